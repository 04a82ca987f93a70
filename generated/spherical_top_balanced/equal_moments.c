/* Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Variant:    equal_moments: I1 = I3
 *  Table:      spherical_top_balanced, SHA-256 70ff20361cc8550a994847ce02cbc8dfe6b50b8424b0daf5121bfd70d4951a10
 *  Command:    ttc generate --out DIR spherical_top_balanced.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   10    4    1    1    2      9    6   (36)
 *  jacobian            2   19    6    1    1    2     11    9   (64)
 *  rhs_jacobian        3   19    6    1    1    2     11   10   (79)
 *  divergence          3    9    4    1    1    1     10    6   (31)
 *  integral_values     0    2    0    0    0    0      2    2   (4)
 *  integral_gradients  0    1    0    0    0    0      1    1   (4)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2 and m*R^2*(I3*gamma3^2 + I3*s^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_balanced[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_moments;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_moments_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_moments_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_moments_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[3];
    out[3] = params[3];
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
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[3] + t1; /* J1 = I3 + m*R*R */
    const double t3 = 1.0/t2; /* 1/J1 */
    const double t4 = params[0]*params[1]; /* m*R */
    const double t5 = params[3]*params[3]; /* I3*I3 */
    const double t6 = params[3]*t1; /* I3*m*R*R */
    const double t7 = t2*params[4]; /* J1*G */
    const double t8 = t7/params[1]; /* J1*G/R */
    const double t9 = params[3]*params[5]; /* I3*M */
    const double t10 = (-1.0)/t2; /* (-1)/J1 */
    const double t11 = t4/t2; /* m*R/J1 */
    const double t12 = params[5]/t2; /* M/J1 */
    const double t13 = -t12; /* -M/J1 */
    const double t14 = -t9; /* -I3*M */
    const double t15 = params[0]*t5; /* m*I3*I3 */
    const double t16 = params[0]*2.0; /* m*2 */
    const double t17 = t5*t16; /* I3*I3*m*2 */
    out[6] = t3;
    out[7] = t4;
    out[8] = t5;
    out[9] = t6;
    out[10] = t8;
    out[11] = t9;
    out[12] = t10;
    out[13] = t11;
    out[14] = t13;
    out[15] = t14;
    out[16] = t15;
    out[17] = t17;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = p[7]*x[1]; /* m*R*v_slip */
    const double t5 = sin(x[2]); /* S = sin(psi) */
    const double t6 = JLT_FNMA(p[5], t5, t4); /* m*R*v_slip - M*S */
    const double t7 = p[6]*t3; /* 1/J1*s */
    const double t8 = t6*t7; /* (m*R*v_slip - M*S)*1/J1*s */
    const double t9 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(1 + gamma3) */
    const double t10 = JLT_FMA(p[9], t9, p[8]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(1 + gamma3)) + I3^2 */
    const double t11 = t3*p[10]; /* s*G*J3/R */
    const double t12 = cos(x[2]); /* C = cos(psi) */
    const double t13 = x[0]*p[11]; /* gamma3*I3*M */
    const double t14 = JLT_FMA(t12, t13, t11); /* C*gamma3*I3*M + s*G*J3/R */
    const double t15 = t3*t10; /* s*Theta */
    const double t16 = 1.0/t15; /* 1/(s*Theta) */
    const double t17 = t15*t16; /* s*Theta*1/(s*Theta) */
    const double t18 = t16*t17; /* 1/(s*Theta)*s*Theta*1/(s*Theta) */
    const double t19 = t14*t18; /* (C*gamma3*I3*M + s*G*J3/R)*1/(s*Theta)*s*Theta*1/(s*Theta) */
    out[0] = t8;
    out[1] = 0.0;
    out[2] = t19;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[7]*x[1]; /* m*R*v_slip */
    const double t1 = sin(x[2]); /* S = sin(psi) */
    const double t2 = JLT_FNMA(p[5], t1, t0); /* m*R*v_slip - M*S */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = x[0] + 1.0; /* gamma3 + 1 */
    const double t5 = t3*t4; /* (1 - gamma3)*(gamma3 + 1) */
    const double t6 = JLT_FMA(x[0], x[0], t5); /* gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1) */
    const double t7 = JLT_FMA(p[9], t6, p[8]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1)) + I3^2 */
    const double t8 = sqrt(t5); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = t7*t8; /* Theta*s */
    const double t10 = 1.0/t9; /* 1/(Theta*s) */
    const double t11 = t7*t10; /* Theta*1/(Theta*s) */
    const double t12 = x[0]*t11; /* gamma3*Theta*1/(Theta*s) */
    const double t13 = p[12]*t12; /* (-1/J1)*gamma3*Theta*1/(Theta*s) */
    const double t14 = t2*t13; /* (m*R*v_slip - M*S)*(-1/J1)*gamma3*Theta*1/(Theta*s) */
    const double t15 = t8*p[13]; /* s*m*R/J1 */
    const double t16 = cos(x[2]); /* C = cos(psi) */
    const double t17 = t8*p[14]; /* s*(-M/J1) */
    const double t18 = t16*t17; /* C*s*(-M/J1) */
    const double t19 = t8*p[10]; /* s*G*J3/R */
    const double t20 = t16*p[11]; /* C*I3*M */
    const double t21 = JLT_FMA(x[0], t20, t19); /* gamma3*C*I3*M + s*G*J3/R */
    const double t22 = t11*t12; /* Theta*1/(Theta*s)*gamma3*Theta*1/(Theta*s) */
    const double t23 = JLT_FNMA(t12, p[10], t20); /* C*I3*M - gamma3*Theta*1/(Theta*s)*G*J3/R */
    const double t24 = JLT_FMA(t21, t22, t23); /* (gamma3*C*I3*M + s*G*J3/R)*Theta*1/(Theta*s)*gamma3*Theta*1/(Theta*s) + C*I3*M - gamma3*Theta*1/(Theta*s)*G*J3/R */
    const double t25 = t8*t10; /* s*1/(Theta*s) */
    const double t26 = t11*t25; /* Theta*1/(Theta*s)*s*1/(Theta*s) */
    const double t27 = t24*t26; /* t24*Theta*1/(Theta*s)*s*1/(Theta*s) */
    const double t28 = t25*p[15]; /* s*1/(Theta*s)*(-I3*M) */
    const double t29 = t12*t28; /* gamma3*Theta*1/(Theta*s)*s*1/(Theta*s)*(-I3*M) */
    const double t30 = t1*t29; /* S*gamma3*Theta*1/(Theta*s)*s*1/(Theta*s)*(-I3*M) */
    out[0] = t14;
    out[1] = t15;
    out[2] = t18;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = t27;
    out[7] = 0.0;
    out[8] = t30;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = p[7]*x[1]; /* m*R*v_slip */
    const double t5 = sin(x[2]); /* S = sin(psi) */
    const double t6 = JLT_FNMA(p[5], t5, t4); /* m*R*v_slip - M*S */
    const double t7 = p[6]*t6; /* 1/J1*(m*R*v_slip - M*S) */
    const double t8 = t3*t7; /* s*1/J1*(m*R*v_slip - M*S) */
    const double t9 = t3*p[10]; /* s*G*J3/R */
    const double t10 = cos(x[2]); /* C = cos(psi) */
    const double t11 = p[11]*t10; /* I3*M*C */
    const double t12 = JLT_FMA(x[0], t11, t9); /* gamma3*I3*M*C + s*G*J3/R */
    const double t13 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(1 + gamma3) */
    const double t14 = JLT_FMA(p[9], t13, p[8]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(1 + gamma3)) + I3^2 */
    const double t15 = t3*t14; /* s*Theta */
    const double t16 = 1.0/t15; /* 1/(s*Theta) */
    const double t17 = t12*t16; /* (gamma3*I3*M*C + s*G*J3/R)*1/(s*Theta) */
    const double t18 = t14*t16; /* Theta*1/(s*Theta) */
    const double t19 = x[0]*t18; /* gamma3*Theta*1/(s*Theta) */
    const double t20 = t7*t19; /* 1/J1*(m*R*v_slip - M*S)*gamma3*Theta*1/(s*Theta) */
    const double t21 = -t20; /* -1/J1*(m*R*v_slip - M*S)*gamma3*Theta*1/(s*Theta) */
    const double t22 = t3*p[13]; /* s*m*R/J1 */
    const double t23 = t3*p[14]; /* s*(-M/J1) */
    const double t24 = t10*t23; /* C*s*(-M/J1) */
    const double t25 = t18*t19; /* Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) */
    const double t26 = JLT_FNMA(p[10], t19, t11); /* I3*M*C - G*J3/R*gamma3*Theta*1/(s*Theta) */
    const double t27 = JLT_FMA(t12, t25, t26); /* (gamma3*I3*M*C + s*G*J3/R)*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) + I3*M*C - G*J3/R*gamma3*Theta*1/(s*Theta) */
    const double t28 = t16*t27; /* 1/(s*Theta)*t27 */
    const double t29 = x[0]*p[15]; /* gamma3*(-I3*M) */
    const double t30 = t16*t29; /* 1/(s*Theta)*gamma3*(-I3*M) */
    const double t31 = t5*t30; /* S*1/(s*Theta)*gamma3*(-I3*M) */
    out[0] = t8;
    out[1] = 0.0;
    out[2] = t17;
    out[3] = t21;
    out[4] = t22;
    out[5] = t24;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t28;
    out[10] = 0.0;
    out[11] = t31;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[9], t3, p[8]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1)) + I3^2 */
    const double t5 = p[7]*x[1]; /* m*R*v_slip */
    const double t6 = sin(x[2]); /* S = sin(psi) */
    const double t7 = JLT_FNMA(p[5], t6, t5); /* m*R*v_slip - M*S */
    const double t8 = p[6]*t7; /* 1/J1*(m*R*v_slip - M*S) */
    const double t9 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t10 = t4*t9; /* Theta*s */
    const double t11 = 1.0/t10; /* 1/(Theta*s) */
    const double t12 = p[11]*t9; /* I3*M*s */
    const double t13 = t11*t12; /* 1/(Theta*s)*I3*M*s */
    const double t14 = JLT_FMA(t6, t13, t8); /* S*1/(Theta*s)*I3*M*s + 1/J1*(m*R*v_slip - M*S) */
    const double t15 = x[0]*t4; /* gamma3*Theta */
    const double t16 = t11*t15; /* 1/(Theta*s)*gamma3*Theta */
    const double t17 = t14*t16; /* (S*1/(Theta*s)*I3*M*s + 1/J1*(m*R*v_slip - M*S))*1/(Theta*s)*gamma3*Theta */
    const double t18 = -t17; /* -t17 */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[16]*x[1]; /* m*I3^2*v_slip */
    const double t1 = x[1]*t0; /* v_slip*m*I3^2*v_slip */
    out[0] = t1;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[17]*x[1]; /* 2*m*I3^2*v_slip */
    out[0] = 0.0;
    out[1] = t0;
    out[2] = 0.0;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double u12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double u24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t9[k] = p[7]*x1[k];
        t12[k] = jlt_jet_sine(x2, t12, u12, k);
        t13[k] = t9[k] - p[5]*t12[k];
        t14[k] = p[6]*t6[k];
        t15[k] = jlt_jet_product(t13, t14, k);
        t19[k] = jlt_jet_product(x0, x0, k) + t5[k];
        t20[k] = p[9]*t19[k] + (k == 0 ? p[8] : 0);
        t22[k] = t6[k]*p[10];
        t24[k] = jlt_jet_cosine(x2, t24, u24, k);
        t25[k] = x0[k]*p[11];
        t26[k] = jlt_jet_product(t24, t25, k) + t22[k];
        t27[k] = jlt_jet_product(t6, t20, k);
        t28[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t27, t28, k);
        t29[k] = jlt_jet_product(t27, t28, k);
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = jlt_jet_product(t26, t30, k);
        double *restrict next = coefficients + (k + 1)*3;
        next[0] = x0[k + 1] = t15[k]/(k + 1);
        next[1] = x1[k + 1] = (k == 0 ? 0.0 : 0)/(k + 1);
        next[2] = x2[k + 1] = t31[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    const double v_I3 = params[3];
    const double v_I1 = (v_I3);
    const double v_m = params[0];
    const double v_R = params[1];
    const double complex v_J1 = (v_I1 + v_m*v_R*v_R);
    const double complex v_v_slip = x[1];
    const double v_M = params[5];
    const double complex v_psi = x[2];
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s*v_omega_tau);
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
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_slip", "m/s", "velocity of the contact point along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "psi", "rad", "angle of the horizontal momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (2.0 / 5.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 4.0) },
    { "G", "kg*m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-3.0 / 10.0) },
    { "M", "kg*m^2/s", "horizontal angular momentum about the contact point", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
};

static const jlt_named integrals[] = {
    { "F0", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_moments = {
    .model = "spherical_top_balanced",
    .variant = "equal_moments",
    .time = "",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "70ff20361cc8550a994847ce02cbc8dfe6b50b8424b0daf5121bfd70d4951a10",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_balanced,
    .state_count = 3, .param_count = 6, .block_count = 18,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 3, { 2, 10, 4, 1, 1, 2, 9, 6 }, { 7, 23, 0, 3, 1, 2, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2 and m*R^2*(I3*gamma3^2 + I3*s^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 9, { 2, 19, 6, 1, 1, 2, 11, 9 }, { 12, 41, 0, 8, 1, 2, 11, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2 and m*R^2*(I3*gamma3^2 + I3*s^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 12, { 3, 19, 6, 1, 1, 2, 11, 10 }, { 14, 51, 0, 11, 1, 2, 11, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2 and m*R^2*(I3*gamma3^2 + I3*s^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 9, 4, 1, 1, 1, 10, 6 }, { 7, 20, 0, 2, 1, 1, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2 and m*R^2*(I3*gamma3^2 + I3*s^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 0, 2, 0, 0, 0, 0, 2, 2 }, { 0, 4, 0, 0, 0, 0, 3, 3 },
        "" },
    .integral_gradients = { integral_gradients, 3, { 0, 1, 0, 0, 0, 0, 1, 1 }, { 0, 4, 0, 0, 0, 0, 3, 3 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_moments_baseline,
        &jlt_batch_spherical_top_balanced_equal_moments_avx2,
        &jlt_batch_spherical_top_balanced_equal_moments_avx512,
    },
};
