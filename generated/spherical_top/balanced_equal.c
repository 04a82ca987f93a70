/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 6   15    4    1    1    0     11    5   (61)
 *  jacobian            8   24    7    1    1    0     12    8   (143)
 *  rhs_jacobian        14   28    8    1    1    0     12   12   (186)
 *  divergence          2    8    3    1    1    0      8    6   (25)
 *  integral_values     2   10    7    0    1    0      9    4   (42)
 *  integral_gradients  2   16    6    1    1    0      8    7   (53)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[5];
    out[5] = params[5];
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[5]*params[5]; /* I3*I3 */
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    const double t3 = params[5]*t2; /* I3*m*R*R */
    const double t4 = params[0]*params[1]; /* m*R */
    const double t5 = params[5]*t4; /* I3*m*R */
    const double t6 = t0 + t3; /* I3*I3 + I3*m*R*R */
    const double t7 = -t4; /* -m*R */
    const double t8 = -t5; /* -I3*m*R */
    const double t9 = -t3; /* -I3*m*R*R */
    const double t10 = params[0]/2.0; /* m/2 */
    const double t11 = params[5]/2.0; /* I3/2 */
    const double t12 = params[5]*params[1]; /* I3*R */
    const double t13 = -t12; /* -I3*R */
    const double t14 = t0*params[0]; /* I3*I3*m */
    const double t15 = params[0]*2.0; /* m*2 */
    const double t16 = t0*t15; /* I3*I3*m*2 */
    const double t17 = params[1]*t15; /* R*m*2 */
    const double t18 = t0*t17; /* I3*I3*R*m*2 */
    out[6] = t0;
    out[7] = t3;
    out[8] = t5;
    out[9] = t6;
    out[10] = t8;
    out[11] = t9;
    out[12] = t10;
    out[13] = t11;
    out[14] = t13;
    out[15] = t14;
    out[16] = t7;
    out[17] = t4;
    out[18] = t12;
    out[19] = t16;
    out[20] = t18;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(1 + gamma3) */
    const double t6 = JLT_FMA(p[7], t5, p[6]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(1 + gamma3)) + I3^2 */
    const double t7 = t3*t6; /* s*Theta */
    const double t8 = 1.0/t7; /* 1/(s*Theta) */
    const double t9 = x[0]*x[3]; /* gamma3*omega_n */
    const double t10 = t6*t9; /* Theta*gamma3*omega_n */
    const double t11 = t8*t10; /* 1/(s*Theta)*Theta*gamma3*omega_n */
    const double t12 = t11 + x[4]; /* 1/(s*Theta)*Theta*gamma3*omega_n + omega3 */
    const double t13 = x[3]*t12; /* omega_n*(1/(s*Theta)*Theta*gamma3*omega_n + omega3) */
    const double t14 = p[1]*t13; /* R*omega_n*(1/(s*Theta)*Theta*gamma3*omega_n + omega3) */
    const double t15 = -t13; /* -omega_n*(1/(s*Theta)*Theta*gamma3*omega_n + omega3) */
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = t3*t8; /* s*1/(s*Theta) */
    const double t18 = p[8]*t16; /* m*R*I3*V */
    const double t19 = t17*t18; /* s*1/(s*Theta)*m*R*I3*V */
    const double t20 = x[2] - t19; /* omega_tau - s*1/(s*Theta)*m*R*I3*V */
    const double t21 = t11*t20; /* 1/(s*Theta)*Theta*gamma3*omega_n*(omega_tau - s*1/(s*Theta)*m*R*I3*V) */
    const double t22 = x[2]*p[9]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t23 = x[4]*t22; /* omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t24 = JLT_FMA(t17, t23, t21); /* s*1/(s*Theta)*omega3*omega_tau*(I3^2 + m*R^2*I3) + t21 */
    const double t25 = x[3]*t19; /* omega_n*s*1/(s*Theta)*m*R*I3*V */
    const double t26 = -t25; /* -omega_n*s*1/(s*Theta)*m*R*I3*V */
    out[0] = t4;
    out[1] = t14;
    out[2] = t15;
    out[3] = t24;
    out[4] = t26;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[7], t3, p[6]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1)) + I3^2 */
    const double t5 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = t4*t5; /* Theta*s */
    const double t7 = 1.0/t6; /* 1/(Theta*s) */
    const double t8 = t4*t7; /* Theta*1/(Theta*s) */
    const double t9 = x[0]*t8; /* gamma3*Theta*1/(Theta*s) */
    const double t10 = x[2]*t9; /* omega_tau*gamma3*Theta*1/(Theta*s) */
    const double t11 = -t10; /* -omega_tau*gamma3*Theta*1/(Theta*s) */
    const double t12 = JLT_FMA(t9, t9, 1.0); /* gamma3*Theta*1/(Theta*s)*gamma3*Theta*1/(Theta*s) + 1 */
    const double t13 = t8*x[3]; /* Theta*1/(Theta*s)*omega_n */
    const double t14 = t12*t13; /* (gamma3*Theta*1/(Theta*s)*gamma3*Theta*1/(Theta*s) + 1)*Theta*1/(Theta*s)*omega_n */
    const double t15 = x[3]*p[1]; /* omega_n*R */
    const double t16 = t14*t15; /* t14*omega_n*R */
    const double t17 = t9*x[3]; /* gamma3*Theta*1/(Theta*s)*omega_n */
    const double t18 = JLT_FMA(2.0, t17, x[4]); /* 2*gamma3*Theta*1/(Theta*s)*omega_n + omega3 */
    const double t19 = p[1]*t18; /* R*(2*gamma3*Theta*1/(Theta*s)*omega_n + omega3) */
    const double t20 = x[3]*t14; /* omega_n*t14 */
    const double t21 = -t20; /* -omega_n*t14 */
    const double t22 = -t18; /* -(2*gamma3*Theta*1/(Theta*s)*omega_n + omega3) */
    const double t23 = -x[3]; /* -omega_n */
    const double t24 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t25 = t5*t7; /* s*1/(Theta*s) */
    const double t26 = p[8]*t24; /* m*R*I3*V */
    const double t27 = t25*t26; /* s*1/(Theta*s)*m*R*I3*V */
    const double t28 = x[2] - t27; /* omega_tau - s*1/(Theta*s)*m*R*I3*V */
    const double t29 = t14*t28; /* t14*(omega_tau - s*1/(Theta*s)*m*R*I3*V) */
    const double t30 = x[3]*t25; /* omega_n*s*1/(Theta*s) */
    const double t31 = t9*t30; /* gamma3*Theta*1/(Theta*s)*omega_n*s*1/(Theta*s) */
    const double t32 = p[10]*t31; /* (-m*R*I3)*gamma3*Theta*1/(Theta*s)*omega_n*s*1/(Theta*s) */
    const double t33 = t25*p[9]; /* s*1/(Theta*s)*(I3^2 + m*R^2*I3) */
    const double t34 = JLT_FMA(x[4], t33, t17); /* omega3*s*1/(Theta*s)*(I3^2 + m*R^2*I3) + gamma3*Theta*1/(Theta*s)*omega_n */
    const double t35 = JLT_FNMA(p[7], t31, t34); /* t34 - m*R^2*I3*gamma3*Theta*1/(Theta*s)*omega_n*s*1/(Theta*s) */
    const double t36 = t9*t28; /* gamma3*Theta*1/(Theta*s)*(omega_tau - s*1/(Theta*s)*m*R*I3*V) */
    const double t37 = x[2]*t33; /* omega_tau*s*1/(Theta*s)*(I3^2 + m*R^2*I3) */
    const double t38 = p[10]*t30; /* (-m*R*I3)*omega_n*s*1/(Theta*s) */
    const double t39 = t30*p[11]; /* omega_n*s*1/(Theta*s)*(-m*R^2*I3) */
    const double t40 = -t27; /* -s*1/(Theta*s)*m*R*I3*V */
    out[0] = t11;
    out[1] = 0.0;
    out[2] = t5;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t16;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t19;
    out[9] = t15;
    out[10] = t21;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t22;
    out[14] = t23;
    out[15] = t29;
    out[16] = t32;
    out[17] = t35;
    out[18] = t36;
    out[19] = t37;
    out[20] = 0.0;
    out[21] = t38;
    out[22] = t39;
    out[23] = t40;
    out[24] = 0.0;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(1 + gamma3) */
    const double t6 = JLT_FMA(p[7], t5, p[6]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(1 + gamma3)) + I3^2 */
    const double t7 = t3*t6; /* s*Theta */
    const double t8 = 1.0/t7; /* 1/(s*Theta) */
    const double t9 = t6*t8; /* Theta*1/(s*Theta) */
    const double t10 = x[0]*t9; /* gamma3*Theta*1/(s*Theta) */
    const double t11 = x[3]*t10; /* omega_n*gamma3*Theta*1/(s*Theta) */
    const double t12 = x[4] + t11; /* omega3 + omega_n*gamma3*Theta*1/(s*Theta) */
    const double t13 = x[3]*p[1]; /* omega_n*R */
    const double t14 = t12*t13; /* (omega3 + omega_n*gamma3*Theta*1/(s*Theta))*omega_n*R */
    const double t15 = x[3]*t12; /* omega_n*(omega3 + omega_n*gamma3*Theta*1/(s*Theta)) */
    const double t16 = -t15; /* -omega_n*(omega3 + omega_n*gamma3*Theta*1/(s*Theta)) */
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t18 = t3*t8; /* s*1/(s*Theta) */
    const double t19 = p[8]*t18; /* m*R*I3*s*1/(s*Theta) */
    const double t20 = t17*t19; /* V*m*R*I3*s*1/(s*Theta) */
    const double t21 = x[2] - t20; /* omega_tau - V*m*R*I3*s*1/(s*Theta) */
    const double t22 = t11*t21; /* omega_n*gamma3*Theta*1/(s*Theta)*(omega_tau - V*m*R*I3*s*1/(s*Theta)) */
    const double t23 = t18*p[9]; /* s*1/(s*Theta)*(I3^2 + m*R^2*I3) */
    const double t24 = x[2]*t23; /* omega_tau*s*1/(s*Theta)*(I3^2 + m*R^2*I3) */
    const double t25 = JLT_FMA(x[4], t24, t22); /* omega3*omega_tau*s*1/(s*Theta)*(I3^2 + m*R^2*I3) + t22 */
    const double t26 = x[3]*t20; /* omega_n*V*m*R*I3*s*1/(s*Theta) */
    const double t27 = -t26; /* -omega_n*V*m*R*I3*s*1/(s*Theta) */
    const double t28 = x[2]*t10; /* omega_tau*gamma3*Theta*1/(s*Theta) */
    const double t29 = -t28; /* -omega_tau*gamma3*Theta*1/(s*Theta) */
    const double t30 = JLT_FMA(t10, t10, 1.0); /* gamma3*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) + 1 */
    const double t31 = x[3]*t9; /* omega_n*Theta*1/(s*Theta) */
    const double t32 = t30*t31; /* (gamma3*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) + 1)*omega_n*Theta*1/(s*Theta) */
    const double t33 = t13*t32; /* omega_n*R*t32 */
    const double t34 = JLT_FMA(t11, 2.0, x[4]); /* omega_n*gamma3*Theta*1/(s*Theta)*2 + omega3 */
    const double t35 = p[1]*t34; /* R*(omega_n*gamma3*Theta*1/(s*Theta)*2 + omega3) */
    const double t36 = x[3]*t32; /* omega_n*t32 */
    const double t37 = -t36; /* -omega_n*t32 */
    const double t38 = -t34; /* -(omega_n*gamma3*Theta*1/(s*Theta)*2 + omega3) */
    const double t39 = -x[3]; /* -omega_n */
    const double t40 = t21*t32; /* (omega_tau - V*m*R*I3*s*1/(s*Theta))*t32 */
    const double t41 = t11*t19; /* omega_n*gamma3*Theta*1/(s*Theta)*m*R*I3*s*1/(s*Theta) */
    const double t42 = -t41; /* -omega_n*gamma3*Theta*1/(s*Theta)*m*R*I3*s*1/(s*Theta) */
    const double t43 = p[7]*t18; /* m*R^2*I3*s*1/(s*Theta) */
    const double t44 = JLT_FMA(x[4], t23, t11); /* omega3*s*1/(s*Theta)*(I3^2 + m*R^2*I3) + omega_n*gamma3*Theta*1/(s*Theta) */
    const double t45 = JLT_FNMA(t11, t43, t44); /* t44 - omega_n*gamma3*Theta*1/(s*Theta)*m*R^2*I3*s*1/(s*Theta) */
    const double t46 = t10*t21; /* gamma3*Theta*1/(s*Theta)*(omega_tau - V*m*R*I3*s*1/(s*Theta)) */
    const double t47 = x[3]*t19; /* omega_n*m*R*I3*s*1/(s*Theta) */
    const double t48 = -t47; /* -omega_n*m*R*I3*s*1/(s*Theta) */
    const double t49 = x[3]*t43; /* omega_n*m*R^2*I3*s*1/(s*Theta) */
    const double t50 = -t49; /* -omega_n*m*R^2*I3*s*1/(s*Theta) */
    const double t51 = -t20; /* -V*m*R*I3*s*1/(s*Theta) */
    out[0] = t4;
    out[1] = t14;
    out[2] = t16;
    out[3] = t25;
    out[4] = t27;
    out[5] = t29;
    out[6] = 0.0;
    out[7] = t3;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = t33;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t35;
    out[14] = t13;
    out[15] = t37;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t38;
    out[19] = t39;
    out[20] = t40;
    out[21] = t42;
    out[22] = t45;
    out[23] = t46;
    out[24] = t24;
    out[25] = 0.0;
    out[26] = t48;
    out[27] = t50;
    out[28] = t51;
    out[29] = 0.0;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(p[7], t4, p[6]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1)) + I3^2 */
    const double t6 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t7 = t3*t5; /* s*Theta */
    const double t8 = 1.0/t7; /* 1/(s*Theta) */
    const double t9 = p[10]*x[0]; /* (-m*R*I3)*gamma3 */
    const double t10 = t6*t9; /* V*(-m*R*I3)*gamma3 */
    const double t11 = t5*t10; /* Theta*V*(-m*R*I3)*gamma3 */
    const double t12 = t3*t11; /* s*Theta*V*(-m*R*I3)*gamma3 */
    const double t13 = t8*t12; /* 1/(s*Theta)*s*Theta*V*(-m*R*I3)*gamma3 */
    const double t14 = t8*t13; /* 1/(s*Theta)*1/(s*Theta)*s*Theta*V*(-m*R*I3)*gamma3 */
    out[0] = t14;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* (1 - gamma3)*(1 + gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t5 = x[4]*t4; /* omega3*s */
    const double t6 = JLT_FMA(x[0], x[3], t5); /* gamma3*omega_n + omega3*s */
    const double t7 = p[1]*t6; /* v_tau = R*(gamma3*omega_n + omega3*s) */
    const double t8 = JLT_FMA(t7, t7, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t9 = p[12]*t8; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t10 = x[3]*x[3]; /* omega_n*omega_n */
    const double t11 = JLT_FMA(x[4], x[4], t10); /* omega3*omega3 + omega_n*omega_n */
    const double t12 = JLT_FMA(x[2], x[2], t11); /* omega_tau*omega_tau + omega3*omega3 + omega_n*omega_n */
    const double t13 = JLT_FMA(p[13], t12, t9); /* energy = 1/2*I3*(omega_tau*omega_tau + omega3*omega3 + omega_n*omega_n) + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t14 = x[4]*x[0]; /* omega3*gamma3 */
    const double t15 = JLT_FNMA(t4, x[3], t14); /* omega3*gamma3 - s*omega_n */
    const double t16 = p[14]*t15; /* (-R*I3)*(omega3*gamma3 - s*omega_n) */
    const double t17 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t18 = p[15]*t17; /* m*I3^2*(R*omega_tau + v_nu) */
    const double t19 = t17*t18; /* (R*omega_tau + v_nu)*m*I3^2*(R*omega_tau + v_nu) */
    out[0] = t13;
    out[1] = t16;
    out[2] = t19;
    out[3] = t17;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0]*x[3]; /* gamma3*omega_n */
    const double t5 = JLT_FMA(x[4], t3, t4); /* omega3*s + gamma3*omega_n */
    const double t6 = p[1]*t5; /* v_tau = R*(omega3*s + gamma3*omega_n) */
    const double t7 = 1.0/t3; /* 1/s */
    const double t8 = x[4]*x[0]; /* omega3*gamma3 */
    const double t9 = JLT_FMS(t7, t8, x[3]); /* 1/s*omega3*gamma3 - omega_n */
    const double t10 = p[16]*t6; /* (-m*R)*v_tau */
    const double t11 = t9*t10; /* (1/s*omega3*gamma3 - omega_n)*(-m*R)*v_tau */
    const double t12 = p[0]*x[1]; /* m*v_nu */
    const double t13 = p[5]*x[2]; /* I3*omega_tau */
    const double t14 = t6*p[17]; /* v_tau*m*R */
    const double t15 = x[0]*t14; /* gamma3*v_tau*m*R */
    const double t16 = JLT_FMA(x[3], p[5], t15); /* d(energy)/d(omega_n) = omega_n*I3 + gamma3*v_tau*m*R */
    const double t17 = x[4]*p[5]; /* omega3*I3 */
    const double t18 = JLT_FMA(t3, t14, t17); /* d(energy)/d(omega3) = s*v_tau*m*R + omega3*I3 */
    const double t19 = JLT_FMA(t4, t7, x[4]); /* gamma3*omega_n*1/s + omega3 */
    const double t20 = p[14]*t19; /* (-R*I3)*(gamma3*omega_n*1/s + omega3) */
    const double t21 = t3*p[18]; /* s*R*I3 */
    const double t22 = x[0]*p[14]; /* gamma3*(-R*I3) */
    const double t23 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t24 = p[19]*t23; /* 2*m*I3^2*(R*omega_tau + v_nu) */
    const double t25 = t23*p[20]; /* (R*omega_tau + v_nu)*2*m*R*I3^2 */
    out[0] = t11;
    out[1] = t12;
    out[2] = t13;
    out[3] = t16;
    out[4] = t18;
    out[5] = t20;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t21;
    out[9] = t22;
    out[10] = 0.0;
    out[11] = t24;
    out[12] = t25;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 1.0;
    out[17] = p[1];
    out[18] = 0.0;
    out[19] = 0.0;
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
    double t12[JLT_JET_ORDER_MAX + 1];
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
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
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
        t12[k] = jlt_jet_product(x0, x0, k) + t5[k];
        t13[k] = p[7]*t12[k] + (k == 0 ? p[6] : 0);
        t14[k] = jlt_jet_product(t6, t13, k);
        t15[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t14, t15, k);
        t16[k] = jlt_jet_product(x0, x3, k);
        t17[k] = jlt_jet_product(t13, t16, k);
        t18[k] = jlt_jet_product(t15, t17, k);
        t20[k] = t18[k] + x4[k];
        t21[k] = jlt_jet_product(x3, t20, k);
        t22[k] = p[1]*t21[k];
        t23[k] = -t21[k];
        t26[k] = x2[k]*p[1] + x1[k];
        t27[k] = jlt_jet_product(t6, t15, k);
        t28[k] = p[8]*t26[k];
        t29[k] = jlt_jet_product(t27, t28, k);
        t30[k] = x2[k] - t29[k];
        t31[k] = jlt_jet_product(t18, t30, k);
        t33[k] = x2[k]*p[9];
        t34[k] = jlt_jet_product(x4, t33, k);
        t35[k] = jlt_jet_product(t27, t34, k) + t31[k];
        t36[k] = jlt_jet_product(x3, t29, k);
        t37[k] = -t36[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t22[k]/(k + 1);
        next[2] = x2[k + 1] = t23[k]/(k + 1);
        next[3] = x3[k + 1] = t35[k]/(k + 1);
        next[4] = x4[k + 1] = t37[k]/(k + 1);
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
    const double complex v_omega3 = x[4];
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double v_I3 = params[5];
    const double v_I1 = (v_I3);
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
    out[4] = (-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta);
}

static const unsigned char family0_is_free[] = { 1, 1, 0, 0, 1 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = x[4];
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[5]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I3*gamma3*v_nu */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = t4*t5; /* (1 + gamma3)*(1 - gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t8 = params[5]*params[5]; /* I3*I3 */
    const double t9 = params[1]*params[1]; /* R*R */
    const double t10 = params[0]*t9; /* m*R*R */
    const double t11 = params[5]*t10; /* I3*m*R*R */
    const double t12 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t13 = t11*t12; /* I3*m*R*R*gamma3*gamma3 */
    const double t14 = t8 + t13; /* I3*I3 + I3*m*R*R*gamma3*gamma3 */
    const double t15 = t7*t7; /* s*s */
    const double t16 = t11*t15; /* I3*m*R*R*s*s */
    const double t17 = t14 + t16; /* Theta = I3*I3 + I3*m*R*R*gamma3*gamma3 + I3*m*R*R*s*s */
    const double t18 = t7*t17; /* s*Theta */
    const double t19 = t3/t18; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t20 = -t19; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t20;
}

static void family0_charpoly(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = t0*t1; /* (1 + gamma3)*(1 - gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t4 = params[5]*t3; /* I3*s */
    const double t5 = params[5]*params[5]; /* I3*I3 */
    const double t6 = params[1]*params[1]; /* R*R */
    const double t7 = params[0]*t6; /* m*R*R */
    const double t8 = params[5]*t7; /* I3*m*R*R */
    const double t9 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t10 = t8*t9; /* I3*m*R*R*gamma3*gamma3 */
    const double t11 = t5 + t10; /* I3*I3 + I3*m*R*R*gamma3*gamma3 */
    const double t12 = t3*t3; /* s*s */
    const double t13 = t8*t12; /* I3*m*R*R*s*s */
    const double t14 = t11 + t13; /* Theta = I3*I3 + I3*m*R*R*gamma3*gamma3 + I3*m*R*R*s*s */
    const double t15 = t4*t14; /* I3*s*Theta */
    const double t16 = params[0]*params[1]; /* m*R */
    const double t17 = t5*t16; /* I3*I3*m*R */
    const double t18 = x[0]*t17; /* gamma3*I3*I3*m*R */
    const double t19 = t18*x[1]; /* gamma3*I3*I3*m*R*v_nu */
    const double t20 = x[4]*x[4]; /* omega3*omega3 */
    const double t21 = t5*t20; /* I3*I3*omega3*omega3 */
    const double t22 = t3*t21; /* s*I3*I3*omega3*omega3 */
    const double t23 = params[5] + t7; /* I3 + m*R*R */
    const double t24 = t22*t23; /* s*I3*I3*omega3*omega3*(I3 + m*R*R) */
    out[0] = t15;
    out[1] = t19;
    out[2] = t24;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = x[0] + 1.0; /* gamma3 + 1 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = t0*t1; /* (gamma3 + 1)*(1 - gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((gamma3 + 1)*(1 - gamma3)) */
    const double t4 = params[1]*x[4]; /* R*omega3 */
    const double t5 = -x[4]; /* -omega3 */
    const double t6 = x[4]*params[5]; /* omega3*I3 */
    const double t7 = params[5]*params[5]; /* I3*I3 */
    const double t8 = params[1]*params[1]; /* R*R */
    const double t9 = params[0]*t8; /* m*R*R */
    const double t10 = params[5]*t9; /* I3*m*R*R */
    const double t11 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t12 = t10*t11; /* I3*m*R*R*gamma3*gamma3 */
    const double t13 = t7 + t12; /* I3*I3 + I3*m*R*R*gamma3*gamma3 */
    const double t14 = t3*t3; /* s*s */
    const double t15 = t10*t14; /* I3*m*R*R*s*s */
    const double t16 = t13 + t15; /* Theta = I3*I3 + I3*m*R*R*gamma3*gamma3 + I3*m*R*R*s*s */
    const double t17 = params[5] + t9; /* I3 + m*R*R */
    const double t18 = t6*t17; /* omega3*I3*(I3 + m*R*R) */
    const double t19 = t18/t16; /* omega3*I3*(I3 + m*R*R)/Theta */
    const double t20 = params[1]*params[0]; /* R*m */
    const double t21 = params[5]*t20; /* I3*R*m */
    const double t22 = x[0]*t21; /* gamma3*I3*R*m */
    const double t23 = t22*x[1]; /* gamma3*I3*R*m*v_nu */
    const double t24 = t3*t16; /* s*Theta */
    const double t25 = t23/t24; /* gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t26 = -t25; /* -gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t27 = t21*x[1]; /* I3*R*m*v_nu */
    const double t28 = t27/t16; /* I3*R*m*v_nu/Theta */
    const double t29 = -t28; /* -I3*R*m*v_nu/Theta */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t4;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t5;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = t19;
    out[18] = t26;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = t29;
    out[24] = 0.0;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[1]*x[4]; /* R*omega3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = t1*t2; /* (1 + gamma3)*(1 - gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t5 = t0*t4; /* v_tau = R*omega3*s */
    const double t6 = params[1]*x[0]; /* R*gamma3 */
    const double t7 = params[0]*t5; /* m*v_tau */
    const double t8 = x[4]*t6; /* omega3*R*gamma3 */
    const double t9 = t8/t4; /* omega3*R*gamma3/s */
    const double t10 = t7*t9; /* m*v_tau*omega3*R*gamma3/s */
    const double t11 = -t10; /* -m*v_tau*omega3*R*gamma3/s */
    const double t12 = params[0]*x[1]; /* m*v_nu */
    const double t13 = params[0]*params[1]; /* m*R */
    const double t14 = x[0]*t13; /* gamma3*m*R */
    const double t15 = t5*t14; /* d(energy)/d(omega_n) = v_tau*gamma3*m*R */
    const double t16 = x[4]*params[5]; /* omega3*I3 */
    const double t17 = t4*t13; /* s*m*R */
    const double t18 = t5*t17; /* v_tau*s*m*R */
    const double t19 = t16 + t18; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    const double t20 = params[1]*params[5]; /* R*I3 */
    const double t21 = x[4]*t20; /* omega3*R*I3 */
    const double t22 = -t21; /* -omega3*R*I3 */
    const double t23 = x[0]*t20; /* gamma3*R*I3 */
    const double t24 = t4*t20; /* s*R*I3 */
    const double t25 = -t23; /* -gamma3*R*I3 */
    const double t26 = params[0]*2.0; /* m*2 */
    const double t27 = params[5]*params[5]; /* I3*I3 */
    const double t28 = t26*t27; /* m*2*I3*I3 */
    const double t29 = x[1]*t28; /* v_nu*m*2*I3*I3 */
    const double t30 = params[1]*t26; /* R*m*2 */
    const double t31 = t27*t30; /* I3*I3*R*m*2 */
    const double t32 = x[1]*t31; /* v_nu*I3*I3*R*m*2 */
    out[0] = t11;
    out[1] = t12;
    out[2] = 0.0;
    out[3] = t15;
    out[4] = t19;
    out[5] = t22;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t24;
    out[9] = t25;
    out[10] = 0.0;
    out[11] = t29;
    out[12] = t32;
    out[13] = 0.0;
    out[14] = 0.0;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "G", "" },
    { "F0", "a3 = 0" },
};

static const jlt_equilibria equilibria[] = {
    { .name = "spin", .condition = "a3 = 0",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .charpoly = family0_charpoly,
      .matrix = family0_matrix,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 3, .obstructs = 1 },
};

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
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 6, .block_count = 21,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 6, 15, 4, 1, 1, 0, 11, 5 }, { 11, 42, 0, 7, 1, 0, 10, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 25, { 8, 24, 7, 1, 1, 0, 12, 8 }, { 24, 95, 0, 23, 1, 0, 10, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 14, 28, 8, 1, 1, 0, 12, 12 }, { 31, 124, 0, 30, 1, 0, 10, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 8, 3, 1, 1, 0, 8, 6 }, { 5, 18, 0, 1, 1, 0, 9, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 4, { 2, 10, 7, 0, 1, 0, 9, 4 }, { 9, 32, 0, 0, 1, 0, 11, 5 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 20, { 2, 16, 6, 1, 1, 0, 8, 7 }, { 10, 40, 0, 2, 1, 0, 7, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_baseline,
        &jlt_batch_spherical_top_balanced_equal_avx2,
        &jlt_batch_spherical_top_balanced_equal_avx512,
    },
};
