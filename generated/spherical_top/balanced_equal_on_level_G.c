/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   14    3    1    1    0     10    5   (45)
 *  jacobian            8   23    5    1    1    0     13   10   (123)
 *  rhs_jacobian        10   27    5    1    1    0     12   10   (143)
 *  divergence          2    7    2    1    1    0      7    4   (28)
 *  integral_values     2   10    7    1    1    0      8    5   (42)
 *  integral_gradients  2   14    8    1    1    0     11    8   (68)
 *  eliminated          2    3    1    1    1    0      4    3   (10)
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
    const double t6 = t2 + t5; /* I3*I3 + I3*m*R*R */
    const double t7 = -params[0]; /* -m */
    const double t8 = params[1]*params[0]; /* R*m */
    const double t9 = -t8; /* -R*m */
    const double t10 = params[5]*t8; /* I3*R*m */
    const double t11 = -t10; /* -I3*R*m */
    const double t12 = -t5; /* -I3*m*R*R */
    const double t13 = -t2; /* -I3*I3 */
    const double t14 = t13 - t5; /* -I3*I3 - I3*m*R*R */
    const double t15 = params[0]/2.0; /* m/2 */
    const double t16 = params[5]/params[0]; /* I3/m */
    const double t17 = t2*params[0]; /* I3*I3*m */
    const double t18 = 1.0/params[1]; /* 1/R */
    const double t19 = params[0]*2.0; /* m*2 */
    const double t20 = t2*t19; /* I3*I3*m*2 */
    const double t21 = params[1]*t19; /* R*m*2 */
    const double t22 = t2*t21; /* I3*I3*R*m*2 */
    out[7] = t1;
    out[8] = t0;
    out[9] = t6;
    out[10] = t11;
    out[11] = t10;
    out[12] = t7;
    out[13] = t9;
    out[14] = t12;
    out[15] = t14;
    out[16] = t15;
    out[17] = t16;
    out[18] = t3;
    out[19] = t17;
    out[20] = t4;
    out[21] = t18;
    out[22] = t20;
    out[23] = t22;
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
    const double t7 = t3*p[9]; /* s*(I3^2 + m*R^2*I3) */
    const double t8 = 1.0/t7; /* 1/(s*(I3^2 + m*R^2*I3)) */
    const double t9 = p[9]*t8; /* (I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3)) */
    const double t10 = p[7]*t6; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t11 = t9*t10; /* omega_n = (I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t12 = x[0]*t9; /* gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3)) */
    const double t13 = JLT_FMA(t11, t12, x[3]); /* omega_n*gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3)) + omega3 */
    const double t14 = t11*t13; /* omega_n*t13 */
    const double t15 = p[1]*t14; /* R*omega_n*t13 */
    const double t16 = -t14; /* -omega_n*t13 */
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t18 = p[10]*t17; /* (-m*R*I3)*V */
    const double t19 = t3*t18; /* s*(-m*R*I3)*V */
    const double t20 = t8*t19; /* 1/(s*(I3^2 + m*R^2*I3))*s*(-m*R*I3)*V */
    const double t21 = t11*t20; /* omega_n*1/(s*(I3^2 + m*R^2*I3))*s*(-m*R*I3)*V */
    out[0] = t4;
    out[1] = t15;
    out[2] = t16;
    out[3] = t21;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = p[9]*t3; /* (I3^2 + m*R^2*I3)*s */
    const double t5 = 1.0/t4; /* 1/((I3^2 + m*R^2*I3)*s) */
    const double t6 = p[9]*t5; /* (I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s) */
    const double t7 = x[0]*t6; /* gamma3*(I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s) */
    const double t8 = x[2]*t7; /* omega_tau*gamma3*(I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s) */
    const double t9 = -t8; /* -omega_tau*gamma3*(I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s) */
    const double t10 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t11 = JLT_FMA(x[3], t10, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t12 = t6*t11; /* (I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s)*(omega3*gamma3*R*I3 + G_level) */
    const double t13 = p[7]*t12; /* 1/(R*I3)*t12 */
    const double t14 = t6*t13; /* (I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s)*1/(R*I3)*t12 */
    const double t15 = t6*t14; /* (I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s)*(I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s)*1/(R*I3)*t12 */
    const double t16 = t14*t15; /* (I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s)*1/(R*I3)*t12*t15 */
    const double t17 = t7*t13; /* gamma3*(I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s)*1/(R*I3)*t12 */
    const double t18 = x[3] + t17; /* omega3 + t17 */
    const double t19 = t6*t18; /* d(omega_n)/d(gamma3) = (I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s)*(omega3 + t17) */
    const double t20 = JLT_FMA(t17, 2.0, x[3]); /* t17*2 + omega3 */
    const double t21 = JLT_FMA(t19, t20, t16); /* d(omega_n)/d(gamma3)*(t17*2 + omega3) + (I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s)*1/(R*I3)*t12*t15 */
    const double t22 = p[1]*t21; /* R*t21 */
    const double t23 = JLT_FMA(t7, t20, t13); /* gamma3*(I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s)*(t17*2 + omega3) + 1/(R*I3)*t12 */
    const double t24 = p[1]*t23; /* R*t23 */
    const double t25 = -t21; /* -t21 */
    const double t26 = -t23; /* -t23 */
    const double t27 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t28 = t3*t5; /* s*1/((I3^2 + m*R^2*I3)*s) */
    const double t29 = p[11]*t27; /* m*R*I3*V */
    const double t30 = t28*t29; /* s*1/((I3^2 + m*R^2*I3)*s)*m*R*I3*V */
    const double t31 = t19*t30; /* d(omega_n)/d(gamma3)*s*1/((I3^2 + m*R^2*I3)*s)*m*R*I3*V */
    const double t32 = -t31; /* -d(omega_n)/d(gamma3)*s*1/((I3^2 + m*R^2*I3)*s)*m*R*I3*V */
    const double t33 = t12*t28; /* t12*s*1/((I3^2 + m*R^2*I3)*s) */
    const double t34 = p[12]*t33; /* (-m)*t12*s*1/((I3^2 + m*R^2*I3)*s) */
    const double t35 = t33*p[13]; /* t12*s*1/((I3^2 + m*R^2*I3)*s)*(-m*R) */
    const double t36 = t7*t30; /* gamma3*(I3^2 + m*R^2*I3)*1/((I3^2 + m*R^2*I3)*s)*s*1/((I3^2 + m*R^2*I3)*s)*m*R*I3*V */
    const double t37 = -t36; /* -t36 */
    out[0] = t9;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t22;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t24;
    out[8] = t25;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t26;
    out[12] = t32;
    out[13] = t34;
    out[14] = t35;
    out[15] = t37;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = t3*p[9]; /* s*(I3^2 + m*R^2*I3) */
    const double t6 = 1.0/t5; /* 1/(s*(I3^2 + m*R^2*I3)) */
    const double t7 = p[9]*t6; /* (I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3)) */
    const double t8 = x[0]*t7; /* gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3)) */
    const double t9 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t10 = JLT_FMA(x[3], t9, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t11 = p[7]*t10; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t12 = t7*t11; /* (I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t13 = t8*t12; /* gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t12 */
    const double t14 = x[3] + t13; /* omega3 + gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t12 */
    const double t15 = t12*t14; /* t12*t14 */
    const double t16 = p[1]*t15; /* R*t12*t14 */
    const double t17 = -t15; /* -t12*t14 */
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t19 = t3*t6; /* s*1/(s*(I3^2 + m*R^2*I3)) */
    const double t20 = p[11]*t18; /* m*R*I3*V */
    const double t21 = t19*t20; /* s*1/(s*(I3^2 + m*R^2*I3))*m*R*I3*V */
    const double t22 = t12*t21; /* t12*s*1/(s*(I3^2 + m*R^2*I3))*m*R*I3*V */
    const double t23 = -t22; /* -t12*s*1/(s*(I3^2 + m*R^2*I3))*m*R*I3*V */
    const double t24 = x[2]*t8; /* omega_tau*gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3)) */
    const double t25 = -t24; /* -omega_tau*gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3)) */
    const double t26 = t7*t12; /* (I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t12 */
    const double t27 = t7*t26; /* (I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t12 */
    const double t28 = t26*t27; /* (I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t12*t27 */
    const double t29 = t7*t14; /* d(omega_n)/d(gamma3) = (I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t14 */
    const double t30 = JLT_FMA(t13, 2.0, x[3]); /* gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t12*2 + omega3 */
    const double t31 = JLT_FMA(t29, t30, t28); /* d(omega_n)/d(gamma3)*t30 + (I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t12*t27 */
    const double t32 = p[1]*t31; /* R*t31 */
    const double t33 = JLT_FMA(t8, t30, t12); /* gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t30 + t12 */
    const double t34 = p[1]*t33; /* R*(gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t30 + t12) */
    const double t35 = -t31; /* -t31 */
    const double t36 = -t33; /* -(gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*t30 + t12) */
    const double t37 = t21*t29; /* s*1/(s*(I3^2 + m*R^2*I3))*m*R*I3*V*d(omega_n)/d(gamma3) */
    const double t38 = -t37; /* -s*1/(s*(I3^2 + m*R^2*I3))*m*R*I3*V*d(omega_n)/d(gamma3) */
    const double t39 = t12*t19; /* t12*s*1/(s*(I3^2 + m*R^2*I3)) */
    const double t40 = p[10]*t39; /* (-m*R*I3)*t12*s*1/(s*(I3^2 + m*R^2*I3)) */
    const double t41 = t39*p[14]; /* t12*s*1/(s*(I3^2 + m*R^2*I3))*(-m*R^2*I3) */
    const double t42 = t8*t21; /* gamma3*(I3^2 + m*R^2*I3)*1/(s*(I3^2 + m*R^2*I3))*s*1/(s*(I3^2 + m*R^2*I3))*m*R*I3*V */
    const double t43 = -t42; /* -t42 */
    out[0] = t4;
    out[1] = t16;
    out[2] = t17;
    out[3] = t23;
    out[4] = t25;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t32;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t34;
    out[12] = t35;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t36;
    out[16] = t38;
    out[17] = t40;
    out[18] = t41;
    out[19] = t43;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t5 = t3*p[9]; /* s*(I3^2 + m*R^2*I3) */
    const double t6 = 1.0/t5; /* 1/(s*(I3^2 + m*R^2*I3)) */
    const double t7 = p[11]*t4; /* m*R*I3*V */
    const double t8 = t3*t7; /* s*m*R*I3*V */
    const double t9 = JLT_FMA(t6, t8, x[2]); /* 1/(s*(I3^2 + m*R^2*I3))*s*m*R*I3*V + omega_tau */
    const double t10 = p[15]*x[0]; /* (-I3^2 - m*R^2*I3)*gamma3 */
    const double t11 = t6*t10; /* 1/(s*(I3^2 + m*R^2*I3))*(-I3^2 - m*R^2*I3)*gamma3 */
    const double t12 = t9*t11; /* (1/(s*(I3^2 + m*R^2*I3))*s*m*R*I3*V + omega_tau)*1/(s*(I3^2 + m*R^2*I3))*(-I3^2 - m*R^2*I3)*gamma3 */
    out[0] = t12;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[3]*x[3]; /* omega3*omega3 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = x[3]*p[8]; /* omega3*R*I3 */
    const double t7 = JLT_FMA(x[0], t6, p[6]); /* gamma3*omega3*R*I3 + G_level */
    const double t8 = p[7]*t7; /* 1/(R*I3)*(gamma3*omega3*R*I3 + G_level) */
    const double t9 = t8/t5; /* omega_n = 1/(R*I3)*(gamma3*omega3*R*I3 + G_level)/s */
    const double t10 = JLT_FMA(x[2], x[2], t1); /* omega_tau*omega_tau + omega3*omega3 */
    const double t11 = JLT_FMA(t9, t9, t10); /* omega_n*omega_n + omega_tau*omega_tau + omega3*omega3 */
    const double t12 = x[3]*t5; /* omega3*s */
    const double t13 = JLT_FMA(x[0], t9, t12); /* v_tau scaled = gamma3*omega_n + omega3*s */
    const double t14 = p[18]*t13; /* R^2*v_tau scaled */
    const double t15 = JLT_FMA(p[17], t11, t0); /* I3/m*(omega_n*omega_n + omega_tau*omega_tau + omega3*omega3) + v_nu*v_nu */
    const double t16 = JLT_FMA(t13, t14, t15); /* energy scaled = v_tau scaled*R^2*v_tau scaled + t15 */
    const double t17 = p[16]*t16; /* 1/2*m*energy scaled */
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t19 = p[19]*t18; /* m*I3^2*(omega_tau*R + v_nu) */
    const double t20 = t18*t19; /* (omega_tau*R + v_nu)*m*I3^2*(omega_tau*R + v_nu) */
    out[0] = t17;
    out[1] = t20;
    out[2] = t18;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = 1.0/t3; /* 1/s */
    const double t5 = x[0]*x[3]; /* gamma3*omega3 */
    const double t6 = JLT_FMA(p[8], t5, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t7 = t4*t6; /* 1/s*(R*I3*gamma3*omega3 + G_level) */
    const double t8 = x[0]*p[7]; /* gamma3*1/(R*I3) */
    const double t9 = t7*t8; /* 1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*1/(R*I3) */
    const double t10 = JLT_FMA(t3, x[3], t9); /* s*omega3 + 1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*1/(R*I3) */
    const double t11 = p[20]*t4; /* m*R^2*1/s */
    const double t12 = t10*t11; /* t10*m*R^2*1/s */
    const double t13 = JLT_FMS(p[7], t6, t5); /* 1/(R*I3)*(R*I3*gamma3*omega3 + G_level) - gamma3*omega3 */
    const double t14 = t12*t13; /* t10*m*R^2*1/s*(1/(R*I3)*(R*I3*gamma3*omega3 + G_level) - gamma3*omega3) */
    const double t15 = x[0]*t12; /* gamma3*t10*m*R^2*1/s */
    const double t16 = t4*p[21]; /* 1/s*1/R */
    const double t17 = JLT_FMA(t7, t16, t15); /* 1/s*(R*I3*gamma3*omega3 + G_level)*1/s*1/R + gamma3*t10*m*R^2*1/s */
    const double t18 = JLT_FMA(t4, t9, x[3]); /* 1/s*1/s*(R*I3*gamma3*omega3 + G_level)*gamma3*1/(R*I3) + omega3 */
    const double t19 = JLT_FMA(t17, t18, t14); /* d(energy)/d(gamma3) = t17*t18 + t14 */
    const double t20 = p[0]*x[1]; /* m*v_nu */
    const double t21 = p[5]*x[2]; /* I3*omega_tau */
    const double t22 = JLT_FMA(t18, p[5], t12); /* d(energy)/d(omega3) = t18*I3 + t10*m*R^2*1/s */
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t24 = p[22]*t23; /* 2*m*I3^2*(omega_tau*R + v_nu) */
    const double t25 = t23*p[23]; /* (omega_tau*R + v_nu)*2*m*R*I3^2 */
    out[0] = t19;
    out[1] = t20;
    out[2] = t21;
    out[3] = t22;
    out[4] = 0.0;
    out[5] = t24;
    out[6] = t25;
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
    const double t4 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t5 = JLT_FMA(x[3], t4, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t6 = p[7]*t5; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t7 = t6/t3; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level)/s */
    out[0] = t7;
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
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
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
        t16[k] = t6[k]*p[9];
        t17[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t16, t17, k);
        t18[k] = p[9]*t17[k];
        t19[k] = p[7]*t14[k];
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = jlt_jet_product(x0, t18, k);
        t22[k] = jlt_jet_product(t20, t21, k) + x3[k];
        t23[k] = jlt_jet_product(t20, t22, k);
        t24[k] = p[1]*t23[k];
        t25[k] = -t23[k];
        t28[k] = x2[k]*p[1] + x1[k];
        t29[k] = p[10]*t28[k];
        t30[k] = jlt_jet_product(t6, t29, k);
        t31[k] = jlt_jet_product(t17, t30, k);
        t32[k] = jlt_jet_product(t20, t31, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t24[k]/(k + 1);
        next[2] = x2[k + 1] = t25[k]/(k + 1);
        next[3] = x3[k + 1] = t32[k]/(k + 1);
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
    .state_count = 4, .param_count = 7, .block_count = 24,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 14, 3, 1, 1, 0, 10, 5 }, { 9, 31, 0, 4, 1, 0, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 8, 23, 5, 1, 1, 0, 13, 10 }, { 24, 80, 0, 18, 1, 0, 13, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 10, 27, 5, 1, 1, 0, 12, 10 }, { 28, 93, 0, 21, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 7, 2, 1, 1, 0, 7, 4 }, { 6, 19, 0, 2, 1, 0, 9, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 2, 10, 7, 1, 1, 0, 8, 5 }, { 9, 31, 0, 1, 1, 0, 13, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 12, { 2, 14, 8, 1, 1, 0, 11, 8 }, { 13, 48, 0, 6, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 3, 1, 1, 1, 0, 4, 3 }, { 2, 6, 0, 1, 1, 0, 5, 3 },
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
