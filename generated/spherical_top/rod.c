/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   18    8    1    1    0     11    7   (50)
 *  jacobian            4   37   15    1    1    0     12   14   (170)
 *  rhs_jacobian        4   42   19    1    1    0     14   19   (206)
 *  divergence          2    7    2    1    1    0      8    5   (18)
 *  integral_values     3   11    6    0    1    0      7    6   (54)
 *  integral_gradients  4   19    5    1    1    0      8   10   (64)
 *  measure_values      2    2    1    0    1    0      4    3   (9)
 *  measure_divergences 2    9    4    1    1    0     10    8   (41)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
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
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[3]*t3; /* a3*m*g */
    const double t5 = t4/params[4]; /* a3*m*g/I1 */
    const double t6 = 1.0/params[1]; /* 1/R */
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t0*t7; /* a3*a3*m*2 */
    const double t9 = params[4]*(-2.0); /* I1*(-2) */
    const double t10 = 2.0/params[1]; /* 2/R */
    const double t11 = params[3]/2.0; /* a3/2 */
    const double t12 = (-1.0)/params[1]; /* (-1)/R */
    const double t13 = params[0]*params[0]; /* m*m */
    const double t14 = 2.0*t13; /* 2*m*m */
    const double t15 = params[2]*t14; /* g*2*m*m */
    const double t16 = params[3]*t0; /* a3*a3*a3 */
    const double t17 = t15*t16; /* g*2*m*m*a3*a3*a3 */
    const double t18 = t17/params[4]; /* g*2*m*m*a3*a3*a3/I1 */
    const double t19 = params[2]*t7; /* g*m*2 */
    const double t20 = params[3]*t19; /* a3*g*m*2 */
    const double t21 = params[0]/2.0; /* m/2 */
    const double t22 = params[4]*params[1]; /* I1*R */
    const double t23 = params[0]*params[3]; /* m*a3 */
    const double t24 = params[0]*params[1]; /* m*R */
    const double t25 = -t22; /* -I1*R */
    out[6] = t1;
    out[7] = t2;
    out[8] = t5;
    out[9] = t6;
    out[10] = t8;
    out[11] = t4;
    out[12] = t9;
    out[13] = t10;
    out[14] = t11;
    out[15] = t12;
    out[16] = t18;
    out[17] = t20;
    out[18] = t21;
    out[19] = t22;
    out[20] = t23;
    out[21] = t24;
    out[22] = t25;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[6], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t7 = t3*t6; /* s*D */
    const double t8 = 1.0/t7; /* 1/(s*D) */
    const double t9 = t6*t8; /* D*1/(s*D) */
    const double t10 = x[3]*t9; /* omega_n*D*1/(s*D) */
    const double t11 = t5*t10; /* b*omega_n*D*1/(s*D) */
    const double t12 = JLT_FMA(p[1], x[4], t11); /* R*omega3 + b*omega_n*D*1/(s*D) */
    const double t13 = x[3]*t12; /* omega_n*(R*omega3 + b*omega_n*D*1/(s*D)) */
    const double t14 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t15 = t4*t14; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t16 = JLT_FNMA(x[3], t10, t15); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n*D*1/(s*D) */
    const double t17 = x[0]*t16; /* gamma3*(omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n*D*1/(s*D)) */
    const double t18 = JLT_FNMA(t3, p[8], t17); /* t17 - s*m*g*a3/I1 */
    const double t19 = t3*p[4]; /* s*I1 */
    const double t20 = t8*t19; /* 1/(s*D)*s*I1 */
    const double t21 = t18*t20; /* (t17 - s*m*g*a3/I1)*1/(s*D)*s*I1 */
    const double t22 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t23 = t10*t22; /* omega_n*D*1/(s*D)*omega_tau*gamma3 */
    const double t24 = x[4]*t22; /* omega3*omega_tau*gamma3 */
    const double t25 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t26 = JLT_FMA(x[2], t25, x[1]); /* V = omega_tau*e + v_nu */
    const double t27 = p[9]*t26; /* 1/R*V */
    const double t28 = JLT_FNMA(t10, t27, t24); /* omega3*omega_tau*gamma3 - omega_n*D*1/(s*D)*1/R*V */
    const double t29 = t9*t28; /* D*1/(s*D)*(omega3*omega_tau*gamma3 - omega_n*D*1/(s*D)*1/R*V) */
    out[0] = t4;
    out[1] = t13;
    out[2] = t21;
    out[3] = t23;
    out[4] = t29;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[6], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = t3*t4; /* D*s */
    const double t6 = 1.0/t5; /* 1/(D*s) */
    const double t7 = t3*t6; /* D*1/(D*s) */
    const double t8 = x[0]*t7; /* gamma3*D*1/(D*s) */
    const double t9 = x[2]*t8; /* omega_tau*gamma3*D*1/(D*s) */
    const double t10 = -t9; /* -omega_tau*gamma3*D*1/(D*s) */
    const double t11 = t7*x[3]; /* D*1/(D*s)*omega_n */
    const double t12 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t13 = t11*t12; /* D*1/(D*s)*omega_n*b */
    const double t14 = x[3]*p[1]; /* omega_n*R */
    const double t15 = JLT_FMA(t8, t13, t14); /* gamma3*D*1/(D*s)*D*1/(D*s)*omega_n*b + omega_n*R */
    const double t16 = t11*t15; /* D*1/(D*s)*omega_n*(gamma3*D*1/(D*s)*D*1/(D*s)*omega_n*b + omega_n*R) */
    const double t17 = p[1]*x[4]; /* R*omega3 */
    const double t18 = JLT_FMA(t13, 2.0, t17); /* D*1/(D*s)*omega_n*b*2 + R*omega3 */
    const double t19 = x[0]*p[10]; /* gamma3*2*m*a3^2 */
    const double t20 = t4*t19; /* s*gamma3*2*m*a3^2 */
    const double t21 = t4*t6; /* s*1/(D*s) */
    const double t22 = JLT_FMS(t20, t21, t8); /* s*gamma3*2*m*a3^2*s*1/(D*s) - gamma3*D*1/(D*s) */
    const double t23 = JLT_FMA(x[0], t22, t4); /* gamma3*(s*gamma3*2*m*a3^2*s*1/(D*s) - gamma3*D*1/(D*s)) + s */
    const double t24 = x[2]*t21; /* omega_tau*s*1/(D*s) */
    const double t25 = x[2]*p[6]; /* omega_tau*m*a3^2 */
    const double t26 = t24*t25; /* omega_tau*s*1/(D*s)*omega_tau*m*a3^2 */
    const double t27 = t23*t26; /* (gamma3*(s*gamma3*2*m*a3^2*s*1/(D*s) - gamma3*D*1/(D*s)) + s)*omega_tau*s*1/(D*s)*omega_tau*m*a3^2 */
    const double t28 = t21*p[11]; /* s*1/(D*s)*m*g*a3 */
    const double t29 = x[3]*t21; /* omega_n*s*1/(D*s) */
    const double t30 = t8*t29; /* gamma3*D*1/(D*s)*omega_n*s*1/(D*s) */
    const double t31 = JLT_FMA(t8, t8, 1.0); /* gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1 */
    const double t32 = t11*t31; /* D*1/(D*s)*omega_n*(gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1) */
    const double t33 = JLT_FMA(t19, t30, t32); /* gamma3*2*m*a3^2*gamma3*D*1/(D*s)*omega_n*s*1/(D*s) + D*1/(D*s)*omega_n*(gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1) */
    const double t34 = p[4]*t29; /* I1*omega_n*s*1/(D*s) */
    const double t35 = JLT_FNMA(t22, t28, t27); /* t27 - (s*gamma3*2*m*a3^2*s*1/(D*s) - gamma3*D*1/(D*s))*s*1/(D*s)*m*g*a3 */
    const double t36 = JLT_FNMA(t33, t34, t35); /* t35 - t33*I1*omega_n*s*1/(D*s) */
    const double t37 = t20*t24; /* s*gamma3*2*m*a3^2*omega_tau*s*1/(D*s) */
    const double t38 = t30*p[12]; /* gamma3*D*1/(D*s)*omega_n*s*1/(D*s)*(-2*I1) */
    const double t39 = x[2]*t32; /* omega_tau*D*1/(D*s)*omega_n*(gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1) */
    const double t40 = t8*x[3]; /* gamma3*D*1/(D*s)*omega_n */
    const double t41 = t7*t11; /* D*1/(D*s)*D*1/(D*s)*omega_n */
    const double t42 = x[2]*p[14]; /* omega_tau*1/2*a3 */
    const double t43 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t44 = JLT_FMA(x[2], t43, x[1]); /* V = omega_tau*e + v_nu */
    const double t45 = t7*t44; /* D*1/(D*s)*V */
    const double t46 = JLT_FMA(t8, t45, t42); /* gamma3*D*1/(D*s)*D*1/(D*s)*V + omega_tau*1/2*a3 */
    const double t47 = p[13]*t41; /* 2/R*D*1/(D*s)*D*1/(D*s)*omega_n */
    const double t48 = t46*t47; /* (gamma3*D*1/(D*s)*D*1/(D*s)*V + omega_tau*1/2*a3)*2/R*D*1/(D*s)*D*1/(D*s)*omega_n */
    const double t49 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t50 = t7*t49; /* D*1/(D*s)*omega_tau*omega3 */
    const double t51 = JLT_FMS(t31, t50, t48); /* (gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1)*D*1/(D*s)*omega_tau*omega3 - t48 */
    const double t52 = t41*p[9]; /* D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t53 = -t52; /* -D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t54 = t43*t52; /* e*D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t55 = JLT_FMS(t8, x[4], t54); /* gamma3*D*1/(D*s)*omega3 - e*D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t56 = t7*p[15]; /* D*1/(D*s)*(-1/R) */
    const double t57 = t45*t56; /* D*1/(D*s)*V*D*1/(D*s)*(-1/R) */
    out[0] = t10;
    out[1] = 0.0;
    out[2] = t4;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t16;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t18;
    out[9] = t14;
    out[10] = t36;
    out[11] = 0.0;
    out[12] = t37;
    out[13] = t38;
    out[14] = 0.0;
    out[15] = t39;
    out[16] = 0.0;
    out[17] = t40;
    out[18] = t9;
    out[19] = 0.0;
    out[20] = t51;
    out[21] = t53;
    out[22] = t55;
    out[23] = t57;
    out[24] = t9;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[6], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t7 = t3*t6; /* s*D */
    const double t8 = 1.0/t7; /* 1/(s*D) */
    const double t9 = t6*t8; /* D*1/(s*D) */
    const double t10 = x[3]*t9; /* omega_n*D*1/(s*D) */
    const double t11 = t5*t10; /* b*omega_n*D*1/(s*D) */
    const double t12 = x[3]*t11; /* omega_n*b*omega_n*D*1/(s*D) */
    const double t13 = x[3]*p[1]; /* omega_n*R */
    const double t14 = JLT_FMA(x[4], t13, t12); /* omega3*omega_n*R + omega_n*b*omega_n*D*1/(s*D) */
    const double t15 = t3*t8; /* s*1/(s*D) */
    const double t16 = x[0]*t15; /* gamma3*s*1/(s*D) */
    const double t17 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t18 = t4*t17; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t19 = JLT_FNMA(x[3], t10, t18); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n*D*1/(s*D) */
    const double t20 = p[4]*t16; /* I1*gamma3*s*1/(s*D) */
    const double t21 = t19*t20; /* (omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n*D*1/(s*D))*I1*gamma3*s*1/(s*D) */
    const double t22 = t15*p[11]; /* s*1/(s*D)*m*g*a3 */
    const double t23 = JLT_FNMA(t3, t22, t21); /* t21 - s*s*1/(s*D)*m*g*a3 */
    const double t24 = x[0]*t10; /* gamma3*omega_n*D*1/(s*D) */
    const double t25 = x[2]*t24; /* omega_tau*gamma3*omega_n*D*1/(s*D) */
    const double t26 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t27 = JLT_FMA(x[2], t26, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = t9*t10; /* D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t29 = p[9]*t28; /* 1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t30 = t27*t29; /* V*1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t31 = x[0]*t9; /* gamma3*D*1/(s*D) */
    const double t32 = x[2]*t31; /* omega_tau*gamma3*D*1/(s*D) */
    const double t33 = JLT_FMS(x[4], t32, t30); /* omega3*omega_tau*gamma3*D*1/(s*D) - V*1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t34 = -t32; /* -omega_tau*gamma3*D*1/(s*D) */
    const double t35 = JLT_FMA(t11, t31, t13); /* b*omega_n*D*1/(s*D)*gamma3*D*1/(s*D) + omega_n*R */
    const double t36 = t10*t35; /* omega_n*D*1/(s*D)*(b*omega_n*D*1/(s*D)*gamma3*D*1/(s*D) + omega_n*R) */
    const double t37 = p[1]*x[4]; /* R*omega3 */
    const double t38 = JLT_FMA(t11, 2.0, t37); /* b*omega_n*D*1/(s*D)*2 + R*omega3 */
    const double t39 = t3*p[16]; /* s*2*m^2*g*a3^3/I1 */
    const double t40 = t15*t39; /* s*1/(s*D)*s*2*m^2*g*a3^3/I1 */
    const double t41 = t10*t10; /* omega_n*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t42 = JLT_FMA(t17, t32, t40); /* omega_tau*m*a3^2/I1*omega_tau*gamma3*D*1/(s*D) + s*1/(s*D)*s*2*m^2*g*a3^3/I1 */
    const double t43 = JLT_FMA(t31, t41, t42); /* gamma3*D*1/(s*D)*omega_n*D*1/(s*D)*omega_n*D*1/(s*D) + t42 */
    const double t44 = t16*t43; /* gamma3*s*1/(s*D)*(gamma3*D*1/(s*D)*omega_n*D*1/(s*D)*omega_n*D*1/(s*D) + t42) */
    const double t45 = t16*p[10]; /* gamma3*s*1/(s*D)*2*m*a3^2 */
    const double t46 = JLT_FMA(t16, t45, t15); /* gamma3*s*1/(s*D)*gamma3*s*1/(s*D)*2*m*a3^2 + s*1/(s*D) */
    const double t47 = JLT_FNMA(t19, t46, t44); /* t44 - (omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n*D*1/(s*D))*(gamma3*s*1/(s*D)*gamma3*s*1/(s*D)*2*m*a3^2 + s*1/(s*D)) */
    const double t48 = p[4]*t47; /* I1*t47 */
    const double t49 = JLT_FMS(t22, t31, t48); /* s*1/(s*D)*m*g*a3*gamma3*D*1/(s*D) - I1*t47 */
    const double t50 = t4*t45; /* omega_tau*s*gamma3*s*1/(s*D)*2*m*a3^2 */
    const double t51 = t10*p[12]; /* omega_n*D*1/(s*D)*(-2*I1) */
    const double t52 = t16*t51; /* gamma3*s*1/(s*D)*omega_n*D*1/(s*D)*(-2*I1) */
    const double t53 = JLT_FMA(t31, t32, x[2]); /* gamma3*D*1/(s*D)*omega_tau*gamma3*D*1/(s*D) + omega_tau */
    const double t54 = t10*t53; /* omega_n*D*1/(s*D)*(gamma3*D*1/(s*D)*omega_tau*gamma3*D*1/(s*D) + omega_tau) */
    const double t55 = x[2]*p[14]; /* omega_tau*1/2*a3 */
    const double t56 = t9*t27; /* D*1/(s*D)*V */
    const double t57 = JLT_FMA(t31, t56, t55); /* gamma3*D*1/(s*D)*D*1/(s*D)*V + omega_tau*1/2*a3 */
    const double t58 = t28*p[13]; /* D*1/(s*D)*omega_n*D*1/(s*D)*2/R */
    const double t59 = t57*t58; /* (gamma3*D*1/(s*D)*D*1/(s*D)*V + omega_tau*1/2*a3)*D*1/(s*D)*omega_n*D*1/(s*D)*2/R */
    const double t60 = t9*x[4]; /* D*1/(s*D)*omega3 */
    const double t61 = JLT_FMS(t53, t60, t59); /* (gamma3*D*1/(s*D)*omega_tau*gamma3*D*1/(s*D) + omega_tau)*D*1/(s*D)*omega3 - t59 */
    const double t62 = -t29; /* -1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t63 = t26*t29; /* e*1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t64 = JLT_FMS(x[4], t31, t63); /* omega3*gamma3*D*1/(s*D) - e*1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t65 = t9*p[15]; /* D*1/(s*D)*(-1/R) */
    const double t66 = t56*t65; /* D*1/(s*D)*V*D*1/(s*D)*(-1/R) */
    out[0] = t4;
    out[1] = t14;
    out[2] = t23;
    out[3] = t25;
    out[4] = t33;
    out[5] = t34;
    out[6] = 0.0;
    out[7] = t3;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = t36;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t38;
    out[14] = t13;
    out[15] = t49;
    out[16] = 0.0;
    out[17] = t50;
    out[18] = t52;
    out[19] = 0.0;
    out[20] = t54;
    out[21] = 0.0;
    out[22] = t24;
    out[23] = t32;
    out[24] = 0.0;
    out[25] = t61;
    out[26] = t62;
    out[27] = t64;
    out[28] = t66;
    out[29] = t32;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[6], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*D */
    const double t6 = 1.0/t5; /* 1/(s*D) */
    const double t7 = p[10]*t3; /* 2*m*a3^2*s */
    const double t8 = t3*t7; /* s*2*m*a3^2*s */
    const double t9 = t6*t8; /* 1/(s*D)*s*2*m*a3^2*s */
    const double t10 = JLT_FMA(t4, t6, t9); /* D*1/(s*D) + 1/(s*D)*s*2*m*a3^2*s */
    const double t11 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t12 = t10*t11; /* (D*1/(s*D) + 1/(s*D)*s*2*m*a3^2*s)*gamma3*omega_tau */
    out[0] = t12;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[17]*x[0]; /* 2*m*g*a3*gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[6], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t6 = p[4]*x[3]; /* I1*omega_n */
    const double t7 = JLT_FMA(x[3], t6, t0); /* omega_n*I1*omega_n + 2*m*g*a3*gamma3 */
    const double t8 = JLT_FMA(t4, t5, t7); /* D*omega_tau*omega_tau + omega_n*I1*omega_n + 2*m*g*a3*gamma3 */
    const double t9 = (1.0 / 2.0)*t8; /* 1/2*(D*omega_tau*omega_tau + omega_n*I1*omega_n + 2*m*g*a3*gamma3) */
    const double t10 = x[1]*x[1]; /* v_nu*v_nu */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = x[3]*t11; /* omega_n*b */
    const double t13 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t14 = p[1]*x[4]; /* R*omega3 */
    const double t15 = JLT_FMA(t13, t14, t12); /* v_tau = s*R*omega3 + omega_n*b */
    const double t16 = JLT_FMA(t15, t15, t10); /* v_tau*v_tau + v_nu*v_nu */
    const double t17 = p[18]*t16; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t18 = t9 + t17; /* energy = t9 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t19 = x[3]*p[19]; /* omega_n*R*I1 */
    const double t20 = t13*t19; /* s*omega_n*R*I1 */
    out[0] = t18;
    out[1] = t20;
    out[2] = t17;
    out[3] = t9;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*x[0]; /* a3*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = JLT_FNMA(t0, t1, p[2]); /* g - a3*gamma3*omega_tau*omega_tau */
    const double t3 = p[20]*t2; /* m*a3*(g - a3*gamma3*omega_tau*omega_tau) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = x[3]*t4; /* omega_n*b */
    const double t6 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t7 = x[0] + 1.0; /* gamma3 + 1 */
    const double t8 = t6*t7; /* (1 - gamma3)*(gamma3 + 1) */
    const double t9 = sqrt(t8); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t10 = p[1]*x[4]; /* R*omega3 */
    const double t11 = JLT_FMA(t9, t10, t5); /* v_tau = s*R*omega3 + omega_n*b */
    const double t12 = p[0]*t11; /* m*v_tau */
    const double t13 = 1.0/t9; /* 1/s */
    const double t14 = x[0]*t13; /* gamma3*1/s */
    const double t15 = JLT_FNMA(x[4], t14, x[3]); /* omega_n - omega3*gamma3*1/s */
    const double t16 = p[1]*t12; /* R*m*v_tau */
    const double t17 = t15*t16; /* (omega_n - omega3*gamma3*1/s)*R*m*v_tau */
    const double t18 = t3 + t17; /* d(energy)/d(gamma3) = m*a3*(g - a3*gamma3*omega_tau*omega_tau) + (omega_n - omega3*gamma3*1/s)*R*m*v_tau */
    const double t19 = p[0]*x[1]; /* m*v_nu */
    const double t20 = JLT_FMA(t8, p[6], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t21 = x[2]*t20; /* omega_tau*D */
    const double t22 = x[3]*p[4]; /* omega_n*I1 */
    const double t23 = t4*t12; /* b*m*v_tau */
    const double t24 = t22 + t23; /* d(energy)/d(omega_n) = omega_n*I1 + b*m*v_tau */
    const double t25 = t9*p[21]; /* s*m*R */
    const double t26 = t11*t25; /* v_tau*s*m*R */
    const double t27 = x[3]*p[22]; /* omega_n*(-R*I1) */
    const double t28 = t14*t27; /* gamma3*1/s*omega_n*(-R*I1) */
    const double t29 = t9*p[19]; /* s*R*I1 */
    out[0] = t18;
    out[1] = t19;
    out[2] = t21;
    out[3] = t24;
    out[4] = t26;
    out[5] = t28;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t29;
    out[9] = 0.0;
    out[10] = t17;
    out[11] = t19;
    out[12] = 0.0;
    out[13] = t23;
    out[14] = t26;
    out[15] = t3;
    out[16] = 0.0;
    out[17] = t21;
    out[18] = t22;
    out[19] = 0.0;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(t2, p[6], p[4]); /* (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*((1 - gamma3)*(1 + gamma3)*m*a3^2 + I1) */
    out[0] = t5;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(t2, p[6], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t5 = t3*p[10]; /* s*2*m*a3^2 */
    const double t6 = t3*t4; /* s*D */
    const double t7 = 1.0/t6; /* 1/(s*D) */
    const double t8 = t3*t5; /* s*s*2*m*a3^2 */
    const double t9 = t4*t7; /* D*1/(s*D) */
    const double t10 = JLT_FMA(t7, t8, t9); /* 1/(s*D)*s*s*2*m*a3^2 + D*1/(s*D) */
    const double t11 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t12 = t4*t11; /* D*gamma3*omega_tau */
    const double t13 = t10*t12; /* (1/(s*D)*s*s*2*m*a3^2 + D*1/(s*D))*D*gamma3*omega_tau */
    const double t14 = JLT_FMA(t4, t9, t5); /* D*D*1/(s*D) + s*2*m*a3^2 */
    const double t15 = JLT_FNMA(t11, t14, t13); /* (1/(s*D)*s*s*2*m*a3^2 + D*1/(s*D))*D*gamma3*omega_tau - gamma3*omega_tau*(D*D*1/(s*D) + s*2*m*a3^2) */
    const double t16 = t3*t15; /* s*t15 */
    out[0] = t16;
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
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
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
        t14[k] = t5[k]*p[6] + (k == 0 ? p[4] : 0);
        t15[k] = jlt_jet_product(t6, t14, k);
        t16[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t15, t16, k);
        t17[k] = jlt_jet_product(t14, t16, k);
        t18[k] = jlt_jet_product(x3, t17, k);
        t19[k] = jlt_jet_product(t11, t18, k);
        t21[k] = p[1]*x4[k] + t19[k];
        t22[k] = jlt_jet_product(x3, t21, k);
        t24[k] = x2[k]*p[7];
        t25[k] = jlt_jet_product(t7, t24, k);
        t26[k] = t25[k] - jlt_jet_product(x3, t18, k);
        t27[k] = jlt_jet_product(x0, t26, k);
        t29[k] = t27[k] - t6[k]*p[8];
        t30[k] = t6[k]*p[4];
        t31[k] = jlt_jet_product(t16, t30, k);
        t32[k] = jlt_jet_product(t29, t31, k);
        t33[k] = jlt_jet_product(x2, x0, k);
        t34[k] = jlt_jet_product(t18, t33, k);
        t35[k] = jlt_jet_product(x4, t33, k);
        t38[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t39[k] = jlt_jet_product(x2, t38, k) + x1[k];
        t40[k] = p[9]*t39[k];
        t41[k] = t35[k] - jlt_jet_product(t18, t40, k);
        t42[k] = jlt_jet_product(t17, t41, k);
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t22[k]/(k + 1);
        next[2] = x2[k + 1] = t32[k]/(k + 1);
        next[3] = x3[k + 1] = t34[k]/(k + 1);
        next[4] = x4[k + 1] = t42[k]/(k + 1);
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
    .state_count = 5, .param_count = 6, .block_count = 23,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 18, 8, 1, 1, 0, 11, 7 }, { 9, 33, 0, 7, 1, 0, 9, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 25, { 4, 37, 15, 1, 1, 0, 12, 14 }, { 23, 119, 0, 27, 1, 0, 15, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 4, 42, 19, 1, 1, 0, 14, 19 }, { 27, 144, 0, 34, 1, 0, 15, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 7, 2, 1, 1, 0, 8, 5 }, { 3, 12, 0, 2, 1, 0, 9, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 4, { 3, 11, 6, 0, 1, 0, 7, 6 }, { 11, 42, 0, 0, 1, 0, 11, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 20, { 4, 19, 5, 1, 1, 0, 8, 10 }, { 10, 51, 0, 2, 1, 0, 8, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { measure_values, 1, { 2, 2, 1, 0, 1, 0, 4, 3 }, { 2, 6, 0, 0, 1, 0, 7, 4 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_divergences = { measure_divergences, 1, { 2, 9, 4, 1, 1, 0, 10, 8 }, { 7, 30, 0, 3, 1, 0, 11, 7 },
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
