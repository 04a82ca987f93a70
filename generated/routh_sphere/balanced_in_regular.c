/* Sphere with displaced centre of mass rolling without slipping, reduced system
 *
 *  Source:     E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      routh_sphere, SHA-256 3411ed6d53d99c328220ac4c0d992bf489a81f74d3bcee4f47f68fdd4a704bc2
 *  Command:    ttc generate --effort full --out DIR routh_sphere.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   11    4    1    0    0      5    5   (67)
 *  jacobian            8   30    7    1    0    0      8   12   (241)
 *  rhs_jacobian        10   36    9    1    0    0      8   11   (287)
 *  divergence          1    5    1    1    0    0      4    4   (22)
 *  integral_values     0   10    8    0    1    0      5    4   (44)
 *  integral_gradients  0   16    5    1    1    0      6    5   (62)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    digits are lost where terms nearly cancel in v_tau/R = s*omega3 + omega_n*gamma3,
 *      (m*R^2/K)*v_tau/R + (I3/K)*s*omega3, omega_n*gamma3*(I1/K) + (m*R^2/K)*v_tau/R + (I3/K)*s*omega3,
 *      d(d(omega_n)/dtau)/d(omega_tau), omega_n*gamma3*(2*I1/K + m*R^2/K) + (m*R^2/K)*v_tau/R + (I3/K)*s*omega3,
 *      d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(gamma3),
 *      a part of d(d(omega3)/dtau)/d(s)
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
extern const jlt_descriptor jlt_kernels_routh_sphere_balanced_in_regular;
extern const struct jlt_ball_table jlt_balls_routh_sphere_general_in_regular;
extern const jlt_kernel_batch jlt_batch_routh_sphere_balanced_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_routh_sphere_balanced_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_routh_sphere_balanced_in_regular_avx512;

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
    out[33] = t1;
    const double t2 = params[4] + t1; /* K = I1 + m*R*R */
    out[34] = t2;
    const double t3 = params[4]/t2; /* I1/K */
    out[22] = t3;
    const double t4 = t1/t2; /* m*R*R/K */
    out[21] = t4;
    const double t5 = t3 + t4; /* I1/K + m*R*R/K */
    out[6] = t5;
    const double t6 = params[5]/t2; /* I3/K */
    out[20] = t6;
    const double t7 = t4 + t6; /* m*R*R/K + I3/K */
    out[7] = t7;
    const double t8 = params[4]*t1; /* I1*m*R*R */
    out[31] = t8;
    const double t9 = params[5]*params[5]; /* I3*I3 */
    const double t10 = t1*params[5]; /* m*R*R*I3 */
    out[32] = t10;
    const double t11 = t9 + t10; /* I3*I3 + m*R*R*I3 */
    out[36] = t11;
    const double t12 = t11/t8; /* (I3*I3 + m*R*R*I3)/(I1*m*R*R) */
    out[8] = t12;
    const double t13 = params[5]/t1; /* I3/(m*R*R) */
    out[9] = t13;
    const double t14 = params[5]/params[4]; /* I3/I1 */
    out[10] = t14;
    const double t15 = params[4] - params[5]; /* I1 - I3 */
    const double t16 = t15/params[4]; /* (I1 - I3)/I1 */
    out[11] = t16;
    const double t17 = -t3; /* -I1/K */
    const double t18 = t17 - t4; /* -I1/K - m*R*R/K */
    out[12] = t18;
    const double t19 = t3*2.0; /* I1/K*2 */
    const double t20 = -t19; /* -I1/K*2 */
    const double t21 = t20 - t4; /* -I1/K*2 - m*R*R/K */
    out[13] = t21;
    const double t22 = -t6; /* -I3/K */
    out[14] = t22;
    const double t23 = -t4; /* -m*R*R/K */
    out[15] = t23;
    const double t24 = params[0]*params[0]; /* m*m */
    const double t25 = t0*t0; /* R*R*R*R */
    const double t26 = t24*t25; /* m*m*R*R*R*R */
    const double t27 = params[4]*params[4]; /* I1*I1 */
    const double t28 = t26*t27; /* m*m*R*R*R*R*I1*I1 */
    const double t29 = params[5]*t9; /* I3*I3*I3 */
    const double t30 = t1*t29; /* m*R*R*I3*I3*I3 */
    const double t31 = t9*t26; /* I3*I3*m*m*R*R*R*R */
    const double t32 = t30 + t31; /* m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R */
    const double t33 = 2.0*t32; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R) */
    const double t34 = t33/t28; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R)/(m*m*R*R*R*R*I1*I1) */
    out[16] = t34;
    const double t35 = t8*t9; /* I1*m*R*R*I3*I3 */
    const double t36 = params[4]*t26; /* I1*m*m*R*R*R*R */
    const double t37 = params[5]*t36; /* I3*I1*m*m*R*R*R*R */
    const double t38 = t35 + t37; /* I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R */
    const double t39 = 2.0*t38; /* 2*(I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R) */
    const double t40 = t39/t28; /* 2*(I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R)/(m*m*R*R*R*R*I1*I1) */
    out[17] = t40;
    const double t41 = params[5]*2.0; /* I3*2 */
    const double t42 = t15*t41; /* (I1 - I3)*I3*2 */
    const double t43 = t42/t27; /* (I1 - I3)*I3*2/(I1*I1) */
    out[18] = t43;
    const double t44 = params[4]/t1; /* I1/(m*R*R) */
    out[19] = t44;
    const double t45 = t4 + t19; /* m*R*R/K + I1/K*2 */
    out[23] = t45;
    const double t46 = t15*(-2.0); /* (I1 - I3)*(-2) */
    const double t47 = t46/params[4]; /* (I1 - I3)*(-2)/I1 */
    out[24] = t47;
    const double t48 = params[4]/2.0; /* I1/2 */
    out[25] = t48;
    const double t49 = params[5]/2.0; /* I3/2 */
    out[26] = t49;
    const double t50 = t1/2.0; /* m*R*R/2 */
    out[27] = t50;
    const double t51 = params[4]*params[1]; /* I1*R */
    out[28] = t51;
    const double t52 = params[1]*params[5]; /* R*I3 */
    out[29] = t52;
    const double t53 = params[4]*params[5]; /* I1*I3 */
    out[30] = t53;
    const double t54 = -t52; /* -R*I3 */
    out[35] = t54;
    const double t55 = t1*t15; /* m*R*R*(I1 - I3) */
    out[37] = t55;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t1 = JLT_FMA(x[4], x[4], p[9]); /* s*s + I3/(m*R^2) */
    const double t2 = JLT_FMA(x[0], t0, t1); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t3 = x[4]*x[3]; /* s*omega3 */
    const double t4 = t3/t2; /* s*omega3/(Theta/(m*R^2*I1)) */
    const double t5 = x[2]*x[0]; /* omega_n*gamma3 */
    const double t6 = x[4]*x[1]; /* s*omega_tau */
    const double t7 = x[4]*t6; /* s*s*omega_tau */
    out[0] = t7;
    const double t8 = x[0]*t6; /* gamma3*s*omega_tau */
    const double t9 = -t8; /* -gamma3*s*omega_tau */
    out[4] = t9;
    const double t10 = p[11]*t8; /* (I1 - I3)/I1*gamma3*s*omega_tau */
    const double t11 = t4*t10; /* s*omega3/(Theta/(m*R^2*I1))*(I1 - I3)/I1*gamma3*s*omega_tau */
    out[3] = t11;
    const double t12 = JLT_FMA(p[8], t4, t5); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*s*omega3/(Theta/(m*R^2*I1)) + omega_n*gamma3 */
    const double t13 = x[1]*t12; /* omega_tau*t12 */
    out[2] = t13;
    const double t14 = p[6]*t5; /* (I1/K + m*R^2/K)*omega_n*gamma3 */
    const double t15 = JLT_FMA(p[7], t3, t14); /* (I3/K + m*R^2/K)*s*omega3 + (I1/K + m*R^2/K)*omega_n*gamma3 */
    const double t16 = x[2]*t15; /* omega_n*((I3/K + m*R^2/K)*s*omega3 + (I1/K + m*R^2/K)*omega_n*gamma3) */
    const double t17 = -t16; /* -t16 */
    out[1] = t17;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
    out[6] = 0.0;
    out[17] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[1] = t0;
    const double t1 = x[4]*x[1]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[4] = t2;
    const double t3 = p[12]*x[2]; /* (-I1/K - m*R^2/K)*omega_n */
    const double t4 = x[2]*t3; /* omega_n*(-I1/K - m*R^2/K)*omega_n */
    out[5] = t4;
    const double t5 = x[2]*x[0]; /* omega_n*gamma3 */
    const double t6 = p[13]*t5; /* (-2*I1/K - m*R^2/K)*omega_n*gamma3 */
    const double t7 = x[4]*x[3]; /* s*omega3 */
    const double t8 = t5 + t7; /* v_tau/R = omega_n*gamma3 + s*omega3 */
    const double t9 = JLT_FMA(p[14], t7, t6); /* (-I3/K)*s*omega3 + (-2*I1/K - m*R^2/K)*omega_n*gamma3 */
    const double t10 = JLT_FMA(p[15], t8, t9); /* (-m*R^2/K)*v_tau/R + (-I3/K)*s*omega3 + (-2*I1/K - m*R^2/K)*omega_n*gamma3 */
    out[7] = t10;
    const double t11 = x[2]*p[7]; /* omega_n*(I3/K + m*R^2/K) */
    const double t12 = x[4]*t11; /* s*omega_n*(I3/K + m*R^2/K) */
    const double t13 = -t12; /* -s*omega_n*(I3/K + m*R^2/K) */
    out[8] = t13;
    const double t14 = x[3]*t11; /* omega3*omega_n*(I3/K + m*R^2/K) */
    const double t15 = -t14; /* -omega3*omega_n*(I3/K + m*R^2/K) */
    out[9] = t15;
    const double t16 = x[1]*x[2]; /* omega_tau*omega_n */
    const double t17 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t18 = t0 + p[9]; /* s*s + I3/(m*R^2) */
    const double t19 = JLT_FMA(p[10], t17, t18); /* Theta/(m*R^2*I1) = I3/I1*gamma3*gamma3 + s*s + I3/(m*R^2) */
    const double t20 = 1.0/t19; /* 1/(Theta/(m*R^2*I1)) */
    const double t21 = x[1]*x[3]; /* omega_tau*omega3 */
    const double t22 = t20*t21; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t23 = x[4]*x[0]; /* s*gamma3 */
    const double t24 = t20*t23; /* 1/(Theta/(m*R^2*I1))*s*gamma3 */
    const double t25 = t22*t24; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*1/(Theta/(m*R^2*I1))*s*gamma3 */
    const double t26 = JLT_FNMA(p[16], t25, t16); /* omega_tau*omega_n - 2*(m*R^2*I3^3 + m^2*R^4*I3^2)/(m^2*R^4*I1^2)*t25 */
    out[10] = t26;
    const double t27 = t20*p[8]; /* 1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t28 = JLT_FMA(t7, t27, t5); /* s*omega3*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) + omega_n*gamma3 */
    out[11] = t28;
    const double t29 = x[1]*x[0]; /* omega_tau*gamma3 */
    out[12] = t29;
    const double t30 = t1*t27; /* s*omega_tau*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    out[13] = t30;
    const double t31 = t22*p[8]; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t32 = t0*t22; /* s*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t33 = t20*p[17]; /* 1/(Theta/(m*R^2*I1))*2*(m*R^2*I1*I3^2 + m^2*R^4*I1*I3)/(m^2*R^4*I1^2) */
    const double t34 = JLT_FNMA(t32, t33, t31); /* t31 - s*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*t33 */
    out[14] = t34;
    const double t35 = t32*p[11]; /* s*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*(I1 - I3)/I1 */
    const double t36 = t25*p[18]; /* t25*2*I3*(I1 - I3)/I1^2 */
    const double t37 = JLT_FNMA(t23, t36, t35); /* s*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*(I1 - I3)/I1 - s*gamma3*t25*2*I3*(I1 - I3)/I1^2 */
    out[15] = t37;
    const double t38 = t24*p[11]; /* 1/(Theta/(m*R^2*I1))*s*gamma3*(I1 - I3)/I1 */
    const double t39 = t7*t38; /* s*omega3*1/(Theta/(m*R^2*I1))*s*gamma3*(I1 - I3)/I1 */
    out[16] = t39;
    const double t40 = t1*t38; /* s*omega_tau*1/(Theta/(m*R^2*I1))*s*gamma3*(I1 - I3)/I1 */
    out[18] = t40;
    const double t41 = t17 + p[19]; /* gamma3*gamma3 + I1/(m*R^2) */
    const double t42 = t36*t41; /* t25*2*I3*(I1 - I3)/I1^2*(gamma3*gamma3 + I1/(m*R^2)) */
    out[19] = t42;
    const double t43 = -t1; /* -s*omega_tau */
    out[20] = t43;
    const double t44 = -t23; /* -s*gamma3 */
    out[21] = t44;
    const double t45 = -t29; /* -omega_tau*gamma3 */
    out[24] = t45;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[1]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = x[4]*x[3]; /* s*omega3 */
    const double t3 = p[20]*t2; /* I3/K*s*omega3 */
    const double t4 = x[2]*x[0]; /* omega_n*gamma3 */
    const double t5 = t2 + t4; /* v_tau/R = s*omega3 + omega_n*gamma3 */
    const double t6 = JLT_FMA(p[21], t5, t3); /* m*R^2/K*v_tau/R + I3/K*s*omega3 */
    const double t7 = JLT_FMA(t4, p[22], t6); /* omega_n*gamma3*I1/K + m*R^2/K*v_tau/R + I3/K*s*omega3 */
    const double t8 = x[2]*t7; /* omega_n*(omega_n*gamma3*I1/K + m*R^2/K*v_tau/R + I3/K*s*omega3) */
    const double t9 = -t8; /* -t8 */
    out[1] = t9;
    const double t10 = x[4]*x[4]; /* s*s */
    out[6] = t10;
    const double t11 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t12 = p[9] + t10; /* I3/(m*R^2) + s*s */
    const double t13 = JLT_FMA(p[10], t11, t12); /* Theta/(m*R^2*I1) = I3/I1*gamma3*gamma3 + I3/(m*R^2) + s*s */
    const double t14 = 1.0/t13; /* 1/(Theta/(m*R^2*I1)) */
    const double t15 = t2*t14; /* s*omega3*1/(Theta/(m*R^2*I1)) */
    const double t16 = JLT_FMA(p[8], t15, t4); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*s*omega3*1/(Theta/(m*R^2*I1)) + omega_n*gamma3 */
    out[16] = t16;
    const double t17 = x[1]*t16; /* omega_tau*t16 */
    out[2] = t17;
    const double t18 = x[4]*x[0]; /* s*gamma3 */
    const double t19 = p[11]*t18; /* (I1 - I3)/I1*s*gamma3 */
    const double t20 = t15*t19; /* s*omega3*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*s*gamma3 */
    out[21] = t20;
    const double t21 = x[1]*t20; /* omega_tau*s*omega3*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*s*gamma3 */
    out[3] = t21;
    const double t22 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t23 = -t22; /* -s*omega_tau*gamma3 */
    out[4] = t23;
    out[5] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[22] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    const double t24 = t0*2.0; /* s*omega_tau*2 */
    out[9] = t24;
    const double t25 = x[2]*p[12]; /* omega_n*(-I1/K - m*R^2/K) */
    const double t26 = x[2]*t25; /* omega_n*omega_n*(-I1/K - m*R^2/K) */
    out[10] = t26;
    const double t27 = JLT_FMA(t4, p[23], t6); /* omega_n*gamma3*(2*I1/K + m*R^2/K) + m*R^2/K*v_tau/R + I3/K*s*omega3 */
    const double t28 = -t27; /* -t27 */
    out[12] = t28;
    const double t29 = x[2]*p[7]; /* omega_n*(I3/K + m*R^2/K) */
    const double t30 = x[4]*t29; /* s*omega_n*(I3/K + m*R^2/K) */
    const double t31 = -t30; /* -s*omega_n*(I3/K + m*R^2/K) */
    out[13] = t31;
    const double t32 = x[3]*t29; /* omega3*omega_n*(I3/K + m*R^2/K) */
    const double t33 = -t32; /* -omega3*omega_n*(I3/K + m*R^2/K) */
    out[14] = t33;
    const double t34 = x[1]*x[2]; /* omega_tau*omega_n */
    const double t35 = x[1]*x[0]; /* omega_tau*gamma3 */
    out[17] = t35;
    const double t36 = t15*t35; /* s*omega3*1/(Theta/(m*R^2*I1))*omega_tau*gamma3 */
    const double t37 = t14*p[16]; /* 1/(Theta/(m*R^2*I1))*2*(m*R^2*I3^3 + m^2*R^4*I3^2)/(m^2*R^4*I1^2) */
    const double t38 = JLT_FNMA(t36, t37, t34); /* omega_tau*omega_n - s*omega3*1/(Theta/(m*R^2*I1))*omega_tau*gamma3*t37 */
    out[15] = t38;
    const double t39 = t0*t14; /* s*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t40 = p[8]*t39; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*s*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[18] = t40;
    const double t41 = x[1]*p[8]; /* omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t42 = x[3]*t41; /* omega3*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t43 = t14*t42; /* 1/(Theta/(m*R^2*I1))*omega3*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t44 = t15*t39; /* s*omega3*1/(Theta/(m*R^2*I1))*s*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t45 = JLT_FNMA(p[17], t44, t43); /* t43 - 2*(m*R^2*I1*I3^2 + m^2*R^4*I1*I3)/(m^2*R^4*I1^2)*t44 */
    out[19] = t45;
    const double t46 = t0*p[11]; /* s*omega_tau*(I1 - I3)/I1 */
    const double t47 = t15*t46; /* s*omega3*1/(Theta/(m*R^2*I1))*s*omega_tau*(I1 - I3)/I1 */
    const double t48 = t11*p[18]; /* gamma3*gamma3*2*I3*(I1 - I3)/I1^2 */
    const double t49 = JLT_FNMA(t44, t48, t47); /* s*omega3*1/(Theta/(m*R^2*I1))*s*omega_tau*(I1 - I3)/I1 - t44*gamma3*gamma3*2*I3*(I1 - I3)/I1^2 */
    out[20] = t49;
    const double t50 = t19*t39; /* (I1 - I3)/I1*s*gamma3*s*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[23] = t50;
    const double t51 = JLT_FMS(t18, t44, t36); /* s*gamma3*t44 - s*omega3*1/(Theta/(m*R^2*I1))*omega_tau*gamma3 */
    const double t52 = p[24]*t51; /* (-2*(I1 - I3)/I1)*t51 */
    out[24] = t52;
    const double t53 = -t0; /* -s*omega_tau */
    out[25] = t53;
    const double t54 = -t18; /* -s*gamma3 */
    out[26] = t54;
    const double t55 = -t35; /* -omega_tau*gamma3 */
    out[29] = t55;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t2 = p[9] + t0; /* I3/(m*R^2) + s*s */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s*s */
    const double t4 = p[11]*x[0]; /* (I1 - I3)/I1*gamma3 */
    const double t5 = x[1]*t4; /* omega_tau*(I1 - I3)/I1*gamma3 */
    const double t6 = t0*t5; /* s*s*omega_tau*(I1 - I3)/I1*gamma3 */
    const double t7 = t6/t3; /* s*s*omega_tau*(I1 - I3)/I1*gamma3/(Theta/(m*R^2*I1)) */
    out[0] = t7;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*p[31]; /* s*m*R^2*I1 */
    const double t1 = JLT_FMA(x[4], t0, p[30]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t2 = x[0]*p[32]; /* gamma3*m*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t4 = sqrt(t3); /* h = sqrt(Theta) */
    const double t5 = x[3]*t4; /* omega3*h */
    out[2] = t5;
    const double t6 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t7 = JLT_FMA(x[2], x[2], t6); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t8 = p[25]*t7; /* 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t9 = x[3]*x[4]; /* omega3*s */
    const double t10 = JLT_FMA(x[2], x[0], t9); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t11 = JLT_FMA(t10, t10, t6); /* v_tau/R*v_tau/R + omega_tau*omega_tau */
    const double t12 = p[26]*x[3]; /* 1/2*I3*omega3 */
    const double t13 = JLT_FMA(x[3], t12, t8); /* omega3*1/2*I3*omega3 + 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t14 = JLT_FMA(p[27], t11, t13); /* 1/2*m*R^2*(v_tau/R*v_tau/R + omega_tau*omega_tau) + t13 */
    out[0] = t14;
    const double t15 = x[2]*p[28]; /* omega_n*R*I1 */
    const double t16 = x[4]*t15; /* s*omega_n*R*I1 */
    const double t17 = x[3]*p[29]; /* omega3*R*I3 */
    const double t18 = JLT_FNMA(x[0], t17, t16); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    out[1] = t18;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*x[4]; /* omega3*s */
    const double t1 = JLT_FMA(x[2], x[0], t0); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t2 = p[33]*t1; /* m*R^2*v_tau/R */
    const double t3 = x[2]*t2; /* omega_n*m*R^2*v_tau/R */
    out[0] = t3;
    const double t4 = p[34]*x[1]; /* (I1 + m*R^2)*omega_tau */
    out[1] = t4;
    const double t5 = x[2]*p[4]; /* omega_n*I1 */
    const double t6 = JLT_FMA(x[0], t2, t5); /* gamma3*m*R^2*v_tau/R + omega_n*I1 */
    out[2] = t6;
    const double t7 = x[3]*p[5]; /* omega3*I3 */
    const double t8 = JLT_FMA(x[4], t2, t7); /* s*m*R^2*v_tau/R + omega3*I3 */
    out[3] = t8;
    const double t9 = x[3]*t2; /* omega3*m*R^2*v_tau/R */
    out[4] = t9;
    const double t10 = x[3]*p[35]; /* omega3*(-R*I3) */
    out[5] = t10;
    out[6] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    const double t11 = x[4]*p[28]; /* s*R*I1 */
    out[7] = t11;
    const double t12 = x[0]*p[35]; /* gamma3*(-R*I3) */
    out[8] = t12;
    const double t13 = x[2]*p[28]; /* omega_n*R*I1 */
    out[9] = t13;
    const double t14 = x[0]*p[32]; /* gamma3*m*R^2*I3 */
    const double t15 = x[4]*p[31]; /* s*m*R^2*I1 */
    const double t16 = JLT_FMA(x[4], t15, p[30]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t17 = JLT_FMA(x[0], t14, t16); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t18 = sqrt(t17); /* h = sqrt(Theta) */
    out[13] = t18;
    const double t19 = x[3]/t17; /* omega3/Theta */
    const double t20 = t18*t19; /* h*omega3/Theta */
    const double t21 = t14*t20; /* gamma3*m*R^2*I3*h*omega3/Theta */
    out[10] = t21;
    const double t22 = t15*t20; /* s*m*R^2*I1*h*omega3/Theta */
    out[14] = t22;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t12[k] = x4[k]*p[31];
        t13[k] = jlt_jet_product(x4, t12, k) + (k == 0 ? p[30] : 0);
        t14[k] = x0[k]*p[32];
        t15[k] = jlt_jet_product(x0, t14, k) + t13[k];
        t16[k] = jlt_jet_product(x4, x3, k);
        t17[k] = jlt_jet_quotient(t16[k], t15, t17, k);
        t18[k] = jlt_jet_product(x2, x0, k);
        t19[k] = jlt_jet_product(x4, x1, k);
        t20[k] = jlt_jet_product(x4, t19, k);
        t21[k] = jlt_jet_product(x0, t19, k);
        t22[k] = -t21[k];
        t23[k] = p[37]*t21[k];
        t24[k] = jlt_jet_product(t17, t23, k);
        t25[k] = p[36]*t17[k] + t18[k];
        t26[k] = jlt_jet_product(x1, t25, k);
        t27[k] = p[6]*t18[k];
        t28[k] = p[7]*t16[k] + t27[k];
        t29[k] = jlt_jet_product(x2, t28, k);
        t30[k] = -t29[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t20[k]/(k + 1);
        next[1] = x1[k + 1] = t30[k]/(k + 1);
        next[2] = x2[k + 1] = t26[k]/(k + 1);
        next[3] = x3[k + 1] = t24[k]/(k + 1);
        next[4] = x4[k + 1] = t22[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[1];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double v_I1 = params[4];
    const double complex v_gamma3 = x[0];
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
    out[1] = (v_s)*((-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_K))
        + (-v_I3*v_omega_n*v_omega3/v_K)
        + (-v_m*v_omega_n*v_e*v_v_tau/(v_s*v_K))
        + (-v_m*v_R*v_a3*v_omega_tau*v_omega_tau*v_s/v_K)
        + (-v_m*v_g*v_a3*v_s/v_K));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    out[2] = (v_s)*((v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta)
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta));
    out[3] = (v_s)*((v_m*v_R*v_omega_tau*v_omega3*v_s*(v_R*v_gamma3*(v_I1 - v_I3) - v_a3*v_I3)/v_Theta));
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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

const jlt_descriptor jlt_kernels_routh_sphere_balanced_in_regular = {
    .model = "routh_sphere",
    .variant = "balanced",
    .time = "regular",
    .elimination = "",
    .title = "Sphere with displaced centre of mass rolling without slipping, reduced system",
    .source = "E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243",
    .sha256 = "3411ed6d53d99c328220ac4c0d992bf489a81f74d3bcee4f47f68fdd4a704bc2",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_routh_sphere, .family = jlt_family_routh_sphere, .claims = jlt_claims_routh_sphere,
    .scales = 1,
    .state_count = 5, .param_count = 6, .prepared_count = 38,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 11, 4, 1, 0, 0, 5, 5 }, { 11, 50, 0, 6, 0, 0, 9, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in a part of d(omega_n)/dtau, (I3/K + m*R^2/K)*s*omega3 + (I1/K + m*R^2/K)*omega_n*gamma3" },
    .jacobian = { jacobian, 25, { 8, 30, 7, 1, 0, 0, 8, 12 }, { 33, 182, 0, 26, 0, 0, 12, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + s*omega3, d(d(omega_tau)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 36, 9, 1, 0, 0, 8, 11 }, { 40, 215, 0, 32, 0, 0, 12, 8 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in v_tau/R = s*omega3 + omega_n*gamma3, (m*R^2/K)*v_tau/R + (I3/K)*s*omega3, omega_n*gamma3*(I1/K) + (m*R^2/K)*v_tau/R + (I3/K)*s*omega3, d(d(omega_n)/dtau)/d(omega_tau), omega_n*gamma3*(2*I1/K + m*R^2/K) + (m*R^2/K)*v_tau/R + (I3/K)*s*omega3, d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(gamma3), a part of d(d(omega3)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 1, 5, 1, 1, 0, 0, 4, 4 }, { 3, 18, 0, 1, 0, 0, 7, 5 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .integral_values = { integral_values, 3, { 0, 10, 8, 0, 1, 0, 5, 4 }, { 8, 35, 0, 0, 1, 0, 8, 5 },
        "takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, Jellett" },
    .integral_gradients = { integral_gradients, 15, { 0, 16, 5, 1, 1, 0, 6, 5 }, { 8, 51, 0, 2, 1, 0, 8, 5 },
        "divides by h: values and rounding errors grow without bound where it vanishes; takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, d(E)/d(omega_n), d(E)/d(omega3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_routh_sphere_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_routh_sphere_balanced_in_regular) },
#endif
};
