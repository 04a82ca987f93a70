/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   19    7    1    0    0      9    8   (65)
 *  jacobian            6   40   20    1    0    0     12   16   (286)
 *  rhs_jacobian        7   46   23    1    0    0     13   15   (329)
 *  divergence          1   10    4    1    0    0      8    6   (36)
 *  integral_values     0   14   10    1    0    0      8    5   (55)
 *  integral_gradients  2   32   13    1    0    0      9    9   (138)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    3    1    1    0    0      4    3   (7)
 *
 *  Accuracy: divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
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
    const double t2 = params[1]*params[4]; /* R*I1 */
    const double t3 = params[5]*params[4]; /* I3*I1 */
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[0]*t4; /* m*R*R */
    const double t6 = params[4]*t5; /* I1*m*R*R */
    const double t7 = params[5]*t5; /* I3*m*R*R */
    const double t8 = params[5]/params[4]; /* I3/I1 */
    const double t9 = params[1]*params[0]; /* R*m */
    const double t10 = params[5]*t9; /* I3*R*m */
    const double t11 = params[5]*params[5]; /* I3*I3 */
    const double t12 = t7 + t11; /* I3*m*R*R + I3*I3 */
    const double t13 = 1.0/params[5]; /* 1/I3 */
    const double t14 = params[4]/params[5]; /* I1/I3 */
    const double t15 = params[1]*2.0; /* R*2 */
    const double t16 = 1.0/t2; /* 1/(R*I1) */
    const double t17 = params[5]*t11; /* I3*I3*I3 */
    const double t18 = t5*t17; /* m*R*R*I3*I3*I3 */
    const double t19 = 2.0*t18; /* 2*m*R*R*I3*I3*I3 */
    const double t20 = params[0]*params[0]; /* m*m */
    const double t21 = t4*t4; /* R*R*R*R */
    const double t22 = t20*t21; /* m*m*R*R*R*R */
    const double t23 = t11*t22; /* I3*I3*m*m*R*R*R*R */
    const double t24 = 2.0*t23; /* 2*I3*I3*m*m*R*R*R*R */
    const double t25 = t19 + t24; /* 2*m*R*R*I3*I3*I3 + 2*I3*I3*m*m*R*R*R*R */
    const double t26 = 2.0*t20; /* 2*m*m */
    const double t27 = params[1]*t4; /* R*R*R */
    const double t28 = t26*t27; /* 2*m*m*R*R*R */
    const double t29 = t11*t28; /* I3*I3*2*m*m*R*R*R */
    const double t30 = params[5]/params[1]; /* I3/R */
    const double t31 = t9 + t30; /* R*m + I3/R */
    const double t32 = -t10; /* -I3*R*m */
    const double t33 = t3 + t6; /* I3*I1 + I1*m*R*R */
    const double t34 = t6*t11; /* I1*m*R*R*I3*I3 */
    const double t35 = 2.0*t34; /* 2*I1*m*R*R*I3*I3 */
    const double t36 = params[4]*t22; /* I1*m*m*R*R*R*R */
    const double t37 = params[5]*t36; /* I3*I1*m*m*R*R*R*R */
    const double t38 = 2.0*t37; /* 2*I3*I1*m*m*R*R*R*R */
    const double t39 = t35 + t38; /* 2*I1*m*R*R*I3*I3 + 2*I3*I1*m*m*R*R*R*R */
    const double t40 = params[4]*t28; /* I1*2*m*m*R*R*R */
    const double t41 = params[5]*t40; /* I3*I1*2*m*m*R*R*R */
    const double t42 = params[0]/2.0; /* m/2 */
    const double t43 = params[4]/2.0; /* I1/2 */
    const double t44 = params[5]/2.0; /* I3/2 */
    const double t45 = params[4]*params[4]; /* I1*I1 */
    const double t46 = params[0]*t45; /* m*I1*I1 */
    const double t47 = params[4] - params[5]; /* I1 - I3 */
    const double t48 = 1.0/params[1]; /* 1/R */
    const double t49 = t2/params[5]; /* R*I1/I3 */
    const double t50 = params[0]*2.0; /* m*2 */
    const double t51 = t4*t50; /* R*R*m*2 */
    const double t52 = params[5]*t51; /* I3*R*R*m*2 */
    const double t53 = t47*t52; /* (I1 - I3)*I3*R*R*m*2 */
    const double t54 = 2.0*t47; /* 2*(I1 - I3) */
    const double t55 = t54/t0; /* 2*(I1 - I3)/(R*I3) */
    const double t56 = t45*t50; /* I1*I1*m*2 */
    const double t57 = params[1]*t50; /* R*m*2 */
    const double t58 = t45*t57; /* I1*I1*R*m*2 */
    const double t59 = params[4]*2.0; /* I1*2 */
    const double t60 = t47*t59; /* (I1 - I3)*I1*2 */
    const double t61 = t60/params[5]; /* (I1 - I3)*I1*2/I3 */
    const double t62 = params[4]*t51; /* I1*R*R*m*2 */
    const double t63 = t47*t62; /* (I1 - I3)*I1*R*R*m*2 */
    const double t64 = (-1.0)/t0; /* (-1)/(R*I3) */
    out[7] = t1;
    out[8] = t2;
    out[9] = t3;
    out[10] = t6;
    out[11] = t7;
    out[12] = t8;
    out[13] = t10;
    out[14] = t12;
    out[15] = t13;
    out[16] = t14;
    out[17] = t15;
    out[18] = t16;
    out[19] = t25;
    out[20] = t29;
    out[21] = t31;
    out[22] = t32;
    out[23] = t33;
    out[24] = t39;
    out[25] = t41;
    out[26] = t42;
    out[27] = t43;
    out[28] = t44;
    out[29] = t46;
    out[30] = t47;
    out[31] = t9;
    out[32] = t48;
    out[33] = t49;
    out[34] = t53;
    out[35] = t55;
    out[36] = t56;
    out[37] = t58;
    out[38] = t61;
    out[39] = t63;
    out[40] = t64;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t3 = x[3]*t2; /* omega_n*omega_n*gamma3 */
    const double t4 = x[4]*x[3]; /* s*omega_n */
    const double t5 = JLT_FNMA(p[8], t4, p[6]); /* G_level - R*I1*s*omega_n */
    const double t6 = x[4]*p[10]; /* s*m*R^2*I1 */
    const double t7 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t8 = JLT_FMA(x[4], t6, p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(x[0], t7, t8); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t10 = x[0]*t9; /* gamma3*Theta */
    const double t11 = 1.0/t10; /* 1/(gamma3*Theta) */
    const double t12 = p[7]*t5; /* 1/(R*I3)*(G_level - R*I1*s*omega_n) */
    const double t13 = t9*t12; /* Theta*1/(R*I3)*(G_level - R*I1*s*omega_n) */
    const double t14 = t11*t13; /* 1/(gamma3*Theta)*Theta*1/(R*I3)*(G_level - R*I1*s*omega_n) */
    const double t15 = t4*t14; /* s*omega_n*1/(gamma3*Theta)*Theta*1/(R*I3)*(G_level - R*I1*s*omega_n) */
    const double t16 = t3 - t15; /* omega_n*omega_n*gamma3 - t15 */
    const double t17 = p[1]*t16; /* R*(omega_n*omega_n*gamma3 - t15) */
    const double t18 = JLT_FMS(t15, p[12], t3); /* t15*I3/I1 - omega_n*omega_n*gamma3 */
    const double t19 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t20 = x[0]*t11; /* gamma3*1/(gamma3*Theta) */
    const double t21 = p[13]*t19; /* m*R*I3*V */
    const double t22 = JLT_FNMA(t20, t21, x[2]); /* omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V */
    const double t23 = t2*t22; /* omega_n*gamma3*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t24 = t0*p[14]; /* s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t25 = t14*t24; /* 1/(gamma3*Theta)*Theta*1/(R*I3)*(G_level - R*I1*s*omega_n)*s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t26 = JLT_FNMA(t20, t25, t23); /* t23 - gamma3*1/(gamma3*Theta)*t25 */
    const double t27 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t28 = -t27; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t17;
    out[2] = t18;
    out[3] = t26;
    out[4] = t28;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = x[4]*x[3]; /* s*omega_n */
    const double t6 = p[11]*x[0]; /* m*R^2*I3*gamma3 */
    const double t7 = JLT_FMA(t0, p[10], p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(x[0], t6, t7); /* Theta = gamma3*m*R^2*I3*gamma3 + s*s*m*R^2*I1 + I1*I3 */
    const double t9 = x[0]*t8; /* gamma3*Theta */
    const double t10 = 1.0/t9; /* 1/(gamma3*Theta) */
    const double t11 = t8*t10; /* Theta*1/(gamma3*Theta) */
    const double t12 = t5*t11; /* s*omega_n*Theta*1/(gamma3*Theta) */
    const double t13 = JLT_FNMA(t5, p[8], p[6]); /* G_level - s*omega_n*R*I1 */
    const double t14 = t11*t13; /* Theta*1/(gamma3*Theta)*(G_level - s*omega_n*R*I1) */
    const double t15 = t12*t14; /* s*omega_n*Theta*1/(gamma3*Theta)*Theta*1/(gamma3*Theta)*(G_level - s*omega_n*R*I1) */
    const double t16 = JLT_FMA(p[15], t15, t4); /* 1/I3*t15 + R*omega_n*omega_n */
    const double t17 = t14*p[7]; /* Theta*1/(gamma3*Theta)*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t18 = JLT_FMS(t12, p[16], t17); /* s*omega_n*Theta*1/(gamma3*Theta)*I1/I3 - Theta*1/(gamma3*Theta)*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t19 = p[1]*t18; /* R*t18 */
    const double t20 = x[4]*t19; /* s*R*t18 */
    const double t21 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t22 = JLT_FMA(p[17], t21, t20); /* 2*R*omega_n*gamma3 + s*R*t18 */
    const double t23 = x[3]*t19; /* omega_n*R*t18 */
    const double t24 = JLT_FMA(t15, p[18], t3); /* t15*1/(R*I1) + omega_n*omega_n */
    const double t25 = -t24; /* -(t15*1/(R*I1) + omega_n*omega_n) */
    const double t26 = 2.0*t21; /* 2*omega_n*gamma3 */
    const double t27 = JLT_FNMA(t17, p[12], t12); /* s*omega_n*Theta*1/(gamma3*Theta) - Theta*1/(gamma3*Theta)*(G_level - s*omega_n*R*I1)*1/(R*I3)*I3/I1 */
    const double t28 = JLT_FMA(x[4], t27, t26); /* s*t27 + 2*omega_n*gamma3 */
    const double t29 = -t28; /* -(s*t27 + 2*omega_n*gamma3) */
    const double t30 = x[3]*t27; /* omega_n*t27 */
    const double t31 = -t30; /* -omega_n*t27 */
    const double t32 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t33 = x[0]*t10; /* gamma3*1/(gamma3*Theta) */
    const double t34 = p[13]*t32; /* m*R*I3*V */
    const double t35 = JLT_FNMA(t33, t34, x[2]); /* omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V */
    const double t36 = x[3]*t35; /* omega_n*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t37 = x[4]*t33; /* s*gamma3*1/(gamma3*Theta) */
    const double t38 = x[2]*t37; /* omega_tau*s*gamma3*1/(gamma3*Theta) */
    const double t39 = t17*t38; /* Theta*1/(gamma3*Theta)*(G_level - s*omega_n*R*I1)*1/(R*I3)*omega_tau*s*gamma3*1/(gamma3*Theta) */
    const double t40 = p[19]*t39; /* (2*m*R^2*I3^3 + 2*m^2*R^4*I3^2)*t39 */
    const double t41 = t21*t33; /* omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t42 = t32*t41; /* V*omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t43 = JLT_FMA(p[20], t42, t40); /* 2*m^2*R^3*I3^2*V*omega_n*gamma3*gamma3*1/(gamma3*Theta) + (2*m*R^2*I3^3 + 2*m^2*R^4*I3^2)*t39 */
    const double t44 = x[0]*t33; /* gamma3*gamma3*1/(gamma3*Theta) */
    const double t45 = t11*t38; /* Theta*1/(gamma3*Theta)*omega_tau*s*gamma3*1/(gamma3*Theta) */
    const double t46 = t14*p[21]; /* Theta*1/(gamma3*Theta)*(G_level - s*omega_n*R*I1)*(m*R + I3/R) */
    const double t47 = JLT_FMA(t45, t46, t36); /* Theta*1/(gamma3*Theta)*omega_tau*s*gamma3*1/(gamma3*Theta)*t46 + omega_n*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t48 = JLT_FMA(t43, t44, t47); /* t43*gamma3*gamma3*1/(gamma3*Theta) + t47 */
    const double t49 = t41*p[22]; /* omega_n*gamma3*gamma3*1/(gamma3*Theta)*(-m*R*I3) */
    const double t50 = t17*p[14]; /* Theta*1/(gamma3*Theta)*(G_level - s*omega_n*R*I1)*1/(R*I3)*(I3^2 + m*R^2*I3) */
    const double t51 = JLT_FNMA(p[11], t41, t21); /* omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t52 = JLT_FNMA(t37, t50, t51); /* t51 - s*gamma3*1/(gamma3*Theta)*t50 */
    const double t53 = x[0]*t35; /* gamma3*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t54 = t45*p[23]; /* Theta*1/(gamma3*Theta)*omega_tau*s*gamma3*1/(gamma3*Theta)*(I1*I3 + m*R^2*I1) */
    const double t55 = JLT_FMA(x[4], t54, t53); /* s*t54 + gamma3*(omega_tau - gamma3*1/(gamma3*Theta)*m*R*I3*V) */
    const double t56 = x[2]*t33; /* omega_tau*gamma3*1/(gamma3*Theta) */
    const double t57 = t50*t56; /* t50*omega_tau*gamma3*1/(gamma3*Theta) */
    const double t58 = t39*p[24]; /* t39*(2*m*R^2*I1*I3^2 + 2*m^2*R^4*I1*I3) */
    const double t59 = JLT_FMA(t42, p[25], t58); /* V*omega_n*gamma3*gamma3*1/(gamma3*Theta)*2*m^2*R^3*I1*I3 + t39*(2*m*R^2*I1*I3^2 + 2*m^2*R^4*I1*I3) */
    const double t60 = JLT_FMS(x[3], t54, t57); /* omega_n*t54 - t50*omega_tau*gamma3*1/(gamma3*Theta) */
    const double t61 = JLT_FMA(t37, t59, t60); /* s*gamma3*1/(gamma3*Theta)*t59 + omega_n*t54 - t50*omega_tau*gamma3*1/(gamma3*Theta) */
    const double t62 = -t1; /* -s*omega_tau */
    const double t63 = x[4]*x[0]; /* s*gamma3 */
    const double t64 = -t63; /* -s*gamma3 */
    const double t65 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t66 = -t65; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t16;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t22;
    out[9] = t23;
    out[10] = t25;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t29;
    out[14] = t31;
    out[15] = t48;
    out[16] = t49;
    out[17] = t52;
    out[18] = t55;
    out[19] = t61;
    out[20] = t62;
    out[21] = 0.0;
    out[22] = t64;
    out[23] = 0.0;
    out[24] = t66;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[4]*x[3]; /* s*omega_n */
    const double t3 = JLT_FNMA(p[8], t2, p[6]); /* G_level - R*I1*s*omega_n */
    const double t4 = x[4]*x[4]; /* s*s */
    const double t5 = p[11]*x[0]; /* m*R^2*I3*gamma3 */
    const double t6 = JLT_FMA(p[10], t4, p[9]); /* m*R^2*I1*s*s + I1*I3 */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta = gamma3*m*R^2*I3*gamma3 + m*R^2*I1*s*s + I1*I3 */
    const double t8 = x[0]*t7; /* gamma3*Theta */
    const double t9 = 1.0/t8; /* 1/(gamma3*Theta) */
    const double t10 = t7*t9; /* Theta*1/(gamma3*Theta) */
    const double t11 = t3*t10; /* (G_level - R*I1*s*omega_n)*Theta*1/(gamma3*Theta) */
    const double t12 = p[7]*t11; /* 1/(R*I3)*(G_level - R*I1*s*omega_n)*Theta*1/(gamma3*Theta) */
    const double t13 = t2*t12; /* s*omega_n*1/(R*I3)*(G_level - R*I1*s*omega_n)*Theta*1/(gamma3*Theta) */
    const double t14 = p[1]*t13; /* R*t13 */
    const double t15 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t16 = p[1]*x[3]; /* R*omega_n */
    const double t17 = JLT_FMS(t15, t16, t14); /* omega_n*gamma3*R*omega_n - R*t13 */
    const double t18 = x[3]*t15; /* omega_n*omega_n*gamma3 */
    const double t19 = JLT_FMS(t13, p[12], t18); /* t13*I3/I1 - omega_n*omega_n*gamma3 */
    const double t20 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t21 = x[0]*t9; /* gamma3*1/(gamma3*Theta) */
    const double t22 = t20*t21; /* V*gamma3*1/(gamma3*Theta) */
    const double t23 = JLT_FNMA(p[13], t22, x[2]); /* omega_tau - m*R*I3*V*gamma3*1/(gamma3*Theta) */
    const double t24 = t15*t23; /* omega_n*gamma3*(omega_tau - m*R*I3*V*gamma3*1/(gamma3*Theta)) */
    const double t25 = t0*t21; /* s*omega_tau*gamma3*1/(gamma3*Theta) */
    const double t26 = p[14]*t25; /* (I3^2 + m*R^2*I3)*s*omega_tau*gamma3*1/(gamma3*Theta) */
    const double t27 = JLT_FNMA(t12, t26, t24); /* t24 - 1/(R*I3)*(G_level - R*I1*s*omega_n)*Theta*1/(gamma3*Theta)*(I3^2 + m*R^2*I3)*s*omega_tau*gamma3*1/(gamma3*Theta) */
    const double t28 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t29 = -t28; /* -s*omega_tau*gamma3 */
    const double t30 = t0*2.0; /* s*omega_tau*2 */
    const double t31 = x[3]*t16; /* omega_n*R*omega_n */
    const double t32 = t2*t10; /* s*omega_n*Theta*1/(gamma3*Theta) */
    const double t33 = t11*t32; /* (G_level - R*I1*s*omega_n)*Theta*1/(gamma3*Theta)*s*omega_n*Theta*1/(gamma3*Theta) */
    const double t34 = JLT_FMA(p[15], t33, t31); /* 1/I3*t33 + omega_n*R*omega_n */
    const double t35 = JLT_FMS(t32, p[16], t12); /* s*omega_n*Theta*1/(gamma3*Theta)*I1/I3 - 1/(R*I3)*(G_level - R*I1*s*omega_n)*Theta*1/(gamma3*Theta) */
    const double t36 = x[4]*p[1]; /* s*R */
    const double t37 = t35*t36; /* t35*s*R */
    const double t38 = JLT_FMA(t15, p[17], t37); /* omega_n*gamma3*2*R + t35*s*R */
    const double t39 = t16*t35; /* R*omega_n*t35 */
    const double t40 = x[3]*x[3]; /* omega_n*omega_n */
    const double t41 = JLT_FMA(t33, p[18], t40); /* t33*1/(R*I1) + omega_n*omega_n */
    const double t42 = -t41; /* -(t33*1/(R*I1) + omega_n*omega_n) */
    const double t43 = t15*2.0; /* omega_n*gamma3*2 */
    const double t44 = JLT_FNMA(t12, p[12], t32); /* s*omega_n*Theta*1/(gamma3*Theta) - 1/(R*I3)*(G_level - R*I1*s*omega_n)*Theta*1/(gamma3*Theta)*I3/I1 */
    const double t45 = JLT_FMA(x[4], t44, t43); /* s*t44 + omega_n*gamma3*2 */
    const double t46 = -t45; /* -(s*t44 + omega_n*gamma3*2) */
    const double t47 = x[3]*t44; /* omega_n*t44 */
    const double t48 = -t47; /* -omega_n*t44 */
    const double t49 = x[3]*t23; /* omega_n*(omega_tau - m*R*I3*V*gamma3*1/(gamma3*Theta)) */
    const double t50 = t12*t21; /* 1/(R*I3)*(G_level - R*I1*s*omega_n)*Theta*1/(gamma3*Theta)*gamma3*1/(gamma3*Theta) */
    const double t51 = t25*t50; /* s*omega_tau*gamma3*1/(gamma3*Theta)*t50 */
    const double t52 = p[19]*t51; /* (2*m*R^2*I3^3 + 2*m^2*R^4*I3^2)*s*omega_tau*gamma3*1/(gamma3*Theta)*t50 */
    const double t53 = t15*t21; /* omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t54 = t22*t53; /* V*gamma3*1/(gamma3*Theta)*omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t55 = JLT_FMA(p[20], t54, t52); /* 2*m^2*R^3*I3^2*t54 + t52 */
    const double t56 = t10*t25; /* Theta*1/(gamma3*Theta)*s*omega_tau*gamma3*1/(gamma3*Theta) */
    const double t57 = t11*p[21]; /* (G_level - R*I1*s*omega_n)*Theta*1/(gamma3*Theta)*(m*R + I3/R) */
    const double t58 = JLT_FMA(t56, t57, t49); /* Theta*1/(gamma3*Theta)*s*omega_tau*gamma3*1/(gamma3*Theta)*t57 + omega_n*(omega_tau - m*R*I3*V*gamma3*1/(gamma3*Theta)) */
    const double t59 = JLT_FMA(x[0], t55, t58); /* gamma3*(2*m^2*R^3*I3^2*t54 + t52) + t58 */
    const double t60 = t53*p[22]; /* omega_n*gamma3*gamma3*1/(gamma3*Theta)*(-m*R*I3) */
    const double t61 = p[14]*t50; /* (I3^2 + m*R^2*I3)*t50 */
    const double t62 = JLT_FNMA(p[11], t53, t15); /* omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*gamma3*1/(gamma3*Theta) */
    const double t63 = JLT_FNMA(x[4], t61, t62); /* t62 - s*(I3^2 + m*R^2*I3)*t50 */
    const double t64 = x[0]*t23; /* gamma3*(omega_tau - m*R*I3*V*gamma3*1/(gamma3*Theta)) */
    const double t65 = t56*p[23]; /* Theta*1/(gamma3*Theta)*s*omega_tau*gamma3*1/(gamma3*Theta)*(I1*I3 + m*R^2*I1) */
    const double t66 = JLT_FMA(x[4], t65, t64); /* s*t65 + gamma3*(omega_tau - m*R*I3*V*gamma3*1/(gamma3*Theta)) */
    const double t67 = x[2]*t61; /* omega_tau*(I3^2 + m*R^2*I3)*t50 */
    const double t68 = t51*p[24]; /* s*omega_tau*gamma3*1/(gamma3*Theta)*t50*(2*m*R^2*I1*I3^2 + 2*m^2*R^4*I1*I3) */
    const double t69 = JLT_FMA(t54, p[25], t68); /* t54*2*m^2*R^3*I1*I3 + t68 */
    const double t70 = JLT_FMS(x[3], t65, t67); /* omega_n*t65 - omega_tau*(I3^2 + m*R^2*I3)*t50 */
    const double t71 = JLT_FMA(x[4], t69, t70); /* s*(t54*2*m^2*R^3*I1*I3 + t68) + omega_n*t65 - omega_tau*(I3^2 + m*R^2*I3)*t50 */
    const double t72 = -t0; /* -s*omega_tau */
    const double t73 = x[4]*x[0]; /* s*gamma3 */
    const double t74 = -t73; /* -s*gamma3 */
    const double t75 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t76 = -t75; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t17;
    out[2] = t19;
    out[3] = t27;
    out[4] = t29;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t4;
    out[8] = 0.0;
    out[9] = t30;
    out[10] = t34;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t38;
    out[14] = t39;
    out[15] = t42;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t46;
    out[19] = t48;
    out[20] = t59;
    out[21] = t60;
    out[22] = t63;
    out[23] = t66;
    out[24] = t71;
    out[25] = t72;
    out[26] = 0.0;
    out[27] = t74;
    out[28] = 0.0;
    out[29] = t76;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t1 = x[0]*p[13]; /* gamma3*m*R*I3 */
    const double t2 = t0*t1; /* V*gamma3*m*R*I3 */
    const double t3 = x[4]*x[4]; /* s*s */
    const double t4 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t5 = JLT_FMA(p[10], t3, p[9]); /* m*R^2*I1*s*s + I1*I3 */
    const double t6 = JLT_FMA(x[0], t4, t5); /* Theta = gamma3*gamma3*m*R^2*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t7 = x[0]*t6; /* gamma3*Theta */
    const double t8 = 1.0/t7; /* 1/(gamma3*Theta) */
    const double t9 = x[2]*p[23]; /* omega_tau*(I1*I3 + m*R^2*I1) */
    const double t10 = t3*t9; /* s*s*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t11 = t6*t10; /* Theta*s*s*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t12 = JLT_FNMA(t8, t11, t2); /* V*gamma3*m*R*I3 - 1/(gamma3*Theta)*Theta*s*s*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t13 = x[0]*t8; /* gamma3*1/(gamma3*Theta) */
    const double t14 = t12*t13; /* t12*gamma3*1/(gamma3*Theta) */
    const double t15 = -t14; /* -t12*gamma3*1/(gamma3*Theta) */
    out[0] = t15;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t2 = 1.0/x[0]; /* 1/gamma3 */
    const double t3 = x[3]*p[8]; /* omega_n*R*I1 */
    const double t4 = JLT_FNMA(x[4], t3, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t5 = p[7]*t4; /* 1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t6 = t2*t5; /* 1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t7 = JLT_FNMA(x[4], t6, t1); /* omega_n*gamma3 - s*1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t8 = p[1]*t7; /* v_tau = R*t7 */
    const double t9 = JLT_FMA(t8, t8, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t10 = x[3]*x[3]; /* omega_n*omega_n */
    const double t11 = JLT_FMA(x[2], x[2], t10); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t12 = p[27]*t11; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t13 = t6*t6; /* 1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I1)*1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I1) */
    const double t14 = JLT_FMA(p[28], t13, t12); /* 1/2*I3*t13 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t15 = JLT_FMA(p[26], t9, t14); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + 1/2*I3*t13 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t16 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t17 = p[29]*t16; /* m*I1^2*(R*omega_tau + v_nu) */
    const double t18 = t16*t17; /* (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    const double t19 = x[4]*p[10]; /* s*m*R^2*I1 */
    const double t20 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t21 = JLT_FMA(x[4], t19, p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t22 = JLT_FMA(x[0], t20, t21); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t23 = p[30]*t22; /* (I1 - I3)*Theta */
    const double t24 = JLT_FMA(t13, t23, t18); /* t13*(I1 - I3)*Theta + (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    out[0] = t15;
    out[1] = t24;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*x[3]; /* R*omega_n */
    const double t1 = 1.0/x[0]; /* 1/gamma3 */
    const double t2 = t1*x[4]; /* 1/gamma3*s */
    const double t3 = x[3]*p[8]; /* omega_n*R*I1 */
    const double t4 = JLT_FNMA(x[4], t3, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t5 = t1*t4; /* 1/gamma3*(G_level - s*omega_n*R*I1) */
    const double t6 = p[15]*t2; /* 1/I3*1/gamma3*s */
    const double t7 = JLT_FMA(t5, t6, t0); /* d(v_tau)/d(gamma3) = 1/gamma3*(G_level - s*omega_n*R*I1)*1/I3*1/gamma3*s + R*omega_n */
    const double t8 = t5*p[7]; /* 1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t9 = x[4]*t8; /* s*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t10 = JLT_FMS(x[3], x[0], t9); /* omega_n*gamma3 - s*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t11 = p[31]*t10; /* m*R*t10 */
    const double t12 = t7*t11; /* d(v_tau)/d(gamma3)*m*R*t10 */
    const double t13 = t1*t8; /* 1/gamma3*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t14 = t5*t13; /* 1/gamma3*(G_level - s*omega_n*R*I1)*1/gamma3*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t15 = JLT_FNMA(p[32], t14, t12); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*R*t10 - 1/R*t14 */
    const double t16 = p[0]*x[1]; /* m*v_nu */
    const double t17 = p[4]*x[2]; /* I1*omega_tau */
    const double t18 = t2*t8; /* 1/gamma3*s*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t19 = x[3] - t18; /* omega_n - 1/gamma3*s*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t20 = p[4]*t19; /* I1*t19 */
    const double t21 = p[1]*x[0]; /* R*gamma3 */
    const double t22 = t2*p[33]; /* 1/gamma3*s*R*I1/I3 */
    const double t23 = JLT_FMA(x[4], t22, t21); /* d(v_tau)/d(omega_n) = s*1/gamma3*s*R*I1/I3 + R*gamma3 */
    const double t24 = JLT_FMA(t11, t23, t20); /* d(energy)/d(omega_n) = m*R*t10*d(v_tau)/d(omega_n) + I1*t19 */
    const double t25 = p[1]*t8; /* R*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t26 = JLT_FMS(x[3], t22, t25); /* d(v_tau)/d(s) = omega_n*1/gamma3*s*R*I1/I3 - R*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t27 = t11*t26; /* m*R*t10*d(v_tau)/d(s) */
    const double t28 = x[3]*t13; /* omega_n*1/gamma3*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t29 = JLT_FNMA(p[4], t28, t27); /* d(energy)/d(s) = m*R*t10*d(v_tau)/d(s) - I1*t28 */
    const double t30 = t8*t8; /* 1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3)*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3) */
    const double t31 = x[0]*p[34]; /* gamma3*2*m*R^2*I3*(I1 - I3) */
    const double t32 = t30*t31; /* t30*gamma3*2*m*R^2*I3*(I1 - I3) */
    const double t33 = x[4]*p[10]; /* s*m*R^2*I1 */
    const double t34 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t35 = JLT_FMA(x[4], t33, p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t36 = JLT_FMA(x[0], t34, t35); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t37 = p[35]*t36; /* 2*(I1 - I3)/(R*I3)*Theta */
    const double t38 = JLT_FNMA(t14, t37, t32); /* t30*gamma3*2*m*R^2*I3*(I1 - I3) - t14*2*(I1 - I3)/(R*I3)*Theta */
    const double t39 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t40 = p[36]*t39; /* 2*m*I1^2*(R*omega_tau + v_nu) */
    const double t41 = t39*p[37]; /* (R*omega_tau + v_nu)*2*m*R*I1^2 */
    const double t42 = t36*p[38]; /* Theta*2*I1*(I1 - I3)/I3 */
    const double t43 = t18*t42; /* 1/gamma3*s*1/gamma3*(G_level - s*omega_n*R*I1)*1/(R*I3)*Theta*2*I1*(I1 - I3)/I3 */
    const double t44 = -t43; /* -t43 */
    const double t45 = x[4]*p[39]; /* s*2*m*R^2*I1*(I1 - I3) */
    const double t46 = t30*t45; /* t30*s*2*m*R^2*I1*(I1 - I3) */
    const double t47 = JLT_FNMA(t28, t42, t46); /* t30*s*2*m*R^2*I1*(I1 - I3) - t28*Theta*2*I1*(I1 - I3)/I3 */
    out[0] = t15;
    out[1] = t16;
    out[2] = t17;
    out[3] = t24;
    out[4] = t29;
    out[5] = t38;
    out[6] = t40;
    out[7] = t41;
    out[8] = t44;
    out[9] = t47;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[0]; /* 1/gamma3 */
    const double t1 = p[8]*x[3]; /* R*I1*omega_n */
    const double t2 = JLT_FNMA(x[4], t1, p[6]); /* G_level - s*R*I1*omega_n */
    const double t3 = p[40]*t2; /* (-1/(R*I3))*(G_level - s*R*I1*omega_n) */
    const double t4 = t0*t3; /* 1/gamma3*(-1/(R*I3))*(G_level - s*R*I1*omega_n) */
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
    double t7[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t7[k] = jlt_jet_product(x3, x0, k);
        t8[k] = jlt_jet_product(x3, t7, k);
        t12[k] = jlt_jet_product(x4, x3, k);
        t13[k] = (k == 0 ? p[6] : 0) - p[8]*t12[k];
        t16[k] = x4[k]*p[10];
        t18[k] = x0[k]*p[11];
        t19[k] = jlt_jet_product(x4, t16, k) + (k == 0 ? p[9] : 0);
        t20[k] = jlt_jet_product(x0, t18, k) + t19[k];
        t21[k] = jlt_jet_product(x0, t20, k);
        t23[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t21, t23, k);
        t24[k] = p[7]*t13[k];
        t25[k] = jlt_jet_product(t20, t24, k);
        t26[k] = jlt_jet_product(t23, t25, k);
        t27[k] = jlt_jet_product(t12, t26, k);
        t28[k] = t8[k] - t27[k];
        t29[k] = p[1]*t28[k];
        t31[k] = t27[k]*p[12] - t8[k];
        t34[k] = x2[k]*p[1] + x1[k];
        t35[k] = jlt_jet_product(x0, t23, k);
        t36[k] = p[13]*t34[k];
        t37[k] = x2[k] - jlt_jet_product(t35, t36, k);
        t38[k] = jlt_jet_product(t7, t37, k);
        t40[k] = t2[k]*p[14];
        t41[k] = jlt_jet_product(t26, t40, k);
        t42[k] = t38[k] - jlt_jet_product(t35, t41, k);
        t43[k] = jlt_jet_product(t2, x0, k);
        t44[k] = -t43[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t29[k]/(k + 1);
        next[2] = x2[k + 1] = t31[k]/(k + 1);
        next[3] = x3[k + 1] = t42[k]/(k + 1);
        next[4] = x4[k + 1] = t44[k]/(k + 1);
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
    const double v_I1 = params[4];
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
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "regular",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 41,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 19, 7, 1, 0, 0, 9, 8 }, { 11, 49, 0, 5, 0, 0, 11, 7 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .jacobian = { jacobian, 25, { 6, 40, 20, 1, 0, 0, 12, 16 }, { 41, 216, 0, 29, 0, 0, 15, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 7, 46, 23, 1, 0, 0, 13, 15 }, { 48, 248, 0, 33, 0, 0, 15, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .divergence = { divergence, 1, { 1, 10, 4, 1, 0, 0, 8, 6 }, { 5, 28, 0, 3, 0, 0, 10, 5 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .integral_values = { integral_values, 2, { 0, 14, 10, 1, 0, 0, 8, 5 }, { 11, 43, 0, 1, 0, 0, 13, 6 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 10, { 2, 32, 13, 1, 0, 0, 9, 9 }, { 23, 105, 0, 10, 0, 0, 12, 9 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 3, 1, 1, 0, 0, 4, 3 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx512,
    },
};
