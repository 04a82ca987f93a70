/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   22    7    1    0    0     12    7   (93)
 *  jacobian            8   55   30    1    0    0     13   23   (644)
 *  rhs_jacobian        13   60   26    1    0    0     14   29   (723)
 *  divergence          3    8    4    1    0    0     10    5   (41)
 *  integral_values     1   12    7    1    0    0      7    5   (47)
 *  integral_gradients  0   25    9    1    0    0     11    5   (195)
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
    const double t6 = t5/params[0]; /* I3*I1/m */
    const double t7 = params[6]/params[3]; /* G/I1 */
    const double t8 = params[4]*t3; /* I3*R*R*I1 */
    const double t9 = params[3] - params[4]; /* I1 - I3 */
    const double t10 = t8*t9; /* I3*R*R*I1*(I1 - I3) */
    const double t11 = t10/params[0]; /* I3*R*R*I1*(I1 - I3)/m */
    const double t12 = t2*2.0; /* R*R*2 */
    const double t13 = params[4]*t12; /* I3*R*R*2 */
    const double t14 = params[3]*t12; /* I1*R*R*2 */
    const double t15 = t2*4.0; /* R*R*4 */
    const double t16 = params[4]*t15; /* I3*R*R*4 */
    const double t17 = params[1]*2.0; /* R*2 */
    const double t18 = params[4]*t17; /* I3*R*2 */
    const double t19 = params[6]*t1; /* G*R*I3 */
    const double t20 = t19/params[3]; /* G*R*I3/I1 */
    const double t21 = params[1]*(-2.0); /* R*(-2) */
    const double t22 = params[4]*t21; /* I3*R*(-2) */
    const double t23 = params[4]*params[4]; /* I3*I3 */
    const double t24 = t2*t23; /* R*R*I3*I3 */
    const double t25 = -t24; /* -R*R*I3*I3 */
    const double t26 = -t1; /* -R*I3 */
    const double t27 = params[3]*t15; /* I1*R*R*4 */
    const double t28 = params[3]*t17; /* I1*R*2 */
    const double t29 = params[6]/t28; /* G/(I1*R*2) */
    const double t30 = params[1]*t2; /* R*R*R */
    const double t31 = 4.0*t30; /* 4*R*R*R */
    const double t32 = params[3]*t31; /* I1*4*R*R*R */
    const double t33 = params[4]*t32; /* I3*I1*4*R*R*R */
    const double t34 = t14*t23; /* I1*R*R*2*I3*I3 */
    const double t35 = t34/params[0]; /* I1*R*R*2*I3*I3/m */
    const double t36 = t2*t9; /* R*R*(I1 - I3) */
    const double t37 = params[1]*params[3]; /* R*I1 */
    const double t38 = params[4]*t37; /* I3*R*I1 */
    const double t39 = t38/params[0]; /* I3*R*I1/m */
    const double t40 = params[3]*params[3]; /* I1*I1 */
    const double t41 = t12*t40; /* R*R*2*I1*I1 */
    const double t42 = params[4]*t41; /* I3*R*R*2*I1*I1 */
    const double t43 = t42/params[0]; /* I3*R*R*2*I1*I1/m */
    const double t44 = t23*t31; /* I3*I3*4*R*R*R */
    const double t45 = params[6]*t4; /* G*I3*R*R */
    const double t46 = t9*t45; /* (I1 - I3)*G*I3*R*R */
    const double t47 = t46/params[0]; /* (I1 - I3)*G*I3*R*R/m */
    const double t48 = t9*t37; /* (I1 - I3)*R*I1 */
    const double t49 = t48/params[0]; /* (I1 - I3)*R*I1/m */
    const double t50 = params[0]/2.0; /* m/2 */
    const double t51 = params[4]/params[3]; /* I3/I1 */
    const double t52 = t2*params[0]; /* R*R*m */
    const double t53 = params[3]*t52; /* I1*R*R*m */
    const double t54 = params[6]*params[6]; /* G*G */
    const double t55 = t54/t53; /* G*G/(I1*R*R*m) */
    const double t56 = params[4]/t52; /* I3/(R*R*m) */
    const double t57 = params[3]/2.0; /* I1/2 */
    const double t58 = params[0]*t40; /* m*I1*I1 */
    const double t59 = params[3]*params[0]; /* I1*m */
    const double t60 = t9*t59; /* (I1 - I3)*I1*m */
    const double t61 = params[4]*t52; /* I3*R*R*m */
    const double t62 = 1.0/params[0]; /* 1/m */
    const double t63 = t54/params[0]; /* G*G/m */
    const double t64 = params[0]*2.0; /* m*2 */
    const double t65 = t2*t2; /* R*R*R*R */
    const double t66 = t64*t65; /* m*2*R*R*R*R */
    const double t67 = t40*t66; /* I1*I1*m*2*R*R*R*R */
    const double t68 = params[4]*t67; /* I3*I1*I1*m*2*R*R*R*R */
    const double t69 = t9*t68; /* (I1 - I3)*I3*I1*I1*m*2*R*R*R*R */
    const double t70 = 2.0/params[0]; /* 2/m */
    const double t71 = params[6]*t14; /* G*I1*R*R*2 */
    const double t72 = t9*t71; /* (I1 - I3)*G*I1*R*R*2 */
    const double t73 = t40*t64; /* I1*I1*m*2 */
    const double t74 = params[1]*t64; /* R*m*2 */
    const double t75 = t40*t74; /* I1*I1*R*m*2 */
    const double t76 = t9*t41; /* (I1 - I3)*R*R*2*I1*I1 */
    const double t77 = params[3]*t40; /* I1*I1*I1 */
    const double t78 = t66*t77; /* m*2*R*R*R*R*I1*I1*I1 */
    const double t79 = t9*t78; /* (I1 - I3)*m*2*R*R*R*R*I1*I1*I1 */
    out[7] = t0;
    out[8] = t1;
    out[9] = t3;
    out[10] = t4;
    out[11] = t6;
    out[12] = t7;
    out[13] = t11;
    out[14] = t13;
    out[15] = t14;
    out[16] = t16;
    out[17] = t18;
    out[18] = t20;
    out[19] = t22;
    out[20] = t25;
    out[21] = t26;
    out[22] = t27;
    out[23] = t29;
    out[24] = t33;
    out[25] = t35;
    out[26] = t36;
    out[27] = t39;
    out[28] = t43;
    out[29] = t44;
    out[30] = t47;
    out[31] = t49;
    out[32] = t50;
    out[33] = t51;
    out[34] = t55;
    out[35] = t56;
    out[36] = t57;
    out[37] = t58;
    out[38] = t60;
    out[39] = t61;
    out[40] = t62;
    out[41] = t5;
    out[42] = t63;
    out[43] = t53;
    out[44] = t69;
    out[45] = t70;
    out[46] = t72;
    out[47] = t73;
    out[48] = t75;
    out[49] = t76;
    out[50] = t79;
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
    const double t9 = t8 + p[11]; /* Theta scaled = K + I1*I3/m */
    const double t10 = t8*t9; /* K*Theta scaled */
    const double t11 = 1.0/t10; /* 1/(K*Theta scaled) */
    const double t12 = t9*t11; /* Theta scaled*1/(K*Theta scaled) */
    const double t13 = t4*t12; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled) */
    const double t14 = x[3]*t13; /* v_tau*(gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled) */
    const double t15 = x[4]*x[3]; /* s*v_tau */
    const double t16 = JLT_FNMA(x[0], p[12], t15); /* s*v_tau - gamma3*G/I1 */
    const double t17 = t12*t16; /* Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1) */
    const double t18 = x[4]*p[8]; /* s*R*I3 */
    const double t19 = t17*t18; /* Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1)*s*R*I3 */
    const double t20 = JLT_FMA(x[0], t13, t19); /* gamma3*(gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled) + t19 */
    const double t21 = t13*t20; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled)*t20 */
    const double t22 = -t21; /* -t21 */
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t24 = t8*t11; /* K*1/(K*Theta scaled) */
    const double t25 = p[11]*t23; /* I1*I3/m*V */
    const double t26 = JLT_FNMA(t24, t25, x[1]); /* v_nu - K*1/(K*Theta scaled)*I1*I3/m*V */
    const double t27 = t13*t26; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled)*(v_nu - K*1/(K*Theta scaled)*I1*I3/m*V) */
    const double t28 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t29 = p[13]*t28; /* R^2*I1*I3*(I1 - I3)/m*s*omega_tau*gamma3 */
    const double t30 = t24*t29; /* K*1/(K*Theta scaled)*R^2*I1*I3*(I1 - I3)/m*s*omega_tau*gamma3 */
    const double t31 = JLT_FMA(t17, t30, t27); /* Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1)*t30 + t27 */
    const double t32 = -t31; /* -t31 */
    const double t33 = -t28; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t14;
    out[2] = t22;
    out[3] = t32;
    out[4] = t33;
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
    const double t7 = t6 + p[11]; /* Theta scaled = K + I1*I3/m */
    const double t8 = t6*t7; /* K*Theta scaled */
    const double t9 = 1.0/t8; /* 1/(K*Theta scaled) */
    const double t10 = t7*t9; /* Theta scaled*1/(K*Theta scaled) */
    const double t11 = t3*t10; /* v_tau*R*I3*Theta scaled*1/(K*Theta scaled) */
    const double t12 = x[4]*p[7]; /* s*R*G */
    const double t13 = JLT_FMA(t3, x[0], t12); /* v_tau*R*I3*gamma3 + s*R*G */
    const double t14 = t10*t13; /* Theta scaled*1/(K*Theta scaled)*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t15 = x[0]*t10; /* gamma3*Theta scaled*1/(K*Theta scaled) */
    const double t16 = t14*t15; /* Theta scaled*1/(K*Theta scaled)*(v_tau*R*I3*gamma3 + s*R*G)*gamma3*Theta scaled*1/(K*Theta scaled) */
    const double t17 = p[14]*t16; /* 2*R^2*I3*t16 */
    const double t18 = t11 - t17; /* v_tau*R*I3*Theta scaled*1/(K*Theta scaled) - 2*R^2*I3*t16 */
    const double t19 = x[3]*t18; /* v_tau*(v_tau*R*I3*Theta scaled*1/(K*Theta scaled) - 2*R^2*I3*t16) */
    const double t20 = JLT_FMA(t3, t15, t14); /* v_tau*R*I3*gamma3*Theta scaled*1/(K*Theta scaled) + Theta scaled*1/(K*Theta scaled)*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t21 = t10*p[7]; /* Theta scaled*1/(K*Theta scaled)*R*G */
    const double t22 = x[4]*t10; /* s*Theta scaled*1/(K*Theta scaled) */
    const double t23 = t14*t22; /* Theta scaled*1/(K*Theta scaled)*(v_tau*R*I3*gamma3 + s*R*G)*s*Theta scaled*1/(K*Theta scaled) */
    const double t24 = p[15]*t23; /* 2*R^2*I1*t23 */
    const double t25 = t21 - t24; /* Theta scaled*1/(K*Theta scaled)*R*G - 2*R^2*I1*t23 */
    const double t26 = x[3]*t25; /* v_tau*(Theta scaled*1/(K*Theta scaled)*R*G - 2*R^2*I1*t23) */
    const double t27 = x[0]*t16; /* gamma3*t16 */
    const double t28 = JLT_FMS(p[16], t27, t14); /* 4*R^2*I3*gamma3*t16 - Theta scaled*1/(K*Theta scaled)*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t29 = x[4]*x[3]; /* s*v_tau */
    const double t30 = JLT_FNMA(x[0], p[12], t29); /* s*v_tau - gamma3*G/I1 */
    const double t31 = t22*t30; /* s*Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1) */
    const double t32 = JLT_FNMA(t16, p[16], t11); /* v_tau*R*I3*Theta scaled*1/(K*Theta scaled) - t16*4*R^2*I3 */
    const double t33 = p[8]*t31; /* R*I3*s*Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1) */
    const double t34 = x[3]*p[17]; /* v_tau*2*R*I3 */
    const double t35 = t16*t34; /* t16*v_tau*2*R*I3 */
    const double t36 = JLT_FMS(t23, p[18], t35); /* t23*R*I3*G/I1 - t16*v_tau*2*R*I3 */
    const double t37 = JLT_FNMA(t32, t33, t36); /* t23*R*I3*G/I1 - t16*v_tau*2*R*I3 - (v_tau*R*I3*Theta scaled*1/(K*Theta scaled) - t16*4*R^2*I3)*t33 */
    const double t38 = JLT_FMA(t14, t28, t37); /* Theta scaled*1/(K*Theta scaled)*(v_tau*R*I3*gamma3 + s*R*G)*t28 + t37 */
    const double t39 = t15*p[20]; /* gamma3*Theta scaled*1/(K*Theta scaled)*(-R^2*I3^2) */
    const double t40 = t31*t39; /* s*Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1)*gamma3*Theta scaled*1/(K*Theta scaled)*(-R^2*I3^2) */
    const double t41 = x[4]*p[21]; /* s*(-R*I3) */
    const double t42 = JLT_FMA(t23, t41, t40); /* t23*s*(-R*I3) + t40 */
    const double t43 = JLT_FMA(t27, p[19], t42); /* gamma3*t16*(-2*R*I3) + t23*s*(-R*I3) + t40 */
    const double t44 = JLT_FNMA(x[4], t14, p[23]); /* 1/2*G/(R*I1) - s*Theta scaled*1/(K*Theta scaled)*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t45 = t16*p[22]; /* t16*4*R^2*I1 */
    const double t46 = t44*t45; /* t44*t16*4*R^2*I1 */
    const double t47 = JLT_FMA(p[7], t22, t14); /* R*G*s*Theta scaled*1/(K*Theta scaled) + Theta scaled*1/(K*Theta scaled)*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t48 = t10*t30; /* Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1) */
    const double t49 = p[8]*t48; /* R*I3*Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1) */
    const double t50 = JLT_FMS(t31, p[24], t3); /* s*Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1)*4*R^3*I1*I3 - v_tau*R*I3 */
    const double t51 = JLT_FMS(t23, t50, t46); /* t23*t50 - t44*t16*4*R^2*I1 */
    const double t52 = JLT_FNMA(t47, t49, t51); /* t23*t50 - t44*t16*4*R^2*I1 - t47*R*I3*Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1) */
    const double t53 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t54 = t6*t9; /* K*1/(K*Theta scaled) */
    const double t55 = p[11]*t53; /* I1*I3/m*V */
    const double t56 = JLT_FNMA(t54, t55, x[1]); /* v_nu - K*1/(K*Theta scaled)*I1*I3/m*V */
    const double t57 = t11*t56; /* v_tau*R*I3*Theta scaled*1/(K*Theta scaled)*(v_nu - K*1/(K*Theta scaled)*I1*I3/m*V) */
    const double t58 = t10 + t54; /* Theta scaled*1/(K*Theta scaled) + K*1/(K*Theta scaled) */
    const double t59 = x[0]*p[26]; /* gamma3*R^2*(I1 - I3) */
    const double t60 = t1*t59; /* s*omega_tau*gamma3*R^2*(I1 - I3) */
    const double t61 = t30*t60; /* (s*v_tau - gamma3*G/I1)*s*omega_tau*gamma3*R^2*(I1 - I3) */
    const double t62 = JLT_FNMA(t13, t53, t61); /* (s*v_tau - gamma3*G/I1)*s*omega_tau*gamma3*R^2*(I1 - I3) - (v_tau*R*I3*gamma3 + s*R*G)*V */
    const double t63 = t54*t62; /* K*1/(K*Theta scaled)*t62 */
    const double t64 = t58*t63; /* (Theta scaled*1/(K*Theta scaled) + K*1/(K*Theta scaled))*K*1/(K*Theta scaled)*t62 */
    const double t65 = t15*p[25]; /* gamma3*Theta scaled*1/(K*Theta scaled)*2*R^2*I1*I3^2/m */
    const double t66 = t54*p[13]; /* K*1/(K*Theta scaled)*R^2*I1*I3*(I1 - I3)/m */
    const double t67 = t1*t48; /* s*omega_tau*Theta scaled*1/(K*Theta scaled)*(s*v_tau - gamma3*G/I1) */
    const double t68 = t15*t66; /* gamma3*Theta scaled*1/(K*Theta scaled)*K*1/(K*Theta scaled)*R^2*I1*I3*(I1 - I3)/m */
    const double t69 = t1*t68; /* s*omega_tau*t68 */
    const double t70 = JLT_FMS(t64, t65, t57); /* t64*gamma3*Theta scaled*1/(K*Theta scaled)*2*R^2*I1*I3^2/m - t57 */
    const double t71 = JLT_FNMA(t66, t67, t70); /* t70 - K*1/(K*Theta scaled)*R^2*I1*I3*(I1 - I3)/m*t67 */
    const double t72 = JLT_FMA(t17, x[1], t71); /* 2*R^2*I3*t16*v_nu + t70 - K*1/(K*Theta scaled)*R^2*I1*I3*(I1 - I3)/m*t67 */
    const double t73 = JLT_FMA(p[12], t69, t72); /* G/I1*s*omega_tau*t68 + t72 */
    const double t74 = t14*t54; /* Theta scaled*1/(K*Theta scaled)*(v_tau*R*I3*gamma3 + s*R*G)*K*1/(K*Theta scaled) */
    const double t75 = JLT_FMS(p[11], t74, t14); /* I1*I3/m*t74 - Theta scaled*1/(K*Theta scaled)*(v_tau*R*I3*gamma3 + s*R*G) */
    const double t76 = t74*p[27]; /* t74*R*I1*I3/m */
    const double t77 = t30*t68; /* (s*v_tau - gamma3*G/I1)*t68 */
    const double t78 = JLT_FNMA(x[4], t77, t76); /* t74*R*I1*I3/m - s*(s*v_tau - gamma3*G/I1)*t68 */
    const double t79 = p[8]*t15; /* R*I3*gamma3*Theta scaled*1/(K*Theta scaled) */
    const double t80 = t56*t79; /* (v_nu - K*1/(K*Theta scaled)*I1*I3/m*V)*R*I3*gamma3*Theta scaled*1/(K*Theta scaled) */
    const double t81 = JLT_FMA(x[4], t69, t80); /* s*s*omega_tau*t68 + t80 */
    const double t82 = -t81; /* -(s*s*omega_tau*t68 + t80) */
    const double t83 = t21*t56; /* Theta scaled*1/(K*Theta scaled)*R*G*(v_nu - K*1/(K*Theta scaled)*I1*I3/m*V) */
    const double t84 = t22*p[28]; /* s*Theta scaled*1/(K*Theta scaled)*2*R^2*I1^2*I3/m */
    const double t85 = JLT_FMS(t64, t84, t83); /* t64*s*Theta scaled*1/(K*Theta scaled)*2*R^2*I1^2*I3/m - t83 */
    const double t86 = JLT_FNMA(x[2], t77, t85); /* t64*s*Theta scaled*1/(K*Theta scaled)*2*R^2*I1^2*I3/m - t83 - omega_tau*(s*v_tau - gamma3*G/I1)*t68 */
    const double t87 = JLT_FNMA(x[3], t69, t86); /* t86 - v_tau*s*omega_tau*t68 */
    const double t88 = JLT_FMA(t24, x[1], t87); /* 2*R^2*I1*t23*v_nu + t86 - v_tau*s*omega_tau*t68 */
    const double t89 = -t1; /* -s*omega_tau */
    const double t90 = x[4]*x[0]; /* s*gamma3 */
    const double t91 = -t90; /* -s*gamma3 */
    const double t92 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t93 = -t92; /* -omega_tau*gamma3 */
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
    out[10] = t38;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t43;
    out[14] = t52;
    out[15] = t73;
    out[16] = t75;
    out[17] = t78;
    out[18] = t82;
    out[19] = t88;
    out[20] = t89;
    out[21] = 0.0;
    out[22] = t91;
    out[23] = 0.0;
    out[24] = t93;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[4]*p[7]; /* s*R*G */
    const double t3 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t5 = x[4]*x[4]; /* s*s */
    const double t6 = p[9]*t5; /* R^2*I1*s*s */
    const double t7 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t8 = JLT_FMA(x[0], t7, t6); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s*s */
    const double t9 = t8 + p[11]; /* Theta scaled = K + I1*I3/m */
    const double t10 = t8*t9; /* K*Theta scaled */
    const double t11 = 1.0/t10; /* 1/(K*Theta scaled) */
    const double t12 = t9*t11; /* Theta scaled*1/(K*Theta scaled) */
    const double t13 = t4*t12; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled) */
    const double t14 = x[3]*t13; /* v_tau*(gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled) */
    const double t15 = x[4]*x[3]; /* s*v_tau */
    const double t16 = JLT_FNMA(x[0], p[12], t15); /* s*v_tau - gamma3*G/I1 */
    const double t17 = x[4]*t12; /* s*Theta scaled*1/(K*Theta scaled) */
    const double t18 = t16*t17; /* (s*v_tau - gamma3*G/I1)*s*Theta scaled*1/(K*Theta scaled) */
    const double t19 = p[8]*t18; /* R*I3*(s*v_tau - gamma3*G/I1)*s*Theta scaled*1/(K*Theta scaled) */
    const double t20 = x[0]*t13; /* gamma3*(gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled) */
    const double t21 = t19 + t20; /* t19 + t20 */
    const double t22 = t13*t21; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled)*(t19 + t20) */
    const double t23 = -t22; /* -t22 */
    const double t24 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t25 = t8*t11; /* K*1/(K*Theta scaled) */
    const double t26 = p[11]*t25; /* I1*I3/m*K*1/(K*Theta scaled) */
    const double t27 = JLT_FNMA(t24, t26, x[1]); /* v_nu - V*I1*I3/m*K*1/(K*Theta scaled) */
    const double t28 = t13*t27; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled)*(v_nu - V*I1*I3/m*K*1/(K*Theta scaled)) */
    const double t29 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t30 = t17*t25; /* s*Theta scaled*1/(K*Theta scaled)*K*1/(K*Theta scaled) */
    const double t31 = p[13]*t30; /* R^2*I1*I3*(I1 - I3)/m*s*Theta scaled*1/(K*Theta scaled)*K*1/(K*Theta scaled) */
    const double t32 = t16*t31; /* (s*v_tau - gamma3*G/I1)*t31 */
    const double t33 = JLT_FMA(t29, t32, t28); /* omega_tau*gamma3*(s*v_tau - gamma3*G/I1)*t31 + t28 */
    const double t34 = -t33; /* -(omega_tau*gamma3*(s*v_tau - gamma3*G/I1)*t31 + t28) */
    const double t35 = x[4]*t29; /* s*omega_tau*gamma3 */
    const double t36 = -t35; /* -s*omega_tau*gamma3 */
    const double t37 = t0*2.0; /* s*omega_tau*2 */
    const double t38 = t3*t12; /* v_tau*R*I3*Theta scaled*1/(K*Theta scaled) */
    const double t39 = x[0]*t12; /* gamma3*Theta scaled*1/(K*Theta scaled) */
    const double t40 = t13*t39; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled)*gamma3*Theta scaled*1/(K*Theta scaled) */
    const double t41 = p[14]*t40; /* 2*R^2*I3*t40 */
    const double t42 = t38 - t41; /* v_tau*R*I3*Theta scaled*1/(K*Theta scaled) - 2*R^2*I3*t40 */
    const double t43 = x[3]*t42; /* v_tau*(v_tau*R*I3*Theta scaled*1/(K*Theta scaled) - 2*R^2*I3*t40) */
    const double t44 = JLT_FMA(t3, t39, t13); /* v_tau*R*I3*gamma3*Theta scaled*1/(K*Theta scaled) + (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled) */
    const double t45 = p[7]*t12; /* R*G*Theta scaled*1/(K*Theta scaled) */
    const double t46 = t13*t17; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled)*s*Theta scaled*1/(K*Theta scaled) */
    const double t47 = p[15]*t46; /* 2*R^2*I1*t46 */
    const double t48 = t45 - t47; /* R*G*Theta scaled*1/(K*Theta scaled) - 2*R^2*I1*t46 */
    const double t49 = x[3]*t48; /* v_tau*(R*G*Theta scaled*1/(K*Theta scaled) - 2*R^2*I1*t46) */
    const double t50 = t39*p[29]; /* gamma3*Theta scaled*1/(K*Theta scaled)*4*R^3*I3^2 */
    const double t51 = JLT_FMS(t18, t50, t13); /* (s*v_tau - gamma3*G/I1)*s*Theta scaled*1/(K*Theta scaled)*gamma3*Theta scaled*1/(K*Theta scaled)*4*R^3*I3^2 - (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled) */
    const double t52 = JLT_FMA(t20, 2.0, t19); /* t20*2 + t19 */
    const double t53 = t20*p[16]; /* t20*4*R^2*I3 */
    const double t54 = t40*t53; /* t40*t20*4*R^2*I3 */
    const double t55 = JLT_FMA(t46, p[18], t54); /* t46*R*I3*G/I1 + t40*t20*4*R^2*I3 */
    const double t56 = JLT_FMA(t13, t51, t55); /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled)*t51 + t46*R*I3*G/I1 + t40*t20*4*R^2*I3 */
    const double t57 = JLT_FNMA(t38, t52, t56); /* t56 - v_tau*R*I3*Theta scaled*1/(K*Theta scaled)*(t20*2 + t19) */
    const double t58 = x[4]*t46; /* s*t46 */
    const double t59 = JLT_FMA(t39, t52, t58); /* gamma3*Theta scaled*1/(K*Theta scaled)*(t20*2 + t19) + s*t46 */
    const double t60 = p[21]*t59; /* (-R*I3)*(gamma3*Theta scaled*1/(K*Theta scaled)*(t20*2 + t19) + s*t46) */
    const double t61 = t15 + t16; /* s*v_tau + s*v_tau - gamma3*G/I1 */
    const double t62 = t12*t61; /* Theta scaled*1/(K*Theta scaled)*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t63 = p[8]*t62; /* R*I3*t62 */
    const double t64 = t13*t63; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled)*R*I3*t62 */
    const double t65 = t46*p[22]; /* t46*4*R^2*I1 */
    const double t66 = JLT_FMS(t21, t65, t64); /* (t19 + t20)*t46*4*R^2*I1 - t64 */
    const double t67 = JLT_FNMA(t45, t52, t66); /* (t19 + t20)*t46*4*R^2*I1 - t64 - R*G*Theta scaled*1/(K*Theta scaled)*(t20*2 + t19) */
    const double t68 = t12 + t25; /* Theta scaled*1/(K*Theta scaled) + K*1/(K*Theta scaled) */
    const double t69 = t4*t24; /* (gamma3*v_tau*R*I3 + s*R*G)*V */
    const double t70 = t16*p[26]; /* (s*v_tau - gamma3*G/I1)*R^2*(I1 - I3) */
    const double t71 = JLT_FNMA(t35, t70, t69); /* (gamma3*v_tau*R*I3 + s*R*G)*V - s*omega_tau*gamma3*(s*v_tau - gamma3*G/I1)*R^2*(I1 - I3) */
    const double t72 = t25*t71; /* K*1/(K*Theta scaled)*t71 */
    const double t73 = t68*t72; /* (Theta scaled*1/(K*Theta scaled) + K*1/(K*Theta scaled))*K*1/(K*Theta scaled)*t71 */
    const double t74 = t39*p[25]; /* gamma3*Theta scaled*1/(K*Theta scaled)*2*R^2*I1*I3^2/m */
    const double t75 = t73*t74; /* t73*gamma3*Theta scaled*1/(K*Theta scaled)*2*R^2*I1*I3^2/m */
    const double t76 = t29*p[30]; /* omega_tau*gamma3*R^2*I3*G*(I1 - I3)/m */
    const double t77 = JLT_FMS(t30, t76, t75); /* s*Theta scaled*1/(K*Theta scaled)*K*1/(K*Theta scaled)*omega_tau*gamma3*R^2*I3*G*(I1 - I3)/m - t73*gamma3*Theta scaled*1/(K*Theta scaled)*2*R^2*I1*I3^2/m */
    const double t78 = JLT_FNMA(t27, t38, t77); /* t77 - (v_nu - V*I1*I3/m*K*1/(K*Theta scaled))*v_tau*R*I3*Theta scaled*1/(K*Theta scaled) */
    const double t79 = JLT_FMA(x[1], t41, t78); /* v_nu*2*R^2*I3*t40 + t78 */
    const double t80 = JLT_FNMA(x[2], t32, t79); /* v_nu*2*R^2*I3*t40 + t78 - omega_tau*(s*v_tau - gamma3*G/I1)*t31 */
    const double t81 = JLT_FMS(t13, t26, t13); /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled)*I1*I3/m*K*1/(K*Theta scaled) - (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled) */
    const double t82 = t25*p[27]; /* K*1/(K*Theta scaled)*R*I1*I3/m */
    const double t83 = t13*t82; /* (gamma3*v_tau*R*I3 + s*R*G)*Theta scaled*1/(K*Theta scaled)*K*1/(K*Theta scaled)*R*I1*I3/m */
    const double t84 = JLT_FNMA(x[0], t32, t83); /* t83 - gamma3*(s*v_tau - gamma3*G/I1)*t31 */
    const double t85 = p[8]*t39; /* R*I3*gamma3*Theta scaled*1/(K*Theta scaled) */
    const double t86 = t27*t85; /* (v_nu - V*I1*I3/m*K*1/(K*Theta scaled))*R*I3*gamma3*Theta scaled*1/(K*Theta scaled) */
    const double t87 = JLT_FMA(t31, t35, t86); /* t31*s*omega_tau*gamma3 + t86 */
    const double t88 = -t87; /* -(t31*s*omega_tau*gamma3 + t86) */
    const double t89 = t29*p[13]; /* omega_tau*gamma3*R^2*I1*I3*(I1 - I3)/m */
    const double t90 = t25*t89; /* K*1/(K*Theta scaled)*omega_tau*gamma3*R^2*I1*I3*(I1 - I3)/m */
    const double t91 = t62*t90; /* t62*K*1/(K*Theta scaled)*omega_tau*gamma3*R^2*I1*I3*(I1 - I3)/m */
    const double t92 = t17*p[28]; /* s*Theta scaled*1/(K*Theta scaled)*2*R^2*I1^2*I3/m */
    const double t93 = JLT_FMS(x[1], t47, t91); /* v_nu*2*R^2*I1*t46 - t91 */
    const double t94 = JLT_FNMA(t73, t92, t93); /* v_nu*2*R^2*I1*t46 - t91 - t73*s*Theta scaled*1/(K*Theta scaled)*2*R^2*I1^2*I3/m */
    const double t95 = JLT_FNMA(t27, t45, t94); /* t94 - (v_nu - V*I1*I3/m*K*1/(K*Theta scaled))*R*G*Theta scaled*1/(K*Theta scaled) */
    const double t96 = -t0; /* -s*omega_tau */
    const double t97 = x[4]*x[0]; /* s*gamma3 */
    const double t98 = -t97; /* -s*gamma3 */
    const double t99 = -t29; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t14;
    out[2] = t23;
    out[3] = t34;
    out[4] = t36;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t5;
    out[8] = 0.0;
    out[9] = t37;
    out[10] = t43;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t44;
    out[14] = t49;
    out[15] = t57;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t60;
    out[19] = t67;
    out[20] = t80;
    out[21] = t81;
    out[22] = t84;
    out[23] = t88;
    out[24] = t95;
    out[25] = t96;
    out[26] = 0.0;
    out[27] = t98;
    out[28] = 0.0;
    out[29] = t99;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s*s */
    const double t4 = t3 + p[11]; /* Theta scaled = K + I1*I3/m */
    const double t5 = t3*t4; /* K*Theta scaled */
    const double t6 = x[2]*p[31]; /* omega_tau*R*I1*(I1 - I3)/m */
    const double t7 = t0*t6; /* s*s*omega_tau*R*I1*(I1 - I3)/m */
    const double t8 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t9 = JLT_FNMA(p[11], t8, t7); /* s*s*omega_tau*R*I1*(I1 - I3)/m - I1*I3/m*V */
    const double t10 = JLT_FMA(t4, x[1], t9); /* Theta scaled*v_nu + s*s*omega_tau*R*I1*(I1 - I3)/m - I1*I3/m*V */
    const double t11 = p[8]*t10; /* R*I3*t10 */
    const double t12 = t11/t5; /* R*I3*t10/(K*Theta scaled) */
    const double t13 = x[2] + t12; /* omega_tau + R*I3*t10/(K*Theta scaled) */
    const double t14 = x[0]*t13; /* gamma3*(omega_tau + R*I3*t10/(K*Theta scaled)) */
    const double t15 = -t14; /* -gamma3*(omega_tau + R*I3*t10/(K*Theta scaled)) */
    out[0] = t15;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[33]*x[0]; /* I3/I1*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K scaled = gamma3*I3/I1*gamma3 + s*s */
    const double t4 = 1.0/t3; /* 1/K scaled */
    const double t5 = t3 + p[35]; /* Theta scaled = K scaled + I3/(m*R^2) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[34]); /* Theta scaled*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = JLT_FMA(t4, t7, t0); /* 1/K scaled*(Theta scaled*v_tau*v_tau + G^2/(m*R^2*I1)) + v_nu*v_nu */
    const double t9 = p[32]*t8; /* 1/2*m*t8 */
    const double t10 = p[36]*x[2]; /* 1/2*I1*omega_tau */
    const double t11 = JLT_FMA(x[2], t10, t9); /* omega_tau*1/2*I1*omega_tau + 1/2*m*t8 */
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t13 = p[37]*t12; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t14 = t12*t13; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t15 = x[4]*x[3]; /* s*v_tau */
    const double t16 = JLT_FNMA(x[0], p[12], t15); /* s*v_tau - gamma3*G/I1 */
    const double t17 = t4*t16; /* 1/K scaled*(s*v_tau - gamma3*G/I1) */
    const double t18 = t5*p[38]; /* Theta scaled*m*I1*(I1 - I3) */
    const double t19 = t17*t18; /* 1/K scaled*(s*v_tau - gamma3*G/I1)*Theta scaled*m*I1*(I1 - I3) */
    const double t20 = JLT_FMA(t17, t19, t14); /* 1/K scaled*(s*v_tau - gamma3*G/I1)*t19 + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[0] = t11;
    out[1] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[9]*x[4]; /* R^2*I1*s */
    const double t1 = x[4]*t0; /* s*R^2*I1*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + s*R^2*I1*s */
    const double t4 = 1.0/t3; /* 1/K */
    const double t5 = JLT_FMA(t3, p[0], p[41]); /* Theta = K*m + I1*I3 */
    const double t6 = t4*t5; /* 1/K*Theta */
    const double t7 = x[3]*t6; /* v_tau*1/K*Theta */
    const double t8 = JLT_FNMA(p[40], t7, x[3]); /* v_tau - 1/m*v_tau*1/K*Theta */
    const double t9 = x[3]*t8; /* v_tau*(v_tau - 1/m*v_tau*1/K*Theta) */
    const double t10 = JLT_FNMA(t4, p[42], t9); /* v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m */
    const double t11 = t4*t10; /* 1/K*(v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m) */
    const double t12 = p[39]*x[0]; /* m*R^2*I3*gamma3 */
    const double t13 = t11*t12; /* 1/K*(v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m)*m*R^2*I3*gamma3 */
    const double t14 = p[0]*x[1]; /* m*v_nu */
    const double t15 = p[3]*x[2]; /* I1*omega_tau */
    const double t16 = x[4]*p[43]; /* s*m*R^2*I1 */
    const double t17 = t11*t16; /* 1/K*(v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m)*s*m*R^2*I1 */
    const double t18 = x[4]*x[3]; /* s*v_tau */
    const double t19 = JLT_FNMA(x[0], p[12], t18); /* s*v_tau - gamma3*G/I1 */
    const double t20 = t4*t19; /* 1/K*(s*v_tau - gamma3*G/I1) */
    const double t21 = t6*t20; /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) */
    const double t22 = JLT_FNMA(p[45], t21, t20); /* 1/K*(s*v_tau - gamma3*G/I1) - 2/m*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) */
    const double t23 = t20*t22; /* 1/K*(s*v_tau - gamma3*G/I1)*t22 */
    const double t24 = x[0]*p[44]; /* gamma3*2*m*R^4*I1^2*I3*(I1 - I3) */
    const double t25 = t23*t24; /* 1/K*(s*v_tau - gamma3*G/I1)*t22*gamma3*2*m*R^4*I1^2*I3*(I1 - I3) */
    const double t26 = JLT_FNMA(t21, p[46], t25); /* t25 - 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1*G*(I1 - I3) */
    const double t27 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t28 = p[47]*t27; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    const double t29 = t27*p[48]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    const double t30 = t21*p[49]; /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t31 = x[4]*t30; /* s*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t32 = x[3]*t30; /* v_tau*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t33 = x[4]*p[50]; /* s*2*m*R^4*I1^3*(I1 - I3) */
    const double t34 = JLT_FMA(t23, t33, t32); /* 1/K*(s*v_tau - gamma3*G/I1)*t22*s*2*m*R^4*I1^3*(I1 - I3) + t32 */
    out[0] = t13;
    out[1] = t14;
    out[2] = t15;
    out[3] = t7;
    out[4] = t17;
    out[5] = t26;
    out[6] = t28;
    out[7] = t29;
    out[8] = t31;
    out[9] = t34;
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
    .state_count = 5, .param_count = 7, .block_count = 51,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 22, 7, 1, 0, 0, 12, 7 }, { 16, 71, 0, 6, 0, 0, 10, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .jacobian = { jacobian, 25, { 8, 55, 30, 1, 0, 0, 13, 23 }, { 91, 507, 0, 46, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 13, 60, 26, 1, 0, 0, 14, 29 }, { 104, 567, 0, 52, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .divergence = { divergence, 1, { 3, 8, 4, 1, 0, 0, 10, 5 }, { 8, 30, 0, 3, 0, 0, 10, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .integral_values = { integral_values, 2, { 1, 12, 7, 1, 0, 0, 7, 5 }, { 9, 35, 0, 3, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are" },
    .integral_gradients = { integral_gradients, 10, { 0, 25, 9, 1, 0, 0, 11, 5 }, { 26, 155, 0, 14, 0, 0, 13, 8 },
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
