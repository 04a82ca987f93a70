/* Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Table:      spherical_top_balanced, SHA-256 70ff20361cc8550a994847ce02cbc8dfe6b50b8424b0daf5121bfd70d4951a10
 *  Command:    ttc generate --out DIR spherical_top_balanced.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   18    5    1    1    2     11    7   (75)
 *  jacobian            3   36   12    1    1    2     14   15   (282)
 *  rhs_jacobian        3   39   12    1    1    2     14   15   (336)
 *  divergence          3   11    4    1    1    1     11    6   (31)
 *  integral_values     2    9    4    1    1    1      9    5   (33)
 *  integral_gradients  2   17    5    1    1    2     12    7   (77)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_balanced[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_general;
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
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[2] + t1; /* J1 = I1 + m*R*R */
    const double t3 = 1.0/t2; /* 1/J1 */
    const double t4 = params[0]*params[1]; /* m*R */
    const double t5 = params[1]*params[3]; /* R*I3 */
    const double t6 = t5/params[2]; /* R*I3/I1 */
    const double t7 = params[1] - t6; /* R - R*I3/I1 */
    const double t8 = params[2]*params[5]; /* I1*M */
    const double t9 = t2*params[4]; /* J1*G */
    const double t10 = t9/params[1]; /* J1*G/R */
    const double t11 = t1 + params[3]; /* J3 = m*R*R + I3 */
    const double t12 = params[4]*t11; /* G*J3 */
    const double t13 = t12/params[1]; /* G*J3/R */
    const double t14 = params[3]*params[5]; /* I3*M */
    const double t15 = params[2]*params[3]; /* I1*I3 */
    const double t16 = (-1.0)/t2; /* (-1)/J1 */
    const double t17 = t4/t2; /* m*R/J1 */
    const double t18 = params[5]/t2; /* M/J1 */
    const double t19 = -t18; /* -M/J1 */
    const double t20 = params[1]*t0; /* R*R*R */
    const double t21 = params[0]*t20; /* m*R*R*R */
    const double t22 = t21*4.0; /* m*R*R*R*4 */
    const double t23 = params[3]*t21; /* I3*m*R*R*R */
    const double t24 = t23/params[2]; /* I3*m*R*R*R/I1 */
    const double t25 = 4.0*t24; /* 4*I3*m*R*R*R/I1 */
    const double t26 = t22 - t25; /* m*R*R*R*4 - 4*I3*m*R*R*R/I1 */
    const double t27 = params[2] - params[3]; /* I1 - I3 */
    const double t28 = t5*params[5]; /* R*I3*M */
    const double t29 = params[3]*params[3]; /* I3*I3 */
    const double t30 = params[1]*t29; /* R*I3*I3 */
    const double t31 = params[5]*t30; /* M*R*I3*I3 */
    const double t32 = t31/params[2]; /* M*R*I3*I3/I1 */
    const double t33 = t28 - t32; /* R*I3*M - M*R*I3*I3/I1 */
    const double t34 = params[2]*params[1]; /* I1*R */
    const double t35 = params[5]*t34; /* M*I1*R */
    const double t36 = t28 - t35; /* R*I3*M - M*I1*R */
    const double t37 = params[0]*2.0; /* m*2 */
    const double t38 = t0*t37; /* R*R*m*2 */
    const double t39 = -t14; /* -I3*M */
    const double t40 = params[2]*params[2]; /* I1*I1 */
    const double t41 = params[0]*t40; /* m*I1*I1 */
    const double t42 = t27*t27; /* (I1 - I3)*(I1 - I3) */
    const double t43 = t38*t42; /* R*R*m*2*(I1 - I3)*(I1 - I3) */
    const double t44 = params[2]*2.0; /* I1*2 */
    const double t45 = params[3]*2.0; /* I3*2 */
    const double t46 = t44 - t45; /* I1*2 - I3*2 */
    const double t47 = t37*t40; /* m*2*I1*I1 */
    const double t48 = params[2]*(-2.0); /* I1*(-2) */
    const double t49 = params[5]*t48; /* M*I1*(-2) */
    const double t50 = t27*t49; /* (I1 - I3)*M*I1*(-2) */
    out[6] = t3;
    out[7] = t4;
    out[8] = t7;
    out[9] = t8;
    out[10] = t10;
    out[11] = t13;
    out[12] = t14;
    out[13] = t15;
    out[14] = t1;
    out[15] = t16;
    out[16] = t17;
    out[17] = t19;
    out[18] = t26;
    out[19] = t27;
    out[20] = t33;
    out[21] = t36;
    out[22] = t38;
    out[23] = t39;
    out[24] = t41;
    out[25] = t43;
    out[26] = t46;
    out[27] = t47;
    out[28] = t50;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = p[7]*x[1]; /* m*R*v_slip */
    const double t5 = sin(x[2]); /* S = sin(psi) */
    const double t6 = JLT_FNMA(p[5], t5, t4); /* m*R*v_slip - M*S */
    const double t7 = p[6]*t3; /* 1/J1*s */
    const double t8 = t6*t7; /* (m*R*v_slip - M*S)*1/J1*s */
    const double t9 = cos(x[2]); /* C = cos(psi) */
    const double t10 = t3*p[9]; /* s*I1*M */
    const double t11 = t9*t10; /* C*s*I1*M */
    const double t12 = JLT_FNMA(x[0], p[10], t11); /* C*s*I1*M - gamma3*G*J1/R */
    const double t13 = t3*p[11]; /* s*G*J3/R */
    const double t14 = x[0]*p[12]; /* gamma3*I3*M */
    const double t15 = JLT_FMA(t9, t14, t13); /* C*gamma3*I3*M + s*G*J3/R */
    const double t16 = t2*p[2]; /* (1 - gamma3)*(1 + gamma3)*I1 */
    const double t17 = x[0]*p[3]; /* gamma3*I3 */
    const double t18 = JLT_FMA(x[0], t17, t16); /* gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1 */
    const double t19 = JLT_FMA(p[14], t18, p[13]); /* Theta = m*R^2*(gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1) + I1*I3 */
    const double t20 = t3*t19; /* s*Theta */
    const double t21 = 1.0/t20; /* 1/(s*Theta) */
    const double t22 = t3*t21; /* s*1/(s*Theta) */
    const double t23 = t15*t22; /* (C*gamma3*I3*M + s*G*J3/R)*s*1/(s*Theta) */
    const double t24 = p[8]*t22; /* (R - R*I3/I1)*s*1/(s*Theta) */
    const double t25 = t12*t24; /* (C*s*I1*M - gamma3*G*J1/R)*(R - R*I3/I1)*s*1/(s*Theta) */
    const double t26 = t23*t25; /* (C*gamma3*I3*M + s*G*J3/R)*s*1/(s*Theta)*(C*s*I1*M - gamma3*G*J1/R)*(R - R*I3/I1)*s*1/(s*Theta) */
    const double t27 = t19*t21; /* Theta*1/(s*Theta) */
    const double t28 = t23*t27; /* (C*gamma3*I3*M + s*G*J3/R)*s*1/(s*Theta)*Theta*1/(s*Theta) */
    out[0] = t8;
    out[1] = t26;
    out[2] = t28;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[7]*x[1]; /* m*R*v_slip */
    const double t1 = sin(x[2]); /* S = sin(psi) */
    const double t2 = JLT_FNMA(p[5], t1, t0); /* m*R*v_slip - M*S */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = x[0] + 1.0; /* gamma3 + 1 */
    const double t5 = t3*t4; /* (1 - gamma3)*(gamma3 + 1) */
    const double t6 = p[2]*t5; /* I1*(1 - gamma3)*(gamma3 + 1) */
    const double t7 = x[0]*p[3]; /* gamma3*I3 */
    const double t8 = JLT_FMA(x[0], t7, t6); /* gamma3*gamma3*I3 + I1*(1 - gamma3)*(gamma3 + 1) */
    const double t9 = JLT_FMA(p[14], t8, p[13]); /* Theta = m*R^2*(gamma3*gamma3*I3 + I1*(1 - gamma3)*(gamma3 + 1)) + I1*I3 */
    const double t10 = sqrt(t5); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t11 = t9*t10; /* Theta*s */
    const double t12 = 1.0/t11; /* 1/(Theta*s) */
    const double t13 = t9*t12; /* Theta*1/(Theta*s) */
    const double t14 = x[0]*t13; /* gamma3*Theta*1/(Theta*s) */
    const double t15 = p[15]*t14; /* (-1/J1)*gamma3*Theta*1/(Theta*s) */
    const double t16 = t2*t15; /* (m*R*v_slip - M*S)*(-1/J1)*gamma3*Theta*1/(Theta*s) */
    const double t17 = t10*p[16]; /* s*m*R/J1 */
    const double t18 = cos(x[2]); /* C = cos(psi) */
    const double t19 = t10*t18; /* s*C */
    const double t20 = p[17]*t19; /* (-M/J1)*s*C */
    const double t21 = t19*p[9]; /* s*C*I1*M */
    const double t22 = JLT_FNMA(x[0], p[10], t21); /* s*C*I1*M - gamma3*G*J1/R */
    const double t23 = t10*p[11]; /* s*G*J3/R */
    const double t24 = t18*p[12]; /* C*I3*M */
    const double t25 = JLT_FMA(x[0], t24, t23); /* gamma3*C*I3*M + s*G*J3/R */
    const double t26 = t10*t12; /* s*1/(Theta*s) */
    const double t27 = t26*t26; /* s*1/(Theta*s)*s*1/(Theta*s) */
    const double t28 = t25*t27; /* (gamma3*C*I3*M + s*G*J3/R)*s*1/(Theta*s)*s*1/(Theta*s) */
    const double t29 = x[0]*p[19]; /* gamma3*(I1 - I3) */
    const double t30 = t28*t29; /* (gamma3*C*I3*M + s*G*J3/R)*s*1/(Theta*s)*s*1/(Theta*s)*gamma3*(I1 - I3) */
    const double t31 = p[18]*t26; /* (4*m*R^3 - 4*m*R^3*I3/I1)*s*1/(Theta*s) */
    const double t32 = t22*t31; /* (s*C*I1*M - gamma3*G*J1/R)*(4*m*R^3 - 4*m*R^3*I3/I1)*s*1/(Theta*s) */
    const double t33 = t30*t32; /* t30*t32 */
    const double t34 = JLT_FMS(t14, p[11], t24); /* gamma3*Theta*1/(Theta*s)*G*J3/R - C*I3*M */
    const double t35 = t22*t27; /* (s*C*I1*M - gamma3*G*J1/R)*s*1/(Theta*s)*s*1/(Theta*s) */
    const double t36 = t34*t35; /* (gamma3*Theta*1/(Theta*s)*G*J3/R - C*I3*M)*(s*C*I1*M - gamma3*G*J1/R)*s*1/(Theta*s)*s*1/(Theta*s) */
    const double t37 = t14*p[9]; /* gamma3*Theta*1/(Theta*s)*I1*M */
    const double t38 = JLT_FMA(t18, t37, p[10]); /* C*gamma3*Theta*1/(Theta*s)*I1*M + G*J1/R */
    const double t39 = JLT_FMA(t28, t38, t36); /* (gamma3*C*I3*M + s*G*J3/R)*s*1/(Theta*s)*s*1/(Theta*s)*(C*gamma3*Theta*1/(Theta*s)*I1*M + G*J1/R) + t36 */
    const double t40 = JLT_FNMA(p[8], t39, t33); /* t30*t32 - (R - R*I3/I1)*t39 */
    const double t41 = x[0]*p[20]; /* gamma3*(R*I3*M - R*I3^2*M/I1) */
    const double t42 = t35*t41; /* (s*C*I1*M - gamma3*G*J1/R)*s*1/(Theta*s)*s*1/(Theta*s)*gamma3*(R*I3*M - R*I3^2*M/I1) */
    const double t43 = t10*p[21]; /* s*(R*I3*M - R*I1*M) */
    const double t44 = JLT_FNMA(t28, t43, t42); /* t42 - (gamma3*C*I3*M + s*G*J3/R)*s*1/(Theta*s)*s*1/(Theta*s)*s*(R*I3*M - R*I1*M) */
    const double t45 = t1*t44; /* S*t44 */
    const double t46 = -t45; /* -S*t44 */
    const double t47 = t13*t14; /* Theta*1/(Theta*s)*gamma3*Theta*1/(Theta*s) */
    const double t48 = JLT_FMS(t25, t47, t34); /* (gamma3*C*I3*M + s*G*J3/R)*Theta*1/(Theta*s)*gamma3*Theta*1/(Theta*s) - (gamma3*Theta*1/(Theta*s)*G*J3/R - C*I3*M) */
    const double t49 = t26*t48; /* s*1/(Theta*s)*t48 */
    const double t50 = JLT_FMA(t30, p[22], t49); /* t30*2*m*R^2 + s*1/(Theta*s)*t48 */
    const double t51 = t13*t50; /* Theta*1/(Theta*s)*(t30*2*m*R^2 + s*1/(Theta*s)*t48) */
    const double t52 = t26*p[23]; /* s*1/(Theta*s)*(-I3*M) */
    const double t53 = t14*t52; /* gamma3*Theta*1/(Theta*s)*s*1/(Theta*s)*(-I3*M) */
    const double t54 = t1*t53; /* S*gamma3*Theta*1/(Theta*s)*s*1/(Theta*s)*(-I3*M) */
    out[0] = t16;
    out[1] = t17;
    out[2] = t20;
    out[3] = t40;
    out[4] = 0.0;
    out[5] = t46;
    out[6] = t51;
    out[7] = 0.0;
    out[8] = t54;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = p[7]*x[1]; /* m*R*v_slip */
    const double t5 = sin(x[2]); /* S = sin(psi) */
    const double t6 = JLT_FNMA(p[5], t5, t4); /* m*R*v_slip - M*S */
    const double t7 = p[6]*t6; /* 1/J1*(m*R*v_slip - M*S) */
    const double t8 = t3*t7; /* s*1/J1*(m*R*v_slip - M*S) */
    const double t9 = cos(x[2]); /* C = cos(psi) */
    const double t10 = p[9]*t9; /* I1*M*C */
    const double t11 = t3*t10; /* s*I1*M*C */
    const double t12 = JLT_FNMA(x[0], p[10], t11); /* s*I1*M*C - gamma3*G*J1/R */
    const double t13 = t3*p[11]; /* s*G*J3/R */
    const double t14 = t9*p[12]; /* C*I3*M */
    const double t15 = JLT_FMA(x[0], t14, t13); /* gamma3*C*I3*M + s*G*J3/R */
    const double t16 = t2*p[2]; /* (1 - gamma3)*(1 + gamma3)*I1 */
    const double t17 = x[0]*p[3]; /* gamma3*I3 */
    const double t18 = JLT_FMA(x[0], t17, t16); /* gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1 */
    const double t19 = JLT_FMA(p[14], t18, p[13]); /* Theta = m*R^2*(gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1) + I1*I3 */
    const double t20 = t3*t19; /* s*Theta */
    const double t21 = 1.0/t20; /* 1/(s*Theta) */
    const double t22 = t3*t21; /* s*1/(s*Theta) */
    const double t23 = t22*t22; /* s*1/(s*Theta)*s*1/(s*Theta) */
    const double t24 = t15*t23; /* (gamma3*C*I3*M + s*G*J3/R)*s*1/(s*Theta)*s*1/(s*Theta) */
    const double t25 = p[8]*t12; /* (R - R*I3/I1)*(s*I1*M*C - gamma3*G*J1/R) */
    const double t26 = t24*t25; /* (gamma3*C*I3*M + s*G*J3/R)*s*1/(s*Theta)*s*1/(s*Theta)*(R - R*I3/I1)*(s*I1*M*C - gamma3*G*J1/R) */
    const double t27 = t15*t21; /* (gamma3*C*I3*M + s*G*J3/R)*1/(s*Theta) */
    const double t28 = t19*t21; /* Theta*1/(s*Theta) */
    const double t29 = x[0]*t28; /* gamma3*Theta*1/(s*Theta) */
    const double t30 = t7*t29; /* 1/J1*(m*R*v_slip - M*S)*gamma3*Theta*1/(s*Theta) */
    const double t31 = -t30; /* -1/J1*(m*R*v_slip - M*S)*gamma3*Theta*1/(s*Theta) */
    const double t32 = t3*p[16]; /* s*m*R/J1 */
    const double t33 = t3*p[17]; /* s*(-M/J1) */
    const double t34 = t9*t33; /* C*s*(-M/J1) */
    const double t35 = x[0]*p[19]; /* gamma3*(I1 - I3) */
    const double t36 = t24*t35; /* (gamma3*C*I3*M + s*G*J3/R)*s*1/(s*Theta)*s*1/(s*Theta)*gamma3*(I1 - I3) */
    const double t37 = t22*p[18]; /* s*1/(s*Theta)*(4*m*R^3 - 4*m*R^3*I3/I1) */
    const double t38 = t12*t37; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*(4*m*R^3 - 4*m*R^3*I3/I1) */
    const double t39 = t36*t38; /* t36*t38 */
    const double t40 = JLT_FMS(p[11], t29, t14); /* G*J3/R*gamma3*Theta*1/(s*Theta) - C*I3*M */
    const double t41 = t12*t23; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*s*1/(s*Theta) */
    const double t42 = t40*t41; /* (G*J3/R*gamma3*Theta*1/(s*Theta) - C*I3*M)*(s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*s*1/(s*Theta) */
    const double t43 = JLT_FMA(t10, t29, p[10]); /* I1*M*C*gamma3*Theta*1/(s*Theta) + G*J1/R */
    const double t44 = JLT_FMA(t24, t43, t42); /* (gamma3*C*I3*M + s*G*J3/R)*s*1/(s*Theta)*s*1/(s*Theta)*(I1*M*C*gamma3*Theta*1/(s*Theta) + G*J1/R) + t42 */
    const double t45 = JLT_FNMA(p[8], t44, t39); /* t36*t38 - (R - R*I3/I1)*t44 */
    const double t46 = x[0]*t5; /* gamma3*S */
    const double t47 = p[20]*t46; /* (R*I3*M - R*I3^2*M/I1)*gamma3*S */
    const double t48 = t41*t47; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*s*1/(s*Theta)*(R*I3*M - R*I3^2*M/I1)*gamma3*S */
    const double t49 = t3*p[21]; /* s*(R*I3*M - R*I1*M) */
    const double t50 = t5*t49; /* S*s*(R*I3*M - R*I1*M) */
    const double t51 = JLT_FMS(t24, t50, t48); /* (gamma3*C*I3*M + s*G*J3/R)*s*1/(s*Theta)*s*1/(s*Theta)*S*s*(R*I3*M - R*I1*M) - t48 */
    const double t52 = t27*t29; /* (gamma3*C*I3*M + s*G*J3/R)*1/(s*Theta)*gamma3*Theta*1/(s*Theta) */
    const double t53 = JLT_FMA(t36, p[22], t52); /* t36*2*m*R^2 + t52 */
    const double t54 = t28*t53; /* Theta*1/(s*Theta)*(t36*2*m*R^2 + t52) */
    const double t55 = JLT_FNMA(t21, t40, t54); /* Theta*1/(s*Theta)*(t36*2*m*R^2 + t52) - 1/(s*Theta)*(G*J3/R*gamma3*Theta*1/(s*Theta) - C*I3*M) */
    const double t56 = t21*p[23]; /* 1/(s*Theta)*(-I3*M) */
    const double t57 = t46*t56; /* gamma3*S*1/(s*Theta)*(-I3*M) */
    out[0] = t8;
    out[1] = t26;
    out[2] = t27;
    out[3] = t31;
    out[4] = t32;
    out[5] = t34;
    out[6] = t45;
    out[7] = 0.0;
    out[8] = t51;
    out[9] = t55;
    out[10] = 0.0;
    out[11] = t57;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = p[2]*t2; /* I1*(1 - gamma3)*(gamma3 + 1) */
    const double t4 = x[0]*p[3]; /* gamma3*I3 */
    const double t5 = JLT_FMA(x[0], t4, t3); /* gamma3*gamma3*I3 + I1*(1 - gamma3)*(gamma3 + 1) */
    const double t6 = JLT_FMA(p[14], t5, p[13]); /* Theta = m*R^2*(gamma3*gamma3*I3 + I1*(1 - gamma3)*(gamma3 + 1)) + I1*I3 */
    const double t7 = p[7]*x[1]; /* m*R*v_slip */
    const double t8 = sin(x[2]); /* S = sin(psi) */
    const double t9 = JLT_FNMA(p[5], t8, t7); /* m*R*v_slip - M*S */
    const double t10 = p[6]*t9; /* 1/J1*(m*R*v_slip - M*S) */
    const double t11 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t12 = t6*t11; /* Theta*s */
    const double t13 = 1.0/t12; /* 1/(Theta*s) */
    const double t14 = p[12]*t11; /* I3*M*s */
    const double t15 = t13*t14; /* 1/(Theta*s)*I3*M*s */
    const double t16 = JLT_FMA(t8, t15, t10); /* S*1/(Theta*s)*I3*M*s + 1/J1*(m*R*v_slip - M*S) */
    const double t17 = x[0]*t6; /* gamma3*Theta */
    const double t18 = t13*t17; /* 1/(Theta*s)*gamma3*Theta */
    const double t19 = t16*t18; /* (S*1/(Theta*s)*I3*M*s + 1/J1*(m*R*v_slip - M*S))*1/(Theta*s)*gamma3*Theta */
    const double t20 = -t19; /* -t19 */
    out[0] = t20;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[24]*x[1]; /* m*I1^2*v_slip */
    const double t1 = x[1]*t0; /* v_slip*m*I1^2*v_slip */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = p[2]*t4; /* I1*(1 - gamma3)*(1 + gamma3) */
    const double t6 = x[0]*p[3]; /* gamma3*I3 */
    const double t7 = JLT_FMA(x[0], t6, t5); /* gamma3*gamma3*I3 + I1*(1 - gamma3)*(1 + gamma3) */
    const double t8 = JLT_FMA(p[14], t7, p[13]); /* Theta = m*R^2*(gamma3*gamma3*I3 + I1*(1 - gamma3)*(1 + gamma3)) + I1*I3 */
    const double t9 = 1.0/t8; /* 1/Theta */
    const double t10 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t11 = cos(x[2]); /* C = cos(psi) */
    const double t12 = p[9]*t10; /* I1*M*s */
    const double t13 = t11*t12; /* C*I1*M*s */
    const double t14 = JLT_FNMA(x[0], p[10], t13); /* C*I1*M*s - gamma3*G*J1/R */
    const double t15 = p[19]*t9; /* (I1 - I3)*1/Theta */
    const double t16 = t14*t15; /* (C*I1*M*s - gamma3*G*J1/R)*(I1 - I3)*1/Theta */
    const double t17 = JLT_FMA(t14, t16, t1); /* (C*I1*M*s - gamma3*G*J1/R)*(C*I1*M*s - gamma3*G*J1/R)*(I1 - I3)*1/Theta + v_slip*m*I1^2*v_slip */
    out[0] = t17;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = cos(x[2]); /* C = cos(psi) */
    const double t5 = p[9]*t4; /* I1*M*C */
    const double t6 = t3*t5; /* s*I1*M*C */
    const double t7 = JLT_FNMA(x[0], p[10], t6); /* s*I1*M*C - gamma3*G*J1/R */
    const double t8 = t2*p[2]; /* (1 - gamma3)*(1 + gamma3)*I1 */
    const double t9 = x[0]*p[3]; /* gamma3*I3 */
    const double t10 = JLT_FMA(x[0], t9, t8); /* gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1 */
    const double t11 = JLT_FMA(p[14], t10, p[13]); /* Theta = m*R^2*(gamma3*gamma3*I3 + (1 - gamma3)*(1 + gamma3)*I1) + I1*I3 */
    const double t12 = t3*t11; /* s*Theta */
    const double t13 = 1.0/t12; /* 1/(s*Theta) */
    const double t14 = t3*t13; /* s*1/(s*Theta) */
    const double t15 = t7*t14; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta) */
    const double t16 = x[0]*p[25]; /* gamma3*2*m*R^2*(I1 - I3)^2 */
    const double t17 = t15*t16; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*gamma3*2*m*R^2*(I1 - I3)^2 */
    const double t18 = x[0]*t11; /* gamma3*Theta */
    const double t19 = t13*t18; /* 1/(s*Theta)*gamma3*Theta */
    const double t20 = JLT_FMA(t5, t19, p[10]); /* I1*M*C*1/(s*Theta)*gamma3*Theta + G*J1/R */
    const double t21 = JLT_FNMA(p[26], t20, t17); /* t17 - (2*I1 - 2*I3)*(I1*M*C*1/(s*Theta)*gamma3*Theta + G*J1/R) */
    const double t22 = t15*t21; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*t21 */
    const double t23 = p[27]*x[1]; /* 2*m*I1^2*v_slip */
    const double t24 = sin(x[2]); /* S = sin(psi) */
    const double t25 = t3*p[28]; /* s*(-2*I1*M*(I1 - I3)) */
    const double t26 = t24*t25; /* S*s*(-2*I1*M*(I1 - I3)) */
    const double t27 = t15*t26; /* (s*I1*M*C - gamma3*G*J1/R)*s*1/(s*Theta)*S*s*(-2*I1*M*(I1 - I3)) */
    out[0] = t22;
    out[1] = t23;
    out[2] = t27;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double u12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double u18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
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
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t9[k] = p[7]*x1[k];
        t12[k] = jlt_jet_sine(x2, t12, u12, k);
        t13[k] = t9[k] - p[5]*t12[k];
        t14[k] = p[6]*t6[k];
        t15[k] = jlt_jet_product(t13, t14, k);
        t18[k] = jlt_jet_cosine(x2, t18, u18, k);
        t19[k] = t6[k]*p[9];
        t20[k] = jlt_jet_product(t18, t19, k);
        t22[k] = t20[k] - x0[k]*p[10];
        t24[k] = t6[k]*p[11];
        t26[k] = x0[k]*p[12];
        t27[k] = jlt_jet_product(t18, t26, k) + t24[k];
        t31[k] = t5[k]*p[2];
        t33[k] = x0[k]*p[3];
        t34[k] = jlt_jet_product(x0, t33, k) + t31[k];
        t35[k] = p[14]*t34[k] + (k == 0 ? p[13] : 0);
        t36[k] = jlt_jet_product(t6, t35, k);
        t37[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t36, t37, k);
        t38[k] = jlt_jet_product(t6, t37, k);
        t39[k] = jlt_jet_product(t27, t38, k);
        t40[k] = p[8]*t38[k];
        t41[k] = jlt_jet_product(t22, t40, k);
        t42[k] = jlt_jet_product(t39, t41, k);
        t43[k] = jlt_jet_product(t35, t37, k);
        t44[k] = jlt_jet_product(t39, t43, k);
        double *restrict next = coefficients + (k + 1)*3;
        next[0] = x0[k + 1] = t15[k]/(k + 1);
        next[1] = x1[k + 1] = t42[k]/(k + 1);
        next[2] = x2[k + 1] = t44[k]/(k + 1);
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

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_slip", "m/s", "velocity of the contact point along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "psi", "rad", "angle of the horizontal momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_balanced_general = {
    .model = "spherical_top_balanced",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on levels of Jellett's integral and of the horizontal momentum",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "70ff20361cc8550a994847ce02cbc8dfe6b50b8424b0daf5121bfd70d4951a10",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_balanced,
    .state_count = 3, .param_count = 6, .block_count = 29,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 3, { 2, 18, 5, 1, 1, 2, 11, 7 }, { 12, 51, 0, 9, 1, 2, 12, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 9, { 3, 36, 12, 1, 1, 2, 14, 15 }, { 42, 199, 0, 38, 1, 2, 17, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 12, { 3, 39, 12, 1, 1, 2, 14, 15 }, { 49, 237, 0, 47, 1, 2, 17, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 11, 4, 1, 1, 1, 11, 6 }, { 7, 20, 0, 2, 1, 1, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 2, 9, 4, 1, 1, 1, 9, 5 }, { 7, 22, 0, 2, 1, 1, 10, 7 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 3, { 2, 17, 5, 1, 1, 2, 12, 7 }, { 13, 53, 0, 8, 1, 2, 13, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_general_baseline,
        &jlt_batch_spherical_top_balanced_general_avx2,
        &jlt_batch_spherical_top_balanced_general_avx512,
    },
};
