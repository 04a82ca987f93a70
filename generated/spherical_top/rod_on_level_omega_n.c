/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Eliminated: level_omega_n: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   18    8    1    1    0     13    9   (50)
 *  jacobian            5   34   16    1    1    0     17   13   (183)
 *  rhs_jacobian        4   37   19    1    1    0     15   17   (216)
 *  divergence          2    4    1    1    1    0      5    4   (15)
 *  integral_values     3    9    6    1    1    0      9    6   (54)
 *  integral_gradients  3   16    7    1    1    0     10    7   (75)
 *  measure_values      2    2    1    0    0    0      4    3   (10)
 *  measure_divergences 0    0    0    0    0    0      0    0   (32)
 *  eliminated          2    1    0    1    1    0      4    3   (6)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in gamma3*1/(D/I1)*omega_tau*omega_tau*(m*a3^2/I1) - (m*g*a3/I1)*1/(D/I1),
 *      e = gamma3*a3 + R, a part of d(d(omega_tau)/dt)/d(gamma3),
 *      omega_n*1/s^2*s*1/s^2*omega_n - omega_tau*(m*a3^2/I1)*omega_tau*s, b = gamma3*R + a3,
 *      a part of d(d(v_nu)/dt)/d(gamma3), 1/s^2*s*omega3*1/s^2 - (a3/R)*1/s^2*omega_n, d(omega_tau)/dt,
 *      d(d(omega_tau)/dt)/d(gamma3), d(v_nu)/dt, d(d(v_nu)/dt)/d(gamma3), V = omega_tau*e + v_nu,
 *      d(d(omega3)/dt)/d(omega_tau), d(omega3)/dt, d(d(omega3)/dt)/d(gamma3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_claim jlt_claims_spherical_top[];
extern const jlt_descriptor *const jlt_family_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_rod_on_level_omega_n;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_on_level_omega_n;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_on_level_omega_n_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_on_level_omega_n_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_on_level_omega_n_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
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
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = params[6]/t0; /* G_level/(R*I1) */
    out[7] = t1;
    const double t2 = params[3]*params[3]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    out[18] = t3;
    const double t4 = t3/params[4]; /* m*a3*a3/I1 */
    out[8] = t4;
    const double t5 = params[0]*params[2]; /* m*g */
    const double t6 = params[3]*t5; /* a3*m*g */
    out[19] = t6;
    const double t7 = t6/params[4]; /* a3*m*g/I1 */
    out[9] = t7;
    const double t8 = 1.0/params[1]; /* 1/R */
    out[10] = t8;
    const double t9 = params[6]*2.0; /* G_level*2 */
    const double t10 = t9/t0; /* G_level*2/(R*I1) */
    out[11] = t10;
    const double t11 = params[6]/params[4]; /* G_level/I1 */
    out[12] = t11;
    const double t12 = params[0]*2.0; /* m*2 */
    const double t13 = t2*t12; /* a3*a3*m*2 */
    out[17] = t13;
    const double t14 = t13/params[4]; /* a3*a3*m*2/I1 */
    out[13] = t14;
    const double t15 = params[3]/params[1]; /* a3/R */
    out[14] = t15;
    const double t16 = 2.0/params[1]; /* 2/R */
    out[15] = t16;
    const double t17 = params[1]*2.0; /* R*2 */
    const double t18 = params[4]*t17; /* I1*R*2 */
    const double t19 = params[6]/t18; /* G_level/(I1*R*2) */
    out[16] = t19;
    const double t20 = params[4]/2.0; /* I1/2 */
    out[20] = t20;
    const double t21 = params[0]/2.0; /* m/2 */
    out[21] = t21;
    const double t22 = params[6]/params[1]; /* G_level/R */
    out[22] = t22;
    const double t23 = params[1]*params[1]; /* R*R */
    const double t24 = params[4]*t23; /* I1*R*R */
    const double t25 = params[6]/t24; /* G_level/(I1*R*R) */
    out[23] = t25;
    const double t26 = params[1]*params[0]; /* R*m */
    out[24] = t26;
    const double t27 = 1.0/t0; /* 1/(R*I1) */
    out[25] = t27;
    const double t28 = params[0]*(-2.0); /* m*(-2) */
    const double t29 = t2*t28; /* a3*a3*m*(-2) */
    const double t30 = t29/t0; /* a3*a3*m*(-2)/(R*I1) */
    out[26] = t30;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[8], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t4 = t2*t3; /* s^2*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s^2*D/I1) */
    const double t6 = sqrt(t2); /* s = sqrt(s^2) */
    const double t7 = t3*t6; /* D/I1*s */
    const double t8 = t5*t7; /* 1/(s^2*D/I1)*D/I1*s */
    const double t9 = t2*t5; /* s^2*1/(s^2*D/I1) */
    const double t10 = p[7]*t8; /* omega_n = G_level/(R*I1)*1/(s^2*D/I1)*D/I1*s */
    const double t11 = t8*t10; /* 1/(s^2*D/I1)*D/I1*s*omega_n */
    const double t12 = x[2]*t6; /* omega_tau*s */
    out[0] = t12;
    const double t13 = t10*t11; /* omega_n*1/(s^2*D/I1)*D/I1*s*omega_n */
    const double t14 = x[2]*p[8]; /* omega_tau*m*a3^2/I1 */
    const double t15 = JLT_FMS(t12, t14, t13); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*1/(s^2*D/I1)*D/I1*s*omega_n */
    const double t16 = x[0]*t15; /* gamma3*t15 */
    const double t17 = JLT_FNMA(p[9], t6, t16); /* gamma3*t15 - m*g*a3/I1*s */
    const double t18 = t9*t17; /* s^2*1/(s^2*D/I1)*(gamma3*t15 - m*g*a3/I1*s) */
    out[2] = t18;
    const double t19 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t20 = JLT_FMA(x[2], t19, x[1]); /* V = omega_tau*e + v_nu */
    const double t21 = p[10]*t20; /* 1/R*V */
    const double t22 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t23 = x[3]*t22; /* omega3*omega_tau*gamma3 */
    const double t24 = JLT_FNMA(t11, t21, t23); /* omega3*omega_tau*gamma3 - 1/(s^2*D/I1)*D/I1*s*omega_n*1/R*V */
    const double t25 = t8*t24; /* 1/(s^2*D/I1)*D/I1*s*(omega3*omega_tau*gamma3 - 1/(s^2*D/I1)*D/I1*s*omega_n*1/R*V) */
    out[3] = t25;
    const double t26 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t27 = t13*t26; /* omega_n*1/(s^2*D/I1)*D/I1*s*omega_n*b */
    const double t28 = p[1]*x[3]; /* R*omega3 */
    const double t29 = JLT_FMA(t10, t28, t27); /* omega_n*R*omega3 + omega_n*1/(s^2*D/I1)*D/I1*s*omega_n*b */
    out[1] = t29;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[11] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[8], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t4 = t2*t3; /* s^2*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s^2*D/I1) */
    const double t6 = t3*t5; /* 1/s^2 = D/I1*1/(s^2*D/I1) */
    const double t7 = t2*t5; /* 1/(D/I1) = s^2*1/(s^2*D/I1) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t8;
    const double t9 = x[0]*t7; /* gamma3*1/(D/I1) */
    const double t10 = t6*t8; /* 1/s^2*s */
    const double t11 = p[13]*t9; /* 2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t12 = x[0]*t10; /* gamma3*1/s^2*s */
    const double t13 = t8*t11; /* s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t14 = x[2]*t13; /* omega_tau*s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    out[10] = t14;
    const double t15 = t13 - t12; /* s*2*m*a3^2/I1*gamma3*1/(D/I1) - gamma3*1/s^2*s */
    const double t16 = JLT_FMA(x[0], t15, t8); /* gamma3*(s*2*m*a3^2/I1*gamma3*1/(D/I1) - gamma3*1/s^2*s) + s */
    const double t17 = x[2]*p[8]; /* omega_tau*m*a3^2/I1 */
    const double t18 = x[2]*t17; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t19 = t16*t18; /* (gamma3*(s*2*m*a3^2/I1*gamma3*1/(D/I1) - gamma3*1/s^2*s) + s)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t20 = p[7]*t10; /* omega_n = G_level/(R*I1)*1/s^2*s */
    const double t21 = t11*t20; /* 2*m*a3^2/I1*gamma3*1/(D/I1)*omega_n */
    const double t22 = t10*t20; /* 1/s^2*s*omega_n */
    const double t23 = t6*t20; /* 1/s^2*omega_n */
    const double t24 = JLT_FNMA(t22, t23, t19); /* t19 - 1/s^2*s*omega_n*1/s^2*omega_n */
    const double t25 = t12*t20; /* gamma3*1/s^2*s*omega_n */
    const double t26 = JLT_FNMA(t21, t25, t24); /* t19 - 1/s^2*s*omega_n*1/s^2*omega_n - 2*m*a3^2/I1*gamma3*1/(D/I1)*omega_n*gamma3*1/s^2*s*omega_n */
    const double t27 = JLT_FNMA(p[9], t15, t26); /* t26 - m*g*a3/I1*(s*2*m*a3^2/I1*gamma3*1/(D/I1) - gamma3*1/s^2*s) */
    const double t28 = t7*t27; /* 1/(D/I1)*t27 */
    const double t29 = p[1]*t20; /* R*omega_n */
    out[7] = t29;
    const double t30 = t22*t29; /* 1/s^2*s*omega_n*R*omega_n */
    const double t31 = x[3]*t6; /* omega3*1/s^2 */
    const double t32 = t10*t31; /* 1/s^2*s*omega3*1/s^2 */
    const double t33 = JLT_FNMA(p[14], t23, t32); /* 1/s^2*s*omega3*1/s^2 - a3/R*1/s^2*omega_n */
    const double t34 = x[2]*t33; /* omega_tau*(1/s^2*s*omega3*1/s^2 - a3/R*1/s^2*omega_n) */
    const double t35 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t36 = x[0]*t23; /* gamma3*1/s^2*omega_n */
    const double t37 = p[11]*t6; /* 2*G_level/(R*I1)*1/s^2 */
    const double t38 = t36*t37; /* gamma3*1/s^2*omega_n*2*G_level/(R*I1)*1/s^2 */
    const double t39 = JLT_FNMA(t9, t38, t28); /* 1/(D/I1)*t27 - gamma3*1/(D/I1)*gamma3*1/s^2*omega_n*2*G_level/(R*I1)*1/s^2 */
    out[8] = t39;
    const double t40 = JLT_FMA(t23, t25, t38); /* 1/s^2*omega_n*gamma3*1/s^2*s*omega_n + gamma3*1/s^2*omega_n*2*G_level/(R*I1)*1/s^2 */
    const double t41 = p[10]*t23; /* 1/R*1/s^2*omega_n */
    const double t42 = -t41; /* -1/R*1/s^2*omega_n */
    out[13] = t42;
    const double t43 = JLT_FMA(x[2], t35, x[1]); /* V = omega_tau*e + v_nu */
    const double t44 = p[15]*t43; /* 2/R*V */
    const double t45 = t6*t44; /* 1/s^2*2/R*V */
    const double t46 = x[3]*t12; /* omega3*gamma3*1/s^2*s */
    const double t47 = JLT_FNMA(t35, t41, t46); /* omega3*gamma3*1/s^2*s - e*1/R*1/s^2*omega_n */
    out[14] = t47;
    const double t48 = p[12]*t6; /* G_level/I1*1/s^2 */
    const double t49 = JLT_FMA(t46, t48, t30); /* omega3*gamma3*1/s^2*s*G_level/I1*1/s^2 + 1/s^2*s*omega_n*R*omega_n */
    const double t50 = p[16]*t6; /* 1/2*G_level/(R*I1)*1/s^2 */
    const double t51 = JLT_FMA(t12, t50, t36); /* gamma3*1/s^2*s*1/2*G_level/(R*I1)*1/s^2 + gamma3*1/s^2*omega_n */
    const double t52 = JLT_FNMA(t45, t51, t34); /* omega_tau*(1/s^2*s*omega3*1/s^2 - a3/R*1/s^2*omega_n) - 1/s^2*2/R*V*t51 */
    out[12] = t52;
    const double t53 = x[2]*t12; /* omega_tau*gamma3*1/s^2*s */
    out[15] = t53;
    const double t54 = -t53; /* -omega_tau*gamma3*1/s^2*s */
    out[0] = t54;
    const double t55 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t56 = JLT_FMA(t40, t55, t49); /* t40*b + t49 */
    out[4] = t56;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[15] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[8], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t4 = t2*t3; /* s^2*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s^2*D/I1) */
    const double t6 = t3*t5; /* 1/s^2 = D/I1*1/(s^2*D/I1) */
    const double t7 = t2*t5; /* 1/(D/I1) = s^2*1/(s^2*D/I1) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t8;
    const double t9 = t6*t8; /* 1/s^2*s */
    const double t10 = p[7]*t9; /* omega_n = G_level/(R*I1)*1/s^2*s */
    const double t11 = x[2]*p[8]; /* omega_tau*m*a3^2/I1 */
    const double t12 = x[0]*t7; /* gamma3*1/(D/I1) */
    const double t13 = x[2]*t11; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t14 = t12*t13; /* gamma3*1/(D/I1)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t15 = JLT_FNMA(p[9], t7, t14); /* gamma3*1/(D/I1)*omega_tau*omega_tau*m*a3^2/I1 - m*g*a3/I1*1/(D/I1) */
    const double t16 = t6*t10; /* 1/s^2*omega_n */
    const double t17 = t9*t16; /* 1/s^2*s*1/s^2*omega_n */
    const double t18 = x[2]*t8; /* omega_tau*s */
    out[0] = t18;
    const double t19 = t8*t15; /* s*t15 */
    const double t20 = x[0]*t9; /* gamma3*1/s^2*s */
    const double t21 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t22 = p[11]*t17; /* 2*G_level/(R*I1)*1/s^2*s*1/s^2*omega_n */
    const double t23 = JLT_FMA(t12, t22, t15); /* gamma3*1/(D/I1)*2*G_level/(R*I1)*1/s^2*s*1/s^2*omega_n + t15 */
    const double t24 = JLT_FMA(t10, t16, t22); /* omega_n*1/s^2*omega_n + 2*G_level/(R*I1)*1/s^2*s*1/s^2*omega_n */
    const double t25 = p[13]*t12; /* 2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t26 = t18*t25; /* omega_tau*s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    out[14] = t26;
    const double t27 = x[3]*t6; /* omega3*1/s^2 */
    const double t28 = t10*t17; /* omega_n*1/s^2*s*1/s^2*omega_n */
    const double t29 = JLT_FNMA(t11, t18, t28); /* omega_n*1/s^2*s*1/s^2*omega_n - omega_tau*m*a3^2/I1*omega_tau*s */
    const double t30 = t7*t29; /* 1/(D/I1)*t29 */
    const double t31 = t7*t20; /* 1/(D/I1)*gamma3*1/s^2*s */
    const double t32 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t33 = t24*t32; /* t24*b */
    const double t34 = JLT_FMA(p[12], t27, t33); /* G_level/I1*omega3*1/s^2 + t24*b */
    const double t35 = t9*t27; /* 1/s^2*s*omega3*1/s^2 */
    const double t36 = JLT_FNMA(p[14], t16, t35); /* 1/s^2*s*omega3*1/s^2 - a3/R*1/s^2*omega_n */
    const double t37 = p[10]*t16; /* 1/R*1/s^2*omega_n */
    const double t38 = x[2]*t36; /* omega_tau*(1/s^2*s*omega3*1/s^2 - a3/R*1/s^2*omega_n) */
    const double t39 = -t37; /* -1/R*1/s^2*omega_n */
    out[17] = t39;
    const double t40 = t10*t10; /* omega_n*omega_n */
    const double t41 = JLT_FNMA(t31, t40, t19); /* s*t15 - 1/(D/I1)*gamma3*1/s^2*s*omega_n*omega_n */
    out[2] = t41;
    const double t42 = JLT_FMS(t25, t41, t30); /* 2*m*a3^2/I1*gamma3*1/(D/I1)*(s*t15 - 1/(D/I1)*gamma3*1/s^2*s*omega_n*omega_n) - 1/(D/I1)*t29 */
    const double t43 = JLT_FNMA(t20, t23, t42); /* t42 - gamma3*1/s^2*s*(gamma3*1/(D/I1)*2*G_level/(R*I1)*1/s^2*s*1/s^2*omega_n + t15) */
    out[12] = t43;
    const double t44 = t9*t40; /* 1/s^2*s*omega_n*omega_n */
    const double t45 = t32*t44; /* b*1/s^2*s*omega_n*omega_n */
    const double t46 = p[1]*t10; /* R*omega_n */
    out[11] = t46;
    const double t47 = JLT_FMA(x[3], t46, t45); /* omega3*R*omega_n + b*1/s^2*s*omega_n*omega_n */
    out[1] = t47;
    const double t48 = p[1]*t44; /* R*1/s^2*s*omega_n*omega_n */
    const double t49 = JLT_FMA(t20, t34, t48); /* gamma3*1/s^2*s*(G_level/I1*omega3*1/s^2 + t24*b) + R*1/s^2*s*omega_n*omega_n */
    out[8] = t49;
    const double t50 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t51 = t21*t37; /* e*1/R*1/s^2*omega_n */
    const double t52 = JLT_FMS(x[3], t20, t51); /* omega3*gamma3*1/s^2*s - e*1/R*1/s^2*omega_n */
    out[18] = t52;
    const double t53 = t37*t50; /* 1/R*1/s^2*omega_n*V */
    const double t54 = p[15]*t50; /* 2/R*V */
    const double t55 = t20*t54; /* gamma3*1/s^2*s*2/R*V */
    const double t56 = x[2]*t20; /* omega_tau*gamma3*1/s^2*s */
    out[19] = t56;
    const double t57 = JLT_FMS(x[3], t56, t53); /* omega3*omega_tau*gamma3*1/s^2*s - 1/R*1/s^2*omega_n*V */
    out[3] = t57;
    const double t58 = -t56; /* -omega_tau*gamma3*1/s^2*s */
    out[4] = t58;
    const double t59 = p[16]*t6; /* 1/2*G_level/(R*I1)*1/s^2 */
    const double t60 = JLT_FMA(t6, t59, t17); /* 1/s^2*1/2*G_level/(R*I1)*1/s^2 + 1/s^2*s*1/s^2*omega_n */
    const double t61 = JLT_FNMA(t55, t60, t38); /* omega_tau*(1/s^2*s*omega3*1/s^2 - a3/R*1/s^2*omega_n) - gamma3*1/s^2*s*2/R*V*(1/s^2*1/2*G_level/(R*I1)*1/s^2 + 1/s^2*s*1/s^2*omega_n) */
    out[16] = t61;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[18], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = p[17]*x[0]; /* 2*m*a3^2*gamma3 */
    const double t6 = x[2]*t5; /* omega_tau*2*m*a3^2*gamma3 */
    const double t7 = t3*t6; /* s*omega_tau*2*m*a3^2*gamma3 */
    const double t8 = t7/t4; /* s*omega_tau*2*m*a3^2*gamma3/D */
    out[0] = t8;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[19]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[8], t3, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t5 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t6 = t4*t5; /* D/I1*omega_tau*omega_tau */
    const double t7 = sqrt(t3); /* s = sqrt(s^2) */
    const double t8 = p[7]/t3; /* G_level/(R*I1)/s^2 */
    const double t9 = t7*t8; /* omega_n = s*G_level/(R*I1)/s^2 */
    const double t10 = JLT_FMA(t9, t9, t6); /* omega_n*omega_n + D/I1*omega_tau*omega_tau */
    const double t11 = JLT_FMA(p[20], t10, t0); /* 1/2*I1*(omega_n*omega_n + D/I1*omega_tau*omega_tau) + m*g*a3*gamma3 */
    out[2] = t11;
    const double t12 = x[1]*x[1]; /* v_nu*v_nu */
    const double t13 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t14 = t9*t13; /* omega_n*b */
    const double t15 = p[1]*x[3]; /* R*omega3 */
    const double t16 = JLT_FMA(t7, t15, t14); /* v_tau = s*R*omega3 + omega_n*b */
    const double t17 = JLT_FMA(t16, t16, t12); /* v_tau*v_tau + v_nu*v_nu */
    const double t18 = p[21]*t17; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[1] = t18;
    const double t19 = t11 + t18; /* energy = t11 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[0] = t19;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[9] = 0.0;
    out[11] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    out[5] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt(s^2) */
    const double t5 = 1.0/t3; /* 1/s^2 */
    const double t6 = JLT_FMA(p[18], t3, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t7 = x[2]*t6; /* omega_tau*D */
    out[2] = t7;
    out[10] = t7;
    const double t8 = t4*t5; /* s*1/s^2 */
    const double t9 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = p[7]*t8; /* omega_n = G_level/(R*I1)*s*1/s^2 */
    const double t11 = p[23]*t9; /* G_level/(R^2*I1)*b */
    const double t12 = JLT_FMS(t5, t11, x[3]); /* 1/s^2*G_level/(R^2*I1)*b - omega3 */
    const double t13 = p[22]*t5; /* G_level/R*1/s^2 */
    const double t14 = t9*t10; /* b*omega_n */
    const double t15 = t8*t13; /* s*1/s^2*G_level/R*1/s^2 */
    const double t16 = x[0]*t12; /* gamma3*(1/s^2*G_level/(R^2*I1)*b - omega3) */
    const double t17 = JLT_FMA(t8, t16, t10); /* d(v_tau)/d(gamma3)/R = s*1/s^2*gamma3*(1/s^2*G_level/(R^2*I1)*b - omega3) + omega_n */
    const double t18 = p[18]*x[2]; /* m*a3^2*omega_tau */
    const double t19 = x[2]*t18; /* omega_tau*m*a3^2*omega_tau */
    const double t20 = JLT_FNMA(t10, t15, t19); /* omega_tau*m*a3^2*omega_tau - omega_n*s*1/s^2*G_level/R*1/s^2 */
    const double t21 = JLT_FNMA(x[0], t20, p[19]); /* m*g*a3 - gamma3*(omega_tau*m*a3^2*omega_tau - omega_n*s*1/s^2*G_level/R*1/s^2) */
    out[8] = t21;
    const double t22 = p[1]*x[3]; /* R*omega3 */
    const double t23 = JLT_FMA(t4, t22, t14); /* v_tau = s*R*omega3 + b*omega_n */
    const double t24 = p[24]*t23; /* m*R*v_tau */
    const double t25 = t4*t24; /* s*m*R*v_tau */
    out[3] = t25;
    out[7] = t25;
    const double t26 = t17*t24; /* d(v_tau)/d(gamma3)/R*m*R*v_tau */
    out[4] = t26;
    const double t27 = t21 + t26; /* d(energy)/d(gamma3) = t21 + d(v_tau)/d(gamma3)/R*m*R*v_tau */
    out[0] = t27;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = p[18]*t0; /* m*a3^2*(1 - gamma3) */
    const double t3 = JLT_FMA(t1, t2, p[4]); /* (1 + gamma3)*m*a3^2*(1 - gamma3) + I1 */
    const double t4 = p[25]*t3; /* 1/(R*I1)*((1 + gamma3)*m*a3^2*(1 - gamma3) + I1) */
    out[0] = t4;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = p[7]/t3; /* G_level/(R*I1)/s */
    out[0] = t4;
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
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t11[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t12[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t13[k] = jlt_jet_product(t11, t12, k);
        t14[k] = jlt_jet_root(t13[k], t14, k);
        t15[k] = p[8]*t13[k] + (k == 0 ? 1.0 : 0);
        t16[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t14, t16, k);
        t17[k] = p[7]*t16[k];
        t18[k] = jlt_jet_product(t16, t17, k);
        t19[k] = jlt_jet_product(x2, t14, k);
        t20[k] = jlt_jet_product(t17, t18, k);
        t21[k] = x2[k]*p[8];
        t22[k] = jlt_jet_product(t19, t21, k) - t20[k];
        t23[k] = jlt_jet_product(x0, t22, k);
        t24[k] = t23[k] - p[9]*t14[k];
        t25[k] = jlt_jet_quotient(t24[k], t15, t25, k);
        t26[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t27[k] = jlt_jet_product(x2, t26, k) + x1[k];
        t28[k] = p[10]*t27[k];
        t29[k] = jlt_jet_product(x2, x0, k);
        t30[k] = jlt_jet_product(x3, t29, k);
        t31[k] = t30[k] - jlt_jet_product(t18, t28, k);
        t32[k] = jlt_jet_product(t16, t31, k);
        t33[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t34[k] = jlt_jet_product(t20, t33, k);
        t35[k] = p[1]*x3[k];
        t36[k] = jlt_jet_product(t17, t35, k) + t34[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t19[k]/(k + 1);
        next[1] = x1[k + 1] = t36[k]/(k + 1);
        next[2] = x2[k + 1] = t25[k]/(k + 1);
        next[3] = x3[k + 1] = t32[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = (0.0);
    const double complex v_omega3 = x[3];
    const double v_a3 = params[3];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "E1", "I3 = 0" },
    { "E2", "I3 = 0" },
};

static const jlt_named measures[] = {
    { "rho", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_rod_on_level_omega_n = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "",
    .elimination = "level_omega_n",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .prepared_count = 27,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 2, 18, 8, 1, 1, 0, 13, 9 }, { 9, 33, 0, 7, 1, 0, 9, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of d(omega_tau)/dt, a part of d(omega_tau)/dt, e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega3*omega_tau*gamma3 - ((1)/s^2*D/I1)*D/I1*s*omega_n*(1/R)*V, b = gamma3*R + a3, d(v_nu)/dt" },
    .jacobian = { jacobian, 16, { 5, 34, 16, 1, 1, 0, 17, 13 }, { 24, 133, 0, 25, 1, 0, 16, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in s*(2*m*a3^2/I1)*gamma3*1/(D/I1) - gamma3*1/s^2*s, gamma3*(s*(2*m*a3^2/I1)*gamma3*1/(D/I1) - gamma3*1/s^2*s) + s, a part of d(d(omega_tau)/dt)/d(gamma3), 1/s^2*s*omega3*1/s^2 - (a3/R)*1/s^2*omega_n, e = gamma3*a3 + R, d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, d(d(omega3)/dt)/d(omega_tau), d(d(omega3)/dt)/d(gamma3), b = gamma3*R + a3, d(d(v_nu)/dt)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 4, 37, 19, 1, 1, 0, 15, 17 }, { 28, 156, 0, 31, 1, 0, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*1/(D/I1)*omega_tau*omega_tau*(m*a3^2/I1) - (m*g*a3/I1)*1/(D/I1), e = gamma3*a3 + R, a part of d(d(omega_tau)/dt)/d(gamma3), omega_n*1/s^2*s*1/s^2*omega_n - omega_tau*(m*a3^2/I1)*omega_tau*s, b = gamma3*R + a3, a part of d(d(v_nu)/dt)/d(gamma3), 1/s^2*s*omega3*1/s^2 - (a3/R)*1/s^2*omega_n, d(omega_tau)/dt, d(d(omega_tau)/dt)/d(gamma3), d(v_nu)/dt, d(d(v_nu)/dt)/d(gamma3), V = omega_tau*e + v_nu, d(d(omega3)/dt)/d(omega_tau), d(omega3)/dt, d(d(omega3)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 2, 4, 1, 1, 1, 0, 5, 4 }, { 2, 11, 0, 1, 1, 0, 7, 4 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_values = { integral_values, 3, { 3, 9, 6, 1, 1, 0, 9, 6 }, { 11, 41, 0, 1, 1, 0, 11, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in E2, b = gamma3*R + a3, v_tau = s*R*omega3 + omega_n*b, E" },
    .integral_gradients = { integral_gradients, 12, { 3, 16, 7, 1, 1, 0, 10, 7 }, { 11, 58, 0, 5, 1, 0, 11, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, ((1)/s^2)*(G_level/(R^2*I1))*b - omega3, d(v_tau)/d(gamma3)/R = s*((1)/s^2)*gamma3*(((1)/s^2)*(G_level/(R^2*I1))*b - omega3) + omega_n, omega_tau*(m*a3^2)*omega_tau - omega_n*s*((1)/s^2)*(G_level/R)*((1)/s^2), d(E2)/d(gamma3), v_tau = s*R*omega3 + b*omega_n, d(E)/d(gamma3)" },
    .measure_values = { measure_values, 1, { 2, 2, 1, 0, 0, 0, 4, 3 }, { 2, 6, 0, 1, 1, 0, 7, 4 },
        "" },
    .measure_divergences = { measure_divergences, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 4, 25, 0, 2, 1, 0, 10, 6 },
        "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 1, 0, 1, 1, 0, 4, 3 }, { 1, 3, 0, 1, 1, 0, 5, 3 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .eliminated_state = 3, .level_integral = 1,
    .integral_count = 3, .measure_count = 1, .equilibria_count = 0,
    .integrals = integrals,
    .measures = measures,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_on_level_omega_n,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_rod_on_level_omega_n) },
#endif
};
