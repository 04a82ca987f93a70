/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   18    6    1    1    0     11    9   (56)
 *  jacobian            5   36   18    1    1    0     15   11   (205)
 *  rhs_jacobian        8   41   18    1    1    0     13   17   (236)
 *  divergence          2   10    5    1    1    0      9    6   (36)
 *  integral_values     2   14   10    1    1    0     10    6   (58)
 *  integral_gradients  3   25   11    1    1    0     10    9   (104)
 *  eliminated          2    4    1    1    1    0      5    3   (10)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
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
    const double t1 = 1.0/t0; /* 1/(R*I1) */
    const double t2 = params[1]*params[5]; /* R*I3 */
    const double t3 = params[4]*params[5]; /* I1*I3 */
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[0]*t4; /* m*R*R */
    const double t6 = params[4]*t5; /* I1*m*R*R */
    const double t7 = params[5]*t5; /* I3*m*R*R */
    const double t8 = params[5]/params[4]; /* I3/I1 */
    const double t9 = params[1]*params[0]; /* R*m */
    const double t10 = params[4]*t9; /* I1*R*m */
    const double t11 = params[4] - params[5]; /* I1 - I3 */
    const double t12 = params[1]*t11; /* R*(I1 - I3) */
    const double t13 = t12/params[4]; /* R*(I1 - I3)/I1 */
    const double t14 = t2/params[4]; /* R*I3/I1 */
    const double t15 = params[1]*2.0; /* R*2 */
    const double t16 = params[5]*t15; /* I3*R*2 */
    const double t17 = t16/params[4]; /* I3*R*2/I1 */
    const double t18 = -t8; /* -I3/I1 */
    const double t19 = params[5]*(-2.0); /* I3*(-2) */
    const double t20 = t19/params[4]; /* I3*(-2)/I1 */
    const double t21 = params[4]*params[4]; /* I1*I1 */
    const double t22 = params[5]*params[5]; /* I3*I3 */
    const double t23 = t22/t21; /* I3*I3/(I1*I1) */
    const double t24 = -t23; /* -I3*I3/(I1*I1) */
    const double t25 = -t10; /* -I1*R*m */
    const double t26 = t6*2.0; /* I1*m*R*R*2 */
    const double t27 = t7*2.0; /* I3*m*R*R*2 */
    const double t28 = t26 - t27; /* I1*m*R*R*2 - I3*m*R*R*2 */
    const double t29 = t5*t11; /* m*R*R*(I1 - I3) */
    const double t30 = params[5]*t9; /* I3*R*m */
    const double t31 = params[0]/2.0; /* m/2 */
    const double t32 = params[4]/2.0; /* I1/2 */
    const double t33 = params[5]/2.0; /* I3/2 */
    const double t34 = params[0]*t21; /* m*I1*I1 */
    const double t35 = t11*(-2.0); /* (I1 - I3)*(-2) */
    const double t36 = t6 - t7; /* I1*m*R*R - I3*m*R*R */
    const double t37 = t35*t36; /* (I1 - I3)*(-2)*(I1*m*R*R - I3*m*R*R) */
    const double t38 = params[0]*2.0; /* m*2 */
    const double t39 = t21*t38; /* I1*I1*m*2 */
    const double t40 = params[1]*t38; /* R*m*2 */
    const double t41 = t21*t40; /* I1*I1*R*m*2 */
    const double t42 = params[4]*2.0; /* I1*2 */
    const double t43 = params[5]*2.0; /* I3*2 */
    const double t44 = t42 - t43; /* I1*2 - I3*2 */
    out[7] = t1;
    out[8] = t2;
    out[9] = t3;
    out[10] = t6;
    out[11] = t7;
    out[12] = t8;
    out[13] = t10;
    out[14] = t13;
    out[15] = t14;
    out[16] = t17;
    out[17] = t18;
    out[18] = t20;
    out[19] = t24;
    out[20] = t25;
    out[21] = t28;
    out[22] = t29;
    out[23] = t30;
    out[24] = t31;
    out[25] = t32;
    out[26] = t33;
    out[27] = t34;
    out[28] = t11;
    out[29] = t9;
    out[30] = t37;
    out[31] = t39;
    out[32] = t41;
    out[33] = t44;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = x[0]*x[3]; /* gamma3*omega3 */
    const double t6 = JLT_FMA(p[8], t5, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t7 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t8 = JLT_FMA(x[0], t7, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t9 = JLT_FMA(t2, p[10], t8); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t10 = t3*t9; /* s*Theta */
    const double t11 = 1.0/t10; /* 1/(s*Theta) */
    const double t12 = t9*t11; /* Theta*1/(s*Theta) */
    const double t13 = p[7]*t6; /* 1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t14 = t12*t13; /* omega_n = Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t15 = x[0]*t12; /* gamma3*Theta*1/(s*Theta) */
    const double t16 = t14*t15; /* omega_n*gamma3*Theta*1/(s*Theta) */
    const double t17 = x[3] + t16; /* omega3 + omega_n*gamma3*Theta*1/(s*Theta) */
    const double t18 = p[1]*t14; /* R*omega_n */
    const double t19 = t17*t18; /* (omega3 + omega_n*gamma3*Theta*1/(s*Theta))*R*omega_n */
    const double t20 = JLT_FMA(x[3], p[12], t16); /* omega3*I3/I1 + omega_n*gamma3*Theta*1/(s*Theta) */
    const double t21 = t14*t20; /* omega_n*(omega3*I3/I1 + omega_n*gamma3*Theta*1/(s*Theta)) */
    const double t22 = -t21; /* -omega_n*(omega3*I3/I1 + omega_n*gamma3*Theta*1/(s*Theta)) */
    const double t23 = t5*p[14]; /* gamma3*omega3*R*(I1 - I3)/I1 */
    const double t24 = t4*t23; /* omega_tau*s*gamma3*omega3*R*(I1 - I3)/I1 */
    const double t25 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t26 = JLT_FNMA(t14, t25, t24); /* omega_tau*s*gamma3*omega3*R*(I1 - I3)/I1 - omega_n*V */
    const double t27 = t3*p[13]; /* s*m*R*I1 */
    const double t28 = t11*t27; /* 1/(s*Theta)*s*m*R*I1 */
    const double t29 = t26*t28; /* (omega_tau*s*gamma3*omega3*R*(I1 - I3)/I1 - omega_n*V)*1/(s*Theta)*s*m*R*I1 */
    out[0] = t4;
    out[1] = t19;
    out[2] = t22;
    out[3] = t29;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(p[10], t2, t4); /* Theta = m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = t5*t6; /* Theta*s */
    const double t8 = 1.0/t7; /* 1/(Theta*s) */
    const double t9 = t5*t8; /* Theta*1/(Theta*s) */
    const double t10 = x[0]*t9; /* gamma3*Theta*1/(Theta*s) */
    const double t11 = x[2]*t10; /* omega_tau*gamma3*Theta*1/(Theta*s) */
    const double t12 = -t11; /* -omega_tau*gamma3*Theta*1/(Theta*s) */
    const double t13 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t14 = JLT_FMA(x[3], t13, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t15 = p[7]*t14; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t16 = t9*t15; /* Theta*1/(Theta*s)*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t17 = t9*t16; /* Theta*1/(Theta*s)*Theta*1/(Theta*s)*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t18 = t10*t16; /* gamma3*Theta*1/(Theta*s)*Theta*1/(Theta*s)*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t19 = t9*t18; /* Theta*1/(Theta*s)*t18 */
    const double t20 = JLT_FMA(x[3], p[12], t18); /* omega3*I3/I1 + t18 */
    const double t21 = t9*t20; /* d(omega_n)/d(gamma3) = Theta*1/(Theta*s)*(omega3*I3/I1 + t18) */
    const double t22 = JLT_FMA(2.0, t21, t19); /* 2*d(omega_n)/d(gamma3) + Theta*1/(Theta*s)*t18 */
    const double t23 = JLT_FMA(t10, t22, t17); /* gamma3*Theta*1/(Theta*s)*(2*d(omega_n)/d(gamma3) + Theta*1/(Theta*s)*t18) + t17 */
    const double t24 = t16*t23; /* Theta*1/(Theta*s)*1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*t23 */
    const double t25 = x[3]*t21; /* omega3*d(omega_n)/d(gamma3) */
    const double t26 = t24 + t25; /* t24 + omega3*d(omega_n)/d(gamma3) */
    const double t27 = p[1]*t26; /* R*(t24 + omega3*d(omega_n)/d(gamma3)) */
    const double t28 = p[1]*t16; /* R*Theta*1/(Theta*s)*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t29 = t10*x[3]; /* gamma3*Theta*1/(Theta*s)*omega3 */
    const double t30 = t10*t18; /* gamma3*Theta*1/(Theta*s)*t18 */
    const double t31 = JLT_FMA(p[15], t29, t28); /* R*I3/I1*gamma3*Theta*1/(Theta*s)*omega3 + R*Theta*1/(Theta*s)*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t32 = JLT_FMA(p[16], t30, t31); /* 2*R*I3/I1*gamma3*Theta*1/(Theta*s)*t18 + t31 */
    const double t33 = JLT_FMA(p[12], t25, t24); /* I3/I1*omega3*d(omega_n)/d(gamma3) + t24 */
    const double t34 = -t33; /* -(I3/I1*omega3*d(omega_n)/d(gamma3) + t24) */
    const double t35 = t16*p[17]; /* Theta*1/(Theta*s)*1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*(-I3/I1) */
    const double t36 = JLT_FMA(t29, p[19], t35); /* gamma3*Theta*1/(Theta*s)*omega3*(-I3^2/I1^2) + t35 */
    const double t37 = JLT_FMA(t30, p[18], t36); /* gamma3*Theta*1/(Theta*s)*t18*(-2*I3/I1) + gamma3*Theta*1/(Theta*s)*omega3*(-I3^2/I1^2) + t35 */
    const double t38 = x[0]*p[21]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t39 = t6*t8; /* s*1/(Theta*s) */
    const double t40 = t6*t39; /* s*s*1/(Theta*s) */
    const double t41 = JLT_FNMA(t38, t40, t10); /* gamma3*Theta*1/(Theta*s) - gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*s*s*1/(Theta*s) */
    const double t42 = JLT_FMS(x[0], t41, t6); /* gamma3*t41 - s */
    const double t43 = x[2]*p[14]; /* omega_tau*R*(I1 - I3)/I1 */
    const double t44 = x[3]*t43; /* omega3*omega_tau*R*(I1 - I3)/I1 */
    const double t45 = t42*t44; /* (gamma3*t41 - s)*omega3*omega_tau*R*(I1 - I3)/I1 */
    const double t46 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t47 = t16*t39; /* Theta*1/(Theta*s)*1/(R*I1)*(omega3*gamma3*R*I3 + G_level)*s*1/(Theta*s) */
    const double t48 = JLT_FMA(t38, t47, t21); /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*t47 + d(omega_n)/d(gamma3) */
    const double t49 = JLT_FMA(t46, t48, t45); /* V*(gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*t47 + d(omega_n)/d(gamma3)) + (gamma3*t41 - s)*omega3*omega_tau*R*(I1 - I3)/I1 */
    const double t50 = p[20]*t39; /* (-m*R*I1)*s*1/(Theta*s) */
    const double t51 = t49*t50; /* t49*(-m*R*I1)*s*1/(Theta*s) */
    const double t52 = p[20]*t47; /* (-m*R*I1)*t47 */
    const double t53 = x[0]*p[22]; /* gamma3*m*R^2*(I1 - I3) */
    const double t54 = t40*t53; /* s*s*1/(Theta*s)*gamma3*m*R^2*(I1 - I3) */
    const double t55 = x[3]*t54; /* omega3*s*s*1/(Theta*s)*gamma3*m*R^2*(I1 - I3) */
    const double t56 = JLT_FNMA(p[10], t47, t55); /* omega3*s*s*1/(Theta*s)*gamma3*m*R^2*(I1 - I3) - m*R^2*I1*t47 */
    const double t57 = x[2]*t54; /* omega_tau*s*s*1/(Theta*s)*gamma3*m*R^2*(I1 - I3) */
    const double t58 = t46*p[23]; /* V*m*R*I3 */
    const double t59 = t39*t58; /* s*1/(Theta*s)*V*m*R*I3 */
    const double t60 = JLT_FNMA(t10, t59, t57); /* omega_tau*s*s*1/(Theta*s)*gamma3*m*R^2*(I1 - I3) - gamma3*Theta*1/(Theta*s)*s*1/(Theta*s)*V*m*R*I3 */
    out[0] = t12;
    out[1] = 0.0;
    out[2] = t6;
    out[3] = 0.0;
    out[4] = t27;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t32;
    out[8] = t34;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t37;
    out[12] = t51;
    out[13] = t52;
    out[14] = t56;
    out[15] = t60;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t6 = JLT_FMA(x[0], t5, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t7 = JLT_FMA(t2, p[10], t6); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t8 = t3*t7; /* s*Theta */
    const double t9 = 1.0/t8; /* 1/(s*Theta) */
    const double t10 = t7*t9; /* Theta*1/(s*Theta) */
    const double t11 = x[0]*t10; /* gamma3*Theta*1/(s*Theta) */
    const double t12 = x[0]*x[3]; /* gamma3*omega3 */
    const double t13 = JLT_FMA(p[8], t12, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t14 = p[7]*t13; /* 1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t15 = t10*t14; /* Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t16 = t11*t15; /* gamma3*Theta*1/(s*Theta)*Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t17 = x[3] + t16; /* omega3 + t16 */
    const double t18 = t15*p[1]; /* Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*R */
    const double t19 = t17*t18; /* (omega3 + t16)*Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*R */
    const double t20 = x[3]*p[12]; /* omega3*I3/I1 */
    const double t21 = t16 + t20; /* t16 + omega3*I3/I1 */
    const double t22 = t15*t21; /* Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*(t16 + omega3*I3/I1) */
    const double t23 = -t22; /* -t22 */
    const double t24 = t12*p[14]; /* gamma3*omega3*R*(I1 - I3)/I1 */
    const double t25 = t4*t24; /* omega_tau*s*gamma3*omega3*R*(I1 - I3)/I1 */
    const double t26 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t27 = JLT_FNMA(t15, t26, t25); /* omega_tau*s*gamma3*omega3*R*(I1 - I3)/I1 - Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*V */
    const double t28 = t3*t9; /* s*1/(s*Theta) */
    const double t29 = p[13]*t28; /* m*R*I1*s*1/(s*Theta) */
    const double t30 = t27*t29; /* t27*m*R*I1*s*1/(s*Theta) */
    const double t31 = x[2]*t11; /* omega_tau*gamma3*Theta*1/(s*Theta) */
    const double t32 = -t31; /* -omega_tau*gamma3*Theta*1/(s*Theta) */
    const double t33 = t10*t21; /* d(omega_n)/d(gamma3) = Theta*1/(s*Theta)*(t16 + omega3*I3/I1) */
    const double t34 = t15*t15; /* Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t35 = JLT_FMA(t16, t16, t34); /* t16*t16 + t34 */
    const double t36 = t10*t35; /* Theta*1/(s*Theta)*(t16*t16 + t34) */
    const double t37 = t16*2.0; /* t16*2 */
    const double t38 = JLT_FMA(t33, t37, t36); /* d(omega_n)/d(gamma3)*t16*2 + Theta*1/(s*Theta)*(t16*t16 + t34) */
    const double t39 = JLT_FMA(x[3], t33, t38); /* omega3*d(omega_n)/d(gamma3) + t38 */
    const double t40 = p[1]*t39; /* R*(omega3*d(omega_n)/d(gamma3) + t38) */
    const double t41 = x[3]*t11; /* omega3*gamma3*Theta*1/(s*Theta) */
    const double t42 = t11*t16; /* gamma3*Theta*1/(s*Theta)*t16 */
    const double t43 = JLT_FMA(p[15], t41, t18); /* R*I3/I1*omega3*gamma3*Theta*1/(s*Theta) + Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*R */
    const double t44 = JLT_FMA(p[16], t42, t43); /* 2*R*I3/I1*gamma3*Theta*1/(s*Theta)*t16 + t43 */
    const double t45 = JLT_FMA(t20, t33, t38); /* omega3*I3/I1*d(omega_n)/d(gamma3) + t38 */
    const double t46 = -t45; /* -(omega3*I3/I1*d(omega_n)/d(gamma3) + t38) */
    const double t47 = t15*p[17]; /* Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*(-I3/I1) */
    const double t48 = JLT_FMA(t41, p[19], t47); /* omega3*gamma3*Theta*1/(s*Theta)*(-I3^2/I1^2) + t47 */
    const double t49 = JLT_FMA(t42, p[18], t48); /* gamma3*Theta*1/(s*Theta)*t16*(-2*I3/I1) + omega3*gamma3*Theta*1/(s*Theta)*(-I3^2/I1^2) + t47 */
    const double t50 = t28*p[22]; /* s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t51 = t4*t50; /* omega_tau*s*s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t52 = x[3]*t51; /* omega3*omega_tau*s*s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t53 = t12*t50; /* gamma3*omega3*s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t54 = x[0]*p[21]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t55 = t28*t54; /* s*1/(s*Theta)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t56 = t27*t55; /* t27*s*1/(s*Theta)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t57 = JLT_FMS(t26, t33, t56); /* V*d(omega_n)/d(gamma3) - t27*s*1/(s*Theta)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t58 = JLT_FNMA(t31, t53, t52); /* omega3*omega_tau*s*s*1/(s*Theta)*m*R^2*(I1 - I3) - omega_tau*gamma3*Theta*1/(s*Theta)*gamma3*omega3*s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t59 = JLT_FNMA(t29, t57, t58); /* t58 - m*R*I1*s*1/(s*Theta)*t57 */
    const double t60 = t15*t29; /* Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*m*R*I1*s*1/(s*Theta) */
    const double t61 = -t60; /* -t60 */
    const double t62 = t3*t53; /* s*gamma3*omega3*s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t63 = p[10]*t28; /* m*R^2*I1*s*1/(s*Theta) */
    const double t64 = JLT_FNMA(t15, t63, t62); /* s*gamma3*omega3*s*1/(s*Theta)*m*R^2*(I1 - I3) - Theta*1/(s*Theta)*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*m*R^2*I1*s*1/(s*Theta) */
    const double t65 = x[0]*t51; /* gamma3*omega_tau*s*s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t66 = t26*p[23]; /* V*m*R*I3 */
    const double t67 = t28*t66; /* s*1/(s*Theta)*V*m*R*I3 */
    const double t68 = JLT_FNMA(t11, t67, t65); /* gamma3*omega_tau*s*s*1/(s*Theta)*m*R^2*(I1 - I3) - gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*V*m*R*I3 */
    out[0] = t4;
    out[1] = t19;
    out[2] = t23;
    out[3] = t30;
    out[4] = t32;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t40;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t44;
    out[12] = t46;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t49;
    out[16] = t59;
    out[17] = t61;
    out[18] = t64;
    out[19] = t68;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t5 = JLT_FMA(x[0], t4, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = JLT_FMA(t2, p[10], t5); /* Theta = (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t7 = t3*t6; /* s*Theta */
    const double t8 = 1.0/t7; /* 1/(s*Theta) */
    const double t9 = t3*t8; /* s*1/(s*Theta) */
    const double t10 = p[22]*x[2]; /* m*R^2*(I1 - I3)*omega_tau */
    const double t11 = t3*t10; /* s*m*R^2*(I1 - I3)*omega_tau */
    const double t12 = t9*t11; /* s*1/(s*Theta)*s*m*R^2*(I1 - I3)*omega_tau */
    const double t13 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t14 = p[23]*t13; /* m*R*I3*V */
    const double t15 = JLT_FMA(t9, t14, x[2]); /* s*1/(s*Theta)*m*R*I3*V + omega_tau */
    const double t16 = t6*t8; /* Theta*1/(s*Theta) */
    const double t17 = JLT_FNMA(t15, t16, t12); /* s*1/(s*Theta)*s*m*R^2*(I1 - I3)*omega_tau - (s*1/(s*Theta)*m*R*I3*V + omega_tau)*Theta*1/(s*Theta) */
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
    const double t5 = 1.0/t4; /* 1/s */
    const double t6 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t7 = JLT_FMA(x[3], t6, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t8 = p[7]*t7; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t9 = t5*t8; /* omega_n = 1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t10 = x[0]*t9; /* gamma3*omega_n */
    const double t11 = JLT_FMA(t4, x[3], t10); /* s*omega3 + gamma3*omega_n */
    const double t12 = p[1]*t11; /* v_tau = R*(s*omega3 + gamma3*omega_n) */
    const double t13 = JLT_FMA(t12, t12, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t14 = t9*t9; /* omega_n*omega_n */
    const double t15 = JLT_FMA(x[2], x[2], t14); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t16 = p[25]*t15; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t17 = x[3]*x[3]; /* omega3*omega3 */
    const double t18 = JLT_FMA(p[26], t17, t16); /* 1/2*I3*omega3*omega3 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t19 = JLT_FMA(p[24], t13, t18); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t18 */
    const double t20 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t21 = p[27]*t20; /* m*I1^2*(R*omega_tau + v_nu) */
    const double t22 = t20*t21; /* (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    const double t23 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t24 = JLT_FMA(x[0], t23, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t25 = JLT_FMA(t3, p[10], t24); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t26 = t17*p[28]; /* omega3*omega3*(I1 - I3) */
    const double t27 = JLT_FMA(t25, t26, t22); /* Theta*omega3*omega3*(I1 - I3) + (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    out[0] = t19;
    out[1] = t27;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = 1.0/t3; /* 1/s */
    const double t5 = x[0]*t4; /* gamma3*1/s */
    const double t6 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t7 = JLT_FMA(x[3], t6, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t8 = p[7]*t7; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t9 = t4*t8; /* 1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t10 = t5*t9; /* gamma3*1/s*1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t11 = JLT_FMA(p[12], x[3], t10); /* I3/I1*omega3 + gamma3*1/s*1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t12 = t4*t11; /* d(omega_n)/d(gamma3) = 1/s*t11 */
    const double t13 = p[4]*t9; /* I1*1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t14 = t12*t13; /* d(omega_n)/d(gamma3)*I1*1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t15 = JLT_FNMA(x[3], t5, t9); /* 1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) - omega3*gamma3*1/s */
    const double t16 = JLT_FMA(x[0], t12, t15); /* gamma3*d(omega_n)/d(gamma3) + t15 */
    const double t17 = x[0]*t9; /* gamma3*1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t18 = JLT_FMA(t3, x[3], t17); /* s*omega3 + gamma3*1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t19 = p[29]*t18; /* m*R*t18 */
    const double t20 = p[1]*t19; /* R*m*R*t18 */
    const double t21 = JLT_FMA(t16, t20, t14); /* d(energy)/d(gamma3) = (gamma3*d(omega_n)/d(gamma3) + t15)*R*m*R*t18 + t14 */
    const double t22 = p[0]*x[1]; /* m*v_nu */
    const double t23 = p[4]*x[2]; /* I1*omega_tau */
    const double t24 = x[3] + t10; /* omega3 + gamma3*1/s*1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t25 = p[5]*t24; /* I3*t24 */
    const double t26 = t3*p[1]; /* s*R */
    const double t27 = x[0]*p[15]; /* gamma3*R*I3/I1 */
    const double t28 = JLT_FMA(t5, t27, t26); /* d(v_tau)/d(omega3) = gamma3*1/s*gamma3*R*I3/I1 + s*R */
    const double t29 = JLT_FMA(t19, t28, t25); /* d(energy)/d(omega3) = m*R*t18*d(v_tau)/d(omega3) + I3*t24 */
    const double t30 = x[0]*p[30]; /* gamma3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    const double t31 = x[3]*x[3]; /* omega3*omega3 */
    const double t32 = t30*t31; /* gamma3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3))*omega3*omega3 */
    const double t33 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t34 = p[31]*t33; /* 2*m*I1^2*(R*omega_tau + v_nu) */
    const double t35 = t33*p[32]; /* (R*omega_tau + v_nu)*2*m*R*I1^2 */
    const double t36 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t37 = JLT_FMA(x[0], t36, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t38 = JLT_FMA(t2, p[10], t37); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t39 = x[3]*p[33]; /* omega3*(2*I1 - 2*I3) */
    const double t40 = t38*t39; /* Theta*omega3*(2*I1 - 2*I3) */
    out[0] = t21;
    out[1] = t22;
    out[2] = t23;
    out[3] = t29;
    out[4] = t32;
    out[5] = t34;
    out[6] = t35;
    out[7] = t40;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = 1.0/t3; /* 1/s */
    const double t5 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t6 = JLT_FMA(x[3], t5, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t7 = p[7]*t6; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t8 = t4*t7; /* 1/s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    out[0] = t8;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
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
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t13[k] = jlt_jet_product(x0, x3, k);
        t14[k] = p[8]*t13[k] + (k == 0 ? p[6] : 0);
        t18[k] = x0[k]*p[11];
        t19[k] = jlt_jet_product(x0, t18, k) + (k == 0 ? p[9] : 0);
        t20[k] = t5[k]*p[10] + t19[k];
        t21[k] = jlt_jet_product(t6, t20, k);
        t22[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t21, t22, k);
        t23[k] = jlt_jet_product(t20, t22, k);
        t24[k] = p[7]*t14[k];
        t25[k] = jlt_jet_product(t23, t24, k);
        t26[k] = jlt_jet_product(x0, t23, k);
        t27[k] = jlt_jet_product(t25, t26, k);
        t28[k] = x3[k] + t27[k];
        t29[k] = p[1]*t25[k];
        t30[k] = jlt_jet_product(t28, t29, k);
        t32[k] = x3[k]*p[12] + t27[k];
        t33[k] = jlt_jet_product(t25, t32, k);
        t34[k] = -t33[k];
        t37[k] = t13[k]*p[14];
        t38[k] = jlt_jet_product(t7, t37, k);
        t40[k] = x2[k]*p[1] + x1[k];
        t41[k] = t38[k] - jlt_jet_product(t25, t40, k);
        t42[k] = t6[k]*p[13];
        t43[k] = jlt_jet_product(t22, t42, k);
        t44[k] = jlt_jet_product(t41, t43, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t30[k]/(k + 1);
        next[2] = x2[k + 1] = t34[k]/(k + 1);
        next[3] = x3[k + 1] = t44[k]/(k + 1);
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
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 34,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 18, 6, 1, 1, 0, 11, 9 }, { 10, 39, 0, 6, 1, 0, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 5, 36, 18, 1, 1, 0, 15, 11 }, { 33, 145, 0, 26, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 8, 41, 18, 1, 1, 0, 13, 17 }, { 38, 166, 0, 31, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 10, 5, 1, 1, 0, 9, 6 }, { 7, 25, 0, 3, 1, 0, 10, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 2, 14, 10, 1, 1, 0, 10, 6 }, { 12, 44, 0, 1, 1, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 8, { 3, 25, 11, 1, 1, 0, 10, 9 }, { 18, 79, 0, 6, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 4, 1, 1, 1, 0, 5, 3 }, { 2, 6, 0, 1, 1, 0, 5, 3 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
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
