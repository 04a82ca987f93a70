/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_omega_n: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   18    7    1    0    0      9    8   (59)
 *  jacobian            4   40   15    1    0    0     12   12   (279)
 *  rhs_jacobian        5   46   17    1    0    0     12   14   (316)
 *  divergence          2    5    3    1    0    0      6    4   (32)
 *  integral_values     0   12   10    1    0    0      9    5   (55)
 *  integral_gradients  2   24   10    1    0    0      8   11   (111)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    2    1    1    0    0      4    2   (7)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    digits are lost where terms nearly cancel in (R*I3)*gamma3*omega3 + G_level, V = omega_tau*R + v_nu,
 *      d(d(omega3)/dtau)/d(omega_tau),
 *      a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s),
 *      ((I1 - I3)/I1)*s*s*omega_tau - (I3/(R*I1))*V, (2*R*I3)*gamma3*omega3 + (R*I3)*gamma3*omega3 + G_level,
 *      d(d(v_nu)/dtau)/d(omega3), d(d(omega_tau)/dtau)/d(omega3), d(d(omega3)/dtau)/d(gamma3), d(v_nu)/dtau,
 *      d(omega_tau)/dtau, d(d(omega3)/dtau)/d(s), d(d(v_nu)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(gamma3)
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_omega_n;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega_n;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_omega_n_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_omega_n_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_omega_n_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
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
    const double t0 = 1.0/params[4]; /* 1/I1 */
    out[7] = t0;
    const double t1 = params[1]*params[5]; /* R*I3 */
    out[8] = t1;
    const double t2 = params[4]*params[4]; /* I1*I1 */
    const double t3 = params[1]*t2; /* R*I1*I1 */
    const double t4 = 1.0/t3; /* 1/(R*I1*I1) */
    out[9] = t4;
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    out[35] = t6;
    const double t7 = params[5]/t6; /* I3/(m*R*R) */
    out[10] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[11] = t8;
    const double t9 = t2*t5; /* I1*I1*R*R */
    const double t10 = (-1.0)/t9; /* (-1)/(I1*I1*R*R) */
    out[12] = t10;
    const double t11 = params[5]/t3; /* I3/(R*I1*I1) */
    const double t12 = -t11; /* -I3/(R*I1*I1) */
    out[13] = t12;
    const double t13 = params[4]*t5; /* I1*R*R */
    const double t14 = (-1.0)/t13; /* (-1)/(I1*R*R) */
    out[14] = t14;
    const double t15 = params[4] - params[5]; /* I1 - I3 */
    const double t16 = t5*t15; /* R*R*(I1 - I3) */
    out[15] = t16;
    const double t17 = params[1]*2.0; /* R*2 */
    const double t18 = params[5]*t17; /* I3*R*2 */
    out[16] = t18;
    const double t19 = t1/params[4]; /* R*I3/I1 */
    out[17] = t19;
    const double t20 = params[5]*2.0; /* I3*2 */
    const double t21 = t20/t2; /* I3*2/(I1*I1) */
    out[18] = t21;
    const double t22 = (-2.0)/t3; /* (-2)/(R*I1*I1) */
    out[19] = t22;
    const double t23 = params[5]*params[5]; /* I3*I3 */
    const double t24 = t23/t2; /* I3*I3/(I1*I1) */
    const double t25 = -t24; /* -I3*I3/(I1*I1) */
    out[20] = t25;
    const double t26 = params[5]*(-2.0); /* I3*(-2) */
    const double t27 = t26/t3; /* I3*(-2)/(R*I1*I1) */
    out[21] = t27;
    const double t28 = 2.0/t9; /* 2/(I1*I1*R*R) */
    out[22] = t28;
    const double t29 = t20/t9; /* I3*2/(I1*I1*R*R) */
    out[23] = t29;
    const double t30 = t15/params[4]; /* (I1 - I3)/I1 */
    out[24] = t30;
    const double t31 = params[4]*params[1]; /* I1*R */
    const double t32 = params[5]/t31; /* I3/(I1*R) */
    out[25] = t32;
    const double t33 = 1.0/t31; /* 1/(I1*R) */
    out[26] = t33;
    const double t34 = 2.0/t13; /* 2/(I1*R*R) */
    out[27] = t34;
    const double t35 = t15*2.0; /* (I1 - I3)*2 */
    const double t36 = t35/params[4]; /* (I1 - I3)*2/I1 */
    out[28] = t36;
    const double t37 = params[0]/2.0; /* m/2 */
    out[29] = t37;
    const double t38 = params[4]/2.0; /* I1/2 */
    out[30] = t38;
    const double t39 = params[5]/2.0; /* I3/2 */
    out[31] = t39;
    const double t40 = t2*params[0]; /* I1*I1*m */
    out[32] = t40;
    const double t41 = params[4]*t6; /* I1*m*R*R */
    const double t42 = t15*t41; /* (I1 - I3)*I1*m*R*R */
    out[33] = t42;
    const double t43 = params[1]*params[0]; /* R*m */
    const double t44 = t43/params[4]; /* R*m/I1 */
    out[34] = t44;
    const double t45 = 1.0/t13; /* 1/(I1*R*R) */
    out[36] = t45;
    const double t46 = params[0]*2.0; /* m*2 */
    const double t47 = t5*t46; /* R*R*m*2 */
    const double t48 = params[5]*t47; /* I3*R*R*m*2 */
    const double t49 = t15*t48; /* (I1 - I3)*I3*R*R*m*2 */
    out[37] = t49;
    const double t50 = t2*t46; /* I1*I1*m*2 */
    out[38] = t50;
    const double t51 = params[1]*t46; /* R*m*2 */
    const double t52 = t2*t51; /* I1*I1*R*m*2 */
    out[39] = t52;
    const double t53 = params[4]*t47; /* I1*R*R*m*2 */
    const double t54 = t15*t53; /* (I1 - I3)*I1*R*R*m*2 */
    out[40] = t54;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*p[11]; /* gamma3*I3/I1 */
    const double t1 = JLT_FMA(x[4], x[4], p[10]); /* s*s + I3/(m*R^2) */
    const double t2 = JLT_FMA(x[0], t0, t1); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t3 = x[4]*t2; /* s*Theta/(m*R^2*I1) */
    const double t4 = 1.0/t3; /* 1/(s*Theta/(m*R^2*I1)) */
    const double t5 = x[0]*x[3]; /* gamma3*omega3 */
    const double t6 = JLT_FMA(p[8], t5, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t7 = t2*t6; /* Theta/(m*R^2*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t8 = t4*t7; /* 1/(s*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t9 = p[15]*t5; /* R^2*(I1 - I3)*gamma3*omega3 */
    const double t10 = x[4]*x[2]; /* s*omega_tau */
    const double t11 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t12 = t6*t11; /* (R*I3*gamma3*omega3 + G_level)*V */
    const double t13 = x[3]*t6; /* omega3*(R*I3*gamma3*omega3 + G_level) */
    const double t14 = x[4]*t10; /* s*s*omega_tau */
    out[0] = t14;
    const double t15 = JLT_FNMA(t9, t14, t12); /* (R*I3*gamma3*omega3 + G_level)*V - R^2*(I1 - I3)*gamma3*omega3*s*s*omega_tau */
    const double t16 = x[0]*t10; /* gamma3*s*omega_tau */
    const double t17 = -t16; /* -gamma3*s*omega_tau */
    out[4] = t17;
    const double t18 = x[0]*t8; /* gamma3*t8 */
    const double t19 = t8*t18; /* t8*gamma3*t8 */
    const double t20 = x[4]*p[14]; /* s*(-1/(R^2*I1)) */
    const double t21 = t15*t20; /* t15*s*(-1/(R^2*I1)) */
    const double t22 = t4*t21; /* 1/(s*Theta/(m*R^2*I1))*t15*s*(-1/(R^2*I1)) */
    out[3] = t22;
    const double t23 = p[7]*t13; /* 1/I1*omega3*(R*I3*gamma3*omega3 + G_level) */
    const double t24 = JLT_FMA(p[9], t19, t23); /* 1/(R*I1^2)*t8*gamma3*t8 + 1/I1*omega3*(R*I3*gamma3*omega3 + G_level) */
    out[1] = t24;
    const double t25 = p[12]*t19; /* (-1/(R^2*I1^2))*t8*gamma3*t8 */
    const double t26 = JLT_FMA(p[13], t13, t25); /* (-I3/(R*I1^2))*omega3*(R*I3*gamma3*omega3 + G_level) + (-1/(R^2*I1^2))*t8*gamma3*t8 */
    out[2] = t26;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[21] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[2] = t0;
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[4] = t2;
    const double t3 = x[0]*x[3]; /* gamma3*omega3 */
    const double t4 = JLT_FMA(p[8], t3, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t5 = x[0]*p[11]; /* gamma3*I3/I1 */
    const double t6 = t0 + p[10]; /* s*s + I3/(m*R^2) */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t8 = x[4]*t7; /* s*Theta/(m*R^2*I1) */
    const double t9 = 1.0/t8; /* 1/(s*Theta/(m*R^2*I1)) */
    const double t10 = t7*t9; /* 1/s = Theta/(m*R^2*I1)*1/(s*Theta/(m*R^2*I1)) */
    const double t11 = t4*t10; /* (R*I3*gamma3*omega3 + G_level)*1/s */
    const double t12 = t10*t11; /* 1/s*(R*I3*gamma3*omega3 + G_level)*1/s */
    const double t13 = JLT_FMA(t3, p[16], t4); /* gamma3*omega3*2*R*I3 + R*I3*gamma3*omega3 + G_level */
    const double t14 = t12*t13; /* 1/s*(R*I3*gamma3*omega3 + G_level)*1/s*(gamma3*omega3*2*R*I3 + R*I3*gamma3*omega3 + G_level) */
    const double t15 = p[9]*t14; /* 1/(R*I1^2)*t14 */
    const double t16 = x[3]*x[3]; /* omega3*omega3 */
    const double t17 = JLT_FMA(p[17], t16, t15); /* R*I3/I1*omega3*omega3 + 1/(R*I1^2)*t14 */
    out[5] = t17;
    const double t18 = t4*p[7]; /* (R*I3*gamma3*omega3 + G_level)*1/I1 */
    const double t19 = x[0]*t12; /* gamma3*1/s*(R*I3*gamma3*omega3 + G_level)*1/s */
    const double t20 = x[0]*t19; /* gamma3*gamma3*1/s*(R*I3*gamma3*omega3 + G_level)*1/s */
    const double t21 = JLT_FMA(t3, p[17], t18); /* gamma3*omega3*R*I3/I1 + (R*I3*gamma3*omega3 + G_level)*1/I1 */
    const double t22 = JLT_FMA(p[18], t20, t21); /* 2*I3/I1^2*gamma3*gamma3*1/s*(R*I3*gamma3*omega3 + G_level)*1/s + gamma3*omega3*R*I3/I1 + (R*I3*gamma3*omega3 + G_level)*1/I1 */
    out[8] = t22;
    const double t23 = t11*t19; /* (R*I3*gamma3*omega3 + G_level)*1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level)*1/s */
    const double t24 = p[19]*t23; /* (-2/(R*I1^2))*t23 */
    out[9] = t24;
    const double t25 = t14*p[12]; /* t14*(-1/(R^2*I1^2)) */
    const double t26 = JLT_FMA(t16, p[20], t25); /* omega3*omega3*(-I3^2/I1^2) + t14*(-1/(R^2*I1^2)) */
    out[10] = t26;
    const double t27 = t4*p[13]; /* (R*I3*gamma3*omega3 + G_level)*(-I3/(R*I1^2)) */
    const double t28 = JLT_FMA(t3, p[20], t27); /* gamma3*omega3*(-I3^2/I1^2) + (R*I3*gamma3*omega3 + G_level)*(-I3/(R*I1^2)) */
    const double t29 = JLT_FMA(t20, p[21], t28); /* gamma3*gamma3*1/s*(R*I3*gamma3*omega3 + G_level)*1/s*(-2*I3/(R*I1^2)) + t28 */
    out[13] = t29;
    const double t30 = t23*p[22]; /* t23*2/(R^2*I1^2) */
    out[14] = t30;
    const double t31 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t32 = x[4]*t9; /* 1/(Theta/(m*R^2*I1)) = s*1/(s*Theta/(m*R^2*I1)) */
    const double t33 = t4*t32; /* (R*I3*gamma3*omega3 + G_level)*1/(Theta/(m*R^2*I1)) */
    const double t34 = t31*t33; /* V*(R*I3*gamma3*omega3 + G_level)*1/(Theta/(m*R^2*I1)) */
    const double t35 = x[4]*t32; /* s*1/(Theta/(m*R^2*I1)) */
    const double t36 = t3*t35; /* gamma3*omega3*s*1/(Theta/(m*R^2*I1)) */
    const double t37 = t1*p[15]; /* s*omega_tau*R^2*(I1 - I3) */
    const double t38 = JLT_FNMA(t36, t37, t34); /* V*(R*I3*gamma3*omega3 + G_level)*1/(Theta/(m*R^2*I1)) - gamma3*omega3*s*1/(Theta/(m*R^2*I1))*s*omega_tau*R^2*(I1 - I3) */
    const double t39 = x[0]*p[23]; /* gamma3*2*I3/(R^2*I1^2) */
    const double t40 = t38*t39; /* t38*gamma3*2*I3/(R^2*I1^2) */
    const double t41 = x[4]*p[24]; /* s*(I1 - I3)/I1 */
    const double t42 = t1*t41; /* s*omega_tau*s*(I1 - I3)/I1 */
    const double t43 = JLT_FNMA(t31, p[25], t42); /* s*omega_tau*s*(I1 - I3)/I1 - V*I3/(R*I1) */
    const double t44 = JLT_FMA(x[3], t43, t40); /* omega3*(s*omega_tau*s*(I1 - I3)/I1 - V*I3/(R*I1)) + t38*gamma3*2*I3/(R^2*I1^2) */
    const double t45 = t32*t44; /* 1/(Theta/(m*R^2*I1))*t44 */
    out[15] = t45;
    const double t46 = t33*p[14]; /* (R*I3*gamma3*omega3 + G_level)*1/(Theta/(m*R^2*I1))*(-1/(R^2*I1)) */
    out[16] = t46;
    const double t47 = t36*t41; /* gamma3*omega3*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    const double t48 = JLT_FNMA(t33, p[26], t47); /* gamma3*omega3*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 - (R*I3*gamma3*omega3 + G_level)*1/(Theta/(m*R^2*I1))*1/(R*I1) */
    out[17] = t48;
    const double t49 = x[0]*t43; /* gamma3*(s*omega_tau*s*(I1 - I3)/I1 - V*I3/(R*I1)) */
    const double t50 = t32*t49; /* 1/(Theta/(m*R^2*I1))*gamma3*(s*omega_tau*s*(I1 - I3)/I1 - V*I3/(R*I1)) */
    out[18] = t50;
    const double t51 = x[2]*p[15]; /* omega_tau*R^2*(I1 - I3) */
    const double t52 = JLT_FMA(t3, t51, t38); /* gamma3*omega3*omega_tau*R^2*(I1 - I3) + t38 */
    const double t53 = t35*p[27]; /* s*1/(Theta/(m*R^2*I1))*2/(R^2*I1) */
    const double t54 = t52*t53; /* (gamma3*omega3*omega_tau*R^2*(I1 - I3) + t38)*s*1/(Theta/(m*R^2*I1))*2/(R^2*I1) */
    out[19] = t54;
    const double t55 = -t1; /* -s*omega_tau */
    out[20] = t55;
    const double t56 = x[4]*x[0]; /* s*gamma3 */
    const double t57 = -t56; /* -s*gamma3 */
    out[22] = t57;
    const double t58 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t59 = -t58; /* -omega_tau*gamma3 */
    out[24] = t59;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[7] = t0;
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = p[10] + t0; /* I3/(m*R^2) + s*s */
    const double t3 = JLT_FMA(p[11], t1, t2); /* Theta/(m*R^2*I1) = I3/I1*gamma3*gamma3 + I3/(m*R^2) + s*s */
    const double t4 = p[24]*t0; /* (I1 - I3)/I1*s*s */
    const double t5 = x[4]*t3; /* s*Theta/(m*R^2*I1) */
    const double t6 = 1.0/t5; /* 1/(s*Theta/(m*R^2*I1)) */
    const double t7 = t3*t6; /* 1/s = Theta/(m*R^2*I1)*1/(s*Theta/(m*R^2*I1)) */
    const double t8 = x[4]*t6; /* 1/(Theta/(m*R^2*I1)) = s*1/(s*Theta/(m*R^2*I1)) */
    const double t9 = x[0]*x[3]; /* gamma3*omega3 */
    const double t10 = x[4]*x[2]; /* s*omega_tau */
    const double t11 = 2.0*t10; /* 2*s*omega_tau */
    out[9] = t11;
    const double t12 = -t10; /* -s*omega_tau */
    out[25] = t12;
    const double t13 = JLT_FMA(p[8], t9, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t14 = x[4]*t10; /* s*s*omega_tau */
    out[0] = t14;
    const double t15 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t16 = t8*t13; /* 1/(Theta/(m*R^2*I1))*(R*I3*gamma3*omega3 + G_level) */
    const double t17 = p[14]*t16; /* (-1/(R^2*I1))*1/(Theta/(m*R^2*I1))*(R*I3*gamma3*omega3 + G_level) */
    out[21] = t17;
    const double t18 = t7*t13; /* 1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t19 = t7*t18; /* 1/s*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t20 = t1*t19; /* gamma3*gamma3*1/s*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t21 = t15*t16; /* V*1/(Theta/(m*R^2*I1))*(R*I3*gamma3*omega3 + G_level) */
    const double t22 = p[26]*t16; /* 1/(R*I1)*1/(Theta/(m*R^2*I1))*(R*I3*gamma3*omega3 + G_level) */
    const double t23 = t8*t9; /* 1/(Theta/(m*R^2*I1))*gamma3*omega3 */
    const double t24 = JLT_FMS(t4, t23, t22); /* (I1 - I3)/I1*s*s*1/(Theta/(m*R^2*I1))*gamma3*omega3 - 1/(R*I1)*1/(Theta/(m*R^2*I1))*(R*I3*gamma3*omega3 + G_level) */
    out[22] = t24;
    const double t25 = p[15]*t14; /* R^2*(I1 - I3)*s*s*omega_tau */
    const double t26 = JLT_FNMA(t23, t25, t21); /* V*1/(Theta/(m*R^2*I1))*(R*I3*gamma3*omega3 + G_level) - 1/(Theta/(m*R^2*I1))*gamma3*omega3*R^2*(I1 - I3)*s*s*omega_tau */
    const double t27 = p[24]*t14; /* (I1 - I3)/I1*s*s*omega_tau */
    const double t28 = JLT_FNMA(p[25], t15, t27); /* (I1 - I3)/I1*s*s*omega_tau - I3/(R*I1)*V */
    const double t29 = t8*t28; /* 1/(Theta/(m*R^2*I1))*((I1 - I3)/I1*s*s*omega_tau - I3/(R*I1)*V) */
    const double t30 = t8*t26; /* 1/(Theta/(m*R^2*I1))*t26 */
    const double t31 = p[14]*t26; /* (-1/(R^2*I1))*t26 */
    out[3] = t31;
    const double t32 = x[0]*t29; /* gamma3*t29 */
    out[23] = t32;
    const double t33 = x[0]*t13; /* gamma3*(R*I3*gamma3*omega3 + G_level) */
    const double t34 = t19*t33; /* 1/s*1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*(R*I3*gamma3*omega3 + G_level) */
    const double t35 = t7*t34; /* 1/s*t34 */
    const double t36 = p[19]*t35; /* (-2/(R*I1^2))*1/s*t34 */
    out[14] = t36;
    const double t37 = p[22]*t35; /* 2/(R^2*I1^2)*1/s*t34 */
    out[19] = t37;
    const double t38 = JLT_FMA(p[16], t9, t13); /* 2*R*I3*gamma3*omega3 + R*I3*gamma3*omega3 + G_level */
    const double t39 = t19*t38; /* 1/s*1/s*(R*I3*gamma3*omega3 + G_level)*(2*R*I3*gamma3*omega3 + R*I3*gamma3*omega3 + G_level) */
    const double t40 = x[3]*t13; /* omega3*(R*I3*gamma3*omega3 + G_level) */
    const double t41 = p[7]*t13; /* 1/I1*(R*I3*gamma3*omega3 + G_level) */
    const double t42 = p[13]*t13; /* (-I3/(R*I1^2))*(R*I3*gamma3*omega3 + G_level) */
    const double t43 = JLT_FMA(p[17], t9, t41); /* R*I3/I1*gamma3*omega3 + 1/I1*(R*I3*gamma3*omega3 + G_level) */
    const double t44 = JLT_FMA(p[20], t9, t42); /* (-I3^2/I1^2)*gamma3*omega3 + (-I3/(R*I1^2))*(R*I3*gamma3*omega3 + G_level) */
    const double t45 = JLT_FMA(p[18], t20, t43); /* 2*I3/I1^2*gamma3*gamma3*1/s*1/s*(R*I3*gamma3*omega3 + G_level) + R*I3/I1*gamma3*omega3 + 1/I1*(R*I3*gamma3*omega3 + G_level) */
    out[13] = t45;
    const double t46 = JLT_FMA(p[21], t20, t44); /* (-2*I3/(R*I1^2))*gamma3*gamma3*1/s*1/s*(R*I3*gamma3*omega3 + G_level) + t44 */
    out[18] = t46;
    const double t47 = x[0]*p[23]; /* gamma3*2*I3/(R^2*I1^2) */
    const double t48 = t30*t47; /* 1/(Theta/(m*R^2*I1))*t26*gamma3*2*I3/(R^2*I1^2) */
    const double t49 = JLT_FMA(x[3], t29, t48); /* omega3*t29 + 1/(Theta/(m*R^2*I1))*t26*gamma3*2*I3/(R^2*I1^2) */
    out[20] = t49;
    const double t50 = x[4]*p[27]; /* s*2/(R^2*I1) */
    const double t51 = t30*t50; /* 1/(Theta/(m*R^2*I1))*t26*s*2/(R^2*I1) */
    const double t52 = p[7]*t40; /* 1/I1*omega3*(R*I3*gamma3*omega3 + G_level) */
    const double t53 = JLT_FMA(p[9], t34, t52); /* 1/(R*I1^2)*t34 + 1/I1*omega3*(R*I3*gamma3*omega3 + G_level) */
    out[1] = t53;
    const double t54 = p[12]*t34; /* (-1/(R^2*I1^2))*t34 */
    const double t55 = JLT_FMA(p[13], t40, t54); /* (-I3/(R*I1^2))*omega3*(R*I3*gamma3*omega3 + G_level) + (-1/(R^2*I1^2))*t34 */
    out[2] = t55;
    const double t56 = x[0]*t10; /* gamma3*s*omega_tau */
    const double t57 = -t56; /* -gamma3*s*omega_tau */
    out[4] = t57;
    const double t58 = p[28]*t10; /* 2*(I1 - I3)/I1*s*omega_tau */
    const double t59 = JLT_FMA(t23, t58, t51); /* 1/(Theta/(m*R^2*I1))*gamma3*omega3*2*(I1 - I3)/I1*s*omega_tau + 1/(Theta/(m*R^2*I1))*t26*s*2/(R^2*I1) */
    out[24] = t59;
    const double t60 = p[9]*t39; /* 1/(R*I1^2)*t39 */
    const double t61 = p[12]*t39; /* (-1/(R^2*I1^2))*t39 */
    const double t62 = x[3]*x[3]; /* omega3*omega3 */
    const double t63 = JLT_FMA(p[17], t62, t60); /* R*I3/I1*omega3*omega3 + 1/(R*I1^2)*t39 */
    out[10] = t63;
    const double t64 = JLT_FMA(p[20], t62, t61); /* (-I3^2/I1^2)*omega3*omega3 + (-1/(R^2*I1^2))*t39 */
    out[15] = t64;
    const double t65 = x[4]*x[0]; /* s*gamma3 */
    const double t66 = -t65; /* -s*gamma3 */
    out[27] = t66;
    const double t67 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t68 = -t67; /* -omega_tau*gamma3 */
    out[29] = t68;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[0]*p[11]; /* gamma3*I3/I1 */
    const double t2 = p[10] + t0; /* I3/(m*R^2) + s*s */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s*s */
    const double t4 = p[24]*x[2]; /* (I1 - I3)/I1*omega_tau */
    const double t5 = t0*t4; /* s*s*(I1 - I3)/I1*omega_tau */
    const double t6 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t7 = JLT_FNMA(p[25], t6, t5); /* s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V */
    const double t8 = t7/t3; /* (s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V)/(Theta/(m*R^2*I1)) */
    const double t9 = t8 - x[2]; /* t8 - omega_tau */
    const double t10 = x[0]*t9; /* gamma3*(t8 - omega_tau) */
    out[0] = t10;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t2 = JLT_FMA(x[3], t1, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t3 = p[26]*t2; /* 1/(R*I1)*(omega3*R*I3*gamma3 + G_level) */
    const double t4 = t3/x[4]; /* omega_n = 1/(R*I1)*(omega3*R*I3*gamma3 + G_level)/s */
    const double t5 = x[0]*t4; /* gamma3*omega_n */
    const double t6 = JLT_FMA(x[4], x[3], t5); /* s*omega3 + gamma3*omega_n */
    const double t7 = p[1]*t6; /* v_tau = R*(s*omega3 + gamma3*omega_n) */
    const double t8 = JLT_FMA(t7, t7, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t9 = t4*t4; /* omega_n*omega_n */
    const double t10 = JLT_FMA(x[2], x[2], t9); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t11 = p[30]*t10; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t12 = x[3]*x[3]; /* omega3*omega3 */
    const double t13 = JLT_FMA(p[31], t12, t11); /* 1/2*I3*omega3*omega3 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t14 = JLT_FMA(p[29], t8, t13); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t13 */
    out[0] = t14;
    const double t15 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t16 = p[32]*t15; /* m*I1^2*(R*omega_tau + v_nu) */
    const double t17 = t15*t16; /* (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    const double t18 = x[0]*p[11]; /* gamma3*I3/I1 */
    const double t19 = JLT_FMA(x[4], x[4], p[10]); /* s*s + I3/(m*R^2) */
    const double t20 = JLT_FMA(x[0], t18, t19); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t21 = t12*p[33]; /* omega3*omega3*m*R^2*I1*(I1 - I3) */
    const double t22 = JLT_FMA(t20, t21, t17); /* Theta/(m*R^2*I1)*omega3*omega3*m*R^2*I1*(I1 - I3) + (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    out[1] = t22;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[4]; /* 1/s */
    const double t1 = x[3]*x[0]; /* omega3*gamma3 */
    const double t2 = p[8]*t1; /* R*I3*omega3*gamma3 */
    const double t3 = p[6] + t2; /* G_level + R*I3*omega3*gamma3 */
    const double t4 = t0*t3; /* 1/s*(G_level + R*I3*omega3*gamma3) */
    const double t5 = t0*t4; /* 1/s*1/s*(G_level + R*I3*omega3*gamma3) */
    const double t6 = p[25]*t5; /* I3/(R*I1)*1/s*1/s*(G_level + R*I3*omega3*gamma3) */
    const double t7 = x[3]*t6; /* omega3*I3/(R*I1)*1/s*1/s*(G_level + R*I3*omega3*gamma3) */
    const double t8 = x[3]*x[4]; /* omega3*s */
    const double t9 = x[0]*p[26]; /* gamma3*1/(R*I1) */
    const double t10 = JLT_FMA(t4, t9, t8); /* v_tau/R = 1/s*(G_level + R*I3*omega3*gamma3)*gamma3*1/(R*I1) + omega3*s */
    const double t11 = JLT_FMA(t0, t2, t4); /* d(v_tau)/d(gamma3)/(1/I1) = 1/s*R*I3*omega3*gamma3 + 1/s*(G_level + R*I3*omega3*gamma3) */
    const double t12 = p[34]*t11; /* m*R/I1*d(v_tau)/d(gamma3)/(1/I1) */
    const double t13 = JLT_FMA(t10, t12, t7); /* d(energy)/d(gamma3) = v_tau/R*m*R/I1*d(v_tau)/d(gamma3)/(1/I1) + omega3*I3/(R*I1)*1/s*1/s*(G_level + R*I3*omega3*gamma3) */
    out[0] = t13;
    const double t14 = p[0]*x[1]; /* m*v_nu */
    out[1] = t14;
    const double t15 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t15;
    const double t16 = x[3]*p[5]; /* omega3*I3 */
    const double t17 = x[0]*p[11]; /* gamma3*I3/I1 */
    const double t18 = x[0]*t17; /* gamma3*gamma3*I3/I1 */
    const double t19 = JLT_FMA(t0, t18, x[4]); /* d(v_tau)/d(omega3)/R = 1/s*gamma3*gamma3*I3/I1 + s */
    const double t20 = t10*p[35]; /* v_tau/R*m*R^2 */
    const double t21 = JLT_FMA(x[0], t6, t16); /* gamma3*I3/(R*I1)*1/s*1/s*(G_level + R*I3*omega3*gamma3) + omega3*I3 */
    const double t22 = JLT_FMA(t19, t20, t21); /* d(energy)/d(omega3) = d(v_tau)/d(omega3)/R*v_tau/R*m*R^2 + t21 */
    out[3] = t22;
    const double t23 = JLT_FNMA(t5, t9, x[3]); /* d(v_tau)/d(s)/R = omega3 - 1/s*1/s*(G_level + R*I3*omega3*gamma3)*gamma3*1/(R*I1) */
    const double t24 = t20*t23; /* v_tau/R*m*R^2*d(v_tau)/d(s)/R */
    const double t25 = t4*p[36]; /* 1/s*(G_level + R*I3*omega3*gamma3)*1/(R^2*I1) */
    const double t26 = JLT_FNMA(t5, t25, t24); /* d(energy)/d(s) = v_tau/R*m*R^2*d(v_tau)/d(s)/R - 1/s*1/s*(G_level + R*I3*omega3*gamma3)*1/s*(G_level + R*I3*omega3*gamma3)*1/(R^2*I1) */
    out[4] = t26;
    const double t27 = x[3]*p[37]; /* omega3*2*m*R^2*I3*(I1 - I3) */
    const double t28 = t1*t27; /* omega3*gamma3*omega3*2*m*R^2*I3*(I1 - I3) */
    out[5] = t28;
    const double t29 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t30 = p[38]*t29; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[6] = t30;
    const double t31 = t29*p[39]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[7] = t31;
    const double t32 = JLT_FMA(x[4], x[4], p[10]); /* s*s + I3/(m*R^2) */
    const double t33 = t18 + t32; /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t34 = x[3]*p[40]; /* omega3*2*m*R^2*I1*(I1 - I3) */
    const double t35 = t33*t34; /* Theta/(m*R^2*I1)*omega3*2*m*R^2*I1*(I1 - I3) */
    out[8] = t35;
    const double t36 = t8*t34; /* omega3*s*omega3*2*m*R^2*I1*(I1 - I3) */
    out[9] = t36;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t1 = JLT_FMA(x[3], t0, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t2 = p[26]*t1; /* 1/(R*I1)*(omega3*R*I3*gamma3 + G_level) */
    const double t3 = t2/x[4]; /* 1/(R*I1)*(omega3*R*I3*gamma3 + G_level)/s */
    out[0] = t3;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
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
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t16[k] = jlt_jet_product(x0, x3, k);
        t17[k] = p[8]*t16[k] + (k == 0 ? p[6] : 0);
        t18[k] = p[15]*t16[k];
        t19[k] = jlt_jet_product(x4, x2, k);
        t20[k] = x2[k]*p[1] + x1[k];
        t21[k] = jlt_jet_product(t17, t20, k);
        t22[k] = jlt_jet_product(x4, t19, k);
        t23[k] = t21[k] - jlt_jet_product(t18, t22, k);
        t24[k] = p[14]*t23[k];
        t25[k] = jlt_jet_product(x0, t19, k);
        t26[k] = -t25[k];
        t27[k] = x0[k]*p[11];
        t28[k] = jlt_jet_product(x4, x4, k) + (k == 0 ? p[10] : 0);
        t29[k] = jlt_jet_product(x0, t27, k) + t28[k];
        t30[k] = jlt_jet_quotient(t24[k], t29, t30, k);
        t31[k] = jlt_jet_quotient(t17[k], x4, t31, k);
        t32[k] = jlt_jet_product(x3, t17, k);
        t33[k] = jlt_jet_product(x0, t31, k);
        t34[k] = jlt_jet_product(t31, t33, k);
        t35[k] = p[7]*t32[k];
        t36[k] = p[9]*t34[k] + t35[k];
        t37[k] = p[12]*t34[k];
        t38[k] = p[13]*t32[k] + t37[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t22[k]/(k + 1);
        next[1] = x1[k + 1] = t36[k]/(k + 1);
        next[2] = x2[k + 1] = t38[k]/(k + 1);
        next[3] = x3[k + 1] = t30[k]/(k + 1);
        next[4] = x4[k + 1] = t26[k]/(k + 1);
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
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
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
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_omega_n = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "regular",
    .elimination = "level_omega_n",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 7, .prepared_count = 41,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 1, 18, 7, 1, 0, 0, 9, 8 }, { 10, 45, 0, 4, 0, 0, 10, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in (R*I3)*gamma3*omega3 + G_level, V = omega_tau*R + v_nu, a part of d(omega3)/dtau, d(v_nu)/dtau, d(omega_tau)/dtau" },
    .jacobian = { jacobian, 25, { 4, 40, 15, 1, 0, 0, 12, 12 }, { 42, 208, 0, 29, 0, 0, 13, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in (R*I3)*gamma3*omega3 + G_level, gamma3*omega3*(2*R*I3) + (R*I3)*gamma3*omega3 + G_level, d(d(v_nu)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(omega3), d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(omega3), V = omega_tau*R + v_nu, a part of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s), s*omega_tau*s*((I1 - I3)/I1) - V*(I3/(R*I1)), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(omega_tau), a part of d(d(omega3)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 5, 46, 17, 1, 0, 0, 12, 14 }, { 48, 236, 0, 32, 0, 0, 13, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in (R*I3)*gamma3*omega3 + G_level, V = omega_tau*R + v_nu, d(d(omega3)/dtau)/d(omega_tau), a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s), ((I1 - I3)/I1)*s*s*omega_tau - (I3/(R*I1))*V, (2*R*I3)*gamma3*omega3 + (R*I3)*gamma3*omega3 + G_level, d(d(v_nu)/dtau)/d(omega3), d(d(omega_tau)/dtau)/d(omega3), d(d(omega3)/dtau)/d(gamma3), d(v_nu)/dtau, d(omega_tau)/dtau, d(d(omega3)/dtau)/d(s), d(d(v_nu)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(gamma3)" },
    .divergence = { divergence, 1, { 2, 5, 3, 1, 0, 0, 6, 4 }, { 6, 24, 0, 2, 0, 0, 9, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, s*s*((I1 - I3)/I1)*omega_tau - (I3/(R*I1))*V, a part of the divergence" },
    .integral_values = { integral_values, 2, { 0, 12, 10, 1, 0, 0, 9, 5 }, { 11, 43, 0, 1, 0, 0, 12, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*(R*I3)*gamma3 + G_level, s*omega3 + gamma3*omega_n, R*omega_tau + v_nu, F0" },
    .integral_gradients = { integral_gradients, 10, { 2, 24, 10, 1, 0, 0, 8, 11 }, { 18, 86, 0, 7, 0, 0, 10, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level + (R*I3)*omega3*gamma3, v_tau/R = ((1)/s)*(G_level + (R*I3)*omega3*gamma3)*gamma3*(1/(R*I1)) + omega3*s, d(v_tau)/d(gamma3)/(1/I1) = ((1)/s)*(R*I3)*omega3*gamma3 + ((1)/s)*(G_level + (R*I3)*omega3*gamma3), d(E)/d(gamma3), d(E)/d(omega3), d(v_tau)/d(s)/R, d(E)/d(s), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 2, 1, 1, 0, 0, 4, 2 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*(R*I3)*gamma3 + G_level" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .eliminated_state = 3, .level_integral = 1,
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular_on_level_omega_n,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_in_regular_on_level_omega_n) },
#endif
};
