/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   22    7    1    1    0     11    8   (64)
 *  jacobian            5   36   18    1    1    0     15   13   (216)
 *  rhs_jacobian        9   40   18    1    1    0     14   17   (255)
 *  divergence          3   15    4    1    1    0     11    7   (38)
 *  integral_values     2   14   10    1    1    0      9    7   (58)
 *  integral_gradients  3   31   12    1    1    0     14   10   (112)
 *  eliminated          2    4    1    1    1    0      5    4   (10)
 *
 *  Accuracy: divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_omega3_avx512;

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
    const double t0 = params[1]*params[5]; /* R*I3 */
    const double t1 = 1.0/t0; /* 1/(R*I3) */
    const double t2 = params[1]*params[4]; /* R*I1 */
    const double t3 = params[5]*params[4]; /* I3*I1 */
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[0]*t4; /* m*R*R */
    const double t6 = params[4]*t5; /* I1*m*R*R */
    const double t7 = params[5]*t5; /* I3*m*R*R */
    const double t8 = params[5]/params[4]; /* I3/I1 */
    const double t9 = params[5]*params[5]; /* I3*I3 */
    const double t10 = t7 + t9; /* I3*m*R*R + I3*I3 */
    const double t11 = params[1]*params[0]; /* R*m */
    const double t12 = params[5]*t11; /* I3*R*m */
    const double t13 = params[4]/params[5]; /* I1/I3 */
    const double t14 = params[1]*2.0; /* R*2 */
    const double t15 = t2/params[5]; /* R*I1/I3 */
    const double t16 = t6*2.0; /* I1*m*R*R*2 */
    const double t17 = t7*2.0; /* I3*m*R*R*2 */
    const double t18 = t16 - t17; /* I1*m*R*R*2 - I3*m*R*R*2 */
    const double t19 = -t12; /* -I3*R*m */
    const double t20 = t3 + t6; /* I3*I1 + I1*m*R*R */
    const double t21 = params[0]/2.0; /* m/2 */
    const double t22 = params[4]/2.0; /* I1/2 */
    const double t23 = params[5]/2.0; /* I3/2 */
    const double t24 = params[4]*params[4]; /* I1*I1 */
    const double t25 = params[0]*t24; /* m*I1*I1 */
    const double t26 = params[4] - params[5]; /* I1 - I3 */
    const double t27 = t26*(-2.0); /* (I1 - I3)*(-2) */
    const double t28 = t6 - t7; /* I1*m*R*R - I3*m*R*R */
    const double t29 = t27*t28; /* (I1 - I3)*(-2)*(I1*m*R*R - I3*m*R*R) */
    const double t30 = params[4]*2.0; /* I1*2 */
    const double t31 = params[5]*2.0; /* I3*2 */
    const double t32 = t31 - t30; /* I3*2 - I1*2 */
    const double t33 = params[0]*2.0; /* m*2 */
    const double t34 = t24*t33; /* I1*I1*m*2 */
    const double t35 = params[1]*t33; /* R*m*2 */
    const double t36 = t24*t35; /* I1*I1*R*m*2 */
    const double t37 = params[4]*(-2.0); /* I1*(-2) */
    const double t38 = t26*t37; /* (I1 - I3)*I1*(-2) */
    const double t39 = t38/params[5]; /* (I1 - I3)*I1*(-2)/I3 */
    const double t40 = (-1.0)/t0; /* (-1)/(R*I3) */
    out[7] = t1;
    out[8] = t2;
    out[9] = t3;
    out[10] = t6;
    out[11] = t7;
    out[12] = t8;
    out[13] = t10;
    out[14] = t12;
    out[15] = t13;
    out[16] = t14;
    out[17] = t15;
    out[18] = t18;
    out[19] = t19;
    out[20] = t20;
    out[21] = t21;
    out[22] = t22;
    out[23] = t23;
    out[24] = t25;
    out[25] = t26;
    out[26] = t29;
    out[27] = t32;
    out[28] = t34;
    out[29] = t36;
    out[30] = t39;
    out[31] = t40;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = x[3]*p[8]; /* omega_n*R*I1 */
    const double t6 = JLT_FNMA(t3, t5, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t7 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t8 = JLT_FMA(x[0], t7, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t9 = JLT_FMA(t2, p[10], t8); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t10 = x[0]*t9; /* gamma3*Theta */
    const double t11 = t3*t10; /* s*gamma3*Theta */
    const double t12 = 1.0/t11; /* 1/(s*gamma3*Theta) */
    const double t13 = t9*t12; /* Theta*1/(s*gamma3*Theta) */
    const double t14 = t3*p[7]; /* s*1/(R*I3) */
    const double t15 = t6*t14; /* (G_level - s*omega_n*R*I1)*s*1/(R*I3) */
    const double t16 = t13*t15; /* Theta*1/(s*gamma3*Theta)*(G_level - s*omega_n*R*I1)*s*1/(R*I3) */
    const double t17 = x[3]*t16; /* omega_n*t16 */
    const double t18 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t19 = x[3]*t18; /* omega_n*gamma3*gamma3 */
    const double t20 = t13*t19; /* Theta*1/(s*gamma3*Theta)*omega_n*gamma3*gamma3 */
    const double t21 = x[3]*t20; /* omega_n*Theta*1/(s*gamma3*Theta)*omega_n*gamma3*gamma3 */
    const double t22 = t21 - t17; /* omega_n*Theta*1/(s*gamma3*Theta)*omega_n*gamma3*gamma3 - omega_n*t16 */
    const double t23 = p[1]*t22; /* R*t22 */
    const double t24 = JLT_FMS(t17, p[12], t21); /* omega_n*t16*I3/I1 - omega_n*Theta*1/(s*gamma3*Theta)*omega_n*gamma3*gamma3 */
    const double t25 = x[0]*t3; /* gamma3*s */
    const double t26 = t12*t25; /* 1/(s*gamma3*Theta)*gamma3*s */
    const double t27 = p[13]*t26; /* (I3^2 + m*R^2*I3)*1/(s*gamma3*Theta)*gamma3*s */
    const double t28 = JLT_FNMA(t16, t27, t20); /* Theta*1/(s*gamma3*Theta)*omega_n*gamma3*gamma3 - t16*(I3^2 + m*R^2*I3)*1/(s*gamma3*Theta)*gamma3*s */
    const double t29 = x[2]*t28; /* omega_tau*t28 */
    const double t30 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t31 = p[14]*t30; /* m*R*I3*V */
    const double t32 = t26*t31; /* 1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V */
    const double t33 = JLT_FNMA(t20, t32, t29); /* omega_tau*t28 - Theta*1/(s*gamma3*Theta)*omega_n*gamma3*gamma3*1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V */
    out[0] = t4;
    out[1] = t23;
    out[2] = t24;
    out[3] = t33;
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
    const double t7 = x[0]*t5; /* gamma3*Theta */
    const double t8 = t6*t7; /* s*gamma3*Theta */
    const double t9 = 1.0/t8; /* 1/(s*gamma3*Theta) */
    const double t10 = t5*t9; /* Theta*1/(s*gamma3*Theta) */
    const double t11 = x[0]*t10; /* gamma3*Theta*1/(s*gamma3*Theta) */
    const double t12 = x[0]*t11; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t13 = x[2]*t12; /* omega_tau*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t14 = -t13; /* -omega_tau*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t15 = t6*x[3]; /* s*omega_n */
    const double t16 = JLT_FNMA(p[8], t15, p[6]); /* G_level - R*I1*s*omega_n */
    const double t17 = t6*t10; /* s*Theta*1/(s*gamma3*Theta) */
    const double t18 = p[7]*t16; /* 1/(R*I3)*(G_level - R*I1*s*omega_n) */
    const double t19 = t17*t18; /* s*Theta*1/(s*gamma3*Theta)*1/(R*I3)*(G_level - R*I1*s*omega_n) */
    const double t20 = t17*t19; /* s*Theta*1/(s*gamma3*Theta)*t19 */
    const double t21 = t11*x[3]; /* gamma3*Theta*1/(s*gamma3*Theta)*omega_n */
    const double t22 = JLT_FNMA(p[15], t21, t20); /* d(omega3)/d(gamma3) = s*Theta*1/(s*gamma3*Theta)*t19 - I1/I3*gamma3*Theta*1/(s*gamma3*Theta)*omega_n */
    const double t23 = JLT_FMA(t12, t12, 1.0); /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*gamma3*gamma3*Theta*1/(s*gamma3*Theta) + 1 */
    const double t24 = t21*t23; /* gamma3*Theta*1/(s*gamma3*Theta)*omega_n*t23 */
    const double t25 = t22 + t24; /* d(omega3)/d(gamma3) + gamma3*Theta*1/(s*gamma3*Theta)*omega_n*t23 */
    const double t26 = p[1]*x[3]; /* R*omega_n */
    const double t27 = t25*t26; /* t25*R*omega_n */
    const double t28 = p[1]*t19; /* R*t19 */
    const double t29 = t12*x[3]; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*omega_n */
    const double t30 = t15*t17; /* s*omega_n*s*Theta*1/(s*gamma3*Theta) */
    const double t31 = JLT_FMS(p[17], t30, t28); /* R*I1/I3*s*omega_n*s*Theta*1/(s*gamma3*Theta) - R*t19 */
    const double t32 = JLT_FMA(p[16], t29, t31); /* 2*R*gamma3*gamma3*Theta*1/(s*gamma3*Theta)*omega_n + R*I1/I3*s*omega_n*s*Theta*1/(s*gamma3*Theta) - R*t19 */
    const double t33 = JLT_FMA(t22, p[12], t24); /* d(omega3)/d(gamma3)*I3/I1 + gamma3*Theta*1/(s*gamma3*Theta)*omega_n*t23 */
    const double t34 = x[3]*t33; /* omega_n*t33 */
    const double t35 = -t34; /* -omega_n*t33 */
    const double t36 = JLT_FMS(t19, p[12], t30); /* t19*I3/I1 - s*omega_n*s*Theta*1/(s*gamma3*Theta) */
    const double t37 = JLT_FNMA(t29, 2.0, t36); /* t19*I3/I1 - s*omega_n*s*Theta*1/(s*gamma3*Theta) - gamma3*gamma3*Theta*1/(s*gamma3*Theta)*omega_n*2 */
    const double t38 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t39 = p[14]*t38; /* m*R*I3*V */
    const double t40 = x[0]*t6; /* gamma3*s */
    const double t41 = t9*t40; /* 1/(s*gamma3*Theta)*gamma3*s */
    const double t42 = JLT_FNMA(t39, t41, x[2]); /* omega_tau - m*R*I3*V*1/(s*gamma3*Theta)*gamma3*s */
    const double t43 = t24*t42; /* gamma3*Theta*1/(s*gamma3*Theta)*omega_n*t23*(omega_tau - m*R*I3*V*1/(s*gamma3*Theta)*gamma3*s) */
    const double t44 = x[0]*p[18]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t45 = t19*t41; /* t19*1/(s*gamma3*Theta)*gamma3*s */
    const double t46 = JLT_FNMA(t44, t45, t22); /* d(omega3)/d(gamma3) - gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*t19*1/(s*gamma3*Theta)*gamma3*s */
    const double t47 = x[2]*p[13]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t48 = t46*t47; /* t46*omega_tau*(I3^2 + m*R^2*I3) */
    const double t49 = t29*t41; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*omega_n*1/(s*gamma3*Theta)*gamma3*s */
    const double t50 = t39*t44; /* m*R*I3*V*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t51 = JLT_FNMA(t49, t50, t48); /* t46*omega_tau*(I3^2 + m*R^2*I3) - t49*m*R*I3*V*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t52 = JLT_FMA(t41, t51, t43); /* 1/(s*gamma3*Theta)*gamma3*s*t51 + t43 */
    const double t53 = t49*p[19]; /* t49*(-m*R*I3) */
    const double t54 = JLT_FNMA(p[13], t45, t29); /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*omega_n - (I3^2 + m*R^2*I3)*t19*1/(s*gamma3*Theta)*gamma3*s */
    const double t55 = JLT_FNMA(p[11], t49, t54); /* t54 - m*R^2*I3*t49 */
    const double t56 = t12*t42; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*(omega_tau - m*R*I3*V*1/(s*gamma3*Theta)*gamma3*s) */
    const double t57 = x[2]*p[20]; /* omega_tau*(I1*I3 + m*R^2*I1) */
    const double t58 = t6*t57; /* s*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t59 = t41*t58; /* 1/(s*gamma3*Theta)*gamma3*s*s*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t60 = JLT_FMA(t17, t59, t56); /* s*Theta*1/(s*gamma3*Theta)*1/(s*gamma3*Theta)*gamma3*s*s*omega_tau*(I1*I3 + m*R^2*I1) + t56 */
    out[0] = t14;
    out[1] = 0.0;
    out[2] = t6;
    out[3] = 0.0;
    out[4] = t27;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t32;
    out[8] = t35;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t37;
    out[12] = t52;
    out[13] = t53;
    out[14] = t55;
    out[15] = t60;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = p[1]*x[3]; /* R*omega_n */
    const double t6 = t3*x[3]; /* s*omega_n */
    const double t7 = JLT_FNMA(p[8], t6, p[6]); /* G_level - R*I1*s*omega_n */
    const double t8 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t9 = JLT_FMA(x[0], t8, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t10 = JLT_FMA(t2, p[10], t9); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t11 = x[0]*t10; /* gamma3*Theta */
    const double t12 = t3*t11; /* s*gamma3*Theta */
    const double t13 = 1.0/t12; /* 1/(s*gamma3*Theta) */
    const double t14 = t10*t13; /* Theta*1/(s*gamma3*Theta) */
    const double t15 = t3*t14; /* s*Theta*1/(s*gamma3*Theta) */
    const double t16 = p[7]*t7; /* 1/(R*I3)*(G_level - R*I1*s*omega_n) */
    const double t17 = t15*t16; /* s*Theta*1/(s*gamma3*Theta)*1/(R*I3)*(G_level - R*I1*s*omega_n) */
    const double t18 = x[0]*t14; /* gamma3*Theta*1/(s*gamma3*Theta) */
    const double t19 = x[3]*t18; /* omega_n*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t20 = x[0]*t19; /* gamma3*omega_n*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t21 = t20 - t17; /* gamma3*omega_n*gamma3*Theta*1/(s*gamma3*Theta) - t17 */
    const double t22 = t5*t21; /* R*omega_n*(gamma3*omega_n*gamma3*Theta*1/(s*gamma3*Theta) - t17) */
    const double t23 = t17*p[12]; /* t17*I3/I1 */
    const double t24 = t20 - t23; /* gamma3*omega_n*gamma3*Theta*1/(s*gamma3*Theta) - t17*I3/I1 */
    const double t25 = x[3]*t24; /* omega_n*(gamma3*omega_n*gamma3*Theta*1/(s*gamma3*Theta) - t17*I3/I1) */
    const double t26 = -t25; /* -t25 */
    const double t27 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t28 = p[14]*t27; /* m*R*I3*V */
    const double t29 = x[0]*t3; /* gamma3*s */
    const double t30 = t13*t29; /* 1/(s*gamma3*Theta)*gamma3*s */
    const double t31 = JLT_FNMA(t28, t30, x[2]); /* omega_tau - m*R*I3*V*1/(s*gamma3*Theta)*gamma3*s */
    const double t32 = t20*t31; /* gamma3*omega_n*gamma3*Theta*1/(s*gamma3*Theta)*(omega_tau - m*R*I3*V*1/(s*gamma3*Theta)*gamma3*s) */
    const double t33 = t30*p[13]; /* 1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t34 = x[2]*t33; /* omega_tau*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t35 = JLT_FNMA(t17, t34, t32); /* t32 - t17*omega_tau*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t36 = x[0]*t18; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t37 = x[2]*t36; /* omega_tau*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t38 = -t37; /* -omega_tau*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t39 = t15*t17; /* s*Theta*1/(s*gamma3*Theta)*t17 */
    const double t40 = JLT_FNMA(t19, p[15], t39); /* d(omega3)/d(gamma3) = s*Theta*1/(s*gamma3*Theta)*t17 - omega_n*gamma3*Theta*1/(s*gamma3*Theta)*I1/I3 */
    const double t41 = JLT_FMA(t36, t36, 1.0); /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*gamma3*gamma3*Theta*1/(s*gamma3*Theta) + 1 */
    const double t42 = t19*t41; /* omega_n*gamma3*Theta*1/(s*gamma3*Theta)*t41 */
    const double t43 = t40 + t42; /* d(omega3)/d(gamma3) + omega_n*gamma3*Theta*1/(s*gamma3*Theta)*t41 */
    const double t44 = t5*t43; /* R*omega_n*t43 */
    const double t45 = p[1]*t17; /* R*t17 */
    const double t46 = t6*t15; /* s*omega_n*s*Theta*1/(s*gamma3*Theta) */
    const double t47 = JLT_FMS(p[17], t46, t45); /* R*I1/I3*s*omega_n*s*Theta*1/(s*gamma3*Theta) - R*t17 */
    const double t48 = JLT_FMA(t20, p[16], t47); /* gamma3*omega_n*gamma3*Theta*1/(s*gamma3*Theta)*2*R + R*I1/I3*s*omega_n*s*Theta*1/(s*gamma3*Theta) - R*t17 */
    const double t49 = JLT_FMA(p[12], t40, t42); /* I3/I1*d(omega3)/d(gamma3) + omega_n*gamma3*Theta*1/(s*gamma3*Theta)*t41 */
    const double t50 = x[3]*t49; /* omega_n*t49 */
    const double t51 = -t50; /* -omega_n*t49 */
    const double t52 = t23 - t46; /* t17*I3/I1 - s*omega_n*s*Theta*1/(s*gamma3*Theta) */
    const double t53 = JLT_FNMA(t20, 2.0, t52); /* t17*I3/I1 - s*omega_n*s*Theta*1/(s*gamma3*Theta) - gamma3*omega_n*gamma3*Theta*1/(s*gamma3*Theta)*2 */
    const double t54 = t31*t42; /* (omega_tau - m*R*I3*V*1/(s*gamma3*Theta)*gamma3*s)*omega_n*gamma3*Theta*1/(s*gamma3*Theta)*t41 */
    const double t55 = x[0]*p[18]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t56 = t30*t55; /* 1/(s*gamma3*Theta)*gamma3*s*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t57 = JLT_FNMA(t17, t56, t40); /* d(omega3)/d(gamma3) - t17*1/(s*gamma3*Theta)*gamma3*s*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t58 = t20*t30; /* gamma3*omega_n*gamma3*Theta*1/(s*gamma3*Theta)*1/(s*gamma3*Theta)*gamma3*s */
    const double t59 = t28*t56; /* m*R*I3*V*1/(s*gamma3*Theta)*gamma3*s*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t60 = JLT_FNMA(t58, t59, t54); /* t54 - t58*t59 */
    const double t61 = JLT_FMA(t34, t57, t60); /* omega_tau*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3)*t57 + t54 - t58*t59 */
    const double t62 = t58*p[19]; /* t58*(-m*R*I3) */
    const double t63 = JLT_FNMA(t17, t33, t20); /* gamma3*omega_n*gamma3*Theta*1/(s*gamma3*Theta) - t17*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t64 = JLT_FNMA(p[11], t58, t63); /* t63 - m*R^2*I3*t58 */
    const double t65 = t31*t36; /* (omega_tau - m*R*I3*V*1/(s*gamma3*Theta)*gamma3*s)*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t66 = t4*p[20]; /* omega_tau*s*(I1*I3 + m*R^2*I1) */
    const double t67 = t30*t66; /* 1/(s*gamma3*Theta)*gamma3*s*omega_tau*s*(I1*I3 + m*R^2*I1) */
    const double t68 = JLT_FMA(t15, t67, t65); /* s*Theta*1/(s*gamma3*Theta)*1/(s*gamma3*Theta)*gamma3*s*omega_tau*s*(I1*I3 + m*R^2*I1) + t65 */
    out[0] = t4;
    out[1] = t22;
    out[2] = t26;
    out[3] = t35;
    out[4] = t38;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t44;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t48;
    out[12] = t51;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t53;
    out[16] = t61;
    out[17] = t62;
    out[18] = t64;
    out[19] = t68;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t5 = JLT_FMA(x[0], t4, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = JLT_FMA(t2, p[10], t5); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t7 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t8 = x[0]*t6; /* gamma3*Theta */
    const double t9 = t3*t8; /* s*gamma3*Theta */
    const double t10 = 1.0/t9; /* 1/(s*gamma3*Theta) */
    const double t11 = x[0]*t10; /* gamma3*1/(s*gamma3*Theta) */
    const double t12 = x[0]*p[14]; /* gamma3*m*R*I3 */
    const double t13 = t7*t12; /* V*gamma3*m*R*I3 */
    const double t14 = t6*t13; /* Theta*V*gamma3*m*R*I3 */
    const double t15 = t11*t14; /* gamma3*1/(s*gamma3*Theta)*Theta*V*gamma3*m*R*I3 */
    const double t16 = x[2]*p[20]; /* omega_tau*(I1*I3 + m*R^2*I1) */
    const double t17 = t6*t16; /* Theta*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t18 = t3*t17; /* s*Theta*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t19 = t3*t18; /* s*s*Theta*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t20 = JLT_FNMA(t10, t19, t15); /* gamma3*1/(s*gamma3*Theta)*Theta*V*gamma3*m*R*I3 - 1/(s*gamma3*Theta)*s*s*Theta*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t21 = t3*t11; /* s*gamma3*1/(s*gamma3*Theta) */
    const double t22 = t20*t21; /* t20*s*gamma3*1/(s*gamma3*Theta) */
    const double t23 = -t22; /* -t20*s*gamma3*1/(s*gamma3*Theta) */
    out[0] = t23;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t2 = 1.0/x[0]; /* 1/gamma3 */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = x[0] + 1.0; /* gamma3 + 1 */
    const double t5 = t3*t4; /* (1 - gamma3)*(gamma3 + 1) */
    const double t6 = sqrt(t5); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = x[3]*p[8]; /* omega_n*R*I1 */
    const double t8 = JLT_FNMA(t6, t7, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t9 = p[7]*t2; /* 1/(R*I3)*1/gamma3 */
    const double t10 = t8*t9; /* (G_level - s*omega_n*R*I1)*1/(R*I3)*1/gamma3 */
    const double t11 = JLT_FNMA(t6, t10, t1); /* omega_n*gamma3 - s*(G_level - s*omega_n*R*I1)*1/(R*I3)*1/gamma3 */
    const double t12 = p[1]*t11; /* v_tau = R*t11 */
    const double t13 = JLT_FMA(t12, t12, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t14 = x[3]*x[3]; /* omega_n*omega_n */
    const double t15 = JLT_FMA(x[2], x[2], t14); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t16 = p[22]*t15; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t17 = t10*t10; /* (G_level - s*omega_n*R*I1)*1/(R*I3)*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3)*1/gamma3 */
    const double t18 = JLT_FMA(p[23], t17, t16); /* 1/2*I3*t17 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t19 = JLT_FMA(p[21], t13, t18); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + 1/2*I3*t17 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t20 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t21 = p[24]*t20; /* m*I1^2*(R*omega_tau + v_nu) */
    const double t22 = t20*t21; /* (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    const double t23 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t24 = JLT_FMA(x[0], t23, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t25 = JLT_FMA(t5, p[10], t24); /* Theta = (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t26 = p[25]*t25; /* (I1 - I3)*Theta */
    const double t27 = JLT_FMA(t17, t26, t22); /* t17*(I1 - I3)*Theta + (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    out[0] = t19;
    out[1] = t27;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[3]*p[8]; /* omega_n*R*I1 */
    const double t5 = JLT_FNMA(t3, t4, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t6 = x[0]*t3; /* gamma3*s */
    const double t7 = 1.0/t6; /* 1/(gamma3*s) */
    const double t8 = t3*t7; /* s*1/(gamma3*s) */
    const double t9 = p[7]*t5; /* 1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t10 = t8*t9; /* s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t11 = t8*t10; /* s*1/(gamma3*s)*s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t12 = x[0]*t7; /* gamma3*1/(gamma3*s) */
    const double t13 = x[3]*p[15]; /* omega_n*I1/I3 */
    const double t14 = JLT_FNMA(t12, t13, t11); /* d(omega3)/d(gamma3) = t11 - gamma3*1/(gamma3*s)*omega_n*I1/I3 */
    const double t15 = JLT_FMA(t3, t14, x[3]); /* s*d(omega3)/d(gamma3) + omega_n */
    const double t16 = p[1]*t15; /* R*(s*d(omega3)/d(gamma3) + omega_n) */
    const double t17 = p[1]*x[0]; /* R*gamma3 */
    const double t18 = t12*t17; /* gamma3*1/(gamma3*s)*R*gamma3 */
    const double t19 = JLT_FMA(t10, t18, t16); /* d(v_tau)/d(gamma3) = s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1)*gamma3*1/(gamma3*s)*R*gamma3 + R*(s*d(omega3)/d(gamma3) + omega_n) */
    const double t20 = t3*t10; /* s*s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t21 = p[1]*t20; /* R*s*s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t22 = JLT_FMS(x[3], t17, t21); /* v_tau = omega_n*R*gamma3 - R*s*s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t23 = p[0]*t22; /* m*v_tau */
    const double t24 = t19*t23; /* d(v_tau)/d(gamma3)*m*v_tau */
    const double t25 = t10*t14; /* s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1)*d(omega3)/d(gamma3) */
    const double t26 = JLT_FNMA(p[5], t25, t24); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau - I3*t25 */
    const double t27 = p[0]*x[1]; /* m*v_nu */
    const double t28 = p[4]*x[2]; /* I1*omega_tau */
    const double t29 = t8*t20; /* s*1/(gamma3*s)*s*s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t30 = x[3] - t29; /* omega_n - t29 */
    const double t31 = p[4]*t30; /* I1*(omega_n - t29) */
    const double t32 = t2*p[17]; /* (1 - gamma3)*(1 + gamma3)*R*I1/I3 */
    const double t33 = JLT_FMA(t8, t32, t17); /* d(v_tau)/d(omega_n) = s*1/(gamma3*s)*(1 - gamma3)*(1 + gamma3)*R*I1/I3 + R*gamma3 */
    const double t34 = JLT_FMA(t23, t33, t31); /* d(energy)/d(omega_n) = m*v_tau*d(v_tau)/d(omega_n) + I1*(omega_n - t29) */
    const double t35 = x[0]*p[26]; /* gamma3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    const double t36 = t10*t35; /* s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1)*gamma3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    const double t37 = t10*t36; /* s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1)*t36 */
    const double t38 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t39 = JLT_FMA(x[0], t38, p[9]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t40 = JLT_FMA(t2, p[10], t39); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t41 = p[27]*t40; /* (-2*I1 + 2*I3)*Theta */
    const double t42 = JLT_FMA(t25, t41, t37); /* t25*(-2*I1 + 2*I3)*Theta + s*1/(gamma3*s)*1/(R*I3)*(G_level - s*omega_n*R*I1)*t36 */
    const double t43 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t44 = p[28]*t43; /* 2*m*I1^2*(R*omega_tau + v_nu) */
    const double t45 = t43*p[29]; /* (R*omega_tau + v_nu)*2*m*R*I1^2 */
    const double t46 = t40*p[30]; /* Theta*(-2*I1*(I1 - I3)/I3) */
    const double t47 = t29*t46; /* t29*Theta*(-2*I1*(I1 - I3)/I3) */
    out[0] = t26;
    out[1] = t27;
    out[2] = t28;
    out[3] = t34;
    out[4] = t42;
    out[5] = t44;
    out[6] = t45;
    out[7] = t47;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[0]; /* 1/gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = p[8]*x[3]; /* R*I1*omega_n */
    const double t6 = JLT_FNMA(t4, t5, p[6]); /* G_level - s*R*I1*omega_n */
    const double t7 = p[31]*t0; /* (-1/(R*I3))*1/gamma3 */
    const double t8 = t6*t7; /* (G_level - s*R*I1*omega_n)*(-1/(R*I3))*1/gamma3 */
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
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
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
        t13[k] = x3[k]*p[8];
        t14[k] = (k == 0 ? p[6] : 0) - jlt_jet_product(t6, t13, k);
        t18[k] = x0[k]*p[11];
        t19[k] = jlt_jet_product(x0, t18, k) + (k == 0 ? p[9] : 0);
        t20[k] = t5[k]*p[10] + t19[k];
        t21[k] = jlt_jet_product(x0, t20, k);
        t22[k] = jlt_jet_product(t6, t21, k);
        t23[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t22, t23, k);
        t24[k] = jlt_jet_product(t20, t23, k);
        t25[k] = t6[k]*p[7];
        t26[k] = jlt_jet_product(t14, t25, k);
        t27[k] = jlt_jet_product(t24, t26, k);
        t28[k] = jlt_jet_product(x3, t27, k);
        t29[k] = jlt_jet_product(x0, x0, k);
        t30[k] = jlt_jet_product(x3, t29, k);
        t31[k] = jlt_jet_product(t24, t30, k);
        t32[k] = jlt_jet_product(x3, t31, k);
        t33[k] = t32[k] - t28[k];
        t34[k] = p[1]*t33[k];
        t36[k] = t28[k]*p[12] - t32[k];
        t38[k] = jlt_jet_product(x0, t6, k);
        t39[k] = jlt_jet_product(t23, t38, k);
        t40[k] = p[13]*t39[k];
        t41[k] = t31[k] - jlt_jet_product(t27, t40, k);
        t42[k] = jlt_jet_product(x2, t41, k);
        t45[k] = x2[k]*p[1] + x1[k];
        t46[k] = p[14]*t45[k];
        t47[k] = jlt_jet_product(t39, t46, k);
        t48[k] = t42[k] - jlt_jet_product(t31, t47, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t34[k]/(k + 1);
        next[2] = x2[k + 1] = t36[k]/(k + 1);
        next[3] = x3[k + 1] = t48[k]/(k + 1);
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
    const double v_a3 = (0.0);
    const double v_R = params[1];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double v_I3 = params[5];
    const double v_G_level = params[6];
    const double v_I1 = params[4];
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
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
    out[3] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 32,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 22, 7, 1, 1, 0, 11, 8 }, { 11, 44, 0, 8, 1, 0, 11, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 5, 36, 18, 1, 1, 0, 15, 13 }, { 34, 149, 0, 32, 1, 0, 16, 11 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 9, 40, 18, 1, 1, 0, 14, 17 }, { 40, 175, 0, 39, 1, 0, 16, 11 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 15, 4, 1, 1, 0, 11, 7 }, { 6, 28, 0, 3, 1, 0, 11, 6 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 2, 14, 10, 1, 1, 0, 9, 7 }, { 12, 44, 0, 1, 1, 0, 14, 6 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 8, { 3, 31, 12, 1, 1, 0, 14, 10 }, { 20, 84, 0, 7, 1, 0, 13, 10 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 4, 1, 1, 1, 0, 5, 4 }, { 2, 6, 0, 1, 1, 0, 6, 4 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_balanced_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_balanced_on_level_G_omega3_avx512,
    },
};
