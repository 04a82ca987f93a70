/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I3 = I1
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_omega_n: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   10    5    1    0    0      8    5   (47)
 *  jacobian            8   25    7    1    0    0     12    7   (180)
 *  rhs_jacobian        12   30    7    1    0    0     11    7   (205)
 *  divergence          2    1    3    1    0    0      6    3   (23)
 *  integral_values     0    7    7    1    0    0      6    4   (39)
 *  integral_gradients  0   14   10    1    0    0      6    8   (72)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    0    1    1    0    0      2    2   (7)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1), V/R = (1/R)*v_nu + omega_tau,
 *      d(d(omega3)/dtau)/d(gamma3), omega3 + gamma3*1/s*1/s*(gamma3*omega3 + G_level/(R*I1)),
 *      (2)*gamma3*1/s*1/s*(gamma3*omega3 + G_level/(R*I1)) + omega3,
 *      a part of d(d(v_nu)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(gamma3),
 *      a part of d(d(v_nu)/dtau)/d(omega3) and of d(d(omega_tau)/dtau)/d(omega3)
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_omega_n;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega_n;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_omega_n_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_omega_n_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_omega_n_avx512;

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
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = params[6]/t0; /* G_level/(R*I1) */
    out[7] = t1;
    const double t2 = params[1]*params[1]; /* R*R */
    const double t3 = params[0]*t2; /* m*R*R */
    out[16] = t3;
    const double t4 = params[4]/t3; /* I1/(m*R*R) */
    out[8] = t4;
    const double t5 = 1.0/params[1]; /* 1/R */
    out[9] = t5;
    const double t6 = params[1]*(-2.0); /* R*(-2) */
    out[10] = t6;
    const double t7 = (-1.0)/params[1]; /* (-1)/R */
    out[11] = t7;
    const double t8 = params[4]/2.0; /* I1/2 */
    out[12] = t8;
    const double t9 = params[0]/params[4]; /* m/I1 */
    out[13] = t9;
    const double t10 = t3/params[4]; /* m*R*R/I1 */
    out[14] = t10;
    const double t11 = params[4]*params[4]; /* I1*I1 */
    const double t12 = params[0]*t11; /* m*I1*I1 */
    out[15] = t12;
    const double t13 = params[0]*2.0; /* m*2 */
    const double t14 = t11*t13; /* I1*I1*m*2 */
    out[17] = t14;
    const double t15 = params[1]*t13; /* R*m*2 */
    const double t16 = t11*t15; /* I1*I1*R*m*2 */
    out[18] = t16;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[4], x[4], p[8]); /* s*s + I1/(m*R^2) */
    const double t1 = JLT_FMA(x[0], x[0], t0); /* Theta/(m*R^2*I1) = gamma3*gamma3 + s*s + I1/(m*R^2) */
    const double t2 = JLT_FMA(x[0], x[3], p[7]); /* gamma3*omega3 + G_level/(R*I1) */
    const double t3 = x[4]*t1; /* s*Theta/(m*R^2*I1) */
    const double t4 = t2/t3; /* (gamma3*omega3 + G_level/(R*I1))/(s*Theta/(m*R^2*I1)) */
    const double t5 = t1*t4; /* Theta/(m*R^2*I1)*(gamma3*omega3 + G_level/(R*I1))/(s*Theta/(m*R^2*I1)) */
    const double t6 = x[3]*t2; /* omega3*(gamma3*omega3 + G_level/(R*I1)) */
    const double t7 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t8 = x[4]*t7; /* s*V/R */
    const double t9 = t4*t8; /* (gamma3*omega3 + G_level/(R*I1))/(s*Theta/(m*R^2*I1))*s*V/R */
    const double t10 = -t9; /* -(gamma3*omega3 + G_level/(R*I1))/(s*Theta/(m*R^2*I1))*s*V/R */
    out[3] = t10;
    const double t11 = x[4]*x[2]; /* s*omega_tau */
    const double t12 = x[4]*t11; /* s*s*omega_tau */
    out[0] = t12;
    const double t13 = x[0]*t11; /* gamma3*s*omega_tau */
    const double t14 = -t13; /* -gamma3*s*omega_tau */
    out[4] = t14;
    const double t15 = x[0]*t5; /* gamma3*t5 */
    const double t16 = JLT_FMA(t5, t15, t6); /* t5*gamma3*t5 + omega3*(gamma3*omega3 + G_level/(R*I1)) */
    const double t17 = p[1]*t16; /* R*(t5*gamma3*t5 + omega3*(gamma3*omega3 + G_level/(R*I1))) */
    out[1] = t17;
    const double t18 = -t16; /* -(t5*gamma3*t5 + omega3*(gamma3*omega3 + G_level/(R*I1))) */
    out[2] = t18;
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
    const double t1 = p[8] + t0; /* I1/(m*R^2) + s*s */
    const double t2 = JLT_FMA(x[0], x[0], t1); /* Theta/(m*R^2*I1) = gamma3*gamma3 + I1/(m*R^2) + s*s */
    const double t3 = x[4]*t2; /* s*Theta/(m*R^2*I1) */
    const double t4 = 1.0/t3; /* 1/(s*Theta/(m*R^2*I1)) */
    const double t5 = t2*t4; /* 1/s = Theta/(m*R^2*I1)*1/(s*Theta/(m*R^2*I1)) */
    const double t6 = x[4]*t4; /* 1/(Theta/(m*R^2*I1)) = s*1/(s*Theta/(m*R^2*I1)) */
    const double t7 = JLT_FMA(x[3], x[0], p[7]); /* omega3*gamma3 + G_level/(R*I1) */
    const double t8 = t5*t7; /* 1/s*(omega3*gamma3 + G_level/(R*I1)) */
    const double t9 = x[0]*t5; /* gamma3*1/s */
    const double t10 = t8*t9; /* 1/s*(omega3*gamma3 + G_level/(R*I1))*gamma3*1/s */
    const double t11 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t12 = t6*t11; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t13 = t6*t7; /* 1/(Theta/(m*R^2*I1))*(omega3*gamma3 + G_level/(R*I1)) */
    const double t14 = p[11]*t13; /* (-1/R)*1/(Theta/(m*R^2*I1))*(omega3*gamma3 + G_level/(R*I1)) */
    out[16] = t14;
    const double t15 = -t13; /* -1/(Theta/(m*R^2*I1))*(omega3*gamma3 + G_level/(R*I1)) */
    out[17] = t15;
    const double t16 = JLT_FMA(2.0, t10, x[3]); /* 2*1/s*(omega3*gamma3 + G_level/(R*I1))*gamma3*1/s + omega3 */
    const double t17 = JLT_FMA(x[0], t16, t7); /* gamma3*(2*1/s*(omega3*gamma3 + G_level/(R*I1))*gamma3*1/s + omega3) + omega3*gamma3 + G_level/(R*I1) */
    const double t18 = x[3]*t16; /* omega3*(2*1/s*(omega3*gamma3 + G_level/(R*I1))*gamma3*1/s + omega3) */
    const double t19 = JLT_FMA(t8, t8, t18); /* 1/s*(omega3*gamma3 + G_level/(R*I1))*1/s*(omega3*gamma3 + G_level/(R*I1)) + t18 */
    const double t20 = t8*t10; /* 1/s*(omega3*gamma3 + G_level/(R*I1))*1/s*(omega3*gamma3 + G_level/(R*I1))*gamma3*1/s */
    const double t21 = p[1]*t19; /* R*t19 */
    out[5] = t21;
    const double t22 = -t19; /* -t19 */
    out[10] = t22;
    const double t23 = p[1]*t17; /* R*t17 */
    out[8] = t23;
    const double t24 = -t17; /* -t17 */
    out[13] = t24;
    const double t25 = p[10]*t20; /* (-2*R)*t20 */
    out[9] = t25;
    const double t26 = 2.0*t20; /* 2*t20 */
    out[14] = t26;
    const double t27 = 2.0*t12; /* 2*1/(Theta/(m*R^2*I1))*V/R */
    const double t28 = t13*t27; /* 1/(Theta/(m*R^2*I1))*(omega3*gamma3 + G_level/(R*I1))*2*1/(Theta/(m*R^2*I1))*V/R */
    const double t29 = x[4]*t28; /* s*t28 */
    out[19] = t29;
    const double t30 = x[0]*t28; /* gamma3*t28 */
    const double t31 = JLT_FNMA(x[3], t12, t30); /* gamma3*t28 - omega3*1/(Theta/(m*R^2*I1))*V/R */
    out[15] = t31;
    const double t32 = x[0]*t12; /* gamma3*1/(Theta/(m*R^2*I1))*V/R */
    const double t33 = -t32; /* -gamma3*1/(Theta/(m*R^2*I1))*V/R */
    out[18] = t33;
    const double t34 = x[4]*x[2]; /* s*omega_tau */
    const double t35 = 2.0*t34; /* 2*s*omega_tau */
    out[4] = t35;
    const double t36 = -t34; /* -s*omega_tau */
    out[20] = t36;
    const double t37 = x[4]*x[0]; /* s*gamma3 */
    const double t38 = -t37; /* -s*gamma3 */
    out[22] = t38;
    const double t39 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t40 = -t39; /* -omega_tau*gamma3 */
    out[24] = t40;
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
    const double t1 = p[8] + t0; /* I1/(m*R^2) + s*s */
    const double t2 = JLT_FMA(x[0], x[0], t1); /* Theta/(m*R^2*I1) = gamma3*gamma3 + I1/(m*R^2) + s*s */
    const double t3 = x[4]*t2; /* s*Theta/(m*R^2*I1) */
    const double t4 = 1.0/t3; /* 1/(s*Theta/(m*R^2*I1)) */
    const double t5 = t2*t4; /* 1/s = Theta/(m*R^2*I1)*1/(s*Theta/(m*R^2*I1)) */
    const double t6 = x[4]*t4; /* 1/(Theta/(m*R^2*I1)) = s*1/(s*Theta/(m*R^2*I1)) */
    const double t7 = JLT_FMA(x[0], x[3], p[7]); /* gamma3*omega3 + G_level/(R*I1) */
    const double t8 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t9 = x[0]*t5; /* gamma3*1/s */
    const double t10 = t5*t7; /* 1/s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t11 = t6*t8; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t12 = t6*t7; /* 1/(Theta/(m*R^2*I1))*(gamma3*omega3 + G_level/(R*I1)) */
    const double t13 = t8*t12; /* V/R*1/(Theta/(m*R^2*I1))*(gamma3*omega3 + G_level/(R*I1)) */
    const double t14 = -t13; /* -V/R*1/(Theta/(m*R^2*I1))*(gamma3*omega3 + G_level/(R*I1)) */
    out[3] = t14;
    const double t15 = p[11]*t12; /* (-1/R)*1/(Theta/(m*R^2*I1))*(gamma3*omega3 + G_level/(R*I1)) */
    out[21] = t15;
    const double t16 = -t12; /* -1/(Theta/(m*R^2*I1))*(gamma3*omega3 + G_level/(R*I1)) */
    out[22] = t16;
    const double t17 = t9*t10; /* gamma3*1/s*1/s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t18 = t10*t10; /* 1/s*(gamma3*omega3 + G_level/(R*I1))*1/s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t19 = t9*t18; /* gamma3*1/s*t18 */
    const double t20 = p[10]*t19; /* (-2*R)*gamma3*1/s*t18 */
    out[14] = t20;
    const double t21 = 2.0*t19; /* 2*gamma3*1/s*t18 */
    out[19] = t21;
    const double t22 = 2.0*t11; /* 2*1/(Theta/(m*R^2*I1))*V/R */
    const double t23 = t12*t22; /* 1/(Theta/(m*R^2*I1))*(gamma3*omega3 + G_level/(R*I1))*2*1/(Theta/(m*R^2*I1))*V/R */
    const double t24 = x[4]*t23; /* s*t23 */
    out[24] = t24;
    const double t25 = x[0]*t23; /* gamma3*t23 */
    const double t26 = JLT_FNMA(x[3], t11, t25); /* gamma3*t23 - omega3*1/(Theta/(m*R^2*I1))*V/R */
    out[20] = t26;
    const double t27 = x[0]*t11; /* gamma3*1/(Theta/(m*R^2*I1))*V/R */
    const double t28 = -t27; /* -gamma3*1/(Theta/(m*R^2*I1))*V/R */
    out[23] = t28;
    const double t29 = x[4]*x[2]; /* s*omega_tau */
    const double t30 = x[4]*t29; /* s*s*omega_tau */
    out[0] = t30;
    const double t31 = 2.0*t29; /* 2*s*omega_tau */
    out[9] = t31;
    const double t32 = -t29; /* -s*omega_tau */
    out[25] = t32;
    const double t33 = x[0]*t29; /* gamma3*s*omega_tau */
    const double t34 = -t33; /* -gamma3*s*omega_tau */
    out[4] = t34;
    const double t35 = x[3] + t17; /* omega3 + gamma3*1/s*1/s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t36 = JLT_FMA(2.0, t17, x[3]); /* 2*gamma3*1/s*1/s*(gamma3*omega3 + G_level/(R*I1)) + omega3 */
    const double t37 = t7*t35; /* (gamma3*omega3 + G_level/(R*I1))*(omega3 + gamma3*1/s*1/s*(gamma3*omega3 + G_level/(R*I1))) */
    const double t38 = JLT_FMA(x[3], t36, t18); /* omega3*(2*gamma3*1/s*1/s*(gamma3*omega3 + G_level/(R*I1)) + omega3) + t18 */
    const double t39 = JLT_FMA(x[0], t36, t7); /* gamma3*(2*gamma3*1/s*1/s*(gamma3*omega3 + G_level/(R*I1)) + omega3) + gamma3*omega3 + G_level/(R*I1) */
    const double t40 = p[1]*t37; /* R*t37 */
    out[1] = t40;
    const double t41 = -t37; /* -t37 */
    out[2] = t41;
    const double t42 = p[1]*t38; /* R*t38 */
    out[10] = t42;
    const double t43 = -t38; /* -t38 */
    out[15] = t43;
    const double t44 = p[1]*t39; /* R*t39 */
    out[13] = t44;
    const double t45 = -t39; /* -t39 */
    out[18] = t45;
    const double t46 = x[4]*x[0]; /* s*gamma3 */
    const double t47 = -t46; /* -s*gamma3 */
    out[27] = t47;
    const double t48 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t49 = -t48; /* -omega_tau*gamma3 */
    out[29] = t49;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[4], x[4], p[8]); /* s*s + I1/(m*R^2) */
    const double t1 = JLT_FMA(x[0], x[0], t0); /* Theta/(m*R^2*I1) = gamma3*gamma3 + s*s + I1/(m*R^2) */
    const double t2 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t3 = t2/t1; /* V/R/(Theta/(m*R^2*I1)) */
    const double t4 = x[2] + t3; /* omega_tau + V/R/(Theta/(m*R^2*I1)) */
    const double t5 = x[0]*t4; /* gamma3*(omega_tau + V/R/(Theta/(m*R^2*I1))) */
    const double t6 = -t5; /* -gamma3*(omega_tau + V/R/(Theta/(m*R^2*I1))) */
    out[0] = t6;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[0], x[3], p[7]); /* gamma3*omega3 + G_level/(R*I1) */
    const double t1 = t0/x[4]; /* omega_n = (gamma3*omega3 + G_level/(R*I1))/s */
    const double t2 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t3 = JLT_FMA(x[3], x[3], t2); /* omega3*omega3 + omega_tau*omega_tau */
    const double t4 = p[13]*x[1]; /* m/I1*v_nu */
    const double t5 = JLT_FMA(x[1], t4, t3); /* v_nu*m/I1*v_nu + omega3*omega3 + omega_tau*omega_tau */
    const double t6 = JLT_FMA(t1, t1, t5); /* omega_n*omega_n + v_nu*m/I1*v_nu + omega3*omega3 + omega_tau*omega_tau */
    const double t7 = x[4]*x[3]; /* s*omega3 */
    const double t8 = JLT_FMA(x[0], t1, t7); /* v_tau/R = gamma3*omega_n + s*omega3 */
    const double t9 = p[14]*t8; /* m*R^2/I1*v_tau/R */
    const double t10 = JLT_FMA(t8, t9, t6); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t6 */
    const double t11 = p[12]*t10; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t11;
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[2] = t12;
    const double t13 = p[15]*t12; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t14 = t12*t13; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t14;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[11] = 1.0;
    out[5] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[12] = p[1];
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t1;
    const double t2 = 1.0/x[4]; /* 1/s */
    const double t3 = JLT_FMA(x[3], x[0], p[7]); /* omega3*gamma3 + G_level/(R*I1) */
    const double t4 = t2*t3; /* 1/s*(omega3*gamma3 + G_level/(R*I1)) */
    const double t5 = x[3]*x[4]; /* omega3*s */
    const double t6 = JLT_FMA(x[0], t4, t5); /* v_tau/R = gamma3*1/s*(omega3*gamma3 + G_level/(R*I1)) + omega3*s */
    const double t7 = t2*t4; /* 1/s*1/s*(omega3*gamma3 + G_level/(R*I1)) */
    const double t8 = x[0]*t2; /* gamma3*1/s */
    const double t9 = p[4]*t7; /* I1*1/s*1/s*(omega3*gamma3 + G_level/(R*I1)) */
    const double t10 = JLT_FMA(x[0], t7, x[3]); /* gamma3*1/s*1/s*(omega3*gamma3 + G_level/(R*I1)) + omega3 */
    const double t11 = p[16]*t6; /* m*R^2*v_tau/R */
    const double t12 = p[14]*t6; /* m*R^2/I1*v_tau/R */
    const double t13 = JLT_FMA(x[0], t8, x[4]); /* d(v_tau)/d(omega3)/R = gamma3*gamma3*1/s + s */
    const double t14 = JLT_FMA(t12, t13, t10); /* d(energy)/d(omega3)/I1 = m*R^2/I1*v_tau/R*d(v_tau)/d(omega3)/R + gamma3*1/s*1/s*(omega3*gamma3 + G_level/(R*I1)) + omega3 */
    const double t15 = p[4]*t14; /* I1*d(energy)/d(omega3)/I1 */
    out[3] = t15;
    const double t16 = JLT_FNMA(t4, t8, x[3]); /* d(v_tau)/d(s)/R = omega3 - 1/s*(omega3*gamma3 + G_level/(R*I1))*gamma3*1/s */
    const double t17 = JLT_FMA(x[3], t8, t4); /* d(v_tau)/d(gamma3)/R = omega3*gamma3*1/s + 1/s*(omega3*gamma3 + G_level/(R*I1)) */
    const double t18 = t11*t16; /* m*R^2*v_tau/R*d(v_tau)/d(s)/R */
    const double t19 = JLT_FNMA(t4, t9, t18); /* d(energy)/d(s) = m*R^2*v_tau/R*d(v_tau)/d(s)/R - 1/s*(omega3*gamma3 + G_level/(R*I1))*I1*1/s*1/s*(omega3*gamma3 + G_level/(R*I1)) */
    out[4] = t19;
    const double t20 = x[3]*t9; /* omega3*I1*1/s*1/s*(omega3*gamma3 + G_level/(R*I1)) */
    const double t21 = JLT_FMA(t11, t17, t20); /* d(energy)/d(gamma3) = m*R^2*v_tau/R*d(v_tau)/d(gamma3)/R + omega3*I1*1/s*1/s*(omega3*gamma3 + G_level/(R*I1)) */
    out[0] = t21;
    const double t22 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t23 = p[17]*t22; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[6] = t23;
    const double t24 = p[18]*t22; /* 2*m*R*I1^2*(omega_tau*R + v_nu) */
    out[7] = t24;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[0], x[3], p[7]); /* gamma3*omega3 + G_level/(R*I1) */
    const double t1 = t0/x[4]; /* (gamma3*omega3 + G_level/(R*I1))/s */
    out[0] = t1;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t9[k] = jlt_jet_product(x0, x3, k) + (k == 0 ? p[7] : 0);
        t10[k] = jlt_jet_product(x4, x4, k) + (k == 0 ? p[8] : 0);
        t11[k] = jlt_jet_product(x0, x0, k) + t10[k];
        t12[k] = p[9]*x1[k] + x2[k];
        t13[k] = jlt_jet_product(t9, t12, k);
        t14[k] = jlt_jet_quotient(t13[k], t11, t14, k);
        t15[k] = -t14[k];
        t16[k] = jlt_jet_quotient(t9[k], x4, t16, k);
        t17[k] = jlt_jet_product(x3, t9, k);
        t18[k] = jlt_jet_product(x4, x2, k);
        t19[k] = jlt_jet_product(x4, t18, k);
        t20[k] = jlt_jet_product(x0, t18, k);
        t21[k] = -t20[k];
        t22[k] = jlt_jet_product(x0, t16, k);
        t23[k] = jlt_jet_product(t16, t22, k) + t17[k];
        t24[k] = p[1]*t23[k];
        t25[k] = -t23[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t19[k]/(k + 1);
        next[1] = x1[k + 1] = t24[k]/(k + 1);
        next[2] = x2[k + 1] = t25[k]/(k + 1);
        next[3] = x3[k + 1] = t15[k]/(k + 1);
        next[4] = x4[k + 1] = t21[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = (v_I1);
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
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
    out[3] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
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
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_omega_n = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "regular",
    .elimination = "level_omega_n",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 7, .prepared_count = 19,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 10, 5, 1, 0, 0, 8, 5 }, { 9, 36, 0, 2, 0, 0, 10, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1), V/R = (1/R)*v_nu + omega_tau, a part of d(v_nu)/dtau and of d(omega_tau)/dtau" },
    .jacobian = { jacobian, 25, { 8, 25, 7, 1, 0, 0, 12, 7 }, { 32, 131, 0, 17, 0, 0, 12, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3 + G_level/(R*I1), V/R = (1/R)*v_nu + omega_tau, (2)*1/s*(omega3*gamma3 + G_level/(R*I1))*gamma3*1/s + omega3, a part of d(d(v_nu)/dtau)/d(omega3) and of d(d(omega_tau)/dtau)/d(omega3), a part of d(d(v_nu)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 12, 30, 7, 1, 0, 0, 11, 7 }, { 37, 150, 0, 18, 0, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1), V/R = (1/R)*v_nu + omega_tau, d(d(omega3)/dtau)/d(gamma3), omega3 + gamma3*1/s*1/s*(gamma3*omega3 + G_level/(R*I1)), (2)*gamma3*1/s*1/s*(gamma3*omega3 + G_level/(R*I1)) + omega3, a part of d(d(v_nu)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(v_nu)/dtau)/d(omega3) and of d(d(omega_tau)/dtau)/d(omega3)" },
    .divergence = { divergence, 1, { 2, 1, 3, 1, 0, 0, 6, 3 }, { 5, 17, 0, 1, 0, 0, 8, 6 },
        "digits are lost where terms nearly cancel in V/R = (1/R)*v_nu + omega_tau, omega_tau + V/R/Theta/(m*R^2*I1)" },
    .integral_values = { integral_values, 3, { 0, 7, 7, 1, 0, 0, 6, 4 }, { 8, 30, 0, 1, 0, 0, 13, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1), v_tau/R = gamma3*omega_n + s*omega3, F_linear" },
    .integral_gradients = { integral_gradients, 15, { 0, 14, 10, 1, 0, 0, 6, 8 }, { 13, 52, 0, 7, 0, 0, 11, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3 + G_level/(R*I1), v_tau/R = gamma3*((1)/s)*(omega3*gamma3 + G_level/(R*I1)) + omega3*s, d(energy)/d(omega3)/I1, d(v_tau)/d(s)/R = omega3 - ((1)/s)*(omega3*gamma3 + G_level/(R*I1))*gamma3*((1)/s), d(v_tau)/d(gamma3)/R = omega3*gamma3*((1)/s) + ((1)/s)*(omega3*gamma3 + G_level/(R*I1)), d(E)/d(s), d(E)/d(gamma3), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 0, 1, 1, 0, 0, 2, 2 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1)" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .eliminated_state = 3, .level_integral = 1,
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular_on_level_omega_n,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_equal_in_regular_on_level_omega_n) },
#endif
};
