/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   15    3    1    1    0      9    5   (45)
 *  jacobian            8   24    5    1    1    0     12    8   (123)
 *  rhs_jacobian        9   29    5    1    1    0     12   10   (143)
 *  divergence          2    7    2    1    1    0      7    4   (28)
 *  integral_values     2   11    7    1    1    0      9    4   (42)
 *  integral_gradients  2   14    6    1    1    0     10    5   (68)
 *  eliminated          2    3    1    1    1    0      4    3   (10)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level, V = omega_tau*R + v_nu,
 *      a part of d(v_nu)/dt and of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(omega3),
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
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
    out[8] = t0;
    const double t1 = 1.0/t0; /* 1/(R*I3) */
    out[7] = t1;
    const double t2 = params[5]*params[5]; /* I3*I3 */
    const double t3 = params[1]*params[1]; /* R*R */
    out[17] = t3;
    const double t4 = params[0]*t3; /* m*R*R */
    out[21] = t4;
    const double t5 = params[5]*t4; /* I3*m*R*R */
    const double t6 = t2 + t5; /* I3*I3 + I3*m*R*R */
    out[9] = t6;
    const double t7 = -params[0]; /* -m */
    out[12] = t7;
    const double t8 = params[1]*params[0]; /* R*m */
    const double t9 = -t8; /* -R*m */
    out[13] = t9;
    const double t10 = params[5]*t8; /* I3*R*m */
    out[11] = t10;
    const double t11 = -t10; /* -I3*R*m */
    out[10] = t11;
    const double t12 = -t2; /* -I3*I3 */
    const double t13 = t12 - t5; /* -I3*I3 - I3*m*R*R */
    out[14] = t13;
    const double t14 = params[0]/2.0; /* m/2 */
    out[15] = t14;
    const double t15 = params[5]/params[0]; /* I3/m */
    out[16] = t15;
    const double t16 = t2*params[0]; /* I3*I3*m */
    out[18] = t16;
    const double t17 = 1.0/params[1]; /* 1/R */
    out[19] = t17;
    const double t18 = t8/params[5]; /* R*m/I3 */
    out[20] = t18;
    const double t19 = params[0]*2.0; /* m*2 */
    const double t20 = t2*t19; /* I3*I3*m*2 */
    out[22] = t20;
    const double t21 = params[1]*t19; /* R*m*2 */
    const double t22 = t2*t21; /* I3*I3*R*m*2 */
    out[23] = t22;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    out[0] = t4;
    const double t5 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t6 = JLT_FMA(x[3], t5, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t7 = t2*p[9]; /* s^2*(I3^2 + m*R^2*I3) */
    const double t8 = 1.0/t7; /* 1/(s^2*(I3^2 + m*R^2*I3)) */
    const double t9 = t3*p[9]; /* s*(I3^2 + m*R^2*I3) */
    const double t10 = t8*t9; /* 1/(s^2*(I3^2 + m*R^2*I3))*s*(I3^2 + m*R^2*I3) */
    const double t11 = p[7]*t6; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t12 = t10*t11; /* omega_n = 1/(s^2*(I3^2 + m*R^2*I3))*s*(I3^2 + m*R^2*I3)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level) */
    const double t13 = x[0]*t10; /* gamma3*1/(s^2*(I3^2 + m*R^2*I3))*s*(I3^2 + m*R^2*I3) */
    const double t14 = JLT_FMA(t12, t13, x[3]); /* omega_n*gamma3*1/(s^2*(I3^2 + m*R^2*I3))*s*(I3^2 + m*R^2*I3) + omega3 */
    const double t15 = t12*t14; /* omega_n*t14 */
    const double t16 = p[1]*t15; /* R*omega_n*t14 */
    out[1] = t16;
    const double t17 = -t15; /* -omega_n*t14 */
    out[2] = t17;
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t19 = t2*p[10]; /* s^2*(-m*R*I3) */
    const double t20 = t18*t19; /* V*s^2*(-m*R*I3) */
    const double t21 = t8*t20; /* 1/(s^2*(I3^2 + m*R^2*I3))*V*s^2*(-m*R*I3) */
    const double t22 = t12*t21; /* omega_n*1/(s^2*(I3^2 + m*R^2*I3))*V*s^2*(-m*R*I3) */
    out[3] = t22;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = p[9]*t2; /* (I3^2 + m*R^2*I3)*s^2 */
    const double t4 = 1.0/t3; /* 1/((I3^2 + m*R^2*I3)*s^2) */
    const double t5 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t5;
    const double t6 = p[9]*t5; /* (I3^2 + m*R^2*I3)*s */
    const double t7 = t4*t6; /* 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s */
    const double t8 = t2*t4; /* 1/Theta = s^2*1/((I3^2 + m*R^2*I3)*s^2) */
    const double t9 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t10 = JLT_FMA(x[3], t9, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t11 = t7*t10; /* 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*(omega3*gamma3*R*I3 + G_level) */
    const double t12 = x[0]*t7; /* gamma3*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s */
    const double t13 = p[7]*t11; /* 1/(R*I3)*t11 */
    const double t14 = t8*t11; /* 1/Theta*t11 */
    const double t15 = p[12]*t14; /* (-m)*1/Theta*t11 */
    out[13] = t15;
    const double t16 = p[13]*t14; /* (-m*R)*1/Theta*t11 */
    out[14] = t16;
    const double t17 = t7*t13; /* 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*1/(R*I3)*t11 */
    const double t18 = t12*t13; /* gamma3*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*1/(R*I3)*t11 */
    const double t19 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t20 = p[11]*t19; /* m*R*I3*V */
    const double t21 = t8*t20; /* 1/Theta*m*R*I3*V */
    const double t22 = t7*t17; /* 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*1/(R*I3)*t11 */
    const double t23 = t17*t22; /* 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*1/(R*I3)*t11*t22 */
    const double t24 = x[3] + t18; /* omega3 + t18 */
    const double t25 = t7*t24; /* d(omega_n)/d(gamma3) = 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*(omega3 + t18) */
    const double t26 = JLT_FMA(2.0, t18, x[3]); /* 2*t18 + omega3 */
    const double t27 = JLT_FMA(t25, t26, t23); /* d(omega_n)/d(gamma3)*(2*t18 + omega3) + t23 */
    const double t28 = JLT_FMA(t12, t26, t13); /* gamma3*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*(2*t18 + omega3) + 1/(R*I3)*t11 */
    const double t29 = t21*t25; /* 1/Theta*m*R*I3*V*d(omega_n)/d(gamma3) */
    const double t30 = -t29; /* -1/Theta*m*R*I3*V*d(omega_n)/d(gamma3) */
    out[12] = t30;
    const double t31 = t12*t21; /* gamma3*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*1/Theta*m*R*I3*V */
    const double t32 = -t31; /* -t31 */
    out[15] = t32;
    const double t33 = x[2]*t12; /* omega_tau*gamma3*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s */
    const double t34 = -t33; /* -t33 */
    out[0] = t34;
    const double t35 = p[1]*t27; /* R*(d(omega_n)/d(gamma3)*(2*t18 + omega3) + t23) */
    out[4] = t35;
    const double t36 = -t27; /* -(d(omega_n)/d(gamma3)*(2*t18 + omega3) + t23) */
    out[8] = t36;
    const double t37 = p[1]*t28; /* R*t28 */
    out[7] = t37;
    const double t38 = -t28; /* -t28 */
    out[11] = t38;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = p[9]*t2; /* (I3^2 + m*R^2*I3)*s^2 */
    const double t4 = 1.0/t3; /* 1/((I3^2 + m*R^2*I3)*s^2) */
    const double t5 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t5;
    const double t6 = t2*t4; /* 1/Theta = s^2*1/((I3^2 + m*R^2*I3)*s^2) */
    const double t7 = x[2]*t5; /* omega_tau*s */
    out[0] = t7;
    const double t8 = p[9]*t5; /* (I3^2 + m*R^2*I3)*s */
    const double t9 = t4*t8; /* 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s */
    const double t10 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t11 = JLT_FMA(x[3], t10, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t12 = t9*t11; /* 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*(omega3*gamma3*R*I3 + G_level) */
    const double t13 = p[7]*t12; /* 1/(R*I3)*t12 */
    const double t14 = x[0]*t9; /* gamma3*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s */
    const double t15 = t13*t14; /* 1/(R*I3)*t12*gamma3*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s */
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = t6*t16; /* 1/Theta*V */
    const double t18 = t6*t12; /* 1/Theta*t12 */
    const double t19 = p[12]*t18; /* (-m)*1/Theta*t12 */
    out[17] = t19;
    const double t20 = p[13]*t18; /* (-m*R)*1/Theta*t12 */
    out[18] = t20;
    const double t21 = t9*t13; /* 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*1/(R*I3)*t12 */
    const double t22 = x[3] + t15; /* omega3 + t15 */
    const double t23 = JLT_FMA(2.0, t15, x[3]); /* 2*t15 + omega3 */
    const double t24 = t9*t21; /* 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*1/(R*I3)*t12 */
    const double t25 = t21*t24; /* 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*1/(R*I3)*t12*t24 */
    const double t26 = t9*t22; /* d(omega_n)/d(gamma3) = 1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*(omega3 + t15) */
    const double t27 = t13*t22; /* 1/(R*I3)*t12*(omega3 + t15) */
    const double t28 = JLT_FMA(t23, t26, t25); /* (2*t15 + omega3)*d(omega_n)/d(gamma3) + t25 */
    const double t29 = JLT_FMA(t14, t23, t13); /* gamma3*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*(2*t15 + omega3) + 1/(R*I3)*t12 */
    const double t30 = p[1]*t27; /* R*1/(R*I3)*t12*(omega3 + t15) */
    out[1] = t30;
    const double t31 = -t27; /* -1/(R*I3)*t12*(omega3 + t15) */
    out[2] = t31;
    const double t32 = p[1]*t28; /* R*((2*t15 + omega3)*d(omega_n)/d(gamma3) + t25) */
    out[8] = t32;
    const double t33 = -t28; /* -((2*t15 + omega3)*d(omega_n)/d(gamma3) + t25) */
    out[12] = t33;
    const double t34 = p[1]*t29; /* R*t29 */
    out[11] = t34;
    const double t35 = -t29; /* -t29 */
    out[15] = t35;
    const double t36 = p[11]*t17; /* m*R*I3*1/Theta*V */
    const double t37 = p[12]*t17; /* (-m)*1/Theta*V */
    const double t38 = t12*t37; /* t12*(-m)*1/Theta*V */
    out[3] = t38;
    const double t39 = t26*t36; /* d(omega_n)/d(gamma3)*m*R*I3*1/Theta*V */
    const double t40 = -t39; /* -d(omega_n)/d(gamma3)*m*R*I3*1/Theta*V */
    out[16] = t40;
    const double t41 = t14*t36; /* gamma3*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s*m*R*I3*1/Theta*V */
    const double t42 = -t41; /* -t41 */
    out[19] = t42;
    const double t43 = x[2]*t14; /* omega_tau*gamma3*1/((I3^2 + m*R^2*I3)*s^2)*(I3^2 + m*R^2*I3)*s */
    const double t44 = -t43; /* -t43 */
    out[4] = t44;
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
    const double t10 = p[14]*x[0]; /* (-I3^2 - m*R^2*I3)*gamma3 */
    const double t11 = t6*t10; /* 1/(s*(I3^2 + m*R^2*I3))*(-I3^2 - m*R^2*I3)*gamma3 */
    const double t12 = t9*t11; /* (1/(s*(I3^2 + m*R^2*I3))*s*m*R*I3*V + omega_tau)*1/(s*(I3^2 + m*R^2*I3))*(-I3^2 - m*R^2*I3)*gamma3 */
    out[0] = t12;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[3]*p[8]; /* omega3*R*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[6]); /* gamma3*omega3*R*I3 + G_level */
    const double t5 = p[7]*t4; /* 1/(R*I3)*(gamma3*omega3*R*I3 + G_level) */
    const double t6 = t5/t2; /* 1/(R*I3)*(gamma3*omega3*R*I3 + G_level)/s^2 */
    const double t7 = sqrt(t2); /* s = sqrt(s^2) */
    const double t8 = t6*t7; /* omega_n = 1/(R*I3)*(gamma3*omega3*R*I3 + G_level)/s^2*s */
    const double t9 = x[3]*t7; /* omega3*s */
    const double t10 = JLT_FMA(x[0], t8, t9); /* v_tau/R = gamma3*omega_n + omega3*s */
    const double t11 = x[3]*x[3]; /* omega3*omega3 */
    const double t12 = JLT_FMA(x[2], x[2], t11); /* omega_tau*omega_tau + omega3*omega3 */
    const double t13 = JLT_FMA(t8, t8, t12); /* omega_n*omega_n + omega_tau*omega_tau + omega3*omega3 */
    const double t14 = x[1]*x[1]; /* v_nu*v_nu */
    const double t15 = JLT_FMA(p[16], t13, t14); /* I3/m*(omega_n*omega_n + omega_tau*omega_tau + omega3*omega3) + v_nu*v_nu */
    const double t16 = p[17]*t10; /* R^2*v_tau/R */
    const double t17 = JLT_FMA(t10, t16, t15); /* energy/(1/2*m) = v_tau/R*R^2*v_tau/R + t15 */
    const double t18 = p[15]*t17; /* 1/2*m*energy/(1/2*m) */
    out[0] = t18;
    const double t19 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[2] = t19;
    const double t20 = p[18]*t19; /* m*I3^2*(omega_tau*R + v_nu) */
    const double t21 = t19*t20; /* (omega_tau*R + v_nu)*m*I3^2*(omega_tau*R + v_nu) */
    out[1] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[9] = 1.0;
    out[4] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[10] = p[1];
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = p[5]*x[2]; /* I3*omega_tau */
    out[2] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t7 = JLT_FMA(x[3], t6, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t8 = 1.0/t5; /* 1/s */
    const double t9 = t7*t8; /* (omega3*gamma3*R*I3 + G_level)*1/s */
    const double t10 = x[0]*p[7]; /* gamma3*1/(R*I3) */
    const double t11 = t9*t10; /* (omega3*gamma3*R*I3 + G_level)*1/s*gamma3*1/(R*I3) */
    const double t12 = JLT_FMA(x[3], t5, t11); /* omega3*s + (omega3*gamma3*R*I3 + G_level)*1/s*gamma3*1/(R*I3) */
    const double t13 = JLT_FMA(t8, t11, x[3]); /* 1/s*(omega3*gamma3*R*I3 + G_level)*1/s*gamma3*1/(R*I3) + omega3 */
    const double t14 = t8*t12; /* 1/s*t12 */
    const double t15 = t8*t9; /* 1/s*(omega3*gamma3*R*I3 + G_level)*1/s */
    const double t16 = p[19]*t13; /* 1/R*t13 */
    const double t17 = JLT_FMA(p[20], t14, t16); /* m*R/I3*1/s*t12 + 1/R*t13 */
    const double t18 = t15*t17; /* 1/s*(omega3*gamma3*R*I3 + G_level)*1/s*(m*R/I3*1/s*t12 + 1/R*t13) */
    out[0] = t18;
    const double t19 = p[5]*t13; /* I3*t13 */
    const double t20 = JLT_FMA(p[21], t14, t19); /* d(energy)/d(omega3) = m*R^2*1/s*t12 + I3*t13 */
    out[3] = t20;
    const double t21 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t22 = p[22]*t21; /* 2*m*I3^2*(omega_tau*R + v_nu) */
    out[5] = t22;
    const double t23 = p[23]*t21; /* 2*m*R*I3^2*(omega_tau*R + v_nu) */
    out[6] = t23;
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
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 24,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 15, 3, 1, 1, 0, 9, 5 }, { 9, 31, 0, 4, 1, 0, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level, omega_n*gamma3*((1)/s^2*(I3^2 + m*R^2*I3))*s*(I3^2 + m*R^2*I3) + omega3, V = omega_tau*R + v_nu" },
    .jacobian = { jacobian, 16, { 8, 24, 5, 1, 1, 0, 12, 8 }, { 24, 80, 0, 18, 1, 0, 13, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level, V = omega_tau*R + v_nu, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 9, 29, 5, 1, 1, 0, 12, 10 }, { 28, 93, 0, 21, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level, V = omega_tau*R + v_nu, a part of d(v_nu)/dt and of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3)" },
    .divergence = { divergence, 1, { 2, 7, 2, 1, 1, 0, 7, 4 }, { 6, 19, 0, 2, 1, 0, 9, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, ((1)/s*(I3^2 + m*R^2*I3))*s*(m*R*I3)*V + omega_tau" },
    .integral_values = { integral_values, 3, { 2, 11, 7, 1, 1, 0, 9, 4 }, { 9, 31, 0, 1, 1, 0, 13, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3*(R*I3) + G_level, v_tau/R = gamma3*omega_n + omega3*s, F_linear" },
    .integral_gradients = { integral_gradients, 12, { 2, 14, 6, 1, 1, 0, 10, 5 }, { 13, 48, 0, 6, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level, omega3*s + (omega3*gamma3*(R*I3) + G_level)*((1)/s)*gamma3*(1/(R*I3)), a part of d(E)/d(gamma3) and of d(E)/d(omega3), a part of d(E)/d(gamma3), d(E)/d(omega3), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 3, 1, 1, 1, 0, 4, 3 }, { 2, 6, 0, 1, 1, 0, 5, 3 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level" },
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
