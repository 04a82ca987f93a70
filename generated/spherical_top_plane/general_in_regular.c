/* Balanced sphere with one nonholonomic constraint, on a level of all three integrals
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_plane, SHA-256 a4968b3c5759c8d01110b5ac20002cbaa9743f70ebbbb6790df56f7c04f68c44
 *  Command:    ttc generate --out DIR spherical_top_plane.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   16    6    1    1    2     15    6   (57)
 *  jacobian            3   40   14    2    1    2     16   12   (295)
 *  rhs_jacobian        4   42   14    2    1    2     16   15   (318)
 *  divergence          0   21   10    2    1    2     14    8   (120)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: grows without bound, and so do rounding errors, where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_plane[];
extern const jlt_descriptor jlt_kernels_spherical_top_plane_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_in_regular_avx512;

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
    const double t9 = params[2]*params[3]; /* I1*I3 */
    const double t10 = params[2]*params[5]; /* I1*M */
    const double t11 = t2*params[4]; /* J1*G */
    const double t12 = t11/params[1]; /* J1*G/R */
    const double t13 = t1 + params[3]; /* J3 = m*R*R + I3 */
    const double t14 = params[4]*t13; /* G*J3 */
    const double t15 = t14/params[1]; /* G*J3/R */
    const double t16 = params[3]*params[5]; /* I3*M */
    const double t17 = t1*params[3]; /* m*R*R*I3 */
    const double t18 = t8*t17; /* (I1 - I3)*m*R*R*I3 */
    const double t19 = t8*t11; /* (I1 - I3)*J1*G */
    const double t20 = t19/params[1]; /* (I1 - I3)*J1*G/R */
    const double t21 = t2*t5; /* J1*I1*I1 */
    const double t22 = params[1]/t21; /* R/(J1*I1*I1) */
    const double t23 = params[1]*params[5]; /* R*M */
    const double t24 = t8*t23; /* (I1 - I3)*R*M */
    const double t25 = t24/params[2]; /* (I1 - I3)*R*M/I1 */
    const double t26 = 2.0/t2; /* 2/J1 */
    const double t27 = t8*t10; /* (I1 - I3)*I1*M */
    const double t28 = params[2]*t1; /* I1*m*R*R */
    const double t29 = t8*t28; /* (I1 - I3)*I1*m*R*R */
    const double t30 = params[0]*2.0; /* m*2 */
    const double t31 = t0*t30; /* R*R*m*2 */
    const double t32 = params[3]*t31; /* I3*R*R*m*2 */
    const double t33 = -t16; /* -I3*M */
    const double t34 = params[2]*t31; /* I1*R*R*m*2 */
    const double t35 = params[1]*t0; /* R*R*R */
    const double t36 = t30*t35; /* m*2*R*R*R */
    const double t37 = params[2]*t36; /* I1*m*2*R*R*R */
    const double t38 = t14/t37; /* G*J3/(I1*m*2*R*R*R) */
    out[7] = t3;
    out[8] = t4;
    out[9] = t7;
    out[10] = t8;
    out[11] = t9;
    out[12] = t1;
    out[13] = t10;
    out[14] = t12;
    out[15] = t15;
    out[16] = t16;
    out[17] = t18;
    out[18] = t20;
    out[19] = t22;
    out[20] = t25;
    out[21] = t26;
    out[22] = t27;
    out[23] = t29;
    out[24] = t32;
    out[25] = t33;
    out[26] = t34;
    out[27] = t38;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[2]*x[2]; /* s*s */
    const double t1 = t0*p[2]; /* s*s*I1 */
    const double t2 = p[3]*x[0]; /* I3*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* gamma3*I3*gamma3 + s*s*I1 */
    const double t4 = JLT_FMA(p[12], t3, p[11]); /* Theta = m*R^2*(gamma3*I3*gamma3 + s*s*I1) + I1*I3 */
    const double t5 = 1.0/t4; /* 1/Theta */
    const double t6 = cos(x[1]); /* C = cos(psi) */
    const double t7 = x[2]*p[13]; /* s*I1*M */
    const double t8 = t6*t7; /* C*s*I1*M */
    const double t9 = JLT_FNMA(x[0], p[14], t8); /* C*s*I1*M - gamma3*G*J1/R */
    const double t10 = p[10]*t5; /* (I1 - I3)*1/Theta */
    const double t11 = t9*t10; /* (C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*1/Theta */
    const double t12 = JLT_FNMA(t9, t11, p[6]); /* F0 - (C*s*I1*M - gamma3*G*J1/R)*(C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*1/Theta */
    const double t13 = p[9]*t12; /* 1/(m*I1^2)*t12 */
    const double t14 = sqrt(t13); /* v_slip = sqrt(1/(m*I1^2)*t12) */
    const double t15 = p[8]*t14; /* m*R*v_slip */
    const double t16 = sin(x[1]); /* S = sin(psi) */
    const double t17 = JLT_FNMA(p[5], t16, t15); /* m*R*v_slip - M*S */
    const double t18 = p[7]*t17; /* 1/J1*(m*R*v_slip - M*S) */
    const double t19 = t0*t18; /* s*s*1/J1*(m*R*v_slip - M*S) */
    const double t20 = x[2]*p[15]; /* s*G*J3/R */
    const double t21 = x[0]*p[16]; /* gamma3*I3*M */
    const double t22 = JLT_FMA(t6, t21, t20); /* C*gamma3*I3*M + s*G*J3/R */
    const double t23 = t5*t22; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t24 = x[2]*x[0]; /* s*gamma3 */
    const double t25 = t18*t24; /* 1/J1*(m*R*v_slip - M*S)*s*gamma3 */
    const double t26 = -t25; /* -1/J1*(m*R*v_slip - M*S)*s*gamma3 */
    out[0] = t19;
    out[1] = t23;
    out[2] = t26;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[2]*p[2]; /* s*I1 */
    const double t1 = x[2]*t0; /* s*s*I1 */
    const double t2 = x[0]*p[3]; /* gamma3*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* gamma3*gamma3*I3 + s*s*I1 */
    const double t4 = JLT_FMA(p[12], t3, p[11]); /* Theta = m*R^2*(gamma3*gamma3*I3 + s*s*I1) + I1*I3 */
    const double t5 = 1.0/t4; /* 1/Theta */
    const double t6 = cos(x[1]); /* C = cos(psi) */
    const double t7 = x[2]*p[13]; /* s*I1*M */
    const double t8 = t6*t7; /* C*s*I1*M */
    const double t9 = JLT_FNMA(x[0], p[14], t8); /* C*s*I1*M - gamma3*G*J1/R */
    const double t10 = t5*t9; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R) */
    const double t11 = t10*t10; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*1/Theta*(C*s*I1*M - gamma3*G*J1/R) */
    const double t12 = p[17]*x[0]; /* m*R^2*I3*(I1 - I3)*gamma3 */
    const double t13 = t11*t12; /* t11*m*R^2*I3*(I1 - I3)*gamma3 */
    const double t14 = JLT_FMA(t10, p[18], t13); /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*G*J1*(I1 - I3)/R + t11*m*R^2*I3*(I1 - I3)*gamma3 */
    const double t15 = t9*p[10]; /* (C*s*I1*M - gamma3*G*J1/R)*(I1 - I3) */
    const double t16 = JLT_FNMA(t10, t15, p[6]); /* F0 - 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*(C*s*I1*M - gamma3*G*J1/R)*(I1 - I3) */
    const double t17 = p[9]*t16; /* 1/(m*I1^2)*t16 */
    const double t18 = sqrt(t17); /* v_slip = sqrt(1/(m*I1^2)*t16) */
    const double t19 = 1.0/t18; /* 1/v_slip */
    const double t20 = x[2]*t19; /* s*1/v_slip */
    const double t21 = p[19]*t20; /* R/(I1^2*J1)*s*1/v_slip */
    const double t22 = t14*t21; /* t14*R/(I1^2*J1)*s*1/v_slip */
    const double t23 = x[2]*t22; /* s*t14*R/(I1^2*J1)*s*1/v_slip */
    const double t24 = sin(x[1]); /* S = sin(psi) */
    const double t25 = p[20]*t24; /* R*M*(I1 - I3)/I1*S */
    const double t26 = t10*t25; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*R*M*(I1 - I3)/I1*S */
    const double t27 = t20*t26; /* s*1/v_slip*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*R*M*(I1 - I3)/I1*S */
    const double t28 = JLT_FNMA(t6, p[5], t27); /* t27 - C*M */
    const double t29 = x[2]*p[7]; /* s*1/J1 */
    const double t30 = t28*t29; /* (t27 - C*M)*s*1/J1 */
    const double t31 = x[2]*t30; /* s*(t27 - C*M)*s*1/J1 */
    const double t32 = t18*p[8]; /* v_slip*m*R */
    const double t33 = JLT_FNMA(t24, p[5], t32); /* v_slip*m*R - S*M */
    const double t34 = t6*p[22]; /* C*I1*M*(I1 - I3) */
    const double t35 = t10*t34; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*C*I1*M*(I1 - I3) */
    const double t36 = x[2]*p[23]; /* s*m*R^2*I1*(I1 - I3) */
    const double t37 = JLT_FNMA(t11, t36, t35); /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*C*I1*M*(I1 - I3) - t11*s*m*R^2*I1*(I1 - I3) */
    const double t38 = t21*t37; /* R/(I1^2*J1)*s*1/v_slip*t37 */
    const double t39 = JLT_FMS(p[21], t33, t38); /* 2/J1*(v_slip*m*R - S*M) - R/(I1^2*J1)*s*1/v_slip*t37 */
    const double t40 = x[2]*t39; /* s*(2/J1*(v_slip*m*R - S*M) - R/(I1^2*J1)*s*1/v_slip*t37) */
    const double t41 = t6*p[16]; /* C*I3*M */
    const double t42 = t5*t41; /* 1/Theta*C*I3*M */
    const double t43 = x[0]*t5; /* gamma3*1/Theta */
    const double t44 = x[2]*p[15]; /* s*G*J3/R */
    const double t45 = JLT_FMA(x[0], t41, t44); /* gamma3*C*I3*M + s*G*J3/R */
    const double t46 = t5*t45; /* 1/Theta*(gamma3*C*I3*M + s*G*J3/R) */
    const double t47 = p[24]*t43; /* 2*m*R^2*I3*gamma3*1/Theta */
    const double t48 = JLT_FNMA(t46, t47, t42); /* 1/Theta*C*I3*M - 1/Theta*(gamma3*C*I3*M + s*G*J3/R)*2*m*R^2*I3*gamma3*1/Theta */
    const double t49 = t43*p[25]; /* gamma3*1/Theta*(-I3*M) */
    const double t50 = t24*t49; /* S*gamma3*1/Theta*(-I3*M) */
    const double t51 = JLT_FNMA(x[2], t46, p[27]); /* 1/2*G*J3/(m*R^3*I1) - s*1/Theta*(gamma3*C*I3*M + s*G*J3/R) */
    const double t52 = t5*p[26]; /* 1/Theta*2*m*R^2*I1 */
    const double t53 = t51*t52; /* (1/2*G*J3/(m*R^3*I1) - s*1/Theta*(gamma3*C*I3*M + s*G*J3/R))*1/Theta*2*m*R^2*I1 */
    const double t54 = t29*t33; /* s*1/J1*(v_slip*m*R - S*M) */
    const double t55 = JLT_FMA(x[0], t22, t54); /* gamma3*t14*R/(I1^2*J1)*s*1/v_slip + s*1/J1*(v_slip*m*R - S*M) */
    const double t56 = -t55; /* -t55 */
    const double t57 = x[0]*t30; /* gamma3*(t27 - C*M)*s*1/J1 */
    const double t58 = -t57; /* -gamma3*(t27 - C*M)*s*1/J1 */
    const double t59 = JLT_FMS(p[7], t33, t38); /* 1/J1*(v_slip*m*R - S*M) - R/(I1^2*J1)*s*1/v_slip*t37 */
    const double t60 = x[0]*t59; /* gamma3*(1/J1*(v_slip*m*R - S*M) - R/(I1^2*J1)*s*1/v_slip*t37) */
    const double t61 = -t60; /* -t60 */
    out[0] = t23;
    out[1] = t31;
    out[2] = t40;
    out[3] = t48;
    out[4] = t50;
    out[5] = t53;
    out[6] = t56;
    out[7] = t58;
    out[8] = t61;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = cos(x[1]); /* C = cos(psi) */
    const double t1 = x[2]*p[13]; /* s*I1*M */
    const double t2 = t0*t1; /* C*s*I1*M */
    const double t3 = JLT_FNMA(p[14], x[0], t2); /* C*s*I1*M - G*J1/R*gamma3 */
    const double t4 = x[2]*p[2]; /* s*I1 */
    const double t5 = x[2]*t4; /* s*s*I1 */
    const double t6 = x[0]*p[3]; /* gamma3*I3 */
    const double t7 = JLT_FMA(x[0], t6, t5); /* gamma3*gamma3*I3 + s*s*I1 */
    const double t8 = JLT_FMA(p[12], t7, p[11]); /* Theta = m*R^2*(gamma3*gamma3*I3 + s*s*I1) + I1*I3 */
    const double t9 = 1.0/t8; /* 1/Theta */
    const double t10 = t3*t9; /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta */
    const double t11 = p[10]*t3; /* (I1 - I3)*(C*s*I1*M - G*J1/R*gamma3) */
    const double t12 = JLT_FNMA(t10, t11, p[6]); /* F0 - (C*s*I1*M - G*J1/R*gamma3)*1/Theta*(I1 - I3)*(C*s*I1*M - G*J1/R*gamma3) */
    const double t13 = p[9]*t12; /* 1/(m*I1^2)*t12 */
    const double t14 = sqrt(t13); /* v_slip = sqrt(1/(m*I1^2)*t12) */
    const double t15 = p[8]*t14; /* m*R*v_slip */
    const double t16 = sin(x[1]); /* S = sin(psi) */
    const double t17 = JLT_FNMA(p[5], t16, t15); /* m*R*v_slip - M*S */
    const double t18 = x[2]*p[7]; /* s*1/J1 */
    const double t19 = t17*t18; /* (m*R*v_slip - M*S)*s*1/J1 */
    const double t20 = x[2]*t19; /* s*(m*R*v_slip - M*S)*s*1/J1 */
    const double t21 = x[2]*p[15]; /* s*G*J3/R */
    const double t22 = t0*p[16]; /* C*I3*M */
    const double t23 = JLT_FMA(x[0], t22, t21); /* gamma3*C*I3*M + s*G*J3/R */
    const double t24 = t9*t23; /* 1/Theta*(gamma3*C*I3*M + s*G*J3/R) */
    const double t25 = x[0]*t19; /* gamma3*(m*R*v_slip - M*S)*s*1/J1 */
    const double t26 = -t25; /* -gamma3*(m*R*v_slip - M*S)*s*1/J1 */
    const double t27 = t10*t10; /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta*(C*s*I1*M - G*J1/R*gamma3)*1/Theta */
    const double t28 = x[0]*p[17]; /* gamma3*m*R^2*I3*(I1 - I3) */
    const double t29 = t27*t28; /* t27*gamma3*m*R^2*I3*(I1 - I3) */
    const double t30 = JLT_FMA(t10, p[18], t29); /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta*G*J1*(I1 - I3)/R + t27*gamma3*m*R^2*I3*(I1 - I3) */
    const double t31 = 1.0/t14; /* 1/v_slip */
    const double t32 = x[2]*t31; /* s*1/v_slip */
    const double t33 = p[19]*t32; /* R/(I1^2*J1)*s*1/v_slip */
    const double t34 = t30*t33; /* t30*R/(I1^2*J1)*s*1/v_slip */
    const double t35 = x[2]*t34; /* s*t30*R/(I1^2*J1)*s*1/v_slip */
    const double t36 = t16*p[20]; /* S*R*M*(I1 - I3)/I1 */
    const double t37 = t10*t36; /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta*S*R*M*(I1 - I3)/I1 */
    const double t38 = t32*t37; /* s*1/v_slip*(C*s*I1*M - G*J1/R*gamma3)*1/Theta*S*R*M*(I1 - I3)/I1 */
    const double t39 = JLT_FNMA(t0, p[5], t38); /* t38 - C*M */
    const double t40 = t18*t39; /* s*1/J1*(t38 - C*M) */
    const double t41 = x[2]*t40; /* s*s*1/J1*(t38 - C*M) */
    const double t42 = t0*p[22]; /* C*I1*M*(I1 - I3) */
    const double t43 = t10*t42; /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta*C*I1*M*(I1 - I3) */
    const double t44 = x[2]*p[23]; /* s*m*R^2*I1*(I1 - I3) */
    const double t45 = JLT_FNMA(t27, t44, t43); /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta*C*I1*M*(I1 - I3) - t27*s*m*R^2*I1*(I1 - I3) */
    const double t46 = t33*t45; /* R/(I1^2*J1)*s*1/v_slip*t45 */
    const double t47 = JLT_FMS(t17, p[21], t46); /* (m*R*v_slip - M*S)*2/J1 - R/(I1^2*J1)*s*1/v_slip*t45 */
    const double t48 = x[2]*t47; /* s*((m*R*v_slip - M*S)*2/J1 - R/(I1^2*J1)*s*1/v_slip*t45) */
    const double t49 = t9*t22; /* 1/Theta*C*I3*M */
    const double t50 = x[0]*t9; /* gamma3*1/Theta */
    const double t51 = p[24]*t50; /* 2*m*R^2*I3*gamma3*1/Theta */
    const double t52 = JLT_FNMA(t24, t51, t49); /* 1/Theta*C*I3*M - 1/Theta*(gamma3*C*I3*M + s*G*J3/R)*2*m*R^2*I3*gamma3*1/Theta */
    const double t53 = t50*p[25]; /* gamma3*1/Theta*(-I3*M) */
    const double t54 = t16*t53; /* S*gamma3*1/Theta*(-I3*M) */
    const double t55 = JLT_FNMA(x[2], t24, p[27]); /* 1/2*G*J3/(m*R^3*I1) - s*1/Theta*(gamma3*C*I3*M + s*G*J3/R) */
    const double t56 = t9*p[26]; /* 1/Theta*2*m*R^2*I1 */
    const double t57 = t55*t56; /* (1/2*G*J3/(m*R^3*I1) - s*1/Theta*(gamma3*C*I3*M + s*G*J3/R))*1/Theta*2*m*R^2*I1 */
    const double t58 = JLT_FMA(x[0], t34, t19); /* gamma3*t30*R/(I1^2*J1)*s*1/v_slip + (m*R*v_slip - M*S)*s*1/J1 */
    const double t59 = -t58; /* -t58 */
    const double t60 = x[0]*t40; /* gamma3*s*1/J1*(t38 - C*M) */
    const double t61 = -t60; /* -gamma3*s*1/J1*(t38 - C*M) */
    const double t62 = JLT_FMS(t17, p[7], t46); /* (m*R*v_slip - M*S)*1/J1 - R/(I1^2*J1)*s*1/v_slip*t45 */
    const double t63 = x[0]*t62; /* gamma3*((m*R*v_slip - M*S)*1/J1 - R/(I1^2*J1)*s*1/v_slip*t45) */
    const double t64 = -t63; /* -t63 */
    out[0] = t20;
    out[1] = t24;
    out[2] = t26;
    out[3] = t35;
    out[4] = t41;
    out[5] = t48;
    out[6] = t52;
    out[7] = t54;
    out[8] = t57;
    out[9] = t59;
    out[10] = t61;
    out[11] = t64;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = cos(x[1]); /* C = cos(psi) */
    const double t1 = x[2]*p[13]; /* s*I1*M */
    const double t2 = t0*t1; /* C*s*I1*M */
    const double t3 = JLT_FNMA(p[14], x[0], t2); /* C*s*I1*M - G*J1/R*gamma3 */
    const double t4 = x[2]*p[2]; /* s*I1 */
    const double t5 = x[2]*t4; /* s*s*I1 */
    const double t6 = x[0]*p[3]; /* gamma3*I3 */
    const double t7 = JLT_FMA(x[0], t6, t5); /* gamma3*gamma3*I3 + s*s*I1 */
    const double t8 = JLT_FMA(p[12], t7, p[11]); /* Theta = m*R^2*(gamma3*gamma3*I3 + s*s*I1) + I1*I3 */
    const double t9 = 1.0/t8; /* 1/Theta */
    const double t10 = t3*t9; /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta */
    const double t11 = p[10]*t3; /* (I1 - I3)*(C*s*I1*M - G*J1/R*gamma3) */
    const double t12 = JLT_FNMA(t10, t11, p[6]); /* F0 - (C*s*I1*M - G*J1/R*gamma3)*1/Theta*(I1 - I3)*(C*s*I1*M - G*J1/R*gamma3) */
    const double t13 = p[9]*t12; /* 1/(m*I1^2)*t12 */
    const double t14 = sqrt(t13); /* v_slip = sqrt(1/(m*I1^2)*t12) */
    const double t15 = 1.0/t14; /* 1/v_slip */
    const double t16 = t10*t10; /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta*(C*s*I1*M - G*J1/R*gamma3)*1/Theta */
    const double t17 = x[0]*p[17]; /* gamma3*m*R^2*I3*(I1 - I3) */
    const double t18 = t16*t17; /* t16*gamma3*m*R^2*I3*(I1 - I3) */
    const double t19 = JLT_FMA(t10, p[18], t18); /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta*G*J1*(I1 - I3)/R + t16*gamma3*m*R^2*I3*(I1 - I3) */
    const double t20 = x[2]*t19; /* s*t19 */
    const double t21 = t0*p[22]; /* C*I1*M*(I1 - I3) */
    const double t22 = t10*t21; /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta*C*I1*M*(I1 - I3) */
    const double t23 = x[2]*p[23]; /* s*m*R^2*I1*(I1 - I3) */
    const double t24 = JLT_FNMA(t16, t23, t22); /* (C*s*I1*M - G*J1/R*gamma3)*1/Theta*C*I1*M*(I1 - I3) - t16*s*m*R^2*I1*(I1 - I3) */
    const double t25 = JLT_FMA(x[0], t24, t20); /* gamma3*t24 + s*t19 */
    const double t26 = p[19]*x[2]; /* R/(I1^2*J1)*s */
    const double t27 = t25*t26; /* (gamma3*t24 + s*t19)*R/(I1^2*J1)*s */
    const double t28 = t15*t27; /* 1/v_slip*(gamma3*t24 + s*t19)*R/(I1^2*J1)*s */
    const double t29 = sin(x[1]); /* S = sin(psi) */
    const double t30 = t9*p[16]; /* 1/Theta*I3*M */
    const double t31 = t29*t30; /* S*1/Theta*I3*M */
    const double t32 = t14*p[8]; /* v_slip*m*R */
    const double t33 = JLT_FNMA(t29, p[5], t32); /* v_slip*m*R - S*M */
    const double t34 = JLT_FMA(p[7], t33, t31); /* 1/J1*(v_slip*m*R - S*M) + S*1/Theta*I3*M */
    const double t35 = JLT_FNMA(x[0], t34, t28); /* 1/v_slip*(gamma3*t24 + s*t19)*R/(I1^2*J1)*s - gamma3*(1/J1*(v_slip*m*R - S*M) + S*1/Theta*I3*M) */
    out[0] = t35;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[2];
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double t1[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double u20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double u32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = 0;
    for (unsigned k = 0; k < order; k++) {
        t1[k] = jlt_jet_product(x2, x2, k);
        t10[k] = t1[k]*p[2];
        t13[k] = p[3]*x0[k];
        t14[k] = jlt_jet_product(x0, t13, k) + t10[k];
        t15[k] = p[12]*t14[k] + (k == 0 ? p[11] : 0);
        t17[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t15, t17, k);
        t20[k] = jlt_jet_cosine(x1, t20, u20, k);
        t21[k] = x2[k]*p[13];
        t22[k] = jlt_jet_product(t20, t21, k);
        t24[k] = t22[k] - x0[k]*p[14];
        t25[k] = p[10]*t17[k];
        t26[k] = jlt_jet_product(t24, t25, k);
        t27[k] = (k == 0 ? p[6] : 0) - jlt_jet_product(t24, t26, k);
        t28[k] = p[9]*t27[k];
        t29[k] = jlt_jet_root(t28[k], t29, k);
        t30[k] = p[8]*t29[k];
        t32[k] = jlt_jet_sine(x1, t32, u32, k);
        t33[k] = t30[k] - p[5]*t32[k];
        t34[k] = p[7]*t33[k];
        t35[k] = jlt_jet_product(t1, t34, k);
        t37[k] = x2[k]*p[15];
        t39[k] = x0[k]*p[16];
        t40[k] = jlt_jet_product(t20, t39, k) + t37[k];
        t41[k] = jlt_jet_product(t17, t40, k);
        t42[k] = jlt_jet_product(x2, x0, k);
        t43[k] = jlt_jet_product(t34, t42, k);
        t44[k] = -t43[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t35[k]/(k + 1);
        next[1] = x1[k + 1] = t41[k]/(k + 1);
        next[2] = x2[k + 1] = t44[k]/(k + 1);
        next[3] = x2[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[2];
    const double v_I1 = params[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double complex v_J1 = (v_I1 + v_m*v_R*v_R);
    const double v_F0 = params[6];
    const double v_I3 = params[3];
    const double complex v_gamma3 = x[0];
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*(v_I1*v_s*v_s + v_I3*v_gamma3*v_gamma3));
    const double v_M = params[5];
    const double complex v_psi = x[1];
    const double complex v_C = ccos(v_psi);
    const double v_G = params[4];
    const double complex v_omega3 = ((v_I1*v_M*v_s*v_C - v_G*v_gamma3*v_J1/v_R)/v_Theta);
    const double complex v_v_slip = csqrt((v_F0 - v_Theta*v_omega3*v_omega3*(v_I1 - v_I3))/(v_m*v_I1*v_I1));
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s)*((v_s*v_omega_tau));
    const double complex v_J3 = (v_I3 + v_m*v_R*v_R);
    const double complex v_omega_n = ((v_G*v_s*v_J3/v_R + v_I3*v_M*v_gamma3*v_C)/v_Theta);
    out[1] = (v_s)*((v_omega_n/v_s));
    out[2] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "psi", "rad", "angle of the horizontal momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_plane_general_in_regular = {
    .model = "spherical_top_plane",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on a level of all three integrals",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "a4968b3c5759c8d01110b5ac20002cbaa9743f70ebbbb6790df56f7c04f68c44",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_plane,
    .state_count = 3, .param_count = 7, .block_count = 28,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 3, { 1, 16, 6, 1, 1, 2, 15, 6 }, { 11, 36, 0, 7, 1, 2, 17, 9 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 9, { 3, 40, 14, 2, 1, 2, 16, 12 }, { 46, 207, 0, 39, 1, 2, 18, 14 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: grows without bound, and so do rounding errors, where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 12, { 4, 42, 14, 2, 1, 2, 16, 15 }, { 50, 222, 0, 43, 1, 2, 18, 15 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: grows without bound, and so do rounding errors, where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 0, 21, 10, 2, 1, 2, 14, 8 }, { 20, 82, 0, 15, 1, 2, 17, 12 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: grows without bound, and so do rounding errors, where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { .loses_digits = "" },
    .integral_gradients = { .loses_digits = "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 0, .measure_count = 0, .equilibria_count = 0,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_plane_general_in_regular_baseline,
        &jlt_batch_spherical_top_plane_general_in_regular_avx2,
        &jlt_batch_spherical_top_plane_general_in_regular_avx512,
    },
};
