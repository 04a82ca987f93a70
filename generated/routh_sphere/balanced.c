/* Sphere with displaced centre of mass rolling without slipping, reduced system
 *
 *  Source:     E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243
 *  Variant:    balanced: a3 = 0
 *  Table:      routh_sphere, SHA-256 3411ed6d53d99c328220ac4c0d992bf489a81f74d3bcee4f47f68fdd4a704bc2
 *  Command:    ttc generate --effort full --out DIR routh_sphere.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   16    4    1    1    0     10    5   (65)
 *  jacobian            7   32    8    1    1    0     14   13   (196)
 *  rhs_jacobian        8   33    8    1    1    0     15   12   (237)
 *  divergence          3    5    1    1    1    0      5    4   (24)
 *  integral_values     2   10    8    0    2    0      7    5   (47)
 *  integral_gradients  2   16    7    1    2    0      9    6   (71)
 *  measure_values      2    3    2    0    1    0      5    4   (21)
 *  measure_divergences 2    7    2    1    2    0      6    4   (47)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2),
 *      2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), a part of d(omega_tau)/dt, a part of d(d(omega_tau)/dt)/d(omega_n),
 *      d(d(omega_n)/dt)/d(omega_tau), a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3),
 *      d(d(omega3)/dt)/d(gamma3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_routh_sphere[];
extern const jlt_claim jlt_claims_routh_sphere[];
extern const jlt_descriptor *const jlt_family_routh_sphere[];
extern const jlt_descriptor jlt_kernels_routh_sphere_balanced;
extern const struct jlt_ball_table jlt_balls_routh_sphere_general;
extern const jlt_kernel_batch jlt_batch_routh_sphere_balanced_baseline;
extern const jlt_kernel_batch jlt_batch_routh_sphere_balanced_avx2;
extern const jlt_kernel_batch jlt_batch_routh_sphere_balanced_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
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
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    out[31] = t1;
    const double t2 = params[4] + t1; /* K = I1 + m*R*R */
    out[32] = t2;
    out[36] = t2;
    const double t3 = params[4]/t2; /* I1/K */
    out[16] = t3;
    const double t4 = t1/t2; /* m*R*R/K */
    out[15] = t4;
    const double t5 = t3 + t4; /* I1/K + m*R*R/K */
    out[6] = t5;
    const double t6 = params[4]*params[5]; /* I1*I3 */
    out[7] = t6;
    const double t7 = params[4]*t1; /* I1*m*R*R */
    out[8] = t7;
    const double t8 = t1*params[5]; /* m*R*R*I3 */
    out[9] = t8;
    const double t9 = params[5]/t2; /* I3/K */
    out[38] = t9;
    const double t10 = t4 + t9; /* m*R*R/K + I3/K */
    out[10] = t10;
    const double t11 = params[5]*params[5]; /* I3*I3 */
    const double t12 = t8 + t11; /* m*R*R*I3 + I3*I3 */
    out[11] = t12;
    const double t13 = params[4] - params[5]; /* I1 - I3 */
    const double t14 = t1*t13; /* m*R*R*(I1 - I3) */
    out[12] = t14;
    const double t15 = params[5]/t1; /* I3/(m*R*R) */
    out[13] = t15;
    const double t16 = params[5]/params[4]; /* I3/I1 */
    out[14] = t16;
    const double t17 = t3*2.0; /* I1/K*2 */
    const double t18 = -t17; /* -I1/K*2 */
    const double t19 = t4*2.0; /* m*R*R/K*2 */
    const double t20 = t18 - t19; /* -I1/K*2 - m*R*R/K*2 */
    out[17] = t20;
    const double t21 = -t9; /* -I3/K */
    out[18] = t21;
    const double t22 = -t4; /* -m*R*R/K */
    out[19] = t22;
    const double t23 = t21 - t4; /* -I3/K - m*R*R/K */
    out[20] = t23;
    const double t24 = t7 - t8; /* I1*m*R*R - m*R*R*I3 */
    const double t25 = 2.0*t24; /* 2*(I1*m*R*R - m*R*R*I3) */
    const double t26 = t25/t7; /* 2*(I1*m*R*R - m*R*R*I3)/(I1*m*R*R) */
    out[21] = t26;
    const double t27 = t12/t7; /* (m*R*R*I3 + I3*I3)/(I1*m*R*R) */
    out[22] = t27;
    const double t28 = t13/params[4]; /* (I1 - I3)/I1 */
    out[23] = t28;
    const double t29 = t17 + t19; /* I1/K*2 + m*R*R/K*2 */
    out[24] = t29;
    const double t30 = params[0]*params[0]; /* m*m */
    const double t31 = t0*t0; /* R*R*R*R */
    const double t32 = t30*t31; /* m*m*R*R*R*R */
    const double t33 = params[4]*params[4]; /* I1*I1 */
    const double t34 = t32*t33; /* m*m*R*R*R*R*I1*I1 */
    const double t35 = t12*2.0; /* (m*R*R*I3 + I3*I3)*2 */
    const double t36 = t24*t35; /* (I1*m*R*R - m*R*R*I3)*(m*R*R*I3 + I3*I3)*2 */
    const double t37 = t36/t34; /* (I1*m*R*R - m*R*R*I3)*(m*R*R*I3 + I3*I3)*2/(m*m*R*R*R*R*I1*I1) */
    out[25] = t37;
    const double t38 = params[4]/2.0; /* I1/2 */
    out[26] = t38;
    const double t39 = params[5]/2.0; /* I3/2 */
    out[27] = t39;
    const double t40 = t1/2.0; /* m*R*R/2 */
    out[28] = t40;
    const double t41 = params[4]*params[1]; /* I1*R */
    out[29] = t41;
    const double t42 = params[1]*params[5]; /* R*I3 */
    out[30] = t42;
    const double t43 = -t41; /* -I1*R */
    out[33] = t43;
    const double t44 = -t42; /* -R*I3 */
    out[34] = t44;
    const double t45 = t8 - t7; /* m*R*R*I3 - I1*m*R*R */
    out[35] = t45;
    const double t46 = t24 - t14; /* I1*m*R*R - m*R*R*I3 - m*R*R*(I1 - I3) */
    const double t47 = t2*t46; /* K*(I1*m*R*R - m*R*R*I3 - m*R*R*(I1 - I3)) */
    const double t48 = -t47; /* -K*(I1*m*R*R - m*R*R*I3 - m*R*R*(I1 - I3)) */
    out[37] = t48;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[9]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[7]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(p[8], t2, t4); /* Theta = m*R^2*I1*s^2 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = t2*t5; /* s^2*Theta */
    const double t7 = 1.0/t6; /* 1/(s^2*Theta) */
    const double t8 = x[0]*x[2]; /* gamma3*omega_n */
    const double t9 = t5*t8; /* Theta*gamma3*omega_n */
    const double t10 = sqrt(t2); /* s = sqrt(s^2) */
    const double t11 = t9*t10; /* Theta*gamma3*omega_n*s */
    const double t12 = t7*t11; /* 1/(s^2*Theta)*Theta*gamma3*omega_n*s */
    const double t13 = x[3]*t2; /* omega3*s^2 */
    const double t14 = t7*t13; /* 1/(s^2*Theta)*omega3*s^2 */
    const double t15 = x[1]*t10; /* omega_tau*s */
    out[0] = t15;
    const double t16 = p[6]*t12; /* (I1/K + m*R^2/K)*1/(s^2*Theta)*Theta*gamma3*omega_n*s */
    const double t17 = JLT_FMA(p[10], x[3], t16); /* (I3/K + m*R^2/K)*omega3 + (I1/K + m*R^2/K)*1/(s^2*Theta)*Theta*gamma3*omega_n*s */
    const double t18 = x[2]*t17; /* omega_n*t17 */
    const double t19 = -t18; /* -omega_n*t17 */
    out[1] = t19;
    const double t20 = JLT_FMA(p[11], t14, t12); /* (I3^2 + m*R^2*I3)*1/(s^2*Theta)*omega3*s^2 + 1/(s^2*Theta)*Theta*gamma3*omega_n*s */
    const double t21 = x[1]*t20; /* omega_tau*t20 */
    out[2] = t21;
    const double t22 = x[0]*p[12]; /* gamma3*m*R^2*(I1 - I3) */
    const double t23 = t15*t22; /* omega_tau*s*gamma3*m*R^2*(I1 - I3) */
    const double t24 = t14*t23; /* 1/(s^2*Theta)*omega3*s^2*omega_tau*s*gamma3*m*R^2*(I1 - I3) */
    out[3] = t24;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[1] = t3;
    const double t4 = x[0]*p[14]; /* gamma3*I3/I1 */
    const double t5 = t2 + p[13]; /* s^2 + I3/(m*R^2) */
    const double t6 = JLT_FMA(x[0], t4, t5); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s^2 + I3/(m*R^2) */
    const double t7 = t2*t6; /* s^2*Theta/(m*R^2*I1) */
    const double t8 = 1.0/t7; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t9 = t3*t6; /* s*Theta/(m*R^2*I1) */
    const double t10 = t8*t9; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1) */
    const double t11 = x[0]*t10; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1) */
    const double t12 = x[1]*t11; /* omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1) */
    out[10] = t12;
    const double t13 = -t12; /* -omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1) */
    out[0] = t13;
    out[2] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[14] = 0.0;
    const double t14 = t10*x[2]; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega_n */
    const double t15 = t11*x[3]; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega3 */
    const double t16 = x[0]*t14; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega_n */
    const double t17 = t3*x[3]; /* s*omega3 */
    const double t18 = t10*t17; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*s*omega3 */
    const double t19 = t16 + t18; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega_n + 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*s*omega3 */
    const double t20 = t15 - x[2]; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega3 - omega_n */
    const double t21 = JLT_FNMA(t11, t19, t20); /* t20 - gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t19 */
    const double t22 = p[15]*t21; /* m*R^2/K*(t20 - gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t19) */
    const double t23 = t10*t14; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega_n */
    const double t24 = JLT_FNMA(p[16], t23, t22); /* t22 - I1/K*t23 */
    const double t25 = t14*t24; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega_n*(t22 - I1/K*t23) */
    out[4] = t25;
    const double t26 = x[3]*p[18]; /* omega3*(-I3/K) */
    const double t27 = JLT_FMA(t18, p[19], t26); /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*s*omega3*(-m*R^2/K) + omega3*(-I3/K) */
    const double t28 = JLT_FMA(t16, p[17], t27); /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega_n*(-2*I1/K - 2*m*R^2/K) + t27 */
    out[6] = t28;
    const double t29 = x[2]*p[20]; /* omega_n*(-I3/K - m*R^2/K) */
    out[7] = t29;
    const double t30 = t10*t23; /* 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t23 */
    const double t31 = t2*t8; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t32 = x[0]*p[21]; /* gamma3*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t33 = t31*t32; /* 1/(Theta/(m*R^2*I1))*gamma3*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t34 = t31*p[22]; /* 1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t35 = x[3]*t34; /* omega3*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t36 = JLT_FMA(t33, t35, t30); /* t33*omega3*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) + 1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*t23 */
    const double t37 = x[1]*t36; /* omega_tau*t36 */
    out[8] = t37;
    const double t38 = t16 + t35; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega_n + omega3*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    out[9] = t38;
    const double t39 = x[1]*t34; /* omega_tau*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    out[11] = t39;
    const double t40 = t31*p[23]; /* 1/(Theta/(m*R^2*I1))*(I1 - I3)/I1 */
    const double t41 = x[0]*t40; /* gamma3*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1 */
    const double t42 = JLT_FMA(t33, t41, t40); /* t33*gamma3*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1 + 1/(Theta/(m*R^2*I1))*(I1 - I3)/I1 */
    const double t43 = x[1]*t17; /* omega_tau*s*omega3 */
    const double t44 = t42*t43; /* t42*omega_tau*s*omega3 */
    const double t45 = x[1]*t41; /* omega_tau*gamma3*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1 */
    const double t46 = JLT_FNMA(t15, t45, t44); /* t42*omega_tau*s*omega3 - gamma3*1/(s^2*Theta/(m*R^2*I1))*s*Theta/(m*R^2*I1)*omega3*omega_tau*gamma3*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1 */
    out[12] = t46;
    const double t47 = t17*t41; /* s*omega3*gamma3*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1 */
    out[13] = t47;
    const double t48 = t3*t45; /* s*omega_tau*gamma3*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1 */
    out[15] = t48;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[18] = 0.0;
    const double t0 = x[2]*p[20]; /* omega_n*(-I3/K - m*R^2/K) */
    out[11] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t4 = x[0]*p[14]; /* gamma3*I3/I1 */
    const double t5 = p[13] + t3; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(x[0], t4, t5); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t7 = t3*t6; /* s^2*Theta/(m*R^2*I1) */
    const double t8 = 1.0/t7; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t9 = sqrt(t3); /* s = sqrt(s^2) */
    out[5] = t9;
    const double t10 = t6*t9; /* Theta/(m*R^2*I1)*s */
    const double t11 = t8*t10; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t12 = t3*t8; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t13 = x[0]*t11; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t14 = x[2]*t13; /* omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t15 = t13*t14; /* gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t16 = -t15; /* -t15 */
    const double t17 = t16 - x[2]; /* -t15 - omega_n */
    const double t18 = x[1]*t13; /* omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    out[14] = t18;
    const double t19 = p[15]*t17; /* m*R^2/K*(-t15 - omega_n) */
    const double t20 = -t18; /* -omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    out[4] = t20;
    const double t21 = x[2]*t11; /* omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t22 = x[1]*t9; /* omega_tau*s */
    out[0] = t22;
    const double t23 = p[10]*x[3]; /* (I3/K + m*R^2/K)*omega3 */
    const double t24 = x[3]*t12; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t25 = t11*t21; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t26 = t11*t25; /* 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t25 */
    const double t27 = JLT_FNMA(p[16], t25, t19); /* m*R^2/K*(-t15 - omega_n) - I1/K*t25 */
    const double t28 = t21*t27; /* omega_n*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*(m*R^2/K*(-t15 - omega_n) - I1/K*t25) */
    out[8] = t28;
    const double t29 = x[0]*t12; /* gamma3*1/(Theta/(m*R^2*I1)) */
    const double t30 = JLT_FMA(p[6], t14, t23); /* (I1/K + m*R^2/K)*omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s + (I3/K + m*R^2/K)*omega3 */
    const double t31 = x[2]*t30; /* omega_n*t30 */
    const double t32 = -t31; /* -omega_n*t30 */
    out[1] = t32;
    const double t33 = JLT_FMA(p[24], t14, t23); /* (2*I1/K + 2*m*R^2/K)*omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s + (I3/K + m*R^2/K)*omega3 */
    const double t34 = -t33; /* -t33 */
    out[10] = t34;
    const double t35 = JLT_FMA(p[22], t24, t14); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega3*1/(Theta/(m*R^2*I1)) + omega_n*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    out[13] = t35;
    const double t36 = x[1]*t35; /* omega_tau*t35 */
    out[2] = t36;
    const double t37 = p[23]*t24; /* (I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) */
    const double t38 = p[25]*t29; /* 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t39 = JLT_FMA(t24, t38, t26); /* omega3*1/(Theta/(m*R^2*I1))*t38 + 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t25 */
    const double t40 = x[1]*t39; /* omega_tau*t39 */
    out[12] = t40;
    const double t41 = t22*t29; /* omega_tau*s*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t42 = JLT_FNMA(p[21], t41, t18); /* omega_tau*gamma3*1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s - 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1)*omega_tau*s*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t43 = p[23]*t41; /* (I1 - I3)/I1*omega_tau*s*gamma3*1/(Theta/(m*R^2*I1)) */
    out[19] = t43;
    const double t44 = x[0]*t37; /* gamma3*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) */
    const double t45 = t9*t44; /* s*gamma3*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) */
    out[17] = t45;
    const double t46 = t22*t37; /* omega_tau*s*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) */
    const double t47 = JLT_FNMA(t42, t44, t46); /* omega_tau*s*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) - t42*gamma3*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) */
    out[16] = t47;
    const double t48 = t22*t44; /* omega_tau*s*gamma3*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) */
    out[3] = t48;
    const double t49 = x[1]*p[22]; /* omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t50 = t12*t49; /* 1/(Theta/(m*R^2*I1))*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    out[15] = t50;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = x[0]*p[14]; /* gamma3*I3/I1 */
    const double t5 = t2 + p[13]; /* (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t6 = JLT_FMA(x[0], t4, t5); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t7 = p[23]*x[0]; /* (I1 - I3)/I1*gamma3 */
    const double t8 = x[1]*t7; /* omega_tau*(I1 - I3)/I1*gamma3 */
    const double t9 = t3*t8; /* s*omega_tau*(I1 - I3)/I1*gamma3 */
    const double t10 = t9/t6; /* s*omega_tau*(I1 - I3)/I1*gamma3/(Theta/(m*R^2*I1)) */
    out[0] = t10;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[9]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[7]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(p[8], t2, t4); /* Theta = m*R^2*I1*(1 - gamma3)*(1 + gamma3) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = sqrt(t5); /* h = sqrt(Theta) */
    const double t8 = x[3]*t7; /* omega3*h */
    out[2] = t8;
    const double t9 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t10 = JLT_FMA(x[2], x[2], t9); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t11 = p[26]*t10; /* 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t12 = x[3]*t6; /* omega3*s */
    const double t13 = JLT_FMA(x[2], x[0], t12); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t14 = JLT_FMA(t13, t13, t9); /* v_tau/R*v_tau/R + omega_tau*omega_tau */
    const double t15 = p[27]*x[3]; /* 1/2*I3*omega3 */
    const double t16 = JLT_FMA(x[3], t15, t11); /* omega3*1/2*I3*omega3 + 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t17 = JLT_FMA(p[28], t14, t16); /* 1/2*m*R^2*(v_tau/R*v_tau/R + omega_tau*omega_tau) + t16 */
    out[0] = t17;
    const double t18 = x[2]*p[29]; /* omega_n*R*I1 */
    const double t19 = t6*t18; /* s*omega_n*R*I1 */
    const double t20 = x[3]*p[30]; /* omega3*R*I3 */
    const double t21 = JLT_FNMA(x[0], t20, t19); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    out[1] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    const double t0 = p[32]*x[1]; /* (I1 + m*R^2)*omega_tau */
    out[1] = t0;
    const double t1 = x[0]*p[34]; /* gamma3*(-R*I3) */
    out[7] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = x[0]*p[9]; /* gamma3*m*R^2*I3 */
    const double t6 = JLT_FMA(x[0], t5, p[7]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t7 = JLT_FMA(p[8], t4, t6); /* Theta = m*R^2*I1*(1 - gamma3)*(1 + gamma3) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t8 = sqrt(t7); /* h = sqrt(Theta) */
    out[11] = t8;
    const double t9 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t10 = p[29]*t9; /* R*I1*s */
    out[6] = t10;
    const double t11 = t8*t9; /* h*s */
    const double t12 = x[0]/t11; /* gamma3/(h*s) */
    const double t13 = t8*t12; /* h*gamma3/(h*s) */
    const double t14 = x[3]*t9; /* omega3*s */
    const double t15 = JLT_FMA(x[2], x[0], t14); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t16 = p[31]*t15; /* m*R^2*v_tau/R */
    const double t17 = p[35]*t14; /* (-m*R^2*I1 + m*R^2*I3)*omega3*s */
    const double t18 = t12*t17; /* gamma3/(h*s)*(-m*R^2*I1 + m*R^2*I3)*omega3*s */
    out[8] = t18;
    const double t19 = x[2]*p[33]; /* omega_n*(-R*I1) */
    const double t20 = t13*t19; /* h*gamma3/(h*s)*omega_n*(-R*I1) */
    const double t21 = JLT_FMA(x[3], p[34], t20); /* omega3*(-R*I3) + h*gamma3/(h*s)*omega_n*(-R*I1) */
    out[4] = t21;
    const double t22 = JLT_FNMA(x[3], t13, x[2]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*h*gamma3/(h*s) */
    const double t23 = t16*t22; /* m*R^2*v_tau/R*d(v_tau)/d(gamma3)/R */
    out[0] = t23;
    const double t24 = x[2]*p[4]; /* omega_n*I1 */
    const double t25 = JLT_FMA(x[0], t16, t24); /* gamma3*m*R^2*v_tau/R + omega_n*I1 */
    out[2] = t25;
    const double t26 = x[3]*p[5]; /* omega3*I3 */
    const double t27 = JLT_FMA(t9, t16, t26); /* s*m*R^2*v_tau/R + omega3*I3 */
    out[3] = t27;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = p[8]*t0; /* m*R^2*I1*(1 - gamma3) */
    const double t3 = x[0]*p[9]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[7]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(t1, t2, t4); /* Theta = (1 + gamma3)*m*R^2*I1*(1 - gamma3) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = sqrt(t5); /* h = sqrt(Theta) */
    const double t7 = p[36]*t6; /* K*h */
    out[0] = t7;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[9]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[7]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(p[8], t2, t4); /* Theta = m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = p[37]*x[0]; /* (-K*(m*R^2*I1 - m*R^2*I3 - m*R^2*(I1 - I3)))*gamma3 */
    const double t8 = x[1]*t7; /* omega_tau*(-K*(m*R^2*I1 - m*R^2*I3 - m*R^2*(I1 - I3)))*gamma3 */
    const double t9 = t5*t8; /* Theta*t8 */
    const double t10 = t6*t9; /* s*Theta*t8 */
    const double t11 = sqrt(t5); /* h = sqrt(Theta) */
    const double t12 = t5*t11; /* Theta*h */
    const double t13 = t10/t12; /* s*Theta*t8/(Theta*h) */
    out[0] = t13;
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
    double t10[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
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
        t7[k] = jlt_jet_product(x1, t6, k);
        t10[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t6, t10, k);
        t12[k] = jlt_jet_product(x0, x2, k);
        t13[k] = jlt_jet_product(t6, x3, k) + t12[k];
        t14[k] = p[15]*t13[k];
        t15[k] = jlt_jet_product(t10, t14, k);
        t17[k] = jlt_jet_product(t10, t12, k);
        t19[k] = x3[k]*p[38] + t15[k];
        t20[k] = p[16]*t17[k] + t19[k];
        t21[k] = jlt_jet_product(x2, t20, k);
        t22[k] = -t21[k];
        t26[k] = x0[k]*p[14];
        t27[k] = t5[k] + (k == 0 ? p[13] : 0);
        t28[k] = jlt_jet_product(x0, t26, k) + t27[k];
        t29[k] = jlt_jet_quotient(x3[k], t28, t29, k);
        t30[k] = p[22]*t29[k] + t17[k];
        t31[k] = jlt_jet_product(x1, t30, k);
        t33[k] = x0[k]*p[23];
        t34[k] = jlt_jet_product(t7, t33, k);
        t35[k] = jlt_jet_product(t29, t34, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t22[k]/(k + 1);
        next[2] = x2[k + 1] = t31[k]/(k + 1);
        next[3] = x3[k + 1] = t35[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[1];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_I1 = params[4];
    const double complex v_omega_n = x[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double v_a3 = (0.0);
    const double complex v_K = (v_I1 + v_m*(v_R*v_R + v_a3*v_a3 + 2.0*v_R*v_a3*v_gamma3));
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_v_tau = (v_omega_n*v_b + v_R*v_omega3*v_s);
    const double v_g = params[2];
    out[1] = (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_K))
        + (-v_I3*v_omega_n*v_omega3/v_K)
        + (-v_m*v_omega_n*v_e*v_v_tau/(v_s*v_K))
        + (-v_m*v_R*v_a3*v_omega_tau*v_omega_tau*v_s/v_K)
        + (-v_m*v_g*v_a3*v_s/v_K);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    out[2] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta)
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta);
    out[3] = (v_m*v_R*v_omega_tau*v_omega3*v_s*(v_R*v_gamma3*(v_I1 - v_I3) - v_a3*v_I3)/v_Theta);
}

static const unsigned char family0_is_free[] = { 1, 0, 0, 1 };

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
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = x[3];
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
}

static const jlt_equilibria equilibria[] = {
    { .name = "rolling", .condition = "a3 = 0",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .left_null_count = 0, .obstructs = 0 },
};

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "Jellett", "" },
    { "Routh", "" },
};

static const jlt_named measures[] = {
    { "rho", "" },
};

static const signed char signs_5[] = { 1, -1, 1, 1 };
static const jlt_reversor reversors[] = {
    { signs_5, 5 },
};

const jlt_descriptor jlt_kernels_routh_sphere_balanced = {
    .model = "routh_sphere",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Sphere with displaced centre of mass rolling without slipping, reduced system",
    .source = "E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243",
    .sha256 = "3411ed6d53d99c328220ac4c0d992bf489a81f74d3bcee4f47f68fdd4a704bc2",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_routh_sphere, .family = jlt_family_routh_sphere, .claims = jlt_claims_routh_sphere,
    .scales = 1,
    .state_count = 4, .param_count = 6, .prepared_count = 39,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 16, 4, 1, 1, 0, 10, 5 }, { 11, 46, 0, 7, 1, 0, 10, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of d(omega_tau)/dt, a part of d(omega_n)/dt" },
    .jacobian = { jacobian, 16, { 7, 32, 8, 1, 1, 0, 14, 13 }, { 31, 137, 0, 27, 1, 0, 11, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega_n), 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 8, 33, 8, 1, 1, 0, 15, 12 }, { 37, 165, 0, 34, 1, 0, 11, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2), 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), a part of d(omega_tau)/dt, a part of d(d(omega_tau)/dt)/d(omega_n), d(d(omega_n)/dt)/d(omega_tau), a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 3, 5, 1, 1, 1, 0, 5, 4 }, { 4, 18, 0, 1, 1, 0, 8, 5 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_values = { integral_values, 3, { 2, 10, 8, 0, 2, 0, 7, 5 }, { 9, 36, 0, 0, 2, 0, 10, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, Jellett" },
    .integral_gradients = { integral_gradients, 12, { 2, 16, 7, 1, 2, 0, 9, 6 }, { 12, 54, 0, 3, 2, 0, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by h: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in -m*R^2*I1 + m*R^2*I3, v_tau/R = omega_n*gamma3 + omega3*s, d(Jellett)/d(gamma3), d(v_tau)/d(gamma3)/R = omega_n - omega3*h*(gamma3/h*s), d(E)/d(omega_n), d(E)/d(omega3)" },
    .measure_values = { measure_values, 1, { 2, 3, 2, 0, 1, 0, 5, 4 }, { 4, 15, 0, 0, 2, 0, 9, 5 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes" },
    .measure_divergences = { measure_divergences, 1, { 2, 7, 2, 1, 2, 0, 6, 4 }, { 7, 36, 0, 2, 2, 0, 12, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; divides by h: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in -K*(m*R^2*I1 - m*R^2*I3 - m*R^2*(I1 - I3))" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 3, .measure_count = 1, .equilibria_count = 1,
    .integrals = integrals,
    .measures = measures,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_routh_sphere_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_routh_sphere_balanced) },
#endif
};
