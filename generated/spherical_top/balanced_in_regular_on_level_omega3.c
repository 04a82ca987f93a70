/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   17    6    1    0    0      8    7   (65)
 *  jacobian            7   39   16    1    0    0     14   13   (286)
 *  rhs_jacobian        8   42   19    1    0    0     16   14   (329)
 *  divergence          0   10    4    1    0    0      7    5   (36)
 *  integral_values     0   11   10    1    0    0      8    6   (55)
 *  integral_gradients  0   25   13    1    0    0      7   10   (138)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    1    1    1    0    0      3    2   (7)
 *
 *  Accuracy
 *    divides by gamma3: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n, G_level/(R*I1) - s*omega_n - s*omega_n,
 *      V = omega_tau*R + v_nu,
 *      a part of d(omega_n)/dtau and of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s),
 *      a part of d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_tau), d(omega_n)/dtau,
 *      d(numerator of d(omega_n)/dt over Theta)/d(gamma3), a part of d(d(omega_n)/dtau)/d(s),
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = (I1*I3 + m*R^2*I1)*s*1/gamma3*s*omega_tau - gamma3*(m*R*I3)*V,
 *      a part of d(d(omega_n)/dtau)/d(s), d(d(omega_tau)/dtau)/d(omega_n), d(d(v_nu)/dtau)/d(omega_n),
 *      a part of d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(gamma3), d(v_nu)/dtau, d(omega_tau)/dtau,
 *      a part of d(d(omega_tau)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_claim jlt_claims_spherical_top[];
extern const jlt_descriptor *const jlt_family_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_omega3;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_omega3_avx512;

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
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = t0/params[5]; /* R*I1/I3 */
    out[7] = t1;
    const double t2 = params[6]/t0; /* G_level/(R*I1) */
    out[8] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    out[32] = t4;
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    out[9] = t5;
    const double t6 = params[5]/params[4]; /* I3/I1 */
    out[10] = t6;
    const double t7 = params[5]/t0; /* I3/(R*I1) */
    out[11] = t7;
    const double t8 = params[5]*t4; /* I3*m*R*R */
    out[15] = t8;
    const double t9 = params[5]*params[5]; /* I3*I3 */
    const double t10 = t8 + t9; /* I3*m*R*R + I3*I3 */
    const double t11 = t10/t8; /* (I3*m*R*R + I3*I3)/(I3*m*R*R) */
    out[12] = t11;
    const double t12 = params[4]*params[5]; /* I1*I3 */
    out[13] = t12;
    const double t13 = params[4]*t4; /* I1*m*R*R */
    out[14] = t13;
    const double t14 = params[1]*2.0; /* R*2 */
    out[16] = t14;
    const double t15 = -t1; /* -R*I1/I3 */
    out[17] = t15;
    const double t16 = params[0]*2.0; /* m*2 */
    const double t17 = t3*t16; /* R*R*m*2 */
    const double t18 = params[5]*t17; /* I3*R*R*m*2 */
    out[18] = t18;
    const double t19 = params[4]*t10; /* I1*(I3*m*R*R + I3*I3) */
    const double t20 = t19/params[5]; /* I1*(I3*m*R*R + I3*I3)/I3 */
    out[19] = t20;
    const double t21 = params[1]*params[0]; /* R*m */
    const double t22 = params[5]*t21; /* I3*R*m */
    out[20] = t22;
    const double t23 = params[5]/params[1]; /* I3/R */
    const double t24 = t21 + t23; /* R*m + I3/R */
    const double t25 = t0*t24; /* R*I1*(R*m + I3/R) */
    out[21] = t25;
    const double t26 = -t22; /* -I3*R*m */
    out[22] = t26;
    const double t27 = t12 + t13; /* I1*I3 + I1*m*R*R */
    out[23] = t27;
    const double t28 = params[4]*t17; /* I1*R*R*m*2 */
    out[24] = t28;
    const double t29 = t10/t18; /* (I3*m*R*R + I3*I3)/(I3*R*R*m*2) */
    out[25] = t29;
    const double t30 = params[4]/2.0; /* I1/2 */
    out[26] = t30;
    const double t31 = params[0]/params[4]; /* m/I1 */
    out[27] = t31;
    const double t32 = params[4]/params[5]; /* I1/I3 */
    out[28] = t32;
    const double t33 = t4/params[4]; /* m*R*R/I1 */
    out[29] = t33;
    const double t34 = params[4]*params[4]; /* I1*I1 */
    const double t35 = params[0]*t34; /* m*I1*I1 */
    out[30] = t35;
    const double t36 = params[4] - params[5]; /* I1 - I3 */
    const double t37 = t13*t36; /* I1*m*R*R*(I1 - I3) */
    out[31] = t37;
    const double t38 = t34/params[5]; /* I1*I1/I3 */
    out[33] = t38;
    const double t39 = t13/params[5]; /* I1*m*R*R/I3 */
    out[34] = t39;
    const double t40 = params[0]*(-2.0); /* m*(-2) */
    const double t41 = t3*t40; /* R*R*m*(-2) */
    const double t42 = params[4]*t34; /* I1*I1*I1 */
    const double t43 = t41*t42; /* R*R*m*(-2)*I1*I1*I1 */
    const double t44 = t36*t43; /* (I1 - I3)*R*R*m*(-2)*I1*I1*I1 */
    const double t45 = t44/t9; /* (I1 - I3)*R*R*m*(-2)*I1*I1*I1/(I3*I3) */
    out[35] = t45;
    const double t46 = t16*t34; /* m*2*I1*I1 */
    out[36] = t46;
    const double t47 = params[1]*t16; /* R*m*2 */
    const double t48 = t34*t47; /* I1*I1*R*m*2 */
    out[37] = t48;
    const double t49 = t17*t42; /* R*R*m*2*I1*I1*I1 */
    const double t50 = t36*t49; /* (I1 - I3)*R*R*m*2*I1*I1*I1 */
    const double t51 = t50/t9; /* (I1 - I3)*R*R*m*2*I1*I1*I1/(I3*I3) */
    out[38] = t51;
    const double t52 = -t32; /* -I1/I3 */
    out[39] = t52;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[10]*x[0]; /* I3/I1*gamma3 */
    const double t1 = JLT_FMA(x[4], x[4], p[9]); /* s*s + I3/(m*R^2) */
    const double t2 = JLT_FMA(x[0], t0, t1); /* Theta/(m*R^2*I1) = gamma3*I3/I1*gamma3 + s*s + I3/(m*R^2) */
    const double t3 = x[0]*t2; /* gamma3*Theta/(m*R^2*I1) */
    const double t4 = 1.0/t3; /* 1/(gamma3*Theta/(m*R^2*I1)) */
    const double t5 = x[4]*x[3]; /* s*omega_n */
    const double t6 = p[8] - t5; /* G_level/(R*I1) - s*omega_n */
    const double t7 = t2*t6; /* Theta/(m*R^2*I1)*(G_level/(R*I1) - s*omega_n) */
    const double t8 = t4*t7; /* 1/(gamma3*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*(G_level/(R*I1) - s*omega_n) */
    const double t9 = x[0]*t4; /* 1/(Theta/(m*R^2*I1)) = gamma3*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t10 = t5*t8; /* s*omega_n*t8 */
    const double t11 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t12 = p[11]*t11; /* I3/(R*I1)*V */
    const double t13 = JLT_FNMA(t9, t12, x[2]); /* omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t14 = x[4]*x[2]; /* s*omega_tau */
    const double t15 = x[4]*t14; /* s*s*omega_tau */
    out[0] = t15;
    const double t16 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t17 = t13*t16; /* (omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V)*omega_n*gamma3 */
    const double t18 = x[3]*t16; /* omega_n*omega_n*gamma3 */
    const double t19 = t10 - t18; /* s*omega_n*t8 - omega_n*omega_n*gamma3 */
    out[2] = t19;
    const double t20 = p[7]*t10; /* R*I1/I3*s*omega_n*t8 */
    const double t21 = JLT_FMS(p[1], t18, t20); /* R*omega_n*omega_n*gamma3 - R*I1/I3*s*omega_n*t8 */
    out[1] = t21;
    const double t22 = p[12]*t14; /* (I3^2 + m*R^2*I3)/(m*R^2*I3)*s*omega_tau */
    const double t23 = t8*t22; /* t8*(I3^2 + m*R^2*I3)/(m*R^2*I3)*s*omega_tau */
    const double t24 = JLT_FNMA(t9, t23, t17); /* t17 - 1/(Theta/(m*R^2*I1))*t8*(I3^2 + m*R^2*I3)/(m*R^2*I3)*s*omega_tau */
    out[3] = t24;
    const double t25 = x[0]*t14; /* gamma3*s*omega_tau */
    const double t26 = -t25; /* -gamma3*s*omega_tau */
    out[4] = t26;
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
    const double t1 = JLT_FMA(p[14], t0, p[13]); /* m*R^2*I1*s*s + I1*I3 */
    const double t2 = p[15]*x[0]; /* m*R^2*I3*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* Theta = gamma3*m*R^2*I3*gamma3 + m*R^2*I1*s*s + I1*I3 */
    const double t4 = x[0]*t3; /* gamma3*Theta */
    const double t5 = 1.0/t4; /* 1/(gamma3*Theta) */
    const double t6 = t3*t5; /* 1/gamma3 = Theta*1/(gamma3*Theta) */
    const double t7 = x[0]*t5; /* 1/Theta = gamma3*1/(gamma3*Theta) */
    const double t8 = x[4]*x[3]; /* s*omega_n */
    const double t9 = p[8] - t8; /* G_level/(R*I1) - s*omega_n */
    const double t10 = t9 - t8; /* G_level/(R*I1) - s*omega_n - s*omega_n */
    const double t11 = x[4]*t6; /* s*1/gamma3 */
    const double t12 = t9*t11; /* (G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t13 = p[19]*t9; /* I1*(I3^2 + m*R^2*I3)/I3*(G_level/(R*I1) - s*omega_n) */
    const double t14 = p[19]*t12; /* I1*(I3^2 + m*R^2*I3)/I3*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t15 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t16 = p[20]*t15; /* m*R*I3*V */
    const double t17 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t18 = x[2]*t14; /* omega_tau*t14 */
    const double t19 = JLT_FMA(t16, t17, t18); /* m*R*I3*V*omega_n*gamma3 + omega_tau*t14 */
    const double t20 = t7*t19; /* 1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t14) */
    const double t21 = JLT_FMA(p[15], t17, t14); /* m*R^2*I3*omega_n*gamma3 + t14 */
    const double t22 = JLT_FNMA(t7, t21, t17); /* omega_n*gamma3 - 1/Theta*(m*R^2*I3*omega_n*gamma3 + t14) */
    out[17] = t22;
    const double t23 = x[2]*t6; /* omega_tau*1/gamma3 */
    const double t24 = x[3]*t6; /* omega_n*1/gamma3 */
    const double t25 = t13*t23; /* I1*(I3^2 + m*R^2*I3)/I3*(G_level/(R*I1) - s*omega_n)*omega_tau*1/gamma3 */
    const double t26 = p[21]*t23; /* R*I1*(m*R + I3/R)*omega_tau*1/gamma3 */
    const double t27 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t28 = x[3]*t16; /* omega_n*m*R*I3*V */
    const double t29 = JLT_FMS(t12, t26, t28); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = (G_level/(R*I1) - s*omega_n)*s*1/gamma3*R*I1*(m*R + I3/R)*omega_tau*1/gamma3 - omega_n*m*R*I3*V */
    const double t30 = t12*t24; /* (G_level/(R*I1) - s*omega_n)*s*1/gamma3*omega_n*1/gamma3 */
    const double t31 = x[0]*t16; /* gamma3*m*R*I3*V */
    const double t32 = t10*t24; /* (G_level/(R*I1) - s*omega_n - s*omega_n)*omega_n*1/gamma3 */
    out[14] = t32;
    const double t33 = p[17]*t32; /* (-R*I1/I3)*(G_level/(R*I1) - s*omega_n - s*omega_n)*omega_n*1/gamma3 */
    out[9] = t33;
    const double t34 = t10*t11; /* (G_level/(R*I1) - s*omega_n - s*omega_n)*s*1/gamma3 */
    const double t35 = p[23]*t11; /* (I1*I3 + m*R^2*I1)*s*1/gamma3 */
    const double t36 = JLT_FMS(t27, t35, t25); /* d(numerator of d(omega_n)/dt over Theta)/d(s) = omega_tau*omega_n*(I1*I3 + m*R^2*I1)*s*1/gamma3 - t25 */
    const double t37 = t7*t36; /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(s) */
    const double t38 = JLT_FNMA(2.0, t17, t34); /* (G_level/(R*I1) - s*omega_n - s*omega_n)*s*1/gamma3 - 2*omega_n*gamma3 */
    out[13] = t38;
    const double t39 = p[7]*t34; /* R*I1/I3*(G_level/(R*I1) - s*omega_n - s*omega_n)*s*1/gamma3 */
    const double t40 = JLT_FMS(p[16], t17, t39); /* 2*R*omega_n*gamma3 - R*I1/I3*(G_level/(R*I1) - s*omega_n - s*omega_n)*s*1/gamma3 */
    out[8] = t40;
    const double t41 = p[22]*t17; /* (-m*R*I3)*omega_n*gamma3 */
    const double t42 = t7*t41; /* 1/Theta*(-m*R*I3)*omega_n*gamma3 */
    out[16] = t42;
    const double t43 = x[4]*x[2]; /* s*omega_tau */
    const double t44 = JLT_FMS(t35, t43, t31); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = (I1*I3 + m*R^2*I1)*s*1/gamma3*s*omega_tau - gamma3*m*R*I3*V */
    const double t45 = 2.0*t43; /* 2*s*omega_tau */
    out[4] = t45;
    const double t46 = -t43; /* -s*omega_tau */
    out[20] = t46;
    const double t47 = x[3]*x[3]; /* omega_n*omega_n */
    const double t48 = x[0]*p[18]; /* gamma3*2*m*R^2*I3 */
    const double t49 = JLT_FMA(t20, t48, t29); /* 1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t14)*gamma3*2*m*R^2*I3 + d(numerator of d(omega_n)/dt over Theta)/d(gamma3) */
    const double t50 = JLT_FMA(t7, t49, t27); /* 1/Theta*t49 + omega_tau*omega_n */
    out[15] = t50;
    const double t51 = x[4]*p[24]; /* s*2*m*R^2*I1 */
    const double t52 = t7*t51; /* 1/Theta*s*2*m*R^2*I1 */
    const double t53 = JLT_FMA(t20, t52, t37); /* 1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t14)*1/Theta*s*2*m*R^2*I1 + 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(s) */
    out[19] = t53;
    const double t54 = p[1]*t47; /* R*omega_n*omega_n */
    const double t55 = JLT_FMA(p[7], t30, t54); /* R*I1/I3*(G_level/(R*I1) - s*omega_n)*s*1/gamma3*omega_n*1/gamma3 + R*omega_n*omega_n */
    out[5] = t55;
    const double t56 = t30 + t47; /* (G_level/(R*I1) - s*omega_n)*s*1/gamma3*omega_n*1/gamma3 + omega_n*omega_n */
    const double t57 = -t56; /* -t56 */
    out[10] = t57;
    const double t58 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t59 = JLT_FMA(t7, t44, t58); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_n) + omega_tau*gamma3 */
    out[18] = t59;
    const double t60 = -t58; /* -omega_tau*gamma3 */
    out[24] = t60;
    const double t61 = x[4]*x[0]; /* s*gamma3 */
    const double t62 = -t61; /* -s*gamma3 */
    out[22] = t62;
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
    const double t1 = JLT_FMA(p[14], t0, p[13]); /* m*R^2*I1*s*s + I1*I3 */
    const double t2 = p[15]*x[0]; /* m*R^2*I3*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* Theta = gamma3*m*R^2*I3*gamma3 + m*R^2*I1*s*s + I1*I3 */
    const double t4 = x[0]*t3; /* gamma3*Theta */
    const double t5 = 1.0/t4; /* 1/(gamma3*Theta) */
    const double t6 = t3*t5; /* 1/gamma3 = Theta*1/(gamma3*Theta) */
    const double t7 = x[0]*t5; /* 1/Theta = gamma3*1/(gamma3*Theta) */
    const double t8 = x[4]*x[3]; /* s*omega_n */
    const double t9 = p[8] - t8; /* G_level/(R*I1) - s*omega_n */
    const double t10 = t9 - t8; /* G_level/(R*I1) - s*omega_n - s*omega_n */
    const double t11 = t6*t10; /* 1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t12 = x[4]*t6; /* s*1/gamma3 */
    const double t13 = t9*t12; /* (G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t14 = p[23]*t12; /* (I1*I3 + m*R^2*I1)*s*1/gamma3 */
    const double t15 = p[25]*t9; /* 1/2*(I3^2 + m*R^2*I3)/(m*R^2*I3)*(G_level/(R*I1) - s*omega_n) */
    const double t16 = p[19]*t13; /* I1*(I3^2 + m*R^2*I3)/I3*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t18 = p[20]*t17; /* m*R*I3*V */
    const double t19 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t20 = x[2]*t16; /* omega_tau*t16 */
    const double t21 = JLT_FMA(t18, t19, t20); /* m*R*I3*V*omega_n*gamma3 + omega_tau*t16 */
    const double t22 = t7*t21; /* 1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t16) */
    const double t23 = JLT_FMA(p[15], t19, t16); /* m*R^2*I3*omega_n*gamma3 + t16 */
    const double t24 = JLT_FNMA(t7, t23, t19); /* omega_n*gamma3 - 1/Theta*(m*R^2*I3*omega_n*gamma3 + t16) */
    out[22] = t24;
    const double t25 = JLT_FMS(x[2], t19, t22); /* omega_tau*omega_n*gamma3 - 1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t16) */
    out[3] = t25;
    const double t26 = x[2]*t6; /* omega_tau*1/gamma3 */
    const double t27 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t28 = x[3]*t18; /* omega_n*m*R*I3*V */
    const double t29 = x[0]*t18; /* gamma3*m*R*I3*V */
    const double t30 = p[21]*t26; /* R*I1*(m*R + I3/R)*omega_tau*1/gamma3 */
    const double t31 = JLT_FMS(t13, t30, t28); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = (G_level/(R*I1) - s*omega_n)*s*1/gamma3*R*I1*(m*R + I3/R)*omega_tau*1/gamma3 - omega_n*m*R*I3*V */
    const double t32 = x[3]*t13; /* omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t33 = x[4]*t22; /* s*1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t16) */
    const double t34 = JLT_FNMA(t15, t26, t33); /* s*1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t16) - t15*omega_tau*1/gamma3 */
    const double t35 = x[4]*x[2]; /* s*omega_tau */
    const double t36 = JLT_FMS(t14, t35, t29); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = (I1*I3 + m*R^2*I1)*s*1/gamma3*s*omega_tau - gamma3*m*R*I3*V */
    const double t37 = t14*t27; /* (I1*I3 + m*R^2*I1)*s*1/gamma3*omega_tau*omega_n */
    const double t38 = JLT_FMA(p[24], t34, t37); /* 2*m*R^2*I1*t34 + (I1*I3 + m*R^2*I1)*s*1/gamma3*omega_tau*omega_n */
    const double t39 = t7*t38; /* 1/Theta*t38 */
    out[24] = t39;
    const double t40 = x[4]*t35; /* s*s*omega_tau */
    out[0] = t40;
    const double t41 = 2.0*t35; /* 2*s*omega_tau */
    out[9] = t41;
    const double t42 = -t35; /* -s*omega_tau */
    out[25] = t42;
    const double t43 = x[0]*t35; /* gamma3*s*omega_tau */
    const double t44 = -t43; /* -gamma3*s*omega_tau */
    out[4] = t44;
    const double t45 = x[3]*x[3]; /* omega_n*omega_n */
    const double t46 = x[4]*t11; /* s*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t47 = x[3]*t11; /* omega_n*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[19] = t47;
    const double t48 = p[17]*t47; /* (-R*I1/I3)*omega_n*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[14] = t48;
    const double t49 = JLT_FNMA(2.0, t19, t46); /* s*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) - 2*omega_n*gamma3 */
    out[18] = t49;
    const double t50 = p[7]*t46; /* R*I1/I3*s*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t51 = JLT_FMS(p[16], t19, t50); /* 2*R*omega_n*gamma3 - R*I1/I3*s*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[13] = t51;
    const double t52 = x[0]*p[18]; /* gamma3*2*m*R^2*I3 */
    const double t53 = JLT_FMA(t22, t52, t31); /* 1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t16)*gamma3*2*m*R^2*I3 + d(numerator of d(omega_n)/dt over Theta)/d(gamma3) */
    const double t54 = JLT_FMA(t7, t53, t27); /* 1/Theta*t53 + omega_tau*omega_n */
    out[20] = t54;
    const double t55 = p[7]*t32; /* R*I1/I3*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t56 = x[3]*t19; /* omega_n*omega_n*gamma3 */
    const double t57 = p[22]*t19; /* (-m*R*I3)*omega_n*gamma3 */
    const double t58 = t7*t57; /* 1/Theta*(-m*R*I3)*omega_n*gamma3 */
    out[21] = t58;
    const double t59 = JLT_FMS(p[1], t56, t55); /* R*omega_n*omega_n*gamma3 - R*I1/I3*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    out[1] = t59;
    const double t60 = t32 - t56; /* omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 - omega_n*omega_n*gamma3 */
    out[2] = t60;
    const double t61 = JLT_FMA(t6, t32, t45); /* 1/gamma3*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 + omega_n*omega_n */
    const double t62 = -t61; /* -t61 */
    out[15] = t62;
    const double t63 = p[1]*t45; /* R*omega_n*omega_n */
    const double t64 = JLT_FMA(t6, t55, t63); /* 1/gamma3*R*I1/I3*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 + R*omega_n*omega_n */
    out[10] = t64;
    const double t65 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t66 = JLT_FMA(t7, t36, t65); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_n) + omega_tau*gamma3 */
    out[23] = t66;
    const double t67 = -t65; /* -omega_tau*gamma3 */
    out[29] = t67;
    const double t68 = x[4]*x[0]; /* s*gamma3 */
    const double t69 = -t68; /* -s*gamma3 */
    out[27] = t69;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[0]*p[15]; /* gamma3*m*R^2*I3 */
    const double t2 = JLT_FMA(p[14], t0, p[13]); /* m*R^2*I1*s*s + I1*I3 */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta = gamma3*gamma3*m*R^2*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t4 = x[0]*t3; /* gamma3*Theta */
    const double t5 = 1.0/t4; /* 1/(gamma3*Theta) */
    const double t6 = x[2]*p[23]; /* omega_tau*(I1*I3 + m*R^2*I1) */
    const double t7 = t0*t6; /* s*s*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t8 = t3*t7; /* Theta*s*s*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t9 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t10 = x[0]*p[20]; /* gamma3*m*R*I3 */
    const double t11 = t9*t10; /* V*gamma3*m*R*I3 */
    const double t12 = JLT_FMS(t5, t8, t11); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = 1/(gamma3*Theta)*Theta*s*s*omega_tau*(I1*I3 + m*R^2*I1) - V*gamma3*m*R*I3 */
    const double t13 = x[0]*t5; /* gamma3*1/(gamma3*Theta) */
    const double t14 = t12*t13; /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n)*gamma3*1/(gamma3*Theta) */
    out[0] = t14;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[27]*x[1]; /* m/I1*v_nu */
    const double t1 = x[3]*x[3]; /* omega_n*omega_n */
    const double t2 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t3 = p[28]*t2; /* I1/I3*(G_level/(R*I1) - omega_n*s) */
    const double t4 = t3/x[0]; /* I1/I3*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t5 = t4*t4; /* I1/I3*(G_level/(R*I1) - omega_n*s)/gamma3*I1/I3*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t6 = x[4]*t4; /* s*I1/I3*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t7 = JLT_FMS(x[3], x[0], t6); /* v_tau/R = omega_n*gamma3 - s*I1/I3*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t8 = p[29]*t7; /* m*R^2/I1*v_tau/R */
    const double t9 = JLT_FMA(x[2], x[2], t1); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t10 = JLT_FMA(x[1], t0, t9); /* v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t11 = JLT_FMA(p[10], t5, t10); /* I3/I1*t5 + v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t12 = JLT_FMA(t7, t8, t11); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t11 */
    const double t13 = p[26]*t12; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t13;
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t15 = p[30]*t14; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t16 = t14*t15; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t17 = p[10]*x[0]; /* I3/I1*gamma3 */
    const double t18 = JLT_FMA(x[4], x[4], p[9]); /* s*s + I3/(m*R^2) */
    const double t19 = JLT_FMA(x[0], t17, t18); /* Theta/(m*R^2*I1) = gamma3*I3/I1*gamma3 + s*s + I3/(m*R^2) */
    const double t20 = p[31]*t19; /* m*R^2*I1*(I1 - I3)*Theta/(m*R^2*I1) */
    const double t21 = JLT_FMA(t5, t20, t16); /* t5*m*R^2*I1*(I1 - I3)*Theta/(m*R^2*I1) + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[0]; /* 1/gamma3 */
    const double t1 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t2 = t0*t1; /* 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t3 = t0*t2; /* 1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t4 = x[4]*t3; /* s*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t5 = JLT_FMA(p[28], t4, x[3]); /* d(v_tau)/d(gamma3)/R = I1/I3*s*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) + omega_n */
    const double t6 = p[28]*x[4]; /* I1/I3*s */
    const double t7 = t2*t6; /* 1/gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*s */
    const double t8 = JLT_FMS(x[3], x[0], t7); /* v_tau/R = omega_n*gamma3 - 1/gamma3*(G_level/(R*I1) - omega_n*s)*I1/I3*s */
    const double t9 = p[32]*t8; /* m*R^2*v_tau/R */
    const double t10 = t5*t9; /* d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R */
    const double t11 = t2*t3; /* 1/gamma3*(G_level/(R*I1) - omega_n*s)*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t12 = JLT_FNMA(p[33], t11, t10); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R - I1^2/I3*t11 */
    out[0] = t12;
    const double t13 = p[0]*x[1]; /* m*v_nu */
    out[1] = t13;
    const double t14 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t14;
    const double t15 = x[3]*p[4]; /* omega_n*I1 */
    const double t16 = x[4]*t0; /* s*1/gamma3 */
    const double t17 = JLT_FMA(t6, t16, x[0]); /* d(v_tau)/d(omega_n)/R = I1/I3*s*s*1/gamma3 + gamma3 */
    const double t18 = JLT_FNMA(t4, p[33], t15); /* omega_n*I1 - s*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s)*I1^2/I3 */
    const double t19 = JLT_FMA(t9, t17, t18); /* d(energy)/d(omega_n) = m*R^2*v_tau/R*d(v_tau)/d(omega_n)/R + t18 */
    out[3] = t19;
    const double t20 = JLT_FMS(x[3], t16, t2); /* omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t21 = t8*p[34]; /* v_tau/R*m*R^2*I1/I3 */
    const double t22 = t20*t21; /* (omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - omega_n*s))*v_tau/R*m*R^2*I1/I3 */
    const double t23 = x[3]*t3; /* omega_n*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t24 = JLT_FNMA(p[33], t23, t22); /* d(energy)/d(s) = t22 - I1^2/I3*omega_n*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    out[4] = t24;
    const double t25 = JLT_FMA(x[4], x[4], p[9]); /* s*s + I3/(m*R^2) */
    const double t26 = p[35]*t25; /* (-2*m*R^2*I1^3*(I1 - I3)/I3^2)*(s*s + I3/(m*R^2)) */
    const double t27 = t11*t26; /* t11*(-2*m*R^2*I1^3*(I1 - I3)/I3^2)*(s*s + I3/(m*R^2)) */
    out[5] = t27;
    const double t28 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t29 = p[36]*t28; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[6] = t29;
    const double t30 = t28*p[37]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[7] = t30;
    const double t31 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t32 = JLT_FMA(x[0], t31, t25); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t33 = p[35]*t32; /* (-2*m*R^2*I1^3*(I1 - I3)/I3^2)*Theta/(m*R^2*I1) */
    const double t34 = t4*t33; /* s*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s)*(-2*m*R^2*I1^3*(I1 - I3)/I3^2)*Theta/(m*R^2*I1) */
    out[8] = t34;
    const double t35 = x[4]*t2; /* s*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t36 = t2*t35; /* 1/gamma3*(G_level/(R*I1) - omega_n*s)*s*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t37 = JLT_FNMA(t23, t32, t36); /* t36 - omega_n*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s)*Theta/(m*R^2*I1) */
    const double t38 = p[38]*t37; /* 2*m*R^2*I1^3*(I1 - I3)/I3^2*t37 */
    out[9] = t38;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t1 = p[39]*t0; /* (-I1/I3)*(G_level/(R*I1) - omega_n*s) */
    const double t2 = t1/x[0]; /* (-I1/I3)*(G_level/(R*I1) - omega_n*s)/gamma3 */
    out[0] = t2;
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
    double t6[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t6[k] = jlt_jet_product(x4, x3, k);
        t9[k] = (k == 0 ? p[8] : 0) - t6[k];
        t10[k] = jlt_jet_quotient(t9[k], x0, t10, k);
        t11[k] = jlt_jet_product(t6, t10, k);
        t12[k] = p[7]*t11[k];
        t14[k] = jlt_jet_product(x3, x0, k);
        t15[k] = jlt_jet_product(x3, t14, k);
        t16[k] = p[1]*t15[k] - t12[k];
        t17[k] = t11[k] - t15[k];
        t20[k] = x0[k]*p[10];
        t21[k] = jlt_jet_product(x4, x4, k) + (k == 0 ? p[9] : 0);
        t22[k] = jlt_jet_product(x0, t20, k) + t21[k];
        t25[k] = x2[k]*p[1] + x1[k];
        t26[k] = t14[k]*p[11];
        t27[k] = jlt_jet_product(t25, t26, k);
        t29[k] = t2[k]*p[12];
        t30[k] = jlt_jet_product(t10, t29, k) + t27[k];
        t31[k] = jlt_jet_quotient(t30[k], t22, t31, k);
        t32[k] = jlt_jet_product(x2, t14, k) - t31[k];
        t33[k] = jlt_jet_product(t2, x0, k);
        t34[k] = -t33[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t16[k]/(k + 1);
        next[2] = x2[k + 1] = t17[k]/(k + 1);
        next[3] = x3[k + 1] = t32[k]/(k + 1);
        next[4] = x4[k + 1] = t34[k]/(k + 1);
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

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    out[3] = x[3];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[4] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = t1 + t2; /* -1 + gamma3*gamma3 + s*s */
    out[0] = t3;
}

static void root_relation_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = 2.0*x[0]; /* 2*gamma3 */
    out[0] = t0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
    const double t1 = 2.0*x[4]; /* 2*s */
    out[4] = t1;
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_omega3 = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "regular",
    .elimination = "level_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 7, .prepared_count = 40,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 17, 6, 1, 0, 0, 8, 7 }, { 11, 49, 0, 5, 0, 0, 11, 7 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n, V = omega_tau*R + v_nu, omega_tau - 1/(Theta/(m*R^2*I1))*(I3/(R*I1))*V, d(omega_tau)/dtau, d(v_nu)/dtau, d(omega_n)/dtau" },
    .jacobian = { jacobian, 25, { 7, 39, 16, 1, 0, 0, 14, 13 }, { 41, 216, 0, 29, 0, 0, 15, 8 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n, G_level/(R*I1) - s*omega_n - s*omega_n, V = omega_tau*R + v_nu, a part of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s), a part of d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_tau), d(numerator of d(omega_n)/dt over Theta)/d(gamma3), d(numerator of d(omega_n)/dt over Theta)/d(s), d(d(omega_tau)/dtau)/d(omega_n), d(d(v_nu)/dtau)/d(omega_n), d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = (I1*I3 + m*R^2*I1)*s*1/gamma3*s*omega_tau - gamma3*(m*R*I3)*V, a part of d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(s), d(d(v_nu)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 8, 42, 19, 1, 0, 0, 16, 14 }, { 48, 248, 0, 33, 0, 0, 15, 8 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n, G_level/(R*I1) - s*omega_n - s*omega_n, V = omega_tau*R + v_nu, a part of d(omega_n)/dtau and of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s), a part of d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_tau), d(omega_n)/dtau, d(numerator of d(omega_n)/dt over Theta)/d(gamma3), a part of d(d(omega_n)/dtau)/d(s), d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = (I1*I3 + m*R^2*I1)*s*1/gamma3*s*omega_tau - gamma3*(m*R*I3)*V, a part of d(d(omega_n)/dtau)/d(s), d(d(omega_tau)/dtau)/d(omega_n), d(d(v_nu)/dtau)/d(omega_n), a part of d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(gamma3), d(v_nu)/dtau, d(omega_tau)/dtau, a part of d(d(omega_tau)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n)" },
    .divergence = { divergence, 1, { 0, 10, 4, 1, 0, 0, 7, 5 }, { 5, 28, 0, 3, 0, 0, 10, 5 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in V = R*omega_tau + v_nu, d(numerator of d(omega_n)/dt over Theta)/d(omega_n)" },
    .integral_values = { integral_values, 2, { 0, 11, 10, 1, 0, 0, 8, 6 }, { 11, 43, 0, 1, 0, 0, 13, 6 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, v_tau/R = omega_n*gamma3 - s*((I1/I3)*(G_level/(R*I1) - omega_n*s)/gamma3), omega_tau*R + v_nu, F0" },
    .integral_gradients = { integral_gradients, 10, { 0, 25, 13, 1, 0, 0, 7, 10 }, { 23, 105, 0, 10, 0, 0, 12, 9 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, d(v_tau)/d(gamma3)/R, v_tau/R = omega_n*gamma3 - ((1)/gamma3)*(G_level/(R*I1) - omega_n*s)*(I1/I3)*s, d(E)/d(gamma3), d(E)/d(omega_n), omega_n*s*((1)/gamma3) - ((1)/gamma3)*(G_level/(R*I1) - omega_n*s), d(E)/d(s), omega_tau*R + v_nu, a part of d(F0)/d(s)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 1, 1, 1, 0, 0, 3, 2 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by gamma3: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .eliminated_state = 4, .level_integral = 1,
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular_on_level_omega3,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_balanced_in_regular_on_level_omega3) },
#endif
};
