/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   19    8    1    0    0      6    7   (49)
 *  jacobian            4   39   11    1    0    0     10   11   (130)
 *  rhs_jacobian        5   47   14    1    0    0     10   19   (168)
 *  divergence          0    4    2    1    0    0      5    3   (15)
 *  integral_values     1   11    6    0    0    0      6    5   (51)
 *  integral_gradients  3   16    3    0    0    0      6    6   (60)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular;
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
    const double t0 = -params[4]; /* -I1 */
    const double t1 = params[0]*params[2]; /* m*g */
    const double t2 = t1*params[3]; /* m*g*a3 */
    const double t3 = t2/params[4]; /* m*g*a3/I1 */
    const double t4 = params[3]*params[3]; /* a3*a3 */
    const double t5 = params[0]*t4; /* m*a3*a3 */
    const double t6 = t5/params[4]; /* m*a3*a3/I1 */
    const double t7 = 1.0/params[1]; /* 1/R */
    const double t8 = params[0]*2.0; /* m*2 */
    const double t9 = t4*t8; /* a3*a3*m*2 */
    const double t10 = params[4]*(-2.0); /* I1*(-2) */
    const double t11 = params[4]*t9; /* I1*a3*a3*m*2 */
    const double t12 = params[3]/params[1]; /* a3/R */
    const double t13 = (-1.0)/params[1]; /* (-1)/R */
    const double t14 = params[2]*t8; /* g*m*2 */
    const double t15 = params[3]*t14; /* a3*g*m*2 */
    const double t16 = params[4]*2.0; /* I1*2 */
    const double t17 = params[0]/2.0; /* m/2 */
    const double t18 = params[4]*params[1]; /* I1*R */
    const double t19 = params[0]*params[1]; /* m*R */
    out[6] = t0;
    out[7] = t3;
    out[8] = t6;
    out[9] = t5;
    out[10] = t7;
    out[11] = t9;
    out[12] = t10;
    out[13] = t2;
    out[14] = t11;
    out[15] = t12;
    out[16] = t13;
    out[17] = t15;
    out[18] = t16;
    out[19] = t17;
    out[20] = t18;
    out[21] = t19;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = t2*t3; /* b*omega_n*omega_n */
    const double t5 = x[5]*p[1]; /* s*R */
    const double t6 = x[3]*x[4]; /* omega_n*omega3 */
    const double t7 = JLT_FMA(t5, t6, t4); /* s*R*omega_n*omega3 + b*omega_n*omega_n */
    const double t8 = t0*p[7]; /* s*s*m*g*a3/I1 */
    const double t9 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t10 = p[8]*t9; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t11 = JLT_FMA(x[0], t3, t8); /* gamma3*omega_n*omega_n + s*s*m*g*a3/I1 */
    const double t12 = JLT_FNMA(t1, t10, t11); /* gamma3*omega_n*omega_n + s*s*m*g*a3/I1 - omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t13 = JLT_FMA(t0, p[9], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = x[5]*t13; /* s*D */
    const double t15 = 1.0/t14; /* 1/(s*D) */
    const double t16 = x[5]*p[6]; /* s*(-I1) */
    const double t17 = t12*t16; /* t12*s*(-I1) */
    const double t18 = t15*t17; /* 1/(s*D)*t12*s*(-I1) */
    const double t19 = x[3]*t9; /* omega_n*omega_tau*gamma3 */
    const double t20 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t21 = JLT_FMA(x[2], t20, x[1]); /* V = omega_tau*e + v_nu */
    const double t22 = x[3]*p[10]; /* omega_n*1/R */
    const double t23 = t13*t22; /* D*omega_n*1/R */
    const double t24 = t21*t23; /* V*D*omega_n*1/R */
    const double t25 = t15*t24; /* 1/(s*D)*V*D*omega_n*1/R */
    const double t26 = JLT_FMS(x[4], t9, t25); /* omega3*omega_tau*gamma3 - 1/(s*D)*V*D*omega_n*1/R */
    const double t27 = x[5]*t9; /* s*omega_tau*gamma3 */
    const double t28 = -t27; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t7;
    out[2] = t18;
    out[3] = t19;
    out[4] = t26;
    out[5] = t28;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[5]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*p[1]; /* omega_n*R */
    const double t4 = x[3]*t3; /* omega_n*omega_n*R */
    const double t5 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t6 = 2.0*x[3]; /* 2*omega_n */
    const double t7 = t5*t6; /* b*2*omega_n */
    const double t8 = x[5]*p[1]; /* s*R */
    const double t9 = JLT_FMA(x[4], t8, t7); /* omega3*s*R + b*2*omega_n */
    const double t10 = x[5]*t3; /* s*omega_n*R */
    const double t11 = t3*x[4]; /* omega_n*R*omega3 */
    const double t12 = JLT_FMA(t0, p[9], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t13 = x[5]*t12; /* s*D */
    const double t14 = 1.0/t13; /* 1/(s*D) */
    const double t15 = x[5]*t14; /* s*1/(s*D) */
    const double t16 = t1*t15; /* s*omega_tau*s*1/(s*D) */
    const double t17 = p[9]*t16; /* m*a3^2*s*omega_tau*s*1/(s*D) */
    const double t18 = t1*t17; /* s*omega_tau*m*a3^2*s*omega_tau*s*1/(s*D) */
    const double t19 = x[3]*t15; /* omega_n*s*1/(s*D) */
    const double t20 = x[3]*p[4]; /* omega_n*I1 */
    const double t21 = JLT_FNMA(t19, t20, t18); /* s*omega_tau*m*a3^2*s*omega_tau*s*1/(s*D) - omega_n*s*1/(s*D)*omega_n*I1 */
    const double t22 = x[5]*x[0]; /* s*gamma3 */
    const double t23 = p[11]*t22; /* 2*m*a3^2*s*gamma3 */
    const double t24 = t16*t23; /* s*omega_tau*s*1/(s*D)*2*m*a3^2*s*gamma3 */
    const double t25 = x[0]*p[12]; /* gamma3*(-2*I1) */
    const double t26 = t19*t25; /* omega_n*s*1/(s*D)*gamma3*(-2*I1) */
    const double t27 = t0*p[11]; /* s*s*2*m*a3^2 */
    const double t28 = JLT_FNMA(t15, t27, 2.0); /* 2 - s*1/(s*D)*s*s*2*m*a3^2 */
    const double t29 = x[5]*p[13]; /* s*m*g*a3 */
    const double t30 = t15*t29; /* s*1/(s*D)*s*m*g*a3 */
    const double t31 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t32 = JLT_FNMA(t17, t31, t30); /* s*1/(s*D)*s*m*g*a3 - m*a3^2*s*omega_tau*s*1/(s*D)*omega_tau*gamma3 */
    const double t33 = t28*t32; /* (2 - s*1/(s*D)*s*s*2*m*a3^2)*t32 */
    const double t34 = t22*p[14]; /* s*gamma3*2*m*a3^2*I1 */
    const double t35 = t19*t34; /* omega_n*s*1/(s*D)*s*gamma3*2*m*a3^2*I1 */
    const double t36 = JLT_FMS(t19, t35, t33); /* omega_n*s*1/(s*D)*omega_n*s*1/(s*D)*s*gamma3*2*m*a3^2*I1 - (2 - s*1/(s*D)*s*s*2*m*a3^2)*t32 */
    const double t37 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t38 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t39 = t12*t14; /* D*1/(s*D) */
    const double t40 = x[3]*t39; /* omega_n*D*1/(s*D) */
    const double t41 = JLT_FNMA(p[15], t40, x[4]); /* omega3 - a3/R*omega_n*D*1/(s*D) */
    const double t42 = x[2]*t41; /* omega_tau*(omega3 - a3/R*omega_n*D*1/(s*D)) */
    const double t43 = t40*p[10]; /* omega_n*D*1/(s*D)*1/R */
    const double t44 = -t43; /* -omega_n*D*1/(s*D)*1/R */
    const double t45 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t46 = t43*t45; /* omega_n*D*1/(s*D)*1/R*e */
    const double t47 = JLT_FMS(x[0], x[4], t46); /* gamma3*omega3 - omega_n*D*1/(s*D)*1/R*e */
    const double t48 = JLT_FMA(x[2], t45, x[1]); /* V = omega_tau*e + v_nu */
    const double t49 = t39*t48; /* D*1/(s*D)*V */
    const double t50 = p[16]*t49; /* (-1/R)*D*1/(s*D)*V */
    const double t51 = t43*t49; /* omega_n*D*1/(s*D)*1/R*D*1/(s*D)*V */
    const double t52 = -t1; /* -s*omega_tau */
    const double t53 = -t22; /* -s*gamma3 */
    const double t54 = -t31; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t2;
    out[6] = t4;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t9;
    out[10] = t10;
    out[11] = t11;
    out[12] = t21;
    out[13] = 0.0;
    out[14] = t24;
    out[15] = t26;
    out[16] = 0.0;
    out[17] = t36;
    out[18] = t37;
    out[19] = 0.0;
    out[20] = t38;
    out[21] = t31;
    out[22] = 0.0;
    out[23] = 0.0;
    out[24] = t42;
    out[25] = t44;
    out[26] = t47;
    out[27] = t50;
    out[28] = t31;
    out[29] = t51;
    out[30] = t52;
    out[31] = 0.0;
    out[32] = t53;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = t54;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[2]; /* s*omega_tau */
    const double t1 = x[5]*t0; /* s*s*omega_tau */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = t2*t3; /* b*omega_n*omega_n */
    const double t5 = x[5]*p[1]; /* s*R */
    const double t6 = x[3]*x[4]; /* omega_n*omega3 */
    const double t7 = JLT_FMA(t5, t6, t4); /* s*R*omega_n*omega3 + b*omega_n*omega_n */
    const double t8 = x[5]*x[5]; /* s*s */
    const double t9 = JLT_FMA(p[9], t8, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t10 = x[5]*t9; /* s*D */
    const double t11 = 1.0/t10; /* 1/(s*D) */
    const double t12 = x[5]*t11; /* s*1/(s*D) */
    const double t13 = x[0]*t12; /* gamma3*s*1/(s*D) */
    const double t14 = t0*p[8]; /* s*omega_tau*m*a3^2/I1 */
    const double t15 = JLT_FMS(t0, t14, t3); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n */
    const double t16 = p[4]*t15; /* I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t17 = t13*t16; /* gamma3*s*1/(s*D)*I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t18 = x[5]*t12; /* s*s*1/(s*D) */
    const double t19 = x[5]*t18; /* s*s*s*1/(s*D) */
    const double t20 = JLT_FNMA(p[13], t19, t17); /* t17 - m*g*a3*s*s*s*1/(s*D) */
    const double t21 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t22 = x[3]*t21; /* omega_n*omega_tau*gamma3 */
    const double t23 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t24 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t25 = t9*t11; /* D*1/(s*D) */
    const double t26 = x[3]*t25; /* omega_n*D*1/(s*D) */
    const double t27 = p[10]*t26; /* 1/R*omega_n*D*1/(s*D) */
    const double t28 = t24*t27; /* V*1/R*omega_n*D*1/(s*D) */
    const double t29 = JLT_FMS(x[4], t21, t28); /* omega3*omega_tau*gamma3 - V*1/R*omega_n*D*1/(s*D) */
    const double t30 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t31 = -t30; /* -s*omega_tau*gamma3 */
    const double t32 = t0*2.0; /* s*omega_tau*2 */
    const double t33 = p[1]*t3; /* R*omega_n*omega_n */
    const double t34 = x[3]*2.0; /* omega_n*2 */
    const double t35 = t2*t34; /* b*omega_n*2 */
    const double t36 = JLT_FMA(t5, x[4], t35); /* s*R*omega3 + b*omega_n*2 */
    const double t37 = x[3]*t5; /* omega_n*s*R */
    const double t38 = p[1]*t6; /* R*omega_n*omega3 */
    const double t39 = t12*t16; /* s*1/(s*D)*I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t40 = t30*p[11]; /* s*omega_tau*gamma3*2*m*a3^2 */
    const double t41 = t18*t40; /* s*s*1/(s*D)*s*omega_tau*gamma3*2*m*a3^2 */
    const double t42 = x[3]*p[12]; /* omega_n*(-2*I1) */
    const double t43 = t13*t42; /* gamma3*s*1/(s*D)*omega_n*(-2*I1) */
    const double t44 = t0*p[11]; /* s*omega_tau*2*m*a3^2 */
    const double t45 = t21*t44; /* omega_tau*gamma3*s*omega_tau*2*m*a3^2 */
    const double t46 = t12*t45; /* s*1/(s*D)*omega_tau*gamma3*s*omega_tau*2*m*a3^2 */
    const double t47 = t19*p[17]; /* s*s*s*1/(s*D)*2*m*g*a3 */
    const double t48 = t15*p[18]; /* (s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n)*2*I1 */
    const double t49 = JLT_FNMA(t13, t48, t47); /* s*s*s*1/(s*D)*2*m*g*a3 - gamma3*s*1/(s*D)*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n)*2*I1 */
    const double t50 = p[9]*t18; /* m*a3^2*s*s*1/(s*D) */
    const double t51 = JLT_FNMA(t18, p[17], t46); /* s*1/(s*D)*omega_tau*gamma3*s*omega_tau*2*m*a3^2 - s*s*1/(s*D)*2*m*g*a3 */
    const double t52 = JLT_FMA(t49, t50, t51); /* t49*m*a3^2*s*s*1/(s*D) + t51 */
    const double t53 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t54 = x[0]*x[3]; /* gamma3*omega_n */
    const double t55 = JLT_FNMA(t26, p[15], x[4]); /* omega3 - omega_n*D*1/(s*D)*a3/R */
    const double t56 = x[2]*t55; /* omega_tau*(omega3 - omega_n*D*1/(s*D)*a3/R) */
    const double t57 = -t27; /* -1/R*omega_n*D*1/(s*D) */
    const double t58 = t23*t27; /* e*1/R*omega_n*D*1/(s*D) */
    const double t59 = JLT_FMS(x[0], x[4], t58); /* gamma3*omega3 - e*1/R*omega_n*D*1/(s*D) */
    const double t60 = t24*t25; /* V*D*1/(s*D) */
    const double t61 = p[16]*t60; /* (-1/R)*V*D*1/(s*D) */
    const double t62 = t27*t60; /* 1/R*omega_n*D*1/(s*D)*V*D*1/(s*D) */
    const double t63 = -t0; /* -s*omega_tau */
    const double t64 = x[5]*x[0]; /* s*gamma3 */
    const double t65 = -t64; /* -s*gamma3 */
    const double t66 = -t21; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t7;
    out[2] = t20;
    out[3] = t22;
    out[4] = t29;
    out[5] = t31;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t8;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t32;
    out[12] = t33;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t36;
    out[16] = t37;
    out[17] = t38;
    out[18] = t39;
    out[19] = 0.0;
    out[20] = t41;
    out[21] = t43;
    out[22] = 0.0;
    out[23] = t52;
    out[24] = t53;
    out[25] = 0.0;
    out[26] = t54;
    out[27] = t21;
    out[28] = 0.0;
    out[29] = 0.0;
    out[30] = t56;
    out[31] = t57;
    out[32] = t59;
    out[33] = t61;
    out[34] = t21;
    out[35] = t62;
    out[36] = t63;
    out[37] = 0.0;
    out[38] = t65;
    out[39] = 0.0;
    out[40] = 0.0;
    out[41] = t66;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = JLT_FMA(p[9], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t2 = 1.0/t1; /* 1/D */
    const double t3 = p[11]*t0; /* 2*m*a3^2*s*s */
    const double t4 = JLT_FMA(t2, t3, 1.0); /* 1/D*2*m*a3^2*s*s + 1 */
    const double t5 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t6 = t4*t5; /* (1/D*2*m*a3^2*s*s + 1)*gamma3*omega_tau */
    out[0] = t6;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[17]*x[0]; /* 2*m*g*a3*gamma3 */
    const double t1 = p[9]*x[5]; /* m*a3^2*s */
    const double t2 = JLT_FMA(x[5], t1, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t3 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t4 = p[4]*x[3]; /* I1*omega_n */
    const double t5 = JLT_FMA(x[3], t4, t0); /* omega_n*I1*omega_n + 2*m*g*a3*gamma3 */
    const double t6 = JLT_FMA(t2, t3, t5); /* D*omega_tau*omega_tau + omega_n*I1*omega_n + 2*m*g*a3*gamma3 */
    const double t7 = (1.0 / 2.0)*t6; /* 1/2*(D*omega_tau*omega_tau + omega_n*I1*omega_n + 2*m*g*a3*gamma3) */
    const double t8 = x[1]*x[1]; /* v_nu*v_nu */
    const double t9 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = x[3]*t9; /* omega_n*b */
    const double t11 = x[5]*p[1]; /* s*R */
    const double t12 = JLT_FMA(x[4], t11, t10); /* v_tau = omega3*s*R + omega_n*b */
    const double t13 = JLT_FMA(t12, t12, t8); /* v_tau*v_tau + v_nu*v_nu */
    const double t14 = p[19]*t13; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t15 = t7 + t14; /* energy = t7 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t16 = x[5]*p[20]; /* s*R*I1 */
    const double t17 = x[3]*t16; /* omega_n*s*R*I1 */
    out[0] = t15;
    out[1] = t17;
    out[2] = t14;
    out[3] = t7;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = x[3]*t0; /* omega_n*b */
    const double t2 = p[1]*x[4]; /* R*omega3 */
    const double t3 = JLT_FMA(x[5], t2, t1); /* v_tau = s*R*omega3 + omega_n*b */
    const double t4 = p[21]*t3; /* m*R*v_tau */
    const double t5 = x[3]*t4; /* omega_n*m*R*v_tau */
    const double t6 = p[13] + t5; /* d(energy)/d(gamma3) = m*g*a3 + omega_n*m*R*v_tau */
    const double t7 = p[0]*x[1]; /* m*v_nu */
    const double t8 = x[5]*p[9]; /* s*m*a3^2 */
    const double t9 = JLT_FMA(x[5], t8, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t10 = x[2]*t9; /* omega_tau*D */
    const double t11 = x[3]*p[4]; /* omega_n*I1 */
    const double t12 = t0*p[0]; /* b*m */
    const double t13 = t3*t12; /* v_tau*b*m */
    const double t14 = t11 + t13; /* d(energy)/d(omega_n) = omega_n*I1 + v_tau*b*m */
    const double t15 = x[5]*t4; /* s*m*R*v_tau */
    const double t16 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t17 = t8*t16; /* s*m*a3^2*omega_tau*omega_tau */
    const double t18 = x[4]*t4; /* omega3*m*R*v_tau */
    const double t19 = t17 + t18; /* d(energy)/d(s) = s*m*a3^2*omega_tau*omega_tau + omega3*m*R*v_tau */
    const double t20 = x[5]*p[20]; /* s*R*I1 */
    const double t21 = x[3]*p[20]; /* omega_n*R*I1 */
    out[0] = t6;
    out[1] = t7;
    out[2] = t10;
    out[3] = t14;
    out[4] = t15;
    out[5] = t19;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t20;
    out[10] = 0.0;
    out[11] = t21;
    out[12] = t5;
    out[13] = t7;
    out[14] = 0.0;
    out[15] = t13;
    out[16] = t15;
    out[17] = t18;
    out[18] = p[13];
    out[19] = 0.0;
    out[20] = t10;
    out[21] = t11;
    out[22] = 0.0;
    out[23] = t17;
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
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
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
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x5, x5, k);
        t3[k] = jlt_jet_product(x2, t2, k);
        t7[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t9[k] = jlt_jet_product(x3, x3, k);
        t10[k] = jlt_jet_product(t7, t9, k);
        t12[k] = x5[k]*p[1];
        t13[k] = jlt_jet_product(x3, x4, k);
        t14[k] = jlt_jet_product(t12, t13, k) + t10[k];
        t17[k] = t2[k]*p[7];
        t19[k] = jlt_jet_product(x2, x0, k);
        t20[k] = p[8]*t19[k];
        t21[k] = jlt_jet_product(x0, t9, k) + t17[k];
        t22[k] = t21[k] - jlt_jet_product(t3, t20, k);
        t25[k] = t2[k]*p[9] + (k == 0 ? p[4] : 0);
        t26[k] = jlt_jet_product(x5, t25, k);
        t28[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t26, t28, k);
        t29[k] = x5[k]*p[6];
        t30[k] = jlt_jet_product(t22, t29, k);
        t31[k] = jlt_jet_product(t28, t30, k);
        t32[k] = jlt_jet_product(x3, t19, k);
        t35[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t36[k] = jlt_jet_product(x2, t35, k) + x1[k];
        t37[k] = x3[k]*p[10];
        t38[k] = jlt_jet_product(t25, t37, k);
        t39[k] = jlt_jet_product(t36, t38, k);
        t40[k] = jlt_jet_product(t28, t39, k);
        t41[k] = jlt_jet_product(x4, t19, k) - t40[k];
        t42[k] = jlt_jet_product(x5, t19, k);
        t43[k] = -t42[k];
        double *restrict next = coefficients + (k + 1)*7;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t14[k]/(k + 1);
        next[2] = x2[k + 1] = t31[k]/(k + 1);
        next[3] = x3[k + 1] = t32[k]/(k + 1);
        next[4] = x4[k + 1] = t41[k]/(k + 1);
        next[5] = x5[k + 1] = t43[k]/(k + 1);
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

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 22,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 6, { 1, 19, 8, 1, 0, 0, 6, 7 }, { 9, 36, 0, 4, 0, 0, 8, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .jacobian = { jacobian, 36, { 4, 39, 11, 1, 0, 0, 10, 11 }, { 17, 99, 0, 14, 0, 0, 11, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 42, { 5, 47, 14, 1, 0, 0, 10, 19 }, { 22, 128, 0, 18, 0, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .divergence = { divergence, 1, { 0, 4, 2, 1, 0, 0, 5, 3 }, { 2, 12, 0, 1, 0, 0, 8, 4 },
        "" },
    .integral_values = { integral_values, 4, { 1, 11, 6, 0, 0, 0, 6, 5 }, { 10, 41, 0, 0, 0, 0, 9, 5 },
        "" },
    .integral_gradients = { integral_gradients, 24, { 3, 16, 3, 0, 0, 0, 6, 6 }, { 6, 54, 0, 0, 0, 0, 6, 6 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_rod_in_regular_baseline,
        &jlt_batch_spherical_top_rod_in_regular_avx2,
        &jlt_batch_spherical_top_rod_in_regular_avx512,
    },
};
