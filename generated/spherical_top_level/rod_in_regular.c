/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   15    3    1    0    0     10    7   (42)
 *  jacobian            5   24    6    1    0    0     10   11   (119)
 *  rhs_jacobian        8   29    6    1    0    0     12   11   (156)
 *  divergence          1    4    1    1    0    0      5    5   (15)
 *  integral_values     0    6    5    1    0    0      6    6   (35)
 *  integral_gradients  0    8    2    1    0    0      3    4   (25)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_rod_in_regular;
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
    const double t2 = params[5]*params[5]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[3]*t4; /* I1*R*R */
    const double t6 = params[6]*params[6]; /* G*G */
    const double t7 = t6/t5; /* G*G/(I1*R*R) */
    const double t8 = params[0]*params[2]; /* m*g */
    const double t9 = params[5]*t8; /* a3*m*g */
    const double t10 = params[0]*2.0; /* m*2 */
    const double t11 = t2*t10; /* a3*a3*m*2 */
    const double t12 = params[2]*t10; /* g*m*2 */
    const double t13 = params[5]*t12; /* a3*g*m*2 */
    const double t14 = t6*2.0; /* G*G*2 */
    const double t15 = t14/t5; /* G*G*2/(I1*R*R) */
    const double t16 = params[0]/2.0; /* m/2 */
    const double t17 = t4*2.0; /* R*R*2 */
    const double t18 = params[3]*t17; /* I1*R*R*2 */
    const double t19 = t6/t18; /* G*G/(I1*R*R*2) */
    out[7] = t1;
    out[8] = t3;
    out[9] = t7;
    out[10] = t9;
    out[11] = t11;
    out[12] = t13;
    out[13] = t15;
    out[14] = t16;
    out[15] = t19;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = JLT_FMA(t0, p[8], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t3 = x[4]*t2; /* s*D */
    const double t4 = 1.0/t3; /* 1/(s*D) */
    const double t5 = t2*t4; /* D*1/(s*D) */
    const double t6 = p[7]*t5; /* G/(R*I1)*D*1/(s*D) */
    const double t7 = x[3]*t6; /* v_tau*G/(R*I1)*D*1/(s*D) */
    const double t8 = x[2]*p[8]; /* omega_tau*m*a3^2 */
    const double t9 = t1*t8; /* omega_tau*s*s*omega_tau*m*a3^2 */
    const double t10 = t5*p[9]; /* D*1/(s*D)*G^2/(R^2*I1) */
    const double t11 = JLT_FNMA(t5, t10, t9); /* omega_tau*s*s*omega_tau*m*a3^2 - D*1/(s*D)*D*1/(s*D)*G^2/(R^2*I1) */
    const double t12 = x[0]*t11; /* gamma3*t11 */
    const double t13 = JLT_FNMA(t0, p[10], t12); /* gamma3*t11 - s*s*m*g*a3 */
    const double t14 = x[4]*t4; /* s*1/(s*D) */
    const double t15 = t13*t14; /* (gamma3*t11 - s*s*m*g*a3)*s*1/(s*D) */
    const double t16 = t6*x[1]; /* G/(R*I1)*D*1/(s*D)*v_nu */
    const double t17 = -t16; /* -G/(R*I1)*D*1/(s*D)*v_nu */
    const double t18 = x[2]*x[4]; /* omega_tau*s */
    const double t19 = x[0]*t18; /* gamma3*omega_tau*s */
    const double t20 = -t19; /* -gamma3*omega_tau*s */
    out[0] = t1;
    out[1] = t7;
    out[2] = t15;
    out[3] = t17;
    out[4] = t20;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = JLT_FMA(t0, p[8], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t4 = x[4]*t3; /* s*D */
    const double t5 = 1.0/t4; /* 1/(s*D) */
    const double t6 = t3*t5; /* D*1/(s*D) */
    const double t7 = p[7]*t6; /* G/(R*I1)*D*1/(s*D) */
    const double t8 = t6*t6; /* D*1/(s*D)*D*1/(s*D) */
    const double t9 = p[7]*t8; /* G/(R*I1)*D*1/(s*D)*D*1/(s*D) */
    const double t10 = x[3]*t9; /* v_tau*G/(R*I1)*D*1/(s*D)*D*1/(s*D) */
    const double t11 = -t10; /* -v_tau*G/(R*I1)*D*1/(s*D)*D*1/(s*D) */
    const double t12 = x[4]*t5; /* s*1/(s*D) */
    const double t13 = t0*t12; /* s*s*s*1/(s*D) */
    const double t14 = p[8]*t13; /* m*a3^2*s*s*s*1/(s*D) */
    const double t15 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t16 = t14*t15; /* m*a3^2*s*s*s*1/(s*D)*omega_tau*omega_tau */
    const double t17 = t12*p[9]; /* s*1/(s*D)*G^2/(R^2*I1) */
    const double t18 = JLT_FNMA(t8, t17, t16); /* m*a3^2*s*s*s*1/(s*D)*omega_tau*omega_tau - D*1/(s*D)*D*1/(s*D)*s*1/(s*D)*G^2/(R^2*I1) */
    const double t19 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t20 = p[11]*t19; /* 2*m*a3^2*omega_tau*gamma3 */
    const double t21 = t13*t20; /* s*s*s*1/(s*D)*2*m*a3^2*omega_tau*gamma3 */
    const double t22 = x[4]*p[12]; /* s*2*m*g*a3 */
    const double t23 = JLT_FNMA(t1, t20, t22); /* s*2*m*g*a3 - s*omega_tau*2*m*a3^2*omega_tau*gamma3 */
    const double t24 = JLT_FMA(p[8], t12, t8); /* m*a3^2*s*1/(s*D) + D*1/(s*D)*D*1/(s*D) */
    const double t25 = x[0]*p[13]; /* gamma3*2*G^2/(R^2*I1) */
    const double t26 = t6*t25; /* D*1/(s*D)*gamma3*2*G^2/(R^2*I1) */
    const double t27 = JLT_FMS(t14, t23, t23); /* m*a3^2*s*s*s*1/(s*D)*(s*2*m*g*a3 - s*omega_tau*2*m*a3^2*omega_tau*gamma3) - (s*2*m*g*a3 - s*omega_tau*2*m*a3^2*omega_tau*gamma3) */
    const double t28 = JLT_FMA(t24, t26, t27); /* (m*a3^2*s*1/(s*D) + D*1/(s*D)*D*1/(s*D))*D*1/(s*D)*gamma3*2*G^2/(R^2*I1) + t27 */
    const double t29 = t12*t28; /* s*1/(s*D)*t28 */
    const double t30 = -t7; /* -G/(R*I1)*D*1/(s*D) */
    const double t31 = t9*x[1]; /* G/(R*I1)*D*1/(s*D)*D*1/(s*D)*v_nu */
    const double t32 = -t1; /* -s*omega_tau */
    const double t33 = x[4]*x[0]; /* s*gamma3 */
    const double t34 = -t33; /* -s*gamma3 */
    const double t35 = -t19; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t7;
    out[9] = t11;
    out[10] = t18;
    out[11] = 0.0;
    out[12] = t21;
    out[13] = 0.0;
    out[14] = t29;
    out[15] = 0.0;
    out[16] = t30;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t31;
    out[20] = t32;
    out[21] = 0.0;
    out[22] = t34;
    out[23] = 0.0;
    out[24] = t35;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = JLT_FMA(p[8], t2, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t4 = x[4]*t3; /* s*D */
    const double t5 = 1.0/t4; /* 1/(s*D) */
    const double t6 = t3*t5; /* D*1/(s*D) */
    const double t7 = p[7]*t6; /* G/(R*I1)*D*1/(s*D) */
    const double t8 = x[3]*t7; /* v_tau*G/(R*I1)*D*1/(s*D) */
    const double t9 = t0*p[8]; /* s*omega_tau*m*a3^2 */
    const double t10 = t0*t9; /* s*omega_tau*s*omega_tau*m*a3^2 */
    const double t11 = t6*t6; /* D*1/(s*D)*D*1/(s*D) */
    const double t12 = JLT_FNMA(p[9], t11, t10); /* s*omega_tau*s*omega_tau*m*a3^2 - G^2/(R^2*I1)*D*1/(s*D)*D*1/(s*D) */
    const double t13 = x[0]*t12; /* gamma3*t12 */
    const double t14 = JLT_FMS(t2, p[10], t13); /* s*s*m*g*a3 - gamma3*t12 */
    const double t15 = x[4]*t5; /* s*1/(s*D) */
    const double t16 = t14*t15; /* (s*s*m*g*a3 - gamma3*t12)*s*1/(s*D) */
    const double t17 = -t16; /* -(s*s*m*g*a3 - gamma3*t12)*s*1/(s*D) */
    const double t18 = t7*x[1]; /* G/(R*I1)*D*1/(s*D)*v_nu */
    const double t19 = -t18; /* -G/(R*I1)*D*1/(s*D)*v_nu */
    const double t20 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t21 = -t20; /* -s*omega_tau*gamma3 */
    const double t22 = t0*2.0; /* s*omega_tau*2 */
    const double t23 = t6*t8; /* D*1/(s*D)*v_tau*G/(R*I1)*D*1/(s*D) */
    const double t24 = -t23; /* -D*1/(s*D)*v_tau*G/(R*I1)*D*1/(s*D) */
    const double t25 = t12*t15; /* t12*s*1/(s*D) */
    const double t26 = x[4]*p[11]; /* s*2*m*a3^2 */
    const double t27 = t20*t26; /* s*omega_tau*gamma3*s*2*m*a3^2 */
    const double t28 = t15*t27; /* s*1/(s*D)*s*omega_tau*gamma3*s*2*m*a3^2 */
    const double t29 = x[2]*p[11]; /* omega_tau*2*m*a3^2 */
    const double t30 = t0*t29; /* s*omega_tau*omega_tau*2*m*a3^2 */
    const double t31 = t6*p[13]; /* D*1/(s*D)*2*G^2/(R^2*I1) */
    const double t32 = JLT_FMA(t11, t31, t30); /* D*1/(s*D)*D*1/(s*D)*D*1/(s*D)*2*G^2/(R^2*I1) + s*omega_tau*omega_tau*2*m*a3^2 */
    const double t33 = x[0]*t32; /* gamma3*t32 */
    const double t34 = JLT_FNMA(x[4], p[12], t33); /* d(numerator of d(omega_tau)/dt over D)/d(s) = gamma3*t32 - s*2*m*g*a3 */
    const double t35 = JLT_FMA(t16, t26, t34); /* (s*s*m*g*a3 - gamma3*t12)*s*1/(s*D)*s*2*m*a3^2 + d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t36 = t15*t35; /* s*1/(s*D)*t35 */
    const double t37 = -t7; /* -G/(R*I1)*D*1/(s*D) */
    const double t38 = t6*t18; /* D*1/(s*D)*G/(R*I1)*D*1/(s*D)*v_nu */
    const double t39 = -t0; /* -s*omega_tau */
    const double t40 = x[4]*x[0]; /* s*gamma3 */
    const double t41 = -t40; /* -s*gamma3 */
    const double t42 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t43 = -t42; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t8;
    out[2] = t17;
    out[3] = t19;
    out[4] = t21;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t2;
    out[8] = 0.0;
    out[9] = t22;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t7;
    out[14] = t24;
    out[15] = t25;
    out[16] = 0.0;
    out[17] = t28;
    out[18] = 0.0;
    out[19] = t36;
    out[20] = 0.0;
    out[21] = t37;
    out[22] = 0.0;
    out[23] = 0.0;
    out[24] = t38;
    out[25] = t39;
    out[26] = 0.0;
    out[27] = t41;
    out[28] = 0.0;
    out[29] = t43;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[8], t0, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t2 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t3 = p[11]*t2; /* 2*m*a3^2*gamma3*omega_tau */
    const double t4 = t0*t3; /* s*s*2*m*a3^2*gamma3*omega_tau */
    const double t5 = t4/t1; /* s*s*2*m*a3^2*gamma3*omega_tau/D */
    const double t6 = t5 - t2; /* s*s*2*m*a3^2*gamma3*omega_tau/D - gamma3*omega_tau */
    out[0] = t6;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = JLT_FMA(x[3], x[3], t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t2 = p[14]*t1; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t3 = p[8]*x[4]; /* m*a3^2*s */
    const double t4 = JLT_FMA(x[4], t3, p[3]); /* D = s*m*a3^2*s + I1 */
    const double t5 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t6 = x[2]*t5; /* omega_tau*1/2*omega_tau */
    const double t7 = 1.0/x[4]; /* 1/s */
    const double t8 = p[15]*t7; /* 1/2*G^2/(R^2*I1)*1/s */
    const double t9 = JLT_FMA(p[10], x[0], t2); /* m*g*a3*gamma3 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t10 = JLT_FMA(t4, t6, t9); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t11 = JLT_FMA(t7, t8, t10); /* 1/s*1/2*G^2/(R^2*I1)*1/s + t10 */
    out[0] = t11;
    out[1] = t2;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    const double t1 = x[4]*p[8]; /* s*m*a3^2 */
    const double t2 = JLT_FMA(x[4], t1, p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t3 = x[2]*t2; /* omega_tau*D */
    const double t4 = p[0]*x[3]; /* m*v_tau */
    const double t5 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t6 = t1*t5; /* s*m*a3^2*omega_tau*omega_tau */
    const double t7 = 1.0/x[4]; /* 1/s */
    const double t8 = p[9]*t7; /* G^2/(R^2*I1)*1/s */
    const double t9 = t7*t7; /* 1/s*1/s */
    const double t10 = JLT_FNMA(t8, t9, t6); /* s*m*a3^2*omega_tau*omega_tau - G^2/(R^2*I1)*1/s*1/s*1/s */
    out[0] = p[10];
    out[1] = t0;
    out[2] = t3;
    out[3] = t4;
    out[4] = t10;
    out[5] = 0.0;
    out[6] = t0;
    out[7] = 0.0;
    out[8] = t4;
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
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t8[k] = jlt_jet_product(x4, x4, k);
        t9[k] = p[8]*t8[k] + (k == 0 ? p[3] : 0);
        t10[k] = jlt_jet_product(x4, t9, k);
        t12[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t10, t12, k);
        t13[k] = jlt_jet_product(t9, t12, k);
        t14[k] = p[7]*t13[k];
        t15[k] = jlt_jet_product(x3, t14, k);
        t17[k] = jlt_jet_product(t2, x0, k);
        t18[k] = t2[k]*p[8];
        t19[k] = jlt_jet_product(t17, t18, k);
        t21[k] = x0[k]*p[9];
        t22[k] = jlt_jet_product(t13, t21, k);
        t24[k] = t19[k] - t8[k]*p[10];
        t25[k] = t24[k] - jlt_jet_product(t13, t22, k);
        t26[k] = jlt_jet_product(x4, t12, k);
        t27[k] = jlt_jet_product(t25, t26, k);
        t29[k] = jlt_jet_product(t14, x1, k);
        t30[k] = -t29[k];
        t31[k] = -t17[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t15[k]/(k + 1);
        next[2] = x2[k + 1] = t27[k]/(k + 1);
        next[3] = x3[k + 1] = t30[k]/(k + 1);
        next[4] = x4[k + 1] = t31[k]/(k + 1);
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

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0) },
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
    .sha256 = "0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 16,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 15, 3, 1, 0, 0, 10, 7 }, { 5, 32, 0, 5, 0, 0, 8, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .jacobian = { jacobian, 25, { 5, 24, 6, 1, 0, 0, 10, 11 }, { 12, 94, 0, 13, 0, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 8, 29, 6, 1, 0, 0, 12, 11 }, { 16, 122, 0, 18, 0, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .divergence = { divergence, 1, { 1, 4, 1, 1, 0, 0, 5, 5 }, { 2, 12, 0, 1, 0, 0, 8, 4 },
        "" },
    .integral_values = { integral_values, 2, { 0, 6, 5, 1, 0, 0, 6, 6 }, { 6, 28, 0, 1, 0, 0, 9, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 10, { 0, 8, 2, 1, 0, 0, 3, 4 }, { 2, 22, 0, 1, 0, 0, 5, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_rod_in_regular_baseline,
        &jlt_batch_spherical_top_level_rod_in_regular_avx2,
        &jlt_batch_spherical_top_level_rod_in_regular_avx512,
    },
};
