/* Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Variant:    equal_moments: I3 = I1
 *  Table:      spherical_top_balanced, SHA-256 24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33
 *  Command:    ttc generate --effort full --out DIR spherical_top_balanced.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2    6    2    1    1    2      6    5   (36)
 *  jacobian            2   15    4    1    1    2      9    6   (64)
 *  rhs_jacobian        2   17    4    1    1    2      9    7   (79)
 *  divergence          2    7    0    1    1    0      7    4   (31)
 *  integral_values     0    2    0    0    0    0      2    2   (4)
 *  integral_gradients  0    1    0    0    0    0      1    1   (4)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in gamma3*(I1*M)*C + (G*J3/R)*s,
 *      G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s,
 *      (I1*M)*C - (G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s)*gamma3*1/s, v_slip - (M/(m*R))*S
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_moments;
extern const struct jlt_ball_table jlt_balls_spherical_top_balanced_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_moments_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_moments_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_moments_avx512;

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
    const double t6 = t3*params[4]; /* J1*G */
    const double t7 = t6/params[1]; /* J1*G/R */
    out[8] = t7;
    const double t8 = params[2]*params[5]; /* I1*M */
    out[9] = t8;
    const double t9 = params[2]*t2; /* I1*m*R*R */
    const double t10 = params[2]*params[2]; /* I1*I1 */
    const double t11 = t9 + t10; /* I1*m*R*R + I1*I1 */
    out[10] = t11;
    const double t12 = -t4; /* -m*R/J1 */
    out[11] = t12;
    const double t13 = params[5]/t3; /* M/J1 */
    const double t14 = -t13; /* -M/J1 */
    out[12] = t14;
    const double t15 = -t8; /* -I1*M */
    out[13] = t15;
    const double t16 = params[2]*t3; /* I1*J1 */
    const double t17 = params[1]*t3; /* R*J1 */
    const double t18 = t10/t2; /* I1*I1/(m*R*R) */
    const double t19 = params[2] + t18; /* I1 + I1*I1/(m*R*R) */
    out[15] = t19;
    const double t20 = t16*t19; /* I1*J1*(I1 + I1*I1/(m*R*R)) */
    const double t21 = t20/t17; /* I1*J1*(I1 + I1*I1/(m*R*R))/(R*J1) */
    const double t22 = -t21; /* -I1*J1*(I1 + I1*I1/(m*R*R))/(R*J1) */
    out[14] = t22;
    const double t23 = params[0]*t10; /* m*I1*I1 */
    out[16] = t23;
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t10*t24; /* I1*I1*m*2 */
    out[17] = t25;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = sin(x[2]); /* S = sin(psi) */
    const double t5 = JLT_FNMA(p[7], t4, x[1]); /* v_slip - M/(m*R)*S */
    const double t6 = p[6]*t3; /* m*R/J1*s */
    const double t7 = t5*t6; /* (v_slip - M/(m*R)*S)*m*R/J1*s */
    out[0] = t7;
    out[1] = 0.0;
    const double t8 = t3*p[8]; /* s*G*J3/R */
    const double t9 = cos(x[2]); /* C = cos(psi) */
    const double t10 = x[0]*p[9]; /* gamma3*I1*M */
    const double t11 = JLT_FMA(t9, t10, t8); /* C*gamma3*I1*M + s*G*J3/R */
    const double t12 = t3*p[10]; /* s*(m*R^2*I1 + I1^2) */
    const double t13 = t11/t12; /* (C*gamma3*I1*M + s*G*J3/R)/(s*(m*R^2*I1 + I1^2)) */
    out[2] = t13;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[7] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = p[6]*t3; /* m*R/J1*s */
    out[1] = t4;
    const double t5 = p[10]*t3; /* (m*R^2*I1 + I1^2)*s */
    const double t6 = 1.0/t5; /* 1/((m*R^2*I1 + I1^2)*s) */
    const double t7 = cos(x[2]); /* C = cos(psi) */
    const double t8 = p[9]*t7; /* I1*M*C */
    const double t9 = p[8]*t3; /* G*J3/R*s */
    const double t10 = JLT_FMA(x[0], t8, t9); /* gamma3*I1*M*C + G*J3/R*s */
    const double t11 = p[12]*t3; /* (-M/J1)*s */
    const double t12 = t7*t11; /* C*(-M/J1)*s */
    out[2] = t12;
    const double t13 = p[10]*t6; /* 1/s = (m*R^2*I1 + I1^2)*1/((m*R^2*I1 + I1^2)*s) */
    const double t14 = JLT_FNMA(t10, t13, p[8]); /* G*J3/R - (gamma3*I1*M*C + G*J3/R*s)*1/s */
    const double t15 = x[0]*t13; /* gamma3*1/s */
    const double t16 = JLT_FNMA(t14, t15, t8); /* I1*M*C - (G*J3/R - (gamma3*I1*M*C + G*J3/R*s)*1/s)*gamma3*1/s */
    const double t17 = t6*t16; /* 1/((m*R^2*I1 + I1^2)*s)*t16 */
    out[6] = t17;
    const double t18 = p[11]*t15; /* (-m*R/J1)*gamma3*1/s */
    const double t19 = sin(x[2]); /* S = sin(psi) */
    const double t20 = x[0]*p[13]; /* gamma3*(-I1*M) */
    const double t21 = t6*t20; /* 1/((m*R^2*I1 + I1^2)*s)*gamma3*(-I1*M) */
    const double t22 = t19*t21; /* S*1/((m*R^2*I1 + I1^2)*s)*gamma3*(-I1*M) */
    out[8] = t22;
    const double t23 = JLT_FNMA(p[7], t19, x[1]); /* v_slip - M/(m*R)*S */
    const double t24 = t18*t23; /* (-m*R/J1)*gamma3*1/s*(v_slip - M/(m*R)*S) */
    out[0] = t24;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[10] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = p[10]*t3; /* (m*R^2*I1 + I1^2)*s */
    const double t5 = 1.0/t4; /* 1/((m*R^2*I1 + I1^2)*s) */
    const double t6 = cos(x[2]); /* C = cos(psi) */
    const double t7 = p[8]*t3; /* G*J3/R*s */
    const double t8 = p[9]*t6; /* I1*M*C */
    const double t9 = JLT_FMA(x[0], t8, t7); /* gamma3*I1*M*C + G*J3/R*s */
    const double t10 = t5*t9; /* 1/((m*R^2*I1 + I1^2)*s)*(gamma3*I1*M*C + G*J3/R*s) */
    out[2] = t10;
    const double t11 = p[10]*t5; /* 1/s = (m*R^2*I1 + I1^2)*1/((m*R^2*I1 + I1^2)*s) */
    const double t12 = JLT_FNMA(t9, t11, p[8]); /* G*J3/R - (gamma3*I1*M*C + G*J3/R*s)*1/s */
    const double t13 = x[0]*t11; /* gamma3*1/s */
    const double t14 = JLT_FNMA(t12, t13, t8); /* I1*M*C - (G*J3/R - (gamma3*I1*M*C + G*J3/R*s)*1/s)*gamma3*1/s */
    const double t15 = t5*t14; /* 1/((m*R^2*I1 + I1^2)*s)*t14 */
    out[9] = t15;
    const double t16 = p[11]*t13; /* (-m*R/J1)*gamma3*1/s */
    const double t17 = sin(x[2]); /* S = sin(psi) */
    const double t18 = x[0]*p[13]; /* gamma3*(-I1*M) */
    const double t19 = t5*t18; /* 1/((m*R^2*I1 + I1^2)*s)*gamma3*(-I1*M) */
    const double t20 = t17*t19; /* S*1/((m*R^2*I1 + I1^2)*s)*gamma3*(-I1*M) */
    out[11] = t20;
    const double t21 = JLT_FNMA(p[7], t17, x[1]); /* v_slip - M/(m*R)*S */
    const double t22 = t16*t21; /* (-m*R/J1)*gamma3*1/s*(v_slip - M/(m*R)*S) */
    out[3] = t22;
    const double t23 = p[6]*t3; /* m*R/J1*s */
    out[4] = t23;
    const double t24 = t21*t23; /* (v_slip - M/(m*R)*S)*m*R/J1*s */
    out[0] = t24;
    const double t25 = p[12]*t3; /* (-M/J1)*s */
    const double t26 = t6*t25; /* C*(-M/J1)*s */
    out[5] = t26;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = t3*p[15]; /* s*(I1 + I1^2/(m*R^2)) */
    const double t5 = 1.0/t4; /* 1/(s*(I1 + I1^2/(m*R^2))) */
    const double t6 = p[14]*x[0]; /* (-I1*(I1 + m*R^2)*(I1 + I1^2/(m*R^2))/(R*J1))*gamma3 */
    const double t7 = x[1]*t6; /* v_slip*(-I1*(I1 + m*R^2)*(I1 + I1^2/(m*R^2))/(R*J1))*gamma3 */
    const double t8 = t3*t7; /* s*v_slip*(-I1*(I1 + m*R^2)*(I1 + I1^2/(m*R^2))/(R*J1))*gamma3 */
    const double t9 = t5*t8; /* 1/(s*(I1 + I1^2/(m*R^2)))*t8 */
    const double t10 = t5*t9; /* 1/(s*(I1 + I1^2/(m*R^2)))*1/(s*(I1 + I1^2/(m*R^2)))*t8 */
    out[0] = t10;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[16]*x[1]; /* m*I1^2*v_slip */
    const double t1 = x[1]*t0; /* v_slip*m*I1^2*v_slip */
    out[0] = t1;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[2] = 0.0;
    const double t0 = p[17]*x[1]; /* 2*m*I1^2*v_slip */
    out[1] = t0;
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
    const double t14 = 1.0/p[10];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double u16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double u21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    for (unsigned k = 0; k < order; k++) {
        t10[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t11[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t12[k] = jlt_jet_product(t10, t11, k);
        t13[k] = jlt_jet_root(t12[k], t13, k);
        t15[k] = jlt_jet_quotient((k == 0 ? t14 : 0), t13, t15, k);
        t16[k] = jlt_jet_sine(x2, t16, u16, k);
        t17[k] = x1[k] - p[7]*t16[k];
        t18[k] = p[8]*t13[k];
        t19[k] = p[6]*t13[k];
        t20[k] = jlt_jet_product(t17, t19, k);
        t21[k] = jlt_jet_cosine(x2, t21, u21, k);
        t22[k] = x0[k]*p[9];
        t23[k] = jlt_jet_product(t21, t22, k) + t18[k];
        t24[k] = jlt_jet_product(t15, t23, k);
        double *restrict next = coefficients + (k + 1)*3;
        next[0] = x0[k + 1] = t20[k]/(k + 1);
        next[1] = x1[k + 1] = (k == 0 ? 0.0 : 0)/(k + 1);
        next[2] = x2[k + 1] = t24[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    const double v_I1 = params[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double complex v_J1 = (v_I1 + v_m*v_R*v_R);
    const double complex v_v_slip = x[1];
    const double v_M = params[5];
    const double complex v_psi = x[2];
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s*v_omega_tau);
    const double v_I3 = (v_I1);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*(v_I1*v_s*v_s + v_I3*v_gamma3*v_gamma3));
    const double v_G = params[4];
    const double complex v_J3 = (v_I3 + v_m*v_R*v_R);
    const double complex v_C = ccos(v_psi);
    const double complex v_omega_n = ((v_G*v_s*v_J3/v_R + v_I3*v_M*v_gamma3*v_C)/v_Theta);
    const double complex v_omega3 = ((v_I1*v_M*v_s*v_C - v_G*v_gamma3*v_J1/v_R)/v_Theta);
    out[1] = (v_R*v_omega_n*v_omega3)
        + (-v_R*v_I3*v_omega_n*v_omega3/v_I1);
    out[2] = (v_omega_n/v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_slip", "m/s", "velocity of the contact point along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "psi", "rad", "angle of the horizontal momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 2.0*0x1.921fb54442d18p+1 },
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

static const signed char signs_4[] = { 1, -1, -1 };
static const jlt_reversor reversors[] = {
    { signs_4, 4 },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_moments = {
    .model = "spherical_top_balanced",
    .variant = "equal_moments",
    .time = "",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_balanced, .family = jlt_family_spherical_top_balanced, .claims = jlt_claims_spherical_top_balanced,
    .scales = 1,
    .state_count = 3, .param_count = 6, .prepared_count = 18,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 3, { 2, 6, 2, 1, 1, 2, 6, 5 }, { 7, 23, 0, 3, 1, 2, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_slip - (M/(m*R))*S, C*gamma3*(I1*M) + s*(G*J3/R)" },
    .jacobian = { jacobian, 9, { 2, 15, 4, 1, 1, 2, 9, 6 }, { 12, 41, 0, 8, 1, 2, 11, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*(I1*M)*C + (G*J3/R)*s, G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s, (I1*M)*C - (G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s)*gamma3*1/s, v_slip - (M/(m*R))*S" },
    .rhs_jacobian = { rhs_jacobian, 12, { 2, 17, 4, 1, 1, 2, 9, 7 }, { 14, 51, 0, 11, 1, 2, 11, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*(I1*M)*C + (G*J3/R)*s, G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s, (I1*M)*C - (G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s)*gamma3*1/s, v_slip - (M/(m*R))*S" },
    .divergence = { divergence, 1, { 2, 7, 0, 1, 1, 0, 7, 4 }, { 7, 20, 0, 2, 1, 1, 11, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_values = { integral_values, 1, { 0, 2, 0, 0, 0, 0, 2, 2 }, { 0, 4, 0, 0, 0, 0, 3, 3 },
        "" },
    .integral_gradients = { integral_gradients, 3, { 0, 1, 0, 0, 0, 0, 1, 1 }, { 0, 4, 0, 0, 0, 0, 3, 3 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_balanced_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_equal_moments) },
#endif
};
