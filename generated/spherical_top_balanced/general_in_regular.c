/* Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_balanced, SHA-256 70ff20361cc8550a994847ce02cbc8dfe6b50b8424b0daf5121bfd70d4951a10
 *  Command:    ttc generate --out DIR spherical_top_balanced.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   17    5    1    0    2      8    7   (82)
 *  jacobian            2   40   13    1    0    2     12   18   (432)
 *  rhs_jacobian        4   44   13    1    0    2     11   17   (496)
 *  divergence          1    7    4    1    0    1     10    4   (26)
 *  integral_values     0    9    4    1    0    1      8    5   (30)
 *  integral_gradients  0   16    5    1    0    2      9    5   (101)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_balanced[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_general_in_regular_avx512;

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
    const double t2 = params[2] + t1; /* J1 = I1 + m*R*R */
    const double t3 = 1.0/t2; /* 1/J1 */
    const double t4 = params[0]*params[1]; /* m*R */
    const double t5 = params[1]*params[3]; /* R*I3 */
    const double t6 = t5/params[2]; /* R*I3/I1 */
    const double t7 = params[1] - t6; /* R - R*I3/I1 */
    const double t8 = params[2]*params[3]; /* I1*I3 */
    const double t9 = params[2]*params[5]; /* I1*M */
    const double t10 = t2*params[4]; /* J1*G */
    const double t11 = t10/params[1]; /* J1*G/R */
    const double t12 = t1 + params[3]; /* J3 = m*R*R + I3 */
    const double t13 = params[4]*t12; /* G*J3 */
    const double t14 = t13/params[1]; /* G*J3/R */
    const double t15 = params[3]*params[5]; /* I3*M */
    const double t16 = t4/t2; /* m*R/J1 */
    const double t17 = params[5]/t2; /* M/J1 */
    const double t18 = 2.0/t2; /* 2/J1 */
    const double t19 = t5*params[5]; /* R*I3*M */
    const double t20 = params[3]*params[3]; /* I3*I3 */
    const double t21 = params[1]*t20; /* R*I3*I3 */
    const double t22 = params[5]*t21; /* M*R*I3*I3 */
    const double t23 = t22/params[2]; /* M*R*I3*I3/I1 */
    const double t24 = t19 - t23; /* R*I3*M - M*R*I3*I3/I1 */
    const double t25 = params[3]*params[4]; /* I3*G */
    const double t26 = t2*t25; /* J1*I3*G */
    const double t27 = t26/params[2]; /* J1*I3*G/I1 */
    const double t28 = t10 - t27; /* J1*G - J1*I3*G/I1 */
    const double t29 = params[1]*t0; /* R*R*R */
    const double t30 = params[0]*t29; /* m*R*R*R */
    const double t31 = params[3]*t30; /* I3*m*R*R*R */
    const double t32 = t31*4.0; /* I3*m*R*R*R*4 */
    const double t33 = t20*t30; /* I3*I3*m*R*R*R */
    const double t34 = t33/params[2]; /* I3*I3*m*R*R*R/I1 */
    const double t35 = 4.0*t34; /* 4*I3*I3*m*R*R*R/I1 */
    const double t36 = t32 - t35; /* I3*m*R*R*R*4 - 4*I3*I3*m*R*R*R/I1 */
    const double t37 = params[2]*params[1]; /* I1*R */
    const double t38 = params[5]*t37; /* M*I1*R */
    const double t39 = t19 - t38; /* R*I3*M - M*I1*R */
    const double t40 = params[2]*t30; /* I1*m*R*R*R */
    const double t41 = 4.0*t40; /* 4*I1*m*R*R*R */
    const double t42 = t32 - t41; /* I3*m*R*R*R*4 - 4*I1*m*R*R*R */
    const double t43 = t12*t25; /* J3*I3*G */
    const double t44 = t43/params[2]; /* J3*I3*G/I1 */
    const double t45 = t13 - t44; /* G*J3 - J3*I3*G/I1 */
    const double t46 = params[0]*2.0; /* m*2 */
    const double t47 = t0*t46; /* R*R*m*2 */
    const double t48 = params[3]*t47; /* I3*R*R*m*2 */
    const double t49 = -t15; /* -I3*M */
    const double t50 = params[2]*t47; /* I1*R*R*m*2 */
    const double t51 = (-1.0)/t2; /* (-1)/J1 */
    const double t52 = -t16; /* -m*R/J1 */
    const double t53 = params[2]*params[2]; /* I1*I1 */
    const double t54 = params[0]*t53; /* m*I1*I1 */
    const double t55 = params[2] - params[3]; /* I1 - I3 */
    const double t56 = params[0]*(-2.0); /* m*(-2) */
    const double t57 = t0*t56; /* R*R*m*(-2) */
    const double t58 = params[3]*t57; /* I3*R*R*m*(-2) */
    const double t59 = t55*t58; /* (I1 - I3)*I3*R*R*m*(-2) */
    const double t60 = params[4]*(-2.0); /* G*(-2) */
    const double t61 = t2*t60; /* J1*G*(-2) */
    const double t62 = t55*t61; /* (I1 - I3)*J1*G*(-2) */
    const double t63 = t62/params[1]; /* (I1 - I3)*J1*G*(-2)/R */
    const double t64 = t46*t53; /* m*2*I1*I1 */
    const double t65 = params[2]*(-2.0); /* I1*(-2) */
    const double t66 = params[5]*t65; /* M*I1*(-2) */
    const double t67 = t55*t66; /* (I1 - I3)*M*I1*(-2) */
    const double t68 = params[2]*2.0; /* I1*2 */
    const double t69 = params[5]*t68; /* M*I1*2 */
    const double t70 = t55*t69; /* (I1 - I3)*M*I1*2 */
    const double t71 = t50*t55; /* I1*R*R*m*2*(I1 - I3) */
    out[6] = t3;
    out[7] = t4;
    out[8] = t7;
    out[9] = t8;
    out[10] = t1;
    out[11] = t9;
    out[12] = t11;
    out[13] = t14;
    out[14] = t15;
    out[15] = t16;
    out[16] = t17;
    out[17] = t18;
    out[18] = t24;
    out[19] = t28;
    out[20] = t36;
    out[21] = t39;
    out[22] = t42;
    out[23] = t45;
    out[24] = t48;
    out[25] = t49;
    out[26] = t50;
    out[27] = t51;
    out[28] = t52;
    out[29] = t54;
    out[30] = t55;
    out[31] = t59;
    out[32] = t63;
    out[33] = t64;
    out[34] = t67;
    out[35] = t70;
    out[36] = t71;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*x[3]; /* s*s */
    const double t1 = p[7]*x[1]; /* m*R*v_slip */
    const double t2 = sin(x[2]); /* S = sin(psi) */
    const double t3 = JLT_FNMA(p[5], t2, t1); /* m*R*v_slip - M*S */
    const double t4 = p[6]*t3; /* 1/J1*(m*R*v_slip - M*S) */
    const double t5 = t0*t4; /* s*s*1/J1*(m*R*v_slip - M*S) */
    const double t6 = t0*p[2]; /* s*s*I1 */
    const double t7 = p[3]*x[0]; /* I3*gamma3 */
    const double t8 = JLT_FMA(x[0], t7, t6); /* gamma3*I3*gamma3 + s*s*I1 */
    const double t9 = JLT_FMA(p[10], t8, p[9]); /* Theta = m*R^2*(gamma3*I3*gamma3 + s*s*I1) + I1*I3 */
    const double t10 = 1.0/t9; /* 1/Theta */
    const double t11 = cos(x[2]); /* C = cos(psi) */
    const double t12 = x[3]*p[11]; /* s*I1*M */
    const double t13 = t11*t12; /* C*s*I1*M */
    const double t14 = JLT_FNMA(x[0], p[12], t13); /* C*s*I1*M - gamma3*G*J1/R */
    const double t15 = x[3]*p[13]; /* s*G*J3/R */
    const double t16 = x[0]*p[14]; /* gamma3*I3*M */
    const double t17 = JLT_FMA(t11, t16, t15); /* C*gamma3*I3*M + s*G*J3/R */
    const double t18 = t10*t17; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t19 = x[3]*p[8]; /* s*(R - R*I3/I1) */
    const double t20 = t10*t19; /* 1/Theta*s*(R - R*I3/I1) */
    const double t21 = t14*t20; /* (C*s*I1*M - gamma3*G*J1/R)*1/Theta*s*(R - R*I3/I1) */
    const double t22 = t18*t21; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R)*(C*s*I1*M - gamma3*G*J1/R)*1/Theta*s*(R - R*I3/I1) */
    const double t23 = x[3]*x[0]; /* s*gamma3 */
    const double t24 = t4*t23; /* 1/J1*(m*R*v_slip - M*S)*s*gamma3 */
    const double t25 = -t24; /* -1/J1*(m*R*v_slip - M*S)*s*gamma3 */
    out[0] = t5;
    out[1] = t22;
    out[2] = t18;
    out[3] = t25;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*p[15]; /* s*m*R/J1 */
    const double t1 = x[3]*t0; /* s*s*m*R/J1 */
    const double t2 = cos(x[2]); /* C = cos(psi) */
    const double t3 = x[3]*t2; /* s*C */
    const double t4 = p[16]*t3; /* M/J1*s*C */
    const double t5 = x[3]*t4; /* s*M/J1*s*C */
    const double t6 = -t5; /* -s*M/J1*s*C */
    const double t7 = p[7]*x[1]; /* m*R*v_slip */
    const double t8 = sin(x[2]); /* S = sin(psi) */
    const double t9 = JLT_FNMA(p[5], t8, t7); /* m*R*v_slip - M*S */
    const double t10 = x[3]*t9; /* s*(m*R*v_slip - M*S) */
    const double t11 = p[17]*t10; /* 2/J1*s*(m*R*v_slip - M*S) */
    const double t12 = t3*p[11]; /* s*C*I1*M */
    const double t13 = JLT_FNMA(p[12], x[0], t12); /* s*C*I1*M - G*J1/R*gamma3 */
    const double t14 = x[3]*p[2]; /* s*I1 */
    const double t15 = x[3]*t14; /* s*s*I1 */
    const double t16 = x[0]*p[3]; /* gamma3*I3 */
    const double t17 = JLT_FMA(x[0], t16, t15); /* gamma3*gamma3*I3 + s*s*I1 */
    const double t18 = JLT_FMA(p[10], t17, p[9]); /* Theta = m*R^2*(gamma3*gamma3*I3 + s*s*I1) + I1*I3 */
    const double t19 = 1.0/t18; /* 1/Theta */
    const double t20 = t19*t19; /* 1/Theta*1/Theta */
    const double t21 = x[3]*t20; /* s*1/Theta*1/Theta */
    const double t22 = t13*t21; /* (s*C*I1*M - G*J1/R*gamma3)*s*1/Theta*1/Theta */
    const double t23 = p[18]*t22; /* (R*I3*M - R*I3^2*M/I1)*(s*C*I1*M - G*J1/R*gamma3)*s*1/Theta*1/Theta */
    const double t24 = t2*t23; /* C*t23 */
    const double t25 = x[3]*p[13]; /* s*G*J3/R */
    const double t26 = t2*p[14]; /* C*I3*M */
    const double t27 = JLT_FMA(x[0], t26, t25); /* gamma3*C*I3*M + s*G*J3/R */
    const double t28 = t21*t27; /* s*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R) */
    const double t29 = x[0]*t19; /* gamma3*1/Theta */
    const double t30 = p[20]*t29; /* (4*m*R^3*I3 - 4*m*R^3*I3^2/I1)*gamma3*1/Theta */
    const double t31 = JLT_FMA(t13, t30, p[19]); /* (s*C*I1*M - G*J1/R*gamma3)*(4*m*R^3*I3 - 4*m*R^3*I3^2/I1)*gamma3*1/Theta + G*J1 - I3*G*J1/I1 */
    const double t32 = JLT_FNMA(t28, t31, t24); /* C*t23 - s*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R)*t31 */
    const double t33 = t28*p[21]; /* s*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R)*(R*I3*M - R*I1*M) */
    const double t34 = x[3]*t33; /* s*t33 */
    const double t35 = JLT_FNMA(x[0], t23, t34); /* s*t33 - gamma3*t23 */
    const double t36 = t8*t35; /* S*(s*t33 - gamma3*t23) */
    const double t37 = x[3]*p[22]; /* s*(4*m*R^3*I3 - 4*m*R^3*I1) */
    const double t38 = t19*t37; /* 1/Theta*s*(4*m*R^3*I3 - 4*m*R^3*I1) */
    const double t39 = t28*t38; /* s*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R)*1/Theta*s*(4*m*R^3*I3 - 4*m*R^3*I1) */
    const double t40 = t20*t27; /* 1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R) */
    const double t41 = JLT_FMA(p[8], t40, t39); /* (R - R*I3/I1)*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R) + t39 */
    const double t42 = t22*p[23]; /* (s*C*I1*M - G*J1/R*gamma3)*s*1/Theta*1/Theta*(G*J3 - I3*G*J3/I1) */
    const double t43 = JLT_FNMA(t2, t33, t42); /* t42 - C*t33 */
    const double t44 = JLT_FMA(t13, t41, t43); /* (s*C*I1*M - G*J1/R*gamma3)*t41 + t42 - C*t33 */
    const double t45 = t19*t26; /* 1/Theta*C*I3*M */
    const double t46 = x[0]*p[24]; /* gamma3*2*m*R^2*I3 */
    const double t47 = JLT_FNMA(t40, t46, t45); /* 1/Theta*C*I3*M - 1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R)*gamma3*2*m*R^2*I3 */
    const double t48 = t29*p[25]; /* gamma3*1/Theta*(-I3*M) */
    const double t49 = t8*t48; /* S*gamma3*1/Theta*(-I3*M) */
    const double t50 = t19*p[13]; /* 1/Theta*G*J3/R */
    const double t51 = JLT_FNMA(t28, p[26], t50); /* 1/Theta*G*J3/R - s*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R)*2*m*R^2*I1 */
    const double t52 = t10*p[27]; /* s*(m*R*v_slip - M*S)*(-1/J1) */
    const double t53 = t0*x[0]; /* s*m*R/J1*gamma3 */
    const double t54 = -t53; /* -s*m*R/J1*gamma3 */
    const double t55 = t4*x[0]; /* M/J1*s*C*gamma3 */
    const double t56 = x[0]*p[27]; /* gamma3*(-1/J1) */
    const double t57 = t9*t56; /* (m*R*v_slip - M*S)*gamma3*(-1/J1) */
    out[0] = 0.0;
    out[1] = t1;
    out[2] = t6;
    out[3] = t11;
    out[4] = t32;
    out[5] = 0.0;
    out[6] = t36;
    out[7] = t44;
    out[8] = t47;
    out[9] = 0.0;
    out[10] = t49;
    out[11] = t51;
    out[12] = t52;
    out[13] = t54;
    out[14] = t55;
    out[15] = t57;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*x[3]; /* s*s */
    const double t1 = p[7]*x[1]; /* m*R*v_slip */
    const double t2 = sin(x[2]); /* S = sin(psi) */
    const double t3 = JLT_FNMA(p[5], t2, t1); /* m*R*v_slip - M*S */
    const double t4 = p[6]*t3; /* 1/J1*(m*R*v_slip - M*S) */
    const double t5 = t0*t4; /* s*s*1/J1*(m*R*v_slip - M*S) */
    const double t6 = cos(x[2]); /* C = cos(psi) */
    const double t7 = x[3]*p[11]; /* s*I1*M */
    const double t8 = t6*t7; /* C*s*I1*M */
    const double t9 = JLT_FNMA(p[12], x[0], t8); /* C*s*I1*M - G*J1/R*gamma3 */
    const double t10 = t0*p[2]; /* s*s*I1 */
    const double t11 = x[0]*p[3]; /* gamma3*I3 */
    const double t12 = JLT_FMA(x[0], t11, t10); /* gamma3*gamma3*I3 + s*s*I1 */
    const double t13 = JLT_FMA(p[10], t12, p[9]); /* Theta = m*R^2*(gamma3*gamma3*I3 + s*s*I1) + I1*I3 */
    const double t14 = 1.0/t13; /* 1/Theta */
    const double t15 = x[3]*t14; /* s*1/Theta */
    const double t16 = t9*t15; /* (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta */
    const double t17 = x[3]*p[13]; /* s*G*J3/R */
    const double t18 = x[0]*p[14]; /* gamma3*I3*M */
    const double t19 = JLT_FMA(t6, t18, t17); /* C*gamma3*I3*M + s*G*J3/R */
    const double t20 = t14*t19; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t21 = p[8]*t20; /* (R - R*I3/I1)*1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t22 = t16*t21; /* (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta*(R - R*I3/I1)*1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t23 = x[3]*x[0]; /* s*gamma3 */
    const double t24 = t4*t23; /* 1/J1*(m*R*v_slip - M*S)*s*gamma3 */
    const double t25 = -t24; /* -1/J1*(m*R*v_slip - M*S)*s*gamma3 */
    const double t26 = t0*p[15]; /* s*s*m*R/J1 */
    const double t27 = t6*p[16]; /* C*M/J1 */
    const double t28 = t0*t27; /* s*s*C*M/J1 */
    const double t29 = -t28; /* -s*s*C*M/J1 */
    const double t30 = x[3]*p[17]; /* s*2/J1 */
    const double t31 = t3*t30; /* (m*R*v_slip - M*S)*s*2/J1 */
    const double t32 = t6*t14; /* C*1/Theta */
    const double t33 = p[18]*t32; /* (R*I3*M - R*I3^2*M/I1)*C*1/Theta */
    const double t34 = x[0]*t14; /* gamma3*1/Theta */
    const double t35 = t20*t34; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R)*gamma3*1/Theta */
    const double t36 = JLT_FNMA(p[20], t35, t33); /* (R*I3*M - R*I3^2*M/I1)*C*1/Theta - (4*m*R^3*I3 - 4*m*R^3*I3^2/I1)*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*gamma3*1/Theta */
    const double t37 = t16*t36; /* (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta*t36 */
    const double t38 = t15*t20; /* s*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t39 = JLT_FNMA(p[19], t38, t37); /* (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta*t36 - (G*J1 - I3*G*J1/I1)*s*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t40 = t15*p[21]; /* s*1/Theta*(R*I3*M - R*I1*M) */
    const double t41 = t15*t40; /* s*1/Theta*s*1/Theta*(R*I3*M - R*I1*M) */
    const double t42 = t19*t41; /* (C*gamma3*I3*M + s*G*J3/R)*s*1/Theta*s*1/Theta*(R*I3*M - R*I1*M) */
    const double t43 = p[18]*t34; /* (R*I3*M - R*I3^2*M/I1)*gamma3*1/Theta */
    const double t44 = JLT_FNMA(t16, t43, t42); /* t42 - (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta*(R*I3*M - R*I3^2*M/I1)*gamma3*1/Theta */
    const double t45 = t2*t44; /* S*t44 */
    const double t46 = t9*t21; /* (C*s*I1*M - G*J1/R*gamma3)*(R - R*I3/I1)*1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t47 = JLT_FMA(t16, p[23], t46); /* (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta*(G*J3 - I3*G*J3/I1) + t46 */
    const double t48 = t14*t47; /* 1/Theta*t47 */
    const double t49 = t6*p[21]; /* C*(R*I3*M - R*I1*M) */
    const double t50 = JLT_FNMA(t16, p[22], t49); /* C*(R*I3*M - R*I1*M) - (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta*(4*m*R^3*I3 - 4*m*R^3*I1) */
    const double t51 = JLT_FNMA(t38, t50, t48); /* 1/Theta*t47 - s*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*t50 */
    const double t52 = p[14]*t32; /* I3*M*C*1/Theta */
    const double t53 = JLT_FNMA(t35, p[24], t52); /* I3*M*C*1/Theta - 1/Theta*(C*gamma3*I3*M + s*G*J3/R)*gamma3*1/Theta*2*m*R^2*I3 */
    const double t54 = t34*p[25]; /* gamma3*1/Theta*(-I3*M) */
    const double t55 = t2*t54; /* S*gamma3*1/Theta*(-I3*M) */
    const double t56 = t14*p[13]; /* 1/Theta*G*J3/R */
    const double t57 = JLT_FNMA(t38, p[26], t56); /* 1/Theta*G*J3/R - s*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*2*m*R^2*I1 */
    const double t58 = x[3]*t4; /* s*1/J1*(m*R*v_slip - M*S) */
    const double t59 = -t58; /* -s*1/J1*(m*R*v_slip - M*S) */
    const double t60 = t23*p[28]; /* s*gamma3*(-m*R/J1) */
    const double t61 = t23*t27; /* s*gamma3*C*M/J1 */
    const double t62 = t4*x[0]; /* 1/J1*(m*R*v_slip - M*S)*gamma3 */
    const double t63 = -t62; /* -1/J1*(m*R*v_slip - M*S)*gamma3 */
    out[0] = t5;
    out[1] = t22;
    out[2] = t20;
    out[3] = t25;
    out[4] = 0.0;
    out[5] = t26;
    out[6] = t29;
    out[7] = t31;
    out[8] = t39;
    out[9] = 0.0;
    out[10] = t45;
    out[11] = t51;
    out[12] = t53;
    out[13] = 0.0;
    out[14] = t55;
    out[15] = t57;
    out[16] = t59;
    out[17] = t60;
    out[18] = t61;
    out[19] = t63;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = sin(x[2]); /* S = sin(psi) */
    const double t1 = p[2]*x[3]; /* I1*s */
    const double t2 = x[3]*t1; /* s*I1*s */
    const double t3 = x[0]*p[3]; /* gamma3*I3 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* gamma3*gamma3*I3 + s*I1*s */
    const double t5 = JLT_FMA(p[10], t4, p[9]); /* Theta = m*R^2*(gamma3*gamma3*I3 + s*I1*s) + I1*I3 */
    const double t6 = 1.0/t5; /* 1/Theta */
    const double t7 = p[14]*t6; /* I3*M*1/Theta */
    const double t8 = t0*t7; /* S*I3*M*1/Theta */
    const double t9 = p[7]*x[1]; /* m*R*v_slip */
    const double t10 = JLT_FNMA(t0, p[5], t9); /* m*R*v_slip - S*M */
    const double t11 = JLT_FMA(p[6], t10, t8); /* 1/J1*(m*R*v_slip - S*M) + S*I3*M*1/Theta */
    const double t12 = x[0]*t11; /* gamma3*(1/J1*(m*R*v_slip - S*M) + S*I3*M*1/Theta) */
    const double t13 = -t12; /* -gamma3*(1/J1*(m*R*v_slip - S*M) + S*I3*M*1/Theta) */
    out[0] = t13;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[29]*x[1]; /* m*I1^2*v_slip */
    const double t1 = x[1]*t0; /* v_slip*m*I1^2*v_slip */
    const double t2 = p[2]*x[3]; /* I1*s */
    const double t3 = x[3]*t2; /* s*I1*s */
    const double t4 = p[3]*x[0]; /* I3*gamma3 */
    const double t5 = JLT_FMA(x[0], t4, t3); /* gamma3*I3*gamma3 + s*I1*s */
    const double t6 = JLT_FMA(p[10], t5, p[9]); /* Theta = m*R^2*(gamma3*I3*gamma3 + s*I1*s) + I1*I3 */
    const double t7 = 1.0/t6; /* 1/Theta */
    const double t8 = cos(x[2]); /* C = cos(psi) */
    const double t9 = x[3]*p[11]; /* s*I1*M */
    const double t10 = t8*t9; /* C*s*I1*M */
    const double t11 = JLT_FNMA(x[0], p[12], t10); /* C*s*I1*M - gamma3*G*J1/R */
    const double t12 = p[30]*t7; /* (I1 - I3)*1/Theta */
    const double t13 = t11*t12; /* (C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*1/Theta */
    const double t14 = JLT_FMA(t11, t13, t1); /* (C*s*I1*M - gamma3*G*J1/R)*(C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*1/Theta + v_slip*m*I1^2*v_slip */
    out[0] = t14;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[2]*x[3]; /* I1*s */
    const double t1 = x[3]*t0; /* s*I1*s */
    const double t2 = x[0]*p[3]; /* gamma3*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* gamma3*gamma3*I3 + s*I1*s */
    const double t4 = JLT_FMA(p[10], t3, p[9]); /* Theta = m*R^2*(gamma3*gamma3*I3 + s*I1*s) + I1*I3 */
    const double t5 = 1.0/t4; /* 1/Theta */
    const double t6 = cos(x[2]); /* C = cos(psi) */
    const double t7 = x[3]*p[11]; /* s*I1*M */
    const double t8 = t6*t7; /* C*s*I1*M */
    const double t9 = JLT_FNMA(x[0], p[12], t8); /* C*s*I1*M - gamma3*G*J1/R */
    const double t10 = t5*t9; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R) */
    const double t11 = p[31]*x[0]; /* (-2*m*R^2*I3*(I1 - I3))*gamma3 */
    const double t12 = t10*t11; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*(-2*m*R^2*I3*(I1 - I3))*gamma3 */
    const double t13 = t10*t12; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*t12 */
    const double t14 = JLT_FMA(t10, p[32], t13); /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*(-2*G*J1*(I1 - I3)/R) + 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*t12 */
    const double t15 = p[33]*x[1]; /* 2*m*I1^2*v_slip */
    const double t16 = sin(x[2]); /* S = sin(psi) */
    const double t17 = x[3]*t10; /* s*1/Theta*(C*s*I1*M - gamma3*G*J1/R) */
    const double t18 = p[34]*t16; /* (-2*I1*M*(I1 - I3))*S */
    const double t19 = t17*t18; /* s*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*(-2*I1*M*(I1 - I3))*S */
    const double t20 = t6*p[35]; /* C*2*I1*M*(I1 - I3) */
    const double t21 = t10*t20; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*C*2*I1*M*(I1 - I3) */
    const double t22 = t10*p[36]; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*2*m*R^2*I1*(I1 - I3) */
    const double t23 = JLT_FNMA(t17, t22, t21); /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*C*2*I1*M*(I1 - I3) - s*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*2*m*R^2*I1*(I1 - I3) */
    out[0] = t14;
    out[1] = t15;
    out[2] = t19;
    out[3] = t23;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[3];
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double t1[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double u8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double u25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = 0;
    for (unsigned k = 0; k < order; k++) {
        t1[k] = jlt_jet_product(x3, x3, k);
        t5[k] = p[7]*x1[k];
        t8[k] = jlt_jet_sine(x2, t8, u8, k);
        t9[k] = t5[k] - p[5]*t8[k];
        t10[k] = p[6]*t9[k];
        t11[k] = jlt_jet_product(t1, t10, k);
        t16[k] = t1[k]*p[2];
        t19[k] = p[3]*x0[k];
        t20[k] = jlt_jet_product(x0, t19, k) + t16[k];
        t21[k] = p[10]*t20[k] + (k == 0 ? p[9] : 0);
        t23[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t21, t23, k);
        t25[k] = jlt_jet_cosine(x2, t25, u25, k);
        t26[k] = x3[k]*p[11];
        t27[k] = jlt_jet_product(t25, t26, k);
        t29[k] = t27[k] - x0[k]*p[12];
        t31[k] = x3[k]*p[13];
        t33[k] = x0[k]*p[14];
        t34[k] = jlt_jet_product(t25, t33, k) + t31[k];
        t35[k] = jlt_jet_product(t23, t34, k);
        t36[k] = x3[k]*p[8];
        t37[k] = jlt_jet_product(t23, t36, k);
        t38[k] = jlt_jet_product(t29, t37, k);
        t39[k] = jlt_jet_product(t35, t38, k);
        t40[k] = jlt_jet_product(x3, x0, k);
        t41[k] = jlt_jet_product(t10, t40, k);
        t42[k] = -t41[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t11[k]/(k + 1);
        next[1] = x1[k + 1] = t39[k]/(k + 1);
        next[2] = x2[k + 1] = t35[k]/(k + 1);
        next[3] = x3[k + 1] = t42[k]/(k + 1);
        next[4] = x3[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[3];
    const double v_I1 = params[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double complex v_J1 = (v_I1 + v_m*v_R*v_R);
    const double complex v_v_slip = x[1];
    const double v_M = params[5];
    const double complex v_psi = x[2];
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s)*((v_s*v_omega_tau));
    const double v_I3 = params[3];
    const double complex v_gamma3 = x[0];
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*(v_I1*v_s*v_s + v_I3*v_gamma3*v_gamma3));
    const double v_G = params[4];
    const double complex v_J3 = (v_I3 + v_m*v_R*v_R);
    const double complex v_C = ccos(v_psi);
    const double complex v_omega_n = ((v_G*v_s*v_J3/v_R + v_I3*v_M*v_gamma3*v_C)/v_Theta);
    const double complex v_omega3 = ((v_I1*v_M*v_s*v_C - v_G*v_gamma3*v_J1/v_R)/v_Theta);
    out[1] = (v_s)*((v_R*v_omega_n*v_omega3)
        + (-v_R*v_I3*v_omega_n*v_omega3/v_I1));
    out[2] = (v_s)*((v_omega_n/v_s));
    out[3] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_slip", "m/s", "velocity of the contact point along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
};

static const jlt_named integrals[] = {
    { "F0", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_general_in_regular = {
    .model = "spherical_top_balanced",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "70ff20361cc8550a994847ce02cbc8dfe6b50b8424b0daf5121bfd70d4951a10",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_balanced,
    .state_count = 4, .param_count = 6, .block_count = 37,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 1, 17, 5, 1, 0, 2, 8, 7 }, { 13, 57, 0, 10, 0, 2, 10, 11 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .jacobian = { jacobian, 16, { 2, 40, 13, 1, 0, 2, 12, 18 }, { 56, 318, 0, 56, 0, 2, 16, 11 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .rhs_jacobian = { rhs_jacobian, 20, { 4, 44, 13, 1, 0, 2, 11, 17 }, { 65, 363, 0, 66, 0, 2, 16, 11 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .divergence = { divergence, 1, { 1, 7, 4, 1, 0, 1, 10, 4 }, { 6, 17, 0, 2, 0, 1, 8, 7 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .integral_values = { integral_values, 1, { 0, 9, 4, 1, 0, 1, 8, 5 }, { 6, 21, 0, 2, 0, 1, 10, 6 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .integral_gradients = { integral_gradients, 4, { 0, 16, 5, 1, 0, 2, 9, 5 }, { 16, 73, 0, 10, 0, 2, 13, 9 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_general_in_regular_baseline,
        &jlt_batch_spherical_top_balanced_general_in_regular_avx2,
        &jlt_batch_spherical_top_balanced_general_in_regular_avx512,
    },
};
