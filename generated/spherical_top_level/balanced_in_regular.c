/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   22    7    1    0    0     12    7   (93)
 *  jacobian            7   53   30    1    0    0     15   19   (644)
 *  rhs_jacobian        12   58   26    1    0    0     13   22   (723)
 *  divergence          2    8    4    1    0    0      9    5   (41)
 *  integral_values     1   12    7    1    0    0      7    5   (47)
 *  integral_gradients  3   26    7    1    0    0     10    8   (195)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1),
 *      s*v_tau + s*v_tau - gamma3*(G/I1), V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V,
 *      a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(v_tau),
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s),
 *      (R*G)*1/K - (2*R^2*I1)*1/K*(gamma3*v_tau*(R*I3) + s*(R*G))*s*1/K, a part of d(d(v_nu)/dtau)/d(gamma3),
 *      a part of d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(v_nu), d(d(v_tau)/dtau)/d(omega_tau),
 *      d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(v_tau), a part of d(v_tau)/dtau,
 *      d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(omega_tau)/dtau)/d(s)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
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
    const double t15 = params[6]*t1; /* G*R*I3 */
    const double t16 = t15/params[3]; /* G*R*I3/I1 */
    out[16] = t16;
    const double t17 = t2*4.0; /* R*R*4 */
    const double t18 = params[4]*t17; /* I3*R*R*4 */
    out[17] = t18;
    const double t19 = params[1]*t2; /* R*R*R */
    const double t20 = 4.0*t19; /* 4*R*R*R */
    const double t21 = params[4]*params[4]; /* I3*I3 */
    const double t22 = t20*t21; /* 4*R*R*R*I3*I3 */
    out[18] = t22;
    const double t23 = -t1; /* -R*I3 */
    out[19] = t23;
    const double t24 = params[3]*t17; /* I1*R*R*4 */
    out[20] = t24;
    const double t25 = t14*t21; /* I1*R*R*2*I3*I3 */
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
    out[34] = t44;
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
    const double t51 = t2*(-2.0); /* R*R*(-2) */
    const double t52 = params[3]*t51; /* I1*R*R*(-2) */
    const double t53 = params[6]*t52; /* G*I1*R*R*(-2) */
    const double t54 = t9*t53; /* (I1 - I3)*G*I1*R*R*(-2) */
    out[36] = t54;
    const double t55 = params[0]*(-2.0); /* m*(-2) */
    const double t56 = t2*t2; /* R*R*R*R */
    const double t57 = t55*t56; /* m*(-2)*R*R*R*R */
    const double t58 = t34*t57; /* I1*I1*m*(-2)*R*R*R*R */
    const double t59 = params[4]*t58; /* I3*I1*I1*m*(-2)*R*R*R*R */
    const double t60 = t9*t59; /* (I1 - I3)*I3*I1*I1*m*(-2)*R*R*R*R */
    out[37] = t60;
    const double t61 = params[3]*2.0; /* I1*2 */
    const double t62 = params[4]*t61; /* I3*I1*2 */
    const double t63 = t62/params[0]; /* I3*I1*2/m */
    out[38] = t63;
    const double t64 = params[0]*2.0; /* m*2 */
    const double t65 = t34*t64; /* I1*I1*m*2 */
    out[39] = t65;
    const double t66 = params[1]*t64; /* R*m*2 */
    const double t67 = t34*t66; /* I1*I1*R*m*2 */
    out[40] = t67;
    const double t68 = t9*t35; /* (I1 - I3)*R*R*2*I1*I1 */
    out[41] = t68;
    const double t69 = t56*t64; /* R*R*R*R*m*2 */
    const double t70 = params[3]*t34; /* I1*I1*I1 */
    const double t71 = t69*t70; /* R*R*R*R*m*2*I1*I1*I1 */
    const double t72 = t9*t71; /* (I1 - I3)*R*R*R*R*m*2*I1*I1*I1 */
    out[42] = t72;
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
    const double t2 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t3 = JLT_FMA(p[10], t2, t1); /* K = R^2*I3*gamma3*gamma3 + R^2*I1*s*s */
    const double t4 = p[17]*t2; /* 4*R^2*I3*gamma3*gamma3 */
    const double t5 = p[11] + t3; /* Theta/m = I1*I3/m + K */
    const double t6 = t3*t5; /* K*Theta/m */
    const double t7 = 1.0/t6; /* 1/(K*Theta/m) */
    const double t8 = t5*t7; /* 1/K = Theta/m*1/(K*Theta/m) */
    const double t9 = t3*t7; /* 1/(Theta/m) = K*1/(K*Theta/m) */
    const double t10 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t11 = x[4]*x[3]; /* s*v_tau */
    const double t12 = JLT_FNMA(x[0], p[12], t11); /* s*v_tau - gamma3*G/I1 */
    const double t13 = x[4]*x[0]; /* s*gamma3 */
    const double t14 = -t13; /* -s*gamma3 */
    out[22] = t14;
    const double t15 = x[2]*p[22]; /* omega_tau*R^2*(I1 - I3) */
    const double t16 = t13*t15; /* s*gamma3*omega_tau*R^2*(I1 - I3) */
    const double t17 = t12*t16; /* (s*v_tau - gamma3*G/I1)*s*gamma3*omega_tau*R^2*(I1 - I3) */
    const double t18 = x[0]*t10; /* gamma3*v_tau*R*I3 */
    const double t19 = x[4]*x[2]; /* s*omega_tau */
    const double t20 = 2.0*t19; /* 2*s*omega_tau */
    out[4] = t20;
    const double t21 = -t19; /* -s*omega_tau */
    out[20] = t21;
    const double t22 = JLT_FMA(x[4], p[7], t18); /* s*R*G + gamma3*v_tau*R*I3 */
    const double t23 = x[4]*t8; /* s*1/K */
    const double t24 = p[8]*t12; /* R*I3*(s*v_tau - gamma3*G/I1) */
    const double t25 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t26 = JLT_FNMA(t22, t25, t17); /* (s*v_tau - gamma3*G/I1)*s*gamma3*omega_tau*R^2*(I1 - I3) - (s*R*G + gamma3*v_tau*R*I3)*V */
    const double t27 = t9*t26; /* 1/(Theta/m)*t26 */
    const double t28 = p[11]*t25; /* I1*I3/m*V */
    const double t29 = t8*t22; /* 1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t30 = JLT_FMA(t8, t18, t29); /* 1/K*gamma3*v_tau*R*I3 + 1/K*(s*R*G + gamma3*v_tau*R*I3) */
    out[8] = t30;
    const double t31 = t9*t22; /* 1/(Theta/m)*(s*R*G + gamma3*v_tau*R*I3) */
    const double t32 = -t31; /* -1/(Theta/m)*(s*R*G + gamma3*v_tau*R*I3) */
    out[16] = t32;
    const double t33 = p[24]*t9; /* R*I1*I3/m*1/(Theta/m) */
    const double t34 = t29*t33; /* 1/K*(s*R*G + gamma3*v_tau*R*I3)*R*I1*I3/m*1/(Theta/m) */
    const double t35 = t23*t24; /* s*1/K*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t36 = x[0]*t19; /* gamma3*s*omega_tau */
    const double t37 = t7*t36; /* 1/(K*Theta/m)*gamma3*s*omega_tau */
    const double t38 = p[13]*t12; /* R^2*I1*I3*(I1 - I3)/m*(s*v_tau - gamma3*G/I1) */
    const double t39 = t7*t38; /* 1/(K*Theta/m)*R^2*I1*I3*(I1 - I3)/m*(s*v_tau - gamma3*G/I1) */
    const double t40 = JLT_FNMA(t13, t39, t34); /* 1/K*(s*R*G + gamma3*v_tau*R*I3)*R*I1*I3/m*1/(Theta/m) - s*gamma3*1/(K*Theta/m)*R^2*I1*I3*(I1 - I3)/m*(s*v_tau - gamma3*G/I1) */
    out[17] = t40;
    const double t41 = p[18]*t12; /* 4*R^3*I3^2*(s*v_tau - gamma3*G/I1) */
    const double t42 = t23*t41; /* s*1/K*4*R^3*I3^2*(s*v_tau - gamma3*G/I1) */
    const double t43 = t8*t29; /* 1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t44 = JLT_FMS(t4, t43, t29); /* 4*R^2*I3*gamma3*gamma3*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) - 1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t45 = JLT_FMA(x[0], t29, t35); /* gamma3*1/K*(s*R*G + gamma3*v_tau*R*I3) + s*1/K*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t46 = t8*t35; /* 1/K*s*1/K*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t47 = JLT_FNMA(p[20], t45, t10); /* v_tau*R*I3 - 4*R^2*I1*t45 */
    const double t48 = JLT_FMA(t8, t8, t7); /* 1/K*1/K + 1/(K*Theta/m) */
    const double t49 = t27*t48; /* 1/(Theta/m)*t26*(1/K*1/K + 1/(K*Theta/m)) */
    const double t50 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t51 = -t50; /* -omega_tau*gamma3 */
    out[24] = t51;
    const double t52 = t39*t50; /* 1/(K*Theta/m)*R^2*I1*I3*(I1 - I3)/m*(s*v_tau - gamma3*G/I1)*omega_tau*gamma3 */
    const double t53 = x[0]*t43; /* gamma3*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t54 = JLT_FMA(2.0, t53, t46); /* 2*gamma3*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) + 1/K*s*1/K*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t55 = x[4]*t43; /* s*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t56 = t47*t55; /* (v_tau*R*I3 - 4*R^2*I1*t45)*s*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t57 = JLT_FMA(t24, t43, t56); /* R*I3*(s*v_tau - gamma3*G/I1)*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) + t56 */
    const double t58 = JLT_FMA(p[7], t54, t57); /* R*G*t54 + t57 */
    const double t59 = -t58; /* -(R*G*t54 + t57) */
    out[14] = t59;
    const double t60 = x[1]*t8; /* v_nu*1/K */
    const double t61 = JLT_FNMA(t7, t28, t60); /* v_nu*1/K - 1/(K*Theta/m)*I1*I3/m*V */
    const double t62 = p[23]*t37; /* R^2*I3*G*(I1 - I3)/m*1/(K*Theta/m)*gamma3*s*omega_tau */
    const double t63 = JLT_FNMA(t19, t39, t62); /* R^2*I3*G*(I1 - I3)/m*1/(K*Theta/m)*gamma3*s*omega_tau - s*omega_tau*1/(K*Theta/m)*R^2*I1*I3*(I1 - I3)/m*(s*v_tau - gamma3*G/I1) */
    const double t64 = p[13]*t37; /* R^2*I1*I3*(I1 - I3)/m*1/(K*Theta/m)*gamma3*s*omega_tau */
    const double t65 = JLT_FNMA(t10, t61, t63); /* t63 - v_tau*R*I3*(v_nu*1/K - 1/(K*Theta/m)*I1*I3/m*V) */
    const double t66 = x[4]*p[25]; /* s*2*R^2*I1^2*I3/m */
    const double t67 = JLT_FMS(t49, t66, t52); /* 1/(Theta/m)*t26*(1/K*1/K + 1/(K*Theta/m))*s*2*R^2*I1^2*I3/m - t52 */
    const double t68 = JLT_FNMA(x[3], t64, t67); /* t67 - v_tau*R^2*I1*I3*(I1 - I3)/m*1/(K*Theta/m)*gamma3*s*omega_tau */
    const double t69 = JLT_FNMA(p[7], t61, t68); /* t68 - R*G*(v_nu*1/K - 1/(K*Theta/m)*I1*I3/m*V) */
    const double t70 = p[16]*t55; /* R*I3*G/I1*s*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t71 = JLT_FMA(t42, t53, t70); /* s*1/K*4*R^3*I3^2*(s*v_tau - gamma3*G/I1)*gamma3*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) + R*I3*G/I1*s*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t72 = JLT_FMA(t29, t44, t71); /* 1/K*(s*R*G + gamma3*v_tau*R*I3)*t44 + t71 */
    const double t73 = JLT_FNMA(t10, t54, t72); /* 1/K*(s*R*G + gamma3*v_tau*R*I3)*t44 + t71 - v_tau*R*I3*t54 */
    out[10] = t73;
    const double t74 = p[14]*t53; /* 2*R^2*I3*gamma3*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t75 = x[0]*t54; /* gamma3*t54 */
    const double t76 = JLT_FMS(t8, t10, t74); /* 1/K*v_tau*R*I3 - 2*R^2*I3*gamma3*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t77 = x[3]*t76; /* v_tau*t76 */
    out[5] = t77;
    const double t78 = JLT_FMA(x[4], t55, t75); /* s*s*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) + gamma3*t54 */
    const double t79 = p[19]*t78; /* (-R*I3)*(s*s*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) + gamma3*t54) */
    out[13] = t79;
    const double t80 = p[15]*t55; /* 2*R^2*I1*s*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t81 = JLT_FMA(x[1], t80, t69); /* v_nu*2*R^2*I1*s*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) + t68 - R*G*(v_nu*1/K - 1/(K*Theta/m)*I1*I3/m*V) */
    out[19] = t81;
    const double t82 = JLT_FMS(p[7], t8, t80); /* R*G*1/K - 2*R^2*I1*s*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) */
    const double t83 = x[3]*t82; /* v_tau*(R*G*1/K - 2*R^2*I1*s*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3)) */
    out[9] = t83;
    const double t84 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t85 = t61*t84; /* (v_nu*1/K - 1/(K*Theta/m)*I1*I3/m*V)*R*I3*gamma3 */
    const double t86 = JLT_FMA(x[4], t64, t85); /* s*R^2*I1*I3*(I1 - I3)/m*1/(K*Theta/m)*gamma3*s*omega_tau + (v_nu*1/K - 1/(K*Theta/m)*I1*I3/m*V)*R*I3*gamma3 */
    const double t87 = -t86; /* -t86 */
    out[18] = t87;
    const double t88 = x[0]*p[21]; /* gamma3*2*R^2*I1*I3^2/m */
    const double t89 = JLT_FMA(t49, t88, t65); /* 1/(Theta/m)*t26*(1/K*1/K + 1/(K*Theta/m))*gamma3*2*R^2*I1*I3^2/m + t63 - v_tau*R*I3*(v_nu*1/K - 1/(K*Theta/m)*I1*I3/m*V) */
    const double t90 = JLT_FMA(x[1], t74, t89); /* v_nu*2*R^2*I3*gamma3*1/K*1/K*(s*R*G + gamma3*v_tau*R*I3) + t89 */
    out[15] = t90;
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
    const double t16 = t8*t15; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t18 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t19 = -t18; /* -omega_tau*gamma3 */
    out[29] = t19;
    const double t20 = t8*t12; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t21 = t12*t17; /* (gamma3*v_tau*R*I3 + s*R*G)*V */
    const double t22 = p[11]*t17; /* I1*I3/m*V */
    const double t23 = JLT_FNMA(t9, t22, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t24 = x[3]*t20; /* v_tau*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[1] = t24;
    const double t25 = x[4]*t8; /* s*1/K */
    const double t26 = p[8]*t14; /* R*I3*(s*v_tau - gamma3*G/I1) */
    const double t27 = t25*t26; /* s*1/K*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t28 = x[4]*t18; /* s*omega_tau*gamma3 */
    const double t29 = -t28; /* -s*omega_tau*gamma3 */
    out[4] = t29;
    const double t30 = p[22]*t14; /* R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t31 = JLT_FNMA(t28, t30, t21); /* (gamma3*v_tau*R*I3 + s*R*G)*V - s*omega_tau*gamma3*R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t32 = p[13]*t18; /* R^2*I1*I3*(I1 - I3)/m*omega_tau*gamma3 */
    const double t33 = t9*t32; /* 1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*omega_tau*gamma3 */
    const double t34 = t16*t33; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1)*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*omega_tau*gamma3 */
    const double t35 = x[0]*t20; /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t36 = t9*t25; /* 1/(Theta/m)*s*1/K */
    const double t37 = t20*t25; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t38 = t8*t11; /* 1/K*v_tau*R*I3 */
    const double t39 = p[14]*t20; /* 2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t40 = x[0]*t8; /* gamma3*1/K */
    const double t41 = JLT_FMA(t11, t40, t20); /* v_tau*R*I3*gamma3*1/K + 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[13] = t41;
    const double t42 = t8 + t9; /* 1/K + 1/(Theta/m) */
    const double t43 = t31*t42; /* t31*(1/K + 1/(Theta/m)) */
    const double t44 = p[7]*t8; /* R*G*1/K */
    const double t45 = t27 + t35; /* s*1/K*R*I3*(s*v_tau - gamma3*G/I1) + gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t46 = JLT_FMA(2.0, t35, t27); /* 2*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + s*1/K*R*I3*(s*v_tau - gamma3*G/I1) */
    const double t47 = p[13]*t36; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*s*1/K */
    const double t48 = t14*t47; /* (s*v_tau - gamma3*G/I1)*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*s*1/K */
    const double t49 = p[15]*t37; /* 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t50 = JLT_FMS(x[1], t49, t34); /* v_nu*2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t34 */
    const double t51 = t44 - t49; /* R*G*1/K - 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t52 = x[3]*t51; /* v_tau*(R*G*1/K - 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[14] = t52;
    const double t53 = JLT_FNMA(t23, t44, t50); /* v_nu*2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t34 - (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t54 = t20*t20; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t55 = JLT_FMS(p[16], t37, t54); /* R*I3*G/I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t54 */
    const double t56 = p[8]*t20; /* R*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t57 = t16*t56; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1)*R*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t58 = t23*t38; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*v_tau*R*I3 */
    const double t59 = x[1]*t39; /* v_nu*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t60 = JLT_FNMA(t39, t40, t38); /* 1/K*v_tau*R*I3 - 2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t61 = x[3]*t60; /* v_tau*t60 */
    out[10] = t61;
    const double t62 = p[21]*t9; /* 2*R^2*I1*I3^2/m*1/(Theta/m) */
    const double t63 = JLT_FNMA(t43, t62, t59); /* v_nu*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G) - t31*(1/K + 1/(Theta/m))*2*R^2*I1*I3^2/m*1/(Theta/m) */
    const double t64 = t9*t20; /* 1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t65 = JLT_FMS(p[11], t64, t20); /* I1*I3/m*1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) - 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[21] = t65;
    const double t66 = p[24]*t64; /* R*I1*I3/m*1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t67 = JLT_FNMA(x[0], t48, t66); /* R*I1*I3/m*1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) - gamma3*t48 */
    out[22] = t67;
    const double t68 = p[23]*t18; /* R^2*I3*G*(I1 - I3)/m*omega_tau*gamma3 */
    const double t69 = JLT_FMS(t36, t68, t58); /* 1/(Theta/m)*s*1/K*R^2*I3*G*(I1 - I3)/m*omega_tau*gamma3 - (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*v_tau*R*I3 */
    const double t70 = JLT_FMA(t40, t63, t69); /* gamma3*1/K*t63 + t69 */
    const double t71 = JLT_FNMA(x[2], t48, t70); /* gamma3*1/K*t63 + t69 - omega_tau*t48 */
    out[20] = t71;
    const double t72 = p[25]*t36; /* 2*R^2*I1^2*I3/m*1/(Theta/m)*s*1/K */
    const double t73 = JLT_FNMA(t43, t72, t53); /* t53 - t31*(1/K + 1/(Theta/m))*2*R^2*I1^2*I3/m*1/(Theta/m)*s*1/K */
    out[24] = t73;
    const double t74 = p[8]*t40; /* R*I3*gamma3*1/K */
    const double t75 = t23*t74; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t76 = JLT_FMA(t28, t47, t75); /* s*omega_tau*gamma3*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*s*1/K + (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t77 = -t76; /* -t76 */
    out[23] = t77;
    const double t78 = t20*t23; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t79 = JLT_FMA(t18, t48, t78); /* omega_tau*gamma3*t48 + t78 */
    const double t80 = -t79; /* -(omega_tau*gamma3*t48 + t78) */
    out[3] = t80;
    const double t81 = t20*t45; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*t45 */
    const double t82 = -t81; /* -1/K*(gamma3*v_tau*R*I3 + s*R*G)*t45 */
    out[2] = t82;
    const double t83 = p[17]*t40; /* 4*R^2*I3*gamma3*1/K */
    const double t84 = JLT_FMA(t81, t83, t55); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*t45*4*R^2*I3*gamma3*1/K + R*I3*G/I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t54 */
    const double t85 = JLT_FNMA(t38, t46, t84); /* t84 - 1/K*v_tau*R*I3*t46 */
    out[15] = t85;
    const double t86 = x[4]*t37; /* s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t87 = JLT_FMA(t40, t46, t86); /* gamma3*1/K*t46 + s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t88 = p[19]*t87; /* (-R*I3)*(gamma3*1/K*t46 + s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[18] = t88;
    const double t89 = p[20]*t37; /* 4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t90 = JLT_FMS(t45, t89, t57); /* t45*4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t57 */
    const double t91 = JLT_FNMA(t44, t46, t90); /* t45*4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t57 - R*G*1/K*t46 */
    out[19] = t91;
    const double t92 = x[2]*x[4]; /* omega_tau*s */
    const double t93 = 2.0*t92; /* 2*omega_tau*s */
    out[9] = t93;
    const double t94 = -t92; /* -omega_tau*s */
    out[25] = t94;
    const double t95 = x[4]*x[0]; /* s*gamma3 */
    const double t96 = -t95; /* -s*gamma3 */
    out[27] = t96;
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
    const double t0 = p[35]*x[3]; /* I1*I3*v_tau */
    const double t1 = JLT_FMA(x[3], t0, p[34]); /* v_tau*I1*I3*v_tau + G^2 */
    const double t2 = x[4]*p[9]; /* s*R^2*I1 */
    const double t3 = x[4]*t2; /* s*s*R^2*I1 */
    const double t4 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t5 = JLT_FMA(x[0], t4, t3); /* K = gamma3*gamma3*R^2*I3 + s*s*R^2*I1 */
    const double t6 = 1.0/t5; /* 1/K */
    const double t7 = t6*t6; /* 1/K*1/K */
    const double t8 = t1*t7; /* (v_tau*I1*I3*v_tau + G^2)*1/K*1/K */
    const double t9 = t4*t8; /* gamma3*R^2*I3*(v_tau*I1*I3*v_tau + G^2)*1/K*1/K */
    const double t10 = -t9; /* -gamma3*R^2*I3*(v_tau*I1*I3*v_tau + G^2)*1/K*1/K */
    out[0] = t10;
    const double t11 = p[0]*x[1]; /* m*v_nu */
    out[1] = t11;
    const double t12 = p[3]*x[2]; /* I1*omega_tau */
    out[2] = t12;
    const double t13 = JLT_FMA(t5, p[0], p[35]); /* Theta = K*m + I1*I3 */
    const double t14 = x[3]*t13; /* v_tau*Theta */
    const double t15 = t6*t14; /* 1/K*v_tau*Theta */
    out[3] = t15;
    const double t16 = t2*t8; /* s*R^2*I1*(v_tau*I1*I3*v_tau + G^2)*1/K*1/K */
    const double t17 = -t16; /* -s*R^2*I1*(v_tau*I1*I3*v_tau + G^2)*1/K*1/K */
    out[4] = t17;
    const double t18 = x[3]*x[4]; /* v_tau*s */
    const double t19 = JLT_FNMA(x[0], p[12], t18); /* v_tau*s - gamma3*G/I1 */
    const double t20 = t7*t19; /* 1/K*1/K*(v_tau*s - gamma3*G/I1) */
    const double t21 = t13*t20; /* Theta*1/K*1/K*(v_tau*s - gamma3*G/I1) */
    const double t22 = p[36]*t21; /* (-2*R^2*I1*G*(I1 - I3))*Theta*1/K*1/K*(v_tau*s - gamma3*G/I1) */
    const double t23 = t5 + p[38]; /* K + 2*I1*I3/m */
    const double t24 = t19*t23; /* (v_tau*s - gamma3*G/I1)*(K + 2*I1*I3/m) */
    const double t25 = t6*t24; /* 1/K*(v_tau*s - gamma3*G/I1)*(K + 2*I1*I3/m) */
    const double t26 = t20*t25; /* 1/K*1/K*(v_tau*s - gamma3*G/I1)*1/K*(v_tau*s - gamma3*G/I1)*(K + 2*I1*I3/m) */
    const double t27 = x[0]*p[37]; /* gamma3*(-2*m*R^4*I1^2*I3*(I1 - I3)) */
    const double t28 = JLT_FMA(t26, t27, t22); /* t26*gamma3*(-2*m*R^4*I1^2*I3*(I1 - I3)) + t22 */
    out[5] = t28;
    const double t29 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t30 = p[39]*t29; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[6] = t30;
    const double t31 = t29*p[40]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[7] = t31;
    const double t32 = t21*p[41]; /* Theta*1/K*1/K*(v_tau*s - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t33 = x[4]*t32; /* s*Theta*1/K*1/K*(v_tau*s - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    out[8] = t33;
    const double t34 = x[3]*t32; /* v_tau*Theta*1/K*1/K*(v_tau*s - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t35 = x[4]*p[42]; /* s*2*m*R^4*I1^3*(I1 - I3) */
    const double t36 = JLT_FNMA(t26, t35, t34); /* t34 - t26*s*2*m*R^4*I1^3*(I1 - I3) */
    out[9] = t36;
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
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 43,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 22, 7, 1, 0, 0, 12, 7 }, { 16, 71, 0, 6, 0, 0, 10, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1), a part of d(omega_tau)/dtau, V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(v_tau)/dtau" },
    .jacobian = { jacobian, 25, { 7, 53, 30, 1, 0, 0, 15, 19 }, { 91, 507, 0, 46, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in s*v_tau - gamma3*(G/I1), s*(R*G) + gamma3*v_tau*(R*I3), V = omega_tau*R + v_nu, a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(omega_tau), a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), v_nu*1/K - ((1)/K*Theta/m)*(I1*I3/m)*V, d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(v_nu)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(s), (R*G)*1/K - (2*R^2*I1)*s*1/K*1/K*(s*(R*G) + gamma3*v_tau*(R*I3)), a part of d(d(v_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 12, 58, 26, 1, 0, 0, 13, 22 }, { 104, 567, 0, 52, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in gamma3*v_tau*(R*I3) + s*(R*G), s*v_tau - gamma3*(G/I1), s*v_tau + s*v_tau - gamma3*(G/I1), V = omega_tau*R + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(v_tau), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), (R*G)*1/K - (2*R^2*I1)*1/K*(gamma3*v_tau*(R*I3) + s*(R*G))*s*1/K, a part of d(d(v_nu)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(v_nu), d(d(v_tau)/dtau)/d(omega_tau), d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(v_tau), a part of d(v_tau)/dtau, d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(omega_tau)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 2, 8, 4, 1, 0, 0, 9, 5 }, { 8, 30, 0, 3, 0, 0, 10, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in V = R*omega_tau + v_nu, (I1*I3/m)*V - s*s*omega_tau*(R*I1*(I1 - I3)/m) - v_nu*Theta/m, a part of the divergence" },
    .integral_values = { integral_values, 2, { 1, 12, 7, 1, 0, 0, 7, 5 }, { 9, 35, 0, 3, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in omega_tau*R + v_nu, s*v_tau - gamma3*(G/I1), F0" },
    .integral_gradients = { integral_gradients, 10, { 3, 26, 7, 1, 0, 0, 10, 8 }, { 26, 155, 0, 14, 0, 0, 13, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in v_tau*s - gamma3*(G/I1), d(F0)/d(gamma3), omega_tau*R + v_nu, d(F0)/d(s)" },
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
