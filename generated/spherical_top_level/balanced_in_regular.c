/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23    8    1    0    0     12    7   (93)
 *  jacobian            6   60   31    1    0    0     14   22   (644)
 *  rhs_jacobian        11   62   30    1    0    0     15   29   (723)
 *  divergence          1   11    6    1    0    0     12    7   (41)
 *  integral_values     0   15    8    1    0    0      7    7   (47)
 *  integral_gradients  0   29    9    1    0    0     10    7   (195)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_balanced_in_regular;
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
    const double t1 = params[1]*params[4]; /* R*I3 */
    const double t2 = params[1]*params[1]; /* R*R */
    const double t3 = t2*params[3]; /* R*R*I1 */
    const double t4 = params[4]*t2; /* I3*R*R */
    const double t5 = params[4]*params[3]; /* I3*I1 */
    const double t6 = params[4]/params[3]; /* I3/I1 */
    const double t7 = params[1]*params[3]; /* R*I1 */
    const double t8 = params[3] - params[4]; /* I1 - I3 */
    const double t9 = t1*t8; /* R*I3*(I1 - I3) */
    const double t10 = t2*2.0; /* R*R*2 */
    const double t11 = params[4]*t10; /* I3*R*R*2 */
    const double t12 = params[3]*t10; /* I1*R*R*2 */
    const double t13 = t2*4.0; /* R*R*4 */
    const double t14 = params[4]*t13; /* I3*R*R*4 */
    const double t15 = params[4]*params[4]; /* I3*I3 */
    const double t16 = t13*t15; /* R*R*4*I3*I3 */
    const double t17 = t16/params[3]; /* R*R*4*I3*I3/I1 */
    const double t18 = params[6]*t1; /* G*R*I3 */
    const double t19 = t18/params[3]; /* G*R*I3/I1 */
    const double t20 = params[1]*(-2.0); /* R*(-2) */
    const double t21 = params[4]*t20; /* I3*R*(-2) */
    const double t22 = params[1]*t15; /* R*I3*I3 */
    const double t23 = t22/params[3]; /* R*I3*I3/I1 */
    const double t24 = -t23; /* -R*I3*I3/I1 */
    const double t25 = -t1; /* -R*I3 */
    const double t26 = params[3]*t13; /* I1*R*R*4 */
    const double t27 = params[3]*params[3]; /* I1*I1 */
    const double t28 = t13*t27; /* R*R*4*I1*I1 */
    const double t29 = params[4]/t28; /* I3/(R*R*4*I1*I1) */
    const double t30 = t2*t15; /* R*R*I3*I3 */
    const double t31 = params[1]*2.0; /* R*2 */
    const double t32 = t8*t31; /* (I1 - I3)*R*2 */
    const double t33 = params[3]*2.0; /* I1*2 */
    const double t34 = params[6]*t4; /* G*I3*R*R */
    const double t35 = t8*t34; /* (I1 - I3)*G*I3*R*R */
    const double t36 = params[4]*t7; /* I3*R*I1 */
    const double t37 = params[4]*t3; /* I3*R*R*I1 */
    const double t38 = t8*t37; /* (I1 - I3)*I3*R*R*I1 */
    const double t39 = t7*t8; /* R*I1*(I1 - I3) */
    const double t40 = params[0]/2.0; /* m/2 */
    const double t41 = params[6]*params[6]; /* G*G */
    const double t42 = params[3]/2.0; /* I1/2 */
    const double t43 = t27*params[0]; /* I1*I1*m */
    const double t44 = 1.0/params[0]; /* 1/m */
    const double t45 = t2*params[0]; /* R*R*m */
    const double t46 = params[3]*t45; /* I1*R*R*m */
    const double t47 = t4*t8; /* I3*R*R*(I1 - I3) */
    const double t48 = 2.0*params[0]; /* 2*m */
    const double t49 = params[6]*t31; /* G*R*2 */
    const double t50 = t8*t49; /* (I1 - I3)*G*R*2 */
    const double t51 = t27*t48; /* I1*I1*2*m */
    const double t52 = params[1]*t48; /* R*2*m */
    const double t53 = t27*t52; /* I1*I1*R*2*m */
    const double t54 = params[3]*t31; /* I1*R*2 */
    const double t55 = t8*t54; /* (I1 - I3)*I1*R*2 */
    const double t56 = t3*t8; /* R*R*I1*(I1 - I3) */
    out[7] = t0;
    out[8] = t1;
    out[9] = t3;
    out[10] = t4;
    out[11] = t5;
    out[12] = t6;
    out[13] = t7;
    out[14] = t9;
    out[15] = t11;
    out[16] = t12;
    out[17] = t14;
    out[18] = t17;
    out[19] = t19;
    out[20] = t21;
    out[21] = t24;
    out[22] = t25;
    out[23] = t26;
    out[24] = t29;
    out[25] = t30;
    out[26] = t32;
    out[27] = t33;
    out[28] = t35;
    out[29] = t36;
    out[30] = t38;
    out[31] = t37;
    out[32] = t39;
    out[33] = t40;
    out[34] = t41;
    out[35] = t42;
    out[36] = t43;
    out[37] = t8;
    out[38] = t44;
    out[39] = t46;
    out[40] = t47;
    out[41] = t48;
    out[42] = t50;
    out[43] = t51;
    out[44] = t53;
    out[45] = t55;
    out[46] = t56;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[4]*p[7]; /* s*R*G */
    const double t3 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t5 = x[4]*p[9]; /* s*R^2*I1 */
    const double t6 = x[4]*t5; /* s*s*R^2*I1 */
    const double t7 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t8 = JLT_FMA(x[0], t7, t6); /* K = gamma3*gamma3*R^2*I3 + s*s*R^2*I1 */
    const double t9 = JLT_FMA(p[0], t8, p[11]); /* Theta = m*K + I1*I3 */
    const double t10 = t8*t9; /* K*Theta */
    const double t11 = 1.0/t10; /* 1/(K*Theta) */
    const double t12 = t9*t11; /* Theta*1/(K*Theta) */
    const double t13 = t4*t12; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta) */
    const double t14 = x[3]*t13; /* v_tau*(gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta) */
    const double t15 = x[4]*p[13]; /* s*R*I1 */
    const double t16 = x[3]*t15; /* v_tau*s*R*I1 */
    const double t17 = JLT_FNMA(p[7], x[0], t16); /* v_tau*s*R*I1 - R*G*gamma3 */
    const double t18 = t12*t17; /* Theta*1/(K*Theta)*(v_tau*s*R*I1 - R*G*gamma3) */
    const double t19 = x[4]*p[12]; /* s*I3/I1 */
    const double t20 = t18*t19; /* Theta*1/(K*Theta)*(v_tau*s*R*I1 - R*G*gamma3)*s*I3/I1 */
    const double t21 = JLT_FMA(x[0], t13, t20); /* gamma3*(gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta) + Theta*1/(K*Theta)*(v_tau*s*R*I1 - R*G*gamma3)*s*I3/I1 */
    const double t22 = t13*t21; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*t21 */
    const double t23 = -t22; /* -(gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*t21 */
    const double t24 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t25 = t8*t11; /* K*1/(K*Theta) */
    const double t26 = p[11]*t24; /* I1*I3*V */
    const double t27 = JLT_FNMA(t25, t26, x[1]); /* v_nu - K*1/(K*Theta)*I1*I3*V */
    const double t28 = t13*t27; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*(v_nu - K*1/(K*Theta)*I1*I3*V) */
    const double t29 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t30 = p[14]*t29; /* R*I3*(I1 - I3)*s*omega_tau*gamma3 */
    const double t31 = t25*t30; /* K*1/(K*Theta)*R*I3*(I1 - I3)*s*omega_tau*gamma3 */
    const double t32 = JLT_FMA(t18, t31, t28); /* Theta*1/(K*Theta)*(v_tau*s*R*I1 - R*G*gamma3)*K*1/(K*Theta)*R*I3*(I1 - I3)*s*omega_tau*gamma3 + t28 */
    const double t33 = -t32; /* -t32 */
    const double t34 = -t29; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t14;
    out[2] = t23;
    out[3] = t33;
    out[4] = t34;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t4 = t0*p[9]; /* s*s*R^2*I1 */
    const double t5 = p[10]*x[0]; /* R^2*I3*gamma3 */
    const double t6 = JLT_FMA(x[0], t5, t4); /* K = gamma3*R^2*I3*gamma3 + s*s*R^2*I1 */
    const double t7 = JLT_FMA(p[0], t6, p[11]); /* Theta = m*K + I1*I3 */
    const double t8 = t6*t7; /* K*Theta */
    const double t9 = 1.0/t8; /* 1/(K*Theta) */
    const double t10 = t7*t9; /* Theta*1/(K*Theta) */
    const double t11 = t3*t10; /* v_tau*R*I3*Theta*1/(K*Theta) */
    const double t12 = x[4]*p[7]; /* s*R*G */
    const double t13 = JLT_FMA(t3, x[0], t12); /* v_tau*R*I3*gamma3 + s*R*G */
    const double t14 = t10*t13; /* Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t15 = x[0]*t10; /* gamma3*Theta*1/(K*Theta) */
    const double t16 = t14*t15; /* Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*Theta*1/(K*Theta) */
    const double t17 = p[15]*t16; /* 2*R^2*I3*t16 */
    const double t18 = t11 - t17; /* v_tau*R*I3*Theta*1/(K*Theta) - 2*R^2*I3*t16 */
    const double t19 = x[3]*t18; /* v_tau*(v_tau*R*I3*Theta*1/(K*Theta) - 2*R^2*I3*t16) */
    const double t20 = JLT_FMA(t3, t15, t14); /* v_tau*R*I3*gamma3*Theta*1/(K*Theta) + Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t21 = t10*p[7]; /* Theta*1/(K*Theta)*R*G */
    const double t22 = x[4]*t10; /* s*Theta*1/(K*Theta) */
    const double t23 = t14*t22; /* Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G)*s*Theta*1/(K*Theta) */
    const double t24 = p[16]*t23; /* 2*R^2*I1*t23 */
    const double t25 = t21 - t24; /* Theta*1/(K*Theta)*R*G - 2*R^2*I1*t23 */
    const double t26 = x[3]*t25; /* v_tau*(Theta*1/(K*Theta)*R*G - 2*R^2*I1*t23) */
    const double t27 = x[0]*t16; /* gamma3*t16 */
    const double t28 = JLT_FMS(p[17], t27, t14); /* 4*R^2*I3*gamma3*t16 - Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t29 = x[4]*p[13]; /* s*R*I1 */
    const double t30 = x[3]*t29; /* v_tau*s*R*I1 */
    const double t31 = JLT_FNMA(x[0], p[7], t30); /* v_tau*s*R*I1 - gamma3*R*G */
    const double t32 = t22*t31; /* s*Theta*1/(K*Theta)*(v_tau*s*R*I1 - gamma3*R*G) */
    const double t33 = t10*p[12]; /* Theta*1/(K*Theta)*I3/I1 */
    const double t34 = t32*t33; /* s*Theta*1/(K*Theta)*(v_tau*s*R*I1 - gamma3*R*G)*Theta*1/(K*Theta)*I3/I1 */
    const double t35 = JLT_FMA(2.0, t16, t34); /* 2*t16 + t34 */
    const double t36 = t16*p[18]; /* t16*4*R^2*I3^2/I1 */
    const double t37 = t32*t36; /* s*Theta*1/(K*Theta)*(v_tau*s*R*I1 - gamma3*R*G)*t16*4*R^2*I3^2/I1 */
    const double t38 = JLT_FMA(t23, p[19], t37); /* t23*R*I3*G/I1 + t37 */
    const double t39 = JLT_FNMA(t3, t35, t38); /* t23*R*I3*G/I1 + t37 - v_tau*R*I3*(2*t16 + t34) */
    const double t40 = JLT_FMA(t14, t28, t39); /* Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G)*t28 + t23*R*I3*G/I1 + t37 - v_tau*R*I3*(2*t16 + t34) */
    const double t41 = t15*p[21]; /* gamma3*Theta*1/(K*Theta)*(-R*I3^2/I1) */
    const double t42 = t32*t41; /* s*Theta*1/(K*Theta)*(v_tau*s*R*I1 - gamma3*R*G)*gamma3*Theta*1/(K*Theta)*(-R*I3^2/I1) */
    const double t43 = x[4]*p[22]; /* s*(-R*I3) */
    const double t44 = JLT_FMA(t23, t43, t42); /* t23*s*(-R*I3) + t42 */
    const double t45 = JLT_FMA(t27, p[20], t44); /* gamma3*t16*(-2*R*I3) + t23*s*(-R*I3) + t42 */
    const double t46 = x[4]*t16; /* s*t16 */
    const double t47 = t31*p[24]; /* (v_tau*s*R*I1 - gamma3*R*G)*1/4*I3/(R^2*I1^2) */
    const double t48 = JLT_FNMA(t10, t47, t46); /* s*t16 - Theta*1/(K*Theta)*(v_tau*s*R*I1 - gamma3*R*G)*1/4*I3/(R^2*I1^2) */
    const double t49 = t14*p[23]; /* Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G)*4*R^2*I1 */
    const double t50 = t48*t49; /* t48*Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G)*4*R^2*I1 */
    const double t51 = JLT_FMS(p[17], t32, t3); /* 4*R^2*I3*s*Theta*1/(K*Theta)*(v_tau*s*R*I1 - gamma3*R*G) - v_tau*R*I3 */
    const double t52 = JLT_FNMA(p[7], t35, t50); /* t48*Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G)*4*R^2*I1 - R*G*(2*t16 + t34) */
    const double t53 = JLT_FMA(t23, t51, t52); /* t23*t51 + t52 */
    const double t54 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t55 = t6*t9; /* K*1/(K*Theta) */
    const double t56 = p[11]*t54; /* I1*I3*V */
    const double t57 = JLT_FNMA(t55, t56, x[1]); /* v_nu - K*1/(K*Theta)*I1*I3*V */
    const double t58 = t11*t57; /* v_tau*R*I3*Theta*1/(K*Theta)*(v_nu - K*1/(K*Theta)*I1*I3*V) */
    const double t59 = t15*t55; /* gamma3*Theta*1/(K*Theta)*K*1/(K*Theta) */
    const double t60 = x[0]*p[26]; /* gamma3*2*R*(I1 - I3) */
    const double t61 = t1*t60; /* s*omega_tau*gamma3*2*R*(I1 - I3) */
    const double t62 = t31*t61; /* (v_tau*s*R*I1 - gamma3*R*G)*s*omega_tau*gamma3*2*R*(I1 - I3) */
    const double t63 = t54*p[27]; /* V*2*I1 */
    const double t64 = JLT_FNMA(t13, t63, t62); /* (v_tau*s*R*I1 - gamma3*R*G)*s*omega_tau*gamma3*2*R*(I1 - I3) - (v_tau*R*I3*gamma3 + s*R*G)*V*2*I1 */
    const double t65 = JLT_FMA(p[0], t55, t10); /* m*K*1/(K*Theta) + Theta*1/(K*Theta) */
    const double t66 = t64*t65; /* t64*(m*K*1/(K*Theta) + Theta*1/(K*Theta)) */
    const double t67 = p[25]*t59; /* R^2*I3^2*gamma3*Theta*1/(K*Theta)*K*1/(K*Theta) */
    const double t68 = x[2]*p[14]; /* omega_tau*R*I3*(I1 - I3) */
    const double t69 = t55*t68; /* K*1/(K*Theta)*omega_tau*R*I3*(I1 - I3) */
    const double t70 = t1*t59; /* s*omega_tau*gamma3*Theta*1/(K*Theta)*K*1/(K*Theta) */
    const double t71 = JLT_FMS(t17, x[1], t58); /* 2*R^2*I3*t16*v_nu - v_tau*R*I3*Theta*1/(K*Theta)*(v_nu - K*1/(K*Theta)*I1*I3*V) */
    const double t72 = JLT_FNMA(t32, t69, t71); /* t71 - s*Theta*1/(K*Theta)*(v_tau*s*R*I1 - gamma3*R*G)*K*1/(K*Theta)*omega_tau*R*I3*(I1 - I3) */
    const double t73 = JLT_FMA(t66, t67, t72); /* t64*(m*K*1/(K*Theta) + Theta*1/(K*Theta))*R^2*I3^2*gamma3*Theta*1/(K*Theta)*K*1/(K*Theta) + t72 */
    const double t74 = JLT_FMA(p[28], t70, t73); /* R^2*I3*G*(I1 - I3)*s*omega_tau*gamma3*Theta*1/(K*Theta)*K*1/(K*Theta) + t73 */
    const double t75 = t14*t55; /* Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G)*K*1/(K*Theta) */
    const double t76 = JLT_FMS(p[11], t75, t14); /* I1*I3*Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G)*K*1/(K*Theta) - Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t77 = t75*p[29]; /* Theta*1/(K*Theta)*(v_tau*R*I3*gamma3 + s*R*G)*K*1/(K*Theta)*R*I1*I3 */
    const double t78 = t31*t59; /* (v_tau*s*R*I1 - gamma3*R*G)*gamma3*Theta*1/(K*Theta)*K*1/(K*Theta) */
    const double t79 = x[4]*p[14]; /* s*R*I3*(I1 - I3) */
    const double t80 = JLT_FNMA(t78, t79, t77); /* t77 - t78*s*R*I3*(I1 - I3) */
    const double t81 = p[8]*t15; /* R*I3*gamma3*Theta*1/(K*Theta) */
    const double t82 = t57*t81; /* (v_nu - K*1/(K*Theta)*I1*I3*V)*R*I3*gamma3*Theta*1/(K*Theta) */
    const double t83 = t70*p[30]; /* s*omega_tau*gamma3*Theta*1/(K*Theta)*K*1/(K*Theta)*R^2*I1*I3*(I1 - I3) */
    const double t84 = JLT_FMA(x[4], t83, t82); /* s*t83 + (v_nu - K*1/(K*Theta)*I1*I3*V)*R*I3*gamma3*Theta*1/(K*Theta) */
    const double t85 = -t84; /* -t84 */
    const double t86 = t21*t57; /* Theta*1/(K*Theta)*R*G*(v_nu - K*1/(K*Theta)*I1*I3*V) */
    const double t87 = t55*p[31]; /* K*1/(K*Theta)*R^2*I1*I3 */
    const double t88 = t22*t87; /* s*Theta*1/(K*Theta)*K*1/(K*Theta)*R^2*I1*I3 */
    const double t89 = JLT_FMS(t24, x[1], t86); /* 2*R^2*I1*t23*v_nu - Theta*1/(K*Theta)*R*G*(v_nu - K*1/(K*Theta)*I1*I3*V) */
    const double t90 = JLT_FNMA(t68, t78, t89); /* t89 - omega_tau*R*I3*(I1 - I3)*t78 */
    const double t91 = JLT_FMA(t66, t88, t90); /* t64*(m*K*1/(K*Theta) + Theta*1/(K*Theta))*s*Theta*1/(K*Theta)*K*1/(K*Theta)*R^2*I1*I3 + t89 - omega_tau*R*I3*(I1 - I3)*t78 */
    const double t92 = JLT_FNMA(x[3], t83, t91); /* t91 - v_tau*t83 */
    const double t93 = -t1; /* -s*omega_tau */
    const double t94 = x[4]*x[0]; /* s*gamma3 */
    const double t95 = -t94; /* -s*gamma3 */
    const double t96 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t97 = -t96; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t19;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t20;
    out[9] = t26;
    out[10] = t40;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t45;
    out[14] = t53;
    out[15] = t74;
    out[16] = t76;
    out[17] = t80;
    out[18] = t85;
    out[19] = t92;
    out[20] = t93;
    out[21] = 0.0;
    out[22] = t95;
    out[23] = 0.0;
    out[24] = t97;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[4]*p[7]; /* s*R*G */
    const double t3 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t5 = t0*p[9]; /* s*s*R^2*I1 */
    const double t6 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t7 = JLT_FMA(x[0], t6, t5); /* K = gamma3*gamma3*R^2*I3 + s*s*R^2*I1 */
    const double t8 = JLT_FMA(p[0], t7, p[11]); /* Theta = m*K + I1*I3 */
    const double t9 = t7*t8; /* K*Theta */
    const double t10 = 1.0/t9; /* 1/(K*Theta) */
    const double t11 = t8*t10; /* Theta*1/(K*Theta) */
    const double t12 = t4*t11; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta) */
    const double t13 = x[3]*t12; /* v_tau*(gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta) */
    const double t14 = x[0]*t12; /* gamma3*(gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta) */
    const double t15 = x[4]*t11; /* s*Theta*1/(K*Theta) */
    const double t16 = x[4]*p[13]; /* s*R*I1 */
    const double t17 = x[3]*t16; /* v_tau*s*R*I1 */
    const double t18 = JLT_FNMA(p[7], x[0], t17); /* v_tau*s*R*I1 - R*G*gamma3 */
    const double t19 = p[12]*t18; /* I3/I1*(v_tau*s*R*I1 - R*G*gamma3) */
    const double t20 = t15*t19; /* s*Theta*1/(K*Theta)*I3/I1*(v_tau*s*R*I1 - R*G*gamma3) */
    const double t21 = t14 + t20; /* gamma3*(gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta) + s*Theta*1/(K*Theta)*I3/I1*(v_tau*s*R*I1 - R*G*gamma3) */
    const double t22 = t12*t21; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*t21 */
    const double t23 = -t22; /* -(gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*t21 */
    const double t24 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t25 = t7*t10; /* K*1/(K*Theta) */
    const double t26 = p[11]*t25; /* I1*I3*K*1/(K*Theta) */
    const double t27 = JLT_FNMA(t24, t26, x[1]); /* v_nu - V*I1*I3*K*1/(K*Theta) */
    const double t28 = t12*t27; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*(v_nu - V*I1*I3*K*1/(K*Theta)) */
    const double t29 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t30 = t15*t25; /* s*Theta*1/(K*Theta)*K*1/(K*Theta) */
    const double t31 = t29*t30; /* omega_tau*gamma3*s*Theta*1/(K*Theta)*K*1/(K*Theta) */
    const double t32 = t18*p[14]; /* (v_tau*s*R*I1 - R*G*gamma3)*R*I3*(I1 - I3) */
    const double t33 = JLT_FMA(t31, t32, t28); /* omega_tau*gamma3*s*Theta*1/(K*Theta)*K*1/(K*Theta)*(v_tau*s*R*I1 - R*G*gamma3)*R*I3*(I1 - I3) + t28 */
    const double t34 = -t33; /* -t33 */
    const double t35 = x[4]*t29; /* s*omega_tau*gamma3 */
    const double t36 = -t35; /* -s*omega_tau*gamma3 */
    const double t37 = x[2]*x[4]; /* omega_tau*s */
    const double t38 = 2.0*t37; /* 2*omega_tau*s */
    const double t39 = t3*t11; /* v_tau*R*I3*Theta*1/(K*Theta) */
    const double t40 = x[0]*t11; /* gamma3*Theta*1/(K*Theta) */
    const double t41 = t12*t40; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*gamma3*Theta*1/(K*Theta) */
    const double t42 = p[15]*t41; /* 2*R^2*I3*t41 */
    const double t43 = t39 - t42; /* v_tau*R*I3*Theta*1/(K*Theta) - 2*R^2*I3*t41 */
    const double t44 = x[3]*t43; /* v_tau*(v_tau*R*I3*Theta*1/(K*Theta) - 2*R^2*I3*t41) */
    const double t45 = JLT_FMA(t3, t40, t12); /* v_tau*R*I3*gamma3*Theta*1/(K*Theta) + (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta) */
    const double t46 = p[7]*t11; /* R*G*Theta*1/(K*Theta) */
    const double t47 = t12*t15; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*s*Theta*1/(K*Theta) */
    const double t48 = p[16]*t47; /* 2*R^2*I1*t47 */
    const double t49 = t46 - t48; /* R*G*Theta*1/(K*Theta) - 2*R^2*I1*t47 */
    const double t50 = x[3]*t49; /* v_tau*(R*G*Theta*1/(K*Theta) - 2*R^2*I1*t47) */
    const double t51 = t12*t12; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*(gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta) */
    const double t52 = JLT_FMA(t14, 2.0, t20); /* gamma3*(gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*2 + s*Theta*1/(K*Theta)*I3/I1*(v_tau*s*R*I1 - R*G*gamma3) */
    const double t53 = t14*p[17]; /* gamma3*(gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*4*R^2*I3 */
    const double t54 = t18*p[18]; /* (v_tau*s*R*I1 - R*G*gamma3)*4*R^2*I3^2/I1 */
    const double t55 = t40*t54; /* gamma3*Theta*1/(K*Theta)*(v_tau*s*R*I1 - R*G*gamma3)*4*R^2*I3^2/I1 */
    const double t56 = JLT_FMS(t47, t55, t51); /* t47*t55 - t51 */
    const double t57 = JLT_FMA(t47, p[19], t56); /* t47*R*I3*G/I1 + t47*t55 - t51 */
    const double t58 = JLT_FMA(t41, t53, t57); /* t41*t53 + t47*R*I3*G/I1 + t47*t55 - t51 */
    const double t59 = JLT_FNMA(t39, t52, t58); /* t41*t53 + t47*R*I3*G/I1 + t47*t55 - t51 - v_tau*R*I3*Theta*1/(K*Theta)*t52 */
    const double t60 = p[8]*t40; /* R*I3*gamma3*Theta*1/(K*Theta) */
    const double t61 = t52*t60; /* t52*R*I3*gamma3*Theta*1/(K*Theta) */
    const double t62 = x[4]*p[8]; /* s*R*I3 */
    const double t63 = JLT_FMA(t47, t62, t61); /* t47*s*R*I3 + t52*R*I3*gamma3*Theta*1/(K*Theta) */
    const double t64 = -t63; /* -(t47*s*R*I3 + t52*R*I3*gamma3*Theta*1/(K*Theta)) */
    const double t65 = t11*t19; /* Theta*1/(K*Theta)*I3/I1*(v_tau*s*R*I1 - R*G*gamma3) */
    const double t66 = t12*t65; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*Theta*1/(K*Theta)*I3/I1*(v_tau*s*R*I1 - R*G*gamma3) */
    const double t67 = t47*p[23]; /* t47*4*R^2*I1 */
    const double t68 = JLT_FMS(t21, t67, t66); /* t21*t47*4*R^2*I1 - t66 */
    const double t69 = JLT_FNMA(t3, t47, t68); /* t21*t47*4*R^2*I1 - t66 - v_tau*R*I3*t47 */
    const double t70 = JLT_FNMA(t46, t52, t69); /* t21*t47*4*R^2*I1 - t66 - v_tau*R*I3*t47 - R*G*Theta*1/(K*Theta)*t52 */
    const double t71 = x[1]*t42; /* v_nu*2*R^2*I3*t41 */
    const double t72 = t35*p[26]; /* s*omega_tau*gamma3*2*R*(I1 - I3) */
    const double t73 = t18*t72; /* (v_tau*s*R*I1 - R*G*gamma3)*s*omega_tau*gamma3*2*R*(I1 - I3) */
    const double t74 = t24*p[27]; /* V*2*I1 */
    const double t75 = JLT_FNMA(t4, t74, t73); /* (v_tau*s*R*I1 - R*G*gamma3)*s*omega_tau*gamma3*2*R*(I1 - I3) - (gamma3*v_tau*R*I3 + s*R*G)*V*2*I1 */
    const double t76 = JLT_FMA(p[0], t25, t11); /* m*K*1/(K*Theta) + Theta*1/(K*Theta) */
    const double t77 = t75*t76; /* t75*(m*K*1/(K*Theta) + Theta*1/(K*Theta)) */
    const double t78 = t25*t40; /* K*1/(K*Theta)*gamma3*Theta*1/(K*Theta) */
    const double t79 = p[25]*t78; /* R^2*I3^2*K*1/(K*Theta)*gamma3*Theta*1/(K*Theta) */
    const double t80 = x[2]*t32; /* omega_tau*(v_tau*s*R*I1 - R*G*gamma3)*R*I3*(I1 - I3) */
    const double t81 = JLT_FNMA(t30, t80, t71); /* v_nu*2*R^2*I3*t41 - s*Theta*1/(K*Theta)*K*1/(K*Theta)*omega_tau*(v_tau*s*R*I1 - R*G*gamma3)*R*I3*(I1 - I3) */
    const double t82 = JLT_FNMA(t27, t39, t81); /* t81 - (v_nu - V*I1*I3*K*1/(K*Theta))*v_tau*R*I3*Theta*1/(K*Theta) */
    const double t83 = JLT_FMA(t77, t79, t82); /* t75*(m*K*1/(K*Theta) + Theta*1/(K*Theta))*R^2*I3^2*K*1/(K*Theta)*gamma3*Theta*1/(K*Theta) + t82 */
    const double t84 = JLT_FMA(t31, p[28], t83); /* omega_tau*gamma3*s*Theta*1/(K*Theta)*K*1/(K*Theta)*R^2*I3*G*(I1 - I3) + t83 */
    const double t85 = JLT_FMS(t12, t26, t12); /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*I1*I3*K*1/(K*Theta) - (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta) */
    const double t86 = t25*p[29]; /* K*1/(K*Theta)*R*I1*I3 */
    const double t87 = t12*t86; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta*1/(K*Theta)*K*1/(K*Theta)*R*I1*I3 */
    const double t88 = x[0]*t32; /* gamma3*(v_tau*s*R*I1 - R*G*gamma3)*R*I3*(I1 - I3) */
    const double t89 = JLT_FNMA(t30, t88, t87); /* t87 - s*Theta*1/(K*Theta)*K*1/(K*Theta)*gamma3*(v_tau*s*R*I1 - R*G*gamma3)*R*I3*(I1 - I3) */
    const double t90 = t27*t60; /* (v_nu - V*I1*I3*K*1/(K*Theta))*R*I3*gamma3*Theta*1/(K*Theta) */
    const double t91 = t31*p[30]; /* omega_tau*gamma3*s*Theta*1/(K*Theta)*K*1/(K*Theta)*R^2*I1*I3*(I1 - I3) */
    const double t92 = JLT_FMA(x[4], t91, t90); /* s*t91 + (v_nu - V*I1*I3*K*1/(K*Theta))*R*I3*gamma3*Theta*1/(K*Theta) */
    const double t93 = -t92; /* -t92 */
    const double t94 = t78*t80; /* K*1/(K*Theta)*gamma3*Theta*1/(K*Theta)*omega_tau*(v_tau*s*R*I1 - R*G*gamma3)*R*I3*(I1 - I3) */
    const double t95 = t30*p[31]; /* s*Theta*1/(K*Theta)*K*1/(K*Theta)*R^2*I1*I3 */
    const double t96 = JLT_FMS(x[1], t48, t94); /* v_nu*2*R^2*I1*t47 - t94 */
    const double t97 = JLT_FNMA(t27, t46, t96); /* v_nu*2*R^2*I1*t47 - t94 - (v_nu - V*I1*I3*K*1/(K*Theta))*R*G*Theta*1/(K*Theta) */
    const double t98 = JLT_FMA(t77, t95, t97); /* t75*(m*K*1/(K*Theta) + Theta*1/(K*Theta))*s*Theta*1/(K*Theta)*K*1/(K*Theta)*R^2*I1*I3 + t97 */
    const double t99 = JLT_FNMA(x[3], t91, t98); /* t98 - v_tau*t91 */
    const double t100 = -t37; /* -omega_tau*s */
    const double t101 = x[4]*x[0]; /* s*gamma3 */
    const double t102 = -t101; /* -s*gamma3 */
    const double t103 = -t29; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t13;
    out[2] = t23;
    out[3] = t34;
    out[4] = t36;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t38;
    out[10] = t44;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t45;
    out[14] = t50;
    out[15] = t59;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t64;
    out[19] = t70;
    out[20] = t84;
    out[21] = t85;
    out[22] = t89;
    out[23] = t93;
    out[24] = t99;
    out[25] = t100;
    out[26] = 0.0;
    out[27] = t102;
    out[28] = 0.0;
    out[29] = t103;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s*s */
    const double t4 = JLT_FMA(p[0], t3, p[11]); /* Theta = m*K + I1*I3 */
    const double t5 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t6 = t3*t4; /* K*Theta */
    const double t7 = 1.0/t6; /* 1/(K*Theta) */
    const double t8 = t3*t7; /* K*1/(K*Theta) */
    const double t9 = p[11]*t5; /* I1*I3*V */
    const double t10 = x[2]*p[32]; /* omega_tau*R*I1*(I1 - I3) */
    const double t11 = t0*t10; /* s*s*omega_tau*R*I1*(I1 - I3) */
    const double t12 = JLT_FMS(t8, t9, x[1]); /* K*1/(K*Theta)*I1*I3*V - v_nu */
    const double t13 = JLT_FNMA(t8, t11, t12); /* K*1/(K*Theta)*I1*I3*V - v_nu - K*1/(K*Theta)*s*s*omega_tau*R*I1*(I1 - I3) */
    const double t14 = p[8]*t4; /* R*I3*Theta */
    const double t15 = t7*t14; /* 1/(K*Theta)*R*I3*Theta */
    const double t16 = JLT_FNMA(t13, t15, x[2]); /* omega_tau - t13*1/(K*Theta)*R*I3*Theta */
    const double t17 = x[0]*t16; /* gamma3*(omega_tau - t13*1/(K*Theta)*R*I3*Theta) */
    const double t18 = -t17; /* -gamma3*(omega_tau - t13*1/(K*Theta)*R*I3*Theta) */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[33]*x[1]; /* 1/2*m*v_nu */
    const double t1 = x[1]*t0; /* v_nu*1/2*m*v_nu */
    const double t2 = p[9]*x[4]; /* R^2*I1*s */
    const double t3 = x[4]*t2; /* s*R^2*I1*s */
    const double t4 = p[10]*x[0]; /* R^2*I3*gamma3 */
    const double t5 = JLT_FMA(x[0], t4, t3); /* K = gamma3*R^2*I3*gamma3 + s*R^2*I1*s */
    const double t6 = 1.0/t5; /* 1/K */
    const double t7 = JLT_FMA(t5, p[0], p[11]); /* Theta = K*m + I1*I3 */
    const double t8 = x[3]*x[3]; /* v_tau*v_tau */
    const double t9 = JLT_FMA(t7, t8, p[34]); /* Theta*v_tau*v_tau + G^2 */
    const double t10 = (1.0 / 2.0)*t6; /* 1/2*1/K */
    const double t11 = p[35]*x[2]; /* 1/2*I1*omega_tau */
    const double t12 = JLT_FMA(x[2], t11, t1); /* omega_tau*1/2*I1*omega_tau + v_nu*1/2*m*v_nu */
    const double t13 = JLT_FMA(t9, t10, t12); /* (Theta*v_tau*v_tau + G^2)*1/2*1/K + omega_tau*1/2*I1*omega_tau + v_nu*1/2*m*v_nu */
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t15 = p[36]*t14; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t16 = t14*t15; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t17 = x[3]*p[13]; /* v_tau*R*I1 */
    const double t18 = x[4]*t17; /* s*v_tau*R*I1 */
    const double t19 = JLT_FNMA(x[0], p[7], t18); /* s*v_tau*R*I1 - gamma3*R*G */
    const double t20 = t6*t19; /* 1/K*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t21 = t7*p[37]; /* Theta*(I1 - I3) */
    const double t22 = t20*t21; /* 1/K*(s*v_tau*R*I1 - gamma3*R*G)*Theta*(I1 - I3) */
    const double t23 = JLT_FMA(t20, t22, t16); /* 1/K*(s*v_tau*R*I1 - gamma3*R*G)*1/K*(s*v_tau*R*I1 - gamma3*R*G)*Theta*(I1 - I3) + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[0] = t13;
    out[1] = t23;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[9]*x[4]; /* R^2*I1*s */
    const double t1 = x[4]*t0; /* s*R^2*I1*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + s*R^2*I1*s */
    const double t4 = 1.0/t3; /* 1/K */
    const double t5 = x[3]*x[3]; /* v_tau*v_tau */
    const double t6 = t4*t5; /* 1/K*v_tau*v_tau */
    const double t7 = JLT_FMA(p[0], t3, p[11]); /* Theta = m*K + I1*I3 */
    const double t8 = JLT_FMA(t5, t7, p[34]); /* v_tau*v_tau*Theta + G^2 */
    const double t9 = t4*t4; /* 1/K*1/K */
    const double t10 = p[38]*t8; /* 1/m*(v_tau*v_tau*Theta + G^2) */
    const double t11 = JLT_FNMA(t9, t10, t6); /* 1/K*v_tau*v_tau - 1/K*1/K*1/m*(v_tau*v_tau*Theta + G^2) */
    const double t12 = p[0]*t2; /* m*gamma3*R^2*I3 */
    const double t13 = t11*t12; /* (1/K*v_tau*v_tau - 1/K*1/K*1/m*(v_tau*v_tau*Theta + G^2))*m*gamma3*R^2*I3 */
    const double t14 = p[0]*x[1]; /* m*v_nu */
    const double t15 = p[3]*x[2]; /* I1*omega_tau */
    const double t16 = t4*t7; /* 1/K*Theta */
    const double t17 = x[3]*t16; /* v_tau*1/K*Theta */
    const double t18 = x[4]*p[39]; /* s*m*R^2*I1 */
    const double t19 = t11*t18; /* (1/K*v_tau*v_tau - 1/K*1/K*1/m*(v_tau*v_tau*Theta + G^2))*s*m*R^2*I1 */
    const double t20 = x[3]*p[13]; /* v_tau*R*I1 */
    const double t21 = x[4]*t20; /* s*v_tau*R*I1 */
    const double t22 = JLT_FNMA(x[0], p[7], t21); /* s*v_tau*R*I1 - gamma3*R*G */
    const double t23 = JLT_FNMA(t16, 4.0, p[41]); /* 2*m - 1/K*Theta*4 */
    const double t24 = t9*t22; /* 1/K*1/K*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t25 = t22*t24; /* (s*v_tau*R*I1 - gamma3*R*G)*1/K*1/K*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t26 = t23*t25; /* (2*m - 1/K*Theta*4)*t25 */
    const double t27 = x[0]*p[40]; /* gamma3*R^2*I3*(I1 - I3) */
    const double t28 = t26*t27; /* (2*m - 1/K*Theta*4)*t25*gamma3*R^2*I3*(I1 - I3) */
    const double t29 = t7*t24; /* Theta*1/K*1/K*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t30 = JLT_FNMA(p[42], t29, t28); /* (2*m - 1/K*Theta*4)*t25*gamma3*R^2*I3*(I1 - I3) - 2*R*G*(I1 - I3)*Theta*1/K*1/K*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t31 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t32 = p[43]*t31; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    const double t33 = t31*p[44]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    const double t34 = t29*p[45]; /* Theta*1/K*1/K*(s*v_tau*R*I1 - gamma3*R*G)*2*R*I1*(I1 - I3) */
    const double t35 = x[4]*t34; /* s*Theta*1/K*1/K*(s*v_tau*R*I1 - gamma3*R*G)*2*R*I1*(I1 - I3) */
    const double t36 = x[3]*t34; /* v_tau*Theta*1/K*1/K*(s*v_tau*R*I1 - gamma3*R*G)*2*R*I1*(I1 - I3) */
    const double t37 = x[4]*p[46]; /* s*R^2*I1*(I1 - I3) */
    const double t38 = JLT_FMA(t26, t37, t36); /* (2*m - 1/K*Theta*4)*t25*s*R^2*I1*(I1 - I3) + t36 */
    out[0] = t13;
    out[1] = t14;
    out[2] = t15;
    out[3] = t17;
    out[4] = t19;
    out[5] = t30;
    out[6] = t32;
    out[7] = t33;
    out[8] = t35;
    out[9] = t38;
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
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
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
        t13[k] = x4[k]*p[9];
        t14[k] = jlt_jet_product(x4, t13, k);
        t16[k] = x0[k]*p[10];
        t17[k] = jlt_jet_product(x0, t16, k) + t14[k];
        t19[k] = p[0]*t17[k] + (k == 0 ? p[11] : 0);
        t20[k] = jlt_jet_product(t17, t19, k);
        t22[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t20, t22, k);
        t23[k] = jlt_jet_product(t19, t22, k);
        t24[k] = jlt_jet_product(t10, t23, k);
        t25[k] = jlt_jet_product(x3, t24, k);
        t28[k] = x4[k]*p[13];
        t29[k] = jlt_jet_product(x3, t28, k);
        t30[k] = t29[k] - p[7]*x0[k];
        t31[k] = jlt_jet_product(t23, t30, k);
        t32[k] = x4[k]*p[12];
        t33[k] = jlt_jet_product(t31, t32, k);
        t34[k] = jlt_jet_product(x0, t24, k) + t33[k];
        t35[k] = jlt_jet_product(t24, t34, k);
        t36[k] = -t35[k];
        t39[k] = x2[k]*p[1] + x1[k];
        t40[k] = jlt_jet_product(t17, t22, k);
        t41[k] = p[11]*t39[k];
        t42[k] = x1[k] - jlt_jet_product(t40, t41, k);
        t43[k] = jlt_jet_product(t24, t42, k);
        t45[k] = jlt_jet_product(t2, x0, k);
        t46[k] = p[14]*t45[k];
        t47[k] = jlt_jet_product(t40, t46, k);
        t48[k] = jlt_jet_product(t31, t47, k) + t43[k];
        t49[k] = -t48[k];
        t50[k] = -t45[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t25[k]/(k + 1);
        next[2] = x2[k + 1] = t36[k]/(k + 1);
        next[3] = x3[k + 1] = t49[k]/(k + 1);
        next[4] = x4[k + 1] = t50[k]/(k + 1);
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
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
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
    .sha256 = "0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 47,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 23, 8, 1, 0, 0, 12, 7 }, { 16, 71, 0, 6, 0, 0, 10, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .jacobian = { jacobian, 25, { 6, 60, 31, 1, 0, 0, 14, 22 }, { 91, 507, 0, 46, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 11, 62, 30, 1, 0, 0, 15, 29 }, { 104, 567, 0, 52, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .divergence = { divergence, 1, { 1, 11, 6, 1, 0, 0, 12, 7 }, { 8, 30, 0, 3, 0, 0, 10, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .integral_values = { integral_values, 2, { 0, 15, 8, 1, 0, 0, 7, 7 }, { 9, 35, 0, 3, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are" },
    .integral_gradients = { integral_gradients, 10, { 0, 29, 9, 1, 0, 0, 10, 7 }, { 26, 155, 0, 14, 0, 0, 13, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_balanced_in_regular_baseline,
        &jlt_batch_spherical_top_level_balanced_in_regular_avx2,
        &jlt_batch_spherical_top_level_balanced_in_regular_avx512,
    },
};
