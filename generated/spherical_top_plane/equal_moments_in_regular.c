/* Balanced sphere with one nonholonomic constraint, on a level of all three integrals
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Variant:    equal_moments: I3 = I1
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_plane, SHA-256 ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6
 *  Command:    ttc generate --effort full --out DIR spherical_top_plane.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1    7    4    1    0    2      5    6   (45)
 *  jacobian            1   20    5    1    0    2      8    9   (95)
 *  rhs_jacobian        3   21    6    1    0    2      8    8   (118)
 *  divergence          1    2    4    1    0    1      6    4   (30)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  domain_values       0    0    0    0    0    0      0    0   (0)
 *  domain_gradients    0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    digits are lost where terms nearly cancel in gamma3*(I1*M)*C + s*(G*J3/R), m*R*v_slip - M*S,
 *      d(d(psi)/dtau)/d(gamma3), G*J3/R - s*(2*m*R^2*I1)*((1)/Theta)*(gamma3*(I1*M)*C + s*(G*J3/R))
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_plane[];
extern const jlt_claim jlt_claims_spherical_top_plane[];
extern const jlt_descriptor *const jlt_family_spherical_top_plane[];
extern const jlt_descriptor jlt_kernels_spherical_top_plane_equal_moments_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_plane_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_equal_moments_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_equal_moments_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_equal_moments_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[2];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[2] + t1; /* J1 = I1 + m*R*R */
    const double t3 = 1.0/t2; /* 1/J1 */
    out[7] = t3;
    const double t4 = params[0]*params[1]; /* m*R */
    const double t5 = params[2]*params[2]; /* I1*I1 */
    out[9] = t5;
    const double t6 = params[0]*t5; /* m*I1*I1 */
    const double t7 = params[6]/t6; /* F0/(m*I1*I1) */
    const double t8 = sqrt(t7); /* v_slip = sqrt(F0/(m*I1*I1)) */
    const double t9 = t4*t8; /* m*R*v_slip */
    out[8] = t9;
    const double t10 = params[2]*t1; /* I1*m*R*R */
    out[10] = t10;
    const double t11 = t2*params[4]; /* J1*G */
    const double t12 = t11/params[1]; /* J1*G/R */
    out[11] = t12;
    const double t13 = params[2]*params[5]; /* I1*M */
    out[12] = t13;
    const double t14 = params[5]/t2; /* M/J1 */
    out[21] = t14;
    const double t15 = -t14; /* -M/J1 */
    out[13] = t15;
    const double t16 = 2.0/t2; /* 2/J1 */
    out[14] = t16;
    const double t17 = t13/2.0; /* I1*M/2 */
    out[15] = t17;
    const double t18 = params[2]/t1; /* I1/(m*R*R) */
    out[16] = t18;
    const double t19 = 2.0/t10; /* 2/(I1*m*R*R) */
    out[17] = t19;
    const double t20 = params[5]/t1; /* M/(m*R*R) */
    out[24] = t20;
    const double t21 = -t20; /* -M/(m*R*R) */
    out[18] = t21;
    const double t22 = params[1]*t0; /* R*R*R */
    const double t23 = params[0]*t22; /* m*R*R*R */
    const double t24 = params[2]*t23; /* I1*m*R*R*R */
    const double t25 = t11/t24; /* J1*G/(I1*m*R*R*R) */
    out[19] = t25;
    const double t26 = (-1.0)/t2; /* (-1)/J1 */
    out[20] = t26;
    const double t27 = params[0]*2.0; /* m*2 */
    const double t28 = t0*t27; /* R*R*m*2 */
    const double t29 = params[2]*t28; /* I1*R*R*m*2 */
    out[22] = t29;
    const double t30 = -t13; /* -I1*M */
    out[23] = t30;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[2]*x[2]; /* s*s */
    const double t1 = sin(x[1]); /* S = sin(psi) */
    const double t2 = JLT_FNMA(p[5], t1, p[8]); /* m*R*v_slip - M*S */
    const double t3 = p[7]*t2; /* 1/J1*(m*R*v_slip - M*S) */
    const double t4 = t0*t3; /* s*s*1/J1*(m*R*v_slip - M*S) */
    out[0] = t4;
    const double t5 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t6 = JLT_FMA(p[10], t5, p[9]); /* Theta = m*R^2*I1*(gamma3*gamma3 + s*s) + I1^2 */
    const double t7 = x[2]*p[11]; /* s*G*J3/R */
    const double t8 = cos(x[1]); /* C = cos(psi) */
    const double t9 = x[0]*p[12]; /* gamma3*I1*M */
    const double t10 = JLT_FMA(t8, t9, t7); /* C*gamma3*I1*M + s*G*J3/R */
    const double t11 = t10/t6; /* (C*gamma3*I1*M + s*G*J3/R)/Theta */
    out[1] = t11;
    const double t12 = x[2]*x[0]; /* s*gamma3 */
    const double t13 = t3*t12; /* 1/J1*(m*R*v_slip - M*S)*s*gamma3 */
    const double t14 = -t13; /* -1/J1*(m*R*v_slip - M*S)*s*gamma3 */
    out[2] = t14;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    const double t0 = x[2]*x[2]; /* s*s */
    const double t1 = p[16] + t0; /* I1/(m*R^2) + s*s */
    const double t2 = JLT_FMA(x[0], x[0], t1); /* Theta/(m*R^2*I1) = gamma3*gamma3 + I1/(m*R^2) + s*s */
    const double t3 = 1.0/t2; /* 1/(Theta/(m*R^2*I1)) */
    const double t4 = p[13]*t0; /* (-M/J1)*s*s */
    const double t5 = cos(x[1]); /* C = cos(psi) */
    const double t6 = t4*t5; /* (-M/J1)*s*s*C */
    out[1] = t6;
    const double t7 = sin(x[1]); /* S = sin(psi) */
    const double t8 = x[2]*p[11]; /* s*G*J3/R */
    const double t9 = x[0]*t5; /* gamma3*C */
    const double t10 = p[15]*t5; /* 1/2*I1*M*C */
    const double t11 = JLT_FMA(p[12], t9, t8); /* I1*M*gamma3*C + s*G*J3/R */
    const double t12 = p[17]*t3; /* 2/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t13 = JLT_FNMA(p[5], t7, p[8]); /* m*R*v_slip - M*S */
    const double t14 = x[0]*t3; /* gamma3*1/(Theta/(m*R^2*I1)) */
    const double t15 = JLT_FNMA(t11, t14, t10); /* 1/2*I1*M*C - (I1*M*gamma3*C + s*G*J3/R)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t16 = t12*t15; /* 2/(m*R^2*I1)*1/(Theta/(m*R^2*I1))*t15 */
    out[3] = t16;
    const double t17 = x[2]*t12; /* s*2/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t18 = JLT_FNMA(t11, t17, p[19]); /* G*J3/(m*R^3*I1) - (I1*M*gamma3*C + s*G*J3/R)*s*2/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t19 = t3*t18; /* 1/(Theta/(m*R^2*I1))*t18 */
    out[5] = t19;
    const double t20 = p[18]*t14; /* (-M/(m*R^2))*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t21 = t7*t20; /* S*(-M/(m*R^2))*gamma3*1/(Theta/(m*R^2*I1)) */
    out[4] = t21;
    const double t22 = x[2]*t13; /* s*(m*R*v_slip - M*S) */
    const double t23 = p[14]*t22; /* 2/J1*s*(m*R*v_slip - M*S) */
    out[2] = t23;
    const double t24 = p[20]*t22; /* (-1/J1)*s*(m*R*v_slip - M*S) */
    out[6] = t24;
    const double t25 = x[2]*p[21]; /* s*M/J1 */
    const double t26 = t9*t25; /* gamma3*C*s*M/J1 */
    out[7] = t26;
    const double t27 = x[0]*p[20]; /* gamma3*(-1/J1) */
    const double t28 = t13*t27; /* (m*R*v_slip - M*S)*gamma3*(-1/J1) */
    out[8] = t28;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[3] = 0.0;
    const double t0 = x[2]*x[2]; /* s*s */
    const double t1 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t2 = JLT_FMA(p[10], t1, p[9]); /* Theta = m*R^2*I1*(gamma3*gamma3 + s*s) + I1^2 */
    const double t3 = 1.0/t2; /* 1/Theta */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = sin(x[1]); /* S = sin(psi) */
    const double t6 = x[2]*p[11]; /* s*G*J3/R */
    const double t7 = p[12]*t4; /* I1*M*C */
    const double t8 = JLT_FMA(x[0], t7, t6); /* gamma3*I1*M*C + s*G*J3/R */
    const double t9 = t3*t8; /* 1/Theta*(gamma3*I1*M*C + s*G*J3/R) */
    out[1] = t9;
    const double t10 = p[22]*t9; /* 2*m*R^2*I1*1/Theta*(gamma3*I1*M*C + s*G*J3/R) */
    const double t11 = t3*t7; /* 1/Theta*I1*M*C */
    const double t12 = JLT_FNMA(p[5], t5, p[8]); /* m*R*v_slip - M*S */
    const double t13 = x[2]*t12; /* s*(m*R*v_slip - M*S) */
    const double t14 = p[14]*t13; /* 2/J1*s*(m*R*v_slip - M*S) */
    out[5] = t14;
    const double t15 = p[7]*t13; /* 1/J1*s*(m*R*v_slip - M*S) */
    const double t16 = x[2]*t15; /* s*1/J1*s*(m*R*v_slip - M*S) */
    out[0] = t16;
    const double t17 = -t15; /* -1/J1*s*(m*R*v_slip - M*S) */
    out[9] = t17;
    const double t18 = x[0]*t15; /* gamma3*1/J1*s*(m*R*v_slip - M*S) */
    const double t19 = -t18; /* -gamma3*1/J1*s*(m*R*v_slip - M*S) */
    out[2] = t19;
    const double t20 = x[2]*p[21]; /* s*M/J1 */
    const double t21 = t4*t20; /* C*s*M/J1 */
    const double t22 = x[0]*t21; /* gamma3*C*s*M/J1 */
    out[10] = t22;
    const double t23 = x[2]*t21; /* s*C*s*M/J1 */
    const double t24 = -t23; /* -s*C*s*M/J1 */
    out[4] = t24;
    const double t25 = x[0]*t3; /* gamma3*1/Theta */
    const double t26 = JLT_FNMA(t10, t25, t11); /* 1/Theta*I1*M*C - 2*m*R^2*I1*1/Theta*(gamma3*I1*M*C + s*G*J3/R)*gamma3*1/Theta */
    out[6] = t26;
    const double t27 = p[23]*t25; /* (-I1*M)*gamma3*1/Theta */
    const double t28 = t5*t27; /* S*(-I1*M)*gamma3*1/Theta */
    out[7] = t28;
    const double t29 = JLT_FNMA(x[2], t10, p[11]); /* G*J3/R - s*2*m*R^2*I1*1/Theta*(gamma3*I1*M*C + s*G*J3/R) */
    const double t30 = t3*t29; /* 1/Theta*(G*J3/R - s*2*m*R^2*I1*1/Theta*(gamma3*I1*M*C + s*G*J3/R)) */
    out[8] = t30;
    const double t31 = x[0]*p[20]; /* gamma3*(-1/J1) */
    const double t32 = t12*t31; /* (m*R*v_slip - M*S)*gamma3*(-1/J1) */
    out[11] = t32;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = sin(x[1]); /* S = sin(psi) */
    const double t1 = JLT_FNMA(p[5], t0, p[8]); /* m*R*v_slip - M*S */
    const double t2 = p[7]*t1; /* 1/J1*(m*R*v_slip - M*S) */
    const double t3 = JLT_FMA(x[2], x[2], p[16]); /* s*s + I1/(m*R^2) */
    const double t4 = JLT_FMA(x[0], x[0], t3); /* Theta/(m*R^2*I1) = gamma3*gamma3 + s*s + I1/(m*R^2) */
    const double t5 = p[24]/t4; /* M/(m*R^2)/(Theta/(m*R^2*I1)) */
    const double t6 = JLT_FMA(t0, t5, t2); /* S*M/(m*R^2)/(Theta/(m*R^2*I1)) + 1/J1*(m*R*v_slip - M*S) */
    const double t7 = x[0]*t6; /* gamma3*(S*M/(m*R^2)/(Theta/(m*R^2*I1)) + 1/J1*(m*R*v_slip - M*S)) */
    const double t8 = -t7; /* -t7 */
    out[0] = t8;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[2];
}

static void domain_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    out[0] = p[6];
}

static void domain_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double u14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double u18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = 0;
    for (unsigned k = 0; k < order; k++) {
        t10[k] = jlt_jet_product(x2, x2, k);
        t11[k] = jlt_jet_product(x0, x0, k) + t10[k];
        t12[k] = p[10]*t11[k] + (k == 0 ? p[9] : 0);
        t13[k] = x2[k]*p[11];
        t14[k] = jlt_jet_cosine(x1, t14, u14, k);
        t15[k] = x0[k]*p[12];
        t16[k] = jlt_jet_product(t14, t15, k) + t13[k];
        t17[k] = jlt_jet_quotient(t16[k], t12, t17, k);
        t18[k] = jlt_jet_sine(x1, t18, u18, k);
        t19[k] = (k == 0 ? p[8] : 0) - p[5]*t18[k];
        t20[k] = x2[k]*p[7];
        t21[k] = jlt_jet_product(t19, t20, k);
        t22[k] = jlt_jet_product(x2, t21, k);
        t23[k] = jlt_jet_product(x0, t21, k);
        t24[k] = -t23[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t22[k]/(k + 1);
        next[1] = x1[k + 1] = t17[k]/(k + 1);
        next[2] = x2[k + 1] = t24[k]/(k + 1);
        next[3] = x2[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[2];
    const double v_I1 = params[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double complex v_J1 = (v_I1 + v_m*v_R*v_R);
    const double v_F0 = params[6];
    const double v_I3 = (v_I1);
    const double complex v_gamma3 = x[0];
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*(v_I1*v_s*v_s + v_I3*v_gamma3*v_gamma3));
    const double v_M = params[5];
    const double complex v_psi = x[1];
    const double complex v_C = ccos(v_psi);
    const double v_G = params[4];
    const double complex v_omega3 = ((v_I1*v_M*v_s*v_C - v_G*v_gamma3*v_J1/v_R)/v_Theta);
    const double complex v_v_slip = csqrt((v_F0 - v_Theta*v_omega3*v_omega3*(v_I1 - v_I3))/(v_m*v_I1*v_I1));
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s)*((v_s*v_omega_tau));
    const double complex v_J3 = (v_I3 + v_m*v_R*v_R);
    const double complex v_omega_n = ((v_G*v_s*v_J3/v_R + v_I3*v_M*v_gamma3*v_C)/v_Theta);
    out[1] = (v_s)*((v_omega_n/v_s));
    out[2] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[2]*x[2]; /* s*s */
    const double t3 = t1 + t2; /* -1 + gamma3*gamma3 + s*s */
    out[0] = t3;
}

static void root_relation_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = 2.0*x[0]; /* 2*gamma3 */
    out[0] = t0;
    out[1] = 0.0;
    const double t1 = 2.0*x[2]; /* 2*s */
    out[2] = t1;
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
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
    { "F0", "kg^3*m^6/s^2", "value of the third integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (1.0 / 2.0), 0.0 },
};

static const jlt_region domains[] = {
    { "motion", "F0 - (I1 - I3)*Theta*omega3^2 > 0", 1 },
};

const jlt_descriptor jlt_kernels_spherical_top_plane_equal_moments_in_regular = {
    .model = "spherical_top_plane",
    .variant = "equal_moments",
    .time = "regular",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on a level of all three integrals",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_plane, .family = jlt_family_spherical_top_plane, .claims = jlt_claims_spherical_top_plane,
    .scales = 1,
    .state_count = 3, .param_count = 7, .prepared_count = 25,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 3, { 1, 7, 4, 1, 0, 2, 5, 6 }, { 8, 29, 0, 5, 1, 2, 9, 8 },
        "digits are lost where terms nearly cancel in m*R*v_slip - M*S, C*gamma3*(I1*M) + s*(G*J3/R)" },
    .jacobian = { jacobian, 9, { 1, 20, 5, 1, 0, 2, 8, 9 }, { 15, 64, 0, 13, 1, 2, 10, 12 },
        "digits are lost where terms nearly cancel in (I1*M)*gamma3*C + s*(G*J3/R), m*R*v_slip - M*S, a part of d(d(psi)/dtau)/d(gamma3), a part of d(d(psi)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 12, { 3, 21, 6, 1, 0, 2, 8, 8 }, { 19, 79, 0, 17, 1, 2, 10, 12 },
        "digits are lost where terms nearly cancel in gamma3*(I1*M)*C + s*(G*J3/R), m*R*v_slip - M*S, d(d(psi)/dtau)/d(gamma3), G*J3/R - s*(2*m*R^2*I1)*((1)/Theta)*(gamma3*(I1*M)*C + s*(G*J3/R))" },
    .divergence = { divergence, 1, { 1, 2, 4, 1, 0, 1, 6, 4 }, { 6, 19, 0, 3, 1, 1, 10, 7 },
        "digits are lost where terms nearly cancel in m*R*v_slip - M*S, S*((M/(m*R^2))/Theta/(m*R^2*I1)) + (1/J1)*(m*R*v_slip - M*S)" },
    .integral_values = { .loses_digits = "" },
    .integral_gradients = { .loses_digits = "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { domain_values, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .domain_gradients = { domain_gradients, 3, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .domain_count = 1, .domains = domains,
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 0, .measure_count = 0, .equilibria_count = 0,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_plane_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_plane_equal_moments_in_regular) },
#endif
};
