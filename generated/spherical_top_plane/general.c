/* Balanced sphere with one nonholonomic constraint, on a level of all three integrals
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Table:      spherical_top_plane, SHA-256 a4968b3c5759c8d01110b5ac20002cbaa9743f70ebbbb6790df56f7c04f68c44
 *  Command:    ttc generate --out DIR spherical_top_plane.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   18    6    1    2    2     16    8   (52)
 *  jacobian            2   34   13    2    2    2     18   14   (157)
 *  rhs_jacobian        2   36   13    2    2    2     18   18   (172)
 *  divergence          3   20    9    2    2    2     20   11   (93)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_plane[];
extern const jlt_descriptor jlt_kernels_spherical_top_plane_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[2] + t1; /* J1 = I1 + m*R*R */
    const double t3 = 1.0/t2; /* 1/J1 */
    const double t4 = params[0]*params[1]; /* m*R */
    const double t5 = params[2]*params[2]; /* I1*I1 */
    const double t6 = params[0]*t5; /* m*I1*I1 */
    const double t7 = 1.0/t6; /* 1/(m*I1*I1) */
    const double t8 = params[2] - params[3]; /* I1 - I3 */
    const double t9 = params[2]*params[5]; /* I1*M */
    const double t10 = t2*params[4]; /* J1*G */
    const double t11 = t10/params[1]; /* J1*G/R */
    const double t12 = params[2]*params[3]; /* I1*I3 */
    const double t13 = t1 + params[3]; /* J3 = m*R*R + I3 */
    const double t14 = params[4]*t13; /* G*J3 */
    const double t15 = t14/params[1]; /* G*J3/R */
    const double t16 = params[3]*params[5]; /* I3*M */
    const double t17 = (-1.0)/t2; /* (-1)/J1 */
    const double t18 = t2*t5; /* J1*I1*I1 */
    const double t19 = params[1]/t18; /* R/(J1*I1*I1) */
    const double t20 = -t19; /* -R/(J1*I1*I1) */
    const double t21 = params[1]*params[5]; /* R*M */
    const double t22 = t8*t21; /* (I1 - I3)*R*M */
    const double t23 = t22/params[2]; /* (I1 - I3)*R*M/I1 */
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t0*t24; /* R*R*m*2 */
    const double t26 = -t16; /* -I3*M */
    const double t27 = t1*t8; /* m*R*R*(I1 - I3) */
    out[7] = t3;
    out[8] = t4;
    out[9] = t7;
    out[10] = t8;
    out[11] = t9;
    out[12] = t11;
    out[13] = t12;
    out[14] = t1;
    out[15] = t15;
    out[16] = t16;
    out[17] = t17;
    out[18] = t20;
    out[19] = t23;
    out[20] = t25;
    out[21] = t26;
    out[22] = t19;
    out[23] = t27;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = t3*p[11]; /* s*I1*M */
    const double t6 = t4*t5; /* C*s*I1*M */
    const double t7 = JLT_FNMA(x[0], p[12], t6); /* C*s*I1*M - gamma3*G*J1/R */
    const double t8 = t2*p[2]; /* (1 - gamma3)*(1 + gamma3)*I1 */
    const double t9 = x[0]*p[3]; /* gamma3*I3 */
    const double t10 = JLT_FMA(x[0], t9, t8); /* gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1 */
    const double t11 = JLT_FMA(p[14], t10, p[13]); /* Theta = m*R^2*(gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1) + I1*I3 */
    const double t12 = t3*t11; /* s*Theta */
    const double t13 = 1.0/t12; /* 1/(s*Theta) */
    const double t14 = t3*t13; /* s*1/(s*Theta) */
    const double t15 = p[10]*t14; /* (I1 - I3)*s*1/(s*Theta) */
    const double t16 = t7*t15; /* (C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*s*1/(s*Theta) */
    const double t17 = JLT_FNMA(t7, t16, p[6]); /* F0 - (C*s*I1*M - gamma3*G*J1/R)*(C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*s*1/(s*Theta) */
    const double t18 = p[9]*t17; /* 1/(m*I1^2)*t17 */
    const double t19 = sqrt(t18); /* v_slip = sqrt(1/(m*I1^2)*t17) */
    const double t20 = p[8]*t19; /* m*R*v_slip */
    const double t21 = sin(x[1]); /* S = sin(psi) */
    const double t22 = JLT_FNMA(p[5], t21, t20); /* m*R*v_slip - M*S */
    const double t23 = p[7]*t3; /* 1/J1*s */
    const double t24 = t22*t23; /* (m*R*v_slip - M*S)*1/J1*s */
    const double t25 = t3*p[15]; /* s*G*J3/R */
    const double t26 = x[0]*p[16]; /* gamma3*I3*M */
    const double t27 = JLT_FMA(t4, t26, t25); /* C*gamma3*I3*M + s*G*J3/R */
    const double t28 = t11*t13; /* Theta*1/(s*Theta) */
    const double t29 = t14*t28; /* s*1/(s*Theta)*Theta*1/(s*Theta) */
    const double t30 = t27*t29; /* (C*gamma3*I3*M + s*G*J3/R)*s*1/(s*Theta)*Theta*1/(s*Theta) */
    out[0] = t24;
    out[1] = t30;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = p[11]*t4; /* I1*M*C */
    const double t6 = t3*t5; /* s*I1*M*C */
    const double t7 = JLT_FNMA(x[0], p[12], t6); /* s*I1*M*C - gamma3*G*J1/R */
    const double t8 = t2*p[2]; /* (1 - gamma3)*(1 + gamma3)*I1 */
    const double t9 = x[0]*p[3]; /* gamma3*I3 */
    const double t10 = JLT_FMA(x[0], t9, t8); /* gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1 */
    const double t11 = JLT_FMA(p[14], t10, p[13]); /* Theta = m*R^2*(gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1) + I1*I3 */
    const double t12 = t3*t11; /* s*Theta */
    const double t13 = 1.0/t12; /* 1/(s*Theta) */
    const double t14 = t3*t13; /* s*1/(s*Theta) */
    const double t15 = t7*t14; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t16 = p[10]*t15; /* (I1 - I3)*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t17 = JLT_FNMA(t7, t16, p[6]); /* F0 - (s*I1*M*C - gamma3*G*J1/R)*(I1 - I3)*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t18 = p[9]*t17; /* 1/(m*I1^2)*t17 */
    const double t19 = sqrt(t18); /* v_slip = sqrt(1/(m*I1^2)*t17) */
    const double t20 = p[8]*t19; /* m*R*v_slip */
    const double t21 = sin(x[1]); /* S = sin(psi) */
    const double t22 = JLT_FNMA(p[5], t21, t20); /* m*R*v_slip - M*S */
    const double t23 = t11*t13; /* Theta*1/(s*Theta) */
    const double t24 = x[0]*t23; /* gamma3*Theta*1/(s*Theta) */
    const double t25 = p[17]*t24; /* (-1/J1)*gamma3*Theta*1/(s*Theta) */
    const double t26 = t22*t25; /* (m*R*v_slip - M*S)*(-1/J1)*gamma3*Theta*1/(s*Theta) */
    const double t27 = x[0]*p[10]; /* gamma3*(I1 - I3) */
    const double t28 = p[14]*t27; /* m*R^2*gamma3*(I1 - I3) */
    const double t29 = JLT_FMA(t5, t24, p[12]); /* I1*M*C*gamma3*Theta*1/(s*Theta) + G*J1/R */
    const double t30 = JLT_FMS(t15, t28, t29); /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*m*R^2*gamma3*(I1 - I3) - (I1*M*C*gamma3*Theta*1/(s*Theta) + G*J1/R) */
    const double t31 = 1.0/t19; /* 1/v_slip */
    const double t32 = t3*t31; /* s*1/v_slip */
    const double t33 = t16*p[18]; /* (I1 - I3)*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*(-R/(I1^2*J1)) */
    const double t34 = t30*t33; /* t30*t33 */
    const double t35 = JLT_FMA(t32, t34, t26); /* s*1/v_slip*t30*t33 + (m*R*v_slip - M*S)*(-1/J1)*gamma3*Theta*1/(s*Theta) */
    const double t36 = t21*p[19]; /* S*R*M*(I1 - I3)/I1 */
    const double t37 = t15*t36; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*S*R*M*(I1 - I3)/I1 */
    const double t38 = t32*t37; /* s*1/v_slip*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*S*R*M*(I1 - I3)/I1 */
    const double t39 = JLT_FNMA(t4, p[5], t38); /* t38 - C*M */
    const double t40 = t3*p[7]; /* s*1/J1 */
    const double t41 = t39*t40; /* (t38 - C*M)*s*1/J1 */
    const double t42 = t3*p[15]; /* s*G*J3/R */
    const double t43 = t4*p[16]; /* C*I3*M */
    const double t44 = JLT_FMA(x[0], t43, t42); /* gamma3*C*I3*M + s*G*J3/R */
    const double t45 = t23*t24; /* Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) */
    const double t46 = t27*p[20]; /* gamma3*(I1 - I3)*2*m*R^2 */
    const double t47 = JLT_FMA(t14, t46, t45); /* s*1/(s*Theta)*gamma3*(I1 - I3)*2*m*R^2 + Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) */
    const double t48 = JLT_FNMA(t24, p[15], t43); /* C*I3*M - gamma3*Theta*1/(s*Theta)*G*J3/R */
    const double t49 = JLT_FMA(t44, t47, t48); /* (gamma3*C*I3*M + s*G*J3/R)*t47 + C*I3*M - gamma3*Theta*1/(s*Theta)*G*J3/R */
    const double t50 = t14*t23; /* s*1/(s*Theta)*Theta*1/(s*Theta) */
    const double t51 = t49*t50; /* t49*s*1/(s*Theta)*Theta*1/(s*Theta) */
    const double t52 = t14*p[21]; /* s*1/(s*Theta)*(-I3*M) */
    const double t53 = t24*t52; /* gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*(-I3*M) */
    const double t54 = t21*t53; /* S*gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*(-I3*M) */
    out[0] = t35;
    out[1] = t41;
    out[2] = t51;
    out[3] = t54;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = p[11]*t4; /* I1*M*C */
    const double t6 = t3*t5; /* s*I1*M*C */
    const double t7 = JLT_FNMA(x[0], p[12], t6); /* s*I1*M*C - gamma3*G*J1/R */
    const double t8 = t2*p[2]; /* (1 - gamma3)*(1 + gamma3)*I1 */
    const double t9 = x[0]*p[3]; /* gamma3*I3 */
    const double t10 = JLT_FMA(x[0], t9, t8); /* gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1 */
    const double t11 = JLT_FMA(p[14], t10, p[13]); /* Theta = m*R^2*(gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1) + I1*I3 */
    const double t12 = t3*t11; /* s*Theta */
    const double t13 = 1.0/t12; /* 1/(s*Theta) */
    const double t14 = t3*t13; /* s*1/(s*Theta) */
    const double t15 = t7*t14; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t16 = p[10]*t15; /* (I1 - I3)*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t17 = JLT_FNMA(t7, t16, p[6]); /* F0 - (s*I1*M*C - gamma3*G*J1/R)*(I1 - I3)*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t18 = p[9]*t17; /* 1/(m*I1^2)*t17 */
    const double t19 = sqrt(t18); /* v_slip = sqrt(1/(m*I1^2)*t17) */
    const double t20 = p[8]*t19; /* m*R*v_slip */
    const double t21 = sin(x[1]); /* S = sin(psi) */
    const double t22 = JLT_FNMA(p[5], t21, t20); /* m*R*v_slip - M*S */
    const double t23 = t3*p[7]; /* s*1/J1 */
    const double t24 = t22*t23; /* (m*R*v_slip - M*S)*s*1/J1 */
    const double t25 = t3*p[15]; /* s*G*J3/R */
    const double t26 = t4*p[16]; /* C*I3*M */
    const double t27 = JLT_FMA(x[0], t26, t25); /* gamma3*C*I3*M + s*G*J3/R */
    const double t28 = t13*t27; /* 1/(s*Theta)*(gamma3*C*I3*M + s*G*J3/R) */
    const double t29 = t11*t13; /* Theta*1/(s*Theta) */
    const double t30 = x[0]*t29; /* gamma3*Theta*1/(s*Theta) */
    const double t31 = p[17]*t30; /* (-1/J1)*gamma3*Theta*1/(s*Theta) */
    const double t32 = t22*t31; /* (m*R*v_slip - M*S)*(-1/J1)*gamma3*Theta*1/(s*Theta) */
    const double t33 = x[0]*p[10]; /* gamma3*(I1 - I3) */
    const double t34 = p[14]*t33; /* m*R^2*gamma3*(I1 - I3) */
    const double t35 = JLT_FMA(t5, t30, p[12]); /* I1*M*C*gamma3*Theta*1/(s*Theta) + G*J1/R */
    const double t36 = JLT_FMS(t15, t34, t35); /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*m*R^2*gamma3*(I1 - I3) - (I1*M*C*gamma3*Theta*1/(s*Theta) + G*J1/R) */
    const double t37 = 1.0/t19; /* 1/v_slip */
    const double t38 = t3*t37; /* s*1/v_slip */
    const double t39 = t16*p[18]; /* (I1 - I3)*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*(-R/(I1^2*J1)) */
    const double t40 = t36*t39; /* t36*t39 */
    const double t41 = JLT_FMA(t38, t40, t32); /* s*1/v_slip*t36*t39 + (m*R*v_slip - M*S)*(-1/J1)*gamma3*Theta*1/(s*Theta) */
    const double t42 = t21*p[19]; /* S*R*M*(I1 - I3)/I1 */
    const double t43 = t15*t42; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*S*R*M*(I1 - I3)/I1 */
    const double t44 = t38*t43; /* s*1/v_slip*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*S*R*M*(I1 - I3)/I1 */
    const double t45 = JLT_FNMA(t4, p[5], t44); /* t44 - C*M */
    const double t46 = t23*t45; /* s*1/J1*(t44 - C*M) */
    const double t47 = t29*t30; /* Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) */
    const double t48 = t28*t47; /* 1/(s*Theta)*(gamma3*C*I3*M + s*G*J3/R)*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) */
    const double t49 = t33*p[20]; /* gamma3*(I1 - I3)*2*m*R^2 */
    const double t50 = t14*t49; /* s*1/(s*Theta)*gamma3*(I1 - I3)*2*m*R^2 */
    const double t51 = JLT_FMS(p[15], t30, t26); /* G*J3/R*gamma3*Theta*1/(s*Theta) - C*I3*M */
    const double t52 = JLT_FNMA(t13, t51, t48); /* t48 - 1/(s*Theta)*(G*J3/R*gamma3*Theta*1/(s*Theta) - C*I3*M) */
    const double t53 = JLT_FMA(t28, t50, t52); /* 1/(s*Theta)*(gamma3*C*I3*M + s*G*J3/R)*s*1/(s*Theta)*gamma3*(I1 - I3)*2*m*R^2 + t48 - 1/(s*Theta)*(G*J3/R*gamma3*Theta*1/(s*Theta) - C*I3*M) */
    const double t54 = t14*p[21]; /* s*1/(s*Theta)*(-I3*M) */
    const double t55 = t30*t54; /* gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*(-I3*M) */
    const double t56 = t21*t55; /* S*gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*(-I3*M) */
    out[0] = t24;
    out[1] = t28;
    out[2] = t41;
    out[3] = t46;
    out[4] = t53;
    out[5] = t56;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = p[11]*t4; /* I1*M*C */
    const double t6 = t3*t5; /* s*I1*M*C */
    const double t7 = JLT_FNMA(x[0], p[12], t6); /* s*I1*M*C - gamma3*G*J1/R */
    const double t8 = t2*p[2]; /* (1 - gamma3)*(1 + gamma3)*I1 */
    const double t9 = x[0]*p[3]; /* gamma3*I3 */
    const double t10 = JLT_FMA(x[0], t9, t8); /* gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1 */
    const double t11 = JLT_FMA(p[14], t10, p[13]); /* Theta = m*R^2*(gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1) + I1*I3 */
    const double t12 = t3*t11; /* s*Theta */
    const double t13 = 1.0/t12; /* 1/(s*Theta) */
    const double t14 = t3*t13; /* s*1/(s*Theta) */
    const double t15 = t7*t14; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t16 = p[10]*t15; /* (I1 - I3)*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t17 = JLT_FNMA(t7, t16, p[6]); /* F0 - (s*I1*M*C - gamma3*G*J1/R)*(I1 - I3)*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t18 = p[9]*t17; /* 1/(m*I1^2)*t17 */
    const double t19 = sqrt(t18); /* v_slip = sqrt(1/(m*I1^2)*t17) */
    const double t20 = p[8]*t19; /* m*R*v_slip */
    const double t21 = sin(x[1]); /* S = sin(psi) */
    const double t22 = JLT_FNMA(p[5], t21, t20); /* m*R*v_slip - M*S */
    const double t23 = p[7]*t22; /* 1/J1*(m*R*v_slip - M*S) */
    const double t24 = t14*p[16]; /* s*1/(s*Theta)*I3*M */
    const double t25 = JLT_FMA(t21, t24, t23); /* S*s*1/(s*Theta)*I3*M + 1/J1*(m*R*v_slip - M*S) */
    const double t26 = x[0]*t11; /* gamma3*Theta */
    const double t27 = t13*t26; /* 1/(s*Theta)*gamma3*Theta */
    const double t28 = t25*t27; /* (S*s*1/(s*Theta)*I3*M + 1/J1*(m*R*v_slip - M*S))*1/(s*Theta)*gamma3*Theta */
    const double t29 = 1.0/t19; /* 1/v_slip */
    const double t30 = x[0]*p[23]; /* gamma3*m*R^2*(I1 - I3) */
    const double t31 = JLT_FMA(t5, t27, p[12]); /* I1*M*C*1/(s*Theta)*gamma3*Theta + G*J1/R */
    const double t32 = JLT_FMS(t15, t30, t31); /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*gamma3*m*R^2*(I1 - I3) - (I1*M*C*1/(s*Theta)*gamma3*Theta + G*J1/R) */
    const double t33 = t3*p[22]; /* s*R/(I1^2*J1) */
    const double t34 = t16*t33; /* (I1 - I3)*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*s*R/(I1^2*J1) */
    const double t35 = t32*t34; /* t32*t34 */
    const double t36 = JLT_FMA(t29, t35, t28); /* 1/v_slip*t32*t34 + t28 */
    const double t37 = -t36; /* -(1/v_slip*t32*t34 + t28) */
    out[0] = t37;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double u13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
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
    double u36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t13[k] = jlt_jet_cosine(x1, t13, u13, k);
        t14[k] = t6[k]*p[11];
        t15[k] = jlt_jet_product(t13, t14, k);
        t17[k] = t15[k] - x0[k]*p[12];
        t21[k] = t5[k]*p[2];
        t23[k] = x0[k]*p[3];
        t24[k] = jlt_jet_product(x0, t23, k) + t21[k];
        t25[k] = p[14]*t24[k] + (k == 0 ? p[13] : 0);
        t26[k] = jlt_jet_product(t6, t25, k);
        t27[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t26, t27, k);
        t28[k] = jlt_jet_product(t6, t27, k);
        t29[k] = p[10]*t28[k];
        t30[k] = jlt_jet_product(t17, t29, k);
        t31[k] = (k == 0 ? p[6] : 0) - jlt_jet_product(t17, t30, k);
        t32[k] = p[9]*t31[k];
        t33[k] = jlt_jet_root(t32[k], t33, k);
        t34[k] = p[8]*t33[k];
        t36[k] = jlt_jet_sine(x1, t36, u36, k);
        t37[k] = t34[k] - p[5]*t36[k];
        t38[k] = p[7]*t6[k];
        t39[k] = jlt_jet_product(t37, t38, k);
        t41[k] = t6[k]*p[15];
        t43[k] = x0[k]*p[16];
        t44[k] = jlt_jet_product(t13, t43, k) + t41[k];
        t45[k] = jlt_jet_product(t25, t27, k);
        t46[k] = jlt_jet_product(t28, t45, k);
        t47[k] = jlt_jet_product(t44, t46, k);
        double *restrict next = coefficients + (k + 1)*2;
        next[0] = x0[k + 1] = t39[k]/(k + 1);
        next[1] = x1[k + 1] = t47[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    const double v_I1 = params[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double complex v_J1 = (v_I1 + v_m*v_R*v_R);
    const double v_F0 = params[6];
    const double v_I3 = params[3];
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*(v_I1*v_s*v_s + v_I3*v_gamma3*v_gamma3));
    const double v_M = params[5];
    const double complex v_psi = x[1];
    const double complex v_C = ccos(v_psi);
    const double v_G = params[4];
    const double complex v_omega3 = ((v_I1*v_M*v_s*v_C - v_G*v_gamma3*v_J1/v_R)/v_Theta);
    const double complex v_v_slip = csqrt((v_F0 - v_Theta*v_omega3*v_omega3*(v_I1 - v_I3))/(v_m*v_I1*v_I1));
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s*v_omega_tau);
    const double complex v_J3 = (v_I3 + v_m*v_R*v_R);
    const double complex v_omega_n = ((v_G*v_s*v_J3/v_R + v_I3*v_M*v_gamma3*v_C)/v_Theta);
    out[1] = (v_omega_n/v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "psi", "rad", "angle of the horizontal momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (2.0 / 5.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 4.0) },
    { "G", "kg*m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-3.0 / 10.0) },
    { "M", "kg*m^2/s", "horizontal angular momentum about the contact point", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "F0", "kg^3*m^6/s^2", "value of the third integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (1.0 / 2.0) },
};

const jlt_descriptor jlt_kernels_spherical_top_plane_general = {
    .model = "spherical_top_plane",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on a level of all three integrals",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "a4968b3c5759c8d01110b5ac20002cbaa9743f70ebbbb6790df56f7c04f68c44",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_plane,
    .state_count = 2, .param_count = 7, .block_count = 24,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 2, { 2, 18, 6, 1, 2, 2, 16, 8 }, { 10, 32, 0, 6, 2, 2, 16, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 4, { 2, 34, 13, 2, 2, 2, 18, 14 }, { 28, 104, 0, 21, 2, 2, 18, 14 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 6, { 2, 36, 13, 2, 2, 2, 18, 18 }, { 30, 114, 0, 24, 2, 2, 18, 15 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 20, 9, 2, 2, 2, 20, 11 }, { 18, 59, 0, 12, 2, 2, 19, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { .loses_digits = "" },
    .integral_gradients = { .loses_digits = "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 0, .measure_count = 0, .equilibria_count = 0,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_plane_general_baseline,
        &jlt_batch_spherical_top_plane_general_avx2,
        &jlt_batch_spherical_top_plane_general_avx512,
    },
};
