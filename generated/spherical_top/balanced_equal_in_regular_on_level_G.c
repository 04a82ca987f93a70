/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   17    5    1    0    0      9    6   (47)
 *  jacobian            5   34   12    1    0    0     13   10   (180)
 *  rhs_jacobian        8   39   13    1    0    0     13   12   (205)
 *  divergence          1    3    4    1    0    0      7    3   (23)
 *  integral_values     0   10    7    1    0    0      9    5   (39)
 *  integral_gradients  0   20   10    1    0    0      9   10   (72)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    3    1    1    0    0      4    3   (7)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are.
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
    const double t0 = params[1]*params[5]; /* R*I3 */
    const double t1 = 1.0/t0; /* 1/(R*I3) */
    const double t2 = params[5]*params[5]; /* I3*I3 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[5]*t4; /* I3*m*R*R */
    const double t6 = params[1]*params[0]; /* R*m */
    const double t7 = params[5]*t6; /* I3*R*m */
    const double t8 = -t7; /* -I3*R*m */
    const double t9 = params[1]*2.0; /* R*2 */
    const double t10 = -params[1]; /* -R */
    const double t11 = 2.0/t0; /* 2/(R*I3) */
    const double t12 = params[0]*params[0]; /* m*m */
    const double t13 = 2.0*t12; /* 2*m*m */
    const double t14 = params[1]*t3; /* R*R*R */
    const double t15 = t13*t14; /* 2*m*m*R*R*R */
    const double t16 = t2*t15; /* I3*I3*2*m*m*R*R*R */
    const double t17 = -t5; /* -I3*m*R*R */
    const double t18 = params[0]/2.0; /* m/2 */
    const double t19 = params[5]/2.0; /* I3/2 */
    const double t20 = t2*params[0]; /* I3*I3*m */
    const double t21 = 1.0/params[5]; /* 1/I3 */
    const double t22 = 1.0/params[1]; /* 1/R */
    const double t23 = params[0]*2.0; /* m*2 */
    const double t24 = t2*t23; /* I3*I3*m*2 */
    const double t25 = params[1]*t23; /* R*m*2 */
    const double t26 = t2*t25; /* I3*I3*R*m*2 */
    out[7] = t1;
    out[8] = t0;
    out[9] = t2;
    out[10] = t5;
    out[11] = t8;
    out[12] = t9;
    out[13] = t10;
    out[14] = t11;
    out[15] = t7;
    out[16] = t16;
    out[17] = t17;
    out[18] = t18;
    out[19] = t19;
    out[20] = t20;
    out[21] = t21;
    out[22] = t22;
    out[23] = t24;
    out[24] = t26;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t3 = JLT_FMA(x[3], t2, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t4 = x[4]*x[4]; /* s*s */
    const double t5 = JLT_FMA(x[0], x[0], t4); /* gamma3*gamma3 + s*s */
    const double t6 = JLT_FMA(p[10], t5, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t7 = x[4]*t6; /* s*Theta */
    const double t8 = 1.0/t7; /* 1/(s*Theta) */
    const double t9 = p[7]*t3; /* 1/(R*I3)*(omega3*R*I3*gamma3 + G_level) */
    const double t10 = t6*t9; /* Theta*1/(R*I3)*(omega3*R*I3*gamma3 + G_level) */
    const double t11 = t8*t10; /* omega_n = 1/(s*Theta)*Theta*1/(R*I3)*(omega3*R*I3*gamma3 + G_level) */
    const double t12 = x[4]*x[3]; /* s*omega3 */
    const double t13 = JLT_FMA(x[0], t11, t12); /* gamma3*omega_n + s*omega3 */
    const double t14 = t11*t13; /* omega_n*(gamma3*omega_n + s*omega3) */
    const double t15 = p[1]*t14; /* R*omega_n*(gamma3*omega_n + s*omega3) */
    const double t16 = -t14; /* -omega_n*(gamma3*omega_n + s*omega3) */
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t18 = x[4]*p[11]; /* s*(-m*R*I3) */
    const double t19 = x[4]*t18; /* s*s*(-m*R*I3) */
    const double t20 = t17*t19; /* V*s*s*(-m*R*I3) */
    const double t21 = t8*t20; /* 1/(s*Theta)*V*s*s*(-m*R*I3) */
    const double t22 = t11*t21; /* omega_n*1/(s*Theta)*V*s*s*(-m*R*I3) */
    const double t23 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t24 = -t23; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t15;
    out[2] = t16;
    out[3] = t22;
    out[4] = t24;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t4 = JLT_FMA(x[3], t3, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t5 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t6 = JLT_FMA(p[10], t5, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t7 = x[4]*t6; /* s*Theta */
    const double t8 = 1.0/t7; /* 1/(s*Theta) */
    const double t9 = t6*t8; /* Theta*1/(s*Theta) */
    const double t10 = t4*t9; /* (omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta) */
    const double t11 = p[7]*t10; /* 1/(R*I3)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta) */
    const double t12 = t11*t11; /* 1/(R*I3)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta)*1/(R*I3)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta) */
    const double t13 = x[0]*t9; /* gamma3*Theta*1/(s*Theta) */
    const double t14 = t11*t13; /* 1/(R*I3)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) */
    const double t15 = JLT_FMA(x[3], (1.0 / 2.0), t14); /* omega3*1/2 + t14 */
    const double t16 = 2.0*x[3]; /* 2*omega3 */
    const double t17 = JLT_FMA(t15, t16, t12); /* (omega3*1/2 + t14)*2*omega3 + t12 */
    const double t18 = p[1]*t17; /* R*((omega3*1/2 + t14)*2*omega3 + t12) */
    const double t19 = x[0]*t15; /* gamma3*(omega3*1/2 + t14) */
    const double t20 = x[4]*t11; /* s*1/(R*I3)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta) */
    const double t21 = JLT_FMA((1.0 / 2.0), t20, t19); /* 1/2*s*1/(R*I3)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta) + gamma3*(omega3*1/2 + t14) */
    const double t22 = p[12]*t21; /* 2*R*t21 */
    const double t23 = t10*p[14]; /* (omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta)*2/(R*I3) */
    const double t24 = JLT_FMS(t13, t23, x[3]); /* gamma3*Theta*1/(s*Theta)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta)*2/(R*I3) - omega3 */
    const double t25 = t11*t24; /* 1/(R*I3)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta)*t24 */
    const double t26 = JLT_FMA(x[3], t11, t25); /* omega3*1/(R*I3)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta) + t25 */
    const double t27 = p[13]*t26; /* (-R)*t26 */
    const double t28 = -t17; /* -((omega3*1/2 + t14)*2*omega3 + t12) */
    const double t29 = t21*(-2.0); /* t21*(-2) */
    const double t30 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t31 = x[4]*t8; /* s*1/(s*Theta) */
    const double t32 = t30*t31; /* V*s*1/(s*Theta) */
    const double t33 = p[15]*t32; /* m*R*I3*V*s*1/(s*Theta) */
    const double t34 = x[3]*t33; /* omega3*m*R*I3*V*s*1/(s*Theta) */
    const double t35 = t20*t31; /* s*1/(R*I3)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta)*s*1/(s*Theta) */
    const double t36 = t32*p[16]; /* V*s*1/(s*Theta)*2*m^2*R^3*I3^2 */
    const double t37 = t35*t36; /* t35*V*s*1/(s*Theta)*2*m^2*R^3*I3^2 */
    const double t38 = JLT_FMS(x[0], t37, t34); /* gamma3*t35*V*s*1/(s*Theta)*2*m^2*R^3*I3^2 - omega3*m*R*I3*V*s*1/(s*Theta) */
    const double t39 = t35*p[11]; /* t35*(-m*R*I3) */
    const double t40 = t35*p[17]; /* t35*(-m*R^2*I3) */
    const double t41 = x[0]*t33; /* gamma3*m*R*I3*V*s*1/(s*Theta) */
    const double t42 = -t41; /* -gamma3*m*R*I3*V*s*1/(s*Theta) */
    const double t43 = t11*t33; /* 1/(R*I3)*(omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta)*m*R*I3*V*s*1/(s*Theta) */
    const double t44 = t32*p[0]; /* V*s*1/(s*Theta)*m */
    const double t45 = JLT_FMS(t10, t44, t43); /* (omega3*R*I3*gamma3 + G_level)*Theta*1/(s*Theta)*V*s*1/(s*Theta)*m - t43 */
    const double t46 = JLT_FMA(x[4], t37, t45); /* s*t35*V*s*1/(s*Theta)*2*m^2*R^3*I3^2 + t45 */
    const double t47 = -t1; /* -s*omega_tau */
    const double t48 = x[4]*x[0]; /* s*gamma3 */
    const double t49 = -t48; /* -s*gamma3 */
    const double t50 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t51 = -t50; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t18;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t22;
    out[9] = t27;
    out[10] = t28;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t29;
    out[14] = t26;
    out[15] = t38;
    out[16] = t39;
    out[17] = t40;
    out[18] = t42;
    out[19] = t46;
    out[20] = t47;
    out[21] = 0.0;
    out[22] = t49;
    out[23] = 0.0;
    out[24] = t51;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[0]*p[8]; /* gamma3*R*I3 */
    const double t3 = JLT_FMA(x[3], t2, p[6]); /* omega3*gamma3*R*I3 + G_level */
    const double t4 = x[4]*x[4]; /* s*s */
    const double t5 = JLT_FMA(x[0], x[0], t4); /* gamma3*gamma3 + s*s */
    const double t6 = JLT_FMA(p[10], t5, p[9]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t7 = x[4]*t6; /* s*Theta */
    const double t8 = 1.0/t7; /* 1/(s*Theta) */
    const double t9 = t6*t8; /* Theta*1/(s*Theta) */
    const double t10 = t3*t9; /* (omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta) */
    const double t11 = p[7]*t10; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta) */
    const double t12 = t11*t11; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta)*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta) */
    const double t13 = x[0]*t12; /* gamma3*t12 */
    const double t14 = x[4]*t11; /* s*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta) */
    const double t15 = JLT_FMA(x[3], t14, t13); /* omega3*s*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta) + gamma3*t12 */
    const double t16 = p[1]*t15; /* R*t15 */
    const double t17 = -t15; /* -t15 */
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t19 = x[4]*t8; /* s*1/(s*Theta) */
    const double t20 = t18*t19; /* V*s*1/(s*Theta) */
    const double t21 = p[15]*t20; /* m*R*I3*V*s*1/(s*Theta) */
    const double t22 = t14*t21; /* s*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta)*m*R*I3*V*s*1/(s*Theta) */
    const double t23 = -t22; /* -t22 */
    const double t24 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t25 = -t24; /* -s*omega_tau*gamma3 */
    const double t26 = t0*2.0; /* s*omega_tau*2 */
    const double t27 = x[0]*t9; /* gamma3*Theta*1/(s*Theta) */
    const double t28 = t11*t27; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) */
    const double t29 = JLT_FMA(x[3], (1.0 / 2.0), t28); /* omega3*1/2 + t28 */
    const double t30 = x[3]*2.0; /* omega3*2 */
    const double t31 = JLT_FMA(t29, t30, t12); /* (omega3*1/2 + t28)*omega3*2 + t12 */
    const double t32 = p[1]*t31; /* R*((omega3*1/2 + t28)*omega3*2 + t12) */
    const double t33 = x[0]*t29; /* gamma3*(omega3*1/2 + t28) */
    const double t34 = JLT_FMA(t14, (1.0 / 2.0), t33); /* s*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta)*1/2 + gamma3*(omega3*1/2 + t28) */
    const double t35 = p[12]*t34; /* 2*R*t34 */
    const double t36 = t10*p[14]; /* (omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta)*2/(R*I3) */
    const double t37 = JLT_FMS(t27, t36, x[3]); /* gamma3*Theta*1/(s*Theta)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta)*2/(R*I3) - omega3 */
    const double t38 = t11*t37; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta)*t37 */
    const double t39 = JLT_FMA(x[3], t11, t38); /* omega3*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta) + t38 */
    const double t40 = p[13]*t39; /* (-R)*t39 */
    const double t41 = -t31; /* -((omega3*1/2 + t28)*omega3*2 + t12) */
    const double t42 = t34*(-2.0); /* t34*(-2) */
    const double t43 = x[3]*t21; /* omega3*m*R*I3*V*s*1/(s*Theta) */
    const double t44 = t14*t19; /* s*1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta)*s*1/(s*Theta) */
    const double t45 = t20*p[16]; /* V*s*1/(s*Theta)*2*m^2*R^3*I3^2 */
    const double t46 = t44*t45; /* t44*V*s*1/(s*Theta)*2*m^2*R^3*I3^2 */
    const double t47 = JLT_FMS(x[0], t46, t43); /* gamma3*t44*V*s*1/(s*Theta)*2*m^2*R^3*I3^2 - omega3*m*R*I3*V*s*1/(s*Theta) */
    const double t48 = t44*p[11]; /* t44*(-m*R*I3) */
    const double t49 = t44*p[17]; /* t44*(-m*R^2*I3) */
    const double t50 = x[0]*t21; /* gamma3*m*R*I3*V*s*1/(s*Theta) */
    const double t51 = -t50; /* -gamma3*m*R*I3*V*s*1/(s*Theta) */
    const double t52 = t11*t21; /* 1/(R*I3)*(omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta)*m*R*I3*V*s*1/(s*Theta) */
    const double t53 = t20*p[0]; /* V*s*1/(s*Theta)*m */
    const double t54 = JLT_FMS(t10, t53, t52); /* (omega3*gamma3*R*I3 + G_level)*Theta*1/(s*Theta)*V*s*1/(s*Theta)*m - t52 */
    const double t55 = JLT_FMA(x[4], t46, t54); /* s*t44*V*s*1/(s*Theta)*2*m^2*R^3*I3^2 + t54 */
    const double t56 = -t0; /* -s*omega_tau */
    const double t57 = x[4]*x[0]; /* s*gamma3 */
    const double t58 = -t57; /* -s*gamma3 */
    const double t59 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t60 = -t59; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t16;
    out[2] = t17;
    out[3] = t23;
    out[4] = t25;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t4;
    out[8] = 0.0;
    out[9] = t26;
    out[10] = t32;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t35;
    out[14] = t40;
    out[15] = t41;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t42;
    out[19] = t39;
    out[20] = t47;
    out[21] = t48;
    out[22] = t49;
    out[23] = t51;
    out[24] = t55;
    out[25] = t56;
    out[26] = 0.0;
    out[27] = t58;
    out[28] = 0.0;
    out[29] = t60;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = JLT_FMA(x[4], x[4], t0); /* s*s + gamma3*gamma3 */
    const double t2 = JLT_FMA(p[10], t1, p[9]); /* Theta = m*R^2*I3*(s*s + gamma3*gamma3) + I3^2 */
    const double t3 = 1.0/t2; /* 1/Theta */
    const double t4 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t5 = p[15]*t4; /* m*R*I3*V */
    const double t6 = JLT_FMA(t3, t5, x[2]); /* 1/Theta*m*R*I3*V + omega_tau */
    const double t7 = x[0]*t6; /* gamma3*(1/Theta*m*R*I3*V + omega_tau) */
    const double t8 = -t7; /* -gamma3*(1/Theta*m*R*I3*V + omega_tau) */
    out[0] = t8;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[3]*x[4]; /* omega3*s */
    const double t2 = 1.0/x[4]; /* 1/s */
    const double t3 = x[3]*p[8]; /* omega3*R*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[6]); /* gamma3*omega3*R*I3 + G_level */
    const double t5 = p[7]*t4; /* 1/(R*I3)*(gamma3*omega3*R*I3 + G_level) */
    const double t6 = t2*t5; /* omega_n = 1/s*1/(R*I3)*(gamma3*omega3*R*I3 + G_level) */
    const double t7 = JLT_FMA(x[0], t6, t1); /* gamma3*omega_n + omega3*s */
    const double t8 = p[1]*t7; /* v_tau = R*(gamma3*omega_n + omega3*s) */
    const double t9 = JLT_FMA(t8, t8, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t10 = p[18]*t9; /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t11 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t12 = JLT_FMA(x[3], x[3], t11); /* omega3*omega3 + omega_tau*omega_tau */
    const double t13 = JLT_FMA(t6, t6, t12); /* omega_n*omega_n + omega3*omega3 + omega_tau*omega_tau */
    const double t14 = JLT_FMA(p[19], t13, t10); /* energy = 1/2*I3*(omega_n*omega_n + omega3*omega3 + omega_tau*omega_tau) + 1/2*m*(v_tau*v_tau + v_nu*v_nu) */
    const double t15 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t16 = p[20]*t15; /* m*I3^2*(R*omega_tau + v_nu) */
    const double t17 = t15*t16; /* (R*omega_tau + v_nu)*m*I3^2*(R*omega_tau + v_nu) */
    out[0] = t14;
    out[1] = t17;
    out[2] = t15;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[4]; /* 1/s */
    const double t1 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t2 = JLT_FMA(x[3], t1, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t3 = t0*t2; /* 1/s*(omega3*R*I3*gamma3 + G_level) */
    const double t4 = p[7]*t3; /* omega_n = 1/(R*I3)*1/s*(omega3*R*I3*gamma3 + G_level) */
    const double t5 = t0*t4; /* 1/s*omega_n */
    const double t6 = p[5]*x[3]; /* I3*omega3 */
    const double t7 = t5*t6; /* 1/s*omega_n*I3*omega3 */
    const double t8 = t4*p[1]; /* omega_n*R */
    const double t9 = t0*x[0]; /* 1/s*gamma3 */
    const double t10 = x[3]*p[1]; /* omega3*R */
    const double t11 = JLT_FMA(t9, t10, t8); /* d(v_tau)/d(gamma3) = 1/s*gamma3*omega3*R + omega_n*R */
    const double t12 = x[4]*t10; /* s*omega3*R */
    const double t13 = JLT_FMA(x[0], t8, t12); /* v_tau = gamma3*omega_n*R + s*omega3*R */
    const double t14 = p[0]*t13; /* m*v_tau */
    const double t15 = JLT_FMA(t11, t14, t7); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau + 1/s*omega_n*I3*omega3 */
    const double t16 = p[0]*x[1]; /* m*v_nu */
    const double t17 = p[5]*x[2]; /* I3*omega_tau */
    const double t18 = JLT_FMA(t4, t9, x[3]); /* omega_n*1/s*gamma3 + omega3 */
    const double t19 = p[5]*t18; /* I3*(omega_n*1/s*gamma3 + omega3) */
    const double t20 = JLT_FMA(x[0], t9, x[4]); /* gamma3*1/s*gamma3 + s */
    const double t21 = p[1]*t20; /* R*(gamma3*1/s*gamma3 + s) */
    const double t22 = JLT_FMA(t14, t21, t19); /* d(energy)/d(omega3) = m*v_tau*R*(gamma3*1/s*gamma3 + s) + I3*(omega_n*1/s*gamma3 + omega3) */
    const double t23 = t9*p[21]; /* 1/s*gamma3*1/I3 */
    const double t24 = JLT_FNMA(t3, t23, t10); /* d(v_tau)/d(s) = omega3*R - 1/s*(omega3*R*I3*gamma3 + G_level)*1/s*gamma3*1/I3 */
    const double t25 = t14*t24; /* m*v_tau*d(v_tau)/d(s) */
    const double t26 = t3*p[22]; /* 1/s*(omega3*R*I3*gamma3 + G_level)*1/R */
    const double t27 = JLT_FNMA(t5, t26, t25); /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) - 1/s*omega_n*1/s*(omega3*R*I3*gamma3 + G_level)*1/R */
    const double t28 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t29 = p[23]*t28; /* 2*m*I3^2*(R*omega_tau + v_nu) */
    const double t30 = t28*p[24]; /* (R*omega_tau + v_nu)*2*m*R*I3^2 */
    out[0] = t15;
    out[1] = t16;
    out[2] = t17;
    out[3] = t22;
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
    const double t0 = 1.0/x[4]; /* 1/s */
    const double t1 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t2 = JLT_FMA(x[3], t1, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t3 = p[7]*t2; /* 1/(R*I3)*(omega3*R*I3*gamma3 + G_level) */
    const double t4 = t0*t3; /* 1/s*1/(R*I3)*(omega3*R*I3*gamma3 + G_level) */
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
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
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
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t10[k] = p[8]*x0[k];
        t11[k] = jlt_jet_product(x3, t10, k) + (k == 0 ? p[6] : 0);
        t14[k] = jlt_jet_product(x4, x4, k);
        t15[k] = jlt_jet_product(x0, x0, k) + t14[k];
        t16[k] = p[10]*t15[k] + (k == 0 ? p[9] : 0);
        t17[k] = jlt_jet_product(x4, t16, k);
        t19[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t17, t19, k);
        t20[k] = p[7]*t11[k];
        t21[k] = jlt_jet_product(t16, t20, k);
        t22[k] = jlt_jet_product(t19, t21, k);
        t23[k] = jlt_jet_product(x4, x3, k);
        t24[k] = jlt_jet_product(x0, t22, k) + t23[k];
        t25[k] = jlt_jet_product(t22, t24, k);
        t26[k] = p[1]*t25[k];
        t27[k] = -t25[k];
        t30[k] = x2[k]*p[1] + x1[k];
        t31[k] = x4[k]*p[11];
        t32[k] = jlt_jet_product(x4, t31, k);
        t33[k] = jlt_jet_product(t30, t32, k);
        t34[k] = jlt_jet_product(t19, t33, k);
        t35[k] = jlt_jet_product(t22, t34, k);
        t36[k] = jlt_jet_product(t2, x0, k);
        t37[k] = -t36[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t26[k]/(k + 1);
        next[2] = x2[k + 1] = t27[k]/(k + 1);
        next[3] = x3[k + 1] = t35[k]/(k + 1);
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
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 25,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 17, 5, 1, 0, 0, 9, 6 }, { 9, 36, 0, 2, 0, 0, 10, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are" },
    .jacobian = { jacobian, 25, { 5, 34, 12, 1, 0, 0, 13, 10 }, { 32, 131, 0, 17, 0, 0, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 8, 39, 13, 1, 0, 0, 13, 12 }, { 37, 150, 0, 18, 0, 0, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are" },
    .divergence = { divergence, 1, { 1, 3, 4, 1, 0, 0, 7, 3 }, { 5, 17, 0, 1, 0, 0, 8, 6 },
        "divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are" },
    .integral_values = { integral_values, 3, { 0, 10, 7, 1, 0, 0, 9, 5 }, { 8, 30, 0, 1, 0, 0, 13, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 15, { 0, 20, 10, 1, 0, 0, 9, 10 }, { 13, 52, 0, 7, 0, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 3, 1, 1, 0, 0, 4, 3 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
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
