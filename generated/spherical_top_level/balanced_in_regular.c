/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 80e339b123f34cca2c47ba73c110613efbf19df47efbd8d3c9b581354234107c
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   22    7    1    0    0     12    7   (93)
 *  jacobian            7   56   29    1    0    0     15   20   (644)
 *  rhs_jacobian        13   61   26    1    0    0     13   23   (723)
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
 *      d(d(v_nu)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3), (R*G)*1/K - (2*R^2*I1)*1/K*(gamma3*v_tau*(R*I3) + s*(R*G))*s*1/K,
 *      a part of d(d(v_tau)/dtau)/d(v_tau), a part of d(v_tau)/dtau,
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s),
 *      d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(v_nu)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(gamma3),
 *      d(d(v_tau)/dtau)/d(omega_tau), d(d(v_tau)/dtau)/d(s)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_chart_spherical_top_level_turning[];
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
    out[14] = t5;
    const double t6 = t5/params[0]; /* I3*I1/m */
    out[11] = t6;
    const double t7 = params[6]/params[3]; /* G/I1 */
    out[12] = t7;
    const double t8 = params[4]*t3; /* I3*R*R*I1 */
    const double t9 = params[3] - params[4]; /* I1 - I3 */
    const double t10 = t8*t9; /* I3*R*R*I1*(I1 - I3) */
    out[22] = t10;
    const double t11 = t10/params[0]; /* I3*R*R*I1*(I1 - I3)/m */
    out[13] = t11;
    const double t12 = t2*2.0; /* R*R*2 */
    const double t13 = params[4]*t12; /* I3*R*R*2 */
    out[15] = t13;
    const double t14 = params[3]*t12; /* I1*R*R*2 */
    out[16] = t14;
    const double t15 = t2*4.0; /* R*R*4 */
    const double t16 = params[4]*t15; /* I3*R*R*4 */
    out[17] = t16;
    const double t17 = params[1]*t2; /* R*R*R */
    const double t18 = 4.0*t17; /* 4*R*R*R */
    const double t19 = params[4]*params[4]; /* I3*I3 */
    const double t20 = t18*t19; /* 4*R*R*R*I3*I3 */
    out[18] = t20;
    const double t21 = params[6]*t1; /* G*R*I3 */
    const double t22 = t21/params[3]; /* G*R*I3/I1 */
    out[19] = t22;
    const double t23 = -t1; /* -R*I3 */
    out[20] = t23;
    const double t24 = params[3]*t15; /* I1*R*R*4 */
    out[21] = t24;
    const double t25 = t14*t19; /* I1*R*R*2*I3*I3 */
    out[23] = t25;
    const double t26 = t2*t9; /* R*R*(I1 - I3) */
    out[24] = t26;
    const double t27 = params[6]*t4; /* G*I3*R*R */
    const double t28 = t9*t27; /* (I1 - I3)*G*I3*R*R */
    out[25] = t28;
    const double t29 = params[1]*params[3]; /* R*I1 */
    const double t30 = params[4]*t29; /* I3*R*I1 */
    out[26] = t30;
    const double t31 = params[3]*params[3]; /* I1*I1 */
    const double t32 = t12*t31; /* R*R*2*I1*I1 */
    const double t33 = params[4]*t32; /* I3*R*R*2*I1*I1 */
    out[27] = t33;
    const double t34 = t25/params[0]; /* I1*R*R*2*I3*I3/m */
    out[28] = t34;
    const double t35 = t28/params[0]; /* (I1 - I3)*G*I3*R*R/m */
    out[29] = t35;
    const double t36 = t30/params[0]; /* I3*R*I1/m */
    out[30] = t36;
    const double t37 = t33/params[0]; /* I3*R*R*2*I1*I1/m */
    out[31] = t37;
    const double t38 = t9*t29; /* (I1 - I3)*R*I1 */
    const double t39 = t38/params[0]; /* (I1 - I3)*R*I1/m */
    out[32] = t39;
    const double t40 = params[0]/2.0; /* m/2 */
    out[33] = t40;
    const double t41 = params[4]/params[3]; /* I3/I1 */
    out[34] = t41;
    const double t42 = t2*params[0]; /* R*R*m */
    const double t43 = params[3]*t42; /* I1*R*R*m */
    const double t44 = params[6]*params[6]; /* G*G */
    out[40] = t44;
    const double t45 = t44/t43; /* G*G/(I1*R*R*m) */
    out[35] = t45;
    const double t46 = params[4]/t42; /* I3/(R*R*m) */
    out[36] = t46;
    const double t47 = params[3]/2.0; /* I1/2 */
    out[37] = t47;
    const double t48 = params[0]*t31; /* m*I1*I1 */
    out[38] = t48;
    const double t49 = params[3]*params[0]; /* I1*m */
    const double t50 = t9*t49; /* (I1 - I3)*I1*m */
    out[39] = t50;
    const double t51 = params[0]*2.0; /* m*2 */
    const double t52 = t2*t2; /* R*R*R*R */
    const double t53 = t51*t52; /* m*2*R*R*R*R */
    const double t54 = t31*t53; /* I1*I1*m*2*R*R*R*R */
    const double t55 = params[4]*t54; /* I3*I1*I1*m*2*R*R*R*R */
    const double t56 = t9*t55; /* (I1 - I3)*I3*I1*I1*m*2*R*R*R*R */
    out[41] = t56;
    const double t57 = 2.0/params[0]; /* 2/m */
    out[42] = t57;
    const double t58 = params[6]*t14; /* G*I1*R*R*2 */
    const double t59 = t9*t58; /* (I1 - I3)*G*I1*R*R*2 */
    out[43] = t59;
    const double t60 = t31*t51; /* I1*I1*m*2 */
    out[44] = t60;
    const double t61 = params[1]*t51; /* R*m*2 */
    const double t62 = t31*t61; /* I1*I1*R*m*2 */
    out[45] = t62;
    const double t63 = t9*t32; /* (I1 - I3)*R*R*2*I1*I1 */
    out[46] = t63;
    const double t64 = params[3]*t31; /* I1*I1*I1 */
    const double t65 = t53*t64; /* m*2*R*R*R*R*I1*I1*I1 */
    const double t66 = t9*t65; /* (I1 - I3)*m*2*R*R*R*R*I1*I1*I1 */
    out[47] = t66;
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
    const double t7 = JLT_FMA(p[0], t6, p[14]); /* Theta = m*K + I1*I3 */
    const double t8 = t6*t7; /* K*Theta */
    const double t9 = 1.0/t8; /* 1/(K*Theta) */
    const double t10 = t7*t9; /* 1/K = Theta*1/(K*Theta) */
    const double t11 = x[4]*p[7]; /* s*R*G */
    const double t12 = JLT_FMA(t3, x[0], t11); /* v_tau*R*I3*gamma3 + s*R*G */
    const double t13 = t10*t12; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t14 = t10*t13; /* 1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t15 = x[0]*t14; /* gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t16 = p[15]*t15; /* 2*R^2*I3*gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t17 = JLT_FMS(t3, t10, t16); /* v_tau*R*I3*1/K - 2*R^2*I3*gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t18 = x[3]*t17; /* v_tau*t17 */
    out[5] = t18;
    const double t19 = x[0]*t10; /* gamma3*1/K */
    const double t20 = JLT_FMA(t3, t19, t13); /* v_tau*R*I3*gamma3*1/K + 1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    out[8] = t20;
    const double t21 = t10*p[7]; /* 1/K*R*G */
    const double t22 = x[4]*t14; /* s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t23 = p[16]*t22; /* 2*R^2*I1*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t24 = t21 - t23; /* 1/K*R*G - 2*R^2*I1*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t25 = x[3]*t24; /* v_tau*(1/K*R*G - 2*R^2*I1*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)) */
    out[9] = t25;
    const double t26 = t19*p[17]; /* gamma3*1/K*4*R^2*I3 */
    const double t27 = JLT_FMS(t15, t26, t14); /* gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K*4*R^2*I3 - 1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t28 = x[4]*x[3]; /* s*v_tau */
    const double t29 = JLT_FNMA(x[0], p[12], t28); /* s*v_tau - gamma3*G/I1 */
    const double t30 = p[8]*t29; /* R*I3*(s*v_tau - gamma3*G/I1) */
    const double t31 = x[4]*t30; /* s*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t32 = t10*t31; /* 1/K*s*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t33 = t10*t32; /* 1/K*1/K*s*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t34 = JLT_FMA(2.0, t15, t33); /* 2*gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) + 1/K*1/K*s*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t35 = t29*p[18]; /* (s*v_tau - gamma3*G/I1)*4*R^3*I3^2 */
    const double t36 = t19*t35; /* gamma3*1/K*(s*v_tau - gamma3*G/I1)*4*R^3*I3^2 */
    const double t37 = t22*t36; /* s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*1/K*(s*v_tau - gamma3*G/I1)*4*R^3*I3^2 */
    const double t38 = JLT_FMA(t22, p[19], t37); /* s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*R*I3*G/I1 + t37 */
    const double t39 = JLT_FMA(t12, t27, t38); /* (v_tau*R*I3*gamma3 + s*R*G)*t27 + s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*R*I3*G/I1 + t37 */
    const double t40 = JLT_FNMA(t3, t34, t39); /* t39 - v_tau*R*I3*t34 */
    out[10] = t40;
    const double t41 = x[4]*t22; /* s*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t42 = JLT_FMA(x[0], t34, t41); /* gamma3*t34 + s*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t43 = p[20]*t42; /* (-R*I3)*(gamma3*t34 + s*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)) */
    out[13] = t43;
    const double t44 = t14*t30; /* 1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t45 = JLT_FMA(x[0], t13, t32); /* gamma3*1/K*(v_tau*R*I3*gamma3 + s*R*G) + 1/K*s*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t46 = p[21]*t45; /* 4*R^2*I1*t45 */
    const double t47 = JLT_FMS(t22, t46, t44); /* s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*4*R^2*I1*t45 - t44 */
    const double t48 = JLT_FNMA(t3, t22, t47); /* s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*4*R^2*I1*t45 - t44 - v_tau*R*I3*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t49 = JLT_FNMA(p[7], t34, t48); /* t48 - R*G*t34 */
    out[14] = t49;
    const double t50 = t29*p[22]; /* (s*v_tau - gamma3*G/I1)*R^2*I1*I3*(I1 - I3) */
    const double t51 = t6*t9; /* 1/Theta = K*1/(K*Theta) */
    const double t52 = t1*t51; /* s*omega_tau*1/Theta */
    const double t53 = t50*t52; /* (s*v_tau - gamma3*G/I1)*R^2*I1*I3*(I1 - I3)*s*omega_tau*1/Theta */
    const double t54 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t55 = t51*t54; /* 1/Theta*V */
    const double t56 = JLT_FNMA(p[14], t55, x[1]); /* v_nu - I1*I3*1/Theta*V */
    const double t57 = JLT_FMA(t3, t56, t53); /* v_tau*R*I3*(v_nu - I1*I3*1/Theta*V) + t53 */
    const double t58 = t16*x[1]; /* 2*R^2*I3*gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*v_nu */
    const double t59 = t19*t52; /* gamma3*1/K*s*omega_tau*1/Theta */
    const double t60 = t29*p[24]; /* (s*v_tau - gamma3*G/I1)*R^2*(I1 - I3) */
    const double t61 = t59*t60; /* gamma3*1/K*s*omega_tau*1/Theta*(s*v_tau - gamma3*G/I1)*R^2*(I1 - I3) */
    const double t62 = JLT_FNMA(t13, t55, t61); /* t61 - 1/K*(v_tau*R*I3*gamma3 + s*R*G)*1/Theta*V */
    const double t63 = p[0]*t51; /* m*1/Theta */
    const double t64 = t10 + t63; /* 1/K + m*1/Theta */
    const double t65 = t62*t64; /* (t61 - 1/K*(v_tau*R*I3*gamma3 + s*R*G)*1/Theta*V)*(1/K + m*1/Theta) */
    const double t66 = x[0]*p[23]; /* gamma3*2*R^2*I1*I3^2 */
    const double t67 = JLT_FMA(t59, p[25], t58); /* gamma3*1/K*s*omega_tau*1/Theta*R^2*I3*G*(I1 - I3) + 2*R^2*I3*gamma3*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*v_nu */
    const double t68 = JLT_FNMA(t10, t57, t67); /* t67 - 1/K*(v_tau*R*I3*(v_nu - I1*I3*1/Theta*V) + t53) */
    const double t69 = JLT_FMA(t65, t66, t68); /* t65*gamma3*2*R^2*I1*I3^2 + t67 - 1/K*(v_tau*R*I3*(v_nu - I1*I3*1/Theta*V) + t53) */
    out[15] = t69;
    const double t70 = t12*t63; /* (v_tau*R*I3*gamma3 + s*R*G)*m*1/Theta */
    const double t71 = -t70; /* -(v_tau*R*I3*gamma3 + s*R*G)*m*1/Theta */
    out[16] = t71;
    const double t72 = t51*p[26]; /* 1/Theta*R*I1*I3 */
    const double t73 = t13*t72; /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*1/Theta*R*I1*I3 */
    const double t74 = t50*t51; /* (s*v_tau - gamma3*G/I1)*R^2*I1*I3*(I1 - I3)*1/Theta */
    const double t75 = t19*t74; /* gamma3*1/K*(s*v_tau - gamma3*G/I1)*R^2*I1*I3*(I1 - I3)*1/Theta */
    const double t76 = JLT_FNMA(x[4], t75, t73); /* 1/K*(v_tau*R*I3*gamma3 + s*R*G)*1/Theta*R*I1*I3 - s*t75 */
    out[17] = t76;
    const double t77 = p[8]*t19; /* R*I3*gamma3*1/K */
    const double t78 = t56*t77; /* (v_nu - I1*I3*1/Theta*V)*R*I3*gamma3*1/K */
    const double t79 = p[22]*t59; /* R^2*I1*I3*(I1 - I3)*gamma3*1/K*s*omega_tau*1/Theta */
    const double t80 = JLT_FMA(x[4], t79, t78); /* s*R^2*I1*I3*(I1 - I3)*gamma3*1/K*s*omega_tau*1/Theta + (v_nu - I1*I3*1/Theta*V)*R*I3*gamma3*1/K */
    const double t81 = -t80; /* -t80 */
    out[18] = t81;
    const double t82 = x[2]*t75; /* omega_tau*t75 */
    const double t83 = x[4]*p[27]; /* s*2*R^2*I1^2*I3 */
    const double t84 = JLT_FMS(t23, x[1], t82); /* 2*R^2*I1*s*1/K*1/K*(v_tau*R*I3*gamma3 + s*R*G)*v_nu - omega_tau*t75 */
    const double t85 = JLT_FNMA(t21, t56, t84); /* t84 - 1/K*R*G*(v_nu - I1*I3*1/Theta*V) */
    const double t86 = JLT_FNMA(x[3], t79, t85); /* t84 - 1/K*R*G*(v_nu - I1*I3*1/Theta*V) - v_tau*R^2*I1*I3*(I1 - I3)*gamma3*1/K*s*omega_tau*1/Theta */
    const double t87 = JLT_FMA(t65, t83, t86); /* t65*s*2*R^2*I1^2*I3 + t86 */
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
    const double t14 = JLT_FNMA(x[0], p[12], t13); /* s*v_tau - gamma3*G/I1 */
    const double t15 = t13 + t14; /* s*v_tau + s*v_tau - gamma3*G/I1 */
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = t8*t12; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t18 = x[3]*t17; /* v_tau*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[1] = t18;
    const double t19 = p[8]*t8; /* R*I3*1/K */
    const double t20 = p[11]*t16; /* I1*I3/m*V */
    const double t21 = JLT_FNMA(t9, t20, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t22 = t12*t16; /* (gamma3*v_tau*R*I3 + s*R*G)*V */
    const double t23 = t9*t12; /* 1/(Theta/m)*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t24 = -t23; /* -1/(Theta/m)*(gamma3*v_tau*R*I3 + s*R*G) */
    out[21] = t24;
    const double t25 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t26 = -t25; /* -omega_tau*gamma3 */
    out[29] = t26;
    const double t27 = x[0]*t8; /* gamma3*1/K */
    const double t28 = JLT_FMA(t11, t27, t17); /* v_tau*R*I3*gamma3*1/K + 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[13] = t28;
    const double t29 = x[4]*t8; /* s*1/K */
    const double t30 = t17*t29; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t31 = p[18]*t14; /* 4*R^3*I3^2*(s*v_tau - gamma3*G/I1) */
    const double t32 = t27*t31; /* gamma3*1/K*4*R^3*I3^2*(s*v_tau - gamma3*G/I1) */
    const double t33 = t30*t32; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K*gamma3*1/K*4*R^3*I3^2*(s*v_tau - gamma3*G/I1) */
    const double t34 = JLT_FMA(p[19], t30, t33); /* R*I3*G/I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K + t33 */
    const double t35 = x[4]*t14; /* s*(s*v_tau - gamma3*G/I1) */
    const double t36 = t19*t35; /* R*I3*1/K*s*(s*v_tau - gamma3*G/I1) */
    const double t37 = p[13]*t7; /* R^2*I1*I3*(I1 - I3)/m*1/(K*Theta/m) */
    const double t38 = x[4]*t25; /* s*omega_tau*gamma3 */
    const double t39 = -t38; /* -s*omega_tau*gamma3 */
    out[4] = t39;
    const double t40 = x[3]*t19; /* v_tau*R*I3*1/K */
    const double t41 = p[24]*t14; /* R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t42 = JLT_FNMA(t38, t41, t22); /* (gamma3*v_tau*R*I3 + s*R*G)*V - s*omega_tau*gamma3*R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t43 = t15*t25; /* (s*v_tau + s*v_tau - gamma3*G/I1)*omega_tau*gamma3 */
    const double t44 = t15*t17; /* (s*v_tau + s*v_tau - gamma3*G/I1)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t45 = t19*t44; /* R*I3*1/K*t44 */
    const double t46 = t37*t43; /* R^2*I1*I3*(I1 - I3)/m*1/(K*Theta/m)*(s*v_tau + s*v_tau - gamma3*G/I1)*omega_tau*gamma3 */
    const double t47 = x[4]*t37; /* s*R^2*I1*I3*(I1 - I3)/m*1/(K*Theta/m) */
    const double t48 = t14*t47; /* (s*v_tau - gamma3*G/I1)*s*R^2*I1*I3*(I1 - I3)/m*1/(K*Theta/m) */
    const double t49 = x[0]*t17; /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t50 = p[15]*t17; /* 2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t51 = p[16]*t30; /* 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t52 = JLT_FMS(x[1], t51, t46); /* v_nu*2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t46 */
    const double t53 = p[17]*t27; /* 4*R^2*I3*gamma3*1/K */
    const double t54 = JLT_FMS(t49, t53, t17); /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*4*R^2*I3*gamma3*1/K - 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t55 = JLT_FMA(t17, t54, t34); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*t54 + R*I3*G/I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K + t33 */
    const double t56 = t21*t40; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*v_tau*R*I3*1/K */
    const double t57 = t8 + t9; /* 1/K + 1/(Theta/m) */
    const double t58 = t42*t57; /* t42*(1/K + 1/(Theta/m)) */
    const double t59 = p[7]*t8; /* R*G*1/K */
    const double t60 = t59 - t51; /* R*G*1/K - 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t61 = x[3]*t60; /* v_tau*(R*G*1/K - 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[14] = t61;
    const double t62 = JLT_FNMA(t21, t59, t52); /* v_nu*2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t46 - (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t63 = p[29]*t38; /* R^2*I3*G*(I1 - I3)/m*s*omega_tau*gamma3 */
    const double t64 = JLT_FMS(t7, t63, t56); /* 1/(K*Theta/m)*R^2*I3*G*(I1 - I3)/m*s*omega_tau*gamma3 - (v_nu - 1/(Theta/m)*I1*I3/m*V)*v_tau*R*I3*1/K */
    const double t65 = JLT_FNMA(x[2], t48, t64); /* t64 - omega_tau*t48 */
    const double t66 = p[8]*t27; /* R*I3*gamma3*1/K */
    const double t67 = t21*t66; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t68 = JLT_FMA(t38, t47, t67); /* s*omega_tau*gamma3*s*R^2*I1*I3*(I1 - I3)/m*1/(K*Theta/m) + (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t69 = -t68; /* -t68 */
    out[23] = t69;
    const double t70 = t17*t21; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t71 = JLT_FMA(t25, t48, t70); /* omega_tau*gamma3*t48 + t70 */
    const double t72 = -t71; /* -(omega_tau*gamma3*t48 + t70) */
    out[3] = t72;
    const double t73 = t36 + t49; /* R*I3*1/K*s*(s*v_tau - gamma3*G/I1) + gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t74 = JLT_FMA(2.0, t49, t36); /* 2*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + R*I3*1/K*s*(s*v_tau - gamma3*G/I1) */
    const double t75 = JLT_FNMA(t40, t74, t55); /* t55 - v_tau*R*I3*1/K*t74 */
    out[15] = t75;
    const double t76 = JLT_FNMA(t27, t50, t40); /* v_tau*R*I3*1/K - gamma3*1/K*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t77 = x[3]*t76; /* v_tau*t76 */
    out[10] = t77;
    const double t78 = x[1]*t50; /* v_nu*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t79 = x[4]*t30; /* s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t80 = p[21]*t30; /* 4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t81 = JLT_FMS(t73, t80, t45); /* t73*4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - R*I3*1/K*t44 */
    const double t82 = JLT_FNMA(t59, t74, t81); /* t81 - R*G*1/K*t74 */
    out[19] = t82;
    const double t83 = JLT_FMA(t27, t74, t79); /* gamma3*1/K*t74 + s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t84 = p[20]*t83; /* (-R*I3)*(gamma3*1/K*t74 + s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[18] = t84;
    const double t85 = t17*t73; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*t73 */
    const double t86 = -t85; /* -1/K*(gamma3*v_tau*R*I3 + s*R*G)*t73 */
    out[2] = t86;
    const double t87 = p[28]*t9; /* 2*R^2*I1*I3^2/m*1/(Theta/m) */
    const double t88 = JLT_FNMA(t58, t87, t78); /* v_nu*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) - t42*(1/K + 1/(Theta/m))*2*R^2*I1*I3^2/m*1/(Theta/m) */
    const double t89 = JLT_FMA(t27, t88, t65); /* gamma3*1/K*t88 + t64 - omega_tau*t48 */
    out[20] = t89;
    const double t90 = p[30]*t9; /* R*I1*I3/m*1/(Theta/m) */
    const double t91 = t17*t90; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I1*I3/m*1/(Theta/m) */
    const double t92 = JLT_FNMA(x[0], t48, t91); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I1*I3/m*1/(Theta/m) - gamma3*t48 */
    out[22] = t92;
    const double t93 = x[4]*p[31]; /* s*2*R^2*I1^2*I3/m */
    const double t94 = t7*t93; /* 1/(K*Theta/m)*s*2*R^2*I1^2*I3/m */
    const double t95 = JLT_FNMA(t58, t94, t62); /* t62 - t42*(1/K + 1/(Theta/m))*1/(K*Theta/m)*s*2*R^2*I1^2*I3/m */
    out[24] = t95;
    const double t96 = x[2]*x[4]; /* omega_tau*s */
    const double t97 = 2.0*t96; /* 2*omega_tau*s */
    out[9] = t97;
    const double t98 = -t96; /* -omega_tau*s */
    out[25] = t98;
    const double t99 = x[4]*x[0]; /* s*gamma3 */
    const double t100 = -t99; /* -s*gamma3 */
    out[27] = t100;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s*s */
    const double t4 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t5 = p[11]*t4; /* I1*I3/m*V */
    const double t6 = x[2]*p[32]; /* omega_tau*R*I1*(I1 - I3)/m */
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
    const double t2 = p[34]*x[0]; /* I3/I1*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K/(R^2*I1) = gamma3*I3/I1*gamma3 + s*s */
    const double t4 = 1.0/t3; /* 1/(K/(R^2*I1)) */
    const double t5 = t3 + p[36]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[35]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = JLT_FMA(t4, t7, t0); /* 1/(K/(R^2*I1))*(Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1)) + v_nu*v_nu */
    const double t9 = p[33]*t8; /* 1/2*m*t8 */
    const double t10 = p[37]*x[2]; /* 1/2*I1*omega_tau */
    const double t11 = JLT_FMA(x[2], t10, t9); /* omega_tau*1/2*I1*omega_tau + 1/2*m*t8 */
    out[0] = t11;
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t13 = p[38]*t12; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t14 = t12*t13; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t15 = x[4]*x[3]; /* s*v_tau */
    const double t16 = JLT_FNMA(x[0], p[12], t15); /* s*v_tau - gamma3*G/I1 */
    const double t17 = t4*t16; /* 1/(K/(R^2*I1))*(s*v_tau - gamma3*G/I1) */
    const double t18 = t5*p[39]; /* Theta/(m*R^2*I1)*m*I1*(I1 - I3) */
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
    const double t7 = JLT_FMA(t3, p[0], p[14]); /* Theta = K*m + I1*I3 */
    const double t8 = t4*t7; /* 1/K*Theta */
    const double t9 = x[3]*t8; /* v_tau*1/K*Theta */
    out[3] = t9;
    const double t10 = JLT_FNMA(t4, p[40], t6); /* v_tau*m*v_tau - 1/K*G^2 */
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
    const double t21 = JLT_FNMA(p[42], t20, t19); /* 1/K*(s*v_tau - gamma3*G/I1) - 2/m*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) */
    const double t22 = t19*t21; /* 1/K*(s*v_tau - gamma3*G/I1)*t21 */
    const double t23 = x[0]*p[41]; /* gamma3*2*m*R^4*I1^2*I3*(I1 - I3) */
    const double t24 = t22*t23; /* 1/K*(s*v_tau - gamma3*G/I1)*t21*gamma3*2*m*R^4*I1^2*I3*(I1 - I3) */
    const double t25 = JLT_FNMA(t20, p[43], t24); /* t24 - 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1*G*(I1 - I3) */
    out[5] = t25;
    const double t26 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t27 = p[44]*t26; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[6] = t27;
    const double t28 = t26*p[45]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[7] = t28;
    const double t29 = t20*p[46]; /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t30 = x[4]*t29; /* s*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    out[8] = t30;
    const double t31 = x[3]*t29; /* v_tau*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t32 = x[4]*p[47]; /* s*2*m*R^4*I1^3*(I1 - I3) */
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
    .sha256 = "80e339b123f34cca2c47ba73c110613efbf19df47efbd8d3c9b581354234107c",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .scales = 1,
    .state_count = 5, .param_count = 7, .prepared_count = 48,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 22, 7, 1, 0, 0, 12, 7 }, { 16, 71, 0, 6, 0, 0, 10, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1), a part of d(omega_tau)/dtau, V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(v_tau)/dtau" },
    .jacobian = { jacobian, 25, { 7, 56, 29, 1, 0, 0, 15, 20 }, { 91, 507, 0, 46, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in v_tau*(R*I3)*gamma3 + s*(R*G), a part of d(d(v_nu)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(v_tau), 1/K*(R*G) - (2*R^2*I1)*s*1/K*1/K*(v_tau*(R*I3)*gamma3 + s*(R*G)), a part of d(d(omega_tau)/dtau)/d(gamma3), s*v_tau - gamma3*(G/I1), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), V = omega_tau*R + v_nu, v_nu - (I1*I3)*1/Theta*V, a part of d(d(v_tau)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(omega_tau), a part of d(d(v_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 13, 61, 26, 1, 0, 0, 13, 23 }, { 104, 567, 0, 52, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1), s*v_tau + s*v_tau - gamma3*(G/I1), V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, d(d(v_nu)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3), (R*G)*1/K - (2*R^2*I1)*1/K*(gamma3*v_tau*(R*I3) + s*(R*G))*s*1/K, a part of d(d(v_tau)/dtau)/d(v_tau), a part of d(v_tau)/dtau, a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(v_nu)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(omega_tau), d(d(v_tau)/dtau)/d(s)" },
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
