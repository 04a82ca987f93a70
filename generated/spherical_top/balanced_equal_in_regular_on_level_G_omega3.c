/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   17    7    1    0    0      9    6   (63)
 *  jacobian            6   36   15    1    0    0     13   13   (278)
 *  rhs_jacobian        9   43   16    1    0    0     15   16   (319)
 *  divergence          1    9    4    1    0    0      8    6   (36)
 *  integral_values     0   10    7    1    0    0     10    4   (39)
 *  integral_gradients  0   20   10    1    0    0     10    9   (72)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    3    1    1    0    0      4    3   (7)
 *
 *  Accuracy: divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_avx512;

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
    const double t0 = params[1]*params[5]; /* R*I3 */
    const double t1 = 1.0/t0; /* 1/(R*I3) */
    const double t2 = params[5]*params[5]; /* I3*I3 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[5]*t4; /* I3*m*R*R */
    const double t6 = params[1]*params[0]; /* R*m */
    const double t7 = params[5]*t6; /* I3*R*m */
    const double t8 = t2 + t5; /* I3*I3 + I3*m*R*R */
    const double t9 = params[5]*t2; /* I3*I3*I3 */
    const double t10 = t4*t9; /* m*R*R*I3*I3*I3 */
    const double t11 = t10*2.0; /* m*R*R*I3*I3*I3*2 */
    const double t12 = params[0]*params[0]; /* m*m */
    const double t13 = t3*t3; /* R*R*R*R */
    const double t14 = t12*t13; /* m*m*R*R*R*R */
    const double t15 = t2*t14; /* I3*I3*m*m*R*R*R*R */
    const double t16 = 2.0*t15; /* 2*I3*I3*m*m*R*R*R*R */
    const double t17 = t11 + t16; /* m*R*R*I3*I3*I3*2 + 2*I3*I3*m*m*R*R*R*R */
    const double t18 = 2.0*t12; /* 2*m*m */
    const double t19 = params[1]*t3; /* R*R*R */
    const double t20 = t18*t19; /* 2*m*m*R*R*R */
    const double t21 = t2*t20; /* I3*I3*2*m*m*R*R*R */
    const double t22 = params[5]/params[1]; /* I3/R */
    const double t23 = t6 + t22; /* R*m + I3/R */
    const double t24 = -t7; /* -I3*R*m */
    const double t25 = params[0]/2.0; /* m/2 */
    const double t26 = params[5]/2.0; /* I3/2 */
    const double t27 = t2*params[0]; /* I3*I3*m */
    const double t28 = 1.0/params[5]; /* 1/I3 */
    const double t29 = 1.0/params[1]; /* 1/R */
    const double t30 = params[0]*2.0; /* m*2 */
    const double t31 = t2*t30; /* I3*I3*m*2 */
    const double t32 = params[1]*t30; /* R*m*2 */
    const double t33 = t2*t32; /* I3*I3*R*m*2 */
    const double t34 = (-1.0)/t0; /* (-1)/(R*I3) */
    out[7] = t1;
    out[8] = t0;
    out[9] = t2;
    out[10] = t5;
    out[11] = t7;
    out[12] = t8;
    out[13] = t17;
    out[14] = t21;
    out[15] = t23;
    out[16] = t24;
    out[17] = t25;
    out[18] = t26;
    out[19] = t27;
    out[20] = t28;
    out[21] = t29;
    out[22] = t31;
    out[23] = t33;
    out[24] = t34;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[4]*p[8]; /* s*R*I3 */
    const double t3 = JLT_FNMA(x[3], t2, p[6]); /* G_level - omega_n*s*R*I3 */
    const double t4 = x[4]*x[4]; /* s*s */
    const double t5 = JLT_FMA(x[0], x[0], t4); /* gamma3*gamma3 + s*s */
    const double t6 = JLT_FMA(p[10], t5, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t7 = x[0]*t6; /* gamma3*Theta */
    const double t8 = 1.0/t7; /* 1/(gamma3*Theta) */
    const double t9 = p[7]*t3; /* 1/(R*I3)*(G_level - omega_n*s*R*I3) */
    const double t10 = t6*t9; /* Theta*1/(R*I3)*(G_level - omega_n*s*R*I3) */
    const double t11 = t8*t10; /* 1/(gamma3*Theta)*Theta*1/(R*I3)*(G_level - omega_n*s*R*I3) */
    const double t12 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t13 = JLT_FNMA(x[4], t11, t12); /* omega_n*gamma3 - s*1/(gamma3*Theta)*Theta*1/(R*I3)*(G_level - omega_n*s*R*I3) */
    const double t14 = x[3]*t13; /* omega_n*t13 */
    const double t15 = p[1]*t14; /* R*omega_n*t13 */
    const double t16 = -t14; /* -omega_n*t13 */
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t18 = x[0]*t8; /* gamma3*1/(gamma3*Theta) */
    const double t19 = p[11]*t17; /* m*R*I3*V */
    const double t20 = JLT_FNMA(t18, t19, x[2]); /* omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V */
    const double t21 = t12*t20; /* omega_n*gamma3*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t22 = t0*p[12]; /* s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t23 = t11*t22; /* 1/(gamma3*Theta)*Theta*1/(R*I3)*(G_level - omega_n*s*R*I3)*s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t24 = JLT_FNMA(t18, t23, t21); /* t21 - gamma3*1/(gamma3*Theta)*t23 */
    const double t25 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t26 = -t25; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t15;
    out[2] = t16;
    out[3] = t24;
    out[4] = t26;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[4]*x[3]; /* s*omega_n */
    const double t4 = JLT_FNMA(p[8], t3, p[6]); /* G_level - R*I3*s*omega_n */
    const double t5 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t6 = JLT_FMA(p[10], t5, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t7 = x[0]*t6; /* gamma3*Theta */
    const double t8 = 1.0/t7; /* 1/(gamma3*Theta) */
    const double t9 = t6*t8; /* Theta*1/(gamma3*Theta) */
    const double t10 = t4*t9; /* (G_level - R*I3*s*omega_n)*Theta*1/(gamma3*Theta) */
    const double t11 = p[7]*t10; /* 1/(R*I3)*(G_level - R*I3*s*omega_n)*Theta*1/(gamma3*Theta) */
    const double t12 = x[4]*t9; /* s*Theta*1/(gamma3*Theta) */
    const double t13 = JLT_FMA(t11, t12, x[3]); /* 1/(R*I3)*(G_level - R*I3*s*omega_n)*Theta*1/(gamma3*Theta)*s*Theta*1/(gamma3*Theta) + omega_n */
    const double t14 = x[3]*t13; /* omega_n*t13 */
    const double t15 = p[1]*t14; /* R*omega_n*t13 */
    const double t16 = JLT_FMS(t3, t9, t11); /* s*omega_n*Theta*1/(gamma3*Theta) - 1/(R*I3)*(G_level - R*I3*s*omega_n)*Theta*1/(gamma3*Theta) */
    const double t17 = x[4]*t16; /* s*t16 */
    const double t18 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t19 = JLT_FMA(2.0, t18, t17); /* 2*omega_n*gamma3 + s*t16 */
    const double t20 = p[1]*t19; /* R*(2*omega_n*gamma3 + s*t16) */
    const double t21 = x[3]*t16; /* omega_n*t16 */
    const double t22 = p[1]*t21; /* R*omega_n*t16 */
    const double t23 = -t14; /* -omega_n*t13 */
    const double t24 = -t19; /* -(2*omega_n*gamma3 + s*t16) */
    const double t25 = -t21; /* -omega_n*t16 */
    const double t26 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t27 = x[0]*t8; /* gamma3*1/(gamma3*Theta) */
    const double t28 = p[11]*t26; /* m*R*I3*V */
    const double t29 = JLT_FNMA(t27, t28, x[2]); /* omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V */
    const double t30 = x[3]*t29; /* omega_n*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t31 = t1*p[13]; /* s*omega_tau*(2*m*R^2*I3^3 + 2*m^2*R^4*I3^2) */
    const double t32 = t11*t31; /* 1/(R*I3)*(G_level - R*I3*s*omega_n)*Theta*1/(gamma3*Theta)*s*omega_tau*(2*m*R^2*I3^3 + 2*m^2*R^4*I3^2) */
    const double t33 = t18*p[14]; /* omega_n*gamma3*2*m^2*R^3*I3^2 */
    const double t34 = JLT_FMA(t26, t33, t32); /* V*omega_n*gamma3*2*m^2*R^3*I3^2 + t32 */
    const double t35 = x[0]*t27; /* gamma3*gamma3*1/(gamma3*Theta) */
    const double t36 = t34*t35; /* (V*omega_n*gamma3*2*m^2*R^3*I3^2 + t32)*gamma3*gamma3*1/(gamma3*Theta) */
    const double t37 = t1*t9; /* s*omega_tau*Theta*1/(gamma3*Theta) */
    const double t38 = t10*p[15]; /* (G_level - R*I3*s*omega_n)*Theta*1/(gamma3*Theta)*(m*R + I3/R) */
    const double t39 = JLT_FMA(t37, t38, t36); /* s*omega_tau*Theta*1/(gamma3*Theta)*t38 + t36 */
    const double t40 = JLT_FMA(t27, t39, t30); /* gamma3*1/(gamma3*Theta)*(s*omega_tau*Theta*1/(gamma3*Theta)*t38 + t36) + omega_n*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t41 = t18*t27; /* omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t42 = p[16]*t41; /* (-m*R*I3)*omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t43 = x[4]*t27; /* s*gamma3*1/(gamma3*Theta) */
    const double t44 = p[12]*t43; /* (I3^2 + m*R^2*I3)*s*gamma3*1/(gamma3*Theta) */
    const double t45 = JLT_FNMA(p[10], t41, t18); /* omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t46 = JLT_FNMA(t11, t44, t45); /* t45 - 1/(R*I3)*(G_level - R*I3*s*omega_n)*Theta*1/(gamma3*Theta)*(I3^2 + m*R^2*I3)*s*gamma3*1/(gamma3*Theta) */
    const double t47 = x[0]*t29; /* gamma3*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t48 = JLT_FMA(t37, t44, t47); /* s*omega_tau*Theta*1/(gamma3*Theta)*(I3^2 + m*R^2*I3)*s*gamma3*1/(gamma3*Theta) + gamma3*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t49 = x[2]*p[12]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t50 = t16*t49; /* t16*omega_tau*(I3^2 + m*R^2*I3) */
    const double t51 = JLT_FMA(t34, t43, t50); /* (V*omega_n*gamma3*2*m^2*R^3*I3^2 + t32)*s*gamma3*1/(gamma3*Theta) + t16*omega_tau*(I3^2 + m*R^2*I3) */
    const double t52 = t27*t51; /* gamma3*1/(gamma3*Theta)*t51 */
    const double t53 = -t1; /* -s*omega_tau */
    const double t54 = x[4]*x[0]; /* s*gamma3 */
    const double t55 = -t54; /* -s*gamma3 */
    const double t56 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t57 = -t56; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t15;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t20;
    out[9] = t22;
    out[10] = t23;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t24;
    out[14] = t25;
    out[15] = t40;
    out[16] = t42;
    out[17] = t46;
    out[18] = t48;
    out[19] = t52;
    out[20] = t53;
    out[21] = 0.0;
    out[22] = t55;
    out[23] = 0.0;
    out[24] = t57;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[4]*p[8]; /* s*R*I3 */
    const double t3 = JLT_FNMA(x[3], t2, p[6]); /* G_level - omega_n*s*R*I3 */
    const double t4 = x[4]*x[4]; /* s*s */
    const double t5 = JLT_FMA(x[0], x[0], t4); /* gamma3*gamma3 + s*s */
    const double t6 = JLT_FMA(p[10], t5, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t7 = x[0]*t6; /* gamma3*Theta */
    const double t8 = 1.0/t7; /* 1/(gamma3*Theta) */
    const double t9 = t6*t8; /* Theta*1/(gamma3*Theta) */
    const double t10 = t3*t9; /* (G_level - omega_n*s*R*I3)*Theta*1/(gamma3*Theta) */
    const double t11 = p[7]*t10; /* 1/(R*I3)*(G_level - omega_n*s*R*I3)*Theta*1/(gamma3*Theta) */
    const double t12 = x[4]*t11; /* s*1/(R*I3)*(G_level - omega_n*s*R*I3)*Theta*1/(gamma3*Theta) */
    const double t13 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t14 = t13 - t12; /* omega_n*gamma3 - s*1/(R*I3)*(G_level - omega_n*s*R*I3)*Theta*1/(gamma3*Theta) */
    const double t15 = x[3]*p[1]; /* omega_n*R */
    const double t16 = t14*t15; /* t14*omega_n*R */
    const double t17 = x[3]*t14; /* omega_n*t14 */
    const double t18 = -t17; /* -omega_n*t14 */
    const double t19 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t20 = x[0]*t8; /* gamma3*1/(gamma3*Theta) */
    const double t21 = p[11]*t19; /* m*R*I3*V */
    const double t22 = JLT_FNMA(t20, t21, x[2]); /* omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V */
    const double t23 = t13*t22; /* omega_n*gamma3*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t24 = t20*p[12]; /* gamma3*1/(gamma3*Theta)*(I3^2 + m*R^2*I3) */
    const double t25 = t0*t11; /* s*omega_tau*1/(R*I3)*(G_level - omega_n*s*R*I3)*Theta*1/(gamma3*Theta) */
    const double t26 = JLT_FNMA(t24, t25, t23); /* t23 - gamma3*1/(gamma3*Theta)*(I3^2 + m*R^2*I3)*t25 */
    const double t27 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t28 = -t27; /* -s*omega_tau*gamma3 */
    const double t29 = t0*2.0; /* s*omega_tau*2 */
    const double t30 = x[4]*t9; /* s*Theta*1/(gamma3*Theta) */
    const double t31 = JLT_FMA(t11, t30, x[3]); /* 1/(R*I3)*(G_level - omega_n*s*R*I3)*Theta*1/(gamma3*Theta)*s*Theta*1/(gamma3*Theta) + omega_n */
    const double t32 = t15*t31; /* omega_n*R*t31 */
    const double t33 = JLT_FMS(x[3], t30, t11); /* omega_n*s*Theta*1/(gamma3*Theta) - 1/(R*I3)*(G_level - omega_n*s*R*I3)*Theta*1/(gamma3*Theta) */
    const double t34 = x[4]*t33; /* s*t33 */
    const double t35 = JLT_FMA(t13, 2.0, t34); /* omega_n*gamma3*2 + s*t33 */
    const double t36 = p[1]*t35; /* R*(omega_n*gamma3*2 + s*t33) */
    const double t37 = t15*t33; /* omega_n*R*t33 */
    const double t38 = x[3]*t31; /* omega_n*t31 */
    const double t39 = -t38; /* -omega_n*t31 */
    const double t40 = -t35; /* -(omega_n*gamma3*2 + s*t33) */
    const double t41 = x[3]*t33; /* omega_n*t33 */
    const double t42 = -t41; /* -omega_n*t33 */
    const double t43 = x[3]*t22; /* omega_n*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t44 = t25*p[13]; /* t25*(2*m*R^2*I3^3 + 2*m^2*R^4*I3^2) */
    const double t45 = t13*p[14]; /* omega_n*gamma3*2*m^2*R^3*I3^2 */
    const double t46 = JLT_FMA(t19, t45, t44); /* V*omega_n*gamma3*2*m^2*R^3*I3^2 + t25*(2*m*R^2*I3^3 + 2*m^2*R^4*I3^2) */
    const double t47 = t20*t46; /* gamma3*1/(gamma3*Theta)*t46 */
    const double t48 = x[0]*t47; /* gamma3*gamma3*1/(gamma3*Theta)*t46 */
    const double t49 = t0*p[15]; /* s*omega_tau*(m*R + I3/R) */
    const double t50 = t9*t49; /* Theta*1/(gamma3*Theta)*s*omega_tau*(m*R + I3/R) */
    const double t51 = JLT_FMA(t10, t50, t48); /* (G_level - omega_n*s*R*I3)*Theta*1/(gamma3*Theta)*Theta*1/(gamma3*Theta)*s*omega_tau*(m*R + I3/R) + gamma3*gamma3*1/(gamma3*Theta)*t46 */
    const double t52 = JLT_FMA(t20, t51, t43); /* gamma3*1/(gamma3*Theta)*t51 + omega_n*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t53 = t13*t20; /* omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t54 = p[16]*t53; /* (-m*R*I3)*omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t55 = JLT_FNMA(p[10], t53, t13); /* omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t56 = JLT_FNMA(t12, t24, t55); /* t55 - s*1/(R*I3)*(G_level - omega_n*s*R*I3)*Theta*1/(gamma3*Theta)*gamma3*1/(gamma3*Theta)*(I3^2 + m*R^2*I3) */
    const double t57 = x[0]*t22; /* gamma3*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t58 = t0*t24; /* s*omega_tau*gamma3*1/(gamma3*Theta)*(I3^2 + m*R^2*I3) */
    const double t59 = JLT_FMA(t30, t58, t57); /* s*Theta*1/(gamma3*Theta)*s*omega_tau*gamma3*1/(gamma3*Theta)*(I3^2 + m*R^2*I3) + gamma3*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t60 = x[2]*t24; /* omega_tau*gamma3*1/(gamma3*Theta)*(I3^2 + m*R^2*I3) */
    const double t61 = t33*t60; /* t33*omega_tau*gamma3*1/(gamma3*Theta)*(I3^2 + m*R^2*I3) */
    const double t62 = x[4]*t20; /* s*gamma3*1/(gamma3*Theta) */
    const double t63 = JLT_FMA(t47, t62, t61); /* gamma3*1/(gamma3*Theta)*t46*s*gamma3*1/(gamma3*Theta) + t33*omega_tau*gamma3*1/(gamma3*Theta)*(I3^2 + m*R^2*I3) */
    const double t64 = -t0; /* -s*omega_tau */
    const double t65 = x[4]*x[0]; /* s*gamma3 */
    const double t66 = -t65; /* -s*gamma3 */
    const double t67 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t68 = -t67; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t16;
    out[2] = t18;
    out[3] = t26;
    out[4] = t28;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t4;
    out[8] = 0.0;
    out[9] = t29;
    out[10] = t32;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t36;
    out[14] = t37;
    out[15] = t39;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t40;
    out[19] = t42;
    out[20] = t52;
    out[21] = t54;
    out[22] = t56;
    out[23] = t59;
    out[24] = t63;
    out[25] = t64;
    out[26] = 0.0;
    out[27] = t66;
    out[28] = 0.0;
    out[29] = t68;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t1 = x[0]*p[11]; /* gamma3*m*R*I3 */
    const double t2 = t0*t1; /* V*gamma3*m*R*I3 */
    const double t3 = x[4]*x[4]; /* s*s */
    const double t4 = JLT_FMA(x[0], x[0], t3); /* gamma3*gamma3 + s*s */
    const double t5 = JLT_FMA(p[10], t4, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t6 = x[0]*t5; /* gamma3*Theta */
    const double t7 = 1.0/t6; /* 1/(gamma3*Theta) */
    const double t8 = x[2]*p[12]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t9 = t3*t8; /* s*s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t10 = t5*t9; /* Theta*s*s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t11 = JLT_FNMA(t7, t10, t2); /* V*gamma3*m*R*I3 - 1/(gamma3*Theta)*Theta*s*s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t12 = x[0]*t7; /* gamma3*1/(gamma3*Theta) */
    const double t13 = t11*t12; /* t11*gamma3*1/(gamma3*Theta) */
    const double t14 = -t13; /* -t11*gamma3*1/(gamma3*Theta) */
    out[0] = t14;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = 1.0/x[0]; /* 1/gamma3 */
    const double t2 = p[8]*x[3]; /* R*I3*omega_n */
    const double t3 = JLT_FNMA(x[4], t2, p[6]); /* G_level - s*R*I3*omega_n */
    const double t4 = p[7]*t3; /* 1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t5 = t1*t4; /* 1/gamma3*1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t6 = x[4]*t5; /* s*1/gamma3*1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t7 = JLT_FMS(x[0], x[3], t6); /* gamma3*omega_n - s*1/gamma3*1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t8 = p[1]*t7; /* v_tau = R*t7 */
    const double t9 = JLT_FMA(t8, t8, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t10 = p[17]*t9; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t11 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t12 = JLT_FMA(x[3], x[3], t11); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t13 = JLT_FMA(t5, t5, t12); /* 1/gamma3*1/(R*I3)*(G_level - s*R*I3*omega_n)*1/gamma3*1/(R*I3)*(G_level - s*R*I3*omega_n) + omega_n*omega_n + omega_tau*omega_tau */
    const double t14 = JLT_FMA(p[18], t13, t10); /* energy = 1/2*I3*t13 + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t15 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t16 = p[19]*t15; /* m*I3^2*(R*omega_tau + v_nu) */
    const double t17 = t15*t16; /* (R*omega_tau + v_nu)*m*I3^2*(R*omega_tau + v_nu) */
    out[0] = t14;
    out[1] = t17;
    out[2] = t15;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*x[3]; /* R*omega_n */
    const double t1 = 1.0/x[0]; /* 1/gamma3 */
    const double t2 = t1*x[4]; /* 1/gamma3*s */
    const double t3 = x[3]*p[8]; /* omega_n*R*I3 */
    const double t4 = JLT_FNMA(x[4], t3, p[6]); /* G_level - s*omega_n*R*I3 */
    const double t5 = t1*t4; /* 1/gamma3*(G_level - s*omega_n*R*I3) */
    const double t6 = p[20]*t2; /* 1/I3*1/gamma3*s */
    const double t7 = JLT_FMA(t5, t6, t0); /* d(v_tau)/d(gamma3) = 1/gamma3*(G_level - s*omega_n*R*I3)*1/I3*1/gamma3*s + R*omega_n */
    const double t8 = t5*p[7]; /* 1/gamma3*(G_level - s*omega_n*R*I3)*1/(R*I3) */
    const double t9 = p[1]*t8; /* R*1/gamma3*(G_level - s*omega_n*R*I3)*1/(R*I3) */
    const double t10 = x[4]*t9; /* s*R*1/gamma3*(G_level - s*omega_n*R*I3)*1/(R*I3) */
    const double t11 = JLT_FMS(t0, x[0], t10); /* v_tau = R*omega_n*gamma3 - s*R*1/gamma3*(G_level - s*omega_n*R*I3)*1/(R*I3) */
    const double t12 = p[0]*t11; /* m*v_tau */
    const double t13 = t7*t12; /* d(v_tau)/d(gamma3)*m*v_tau */
    const double t14 = t1*t8; /* 1/gamma3*1/gamma3*(G_level - s*omega_n*R*I3)*1/(R*I3) */
    const double t15 = t5*p[21]; /* 1/gamma3*(G_level - s*omega_n*R*I3)*1/R */
    const double t16 = JLT_FNMA(t14, t15, t13); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau - 1/gamma3*1/gamma3*(G_level - s*omega_n*R*I3)*1/(R*I3)*1/gamma3*(G_level - s*omega_n*R*I3)*1/R */
    const double t17 = p[0]*x[1]; /* m*v_nu */
    const double t18 = p[5]*x[2]; /* I3*omega_tau */
    const double t19 = JLT_FMA(x[4], t2, x[0]); /* s*1/gamma3*s + gamma3 */
    const double t20 = p[1]*t19; /* R*(s*1/gamma3*s + gamma3) */
    const double t21 = t12*t20; /* m*v_tau*R*(s*1/gamma3*s + gamma3) */
    const double t22 = JLT_FNMA(t2, t8, x[3]); /* omega_n - 1/gamma3*s*1/gamma3*(G_level - s*omega_n*R*I3)*1/(R*I3) */
    const double t23 = JLT_FMA(p[5], t22, t21); /* d(energy)/d(omega_n) = I3*t22 + m*v_tau*R*(s*1/gamma3*s + gamma3) */
    const double t24 = JLT_FMS(t0, t2, t9); /* d(v_tau)/d(s) = R*omega_n*1/gamma3*s - R*1/gamma3*(G_level - s*omega_n*R*I3)*1/(R*I3) */
    const double t25 = t12*t24; /* m*v_tau*d(v_tau)/d(s) */
    const double t26 = x[3]*p[5]; /* omega_n*I3 */
    const double t27 = JLT_FNMA(t14, t26, t25); /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) - 1/gamma3*1/gamma3*(G_level - s*omega_n*R*I3)*1/(R*I3)*omega_n*I3 */
    const double t28 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t29 = p[22]*t28; /* 2*m*I3^2*(R*omega_tau + v_nu) */
    const double t30 = t28*p[23]; /* (R*omega_tau + v_nu)*2*m*R*I3^2 */
    out[0] = t16;
    out[1] = t17;
    out[2] = t18;
    out[3] = t23;
    out[4] = t27;
    out[5] = 0.0;
    out[6] = t29;
    out[7] = t30;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 1.0;
    out[12] = p[1];
    out[13] = 0.0;
    out[14] = 0.0;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[0]; /* 1/gamma3 */
    const double t1 = p[8]*x[3]; /* R*I3*omega_n */
    const double t2 = JLT_FNMA(x[4], t1, p[6]); /* G_level - s*R*I3*omega_n */
    const double t3 = p[24]*t2; /* (-1/(R*I3))*(G_level - s*R*I3*omega_n) */
    const double t4 = t0*t3; /* 1/gamma3*(-1/(R*I3))*(G_level - s*R*I3*omega_n) */
    out[0] = t4;
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
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t9[k] = x4[k]*p[8];
        t10[k] = (k == 0 ? p[6] : 0) - jlt_jet_product(x3, t9, k);
        t13[k] = jlt_jet_product(x4, x4, k);
        t15[k] = jlt_jet_product(x0, x0, k) + t13[k];
        t16[k] = p[10]*t15[k] + (k == 0 ? p[9] : 0);
        t17[k] = jlt_jet_product(x0, t16, k);
        t19[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t17, t19, k);
        t20[k] = p[7]*t10[k];
        t21[k] = jlt_jet_product(t16, t20, k);
        t22[k] = jlt_jet_product(t19, t21, k);
        t23[k] = jlt_jet_product(x3, x0, k);
        t24[k] = t23[k] - jlt_jet_product(x4, t22, k);
        t25[k] = jlt_jet_product(x3, t24, k);
        t26[k] = p[1]*t25[k];
        t27[k] = -t25[k];
        t30[k] = x2[k]*p[1] + x1[k];
        t31[k] = jlt_jet_product(x0, t19, k);
        t32[k] = p[11]*t30[k];
        t33[k] = x2[k] - jlt_jet_product(t31, t32, k);
        t34[k] = jlt_jet_product(t23, t33, k);
        t36[k] = t2[k]*p[12];
        t37[k] = jlt_jet_product(t22, t36, k);
        t38[k] = t34[k] - jlt_jet_product(t31, t37, k);
        t39[k] = jlt_jet_product(t2, x0, k);
        t40[k] = -t39[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t26[k]/(k + 1);
        next[2] = x2[k + 1] = t27[k]/(k + 1);
        next[3] = x3[k + 1] = t38[k]/(k + 1);
        next[4] = x4[k + 1] = t40[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = (0.0);
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double v_I3 = params[5];
    const double v_G_level = params[6];
    const double v_I1 = (v_I3);
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
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
    out[3] = (v_s)*((v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "regular",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 25,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 17, 7, 1, 0, 0, 9, 6 }, { 11, 48, 0, 4, 0, 0, 11, 7 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are" },
    .jacobian = { jacobian, 25, { 6, 36, 15, 1, 0, 0, 13, 13 }, { 41, 210, 0, 27, 0, 0, 14, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 9, 43, 16, 1, 0, 0, 15, 16 }, { 48, 241, 0, 30, 0, 0, 14, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are" },
    .divergence = { divergence, 1, { 1, 9, 4, 1, 0, 0, 8, 6 }, { 5, 28, 0, 3, 0, 0, 10, 5 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are" },
    .integral_values = { integral_values, 3, { 0, 10, 7, 1, 0, 0, 10, 4 }, { 8, 30, 0, 1, 0, 0, 14, 4 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 15, { 0, 20, 10, 1, 0, 0, 10, 9 }, { 13, 52, 0, 7, 0, 0, 12, 7 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 3, 1, 1, 0, 0, 4, 3 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_avx512,
    },
};
