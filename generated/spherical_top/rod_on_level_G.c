/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   18    8    1    1    0     12    8   (50)
 *  jacobian            5   34   17    1    1    0     15   16   (183)
 *  rhs_jacobian        6   42   20    1    1    0     13   19   (216)
 *  divergence          2    5    1    1    1    0      5    4   (15)
 *  integral_values     3   10    6    1    1    0     10    7   (54)
 *  integral_gradients  3   17    7    1    1    0     10   10   (75)
 *  measure_values      2    2    1    0    0    0      4    3   (10)
 *  measure_divergences 2    5    2    1    1    0      6    4   (32)
 *  eliminated          2    2    0    1    1    0      5    3   (6)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_rod_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_on_level_G_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
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
    const double t2 = params[3]*params[3]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    const double t4 = t3/params[4]; /* m*a3*a3/I1 */
    const double t5 = params[0]*params[2]; /* m*g */
    const double t6 = params[3]*t5; /* a3*m*g */
    const double t7 = t6/params[4]; /* a3*m*g/I1 */
    const double t8 = 1.0/params[1]; /* 1/R */
    const double t9 = params[6]*2.0; /* G_level*2 */
    const double t10 = t9/t0; /* G_level*2/(R*I1) */
    const double t11 = params[6]/params[4]; /* G_level/I1 */
    const double t12 = params[0]*2.0; /* m*2 */
    const double t13 = t2*t12; /* a3*a3*m*2 */
    const double t14 = params[3]/params[1]; /* a3/R */
    const double t15 = 2.0/params[1]; /* 2/R */
    const double t16 = params[1]*2.0; /* R*2 */
    const double t17 = params[4]*t16; /* I1*R*2 */
    const double t18 = params[6]/t17; /* G_level/(I1*R*2) */
    const double t19 = params[0]*params[3]; /* m*a3 */
    const double t20 = params[2]*t12; /* g*m*2 */
    const double t21 = params[3]*t20; /* a3*g*m*2 */
    const double t22 = params[0]/2.0; /* m/2 */
    const double t23 = params[6]/params[1]; /* G_level/R */
    const double t24 = params[1]*params[0]; /* R*m */
    const double t25 = params[1]*params[1]; /* R*R */
    const double t26 = params[4]*t25; /* I1*R*R */
    const double t27 = params[6]/t26; /* G_level/(I1*R*R) */
    const double t28 = 1.0/t0; /* 1/(R*I1) */
    const double t29 = params[0]*(-2.0); /* m*(-2) */
    const double t30 = t2*t29; /* a3*a3*m*(-2) */
    const double t31 = t30/t0; /* a3*a3*m*(-2)/(R*I1) */
    out[7] = t1;
    out[8] = t3;
    out[9] = t4;
    out[10] = t7;
    out[11] = t8;
    out[12] = t10;
    out[13] = t11;
    out[14] = t13;
    out[15] = t14;
    out[16] = t15;
    out[17] = t18;
    out[18] = t19;
    out[19] = t21;
    out[20] = t22;
    out[21] = t6;
    out[22] = t23;
    out[23] = t24;
    out[24] = t27;
    out[25] = t28;
    out[26] = t31;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(t2, p[8], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t6 = t3*t5; /* s*D */
    const double t7 = 1.0/t6; /* 1/(s*D) */
    const double t8 = t5*t7; /* D*1/(s*D) */
    const double t9 = p[7]*t8; /* omega_n = G_level/(R*I1)*D*1/(s*D) */
    const double t10 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t11 = t8*t9; /* D*1/(s*D)*omega_n */
    const double t12 = t10*t11; /* b*D*1/(s*D)*omega_n */
    const double t13 = JLT_FMA(p[1], x[3], t12); /* R*omega3 + b*D*1/(s*D)*omega_n */
    const double t14 = t9*t13; /* omega_n*(R*omega3 + b*D*1/(s*D)*omega_n) */
    const double t15 = x[2]*p[9]; /* omega_tau*m*a3^2/I1 */
    const double t16 = t4*t15; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t17 = JLT_FNMA(t9, t11, t16); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*D*1/(s*D)*omega_n */
    const double t18 = x[0]*t17; /* gamma3*(omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*D*1/(s*D)*omega_n) */
    const double t19 = JLT_FNMA(t3, p[10], t18); /* t18 - s*m*g*a3/I1 */
    const double t20 = t3*p[4]; /* s*I1 */
    const double t21 = t7*t20; /* 1/(s*D)*s*I1 */
    const double t22 = t19*t21; /* (t18 - s*m*g*a3/I1)*1/(s*D)*s*I1 */
    const double t23 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t24 = x[3]*t23; /* omega3*omega_tau*gamma3 */
    const double t25 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t26 = JLT_FMA(x[2], t25, x[1]); /* V = omega_tau*e + v_nu */
    const double t27 = p[11]*t26; /* 1/R*V */
    const double t28 = JLT_FNMA(t11, t27, t24); /* omega3*omega_tau*gamma3 - D*1/(s*D)*omega_n*1/R*V */
    const double t29 = t8*t28; /* D*1/(s*D)*(omega3*omega_tau*gamma3 - D*1/(s*D)*omega_n*1/R*V) */
    out[0] = t4;
    out[1] = t14;
    out[2] = t22;
    out[3] = t29;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[8], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = t3*t4; /* D*s */
    const double t6 = 1.0/t5; /* 1/(D*s) */
    const double t7 = t3*t6; /* D*1/(D*s) */
    const double t8 = x[0]*t7; /* gamma3*D*1/(D*s) */
    const double t9 = x[2]*t8; /* omega_tau*gamma3*D*1/(D*s) */
    const double t10 = -t9; /* -omega_tau*gamma3*D*1/(D*s) */
    const double t11 = t7*p[7]; /* omega_n = D*1/(D*s)*G_level/(R*I1) */
    const double t12 = t7*t11; /* D*1/(D*s)*omega_n */
    const double t13 = t11*p[1]; /* omega_n*R */
    const double t14 = t12*t13; /* D*1/(D*s)*omega_n*omega_n*R */
    const double t15 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t16 = t7*t12; /* D*1/(D*s)*D*1/(D*s)*omega_n */
    const double t17 = JLT_FMA(t7, p[12], t11); /* D*1/(D*s)*2*G_level/(R*I1) + omega_n */
    const double t18 = t8*t17; /* gamma3*D*1/(D*s)*(D*1/(D*s)*2*G_level/(R*I1) + omega_n) */
    const double t19 = t15*t16; /* b*D*1/(D*s)*D*1/(D*s)*omega_n */
    const double t20 = t7*t8; /* D*1/(D*s)*gamma3*D*1/(D*s) */
    const double t21 = t7*x[3]; /* D*1/(D*s)*omega3 */
    const double t22 = p[13]*t21; /* G_level/I1*D*1/(D*s)*omega3 */
    const double t23 = JLT_FMA(t20, t22, t14); /* D*1/(D*s)*gamma3*D*1/(D*s)*G_level/I1*D*1/(D*s)*omega3 + D*1/(D*s)*omega_n*omega_n*R */
    const double t24 = JLT_FMA(t18, t19, t23); /* gamma3*D*1/(D*s)*(D*1/(D*s)*2*G_level/(R*I1) + omega_n)*b*D*1/(D*s)*D*1/(D*s)*omega_n + t23 */
    const double t25 = t4*t6; /* s*1/(D*s) */
    const double t26 = x[0]*p[14]; /* gamma3*2*m*a3^2 */
    const double t27 = t25*t26; /* s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t28 = t4*t27; /* s*s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t29 = t28 - t8; /* s*s*1/(D*s)*gamma3*2*m*a3^2 - gamma3*D*1/(D*s) */
    const double t30 = JLT_FMA(x[0], t29, t4); /* gamma3*(s*s*1/(D*s)*gamma3*2*m*a3^2 - gamma3*D*1/(D*s)) + s */
    const double t31 = x[2]*p[9]; /* omega_tau*m*a3^2/I1 */
    const double t32 = x[2]*t31; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t33 = t30*t32; /* (gamma3*(s*s*1/(D*s)*gamma3*2*m*a3^2 - gamma3*D*1/(D*s)) + s)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t34 = t11*t11; /* omega_n*omega_n */
    const double t35 = t8*t27; /* gamma3*D*1/(D*s)*s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t36 = JLT_FMA(t8, t18, t11); /* gamma3*D*1/(D*s)*gamma3*D*1/(D*s)*(D*1/(D*s)*2*G_level/(R*I1) + omega_n) + omega_n */
    const double t37 = JLT_FNMA(t34, t35, t33); /* t33 - omega_n*omega_n*gamma3*D*1/(D*s)*s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t38 = JLT_FNMA(t29, p[10], t37); /* t37 - (s*s*1/(D*s)*gamma3*2*m*a3^2 - gamma3*D*1/(D*s))*m*g*a3/I1 */
    const double t39 = JLT_FNMA(t12, t36, t38); /* t38 - D*1/(D*s)*omega_n*t36 */
    const double t40 = p[4]*t25; /* I1*s*1/(D*s) */
    const double t41 = t39*t40; /* (t38 - D*1/(D*s)*omega_n*t36)*I1*s*1/(D*s) */
    const double t42 = x[2]*t28; /* omega_tau*s*s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t43 = JLT_FNMA(t16, p[15], t21); /* D*1/(D*s)*omega3 - D*1/(D*s)*D*1/(D*s)*omega_n*a3/R */
    const double t44 = x[2]*t43; /* omega_tau*(D*1/(D*s)*omega3 - D*1/(D*s)*D*1/(D*s)*omega_n*a3/R) */
    const double t45 = t9*x[3]; /* omega_tau*gamma3*D*1/(D*s)*omega3 */
    const double t46 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t47 = JLT_FMA(x[2], t46, x[1]); /* V = omega_tau*e + v_nu */
    const double t48 = t7*p[17]; /* D*1/(D*s)*1/2*G_level/(R*I1) */
    const double t49 = t7*t7; /* D*1/(D*s)*D*1/(D*s) */
    const double t50 = JLT_FMA(t48, t49, t16); /* D*1/(D*s)*1/2*G_level/(R*I1)*D*1/(D*s)*D*1/(D*s) + D*1/(D*s)*D*1/(D*s)*omega_n */
    const double t51 = p[16]*t47; /* 2/R*V */
    const double t52 = JLT_FNMA(t50, t51, t45); /* omega_tau*gamma3*D*1/(D*s)*omega3 - t50*2/R*V */
    const double t53 = JLT_FMA(t20, t52, t44); /* D*1/(D*s)*gamma3*D*1/(D*s)*(omega_tau*gamma3*D*1/(D*s)*omega3 - t50*2/R*V) + t44 */
    const double t54 = t16*p[11]; /* D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t55 = -t54; /* -D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t56 = t46*t54; /* e*D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t57 = JLT_FMS(t8, x[3], t56); /* gamma3*D*1/(D*s)*omega3 - e*D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    out[0] = t10;
    out[1] = 0.0;
    out[2] = t4;
    out[3] = 0.0;
    out[4] = t24;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t13;
    out[8] = t41;
    out[9] = 0.0;
    out[10] = t42;
    out[11] = 0.0;
    out[12] = t53;
    out[13] = t55;
    out[14] = t57;
    out[15] = t9;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(t2, p[8], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t6 = t3*t5; /* s*D */
    const double t7 = 1.0/t6; /* 1/(s*D) */
    const double t8 = t5*t7; /* D*1/(s*D) */
    const double t9 = p[7]*t8; /* omega_n = G_level/(R*I1)*D*1/(s*D) */
    const double t10 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t11 = t8*t9; /* D*1/(s*D)*omega_n */
    const double t12 = t9*t10; /* omega_n*b */
    const double t13 = t11*t12; /* D*1/(s*D)*omega_n*omega_n*b */
    const double t14 = t9*p[1]; /* omega_n*R */
    const double t15 = JLT_FMA(x[3], t14, t13); /* omega3*omega_n*R + D*1/(s*D)*omega_n*omega_n*b */
    const double t16 = t3*t7; /* s*1/(s*D) */
    const double t17 = t3*t16; /* s*s*1/(s*D) */
    const double t18 = x[0]*p[3]; /* gamma3*a3 */
    const double t19 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t20 = JLT_FNMA(t18, t19, p[2]); /* g - gamma3*a3*omega_tau*omega_tau */
    const double t21 = p[18]*t20; /* m*a3*(g - gamma3*a3*omega_tau*omega_tau) */
    const double t22 = t17*t21; /* s*s*1/(s*D)*m*a3*(g - gamma3*a3*omega_tau*omega_tau) */
    const double t23 = x[0]*t8; /* gamma3*D*1/(s*D) */
    const double t24 = t9*t16; /* omega_n*s*1/(s*D) */
    const double t25 = t9*t23; /* omega_n*gamma3*D*1/(s*D) */
    const double t26 = t24*t25; /* omega_n*s*1/(s*D)*omega_n*gamma3*D*1/(s*D) */
    const double t27 = JLT_FMA(p[4], t26, t22); /* I1*omega_n*s*1/(s*D)*omega_n*gamma3*D*1/(s*D) + s*s*1/(s*D)*m*a3*(g - gamma3*a3*omega_tau*omega_tau) */
    const double t28 = -t27; /* -t27 */
    const double t29 = p[1] + t18; /* e = R + gamma3*a3 */
    const double t30 = JLT_FMA(x[2], t29, x[1]); /* V = omega_tau*e + v_nu */
    const double t31 = t8*t11; /* D*1/(s*D)*D*1/(s*D)*omega_n */
    const double t32 = p[11]*t31; /* 1/R*D*1/(s*D)*D*1/(s*D)*omega_n */
    const double t33 = t30*t32; /* V*1/R*D*1/(s*D)*D*1/(s*D)*omega_n */
    const double t34 = x[3]*t23; /* omega3*gamma3*D*1/(s*D) */
    const double t35 = JLT_FMS(x[2], t34, t33); /* omega_tau*omega3*gamma3*D*1/(s*D) - V*1/R*D*1/(s*D)*D*1/(s*D)*omega_n */
    const double t36 = x[2]*t23; /* omega_tau*gamma3*D*1/(s*D) */
    const double t37 = -t36; /* -omega_tau*gamma3*D*1/(s*D) */
    const double t38 = t11*t14; /* D*1/(s*D)*omega_n*omega_n*R */
    const double t39 = JLT_FMA(t8, p[12], t9); /* D*1/(s*D)*2*G_level/(R*I1) + omega_n */
    const double t40 = t23*t39; /* gamma3*D*1/(s*D)*(D*1/(s*D)*2*G_level/(R*I1) + omega_n) */
    const double t41 = t10*t31; /* b*D*1/(s*D)*D*1/(s*D)*omega_n */
    const double t42 = t8*t8; /* D*1/(s*D)*D*1/(s*D) */
    const double t43 = p[13]*t42; /* G_level/I1*D*1/(s*D)*D*1/(s*D) */
    const double t44 = JLT_FMA(t34, t43, t38); /* omega3*gamma3*D*1/(s*D)*G_level/I1*D*1/(s*D)*D*1/(s*D) + D*1/(s*D)*omega_n*omega_n*R */
    const double t45 = JLT_FMA(t40, t41, t44); /* gamma3*D*1/(s*D)*(D*1/(s*D)*2*G_level/(R*I1) + omega_n)*b*D*1/(s*D)*D*1/(s*D)*omega_n + t44 */
    const double t46 = x[2]*t17; /* omega_tau*s*s*1/(s*D) */
    const double t47 = x[2]*p[8]; /* omega_tau*m*a3^2 */
    const double t48 = t46*t47; /* omega_tau*s*s*1/(s*D)*omega_tau*m*a3^2 */
    const double t49 = x[0]*p[14]; /* gamma3*2*m*a3^2 */
    const double t50 = JLT_FMS(t17, t49, t23); /* s*s*1/(s*D)*gamma3*2*m*a3^2 - gamma3*D*1/(s*D) */
    const double t51 = t21*t50; /* m*a3*(g - gamma3*a3*omega_tau*omega_tau)*(s*s*1/(s*D)*gamma3*2*m*a3^2 - gamma3*D*1/(s*D)) */
    const double t52 = t26*t49; /* omega_n*s*1/(s*D)*omega_n*gamma3*D*1/(s*D)*gamma3*2*m*a3^2 */
    const double t53 = JLT_FMA(t23, t40, t9); /* gamma3*D*1/(s*D)*gamma3*D*1/(s*D)*(D*1/(s*D)*2*G_level/(R*I1) + omega_n) + omega_n */
    const double t54 = JLT_FMA(t11, t53, t52); /* D*1/(s*D)*omega_n*t53 + omega_n*s*1/(s*D)*omega_n*gamma3*D*1/(s*D)*gamma3*2*m*a3^2 */
    const double t55 = JLT_FMA(p[4], t54, t51); /* I1*t54 + t51 */
    const double t56 = JLT_FNMA(t16, t55, t48); /* omega_tau*s*s*1/(s*D)*omega_tau*m*a3^2 - s*1/(s*D)*(I1*t54 + t51) */
    const double t57 = t46*t49; /* omega_tau*s*s*1/(s*D)*gamma3*2*m*a3^2 */
    const double t58 = x[2]*p[15]; /* omega_tau*a3/R */
    const double t59 = t31*t58; /* D*1/(s*D)*D*1/(s*D)*omega_n*omega_tau*a3/R */
    const double t60 = JLT_FMA(t23, t34, x[3]); /* gamma3*D*1/(s*D)*omega3*gamma3*D*1/(s*D) + omega3 */
    const double t61 = x[2]*t60; /* omega_tau*(gamma3*D*1/(s*D)*omega3*gamma3*D*1/(s*D) + omega3) */
    const double t62 = t8*p[17]; /* D*1/(s*D)*1/2*G_level/(R*I1) */
    const double t63 = JLT_FMA(t42, t62, t31); /* D*1/(s*D)*D*1/(s*D)*D*1/(s*D)*1/2*G_level/(R*I1) + D*1/(s*D)*D*1/(s*D)*omega_n */
    const double t64 = t30*p[16]; /* V*2/R */
    const double t65 = t23*t64; /* gamma3*D*1/(s*D)*V*2/R */
    const double t66 = JLT_FNMA(t63, t65, t61); /* t61 - t63*gamma3*D*1/(s*D)*V*2/R */
    const double t67 = JLT_FMS(t8, t66, t59); /* D*1/(s*D)*(t61 - t63*gamma3*D*1/(s*D)*V*2/R) - D*1/(s*D)*D*1/(s*D)*omega_n*omega_tau*a3/R */
    const double t68 = -t32; /* -1/R*D*1/(s*D)*D*1/(s*D)*omega_n */
    const double t69 = JLT_FNMA(t29, t32, t34); /* omega3*gamma3*D*1/(s*D) - e*1/R*D*1/(s*D)*D*1/(s*D)*omega_n */
    out[0] = t4;
    out[1] = t15;
    out[2] = t28;
    out[3] = t35;
    out[4] = t37;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t45;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t14;
    out[12] = t56;
    out[13] = 0.0;
    out[14] = t57;
    out[15] = 0.0;
    out[16] = t67;
    out[17] = t68;
    out[18] = t69;
    out[19] = t36;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[8], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = 1.0/t4; /* 1/D */
    const double t6 = p[14]*x[0]; /* 2*m*a3^2*gamma3 */
    const double t7 = x[2]*t6; /* omega_tau*2*m*a3^2*gamma3 */
    const double t8 = t3*t7; /* s*omega_tau*2*m*a3^2*gamma3 */
    const double t9 = t5*t8; /* 1/D*s*omega_tau*2*m*a3^2*gamma3 */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[19]*x[0]; /* 2*m*g*a3*gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[8], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t6 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = 1.0/t6; /* 1/s */
    const double t8 = p[7]*t7; /* omega_n = G_level/(R*I1)*1/s */
    const double t9 = p[4]*t8; /* I1*omega_n */
    const double t10 = JLT_FMA(t4, t5, t0); /* D*omega_tau*omega_tau + 2*m*g*a3*gamma3 */
    const double t11 = JLT_FMA(t8, t9, t10); /* omega_n*I1*omega_n + D*omega_tau*omega_tau + 2*m*g*a3*gamma3 */
    const double t12 = (1.0 / 2.0)*t11; /* 1/2*(omega_n*I1*omega_n + D*omega_tau*omega_tau + 2*m*g*a3*gamma3) */
    const double t13 = x[1]*x[1]; /* v_nu*v_nu */
    const double t14 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t15 = t8*t14; /* omega_n*b */
    const double t16 = p[1]*x[3]; /* R*omega3 */
    const double t17 = JLT_FMA(t6, t16, t15); /* v_tau = s*R*omega3 + omega_n*b */
    const double t18 = JLT_FMA(t17, t17, t13); /* v_tau*v_tau + v_nu*v_nu */
    const double t19 = p[20]*t18; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t20 = t12 + t19; /* energy = t12 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[0] = t20;
    out[1] = t19;
    out[2] = t12;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[8]*x[2]; /* m*a3^2*omega_tau */
    const double t1 = x[2]*t0; /* omega_tau*m*a3^2*omega_tau */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = 1.0/t5; /* 1/s */
    const double t7 = p[7]*t6; /* omega_n = G_level/(R*I1)*1/s */
    const double t8 = t6*t6; /* 1/s*1/s */
    const double t9 = p[22]*t6; /* G_level/R*1/s */
    const double t10 = t7*t9; /* omega_n*G_level/R*1/s */
    const double t11 = JLT_FNMA(t8, t10, t1); /* omega_tau*m*a3^2*omega_tau - 1/s*1/s*omega_n*G_level/R*1/s */
    const double t12 = JLT_FNMA(x[0], t11, p[21]); /* m*g*a3 - gamma3*(omega_tau*m*a3^2*omega_tau - 1/s*1/s*omega_n*G_level/R*1/s) */
    const double t13 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t14 = t7*t13; /* omega_n*b */
    const double t15 = p[1]*x[3]; /* R*omega3 */
    const double t16 = JLT_FMA(t5, t15, t14); /* v_tau = s*R*omega3 + omega_n*b */
    const double t17 = t13*p[24]; /* b*G_level/(R^2*I1) */
    const double t18 = JLT_FMS(t8, t17, x[3]); /* 1/s*1/s*b*G_level/(R^2*I1) - omega3 */
    const double t19 = x[0]*t6; /* gamma3*1/s */
    const double t20 = JLT_FMA(t18, t19, t7); /* (1/s*1/s*b*G_level/(R^2*I1) - omega3)*gamma3*1/s + omega_n */
    const double t21 = p[23]*t16; /* m*R*v_tau */
    const double t22 = t20*t21; /* ((1/s*1/s*b*G_level/(R^2*I1) - omega3)*gamma3*1/s + omega_n)*m*R*v_tau */
    const double t23 = t12 + t22; /* d(energy)/d(gamma3) = t12 + t22 */
    const double t24 = p[0]*x[1]; /* m*v_nu */
    const double t25 = JLT_FMA(p[8], t4, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t26 = x[2]*t25; /* omega_tau*D */
    const double t27 = t5*p[23]; /* s*m*R */
    const double t28 = t16*t27; /* v_tau*s*m*R */
    out[0] = t23;
    out[1] = t24;
    out[2] = t26;
    out[3] = t28;
    out[4] = t22;
    out[5] = t24;
    out[6] = 0.0;
    out[7] = t28;
    out[8] = t12;
    out[9] = 0.0;
    out[10] = t26;
    out[11] = 0.0;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = p[8]*t0; /* m*a3^2*(1 - gamma3) */
    const double t3 = JLT_FMA(t1, t2, p[4]); /* (1 + gamma3)*m*a3^2*(1 - gamma3) + I1 */
    const double t4 = p[25]*t3; /* 1/(R*I1)*((1 + gamma3)*m*a3^2*(1 - gamma3) + I1) */
    out[0] = t4;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[8], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = 1.0/t4; /* 1/D */
    const double t6 = JLT_FNMA(t4, t5, 1.0); /* 1 - D*1/D */
    const double t7 = p[26]*x[0]; /* (-2*m*a3^2/(R*I1))*gamma3 */
    const double t8 = x[2]*t7; /* omega_tau*(-2*m*a3^2/(R*I1))*gamma3 */
    const double t9 = t3*t8; /* s*omega_tau*(-2*m*a3^2/(R*I1))*gamma3 */
    const double t10 = t6*t9; /* (1 - D*1/D)*s*omega_tau*(-2*m*a3^2/(R*I1))*gamma3 */
    out[0] = t10;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = 1.0/t3; /* 1/s */
    const double t5 = p[7]*t4; /* G_level/(R*I1)*1/s */
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
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
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
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t11[k] = t5[k]*p[8] + (k == 0 ? p[4] : 0);
        t12[k] = jlt_jet_product(t6, t11, k);
        t13[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t12, t13, k);
        t14[k] = jlt_jet_product(t11, t13, k);
        t15[k] = p[7]*t14[k];
        t18[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t19[k] = jlt_jet_product(t14, t15, k);
        t20[k] = jlt_jet_product(t18, t19, k);
        t22[k] = p[1]*x3[k] + t20[k];
        t23[k] = jlt_jet_product(t15, t22, k);
        t25[k] = x2[k]*p[9];
        t26[k] = jlt_jet_product(t7, t25, k);
        t27[k] = t26[k] - jlt_jet_product(t15, t19, k);
        t28[k] = jlt_jet_product(x0, t27, k);
        t30[k] = t28[k] - t6[k]*p[10];
        t31[k] = t6[k]*p[4];
        t32[k] = jlt_jet_product(t13, t31, k);
        t33[k] = jlt_jet_product(t30, t32, k);
        t34[k] = jlt_jet_product(x2, x0, k);
        t35[k] = jlt_jet_product(x3, t34, k);
        t38[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t39[k] = jlt_jet_product(x2, t38, k) + x1[k];
        t40[k] = p[11]*t39[k];
        t41[k] = t35[k] - jlt_jet_product(t19, t40, k);
        t42[k] = jlt_jet_product(t14, t41, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t23[k]/(k + 1);
        next[2] = x2[k + 1] = t33[k]/(k + 1);
        next[3] = x3[k + 1] = t42[k]/(k + 1);
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
    const double v_I3 = (0.0);
    const double complex v_omega3 = x[3];
    const double v_a3 = params[3];
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "E1", "I3 = 0" },
    { "E2", "I3 = 0" },
};

static const jlt_named measures[] = {
    { "rho", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_rod_on_level_G = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 27,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 2, 18, 8, 1, 1, 0, 12, 8 }, { 9, 33, 0, 7, 1, 0, 9, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 5, 34, 17, 1, 1, 0, 15, 16 }, { 24, 133, 0, 25, 1, 0, 16, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 6, 42, 20, 1, 1, 0, 13, 19 }, { 28, 156, 0, 31, 1, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 5, 1, 1, 1, 0, 5, 4 }, { 2, 11, 0, 1, 1, 0, 7, 4 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 3, 10, 6, 1, 1, 0, 10, 7 }, { 11, 41, 0, 1, 1, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 12, { 3, 17, 7, 1, 1, 0, 10, 10 }, { 11, 58, 0, 5, 1, 0, 11, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { measure_values, 1, { 2, 2, 1, 0, 0, 0, 4, 3 }, { 2, 6, 0, 1, 1, 0, 7, 4 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_divergences = { measure_divergences, 1, { 2, 5, 2, 1, 1, 0, 6, 4 }, { 4, 25, 0, 2, 1, 0, 10, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 2, 0, 1, 1, 0, 5, 3 }, { 1, 3, 0, 1, 1, 0, 5, 3 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 3, .measure_count = 1, .equilibria_count = 0,
    .integrals = integrals,
    .measures = measures,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_rod_on_level_G_baseline,
        &jlt_batch_spherical_top_rod_on_level_G_avx2,
        &jlt_batch_spherical_top_rod_on_level_G_avx512,
    },
};
