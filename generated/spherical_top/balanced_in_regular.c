/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   16    7    1    0    0      7    7   (75)
 *  jacobian            7   46   16    1    0    0     10   15   (321)
 *  rhs_jacobian        10   55   17    1    0    0      8   16   (381)
 *  divergence          1    5    3    1    0    0      5    4   (30)
 *  integral_values     0   13   10    0    0    0      6    6   (55)
 *  integral_gradients  0   21    6    0    0    0      4    4   (81)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    digits are lost where terms nearly cancel in s*omega3 + omega_n*gamma3, omega_n*gamma3 + s*omega3*(I3/I1),
 *      V = omega_tau*R + v_nu,
 *      numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*(m*R*I3)*V,
 *      d(omega_n)/dtau,
 *      numerator of d(omega3)/dt over Theta = s*omega_tau*gamma3*s*omega3*(m*R^2*(I1 - I3)) - V*(m*R*I1)*s*omega_n,
 *      d(d(v_nu)/dtau)/d(omega_n), omega_n*gamma3*(2) + s*omega3*(I3/I1), omega_tau - ((1)/Theta)*(m*R*I3)*V,
 *      d(d(omega_n)/dtau)/d(gamma3),
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(I3^2 + m*R^2*I3) - omega_n*gamma3*(m*R^2*I3),
 *      d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(gamma3),
 *      d(numerator of d(omega3)/dt over Theta)/d(omega_tau) = s*omega3*(m*R^2*(I1 - I3))*s*gamma3 - (m*R^2*I1)*s*omega_n,
 *      d(numerator of d(omega3)/dt over Theta)/d(s) = s*omega_tau*gamma3*omega3*(2*m*R^2*(I1 - I3)) - omega_n*V*(m*R*I1),
 *      d(d(omega3)/dtau)/d(s)
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_avx512;

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
    const double t0 = params[5]/params[4]; /* I3/I1 */
    out[6] = t0;
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    out[40] = t2;
    const double t3 = params[5]/t2; /* I3/(m*R*R) */
    out[7] = t3;
    const double t4 = 1.0/params[1]; /* 1/R */
    out[8] = t4;
    const double t5 = params[4]*t2; /* I1*m*R*R */
    out[21] = t5;
    const double t6 = params[5]*params[5]; /* I3*I3 */
    const double t7 = params[5]*t2; /* I3*m*R*R */
    out[22] = t7;
    const double t8 = t6 + t7; /* I3*I3 + I3*m*R*R */
    out[23] = t8;
    const double t9 = t8/t5; /* (I3*I3 + I3*m*R*R)/(I1*m*R*R) */
    out[9] = t9;
    const double t10 = params[4] - params[5]; /* I1 - I3 */
    const double t11 = t10/params[4]; /* (I1 - I3)/I1 */
    out[10] = t11;
    const double t12 = params[1]*2.0; /* R*2 */
    out[11] = t12;
    const double t13 = -t0; /* -I3/I1 */
    out[12] = t13;
    const double t14 = params[4]*params[4]; /* I1*I1 */
    const double t15 = t6*2.0; /* I3*I3*2 */
    const double t16 = t15/t14; /* I3*I3*2/(I1*I1) */
    out[13] = t16;
    const double t17 = params[0]*params[0]; /* m*m */
    const double t18 = t1*t1; /* R*R*R*R */
    const double t19 = t17*t18; /* m*m*R*R*R*R */
    const double t20 = t14*t19; /* I1*I1*m*m*R*R*R*R */
    const double t21 = params[5]*t6; /* I3*I3*I3 */
    const double t22 = t2*t21; /* m*R*R*I3*I3*I3 */
    const double t23 = t6*t19; /* I3*I3*m*m*R*R*R*R */
    const double t24 = t22 + t23; /* m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R */
    const double t25 = 2.0*t24; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R) */
    const double t26 = t25/t20; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R)/(I1*I1*m*m*R*R*R*R) */
    out[14] = t26;
    const double t27 = params[4]*params[1]; /* I1*R */
    out[36] = t27;
    const double t28 = params[5]/t27; /* I3/(I1*R) */
    out[32] = t28;
    const double t29 = -t28; /* -I3/(I1*R) */
    out[15] = t29;
    const double t30 = t5*t6; /* I1*m*R*R*I3*I3 */
    const double t31 = params[4]*t19; /* I1*m*m*R*R*R*R */
    const double t32 = params[5]*t31; /* I3*I1*m*m*R*R*R*R */
    const double t33 = t30 + t32; /* I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R */
    const double t34 = 2.0*t33; /* 2*(I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R) */
    const double t35 = t34/t20; /* 2*(I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R)/(I1*I1*m*m*R*R*R*R) */
    out[16] = t35;
    const double t36 = params[5]*2.0; /* I3*2 */
    const double t37 = t36/params[4]; /* I3*2/I1 */
    out[17] = t37;
    const double t38 = t10*t36; /* (I1 - I3)*I3*2 */
    const double t39 = t38/t14; /* (I1 - I3)*I3*2/(I1*I1) */
    out[18] = t39;
    const double t40 = (-1.0)/params[1]; /* (-1)/R */
    out[19] = t40;
    const double t41 = params[4]*params[5]; /* I1*I3 */
    out[20] = t41;
    const double t42 = params[0]*params[1]; /* m*R */
    const double t43 = params[5]*t42; /* I3*m*R */
    out[24] = t43;
    const double t44 = params[4]*t42; /* I1*m*R */
    out[25] = t44;
    const double t45 = t2*t10; /* m*R*R*(I1 - I3) */
    out[26] = t45;
    const double t46 = params[0]*2.0; /* m*2 */
    const double t47 = t1*t46; /* R*R*m*2 */
    const double t48 = params[5]*t47; /* I3*R*R*m*2 */
    out[27] = t48;
    const double t49 = -t43; /* -I3*m*R */
    out[28] = t49;
    const double t50 = params[4]*t47; /* I1*R*R*m*2 */
    out[29] = t50;
    const double t51 = -t44; /* -I1*m*R */
    out[30] = t51;
    const double t52 = t10*t47; /* (I1 - I3)*R*R*m*2 */
    out[31] = t52;
    const double t53 = params[4]/2.0; /* I1/2 */
    out[33] = t53;
    const double t54 = params[0]/params[4]; /* m/I1 */
    out[34] = t54;
    const double t55 = t2/params[4]; /* m*R*R/I1 */
    out[35] = t55;
    const double t56 = params[5]*params[1]; /* I3*R */
    out[37] = t56;
    const double t57 = params[0]*t14; /* m*I1*I1 */
    out[38] = t57;
    const double t58 = t5*t10; /* I1*m*R*R*(I1 - I3) */
    out[39] = t58;
    const double t59 = -t56; /* -I3*R */
    out[41] = t59;
    const double t60 = t10*t48; /* (I1 - I3)*I3*R*R*m*2 */
    out[42] = t60;
    const double t61 = t14*t46; /* I1*I1*m*2 */
    out[43] = t61;
    const double t62 = params[1]*t46; /* R*m*2 */
    const double t63 = t14*t62; /* I1*I1*R*m*2 */
    out[44] = t63;
    const double t64 = t10*t50; /* (I1 - I3)*I1*R*R*m*2 */
    out[45] = t64;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[2]; /* s*omega_tau */
    const double t1 = x[5]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = x[5]*x[4]; /* s*omega3 */
    const double t3 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t4 = t2 + t3; /* s*omega3 + omega_n*gamma3 */
    const double t5 = p[1]*x[3]; /* R*omega_n */
    const double t6 = t4*t5; /* (s*omega3 + omega_n*gamma3)*R*omega_n */
    out[1] = t6;
    const double t7 = JLT_FMA(t2, p[6], t3); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t8 = x[3]*t7; /* omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t9 = -t8; /* -omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    out[2] = t9;
    const double t10 = x[0]*p[6]; /* gamma3*I3/I1 */
    const double t11 = JLT_FMA(x[5], x[5], p[7]); /* s*s + I3/(m*R^2) */
    const double t12 = JLT_FMA(x[0], t10, t11); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t13 = 1.0/t12; /* 1/(Theta/(m*R^2*I1)) */
    const double t14 = JLT_FMA(p[8], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t15 = t13*t14; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t16 = JLT_FNMA(p[6], t15, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t17 = t3*t16; /* omega_n*gamma3*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    const double t18 = t2*t13; /* s*omega3*1/(Theta/(m*R^2*I1)) */
    const double t19 = x[2]*p[9]; /* omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t20 = JLT_FMA(t18, t19, t17); /* s*omega3*1/(Theta/(m*R^2*I1))*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) + omega_n*gamma3*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    out[3] = t20;
    const double t21 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t22 = p[10]*t21; /* (I1 - I3)/I1*s*omega_tau*gamma3 */
    const double t23 = t18*t22; /* s*omega3*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*s*omega_tau*gamma3 */
    const double t24 = x[5]*x[3]; /* s*omega_n */
    const double t25 = JLT_FNMA(t15, t24, t23); /* t23 - 1/(Theta/(m*R^2*I1))*V/R*s*omega_n */
    out[4] = t25;
    const double t26 = -t21; /* -s*omega_tau*gamma3 */
    out[5] = t26;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[31] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    const double t0 = x[5]*x[5]; /* s*s */
    out[2] = t0;
    const double t1 = x[5]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[5] = t2;
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    out[6] = t4;
    const double t5 = x[5]*x[4]; /* s*omega3 */
    const double t6 = p[1]*t5; /* R*s*omega3 */
    const double t7 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t8 = JLT_FMA(p[11], t7, t6); /* 2*R*omega_n*gamma3 + R*s*omega3 */
    out[9] = t8;
    const double t9 = x[5]*x[3]; /* s*omega_n */
    const double t10 = p[1]*t9; /* R*s*omega_n */
    out[10] = t10;
    const double t11 = x[3]*x[4]; /* omega_n*omega3 */
    const double t12 = p[1]*t11; /* R*omega_n*omega3 */
    out[11] = t12;
    const double t13 = -t3; /* -omega_n*omega_n */
    out[12] = t13;
    const double t14 = t7*(-2.0); /* omega_n*gamma3*(-2) */
    const double t15 = JLT_FMA(t5, p[12], t14); /* s*omega3*(-I3/I1) + omega_n*gamma3*(-2) */
    out[15] = t15;
    const double t16 = t9*p[12]; /* s*omega_n*(-I3/I1) */
    out[16] = t16;
    const double t17 = t11*p[12]; /* omega_n*omega3*(-I3/I1) */
    out[17] = t17;
    const double t18 = x[0]*p[6]; /* gamma3*I3/I1 */
    const double t19 = t0 + p[7]; /* s*s + I3/(m*R^2) */
    const double t20 = JLT_FMA(x[0], t18, t19); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t21 = 1.0/t20; /* 1/(Theta/(m*R^2*I1)) */
    const double t22 = JLT_FMA(p[8], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t23 = t21*t22; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t24 = JLT_FNMA(p[6], t23, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t25 = x[3]*t24; /* omega_n*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    const double t26 = t7*t21; /* omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t27 = x[0]*p[13]; /* gamma3*2*I3^2/I1^2 */
    const double t28 = t26*t27; /* omega_n*gamma3*1/(Theta/(m*R^2*I1))*gamma3*2*I3^2/I1^2 */
    const double t29 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t30 = x[5]*t21; /* s*1/(Theta/(m*R^2*I1)) */
    const double t31 = x[0]*t30; /* gamma3*s*1/(Theta/(m*R^2*I1)) */
    const double t32 = t29*t31; /* omega_tau*omega3*gamma3*s*1/(Theta/(m*R^2*I1)) */
    const double t33 = t21*p[14]; /* 1/(Theta/(m*R^2*I1))*2*(m*R^2*I3^3 + m^2*R^4*I3^2)/(m^2*R^4*I1^2) */
    const double t34 = JLT_FMA(t23, t28, t25); /* 1/(Theta/(m*R^2*I1))*V/R*omega_n*gamma3*1/(Theta/(m*R^2*I1))*gamma3*2*I3^2/I1^2 + omega_n*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    const double t35 = JLT_FNMA(t32, t33, t34); /* t34 - omega_tau*omega3*gamma3*s*1/(Theta/(m*R^2*I1))*t33 */
    out[18] = t35;
    const double t36 = t26*p[15]; /* omega_n*gamma3*1/(Theta/(m*R^2*I1))*(-I3/(R*I1)) */
    out[19] = t36;
    const double t37 = t30*p[9]; /* s*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t38 = JLT_FNMA(p[6], t26, t7); /* omega_n*gamma3 - I3/I1*omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t39 = JLT_FMA(x[4], t37, t38); /* omega3*s*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) + omega_n*gamma3 - I3/I1*omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    out[20] = t39;
    const double t40 = x[0]*t24; /* gamma3*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    out[21] = t40;
    const double t41 = x[2]*t37; /* omega_tau*s*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    out[22] = t41;
    const double t42 = t21*p[9]; /* 1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t43 = t30*p[16]; /* s*1/(Theta/(m*R^2*I1))*2*(m*R^2*I1*I3^2 + m^2*R^4*I1*I3)/(m^2*R^4*I1^2) */
    const double t44 = JLT_FNMA(t30, t43, t42); /* 1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) - s*1/(Theta/(m*R^2*I1))*t43 */
    const double t45 = x[3]*t23; /* omega_n*1/(Theta/(m*R^2*I1))*V/R */
    const double t46 = p[17]*t45; /* 2*I3/I1*omega_n*1/(Theta/(m*R^2*I1))*V/R */
    const double t47 = t31*t46; /* gamma3*s*1/(Theta/(m*R^2*I1))*2*I3/I1*omega_n*1/(Theta/(m*R^2*I1))*V/R */
    const double t48 = JLT_FMA(t29, t44, t47); /* omega_tau*omega3*t44 + t47 */
    out[23] = t48;
    const double t49 = t31*p[18]; /* gamma3*s*1/(Theta/(m*R^2*I1))*2*I3*(I1 - I3)/I1^2 */
    const double t50 = x[5]*p[10]; /* s*(I1 - I3)/I1 */
    const double t51 = t30*t50; /* s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    const double t52 = JLT_FMA(t29, t51, t47); /* omega_tau*omega3*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 + t47 */
    const double t53 = JLT_FNMA(t32, t49, t52); /* omega_tau*omega3*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 + t47 - omega_tau*omega3*gamma3*s*1/(Theta/(m*R^2*I1))*gamma3*s*1/(Theta/(m*R^2*I1))*2*I3*(I1 - I3)/I1^2 */
    out[24] = t53;
    const double t54 = x[3]*t30; /* omega_n*s*1/(Theta/(m*R^2*I1)) */
    const double t55 = p[19]*t54; /* (-1/R)*omega_n*s*1/(Theta/(m*R^2*I1)) */
    out[25] = t55;
    const double t56 = t31*t50; /* gamma3*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    const double t57 = JLT_FMS(x[4], t56, t54); /* omega3*gamma3*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 - omega_n*s*1/(Theta/(m*R^2*I1)) */
    out[26] = t57;
    const double t58 = t22*t30; /* V/R*s*1/(Theta/(m*R^2*I1)) */
    const double t59 = -t58; /* -V/R*s*1/(Theta/(m*R^2*I1)) */
    out[27] = t59;
    const double t60 = x[2]*t56; /* omega_tau*gamma3*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    out[28] = t60;
    const double t61 = t54*t58; /* omega_n*s*1/(Theta/(m*R^2*I1))*V/R*s*1/(Theta/(m*R^2*I1)) */
    const double t62 = p[10] - t51; /* (I1 - I3)/I1 - s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    const double t63 = JLT_FMA(t32, t62, t61); /* omega_tau*omega3*gamma3*s*1/(Theta/(m*R^2*I1))*((I1 - I3)/I1 - s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1) + omega_n*s*1/(Theta/(m*R^2*I1))*V/R*s*1/(Theta/(m*R^2*I1)) */
    const double t64 = JLT_FMS(2.0, t63, t45); /* 2*t63 - omega_n*1/(Theta/(m*R^2*I1))*V/R */
    out[29] = t64;
    const double t65 = -t1; /* -s*omega_tau */
    out[30] = t65;
    const double t66 = x[5]*x[0]; /* s*gamma3 */
    const double t67 = -t66; /* -s*gamma3 */
    out[32] = t67;
    const double t68 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t69 = -t68; /* -omega_tau*gamma3 */
    out[35] = t69;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[2]; /* s*omega_tau */
    const double t1 = x[5]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = x[5]*x[4]; /* s*omega3 */
    const double t3 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t4 = t2 + t3; /* s*omega3 + omega_n*gamma3 */
    const double t5 = x[3]*p[1]; /* omega_n*R */
    const double t6 = t4*t5; /* (s*omega3 + omega_n*gamma3)*omega_n*R */
    out[1] = t6;
    const double t7 = t2*p[6]; /* s*omega3*I3/I1 */
    const double t8 = t3 + t7; /* omega_n*gamma3 + s*omega3*I3/I1 */
    const double t9 = x[3]*t8; /* omega_n*(omega_n*gamma3 + s*omega3*I3/I1) */
    const double t10 = -t9; /* -omega_n*(omega_n*gamma3 + s*omega3*I3/I1) */
    out[2] = t10;
    const double t11 = x[5]*x[5]; /* s*s */
    out[8] = t11;
    const double t12 = x[0]*p[22]; /* gamma3*m*R^2*I3 */
    const double t13 = JLT_FMA(p[21], t11, p[20]); /* m*R^2*I1*s*s + I1*I3 */
    const double t14 = JLT_FMA(x[0], t12, t13); /* Theta = gamma3*gamma3*m*R^2*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t15 = 1.0/t14; /* 1/Theta */
    const double t16 = x[2]*p[23]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t17 = t2*t16; /* s*omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t19 = p[24]*t18; /* m*R*I3*V */
    const double t20 = JLT_FNMA(t3, t19, t17); /* numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*m*R*I3*V */
    const double t21 = t15*t20; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t22 = JLT_FMA(x[2], t3, t21); /* omega_tau*omega_n*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t22;
    const double t23 = t18*p[25]; /* V*m*R*I1 */
    const double t24 = x[5]*x[3]; /* s*omega_n */
    const double t25 = t23*t24; /* V*m*R*I1*s*omega_n */
    const double t26 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t27 = t2*p[26]; /* s*omega3*m*R^2*(I1 - I3) */
    const double t28 = JLT_FMS(t26, t27, t25); /* numerator of d(omega3)/dt over Theta = s*omega_tau*gamma3*s*omega3*m*R^2*(I1 - I3) - V*m*R*I1*s*omega_n */
    const double t29 = t15*t28; /* 1/Theta*numerator of d(omega3)/dt over Theta */
    out[4] = t29;
    const double t30 = -t26; /* -s*omega_tau*gamma3 */
    out[5] = t30;
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[19] = 0.0;
    out[20] = 0.0;
    out[37] = 0.0;
    out[39] = 0.0;
    out[40] = 0.0;
    const double t31 = t0*2.0; /* s*omega_tau*2 */
    out[11] = t31;
    const double t32 = x[3]*t5; /* omega_n*omega_n*R */
    out[12] = t32;
    const double t33 = t2*p[1]; /* s*omega3*R */
    const double t34 = JLT_FMA(t3, p[11], t33); /* omega_n*gamma3*2*R + s*omega3*R */
    out[15] = t34;
    const double t35 = p[1]*t24; /* R*s*omega_n */
    out[16] = t35;
    const double t36 = x[4]*t5; /* omega3*omega_n*R */
    out[17] = t36;
    const double t37 = x[3]*x[3]; /* omega_n*omega_n */
    const double t38 = -t37; /* -omega_n*omega_n */
    out[18] = t38;
    const double t39 = JLT_FMA(t3, 2.0, t7); /* omega_n*gamma3*2 + s*omega3*I3/I1 */
    const double t40 = -t39; /* -(omega_n*gamma3*2 + s*omega3*I3/I1) */
    out[21] = t40;
    const double t41 = t24*p[12]; /* s*omega_n*(-I3/I1) */
    out[22] = t41;
    const double t42 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    const double t43 = x[4]*t42; /* omega3*omega_n*(-I3/I1) */
    out[23] = t43;
    const double t44 = JLT_FNMA(t15, t19, x[2]); /* omega_tau - 1/Theta*m*R*I3*V */
    const double t45 = x[3]*t44; /* omega_n*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t46 = x[0]*p[27]; /* gamma3*2*m*R^2*I3 */
    const double t47 = t15*t46; /* 1/Theta*gamma3*2*m*R^2*I3 */
    const double t48 = JLT_FNMA(t21, t47, t45); /* omega_n*(omega_tau - 1/Theta*m*R*I3*V) - 1/Theta*numerator of d(omega_n)/dt over Theta*1/Theta*gamma3*2*m*R^2*I3 */
    out[24] = t48;
    const double t49 = t3*p[28]; /* omega_n*gamma3*(-m*R*I3) */
    const double t50 = t15*t49; /* 1/Theta*omega_n*gamma3*(-m*R*I3) */
    out[25] = t50;
    const double t51 = t2*p[23]; /* s*omega3*(I3^2 + m*R^2*I3) */
    const double t52 = JLT_FNMA(t3, p[22], t51); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(I3^2 + m*R^2*I3) - omega_n*gamma3*m*R^2*I3 */
    const double t53 = JLT_FMA(t15, t52, t3); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[26] = t53;
    const double t54 = x[0]*t44; /* gamma3*(omega_tau - 1/Theta*m*R*I3*V) */
    out[27] = t54;
    const double t55 = t0*t15; /* s*omega_tau*1/Theta */
    const double t56 = p[23]*t55; /* (I3^2 + m*R^2*I3)*s*omega_tau*1/Theta */
    out[28] = t56;
    const double t57 = x[4]*t16; /* omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t58 = t15*t57; /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t59 = x[5]*t15; /* s*1/Theta */
    const double t60 = p[29]*t59; /* 2*m*R^2*I1*s*1/Theta */
    const double t61 = JLT_FNMA(t21, t60, t58); /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    out[29] = t61;
    const double t62 = t27*t55; /* s*omega3*m*R^2*(I1 - I3)*s*omega_tau*1/Theta */
    const double t63 = JLT_FNMA(t29, t47, t62); /* s*omega3*m*R^2*(I1 - I3)*s*omega_tau*1/Theta - 1/Theta*numerator of d(omega3)/dt over Theta*1/Theta*gamma3*2*m*R^2*I3 */
    out[30] = t63;
    const double t64 = t24*p[30]; /* s*omega_n*(-m*R*I1) */
    const double t65 = t15*t64; /* 1/Theta*s*omega_n*(-m*R*I1) */
    out[31] = t65;
    const double t66 = x[5]*x[0]; /* s*gamma3 */
    const double t67 = t27*t66; /* s*omega3*m*R^2*(I1 - I3)*s*gamma3 */
    const double t68 = JLT_FNMA(p[21], t24, t67); /* d(numerator of d(omega3)/dt over Theta)/d(omega_tau) = s*omega3*m*R^2*(I1 - I3)*s*gamma3 - m*R^2*I1*s*omega_n */
    const double t69 = t15*t68; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(omega_tau) */
    out[32] = t69;
    const double t70 = t23*t59; /* V*m*R*I1*s*1/Theta */
    const double t71 = -t70; /* -V*m*R*I1*s*1/Theta */
    out[33] = t71;
    const double t72 = t26*p[26]; /* s*omega_tau*gamma3*m*R^2*(I1 - I3) */
    const double t73 = t59*t72; /* s*1/Theta*s*omega_tau*gamma3*m*R^2*(I1 - I3) */
    out[34] = t73;
    const double t74 = t29*t60; /* 1/Theta*numerator of d(omega3)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    const double t75 = x[3]*t23; /* omega_n*V*m*R*I1 */
    const double t76 = x[4]*p[31]; /* omega3*2*m*R^2*(I1 - I3) */
    const double t77 = JLT_FMS(t26, t76, t75); /* d(numerator of d(omega3)/dt over Theta)/d(s) = s*omega_tau*gamma3*omega3*2*m*R^2*(I1 - I3) - omega_n*V*m*R*I1 */
    const double t78 = JLT_FMS(t15, t77, t74); /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) - t74 */
    out[35] = t78;
    const double t79 = -t0; /* -s*omega_tau */
    out[36] = t79;
    const double t80 = -t66; /* -s*gamma3 */
    out[38] = t80;
    const double t81 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t82 = -t81; /* -omega_tau*gamma3 */
    out[41] = t82;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[0]*p[6]; /* gamma3*I3/I1 */
    const double t2 = p[7] + t0; /* I3/(m*R^2) + s*s */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s*s */
    const double t4 = p[10]*x[2]; /* (I1 - I3)/I1*omega_tau */
    const double t5 = t0*t4; /* s*s*(I1 - I3)/I1*omega_tau */
    const double t6 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t7 = JLT_FNMA(p[32], t6, t5); /* s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V */
    const double t8 = x[0]*t7; /* gamma3*(s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V) */
    const double t9 = t8/t3; /* gamma3*(s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V)/(Theta/(m*R^2*I1)) */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[34]*x[1]; /* m/I1*v_nu */
    const double t1 = x[3]*x[3]; /* omega_n*omega_n */
    const double t2 = x[4]*x[4]; /* omega3*omega3 */
    const double t3 = x[4]*x[5]; /* omega3*s */
    const double t4 = JLT_FMA(x[3], x[0], t3); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t5 = p[35]*t4; /* m*R^2/I1*v_tau/R */
    const double t6 = JLT_FMA(x[2], x[2], t1); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t7 = JLT_FMA(x[1], t0, t6); /* v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t8 = JLT_FMA(p[6], t2, t7); /* I3/I1*omega3*omega3 + v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t9 = JLT_FMA(t4, t5, t8); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t8 */
    const double t10 = p[33]*t9; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t10;
    const double t11 = x[3]*p[36]; /* omega_n*R*I1 */
    const double t12 = x[5]*t11; /* s*omega_n*R*I1 */
    const double t13 = x[4]*p[37]; /* omega3*R*I3 */
    const double t14 = JLT_FNMA(x[0], t13, t12); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    out[1] = t14;
    const double t15 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t16 = p[38]*t15; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t17 = t15*t16; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t18 = p[6]*x[0]; /* I3/I1*gamma3 */
    const double t19 = JLT_FMA(x[5], x[5], p[7]); /* s*s + I3/(m*R^2) */
    const double t20 = JLT_FMA(x[0], t18, t19); /* Theta/(m*R^2*I1) = gamma3*I3/I1*gamma3 + s*s + I3/(m*R^2) */
    const double t21 = t2*p[39]; /* omega3*omega3*m*R^2*I1*(I1 - I3) */
    const double t22 = JLT_FMA(t20, t21, t17); /* Theta/(m*R^2*I1)*omega3*omega3*m*R^2*I1*(I1 - I3) + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[2] = t22;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[5]; /* omega3*s */
    const double t1 = JLT_FMA(x[3], x[0], t0); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t2 = p[40]*t1; /* m*R^2*v_tau/R */
    const double t3 = x[3]*t2; /* omega_n*m*R^2*v_tau/R */
    out[0] = t3;
    const double t4 = p[0]*x[1]; /* m*v_nu */
    out[1] = t4;
    const double t5 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t5;
    const double t6 = x[3]*p[4]; /* omega_n*I1 */
    const double t7 = JLT_FMA(x[0], t2, t6); /* d(energy)/d(omega_n) = gamma3*m*R^2*v_tau/R + omega_n*I1 */
    out[3] = t7;
    const double t8 = x[4]*p[5]; /* omega3*I3 */
    const double t9 = JLT_FMA(x[5], t2, t8); /* d(energy)/d(omega3) = s*m*R^2*v_tau/R + omega3*I3 */
    out[4] = t9;
    const double t10 = x[4]*t2; /* omega3*m*R^2*v_tau/R */
    out[5] = t10;
    const double t11 = x[4]*p[41]; /* omega3*(-R*I3) */
    out[6] = t11;
    out[7] = 0.0;
    out[8] = 0.0;
    out[15] = 0.0;
    const double t12 = x[5]*p[36]; /* s*R*I1 */
    out[9] = t12;
    const double t13 = x[0]*p[41]; /* gamma3*(-R*I3) */
    out[10] = t13;
    const double t14 = x[3]*p[36]; /* omega_n*R*I1 */
    out[11] = t14;
    const double t15 = x[4]*p[42]; /* omega3*2*m*R^2*I3*(I1 - I3) */
    const double t16 = x[4]*x[0]; /* omega3*gamma3 */
    const double t17 = t15*t16; /* omega3*2*m*R^2*I3*(I1 - I3)*omega3*gamma3 */
    out[12] = t17;
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t19 = p[43]*t18; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[13] = t19;
    const double t20 = t18*p[44]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[14] = t20;
    const double t21 = x[0]*p[6]; /* gamma3*I3/I1 */
    const double t22 = JLT_FMA(x[5], x[5], p[7]); /* s*s + I3/(m*R^2) */
    const double t23 = JLT_FMA(x[0], t21, t22); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t24 = x[4]*p[45]; /* omega3*2*m*R^2*I1*(I1 - I3) */
    const double t25 = t23*t24; /* Theta/(m*R^2*I1)*omega3*2*m*R^2*I1*(I1 - I3) */
    out[16] = t25;
    const double t26 = t0*t24; /* omega3*s*omega3*2*m*R^2*I1*(I1 - I3) */
    out[17] = t26;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[5];
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double x5[JLT_JET_ORDER_MAX + 1];
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x5, x2, k);
        t3[k] = jlt_jet_product(x5, t2, k);
        t7[k] = jlt_jet_product(x5, x4, k);
        t9[k] = jlt_jet_product(x3, x0, k);
        t10[k] = t7[k] + t9[k];
        t11[k] = p[1]*x3[k];
        t12[k] = jlt_jet_product(t10, t11, k);
        t14[k] = t7[k]*p[6] + t9[k];
        t15[k] = jlt_jet_product(x3, t14, k);
        t16[k] = -t15[k];
        t19[k] = x0[k]*p[6];
        t20[k] = jlt_jet_product(x5, x5, k) + (k == 0 ? p[7] : 0);
        t21[k] = jlt_jet_product(x0, t19, k) + t20[k];
        t23[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t21, t23, k);
        t24[k] = jlt_jet_product(t7, t23, k);
        t25[k] = x2[k]*p[9];
        t26[k] = jlt_jet_product(t24, t25, k);
        t29[k] = p[8]*x1[k] + x2[k];
        t30[k] = jlt_jet_product(t23, t29, k);
        t31[k] = x2[k] - p[6]*t30[k];
        t32[k] = jlt_jet_product(t9, t31, k) + t26[k];
        t34[k] = jlt_jet_product(t2, x0, k);
        t35[k] = p[10]*t34[k];
        t36[k] = jlt_jet_product(t24, t35, k);
        t37[k] = jlt_jet_product(x5, x3, k);
        t38[k] = t36[k] - jlt_jet_product(t30, t37, k);
        t39[k] = -t34[k];
        double *restrict next = coefficients + (k + 1)*7;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t12[k]/(k + 1);
        next[2] = x2[k + 1] = t16[k]/(k + 1);
        next[3] = x3[k + 1] = t32[k]/(k + 1);
        next[4] = x4[k + 1] = t38[k]/(k + 1);
        next[5] = x5[k + 1] = t39[k]/(k + 1);
        next[6] = x5[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[5];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = (0.0);
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega3 = x[4];
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = params[5];
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta));
    out[4] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[5] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    out[3] = x[3];
    out[4] = x[4];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[5] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[5]*x[5]; /* s*s */
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
    out[3] = 0.0;
    out[4] = 0.0;
    const double t1 = 2.0*x[5]; /* 2*s */
    out[5] = t1;
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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

const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .scales = 1,
    .state_count = 6, .param_count = 6, .prepared_count = 46,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 6, { 3, 16, 7, 1, 0, 0, 7, 7 }, { 12, 57, 0, 6, 0, 0, 10, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in s*omega3 + omega_n*gamma3, s*omega3*(I3/I1) + omega_n*gamma3, V/R = (1/R)*v_nu + omega_tau, omega_tau - (I3/I1)*((1)/Theta/(m*R^2*I1))*V/R, d(omega_n)/dtau, d(omega3)/dtau" },
    .jacobian = { jacobian, 36, { 7, 46, 16, 1, 0, 0, 10, 15 }, { 40, 250, 0, 31, 0, 0, 13, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in d(d(v_nu)/dtau)/d(omega_n), d(d(omega_tau)/dtau)/d(omega_n), V/R = (1/R)*v_nu + omega_tau, omega_tau - (I3/I1)*((1)/Theta/(m*R^2*I1))*V/R, d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), a part of d(d(omega_n)/dtau)/d(s), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(omega_tau), (I1 - I3)/I1 - s*((1)/Theta/(m*R^2*I1))*s*((I1 - I3)/I1), a part of d(d(omega3)/dtau)/d(s), d(d(omega3)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 42, { 10, 55, 17, 1, 0, 0, 8, 16 }, { 49, 295, 0, 37, 0, 0, 13, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in s*omega3 + omega_n*gamma3, omega_n*gamma3 + s*omega3*(I3/I1), V = omega_tau*R + v_nu, numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*(m*R*I3)*V, d(omega_n)/dtau, numerator of d(omega3)/dt over Theta = s*omega_tau*gamma3*s*omega3*(m*R^2*(I1 - I3)) - V*(m*R*I1)*s*omega_n, d(d(v_nu)/dtau)/d(omega_n), omega_n*gamma3*(2) + s*omega3*(I3/I1), omega_tau - ((1)/Theta)*(m*R*I3)*V, d(d(omega_n)/dtau)/d(gamma3), d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(I3^2 + m*R^2*I3) - omega_n*gamma3*(m*R^2*I3), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(omega_tau) = s*omega3*(m*R^2*(I1 - I3))*s*gamma3 - (m*R^2*I1)*s*omega_n, d(numerator of d(omega3)/dt over Theta)/d(s) = s*omega_tau*gamma3*omega3*(2*m*R^2*(I1 - I3)) - omega_n*V*(m*R*I1), d(d(omega3)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 1, 5, 3, 1, 0, 0, 5, 4 }, { 5, 23, 0, 2, 0, 0, 8, 5 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, s*s*((I1 - I3)/I1)*omega_tau - (I3/(R*I1))*V" },
    .integral_values = { integral_values, 3, { 0, 13, 10, 0, 0, 0, 6, 6 }, { 11, 44, 0, 0, 0, 0, 9, 6 },
        "digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, G, omega_tau*R + v_nu, F0" },
    .integral_gradients = { integral_gradients, 18, { 0, 21, 6, 0, 0, 0, 4, 4 }, { 12, 69, 0, 0, 0, 0, 8, 5 },
        "digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, d(E)/d(omega_n), d(E)/d(omega3), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_in_regular) },
#endif
};
