/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   18    8    1    0    0      7    7   (49)
 *  jacobian            5   35    9    1    0    0      9    9   (130)
 *  rhs_jacobian        6   41   12    1    0    0     11    9   (168)
 *  divergence          1    4    1    1    0    0      5    4   (15)
 *  integral_values     1   10    6    0    0    0      6    5   (51)
 *  integral_gradients  3   16    3    0    0    0      6    5   (60)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in s*omega_tau*(m*a3^2/I1)*s*omega_tau - omega_n*omega_n,
 *      d(omega_tau)/dtau, a part of d(d(omega_tau)/dtau)/d(s), b = R*gamma3 + a3, d(d(v_nu)/dtau)/d(omega_n),
 *      omega_n*b + s*R*omega3, e = a3*gamma3 + R, V = omega_tau*e + v_nu, omega3 - (a3/R)*omega_n*1/s,
 *      d(d(omega3)/dtau)/d(omega_tau), d(omega3)/dtau, d(d(omega_tau)/dtau)/d(s)
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
extern const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_avx512;

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
    out[15] = t1;
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    out[6] = t2;
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[3]*t3; /* a3*m*g */
    out[19] = t4;
    const double t5 = t4/params[4]; /* a3*m*g/I1 */
    out[7] = t5;
    const double t6 = 1.0/params[1]; /* 1/R */
    out[8] = t6;
    const double t7 = params[1]*2.0; /* R*2 */
    out[9] = t7;
    const double t8 = params[3]/params[1]; /* a3/R */
    out[10] = t8;
    const double t9 = params[0]*2.0; /* m*2 */
    const double t10 = t0*t9; /* a3*a3*m*2 */
    out[14] = t10;
    const double t11 = t10/params[4]; /* a3*a3*m*2/I1 */
    out[11] = t11;
    const double t12 = params[2]*t9; /* g*m*2 */
    const double t13 = params[3]*t12; /* a3*g*m*2 */
    const double t14 = t13/params[4]; /* a3*g*m*2/I1 */
    out[12] = t14;
    const double t15 = (-1.0)/params[1]; /* (-1)/R */
    out[13] = t15;
    const double t16 = params[4]/2.0; /* I1/2 */
    out[16] = t16;
    const double t17 = params[0]/2.0; /* m/2 */
    out[17] = t17;
    const double t18 = params[4]*params[1]; /* I1*R */
    out[18] = t18;
    const double t19 = params[0]*params[1]; /* m*R */
    out[20] = t19;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t1;
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = t2*t3; /* b*omega_n*omega_n */
    const double t5 = x[5]*p[1]; /* s*R */
    const double t6 = x[3]*x[4]; /* omega_n*omega3 */
    const double t7 = JLT_FMA(t5, t6, t4); /* s*R*omega_n*omega3 + b*omega_n*omega_n */
    out[1] = t7;
    const double t8 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t9 = p[6]*t8; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t10 = t1*t9; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t11 = JLT_FNMA(x[0], t3, t10); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - gamma3*omega_n*omega_n */
    const double t12 = JLT_FNMA(t0, p[7], t11); /* t11 - s*s*m*g*a3/I1 */
    const double t13 = JLT_FMA(t0, p[6], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t14 = x[5]*t13; /* s*D/I1 */
    const double t15 = 1.0/t14; /* 1/(s*D/I1) */
    const double t16 = x[5]*t12; /* s*(t11 - s*s*m*g*a3/I1) */
    const double t17 = t15*t16; /* 1/(s*D/I1)*s*(t11 - s*s*m*g*a3/I1) */
    out[2] = t17;
    const double t18 = x[3]*t8; /* omega_n*omega_tau*gamma3 */
    out[3] = t18;
    const double t19 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t20 = JLT_FMA(x[2], t19, x[1]); /* V = omega_tau*e + v_nu */
    const double t21 = x[3]*p[8]; /* omega_n*1/R */
    const double t22 = t13*t21; /* D/I1*omega_n*1/R */
    const double t23 = t20*t22; /* V*D/I1*omega_n*1/R */
    const double t24 = t15*t23; /* 1/(s*D/I1)*V*D/I1*omega_n*1/R */
    const double t25 = JLT_FMS(x[4], t8, t24); /* omega3*omega_tau*gamma3 - 1/(s*D/I1)*V*D/I1*omega_n*1/R */
    out[4] = t25;
    const double t26 = x[5]*t8; /* s*omega_tau*gamma3 */
    const double t27 = -t26; /* -s*omega_tau*gamma3 */
    out[5] = t27;
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
    out[16] = 0.0;
    out[19] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
    out[31] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    const double t0 = x[5]*x[5]; /* s*s */
    out[2] = t0;
    const double t1 = x[5]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[5] = t2;
    const double t3 = x[3]*p[1]; /* omega_n*R */
    const double t4 = x[3]*t3; /* omega_n*omega_n*R */
    out[6] = t4;
    const double t5 = p[10] + x[0]; /* b/R = a3/R + gamma3 */
    const double t6 = x[3]*p[9]; /* omega_n*2*R */
    const double t7 = t5*t6; /* b/R*omega_n*2*R */
    const double t8 = x[5]*p[1]; /* s*R */
    const double t9 = JLT_FMA(x[4], t8, t7); /* omega3*s*R + b/R*omega_n*2*R */
    out[9] = t9;
    const double t10 = x[5]*t3; /* s*omega_n*R */
    out[10] = t10;
    const double t11 = t3*x[4]; /* omega_n*R*omega3 */
    out[11] = t11;
    const double t12 = t1*p[6]; /* s*omega_tau*m*a3^2/I1 */
    const double t13 = x[3]*x[3]; /* omega_n*omega_n */
    const double t14 = JLT_FMS(t1, t12, t13); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n */
    const double t15 = JLT_FMA(t0, p[6], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t16 = x[5]*t15; /* s*D/I1 */
    const double t17 = 1.0/t16; /* 1/(s*D/I1) */
    const double t18 = x[5]*t17; /* 1/(D/I1) = s*1/(s*D/I1) */
    const double t19 = t14*t18; /* (s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n)*1/(D/I1) */
    out[12] = t19;
    const double t20 = x[5]*x[0]; /* s*gamma3 */
    const double t21 = p[11]*t20; /* 2*m*a3^2/I1*s*gamma3 */
    const double t22 = t18*t21; /* 1/(D/I1)*2*m*a3^2/I1*s*gamma3 */
    const double t23 = t1*t22; /* s*omega_tau*1/(D/I1)*2*m*a3^2/I1*s*gamma3 */
    out[14] = t23;
    const double t24 = x[3]*x[0]; /* omega_n*gamma3 */
    out[20] = t24;
    const double t25 = (-2.0)*t24; /* (-2)*omega_n*gamma3 */
    const double t26 = t18*t25; /* 1/(D/I1)*(-2)*omega_n*gamma3 */
    out[15] = t26;
    const double t27 = JLT_FMA(x[2], x[2], t13); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t28 = t22*t27; /* 1/(D/I1)*2*m*a3^2/I1*s*gamma3*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t29 = x[5]*p[12]; /* s*2*m*g*a3/I1 */
    const double t30 = JLT_FNMA(t18, t29, t28); /* t28 - 1/(D/I1)*s*2*m*g*a3/I1 */
    const double t31 = t18*t30; /* 1/(D/I1)*(t28 - 1/(D/I1)*s*2*m*g*a3/I1) */
    out[17] = t31;
    const double t32 = x[2]*x[3]; /* omega_tau*omega_n */
    out[18] = t32;
    const double t33 = x[2]*x[0]; /* omega_tau*gamma3 */
    out[21] = t33;
    out[28] = t33;
    const double t34 = t15*t17; /* 1/s = D/I1*1/(s*D/I1) */
    const double t35 = x[3]*t34; /* omega_n*1/s */
    const double t36 = JLT_FNMA(p[10], t35, x[4]); /* omega3 - a3/R*omega_n*1/s */
    const double t37 = x[2]*t36; /* omega_tau*(omega3 - a3/R*omega_n*1/s) */
    out[24] = t37;
    const double t38 = t35*p[8]; /* omega_n*1/s*1/R */
    const double t39 = -t38; /* -omega_n*1/s*1/R */
    out[25] = t39;
    const double t40 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t41 = t38*t40; /* omega_n*1/s*1/R*e */
    const double t42 = JLT_FMS(x[0], x[4], t41); /* gamma3*omega3 - omega_n*1/s*1/R*e */
    out[26] = t42;
    const double t43 = JLT_FMA(x[2], t40, x[1]); /* V = omega_tau*e + v_nu */
    const double t44 = t34*t43; /* 1/s*V */
    const double t45 = p[13]*t44; /* (-1/R)*1/s*V */
    out[27] = t45;
    const double t46 = t38*t44; /* omega_n*1/s*1/R*1/s*V */
    out[29] = t46;
    const double t47 = -t1; /* -s*omega_tau */
    out[30] = t47;
    const double t48 = -t20; /* -s*gamma3 */
    out[32] = t48;
    const double t49 = -t33; /* -omega_tau*gamma3 */
    out[35] = t49;
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
    out[22] = 0.0;
    out[25] = 0.0;
    out[28] = 0.0;
    out[29] = 0.0;
    out[37] = 0.0;
    out[39] = 0.0;
    out[40] = 0.0;
    const double t0 = x[2]*x[3]; /* omega_tau*omega_n */
    out[24] = t0;
    const double t1 = x[5]*x[5]; /* s*s */
    out[8] = t1;
    const double t2 = JLT_FMA(p[6], t1, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t3 = p[7]*t1; /* m*g*a3/I1*s*s */
    const double t4 = x[5]*t2; /* s*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s*D/I1) */
    const double t6 = t2*t5; /* 1/s = D/I1*1/(s*D/I1) */
    const double t7 = x[5]*t5; /* 1/(D/I1) = s*1/(s*D/I1) */
    const double t8 = x[5]*x[2]; /* s*omega_tau */
    const double t9 = x[5]*t8; /* s*s*omega_tau */
    out[0] = t9;
    const double t10 = 2.0*t8; /* 2*s*omega_tau */
    out[11] = t10;
    const double t11 = -t8; /* -s*omega_tau */
    out[36] = t11;
    const double t12 = p[6]*t8; /* m*a3^2/I1*s*omega_tau */
    const double t13 = x[3]*x[3]; /* omega_n*omega_n */
    const double t14 = JLT_FMS(t8, t12, t13); /* s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n */
    const double t15 = p[1]*t13; /* R*omega_n*omega_n */
    out[12] = t15;
    const double t16 = t7*t14; /* 1/(D/I1)*(s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n) */
    out[18] = t16;
    const double t17 = x[0]*t16; /* gamma3*t16 */
    const double t18 = JLT_FNMA(t3, t7, t17); /* gamma3*t16 - m*g*a3/I1*s*s*1/(D/I1) */
    out[2] = t18;
    const double t19 = JLT_FMA(p[11], t18, p[12]); /* 2*m*a3^2/I1*(gamma3*t16 - m*g*a3/I1*s*s*1/(D/I1)) + 2*m*g*a3/I1 */
    const double t20 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t21 = x[3]*t20; /* omega_n*b */
    const double t22 = p[1]*x[4]; /* R*omega3 */
    const double t23 = x[3]*t22; /* omega_n*R*omega3 */
    out[17] = t23;
    const double t24 = x[5]*t22; /* s*R*omega3 */
    const double t25 = JLT_FMA(2.0, t21, t24); /* 2*omega_n*b + s*R*omega3 */
    out[15] = t25;
    const double t26 = t21 + t24; /* omega_n*b + s*R*omega3 */
    const double t27 = x[3]*t26; /* omega_n*(omega_n*b + s*R*omega3) */
    out[1] = t27;
    const double t28 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t29 = x[3]*t6; /* omega_n*1/s */
    const double t30 = JLT_FMA(x[2], t28, x[1]); /* V = omega_tau*e + v_nu */
    const double t31 = t6*t30; /* 1/s*V */
    const double t32 = p[13]*t31; /* (-1/R)*1/s*V */
    out[33] = t32;
    const double t33 = p[8]*t29; /* 1/R*omega_n*1/s */
    const double t34 = t31*t33; /* 1/s*V*1/R*omega_n*1/s */
    out[35] = t34;
    const double t35 = t30*t33; /* V*1/R*omega_n*1/s */
    const double t36 = JLT_FNMA(p[10], t29, x[4]); /* omega3 - a3/R*omega_n*1/s */
    const double t37 = x[2]*t36; /* omega_tau*(omega3 - a3/R*omega_n*1/s) */
    out[30] = t37;
    const double t38 = t28*t33; /* e*1/R*omega_n*1/s */
    const double t39 = -t33; /* -1/R*omega_n*1/s */
    out[31] = t39;
    const double t40 = JLT_FMS(x[0], x[4], t38); /* gamma3*omega3 - e*1/R*omega_n*1/s */
    out[32] = t40;
    const double t41 = p[11]*t8; /* 2*m*a3^2/I1*s*omega_tau */
    const double t42 = x[0]*t8; /* gamma3*s*omega_tau */
    const double t43 = -t42; /* -gamma3*s*omega_tau */
    out[5] = t43;
    const double t44 = t7*t41; /* 1/(D/I1)*2*m*a3^2/I1*s*omega_tau */
    const double t45 = x[3]*x[0]; /* omega_n*gamma3 */
    out[26] = t45;
    const double t46 = (-2.0)*t45; /* (-2)*omega_n*gamma3 */
    const double t47 = t7*t46; /* 1/(D/I1)*(-2)*omega_n*gamma3 */
    out[21] = t47;
    const double t48 = x[5]*t7; /* s*1/(D/I1) */
    const double t49 = t19*t48; /* t19*s*1/(D/I1) */
    const double t50 = x[2]*x[0]; /* omega_tau*gamma3 */
    out[27] = t50;
    out[34] = t50;
    const double t51 = JLT_FMS(x[4], t50, t35); /* omega3*omega_tau*gamma3 - V*1/R*omega_n*1/s */
    out[4] = t51;
    const double t52 = JLT_FMS(t44, t50, t49); /* 1/(D/I1)*2*m*a3^2/I1*s*omega_tau*omega_tau*gamma3 - t19*s*1/(D/I1) */
    out[23] = t52;
    const double t53 = x[3]*t50; /* omega_n*omega_tau*gamma3 */
    out[3] = t53;
    const double t54 = -t50; /* -omega_tau*gamma3 */
    out[41] = t54;
    const double t55 = x[5]*p[1]; /* s*R */
    const double t56 = x[3]*t55; /* omega_n*s*R */
    out[16] = t56;
    const double t57 = x[5]*x[0]; /* s*gamma3 */
    const double t58 = t44*t57; /* 1/(D/I1)*2*m*a3^2/I1*s*omega_tau*s*gamma3 */
    out[20] = t58;
    const double t59 = -t57; /* -s*gamma3 */
    out[38] = t59;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[5]*x[5]; /* s*s */
    const double t2 = JLT_FMA(p[15], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t3 = p[14]*t1; /* 2*m*a3^2*s*s */
    const double t4 = t0*t3; /* gamma3*omega_tau*2*m*a3^2*s*s */
    const double t5 = t4/t2; /* gamma3*omega_tau*2*m*a3^2*s*s/D */
    const double t6 = t0 + t5; /* gamma3*omega_tau + gamma3*omega_tau*2*m*a3^2*s*s/D */
    out[0] = t6;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[12]*x[0]; /* 2*m*g*a3/I1*gamma3 */
    const double t1 = p[6]*x[5]; /* m*a3^2/I1*s */
    const double t2 = JLT_FMA(x[5], t1, 1.0); /* D/I1 = s*m*a3^2/I1*s + 1 */
    const double t3 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t4 = JLT_FMA(x[3], x[3], t0); /* omega_n*omega_n + 2*m*g*a3/I1*gamma3 */
    const double t5 = JLT_FMA(t2, t3, t4); /* D/I1*omega_tau*omega_tau + omega_n*omega_n + 2*m*g*a3/I1*gamma3 */
    const double t6 = p[16]*t5; /* 1/2*I1*t5 */
    out[3] = t6;
    const double t7 = x[1]*x[1]; /* v_nu*v_nu */
    const double t8 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t9 = x[3]*t8; /* omega_n*b */
    const double t10 = x[5]*p[1]; /* s*R */
    const double t11 = JLT_FMA(x[4], t10, t9); /* v_tau = omega3*s*R + omega_n*b */
    const double t12 = JLT_FMA(t11, t11, t7); /* v_tau*v_tau + v_nu*v_nu */
    const double t13 = p[17]*t12; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[2] = t13;
    const double t14 = t6 + t13; /* energy = 1/2*I1*t5 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[0] = t14;
    const double t15 = x[5]*p[18]; /* s*R*I1 */
    const double t16 = x[3]*t15; /* omega_n*s*R*I1 */
    out[1] = t16;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[18] = p[19];
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[10] = 0.0;
    out[14] = 0.0;
    out[19] = 0.0;
    out[22] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    out[13] = t0;
    const double t1 = x[5]*p[18]; /* s*R*I1 */
    out[9] = t1;
    const double t2 = x[3]*p[18]; /* omega_n*R*I1 */
    out[11] = t2;
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = x[3]*t3; /* omega_n*b */
    const double t5 = p[0]*t3; /* m*b */
    const double t6 = p[1]*x[4]; /* R*omega3 */
    const double t7 = JLT_FMA(x[5], t6, t4); /* v_tau = s*R*omega3 + omega_n*b */
    const double t8 = t5*t7; /* m*b*v_tau */
    out[15] = t8;
    const double t9 = p[20]*t7; /* m*R*v_tau */
    const double t10 = x[5]*t9; /* s*m*R*v_tau */
    out[4] = t10;
    out[16] = t10;
    const double t11 = x[5]*p[15]; /* s*m*a3^2 */
    const double t12 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t13 = t11*t12; /* s*m*a3^2*omega_tau*omega_tau */
    out[23] = t13;
    const double t14 = JLT_FMA(x[5], t11, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t15 = x[2]*t14; /* omega_tau*D */
    out[2] = t15;
    out[20] = t15;
    const double t16 = x[3]*t9; /* omega_n*m*R*v_tau */
    out[12] = t16;
    const double t17 = p[19] + t16; /* d(energy)/d(gamma3) = m*g*a3 + omega_n*m*R*v_tau */
    out[0] = t17;
    const double t18 = x[4]*t9; /* omega3*m*R*v_tau */
    out[17] = t18;
    const double t19 = t13 + t18; /* d(energy)/d(s) = s*m*a3^2*omega_tau*omega_tau + omega3*m*R*v_tau */
    out[5] = t19;
    const double t20 = x[3]*p[4]; /* omega_n*I1 */
    out[21] = t20;
    const double t21 = t8 + t20; /* d(energy)/d(omega_n) = m*b*v_tau + omega_n*I1 */
    out[3] = t21;
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
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = 0;
    for (unsigned k = 0; k < order; k++) {
        t12[k] = jlt_jet_product(x5, x5, k);
        t13[k] = jlt_jet_product(x2, x0, k);
        t14[k] = jlt_jet_product(x3, t13, k);
        t15[k] = jlt_jet_product(x2, t12, k);
        t16[k] = p[6]*t13[k];
        t17[k] = jlt_jet_product(t15, t16, k);
        t18[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t19[k] = jlt_jet_product(x2, t18, k) + x1[k];
        t20[k] = jlt_jet_product(x3, x3, k);
        t21[k] = t17[k] - jlt_jet_product(x0, t20, k);
        t22[k] = t21[k] - p[7]*t12[k];
        t23[k] = p[6]*t12[k] + (k == 0 ? 1.0 : 0);
        t24[k] = jlt_jet_quotient(t22[k], t23, t24, k);
        t25[k] = x3[k]*p[8];
        t26[k] = jlt_jet_product(t19, t25, k);
        t27[k] = jlt_jet_quotient(t26[k], x5, t27, k);
        t28[k] = jlt_jet_product(x4, t13, k) - t27[k];
        t29[k] = jlt_jet_product(x5, t13, k);
        t30[k] = -t29[k];
        t31[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t32[k] = jlt_jet_product(t20, t31, k);
        t33[k] = x5[k]*p[1];
        t34[k] = jlt_jet_product(x3, x4, k);
        t35[k] = jlt_jet_product(t33, t34, k) + t32[k];
        double *restrict next = coefficients + (k + 1)*7;
        next[0] = x0[k + 1] = t15[k]/(k + 1);
        next[1] = x1[k + 1] = t35[k]/(k + 1);
        next[2] = x2[k + 1] = t24[k]/(k + 1);
        next[3] = x3[k + 1] = t14[k]/(k + 1);
        next[4] = x4[k + 1] = t28[k]/(k + 1);
        next[5] = x5[k + 1] = t30[k]/(k + 1);
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
    const double v_a3 = params[3];
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
    const double v_I3 = (0.0);
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
    { "E1", "I3 = 0" },
    { "E2", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .scales = 1,
    .state_count = 6, .param_count = 6, .prepared_count = 21,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 6, { 1, 18, 8, 1, 0, 0, 7, 7 }, { 9, 36, 0, 4, 0, 0, 8, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, d(v_nu)/dtau, a part of d(omega_tau)/dtau, e = a3*gamma3 + R, V = omega_tau*e + v_nu, d(omega3)/dtau" },
    .jacobian = { jacobian, 36, { 5, 35, 9, 1, 0, 0, 9, 9 }, { 17, 99, 0, 14, 0, 0, 11, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, d(d(v_nu)/dtau)/d(omega_n), s*omega_tau*s*omega_tau*(m*a3^2/I1) - omega_n*omega_n, a part of d(d(omega_tau)/dtau)/d(s), omega3 - (a3/R)*omega_n*1/s, e = gamma3*a3 + R, d(d(omega3)/dtau)/d(omega_tau), V = omega_tau*e + v_nu" },
    .rhs_jacobian = { rhs_jacobian, 42, { 6, 41, 12, 1, 0, 0, 11, 9 }, { 22, 128, 0, 18, 0, 0, 11, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in s*omega_tau*(m*a3^2/I1)*s*omega_tau - omega_n*omega_n, d(omega_tau)/dtau, a part of d(d(omega_tau)/dtau)/d(s), b = R*gamma3 + a3, d(d(v_nu)/dtau)/d(omega_n), omega_n*b + s*R*omega3, e = a3*gamma3 + R, V = omega_tau*e + v_nu, omega3 - (a3/R)*omega_n*1/s, d(d(omega3)/dtau)/d(omega_tau), d(omega3)/dtau, d(d(omega_tau)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 1, 4, 1, 1, 0, 0, 5, 4 }, { 2, 12, 0, 1, 0, 0, 8, 4 },
        "" },
    .integral_values = { integral_values, 4, { 1, 10, 6, 0, 0, 0, 6, 5 }, { 10, 41, 0, 0, 0, 0, 9, 5 },
        "digits are lost where terms nearly cancel in D/I1*omega_tau*omega_tau + omega_n*omega_n + (2*m*g*a3/I1)*gamma3, b = gamma3*R + a3, v_tau = omega3*s*R + omega_n*b, E" },
    .integral_gradients = { integral_gradients, 24, { 3, 16, 3, 0, 0, 0, 6, 5 }, { 6, 54, 0, 0, 0, 0, 6, 6 },
        "digits are lost where terms nearly cancel in b = R*gamma3 + a3, v_tau = s*R*omega3 + omega_n*b, d(E)/d(gamma3), d(E)/d(s), d(E)/d(omega_n)" },
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
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_rod_in_regular) },
#endif
};
