/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   18    6    1    1    0     11    6   (64)
 *  jacobian            7   33   15    1    1    0     14   12   (216)
 *  rhs_jacobian        8   38   16    1    1    0     15   15   (255)
 *  divergence          2   13    4    1    1    0      9    6   (38)
 *  integral_values     3   12    9    1    1    0     10    7   (58)
 *  integral_gradients  4   26   11    1    1    0     13   10   (112)
 *  eliminated          2    2    1    1    1    0      5    3   (10)
 *
 *  Accuracy
 *    divides by gamma3: values and rounding errors grow without bound where it vanishes
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
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = t0/params[5]; /* R*I1/I3 */
    out[7] = t1;
    const double t2 = params[6]/t0; /* G_level/(R*I1) */
    out[8] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    out[29] = t4;
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    out[9] = t5;
    const double t6 = params[5]/params[4]; /* I3/I1 */
    out[10] = t6;
    const double t7 = params[5]/t0; /* I3/(R*I1) */
    out[11] = t7;
    const double t8 = params[5]*t4; /* I3*m*R*R */
    out[15] = t8;
    const double t9 = params[5]*params[5]; /* I3*I3 */
    const double t10 = t8 + t9; /* I3*m*R*R + I3*I3 */
    out[19] = t10;
    const double t11 = t10/t8; /* (I3*m*R*R + I3*I3)/(I3*m*R*R) */
    out[12] = t11;
    const double t12 = params[4]*params[5]; /* I1*I3 */
    out[13] = t12;
    const double t13 = params[4]*t4; /* I1*m*R*R */
    out[14] = t13;
    const double t14 = params[4]/params[5]; /* I1/I3 */
    out[16] = t14;
    const double t15 = params[1]*2.0; /* R*2 */
    out[17] = t15;
    const double t16 = params[1]*params[0]; /* R*m */
    const double t17 = params[5]*t16; /* I3*R*m */
    out[18] = t17;
    const double t18 = t13*2.0; /* I1*m*R*R*2 */
    const double t19 = t8*2.0; /* I3*m*R*R*2 */
    const double t20 = t18 - t19; /* I1*m*R*R*2 - I3*m*R*R*2 */
    out[20] = t20;
    const double t21 = params[4]*t10; /* I1*(I3*m*R*R + I3*I3) */
    const double t22 = t21/params[5]; /* I1*(I3*m*R*R + I3*I3)/I3 */
    out[21] = t22;
    const double t23 = -t17; /* -I3*R*m */
    out[22] = t23;
    const double t24 = t12 + t13; /* I1*I3 + I1*m*R*R */
    out[23] = t24;
    const double t25 = params[4]/2.0; /* I1/2 */
    out[24] = t25;
    const double t26 = params[0]/params[4]; /* m/I1 */
    out[25] = t26;
    const double t27 = t4/params[4]; /* m*R*R/I1 */
    out[26] = t27;
    const double t28 = params[4]*params[4]; /* I1*I1 */
    const double t29 = params[0]*t28; /* m*I1*I1 */
    out[27] = t29;
    const double t30 = params[4] - params[5]; /* I1 - I3 */
    const double t31 = t13*t30; /* I1*m*R*R*(I1 - I3) */
    out[28] = t31;
    const double t32 = t30*(-2.0); /* (I1 - I3)*(-2) */
    const double t33 = t13 - t8; /* I1*m*R*R - I3*m*R*R */
    const double t34 = t32*t33; /* (I1 - I3)*(-2)*(I1*m*R*R - I3*m*R*R) */
    out[30] = t34;
    const double t35 = params[0]*(-2.0); /* m*(-2) */
    const double t36 = t3*t35; /* R*R*m*(-2) */
    const double t37 = params[4]*t36; /* I1*R*R*m*(-2) */
    const double t38 = t30*t37; /* (I1 - I3)*I1*R*R*m*(-2) */
    out[31] = t38;
    const double t39 = params[0]*2.0; /* m*2 */
    const double t40 = t28*t39; /* I1*I1*m*2 */
    out[32] = t40;
    const double t41 = params[1]*t39; /* R*m*2 */
    const double t42 = t28*t41; /* I1*I1*R*m*2 */
    out[33] = t42;
    const double t43 = t28*t36; /* I1*I1*R*R*m*(-2) */
    const double t44 = t30*t43; /* (I1 - I3)*I1*I1*R*R*m*(-2) */
    const double t45 = t44/params[5]; /* (I1 - I3)*I1*I1*R*R*m*(-2)/I3 */
    out[34] = t45;
    const double t46 = -t14; /* -I1/I3 */
    out[35] = t46;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = p[9] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t5 = x[2]*t3; /* omega_tau*s */
    out[0] = t5;
    const double t6 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t7 = JLT_FMA(p[10], t6, t4); /* Theta/(m*R^2*I1) = I3/I1*gamma3*gamma3 + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t8 = x[3]*t6; /* omega_n*gamma3*gamma3 */
    const double t9 = x[0]*t3; /* gamma3*s */
    const double t10 = t7*t9; /* Theta/(m*R^2*I1)*gamma3*s */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*gamma3*s) */
    const double t12 = t7*t11; /* 1/(gamma3*s) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s) */
    const double t13 = t9*t11; /* 1/(Theta/(m*R^2*I1)) = gamma3*s*1/(Theta/(m*R^2*I1)*gamma3*s) */
    const double t14 = t8*t12; /* omega_n*gamma3*gamma3*1/(gamma3*s) */
    const double t15 = JLT_FNMA(x[3], t3, p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t16 = t3*t15; /* s*(G_level/(R*I1) - omega_n*s) */
    const double t17 = t12*t16; /* 1/(gamma3*s)*s*(G_level/(R*I1) - omega_n*s) */
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t19 = p[11]*t18; /* I3/(R*I1)*V */
    const double t20 = JLT_FNMA(t13, t19, x[2]); /* omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t21 = t14*t20; /* omega_n*gamma3*gamma3*1/(gamma3*s)*(omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V) */
    const double t22 = x[3]*t14; /* omega_n*omega_n*gamma3*gamma3*1/(gamma3*s) */
    const double t23 = x[3]*t17; /* omega_n*1/(gamma3*s)*s*(G_level/(R*I1) - omega_n*s) */
    const double t24 = t23 - t22; /* omega_n*1/(gamma3*s)*s*(G_level/(R*I1) - omega_n*s) - omega_n*omega_n*gamma3*gamma3*1/(gamma3*s) */
    out[2] = t24;
    const double t25 = p[7]*t23; /* R*I1/I3*omega_n*1/(gamma3*s)*s*(G_level/(R*I1) - omega_n*s) */
    const double t26 = JLT_FMS(p[1], t22, t25); /* R*omega_n*omega_n*gamma3*gamma3*1/(gamma3*s) - R*I1/I3*omega_n*1/(gamma3*s)*s*(G_level/(R*I1) - omega_n*s) */
    out[1] = t26;
    const double t27 = x[2]*p[12]; /* omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I3) */
    const double t28 = t13*t27; /* 1/(Theta/(m*R^2*I1))*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I3) */
    const double t29 = JLT_FNMA(t17, t28, t21); /* t21 - 1/(gamma3*s)*s*(G_level/(R*I1) - omega_n*s)*1/(Theta/(m*R^2*I1))*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I3) */
    out[3] = t29;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[15]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[13]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(p[14], t2, t4); /* Theta = m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t6;
    const double t7 = x[0]*t6; /* gamma3*s */
    const double t8 = t5*t7; /* Theta*gamma3*s */
    const double t9 = 1.0/t8; /* 1/(Theta*gamma3*s) */
    const double t10 = t5*t9; /* 1/(s*gamma3) = Theta*1/(Theta*gamma3*s) */
    const double t11 = t7*t9; /* 1/Theta = gamma3*s*1/(Theta*gamma3*s) */
    const double t12 = x[0]*t10; /* 1/s = gamma3*1/(s*gamma3) */
    const double t13 = t6*t10; /* 1/gamma3 = s*1/(s*gamma3) */
    const double t14 = JLT_FNMA(x[3], t6, p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t15 = t13*t14; /* 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t16 = t6*t13; /* s*1/gamma3 */
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t18 = p[18]*t17; /* m*R*I3*V */
    const double t19 = t11*t18; /* 1/Theta*m*R*I3*V */
    const double t20 = x[3]*t12; /* omega_n*1/s */
    const double t21 = JLT_FMS(t13, t15, t20); /* 1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*1/s */
    const double t22 = p[16]*t21; /* d(omega3)/d(gamma3) = I1/I3*(1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*1/s) */
    const double t23 = x[2]*t12; /* omega_tau*1/s */
    const double t24 = x[0]*t20; /* gamma3*omega_n*1/s */
    const double t25 = t12*t20; /* 1/s*omega_n*1/s */
    const double t26 = JLT_FMS(t12, t19, t23); /* 1/s*1/Theta*m*R*I3*V - omega_tau*1/s */
    const double t27 = t20*t25; /* omega_n*1/s*1/s*omega_n*1/s */
    const double t28 = t25*t26; /* 1/s*omega_n*1/s*(1/s*1/Theta*m*R*I3*V - omega_tau*1/s) */
    const double t29 = x[0]*t23; /* gamma3*omega_tau*1/s */
    const double t30 = -t29; /* -gamma3*omega_tau*1/s */
    out[0] = t30;
    const double t31 = x[0]*t26; /* gamma3*(1/s*1/Theta*m*R*I3*V - omega_tau*1/s) */
    const double t32 = x[2]*t11; /* omega_tau*1/Theta */
    const double t33 = t11*t24; /* 1/Theta*gamma3*omega_n*1/s */
    const double t34 = p[21]*t11; /* I1*(I3^2 + m*R^2*I3)/I3*1/Theta */
    const double t35 = t19*t33; /* 1/Theta*m*R*I3*V*1/Theta*gamma3*omega_n*1/s */
    const double t36 = t15*t34; /* 1/gamma3*(G_level/(R*I1) - omega_n*s)*I1*(I3^2 + m*R^2*I3)/I3*1/Theta */
    const double t37 = JLT_FMS(x[3], t16, t15); /* omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t38 = JLT_FMA(t32, t36, t35); /* omega_tau*1/Theta*t36 + 1/Theta*m*R*I3*V*1/Theta*gamma3*omega_n*1/s */
    const double t39 = t24 - t36; /* gamma3*omega_n*1/s - t36 */
    const double t40 = JLT_FNMA(p[15], t33, t39); /* gamma3*omega_n*1/s - t36 - m*R^2*I3*1/Theta*gamma3*omega_n*1/s */
    out[14] = t40;
    const double t41 = p[22]*t33; /* (-m*R*I3)*1/Theta*gamma3*omega_n*1/s */
    out[13] = t41;
    const double t42 = x[3]*t22; /* omega_n*d(omega3)/d(gamma3) */
    const double t43 = p[19]*t32; /* (I3^2 + m*R^2*I3)*omega_tau*1/Theta */
    const double t44 = JLT_FMS(t22, t43, t28); /* d(omega3)/d(gamma3)*(I3^2 + m*R^2*I3)*omega_tau*1/Theta - 1/s*omega_n*1/s*(1/s*1/Theta*m*R*I3*V - omega_tau*1/s) */
    const double t45 = p[23]*t32; /* (I1*I3 + m*R^2*I1)*omega_tau*1/Theta */
    const double t46 = JLT_FMS(t16, t45, t31); /* s*1/gamma3*(I1*I3 + m*R^2*I1)*omega_tau*1/Theta - gamma3*(1/s*1/Theta*m*R*I3*V - omega_tau*1/s) */
    out[15] = t46;
    const double t47 = t27 + t42; /* omega_n*1/s*1/s*omega_n*1/s + omega_n*d(omega3)/d(gamma3) */
    const double t48 = JLT_FMA(p[10], t42, t27); /* I3/I1*omega_n*d(omega3)/d(gamma3) + omega_n*1/s*1/s*omega_n*1/s */
    const double t49 = p[1]*t47; /* R*(omega_n*1/s*1/s*omega_n*1/s + omega_n*d(omega3)/d(gamma3)) */
    out[4] = t49;
    const double t50 = -t48; /* -t48 */
    out[8] = t50;
    const double t51 = p[7]*t37; /* R*I1/I3*(omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - omega_n*s)) */
    const double t52 = JLT_FMA(p[17], t24, t51); /* 2*R*gamma3*omega_n*1/s + t51 */
    out[7] = t52;
    const double t53 = JLT_FMA(2.0, t24, t37); /* 2*gamma3*omega_n*1/s + omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t54 = -t53; /* -t53 */
    out[11] = t54;
    const double t55 = x[0]*p[20]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t56 = JLT_FNMA(t38, t55, t44); /* t44 - t38*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    out[12] = t56;
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
    const double t3 = x[0]*p[15]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[13]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(p[14], t2, t4); /* Theta = m*R^2*I1*(1 - gamma3)*(1 + gamma3) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[6] = t6;
    const double t7 = x[0]*t6; /* gamma3*s */
    const double t8 = t5*t7; /* Theta*gamma3*s */
    const double t9 = 1.0/t8; /* 1/(Theta*gamma3*s) */
    const double t10 = t5*t9; /* 1/(gamma3*s) = Theta*1/(Theta*gamma3*s) */
    const double t11 = t7*t9; /* 1/Theta = gamma3*s*1/(Theta*gamma3*s) */
    const double t12 = x[3]*t6; /* omega_n*s */
    const double t13 = p[8] - t12; /* G_level/(R*I1) - omega_n*s */
    const double t14 = t6*t10; /* 1/gamma3 = s*1/(gamma3*s) */
    const double t15 = t13*t14; /* (G_level/(R*I1) - omega_n*s)*1/gamma3 */
    const double t16 = x[0]*t10; /* 1/s = gamma3*1/(gamma3*s) */
    const double t17 = x[2]*t6; /* omega_tau*s */
    out[0] = t17;
    const double t18 = JLT_FNMA(t12, t14, t15); /* (G_level/(R*I1) - omega_n*s)*1/gamma3 - omega_n*s*1/gamma3 */
    const double t19 = p[23]*t17; /* (I1*I3 + m*R^2*I1)*omega_tau*s */
    const double t20 = t11*t19; /* 1/Theta*(I1*I3 + m*R^2*I1)*omega_tau*s */
    const double t21 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t22 = p[18]*t21; /* m*R*I3*V */
    const double t23 = p[16]*t15; /* I1/I3*(G_level/(R*I1) - omega_n*s)*1/gamma3 */
    const double t24 = x[3]*t16; /* omega_n*1/s */
    const double t25 = JLT_FNMA(t11, t22, x[2]); /* omega_tau - 1/Theta*m*R*I3*V */
    const double t26 = p[19]*t11; /* (I3^2 + m*R^2*I3)*1/Theta */
    const double t27 = t14*t23; /* 1/gamma3*I1/I3*(G_level/(R*I1) - omega_n*s)*1/gamma3 */
    const double t28 = JLT_FNMA(p[16], t24, t27); /* d(omega3)/d(gamma3) = 1/gamma3*I1/I3*(G_level/(R*I1) - omega_n*s)*1/gamma3 - I1/I3*omega_n*1/s */
    const double t29 = x[0]*t24; /* gamma3*omega_n*1/s */
    const double t30 = t15 - t29; /* (G_level/(R*I1) - omega_n*s)*1/gamma3 - gamma3*omega_n*1/s */
    const double t31 = x[3]*t30; /* omega_n*((G_level/(R*I1) - omega_n*s)*1/gamma3 - gamma3*omega_n*1/s) */
    out[2] = t31;
    const double t32 = JLT_FNMA(2.0, t29, t18); /* (G_level/(R*I1) - omega_n*s)*1/gamma3 - omega_n*s*1/gamma3 - 2*gamma3*omega_n*1/s */
    out[15] = t32;
    const double t33 = p[7]*t18; /* R*I1/I3*((G_level/(R*I1) - omega_n*s)*1/gamma3 - omega_n*s*1/gamma3) */
    const double t34 = JLT_FMS(p[17], t29, t33); /* 2*R*gamma3*omega_n*1/s - t33 */
    out[11] = t34;
    const double t35 = x[2]*t26; /* omega_tau*(I3^2 + m*R^2*I3)*1/Theta */
    const double t36 = JLT_FNMA(t23, t26, t29); /* gamma3*omega_n*1/s - I1/I3*(G_level/(R*I1) - omega_n*s)*1/gamma3*(I3^2 + m*R^2*I3)*1/Theta */
    const double t37 = t16*t24; /* 1/s*omega_n*1/s */
    const double t38 = t24*t37; /* omega_n*1/s*1/s*omega_n*1/s */
    const double t39 = t16*t25; /* 1/s*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t40 = t37*t39; /* 1/s*omega_n*1/s*1/s*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t41 = x[0]*t16; /* gamma3*1/s */
    const double t42 = JLT_FMA(t28, t35, t40); /* d(omega3)/d(gamma3)*omega_tau*(I3^2 + m*R^2*I3)*1/Theta + 1/s*omega_n*1/s*1/s*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t43 = t23*t35; /* I1/I3*(G_level/(R*I1) - omega_n*s)*1/gamma3*omega_tau*(I3^2 + m*R^2*I3)*1/Theta */
    const double t44 = x[3]*t28; /* omega_n*d(omega3)/d(gamma3) */
    const double t45 = t29 - t23; /* gamma3*omega_n*1/s - I1/I3*(G_level/(R*I1) - omega_n*s)*1/gamma3 */
    const double t46 = JLT_FMS(t25, t29, t43); /* (omega_tau - 1/Theta*m*R*I3*V)*gamma3*omega_n*1/s - t43 */
    out[3] = t46;
    const double t47 = t11*t29; /* 1/Theta*gamma3*omega_n*1/s */
    const double t48 = JLT_FMA(t22, t47, t43); /* m*R*I3*V*1/Theta*gamma3*omega_n*1/s + t43 */
    const double t49 = JLT_FNMA(p[15], t47, t36); /* t36 - m*R^2*I3*1/Theta*gamma3*omega_n*1/s */
    out[18] = t49;
    const double t50 = p[22]*t47; /* (-m*R*I3)*1/Theta*gamma3*omega_n*1/s */
    out[17] = t50;
    const double t51 = t25*t41; /* (omega_tau - 1/Theta*m*R*I3*V)*gamma3*1/s */
    const double t52 = JLT_FMA(t14, t20, t51); /* 1/gamma3*1/Theta*(I1*I3 + m*R^2*I1)*omega_tau*s + (omega_tau - 1/Theta*m*R*I3*V)*gamma3*1/s */
    out[19] = t52;
    const double t53 = x[2]*t41; /* omega_tau*gamma3*1/s */
    const double t54 = -t53; /* -omega_tau*gamma3*1/s */
    out[4] = t54;
    const double t55 = x[0]*p[20]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t56 = t11*t55; /* 1/Theta*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t57 = JLT_FNMA(t48, t56, t42); /* t42 - (m*R*I3*V*1/Theta*gamma3*omega_n*1/s + t43)*1/Theta*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    out[16] = t57;
    const double t58 = p[1]*x[3]; /* R*omega_n */
    const double t59 = t45*t58; /* t45*R*omega_n */
    out[1] = t59;
    const double t60 = t38 + t44; /* omega_n*1/s*1/s*omega_n*1/s + omega_n*d(omega3)/d(gamma3) */
    const double t61 = JLT_FMA(p[10], t44, t38); /* I3/I1*omega_n*d(omega3)/d(gamma3) + omega_n*1/s*1/s*omega_n*1/s */
    const double t62 = p[1]*t60; /* R*(omega_n*1/s*1/s*omega_n*1/s + omega_n*d(omega3)/d(gamma3)) */
    out[8] = t62;
    const double t63 = -t61; /* -t61 */
    out[12] = t63;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[15]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[13]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(p[14], t2, t4); /* Theta = m*R^2*I1*(1 - gamma3)*(1 + gamma3) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = x[0]*t5; /* gamma3*Theta */
    const double t8 = t6*t7; /* s*gamma3*Theta */
    const double t9 = t5*t6; /* Theta*s */
    const double t10 = 1.0/t8; /* 1/(s*gamma3*Theta) */
    const double t11 = p[23]*x[2]; /* (I1*I3 + m*R^2*I1)*omega_tau */
    const double t12 = t2*t11; /* (1 - gamma3)*(1 + gamma3)*(I1*I3 + m*R^2*I1)*omega_tau */
    const double t13 = t10*t12; /* 1/(s*gamma3*Theta)*(1 - gamma3)*(1 + gamma3)*(I1*I3 + m*R^2*I1)*omega_tau */
    const double t14 = x[0]*t10; /* 1/(Theta*s) = gamma3*1/(s*gamma3*Theta) */
    const double t15 = t9*t14; /* Theta*s*1/(Theta*s) */
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = x[0]*p[18]; /* gamma3*m*R*I3 */
    const double t18 = t16*t17; /* V*gamma3*m*R*I3 */
    const double t19 = JLT_FNMA(t14, t18, t13); /* t13 - 1/(Theta*s)*V*gamma3*m*R*I3 */
    const double t20 = t15*t19; /* Theta*s*1/(Theta*s)*(t13 - 1/(Theta*s)*V*gamma3*m*R*I3) */
    out[0] = t20;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[25]*x[1]; /* m/I1*v_nu */
    const double t1 = x[3]*x[3]; /* omega_n*omega_n */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = JLT_FNMA(x[3], t5, p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t7 = p[16]/x[0]; /* I1/I3/gamma3 */
    const double t8 = t6*t7; /* (G_level/(R*I1) - omega_n*s)*I1/I3/gamma3 */
    const double t9 = t8*t8; /* (G_level/(R*I1) - omega_n*s)*I1/I3/gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3/gamma3 */
    const double t10 = t5*t8; /* s*(G_level/(R*I1) - omega_n*s)*I1/I3/gamma3 */
    const double t11 = JLT_FMS(x[3], x[0], t10); /* v_tau/R = omega_n*gamma3 - s*(G_level/(R*I1) - omega_n*s)*I1/I3/gamma3 */
    const double t12 = p[26]*t11; /* m*R^2/I1*v_tau/R */
    const double t13 = JLT_FMA(x[2], x[2], t1); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t14 = JLT_FMA(x[1], t0, t13); /* v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t15 = JLT_FMA(p[10], t9, t14); /* I3/I1*t9 + v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t16 = JLT_FMA(t11, t12, t15); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t15 */
    const double t17 = p[24]*t16; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t17;
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t19 = p[27]*t18; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t20 = t18*t19; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t21 = p[10]*x[0]; /* I3/I1*gamma3 */
    const double t22 = t4 + p[9]; /* (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t23 = JLT_FMA(x[0], t21, t22); /* Theta/(m*R^2*I1) = gamma3*I3/I1*gamma3 + (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t24 = p[28]*t23; /* m*R^2*I1*(I1 - I3)*Theta/(m*R^2*I1) */
    const double t25 = JLT_FMA(t9, t24, t20); /* t9*m*R^2*I1*(I1 - I3)*Theta/(m*R^2*I1) + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t25;
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
    const double t6 = x[0]*t5; /* gamma3*s */
    const double t7 = 1.0/t6; /* 1/(gamma3*s) */
    const double t8 = t5*t7; /* 1/gamma3 = s*1/(gamma3*s) */
    const double t9 = x[0]*t7; /* 1/s = gamma3*1/(gamma3*s) */
    const double t10 = JLT_FNMA(x[3], t5, p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t11 = p[16]*t8; /* I1/I3*1/gamma3 */
    const double t12 = t10*t11; /* (G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t13 = JLT_FMA(t4, t11, x[0]); /* d(v_tau)/d(omega_n)/R = (1 - gamma3)*(1 + gamma3)*I1/I3*1/gamma3 + gamma3 */
    const double t14 = p[9] + t4; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t15 = p[26]*t13; /* m*R^2/I1*d(v_tau)/d(omega_n)/R */
    const double t16 = t8*t12; /* 1/gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t17 = x[3]*p[16]; /* omega_n*I1/I3 */
    const double t18 = JLT_FNMA(t9, t17, t16); /* d(omega3)/d(gamma3) = 1/gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 - 1/s*omega_n*I1/I3 */
    const double t19 = t5*t12; /* s*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t20 = t8*t19; /* 1/gamma3*s*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t21 = JLT_FMS(x[3], x[0], t19); /* v_tau/R = omega_n*gamma3 - s*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t22 = x[0]*t12; /* gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t23 = JLT_FMA(t9, t22, x[3]); /* 1/s*gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 + omega_n */
    const double t24 = JLT_FMA(t5, t18, t23); /* d(v_tau)/d(gamma3)/R = s*d(omega3)/d(gamma3) + t23 */
    const double t25 = t12*t18; /* (G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3*d(omega3)/d(gamma3) */
    const double t26 = p[30]*t12; /* (-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3))*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t27 = t22*t26; /* gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3*t26 */
    const double t28 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t29 = JLT_FMA(x[0], t28, t14); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t30 = x[3] - t20; /* omega_n - 1/gamma3*s*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t31 = JLT_FMA(t15, t21, t30); /* d(energy)/d(omega_n)/I1 = m*R^2/I1*d(v_tau)/d(omega_n)/R*v_tau/R + t30 */
    const double t32 = p[4]*t31; /* I1*d(energy)/d(omega_n)/I1 */
    out[3] = t32;
    const double t33 = p[29]*t21; /* m*R^2*v_tau/R */
    const double t34 = p[5]*t25; /* I3*t25 */
    const double t35 = JLT_FMS(t24, t33, t34); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R - I3*t25 */
    out[0] = t35;
    const double t36 = p[31]*t29; /* (-2*m*R^2*I1*(I1 - I3))*Theta/(m*R^2*I1) */
    const double t37 = JLT_FMA(t25, t36, t27); /* t25*(-2*m*R^2*I1*(I1 - I3))*Theta/(m*R^2*I1) + gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3*t26 */
    out[4] = t37;
    const double t38 = p[34]*t29; /* (-2*m*R^2*I1^2*(I1 - I3)/I3)*Theta/(m*R^2*I1) */
    const double t39 = t20*t38; /* 1/gamma3*s*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3*(-2*m*R^2*I1^2*(I1 - I3)/I3)*Theta/(m*R^2*I1) */
    out[7] = t39;
    const double t40 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t41 = p[32]*t40; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[5] = t41;
    const double t42 = p[33]*t40; /* 2*m*R*I1^2*(omega_tau*R + v_nu) */
    out[6] = t42;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FNMA(x[3], t3, p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t5 = p[35]/x[0]; /* (-I1/I3)/gamma3 */
    const double t6 = t4*t5; /* (G_level/(R*I1) - omega_n*s)*(-I1/I3)/gamma3 */
    out[0] = t6;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
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
        t12[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t13[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t14[k] = jlt_jet_product(t12, t13, k);
        t15[k] = jlt_jet_root(t14[k], t15, k);
        t16[k] = (k == 0 ? p[9] : 0) + t14[k];
        t17[k] = jlt_jet_product(x2, t15, k);
        t18[k] = jlt_jet_product(x0, x0, k);
        t19[k] = p[10]*t18[k] + t16[k];
        t20[k] = jlt_jet_product(x3, t18, k);
        t21[k] = jlt_jet_product(x0, t15, k);
        t22[k] = jlt_jet_product(t19, t21, k);
        t23[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t22, t23, k);
        t24[k] = jlt_jet_product(t19, t23, k);
        t25[k] = jlt_jet_product(t21, t23, k);
        t26[k] = jlt_jet_product(t20, t24, k);
        t27[k] = (k == 0 ? p[8] : 0) - jlt_jet_product(x3, t15, k);
        t28[k] = jlt_jet_product(t15, t27, k);
        t29[k] = jlt_jet_product(t24, t28, k);
        t30[k] = x2[k]*p[1] + x1[k];
        t31[k] = p[11]*t30[k];
        t32[k] = x2[k] - jlt_jet_product(t25, t31, k);
        t33[k] = jlt_jet_product(t26, t32, k);
        t34[k] = jlt_jet_product(x3, t26, k);
        t35[k] = jlt_jet_product(x3, t29, k);
        t36[k] = t35[k] - t34[k];
        t37[k] = p[7]*t35[k];
        t38[k] = p[1]*t34[k] - t37[k];
        t39[k] = x2[k]*p[12];
        t40[k] = jlt_jet_product(t25, t39, k);
        t41[k] = t33[k] - jlt_jet_product(t29, t40, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t17[k]/(k + 1);
        next[1] = x1[k + 1] = t38[k]/(k + 1);
        next[2] = x2[k + 1] = t36[k]/(k + 1);
        next[3] = x3[k + 1] = t41[k]/(k + 1);
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
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 36,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 18, 6, 1, 1, 0, 11, 6 }, { 11, 44, 0, 8, 1, 0, 11, 8 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .jacobian = { jacobian, 16, { 7, 33, 15, 1, 1, 0, 14, 12 }, { 34, 149, 0, 32, 1, 0, 16, 11 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 8, 38, 16, 1, 1, 0, 15, 15 }, { 40, 175, 0, 39, 1, 0, 16, 11 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .divergence = { divergence, 1, { 2, 13, 4, 1, 1, 0, 9, 6 }, { 6, 28, 0, 3, 1, 0, 11, 6 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_values = { integral_values, 2, { 3, 12, 9, 1, 1, 0, 10, 7 }, { 12, 44, 0, 1, 1, 0, 14, 6 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_gradients = { integral_gradients, 8, { 4, 26, 11, 1, 1, 0, 13, 10 }, { 20, 84, 0, 7, 1, 0, 13, 10 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 2, 1, 1, 1, 0, 5, 3 }, { 2, 6, 0, 1, 1, 0, 6, 4 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
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
