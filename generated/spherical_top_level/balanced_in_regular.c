/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   22    7    1    0    0     12    7   (93)
 *  jacobian            8   57   27    1    0    0     14   19   (644)
 *  rhs_jacobian        14   60   24    1    0    0     14   21   (723)
 *  divergence          2    8    4    1    0    0      9    5   (41)
 *  integral_values     1   12    7    1    0    0      7    5   (47)
 *  integral_gradients  0   24    9    1    0    0     10    7   (195)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1),
 *      s*v_tau + s*v_tau - gamma3*(G/I1), V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V,
 *      a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(v_tau),
 *      d(d(v_tau)/dtau)/d(omega_tau),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s),
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s),
 *      d(d(v_tau)/dtau)/d(gamma3), a part of d(d(v_nu)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(v_tau),
 *      a part of d(v_tau)/dtau, d(d(v_tau)/dtau)/d(s),
 *      (R*G)*1/K - (2*R^2*I1)*s*1/K*1/K*(gamma3*v_tau*(R*I3) + s*(R*G)), a part of d(d(omega_tau)/dtau)/d(gamma3),
 *      d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(omega_tau)/dtau)/d(s)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_chart_spherical_top_level_5[];
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
    out[34] = t5;
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
    out[35] = t44;
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
    const double t51 = params[0]*2.0; /* m*2 */
    const double t52 = t2*t2; /* R*R*R*R */
    const double t53 = t51*t52; /* m*2*R*R*R*R */
    const double t54 = t34*t53; /* I1*I1*m*2*R*R*R*R */
    const double t55 = params[4]*t54; /* I3*I1*I1*m*2*R*R*R*R */
    const double t56 = t9*t55; /* (I1 - I3)*I3*I1*I1*m*2*R*R*R*R */
    out[36] = t56;
    const double t57 = 2.0/params[0]; /* 2/m */
    out[37] = t57;
    const double t58 = params[6]*t14; /* G*I1*R*R*2 */
    const double t59 = t9*t58; /* (I1 - I3)*G*I1*R*R*2 */
    out[38] = t59;
    const double t60 = t34*t51; /* I1*I1*m*2 */
    out[39] = t60;
    const double t61 = params[1]*t51; /* R*m*2 */
    const double t62 = t34*t61; /* I1*I1*R*m*2 */
    out[40] = t62;
    const double t63 = t9*t35; /* (I1 - I3)*R*R*2*I1*I1 */
    out[41] = t63;
    const double t64 = params[3]*t34; /* I1*I1*I1 */
    const double t65 = t53*t64; /* m*2*R*R*R*R*I1*I1*I1 */
    const double t66 = t9*t65; /* (I1 - I3)*m*2*R*R*R*R*I1*I1*I1 */
    out[42] = t66;
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
    const double t11 = x[0]*t10; /* gamma3*1/K */
    const double t12 = x[4]*p[7]; /* s*R*G */
    const double t13 = JLT_FMA(t3, x[0], t12); /* v_tau*R*I3*gamma3 + s*R*G */
    const double t14 = t10*t13; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t15 = t11*t14; /* gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t16 = p[14]*t15; /* 2*R^2*I3*gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t17 = JLT_FMS(t3, t10, t16); /* v_tau*R*I3*1/K - 2*R^2*I3*gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t18 = x[3]*t17; /* v_tau*t17 */
    out[5] = t18;
    const double t19 = JLT_FMA(t3, t11, t14); /* v_tau*R*I3*gamma3*1/K + 1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    out[8] = t19;
    const double t20 = t10*t14; /* 1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t21 = x[4]*t20; /* s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t22 = p[15]*t21; /* 2*R^2*I1*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t23 = JLT_FMS(t10, p[7], t22); /* 1/K*R*G - 2*R^2*I1*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t24 = x[3]*t23; /* v_tau*(1/K*R*G - 2*R^2*I1*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)) */
    out[9] = t24;
    const double t25 = t11*p[16]; /* gamma3*1/K*4*R^2*I3 */
    const double t26 = JLT_FMS(t15, t25, t20); /* gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K*4*R^2*I3 - 1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t27 = x[4]*x[3]; /* s*v_tau */
    const double t28 = JLT_FNMA(x[0], p[12], t27); /* s*v_tau - gamma3*G/I1 */
    const double t29 = x[4]*p[8]; /* s*R*I3 */
    const double t30 = t28*t29; /* (s*v_tau - gamma3*G/I1)*s*R*I3 */
    const double t31 = t10*t30; /* 1/K*(s*v_tau - gamma3*G/I1)*s*R*I3 */
    const double t32 = t10*t31; /* 1/K*1/K*(s*v_tau - gamma3*G/I1)*s*R*I3 */
    const double t33 = JLT_FMA(2.0, t15, t32); /* 2*gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) + 1/K*1/K*(s*v_tau - gamma3*G/I1)*s*R*I3 */
    const double t34 = t28*p[17]; /* (s*v_tau - gamma3*G/I1)*4*R^3*I3^2 */
    const double t35 = t11*t34; /* gamma3*1/K*(s*v_tau - gamma3*G/I1)*4*R^3*I3^2 */
    const double t36 = t21*t35; /* s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K*(s*v_tau - gamma3*G/I1)*4*R^3*I3^2 */
    const double t37 = JLT_FMA(t21, p[18], t36); /* s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*R*I3*G/I1 + t36 */
    const double t38 = JLT_FMA(t13, t26, t37); /* (v_tau*R*I3*gamma3 + s*R*G)*t26 + s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*R*I3*G/I1 + t36 */
    const double t39 = JLT_FNMA(t3, t33, t38); /* t38 - v_tau*R*I3*t33 */
    out[10] = t39;
    const double t40 = x[4]*t21; /* s*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t41 = JLT_FMA(x[0], t33, t40); /* gamma3*t33 + s*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t42 = p[19]*t41; /* (-R*I3)*(gamma3*t33 + s*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)) */
    out[13] = t42;
    const double t43 = t27 + t28; /* s*v_tau + s*v_tau - gamma3*G/I1 */
    const double t44 = p[8]*t43; /* R*I3*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t45 = t20*t44; /* 1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*R*I3*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t46 = JLT_FMA(t11, t13, t31); /* gamma3*1/K*(v_tau*R*I3*gamma3 + s*R*G) + 1/K*(s*v_tau - gamma3*G/I1)*s*R*I3 */
    const double t47 = p[20]*t46; /* 4*R^2*I1*t46 */
    const double t48 = JLT_FMS(t21, t47, t45); /* s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*4*R^2*I1*t46 - t45 */
    const double t49 = JLT_FNMA(p[7], t33, t48); /* s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*4*R^2*I1*t46 - t45 - R*G*t33 */
    out[14] = t49;
    const double t50 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t51 = t6*t9; /* 1/(Theta/m) = K*1/(K*Theta/m) */
    const double t52 = p[11]*t50; /* I1*I3/m*V */
    const double t53 = JLT_FNMA(t51, t52, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t54 = t10*t53; /* 1/K*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t55 = t1*t28; /* s*omega_tau*(s*v_tau - gamma3*G/I1) */
    const double t56 = x[0]*p[22]; /* gamma3*R^2*(I1 - I3) */
    const double t57 = t55*t56; /* s*omega_tau*(s*v_tau - gamma3*G/I1)*gamma3*R^2*(I1 - I3) */
    const double t58 = JLT_FNMA(t13, t50, t57); /* s*omega_tau*(s*v_tau - gamma3*G/I1)*gamma3*R^2*(I1 - I3) - (v_tau*R*I3*gamma3 + s*R*G)*V */
    const double t59 = t10 + t51; /* 1/K + 1/(Theta/m) */
    const double t60 = t58*t59; /* t58*(1/K + 1/(Theta/m)) */
    const double t61 = t11*t51; /* gamma3*1/K*1/(Theta/m) */
    const double t62 = p[21]*t60; /* 2*R^2*I1*I3^2/m*t58*(1/K + 1/(Theta/m)) */
    const double t63 = t55*p[13]; /* s*omega_tau*(s*v_tau - gamma3*G/I1)*R^2*I1*I3*(I1 - I3)/m */
    const double t64 = t9*t63; /* 1/(K*Theta/m)*s*omega_tau*(s*v_tau - gamma3*G/I1)*R^2*I1*I3*(I1 - I3)/m */
    const double t65 = t1*p[23]; /* s*omega_tau*R^2*I3*G*(I1 - I3)/m */
    const double t66 = JLT_FMS(t61, t65, t64); /* gamma3*1/K*1/(Theta/m)*s*omega_tau*R^2*I3*G*(I1 - I3)/m - t64 */
    const double t67 = JLT_FNMA(t3, t54, t66); /* t66 - v_tau*R*I3*1/K*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t68 = JLT_FMA(t16, x[1], t67); /* 2*R^2*I3*gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*v_nu + t66 - v_tau*R*I3*1/K*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t69 = JLT_FMA(t61, t62, t68); /* gamma3*1/K*1/(Theta/m)*2*R^2*I1*I3^2/m*t58*(1/K + 1/(Theta/m)) + t68 */
    out[15] = t69;
    const double t70 = t13*t51; /* (v_tau*R*I3*gamma3 + s*R*G)*1/(Theta/m) */
    const double t71 = -t70; /* -(v_tau*R*I3*gamma3 + s*R*G)*1/(Theta/m) */
    out[16] = t71;
    const double t72 = t51*p[24]; /* 1/(Theta/m)*R*I1*I3/m */
    const double t73 = t14*t72; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*1/(Theta/m)*R*I1*I3/m */
    const double t74 = t61*p[13]; /* gamma3*1/K*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    const double t75 = x[4]*t74; /* s*gamma3*1/K*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    const double t76 = JLT_FNMA(t28, t75, t73); /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*1/(Theta/m)*R*I1*I3/m - (s*v_tau - gamma3*G/I1)*s*gamma3*1/K*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    out[17] = t76;
    const double t77 = p[8]*t11; /* R*I3*gamma3*1/K */
    const double t78 = t53*t77; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t79 = JLT_FMA(t1, t75, t78); /* s*omega_tau*s*gamma3*1/K*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m + (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t80 = -t79; /* -t79 */
    out[18] = t80;
    const double t81 = p[7]*t54; /* R*G*1/K*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t82 = x[2]*t43; /* omega_tau*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t83 = x[4]*p[25]; /* s*2*R^2*I1^2*I3/m */
    const double t84 = t9*t83; /* 1/(K*Theta/m)*s*2*R^2*I1^2*I3/m */
    const double t85 = JLT_FMS(t60, t84, t81); /* t58*(1/K + 1/(Theta/m))*1/(K*Theta/m)*s*2*R^2*I1^2*I3/m - R*G*1/K*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t86 = JLT_FNMA(t74, t82, t85); /* t85 - gamma3*1/K*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*omega_tau*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t87 = JLT_FMA(t22, x[1], t86); /* 2*R^2*I1*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*v_nu + t86 */
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
    const double t14 = x[4]*t13; /* s*s*omega_tau */
    out[0] = t14;
    const double t15 = 2.0*t13; /* 2*s*omega_tau */
    out[9] = t15;
    const double t16 = -t13; /* -s*omega_tau */
    out[25] = t16;
    const double t17 = x[0]*t13; /* gamma3*s*omega_tau */
    const double t18 = -t17; /* -gamma3*s*omega_tau */
    out[4] = t18;
    const double t19 = JLT_FNMA(x[0], p[12], t12); /* s*v_tau - gamma3*G/I1 */
    const double t20 = t12 + t19; /* s*v_tau + s*v_tau - gamma3*G/I1 */
    const double t21 = t7*t20; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t22 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t23 = x[4]*t7; /* s*1/K */
    const double t24 = p[11]*t22; /* I1*I3/m*V */
    const double t25 = t11*t22; /* (gamma3*v_tau*R*I3 + s*R*G)*V */
    const double t26 = JLT_FNMA(t8, t24, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t27 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t28 = -t27; /* -omega_tau*gamma3 */
    out[29] = t28;
    const double t29 = p[22]*t19; /* R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t30 = JLT_FNMA(t17, t29, t25); /* (gamma3*v_tau*R*I3 + s*R*G)*V - gamma3*s*omega_tau*R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t31 = t19*t23; /* (s*v_tau - gamma3*G/I1)*s*1/K */
    const double t32 = t8*t30; /* 1/(Theta/m)*t30 */
    const double t33 = t7*t11; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t34 = t8*t11; /* 1/(Theta/m)*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t35 = -t34; /* -1/(Theta/m)*(gamma3*v_tau*R*I3 + s*R*G) */
    out[21] = t35;
    const double t36 = x[3]*t33; /* v_tau*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[1] = t36;
    const double t37 = t7*t10; /* 1/K*v_tau*R*I3 */
    const double t38 = p[23]*t27; /* R^2*I3*G*(I1 - I3)/m*omega_tau*gamma3 */
    const double t39 = t8*t38; /* 1/(Theta/m)*R^2*I3*G*(I1 - I3)/m*omega_tau*gamma3 */
    const double t40 = x[0]*t33; /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t41 = p[8]*t31; /* R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t42 = x[0]*t7; /* gamma3*1/K */
    const double t43 = JLT_FMA(t10, t42, t33); /* v_tau*R*I3*gamma3*1/K + 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[13] = t43;
    const double t44 = p[7]*t7; /* R*G*1/K */
    const double t45 = t7 + t8; /* 1/K + 1/(Theta/m) */
    const double t46 = t32*t45; /* 1/(Theta/m)*t30*(1/K + 1/(Theta/m)) */
    const double t47 = t23*t33; /* s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t48 = t26*t37; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*v_tau*R*I3 */
    const double t49 = JLT_FMS(t23, t39, t48); /* s*1/K*1/(Theta/m)*R^2*I3*G*(I1 - I3)/m*omega_tau*gamma3 - (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*v_tau*R*I3 */
    const double t50 = p[13]*t8; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t51 = t31*t50; /* (s*v_tau - gamma3*G/I1)*s*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t52 = p[24]*t8; /* R*I1*I3/m*1/(Theta/m) */
    const double t53 = t17*t50; /* gamma3*s*omega_tau*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t54 = t27*t50; /* omega_tau*gamma3*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t55 = t33*t52; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I1*I3/m*1/(Theta/m) */
    const double t56 = JLT_FNMA(x[0], t51, t55); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I1*I3/m*1/(Theta/m) - gamma3*t51 */
    out[22] = t56;
    const double t57 = p[14]*t33; /* 2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t58 = t42*t57; /* gamma3*1/K*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t59 = p[15]*t47; /* 2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t60 = JLT_FMA(2.0, t40, t41); /* 2*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t61 = t40 + t41; /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t62 = p[8]*t21; /* R*I3*1/K*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t63 = t33*t62; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I3*1/K*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t64 = p[21]*t42; /* 2*R^2*I1*I3^2/m*gamma3*1/K */
    const double t65 = JLT_FNMA(t46, t64, t49); /* t49 - 1/(Theta/m)*t30*(1/K + 1/(Theta/m))*2*R^2*I1*I3^2/m*gamma3*1/K */
    const double t66 = JLT_FMA(x[1], t58, t65); /* v_nu*gamma3*1/K*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + t65 */
    const double t67 = JLT_FNMA(x[2], t51, t66); /* t66 - omega_tau*t51 */
    out[20] = t67;
    const double t68 = t37 - t58; /* 1/K*v_tau*R*I3 - gamma3*1/K*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t69 = x[3]*t68; /* v_tau*t68 */
    out[10] = t69;
    const double t70 = t37*t60; /* 1/K*v_tau*R*I3*t60 */
    const double t71 = JLT_FMS(p[18], t47, t70); /* R*I3*G/I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) - 1/K*v_tau*R*I3*t60 */
    const double t72 = p[8]*t42; /* R*I3*gamma3*1/K */
    const double t73 = t26*t72; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t74 = JLT_FMA(t23, t53, t73); /* s*1/K*gamma3*s*omega_tau*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) + (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t75 = -t74; /* -t74 */
    out[23] = t75;
    const double t76 = p[25]*t23; /* 2*R^2*I1^2*I3/m*s*1/K */
    const double t77 = t26*t44; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t78 = t26*t33; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t79 = JLT_FMA(t27, t51, t78); /* omega_tau*gamma3*t51 + t78 */
    const double t80 = -t79; /* -(omega_tau*gamma3*t51 + t78) */
    out[3] = t80;
    const double t81 = JLT_FMS(x[1], t59, t77); /* v_nu*2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) - (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t82 = JLT_FNMA(t21, t54, t81); /* t81 - 1/K*(s*v_tau + s*v_tau - gamma3*G/I1)*omega_tau*gamma3*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t83 = JLT_FNMA(t46, t76, t82); /* t82 - 1/(Theta/m)*t30*(1/K + 1/(Theta/m))*2*R^2*I1^2*I3/m*s*1/K */
    out[24] = t83;
    const double t84 = t44 - t59; /* R*G*1/K - 2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t85 = x[3]*t84; /* v_tau*(R*G*1/K - 2*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G)) */
    out[14] = t85;
    const double t86 = p[16]*t42; /* 4*R^2*I3*gamma3*1/K */
    const double t87 = JLT_FMS(t61, t86, t33); /* t61*4*R^2*I3*gamma3*1/K - 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t88 = JLT_FMA(t33, t87, t71); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*(t61*4*R^2*I3*gamma3*1/K - 1/K*(gamma3*v_tau*R*I3 + s*R*G)) + t71 */
    out[15] = t88;
    const double t89 = t33*t61; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*t61 */
    const double t90 = -t89; /* -1/K*(gamma3*v_tau*R*I3 + s*R*G)*t61 */
    out[2] = t90;
    const double t91 = x[4]*t47; /* s*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t92 = JLT_FMA(t42, t60, t91); /* gamma3*1/K*t60 + s*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t93 = p[19]*t92; /* (-R*I3)*(gamma3*1/K*t60 + s*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G)) */
    out[18] = t93;
    const double t94 = p[20]*t47; /* 4*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t95 = JLT_FMS(t61, t94, t63); /* t61*4*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) - t63 */
    const double t96 = JLT_FNMA(t44, t60, t95); /* t61*4*R^2*I1*s*1/K*1/K*(gamma3*v_tau*R*I3 + s*R*G) - t63 - R*G*1/K*t60 */
    out[19] = t96;
    const double t97 = x[4]*x[0]; /* s*gamma3 */
    const double t98 = -t97; /* -s*gamma3 */
    out[27] = t98;
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
    const double t13 = t12 - x[2]; /* t11/(K*Theta/m) - omega_tau */
    const double t14 = x[0]*t13; /* gamma3*(t11/(K*Theta/m) - omega_tau) */
    out[0] = t14;
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
    const double t5 = p[0]*x[3]; /* m*v_tau */
    const double t6 = x[3]*t5; /* v_tau*m*v_tau */
    const double t7 = JLT_FMA(t3, p[0], p[34]); /* Theta = K*m + I1*I3 */
    const double t8 = t4*t7; /* 1/K*Theta */
    const double t9 = x[3]*t8; /* v_tau*1/K*Theta */
    out[3] = t9;
    const double t10 = JLT_FNMA(t4, p[35], t6); /* v_tau*m*v_tau - 1/K*G^2 */
    const double t11 = JLT_FNMA(x[3], t9, t10); /* v_tau*m*v_tau - 1/K*G^2 - v_tau*v_tau*1/K*Theta */
    const double t12 = t4*t11; /* 1/K*(v_tau*m*v_tau - 1/K*G^2 - v_tau*v_tau*1/K*Theta) */
    const double t13 = t2*t12; /* gamma3*R^2*I3*1/K*(v_tau*m*v_tau - 1/K*G^2 - v_tau*v_tau*1/K*Theta) */
    out[0] = t13;
    const double t14 = p[0]*x[1]; /* m*v_nu */
    out[1] = t14;
    const double t15 = p[3]*x[2]; /* I1*omega_tau */
    out[2] = t15;
    const double t16 = t0*t12; /* s*R^2*I1*1/K*(v_tau*m*v_tau - 1/K*G^2 - v_tau*v_tau*1/K*Theta) */
    out[4] = t16;
    const double t17 = x[4]*x[3]; /* s*v_tau */
    const double t18 = JLT_FNMA(x[0], p[12], t17); /* s*v_tau - gamma3*G/I1 */
    const double t19 = t4*t18; /* 1/K*(s*v_tau - gamma3*G/I1) */
    const double t20 = t8*t19; /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) */
    const double t21 = JLT_FNMA(p[37], t20, t19); /* 1/K*(s*v_tau - gamma3*G/I1) - 2/m*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) */
    const double t22 = t19*t21; /* 1/K*(s*v_tau - gamma3*G/I1)*t21 */
    const double t23 = x[0]*p[36]; /* gamma3*2*m*R^4*I1^2*I3*(I1 - I3) */
    const double t24 = t22*t23; /* 1/K*(s*v_tau - gamma3*G/I1)*t21*gamma3*2*m*R^4*I1^2*I3*(I1 - I3) */
    const double t25 = JLT_FNMA(t20, p[38], t24); /* t24 - 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1*G*(I1 - I3) */
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
    const double t32 = x[4]*p[42]; /* s*2*m*R^4*I1^3*(I1 - I3) */
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
    double t7[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t6[k] = x4[k]*p[9];
        t7[k] = jlt_jet_product(x4, t6, k);
        t10[k] = p[10]*x0[k];
        t11[k] = jlt_jet_product(x0, t10, k) + t7[k];
        t13[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t11, t13, k);
        t15[k] = x4[k]*p[7];
        t17[k] = x3[k]*p[8];
        t18[k] = jlt_jet_product(x0, t17, k) + t15[k];
        t19[k] = jlt_jet_product(t13, t18, k);
        t20[k] = jlt_jet_product(x3, t19, k);
        t21[k] = jlt_jet_product(x4, x3, k);
        t23[k] = t21[k] - x0[k]*p[12];
        t24[k] = jlt_jet_product(t13, t23, k);
        t25[k] = x4[k]*p[8];
        t26[k] = jlt_jet_product(t24, t25, k);
        t27[k] = jlt_jet_product(x0, t19, k) + t26[k];
        t28[k] = jlt_jet_product(t19, t27, k);
        t29[k] = -t28[k];
        t32[k] = t11[k] + (k == 0 ? p[11] : 0);
        t33[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t32, t33, k);
        t35[k] = x2[k]*p[1] + x1[k];
        t36[k] = p[11]*t35[k];
        t37[k] = x1[k] - jlt_jet_product(t33, t36, k);
        t38[k] = jlt_jet_product(t19, t37, k);
        t40[k] = jlt_jet_product(t2, x0, k);
        t41[k] = p[13]*t40[k];
        t42[k] = jlt_jet_product(t33, t41, k);
        t43[k] = jlt_jet_product(t24, t42, k) + t38[k];
        t44[k] = -t43[k];
        t45[k] = -t40[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t20[k]/(k + 1);
        next[2] = x2[k + 1] = t29[k]/(k + 1);
        next[3] = x3[k + 1] = t44[k]/(k + 1);
        next[4] = x4[k + 1] = t45[k]/(k + 1);
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
    .sha256 = "5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .scales = 1,
    .state_count = 5, .param_count = 7, .prepared_count = 43,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 22, 7, 1, 0, 0, 12, 7 }, { 16, 71, 0, 6, 0, 0, 10, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1), a part of d(omega_tau)/dtau, V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(v_tau)/dtau" },
    .jacobian = { jacobian, 25, { 8, 57, 27, 1, 0, 0, 14, 19 }, { 91, 507, 0, 46, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in v_tau*(R*I3)*gamma3 + s*(R*G), a part of d(d(v_nu)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(v_tau), 1/K*(R*G) - (2*R^2*I1)*s*1/K*1/K*(v_tau*(R*I3)*gamma3 + s*(R*G)), a part of d(d(omega_tau)/dtau)/d(gamma3), s*v_tau - gamma3*(G/I1), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), s*v_tau + s*v_tau - gamma3*(G/I1), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(omega_tau), a part of d(d(v_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 14, 60, 24, 1, 0, 0, 14, 21 }, { 104, 567, 0, 52, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1), s*v_tau + s*v_tau - gamma3*(G/I1), V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(omega_tau), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(gamma3), a part of d(d(v_nu)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(v_tau), a part of d(v_tau)/dtau, d(d(v_tau)/dtau)/d(s), (R*G)*1/K - (2*R^2*I1)*s*1/K*1/K*(gamma3*v_tau*(R*I3) + s*(R*G)), a part of d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(omega_tau)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 2, 8, 4, 1, 0, 0, 9, 5 }, { 8, 30, 0, 3, 0, 0, 10, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in V = R*omega_tau + v_nu, (I1*I3/m)*V - s*s*omega_tau*(R*I1*(I1 - I3)/m) - v_nu*Theta/m, a part of the divergence" },
    .integral_values = { integral_values, 2, { 1, 12, 7, 1, 0, 0, 7, 5 }, { 9, 35, 0, 3, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in omega_tau*R + v_nu, s*v_tau - gamma3*(G/I1), F0" },
    .integral_gradients = { integral_gradients, 10, { 0, 24, 9, 1, 0, 0, 10, 7 }, { 26, 155, 0, 14, 0, 0, 13, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in v_tau*m*v_tau - ((1)/K)*(G^2) - v_tau*v_tau*((1)/K)*Theta, s*v_tau - gamma3*(G/I1), a part of d(F0)/d(gamma3) and of d(F0)/d(s), d(F0)/d(gamma3), omega_tau*R + v_nu, d(F0)/d(s)" },
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
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_level_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_level_balanced_in_regular) },
#endif
};
