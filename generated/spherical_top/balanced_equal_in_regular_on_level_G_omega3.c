/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   17    7    1    0    0      9    6   (63)
 *  jacobian            5   35   14    1    0    0     12   13   (278)
 *  rhs_jacobian        5   39   18    1    0    0     15   10   (319)
 *  divergence          0    9    4    1    0    0      7    5   (36)
 *  integral_values     0    9    7    1    0    0      9    4   (39)
 *  integral_gradients  0   15   10    1    0    0      9    7   (72)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    2    1    1    0    0      4    2   (7)
 *
 *  Accuracy
 *    divides by gamma3: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are
 *    digits are lost where terms nearly cancel in G_level - (R*I3)*s*omega_n,
 *      (1/(R*I3))*1/gamma3*(G_level - (R*I3)*s*omega_n) - 1/gamma3*s*omega_n, V = omega_tau*R + v_nu,
 *      a part of d(omega_n)/dtau and of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s),
 *      a part of d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_tau), d(omega_n)/dtau,
 *      (1/(R*I3))*s*1/gamma3*(G_level - (R*I3)*s*omega_n) - omega_n*gamma3,
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = 1/gamma3*(I3^2 + m*R^2*I3)*s*s*omega_tau - gamma3*(m*R*I3)*V,
 *      d(numerator of d(omega_n)/dt over Theta)/d(gamma3),
 *      (1/(R*I3))*1/gamma3*s*1/gamma3*(G_level - (R*I3)*s*omega_n) + omega_n, a part of d(d(omega_n)/dtau)/d(gamma3),
 *      a part of d(d(omega_n)/dtau)/d(s), d(d(omega_tau)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(gamma3),
 *      d(d(omega_n)/dtau)/d(omega_n)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
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
    const double t0 = -params[1]; /* -R */
    out[7] = t0;
    const double t1 = params[1]*params[5]; /* R*I3 */
    out[9] = t1;
    const double t2 = 1.0/t1; /* 1/(R*I3) */
    out[8] = t2;
    const double t3 = params[5]*params[5]; /* I3*I3 */
    out[10] = t3;
    const double t4 = params[1]*params[1]; /* R*R */
    out[22] = t4;
    const double t5 = params[0]*t4; /* m*R*R */
    out[24] = t5;
    const double t6 = params[5]*t5; /* I3*m*R*R */
    out[11] = t6;
    const double t7 = params[1]*params[0]; /* R*m */
    const double t8 = params[5]*t7; /* I3*R*m */
    out[12] = t8;
    const double t9 = t3 + t6; /* I3*I3 + I3*m*R*R */
    out[13] = t9;
    const double t10 = params[0]*params[0]; /* m*m */
    const double t11 = 2.0*t10; /* 2*m*m */
    const double t12 = params[1]*t4; /* R*R*R */
    const double t13 = t11*t12; /* 2*m*m*R*R*R */
    const double t14 = t3*t13; /* I3*I3*2*m*m*R*R*R */
    out[14] = t14;
    const double t15 = params[5]*t3; /* I3*I3*I3 */
    const double t16 = t5*t15; /* m*R*R*I3*I3*I3 */
    const double t17 = t4*t4; /* R*R*R*R */
    const double t18 = t10*t17; /* m*m*R*R*R*R */
    const double t19 = t3*t18; /* I3*I3*m*m*R*R*R*R */
    const double t20 = t16 + t19; /* m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R */
    const double t21 = 2.0*t20; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R) */
    const double t22 = t21/t1; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R)/(R*I3) */
    out[15] = t22;
    const double t23 = params[5]/params[1]; /* I3/R */
    const double t24 = t7 + t23; /* R*m + I3/R */
    out[16] = t24;
    const double t25 = -t8; /* -I3*R*m */
    out[17] = t25;
    const double t26 = t9/t1; /* (I3*I3 + I3*m*R*R)/(R*I3) */
    out[18] = t26;
    const double t27 = params[0]*2.0; /* m*2 */
    const double t28 = t4*t27; /* R*R*m*2 */
    const double t29 = params[5]*t28; /* I3*R*R*m*2 */
    out[19] = t29;
    const double t30 = params[0]/2.0; /* m/2 */
    out[20] = t30;
    const double t31 = params[5]/params[0]; /* I3/m */
    out[21] = t31;
    const double t32 = t3*params[0]; /* I3*I3*m */
    out[23] = t32;
    const double t33 = 1.0/params[1]; /* 1/R */
    out[25] = t33;
    const double t34 = t3*t27; /* I3*I3*m*2 */
    out[26] = t34;
    const double t35 = params[1]*t27; /* R*m*2 */
    const double t36 = t3*t35; /* I3*I3*R*m*2 */
    out[27] = t36;
    const double t37 = (-1.0)/t1; /* (-1)/(R*I3) */
    out[28] = t37;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = x[4]*x[3]; /* s*omega_n */
    const double t3 = JLT_FNMA(p[9], t2, p[6]); /* G_level - R*I3*s*omega_n */
    const double t4 = x[4]*x[4]; /* s*s */
    const double t5 = JLT_FMA(x[0], x[0], t4); /* gamma3*gamma3 + s*s */
    const double t6 = JLT_FMA(p[11], t5, p[10]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t7 = x[0]*t6; /* gamma3*Theta */
    const double t8 = 1.0/t7; /* 1/(gamma3*Theta) */
    const double t9 = p[8]*t3; /* 1/(R*I3)*(G_level - R*I3*s*omega_n) */
    const double t10 = t6*t9; /* Theta*1/(R*I3)*(G_level - R*I3*s*omega_n) */
    const double t11 = t8*t10; /* 1/(gamma3*Theta)*Theta*1/(R*I3)*(G_level - R*I3*s*omega_n) */
    const double t12 = t2*t11; /* s*omega_n*1/(gamma3*Theta)*Theta*1/(R*I3)*(G_level - R*I3*s*omega_n) */
    const double t13 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t14 = JLT_FNMA(x[3], t13, t12); /* t12 - omega_n*omega_n*gamma3 */
    out[2] = t14;
    const double t15 = p[7]*t14; /* (-R)*(t12 - omega_n*omega_n*gamma3) */
    out[1] = t15;
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = x[0]*t8; /* 1/Theta = gamma3*1/(gamma3*Theta) */
    const double t18 = p[12]*t16; /* m*R*I3*V */
    const double t19 = JLT_FNMA(t17, t18, x[2]); /* omega_tau - 1/Theta*m*R*I3*V */
    const double t20 = t13*t19; /* omega_n*gamma3*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t21 = t0*p[13]; /* s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t22 = t11*t21; /* 1/(gamma3*Theta)*Theta*1/(R*I3)*(G_level - R*I3*s*omega_n)*s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t23 = JLT_FNMA(t17, t22, t20); /* omega_n*gamma3*(omega_tau - 1/Theta*m*R*I3*V) - 1/Theta*t22 */
    out[3] = t23;
    const double t24 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t25 = -t24; /* -s*omega_tau*gamma3 */
    out[4] = t25;
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
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[4] = t2;
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = x[4]*x[3]; /* s*omega_n */
    const double t5 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t6 = JLT_FMA(p[11], t5, p[10]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t7 = x[0]*t6; /* gamma3*Theta */
    const double t8 = 1.0/t7; /* 1/(gamma3*Theta) */
    const double t9 = t6*t8; /* 1/gamma3 = Theta*1/(gamma3*Theta) */
    const double t10 = t4*t9; /* s*omega_n*1/gamma3 */
    const double t11 = JLT_FNMA(t4, p[9], p[6]); /* G_level - s*omega_n*R*I3 */
    const double t12 = p[8]*t11; /* 1/(R*I3)*(G_level - s*omega_n*R*I3) */
    const double t13 = t9*t12; /* 1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I3) */
    const double t14 = JLT_FMA(t10, t13, t3); /* s*omega_n*1/gamma3*1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I3) + omega_n*omega_n */
    const double t15 = p[1]*t14; /* R*t14 */
    out[5] = t15;
    const double t16 = t13 - t10; /* 1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I3) - s*omega_n*1/gamma3 */
    const double t17 = x[4]*t16; /* s*t16 */
    const double t18 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t19 = JLT_FNMA(2.0, t18, t17); /* s*t16 - 2*omega_n*gamma3 */
    out[13] = t19;
    const double t20 = p[7]*t19; /* (-R)*(s*t16 - 2*omega_n*gamma3) */
    out[8] = t20;
    const double t21 = x[3]*t16; /* omega_n*t16 */
    out[14] = t21;
    const double t22 = p[7]*t21; /* (-R)*omega_n*t16 */
    out[9] = t22;
    const double t23 = -t14; /* -t14 */
    out[10] = t23;
    const double t24 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t25 = x[0]*t8; /* 1/Theta = gamma3*1/(gamma3*Theta) */
    const double t26 = p[12]*t24; /* m*R*I3*V */
    const double t27 = JLT_FNMA(t25, t26, x[2]); /* omega_tau - 1/Theta*m*R*I3*V */
    const double t28 = x[3]*t27; /* omega_n*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t29 = t18*t25; /* omega_n*gamma3*1/Theta */
    const double t30 = t24*p[14]; /* V*2*m^2*R^3*I3^2 */
    const double t31 = t29*t30; /* omega_n*gamma3*1/Theta*V*2*m^2*R^3*I3^2 */
    const double t32 = t1*t9; /* s*omega_tau*1/gamma3 */
    const double t33 = t11*t25; /* (G_level - s*omega_n*R*I3)*1/Theta */
    const double t34 = t32*t33; /* s*omega_tau*1/gamma3*(G_level - s*omega_n*R*I3)*1/Theta */
    const double t35 = JLT_FMA(p[15], t34, t31); /* 2*(m*R^2*I3^3 + m^2*R^4*I3^2)/(R*I3)*s*omega_tau*1/gamma3*(G_level - s*omega_n*R*I3)*1/Theta + omega_n*gamma3*1/Theta*V*2*m^2*R^3*I3^2 */
    const double t36 = t25*t35; /* 1/Theta*t35 */
    const double t37 = t9*p[16]; /* 1/gamma3*(m*R + I3/R) */
    const double t38 = JLT_FMA(t34, t37, t28); /* s*omega_tau*1/gamma3*(G_level - s*omega_n*R*I3)*1/Theta*1/gamma3*(m*R + I3/R) + omega_n*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t39 = JLT_FMA(x[0], t36, t38); /* gamma3*1/Theta*t35 + t38 */
    out[15] = t39;
    const double t40 = t29*p[17]; /* omega_n*gamma3*1/Theta*(-m*R*I3) */
    out[16] = t40;
    const double t41 = t25*p[13]; /* 1/Theta*(I3^2 + m*R^2*I3) */
    const double t42 = x[4]*t41; /* s*1/Theta*(I3^2 + m*R^2*I3) */
    const double t43 = JLT_FNMA(p[11], t29, t18); /* omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*1/Theta */
    const double t44 = JLT_FNMA(t13, t42, t43); /* omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*1/Theta - 1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I3)*s*1/Theta*(I3^2 + m*R^2*I3) */
    out[17] = t44;
    const double t45 = x[0]*t27; /* gamma3*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t46 = JLT_FMA(t32, t42, t45); /* s*omega_tau*1/gamma3*s*1/Theta*(I3^2 + m*R^2*I3) + gamma3*(omega_tau - 1/Theta*m*R*I3*V) */
    out[18] = t46;
    const double t47 = x[4]*t36; /* s*1/Theta*t35 */
    const double t48 = x[2]*t41; /* omega_tau*1/Theta*(I3^2 + m*R^2*I3) */
    const double t49 = JLT_FNMA(t16, t48, t47); /* s*1/Theta*t35 - t16*omega_tau*1/Theta*(I3^2 + m*R^2*I3) */
    out[19] = t49;
    const double t50 = -t1; /* -s*omega_tau */
    out[20] = t50;
    const double t51 = x[4]*x[0]; /* s*gamma3 */
    const double t52 = -t51; /* -s*gamma3 */
    out[22] = t52;
    const double t53 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t54 = -t53; /* -omega_tau*gamma3 */
    out[24] = t54;
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
    const double t3 = x[0]*t2; /* gamma3*Theta */
    const double t4 = 1.0/t3; /* 1/(gamma3*Theta) */
    const double t5 = t2*t4; /* 1/gamma3 = Theta*1/(gamma3*Theta) */
    const double t6 = x[0]*t4; /* 1/Theta = gamma3*1/(gamma3*Theta) */
    const double t7 = x[4]*x[3]; /* s*omega_n */
    const double t8 = JLT_FNMA(p[9], t7, p[6]); /* G_level - R*I3*s*omega_n */
    const double t9 = t5*t8; /* 1/gamma3*(G_level - R*I3*s*omega_n) */
    const double t10 = x[4]*t9; /* s*1/gamma3*(G_level - R*I3*s*omega_n) */
    const double t11 = p[8]*t9; /* 1/(R*I3)*1/gamma3*(G_level - R*I3*s*omega_n) */
    const double t12 = JLT_FNMA(t5, t7, t11); /* 1/(R*I3)*1/gamma3*(G_level - R*I3*s*omega_n) - 1/gamma3*s*omega_n */
    const double t13 = p[18]*t10; /* (I3^2 + m*R^2*I3)/(R*I3)*s*1/gamma3*(G_level - R*I3*s*omega_n) */
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t15 = p[12]*t14; /* m*R*I3*V */
    const double t16 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t17 = x[2]*t13; /* omega_tau*t13 */
    const double t18 = JLT_FMA(t15, t16, t17); /* m*R*I3*V*omega_n*gamma3 + omega_tau*t13 */
    const double t19 = t6*t18; /* 1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t13) */
    const double t20 = JLT_FMA(p[11], t16, t13); /* m*R^2*I3*omega_n*gamma3 + t13 */
    const double t21 = JLT_FNMA(t6, t20, t16); /* omega_n*gamma3 - 1/Theta*(m*R^2*I3*omega_n*gamma3 + t13) */
    out[22] = t21;
    const double t22 = JLT_FMS(x[2], t16, t19); /* omega_tau*omega_n*gamma3 - 1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t13) */
    out[3] = t22;
    const double t23 = p[19]*t19; /* 2*m*R^2*I3*1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t13) */
    const double t24 = x[4]*x[2]; /* s*omega_tau */
    const double t25 = 2.0*t24; /* 2*s*omega_tau */
    out[9] = t25;
    const double t26 = -t24; /* -s*omega_tau */
    out[25] = t26;
    const double t27 = x[4]*t24; /* s*s*omega_tau */
    out[0] = t27;
    const double t28 = p[13]*t27; /* (I3^2 + m*R^2*I3)*s*s*omega_tau */
    const double t29 = x[0]*t24; /* gamma3*s*omega_tau */
    const double t30 = -t29; /* -gamma3*s*omega_tau */
    out[4] = t30;
    const double t31 = t5*t10; /* 1/gamma3*s*1/gamma3*(G_level - R*I3*s*omega_n) */
    const double t32 = JLT_FMS(p[8], t10, t16); /* 1/(R*I3)*s*1/gamma3*(G_level - R*I3*s*omega_n) - omega_n*gamma3 */
    const double t33 = x[3]*t32; /* omega_n*t32 */
    out[2] = t33;
    const double t34 = p[7]*t33; /* (-R)*omega_n*t32 */
    out[1] = t34;
    const double t35 = x[3]*t15; /* omega_n*m*R*I3*V */
    const double t36 = x[0]*t15; /* gamma3*m*R*I3*V */
    const double t37 = JLT_FMS(t5, t28, t36); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = 1/gamma3*(I3^2 + m*R^2*I3)*s*s*omega_tau - gamma3*m*R*I3*V */
    const double t38 = x[2]*p[16]; /* omega_tau*(m*R + I3/R) */
    const double t39 = JLT_FMS(t31, t38, t35); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = 1/gamma3*s*1/gamma3*(G_level - R*I3*s*omega_n)*omega_tau*(m*R + I3/R) - omega_n*m*R*I3*V */
    const double t40 = JLT_FMA(p[8], t31, x[3]); /* 1/(R*I3)*1/gamma3*s*1/gamma3*(G_level - R*I3*s*omega_n) + omega_n */
    const double t41 = x[3]*t40; /* omega_n*t40 */
    const double t42 = JLT_FMA(x[0], t23, t39); /* gamma3*2*m*R^2*I3*1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t13) + d(numerator of d(omega_n)/dt over Theta)/d(gamma3) */
    const double t43 = p[1]*t41; /* R*omega_n*t40 */
    out[10] = t43;
    const double t44 = -t41; /* -omega_n*t40 */
    out[15] = t44;
    const double t45 = x[2]*p[13]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t46 = t12*t45; /* t12*omega_tau*(I3^2 + m*R^2*I3) */
    const double t47 = JLT_FMS(x[4], t23, t46); /* s*2*m*R^2*I3*1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t13) - t12*omega_tau*(I3^2 + m*R^2*I3) */
    const double t48 = t6*t47; /* 1/Theta*t47 */
    out[24] = t48;
    const double t49 = x[4]*t12; /* s*t12 */
    const double t50 = JLT_FNMA(2.0, t16, t49); /* s*t12 - 2*omega_n*gamma3 */
    out[18] = t50;
    const double t51 = p[7]*t50; /* (-R)*(s*t12 - 2*omega_n*gamma3) */
    out[13] = t51;
    const double t52 = x[3]*t12; /* omega_n*t12 */
    out[19] = t52;
    const double t53 = p[7]*t52; /* (-R)*omega_n*t12 */
    out[14] = t53;
    const double t54 = p[17]*t16; /* (-m*R*I3)*omega_n*gamma3 */
    const double t55 = t6*t54; /* 1/Theta*(-m*R*I3)*omega_n*gamma3 */
    out[21] = t55;
    const double t56 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t57 = JLT_FMA(t6, t42, t56); /* 1/Theta*t42 + omega_tau*omega_n */
    out[20] = t57;
    const double t58 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t59 = JLT_FMA(t6, t37, t58); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_n) + omega_tau*gamma3 */
    out[23] = t59;
    const double t60 = -t58; /* -omega_tau*gamma3 */
    out[29] = t60;
    const double t61 = x[4]*x[0]; /* s*gamma3 */
    const double t62 = -t61; /* -s*gamma3 */
    out[27] = t62;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t2 = JLT_FMA(p[11], t1, p[10]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t3 = x[0]*t2; /* gamma3*Theta */
    const double t4 = 1.0/t3; /* 1/(gamma3*Theta) */
    const double t5 = x[2]*p[13]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t6 = t0*t5; /* s*s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t7 = t2*t6; /* Theta*s*s*omega_tau*(I3^2 + m*R^2*I3) */
    const double t8 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t9 = x[0]*p[12]; /* gamma3*m*R*I3 */
    const double t10 = t8*t9; /* V*gamma3*m*R*I3 */
    const double t11 = JLT_FMS(t4, t7, t10); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = 1/(gamma3*Theta)*Theta*s*s*omega_tau*(I3^2 + m*R^2*I3) - V*gamma3*m*R*I3 */
    const double t12 = x[0]*t4; /* gamma3*1/(gamma3*Theta) */
    const double t13 = t11*t12; /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n)*gamma3*1/(gamma3*Theta) */
    out[0] = t13;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[9]*x[3]; /* R*I3*omega_n */
    const double t1 = JLT_FNMA(x[4], t0, p[6]); /* G_level - s*R*I3*omega_n */
    const double t2 = p[8]*t1; /* 1/(R*I3)*(G_level - s*R*I3*omega_n) */
    const double t3 = t2/x[0]; /* 1/(R*I3)*(G_level - s*R*I3*omega_n)/gamma3 */
    const double t4 = x[3]*x[3]; /* omega_n*omega_n */
    const double t5 = JLT_FMA(x[2], x[2], t4); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t6 = JLT_FMA(t3, t3, t5); /* 1/(R*I3)*(G_level - s*R*I3*omega_n)/gamma3*1/(R*I3)*(G_level - s*R*I3*omega_n)/gamma3 + omega_tau*omega_tau + omega_n*omega_n */
    const double t7 = x[4]*t3; /* s*1/(R*I3)*(G_level - s*R*I3*omega_n)/gamma3 */
    const double t8 = JLT_FMS(x[0], x[3], t7); /* v_tau/R = gamma3*omega_n - s*1/(R*I3)*(G_level - s*R*I3*omega_n)/gamma3 */
    const double t9 = x[1]*x[1]; /* v_nu*v_nu */
    const double t10 = JLT_FMA(p[21], t6, t9); /* I3/m*t6 + v_nu*v_nu */
    const double t11 = p[22]*t8; /* R^2*v_tau/R */
    const double t12 = JLT_FMA(t8, t11, t10); /* energy/(1/2*m) = v_tau/R*R^2*v_tau/R + I3/m*t6 + v_nu*v_nu */
    const double t13 = p[20]*t12; /* 1/2*m*energy/(1/2*m) */
    out[0] = t13;
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[2] = t14;
    const double t15 = p[23]*t14; /* m*I3^2*(omega_tau*R + v_nu) */
    const double t16 = t14*t15; /* (omega_tau*R + v_nu)*m*I3^2*(omega_tau*R + v_nu) */
    out[1] = t16;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[11] = 1.0;
    out[5] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[12] = p[1];
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = p[5]*x[2]; /* I3*omega_tau */
    out[2] = t1;
    const double t2 = x[3]*p[9]; /* omega_n*R*I3 */
    const double t3 = JLT_FNMA(x[4], t2, p[6]); /* G_level - s*omega_n*R*I3 */
    const double t4 = 1.0/x[0]; /* 1/gamma3 */
    const double t5 = t3*t4; /* (G_level - s*omega_n*R*I3)*1/gamma3 */
    const double t6 = p[8]*t5; /* 1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3 */
    const double t7 = p[25]*t5; /* 1/R*(G_level - s*omega_n*R*I3)*1/gamma3 */
    const double t8 = x[4]*t6; /* s*1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3 */
    const double t9 = JLT_FMS(x[3], x[0], t8); /* v_tau/R = omega_n*gamma3 - s*1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3 */
    const double t10 = p[24]*t9; /* m*R^2*v_tau/R */
    const double t11 = x[4]*t4; /* s*1/gamma3 */
    const double t12 = t4*t6; /* 1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3 */
    const double t13 = JLT_FMA(t6, t11, x[3]); /* d(v_tau)/d(gamma3)/R = 1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3*s*1/gamma3 + omega_n */
    const double t14 = JLT_FMS(x[3], t11, t6); /* d(v_tau)/d(s)/R = omega_n*s*1/gamma3 - 1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3 */
    const double t15 = t10*t13; /* m*R^2*v_tau/R*d(v_tau)/d(gamma3)/R */
    const double t16 = JLT_FNMA(t7, t12, t15); /* d(energy)/d(gamma3) = m*R^2*v_tau/R*d(v_tau)/d(gamma3)/R - 1/R*(G_level - s*omega_n*R*I3)*1/gamma3*1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3 */
    out[0] = t16;
    const double t17 = t10*t14; /* m*R^2*v_tau/R*d(v_tau)/d(s)/R */
    const double t18 = x[3]*p[5]; /* omega_n*I3 */
    const double t19 = JLT_FNMA(t12, t18, t17); /* d(energy)/d(s) = m*R^2*v_tau/R*d(v_tau)/d(s)/R - 1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3*omega_n*I3 */
    out[4] = t19;
    const double t20 = JLT_FNMA(t7, t11, t18); /* omega_n*I3 - 1/R*(G_level - s*omega_n*R*I3)*1/gamma3*s*1/gamma3 */
    const double t21 = JLT_FMA(x[4], t11, x[0]); /* d(v_tau)/d(omega_n)/R = s*s*1/gamma3 + gamma3 */
    const double t22 = JLT_FMA(t10, t21, t20); /* d(energy)/d(omega_n) = m*R^2*v_tau/R*d(v_tau)/d(omega_n)/R + t20 */
    out[3] = t22;
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t24 = p[26]*t23; /* 2*m*I3^2*(omega_tau*R + v_nu) */
    out[6] = t24;
    const double t25 = p[27]*t23; /* 2*m*R*I3^2*(omega_tau*R + v_nu) */
    out[7] = t25;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[9]*x[3]; /* R*I3*omega_n */
    const double t1 = JLT_FNMA(x[4], t0, p[6]); /* G_level - s*R*I3*omega_n */
    const double t2 = p[28]*t1; /* (-1/(R*I3))*(G_level - s*R*I3*omega_n) */
    const double t3 = t2/x[0]; /* (-1/(R*I3))*(G_level - s*R*I3*omega_n)/gamma3 */
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
    double t15[JLT_JET_ORDER_MAX + 1];
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
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
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
        t15[k] = jlt_jet_product(x4, x4, k);
        t16[k] = jlt_jet_product(x0, x0, k) + t15[k];
        t17[k] = p[11]*t16[k] + (k == 0 ? p[10] : 0);
        t18[k] = jlt_jet_product(x0, t17, k);
        t19[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t18, t19, k);
        t20[k] = jlt_jet_product(x4, x3, k);
        t21[k] = (k == 0 ? p[6] : 0) - p[9]*t20[k];
        t22[k] = p[8]*t21[k];
        t23[k] = jlt_jet_product(t17, t22, k);
        t24[k] = jlt_jet_product(t19, t23, k);
        t25[k] = jlt_jet_product(t20, t24, k);
        t26[k] = jlt_jet_product(x0, t19, k);
        t27[k] = jlt_jet_product(x4, x2, k);
        t28[k] = jlt_jet_product(x4, t27, k);
        t29[k] = jlt_jet_product(x3, x0, k);
        t30[k] = t25[k] - jlt_jet_product(x3, t29, k);
        t31[k] = p[7]*t30[k];
        t32[k] = p[13]*t27[k];
        t33[k] = jlt_jet_product(t24, t32, k);
        t34[k] = jlt_jet_product(x0, t27, k);
        t35[k] = -t34[k];
        t36[k] = x2[k]*p[1] + x1[k];
        t37[k] = p[12]*t29[k];
        t38[k] = jlt_jet_product(t36, t37, k) + t33[k];
        t39[k] = jlt_jet_product(x2, t29, k);
        t40[k] = t39[k] - jlt_jet_product(t26, t38, k);
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t28[k]/(k + 1);
        next[1] = x1[k + 1] = t31[k]/(k + 1);
        next[2] = x2[k + 1] = t30[k]/(k + 1);
        next[3] = x3[k + 1] = t40[k]/(k + 1);
        next[4] = x4[k + 1] = t35[k]/(k + 1);
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
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 29,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 1, 17, 7, 1, 0, 0, 9, 6 }, { 11, 48, 0, 4, 0, 0, 11, 7 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in G_level - (R*I3)*s*omega_n, d(omega_tau)/dtau, V = omega_tau*R + v_nu, omega_tau - 1/Theta*(m*R*I3)*V, d(omega_n)/dtau" },
    .jacobian = { jacobian, 25, { 5, 35, 14, 1, 0, 0, 12, 13 }, { 41, 210, 0, 27, 0, 0, 14, 8 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in G_level - s*omega_n*(R*I3), a part of d(d(v_nu)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(gamma3), 1/gamma3*(1/(R*I3))*(G_level - s*omega_n*(R*I3)) - s*omega_n*1/gamma3, d(d(omega_tau)/dtau)/d(omega_n), V = omega_tau*R + v_nu, omega_tau - 1/Theta*(m*R*I3)*V, a part of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 5, 39, 18, 1, 0, 0, 15, 10 }, { 48, 241, 0, 30, 0, 0, 14, 8 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in G_level - (R*I3)*s*omega_n, (1/(R*I3))*1/gamma3*(G_level - (R*I3)*s*omega_n) - 1/gamma3*s*omega_n, V = omega_tau*R + v_nu, a part of d(omega_n)/dtau and of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s), a part of d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_tau), d(omega_n)/dtau, (1/(R*I3))*s*1/gamma3*(G_level - (R*I3)*s*omega_n) - omega_n*gamma3, d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = 1/gamma3*(I3^2 + m*R^2*I3)*s*s*omega_tau - gamma3*(m*R*I3)*V, d(numerator of d(omega_n)/dt over Theta)/d(gamma3), (1/(R*I3))*1/gamma3*s*1/gamma3*(G_level - (R*I3)*s*omega_n) + omega_n, a part of d(d(omega_n)/dtau)/d(gamma3), a part of d(d(omega_n)/dtau)/d(s), d(d(omega_tau)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n)" },
    .divergence = { divergence, 1, { 0, 9, 4, 1, 0, 0, 7, 5 }, { 5, 28, 0, 3, 0, 0, 10, 5 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in V = R*omega_tau + v_nu, d(numerator of d(omega_n)/dt over Theta)/d(omega_n)" },
    .integral_values = { integral_values, 3, { 0, 9, 7, 1, 0, 0, 9, 4 }, { 8, 30, 0, 1, 0, 0, 14, 4 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level - s*(R*I3)*omega_n, v_tau/R = gamma3*omega_n - s*((1/(R*I3))*(G_level - s*(R*I3)*omega_n)/gamma3), F_linear" },
    .integral_gradients = { integral_gradients, 15, { 0, 15, 10, 1, 0, 0, 9, 7 }, { 13, 52, 0, 7, 0, 0, 12, 7 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level - s*omega_n*(R*I3), v_tau/R = omega_n*gamma3 - s*(1/(R*I3))*(G_level - s*omega_n*(R*I3))*((1)/gamma3), d(v_tau)/d(gamma3)/R, d(v_tau)/d(s)/R, d(E)/d(gamma3), d(E)/d(s), d(E)/d(omega_n), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 2, 1, 1, 0, 0, 4, 2 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level - s*(R*I3)*omega_n" },
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
