/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Eliminated: level_omega_n: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   18    5    1    1    0     12    6   (56)
 *  jacobian            5   39   16    1    1    0     15   12   (205)
 *  rhs_jacobian        8   39   16    1    1    0     15   13   (236)
 *  divergence          3   10    4    1    1    0     10    6   (36)
 *  integral_values     3   14    9    1    1    0     10    6   (58)
 *  integral_gradients  4   23   10    1    1    0     11   10   (104)
 *  eliminated          2    3    1    1    1    0      4    3   (10)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), (R*I3)*gamma3*omega3 + G_level,
 *      d(d(omega3)/dt)/d(omega_tau),
 *      a part of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3),
 *      V/R = (1/R)*v_nu + omega_tau, d(omega3)/dt,
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3),
 *      a part of d(v_nu)/dt, d(d(v_nu)/dt)/d(omega3), d(d(omega_tau)/dt)/d(omega3), d(d(omega3)/dt)/d(omega3),
 *      a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3)
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_omega_n;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_on_level_omega_n;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_omega_n_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_omega_n_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_omega_n_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[1]*params[4]; /* R*I1 */
    out[34] = t0;
    const double t1 = 1.0/t0; /* 1/(R*I1) */
    out[7] = t1;
    const double t2 = params[1]*params[5]; /* R*I3 */
    out[8] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    out[35] = t4;
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    out[9] = t5;
    const double t6 = params[5]/params[4]; /* I3/I1 */
    out[10] = t6;
    const double t7 = params[4] - params[5]; /* I1 - I3 */
    const double t8 = t7/params[4]; /* (I1 - I3)/I1 */
    out[11] = t8;
    const double t9 = 1.0/params[1]; /* 1/R */
    out[12] = t9;
    const double t10 = 1.0/params[4]; /* 1/I1 */
    out[13] = t10;
    const double t11 = params[4]*params[4]; /* I1*I1 */
    const double t12 = params[1]*t11; /* R*I1*I1 */
    const double t13 = 1.0/t12; /* 1/(R*I1*I1) */
    out[14] = t13;
    const double t14 = t2/params[4]; /* R*I3/I1 */
    out[15] = t14;
    const double t15 = params[5]*2.0; /* I3*2 */
    const double t16 = t15/t11; /* I3*2/(I1*I1) */
    out[16] = t16;
    const double t17 = t3*t11; /* R*R*I1*I1 */
    const double t18 = (-1.0)/t17; /* (-1)/(R*R*I1*I1) */
    out[17] = t18;
    const double t19 = params[5]/t12; /* I3/(R*I1*I1) */
    const double t20 = -t19; /* -I3/(R*I1*I1) */
    out[18] = t20;
    const double t21 = params[5]*(-2.0); /* I3*(-2) */
    const double t22 = t21/t12; /* I3*(-2)/(R*I1*I1) */
    out[19] = t22;
    const double t23 = params[5]*params[5]; /* I3*I3 */
    const double t24 = t23/t11; /* I3*I3/(I1*I1) */
    const double t25 = -t24; /* -I3*I3/(I1*I1) */
    out[20] = t25;
    const double t26 = params[4]*t3; /* I1*R*R */
    const double t27 = 1.0/t26; /* 1/(I1*R*R) */
    out[21] = t27;
    const double t28 = t3*t7; /* R*R*(I1 - I3) */
    out[22] = t28;
    const double t29 = params[4]*t4; /* I1*m*R*R */
    const double t30 = params[5]*t4; /* I3*m*R*R */
    const double t31 = t29 - t30; /* I1*m*R*R - I3*m*R*R */
    const double t32 = 2.0*t31; /* 2*(I1*m*R*R - I3*m*R*R) */
    const double t33 = t32/t29; /* 2*(I1*m*R*R - I3*m*R*R)/(I1*m*R*R) */
    out[23] = t33;
    const double t34 = (-1.0)/t26; /* (-1)/(I1*R*R) */
    out[24] = t34;
    const double t35 = params[5]/t0; /* I3/(R*I1) */
    out[25] = t35;
    const double t36 = params[1]*2.0; /* R*2 */
    const double t37 = params[5]*t36; /* I3*R*2 */
    const double t38 = t37/params[4]; /* I3*R*2/I1 */
    out[26] = t38;
    const double t39 = t21/params[4]; /* I3*(-2)/I1 */
    out[27] = t39;
    const double t40 = params[0]/2.0; /* m/2 */
    out[28] = t40;
    const double t41 = params[4]/2.0; /* I1/2 */
    out[29] = t41;
    const double t42 = params[5]/2.0; /* I3/2 */
    out[30] = t42;
    const double t43 = params[0]*t11; /* m*I1*I1 */
    out[31] = t43;
    const double t44 = t7*t29; /* (I1 - I3)*I1*m*R*R */
    out[32] = t44;
    const double t45 = params[1]*params[0]; /* R*m */
    const double t46 = t45/params[4]; /* R*m/I1 */
    out[33] = t46;
    const double t47 = t7*(-2.0); /* (I1 - I3)*(-2) */
    const double t48 = t31*t47; /* (I1*m*R*R - I3*m*R*R)*(I1 - I3)*(-2) */
    out[36] = t48;
    const double t49 = params[0]*2.0; /* m*2 */
    const double t50 = t11*t49; /* I1*I1*m*2 */
    out[37] = t50;
    const double t51 = params[1]*t49; /* R*m*2 */
    const double t52 = t11*t51; /* I1*I1*R*m*2 */
    out[38] = t52;
    const double t53 = t3*t49; /* R*R*m*2 */
    const double t54 = params[4]*t53; /* I1*R*R*m*2 */
    const double t55 = t7*t54; /* (I1 - I3)*I1*R*R*m*2 */
    out[39] = t55;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t4 = p[9] + t2; /* I3/(m*R^2) + s^2 */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t6 = t2*t5; /* s^2*Theta/(m*R^2*I1) */
    const double t7 = 1.0/t6; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    const double t9 = t5*t8; /* Theta/(m*R^2*I1)*s */
    const double t10 = t7*t9; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t11 = t2*t7; /* s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t12 = x[2]*t8; /* omega_tau*s */
    out[0] = t12;
    const double t13 = x[0]*x[3]; /* gamma3*omega3 */
    const double t14 = JLT_FMA(p[8], t13, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t15 = p[7]*t14; /* 1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t16 = t10*t15; /* omega_n = 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t17 = x[0]*t10; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t18 = t16*t17; /* omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t19 = p[11]*t13; /* (I1 - I3)/I1*gamma3*omega3 */
    const double t20 = t12*t19; /* omega_tau*s*(I1 - I3)/I1*gamma3*omega3 */
    const double t21 = JLT_FMA(x[3], p[10], t18); /* omega3*I3/I1 + omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t22 = x[3] + t18; /* omega3 + omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t23 = t16*t21; /* omega_n*t21 */
    const double t24 = -t23; /* -omega_n*t21 */
    out[2] = t24;
    const double t25 = JLT_FMA(p[12], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t26 = JLT_FNMA(t16, t25, t20); /* omega_tau*s*(I1 - I3)/I1*gamma3*omega3 - omega_n*V/R */
    const double t27 = t11*t26; /* s^2*1/(s^2*Theta/(m*R^2*I1))*(omega_tau*s*(I1 - I3)/I1*gamma3*omega3 - omega_n*V/R) */
    out[3] = t27;
    const double t28 = p[1]*t16; /* R*omega_n */
    const double t29 = t22*t28; /* t22*R*omega_n */
    out[1] = t29;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t5 = t2 + p[9]; /* s^2 + I3/(m*R^2) */
    const double t6 = JLT_FMA(x[0], t4, t5); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s^2 + I3/(m*R^2) */
    const double t7 = t2*t6; /* s^2*Theta/(m*R^2*I1) */
    const double t8 = 1.0/t7; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t9 = t3*t6; /* s*Theta/(m*R^2*I1) */
    const double t10 = t8*t9; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1) */
    const double t11 = x[0]*t10; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1) */
    const double t12 = x[2]*t11; /* omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1) */
    const double t13 = -t12; /* -omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1) */
    out[0] = t13;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    const double t14 = x[3]*p[8]; /* omega3*R*I3 */
    const double t15 = JLT_FMA(x[0], t14, p[6]); /* gamma3*omega3*R*I3 + G_level */
    const double t16 = t10*t15; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*(gamma3*omega3*R*I3 + G_level) */
    const double t17 = t11*t16; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t16 */
    const double t18 = t14 + t17; /* omega3*R*I3 + gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t16 */
    const double t19 = t10*t18; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t18 */
    const double t20 = x[3]*t19; /* omega3*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    const double t21 = p[13]*t20; /* 1/I1*omega3*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    const double t22 = t10*t16; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t16 */
    const double t23 = t10*t22; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t16 */
    const double t24 = t22*t23; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t16*t23 */
    const double t25 = t17*2.0; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t16*2 */
    const double t26 = JLT_FMA(t19, t25, t24); /* d(omega_n)/d(gamma3)/(1/(R*I1))*gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t16*2 + 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t16*t23 */
    const double t27 = JLT_FMA(p[14], t26, t21); /* 1/(R*I1^2)*t26 + 1/I1*omega3*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    out[4] = t27;
    const double t28 = p[13]*t16; /* 1/I1*t16 */
    const double t29 = t11*x[3]; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega3 */
    const double t30 = t11*t17; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t16 */
    const double t31 = JLT_FMA(p[15], t29, t28); /* R*I3/I1*gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega3 + 1/I1*t16 */
    const double t32 = JLT_FMA(p[16], t30, t31); /* 2*I3/I1^2*t30 + t31 */
    out[7] = t32;
    const double t33 = t26*p[17]; /* t26*(-1/(R^2*I1^2)) */
    const double t34 = JLT_FMA(t20, p[18], t33); /* omega3*d(omega_n)/d(gamma3)/(1/(R*I1))*(-I3/(R*I1^2)) + t26*(-1/(R^2*I1^2)) */
    out[8] = t34;
    const double t35 = t16*p[18]; /* t16*(-I3/(R*I1^2)) */
    const double t36 = JLT_FMA(t29, p[20], t35); /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega3*(-I3^2/I1^2) + t16*(-I3/(R*I1^2)) */
    const double t37 = JLT_FMA(t30, p[19], t36); /* t30*(-2*I3/(R*I1^2)) + t36 */
    out[11] = t37;
    const double t38 = x[2]*p[22]; /* omega_tau*R^2*(I1 - I3) */
    const double t39 = x[3]*t38; /* omega3*omega_tau*R^2*(I1 - I3) */
    const double t40 = t3*t39; /* s*omega3*omega_tau*R^2*(I1 - I3) */
    const double t41 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t42 = t2*t8; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t43 = t16*t42; /* t16*1/(Theta/(m*R^2*I1)) */
    const double t44 = t41*t43; /* V*t16*1/(Theta/(m*R^2*I1)) */
    const double t45 = x[0]*t42; /* gamma3*1/(Theta/(m*R^2*I1)) */
    const double t46 = JLT_FNMA(t40, t45, t44); /* V*t16*1/(Theta/(m*R^2*I1)) - s*omega3*omega_tau*R^2*(I1 - I3)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t47 = p[23]*t46; /* 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1)*t46 */
    const double t48 = JLT_FMA(t11, t39, t47); /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega3*omega_tau*R^2*(I1 - I3) + 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1)*t46 */
    const double t49 = JLT_FNMA(t19, t41, t40); /* s*omega3*omega_tau*R^2*(I1 - I3) - d(omega_n)/d(gamma3)/(1/(R*I1))*V */
    const double t50 = JLT_FNMA(x[0], t48, t49); /* t49 - gamma3*t48 */
    const double t51 = p[21]*t42; /* 1/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t52 = t50*t51; /* (t49 - gamma3*t48)*1/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    out[12] = t52;
    const double t53 = t43*p[24]; /* t16*1/(Theta/(m*R^2*I1))*(-1/(R^2*I1)) */
    out[13] = t53;
    const double t54 = t3*p[11]; /* s*(I1 - I3)/I1 */
    const double t55 = t45*t54; /* gamma3*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    const double t56 = x[3]*t55; /* omega3*gamma3*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    const double t57 = JLT_FNMA(t43, p[7], t56); /* omega3*gamma3*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 - t16*1/(Theta/(m*R^2*I1))*1/(R*I1) */
    out[14] = t57;
    const double t58 = x[2]*t55; /* omega_tau*gamma3*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    const double t59 = t41*p[25]; /* V*I3/(R*I1) */
    const double t60 = t42*t59; /* 1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    const double t61 = JLT_FNMA(t11, t60, t58); /* omega_tau*gamma3*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 - gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    out[15] = t61;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t4 = p[9] + t2; /* I3/(m*R^2) + s^2 */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t6 = t2*t5; /* s^2*Theta/(m*R^2*I1) */
    const double t7 = 1.0/t6; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t8;
    const double t9 = t5*t8; /* Theta/(m*R^2*I1)*s */
    const double t10 = t7*t9; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t11 = t2*t7; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t12 = x[0]*x[3]; /* gamma3*omega3 */
    const double t13 = JLT_FMA(p[8], t12, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t14 = t10*t13; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*(R*I3*gamma3*omega3 + G_level) */
    const double t15 = p[7]*t14; /* 1/(R*I1)*t14 */
    const double t16 = x[0]*t10; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t17 = x[2]*t8; /* omega_tau*s */
    out[0] = t17;
    const double t18 = t15*t16; /* 1/(R*I1)*t14*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t19 = p[11]*t11; /* (I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t20 = t17*t19; /* omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t21 = t12*t19; /* gamma3*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t22 = t12*t20; /* gamma3*omega3*omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t23 = t8*t21; /* s*gamma3*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t24 = JLT_FNMA(t11, t15, t23); /* s*gamma3*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - 1/(Theta/(m*R^2*I1))*1/(R*I1)*t14 */
    out[18] = t24;
    const double t25 = t10*t15; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*1/(R*I1)*t14 */
    const double t26 = JLT_FMA(x[3], p[10], t18); /* omega3*I3/I1 + t18 */
    const double t27 = JLT_FMA(p[12], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t28 = t11*t27; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t29 = JLT_FNMA(t15, t28, t22); /* gamma3*omega3*omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - 1/(R*I1)*t14*1/(Theta/(m*R^2*I1))*V/R */
    out[3] = t29;
    const double t30 = t15*t26; /* 1/(R*I1)*t14*(omega3*I3/I1 + t18) */
    const double t31 = -t30; /* -1/(R*I1)*t14*(omega3*I3/I1 + t18) */
    out[2] = t31;
    const double t32 = t10*t26; /* d(omega_n)/d(gamma3) = 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*(omega3*I3/I1 + t18) */
    const double t33 = t10*t25; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*1/(R*I1)*t14 */
    const double t34 = t25*t33; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*1/(R*I1)*t14*t33 */
    const double t35 = x[2]*t16; /* omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t36 = -t35; /* -omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    out[4] = t36;
    const double t37 = 2.0*t18; /* 2*t18 */
    const double t38 = JLT_FMA(t32, t37, t34); /* d(omega_n)/d(gamma3)*2*t18 + 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*1/(R*I1)*t14*t33 */
    const double t39 = x[3]*t20; /* omega3*omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t40 = JLT_FNMA(t21, t35, t39); /* omega3*omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - gamma3*omega3*(I1 - I3)/I1*1/(Theta/(m*R^2*I1))*omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t41 = x[0]*t20; /* gamma3*omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) */
    const double t42 = x[0]*p[23]; /* gamma3*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t43 = t11*t42; /* 1/(Theta/(m*R^2*I1))*gamma3*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t44 = JLT_FMA(t29, t43, t40); /* t29*t43 + t40 */
    const double t45 = JLT_FNMA(t28, t32, t44); /* t29*t43 + t40 - 1/(Theta/(m*R^2*I1))*V/R*d(omega_n)/d(gamma3) */
    out[16] = t45;
    const double t46 = x[3]*t32; /* omega3*d(omega_n)/d(gamma3) */
    const double t47 = p[24]*t11; /* (-1/(R^2*I1))*1/(Theta/(m*R^2*I1)) */
    const double t48 = t14*t47; /* t14*(-1/(R^2*I1))*1/(Theta/(m*R^2*I1)) */
    out[17] = t48;
    const double t49 = p[13]*t14; /* 1/I1*t14 */
    const double t50 = p[18]*t14; /* (-I3/(R*I1^2))*t14 */
    const double t51 = x[3]*t16; /* omega3*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t52 = JLT_FMA(p[20], t51, t50); /* (-I3^2/I1^2)*omega3*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s + (-I3/(R*I1^2))*t14 */
    const double t53 = JLT_FMA(p[15], t51, t49); /* R*I3/I1*omega3*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s + 1/I1*t14 */
    const double t54 = x[3] + t18; /* omega3 + t18 */
    const double t55 = t49*t54; /* 1/I1*t14*(omega3 + t18) */
    out[1] = t55;
    const double t56 = t16*t18; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t18 */
    const double t57 = JLT_FMA(p[26], t56, t53); /* 2*R*I3/I1*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t18 + t53 */
    out[11] = t57;
    const double t58 = JLT_FMA(p[27], t56, t52); /* (-2*I3/I1)*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t18 + t52 */
    out[15] = t58;
    const double t59 = p[10]*t16; /* I3/I1*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t60 = JLT_FNMA(t28, t59, t41); /* gamma3*omega_tau*s*(I1 - I3)/I1*1/(Theta/(m*R^2*I1)) - 1/(Theta/(m*R^2*I1))*V/R*I3/I1*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    out[19] = t60;
    const double t61 = t38 + t46; /* t38 + omega3*d(omega_n)/d(gamma3) */
    const double t62 = JLT_FMA(p[10], t46, t38); /* I3/I1*omega3*d(omega_n)/d(gamma3) + t38 */
    const double t63 = p[1]*t61; /* R*(t38 + omega3*d(omega_n)/d(gamma3)) */
    out[8] = t63;
    const double t64 = -t62; /* -(I3/I1*omega3*d(omega_n)/d(gamma3) + t38) */
    out[12] = t64;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t4 = p[9] + t2; /* I3/(m*R^2) + s^2 */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t6 = t2*t5; /* s^2*Theta/(m*R^2*I1) */
    const double t7 = 1.0/t6; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t8 = t5*t7; /* Theta/(m*R^2*I1)*1/(s^2*Theta/(m*R^2*I1)) */
    const double t9 = t2*t7; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t10 = sqrt(t2); /* s = sqrt(s^2) */
    const double t11 = x[0]*t10; /* gamma3*s */
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t13 = p[25]*t12; /* I3/(R*I1)*V */
    const double t14 = JLT_FMA(t9, t13, x[2]); /* 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V + omega_tau */
    const double t15 = p[11]*x[2]; /* (I1 - I3)/I1*omega_tau */
    const double t16 = t9*t15; /* 1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*omega_tau */
    const double t17 = JLT_FNMA(t8, t14, t16); /* 1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*omega_tau - Theta/(m*R^2*I1)*1/(s^2*Theta/(m*R^2*I1))*(1/(Theta/(m*R^2*I1))*I3/(R*I1)*V + omega_tau) */
    const double t18 = t11*t17; /* gamma3*s*t17 */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt(s^2) */
    const double t5 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t6 = JLT_FMA(x[3], t5, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t7 = p[7]*t6; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t8 = t7/t3; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)/s^2 */
    const double t9 = t4*t8; /* omega_n = s*1/(R*I1)*(omega3*gamma3*R*I3 + G_level)/s^2 */
    const double t10 = x[0]*t9; /* gamma3*omega_n */
    const double t11 = JLT_FMA(t4, x[3], t10); /* s*omega3 + gamma3*omega_n */
    const double t12 = p[1]*t11; /* v_tau = R*(s*omega3 + gamma3*omega_n) */
    const double t13 = JLT_FMA(t12, t12, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t14 = t9*t9; /* omega_n*omega_n */
    const double t15 = JLT_FMA(x[2], x[2], t14); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t16 = p[29]*t15; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t17 = x[3]*x[3]; /* omega3*omega3 */
    const double t18 = JLT_FMA(p[30], t17, t16); /* 1/2*I3*omega3*omega3 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t19 = JLT_FMA(p[28], t13, t18); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t18 */
    out[0] = t19;
    const double t20 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t21 = p[31]*t20; /* m*I1^2*(R*omega_tau + v_nu) */
    const double t22 = t20*t21; /* (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    const double t23 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t24 = t3 + p[9]; /* s^2 + I3/(m*R^2) */
    const double t25 = JLT_FMA(x[0], t23, t24); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s^2 + I3/(m*R^2) */
    const double t26 = t17*p[32]; /* omega3*omega3*m*R^2*I1*(I1 - I3) */
    const double t27 = JLT_FMA(t25, t26, t22); /* Theta/(m*R^2*I1)*omega3*omega3*m*R^2*I1*(I1 - I3) + (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    out[1] = t27;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = p[9] + t4; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t7 = x[0]*x[3]; /* gamma3*omega3 */
    const double t8 = 1.0/t5; /* 1/s */
    const double t9 = JLT_FMA(p[8], t7, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t10 = t8*t9; /* 1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t11 = x[0]*t10; /* gamma3*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t12 = t8*t11; /* 1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t13 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t14 = x[0]*t13; /* gamma3*gamma3*I3/I1 */
    const double t15 = t6 + t14; /* Theta/(m*R^2*I1) = I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) + gamma3*gamma3*I3/I1 */
    const double t16 = JLT_FMA(t8, t14, t5); /* d(v_tau)/d(omega3)/R = 1/s*gamma3*gamma3*I3/I1 + s */
    const double t17 = x[3]*t5; /* omega3*s */
    const double t18 = JLT_FMA(p[7], t11, t17); /* v_tau/R = 1/(R*I1)*gamma3*1/s*(R*I3*gamma3*omega3 + G_level) + omega3*s */
    const double t19 = p[35]*t16; /* m*R^2*d(v_tau)/d(omega3)/R */
    const double t20 = JLT_FMA(p[8], x[3], t12); /* R*I3*omega3 + 1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t21 = t8*t20; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/s*(R*I3*omega3 + 1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level)) */
    const double t22 = p[34]*t7; /* R*I1*gamma3*omega3 */
    const double t23 = JLT_FNMA(t8, t22, t10); /* 1/s*(R*I3*gamma3*omega3 + G_level) - 1/s*R*I1*gamma3*omega3 */
    const double t24 = p[21]*t10; /* 1/(R^2*I1)*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t25 = t21*t24; /* d(omega_n)/d(gamma3)/(1/(R*I1))*1/(R^2*I1)*1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t26 = JLT_FMA(x[0], t21, t23); /* d(v_tau)/d(gamma3)/(1/I1) = gamma3*d(omega_n)/d(gamma3)/(1/(R*I1)) + 1/s*(R*I3*gamma3*omega3 + G_level) - 1/s*R*I1*gamma3*omega3 */
    const double t27 = x[3]*p[5]; /* omega3*I3 */
    const double t28 = JLT_FMA(p[25], t12, t27); /* I3/(R*I1)*1/s*gamma3*1/s*(R*I3*gamma3*omega3 + G_level) + omega3*I3 */
    const double t29 = JLT_FMA(t18, t19, t28); /* d(energy)/d(omega3) = v_tau/R*m*R^2*d(v_tau)/d(omega3)/R + t28 */
    out[3] = t29;
    const double t30 = p[33]*t18; /* m*R/I1*v_tau/R */
    const double t31 = JLT_FMA(t26, t30, t25); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/(1/I1)*m*R/I1*v_tau/R + t25 */
    out[0] = t31;
    const double t32 = x[3]*p[36]; /* omega3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    const double t33 = t7*t32; /* gamma3*omega3*omega3*(-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3)) */
    out[4] = t33;
    const double t34 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t35 = p[37]*t34; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[5] = t35;
    const double t36 = p[38]*t34; /* 2*m*R*I1^2*(omega_tau*R + v_nu) */
    out[6] = t36;
    const double t37 = x[3]*p[39]; /* omega3*2*m*R^2*I1*(I1 - I3) */
    const double t38 = t15*t37; /* Theta/(m*R^2*I1)*omega3*2*m*R^2*I1*(I1 - I3) */
    out[7] = t38;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t5 = JLT_FMA(x[3], t4, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t6 = p[7]*t5; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level) */
    const double t7 = t6/t3; /* 1/(R*I1)*(omega3*gamma3*R*I3 + G_level)/s */
    out[0] = t7;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
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
    for (unsigned k = 0; k < order; k++) {
        t13[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t14[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t15[k] = jlt_jet_product(t13, t14, k);
        t16[k] = jlt_jet_root(t15[k], t16, k);
        t17[k] = (k == 0 ? p[9] : 0) + t15[k];
        t18[k] = jlt_jet_product(x0, x3, k);
        t19[k] = p[8]*t18[k] + (k == 0 ? p[6] : 0);
        t20[k] = p[7]*t19[k];
        t21[k] = p[11]*t18[k];
        t22[k] = jlt_jet_product(x2, t16, k);
        t23[k] = jlt_jet_product(t21, t22, k);
        t24[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t16, t24, k);
        t25[k] = jlt_jet_product(t20, t24, k);
        t26[k] = jlt_jet_product(x0, t24, k);
        t27[k] = jlt_jet_product(t25, t26, k);
        t28[k] = x0[k]*p[10];
        t29[k] = jlt_jet_product(x0, t28, k) + t17[k];
        t30[k] = p[12]*x1[k] + x2[k];
        t31[k] = t23[k] - jlt_jet_product(t25, t30, k);
        t32[k] = jlt_jet_quotient(t31[k], t29, t32, k);
        t33[k] = x3[k]*p[10] + t27[k];
        t34[k] = x3[k] + t27[k];
        t35[k] = jlt_jet_product(t25, t33, k);
        t36[k] = -t35[k];
        t37[k] = p[1]*t25[k];
        t38[k] = jlt_jet_product(t34, t37, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t22[k]/(k + 1);
        next[1] = x1[k + 1] = t38[k]/(k + 1);
        next[2] = x2[k + 1] = t36[k]/(k + 1);
        next[3] = x3[k + 1] = t32[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_omega_n = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "",
    .elimination = "level_omega_n",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .prepared_count = 40,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 18, 5, 1, 1, 0, 12, 6 }, { 10, 39, 0, 6, 1, 0, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in (R*I3)*gamma3*omega3 + G_level, a part of d(omega_tau)/dt, omega3 + omega_n*gamma3*((1)/s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s, V/R = (1/R)*v_nu + omega_tau, omega_tau*s*((I1 - I3)/I1)*gamma3*omega3 - omega_n*V/R" },
    .jacobian = { jacobian, 16, { 5, 39, 16, 1, 1, 0, 15, 12 }, { 33, 145, 0, 26, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3*(R*I3) + G_level, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega3), d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega3), 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), V = omega_tau*R + v_nu, a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(omega_tau), d(d(omega3)/dt)/d(omega3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 8, 39, 16, 1, 1, 0, 15, 13 }, { 38, 166, 0, 31, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), (R*I3)*gamma3*omega3 + G_level, d(d(omega3)/dt)/d(omega_tau), a part of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), V/R = (1/R)*v_nu + omega_tau, d(omega3)/dt, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(v_nu)/dt, d(d(v_nu)/dt)/d(omega3), d(d(omega_tau)/dt)/d(omega3), d(d(omega3)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 3, 10, 4, 1, 1, 0, 10, 6 }, { 7, 25, 0, 3, 1, 0, 10, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, 1/(Theta/(m*R^2*I1))*(I3/(R*I1))*V + omega_tau, a part of the divergence" },
    .integral_values = { integral_values, 2, { 3, 14, 9, 1, 1, 0, 10, 6 }, { 12, 44, 0, 1, 1, 0, 12, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level, s*omega3 + gamma3*omega_n, R*omega_tau + v_nu, F0" },
    .integral_gradients = { integral_gradients, 8, { 4, 23, 10, 1, 1, 0, 11, 10 }, { 18, 79, 0, 6, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in -2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3), (R*I3)*gamma3*omega3 + G_level, v_tau/R = (1/(R*I1))*gamma3*((1)/s)*((R*I3)*gamma3*omega3 + G_level) + omega3*s, (R*I3)*omega3 + ((1)/s)*gamma3*((1)/s)*((R*I3)*gamma3*omega3 + G_level), d(v_tau)/d(gamma3)/(1/I1), d(E)/d(omega3), d(E)/d(gamma3), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 3, 1, 1, 1, 0, 4, 3 }, { 2, 6, 0, 1, 1, 0, 5, 3 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .eliminated_state = 3, .level_integral = 1,
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_on_level_omega_n,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_on_level_omega_n) },
#endif
};
