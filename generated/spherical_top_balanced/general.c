/* Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Table:      spherical_top_balanced, SHA-256 24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33
 *  Command:    ttc generate --effort full --out DIR spherical_top_balanced.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   16    5    1    1    2     10    7   (75)
 *  jacobian            2   31   12    1    1    2     14   12   (282)
 *  rhs_jacobian        3   34   12    1    1    2     14   14   (336)
 *  divergence          4    9    3    1    1    1     10    5   (31)
 *  integral_values     3    7    3    1    1    1      8    4   (33)
 *  integral_gradients  2   10    5    2    1    2     10    5   (77)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in R - R*I3/I1, 4*(I1 - I3)*(m*R^3 - m*R^3*I3/I1),
 *      R*I3*M - R*I3^2*M/I1, R*I3*M - R*I1*M, gamma3*(I3*M)*C + (G*J3/R)*s, (I1*M)*s*C - gamma3*(G*J1/R),
 *      (G*J3/R)*gamma3*1/s - (I3*M)*C, v_slip - (M/(m*R))*S, a part of d(d(psi)/dt)/d(gamma3),
 *      a part of d(d(v_slip)/dt)/d(gamma3), a part of d(d(v_slip)/dt)/d(psi), C*(I1*M)*gamma3*1/s + G*J1/R,
 *      d(d(v_slip)/dt)/d(gamma3)
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_general;
extern const struct jlt_ball_table jlt_balls_spherical_top_balanced_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_general_avx512;

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
    const double t9 = params[2]*params[5]; /* I1*M */
    out[9] = t9;
    const double t10 = t3*params[4]; /* J1*G */
    const double t11 = t10/params[1]; /* J1*G/R */
    out[10] = t11;
    const double t12 = t2 + params[3]; /* J3 = m*R*R + I3 */
    const double t13 = params[4]*t12; /* G*J3 */
    const double t14 = t13/params[1]; /* G*J3/R */
    out[11] = t14;
    const double t15 = params[5]*params[3]; /* M*I3 */
    out[12] = t15;
    const double t16 = params[2]*params[3]; /* I1*I3 */
    out[13] = t16;
    const double t17 = params[2]*t2; /* I1*m*R*R */
    out[14] = t17;
    const double t18 = params[3]/params[2]; /* I3/I1 */
    out[15] = t18;
    const double t19 = -t4; /* -m*R/J1 */
    out[16] = t19;
    const double t20 = params[5]/t3; /* M/J1 */
    const double t21 = -t20; /* -M/J1 */
    out[17] = t21;
    const double t22 = params[2] - params[3]; /* I1 - I3 */
    out[28] = t22;
    const double t23 = 4.0*t22; /* 4*(I1 - I3) */
    const double t24 = params[1]*t1; /* R*R*R */
    const double t25 = params[0]*t24; /* m*R*R*R */
    const double t26 = params[3]*t25; /* I3*m*R*R*R */
    const double t27 = t26/params[2]; /* I3*m*R*R*R/I1 */
    const double t28 = t25 - t27; /* m*R*R*R - I3*m*R*R*R/I1 */
    const double t29 = t23*t28; /* 4*(I1 - I3)*(m*R*R*R - I3*m*R*R*R/I1) */
    out[18] = t29;
    const double t30 = params[5]*t6; /* M*R*I3 */
    const double t31 = params[1]*params[2]; /* R*I1 */
    const double t32 = params[5]*t31; /* M*R*I1 */
    const double t33 = t30 - t32; /* M*R*I3 - M*R*I1 */
    out[19] = t33;
    const double t34 = params[3]*params[3]; /* I3*I3 */
    const double t35 = params[1]*t34; /* R*I3*I3 */
    const double t36 = params[5]*t35; /* M*R*I3*I3 */
    const double t37 = t36/params[2]; /* M*R*I3*I3/I1 */
    const double t38 = t30 - t37; /* M*R*I3 - M*R*I3*I3/I1 */
    out[20] = t38;
    const double t39 = params[0]*2.0; /* m*2 */
    const double t40 = t1*t39; /* R*R*m*2 */
    const double t41 = t22*t40; /* (I1 - I3)*R*R*m*2 */
    out[21] = t41;
    const double t42 = -t15; /* -M*I3 */
    out[22] = t42;
    const double t43 = params[3]/t2; /* I3/(m*R*R) */
    out[23] = t43;
    const double t44 = t15/t17; /* M*I3/(I1*m*R*R) */
    out[24] = t44;
    const double t45 = params[2]*params[2]; /* I1*I1 */
    const double t46 = params[0]*t45; /* m*I1*I1 */
    out[25] = t46;
    const double t47 = t22/t17; /* (I1 - I3)/(I1*m*R*R) */
    out[26] = t47;
    const double t48 = t22*(-2.0); /* (I1 - I3)*(-2) */
    const double t49 = t48/t2; /* (I1 - I3)*(-2)/(m*R*R) */
    out[27] = t49;
    const double t50 = t16/t2; /* I1*I3/(m*R*R) */
    out[29] = t50;
    const double t51 = t39*t45; /* m*2*I1*I1 */
    out[30] = t51;
    const double t52 = params[2]*(-2.0); /* I1*(-2) */
    const double t53 = params[5]*t52; /* M*I1*(-2) */
    const double t54 = t22*t53; /* (I1 - I3)*M*I1*(-2) */
    const double t55 = t54/t2; /* (I1 - I3)*M*I1*(-2)/(m*R*R) */
    out[31] = t55;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = sin(x[2]); /* S = sin(psi) */
    const double t5 = JLT_FNMA(p[7], t4, x[1]); /* v_slip - M/(m*R)*S */
    const double t6 = p[6]*t3; /* m*R/J1*s */
    const double t7 = t5*t6; /* (v_slip - M/(m*R)*S)*m*R/J1*s */
    out[0] = t7;
    const double t8 = cos(x[2]); /* C = cos(psi) */
    const double t9 = t3*p[9]; /* s*I1*M */
    const double t10 = t8*t9; /* C*s*I1*M */
    const double t11 = JLT_FNMA(x[0], p[10], t10); /* C*s*I1*M - gamma3*G*J1/R */
    const double t12 = t3*p[11]; /* s*G*J3/R */
    const double t13 = x[0]*p[12]; /* gamma3*I3*M */
    const double t14 = JLT_FMA(t8, t13, t12); /* C*gamma3*I3*M + s*G*J3/R */
    const double t15 = x[0]*p[15]; /* gamma3*I3/I1 */
    const double t16 = JLT_FMA(x[0], t15, t2); /* gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) */
    const double t17 = JLT_FMA(p[14], t16, p[13]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3)) + I1*I3 */
    const double t18 = t3*t17; /* s*Theta */
    const double t19 = 1.0/t18; /* 1/(s*Theta) */
    const double t20 = t3*t19; /* 1/Theta = s*1/(s*Theta) */
    const double t21 = t14*t20; /* (C*gamma3*I3*M + s*G*J3/R)*1/Theta */
    const double t22 = p[8]*t20; /* (R - R*I3/I1)*1/Theta */
    const double t23 = t11*t22; /* (C*s*I1*M - gamma3*G*J1/R)*(R - R*I3/I1)*1/Theta */
    const double t24 = t21*t23; /* (C*gamma3*I3*M + s*G*J3/R)*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*(R - R*I3/I1)*1/Theta */
    out[1] = t24;
    const double t25 = t17*t19; /* Theta*1/(s*Theta) */
    const double t26 = t21*t25; /* (C*gamma3*I3*M + s*G*J3/R)*1/Theta*Theta*1/(s*Theta) */
    out[2] = t26;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[4] = 0.0;
    out[7] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[15]; /* gamma3*I3/I1 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* gamma3*gamma3*I3/I1 + (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(p[14], t4, p[13]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + (1 - gamma3)*(gamma3 + 1)) + I1*I3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = p[6]*t6; /* m*R/J1*s */
    out[1] = t7;
    const double t8 = t5*t6; /* Theta*s */
    const double t9 = 1.0/t8; /* 1/(Theta*s) */
    const double t10 = t5*t9; /* 1/s = Theta*1/(Theta*s) */
    const double t11 = t6*t9; /* 1/Theta = s*1/(Theta*s) */
    const double t12 = cos(x[2]); /* C = cos(psi) */
    const double t13 = x[0]*t10; /* gamma3*1/s */
    const double t14 = p[11]*t6; /* G*J3/R*s */
    const double t15 = p[12]*t12; /* I3*M*C */
    const double t16 = JLT_FMA(x[0], t15, t14); /* gamma3*I3*M*C + G*J3/R*s */
    const double t17 = JLT_FMS(p[11], t13, t15); /* G*J3/R*gamma3*1/s - I3*M*C */
    const double t18 = t11*t16; /* 1/Theta*(gamma3*I3*M*C + G*J3/R*s) */
    const double t19 = t11*t17; /* 1/Theta*(G*J3/R*gamma3*1/s - I3*M*C) */
    const double t20 = p[9]*t12; /* I1*M*C */
    const double t21 = t6*t20; /* s*I1*M*C */
    const double t22 = JLT_FNMA(x[0], p[10], t21); /* s*I1*M*C - gamma3*G*J1/R */
    const double t23 = JLT_FMA(t13, t20, p[10]); /* gamma3*1/s*I1*M*C + G*J1/R */
    const double t24 = x[0]*t11; /* gamma3*1/Theta */
    const double t25 = t22*t24; /* (s*I1*M*C - gamma3*G*J1/R)*gamma3*1/Theta */
    const double t26 = t19*t22; /* 1/Theta*(G*J3/R*gamma3*1/s - I3*M*C)*(s*I1*M*C - gamma3*G*J1/R) */
    const double t27 = JLT_FMA(t18, t23, t26); /* 1/Theta*(gamma3*I3*M*C + G*J3/R*s)*(gamma3*1/s*I1*M*C + G*J1/R) + t26 */
    const double t28 = p[18]*t18; /* 4*(I1 - I3)*(m*R^3 - m*R^3*I3/I1)*1/Theta*(gamma3*I3*M*C + G*J3/R*s) */
    const double t29 = t25*t28; /* (s*I1*M*C - gamma3*G*J1/R)*gamma3*1/Theta*t28 */
    const double t30 = JLT_FNMA(p[8], t27, t29); /* (s*I1*M*C - gamma3*G*J1/R)*gamma3*1/Theta*t28 - (R - R*I3/I1)*t27 */
    const double t31 = t11*t30; /* 1/Theta*t30 */
    out[3] = t31;
    const double t32 = p[19]*t6; /* (R*I3*M - R*I1*M)*s */
    const double t33 = t18*t32; /* 1/Theta*(gamma3*I3*M*C + G*J3/R*s)*(R*I3*M - R*I1*M)*s */
    const double t34 = JLT_FNMA(p[20], t25, t33); /* 1/Theta*(gamma3*I3*M*C + G*J3/R*s)*(R*I3*M - R*I1*M)*s - (R*I3*M - R*I3^2*M/I1)*(s*I1*M*C - gamma3*G*J1/R)*gamma3*1/Theta */
    const double t35 = p[17]*t6; /* (-M/J1)*s */
    const double t36 = t12*t35; /* C*(-M/J1)*s */
    out[2] = t36;
    const double t37 = t10*t13; /* 1/s*gamma3*1/s */
    const double t38 = JLT_FMA(p[21], t24, t37); /* 2*m*R^2*(I1 - I3)*gamma3*1/Theta + 1/s*gamma3*1/s */
    const double t39 = JLT_FMS(t18, t38, t19); /* 1/Theta*(gamma3*I3*M*C + G*J3/R*s)*(2*m*R^2*(I1 - I3)*gamma3*1/Theta + 1/s*gamma3*1/s) - 1/Theta*(G*J3/R*gamma3*1/s - I3*M*C) */
    const double t40 = t10*t39; /* 1/s*t39 */
    out[6] = t40;
    const double t41 = sin(x[2]); /* S = sin(psi) */
    const double t42 = t11*t41; /* 1/Theta*S */
    const double t43 = t34*t42; /* t34*1/Theta*S */
    out[5] = t43;
    const double t44 = JLT_FNMA(p[7], t41, x[1]); /* v_slip - M/(m*R)*S */
    const double t45 = p[16]*t13; /* (-m*R/J1)*gamma3*1/s */
    const double t46 = t44*t45; /* (v_slip - M/(m*R)*S)*(-m*R/J1)*gamma3*1/s */
    out[0] = t46;
    const double t47 = p[22]*t13; /* (-I3*M)*gamma3*1/s */
    const double t48 = t42*t47; /* 1/Theta*S*(-I3*M)*gamma3*1/s */
    out[8] = t48;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[7] = 0.0;
    out[10] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[15]; /* gamma3*I3/I1 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = JLT_FMA(p[14], t4, p[13]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3)) + I1*I3 */
    const double t7 = t5*t6; /* s*Theta */
    const double t8 = 1.0/t7; /* 1/(s*Theta) */
    const double t9 = t6*t8; /* 1/s = Theta*1/(s*Theta) */
    const double t10 = t5*t8; /* 1/Theta = s*1/(s*Theta) */
    const double t11 = cos(x[2]); /* C = cos(psi) */
    const double t12 = p[11]*t5; /* G*J3/R*s */
    const double t13 = p[12]*t11; /* I3*M*C */
    const double t14 = JLT_FMA(x[0], t13, t12); /* gamma3*I3*M*C + G*J3/R*s */
    const double t15 = t10*t14; /* 1/Theta*(gamma3*I3*M*C + G*J3/R*s) */
    const double t16 = t5*t11; /* s*C */
    const double t17 = p[17]*t16; /* (-M/J1)*s*C */
    out[5] = t17;
    const double t18 = p[9]*t16; /* I1*M*s*C */
    const double t19 = JLT_FNMA(x[0], p[10], t18); /* I1*M*s*C - gamma3*G*J1/R */
    const double t20 = t10*t15; /* 1/Theta*1/Theta*(gamma3*I3*M*C + G*J3/R*s) */
    const double t21 = x[0]*t9; /* gamma3*1/s */
    const double t22 = JLT_FMS(p[11], t21, t13); /* G*J3/R*gamma3*1/s - I3*M*C */
    const double t23 = t10*t22; /* 1/Theta*(G*J3/R*gamma3*1/s - I3*M*C) */
    const double t24 = x[0]*t20; /* gamma3*1/Theta*1/Theta*(gamma3*I3*M*C + G*J3/R*s) */
    const double t25 = p[8]*t20; /* (R - R*I3/I1)*1/Theta*1/Theta*(gamma3*I3*M*C + G*J3/R*s) */
    const double t26 = t19*t25; /* (I1*M*s*C - gamma3*G*J1/R)*(R - R*I3/I1)*1/Theta*1/Theta*(gamma3*I3*M*C + G*J3/R*s) */
    out[1] = t26;
    const double t27 = t10*t19; /* 1/Theta*(I1*M*s*C - gamma3*G*J1/R) */
    const double t28 = x[0]*p[20]; /* gamma3*(R*I3*M - R*I3^2*M/I1) */
    const double t29 = t27*t28; /* 1/Theta*(I1*M*s*C - gamma3*G*J1/R)*gamma3*(R*I3*M - R*I3^2*M/I1) */
    const double t30 = sin(x[2]); /* S = sin(psi) */
    const double t31 = t10*t30; /* 1/Theta*S */
    const double t32 = JLT_FNMA(p[7], t30, x[1]); /* v_slip - M/(m*R)*S */
    const double t33 = t9*t15; /* 1/s*1/Theta*(gamma3*I3*M*C + G*J3/R*s) */
    out[2] = t33;
    const double t34 = JLT_FMS(t21, t33, t23); /* gamma3*1/s*1/s*1/Theta*(gamma3*I3*M*C + G*J3/R*s) - 1/Theta*(G*J3/R*gamma3*1/s - I3*M*C) */
    const double t35 = JLT_FMA(p[21], t24, t34); /* 2*m*R^2*(I1 - I3)*gamma3*1/Theta*1/Theta*(gamma3*I3*M*C + G*J3/R*s) + t34 */
    const double t36 = t9*t35; /* 1/s*t35 */
    out[9] = t36;
    const double t37 = p[18]*t24; /* 4*(I1 - I3)*(m*R^3 - m*R^3*I3/I1)*gamma3*1/Theta*1/Theta*(gamma3*I3*M*C + G*J3/R*s) */
    const double t38 = JLT_FNMA(p[8], t23, t37); /* t37 - (R - R*I3/I1)*1/Theta*(G*J3/R*gamma3*1/s - I3*M*C) */
    const double t39 = t27*t38; /* 1/Theta*(I1*M*s*C - gamma3*G*J1/R)*(t37 - (R - R*I3/I1)*1/Theta*(G*J3/R*gamma3*1/s - I3*M*C)) */
    const double t40 = p[19]*t5; /* (R*I3*M - R*I1*M)*s */
    const double t41 = JLT_FNMA(t15, t40, t29); /* t29 - 1/Theta*(gamma3*I3*M*C + G*J3/R*s)*(R*I3*M - R*I1*M)*s */
    const double t42 = p[6]*t5; /* m*R/J1*s */
    out[4] = t42;
    const double t43 = t32*t42; /* (v_slip - M/(m*R)*S)*m*R/J1*s */
    out[0] = t43;
    const double t44 = t31*t41; /* 1/Theta*S*(t29 - 1/Theta*(gamma3*I3*M*C + G*J3/R*s)*(R*I3*M - R*I1*M)*s) */
    const double t45 = -t44; /* -t44 */
    out[8] = t45;
    const double t46 = p[9]*t21; /* I1*M*gamma3*1/s */
    const double t47 = JLT_FMA(t11, t46, p[10]); /* C*I1*M*gamma3*1/s + G*J1/R */
    const double t48 = JLT_FNMA(t25, t47, t39); /* t39 - (R - R*I3/I1)*1/Theta*1/Theta*(gamma3*I3*M*C + G*J3/R*s)*(C*I1*M*gamma3*1/s + G*J1/R) */
    out[6] = t48;
    const double t49 = p[16]*t21; /* (-m*R/J1)*gamma3*1/s */
    const double t50 = t32*t49; /* (v_slip - M/(m*R)*S)*(-m*R/J1)*gamma3*1/s */
    out[3] = t50;
    const double t51 = p[22]*t21; /* (-I3*M)*gamma3*1/s */
    const double t52 = t31*t51; /* 1/Theta*S*(-I3*M)*gamma3*1/s */
    out[11] = t52;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[15]; /* gamma3*I3/I1 */
    const double t4 = p[23] + t2; /* I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = t5*t6; /* Theta/(m*R^2*I1)*s */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*s) */
    const double t9 = p[24]*t6; /* I3*M/(m*R^2*I1)*s */
    const double t10 = t8*t9; /* 1/(Theta/(m*R^2*I1)*s)*I3*M/(m*R^2*I1)*s */
    const double t11 = x[0]*t5; /* gamma3*Theta/(m*R^2*I1) */
    const double t12 = t8*t11; /* 1/(Theta/(m*R^2*I1)*s)*gamma3*Theta/(m*R^2*I1) */
    const double t13 = sin(x[2]); /* S = sin(psi) */
    const double t14 = JLT_FNMA(p[7], t13, x[1]); /* v_slip - M/(m*R)*S */
    const double t15 = p[6]*t14; /* m*R/J1*(v_slip - M/(m*R)*S) */
    const double t16 = JLT_FMA(t10, t13, t15); /* 1/(Theta/(m*R^2*I1)*s)*I3*M/(m*R^2*I1)*s*S + m*R/J1*(v_slip - M/(m*R)*S) */
    const double t17 = t12*t16; /* 1/(Theta/(m*R^2*I1)*s)*gamma3*Theta/(m*R^2*I1)*t16 */
    const double t18 = -t17; /* -1/(Theta/(m*R^2*I1)*s)*gamma3*Theta/(m*R^2*I1)*t16 */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[15]; /* gamma3*I3/I1 */
    const double t4 = p[23] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = p[9]*t6; /* I1*M*s */
    const double t8 = p[26]/t5; /* (I1 - I3)/(m*R^2*I1)/(Theta/(m*R^2*I1)) */
    const double t9 = cos(x[2]); /* C = cos(psi) */
    const double t10 = t7*t9; /* I1*M*s*C */
    const double t11 = JLT_FNMA(x[0], p[10], t10); /* I1*M*s*C - gamma3*G*J1/R */
    const double t12 = t8*t11; /* (I1 - I3)/(m*R^2*I1)/(Theta/(m*R^2*I1))*(I1*M*s*C - gamma3*G*J1/R) */
    const double t13 = p[25]*x[1]; /* m*I1^2*v_slip */
    const double t14 = x[1]*t13; /* v_slip*m*I1^2*v_slip */
    const double t15 = JLT_FMA(t11, t12, t14); /* (I1*M*s*C - gamma3*G*J1/R)*t12 + v_slip*m*I1^2*v_slip */
    out[0] = t15;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[30]*x[1]; /* 2*m*I1^2*v_slip */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt(s^2) */
    const double t5 = cos(x[2]); /* C = cos(psi) */
    const double t6 = p[9]*t4; /* I1*M*s */
    const double t7 = t5*t6; /* C*I1*M*s */
    const double t8 = p[31]*t4; /* (-2*I1*M*(I1 - I3)/(m*R^2))*s */
    const double t9 = x[0]*p[3]; /* gamma3*I3 */
    const double t10 = JLT_FMA(x[0], t9, p[29]); /* gamma3*gamma3*I3 + I1*I3/(m*R^2) */
    const double t11 = JLT_FMA(p[2], t3, t10); /* Theta/(m*R^2) = I1*s^2 + gamma3*gamma3*I3 + I1*I3/(m*R^2) */
    const double t12 = t7/t3; /* C*I1*M*s/s^2 */
    const double t13 = JLT_FNMA(x[0], p[10], t7); /* C*I1*M*s - gamma3*G*J1/R */
    const double t14 = t13/t11; /* (C*I1*M*s - gamma3*G*J1/R)/(Theta/(m*R^2)) */
    const double t15 = JLT_FNMA(p[28], t14, t12); /* C*I1*M*s/s^2 - (I1 - I3)*(C*I1*M*s - gamma3*G*J1/R)/(Theta/(m*R^2)) */
    const double t16 = JLT_FMA(x[0], t15, p[10]); /* gamma3*t15 + G*J1/R */
    const double t17 = sin(x[2]); /* S = sin(psi) */
    const double t18 = t8*t17; /* (-2*I1*M*(I1 - I3)/(m*R^2))*s*S */
    const double t19 = t14*t18; /* (C*I1*M*s - gamma3*G*J1/R)/(Theta/(m*R^2))*(-2*I1*M*(I1 - I3)/(m*R^2))*s*S */
    out[2] = t19;
    const double t20 = p[27]*t14; /* (-2*(I1 - I3)/(m*R^2))*(C*I1*M*s - gamma3*G*J1/R)/(Theta/(m*R^2)) */
    const double t21 = t16*t20; /* (gamma3*t15 + G*J1/R)*t20 */
    out[0] = t21;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
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
    double u35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    for (unsigned k = 0; k < order; k++) {
        t14[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t15[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t16[k] = jlt_jet_product(t14, t15, k);
        t17[k] = x0[k]*p[15];
        t18[k] = jlt_jet_product(x0, t17, k) + t16[k];
        t19[k] = p[14]*t18[k] + (k == 0 ? p[13] : 0);
        t20[k] = jlt_jet_root(t16[k], t20, k);
        t21[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t19, t21, k);
        t22[k] = jlt_jet_cosine(x2, t22, u22, k);
        t23[k] = p[11]*t20[k];
        t24[k] = x0[k]*p[12];
        t25[k] = jlt_jet_product(t22, t24, k) + t23[k];
        t26[k] = jlt_jet_product(t21, t25, k);
        t27[k] = p[8]*t21[k];
        t28[k] = jlt_jet_quotient(t26[k], t20, t28, k);
        t29[k] = p[9]*t20[k];
        t30[k] = jlt_jet_product(t22, t29, k);
        t31[k] = t30[k] - x0[k]*p[10];
        t32[k] = jlt_jet_product(t27, t31, k);
        t33[k] = jlt_jet_product(t26, t32, k);
        t34[k] = p[6]*t20[k];
        t35[k] = jlt_jet_sine(x2, t35, u35, k);
        t36[k] = x1[k] - p[7]*t35[k];
        t37[k] = jlt_jet_product(t34, t36, k);
        double *restrict next = coefficients + (k + 1)*3;
        next[0] = x0[k + 1] = t37[k]/(k + 1);
        next[1] = x1[k + 1] = t33[k]/(k + 1);
        next[2] = x2[k + 1] = t28[k]/(k + 1);
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
    const double complex v_v_slip = x[1];
    const double v_M = params[5];
    const double complex v_psi = x[2];
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s*v_omega_tau);
    const double v_I3 = params[3];
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*(v_I1*v_s*v_s + v_I3*v_gamma3*v_gamma3));
    const double v_G = params[4];
    const double complex v_J3 = (v_I3 + v_m*v_R*v_R);
    const double complex v_C = ccos(v_psi);
    const double complex v_omega_n = ((v_G*v_s*v_J3/v_R + v_I3*v_M*v_gamma3*v_C)/v_Theta);
    const double complex v_omega3 = ((v_I1*v_M*v_s*v_C - v_G*v_gamma3*v_J1/v_R)/v_Theta);
    out[1] = (v_R*v_omega_n*v_omega3)
        + (-v_R*v_I3*v_omega_n*v_omega3/v_I1);
    out[2] = (v_omega_n/v_s);
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
    const double t7 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t8 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t9 = t7*t8; /* (1 - gamma3)*(1 + gamma3) */
    const double t10 = sqrt(t9); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t11 = t10*t10; /* s*s */
    const double t12 = params[2]*t11; /* I1*s*s */
    const double t13 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t14 = params[3]*t13; /* I3*gamma3*gamma3 */
    const double t15 = t12 + t14; /* I1*s*s + I3*gamma3*gamma3 */
    const double t16 = t6*t15; /* m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t17 = t4 + t16; /* Theta = I1*I3 + m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t18 = params[2]*params[5]; /* I1*M */
    const double t19 = t10*t18; /* s*I1*M */
    const double t20 = cos(x[2]); /* C = cos(psi) */
    const double t21 = t19*t20; /* s*I1*M*C */
    const double t22 = params[4]*x[0]; /* G*gamma3 */
    const double t23 = params[2] + t6; /* J1 = I1 + m*R*R */
    const double t24 = t22*t23; /* G*gamma3*J1 */
    const double t25 = t24/params[1]; /* G*gamma3*J1/R */
    const double t26 = t21 - t25; /* s*I1*M*C - G*gamma3*J1/R */
    const double t27 = t26*t26; /* (s*I1*M*C - G*gamma3*J1/R)*(s*I1*M*C - G*gamma3*J1/R) */
    const double t28 = params[2] - params[3]; /* I1 - I3 */
    const double t29 = t27*t28; /* (s*I1*M*C - G*gamma3*J1/R)*(s*I1*M*C - G*gamma3*J1/R)*(I1 - I3) */
    const double t30 = t29/t17; /* t29/Theta */
    const double t31 = t3 + t30; /* m*I1*I1*v_slip*v_slip + t29/Theta */
    out[6] = t31;
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
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = x[0] + 1.0; /* gamma3 + 1 */
    const double t7 = t5*t6; /* (1 - gamma3)*(gamma3 + 1) */
    const double t8 = sqrt(t7); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = t8*t8; /* s*s */
    const double t10 = params[2]*t9; /* I1*s*s */
    const double t11 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t12 = params[3]*t11; /* I3*gamma3*gamma3 */
    const double t13 = t10 + t12; /* I1*s*s + I3*gamma3*gamma3 */
    const double t14 = t4*t13; /* m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t15 = t2 + t14; /* Theta = I1*I3 + m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t16 = params[2]*params[5]; /* I1*M */
    const double t17 = t8*t16; /* s*I1*M */
    out[2] = x[1];
    const double t18 = cos(x[1]); /* C = cos(psi) */
    const double t19 = t17*t18; /* s*I1*M*C */
    const double t20 = x[0]*params[4]; /* gamma3*G */
    const double t21 = params[2] + t4; /* J1 = I1 + m*R*R */
    const double t22 = t20*t21; /* gamma3*G*J1 */
    const double t23 = t22/params[1]; /* gamma3*G*J1/R */
    const double t24 = t19 - t23; /* s*I1*M*C - gamma3*G*J1/R */
    const double t25 = t24*t24; /* (s*I1*M*C - gamma3*G*J1/R)*(s*I1*M*C - gamma3*G*J1/R) */
    const double t26 = params[2] - params[3]; /* I1 - I3 */
    const double t27 = t25*t26; /* (s*I1*M*C - gamma3*G*J1/R)*(s*I1*M*C - gamma3*G*J1/R)*(I1 - I3) */
    const double t28 = t27/t15; /* t27/Theta */
    const double t29 = params[6] - t28; /* F0 - t27/Theta */
    const double t30 = t29/t1; /* (F0 - t27/Theta)/(m*I1*I1) */
    const double t31 = sqrt(t30); /* v_slip = sqrt((F0 - t27/Theta)/(m*I1*I1)) */
    out[1] = t31;
}

static const unsigned char way0_is_angle[] = { 0, 0 };

static const unsigned char way0_is_root[] = { 0, 0, 0, 0, 0, 0, 0 };

static const unsigned char way0_sources[] = { 0, 0, 0, 0, 0, 0, 2 };

static const jlt_way ways[] = {
    { .name = "half", .kind = "reduction", .model = "spherical_top_plane", .file = "spherical_top_plane.tt",
      .sha256 = "ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6",
      .time = "", .claim = 7,
      .state_count = 2, .param_count = 7, .coordinate_count = 2,
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

static const signed char signs_4[] = { 1, -1, -1 };
static const jlt_reversor reversors[] = {
    { signs_4, 4 },
};

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_general = {
    .model = "spherical_top_balanced",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_balanced, .family = jlt_family_spherical_top_balanced, .claims = jlt_claims_spherical_top_balanced,
    .scales = 1,
    .state_count = 3, .param_count = 6, .prepared_count = 32,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 3, { 2, 16, 5, 1, 1, 2, 10, 7 }, { 12, 51, 0, 9, 1, 2, 12, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_slip - (M/(m*R))*S, R - R*I3/I1, C*s*(I1*M) - gamma3*(G*J1/R), C*gamma3*(I3*M) + s*(G*J3/R)" },
    .jacobian = { jacobian, 9, { 2, 31, 12, 1, 1, 2, 14, 12 }, { 42, 199, 0, 38, 1, 2, 17, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 4*(I1 - I3)*(m*R^3 - m*R^3*I3/I1), R - R*I3/I1, R*I3*M - R*I1*M, R*I3*M - R*I3^2*M/I1, gamma3*(I3*M)*C + (G*J3/R)*s, (G*J3/R)*gamma3*1/s - (I3*M)*C, s*(I1*M)*C - gamma3*(G*J1/R), gamma3*1/s*(I1*M)*C + G*J1/R, a part of d(d(v_slip)/dt)/d(gamma3), a part of d(d(v_slip)/dt)/d(gamma3), a part of d(d(v_slip)/dt)/d(psi), (2*m*R^2*(I1 - I3))*gamma3*1/Theta + 1/s*gamma3*1/s, a part of d(d(psi)/dt)/d(gamma3), v_slip - (M/(m*R))*S" },
    .rhs_jacobian = { rhs_jacobian, 12, { 3, 34, 12, 1, 1, 2, 14, 14 }, { 49, 237, 0, 47, 1, 2, 17, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in R - R*I3/I1, 4*(I1 - I3)*(m*R^3 - m*R^3*I3/I1), R*I3*M - R*I3^2*M/I1, R*I3*M - R*I1*M, gamma3*(I3*M)*C + (G*J3/R)*s, (I1*M)*s*C - gamma3*(G*J1/R), (G*J3/R)*gamma3*1/s - (I3*M)*C, v_slip - (M/(m*R))*S, a part of d(d(psi)/dt)/d(gamma3), a part of d(d(v_slip)/dt)/d(gamma3), a part of d(d(v_slip)/dt)/d(psi), C*(I1*M)*gamma3*1/s + G*J1/R, d(d(v_slip)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 4, 9, 3, 1, 1, 1, 10, 5 }, { 7, 20, 0, 2, 1, 1, 11, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_slip - (M/(m*R))*S, a part of the divergence" },
    .integral_values = { integral_values, 1, { 3, 7, 3, 1, 1, 1, 8, 4 }, { 7, 22, 0, 2, 1, 1, 10, 7 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in (I1*M)*s*C - gamma3*(G*J1/R), F0" },
    .integral_gradients = { integral_gradients, 3, { 2, 10, 5, 2, 1, 2, 10, 5 }, { 13, 53, 0, 8, 1, 2, 13, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*(I1*M)*s - gamma3*(G*J1/R), a part of d(F0)/d(gamma3), a part of d(F0)/d(gamma3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .reversor_count = 1, .reversors = reversors,
    .pole_count = 1, .poles = poles,
    .tier = "balanced", .tier_meaning = "a3 = 0: M^2 whole, in three states on levels of G and of the horizontal momentum",
    .way_count = 1, .ways = ways,
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_balanced_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_general) },
#endif
};
