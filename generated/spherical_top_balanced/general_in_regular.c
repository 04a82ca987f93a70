/* Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_balanced, SHA-256 24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33
 *  Command:    ttc generate --effort full --out DIR spherical_top_balanced.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   15    5    1    0    2      7    6   (82)
 *  jacobian            1   38   13    1    0    2     10   13   (432)
 *  rhs_jacobian        3   41   13    1    0    2     10   14   (496)
 *  divergence          1    3    4    1    0    1      7    3   (26)
 *  integral_values     0    6    4    1    0    1      5    4   (30)
 *  integral_gradients  1   13    5    1    0    2      7    5   (101)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are
 *    digits are lost where terms nearly cancel in R - R*I3/I1, R*I3*M - R*I3^2*M/I1, 4*m*R^3*I3 - 4*m*R^3*I3^2/I1,
 *      G*J1 - I3*G*J1/I1, R*I3*M - R*I1*M, G*J3 - I3*G*J3/I1, 4*m*R^3*I3 - 4*m*R^3*I1, gamma3*(I3*M)*C + s*(G*J3/R),
 *      C*s*(I1*M) - (G*J1/R)*gamma3, v_slip - (M/(m*R))*S, d(d(psi)/dtau)/d(gamma3),
 *      a part of d(d(v_slip)/dtau)/d(gamma3), d(d(v_slip)/dtau)/d(gamma3), a part of d(d(v_slip)/dtau)/d(s),
 *      a part of d(d(v_slip)/dtau)/d(psi), d(d(v_slip)/dtau)/d(s), d(d(psi)/dtau)/d(s)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_balanced[];
extern const jlt_claim jlt_claims_spherical_top_balanced[];
extern const jlt_descriptor *const jlt_family_spherical_top_balanced[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_general_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_balanced_general_in_regular;
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
    out[6] = t4;
    const double t5 = params[5]/t0; /* M/(m*R) */
    out[7] = t5;
    const double t6 = params[1]*params[3]; /* R*I3 */
    const double t7 = t6/params[2]; /* R*I3/I1 */
    const double t8 = params[1] - t7; /* R - R*I3/I1 */
    out[8] = t8;
    const double t9 = params[2]*params[3]; /* I1*I3 */
    out[9] = t9;
    const double t10 = params[2]*t2; /* I1*m*R*R */
    out[10] = t10;
    const double t11 = params[3]/params[2]; /* I3/I1 */
    out[11] = t11;
    const double t12 = params[2]*params[5]; /* I1*M */
    out[12] = t12;
    const double t13 = t3*params[4]; /* J1*G */
    const double t14 = t13/params[1]; /* J1*G/R */
    out[13] = t14;
    const double t15 = t2 + params[3]; /* J3 = m*R*R + I3 */
    const double t16 = params[4]*t15; /* G*J3 */
    const double t17 = t16/params[1]; /* G*J3/R */
    out[14] = t17;
    const double t18 = params[5]*params[3]; /* M*I3 */
    out[15] = t18;
    const double t19 = params[5]/t3; /* M/J1 */
    out[16] = t19;
    const double t20 = params[0]*2.0; /* m*2 */
    const double t21 = params[1]*t20; /* R*m*2 */
    const double t22 = t21/t3; /* R*m*2/J1 */
    out[17] = t22;
    const double t23 = params[5]*t6; /* M*R*I3 */
    const double t24 = params[3]*params[3]; /* I3*I3 */
    const double t25 = params[1]*t24; /* R*I3*I3 */
    const double t26 = params[5]*t25; /* M*R*I3*I3 */
    const double t27 = t26/params[2]; /* M*R*I3*I3/I1 */
    const double t28 = t23 - t27; /* M*R*I3 - M*R*I3*I3/I1 */
    out[18] = t28;
    const double t29 = params[3]*params[4]; /* I3*G */
    const double t30 = t3*t29; /* J1*I3*G */
    const double t31 = t30/params[2]; /* J1*I3*G/I1 */
    const double t32 = t13 - t31; /* J1*G - J1*I3*G/I1 */
    out[19] = t32;
    const double t33 = params[1]*t1; /* R*R*R */
    const double t34 = params[0]*t33; /* m*R*R*R */
    const double t35 = params[3]*t34; /* I3*m*R*R*R */
    const double t36 = t35*4.0; /* I3*m*R*R*R*4 */
    const double t37 = t24*t34; /* I3*I3*m*R*R*R */
    const double t38 = t37/params[2]; /* I3*I3*m*R*R*R/I1 */
    const double t39 = 4.0*t38; /* 4*I3*I3*m*R*R*R/I1 */
    const double t40 = t36 - t39; /* I3*m*R*R*R*4 - 4*I3*I3*m*R*R*R/I1 */
    out[20] = t40;
    const double t41 = params[1]*params[2]; /* R*I1 */
    const double t42 = params[5]*t41; /* M*R*I1 */
    const double t43 = t23 - t42; /* M*R*I3 - M*R*I1 */
    out[21] = t43;
    const double t44 = t15*t29; /* J3*I3*G */
    const double t45 = t44/params[2]; /* J3*I3*G/I1 */
    const double t46 = t16 - t45; /* G*J3 - J3*I3*G/I1 */
    out[22] = t46;
    const double t47 = params[2]*t34; /* I1*m*R*R*R */
    const double t48 = 4.0*t47; /* 4*I1*m*R*R*R */
    const double t49 = t36 - t48; /* I3*m*R*R*R*4 - 4*I1*m*R*R*R */
    out[23] = t49;
    const double t50 = t1*t20; /* R*R*m*2 */
    const double t51 = params[3]*t50; /* I3*R*R*m*2 */
    out[24] = t51;
    const double t52 = -t18; /* -M*I3 */
    out[25] = t52;
    const double t53 = params[2]*t50; /* I1*R*R*m*2 */
    out[26] = t53;
    const double t54 = -t4; /* -m*R/J1 */
    out[27] = t54;
    const double t55 = t18/t10; /* M*I3/(I1*m*R*R) */
    out[28] = t55;
    const double t56 = params[3]/t2; /* I3/(m*R*R) */
    out[29] = t56;
    const double t57 = params[2]*params[2]; /* I1*I1 */
    const double t58 = params[0]*t57; /* m*I1*I1 */
    out[30] = t58;
    const double t59 = params[2] - params[3]; /* I1 - I3 */
    const double t60 = t59/t10; /* (I1 - I3)/(I1*m*R*R) */
    out[31] = t60;
    const double t61 = params[3]*(-2.0); /* I3*(-2) */
    const double t62 = t59*t61; /* (I1 - I3)*I3*(-2) */
    const double t63 = t62/t2; /* (I1 - I3)*I3*(-2)/(m*R*R) */
    out[32] = t63;
    const double t64 = t9/t2; /* I1*I3/(m*R*R) */
    out[33] = t64;
    const double t65 = params[4]*(-2.0); /* G*(-2) */
    const double t66 = t3*t65; /* J1*G*(-2) */
    const double t67 = t59*t66; /* (I1 - I3)*J1*G*(-2) */
    const double t68 = t67/t34; /* (I1 - I3)*J1*G*(-2)/(m*R*R*R) */
    out[34] = t68;
    const double t69 = t20*t57; /* m*2*I1*I1 */
    out[35] = t69;
    const double t70 = params[2]*2.0; /* I1*2 */
    const double t71 = params[5]*t70; /* M*I1*2 */
    const double t72 = t59*t71; /* (I1 - I3)*M*I1*2 */
    const double t73 = t72/t2; /* (I1 - I3)*M*I1*2/(m*R*R) */
    out[36] = t73;
    const double t74 = t59*t70; /* (I1 - I3)*I1*2 */
    const double t75 = t74/t2; /* (I1 - I3)*I1*2/(m*R*R) */
    out[37] = t75;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*x[3]; /* s*s */
    const double t1 = p[11]*x[0]; /* I3/I1*gamma3 */
    const double t2 = JLT_FMA(x[0], t1, t0); /* gamma3*I3/I1*gamma3 + s*s */
    const double t3 = JLT_FMA(p[10], t2, p[9]); /* Theta = m*R^2*I1*(gamma3*I3/I1*gamma3 + s*s) + I1*I3 */
    const double t4 = 1.0/t3; /* 1/Theta */
    const double t5 = sin(x[2]); /* S = sin(psi) */
    const double t6 = JLT_FNMA(p[7], t5, x[1]); /* v_slip - M/(m*R)*S */
    const double t7 = cos(x[2]); /* C = cos(psi) */
    const double t8 = x[3]*p[12]; /* s*I1*M */
    const double t9 = t7*t8; /* C*s*I1*M */
    const double t10 = JLT_FNMA(x[0], p[13], t9); /* C*s*I1*M - gamma3*G*J1/R */
    const double t11 = x[3]*p[6]; /* s*m*R/J1 */
    const double t12 = t6*t11; /* (v_slip - M/(m*R)*S)*s*m*R/J1 */
    const double t13 = x[3]*t12; /* s*(v_slip - M/(m*R)*S)*s*m*R/J1 */
    out[0] = t13;
    const double t14 = x[0]*t12; /* gamma3*(v_slip - M/(m*R)*S)*s*m*R/J1 */
    const double t15 = -t14; /* -gamma3*(v_slip - M/(m*R)*S)*s*m*R/J1 */
    out[3] = t15;
    const double t16 = x[3]*p[14]; /* s*G*J3/R */
    const double t17 = x[0]*p[15]; /* gamma3*I3*M */
    const double t18 = JLT_FMA(t7, t17, t16); /* C*gamma3*I3*M + s*G*J3/R */
    const double t19 = t4*t18; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    out[2] = t19;
    const double t20 = x[3]*p[8]; /* s*(R - R*I3/I1) */
    const double t21 = t4*t20; /* 1/Theta*s*(R - R*I3/I1) */
    const double t22 = t10*t21; /* (C*s*I1*M - gamma3*G*J1/R)*1/Theta*s*(R - R*I3/I1) */
    const double t23 = t19*t22; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R)*(C*s*I1*M - gamma3*G*J1/R)*1/Theta*s*(R - R*I3/I1) */
    out[1] = t23;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[5] = 0.0;
    out[9] = 0.0;
    const double t0 = x[3]*x[3]; /* s*s */
    const double t1 = p[6]*t0; /* m*R/J1*s*s */
    out[1] = t1;
    const double t2 = p[11]*x[0]; /* I3/I1*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t0); /* gamma3*I3/I1*gamma3 + s*s */
    const double t4 = JLT_FMA(p[10], t3, p[9]); /* Theta = m*R^2*I1*(gamma3*I3/I1*gamma3 + s*s) + I1*I3 */
    const double t5 = 1.0/t4; /* 1/Theta */
    const double t6 = cos(x[2]); /* C = cos(psi) */
    const double t7 = x[3]*p[14]; /* s*G*J3/R */
    const double t8 = x[0]*p[15]; /* gamma3*I3*M */
    const double t9 = JLT_FMA(t6, t8, t7); /* C*gamma3*I3*M + s*G*J3/R */
    const double t10 = t5*t9; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    const double t11 = x[3]*p[12]; /* s*I1*M */
    const double t12 = t6*t11; /* C*s*I1*M */
    const double t13 = JLT_FNMA(x[0], p[13], t12); /* C*s*I1*M - gamma3*G*J1/R */
    const double t14 = x[3]*t5; /* s*1/Theta */
    const double t15 = t10*t14; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R)*s*1/Theta */
    const double t16 = p[8]*t5; /* (R - R*I3/I1)*1/Theta */
    const double t17 = t10*t16; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R)*(R - R*I3/I1)*1/Theta */
    const double t18 = p[22]*t5; /* (G*J3 - I3*G*J3/I1)*1/Theta */
    const double t19 = JLT_FMA(p[23], t15, t18); /* (4*m*R^3*I3 - 4*m*R^3*I1)*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*s*1/Theta + (G*J3 - I3*G*J3/I1)*1/Theta */
    const double t20 = JLT_FMA(t14, t19, t17); /* s*1/Theta*t19 + 1/Theta*(C*gamma3*I3*M + s*G*J3/R)*(R - R*I3/I1)*1/Theta */
    const double t21 = p[18]*t14; /* (R*I3*M - R*I3^2*M/I1)*s*1/Theta */
    const double t22 = t13*t21; /* (C*s*I1*M - gamma3*G*J1/R)*(R*I3*M - R*I3^2*M/I1)*s*1/Theta */
    const double t23 = t13*t20; /* (C*s*I1*M - gamma3*G*J1/R)*t20 */
    const double t24 = sin(x[2]); /* S = sin(psi) */
    const double t25 = x[0]*t5; /* gamma3*1/Theta */
    const double t26 = p[16]*t6; /* M/J1*C */
    const double t27 = t0*t26; /* s*s*M/J1*C */
    const double t28 = -t27; /* -s*s*M/J1*C */
    out[2] = t28;
    const double t29 = JLT_FNMA(p[7], t24, x[1]); /* v_slip - M/(m*R)*S */
    const double t30 = t5*t6; /* 1/Theta*C */
    const double t31 = p[14]*t5; /* G*J3/R*1/Theta */
    const double t32 = JLT_FNMA(p[26], t15, t31); /* G*J3/R*1/Theta - 2*m*R^2*I1*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*s*1/Theta */
    out[11] = t32;
    const double t33 = p[20]*t25; /* (4*m*R^3*I3 - 4*m*R^3*I3^2/I1)*gamma3*1/Theta */
    const double t34 = JLT_FMA(t13, t33, p[19]); /* (C*s*I1*M - gamma3*G*J1/R)*(4*m*R^3*I3 - 4*m*R^3*I3^2/I1)*gamma3*1/Theta + G*J1 - I3*G*J1/I1 */
    const double t35 = p[21]*t15; /* (R*I3*M - R*I1*M)*1/Theta*(C*gamma3*I3*M + s*G*J3/R)*s*1/Theta */
    const double t36 = JLT_FNMA(t6, t35, t23); /* (C*s*I1*M - gamma3*G*J1/R)*t20 - C*t35 */
    out[7] = t36;
    const double t37 = x[3]*t24; /* s*S */
    const double t38 = t35*t37; /* t35*s*S */
    const double t39 = t24*t25; /* S*gamma3*1/Theta */
    const double t40 = JLT_FNMA(t22, t39, t38); /* t35*s*S - (C*s*I1*M - gamma3*G*J1/R)*(R*I3*M - R*I3^2*M/I1)*s*1/Theta*S*gamma3*1/Theta */
    out[6] = t40;
    const double t41 = p[25]*t39; /* (-I3*M)*S*gamma3*1/Theta */
    out[10] = t41;
    const double t42 = t22*t30; /* (C*s*I1*M - gamma3*G*J1/R)*(R*I3*M - R*I3^2*M/I1)*s*1/Theta*1/Theta*C */
    const double t43 = JLT_FNMA(t15, t34, t42); /* t42 - 1/Theta*(C*gamma3*I3*M + s*G*J3/R)*s*1/Theta*t34 */
    out[4] = t43;
    const double t44 = p[15]*t30; /* I3*M*1/Theta*C */
    const double t45 = p[24]*t25; /* 2*m*R^2*I3*gamma3*1/Theta */
    const double t46 = JLT_FNMA(t10, t45, t44); /* I3*M*1/Theta*C - 1/Theta*(C*gamma3*I3*M + s*G*J3/R)*2*m*R^2*I3*gamma3*1/Theta */
    out[8] = t46;
    const double t47 = x[3]*t29; /* s*(v_slip - M/(m*R)*S) */
    const double t48 = p[17]*t47; /* 2*m*R/J1*s*(v_slip - M/(m*R)*S) */
    out[3] = t48;
    const double t49 = p[27]*t47; /* (-m*R/J1)*s*(v_slip - M/(m*R)*S) */
    out[12] = t49;
    const double t50 = x[3]*x[0]; /* s*gamma3 */
    const double t51 = t26*t50; /* M/J1*C*s*gamma3 */
    out[14] = t51;
    const double t52 = p[27]*t50; /* (-m*R/J1)*s*gamma3 */
    out[13] = t52;
    const double t53 = x[0]*p[27]; /* gamma3*(-m*R/J1) */
    const double t54 = t29*t53; /* (v_slip - M/(m*R)*S)*gamma3*(-m*R/J1) */
    out[15] = t54;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[4] = 0.0;
    out[9] = 0.0;
    out[13] = 0.0;
    const double t0 = x[3]*x[3]; /* s*s */
    const double t1 = x[0]*p[11]; /* gamma3*I3/I1 */
    const double t2 = JLT_FMA(x[0], t1, t0); /* gamma3*gamma3*I3/I1 + s*s */
    const double t3 = JLT_FMA(p[10], t2, p[9]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + s*s) + I1*I3 */
    const double t4 = 1.0/t3; /* 1/Theta */
    const double t5 = cos(x[2]); /* C = cos(psi) */
    const double t6 = x[3]*p[14]; /* s*G*J3/R */
    const double t7 = p[15]*t5; /* I3*M*C */
    const double t8 = JLT_FMA(x[0], t7, t6); /* gamma3*I3*M*C + s*G*J3/R */
    const double t9 = t4*t8; /* 1/Theta*(gamma3*I3*M*C + s*G*J3/R) */
    out[2] = t9;
    const double t10 = t4*t7; /* 1/Theta*I3*M*C */
    const double t11 = x[3]*p[12]; /* s*I1*M */
    const double t12 = t5*t11; /* C*s*I1*M */
    const double t13 = JLT_FNMA(p[13], x[0], t12); /* C*s*I1*M - G*J1/R*gamma3 */
    const double t14 = x[3]*t4; /* s*1/Theta */
    const double t15 = sin(x[2]); /* S = sin(psi) */
    const double t16 = p[18]*t4; /* (R*I3*M - R*I3^2*M/I1)*1/Theta */
    const double t17 = t5*t16; /* C*(R*I3*M - R*I3^2*M/I1)*1/Theta */
    const double t18 = x[0]*t4; /* gamma3*1/Theta */
    const double t19 = t9*t14; /* 1/Theta*(gamma3*I3*M*C + s*G*J3/R)*s*1/Theta */
    const double t20 = t13*t14; /* (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta */
    const double t21 = JLT_FNMA(p[7], t15, x[1]); /* v_slip - M/(m*R)*S */
    const double t22 = p[8]*t9; /* (R - R*I3/I1)*1/Theta*(gamma3*I3*M*C + s*G*J3/R) */
    const double t23 = t9*t18; /* 1/Theta*(gamma3*I3*M*C + s*G*J3/R)*gamma3*1/Theta */
    const double t24 = JLT_FNMA(p[24], t23, t10); /* 1/Theta*I3*M*C - 2*m*R^2*I3*1/Theta*(gamma3*I3*M*C + s*G*J3/R)*gamma3*1/Theta */
    out[12] = t24;
    const double t25 = JLT_FNMA(p[20], t23, t17); /* C*(R*I3*M - R*I3^2*M/I1)*1/Theta - (4*m*R^3*I3 - 4*m*R^3*I3^2/I1)*1/Theta*(gamma3*I3*M*C + s*G*J3/R)*gamma3*1/Theta */
    const double t26 = t13*t22; /* (C*s*I1*M - G*J1/R*gamma3)*(R - R*I3/I1)*1/Theta*(gamma3*I3*M*C + s*G*J3/R) */
    const double t27 = t20*t22; /* (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta*(R - R*I3/I1)*1/Theta*(gamma3*I3*M*C + s*G*J3/R) */
    out[1] = t27;
    const double t28 = t20*t25; /* (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta*t25 */
    const double t29 = JLT_FNMA(p[19], t19, t28); /* (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta*t25 - (G*J1 - I3*G*J1/I1)*1/Theta*(gamma3*I3*M*C + s*G*J3/R)*s*1/Theta */
    out[8] = t29;
    const double t30 = JLT_FMA(p[22], t20, t26); /* (G*J3 - I3*G*J3/I1)*(C*s*I1*M - G*J1/R*gamma3)*s*1/Theta + t26 */
    const double t31 = p[21]*t19; /* (R*I3*M - R*I1*M)*1/Theta*(gamma3*I3*M*C + s*G*J3/R)*s*1/Theta */
    const double t32 = p[6]*x[0]; /* m*R/J1*gamma3 */
    const double t33 = x[3]*t21; /* s*(v_slip - M/(m*R)*S) */
    const double t34 = p[17]*t33; /* 2*m*R/J1*s*(v_slip - M/(m*R)*S) */
    out[7] = t34;
    const double t35 = p[27]*t33; /* (-m*R/J1)*s*(v_slip - M/(m*R)*S) */
    out[16] = t35;
    const double t36 = t32*t33; /* m*R/J1*gamma3*s*(v_slip - M/(m*R)*S) */
    const double t37 = -t36; /* -m*R/J1*gamma3*s*(v_slip - M/(m*R)*S) */
    out[3] = t37;
    const double t38 = t21*t32; /* (v_slip - M/(m*R)*S)*m*R/J1*gamma3 */
    const double t39 = -t38; /* -(v_slip - M/(m*R)*S)*m*R/J1*gamma3 */
    out[19] = t39;
    const double t40 = p[16]*t5; /* M/J1*C */
    const double t41 = t5*t31; /* C*t31 */
    const double t42 = x[3]*t31; /* s*t31 */
    const double t43 = p[18]*t18; /* (R*I3*M - R*I3^2*M/I1)*gamma3*1/Theta */
    const double t44 = JLT_FNMA(t20, t43, t42); /* s*t31 - (C*s*I1*M - G*J1/R*gamma3)*s*1/Theta*(R*I3*M - R*I3^2*M/I1)*gamma3*1/Theta */
    const double t45 = t15*t44; /* S*t44 */
    out[10] = t45;
    const double t46 = p[23]*t20; /* (4*m*R^3*I3 - 4*m*R^3*I1)*(C*s*I1*M - G*J1/R*gamma3)*s*1/Theta */
    const double t47 = JLT_FMS(t19, t46, t41); /* 1/Theta*(gamma3*I3*M*C + s*G*J3/R)*s*1/Theta*t46 - C*t31 */
    const double t48 = JLT_FMA(t4, t30, t47); /* 1/Theta*t30 + 1/Theta*(gamma3*I3*M*C + s*G*J3/R)*s*1/Theta*t46 - C*t31 */
    out[11] = t48;
    const double t49 = p[25]*t18; /* (-I3*M)*gamma3*1/Theta */
    const double t50 = t15*t49; /* S*(-I3*M)*gamma3*1/Theta */
    out[14] = t50;
    const double t51 = p[14]*t4; /* G*J3/R*1/Theta */
    const double t52 = JLT_FNMA(p[26], t19, t51); /* G*J3/R*1/Theta - 2*m*R^2*I1*1/Theta*(gamma3*I3*M*C + s*G*J3/R)*s*1/Theta */
    out[15] = t52;
    const double t53 = p[6]*t0; /* m*R/J1*s*s */
    out[5] = t53;
    const double t54 = t21*t53; /* (v_slip - M/(m*R)*S)*m*R/J1*s*s */
    out[0] = t54;
    const double t55 = t0*t40; /* s*s*M/J1*C */
    const double t56 = -t55; /* -s*s*M/J1*C */
    out[6] = t56;
    const double t57 = x[3]*x[0]; /* s*gamma3 */
    const double t58 = t40*t57; /* M/J1*C*s*gamma3 */
    out[18] = t58;
    const double t59 = p[27]*t57; /* (-m*R/J1)*s*gamma3 */
    out[17] = t59;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*p[11]; /* gamma3*I3/I1 */
    const double t1 = JLT_FMA(x[3], x[3], p[29]); /* s*s + I3/(m*R^2) */
    const double t2 = JLT_FMA(x[0], t0, t1); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t3 = p[28]/t2; /* I3*M/(m*R^2*I1)/(Theta/(m*R^2*I1)) */
    const double t4 = sin(x[2]); /* S = sin(psi) */
    const double t5 = t3*t4; /* I3*M/(m*R^2*I1)/(Theta/(m*R^2*I1))*S */
    const double t6 = JLT_FNMA(p[7], t4, x[1]); /* v_slip - M/(m*R)*S */
    const double t7 = JLT_FMA(p[6], t6, t5); /* m*R/J1*(v_slip - M/(m*R)*S) + I3*M/(m*R^2*I1)/(Theta/(m*R^2*I1))*S */
    const double t8 = x[0]*t7; /* gamma3*t7 */
    const double t9 = -t8; /* -gamma3*t7 */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[11]*x[0]; /* I3/I1*gamma3 */
    const double t1 = JLT_FMA(x[3], x[3], p[29]); /* s*s + I3/(m*R^2) */
    const double t2 = JLT_FMA(x[0], t0, t1); /* Theta/(m*R^2*I1) = gamma3*I3/I1*gamma3 + s*s + I3/(m*R^2) */
    const double t3 = p[31]/t2; /* (I1 - I3)/(m*R^2*I1)/(Theta/(m*R^2*I1)) */
    const double t4 = cos(x[2]); /* C = cos(psi) */
    const double t5 = x[3]*p[12]; /* s*I1*M */
    const double t6 = t4*t5; /* C*s*I1*M */
    const double t7 = JLT_FNMA(x[0], p[13], t6); /* C*s*I1*M - gamma3*G*J1/R */
    const double t8 = t3*t7; /* (I1 - I3)/(m*R^2*I1)/(Theta/(m*R^2*I1))*(C*s*I1*M - gamma3*G*J1/R) */
    const double t9 = p[30]*x[1]; /* m*I1^2*v_slip */
    const double t10 = x[1]*t9; /* v_slip*m*I1^2*v_slip */
    const double t11 = JLT_FMA(t7, t8, t10); /* (C*s*I1*M - gamma3*G*J1/R)*t8 + v_slip*m*I1^2*v_slip */
    out[0] = t11;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[2]*x[3]; /* I1*s */
    const double t1 = x[0]*p[3]; /* gamma3*I3 */
    const double t2 = JLT_FMA(x[3], t0, p[33]); /* s*I1*s + I1*I3/(m*R^2) */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta/(m*R^2) = gamma3*gamma3*I3 + s*I1*s + I1*I3/(m*R^2) */
    const double t4 = cos(x[2]); /* C = cos(psi) */
    const double t5 = x[3]*p[12]; /* s*I1*M */
    const double t6 = t4*t5; /* C*s*I1*M */
    const double t7 = JLT_FNMA(x[0], p[13], t6); /* C*s*I1*M - gamma3*G*J1/R */
    const double t8 = t7/t3; /* (C*s*I1*M - gamma3*G*J1/R)/(Theta/(m*R^2)) */
    const double t9 = t8*t8; /* (C*s*I1*M - gamma3*G*J1/R)/(Theta/(m*R^2))*(C*s*I1*M - gamma3*G*J1/R)/(Theta/(m*R^2)) */
    const double t10 = p[32]*x[0]; /* (-2*I3*(I1 - I3)/(m*R^2))*gamma3 */
    const double t11 = t9*t10; /* t9*(-2*I3*(I1 - I3)/(m*R^2))*gamma3 */
    const double t12 = JLT_FMA(t8, p[34], t11); /* (C*s*I1*M - gamma3*G*J1/R)/(Theta/(m*R^2))*(-2*G*J1*(I1 - I3)/(m*R^3)) + t9*(-2*I3*(I1 - I3)/(m*R^2))*gamma3 */
    out[0] = t12;
    const double t13 = p[35]*x[1]; /* 2*m*I1^2*v_slip */
    out[1] = t13;
    const double t14 = sin(x[2]); /* S = sin(psi) */
    const double t15 = t8*p[36]; /* (C*s*I1*M - gamma3*G*J1/R)/(Theta/(m*R^2))*2*I1*M*(I1 - I3)/(m*R^2) */
    const double t16 = x[3]*t14; /* s*S */
    const double t17 = t15*t16; /* t15*s*S */
    const double t18 = -t17; /* -t15*s*S */
    out[2] = t18;
    const double t19 = t4*t15; /* C*t15 */
    const double t20 = x[3]*p[37]; /* s*2*I1*(I1 - I3)/(m*R^2) */
    const double t21 = JLT_FNMA(t9, t20, t19); /* C*t15 - t9*s*2*I1*(I1 - I3)/(m*R^2) */
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
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double u20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double u22[JLT_JET_ORDER_MAX + 1];
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = 0;
    for (unsigned k = 0; k < order; k++) {
        t15[k] = jlt_jet_product(x3, x3, k);
        t16[k] = p[11]*x0[k];
        t17[k] = jlt_jet_product(x0, t16, k) + t15[k];
        t18[k] = p[10]*t17[k] + (k == 0 ? p[9] : 0);
        t19[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t18, t19, k);
        t20[k] = jlt_jet_sine(x2, t20, u20, k);
        t21[k] = x1[k] - p[7]*t20[k];
        t22[k] = jlt_jet_cosine(x2, t22, u22, k);
        t23[k] = x3[k]*p[12];
        t24[k] = jlt_jet_product(t22, t23, k);
        t25[k] = t24[k] - x0[k]*p[13];
        t26[k] = x3[k]*p[6];
        t27[k] = jlt_jet_product(t21, t26, k);
        t28[k] = jlt_jet_product(x3, t27, k);
        t29[k] = jlt_jet_product(x0, t27, k);
        t30[k] = -t29[k];
        t31[k] = x3[k]*p[14];
        t32[k] = x0[k]*p[15];
        t33[k] = jlt_jet_product(t22, t32, k) + t31[k];
        t34[k] = jlt_jet_product(t19, t33, k);
        t35[k] = x3[k]*p[8];
        t36[k] = jlt_jet_product(t19, t35, k);
        t37[k] = jlt_jet_product(t25, t36, k);
        t38[k] = jlt_jet_product(t34, t37, k);
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t28[k]/(k + 1);
        next[1] = x1[k + 1] = t38[k]/(k + 1);
        next[2] = x2[k + 1] = t34[k]/(k + 1);
        next[3] = x3[k + 1] = t30[k]/(k + 1);
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

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[3] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[3]*x[3]; /* s*s */
    const double t3 = t1 + t2; /* -1 + gamma3*gamma3 + s*s */
    out[0] = t3;
}

static void root_relation_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = 2.0*x[0]; /* 2*gamma3 */
    out[0] = t0;
    out[1] = 0.0;
    out[2] = 0.0;
    const double t1 = 2.0*x[3]; /* 2*s */
    out[3] = t1;
}

/* The reduction half, to the table spherical_top_plane, SHA-256
 * ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6. */
static void way0_coordinates(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = 1.0;
    out[3] = 1.0;
    out[2] = x[2];
}

static void way0_params(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[2]*params[2]; /* I1*I1 */
    const double t1 = params[0]*t0; /* m*I1*I1 */
    const double t2 = x[1]*x[1]; /* v_slip*v_slip */
    const double t3 = t1*t2; /* m*I1*I1*v_slip*v_slip */
    const double t4 = params[2]*params[3]; /* I1*I3 */
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    const double t7 = x[3]*x[3]; /* s*s */
    const double t8 = params[2]*t7; /* I1*s*s */
    const double t9 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t10 = params[3]*t9; /* I3*gamma3*gamma3 */
    const double t11 = t8 + t10; /* I1*s*s + I3*gamma3*gamma3 */
    const double t12 = t6*t11; /* m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t13 = t4 + t12; /* Theta = I1*I3 + m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t14 = params[2]*params[5]; /* I1*M */
    const double t15 = x[3]*t14; /* s*I1*M */
    const double t16 = cos(x[2]); /* C = cos(psi) */
    const double t17 = t15*t16; /* s*I1*M*C */
    const double t18 = params[4]*x[0]; /* G*gamma3 */
    const double t19 = params[2] + t6; /* J1 = I1 + m*R*R */
    const double t20 = t18*t19; /* G*gamma3*J1 */
    const double t21 = t20/params[1]; /* G*gamma3*J1/R */
    const double t22 = t17 - t21; /* s*I1*M*C - G*gamma3*J1/R */
    const double t23 = t22*t22; /* (s*I1*M*C - G*gamma3*J1/R)*(s*I1*M*C - G*gamma3*J1/R) */
    const double t24 = params[2] - params[3]; /* I1 - I3 */
    const double t25 = t23*t24; /* (s*I1*M*C - G*gamma3*J1/R)*(s*I1*M*C - G*gamma3*J1/R)*(I1 - I3) */
    const double t26 = t25/t13; /* t25/Theta */
    const double t27 = t3 + t26; /* m*I1*I1*v_slip*v_slip + t25/Theta */
    out[6] = t27;
}

static const jlt_way_condition way0_conditions[] = {
    { "v_slip > 0", 0 },
};

static void way0_condition_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[1];
}

static void way0_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    const double t0 = params[2]*params[2]; /* I1*I1 */
    const double t1 = params[0]*t0; /* m*I1*I1 */
    const double t2 = params[2]*params[3]; /* I1*I3 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    out[3] = x[2];
    const double t5 = x[2]*x[2]; /* s*s */
    const double t6 = params[2]*t5; /* I1*s*s */
    const double t7 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t8 = params[3]*t7; /* I3*gamma3*gamma3 */
    const double t9 = t6 + t8; /* I1*s*s + I3*gamma3*gamma3 */
    const double t10 = t4*t9; /* m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t11 = t2 + t10; /* Theta = I1*I3 + m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t12 = params[2]*params[5]; /* I1*M */
    const double t13 = x[2]*t12; /* s*I1*M */
    out[2] = x[1];
    const double t14 = cos(x[1]); /* C = cos(psi) */
    const double t15 = t13*t14; /* s*I1*M*C */
    const double t16 = x[0]*params[4]; /* gamma3*G */
    const double t17 = params[2] + t4; /* J1 = I1 + m*R*R */
    const double t18 = t16*t17; /* gamma3*G*J1 */
    const double t19 = t18/params[1]; /* gamma3*G*J1/R */
    const double t20 = t15 - t19; /* s*I1*M*C - gamma3*G*J1/R */
    const double t21 = t20*t20; /* (s*I1*M*C - gamma3*G*J1/R)*(s*I1*M*C - gamma3*G*J1/R) */
    const double t22 = params[2] - params[3]; /* I1 - I3 */
    const double t23 = t21*t22; /* (s*I1*M*C - gamma3*G*J1/R)*(s*I1*M*C - gamma3*G*J1/R)*(I1 - I3) */
    const double t24 = t23/t11; /* t23/Theta */
    const double t25 = params[6] - t24; /* F0 - t23/Theta */
    const double t26 = t25/t1; /* (F0 - t23/Theta)/(m*I1*I1) */
    const double t27 = sqrt(t26); /* v_slip = sqrt((F0 - t23/Theta)/(m*I1*I1)) */
    out[1] = t27;
}

static const unsigned char way0_is_angle[] = { 0, 0 };

static const unsigned char way0_is_root[] = { 0, 0, 0, 0, 0, 0, 0 };

static const unsigned char way0_sources[] = { 0, 0, 0, 0, 0, 0, 2 };

static const jlt_way ways[] = {
    { .name = "half", .kind = "reduction", .model = "spherical_top_plane", .file = "spherical_top_plane.tt",
      .sha256 = "ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6",
      .time = "regular", .claim = 7,
      .state_count = 3, .param_count = 7, .coordinate_count = 2,
      .is_angle = way0_is_angle,
      .coordinates = way0_coordinates,
      .back = way0_back,
      .is_root = way0_is_root, .sources = way0_sources,
      .params = way0_params,
      .condition_count = 1, .conditions = way0_conditions,
      .condition_values = way0_condition_values,
    },
};

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_slip", "m/s", "velocity of the contact point along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "psi", "rad", "angle of the horizontal momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 2.0*0x1.921fb54442d18p+1 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (2.0 / 5.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 4.0), 0.0 },
    { "G", "kg*m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-3.0 / 10.0), 0.0 },
    { "M", "kg*m^2/s", "horizontal angular momentum about the contact point", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
};

static const jlt_named integrals[] = {
    { "F0", "" },
};

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_general_in_regular = {
    .model = "spherical_top_balanced",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_balanced, .family = jlt_family_spherical_top_balanced, .claims = jlt_claims_spherical_top_balanced,
    .scales = 1,
    .state_count = 4, .param_count = 6, .prepared_count = 38,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 1, 15, 5, 1, 0, 2, 7, 6 }, { 13, 57, 0, 10, 0, 2, 10, 11 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; digits are lost where terms nearly cancel in R - R*I3/I1, v_slip - (M/(m*R))*S, C*s*(I1*M) - gamma3*(G*J1/R), C*gamma3*(I3*M) + s*(G*J3/R)" },
    .jacobian = { jacobian, 16, { 1, 38, 13, 1, 0, 2, 10, 13 }, { 56, 318, 0, 56, 0, 2, 16, 11 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; digits are lost where terms nearly cancel in R*I3*M - R*I3^2*M/I1, G*J1 - I3*G*J1/I1, 4*m*R^3*I3 - 4*m*R^3*I3^2/I1, R*I3*M - R*I1*M, R - R*I3/I1, G*J3 - I3*G*J3/I1, 4*m*R^3*I3 - 4*m*R^3*I1, C*gamma3*(I3*M) + s*(G*J3/R), C*s*(I1*M) - gamma3*(G*J1/R), a part of d(d(v_slip)/dtau)/d(s), a part of d(d(v_slip)/dtau)/d(s), v_slip - (M/(m*R))*S, d(d(psi)/dtau)/d(s), a part of d(d(v_slip)/dtau)/d(gamma3), d(d(v_slip)/dtau)/d(s), d(d(v_slip)/dtau)/d(psi), d(d(v_slip)/dtau)/d(gamma3), d(d(psi)/dtau)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 3, 41, 13, 1, 0, 2, 10, 14 }, { 65, 363, 0, 66, 0, 2, 16, 11 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; digits are lost where terms nearly cancel in R - R*I3/I1, R*I3*M - R*I3^2*M/I1, 4*m*R^3*I3 - 4*m*R^3*I3^2/I1, G*J1 - I3*G*J1/I1, R*I3*M - R*I1*M, G*J3 - I3*G*J3/I1, 4*m*R^3*I3 - 4*m*R^3*I1, gamma3*(I3*M)*C + s*(G*J3/R), C*s*(I1*M) - (G*J1/R)*gamma3, v_slip - (M/(m*R))*S, d(d(psi)/dtau)/d(gamma3), a part of d(d(v_slip)/dtau)/d(gamma3), d(d(v_slip)/dtau)/d(gamma3), a part of d(d(v_slip)/dtau)/d(s), a part of d(d(v_slip)/dtau)/d(psi), d(d(v_slip)/dtau)/d(s), d(d(psi)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 1, 3, 4, 1, 0, 1, 7, 3 }, { 6, 17, 0, 2, 0, 1, 8, 7 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; digits are lost where terms nearly cancel in v_slip - (M/(m*R))*S, (m*R/J1)*(v_slip - (M/(m*R))*S) + ((I3*M/(m*R^2*I1))/Theta/(m*R^2*I1))*S" },
    .integral_values = { integral_values, 1, { 0, 6, 4, 1, 0, 1, 5, 4 }, { 6, 21, 0, 2, 0, 1, 10, 6 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; digits are lost where terms nearly cancel in C*s*(I1*M) - gamma3*(G*J1/R), F0" },
    .integral_gradients = { integral_gradients, 4, { 1, 13, 5, 1, 0, 2, 7, 5 }, { 16, 73, 0, 10, 0, 2, 13, 9 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; digits are lost where terms nearly cancel in C*s*(I1*M) - gamma3*(G*J1/R), d(F0)/d(gamma3), d(F0)/d(s)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .pole_count = 1, .poles = poles,
    .lifted = lifted,
    .tier = "balanced", .tier_meaning = "a3 = 0: M^2 whole, in three states on levels of G and of the horizontal momentum",
    .way_count = 1, .ways = ways,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_balanced_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_general_in_regular) },
#endif
};
