/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   17    8    1    1    0     10    8   (50)
 *  jacobian            6   37   13    1    1    0     13   13   (170)
 *  rhs_jacobian        5   39   17    1    1    0     12   13   (206)
 *  divergence          2    4    2    1    1    0      6    4   (18)
 *  integral_values     3   11    6    0    1    0      7    6   (54)
 *  integral_gradients  4   16    5    1    1    0      7    6   (64)
 *  measure_values      2    2    1    0    1    0      4    3   (9)
 *  measure_divergences 3    5    1    1    0    0      6    4   (41)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_rod;
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
    out[15] = t1;
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    out[6] = t2;
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[3]*t3; /* a3*m*g */
    out[17] = t4;
    const double t5 = t4/params[4]; /* a3*m*g/I1 */
    out[7] = t5;
    const double t6 = 1.0/params[1]; /* 1/R */
    out[8] = t6;
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t0*t7; /* a3*a3*m*2 */
    out[16] = t8;
    const double t9 = t8/params[4]; /* a3*a3*m*2/I1 */
    out[9] = t9;
    const double t10 = params[3]/params[1]; /* a3/R */
    out[10] = t10;
    const double t11 = 2.0/params[1]; /* 2/R */
    out[11] = t11;
    const double t12 = (-1.0)/params[1]; /* (-1)/R */
    out[12] = t12;
    const double t13 = params[0]*params[0]; /* m*m */
    const double t14 = 2.0*t13; /* 2*m*m */
    const double t15 = params[2]*t14; /* g*2*m*m */
    const double t16 = params[3]*t0; /* a3*a3*a3 */
    const double t17 = t15*t16; /* g*2*m*m*a3*a3*a3 */
    const double t18 = params[4]*params[4]; /* I1*I1 */
    const double t19 = t17/t18; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    out[13] = t19;
    const double t20 = params[3]/2.0; /* a3/2 */
    out[14] = t20;
    const double t21 = params[4]/2.0; /* I1/2 */
    out[18] = t21;
    const double t22 = params[0]/2.0; /* m/2 */
    out[19] = t22;
    const double t23 = params[4]*params[1]; /* I1*R */
    out[20] = t23;
    const double t24 = params[0]*params[1]; /* m*R */
    out[21] = t24;
    const double t25 = -t23; /* -I1*R */
    out[22] = t25;
    const double t26 = params[0]*(-2.0); /* m*(-2) */
    const double t27 = t0*t26; /* a3*a3*m*(-2) */
    out[23] = t27;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    out[0] = t4;
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[6], 1.0); /* D/I1 = (1 - gamma3)*(1 + gamma3)*m*a3^2/I1 + 1 */
    const double t7 = t3*t6; /* s*D/I1 */
    const double t8 = 1.0/t7; /* 1/(s*D/I1) */
    const double t9 = t6*t8; /* 1/s = D/I1*1/(s*D/I1) */
    const double t10 = x[3]*t9; /* omega_n*1/s */
    const double t11 = t5*t10; /* b*omega_n*1/s */
    const double t12 = JLT_FMA(p[1], x[4], t11); /* R*omega3 + b*omega_n*1/s */
    const double t13 = x[3]*t12; /* omega_n*(R*omega3 + b*omega_n*1/s) */
    out[1] = t13;
    const double t14 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t15 = p[6]*t14; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t16 = t4*t15; /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t17 = x[0]*x[3]; /* gamma3*omega_n */
    const double t18 = JLT_FNMA(t3, p[7], t16); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - s*m*g*a3/I1 */
    const double t19 = JLT_FNMA(t10, t17, t18); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - s*m*g*a3/I1 - omega_n*1/s*gamma3*omega_n */
    const double t20 = t3*t8; /* s*1/(s*D/I1) */
    const double t21 = t19*t20; /* t19*s*1/(s*D/I1) */
    out[2] = t21;
    const double t22 = t10*t14; /* omega_n*1/s*omega_tau*gamma3 */
    out[3] = t22;
    const double t23 = x[4]*t14; /* omega3*omega_tau*gamma3 */
    const double t24 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t25 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t26 = p[8]*t25; /* 1/R*V */
    const double t27 = JLT_FNMA(t10, t26, t23); /* omega3*omega_tau*gamma3 - omega_n*1/s*1/R*V */
    const double t28 = t9*t27; /* 1/s*(omega3*omega_tau*gamma3 - omega_n*1/s*1/R*V) */
    out[4] = t28;
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
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(gamma3 + 1) + 1 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t4;
    const double t5 = t3*t4; /* D/I1*s */
    const double t6 = 1.0/t5; /* 1/(D/I1*s) */
    const double t7 = t3*t6; /* 1/s = D/I1*1/(D/I1*s) */
    const double t8 = t4*t6; /* 1/(D/I1) = s*1/(D/I1*s) */
    const double t9 = t4*t8; /* s*1/(D/I1) */
    const double t10 = x[0]*t8; /* gamma3*1/(D/I1) */
    const double t11 = p[9]*t9; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t12 = x[3]*p[9]; /* omega_n*2*m*a3^2/I1 */
    const double t13 = t10*t12; /* gamma3*1/(D/I1)*omega_n*2*m*a3^2/I1 */
    const double t14 = t10*t13; /* gamma3*1/(D/I1)*gamma3*1/(D/I1)*omega_n*2*m*a3^2/I1 */
    const double t15 = x[3]*t7; /* omega_n*1/s */
    const double t16 = x[0]*t15; /* gamma3*omega_n*1/s */
    out[17] = t16;
    const double t17 = t7 - t11; /* 1/s - 2*m*a3^2/I1*s*1/(D/I1) */
    const double t18 = t10*t17; /* gamma3*1/(D/I1)*(1/s - 2*m*a3^2/I1*s*1/(D/I1)) */
    const double t19 = JLT_FMS(x[0], t18, t9); /* gamma3*gamma3*1/(D/I1)*(1/s - 2*m*a3^2/I1*s*1/(D/I1)) - s*1/(D/I1) */
    const double t20 = p[7]*t18; /* m*g*a3/I1*gamma3*1/(D/I1)*(1/s - 2*m*a3^2/I1*s*1/(D/I1)) */
    const double t21 = x[4]*t7; /* omega3*1/s */
    const double t22 = t7*t7; /* 1/s*1/s */
    const double t23 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t24 = t7*t15; /* 1/s*omega_n*1/s */
    const double t25 = JLT_FMA(t8, t24, t14); /* 1/(D/I1)*1/s*omega_n*1/s + gamma3*1/(D/I1)*gamma3*1/(D/I1)*omega_n*2*m*a3^2/I1 */
    const double t26 = JLT_FNMA(t15, t25, t20); /* m*g*a3/I1*gamma3*1/(D/I1)*(1/s - 2*m*a3^2/I1*s*1/(D/I1)) - omega_n*1/s*t25 */
    const double t27 = x[2]*t7; /* omega_tau*1/s */
    const double t28 = t24*t27; /* 1/s*omega_n*1/s*omega_tau*1/s */
    out[15] = t28;
    const double t29 = x[0]*t27; /* gamma3*omega_tau*1/s */
    out[18] = t29;
    out[24] = t29;
    const double t30 = -t29; /* -gamma3*omega_tau*1/s */
    out[0] = t30;
    const double t31 = t21*t22; /* omega3*1/s*1/s*1/s */
    const double t32 = JLT_FNMA(p[10], t24, t31); /* omega3*1/s*1/s*1/s - a3/R*1/s*omega_n*1/s */
    const double t33 = x[2]*t32; /* omega_tau*(omega3*1/s*1/s*1/s - a3/R*1/s*omega_n*1/s) */
    const double t34 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t35 = t22*t34; /* 1/s*1/s*V */
    const double t36 = p[12]*t35; /* (-1/R)*1/s*1/s*V */
    out[23] = t36;
    const double t37 = p[11]*t35; /* 2/R*1/s*1/s*V */
    const double t38 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t39 = x[0]*t24; /* gamma3*1/s*omega_n*1/s */
    const double t40 = JLT_FNMA(t37, t39, t33); /* omega_tau*(omega3*1/s*1/s*1/s - a3/R*1/s*omega_n*1/s) - 2/R*1/s*1/s*V*gamma3*1/s*omega_n*1/s */
    out[20] = t40;
    const double t41 = p[8]*t24; /* 1/R*1/s*omega_n*1/s */
    const double t42 = t23*t41; /* e*1/R*1/s*omega_n*1/s */
    const double t43 = JLT_FMS(x[0], t21, t42); /* gamma3*omega3*1/s - e*1/R*1/s*omega_n*1/s */
    out[22] = t43;
    const double t44 = -t41; /* -1/R*1/s*omega_n*1/s */
    out[21] = t44;
    const double t45 = p[1]*x[3]; /* R*omega_n */
    out[9] = t45;
    const double t46 = JLT_FMA(t38, t39, t45); /* b*gamma3*1/s*omega_n*1/s + R*omega_n */
    const double t47 = t15*t46; /* omega_n*1/s*(b*gamma3*1/s*omega_n*1/s + R*omega_n) */
    out[5] = t47;
    const double t48 = 2.0*t15; /* 2*omega_n*1/s */
    const double t49 = t10*t48; /* gamma3*1/(D/I1)*2*omega_n*1/s */
    const double t50 = -t49; /* -gamma3*1/(D/I1)*2*omega_n*1/s */
    out[13] = t50;
    const double t51 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t52 = x[2]*t51; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t53 = JLT_FNMA(t19, t52, t26); /* t26 - t19*omega_tau*omega_tau*m*a3^2/I1 */
    out[10] = t53;
    const double t54 = p[1]*x[4]; /* R*omega3 */
    const double t55 = JLT_FMA(t38, t48, t54); /* b*2*omega_n*1/s + R*omega3 */
    out[8] = t55;
    const double t56 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t57 = t11*t56; /* 2*m*a3^2/I1*s*1/(D/I1)*gamma3*omega_tau */
    out[12] = t57;
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
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[7] = t3;
    const double t4 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(1 + gamma3) + 1 */
    const double t5 = t3*t4; /* s*D/I1 */
    const double t6 = 1.0/t5; /* 1/(s*D/I1) */
    const double t7 = t4*t6; /* 1/s = D/I1*1/(s*D/I1) */
    const double t8 = t3*t6; /* 1/(D/I1) = s*1/(s*D/I1) */
    const double t9 = x[2]*t3; /* omega_tau*s */
    out[0] = t9;
    const double t10 = t3*t8; /* s*1/(D/I1) */
    const double t11 = x[0]*t8; /* gamma3*1/(D/I1) */
    const double t12 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t13 = x[3]*t7; /* omega_n*1/s */
    const double t14 = x[0]*t13; /* gamma3*omega_n*1/s */
    out[22] = t14;
    const double t15 = t9*t11; /* omega_tau*s*gamma3*1/(D/I1) */
    const double t16 = t9*t12; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t17 = p[9]*t15; /* 2*m*a3^2/I1*omega_tau*s*gamma3*1/(D/I1) */
    out[17] = t17;
    const double t18 = t12*t15; /* omega_tau*m*a3^2/I1*omega_tau*s*gamma3*1/(D/I1) */
    const double t19 = x[0]*t7; /* gamma3*1/s */
    const double t20 = JLT_FMA(p[7], t19, t16); /* m*g*a3/I1*gamma3*1/s + omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t21 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t22 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t23 = t13*t22; /* omega_n*1/s*b */
    const double t24 = t11*t13; /* gamma3*1/(D/I1)*omega_n*1/s */
    const double t25 = JLT_FNMA(x[3], t24, t18); /* omega_tau*m*a3^2/I1*omega_tau*s*gamma3*1/(D/I1) - omega_n*gamma3*1/(D/I1)*omega_n*1/s */
    const double t26 = (-2.0)*t24; /* (-2)*gamma3*1/(D/I1)*omega_n*1/s */
    out[18] = t26;
    const double t27 = JLT_FNMA(p[7], t10, t25); /* t25 - m*g*a3/I1*s*1/(D/I1) */
    out[2] = t27;
    const double t28 = p[13]*t10; /* 2*m^2*g*a3^3/I1^2*s*1/(D/I1) */
    const double t29 = x[2]*t19; /* omega_tau*gamma3*1/s */
    out[23] = t29;
    out[29] = t29;
    const double t30 = JLT_FMA(t12, t29, t28); /* omega_tau*m*a3^2/I1*omega_tau*gamma3*1/s + 2*m^2*g*a3^3/I1^2*s*1/(D/I1) */
    const double t31 = JLT_FNMA(p[9], t25, t30); /* t30 - 2*m*a3^2/I1*t25 */
    const double t32 = x[3]*t29; /* omega_n*omega_tau*gamma3*1/s */
    out[3] = t32;
    const double t33 = -t29; /* -omega_tau*gamma3*1/s */
    out[5] = t33;
    const double t34 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t35 = t7*t13; /* 1/s*omega_n*1/s */
    const double t36 = JLT_FNMA(t13, t35, t20); /* m*g*a3/I1*gamma3*1/s + omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*1/s*1/s*omega_n*1/s */
    const double t37 = t8*t36; /* 1/(D/I1)*t36 */
    const double t38 = JLT_FNMA(t11, t31, t37); /* 1/(D/I1)*t36 - gamma3*1/(D/I1)*(t30 - 2*m*a3^2/I1*t25) */
    out[15] = t38;
    const double t39 = x[2]*t7; /* omega_tau*1/s */
    const double t40 = t7*t7; /* 1/s*1/s */
    const double t41 = t35*t39; /* 1/s*omega_n*1/s*omega_tau*1/s */
    out[20] = t41;
    const double t42 = x[4]*t39; /* omega3*omega_tau*1/s */
    const double t43 = t40*t42; /* 1/s*1/s*omega3*omega_tau*1/s */
    const double t44 = t34*t40; /* V*1/s*1/s */
    const double t45 = p[12]*t44; /* (-1/R)*V*1/s*1/s */
    out[28] = t45;
    const double t46 = p[1]*x[4]; /* R*omega3 */
    const double t47 = JLT_FMA(2.0, t23, t46); /* 2*omega_n*1/s*b + R*omega3 */
    out[13] = t47;
    const double t48 = t23 + t46; /* omega_n*1/s*b + R*omega3 */
    const double t49 = x[3]*t48; /* omega_n*(omega_n*1/s*b + R*omega3) */
    out[1] = t49;
    const double t50 = p[8]*t35; /* 1/R*1/s*omega_n*1/s */
    const double t51 = t34*t50; /* V*1/R*1/s*omega_n*1/s */
    const double t52 = JLT_FMS(x[4], t29, t51); /* omega3*omega_tau*gamma3*1/s - V*1/R*1/s*omega_n*1/s */
    out[4] = t52;
    const double t53 = p[11]*t35; /* 2/R*1/s*omega_n*1/s */
    const double t54 = t21*t50; /* e*1/R*1/s*omega_n*1/s */
    const double t55 = -t50; /* -1/R*1/s*omega_n*1/s */
    out[26] = t55;
    const double t56 = JLT_FMS(x[4], t19, t54); /* omega3*gamma3*1/s - e*1/R*1/s*omega_n*1/s */
    out[27] = t56;
    const double t57 = x[3]*p[1]; /* omega_n*R */
    out[14] = t57;
    const double t58 = JLT_FMA(t19, t23, t57); /* gamma3*1/s*omega_n*1/s*b + omega_n*R */
    const double t59 = t13*t58; /* omega_n*1/s*(gamma3*1/s*omega_n*1/s*b + omega_n*R) */
    out[10] = t59;
    const double t60 = x[2]*p[14]; /* omega_tau*1/2*a3 */
    const double t61 = JLT_FMA(x[0], t44, t60); /* gamma3*V*1/s*1/s + omega_tau*1/2*a3 */
    const double t62 = JLT_FNMA(t53, t61, t43); /* 1/s*1/s*omega3*omega_tau*1/s - 2/R*1/s*omega_n*1/s*(gamma3*V*1/s*1/s + omega_tau*1/2*a3) */
    out[25] = t62;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[15], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*D */
    const double t6 = JLT_FMA(t2, p[16], t4); /* (1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D */
    const double t7 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t8 = t6*t7; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D)*gamma3*omega_tau */
    const double t9 = t8/t5; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D)*gamma3*omega_tau/(s*D) */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[17]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[15], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t6 = x[2]*t5; /* omega_tau*1/2*omega_tau */
    const double t7 = p[18]*x[3]; /* 1/2*I1*omega_n */
    const double t8 = JLT_FMA(x[3], t7, t0); /* omega_n*1/2*I1*omega_n + m*g*a3*gamma3 */
    const double t9 = JLT_FMA(t4, t6, t8); /* D*omega_tau*1/2*omega_tau + omega_n*1/2*I1*omega_n + m*g*a3*gamma3 */
    out[3] = t9;
    const double t10 = x[1]*x[1]; /* v_nu*v_nu */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = x[3]*t11; /* omega_n*b */
    const double t13 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t14 = p[1]*x[4]; /* R*omega3 */
    const double t15 = JLT_FMA(t13, t14, t12); /* v_tau = s*R*omega3 + omega_n*b */
    const double t16 = JLT_FMA(t15, t15, t10); /* v_tau*v_tau + v_nu*v_nu */
    const double t17 = p[19]*t16; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[2] = t17;
    const double t18 = t9 + t17; /* energy = t9 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[0] = t18;
    const double t19 = x[3]*p[20]; /* omega_n*R*I1 */
    const double t20 = t13*t19; /* s*omega_n*R*I1 */
    out[1] = t20;
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
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = JLT_FMA(p[15], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*t5; /* omega_tau*D */
    out[2] = t6;
    out[17] = t6;
    const double t7 = p[20]*t4; /* R*I1*s */
    out[8] = t7;
    const double t8 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t9 = x[3]*t8; /* omega_n*b */
    const double t10 = p[0]*t8; /* m*b */
    const double t11 = x[4]*p[1]; /* omega3*R */
    const double t12 = JLT_FMA(t4, t11, t9); /* v_tau = s*omega3*R + omega_n*b */
    const double t13 = t10*t12; /* m*b*v_tau */
    out[13] = t13;
    const double t14 = p[21]*t12; /* m*R*v_tau */
    const double t15 = t4*t14; /* s*m*R*v_tau */
    out[4] = t15;
    out[14] = t15;
    const double t16 = x[0]/t4; /* gamma3/s */
    const double t17 = p[15]*x[0]; /* m*a3^2*gamma3 */
    const double t18 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t19 = JLT_FNMA(t17, t18, p[17]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    out[15] = t19;
    const double t20 = JLT_FNMA(x[4], t16, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*gamma3/s */
    const double t21 = t14*t20; /* m*R*v_tau*d(v_tau)/d(gamma3)/R */
    out[10] = t21;
    const double t22 = t19 + t21; /* d(energy)/d(gamma3) = m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau + m*R*v_tau*d(v_tau)/d(gamma3)/R */
    out[0] = t22;
    const double t23 = x[3]*p[4]; /* omega_n*I1 */
    out[18] = t23;
    const double t24 = t13 + t23; /* d(energy)/d(omega_n) = m*b*v_tau + omega_n*I1 */
    out[3] = t24;
    const double t25 = x[3]*p[22]; /* omega_n*(-R*I1) */
    const double t26 = t16*t25; /* gamma3/s*omega_n*(-R*I1) */
    out[5] = t26;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(t2, p[15], p[4]); /* (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*((1 - gamma3)*(1 + gamma3)*m*a3^2 + I1) */
    out[0] = t5;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(t2, p[15], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t4 = t3/t3; /* D/D */
    const double t5 = 1.0 - t4; /* 1 - D/D */
    const double t6 = p[23]*x[0]; /* (-2*m*a3^2)*gamma3 */
    const double t7 = x[2]*t6; /* omega_tau*(-2*m*a3^2)*gamma3 */
    const double t8 = t2*t7; /* (1 - gamma3)*(1 + gamma3)*omega_tau*(-2*m*a3^2)*gamma3 */
    const double t9 = t5*t8; /* (1 - D/D)*(1 - gamma3)*(1 + gamma3)*omega_tau*(-2*m*a3^2)*gamma3 */
    out[0] = t9;
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
    double t25[JLT_JET_ORDER_MAX + 1];
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
        t25[k] = jlt_jet_product(x0, x3, k);
        t27[k] = t24[k] - t6[k]*p[7];
        t28[k] = t27[k] - jlt_jet_product(t17, t25, k);
        t29[k] = jlt_jet_product(t6, t15, k);
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = jlt_jet_product(t17, t22, k);
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
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 6, .block_count = 24,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 17, 8, 1, 1, 0, 10, 8 }, { 9, 33, 0, 7, 1, 0, 9, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 25, { 6, 37, 13, 1, 1, 0, 13, 13 }, { 23, 119, 0, 27, 1, 0, 15, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 5, 39, 17, 1, 1, 0, 12, 13 }, { 27, 144, 0, 34, 1, 0, 15, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 4, 2, 1, 1, 0, 6, 4 }, { 3, 12, 0, 2, 1, 0, 9, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 4, { 3, 11, 6, 0, 1, 0, 7, 6 }, { 11, 42, 0, 0, 1, 0, 11, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 20, { 4, 16, 5, 1, 1, 0, 7, 6 }, { 10, 51, 0, 2, 1, 0, 8, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { measure_values, 1, { 2, 2, 1, 0, 1, 0, 4, 3 }, { 2, 6, 0, 0, 1, 0, 7, 4 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_divergences = { measure_divergences, 1, { 3, 5, 1, 1, 0, 0, 6, 4 }, { 7, 30, 0, 3, 1, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 1, .equilibria_count = 0,
    .integrals = integrals,
    .measures = measures,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_rod_baseline,
        &jlt_batch_spherical_top_rod_avx2,
        &jlt_batch_spherical_top_rod_avx512,
    },
};
