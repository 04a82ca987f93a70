/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   26    8    1    1    0     16    9   (94)
 *  jacobian            4   53   25    1    1    0     17   17   (464)
 *  rhs_jacobian        6   56   28    1    1    0     18   23   (541)
 *  divergence          3   17    6    1    1    0     15    7   (46)
 *  integral_values     2   15    8    1    1    0      8    8   (50)
 *  integral_gradients  4   29    8    1    1    0     14   10   (123)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_balanced;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_avx512;

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
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    const double t2 = t0*params[4]; /* R*R*I3 */
    const double t3 = params[1]*params[6]; /* R*G */
    const double t4 = params[1]*params[4]; /* R*I3 */
    const double t5 = params[3]*params[4]; /* I1*I3 */
    const double t6 = params[4]/params[3]; /* I3/I1 */
    const double t7 = params[1]*params[3]; /* R*I1 */
    const double t8 = params[3] - params[4]; /* I1 - I3 */
    const double t9 = t4*t8; /* R*I3*(I1 - I3) */
    const double t10 = t1*2.0; /* R*R*I1*2 */
    const double t11 = t2*2.0; /* R*R*I3*2 */
    const double t12 = t10 - t11; /* R*R*I1*2 - R*R*I3*2 */
    const double t13 = 1.0/params[3]; /* 1/I1 */
    const double t14 = 2.0/params[3]; /* 2/I1 */
    const double t15 = params[1]*(-2.0); /* R*(-2) */
    const double t16 = params[4]*t15; /* I3*R*(-2) */
    const double t17 = -t4; /* -R*I3 */
    const double t18 = params[3]*params[0]; /* I1*m */
    const double t19 = params[4]*t18; /* I3*I1*m */
    const double t20 = params[4]*t7; /* I3*R*I1 */
    const double t21 = t7*t8; /* R*I1*(I1 - I3) */
    const double t22 = params[4]*2.0; /* I3*2 */
    const double t23 = t22/params[3]; /* I3*2/I1 */
    const double t24 = params[4]*params[4]; /* I3*I3 */
    const double t25 = params[1]*t24; /* R*I3*I3 */
    const double t26 = t25/params[3]; /* R*I3*I3/I1 */
    const double t27 = -t26; /* -R*I3*I3/I1 */
    const double t28 = t1*params[4]; /* R*R*I1*I3 */
    const double t29 = t8*t28; /* (I1 - I3)*R*R*I1*I3 */
    const double t30 = -t29; /* -(I1 - I3)*R*R*I1*I3 */
    const double t31 = params[0]/2.0; /* m/2 */
    const double t32 = params[6]*params[6]; /* G*G */
    const double t33 = params[3]/2.0; /* I1/2 */
    const double t34 = params[3]*params[3]; /* I1*I1 */
    const double t35 = params[0]*t34; /* m*I1*I1 */
    const double t36 = -t31; /* -m/2 */
    const double t37 = 1.0/params[0]; /* 1/m */
    const double t38 = t32/params[0]; /* G*G/m */
    const double t39 = t8*params[0]; /* (I1 - I3)*m */
    const double t40 = params[3]*2.0; /* I1*2 */
    const double t41 = t40 - t22; /* I1*2 - I3*2 */
    const double t42 = 2.0*params[0]; /* 2*m */
    const double t43 = t34*t42; /* I1*I1*2*m */
    const double t44 = params[1]*t42; /* R*2*m */
    const double t45 = t34*t44; /* I1*I1*R*2*m */
    const double t46 = params[1]*2.0; /* R*2 */
    const double t47 = params[3]*t46; /* I1*R*2 */
    const double t48 = t8*t47; /* (I1 - I3)*I1*R*2 */
    out[7] = t1;
    out[8] = t2;
    out[9] = t3;
    out[10] = t4;
    out[11] = t5;
    out[12] = t6;
    out[13] = t7;
    out[14] = t9;
    out[15] = t12;
    out[16] = t13;
    out[17] = t14;
    out[18] = t16;
    out[19] = t17;
    out[20] = t19;
    out[21] = t20;
    out[22] = t21;
    out[23] = t23;
    out[24] = t27;
    out[25] = t30;
    out[26] = t29;
    out[27] = t31;
    out[28] = t32;
    out[29] = t33;
    out[30] = t35;
    out[31] = t8;
    out[32] = t36;
    out[33] = t37;
    out[34] = t38;
    out[35] = t39;
    out[36] = t41;
    out[37] = t43;
    out[38] = t45;
    out[39] = t48;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = t2*p[7]; /* (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t6 = x[0]*p[8]; /* gamma3*R^2*I3 */
    const double t7 = JLT_FMA(x[0], t6, t5); /* K = gamma3*gamma3*R^2*I3 + (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t8 = t3*p[9]; /* s*R*G */
    const double t9 = x[0]*p[10]; /* gamma3*R*I3 */
    const double t10 = JLT_FMA(x[3], t9, t8); /* v_tau*gamma3*R*I3 + s*R*G */
    const double t11 = JLT_FMA(t7, p[0], p[11]); /* Theta = K*m + I1*I3 */
    const double t12 = t7*t11; /* K*Theta */
    const double t13 = t3*t12; /* s*K*Theta */
    const double t14 = 1.0/t13; /* 1/(s*K*Theta) */
    const double t15 = t11*t14; /* Theta*1/(s*K*Theta) */
    const double t16 = t3*t15; /* s*Theta*1/(s*K*Theta) */
    const double t17 = t10*t16; /* (v_tau*gamma3*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta) */
    const double t18 = t7*t15; /* K*Theta*1/(s*K*Theta) */
    const double t19 = t17*t18; /* (v_tau*gamma3*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta)*K*Theta*1/(s*K*Theta) */
    const double t20 = x[3]*t19; /* v_tau*t19 */
    const double t21 = x[0]*t19; /* gamma3*t19 */
    const double t22 = x[3]*p[13]; /* v_tau*R*I1 */
    const double t23 = t3*t22; /* s*v_tau*R*I1 */
    const double t24 = JLT_FNMA(x[0], p[9], t23); /* s*v_tau*R*I1 - gamma3*R*G */
    const double t25 = t16*t24; /* s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t26 = JLT_FMA(p[12], t25, t21); /* I3/I1*s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G) + gamma3*t19 */
    const double t27 = t17*t26; /* (v_tau*gamma3*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta)*t26 */
    const double t28 = -t27; /* -(v_tau*gamma3*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta)*t26 */
    const double t29 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t30 = t3*t7; /* s*K */
    const double t31 = t14*t30; /* 1/(s*K*Theta)*s*K */
    const double t32 = p[11]*t29; /* I1*I3*V */
    const double t33 = JLT_FNMA(t31, t32, x[1]); /* v_nu - 1/(s*K*Theta)*s*K*I1*I3*V */
    const double t34 = t19*t33; /* t19*(v_nu - 1/(s*K*Theta)*s*K*I1*I3*V) */
    const double t35 = x[2]*p[14]; /* omega_tau*R*I3*(I1 - I3) */
    const double t36 = x[0]*t35; /* gamma3*omega_tau*R*I3*(I1 - I3) */
    const double t37 = t31*t36; /* 1/(s*K*Theta)*s*K*gamma3*omega_tau*R*I3*(I1 - I3) */
    const double t38 = JLT_FMA(t25, t37, t34); /* s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G)*1/(s*K*Theta)*s*K*gamma3*omega_tau*R*I3*(I1 - I3) + t19*(v_nu - 1/(s*K*Theta)*s*K*I1*I3*V) */
    const double t39 = -t38; /* -t38 */
    out[0] = t4;
    out[1] = t20;
    out[2] = t28;
    out[3] = t39;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = p[7]*t2; /* R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t4 = x[0]*p[8]; /* gamma3*R^2*I3 */
    const double t5 = JLT_FMA(x[0], t4, t3); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t6 = JLT_FMA(t5, p[0], p[11]); /* Theta = K*m + I1*I3 */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = t5*t6; /* K*Theta */
    const double t9 = t7*t8; /* s*K*Theta */
    const double t10 = 1.0/t9; /* 1/(s*K*Theta) */
    const double t11 = t6*t10; /* Theta*1/(s*K*Theta) */
    const double t12 = t5*t11; /* K*Theta*1/(s*K*Theta) */
    const double t13 = x[0]*t12; /* gamma3*K*Theta*1/(s*K*Theta) */
    const double t14 = x[2]*t13; /* omega_tau*gamma3*K*Theta*1/(s*K*Theta) */
    const double t15 = -t14; /* -omega_tau*gamma3*K*Theta*1/(s*K*Theta) */
    const double t16 = t7*p[9]; /* s*R*G */
    const double t17 = x[3]*p[10]; /* v_tau*R*I3 */
    const double t18 = JLT_FMA(x[0], t17, t16); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t19 = t7*t11; /* s*Theta*1/(s*K*Theta) */
    const double t20 = t18*t19; /* (gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta) */
    const double t21 = t12*t20; /* K*Theta*1/(s*K*Theta)*(gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta) */
    const double t22 = t13*t21; /* gamma3*K*Theta*1/(s*K*Theta)*t21 */
    const double t23 = JLT_FMS(t13, p[9], t17); /* gamma3*K*Theta*1/(s*K*Theta)*R*G - v_tau*R*I3 */
    const double t24 = x[0]*p[15]; /* gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t25 = t20*t24; /* (gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta)*gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t26 = t23 - t25; /* gamma3*K*Theta*1/(s*K*Theta)*R*G - v_tau*R*I3 - t25 */
    const double t27 = JLT_FNMA(t19, t26, t22); /* gamma3*K*Theta*1/(s*K*Theta)*t21 - s*Theta*1/(s*K*Theta)*(gamma3*K*Theta*1/(s*K*Theta)*R*G - v_tau*R*I3 - t25) */
    const double t28 = t12*x[3]; /* K*Theta*1/(s*K*Theta)*v_tau */
    const double t29 = t27*t28; /* t27*K*Theta*1/(s*K*Theta)*v_tau */
    const double t30 = x[0]*t19; /* gamma3*s*Theta*1/(s*K*Theta) */
    const double t31 = t12*t17; /* K*Theta*1/(s*K*Theta)*v_tau*R*I3 */
    const double t32 = JLT_FMA(t30, t31, t21); /* gamma3*s*Theta*1/(s*K*Theta)*K*Theta*1/(s*K*Theta)*v_tau*R*I3 + t21 */
    const double t33 = t30*2.0; /* gamma3*s*Theta*1/(s*K*Theta)*2 */
    const double t34 = JLT_FMA(x[0], t22, t20); /* gamma3*gamma3*K*Theta*1/(s*K*Theta)*t21 + (gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta) */
    const double t35 = JLT_FNMA(t26, t33, t34); /* t34 - (gamma3*K*Theta*1/(s*K*Theta)*R*G - v_tau*R*I3 - t25)*gamma3*s*Theta*1/(s*K*Theta)*2 */
    const double t36 = t21*t35; /* t21*t35 */
    const double t37 = x[3]*p[13]; /* v_tau*R*I1 */
    const double t38 = t7*t37; /* s*v_tau*R*I1 */
    const double t39 = JLT_FNMA(x[0], p[9], t38); /* s*v_tau*R*I1 - gamma3*R*G */
    const double t40 = t23*p[16]; /* (gamma3*K*Theta*1/(s*K*Theta)*R*G - v_tau*R*I3)*1/I1 */
    const double t41 = JLT_FNMA(t25, p[17], t40); /* (gamma3*K*Theta*1/(s*K*Theta)*R*G - v_tau*R*I3)*1/I1 - t25*2/I1 */
    const double t42 = t19*t39; /* s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t43 = t41*t42; /* t41*s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t44 = JLT_FMA(t13, t37, p[9]); /* gamma3*K*Theta*1/(s*K*Theta)*v_tau*R*I1 + R*G */
    const double t45 = t20*p[16]; /* (gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta)*1/I1 */
    const double t46 = JLT_FMA(t44, t45, t43); /* (gamma3*K*Theta*1/(s*K*Theta)*v_tau*R*I1 + R*G)*(gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta)*1/I1 + t41*s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t47 = t19*p[4]; /* s*Theta*1/(s*K*Theta)*I3 */
    const double t48 = JLT_FMS(t46, t47, t36); /* t46*s*Theta*1/(s*K*Theta)*I3 - t21*t35 */
    const double t49 = x[0]*p[18]; /* gamma3*(-2*R*I3) */
    const double t50 = t30*t49; /* gamma3*s*Theta*1/(s*K*Theta)*gamma3*(-2*R*I3) */
    const double t51 = t21*t50; /* t21*gamma3*s*Theta*1/(s*K*Theta)*gamma3*(-2*R*I3) */
    const double t52 = t7*t20; /* s*(gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta) */
    const double t53 = t30*t39; /* gamma3*s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t54 = JLT_FMA(p[12], t53, t52); /* I3/I1*gamma3*s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G) + s*(gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta) */
    const double t55 = t19*p[19]; /* s*Theta*1/(s*K*Theta)*(-R*I3) */
    const double t56 = JLT_FMA(t54, t55, t51); /* t54*s*Theta*1/(s*K*Theta)*(-R*I3) + t21*gamma3*s*Theta*1/(s*K*Theta)*gamma3*(-2*R*I3) */
    const double t57 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t58 = t5*t7; /* K*s */
    const double t59 = t10*t58; /* 1/(s*K*Theta)*K*s */
    const double t60 = t57*t59; /* V*1/(s*K*Theta)*K*s */
    const double t61 = JLT_FNMA(p[11], t60, x[1]); /* v_nu - I1*I3*V*1/(s*K*Theta)*K*s */
    const double t62 = t12*t61; /* K*Theta*1/(s*K*Theta)*(v_nu - I1*I3*V*1/(s*K*Theta)*K*s) */
    const double t63 = t27*t62; /* t27*K*Theta*1/(s*K*Theta)*(v_nu - I1*I3*V*1/(s*K*Theta)*K*s) */
    const double t64 = t21*t59; /* t21*1/(s*K*Theta)*K*s */
    const double t65 = t24*p[20]; /* gamma3*(2*R^2*I1 - 2*R^2*I3)*m*I1*I3 */
    const double t66 = t60*t65; /* V*1/(s*K*Theta)*K*s*gamma3*(2*R^2*I1 - 2*R^2*I3)*m*I1*I3 */
    const double t67 = JLT_FMA(p[0], t59, t19); /* m*1/(s*K*Theta)*K*s + s*Theta*1/(s*K*Theta) */
    const double t68 = t24*t30; /* gamma3*(2*R^2*I1 - 2*R^2*I3)*gamma3*s*Theta*1/(s*K*Theta) */
    const double t69 = JLT_FMA(t67, t68, t19); /* (m*1/(s*K*Theta)*K*s + s*Theta*1/(s*K*Theta))*gamma3*(2*R^2*I1 - 2*R^2*I3)*gamma3*s*Theta*1/(s*K*Theta) + s*Theta*1/(s*K*Theta) */
    const double t70 = t39*t69; /* (s*v_tau*R*I1 - gamma3*R*G)*t69 */
    const double t71 = JLT_FNMA(t30, t44, t70); /* (s*v_tau*R*I1 - gamma3*R*G)*t69 - gamma3*s*Theta*1/(s*K*Theta)*(gamma3*K*Theta*1/(s*K*Theta)*v_tau*R*I1 + R*G) */
    const double t72 = t59*p[14]; /* 1/(s*K*Theta)*K*s*R*I3*(I1 - I3) */
    const double t73 = x[2]*t72; /* omega_tau*1/(s*K*Theta)*K*s*R*I3*(I1 - I3) */
    const double t74 = JLT_FMS(t64, t66, t63); /* t21*1/(s*K*Theta)*K*s*V*1/(s*K*Theta)*K*s*gamma3*(2*R^2*I1 - 2*R^2*I3)*m*I1*I3 - t27*K*Theta*1/(s*K*Theta)*(v_nu - I1*I3*V*1/(s*K*Theta)*K*s) */
    const double t75 = JLT_FNMA(t71, t73, t74); /* t74 - t71*omega_tau*1/(s*K*Theta)*K*s*R*I3*(I1 - I3) */
    const double t76 = JLT_FMS(p[11], t64, t21); /* I1*I3*t21*1/(s*K*Theta)*K*s - t21 */
    const double t77 = t64*p[21]; /* t21*1/(s*K*Theta)*K*s*R*I1*I3 */
    const double t78 = JLT_FNMA(t53, t72, t77); /* t21*1/(s*K*Theta)*K*s*R*I1*I3 - gamma3*s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G)*1/(s*K*Theta)*K*s*R*I3*(I1 - I3) */
    const double t79 = x[2]*p[22]; /* omega_tau*R*I1*(I1 - I3) */
    const double t80 = t7*t79; /* s*omega_tau*R*I1*(I1 - I3) */
    const double t81 = JLT_FMA(t59, t80, t62); /* 1/(s*K*Theta)*K*s*s*omega_tau*R*I1*(I1 - I3) + K*Theta*1/(s*K*Theta)*(v_nu - I1*I3*V*1/(s*K*Theta)*K*s) */
    const double t82 = t30*p[19]; /* gamma3*s*Theta*1/(s*K*Theta)*(-R*I3) */
    const double t83 = t81*t82; /* t81*gamma3*s*Theta*1/(s*K*Theta)*(-R*I3) */
    out[0] = t15;
    out[1] = 0.0;
    out[2] = t7;
    out[3] = 0.0;
    out[4] = t29;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t32;
    out[8] = t48;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t56;
    out[12] = t75;
    out[13] = t76;
    out[14] = t78;
    out[15] = t83;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = t3*p[9]; /* s*R*G */
    const double t6 = x[3]*p[10]; /* v_tau*R*I3 */
    const double t7 = JLT_FMA(x[0], t6, t5); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t8 = t2*p[7]; /* (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t9 = x[0]*p[8]; /* gamma3*R^2*I3 */
    const double t10 = JLT_FMA(x[0], t9, t8); /* K = gamma3*gamma3*R^2*I3 + (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t11 = JLT_FMA(p[0], t10, p[11]); /* Theta = m*K + I1*I3 */
    const double t12 = t10*t11; /* K*Theta */
    const double t13 = t3*t12; /* s*K*Theta */
    const double t14 = 1.0/t13; /* 1/(s*K*Theta) */
    const double t15 = t11*t14; /* Theta*1/(s*K*Theta) */
    const double t16 = t3*t15; /* s*Theta*1/(s*K*Theta) */
    const double t17 = t7*t16; /* (gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta) */
    const double t18 = t10*t15; /* K*Theta*1/(s*K*Theta) */
    const double t19 = t17*t18; /* (gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta)*K*Theta*1/(s*K*Theta) */
    const double t20 = x[3]*t19; /* v_tau*t19 */
    const double t21 = x[3]*p[13]; /* v_tau*R*I1 */
    const double t22 = t3*t21; /* s*v_tau*R*I1 */
    const double t23 = JLT_FNMA(x[0], p[9], t22); /* s*v_tau*R*I1 - gamma3*R*G */
    const double t24 = t16*t23; /* s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t25 = x[0]*t19; /* gamma3*t19 */
    const double t26 = JLT_FMA(p[12], t24, t25); /* I3/I1*s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G) + gamma3*t19 */
    const double t27 = t17*t26; /* (gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta)*t26 */
    const double t28 = -t27; /* -(gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta)*t26 */
    const double t29 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t30 = t3*t10; /* s*K */
    const double t31 = t14*t30; /* 1/(s*K*Theta)*s*K */
    const double t32 = t29*t31; /* V*1/(s*K*Theta)*s*K */
    const double t33 = JLT_FNMA(p[11], t32, x[1]); /* v_nu - I1*I3*V*1/(s*K*Theta)*s*K */
    const double t34 = t19*t33; /* t19*(v_nu - I1*I3*V*1/(s*K*Theta)*s*K) */
    const double t35 = t31*p[14]; /* 1/(s*K*Theta)*s*K*R*I3*(I1 - I3) */
    const double t36 = t24*t35; /* s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G)*1/(s*K*Theta)*s*K*R*I3*(I1 - I3) */
    const double t37 = x[2]*t36; /* omega_tau*t36 */
    const double t38 = JLT_FMA(x[0], t37, t34); /* gamma3*omega_tau*t36 + t19*(v_nu - I1*I3*V*1/(s*K*Theta)*s*K) */
    const double t39 = -t38; /* -t38 */
    const double t40 = x[0]*t18; /* gamma3*K*Theta*1/(s*K*Theta) */
    const double t41 = x[2]*t40; /* omega_tau*gamma3*K*Theta*1/(s*K*Theta) */
    const double t42 = -t41; /* -omega_tau*gamma3*K*Theta*1/(s*K*Theta) */
    const double t43 = JLT_FMS(p[9], t40, t6); /* R*G*gamma3*K*Theta*1/(s*K*Theta) - v_tau*R*I3 */
    const double t44 = x[0]*p[15]; /* gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t45 = JLT_FNMA(t17, t44, t43); /* R*G*gamma3*K*Theta*1/(s*K*Theta) - v_tau*R*I3 - (gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta)*gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t46 = t16*t45; /* s*Theta*1/(s*K*Theta)*t45 */
    const double t47 = JLT_FNMA(t19, t40, t46); /* s*Theta*1/(s*K*Theta)*t45 - t19*gamma3*K*Theta*1/(s*K*Theta) */
    const double t48 = t18*t47; /* K*Theta*1/(s*K*Theta)*(s*Theta*1/(s*K*Theta)*t45 - t19*gamma3*K*Theta*1/(s*K*Theta)) */
    const double t49 = x[3]*t48; /* v_tau*t48 */
    const double t50 = -t49; /* -v_tau*t48 */
    const double t51 = t16*t40; /* s*Theta*1/(s*K*Theta)*gamma3*K*Theta*1/(s*K*Theta) */
    const double t52 = JLT_FMA(t6, t51, t19); /* v_tau*R*I3*s*Theta*1/(s*K*Theta)*gamma3*K*Theta*1/(s*K*Theta) + t19 */
    const double t53 = x[0]*t16; /* gamma3*s*Theta*1/(s*K*Theta) */
    const double t54 = 2.0*t53; /* 2*gamma3*s*Theta*1/(s*K*Theta) */
    const double t55 = JLT_FMA(t25, t40, t17); /* gamma3*t19*gamma3*K*Theta*1/(s*K*Theta) + (gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta) */
    const double t56 = JLT_FNMA(t45, t54, t55); /* t55 - t45*2*gamma3*s*Theta*1/(s*K*Theta) */
    const double t57 = t16*t17; /* s*Theta*1/(s*K*Theta)*(gamma3*v_tau*R*I3 + s*R*G)*s*Theta*1/(s*K*Theta) */
    const double t58 = t44*p[23]; /* gamma3*(2*R^2*I1 - 2*R^2*I3)*2*I3/I1 */
    const double t59 = t24*t58; /* s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G)*gamma3*(2*R^2*I1 - 2*R^2*I3)*2*I3/I1 */
    const double t60 = t57*t59; /* t57*t59 */
    const double t61 = t16*t24; /* s*Theta*1/(s*K*Theta)*s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t62 = t43*t61; /* (R*G*gamma3*K*Theta*1/(s*K*Theta) - v_tau*R*I3)*t61 */
    const double t63 = JLT_FMA(t21, t40, p[9]); /* v_tau*R*I1*gamma3*K*Theta*1/(s*K*Theta) + R*G */
    const double t64 = JLT_FMA(t57, t63, t62); /* t57*(v_tau*R*I1*gamma3*K*Theta*1/(s*K*Theta) + R*G) + (R*G*gamma3*K*Theta*1/(s*K*Theta) - v_tau*R*I3)*t61 */
    const double t65 = JLT_FMS(p[12], t64, t60); /* I3/I1*t64 - t57*t59 */
    const double t66 = JLT_FNMA(t19, t56, t65); /* I3/I1*t64 - t57*t59 - t19*(t55 - t45*2*gamma3*s*Theta*1/(s*K*Theta)) */
    const double t67 = t53*p[18]; /* gamma3*s*Theta*1/(s*K*Theta)*(-2*R*I3) */
    const double t68 = t24*p[24]; /* s*Theta*1/(s*K*Theta)*(s*v_tau*R*I1 - gamma3*R*G)*(-R*I3^2/I1) */
    const double t69 = t53*t68; /* gamma3*s*Theta*1/(s*K*Theta)*t68 */
    const double t70 = t3*p[19]; /* s*(-R*I3) */
    const double t71 = JLT_FMA(t57, t70, t69); /* t57*s*(-R*I3) + gamma3*s*Theta*1/(s*K*Theta)*t68 */
    const double t72 = JLT_FMA(t25, t67, t71); /* gamma3*t19*gamma3*s*Theta*1/(s*K*Theta)*(-2*R*I3) + t57*s*(-R*I3) + gamma3*s*Theta*1/(s*K*Theta)*t68 */
    const double t73 = t19*t31; /* t19*1/(s*K*Theta)*s*K */
    const double t74 = t32*p[20]; /* V*1/(s*K*Theta)*s*K*m*I1*I3 */
    const double t75 = t73*t74; /* t19*1/(s*K*Theta)*s*K*V*1/(s*K*Theta)*s*K*m*I1*I3 */
    const double t76 = x[0]*p[0]; /* gamma3*m */
    const double t77 = JLT_FMA(t31, t76, t53); /* 1/(s*K*Theta)*s*K*gamma3*m + gamma3*s*Theta*1/(s*K*Theta) */
    const double t78 = JLT_FNMA(t37, t77, t75); /* t19*1/(s*K*Theta)*s*K*V*1/(s*K*Theta)*s*K*m*I1*I3 - omega_tau*t36*(1/(s*K*Theta)*s*K*gamma3*m + gamma3*s*Theta*1/(s*K*Theta)) */
    const double t79 = t31*t53; /* 1/(s*K*Theta)*s*K*gamma3*s*Theta*1/(s*K*Theta) */
    const double t80 = x[2]*p[14]; /* omega_tau*R*I3*(I1 - I3) */
    const double t81 = t79*t80; /* 1/(s*K*Theta)*s*K*gamma3*s*Theta*1/(s*K*Theta)*omega_tau*R*I3*(I1 - I3) */
    const double t82 = JLT_FMS(t63, t81, t37); /* (v_tau*R*I1*gamma3*K*Theta*1/(s*K*Theta) + R*G)*t81 - omega_tau*t36 */
    const double t83 = JLT_FMA(t44, t78, t82); /* gamma3*(2*R^2*I1 - 2*R^2*I3)*t78 + t82 */
    const double t84 = JLT_FMA(t33, t48, t83); /* (v_nu - I1*I3*V*1/(s*K*Theta)*s*K)*t48 + gamma3*(2*R^2*I1 - 2*R^2*I3)*t78 + t82 */
    const double t85 = JLT_FMS(p[11], t73, t19); /* I1*I3*t19*1/(s*K*Theta)*s*K - t19 */
    const double t86 = t73*p[21]; /* t19*1/(s*K*Theta)*s*K*R*I1*I3 */
    const double t87 = JLT_FNMA(x[0], t36, t86); /* t19*1/(s*K*Theta)*s*K*R*I1*I3 - gamma3*t36 */
    const double t88 = t33*p[19]; /* (v_nu - I1*I3*V*1/(s*K*Theta)*s*K)*(-R*I3) */
    const double t89 = t51*t88; /* s*Theta*1/(s*K*Theta)*gamma3*K*Theta*1/(s*K*Theta)*(v_nu - I1*I3*V*1/(s*K*Theta)*s*K)*(-R*I3) */
    const double t90 = t4*p[25]; /* omega_tau*s*(-R^2*I1*I3*(I1 - I3)) */
    const double t91 = JLT_FMA(t79, t90, t89); /* 1/(s*K*Theta)*s*K*gamma3*s*Theta*1/(s*K*Theta)*omega_tau*s*(-R^2*I1*I3*(I1 - I3)) + t89 */
    out[0] = t4;
    out[1] = t20;
    out[2] = t28;
    out[3] = t39;
    out[4] = t42;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t50;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t52;
    out[12] = t66;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t72;
    out[16] = t84;
    out[17] = t85;
    out[18] = t87;
    out[19] = t91;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = t2*p[7]; /* (1 - gamma3)*(gamma3 + 1)*R^2*I1 */
    const double t5 = x[0]*p[8]; /* gamma3*R^2*I3 */
    const double t6 = JLT_FMA(x[0], t5, t4); /* K = gamma3*gamma3*R^2*I3 + (1 - gamma3)*(gamma3 + 1)*R^2*I1 */
    const double t7 = JLT_FMA(p[0], t6, p[11]); /* Theta = m*K + I1*I3 */
    const double t8 = t6*t7; /* K*Theta */
    const double t9 = t3*t8; /* s*K*Theta */
    const double t10 = 1.0/t9; /* 1/(s*K*Theta) */
    const double t11 = t7*t10; /* Theta*1/(s*K*Theta) */
    const double t12 = t3*t11; /* s*Theta*1/(s*K*Theta) */
    const double t13 = t3*t6; /* s*K */
    const double t14 = t10*t13; /* 1/(s*K*Theta)*s*K */
    const double t15 = p[26]*t3; /* R^2*I1*I3*(I1 - I3)*s */
    const double t16 = t14*t15; /* 1/(s*K*Theta)*s*K*R^2*I1*I3*(I1 - I3)*s */
    const double t17 = t6*t11; /* K*Theta*1/(s*K*Theta) */
    const double t18 = JLT_FMA(t12, t16, t17); /* s*Theta*1/(s*K*Theta)*1/(s*K*Theta)*s*K*R^2*I1*I3*(I1 - I3)*s + K*Theta*1/(s*K*Theta) */
    const double t19 = x[2]*t18; /* omega_tau*t18 */
    const double t20 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t21 = p[11]*t20; /* I1*I3*V */
    const double t22 = JLT_FNMA(t14, t21, x[1]); /* v_nu - 1/(s*K*Theta)*s*K*I1*I3*V */
    const double t23 = t17*p[10]; /* K*Theta*1/(s*K*Theta)*R*I3 */
    const double t24 = t12*t23; /* s*Theta*1/(s*K*Theta)*K*Theta*1/(s*K*Theta)*R*I3 */
    const double t25 = JLT_FMA(t22, t24, t19); /* (v_nu - 1/(s*K*Theta)*s*K*I1*I3*V)*s*Theta*1/(s*K*Theta)*K*Theta*1/(s*K*Theta)*R*I3 + omega_tau*t18 */
    const double t26 = x[0]*t25; /* gamma3*t25 */
    const double t27 = -t26; /* -gamma3*t25 */
    out[0] = t27;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[27]*x[1]; /* 1/2*m*v_nu */
    const double t1 = x[1]*t0; /* v_nu*1/2*m*v_nu */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = p[7]*t4; /* R^2*I1*(1 - gamma3)*(1 + gamma3) */
    const double t6 = x[0]*p[8]; /* gamma3*R^2*I3 */
    const double t7 = JLT_FMA(x[0], t6, t5); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*(1 - gamma3)*(1 + gamma3) */
    const double t8 = 1.0/t7; /* 1/K */
    const double t9 = JLT_FMA(t7, p[0], p[11]); /* Theta = K*m + I1*I3 */
    const double t10 = x[3]*x[3]; /* v_tau*v_tau */
    const double t11 = JLT_FMA(t9, t10, p[28]); /* Theta*v_tau*v_tau + G^2 */
    const double t12 = (1.0 / 2.0)*t8; /* 1/2*1/K */
    const double t13 = p[29]*x[2]; /* 1/2*I1*omega_tau */
    const double t14 = JLT_FMA(x[2], t13, t1); /* omega_tau*1/2*I1*omega_tau + v_nu*1/2*m*v_nu */
    const double t15 = JLT_FMA(t11, t12, t14); /* (Theta*v_tau*v_tau + G^2)*1/2*1/K + omega_tau*1/2*I1*omega_tau + v_nu*1/2*m*v_nu */
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t17 = p[30]*t16; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t18 = t16*t17; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t19 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t20 = x[3]*p[13]; /* v_tau*R*I1 */
    const double t21 = t19*t20; /* s*v_tau*R*I1 */
    const double t22 = JLT_FNMA(x[0], p[9], t21); /* s*v_tau*R*I1 - gamma3*R*G */
    const double t23 = t8*t22; /* 1/K*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t24 = t9*p[31]; /* Theta*(I1 - I3) */
    const double t25 = t23*t24; /* 1/K*(s*v_tau*R*I1 - gamma3*R*G)*Theta*(I1 - I3) */
    const double t26 = JLT_FMA(t23, t25, t18); /* 1/K*(s*v_tau*R*I1 - gamma3*R*G)*1/K*(s*v_tau*R*I1 - gamma3*R*G)*Theta*(I1 - I3) + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[0] = t15;
    out[1] = t26;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[15]*x[0]; /* (2*R^2*I1 - 2*R^2*I3)*gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = p[7]*t3; /* R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t5 = x[0]*p[8]; /* gamma3*R^2*I3 */
    const double t6 = JLT_FMA(x[0], t5, t4); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t7 = JLT_FMA(p[0], t6, p[11]); /* Theta = m*K + I1*I3 */
    const double t8 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = t6*t8; /* K*s */
    const double t10 = 1.0/t9; /* 1/(K*s) */
    const double t11 = t8*t10; /* s*1/(K*s) */
    const double t12 = t7*t11; /* Theta*s*1/(K*s) */
    const double t13 = JLT_FNMA(p[33], t12, 1.0); /* 1 - 1/m*Theta*s*1/(K*s) */
    const double t14 = x[3]*x[3]; /* v_tau*v_tau */
    const double t15 = t13*t14; /* (1 - 1/m*Theta*s*1/(K*s))*v_tau*v_tau */
    const double t16 = JLT_FNMA(t11, p[34], t15); /* (1 - 1/m*Theta*s*1/(K*s))*v_tau*v_tau - s*1/(K*s)*G^2/m */
    const double t17 = p[32]*t0; /* (-1/2*m)*(2*R^2*I1 - 2*R^2*I3)*gamma3 */
    const double t18 = t11*t17; /* s*1/(K*s)*(-1/2*m)*(2*R^2*I1 - 2*R^2*I3)*gamma3 */
    const double t19 = t16*t18; /* ((1 - 1/m*Theta*s*1/(K*s))*v_tau*v_tau - s*1/(K*s)*G^2/m)*s*1/(K*s)*(-1/2*m)*(2*R^2*I1 - 2*R^2*I3)*gamma3 */
    const double t20 = p[0]*x[1]; /* m*v_nu */
    const double t21 = p[3]*x[2]; /* I1*omega_tau */
    const double t22 = x[3]*t12; /* v_tau*Theta*s*1/(K*s) */
    const double t23 = x[3]*p[13]; /* v_tau*R*I1 */
    const double t24 = t8*t23; /* s*v_tau*R*I1 */
    const double t25 = JLT_FNMA(x[0], p[9], t24); /* s*v_tau*R*I1 - gamma3*R*G */
    const double t26 = t11*t25; /* s*1/(K*s)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t27 = t12*p[36]; /* Theta*s*1/(K*s)*(2*I1 - 2*I3) */
    const double t28 = p[35] - t27; /* m*(I1 - I3) - Theta*s*1/(K*s)*(2*I1 - 2*I3) */
    const double t29 = t0*t26; /* (2*R^2*I1 - 2*R^2*I3)*gamma3*s*1/(K*s)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t30 = t28*t29; /* (m*(I1 - I3) - Theta*s*1/(K*s)*(2*I1 - 2*I3))*t29 */
    const double t31 = x[0]*t23; /* gamma3*v_tau*R*I1 */
    const double t32 = t6*t31; /* K*gamma3*v_tau*R*I1 */
    const double t33 = JLT_FMA(t10, t32, p[9]); /* 1/(K*s)*K*gamma3*v_tau*R*I1 + R*G */
    const double t34 = JLT_FMA(t27, t33, t30); /* Theta*s*1/(K*s)*(2*I1 - 2*I3)*(1/(K*s)*K*gamma3*v_tau*R*I1 + R*G) + (m*(I1 - I3) - Theta*s*1/(K*s)*(2*I1 - 2*I3))*t29 */
    const double t35 = t26*t34; /* s*1/(K*s)*(s*v_tau*R*I1 - gamma3*R*G)*t34 */
    const double t36 = -t35; /* -s*1/(K*s)*(s*v_tau*R*I1 - gamma3*R*G)*t34 */
    const double t37 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t38 = p[37]*t37; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    const double t39 = t37*p[38]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    const double t40 = t8*p[39]; /* s*2*R*I1*(I1 - I3) */
    const double t41 = t26*t40; /* s*1/(K*s)*(s*v_tau*R*I1 - gamma3*R*G)*s*2*R*I1*(I1 - I3) */
    const double t42 = t12*t41; /* Theta*s*1/(K*s)*s*1/(K*s)*(s*v_tau*R*I1 - gamma3*R*G)*s*2*R*I1*(I1 - I3) */
    out[0] = t19;
    out[1] = t20;
    out[2] = t21;
    out[3] = t22;
    out[4] = t36;
    out[5] = t38;
    out[6] = t39;
    out[7] = t42;
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
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
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
    double t31[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t10[k] = t5[k]*p[7];
        t12[k] = x0[k]*p[8];
        t13[k] = jlt_jet_product(x0, t12, k) + t10[k];
        t15[k] = t6[k]*p[9];
        t17[k] = x0[k]*p[10];
        t18[k] = jlt_jet_product(x3, t17, k) + t15[k];
        t21[k] = t13[k]*p[0] + (k == 0 ? p[11] : 0);
        t22[k] = jlt_jet_product(t13, t21, k);
        t23[k] = jlt_jet_product(t6, t22, k);
        t24[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t23, t24, k);
        t25[k] = jlt_jet_product(t21, t24, k);
        t26[k] = jlt_jet_product(t6, t25, k);
        t27[k] = jlt_jet_product(t18, t26, k);
        t28[k] = jlt_jet_product(t13, t25, k);
        t29[k] = jlt_jet_product(t27, t28, k);
        t30[k] = jlt_jet_product(x3, t29, k);
        t31[k] = jlt_jet_product(x0, t29, k);
        t34[k] = x3[k]*p[13];
        t35[k] = jlt_jet_product(t6, t34, k);
        t36[k] = t35[k] - x0[k]*p[9];
        t37[k] = jlt_jet_product(t26, t36, k);
        t38[k] = p[12]*t37[k] + t31[k];
        t39[k] = jlt_jet_product(t27, t38, k);
        t40[k] = -t39[k];
        t43[k] = x2[k]*p[1] + x1[k];
        t44[k] = jlt_jet_product(t6, t13, k);
        t45[k] = jlt_jet_product(t24, t44, k);
        t46[k] = p[11]*t43[k];
        t47[k] = x1[k] - jlt_jet_product(t45, t46, k);
        t48[k] = jlt_jet_product(t29, t47, k);
        t50[k] = x2[k]*p[14];
        t51[k] = jlt_jet_product(x0, t50, k);
        t52[k] = jlt_jet_product(t45, t51, k);
        t53[k] = jlt_jet_product(t37, t52, k) + t48[k];
        t54[k] = -t53[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t30[k]/(k + 1);
        next[2] = x2[k + 1] = t40[k]/(k + 1);
        next[3] = x3[k + 1] = t54[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double complex v_v_tau = x[3];
    const double v_R = params[1];
    const double v_I1 = params[3];
    const double v_I3 = params[4];
    const double v_a3 = (0.0);
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_K = (v_R*v_R*v_I1*v_s*v_s + v_I3*v_b*v_b);
    const double v_G = params[6];
    const double complex v_omega_n = ((v_R*v_G*v_s + v_I3*v_v_tau*v_b)/v_K);
    out[1] = (v_v_tau*v_omega_n/v_s);
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double complex v_omega3 = ((v_R*v_I1*v_v_tau*v_s - v_G*v_b)/v_K);
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_v_nu = x[1];
    const double complex v_Theta = (v_m*v_K + v_I1*v_I3);
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (-v_v_nu*v_omega_n/v_s)
        + (v_I1*v_I3*v_V*v_omega_n/(v_s*v_Theta))
        + (-v_I3*v_omega_tau*v_omega3*(v_R*v_gamma3*(v_I1 - v_I3) - v_I3*v_a3)/v_Theta);
}

static const unsigned char family0_is_free[] = { 1, 1, 0, 0 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
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

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = x[0]*params[4]; /* gamma3*I3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = t1*t2; /* (gamma3 + 1)*(1 - gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((gamma3 + 1)*(1 - gamma3)) */
    const double t5 = params[6]*t4; /* G*s */
    const double t6 = t5/t0; /* G*s/(gamma3*I3) */
    const double t7 = -t6; /* v_tau = -G*s/(gamma3*I3) */
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    out[3] = t7;
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[4]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I3*gamma3*v_nu */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = t4*t5; /* (1 + gamma3)*(1 - gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t8 = params[1]*params[1]; /* R*R */
    const double t9 = t8*params[3]; /* R*R*I1 */
    const double t10 = t7*t7; /* s*s */
    const double t11 = t9*t10; /* R*R*I1*s*s */
    const double t12 = params[4]*t8; /* I3*R*R */
    const double t13 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t14 = t12*t13; /* I3*R*R*gamma3*gamma3 */
    const double t15 = t11 + t14; /* K = R*R*I1*s*s + I3*R*R*gamma3*gamma3 */
    const double t16 = params[0]*t15; /* m*K */
    const double t17 = params[4]*params[3]; /* I3*I1 */
    const double t18 = t16 + t17; /* Theta = m*K + I3*I1 */
    const double t19 = t7*t18; /* s*Theta */
    const double t20 = t3/t19; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t21 = -t20; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t21;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[4]*x[0]; /* I3*gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = t1*t2; /* (1 + gamma3)*(1 - gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t5 = params[6]*t4; /* G*s */
    const double t6 = t5/t0; /* G*s/(I3*gamma3) */
    const double t7 = t6*t6; /* G*s/(I3*gamma3)*G*s/(I3*gamma3) */
    const double t8 = params[1]*params[1]; /* R*R */
    const double t9 = t8*params[3]; /* R*R*I1 */
    const double t10 = t4*t4; /* s*s */
    const double t11 = t9*t10; /* R*R*I1*s*s */
    const double t12 = params[4]*t8; /* I3*R*R */
    const double t13 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t14 = t12*t13; /* I3*R*R*gamma3*gamma3 */
    const double t15 = t11 + t14; /* K = R*R*I1*s*s + I3*R*R*gamma3*gamma3 */
    const double t16 = t15*t15; /* K*K */
    const double t17 = t15*params[0]; /* K*m */
    const double t18 = params[4]*params[3]; /* I3*I1 */
    const double t19 = t17 + t18; /* Theta = K*m + I3*I1 */
    const double t20 = t7*t19; /* G*s/(I3*gamma3)*G*s/(I3*gamma3)*Theta */
    const double t21 = x[0]*t9; /* gamma3*R*R*I1 */
    const double t22 = t21*2.0; /* gamma3*R*R*I1*2 */
    const double t23 = x[0]*t12; /* gamma3*I3*R*R */
    const double t24 = 2.0*t23; /* 2*gamma3*I3*R*R */
    const double t25 = t24 - t22; /* d(K)/d(gamma3) = 2*gamma3*I3*R*R - gamma3*R*R*I1*2 */
    const double t26 = t20*t25; /* G*s/(I3*gamma3)*G*s/(I3*gamma3)*Theta*d(K)/d(gamma3) */
    const double t27 = t26/t16; /* G*s/(I3*gamma3)*G*s/(I3*gamma3)*Theta*d(K)/d(gamma3)/(K*K) */
    const double t28 = t27*(1.0 / 2.0); /* G*s/(I3*gamma3)*G*s/(I3*gamma3)*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t29 = t7*params[0]; /* G*s/(I3*gamma3)*G*s/(I3*gamma3)*m */
    const double t30 = t25*t29; /* d(K)/d(gamma3)*G*s/(I3*gamma3)*G*s/(I3*gamma3)*m */
    const double t31 = t30/t15; /* d(K)/d(gamma3)*G*s/(I3*gamma3)*G*s/(I3*gamma3)*m/K */
    const double t32 = (1.0 / 2.0)*t31; /* 1/2*d(K)/d(gamma3)*G*s/(I3*gamma3)*G*s/(I3*gamma3)*m/K */
    const double t33 = t32 - t28; /* 1/2*d(K)/d(gamma3)*G*s/(I3*gamma3)*G*s/(I3*gamma3)*m/K - t28 */
    const double t34 = params[6]*params[6]; /* G*G */
    const double t35 = t25*t34; /* d(K)/d(gamma3)*G*G */
    const double t36 = t35/t16; /* d(K)/d(gamma3)*G*G/(K*K) */
    const double t37 = (1.0 / 2.0)*t36; /* 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t38 = t33 - t37; /* 1/2*d(K)/d(gamma3)*G*s/(I3*gamma3)*G*s/(I3*gamma3)*m/K - t28 - 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t39 = params[0]*x[1]; /* m*v_nu */
    const double t40 = t6*t19; /* G*s/(I3*gamma3)*Theta */
    const double t41 = t40/t15; /* G*s/(I3*gamma3)*Theta/K */
    const double t42 = -t41; /* -G*s/(I3*gamma3)*Theta/K */
    const double t43 = t15*t16; /* K*K*K */
    const double t44 = params[3] - params[4]; /* I1 - I3 */
    const double t45 = t19*t44; /* Theta*(I1 - I3) */
    const double t46 = t25*t45; /* d(K)/d(gamma3)*Theta*(I1 - I3) */
    const double t47 = params[1]*params[3]; /* R*I1 */
    const double t48 = t6*t47; /* G*s/(I3*gamma3)*R*I1 */
    const double t49 = t4*t48; /* s*G*s/(I3*gamma3)*R*I1 */
    const double t50 = -t49; /* -s*G*s/(I3*gamma3)*R*I1 */
    const double t51 = params[6]*params[1]; /* G*R */
    const double t52 = x[0]*t51; /* gamma3*G*R */
    const double t53 = t50 - t52; /* -s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R */
    const double t54 = t53*t53; /* (-s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R)*(-s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R) */
    const double t55 = t46*t54; /* d(K)/d(gamma3)*Theta*(I1 - I3)*t54 */
    const double t56 = t55/t43; /* d(K)/d(gamma3)*Theta*(I1 - I3)*t54/(K*K*K) */
    const double t57 = 2.0*t56; /* 2*d(K)/d(gamma3)*Theta*(I1 - I3)*t54/(K*K*K) */
    const double t58 = params[0]*t44; /* m*(I1 - I3) */
    const double t59 = t25*t58; /* d(K)/d(gamma3)*m*(I1 - I3) */
    const double t60 = t54*t59; /* t54*d(K)/d(gamma3)*m*(I1 - I3) */
    const double t61 = t60/t16; /* t54*d(K)/d(gamma3)*m*(I1 - I3)/(K*K) */
    const double t62 = t61 - t57; /* t54*d(K)/d(gamma3)*m*(I1 - I3)/(K*K) - 2*d(K)/d(gamma3)*Theta*(I1 - I3)*t54/(K*K*K) */
    const double t63 = x[0]*t47; /* gamma3*R*I1 */
    const double t64 = t6*t63; /* G*s/(I3*gamma3)*gamma3*R*I1 */
    const double t65 = t64/t4; /* G*s/(I3*gamma3)*gamma3*R*I1/s */
    const double t66 = t51 - t65; /* G*R - G*s/(I3*gamma3)*gamma3*R*I1/s */
    const double t67 = t45*t66; /* Theta*(I1 - I3)*(G*R - G*s/(I3*gamma3)*gamma3*R*I1/s) */
    const double t68 = t53*t67; /* (-s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R)*Theta*(I1 - I3)*(G*R - G*s/(I3*gamma3)*gamma3*R*I1/s) */
    const double t69 = t68/t16; /* t68/(K*K) */
    const double t70 = 2.0*t69; /* 2*t68/(K*K) */
    const double t71 = t62 - t70; /* t62 - 2*t68/(K*K) */
    const double t72 = params[0]*2.0; /* m*2 */
    const double t73 = params[3]*params[3]; /* I1*I1 */
    const double t74 = t72*t73; /* m*2*I1*I1 */
    const double t75 = x[1]*t74; /* v_nu*m*2*I1*I1 */
    const double t76 = params[1]*t72; /* R*m*2 */
    const double t77 = t73*t76; /* I1*I1*R*m*2 */
    const double t78 = x[1]*t77; /* v_nu*I1*I1*R*m*2 */
    const double t79 = params[1]*2.0; /* R*2 */
    const double t80 = params[3]*t79; /* I1*R*2 */
    const double t81 = t4*t80; /* s*I1*R*2 */
    const double t82 = t19*t81; /* Theta*s*I1*R*2 */
    const double t83 = t44*t82; /* (I1 - I3)*Theta*s*I1*R*2 */
    const double t84 = t53*t83; /* (-s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R)*(I1 - I3)*Theta*s*I1*R*2 */
    const double t85 = t84/t16; /* t84/(K*K) */
    out[0] = t38;
    out[1] = t39;
    out[2] = 0.0;
    out[3] = t42;
    out[4] = t71;
    out[5] = t75;
    out[6] = t78;
    out[7] = t85;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

static const jlt_equilibria equilibria[] = {
    { .name = "spinning", .condition = "a3 = 0",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 2, .obstructs = 1 },
};

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_level_balanced = {
    .model = "spherical_top_level",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 4, .param_count = 7, .block_count = 40,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 26, 8, 1, 1, 0, 16, 9 }, { 16, 71, 0, 6, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 4, 53, 25, 1, 1, 0, 17, 17 }, { 72, 350, 0, 41, 1, 0, 20, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 6, 56, 28, 1, 1, 0, 18, 23 }, { 84, 409, 0, 47, 1, 0, 20, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 17, 6, 1, 1, 0, 15, 7 }, { 9, 32, 0, 4, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 2, 15, 8, 1, 1, 0, 8, 8 }, { 10, 36, 0, 3, 1, 0, 14, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 8, { 4, 29, 8, 1, 1, 0, 14, 10 }, { 19, 94, 0, 9, 1, 0, 15, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_balanced_baseline,
        &jlt_batch_spherical_top_level_balanced_avx2,
        &jlt_batch_spherical_top_level_balanced_avx512,
    },
};
