/* Sphere with displaced centre of mass rolling without slipping, reduced system
 *
 *  Source:     E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243
 *  Variant:    balanced: a3 = 0
 *  Table:      routh_sphere, SHA-256 7ea5d7e192247bbb71a43cf42803dc35e835526f39f8f2b9ef8220743e084b9e
 *  Command:    ttc generate --out DIR routh_sphere.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   16    5    1    1    0     10    8   (65)
 *  jacobian            3   33   13    1    1    0     11   11   (196)
 *  rhs_jacobian        6   33   16    1    1    0     11   16   (237)
 *  divergence          2    6    2    1    1    0      5    4   (24)
 *  integral_values     2   12    8    0    2    0      8    7   (47)
 *  integral_gradients  2   21    7    1    2    0      9    8   (71)
 *  measure_values      2    3    2    0    1    0      5    4   (21)
 *  measure_divergences 2   12    3    1    2    0      9    6   (47)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_routh_sphere[];
extern const jlt_descriptor jlt_kernels_routh_sphere_balanced;
extern const jlt_kernel_batch jlt_batch_routh_sphere_balanced_baseline;
extern const jlt_kernel_batch jlt_batch_routh_sphere_balanced_avx2;
extern const jlt_kernel_batch jlt_batch_routh_sphere_balanced_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[4] + t1; /* K = I1 + m*R*R */
    const double t3 = params[4]/t2; /* I1/K */
    const double t4 = t1/t2; /* m*R*R/K */
    const double t5 = params[4]*params[5]; /* I1*I3 */
    const double t6 = params[4]*t1; /* I1*m*R*R */
    const double t7 = t1*params[5]; /* m*R*R*I3 */
    const double t8 = params[5]/t2; /* I3/K */
    const double t9 = params[5]*params[5]; /* I3*I3 */
    const double t10 = t7 + t9; /* m*R*R*I3 + I3*I3 */
    const double t11 = params[4] - params[5]; /* I1 - I3 */
    const double t12 = t1*t11; /* m*R*R*(I1 - I3) */
    const double t13 = -t3; /* -I1/K */
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = -t14; /* -m*R */
    const double t16 = t14/t2; /* m*R/K */
    const double t17 = -t16; /* -m*R/K */
    const double t18 = t3*2.0; /* I1/K*2 */
    const double t19 = -t18; /* -I1/K*2 */
    const double t20 = t19 - t4; /* -I1/K*2 - m*R*R/K */
    const double t21 = -t8; /* -I3/K */
    const double t22 = t21 - t4; /* -I3/K - m*R*R/K */
    const double t23 = t6*2.0; /* I1*m*R*R*2 */
    const double t24 = t7*2.0; /* m*R*R*I3*2 */
    const double t25 = t23 - t24; /* I1*m*R*R*2 - m*R*R*I3*2 */
    const double t26 = -t12; /* -m*R*R*(I1 - I3) */
    const double t27 = t4 + t18; /* m*R*R/K + I1/K*2 */
    const double t28 = params[4]/2.0; /* I1/2 */
    const double t29 = params[5]/2.0; /* I3/2 */
    const double t30 = params[0]/2.0; /* m/2 */
    const double t31 = params[4]*params[1]; /* I1*R */
    const double t32 = params[1]*params[5]; /* R*I3 */
    const double t33 = -t31; /* -I1*R */
    const double t34 = -t32; /* -R*I3 */
    const double t35 = t7 - t6; /* m*R*R*I3 - I1*m*R*R */
    const double t36 = t6 - t7; /* I1*m*R*R - m*R*R*I3 */
    out[6] = t3;
    out[7] = t4;
    out[8] = t5;
    out[9] = t6;
    out[10] = t7;
    out[11] = t8;
    out[12] = t10;
    out[13] = t12;
    out[14] = t13;
    out[15] = t17;
    out[16] = t20;
    out[17] = t21;
    out[18] = t22;
    out[19] = t25;
    out[20] = t26;
    out[21] = t27;
    out[22] = t28;
    out[23] = t29;
    out[24] = t30;
    out[25] = t0;
    out[26] = t31;
    out[27] = t32;
    out[28] = t15;
    out[29] = t2;
    out[30] = t14;
    out[31] = t33;
    out[32] = t34;
    out[33] = t35;
    out[34] = t2;
    out[35] = t36;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[1]*t3; /* omega_tau*s */
    const double t5 = x[0]*x[2]; /* gamma3*omega_n */
    const double t6 = p[6]*t5; /* I1/K*gamma3*omega_n */
    const double t7 = t3*x[3]; /* s*omega3 */
    const double t8 = t5 + t7; /* gamma3*omega_n + s*omega3 */
    const double t9 = JLT_FMA(p[7], t8, t6); /* m*R^2/K*(gamma3*omega_n + s*omega3) + I1/K*gamma3*omega_n */
    const double t10 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t11 = JLT_FMA(x[0], t10, p[8]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t12 = JLT_FMA(t2, p[9], t11); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t13 = t3*t12; /* s*Theta */
    const double t14 = 1.0/t13; /* 1/(s*Theta) */
    const double t15 = t12*t14; /* Theta*1/(s*Theta) */
    const double t16 = t9*t15; /* (m*R^2/K*(gamma3*omega_n + s*omega3) + I1/K*gamma3*omega_n)*Theta*1/(s*Theta) */
    const double t17 = JLT_FMA(x[3], p[11], t16); /* omega3*I3/K + t16 */
    const double t18 = x[2]*t17; /* omega_n*(omega3*I3/K + t16) */
    const double t19 = -t18; /* -omega_n*(omega3*I3/K + t16) */
    const double t20 = t5*t15; /* gamma3*omega_n*Theta*1/(s*Theta) */
    const double t21 = t7*t14; /* s*omega3*1/(s*Theta) */
    const double t22 = JLT_FMA(p[12], t21, t20); /* (I3^2 + m*R^2*I3)*s*omega3*1/(s*Theta) + gamma3*omega_n*Theta*1/(s*Theta) */
    const double t23 = x[1]*t22; /* omega_tau*t22 */
    const double t24 = x[0]*p[13]; /* gamma3*m*R^2*(I1 - I3) */
    const double t25 = t4*t24; /* omega_tau*s*gamma3*m*R^2*(I1 - I3) */
    const double t26 = t21*t25; /* s*omega3*1/(s*Theta)*omega_tau*s*gamma3*m*R^2*(I1 - I3) */
    out[0] = t4;
    out[1] = t19;
    out[2] = t23;
    out[3] = t26;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[8]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(p[9], t2, t4); /* Theta = m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = t5*t6; /* Theta*s */
    const double t8 = 1.0/t7; /* 1/(Theta*s) */
    const double t9 = t5*t8; /* Theta*1/(Theta*s) */
    const double t10 = x[0]*t9; /* gamma3*Theta*1/(Theta*s) */
    const double t11 = x[1]*t10; /* omega_tau*gamma3*Theta*1/(Theta*s) */
    const double t12 = -t11; /* -omega_tau*gamma3*Theta*1/(Theta*s) */
    const double t13 = JLT_FMA(t10, t10, 1.0); /* gamma3*Theta*1/(Theta*s)*gamma3*Theta*1/(Theta*s) + 1 */
    const double t14 = t9*x[2]; /* Theta*1/(Theta*s)*omega_n */
    const double t15 = t13*t14; /* (gamma3*Theta*1/(Theta*s)*gamma3*Theta*1/(Theta*s) + 1)*Theta*1/(Theta*s)*omega_n */
    const double t16 = p[14]*x[2]; /* (-I1/K)*omega_n */
    const double t17 = t15*t16; /* t15*(-I1/K)*omega_n */
    const double t18 = x[0]*x[2]; /* gamma3*omega_n */
    const double t19 = JLT_FMA(t6, x[3], t18); /* s*omega3 + gamma3*omega_n */
    const double t20 = p[1]*t19; /* R*(s*omega3 + gamma3*omega_n) */
    const double t21 = t9*t20; /* Theta*1/(Theta*s)*R*(s*omega3 + gamma3*omega_n) */
    const double t22 = t10*t21; /* gamma3*Theta*1/(Theta*s)*Theta*1/(Theta*s)*R*(s*omega3 + gamma3*omega_n) */
    const double t23 = JLT_FNMA(t10, x[3], x[2]); /* omega_n - gamma3*Theta*1/(Theta*s)*omega3 */
    const double t24 = JLT_FMA(p[1], t23, t22); /* R*(omega_n - gamma3*Theta*1/(Theta*s)*omega3) + t22 */
    const double t25 = t14*p[15]; /* Theta*1/(Theta*s)*omega_n*(-m*R/K) */
    const double t26 = JLT_FMA(t24, t25, t17); /* (R*(omega_n - gamma3*Theta*1/(Theta*s)*omega3) + t22)*Theta*1/(Theta*s)*omega_n*(-m*R/K) + t15*(-I1/K)*omega_n */
    const double t27 = t10*x[2]; /* gamma3*Theta*1/(Theta*s)*omega_n */
    const double t28 = x[3]*p[17]; /* omega3*(-I3/K) */
    const double t29 = JLT_FMA(p[15], t21, t28); /* (-m*R/K)*Theta*1/(Theta*s)*R*(s*omega3 + gamma3*omega_n) + omega3*(-I3/K) */
    const double t30 = JLT_FMA(p[16], t27, t29); /* (-2*I1/K - m*R^2/K)*gamma3*Theta*1/(Theta*s)*omega_n + t29 */
    const double t31 = x[2]*p[18]; /* omega_n*(-I3/K - m*R^2/K) */
    const double t32 = x[1]*t15; /* omega_tau*t15 */
    const double t33 = x[0]*p[19]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t34 = t6*t8; /* s*1/(Theta*s) */
    const double t35 = x[3]*t34; /* omega3*s*1/(Theta*s) */
    const double t36 = x[1]*t34; /* omega_tau*s*1/(Theta*s) */
    const double t37 = p[12]*t36; /* (I3^2 + m*R^2*I3)*omega_tau*s*1/(Theta*s) */
    const double t38 = t33*t35; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*omega3*s*1/(Theta*s) */
    const double t39 = JLT_FMA(t37, t38, t32); /* (I3^2 + m*R^2*I3)*omega_tau*s*1/(Theta*s)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*omega3*s*1/(Theta*s) + omega_tau*t15 */
    const double t40 = JLT_FMA(t35, p[12], t27); /* omega3*s*1/(Theta*s)*(I3^2 + m*R^2*I3) + gamma3*Theta*1/(Theta*s)*omega_n */
    const double t41 = t6*t33; /* s*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t42 = JLT_FNMA(t34, t41, t10); /* gamma3*Theta*1/(Theta*s) - s*1/(Theta*s)*s*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t43 = JLT_FMS(x[0], t42, t6); /* gamma3*t42 - s */
    const double t44 = x[3]*p[20]; /* omega3*(-m*R^2*(I1 - I3)) */
    const double t45 = t36*t44; /* omega_tau*s*1/(Theta*s)*omega3*(-m*R^2*(I1 - I3)) */
    const double t46 = t43*t45; /* (gamma3*t42 - s)*omega_tau*s*1/(Theta*s)*omega3*(-m*R^2*(I1 - I3)) */
    const double t47 = x[0]*p[13]; /* gamma3*m*R^2*(I1 - I3) */
    const double t48 = t6*t47; /* s*gamma3*m*R^2*(I1 - I3) */
    const double t49 = t35*t48; /* omega3*s*1/(Theta*s)*s*gamma3*m*R^2*(I1 - I3) */
    const double t50 = t36*t48; /* omega_tau*s*1/(Theta*s)*s*gamma3*m*R^2*(I1 - I3) */
    out[0] = t12;
    out[1] = t6;
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = t26;
    out[5] = 0.0;
    out[6] = t30;
    out[7] = t31;
    out[8] = t39;
    out[9] = t40;
    out[10] = t11;
    out[11] = t37;
    out[12] = t46;
    out[13] = t49;
    out[14] = 0.0;
    out[15] = t50;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[1]*t3; /* omega_tau*s */
    const double t5 = x[0]*x[2]; /* gamma3*omega_n */
    const double t6 = JLT_FMA(t3, x[3], t5); /* s*omega3 + gamma3*omega_n */
    const double t7 = p[7]*t6; /* m*R^2/K*(s*omega3 + gamma3*omega_n) */
    const double t8 = JLT_FMA(p[6], t5, t7); /* I1/K*gamma3*omega_n + m*R^2/K*(s*omega3 + gamma3*omega_n) */
    const double t9 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t10 = JLT_FMA(x[0], t9, p[8]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t11 = JLT_FMA(t2, p[9], t10); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t12 = t3*t11; /* s*Theta */
    const double t13 = 1.0/t12; /* 1/(s*Theta) */
    const double t14 = t11*t13; /* Theta*1/(s*Theta) */
    const double t15 = x[2]*t14; /* omega_n*Theta*1/(s*Theta) */
    const double t16 = t8*t15; /* (I1/K*gamma3*omega_n + m*R^2/K*(s*omega3 + gamma3*omega_n))*omega_n*Theta*1/(s*Theta) */
    const double t17 = x[3]*p[11]; /* omega3*I3/K */
    const double t18 = JLT_FMA(x[2], t17, t16); /* omega_n*omega3*I3/K + t16 */
    const double t19 = -t18; /* -(omega_n*omega3*I3/K + t16) */
    const double t20 = x[0]*t14; /* gamma3*Theta*1/(s*Theta) */
    const double t21 = x[1]*t20; /* omega_tau*gamma3*Theta*1/(s*Theta) */
    const double t22 = t3*t13; /* s*1/(s*Theta) */
    const double t23 = x[1]*t22; /* omega_tau*s*1/(s*Theta) */
    const double t24 = x[3]*t23; /* omega3*omega_tau*s*1/(s*Theta) */
    const double t25 = p[12]*t24; /* (I3^2 + m*R^2*I3)*omega3*omega_tau*s*1/(s*Theta) */
    const double t26 = JLT_FMA(x[2], t21, t25); /* omega_n*omega_tau*gamma3*Theta*1/(s*Theta) + (I3^2 + m*R^2*I3)*omega3*omega_tau*s*1/(s*Theta) */
    const double t27 = t3*p[13]; /* s*m*R^2*(I1 - I3) */
    const double t28 = x[0]*t27; /* gamma3*s*m*R^2*(I1 - I3) */
    const double t29 = t24*t28; /* omega3*omega_tau*s*1/(s*Theta)*gamma3*s*m*R^2*(I1 - I3) */
    const double t30 = -t21; /* -omega_tau*gamma3*Theta*1/(s*Theta) */
    const double t31 = JLT_FNMA(x[3], t20, x[2]); /* omega_n - omega3*gamma3*Theta*1/(s*Theta) */
    const double t32 = p[6]*x[2]; /* I1/K*omega_n */
    const double t33 = t8*t14; /* (I1/K*gamma3*omega_n + m*R^2/K*(s*omega3 + gamma3*omega_n))*Theta*1/(s*Theta) */
    const double t34 = JLT_FMA(t20, t33, t32); /* gamma3*Theta*1/(s*Theta)*t33 + I1/K*omega_n */
    const double t35 = JLT_FMA(p[7], t31, t34); /* m*R^2/K*(omega_n - omega3*gamma3*Theta*1/(s*Theta)) + gamma3*Theta*1/(s*Theta)*t33 + I1/K*omega_n */
    const double t36 = t15*t35; /* omega_n*Theta*1/(s*Theta)*t35 */
    const double t37 = -t36; /* -omega_n*Theta*1/(s*Theta)*t35 */
    const double t38 = x[2]*t20; /* omega_n*gamma3*Theta*1/(s*Theta) */
    const double t39 = JLT_FMA(t7, t14, t17); /* m*R^2/K*(s*omega3 + gamma3*omega_n)*Theta*1/(s*Theta) + omega3*I3/K */
    const double t40 = JLT_FMA(p[21], t38, t39); /* (2*I1/K + m*R^2/K)*omega_n*gamma3*Theta*1/(s*Theta) + t39 */
    const double t41 = -t40; /* -((2*I1/K + m*R^2/K)*omega_n*gamma3*Theta*1/(s*Theta) + t39) */
    const double t42 = x[2]*p[18]; /* omega_n*(-I3/K - m*R^2/K) */
    const double t43 = JLT_FMA(t20, t21, x[1]); /* gamma3*Theta*1/(s*Theta)*omega_tau*gamma3*Theta*1/(s*Theta) + omega_tau */
    const double t44 = t15*t43; /* omega_n*Theta*1/(s*Theta)*t43 */
    const double t45 = x[0]*p[19]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t46 = t22*t45; /* s*1/(s*Theta)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t47 = JLT_FMA(t25, t46, t44); /* (I3^2 + m*R^2*I3)*omega3*omega_tau*s*1/(s*Theta)*s*1/(s*Theta)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) + omega_n*Theta*1/(s*Theta)*t43 */
    const double t48 = x[3]*t22; /* omega3*s*1/(s*Theta) */
    const double t49 = JLT_FMA(p[12], t48, t38); /* (I3^2 + m*R^2*I3)*omega3*s*1/(s*Theta) + omega_n*gamma3*Theta*1/(s*Theta) */
    const double t50 = p[12]*t23; /* (I3^2 + m*R^2*I3)*omega_tau*s*1/(s*Theta) */
    const double t51 = x[0]*p[13]; /* gamma3*m*R^2*(I1 - I3) */
    const double t52 = JLT_FNMA(t20, t51, t27); /* s*m*R^2*(I1 - I3) - gamma3*Theta*1/(s*Theta)*gamma3*m*R^2*(I1 - I3) */
    const double t53 = JLT_FMA(t28, t46, t52); /* gamma3*s*m*R^2*(I1 - I3)*s*1/(s*Theta)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) + t52 */
    const double t54 = t24*t53; /* omega3*omega_tau*s*1/(s*Theta)*t53 */
    const double t55 = t28*t48; /* gamma3*s*m*R^2*(I1 - I3)*omega3*s*1/(s*Theta) */
    const double t56 = t23*t28; /* omega_tau*s*1/(s*Theta)*gamma3*s*m*R^2*(I1 - I3) */
    out[0] = t4;
    out[1] = t19;
    out[2] = t26;
    out[3] = t29;
    out[4] = t30;
    out[5] = t3;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t37;
    out[9] = 0.0;
    out[10] = t41;
    out[11] = t42;
    out[12] = t47;
    out[13] = t49;
    out[14] = t21;
    out[15] = t50;
    out[16] = t54;
    out[17] = t55;
    out[18] = 0.0;
    out[19] = t56;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t5 = JLT_FMA(x[0], t4, p[8]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = JLT_FMA(t2, p[9], t5); /* Theta = (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t7 = 1.0/t6; /* 1/Theta */
    const double t8 = p[13]*x[0]; /* m*R^2*(I1 - I3)*gamma3 */
    const double t9 = x[1]*t8; /* omega_tau*m*R^2*(I1 - I3)*gamma3 */
    const double t10 = t3*t9; /* s*omega_tau*m*R^2*(I1 - I3)*gamma3 */
    const double t11 = t7*t10; /* 1/Theta*s*omega_tau*m*R^2*(I1 - I3)*gamma3 */
    out[0] = t11;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t1 = JLT_FMA(x[2], x[2], t0); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t2 = p[22]*t1; /* 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t3 = p[23]*x[3]; /* 1/2*I3*omega3 */
    const double t4 = x[2]*x[0]; /* omega_n*gamma3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = x[0] + 1.0; /* gamma3 + 1 */
    const double t7 = t5*t6; /* (1 - gamma3)*(gamma3 + 1) */
    const double t8 = sqrt(t7); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = JLT_FMA(x[3], t8, t4); /* omega3*s + omega_n*gamma3 */
    const double t10 = p[1]*t9; /* v_tau = R*(omega3*s + omega_n*gamma3) */
    const double t11 = t10*t10; /* v_tau*v_tau */
    const double t12 = JLT_FMA(t0, p[25], t11); /* omega_tau*omega_tau*R^2 + v_tau*v_tau */
    const double t13 = JLT_FMA(x[3], t3, t2); /* omega3*1/2*I3*omega3 + 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t14 = JLT_FMA(p[24], t12, t13); /* 1/2*m*(omega_tau*omega_tau*R^2 + v_tau*v_tau) + t13 */
    const double t15 = x[2]*p[26]; /* omega_n*R*I1 */
    const double t16 = t8*t15; /* s*omega_n*R*I1 */
    const double t17 = x[3]*p[27]; /* omega3*R*I3 */
    const double t18 = JLT_FNMA(x[0], t17, t16); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    const double t19 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t20 = JLT_FMA(x[0], t19, p[8]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t21 = JLT_FMA(t7, p[9], t20); /* Theta = (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t22 = sqrt(t21); /* h = sqrt(Theta) */
    const double t23 = x[3]*t22; /* omega3*h */
    out[0] = t14;
    out[1] = t18;
    out[2] = t23;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0]*x[2]; /* gamma3*omega_n */
    const double t5 = JLT_FMA(x[3], t3, t4); /* omega3*s + gamma3*omega_n */
    const double t6 = p[1]*t5; /* v_tau = R*(omega3*s + gamma3*omega_n) */
    const double t7 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t8 = JLT_FMA(x[0], t7, p[8]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t9 = JLT_FMA(t2, p[9], t8); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t10 = sqrt(t9); /* h = sqrt(Theta) */
    const double t11 = t3*t10; /* s*h */
    const double t12 = 1.0/t11; /* 1/(s*h) */
    const double t13 = t10*t12; /* h*1/(s*h) */
    const double t14 = x[3]*x[0]; /* omega3*gamma3 */
    const double t15 = JLT_FMS(t13, t14, x[2]); /* h*1/(s*h)*omega3*gamma3 - omega_n */
    const double t16 = p[28]*t6; /* (-m*R)*v_tau */
    const double t17 = t15*t16; /* (h*1/(s*h)*omega3*gamma3 - omega_n)*(-m*R)*v_tau */
    const double t18 = p[29]*x[1]; /* (I1 + m*R^2)*omega_tau */
    const double t19 = x[2]*p[4]; /* omega_n*I1 */
    const double t20 = t6*p[30]; /* v_tau*m*R */
    const double t21 = JLT_FMA(x[0], t20, t19); /* gamma3*v_tau*m*R + omega_n*I1 */
    const double t22 = t3*t20; /* s*v_tau*m*R */
    const double t23 = JLT_FMA(x[3], p[5], t22); /* omega3*I3 + s*v_tau*m*R */
    const double t24 = t4*p[31]; /* gamma3*omega_n*(-R*I1) */
    const double t25 = t13*t24; /* h*1/(s*h)*gamma3*omega_n*(-R*I1) */
    const double t26 = JLT_FMA(x[3], p[32], t25); /* omega3*(-R*I3) + h*1/(s*h)*gamma3*omega_n*(-R*I1) */
    const double t27 = t3*p[26]; /* s*R*I1 */
    const double t28 = x[0]*p[32]; /* gamma3*(-R*I3) */
    const double t29 = x[3]*p[33]; /* omega3*(-m*R^2*I1 + m*R^2*I3) */
    const double t30 = x[0]*t29; /* gamma3*omega3*(-m*R^2*I1 + m*R^2*I3) */
    const double t31 = t3*t30; /* s*gamma3*omega3*(-m*R^2*I1 + m*R^2*I3) */
    const double t32 = t12*t31; /* 1/(s*h)*s*gamma3*omega3*(-m*R^2*I1 + m*R^2*I3) */
    out[0] = t17;
    out[1] = t18;
    out[2] = t21;
    out[3] = t23;
    out[4] = t26;
    out[5] = 0.0;
    out[6] = t27;
    out[7] = t28;
    out[8] = t32;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t10;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = p[9]*t0; /* m*R^2*I1*(1 - gamma3) */
    const double t3 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[8]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(t1, t2, t4); /* Theta = (1 + gamma3)*m*R^2*I1*(1 - gamma3) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = sqrt(t5); /* h = sqrt(Theta) */
    const double t7 = p[34]*t6; /* K*h */
    out[0] = t7;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t5 = JLT_FMA(x[0], t4, p[8]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = JLT_FMA(t2, p[9], t5); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t7 = sqrt(t6); /* h = sqrt(Theta) */
    const double t8 = t6*t7; /* Theta*h */
    const double t9 = 1.0/t8; /* 1/(Theta*h) */
    const double t10 = x[0]*p[13]; /* gamma3*m*R^2*(I1 - I3) */
    const double t11 = t7*t10; /* h*gamma3*m*R^2*(I1 - I3) */
    const double t12 = t7*t11; /* h*h*gamma3*m*R^2*(I1 - I3) */
    const double t13 = t9*t12; /* 1/(Theta*h)*h*h*gamma3*m*R^2*(I1 - I3) */
    const double t14 = x[0]*p[35]; /* gamma3*(m*R^2*I1 - m*R^2*I3) */
    const double t15 = t6*t14; /* Theta*gamma3*(m*R^2*I1 - m*R^2*I3) */
    const double t16 = JLT_FNMA(t9, t15, t13); /* 1/(Theta*h)*h*h*gamma3*m*R^2*(I1 - I3) - 1/(Theta*h)*Theta*gamma3*(m*R^2*I1 - m*R^2*I3) */
    const double t17 = p[34]*x[1]; /* K*omega_tau */
    const double t18 = t3*t17; /* s*K*omega_tau */
    const double t19 = t16*t18; /* t16*s*K*omega_tau */
    out[0] = t19;
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
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x1, t6, k);
        t10[k] = jlt_jet_product(x0, x2, k);
        t11[k] = p[6]*t10[k];
        t14[k] = jlt_jet_product(t6, x3, k);
        t15[k] = t10[k] + t14[k];
        t16[k] = p[7]*t15[k] + t11[k];
        t20[k] = x0[k]*p[10];
        t21[k] = jlt_jet_product(x0, t20, k) + (k == 0 ? p[8] : 0);
        t22[k] = t5[k]*p[9] + t21[k];
        t23[k] = jlt_jet_product(t6, t22, k);
        t24[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t23, t24, k);
        t25[k] = jlt_jet_product(t22, t24, k);
        t26[k] = jlt_jet_product(t16, t25, k);
        t28[k] = x3[k]*p[11] + t26[k];
        t29[k] = jlt_jet_product(x2, t28, k);
        t30[k] = -t29[k];
        t31[k] = jlt_jet_product(t10, t25, k);
        t33[k] = jlt_jet_product(t14, t24, k);
        t34[k] = p[12]*t33[k] + t31[k];
        t35[k] = jlt_jet_product(x1, t34, k);
        t37[k] = x0[k]*p[13];
        t38[k] = jlt_jet_product(t7, t37, k);
        t39[k] = jlt_jet_product(t33, t38, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t30[k]/(k + 1);
        next[2] = x2[k + 1] = t35[k]/(k + 1);
        next[3] = x3[k + 1] = t39[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[1];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_I1 = params[4];
    const double complex v_omega_n = x[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double v_a3 = (0.0);
    const double complex v_K = (v_I1 + v_m*(v_R*v_R + v_a3*v_a3 + 2.0*v_R*v_a3*v_gamma3));
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_v_tau = (v_omega_n*v_b + v_R*v_omega3*v_s);
    const double v_g = params[2];
    out[1] = (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_K))
        + (-v_I3*v_omega_n*v_omega3/v_K)
        + (-v_m*v_omega_n*v_e*v_v_tau/(v_s*v_K))
        + (-v_m*v_R*v_a3*v_omega_tau*v_omega_tau*v_s/v_K)
        + (-v_m*v_g*v_a3*v_s/v_K);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    out[2] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta)
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta);
    out[3] = (v_m*v_R*v_omega_tau*v_omega3*v_s*(v_R*v_gamma3*(v_I1 - v_I3) - v_a3*v_I3)/v_Theta);
}

static const unsigned char family0_is_free[] = { 1, 0, 0, 1 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = x[3];
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
}

static const jlt_equilibria equilibria[] = {
    { .name = "rolling", .condition = "a3 = 0",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .left_null_count = 0, .obstructs = 0 },
};

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "Jellett", "" },
    { "Routh", "" },
};

static const jlt_named measures[] = {
    { "rho", "" },
};

const jlt_descriptor jlt_kernels_routh_sphere_balanced = {
    .model = "routh_sphere",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Sphere with displaced centre of mass rolling without slipping, reduced system",
    .source = "E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243",
    .sha256 = "7ea5d7e192247bbb71a43cf42803dc35e835526f39f8f2b9ef8220743e084b9e",
    .generator = "ttc 0.1.0",
    .table = jlt_table_routh_sphere,
    .state_count = 4, .param_count = 6, .block_count = 36,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 16, 5, 1, 1, 0, 10, 8 }, { 11, 46, 0, 7, 1, 0, 10, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 3, 33, 13, 1, 1, 0, 11, 11 }, { 31, 137, 0, 27, 1, 0, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 6, 33, 16, 1, 1, 0, 11, 16 }, { 37, 165, 0, 34, 1, 0, 11, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 6, 2, 1, 1, 0, 5, 4 }, { 4, 18, 0, 1, 1, 0, 8, 5 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 2, 12, 8, 0, 2, 0, 8, 7 }, { 9, 36, 0, 0, 2, 0, 10, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 12, { 2, 21, 7, 1, 2, 0, 9, 8 }, { 12, 54, 0, 3, 2, 0, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by h: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { measure_values, 1, { 2, 3, 2, 0, 1, 0, 5, 4 }, { 4, 15, 0, 0, 2, 0, 9, 5 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .measure_divergences = { measure_divergences, 1, { 2, 12, 3, 1, 2, 0, 9, 6 }, { 7, 36, 0, 2, 2, 0, 12, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; divides by h: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 3, .measure_count = 1, .equilibria_count = 1,
    .integrals = integrals,
    .measures = measures,
    .equilibria = equilibria,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_routh_sphere_balanced_baseline,
        &jlt_batch_routh_sphere_balanced_avx2,
        &jlt_batch_routh_sphere_balanced_avx512,
    },
};
