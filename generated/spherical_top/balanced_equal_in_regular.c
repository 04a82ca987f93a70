/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   14    5    1    0    0      7    6   (63)
 *  jacobian            7   36   12    1    0    0      8    9   (242)
 *  rhs_jacobian        12   44   11    1    0    0      8   10   (290)
 *  divergence          0    3    3    1    0    0      4    4   (21)
 *  integral_values     0    9    7    0    0    0      6    4   (39)
 *  integral_gradients  0   14    4    0    0    0      4    3   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are
 *    digits are lost where terms nearly cancel in V = omega_tau*R + v_nu,
 *      numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*(m*R*I3)*V,
 *      d(omega_n)/dtau, d(d(omega_n)/dtau)/d(s), s*omega3 + omega_n*gamma3, omega_tau - ((1)/Theta)*(m*R*I3)*V,
 *      d(d(omega3)/dtau)/d(s), (2)*omega_n*gamma3 + s*omega3,
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = (I3^2 + m*R^2*I3)*s*omega3 - (m*R^2*I3)*omega_n*gamma3,
 *      d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(gamma3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_avx512;

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
    out[7] = t0;
    const double t1 = params[1]*params[1]; /* R*R */
    out[16] = t1;
    const double t2 = params[0]*t1; /* m*R*R */
    out[19] = t2;
    const double t3 = params[5]*t2; /* I3*m*R*R */
    out[8] = t3;
    const double t4 = t0 + t3; /* I3*I3 + I3*m*R*R */
    out[6] = t4;
    const double t5 = params[0]*params[1]; /* m*R */
    const double t6 = params[5]*t5; /* I3*m*R */
    out[9] = t6;
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t1*t7; /* R*R*m*2 */
    const double t9 = params[5]*t8; /* I3*R*R*m*2 */
    out[10] = t9;
    const double t10 = -t6; /* -I3*m*R */
    out[11] = t10;
    const double t11 = params[0]*params[0]; /* m*m */
    const double t12 = 2.0*t11; /* 2*m*m */
    const double t13 = params[1]*t1; /* R*R*R */
    const double t14 = t12*t13; /* 2*m*m*R*R*R */
    const double t15 = t0*t14; /* I3*I3*2*m*m*R*R*R */
    out[12] = t15;
    const double t16 = -t3; /* -I3*m*R*R */
    out[13] = t16;
    const double t17 = params[0]/2.0; /* m/2 */
    out[14] = t17;
    const double t18 = params[5]/params[0]; /* I3/m */
    out[15] = t18;
    const double t19 = params[5]*params[1]; /* I3*R */
    out[20] = t19;
    const double t20 = -t19; /* -I3*R */
    out[17] = t20;
    const double t21 = t0*params[0]; /* I3*I3*m */
    out[18] = t21;
    const double t22 = t0*t7; /* I3*I3*m*2 */
    out[21] = t22;
    const double t23 = params[1]*t7; /* R*m*2 */
    const double t24 = t0*t23; /* I3*I3*R*m*2 */
    out[22] = t24;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[2]; /* s*omega_tau */
    const double t1 = x[5]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t3 = x[5]*x[4]; /* s*omega3 */
    const double t4 = t2 + t3; /* omega_n*gamma3 + s*omega3 */
    const double t5 = x[3]*t4; /* omega_n*(omega_n*gamma3 + s*omega3) */
    const double t6 = p[1]*t5; /* R*omega_n*(omega_n*gamma3 + s*omega3) */
    out[1] = t6;
    const double t7 = -t5; /* -omega_n*(omega_n*gamma3 + s*omega3) */
    out[2] = t7;
    const double t8 = x[5]*x[5]; /* s*s */
    const double t9 = JLT_FMA(x[0], x[0], t8); /* gamma3*gamma3 + s*s */
    const double t10 = JLT_FMA(p[8], t9, p[7]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t11 = 1.0/t10; /* 1/Theta */
    const double t12 = t3*p[6]; /* s*omega3*(I3^2 + m*R^2*I3) */
    const double t13 = JLT_FMA(t11, t12, t2); /* 1/Theta*s*omega3*(I3^2 + m*R^2*I3) + omega_n*gamma3 */
    const double t14 = x[2]*t13; /* omega_tau*(1/Theta*s*omega3*(I3^2 + m*R^2*I3) + omega_n*gamma3) */
    const double t15 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t16 = p[9]*t15; /* m*R*I3*V */
    const double t17 = t11*t16; /* 1/Theta*m*R*I3*V */
    const double t18 = JLT_FNMA(t2, t17, t14); /* t14 - omega_n*gamma3*1/Theta*m*R*I3*V */
    out[3] = t18;
    const double t19 = x[5]*x[3]; /* s*omega_n */
    const double t20 = t17*t19; /* 1/Theta*m*R*I3*V*s*omega_n */
    const double t21 = -t20; /* -1/Theta*m*R*I3*V*s*omega_n */
    out[4] = t21;
    const double t22 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t23 = -t22; /* -s*omega_tau*gamma3 */
    out[5] = t23;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[28] = 0.0;
    out[31] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    const double t0 = x[5]*x[5]; /* s*s */
    out[2] = t0;
    const double t1 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t2 = JLT_FMA(p[8], t1, p[7]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t3 = 1.0/t2; /* 1/Theta */
    const double t4 = x[5]*x[4]; /* s*omega3 */
    const double t5 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t6 = x[2]*p[6]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t7 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t8 = p[9]*t5; /* m*R*I3*V */
    const double t9 = t4*t6; /* s*omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t10 = JLT_FNMA(t7, t8, t9); /* numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*m*R*I3*V */
    const double t11 = t3*t8; /* 1/Theta*m*R*I3*V */
    const double t12 = p[10]*t10; /* 2*m*R^2*I3*numerator of d(omega_n)/dt over Theta */
    const double t13 = t3*t12; /* 1/Theta*2*m*R^2*I3*numerator of d(omega_n)/dt over Theta */
    const double t14 = x[5]*t3; /* s*1/Theta */
    const double t15 = t5*t14; /* V*s*1/Theta */
    const double t16 = t6*t14; /* omega_tau*(I3^2 + m*R^2*I3)*s*1/Theta */
    out[22] = t16;
    const double t17 = x[4]*t6; /* omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t18 = t3*t17; /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t19 = JLT_FNMA(t13, t14, t18); /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) - 1/Theta*2*m*R^2*I3*numerator of d(omega_n)/dt over Theta*s*1/Theta */
    out[23] = t19;
    const double t20 = x[3]*t14; /* omega_n*s*1/Theta */
    const double t21 = p[11]*t20; /* (-m*R*I3)*omega_n*s*1/Theta */
    out[25] = t21;
    const double t22 = p[13]*t20; /* (-m*R^2*I3)*omega_n*s*1/Theta */
    out[26] = t22;
    const double t23 = p[11]*t15; /* (-m*R*I3)*V*s*1/Theta */
    out[27] = t23;
    const double t24 = p[12]*t15; /* 2*m^2*R^3*I3^2*V*s*1/Theta */
    const double t25 = x[3]*t11; /* omega_n*1/Theta*m*R*I3*V */
    const double t26 = JLT_FMS(t20, t24, t25); /* omega_n*s*1/Theta*2*m^2*R^3*I3^2*V*s*1/Theta - omega_n*1/Theta*m*R*I3*V */
    out[29] = t26;
    const double t27 = JLT_FMS(x[2], x[3], t25); /* omega_tau*omega_n - omega_n*1/Theta*m*R*I3*V */
    const double t28 = p[6]*t4; /* (I3^2 + m*R^2*I3)*s*omega3 */
    const double t29 = JLT_FMA(2.0, t7, t4); /* 2*omega_n*gamma3 + s*omega3 */
    const double t30 = JLT_FNMA(p[8], t7, t28); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = (I3^2 + m*R^2*I3)*s*omega3 - m*R^2*I3*omega_n*gamma3 */
    const double t31 = JLT_FMA(t3, t30, t7); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[20] = t31;
    const double t32 = t3*t7; /* 1/Theta*omega_n*gamma3 */
    const double t33 = t24*t32; /* 2*m^2*R^3*I3^2*V*s*1/Theta*1/Theta*omega_n*gamma3 */
    out[24] = t33;
    const double t34 = p[11]*t32; /* (-m*R*I3)*1/Theta*omega_n*gamma3 */
    out[19] = t34;
    const double t35 = x[0]*t3; /* gamma3*1/Theta */
    const double t36 = JLT_FNMA(t13, t35, t27); /* omega_tau*omega_n - omega_n*1/Theta*m*R*I3*V - 1/Theta*2*m*R^2*I3*numerator of d(omega_n)/dt over Theta*gamma3*1/Theta */
    out[18] = t36;
    const double t37 = p[1]*t29; /* R*(2*omega_n*gamma3 + s*omega3) */
    out[9] = t37;
    const double t38 = -t29; /* -(2*omega_n*gamma3 + s*omega3) */
    out[15] = t38;
    const double t39 = x[5]*x[2]; /* s*omega_tau */
    const double t40 = 2.0*t39; /* 2*s*omega_tau */
    out[5] = t40;
    const double t41 = -t39; /* -s*omega_tau */
    out[30] = t41;
    const double t42 = x[3]*x[3]; /* omega_n*omega_n */
    const double t43 = p[1]*t42; /* R*omega_n*omega_n */
    out[6] = t43;
    const double t44 = -t42; /* -omega_n*omega_n */
    out[12] = t44;
    const double t45 = x[5]*x[3]; /* s*omega_n */
    const double t46 = p[1]*t45; /* R*s*omega_n */
    out[10] = t46;
    const double t47 = -t45; /* -s*omega_n */
    out[16] = t47;
    const double t48 = x[3]*x[4]; /* omega_n*omega3 */
    const double t49 = p[1]*t48; /* R*omega_n*omega3 */
    out[11] = t49;
    const double t50 = -t48; /* -omega_n*omega3 */
    out[17] = t50;
    const double t51 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t52 = JLT_FNMA(x[0], t11, t51); /* omega_tau*gamma3 - gamma3*1/Theta*m*R*I3*V */
    out[21] = t52;
    const double t53 = -t51; /* -omega_tau*gamma3 */
    out[35] = t53;
    const double t54 = x[5]*x[0]; /* s*gamma3 */
    const double t55 = -t54; /* -s*gamma3 */
    out[32] = t55;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[19] = 0.0;
    out[20] = 0.0;
    out[34] = 0.0;
    out[37] = 0.0;
    out[39] = 0.0;
    out[40] = 0.0;
    const double t0 = x[5]*x[5]; /* s*s */
    out[8] = t0;
    const double t1 = JLT_FMA(x[0], x[0], t0); /* gamma3*gamma3 + s*s */
    const double t2 = JLT_FMA(p[8], t1, p[7]); /* Theta = m*R^2*I3*(gamma3*gamma3 + s*s) + I3^2 */
    const double t3 = 1.0/t2; /* 1/Theta */
    const double t4 = x[5]*x[4]; /* s*omega3 */
    const double t5 = x[2]*p[6]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t6 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t7 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t8 = t4*t5; /* s*omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t9 = p[9]*t6; /* m*R*I3*V */
    const double t10 = JLT_FNMA(t7, t9, t8); /* numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*m*R*I3*V */
    const double t11 = t3*t10; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t12 = JLT_FMA(x[2], t7, t11); /* omega_tau*omega_n*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t12;
    const double t13 = p[10]*t11; /* 2*m*R^2*I3*1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t14 = x[5]*t3; /* s*1/Theta */
    const double t15 = t6*t14; /* V*s*1/Theta */
    const double t16 = t5*t14; /* omega_tau*(I3^2 + m*R^2*I3)*s*1/Theta */
    out[28] = t16;
    const double t17 = x[4]*t5; /* omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t18 = t3*t17; /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t19 = JLT_FNMA(t13, t14, t18); /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) - 2*m*R^2*I3*1/Theta*numerator of d(omega_n)/dt over Theta*s*1/Theta */
    out[29] = t19;
    const double t20 = x[3]*t14; /* omega_n*s*1/Theta */
    const double t21 = p[11]*t20; /* (-m*R*I3)*omega_n*s*1/Theta */
    out[31] = t21;
    const double t22 = p[13]*t20; /* (-m*R^2*I3)*omega_n*s*1/Theta */
    out[32] = t22;
    const double t23 = p[11]*t15; /* (-m*R*I3)*V*s*1/Theta */
    out[33] = t23;
    const double t24 = p[12]*t15; /* 2*m^2*R^3*I3^2*V*s*1/Theta */
    const double t25 = t3*t9; /* 1/Theta*m*R*I3*V */
    const double t26 = t9*t20; /* m*R*I3*V*omega_n*s*1/Theta */
    const double t27 = -t26; /* -m*R*I3*V*omega_n*s*1/Theta */
    out[4] = t27;
    const double t28 = x[5]*x[2]; /* s*omega_tau */
    const double t29 = x[5]*t28; /* s*s*omega_tau */
    out[0] = t29;
    const double t30 = 2.0*t28; /* 2*s*omega_tau */
    out[11] = t30;
    const double t31 = -t28; /* -s*omega_tau */
    out[36] = t31;
    const double t32 = x[0]*t28; /* gamma3*s*omega_tau */
    const double t33 = -t32; /* -gamma3*s*omega_tau */
    out[5] = t33;
    const double t34 = t4 + t7; /* s*omega3 + omega_n*gamma3 */
    const double t35 = x[2] - t25; /* omega_tau - 1/Theta*m*R*I3*V */
    const double t36 = x[3]*t25; /* omega_n*1/Theta*m*R*I3*V */
    const double t37 = JLT_FMS(t20, t24, t36); /* omega_n*s*1/Theta*2*m^2*R^3*I3^2*V*s*1/Theta - omega_n*1/Theta*m*R*I3*V */
    out[35] = t37;
    const double t38 = x[0]*t35; /* gamma3*(omega_tau - 1/Theta*m*R*I3*V) */
    out[27] = t38;
    const double t39 = x[3]*t35; /* omega_n*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t40 = p[6]*t4; /* (I3^2 + m*R^2*I3)*s*omega3 */
    const double t41 = JLT_FMA(2.0, t7, t4); /* 2*omega_n*gamma3 + s*omega3 */
    const double t42 = JLT_FNMA(p[8], t7, t40); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = (I3^2 + m*R^2*I3)*s*omega3 - m*R^2*I3*omega_n*gamma3 */
    const double t43 = JLT_FMA(t3, t42, t7); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[26] = t43;
    const double t44 = t3*t7; /* 1/Theta*omega_n*gamma3 */
    const double t45 = t24*t44; /* 2*m^2*R^3*I3^2*V*s*1/Theta*1/Theta*omega_n*gamma3 */
    out[30] = t45;
    const double t46 = p[11]*t44; /* (-m*R*I3)*1/Theta*omega_n*gamma3 */
    out[25] = t46;
    const double t47 = x[0]*t3; /* gamma3*1/Theta */
    const double t48 = JLT_FNMA(t13, t47, t39); /* omega_n*(omega_tau - 1/Theta*m*R*I3*V) - 2*m*R^2*I3*1/Theta*numerator of d(omega_n)/dt over Theta*gamma3*1/Theta */
    out[24] = t48;
    const double t49 = p[1]*t41; /* R*(2*omega_n*gamma3 + s*omega3) */
    out[15] = t49;
    const double t50 = -t41; /* -(2*omega_n*gamma3 + s*omega3) */
    out[21] = t50;
    const double t51 = x[3]*p[1]; /* omega_n*R */
    const double t52 = t34*t51; /* (s*omega3 + omega_n*gamma3)*omega_n*R */
    out[1] = t52;
    const double t53 = x[3]*t34; /* omega_n*(s*omega3 + omega_n*gamma3) */
    const double t54 = -t53; /* -omega_n*(s*omega3 + omega_n*gamma3) */
    out[2] = t54;
    const double t55 = x[3]*t51; /* omega_n*omega_n*R */
    out[12] = t55;
    const double t56 = x[5]*t51; /* s*omega_n*R */
    out[16] = t56;
    const double t57 = x[4]*t51; /* omega3*omega_n*R */
    out[17] = t57;
    const double t58 = x[3]*x[3]; /* omega_n*omega_n */
    const double t59 = -t58; /* -omega_n*omega_n */
    out[18] = t59;
    const double t60 = x[5]*x[3]; /* s*omega_n */
    const double t61 = -t60; /* -s*omega_n */
    out[22] = t61;
    const double t62 = x[4]*x[3]; /* omega3*omega_n */
    const double t63 = -t62; /* -omega3*omega_n */
    out[23] = t63;
    const double t64 = x[5]*x[0]; /* s*gamma3 */
    const double t65 = -t64; /* -s*gamma3 */
    out[38] = t65;
    const double t66 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t67 = -t66; /* -omega_tau*gamma3 */
    out[41] = t67;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = JLT_FMA(x[5], x[5], t0); /* s*s + gamma3*gamma3 */
    const double t2 = JLT_FMA(p[8], t1, p[7]); /* Theta = m*R^2*I3*(s*s + gamma3*gamma3) + I3^2 */
    const double t3 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t4 = p[11]*x[0]; /* (-m*R*I3)*gamma3 */
    const double t5 = t3*t4; /* V*(-m*R*I3)*gamma3 */
    const double t6 = t5/t2; /* V*(-m*R*I3)*gamma3/Theta */
    out[0] = t6;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* omega3*omega3 */
    const double t1 = JLT_FMA(x[3], x[3], t0); /* omega_n*omega_n + omega3*omega3 */
    const double t2 = JLT_FMA(x[2], x[2], t1); /* omega_tau*omega_tau + omega_n*omega_n + omega3*omega3 */
    const double t3 = x[4]*x[5]; /* omega3*s */
    const double t4 = JLT_FMA(x[3], x[0], t3); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t5 = x[1]*x[1]; /* v_nu*v_nu */
    const double t6 = JLT_FMA(p[15], t2, t5); /* I3/m*(omega_tau*omega_tau + omega_n*omega_n + omega3*omega3) + v_nu*v_nu */
    const double t7 = p[16]*t4; /* R^2*v_tau/R */
    const double t8 = JLT_FMA(t4, t7, t6); /* energy/(1/2*m) = v_tau/R*R^2*v_tau/R + t6 */
    const double t9 = p[14]*t8; /* 1/2*m*energy/(1/2*m) */
    out[0] = t9;
    const double t10 = x[4]*x[0]; /* omega3*gamma3 */
    const double t11 = JLT_FNMA(x[3], x[5], t10); /* omega3*gamma3 - omega_n*s */
    const double t12 = p[17]*t11; /* (-R*I3)*(omega3*gamma3 - omega_n*s) */
    out[1] = t12;
    const double t13 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    out[3] = t13;
    const double t14 = p[18]*t13; /* m*I3^2*(omega_tau*R + v_nu) */
    const double t15 = t13*t14; /* (omega_tau*R + v_nu)*m*I3^2*(omega_tau*R + v_nu) */
    out[2] = t15;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[5]; /* omega3*s */
    const double t1 = JLT_FMA(x[3], x[0], t0); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t2 = p[19]*t1; /* m*R^2*v_tau/R */
    const double t3 = x[3]*t2; /* omega_n*m*R^2*v_tau/R */
    out[0] = t3;
    const double t4 = p[0]*x[1]; /* m*v_nu */
    out[1] = t4;
    const double t5 = p[5]*x[2]; /* I3*omega_tau */
    out[2] = t5;
    const double t6 = x[3]*p[5]; /* omega_n*I3 */
    const double t7 = JLT_FMA(x[0], t2, t6); /* d(energy)/d(omega_n) = gamma3*m*R^2*v_tau/R + omega_n*I3 */
    out[3] = t7;
    const double t8 = x[4]*p[5]; /* omega3*I3 */
    const double t9 = JLT_FMA(x[5], t2, t8); /* d(energy)/d(omega3) = s*m*R^2*v_tau/R + omega3*I3 */
    out[4] = t9;
    const double t10 = x[4]*t2; /* omega3*m*R^2*v_tau/R */
    out[5] = t10;
    const double t11 = x[4]*p[17]; /* omega3*(-R*I3) */
    out[6] = t11;
    out[7] = 0.0;
    out[8] = 0.0;
    out[12] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
    const double t12 = x[5]*p[20]; /* s*R*I3 */
    out[9] = t12;
    const double t13 = x[0]*p[17]; /* gamma3*(-R*I3) */
    out[10] = t13;
    const double t14 = x[3]*p[20]; /* omega_n*R*I3 */
    out[11] = t14;
    out[20] = p[1];
    const double t15 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t16 = p[21]*t15; /* 2*m*I3^2*(omega_tau*R + v_nu) */
    out[13] = t16;
    const double t17 = t15*p[22]; /* (omega_tau*R + v_nu)*2*m*R*I3^2 */
    out[14] = t17;
    out[19] = 1.0;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[5];
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double x5[JLT_JET_ORDER_MAX + 1];
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x5, x2, k);
        t3[k] = jlt_jet_product(x5, t2, k);
        t8[k] = jlt_jet_product(x3, x0, k);
        t9[k] = jlt_jet_product(x5, x4, k) + t8[k];
        t10[k] = jlt_jet_product(x3, t9, k);
        t11[k] = p[1]*t10[k];
        t12[k] = -t10[k];
        t16[k] = jlt_jet_product(x5, x5, k);
        t17[k] = jlt_jet_product(x0, x0, k) + t16[k];
        t18[k] = p[8]*t17[k] + (k == 0 ? p[7] : 0);
        t20[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t18, t20, k);
        t22[k] = x2[k]*p[1] + x1[k];
        t23[k] = p[9]*t22[k];
        t24[k] = jlt_jet_product(t20, t23, k);
        t25[k] = x2[k] - t24[k];
        t26[k] = jlt_jet_product(t8, t25, k);
        t28[k] = x4[k]*p[6];
        t29[k] = jlt_jet_product(t2, t28, k);
        t30[k] = jlt_jet_product(t20, t29, k) + t26[k];
        t31[k] = jlt_jet_product(x5, x3, k);
        t32[k] = jlt_jet_product(t24, t31, k);
        t33[k] = -t32[k];
        t34[k] = jlt_jet_product(t2, x0, k);
        t35[k] = -t34[k];
        double *restrict next = coefficients + (k + 1)*7;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t11[k]/(k + 1);
        next[2] = x2[k + 1] = t12[k]/(k + 1);
        next[3] = x3[k + 1] = t30[k]/(k + 1);
        next[4] = x4[k + 1] = t33[k]/(k + 1);
        next[5] = x5[k + 1] = t35[k]/(k + 1);
        next[6] = x5[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[5];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = (0.0);
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega3 = x[4];
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double v_I3 = params[5];
    const double v_I1 = (v_I3);
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
    out[4] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[5] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "G", "" },
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 23,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 6, { 4, 14, 5, 1, 0, 0, 7, 6 }, { 11, 48, 0, 4, 0, 0, 10, 6 },
        "divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in omega_n*gamma3 + s*omega3, ((1)/Theta)*s*omega3*(I3^2 + m*R^2*I3) + omega_n*gamma3, V = omega_tau*R + v_nu, d(omega_n)/dtau" },
    .jacobian = { jacobian, 36, { 7, 36, 12, 1, 0, 0, 8, 9 }, { 30, 190, 0, 22, 0, 0, 12, 6 },
        "divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*(m*R*I3)*V, d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(s), (2)*omega_n*gamma3 + s*omega3, d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = (I3^2 + m*R^2*I3)*s*omega3 - (m*R^2*I3)*omega_n*gamma3, d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n)" },
    .rhs_jacobian = { rhs_jacobian, 42, { 12, 44, 11, 1, 0, 0, 8, 10 }, { 38, 226, 0, 26, 0, 0, 12, 6 },
        "divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*(m*R*I3)*V, d(omega_n)/dtau, d(d(omega_n)/dtau)/d(s), s*omega3 + omega_n*gamma3, omega_tau - ((1)/Theta)*(m*R*I3)*V, d(d(omega3)/dtau)/d(s), (2)*omega_n*gamma3 + s*omega3, d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = (I3^2 + m*R^2*I3)*s*omega3 - (m*R^2*I3)*omega_n*gamma3, d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(gamma3)" },
    .divergence = { divergence, 1, { 0, 3, 3, 1, 0, 0, 4, 4 }, { 4, 16, 0, 1, 0, 0, 8, 5 },
        "divides by Theta, small only where all of I3^2, m*R^2*I3*gamma3^2 and m*R^2*I3*s^2 are; digits are lost where terms nearly cancel in V = R*omega_tau + v_nu" },
    .integral_values = { integral_values, 4, { 0, 9, 7, 0, 0, 0, 6, 4 }, { 8, 31, 0, 0, 0, 0, 9, 4 },
        "digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, omega3*gamma3 - omega_n*s, F_linear" },
    .integral_gradients = { integral_gradients, 24, { 0, 14, 4, 0, 0, 0, 4, 3 }, { 7, 39, 0, 0, 0, 0, 5, 4 },
        "digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, d(E)/d(omega_n), d(E)/d(omega3), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_in_regular_baseline,
        &jlt_batch_spherical_top_balanced_equal_in_regular_avx2,
        &jlt_batch_spherical_top_balanced_equal_in_regular_avx512,
    },
};
