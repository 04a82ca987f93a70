/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I3 = I1
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   15    3    1    1    0      9    5   (61)
 *  jacobian            7   26    4    1    1    0      9    6   (143)
 *  rhs_jacobian        11   32    4    1    1    0     10    8   (186)
 *  divergence          2    7    1    1    1    0      7    5   (25)
 *  integral_values     2   10    7    0    1    0      8    4   (42)
 *  integral_gradients  2   14    6    1    1    0      8    4   (53)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in V = omega_tau*R + v_nu,
 *      omega3 + omega_n*gamma3*((1)/(m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s, omega_tau - 1/Theta*(m*R*I1)*V,
 *      d(omega_n)/dt, a part of d(d(v_nu)/dt)/d(omega_n) and of d(d(omega_tau)/dt)/d(omega_n),
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
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal;
extern const struct jlt_ball_table jlt_balls_spherical_top_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_avx512;

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
    out[17] = t1;
    const double t2 = t1*params[4]; /* m*R*R*I1 */
    const double t3 = params[4]*params[4]; /* I1*I1 */
    out[9] = t3;
    const double t4 = t2 + t3; /* m*R*R*I1 + I1*I1 */
    out[6] = t4;
    const double t5 = params[0]*params[1]; /* m*R */
    const double t6 = params[4]*t5; /* I1*m*R */
    out[7] = t6;
    const double t7 = -t6; /* -I1*m*R */
    out[8] = t7;
    const double t8 = -t2; /* -m*R*R*I1 */
    out[10] = t8;
    const double t9 = t4*t6; /* (m*R*R*I1 + I1*I1)*I1*m*R */
    const double t10 = -t9; /* -(m*R*R*I1 + I1*I1)*I1*m*R */
    out[11] = t10;
    const double t11 = params[4]/2.0; /* I1/2 */
    out[12] = t11;
    const double t12 = params[0]/params[4]; /* m/I1 */
    out[13] = t12;
    const double t13 = t1/params[4]; /* m*R*R/I1 */
    out[14] = t13;
    const double t14 = params[1]*params[4]; /* R*I1 */
    out[15] = t14;
    const double t15 = params[0]*t3; /* m*I1*I1 */
    out[16] = t15;
    const double t16 = -t14; /* -R*I1 */
    out[18] = t16;
    const double t17 = params[0]*2.0; /* m*2 */
    const double t18 = t3*t17; /* I1*I1*m*2 */
    out[19] = t18;
    const double t19 = params[1]*t17; /* R*m*2 */
    const double t20 = t3*t19; /* I1*I1*R*m*2 */
    out[20] = t20;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    out[0] = t4;
    const double t5 = t2*p[6]; /* s^2*(m*R^2*I1 + I1^2) */
    const double t6 = 1.0/t5; /* 1/(s^2*(m*R^2*I1 + I1^2)) */
    const double t7 = x[0]*p[6]; /* gamma3*(m*R^2*I1 + I1^2) */
    const double t8 = x[3]*t7; /* omega_n*gamma3*(m*R^2*I1 + I1^2) */
    const double t9 = t6*t8; /* 1/(s^2*(m*R^2*I1 + I1^2))*omega_n*gamma3*(m*R^2*I1 + I1^2) */
    const double t10 = t3*t9; /* s*1/(s^2*(m*R^2*I1 + I1^2))*omega_n*gamma3*(m*R^2*I1 + I1^2) */
    const double t11 = x[4] + t10; /* omega3 + s*1/(s^2*(m*R^2*I1 + I1^2))*omega_n*gamma3*(m*R^2*I1 + I1^2) */
    const double t12 = x[3]*t11; /* omega_n*t11 */
    const double t13 = p[1]*t12; /* R*omega_n*t11 */
    out[1] = t13;
    const double t14 = -t12; /* -omega_n*t11 */
    out[2] = t14;
    const double t15 = t2*t6; /* 1/Theta = s^2*1/(s^2*(m*R^2*I1 + I1^2)) */
    const double t16 = x[4]*p[6]; /* omega3*(m*R^2*I1 + I1^2) */
    const double t17 = JLT_FMA(t15, t16, t10); /* 1/Theta*omega3*(m*R^2*I1 + I1^2) + s*1/(s^2*(m*R^2*I1 + I1^2))*omega_n*gamma3*(m*R^2*I1 + I1^2) */
    const double t18 = x[2]*t17; /* omega_tau*t17 */
    const double t19 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t20 = p[7]*t19; /* m*R*I1*V */
    const double t21 = t15*t20; /* 1/Theta*m*R*I1*V */
    const double t22 = JLT_FNMA(t10, t21, t18); /* omega_tau*t17 - s*1/(s^2*(m*R^2*I1 + I1^2))*omega_n*gamma3*(m*R^2*I1 + I1^2)*1/Theta*m*R*I1*V */
    out[3] = t22;
    const double t23 = x[3]*t21; /* omega_n*1/Theta*m*R*I1*V */
    const double t24 = -t23; /* -omega_n*1/Theta*m*R*I1*V */
    out[4] = t24;
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
    out[20] = 0.0;
    out[24] = 0.0;
    const double t0 = p[1]*x[3]; /* R*omega_n */
    out[9] = t0;
    const double t1 = -x[3]; /* -omega_n */
    out[14] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t5 = p[6]*t4; /* (m*R^2*I1 + I1^2)*s^2 */
    const double t6 = 1.0/t5; /* 1/((m*R^2*I1 + I1^2)*s^2) */
    const double t7 = sqrt(t4); /* s = sqrt(s^2) */
    out[2] = t7;
    const double t8 = p[6]*t7; /* (m*R^2*I1 + I1^2)*s */
    const double t9 = t6*t8; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t10 = t4*t6; /* 1/Theta = s^2*1/((m*R^2*I1 + I1^2)*s^2) */
    const double t11 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t12 = p[7]*t11; /* m*R*I1*V */
    const double t13 = t10*t12; /* 1/Theta*m*R*I1*V */
    const double t14 = -t13; /* -1/Theta*m*R*I1*V */
    out[23] = t14;
    const double t15 = x[3]*t9; /* omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t16 = x[2]*t9; /* omega_tau*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t17 = JLT_FNMA(t9, t13, t16); /* omega_tau*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s - 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*1/Theta*m*R*I1*V */
    const double t18 = t9*t15; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t19 = x[0]*t16; /* gamma3*omega_tau*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t20 = -t19; /* -t19 */
    out[0] = t20;
    const double t21 = t17*t18; /* t17*t18 */
    out[15] = t21;
    const double t22 = x[0]*t17; /* gamma3*t17 */
    out[18] = t22;
    const double t23 = t15*t18; /* omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t18 */
    const double t24 = x[0]*t15; /* gamma3*omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t25 = p[1]*t23; /* R*omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t18 */
    out[5] = t25;
    const double t26 = -t23; /* -omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t18 */
    out[10] = t26;
    const double t27 = p[6]*t10; /* (m*R^2*I1 + I1^2)*1/Theta */
    const double t28 = x[2]*t27; /* omega_tau*(m*R^2*I1 + I1^2)*1/Theta */
    out[19] = t28;
    const double t29 = x[4]*t27; /* omega3*(m*R^2*I1 + I1^2)*1/Theta */
    const double t30 = JLT_FMA(2.0, t24, x[4]); /* 2*gamma3*omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s + omega3 */
    const double t31 = t10*t24; /* 1/Theta*gamma3*omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t32 = JLT_FMA(p[9], t31, t29); /* I1^2*t31 + omega3*(m*R^2*I1 + I1^2)*1/Theta */
    out[17] = t32;
    const double t33 = p[8]*t31; /* (-m*R*I1)*t31 */
    out[16] = t33;
    const double t34 = x[3]*t10; /* omega_n*1/Theta */
    const double t35 = p[1]*t30; /* R*t30 */
    out[8] = t35;
    const double t36 = -t30; /* -t30 */
    out[13] = t36;
    const double t37 = p[8]*t34; /* (-m*R*I1)*omega_n*1/Theta */
    out[21] = t37;
    const double t38 = p[10]*t34; /* (-m*R^2*I1)*omega_n*1/Theta */
    out[22] = t38;
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
    out[25] = 0.0;
    out[29] = 0.0;
    const double t0 = p[1]*x[3]; /* R*omega_n */
    out[14] = t0;
    const double t1 = -x[3]; /* -omega_n */
    out[19] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t5 = p[6]*t4; /* (m*R^2*I1 + I1^2)*s^2 */
    const double t6 = 1.0/t5; /* 1/((m*R^2*I1 + I1^2)*s^2) */
    const double t7 = sqrt(t4); /* s = sqrt(s^2) */
    out[7] = t7;
    const double t8 = t4*t6; /* 1/Theta = s^2*1/((m*R^2*I1 + I1^2)*s^2) */
    const double t9 = x[2]*t7; /* omega_tau*s */
    out[0] = t9;
    const double t10 = p[6]*t7; /* (m*R^2*I1 + I1^2)*s */
    const double t11 = t6*t10; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t13 = p[7]*t12; /* m*R*I1*V */
    const double t14 = t8*t13; /* 1/Theta*m*R*I1*V */
    const double t15 = -t14; /* -1/Theta*m*R*I1*V */
    out[28] = t15;
    const double t16 = x[0]*t11; /* gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t17 = x[3]*t16; /* omega_n*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t18 = x[2]*t16; /* omega_tau*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t19 = -t18; /* -t18 */
    out[5] = t19;
    const double t20 = x[3]*t11; /* omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t21 = x[4] + t17; /* omega3 + omega_n*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t22 = x[3]*t21; /* omega_n*t21 */
    const double t23 = p[1]*t22; /* R*omega_n*t21 */
    out[1] = t23;
    const double t24 = -t22; /* -omega_n*t21 */
    out[2] = t24;
    const double t25 = x[2] - t14; /* omega_tau - 1/Theta*m*R*I1*V */
    const double t26 = x[3]*t14; /* omega_n*1/Theta*m*R*I1*V */
    const double t27 = -t26; /* -omega_n*1/Theta*m*R*I1*V */
    out[4] = t27;
    const double t28 = p[6]*t8; /* (m*R^2*I1 + I1^2)*1/Theta */
    const double t29 = t11*t20; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t30 = t20*t29; /* omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t29 */
    const double t31 = t11*t25; /* 1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*(omega_tau - 1/Theta*m*R*I1*V) */
    const double t32 = t29*t31; /* t29*t31 */
    out[20] = t32;
    const double t33 = x[0]*t31; /* gamma3*t31 */
    out[23] = t33;
    const double t34 = t17*t25; /* omega_n*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*(omega_tau - 1/Theta*m*R*I1*V) */
    const double t35 = p[1]*t30; /* R*omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t29 */
    out[10] = t35;
    const double t36 = -t30; /* -omega_n*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s*t29 */
    out[15] = t36;
    const double t37 = x[2]*t28; /* omega_tau*(m*R^2*I1 + I1^2)*1/Theta */
    out[24] = t37;
    const double t38 = JLT_FMA(x[4], t37, t34); /* omega3*omega_tau*(m*R^2*I1 + I1^2)*1/Theta + t34 */
    out[3] = t38;
    const double t39 = x[4]*t28; /* omega3*(m*R^2*I1 + I1^2)*1/Theta */
    const double t40 = JLT_FMA(2.0, t17, x[4]); /* 2*omega_n*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s + omega3 */
    const double t41 = t8*t17; /* 1/Theta*omega_n*gamma3*1/((m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s */
    const double t42 = JLT_FMA(p[9], t41, t39); /* I1^2*t41 + omega3*(m*R^2*I1 + I1^2)*1/Theta */
    out[22] = t42;
    const double t43 = p[8]*t41; /* (-m*R*I1)*t41 */
    out[21] = t43;
    const double t44 = x[3]*t8; /* omega_n*1/Theta */
    const double t45 = p[1]*t40; /* R*t40 */
    out[13] = t45;
    const double t46 = -t40; /* -t40 */
    out[18] = t46;
    const double t47 = p[8]*t44; /* (-m*R*I1)*omega_n*1/Theta */
    out[26] = t47;
    const double t48 = p[10]*t44; /* (-m*R^2*I1)*omega_n*1/Theta */
    out[27] = t48;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t5 = t3*p[6]; /* s*(m*R^2*I1 + I1^2) */
    const double t6 = 1.0/t5; /* 1/(s*(m*R^2*I1 + I1^2)) */
    const double t7 = p[11]*x[0]; /* (-m*R*I1*(m*R^2*I1 + I1^2))*gamma3 */
    const double t8 = t4*t7; /* V*(-m*R*I1*(m*R^2*I1 + I1^2))*gamma3 */
    const double t9 = t3*t8; /* s*V*(-m*R*I1*(m*R^2*I1 + I1^2))*gamma3 */
    const double t10 = t6*t9; /* 1/(s*(m*R^2*I1 + I1^2))*s*V*(-m*R*I1*(m*R^2*I1 + I1^2))*gamma3 */
    const double t11 = t6*t10; /* 1/(s*(m*R^2*I1 + I1^2))*t10 */
    out[0] = t11;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[3]*x[3]; /* omega_n*omega_n */
    const double t5 = JLT_FMA(x[2], x[2], t4); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t6 = JLT_FMA(x[4], x[4], t5); /* omega3*omega3 + omega_tau*omega_tau + omega_n*omega_n */
    const double t7 = x[4]*t3; /* omega3*s */
    const double t8 = JLT_FMA(x[3], x[0], t7); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t9 = x[3]*t3; /* omega_n*s */
    const double t10 = JLT_FNMA(x[4], x[0], t9); /* omega_n*s - omega3*gamma3 */
    const double t11 = p[15]*t10; /* R*I1*(omega_n*s - omega3*gamma3) */
    out[1] = t11;
    const double t12 = p[13]*x[1]; /* m/I1*v_nu */
    const double t13 = JLT_FMA(x[1], t12, t6); /* v_nu*m/I1*v_nu + omega3*omega3 + omega_tau*omega_tau + omega_n*omega_n */
    const double t14 = p[14]*t8; /* m*R^2/I1*v_tau/R */
    const double t15 = JLT_FMA(t8, t14, t13); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t13 */
    const double t16 = p[12]*t15; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t16;
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[3] = t17;
    const double t18 = p[16]*t17; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t19 = t17*t18; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[2] = t19;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[16] = 1.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[18] = 0.0;
    out[19] = 0.0;
    out[17] = p[1];
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t1;
    const double t2 = x[0]*p[18]; /* gamma3*(-R*I1) */
    out[9] = t2;
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = x[0] + 1.0; /* gamma3 + 1 */
    const double t5 = t3*t4; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t6 = sqrt(t5); /* s = sqrt(s^2) */
    const double t7 = x[0]/t5; /* gamma3/s^2 */
    const double t8 = t6*t7; /* s*gamma3/s^2 */
    const double t9 = p[15]*t6; /* R*I1*s */
    out[8] = t9;
    const double t10 = x[4]*t6; /* omega3*s */
    const double t11 = JLT_FMA(x[3], x[0], t10); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t12 = p[17]*t11; /* m*R^2*v_tau/R */
    const double t13 = t6*t12; /* s*m*R^2*v_tau/R */
    const double t14 = JLT_FMA(x[4], p[4], t13); /* d(energy)/d(omega3) = omega3*I1 + s*m*R^2*v_tau/R */
    out[4] = t14;
    const double t15 = JLT_FNMA(x[4], t8, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*s*gamma3/s^2 */
    const double t16 = t12*t15; /* m*R^2*v_tau/R*d(v_tau)/d(gamma3)/R */
    out[0] = t16;
    const double t17 = JLT_FMA(x[3], t8, x[4]); /* omega_n*s*gamma3/s^2 + omega3 */
    const double t18 = p[18]*t17; /* (-R*I1)*(omega_n*s*gamma3/s^2 + omega3) */
    out[5] = t18;
    const double t19 = x[3]*p[4]; /* omega_n*I1 */
    const double t20 = JLT_FMA(x[0], t12, t19); /* d(energy)/d(omega_n) = gamma3*m*R^2*v_tau/R + omega_n*I1 */
    out[3] = t20;
    const double t21 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t22 = p[19]*t21; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[11] = t22;
    const double t23 = p[20]*t21; /* 2*m*R*I1^2*(omega_tau*R + v_nu) */
    out[12] = t23;
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
    double t16[JLT_JET_ORDER_MAX + 1];
    const double t18 = 1.0/p[6];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
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
        t14[k] = jlt_jet_product(x3, t13, k);
        t15[k] = p[1]*t14[k];
        t16[k] = -t14[k];
        t19[k] = x4[k]*p[6];
        t20[k] = t18*t19[k] + t12[k];
        t21[k] = jlt_jet_product(x2, t20, k);
        t24[k] = x2[k]*p[1] + x1[k];
        t25[k] = p[7]*t24[k];
        t26[k] = t18*t25[k];
        t27[k] = t21[k] - jlt_jet_product(t12, t26, k);
        t28[k] = jlt_jet_product(x3, t26, k);
        t29[k] = -t28[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t15[k]/(k + 1);
        next[2] = x2[k + 1] = t16[k]/(k + 1);
        next[3] = x3[k + 1] = t27[k]/(k + 1);
        next[4] = x4[k + 1] = t29[k]/(k + 1);
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
    const double v_I3 = (v_I1);
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
    const double t1 = t0*params[4]; /* m*R*I1 */
    const double t2 = t1*x[0]; /* m*R*I1*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I1*gamma3*v_nu */
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t6 = t4*t5; /* (1 - gamma3)*(1 + gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t8 = params[1]*params[1]; /* R*R */
    const double t9 = params[0]*t8; /* m*R*R */
    const double t10 = params[4]*t9; /* I1*m*R*R */
    const double t11 = t7*t7; /* s*s */
    const double t12 = t10*t11; /* I1*m*R*R*s*s */
    const double t13 = params[4]*params[4]; /* I1*I1 */
    const double t14 = t12 + t13; /* I1*m*R*R*s*s + I1*I1 */
    const double t15 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t16 = t10*t15; /* I1*m*R*R*gamma3*gamma3 */
    const double t17 = t14 + t16; /* Theta = I1*m*R*R*s*s + I1*I1 + I1*m*R*R*gamma3*gamma3 */
    const double t18 = t7*t17; /* s*Theta */
    const double t19 = t3/t18; /* m*R*I1*gamma3*v_nu/(s*Theta) */
    const double t20 = -t19; /* -m*R*I1*gamma3*v_nu/(s*Theta) */
    out[0] = t20;
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
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    const double t7 = params[4]*t6; /* I1*m*R*R */
    const double t8 = t3*t3; /* s*s */
    const double t9 = t7*t8; /* I1*m*R*R*s*s */
    const double t10 = params[4]*params[4]; /* I1*I1 */
    const double t11 = t9 + t10; /* I1*m*R*R*s*s + I1*I1 */
    const double t12 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t13 = t7*t12; /* I1*m*R*R*gamma3*gamma3 */
    const double t14 = t11 + t13; /* Theta = I1*m*R*R*s*s + I1*I1 + I1*m*R*R*gamma3*gamma3 */
    const double t15 = t4*t14; /* I1*s*Theta */
    out[0] = t15;
    const double t16 = params[0]*params[1]; /* m*R */
    const double t17 = t10*t16; /* I1*I1*m*R */
    const double t18 = x[0]*t17; /* gamma3*I1*I1*m*R */
    const double t19 = t18*x[1]; /* gamma3*I1*I1*m*R*v_nu */
    out[1] = t19;
    const double t20 = x[4]*x[4]; /* omega3*omega3 */
    const double t21 = t10*t20; /* I1*I1*omega3*omega3 */
    const double t22 = t3*t21; /* s*I1*I1*omega3*omega3 */
    const double t23 = params[4] + t6; /* I1 + m*R*R */
    const double t24 = t22*t23; /* s*I1*I1*omega3*omega3*(I1 + m*R*R) */
    out[2] = t24;
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
    out[22] = 0.0;
    out[24] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t3;
    const double t4 = params[1]*x[4]; /* R*omega3 */
    out[8] = t4;
    const double t5 = -x[4]; /* -omega3 */
    out[13] = t5;
    const double t6 = x[4]*params[4]; /* omega3*I1 */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = params[0]*t7; /* m*R*R */
    const double t9 = params[4]*t8; /* I1*m*R*R */
    const double t10 = t3*t3; /* s*s */
    const double t11 = t9*t10; /* I1*m*R*R*s*s */
    const double t12 = params[4]*params[4]; /* I1*I1 */
    const double t13 = t11 + t12; /* I1*m*R*R*s*s + I1*I1 */
    const double t14 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t15 = t9*t14; /* I1*m*R*R*gamma3*gamma3 */
    const double t16 = t13 + t15; /* Theta = I1*m*R*R*s*s + I1*I1 + I1*m*R*R*gamma3*gamma3 */
    const double t17 = params[4] + t8; /* I1 + m*R*R */
    const double t18 = t6*t17; /* omega3*I1*(I1 + m*R*R) */
    const double t19 = t18/t16; /* omega3*I1*(I1 + m*R*R)/Theta */
    out[17] = t19;
    const double t20 = params[1]*params[0]; /* R*m */
    const double t21 = params[4]*t20; /* I1*R*m */
    const double t22 = x[0]*t21; /* gamma3*I1*R*m */
    const double t23 = t22*x[1]; /* gamma3*I1*R*m*v_nu */
    const double t24 = t3*t16; /* s*Theta */
    const double t25 = t23/t24; /* gamma3*I1*R*m*v_nu/(s*Theta) */
    const double t26 = -t25; /* -gamma3*I1*R*m*v_nu/(s*Theta) */
    out[18] = t26;
    const double t27 = t21*x[1]; /* I1*R*m*v_nu */
    const double t28 = t27/t16; /* I1*R*m*v_nu/Theta */
    const double t29 = -t28; /* -I1*R*m*v_nu/Theta */
    out[23] = t29;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[2] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
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
    const double t16 = t4*t13; /* s*m*R */
    const double t17 = t5*t16; /* v_tau*s*m*R */
    const double t18 = x[4]*params[4]; /* omega3*I1 */
    const double t19 = t17 + t18; /* d(energy)/d(omega3) = v_tau*s*m*R + omega3*I1 */
    out[4] = t19;
    const double t20 = params[1]*params[4]; /* R*I1 */
    const double t21 = x[0]*t20; /* gamma3*R*I1 */
    const double t22 = x[4]*t20; /* omega3*R*I1 */
    const double t23 = -t22; /* -omega3*R*I1 */
    out[5] = t23;
    const double t24 = t4*t20; /* s*R*I1 */
    out[8] = t24;
    const double t25 = -t21; /* -gamma3*R*I1 */
    out[9] = t25;
    const double t26 = params[0]*2.0; /* m*2 */
    const double t27 = params[4]*params[4]; /* I1*I1 */
    const double t28 = t26*t27; /* m*2*I1*I1 */
    const double t29 = x[1]*t28; /* v_nu*m*2*I1*I1 */
    out[11] = t29;
    const double t30 = params[1]*t26; /* R*m*2 */
    const double t31 = t27*t30; /* I1*I1*R*m*2 */
    const double t32 = x[1]*t31; /* v_nu*I1*I1*R*m*2 */
    out[12] = t32;
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
    { "F_linear", "a3 = 0, I1 = I3" },
};

static const signed char signs_7[] = { 1, -1, -1, 1, 1 };
static const jlt_reversor reversors[] = {
    { signs_7, 7 },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .scales = 1,
    .state_count = 5, .param_count = 6, .prepared_count = 21,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 5, 15, 3, 1, 1, 0, 9, 5 }, { 11, 42, 0, 7, 1, 0, 12, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3 + s*((1)/s^2*(m*R^2*I1 + I1^2))*omega_n*gamma3*(m*R^2*I1 + I1^2), a part of d(omega_n)/dt, V = omega_tau*R + v_nu, d(omega_n)/dt" },
    .jacobian = { jacobian, 25, { 7, 26, 4, 1, 1, 0, 9, 6 }, { 24, 95, 0, 23, 1, 0, 12, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, a part of d(d(omega_n)/dt)/d(gamma3) and of d(d(omega_n)/dt)/d(omega_n), a part of d(d(v_nu)/dt)/d(omega_n) and of d(d(omega_tau)/dt)/d(omega_n), d(d(omega_n)/dt)/d(omega_tau)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 11, 32, 4, 1, 1, 0, 10, 8 }, { 31, 124, 0, 30, 1, 0, 12, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, omega3 + omega_n*gamma3*((1)/(m*R^2*I1 + I1^2)*s^2)*(m*R^2*I1 + I1^2)*s, omega_tau - 1/Theta*(m*R*I1)*V, d(omega_n)/dt, a part of d(d(v_nu)/dt)/d(omega_n) and of d(d(omega_tau)/dt)/d(omega_n), d(d(omega_n)/dt)/d(omega_tau)" },
    .divergence = { divergence, 1, { 2, 7, 1, 1, 1, 0, 7, 5 }, { 5, 18, 0, 1, 1, 0, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = R*omega_tau + v_nu" },
    .integral_values = { integral_values, 4, { 2, 10, 7, 0, 1, 0, 8, 4 }, { 9, 32, 0, 0, 1, 0, 11, 5 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, omega_n*s - omega3*gamma3, F_linear" },
    .integral_gradients = { integral_gradients, 20, { 2, 14, 6, 1, 1, 0, 8, 4 }, { 10, 40, 0, 2, 1, 0, 7, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, d(E)/d(omega3), d(v_tau)/d(gamma3)/R = omega_n - omega3*s*(gamma3/s^2), omega_n*s*(gamma3/s^2) + omega3, d(E)/d(omega_n), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 4, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_equal) },
#endif
};
