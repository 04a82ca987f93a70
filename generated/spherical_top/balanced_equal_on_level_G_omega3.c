/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   18    5    1    1    0     10    5   (62)
 *  jacobian            5   28    9    1    1    0     11   10   (171)
 *  rhs_jacobian        6   32   10    1    1    0     12   11   (208)
 *  divergence          2   11    2    1    1    0      9    6   (38)
 *  integral_values     2   10    7    1    1    0     10    4   (42)
 *  integral_gradients  2   18    9    1    1    0     13    8   (66)
 *  eliminated          2    3    1    1    1    0      5    3   (10)
 *
 *  Accuracy
 *    divides by gamma3: values and rounding errors grow without bound where it vanishes
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in G_level - (R*I3)*omega_n*s, V = omega_tau*R + v_nu,
 *      omega_tau - 1/Theta*(m*R*I3)*V, d(d(omega_tau)/dt)/d(omega_n), d(omega3)/d(gamma3),
 *      a part of d(v_nu)/dt and of d(omega_tau)/dt, 1/s^2*1/s^2*omega_n*s + d(omega3)/d(gamma3),
 *      d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), d(omega_n)/dt, d(d(omega_n)/dt)/d(omega_tau)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
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
    const double t0 = -params[1]; /* -R */
    out[7] = t0;
    const double t1 = params[1]*params[5]; /* R*I3 */
    out[10] = t1;
    const double t2 = 1.0/t1; /* 1/(R*I3) */
    out[8] = t2;
    const double t3 = params[5]*params[5]; /* I3*I3 */
    out[14] = t3;
    const double t4 = params[1]*params[1]; /* R*R */
    out[19] = t4;
    const double t5 = params[0]*t4; /* m*R*R */
    out[22] = t5;
    const double t6 = params[5]*t5; /* I3*m*R*R */
    const double t7 = t3 + t6; /* I3*I3 + I3*m*R*R */
    out[9] = t7;
    const double t8 = t7/t1; /* (I3*I3 + I3*m*R*R)/(R*I3) */
    out[11] = t8;
    const double t9 = params[1]*params[0]; /* R*m */
    const double t10 = params[5]*t9; /* I3*R*m */
    out[12] = t10;
    const double t11 = -t10; /* -I3*R*m */
    out[13] = t11;
    const double t12 = t7*t10; /* (I3*I3 + I3*m*R*R)*I3*R*m */
    out[15] = t12;
    const double t13 = t7*t7; /* (I3*I3 + I3*m*R*R)*(I3*I3 + I3*m*R*R) */
    out[16] = t13;
    const double t14 = params[0]/2.0; /* m/2 */
    out[17] = t14;
    const double t15 = params[5]/params[0]; /* I3/m */
    out[18] = t15;
    const double t16 = t3*params[0]; /* I3*I3*m */
    out[20] = t16;
    const double t17 = 1.0/params[1]; /* 1/R */
    out[21] = t17;
    const double t18 = params[0]*2.0; /* m*2 */
    const double t19 = t3*t18; /* I3*I3*m*2 */
    out[23] = t19;
    const double t20 = params[1]*t18; /* R*m*2 */
    const double t21 = t3*t20; /* I3*I3*R*m*2 */
    out[24] = t21;
    const double t22 = (-1.0)/t1; /* (-1)/(R*I3) */
    out[25] = t22;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[9]; /* gamma3*(I3^2 + m*R^2*I3) */
    const double t4 = t2*t3; /* s^2*gamma3*(I3^2 + m*R^2*I3) */
    const double t5 = 1.0/t4; /* 1/(s^2*gamma3*(I3^2 + m*R^2*I3)) */
    const double t6 = x[0]*t3; /* gamma3*gamma3*(I3^2 + m*R^2*I3) */
    const double t7 = t5*t6; /* 1/(s^2*gamma3*(I3^2 + m*R^2*I3))*gamma3*gamma3*(I3^2 + m*R^2*I3) */
    const double t8 = t2*t5; /* 1/(gamma3*Theta) = s^2*1/(s^2*gamma3*(I3^2 + m*R^2*I3)) */
    const double t9 = sqrt(t2); /* s = sqrt(s^2) */
    const double t10 = x[2]*t9; /* omega_tau*s */
    out[0] = t10;
    const double t11 = x[3]*t9; /* omega_n*s */
    const double t12 = t7*t11; /* t7*omega_n*s */
    const double t13 = JLT_FNMA(p[10], t11, p[6]); /* G_level - R*I3*omega_n*s */
    const double t14 = p[9]*t8; /* (I3^2 + m*R^2*I3)*1/(gamma3*Theta) */
    const double t15 = t13*t14; /* (G_level - R*I3*omega_n*s)*(I3^2 + m*R^2*I3)*1/(gamma3*Theta) */
    const double t16 = x[0]*t8; /* gamma3*1/(gamma3*Theta) */
    const double t17 = x[2]*p[11]; /* omega_tau*(I3^2 + m*R^2*I3)/(R*I3) */
    const double t18 = t15*t17; /* t15*omega_tau*(I3^2 + m*R^2*I3)/(R*I3) */
    const double t19 = JLT_FMS(p[8], t15, t12); /* 1/(R*I3)*t15 - t7*omega_n*s */
    const double t20 = x[3]*t19; /* omega_n*(1/(R*I3)*t15 - t7*omega_n*s) */
    out[2] = t20;
    const double t21 = p[7]*t20; /* (-R)*omega_n*(1/(R*I3)*t15 - t7*omega_n*s) */
    out[1] = t21;
    const double t22 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t23 = p[12]*t22; /* m*R*I3*V */
    const double t24 = JLT_FMA(t12, t23, t18); /* t7*omega_n*s*m*R*I3*V + t15*omega_tau*(I3^2 + m*R^2*I3)/(R*I3) */
    const double t25 = x[2]*t12; /* omega_tau*t7*omega_n*s */
    const double t26 = JLT_FNMA(t16, t24, t25); /* omega_tau*t7*omega_n*s - gamma3*1/(gamma3*Theta)*t24 */
    out[3] = t26;
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
    const double t3 = x[0]*p[9]; /* gamma3*(I3^2 + m*R^2*I3) */
    const double t4 = t2*t3; /* s^2*gamma3*(I3^2 + m*R^2*I3) */
    const double t5 = 1.0/t4; /* 1/(s^2*gamma3*(I3^2 + m*R^2*I3)) */
    const double t6 = t3*t5; /* 1/s^2 = gamma3*(I3^2 + m*R^2*I3)*1/(s^2*gamma3*(I3^2 + m*R^2*I3)) */
    const double t7 = t2*t5; /* s^2*1/(s^2*gamma3*(I3^2 + m*R^2*I3)) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t8;
    const double t9 = x[3]*p[10]; /* omega_n*R*I3 */
    const double t10 = JLT_FNMA(t8, t9, p[6]); /* G_level - s*omega_n*R*I3 */
    const double t11 = p[8]*t10; /* 1/(R*I3)*(G_level - s*omega_n*R*I3) */
    const double t12 = t6*t8; /* 1/s^2*s */
    const double t13 = p[9]*t7; /* 1/gamma3 = (I3^2 + m*R^2*I3)*s^2*1/(s^2*gamma3*(I3^2 + m*R^2*I3)) */
    const double t14 = t11*t13; /* 1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3 */
    const double t15 = t8*t13; /* s*1/gamma3 */
    const double t16 = x[0]*t7; /* 1/Theta = gamma3*s^2*1/(s^2*gamma3*(I3^2 + m*R^2*I3)) */
    const double t17 = x[3]*t12; /* omega_n*1/s^2*s */
    const double t18 = JLT_FMS(t13, t14, t17); /* d(omega3)/d(gamma3) = 1/gamma3*1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3 - omega_n*1/s^2*s */
    const double t19 = t6*t17; /* 1/s^2*omega_n*1/s^2*s */
    const double t20 = x[0]*t12; /* gamma3*1/s^2*s */
    const double t21 = x[0]*t17; /* gamma3*omega_n*1/s^2*s */
    const double t22 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t23 = p[12]*t22; /* m*R*I3*V */
    const double t24 = JLT_FNMA(t16, t23, x[2]); /* omega_tau - 1/Theta*m*R*I3*V */
    const double t25 = t18 + t19; /* d(omega3)/d(gamma3) + 1/s^2*omega_n*1/s^2*s */
    const double t26 = x[3]*t25; /* omega_n*(d(omega3)/d(gamma3) + 1/s^2*omega_n*1/s^2*s) */
    const double t27 = t19*t24; /* 1/s^2*omega_n*1/s^2*s*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t28 = t20*t24; /* gamma3*1/s^2*s*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t29 = x[2]*t20; /* omega_tau*gamma3*1/s^2*s */
    const double t30 = -t29; /* -omega_tau*gamma3*1/s^2*s */
    out[0] = t30;
    const double t31 = p[1]*t26; /* R*omega_n*(d(omega3)/d(gamma3) + 1/s^2*omega_n*1/s^2*s) */
    out[4] = t31;
    const double t32 = -t26; /* -omega_n*(d(omega3)/d(gamma3) + 1/s^2*omega_n*1/s^2*s) */
    out[8] = t32;
    const double t33 = JLT_FNMA(x[3], t15, t14); /* 1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3 - omega_n*s*1/gamma3 */
    const double t34 = JLT_FNMA(2.0, t21, t33); /* t33 - 2*gamma3*omega_n*1/s^2*s */
    out[11] = t34;
    const double t35 = p[7]*t34; /* (-R)*(t33 - 2*gamma3*omega_n*1/s^2*s) */
    out[7] = t35;
    const double t36 = t16*t21; /* 1/Theta*gamma3*omega_n*1/s^2*s */
    const double t37 = p[9]*t16; /* (I3^2 + m*R^2*I3)*1/Theta */
    const double t38 = t14*t37; /* 1/(R*I3)*(G_level - s*omega_n*R*I3)*1/gamma3*(I3^2 + m*R^2*I3)*1/Theta */
    const double t39 = JLT_FMS(p[14], t36, t38); /* I3^2*1/Theta*gamma3*omega_n*1/s^2*s - t38 */
    out[14] = t39;
    const double t40 = p[13]*t36; /* (-m*R*I3)*1/Theta*gamma3*omega_n*1/s^2*s */
    out[13] = t40;
    const double t41 = x[2]*t37; /* omega_tau*(I3^2 + m*R^2*I3)*1/Theta */
    const double t42 = JLT_FMA(t18, t41, t27); /* d(omega3)/d(gamma3)*omega_tau*(I3^2 + m*R^2*I3)*1/Theta + 1/s^2*omega_n*1/s^2*s*(omega_tau - 1/Theta*m*R*I3*V) */
    out[12] = t42;
    const double t43 = JLT_FMA(t15, t41, t28); /* s*1/gamma3*omega_tau*(I3^2 + m*R^2*I3)*1/Theta + gamma3*1/s^2*s*(omega_tau - 1/Theta*m*R*I3*V) */
    out[15] = t43;
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
    const double t3 = x[0]*p[9]; /* gamma3*(I3^2 + m*R^2*I3) */
    const double t4 = t2*t3; /* s^2*gamma3*(I3^2 + m*R^2*I3) */
    const double t5 = 1.0/t4; /* 1/(s^2*gamma3*(I3^2 + m*R^2*I3)) */
    const double t6 = t3*t5; /* 1/s^2 = gamma3*(I3^2 + m*R^2*I3)*1/(s^2*gamma3*(I3^2 + m*R^2*I3)) */
    const double t7 = t2*t5; /* 1/(gamma3*Theta) = s^2*1/(s^2*gamma3*(I3^2 + m*R^2*I3)) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t8;
    const double t9 = x[2]*t8; /* omega_tau*s */
    out[0] = t9;
    const double t10 = x[3]*t8; /* omega_n*s */
    const double t11 = p[9]*t7; /* 1/gamma3 = (I3^2 + m*R^2*I3)*1/(gamma3*Theta) */
    const double t12 = x[0]*t7; /* 1/Theta = gamma3*1/(gamma3*Theta) */
    const double t13 = JLT_FNMA(p[10], t10, p[6]); /* G_level - R*I3*omega_n*s */
    const double t14 = p[8]*t11; /* 1/(R*I3)*1/gamma3 */
    const double t15 = t13*t14; /* (G_level - R*I3*omega_n*s)*1/(R*I3)*1/gamma3 */
    const double t16 = t6*t10; /* 1/s^2*omega_n*s */
    const double t17 = JLT_FNMA(t10, t11, t15); /* (G_level - R*I3*omega_n*s)*1/(R*I3)*1/gamma3 - omega_n*s*1/gamma3 */
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t19 = p[12]*t18; /* m*R*I3*V */
    const double t20 = JLT_FNMA(t12, t19, x[2]); /* omega_tau - 1/Theta*m*R*I3*V */
    const double t21 = x[0]*t16; /* gamma3*1/s^2*omega_n*s */
    const double t22 = JLT_FNMA(2.0, t21, t17); /* t17 - 2*gamma3*1/s^2*omega_n*s */
    out[15] = t22;
    const double t23 = p[7]*t22; /* (-R)*(t17 - 2*gamma3*1/s^2*omega_n*s) */
    out[11] = t23;
    const double t24 = x[0]*t8; /* gamma3*s */
    const double t25 = t6*t24; /* 1/s^2*gamma3*s */
    const double t26 = t6*t16; /* 1/s^2*1/s^2*omega_n*s */
    const double t27 = JLT_FMS(t11, t15, t16); /* d(omega3)/d(gamma3) = 1/gamma3*(G_level - R*I3*omega_n*s)*1/(R*I3)*1/gamma3 - 1/s^2*omega_n*s */
    const double t28 = t8*t11; /* s*1/gamma3 */
    const double t29 = t15 - t21; /* (G_level - R*I3*omega_n*s)*1/(R*I3)*1/gamma3 - gamma3*1/s^2*omega_n*s */
    const double t30 = x[3]*t29; /* omega_n*t29 */
    out[2] = t30;
    const double t31 = p[7]*t30; /* (-R)*omega_n*t29 */
    out[1] = t31;
    const double t32 = p[9]*t12; /* (I3^2 + m*R^2*I3)*1/Theta */
    const double t33 = t12*t21; /* 1/Theta*gamma3*1/s^2*omega_n*s */
    const double t34 = t20*t21; /* (omega_tau - 1/Theta*m*R*I3*V)*gamma3*1/s^2*omega_n*s */
    const double t35 = p[13]*t33; /* (-m*R*I3)*1/Theta*gamma3*1/s^2*omega_n*s */
    out[17] = t35;
    const double t36 = t26 + t27; /* 1/s^2*1/s^2*omega_n*s + d(omega3)/d(gamma3) */
    const double t37 = x[3]*t36; /* omega_n*(1/s^2*1/s^2*omega_n*s + d(omega3)/d(gamma3)) */
    const double t38 = t20*t26; /* (omega_tau - 1/Theta*m*R*I3*V)*1/s^2*1/s^2*omega_n*s */
    const double t39 = t20*t25; /* (omega_tau - 1/Theta*m*R*I3*V)*1/s^2*gamma3*s */
    const double t40 = x[2]*t25; /* omega_tau*1/s^2*gamma3*s */
    const double t41 = -t40; /* -omega_tau*1/s^2*gamma3*s */
    out[4] = t41;
    const double t42 = p[1]*t37; /* R*omega_n*(1/s^2*1/s^2*omega_n*s + d(omega3)/d(gamma3)) */
    out[8] = t42;
    const double t43 = -t37; /* -omega_n*(1/s^2*1/s^2*omega_n*s + d(omega3)/d(gamma3)) */
    out[12] = t43;
    const double t44 = x[2]*t32; /* omega_tau*(I3^2 + m*R^2*I3)*1/Theta */
    const double t45 = JLT_FMA(t27, t44, t38); /* d(omega3)/d(gamma3)*omega_tau*(I3^2 + m*R^2*I3)*1/Theta + (omega_tau - 1/Theta*m*R*I3*V)*1/s^2*1/s^2*omega_n*s */
    out[16] = t45;
    const double t46 = JLT_FMA(t28, t44, t39); /* s*1/gamma3*omega_tau*(I3^2 + m*R^2*I3)*1/Theta + (omega_tau - 1/Theta*m*R*I3*V)*1/s^2*gamma3*s */
    out[19] = t46;
    const double t47 = JLT_FNMA(t15, t44, t34); /* (omega_tau - 1/Theta*m*R*I3*V)*gamma3*1/s^2*omega_n*s - (G_level - R*I3*omega_n*s)*1/(R*I3)*1/gamma3*omega_tau*(I3^2 + m*R^2*I3)*1/Theta */
    out[3] = t47;
    const double t48 = t15*t32; /* (G_level - R*I3*omega_n*s)*1/(R*I3)*1/gamma3*(I3^2 + m*R^2*I3)*1/Theta */
    const double t49 = JLT_FMS(p[14], t33, t48); /* I3^2*1/Theta*gamma3*1/s^2*omega_n*s - t48 */
    out[18] = t49;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = x[0]*p[9]; /* gamma3*(I3^2 + m*R^2*I3) */
    const double t5 = t3*t4; /* s*gamma3*(I3^2 + m*R^2*I3) */
    const double t6 = 1.0/t5; /* 1/(s*gamma3*(I3^2 + m*R^2*I3)) */
    const double t7 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t8 = p[15]*x[0]; /* m*R*I3*(I3^2 + m*R^2*I3)*gamma3 */
    const double t9 = t7*t8; /* V*m*R*I3*(I3^2 + m*R^2*I3)*gamma3 */
    const double t10 = x[0]*t6; /* 1/(Theta*s) = gamma3*1/(s*gamma3*(I3^2 + m*R^2*I3)) */
    const double t11 = t9*t10; /* V*m*R*I3*(I3^2 + m*R^2*I3)*gamma3*1/(Theta*s) */
    const double t12 = t3*t10; /* s*1/(Theta*s) */
    const double t13 = x[2]*p[16]; /* omega_tau*(I3^2 + m*R^2*I3)^2 */
    const double t14 = t2*t13; /* (1 - gamma3)*(gamma3 + 1)*omega_tau*(I3^2 + m*R^2*I3)^2 */
    const double t15 = JLT_FMS(t6, t14, t11); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = 1/(s*gamma3*(I3^2 + m*R^2*I3))*(1 - gamma3)*(gamma3 + 1)*omega_tau*(I3^2 + m*R^2*I3)^2 - V*m*R*I3*(I3^2 + m*R^2*I3)*gamma3*1/(Theta*s) */
    const double t16 = t12*t15; /* s*1/(Theta*s)*d(numerator of d(omega_n)/dt over Theta)/d(omega_n) */
    out[0] = t16;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = p[10]*x[3]; /* R*I3*omega_n */
    const double t5 = JLT_FNMA(t3, t4, p[6]); /* G_level - s*R*I3*omega_n */
    const double t6 = p[8]/x[0]; /* 1/(R*I3)/gamma3 */
    const double t7 = t5*t6; /* (G_level - s*R*I3*omega_n)*1/(R*I3)/gamma3 */
    const double t8 = t3*t7; /* s*(G_level - s*R*I3*omega_n)*1/(R*I3)/gamma3 */
    const double t9 = JLT_FMS(x[0], x[3], t8); /* v_tau/R = gamma3*omega_n - s*(G_level - s*R*I3*omega_n)*1/(R*I3)/gamma3 */
    const double t10 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t11 = JLT_FMA(x[3], x[3], t10); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t12 = JLT_FMA(t7, t7, t11); /* (G_level - s*R*I3*omega_n)*1/(R*I3)/gamma3*(G_level - s*R*I3*omega_n)*1/(R*I3)/gamma3 + omega_n*omega_n + omega_tau*omega_tau */
    const double t13 = x[1]*x[1]; /* v_nu*v_nu */
    const double t14 = JLT_FMA(p[18], t12, t13); /* I3/m*t12 + v_nu*v_nu */
    const double t15 = p[19]*t9; /* R^2*v_tau/R */
    const double t16 = JLT_FMA(t9, t15, t14); /* energy/(1/2*m) = v_tau/R*R^2*v_tau/R + I3/m*t12 + v_nu*v_nu */
    const double t17 = p[17]*t16; /* 1/2*m*energy/(1/2*m) */
    out[0] = t17;
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[2] = t18;
    const double t19 = p[20]*t18; /* m*I3^2*(omega_tau*R + v_nu) */
    const double t20 = t18*t19; /* (omega_tau*R + v_nu)*m*I3^2*(omega_tau*R + v_nu) */
    out[1] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[9] = 1.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    const double t4 = x[3]*t3; /* omega_n*s */
    const double t5 = JLT_FNMA(p[10], t4, p[6]); /* G_level - R*I3*omega_n*s */
    const double t6 = x[0]*t2; /* gamma3*s^2 */
    const double t7 = 1.0/t6; /* 1/(gamma3*s^2) */
    const double t8 = t2*t7; /* 1/gamma3 = s^2*1/(gamma3*s^2) */
    const double t9 = t5*t8; /* (G_level - R*I3*omega_n*s)*1/gamma3 */
    const double t10 = p[8]*t9; /* 1/(R*I3)*(G_level - R*I3*omega_n*s)*1/gamma3 */
    const double t11 = t8*t10; /* 1/gamma3*1/(R*I3)*(G_level - R*I3*omega_n*s)*1/gamma3 */
    const double t12 = x[0]*t7; /* 1/s^2 = gamma3*1/(gamma3*s^2) */
    const double t13 = JLT_FNMA(t4, t12, t11); /* d(omega3)/d(gamma3) = 1/gamma3*1/(R*I3)*(G_level - R*I3*omega_n*s)*1/gamma3 - omega_n*s*1/s^2 */
    const double t14 = t9*p[21]; /* (G_level - R*I3*omega_n*s)*1/gamma3*1/R */
    const double t15 = t13*t14; /* d(omega3)/d(gamma3)*(G_level - R*I3*omega_n*s)*1/gamma3*1/R */
    const double t16 = x[0]*t12; /* gamma3*1/s^2 */
    const double t17 = JLT_FMA(t10, t16, t13); /* 1/(R*I3)*(G_level - R*I3*omega_n*s)*1/gamma3*gamma3*1/s^2 + d(omega3)/d(gamma3) */
    const double t18 = JLT_FMA(t3, t17, x[3]); /* d(v_tau)/d(gamma3)/R = s*t17 + omega_n */
    const double t19 = t3*t10; /* s*1/(R*I3)*(G_level - R*I3*omega_n*s)*1/gamma3 */
    const double t20 = JLT_FMS(x[3], x[0], t19); /* v_tau/R = omega_n*gamma3 - s*1/(R*I3)*(G_level - R*I3*omega_n*s)*1/gamma3 */
    const double t21 = p[22]*t20; /* m*R^2*v_tau/R */
    const double t22 = JLT_FMS(t18, t21, t15); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R - d(omega3)/d(gamma3)*(G_level - R*I3*omega_n*s)*1/gamma3*1/R */
    out[0] = t22;
    const double t23 = p[0]*x[1]; /* m*v_nu */
    out[1] = t23;
    const double t24 = p[5]*x[2]; /* I3*omega_tau */
    out[2] = t24;
    const double t25 = JLT_FMS(t3, t14, t21); /* s*(G_level - R*I3*omega_n*s)*1/gamma3*1/R - m*R^2*v_tau/R */
    const double t26 = t8*t25; /* 1/gamma3*(s*(G_level - R*I3*omega_n*s)*1/gamma3*1/R - m*R^2*v_tau/R) */
    const double t27 = JLT_FMS(x[3], p[5], t26); /* d(energy)/d(omega_n) = omega_n*I3 - t26 */
    out[3] = t27;
    out[4] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[10] = p[1];
    const double t28 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t29 = p[23]*t28; /* 2*m*I3^2*(omega_tau*R + v_nu) */
    out[5] = t29;
    const double t30 = t28*p[24]; /* (omega_tau*R + v_nu)*2*m*R*I3^2 */
    out[6] = t30;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = p[10]*x[3]; /* R*I3*omega_n */
    const double t5 = JLT_FNMA(t3, t4, p[6]); /* G_level - s*R*I3*omega_n */
    const double t6 = p[25]/x[0]; /* (-1/(R*I3))/gamma3 */
    const double t7 = t5*t6; /* (G_level - s*R*I3*omega_n)*(-1/(R*I3))/gamma3 */
    out[0] = t7;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t13[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t14[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t15[k] = jlt_jet_product(t13, t14, k);
        t16[k] = jlt_jet_root(t15[k], t16, k);
        t17[k] = jlt_jet_product(x2, t16, k);
        t18[k] = jlt_jet_product(x0, t16, k);
        t19[k] = p[9]*t18[k];
        t20[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t19, t20, k);
        t21[k] = jlt_jet_product(t18, t20, k);
        t22[k] = p[9]*t20[k];
        t23[k] = x3[k]*p[10];
        t24[k] = (k == 0 ? p[6] : 0) - jlt_jet_product(t16, t23, k);
        t25[k] = jlt_jet_product(t16, t24, k);
        t26[k] = jlt_jet_product(t22, t25, k);
        t27[k] = jlt_jet_product(x0, x0, k);
        t28[k] = jlt_jet_product(x3, t27, k);
        t29[k] = jlt_jet_product(t22, t28, k);
        t30[k] = x2[k]*p[11];
        t31[k] = jlt_jet_product(t26, t30, k);
        t32[k] = p[8]*t26[k] - t29[k];
        t33[k] = jlt_jet_product(x3, t32, k);
        t34[k] = p[7]*t33[k];
        t35[k] = x2[k]*p[1] + x1[k];
        t36[k] = p[12]*t35[k];
        t37[k] = jlt_jet_product(t29, t36, k) + t31[k];
        t38[k] = jlt_jet_product(x2, t29, k);
        t39[k] = t38[k] - jlt_jet_product(t21, t37, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t17[k]/(k + 1);
        next[1] = x1[k + 1] = t34[k]/(k + 1);
        next[2] = x2[k + 1] = t33[k]/(k + 1);
        next[3] = x3[k + 1] = t39[k]/(k + 1);
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
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 26,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 2, 18, 5, 1, 1, 0, 10, 5 }, { 11, 43, 0, 7, 1, 0, 11, 8 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level - (R*I3)*omega_n*s, a part of d(v_nu)/dt and of d(omega_tau)/dt, V = omega_tau*R + v_nu, a part of d(omega_n)/dt, d(omega_n)/dt" },
    .jacobian = { jacobian, 16, { 5, 28, 9, 1, 1, 0, 11, 10 }, { 30, 113, 0, 27, 1, 0, 12, 9 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level - s*omega_n*(R*I3), d(omega3)/d(gamma3), V = omega_tau*R + v_nu, omega_tau - 1/Theta*(m*R*I3)*V, d(omega3)/d(gamma3) + 1/s^2*omega_n*1/s^2*s, d(d(omega_tau)/dt)/d(omega_n), d(d(omega_n)/dt)/d(omega_tau), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 6, 32, 10, 1, 1, 0, 12, 11 }, { 36, 138, 0, 33, 1, 0, 12, 9 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level - (R*I3)*omega_n*s, V = omega_tau*R + v_nu, omega_tau - 1/Theta*(m*R*I3)*V, d(d(omega_tau)/dt)/d(omega_n), d(omega3)/d(gamma3), a part of d(v_nu)/dt and of d(omega_tau)/dt, 1/s^2*1/s^2*omega_n*s + d(omega3)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), d(omega_n)/dt, d(d(omega_n)/dt)/d(omega_tau)" },
    .divergence = { divergence, 1, { 2, 11, 2, 1, 1, 0, 9, 6 }, { 6, 28, 0, 3, 1, 0, 10, 6 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = R*omega_tau + v_nu, d(numerator of d(omega_n)/dt over Theta)/d(omega_n)" },
    .integral_values = { integral_values, 3, { 2, 10, 7, 1, 1, 0, 10, 4 }, { 9, 31, 0, 1, 1, 0, 15, 5 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level - s*(R*I3)*omega_n, v_tau/R = gamma3*omega_n - s*(G_level - s*(R*I3)*omega_n)*((1/(R*I3))/gamma3), F_linear" },
    .integral_gradients = { integral_gradients, 12, { 2, 18, 9, 1, 1, 0, 13, 8 }, { 13, 46, 0, 6, 1, 0, 13, 9 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level - (R*I3)*omega_n*s, d(omega3)/d(gamma3), a part of d(E)/d(gamma3), d(v_tau)/d(gamma3)/R, v_tau/R = omega_n*gamma3 - s*(1/(R*I3))*(G_level - (R*I3)*omega_n*s)*1/gamma3, d(E)/d(gamma3), s*(G_level - (R*I3)*omega_n*s)*1/gamma3*(1/R) - (m*R^2)*v_tau/R, d(E)/d(omega_n), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 3, 1, 1, 1, 0, 5, 3 }, { 2, 6, 0, 1, 1, 0, 6, 4 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level - s*(R*I3)*omega_n" },
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
