/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 a03ac57982f08b300ad072746897d22dbcd0a4e4ebdedbf1bb5bf573f26d0de6
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   22    7    1    0    0     12    7   (93)
 *  jacobian            9   55   26    1    0    0     14   23   (644)
 *  rhs_jacobian        13   61   25    1    0    0     13   23   (723)
 *  divergence          2    8    4    1    0    0      9    5   (41)
 *  integral_values     1   12    7    1    0    0      7    5   (47)
 *  integral_gradients  0   24    9    1    0    0     11    7   (195)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), V = omega_tau*R + v_nu,
 *      s*v_tau - gamma3*(G/I1), s*v_tau + s*v_tau - gamma3*(G/I1), v_nu - 1/(Theta/m)*(I1*I3/m)*V,
 *      a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(v_tau),
 *      d(d(v_tau)/dtau)/d(omega_tau), (R*G)*1/K - (2*R^2*I1)*1/K*(gamma3*v_tau*(R*I3) + s*(R*G))*s*1/K,
 *      d(d(v_tau)/dtau)/d(gamma3), a part of d(d(v_nu)/dtau)/d(gamma3),
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s),
 *      d(d(omega_tau)/dtau)/d(gamma3), a part of d(v_tau)/dtau, d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(s)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_claim jlt_claims_spherical_top_level[];
extern const jlt_descriptor *const jlt_family_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_balanced_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_level_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
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
    const double t0 = params[1]*params[6]; /* R*G */
    out[7] = t0;
    const double t1 = params[1]*params[4]; /* R*I3 */
    out[8] = t1;
    const double t2 = params[1]*params[1]; /* R*R */
    const double t3 = t2*params[3]; /* R*R*I1 */
    out[9] = t3;
    const double t4 = params[4]*t2; /* I3*R*R */
    out[10] = t4;
    const double t5 = params[4]*params[3]; /* I3*I1 */
    out[37] = t5;
    const double t6 = t5/params[0]; /* I3*I1/m */
    out[11] = t6;
    const double t7 = params[6]/params[3]; /* G/I1 */
    out[12] = t7;
    const double t8 = params[4]*t3; /* I3*R*R*I1 */
    const double t9 = params[3] - params[4]; /* I1 - I3 */
    const double t10 = t8*t9; /* I3*R*R*I1*(I1 - I3) */
    const double t11 = t10/params[0]; /* I3*R*R*I1*(I1 - I3)/m */
    out[13] = t11;
    const double t12 = t2*2.0; /* R*R*2 */
    const double t13 = params[4]*t12; /* I3*R*R*2 */
    out[14] = t13;
    const double t14 = params[3]*t12; /* I1*R*R*2 */
    out[15] = t14;
    const double t15 = t2*4.0; /* R*R*4 */
    const double t16 = params[4]*t15; /* I3*R*R*4 */
    out[16] = t16;
    const double t17 = params[6]*t1; /* G*R*I3 */
    const double t18 = t17/params[3]; /* G*R*I3/I1 */
    out[17] = t18;
    const double t19 = -t1; /* -R*I3 */
    out[18] = t19;
    const double t20 = params[3]*t15; /* I1*R*R*4 */
    out[19] = t20;
    const double t21 = params[1]*4.0; /* R*4 */
    const double t22 = params[3]*t21; /* I1*R*4 */
    const double t23 = params[4]/t22; /* I3/(I1*R*4) */
    out[20] = t23;
    const double t24 = params[4]*params[4]; /* I3*I3 */
    const double t25 = t14*t24; /* I1*R*R*2*I3*I3 */
    const double t26 = t25/params[0]; /* I1*R*R*2*I3*I3/m */
    out[21] = t26;
    const double t27 = t2*t9; /* R*R*(I1 - I3) */
    out[22] = t27;
    const double t28 = params[6]*t4; /* G*I3*R*R */
    const double t29 = t9*t28; /* (I1 - I3)*G*I3*R*R */
    const double t30 = t29/params[0]; /* (I1 - I3)*G*I3*R*R/m */
    out[23] = t30;
    const double t31 = params[1]*params[3]; /* R*I1 */
    const double t32 = params[4]*t31; /* I3*R*I1 */
    const double t33 = t32/params[0]; /* I3*R*I1/m */
    out[24] = t33;
    const double t34 = params[3]*params[3]; /* I1*I1 */
    const double t35 = t12*t34; /* R*R*2*I1*I1 */
    const double t36 = params[4]*t35; /* I3*R*R*2*I1*I1 */
    const double t37 = t36/params[0]; /* I3*R*R*2*I1*I1/m */
    out[25] = t37;
    const double t38 = params[1]*t2; /* R*R*R */
    const double t39 = 4.0*t38; /* 4*R*R*R */
    const double t40 = t24*t39; /* I3*I3*4*R*R*R */
    out[26] = t40;
    const double t41 = -t11; /* -I3*R*R*I1*(I1 - I3)/m */
    out[27] = t41;
    const double t42 = t9*t31; /* (I1 - I3)*R*I1 */
    const double t43 = t42/params[0]; /* (I1 - I3)*R*I1/m */
    out[28] = t43;
    const double t44 = params[0]/2.0; /* m/2 */
    out[29] = t44;
    const double t45 = params[4]/params[3]; /* I3/I1 */
    out[30] = t45;
    const double t46 = t2*params[0]; /* R*R*m */
    const double t47 = params[3]*t46; /* I1*R*R*m */
    const double t48 = params[6]*params[6]; /* G*G */
    const double t49 = t48/t47; /* G*G/(I1*R*R*m) */
    out[31] = t49;
    const double t50 = params[4]/t46; /* I3/(R*R*m) */
    out[32] = t50;
    const double t51 = params[3]/2.0; /* I1/2 */
    out[33] = t51;
    const double t52 = params[0]*t34; /* m*I1*I1 */
    out[34] = t52;
    const double t53 = params[3]*params[0]; /* I1*m */
    const double t54 = t9*t53; /* (I1 - I3)*I1*m */
    out[35] = t54;
    const double t55 = 1.0/params[0]; /* 1/m */
    out[36] = t55;
    const double t56 = t48/params[0]; /* G*G/m */
    out[38] = t56;
    const double t57 = params[0]*2.0; /* m*2 */
    const double t58 = t2*t2; /* R*R*R*R */
    const double t59 = t57*t58; /* m*2*R*R*R*R */
    const double t60 = t34*t59; /* I1*I1*m*2*R*R*R*R */
    const double t61 = params[4]*t60; /* I3*I1*I1*m*2*R*R*R*R */
    const double t62 = t9*t61; /* (I1 - I3)*I3*I1*I1*m*2*R*R*R*R */
    out[39] = t62;
    const double t63 = 2.0/params[0]; /* 2/m */
    out[40] = t63;
    const double t64 = params[6]*t14; /* G*I1*R*R*2 */
    const double t65 = t9*t64; /* (I1 - I3)*G*I1*R*R*2 */
    out[41] = t65;
    const double t66 = t34*t57; /* I1*I1*m*2 */
    out[42] = t66;
    const double t67 = params[1]*t57; /* R*m*2 */
    const double t68 = t34*t67; /* I1*I1*R*m*2 */
    out[43] = t68;
    const double t69 = t9*t35; /* (I1 - I3)*R*R*2*I1*I1 */
    out[44] = t69;
    const double t70 = params[3]*t34; /* I1*I1*I1 */
    const double t71 = t59*t70; /* m*2*R*R*R*R*I1*I1*I1 */
    const double t72 = t9*t71; /* (I1 - I3)*m*2*R*R*R*R*I1*I1*I1 */
    out[45] = t72;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = x[4]*p[7]; /* s*R*G */
    const double t3 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t5 = x[4]*p[9]; /* s*R^2*I1 */
    const double t6 = x[4]*t5; /* s*s*R^2*I1 */
    const double t7 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t8 = JLT_FMA(x[0], t7, t6); /* K = gamma3*gamma3*R^2*I3 + s*s*R^2*I1 */
    const double t9 = t8 + p[11]; /* Theta/m = K + I1*I3/m */
    const double t10 = t8*t9; /* K*Theta/m */
    const double t11 = 1.0/t10; /* 1/(K*Theta/m) */
    const double t12 = t9*t11; /* 1/K = Theta/m*1/(K*Theta/m) */
    const double t13 = t4*t12; /* (gamma3*v_tau*R*I3 + s*R*G)*1/K */
    const double t14 = x[3]*t13; /* v_tau*(gamma3*v_tau*R*I3 + s*R*G)*1/K */
    out[1] = t14;
    const double t15 = x[4]*x[3]; /* s*v_tau */
    const double t16 = JLT_FNMA(x[0], p[12], t15); /* s*v_tau - gamma3*G/I1 */
    const double t17 = t12*t16; /* 1/K*(s*v_tau - gamma3*G/I1) */
    const double t18 = x[4]*p[8]; /* s*R*I3 */
    const double t19 = t17*t18; /* 1/K*(s*v_tau - gamma3*G/I1)*s*R*I3 */
    const double t20 = JLT_FMA(x[0], t13, t19); /* gamma3*(gamma3*v_tau*R*I3 + s*R*G)*1/K + 1/K*(s*v_tau - gamma3*G/I1)*s*R*I3 */
    const double t21 = t13*t20; /* (gamma3*v_tau*R*I3 + s*R*G)*1/K*t20 */
    const double t22 = -t21; /* -(gamma3*v_tau*R*I3 + s*R*G)*1/K*t20 */
    out[2] = t22;
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t24 = t8*t11; /* 1/(Theta/m) = K*1/(K*Theta/m) */
    const double t25 = p[11]*t23; /* I1*I3/m*V */
    const double t26 = JLT_FNMA(t24, t25, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t27 = t13*t26; /* (gamma3*v_tau*R*I3 + s*R*G)*1/K*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t28 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t29 = p[13]*t28; /* R^2*I1*I3*(I1 - I3)/m*s*omega_tau*gamma3 */
    const double t30 = t24*t29; /* 1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*s*omega_tau*gamma3 */
    const double t31 = JLT_FMA(t17, t30, t27); /* 1/K*(s*v_tau - gamma3*G/I1)*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*s*omega_tau*gamma3 + t27 */
    const double t32 = -t31; /* -t31 */
    out[3] = t32;
    const double t33 = -t28; /* -s*omega_tau*gamma3 */
    out[4] = t33;
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
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = p[10]*x[0]; /* R^2*I3*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*R^2*I3*gamma3 + R^2*I1*s*s */
    const double t4 = p[11] + t3; /* Theta/m = I1*I3/m + K */
    const double t5 = t3*t4; /* K*Theta/m */
    const double t6 = 1.0/t5; /* 1/(K*Theta/m) */
    const double t7 = t4*t6; /* 1/K = Theta/m*1/(K*Theta/m) */
    const double t8 = t3*t6; /* 1/(Theta/m) = K*1/(K*Theta/m) */
    const double t9 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t10 = x[4]*p[7]; /* s*R*G */
    const double t11 = JLT_FMA(x[0], t9, t10); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t12 = x[4]*x[3]; /* s*v_tau */
    const double t13 = JLT_FNMA(x[0], p[12], t12); /* s*v_tau - gamma3*G/I1 */
    const double t14 = t12 + t13; /* s*v_tau + s*v_tau - gamma3*G/I1 */
    const double t15 = x[4]*x[2]; /* s*omega_tau */
    const double t16 = 2.0*t15; /* 2*s*omega_tau */
    out[4] = t16;
    const double t17 = -t15; /* -s*omega_tau */
    out[20] = t17;
    const double t18 = x[0]*t7; /* gamma3*1/K */
    const double t19 = t7*t11; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t20 = JLT_FMA(t9, t18, t19); /* v_tau*R*I3*gamma3*1/K + 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[8] = t20;
    const double t21 = p[8]*t13; /* R*I3*(s*v_tau - gamma3*G/I1) */
    const double t22 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t23 = t18*t19; /* gamma3*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t24 = t7*t19; /* 1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t25 = t7*t21; /* 1/K*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t26 = x[4]*t7; /* s*1/K */
    const double t27 = p[11]*t22; /* I1*I3/m*V */
    const double t28 = JLT_FNMA(t8, t27, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t29 = t13*t15; /* (s*v_tau - gamma3*G/I1)*s*omega_tau */
    const double t30 = t8*t29; /* 1/(Theta/m)*(s*v_tau - gamma3*G/I1)*s*omega_tau */
    const double t31 = p[14]*t23; /* 2*R^2*I3*gamma3*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t32 = p[7]*t7; /* R*G*1/K */
    const double t33 = x[4]*t24; /* s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t34 = p[16]*t18; /* 4*R^2*I3*gamma3*1/K */
    const double t35 = JLT_FMA(t21, t34, p[17]); /* R*I3*(s*v_tau - gamma3*G/I1)*4*R^2*I3*gamma3*1/K + R*I3*G/I1 */
    const double t36 = JLT_FNMA(t23, t34, t24); /* 1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) - gamma3*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G)*4*R^2*I3*gamma3*1/K */
    const double t37 = t11*t36; /* (gamma3*v_tau*R*I3 + s*R*G)*t36 */
    const double t38 = JLT_FMS(t33, t35, t37); /* s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G)*(R*I3*(s*v_tau - gamma3*G/I1)*4*R^2*I3*gamma3*1/K + R*I3*G/I1) - (gamma3*v_tau*R*I3 + s*R*G)*t36 */
    const double t39 = p[15]*t33; /* 2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t40 = t8*t11; /* 1/(Theta/m)*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t41 = -t40; /* -1/(Theta/m)*(gamma3*v_tau*R*I3 + s*R*G) */
    out[16] = t41;
    const double t42 = t25*t26; /* 1/K*R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t43 = JLT_FMA(2.0, t23, t42); /* 2*gamma3*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) + 1/K*R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t44 = JLT_FNMA(t9, t43, t38); /* t38 - v_tau*R*I3*t43 */
    out[10] = t44;
    const double t45 = t0*t25; /* s*s*1/K*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t46 = JLT_FNMA(p[20], t14, t45); /* s*s*1/K*R*I3*(s*v_tau - gamma3*G/I1) - 1/4*I3/(R*I1)*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t47 = x[2]*t14; /* omega_tau*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t48 = p[25]*t26; /* 2*R^2*I1^2*I3/m*s*1/K */
    const double t49 = x[0]*p[22]; /* gamma3*R^2*(I1 - I3) */
    const double t50 = t30*t49; /* 1/(Theta/m)*(s*v_tau - gamma3*G/I1)*s*omega_tau*gamma3*R^2*(I1 - I3) */
    const double t51 = JLT_FNMA(t22, t40, t50); /* t50 - V*1/(Theta/m)*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t52 = t8*t18; /* 1/(Theta/m)*gamma3*1/K */
    const double t53 = x[4]*x[0]; /* s*gamma3 */
    const double t54 = JLT_FMA(t19, t53, t46); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*gamma3 + t46 */
    const double t55 = -t53; /* -s*gamma3 */
    out[22] = t55;
    const double t56 = t9*t28; /* v_tau*R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t57 = JLT_FMA(p[13], t30, t56); /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*(s*v_tau - gamma3*G/I1)*s*omega_tau + v_tau*R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t58 = JLT_FMS(t7, t9, t31); /* 1/K*v_tau*R*I3 - 2*R^2*I3*gamma3*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t59 = x[3]*t58; /* v_tau*t58 */
    out[5] = t59;
    const double t60 = x[1]*t31; /* v_nu*2*R^2*I3*gamma3*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t61 = p[23]*t15; /* R^2*I3*G*(I1 - I3)/m*s*omega_tau */
    const double t62 = JLT_FMA(t52, t61, t60); /* 1/(Theta/m)*gamma3*1/K*R^2*I3*G*(I1 - I3)/m*s*omega_tau + v_nu*2*R^2*I3*gamma3*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t63 = JLT_FNMA(t7, t57, t62); /* t62 - 1/K*t57 */
    const double t64 = p[13]*t52; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*gamma3*1/K */
    const double t65 = t7 + t8; /* 1/K + 1/(Theta/m) */
    const double t66 = t51*t65; /* (t50 - V*1/(Theta/m)*(gamma3*v_tau*R*I3 + s*R*G))*(1/K + 1/(Theta/m)) */
    const double t67 = p[24]*t8; /* R*I1*I3/m*1/(Theta/m) */
    const double t68 = t19*t67; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I1*I3/m*1/(Theta/m) */
    const double t69 = p[8]*t18; /* R*I3*gamma3*1/K */
    const double t70 = t28*t69; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t71 = t28*t32; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t72 = JLT_FMS(x[1], t39, t71); /* v_nu*2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) - (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t73 = t32 - t39; /* R*G*1/K - 2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t74 = JLT_FNMA(t47, t64, t72); /* t72 - omega_tau*(s*v_tau + s*v_tau - gamma3*G/I1)*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*gamma3*1/K */
    const double t75 = JLT_FMA(t48, t66, t74); /* 2*R^2*I1^2*I3/m*s*1/K*t66 + t74 */
    out[19] = t75;
    const double t76 = x[3]*t73; /* v_tau*(R*G*1/K - 2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G)) */
    out[9] = t76;
    const double t77 = x[4]*t64; /* s*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*gamma3*1/K */
    const double t78 = JLT_FNMA(t13, t77, t68); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I1*I3/m*1/(Theta/m) - (s*v_tau - gamma3*G/I1)*s*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*gamma3*1/K */
    out[17] = t78;
    const double t79 = JLT_FMA(t15, t77, t70); /* s*omega_tau*s*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*gamma3*1/K + (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t80 = -t79; /* -t79 */
    out[18] = t80;
    const double t81 = p[21]*t18; /* 2*R^2*I1*I3^2/m*gamma3*1/K */
    const double t82 = JLT_FMA(t66, t81, t63); /* t66*2*R^2*I1*I3^2/m*gamma3*1/K + t62 - 1/K*t57 */
    out[15] = t82;
    const double t83 = x[0]*t43; /* gamma3*t43 */
    const double t84 = JLT_FMA(t0, t24, t83); /* s*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) + gamma3*t43 */
    const double t85 = p[18]*t84; /* (-R*I3)*(s*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) + gamma3*t43) */
    out[13] = t85;
    const double t86 = p[19]*t24; /* 4*R^2*I1*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t87 = t54*t86; /* (1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*gamma3 + t46)*4*R^2*I1*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t88 = JLT_FNMA(p[7], t43, t87); /* t87 - R*G*t43 */
    out[14] = t88;
    const double t89 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t90 = -t89; /* -omega_tau*gamma3 */
    out[24] = t90;
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
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t1;
    const double t2 = p[9]*t0; /* R^2*I1*s*s */
    const double t3 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s*s */
    const double t5 = p[11] + t4; /* Theta/m = I1*I3/m + K */
    const double t6 = t4*t5; /* K*Theta/m */
    const double t7 = 1.0/t6; /* 1/(K*Theta/m) */
    const double t8 = t5*t7; /* 1/K = Theta/m*1/(K*Theta/m) */
    const double t9 = t4*t7; /* 1/(Theta/m) = K*1/(K*Theta/m) */
    const double t10 = x[4]*p[7]; /* s*R*G */
    const double t11 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t12 = JLT_FMA(x[0], t11, t10); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t13 = x[4]*x[3]; /* s*v_tau */
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t15 = JLT_FNMA(x[0], p[12], t13); /* s*v_tau - gamma3*G/I1 */
    const double t16 = t13 + t15; /* s*v_tau + s*v_tau - gamma3*G/I1 */
    const double t17 = t8*t16; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t18 = p[11]*t14; /* I1*I3/m*V */
    const double t19 = JLT_FNMA(t9, t18, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t20 = t12*t14; /* (gamma3*v_tau*R*I3 + s*R*G)*V */
    const double t21 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t22 = -t21; /* -omega_tau*gamma3 */
    out[29] = t22;
    const double t23 = t8*t12; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t24 = t9*t12; /* 1/(Theta/m)*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t25 = -t24; /* -1/(Theta/m)*(gamma3*v_tau*R*I3 + s*R*G) */
    out[21] = t25;
    const double t26 = x[3]*t23; /* v_tau*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[1] = t26;
    const double t27 = x[4]*t8; /* s*1/K */
    const double t28 = x[4]*t21; /* s*omega_tau*gamma3 */
    const double t29 = -t28; /* -s*omega_tau*gamma3 */
    out[4] = t29;
    const double t30 = t8*t11; /* 1/K*v_tau*R*I3 */
    const double t31 = p[22]*t15; /* R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t32 = JLT_FNMA(t28, t31, t20); /* (gamma3*v_tau*R*I3 + s*R*G)*V - s*omega_tau*gamma3*R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t33 = t15*t27; /* (s*v_tau - gamma3*G/I1)*s*1/K */
    const double t34 = p[27]*t28; /* (-R^2*I1*I3*(I1 - I3)/m)*s*omega_tau*gamma3 */
    const double t35 = x[0]*t23; /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t36 = x[0]*t8; /* gamma3*1/K */
    const double t37 = JLT_FMA(t11, t36, t23); /* v_tau*R*I3*gamma3*1/K + 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[13] = t37;
    const double t38 = p[7]*t8; /* R*G*1/K */
    const double t39 = t23*t27; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t40 = t9*t27; /* 1/(Theta/m)*s*1/K */
    const double t41 = t23*t23; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t42 = JLT_FMS(p[17], t39, t41); /* R*I3*G/I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t41 */
    const double t43 = t19*t30; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*v_tau*R*I3 */
    const double t44 = t8 + t9; /* 1/K + 1/(Theta/m) */
    const double t45 = t32*t44; /* t32*(1/K + 1/(Theta/m)) */
    const double t46 = t8*t35; /* 1/K*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t47 = p[21]*t9; /* 2*R^2*I1*I3^2/m*1/(Theta/m) */
    const double t48 = t36*t47; /* gamma3*1/K*2*R^2*I1*I3^2/m*1/(Theta/m) */
    const double t49 = p[23]*t21; /* R^2*I3*G*(I1 - I3)/m*omega_tau*gamma3 */
    const double t50 = JLT_FMS(t40, t49, t43); /* 1/(Theta/m)*s*1/K*R^2*I3*G*(I1 - I3)/m*omega_tau*gamma3 - (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*v_tau*R*I3 */
    const double t51 = JLT_FNMA(t45, t48, t50); /* t50 - t32*(1/K + 1/(Theta/m))*gamma3*1/K*2*R^2*I1*I3^2/m*1/(Theta/m) */
    const double t52 = p[8]*t33; /* R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t53 = p[13]*t9; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t54 = p[24]*t9; /* R*I1*I3/m*1/(Theta/m) */
    const double t55 = t23*t54; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I1*I3/m*1/(Theta/m) */
    const double t56 = p[15]*t39; /* 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t57 = p[16]*t35; /* 4*R^2*I3*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t58 = JLT_FMA(t46, t57, t42); /* 1/K*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*4*R^2*I3*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + R*I3*G/I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t41 */
    const double t59 = p[8]*t23; /* R*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t60 = t17*t59; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1)*R*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t61 = t17*t21; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1)*omega_tau*gamma3 */
    const double t62 = t19*t38; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t63 = JLT_FMS(x[1], t56, t62); /* v_nu*2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t64 = JLT_FNMA(t53, t61, t63); /* t63 - R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*1/K*(s*v_tau + s*v_tau - gamma3*G/I1)*omega_tau*gamma3 */
    const double t65 = t33*t53; /* (s*v_tau - gamma3*G/I1)*s*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t66 = JLT_FNMA(x[0], t65, t55); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I1*I3/m*1/(Theta/m) - gamma3*t65 */
    out[22] = t66;
    const double t67 = p[26]*t33; /* 4*R^3*I3^2*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t68 = JLT_FMA(t46, t67, t58); /* 1/K*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*4*R^3*I3^2*(s*v_tau - gamma3*G/I1)*s*1/K + t58 */
    const double t69 = p[14]*t46; /* 2*R^2*I3*1/K*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t70 = t38 - t56; /* R*G*1/K - 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t71 = x[3]*t70; /* v_tau*(R*G*1/K - 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[14] = t71;
    const double t72 = JLT_FNMA(x[2], t65, t51); /* t51 - omega_tau*t65 */
    const double t73 = JLT_FMA(x[1], t69, t72); /* v_nu*2*R^2*I3*1/K*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + t51 - omega_tau*t65 */
    out[20] = t73;
    const double t74 = t30 - t69; /* 1/K*v_tau*R*I3 - 2*R^2*I3*1/K*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t75 = x[3]*t74; /* v_tau*t74 */
    out[10] = t75;
    const double t76 = t35 + t52; /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t77 = JLT_FMA(2.0, t35, t52); /* 2*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t78 = JLT_FNMA(t30, t77, t68); /* t68 - 1/K*v_tau*R*I3*t77 */
    out[15] = t78;
    const double t79 = t19*t23; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t80 = JLT_FMA(t21, t65, t79); /* omega_tau*gamma3*t65 + t79 */
    const double t81 = -t80; /* -(omega_tau*gamma3*t65 + t79) */
    out[3] = t81;
    const double t82 = t23*t76; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*t76 */
    const double t83 = -t82; /* -1/K*(gamma3*v_tau*R*I3 + s*R*G)*t76 */
    out[2] = t83;
    const double t84 = x[4]*t39; /* s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t85 = p[19]*t39; /* 4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t86 = JLT_FMS(t76, t85, t60); /* t76*4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t60 */
    const double t87 = JLT_FNMA(t38, t77, t86); /* t76*4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t60 - R*G*1/K*t77 */
    out[19] = t87;
    const double t88 = JLT_FMA(t36, t77, t84); /* gamma3*1/K*t77 + s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t89 = p[18]*t88; /* (-R*I3)*(gamma3*1/K*t77 + s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[18] = t89;
    const double t90 = p[18]*t36; /* (-R*I3)*gamma3*1/K */
    const double t91 = t19*t90; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*(-R*I3)*gamma3*1/K */
    const double t92 = JLT_FMA(t34, t40, t91); /* (-R^2*I1*I3*(I1 - I3)/m)*s*omega_tau*gamma3*1/(Theta/m)*s*1/K + (v_nu - 1/(Theta/m)*I1*I3/m*V)*(-R*I3)*gamma3*1/K */
    out[23] = t92;
    const double t93 = p[25]*t40; /* 2*R^2*I1^2*I3/m*1/(Theta/m)*s*1/K */
    const double t94 = JLT_FNMA(t45, t93, t64); /* t64 - t32*(1/K + 1/(Theta/m))*2*R^2*I1^2*I3/m*1/(Theta/m)*s*1/K */
    out[24] = t94;
    const double t95 = x[2]*x[4]; /* omega_tau*s */
    const double t96 = 2.0*t95; /* 2*omega_tau*s */
    out[9] = t96;
    const double t97 = -t95; /* -omega_tau*s */
    out[25] = t97;
    const double t98 = x[4]*x[0]; /* s*gamma3 */
    const double t99 = -t98; /* -s*gamma3 */
    out[27] = t99;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s*s */
    const double t4 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t5 = p[11]*t4; /* I1*I3/m*V */
    const double t6 = x[2]*p[28]; /* omega_tau*R*I1*(I1 - I3)/m */
    const double t7 = JLT_FNMA(t0, t6, t5); /* I1*I3/m*V - s*s*omega_tau*R*I1*(I1 - I3)/m */
    const double t8 = p[11] + t3; /* Theta/m = I1*I3/m + K */
    const double t9 = JLT_FNMA(x[1], t8, t7); /* I1*I3/m*V - s*s*omega_tau*R*I1*(I1 - I3)/m - v_nu*Theta/m */
    const double t10 = t3*t8; /* K*Theta/m */
    const double t11 = p[8]*t9; /* R*I3*(I1*I3/m*V - s*s*omega_tau*R*I1*(I1 - I3)/m - v_nu*Theta/m) */
    const double t12 = t11/t10; /* t11/(K*Theta/m) */
    const double t13 = t12 - x[2]; /* t11/(K*Theta/m) - omega_tau */
    const double t14 = x[0]*t13; /* gamma3*(t11/(K*Theta/m) - omega_tau) */
    out[0] = t14;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[30]*x[0]; /* I3/I1*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K/(R^2*I1) = gamma3*I3/I1*gamma3 + s*s */
    const double t4 = 1.0/t3; /* 1/(K/(R^2*I1)) */
    const double t5 = t3 + p[32]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[31]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = JLT_FMA(t4, t7, t0); /* 1/(K/(R^2*I1))*(Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1)) + v_nu*v_nu */
    const double t9 = p[29]*t8; /* 1/2*m*t8 */
    const double t10 = p[33]*x[2]; /* 1/2*I1*omega_tau */
    const double t11 = JLT_FMA(x[2], t10, t9); /* omega_tau*1/2*I1*omega_tau + 1/2*m*t8 */
    out[0] = t11;
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t13 = p[34]*t12; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t14 = t12*t13; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t15 = x[4]*x[3]; /* s*v_tau */
    const double t16 = JLT_FNMA(x[0], p[12], t15); /* s*v_tau - gamma3*G/I1 */
    const double t17 = t4*t16; /* 1/(K/(R^2*I1))*(s*v_tau - gamma3*G/I1) */
    const double t18 = t5*p[35]; /* Theta/(m*R^2*I1)*m*I1*(I1 - I3) */
    const double t19 = t17*t18; /* 1/(K/(R^2*I1))*(s*v_tau - gamma3*G/I1)*Theta/(m*R^2*I1)*m*I1*(I1 - I3) */
    const double t20 = JLT_FMA(t17, t19, t14); /* 1/(K/(R^2*I1))*(s*v_tau - gamma3*G/I1)*t19 + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[10]*x[0]; /* R^2*I3*gamma3 */
    const double t1 = x[4]*p[9]; /* s*R^2*I1 */
    const double t2 = x[4]*t1; /* s*s*R^2*I1 */
    const double t3 = JLT_FMA(x[0], t0, t2); /* K = gamma3*R^2*I3*gamma3 + s*s*R^2*I1 */
    const double t4 = 1.0/t3; /* 1/K */
    const double t5 = JLT_FMA(p[0], t3, p[37]); /* Theta = m*K + I1*I3 */
    const double t6 = t4*t5; /* 1/K*Theta */
    const double t7 = x[3]*t6; /* v_tau*1/K*Theta */
    out[3] = t7;
    const double t8 = JLT_FNMA(p[36], t7, x[3]); /* v_tau - 1/m*v_tau*1/K*Theta */
    const double t9 = x[3]*t8; /* v_tau*(v_tau - 1/m*v_tau*1/K*Theta) */
    const double t10 = JLT_FNMA(t4, p[38], t9); /* v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m */
    const double t11 = p[0]*t4; /* m*1/K */
    const double t12 = t10*t11; /* (v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m)*m*1/K */
    const double t13 = t0*t12; /* R^2*I3*gamma3*(v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m)*m*1/K */
    out[0] = t13;
    const double t14 = p[0]*x[1]; /* m*v_nu */
    out[1] = t14;
    const double t15 = p[3]*x[2]; /* I1*omega_tau */
    out[2] = t15;
    const double t16 = t1*t12; /* s*R^2*I1*(v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m)*m*1/K */
    out[4] = t16;
    const double t17 = x[4]*x[3]; /* s*v_tau */
    const double t18 = JLT_FNMA(x[0], p[12], t17); /* s*v_tau - gamma3*G/I1 */
    const double t19 = t4*t18; /* 1/K*(s*v_tau - gamma3*G/I1) */
    const double t20 = t6*t19; /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) */
    const double t21 = JLT_FNMA(p[40], t20, t19); /* 1/K*(s*v_tau - gamma3*G/I1) - 2/m*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) */
    const double t22 = t19*t21; /* 1/K*(s*v_tau - gamma3*G/I1)*t21 */
    const double t23 = x[0]*p[39]; /* gamma3*2*m*R^4*I1^2*I3*(I1 - I3) */
    const double t24 = t22*t23; /* 1/K*(s*v_tau - gamma3*G/I1)*t21*gamma3*2*m*R^4*I1^2*I3*(I1 - I3) */
    const double t25 = JLT_FNMA(t20, p[41], t24); /* t24 - 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1*G*(I1 - I3) */
    out[5] = t25;
    const double t26 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t27 = p[42]*t26; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[6] = t27;
    const double t28 = t26*p[43]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[7] = t28;
    const double t29 = t20*p[44]; /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t30 = x[4]*t29; /* s*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    out[8] = t30;
    const double t31 = x[3]*t29; /* v_tau*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t32 = x[4]*p[45]; /* s*2*m*R^4*I1^3*(I1 - I3) */
    const double t33 = JLT_FMA(t22, t32, t31); /* 1/K*(s*v_tau - gamma3*G/I1)*t21*s*2*m*R^4*I1^3*(I1 - I3) + t31 */
    out[9] = t33;
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
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t6[k] = x4[k]*p[7];
        t9[k] = x3[k]*p[8];
        t10[k] = jlt_jet_product(x0, t9, k) + t6[k];
        t12[k] = x4[k]*p[9];
        t13[k] = jlt_jet_product(x4, t12, k);
        t15[k] = x0[k]*p[10];
        t16[k] = jlt_jet_product(x0, t15, k) + t13[k];
        t18[k] = t16[k] + (k == 0 ? p[11] : 0);
        t19[k] = jlt_jet_product(t16, t18, k);
        t21[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t19, t21, k);
        t22[k] = jlt_jet_product(t18, t21, k);
        t23[k] = jlt_jet_product(t10, t22, k);
        t24[k] = jlt_jet_product(x3, t23, k);
        t25[k] = jlt_jet_product(x4, x3, k);
        t27[k] = t25[k] - x0[k]*p[12];
        t28[k] = jlt_jet_product(t22, t27, k);
        t29[k] = x4[k]*p[8];
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = jlt_jet_product(x0, t23, k) + t30[k];
        t32[k] = jlt_jet_product(t23, t31, k);
        t33[k] = -t32[k];
        t36[k] = x2[k]*p[1] + x1[k];
        t37[k] = jlt_jet_product(t16, t21, k);
        t38[k] = p[11]*t36[k];
        t39[k] = x1[k] - jlt_jet_product(t37, t38, k);
        t40[k] = jlt_jet_product(t23, t39, k);
        t42[k] = jlt_jet_product(t2, x0, k);
        t43[k] = p[13]*t42[k];
        t44[k] = jlt_jet_product(t37, t43, k);
        t45[k] = jlt_jet_product(t28, t44, k) + t40[k];
        t46[k] = -t45[k];
        t47[k] = -t42[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t24[k]/(k + 1);
        next[2] = x2[k + 1] = t33[k]/(k + 1);
        next[3] = x3[k + 1] = t46[k]/(k + 1);
        next[4] = x4[k + 1] = t47[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_v_tau = x[3];
    const double v_R = params[1];
    const double v_I1 = params[3];
    const double v_I3 = params[4];
    const double v_a3 = (0.0);
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_K = (v_R*v_R*v_I1*v_s*v_s + v_I3*v_b*v_b);
    const double v_G = params[6];
    const double complex v_omega_n = ((v_R*v_G*v_s + v_I3*v_v_tau*v_b)/v_K);
    out[1] = (v_s)*((v_v_tau*v_omega_n/v_s));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double complex v_omega3 = ((v_R*v_I1*v_v_tau*v_s - v_G*v_b)/v_K);
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_v_nu = x[1];
    const double complex v_Theta = (v_m*v_K + v_I1*v_I3);
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((-v_v_nu*v_omega_n/v_s)
        + (v_I1*v_I3*v_V*v_omega_n/(v_s*v_Theta))
        + (-v_I3*v_omega_tau*v_omega3*(v_R*v_gamma3*(v_I1 - v_I3) - v_I3*v_a3)/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0) },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_balanced_in_regular = {
    .model = "spherical_top_level",
    .variant = "balanced",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "a03ac57982f08b300ad072746897d22dbcd0a4e4ebdedbf1bb5bf573f26d0de6",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 46,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 22, 7, 1, 0, 0, 12, 7 }, { 16, 71, 0, 6, 0, 0, 10, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1), a part of d(omega_tau)/dtau, V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(v_tau)/dtau" },
    .jacobian = { jacobian, 25, { 9, 55, 26, 1, 0, 0, 14, 23 }, { 91, 507, 0, 46, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1), s*v_tau + s*v_tau - gamma3*(G/I1), d(d(v_nu)/dtau)/d(v_tau), V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, (R*I3)*(s*v_tau - gamma3*(G/I1))*(4*R^2*I3)*gamma3*1/K + R*I3*G/I1, a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(gamma3), a part of d(d(v_nu)/dtau)/d(gamma3), (R*G)*1/K - (2*R^2*I1)*s*1/K*1/K*(gamma3*v_tau*(R*I3) + s*(R*G)), d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(omega_tau), a part of d(d(v_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(omega_tau)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 13, 61, 25, 1, 0, 0, 13, 23 }, { 104, 567, 0, 52, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), V = omega_tau*R + v_nu, s*v_tau - gamma3*(G/I1), s*v_tau + s*v_tau - gamma3*(G/I1), v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(omega_tau), (R*G)*1/K - (2*R^2*I1)*1/K*(gamma3*v_tau*(R*I3) + s*(R*G))*s*1/K, d(d(v_tau)/dtau)/d(gamma3), a part of d(d(v_nu)/dtau)/d(gamma3), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(gamma3), a part of d(v_tau)/dtau, d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 2, 8, 4, 1, 0, 0, 9, 5 }, { 8, 30, 0, 3, 0, 0, 10, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in V = R*omega_tau + v_nu, (I1*I3/m)*V - s*s*omega_tau*(R*I1*(I1 - I3)/m) - v_nu*Theta/m, a part of the divergence" },
    .integral_values = { integral_values, 2, { 1, 12, 7, 1, 0, 0, 7, 5 }, { 9, 35, 0, 3, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in omega_tau*R + v_nu, s*v_tau - gamma3*(G/I1), F0" },
    .integral_gradients = { integral_gradients, 10, { 0, 24, 9, 1, 0, 0, 11, 7 }, { 26, 155, 0, 14, 0, 0, 13, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in v_tau - (1/m)*v_tau*((1)/K)*Theta, v_tau*(v_tau - (1/m)*v_tau*((1)/K)*Theta) - ((1)/K)*(G^2/m), s*v_tau - gamma3*(G/I1), a part of d(F0)/d(gamma3) and of d(F0)/d(s), d(F0)/d(gamma3), omega_tau*R + v_nu, d(F0)/d(s)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_level_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_level_balanced_in_regular_baseline,
        &jlt_batch_spherical_top_level_balanced_in_regular_avx2,
        &jlt_batch_spherical_top_level_balanced_in_regular_avx512,
    },
#endif
};
