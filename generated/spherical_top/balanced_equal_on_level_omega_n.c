/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I3 = I1
 *  Eliminated: level_omega_n: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   13    3    1    1    0      9    5   (45)
 *  jacobian            8   22    5    1    1    0     11    8   (123)
 *  rhs_jacobian        10   26    5    1    1    0     11    9   (143)
 *  divergence          2    7    2    1    1    0      7    4   (28)
 *  integral_values     2    9    7    1    1    0      8    5   (42)
 *  integral_gradients  2   10    5    1    1    0     11    5   (68)
 *  eliminated          2    1    1    1    1    0      4    3   (10)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1), V = omega_tau*R + v_nu,
 *      a part of d(v_nu)/dt and of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(omega3),
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3)
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_omega_n;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_on_level_omega_n;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_omega_n_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_omega_n_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_omega_n_avx512;

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
    const double t4 = params[4]*t3; /* I1*m*R*R */
    const double t5 = params[4]*params[4]; /* I1*I1 */
    const double t6 = t4 + t5; /* I1*m*R*R + I1*I1 */
    out[8] = t6;
    const double t7 = params[1]*params[0]; /* R*m */
    const double t8 = params[4]*t7; /* I1*R*m */
    out[10] = t8;
    const double t9 = -t8; /* -I1*R*m */
    out[9] = t9;
    const double t10 = -t4; /* -I1*m*R*R */
    out[11] = t10;
    const double t11 = t10 - t5; /* -I1*m*R*R - I1*I1 */
    out[12] = t11;
    const double t12 = params[4]/2.0; /* I1/2 */
    out[13] = t12;
    const double t13 = params[0]/params[4]; /* m/I1 */
    out[14] = t13;
    const double t14 = t3/params[4]; /* m*R*R/I1 */
    out[15] = t14;
    const double t15 = params[0]*t5; /* m*I1*I1 */
    out[16] = t15;
    const double t16 = params[0]*2.0; /* m*2 */
    const double t17 = t5*t16; /* I1*I1*m*2 */
    out[17] = t17;
    const double t18 = params[1]*t16; /* R*m*2 */
    const double t19 = t5*t18; /* I1*I1*R*m*2 */
    out[18] = t19;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    out[0] = t4;
    const double t5 = JLT_FMA(x[0], x[3], p[7]); /* gamma3*omega3 + G_level/(R*I1) */
    const double t6 = t2*p[8]; /* s^2*(m*R^2*I1 + I1^2) */
    const double t7 = 1.0/t6; /* 1/(s^2*(m*R^2*I1 + I1^2)) */
    const double t8 = t3*p[8]; /* s*(m*R^2*I1 + I1^2) */
    const double t9 = t7*t8; /* 1/(s^2*(m*R^2*I1 + I1^2))*s*(m*R^2*I1 + I1^2) */
    const double t10 = t5*t9; /* omega_n = (gamma3*omega3 + G_level/(R*I1))*1/(s^2*(m*R^2*I1 + I1^2))*s*(m*R^2*I1 + I1^2) */
    const double t11 = x[0]*t9; /* gamma3*1/(s^2*(m*R^2*I1 + I1^2))*s*(m*R^2*I1 + I1^2) */
    const double t12 = JLT_FMA(t10, t11, x[3]); /* omega_n*gamma3*1/(s^2*(m*R^2*I1 + I1^2))*s*(m*R^2*I1 + I1^2) + omega3 */
    const double t13 = t10*t12; /* omega_n*t12 */
    const double t14 = p[1]*t13; /* R*omega_n*t12 */
    out[1] = t14;
    const double t15 = -t13; /* -omega_n*t12 */
    out[2] = t15;
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = t2*p[9]; /* s^2*(-m*R*I1) */
    const double t18 = t16*t17; /* V*s^2*(-m*R*I1) */
    const double t19 = t7*t18; /* 1/(s^2*(m*R^2*I1 + I1^2))*V*s^2*(-m*R*I1) */
    const double t20 = t10*t19; /* omega_n*1/(s^2*(m*R^2*I1 + I1^2))*V*s^2*(-m*R*I1) */
    out[3] = t20;
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
    const double t3 = p[8]*t2; /* (m*R^2*I1 + I1^2)*s^2 */
    const double t4 = 1.0/t3; /* 1/((m*R^2*I1 + I1^2)*s^2) */
    const double t5 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t5;
    const double t6 = p[8]*t5; /* (m*R^2*I1 + I1^2)*s */
    const double t7 = t4*t6; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t8 = t2*t4; /* 1/Theta = s^2*1/((m*R^2*I1 + I1^2)*s^2) */
    const double t9 = JLT_FMA(x[0], x[3], p[7]); /* gamma3*omega3 + G_level/(R*I1) */
    const double t10 = t7*t9; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t11 = x[0]*t7; /* gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t12 = t7*t10; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t10 */
    const double t13 = t10*t11; /* t10*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t15 = p[10]*t14; /* m*R*I1*V */
    const double t16 = t8*t15; /* 1/Theta*m*R*I1*V */
    const double t17 = t8*t10; /* 1/Theta*t10 */
    const double t18 = p[9]*t17; /* (-m*R*I1)*1/Theta*t10 */
    out[13] = t18;
    const double t19 = p[11]*t17; /* (-m*R^2*I1)*1/Theta*t10 */
    out[14] = t19;
    const double t20 = t7*t12; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t10 */
    const double t21 = t12*t20; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t10*t20 */
    const double t22 = x[3] + t13; /* omega3 + t10*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t23 = t7*t22; /* d(omega_n)/d(gamma3) = 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t22 */
    const double t24 = JLT_FMA(2.0, t13, x[3]); /* 2*t10*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s + omega3 */
    const double t25 = JLT_FMA(t23, t24, t21); /* d(omega_n)/d(gamma3)*t24 + 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t10*t20 */
    const double t26 = JLT_FMA(t11, t24, t10); /* gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t24 + t10 */
    const double t27 = t16*t23; /* 1/Theta*m*R*I1*V*d(omega_n)/d(gamma3) */
    const double t28 = -t27; /* -1/Theta*m*R*I1*V*d(omega_n)/d(gamma3) */
    out[12] = t28;
    const double t29 = t11*t16; /* gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*1/Theta*m*R*I1*V */
    const double t30 = -t29; /* -t29 */
    out[15] = t30;
    const double t31 = x[2]*t11; /* omega_tau*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t32 = -t31; /* -t31 */
    out[0] = t32;
    const double t33 = p[1]*t25; /* R*t25 */
    out[4] = t33;
    const double t34 = -t25; /* -t25 */
    out[8] = t34;
    const double t35 = p[1]*t26; /* R*t26 */
    out[7] = t35;
    const double t36 = -t26; /* -t26 */
    out[11] = t36;
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
    const double t3 = p[8]*t2; /* (m*R^2*I1 + I1^2)*s^2 */
    const double t4 = 1.0/t3; /* 1/((m*R^2*I1 + I1^2)*s^2) */
    const double t5 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t5;
    const double t6 = t2*t4; /* 1/Theta = s^2*1/((m*R^2*I1 + I1^2)*s^2) */
    const double t7 = x[2]*t5; /* omega_tau*s */
    out[0] = t7;
    const double t8 = p[8]*t5; /* (m*R^2*I1 + I1^2)*s */
    const double t9 = t4*t8; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t10 = JLT_FMA(x[0], x[3], p[7]); /* gamma3*omega3 + G_level/(R*I1) */
    const double t11 = t9*t10; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t12 = x[0]*t9; /* gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t13 = t11*t12; /* t11*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t15 = p[10]*t14; /* m*R*I1*V */
    const double t16 = t6*t15; /* 1/Theta*m*R*I1*V */
    const double t17 = t6*t11; /* 1/Theta*t11 */
    const double t18 = p[9]*t17; /* (-m*R*I1)*1/Theta*t11 */
    out[17] = t18;
    const double t19 = p[11]*t17; /* (-m*R^2*I1)*1/Theta*t11 */
    out[18] = t19;
    const double t20 = t9*t11; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t11 */
    const double t21 = x[3] + t13; /* omega3 + t11*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t22 = JLT_FMA(2.0, t13, x[3]); /* 2*t11*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s + omega3 */
    const double t23 = t9*t20; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t11 */
    const double t24 = t20*t23; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t11*t23 */
    const double t25 = t9*t21; /* d(omega_n)/d(gamma3) = 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t21 */
    const double t26 = t11*t21; /* t11*t21 */
    const double t27 = JLT_FMA(t22, t25, t24); /* t22*d(omega_n)/d(gamma3) + 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t11*t23 */
    const double t28 = JLT_FMA(t12, t22, t11); /* gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t22 + t11 */
    const double t29 = t11*t16; /* t11*1/Theta*m*R*I1*V */
    const double t30 = -t29; /* -t11*1/Theta*m*R*I1*V */
    out[3] = t30;
    const double t31 = t16*t25; /* 1/Theta*m*R*I1*V*d(omega_n)/d(gamma3) */
    const double t32 = -t31; /* -1/Theta*m*R*I1*V*d(omega_n)/d(gamma3) */
    out[16] = t32;
    const double t33 = t12*t16; /* gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*1/Theta*m*R*I1*V */
    const double t34 = -t33; /* -t33 */
    out[19] = t34;
    const double t35 = x[2]*t12; /* omega_tau*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t36 = -t35; /* -t35 */
    out[4] = t36;
    const double t37 = p[1]*t26; /* R*t11*t21 */
    out[1] = t37;
    const double t38 = -t26; /* -t11*t21 */
    out[2] = t38;
    const double t39 = p[1]*t27; /* R*t27 */
    out[8] = t39;
    const double t40 = -t27; /* -t27 */
    out[12] = t40;
    const double t41 = p[1]*t28; /* R*t28 */
    out[11] = t41;
    const double t42 = -t28; /* -t28 */
    out[15] = t42;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t5 = t3*p[8]; /* s*(m*R^2*I1 + I1^2) */
    const double t6 = 1.0/t5; /* 1/(s*(m*R^2*I1 + I1^2)) */
    const double t7 = p[10]*t4; /* m*R*I1*V */
    const double t8 = t3*t7; /* s*m*R*I1*V */
    const double t9 = JLT_FMA(t6, t8, x[2]); /* 1/(s*(m*R^2*I1 + I1^2))*s*m*R*I1*V + omega_tau */
    const double t10 = p[12]*x[0]; /* (-m*R^2*I1 - I1^2)*gamma3 */
    const double t11 = t6*t10; /* 1/(s*(m*R^2*I1 + I1^2))*(-m*R^2*I1 - I1^2)*gamma3 */
    const double t12 = t9*t11; /* (1/(s*(m*R^2*I1 + I1^2))*s*m*R*I1*V + omega_tau)*1/(s*(m*R^2*I1 + I1^2))*(-m*R^2*I1 - I1^2)*gamma3 */
    out[0] = t12;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], x[3], p[7]); /* gamma3*omega3 + G_level/(R*I1) */
    const double t4 = t3/t2; /* (gamma3*omega3 + G_level/(R*I1))/s^2 */
    const double t5 = sqrt(t2); /* s = sqrt(s^2) */
    const double t6 = t4*t5; /* omega_n = (gamma3*omega3 + G_level/(R*I1))/s^2*s */
    const double t7 = x[3]*t5; /* omega3*s */
    const double t8 = JLT_FMA(x[0], t6, t7); /* v_tau/R = gamma3*omega_n + omega3*s */
    const double t9 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t10 = JLT_FMA(x[3], x[3], t9); /* omega3*omega3 + omega_tau*omega_tau */
    const double t11 = p[14]*x[1]; /* m/I1*v_nu */
    const double t12 = JLT_FMA(x[1], t11, t10); /* v_nu*m/I1*v_nu + omega3*omega3 + omega_tau*omega_tau */
    const double t13 = JLT_FMA(t6, t6, t12); /* omega_n*omega_n + v_nu*m/I1*v_nu + omega3*omega3 + omega_tau*omega_tau */
    const double t14 = p[15]*t8; /* m*R^2/I1*v_tau/R */
    const double t15 = JLT_FMA(t8, t14, t13); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t13 */
    const double t16 = p[13]*t15; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t16;
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[2] = t17;
    const double t18 = p[16]*t17; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t19 = t17*t18; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t19;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[9] = 1.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = 1.0/t3; /* 1/s */
    const double t5 = JLT_FMA(x[0], x[3], p[7]); /* gamma3*omega3 + G_level/(R*I1) */
    const double t6 = t4*t5; /* 1/s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t7 = x[0]*t6; /* gamma3*1/s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t8 = JLT_FMA(t3, x[3], t7); /* v_tau/R = s*omega3 + gamma3*1/s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t9 = JLT_FMA(p[15], t8, t7); /* m*R^2/I1*v_tau/R + gamma3*1/s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t10 = JLT_FMA(t4, t9, x[3]); /* 1/s*t9 + omega3 */
    const double t11 = p[4]*t10; /* I1*(1/s*t9 + omega3) */
    out[3] = t11;
    const double t12 = t4*t6; /* 1/s*1/s*(gamma3*omega3 + G_level/(R*I1)) */
    const double t13 = t11*t12; /* I1*(1/s*t9 + omega3)*1/s*1/s*(gamma3*omega3 + G_level/(R*I1)) */
    out[0] = t13;
    const double t14 = p[0]*x[1]; /* m*v_nu */
    out[1] = t14;
    const double t15 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t15;
    out[4] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[10] = p[1];
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t17 = p[17]*t16; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[5] = t17;
    const double t18 = t16*p[18]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[6] = t18;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], x[3], p[7]); /* gamma3*omega3 + G_level/(R*I1) */
    const double t5 = t4/t3; /* (gamma3*omega3 + G_level/(R*I1))/s */
    out[0] = t5;
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
    double t9[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
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
        t9[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t6, t9, k);
        t12[k] = jlt_jet_product(x0, x3, k) + (k == 0 ? p[7] : 0);
        t13[k] = jlt_jet_product(t9, t12, k);
        t14[k] = jlt_jet_product(x0, t9, k);
        t15[k] = jlt_jet_product(t13, t14, k) + x3[k];
        t16[k] = jlt_jet_product(t13, t15, k);
        t17[k] = p[1]*t16[k];
        t18[k] = -t16[k];
        t22[k] = x2[k]*p[1] + x1[k];
        t23[k] = p[9]*t22[k];
        t24[k] = t23[k]/p[8];
        t25[k] = jlt_jet_product(t13, t24, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t17[k]/(k + 1);
        next[2] = x2[k + 1] = t18[k]/(k + 1);
        next[3] = x3[k + 1] = t25[k]/(k + 1);
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
    const double v_I3 = (v_I1);
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
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_omega_n = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "",
    .elimination = "level_omega_n",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .prepared_count = 19,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 13, 3, 1, 1, 0, 9, 5 }, { 9, 31, 0, 4, 1, 0, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1), omega_n*gamma3*((1)/s^2*(m*R^2*I1 + I1^2))*s*(m*R^2*I1 + I1^2) + omega3, V = omega_tau*R + v_nu" },
    .jacobian = { jacobian, 16, { 8, 22, 5, 1, 1, 0, 11, 8 }, { 24, 80, 0, 18, 1, 0, 13, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1), V = omega_tau*R + v_nu, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 10, 26, 5, 1, 1, 0, 11, 9 }, { 28, 93, 0, 21, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1), V = omega_tau*R + v_nu, a part of d(v_nu)/dt and of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3)" },
    .divergence = { divergence, 1, { 2, 7, 2, 1, 1, 0, 7, 4 }, { 6, 19, 0, 2, 1, 0, 10, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, ((1)/s*(m*R^2*I1 + I1^2))*s*(m*R*I1)*V + omega_tau" },
    .integral_values = { integral_values, 3, { 2, 9, 7, 1, 1, 0, 8, 5 }, { 9, 31, 0, 1, 1, 0, 13, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1), v_tau/R = gamma3*omega_n + omega3*s, F_linear" },
    .integral_gradients = { integral_gradients, 12, { 2, 10, 5, 1, 1, 0, 11, 5 }, { 13, 48, 0, 6, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1), v_tau/R = s*omega3 + gamma3*((1)/s)*(gamma3*omega3 + G_level/(R*I1)), (m*R^2/I1)*v_tau/R + gamma3*((1)/s)*(gamma3*omega3 + G_level/(R*I1)), a part of d(E)/d(gamma3) and of d(E)/d(omega3), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 1, 1, 1, 1, 0, 4, 3 }, { 2, 6, 0, 1, 1, 0, 5, 3 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3 + G_level/(R*I1)" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .eliminated_state = 3, .level_integral = 1,
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_on_level_omega_n,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_equal_on_level_omega_n) },
#endif
};
