/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Eliminated: level_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   19    5    1    1    0     10    6   (64)
 *  jacobian            6   34   15    1    1    0     14   12   (216)
 *  rhs_jacobian        7   37   18    1    1    0     13   14   (255)
 *  divergence          2   11    4    1    1    0      8    6   (38)
 *  integral_values     3   12    9    1    1    0     10    7   (58)
 *  integral_gradients  5   27   10    1    1    0     12   10   (112)
 *  eliminated          2    2    1    1    1    0      5    3   (10)
 *
 *  Accuracy
 *    divides by gamma3: values and rounding errors grow without bound where it vanishes
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in 2*m*R^2*I1 - 2*m*R^2*I3, G_level/(R*I1) - omega_n*s,
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_n)/dt)/d(gamma3),
 *      V = omega_tau*R + v_nu, omega_tau - V*(m*R*I3)*1/Theta,
 *      1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*s*1/gamma3,
 *      a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(omega_tau),
 *      d(d(omega_n)/dt)/d(omega_tau), d(omega_n)/dt, d(d(omega_tau)/dt)/d(omega_n), d(d(v_nu)/dt)/d(omega_n),
 *      d(omega_tau)/dt, d(v_nu)/dt, d(d(omega_n)/dt)/d(omega_n), d(d(omega_n)/dt)/d(gamma3),
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_omega3;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_on_level_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_omega3_avx512;

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
    const double t0 = -params[1]; /* -R */
    out[7] = t0;
    const double t1 = params[4]/params[5]; /* I1/I3 */
    out[8] = t1;
    const double t2 = params[1]*params[4]; /* R*I1 */
    const double t3 = params[6]/t2; /* G_level/(R*I1) */
    out[9] = t3;
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[0]*t4; /* m*R*R */
    out[34] = t5;
    const double t6 = params[5]/t5; /* I3/(m*R*R) */
    out[10] = t6;
    const double t7 = params[5]/params[4]; /* I3/I1 */
    out[11] = t7;
    const double t8 = params[5]/t2; /* I3/(R*I1) */
    out[12] = t8;
    const double t9 = params[5]*t5; /* I3*m*R*R */
    out[23] = t9;
    const double t10 = params[5]*params[5]; /* I3*I3 */
    const double t11 = t9 + t10; /* I3*m*R*R + I3*I3 */
    out[26] = t11;
    const double t12 = t11/t9; /* (I3*m*R*R + I3*I3)/(I3*m*R*R) */
    out[13] = t12;
    const double t13 = t2/params[5]; /* R*I1/I3 */
    out[14] = t13;
    const double t14 = params[1]*2.0; /* R*2 */
    out[15] = t14;
    const double t15 = params[4]*t5; /* I1*m*R*R */
    out[22] = t15;
    const double t16 = t11/t15; /* (I3*m*R*R + I3*I3)/(I1*m*R*R) */
    out[16] = t16;
    const double t17 = t15 - t9; /* I1*m*R*R - I3*m*R*R */
    const double t18 = 2.0*t17; /* 2*(I1*m*R*R - I3*m*R*R) */
    const double t19 = t18/t9; /* 2*(I1*m*R*R - I3*m*R*R)/(I3*m*R*R) */
    out[17] = t19;
    const double t20 = params[1]*t4; /* R*R*R */
    const double t21 = params[0]*t20; /* m*R*R*R */
    const double t22 = params[4]*params[4]; /* I1*I1 */
    const double t23 = t21*t22; /* m*R*R*R*I1*I1 */
    const double t24 = params[5]*2.0; /* I3*2 */
    const double t25 = t17*t24; /* (I1*m*R*R - I3*m*R*R)*I3*2 */
    const double t26 = t25/t23; /* (I1*m*R*R - I3*m*R*R)*I3*2/(m*R*R*R*I1*I1) */
    out[18] = t26;
    const double t27 = -t8; /* -I3/(R*I1) */
    out[19] = t27;
    const double t28 = params[4]*params[5]; /* I1*I3 */
    out[21] = t28;
    const double t29 = t15 + t28; /* I1*m*R*R + I1*I3 */
    out[28] = t29;
    const double t30 = t29/t15; /* (I1*m*R*R + I1*I3)/(I1*m*R*R) */
    out[20] = t30;
    const double t31 = params[1]*params[0]; /* R*m */
    const double t32 = params[5]*t31; /* I3*R*m */
    out[24] = t32;
    const double t33 = params[4]*t11; /* I1*(I3*m*R*R + I3*I3) */
    const double t34 = t33/params[5]; /* I1*(I3*m*R*R + I3*I3)/I3 */
    out[25] = t34;
    const double t35 = 2.0*t15; /* 2*I1*m*R*R */
    const double t36 = t9*2.0; /* I3*m*R*R*2 */
    const double t37 = t35 - t36; /* 2*I1*m*R*R - I3*m*R*R*2 */
    out[27] = t37;
    const double t38 = params[4]/2.0; /* I1/2 */
    out[29] = t38;
    const double t39 = params[0]/params[4]; /* m/I1 */
    out[30] = t39;
    const double t40 = t5/params[4]; /* m*R*R/I1 */
    out[31] = t40;
    const double t41 = params[0]*t22; /* m*I1*I1 */
    out[32] = t41;
    const double t42 = params[4] - params[5]; /* I1 - I3 */
    const double t43 = t15*t42; /* I1*m*R*R*(I1 - I3) */
    out[33] = t43;
    const double t44 = t42*(-2.0); /* (I1 - I3)*(-2) */
    const double t45 = t17*t44; /* (I1*m*R*R - I3*m*R*R)*(I1 - I3)*(-2) */
    out[35] = t45;
    const double t46 = params[0]*(-2.0); /* m*(-2) */
    const double t47 = t4*t46; /* R*R*m*(-2) */
    const double t48 = params[4]*t47; /* I1*R*R*m*(-2) */
    const double t49 = t42*t48; /* (I1 - I3)*I1*R*R*m*(-2) */
    out[36] = t49;
    const double t50 = params[0]*2.0; /* m*2 */
    const double t51 = t22*t50; /* I1*I1*m*2 */
    out[37] = t51;
    const double t52 = params[1]*t50; /* R*m*2 */
    const double t53 = t22*t52; /* I1*I1*R*m*2 */
    out[38] = t53;
    const double t54 = t22*t47; /* I1*I1*R*R*m*(-2) */
    const double t55 = t42*t54; /* (I1 - I3)*I1*I1*R*R*m*(-2) */
    const double t56 = t55/params[5]; /* (I1 - I3)*I1*I1*R*R*m*(-2)/I3 */
    out[39] = t56;
    const double t57 = -t1; /* -I1/I3 */
    out[40] = t57;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t4 = p[10] + t2; /* I3/(m*R^2) + s^2 */
    const double t5 = JLT_FMA(p[11], t3, t4); /* Theta/(m*R^2*I1) = I3/I1*gamma3*gamma3 + I3/(m*R^2) + s^2 */
    const double t6 = x[0]*t2; /* gamma3*s^2 */
    const double t7 = t5*t6; /* Theta/(m*R^2*I1)*gamma3*s^2 */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*gamma3*s^2) */
    const double t9 = t5*t8; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s^2) */
    const double t10 = t6*t8; /* 1/(Theta/(m*R^2*I1)) = gamma3*s^2*1/(Theta/(m*R^2*I1)*gamma3*s^2) */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    const double t12 = x[2]*t11; /* omega_tau*s */
    out[0] = t12;
    const double t13 = x[3]*t11; /* omega_n*s */
    const double t14 = t3*t13; /* gamma3*gamma3*omega_n*s */
    const double t15 = p[9] - t13; /* G_level/(R*I1) - omega_n*s */
    const double t16 = t2*t15; /* s^2*(G_level/(R*I1) - omega_n*s) */
    const double t17 = t9*t16; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s^2)*s^2*(G_level/(R*I1) - omega_n*s) */
    const double t18 = t9*t14; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s^2)*gamma3*gamma3*omega_n*s */
    const double t19 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t20 = p[12]*t19; /* I3/(R*I1)*V */
    const double t21 = JLT_FNMA(t10, t20, x[2]); /* omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t22 = t18*t21; /* t18*(omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V) */
    const double t23 = x[2]*p[13]; /* omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I3) */
    const double t24 = t10*t23; /* 1/(Theta/(m*R^2*I1))*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I3) */
    const double t25 = JLT_FNMA(t17, t24, t22); /* t18*(omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V) - t17*1/(Theta/(m*R^2*I1))*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I3) */
    out[3] = t25;
    const double t26 = JLT_FMS(p[8], t17, t18); /* I1/I3*t17 - t18 */
    const double t27 = t17 - t18; /* t17 - t18 */
    const double t28 = x[3]*t27; /* omega_n*(t17 - t18) */
    out[2] = t28;
    const double t29 = p[7]*x[3]; /* (-R)*omega_n */
    const double t30 = t26*t29; /* (I1/I3*t17 - t18)*(-R)*omega_n */
    out[1] = t30;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[11]; /* gamma3*I3/I1 */
    const double t4 = p[10] + t2; /* I3/(m*R^2) + s^2 */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t6 = x[0]*t2; /* gamma3*s^2 */
    const double t7 = t5*t6; /* Theta/(m*R^2*I1)*gamma3*s^2 */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*gamma3*s^2) */
    const double t9 = t5*t8; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s^2) */
    const double t10 = t6*t8; /* 1/(Theta/(m*R^2*I1)) = gamma3*s^2*1/(Theta/(m*R^2*I1)*gamma3*s^2) */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t11;
    const double t12 = t2*t9; /* 1/gamma3 = s^2*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s^2) */
    const double t13 = x[0]*t11; /* gamma3*s */
    const double t14 = t9*t13; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s^2)*gamma3*s */
    const double t15 = JLT_FNMA(x[3], t11, p[9]); /* G_level/(R*I1) - omega_n*s */
    const double t16 = t12*t15; /* 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t17 = t11*t12; /* s*1/gamma3 */
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t19 = t10*t18; /* 1/(Theta/(m*R^2*I1))*V */
    const double t20 = x[3]*t14; /* omega_n*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s^2)*gamma3*s */
    const double t21 = JLT_FMS(t12, t16, t20); /* 1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) - t20 */
    const double t22 = p[8]*t21; /* d(omega3)/d(gamma3) = I1/I3*(1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) - t20) */
    const double t23 = x[2]*t14; /* omega_tau*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s^2)*gamma3*s */
    const double t24 = p[12]*t19; /* I3/(R*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t25 = JLT_FNMA(t14, t24, t23); /* t23 - Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s^2)*gamma3*s*I3/(R*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t26 = t14*t20; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*gamma3*s^2)*gamma3*s*t20 */
    const double t27 = x[0]*t23; /* gamma3*t23 */
    const double t28 = -t27; /* -gamma3*t23 */
    out[0] = t28;
    const double t29 = x[0]*t20; /* gamma3*t20 */
    const double t30 = t20*t26; /* t20*t26 */
    const double t31 = t25*t26; /* t25*t26 */
    const double t32 = x[0]*t25; /* gamma3*t25 */
    const double t33 = x[0]*p[18]; /* gamma3*2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^3*I1^2) */
    const double t34 = t19*t33; /* 1/(Theta/(m*R^2*I1))*V*gamma3*2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^3*I1^2) */
    const double t35 = x[3]*t22; /* omega_n*d(omega3)/d(gamma3) */
    const double t36 = JLT_FNMA(x[3], t17, t16); /* 1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*s*1/gamma3 */
    const double t37 = t10*t16; /* 1/(Theta/(m*R^2*I1))*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t38 = JLT_FNMA(2.0, t29, t36); /* 1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*s*1/gamma3 - 2*gamma3*t20 */
    out[11] = t38;
    const double t39 = p[14]*t36; /* R*I1/I3*(1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*s*1/gamma3) */
    const double t40 = JLT_FMS(p[15], t29, t39); /* 2*R*gamma3*t20 - t39 */
    out[7] = t40;
    const double t41 = x[0]*p[17]; /* gamma3*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I3) */
    const double t42 = JLT_FMS(t37, t41, t22); /* 1/(Theta/(m*R^2*I1))*1/gamma3*(G_level/(R*I1) - omega_n*s)*gamma3*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I3) - d(omega3)/d(gamma3) */
    const double t43 = JLT_FNMA(p[13], t37, t29); /* gamma3*t20 - (I3^2 + m*R^2*I3)/(m*R^2*I3)*1/(Theta/(m*R^2*I1))*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t44 = t10*t29; /* 1/(Theta/(m*R^2*I1))*gamma3*t20 */
    const double t45 = JLT_FNMA(t34, t44, t31); /* t25*t26 - t34*1/(Theta/(m*R^2*I1))*gamma3*t20 */
    const double t46 = JLT_FNMA(p[11], t44, t43); /* t43 - I3/I1*1/(Theta/(m*R^2*I1))*gamma3*t20 */
    out[14] = t46;
    const double t47 = p[19]*t44; /* (-I3/(R*I1))*1/(Theta/(m*R^2*I1))*gamma3*t20 */
    out[13] = t47;
    const double t48 = x[2]*t10; /* omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t49 = t30 + t35; /* t20*t26 + omega_n*d(omega3)/d(gamma3) */
    const double t50 = JLT_FMA(p[11], t35, t30); /* I3/I1*omega_n*d(omega3)/d(gamma3) + t20*t26 */
    const double t51 = p[1]*t49; /* R*(t20*t26 + omega_n*d(omega3)/d(gamma3)) */
    out[4] = t51;
    const double t52 = -t50; /* -(I3/I1*omega_n*d(omega3)/d(gamma3) + t20*t26) */
    out[8] = t52;
    const double t53 = p[16]*t48; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t54 = JLT_FNMA(t42, t53, t45); /* t25*t26 - t34*1/(Theta/(m*R^2*I1))*gamma3*t20 - t42*(I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[12] = t54;
    const double t55 = p[20]*t48; /* (I1*I3 + m*R^2*I1)/(m*R^2*I1)*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t56 = JLT_FMA(t17, t55, t32); /* s*1/gamma3*(I1*I3 + m*R^2*I1)/(m*R^2*I1)*omega_tau*1/(Theta/(m*R^2*I1)) + gamma3*t25 */
    out[15] = t56;
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
    const double t3 = x[0]*p[23]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[21]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(p[22], t2, t4); /* Theta = m*R^2*I1*s^2 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = x[0]*t2; /* gamma3*s^2 */
    const double t7 = t5*t6; /* Theta*gamma3*s^2 */
    const double t8 = 1.0/t7; /* 1/(Theta*gamma3*s^2) */
    const double t9 = t5*t8; /* Theta*1/(Theta*gamma3*s^2) */
    const double t10 = t6*t8; /* 1/Theta = gamma3*s^2*1/(Theta*gamma3*s^2) */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t11;
    const double t12 = t2*t9; /* 1/gamma3 = s^2*Theta*1/(Theta*gamma3*s^2) */
    const double t13 = x[2]*t11; /* omega_tau*s */
    out[0] = t13;
    const double t14 = x[0]*t11; /* gamma3*s */
    const double t15 = t9*t14; /* Theta*1/(Theta*gamma3*s^2)*gamma3*s */
    const double t16 = JLT_FNMA(x[3], t11, p[9]); /* G_level/(R*I1) - omega_n*s */
    const double t17 = t12*t16; /* 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t18 = t11*t12; /* s*1/gamma3 */
    const double t19 = x[3]*t15; /* omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s */
    const double t20 = JLT_FMS(t12, t17, t19); /* 1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s */
    const double t21 = p[8]*t20; /* d(omega3)/d(gamma3) = I1/I3*t20 */
    const double t22 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t23 = p[24]*t10; /* m*R*I3*1/Theta */
    const double t24 = x[0]*t19; /* gamma3*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s */
    const double t25 = JLT_FNMA(t22, t23, x[2]); /* omega_tau - V*m*R*I3*1/Theta */
    const double t26 = t23*t24; /* m*R*I3*1/Theta*gamma3*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s */
    const double t27 = t15*t25; /* Theta*1/(Theta*gamma3*s^2)*gamma3*s*(omega_tau - V*m*R*I3*1/Theta) */
    const double t28 = t22*t26; /* V*t26 */
    const double t29 = -t26; /* -t26 */
    out[17] = t29;
    const double t30 = x[2]*t10; /* omega_tau*1/Theta */
    const double t31 = t15*t19; /* Theta*1/(Theta*gamma3*s^2)*gamma3*s*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s */
    const double t32 = t19*t31; /* omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s*t31 */
    const double t33 = t27*t31; /* t27*t31 */
    const double t34 = x[0]*t27; /* gamma3*t27 */
    const double t35 = x[3]*t17; /* omega_n*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t36 = p[25]*t17; /* I1*(I3^2 + m*R^2*I3)/I3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t37 = JLT_FNMA(x[3], t18, t17); /* 1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*s*1/gamma3 */
    const double t38 = JLT_FMA(t30, t36, t28); /* omega_tau*1/Theta*t36 + V*t26 */
    const double t39 = JLT_FMA(p[23], t24, t36); /* m*R^2*I3*gamma3*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s + t36 */
    const double t40 = JLT_FNMA(t10, t39, t24); /* gamma3*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s - 1/Theta*t39 */
    out[18] = t40;
    const double t41 = JLT_FMS(x[2], t24, t38); /* omega_tau*gamma3*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s - (omega_tau*1/Theta*t36 + V*t26) */
    out[3] = t41;
    const double t42 = JLT_FNMA(2.0, t24, t37); /* 1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*s*1/gamma3 - 2*gamma3*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s */
    out[15] = t42;
    const double t43 = p[14]*t37; /* R*I1/I3*(1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*s*1/gamma3) */
    const double t44 = JLT_FMS(p[15], t24, t43); /* 2*R*gamma3*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s - t43 */
    out[11] = t44;
    const double t45 = x[3]*t24; /* omega_n*gamma3*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s */
    const double t46 = t35 - t45; /* omega_n*1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*gamma3*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s */
    out[2] = t46;
    const double t47 = p[14]*t35; /* R*I1/I3*omega_n*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t48 = JLT_FMS(p[1], t45, t47); /* R*omega_n*gamma3*omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s - R*I1/I3*omega_n*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    out[1] = t48;
    const double t49 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t50 = t15*t49; /* Theta*1/(Theta*gamma3*s^2)*gamma3*s*omega_tau*gamma3 */
    const double t51 = -t50; /* -Theta*1/(Theta*gamma3*s^2)*gamma3*s*omega_tau*gamma3 */
    out[4] = t51;
    const double t52 = x[3]*t21; /* omega_n*d(omega3)/d(gamma3) */
    const double t53 = p[26]*t30; /* (I3^2 + m*R^2*I3)*omega_tau*1/Theta */
    const double t54 = JLT_FMA(t21, t53, t33); /* d(omega3)/d(gamma3)*(I3^2 + m*R^2*I3)*omega_tau*1/Theta + t27*t31 */
    const double t55 = p[28]*t30; /* (I1*I3 + m*R^2*I1)*omega_tau*1/Theta */
    const double t56 = JLT_FMA(t18, t55, t34); /* s*1/gamma3*(I1*I3 + m*R^2*I1)*omega_tau*1/Theta + gamma3*t27 */
    out[19] = t56;
    const double t57 = x[0]*p[27]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t58 = t10*t57; /* 1/Theta*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t59 = JLT_FNMA(t38, t58, t54); /* t54 - (omega_tau*1/Theta*t36 + V*t26)*1/Theta*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    out[16] = t59;
    const double t60 = t32 + t52; /* omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s*t31 + omega_n*d(omega3)/d(gamma3) */
    const double t61 = JLT_FMA(p[11], t52, t32); /* I3/I1*omega_n*d(omega3)/d(gamma3) + omega_n*Theta*1/(Theta*gamma3*s^2)*gamma3*s*t31 */
    const double t62 = p[1]*t60; /* R*t60 */
    out[8] = t62;
    const double t63 = -t61; /* -t61 */
    out[12] = t63;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t4 = JLT_FMA(p[23], t3, p[21]); /* m*R^2*I3*gamma3*gamma3 + I1*I3 */
    const double t5 = JLT_FMA(p[22], t2, t4); /* Theta = m*R^2*I1*s^2 + m*R^2*I3*gamma3*gamma3 + I1*I3 */
    const double t6 = p[24]*t3; /* m*R*I3*gamma3*gamma3 */
    const double t7 = x[0]*t2; /* gamma3*s^2 */
    const double t8 = t5*t7; /* Theta*gamma3*s^2 */
    const double t9 = p[28]*x[2]; /* (I1*I3 + m*R^2*I1)*omega_tau */
    const double t10 = t2*t9; /* s^2*(I1*I3 + m*R^2*I1)*omega_tau */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t13 = JLT_FNMA(t6, t12, t10); /* s^2*(I1*I3 + m*R^2*I1)*omega_tau - m*R*I3*gamma3*gamma3*V */
    const double t14 = t8*t13; /* Theta*gamma3*s^2*(s^2*(I1*I3 + m*R^2*I1)*omega_tau - m*R*I3*gamma3*gamma3*V) */
    const double t15 = t11*t14; /* s*t14 */
    const double t16 = 1.0/t8; /* 1/(Theta*gamma3*s^2) */
    const double t17 = t15*t16; /* s*t14*1/(Theta*gamma3*s^2) */
    const double t18 = t16*t17; /* 1/(Theta*gamma3*s^2)*s*t14*1/(Theta*gamma3*s^2) */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[30]*x[1]; /* m/I1*v_nu */
    const double t1 = x[3]*x[3]; /* omega_n*omega_n */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = JLT_FNMA(x[3], t5, p[9]); /* G_level/(R*I1) - omega_n*s */
    const double t7 = p[8]/x[0]; /* I1/I3/gamma3 */
    const double t8 = t6*t7; /* (G_level/(R*I1) - omega_n*s)*I1/I3/gamma3 */
    const double t9 = t8*t8; /* (G_level/(R*I1) - omega_n*s)*I1/I3/gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3/gamma3 */
    const double t10 = t5*t8; /* s*(G_level/(R*I1) - omega_n*s)*I1/I3/gamma3 */
    const double t11 = JLT_FMS(x[3], x[0], t10); /* v_tau/R = omega_n*gamma3 - s*(G_level/(R*I1) - omega_n*s)*I1/I3/gamma3 */
    const double t12 = p[31]*t11; /* m*R^2/I1*v_tau/R */
    const double t13 = JLT_FMA(x[2], x[2], t1); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t14 = JLT_FMA(x[1], t0, t13); /* v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t15 = JLT_FMA(p[11], t9, t14); /* I3/I1*t9 + v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t16 = JLT_FMA(t11, t12, t15); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t15 */
    const double t17 = p[29]*t16; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t17;
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t19 = p[32]*t18; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t20 = t18*t19; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t21 = p[11]*x[0]; /* I3/I1*gamma3 */
    const double t22 = t4 + p[10]; /* (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t23 = JLT_FMA(x[0], t21, t22); /* Theta/(m*R^2*I1) = gamma3*I3/I1*gamma3 + (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t24 = p[33]*t23; /* m*R^2*I1*(I1 - I3)*Theta/(m*R^2*I1) */
    const double t25 = JLT_FMA(t9, t24, t20); /* t9*m*R^2*I1*(I1 - I3)*Theta/(m*R^2*I1) + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t25;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t5 = x[0]*t4; /* gamma3*s^2 */
    const double t6 = 1.0/t5; /* 1/(gamma3*s^2) */
    const double t7 = sqrt(t4); /* s = sqrt(s^2) */
    const double t8 = x[3]*t7; /* omega_n*s */
    const double t9 = t4*t6; /* 1/gamma3 = s^2*1/(gamma3*s^2) */
    const double t10 = x[0]*t6; /* 1/s^2 = gamma3*1/(gamma3*s^2) */
    const double t11 = p[9] - t8; /* G_level/(R*I1) - omega_n*s */
    const double t12 = p[8]*t9; /* I1/I3*1/gamma3 */
    const double t13 = t11*t12; /* (G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t14 = JLT_FMA(t4, t12, x[0]); /* d(v_tau)/d(omega_n)/R = s^2*I1/I3*1/gamma3 + gamma3 */
    const double t15 = p[10] + t4; /* I3/(m*R^2) + s^2 */
    const double t16 = p[31]*t14; /* m*R^2/I1*d(v_tau)/d(omega_n)/R */
    const double t17 = t9*t13; /* 1/gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t18 = p[8]*t10; /* I1/I3*1/s^2 */
    const double t19 = JLT_FNMA(t8, t18, t17); /* d(omega3)/d(gamma3) = 1/gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 - omega_n*s*I1/I3*1/s^2 */
    const double t20 = t7*t13; /* s*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t21 = t9*t20; /* 1/gamma3*s*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t22 = JLT_FMS(x[3], x[0], t20); /* v_tau/R = omega_n*gamma3 - s*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t23 = x[0]*t13; /* gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t24 = JLT_FMA(t10, t23, t19); /* 1/s^2*gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 + d(omega3)/d(gamma3) */
    const double t25 = JLT_FMA(t7, t24, x[3]); /* d(v_tau)/d(gamma3)/R = s*t24 + omega_n */
    const double t26 = t13*t19; /* (G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3*d(omega3)/d(gamma3) */
    const double t27 = p[35]*t13; /* (-2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3))*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t28 = t23*t27; /* gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3*t27 */
    const double t29 = x[0]*p[11]; /* gamma3*I3/I1 */
    const double t30 = JLT_FMA(x[0], t29, t15); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t31 = x[3] - t21; /* omega_n - 1/gamma3*s*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3 */
    const double t32 = JLT_FMA(t16, t22, t31); /* d(energy)/d(omega_n)/I1 = m*R^2/I1*d(v_tau)/d(omega_n)/R*v_tau/R + t31 */
    const double t33 = p[4]*t32; /* I1*d(energy)/d(omega_n)/I1 */
    out[3] = t33;
    const double t34 = p[34]*t22; /* m*R^2*v_tau/R */
    const double t35 = p[5]*t26; /* I3*t26 */
    const double t36 = JLT_FMS(t25, t34, t35); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R - I3*t26 */
    out[0] = t36;
    const double t37 = p[36]*t30; /* (-2*m*R^2*I1*(I1 - I3))*Theta/(m*R^2*I1) */
    const double t38 = JLT_FMA(t26, t37, t28); /* t26*(-2*m*R^2*I1*(I1 - I3))*Theta/(m*R^2*I1) + gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3*t27 */
    out[4] = t38;
    const double t39 = p[39]*t30; /* (-2*m*R^2*I1^2*(I1 - I3)/I3)*Theta/(m*R^2*I1) */
    const double t40 = t21*t39; /* 1/gamma3*s*(G_level/(R*I1) - omega_n*s)*I1/I3*1/gamma3*(-2*m*R^2*I1^2*(I1 - I3)/I3)*Theta/(m*R^2*I1) */
    out[7] = t40;
    const double t41 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t42 = p[37]*t41; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[5] = t42;
    const double t43 = p[38]*t41; /* 2*m*R*I1^2*(omega_tau*R + v_nu) */
    out[6] = t43;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FNMA(x[3], t3, p[9]); /* G_level/(R*I1) - omega_n*s */
    const double t5 = p[40]/x[0]; /* (-I1/I3)/gamma3 */
    const double t6 = t4*t5; /* (G_level/(R*I1) - omega_n*s)*(-I1/I3)/gamma3 */
    out[0] = t6;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t12[k] = (k == 0 ? p[9] : 0) - jlt_jet_product(t6, x3, k);
        t13[k] = jlt_jet_quotient(t12[k], x0, t13, k);
        t14[k] = jlt_jet_product(x0, x3, k);
        t15[k] = jlt_jet_quotient(t14[k], t6, t15, k);
        t16[k] = p[8]*t13[k] - t15[k];
        t17[k] = p[7]*x3[k];
        t18[k] = jlt_jet_product(t16, t17, k);
        t19[k] = t13[k] - t15[k];
        t20[k] = jlt_jet_product(x3, t19, k);
        t24[k] = x0[k]*p[11];
        t25[k] = t5[k] + (k == 0 ? p[10] : 0);
        t26[k] = jlt_jet_product(x0, t24, k) + t25[k];
        t27[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t26, t27, k);
        t30[k] = x2[k]*p[1] + x1[k];
        t31[k] = p[12]*t30[k];
        t32[k] = x2[k] - jlt_jet_product(t27, t31, k);
        t33[k] = jlt_jet_product(t15, t32, k);
        t35[k] = x2[k]*p[13];
        t36[k] = jlt_jet_product(t27, t35, k);
        t37[k] = t33[k] - jlt_jet_product(t13, t36, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t18[k]/(k + 1);
        next[2] = x2[k + 1] = t20[k]/(k + 1);
        next[3] = x3[k + 1] = t37[k]/(k + 1);
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
    const double v_I3 = params[5];
    const double v_G_level = params[6];
    const double v_I1 = params[4];
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
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
    out[3] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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

const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_omega3 = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "",
    .elimination = "level_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .prepared_count = 41,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 19, 5, 1, 1, 0, 10, 6 }, { 11, 44, 0, 8, 1, 0, 11, 8 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, V = omega_tau*R + v_nu, omega_tau - 1/(Theta/(m*R^2*I1))*(I3/(R*I1))*V, d(omega_n)/dt, a part of d(v_nu)/dt, a part of d(omega_tau)/dt" },
    .jacobian = { jacobian, 16, { 6, 34, 15, 1, 1, 0, 14, 12 }, { 34, 149, 0, 32, 1, 0, 16, 11 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I3), 2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^3*I1^2), G_level/(R*I1) - omega_n*s, V = omega_tau*R + v_nu, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3) and of d(d(omega_n)/dt)/d(omega_n), 1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*s*1/gamma3, d(d(omega_tau)/dt)/d(omega_n), d(d(v_nu)/dt)/d(omega_n), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 37, 18, 1, 1, 0, 13, 14 }, { 40, 175, 0, 39, 1, 0, 16, 11 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*m*R^2*I1 - 2*m*R^2*I3, G_level/(R*I1) - omega_n*s, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_n)/dt)/d(gamma3), V = omega_tau*R + v_nu, omega_tau - V*(m*R*I3)*1/Theta, 1/gamma3*(G_level/(R*I1) - omega_n*s) - omega_n*s*1/gamma3, a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(omega_tau), d(d(omega_n)/dt)/d(omega_tau), d(omega_n)/dt, d(d(omega_tau)/dt)/d(omega_n), d(d(v_nu)/dt)/d(omega_n), d(omega_tau)/dt, d(v_nu)/dt, d(d(omega_n)/dt)/d(omega_n), d(d(omega_n)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 2, 11, 4, 1, 1, 0, 8, 6 }, { 6, 28, 0, 3, 1, 0, 11, 6 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, s^2*(I1*I3 + m*R^2*I1)*omega_tau - (m*R*I3)*gamma3*gamma3*V" },
    .integral_values = { integral_values, 2, { 3, 12, 9, 1, 1, 0, 10, 7 }, { 12, 44, 0, 1, 1, 0, 14, 6 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, v_tau/R = omega_n*gamma3 - s*(G_level/(R*I1) - omega_n*s)*((I1/I3)/gamma3), omega_tau*R + v_nu, F0" },
    .integral_gradients = { integral_gradients, 8, { 5, 27, 10, 1, 1, 0, 12, 10 }, { 20, 84, 0, 7, 1, 0, 13, 10 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in -2*(I1 - I3)*(m*R^2*I1 - m*R^2*I3), G_level/(R*I1) - omega_n*s, d(omega3)/d(gamma3), v_tau/R = omega_n*gamma3 - s*(G_level/(R*I1) - omega_n*s)*(I1/I3)*1/gamma3, a part of d(E)/d(gamma3), d(v_tau)/d(gamma3)/R, d(energy)/d(omega_n)/I1, d(E)/d(gamma3), d(F0)/d(gamma3), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 2, 1, 1, 1, 0, 5, 3 }, { 2, 6, 0, 1, 1, 0, 6, 4 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .eliminated_state = 4, .level_integral = 1,
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_on_level_omega3,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_on_level_omega3) },
#endif
};
