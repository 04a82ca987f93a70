/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   18    8    1    1    0     12    8   (50)
 *  jacobian            5   36   13    1    1    0     15   13   (170)
 *  rhs_jacobian        6   39   15    1    1    0     14   15   (206)
 *  divergence          2    4    2    1    1    0      6    4   (18)
 *  integral_values     3   10    6    0    1    0      7    5   (54)
 *  integral_gradients  4   17    5    1    1    0      7    6   (64)
 *  measure_values      2    2    1    0    1    0      4    3   (9)
 *  measure_divergences 0    0    0    0    0    0      0    0   (41)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in m*g*a3/I1 - omega_tau*(m*a3^2/I1)*omega_tau*gamma3,
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), e = gamma3*a3 + R, V = omega_tau*e + v_nu,
 *      b = gamma3*R + a3, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3),
 *      gamma3*1/s^2*V + omega_tau*(1/2*a3), d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(omega_tau),
 *      d(d(v_nu)/dt)/d(omega_n), omega_n*1/s^2*s*b + R*omega3, gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R,
 *      d(omega3)/dt
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
extern const jlt_descriptor jlt_kernels_spherical_top_rod;
extern const struct jlt_ball_table jlt_balls_spherical_top_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[3]*params[3]; /* a3*a3 */
    const double t1 = params[0]*t0; /* m*a3*a3 */
    out[14] = t1;
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    out[6] = t2;
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[3]*t3; /* a3*m*g */
    out[16] = t4;
    const double t5 = t4/params[4]; /* a3*m*g/I1 */
    out[7] = t5;
    const double t6 = 1.0/params[1]; /* 1/R */
    out[8] = t6;
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t0*t7; /* a3*a3*m*2 */
    out[15] = t8;
    const double t9 = t8/params[4]; /* a3*a3*m*2/I1 */
    out[9] = t9;
    const double t10 = 2.0/params[1]; /* 2/R */
    out[10] = t10;
    const double t11 = params[3]/params[1]; /* a3/R */
    out[11] = t11;
    const double t12 = (-1.0)/params[1]; /* (-1)/R */
    out[12] = t12;
    const double t13 = params[3]/2.0; /* a3/2 */
    out[13] = t13;
    const double t14 = params[4]/2.0; /* I1/2 */
    out[17] = t14;
    const double t15 = params[0]/2.0; /* m/2 */
    out[18] = t15;
    const double t16 = params[4]*params[1]; /* I1*R */
    out[19] = t16;
    const double t17 = params[0]*params[1]; /* m*R */
    out[20] = t17;
    const double t18 = -t16; /* -I1*R */
    out[21] = t18;
    const double t19 = params[0]*(-2.0); /* m*(-2) */
    const double t20 = t0*t19; /* a3*a3*m*(-2) */
    out[22] = t20;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t4 = t2*t3; /* s^2*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s^2*D/I1) */
    const double t6 = sqrt(t2); /* s = sqrt(s^2) */
    const double t7 = t3*t6; /* D/I1*s */
    const double t8 = t5*t7; /* 1/(s^2*D/I1)*D/I1*s */
    const double t9 = t2*t5; /* s^2*1/(s^2*D/I1) */
    const double t10 = x[3]*t8; /* omega_n*1/(s^2*D/I1)*D/I1*s */
    const double t11 = x[2]*t6; /* omega_tau*s */
    out[0] = t11;
    const double t12 = x[3]*t10; /* omega_n*omega_n*1/(s^2*D/I1)*D/I1*s */
    const double t13 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t14 = JLT_FMS(t11, t13, t12); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n*1/(s^2*D/I1)*D/I1*s */
    const double t15 = x[0]*t14; /* gamma3*t14 */
    const double t16 = JLT_FNMA(p[7], t6, t15); /* gamma3*t14 - m*g*a3/I1*s */
    const double t17 = t9*t16; /* s^2*1/(s^2*D/I1)*(gamma3*t14 - m*g*a3/I1*s) */
    out[2] = t17;
    const double t18 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t19 = JLT_FMA(x[2], t18, x[1]); /* V = omega_tau*e + v_nu */
    const double t20 = p[8]*t19; /* 1/R*V */
    const double t21 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t22 = t10*t21; /* omega_n*1/(s^2*D/I1)*D/I1*s*omega_tau*gamma3 */
    out[3] = t22;
    const double t23 = x[4]*t21; /* omega3*omega_tau*gamma3 */
    const double t24 = JLT_FNMA(t10, t20, t23); /* omega3*omega_tau*gamma3 - omega_n*1/(s^2*D/I1)*D/I1*s*1/R*V */
    const double t25 = t8*t24; /* 1/(s^2*D/I1)*D/I1*s*(omega3*omega_tau*gamma3 - omega_n*1/(s^2*D/I1)*D/I1*s*1/R*V) */
    out[4] = t25;
    const double t26 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t27 = t12*t26; /* omega_n*omega_n*1/(s^2*D/I1)*D/I1*s*b */
    const double t28 = p[1]*x[3]; /* R*omega_n */
    const double t29 = JLT_FMA(x[4], t28, t27); /* omega3*R*omega_n + omega_n*omega_n*1/(s^2*D/I1)*D/I1*s*b */
    out[1] = t29;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = JLT_FMA(t2, p[6], 1.0); /* D/I1 = s^2*m*a3^2/I1 + 1 */
    const double t5 = t2*t4; /* s^2*D/I1 */
    const double t6 = 1.0/t5; /* 1/(s^2*D/I1) */
    const double t7 = t4*t6; /* 1/s^2 = D/I1*1/(s^2*D/I1) */
    const double t8 = t3*t7; /* s*1/s^2 */
    const double t9 = x[0]*t8; /* gamma3*s*1/s^2 */
    const double t10 = x[2]*t9; /* omega_tau*gamma3*s*1/s^2 */
    out[18] = t10;
    out[24] = t10;
    const double t11 = -t10; /* -omega_tau*gamma3*s*1/s^2 */
    out[0] = t11;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[14] = 0.0;
    out[16] = 0.0;
    out[19] = 0.0;
    const double t12 = t8*x[3]; /* s*1/s^2*omega_n */
    const double t13 = t8*t12; /* s*1/s^2*s*1/s^2*omega_n */
    const double t14 = x[0]*t13; /* gamma3*s*1/s^2*s*1/s^2*omega_n */
    const double t15 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t16 = t12*t15; /* s*1/s^2*omega_n*b */
    const double t17 = t14*t16; /* gamma3*s*1/s^2*s*1/s^2*omega_n*s*1/s^2*omega_n*b */
    const double t18 = x[3]*p[1]; /* omega_n*R */
    out[9] = t18;
    const double t19 = JLT_FMA(t12, t18, t17); /* s*1/s^2*omega_n*omega_n*R + gamma3*s*1/s^2*s*1/s^2*omega_n*s*1/s^2*omega_n*b */
    out[5] = t19;
    const double t20 = p[1]*x[4]; /* R*omega3 */
    const double t21 = JLT_FMA(t16, 2.0, t20); /* s*1/s^2*omega_n*b*2 + R*omega3 */
    out[8] = t21;
    const double t22 = t2*t6; /* 1/(D/I1) = s^2*1/(s^2*D/I1) */
    const double t23 = x[0]*p[9]; /* gamma3*2*m*a3^2/I1 */
    const double t24 = t22*t23; /* 1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t25 = t3*t24; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t26 = t25 - t9; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*s*1/s^2 */
    const double t27 = JLT_FMA(x[0], t26, t3); /* gamma3*(s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*s*1/s^2) + s */
    const double t28 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t29 = x[2]*t28; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t30 = t27*t29; /* (gamma3*(s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*s*1/s^2) + s)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t31 = x[0]*t12; /* gamma3*s*1/s^2*omega_n */
    out[17] = t31;
    const double t32 = x[3]*t24; /* omega_n*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t33 = JLT_FNMA(t12, t13, t30); /* t30 - s*1/s^2*omega_n*s*1/s^2*s*1/s^2*omega_n */
    const double t34 = JLT_FNMA(t31, t32, t33); /* t30 - s*1/s^2*omega_n*s*1/s^2*s*1/s^2*omega_n - gamma3*s*1/s^2*omega_n*omega_n*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t35 = JLT_FNMA(t26, p[7], t34); /* t34 - (s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*s*1/s^2)*m*g*a3/I1 */
    const double t36 = t22*t35; /* 1/(D/I1)*t35 */
    out[10] = t36;
    const double t37 = x[2]*t25; /* omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[12] = t37;
    const double t38 = t22*(-2.0); /* 1/(D/I1)*(-2) */
    const double t39 = t31*t38; /* gamma3*s*1/s^2*omega_n*1/(D/I1)*(-2) */
    out[13] = t39;
    const double t40 = x[2]*t8; /* omega_tau*s*1/s^2 */
    const double t41 = t13*t40; /* s*1/s^2*s*1/s^2*omega_n*omega_tau*s*1/s^2 */
    out[15] = t41;
    const double t42 = x[4]*t40; /* omega3*omega_tau*s*1/s^2 */
    const double t43 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t44 = JLT_FMA(x[2], t43, x[1]); /* V = omega_tau*e + v_nu */
    const double t45 = p[10]*t44; /* 2/R*V */
    const double t46 = JLT_FNMA(t14, t45, t42); /* omega3*omega_tau*s*1/s^2 - gamma3*s*1/s^2*s*1/s^2*omega_n*2/R*V */
    const double t47 = t7*t46; /* 1/s^2*t46 */
    const double t48 = x[2]*p[11]; /* omega_tau*a3/R */
    const double t49 = JLT_FNMA(t13, t48, t47); /* 1/s^2*t46 - s*1/s^2*s*1/s^2*omega_n*omega_tau*a3/R */
    out[20] = t49;
    const double t50 = t13*p[8]; /* s*1/s^2*s*1/s^2*omega_n*1/R */
    const double t51 = -t50; /* -s*1/s^2*s*1/s^2*omega_n*1/R */
    out[21] = t51;
    const double t52 = t43*t50; /* e*s*1/s^2*s*1/s^2*omega_n*1/R */
    const double t53 = JLT_FMS(t9, x[4], t52); /* gamma3*s*1/s^2*omega3 - e*s*1/s^2*s*1/s^2*omega_n*1/R */
    out[22] = t53;
    const double t54 = t44*p[12]; /* V*(-1/R) */
    const double t55 = t7*t54; /* 1/s^2*V*(-1/R) */
    out[23] = t55;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[19] = 0.0;
    out[21] = 0.0;
    out[24] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t4 = t2*t3; /* s^2*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s^2*D/I1) */
    const double t6 = t3*t5; /* 1/s^2 = D/I1*1/(s^2*D/I1) */
    const double t7 = t2*t5; /* 1/(D/I1) = s^2*1/(s^2*D/I1) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[7] = t8;
    const double t9 = t6*t8; /* 1/s^2*s */
    const double t10 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t11 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t12 = JLT_FNMA(t10, t11, p[7]); /* m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3 */
    const double t13 = t7*t12; /* 1/(D/I1)*(m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3) */
    const double t14 = x[0]*t9; /* gamma3*1/s^2*s */
    const double t15 = x[2]*t8; /* omega_tau*s */
    out[0] = t15;
    const double t16 = t8*t13; /* s*1/(D/I1)*(m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3) */
    const double t17 = t10*t15; /* omega_tau*m*a3^2/I1*omega_tau*s */
    const double t18 = x[3]*t9; /* omega_n*1/s^2*s */
    const double t19 = x[3]*t14; /* omega_n*gamma3*1/s^2*s */
    out[22] = t19;
    const double t20 = t7*t19; /* 1/(D/I1)*omega_n*gamma3*1/s^2*s */
    const double t21 = JLT_FMA(x[3], t20, t16); /* omega_n*1/(D/I1)*omega_n*gamma3*1/s^2*s + t16 */
    const double t22 = (-2.0)*t20; /* (-2)*1/(D/I1)*omega_n*gamma3*1/s^2*s */
    out[18] = t22;
    const double t23 = -t21; /* -(omega_n*1/(D/I1)*omega_n*gamma3*1/s^2*s + t16) */
    out[2] = t23;
    const double t24 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t25 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t26 = t9*t18; /* 1/s^2*s*omega_n*1/s^2*s */
    const double t27 = JLT_FNMA(t18, t26, t17); /* omega_tau*m*a3^2/I1*omega_tau*s - omega_n*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    const double t28 = x[2]*t9; /* omega_tau*1/s^2*s */
    const double t29 = t26*t28; /* 1/s^2*s*omega_n*1/s^2*s*omega_tau*1/s^2*s */
    out[20] = t29;
    const double t30 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t31 = t18*t30; /* omega_n*1/s^2*s*b */
    const double t32 = x[0]*p[9]; /* gamma3*2*m*a3^2/I1 */
    const double t33 = JLT_FNMA(t21, t32, t27); /* t27 - (omega_n*1/(D/I1)*omega_n*gamma3*1/s^2*s + t16)*gamma3*2*m*a3^2/I1 */
    const double t34 = t15*t32; /* omega_tau*s*gamma3*2*m*a3^2/I1 */
    const double t35 = t7*t34; /* 1/(D/I1)*omega_tau*s*gamma3*2*m*a3^2/I1 */
    out[17] = t35;
    const double t36 = t7*t33; /* 1/(D/I1)*t33 */
    const double t37 = JLT_FMA(t13, t14, t36); /* 1/(D/I1)*(m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3)*gamma3*1/s^2*s + 1/(D/I1)*t33 */
    out[15] = t37;
    const double t38 = x[2]*p[13]; /* omega_tau*1/2*a3 */
    const double t39 = t6*t25; /* 1/s^2*V */
    const double t40 = x[4]*t6; /* omega3*1/s^2 */
    const double t41 = t28*t40; /* omega_tau*1/s^2*s*omega3*1/s^2 */
    const double t42 = JLT_FMA(x[0], t39, t38); /* gamma3*1/s^2*V + omega_tau*1/2*a3 */
    const double t43 = p[12]*t39; /* (-1/R)*1/s^2*V */
    out[28] = t43;
    const double t44 = p[10]*t42; /* 2/R*(gamma3*1/s^2*V + omega_tau*1/2*a3) */
    const double t45 = JLT_FNMA(t26, t44, t41); /* omega_tau*1/s^2*s*omega3*1/s^2 - 1/s^2*s*omega_n*1/s^2*s*2/R*(gamma3*1/s^2*V + omega_tau*1/2*a3) */
    out[25] = t45;
    const double t46 = p[8]*t26; /* 1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t47 = t25*t46; /* V*1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t48 = t24*t46; /* e*1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t49 = -t46; /* -1/R*1/s^2*s*omega_n*1/s^2*s */
    out[26] = t49;
    const double t50 = JLT_FMS(x[4], t14, t48); /* omega3*gamma3*1/s^2*s - e*1/R*1/s^2*s*omega_n*1/s^2*s */
    out[27] = t50;
    const double t51 = p[1]*x[4]; /* R*omega3 */
    const double t52 = JLT_FMA(2.0, t31, t51); /* 2*omega_n*1/s^2*s*b + R*omega3 */
    out[13] = t52;
    const double t53 = t31 + t51; /* omega_n*1/s^2*s*b + R*omega3 */
    const double t54 = x[3]*t53; /* omega_n*(omega_n*1/s^2*s*b + R*omega3) */
    out[1] = t54;
    const double t55 = x[3]*p[1]; /* omega_n*R */
    out[14] = t55;
    const double t56 = JLT_FMA(t14, t31, t55); /* gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R */
    const double t57 = t18*t56; /* omega_n*1/s^2*s*(gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R) */
    out[10] = t57;
    const double t58 = x[2]*t14; /* omega_tau*gamma3*1/s^2*s */
    out[23] = t58;
    out[29] = t58;
    const double t59 = JLT_FMS(x[4], t58, t47); /* omega3*omega_tau*gamma3*1/s^2*s - V*1/R*1/s^2*s*omega_n*1/s^2*s */
    out[4] = t59;
    const double t60 = x[3]*t58; /* omega_n*omega_tau*gamma3*1/s^2*s */
    out[3] = t60;
    const double t61 = -t58; /* -omega_tau*gamma3*1/s^2*s */
    out[5] = t61;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[14], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*D */
    const double t6 = JLT_FMA(t2, p[15], t4); /* (1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D */
    const double t7 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t8 = t6*t7; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D)*gamma3*omega_tau */
    const double t9 = t8/t5; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D)*gamma3*omega_tau/(s*D) */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = x[3]*t3; /* omega_n*b */
    const double t5 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(gamma3 + 1) + 1 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t8 = t5*t7; /* D/I1*omega_tau*omega_tau */
    const double t9 = JLT_FMA(x[3], x[3], t8); /* omega_n*omega_n + D/I1*omega_tau*omega_tau */
    const double t10 = p[1]*x[4]; /* R*omega3 */
    const double t11 = JLT_FMA(t6, t10, t4); /* v_tau = s*R*omega3 + omega_n*b */
    const double t12 = x[1]*x[1]; /* v_nu*v_nu */
    const double t13 = JLT_FMA(t11, t11, t12); /* v_tau*v_tau + v_nu*v_nu */
    const double t14 = p[18]*t13; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[2] = t14;
    const double t15 = p[16]*x[0]; /* m*g*a3*gamma3 */
    const double t16 = JLT_FMA(p[17], t9, t15); /* 1/2*I1*(omega_n*omega_n + D/I1*omega_tau*omega_tau) + m*g*a3*gamma3 */
    out[3] = t16;
    const double t17 = t14 + t16; /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t16 */
    out[0] = t17;
    const double t18 = x[3]*p[19]; /* omega_n*R*I1 */
    const double t19 = t6*t18; /* s*omega_n*R*I1 */
    out[1] = t19;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[19] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    out[11] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = sqrt(t3); /* s = sqrt(s^2) */
    const double t6 = p[19]*t5; /* R*I1*s */
    out[8] = t6;
    const double t7 = x[0]/t3; /* gamma3/s^2 */
    const double t8 = t5*t7; /* s*gamma3/s^2 */
    const double t9 = JLT_FMA(p[14], t3, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t10 = x[2]*t9; /* omega_tau*D */
    out[2] = t10;
    out[17] = t10;
    const double t11 = x[3]*t4; /* omega_n*b */
    const double t12 = p[0]*t4; /* m*b */
    const double t13 = x[4]*p[1]; /* omega3*R */
    const double t14 = JLT_FMA(t5, t13, t11); /* v_tau = s*omega3*R + omega_n*b */
    const double t15 = t12*t14; /* m*b*v_tau */
    out[13] = t15;
    const double t16 = p[20]*t14; /* m*R*v_tau */
    const double t17 = t5*t16; /* s*m*R*v_tau */
    out[4] = t17;
    out[14] = t17;
    const double t18 = p[14]*x[0]; /* m*a3^2*gamma3 */
    const double t19 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t20 = JLT_FNMA(t18, t19, p[16]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    out[15] = t20;
    const double t21 = JLT_FNMA(x[4], t8, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*s*gamma3/s^2 */
    const double t22 = t16*t21; /* m*R*v_tau*d(v_tau)/d(gamma3)/R */
    out[10] = t22;
    const double t23 = t20 + t22; /* d(energy)/d(gamma3) = m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau + m*R*v_tau*d(v_tau)/d(gamma3)/R */
    out[0] = t23;
    const double t24 = x[3]*p[4]; /* omega_n*I1 */
    out[18] = t24;
    const double t25 = t15 + t24; /* d(energy)/d(omega_n) = m*b*v_tau + omega_n*I1 */
    out[3] = t25;
    const double t26 = x[3]*p[21]; /* omega_n*(-R*I1) */
    const double t27 = t8*t26; /* s*gamma3/s^2*omega_n*(-R*I1) */
    out[5] = t27;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(t2, p[14], p[4]); /* (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*((1 - gamma3)*(1 + gamma3)*m*a3^2 + I1) */
    out[0] = t5;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
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
    coefficients[4] = x4[0] = x[4];
    for (unsigned k = 0; k < order; k++) {
        t11[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t12[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t13[k] = jlt_jet_product(t11, t12, k);
        t14[k] = jlt_jet_root(t13[k], t14, k);
        t15[k] = p[6]*t13[k] + (k == 0 ? 1.0 : 0);
        t16[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t14, t16, k);
        t17[k] = jlt_jet_product(x3, t16, k);
        t18[k] = jlt_jet_product(x2, t14, k);
        t19[k] = jlt_jet_product(x3, t17, k);
        t20[k] = x2[k]*p[6];
        t21[k] = jlt_jet_product(t18, t20, k) - t19[k];
        t22[k] = jlt_jet_product(x0, t21, k);
        t23[k] = t22[k] - p[7]*t14[k];
        t24[k] = jlt_jet_quotient(t23[k], t15, t24, k);
        t25[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t26[k] = jlt_jet_product(x2, t25, k) + x1[k];
        t27[k] = p[8]*t26[k];
        t28[k] = jlt_jet_product(x2, x0, k);
        t29[k] = jlt_jet_product(t17, t28, k);
        t30[k] = jlt_jet_product(x4, t28, k);
        t31[k] = t30[k] - jlt_jet_product(t17, t27, k);
        t32[k] = jlt_jet_product(t16, t31, k);
        t33[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t34[k] = jlt_jet_product(t19, t33, k);
        t35[k] = p[1]*x3[k];
        t36[k] = jlt_jet_product(x4, t35, k) + t34[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t18[k]/(k + 1);
        next[1] = x1[k + 1] = t36[k]/(k + 1);
        next[2] = x2[k + 1] = t24[k]/(k + 1);
        next[3] = x3[k + 1] = t29[k]/(k + 1);
        next[4] = x4[k + 1] = t32[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double complex v_omega_n = x[3];
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega3 = x[4];
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = (0.0);
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta);
    out[4] = (-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "G", "" },
    { "E1", "I3 = 0" },
    { "E2", "I3 = 0" },
};

static const jlt_named measures[] = {
    { "rho", "I3 = 0" },
};

static const signed char signs_7[] = { 1, -1, -1, 1, 1 };
static const jlt_reversor reversors[] = {
    { signs_7, 7 },
};

const jlt_descriptor jlt_kernels_spherical_top_rod = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .scales = 1,
    .state_count = 5, .param_count = 6, .prepared_count = 23,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 18, 8, 1, 1, 0, 12, 8 }, { 9, 33, 0, 7, 1, 0, 9, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of d(omega_tau)/dt, a part of d(omega_tau)/dt, e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega3*omega_tau*gamma3 - omega_n*((1)/s^2*D/I1)*D/I1*s*(1/R)*V, b = gamma3*R + a3, d(v_nu)/dt" },
    .jacobian = { jacobian, 25, { 5, 36, 13, 1, 1, 0, 15, 13 }, { 23, 119, 0, 27, 1, 0, 15, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega_n), s*1/(D/I1)*gamma3*(2*m*a3^2/I1) - gamma3*s*1/s^2, gamma3*(s*1/(D/I1)*gamma3*(2*m*a3^2/I1) - gamma3*s*1/s^2) + s, a part of d(d(omega_tau)/dt)/d(gamma3), e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega3*omega_tau*s*1/s^2 - gamma3*s*1/s^2*s*1/s^2*omega_n*(2/R)*V, d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(omega_tau)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 6, 39, 15, 1, 1, 0, 14, 15 }, { 27, 144, 0, 34, 1, 0, 15, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in m*g*a3/I1 - omega_tau*(m*a3^2/I1)*omega_tau*gamma3, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), e = gamma3*a3 + R, V = omega_tau*e + v_nu, b = gamma3*R + a3, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), gamma3*1/s^2*V + omega_tau*(1/2*a3), d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(omega_tau), d(d(v_nu)/dt)/d(omega_n), omega_n*1/s^2*s*b + R*omega3, gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R, d(omega3)/dt" },
    .divergence = { divergence, 1, { 2, 4, 2, 1, 1, 0, 6, 4 }, { 3, 12, 0, 2, 1, 0, 9, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_values = { integral_values, 4, { 3, 10, 6, 0, 1, 0, 7, 5 }, { 11, 42, 0, 0, 1, 0, 11, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*R*omega3 + omega_n*b, E2, E" },
    .integral_gradients = { integral_gradients, 20, { 4, 17, 5, 1, 1, 0, 7, 6 }, { 10, 51, 0, 2, 1, 0, 8, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*omega3*R + omega_n*b, d(E2)/d(gamma3), d(v_tau)/d(gamma3)/R = omega_n - omega3*s*(gamma3/s^2), d(E)/d(gamma3), d(E)/d(omega_n)" },
    .measure_values = { measure_values, 1, { 2, 2, 1, 0, 1, 0, 4, 3 }, { 2, 6, 0, 0, 1, 0, 7, 4 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .measure_divergences = { measure_divergences, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 7, 30, 0, 3, 1, 0, 11, 7 },
        "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 4, .measure_count = 1, .equilibria_count = 0,
    .integrals = integrals,
    .measures = measures,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_rod) },
#endif
};
