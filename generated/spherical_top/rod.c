/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top, SHA-256 1b6d453374f697d58e1412b96ff746b2599a2a450f7166c0e5909287ba92fdcb
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   18    8    1    1    0     10    8   (50)
 *  jacobian            5   35   13    1    1    0     14   12   (170)
 *  rhs_jacobian        6   40   15    1    1    0     16   14   (206)
 *  divergence          2    4    2    1    1    0      6    4   (18)
 *  integral_values     3   10    6    0    1    0      7    6   (54)
 *  integral_gradients  4   17    5    1    1    0      7    6   (64)
 *  measure_values      2    2    1    0    1    0      4    3   (9)
 *  measure_divergences 0    0    0    0    0    0      0    0   (41)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in m*g*a3/I1 - omega_tau*gamma3*omega_tau*(m*a3^2/I1),
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      e = gamma3*a3 + R, b = gamma3*R + a3, V = omega_tau*e + v_nu, a part of d(d(omega_tau)/dt)/d(gamma3),
 *      d(d(omega_tau)/dt)/d(gamma3), 1/s^2*omega3*1/s^2*s - (a3/R)*1/s^2*s*omega_n*1/s^2*s, d(d(v_nu)/dt)/d(omega_n),
 *      omega_n*1/s^2*s*b + R*omega3, d(d(omega3)/dt)/d(omega_tau), d(d(omega3)/dt)/d(gamma3), d(omega3)/dt,
 *      d(d(v_nu)/dt)/d(gamma3)
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
extern const jlt_descriptor jlt_kernels_spherical_top_rod;
extern const struct jlt_ball_table jlt_balls_spherical_top_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[3]*params[3]; /* a3*a3 */
    const double t1 = params[0]*t0; /* m*a3*a3 */
    out[14] = t1;
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    out[6] = t2;
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[3]*t3; /* a3*m*g */
    out[20] = t4;
    const double t5 = t4/params[4]; /* a3*m*g/I1 */
    out[7] = t5;
    const double t6 = 1.0/params[1]; /* 1/R */
    out[8] = t6;
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t0*t7; /* a3*a3*m*2 */
    out[15] = t8;
    const double t9 = t8/params[4]; /* a3*a3*m*2/I1 */
    out[9] = t9;
    const double t10 = 2.0/params[1]; /* 2/R */
    out[10] = t10;
    const double t11 = params[3]/2.0; /* a3/2 */
    out[11] = t11;
    const double t12 = (-1.0)/params[1]; /* (-1)/R */
    out[12] = t12;
    const double t13 = params[3]/params[1]; /* a3/R */
    out[13] = t13;
    const double t14 = params[4]/2.0; /* I1/2 */
    out[16] = t14;
    const double t15 = params[2]*t7; /* g*m*2 */
    const double t16 = params[3]*t15; /* a3*g*m*2 */
    const double t17 = t16/params[4]; /* a3*g*m*2/I1 */
    out[17] = t17;
    const double t18 = params[0]/2.0; /* m/2 */
    out[18] = t18;
    const double t19 = params[4]*params[1]; /* I1*R */
    out[19] = t19;
    const double t20 = params[0]*params[1]; /* m*R */
    out[21] = t20;
    const double t21 = -t19; /* -I1*R */
    out[22] = t21;
    const double t22 = params[0]*(-2.0); /* m*(-2) */
    const double t23 = t0*t22; /* a3*a3*m*(-2) */
    out[23] = t23;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t4 = t2*t3; /* s^2*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s^2*D/I1) */
    const double t6 = sqrt(t2); /* s = sqrt(s^2) */
    const double t7 = t3*t6; /* D/I1*s */
    const double t8 = t5*t7; /* 1/(s^2*D/I1)*D/I1*s */
    const double t9 = t2*t5; /* s^2*1/(s^2*D/I1) */
    const double t10 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t11 = x[2]*t6; /* omega_tau*s */
    out[0] = t11;
    const double t12 = p[6]*t10; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t13 = t11*t12; /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t14 = JLT_FNMA(p[7], t6, t13); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s */
    const double t15 = x[4]*t10; /* omega3*omega_tau*gamma3 */
    const double t16 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t17 = JLT_FMA(x[2], t16, x[1]); /* V = omega_tau*e + v_nu */
    const double t18 = p[8]*t17; /* 1/R*V */
    const double t19 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t20 = x[3]*t8; /* omega_n*1/(s^2*D/I1)*D/I1*s */
    const double t21 = JLT_FNMA(t18, t20, t15); /* omega3*omega_tau*gamma3 - 1/R*V*omega_n*1/(s^2*D/I1)*D/I1*s */
    const double t22 = t8*t21; /* 1/(s^2*D/I1)*D/I1*s*(omega3*omega_tau*gamma3 - 1/R*V*omega_n*1/(s^2*D/I1)*D/I1*s) */
    out[4] = t22;
    const double t23 = t19*t20; /* b*omega_n*1/(s^2*D/I1)*D/I1*s */
    const double t24 = x[0]*t20; /* gamma3*omega_n*1/(s^2*D/I1)*D/I1*s */
    const double t25 = JLT_FMA(p[1], x[4], t23); /* R*omega3 + b*omega_n*1/(s^2*D/I1)*D/I1*s */
    const double t26 = x[3]*t25; /* omega_n*(R*omega3 + b*omega_n*1/(s^2*D/I1)*D/I1*s) */
    out[1] = t26;
    const double t27 = JLT_FNMA(x[3], t24, t14); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s - omega_n*gamma3*omega_n*1/(s^2*D/I1)*D/I1*s */
    const double t28 = t9*t27; /* s^2*1/(s^2*D/I1)*t27 */
    out[2] = t28;
    const double t29 = x[2]*t24; /* omega_tau*gamma3*omega_n*1/(s^2*D/I1)*D/I1*s */
    out[3] = t29;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[14] = 0.0;
    out[16] = 0.0;
    out[19] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t4 = t2*t3; /* s^2*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s^2*D/I1) */
    const double t6 = t3*t5; /* 1/s^2 = D/I1*1/(s^2*D/I1) */
    const double t7 = t2*t5; /* 1/(D/I1) = s^2*1/(s^2*D/I1) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t8;
    const double t9 = x[0]*p[9]; /* gamma3*2*m*a3^2/I1 */
    const double t10 = t7*t9; /* 1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t11 = t6*t8; /* 1/s^2*s */
    const double t12 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t13 = x[0]*t11; /* gamma3*1/s^2*s */
    const double t14 = t8*t10; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t15 = x[3]*t10; /* omega_n*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t16 = x[2]*t14; /* omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[12] = t16;
    const double t17 = t14 - t13; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*1/s^2*s */
    const double t18 = JLT_FMA(x[0], t17, t8); /* gamma3*(s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*1/s^2*s) + s */
    const double t19 = p[7]*t17; /* m*g*a3/I1*(s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*1/s^2*s) */
    const double t20 = JLT_FMA(x[2], t12, x[1]); /* V = omega_tau*e + v_nu */
    const double t21 = t6*t20; /* 1/s^2*V */
    const double t22 = x[4]*t6; /* omega3*1/s^2 */
    const double t23 = p[12]*t21; /* (-1/R)*1/s^2*V */
    out[23] = t23;
    const double t24 = x[0]*t21; /* gamma3*1/s^2*V */
    const double t25 = JLT_FMA(x[2], p[11], t24); /* omega_tau*1/2*a3 + gamma3*1/s^2*V */
    const double t26 = p[10]*t25; /* 2/R*(omega_tau*1/2*a3 + gamma3*1/s^2*V) */
    const double t27 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t28 = x[2]*t27; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t29 = JLT_FMS(t18, t28, t19); /* (gamma3*(s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*1/s^2*s) + s)*omega_tau*omega_tau*m*a3^2/I1 - m*g*a3/I1*(s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*1/s^2*s) */
    const double t30 = x[3]*t11; /* omega_n*1/s^2*s */
    const double t31 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t32 = t30*t31; /* omega_n*1/s^2*s*b */
    const double t33 = x[3]*t13; /* omega_n*gamma3*1/s^2*s */
    out[17] = t33;
    const double t34 = JLT_FNMA(t15, t33, t29); /* t29 - omega_n*1/(D/I1)*gamma3*2*m*a3^2/I1*omega_n*gamma3*1/s^2*s */
    const double t35 = t11*t30; /* 1/s^2*s*omega_n*1/s^2*s */
    const double t36 = JLT_FNMA(t30, t35, t34); /* t34 - omega_n*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    const double t37 = t7*t36; /* 1/(D/I1)*(t34 - omega_n*1/s^2*s*1/s^2*s*omega_n*1/s^2*s) */
    out[10] = t37;
    const double t38 = (-2.0)*t7; /* (-2)*1/(D/I1) */
    const double t39 = t33*t38; /* omega_n*gamma3*1/s^2*s*(-2)*1/(D/I1) */
    out[13] = t39;
    const double t40 = x[2]*t11; /* omega_tau*1/s^2*s */
    const double t41 = t26*t35; /* 2/R*(omega_tau*1/2*a3 + gamma3*1/s^2*V)*1/s^2*s*omega_n*1/s^2*s */
    const double t42 = JLT_FMS(t22, t40, t41); /* omega3*1/s^2*omega_tau*1/s^2*s - t41 */
    out[20] = t42;
    const double t43 = t35*t40; /* 1/s^2*s*omega_n*1/s^2*s*omega_tau*1/s^2*s */
    out[15] = t43;
    const double t44 = p[8]*t35; /* 1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t45 = t12*t44; /* e*1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t46 = -t44; /* -1/R*1/s^2*s*omega_n*1/s^2*s */
    out[21] = t46;
    const double t47 = JLT_FMS(x[4], t13, t45); /* omega3*gamma3*1/s^2*s - e*1/R*1/s^2*s*omega_n*1/s^2*s */
    out[22] = t47;
    const double t48 = x[3]*p[1]; /* omega_n*R */
    out[9] = t48;
    const double t49 = JLT_FMA(t13, t32, t48); /* gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R */
    const double t50 = t30*t49; /* omega_n*1/s^2*s*(gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R) */
    out[5] = t50;
    const double t51 = x[2]*t13; /* omega_tau*gamma3*1/s^2*s */
    out[18] = t51;
    out[24] = t51;
    const double t52 = -t51; /* -omega_tau*gamma3*1/s^2*s */
    out[0] = t52;
    const double t53 = p[1]*x[4]; /* R*omega3 */
    const double t54 = JLT_FMA(2.0, t32, t53); /* 2*omega_n*1/s^2*s*b + R*omega3 */
    out[8] = t54;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[19] = 0.0;
    out[21] = 0.0;
    out[24] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t4 = t2*t3; /* s^2*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s^2*D/I1) */
    const double t6 = t3*t5; /* 1/s^2 = D/I1*1/(s^2*D/I1) */
    const double t7 = t2*t5; /* 1/(D/I1) = s^2*1/(s^2*D/I1) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[7] = t8;
    const double t9 = x[2]*t8; /* omega_tau*s */
    out[0] = t9;
    const double t10 = t6*t8; /* 1/s^2*s */
    const double t11 = t7*t8; /* 1/(D/I1)*s */
    const double t12 = x[3]*t10; /* omega_n*1/s^2*s */
    const double t13 = x[0]*t12; /* gamma3*omega_n*1/s^2*s */
    out[22] = t13;
    const double t14 = t7*t13; /* 1/(D/I1)*gamma3*omega_n*1/s^2*s */
    const double t15 = (-2.0)*t14; /* (-2)*1/(D/I1)*gamma3*omega_n*1/s^2*s */
    out[18] = t15;
    const double t16 = x[3]*t14; /* omega_n*1/(D/I1)*gamma3*omega_n*1/s^2*s */
    const double t17 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t18 = t12*t17; /* omega_n*1/s^2*s*omega_tau*gamma3 */
    out[3] = t18;
    const double t19 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t20 = JLT_FNMA(t17, t19, p[7]); /* m*g*a3/I1 - omega_tau*gamma3*omega_tau*m*a3^2/I1 */
    const double t21 = JLT_FMA(t11, t20, t16); /* 1/(D/I1)*s*(m*g*a3/I1 - omega_tau*gamma3*omega_tau*m*a3^2/I1) + omega_n*1/(D/I1)*gamma3*omega_n*1/s^2*s */
    const double t22 = t10*t20; /* 1/s^2*s*(m*g*a3/I1 - omega_tau*gamma3*omega_tau*m*a3^2/I1) */
    const double t23 = JLT_FNMA(p[9], t21, t22); /* 1/s^2*s*(m*g*a3/I1 - omega_tau*gamma3*omega_tau*m*a3^2/I1) - 2*m*a3^2/I1*t21 */
    const double t24 = -t21; /* -t21 */
    out[2] = t24;
    const double t25 = x[2]*t19; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t26 = x[0]*t23; /* gamma3*t23 */
    const double t27 = t11*t25; /* 1/(D/I1)*s*omega_tau*omega_tau*m*a3^2/I1 */
    const double t28 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t29 = x[4]*t10; /* omega3*1/s^2*s */
    const double t30 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t31 = t12*t30; /* omega_n*1/s^2*s*b */
    const double t32 = JLT_FMA(x[2], t28, x[1]); /* V = omega_tau*e + v_nu */
    const double t33 = t10*t12; /* 1/s^2*s*omega_n*1/s^2*s */
    const double t34 = JLT_FNMA(t12, t33, t26); /* gamma3*t23 - omega_n*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    const double t35 = JLT_FMA(t7, t34, t27); /* 1/(D/I1)*(gamma3*t23 - omega_n*1/s^2*s*1/s^2*s*omega_n*1/s^2*s) + 1/(D/I1)*s*omega_tau*omega_tau*m*a3^2/I1 */
    out[15] = t35;
    const double t36 = t6*t29; /* 1/s^2*omega3*1/s^2*s */
    const double t37 = JLT_FNMA(p[13], t33, t36); /* 1/s^2*omega3*1/s^2*s - a3/R*1/s^2*s*omega_n*1/s^2*s */
    const double t38 = t6*t32; /* 1/s^2*V */
    const double t39 = x[2]*t37; /* omega_tau*(1/s^2*omega3*1/s^2*s - a3/R*1/s^2*s*omega_n*1/s^2*s) */
    const double t40 = p[12]*t38; /* (-1/R)*1/s^2*V */
    out[28] = t40;
    const double t41 = p[10]*t38; /* 2/R*1/s^2*V */
    const double t42 = p[1]*x[4]; /* R*omega3 */
    const double t43 = JLT_FMA(2.0, t31, t42); /* 2*omega_n*1/s^2*s*b + R*omega3 */
    out[13] = t43;
    const double t44 = t31 + t42; /* omega_n*1/s^2*s*b + R*omega3 */
    const double t45 = x[3]*t44; /* omega_n*(omega_n*1/s^2*s*b + R*omega3) */
    out[1] = t45;
    const double t46 = p[8]*t33; /* 1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t47 = t32*t46; /* V*1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t48 = t28*t46; /* e*1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t49 = JLT_FMS(x[0], t29, t48); /* gamma3*omega3*1/s^2*s - e*1/R*1/s^2*s*omega_n*1/s^2*s */
    out[27] = t49;
    const double t50 = -t46; /* -1/R*1/s^2*s*omega_n*1/s^2*s */
    out[26] = t50;
    const double t51 = x[0]*t33; /* gamma3*1/s^2*s*omega_n*1/s^2*s */
    const double t52 = JLT_FNMA(t41, t51, t39); /* t39 - 2/R*1/s^2*V*gamma3*1/s^2*s*omega_n*1/s^2*s */
    out[25] = t52;
    const double t53 = t31*t51; /* omega_n*1/s^2*s*b*gamma3*1/s^2*s*omega_n*1/s^2*s */
    const double t54 = t10*t17; /* 1/s^2*s*omega_tau*gamma3 */
    out[23] = t54;
    out[29] = t54;
    const double t55 = JLT_FMS(x[4], t54, t47); /* omega3*1/s^2*s*omega_tau*gamma3 - V*1/R*1/s^2*s*omega_n*1/s^2*s */
    out[4] = t55;
    const double t56 = -t54; /* -1/s^2*s*omega_tau*gamma3 */
    out[5] = t56;
    const double t57 = p[9]*t17; /* 2*m*a3^2/I1*omega_tau*gamma3 */
    const double t58 = t11*t57; /* 1/(D/I1)*s*2*m*a3^2/I1*omega_tau*gamma3 */
    out[17] = t58;
    const double t59 = x[2]*t10; /* omega_tau*1/s^2*s */
    const double t60 = t33*t59; /* 1/s^2*s*omega_n*1/s^2*s*omega_tau*1/s^2*s */
    out[20] = t60;
    const double t61 = x[3]*p[1]; /* omega_n*R */
    out[14] = t61;
    const double t62 = JLT_FMA(t12, t61, t53); /* omega_n*1/s^2*s*omega_n*R + omega_n*1/s^2*s*b*gamma3*1/s^2*s*omega_n*1/s^2*s */
    out[10] = t62;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[14], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*D */
    const double t6 = JLT_FMA(t2, p[15], t4); /* (1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D */
    const double t7 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t8 = t6*t7; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D)*gamma3*omega_tau */
    const double t9 = t8/t5; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D)*gamma3*omega_tau/(s*D) */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[17]*x[0]; /* 2*m*g*a3/I1*gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[6], t3, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(gamma3 + 1) + 1 */
    const double t5 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t6 = JLT_FMA(x[3], x[3], t0); /* omega_n*omega_n + 2*m*g*a3/I1*gamma3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* D/I1*omega_tau*omega_tau + omega_n*omega_n + 2*m*g*a3/I1*gamma3 */
    const double t8 = p[16]*t7; /* 1/2*I1*t7 */
    out[3] = t8;
    const double t9 = x[1]*x[1]; /* v_nu*v_nu */
    const double t10 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t11 = x[3]*t10; /* omega_n*b */
    const double t12 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t13 = p[1]*x[4]; /* R*omega3 */
    const double t14 = JLT_FMA(t12, t13, t11); /* v_tau = s*R*omega3 + omega_n*b */
    const double t15 = JLT_FMA(t14, t14, t9); /* v_tau*v_tau + v_nu*v_nu */
    const double t16 = p[18]*t15; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[2] = t16;
    const double t17 = t8 + t16; /* energy = 1/2*I1*t7 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[0] = t17;
    const double t18 = x[3]*p[19]; /* omega_n*R*I1 */
    const double t19 = t12*t18; /* s*omega_n*R*I1 */
    out[1] = t19;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[19] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    out[11] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = sqrt(t3); /* s = sqrt(s^2) */
    const double t6 = p[19]*t5; /* R*I1*s */
    out[8] = t6;
    const double t7 = x[0]/t3; /* gamma3/s^2 */
    const double t8 = t5*t7; /* s*gamma3/s^2 */
    const double t9 = JLT_FMA(p[14], t3, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t10 = x[2]*t9; /* omega_tau*D */
    out[2] = t10;
    out[17] = t10;
    const double t11 = x[3]*t4; /* omega_n*b */
    const double t12 = p[0]*t4; /* m*b */
    const double t13 = x[4]*p[1]; /* omega3*R */
    const double t14 = JLT_FMA(t5, t13, t11); /* v_tau = s*omega3*R + omega_n*b */
    const double t15 = t12*t14; /* m*b*v_tau */
    out[13] = t15;
    const double t16 = p[21]*t14; /* m*R*v_tau */
    const double t17 = t5*t16; /* s*m*R*v_tau */
    out[4] = t17;
    out[14] = t17;
    const double t18 = p[14]*x[0]; /* m*a3^2*gamma3 */
    const double t19 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t20 = JLT_FNMA(t18, t19, p[20]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    out[15] = t20;
    const double t21 = JLT_FNMA(x[4], t8, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*s*gamma3/s^2 */
    const double t22 = t16*t21; /* m*R*v_tau*d(v_tau)/d(gamma3)/R */
    out[10] = t22;
    const double t23 = t20 + t22; /* d(energy)/d(gamma3) = m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau + m*R*v_tau*d(v_tau)/d(gamma3)/R */
    out[0] = t23;
    const double t24 = x[3]*p[4]; /* omega_n*I1 */
    out[18] = t24;
    const double t25 = t15 + t24; /* d(energy)/d(omega_n) = m*b*v_tau + omega_n*I1 */
    out[3] = t25;
    const double t26 = x[3]*p[22]; /* omega_n*(-R*I1) */
    const double t27 = t8*t26; /* s*gamma3/s^2*omega_n*(-R*I1) */
    out[5] = t27;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(t2, p[14], p[4]); /* (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*((1 - gamma3)*(1 + gamma3)*m*a3^2 + I1) */
    out[0] = t5;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
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
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
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
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t11[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t13[k] = t5[k]*p[6] + (k == 0 ? 1.0 : 0);
        t14[k] = jlt_jet_product(t6, t13, k);
        t15[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t14, t15, k);
        t16[k] = jlt_jet_product(t13, t15, k);
        t17[k] = jlt_jet_product(x3, t16, k);
        t18[k] = jlt_jet_product(t11, t17, k);
        t20[k] = p[1]*x4[k] + t18[k];
        t21[k] = jlt_jet_product(x3, t20, k);
        t22[k] = jlt_jet_product(x2, x0, k);
        t23[k] = p[6]*t22[k];
        t24[k] = jlt_jet_product(t7, t23, k);
        t26[k] = jlt_jet_product(x0, t17, k);
        t27[k] = t24[k] - t6[k]*p[7];
        t28[k] = t27[k] - jlt_jet_product(x3, t26, k);
        t29[k] = jlt_jet_product(t6, t15, k);
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = jlt_jet_product(x2, t26, k);
        t32[k] = jlt_jet_product(x4, t22, k);
        t35[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t36[k] = jlt_jet_product(x2, t35, k) + x1[k];
        t37[k] = p[8]*t36[k];
        t38[k] = t32[k] - jlt_jet_product(t17, t37, k);
        t39[k] = jlt_jet_product(t16, t38, k);
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t21[k]/(k + 1);
        next[2] = x2[k + 1] = t30[k]/(k + 1);
        next[3] = x3[k + 1] = t31[k]/(k + 1);
        next[4] = x4[k + 1] = t39[k]/(k + 1);
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
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega3 = x[4];
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = (0.0);
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

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "G", "" },
    { "E1", "I3 = 0" },
    { "E2", "I3 = 0" },
};

static const jlt_named measures[] = {
    { "rho", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_rod = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "1b6d453374f697d58e1412b96ff746b2599a2a450f7166c0e5909287ba92fdcb",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 6, .block_count = 24,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 18, 8, 1, 1, 0, 10, 8 }, { 9, 33, 0, 7, 1, 0, 9, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in e = gamma3*a3 + R, V = omega_tau*e + v_nu, b = gamma3*R + a3, omega3*omega_tau*gamma3 - (1/R)*V*omega_n*((1)/s^2*D/I1)*D/I1*s, R*omega3 + b*omega_n*((1)/s^2*D/I1)*D/I1*s, a part of d(omega_tau)/dt" },
    .jacobian = { jacobian, 25, { 5, 35, 13, 1, 1, 0, 14, 12 }, { 23, 119, 0, 27, 1, 0, 15, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in e = gamma3*a3 + R, s*1/(D/I1)*gamma3*(2*m*a3^2/I1) - gamma3*1/s^2*s, gamma3*(s*1/(D/I1)*gamma3*(2*m*a3^2/I1) - gamma3*1/s^2*s) + s, V = omega_tau*e + v_nu, omega_tau*(1/2*a3) + gamma3*1/s^2*V, b = gamma3*R + a3, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(omega_tau), gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R, d(d(v_nu)/dt)/d(omega_n)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 6, 40, 15, 1, 1, 0, 16, 14 }, { 27, 144, 0, 34, 1, 0, 15, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in m*g*a3/I1 - omega_tau*gamma3*omega_tau*(m*a3^2/I1), a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), e = gamma3*a3 + R, b = gamma3*R + a3, V = omega_tau*e + v_nu, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), 1/s^2*omega3*1/s^2*s - (a3/R)*1/s^2*s*omega_n*1/s^2*s, d(d(v_nu)/dt)/d(omega_n), omega_n*1/s^2*s*b + R*omega3, d(d(omega3)/dt)/d(omega_tau), d(d(omega3)/dt)/d(gamma3), d(omega3)/dt, d(d(v_nu)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 2, 4, 2, 1, 1, 0, 6, 4 }, { 3, 12, 0, 2, 1, 0, 9, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_values = { integral_values, 4, { 3, 10, 6, 0, 1, 0, 7, 6 }, { 11, 42, 0, 0, 1, 0, 11, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in D/I1*omega_tau*omega_tau + omega_n*omega_n + (2*m*g*a3/I1)*gamma3, b = gamma3*R + a3, v_tau = s*R*omega3 + omega_n*b, E" },
    .integral_gradients = { integral_gradients, 20, { 4, 17, 5, 1, 1, 0, 7, 6 }, { 10, 51, 0, 2, 1, 0, 8, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*omega3*R + omega_n*b, d(E2)/d(gamma3), d(v_tau)/d(gamma3)/R = omega_n - omega3*s*(gamma3/s^2), d(E)/d(gamma3), d(E)/d(omega_n)" },
    .measure_values = { measure_values, 1, { 2, 2, 1, 0, 1, 0, 4, 3 }, { 2, 6, 0, 0, 1, 0, 7, 4 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .measure_divergences = { measure_divergences, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 7, 30, 0, 3, 1, 0, 11, 7 },
        "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 1, .equilibria_count = 0,
    .integrals = integrals,
    .measures = measures,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_rod_baseline,
        &jlt_batch_spherical_top_rod_avx2,
        &jlt_batch_spherical_top_rod_avx512,
    },
#endif
};
