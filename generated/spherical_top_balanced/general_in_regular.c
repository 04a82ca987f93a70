/* Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_balanced, SHA-256 70ff20361cc8550a994847ce02cbc8dfe6b50b8424b0daf5121bfd70d4951a10
 *  Command:    ttc generate --out DIR spherical_top_balanced.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   15    5    1    0    2      7    7   (82)
 *  jacobian            1   38   13    1    0    2     11   16   (432)
 *  rhs_jacobian        3   42   13    1    0    2     10   19   (496)
 *  divergence          1    3    4    1    0    1      7    4   (26)
 *  integral_values     0    6    4    1    0    1      5    5   (30)
 *  integral_gradients  1   13    5    1    0    2      7    5   (101)
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
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    const double t3 = params[2] + t2; /* J1 = I1 + m*R*R */
    const double t4 = t0/t3; /* m*R/J1 */
    const double t5 = params[5]/t0; /* M/(m*R) */
    const double t6 = params[1]*params[3]; /* R*I3 */
    const double t7 = t6/params[2]; /* R*I3/I1 */
    const double t8 = params[1] - t7; /* R - R*I3/I1 */
    const double t9 = params[2]*params[3]; /* I1*I3 */
    const double t10 = params[2]*t2; /* I1*m*R*R */
    const double t11 = params[3]/params[2]; /* I3/I1 */
    const double t12 = params[2]*params[5]; /* I1*M */
    const double t13 = t3*params[4]; /* J1*G */
    const double t14 = t13/params[1]; /* J1*G/R */
    const double t15 = t2 + params[3]; /* J3 = m*R*R + I3 */
    const double t16 = params[4]*t15; /* G*J3 */
    const double t17 = t16/params[1]; /* G*J3/R */
    const double t18 = params[5]*params[3]; /* M*I3 */
    const double t19 = params[5]/t3; /* M/J1 */
    const double t20 = params[0]*2.0; /* m*2 */
    const double t21 = params[1]*t20; /* R*m*2 */
    const double t22 = t21/t3; /* R*m*2/J1 */
    const double t23 = params[5]*t6; /* M*R*I3 */
    const double t24 = params[3]*params[3]; /* I3*I3 */
    const double t25 = params[1]*t24; /* R*I3*I3 */
    const double t26 = params[5]*t25; /* M*R*I3*I3 */
    const double t27 = t26/params[2]; /* M*R*I3*I3/I1 */
    const double t28 = t23 - t27; /* M*R*I3 - M*R*I3*I3/I1 */
    const double t29 = params[3]*params[4]; /* I3*G */
    const double t30 = t3*t29; /* J1*I3*G */
    const double t31 = t30/params[2]; /* J1*I3*G/I1 */
    const double t32 = t13 - t31; /* J1*G - J1*I3*G/I1 */
    const double t33 = params[1]*t1; /* R*R*R */
    const double t34 = params[0]*t33; /* m*R*R*R */
    const double t35 = params[3]*t34; /* I3*m*R*R*R */
    const double t36 = t35*4.0; /* I3*m*R*R*R*4 */
    const double t37 = t24*t34; /* I3*I3*m*R*R*R */
    const double t38 = t37/params[2]; /* I3*I3*m*R*R*R/I1 */
    const double t39 = 4.0*t38; /* 4*I3*I3*m*R*R*R/I1 */
    const double t40 = t36 - t39; /* I3*m*R*R*R*4 - 4*I3*I3*m*R*R*R/I1 */
    const double t41 = params[1]*params[2]; /* R*I1 */
    const double t42 = params[5]*t41; /* M*R*I1 */
    const double t43 = t23 - t42; /* M*R*I3 - M*R*I1 */
    const double t44 = t15*t29; /* J3*I3*G */
    const double t45 = t44/params[2]; /* J3*I3*G/I1 */
    const double t46 = t16 - t45; /* G*J3 - J3*I3*G/I1 */
    const double t47 = params[2]*t34; /* I1*m*R*R*R */
    const double t48 = 4.0*t47; /* 4*I1*m*R*R*R */
    const double t49 = t36 - t48; /* I3*m*R*R*R*4 - 4*I1*m*R*R*R */
    const double t50 = t1*t20; /* R*R*m*2 */
    const double t51 = params[3]*t50; /* I3*R*R*m*2 */
    const double t52 = -t18; /* -M*I3 */
    const double t53 = params[2]*t50; /* I1*R*R*m*2 */
    const double t54 = -t4; /* -m*R/J1 */
    const double t55 = t18/t10; /* M*I3/(I1*m*R*R) */
    const double t56 = params[3]/t2; /* I3/(m*R*R) */
    const double t57 = params[2]*params[2]; /* I1*I1 */
    const double t58 = params[0]*t57; /* m*I1*I1 */
    const double t59 = params[2] - params[3]; /* I1 - I3 */
    const double t60 = t59/t10; /* (I1 - I3)/(I1*m*R*R) */
    const double t61 = params[3]*(-2.0); /* I3*(-2) */
    const double t62 = t59*t61; /* (I1 - I3)*I3*(-2) */
    const double t63 = t62/t2; /* (I1 - I3)*I3*(-2)/(m*R*R) */
    const double t64 = t9/t2; /* I1*I3/(m*R*R) */
    const double t65 = params[4]*(-2.0); /* G*(-2) */
    const double t66 = t3*t65; /* J1*G*(-2) */
    const double t67 = t59*t66; /* (I1 - I3)*J1*G*(-2) */
    const double t68 = t67/t34; /* (I1 - I3)*J1*G*(-2)/(m*R*R*R) */
    const double t69 = t20*t57; /* m*2*I1*I1 */
    const double t70 = params[2]*2.0; /* I1*2 */
    const double t71 = params[5]*t70; /* M*I1*2 */
    const double t72 = t59*t71; /* (I1 - I3)*M*I1*2 */
    const double t73 = t72/t2; /* (I1 - I3)*M*I1*2/(m*R*R) */
    const double t74 = t59*t70; /* (I1 - I3)*I1*2 */
    const double t75 = t74/t2; /* (I1 - I3)*I1*2/(m*R*R) */
    out[6] = t4;
    out[7] = t5;
    out[8] = t8;
    out[9] = t9;
    out[10] = t10;
    out[11] = t11;
    out[12] = t12;
    out[13] = t14;
    out[14] = t17;
    out[15] = t18;
    out[16] = t19;
    out[17] = t22;
    out[18] = t28;
    out[19] = t32;
    out[20] = t40;
    out[21] = t43;
    out[22] = t46;
    out[23] = t49;
    out[24] = t51;
    out[25] = t52;
    out[26] = t53;
    out[27] = t54;
    out[28] = t55;
    out[29] = t56;
    out[30] = t58;
    out[31] = t60;
    out[32] = t63;
    out[33] = t64;
    out[34] = t68;
    out[35] = t69;
    out[36] = t73;
    out[37] = t75;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = sin(x[2]); /* S = sin(psi) */
    const double t1 = JLT_FNMA(p[7], t0, x[1]); /* v_slip - M/(m*R)*S */
    const double t2 = x[3]*p[6]; /* s*m*R/J1 */
    const double t3 = t1*t2; /* (v_slip - M/(m*R)*S)*s*m*R/J1 */
    const double t4 = x[3]*t3; /* s*(v_slip - M/(m*R)*S)*s*m*R/J1 */
    const double t5 = x[3]*x[3]; /* s*s */
    const double t6 = p[11]*x[0]; /* I3/I1*gamma3 */
    const double t7 = JLT_FMA(x[0], t6, t5); /* gamma3*I3/I1*gamma3 + s*s */
    const double t8 = JLT_FMA(p[10], t7, p[9]); /* Theta = m*R^2*I1*(gamma3*I3/I1*gamma3 + s*s) + I1*I3 */
    const double t9 = 1.0/t8; /* 1/Theta */
    const double t10 = cos(x[2]); /* C = cos(psi) */
    const double t11 = x[3]*p[12]; /* s*I1*M */
    const double t12 = t10*t11; /* C*s*I1*M */
    const double t13 = JLT_FNMA(x[0], p[13], t12); /* C*s*I1*M - gamma3*G*J1/R */
    const double t14 = x[3]*p[14]; /* s*G*J3/R */
    const double t15 = x[0]*p[15]; /* gamma3*I3*M */
    const double t16 = JLT_FMA(t10, t15, t14); /* C*gamma3*I3*M + s*G*J3/R */
    const double t17 = t9*t16; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t18 = x[3]*p[8]; /* s*(R - R*I3/I1) */
    const double t19 = t9*t18; /* 1/Theta*s*(R - R*I3/I1) */
    const double t20 = t13*t19; /* (C*s*I1*M - gamma3*G*J1/R)*1/Theta*s*(R - R*I3/I1) */
    const double t21 = t17*t20; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R)*(C*s*I1*M - gamma3*G*J1/R)*1/Theta*s*(R - R*I3/I1) */
    const double t22 = t3*x[0]; /* (v_slip - M/(m*R)*S)*s*m*R/J1*gamma3 */
    const double t23 = -t22; /* -(v_slip - M/(m*R)*S)*s*m*R/J1*gamma3 */
    out[0] = t4;
    out[1] = t21;
    out[2] = t17;
    out[3] = t23;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*x[3]; /* s*s */
    const double t1 = p[6]*t0; /* m*R/J1*s*s */
    const double t2 = cos(x[2]); /* C = cos(psi) */
    const double t3 = p[16]*t2; /* M/J1*C */
    const double t4 = t0*t3; /* s*s*M/J1*C */
    const double t5 = -t4; /* -s*s*M/J1*C */
    const double t6 = sin(x[2]); /* S = sin(psi) */
    const double t7 = JLT_FNMA(p[7], t6, x[1]); /* v_slip - M/(m*R)*S */
    const double t8 = x[3]*t7; /* s*(v_slip - M/(m*R)*S) */
    const double t9 = p[17]*t8; /* 2*m*R/J1*s*(v_slip - M/(m*R)*S) */
    const double t10 = p[11]*x[0]; /* I3/I1*gamma3 */
    const double t11 = JLT_FMA(x[0], t10, t0); /* gamma3*I3/I1*gamma3 + s*s */
    const double t12 = JLT_FMA(p[10], t11, p[9]); /* Theta = m*R^2*I1*(gamma3*I3/I1*gamma3 + s*s) + I1*I3 */
    const double t13 = 1.0/t12; /* 1/Theta */
    const double t14 = x[3]*p[12]; /* s*I1*M */
    const double t15 = t2*t14; /* C*s*I1*M */
    const double t16 = JLT_FNMA(x[0], p[13], t15); /* C*s*I1*M - gamma3*G*J1/R */
    const double t17 = x[3]*t13; /* s*1/Theta */
    const double t18 = p[18]*t17; /* (R*I3*M - R*I3^2*M/I1)*s*1/Theta */
    const double t19 = t16*t18; /* (C*s*I1*M - gamma3*G*J1/R)*(R*I3*M - R*I3^2*M/I1)*s*1/Theta */
    const double t20 = t2*t13; /* C*1/Theta */
    const double t21 = t19*t20; /* (C*s*I1*M - gamma3*G*J1/R)*(R*I3*M - R*I3^2*M/I1)*s*1/Theta*C*1/Theta */
    const double t22 = x[0]*t13; /* gamma3*1/Theta */
    const double t23 = p[20]*t22; /* (4*m*R^3*I3 - 4*m*R^3*I3^2/I1)*gamma3*1/Theta */
    const double t24 = JLT_FMA(t16, t23, p[19]); /* (C*s*I1*M - gamma3*G*J1/R)*(4*m*R^3*I3 - 4*m*R^3*I3^2/I1)*gamma3*1/Theta + G*J1 - I3*G*J1/I1 */
    const double t25 = x[3]*p[14]; /* s*G*J3/R */
    const double t26 = t2*p[15]; /* C*I3*M */
    const double t27 = JLT_FMA(x[0], t26, t25); /* gamma3*C*I3*M + s*G*J3/R */
    const double t28 = t13*t27; /* 1/Theta*(gamma3*C*I3*M + s*G*J3/R) */
    const double t29 = t17*t28; /* s*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R) */
    const double t30 = JLT_FNMA(t24, t29, t21); /* t21 - t24*s*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R) */
    const double t31 = t29*p[21]; /* s*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R)*(R*I3*M - R*I1*M) */
    const double t32 = x[3]*t6; /* s*S */
    const double t33 = t31*t32; /* t31*s*S */
    const double t34 = t6*t22; /* S*gamma3*1/Theta */
    const double t35 = JLT_FNMA(t19, t34, t33); /* t31*s*S - (C*s*I1*M - gamma3*G*J1/R)*(R*I3*M - R*I3^2*M/I1)*s*1/Theta*S*gamma3*1/Theta */
    const double t36 = t13*p[22]; /* 1/Theta*(G*J3 - I3*G*J3/I1) */
    const double t37 = JLT_FMA(t29, p[23], t36); /* s*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R)*(4*m*R^3*I3 - 4*m*R^3*I1) + 1/Theta*(G*J3 - I3*G*J3/I1) */
    const double t38 = t17*t37; /* s*1/Theta*t37 */
    const double t39 = t13*p[8]; /* 1/Theta*(R - R*I3/I1) */
    const double t40 = JLT_FMA(t28, t39, t38); /* 1/Theta*(gamma3*C*I3*M + s*G*J3/R)*1/Theta*(R - R*I3/I1) + s*1/Theta*t37 */
    const double t41 = t16*t40; /* (C*s*I1*M - gamma3*G*J1/R)*t40 */
    const double t42 = JLT_FNMA(t2, t31, t41); /* (C*s*I1*M - gamma3*G*J1/R)*t40 - C*t31 */
    const double t43 = t13*t26; /* 1/Theta*C*I3*M */
    const double t44 = t22*p[24]; /* gamma3*1/Theta*2*m*R^2*I3 */
    const double t45 = JLT_FNMA(t28, t44, t43); /* 1/Theta*C*I3*M - 1/Theta*(gamma3*C*I3*M + s*G*J3/R)*gamma3*1/Theta*2*m*R^2*I3 */
    const double t46 = t34*p[25]; /* S*gamma3*1/Theta*(-I3*M) */
    const double t47 = t13*p[14]; /* 1/Theta*G*J3/R */
    const double t48 = JLT_FNMA(t29, p[26], t47); /* 1/Theta*G*J3/R - s*1/Theta*1/Theta*(gamma3*C*I3*M + s*G*J3/R)*2*m*R^2*I1 */
    const double t49 = t8*p[27]; /* s*(v_slip - M/(m*R)*S)*(-m*R/J1) */
    const double t50 = x[3]*x[0]; /* s*gamma3 */
    const double t51 = p[27]*t50; /* (-m*R/J1)*s*gamma3 */
    const double t52 = t3*t50; /* M/J1*C*s*gamma3 */
    const double t53 = x[0]*p[27]; /* gamma3*(-m*R/J1) */
    const double t54 = t7*t53; /* (v_slip - M/(m*R)*S)*gamma3*(-m*R/J1) */
    out[0] = 0.0;
    out[1] = t1;
    out[2] = t5;
    out[3] = t9;
    out[4] = t30;
    out[5] = 0.0;
    out[6] = t35;
    out[7] = t42;
    out[8] = t45;
    out[9] = 0.0;
    out[10] = t46;
    out[11] = t48;
    out[12] = t49;
    out[13] = t51;
    out[14] = t52;
    out[15] = t54;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*x[3]; /* s*s */
    const double t1 = sin(x[2]); /* S = sin(psi) */
    const double t2 = JLT_FNMA(p[7], t1, x[1]); /* v_slip - M/(m*R)*S */
    const double t3 = p[6]*t2; /* m*R/J1*(v_slip - M/(m*R)*S) */
    const double t4 = t0*t3; /* s*s*m*R/J1*(v_slip - M/(m*R)*S) */
    const double t5 = p[11]*x[0]; /* I3/I1*gamma3 */
    const double t6 = JLT_FMA(x[0], t5, t0); /* gamma3*I3/I1*gamma3 + s*s */
    const double t7 = JLT_FMA(p[10], t6, p[9]); /* Theta = m*R^2*I1*(gamma3*I3/I1*gamma3 + s*s) + I1*I3 */
    const double t8 = 1.0/t7; /* 1/Theta */
    const double t9 = x[3]*p[14]; /* s*G*J3/R */
    const double t10 = cos(x[2]); /* C = cos(psi) */
    const double t11 = x[0]*p[15]; /* gamma3*I3*M */
    const double t12 = JLT_FMA(t10, t11, t9); /* C*gamma3*I3*M + s*G*J3/R */
    const double t13 = t8*t12; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t14 = p[8]*t13; /* (R - R*I3/I1)*1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t15 = x[3]*p[12]; /* s*I1*M */
    const double t16 = t10*t15; /* C*s*I1*M */
    const double t17 = JLT_FNMA(x[0], p[13], t16); /* C*s*I1*M - gamma3*G*J1/R */
    const double t18 = t8*t17; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R) */
    const double t19 = x[3]*t18; /* s*1/Theta*(C*s*I1*M - gamma3*G*J1/R) */
    const double t20 = t14*t19; /* (R - R*I3/I1)*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*s*1/Theta*(C*s*I1*M - gamma3*G*J1/R) */
    const double t21 = x[3]*x[0]; /* s*gamma3 */
    const double t22 = t3*t21; /* m*R/J1*(v_slip - M/(m*R)*S)*s*gamma3 */
    const double t23 = -t22; /* -m*R/J1*(v_slip - M/(m*R)*S)*s*gamma3 */
    const double t24 = t0*p[6]; /* s*s*m*R/J1 */
    const double t25 = t10*p[16]; /* C*M/J1 */
    const double t26 = t0*t25; /* s*s*C*M/J1 */
    const double t27 = -t26; /* -s*s*C*M/J1 */
    const double t28 = x[3]*t2; /* s*(v_slip - M/(m*R)*S) */
    const double t29 = p[17]*t28; /* 2*m*R/J1*s*(v_slip - M/(m*R)*S) */
    const double t30 = t19*p[18]; /* s*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*(R*I3*M - R*I3^2*M/I1) */
    const double t31 = t8*t10; /* 1/Theta*C */
    const double t32 = t30*t31; /* s*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*(R*I3*M - R*I3^2*M/I1)*1/Theta*C */
    const double t33 = t8*t13; /* 1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t34 = x[0]*t33; /* gamma3*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t35 = t19*p[20]; /* s*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*(4*m*R^3*I3 - 4*m*R^3*I3^2/I1) */
    const double t36 = x[3]*t33; /* s*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t37 = JLT_FNMA(t34, t35, t32); /* t32 - gamma3*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*t35 */
    const double t38 = JLT_FNMA(p[19], t36, t37); /* t32 - gamma3*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*t35 - (G*J1 - I3*G*J1/I1)*s*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t39 = t0*p[21]; /* s*s*(R*I3*M - R*I1*M) */
    const double t40 = t1*t39; /* S*s*s*(R*I3*M - R*I1*M) */
    const double t41 = t33*t40; /* 1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*S*s*s*(R*I3*M - R*I1*M) */
    const double t42 = x[0]*t8; /* gamma3*1/Theta */
    const double t43 = t1*t42; /* S*gamma3*1/Theta */
    const double t44 = JLT_FNMA(t30, t43, t41); /* t41 - s*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*(R*I3*M - R*I3^2*M/I1)*S*gamma3*1/Theta */
    const double t45 = t14*t18; /* (R - R*I3/I1)*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*1/Theta*(C*s*I1*M - gamma3*G*J1/R) */
    const double t46 = t8*p[22]; /* 1/Theta*(G*J3 - I3*G*J3/I1) */
    const double t47 = JLT_FMA(t36, p[23], t46); /* s*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*(4*m*R^3*I3 - 4*m*R^3*I1) + 1/Theta*(G*J3 - I3*G*J3/I1) */
    const double t48 = t10*p[21]; /* C*(R*I3*M - R*I1*M) */
    const double t49 = JLT_FNMA(t36, t48, t45); /* t45 - s*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*C*(R*I3*M - R*I1*M) */
    const double t50 = JLT_FMA(t19, t47, t49); /* s*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*t47 + t49 */
    const double t51 = p[15]*t31; /* I3*M*1/Theta*C */
    const double t52 = JLT_FNMA(t34, p[24], t51); /* I3*M*1/Theta*C - gamma3*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*2*m*R^2*I3 */
    const double t53 = t43*p[25]; /* S*gamma3*1/Theta*(-I3*M) */
    const double t54 = t8*p[14]; /* 1/Theta*G*J3/R */
    const double t55 = JLT_FNMA(t36, p[26], t54); /* 1/Theta*G*J3/R - s*1/Theta*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*2*m*R^2*I1 */
    const double t56 = t28*p[27]; /* s*(v_slip - M/(m*R)*S)*(-m*R/J1) */
    const double t57 = t21*p[27]; /* s*gamma3*(-m*R/J1) */
    const double t58 = t21*t25; /* s*gamma3*C*M/J1 */
    const double t59 = t3*x[0]; /* m*R/J1*(v_slip - M/(m*R)*S)*gamma3 */
    const double t60 = -t59; /* -m*R/J1*(v_slip - M/(m*R)*S)*gamma3 */
    out[0] = t4;
    out[1] = t20;
    out[2] = t13;
    out[3] = t23;
    out[4] = 0.0;
    out[5] = t24;
    out[6] = t27;
    out[7] = t29;
    out[8] = t38;
    out[9] = 0.0;
    out[10] = t44;
    out[11] = t50;
    out[12] = t52;
    out[13] = 0.0;
    out[14] = t53;
    out[15] = t55;
    out[16] = t56;
    out[17] = t57;
    out[18] = t58;
    out[19] = t60;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = sin(x[2]); /* S = sin(psi) */
    const double t1 = x[0]*p[11]; /* gamma3*I3/I1 */
    const double t2 = JLT_FMA(x[3], x[3], p[29]); /* s*s + I3/(m*R^2) */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta scaled = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t4 = p[28]/t3; /* I3*M/(m*R^2*I1)/Theta scaled */
    const double t5 = t0*t4; /* S*I3*M/(m*R^2*I1)/Theta scaled */
    const double t6 = JLT_FNMA(t0, p[7], x[1]); /* v_slip - S*M/(m*R) */
    const double t7 = JLT_FMA(p[6], t6, t5); /* m*R/J1*(v_slip - S*M/(m*R)) + S*I3*M/(m*R^2*I1)/Theta scaled */
    const double t8 = x[0]*t7; /* gamma3*(m*R/J1*(v_slip - S*M/(m*R)) + S*I3*M/(m*R^2*I1)/Theta scaled) */
    const double t9 = -t8; /* -t8 */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[30]*x[1]; /* m*I1^2*v_slip */
    const double t1 = x[1]*t0; /* v_slip*m*I1^2*v_slip */
    const double t2 = p[11]*x[0]; /* I3/I1*gamma3 */
    const double t3 = JLT_FMA(x[3], x[3], p[29]); /* s*s + I3/(m*R^2) */
    const double t4 = JLT_FMA(x[0], t2, t3); /* Theta scaled = gamma3*I3/I1*gamma3 + s*s + I3/(m*R^2) */
    const double t5 = cos(x[2]); /* C = cos(psi) */
    const double t6 = x[3]*p[12]; /* s*I1*M */
    const double t7 = t5*t6; /* C*s*I1*M */
    const double t8 = JLT_FNMA(x[0], p[13], t7); /* C*s*I1*M - gamma3*G*J1/R */
    const double t9 = p[31]/t4; /* (I1 - I3)/(m*R^2*I1)/Theta scaled */
    const double t10 = t8*t9; /* (C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)/(m*R^2*I1)/Theta scaled */
    const double t11 = JLT_FMA(t8, t10, t1); /* (C*s*I1*M - gamma3*G*J1/R)*(C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)/(m*R^2*I1)/Theta scaled + v_slip*m*I1^2*v_slip */
    out[0] = t11;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[2]*x[3]; /* I1*s */
    const double t1 = x[0]*p[3]; /* gamma3*I3 */
    const double t2 = JLT_FMA(x[3], t0, p[33]); /* s*I1*s + I1*I3/(m*R^2) */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta scaled = gamma3*gamma3*I3 + s*I1*s + I1*I3/(m*R^2) */
    const double t4 = cos(x[2]); /* C = cos(psi) */
    const double t5 = x[3]*p[12]; /* s*I1*M */
    const double t6 = t4*t5; /* C*s*I1*M */
    const double t7 = JLT_FNMA(x[0], p[13], t6); /* C*s*I1*M - gamma3*G*J1/R */
    const double t8 = t7/t3; /* (C*s*I1*M - gamma3*G*J1/R)/Theta scaled */
    const double t9 = t8*t8; /* (C*s*I1*M - gamma3*G*J1/R)/Theta scaled*(C*s*I1*M - gamma3*G*J1/R)/Theta scaled */
    const double t10 = p[32]*x[0]; /* (-2*I3*(I1 - I3)/(m*R^2))*gamma3 */
    const double t11 = t9*t10; /* t9*(-2*I3*(I1 - I3)/(m*R^2))*gamma3 */
    const double t12 = JLT_FMA(t8, p[34], t11); /* (C*s*I1*M - gamma3*G*J1/R)/Theta scaled*(-2*G*J1*(I1 - I3)/(m*R^3)) + t9*(-2*I3*(I1 - I3)/(m*R^2))*gamma3 */
    const double t13 = p[35]*x[1]; /* 2*m*I1^2*v_slip */
    const double t14 = sin(x[2]); /* S = sin(psi) */
    const double t15 = t8*p[36]; /* (C*s*I1*M - gamma3*G*J1/R)/Theta scaled*2*I1*M*(I1 - I3)/(m*R^2) */
    const double t16 = x[3]*t14; /* s*S */
    const double t17 = t15*t16; /* t15*s*S */
    const double t18 = -t17; /* -t15*s*S */
    const double t19 = t4*t15; /* C*t15 */
    const double t20 = x[3]*p[37]; /* s*2*I1*(I1 - I3)/(m*R^2) */
    const double t21 = JLT_FNMA(t9, t20, t19); /* C*t15 - t9*s*2*I1*(I1 - I3)/(m*R^2) */
    out[0] = t12;
    out[1] = t13;
    out[2] = t18;
    out[3] = t21;
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
    double t5[JLT_JET_ORDER_MAX + 1];
    double u5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double u22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = 0;
    for (unsigned k = 0; k < order; k++) {
        t5[k] = jlt_jet_sine(x2, t5, u5, k);
        t6[k] = x1[k] - p[7]*t5[k];
        t7[k] = x3[k]*p[6];
        t8[k] = jlt_jet_product(t6, t7, k);
        t9[k] = jlt_jet_product(x3, t8, k);
        t13[k] = jlt_jet_product(x3, x3, k);
        t16[k] = p[11]*x0[k];
        t17[k] = jlt_jet_product(x0, t16, k) + t13[k];
        t18[k] = p[10]*t17[k] + (k == 0 ? p[9] : 0);
        t20[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t18, t20, k);
        t22[k] = jlt_jet_cosine(x2, t22, u22, k);
        t23[k] = x3[k]*p[12];
        t24[k] = jlt_jet_product(t22, t23, k);
        t26[k] = t24[k] - x0[k]*p[13];
        t28[k] = x3[k]*p[14];
        t30[k] = x0[k]*p[15];
        t31[k] = jlt_jet_product(t22, t30, k) + t28[k];
        t32[k] = jlt_jet_product(t20, t31, k);
        t33[k] = x3[k]*p[8];
        t34[k] = jlt_jet_product(t20, t33, k);
        t35[k] = jlt_jet_product(t26, t34, k);
        t36[k] = jlt_jet_product(t32, t35, k);
        t37[k] = jlt_jet_product(t8, x0, k);
        t38[k] = -t37[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t9[k]/(k + 1);
        next[1] = x1[k + 1] = t36[k]/(k + 1);
        next[2] = x2[k + 1] = t32[k]/(k + 1);
        next[3] = x3[k + 1] = t38[k]/(k + 1);
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
    .state_count = 4, .param_count = 6, .block_count = 38,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 1, 15, 5, 1, 0, 2, 7, 7 }, { 13, 57, 0, 10, 0, 2, 10, 11 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .jacobian = { jacobian, 16, { 1, 38, 13, 1, 0, 2, 11, 16 }, { 56, 318, 0, 56, 0, 2, 16, 11 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .rhs_jacobian = { rhs_jacobian, 20, { 3, 42, 13, 1, 0, 2, 10, 19 }, { 65, 363, 0, 66, 0, 2, 16, 11 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .divergence = { divergence, 1, { 1, 3, 4, 1, 0, 1, 7, 4 }, { 6, 17, 0, 2, 0, 1, 8, 7 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .integral_values = { integral_values, 1, { 0, 6, 4, 1, 0, 1, 5, 5 }, { 6, 21, 0, 2, 0, 1, 10, 6 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are" },
    .integral_gradients = { integral_gradients, 4, { 1, 13, 5, 1, 0, 2, 7, 5 }, { 16, 73, 0, 10, 0, 2, 13, 9 },
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
