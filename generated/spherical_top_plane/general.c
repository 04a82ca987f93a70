/* Balanced sphere with one nonholonomic constraint, on a level of all three integrals
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Table:      spherical_top_plane, SHA-256 a4968b3c5759c8d01110b5ac20002cbaa9743f70ebbbb6790df56f7c04f68c44
 *  Command:    ttc generate --out DIR spherical_top_plane.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   16    6    1    2    2     14    8   (52)
 *  jacobian            2   31   13    2    2    2     15   13   (157)
 *  rhs_jacobian        2   31   13    2    2    2     15   15   (172)
 *  divergence          2   17    9    2    2    2     17    9   (93)
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
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    const double t3 = params[2] + t2; /* J1 = I1 + m*R*R */
    const double t4 = t0/t3; /* m*R/J1 */
    const double t5 = params[2]*params[2]; /* I1*I1 */
    const double t6 = params[0]*t5; /* m*I1*I1 */
    const double t7 = 1.0/t6; /* 1/(m*I1*I1) */
    const double t8 = params[2] - params[3]; /* I1 - I3 */
    const double t9 = params[2]*params[5]; /* I1*M */
    const double t10 = t3*params[4]; /* J1*G */
    const double t11 = t10/params[1]; /* J1*G/R */
    const double t12 = params[2]*params[3]; /* I1*I3 */
    const double t13 = params[2]*t2; /* I1*m*R*R */
    const double t14 = params[3]/params[2]; /* I3/I1 */
    const double t15 = params[5]/t0; /* M/(m*R) */
    const double t16 = t2 + params[3]; /* J3 = m*R*R + I3 */
    const double t17 = params[4]*t16; /* G*J3 */
    const double t18 = t17/params[1]; /* G*J3/R */
    const double t19 = params[3]*params[5]; /* I3*M */
    const double t20 = params[1]*params[5]; /* R*M */
    const double t21 = params[2]*t3; /* I1*J1 */
    const double t22 = t20/t21; /* R*M/(I1*J1) */
    const double t23 = params[4]/t5; /* G/(I1*I1) */
    const double t24 = params[1]*t1; /* R*R*R */
    const double t25 = params[0]*t24; /* m*R*R*R */
    const double t26 = t3*t5; /* J1*I1*I1 */
    const double t27 = t25/t26; /* m*R*R*R/(J1*I1*I1) */
    const double t28 = 1.0/t3; /* 1/J1 */
    const double t29 = t8*t20; /* (I1 - I3)*R*M */
    const double t30 = t29/params[2]; /* (I1 - I3)*R*M/I1 */
    const double t31 = params[0]*2.0; /* m*2 */
    const double t32 = t1*t31; /* R*R*m*2 */
    const double t33 = -t19; /* -I3*M */
    const double t34 = t8*params[4]; /* (I1 - I3)*G */
    const double t35 = t34/t5; /* (I1 - I3)*G/(I1*I1) */
    const double t36 = t29/t21; /* (I1 - I3)*R*M/(I1*J1) */
    const double t37 = t8*t8; /* (I1 - I3)*(I1 - I3) */
    const double t38 = t25*t37; /* m*R*R*R*(I1 - I3)*(I1 - I3) */
    const double t39 = t38/t26; /* m*R*R*R*(I1 - I3)*(I1 - I3)/(J1*I1*I1) */
    const double t40 = t8*t32; /* (I1 - I3)*R*R*m*2 */
    const double t41 = t12/t2; /* I1*I3/(m*R*R) */
    const double t42 = t19/t2; /* I3*M/(m*R*R) */
    const double t43 = t8/t2; /* (I1 - I3)/(m*R*R) */
    const double t44 = t0*params[2]; /* m*R*I1 */
    const double t45 = t3*t44; /* J1*m*R*I1 */
    const double t46 = t8*params[5]; /* (I1 - I3)*M */
    const double t47 = t46/t45; /* (I1 - I3)*M/(J1*m*R*I1) */
    const double t48 = t0*t5; /* m*R*I1*I1 */
    const double t49 = t3*t48; /* J1*m*R*I1*I1 */
    const double t50 = t37/t49; /* (I1 - I3)*(I1 - I3)/(J1*m*R*I1*I1) */
    const double t51 = t2*t5; /* m*R*R*I1*I1 */
    const double t52 = t34/t51; /* (I1 - I3)*G/(m*R*R*I1*I1) */
    out[7] = t4;
    out[8] = t7;
    out[9] = t8;
    out[10] = t9;
    out[11] = t11;
    out[12] = t12;
    out[13] = t13;
    out[14] = t14;
    out[15] = t15;
    out[16] = t18;
    out[17] = t19;
    out[18] = t22;
    out[19] = t23;
    out[20] = t27;
    out[21] = t28;
    out[22] = t30;
    out[23] = t32;
    out[24] = t33;
    out[25] = t35;
    out[26] = t36;
    out[27] = t39;
    out[28] = t40;
    out[29] = t41;
    out[30] = t42;
    out[31] = t43;
    out[32] = t47;
    out[33] = t50;
    out[34] = t52;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = t3*p[10]; /* s*I1*M */
    const double t6 = t4*t5; /* C*s*I1*M */
    const double t7 = JLT_FNMA(x[0], p[11], t6); /* C*s*I1*M - gamma3*G*J1/R */
    const double t8 = x[0]*p[14]; /* gamma3*I3/I1 */
    const double t9 = JLT_FMA(x[0], t8, t2); /* gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) */
    const double t10 = JLT_FMA(p[13], t9, p[12]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3)) + I1*I3 */
    const double t11 = t3*t10; /* s*Theta */
    const double t12 = 1.0/t11; /* 1/(s*Theta) */
    const double t13 = t3*t12; /* s*1/(s*Theta) */
    const double t14 = p[9]*t13; /* (I1 - I3)*s*1/(s*Theta) */
    const double t15 = t7*t14; /* (C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*s*1/(s*Theta) */
    const double t16 = JLT_FNMA(t7, t15, p[6]); /* F0 - (C*s*I1*M - gamma3*G*J1/R)*(C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*s*1/(s*Theta) */
    const double t17 = p[8]*t16; /* 1/(m*I1^2)*t16 */
    const double t18 = sqrt(t17); /* v_slip = sqrt(1/(m*I1^2)*t16) */
    const double t19 = sin(x[1]); /* S = sin(psi) */
    const double t20 = JLT_FNMA(p[15], t19, t18); /* v_slip - M/(m*R)*S */
    const double t21 = p[7]*t3; /* m*R/J1*s */
    const double t22 = t20*t21; /* (v_slip - M/(m*R)*S)*m*R/J1*s */
    const double t23 = t3*p[16]; /* s*G*J3/R */
    const double t24 = x[0]*p[17]; /* gamma3*I3*M */
    const double t25 = JLT_FMA(t4, t24, t23); /* C*gamma3*I3*M + s*G*J3/R */
    const double t26 = t10*t12; /* Theta*1/(s*Theta) */
    const double t27 = t13*t26; /* s*1/(s*Theta)*Theta*1/(s*Theta) */
    const double t28 = t25*t27; /* (C*gamma3*I3*M + s*G*J3/R)*s*1/(s*Theta)*Theta*1/(s*Theta) */
    out[0] = t22;
    out[1] = t28;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = p[10]*t3; /* I1*M*s */
    const double t6 = t4*t5; /* C*I1*M*s */
    const double t7 = JLT_FNMA(x[0], p[11], t6); /* C*I1*M*s - gamma3*G*J1/R */
    const double t8 = x[0]*p[14]; /* gamma3*I3/I1 */
    const double t9 = JLT_FMA(x[0], t8, t2); /* gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) */
    const double t10 = JLT_FMA(p[13], t9, p[12]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3)) + I1*I3 */
    const double t11 = t3*t10; /* s*Theta */
    const double t12 = 1.0/t11; /* 1/(s*Theta) */
    const double t13 = t3*t12; /* s*1/(s*Theta) */
    const double t14 = t7*t13; /* (C*I1*M*s - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t15 = p[9]*t7; /* (I1 - I3)*(C*I1*M*s - gamma3*G*J1/R) */
    const double t16 = JLT_FNMA(t14, t15, p[6]); /* F0 - (C*I1*M*s - gamma3*G*J1/R)*s*1/(s*Theta)*(I1 - I3)*(C*I1*M*s - gamma3*G*J1/R) */
    const double t17 = p[8]*t16; /* 1/(m*I1^2)*t16 */
    const double t18 = sqrt(t17); /* v_slip = sqrt(1/(m*I1^2)*t16) */
    const double t19 = sin(x[1]); /* S = sin(psi) */
    const double t20 = JLT_FNMA(p[15], t19, t18); /* v_slip - M/(m*R)*S */
    const double t21 = t10*t12; /* Theta*1/(s*Theta) */
    const double t22 = x[0]*t21; /* gamma3*Theta*1/(s*Theta) */
    const double t23 = p[7]*t22; /* m*R/J1*gamma3*Theta*1/(s*Theta) */
    const double t24 = t20*t23; /* (v_slip - M/(m*R)*S)*m*R/J1*gamma3*Theta*1/(s*Theta) */
    const double t25 = t22*p[18]; /* gamma3*Theta*1/(s*Theta)*R*M/(I1*J1) */
    const double t26 = p[9]*x[0]; /* (I1 - I3)*gamma3 */
    const double t27 = p[20]*t26; /* m*R^3/(I1^2*J1)*(I1 - I3)*gamma3 */
    const double t28 = JLT_FMA(t4, t25, p[19]); /* C*gamma3*Theta*1/(s*Theta)*R*M/(I1*J1) + G/I1^2 */
    const double t29 = JLT_FNMA(t14, t27, t28); /* C*gamma3*Theta*1/(s*Theta)*R*M/(I1*J1) + G/I1^2 - (C*I1*M*s - gamma3*G*J1/R)*s*1/(s*Theta)*m*R^3/(I1^2*J1)*(I1 - I3)*gamma3 */
    const double t30 = t3*t14; /* s*(C*I1*M*s - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t31 = t30/t18; /* s*(C*I1*M*s - gamma3*G*J1/R)*s*1/(s*Theta)/v_slip */
    const double t32 = p[9]*t29; /* (I1 - I3)*t29 */
    const double t33 = JLT_FMS(t31, t32, t24); /* s*(C*I1*M*s - gamma3*G*J1/R)*s*1/(s*Theta)/v_slip*(I1 - I3)*t29 - (v_slip - M/(m*R)*S)*m*R/J1*gamma3*Theta*1/(s*Theta) */
    const double t34 = t19*p[22]; /* S*R*M*(I1 - I3)/I1 */
    const double t35 = t31*t34; /* s*(C*I1*M*s - gamma3*G*J1/R)*s*1/(s*Theta)/v_slip*S*R*M*(I1 - I3)/I1 */
    const double t36 = JLT_FNMA(t4, p[5], t35); /* t35 - C*M */
    const double t37 = t3*p[21]; /* s*1/J1 */
    const double t38 = t36*t37; /* (t35 - C*M)*s*1/J1 */
    const double t39 = t3*p[16]; /* s*G*J3/R */
    const double t40 = t4*p[17]; /* C*I3*M */
    const double t41 = JLT_FMA(x[0], t40, t39); /* gamma3*C*I3*M + s*G*J3/R */
    const double t42 = t21*t22; /* Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) */
    const double t43 = t26*p[23]; /* (I1 - I3)*gamma3*2*m*R^2 */
    const double t44 = JLT_FMA(t13, t43, t42); /* s*1/(s*Theta)*(I1 - I3)*gamma3*2*m*R^2 + Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) */
    const double t45 = JLT_FNMA(t22, p[16], t40); /* C*I3*M - gamma3*Theta*1/(s*Theta)*G*J3/R */
    const double t46 = JLT_FMA(t41, t44, t45); /* (gamma3*C*I3*M + s*G*J3/R)*t44 + C*I3*M - gamma3*Theta*1/(s*Theta)*G*J3/R */
    const double t47 = t13*t21; /* s*1/(s*Theta)*Theta*1/(s*Theta) */
    const double t48 = t46*t47; /* t46*s*1/(s*Theta)*Theta*1/(s*Theta) */
    const double t49 = t13*p[24]; /* s*1/(s*Theta)*(-I3*M) */
    const double t50 = t22*t49; /* gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*(-I3*M) */
    const double t51 = t19*t50; /* S*gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*(-I3*M) */
    out[0] = t33;
    out[1] = t38;
    out[2] = t48;
    out[3] = t51;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = t3*p[10]; /* s*I1*M */
    const double t6 = t4*t5; /* C*s*I1*M */
    const double t7 = JLT_FNMA(x[0], p[11], t6); /* C*s*I1*M - gamma3*G*J1/R */
    const double t8 = x[0]*p[14]; /* gamma3*I3/I1 */
    const double t9 = JLT_FMA(x[0], t8, t2); /* gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) */
    const double t10 = JLT_FMA(p[13], t9, p[12]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3)) + I1*I3 */
    const double t11 = t3*t10; /* s*Theta */
    const double t12 = 1.0/t11; /* 1/(s*Theta) */
    const double t13 = t3*t12; /* s*1/(s*Theta) */
    const double t14 = t7*t13; /* (C*s*I1*M - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t15 = p[9]*t7; /* (I1 - I3)*(C*s*I1*M - gamma3*G*J1/R) */
    const double t16 = JLT_FNMA(t14, t15, p[6]); /* F0 - (C*s*I1*M - gamma3*G*J1/R)*s*1/(s*Theta)*(I1 - I3)*(C*s*I1*M - gamma3*G*J1/R) */
    const double t17 = p[8]*t16; /* 1/(m*I1^2)*t16 */
    const double t18 = sqrt(t17); /* v_slip = sqrt(1/(m*I1^2)*t16) */
    const double t19 = sin(x[1]); /* S = sin(psi) */
    const double t20 = JLT_FNMA(p[15], t19, t18); /* v_slip - M/(m*R)*S */
    const double t21 = p[7]*t20; /* m*R/J1*(v_slip - M/(m*R)*S) */
    const double t22 = t3*t21; /* s*m*R/J1*(v_slip - M/(m*R)*S) */
    const double t23 = t3*p[16]; /* s*G*J3/R */
    const double t24 = t4*p[17]; /* C*I3*M */
    const double t25 = JLT_FMA(x[0], t24, t23); /* gamma3*C*I3*M + s*G*J3/R */
    const double t26 = t12*t25; /* 1/(s*Theta)*(gamma3*C*I3*M + s*G*J3/R) */
    const double t27 = t3*t14; /* s*(C*s*I1*M - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t28 = t27/t18; /* s*(C*s*I1*M - gamma3*G*J1/R)*s*1/(s*Theta)/v_slip */
    const double t29 = p[25]*t28; /* G*(I1 - I3)/I1^2*s*(C*s*I1*M - gamma3*G*J1/R)*s*1/(s*Theta)/v_slip */
    const double t30 = t4*p[26]; /* C*R*M*(I1 - I3)/(I1*J1) */
    const double t31 = JLT_FMS(t28, t30, t21); /* s*(C*s*I1*M - gamma3*G*J1/R)*s*1/(s*Theta)/v_slip*C*R*M*(I1 - I3)/(I1*J1) - m*R/J1*(v_slip - M/(m*R)*S) */
    const double t32 = t10*t12; /* Theta*1/(s*Theta) */
    const double t33 = x[0]*t32; /* gamma3*Theta*1/(s*Theta) */
    const double t34 = x[0]*p[27]; /* gamma3*m*R^3*(I1 - I3)^2/(I1^2*J1) */
    const double t35 = t14*t34; /* (C*s*I1*M - gamma3*G*J1/R)*s*1/(s*Theta)*gamma3*m*R^3*(I1 - I3)^2/(I1^2*J1) */
    const double t36 = JLT_FNMA(t28, t35, t29); /* t29 - s*(C*s*I1*M - gamma3*G*J1/R)*s*1/(s*Theta)/v_slip*t35 */
    const double t37 = JLT_FMA(t31, t33, t36); /* t31*gamma3*Theta*1/(s*Theta) + t29 - s*(C*s*I1*M - gamma3*G*J1/R)*s*1/(s*Theta)/v_slip*t35 */
    const double t38 = t19*p[22]; /* S*R*M*(I1 - I3)/I1 */
    const double t39 = t28*t38; /* s*(C*s*I1*M - gamma3*G*J1/R)*s*1/(s*Theta)/v_slip*S*R*M*(I1 - I3)/I1 */
    const double t40 = JLT_FNMA(t4, p[5], t39); /* t39 - C*M */
    const double t41 = t3*p[21]; /* s*1/J1 */
    const double t42 = t40*t41; /* (t39 - C*M)*s*1/J1 */
    const double t43 = x[0]*p[28]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t44 = t13*t43; /* s*1/(s*Theta)*gamma3*2*m*R^2*(I1 - I3) */
    const double t45 = JLT_FMA(t32, t33, t44); /* Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) + s*1/(s*Theta)*gamma3*2*m*R^2*(I1 - I3) */
    const double t46 = JLT_FNMA(p[16], t33, t24); /* C*I3*M - G*J3/R*gamma3*Theta*1/(s*Theta) */
    const double t47 = JLT_FMA(t25, t45, t46); /* (gamma3*C*I3*M + s*G*J3/R)*t45 + C*I3*M - G*J3/R*gamma3*Theta*1/(s*Theta) */
    const double t48 = t12*t47; /* 1/(s*Theta)*t47 */
    const double t49 = t13*p[24]; /* s*1/(s*Theta)*(-I3*M) */
    const double t50 = t33*t49; /* gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*(-I3*M) */
    const double t51 = t19*t50; /* S*gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*(-I3*M) */
    out[0] = t22;
    out[1] = t26;
    out[2] = t37;
    out[3] = t42;
    out[4] = t48;
    out[5] = t51;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[3]; /* gamma3*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[29]); /* gamma3*gamma3*I3 + I1*I3/(m*R^2) */
    const double t5 = JLT_FMA(p[2], t2, t4); /* Theta scaled = I1*(1 - gamma3)*(gamma3 + 1) + gamma3*gamma3*I3 + I1*I3/(m*R^2) */
    const double t6 = sin(x[1]); /* S = sin(psi) */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = t5*t7; /* Theta scaled*s */
    const double t9 = 1.0/t8; /* 1/(Theta scaled*s) */
    const double t10 = t7*t9; /* s*1/(Theta scaled*s) */
    const double t11 = p[30]*t10; /* I3*M/(m*R^2)*s*1/(Theta scaled*s) */
    const double t12 = t6*t11; /* S*I3*M/(m*R^2)*s*1/(Theta scaled*s) */
    const double t13 = cos(x[1]); /* C = cos(psi) */
    const double t14 = t7*p[10]; /* s*I1*M */
    const double t15 = t13*t14; /* C*s*I1*M */
    const double t16 = JLT_FNMA(x[0], p[11], t15); /* C*s*I1*M - gamma3*G*J1/R */
    const double t17 = t10*t16; /* s*1/(Theta scaled*s)*(C*s*I1*M - gamma3*G*J1/R) */
    const double t18 = p[31]*t16; /* (I1 - I3)/(m*R^2)*(C*s*I1*M - gamma3*G*J1/R) */
    const double t19 = JLT_FNMA(t17, t18, p[6]); /* F0 - s*1/(Theta scaled*s)*(C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)/(m*R^2)*(C*s*I1*M - gamma3*G*J1/R) */
    const double t20 = p[8]*t19; /* 1/(m*I1^2)*t19 */
    const double t21 = sqrt(t20); /* v_slip = sqrt(1/(m*I1^2)*t19) */
    const double t22 = JLT_FNMA(t6, p[15], t21); /* v_slip - S*M/(m*R) */
    const double t23 = t7*t17; /* s*s*1/(Theta scaled*s)*(C*s*I1*M - gamma3*G*J1/R) */
    const double t24 = t23/t21; /* s*s*1/(Theta scaled*s)*(C*s*I1*M - gamma3*G*J1/R)/v_slip */
    const double t25 = t13*p[32]; /* C*M*(I1 - I3)/(m*R*I1*J1) */
    const double t26 = JLT_FMA(p[7], t22, t12); /* m*R/J1*(v_slip - S*M/(m*R)) + S*I3*M/(m*R^2)*s*1/(Theta scaled*s) */
    const double t27 = JLT_FNMA(t24, t25, t26); /* t26 - s*s*1/(Theta scaled*s)*(C*s*I1*M - gamma3*G*J1/R)/v_slip*C*M*(I1 - I3)/(m*R*I1*J1) */
    const double t28 = t5*t9; /* Theta scaled*1/(Theta scaled*s) */
    const double t29 = t27*t28; /* t27*Theta scaled*1/(Theta scaled*s) */
    const double t30 = t17*p[33]; /* s*1/(Theta scaled*s)*(C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)^2/(m*R*I1^2*J1) */
    const double t31 = JLT_FMA(t24, t30, t29); /* s*s*1/(Theta scaled*s)*(C*s*I1*M - gamma3*G*J1/R)/v_slip*t30 + t27*Theta scaled*1/(Theta scaled*s) */
    const double t32 = x[0]*t31; /* gamma3*t31 */
    const double t33 = JLT_FMS(t24, p[34], t32); /* s*s*1/(Theta scaled*s)*(C*s*I1*M - gamma3*G*J1/R)/v_slip*G*(I1 - I3)/(m*R^2*I1^2) - gamma3*t31 */
    out[0] = t33;
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
    double t12[JLT_JET_ORDER_MAX + 1];
    double u12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t12[k] = jlt_jet_cosine(x1, t12, u12, k);
        t13[k] = t6[k]*p[10];
        t14[k] = jlt_jet_product(t12, t13, k);
        t16[k] = t14[k] - x0[k]*p[11];
        t20[k] = x0[k]*p[14];
        t21[k] = jlt_jet_product(x0, t20, k) + t5[k];
        t22[k] = p[13]*t21[k] + (k == 0 ? p[12] : 0);
        t23[k] = jlt_jet_product(t6, t22, k);
        t24[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t23, t24, k);
        t25[k] = jlt_jet_product(t6, t24, k);
        t26[k] = p[9]*t25[k];
        t27[k] = jlt_jet_product(t16, t26, k);
        t28[k] = (k == 0 ? p[6] : 0) - jlt_jet_product(t16, t27, k);
        t29[k] = p[8]*t28[k];
        t30[k] = jlt_jet_root(t29[k], t30, k);
        t32[k] = jlt_jet_sine(x1, t32, u32, k);
        t33[k] = t30[k] - p[15]*t32[k];
        t34[k] = p[7]*t6[k];
        t35[k] = jlt_jet_product(t33, t34, k);
        t37[k] = t6[k]*p[16];
        t39[k] = x0[k]*p[17];
        t40[k] = jlt_jet_product(t12, t39, k) + t37[k];
        t41[k] = jlt_jet_product(t22, t24, k);
        t42[k] = jlt_jet_product(t25, t41, k);
        t43[k] = jlt_jet_product(t40, t42, k);
        double *restrict next = coefficients + (k + 1)*2;
        next[0] = x0[k + 1] = t35[k]/(k + 1);
        next[1] = x1[k + 1] = t43[k]/(k + 1);
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
    .state_count = 2, .param_count = 7, .block_count = 35,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 2, { 2, 16, 6, 1, 2, 2, 14, 8 }, { 10, 32, 0, 6, 2, 2, 16, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 4, { 2, 31, 13, 2, 2, 2, 15, 13 }, { 28, 104, 0, 21, 2, 2, 18, 14 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 6, { 2, 31, 13, 2, 2, 2, 15, 15 }, { 30, 114, 0, 24, 2, 2, 18, 15 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 17, 9, 2, 2, 2, 17, 9 }, { 18, 59, 0, 12, 2, 2, 19, 13 },
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
