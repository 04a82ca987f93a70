/* Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Variant:    equal_moments: I3 = I1
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_balanced, SHA-256 24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33
 *  Command:    ttc generate --effort full --out DIR spherical_top_balanced.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1    7    4    1    0    2      5    5   (41)
 *  jacobian            1   21    6    1    0    2      8    8   (100)
 *  rhs_jacobian        3   23    6    1    0    2      8    9   (123)
 *  divergence          1    2    4    1    0    1      6    4   (26)
 *  integral_values     0    2    0    0    0    0      2    2   (4)
 *  integral_gradients  0    1    0    0    0    0      1    1   (4)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    digits are lost where terms nearly cancel in gamma3*(I1*M)*C + s*(G*J3/R), v_slip - (M/(m*R))*S,
 *      d(d(psi)/dtau)/d(gamma3), G*J3/R - s*(2*m*R^2*I1)*((1)/Theta)*(gamma3*(I1*M)*C + s*(G*J3/R))
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_balanced[];
extern const jlt_claim jlt_claims_spherical_top_balanced[];
extern const jlt_descriptor *const jlt_family_spherical_top_balanced[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_moments_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_balanced_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_moments_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_moments_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_moments_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[2];
    out[4] = params[4];
    out[5] = params[5];
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    const double t3 = params[2] + t2; /* J1 = I1 + m*R*R */
    const double t4 = t0/t3; /* m*R/J1 */
    out[6] = t4;
    const double t5 = params[5]/t0; /* M/(m*R) */
    out[7] = t5;
    const double t6 = params[2]*params[2]; /* I1*I1 */
    out[8] = t6;
    const double t7 = params[2]*t2; /* I1*m*R*R */
    out[9] = t7;
    const double t8 = t3*params[4]; /* J1*G */
    const double t9 = t8/params[1]; /* J1*G/R */
    out[10] = t9;
    const double t10 = params[2]*params[5]; /* I1*M */
    out[11] = t10;
    const double t11 = params[5]/t3; /* M/J1 */
    out[12] = t11;
    const double t12 = params[0]*2.0; /* m*2 */
    const double t13 = params[1]*t12; /* R*m*2 */
    const double t14 = t13/t3; /* R*m*2/J1 */
    out[13] = t14;
    const double t15 = t1*t12; /* R*R*m*2 */
    const double t16 = params[2]*t15; /* I1*R*R*m*2 */
    out[14] = t16;
    const double t17 = -t10; /* -I1*M */
    out[15] = t17;
    const double t18 = -t4; /* -m*R/J1 */
    out[16] = t18;
    const double t19 = params[5]/t2; /* M/(m*R*R) */
    out[17] = t19;
    const double t20 = params[2]/t2; /* I1/(m*R*R) */
    out[18] = t20;
    const double t21 = params[0]*t6; /* m*I1*I1 */
    out[19] = t21;
    const double t22 = t6*t12; /* I1*I1*m*2 */
    out[20] = t22;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    const double t0 = x[3]*x[3]; /* s*s */
    const double t1 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t2 = JLT_FMA(p[9], t1, p[8]); /* Theta = m*R^2*I1*(gamma3*gamma3 + s*s) + I1^2 */
    const double t3 = x[3]*p[10]; /* s*G*J3/R */
    const double t4 = cos(x[2]); /* C = cos(psi) */
    const double t5 = x[0]*p[11]; /* gamma3*I1*M */
    const double t6 = JLT_FMA(t4, t5, t3); /* C*gamma3*I1*M + s*G*J3/R */
    const double t7 = t6/t2; /* (C*gamma3*I1*M + s*G*J3/R)/Theta */
    out[2] = t7;
    const double t8 = sin(x[2]); /* S = sin(psi) */
    const double t9 = JLT_FNMA(p[7], t8, x[1]); /* v_slip - M/(m*R)*S */
    const double t10 = x[3]*p[6]; /* s*m*R/J1 */
    const double t11 = t9*t10; /* (v_slip - M/(m*R)*S)*s*m*R/J1 */
    const double t12 = x[3]*t11; /* s*(v_slip - M/(m*R)*S)*s*m*R/J1 */
    out[0] = t12;
    const double t13 = x[0]*t11; /* gamma3*(v_slip - M/(m*R)*S)*s*m*R/J1 */
    const double t14 = -t13; /* -gamma3*(v_slip - M/(m*R)*S)*s*m*R/J1 */
    out[3] = t14;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    const double t0 = x[3]*x[3]; /* s*s */
    const double t1 = p[6]*t0; /* m*R/J1*s*s */
    out[1] = t1;
    const double t2 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t3 = JLT_FMA(p[9], t2, p[8]); /* Theta = m*R^2*I1*(gamma3*gamma3 + s*s) + I1^2 */
    const double t4 = 1.0/t3; /* 1/Theta */
    const double t5 = cos(x[2]); /* C = cos(psi) */
    const double t6 = p[11]*t5; /* I1*M*C */
    const double t7 = p[12]*t5; /* M/J1*C */
    const double t8 = t0*t7; /* s*s*M/J1*C */
    const double t9 = -t8; /* -s*s*M/J1*C */
    out[2] = t9;
    const double t10 = x[3]*p[10]; /* s*G*J3/R */
    const double t11 = JLT_FMA(x[0], t6, t10); /* gamma3*I1*M*C + s*G*J3/R */
    const double t12 = t4*t6; /* 1/Theta*I1*M*C */
    const double t13 = sin(x[2]); /* S = sin(psi) */
    const double t14 = p[14]*t4; /* 2*m*R^2*I1*1/Theta */
    const double t15 = t11*t14; /* (gamma3*I1*M*C + s*G*J3/R)*2*m*R^2*I1*1/Theta */
    const double t16 = JLT_FNMA(p[7], t13, x[1]); /* v_slip - M/(m*R)*S */
    const double t17 = x[0]*t4; /* gamma3*1/Theta */
    const double t18 = JLT_FNMA(t15, t17, t12); /* 1/Theta*I1*M*C - (gamma3*I1*M*C + s*G*J3/R)*2*m*R^2*I1*1/Theta*gamma3*1/Theta */
    out[8] = t18;
    const double t19 = p[15]*t17; /* (-I1*M)*gamma3*1/Theta */
    const double t20 = t13*t19; /* S*(-I1*M)*gamma3*1/Theta */
    out[10] = t20;
    const double t21 = JLT_FNMA(x[3], t15, p[10]); /* G*J3/R - s*(gamma3*I1*M*C + s*G*J3/R)*2*m*R^2*I1*1/Theta */
    const double t22 = t4*t21; /* 1/Theta*(G*J3/R - s*(gamma3*I1*M*C + s*G*J3/R)*2*m*R^2*I1*1/Theta) */
    out[11] = t22;
    const double t23 = x[3]*t16; /* s*(v_slip - M/(m*R)*S) */
    const double t24 = p[13]*t23; /* 2*m*R/J1*s*(v_slip - M/(m*R)*S) */
    out[3] = t24;
    const double t25 = p[16]*t23; /* (-m*R/J1)*s*(v_slip - M/(m*R)*S) */
    out[12] = t25;
    const double t26 = x[3]*x[0]; /* s*gamma3 */
    const double t27 = t7*t26; /* M/J1*C*s*gamma3 */
    out[14] = t27;
    const double t28 = p[16]*t26; /* (-m*R/J1)*s*gamma3 */
    out[13] = t28;
    const double t29 = x[0]*p[16]; /* gamma3*(-m*R/J1) */
    const double t30 = t16*t29; /* (v_slip - M/(m*R)*S)*gamma3*(-m*R/J1) */
    out[15] = t30;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[4] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[13] = 0.0;
    const double t0 = x[3]*x[3]; /* s*s */
    const double t1 = p[6]*t0; /* m*R/J1*s*s */
    out[5] = t1;
    const double t2 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t3 = JLT_FMA(p[9], t2, p[8]); /* Theta = m*R^2*I1*(gamma3*gamma3 + s*s) + I1^2 */
    const double t4 = 1.0/t3; /* 1/Theta */
    const double t5 = cos(x[2]); /* C = cos(psi) */
    const double t6 = sin(x[2]); /* S = sin(psi) */
    const double t7 = x[3]*p[10]; /* s*G*J3/R */
    const double t8 = p[11]*t5; /* I1*M*C */
    const double t9 = JLT_FMA(x[0], t8, t7); /* gamma3*I1*M*C + s*G*J3/R */
    const double t10 = t4*t9; /* 1/Theta*(gamma3*I1*M*C + s*G*J3/R) */
    out[2] = t10;
    const double t11 = p[12]*t5; /* M/J1*C */
    const double t12 = p[14]*t10; /* 2*m*R^2*I1*1/Theta*(gamma3*I1*M*C + s*G*J3/R) */
    const double t13 = t0*t11; /* s*s*M/J1*C */
    const double t14 = -t13; /* -s*s*M/J1*C */
    out[6] = t14;
    const double t15 = JLT_FNMA(p[7], t6, x[1]); /* v_slip - M/(m*R)*S */
    const double t16 = x[3]*t15; /* s*(v_slip - M/(m*R)*S) */
    const double t17 = p[13]*t16; /* 2*m*R/J1*s*(v_slip - M/(m*R)*S) */
    out[7] = t17;
    const double t18 = p[6]*t16; /* m*R/J1*s*(v_slip - M/(m*R)*S) */
    const double t19 = x[3]*t18; /* s*m*R/J1*s*(v_slip - M/(m*R)*S) */
    out[0] = t19;
    const double t20 = -t18; /* -m*R/J1*s*(v_slip - M/(m*R)*S) */
    out[16] = t20;
    const double t21 = x[0]*t18; /* gamma3*m*R/J1*s*(v_slip - M/(m*R)*S) */
    const double t22 = -t21; /* -gamma3*m*R/J1*s*(v_slip - M/(m*R)*S) */
    out[3] = t22;
    const double t23 = x[0]*t4; /* gamma3*1/Theta */
    const double t24 = t12*t23; /* 2*m*R^2*I1*1/Theta*(gamma3*I1*M*C + s*G*J3/R)*gamma3*1/Theta */
    const double t25 = JLT_FMS(t4, t8, t24); /* 1/Theta*I1*M*C - 2*m*R^2*I1*1/Theta*(gamma3*I1*M*C + s*G*J3/R)*gamma3*1/Theta */
    out[12] = t25;
    const double t26 = p[15]*t23; /* (-I1*M)*gamma3*1/Theta */
    const double t27 = t6*t26; /* S*(-I1*M)*gamma3*1/Theta */
    out[14] = t27;
    const double t28 = JLT_FNMA(x[3], t12, p[10]); /* G*J3/R - s*2*m*R^2*I1*1/Theta*(gamma3*I1*M*C + s*G*J3/R) */
    const double t29 = t4*t28; /* 1/Theta*(G*J3/R - s*2*m*R^2*I1*1/Theta*(gamma3*I1*M*C + s*G*J3/R)) */
    out[15] = t29;
    const double t30 = x[3]*x[0]; /* s*gamma3 */
    const double t31 = t11*t30; /* M/J1*C*s*gamma3 */
    out[18] = t31;
    const double t32 = p[16]*t30; /* (-m*R/J1)*s*gamma3 */
    out[17] = t32;
    const double t33 = x[0]*p[16]; /* gamma3*(-m*R/J1) */
    const double t34 = t15*t33; /* (v_slip - M/(m*R)*S)*gamma3*(-m*R/J1) */
    out[19] = t34;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = sin(x[2]); /* S = sin(psi) */
    const double t1 = JLT_FNMA(p[7], t0, x[1]); /* v_slip - M/(m*R)*S */
    const double t2 = p[6]*t1; /* m*R/J1*(v_slip - M/(m*R)*S) */
    const double t3 = JLT_FMA(x[3], x[3], p[18]); /* s*s + I1/(m*R^2) */
    const double t4 = JLT_FMA(x[0], x[0], t3); /* Theta/(m*R^2*I1) = gamma3*gamma3 + s*s + I1/(m*R^2) */
    const double t5 = p[17]/t4; /* M/(m*R^2)/(Theta/(m*R^2*I1)) */
    const double t6 = JLT_FMA(t0, t5, t2); /* S*M/(m*R^2)/(Theta/(m*R^2*I1)) + m*R/J1*(v_slip - M/(m*R)*S) */
    const double t7 = x[0]*t6; /* gamma3*(S*M/(m*R^2)/(Theta/(m*R^2*I1)) + m*R/J1*(v_slip - M/(m*R)*S)) */
    const double t8 = -t7; /* -t7 */
    out[0] = t8;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[19]*x[1]; /* m*I1^2*v_slip */
    const double t1 = x[1]*t0; /* v_slip*m*I1^2*v_slip */
    out[0] = t1;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
    const double t0 = p[20]*x[1]; /* 2*m*I1^2*v_slip */
    out[1] = t0;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[3];
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double u15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double u19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = 0;
    for (unsigned k = 0; k < order; k++) {
        t11[k] = jlt_jet_product(x3, x3, k);
        t12[k] = jlt_jet_product(x0, x0, k) + t11[k];
        t13[k] = p[9]*t12[k] + (k == 0 ? p[8] : 0);
        t14[k] = x3[k]*p[10];
        t15[k] = jlt_jet_cosine(x2, t15, u15, k);
        t16[k] = x0[k]*p[11];
        t17[k] = jlt_jet_product(t15, t16, k) + t14[k];
        t18[k] = jlt_jet_quotient(t17[k], t13, t18, k);
        t19[k] = jlt_jet_sine(x2, t19, u19, k);
        t20[k] = x1[k] - p[7]*t19[k];
        t21[k] = x3[k]*p[6];
        t22[k] = jlt_jet_product(t20, t21, k);
        t23[k] = jlt_jet_product(x3, t22, k);
        t24[k] = jlt_jet_product(x0, t22, k);
        t25[k] = -t24[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t23[k]/(k + 1);
        next[1] = x1[k + 1] = (k == 0 ? 0.0 : 0)/(k + 1);
        next[2] = x2[k + 1] = t18[k]/(k + 1);
        next[3] = x3[k + 1] = t25[k]/(k + 1);
        next[4] = x3[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[3];
    const double v_I1 = params[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double complex v_J1 = (v_I1 + v_m*v_R*v_R);
    const double complex v_v_slip = x[1];
    const double v_M = params[5];
    const double complex v_psi = x[2];
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s)*((v_s*v_omega_tau));
    const double v_I3 = (v_I1);
    const double complex v_gamma3 = x[0];
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*(v_I1*v_s*v_s + v_I3*v_gamma3*v_gamma3));
    const double v_G = params[4];
    const double complex v_J3 = (v_I3 + v_m*v_R*v_R);
    const double complex v_C = ccos(v_psi);
    const double complex v_omega_n = ((v_G*v_s*v_J3/v_R + v_I3*v_M*v_gamma3*v_C)/v_Theta);
    const double complex v_omega3 = ((v_I1*v_M*v_s*v_C - v_G*v_gamma3*v_J1/v_R)/v_Theta);
    out[1] = (v_s)*((v_R*v_omega_n*v_omega3)
        + (-v_R*v_I3*v_omega_n*v_omega3/v_I1));
    out[2] = (v_s)*((v_omega_n/v_s));
    out[3] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[3] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[3]*x[3]; /* s*s */
    const double t3 = t1 + t2; /* -1 + gamma3*gamma3 + s*s */
    out[0] = t3;
}

static void root_relation_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = 2.0*x[0]; /* 2*gamma3 */
    out[0] = t0;
    out[1] = 0.0;
    out[2] = 0.0;
    const double t1 = 2.0*x[3]; /* 2*s */
    out[3] = t1;
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_slip", "m/s", "velocity of the contact point along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "psi", "rad", "angle of the horizontal momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 2.0*0x1.921fb54442d18p+1 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (2.0 / 5.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 4.0), 0.0 },
    { "G", "kg*m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-3.0 / 10.0), 0.0 },
    { "M", "kg*m^2/s", "horizontal angular momentum about the contact point", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
};

static const jlt_named integrals[] = {
    { "F0", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_moments_in_regular = {
    .model = "spherical_top_balanced",
    .variant = "equal_moments",
    .time = "regular",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_balanced, .family = jlt_family_spherical_top_balanced, .claims = jlt_claims_spherical_top_balanced,
    .scales = 1,
    .state_count = 4, .param_count = 6, .prepared_count = 21,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 1, 7, 4, 1, 0, 2, 5, 5 }, { 8, 27, 0, 4, 0, 2, 7, 7 },
        "digits are lost where terms nearly cancel in C*gamma3*(I1*M) + s*(G*J3/R), v_slip - (M/(m*R))*S" },
    .jacobian = { jacobian, 16, { 1, 21, 6, 1, 0, 2, 8, 8 }, { 16, 68, 0, 14, 0, 2, 10, 11 },
        "digits are lost where terms nearly cancel in gamma3*(I1*M)*C + s*(G*J3/R), v_slip - (M/(m*R))*S, d(d(psi)/dtau)/d(gamma3), G*J3/R - s*(gamma3*(I1*M)*C + s*(G*J3/R))*(2*m*R^2*I1)*((1)/Theta)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 3, 23, 6, 1, 0, 2, 8, 9 }, { 20, 83, 0, 18, 0, 2, 10, 11 },
        "digits are lost where terms nearly cancel in gamma3*(I1*M)*C + s*(G*J3/R), v_slip - (M/(m*R))*S, d(d(psi)/dtau)/d(gamma3), G*J3/R - s*(2*m*R^2*I1)*((1)/Theta)*(gamma3*(I1*M)*C + s*(G*J3/R))" },
    .divergence = { divergence, 1, { 1, 2, 4, 1, 0, 1, 6, 4 }, { 6, 17, 0, 2, 0, 1, 7, 7 },
        "digits are lost where terms nearly cancel in v_slip - (M/(m*R))*S, S*((M/(m*R^2))/Theta/(m*R^2*I1)) + (m*R/J1)*(v_slip - (M/(m*R))*S)" },
    .integral_values = { integral_values, 1, { 0, 2, 0, 0, 0, 0, 2, 2 }, { 0, 4, 0, 0, 0, 0, 3, 3 },
        "" },
    .integral_gradients = { integral_gradients, 4, { 0, 1, 0, 0, 0, 0, 1, 1 }, { 0, 4, 0, 0, 0, 0, 3, 3 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_balanced_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_equal_moments_in_regular) },
#endif
};
