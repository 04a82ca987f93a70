/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top_level, SHA-256 5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   14    3    1    1    0     11    6   (42)
 *  jacobian            6   22    6    1    1    0     14    9   (126)
 *  rhs_jacobian        6   25    7    1    1    0     14    9   (160)
 *  divergence          2    4    2    1    1    0      6    4   (18)
 *  integral_values     3    5    4    1    0    0      6    5   (38)
 *  integral_gradients  2    6    3    1    0    0      6    3   (30)
 *  measure_values      2    1    1    1    1    0      4    3   (9)
 *  measure_divergences 2    7    2    1    1    0      9    5   (43)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in omega_tau*s*omega_tau*(m*a3^2) - (G^2/(R^2*I1))*1/s^2*1/s^2*s,
 *      numerator of d(omega_tau)/dt over D, a part of d(d(omega_tau)/dt)/d(gamma3),
 *      d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_chart_spherical_top_level_5[];
extern const char jlt_table_spherical_top_level[];
extern const jlt_claim jlt_claims_spherical_top_level[];
extern const jlt_descriptor *const jlt_family_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_rod;
extern const struct jlt_ball_table jlt_balls_spherical_top_level_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = 0.0;
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
    const double t0 = params[1]*params[3]; /* R*I1 */
    const double t1 = params[6]/t0; /* G/(R*I1) */
    out[7] = t1;
    const double t2 = params[5]*params[5]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    out[8] = t3;
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[3]*t4; /* I1*R*R */
    const double t6 = params[6]*params[6]; /* G*G */
    const double t7 = t6/t5; /* G*G/(I1*R*R) */
    out[9] = t7;
    const double t8 = params[0]*params[2]; /* m*g */
    const double t9 = params[5]*t8; /* a3*m*g */
    out[10] = t9;
    const double t10 = params[6]*2.0; /* G*2 */
    const double t11 = t10/t0; /* G*2/(R*I1) */
    out[11] = t11;
    const double t12 = params[0]*2.0; /* m*2 */
    const double t13 = t2*t12; /* a3*a3*m*2 */
    out[12] = t13;
    const double t14 = t6*3.0; /* G*G*3 */
    const double t15 = t14/t5; /* G*G*3/(I1*R*R) */
    out[13] = t15;
    const double t16 = params[0]/2.0; /* m/2 */
    out[14] = t16;
    const double t17 = t4*2.0; /* R*R*2 */
    const double t18 = params[3]*t17; /* I1*R*R*2 */
    const double t19 = t6/t18; /* G*G/(I1*R*R*2) */
    out[15] = t19;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[8], t2, p[3]); /* D = m*a3^2*s^2 + I1 */
    const double t4 = t2*t3; /* s^2*D */
    const double t5 = 1.0/t4; /* 1/(s^2*D) */
    const double t6 = t3*t5; /* 1/s^2 = D*1/(s^2*D) */
    const double t7 = t2*t5; /* s^2*1/(s^2*D) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    const double t9 = x[2]*t8; /* omega_tau*s */
    out[0] = t9;
    const double t10 = x[2]*p[8]; /* omega_tau*m*a3^2 */
    const double t11 = t9*t10; /* omega_tau*s*omega_tau*m*a3^2 */
    const double t12 = p[9]*t8; /* G^2/(R^2*I1)*s */
    const double t13 = t6*t12; /* 1/s^2*G^2/(R^2*I1)*s */
    const double t14 = JLT_FNMA(t6, t13, t11); /* omega_tau*s*omega_tau*m*a3^2 - 1/s^2*1/s^2*G^2/(R^2*I1)*s */
    const double t15 = p[7]*t6; /* G/(R*I1)*1/s^2 */
    const double t16 = x[0]*t14; /* gamma3*(omega_tau*s*omega_tau*m*a3^2 - 1/s^2*1/s^2*G^2/(R^2*I1)*s) */
    const double t17 = JLT_FNMA(p[10], t8, t16); /* t16 - m*g*a3*s */
    const double t18 = t7*t17; /* s^2*1/(s^2*D)*(t16 - m*g*a3*s) */
    out[2] = t18;
    const double t19 = x[3]*t15; /* v_tau*G/(R*I1)*1/s^2 */
    out[1] = t19;
    const double t20 = x[1]*t15; /* v_nu*G/(R*I1)*1/s^2 */
    const double t21 = -t20; /* -v_nu*G/(R*I1)*1/s^2 */
    out[3] = t21;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[11] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[8], t2, p[3]); /* D = m*a3^2*s^2 + I1 */
    const double t4 = t2*t3; /* s^2*D */
    const double t5 = 1.0/t4; /* 1/(s^2*D) */
    const double t6 = t3*t5; /* 1/s^2 = D*1/(s^2*D) */
    const double t7 = t2*t5; /* 1/D = s^2*1/(s^2*D) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t8;
    const double t9 = x[0]*p[12]; /* gamma3*2*m*a3^2 */
    const double t10 = t7*t9; /* 1/D*gamma3*2*m*a3^2 */
    const double t11 = x[0]*t6; /* gamma3*1/s^2 */
    const double t12 = t8*t11; /* s*gamma3*1/s^2 */
    const double t13 = t8*t10; /* s*1/D*gamma3*2*m*a3^2 */
    const double t14 = JLT_FMA(3.0, t11, t10); /* 3*gamma3*1/s^2 + 1/D*gamma3*2*m*a3^2 */
    const double t15 = JLT_FMA(t11, t14, t6); /* gamma3*1/s^2*(3*gamma3*1/s^2 + 1/D*gamma3*2*m*a3^2) + 1/s^2 */
    const double t16 = x[2]*t13; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[10] = t16;
    const double t17 = t13 - t12; /* s*1/D*gamma3*2*m*a3^2 - s*gamma3*1/s^2 */
    const double t18 = x[2]*t12; /* omega_tau*s*gamma3*1/s^2 */
    const double t19 = -t18; /* -omega_tau*s*gamma3*1/s^2 */
    out[0] = t19;
    const double t20 = x[2]*p[8]; /* omega_tau*m*a3^2 */
    const double t21 = x[2]*t20; /* omega_tau*omega_tau*m*a3^2 */
    const double t22 = JLT_FMA(x[0], t17, t8); /* gamma3*(s*1/D*gamma3*2*m*a3^2 - s*gamma3*1/s^2) + s */
    const double t23 = t21*t22; /* omega_tau*omega_tau*m*a3^2*(gamma3*(s*1/D*gamma3*2*m*a3^2 - s*gamma3*1/s^2) + s) */
    const double t24 = JLT_FNMA(p[10], t17, t23); /* t23 - m*g*a3*(s*1/D*gamma3*2*m*a3^2 - s*gamma3*1/s^2) */
    const double t25 = p[9]*t8; /* G^2/(R^2*I1)*s */
    const double t26 = t6*t25; /* 1/s^2*G^2/(R^2*I1)*s */
    const double t27 = JLT_FNMA(t15, t26, t24); /* t23 - m*g*a3*(s*1/D*gamma3*2*m*a3^2 - s*gamma3*1/s^2) - (gamma3*1/s^2*(3*gamma3*1/s^2 + 1/D*gamma3*2*m*a3^2) + 1/s^2)*1/s^2*G^2/(R^2*I1)*s */
    const double t28 = t7*t27; /* 1/D*t27 */
    out[8] = t28;
    const double t29 = p[11]*t6; /* 2*G/(R*I1)*1/s^2 */
    const double t30 = t11*t29; /* gamma3*1/s^2*2*G/(R*I1)*1/s^2 */
    const double t31 = p[7]*t6; /* G/(R*I1)*1/s^2 */
    out[7] = t31;
    const double t32 = -t31; /* -G/(R*I1)*1/s^2 */
    out[13] = t32;
    const double t33 = x[3]*t30; /* v_tau*gamma3*1/s^2*2*G/(R*I1)*1/s^2 */
    out[4] = t33;
    const double t34 = x[1]*t30; /* v_nu*gamma3*1/s^2*2*G/(R*I1)*1/s^2 */
    const double t35 = -t34; /* -v_nu*gamma3*1/s^2*2*G/(R*I1)*1/s^2 */
    out[12] = t35;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[15] = 0.0;
    out[18] = 0.0;
    out[19] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[8], t2, p[3]); /* D = m*a3^2*s^2 + I1 */
    const double t4 = t2*t3; /* s^2*D */
    const double t5 = 1.0/t4; /* 1/(s^2*D) */
    const double t6 = t3*t5; /* 1/s^2 = D*1/(s^2*D) */
    const double t7 = t2*t5; /* 1/D = s^2*1/(s^2*D) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t8;
    const double t9 = x[2]*t8; /* omega_tau*s */
    out[0] = t9;
    const double t10 = x[2]*p[8]; /* omega_tau*m*a3^2 */
    const double t11 = t6*t8; /* 1/s^2*s */
    const double t12 = t9*t10; /* omega_tau*s*omega_tau*m*a3^2 */
    const double t13 = t6*t11; /* 1/s^2*1/s^2*s */
    const double t14 = JLT_FNMA(p[9], t13, t12); /* omega_tau*s*omega_tau*m*a3^2 - G^2/(R^2*I1)*1/s^2*1/s^2*s */
    const double t15 = x[0]*t11; /* gamma3*1/s^2*s */
    const double t16 = t13*t15; /* 1/s^2*1/s^2*s*gamma3*1/s^2*s */
    const double t17 = p[7]*t6; /* G/(R*I1)*1/s^2 */
    out[11] = t17;
    const double t18 = x[3]*t17; /* v_tau*G/(R*I1)*1/s^2 */
    out[1] = t18;
    const double t19 = -t17; /* -G/(R*I1)*1/s^2 */
    out[17] = t19;
    const double t20 = x[1]*t17; /* v_nu*G/(R*I1)*1/s^2 */
    const double t21 = -t20; /* -v_nu*G/(R*I1)*1/s^2 */
    out[3] = t21;
    const double t22 = x[0]*t14; /* gamma3*(omega_tau*s*omega_tau*m*a3^2 - G^2/(R^2*I1)*1/s^2*1/s^2*s) */
    const double t23 = JLT_FNMA(p[10], t8, t22); /* numerator of d(omega_tau)/dt over D = t22 - m*g*a3*s */
    const double t24 = t7*t23; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t24;
    const double t25 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t26 = JLT_FNMA(t10, t25, p[10]); /* m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t27 = JLT_FNMA(p[13], t16, t26); /* m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3 - 3*G^2/(R^2*I1)*1/s^2*1/s^2*s*gamma3*1/s^2*s */
    const double t28 = JLT_FMA(t15, t27, t14); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = gamma3*1/s^2*s*t27 + omega_tau*s*omega_tau*m*a3^2 - G^2/(R^2*I1)*1/s^2*1/s^2*s */
    const double t29 = p[11]*t16; /* 2*G/(R*I1)*1/s^2*1/s^2*s*gamma3*1/s^2*s */
    const double t30 = x[2]*t15; /* omega_tau*gamma3*1/s^2*s */
    const double t31 = -t30; /* -omega_tau*gamma3*1/s^2*s */
    out[4] = t31;
    const double t32 = x[3]*t29; /* v_tau*2*G/(R*I1)*1/s^2*1/s^2*s*gamma3*1/s^2*s */
    out[8] = t32;
    const double t33 = x[1]*t29; /* v_nu*2*G/(R*I1)*1/s^2*1/s^2*s*gamma3*1/s^2*s */
    const double t34 = -t33; /* -v_nu*2*G/(R*I1)*1/s^2*1/s^2*s*gamma3*1/s^2*s */
    out[16] = t34;
    const double t35 = x[0]*p[12]; /* gamma3*2*m*a3^2 */
    const double t36 = t7*t35; /* 1/D*gamma3*2*m*a3^2 */
    const double t37 = t9*t36; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[14] = t37;
    const double t38 = t24*t36; /* 1/D*numerator of d(omega_tau)/dt over D*1/D*gamma3*2*m*a3^2 */
    const double t39 = JLT_FMA(t7, t28, t38); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) + 1/D*numerator of d(omega_tau)/dt over D*1/D*gamma3*2*m*a3^2 */
    out[12] = t39;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[8], p[3]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*D */
    const double t6 = JLT_FMS(t2, p[12], t4); /* (1 - gamma3)*(gamma3 + 1)*2*m*a3^2 - D */
    const double t7 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t8 = t6*t7; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 - D)*gamma3*omega_tau */
    const double t9 = t8/t5; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 - D)*gamma3*omega_tau/(s*D) */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = JLT_FMA(x[3], x[3], t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t2 = p[14]*t1; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[1] = t2;
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = x[0] + 1.0; /* gamma3 + 1 */
    const double t5 = t3*t4; /* (1 - gamma3)*(gamma3 + 1) */
    const double t6 = JLT_FMA(p[8], t5, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t7 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t8 = x[2]*t7; /* omega_tau*1/2*omega_tau */
    const double t9 = p[15]/t5; /* 1/2*G^2/(R^2*I1)/((1 - gamma3)*(gamma3 + 1)) */
    const double t10 = JLT_FMA(p[10], x[0], t2); /* m*g*a3*gamma3 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t11 = JLT_FMA(t6, t8, t10); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t12 = t9 + t11; /* 1/2*G^2/(R^2*I1)/((1 - gamma3)*(gamma3 + 1)) + t11 */
    out[0] = t12;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[4] = 0.0;
    out[6] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    out[5] = t0;
    const double t1 = p[0]*x[3]; /* m*v_tau */
    out[3] = t1;
    out[7] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = t4*t4; /* (1 - gamma3)*(gamma3 + 1)*(1 - gamma3)*(gamma3 + 1) */
    const double t6 = p[9]/t5; /* G^2/(R^2*I1)/((1 - gamma3)*(gamma3 + 1)*(1 - gamma3)*(gamma3 + 1)) */
    const double t7 = JLT_FMA(p[8], t4, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t8 = x[2]*t7; /* omega_tau*D */
    out[2] = t8;
    const double t9 = p[8]*x[2]; /* m*a3^2*omega_tau */
    const double t10 = JLT_FMS(x[2], t9, t6); /* omega_tau*m*a3^2*omega_tau - t6 */
    const double t11 = JLT_FNMA(x[0], t10, p[10]); /* m*g*a3 - gamma3*(omega_tau*m*a3^2*omega_tau - t6) */
    out[0] = t11;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(t2, p[8], p[3]); /* (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t5 = t4/t3; /* ((1 - gamma3)*(1 + gamma3)*m*a3^2 + I1)/s */
    out[0] = t5;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[8], p[3]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*D */
    const double t6 = t4/t5; /* 1/s = D/(s*D) */
    const double t7 = t4*t6; /* D*1/s */
    const double t8 = t6*t7; /* 1/s*D*1/s */
    const double t9 = JLT_FMS(t3, t8, t7); /* s*1/s*D*1/s - D*1/s */
    const double t10 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t11 = t6*t10; /* 1/s*omega_tau*gamma3 */
    const double t12 = t9*t11; /* (s*1/s*D*1/s - D*1/s)*1/s*omega_tau*gamma3 */
    out[0] = t12;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
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
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t10[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t11[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t12[k] = jlt_jet_product(t10, t11, k);
        t13[k] = jlt_jet_root(t12[k], t13, k);
        t14[k] = p[8]*t12[k] + (k == 0 ? p[3] : 0);
        t15[k] = jlt_jet_product(x2, t13, k);
        t16[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t13, t16, k);
        t17[k] = x2[k]*p[8];
        t18[k] = jlt_jet_product(t15, t17, k);
        t19[k] = jlt_jet_product(t16, t16, k);
        t20[k] = p[9]*t16[k];
        t21[k] = t18[k] - jlt_jet_product(t19, t20, k);
        t22[k] = jlt_jet_product(x0, t21, k);
        t23[k] = t22[k] - p[10]*t13[k];
        t24[k] = jlt_jet_quotient(t23[k], t14, t24, k);
        t25[k] = p[7]*t19[k];
        t26[k] = jlt_jet_product(x3, t25, k);
        t27[k] = jlt_jet_product(x1, t25, k);
        t28[k] = -t27[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t15[k]/(k + 1);
        next[1] = x1[k + 1] = t26[k]/(k + 1);
        next[2] = x2[k + 1] = t24[k]/(k + 1);
        next[3] = x3[k + 1] = t28[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double complex v_v_tau = x[3];
    const double v_R = params[1];
    const double v_I1 = params[3];
    const double v_I3 = (0.0);
    const double v_a3 = params[5];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_K = (v_R*v_R*v_I1*v_s*v_s + v_I3*v_b*v_b);
    const double v_G = params[6];
    const double complex v_omega_n = ((v_R*v_G*v_s + v_I3*v_v_tau*v_b)/v_K);
    out[1] = (v_v_tau*v_omega_n/v_s);
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double complex v_omega3 = ((v_R*v_I1*v_v_tau*v_s - v_G*v_b)/v_K);
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_v_nu = x[1];
    const double complex v_Theta = (v_m*v_K + v_I1*v_I3);
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (-v_v_nu*v_omega_n/v_s)
        + (v_I1*v_I3*v_V*v_omega_n/(v_s*v_Theta))
        + (-v_I3*v_omega_tau*v_omega3*(v_R*v_gamma3*(v_I1 - v_I3) - v_I3*v_a3)/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0), 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "E1", "I3 = 0" },
};

static const jlt_named measures[] = {
    { "density", "I3 = 0" },
};

static const signed char signs_4[] = { 1, -1, -1, 1 };
static const jlt_reversor reversors[] = {
    { signs_4, 4 },
};

const jlt_descriptor jlt_kernels_spherical_top_level_rod = {
    .model = "spherical_top_level",
    .variant = "rod",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .scales = 1,
    .state_count = 4, .param_count = 7, .prepared_count = 16,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 14, 3, 1, 1, 0, 11, 6 }, { 5, 31, 0, 5, 1, 0, 9, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega_tau*s*omega_tau*(m*a3^2) - 1/s^2*1/s^2*(G^2/(R^2*I1))*s, a part of d(omega_tau)/dt" },
    .jacobian = { jacobian, 16, { 6, 22, 6, 1, 1, 0, 14, 9 }, { 11, 100, 0, 14, 1, 0, 15, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in s*1/D*gamma3*(2*m*a3^2) - s*gamma3*1/s^2, gamma3*(s*1/D*gamma3*(2*m*a3^2) - s*gamma3*1/s^2) + s, a part of d(d(omega_tau)/dt)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 6, 25, 7, 1, 1, 0, 14, 9 }, { 14, 126, 0, 19, 1, 0, 15, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega_tau*s*omega_tau*(m*a3^2) - (G^2/(R^2*I1))*1/s^2*1/s^2*s, numerator of d(omega_tau)/dt over D, a part of d(d(omega_tau)/dt)/d(gamma3), d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 2, 4, 2, 1, 1, 0, 6, 4 }, { 3, 12, 0, 2, 1, 0, 9, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in (1 - gamma3)*(gamma3 + 1)*(2*m*a3^2) - D" },
    .integral_values = { integral_values, 2, { 3, 5, 4, 1, 0, 0, 6, 5 }, { 7, 29, 0, 1, 1, 0, 11, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in E" },
    .integral_gradients = { integral_gradients, 8, { 2, 6, 3, 1, 0, 0, 6, 3 }, { 4, 24, 0, 1, 1, 0, 8, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of d(E)/d(gamma3), d(E)/d(gamma3)" },
    .measure_values = { measure_values, 1, { 2, 1, 1, 1, 1, 0, 4, 3 }, { 2, 5, 0, 1, 1, 0, 7, 4 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .measure_divergences = { measure_divergences, 1, { 2, 7, 2, 1, 1, 0, 9, 5 }, { 7, 30, 0, 5, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in s*1/s*D*1/s - D*1/s" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 2, .measure_count = 1, .equilibria_count = 0,
    .integrals = integrals,
    .measures = measures,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_level_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_level_rod) },
#endif
};
