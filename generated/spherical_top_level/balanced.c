/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Table:      spherical_top_level, SHA-256 5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   25    7    1    1    0     15    7   (94)
 *  jacobian            8   45   22    1    1    0     16   21   (464)
 *  rhs_jacobian        11   51   23    1    1    0     17   21   (541)
 *  divergence          3   13    5    1    1    0     12    6   (46)
 *  integral_values     3   12    7    1    1    0      8    6   (50)
 *  integral_gradients  3   27    7    1    1    0     12    9   (123)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in 2*R^2*I1 - 2*R^2*I3, gamma3*v_tau*(R*I3) + (R*G)*s,
 *      v_tau*s - gamma3*(G/I1), V = omega_tau*R + v_nu, (R*G)*gamma3*K*((1)/K*s^2*Theta/m)*Theta/m*s - v_tau*(R*I3),
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3),
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      v_tau*gamma3*K*((1)/K*s^2*Theta/m)*Theta/m*s + G/I1, a part of d(d(v_tau)/dt)/d(gamma3),
 *      v_nu - 1/(Theta/m)*(I1*I3/m)*V, d(d(v_tau)/dt)/d(omega_tau), a part of d(d(v_tau)/dt)/d(gamma3),
 *      d(d(v_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(v_tau), a part of d(d(v_tau)/dt)/d(v_tau), a part of d(v_tau)/dt,
 *      a part of d(omega_tau)/dt, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(v_tau)
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
extern const jlt_descriptor jlt_kernels_spherical_top_level_balanced;
extern const struct jlt_ball_table jlt_balls_spherical_top_level_general;
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
    out[7] = t1;
    const double t2 = t0*params[4]; /* R*R*I3 */
    out[8] = t2;
    const double t3 = params[3]*params[4]; /* I1*I3 */
    out[30] = t3;
    const double t4 = t3/params[0]; /* I1*I3/m */
    out[9] = t4;
    const double t5 = params[1]*params[6]; /* R*G */
    out[10] = t5;
    const double t6 = params[1]*params[4]; /* R*I3 */
    out[11] = t6;
    const double t7 = params[6]/params[3]; /* G/I1 */
    out[12] = t7;
    const double t8 = t1*params[4]; /* R*R*I1*I3 */
    const double t9 = params[3] - params[4]; /* I1 - I3 */
    const double t10 = t8*t9; /* R*R*I1*I3*(I1 - I3) */
    const double t11 = t10/params[0]; /* R*R*I1*I3*(I1 - I3)/m */
    out[13] = t11;
    const double t12 = t1*2.0; /* R*R*I1*2 */
    const double t13 = t2*2.0; /* R*R*I3*2 */
    const double t14 = t12 - t13; /* R*R*I1*2 - R*R*I3*2 */
    out[14] = t14;
    const double t15 = params[1]*2.0; /* R*2 */
    const double t16 = params[4]*t15; /* I3*R*2 */
    out[15] = t16;
    const double t17 = params[1]*params[3]; /* R*I1 */
    const double t18 = params[4]*t17; /* I3*R*I1 */
    const double t19 = t18/params[0]; /* I3*R*I1/m */
    out[16] = t19;
    const double t20 = params[4]*params[4]; /* I3*I3 */
    const double t21 = t0*t20; /* R*R*I3*I3 */
    out[17] = t21;
    const double t22 = params[1]*t0; /* R*R*R */
    const double t23 = params[0]*t22; /* m*R*R*R */
    const double t24 = params[3]*t23; /* I1*m*R*R*R */
    const double t25 = t20/t24; /* I3*I3/(I1*m*R*R*R) */
    out[18] = t25;
    const double t26 = params[4]/params[3]; /* I3/I1 */
    out[19] = t26;
    const double t27 = t0*params[0]; /* R*R*m */
    const double t28 = params[4]/t27; /* I3/(R*R*m) */
    out[20] = t28;
    const double t29 = params[3]*t27; /* I1*R*R*m */
    const double t30 = params[4]*t9; /* I3*(I1 - I3) */
    const double t31 = t30/t29; /* I3*(I1 - I3)/(I1*R*R*m) */
    out[21] = t31;
    const double t32 = params[4]/t17; /* I3/(R*I1) */
    out[22] = t32;
    const double t33 = params[0]/2.0; /* m/2 */
    out[23] = t33;
    const double t34 = params[6]*params[6]; /* G*G */
    out[29] = t34;
    const double t35 = t34/t29; /* G*G/(I1*R*R*m) */
    out[24] = t35;
    const double t36 = params[3]/2.0; /* I1/2 */
    out[25] = t36;
    const double t37 = params[3]*params[3]; /* I1*I1 */
    const double t38 = params[0]*t37; /* m*I1*I1 */
    out[26] = t38;
    const double t39 = params[3]*params[0]; /* I1*m */
    const double t40 = t9*t39; /* (I1 - I3)*I1*m */
    out[27] = t40;
    const double t41 = t1 - t2; /* R*R*I1 - R*R*I3 */
    out[28] = t41;
    const double t42 = params[0]*2.0; /* m*2 */
    const double t43 = t0*t42; /* R*R*m*2 */
    const double t44 = t37*t43; /* I1*I1*R*R*m*2 */
    const double t45 = t9*t44; /* (I1 - I3)*I1*I1*R*R*m*2 */
    const double t46 = t41*t45; /* (R*R*I1 - R*R*I3)*(I1 - I3)*I1*I1*R*R*m*2 */
    out[31] = t46;
    const double t47 = params[3]*2.0; /* I1*2 */
    const double t48 = params[4]*t47; /* I3*I1*2 */
    const double t49 = t48/params[0]; /* I3*I1*2/m */
    out[32] = t49;
    const double t50 = t0*2.0; /* R*R*2 */
    const double t51 = t37*t50; /* I1*I1*R*R*2 */
    const double t52 = t9*t51; /* (I1 - I3)*I1*I1*R*R*2 */
    out[33] = t52;
    const double t53 = t37*t42; /* I1*I1*m*2 */
    out[34] = t53;
    const double t54 = params[1]*t42; /* R*m*2 */
    const double t55 = t37*t54; /* I1*I1*R*m*2 */
    out[35] = t55;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = p[7]*t2; /* R^2*I1*s^2 */
    const double t4 = x[0]*p[8]; /* gamma3*R^2*I3 */
    const double t5 = JLT_FMA(x[0], t4, t3); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s^2 */
    const double t6 = p[9] + t5; /* Theta/m = I1*I3/m + K */
    const double t7 = t2*t6; /* s^2*Theta/m */
    const double t8 = t5*t7; /* K*s^2*Theta/m */
    const double t9 = 1.0/t8; /* 1/(K*s^2*Theta/m) */
    const double t10 = t7*t9; /* 1/K = s^2*Theta/m*1/(K*s^2*Theta/m) */
    const double t11 = t5*t9; /* K*1/(K*s^2*Theta/m) */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    const double t13 = t6*t12; /* Theta/m*s */
    const double t14 = t11*t13; /* K*1/(K*s^2*Theta/m)*Theta/m*s */
    const double t15 = t2*t11; /* 1/(Theta/m) = s^2*K*1/(K*s^2*Theta/m) */
    const double t16 = x[2]*t12; /* omega_tau*s */
    out[0] = t16;
    const double t17 = p[10]*t12; /* R*G*s */
    const double t18 = x[3]*t12; /* v_tau*s */
    const double t19 = JLT_FNMA(x[0], p[12], t18); /* v_tau*s - gamma3*G/I1 */
    const double t20 = t10*t19; /* 1/K*(v_tau*s - gamma3*G/I1) */
    const double t21 = x[0]*p[11]; /* gamma3*R*I3 */
    const double t22 = JLT_FMA(x[3], t21, t17); /* v_tau*gamma3*R*I3 + R*G*s */
    const double t23 = t10*t22; /* 1/K*(v_tau*gamma3*R*I3 + R*G*s) */
    const double t24 = t14*t23; /* K*1/(K*s^2*Theta/m)*Theta/m*s*1/K*(v_tau*gamma3*R*I3 + R*G*s) */
    const double t25 = x[3]*t24; /* v_tau*t24 */
    out[1] = t25;
    const double t26 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t27 = p[9]*t26; /* I1*I3/m*V */
    const double t28 = JLT_FNMA(t15, t27, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t29 = t24*t28; /* t24*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t30 = x[0]*t24; /* gamma3*t24 */
    const double t31 = JLT_FMA(p[11], t20, t30); /* R*I3*1/K*(v_tau*s - gamma3*G/I1) + gamma3*t24 */
    const double t32 = t23*t31; /* 1/K*(v_tau*gamma3*R*I3 + R*G*s)*(R*I3*1/K*(v_tau*s - gamma3*G/I1) + gamma3*t24) */
    const double t33 = -t32; /* -t32 */
    out[2] = t33;
    const double t34 = x[2]*p[13]; /* omega_tau*R^2*I1*I3*(I1 - I3)/m */
    const double t35 = x[0]*t34; /* gamma3*omega_tau*R^2*I1*I3*(I1 - I3)/m */
    const double t36 = t20*t35; /* 1/K*(v_tau*s - gamma3*G/I1)*gamma3*omega_tau*R^2*I1*I3*(I1 - I3)/m */
    const double t37 = JLT_FMA(t15, t36, t29); /* 1/(Theta/m)*t36 + t24*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t38 = -t37; /* -(1/(Theta/m)*t36 + t24*(v_nu - 1/(Theta/m)*I1*I3/m*V)) */
    out[3] = t38;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = t2*p[7]; /* s^2*R^2*I1 */
    const double t5 = x[0]*p[8]; /* gamma3*R^2*I3 */
    const double t6 = JLT_FMA(x[0], t5, t4); /* K = gamma3*gamma3*R^2*I3 + s^2*R^2*I1 */
    const double t7 = t6 + p[9]; /* Theta/m = K + I1*I3/m */
    const double t8 = t2*t6; /* s^2*K */
    const double t9 = t7*t8; /* Theta/m*s^2*K */
    const double t10 = 1.0/t9; /* 1/(Theta/m*s^2*K) */
    const double t11 = t7*t10; /* Theta/m*1/(Theta/m*s^2*K) */
    const double t12 = t3*t6; /* s*K */
    const double t13 = t11*t12; /* Theta/m*1/(Theta/m*s^2*K)*s*K */
    const double t14 = x[0]*t13; /* gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K */
    const double t15 = x[2]*t14; /* omega_tau*gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K */
    const double t16 = -t15; /* -omega_tau*gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K */
    out[0] = t16;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    const double t17 = t3*p[10]; /* s*R*G */
    const double t18 = x[3]*p[11]; /* v_tau*R*I3 */
    const double t19 = JLT_FMA(x[0], t18, t17); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t20 = t2*t11; /* 1/K = s^2*Theta/m*1/(Theta/m*s^2*K) */
    const double t21 = t19*t20; /* (gamma3*v_tau*R*I3 + s*R*G)*1/K */
    const double t22 = t13*t21; /* Theta/m*1/(Theta/m*s^2*K)*s*K*(gamma3*v_tau*R*I3 + s*R*G)*1/K */
    const double t23 = t13*t22; /* Theta/m*1/(Theta/m*s^2*K)*s*K*t22 */
    const double t24 = x[0]*t23; /* gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*t22 */
    const double t25 = JLT_FMS(t14, p[10], t18); /* gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*R*G - v_tau*R*I3 */
    const double t26 = x[0]*p[14]; /* gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t27 = t21*t26; /* (gamma3*v_tau*R*I3 + s*R*G)*1/K*gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t28 = t25 - t27; /* gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*R*G - v_tau*R*I3 - (gamma3*v_tau*R*I3 + s*R*G)*1/K*gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t29 = JLT_FNMA(t20, t28, t24); /* gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*t22 - 1/K*t28 */
    const double t30 = t13*t29; /* Theta/m*1/(Theta/m*s^2*K)*s*K*(gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*t22 - 1/K*t28) */
    const double t31 = x[3]*t30; /* v_tau*t30 */
    out[4] = t31;
    const double t32 = p[11]*t20; /* R*I3*1/K */
    const double t33 = t14*t32; /* gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*R*I3*1/K */
    const double t34 = JLT_FMA(x[3], t33, t22); /* v_tau*gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*R*I3*1/K + t22 */
    out[7] = t34;
    const double t35 = t22*t23; /* t22*Theta/m*1/(Theta/m*s^2*K)*s*K*t22 */
    const double t36 = x[0]*t20; /* gamma3*1/K */
    const double t37 = t22*t36; /* t22*gamma3*1/K */
    const double t38 = 2.0*t37; /* 2*t22*gamma3*1/K */
    const double t39 = JLT_FMA(t14, x[3], p[12]); /* gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*v_tau + G/I1 */
    const double t40 = t21*t39; /* (gamma3*v_tau*R*I3 + s*R*G)*1/K*(gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*v_tau + G/I1) */
    const double t41 = t3*x[3]; /* s*v_tau */
    const double t42 = JLT_FNMA(x[0], p[12], t41); /* s*v_tau - gamma3*G/I1 */
    const double t43 = t20*t42; /* 1/K*(s*v_tau - gamma3*G/I1) */
    const double t44 = JLT_FNMA(t27, 2.0, t25); /* gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*R*G - v_tau*R*I3 - (gamma3*v_tau*R*I3 + s*R*G)*1/K*gamma3*(2*R^2*I1 - 2*R^2*I3)*2 */
    const double t45 = JLT_FMA(t43, t44, t40); /* 1/K*(s*v_tau - gamma3*G/I1)*t44 + t40 */
    const double t46 = JLT_FMS(t28, t38, t35); /* t28*2*t22*gamma3*1/K - t22*Theta/m*1/(Theta/m*s^2*K)*s*K*t22 */
    const double t47 = JLT_FMA(t32, t45, t46); /* R*I3*1/K*(1/K*(s*v_tau - gamma3*G/I1)*t44 + t40) + t28*2*t22*gamma3*1/K - t22*Theta/m*1/(Theta/m*s^2*K)*s*K*t22 */
    out[8] = t47;
    const double t48 = x[0]*p[15]; /* gamma3*2*R*I3 */
    const double t49 = t37*t48; /* t22*gamma3*1/K*gamma3*2*R*I3 */
    const double t50 = t3*t21; /* s*(gamma3*v_tau*R*I3 + s*R*G)*1/K */
    const double t51 = t36*t42; /* gamma3*1/K*(s*v_tau - gamma3*G/I1) */
    const double t52 = JLT_FMA(p[11], t51, t50); /* R*I3*gamma3*1/K*(s*v_tau - gamma3*G/I1) + s*(gamma3*v_tau*R*I3 + s*R*G)*1/K */
    const double t53 = JLT_FMA(t32, t52, t49); /* R*I3*1/K*t52 + t22*gamma3*1/K*gamma3*2*R*I3 */
    const double t54 = -t53; /* -(R*I3*1/K*t52 + t22*gamma3*1/K*gamma3*2*R*I3) */
    out[11] = t54;
    const double t55 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t56 = t8*t10; /* 1/(Theta/m) = s^2*K*1/(Theta/m*s^2*K) */
    const double t57 = p[9]*t55; /* I1*I3/m*V */
    const double t58 = t56*t57; /* 1/(Theta/m)*I1*I3/m*V */
    const double t59 = x[1] - t58; /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t60 = t22*t56; /* t22*1/(Theta/m) */
    const double t61 = t26*t58; /* gamma3*(2*R^2*I1 - 2*R^2*I3)*1/(Theta/m)*I1*I3/m*V */
    const double t62 = t60*t61; /* t22*1/(Theta/m)*gamma3*(2*R^2*I1 - 2*R^2*I3)*1/(Theta/m)*I1*I3/m*V */
    const double t63 = JLT_FMA(t42, t56, t43); /* (s*v_tau - gamma3*G/I1)*1/(Theta/m) + 1/K*(s*v_tau - gamma3*G/I1) */
    const double t64 = JLT_FMS(t26, t63, t39); /* gamma3*(2*R^2*I1 - 2*R^2*I3)*t63 - (gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*v_tau + G/I1) */
    const double t65 = JLT_FMA(t36, t64, t43); /* gamma3*1/K*t64 + 1/K*(s*v_tau - gamma3*G/I1) */
    const double t66 = t56*p[13]; /* 1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    const double t67 = x[2]*t66; /* omega_tau*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    const double t68 = JLT_FNMA(t65, t67, t62); /* t62 - (gamma3*1/K*t64 + 1/K*(s*v_tau - gamma3*G/I1))*omega_tau*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    const double t69 = JLT_FNMA(t30, t59, t68); /* t68 - t30*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    out[12] = t69;
    const double t70 = JLT_FMS(p[9], t60, t22); /* I1*I3/m*t22*1/(Theta/m) - t22 */
    out[13] = t70;
    const double t71 = t60*p[16]; /* t22*1/(Theta/m)*R*I1*I3/m */
    const double t72 = JLT_FNMA(t51, t66, t71); /* t22*1/(Theta/m)*R*I1*I3/m - gamma3*1/K*(s*v_tau - gamma3*G/I1)*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    out[14] = t72;
    const double t73 = t33*t59; /* gamma3*Theta/m*1/(Theta/m*s^2*K)*s*K*R*I3*1/K*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t74 = t3*t36; /* s*gamma3*1/K */
    const double t75 = JLT_FMA(t67, t74, t73); /* omega_tau*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*s*gamma3*1/K + t73 */
    const double t76 = -t75; /* -t75 */
    out[15] = t76;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = p[7]*t2; /* R^2*I1*s^2 */
    const double t4 = x[0]*p[8]; /* gamma3*R^2*I3 */
    const double t5 = JLT_FMA(x[0], t4, t3); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s^2 */
    const double t6 = p[9] + t5; /* Theta/m = I1*I3/m + K */
    const double t7 = t2*t6; /* s^2*Theta/m */
    const double t8 = t5*t7; /* K*s^2*Theta/m */
    const double t9 = 1.0/t8; /* 1/(K*s^2*Theta/m) */
    const double t10 = t7*t9; /* 1/K = s^2*Theta/m*1/(K*s^2*Theta/m) */
    const double t11 = t5*t9; /* K*1/(K*s^2*Theta/m) */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t12;
    const double t13 = t6*t12; /* Theta/m*s */
    const double t14 = t11*t13; /* K*1/(K*s^2*Theta/m)*Theta/m*s */
    const double t15 = t2*t11; /* 1/(Theta/m) = s^2*K*1/(K*s^2*Theta/m) */
    const double t16 = p[10]*t12; /* R*G*s */
    const double t17 = x[3]*p[11]; /* v_tau*R*I3 */
    const double t18 = JLT_FMA(x[0], t17, t16); /* gamma3*v_tau*R*I3 + R*G*s */
    const double t19 = t10*t18; /* 1/K*(gamma3*v_tau*R*I3 + R*G*s) */
    const double t20 = t15*t18; /* 1/(Theta/m)*(gamma3*v_tau*R*I3 + R*G*s) */
    const double t21 = t14*t20; /* K*1/(K*s^2*Theta/m)*Theta/m*s*1/(Theta/m)*(gamma3*v_tau*R*I3 + R*G*s) */
    const double t22 = -t21; /* -t21 */
    out[17] = t22;
    const double t23 = x[3]*t12; /* v_tau*s */
    const double t24 = JLT_FNMA(x[0], p[12], t23); /* v_tau*s - gamma3*G/I1 */
    const double t25 = t14*t19; /* K*1/(K*s^2*Theta/m)*Theta/m*s*1/K*(gamma3*v_tau*R*I3 + R*G*s) */
    const double t26 = x[3]*t25; /* v_tau*t25 */
    out[1] = t26;
    const double t27 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t28 = p[9]*t27; /* I1*I3/m*V */
    const double t29 = t15*t28; /* 1/(Theta/m)*I1*I3/m*V */
    const double t30 = x[0]*t14; /* gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s */
    const double t31 = JLT_FMS(p[10], t30, t17); /* R*G*gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s - v_tau*R*I3 */
    const double t32 = x[0]*p[14]; /* gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t33 = t14*t25; /* K*1/(K*s^2*Theta/m)*Theta/m*s*t25 */
    const double t34 = t10*t14; /* 1/K*K*1/(K*s^2*Theta/m)*Theta/m*s */
    const double t35 = t19*t32; /* 1/K*(gamma3*v_tau*R*I3 + R*G*s)*gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t36 = t10*t24; /* 1/K*(v_tau*s - gamma3*G/I1) */
    const double t37 = p[11]*t10; /* R*I3*1/K */
    const double t38 = x[0]*t10; /* gamma3*1/K */
    const double t39 = p[13]*t15; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t40 = t30*t33; /* gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s*K*1/(K*s^2*Theta/m)*Theta/m*s*t25 */
    const double t41 = t31 - t35; /* R*G*gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s - v_tau*R*I3 - 1/K*(gamma3*v_tau*R*I3 + R*G*s)*gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t42 = JLT_FNMA(t34, t41, t40); /* t40 - 1/K*K*1/(K*s^2*Theta/m)*Theta/m*s*t41 */
    const double t43 = JLT_FNMA(2.0, t35, t31); /* R*G*gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s - v_tau*R*I3 - 2*1/K*(gamma3*v_tau*R*I3 + R*G*s)*gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t44 = x[3]*t42; /* v_tau*(t40 - 1/K*K*1/(K*s^2*Theta/m)*Theta/m*s*t41) */
    out[8] = t44;
    const double t45 = JLT_FMA(x[3], t30, p[12]); /* v_tau*gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s + G/I1 */
    const double t46 = p[17]*t36; /* R^2*I3^2*1/K*(v_tau*s - gamma3*G/I1) */
    const double t47 = t38*t46; /* gamma3*1/K*R^2*I3^2*1/K*(v_tau*s - gamma3*G/I1) */
    const double t48 = JLT_FMA(t15, t24, t36); /* 1/(Theta/m)*(v_tau*s - gamma3*G/I1) + 1/K*(v_tau*s - gamma3*G/I1) */
    const double t49 = JLT_FMS(t32, t48, t45); /* gamma3*(2*R^2*I1 - 2*R^2*I3)*t48 - (v_tau*gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s + G/I1) */
    const double t50 = t15*t25; /* 1/(Theta/m)*t25 */
    const double t51 = t29*t32; /* 1/(Theta/m)*I1*I3/m*V*gamma3*(2*R^2*I1 - 2*R^2*I3) */
    const double t52 = x[1] - t29; /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t53 = t42*t52; /* (t40 - 1/K*K*1/(K*s^2*Theta/m)*Theta/m*s*t41)*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t54 = JLT_FMS(t50, t51, t53); /* 1/(Theta/m)*t25*1/(Theta/m)*I1*I3/m*V*gamma3*(2*R^2*I1 - 2*R^2*I3) - t53 */
    const double t55 = t19*t37; /* 1/K*(gamma3*v_tau*R*I3 + R*G*s)*R*I3*1/K */
    const double t56 = t45*t55; /* (v_tau*gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s + G/I1)*1/K*(gamma3*v_tau*R*I3 + R*G*s)*R*I3*1/K */
    const double t57 = JLT_FMA(t12, t55, t47); /* s*1/K*(gamma3*v_tau*R*I3 + R*G*s)*R*I3*1/K + gamma3*1/K*R^2*I3^2*1/K*(v_tau*s - gamma3*G/I1) */
    const double t58 = x[2]*t12; /* omega_tau*s */
    out[0] = t58;
    const double t59 = t24*t55; /* (v_tau*s - gamma3*G/I1)*1/K*(gamma3*v_tau*R*I3 + R*G*s)*R*I3*1/K */
    const double t60 = t38*t39; /* gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t61 = t24*t60; /* (v_tau*s - gamma3*G/I1)*gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t62 = JLT_FMS(p[16], t50, t61); /* R*I1*I3/m*1/(Theta/m)*t25 - t61 */
    out[18] = t62;
    const double t63 = t49*t60; /* t49*gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t64 = JLT_FMA(t36, t39, t63); /* 1/K*(v_tau*s - gamma3*G/I1)*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) + t49*gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t65 = JLT_FNMA(x[2], t64, t54); /* t54 - omega_tau*t64 */
    out[16] = t65;
    const double t66 = t36*t37; /* 1/K*(v_tau*s - gamma3*G/I1)*R*I3*1/K */
    const double t67 = JLT_FMA(t43, t66, t56); /* t43*1/K*(v_tau*s - gamma3*G/I1)*R*I3*1/K + t56 */
    const double t68 = t30*t37; /* gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s*R*I3*1/K */
    const double t69 = x[2]*t30; /* omega_tau*gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s */
    const double t70 = -t69; /* -omega_tau*gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s */
    out[4] = t70;
    const double t71 = JLT_FMA(x[3], t68, t25); /* v_tau*gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s*R*I3*1/K + t25 */
    out[11] = t71;
    const double t72 = t52*t68; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*gamma3*K*1/(K*s^2*Theta/m)*Theta/m*s*R*I3*1/K */
    const double t73 = JLT_FMA(t58, t60, t72); /* omega_tau*s*gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) + t72 */
    const double t74 = -t73; /* -t73 */
    out[19] = t74;
    const double t75 = t25*t52; /* t25*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t76 = JLT_FMA(x[2], t61, t75); /* omega_tau*t61 + t25*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t77 = -t76; /* -(omega_tau*t61 + t25*(v_nu - 1/(Theta/m)*I1*I3/m*V)) */
    out[3] = t77;
    const double t78 = x[0]*t25; /* gamma3*t25 */
    const double t79 = JLT_FMA(t19, t78, t59); /* 1/K*(gamma3*v_tau*R*I3 + R*G*s)*gamma3*t25 + t59 */
    const double t80 = -t79; /* -(1/K*(gamma3*v_tau*R*I3 + R*G*s)*gamma3*t25 + t59) */
    out[2] = t80;
    const double t81 = 2.0*t38; /* 2*gamma3*1/K */
    const double t82 = JLT_FNMA(t41, t81, t33); /* K*1/(K*s^2*Theta/m)*Theta/m*s*t25 - t41*2*gamma3*1/K */
    const double t83 = JLT_FNMA(t25, t82, t67); /* t43*1/K*(v_tau*s - gamma3*G/I1)*R*I3*1/K + t56 - t25*(K*1/(K*s^2*Theta/m)*Theta/m*s*t25 - t41*2*gamma3*1/K) */
    out[12] = t83;
    const double t84 = p[15]*t38; /* 2*R*I3*gamma3*1/K */
    const double t85 = JLT_FMA(t78, t84, t57); /* gamma3*t25*2*R*I3*gamma3*1/K + t57 */
    const double t86 = -t85; /* -(gamma3*t25*2*R*I3*gamma3*1/K + t57) */
    out[15] = t86;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[19]; /* gamma3*I3/I1 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* K/(R^2*I1) = gamma3*gamma3*I3/I1 + (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = t4*t5; /* K/(R^2*I1)*s */
    const double t7 = p[21]*t2; /* I3*(I1 - I3)/(m*R^2*I1)*(1 - gamma3)*(gamma3 + 1) */
    const double t8 = p[20] + t4; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t9 = t6*t8; /* K/(R^2*I1)*s*Theta/(m*R^2*I1) */
    const double t10 = 1.0/t9; /* 1/(K/(R^2*I1)*s*Theta/(m*R^2*I1)) */
    const double t11 = t6*t10; /* 1/(Theta/(m*R^2*I1)) = K/(R^2*I1)*s*1/(K/(R^2*I1)*s*Theta/(m*R^2*I1)) */
    const double t12 = t8*t10; /* 1/(s*(K/(R^2*I1))) = Theta/(m*R^2*I1)*1/(K/(R^2*I1)*s*Theta/(m*R^2*I1)) */
    const double t13 = JLT_FMA(t7, t11, t4); /* I3*(I1 - I3)/(m*R^2*I1)*(1 - gamma3)*(gamma3 + 1)*1/(Theta/(m*R^2*I1)) + K/(R^2*I1) */
    const double t14 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t15 = p[18]*t14; /* I3^2/(m*R^3*I1)*V */
    const double t16 = t11*t15; /* 1/(Theta/(m*R^2*I1))*I3^2/(m*R^3*I1)*V */
    const double t17 = t12*t16; /* 1/(s*(K/(R^2*I1)))*1/(Theta/(m*R^2*I1))*I3^2/(m*R^3*I1)*V */
    const double t18 = x[1]*p[22]; /* v_nu*I3/(R*I1) */
    const double t19 = JLT_FNMA(t12, t18, t17); /* 1/(s*(K/(R^2*I1)))*1/(Theta/(m*R^2*I1))*I3^2/(m*R^3*I1)*V - 1/(s*(K/(R^2*I1)))*v_nu*I3/(R*I1) */
    const double t20 = x[2]*t12; /* omega_tau*1/(s*(K/(R^2*I1))) */
    const double t21 = JLT_FNMA(t13, t20, t19); /* t19 - t13*omega_tau*1/(s*(K/(R^2*I1))) */
    const double t22 = x[0]*t21; /* gamma3*(t19 - t13*omega_tau*1/(s*(K/(R^2*I1)))) */
    out[0] = t22;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* (1 - gamma3)*(1 + gamma3) */
    const double t4 = x[0]*p[19]; /* gamma3*I3/I1 */
    const double t5 = JLT_FMA(x[0], t4, t3); /* K/(R^2*I1) = gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) */
    const double t6 = 1.0/t5; /* 1/(K/(R^2*I1)) */
    const double t7 = t5 + p[20]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t8 = x[3]*x[3]; /* v_tau*v_tau */
    const double t9 = JLT_FMA(t7, t8, p[24]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t10 = JLT_FMA(t6, t9, t0); /* 1/(K/(R^2*I1))*(Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1)) + v_nu*v_nu */
    const double t11 = p[23]*t10; /* 1/2*m*t10 */
    const double t12 = p[25]*x[2]; /* 1/2*I1*omega_tau */
    const double t13 = JLT_FMA(x[2], t12, t11); /* omega_tau*1/2*I1*omega_tau + 1/2*m*t10 */
    out[0] = t13;
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t15 = p[26]*t14; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t16 = t14*t15; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t17 = sqrt(t3); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t18 = x[3]*t17; /* v_tau*s */
    const double t19 = JLT_FNMA(x[0], p[12], t18); /* v_tau*s - gamma3*G/I1 */
    const double t20 = t6*t19; /* 1/(K/(R^2*I1))*(v_tau*s - gamma3*G/I1) */
    const double t21 = t7*p[27]; /* Theta/(m*R^2*I1)*m*I1*(I1 - I3) */
    const double t22 = t20*t21; /* 1/(K/(R^2*I1))*(v_tau*s - gamma3*G/I1)*Theta/(m*R^2*I1)*m*I1*(I1 - I3) */
    const double t23 = JLT_FMA(t20, t22, t16); /* 1/(K/(R^2*I1))*(v_tau*s - gamma3*G/I1)*t22 + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t23;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = p[3]*x[2]; /* I1*omega_tau */
    out[2] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t5 = p[7]*t4; /* R^2*I1*s^2 */
    const double t6 = x[0]*p[8]; /* gamma3*R^2*I3 */
    const double t7 = JLT_FMA(x[0], t6, t5); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s^2 */
    const double t8 = t4*t7; /* s^2*K */
    const double t9 = 1.0/t8; /* 1/(s^2*K) */
    const double t10 = sqrt(t4); /* s = sqrt(s^2) */
    const double t11 = t4*t9; /* 1/K = s^2*1/(s^2*K) */
    const double t12 = p[32] + t7; /* 2*I1*I3/m + K */
    const double t13 = p[31]*t12; /* 2*m*R^2*I1^2*(I1 - I3)*(R^2*I1 - R^2*I3)*(2*I1*I3/m + K) */
    const double t14 = x[3]*t10; /* v_tau*s */
    const double t15 = p[30]*x[3]; /* I1*I3*v_tau */
    const double t16 = JLT_FMA(x[3], t15, p[29]); /* v_tau*I1*I3*v_tau + G^2 */
    const double t17 = p[28]*t16; /* (R^2*I1 - R^2*I3)*(v_tau*I1*I3*v_tau + G^2) */
    const double t18 = t11*t17; /* 1/K*(R^2*I1 - R^2*I3)*(v_tau*I1*I3*v_tau + G^2) */
    const double t19 = x[0]*t11; /* gamma3*1/K */
    const double t20 = t18*t19; /* 1/K*(R^2*I1 - R^2*I3)*(v_tau*I1*I3*v_tau + G^2)*gamma3*1/K */
    out[0] = t20;
    const double t21 = t13*t19; /* 2*m*R^2*I1^2*(I1 - I3)*(R^2*I1 - R^2*I3)*(2*I1*I3/m + K)*gamma3*1/K */
    const double t22 = JLT_FMA(p[0], t7, p[30]); /* Theta = m*K + I1*I3 */
    const double t23 = x[0]*t7; /* gamma3*K */
    const double t24 = t11*t22; /* 1/K*Theta */
    const double t25 = t14*t23; /* v_tau*s*gamma3*K */
    const double t26 = JLT_FMA(t9, t25, p[12]); /* 1/(s^2*K)*v_tau*s*gamma3*K + G/I1 */
    const double t27 = JLT_FNMA(x[0], p[12], t14); /* v_tau*s - gamma3*G/I1 */
    const double t28 = t11*t27; /* 1/K*(v_tau*s - gamma3*G/I1) */
    const double t29 = t21*t28; /* t21*1/K*(v_tau*s - gamma3*G/I1) */
    const double t30 = t10*t28; /* s*1/K*(v_tau*s - gamma3*G/I1) */
    const double t31 = x[3]*t24; /* v_tau*1/K*Theta */
    out[3] = t31;
    const double t32 = p[33]*t24; /* 2*R^2*I1^2*(I1 - I3)*1/K*Theta */
    const double t33 = JLT_FNMA(t26, t32, t29); /* t21*1/K*(v_tau*s - gamma3*G/I1) - (1/(s^2*K)*v_tau*s*gamma3*K + G/I1)*2*R^2*I1^2*(I1 - I3)*1/K*Theta */
    const double t34 = t28*t33; /* 1/K*(v_tau*s - gamma3*G/I1)*t33 */
    out[4] = t34;
    const double t35 = t30*t32; /* s*1/K*(v_tau*s - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3)*1/K*Theta */
    out[7] = t35;
    const double t36 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t37 = p[34]*t36; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[5] = t37;
    const double t38 = p[35]*t36; /* 2*m*R*I1^2*(omega_tau*R + v_nu) */
    out[6] = t38;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
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
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
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
    for (unsigned k = 0; k < order; k++) {
        t13[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t14[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t15[k] = jlt_jet_product(t13, t14, k);
        t16[k] = p[7]*t15[k];
        t17[k] = jlt_jet_root(t15[k], t17, k);
        t18[k] = jlt_jet_product(x2, t17, k);
        t19[k] = x0[k]*p[8];
        t20[k] = jlt_jet_product(x0, t19, k) + t16[k];
        t21[k] = p[10]*t17[k];
        t22[k] = x0[k]*p[11];
        t23[k] = jlt_jet_product(x3, t22, k) + t21[k];
        t24[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t20, t24, k);
        t25[k] = jlt_jet_product(t23, t24, k);
        t26[k] = (k == 0 ? p[9] : 0) + t20[k];
        t27[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t26, t27, k);
        t28[k] = jlt_jet_product(x3, t17, k);
        t29[k] = jlt_jet_quotient(t25[k], t17, t29, k);
        t30[k] = t28[k] - x0[k]*p[12];
        t31[k] = jlt_jet_product(t24, t30, k);
        t32[k] = jlt_jet_product(x3, t29, k);
        t33[k] = x2[k]*p[1] + x1[k];
        t34[k] = p[9]*t33[k];
        t35[k] = x1[k] - jlt_jet_product(t27, t34, k);
        t36[k] = jlt_jet_product(t29, t35, k);
        t37[k] = jlt_jet_product(x0, t29, k);
        t38[k] = p[11]*t31[k] + t37[k];
        t39[k] = jlt_jet_product(t25, t38, k);
        t40[k] = -t39[k];
        t41[k] = x2[k]*p[13];
        t42[k] = jlt_jet_product(x0, t41, k);
        t43[k] = jlt_jet_product(t27, t42, k);
        t44[k] = jlt_jet_product(t31, t43, k) + t36[k];
        t45[k] = -t44[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t18[k]/(k + 1);
        next[1] = x1[k + 1] = t32[k]/(k + 1);
        next[2] = x2[k + 1] = t40[k]/(k + 1);
        next[3] = x3[k + 1] = t45[k]/(k + 1);
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
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    const double t0 = x[0]*params[4]; /* gamma3*I3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = params[6]*t4; /* G*s */
    const double t6 = t5/t0; /* G*s/(gamma3*I3) */
    const double t7 = -t6; /* v_tau = -G*s/(gamma3*I3) */
    out[3] = t7;
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[4]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I3*gamma3*v_nu */
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t6 = t4*t5; /* (1 - gamma3)*(1 + gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
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
    out[2] = 0.0;
    const double t0 = params[4]*x[0]; /* I3*gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* (1 - gamma3)*(1 + gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
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
    out[0] = t38;
    const double t39 = params[0]*x[1]; /* m*v_nu */
    out[1] = t39;
    const double t40 = t6*t19; /* G*s/(I3*gamma3)*Theta */
    const double t41 = t40/t15; /* G*s/(I3*gamma3)*Theta/K */
    const double t42 = -t41; /* -G*s/(I3*gamma3)*Theta/K */
    out[3] = t42;
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
    out[4] = t71;
    const double t72 = params[0]*2.0; /* m*2 */
    const double t73 = params[3]*params[3]; /* I1*I1 */
    const double t74 = t72*t73; /* m*2*I1*I1 */
    const double t75 = x[1]*t74; /* v_nu*m*2*I1*I1 */
    out[5] = t75;
    const double t76 = params[1]*t72; /* R*m*2 */
    const double t77 = t73*t76; /* I1*I1*R*m*2 */
    const double t78 = x[1]*t77; /* v_nu*I1*I1*R*m*2 */
    out[6] = t78;
    const double t79 = params[1]*2.0; /* R*2 */
    const double t80 = params[3]*t79; /* I1*R*2 */
    const double t81 = t4*t80; /* s*I1*R*2 */
    const double t82 = t19*t81; /* Theta*s*I1*R*2 */
    const double t83 = t44*t82; /* (I1 - I3)*Theta*s*I1*R*2 */
    const double t84 = t53*t83; /* (-s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R)*(I1 - I3)*Theta*s*I1*R*2 */
    const double t85 = t84/t16; /* t84/(K*K) */
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
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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

static const signed char signs_4[] = { 1, -1, -1, 1 };
static const jlt_reversor reversors[] = {
    { signs_4, 4 },
};

const jlt_descriptor jlt_kernels_spherical_top_level_balanced = {
    .model = "spherical_top_level",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .scales = 1,
    .state_count = 4, .param_count = 7, .prepared_count = 36,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 25, 7, 1, 1, 0, 15, 7 }, { 16, 71, 0, 6, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_tau*s - gamma3*(G/I1), v_tau*gamma3*(R*I3) + (R*G)*s, V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(omega_tau)/dt, a part of d(v_tau)/dt" },
    .jacobian = { jacobian, 16, { 8, 45, 22, 1, 1, 0, 16, 21 }, { 72, 350, 0, 41, 1, 0, 20, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), gamma3*Theta/m*((1)/Theta/m*s^2*K)*s*K*(R*G) - v_tau*(R*I3), 2*R^2*I1 - 2*R^2*I3, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(v_tau), gamma3*Theta/m*((1)/Theta/m*s^2*K)*s*K*v_tau + G/I1, s*v_tau - gamma3*(G/I1), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(v_tau), a part of d(d(omega_tau)/dt)/d(v_tau), V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(v_nu), d(d(v_tau)/dt)/d(omega_tau), a part of d(d(v_tau)/dt)/d(v_tau)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 11, 51, 23, 1, 1, 0, 17, 21 }, { 84, 409, 0, 47, 1, 0, 20, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*R^2*I1 - 2*R^2*I3, gamma3*v_tau*(R*I3) + (R*G)*s, v_tau*s - gamma3*(G/I1), V = omega_tau*R + v_nu, (R*G)*gamma3*K*((1)/K*s^2*Theta/m)*Theta/m*s - v_tau*(R*I3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), v_tau*gamma3*K*((1)/K*s^2*Theta/m)*Theta/m*s + G/I1, a part of d(d(v_tau)/dt)/d(gamma3), v_nu - 1/(Theta/m)*(I1*I3/m)*V, d(d(v_tau)/dt)/d(omega_tau), a part of d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(v_tau), a part of d(d(v_tau)/dt)/d(v_tau), a part of d(v_tau)/dt, a part of d(omega_tau)/dt, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(v_tau)" },
    .divergence = { divergence, 1, { 3, 13, 5, 1, 1, 0, 12, 6 }, { 9, 32, 0, 4, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of the divergence, V = R*omega_tau + v_nu, a part of the divergence" },
    .integral_values = { integral_values, 2, { 3, 12, 7, 1, 1, 0, 8, 6 }, { 10, 36, 0, 3, 1, 0, 14, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in omega_tau*R + v_nu, v_tau*s - gamma3*(G/I1), F0" },
    .integral_gradients = { integral_gradients, 8, { 3, 27, 7, 1, 1, 0, 12, 9 }, { 19, 94, 0, 9, 1, 0, 15, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in R^2*I1 - R^2*I3, 2*m*R^2*I1^2*(I1 - I3)*(R^2*I1 - R^2*I3), ((1)/s^2*K)*v_tau*s*gamma3*K + G/I1, v_tau*s - gamma3*(G/I1), a part of d(F0)/d(gamma3), omega_tau*R + v_nu" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 2, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_level_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_level_balanced) },
#endif
};
