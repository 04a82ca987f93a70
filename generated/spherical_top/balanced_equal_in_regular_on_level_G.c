/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   15    6    1    0    0     10    6   (47)
 *  jacobian            6   30    8    1    0    0     12    6   (180)
 *  rhs_jacobian        10   36    8    1    0    0     12    7   (205)
 *  divergence          2    3    3    1    0    0      7    3   (23)
 *  integral_values     0    9    7    1    0    0      8    4   (39)
 *  integral_gradients  0   15   10    1    0    0      7    8   (72)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    2    1    1    0    0      4    2   (7)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are
 *    digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level, V = omega_tau*R + v_nu,
 *      omega3 + 1/s*(omega3*gamma3*(R*I3) + G_level)*1/s*gamma3*(2/(R*I3)),
 *      a part of d(v_nu)/dtau and of d(omega_tau)/dtau,
 *      a part of d(d(v_nu)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(gamma3),
 *      a part of d(d(v_nu)/dtau)/d(omega3) and of d(d(omega_tau)/dtau)/d(omega3), d(d(omega3)/dtau)/d(gamma3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_avx512;

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
    const double t0 = 1.0/params[5]; /* 1/I3 */
    out[7] = t0;
    const double t1 = params[5]*params[1]; /* I3*R */
    out[8] = t1;
    const double t2 = params[5]*params[5]; /* I3*I3 */
    out[10] = t2;
    const double t3 = params[1]*t2; /* R*I3*I3 */
    const double t4 = 1.0/t3; /* 1/(R*I3*I3) */
    out[9] = t4;
    const double t5 = params[1]*params[1]; /* R*R */
    out[29] = t5;
    const double t6 = params[0]*t5; /* m*R*R */
    out[32] = t6;
    const double t7 = params[5]*t6; /* I3*m*R*R */
    out[11] = t7;
    const double t8 = t2*t5; /* I3*I3*R*R */
    const double t9 = (-1.0)/t8; /* (-1)/(I3*I3*R*R) */
    out[12] = t9;
    const double t10 = (-1.0)/t1; /* (-1)/(I3*R) */
    out[13] = t10;
    const double t11 = -params[0]; /* -m */
    out[14] = t11;
    const double t12 = 2.0/t1; /* 2/(I3*R) */
    out[15] = t12;
    const double t13 = 1.0/t8; /* 1/(I3*I3*R*R) */
    out[16] = t13;
    const double t14 = 1.0/t1; /* 1/(I3*R) */
    out[17] = t14;
    const double t15 = (-2.0)/t3; /* (-2)/(R*I3*I3) */
    out[18] = t15;
    const double t16 = 2.0/t8; /* 2/(I3*I3*R*R) */
    out[19] = t16;
    const double t17 = params[1]*params[0]; /* R*m */
    const double t18 = params[5]*t17; /* I3*R*m */
    out[20] = t18;
    const double t19 = params[0]*params[0]; /* m*m */
    const double t20 = 2.0*t19; /* 2*m*m */
    const double t21 = t5*t20; /* R*R*2*m*m */
    const double t22 = params[5]*t21; /* I3*R*R*2*m*m */
    out[21] = t22;
    const double t23 = -t17; /* -R*m */
    out[22] = t23;
    const double t24 = -params[1]; /* -R */
    out[23] = t24;
    const double t25 = params[1]*t5; /* R*R*R */
    const double t26 = t20*t25; /* 2*m*m*R*R*R */
    const double t27 = t2*t26; /* I3*I3*2*m*m*R*R*R */
    out[24] = t27;
    const double t28 = -t18; /* -I3*R*m */
    out[25] = t28;
    const double t29 = -t7; /* -I3*m*R*R */
    out[26] = t29;
    const double t30 = params[0]/2.0; /* m/2 */
    out[27] = t30;
    const double t31 = params[5]/params[0]; /* I3/m */
    out[28] = t31;
    const double t32 = t2*params[0]; /* I3*I3*m */
    out[30] = t32;
    const double t33 = 1.0/params[1]; /* 1/R */
    out[31] = t33;
    const double t34 = params[0]*2.0; /* m*2 */
    const double t35 = t2*t34; /* I3*I3*m*2 */
    out[33] = t35;
    const double t36 = params[1]*t34; /* R*m*2 */
    const double t37 = t2*t36; /* I3*I3*R*m*2 */
    out[34] = t37;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t1;
    const double t2 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t3 = JLT_FMA(x[3], t2, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t4 = x[3]*t3; /* omega3*(omega3*R*I3*gamma3 + G_level) */
    const double t5 = p[7]*t4; /* 1/I3*omega3*(omega3*R*I3*gamma3 + G_level) */
    const double t6 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t7 = JLT_FMA(p[11], t6, p[10]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t8 = x[4]*t7; /* s*Theta */
    const double t9 = t3/t8; /* (omega3*R*I3*gamma3 + G_level)/(s*Theta) */
    const double t10 = t7*t9; /* Theta*(omega3*R*I3*gamma3 + G_level)/(s*Theta) */
    const double t11 = x[0]*t10; /* gamma3*Theta*(omega3*R*I3*gamma3 + G_level)/(s*Theta) */
    const double t12 = t10*t11; /* Theta*(omega3*R*I3*gamma3 + G_level)/(s*Theta)*gamma3*Theta*(omega3*R*I3*gamma3 + G_level)/(s*Theta) */
    const double t13 = JLT_FMA(p[9], t12, t5); /* 1/(R*I3^2)*t12 + 1/I3*omega3*(omega3*R*I3*gamma3 + G_level) */
    out[1] = t13;
    const double t14 = t12*p[12]; /* t12*(-1/(R^2*I3^2)) */
    const double t15 = JLT_FMA(t4, p[13], t14); /* omega3*(omega3*R*I3*gamma3 + G_level)*(-1/(R*I3)) + t12*(-1/(R^2*I3^2)) */
    out[2] = t15;
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = x[4]*p[14]; /* s*(-m) */
    const double t18 = t16*t17; /* V*s*(-m) */
    const double t19 = t9*t18; /* (omega3*R*I3*gamma3 + G_level)/(s*Theta)*V*s*(-m) */
    out[3] = t19;
    const double t20 = x[2]*x[4]; /* omega_tau*s */
    const double t21 = x[0]*t20; /* gamma3*omega_tau*s */
    const double t22 = -t21; /* -gamma3*omega_tau*s */
    out[4] = t22;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[21] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[2] = t0;
    const double t1 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t2 = JLT_FMA(p[11], t1, p[10]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t3 = x[4]*t2; /* s*Theta */
    const double t4 = 1.0/t3; /* 1/(s*Theta) */
    const double t5 = t2*t4; /* 1/s = Theta*1/(s*Theta) */
    const double t6 = x[4]*t4; /* 1/Theta = s*1/(s*Theta) */
    const double t7 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t8 = JLT_FMA(x[3], t7, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t9 = t5*t8; /* 1/s*(omega3*R*I3*gamma3 + G_level) */
    const double t10 = x[0]*t5; /* gamma3*1/s */
    const double t11 = p[15]*t9; /* 2/(R*I3)*1/s*(omega3*R*I3*gamma3 + G_level) */
    const double t12 = JLT_FMA(t10, t11, x[3]); /* gamma3*1/s*2/(R*I3)*1/s*(omega3*R*I3*gamma3 + G_level) + omega3 */
    const double t13 = t9*t9; /* 1/s*(omega3*R*I3*gamma3 + G_level)*1/s*(omega3*R*I3*gamma3 + G_level) */
    const double t14 = t10*t13; /* gamma3*1/s*t13 */
    const double t15 = p[18]*t14; /* (-2/(R*I3^2))*gamma3*1/s*t13 */
    out[9] = t15;
    const double t16 = p[19]*t14; /* 2/(R^2*I3^2)*gamma3*1/s*t13 */
    out[14] = t16;
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t18 = t6*t17; /* 1/Theta*V */
    const double t19 = t6*t8; /* 1/Theta*(omega3*R*I3*gamma3 + G_level) */
    const double t20 = p[17]*t8; /* 1/(R*I3)*(omega3*R*I3*gamma3 + G_level) */
    const double t21 = JLT_FMA(x[0], t12, t20); /* gamma3*t12 + 1/(R*I3)*(omega3*R*I3*gamma3 + G_level) */
    const double t22 = x[3]*t12; /* omega3*t12 */
    const double t23 = JLT_FMA(p[16], t13, t22); /* 1/(R^2*I3^2)*t13 + omega3*t12 */
    const double t24 = p[1]*t23; /* R*(1/(R^2*I3^2)*t13 + omega3*t12) */
    out[5] = t24;
    const double t25 = -t23; /* -(1/(R^2*I3^2)*t13 + omega3*t12) */
    out[10] = t25;
    const double t26 = p[1]*t21; /* R*(gamma3*t12 + 1/(R*I3)*(omega3*R*I3*gamma3 + G_level)) */
    out[8] = t26;
    const double t27 = -t21; /* -(gamma3*t12 + 1/(R*I3)*(omega3*R*I3*gamma3 + G_level)) */
    out[13] = t27;
    const double t28 = p[14]*t19; /* (-m)*1/Theta*(omega3*R*I3*gamma3 + G_level) */
    out[16] = t28;
    const double t29 = p[22]*t19; /* (-m*R)*1/Theta*(omega3*R*I3*gamma3 + G_level) */
    out[17] = t29;
    const double t30 = p[20]*t18; /* m*R*I3*1/Theta*V */
    const double t31 = p[21]*t18; /* 2*m^2*R^2*I3*1/Theta*V */
    const double t32 = t19*t31; /* 1/Theta*(omega3*R*I3*gamma3 + G_level)*2*m^2*R^2*I3*1/Theta*V */
    const double t33 = x[4]*t32; /* s*t32 */
    out[19] = t33;
    const double t34 = x[4]*x[2]; /* s*omega_tau */
    const double t35 = 2.0*t34; /* 2*s*omega_tau */
    out[4] = t35;
    const double t36 = -t34; /* -s*omega_tau */
    out[20] = t36;
    const double t37 = x[3]*t30; /* omega3*m*R*I3*1/Theta*V */
    const double t38 = JLT_FMS(x[0], t32, t37); /* gamma3*t32 - omega3*m*R*I3*1/Theta*V */
    out[15] = t38;
    const double t39 = x[0]*t30; /* gamma3*m*R*I3*1/Theta*V */
    const double t40 = -t39; /* -gamma3*m*R*I3*1/Theta*V */
    out[18] = t40;
    const double t41 = x[4]*x[0]; /* s*gamma3 */
    const double t42 = -t41; /* -s*gamma3 */
    out[22] = t42;
    const double t43 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t44 = -t43; /* -omega_tau*gamma3 */
    out[24] = t44;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[7] = t0;
    const double t1 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t2 = JLT_FMA(p[11], t1, p[10]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t3 = x[4]*t2; /* s*Theta */
    const double t4 = 1.0/t3; /* 1/(s*Theta) */
    const double t5 = t2*t4; /* 1/s = Theta*1/(s*Theta) */
    const double t6 = x[4]*t4; /* 1/Theta = s*1/(s*Theta) */
    const double t7 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t8 = JLT_FMA(x[3], t7, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t9 = t5*t8; /* 1/s*(omega3*gamma3*R*I3 + G_level) */
    const double t10 = x[0]*p[15]; /* gamma3*2/(R*I3) */
    const double t11 = t5*t10; /* 1/s*gamma3*2/(R*I3) */
    const double t12 = t9*t11; /* 1/s*(omega3*gamma3*R*I3 + G_level)*1/s*gamma3*2/(R*I3) */
    const double t13 = p[16]*t9; /* 1/(R^2*I3^2)*1/s*(omega3*gamma3*R*I3 + G_level) */
    const double t14 = t9*t13; /* 1/s*(omega3*gamma3*R*I3 + G_level)*1/(R^2*I3^2)*1/s*(omega3*gamma3*R*I3 + G_level) */
    const double t15 = p[17]*t9; /* 1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level) */
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = t6*t16; /* 1/Theta*V */
    const double t18 = x[4]*t15; /* s*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level) */
    const double t19 = t6*t18; /* 1/Theta*s*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level) */
    const double t20 = t12*t15; /* 1/s*(omega3*gamma3*R*I3 + G_level)*1/s*gamma3*2/(R*I3)*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level) */
    out[19] = t20;
    const double t21 = p[23]*t20; /* (-R)*t20 */
    out[14] = t21;
    const double t22 = x[3] + t12; /* omega3 + 1/s*(omega3*gamma3*R*I3 + G_level)*1/s*gamma3*2/(R*I3) */
    const double t23 = p[25]*t19; /* (-m*R*I3)*1/Theta*s*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level) */
    out[21] = t23;
    const double t24 = p[26]*t19; /* (-m*R^2*I3)*1/Theta*s*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level) */
    out[22] = t24;
    const double t25 = x[4]*x[2]; /* s*omega_tau */
    const double t26 = x[4]*t25; /* s*s*omega_tau */
    out[0] = t26;
    const double t27 = 2.0*t25; /* 2*s*omega_tau */
    out[9] = t27;
    const double t28 = -t25; /* -s*omega_tau */
    out[25] = t28;
    const double t29 = x[0]*t25; /* gamma3*s*omega_tau */
    const double t30 = -t29; /* -gamma3*s*omega_tau */
    out[4] = t30;
    const double t31 = x[0]*t14; /* gamma3*t14 */
    const double t32 = JLT_FMA(x[3], t18, t31); /* omega3*s*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level) + gamma3*t14 */
    const double t33 = JLT_FMA(x[3], t22, t14); /* omega3*t22 + t14 */
    const double t34 = JLT_FMA(x[0], t22, t18); /* gamma3*t22 + s*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level) */
    const double t35 = p[1]*t32; /* R*t32 */
    out[1] = t35;
    const double t36 = -t32; /* -t32 */
    out[2] = t36;
    const double t37 = p[1]*t33; /* R*(omega3*t22 + t14) */
    out[10] = t37;
    const double t38 = -t33; /* -(omega3*t22 + t14) */
    out[15] = t38;
    const double t39 = p[1]*t34; /* R*(gamma3*t22 + s*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level)) */
    out[13] = t39;
    const double t40 = -t34; /* -(gamma3*t22 + s*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level)) */
    out[18] = t40;
    const double t41 = p[20]*t17; /* m*R*I3*1/Theta*V */
    const double t42 = p[24]*t17; /* 2*m^2*R^3*I3^2*1/Theta*V */
    const double t43 = t19*t42; /* 1/Theta*s*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level)*2*m^2*R^3*I3^2*1/Theta*V */
    const double t44 = t18*t41; /* s*1/(R*I3)*1/s*(omega3*gamma3*R*I3 + G_level)*m*R*I3*1/Theta*V */
    const double t45 = -t44; /* -t44 */
    out[3] = t45;
    const double t46 = x[4]*t43; /* s*t43 */
    out[24] = t46;
    const double t47 = x[3]*t41; /* omega3*m*R*I3*1/Theta*V */
    const double t48 = JLT_FMS(x[0], t43, t47); /* gamma3*t43 - omega3*m*R*I3*1/Theta*V */
    out[20] = t48;
    const double t49 = x[0]*t41; /* gamma3*m*R*I3*1/Theta*V */
    const double t50 = -t49; /* -gamma3*m*R*I3*1/Theta*V */
    out[23] = t50;
    const double t51 = x[4]*x[0]; /* s*gamma3 */
    const double t52 = -t51; /* -s*gamma3 */
    out[27] = t52;
    const double t53 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t54 = -t53; /* -omega_tau*gamma3 */
    out[29] = t54;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = JLT_FMA(x[4], x[4], t0); /* s*s + gamma3*gamma3 */
    const double t2 = JLT_FMA(p[11], t1, p[10]); /* Theta = m*R^2*I3*(s*s + gamma3*gamma3) + I3^2 */
    const double t3 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t4 = p[20]*t3; /* m*R*I3*V */
    const double t5 = t4/t2; /* m*R*I3*V/Theta */
    const double t6 = x[2] + t5; /* omega_tau + m*R*I3*V/Theta */
    const double t7 = x[0]*t6; /* gamma3*(omega_tau + m*R*I3*V/Theta) */
    const double t8 = -t7; /* -gamma3*(omega_tau + m*R*I3*V/Theta) */
    out[0] = t8;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*p[8]; /* omega3*R*I3 */
    const double t1 = JLT_FMA(x[0], t0, p[6]); /* gamma3*omega3*R*I3 + G_level */
    const double t2 = p[17]*t1; /* 1/(R*I3)*(gamma3*omega3*R*I3 + G_level) */
    const double t3 = t2/x[4]; /* omega_n = 1/(R*I3)*(gamma3*omega3*R*I3 + G_level)/s */
    const double t4 = x[3]*x[3]; /* omega3*omega3 */
    const double t5 = JLT_FMA(x[2], x[2], t4); /* omega_tau*omega_tau + omega3*omega3 */
    const double t6 = JLT_FMA(t3, t3, t5); /* omega_n*omega_n + omega_tau*omega_tau + omega3*omega3 */
    const double t7 = x[3]*x[4]; /* omega3*s */
    const double t8 = JLT_FMA(x[0], t3, t7); /* v_tau/R = gamma3*omega_n + omega3*s */
    const double t9 = x[1]*x[1]; /* v_nu*v_nu */
    const double t10 = JLT_FMA(p[28], t6, t9); /* I3/m*(omega_n*omega_n + omega_tau*omega_tau + omega3*omega3) + v_nu*v_nu */
    const double t11 = p[29]*t8; /* R^2*v_tau/R */
    const double t12 = JLT_FMA(t8, t11, t10); /* energy/(1/2*m) = v_tau/R*R^2*v_tau/R + t10 */
    const double t13 = p[27]*t12; /* 1/2*m*energy/(1/2*m) */
    out[0] = t13;
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[2] = t14;
    const double t15 = p[30]*t14; /* m*I3^2*(omega_tau*R + v_nu) */
    const double t16 = t14*t15; /* (omega_tau*R + v_nu)*m*I3^2*(omega_tau*R + v_nu) */
    out[1] = t16;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[11] = 1.0;
    const double t0 = 1.0/x[4]; /* 1/s */
    const double t1 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t2 = JLT_FMA(x[3], t1, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t3 = t0*t2; /* 1/s*(omega3*R*I3*gamma3 + G_level) */
    const double t4 = p[31]*t3; /* 1/R*1/s*(omega3*R*I3*gamma3 + G_level) */
    const double t5 = t0*t4; /* 1/s*1/R*1/s*(omega3*R*I3*gamma3 + G_level) */
    const double t6 = x[3]*t5; /* omega3*1/s*1/R*1/s*(omega3*R*I3*gamma3 + G_level) */
    const double t7 = t3*p[17]; /* 1/s*(omega3*R*I3*gamma3 + G_level)*1/(R*I3) */
    const double t8 = t0*x[0]; /* 1/s*gamma3 */
    const double t9 = JLT_FMA(x[3], t8, t7); /* d(v_tau)/d(gamma3)/R = omega3*1/s*gamma3 + 1/s*(omega3*R*I3*gamma3 + G_level)*1/(R*I3) */
    const double t10 = x[3]*x[4]; /* omega3*s */
    const double t11 = JLT_FMA(x[0], t7, t10); /* v_tau/R = gamma3*1/s*(omega3*R*I3*gamma3 + G_level)*1/(R*I3) + omega3*s */
    const double t12 = p[32]*t11; /* m*R^2*v_tau/R */
    const double t13 = JLT_FMA(t9, t12, t6); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R + omega3*1/s*1/R*1/s*(omega3*R*I3*gamma3 + G_level) */
    out[0] = t13;
    const double t14 = p[0]*x[1]; /* m*v_nu */
    out[1] = t14;
    const double t15 = p[5]*x[2]; /* I3*omega_tau */
    out[2] = t15;
    const double t16 = x[3]*p[5]; /* omega3*I3 */
    const double t17 = JLT_FMA(x[0], t8, x[4]); /* d(v_tau)/d(omega3)/R = gamma3*1/s*gamma3 + s */
    const double t18 = JLT_FMA(t4, t8, t16); /* 1/R*1/s*(omega3*R*I3*gamma3 + G_level)*1/s*gamma3 + omega3*I3 */
    const double t19 = JLT_FMA(t12, t17, t18); /* d(energy)/d(omega3) = m*R^2*v_tau/R*d(v_tau)/d(omega3)/R + t18 */
    out[3] = t19;
    const double t20 = t5*t7; /* 1/s*1/R*1/s*(omega3*R*I3*gamma3 + G_level)*1/s*(omega3*R*I3*gamma3 + G_level)*1/(R*I3) */
    const double t21 = JLT_FNMA(t7, t8, x[3]); /* d(v_tau)/d(s)/R = omega3 - 1/s*(omega3*R*I3*gamma3 + G_level)*1/(R*I3)*1/s*gamma3 */
    const double t22 = JLT_FMS(t12, t21, t20); /* d(energy)/d(s) = m*R^2*v_tau/R*d(v_tau)/d(s)/R - t20 */
    out[4] = t22;
    out[5] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[12] = p[1];
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t24 = p[33]*t23; /* 2*m*I3^2*(omega_tau*R + v_nu) */
    out[6] = t24;
    const double t25 = t23*p[34]; /* (omega_tau*R + v_nu)*2*m*R*I3^2 */
    out[7] = t25;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t1 = JLT_FMA(x[3], t0, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t2 = p[17]*t1; /* 1/(R*I3)*(omega3*R*I3*gamma3 + G_level) */
    const double t3 = t2/x[4]; /* 1/(R*I3)*(omega3*R*I3*gamma3 + G_level)/s */
    out[0] = t3;
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
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
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
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x4, k);
        t3[k] = jlt_jet_product(x2, t2, k);
        t9[k] = p[8]*x0[k];
        t10[k] = jlt_jet_product(x3, t9, k) + (k == 0 ? p[6] : 0);
        t11[k] = jlt_jet_product(x3, t10, k);
        t12[k] = p[7]*t11[k];
        t16[k] = jlt_jet_product(x0, x0, k) + t2[k];
        t17[k] = p[11]*t16[k] + (k == 0 ? p[10] : 0);
        t18[k] = jlt_jet_product(x4, t17, k);
        t19[k] = jlt_jet_quotient(t10[k], t18, t19, k);
        t20[k] = jlt_jet_product(t17, t19, k);
        t21[k] = jlt_jet_product(x0, t20, k);
        t22[k] = jlt_jet_product(t20, t21, k);
        t23[k] = p[9]*t22[k] + t12[k];
        t25[k] = t22[k]*p[12];
        t27[k] = t11[k]*p[13] + t25[k];
        t31[k] = x2[k]*p[1] + x1[k];
        t32[k] = x4[k]*p[14];
        t33[k] = jlt_jet_product(t31, t32, k);
        t34[k] = jlt_jet_product(t19, t33, k);
        t35[k] = jlt_jet_product(x2, x4, k);
        t36[k] = jlt_jet_product(x0, t35, k);
        t37[k] = -t36[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t23[k]/(k + 1);
        next[2] = x2[k + 1] = t27[k]/(k + 1);
        next[3] = x3[k + 1] = t34[k]/(k + 1);
        next[4] = x4[k + 1] = t37[k]/(k + 1);
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
    const double v_I3 = params[5];
    const double v_I1 = (v_I3);
    const double v_G_level = params[6];
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
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
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "regular",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 35,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 1, 15, 6, 1, 0, 0, 10, 6 }, { 9, 36, 0, 2, 0, 0, 10, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in omega3*(R*I3)*gamma3 + G_level, d(v_nu)/dtau, d(omega_tau)/dtau, V = omega_tau*R + v_nu" },
    .jacobian = { jacobian, 25, { 6, 30, 8, 1, 0, 0, 12, 6 }, { 32, 131, 0, 17, 0, 0, 11, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in omega3*(R*I3)*gamma3 + G_level, gamma3*1/s*(2/(R*I3))*1/s*(omega3*(R*I3)*gamma3 + G_level) + omega3, V = omega_tau*R + v_nu, a part of d(d(v_nu)/dtau)/d(omega3) and of d(d(omega_tau)/dtau)/d(omega3), a part of d(d(v_nu)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 36, 8, 1, 0, 0, 12, 7 }, { 37, 150, 0, 18, 0, 0, 11, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in omega3*gamma3*(R*I3) + G_level, V = omega_tau*R + v_nu, omega3 + 1/s*(omega3*gamma3*(R*I3) + G_level)*1/s*gamma3*(2/(R*I3)), a part of d(v_nu)/dtau and of d(omega_tau)/dtau, a part of d(d(v_nu)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(v_nu)/dtau)/d(omega3) and of d(d(omega_tau)/dtau)/d(omega3), d(d(omega3)/dtau)/d(gamma3)" },
    .divergence = { divergence, 1, { 2, 3, 3, 1, 0, 0, 7, 3 }, { 5, 17, 0, 1, 0, 0, 8, 6 },
        "divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, omega_tau + (m*R*I3)*V/Theta" },
    .integral_values = { integral_values, 3, { 0, 9, 7, 1, 0, 0, 8, 4 }, { 8, 30, 0, 1, 0, 0, 13, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*omega3*(R*I3) + G_level, v_tau/R = gamma3*omega_n + omega3*s, F_linear" },
    .integral_gradients = { integral_gradients, 15, { 0, 15, 10, 1, 0, 0, 7, 8 }, { 13, 52, 0, 7, 0, 0, 10, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*(R*I3)*gamma3 + G_level, d(v_tau)/d(gamma3)/R, v_tau/R = gamma3*((1)/s)*(omega3*(R*I3)*gamma3 + G_level)*(1/(R*I3)) + omega3*s, d(E)/d(gamma3), d(E)/d(omega3), d(v_tau)/d(s)/R, d(E)/d(s), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 2, 1, 1, 0, 0, 4, 2 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in omega3*(R*I3)*gamma3 + G_level" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_baseline,
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_avx2,
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_avx512,
    },
};
