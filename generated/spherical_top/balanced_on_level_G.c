/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   17    5    1    1    0     12    6   (56)
 *  jacobian            5   36   17    1    1    0     15   11   (205)
 *  rhs_jacobian        5   40   17    1    1    0     15   14   (236)
 *  divergence          3   10    4    1    1    0     11    5   (36)
 *  integral_values     3   13    9    1    1    0      9    6   (58)
 *  integral_gradients  4   23   10    1    1    0     11   10   (104)
 *  eliminated          2    3    1    1    1    0      4    3   (10)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G;
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
    out[38] = t0;
    const double t1 = 1.0/t0; /* 1/(R*I1) */
    out[7] = t1;
    const double t2 = params[1]*params[5]; /* R*I3 */
    out[8] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    out[39] = t4;
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    out[9] = t5;
    const double t6 = params[5]/params[4]; /* I3/I1 */
    out[10] = t6;
    const double t7 = params[4] - params[5]; /* I1 - I3 */
    const double t8 = t7/params[4]; /* (I1 - I3)/I1 */
    out[11] = t8;
    const double t9 = 1.0/params[1]; /* 1/R */
    out[12] = t9;
    const double t10 = 1.0/params[4]; /* 1/I1 */
    out[13] = t10;
    const double t11 = 2.0/t0; /* 2/(R*I1) */
    out[14] = t11;
    const double t12 = t2/params[4]; /* R*I3/I1 */
    out[15] = t12;
    const double t13 = params[1]*2.0; /* R*2 */
    const double t14 = params[5]*t13; /* I3*R*2 */
    const double t15 = t14/params[4]; /* I3*R*2/I1 */
    out[16] = t15;
    const double t16 = params[4]*params[4]; /* I1*I1 */
    const double t17 = params[1]*t16; /* R*I1*I1 */
    const double t18 = params[5]/t17; /* I3/(R*I1*I1) */
    out[17] = t18;
    const double t19 = -t6; /* -I3/I1 */
    out[18] = t19;
    const double t20 = params[5]*(-2.0); /* I3*(-2) */
    const double t21 = t20/params[4]; /* I3*(-2)/I1 */
    out[19] = t21;
    const double t22 = params[5]*params[5]; /* I3*I3 */
    const double t23 = t22/t16; /* I3*I3/(I1*I1) */
    const double t24 = -t23; /* -I3*I3/(I1*I1) */
    out[20] = t24;
    const double t25 = params[4]*t4; /* I1*m*R*R */
    const double t26 = params[5]*t4; /* I3*m*R*R */
    const double t27 = t25 - t26; /* I1*m*R*R - I3*m*R*R */
    const double t28 = 2.0*t27; /* 2*(I1*m*R*R - I3*m*R*R) */
    const double t29 = t28/t25; /* 2*(I1*m*R*R - I3*m*R*R)/(I1*m*R*R) */
    out[21] = t29;
    const double t30 = params[4]*t3; /* I1*R*R */
    const double t31 = 1.0/t30; /* 1/(I1*R*R) */
    out[22] = t31;
    const double t32 = params[1]*params[0]; /* R*m */
    const double t33 = t28/t32; /* 2*(I1*m*R*R - I3*m*R*R)/(R*m) */
    out[23] = t33;
    const double t34 = (-1.0)/params[1]; /* (-1)/R */
    out[24] = t34;
    const double t35 = params[5]/t0; /* I3/(R*I1) */
    out[25] = t35;
    const double t36 = (-1.0)/t0; /* (-1)/(R*I1) */
    out[26] = t36;
    const double t37 = 1.0/t17; /* 1/(R*I1*I1) */
    out[27] = t37;
    const double t38 = params[4]*t13; /* I1*R*2 */
    out[28] = t38;
    const double t39 = t3*t16; /* R*R*I1*I1 */
    const double t40 = (-1.0)/t39; /* (-1)/(R*R*I1*I1) */
    out[29] = t40;
    const double t41 = -t18; /* -I3/(R*I1*I1) */
    out[30] = t41;
    const double t42 = (-1.0)/t30; /* (-1)/(I1*R*R) */
    out[31] = t42;
    const double t43 = params[0]/2.0; /* m/2 */
    out[32] = t43;
    const double t44 = params[4]/2.0; /* I1/2 */
    out[33] = t44;
    const double t45 = params[5]/2.0; /* I3/2 */
    out[34] = t45;
    const double t46 = params[0]*t16; /* m*I1*I1 */
    out[35] = t46;
    const double t47 = t7*t25; /* (I1 - I3)*I1*m*R*R */
    out[36] = t47;
    const double t48 = t32/params[4]; /* R*m/I1 */
    out[37] = t48;
    const double t49 = t7*(-2.0); /* (I1 - I3)*(-2) */
    const double t50 = t27*t49; /* (I1*m*R*R - I3*m*R*R)*(I1 - I3)*(-2) */
    out[40] = t50;
    const double t51 = params[0]*2.0; /* m*2 */
    const double t52 = t16*t51; /* I1*I1*m*2 */
    out[41] = t52;
    const double t53 = params[1]*t51; /* R*m*2 */
    const double t54 = t16*t53; /* I1*I1*R*m*2 */
    out[42] = t54;
    const double t55 = t3*t51; /* R*R*m*2 */
    const double t56 = params[4]*t55; /* I1*R*R*m*2 */
    const double t57 = t7*t56; /* (I1 - I3)*I1*R*R*m*2 */
    out[43] = t57;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t4 = p[9] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = t5*t6; /* Theta/(m*R^2*I1)*s */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*s) */
    const double t9 = t5*t8; /* 1/s = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s) */
    const double t10 = t6*t8; /* s*1/(Theta/(m*R^2*I1)*s) */
    const double t11 = x[2]*t6; /* omega_tau*s */
    out[0] = t11;
    const double t12 = x[0]*x[3]; /* gamma3*omega3 */
    const double t13 = JLT_FMA(p[8], t12, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t14 = p[7]*t13; /* 1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t15 = t9*t14; /* omega_n = 1/s*1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t16 = x[0]*t9; /* gamma3*1/s */
    const double t17 = t15*t16; /* omega_n*gamma3*1/s */
    const double t18 = p[11]*t12; /* (I1 - I3)/I1*gamma3*omega3 */
    const double t19 = t11*t18; /* omega_tau*s*(I1 - I3)/I1*gamma3*omega3 */
    const double t20 = JLT_FMA(x[3], p[10], t17); /* omega3*I3/I1 + omega_n*gamma3*1/s */
    const double t21 = x[3] + t17; /* omega3 + omega_n*gamma3*1/s */
    const double t22 = t15*t20; /* omega_n*(omega3*I3/I1 + omega_n*gamma3*1/s) */
    const double t23 = -t22; /* -omega_n*(omega3*I3/I1 + omega_n*gamma3*1/s) */
    out[2] = t23;
    const double t24 = JLT_FMA(p[12], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t25 = JLT_FNMA(t15, t24, t19); /* omega_tau*s*(I1 - I3)/I1*gamma3*omega3 - omega_n*V/R */
    const double t26 = t10*t25; /* s*1/(Theta/(m*R^2*I1)*s)*(omega_tau*s*(I1 - I3)/I1*gamma3*omega3 - omega_n*V/R) */
    out[3] = t26;
    const double t27 = p[1]*t15; /* R*omega_n */
    const double t28 = t21*t27; /* (omega3 + omega_n*gamma3*1/s)*R*omega_n */
    out[1] = t28;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t4 = p[9] + t2; /* I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t6;
    const double t7 = t5*t6; /* Theta/(m*R^2*I1)*s */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*s) */
    const double t9 = t5*t8; /* 1/s = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s) */
    const double t10 = x[0]*t9; /* gamma3*1/s */
    const double t11 = x[2]*t10; /* omega_tau*gamma3*1/s */
    const double t12 = -t11; /* -omega_tau*gamma3*1/s */
    out[0] = t12;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    const double t13 = x[3]*p[8]; /* omega3*R*I3 */
    const double t14 = JLT_FMA(x[0], t13, p[6]); /* gamma3*omega3*R*I3 + G_level */
    const double t15 = t9*t14; /* 1/s*(gamma3*omega3*R*I3 + G_level) */
    const double t16 = JLT_FMA(t10, t15, t13); /* gamma3*1/s*1/s*(gamma3*omega3*R*I3 + G_level) + omega3*R*I3 */
    const double t17 = t9*t16; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/s*(gamma3*1/s*1/s*(gamma3*omega3*R*I3 + G_level) + omega3*R*I3) */
    const double t18 = x[3]*t17; /* omega3*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    const double t19 = p[13]*t18; /* 1/I1*omega3*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    const double t20 = t15*p[7]; /* omega_n = 1/s*(gamma3*omega3*R*I3 + G_level)*1/(R*I1) */
    const double t21 = t9*t20; /* 1/s*omega_n */
    const double t22 = t9*t21; /* 1/s*1/s*omega_n */
    const double t23 = t21*t22; /* 1/s*omega_n*1/s*1/s*omega_n */
    const double t24 = t10*t20; /* gamma3*1/s*omega_n */
    const double t25 = p[14]*t24; /* 2/(R*I1)*gamma3*1/s*omega_n */
    const double t26 = JLT_FMA(t17, t25, t23); /* d(omega_n)/d(gamma3)/(1/(R*I1))*2/(R*I1)*gamma3*1/s*omega_n + 1/s*omega_n*1/s*1/s*omega_n */
    const double t27 = JLT_FMA(p[1], t26, t19); /* R*t26 + 1/I1*omega3*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    out[4] = t27;
    const double t28 = p[1]*t20; /* R*omega_n */
    const double t29 = t10*x[3]; /* gamma3*1/s*omega3 */
    const double t30 = t10*t24; /* gamma3*1/s*gamma3*1/s*omega_n */
    const double t31 = JLT_FMA(p[15], t29, t28); /* R*I3/I1*gamma3*1/s*omega3 + R*omega_n */
    const double t32 = JLT_FMA(p[16], t30, t31); /* 2*R*I3/I1*gamma3*1/s*gamma3*1/s*omega_n + R*I3/I1*gamma3*1/s*omega3 + R*omega_n */
    out[7] = t32;
    const double t33 = JLT_FMA(t18, p[17], t26); /* omega3*d(omega_n)/d(gamma3)/(1/(R*I1))*I3/(R*I1^2) + t26 */
    const double t34 = -t33; /* -(omega3*d(omega_n)/d(gamma3)/(1/(R*I1))*I3/(R*I1^2) + t26) */
    out[8] = t34;
    const double t35 = t20*p[18]; /* omega_n*(-I3/I1) */
    const double t36 = JLT_FMA(t29, p[20], t35); /* gamma3*1/s*omega3*(-I3^2/I1^2) + omega_n*(-I3/I1) */
    const double t37 = JLT_FMA(t30, p[19], t36); /* gamma3*1/s*gamma3*1/s*omega_n*(-2*I3/I1) + gamma3*1/s*omega3*(-I3^2/I1^2) + omega_n*(-I3/I1) */
    out[11] = t37;
    const double t38 = t6*t8; /* 1/(Theta/(m*R^2*I1)) = s*1/(Theta/(m*R^2*I1)*s) */
    const double t39 = x[0]*t6; /* gamma3*s */
    const double t40 = t38*t39; /* 1/(Theta/(m*R^2*I1))*gamma3*s */
    const double t41 = JLT_FNMA(p[21], t40, t10); /* gamma3*1/s - 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1)*1/(Theta/(m*R^2*I1))*gamma3*s */
    const double t42 = JLT_FNMA(x[0], t41, t6); /* s - gamma3*t41 */
    const double t43 = x[3]*p[11]; /* omega3*(I1 - I3)/I1 */
    const double t44 = x[2]*t43; /* omega_tau*omega3*(I1 - I3)/I1 */
    const double t45 = t42*t44; /* (s - gamma3*t41)*omega_tau*omega3*(I1 - I3)/I1 */
    const double t46 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t47 = t20*t38; /* omega_n*1/(Theta/(m*R^2*I1)) */
    const double t48 = x[0]*p[23]; /* gamma3*2*(m*R^2*I1 - m*R^2*I3)/(m*R) */
    const double t49 = JLT_FMA(t47, t48, t17); /* omega_n*1/(Theta/(m*R^2*I1))*gamma3*2*(m*R^2*I1 - m*R^2*I3)/(m*R) + d(omega_n)/d(gamma3)/(1/(R*I1)) */
    const double t50 = p[22]*t46; /* 1/(R^2*I1)*V */
    const double t51 = JLT_FNMA(t49, t50, t45); /* (s - gamma3*t41)*omega_tau*omega3*(I1 - I3)/I1 - t49*1/(R^2*I1)*V */
    const double t52 = t38*t51; /* 1/(Theta/(m*R^2*I1))*t51 */
    out[12] = t52;
    const double t53 = t47*p[24]; /* omega_n*1/(Theta/(m*R^2*I1))*(-1/R) */
    out[13] = t53;
    const double t54 = JLT_FMS(t40, t43, t47); /* 1/(Theta/(m*R^2*I1))*gamma3*s*omega3*(I1 - I3)/I1 - omega_n*1/(Theta/(m*R^2*I1)) */
    out[14] = t54;
    const double t55 = x[2]*p[11]; /* omega_tau*(I1 - I3)/I1 */
    const double t56 = t40*t55; /* 1/(Theta/(m*R^2*I1))*gamma3*s*omega_tau*(I1 - I3)/I1 */
    const double t57 = t46*p[25]; /* V*I3/(R*I1) */
    const double t58 = t38*t57; /* 1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    const double t59 = JLT_FNMA(t10, t58, t56); /* 1/(Theta/(m*R^2*I1))*gamma3*s*omega_tau*(I1 - I3)/I1 - gamma3*1/s*1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    out[15] = t59;
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
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t4 = p[9] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[6] = t6;
    const double t7 = t5*t6; /* Theta/(m*R^2*I1)*s */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*s) */
    const double t9 = t5*t8; /* 1/s = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s) */
    const double t10 = t6*t8; /* 1/(Theta/(m*R^2*I1)) = s*1/(Theta/(m*R^2*I1)*s) */
    const double t11 = x[0]*x[3]; /* gamma3*omega3 */
    const double t12 = JLT_FMA(p[8], t11, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t13 = t9*t12; /* 1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t14 = x[0]*t9; /* gamma3*1/s */
    const double t15 = t13*t14; /* 1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*1/s */
    const double t16 = x[2]*t6; /* omega_tau*s */
    out[0] = t16;
    const double t17 = p[7]*t15; /* 1/(R*I1)*1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*1/s */
    const double t18 = p[28]*t15; /* 2*R*I1*1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*1/s */
    const double t19 = p[11]*t10; /* (I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t20 = t11*t19; /* gamma3*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t21 = t16*t19; /* omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t22 = t16*t20; /* omega_tau*s*gamma3*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t23 = t9*t13; /* 1/s*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t24 = JLT_FMA(x[3], p[10], t17); /* omega3*I3/I1 + 1/(R*I1)*1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*1/s */
    const double t25 = t10*t13; /* 1/(Theta/(m*R^2*I1))*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t26 = p[31]*t25; /* (-1/(R^2*I1))*1/(Theta/(m*R^2*I1))*1/s*(R*I3*gamma3*omega3 + G_level) */
    out[17] = t26;
    const double t27 = p[7]*t25; /* 1/(R*I1)*1/(Theta/(m*R^2*I1))*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t28 = JLT_FMS(t6, t20, t27); /* s*gamma3*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - t27 */
    out[18] = t28;
    const double t29 = t9*t23; /* 1/s*1/s*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t30 = t23*t29; /* 1/s*1/s*(R*I3*gamma3*omega3 + G_level)*1/s*1/s*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t31 = t9*t24; /* d(omega_n)/d(gamma3) = 1/s*t24 */
    const double t32 = JLT_FMA(t18, t31, t30); /* 2*R*I1*1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*1/s*d(omega_n)/d(gamma3) + t30 */
    const double t33 = JLT_FMA(p[12], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t34 = JLT_FNMA(t27, t33, t22); /* omega_tau*s*gamma3*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - t27*V/R */
    out[3] = t34;
    const double t35 = t10*t33; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t36 = x[2]*t14; /* omega_tau*gamma3*1/s */
    const double t37 = -t36; /* -omega_tau*gamma3*1/s */
    out[4] = t37;
    const double t38 = x[3]*t21; /* omega3*omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t39 = JLT_FNMA(t20, t36, t38); /* omega3*omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - gamma3*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1))*omega_tau*gamma3*1/s */
    const double t40 = x[0]*t21; /* gamma3*omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t41 = x[0]*p[21]; /* gamma3*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t42 = t10*t41; /* 1/(Theta/(m*R^2*I1))*gamma3*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t43 = JLT_FMA(t34, t42, t39); /* t34*t42 + t39 */
    const double t44 = JLT_FNMA(t31, t35, t43); /* t34*t42 + t39 - d(omega_n)/d(gamma3)*1/(Theta/(m*R^2*I1))*V/R */
    out[16] = t44;
    const double t45 = x[3]*t31; /* omega3*d(omega_n)/d(gamma3) */
    const double t46 = p[13]*t13; /* 1/I1*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t47 = x[3]*t14; /* omega3*gamma3*1/s */
    const double t48 = p[30]*t13; /* (-I3/(R*I1^2))*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t49 = p[26]*t13; /* (-1/(R*I1))*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t50 = t24*t49; /* t24*(-1/(R*I1))*1/s*(R*I3*gamma3*omega3 + G_level) */
    out[2] = t50;
    const double t51 = JLT_FMA(p[20], t47, t48); /* (-I3^2/I1^2)*omega3*gamma3*1/s + (-I3/(R*I1^2))*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t52 = JLT_FMA(p[15], t47, t46); /* R*I3/I1*omega3*gamma3*1/s + 1/I1*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t53 = x[3] + t17; /* omega3 + 1/(R*I1)*1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*1/s */
    const double t54 = t46*t53; /* 1/I1*1/s*(R*I3*gamma3*omega3 + G_level)*t53 */
    out[1] = t54;
    const double t55 = t14*t17; /* gamma3*1/s*1/(R*I1)*1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*1/s */
    const double t56 = JLT_FMA(p[16], t55, t52); /* 2*R*I3/I1*t55 + t52 */
    out[11] = t56;
    const double t57 = JLT_FMA(p[19], t55, t51); /* (-2*I3/I1)*t55 + t51 */
    out[15] = t57;
    const double t58 = p[10]*t14; /* I3/I1*gamma3*1/s */
    const double t59 = JLT_FNMA(t35, t58, t40); /* gamma3*omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - 1/(Theta/(m*R^2*I1))*V/R*I3/I1*gamma3*1/s */
    out[19] = t59;
    const double t60 = p[1]*t45; /* R*omega3*d(omega_n)/d(gamma3) */
    const double t61 = JLT_FMA(p[27], t32, t60); /* 1/(R*I1^2)*t32 + R*omega3*d(omega_n)/d(gamma3) */
    out[8] = t61;
    const double t62 = p[29]*t32; /* (-1/(R^2*I1^2))*t32 */
    const double t63 = JLT_FMA(p[18], t45, t62); /* (-I3/I1)*omega3*d(omega_n)/d(gamma3) + (-1/(R^2*I1^2))*t32 */
    out[12] = t63;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t5 = t2 + p[9]; /* (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t6 = JLT_FMA(x[0], t4, t5); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t7 = t3*t6; /* s*Theta/(m*R^2*I1) */
    const double t8 = 1.0/t7; /* 1/(s*Theta/(m*R^2*I1)) */
    const double t9 = t3*t8; /* 1/(Theta/(m*R^2*I1)) = s*1/(s*Theta/(m*R^2*I1)) */
    const double t10 = p[11]*t3; /* (I1 - I3)/I1*s */
    const double t11 = t6*t8; /* 1/s = Theta/(m*R^2*I1)*1/(s*Theta/(m*R^2*I1)) */
    const double t12 = JLT_FMS(t9, t10, t11); /* 1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*s - 1/s */
    const double t13 = x[2]*t12; /* omega_tau*(1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*s - 1/s) */
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t15 = p[25]*t14; /* I3/(R*I1)*V */
    const double t16 = t9*t15; /* 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t17 = JLT_FNMA(t11, t16, t13); /* omega_tau*(1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*s - 1/s) - 1/s*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t18 = x[0]*t17; /* gamma3*t17 */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* (1 - gamma3)*(1 + gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t5 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t6 = JLT_FMA(x[3], t5, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t7 = p[7]*t6; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t8 = t7/t4; /* omega_n = 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)/s */
    const double t9 = x[0]*t8; /* gamma3*omega_n */
    const double t10 = JLT_FMA(t4, x[3], t9); /* s*omega3 + gamma3*omega_n */
    const double t11 = p[1]*t10; /* v_tau = R*(s*omega3 + gamma3*omega_n) */
    const double t12 = JLT_FMA(t11, t11, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t13 = t8*t8; /* omega_n*omega_n */
    const double t14 = JLT_FMA(x[2], x[2], t13); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t15 = p[33]*t14; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t16 = x[3]*x[3]; /* omega3*omega3 */
    const double t17 = JLT_FMA(p[34], t16, t15); /* 1/2*I3*omega3*omega3 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t18 = JLT_FMA(p[32], t12, t17); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t17 */
    out[0] = t18;
    const double t19 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t20 = p[35]*t19; /* m*I1^2*(R*omega_tau + v_nu) */
    const double t21 = t19*t20; /* (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    const double t22 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t23 = t3 + p[9]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t24 = JLT_FMA(x[0], t22, t23); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t25 = t16*p[36]; /* omega3*omega3*m*R^2*I1*(I1 - I3) */
    const double t26 = JLT_FMA(t24, t25, t21); /* Theta/(m*R^2*I1)*omega3*omega3*m*R^2*I1*(I1 - I3) + (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    out[1] = t26;
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
    const double t19 = p[39]*t16; /* m*R^2*d(v_tau)/d(omega3)/R */
    const double t20 = JLT_FMA(p[8], x[3], t12); /* R*I3*omega3 + 1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t21 = t8*t20; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/s*(R*I3*omega3 + 1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level)) */
    const double t22 = p[38]*t7; /* R*I1*gamma3*omega3 */
    const double t23 = JLT_FNMA(t8, t22, t10); /* 1/s*(R*I3*gamma3*omega3 + G_level) - 1/s*R*I1*gamma3*omega3 */
    const double t24 = p[22]*t10; /* 1/(R^2*I1)*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t25 = t21*t24; /* d(omega_n)/d(gamma3)/(1/(R*I1))*1/(R^2*I1)*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t26 = JLT_FMA(x[0], t21, t23); /* d(v_tau)/d(gamma3)/(1/I1) = gamma3*d(omega_n)/d(gamma3)/(1/(R*I1)) + 1/s*(R*I3*gamma3*omega3 + G_level) - 1/s*R*I1*gamma3*omega3 */
    const double t27 = x[3]*p[5]; /* omega3*I3 */
    const double t28 = JLT_FMA(p[25], t12, t27); /* I3/(R*I1)*1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level) + omega3*I3 */
    const double t29 = JLT_FMA(t18, t19, t28); /* d(energy)/d(omega3) = v_tau/R*m*R^2*d(v_tau)/d(omega3)/R + t28 */
    out[3] = t29;
    const double t30 = p[37]*t18; /* m*R/I1*v_tau/R */
    const double t31 = JLT_FMA(t26, t30, t25); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/(1/I1)*m*R/I1*v_tau/R + t25 */
    out[0] = t31;
    const double t32 = x[3]*p[40]; /* omega3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    const double t33 = t7*t32; /* gamma3*omega3*omega3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    out[4] = t33;
    const double t34 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t35 = p[41]*t34; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[5] = t35;
    const double t36 = p[42]*t34; /* 2*m*R*I1^2*(omega_tau*R + v_nu) */
    out[6] = t36;
    const double t37 = x[3]*p[43]; /* omega3*2*m*R^2*I1*(I1 - I3) */
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 44,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 17, 5, 1, 1, 0, 12, 6 }, { 10, 39, 0, 6, 1, 0, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .jacobian = { jacobian, 16, { 5, 36, 17, 1, 1, 0, 15, 11 }, { 33, 145, 0, 26, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 5, 40, 17, 1, 1, 0, 15, 14 }, { 38, 166, 0, 31, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .divergence = { divergence, 1, { 3, 10, 4, 1, 1, 0, 11, 5 }, { 7, 25, 0, 3, 1, 0, 10, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_values = { integral_values, 2, { 3, 13, 9, 1, 1, 0, 9, 6 }, { 12, 44, 0, 1, 1, 0, 12, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_gradients = { integral_gradients, 8, { 4, 23, 10, 1, 1, 0, 11, 10 }, { 18, 79, 0, 6, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 3, 1, 1, 1, 0, 4, 3 }, { 2, 6, 0, 1, 1, 0, 5, 3 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_on_level_G_baseline,
        &jlt_batch_spherical_top_balanced_on_level_G_avx2,
        &jlt_batch_spherical_top_balanced_on_level_G_avx512,
    },
};
