/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I3 = I1
 *  Eliminated: level_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   18    3    1    1    0     10    5   (62)
 *  jacobian            6   26    8    1    1    0     13    9   (171)
 *  rhs_jacobian        7   31    9    1    1    0     11   11   (208)
 *  divergence          2   11    2    1    1    0      8    6   (38)
 *  integral_values     2    8    7    1    1    0     10    5   (42)
 *  integral_gradients  3   17    8    1    1    0     11    7   (66)
 *  eliminated          3    1    1    1    1    0      6    3   (10)
 *
 *  Accuracy
 *    divides by gamma3: values and rounding errors grow without bound where it vanishes
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, V = omega_tau*R + v_nu,
 *      omega_tau - 1/Theta*(m*R*I1)*V,
 *      d(omega3)/d(gamma3) = 1/gamma3*(G_level/(R*I1) - omega_n*s)*1/gamma3 - 1/s^2*omega_n*s,
 *      (G_level/(R*I1) - omega_n*s)*1/gamma3 - gamma3*1/s^2*omega_n*s, d(omega3)/d(gamma3) + 1/s^2*1/s^2*omega_n*s,
 *      d(d(omega_tau)/dt)/d(omega_n), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), d(omega_n)/dt,
 *      d(d(omega_n)/dt)/d(omega_tau)
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_omega3;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_on_level_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_omega3_avx512;

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
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    out[18] = t2;
    const double t3 = t2*params[4]; /* m*R*R*I1 */
    const double t4 = params[4]*params[4]; /* I1*I1 */
    out[12] = t4;
    const double t5 = t3 + t4; /* m*R*R*I1 + I1*I1 */
    out[8] = t5;
    const double t6 = params[1]*params[4]; /* R*I1 */
    const double t7 = params[6]/t6; /* G_level/(R*I1) */
    out[9] = t7;
    const double t8 = params[1]*params[0]; /* R*m */
    const double t9 = params[4]*t8; /* I1*R*m */
    out[10] = t9;
    const double t10 = -t9; /* -I1*R*m */
    out[11] = t10;
    const double t11 = t5*t5; /* (m*R*R*I1 + I1*I1)*(m*R*R*I1 + I1*I1) */
    const double t12 = t11/t9; /* (m*R*R*I1 + I1*I1)*(m*R*R*I1 + I1*I1)/(I1*R*m) */
    out[13] = t12;
    const double t13 = params[4]/2.0; /* I1/2 */
    out[14] = t13;
    const double t14 = params[0]/params[4]; /* m/I1 */
    out[15] = t14;
    const double t15 = t2/params[4]; /* m*R*R/I1 */
    out[16] = t15;
    const double t16 = params[0]*t4; /* m*I1*I1 */
    out[17] = t16;
    const double t17 = params[0]*2.0; /* m*2 */
    const double t18 = t4*t17; /* I1*I1*m*2 */
    out[19] = t18;
    const double t19 = params[1]*t17; /* R*m*2 */
    const double t20 = t4*t19; /* I1*I1*R*m*2 */
    out[20] = t20;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[8]; /* gamma3*(m*R^2*I1 + I1^2) */
    const double t4 = t2*t3; /* s^2*gamma3*(m*R^2*I1 + I1^2) */
    const double t5 = 1.0/t4; /* 1/(s^2*gamma3*(m*R^2*I1 + I1^2)) */
    const double t6 = x[0]*t3; /* gamma3*gamma3*(m*R^2*I1 + I1^2) */
    const double t7 = t5*t6; /* 1/(s^2*gamma3*(m*R^2*I1 + I1^2))*gamma3*gamma3*(m*R^2*I1 + I1^2) */
    const double t8 = t2*t5; /* 1/(gamma3*Theta) = s^2*1/(s^2*gamma3*(m*R^2*I1 + I1^2)) */
    const double t9 = sqrt(t2); /* s = sqrt(s^2) */
    const double t10 = x[2]*t9; /* omega_tau*s */
    out[0] = t10;
    const double t11 = x[3]*t9; /* omega_n*s */
    const double t12 = t7*t11; /* t7*omega_n*s */
    const double t13 = p[9] - t11; /* G_level/(R*I1) - omega_n*s */
    const double t14 = p[8]*t8; /* (m*R^2*I1 + I1^2)*1/(gamma3*Theta) */
    const double t15 = t13*t14; /* (G_level/(R*I1) - omega_n*s)*(m*R^2*I1 + I1^2)*1/(gamma3*Theta) */
    const double t16 = x[0]*t8; /* 1/Theta = gamma3*1/(gamma3*Theta) */
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t18 = p[10]*t17; /* m*R*I1*V */
    const double t19 = JLT_FNMA(t16, t18, x[2]); /* omega_tau - 1/Theta*m*R*I1*V */
    const double t20 = t12*t19; /* t7*omega_n*s*(omega_tau - 1/Theta*m*R*I1*V) */
    const double t21 = t15 - t12; /* t15 - t7*omega_n*s */
    const double t22 = x[3]*t21; /* omega_n*(t15 - t7*omega_n*s) */
    out[2] = t22;
    const double t23 = p[7]*t22; /* (-R)*omega_n*(t15 - t7*omega_n*s) */
    out[1] = t23;
    const double t24 = x[2]*p[8]; /* omega_tau*(m*R^2*I1 + I1^2) */
    const double t25 = t16*t24; /* 1/Theta*omega_tau*(m*R^2*I1 + I1^2) */
    const double t26 = JLT_FNMA(t15, t25, t20); /* t7*omega_n*s*(omega_tau - 1/Theta*m*R*I1*V) - t15*1/Theta*omega_tau*(m*R^2*I1 + I1^2) */
    out[3] = t26;
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
    const double t3 = x[0]*p[8]; /* gamma3*(m*R^2*I1 + I1^2) */
    const double t4 = t2*t3; /* s^2*gamma3*(m*R^2*I1 + I1^2) */
    const double t5 = 1.0/t4; /* 1/(s^2*gamma3*(m*R^2*I1 + I1^2)) */
    const double t6 = t3*t5; /* 1/s^2 = gamma3*(m*R^2*I1 + I1^2)*1/(s^2*gamma3*(m*R^2*I1 + I1^2)) */
    const double t7 = t2*t5; /* 1/(gamma3*Theta) = s^2*1/(s^2*gamma3*(m*R^2*I1 + I1^2)) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t8;
    const double t9 = p[8]*t7; /* 1/gamma3 = (m*R^2*I1 + I1^2)*1/(gamma3*Theta) */
    const double t10 = x[0]*t7; /* 1/Theta = gamma3*1/(gamma3*Theta) */
    const double t11 = t8*t9; /* s*1/gamma3 */
    const double t12 = t6*t8; /* 1/s^2*s */
    const double t13 = x[3]*t11; /* omega_n*s*1/gamma3 */
    const double t14 = JLT_FMS(p[9], t9, t13); /* G_level/(R*I1)*1/gamma3 - omega_n*s*1/gamma3 */
    const double t15 = t14 - t13; /* G_level/(R*I1)*1/gamma3 - omega_n*s*1/gamma3 - omega_n*s*1/gamma3 */
    const double t16 = x[3]*t12; /* omega_n*1/s^2*s */
    const double t17 = JLT_FMS(t9, t14, t16); /* d(omega3)/d(gamma3) = 1/gamma3*(G_level/(R*I1)*1/gamma3 - omega_n*s*1/gamma3) - omega_n*1/s^2*s */
    const double t18 = t6*t16; /* 1/s^2*omega_n*1/s^2*s */
    const double t19 = x[0]*t12; /* gamma3*1/s^2*s */
    const double t20 = x[0]*t16; /* gamma3*omega_n*1/s^2*s */
    const double t21 = JLT_FNMA(2.0, t20, t15); /* t15 - 2*gamma3*omega_n*1/s^2*s */
    out[11] = t21;
    const double t22 = p[7]*t21; /* (-R)*(t15 - 2*gamma3*omega_n*1/s^2*s) */
    out[7] = t22;
    const double t23 = t10*t20; /* 1/Theta*gamma3*omega_n*1/s^2*s */
    const double t24 = p[11]*t23; /* (-m*R*I1)*1/Theta*gamma3*omega_n*1/s^2*s */
    out[13] = t24;
    const double t25 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t26 = p[10]*t25; /* m*R*I1*V */
    const double t27 = JLT_FNMA(t10, t26, x[2]); /* omega_tau - 1/Theta*m*R*I1*V */
    const double t28 = p[8]*t10; /* (m*R^2*I1 + I1^2)*1/Theta */
    const double t29 = t14*t28; /* (G_level/(R*I1)*1/gamma3 - omega_n*s*1/gamma3)*(m*R^2*I1 + I1^2)*1/Theta */
    const double t30 = JLT_FMS(p[12], t23, t29); /* I1^2*1/Theta*gamma3*omega_n*1/s^2*s - t29 */
    out[14] = t30;
    const double t31 = x[2]*t28; /* omega_tau*(m*R^2*I1 + I1^2)*1/Theta */
    const double t32 = t17 + t18; /* d(omega3)/d(gamma3) + 1/s^2*omega_n*1/s^2*s */
    const double t33 = x[3]*t32; /* omega_n*(d(omega3)/d(gamma3) + 1/s^2*omega_n*1/s^2*s) */
    const double t34 = t18*t27; /* 1/s^2*omega_n*1/s^2*s*(omega_tau - 1/Theta*m*R*I1*V) */
    const double t35 = JLT_FMA(t17, t31, t34); /* d(omega3)/d(gamma3)*omega_tau*(m*R^2*I1 + I1^2)*1/Theta + 1/s^2*omega_n*1/s^2*s*(omega_tau - 1/Theta*m*R*I1*V) */
    out[12] = t35;
    const double t36 = t19*t27; /* gamma3*1/s^2*s*(omega_tau - 1/Theta*m*R*I1*V) */
    const double t37 = JLT_FMA(t11, t31, t36); /* s*1/gamma3*omega_tau*(m*R^2*I1 + I1^2)*1/Theta + gamma3*1/s^2*s*(omega_tau - 1/Theta*m*R*I1*V) */
    out[15] = t37;
    const double t38 = x[2]*t19; /* omega_tau*gamma3*1/s^2*s */
    const double t39 = -t38; /* -omega_tau*gamma3*1/s^2*s */
    out[0] = t39;
    const double t40 = p[1]*t33; /* R*omega_n*(d(omega3)/d(gamma3) + 1/s^2*omega_n*1/s^2*s) */
    out[4] = t40;
    const double t41 = -t33; /* -omega_n*(d(omega3)/d(gamma3) + 1/s^2*omega_n*1/s^2*s) */
    out[8] = t41;
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
    const double t3 = x[0]*p[8]; /* gamma3*(m*R^2*I1 + I1^2) */
    const double t4 = t2*t3; /* s^2*gamma3*(m*R^2*I1 + I1^2) */
    const double t5 = 1.0/t4; /* 1/(s^2*gamma3*(m*R^2*I1 + I1^2)) */
    const double t6 = t3*t5; /* 1/s^2 = gamma3*(m*R^2*I1 + I1^2)*1/(s^2*gamma3*(m*R^2*I1 + I1^2)) */
    const double t7 = t2*t5; /* 1/(gamma3*Theta) = s^2*1/(s^2*gamma3*(m*R^2*I1 + I1^2)) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t8;
    const double t9 = x[2]*t8; /* omega_tau*s */
    out[0] = t9;
    const double t10 = x[3]*t8; /* omega_n*s */
    const double t11 = p[9] - t10; /* G_level/(R*I1) - omega_n*s */
    const double t12 = t6*t10; /* 1/s^2*omega_n*s */
    const double t13 = p[8]*t7; /* 1/gamma3 = (m*R^2*I1 + I1^2)*1/(gamma3*Theta) */
    const double t14 = t11*t13; /* (G_level/(R*I1) - omega_n*s)*1/gamma3 */
    const double t15 = x[0]*t7; /* 1/Theta = gamma3*1/(gamma3*Theta) */
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = p[10]*t16; /* m*R*I1*V */
    const double t18 = JLT_FNMA(t15, t17, x[2]); /* omega_tau - 1/Theta*m*R*I1*V */
    const double t19 = x[0]*t12; /* gamma3*1/s^2*omega_n*s */
    const double t20 = x[0]*t8; /* gamma3*s */
    const double t21 = t8*t13; /* s*1/gamma3 */
    const double t22 = JLT_FMS(t13, t14, t12); /* d(omega3)/d(gamma3) = 1/gamma3*(G_level/(R*I1) - omega_n*s)*1/gamma3 - 1/s^2*omega_n*s */
    const double t23 = t6*t12; /* 1/s^2*1/s^2*omega_n*s */
    const double t24 = t6*t20; /* 1/s^2*gamma3*s */
    const double t25 = t14 - t19; /* (G_level/(R*I1) - omega_n*s)*1/gamma3 - gamma3*1/s^2*omega_n*s */
    const double t26 = x[3]*t25; /* omega_n*t25 */
    out[2] = t26;
    const double t27 = p[7]*t26; /* (-R)*omega_n*t25 */
    out[1] = t27;
    const double t28 = p[8]*t15; /* (m*R^2*I1 + I1^2)*1/Theta */
    const double t29 = t15*t19; /* 1/Theta*gamma3*1/s^2*omega_n*s */
    const double t30 = p[11]*t29; /* (-m*R*I1)*1/Theta*gamma3*1/s^2*omega_n*s */
    out[17] = t30;
    const double t31 = t22 + t23; /* d(omega3)/d(gamma3) + 1/s^2*1/s^2*omega_n*s */
    const double t32 = x[3]*t31; /* omega_n*(d(omega3)/d(gamma3) + 1/s^2*1/s^2*omega_n*s) */
    const double t33 = t18*t23; /* (omega_tau - 1/Theta*m*R*I1*V)*1/s^2*1/s^2*omega_n*s */
    const double t34 = p[1]*t32; /* R*omega_n*(d(omega3)/d(gamma3) + 1/s^2*1/s^2*omega_n*s) */
    out[8] = t34;
    const double t35 = -t32; /* -omega_n*(d(omega3)/d(gamma3) + 1/s^2*1/s^2*omega_n*s) */
    out[12] = t35;
    const double t36 = JLT_FNMA(x[3], t21, t14); /* (G_level/(R*I1) - omega_n*s)*1/gamma3 - omega_n*s*1/gamma3 */
    const double t37 = JLT_FNMA(2.0, t19, t36); /* (G_level/(R*I1) - omega_n*s)*1/gamma3 - omega_n*s*1/gamma3 - 2*gamma3*1/s^2*omega_n*s */
    out[15] = t37;
    const double t38 = p[7]*t37; /* (-R)*t37 */
    out[11] = t38;
    const double t39 = t18*t19; /* (omega_tau - 1/Theta*m*R*I1*V)*gamma3*1/s^2*omega_n*s */
    const double t40 = t18*t24; /* (omega_tau - 1/Theta*m*R*I1*V)*1/s^2*gamma3*s */
    const double t41 = x[2]*t24; /* omega_tau*1/s^2*gamma3*s */
    const double t42 = -t41; /* -omega_tau*1/s^2*gamma3*s */
    out[4] = t42;
    const double t43 = x[2]*t28; /* omega_tau*(m*R^2*I1 + I1^2)*1/Theta */
    const double t44 = JLT_FMA(t22, t43, t33); /* d(omega3)/d(gamma3)*omega_tau*(m*R^2*I1 + I1^2)*1/Theta + (omega_tau - 1/Theta*m*R*I1*V)*1/s^2*1/s^2*omega_n*s */
    out[16] = t44;
    const double t45 = JLT_FMA(t21, t43, t40); /* s*1/gamma3*omega_tau*(m*R^2*I1 + I1^2)*1/Theta + (omega_tau - 1/Theta*m*R*I1*V)*1/s^2*gamma3*s */
    out[19] = t45;
    const double t46 = JLT_FNMA(t14, t43, t39); /* (omega_tau - 1/Theta*m*R*I1*V)*gamma3*1/s^2*omega_n*s - (G_level/(R*I1) - omega_n*s)*1/gamma3*omega_tau*(m*R^2*I1 + I1^2)*1/Theta */
    out[3] = t46;
    const double t47 = t14*t28; /* (G_level/(R*I1) - omega_n*s)*1/gamma3*(m*R^2*I1 + I1^2)*1/Theta */
    const double t48 = JLT_FMS(p[12], t29, t47); /* I1^2*1/Theta*gamma3*1/s^2*omega_n*s - t47 */
    out[18] = t48;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = x[0]*p[8]; /* gamma3*(m*R^2*I1 + I1^2) */
    const double t5 = t3*t4; /* s*gamma3*(m*R^2*I1 + I1^2) */
    const double t6 = 1.0/t5; /* 1/(s*gamma3*(m*R^2*I1 + I1^2)) */
    const double t7 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t8 = x[0]*t4; /* gamma3*gamma3*(m*R^2*I1 + I1^2) */
    const double t9 = t7*t8; /* V*gamma3*gamma3*(m*R^2*I1 + I1^2) */
    const double t10 = x[2]*p[13]; /* omega_tau*(m*R^2*I1 + I1^2)^2/(m*R*I1) */
    const double t11 = JLT_FNMA(t2, t10, t9); /* V*gamma3*gamma3*(m*R^2*I1 + I1^2) - (1 - gamma3)*(gamma3 + 1)*omega_tau*(m*R^2*I1 + I1^2)^2/(m*R*I1) */
    const double t12 = p[11]*x[0]; /* (-m*R*I1)*gamma3 */
    const double t13 = t11*t12; /* t11*(-m*R*I1)*gamma3 */
    const double t14 = t3*t13; /* s*t11*(-m*R*I1)*gamma3 */
    const double t15 = t6*t14; /* 1/(s*gamma3*(m*R^2*I1 + I1^2))*s*t11*(-m*R*I1)*gamma3 */
    const double t16 = t6*t15; /* 1/(s*gamma3*(m*R^2*I1 + I1^2))*1/(s*gamma3*(m*R^2*I1 + I1^2))*s*t11*(-m*R*I1)*gamma3 */
    out[0] = t16;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FNMA(x[3], t3, p[9]); /* G_level/(R*I1) - omega_n*s */
    const double t5 = t4/x[0]; /* (G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t6 = t3*t5; /* s*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t7 = JLT_FMS(x[3], x[0], t6); /* v_tau/R = omega_n*gamma3 - s*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t8 = x[3]*x[3]; /* omega_n*omega_n */
    const double t9 = JLT_FMA(x[2], x[2], t8); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t10 = p[15]*x[1]; /* m/I1*v_nu */
    const double t11 = JLT_FMA(x[1], t10, t9); /* v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t12 = JLT_FMA(t5, t5, t11); /* (G_level/(R*I1) - omega_n*s)/gamma3*(G_level/(R*I1) - omega_n*s)/gamma3 + v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t13 = p[16]*t7; /* m*R^2/I1*v_tau/R */
    const double t14 = JLT_FMA(t7, t13, t12); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t12 */
    const double t15 = p[14]*t14; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t15;
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[2] = t16;
    const double t17 = p[17]*t16; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t18 = t16*t17; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t18;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[9] = 1.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    const double t4 = t3*x[3]; /* s*omega_n */
    const double t5 = p[9] - t4; /* G_level/(R*I1) - s*omega_n */
    const double t6 = x[0]*t2; /* gamma3*s^2 */
    const double t7 = 1.0/t6; /* 1/(gamma3*s^2) */
    const double t8 = t2*t7; /* 1/gamma3 = s^2*1/(gamma3*s^2) */
    const double t9 = t5*t8; /* (G_level/(R*I1) - s*omega_n)*1/gamma3 */
    const double t10 = t8*t9; /* 1/gamma3*(G_level/(R*I1) - s*omega_n)*1/gamma3 */
    const double t11 = x[0]*t7; /* 1/s^2 = gamma3*1/(gamma3*s^2) */
    const double t12 = JLT_FNMA(t4, t11, t10); /* d(omega3)/d(gamma3) = 1/gamma3*(G_level/(R*I1) - s*omega_n)*1/gamma3 - s*omega_n*1/s^2 */
    const double t13 = t3*t9; /* s*(G_level/(R*I1) - s*omega_n)*1/gamma3 */
    const double t14 = x[0]*t11; /* gamma3*1/s^2 */
    const double t15 = JLT_FMA(t13, t14, x[3]); /* s*(G_level/(R*I1) - s*omega_n)*1/gamma3*gamma3*1/s^2 + omega_n */
    const double t16 = JLT_FMA(t3, t12, t15); /* s*d(omega3)/d(gamma3) + t15 */
    const double t17 = JLT_FMS(x[0], x[3], t13); /* gamma3*omega_n - s*(G_level/(R*I1) - s*omega_n)*1/gamma3 */
    const double t18 = p[18]*t17; /* m*R^2*(gamma3*omega_n - s*(G_level/(R*I1) - s*omega_n)*1/gamma3) */
    const double t19 = t16*t18; /* (s*d(omega3)/d(gamma3) + t15)*t18 */
    const double t20 = t9*p[4]; /* (G_level/(R*I1) - s*omega_n)*1/gamma3*I1 */
    const double t21 = JLT_FNMA(t12, t20, t19); /* d(energy)/d(gamma3) = (s*d(omega3)/d(gamma3) + t15)*t18 - d(omega3)/d(gamma3)*(G_level/(R*I1) - s*omega_n)*1/gamma3*I1 */
    out[0] = t21;
    const double t22 = p[0]*x[1]; /* m*v_nu */
    out[1] = t22;
    const double t23 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t23;
    const double t24 = t8*t18; /* 1/gamma3*t18 */
    const double t25 = JLT_FNMA(t8, t13, x[3]); /* omega_n - 1/gamma3*s*(G_level/(R*I1) - s*omega_n)*1/gamma3 */
    const double t26 = JLT_FMA(p[4], t25, t24); /* d(energy)/d(omega_n) = I1*(omega_n - 1/gamma3*s*(G_level/(R*I1) - s*omega_n)*1/gamma3) + 1/gamma3*t18 */
    out[3] = t26;
    out[4] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[10] = p[1];
    const double t27 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t28 = p[19]*t27; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[5] = t28;
    const double t29 = t27*p[20]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[6] = t29;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FNMA(x[3], t3, p[9]); /* G_level/(R*I1) - omega_n*s */
    const double t5 = t4/x[0]; /* (G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t6 = -t5; /* -(G_level/(R*I1) - omega_n*s)/gamma3 */
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
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    const double t20 = 1.0/p[8];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
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
        t11[k] = (k == 0 ? p[9] : 0) - jlt_jet_product(t6, x3, k);
        t12[k] = jlt_jet_quotient(t11[k], x0, t12, k);
        t13[k] = jlt_jet_product(x0, x3, k);
        t14[k] = jlt_jet_quotient(t13[k], t6, t14, k);
        t15[k] = t12[k] - t14[k];
        t16[k] = jlt_jet_product(x3, t15, k);
        t17[k] = p[7]*t16[k];
        t23[k] = x2[k]*p[1] + x1[k];
        t24[k] = p[10]*t23[k];
        t25[k] = x2[k] - t20*t24[k];
        t26[k] = jlt_jet_product(t14, t25, k);
        t27[k] = x2[k]*p[8];
        t28[k] = t20*t27[k];
        t29[k] = t26[k] - jlt_jet_product(t12, t28, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t17[k]/(k + 1);
        next[2] = x2[k + 1] = t16[k]/(k + 1);
        next[3] = x3[k + 1] = t29[k]/(k + 1);
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
    const double v_I1 = params[4];
    const double v_I3 = (v_I1);
    const double v_G_level = params[6];
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
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_omega3 = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "",
    .elimination = "level_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .prepared_count = 21,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 18, 3, 1, 1, 0, 10, 5 }, { 11, 43, 0, 7, 1, 0, 12, 8 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, V = omega_tau*R + v_nu, omega_tau - 1/Theta*(m*R*I1)*V, a part of d(v_nu)/dt and of d(omega_tau)/dt, d(omega_n)/dt" },
    .jacobian = { jacobian, 16, { 6, 26, 8, 1, 1, 0, 13, 9 }, { 30, 113, 0, 27, 1, 0, 13, 9 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in (G_level/(R*I1))*1/gamma3 - omega_n*s*1/gamma3, d(omega3)/d(gamma3), d(d(omega_tau)/dt)/d(omega_n), V = omega_tau*R + v_nu, omega_tau - 1/Theta*(m*R*I1)*V, d(d(omega_n)/dt)/d(omega_tau), d(omega3)/d(gamma3) + 1/s^2*omega_n*1/s^2*s, d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 31, 9, 1, 1, 0, 11, 11 }, { 36, 138, 0, 33, 1, 0, 13, 9 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, V = omega_tau*R + v_nu, omega_tau - 1/Theta*(m*R*I1)*V, d(omega3)/d(gamma3) = 1/gamma3*(G_level/(R*I1) - omega_n*s)*1/gamma3 - 1/s^2*omega_n*s, (G_level/(R*I1) - omega_n*s)*1/gamma3 - gamma3*1/s^2*omega_n*s, d(omega3)/d(gamma3) + 1/s^2*1/s^2*omega_n*s, d(d(omega_tau)/dt)/d(omega_n), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), d(omega_n)/dt, d(d(omega_n)/dt)/d(omega_tau)" },
    .divergence = { divergence, 1, { 2, 11, 2, 1, 1, 0, 8, 6 }, { 6, 28, 0, 3, 1, 0, 11, 7 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = R*omega_tau + v_nu, a part of the divergence" },
    .integral_values = { integral_values, 3, { 2, 8, 7, 1, 1, 0, 10, 5 }, { 9, 31, 0, 1, 1, 0, 15, 5 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, v_tau/R = omega_n*gamma3 - s*((G_level/(R*I1) - omega_n*s)/gamma3), F_linear" },
    .integral_gradients = { integral_gradients, 12, { 3, 17, 8, 1, 1, 0, 11, 7 }, { 13, 46, 0, 6, 1, 0, 12, 9 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n, d(omega3)/d(gamma3) = 1/gamma3*(G_level/(R*I1) - s*omega_n)*1/gamma3 - s*omega_n*1/s^2, a part of d(E)/d(gamma3), gamma3*omega_n - s*(G_level/(R*I1) - s*omega_n)*1/gamma3, d(E)/d(gamma3), omega_n - 1/gamma3*s*(G_level/(R*I1) - s*omega_n)*1/gamma3, d(E)/d(omega_n), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 1, 1, 1, 1, 0, 6, 3 }, { 2, 6, 0, 1, 1, 0, 6, 4 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .eliminated_state = 4, .level_integral = 1,
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_on_level_omega3,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_equal_on_level_omega3) },
#endif
};
