/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I3 = I1
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   13    7    1    0    0      8    6   (63)
 *  jacobian            9   31   12    1    0    0     12   13   (278)
 *  rhs_jacobian        9   37   13    1    0    0     13   12   (319)
 *  divergence          2    8    3    1    0    0      8    5   (36)
 *  integral_values     0    7    7    1    0    0      7    4   (39)
 *  integral_gradients  2   15    8    1    0    0      7    8   (72)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          1    0    1    1    0    0      3    2   (7)
 *
 *  Accuracy
 *    divides by gamma3: values and rounding errors grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n,
 *      1/gamma3*(G_level/(R*I1) - s*omega_n) - 1/gamma3*s*omega_n, V/R = (1/R)*v_nu + omega_tau,
 *      a part of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s), omega_tau - 1/(Theta/(m*R^2*I1))*V/R,
 *      d(d(omega_tau)/dtau)/d(omega_n), s*1/gamma3*(G_level/(R*I1) - s*omega_n) - omega_n*gamma3,
 *      1/gamma3*s*1/gamma3*(G_level/(R*I1) - s*omega_n) + omega_n, a part of d(d(omega_n)/dtau)/d(gamma3),
 *      d(d(omega_n)/dtau)/d(omega_tau), d(omega_n)/dtau, d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n),
 *      d(d(omega_n)/dtau)/d(s)
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_omega3;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_omega3_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[4];
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
    const double t1 = params[1]*params[4]; /* R*I1 */
    const double t2 = params[6]/t1; /* G_level/(R*I1) */
    out[8] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    out[19] = t4;
    const double t5 = params[4]/t4; /* I1/(m*R*R) */
    out[9] = t5;
    const double t6 = 1.0/params[1]; /* 1/R */
    out[10] = t6;
    const double t7 = params[4]*t4; /* I1*m*R*R */
    const double t8 = params[4]*params[4]; /* I1*I1 */
    const double t9 = t7 + t8; /* I1*m*R*R + I1*I1 */
    const double t10 = t9/t7; /* (I1*m*R*R + I1*I1)/(I1*m*R*R) */
    out[11] = t10;
    const double t11 = params[0]*params[0]; /* m*m */
    const double t12 = t3*t3; /* R*R*R*R */
    const double t13 = t11*t12; /* m*m*R*R*R*R */
    const double t14 = t8*t13; /* I1*I1*m*m*R*R*R*R */
    const double t15 = params[4]*t8; /* I1*I1*I1 */
    const double t16 = t4*t15; /* m*R*R*I1*I1*I1 */
    const double t17 = t14 + t16; /* I1*I1*m*m*R*R*R*R + m*R*R*I1*I1*I1 */
    const double t18 = 2.0*t17; /* 2*(I1*I1*m*m*R*R*R*R + m*R*R*I1*I1*I1) */
    const double t19 = t18/t14; /* 2*(I1*I1*m*m*R*R*R*R + m*R*R*I1*I1*I1)/(I1*I1*m*m*R*R*R*R) */
    out[12] = t19;
    const double t20 = params[1]*params[0]; /* R*m */
    const double t21 = params[4]/params[1]; /* I1/R */
    const double t22 = t20 + t21; /* R*m + I1/R */
    const double t23 = t22/t20; /* (R*m + I1/R)/(R*m) */
    out[13] = t23;
    const double t24 = (-1.0)/params[1]; /* (-1)/R */
    out[14] = t24;
    const double t25 = params[4]/2.0; /* I1/2 */
    out[15] = t25;
    const double t26 = params[0]/params[4]; /* m/I1 */
    out[16] = t26;
    const double t27 = t4/params[4]; /* m*R*R/I1 */
    out[17] = t27;
    const double t28 = params[0]*t8; /* m*I1*I1 */
    out[18] = t28;
    const double t29 = params[0]*2.0; /* m*2 */
    const double t30 = t8*t29; /* I1*I1*m*2 */
    out[20] = t30;
    const double t31 = params[1]*t29; /* R*m*2 */
    const double t32 = t8*t31; /* I1*I1*R*m*2 */
    out[21] = t32;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t3 = JLT_FMA(x[4], x[4], p[9]); /* s*s + I1/(m*R^2) */
    const double t4 = JLT_FMA(x[0], x[0], t3); /* Theta/(m*R^2*I1) = gamma3*gamma3 + s*s + I1/(m*R^2) */
    const double t5 = x[0]*t4; /* gamma3*Theta/(m*R^2*I1) */
    const double t6 = 1.0/t5; /* 1/(gamma3*Theta/(m*R^2*I1)) */
    const double t7 = t2*t4; /* (G_level/(R*I1) - s*omega_n)*Theta/(m*R^2*I1) */
    const double t8 = t6*t7; /* 1/(gamma3*Theta/(m*R^2*I1))*(G_level/(R*I1) - s*omega_n)*Theta/(m*R^2*I1) */
    const double t9 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t10 = JLT_FMS(x[4], t8, t9); /* s*t8 - omega_n*gamma3 */
    const double t11 = x[3]*t10; /* omega_n*(s*t8 - omega_n*gamma3) */
    out[2] = t11;
    const double t12 = p[7]*t11; /* (-R)*omega_n*(s*t8 - omega_n*gamma3) */
    out[1] = t12;
    const double t13 = JLT_FMA(p[10], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t14 = x[0]*t6; /* 1/(Theta/(m*R^2*I1)) = gamma3*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t15 = JLT_FNMA(t13, t14, x[2]); /* omega_tau - V/R*1/(Theta/(m*R^2*I1)) */
    const double t16 = t9*t15; /* omega_n*gamma3*(omega_tau - V/R*1/(Theta/(m*R^2*I1))) */
    const double t17 = t0*p[11]; /* s*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t18 = t8*t17; /* t8*s*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t19 = JLT_FNMA(t14, t18, t16); /* omega_n*gamma3*(omega_tau - V/R*1/(Theta/(m*R^2*I1))) - 1/(Theta/(m*R^2*I1))*t8*s*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    out[3] = t19;
    const double t20 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t21 = -t20; /* -s*omega_tau*gamma3 */
    out[4] = t21;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[21] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[2] = t0;
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[4] = t2;
    const double t3 = t0 + p[9]; /* s*s + I1/(m*R^2) */
    const double t4 = JLT_FMA(x[0], x[0], t3); /* Theta/(m*R^2*I1) = gamma3*gamma3 + s*s + I1/(m*R^2) */
    const double t5 = x[0]*t4; /* gamma3*Theta/(m*R^2*I1) */
    const double t6 = 1.0/t5; /* 1/(gamma3*Theta/(m*R^2*I1)) */
    const double t7 = t4*t6; /* 1/gamma3 = Theta/(m*R^2*I1)*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t8 = x[4]*t7; /* s*1/gamma3 */
    const double t9 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t10 = t7*t9; /* 1/gamma3*(G_level/(R*I1) - s*omega_n) */
    const double t11 = JLT_FMA(t8, t10, x[3]); /* s*1/gamma3*1/gamma3*(G_level/(R*I1) - s*omega_n) + omega_n */
    const double t12 = x[3]*t11; /* omega_n*(s*1/gamma3*1/gamma3*(G_level/(R*I1) - s*omega_n) + omega_n) */
    const double t13 = p[1]*t12; /* R*t12 */
    out[5] = t13;
    const double t14 = JLT_FMS(x[3], t8, t10); /* omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - s*omega_n) */
    const double t15 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t16 = 2.0*t15; /* 2*omega_n*gamma3 */
    const double t17 = JLT_FMA(x[4], t14, t16); /* s*(omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - s*omega_n)) + 2*omega_n*gamma3 */
    const double t18 = p[1]*t17; /* R*t17 */
    out[8] = t18;
    const double t19 = x[3]*t14; /* omega_n*(omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - s*omega_n)) */
    const double t20 = p[1]*t19; /* R*t19 */
    out[9] = t20;
    const double t21 = -t12; /* -t12 */
    out[10] = t21;
    const double t22 = -t17; /* -t17 */
    out[13] = t22;
    const double t23 = -t19; /* -t19 */
    out[14] = t23;
    const double t24 = JLT_FMA(p[10], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t25 = x[0]*t6; /* 1/(Theta/(m*R^2*I1)) = gamma3*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t26 = t24*t25; /* V/R*1/(Theta/(m*R^2*I1)) */
    const double t27 = x[2] - t26; /* omega_tau - V/R*1/(Theta/(m*R^2*I1)) */
    const double t28 = x[3]*t27; /* omega_n*(omega_tau - V/R*1/(Theta/(m*R^2*I1))) */
    const double t29 = t16*t26; /* 2*omega_n*gamma3*V/R*1/(Theta/(m*R^2*I1)) */
    const double t30 = t1*t25; /* s*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t31 = t10*t30; /* 1/gamma3*(G_level/(R*I1) - s*omega_n)*s*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t32 = JLT_FMA(p[12], t31, t29); /* 2*(m*R^2*I1^3 + m^2*R^4*I1^2)/(m^2*R^4*I1^2)*t31 + 2*omega_n*gamma3*V/R*1/(Theta/(m*R^2*I1)) */
    const double t33 = t25*t32; /* 1/(Theta/(m*R^2*I1))*t32 */
    const double t34 = t7*p[13]; /* 1/gamma3*(m*R + I1/R)/(m*R) */
    const double t35 = JLT_FMA(t31, t34, t28); /* t31*1/gamma3*(m*R + I1/R)/(m*R) + omega_n*(omega_tau - V/R*1/(Theta/(m*R^2*I1))) */
    const double t36 = JLT_FMA(x[0], t33, t35); /* gamma3*1/(Theta/(m*R^2*I1))*t32 + t35 */
    out[15] = t36;
    const double t37 = t15*t25; /* omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t38 = p[14]*t37; /* (-1/R)*omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    out[16] = t38;
    const double t39 = t25*p[11]; /* 1/(Theta/(m*R^2*I1))*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t40 = t8*t39; /* s*1/gamma3*1/(Theta/(m*R^2*I1))*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t41 = t15 - t37; /* omega_n*gamma3 - omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t42 = JLT_FNMA(t9, t40, t41); /* omega_n*gamma3 - omega_n*gamma3*1/(Theta/(m*R^2*I1)) - (G_level/(R*I1) - s*omega_n)*s*1/gamma3*1/(Theta/(m*R^2*I1))*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    out[17] = t42;
    const double t43 = x[0]*t27; /* gamma3*(omega_tau - V/R*1/(Theta/(m*R^2*I1))) */
    const double t44 = JLT_FMA(t1, t40, t43); /* s*omega_tau*s*1/gamma3*1/(Theta/(m*R^2*I1))*(m*R^2*I1 + I1^2)/(m*R^2*I1) + gamma3*(omega_tau - V/R*1/(Theta/(m*R^2*I1))) */
    out[18] = t44;
    const double t45 = x[4]*t33; /* s*1/(Theta/(m*R^2*I1))*t32 */
    const double t46 = x[2]*t39; /* omega_tau*1/(Theta/(m*R^2*I1))*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t47 = JLT_FMA(t14, t46, t45); /* (omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - s*omega_n))*omega_tau*1/(Theta/(m*R^2*I1))*(m*R^2*I1 + I1^2)/(m*R^2*I1) + s*1/(Theta/(m*R^2*I1))*t32 */
    out[19] = t47;
    const double t48 = -t1; /* -s*omega_tau */
    out[20] = t48;
    const double t49 = x[4]*x[0]; /* s*gamma3 */
    const double t50 = -t49; /* -s*gamma3 */
    out[22] = t50;
    const double t51 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t52 = -t51; /* -omega_tau*gamma3 */
    out[24] = t52;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[7] = t0;
    const double t1 = p[9] + t0; /* I1/(m*R^2) + s*s */
    const double t2 = JLT_FMA(x[0], x[0], t1); /* Theta/(m*R^2*I1) = gamma3*gamma3 + I1/(m*R^2) + s*s */
    const double t3 = x[0]*t2; /* gamma3*Theta/(m*R^2*I1) */
    const double t4 = 1.0/t3; /* 1/(gamma3*Theta/(m*R^2*I1)) */
    const double t5 = t2*t4; /* 1/gamma3 = Theta/(m*R^2*I1)*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t6 = x[0]*t4; /* 1/(Theta/(m*R^2*I1)) = gamma3*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t7 = x[4]*x[3]; /* s*omega_n */
    const double t8 = p[8] - t7; /* G_level/(R*I1) - s*omega_n */
    const double t9 = t5*t8; /* 1/gamma3*(G_level/(R*I1) - s*omega_n) */
    const double t10 = JLT_FNMA(t5, t7, t9); /* 1/gamma3*(G_level/(R*I1) - s*omega_n) - 1/gamma3*s*omega_n */
    const double t11 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t12 = x[4]*x[2]; /* s*omega_tau */
    const double t13 = 2.0*t12; /* 2*s*omega_tau */
    out[9] = t13;
    const double t14 = -t12; /* -s*omega_tau */
    out[25] = t14;
    const double t15 = JLT_FMA(p[10], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t16 = 2.0*t11; /* 2*omega_n*gamma3 */
    const double t17 = t9*t12; /* 1/gamma3*(G_level/(R*I1) - s*omega_n)*s*omega_tau */
    const double t18 = x[4]*t9; /* s*1/gamma3*(G_level/(R*I1) - s*omega_n) */
    const double t19 = t15*t16; /* V/R*2*omega_n*gamma3 */
    const double t20 = JLT_FMA(p[12], t17, t19); /* 2*(m*R^2*I1^3 + m^2*R^4*I1^2)/(m^2*R^4*I1^2)*1/gamma3*(G_level/(R*I1) - s*omega_n)*s*omega_tau + V/R*2*omega_n*gamma3 */
    const double t21 = t6*t20; /* 1/(Theta/(m*R^2*I1))*t20 */
    const double t22 = JLT_FNMA(t6, t15, x[2]); /* omega_tau - 1/(Theta/(m*R^2*I1))*V/R */
    const double t23 = JLT_FMS(x[4], t10, t16); /* s*(1/gamma3*(G_level/(R*I1) - s*omega_n) - 1/gamma3*s*omega_n) - 2*omega_n*gamma3 */
    out[18] = t23;
    const double t24 = p[7]*t23; /* (-R)*t23 */
    out[13] = t24;
    const double t25 = p[11]*t6; /* (m*R^2*I1 + I1^2)/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t26 = x[4]*t12; /* s*s*omega_tau */
    out[0] = t26;
    const double t27 = x[0]*t12; /* gamma3*s*omega_tau */
    const double t28 = -t27; /* -gamma3*s*omega_tau */
    out[4] = t28;
    const double t29 = t5*t26; /* 1/gamma3*s*s*omega_tau */
    const double t30 = t18 - t11; /* s*1/gamma3*(G_level/(R*I1) - s*omega_n) - omega_n*gamma3 */
    const double t31 = x[3]*t30; /* omega_n*(s*1/gamma3*(G_level/(R*I1) - s*omega_n) - omega_n*gamma3) */
    out[2] = t31;
    const double t32 = p[7]*t31; /* (-R)*t31 */
    out[1] = t32;
    const double t33 = JLT_FMA(t5, t18, x[3]); /* 1/gamma3*s*1/gamma3*(G_level/(R*I1) - s*omega_n) + omega_n */
    const double t34 = p[13]*t5; /* (m*R + I1/R)/(m*R)*1/gamma3 */
    const double t35 = x[3]*t33; /* omega_n*(1/gamma3*s*1/gamma3*(G_level/(R*I1) - s*omega_n) + omega_n) */
    const double t36 = p[1]*t35; /* R*t35 */
    out[10] = t36;
    const double t37 = -t35; /* -t35 */
    out[15] = t37;
    const double t38 = x[0]*t21; /* gamma3*1/(Theta/(m*R^2*I1))*t20 */
    const double t39 = JLT_FMA(t17, t34, t38); /* 1/gamma3*(G_level/(R*I1) - s*omega_n)*s*omega_tau*(m*R + I1/R)/(m*R)*1/gamma3 + gamma3*1/(Theta/(m*R^2*I1))*t20 */
    const double t40 = t6*t11; /* 1/(Theta/(m*R^2*I1))*omega_n*gamma3 */
    const double t41 = p[14]*t40; /* (-1/R)*1/(Theta/(m*R^2*I1))*omega_n*gamma3 */
    out[21] = t41;
    const double t42 = t11 - t40; /* omega_n*gamma3 - 1/(Theta/(m*R^2*I1))*omega_n*gamma3 */
    const double t43 = JLT_FNMA(t18, t25, t42); /* omega_n*gamma3 - 1/(Theta/(m*R^2*I1))*omega_n*gamma3 - s*1/gamma3*(G_level/(R*I1) - s*omega_n)*(m*R^2*I1 + I1^2)/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    out[22] = t43;
    const double t44 = t11*t22; /* omega_n*gamma3*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) */
    const double t45 = JLT_FNMA(t17, t25, t44); /* omega_n*gamma3*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) - 1/gamma3*(G_level/(R*I1) - s*omega_n)*s*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    out[3] = t45;
    const double t46 = x[2]*t25; /* omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t47 = t10*t46; /* (1/gamma3*(G_level/(R*I1) - s*omega_n) - 1/gamma3*s*omega_n)*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t48 = x[3]*t10; /* omega_n*(1/gamma3*(G_level/(R*I1) - s*omega_n) - 1/gamma3*s*omega_n) */
    out[19] = t48;
    const double t49 = p[7]*t48; /* (-R)*t48 */
    out[14] = t49;
    const double t50 = x[3]*t22; /* omega_n*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) */
    const double t51 = JLT_FMA(t6, t39, t50); /* 1/(Theta/(m*R^2*I1))*t39 + omega_n*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) */
    out[20] = t51;
    const double t52 = x[0]*t22; /* gamma3*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) */
    const double t53 = JLT_FMA(t25, t29, t52); /* (m*R^2*I1 + I1^2)/(m*R^2*I1)*1/(Theta/(m*R^2*I1))*1/gamma3*s*s*omega_tau + gamma3*(omega_tau - 1/(Theta/(m*R^2*I1))*V/R) */
    out[23] = t53;
    const double t54 = x[4]*t6; /* s*1/(Theta/(m*R^2*I1)) */
    const double t55 = JLT_FMS(t21, t54, t47); /* 1/(Theta/(m*R^2*I1))*t20*s*1/(Theta/(m*R^2*I1)) - t47 */
    out[24] = t55;
    const double t56 = x[4]*x[0]; /* s*gamma3 */
    const double t57 = -t56; /* -s*gamma3 */
    out[27] = t57;
    const double t58 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t59 = -t58; /* -omega_tau*gamma3 */
    out[29] = t59;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9] + t0; /* I1/(m*R^2) + s*s */
    const double t2 = JLT_FMA(x[0], x[0], t1); /* Theta/(m*R^2*I1) = gamma3*gamma3 + I1/(m*R^2) + s*s */
    const double t3 = x[0]*t2; /* gamma3*Theta/(m*R^2*I1) */
    const double t4 = 1.0/t3; /* 1/(gamma3*Theta/(m*R^2*I1)) */
    const double t5 = x[2]*p[11]; /* omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t6 = t0*t5; /* s*s*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t7 = t2*t6; /* Theta/(m*R^2*I1)*s*s*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t8 = JLT_FMA(p[10], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t9 = x[0]*t8; /* gamma3*V/R */
    const double t10 = JLT_FNMA(t4, t7, t9); /* gamma3*V/R - 1/(gamma3*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*s*omega_tau*(m*R^2*I1 + I1^2)/(m*R^2*I1) */
    const double t11 = x[0]*t4; /* gamma3*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t12 = t10*t11; /* t10*gamma3*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t13 = -t12; /* -t10*gamma3*1/(gamma3*Theta/(m*R^2*I1)) */
    out[0] = t13;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t1 = t0/x[0]; /* (G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = JLT_FMA(x[2], x[2], t2); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t4 = p[16]*x[1]; /* m/I1*v_nu */
    const double t5 = JLT_FMA(x[1], t4, t3); /* v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t6 = JLT_FMA(t1, t1, t5); /* (G_level/(R*I1) - omega_n*s)/gamma3*(G_level/(R*I1) - omega_n*s)/gamma3 + v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t7 = x[4]*t1; /* s*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t8 = JLT_FMS(x[3], x[0], t7); /* v_tau/R = omega_n*gamma3 - s*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t9 = p[17]*t8; /* m*R^2/I1*v_tau/R */
    const double t10 = JLT_FMA(t8, t9, t6); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t6 */
    const double t11 = p[15]*t10; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t11;
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[2] = t12;
    const double t13 = p[18]*t12; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t14 = t12*t13; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t14;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[11] = 1.0;
    const double t0 = 1.0/x[0]; /* 1/gamma3 */
    const double t1 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t2 = t0*t1; /* 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t3 = t0*t2; /* 1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t4 = x[4]*t3; /* s*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t5 = x[3] + t4; /* d(v_tau)/d(gamma3)/R = omega_n + s*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t6 = x[4]*t2; /* s*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t7 = JLT_FMS(x[3], x[0], t6); /* v_tau/R = omega_n*gamma3 - s*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t8 = p[19]*t7; /* m*R^2*v_tau/R */
    const double t9 = t5*t8; /* d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R */
    const double t10 = t3*p[4]; /* 1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s)*I1 */
    const double t11 = JLT_FNMA(t2, t10, t9); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R - 1/gamma3*(G_level/(R*I1) - omega_n*s)*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s)*I1 */
    out[0] = t11;
    const double t12 = p[0]*x[1]; /* m*v_nu */
    out[1] = t12;
    const double t13 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t13;
    const double t14 = x[4]*t0; /* s*1/gamma3 */
    const double t15 = JLT_FMA(x[4], t14, x[0]); /* d(v_tau)/d(omega_n)/R = s*s*1/gamma3 + gamma3 */
    const double t16 = t7*p[17]; /* v_tau/R*m*R^2/I1 */
    const double t17 = x[3] - t4; /* omega_n - s*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t18 = JLT_FMA(t15, t16, t17); /* d(energy)/d(omega_n)/I1 = d(v_tau)/d(omega_n)/R*v_tau/R*m*R^2/I1 + omega_n - s*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t19 = p[4]*t18; /* I1*d(energy)/d(omega_n)/I1 */
    out[3] = t19;
    const double t20 = JLT_FMS(x[3], t14, t2); /* d(v_tau)/d(s)/R = omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t21 = t8*t20; /* m*R^2*v_tau/R*d(v_tau)/d(s)/R */
    const double t22 = JLT_FNMA(x[3], t10, t21); /* d(energy)/d(s) = m*R^2*v_tau/R*d(v_tau)/d(s)/R - omega_n*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s)*I1 */
    out[4] = t22;
    out[5] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[12] = p[1];
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t24 = p[20]*t23; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[6] = t24;
    const double t25 = t23*p[21]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[7] = t25;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t1 = t0/x[0]; /* (G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t2 = -t1; /* -(G_level/(R*I1) - omega_n*s)/gamma3 */
    out[0] = t2;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t9[k] = (k == 0 ? p[8] : 0) - jlt_jet_product(x4, x3, k);
        t10[k] = jlt_jet_quotient(t9[k], x0, t10, k);
        t11[k] = jlt_jet_product(x3, x0, k);
        t12[k] = jlt_jet_product(x4, t10, k) - t11[k];
        t13[k] = jlt_jet_product(x3, t12, k);
        t14[k] = p[7]*t13[k];
        t16[k] = jlt_jet_product(x4, x4, k) + (k == 0 ? p[9] : 0);
        t17[k] = jlt_jet_product(x0, x0, k) + t16[k];
        t18[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t17, t18, k);
        t21[k] = p[10]*x1[k] + x2[k];
        t22[k] = x2[k] - jlt_jet_product(t18, t21, k);
        t23[k] = jlt_jet_product(t11, t22, k);
        t25[k] = t2[k]*p[11];
        t26[k] = jlt_jet_product(t10, t25, k);
        t27[k] = t23[k] - jlt_jet_product(t18, t26, k);
        t28[k] = jlt_jet_product(t2, x0, k);
        t29[k] = -t28[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t14[k]/(k + 1);
        next[2] = x2[k + 1] = t13[k]/(k + 1);
        next[3] = x3[k + 1] = t27[k]/(k + 1);
        next[4] = x4[k + 1] = t29[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = (0.0);
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double v_I1 = params[4];
    const double v_I3 = (v_I1);
    const double v_G_level = params[6];
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
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
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    out[3] = x[3];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[4] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[4]*x[4]; /* s*s */
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
    const double t1 = 2.0*x[4]; /* 2*s */
    out[4] = t1;
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_omega3 = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "regular",
    .elimination = "level_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 7, .prepared_count = 22,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 1, 13, 7, 1, 0, 0, 8, 6 }, { 11, 48, 0, 4, 0, 0, 10, 7 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n, a part of d(v_nu)/dtau and of d(omega_tau)/dtau, V/R = (1/R)*v_nu + omega_tau, omega_tau - V/R*1/(Theta/(m*R^2*I1)), d(omega_n)/dtau" },
    .jacobian = { jacobian, 25, { 9, 31, 12, 1, 0, 0, 12, 13 }, { 41, 210, 0, 27, 0, 0, 14, 8 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n, s*1/gamma3*1/gamma3*(G_level/(R*I1) - s*omega_n) + omega_n, omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - s*omega_n), a part of d(d(v_nu)/dtau)/d(omega_n) and of d(d(omega_tau)/dtau)/d(omega_n), V/R = (1/R)*v_nu + omega_tau, omega_tau - V/R*1/(Theta/(m*R^2*I1)), a part of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 9, 37, 13, 1, 0, 0, 13, 12 }, { 48, 241, 0, 30, 0, 0, 14, 8 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n, 1/gamma3*(G_level/(R*I1) - s*omega_n) - 1/gamma3*s*omega_n, V/R = (1/R)*v_nu + omega_tau, a part of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s), omega_tau - 1/(Theta/(m*R^2*I1))*V/R, d(d(omega_tau)/dtau)/d(omega_n), s*1/gamma3*(G_level/(R*I1) - s*omega_n) - omega_n*gamma3, 1/gamma3*s*1/gamma3*(G_level/(R*I1) - s*omega_n) + omega_n, a part of d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), d(omega_n)/dtau, d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 2, 8, 3, 1, 0, 0, 8, 5 }, { 5, 28, 0, 3, 0, 0, 10, 5 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in V/R = (1/R)*v_nu + omega_tau, a part of the divergence" },
    .integral_values = { integral_values, 3, { 0, 7, 7, 1, 0, 0, 7, 4 }, { 8, 30, 0, 1, 0, 0, 14, 5 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, v_tau/R = omega_n*gamma3 - s*((G_level/(R*I1) - omega_n*s)/gamma3), F_linear" },
    .integral_gradients = { integral_gradients, 15, { 2, 15, 8, 1, 0, 0, 7, 8 }, { 13, 52, 0, 7, 0, 0, 11, 7 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, d(v_tau)/d(gamma3)/R = omega_n + s*((1)/gamma3)*((1)/gamma3)*(G_level/(R*I1) - omega_n*s), v_tau/R = omega_n*gamma3 - s*((1)/gamma3)*(G_level/(R*I1) - omega_n*s), d(E)/d(gamma3), d(energy)/d(omega_n)/I1, d(v_tau)/d(s)/R = omega_n*s*((1)/gamma3) - ((1)/gamma3)*(G_level/(R*I1) - omega_n*s), d(E)/d(s), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 1, 0, 1, 1, 0, 0, 3, 2 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .eliminated_state = 4, .level_integral = 1,
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular_on_level_omega3,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_equal_in_regular_on_level_omega3) },
#endif
};
