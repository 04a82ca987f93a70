/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   19    8    1    0    0      9    9   (50)
 *  jacobian            6   37   11    1    0    0     13   11   (146)
 *  rhs_jacobian        6   41   17    1    0    0     11   19   (182)
 *  divergence          0    5    1    1    0    0      4    4   (13)
 *  integral_values     1   10    6    1    0    0      7    6   (51)
 *  integral_gradients  4   17    4    1    0    0      7    9   (67)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    1    0    1    0    0      2    2   (3)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_on_level_G_avx512;

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
    const double t11 = params[0]*2.0; /* m*2 */
    const double t12 = t2*t11; /* a3*a3*m*2 */
    const double t13 = t9/params[1]; /* G_level*2/R */
    const double t14 = params[4]*2.0; /* I1*2 */
    const double t15 = params[3]/params[1]; /* a3/R */
    const double t16 = params[6]/params[4]; /* G_level/I1 */
    const double t17 = params[2]*t11; /* g*m*2 */
    const double t18 = params[3]*t17; /* a3*g*m*2 */
    const double t19 = params[0]*params[0]; /* m*m */
    const double t20 = 2.0*t19; /* 2*m*m */
    const double t21 = params[2]*t20; /* g*2*m*m */
    const double t22 = params[3]*t2; /* a3*a3*a3 */
    const double t23 = t21*t22; /* g*2*m*m*a3*a3*a3 */
    const double t24 = params[1]*params[1]; /* R*R */
    const double t25 = params[4]*t24; /* I1*R*R */
    const double t26 = params[6]/t25; /* G_level/(I1*R*R) */
    const double t27 = params[0]/2.0; /* m/2 */
    const double t28 = params[1]*params[0]; /* R*m */
    const double t29 = params[6]/params[1]; /* G_level/R */
    const double t30 = -params[4]; /* -I1 */
    out[7] = t1;
    out[8] = t3;
    out[9] = t4;
    out[10] = t7;
    out[11] = t8;
    out[12] = t10;
    out[13] = t12;
    out[14] = t13;
    out[15] = t14;
    out[16] = t6;
    out[17] = t15;
    out[18] = t16;
    out[19] = t18;
    out[20] = t23;
    out[21] = t26;
    out[22] = t27;
    out[23] = t28;
    out[24] = t29;
    out[25] = t30;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = JLT_FMA(t0, p[8], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t4 = x[4]*t3; /* s*D */
    const double t5 = 1.0/t4; /* 1/(s*D) */
    const double t6 = t3*t5; /* D*1/(s*D) */
    const double t7 = p[7]*t6; /* omega_n = G_level/(R*I1)*D*1/(s*D) */
    const double t8 = t7*t7; /* omega_n*omega_n */
    const double t9 = t2*t8; /* b*omega_n*omega_n */
    const double t10 = x[4]*p[1]; /* s*R */
    const double t11 = x[3]*t10; /* omega3*s*R */
    const double t12 = JLT_FMA(t7, t11, t9); /* omega_n*omega3*s*R + b*omega_n*omega_n */
    const double t13 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t14 = p[9]*t13; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t15 = t1*t14; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t16 = JLT_FNMA(t0, p[10], t15); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - s*s*m*g*a3/I1 */
    const double t17 = JLT_FNMA(x[0], t8, t16); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - s*s*m*g*a3/I1 - gamma3*omega_n*omega_n */
    const double t18 = x[4]*p[4]; /* s*I1 */
    const double t19 = t5*t18; /* 1/(s*D)*s*I1 */
    const double t20 = t17*t19; /* t17*1/(s*D)*s*I1 */
    const double t21 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t22 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t23 = p[11]*t22; /* 1/R*V */
    const double t24 = t6*t23; /* D*1/(s*D)*1/R*V */
    const double t25 = t7*t24; /* omega_n*D*1/(s*D)*1/R*V */
    const double t26 = JLT_FMS(x[3], t13, t25); /* omega3*omega_tau*gamma3 - omega_n*D*1/(s*D)*1/R*V */
    const double t27 = x[4]*t13; /* s*omega_tau*gamma3 */
    const double t28 = -t27; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t12;
    out[2] = t20;
    out[3] = t26;
    out[4] = t28;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = JLT_FMA(t0, p[8], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t4 = x[4]*t3; /* s*D */
    const double t5 = 1.0/t4; /* 1/(s*D) */
    const double t6 = t3*t5; /* D*1/(s*D) */
    const double t7 = p[7]*t6; /* G_level/(R*I1)*D*1/(s*D) */
    const double t8 = t7*t7; /* G_level/(R*I1)*D*1/(s*D)*G_level/(R*I1)*D*1/(s*D) */
    const double t9 = p[1]*t8; /* R*G_level/(R*I1)*D*1/(s*D)*G_level/(R*I1)*D*1/(s*D) */
    const double t10 = x[4]*p[1]; /* s*R */
    const double t11 = t7*t10; /* G_level/(R*I1)*D*1/(s*D)*s*R */
    const double t12 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t13 = t6*t7; /* D*1/(s*D)*G_level/(R*I1)*D*1/(s*D) */
    const double t14 = t6*t13; /* D*1/(s*D)*D*1/(s*D)*G_level/(R*I1)*D*1/(s*D) */
    const double t15 = p[12]*t12; /* 2*G_level/(R*I1)*b */
    const double t16 = t14*t15; /* D*1/(s*D)*D*1/(s*D)*G_level/(R*I1)*D*1/(s*D)*2*G_level/(R*I1)*b */
    const double t17 = -t16; /* -t16 */
    const double t18 = t1*p[9]; /* s*omega_tau*m*a3^2/I1 */
    const double t19 = JLT_FMS(t1, t18, t8); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - G_level/(R*I1)*D*1/(s*D)*G_level/(R*I1)*D*1/(s*D) */
    const double t20 = x[4]*t5; /* s*1/(s*D) */
    const double t21 = p[4]*t20; /* I1*s*1/(s*D) */
    const double t22 = t19*t21; /* t19*I1*s*1/(s*D) */
    const double t23 = x[4]*t20; /* s*s*1/(s*D) */
    const double t24 = p[13]*t23; /* 2*m*a3^2*s*s*1/(s*D) */
    const double t25 = t1*x[0]; /* s*omega_tau*gamma3 */
    const double t26 = t24*t25; /* 2*m*a3^2*s*s*1/(s*D)*s*omega_tau*gamma3 */
    const double t27 = t14*p[14]; /* D*1/(s*D)*D*1/(s*D)*G_level/(R*I1)*D*1/(s*D)*2*G_level/R */
    const double t28 = JLT_FNMA(x[4], t24, 2.0); /* 2 - s*2*m*a3^2*s*s*1/(s*D) */
    const double t29 = x[2]*t1; /* omega_tau*s*omega_tau */
    const double t30 = t28*t29; /* (2 - s*2*m*a3^2*s*s*1/(s*D))*omega_tau*s*omega_tau */
    const double t31 = t23*p[15]; /* s*s*1/(s*D)*2*I1 */
    const double t32 = JLT_FMA(t8, t31, t30); /* G_level/(R*I1)*D*1/(s*D)*G_level/(R*I1)*D*1/(s*D)*s*s*1/(s*D)*2*I1 + (2 - s*2*m*a3^2*s*s*1/(s*D))*omega_tau*s*omega_tau */
    const double t33 = JLT_FMA(p[8], t32, t27); /* m*a3^2*t32 + D*1/(s*D)*D*1/(s*D)*G_level/(R*I1)*D*1/(s*D)*2*G_level/R */
    const double t34 = x[0]*t20; /* gamma3*s*1/(s*D) */
    const double t35 = t33*t34; /* t33*gamma3*s*1/(s*D) */
    const double t36 = t23*p[16]; /* s*s*1/(s*D)*m*g*a3 */
    const double t37 = JLT_FNMA(t28, t36, t35); /* t33*gamma3*s*1/(s*D) - (2 - s*2*m*a3^2*s*s*1/(s*D))*s*s*1/(s*D)*m*g*a3 */
    const double t38 = JLT_FNMA(t13, p[17], x[3]); /* omega3 - D*1/(s*D)*G_level/(R*I1)*D*1/(s*D)*a3/R */
    const double t39 = x[2]*t38; /* omega_tau*(omega3 - D*1/(s*D)*G_level/(R*I1)*D*1/(s*D)*a3/R) */
    const double t40 = t13*p[11]; /* D*1/(s*D)*G_level/(R*I1)*D*1/(s*D)*1/R */
    const double t41 = -t40; /* -D*1/(s*D)*G_level/(R*I1)*D*1/(s*D)*1/R */
    const double t42 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t43 = t40*t42; /* D*1/(s*D)*G_level/(R*I1)*D*1/(s*D)*1/R*e */
    const double t44 = JLT_FMS(x[3], x[0], t43); /* omega3*gamma3 - D*1/(s*D)*G_level/(R*I1)*D*1/(s*D)*1/R*e */
    const double t45 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t46 = JLT_FMA(x[2], t42, x[1]); /* V = omega_tau*e + v_nu */
    const double t47 = t13 + t13; /* D*1/(s*D)*G_level/(R*I1)*D*1/(s*D) + D*1/(s*D)*G_level/(R*I1)*D*1/(s*D) */
    const double t48 = p[11]*t46; /* 1/R*V */
    const double t49 = t6*t48; /* D*1/(s*D)*1/R*V */
    const double t50 = t47*t49; /* t47*D*1/(s*D)*1/R*V */
    const double t51 = -t1; /* -s*omega_tau */
    const double t52 = x[4]*x[0]; /* s*gamma3 */
    const double t53 = -t52; /* -s*gamma3 */
    const double t54 = -t45; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t9;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t11;
    out[9] = t17;
    out[10] = t22;
    out[11] = 0.0;
    out[12] = t26;
    out[13] = 0.0;
    out[14] = t37;
    out[15] = t39;
    out[16] = t41;
    out[17] = t44;
    out[18] = t45;
    out[19] = t50;
    out[20] = t51;
    out[21] = 0.0;
    out[22] = t53;
    out[23] = 0.0;
    out[24] = t54;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[4]*x[4]; /* s*s */
    const double t4 = JLT_FMA(p[8], t3, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t5 = x[4]*t4; /* s*D */
    const double t6 = 1.0/t5; /* 1/(s*D) */
    const double t7 = t4*t6; /* D*1/(s*D) */
    const double t8 = p[7]*t7; /* omega_n = G_level/(R*I1)*D*1/(s*D) */
    const double t9 = t8*t8; /* omega_n*omega_n */
    const double t10 = t2*t9; /* b*omega_n*omega_n */
    const double t11 = p[1]*t8; /* R*omega_n */
    const double t12 = x[4]*t11; /* s*R*omega_n */
    const double t13 = JLT_FMA(x[3], t12, t10); /* omega3*s*R*omega_n + b*omega_n*omega_n */
    const double t14 = x[4]*t6; /* s*1/(s*D) */
    const double t15 = x[0]*t14; /* gamma3*s*1/(s*D) */
    const double t16 = t0*p[9]; /* s*omega_tau*m*a3^2/I1 */
    const double t17 = JLT_FMS(t0, t16, t9); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n */
    const double t18 = p[4]*t17; /* I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t19 = t15*t18; /* gamma3*s*1/(s*D)*I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t20 = x[4]*t14; /* s*s*1/(s*D) */
    const double t21 = x[4]*t20; /* s*s*s*1/(s*D) */
    const double t22 = JLT_FNMA(p[16], t21, t19); /* t19 - m*g*a3*s*s*s*1/(s*D) */
    const double t23 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t24 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t25 = t7*t8; /* D*1/(s*D)*omega_n */
    const double t26 = p[11]*t25; /* 1/R*D*1/(s*D)*omega_n */
    const double t27 = t24*t26; /* V*1/R*D*1/(s*D)*omega_n */
    const double t28 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t29 = JLT_FMS(x[3], t28, t27); /* omega3*omega_tau*gamma3 - V*1/R*D*1/(s*D)*omega_n */
    const double t30 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t31 = -t30; /* -s*omega_tau*gamma3 */
    const double t32 = t0*2.0; /* s*omega_tau*2 */
    const double t33 = p[1]*t9; /* R*omega_n*omega_n */
    const double t34 = JLT_FMS(t7, p[18], t11); /* D*1/(s*D)*G_level/I1 - R*omega_n */
    const double t35 = x[3]*t34; /* omega3*(D*1/(s*D)*G_level/I1 - R*omega_n) */
    const double t36 = t7*t25; /* D*1/(s*D)*D*1/(s*D)*omega_n */
    const double t37 = t2*p[12]; /* b*2*G_level/(R*I1) */
    const double t38 = JLT_FMA(t36, t37, t35); /* D*1/(s*D)*D*1/(s*D)*omega_n*b*2*G_level/(R*I1) + omega3*(D*1/(s*D)*G_level/I1 - R*omega_n) */
    const double t39 = -t38; /* -t38 */
    const double t40 = t14*t18; /* s*1/(s*D)*I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t41 = t30*p[13]; /* s*omega_tau*gamma3*2*m*a3^2 */
    const double t42 = t20*t41; /* s*s*1/(s*D)*s*omega_tau*gamma3*2*m*a3^2 */
    const double t43 = t36*p[14]; /* D*1/(s*D)*D*1/(s*D)*omega_n*2*G_level/R */
    const double t44 = x[2]*t32; /* omega_tau*s*omega_tau*2 */
    const double t45 = t20*p[15]; /* s*s*1/(s*D)*2*I1 */
    const double t46 = JLT_FNMA(t17, t45, t44); /* omega_tau*s*omega_tau*2 - (s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n)*s*s*1/(s*D)*2*I1 */
    const double t47 = JLT_FMA(p[8], t46, t43); /* m*a3^2*t46 + D*1/(s*D)*D*1/(s*D)*omega_n*2*G_level/R */
    const double t48 = t20*p[19]; /* s*s*1/(s*D)*2*m*g*a3 */
    const double t49 = t20*p[20]; /* s*s*1/(s*D)*2*m^2*g*a3^3 */
    const double t50 = JLT_FMS(t21, t49, t48); /* s*s*s*1/(s*D)*s*s*1/(s*D)*2*m^2*g*a3^3 - s*s*1/(s*D)*2*m*g*a3 */
    const double t51 = JLT_FMA(t15, t47, t50); /* gamma3*s*1/(s*D)*(m*a3^2*t46 + D*1/(s*D)*D*1/(s*D)*omega_n*2*G_level/R) + t50 */
    const double t52 = JLT_FNMA(t25, p[17], x[3]); /* omega3 - D*1/(s*D)*omega_n*a3/R */
    const double t53 = x[2]*t52; /* omega_tau*(omega3 - D*1/(s*D)*omega_n*a3/R) */
    const double t54 = -t26; /* -1/R*D*1/(s*D)*omega_n */
    const double t55 = t23*t26; /* e*1/R*D*1/(s*D)*omega_n */
    const double t56 = JLT_FMS(x[0], x[3], t55); /* gamma3*omega3 - e*1/R*D*1/(s*D)*omega_n */
    const double t57 = t7*p[21]; /* D*1/(s*D)*G_level/(R^2*I1) */
    const double t58 = JLT_FMA(t7, t57, t26); /* D*1/(s*D)*D*1/(s*D)*G_level/(R^2*I1) + 1/R*D*1/(s*D)*omega_n */
    const double t59 = t7*t24; /* D*1/(s*D)*V */
    const double t60 = t58*t59; /* (D*1/(s*D)*D*1/(s*D)*G_level/(R^2*I1) + 1/R*D*1/(s*D)*omega_n)*D*1/(s*D)*V */
    const double t61 = -t0; /* -s*omega_tau */
    const double t62 = x[4]*x[0]; /* s*gamma3 */
    const double t63 = -t62; /* -s*gamma3 */
    const double t64 = -t28; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t13;
    out[2] = t22;
    out[3] = t29;
    out[4] = t31;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t3;
    out[8] = 0.0;
    out[9] = t32;
    out[10] = t33;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t12;
    out[14] = t39;
    out[15] = t40;
    out[16] = 0.0;
    out[17] = t42;
    out[18] = 0.0;
    out[19] = t51;
    out[20] = t53;
    out[21] = t54;
    out[22] = t56;
    out[23] = t28;
    out[24] = t60;
    out[25] = t61;
    out[26] = 0.0;
    out[27] = t63;
    out[28] = 0.0;
    out[29] = t64;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[8], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t2 = 1.0/t1; /* 1/D */
    const double t3 = p[13]*x[0]; /* 2*m*a3^2*gamma3 */
    const double t4 = x[2]*t3; /* omega_tau*2*m*a3^2*gamma3 */
    const double t5 = t0*t4; /* s*s*omega_tau*2*m*a3^2*gamma3 */
    const double t6 = t2*t5; /* 1/D*s*s*omega_tau*2*m*a3^2*gamma3 */
    out[0] = t6;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[19]*x[0]; /* 2*m*g*a3*gamma3 */
    const double t1 = p[8]*x[4]; /* m*a3^2*s */
    const double t2 = JLT_FMA(x[4], t1, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t3 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t4 = 1.0/x[4]; /* 1/s */
    const double t5 = p[7]*t4; /* omega_n = G_level/(R*I1)*1/s */
    const double t6 = p[4]*t5; /* I1*omega_n */
    const double t7 = JLT_FMA(t2, t3, t0); /* D*omega_tau*omega_tau + 2*m*g*a3*gamma3 */
    const double t8 = JLT_FMA(t5, t6, t7); /* omega_n*I1*omega_n + D*omega_tau*omega_tau + 2*m*g*a3*gamma3 */
    const double t9 = (1.0 / 2.0)*t8; /* 1/2*(omega_n*I1*omega_n + D*omega_tau*omega_tau + 2*m*g*a3*gamma3) */
    const double t10 = x[1]*x[1]; /* v_nu*v_nu */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = t5*t11; /* omega_n*b */
    const double t13 = x[4]*p[1]; /* s*R */
    const double t14 = JLT_FMA(x[3], t13, t12); /* v_tau = omega3*s*R + omega_n*b */
    const double t15 = JLT_FMA(t14, t14, t10); /* v_tau*v_tau + v_nu*v_nu */
    const double t16 = p[22]*t15; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t17 = t9 + t16; /* energy = t9 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    out[0] = t17;
    out[1] = t16;
    out[2] = t9;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[4]; /* 1/s */
    const double t1 = p[7]*t0; /* omega_n = G_level/(R*I1)*1/s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = t1*t2; /* omega_n*b */
    const double t4 = p[1]*x[3]; /* R*omega3 */
    const double t5 = JLT_FMA(x[4], t4, t3); /* v_tau = s*R*omega3 + omega_n*b */
    const double t6 = p[23]*t5; /* m*R*v_tau */
    const double t7 = t1*t6; /* omega_n*m*R*v_tau */
    const double t8 = p[16] + t7; /* d(energy)/d(gamma3) = m*g*a3 + omega_n*m*R*v_tau */
    const double t9 = p[0]*x[1]; /* m*v_nu */
    const double t10 = x[4]*p[8]; /* s*m*a3^2 */
    const double t11 = JLT_FMA(x[4], t10, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t12 = x[2]*t11; /* omega_tau*D */
    const double t13 = x[4]*t6; /* s*m*R*v_tau */
    const double t14 = t0*t0; /* 1/s*1/s */
    const double t15 = p[7]*t2; /* G_level/(R*I1)*b */
    const double t16 = JLT_FNMA(t14, t15, t4); /* d(v_tau)/d(s) = R*omega3 - 1/s*1/s*G_level/(R*I1)*b */
    const double t17 = t5*p[0]; /* v_tau*m */
    const double t18 = t16*t17; /* d(v_tau)/d(s)*v_tau*m */
    const double t19 = t1*p[24]; /* omega_n*G_level/R */
    const double t20 = t14*t19; /* 1/s*1/s*omega_n*G_level/R */
    const double t21 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t22 = t10*t21; /* s*m*a3^2*omega_tau*omega_tau */
    const double t23 = t20 - t22; /* 1/s*1/s*omega_n*G_level/R - s*m*a3^2*omega_tau*omega_tau */
    const double t24 = t18 - t23; /* d(energy)/d(s) = d(v_tau)/d(s)*v_tau*m - (1/s*1/s*omega_n*G_level/R - s*m*a3^2*omega_tau*omega_tau) */
    const double t25 = t22 - t20; /* s*m*a3^2*omega_tau*omega_tau - 1/s*1/s*omega_n*G_level/R */
    out[0] = t8;
    out[1] = t9;
    out[2] = t12;
    out[3] = t13;
    out[4] = t24;
    out[5] = t7;
    out[6] = t9;
    out[7] = 0.0;
    out[8] = t13;
    out[9] = t18;
    out[10] = p[16];
    out[11] = 0.0;
    out[12] = t12;
    out[13] = 0.0;
    out[14] = t25;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[4]; /* 1/s */
    const double t1 = p[7]*t0; /* G_level/(R*I1)*1/s */
    out[0] = t1;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
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
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x4, k);
        t3[k] = jlt_jet_product(x2, t2, k);
        t7[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t11[k] = t2[k]*p[8] + (k == 0 ? p[4] : 0);
        t12[k] = jlt_jet_product(x4, t11, k);
        t14[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t12, t14, k);
        t15[k] = jlt_jet_product(t11, t14, k);
        t16[k] = p[7]*t15[k];
        t17[k] = jlt_jet_product(t16, t16, k);
        t18[k] = jlt_jet_product(t7, t17, k);
        t20[k] = x4[k]*p[1];
        t21[k] = jlt_jet_product(x3, t20, k);
        t22[k] = jlt_jet_product(t16, t21, k) + t18[k];
        t25[k] = t2[k]*p[10];
        t27[k] = jlt_jet_product(x2, x0, k);
        t28[k] = p[9]*t27[k];
        t29[k] = t25[k] - jlt_jet_product(t3, t28, k);
        t30[k] = jlt_jet_product(x0, t17, k) + t29[k];
        t31[k] = x4[k]*p[25];
        t32[k] = jlt_jet_product(t14, t31, k);
        t33[k] = jlt_jet_product(t30, t32, k);
        t36[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t37[k] = jlt_jet_product(x2, t36, k) + x1[k];
        t38[k] = p[11]*t37[k];
        t39[k] = jlt_jet_product(t15, t38, k);
        t40[k] = jlt_jet_product(t16, t39, k);
        t41[k] = jlt_jet_product(x3, t27, k) - t40[k];
        t42[k] = jlt_jet_product(x4, t27, k);
        t43[k] = -t42[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t22[k]/(k + 1);
        next[2] = x2[k + 1] = t33[k]/(k + 1);
        next[3] = x3[k + 1] = t41[k]/(k + 1);
        next[4] = x4[k + 1] = t43[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = (0.0);
    const double complex v_omega3 = x[3];
    const double v_a3 = params[3];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "E1", "I3 = 0" },
    { "E2", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular_on_level_G = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "regular",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 26,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 1, 19, 8, 1, 0, 0, 9, 9 }, { 9, 36, 0, 5, 0, 0, 8, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .jacobian = { jacobian, 25, { 6, 37, 11, 1, 0, 0, 13, 11 }, { 19, 110, 0, 17, 0, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 6, 41, 17, 1, 0, 0, 11, 19 }, { 24, 137, 0, 21, 0, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .divergence = { divergence, 1, { 0, 5, 1, 1, 0, 0, 4, 4 }, { 1, 11, 0, 1, 0, 0, 6, 4 },
        "" },
    .integral_values = { integral_values, 3, { 1, 10, 6, 1, 0, 0, 7, 6 }, { 10, 40, 0, 1, 0, 0, 9, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 15, { 4, 17, 4, 1, 0, 0, 7, 9 }, { 8, 55, 0, 4, 0, 0, 9, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 1, 0, 1, 0, 0, 2, 2 }, { 0, 2, 0, 1, 0, 0, 3, 2 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_rod_in_regular_on_level_G_baseline,
        &jlt_batch_spherical_top_rod_in_regular_on_level_G_avx2,
        &jlt_batch_spherical_top_rod_in_regular_on_level_G_avx512,
    },
};
