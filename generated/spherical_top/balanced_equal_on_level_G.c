/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   14    5    1    1    0     11    5   (45)
 *  jacobian            8   24    8    1    1    0     13   10   (123)
 *  rhs_jacobian        10   28    8    1    1    0     13   10   (143)
 *  divergence          3    7    4    1    1    0      9    5   (28)
 *  integral_values     2   11    7    1    1    0     10    5   (42)
 *  integral_gradients  2   18    9    1    1    0     10    9   (68)
 *  eliminated          2    4    1    1    1    0      5    3   (10)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_avx512;

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
    const double t8 = -t7; /* -I3*R*m */
    const double t9 = -t5; /* -I3*m*R*R */
    const double t10 = params[0]/2.0; /* m/2 */
    const double t11 = params[5]/2.0; /* I3/2 */
    const double t12 = t2*params[0]; /* I3*I3*m */
    const double t13 = params[0]*2.0; /* m*2 */
    const double t14 = t2*t13; /* I3*I3*m*2 */
    const double t15 = params[1]*t13; /* R*m*2 */
    const double t16 = t2*t15; /* I3*I3*R*m*2 */
    out[7] = t1;
    out[8] = t0;
    out[9] = t2;
    out[10] = t5;
    out[11] = t8;
    out[12] = t7;
    out[13] = t9;
    out[14] = t10;
    out[15] = t11;
    out[16] = t12;
    out[17] = t14;
    out[18] = t16;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t6 = JLT_FMA(x[3], t5, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t7 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(1 + gamma3) */
    const double t8 = JLT_FMA(p[10], t7, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(1 + gamma3)) + I3^2 */
    const double t9 = t3*t8; /* s*Theta */
    const double t10 = 1.0/t9; /* 1/(s*Theta) */
    const double t11 = t8*t10; /* Theta*1/(s*Theta) */
    const double t12 = p[7]*t6; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t13 = t11*t12; /* omega_n = Theta*1/(s*Theta)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t14 = x[0]*t11; /* gamma3*Theta*1/(s*Theta) */
    const double t15 = JLT_FMA(t13, t14, x[3]); /* omega_n*gamma3*Theta*1/(s*Theta) + omega3 */
    const double t16 = t13*t15; /* omega_n*(omega_n*gamma3*Theta*1/(s*Theta) + omega3) */
    const double t17 = p[1]*t16; /* R*omega_n*(omega_n*gamma3*Theta*1/(s*Theta) + omega3) */
    const double t18 = -t16; /* -omega_n*(omega_n*gamma3*Theta*1/(s*Theta) + omega3) */
    const double t19 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t20 = p[11]*t19; /* (-m*R*I3)*V */
    const double t21 = t3*t20; /* s*(-m*R*I3)*V */
    const double t22 = t10*t21; /* 1/(s*Theta)*s*(-m*R*I3)*V */
    const double t23 = t13*t22; /* omega_n*1/(s*Theta)*s*(-m*R*I3)*V */
    out[0] = t4;
    out[1] = t17;
    out[2] = t18;
    out[3] = t23;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[10], t3, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1)) + I3^2 */
    const double t5 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = t4*t5; /* Theta*s */
    const double t7 = 1.0/t6; /* 1/(Theta*s) */
    const double t8 = t4*t7; /* Theta*1/(Theta*s) */
    const double t9 = x[0]*t8; /* gamma3*Theta*1/(Theta*s) */
    const double t10 = x[2]*t9; /* omega_tau*gamma3*Theta*1/(Theta*s) */
    const double t11 = -t10; /* -omega_tau*gamma3*Theta*1/(Theta*s) */
    const double t12 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t13 = JLT_FMA(x[3], t12, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t14 = p[7]*t13; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t15 = t8*t14; /* Theta*1/(Theta*s)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t16 = t8*t15; /* Theta*1/(Theta*s)*Theta*1/(Theta*s)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t17 = t15*t16; /* Theta*1/(Theta*s)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*t16 */
    const double t18 = t9*t15; /* gamma3*Theta*1/(Theta*s)*Theta*1/(Theta*s)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t19 = t8*t18; /* Theta*1/(Theta*s)*t18 */
    const double t20 = x[3] + t18; /* omega3 + t18 */
    const double t21 = t8*t20; /* d(omega_n)/d(gamma3) = Theta*1/(Theta*s)*(omega3 + t18) */
    const double t22 = JLT_FMA(x[3], (1.0 / 2.0), t18); /* omega3*1/2 + t18 */
    const double t23 = 2.0*t22; /* 2*(omega3*1/2 + t18) */
    const double t24 = JLT_FMA(t18, t19, t17); /* t18*Theta*1/(Theta*s)*t18 + t17 */
    const double t25 = JLT_FMA(t21, t23, t24); /* d(omega_n)/d(gamma3)*2*(omega3*1/2 + t18) + t18*Theta*1/(Theta*s)*t18 + t17 */
    const double t26 = p[1]*t25; /* R*t25 */
    const double t27 = JLT_FMA(t9, t23, t15); /* gamma3*Theta*1/(Theta*s)*2*(omega3*1/2 + t18) + Theta*1/(Theta*s)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t28 = p[1]*t27; /* R*t27 */
    const double t29 = -t25; /* -t25 */
    const double t30 = -t27; /* -t27 */
    const double t31 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t32 = t5*t7; /* s*1/(Theta*s) */
    const double t33 = p[12]*t31; /* m*R*I3*V */
    const double t34 = t32*t33; /* s*1/(Theta*s)*m*R*I3*V */
    const double t35 = t21*t34; /* d(omega_n)/d(gamma3)*s*1/(Theta*s)*m*R*I3*V */
    const double t36 = -t35; /* -d(omega_n)/d(gamma3)*s*1/(Theta*s)*m*R*I3*V */
    const double t37 = t15*t32; /* Theta*1/(Theta*s)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*s*1/(Theta*s) */
    const double t38 = p[11]*t37; /* (-m*R*I3)*t37 */
    const double t39 = t37*p[13]; /* t37*(-m*R^2*I3) */
    const double t40 = t9*t34; /* gamma3*Theta*1/(Theta*s)*s*1/(Theta*s)*m*R*I3*V */
    const double t41 = -t40; /* -gamma3*Theta*1/(Theta*s)*s*1/(Theta*s)*m*R*I3*V */
    out[0] = t11;
    out[1] = 0.0;
    out[2] = t5;
    out[3] = 0.0;
    out[4] = t26;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t28;
    out[8] = t29;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t30;
    out[12] = t36;
    out[13] = t38;
    out[14] = t39;
    out[15] = t41;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(1 + gamma3) */
    const double t6 = JLT_FMA(p[10], t5, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(1 + gamma3)) + I3^2 */
    const double t7 = t3*t6; /* s*Theta */
    const double t8 = 1.0/t7; /* 1/(s*Theta) */
    const double t9 = t6*t8; /* Theta*1/(s*Theta) */
    const double t10 = x[0]*t9; /* gamma3*Theta*1/(s*Theta) */
    const double t11 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t12 = JLT_FMA(x[3], t11, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t13 = p[7]*t12; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t14 = t9*t13; /* Theta*1/(s*Theta)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t15 = t10*t14; /* gamma3*Theta*1/(s*Theta)*Theta*1/(s*Theta)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t16 = x[3] + t15; /* omega3 + t15 */
    const double t17 = t14*t16; /* Theta*1/(s*Theta)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*(omega3 + t15) */
    const double t18 = p[1]*t17; /* R*t17 */
    const double t19 = -t17; /* -t17 */
    const double t20 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t21 = t3*t8; /* s*1/(s*Theta) */
    const double t22 = p[12]*t20; /* m*R*I3*V */
    const double t23 = t21*t22; /* s*1/(s*Theta)*m*R*I3*V */
    const double t24 = t14*t23; /* Theta*1/(s*Theta)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*s*1/(s*Theta)*m*R*I3*V */
    const double t25 = -t24; /* -t24 */
    const double t26 = x[2]*t10; /* omega_tau*gamma3*Theta*1/(s*Theta) */
    const double t27 = -t26; /* -omega_tau*gamma3*Theta*1/(s*Theta) */
    const double t28 = JLT_FMA(t10, t10, 1.0); /* gamma3*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) + 1 */
    const double t29 = t9*t14; /* Theta*1/(s*Theta)*Theta*1/(s*Theta)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t30 = t14*t29; /* Theta*1/(s*Theta)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*t29 */
    const double t31 = t28*t30; /* (gamma3*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) + 1)*t30 */
    const double t32 = t9*t16; /* d(omega_n)/d(gamma3) = Theta*1/(s*Theta)*(omega3 + t15) */
    const double t33 = JLT_FMA(x[3], (1.0 / 2.0), t15); /* omega3*1/2 + t15 */
    const double t34 = 2.0*t33; /* 2*(omega3*1/2 + t15) */
    const double t35 = JLT_FMA(t32, t34, t31); /* d(omega_n)/d(gamma3)*2*(omega3*1/2 + t15) + (gamma3*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) + 1)*t30 */
    const double t36 = p[1]*t35; /* R*t35 */
    const double t37 = JLT_FMA(t10, t34, t14); /* gamma3*Theta*1/(s*Theta)*2*(omega3*1/2 + t15) + Theta*1/(s*Theta)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t38 = p[1]*t37; /* R*t37 */
    const double t39 = -t35; /* -t35 */
    const double t40 = -t37; /* -t37 */
    const double t41 = t23*t32; /* s*1/(s*Theta)*m*R*I3*V*d(omega_n)/d(gamma3) */
    const double t42 = -t41; /* -s*1/(s*Theta)*m*R*I3*V*d(omega_n)/d(gamma3) */
    const double t43 = t14*t21; /* Theta*1/(s*Theta)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*s*1/(s*Theta) */
    const double t44 = p[11]*t43; /* (-m*R*I3)*t43 */
    const double t45 = t43*p[13]; /* t43*(-m*R^2*I3) */
    const double t46 = t10*t23; /* gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*m*R*I3*V */
    const double t47 = -t46; /* -gamma3*Theta*1/(s*Theta)*s*1/(s*Theta)*m*R*I3*V */
    out[0] = t4;
    out[1] = t18;
    out[2] = t19;
    out[3] = t25;
    out[4] = t27;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t36;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t38;
    out[12] = t39;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t40;
    out[16] = t42;
    out[17] = t44;
    out[18] = t45;
    out[19] = t47;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], x[0], t2); /* gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[10], t3, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + (1 - gamma3)*(gamma3 + 1)) + I3^2 */
    const double t5 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t7 = t4*t5; /* Theta*s */
    const double t8 = 1.0/t7; /* 1/(Theta*s) */
    const double t9 = p[12]*t6; /* m*R*I3*V */
    const double t10 = t5*t9; /* s*m*R*I3*V */
    const double t11 = JLT_FMA(t8, t10, x[2]); /* 1/(Theta*s)*s*m*R*I3*V + omega_tau */
    const double t12 = x[0]*t4; /* gamma3*Theta */
    const double t13 = t8*t12; /* 1/(Theta*s)*gamma3*Theta */
    const double t14 = t11*t13; /* (1/(Theta*s)*s*m*R*I3*V + omega_tau)*1/(Theta*s)*gamma3*Theta */
    const double t15 = -t14; /* -t14 */
    out[0] = t15;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* (1 - gamma3)*(1 + gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t5 = x[3]*t4; /* omega3*s */
    const double t6 = 1.0/t4; /* 1/s */
    const double t7 = x[3]*p[8]; /* omega3*R*I3 */
    const double t8 = JLT_FMA(x[0], t7, p[6]); /* gamma3*omega3*R*I3 + G_level */
    const double t9 = p[7]*t8; /* 1/(R*I3)*(gamma3*omega3*R*I3 + G_level) */
    const double t10 = t6*t9; /* omega_n = 1/s*1/(R*I3)*(gamma3*omega3*R*I3 + G_level) */
    const double t11 = JLT_FMA(x[0], t10, t5); /* gamma3*omega_n + omega3*s */
    const double t12 = p[1]*t11; /* v_tau = R*(gamma3*omega_n + omega3*s) */
    const double t13 = JLT_FMA(t12, t12, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t14 = p[14]*t13; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t15 = x[3]*x[3]; /* omega3*omega3 */
    const double t16 = JLT_FMA(x[2], x[2], t15); /* omega_tau*omega_tau + omega3*omega3 */
    const double t17 = JLT_FMA(t10, t10, t16); /* omega_n*omega_n + omega_tau*omega_tau + omega3*omega3 */
    const double t18 = JLT_FMA(p[15], t17, t14); /* energy = 1/2*I3*(omega_n*omega_n + omega_tau*omega_tau + omega3*omega3) + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t19 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t20 = p[16]*t19; /* m*I3^2*(R*omega_tau + v_nu) */
    const double t21 = t19*t20; /* (R*omega_tau + v_nu)*m*I3^2*(R*omega_tau + v_nu) */
    out[0] = t18;
    out[1] = t21;
    out[2] = t19;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = 1.0/t3; /* 1/s */
    const double t5 = x[0]*t4; /* gamma3*1/s */
    const double t6 = x[3]*p[8]; /* omega3*R*I3 */
    const double t7 = JLT_FMA(x[0], t6, p[6]); /* gamma3*omega3*R*I3 + G_level */
    const double t8 = p[7]*t7; /* 1/(R*I3)*(gamma3*omega3*R*I3 + G_level) */
    const double t9 = t4*t8; /* 1/s*1/(R*I3)*(gamma3*omega3*R*I3 + G_level) */
    const double t10 = JLT_FMS(x[3], t5, t9); /* omega3*gamma3*1/s - 1/s*1/(R*I3)*(gamma3*omega3*R*I3 + G_level) */
    const double t11 = p[1]*t10; /* R*t10 */
    const double t12 = JLT_FMA(t5, t9, x[3]); /* gamma3*1/s*1/s*1/(R*I3)*(gamma3*omega3*R*I3 + G_level) + omega3 */
    const double t13 = t4*t12; /* d(omega_n)/d(gamma3) = 1/s*t12 */
    const double t14 = p[1]*x[0]; /* R*gamma3 */
    const double t15 = JLT_FMS(t13, t14, t11); /* d(v_tau)/d(gamma3) = d(omega_n)/d(gamma3)*R*gamma3 - R*t10 */
    const double t16 = p[1]*t3; /* R*s */
    const double t17 = x[3]*t16; /* omega3*R*s */
    const double t18 = JLT_FMA(t9, t14, t17); /* v_tau = 1/s*1/(R*I3)*(gamma3*omega3*R*I3 + G_level)*R*gamma3 + omega3*R*s */
    const double t19 = p[0]*t18; /* m*v_tau */
    const double t20 = t15*t19; /* d(v_tau)/d(gamma3)*m*v_tau */
    const double t21 = t9*p[5]; /* 1/s*1/(R*I3)*(gamma3*omega3*R*I3 + G_level)*I3 */
    const double t22 = JLT_FMA(t13, t21, t20); /* d(energy)/d(gamma3) = d(omega_n)/d(gamma3)*1/s*1/(R*I3)*(gamma3*omega3*R*I3 + G_level)*I3 + d(v_tau)/d(gamma3)*m*v_tau */
    const double t23 = p[0]*x[1]; /* m*v_nu */
    const double t24 = p[5]*x[2]; /* I3*omega_tau */
    const double t25 = t12*p[5]; /* t12*I3 */
    const double t26 = JLT_FMA(t5, t14, t16); /* d(v_tau)/d(omega3) = gamma3*1/s*R*gamma3 + R*s */
    const double t27 = JLT_FMA(t19, t26, t25); /* d(energy)/d(omega3) = m*v_tau*d(v_tau)/d(omega3) + t12*I3 */
    const double t28 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t29 = p[17]*t28; /* 2*m*I3^2*(R*omega_tau + v_nu) */
    const double t30 = t28*p[18]; /* (R*omega_tau + v_nu)*2*m*R*I3^2 */
    out[0] = t22;
    out[1] = t23;
    out[2] = t24;
    out[3] = t27;
    out[4] = 0.0;
    out[5] = t29;
    out[6] = t30;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = 1.0;
    out[10] = p[1];
    out[11] = 0.0;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = 1.0/t3; /* 1/s */
    const double t5 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t6 = JLT_FMA(x[3], t5, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t7 = p[7]*t6; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t8 = t4*t7; /* 1/s*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
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
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
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
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
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
        t13[k] = x0[k]*p[8];
        t14[k] = jlt_jet_product(x3, t13, k) + (k == 0 ? p[6] : 0);
        t17[k] = jlt_jet_product(x0, x0, k) + t5[k];
        t18[k] = p[10]*t17[k] + (k == 0 ? p[9] : 0);
        t19[k] = jlt_jet_product(t6, t18, k);
        t20[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t19, t20, k);
        t21[k] = jlt_jet_product(t18, t20, k);
        t22[k] = p[7]*t14[k];
        t23[k] = jlt_jet_product(t21, t22, k);
        t24[k] = jlt_jet_product(x0, t21, k);
        t25[k] = jlt_jet_product(t23, t24, k) + x3[k];
        t26[k] = jlt_jet_product(t23, t25, k);
        t27[k] = p[1]*t26[k];
        t28[k] = -t26[k];
        t31[k] = x2[k]*p[1] + x1[k];
        t32[k] = p[11]*t31[k];
        t33[k] = jlt_jet_product(t6, t32, k);
        t34[k] = jlt_jet_product(t20, t33, k);
        t35[k] = jlt_jet_product(t23, t34, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t27[k]/(k + 1);
        next[2] = x2[k + 1] = t28[k]/(k + 1);
        next[3] = x3[k + 1] = t35[k]/(k + 1);
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
    const double v_I3 = params[5];
    const double v_I1 = (v_I3);
    const double v_G_level = params[6];
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
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
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_G = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 19,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 14, 5, 1, 1, 0, 11, 5 }, { 9, 31, 0, 4, 1, 0, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 8, 24, 8, 1, 1, 0, 13, 10 }, { 24, 80, 0, 18, 1, 0, 13, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 10, 28, 8, 1, 1, 0, 13, 10 }, { 28, 93, 0, 21, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 7, 4, 1, 1, 0, 9, 5 }, { 6, 19, 0, 2, 1, 0, 9, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 2, 11, 7, 1, 1, 0, 10, 5 }, { 9, 31, 0, 1, 1, 0, 13, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 12, { 2, 18, 9, 1, 1, 0, 10, 9 }, { 13, 48, 0, 6, 1, 0, 12, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 4, 1, 1, 1, 0, 5, 3 }, { 2, 6, 0, 1, 1, 0, 5, 3 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_on_level_G_baseline,
        &jlt_batch_spherical_top_balanced_equal_on_level_G_avx2,
        &jlt_batch_spherical_top_balanced_equal_on_level_G_avx512,
    },
};
