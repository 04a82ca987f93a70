/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   18    5    1    1    0     12    6   (56)
 *  jacobian            5   38   17    1    1    0     14   13   (205)
 *  rhs_jacobian        7   39   17    1    1    0     19   15   (236)
 *  divergence          3   10    4    1    1    0     10    6   (36)
 *  integral_values     3   14    9    1    1    0     10    6   (58)
 *  integral_gradients  4   23   10    1    1    0     11   10   (104)
 *  eliminated          2    3    1    1    1    0      4    3   (10)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), omega3*gamma3*(R*I3) + G_level,
 *      a part of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3), V/R = (1/R)*v_nu + omega_tau,
 *      d(omega3)/dt, d(d(omega3)/dt)/d(omega3), a part of d(v_nu)/dt, d(d(omega_tau)/dt)/d(omega3),
 *      d(d(v_nu)/dt)/d(omega3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3),
 *      d(d(omega3)/dt)/d(omega_tau), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3)
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_avx512;

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
    const double t0 = params[1]*params[4]; /* R*I1 */
    out[37] = t0;
    const double t1 = 1.0/t0; /* 1/(R*I1) */
    out[7] = t1;
    const double t2 = params[1]*params[5]; /* R*I3 */
    out[8] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    out[38] = t4;
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    out[9] = t5;
    const double t6 = params[5]/params[4]; /* I3/I1 */
    out[10] = t6;
    const double t7 = params[4] - params[5]; /* I1 - I3 */
    const double t8 = t7/params[4]; /* (I1 - I3)/I1 */
    out[11] = t8;
    const double t9 = 1.0/params[1]; /* 1/R */
    out[12] = t9;
    const double t10 = params[4]*params[5]; /* I1*I3 */
    out[13] = t10;
    const double t11 = params[4]*t4; /* I1*m*R*R */
    out[14] = t11;
    const double t12 = params[5]*t4; /* I3*m*R*R */
    out[15] = t12;
    const double t13 = 1.0/params[4]; /* 1/I1 */
    out[16] = t13;
    const double t14 = t2/params[4]; /* R*I3/I1 */
    out[17] = t14;
    const double t15 = params[1]*2.0; /* R*2 */
    const double t16 = params[5]*t15; /* I3*R*2 */
    const double t17 = t16/params[4]; /* I3*R*2/I1 */
    out[18] = t17;
    const double t18 = params[4]*params[4]; /* I1*I1 */
    const double t19 = params[1]*t18; /* R*I1*I1 */
    const double t20 = params[5]/t19; /* I3/(R*I1*I1) */
    const double t21 = -t20; /* -I3/(R*I1*I1) */
    out[19] = t21;
    const double t22 = params[5]*(-2.0); /* I3*(-2) */
    const double t23 = t22/params[4]; /* I3*(-2)/I1 */
    out[20] = t23;
    const double t24 = params[5]*params[5]; /* I3*I3 */
    const double t25 = t24/t18; /* I3*I3/(I1*I1) */
    const double t26 = -t25; /* -I3*I3/(I1*I1) */
    out[21] = t26;
    const double t27 = t11*2.0; /* I1*m*R*R*2 */
    const double t28 = t12*2.0; /* I3*m*R*R*2 */
    const double t29 = t27 - t28; /* I1*m*R*R*2 - I3*m*R*R*2 */
    out[22] = t29;
    const double t30 = t4*t7; /* m*R*R*(I1 - I3) */
    out[23] = t30;
    const double t31 = params[1]*params[0]; /* R*m */
    const double t32 = params[4]*t31; /* I1*R*m */
    out[24] = t32;
    const double t33 = -t32; /* -I1*R*m */
    out[25] = t33;
    const double t34 = params[5]*t31; /* I3*R*m */
    out[26] = t34;
    const double t35 = t11 - t12; /* I1*m*R*R - I3*m*R*R */
    const double t36 = 2.0*t35; /* 2*(I1*m*R*R - I3*m*R*R) */
    const double t37 = t36/t11; /* 2*(I1*m*R*R - I3*m*R*R)/(I1*m*R*R) */
    out[27] = t37;
    const double t38 = (-1.0)/params[1]; /* (-1)/R */
    out[28] = t38;
    const double t39 = params[5]/t0; /* I3/(R*I1) */
    out[29] = t39;
    const double t40 = params[0]/2.0; /* m/2 */
    out[30] = t40;
    const double t41 = params[4]/2.0; /* I1/2 */
    out[31] = t41;
    const double t42 = params[5]/2.0; /* I3/2 */
    out[32] = t42;
    const double t43 = params[0]*t18; /* m*I1*I1 */
    out[33] = t43;
    const double t44 = t7*t11; /* (I1 - I3)*I1*m*R*R */
    out[34] = t44;
    const double t45 = params[4]*t3; /* I1*R*R */
    const double t46 = 1.0/t45; /* 1/(I1*R*R) */
    out[35] = t46;
    const double t47 = t31/params[4]; /* R*m/I1 */
    out[36] = t47;
    const double t48 = t7*(-2.0); /* (I1 - I3)*(-2) */
    const double t49 = t35*t48; /* (I1*m*R*R - I3*m*R*R)*(I1 - I3)*(-2) */
    out[39] = t49;
    const double t50 = params[0]*2.0; /* m*2 */
    const double t51 = t18*t50; /* I1*I1*m*2 */
    out[40] = t51;
    const double t52 = params[1]*t50; /* R*m*2 */
    const double t53 = t18*t52; /* I1*I1*R*m*2 */
    out[41] = t53;
    const double t54 = t3*t50; /* R*R*m*2 */
    const double t55 = params[4]*t54; /* I1*R*R*m*2 */
    const double t56 = t7*t55; /* (I1 - I3)*I1*R*R*m*2 */
    out[42] = t56;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t4 = p[9] + t2; /* I3/(m*R^2) + s^2 */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t6 = t2*t5; /* s^2*Theta/(m*R^2*I1) */
    const double t7 = 1.0/t6; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    const double t9 = t5*t8; /* Theta/(m*R^2*I1)*s */
    const double t10 = t7*t9; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t11 = t2*t7; /* s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t12 = x[2]*t8; /* omega_tau*s */
    out[0] = t12;
    const double t13 = x[0]*x[3]; /* gamma3*omega3 */
    const double t14 = JLT_FMA(p[8], t13, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t15 = p[7]*t14; /* 1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t16 = t10*t15; /* omega_n = 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t17 = x[0]*t10; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t18 = t16*t17; /* omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t19 = p[11]*t13; /* (I1 - I3)/I1*gamma3*omega3 */
    const double t20 = t12*t19; /* omega_tau*s*(I1 - I3)/I1*gamma3*omega3 */
    const double t21 = JLT_FMA(x[3], p[10], t18); /* omega3*I3/I1 + omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t22 = x[3] + t18; /* omega3 + omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t23 = t16*t21; /* omega_n*t21 */
    const double t24 = -t23; /* -omega_n*t21 */
    out[2] = t24;
    const double t25 = JLT_FMA(p[12], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t26 = JLT_FNMA(t16, t25, t20); /* omega_tau*s*(I1 - I3)/I1*gamma3*omega3 - omega_n*V/R */
    const double t27 = t11*t26; /* s^2*1/(s^2*Theta/(m*R^2*I1))*(omega_tau*s*(I1 - I3)/I1*gamma3*omega3 - omega_n*V/R) */
    out[3] = t27;
    const double t28 = p[1]*t16; /* R*omega_n */
    const double t29 = t22*t28; /* t22*R*omega_n */
    out[1] = t29;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = x[0]*p[15]; /* gamma3*m*R^2*I3 */
    const double t5 = JLT_FMA(x[0], t4, p[13]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = JLT_FMA(t2, p[14], t5); /* Theta = s^2*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t7 = t2*t6; /* s^2*Theta */
    const double t8 = 1.0/t7; /* 1/(s^2*Theta) */
    const double t9 = t3*t6; /* s*Theta */
    const double t10 = t8*t9; /* 1/(s^2*Theta)*s*Theta */
    const double t11 = x[0]*t10; /* gamma3*1/(s^2*Theta)*s*Theta */
    const double t12 = x[2]*t11; /* omega_tau*gamma3*1/(s^2*Theta)*s*Theta */
    const double t13 = -t12; /* -omega_tau*gamma3*1/(s^2*Theta)*s*Theta */
    out[0] = t13;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    const double t14 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t15 = JLT_FMA(x[3], t14, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t16 = t10*t15; /* 1/(s^2*Theta)*s*Theta*(omega3*gamma3*R*I3 + G_level) */
    const double t17 = p[7]*t16; /* 1/(R*I1)*1/(s^2*Theta)*s*Theta*(omega3*gamma3*R*I3 + G_level) */
    const double t18 = t10*t17; /* 1/(s^2*Theta)*s*Theta*t17 */
    const double t19 = t10*t18; /* 1/(s^2*Theta)*s*Theta*1/(s^2*Theta)*s*Theta*t17 */
    const double t20 = t18*t19; /* 1/(s^2*Theta)*s*Theta*t17*1/(s^2*Theta)*s*Theta*1/(s^2*Theta)*s*Theta*t17 */
    const double t21 = t11*t17; /* gamma3*1/(s^2*Theta)*s*Theta*t17 */
    const double t22 = JLT_FMA(x[3], p[10], t21); /* omega3*I3/I1 + gamma3*1/(s^2*Theta)*s*Theta*t17 */
    const double t23 = t10*t22; /* d(omega_n)/d(gamma3) = 1/(s^2*Theta)*s*Theta*(omega3*I3/I1 + gamma3*1/(s^2*Theta)*s*Theta*t17) */
    const double t24 = 2.0*t21; /* 2*gamma3*1/(s^2*Theta)*s*Theta*t17 */
    const double t25 = JLT_FMA(t23, t24, t20); /* d(omega_n)/d(gamma3)*2*gamma3*1/(s^2*Theta)*s*Theta*t17 + t20 */
    const double t26 = x[3]*t23; /* omega3*d(omega_n)/d(gamma3) */
    const double t27 = t25 + t26; /* t25 + omega3*d(omega_n)/d(gamma3) */
    const double t28 = p[1]*t27; /* R*(t25 + omega3*d(omega_n)/d(gamma3)) */
    out[4] = t28;
    const double t29 = t16*p[16]; /* 1/(s^2*Theta)*s*Theta*(omega3*gamma3*R*I3 + G_level)*1/I1 */
    const double t30 = t11*x[3]; /* gamma3*1/(s^2*Theta)*s*Theta*omega3 */
    const double t31 = t11*t21; /* gamma3*1/(s^2*Theta)*s*Theta*gamma3*1/(s^2*Theta)*s*Theta*t17 */
    const double t32 = JLT_FMA(p[17], t30, t29); /* R*I3/I1*gamma3*1/(s^2*Theta)*s*Theta*omega3 + 1/(s^2*Theta)*s*Theta*(omega3*gamma3*R*I3 + G_level)*1/I1 */
    const double t33 = JLT_FMA(p[18], t31, t32); /* 2*R*I3/I1*t31 + t32 */
    out[7] = t33;
    const double t34 = JLT_FMA(p[10], t26, t25); /* I3/I1*omega3*d(omega_n)/d(gamma3) + t25 */
    const double t35 = -t34; /* -(I3/I1*omega3*d(omega_n)/d(gamma3) + t25) */
    out[8] = t35;
    const double t36 = t16*p[19]; /* 1/(s^2*Theta)*s*Theta*(omega3*gamma3*R*I3 + G_level)*(-I3/(R*I1^2)) */
    const double t37 = JLT_FMA(t30, p[21], t36); /* gamma3*1/(s^2*Theta)*s*Theta*omega3*(-I3^2/I1^2) + t36 */
    const double t38 = JLT_FMA(t31, p[20], t37); /* t31*(-2*I3/I1) + gamma3*1/(s^2*Theta)*s*Theta*omega3*(-I3^2/I1^2) + t36 */
    out[11] = t38;
    const double t39 = x[0]*p[22]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t40 = t2*t8; /* 1/Theta = s^2*1/(s^2*Theta) */
    const double t41 = t3*t39; /* s*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t42 = JLT_FMS(t40, t41, t11); /* 1/Theta*s*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) - gamma3*1/(s^2*Theta)*s*Theta */
    const double t43 = JLT_FMA(x[0], t42, t3); /* gamma3*t42 + s */
    const double t44 = t40*p[23]; /* 1/Theta*m*R^2*(I1 - I3) */
    const double t45 = x[2]*t44; /* omega_tau*1/Theta*m*R^2*(I1 - I3) */
    const double t46 = x[3]*t45; /* omega3*omega_tau*1/Theta*m*R^2*(I1 - I3) */
    const double t47 = t43*t46; /* (gamma3*t42 + s)*omega3*omega_tau*1/Theta*m*R^2*(I1 - I3) */
    const double t48 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t49 = t40*t48; /* 1/Theta*V */
    const double t50 = t17*t40; /* t17*1/Theta */
    const double t51 = JLT_FMA(t39, t50, t23); /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*t17*1/Theta + d(omega_n)/d(gamma3) */
    const double t52 = p[24]*t49; /* m*R*I1*1/Theta*V */
    const double t53 = JLT_FNMA(t51, t52, t47); /* (gamma3*t42 + s)*omega3*omega_tau*1/Theta*m*R^2*(I1 - I3) - t51*m*R*I1*1/Theta*V */
    out[12] = t53;
    const double t54 = t50*p[25]; /* t17*1/Theta*(-m*R*I1) */
    out[13] = t54;
    const double t55 = x[0]*t3; /* gamma3*s */
    const double t56 = x[3]*t55; /* omega3*gamma3*s */
    const double t57 = t44*t56; /* 1/Theta*m*R^2*(I1 - I3)*omega3*gamma3*s */
    const double t58 = JLT_FNMA(p[14], t50, t57); /* 1/Theta*m*R^2*(I1 - I3)*omega3*gamma3*s - m*R^2*I1*t17*1/Theta */
    out[14] = t58;
    const double t59 = t45*t55; /* omega_tau*1/Theta*m*R^2*(I1 - I3)*gamma3*s */
    const double t60 = t11*p[26]; /* gamma3*1/(s^2*Theta)*s*Theta*m*R*I3 */
    const double t61 = JLT_FNMA(t49, t60, t59); /* omega_tau*1/Theta*m*R^2*(I1 - I3)*gamma3*s - 1/Theta*V*gamma3*1/(s^2*Theta)*s*Theta*m*R*I3 */
    out[15] = t61;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t4 = p[9] + t2; /* I3/(m*R^2) + s^2 */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t6 = t2*t5; /* s^2*Theta/(m*R^2*I1) */
    const double t7 = 1.0/t6; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t8 = t5*t7; /* 1/s^2 = Theta/(m*R^2*I1)*1/(s^2*Theta/(m*R^2*I1)) */
    const double t9 = t2*t7; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t10 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t10;
    const double t11 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t12 = JLT_FMA(x[3], t11, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t13 = t8*t10; /* 1/s^2*s */
    const double t14 = t12*t13; /* (omega3*gamma3*R*I3 + G_level)*1/s^2*s */
    const double t15 = p[7]*t14; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*1/s^2*s */
    const double t16 = x[0]*t13; /* gamma3*1/s^2*s */
    const double t17 = t15*t16; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*1/s^2*s*gamma3*1/s^2*s */
    const double t18 = JLT_FMA(x[3], p[10], t17); /* omega3*I3/I1 + t17 */
    const double t19 = t13*t18; /* d(omega_n)/d(gamma3) = 1/s^2*s*(omega3*I3/I1 + t17) */
    const double t20 = t15*t18; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*1/s^2*s*(omega3*I3/I1 + t17) */
    const double t21 = -t20; /* -t20 */
    out[2] = t21;
    const double t22 = x[0]*2.0; /* gamma3*2 */
    const double t23 = t19*t22; /* d(omega_n)/d(gamma3)*gamma3*2 */
    const double t24 = JLT_FMA(t8, t15, t23); /* 1/s^2*1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*1/s^2*s + d(omega_n)/d(gamma3)*gamma3*2 */
    const double t25 = t13*t24; /* 1/s^2*s*t24 */
    const double t26 = x[2]*t10; /* omega_tau*s */
    out[0] = t26;
    const double t27 = x[0]*t10; /* gamma3*s */
    const double t28 = p[11]*t9; /* (I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t29 = x[0]*t26; /* gamma3*omega_tau*s */
    const double t30 = x[3]*t28; /* omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t31 = t26*t30; /* omega_tau*s*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t32 = t28*t29; /* (I1 - I3)/I1*1/(Theta/(m*R^2*I1))*gamma3*omega_tau*s */
    const double t33 = t29*t30; /* gamma3*omega_tau*s*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t34 = JLT_FMA(p[12], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t35 = t9*t34; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t36 = JLT_FNMA(t15, t35, t33); /* gamma3*omega_tau*s*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*1/s^2*s*1/(Theta/(m*R^2*I1))*V/R */
    out[3] = t36;
    const double t37 = JLT_FNMA(t19, t35, t31); /* omega_tau*s*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - d(omega_n)/d(gamma3)*1/(Theta/(m*R^2*I1))*V/R */
    const double t38 = x[3]*t19; /* omega3*d(omega_n)/d(gamma3) */
    const double t39 = p[10]*t35; /* I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t40 = JLT_FNMA(t16, t39, t32); /* (I1 - I3)/I1*1/(Theta/(m*R^2*I1))*gamma3*omega_tau*s - gamma3*1/s^2*s*I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    out[19] = t40;
    const double t41 = x[2]*t16; /* omega_tau*gamma3*1/s^2*s */
    const double t42 = -t41; /* -omega_tau*gamma3*1/s^2*s */
    out[4] = t42;
    const double t43 = t30*t41; /* omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1))*omega_tau*gamma3*1/s^2*s */
    const double t44 = p[16]*t14; /* 1/I1*(omega3*gamma3*R*I3 + G_level)*1/s^2*s */
    const double t45 = p[19]*t14; /* (-I3/(R*I1^2))*(omega3*gamma3*R*I3 + G_level)*1/s^2*s */
    const double t46 = x[3]*t16; /* omega3*gamma3*1/s^2*s */
    const double t47 = t16*t17; /* gamma3*1/s^2*s*t17 */
    const double t48 = x[3] + t17; /* omega3 + t17 */
    const double t49 = t44*t48; /* 1/I1*(omega3*gamma3*R*I3 + G_level)*1/s^2*s*(omega3 + t17) */
    out[1] = t49;
    const double t50 = JLT_FMA(p[21], t46, t45); /* (-I3^2/I1^2)*omega3*gamma3*1/s^2*s + (-I3/(R*I1^2))*(omega3*gamma3*R*I3 + G_level)*1/s^2*s */
    const double t51 = JLT_FMA(p[20], t47, t50); /* (-2*I3/I1)*gamma3*1/s^2*s*t17 + t50 */
    out[15] = t51;
    const double t52 = JLT_FMA(p[17], t46, t44); /* R*I3/I1*omega3*gamma3*1/s^2*s + 1/I1*(omega3*gamma3*R*I3 + G_level)*1/s^2*s */
    const double t53 = JLT_FMA(p[18], t47, t52); /* 2*R*I3/I1*gamma3*1/s^2*s*t17 + t52 */
    out[11] = t53;
    const double t54 = t15*t25; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*1/s^2*s*1/s^2*s*t24 */
    const double t55 = JLT_FMA(p[10], t38, t54); /* I3/I1*omega3*d(omega_n)/d(gamma3) + 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*1/s^2*s*1/s^2*s*t24 */
    const double t56 = -t55; /* -t55 */
    out[12] = t56;
    const double t57 = p[1]*t38; /* R*omega3*d(omega_n)/d(gamma3) */
    const double t58 = JLT_FMA(t25, t44, t57); /* 1/s^2*s*t24*1/I1*(omega3*gamma3*R*I3 + G_level)*1/s^2*s + R*omega3*d(omega_n)/d(gamma3) */
    out[8] = t58;
    const double t59 = t9*t15; /* 1/(Theta/(m*R^2*I1))*1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*1/s^2*s */
    const double t60 = JLT_FMS(t27, t30, t59); /* gamma3*s*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - t59 */
    out[18] = t60;
    const double t61 = p[28]*t59; /* (-1/R)*t59 */
    out[17] = t61;
    const double t62 = p[27]*t9; /* 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t63 = JLT_FNMA(t36, t62, t43); /* t43 - t36*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t64 = JLT_FNMA(x[0], t63, t37); /* t37 - gamma3*t63 */
    out[16] = t64;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t4 = p[9] + t2; /* I3/(m*R^2) + s^2 */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t6 = t2*t5; /* s^2*Theta/(m*R^2*I1) */
    const double t7 = 1.0/t6; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t8 = t5*t7; /* Theta/(m*R^2*I1)*1/(s^2*Theta/(m*R^2*I1)) */
    const double t9 = t2*t7; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t10 = sqrt(t2); /* s = sqrt(s^2) */
    const double t11 = x[0]*t10; /* gamma3*s */
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t13 = p[29]*t12; /* I3/(R*I1)*V */
    const double t14 = JLT_FMA(t9, t13, x[2]); /* 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V + omega_tau */
    const double t15 = p[11]*x[2]; /* (I1 - I3)/I1*omega_tau */
    const double t16 = t9*t15; /* 1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*omega_tau */
    const double t17 = JLT_FNMA(t8, t14, t16); /* 1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*omega_tau - Theta/(m*R^2*I1)*1/(s^2*Theta/(m*R^2*I1))*(1/(Theta/(m*R^2*I1))*I3/(R*I1)*V + omega_tau) */
    const double t18 = t11*t17; /* gamma3*s*t17 */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt(s^2) */
    const double t5 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t6 = JLT_FMA(x[3], t5, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t7 = p[7]*t6; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t8 = t7/t3; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)/s^2 */
    const double t9 = t4*t8; /* omega_n = s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level)/s^2 */
    const double t10 = x[0]*t9; /* gamma3*omega_n */
    const double t11 = JLT_FMA(t4, x[3], t10); /* s*omega3 + gamma3*omega_n */
    const double t12 = p[1]*t11; /* v_tau = R*(s*omega3 + gamma3*omega_n) */
    const double t13 = JLT_FMA(t12, t12, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t14 = t9*t9; /* omega_n*omega_n */
    const double t15 = JLT_FMA(x[2], x[2], t14); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t16 = p[31]*t15; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t17 = x[3]*x[3]; /* omega3*omega3 */
    const double t18 = JLT_FMA(p[32], t17, t16); /* 1/2*I3*omega3*omega3 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t19 = JLT_FMA(p[30], t13, t18); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t18 */
    out[0] = t19;
    const double t20 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t21 = p[33]*t20; /* m*I1^2*(R*omega_tau + v_nu) */
    const double t22 = t20*t21; /* (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    const double t23 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t24 = t3 + p[9]; /* s^2 + I3/(m*R^2) */
    const double t25 = JLT_FMA(x[0], t23, t24); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s^2 + I3/(m*R^2) */
    const double t26 = t17*p[34]; /* omega3*omega3*m*R^2*I1*(I1 - I3) */
    const double t27 = JLT_FMA(t25, t26, t22); /* Theta/(m*R^2*I1)*omega3*omega3*m*R^2*I1*(I1 - I3) + (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    out[1] = t27;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = p[9] + t4; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t7 = x[0]*x[3]; /* gamma3*omega3 */
    const double t8 = 1.0/t5; /* 1/s */
    const double t9 = JLT_FMA(p[8], t7, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t10 = t8*t9; /* 1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t11 = x[0]*t10; /* gamma3*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t12 = t8*t11; /* 1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t13 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t14 = x[0]*t13; /* gamma3*gamma3*I3/I1 */
    const double t15 = t6 + t14; /* Theta/(m*R^2*I1) = I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) + gamma3*gamma3*I3/I1 */
    const double t16 = JLT_FMA(t8, t14, t5); /* d(v_tau)/d(omega3)/R = 1/s*gamma3*gamma3*I3/I1 + s */
    const double t17 = x[3]*t5; /* omega3*s */
    const double t18 = JLT_FMA(p[7], t11, t17); /* v_tau/R = 1/(R*I1)*gamma3*1/s*(R*I3*gamma3*omega3 + G_level) + omega3*s */
    const double t19 = p[38]*t16; /* m*R^2*d(v_tau)/d(omega3)/R */
    const double t20 = JLT_FMA(p[8], x[3], t12); /* R*I3*omega3 + 1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t21 = t8*t20; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/s*(R*I3*omega3 + 1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level)) */
    const double t22 = p[37]*t7; /* R*I1*gamma3*omega3 */
    const double t23 = JLT_FNMA(t8, t22, t10); /* 1/s*(R*I3*gamma3*omega3 + G_level) - 1/s*R*I1*gamma3*omega3 */
    const double t24 = p[35]*t10; /* 1/(R^2*I1)*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t25 = t21*t24; /* d(omega_n)/d(gamma3)/(1/(R*I1))*1/(R^2*I1)*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t26 = JLT_FMA(x[0], t21, t23); /* d(v_tau)/d(gamma3)/(1/I1) = gamma3*d(omega_n)/d(gamma3)/(1/(R*I1)) + 1/s*(R*I3*gamma3*omega3 + G_level) - 1/s*R*I1*gamma3*omega3 */
    const double t27 = x[3]*p[5]; /* omega3*I3 */
    const double t28 = JLT_FMA(p[29], t12, t27); /* I3/(R*I1)*1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level) + omega3*I3 */
    const double t29 = JLT_FMA(t18, t19, t28); /* d(energy)/d(omega3) = v_tau/R*m*R^2*d(v_tau)/d(omega3)/R + t28 */
    out[3] = t29;
    const double t30 = p[36]*t18; /* m*R/I1*v_tau/R */
    const double t31 = JLT_FMA(t26, t30, t25); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/(1/I1)*m*R/I1*v_tau/R + t25 */
    out[0] = t31;
    const double t32 = x[3]*p[39]; /* omega3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    const double t33 = t7*t32; /* gamma3*omega3*omega3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    out[4] = t33;
    const double t34 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t35 = p[40]*t34; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[5] = t35;
    const double t36 = p[41]*t34; /* 2*m*R*I1^2*(omega_tau*R + v_nu) */
    out[6] = t36;
    const double t37 = x[3]*p[42]; /* omega3*2*m*R^2*I1*(I1 - I3) */
    const double t38 = t15*t37; /* Theta/(m*R^2*I1)*omega3*2*m*R^2*I1*(I1 - I3) */
    out[7] = t38;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t5 = JLT_FMA(x[3], t4, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t6 = p[7]*t5; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t7 = t6/t3; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)/s */
    out[0] = t7;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
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
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t13[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t14[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t15[k] = jlt_jet_product(t13, t14, k);
        t16[k] = x0[k]*p[10];
        t17[k] = (k == 0 ? p[9] : 0) + t15[k];
        t18[k] = jlt_jet_product(x0, t16, k) + t17[k];
        t19[k] = jlt_jet_root(t15[k], t19, k);
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t20, t21, k);
        t22[k] = jlt_jet_product(t18, t21, k);
        t23[k] = jlt_jet_product(t19, t21, k);
        t24[k] = jlt_jet_product(x2, t19, k);
        t25[k] = jlt_jet_product(x0, x3, k);
        t26[k] = p[8]*t25[k] + (k == 0 ? p[6] : 0);
        t27[k] = p[7]*t26[k];
        t28[k] = jlt_jet_product(t22, t27, k);
        t29[k] = jlt_jet_product(x0, t22, k);
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = p[11]*t25[k];
        t32[k] = jlt_jet_product(t24, t31, k);
        t33[k] = x3[k]*p[10] + t30[k];
        t34[k] = x3[k] + t30[k];
        t35[k] = jlt_jet_product(t28, t33, k);
        t36[k] = -t35[k];
        t37[k] = p[12]*x1[k] + x2[k];
        t38[k] = t32[k] - jlt_jet_product(t28, t37, k);
        t39[k] = jlt_jet_product(t23, t38, k);
        t40[k] = p[1]*t28[k];
        t41[k] = jlt_jet_product(t34, t40, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t24[k]/(k + 1);
        next[1] = x1[k + 1] = t41[k]/(k + 1);
        next[2] = x2[k + 1] = t36[k]/(k + 1);
        next[3] = x3[k + 1] = t39[k]/(k + 1);
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
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
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
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 43,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 18, 5, 1, 1, 0, 12, 6 }, { 10, 39, 0, 6, 1, 0, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in (R*I3)*gamma3*omega3 + G_level, a part of d(omega_tau)/dt, omega3 + omega_n*gamma3*((1)/s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s, V/R = (1/R)*v_nu + omega_tau, omega_tau*s*((I1 - I3)/I1)*gamma3*omega3 - omega_n*V/R" },
    .jacobian = { jacobian, 16, { 5, 38, 17, 1, 1, 0, 14, 13 }, { 33, 145, 0, 26, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega3), 2*m*R^2*I1 - 2*m*R^2*I3, a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), V = omega_tau*R + v_nu, a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(omega_tau), d(d(omega3)/dt)/d(omega3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 39, 17, 1, 1, 0, 19, 15 }, { 38, 166, 0, 31, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), omega3*gamma3*(R*I3) + G_level, a part of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3), V/R = (1/R)*v_nu + omega_tau, d(omega3)/dt, d(d(omega3)/dt)/d(omega3), a part of d(v_nu)/dt, d(d(omega_tau)/dt)/d(omega3), d(d(v_nu)/dt)/d(omega3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), d(d(omega3)/dt)/d(omega_tau), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 3, 10, 4, 1, 1, 0, 10, 6 }, { 7, 25, 0, 3, 1, 0, 10, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, 1/(Theta/(m*R^2*I1))*(I3/(R*I1))*V + omega_tau, a part of the divergence" },
    .integral_values = { integral_values, 2, { 3, 14, 9, 1, 1, 0, 10, 6 }, { 12, 44, 0, 1, 1, 0, 12, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level, s*omega3 + gamma3*omega_n, R*omega_tau + v_nu, F0" },
    .integral_gradients = { integral_gradients, 8, { 4, 23, 10, 1, 1, 0, 11, 10 }, { 18, 79, 0, 6, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in -2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3), (R*I3)*gamma3*omega3 + G_level, v_tau/R = (1/(R*I1))*gamma3*((1)/s)*((R*I3)*gamma3*omega3 + G_level) + omega3*s, (R*I3)*omega3 + ((1)/s)*gamma3*((1)/s)*((R*I3)*gamma3*omega3 + G_level), d(v_tau)/d(gamma3)/(1/I1), d(E)/d(omega3), d(E)/d(gamma3), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 3, 1, 1, 1, 0, 4, 3 }, { 2, 6, 0, 1, 1, 0, 5, 3 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_on_level_G,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_balanced_on_level_G_baseline,
        &jlt_batch_spherical_top_balanced_on_level_G_avx2,
        &jlt_batch_spherical_top_balanced_on_level_G_avx512,
    },
#endif
};
