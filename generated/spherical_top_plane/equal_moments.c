/* Balanced sphere with one nonholonomic constraint, on a level of all three integrals
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Variant:    equal_moments: I3 = I1
 *  Table:      spherical_top_plane, SHA-256 ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6
 *  Command:    ttc generate --effort full --out DIR spherical_top_plane.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2    6    2    1    1    2      6    5   (40)
 *  jacobian            2   14    4    1    1    2      9    6   (65)
 *  rhs_jacobian        3   16    4    1    1    2      9    8   (80)
 *  divergence          2    6    0    1    1    0      7    4   (35)
 *  domain_values       0    0    0    0    0    0      0    0   (0)
 *  domain_gradients    0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in gamma3*(I1*M)*C + (G*J3/R)*s, m*R*v_slip - M*S,
 *      G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s, (I1*M)*C - (G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s)*gamma3*1/s
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
extern const jlt_descriptor jlt_kernels_spherical_top_plane_equal_moments;
extern const struct jlt_ball_table jlt_balls_spherical_top_plane_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_equal_moments_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_equal_moments_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_equal_moments_avx512;

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
    const double t6 = params[0]*t5; /* m*I1*I1 */
    const double t7 = params[6]/t6; /* F0/(m*I1*I1) */
    const double t8 = sqrt(t7); /* v_slip = sqrt(F0/(m*I1*I1)) */
    const double t9 = t4*t8; /* m*R*v_slip */
    out[8] = t9;
    const double t10 = t2*params[4]; /* J1*G */
    const double t11 = t10/params[1]; /* J1*G/R */
    out[9] = t11;
    const double t12 = params[2]*params[5]; /* I1*M */
    out[10] = t12;
    const double t13 = params[2]*t1; /* I1*m*R*R */
    const double t14 = t5 + t13; /* I1*I1 + I1*m*R*R */
    out[11] = t14;
    const double t15 = (-1.0)/t2; /* (-1)/J1 */
    out[12] = t15;
    const double t16 = params[5]/t2; /* M/J1 */
    const double t17 = -t16; /* -M/J1 */
    out[13] = t17;
    const double t18 = -t12; /* -I1*M */
    out[14] = t18;
    const double t19 = params[2]*t2; /* I1*J1 */
    const double t20 = params[1]*t2; /* R*J1 */
    const double t21 = t8*t19; /* v_slip*I1*J1 */
    const double t22 = t5/t1; /* I1*I1/(m*R*R) */
    const double t23 = params[2] + t22; /* I1 + I1*I1/(m*R*R) */
    out[16] = t23;
    const double t24 = t21*t23; /* v_slip*I1*J1*(I1 + I1*I1/(m*R*R)) */
    const double t25 = t24/t20; /* v_slip*I1*J1*(I1 + I1*I1/(m*R*R))/(R*J1) */
    const double t26 = -t25; /* -v_slip*I1*J1*(I1 + I1*I1/(m*R*R))/(R*J1) */
    out[15] = t26;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = sin(x[1]); /* S = sin(psi) */
    const double t5 = JLT_FNMA(p[5], t4, p[8]); /* m*R*v_slip - M*S */
    const double t6 = p[7]*t3; /* 1/J1*s */
    const double t7 = t5*t6; /* (m*R*v_slip - M*S)*1/J1*s */
    out[0] = t7;
    const double t8 = t3*p[9]; /* s*G*J3/R */
    const double t9 = cos(x[1]); /* C = cos(psi) */
    const double t10 = x[0]*p[10]; /* gamma3*I1*M */
    const double t11 = JLT_FMA(t9, t10, t8); /* C*gamma3*I1*M + s*G*J3/R */
    const double t12 = t3*p[11]; /* s*(m*R^2*I1 + I1^2) */
    const double t13 = t11/t12; /* (C*gamma3*I1*M + s*G*J3/R)/(s*(m*R^2*I1 + I1^2)) */
    out[1] = t13;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = p[11]*t3; /* (m*R^2*I1 + I1^2)*s */
    const double t5 = 1.0/t4; /* 1/((m*R^2*I1 + I1^2)*s) */
    const double t6 = cos(x[1]); /* C = cos(psi) */
    const double t7 = p[10]*t6; /* I1*M*C */
    const double t8 = p[9]*t3; /* G*J3/R*s */
    const double t9 = JLT_FMA(x[0], t7, t8); /* gamma3*I1*M*C + G*J3/R*s */
    const double t10 = p[13]*t3; /* (-M/J1)*s */
    const double t11 = t6*t10; /* C*(-M/J1)*s */
    out[1] = t11;
    const double t12 = p[11]*t5; /* 1/s = (m*R^2*I1 + I1^2)*1/((m*R^2*I1 + I1^2)*s) */
    const double t13 = JLT_FNMA(t9, t12, p[9]); /* G*J3/R - (gamma3*I1*M*C + G*J3/R*s)*1/s */
    const double t14 = x[0]*t12; /* gamma3*1/s */
    const double t15 = JLT_FNMA(t13, t14, t7); /* I1*M*C - (G*J3/R - (gamma3*I1*M*C + G*J3/R*s)*1/s)*gamma3*1/s */
    const double t16 = t5*t15; /* 1/((m*R^2*I1 + I1^2)*s)*t15 */
    out[2] = t16;
    const double t17 = p[12]*t14; /* (-1/J1)*gamma3*1/s */
    const double t18 = sin(x[1]); /* S = sin(psi) */
    const double t19 = x[0]*p[14]; /* gamma3*(-I1*M) */
    const double t20 = t5*t19; /* 1/((m*R^2*I1 + I1^2)*s)*gamma3*(-I1*M) */
    const double t21 = t18*t20; /* S*1/((m*R^2*I1 + I1^2)*s)*gamma3*(-I1*M) */
    out[3] = t21;
    const double t22 = JLT_FNMA(p[5], t18, p[8]); /* m*R*v_slip - M*S */
    const double t23 = t17*t22; /* (-1/J1)*gamma3*1/s*(m*R*v_slip - M*S) */
    out[0] = t23;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = p[11]*t3; /* (m*R^2*I1 + I1^2)*s */
    const double t5 = 1.0/t4; /* 1/((m*R^2*I1 + I1^2)*s) */
    const double t6 = cos(x[1]); /* C = cos(psi) */
    const double t7 = sin(x[1]); /* S = sin(psi) */
    const double t8 = p[9]*t3; /* G*J3/R*s */
    const double t9 = p[10]*t6; /* I1*M*C */
    const double t10 = JLT_FMA(x[0], t9, t8); /* gamma3*I1*M*C + G*J3/R*s */
    const double t11 = t5*t10; /* 1/((m*R^2*I1 + I1^2)*s)*(gamma3*I1*M*C + G*J3/R*s) */
    out[1] = t11;
    const double t12 = JLT_FNMA(p[5], t7, p[8]); /* m*R*v_slip - M*S */
    const double t13 = p[7]*t12; /* 1/J1*(m*R*v_slip - M*S) */
    const double t14 = t3*t13; /* s*1/J1*(m*R*v_slip - M*S) */
    out[0] = t14;
    const double t15 = p[13]*t3; /* (-M/J1)*s */
    const double t16 = t6*t15; /* C*(-M/J1)*s */
    out[3] = t16;
    const double t17 = p[11]*t5; /* 1/s = (m*R^2*I1 + I1^2)*1/((m*R^2*I1 + I1^2)*s) */
    const double t18 = JLT_FNMA(t10, t17, p[9]); /* G*J3/R - (gamma3*I1*M*C + G*J3/R*s)*1/s */
    const double t19 = x[0]*t17; /* gamma3*1/s */
    const double t20 = JLT_FNMA(t18, t19, t9); /* I1*M*C - (G*J3/R - (gamma3*I1*M*C + G*J3/R*s)*1/s)*gamma3*1/s */
    const double t21 = t13*t19; /* 1/J1*(m*R*v_slip - M*S)*gamma3*1/s */
    const double t22 = -t21; /* -1/J1*(m*R*v_slip - M*S)*gamma3*1/s */
    out[2] = t22;
    const double t23 = t5*t20; /* 1/((m*R^2*I1 + I1^2)*s)*t20 */
    out[4] = t23;
    const double t24 = x[0]*p[14]; /* gamma3*(-I1*M) */
    const double t25 = t5*t24; /* 1/((m*R^2*I1 + I1^2)*s)*gamma3*(-I1*M) */
    const double t26 = t7*t25; /* S*1/((m*R^2*I1 + I1^2)*s)*gamma3*(-I1*M) */
    out[5] = t26;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = t3*p[16]; /* s*(I1 + I1^2/(m*R^2)) */
    const double t5 = 1.0/t4; /* 1/(s*(I1 + I1^2/(m*R^2))) */
    const double t6 = p[15]*x[0]; /* (-I1*(I1 + m*R^2)*v_slip*(I1 + I1^2/(m*R^2))/(R*J1))*gamma3 */
    const double t7 = t3*t6; /* s*(-I1*(I1 + m*R^2)*v_slip*(I1 + I1^2/(m*R^2))/(R*J1))*gamma3 */
    const double t8 = t5*t7; /* 1/(s*(I1 + I1^2/(m*R^2)))*t7 */
    const double t9 = t5*t8; /* 1/(s*(I1 + I1^2/(m*R^2)))*1/(s*(I1 + I1^2/(m*R^2)))*t7 */
    out[0] = t9;
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
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    const double t13 = 1.0/p[11];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double u15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double u20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    for (unsigned k = 0; k < order; k++) {
        t9[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t10[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t11[k] = jlt_jet_product(t9, t10, k);
        t12[k] = jlt_jet_root(t11[k], t12, k);
        t14[k] = jlt_jet_quotient((k == 0 ? t13 : 0), t12, t14, k);
        t15[k] = jlt_jet_sine(x1, t15, u15, k);
        t16[k] = (k == 0 ? p[8] : 0) - p[5]*t15[k];
        t17[k] = p[9]*t12[k];
        t18[k] = p[7]*t12[k];
        t19[k] = jlt_jet_product(t16, t18, k);
        t20[k] = jlt_jet_cosine(x1, t20, u20, k);
        t21[k] = x0[k]*p[10];
        t22[k] = jlt_jet_product(t20, t21, k) + t17[k];
        t23[k] = jlt_jet_product(t14, t22, k);
        double *restrict next = coefficients + (k + 1)*2;
        next[0] = x0[k + 1] = t19[k]/(k + 1);
        next[1] = x1[k + 1] = t23[k]/(k + 1);
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
    const double v_F0 = params[6];
    const double v_I3 = (v_I1);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*(v_I1*v_s*v_s + v_I3*v_gamma3*v_gamma3));
    const double v_M = params[5];
    const double complex v_psi = x[1];
    const double complex v_C = ccos(v_psi);
    const double v_G = params[4];
    const double complex v_omega3 = ((v_I1*v_M*v_s*v_C - v_G*v_gamma3*v_J1/v_R)/v_Theta);
    const double complex v_v_slip = csqrt((v_F0 - v_Theta*v_omega3*v_omega3*(v_I1 - v_I3))/(v_m*v_I1*v_I1));
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s*v_omega_tau);
    const double complex v_J3 = (v_I3 + v_m*v_R*v_R);
    const double complex v_omega_n = ((v_G*v_s*v_J3/v_R + v_I3*v_M*v_gamma3*v_C)/v_Theta);
    out[1] = (v_omega_n/v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "psi", "rad", "angle of the horizontal momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 2.0*0x1.921fb54442d18p+1 },
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

const jlt_descriptor jlt_kernels_spherical_top_plane_equal_moments = {
    .model = "spherical_top_plane",
    .variant = "equal_moments",
    .time = "",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on a level of all three integrals",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_plane, .family = jlt_family_spherical_top_plane, .claims = jlt_claims_spherical_top_plane,
    .scales = 1,
    .state_count = 2, .param_count = 7, .prepared_count = 17,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 2, { 2, 6, 2, 1, 1, 2, 6, 5 }, { 7, 25, 0, 4, 2, 2, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in m*R*v_slip - M*S, C*gamma3*(I1*M) + s*(G*J3/R)" },
    .jacobian = { jacobian, 4, { 2, 14, 4, 1, 1, 2, 9, 6 }, { 12, 41, 0, 8, 2, 2, 11, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*(I1*M)*C + (G*J3/R)*s, G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s, (I1*M)*C - (G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s)*gamma3*1/s, m*R*v_slip - M*S" },
    .rhs_jacobian = { rhs_jacobian, 6, { 3, 16, 4, 1, 1, 2, 9, 8 }, { 14, 51, 0, 11, 2, 2, 11, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*(I1*M)*C + (G*J3/R)*s, m*R*v_slip - M*S, G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s, (I1*M)*C - (G*J3/R - (gamma3*(I1*M)*C + (G*J3/R)*s)*1/s)*gamma3*1/s" },
    .divergence = { divergence, 1, { 2, 6, 0, 1, 1, 0, 7, 4 }, { 7, 22, 0, 3, 2, 1, 11, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_values = { .loses_digits = "" },
    .integral_gradients = { .loses_digits = "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { domain_values, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .domain_gradients = { domain_gradients, 2, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .domain_count = 1, .domains = domains,
    .integral_count = 0, .measure_count = 0, .equilibria_count = 0,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_plane_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_plane_equal_moments) },
#endif
};
