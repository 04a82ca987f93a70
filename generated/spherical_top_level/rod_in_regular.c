/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   15    3    1    0    0     10    6   (42)
 *  jacobian            5   26    5    1    0    0      9    7   (119)
 *  rhs_jacobian        7   29    6    1    0    0     12    8   (156)
 *  divergence          1    4    1    1    0    0      5    4   (15)
 *  integral_values     0    6    5    1    0    0      6    4   (35)
 *  integral_gradients  0    8    2    1    0    0      3    4   (25)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in s*omega_tau*(m*a3^2)*s*omega_tau - (G^2/(R^2*I1))*1/s*1/s,
 *      numerator of d(omega_tau)/dt over D, d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_chart_spherical_top_level_5[];
extern const char jlt_table_spherical_top_level[];
extern const jlt_claim jlt_claims_spherical_top_level[];
extern const jlt_descriptor *const jlt_family_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_rod_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_level_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = 0.0;
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
    const double t0 = params[1]*params[3]; /* R*I1 */
    const double t1 = params[6]/t0; /* G/(R*I1) */
    out[7] = t1;
    const double t2 = params[5]*params[5]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    out[8] = t3;
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[3]*t4; /* I1*R*R */
    const double t6 = params[6]*params[6]; /* G*G */
    const double t7 = t6/t5; /* G*G/(I1*R*R) */
    out[9] = t7;
    const double t8 = params[0]*params[2]; /* m*g */
    const double t9 = params[5]*t8; /* a3*m*g */
    out[10] = t9;
    const double t10 = params[0]*2.0; /* m*2 */
    const double t11 = t2*t10; /* a3*a3*m*2 */
    out[11] = t11;
    const double t12 = (-2.0)/t5; /* (-2)/(I1*R*R) */
    out[12] = t12;
    const double t13 = params[0]*t4; /* m*R*R */
    const double t14 = params[2]*t13; /* g*m*R*R */
    const double t15 = params[3]*params[3]; /* I1*I1 */
    const double t16 = t14*t15; /* g*m*R*R*I1*I1 */
    const double t17 = params[5]*t16; /* a3*g*m*R*R*I1*I1 */
    out[13] = t17;
    const double t18 = t6*t11; /* G*G*a3*a3*m*2 */
    out[14] = t18;
    const double t19 = t13*t15; /* m*R*R*I1*I1 */
    const double t20 = t2*t19; /* a3*a3*m*R*R*I1*I1 */
    out[15] = t20;
    const double t21 = params[3]*t6; /* I1*G*G */
    out[16] = t21;
    const double t22 = params[2]*t10; /* g*m*2 */
    const double t23 = params[5]*t22; /* a3*g*m*2 */
    out[17] = t23;
    const double t24 = t6*2.0; /* G*G*2 */
    const double t25 = t24/t5; /* G*G*2/(I1*R*R) */
    out[18] = t25;
    const double t26 = params[0]/2.0; /* m/2 */
    out[19] = t26;
    const double t27 = t4*2.0; /* R*R*2 */
    const double t28 = params[3]*t27; /* I1*R*R*2 */
    const double t29 = t6/t28; /* G*G/(I1*R*R*2) */
    out[20] = t29;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[8], t0, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t2 = x[4]*t1; /* s*D */
    const double t3 = 1.0/t2; /* 1/(s*D) */
    const double t4 = t1*t3; /* 1/s = D*1/(s*D) */
    const double t5 = x[4]*t3; /* s*1/(s*D) */
    const double t6 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t6;
    const double t7 = x[2]*p[8]; /* omega_tau*m*a3^2 */
    const double t8 = t6*t7; /* omega_tau*s*s*omega_tau*m*a3^2 */
    const double t9 = p[9]*t4; /* G^2/(R^2*I1)*1/s */
    const double t10 = JLT_FNMA(t4, t9, t8); /* omega_tau*s*s*omega_tau*m*a3^2 - 1/s*G^2/(R^2*I1)*1/s */
    const double t11 = p[7]*t4; /* G/(R*I1)*1/s */
    const double t12 = x[0]*t10; /* gamma3*(omega_tau*s*s*omega_tau*m*a3^2 - 1/s*G^2/(R^2*I1)*1/s) */
    const double t13 = JLT_FNMA(p[10], t0, t12); /* t12 - m*g*a3*s*s */
    const double t14 = t5*t13; /* s*1/(s*D)*(t12 - m*g*a3*s*s) */
    out[2] = t14;
    const double t15 = x[3]*t11; /* v_tau*G/(R*I1)*1/s */
    out[1] = t15;
    const double t16 = x[1]*t11; /* v_nu*G/(R*I1)*1/s */
    const double t17 = -t16; /* -v_nu*G/(R*I1)*1/s */
    out[3] = t17;
    const double t18 = x[2]*x[4]; /* omega_tau*s */
    const double t19 = x[0]*t18; /* gamma3*omega_tau*s */
    const double t20 = -t19; /* -gamma3*omega_tau*s */
    out[4] = t20;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[13] = 0.0;
    out[15] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[21] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[2] = t0;
    const double t1 = JLT_FMA(p[8], t0, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t2 = x[4]*t1; /* s*D */
    const double t3 = 1.0/t2; /* 1/(s*D) */
    const double t4 = t1*t3; /* 1/s = D*1/(s*D) */
    const double t5 = x[4]*t3; /* 1/D = s*1/(s*D) */
    const double t6 = x[4]*x[2]; /* s*omega_tau */
    const double t7 = 2.0*t6; /* 2*s*omega_tau */
    out[4] = t7;
    const double t8 = -t6; /* -s*omega_tau */
    out[20] = t8;
    const double t9 = t6*t6; /* s*omega_tau*s*omega_tau */
    const double t10 = p[15]*t0; /* m*R^2*I1^2*a3^2*s*s */
    const double t11 = JLT_FMA(p[14], t0, p[16]); /* 2*m*a3^2*G^2*s*s + I1*G^2 */
    const double t12 = JLT_FMA(t9, t10, t11); /* s*omega_tau*s*omega_tau*m*R^2*I1^2*a3^2*s*s + 2*m*a3^2*G^2*s*s + I1*G^2 */
    const double t13 = x[0]*t12; /* gamma3*t12 */
    const double t14 = p[8]*t9; /* m*a3^2*s*omega_tau*s*omega_tau */
    const double t15 = t4*t13; /* 1/s*gamma3*t12 */
    const double t16 = t4*t4; /* 1/s*1/s */
    const double t17 = p[7]*t4; /* G/(R*I1)*1/s */
    out[8] = t17;
    const double t18 = -t17; /* -G/(R*I1)*1/s */
    out[16] = t18;
    const double t19 = JLT_FNMA(p[9], t16, t14); /* m*a3^2*s*omega_tau*s*omega_tau - G^2/(R^2*I1)*1/s*1/s */
    const double t20 = t5*t19; /* 1/D*(m*a3^2*s*omega_tau*s*omega_tau - G^2/(R^2*I1)*1/s*1/s) */
    out[10] = t20;
    const double t21 = x[4]*x[0]; /* s*gamma3 */
    const double t22 = -t21; /* -s*gamma3 */
    out[22] = t22;
    const double t23 = p[11]*t21; /* 2*m*a3^2*s*gamma3 */
    const double t24 = t6*t23; /* s*omega_tau*2*m*a3^2*s*gamma3 */
    const double t25 = t5*t24; /* 1/D*s*omega_tau*2*m*a3^2*s*gamma3 */
    out[12] = t25;
    const double t26 = p[7]*t16; /* G/(R*I1)*1/s*1/s */
    const double t27 = x[1]*t26; /* v_nu*G/(R*I1)*1/s*1/s */
    out[19] = t27;
    const double t28 = x[3]*t26; /* v_tau*G/(R*I1)*1/s*1/s */
    const double t29 = -t28; /* -v_tau*G/(R*I1)*1/s*1/s */
    out[9] = t29;
    const double t30 = x[4]*p[13]; /* s*m*R^2*g*I1^2*a3 */
    const double t31 = JLT_FNMA(t15, t16, t30); /* s*m*R^2*g*I1^2*a3 - 1/s*gamma3*t12*1/s*1/s */
    const double t32 = p[12]*t5; /* (-2/(R^2*I1))*1/D */
    const double t33 = t5*t32; /* 1/D*(-2/(R^2*I1))*1/D */
    const double t34 = t31*t33; /* (s*m*R^2*g*I1^2*a3 - 1/s*gamma3*t12*1/s*1/s)*1/D*(-2/(R^2*I1))*1/D */
    out[14] = t34;
    const double t35 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t36 = -t35; /* -omega_tau*gamma3 */
    out[24] = t36;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[18] = 0.0;
    out[20] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[7] = t0;
    const double t1 = JLT_FMA(p[8], t0, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t2 = x[4]*t1; /* s*D */
    const double t3 = 1.0/t2; /* 1/(s*D) */
    const double t4 = t1*t3; /* 1/s = D*1/(s*D) */
    const double t5 = x[4]*t3; /* 1/D = s*1/(s*D) */
    const double t6 = x[4]*x[2]; /* s*omega_tau */
    const double t7 = x[4]*t6; /* s*s*omega_tau */
    out[0] = t7;
    const double t8 = 2.0*t6; /* 2*s*omega_tau */
    out[9] = t8;
    const double t9 = -t6; /* -s*omega_tau */
    out[25] = t9;
    const double t10 = p[8]*t6; /* m*a3^2*s*omega_tau */
    const double t11 = t6*t10; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t12 = x[0]*t6; /* gamma3*s*omega_tau */
    const double t13 = -t12; /* -gamma3*s*omega_tau */
    out[4] = t13;
    const double t14 = p[11]*t12; /* 2*m*a3^2*gamma3*s*omega_tau */
    const double t15 = t4*t4; /* 1/s*1/s */
    const double t16 = JLT_FNMA(p[9], t15, t11); /* s*omega_tau*m*a3^2*s*omega_tau - G^2/(R^2*I1)*1/s*1/s */
    const double t17 = t5*t16; /* 1/D*(s*omega_tau*m*a3^2*s*omega_tau - G^2/(R^2*I1)*1/s*1/s) */
    out[15] = t17;
    const double t18 = x[0]*t16; /* gamma3*(s*omega_tau*m*a3^2*s*omega_tau - G^2/(R^2*I1)*1/s*1/s) */
    const double t19 = JLT_FNMA(p[10], t0, t18); /* numerator of d(omega_tau)/dt over D = t18 - m*g*a3*s*s */
    const double t20 = t5*t19; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t20;
    const double t21 = p[7]*t4; /* G/(R*I1)*1/s */
    out[13] = t21;
    const double t22 = -t21; /* -G/(R*I1)*1/s */
    out[21] = t22;
    const double t23 = x[4]*t5; /* s*1/D */
    const double t24 = t14*t23; /* 2*m*a3^2*gamma3*s*omega_tau*s*1/D */
    out[17] = t24;
    const double t25 = x[2]*t14; /* omega_tau*2*m*a3^2*gamma3*s*omega_tau */
    const double t26 = p[11]*t23; /* 2*m*a3^2*s*1/D */
    const double t27 = t20*t26; /* 1/D*numerator of d(omega_tau)/dt over D*2*m*a3^2*s*1/D */
    const double t28 = JLT_FNMA(x[4], p[17], t25); /* omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 */
    const double t29 = x[0]*p[18]; /* gamma3*2*G^2/(R^2*I1) */
    const double t30 = t4*t29; /* 1/s*gamma3*2*G^2/(R^2*I1) */
    const double t31 = JLT_FMA(t15, t30, t28); /* d(numerator of d(omega_tau)/dt over D)/d(s) = 1/s*1/s*1/s*gamma3*2*G^2/(R^2*I1) + omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 */
    const double t32 = JLT_FMS(t5, t31, t27); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) - 1/D*numerator of d(omega_tau)/dt over D*2*m*a3^2*s*1/D */
    out[19] = t32;
    const double t33 = x[3]*t21; /* v_tau*G/(R*I1)*1/s */
    out[1] = t33;
    const double t34 = x[1]*t21; /* v_nu*G/(R*I1)*1/s */
    const double t35 = t4*t33; /* 1/s*v_tau*G/(R*I1)*1/s */
    const double t36 = -t35; /* -1/s*v_tau*G/(R*I1)*1/s */
    out[14] = t36;
    const double t37 = t4*t34; /* 1/s*v_nu*G/(R*I1)*1/s */
    out[24] = t37;
    const double t38 = -t34; /* -v_nu*G/(R*I1)*1/s */
    out[3] = t38;
    const double t39 = x[4]*x[0]; /* s*gamma3 */
    const double t40 = -t39; /* -s*gamma3 */
    out[27] = t40;
    const double t41 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t42 = -t41; /* -omega_tau*gamma3 */
    out[29] = t42;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[11]*t0; /* 2*m*a3^2*gamma3*omega_tau */
    const double t3 = t1*t2; /* s*s*2*m*a3^2*gamma3*omega_tau */
    const double t4 = JLT_FMA(p[8], t1, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t5 = t3/t4; /* s*s*2*m*a3^2*gamma3*omega_tau/D */
    const double t6 = t5 - t0; /* s*s*2*m*a3^2*gamma3*omega_tau/D - gamma3*omega_tau */
    out[0] = t6;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = JLT_FMA(x[3], x[3], t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t2 = p[19]*t1; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[1] = t2;
    const double t3 = JLT_FMA(p[10], x[0], t2); /* m*g*a3*gamma3 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t4 = p[8]*x[4]; /* m*a3^2*s */
    const double t5 = JLT_FMA(x[4], t4, p[3]); /* D = s*m*a3^2*s + I1 */
    const double t6 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t7 = x[2]*t6; /* omega_tau*1/2*omega_tau */
    const double t8 = JLT_FMA(t5, t7, t3); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t9 = 1.0/x[4]; /* 1/s */
    const double t10 = p[20]*t9; /* 1/2*G^2/(R^2*I1)*1/s */
    const double t11 = JLT_FMA(t9, t10, t8); /* 1/s*1/2*G^2/(R^2*I1)*1/s + t8 */
    out[0] = t11;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = p[10];
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    out[6] = t0;
    const double t1 = x[4]*p[8]; /* s*m*a3^2 */
    const double t2 = JLT_FMA(x[4], t1, p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t3 = x[2]*t2; /* omega_tau*D */
    out[2] = t3;
    const double t4 = p[0]*x[3]; /* m*v_tau */
    out[3] = t4;
    out[8] = t4;
    const double t5 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t6 = t1*t5; /* s*m*a3^2*omega_tau*omega_tau */
    const double t7 = 1.0/x[4]; /* 1/s */
    const double t8 = p[9]*t7; /* G^2/(R^2*I1)*1/s */
    const double t9 = t7*t7; /* 1/s*1/s */
    const double t10 = JLT_FNMA(t8, t9, t6); /* s*m*a3^2*omega_tau*omega_tau - G^2/(R^2*I1)*1/s*1/s*1/s */
    out[4] = t10;
    out[5] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t11[k] = jlt_jet_product(x4, x2, k);
        t12[k] = jlt_jet_product(x4, t11, k);
        t13[k] = jlt_jet_product(x0, t11, k);
        t14[k] = p[8]*t11[k];
        t15[k] = jlt_jet_product(t13, t14, k);
        t16[k] = -t13[k];
        t17[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), x4, t17, k);
        t18[k] = jlt_jet_product(x4, x4, k);
        t19[k] = t15[k] - p[10]*t18[k];
        t20[k] = p[8]*t18[k] + (k == 0 ? p[3] : 0);
        t21[k] = x0[k]*p[9];
        t22[k] = jlt_jet_product(t17, t21, k);
        t23[k] = t19[k] - jlt_jet_product(t17, t22, k);
        t24[k] = jlt_jet_quotient(t23[k], t20, t24, k);
        t25[k] = p[7]*t17[k];
        t26[k] = jlt_jet_product(x3, t25, k);
        t27[k] = jlt_jet_product(x1, t25, k);
        t28[k] = -t27[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t12[k]/(k + 1);
        next[1] = x1[k + 1] = t26[k]/(k + 1);
        next[2] = x2[k + 1] = t24[k]/(k + 1);
        next[3] = x3[k + 1] = t28[k]/(k + 1);
        next[4] = x4[k + 1] = t16[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_v_tau = x[3];
    const double v_R = params[1];
    const double v_I1 = params[3];
    const double v_I3 = (0.0);
    const double v_a3 = params[5];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_K = (v_R*v_R*v_I1*v_s*v_s + v_I3*v_b*v_b);
    const double v_G = params[6];
    const double complex v_omega_n = ((v_R*v_G*v_s + v_I3*v_v_tau*v_b)/v_K);
    out[1] = (v_s)*((v_v_tau*v_omega_n/v_s));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double complex v_omega3 = ((v_R*v_I1*v_v_tau*v_s - v_G*v_b)/v_K);
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_v_nu = x[1];
    const double complex v_Theta = (v_m*v_K + v_I1*v_I3);
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((-v_v_nu*v_omega_n/v_s)
        + (v_I1*v_I3*v_V*v_omega_n/(v_s*v_Theta))
        + (-v_I3*v_omega_tau*v_omega3*(v_R*v_gamma3*(v_I1 - v_I3) - v_I3*v_a3)/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    out[3] = x[3];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[4] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[4]*x[4]; /* s*s */
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
    out[3] = 0.0;
    const double t1 = 2.0*x[4]; /* 2*s */
    out[4] = t1;
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0), 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "E1", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_rod_in_regular = {
    .model = "spherical_top_level",
    .variant = "rod",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .scales = 1,
    .state_count = 5, .param_count = 7, .prepared_count = 21,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 15, 3, 1, 0, 0, 10, 6 }, { 5, 32, 0, 5, 0, 0, 8, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in omega_tau*s*s*omega_tau*(m*a3^2) - 1/s*(G^2/(R^2*I1))*1/s, a part of d(omega_tau)/dtau" },
    .jacobian = { jacobian, 25, { 5, 26, 5, 1, 0, 0, 9, 7 }, { 12, 94, 0, 13, 0, 0, 12, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in (m*a3^2)*s*omega_tau*s*omega_tau - (G^2/(R^2*I1))*1/s*1/s, a part of d(d(omega_tau)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 7, 29, 6, 1, 0, 0, 12, 8 }, { 16, 122, 0, 18, 0, 0, 12, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in s*omega_tau*(m*a3^2)*s*omega_tau - (G^2/(R^2*I1))*1/s*1/s, numerator of d(omega_tau)/dt over D, d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 1, 4, 1, 1, 0, 0, 5, 4 }, { 2, 12, 0, 1, 0, 0, 8, 4 },
        "digits are lost where terms nearly cancel in the divergence" },
    .integral_values = { integral_values, 2, { 0, 6, 5, 1, 0, 0, 6, 4 }, { 6, 28, 0, 1, 0, 0, 9, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in E" },
    .integral_gradients = { integral_gradients, 10, { 0, 8, 2, 1, 0, 0, 3, 4 }, { 2, 22, 0, 1, 0, 0, 5, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in d(E)/d(s)" },
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
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_level_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_level_rod_in_regular) },
#endif
};
