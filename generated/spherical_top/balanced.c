/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   18    6    1    1    0     10    7   (72)
 *  jacobian            6   40   13    1    1    0     13   11   (239)
 *  rhs_jacobian        10   44   14    1    1    0     13   15   (293)
 *  divergence          3   10    3    1    1    0      8    5   (33)
 *  integral_values     3   14    9    0    1    0      8    8   (58)
 *  integral_gradients  3   20    7    1    1    0      6    7   (85)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in m*R^2*I1 - m*R^2*I3, 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1),
 *      V/R = (1/R)*v_nu + omega_tau, a part of d(d(omega_n)/dt)/d(gamma3), d(omega3)/dt,
 *      omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, a part of d(omega_tau)/dt,
 *      a part of d(d(omega_tau)/dt)/d(omega_n), gamma3*gamma3*((1)/s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s - s,
 *      d(d(omega_n)/dt)/d(gamma3), d(omega_n)/dt, d(d(omega3)/dt)/d(gamma3),
 *      omega3 + gamma3*omega_n*((1)/s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s, d(d(v_nu)/dt)/d(omega_n),
 *      d(d(omega_n)/dt)/d(omega_tau), d(d(omega3)/dt)/d(omega_tau)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_claim jlt_claims_spherical_top[];
extern const jlt_descriptor *const jlt_family_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced;
extern const struct jlt_ball_table jlt_balls_spherical_top_general;
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
    out[29] = t1;
    const double t2 = params[5]/t1; /* I3/(m*R*R) */
    out[6] = t2;
    const double t3 = params[5]/params[4]; /* I3/I1 */
    out[7] = t3;
    const double t4 = t1*params[4]; /* m*R*R*I1 */
    const double t5 = params[5]*params[5]; /* I3*I3 */
    const double t6 = t1*params[5]; /* m*R*R*I3 */
    const double t7 = t5 + t6; /* I3*I3 + m*R*R*I3 */
    const double t8 = t7/t4; /* (I3*I3 + m*R*R*I3)/(m*R*R*I1) */
    out[8] = t8;
    const double t9 = 1.0/params[1]; /* 1/R */
    out[9] = t9;
    const double t10 = params[4] - params[5]; /* I1 - I3 */
    const double t11 = t10/params[4]; /* (I1 - I3)/I1 */
    out[10] = t11;
    const double t12 = params[1]*2.0; /* R*2 */
    out[11] = t12;
    const double t13 = -t3; /* -I3/I1 */
    out[12] = t13;
    const double t14 = params[0]*params[0]; /* m*m */
    const double t15 = t0*t0; /* R*R*R*R */
    const double t16 = t14*t15; /* m*m*R*R*R*R */
    const double t17 = params[4]*params[4]; /* I1*I1 */
    const double t18 = t16*t17; /* m*m*R*R*R*R*I1*I1 */
    const double t19 = t7*2.0; /* (I3*I3 + m*R*R*I3)*2 */
    const double t20 = t4 - t6; /* m*R*R*I1 - m*R*R*I3 */
    out[18] = t20;
    const double t21 = t19*t20; /* (I3*I3 + m*R*R*I3)*2*(m*R*R*I1 - m*R*R*I3) */
    const double t22 = t21/t18; /* (I3*I3 + m*R*R*I3)*2*(m*R*R*I1 - m*R*R*I3)/(m*m*R*R*R*R*I1*I1) */
    out[13] = t22;
    const double t23 = t1*t17; /* m*R*R*I1*I1 */
    const double t24 = params[5]*2.0; /* I3*2 */
    const double t25 = t20*t24; /* (m*R*R*I1 - m*R*R*I3)*I3*2 */
    const double t26 = t25/t23; /* (m*R*R*I1 - m*R*R*I3)*I3*2/(m*R*R*I1*I1) */
    out[14] = t26;
    const double t27 = params[1]*params[4]; /* R*I1 */
    out[25] = t27;
    const double t28 = params[5]/t27; /* I3/(R*I1) */
    out[21] = t28;
    const double t29 = -t28; /* -I3/(R*I1) */
    out[15] = t29;
    const double t30 = 2.0*t20; /* 2*(m*R*R*I1 - m*R*R*I3) */
    const double t31 = t30/t4; /* 2*(m*R*R*I1 - m*R*R*I3)/(m*R*R*I1) */
    out[16] = t31;
    const double t32 = (-1.0)/params[1]; /* (-1)/R */
    out[17] = t32;
    const double t33 = t24/t23; /* I3*2/(m*R*R*I1*I1) */
    out[19] = t33;
    const double t34 = t19/t18; /* (I3*I3 + m*R*R*I3)*2/(m*m*R*R*R*R*I1*I1) */
    out[20] = t34;
    const double t35 = params[4]/2.0; /* I1/2 */
    out[22] = t35;
    const double t36 = params[0]/params[4]; /* m/I1 */
    out[23] = t36;
    const double t37 = t1/params[4]; /* m*R*R/I1 */
    out[24] = t37;
    const double t38 = params[1]*params[5]; /* R*I3 */
    out[26] = t38;
    const double t39 = params[0]*t17; /* m*I1*I1 */
    out[27] = t39;
    const double t40 = t4*t10; /* m*R*R*I1*(I1 - I3) */
    out[28] = t40;
    const double t41 = -t27; /* -R*I1 */
    out[30] = t41;
    const double t42 = -t38; /* -R*I3 */
    out[31] = t42;
    const double t43 = t10*(-2.0); /* (I1 - I3)*(-2) */
    const double t44 = t20*t43; /* (m*R*R*I1 - m*R*R*I3)*(I1 - I3)*(-2) */
    out[32] = t44;
    const double t45 = params[0]*2.0; /* m*2 */
    const double t46 = t17*t45; /* I1*I1*m*2 */
    out[33] = t46;
    const double t47 = params[1]*t45; /* R*m*2 */
    const double t48 = t17*t47; /* I1*I1*R*m*2 */
    out[34] = t48;
    const double t49 = t0*t45; /* R*R*m*2 */
    const double t50 = params[4]*t49; /* I1*R*R*m*2 */
    const double t51 = t10*t50; /* (I1 - I3)*I1*R*R*m*2 */
    out[35] = t51;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    out[0] = t4;
    const double t5 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t6 = t2 + p[6]; /* s^2 + I3/(m*R^2) */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s^2 + I3/(m*R^2) */
    const double t8 = t2*t7; /* s^2*Theta/(m*R^2*I1) */
    const double t9 = 1.0/t8; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t10 = x[0]*t3; /* gamma3*s */
    const double t11 = x[3]*t7; /* omega_n*Theta/(m*R^2*I1) */
    const double t12 = t10*t11; /* gamma3*s*omega_n*Theta/(m*R^2*I1) */
    const double t13 = t9*t12; /* 1/(s^2*Theta/(m*R^2*I1))*gamma3*s*omega_n*Theta/(m*R^2*I1) */
    const double t14 = x[4] + t13; /* omega3 + 1/(s^2*Theta/(m*R^2*I1))*gamma3*s*omega_n*Theta/(m*R^2*I1) */
    const double t15 = p[1]*x[3]; /* R*omega_n */
    const double t16 = t14*t15; /* t14*R*omega_n */
    out[1] = t16;
    const double t17 = JLT_FMA(x[4], p[7], t13); /* omega3*I3/I1 + 1/(s^2*Theta/(m*R^2*I1))*gamma3*s*omega_n*Theta/(m*R^2*I1) */
    const double t18 = x[3]*t17; /* omega_n*t17 */
    const double t19 = -t18; /* -omega_n*t17 */
    out[2] = t19;
    const double t20 = t2*t9; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t21 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t22 = t20*t21; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t23 = p[8]*t22; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t24 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t25 = t20*t24; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t26 = JLT_FNMA(p[7], t25, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t27 = JLT_FMA(t13, t26, t23); /* 1/(s^2*Theta/(m*R^2*I1))*gamma3*s*omega_n*Theta/(m*R^2*I1)*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) + t23 */
    out[3] = t27;
    const double t28 = x[3]*t25; /* omega_n*1/(Theta/(m*R^2*I1))*V/R */
    const double t29 = t10*p[10]; /* gamma3*s*(I1 - I3)/I1 */
    const double t30 = JLT_FMS(t22, t29, t28); /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*gamma3*s*(I1 - I3)/I1 - omega_n*1/(Theta/(m*R^2*I1))*V/R */
    out[4] = t30;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    const double t0 = p[1]*x[3]; /* R*omega_n */
    out[9] = t0;
    const double t1 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    out[14] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t5 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t6 = p[6] + t4; /* I3/(m*R^2) + s^2 */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t8 = t4*t7; /* s^2*Theta/(m*R^2*I1) */
    const double t9 = 1.0/t8; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t10 = sqrt(t4); /* s = sqrt(s^2) */
    out[2] = t10;
    const double t11 = t7*t10; /* Theta/(m*R^2*I1)*s */
    const double t12 = t9*t11; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t13 = t4*t9; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t14 = p[10]*t10; /* (I1 - I3)/I1*s */
    const double t15 = x[0]*t12; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t16 = x[0]*t13; /* gamma3*1/(Theta/(m*R^2*I1)) */
    const double t17 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t18 = t13*t17; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t19 = -t18; /* -1/(Theta/(m*R^2*I1))*V/R */
    out[23] = t19;
    const double t20 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t21 = x[3]*p[16]; /* omega_n*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t22 = t18*t21; /* 1/(Theta/(m*R^2*I1))*V/R*omega_n*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t23 = p[10]*t15; /* (I1 - I3)/I1*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t24 = t14*t16; /* (I1 - I3)/I1*s*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t25 = JLT_FNMA(p[16], t24, t23); /* t23 - 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1)*(I1 - I3)/I1*s*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t26 = JLT_FMA(t20, t25, t22); /* omega_tau*omega3*t25 + t22 */
    const double t27 = t13*t20; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t28 = t16*t26; /* gamma3*1/(Theta/(m*R^2*I1))*(omega_tau*omega3*t25 + t22) */
    const double t29 = JLT_FMS(t14, t27, t28); /* (I1 - I3)/I1*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 - gamma3*1/(Theta/(m*R^2*I1))*(omega_tau*omega3*t25 + t22) */
    out[20] = t29;
    const double t30 = x[2]*t24; /* omega_tau*(I1 - I3)/I1*s*gamma3*1/(Theta/(m*R^2*I1)) */
    out[24] = t30;
    const double t31 = x[3]*t12; /* omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t32 = p[13]*t16; /* 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t33 = t27*t32; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*t32 */
    const double t34 = p[14]*t18; /* 2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2)*1/(Theta/(m*R^2*I1))*V/R */
    const double t35 = t16*t34; /* gamma3*1/(Theta/(m*R^2*I1))*t34 */
    const double t36 = JLT_FNMA(p[7], t18, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t37 = t15*t36; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    out[18] = t37;
    const double t38 = x[2]*t15; /* omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t39 = -t38; /* -omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    out[0] = t39;
    const double t40 = t12*t31; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t41 = t12*t40; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t40 */
    const double t42 = t31*t40; /* omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t40 */
    const double t43 = x[0]*t31; /* gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t44 = JLT_FNMA(t35, t43, t33); /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*t32 - gamma3*1/(Theta/(m*R^2*I1))*t34*gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t45 = JLT_FMA(t36, t41, t44); /* (omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R)*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t40 + t44 */
    out[15] = t45;
    const double t46 = p[1]*t42; /* R*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t40 */
    out[5] = t46;
    const double t47 = -t42; /* -omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t40 */
    out[10] = t47;
    const double t48 = p[8]*t13; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t49 = x[2]*t48; /* omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    out[19] = t49;
    const double t50 = JLT_FMA(x[4], t48, t43); /* omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) + gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t51 = p[1]*x[4]; /* R*omega3 */
    const double t52 = JLT_FMA(p[11], t43, t51); /* 2*R*gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s + R*omega3 */
    out[8] = t52;
    const double t53 = x[4]*p[12]; /* omega3*(-I3/I1) */
    const double t54 = JLT_FMA((-2.0), t43, t53); /* (-2)*gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s + omega3*(-I3/I1) */
    out[13] = t54;
    const double t55 = t13*t43; /* 1/(Theta/(m*R^2*I1))*gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t56 = JLT_FNMA(p[7], t55, t50); /* t50 - I3/I1*t55 */
    out[17] = t56;
    const double t57 = p[15]*t55; /* (-I3/(R*I1))*t55 */
    out[16] = t57;
    const double t58 = x[3]*t13; /* omega_n*1/(Theta/(m*R^2*I1)) */
    const double t59 = JLT_FMS(x[4], t24, t58); /* omega3*(I1 - I3)/I1*s*gamma3*1/(Theta/(m*R^2*I1)) - omega_n*1/(Theta/(m*R^2*I1)) */
    out[22] = t59;
    const double t60 = p[17]*t58; /* (-1/R)*omega_n*1/(Theta/(m*R^2*I1)) */
    out[21] = t60;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    const double t0 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    out[19] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t4 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t5 = p[6] + t3; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(x[0], t4, t5); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t7 = t3*t6; /* s^2*Theta/(m*R^2*I1) */
    const double t8 = 1.0/t7; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t9 = sqrt(t3); /* s = sqrt(s^2) */
    out[7] = t9;
    const double t10 = t6*t9; /* Theta/(m*R^2*I1)*s */
    const double t11 = t8*t10; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t12 = t3*t8; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t13 = x[2]*t9; /* omega_tau*s */
    out[0] = t13;
    const double t14 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t15 = t12*t14; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t16 = -t15; /* -1/(Theta/(m*R^2*I1))*V/R */
    out[28] = t16;
    const double t17 = x[3]*t11; /* omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t18 = x[4]*t12; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t19 = x[0]*p[10]; /* gamma3*(I1 - I3)/I1 */
    const double t20 = t9*t19; /* s*gamma3*(I1 - I3)/I1 */
    const double t21 = x[0]*t17; /* gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t22 = x[2]*t18; /* omega_tau*omega3*1/(Theta/(m*R^2*I1)) */
    const double t23 = p[19]*t15; /* 2*I3/(m*R^2*I1^2)*1/(Theta/(m*R^2*I1))*V/R */
    const double t24 = t21*t23; /* gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*2*I3/(m*R^2*I1^2)*1/(Theta/(m*R^2*I1))*V/R */
    const double t25 = JLT_FNMA(p[20], t22, t24); /* t24 - 2*(I3^2 + m*R^2*I3)/(m^2*R^4*I1^2)*omega_tau*omega3*1/(Theta/(m*R^2*I1)) */
    const double t26 = x[4]*p[7]; /* omega3*I3/I1 */
    const double t27 = t20*t22; /* s*gamma3*(I1 - I3)/I1*omega_tau*omega3*1/(Theta/(m*R^2*I1)) */
    const double t28 = JLT_FNMA(x[3], t15, t27); /* s*gamma3*(I1 - I3)/I1*omega_tau*omega3*1/(Theta/(m*R^2*I1)) - omega_n*1/(Theta/(m*R^2*I1))*V/R */
    out[4] = t28;
    const double t29 = JLT_FNMA(p[7], t15, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t30 = x[0]*t12; /* gamma3*1/(Theta/(m*R^2*I1)) */
    const double t31 = t21 + t26; /* gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s + omega3*I3/I1 */
    const double t32 = x[3]*t31; /* omega_n*t31 */
    const double t33 = -t32; /* -omega_n*t31 */
    out[2] = t33;
    const double t34 = JLT_FMA(2.0, t21, t26); /* 2*gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s + omega3*I3/I1 */
    const double t35 = -t34; /* -t34 */
    out[18] = t35;
    const double t36 = x[0]*t11; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t37 = JLT_FMS(x[0], t36, t9); /* gamma3*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s - s */
    const double t38 = t29*t36; /* (omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R)*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    out[23] = t38;
    const double t39 = x[2]*t36; /* omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t40 = -t39; /* -omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    out[5] = t40;
    const double t41 = t11*t17; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t42 = t17*t41; /* omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t41 */
    const double t43 = t11*t41; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t41 */
    const double t44 = p[1]*t42; /* R*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t41 */
    out[10] = t44;
    const double t45 = -t42; /* -omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t41 */
    out[15] = t45;
    const double t46 = p[18]*t30; /* (m*R^2*I1 - m*R^2*I3)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t47 = t25*t46; /* t25*(m*R^2*I1 - m*R^2*I3)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t48 = JLT_FMS(t29, t43, t47); /* (omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R)*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t41 - t25*(m*R^2*I1 - m*R^2*I3)*gamma3*1/(Theta/(m*R^2*I1)) */
    out[20] = t48;
    const double t49 = p[16]*t30; /* 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t50 = t28*t49; /* t28*t49 */
    const double t51 = t21*t29; /* gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    const double t52 = JLT_FMA(p[8], t22, t51); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*omega3*1/(Theta/(m*R^2*I1)) + t51 */
    out[3] = t52;
    const double t53 = p[10]*t22; /* (I1 - I3)/I1*omega_tau*omega3*1/(Theta/(m*R^2*I1)) */
    const double t54 = JLT_FNMA(t37, t53, t50); /* t28*t49 - t37*(I1 - I3)/I1*omega_tau*omega3*1/(Theta/(m*R^2*I1)) */
    out[25] = t54;
    const double t55 = x[4] + t21; /* omega3 + gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t56 = x[3]*p[1]; /* omega_n*R */
    out[14] = t56;
    const double t57 = t55*t56; /* t55*omega_n*R */
    out[1] = t57;
    const double t58 = x[4]*p[1]; /* omega3*R */
    const double t59 = JLT_FMA(p[11], t21, t58); /* 2*R*gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s + omega3*R */
    out[13] = t59;
    const double t60 = t12*t21; /* 1/(Theta/(m*R^2*I1))*gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t61 = JLT_FMA(p[8], t18, t21); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega3*1/(Theta/(m*R^2*I1)) + gamma3*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t62 = JLT_FNMA(p[7], t60, t61); /* t61 - I3/I1*t60 */
    out[22] = t62;
    const double t63 = p[15]*t60; /* (-I3/(R*I1))*t60 */
    out[21] = t63;
    const double t64 = x[2]*t12; /* omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t65 = x[3]*t12; /* omega_n*1/(Theta/(m*R^2*I1)) */
    const double t66 = JLT_FMS(t18, t20, t65); /* omega3*1/(Theta/(m*R^2*I1))*s*gamma3*(I1 - I3)/I1 - omega_n*1/(Theta/(m*R^2*I1)) */
    out[27] = t66;
    const double t67 = p[17]*t65; /* (-1/R)*omega_n*1/(Theta/(m*R^2*I1)) */
    out[26] = t67;
    const double t68 = t20*t64; /* s*gamma3*(I1 - I3)/I1*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[29] = t68;
    const double t69 = p[8]*t64; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[24] = t69;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t4 = p[6] + t2; /* I3/(m*R^2) + s^2 */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t6 = t2*t5; /* s^2*Theta/(m*R^2*I1) */
    const double t7 = 1.0/t6; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t8 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t9 = p[21]*t8; /* I3/(R*I1)*V */
    const double t10 = t5*t9; /* Theta/(m*R^2*I1)*I3/(R*I1)*V */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    const double t12 = x[0]*t2; /* gamma3*s^2 */
    const double t13 = t11*t12; /* s*gamma3*s^2 */
    const double t14 = t7*t13; /* 1/(s^2*Theta/(m*R^2*I1))*s*gamma3*s^2 */
    const double t15 = p[10]*x[2]; /* (I1 - I3)/I1*omega_tau */
    const double t16 = JLT_FNMA(t7, t10, t15); /* (I1 - I3)/I1*omega_tau - 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*I3/(R*I1)*V */
    const double t17 = t14*t16; /* 1/(s^2*Theta/(m*R^2*I1))*s*gamma3*s^2*t16 */
    out[0] = t17;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[23]*x[1]; /* m/I1*v_nu */
    const double t1 = x[3]*x[3]; /* omega_n*omega_n */
    const double t2 = x[4]*x[4]; /* omega3*omega3 */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = t3*t4; /* (1 - gamma3)*(1 + gamma3) */
    const double t6 = sqrt(t5); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = x[4]*t6; /* omega3*s */
    const double t8 = JLT_FMA(x[3], x[0], t7); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t9 = p[24]*t8; /* m*R^2/I1*v_tau/R */
    const double t10 = JLT_FMA(x[2], x[2], t1); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t11 = JLT_FMA(x[1], t0, t10); /* v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t12 = JLT_FMA(p[7], t2, t11); /* I3/I1*omega3*omega3 + v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t13 = JLT_FMA(t8, t9, t12); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t12 */
    const double t14 = p[22]*t13; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t14;
    const double t15 = x[3]*p[25]; /* omega_n*R*I1 */
    const double t16 = t6*t15; /* s*omega_n*R*I1 */
    const double t17 = x[4]*p[26]; /* omega3*R*I3 */
    const double t18 = JLT_FNMA(x[0], t17, t16); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    out[1] = t18;
    const double t19 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t20 = p[27]*t19; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t21 = t19*t20; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t22 = p[7]*x[0]; /* I3/I1*gamma3 */
    const double t23 = t5 + p[6]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t24 = JLT_FMA(x[0], t22, t23); /* Theta/(m*R^2*I1) = gamma3*I3/I1*gamma3 + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t25 = t2*p[28]; /* omega3*omega3*m*R^2*I1*(I1 - I3) */
    const double t26 = JLT_FMA(t24, t25, t21); /* Theta/(m*R^2*I1)*omega3*omega3*m*R^2*I1*(I1 - I3) + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[2] = t26;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[7] = 0.0;
    out[13] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t1;
    const double t2 = x[0]*p[31]; /* gamma3*(-R*I3) */
    out[9] = t2;
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = t3*t4; /* (1 - gamma3)*(1 + gamma3) */
    const double t6 = sqrt(t5); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = p[6] + t5; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t8 = p[25]*t6; /* R*I1*s */
    out[8] = t8;
    const double t9 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t10 = 1.0/t6; /* 1/s */
    const double t11 = x[0]*x[4]; /* gamma3*omega3 */
    const double t12 = JLT_FMA(x[4], t6, t9); /* v_tau/R = omega3*s + omega_n*gamma3 */
    const double t13 = p[30]*t9; /* (-R*I1)*omega_n*gamma3 */
    const double t14 = p[29]*t12; /* m*R^2*v_tau/R */
    const double t15 = t10*t13; /* 1/s*(-R*I1)*omega_n*gamma3 */
    const double t16 = JLT_FMA(x[4], p[31], t15); /* omega3*(-R*I3) + 1/s*(-R*I1)*omega_n*gamma3 */
    out[5] = t16;
    const double t17 = JLT_FNMA(t10, t11, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - 1/s*gamma3*omega3 */
    const double t18 = t14*t17; /* m*R^2*v_tau/R*d(v_tau)/d(gamma3)/R */
    out[0] = t18;
    const double t19 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t20 = JLT_FMA(x[0], t19, t7); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t21 = x[3]*p[4]; /* omega_n*I1 */
    const double t22 = JLT_FMA(x[0], t14, t21); /* d(energy)/d(omega_n) = gamma3*m*R^2*v_tau/R + omega_n*I1 */
    out[3] = t22;
    const double t23 = x[4]*p[5]; /* omega3*I3 */
    const double t24 = JLT_FMA(t6, t14, t23); /* d(energy)/d(omega3) = s*m*R^2*v_tau/R + omega3*I3 */
    out[4] = t24;
    const double t25 = x[4]*p[32]; /* omega3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    const double t26 = t11*t25; /* gamma3*omega3*omega3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    out[10] = t26;
    const double t27 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t28 = p[33]*t27; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[11] = t28;
    const double t29 = p[34]*t27; /* 2*m*R*I1^2*(omega_tau*R + v_nu) */
    out[12] = t29;
    const double t30 = x[4]*p[35]; /* omega3*2*m*R^2*I1*(I1 - I3) */
    const double t31 = t20*t30; /* Theta/(m*R^2*I1)*omega3*2*m*R^2*I1*(I1 - I3) */
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
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
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
    coefficients[4] = x4[0] = x[4];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t11[k] = jlt_jet_product(x0, x3, k);
        t12[k] = jlt_jet_quotient(t11[k], t6, t12, k);
        t13[k] = x4[k] + t12[k];
        t14[k] = p[1]*x3[k];
        t15[k] = jlt_jet_product(t13, t14, k);
        t17[k] = x4[k]*p[7] + t12[k];
        t18[k] = jlt_jet_product(x3, t17, k);
        t19[k] = -t18[k];
        t22[k] = x0[k]*p[7];
        t23[k] = t5[k] + (k == 0 ? p[6] : 0);
        t24[k] = jlt_jet_product(x0, t22, k) + t23[k];
        t25[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t24, t25, k);
        t26[k] = jlt_jet_product(x2, x4, k);
        t27[k] = jlt_jet_product(t25, t26, k);
        t28[k] = p[8]*t27[k];
        t31[k] = p[9]*x1[k] + x2[k];
        t32[k] = jlt_jet_product(t25, t31, k);
        t33[k] = x2[k] - p[7]*t32[k];
        t34[k] = jlt_jet_product(t12, t33, k) + t28[k];
        t35[k] = jlt_jet_product(x3, t32, k);
        t37[k] = x0[k]*p[10];
        t38[k] = jlt_jet_product(t6, t37, k);
        t39[k] = jlt_jet_product(t27, t38, k) - t35[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t15[k]/(k + 1);
        next[2] = x2[k + 1] = t19[k]/(k + 1);
        next[3] = x3[k + 1] = t34[k]/(k + 1);
        next[4] = x4[k + 1] = t39[k]/(k + 1);
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
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t6 = t4*t5; /* (1 - gamma3)*(1 + gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
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
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = params[4]*t3; /* I1*s */
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
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
    out[0] = t16;
    const double t17 = params[0]*params[1]; /* m*R */
    const double t18 = params[4]*t17; /* I1*m*R */
    const double t19 = params[5]*t18; /* I3*I1*m*R */
    const double t20 = x[0]*t19; /* gamma3*I3*I1*m*R */
    const double t21 = t20*x[1]; /* gamma3*I3*I1*m*R*v_nu */
    out[1] = t21;
    const double t22 = params[5]*params[5]; /* I3*I3 */
    const double t23 = x[4]*x[4]; /* omega3*omega3 */
    const double t24 = t22*t23; /* I3*I3*omega3*omega3 */
    const double t25 = t3*t24; /* s*I3*I3*omega3*omega3 */
    const double t26 = params[5] + t7; /* I3 + m*R*R */
    const double t27 = t25*t26; /* s*I3*I3*omega3*omega3*(I3 + m*R*R) */
    out[2] = t27;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[24] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t3;
    const double t4 = params[1]*x[4]; /* R*omega3 */
    out[8] = t4;
    const double t5 = x[4]*params[5]; /* omega3*I3 */
    const double t6 = t5/params[4]; /* omega3*I3/I1 */
    const double t7 = -t6; /* -omega3*I3/I1 */
    out[13] = t7;
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
    out[17] = t21;
    const double t22 = params[1]*params[0]; /* R*m */
    const double t23 = params[5]*t22; /* I3*R*m */
    const double t24 = x[0]*t23; /* gamma3*I3*R*m */
    const double t25 = t24*x[1]; /* gamma3*I3*R*m*v_nu */
    const double t26 = t3*t18; /* s*Theta */
    const double t27 = t25/t26; /* gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t28 = -t27; /* -gamma3*I3*R*m*v_nu/(s*Theta) */
    out[18] = t28;
    const double t29 = x[0]*t10; /* gamma3*m*R*R */
    const double t30 = x[4]*t29; /* omega3*gamma3*m*R*R */
    const double t31 = t3*t30; /* s*omega3*gamma3*m*R*R */
    const double t32 = params[4] - params[5]; /* I1 - I3 */
    const double t33 = t31*t32; /* s*omega3*gamma3*m*R*R*(I1 - I3) */
    const double t34 = t33/t18; /* s*omega3*gamma3*m*R*R*(I1 - I3)/Theta */
    out[22] = t34;
    const double t35 = params[4]*t22; /* I1*R*m */
    const double t36 = x[1]*t35; /* v_nu*I1*R*m */
    const double t37 = t36/t18; /* v_nu*I1*R*m/Theta */
    const double t38 = -t37; /* -v_nu*I1*R*m/Theta */
    out[23] = t38;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[2] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[13] = 0.0;
    const double t0 = params[1]*x[4]; /* R*omega3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* (1 - gamma3)*(1 + gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t5 = t0*t4; /* v_tau = R*omega3*s */
    const double t6 = params[1]*x[0]; /* R*gamma3 */
    const double t7 = params[0]*t5; /* m*v_tau */
    const double t8 = x[4]*t6; /* omega3*R*gamma3 */
    const double t9 = t8/t4; /* omega3*R*gamma3/s */
    const double t10 = t7*t9; /* m*v_tau*omega3*R*gamma3/s */
    const double t11 = -t10; /* -m*v_tau*omega3*R*gamma3/s */
    out[0] = t11;
    const double t12 = params[0]*x[1]; /* m*v_nu */
    out[1] = t12;
    const double t13 = params[0]*params[1]; /* m*R */
    const double t14 = x[0]*t13; /* gamma3*m*R */
    const double t15 = t5*t14; /* d(energy)/d(omega_n) = v_tau*gamma3*m*R */
    out[3] = t15;
    const double t16 = x[4]*params[5]; /* omega3*I3 */
    const double t17 = t4*t13; /* s*m*R */
    const double t18 = t5*t17; /* v_tau*s*m*R */
    const double t19 = t16 + t18; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    out[4] = t19;
    const double t20 = params[1]*params[4]; /* R*I1 */
    const double t21 = params[1]*params[5]; /* R*I3 */
    const double t22 = x[4]*t21; /* omega3*R*I3 */
    const double t23 = -t22; /* -omega3*R*I3 */
    out[5] = t23;
    const double t24 = t4*t20; /* s*R*I1 */
    out[8] = t24;
    const double t25 = x[0]*t21; /* gamma3*R*I3 */
    const double t26 = -t25; /* -gamma3*R*I3 */
    out[9] = t26;
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
    out[10] = t39;
    const double t40 = params[0]*2.0; /* m*2 */
    const double t41 = params[4]*params[4]; /* I1*I1 */
    const double t42 = t40*t41; /* m*2*I1*I1 */
    const double t43 = x[1]*t42; /* v_nu*m*2*I1*I1 */
    out[11] = t43;
    const double t44 = params[1]*t40; /* R*m*2 */
    const double t45 = t41*t44; /* I1*I1*R*m*2 */
    const double t46 = x[1]*t45; /* v_nu*I1*I1*R*m*2 */
    out[12] = t46;
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "G", "" },
    { "F0", "a3 = 0" },
};

static const signed char signs_7[] = { 1, -1, -1, 1, 1 };
static const jlt_reversor reversors[] = {
    { signs_7, 7 },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .scales = 1,
    .state_count = 5, .param_count = 6, .prepared_count = 36,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 5, 18, 6, 1, 1, 0, 10, 7 }, { 12, 50, 0, 9, 1, 0, 11, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3 + ((1)/s^2*Theta/(m*R^2*I1))*gamma3*s*omega_n*Theta/(m*R^2*I1), a part of d(omega_tau)/dt, V/R = (1/R)*v_nu + omega_tau, omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, d(omega_n)/dt, d(omega3)/dt" },
    .jacobian = { jacobian, 25, { 6, 40, 13, 1, 1, 0, 13, 11 }, { 36, 168, 0, 34, 1, 0, 14, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2), 2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2), 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), V/R = (1/R)*v_nu + omega_tau, a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, d(d(omega_n)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega_n), d(d(omega_tau)/dt)/d(omega_n), d(d(omega_n)/dt)/d(omega_tau), d(d(omega3)/dt)/d(omega_tau)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 44, 14, 1, 1, 0, 13, 15 }, { 44, 205, 0, 43, 1, 0, 14, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in m*R^2*I1 - m*R^2*I3, 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), V/R = (1/R)*v_nu + omega_tau, a part of d(d(omega_n)/dt)/d(gamma3), d(omega3)/dt, omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, a part of d(omega_tau)/dt, a part of d(d(omega_tau)/dt)/d(omega_n), gamma3*gamma3*((1)/s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s - s, d(d(omega_n)/dt)/d(gamma3), d(omega_n)/dt, d(d(omega3)/dt)/d(gamma3), omega3 + gamma3*omega_n*((1)/s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s, d(d(v_nu)/dt)/d(omega_n), d(d(omega_n)/dt)/d(omega_tau), d(d(omega3)/dt)/d(omega_tau)" },
    .divergence = { divergence, 1, { 3, 10, 3, 1, 1, 0, 8, 5 }, { 6, 24, 0, 2, 1, 0, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, a part of the divergence" },
    .integral_values = { integral_values, 3, { 3, 14, 9, 0, 1, 0, 8, 8 }, { 12, 45, 0, 0, 1, 0, 10, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, G, omega_tau*R + v_nu, F0" },
    .integral_gradients = { integral_gradients, 15, { 3, 20, 7, 1, 1, 0, 6, 7 }, { 15, 67, 0, 2, 1, 0, 9, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in -2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3), v_tau/R = omega3*s + omega_n*gamma3, d(G)/d(gamma3), d(v_tau)/d(gamma3)/R = omega_n - ((1)/s)*gamma3*omega3, d(E)/d(omega_n), d(E)/d(omega3), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 3, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced) },
#endif
};
