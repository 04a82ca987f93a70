/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   20    5    1    1    0     12    7   (62)
 *  jacobian            6   27   13    1    1    0     15   12   (171)
 *  rhs_jacobian        7   32   14    1    1    0     15   14   (208)
 *  divergence          3   14    4    1    1    0     12    7   (38)
 *  integral_values     2   11    7    1    1    0     11    5   (42)
 *  integral_gradients  2   20   10    1    1    0     13    9   (66)
 *  eliminated          2    4    1    1    1    0      5    4   (10)
 *
 *  Accuracy: divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[5];
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
    const double t0 = params[5]*params[5]; /* I3*I3 */
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    const double t3 = params[5]*t2; /* I3*m*R*R */
    const double t4 = params[5]*params[1]; /* I3*R */
    const double t5 = 1.0/t4; /* 1/(I3*R) */
    const double t6 = params[0]*params[1]; /* m*R */
    const double t7 = params[5]*t6; /* I3*m*R */
    const double t8 = t0 + t3; /* I3*I3 + I3*m*R*R */
    const double t9 = -t7; /* -I3*m*R */
    const double t10 = params[1]*2.0; /* R*2 */
    const double t11 = params[0]/2.0; /* m/2 */
    const double t12 = params[5]/2.0; /* I3/2 */
    const double t13 = t0*params[0]; /* I3*I3*m */
    const double t14 = params[0]*2.0; /* m*2 */
    const double t15 = t0*t14; /* I3*I3*m*2 */
    const double t16 = params[1]*t14; /* R*m*2 */
    const double t17 = t0*t16; /* I3*I3*R*m*2 */
    const double t18 = (-1.0)/t4; /* (-1)/(I3*R) */
    out[7] = t0;
    out[8] = t3;
    out[9] = t5;
    out[10] = t4;
    out[11] = t7;
    out[12] = t8;
    out[13] = t9;
    out[14] = t10;
    out[15] = t11;
    out[16] = t12;
    out[17] = t13;
    out[18] = t6;
    out[19] = t15;
    out[20] = t17;
    out[21] = t18;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t6 = t2 + t5; /* (1 - gamma3)*(1 + gamma3) + gamma3*gamma3 */
    const double t7 = JLT_FMA(p[8], t6, p[7]); /* Theta = m*R^2*I3*((1 - gamma3)*(1 + gamma3) + gamma3*gamma3) + I3^2 */
    const double t8 = x[0]*t7; /* gamma3*Theta */
    const double t9 = t3*t8; /* s*gamma3*Theta */
    const double t10 = 1.0/t9; /* 1/(s*gamma3*Theta) */
    const double t11 = t7*t10; /* Theta*1/(s*gamma3*Theta) */
    const double t12 = x[3]*t5; /* omega_n*gamma3*gamma3 */
    const double t13 = t11*t12; /* Theta*1/(s*gamma3*Theta)*omega_n*gamma3*gamma3 */
    const double t14 = x[3]*p[10]; /* omega_n*R*I3 */
    const double t15 = JLT_FNMA(t3, t14, p[6]); /* G_level - s*omega_n*R*I3 */
    const double t16 = t3*p[9]; /* s*1/(R*I3) */
    const double t17 = t15*t16; /* (G_level - s*omega_n*R*I3)*s*1/(R*I3) */
    const double t18 = t11*t17; /* Theta*1/(s*gamma3*Theta)*(G_level - s*omega_n*R*I3)*s*1/(R*I3) */
    const double t19 = t13 - t18; /* Theta*1/(s*gamma3*Theta)*omega_n*gamma3*gamma3 - t18 */
    const double t20 = x[3]*t19; /* omega_n*(Theta*1/(s*gamma3*Theta)*omega_n*gamma3*gamma3 - t18) */
    const double t21 = p[1]*t20; /* R*t20 */
    const double t22 = -t20; /* -t20 */
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t24 = x[0]*t3; /* gamma3*s */
    const double t25 = t10*t24; /* 1/(s*gamma3*Theta)*gamma3*s */
    const double t26 = p[11]*t23; /* m*R*I3*V */
    const double t27 = JLT_FNMA(t25, t26, x[2]); /* omega_tau - 1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V */
    const double t28 = t13*t27; /* Theta*1/(s*gamma3*Theta)*omega_n*gamma3*gamma3*(omega_tau - 1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V) */
    const double t29 = x[2]*p[12]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t30 = t25*t29; /* 1/(s*gamma3*Theta)*gamma3*s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t31 = JLT_FNMA(t18, t30, t28); /* t28 - t18*1/(s*gamma3*Theta)*gamma3*s*omega_tau*(I3^2 + m*R^2*I3) */
    out[0] = t4;
    out[1] = t21;
    out[2] = t22;
    out[3] = t31;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[8], t3, p[7]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1)) + I3^2 */
    const double t5 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = x[0]*t4; /* gamma3*Theta */
    const double t7 = t5*t6; /* s*gamma3*Theta */
    const double t8 = 1.0/t7; /* 1/(s*gamma3*Theta) */
    const double t9 = t4*t8; /* Theta*1/(s*gamma3*Theta) */
    const double t10 = x[0]*t9; /* gamma3*Theta*1/(s*gamma3*Theta) */
    const double t11 = x[0]*t10; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t12 = x[2]*t11; /* omega_tau*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t13 = -t12; /* -omega_tau*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t14 = t5*x[3]; /* s*omega_n */
    const double t15 = JLT_FNMA(p[10], t14, p[6]); /* G_level - R*I3*s*omega_n */
    const double t16 = t5*t9; /* s*Theta*1/(s*gamma3*Theta) */
    const double t17 = p[9]*t15; /* 1/(R*I3)*(G_level - R*I3*s*omega_n) */
    const double t18 = t16*t17; /* s*Theta*1/(s*gamma3*Theta)*1/(R*I3)*(G_level - R*I3*s*omega_n) */
    const double t19 = t10*x[3]; /* gamma3*Theta*1/(s*gamma3*Theta)*omega_n */
    const double t20 = JLT_FMS(t16, t18, t19); /* d(omega3)/d(gamma3) = s*Theta*1/(s*gamma3*Theta)*t18 - gamma3*Theta*1/(s*gamma3*Theta)*omega_n */
    const double t21 = JLT_FMA(t11, t11, 1.0); /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*gamma3*gamma3*Theta*1/(s*gamma3*Theta) + 1 */
    const double t22 = t19*t21; /* gamma3*Theta*1/(s*gamma3*Theta)*omega_n*t21 */
    const double t23 = t20 + t22; /* d(omega3)/d(gamma3) + gamma3*Theta*1/(s*gamma3*Theta)*omega_n*t21 */
    const double t24 = x[3]*t23; /* omega_n*t23 */
    const double t25 = p[1]*t24; /* R*omega_n*t23 */
    const double t26 = x[0]*t19; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*omega_n */
    const double t27 = JLT_FMS(t14, t16, t18); /* s*omega_n*s*Theta*1/(s*gamma3*Theta) - t18 */
    const double t28 = JLT_FMA(2.0, t26, t27); /* 2*gamma3*gamma3*Theta*1/(s*gamma3*Theta)*omega_n + s*omega_n*s*Theta*1/(s*gamma3*Theta) - t18 */
    const double t29 = p[1]*t28; /* R*t28 */
    const double t30 = -t24; /* -omega_n*t23 */
    const double t31 = -t28; /* -t28 */
    const double t32 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t33 = x[0]*t5; /* gamma3*s */
    const double t34 = t8*t33; /* 1/(s*gamma3*Theta)*gamma3*s */
    const double t35 = p[11]*t32; /* m*R*I3*V */
    const double t36 = JLT_FNMA(t34, t35, x[2]); /* omega_tau - 1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V */
    const double t37 = t22*t36; /* gamma3*Theta*1/(s*gamma3*Theta)*omega_n*t21*(omega_tau - 1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V) */
    const double t38 = t34*p[12]; /* 1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t39 = x[2]*t38; /* omega_tau*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t40 = JLT_FMA(t20, t39, t37); /* d(omega3)/d(gamma3)*omega_tau*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) + t37 */
    const double t41 = t26*t34; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*omega_n*1/(s*gamma3*Theta)*gamma3*s */
    const double t42 = p[13]*t41; /* (-m*R*I3)*t41 */
    const double t43 = JLT_FNMA(t18, t38, t26); /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*omega_n - t18*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t44 = JLT_FNMA(p[8], t41, t43); /* t43 - m*R^2*I3*t41 */
    const double t45 = t11*t36; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*(omega_tau - 1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V) */
    const double t46 = t5*t16; /* s*s*Theta*1/(s*gamma3*Theta) */
    const double t47 = JLT_FMA(t39, t46, t45); /* omega_tau*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3)*s*s*Theta*1/(s*gamma3*Theta) + t45 */
    out[0] = t13;
    out[1] = 0.0;
    out[2] = t5;
    out[3] = 0.0;
    out[4] = t25;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t29;
    out[8] = t30;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t31;
    out[12] = t40;
    out[13] = t42;
    out[14] = t44;
    out[15] = t47;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = t3*x[3]; /* s*omega_n */
    const double t6 = JLT_FNMA(p[10], t5, p[6]); /* G_level - R*I3*s*omega_n */
    const double t7 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(1 + gamma3) */
    const double t8 = JLT_FMA(p[8], t7, p[7]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(1 + gamma3)) + I3^2 */
    const double t9 = x[0]*t8; /* gamma3*Theta */
    const double t10 = t3*t9; /* s*gamma3*Theta */
    const double t11 = 1.0/t10; /* 1/(s*gamma3*Theta) */
    const double t12 = t8*t11; /* Theta*1/(s*gamma3*Theta) */
    const double t13 = t3*t12; /* s*Theta*1/(s*gamma3*Theta) */
    const double t14 = p[9]*t6; /* 1/(R*I3)*(G_level - R*I3*s*omega_n) */
    const double t15 = t13*t14; /* s*Theta*1/(s*gamma3*Theta)*1/(R*I3)*(G_level - R*I3*s*omega_n) */
    const double t16 = x[0]*t12; /* gamma3*Theta*1/(s*gamma3*Theta) */
    const double t17 = x[0]*t16; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t18 = x[3]*t17; /* omega_n*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t19 = t18 - t15; /* omega_n*gamma3*gamma3*Theta*1/(s*gamma3*Theta) - t15 */
    const double t20 = x[3]*t19; /* omega_n*(omega_n*gamma3*gamma3*Theta*1/(s*gamma3*Theta) - t15) */
    const double t21 = p[1]*t20; /* R*t20 */
    const double t22 = -t20; /* -t20 */
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t24 = x[0]*t3; /* gamma3*s */
    const double t25 = t11*t24; /* 1/(s*gamma3*Theta)*gamma3*s */
    const double t26 = p[11]*t23; /* m*R*I3*V */
    const double t27 = JLT_FNMA(t25, t26, x[2]); /* omega_tau - 1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V */
    const double t28 = t18*t27; /* omega_n*gamma3*gamma3*Theta*1/(s*gamma3*Theta)*(omega_tau - 1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V) */
    const double t29 = t25*p[12]; /* 1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t30 = x[2]*t29; /* omega_tau*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t31 = JLT_FNMA(t15, t30, t28); /* t28 - t15*omega_tau*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t32 = x[2]*t17; /* omega_tau*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t33 = -t32; /* -omega_tau*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t34 = JLT_FMA(t17, t17, 1.0); /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*gamma3*gamma3*Theta*1/(s*gamma3*Theta) + 1 */
    const double t35 = x[3]*t16; /* omega_n*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t36 = t34*t35; /* t34*omega_n*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t37 = JLT_FMS(t13, t15, t35); /* d(omega3)/d(gamma3) = s*Theta*1/(s*gamma3*Theta)*t15 - omega_n*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t38 = t36 + t37; /* t34*omega_n*gamma3*Theta*1/(s*gamma3*Theta) + d(omega3)/d(gamma3) */
    const double t39 = x[3]*t38; /* omega_n*t38 */
    const double t40 = p[1]*t39; /* R*omega_n*t38 */
    const double t41 = JLT_FMS(t5, t13, t15); /* s*omega_n*s*Theta*1/(s*gamma3*Theta) - t15 */
    const double t42 = JLT_FMA((1.0 / 2.0), t41, t18); /* 1/2*(s*omega_n*s*Theta*1/(s*gamma3*Theta) - t15) + omega_n*gamma3*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t43 = p[14]*t42; /* 2*R*t42 */
    const double t44 = -t39; /* -omega_n*t38 */
    const double t45 = t42*(-2.0); /* t42*(-2) */
    const double t46 = t27*t36; /* (omega_tau - 1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V)*t34*omega_n*gamma3*Theta*1/(s*gamma3*Theta) */
    const double t47 = JLT_FMA(t30, t37, t46); /* omega_tau*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3)*d(omega3)/d(gamma3) + t46 */
    const double t48 = t18*t25; /* omega_n*gamma3*gamma3*Theta*1/(s*gamma3*Theta)*1/(s*gamma3*Theta)*gamma3*s */
    const double t49 = p[13]*t48; /* (-m*R*I3)*t48 */
    const double t50 = JLT_FNMA(t15, t29, t18); /* omega_n*gamma3*gamma3*Theta*1/(s*gamma3*Theta) - t15*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3) */
    const double t51 = JLT_FNMA(p[8], t48, t50); /* t50 - m*R^2*I3*t48 */
    const double t52 = t17*t27; /* gamma3*gamma3*Theta*1/(s*gamma3*Theta)*(omega_tau - 1/(s*gamma3*Theta)*gamma3*s*m*R*I3*V) */
    const double t53 = t3*t13; /* s*s*Theta*1/(s*gamma3*Theta) */
    const double t54 = JLT_FMA(t30, t53, t52); /* omega_tau*1/(s*gamma3*Theta)*gamma3*s*(I3^2 + m*R^2*I3)*s*s*Theta*1/(s*gamma3*Theta) + t52 */
    out[0] = t4;
    out[1] = t21;
    out[2] = t22;
    out[3] = t31;
    out[4] = t33;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t40;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t43;
    out[12] = t44;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t45;
    out[16] = t47;
    out[17] = t49;
    out[18] = t51;
    out[19] = t54;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(1 + gamma3) */
    const double t5 = JLT_FMA(p[8], t4, p[7]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(1 + gamma3)) + I3^2 */
    const double t6 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t7 = x[0]*t5; /* gamma3*Theta */
    const double t8 = t3*t7; /* s*gamma3*Theta */
    const double t9 = 1.0/t8; /* 1/(s*gamma3*Theta) */
    const double t10 = x[0]*t9; /* gamma3*1/(s*gamma3*Theta) */
    const double t11 = x[0]*p[11]; /* gamma3*m*R*I3 */
    const double t12 = t6*t11; /* V*gamma3*m*R*I3 */
    const double t13 = t5*t12; /* Theta*V*gamma3*m*R*I3 */
    const double t14 = t10*t13; /* gamma3*1/(s*gamma3*Theta)*Theta*V*gamma3*m*R*I3 */
    const double t15 = x[2]*p[12]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t16 = t5*t15; /* Theta*omega_tau*(I3^2 + m*R^2*I3) */
    const double t17 = t3*t16; /* s*Theta*omega_tau*(I3^2 + m*R^2*I3) */
    const double t18 = t3*t17; /* s*s*Theta*omega_tau*(I3^2 + m*R^2*I3) */
    const double t19 = JLT_FNMA(t9, t18, t14); /* gamma3*1/(s*gamma3*Theta)*Theta*V*gamma3*m*R*I3 - 1/(s*gamma3*Theta)*s*s*Theta*omega_tau*(I3^2 + m*R^2*I3) */
    const double t20 = t3*t10; /* s*gamma3*1/(s*gamma3*Theta) */
    const double t21 = t19*t20; /* t19*s*gamma3*1/(s*gamma3*Theta) */
    const double t22 = -t21; /* -t19*s*gamma3*1/(s*gamma3*Theta) */
    out[0] = t22;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = 1.0/x[0]; /* 1/gamma3 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = p[10]*x[3]; /* R*I3*omega_n */
    const double t7 = JLT_FNMA(t5, t6, p[6]); /* G_level - s*R*I3*omega_n */
    const double t8 = p[9]*t1; /* 1/(R*I3)*1/gamma3 */
    const double t9 = t7*t8; /* (G_level - s*R*I3*omega_n)*1/(R*I3)*1/gamma3 */
    const double t10 = t5*t9; /* s*(G_level - s*R*I3*omega_n)*1/(R*I3)*1/gamma3 */
    const double t11 = JLT_FMS(x[0], x[3], t10); /* gamma3*omega_n - s*(G_level - s*R*I3*omega_n)*1/(R*I3)*1/gamma3 */
    const double t12 = p[1]*t11; /* v_tau = R*t11 */
    const double t13 = JLT_FMA(t12, t12, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t14 = p[15]*t13; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t15 = x[3]*x[3]; /* omega_n*omega_n */
    const double t16 = JLT_FMA(x[2], x[2], t15); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t17 = JLT_FMA(t9, t9, t16); /* (G_level - s*R*I3*omega_n)*1/(R*I3)*1/gamma3*(G_level - s*R*I3*omega_n)*1/(R*I3)*1/gamma3 + omega_tau*omega_tau + omega_n*omega_n */
    const double t18 = JLT_FMA(p[16], t17, t14); /* energy = 1/2*I3*t17 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t19 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t20 = p[17]*t19; /* m*I3^2*(R*omega_tau + v_nu) */
    const double t21 = t19*t20; /* (R*omega_tau + v_nu)*m*I3^2*(R*omega_tau + v_nu) */
    out[0] = t18;
    out[1] = t21;
    out[2] = t19;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = p[10]*x[3]; /* R*I3*omega_n */
    const double t5 = JLT_FNMA(t3, t4, p[6]); /* G_level - s*R*I3*omega_n */
    const double t6 = x[0]*t3; /* gamma3*s */
    const double t7 = 1.0/t6; /* 1/(gamma3*s) */
    const double t8 = t3*t7; /* s*1/(gamma3*s) */
    const double t9 = p[9]*t5; /* 1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t10 = t8*t9; /* s*1/(gamma3*s)*1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t11 = t3*t10; /* s*s*1/(gamma3*s)*1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t12 = JLT_FMS(x[0], x[3], t11); /* gamma3*omega_n - s*s*1/(gamma3*s)*1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t13 = p[18]*t12; /* m*R*t12 */
    const double t14 = t8*t10; /* s*1/(gamma3*s)*s*1/(gamma3*s)*1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t15 = x[0]*t7; /* gamma3*1/(gamma3*s) */
    const double t16 = JLT_FNMA(x[3], t15, t14); /* d(omega3)/d(gamma3) = t14 - omega_n*gamma3*1/(gamma3*s) */
    const double t17 = x[0]*t15; /* gamma3*gamma3*1/(gamma3*s) */
    const double t18 = JLT_FMA(t10, t17, x[3]); /* s*1/(gamma3*s)*1/(R*I3)*(G_level - s*R*I3*omega_n)*gamma3*gamma3*1/(gamma3*s) + omega_n */
    const double t19 = JLT_FMA(t3, t16, t18); /* s*d(omega3)/d(gamma3) + t18 */
    const double t20 = p[1]*t13; /* R*m*R*t12 */
    const double t21 = t19*t20; /* (s*d(omega3)/d(gamma3) + t18)*R*m*R*t12 */
    const double t22 = t10*p[5]; /* s*1/(gamma3*s)*1/(R*I3)*(G_level - s*R*I3*omega_n)*I3 */
    const double t23 = JLT_FNMA(t16, t22, t21); /* d(energy)/d(gamma3) = (s*d(omega3)/d(gamma3) + t18)*R*m*R*t12 - d(omega3)/d(gamma3)*s*1/(gamma3*s)*1/(R*I3)*(G_level - s*R*I3*omega_n)*I3 */
    const double t24 = p[0]*x[1]; /* m*v_nu */
    const double t25 = p[5]*x[2]; /* I3*omega_tau */
    const double t26 = JLT_FNMA(t8, t11, x[3]); /* omega_n - s*1/(gamma3*s)*s*s*1/(gamma3*s)*1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t27 = p[5]*t26; /* I3*t26 */
    const double t28 = JLT_FMA(t2, t8, x[0]); /* (1 - gamma3)*(1 + gamma3)*s*1/(gamma3*s) + gamma3 */
    const double t29 = p[1]*t28; /* R*((1 - gamma3)*(1 + gamma3)*s*1/(gamma3*s) + gamma3) */
    const double t30 = JLT_FMA(t13, t29, t27); /* d(energy)/d(omega_n) = m*R*t12*R*((1 - gamma3)*(1 + gamma3)*s*1/(gamma3*s) + gamma3) + I3*t26 */
    const double t31 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t32 = p[19]*t31; /* 2*m*I3^2*(R*omega_tau + v_nu) */
    const double t33 = t31*p[20]; /* (R*omega_tau + v_nu)*2*m*R*I3^2 */
    out[0] = t23;
    out[1] = t24;
    out[2] = t25;
    out[3] = t30;
    out[4] = 0.0;
    out[5] = t32;
    out[6] = t33;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = 1.0;
    out[10] = p[1];
    out[11] = 0.0;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[0]; /* 1/gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = p[10]*x[3]; /* R*I3*omega_n */
    const double t6 = JLT_FNMA(t4, t5, p[6]); /* G_level - s*R*I3*omega_n */
    const double t7 = p[21]*t0; /* (-1/(R*I3))*1/gamma3 */
    const double t8 = t6*t7; /* (G_level - s*R*I3*omega_n)*(-1/(R*I3))*1/gamma3 */
    out[0] = t8;
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
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
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
    double t40[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
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
        t12[k] = jlt_jet_product(x0, x0, k);
        t13[k] = t5[k] + t12[k];
        t14[k] = p[8]*t13[k] + (k == 0 ? p[7] : 0);
        t15[k] = jlt_jet_product(x0, t14, k);
        t16[k] = jlt_jet_product(t6, t15, k);
        t17[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t16, t17, k);
        t18[k] = jlt_jet_product(t14, t17, k);
        t19[k] = jlt_jet_product(x3, t12, k);
        t20[k] = jlt_jet_product(t18, t19, k);
        t24[k] = x3[k]*p[10];
        t25[k] = (k == 0 ? p[6] : 0) - jlt_jet_product(t6, t24, k);
        t26[k] = t6[k]*p[9];
        t27[k] = jlt_jet_product(t25, t26, k);
        t28[k] = jlt_jet_product(t18, t27, k);
        t29[k] = t20[k] - t28[k];
        t30[k] = jlt_jet_product(x3, t29, k);
        t31[k] = p[1]*t30[k];
        t32[k] = -t30[k];
        t35[k] = x2[k]*p[1] + x1[k];
        t36[k] = jlt_jet_product(x0, t6, k);
        t37[k] = jlt_jet_product(t17, t36, k);
        t38[k] = p[11]*t35[k];
        t39[k] = x2[k] - jlt_jet_product(t37, t38, k);
        t40[k] = jlt_jet_product(t20, t39, k);
        t42[k] = x2[k]*p[12];
        t43[k] = jlt_jet_product(t37, t42, k);
        t44[k] = t40[k] - jlt_jet_product(t28, t43, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t31[k]/(k + 1);
        next[2] = x2[k + 1] = t32[k]/(k + 1);
        next[3] = x3[k + 1] = t44[k]/(k + 1);
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
    const double v_I3 = params[5];
    const double v_G_level = params[6];
    const double v_I1 = (v_I3);
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
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
    out[3] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 22,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 20, 5, 1, 1, 0, 12, 7 }, { 11, 43, 0, 7, 1, 0, 11, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 6, 27, 13, 1, 1, 0, 15, 12 }, { 30, 113, 0, 27, 1, 0, 12, 9 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 32, 14, 1, 1, 0, 15, 14 }, { 36, 138, 0, 33, 1, 0, 12, 9 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 14, 4, 1, 1, 0, 12, 7 }, { 6, 28, 0, 3, 1, 0, 10, 6 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 2, 11, 7, 1, 1, 0, 11, 5 }, { 9, 31, 0, 1, 1, 0, 15, 5 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 12, { 2, 20, 10, 1, 1, 0, 13, 9 }, { 13, 46, 0, 6, 1, 0, 13, 9 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 4, 1, 1, 1, 0, 5, 4 }, { 2, 6, 0, 1, 1, 0, 6, 4 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_avx512,
    },
};
