/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   18    6    1    1    0     11    7   (72)
 *  jacobian            6   39   13    1    1    0     14   16   (239)
 *  rhs_jacobian        10   43   14    1    1    0     13   16   (293)
 *  divergence          3   10    3    1    1    0      8    6   (33)
 *  integral_values     3   14    9    0    1    0      8    8   (58)
 *  integral_gradients  3   20    7    1    1    0      6    8   (85)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_avx512;

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
    const double t2 = params[5]/t1; /* I3/(m*R*R) */
    const double t3 = params[5]/params[4]; /* I3/I1 */
    const double t4 = t1*params[4]; /* m*R*R*I1 */
    const double t5 = params[5]*params[5]; /* I3*I3 */
    const double t6 = t1*params[5]; /* m*R*R*I3 */
    const double t7 = t5 + t6; /* I3*I3 + m*R*R*I3 */
    const double t8 = t7/t4; /* (I3*I3 + m*R*R*I3)/(m*R*R*I1) */
    const double t9 = 1.0/params[1]; /* 1/R */
    const double t10 = params[4] - params[5]; /* I1 - I3 */
    const double t11 = t10/params[4]; /* (I1 - I3)/I1 */
    const double t12 = params[1]*2.0; /* R*2 */
    const double t13 = -t3; /* -I3/I1 */
    const double t14 = params[0]*params[0]; /* m*m */
    const double t15 = t0*t0; /* R*R*R*R */
    const double t16 = t14*t15; /* m*m*R*R*R*R */
    const double t17 = params[4]*params[4]; /* I1*I1 */
    const double t18 = t16*t17; /* m*m*R*R*R*R*I1*I1 */
    const double t19 = t7*2.0; /* (I3*I3 + m*R*R*I3)*2 */
    const double t20 = t4 - t6; /* m*R*R*I1 - m*R*R*I3 */
    const double t21 = t19*t20; /* (I3*I3 + m*R*R*I3)*2*(m*R*R*I1 - m*R*R*I3) */
    const double t22 = t21/t18; /* (I3*I3 + m*R*R*I3)*2*(m*R*R*I1 - m*R*R*I3)/(m*m*R*R*R*R*I1*I1) */
    const double t23 = t1*t17; /* m*R*R*I1*I1 */
    const double t24 = params[5]*2.0; /* I3*2 */
    const double t25 = t20*t24; /* (m*R*R*I1 - m*R*R*I3)*I3*2 */
    const double t26 = t25/t23; /* (m*R*R*I1 - m*R*R*I3)*I3*2/(m*R*R*I1*I1) */
    const double t27 = params[1]*params[4]; /* R*I1 */
    const double t28 = params[5]/t27; /* I3/(R*I1) */
    const double t29 = -t28; /* -I3/(R*I1) */
    const double t30 = 2.0*t20; /* 2*(m*R*R*I1 - m*R*R*I3) */
    const double t31 = t30/t4; /* 2*(m*R*R*I1 - m*R*R*I3)/(m*R*R*I1) */
    const double t32 = (-1.0)/params[1]; /* (-1)/R */
    const double t33 = params[4]/2.0; /* I1/2 */
    const double t34 = params[0]/params[4]; /* m/I1 */
    const double t35 = t1/params[4]; /* m*R*R/I1 */
    const double t36 = params[1]*params[5]; /* R*I3 */
    const double t37 = params[0]*t17; /* m*I1*I1 */
    const double t38 = t4*t10; /* m*R*R*I1*(I1 - I3) */
    const double t39 = -t27; /* -R*I1 */
    const double t40 = -t36; /* -R*I3 */
    const double t41 = t10*(-2.0); /* (I1 - I3)*(-2) */
    const double t42 = t20*t41; /* (m*R*R*I1 - m*R*R*I3)*(I1 - I3)*(-2) */
    const double t43 = params[0]*2.0; /* m*2 */
    const double t44 = t17*t43; /* I1*I1*m*2 */
    const double t45 = params[1]*t43; /* R*m*2 */
    const double t46 = t17*t45; /* I1*I1*R*m*2 */
    const double t47 = t0*t43; /* R*R*m*2 */
    const double t48 = params[4]*t47; /* I1*R*R*m*2 */
    const double t49 = t10*t48; /* (I1 - I3)*I1*R*R*m*2 */
    out[6] = t2;
    out[7] = t3;
    out[8] = t8;
    out[9] = t9;
    out[10] = t11;
    out[11] = t12;
    out[12] = t13;
    out[13] = t22;
    out[14] = t26;
    out[15] = t29;
    out[16] = t31;
    out[17] = t32;
    out[18] = t28;
    out[19] = t33;
    out[20] = t34;
    out[21] = t35;
    out[22] = t27;
    out[23] = t36;
    out[24] = t37;
    out[25] = t38;
    out[26] = t1;
    out[27] = t39;
    out[28] = t40;
    out[29] = t42;
    out[30] = t44;
    out[31] = t46;
    out[32] = t49;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t6 = t2 + p[6]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta scaled = gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t8 = t3*t7; /* s*Theta scaled */
    const double t9 = 1.0/t8; /* 1/(s*Theta scaled) */
    const double t10 = x[0]*x[3]; /* gamma3*omega_n */
    const double t11 = t7*t10; /* Theta scaled*gamma3*omega_n */
    const double t12 = t9*t11; /* 1/(s*Theta scaled)*Theta scaled*gamma3*omega_n */
    const double t13 = x[4] + t12; /* omega3 + 1/(s*Theta scaled)*Theta scaled*gamma3*omega_n */
    const double t14 = p[1]*x[3]; /* R*omega_n */
    const double t15 = t13*t14; /* (omega3 + 1/(s*Theta scaled)*Theta scaled*gamma3*omega_n)*R*omega_n */
    const double t16 = JLT_FMA(x[4], p[7], t12); /* omega3*I3/I1 + 1/(s*Theta scaled)*Theta scaled*gamma3*omega_n */
    const double t17 = x[3]*t16; /* omega_n*t16 */
    const double t18 = -t17; /* -omega_n*t16 */
    const double t19 = t3*t9; /* s*1/(s*Theta scaled) */
    const double t20 = x[4]*t19; /* omega3*s*1/(s*Theta scaled) */
    const double t21 = JLT_FMA(p[8], t20, t12); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega3*s*1/(s*Theta scaled) + 1/(s*Theta scaled)*Theta scaled*gamma3*omega_n */
    const double t22 = x[2]*t21; /* omega_tau*t21 */
    const double t23 = JLT_FMA(p[9], x[1], x[2]); /* V scaled = 1/R*v_nu + omega_tau */
    const double t24 = t19*t23; /* s*1/(s*Theta scaled)*V scaled */
    const double t25 = p[7]*t12; /* I3/I1*1/(s*Theta scaled)*Theta scaled*gamma3*omega_n */
    const double t26 = JLT_FNMA(t24, t25, t22); /* omega_tau*t21 - s*1/(s*Theta scaled)*V scaled*I3/I1*1/(s*Theta scaled)*Theta scaled*gamma3*omega_n */
    const double t27 = x[3]*t24; /* omega_n*s*1/(s*Theta scaled)*V scaled */
    const double t28 = x[0]*p[10]; /* gamma3*(I1 - I3)/I1 */
    const double t29 = t4*t28; /* omega_tau*s*gamma3*(I1 - I3)/I1 */
    const double t30 = JLT_FMS(t20, t29, t27); /* omega3*s*1/(s*Theta scaled)*omega_tau*s*gamma3*(I1 - I3)/I1 - omega_n*s*1/(s*Theta scaled)*V scaled */
    out[0] = t4;
    out[1] = t15;
    out[2] = t18;
    out[3] = t26;
    out[4] = t30;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t4 = p[6] + t2; /* I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta scaled = gamma3*gamma3*I3/I1 + I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = t5*t6; /* Theta scaled*s */
    const double t8 = 1.0/t7; /* 1/(Theta scaled*s) */
    const double t9 = t5*t8; /* Theta scaled*1/(Theta scaled*s) */
    const double t10 = x[0]*t9; /* gamma3*Theta scaled*1/(Theta scaled*s) */
    const double t11 = x[2]*t10; /* omega_tau*gamma3*Theta scaled*1/(Theta scaled*s) */
    const double t12 = -t11; /* -omega_tau*gamma3*Theta scaled*1/(Theta scaled*s) */
    const double t13 = t9*x[3]; /* Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t14 = t9*t13; /* Theta scaled*1/(Theta scaled*s)*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t15 = t13*t14; /* Theta scaled*1/(Theta scaled*s)*omega_n*t14 */
    const double t16 = p[1]*t15; /* R*Theta scaled*1/(Theta scaled*s)*omega_n*t14 */
    const double t17 = p[1]*x[4]; /* R*omega3 */
    const double t18 = x[0]*t13; /* gamma3*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t19 = JLT_FMA(p[11], t18, t17); /* 2*R*gamma3*Theta scaled*1/(Theta scaled*s)*omega_n + R*omega3 */
    const double t20 = p[1]*x[3]; /* R*omega_n */
    const double t21 = -t15; /* -Theta scaled*1/(Theta scaled*s)*omega_n*t14 */
    const double t22 = x[4]*p[12]; /* omega3*(-I3/I1) */
    const double t23 = JLT_FMA(t18, (-2.0), t22); /* gamma3*Theta scaled*1/(Theta scaled*s)*omega_n*(-2) + omega3*(-I3/I1) */
    const double t24 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    const double t25 = t6*t8; /* s*1/(Theta scaled*s) */
    const double t26 = x[4]*t25; /* omega3*s*1/(Theta scaled*s) */
    const double t27 = x[2]*t26; /* omega_tau*omega3*s*1/(Theta scaled*s) */
    const double t28 = x[0]*t25; /* gamma3*s*1/(Theta scaled*s) */
    const double t29 = p[13]*t28; /* 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2)*gamma3*s*1/(Theta scaled*s) */
    const double t30 = t27*t29; /* omega_tau*omega3*s*1/(Theta scaled*s)*t29 */
    const double t31 = JLT_FMA(p[9], x[1], x[2]); /* V scaled = 1/R*v_nu + omega_tau */
    const double t32 = t13*t28; /* Theta scaled*1/(Theta scaled*s)*omega_n*gamma3*s*1/(Theta scaled*s) */
    const double t33 = p[14]*t31; /* 2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2)*V scaled */
    const double t34 = t28*t33; /* gamma3*s*1/(Theta scaled*s)*2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2)*V scaled */
    const double t35 = t25*t31; /* s*1/(Theta scaled*s)*V scaled */
    const double t36 = JLT_FNMA(p[7], t35, x[2]); /* omega_tau - I3/I1*s*1/(Theta scaled*s)*V scaled */
    const double t37 = t9*t14; /* Theta scaled*1/(Theta scaled*s)*t14 */
    const double t38 = JLT_FNMA(t32, t34, t30); /* omega_tau*omega3*s*1/(Theta scaled*s)*t29 - t32*t34 */
    const double t39 = JLT_FMA(t36, t37, t38); /* (omega_tau - I3/I1*s*1/(Theta scaled*s)*V scaled)*Theta scaled*1/(Theta scaled*s)*t14 + omega_tau*omega3*s*1/(Theta scaled*s)*t29 - t32*t34 */
    const double t40 = t32*p[15]; /* t32*(-I3/(R*I1)) */
    const double t41 = JLT_FMA(t26, p[8], t18); /* omega3*s*1/(Theta scaled*s)*(I3^2 + m*R^2*I3)/(m*R^2*I1) + gamma3*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t42 = JLT_FNMA(p[7], t32, t41); /* t41 - I3/I1*t32 */
    const double t43 = t10*t36; /* gamma3*Theta scaled*1/(Theta scaled*s)*(omega_tau - I3/I1*s*1/(Theta scaled*s)*V scaled) */
    const double t44 = x[2]*p[8]; /* omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t45 = t25*t44; /* s*1/(Theta scaled*s)*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t46 = t6*p[10]; /* s*(I1 - I3)/I1 */
    const double t47 = t28*t46; /* gamma3*s*1/(Theta scaled*s)*s*(I1 - I3)/I1 */
    const double t48 = x[2]*t47; /* omega_tau*gamma3*s*1/(Theta scaled*s)*s*(I1 - I3)/I1 */
    const double t49 = x[4]*t48; /* omega3*omega_tau*gamma3*s*1/(Theta scaled*s)*s*(I1 - I3)/I1 */
    const double t50 = x[3]*t25; /* omega_n*s*1/(Theta scaled*s) */
    const double t51 = JLT_FNMA(t31, t50, t49); /* omega3*omega_tau*gamma3*s*1/(Theta scaled*s)*s*(I1 - I3)/I1 - V scaled*omega_n*s*1/(Theta scaled*s) */
    const double t52 = t28*p[16]; /* gamma3*s*1/(Theta scaled*s)*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t53 = t51*t52; /* t51*t52 */
    const double t54 = JLT_FMS(x[0], t10, t6); /* gamma3*gamma3*Theta scaled*1/(Theta scaled*s) - s */
    const double t55 = t27*p[10]; /* omega_tau*omega3*s*1/(Theta scaled*s)*(I1 - I3)/I1 */
    const double t56 = JLT_FNMA(t54, t55, t53); /* t51*t52 - (gamma3*gamma3*Theta scaled*1/(Theta scaled*s) - s)*omega_tau*omega3*s*1/(Theta scaled*s)*(I1 - I3)/I1 */
    const double t57 = t50*p[17]; /* omega_n*s*1/(Theta scaled*s)*(-1/R) */
    const double t58 = JLT_FMS(x[4], t47, t50); /* omega3*gamma3*s*1/(Theta scaled*s)*s*(I1 - I3)/I1 - omega_n*s*1/(Theta scaled*s) */
    const double t59 = -t35; /* -s*1/(Theta scaled*s)*V scaled */
    out[0] = t12;
    out[1] = 0.0;
    out[2] = t6;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t16;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t19;
    out[9] = t20;
    out[10] = t21;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t23;
    out[14] = t24;
    out[15] = t39;
    out[16] = t40;
    out[17] = t42;
    out[18] = t43;
    out[19] = t45;
    out[20] = t56;
    out[21] = t57;
    out[22] = t58;
    out[23] = t59;
    out[24] = t48;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = p[1]*x[3]; /* R*omega_n */
    const double t6 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t7 = t2 + p[6]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t8 = JLT_FMA(x[0], t6, t7); /* Theta scaled = gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t9 = t3*t8; /* s*Theta scaled */
    const double t10 = 1.0/t9; /* 1/(s*Theta scaled) */
    const double t11 = t8*t10; /* Theta scaled*1/(s*Theta scaled) */
    const double t12 = x[3]*t11; /* omega_n*Theta scaled*1/(s*Theta scaled) */
    const double t13 = x[0]*t12; /* gamma3*omega_n*Theta scaled*1/(s*Theta scaled) */
    const double t14 = x[4] + t13; /* omega3 + gamma3*omega_n*Theta scaled*1/(s*Theta scaled) */
    const double t15 = t5*t14; /* R*omega_n*(omega3 + gamma3*omega_n*Theta scaled*1/(s*Theta scaled)) */
    const double t16 = x[4]*p[7]; /* omega3*I3/I1 */
    const double t17 = t13 + t16; /* gamma3*omega_n*Theta scaled*1/(s*Theta scaled) + omega3*I3/I1 */
    const double t18 = x[3]*t17; /* omega_n*t17 */
    const double t19 = -t18; /* -omega_n*t17 */
    const double t20 = JLT_FMA(p[9], x[1], x[2]); /* V scaled = 1/R*v_nu + omega_tau */
    const double t21 = t3*t10; /* s*1/(s*Theta scaled) */
    const double t22 = t20*t21; /* V scaled*s*1/(s*Theta scaled) */
    const double t23 = JLT_FNMA(p[7], t22, x[2]); /* omega_tau - I3/I1*V scaled*s*1/(s*Theta scaled) */
    const double t24 = t13*t23; /* gamma3*omega_n*Theta scaled*1/(s*Theta scaled)*(omega_tau - I3/I1*V scaled*s*1/(s*Theta scaled)) */
    const double t25 = x[4]*t21; /* omega3*s*1/(s*Theta scaled) */
    const double t26 = x[2]*t25; /* omega_tau*omega3*s*1/(s*Theta scaled) */
    const double t27 = JLT_FMA(p[8], t26, t24); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*omega3*s*1/(s*Theta scaled) + t24 */
    const double t28 = x[0]*p[10]; /* gamma3*(I1 - I3)/I1 */
    const double t29 = t3*t28; /* s*gamma3*(I1 - I3)/I1 */
    const double t30 = t26*t29; /* omega_tau*omega3*s*1/(s*Theta scaled)*s*gamma3*(I1 - I3)/I1 */
    const double t31 = JLT_FNMA(x[3], t22, t30); /* omega_tau*omega3*s*1/(s*Theta scaled)*s*gamma3*(I1 - I3)/I1 - omega_n*V scaled*s*1/(s*Theta scaled) */
    const double t32 = x[0]*t11; /* gamma3*Theta scaled*1/(s*Theta scaled) */
    const double t33 = x[2]*t32; /* omega_tau*gamma3*Theta scaled*1/(s*Theta scaled) */
    const double t34 = -t33; /* -omega_tau*gamma3*Theta scaled*1/(s*Theta scaled) */
    const double t35 = t11*t12; /* Theta scaled*1/(s*Theta scaled)*omega_n*Theta scaled*1/(s*Theta scaled) */
    const double t36 = t12*t35; /* omega_n*Theta scaled*1/(s*Theta scaled)*t35 */
    const double t37 = p[1]*t36; /* R*omega_n*Theta scaled*1/(s*Theta scaled)*t35 */
    const double t38 = p[1]*x[4]; /* R*omega3 */
    const double t39 = JLT_FMA(t13, p[11], t38); /* gamma3*omega_n*Theta scaled*1/(s*Theta scaled)*2*R + R*omega3 */
    const double t40 = -t36; /* -omega_n*Theta scaled*1/(s*Theta scaled)*t35 */
    const double t41 = JLT_FMA(t13, 2.0, t16); /* gamma3*omega_n*Theta scaled*1/(s*Theta scaled)*2 + omega3*I3/I1 */
    const double t42 = -t41; /* -t41 */
    const double t43 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    const double t44 = x[0]*t21; /* gamma3*s*1/(s*Theta scaled) */
    const double t45 = p[14]*t44; /* 2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2)*gamma3*s*1/(s*Theta scaled) */
    const double t46 = t22*t45; /* V scaled*s*1/(s*Theta scaled)*t45 */
    const double t47 = t13*t46; /* gamma3*omega_n*Theta scaled*1/(s*Theta scaled)*V scaled*s*1/(s*Theta scaled)*t45 */
    const double t48 = t44*p[13]; /* gamma3*s*1/(s*Theta scaled)*2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2) */
    const double t49 = t11*t35; /* Theta scaled*1/(s*Theta scaled)*t35 */
    const double t50 = JLT_FMS(t26, t48, t47); /* omega_tau*omega3*s*1/(s*Theta scaled)*t48 - t47 */
    const double t51 = JLT_FMA(t23, t49, t50); /* (omega_tau - I3/I1*V scaled*s*1/(s*Theta scaled))*Theta scaled*1/(s*Theta scaled)*t35 + omega_tau*omega3*s*1/(s*Theta scaled)*t48 - t47 */
    const double t52 = t13*t21; /* gamma3*omega_n*Theta scaled*1/(s*Theta scaled)*s*1/(s*Theta scaled) */
    const double t53 = p[15]*t52; /* (-I3/(R*I1))*t52 */
    const double t54 = JLT_FMA(p[8], t25, t13); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega3*s*1/(s*Theta scaled) + gamma3*omega_n*Theta scaled*1/(s*Theta scaled) */
    const double t55 = JLT_FNMA(p[7], t52, t54); /* t54 - I3/I1*t52 */
    const double t56 = t23*t32; /* (omega_tau - I3/I1*V scaled*s*1/(s*Theta scaled))*gamma3*Theta scaled*1/(s*Theta scaled) */
    const double t57 = x[2]*t21; /* omega_tau*s*1/(s*Theta scaled) */
    const double t58 = p[8]*t57; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*s*1/(s*Theta scaled) */
    const double t59 = t44*p[16]; /* gamma3*s*1/(s*Theta scaled)*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t60 = t31*t59; /* t31*t59 */
    const double t61 = JLT_FMS(x[0], t32, t3); /* gamma3*gamma3*Theta scaled*1/(s*Theta scaled) - s */
    const double t62 = t26*p[10]; /* omega_tau*omega3*s*1/(s*Theta scaled)*(I1 - I3)/I1 */
    const double t63 = JLT_FNMA(t61, t62, t60); /* t31*t59 - (gamma3*gamma3*Theta scaled*1/(s*Theta scaled) - s)*omega_tau*omega3*s*1/(s*Theta scaled)*(I1 - I3)/I1 */
    const double t64 = x[3]*t21; /* omega_n*s*1/(s*Theta scaled) */
    const double t65 = p[17]*t64; /* (-1/R)*omega_n*s*1/(s*Theta scaled) */
    const double t66 = JLT_FMS(t25, t29, t64); /* omega3*s*1/(s*Theta scaled)*s*gamma3*(I1 - I3)/I1 - omega_n*s*1/(s*Theta scaled) */
    const double t67 = -t22; /* -V scaled*s*1/(s*Theta scaled) */
    const double t68 = t29*t57; /* s*gamma3*(I1 - I3)/I1*omega_tau*s*1/(s*Theta scaled) */
    out[0] = t4;
    out[1] = t15;
    out[2] = t19;
    out[3] = t27;
    out[4] = t31;
    out[5] = t34;
    out[6] = 0.0;
    out[7] = t3;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = t37;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t39;
    out[14] = t5;
    out[15] = t40;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t42;
    out[19] = t43;
    out[20] = t51;
    out[21] = t53;
    out[22] = t55;
    out[23] = t56;
    out[24] = t58;
    out[25] = t63;
    out[26] = t65;
    out[27] = t66;
    out[28] = t67;
    out[29] = t68;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = p[10]*x[2]; /* (I1 - I3)/I1*omega_tau */
    const double t5 = t3*t4; /* s*(I1 - I3)/I1*omega_tau */
    const double t6 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t7 = t2 + p[6]; /* (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t8 = JLT_FMA(x[0], t6, t7); /* Theta scaled = gamma3*gamma3*I3/I1 + (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t9 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t10 = t3*t8; /* s*Theta scaled */
    const double t11 = 1.0/t10; /* 1/(s*Theta scaled) */
    const double t12 = p[18]*t9; /* I3/(R*I1)*V */
    const double t13 = t8*t12; /* Theta scaled*I3/(R*I1)*V */
    const double t14 = JLT_FNMA(t11, t13, t5); /* s*(I1 - I3)/I1*omega_tau - 1/(s*Theta scaled)*Theta scaled*I3/(R*I1)*V */
    const double t15 = x[0]*t3; /* gamma3*s */
    const double t16 = t11*t15; /* 1/(s*Theta scaled)*gamma3*s */
    const double t17 = t14*t16; /* t14*1/(s*Theta scaled)*gamma3*s */
    out[0] = t17;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[20]*x[1]; /* m/I1*v_nu */
    const double t1 = x[3]*x[3]; /* omega_n*omega_n */
    const double t2 = x[4]*x[4]; /* omega3*omega3 */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = t3*t4; /* (1 - gamma3)*(1 + gamma3) */
    const double t6 = sqrt(t5); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = x[4]*t6; /* omega3*s */
    const double t8 = JLT_FMA(x[3], x[0], t7); /* v_tau scaled = omega_n*gamma3 + omega3*s */
    const double t9 = p[21]*t8; /* m*R^2/I1*v_tau scaled */
    const double t10 = JLT_FMA(x[2], x[2], t1); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t11 = JLT_FMA(x[1], t0, t10); /* v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t12 = JLT_FMA(p[7], t2, t11); /* I3/I1*omega3*omega3 + v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t13 = JLT_FMA(t8, t9, t12); /* energy scaled = v_tau scaled*m*R^2/I1*v_tau scaled + t12 */
    const double t14 = p[19]*t13; /* 1/2*I1*energy scaled */
    const double t15 = x[3]*p[22]; /* omega_n*R*I1 */
    const double t16 = t6*t15; /* s*omega_n*R*I1 */
    const double t17 = x[4]*p[23]; /* omega3*R*I3 */
    const double t18 = JLT_FNMA(x[0], t17, t16); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    const double t19 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t20 = p[24]*t19; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t21 = t19*t20; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t22 = p[7]*x[0]; /* I3/I1*gamma3 */
    const double t23 = t5 + p[6]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t24 = JLT_FMA(x[0], t22, t23); /* Theta scaled = gamma3*I3/I1*gamma3 + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t25 = t2*p[25]; /* omega3*omega3*m*R^2*I1*(I1 - I3) */
    const double t26 = JLT_FMA(t24, t25, t21); /* Theta scaled*omega3*omega3*m*R^2*I1*(I1 - I3) + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[0] = t14;
    out[1] = t18;
    out[2] = t26;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = 1.0/t3; /* 1/s */
    const double t5 = x[0]*x[4]; /* gamma3*omega3 */
    const double t6 = JLT_FNMA(t4, t5, x[3]); /* d(v_tau)/d(gamma3) scaled = omega_n - 1/s*gamma3*omega3 */
    const double t7 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t8 = JLT_FMA(t3, x[4], t7); /* v_tau scaled = s*omega3 + omega_n*gamma3 */
    const double t9 = p[26]*t8; /* m*R^2*v_tau scaled */
    const double t10 = t6*t9; /* d(v_tau)/d(gamma3) scaled*m*R^2*v_tau scaled */
    const double t11 = p[0]*x[1]; /* m*v_nu */
    const double t12 = p[4]*x[2]; /* I1*omega_tau */
    const double t13 = x[3]*p[4]; /* omega_n*I1 */
    const double t14 = JLT_FMA(x[0], t9, t13); /* d(energy)/d(omega_n) = gamma3*m*R^2*v_tau scaled + omega_n*I1 */
    const double t15 = x[4]*p[5]; /* omega3*I3 */
    const double t16 = JLT_FMA(t3, t9, t15); /* d(energy)/d(omega3) = s*m*R^2*v_tau scaled + omega3*I3 */
    const double t17 = t7*p[27]; /* omega_n*gamma3*(-R*I1) */
    const double t18 = t4*t17; /* 1/s*omega_n*gamma3*(-R*I1) */
    const double t19 = JLT_FMA(x[4], p[28], t18); /* omega3*(-R*I3) + 1/s*omega_n*gamma3*(-R*I1) */
    const double t20 = t3*p[22]; /* s*R*I1 */
    const double t21 = x[0]*p[28]; /* gamma3*(-R*I3) */
    const double t22 = x[4]*p[29]; /* omega3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    const double t23 = t5*t22; /* gamma3*omega3*omega3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    const double t24 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t25 = p[30]*t24; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    const double t26 = t24*p[31]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    const double t27 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t28 = t2 + p[6]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t29 = JLT_FMA(x[0], t27, t28); /* Theta scaled = gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t30 = x[4]*p[32]; /* omega3*2*m*R^2*I1*(I1 - I3) */
    const double t31 = t29*t30; /* Theta scaled*omega3*2*m*R^2*I1*(I1 - I3) */
    out[0] = t10;
    out[1] = t11;
    out[2] = t12;
    out[3] = t14;
    out[4] = t16;
    out[5] = t19;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t20;
    out[9] = t21;
    out[10] = t23;
    out[11] = t25;
    out[12] = t26;
    out[13] = 0.0;
    out[14] = t31;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
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
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t13[k] = x0[k]*p[7];
        t14[k] = t5[k] + (k == 0 ? p[6] : 0);
        t15[k] = jlt_jet_product(x0, t13, k) + t14[k];
        t16[k] = jlt_jet_product(t6, t15, k);
        t17[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t16, t17, k);
        t18[k] = jlt_jet_product(x0, x3, k);
        t19[k] = jlt_jet_product(t15, t18, k);
        t20[k] = jlt_jet_product(t17, t19, k);
        t21[k] = x4[k] + t20[k];
        t22[k] = p[1]*x3[k];
        t23[k] = jlt_jet_product(t21, t22, k);
        t24[k] = x4[k]*p[7] + t20[k];
        t25[k] = jlt_jet_product(x3, t24, k);
        t26[k] = -t25[k];
        t28[k] = jlt_jet_product(t6, t17, k);
        t29[k] = jlt_jet_product(x4, t28, k);
        t30[k] = p[8]*t29[k] + t20[k];
        t31[k] = jlt_jet_product(x2, t30, k);
        t34[k] = p[9]*x1[k] + x2[k];
        t35[k] = jlt_jet_product(t28, t34, k);
        t36[k] = p[7]*t20[k];
        t37[k] = t31[k] - jlt_jet_product(t35, t36, k);
        t38[k] = jlt_jet_product(x3, t35, k);
        t40[k] = x0[k]*p[10];
        t41[k] = jlt_jet_product(t7, t40, k);
        t42[k] = jlt_jet_product(t29, t41, k) - t38[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t23[k]/(k + 1);
        next[2] = x2[k + 1] = t26[k]/(k + 1);
        next[3] = x3[k + 1] = t37[k]/(k + 1);
        next[4] = x4[k + 1] = t42[k]/(k + 1);
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
    const double complex v_omega3 = x[4];
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = params[5];
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

static const unsigned char family0_is_free[] = { 1, 1, 0, 0, 1 };

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
    out[1] = x[1];
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = x[4];
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[5]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I3*gamma3*v_nu */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = t4*t5; /* (1 + gamma3)*(1 - gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t8 = params[5]*params[4]; /* I3*I1 */
    const double t9 = params[1]*params[1]; /* R*R */
    const double t10 = params[0]*t9; /* m*R*R */
    const double t11 = params[4]*t10; /* I1*m*R*R */
    const double t12 = t7*t7; /* s*s */
    const double t13 = t11*t12; /* I1*m*R*R*s*s */
    const double t14 = t8 + t13; /* I3*I1 + I1*m*R*R*s*s */
    const double t15 = params[5]*t10; /* I3*m*R*R */
    const double t16 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t17 = t15*t16; /* I3*m*R*R*gamma3*gamma3 */
    const double t18 = t14 + t17; /* Theta = I3*I1 + I1*m*R*R*s*s + I3*m*R*R*gamma3*gamma3 */
    const double t19 = t7*t18; /* s*Theta */
    const double t20 = t3/t19; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t21 = -t20; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t21;
}

static void family0_charpoly(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = t0*t1; /* (1 + gamma3)*(1 - gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t4 = params[4]*t3; /* I1*s */
    const double t5 = params[4]*params[5]; /* I1*I3 */
    const double t6 = params[1]*params[1]; /* R*R */
    const double t7 = params[0]*t6; /* m*R*R */
    const double t8 = params[4]*t7; /* I1*m*R*R */
    const double t9 = t3*t3; /* s*s */
    const double t10 = t8*t9; /* I1*m*R*R*s*s */
    const double t11 = t5 + t10; /* I1*I3 + I1*m*R*R*s*s */
    const double t12 = params[5]*t7; /* I3*m*R*R */
    const double t13 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t14 = t12*t13; /* I3*m*R*R*gamma3*gamma3 */
    const double t15 = t11 + t14; /* Theta = I1*I3 + I1*m*R*R*s*s + I3*m*R*R*gamma3*gamma3 */
    const double t16 = t4*t15; /* I1*s*Theta */
    const double t17 = params[0]*params[1]; /* m*R */
    const double t18 = params[4]*t17; /* I1*m*R */
    const double t19 = params[5]*t18; /* I3*I1*m*R */
    const double t20 = x[0]*t19; /* gamma3*I3*I1*m*R */
    const double t21 = t20*x[1]; /* gamma3*I3*I1*m*R*v_nu */
    const double t22 = params[5]*params[5]; /* I3*I3 */
    const double t23 = x[4]*x[4]; /* omega3*omega3 */
    const double t24 = t22*t23; /* I3*I3*omega3*omega3 */
    const double t25 = t3*t24; /* s*I3*I3*omega3*omega3 */
    const double t26 = params[5] + t7; /* I3 + m*R*R */
    const double t27 = t25*t26; /* s*I3*I3*omega3*omega3*(I3 + m*R*R) */
    out[0] = t16;
    out[1] = t21;
    out[2] = t27;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = x[0] + 1.0; /* gamma3 + 1 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = t0*t1; /* (gamma3 + 1)*(1 - gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((gamma3 + 1)*(1 - gamma3)) */
    const double t4 = params[1]*x[4]; /* R*omega3 */
    const double t5 = x[4]*params[5]; /* omega3*I3 */
    const double t6 = t5/params[4]; /* omega3*I3/I1 */
    const double t7 = -t6; /* -omega3*I3/I1 */
    const double t8 = params[4]*params[5]; /* I1*I3 */
    const double t9 = params[1]*params[1]; /* R*R */
    const double t10 = params[0]*t9; /* m*R*R */
    const double t11 = params[4]*t10; /* I1*m*R*R */
    const double t12 = t3*t3; /* s*s */
    const double t13 = t11*t12; /* I1*m*R*R*s*s */
    const double t14 = t8 + t13; /* I1*I3 + I1*m*R*R*s*s */
    const double t15 = params[5]*t10; /* I3*m*R*R */
    const double t16 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t17 = t15*t16; /* I3*m*R*R*gamma3*gamma3 */
    const double t18 = t14 + t17; /* Theta = I1*I3 + I1*m*R*R*s*s + I3*m*R*R*gamma3*gamma3 */
    const double t19 = params[5] + t10; /* I3 + m*R*R */
    const double t20 = t5*t19; /* omega3*I3*(I3 + m*R*R) */
    const double t21 = t20/t18; /* omega3*I3*(I3 + m*R*R)/Theta */
    const double t22 = params[1]*params[0]; /* R*m */
    const double t23 = params[5]*t22; /* I3*R*m */
    const double t24 = x[0]*t23; /* gamma3*I3*R*m */
    const double t25 = t24*x[1]; /* gamma3*I3*R*m*v_nu */
    const double t26 = t3*t18; /* s*Theta */
    const double t27 = t25/t26; /* gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t28 = -t27; /* -gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t29 = x[0]*t10; /* gamma3*m*R*R */
    const double t30 = x[4]*t29; /* omega3*gamma3*m*R*R */
    const double t31 = t3*t30; /* s*omega3*gamma3*m*R*R */
    const double t32 = params[4] - params[5]; /* I1 - I3 */
    const double t33 = t31*t32; /* s*omega3*gamma3*m*R*R*(I1 - I3) */
    const double t34 = t33/t18; /* s*omega3*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t35 = params[4]*t22; /* I1*R*m */
    const double t36 = x[1]*t35; /* v_nu*I1*R*m */
    const double t37 = t36/t18; /* v_nu*I1*R*m/Theta */
    const double t38 = -t37; /* -v_nu*I1*R*m/Theta */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t4;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t7;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = t21;
    out[18] = t28;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = t34;
    out[23] = t38;
    out[24] = 0.0;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[1]*x[4]; /* R*omega3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = t1*t2; /* (1 + gamma3)*(1 - gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t5 = t0*t4; /* v_tau = R*omega3*s */
    const double t6 = params[1]*x[0]; /* R*gamma3 */
    const double t7 = params[0]*t5; /* m*v_tau */
    const double t8 = x[4]*t6; /* omega3*R*gamma3 */
    const double t9 = t8/t4; /* omega3*R*gamma3/s */
    const double t10 = t7*t9; /* m*v_tau*omega3*R*gamma3/s */
    const double t11 = -t10; /* -m*v_tau*omega3*R*gamma3/s */
    const double t12 = params[0]*x[1]; /* m*v_nu */
    const double t13 = params[0]*params[1]; /* m*R */
    const double t14 = x[0]*t13; /* gamma3*m*R */
    const double t15 = t5*t14; /* d(energy)/d(omega_n) = v_tau*gamma3*m*R */
    const double t16 = x[4]*params[5]; /* omega3*I3 */
    const double t17 = t4*t13; /* s*m*R */
    const double t18 = t5*t17; /* v_tau*s*m*R */
    const double t19 = t16 + t18; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    const double t20 = params[1]*params[4]; /* R*I1 */
    const double t21 = params[1]*params[5]; /* R*I3 */
    const double t22 = x[4]*t21; /* omega3*R*I3 */
    const double t23 = -t22; /* -omega3*R*I3 */
    const double t24 = t4*t20; /* s*R*I1 */
    const double t25 = x[0]*t21; /* gamma3*R*I3 */
    const double t26 = -t25; /* -gamma3*R*I3 */
    const double t27 = x[4]*x[4]; /* omega3*omega3 */
    const double t28 = params[4] - params[5]; /* I1 - I3 */
    const double t29 = t27*t28; /* omega3*omega3*(I1 - I3) */
    const double t30 = params[1]*params[1]; /* R*R */
    const double t31 = params[0]*t30; /* m*R*R */
    const double t32 = params[4]*t31; /* I1*m*R*R */
    const double t33 = x[0]*t32; /* gamma3*I1*m*R*R */
    const double t34 = t33*2.0; /* gamma3*I1*m*R*R*2 */
    const double t35 = params[5]*t31; /* I3*m*R*R */
    const double t36 = x[0]*t35; /* gamma3*I3*m*R*R */
    const double t37 = 2.0*t36; /* 2*gamma3*I3*m*R*R */
    const double t38 = t37 - t34; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - gamma3*I1*m*R*R*2 */
    const double t39 = t29*t38; /* omega3*omega3*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t40 = params[0]*2.0; /* m*2 */
    const double t41 = params[4]*params[4]; /* I1*I1 */
    const double t42 = t40*t41; /* m*2*I1*I1 */
    const double t43 = x[1]*t42; /* v_nu*m*2*I1*I1 */
    const double t44 = params[1]*t40; /* R*m*2 */
    const double t45 = t41*t44; /* I1*I1*R*m*2 */
    const double t46 = x[1]*t45; /* v_nu*I1*I1*R*m*2 */
    const double t47 = x[4]*2.0; /* omega3*2 */
    const double t48 = params[4]*params[5]; /* I1*I3 */
    const double t49 = t4*t4; /* s*s */
    const double t50 = t32*t49; /* I1*m*R*R*s*s */
    const double t51 = t48 + t50; /* I1*I3 + I1*m*R*R*s*s */
    const double t52 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t53 = t35*t52; /* I3*m*R*R*gamma3*gamma3 */
    const double t54 = t51 + t53; /* Theta = I1*I3 + I1*m*R*R*s*s + I3*m*R*R*gamma3*gamma3 */
    const double t55 = t47*t54; /* omega3*2*Theta */
    const double t56 = t28*t55; /* (I1 - I3)*omega3*2*Theta */
    out[0] = t11;
    out[1] = t12;
    out[2] = 0.0;
    out[3] = t15;
    out[4] = t19;
    out[5] = t23;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t24;
    out[9] = t26;
    out[10] = t39;
    out[11] = t43;
    out[12] = t46;
    out[13] = 0.0;
    out[14] = t56;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "G", "" },
    { "F0", "a3 = 0" },
};

static const jlt_equilibria equilibria[] = {
    { .name = "spin", .condition = "a3 = 0",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .charpoly = family0_charpoly,
      .matrix = family0_matrix,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 3, .obstructs = 1 },
};

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    { "G", "" },
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 6, .block_count = 33,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 5, 18, 6, 1, 1, 0, 11, 7 }, { 12, 50, 0, 9, 1, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 25, { 6, 39, 13, 1, 1, 0, 14, 16 }, { 36, 168, 0, 34, 1, 0, 14, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 43, 14, 1, 1, 0, 13, 16 }, { 44, 205, 0, 43, 1, 0, 14, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 10, 3, 1, 1, 0, 8, 6 }, { 6, 24, 0, 2, 1, 0, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 3, 14, 9, 0, 1, 0, 8, 8 }, { 12, 45, 0, 0, 1, 0, 10, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 15, { 3, 20, 7, 1, 1, 0, 6, 8 }, { 15, 67, 0, 2, 1, 0, 9, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_baseline,
        &jlt_batch_spherical_top_balanced_avx2,
        &jlt_batch_spherical_top_balanced_avx512,
    },
};
