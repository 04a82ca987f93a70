/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I3 = I1
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   12    5    1    0    0      6    5   (63)
 *  jacobian            11   33    9    1    0    0      8   10   (242)
 *  rhs_jacobian        15   38   10    1    0    0      8   10   (290)
 *  divergence          1    1    3    1    0    0      4    3   (21)
 *  integral_values     0    9    7    0    0    0      6    4   (39)
 *  integral_gradients  0   14    4    0    0    0      5    3   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    digits are lost where terms nearly cancel in V/R = (1/R)*v_nu + omega_tau,
 *      numerator of d(omega_n)/dt over Theta/(m*R^2*I1) = s*omega3*omega_tau*((m*R^2*I1 + I1^2)/(m*R^2*I1)) - omega_n*gamma3*V/R,
 *      d(omega_n)/dtau, omega_n*gamma3 + s*omega3, omega_tau - ((1)/Theta/(m*R^2*I1))*V/R,
 *      d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(s), (2)*omega_n*gamma3 + s*omega3,
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau)/(m*R^2*I1) = ((m*R^2*I1 + I1^2)/(m*R^2*I1))*s*omega3 - omega_n*gamma3,
 *      d(d(omega_n)/dtau)/d(omega_tau)
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[4];
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
    out[15] = t1;
    const double t2 = t1*params[4]; /* m*R*R*I1 */
    const double t3 = params[4]*params[4]; /* I1*I1 */
    const double t4 = t2 + t3; /* m*R*R*I1 + I1*I1 */
    const double t5 = t4/t2; /* (m*R*R*I1 + I1*I1)/(m*R*R*I1) */
    out[6] = t5;
    const double t6 = params[4]/t1; /* I1/(m*R*R) */
    out[7] = t6;
    const double t7 = 1.0/params[1]; /* 1/R */
    out[8] = t7;
    const double t8 = (-1.0)/params[1]; /* (-1)/R */
    out[9] = t8;
    const double t9 = params[4]/2.0; /* I1/2 */
    out[10] = t9;
    const double t10 = params[0]/params[4]; /* m/I1 */
    out[11] = t10;
    const double t11 = t1/params[4]; /* m*R*R/I1 */
    out[12] = t11;
    const double t12 = params[1]*params[4]; /* R*I1 */
    out[13] = t12;
    const double t13 = params[0]*t3; /* m*I1*I1 */
    out[14] = t13;
    const double t14 = -t12; /* -R*I1 */
    out[16] = t14;
    const double t15 = params[0]*2.0; /* m*2 */
    const double t16 = t3*t15; /* I1*I1*m*2 */
    out[17] = t16;
    const double t17 = params[1]*t15; /* R*m*2 */
    const double t18 = t3*t17; /* I1*I1*R*m*2 */
    out[18] = t18;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[5], x[5], p[7]); /* s*s + I1/(m*R^2) */
    const double t1 = JLT_FMA(x[0], x[0], t0); /* Theta/(m*R^2*I1) = gamma3*gamma3 + s*s + I1/(m*R^2) */
    const double t2 = 1.0/t1; /* 1/(Theta/(m*R^2*I1)) */
    const double t3 = x[5]*x[4]; /* s*omega3 */
    const double t4 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t5 = p[6]*t3; /* (m*R^2*I1 + I1^2)/(m*R^2*I1)*s*omega3 */
    const double t6 = t3 + t4; /* s*omega3 + omega_n*gamma3 */
    const double t7 = JLT_FMA(t2, t5, t4); /* 1/(Theta/(m*R^2*I1))*(m*R^2*I1 + I1^2)/(m*R^2*I1)*s*omega3 + omega_n*gamma3 */
    const double t8 = x[3]*t6; /* omega_n*(s*omega3 + omega_n*gamma3) */
    const double t9 = x[2]*t7; /* omega_tau*t7 */
    const double t10 = p[1]*t8; /* R*omega_n*(s*omega3 + omega_n*gamma3) */
    out[1] = t10;
    const double t11 = -t8; /* -omega_n*(s*omega3 + omega_n*gamma3) */
    out[2] = t11;
    const double t12 = JLT_FMA(p[8], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t13 = t2*t12; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t14 = JLT_FNMA(t4, t13, t9); /* omega_tau*t7 - omega_n*gamma3*1/(Theta/(m*R^2*I1))*V/R */
    out[3] = t14;
    const double t15 = x[5]*x[2]; /* s*omega_tau */
    const double t16 = x[5]*t15; /* s*s*omega_tau */
    out[0] = t16;
    const double t17 = x[0]*t15; /* gamma3*s*omega_tau */
    const double t18 = -t17; /* -gamma3*s*omega_tau */
    out[5] = t18;
    const double t19 = x[5]*x[3]; /* s*omega_n */
    const double t20 = t13*t19; /* 1/(Theta/(m*R^2*I1))*V/R*s*omega_n */
    const double t21 = -t20; /* -1/(Theta/(m*R^2*I1))*V/R*s*omega_n */
    out[4] = t21;
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
    out[28] = 0.0;
    out[31] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    const double t0 = x[5]*x[5]; /* s*s */
    out[2] = t0;
    const double t1 = p[7] + t0; /* I1/(m*R^2) + s*s */
    const double t2 = JLT_FMA(x[0], x[0], t1); /* Theta/(m*R^2*I1) = gamma3*gamma3 + I1/(m*R^2) + s*s */
    const double t3 = 1.0/t2; /* 1/(Theta/(m*R^2*I1)) */
    const double t4 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t5 = JLT_FMA(p[8], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t6 = x[5]*x[4]; /* s*omega3 */
    const double t7 = t4*t5; /* omega_n*gamma3*V/R */
    const double t8 = t3*t5; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t9 = x[2]*p[6]; /* omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t10 = JLT_FMS(t6, t9, t7); /* numerator of d(omega_n)/dt over Theta/(m*R^2*I1) = s*omega3*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) - omega_n*gamma3*V/R */
    const double t11 = t3*t10; /* 1/(Theta/(m*R^2*I1))*numerator of d(omega_n)/dt over Theta/(m*R^2*I1) */
    const double t12 = t3*t9; /* 1/(Theta/(m*R^2*I1))*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t13 = x[5]*t12; /* s*1/(Theta/(m*R^2*I1))*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    out[22] = t13;
    const double t14 = x[4]*t12; /* omega3*1/(Theta/(m*R^2*I1))*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t15 = x[5]*x[3]; /* s*omega_n */
    const double t16 = p[1]*t15; /* R*s*omega_n */
    out[10] = t16;
    const double t17 = -t15; /* -s*omega_n */
    out[16] = t17;
    const double t18 = x[2] - t8; /* omega_tau - 1/(Theta/(m*R^2*I1))*V/R */
    const double t19 = x[0]*t18; /* gamma3*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) */
    out[21] = t19;
    const double t20 = x[3]*t18; /* omega_n*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) */
    const double t21 = 2.0*t3; /* 2*1/(Theta/(m*R^2*I1)) */
    const double t22 = t11*t21; /* t11*2*1/(Theta/(m*R^2*I1)) */
    const double t23 = JLT_FNMA(x[0], t22, t20); /* omega_n*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) - gamma3*t11*2*1/(Theta/(m*R^2*I1)) */
    out[18] = t23;
    const double t24 = JLT_FNMA(x[5], t22, t14); /* t14 - s*t11*2*1/(Theta/(m*R^2*I1)) */
    out[23] = t24;
    const double t25 = x[5]*t8; /* s*1/(Theta/(m*R^2*I1))*V/R */
    const double t26 = t21*t25; /* 2*1/(Theta/(m*R^2*I1))*s*1/(Theta/(m*R^2*I1))*V/R */
    const double t27 = -t25; /* -s*1/(Theta/(m*R^2*I1))*V/R */
    out[27] = t27;
    const double t28 = x[3]*t8; /* omega_n*1/(Theta/(m*R^2*I1))*V/R */
    const double t29 = JLT_FMS(t15, t26, t28); /* s*omega_n*2*1/(Theta/(m*R^2*I1))*s*1/(Theta/(m*R^2*I1))*V/R - omega_n*1/(Theta/(m*R^2*I1))*V/R */
    out[29] = t29;
    const double t30 = t4*t26; /* omega_n*gamma3*2*1/(Theta/(m*R^2*I1))*s*1/(Theta/(m*R^2*I1))*V/R */
    out[24] = t30;
    const double t31 = t3*t15; /* 1/(Theta/(m*R^2*I1))*s*omega_n */
    const double t32 = p[9]*t31; /* (-1/R)*1/(Theta/(m*R^2*I1))*s*omega_n */
    out[25] = t32;
    const double t33 = -t31; /* -1/(Theta/(m*R^2*I1))*s*omega_n */
    out[26] = t33;
    const double t34 = x[5]*x[2]; /* s*omega_tau */
    const double t35 = 2.0*t34; /* 2*s*omega_tau */
    out[5] = t35;
    const double t36 = -t34; /* -s*omega_tau */
    out[30] = t36;
    const double t37 = x[3]*x[3]; /* omega_n*omega_n */
    const double t38 = p[1]*t37; /* R*omega_n*omega_n */
    out[6] = t38;
    const double t39 = -t37; /* -omega_n*omega_n */
    out[12] = t39;
    const double t40 = JLT_FMA(2.0, t4, t6); /* 2*omega_n*gamma3 + s*omega3 */
    const double t41 = JLT_FMS(p[6], t6, t4); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau)/(m*R^2*I1) = (m*R^2*I1 + I1^2)/(m*R^2*I1)*s*omega3 - omega_n*gamma3 */
    const double t42 = JLT_FMA(t3, t41, t4); /* 1/(Theta/(m*R^2*I1))*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau)/(m*R^2*I1) + omega_n*gamma3 */
    out[20] = t42;
    const double t43 = p[9]*t4; /* (-1/R)*omega_n*gamma3 */
    const double t44 = t3*t43; /* 1/(Theta/(m*R^2*I1))*(-1/R)*omega_n*gamma3 */
    out[19] = t44;
    const double t45 = p[1]*t40; /* R*(2*omega_n*gamma3 + s*omega3) */
    out[9] = t45;
    const double t46 = -t40; /* -(2*omega_n*gamma3 + s*omega3) */
    out[15] = t46;
    const double t47 = x[3]*x[4]; /* omega_n*omega3 */
    const double t48 = p[1]*t47; /* R*omega_n*omega3 */
    out[11] = t48;
    const double t49 = -t47; /* -omega_n*omega3 */
    out[17] = t49;
    const double t50 = x[5]*x[0]; /* s*gamma3 */
    const double t51 = -t50; /* -s*gamma3 */
    out[32] = t51;
    const double t52 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t53 = -t52; /* -omega_tau*gamma3 */
    out[35] = t53;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[19] = 0.0;
    out[20] = 0.0;
    out[34] = 0.0;
    out[37] = 0.0;
    out[39] = 0.0;
    out[40] = 0.0;
    const double t0 = x[5]*x[5]; /* s*s */
    out[8] = t0;
    const double t1 = p[7] + t0; /* I1/(m*R^2) + s*s */
    const double t2 = JLT_FMA(x[0], x[0], t1); /* Theta/(m*R^2*I1) = gamma3*gamma3 + I1/(m*R^2) + s*s */
    const double t3 = 1.0/t2; /* 1/(Theta/(m*R^2*I1)) */
    const double t4 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t5 = JLT_FMA(p[8], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t6 = x[5]*x[4]; /* s*omega3 */
    const double t7 = t4*t5; /* omega_n*gamma3*V/R */
    const double t8 = x[2]*p[6]; /* omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t9 = JLT_FMS(t6, t8, t7); /* numerator of d(omega_n)/dt over Theta/(m*R^2*I1) = s*omega3*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) - omega_n*gamma3*V/R */
    const double t10 = t3*t9; /* 1/(Theta/(m*R^2*I1))*numerator of d(omega_n)/dt over Theta/(m*R^2*I1) */
    const double t11 = t3*t8; /* 1/(Theta/(m*R^2*I1))*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t12 = JLT_FMA(x[2], t4, t10); /* omega_tau*omega_n*gamma3 + t10 */
    out[3] = t12;
    const double t13 = x[5]*t11; /* s*1/(Theta/(m*R^2*I1))*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    out[28] = t13;
    const double t14 = x[4]*t11; /* omega3*1/(Theta/(m*R^2*I1))*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t15 = x[5]*x[3]; /* s*omega_n */
    const double t16 = p[1]*t15; /* R*s*omega_n */
    out[16] = t16;
    const double t17 = -t15; /* -s*omega_n */
    out[22] = t17;
    const double t18 = t3*t15; /* 1/(Theta/(m*R^2*I1))*s*omega_n */
    const double t19 = p[9]*t18; /* (-1/R)*1/(Theta/(m*R^2*I1))*s*omega_n */
    out[31] = t19;
    const double t20 = -t18; /* -1/(Theta/(m*R^2*I1))*s*omega_n */
    out[32] = t20;
    const double t21 = t3*t5; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t22 = t5*t18; /* V/R*1/(Theta/(m*R^2*I1))*s*omega_n */
    const double t23 = -t22; /* -V/R*1/(Theta/(m*R^2*I1))*s*omega_n */
    out[4] = t23;
    const double t24 = x[5]*x[2]; /* s*omega_tau */
    const double t25 = x[5]*t24; /* s*s*omega_tau */
    out[0] = t25;
    const double t26 = 2.0*t24; /* 2*s*omega_tau */
    out[11] = t26;
    const double t27 = -t24; /* -s*omega_tau */
    out[36] = t27;
    const double t28 = x[0]*t24; /* gamma3*s*omega_tau */
    const double t29 = -t28; /* -gamma3*s*omega_tau */
    out[5] = t29;
    const double t30 = t4 + t6; /* omega_n*gamma3 + s*omega3 */
    const double t31 = x[3]*t30; /* omega_n*(omega_n*gamma3 + s*omega3) */
    const double t32 = p[1]*t31; /* R*omega_n*(omega_n*gamma3 + s*omega3) */
    out[1] = t32;
    const double t33 = -t31; /* -omega_n*(omega_n*gamma3 + s*omega3) */
    out[2] = t33;
    const double t34 = x[2] - t21; /* omega_tau - 1/(Theta/(m*R^2*I1))*V/R */
    const double t35 = x[0]*t34; /* gamma3*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) */
    out[27] = t35;
    const double t36 = x[3]*t34; /* omega_n*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) */
    const double t37 = 2.0*t3; /* 2*1/(Theta/(m*R^2*I1)) */
    const double t38 = t10*t37; /* t10*2*1/(Theta/(m*R^2*I1)) */
    const double t39 = JLT_FNMA(x[0], t38, t36); /* omega_n*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) - gamma3*t10*2*1/(Theta/(m*R^2*I1)) */
    out[24] = t39;
    const double t40 = JLT_FNMA(x[5], t38, t14); /* t14 - s*t10*2*1/(Theta/(m*R^2*I1)) */
    out[29] = t40;
    const double t41 = x[5]*t21; /* s*1/(Theta/(m*R^2*I1))*V/R */
    const double t42 = x[3]*t21; /* omega_n*1/(Theta/(m*R^2*I1))*V/R */
    const double t43 = -t41; /* -s*1/(Theta/(m*R^2*I1))*V/R */
    out[33] = t43;
    const double t44 = 2.0*t41; /* 2*s*1/(Theta/(m*R^2*I1))*V/R */
    const double t45 = JLT_FMS(t18, t44, t42); /* 1/(Theta/(m*R^2*I1))*s*omega_n*2*s*1/(Theta/(m*R^2*I1))*V/R - omega_n*1/(Theta/(m*R^2*I1))*V/R */
    out[35] = t45;
    const double t46 = x[3]*x[3]; /* omega_n*omega_n */
    const double t47 = p[1]*t46; /* R*omega_n*omega_n */
    out[12] = t47;
    const double t48 = -t46; /* -omega_n*omega_n */
    out[18] = t48;
    const double t49 = JLT_FMA(2.0, t4, t6); /* 2*omega_n*gamma3 + s*omega3 */
    const double t50 = JLT_FMS(p[6], t6, t4); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau)/(m*R^2*I1) = (m*R^2*I1 + I1^2)/(m*R^2*I1)*s*omega3 - omega_n*gamma3 */
    const double t51 = JLT_FMA(t3, t50, t4); /* 1/(Theta/(m*R^2*I1))*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau)/(m*R^2*I1) + omega_n*gamma3 */
    out[26] = t51;
    const double t52 = t3*t4; /* 1/(Theta/(m*R^2*I1))*omega_n*gamma3 */
    const double t53 = t44*t52; /* 2*s*1/(Theta/(m*R^2*I1))*V/R*1/(Theta/(m*R^2*I1))*omega_n*gamma3 */
    out[30] = t53;
    const double t54 = p[9]*t52; /* (-1/R)*1/(Theta/(m*R^2*I1))*omega_n*gamma3 */
    out[25] = t54;
    const double t55 = p[1]*t49; /* R*(2*omega_n*gamma3 + s*omega3) */
    out[15] = t55;
    const double t56 = -t49; /* -(2*omega_n*gamma3 + s*omega3) */
    out[21] = t56;
    const double t57 = x[3]*x[4]; /* omega_n*omega3 */
    const double t58 = p[1]*t57; /* R*omega_n*omega3 */
    out[17] = t58;
    const double t59 = -t57; /* -omega_n*omega3 */
    out[23] = t59;
    const double t60 = x[5]*x[0]; /* s*gamma3 */
    const double t61 = -t60; /* -s*gamma3 */
    out[38] = t61;
    const double t62 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t63 = -t62; /* -omega_tau*gamma3 */
    out[41] = t63;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[5], x[5], p[7]); /* s*s + I1/(m*R^2) */
    const double t1 = JLT_FMA(x[0], x[0], t0); /* Theta/(m*R^2*I1) = gamma3*gamma3 + s*s + I1/(m*R^2) */
    const double t2 = JLT_FMA(p[8], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t3 = x[0]*t2; /* gamma3*V/R */
    const double t4 = t3/t1; /* gamma3*V/R/(Theta/(m*R^2*I1)) */
    const double t5 = -t4; /* -gamma3*V/R/(Theta/(m*R^2*I1)) */
    out[0] = t5;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*x[3]; /* omega_n*omega_n */
    const double t1 = JLT_FMA(x[2], x[2], t0); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t2 = JLT_FMA(x[4], x[4], t1); /* omega3*omega3 + omega_tau*omega_tau + omega_n*omega_n */
    const double t3 = x[4]*x[5]; /* omega3*s */
    const double t4 = JLT_FMA(x[3], x[0], t3); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t5 = p[11]*x[1]; /* m/I1*v_nu */
    const double t6 = JLT_FMA(x[1], t5, t2); /* v_nu*m/I1*v_nu + omega3*omega3 + omega_tau*omega_tau + omega_n*omega_n */
    const double t7 = p[12]*t4; /* m*R^2/I1*v_tau/R */
    const double t8 = JLT_FMA(t4, t7, t6); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t6 */
    const double t9 = p[10]*t8; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t9;
    const double t10 = x[3]*x[5]; /* omega_n*s */
    const double t11 = JLT_FNMA(x[4], x[0], t10); /* omega_n*s - omega3*gamma3 */
    const double t12 = p[13]*t11; /* R*I1*(omega_n*s - omega3*gamma3) */
    out[1] = t12;
    const double t13 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[3] = t13;
    const double t14 = p[14]*t13; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t15 = t13*t14; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[2] = t15;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[5]; /* omega3*s */
    const double t1 = JLT_FMA(x[3], x[0], t0); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t2 = p[15]*t1; /* m*R^2*v_tau/R */
    const double t3 = x[3]*t2; /* omega_n*m*R^2*v_tau/R */
    out[0] = t3;
    const double t4 = p[0]*x[1]; /* m*v_nu */
    out[1] = t4;
    const double t5 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t5;
    const double t6 = x[3]*p[4]; /* omega_n*I1 */
    const double t7 = JLT_FMA(x[0], t2, t6); /* d(energy)/d(omega_n) = gamma3*m*R^2*v_tau/R + omega_n*I1 */
    out[3] = t7;
    const double t8 = x[5]*t2; /* s*m*R^2*v_tau/R */
    const double t9 = JLT_FMA(x[4], p[4], t8); /* d(energy)/d(omega3) = omega3*I1 + s*m*R^2*v_tau/R */
    out[4] = t9;
    const double t10 = x[4]*t2; /* omega3*m*R^2*v_tau/R */
    out[5] = t10;
    const double t11 = x[4]*p[16]; /* omega3*(-R*I1) */
    out[6] = t11;
    out[7] = 0.0;
    out[8] = 0.0;
    out[12] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
    const double t12 = x[5]*p[13]; /* s*R*I1 */
    out[9] = t12;
    const double t13 = x[0]*p[16]; /* gamma3*(-R*I1) */
    out[10] = t13;
    const double t14 = x[3]*p[13]; /* omega_n*R*I1 */
    out[11] = t14;
    out[20] = p[1];
    const double t15 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t16 = p[17]*t15; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[13] = t16;
    const double t17 = t15*p[18]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[14] = t17;
    out[19] = 1.0;
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
    double t8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
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
        t8[k] = jlt_jet_product(x3, x0, k);
        t9[k] = jlt_jet_product(x5, x4, k) + t8[k];
        t10[k] = jlt_jet_product(x3, t9, k);
        t11[k] = p[1]*t10[k];
        t12[k] = -t10[k];
        t14[k] = jlt_jet_product(x5, x5, k) + (k == 0 ? p[7] : 0);
        t15[k] = jlt_jet_product(x0, x0, k) + t14[k];
        t17[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t15, t17, k);
        t20[k] = p[8]*x1[k] + x2[k];
        t21[k] = jlt_jet_product(t17, t20, k);
        t22[k] = x2[k] - t21[k];
        t23[k] = jlt_jet_product(t8, t22, k);
        t25[k] = x4[k]*p[6];
        t26[k] = jlt_jet_product(t2, t25, k);
        t27[k] = jlt_jet_product(t17, t26, k) + t23[k];
        t28[k] = jlt_jet_product(x5, x3, k);
        t29[k] = jlt_jet_product(t21, t28, k);
        t30[k] = -t29[k];
        t31[k] = jlt_jet_product(t2, x0, k);
        t32[k] = -t31[k];
        double *restrict next = coefficients + (k + 1)*7;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t11[k]/(k + 1);
        next[2] = x2[k + 1] = t12[k]/(k + 1);
        next[3] = x3[k + 1] = t27[k]/(k + 1);
        next[4] = x4[k + 1] = t30[k]/(k + 1);
        next[5] = x5[k + 1] = t32[k]/(k + 1);
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
    const double v_I3 = (v_I1);
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
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .scales = 1,
    .state_count = 6, .param_count = 6, .prepared_count = 19,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 6, { 4, 12, 5, 1, 0, 0, 6, 5 }, { 11, 48, 0, 4, 0, 0, 10, 6 },
        "digits are lost where terms nearly cancel in s*omega3 + omega_n*gamma3, a part of d(omega_n)/dtau, V/R = (1/R)*v_nu + omega_tau, d(omega_n)/dtau" },
    .jacobian = { jacobian, 36, { 11, 33, 9, 1, 0, 0, 8, 10 }, { 30, 190, 0, 22, 0, 0, 13, 6 },
        "digits are lost where terms nearly cancel in V/R = (1/R)*v_nu + omega_tau, numerator of d(omega_n)/dt over Theta/(m*R^2*I1) = s*omega3*omega_tau*((m*R^2*I1 + I1^2)/(m*R^2*I1)) - omega_n*gamma3*V/R, omega_tau - ((1)/Theta/(m*R^2*I1))*V/R, d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(s), (2)*omega_n*gamma3 + s*omega3, d(numerator of d(omega_n)/dt over Theta)/d(omega_tau)/(m*R^2*I1) = ((m*R^2*I1 + I1^2)/(m*R^2*I1))*s*omega3 - omega_n*gamma3, d(d(omega_n)/dtau)/d(omega_tau)" },
    .rhs_jacobian = { rhs_jacobian, 42, { 15, 38, 10, 1, 0, 0, 8, 10 }, { 38, 226, 0, 26, 0, 0, 13, 6 },
        "digits are lost where terms nearly cancel in V/R = (1/R)*v_nu + omega_tau, numerator of d(omega_n)/dt over Theta/(m*R^2*I1) = s*omega3*omega_tau*((m*R^2*I1 + I1^2)/(m*R^2*I1)) - omega_n*gamma3*V/R, d(omega_n)/dtau, omega_n*gamma3 + s*omega3, omega_tau - ((1)/Theta/(m*R^2*I1))*V/R, d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(s), (2)*omega_n*gamma3 + s*omega3, d(numerator of d(omega_n)/dt over Theta)/d(omega_tau)/(m*R^2*I1) = ((m*R^2*I1 + I1^2)/(m*R^2*I1))*s*omega3 - omega_n*gamma3, d(d(omega_n)/dtau)/d(omega_tau)" },
    .divergence = { divergence, 1, { 1, 1, 3, 1, 0, 0, 4, 3 }, { 4, 16, 0, 1, 0, 0, 8, 5 },
        "digits are lost where terms nearly cancel in V/R = (1/R)*v_nu + omega_tau" },
    .integral_values = { integral_values, 4, { 0, 9, 7, 0, 0, 0, 6, 4 }, { 8, 31, 0, 0, 0, 0, 9, 4 },
        "digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, omega_n*s - omega3*gamma3, F_linear" },
    .integral_gradients = { integral_gradients, 24, { 0, 14, 4, 0, 0, 0, 5, 3 }, { 7, 39, 0, 0, 0, 0, 5, 4 },
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
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_equal_in_regular) },
#endif
};
