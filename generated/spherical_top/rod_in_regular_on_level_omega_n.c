/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_omega_n: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   18    8    1    0    0      9    7   (50)
 *  jacobian            5   33    9    1    0    0     12   10   (146)
 *  rhs_jacobian        6   34   13    1    0    0     16   11   (182)
 *  divergence          0    4    1    1    0    0      4    3   (13)
 *  integral_values     1    8    6    1    0    0      6    5   (51)
 *  integral_gradients  4   16    4    1    0    0      7    6   (67)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    0    0    1    0    0      1    1   (3)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in s*omega_tau*(m*a3^2/I1)*s*omega_tau - (G_level^2/(R^2*I1^2))*1/s*1/s,
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s),
 *      e = a3*gamma3 + R, a part of d(d(omega_tau)/dtau)/d(s), b = R*gamma3 + a3, d(v_nu)/dtau, V = omega_tau*e + v_nu,
 *      omega3 - (a3*G_level/(R^2*I1))*1/s*1/s, d(d(omega3)/dtau)/d(omega_tau), d(omega3)/dtau,
 *      d(d(omega_tau)/dtau)/d(s)
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
extern const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular_on_level_omega_n;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega_n;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_on_level_omega_n_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_on_level_omega_n_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_on_level_omega_n_avx512;

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
    out[24] = t3;
    const double t4 = t3/params[4]; /* m*a3*a3/I1 */
    out[8] = t4;
    const double t5 = params[0]*params[2]; /* m*g */
    const double t6 = params[3]*t5; /* a3*m*g */
    out[27] = t6;
    const double t7 = t6/params[4]; /* a3*m*g/I1 */
    out[9] = t7;
    const double t8 = 1.0/params[1]; /* 1/R */
    out[10] = t8;
    const double t9 = params[4]*params[4]; /* I1*I1 */
    const double t10 = params[1]*t9; /* R*I1*I1 */
    const double t11 = params[6]*params[6]; /* G_level*G_level */
    const double t12 = (-2.0)*t11; /* (-2)*G_level*G_level */
    const double t13 = t12/t10; /* (-2)*G_level*G_level/(R*I1*I1) */
    out[11] = t13;
    const double t14 = params[3]/params[1]; /* a3/R */
    out[12] = t14;
    const double t15 = params[0]*2.0; /* m*2 */
    const double t16 = t2*t15; /* a3*a3*m*2 */
    out[23] = t16;
    const double t17 = t16/params[4]; /* a3*a3*m*2/I1 */
    out[13] = t17;
    const double t18 = params[6]*2.0; /* G_level*2 */
    const double t19 = t18/t0; /* G_level*2/(R*I1) */
    out[14] = t19;
    const double t20 = params[2]*t15; /* g*m*2 */
    const double t21 = params[3]*t20; /* a3*g*m*2 */
    const double t22 = t21/params[4]; /* a3*g*m*2/I1 */
    out[15] = t22;
    const double t23 = params[1]*params[1]; /* R*R */
    const double t24 = params[4]*t23; /* I1*R*R */
    const double t25 = t18/t24; /* G_level*2/(I1*R*R) */
    out[16] = t25;
    const double t26 = t9*t23; /* I1*I1*R*R */
    const double t27 = t11/t26; /* G_level*G_level/(I1*I1*R*R) */
    out[17] = t27;
    const double t28 = params[6]/params[4]; /* G_level/I1 */
    out[18] = t28;
    const double t29 = params[6]/t24; /* G_level/(I1*R*R) */
    out[19] = t29;
    const double t30 = t11/t10; /* G_level*G_level/(R*I1*I1) */
    out[20] = t30;
    const double t31 = t11*2.0; /* G_level*G_level*2 */
    const double t32 = t31/t26; /* G_level*G_level*2/(I1*I1*R*R) */
    out[21] = t32;
    const double t33 = params[6]*params[3]; /* G_level*a3 */
    const double t34 = t33/t24; /* G_level*a3/(I1*R*R) */
    out[22] = t34;
    const double t35 = params[4]/2.0; /* I1/2 */
    out[25] = t35;
    const double t36 = params[0]/2.0; /* m/2 */
    out[26] = t36;
    const double t37 = params[1]*params[0]; /* R*m */
    out[28] = t37;
    const double t38 = params[6]/params[1]; /* G_level/R */
    out[29] = t38;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[8], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t2 = x[4]*t1; /* s*D/I1 */
    const double t3 = 1.0/t2; /* 1/(s*D/I1) */
    const double t4 = t1*t3; /* 1/s = D/I1*1/(s*D/I1) */
    const double t5 = x[4]*t3; /* s*1/(s*D/I1) */
    const double t6 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t7 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t8 = JLT_FMA(x[2], t7, x[1]); /* V = omega_tau*e + v_nu */
    const double t9 = p[10]*t8; /* 1/R*V */
    const double t10 = t4*t9; /* 1/s*1/R*V */
    const double t11 = p[7]*t4; /* omega_n = G_level/(R*I1)*1/s */
    const double t12 = t10*t11; /* 1/s*1/R*V*omega_n */
    const double t13 = JLT_FMS(x[3], t6, t12); /* omega3*omega_tau*gamma3 - 1/s*1/R*V*omega_n */
    out[3] = t13;
    const double t14 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t14;
    const double t15 = p[8]*t6; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t16 = t14*t15; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t17 = JLT_FNMA(p[9], t0, t16); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s*s */
    const double t18 = x[4]*t6; /* s*omega_tau*gamma3 */
    const double t19 = -t18; /* -s*omega_tau*gamma3 */
    out[4] = t19;
    const double t20 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t21 = t11*t11; /* omega_n*omega_n */
    const double t22 = t20*t21; /* b*omega_n*omega_n */
    const double t23 = JLT_FNMA(x[0], t21, t17); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s*s - gamma3*omega_n*omega_n */
    const double t24 = t5*t23; /* s*1/(s*D/I1)*t23 */
    out[2] = t24;
    const double t25 = x[4]*p[1]; /* s*R */
    const double t26 = x[3]*t25; /* omega3*s*R */
    const double t27 = JLT_FMA(t11, t26, t22); /* omega_n*omega3*s*R + b*omega_n*omega_n */
    out[1] = t27;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[13] = 0.0;
    out[21] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[2] = t0;
    const double t1 = JLT_FMA(p[8], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t2 = x[4]*t1; /* s*D/I1 */
    const double t3 = 1.0/t2; /* 1/(s*D/I1) */
    const double t4 = t1*t3; /* 1/s = D/I1*1/(s*D/I1) */
    const double t5 = x[4]*t3; /* 1/(D/I1) = s*1/(s*D/I1) */
    const double t6 = p[7]*t4; /* omega_n = G_level/(R*I1)*1/s */
    const double t7 = t6*t6; /* omega_n*omega_n */
    const double t8 = p[1]*t7; /* R*omega_n*omega_n */
    out[5] = t8;
    const double t9 = t4*t4; /* 1/s*1/s */
    const double t10 = x[4]*t5; /* s*1/(D/I1) */
    const double t11 = p[14]*t6; /* 2*G_level/(R*I1)*omega_n */
    const double t12 = t9*t11; /* 1/s*1/s*2*G_level/(R*I1)*omega_n */
    const double t13 = t4*t9; /* 1/s*1/s*1/s */
    const double t14 = t4*t6; /* 1/s*omega_n */
    const double t15 = p[13]*t10; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t16 = JLT_FMA(x[2], x[2], t7); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t17 = JLT_FMA(t15, t16, t12); /* 2*m*a3^2/I1*s*1/(D/I1)*(omega_tau*omega_tau + omega_n*omega_n) + 1/s*1/s*2*G_level/(R*I1)*omega_n */
    const double t18 = x[0]*t17; /* gamma3*t17 */
    const double t19 = JLT_FNMA(p[15], t10, t18); /* gamma3*t17 - 2*m*g*a3/I1*s*1/(D/I1) */
    const double t20 = t5*t19; /* 1/(D/I1)*(gamma3*t17 - 2*m*g*a3/I1*s*1/(D/I1)) */
    out[14] = t20;
    const double t21 = x[4]*x[2]; /* s*omega_tau */
    const double t22 = 2.0*t21; /* 2*s*omega_tau */
    out[4] = t22;
    const double t23 = -t21; /* -s*omega_tau */
    out[20] = t23;
    const double t24 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t25 = p[12] + x[0]; /* b/R = a3/R + gamma3 */
    const double t26 = p[11]*t25; /* (-2*G_level^2/(R*I1^2))*b/R */
    const double t27 = t13*t26; /* 1/s*1/s*1/s*(-2*G_level^2/(R*I1^2))*b/R */
    out[9] = t27;
    const double t28 = p[8]*t21; /* m*a3^2/I1*s*omega_tau */
    const double t29 = JLT_FMS(t21, t28, t7); /* s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n */
    const double t30 = t5*t29; /* 1/(D/I1)*(s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n) */
    out[10] = t30;
    const double t31 = x[0]*t21; /* gamma3*s*omega_tau */
    const double t32 = t15*t31; /* 2*m*a3^2/I1*s*1/(D/I1)*gamma3*s*omega_tau */
    out[12] = t32;
    const double t33 = p[10]*t14; /* 1/R*1/s*omega_n */
    const double t34 = JLT_FNMA(p[12], t14, x[3]); /* omega3 - a3/R*1/s*omega_n */
    const double t35 = x[2]*t34; /* omega_tau*(omega3 - a3/R*1/s*omega_n) */
    out[15] = t35;
    const double t36 = -t33; /* -1/R*1/s*omega_n */
    out[16] = t36;
    const double t37 = t24*t33; /* e*1/R*1/s*omega_n */
    const double t38 = JLT_FMS(x[0], x[3], t37); /* gamma3*omega3 - e*1/R*1/s*omega_n */
    out[17] = t38;
    const double t39 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t40 = p[16]*t39; /* 2*G_level/(R^2*I1)*V */
    const double t41 = t13*t40; /* 1/s*1/s*1/s*2*G_level/(R^2*I1)*V */
    out[19] = t41;
    const double t42 = x[4]*p[1]; /* s*R */
    const double t43 = t6*t42; /* omega_n*s*R */
    out[8] = t43;
    const double t44 = x[2]*x[0]; /* omega_tau*gamma3 */
    out[18] = t44;
    const double t45 = -t44; /* -omega_tau*gamma3 */
    out[24] = t45;
    const double t46 = x[4]*x[0]; /* s*gamma3 */
    const double t47 = -t46; /* -s*gamma3 */
    out[22] = t47;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[18] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[7] = t0;
    const double t1 = JLT_FMA(p[8], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t2 = x[4]*t1; /* s*D/I1 */
    const double t3 = 1.0/t2; /* 1/(s*D/I1) */
    const double t4 = t1*t3; /* 1/s = D/I1*1/(s*D/I1) */
    const double t5 = x[4]*t3; /* 1/(D/I1) = s*1/(s*D/I1) */
    const double t6 = x[4]*x[2]; /* s*omega_tau */
    const double t7 = x[4]*t6; /* s*s*omega_tau */
    out[0] = t7;
    const double t8 = 2.0*t6; /* 2*s*omega_tau */
    out[9] = t8;
    const double t9 = -t6; /* -s*omega_tau */
    out[25] = t9;
    const double t10 = t4*t4; /* 1/s*1/s */
    const double t11 = p[20]*t10; /* G_level^2/(R*I1^2)*1/s*1/s */
    out[10] = t11;
    const double t12 = p[17]*t10; /* G_level^2/(R^2*I1^2)*1/s*1/s */
    const double t13 = p[8]*t6; /* m*a3^2/I1*s*omega_tau */
    const double t14 = JLT_FMS(t6, t13, t12); /* s*omega_tau*m*a3^2/I1*s*omega_tau - G_level^2/(R^2*I1^2)*1/s*1/s */
    const double t15 = t5*t14; /* 1/(D/I1)*t14 */
    out[15] = t15;
    const double t16 = x[0]*t14; /* gamma3*t14 */
    const double t17 = JLT_FNMA(p[9], t0, t16); /* gamma3*t14 - m*g*a3/I1*s*s */
    const double t18 = t5*t17; /* 1/(D/I1)*(gamma3*t14 - m*g*a3/I1*s*s) */
    out[2] = t18;
    const double t19 = JLT_FMA(p[13], t18, p[15]); /* 2*m*a3^2/I1*1/(D/I1)*(gamma3*t14 - m*g*a3/I1*s*s) + 2*m*g*a3/I1 */
    const double t20 = x[4]*t19; /* s*t19 */
    const double t21 = t4*t10; /* 1/s*1/s*1/s */
    const double t22 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t23 = p[21]*t21; /* 2*G_level^2/(R^2*I1^2)*1/s*1/s*1/s */
    const double t24 = JLT_FNMA(x[0], t23, t20); /* s*t19 - gamma3*2*G_level^2/(R^2*I1^2)*1/s*1/s*1/s */
    const double t25 = t5*t24; /* 1/(D/I1)*(s*t19 - gamma3*2*G_level^2/(R^2*I1^2)*1/s*1/s*1/s) */
    const double t26 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t27 = t12*t26; /* G_level^2/(R^2*I1^2)*1/s*1/s*b */
    const double t28 = t23*t26; /* 2*G_level^2/(R^2*I1^2)*1/s*1/s*1/s*b */
    const double t29 = -t28; /* -2*G_level^2/(R^2*I1^2)*1/s*1/s*1/s*b */
    out[14] = t29;
    const double t30 = x[4]*p[18]; /* s*G_level/I1 */
    const double t31 = t4*t30; /* 1/s*s*G_level/I1 */
    out[13] = t31;
    const double t32 = JLT_FMA(x[3], t31, t27); /* omega3*1/s*s*G_level/I1 + G_level^2/(R^2*I1^2)*1/s*1/s*b */
    out[1] = t32;
    const double t33 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = p[19]*t10; /* G_level/(R^2*I1)*1/s*1/s */
    const double t35 = JLT_FNMA(p[22], t10, x[3]); /* omega3 - a3*G_level/(R^2*I1)*1/s*1/s */
    const double t36 = x[2]*t35; /* omega_tau*(omega3 - a3*G_level/(R^2*I1)*1/s*1/s) */
    out[20] = t36;
    const double t37 = t22*t34; /* e*G_level/(R^2*I1)*1/s*1/s */
    const double t38 = JLT_FMS(x[0], x[3], t37); /* gamma3*omega3 - e*G_level/(R^2*I1)*1/s*1/s */
    out[22] = t38;
    const double t39 = -t34; /* -G_level/(R^2*I1)*1/s*1/s */
    out[21] = t39;
    const double t40 = t33*t34; /* V*G_level/(R^2*I1)*1/s*1/s */
    const double t41 = p[16]*t33; /* 2*G_level/(R^2*I1)*V */
    const double t42 = t21*t41; /* 1/s*1/s*1/s*2*G_level/(R^2*I1)*V */
    out[24] = t42;
    const double t43 = p[13]*t6; /* 2*m*a3^2/I1*s*omega_tau */
    const double t44 = t5*t43; /* 1/(D/I1)*2*m*a3^2/I1*s*omega_tau */
    const double t45 = x[0]*t6; /* gamma3*s*omega_tau */
    const double t46 = -t45; /* -gamma3*s*omega_tau */
    out[4] = t46;
    const double t47 = x[2]*x[0]; /* omega_tau*gamma3 */
    out[23] = t47;
    const double t48 = JLT_FMS(x[3], t47, t40); /* omega3*omega_tau*gamma3 - V*G_level/(R^2*I1)*1/s*1/s */
    out[3] = t48;
    const double t49 = JLT_FMS(t44, t47, t25); /* 1/(D/I1)*2*m*a3^2/I1*s*omega_tau*omega_tau*gamma3 - 1/(D/I1)*(s*t19 - gamma3*2*G_level^2/(R^2*I1^2)*1/s*1/s*1/s) */
    out[19] = t49;
    const double t50 = -t47; /* -omega_tau*gamma3 */
    out[29] = t50;
    const double t51 = x[4]*x[0]; /* s*gamma3 */
    const double t52 = t44*t51; /* 1/(D/I1)*2*m*a3^2/I1*s*omega_tau*s*gamma3 */
    out[17] = t52;
    const double t53 = -t51; /* -s*gamma3 */
    out[27] = t53;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[23]*x[0]; /* 2*m*a3^2*gamma3 */
    const double t1 = x[2]*t0; /* omega_tau*2*m*a3^2*gamma3 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = t1*t2; /* omega_tau*2*m*a3^2*gamma3*s*s */
    const double t4 = JLT_FMA(p[24], t2, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t5 = t3/t4; /* omega_tau*2*m*a3^2*gamma3*s*s/D */
    out[0] = t5;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[15]*x[0]; /* 2*m*g*a3/I1*gamma3 */
    const double t1 = p[8]*x[4]; /* m*a3^2/I1*s */
    const double t2 = JLT_FMA(x[4], t1, 1.0); /* D/I1 = s*m*a3^2/I1*s + 1 */
    const double t3 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t4 = p[7]/x[4]; /* omega_n = G_level/(R*I1)/s */
    const double t5 = JLT_FMA(t2, t3, t0); /* D/I1*omega_tau*omega_tau + 2*m*g*a3/I1*gamma3 */
    const double t6 = JLT_FMA(t4, t4, t5); /* omega_n*omega_n + D/I1*omega_tau*omega_tau + 2*m*g*a3/I1*gamma3 */
    const double t7 = p[25]*t6; /* 1/2*I1*t6 */
    out[2] = t7;
    const double t8 = x[1]*x[1]; /* v_nu*v_nu */
    const double t9 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = t4*t9; /* omega_n*b */
    const double t11 = x[4]*p[1]; /* s*R */
    const double t12 = JLT_FMA(x[3], t11, t10); /* v_tau = omega3*s*R + omega_n*b */
    const double t13 = JLT_FMA(t12, t12, t8); /* v_tau*v_tau + v_nu*v_nu */
    const double t14 = p[26]*t13; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[1] = t14;
    const double t15 = t7 + t14; /* energy = 1/2*I1*t6 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[0] = t15;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[10] = p[27];
    out[7] = 0.0;
    out[11] = 0.0;
    out[13] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    out[6] = t0;
    const double t1 = 1.0/x[4]; /* 1/s */
    const double t2 = p[7]*t1; /* omega_n = G_level/(R*I1)*1/s */
    const double t3 = t1*t1; /* 1/s*1/s */
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = t2*t4; /* omega_n*b */
    const double t6 = p[19]*t4; /* G_level/(R^2*I1)*b */
    const double t7 = JLT_FNMA(t3, t6, x[3]); /* d(v_tau)/d(s)/R = omega3 - 1/s*1/s*G_level/(R^2*I1)*b */
    const double t8 = x[4]*p[1]; /* s*R */
    const double t9 = JLT_FMA(x[3], t8, t5); /* v_tau = omega3*s*R + omega_n*b */
    const double t10 = p[28]*t9; /* m*R*v_tau */
    const double t11 = t7*t10; /* d(v_tau)/d(s)/R*m*R*v_tau */
    out[9] = t11;
    const double t12 = x[4]*t10; /* s*m*R*v_tau */
    out[3] = t12;
    out[8] = t12;
    const double t13 = t2*t10; /* omega_n*m*R*v_tau */
    out[5] = t13;
    const double t14 = p[27] + t13; /* d(energy)/d(gamma3) = m*g*a3 + omega_n*m*R*v_tau */
    out[0] = t14;
    const double t15 = p[29]*t2; /* G_level/R*omega_n */
    const double t16 = t3*t15; /* 1/s*1/s*G_level/R*omega_n */
    const double t17 = x[4]*p[24]; /* s*m*a3^2 */
    const double t18 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t19 = t17*t18; /* s*m*a3^2*omega_tau*omega_tau */
    const double t20 = JLT_FMA(x[4], t17, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t21 = x[2]*t20; /* omega_tau*D */
    out[2] = t21;
    out[12] = t21;
    const double t22 = t19 - t16; /* s*m*a3^2*omega_tau*omega_tau - 1/s*1/s*G_level/R*omega_n */
    out[14] = t22;
    const double t23 = t16 - t19; /* 1/s*1/s*G_level/R*omega_n - s*m*a3^2*omega_tau*omega_tau */
    const double t24 = t11 - t23; /* d(energy)/d(s) = d(v_tau)/d(s)/R*m*R*v_tau - (1/s*1/s*G_level/R*omega_n - s*m*a3^2*omega_tau*omega_tau) */
    out[4] = t24;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[7]/x[4]; /* G_level/(R*I1)/s */
    out[0] = t0;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
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
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t12[k] = jlt_jet_product(x4, x4, k);
        t13[k] = jlt_jet_product(x2, x0, k);
        t14[k] = jlt_jet_product(x2, t12, k);
        t15[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), x4, t15, k);
        t16[k] = p[8]*t13[k];
        t17[k] = jlt_jet_product(t14, t16, k);
        t18[k] = t17[k] - p[9]*t12[k];
        t19[k] = p[8]*t12[k] + (k == 0 ? 1.0 : 0);
        t20[k] = p[7]*t15[k];
        t21[k] = p[10]*t15[k];
        t22[k] = jlt_jet_product(t20, t20, k);
        t23[k] = t18[k] - jlt_jet_product(x0, t22, k);
        t24[k] = jlt_jet_quotient(t23[k], t19, t24, k);
        t25[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t26[k] = jlt_jet_product(x2, t25, k) + x1[k];
        t27[k] = jlt_jet_product(t21, t26, k);
        t28[k] = jlt_jet_product(t20, t27, k);
        t29[k] = jlt_jet_product(x3, t13, k) - t28[k];
        t30[k] = jlt_jet_product(x4, t13, k);
        t31[k] = -t30[k];
        t32[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t33[k] = jlt_jet_product(t22, t32, k);
        t34[k] = x4[k]*p[1];
        t35[k] = jlt_jet_product(x3, t34, k);
        t36[k] = jlt_jet_product(t20, t35, k) + t33[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t14[k]/(k + 1);
        next[1] = x1[k + 1] = t36[k]/(k + 1);
        next[2] = x2[k + 1] = t24[k]/(k + 1);
        next[3] = x3[k + 1] = t29[k]/(k + 1);
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
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = (0.0);
    const double complex v_omega3 = x[3];
    const double v_a3 = params[3];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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

const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular_on_level_omega_n = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "regular",
    .elimination = "level_omega_n",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 7, .prepared_count = 30,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 1, 18, 8, 1, 0, 0, 9, 7 }, { 9, 36, 0, 5, 0, 0, 8, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in e = a3*gamma3 + R, V = omega_tau*e + v_nu, d(omega3)/dtau, b = R*gamma3 + a3, a part of d(omega_tau)/dtau, d(v_nu)/dtau" },
    .jacobian = { jacobian, 25, { 5, 33, 9, 1, 0, 0, 12, 10 }, { 19, 110, 0, 17, 0, 0, 12, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of d(d(omega_tau)/dtau)/d(s), e = gamma3*a3 + R, b/R = a3/R + gamma3, s*omega_tau*(m*a3^2/I1)*s*omega_tau - omega_n*omega_n, omega3 - (a3/R)*1/s*omega_n, d(d(omega3)/dtau)/d(omega_tau), V = omega_tau*e + v_nu" },
    .rhs_jacobian = { rhs_jacobian, 30, { 6, 34, 13, 1, 0, 0, 16, 11 }, { 24, 137, 0, 21, 0, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in s*omega_tau*(m*a3^2/I1)*s*omega_tau - (G_level^2/(R^2*I1^2))*1/s*1/s, a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), e = a3*gamma3 + R, a part of d(d(omega_tau)/dtau)/d(s), b = R*gamma3 + a3, d(v_nu)/dtau, V = omega_tau*e + v_nu, omega3 - (a3*G_level/(R^2*I1))*1/s*1/s, d(d(omega3)/dtau)/d(omega_tau), d(omega3)/dtau, d(d(omega_tau)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 0, 4, 1, 1, 0, 0, 4, 3 }, { 1, 11, 0, 1, 0, 0, 6, 4 },
        "" },
    .integral_values = { integral_values, 3, { 1, 8, 6, 1, 0, 0, 6, 5 }, { 10, 40, 0, 1, 0, 0, 9, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in omega_n*omega_n + D/I1*omega_tau*omega_tau + (2*m*g*a3/I1)*gamma3, b = gamma3*R + a3, v_tau = omega3*s*R + omega_n*b, E" },
    .integral_gradients = { integral_gradients, 15, { 4, 16, 4, 1, 0, 0, 7, 6 }, { 8, 55, 0, 4, 0, 0, 8, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, d(v_tau)/d(s)/R = omega3 - ((1)/s)*((1)/s)*(G_level/(R^2*I1))*b, v_tau = omega3*s*R + omega_n*b, d(E)/d(gamma3), d(E2)/d(s), d(E)/d(s)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 0, 0, 1, 0, 0, 1, 1 }, { 0, 2, 0, 1, 0, 0, 3, 2 },
        "divides by s: values and rounding errors grow without bound where it vanishes" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .eliminated_state = 3, .level_integral = 1,
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular_on_level_omega_n,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_rod_in_regular_on_level_omega_n) },
#endif
};
