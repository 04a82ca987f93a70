/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 a0362d7aafe4ac095061c9e2c7f9417b05b6c21c51ed0a0e3c3f227f5c7cacca
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   22    7    1    0    0     12    7   (93)
 *  jacobian            9   57   26    1    0    0     14   21   (644)
 *  rhs_jacobian        12   56   26    1    0    0     14   19   (723)
 *  divergence          3    8    4    1    0    0     10    5   (41)
 *  integral_values     1   12    7    1    0    0      7    5   (47)
 *  integral_gradients  0   24    9    1    0    0     11    7   (195)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1),
 *      s*v_tau + s*v_tau - gamma3*(G/I1), V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V,
 *      a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(v_tau),
 *      d(d(v_nu)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(v_nu), d(d(v_tau)/dtau)/d(omega_tau),
 *      a part of d(d(v_nu)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(gamma3),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s),
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s),
 *      (R*G)*1/K - (2*R^2*I1)*s*1/K*1/K*(gamma3*v_tau*(R*I3) + s*(R*G)), d(d(v_tau)/dtau)/d(s),
 *      a part of d(v_tau)/dtau, d(d(v_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3),
 *      d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(omega_tau)/dtau)/d(s)
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
    out[35] = t5;
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
    const double t17 = params[1]*t2; /* R*R*R */
    const double t18 = 4.0*t17; /* 4*R*R*R */
    const double t19 = params[4]*params[4]; /* I3*I3 */
    const double t20 = t18*t19; /* 4*R*R*R*I3*I3 */
    out[17] = t20;
    const double t21 = params[6]*t1; /* G*R*I3 */
    const double t22 = t21/params[3]; /* G*R*I3/I1 */
    out[18] = t22;
    const double t23 = -t1; /* -R*I3 */
    out[19] = t23;
    const double t24 = params[3]*t15; /* I1*R*R*4 */
    out[20] = t24;
    const double t25 = t14*t19; /* I1*R*R*2*I3*I3 */
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
    const double t38 = t9*t31; /* (I1 - I3)*R*I1 */
    const double t39 = t38/params[0]; /* (I1 - I3)*R*I1/m */
    out[26] = t39;
    const double t40 = params[0]/2.0; /* m/2 */
    out[27] = t40;
    const double t41 = params[4]/params[3]; /* I3/I1 */
    out[28] = t41;
    const double t42 = t2*params[0]; /* R*R*m */
    const double t43 = params[3]*t42; /* I1*R*R*m */
    const double t44 = params[6]*params[6]; /* G*G */
    const double t45 = t44/t43; /* G*G/(I1*R*R*m) */
    out[29] = t45;
    const double t46 = params[4]/t42; /* I3/(R*R*m) */
    out[30] = t46;
    const double t47 = params[3]/2.0; /* I1/2 */
    out[31] = t47;
    const double t48 = params[0]*t34; /* m*I1*I1 */
    out[32] = t48;
    const double t49 = params[3]*params[0]; /* I1*m */
    const double t50 = t9*t49; /* (I1 - I3)*I1*m */
    out[33] = t50;
    const double t51 = 1.0/params[0]; /* 1/m */
    out[34] = t51;
    const double t52 = t44/params[0]; /* G*G/m */
    out[36] = t52;
    const double t53 = t2*t2; /* R*R*R*R */
    const double t54 = (-4.0)*t53; /* (-4)*R*R*R*R */
    const double t55 = t34*t54; /* I1*I1*(-4)*R*R*R*R */
    const double t56 = params[4]*t55; /* I3*I1*I1*(-4)*R*R*R*R */
    const double t57 = t9*t56; /* (I1 - I3)*I3*I1*I1*(-4)*R*R*R*R */
    out[37] = t57;
    const double t58 = t2*(-2.0); /* R*R*(-2) */
    const double t59 = params[3]*t58; /* I1*R*R*(-2) */
    const double t60 = params[6]*t59; /* G*I1*R*R*(-2) */
    const double t61 = t9*t60; /* (I1 - I3)*G*I1*R*R*(-2) */
    out[38] = t61;
    const double t62 = params[0]*2.0; /* m*2 */
    const double t63 = t34*t62; /* I1*I1*m*2 */
    out[39] = t63;
    const double t64 = params[1]*t62; /* R*m*2 */
    const double t65 = t34*t64; /* I1*I1*R*m*2 */
    out[40] = t65;
    const double t66 = t9*t35; /* (I1 - I3)*R*R*2*I1*I1 */
    out[41] = t66;
    const double t67 = 4.0*t53; /* 4*R*R*R*R */
    const double t68 = params[3]*t34; /* I1*I1*I1 */
    const double t69 = t67*t68; /* 4*R*R*R*R*I1*I1*I1 */
    const double t70 = t9*t69; /* (I1 - I3)*4*R*R*R*R*I1*I1*I1 */
    out[42] = t70;
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
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[4] = t2;
    const double t3 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t4 = t0*p[9]; /* s*s*R^2*I1 */
    const double t5 = p[10]*x[0]; /* R^2*I3*gamma3 */
    const double t6 = JLT_FMA(x[0], t5, t4); /* K = gamma3*R^2*I3*gamma3 + s*s*R^2*I1 */
    const double t7 = t6 + p[11]; /* Theta/m = K + I1*I3/m */
    const double t8 = t6*t7; /* K*Theta/m */
    const double t9 = 1.0/t8; /* 1/(K*Theta/m) */
    const double t10 = t7*t9; /* 1/K = Theta/m*1/(K*Theta/m) */
    const double t11 = x[4]*p[7]; /* s*R*G */
    const double t12 = JLT_FMA(t3, x[0], t11); /* v_tau*R*I3*gamma3 + s*R*G */
    const double t13 = t10*t12; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t14 = x[0]*t10; /* gamma3*1/K */
    const double t15 = t13*t14; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K */
    const double t16 = p[14]*t15; /* 2*R^2*I3*1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K */
    const double t17 = JLT_FMS(t3, t10, t16); /* v_tau*R*I3*1/K - 2*R^2*I3*1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K */
    const double t18 = x[3]*t17; /* v_tau*t17 */
    out[5] = t18;
    const double t19 = JLT_FMA(t3, t14, t13); /* v_tau*R*I3*gamma3*1/K + 1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    out[8] = t19;
    const double t20 = t10*p[7]; /* 1/K*R*G */
    const double t21 = x[4]*t10; /* s*1/K */
    const double t22 = t13*t21; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K */
    const double t23 = p[15]*t22; /* 2*R^2*I1*1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K */
    const double t24 = t20 - t23; /* 1/K*R*G - 2*R^2*I1*1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K */
    const double t25 = x[3]*t24; /* v_tau*(1/K*R*G - 2*R^2*I1*1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K) */
    out[9] = t25;
    const double t26 = x[0]*p[16]; /* gamma3*4*R^2*I3 */
    const double t27 = JLT_FMS(t15, t26, t13); /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K*gamma3*4*R^2*I3 - 1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t28 = p[8]*t10; /* R*I3*1/K */
    const double t29 = x[4]*x[3]; /* s*v_tau */
    const double t30 = JLT_FNMA(x[0], p[12], t29); /* s*v_tau - gamma3*G/I1 */
    const double t31 = t21*t30; /* s*1/K*(s*v_tau - gamma3*G/I1) */
    const double t32 = t28*t31; /* R*I3*1/K*s*1/K*(s*v_tau - gamma3*G/I1) */
    const double t33 = JLT_FMA(2.0, t15, t32); /* 2*1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K + R*I3*1/K*s*1/K*(s*v_tau - gamma3*G/I1) */
    const double t34 = t30*p[17]; /* (s*v_tau - gamma3*G/I1)*4*R^3*I3^2 */
    const double t35 = t14*t34; /* gamma3*1/K*(s*v_tau - gamma3*G/I1)*4*R^3*I3^2 */
    const double t36 = t22*t35; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K*gamma3*1/K*(s*v_tau - gamma3*G/I1)*4*R^3*I3^2 */
    const double t37 = JLT_FMA(t22, p[18], t36); /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K*R*I3*G/I1 + t36 */
    const double t38 = JLT_FMA(t13, t27, t37); /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*t27 + 1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K*R*I3*G/I1 + t36 */
    const double t39 = JLT_FNMA(t3, t33, t38); /* t38 - v_tau*R*I3*t33 */
    out[10] = t39;
    const double t40 = x[4]*t22; /* s*1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K */
    const double t41 = JLT_FMA(x[0], t33, t40); /* gamma3*t33 + s*1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K */
    const double t42 = p[19]*t41; /* (-R*I3)*(gamma3*t33 + s*1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K) */
    out[13] = t42;
    const double t43 = t29 + t30; /* s*v_tau + s*v_tau - gamma3*G/I1 */
    const double t44 = t13*t43; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t45 = t28*t44; /* R*I3*1/K*t44 */
    const double t46 = t12*t14; /* (v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K */
    const double t47 = JLT_FMA(p[8], t31, t46); /* R*I3*s*1/K*(s*v_tau - gamma3*G/I1) + (v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K */
    const double t48 = t22*p[20]; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K*4*R^2*I1 */
    const double t49 = JLT_FMS(t47, t48, t45); /* t47*1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K*4*R^2*I1 - R*I3*1/K*t44 */
    const double t50 = JLT_FNMA(p[7], t33, t49); /* t49 - R*G*t33 */
    out[14] = t50;
    const double t51 = t6*t9; /* 1/(Theta/m) = K*1/(K*Theta/m) */
    const double t52 = t1*t30; /* s*omega_tau*(s*v_tau - gamma3*G/I1) */
    const double t53 = t51*t52; /* 1/(Theta/m)*s*omega_tau*(s*v_tau - gamma3*G/I1) */
    const double t54 = p[13]*t53; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*s*omega_tau*(s*v_tau - gamma3*G/I1) */
    const double t55 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t56 = t51*t55; /* 1/(Theta/m)*V */
    const double t57 = JLT_FNMA(p[11], t56, x[1]); /* v_nu - I1*I3/m*1/(Theta/m)*V */
    const double t58 = JLT_FMA(t3, t57, t54); /* v_tau*R*I3*(v_nu - I1*I3/m*1/(Theta/m)*V) + t54 */
    const double t59 = t16*x[1]; /* 2*R^2*I3*1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K*v_nu */
    const double t60 = t10 + t51; /* 1/K + 1/(Theta/m) */
    const double t61 = x[0]*p[22]; /* gamma3*R^2*(I1 - I3) */
    const double t62 = t53*t61; /* 1/(Theta/m)*s*omega_tau*(s*v_tau - gamma3*G/I1)*gamma3*R^2*(I1 - I3) */
    const double t63 = JLT_FNMA(t12, t56, t62); /* t62 - (v_tau*R*I3*gamma3 + s*R*G)*1/(Theta/m)*V */
    const double t64 = t60*t63; /* (1/K + 1/(Theta/m))*(t62 - (v_tau*R*I3*gamma3 + s*R*G)*1/(Theta/m)*V) */
    const double t65 = t14*p[21]; /* gamma3*1/K*2*R^2*I1*I3^2/m */
    const double t66 = t14*t51; /* gamma3*1/K*1/(Theta/m) */
    const double t67 = t1*p[23]; /* s*omega_tau*R^2*I3*G*(I1 - I3)/m */
    const double t68 = JLT_FMA(t66, t67, t59); /* gamma3*1/K*1/(Theta/m)*s*omega_tau*R^2*I3*G*(I1 - I3)/m + 2*R^2*I3*1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K*v_nu */
    const double t69 = JLT_FMA(t64, t65, t68); /* t64*gamma3*1/K*2*R^2*I1*I3^2/m + t68 */
    const double t70 = JLT_FNMA(t10, t58, t69); /* t64*gamma3*1/K*2*R^2*I1*I3^2/m + t68 - 1/K*(v_tau*R*I3*(v_nu - I1*I3/m*1/(Theta/m)*V) + t54) */
    out[15] = t70;
    const double t71 = t12*t51; /* (v_tau*R*I3*gamma3 + s*R*G)*1/(Theta/m) */
    const double t72 = -t71; /* -(v_tau*R*I3*gamma3 + s*R*G)*1/(Theta/m) */
    out[16] = t72;
    const double t73 = t51*p[24]; /* 1/(Theta/m)*R*I1*I3/m */
    const double t74 = t13*t73; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*1/(Theta/m)*R*I1*I3/m */
    const double t75 = p[13]*t66; /* R^2*I1*I3*(I1 - I3)/m*gamma3*1/K*1/(Theta/m) */
    const double t76 = x[4]*t75; /* s*R^2*I1*I3*(I1 - I3)/m*gamma3*1/K*1/(Theta/m) */
    const double t77 = JLT_FNMA(t30, t76, t74); /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*1/(Theta/m)*R*I1*I3/m - (s*v_tau - gamma3*G/I1)*s*R^2*I1*I3*(I1 - I3)/m*gamma3*1/K*1/(Theta/m) */
    out[17] = t77;
    const double t78 = t1*t76; /* s*omega_tau*s*R^2*I1*I3*(I1 - I3)/m*gamma3*1/K*1/(Theta/m) */
    const double t79 = p[8]*t14; /* R*I3*gamma3*1/K */
    const double t80 = JLT_FMA(t57, t79, t78); /* (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*gamma3*1/K + s*omega_tau*s*R^2*I1*I3*(I1 - I3)/m*gamma3*1/K*1/(Theta/m) */
    const double t81 = -t80; /* -t80 */
    out[18] = t81;
    const double t82 = t20*t57; /* 1/K*R*G*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t83 = x[2]*t43; /* omega_tau*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t84 = t21*p[25]; /* s*1/K*2*R^2*I1^2*I3/m */
    const double t85 = JLT_FMS(t23, x[1], t82); /* 2*R^2*I1*1/K*(v_tau*R*I3*gamma3 + s*R*G)*s*1/K*v_nu - 1/K*R*G*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t86 = JLT_FNMA(t75, t83, t85); /* t85 - R^2*I1*I3*(I1 - I3)/m*gamma3*1/K*1/(Theta/m)*omega_tau*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t87 = JLT_FMA(t64, t84, t86); /* t64*s*1/K*2*R^2*I1^2*I3/m + t86 */
    out[19] = t87;
    const double t88 = -t1; /* -s*omega_tau */
    out[20] = t88;
    const double t89 = x[4]*x[0]; /* s*gamma3 */
    const double t90 = -t89; /* -s*gamma3 */
    out[22] = t90;
    const double t91 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t92 = -t91; /* -omega_tau*gamma3 */
    out[24] = t92;
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
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s*s */
    const double t4 = p[11] + t3; /* Theta/m = I1*I3/m + K */
    const double t5 = t3*t4; /* K*Theta/m */
    const double t6 = 1.0/t5; /* 1/(K*Theta/m) */
    const double t7 = t4*t6; /* 1/K = Theta/m*1/(K*Theta/m) */
    const double t8 = t3*t6; /* 1/(Theta/m) = K*1/(K*Theta/m) */
    const double t9 = x[4]*p[7]; /* s*R*G */
    const double t10 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t11 = JLT_FMA(x[0], t10, t9); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t12 = x[4]*x[3]; /* s*v_tau */
    const double t13 = x[4]*x[2]; /* s*omega_tau */
    const double t14 = 2.0*t13; /* 2*s*omega_tau */
    out[9] = t14;
    const double t15 = -t13; /* -s*omega_tau */
    out[25] = t15;
    const double t16 = JLT_FNMA(x[0], p[12], t12); /* s*v_tau - gamma3*G/I1 */
    const double t17 = t12 + t16; /* s*v_tau + s*v_tau - gamma3*G/I1 */
    const double t18 = t7*t17; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t19 = x[4]*t7; /* s*1/K */
    const double t20 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t21 = t7*t11; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t22 = t11*t20; /* (gamma3*v_tau*R*I3 + s*R*G)*V */
    const double t23 = p[11]*t20; /* I1*I3/m*V */
    const double t24 = JLT_FNMA(t8, t23, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t25 = x[3]*t21; /* v_tau*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[1] = t25;
    const double t26 = t16*t19; /* (s*v_tau - gamma3*G/I1)*s*1/K */
    const double t27 = p[22]*t16; /* R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t28 = x[0]*t13; /* gamma3*s*omega_tau */
    const double t29 = JLT_FNMA(t27, t28, t22); /* (gamma3*v_tau*R*I3 + s*R*G)*V - R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1)*gamma3*s*omega_tau */
    const double t30 = -t28; /* -gamma3*s*omega_tau */
    out[4] = t30;
    const double t31 = t8*t29; /* 1/(Theta/m)*t29 */
    const double t32 = x[4]*t13; /* s*s*omega_tau */
    out[0] = t32;
    const double t33 = p[23]*t13; /* R^2*I3*G*(I1 - I3)/m*s*omega_tau */
    const double t34 = t8*t33; /* 1/(Theta/m)*R^2*I3*G*(I1 - I3)/m*s*omega_tau */
    const double t35 = p[8]*t26; /* R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t36 = x[0]*t21; /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t37 = p[13]*t8; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t38 = t26*t37; /* (s*v_tau - gamma3*G/I1)*s*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t39 = t32*t37; /* s*s*omega_tau*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t40 = JLT_FMA(p[8], t24, t39); /* R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V) + s*s*omega_tau*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t41 = p[7]*t7; /* R*G*1/K */
    const double t42 = t19*t21; /* s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t43 = p[25]*t19; /* 2*R^2*I1^2*I3/m*s*1/K */
    const double t44 = t7*t10; /* 1/K*v_tau*R*I3 */
    const double t45 = x[0]*t7; /* gamma3*1/K */
    const double t46 = JLT_FMA(t10, t45, t21); /* v_tau*R*I3*gamma3*1/K + 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[13] = t46;
    const double t47 = t7 + t8; /* 1/K + 1/(Theta/m) */
    const double t48 = t31*t47; /* 1/(Theta/m)*t29*(1/K + 1/(Theta/m)) */
    const double t49 = t8*t21; /* 1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t50 = t40*t45; /* t40*gamma3*1/K */
    const double t51 = -t50; /* -t40*gamma3*1/K */
    out[23] = t51;
    const double t52 = JLT_FMS(p[11], t49, t21); /* I1*I3/m*1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) - 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[21] = t52;
    const double t53 = p[24]*t49; /* R*I1*I3/m*1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t54 = JLT_FNMA(x[0], t38, t53); /* R*I1*I3/m*1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) - gamma3*t38 */
    out[22] = t54;
    const double t55 = x[2]*t38; /* omega_tau*t38 */
    const double t56 = p[14]*t21; /* 2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t57 = JLT_FMA(x[1], t56, t34); /* v_nu*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + 1/(Theta/m)*R^2*I3*G*(I1 - I3)/m*s*omega_tau */
    const double t58 = JLT_FNMA(t45, t56, t44); /* 1/K*v_tau*R*I3 - gamma3*1/K*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t59 = x[3]*t58; /* v_tau*t58 */
    out[10] = t59;
    const double t60 = JLT_FNMA(p[21], t48, t57); /* t57 - 2*R^2*I1*I3^2/m*1/(Theta/m)*t29*(1/K + 1/(Theta/m)) */
    const double t61 = p[15]*t42; /* 2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t62 = JLT_FMA(2.0, t36, t35); /* 2*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t63 = t35 + t36; /* R*I3*(s*v_tau - gamma3*G/I1)*s*1/K + gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t64 = p[8]*t21; /* R*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t65 = t18*t64; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1)*R*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t66 = t24*t41; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t67 = JLT_FMS(x[1], t61, t66); /* v_nu*2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) - (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t68 = t41 - t61; /* R*G*1/K - 2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t69 = x[3]*t68; /* v_tau*(R*G*1/K - 2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G)) */
    out[14] = t69;
    const double t70 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t71 = t37*t70; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*omega_tau*gamma3 */
    const double t72 = JLT_FNMA(t18, t71, t67); /* t67 - 1/K*(s*v_tau + s*v_tau - gamma3*G/I1)*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*omega_tau*gamma3 */
    const double t73 = JLT_FNMA(t43, t48, t72); /* t72 - 2*R^2*I1^2*I3/m*s*1/K*1/(Theta/m)*t29*(1/K + 1/(Theta/m)) */
    out[24] = t73;
    const double t74 = -t70; /* -omega_tau*gamma3 */
    out[29] = t74;
    const double t75 = t21*t24; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t76 = JLT_FMA(x[0], t55, t75); /* gamma3*omega_tau*t38 + t75 */
    const double t77 = JLT_FMA(t24, t44, t55); /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*v_tau*R*I3 + omega_tau*t38 */
    const double t78 = JLT_FMS(t45, t60, t77); /* gamma3*1/K*(t57 - 2*R^2*I1*I3^2/m*1/(Theta/m)*t29*(1/K + 1/(Theta/m))) - t77 */
    out[20] = t78;
    const double t79 = -t76; /* -(gamma3*omega_tau*t38 + t75) */
    out[3] = t79;
    const double t80 = t44*t62; /* 1/K*v_tau*R*I3*t62 */
    const double t81 = JLT_FMS(p[18], t42, t80); /* R*I3*G/I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) - 1/K*v_tau*R*I3*t62 */
    const double t82 = p[16]*t45; /* 4*R^2*I3*gamma3*1/K */
    const double t83 = JLT_FMS(t63, t82, t21); /* t63*4*R^2*I3*gamma3*1/K - 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t84 = JLT_FMA(t21, t83, t81); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*(t63*4*R^2*I3*gamma3*1/K - 1/K*(gamma3*v_tau*R*I3 + s*R*G)) + t81 */
    out[15] = t84;
    const double t85 = t21*t63; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*t63 */
    const double t86 = -t85; /* -1/K*(gamma3*v_tau*R*I3 + s*R*G)*t63 */
    out[2] = t86;
    const double t87 = x[4]*t42; /* s*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t88 = JLT_FMA(t45, t62, t87); /* gamma3*1/K*t62 + s*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t89 = p[19]*t88; /* (-R*I3)*(gamma3*1/K*t62 + s*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G)) */
    out[18] = t89;
    const double t90 = p[20]*t42; /* 4*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t91 = JLT_FMS(t63, t90, t65); /* t63*4*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) - t65 */
    const double t92 = JLT_FNMA(t41, t62, t91); /* t63*4*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) - t65 - R*G*1/K*t62 */
    out[19] = t92;
    const double t93 = x[4]*x[0]; /* s*gamma3 */
    const double t94 = -t93; /* -s*gamma3 */
    out[27] = t94;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s*s */
    const double t4 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t5 = p[11]*t4; /* I1*I3/m*V */
    const double t6 = x[2]*p[26]; /* omega_tau*R*I1*(I1 - I3)/m */
    const double t7 = JLT_FNMA(t0, t6, t5); /* I1*I3/m*V - s*s*omega_tau*R*I1*(I1 - I3)/m */
    const double t8 = p[11] + t3; /* Theta/m = I1*I3/m + K */
    const double t9 = JLT_FNMA(x[1], t8, t7); /* I1*I3/m*V - s*s*omega_tau*R*I1*(I1 - I3)/m - v_nu*Theta/m */
    const double t10 = t3*t8; /* K*Theta/m */
    const double t11 = p[8]*t9; /* R*I3*(I1*I3/m*V - s*s*omega_tau*R*I1*(I1 - I3)/m - v_nu*Theta/m) */
    const double t12 = t11/t10; /* t11/(K*Theta/m) */
    const double t13 = x[2] - t12; /* omega_tau - t11/(K*Theta/m) */
    const double t14 = x[0]*t13; /* gamma3*(omega_tau - t11/(K*Theta/m)) */
    const double t15 = -t14; /* -gamma3*(omega_tau - t11/(K*Theta/m)) */
    out[0] = t15;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[28]*x[0]; /* I3/I1*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K/(R^2*I1) = gamma3*I3/I1*gamma3 + s*s */
    const double t4 = 1.0/t3; /* 1/(K/(R^2*I1)) */
    const double t5 = t3 + p[30]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[29]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = JLT_FMA(t4, t7, t0); /* 1/(K/(R^2*I1))*(Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1)) + v_nu*v_nu */
    const double t9 = p[27]*t8; /* 1/2*m*t8 */
    const double t10 = p[31]*x[2]; /* 1/2*I1*omega_tau */
    const double t11 = JLT_FMA(x[2], t10, t9); /* omega_tau*1/2*I1*omega_tau + 1/2*m*t8 */
    out[0] = t11;
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t13 = p[32]*t12; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t14 = t12*t13; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t15 = x[4]*x[3]; /* s*v_tau */
    const double t16 = JLT_FNMA(x[0], p[12], t15); /* s*v_tau - gamma3*G/I1 */
    const double t17 = t4*t16; /* 1/(K/(R^2*I1))*(s*v_tau - gamma3*G/I1) */
    const double t18 = t5*p[33]; /* Theta/(m*R^2*I1)*m*I1*(I1 - I3) */
    const double t19 = t17*t18; /* 1/(K/(R^2*I1))*(s*v_tau - gamma3*G/I1)*Theta/(m*R^2*I1)*m*I1*(I1 - I3) */
    const double t20 = JLT_FMA(t17, t19, t14); /* 1/(K/(R^2*I1))*(s*v_tau - gamma3*G/I1)*t19 + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*p[9]; /* s*R^2*I1 */
    const double t1 = x[4]*t0; /* s*s*R^2*I1 */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + s*s*R^2*I1 */
    const double t4 = 1.0/t3; /* 1/K */
    const double t5 = JLT_FMA(p[0], t3, p[35]); /* Theta = m*K + I1*I3 */
    const double t6 = t4*t5; /* 1/K*Theta */
    const double t7 = x[3]*t6; /* v_tau*1/K*Theta */
    out[3] = t7;
    const double t8 = JLT_FNMA(p[34], t7, x[3]); /* v_tau - 1/m*v_tau*1/K*Theta */
    const double t9 = x[3]*t8; /* v_tau*(v_tau - 1/m*v_tau*1/K*Theta) */
    const double t10 = JLT_FNMA(t4, p[36], t9); /* v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m */
    const double t11 = p[0]*t4; /* m*1/K */
    const double t12 = t10*t11; /* (v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m)*m*1/K */
    const double t13 = t2*t12; /* gamma3*R^2*I3*(v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m)*m*1/K */
    out[0] = t13;
    const double t14 = p[0]*x[1]; /* m*v_nu */
    out[1] = t14;
    const double t15 = p[3]*x[2]; /* I1*omega_tau */
    out[2] = t15;
    const double t16 = t0*t12; /* s*R^2*I1*(v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m)*m*1/K */
    out[4] = t16;
    const double t17 = x[4]*x[3]; /* s*v_tau */
    const double t18 = JLT_FNMA(x[0], p[12], t17); /* s*v_tau - gamma3*G/I1 */
    const double t19 = t4*t18; /* 1/K*(s*v_tau - gamma3*G/I1) */
    const double t20 = t6*t19; /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) */
    const double t21 = JLT_FNMA(t19, p[27], t20); /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) - 1/K*(s*v_tau - gamma3*G/I1)*1/2*m */
    const double t22 = t19*t21; /* 1/K*(s*v_tau - gamma3*G/I1)*t21 */
    const double t23 = x[0]*p[37]; /* gamma3*(-4*R^4*I1^2*I3*(I1 - I3)) */
    const double t24 = t22*t23; /* 1/K*(s*v_tau - gamma3*G/I1)*t21*gamma3*(-4*R^4*I1^2*I3*(I1 - I3)) */
    const double t25 = JLT_FMA(t20, p[38], t24); /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*(-2*R^2*I1*G*(I1 - I3)) + t24 */
    out[5] = t25;
    const double t26 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t27 = p[39]*t26; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[6] = t27;
    const double t28 = t26*p[40]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[7] = t28;
    const double t29 = t20*p[41]; /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t30 = x[4]*t29; /* s*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    out[8] = t30;
    const double t31 = x[3]*t29; /* v_tau*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t32 = x[4]*p[42]; /* s*4*R^4*I1^3*(I1 - I3) */
    const double t33 = JLT_FNMA(t22, t32, t31); /* t31 - 1/K*(s*v_tau - gamma3*G/I1)*t21*s*4*R^4*I1^3*(I1 - I3) */
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
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0), 0.0 },
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
    .sha256 = "a0362d7aafe4ac095061c9e2c7f9417b05b6c21c51ed0a0e3c3f227f5c7cacca",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 43,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 22, 7, 1, 0, 0, 12, 7 }, { 16, 71, 0, 6, 0, 0, 10, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1), a part of d(omega_tau)/dtau, V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(v_tau)/dtau" },
    .jacobian = { jacobian, 25, { 9, 57, 26, 1, 0, 0, 14, 21 }, { 91, 507, 0, 46, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in v_tau*(R*I3)*gamma3 + s*(R*G), a part of d(d(v_nu)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(v_tau), 1/K*(R*G) - (2*R^2*I1)*1/K*(v_tau*(R*I3)*gamma3 + s*(R*G))*s*1/K, a part of d(d(omega_tau)/dtau)/d(gamma3), s*v_tau - gamma3*(G/I1), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), s*v_tau + s*v_tau - gamma3*(G/I1), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), V = omega_tau*R + v_nu, v_nu - (I1*I3/m)*1/(Theta/m)*V, a part of d(d(v_tau)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(omega_tau), a part of d(d(v_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 12, 56, 26, 1, 0, 0, 14, 19 }, { 104, 567, 0, 52, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1), s*v_tau + s*v_tau - gamma3*(G/I1), V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(v_tau), d(d(v_nu)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(v_nu), d(d(v_tau)/dtau)/d(omega_tau), a part of d(d(v_nu)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), (R*G)*1/K - (2*R^2*I1)*s*1/K*1/K*(gamma3*v_tau*(R*I3) + s*(R*G)), d(d(v_tau)/dtau)/d(s), a part of d(v_tau)/dtau, d(d(v_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(omega_tau)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 3, 8, 4, 1, 0, 0, 10, 5 }, { 8, 30, 0, 3, 0, 0, 10, 7 },
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
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
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
