/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23   13    1    0    0      7   10   (105)
 *  jacobian            12   67   30    1    0    0     13   20   (480)
 *  rhs_jacobian        14   69   34    1    0    0     12   24   (563)
 *  divergence          0    8    9    1    0    0      9    7   (53)
 *  integral_values     0   12    9    0    0    0      7    5   (40)
 *  integral_gradients  0   15    7    0    0    0      5    5   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  observe_values      1    7    4    1    0    0      8    5   (35)
 *  valid_values        1    7    4    1    0    0      8    5   (35)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, V = omega_tau*e + v_nu,
 *      omega_n*omega_n - s*omega_tau*(m*a3^2/I1)*s*omega_tau,
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), (m*R*I3)*e + I3^2,
 *      numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*((m*R*I3)*e + I3^2) - V*(m*I3)*omega_n*b,
 *      d(numerator of d(omega_n)/dt over Theta)/d(gamma3), a part of d(d(omega_n)/dtau)/d(gamma3),
 *      d(d(omega_n)/dtau)/d(gamma3), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)),
 *      a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s),
 *      d(numerator of d(omega3)/dt over Theta)/d(gamma3) = (m*R^2*(I1 - I3))*s*omega_tau*s*omega3 - s*omega_tau*omega_n*(m*R*a3*I1),
 *      a part of d(d(omega3)/dtau)/d(gamma3),
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*((m*R*I3)*e + I3^2) - e*(m*I3)*omega_n*b,
 *      d(d(omega_n)/dtau)/d(omega_tau), I3*s*omega3 + (2*I1)*omega_n*gamma3, a part of d(d(omega3)/dtau)/d(omega_tau),
 *      d(numerator of d(omega3)/dt over Theta)/d(s), d(d(omega3)/dtau)/d(s),
 *      d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s), d(d(omega_n)/dtau)/d(s),
 *      d(d(v_nu)/dtau)/d(omega_n), d(v_nu)/dtau, d(d(omega_n)/dtau)/d(omega_n), d(omega_n)/dtau
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_claim jlt_claims_spherical_top[];
extern const jlt_descriptor *const jlt_family_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_avx512;

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
    const double t2 = params[5]/t1; /* I3/(m*R*R) */
    out[6] = t2;
    const double t3 = t0*params[4]; /* R*R*I1 */
    const double t4 = params[5]/t3; /* I3/(R*R*I1) */
    out[7] = t4;
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[38] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[8] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[9] = t8;
    const double t9 = params[0]*params[2]; /* m*g */
    const double t10 = params[3]*t9; /* a3*m*g */
    out[34] = t10;
    const double t11 = t10/params[4]; /* a3*m*g/I1 */
    out[10] = t11;
    const double t12 = params[1]*params[4]; /* R*I1 */
    out[58] = t12;
    const double t13 = params[5]/t12; /* I3/(R*I1) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[59] = t14;
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[12] = t15;
    const double t16 = (-1.0)/params[1]; /* (-1)/R */
    out[13] = t16;
    const double t17 = params[5]*params[3]; /* I3*a3 */
    const double t18 = t17/params[4]; /* I3*a3/I1 */
    out[14] = t18;
    const double t19 = params[4] - params[5]; /* I1 - I3 */
    const double t20 = params[1]*t19; /* R*(I1 - I3) */
    const double t21 = t20/params[4]; /* R*(I1 - I3)/I1 */
    out[15] = t21;
    const double t22 = params[1]*2.0; /* R*2 */
    out[16] = t22;
    const double t23 = params[3]/params[1]; /* a3/R */
    out[17] = t23;
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t5*t24; /* a3*a3*m*2 */
    out[44] = t25;
    const double t26 = t25/params[4]; /* a3*a3*m*2/I1 */
    out[18] = t26;
    const double t27 = params[2]*t24; /* g*m*2 */
    const double t28 = params[3]*t27; /* a3*g*m*2 */
    out[46] = t28;
    const double t29 = t28/params[4]; /* a3*g*m*2/I1 */
    out[19] = t29;
    const double t30 = params[4]*params[4]; /* I1*I1 */
    const double t31 = params[5]*t25; /* I3*a3*a3*m*2 */
    const double t32 = t31/t30; /* I3*a3*a3*m*2/(I1*I1) */
    out[20] = t32;
    const double t33 = t17/t12; /* I3*a3/(R*I1) */
    out[21] = t33;
    const double t34 = params[1]*t30; /* R*I1*I1 */
    const double t35 = params[5]*params[5]; /* I3*I3 */
    out[39] = t35;
    const double t36 = 2.0*t35; /* 2*I3*I3 */
    const double t37 = t36/t34; /* 2*I3*I3/(R*I1*I1) */
    out[22] = t37;
    const double t38 = t1*t30; /* m*R*R*I1*I1 */
    const double t39 = params[5]*t35; /* I3*I3*I3 */
    const double t40 = 2.0*t39; /* 2*I3*I3*I3 */
    const double t41 = t40/t38; /* 2*I3*I3*I3/(m*R*R*I1*I1) */
    out[23] = t41;
    const double t42 = -params[5]; /* -I3 */
    out[61] = t42;
    const double t43 = -t13; /* -I3/(R*I1) */
    out[24] = t43;
    const double t44 = t1*params[4]; /* m*R*R*I1 */
    out[36] = t44;
    const double t45 = t35/t44; /* I3*I3/(m*R*R*I1) */
    out[25] = t45;
    const double t46 = params[5]*2.0; /* I3*2 */
    const double t47 = t46/t12; /* I3*2/(R*I1) */
    out[26] = t47;
    const double t48 = t36/t44; /* 2*I3*I3/(m*R*R*I1) */
    out[27] = t48;
    const double t49 = t19/params[4]; /* (I1 - I3)/I1 */
    out[28] = t49;
    const double t50 = params[3]*2.0; /* a3*2 */
    const double t51 = t35*t50; /* I3*I3*a3*2 */
    const double t52 = t51/t34; /* I3*I3*a3*2/(R*I1*I1) */
    out[29] = t52;
    const double t53 = t19*t46; /* (I1 - I3)*I3*2 */
    const double t54 = t53/t30; /* (I1 - I3)*I3*2/(I1*I1) */
    out[30] = t54;
    const double t55 = 1.0/params[1]; /* 1/R */
    out[31] = t55;
    const double t56 = params[4]/t1; /* I1/(m*R*R) */
    out[32] = t56;
    const double t57 = 2.0/params[1]; /* 2/R */
    out[33] = t57;
    const double t58 = params[5]*params[4]; /* I3*I1 */
    out[35] = t58;
    const double t59 = params[0]*params[5]; /* m*I3 */
    out[37] = t59;
    const double t60 = params[5]*t14; /* I3*m*R */
    out[40] = t60;
    const double t61 = params[4]*t14; /* I1*m*R */
    out[41] = t61;
    const double t62 = params[3]*t14; /* a3*m*R */
    const double t63 = params[5]*t62; /* I3*a3*m*R */
    out[42] = t63;
    const double t64 = t1*t19; /* m*R*R*(I1 - I3) */
    out[43] = t64;
    const double t65 = params[4]*2.0; /* I1*2 */
    out[45] = t65;
    const double t66 = params[0]*params[3]; /* m*a3 */
    const double t67 = params[5]*t66; /* I3*m*a3 */
    out[47] = t67;
    const double t68 = params[1]*t24; /* R*m*2 */
    const double t69 = params[5]*t68; /* I3*R*m*2 */
    out[48] = t69;
    const double t70 = t0*t24; /* R*R*m*2 */
    const double t71 = params[4]*t70; /* I1*R*R*m*2 */
    out[49] = t71;
    const double t72 = params[4]*t62; /* I1*a3*m*R */
    out[50] = t72;
    const double t73 = t19*t70; /* (I1 - I3)*R*R*m*2 */
    out[51] = t73;
    const double t74 = params[3]*t68; /* a3*R*m*2 */
    const double t75 = params[5]*t74; /* I3*a3*R*m*2 */
    out[52] = t75;
    const double t76 = params[0]/2.0; /* m/2 */
    out[53] = t76;
    const double t77 = params[2]*2.0; /* g*2 */
    const double t78 = params[3]*t77; /* a3*g*2 */
    out[54] = t78;
    const double t79 = 1.0/params[0]; /* 1/m */
    out[55] = t79;
    const double t80 = params[4]/params[0]; /* I1/m */
    out[56] = t80;
    const double t81 = params[5]/params[0]; /* I3/m */
    out[57] = t81;
    const double t82 = params[1]*params[5]; /* R*I3 */
    const double t83 = -t82; /* -R*I3 */
    out[60] = t83;
    const double t84 = params[4]*params[3]; /* I1*a3 */
    out[62] = t84;
    const double t85 = -t61; /* -I1*m*R */
    out[63] = t85;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t1;
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[5]*x[4]; /* s*omega3 */
    const double t5 = JLT_FMA(p[1], t4, t3); /* R*s*omega3 + omega_n*b */
    const double t6 = x[3]*t5; /* omega_n*(R*s*omega3 + omega_n*b) */
    out[1] = t6;
    const double t7 = t2*p[7]; /* b*I3/(R^2*I1) */
    const double t8 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t9 = JLT_FMA(t2, t7, t8); /* Theta/(m*R^2*I1) = b*b*I3/(R^2*I1) + s*s + I3/(m*R^2) */
    const double t10 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t11 = p[8]*t10; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t12 = t1*t11; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t13 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t14 = JLT_FMA(t4, p[9], t13); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t15 = JLT_FNMA(t0, p[10], t12); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - s*s*m*g*a3/I1 */
    const double t16 = JLT_FNMA(x[3], t14, t15); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - s*s*m*g*a3/I1 - omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t17 = JLT_FMA(t0, p[8], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t18 = t9*t17; /* Theta/(m*R^2*I1)*D/I1 */
    const double t19 = 1.0/t18; /* 1/(Theta/(m*R^2*I1)*D/I1) */
    const double t20 = t9*t16; /* Theta/(m*R^2*I1)*t16 */
    const double t21 = t19*t20; /* 1/(Theta/(m*R^2*I1)*D/I1)*Theta/(m*R^2*I1)*t16 */
    out[2] = t21;
    const double t22 = x[3]*t10; /* omega_n*omega_tau*gamma3 */
    const double t23 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t24 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t25 = x[3]*t24; /* omega_n*V */
    const double t26 = t7*t25; /* b*I3/(R^2*I1)*omega_n*V */
    const double t27 = t23 + p[12]; /* e + I3/(m*R) */
    const double t28 = x[2]*t4; /* omega_tau*s*omega3 */
    const double t29 = p[11]*t28; /* I3/(R*I1)*omega_tau*s*omega3 */
    const double t30 = JLT_FNMA(t27, t29, t26); /* b*I3/(R^2*I1)*omega_n*V - (e + I3/(m*R))*I3/(R*I1)*omega_tau*s*omega3 */
    const double t31 = t17*t19; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t32 = JLT_FNMA(t30, t31, t22); /* omega_n*omega_tau*gamma3 - t30*1/(Theta/(m*R^2*I1)) */
    out[3] = t32;
    const double t33 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/I1 - gamma3*R*(I1 - I3)/I1 */
    const double t34 = JLT_FMA(t28, t33, t25); /* omega_tau*s*omega3*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) + omega_n*V */
    const double t35 = x[5]*p[13]; /* s*(-1/R) */
    const double t36 = t34*t35; /* t34*s*(-1/R) */
    const double t37 = t31*t36; /* 1/(Theta/(m*R^2*I1))*t34*s*(-1/R) */
    out[4] = t37;
    const double t38 = x[5]*t10; /* s*omega_tau*gamma3 */
    const double t39 = -t38; /* -s*omega_tau*gamma3 */
    out[5] = t39;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[13] = 0.0;
    out[31] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    const double t0 = x[5]*x[5]; /* s*s */
    out[2] = t0;
    const double t1 = x[5]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[5] = t2;
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    out[6] = t4;
    const double t5 = p[17] + x[0]; /* b/R = a3/R + gamma3 */
    const double t6 = x[3]*p[16]; /* omega_n*2*R */
    const double t7 = t5*t6; /* b/R*omega_n*2*R */
    const double t8 = x[5]*p[1]; /* s*R */
    const double t9 = JLT_FMA(x[4], t8, t7); /* omega3*s*R + b/R*omega_n*2*R */
    out[9] = t9;
    const double t10 = x[3]*t8; /* omega_n*s*R */
    out[10] = t10;
    const double t11 = x[3]*x[4]; /* omega_n*omega3 */
    const double t12 = p[1]*t11; /* R*omega_n*omega3 */
    out[11] = t12;
    const double t13 = t5*t5; /* b/R*b/R */
    const double t14 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t15 = JLT_FMA(p[9], t13, t14); /* Theta/(m*R^2*I1) = I3/I1*b/R*b/R + s*s + I3/(m*R^2) */
    const double t16 = JLT_FMA(t0, p[8], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t17 = t15*t16; /* Theta/(m*R^2*I1)*D/I1 */
    const double t18 = 1.0/t17; /* 1/(Theta/(m*R^2*I1)*D/I1) */
    const double t19 = t15*t18; /* 1/(D/I1) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t20 = x[5]*t19; /* s*1/(D/I1) */
    const double t21 = t1*t20; /* s*omega_tau*s*1/(D/I1) */
    const double t22 = x[2]*p[8]; /* omega_tau*m*a3^2/I1 */
    const double t23 = t21*t22; /* s*omega_tau*s*1/(D/I1)*omega_tau*m*a3^2/I1 */
    const double t24 = JLT_FNMA(t3, t19, t23); /* s*omega_tau*s*1/(D/I1)*omega_tau*m*a3^2/I1 - omega_n*omega_n*1/(D/I1) */
    out[12] = t24;
    const double t25 = x[0]*p[18]; /* gamma3*2*m*a3^2/I1 */
    const double t26 = t21*t25; /* s*omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[14] = t26;
    const double t27 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t28 = 2.0*t27; /* 2*omega_n*gamma3 */
    const double t29 = t19*t28; /* 1/(D/I1)*2*omega_n*gamma3 */
    const double t30 = p[9]*t20; /* I3/I1*s*1/(D/I1) */
    const double t31 = JLT_FMA(x[4], t30, t29); /* omega3*I3/I1*s*1/(D/I1) + 1/(D/I1)*2*omega_n*gamma3 */
    const double t32 = -t31; /* -(omega3*I3/I1*s*1/(D/I1) + 1/(D/I1)*2*omega_n*gamma3) */
    out[15] = t32;
    const double t33 = x[3]*t30; /* omega_n*I3/I1*s*1/(D/I1) */
    const double t34 = -t33; /* -omega_n*I3/I1*s*1/(D/I1) */
    out[16] = t34;
    const double t35 = JLT_FMA(x[2], x[2], t3); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t36 = JLT_FNMA(t25, t35, p[19]); /* 2*m*g*a3/I1 - gamma3*2*m*a3^2/I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t37 = t20*t36; /* s*1/(D/I1)*t36 */
    const double t38 = JLT_FMA(t11, p[9], t37); /* omega_n*omega3*I3/I1 + s*1/(D/I1)*t36 */
    const double t39 = t19*t38; /* 1/(D/I1)*(omega_n*omega3*I3/I1 + s*1/(D/I1)*t36) */
    const double t40 = t11*p[20]; /* omega_n*omega3*2*m*a3^2*I3/I1^2 */
    const double t41 = t20*t40; /* s*1/(D/I1)*omega_n*omega3*2*m*a3^2*I3/I1^2 */
    const double t42 = JLT_FMS(t20, t41, t39); /* s*1/(D/I1)*s*1/(D/I1)*omega_n*omega3*2*m*a3^2*I3/I1^2 - 1/(D/I1)*(omega_n*omega3*I3/I1 + s*1/(D/I1)*t36) */
    out[17] = t42;
    const double t43 = t16*t18; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t44 = t5*t43; /* b/R*1/(Theta/(m*R^2*I1)) */
    const double t45 = x[3]*t44; /* omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t46 = x[5]*t43; /* s*1/(Theta/(m*R^2*I1)) */
    const double t47 = x[2]*t46; /* omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t48 = x[4]*t47; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t49 = JLT_FMS(x[2], t45, t48); /* omega_tau*omega_n*b/R*1/(Theta/(m*R^2*I1)) - omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t50 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t51 = JLT_FMA(x[2], t50, x[1]); /* V = omega_tau*e + v_nu */
    const double t52 = p[11]*t51; /* I3/(R*I1)*V */
    const double t53 = JLT_FNMA(t43, t52, x[2]); /* omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t54 = x[3]*t53; /* omega_n*(omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V) */
    const double t55 = t45*t51; /* omega_n*b/R*1/(Theta/(m*R^2*I1))*V */
    const double t56 = JLT_FMS(t48, t50, t55); /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*e - omega_n*b/R*1/(Theta/(m*R^2*I1))*V */
    const double t57 = t44*p[22]; /* b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2) */
    const double t58 = t44*p[23]; /* b/R*1/(Theta/(m*R^2*I1))*2*I3^3/(m*R^2*I1^2) */
    const double t59 = JLT_FNMA(t48, t58, t54); /* omega_n*(omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V) - omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*b/R*1/(Theta/(m*R^2*I1))*2*I3^3/(m*R^2*I1^2) */
    const double t60 = JLT_FNMA(p[21], t49, t59); /* t59 - a3*I3/(R*I1)*t49 */
    const double t61 = JLT_FNMA(t56, t57, t60); /* t59 - a3*I3/(R*I1)*t49 - t56*b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2) */
    out[18] = t61;
    const double t62 = t45*p[24]; /* omega_n*b/R*1/(Theta/(m*R^2*I1))*(-I3/(R*I1)) */
    out[19] = t62;
    const double t63 = p[11]*t50; /* I3/(R*I1)*e */
    const double t64 = t63 + p[25]; /* I3/(R*I1)*e + I3^2/(m*R^2*I1) */
    const double t65 = x[4]*t64; /* omega3*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    const double t66 = JLT_FMA(t46, t65, t27); /* s*1/(Theta/(m*R^2*I1))*omega3*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) + omega_n*gamma3 */
    const double t67 = JLT_FNMA(t45, t63, t66); /* t66 - omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*e */
    out[20] = t67;
    const double t68 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t69 = JLT_FNMA(t44, t52, t68); /* omega_tau*gamma3 - b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    out[21] = t69;
    const double t70 = t47*t64; /* omega_tau*s*1/(Theta/(m*R^2*I1))*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    out[22] = t70;
    const double t71 = x[2]*t65; /* omega_tau*omega3*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    const double t72 = t43*t71; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    const double t73 = t46*p[26]; /* s*1/(Theta/(m*R^2*I1))*2*I3/(R*I1) */
    const double t74 = t46*p[27]; /* s*1/(Theta/(m*R^2*I1))*2*I3^2/(m*R^2*I1) */
    const double t75 = JLT_FNMA(t48, t74, t72); /* t72 - omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*s*1/(Theta/(m*R^2*I1))*2*I3^2/(m*R^2*I1) */
    const double t76 = JLT_FNMA(t56, t73, t75); /* t75 - t56*s*1/(Theta/(m*R^2*I1))*2*I3/(R*I1) */
    out[23] = t76;
    const double t77 = x[5]*p[28]; /* s*(I1 - I3)/I1 */
    const double t78 = t48*t77; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    const double t79 = JLT_FNMA(x[0], p[30], p[29]); /* 2*a3*I3^2/(R*I1^2) - gamma3*2*I3*(I1 - I3)/I1^2 */
    const double t80 = t48*t79; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*(2*a3*I3^2/(R*I1^2) - gamma3*2*I3*(I1 - I3)/I1^2) */
    const double t81 = t5*t80; /* b/R*t80 */
    const double t82 = JLT_FMA(t55, p[26], t81); /* omega_n*b/R*1/(Theta/(m*R^2*I1))*V*2*I3/(R*I1) + b/R*t80 */
    const double t83 = x[3]*p[17]; /* omega_n*a3/R */
    const double t84 = JLT_FNMA(t47, t83, t78); /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 - omega_tau*s*1/(Theta/(m*R^2*I1))*omega_n*a3/R */
    const double t85 = JLT_FMA(t46, t82, t84); /* s*1/(Theta/(m*R^2*I1))*(omega_n*b/R*1/(Theta/(m*R^2*I1))*V*2*I3/(R*I1) + b/R*t80) + t84 */
    out[24] = t85;
    const double t86 = x[3]*p[31]; /* omega_n*1/R */
    const double t87 = t46*t86; /* s*1/(Theta/(m*R^2*I1))*omega_n*1/R */
    const double t88 = -t87; /* -s*1/(Theta/(m*R^2*I1))*omega_n*1/R */
    out[25] = t88;
    const double t89 = JLT_FNMA(x[0], p[28], p[21]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t90 = x[5]*t89; /* s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t91 = x[4]*t90; /* omega3*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t92 = JLT_FMA(t50, t86, t91); /* e*omega_n*1/R + omega3*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t93 = t46*t92; /* s*1/(Theta/(m*R^2*I1))*t92 */
    const double t94 = -t93; /* -s*1/(Theta/(m*R^2*I1))*t92 */
    out[26] = t94;
    const double t95 = t46*t51; /* s*1/(Theta/(m*R^2*I1))*V */
    const double t96 = p[13]*t95; /* (-1/R)*s*1/(Theta/(m*R^2*I1))*V */
    out[27] = t96;
    const double t97 = t47*t90; /* omega_tau*s*1/(Theta/(m*R^2*I1))*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t98 = -t97; /* -t97 */
    out[28] = t98;
    const double t99 = t51*t86; /* V*omega_n*1/R */
    const double t100 = t13 + p[32]; /* b/R*b/R + I1/(m*R^2) */
    const double t101 = JLT_FMA(t80, t100, t99); /* t80*(b/R*b/R + I1/(m*R^2)) + V*omega_n*1/R */
    const double t102 = t43*t101; /* 1/(Theta/(m*R^2*I1))*(t80*(b/R*b/R + I1/(m*R^2)) + V*omega_n*1/R) */
    const double t103 = x[3]*p[33]; /* omega_n*2/R */
    const double t104 = t46*t103; /* s*1/(Theta/(m*R^2*I1))*omega_n*2/R */
    const double t105 = JLT_FMS(t95, t104, t102); /* s*1/(Theta/(m*R^2*I1))*V*s*1/(Theta/(m*R^2*I1))*omega_n*2/R - t102 */
    out[29] = t105;
    const double t106 = -t1; /* -s*omega_tau */
    out[30] = t106;
    const double t107 = x[5]*x[0]; /* s*gamma3 */
    const double t108 = -t107; /* -s*gamma3 */
    out[32] = t108;
    const double t109 = -t68; /* -omega_tau*gamma3 */
    out[35] = t109;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[19] = 0.0;
    out[37] = 0.0;
    out[39] = 0.0;
    out[40] = 0.0;
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = x[5]*x[5]; /* s*s */
    out[8] = t1;
    const double t2 = p[37]*t0; /* m*I3*b */
    const double t3 = JLT_FMA(p[36], t1, p[35]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t0, t2, t3); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(p[38], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t6 = p[34]*t1; /* m*g*a3*s*s */
    const double t7 = t4*t5; /* Theta*D */
    const double t8 = 1.0/t7; /* 1/(Theta*D) */
    const double t9 = t5*t8; /* 1/Theta = D*1/(Theta*D) */
    const double t10 = t4*t8; /* 1/D = Theta*1/(Theta*D) */
    const double t11 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t12 = x[5]*x[2]; /* s*omega_tau */
    const double t13 = x[5]*t12; /* s*s*omega_tau */
    out[0] = t13;
    const double t14 = 2.0*t12; /* 2*s*omega_tau */
    out[11] = t14;
    const double t15 = -t12; /* -s*omega_tau */
    out[36] = t15;
    const double t16 = x[3]*t0; /* omega_n*b */
    const double t17 = p[48]*t0; /* 2*m*R*I3*b */
    const double t18 = JLT_FMA(x[2], t11, x[1]); /* V = omega_tau*e + v_nu */
    const double t19 = t2*t18; /* m*I3*b*V */
    const double t20 = x[3]*x[3]; /* omega_n*omega_n */
    const double t21 = p[8]*t12; /* m*a3^2/I1*s*omega_tau */
    const double t22 = JLT_FNMA(t12, t21, t20); /* omega_n*omega_n - s*omega_tau*m*a3^2/I1*s*omega_tau */
    const double t23 = p[4]*t22; /* I1*(omega_n*omega_n - s*omega_tau*m*a3^2/I1*s*omega_tau) */
    const double t24 = p[37]*t16; /* m*I3*omega_n*b */
    const double t25 = x[4]*t12; /* omega3*s*omega_tau */
    const double t26 = x[3]*t18; /* omega_n*V */
    const double t27 = x[5]*x[4]; /* s*omega3 */
    const double t28 = x[3]*p[5]; /* omega_n*I3 */
    const double t29 = JLT_FMA(t27, t28, t6); /* s*omega3*omega_n*I3 + m*g*a3*s*s */
    const double t30 = JLT_FMA(x[0], t23, t29); /* gamma3*I1*(omega_n*omega_n - s*omega_tau*m*a3^2/I1*s*omega_tau) + s*omega3*omega_n*I3 + m*g*a3*s*s */
    const double t31 = t10*t30; /* 1/D*t30 */
    const double t32 = t10*t23; /* 1/D*I1*(omega_n*omega_n - s*omega_tau*m*a3^2/I1*s*omega_tau) */
    const double t33 = -t32; /* -1/D*I1*(omega_n*omega_n - s*omega_tau*m*a3^2/I1*s*omega_tau) */
    out[18] = t33;
    const double t34 = -t31; /* -1/D*t30 */
    out[2] = t34;
    const double t35 = t18*t24; /* V*m*I3*omega_n*b */
    const double t36 = JLT_FMA(p[40], t11, p[39]); /* m*R*I3*e + I3^2 */
    const double t37 = JLT_FMS(t25, t36, t35); /* numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*(m*R*I3*e + I3^2) - V*m*I3*omega_n*b */
    const double t38 = t9*t37; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t39 = p[41]*t26; /* m*R*I1*omega_n*V */
    const double t40 = x[0]*t12; /* gamma3*s*omega_tau */
    const double t41 = -t40; /* -gamma3*s*omega_tau */
    out[5] = t41;
    const double t42 = p[44]*t40; /* 2*m*a3^2*gamma3*s*omega_tau */
    const double t43 = p[42]*t25; /* m*R*a3*I3*omega3*s*omega_tau */
    const double t44 = x[2]*p[47]; /* omega_tau*m*a3*I3 */
    const double t45 = JLT_FNMA(t16, t44, t43); /* m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 */
    const double t46 = JLT_FNMA(p[40], t26, t45); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 - m*R*I3*omega_n*V */
    const double t47 = JLT_FNMA(t17, t38, t46); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) - 2*m*R*I3*b*1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t48 = t9*t47; /* 1/Theta*t47 */
    const double t49 = JLT_FMA(x[2], x[3], t48); /* omega_tau*omega_n + 1/Theta*t47 */
    out[24] = t49;
    const double t50 = x[5]*t9; /* s*1/Theta */
    const double t51 = x[5]*t39; /* s*m*R*I1*omega_n*V */
    const double t52 = JLT_FNMA(x[0], p[43], p[42]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t53 = t12*t27; /* s*omega_tau*s*omega3 */
    const double t54 = JLT_FMA(t52, t53, t51); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*omega_tau*s*omega3 + s*m*R*I1*omega_n*V */
    const double t55 = t9*t54; /* 1/Theta*t54 */
    const double t56 = t50*t52; /* s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t57 = -t55; /* -1/Theta*t54 */
    out[4] = t57;
    const double t58 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t59 = x[3]*p[50]; /* omega_n*m*R*a3*I1 */
    const double t60 = t12*t59; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t61 = JLT_FMS(p[43], t53, t60); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = m*R^2*(I1 - I3)*s*omega_tau*s*omega3 - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t62 = JLT_FMA(t17, t55, t61); /* 2*m*R*I3*b*1/Theta*t54 + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t63 = t9*t62; /* 1/Theta*t62 */
    out[30] = t63;
    const double t64 = p[41]*t50; /* m*R*I1*s*1/Theta */
    const double t65 = p[49]*t50; /* 2*m*R^2*I1*s*1/Theta */
    const double t66 = t18*t64; /* V*m*R*I1*s*1/Theta */
    const double t67 = -t66; /* -V*m*R*I1*s*1/Theta */
    out[33] = t67;
    const double t68 = x[3]*t64; /* omega_n*m*R*I1*s*1/Theta */
    const double t69 = -t68; /* -omega_n*m*R*I1*s*1/Theta */
    out[31] = t69;
    const double t70 = t11*t68; /* e*omega_n*m*R*I1*s*1/Theta */
    const double t71 = t11*t24; /* e*m*I3*omega_n*b */
    const double t72 = t9*t24; /* 1/Theta*m*I3*omega_n*b */
    const double t73 = -t72; /* -1/Theta*m*I3*omega_n*b */
    out[25] = t73;
    const double t74 = JLT_FMS(t27, t36, t71); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(m*R*I3*e + I3^2) - e*m*I3*omega_n*b */
    const double t75 = JLT_FMA(t9, t74, t58); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[26] = t75;
    const double t76 = p[45]*t58; /* 2*I1*omega_n*gamma3 */
    const double t77 = JLT_FMA(p[5], t27, t76); /* I3*s*omega3 + 2*I1*omega_n*gamma3 */
    const double t78 = t9*t36; /* 1/Theta*(m*R*I3*e + I3^2) */
    const double t79 = t10*t77; /* 1/D*(I3*s*omega3 + 2*I1*omega_n*gamma3) */
    const double t80 = -t79; /* -1/D*(I3*s*omega3 + 2*I1*omega_n*gamma3) */
    out[21] = t80;
    const double t81 = JLT_FMA(t27, t56, t70); /* s*omega3*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*omega_n*m*R*I1*s*1/Theta */
    const double t82 = -t81; /* -t81 */
    out[32] = t82;
    const double t83 = t12*t56; /* s*omega_tau*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t84 = t12*t78; /* s*omega_tau*1/Theta*(m*R*I3*e + I3^2) */
    out[28] = t84;
    const double t85 = -t83; /* -s*omega_tau*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[34] = t85;
    const double t86 = x[0]*p[51]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t87 = JLT_FMS(t25, t86, t39); /* omega3*s*omega_tau*gamma3*2*m*R^2*(I1 - I3) - m*R*I1*omega_n*V */
    const double t88 = JLT_FNMA(p[52], t25, t87); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t87 - 2*m*R*a3*I3*omega3*s*omega_tau */
    const double t89 = t9*t88; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t90 = JLT_FMA(t55, t65, t89); /* 1/Theta*t54*2*m*R^2*I1*s*1/Theta + 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    out[35] = t90;
    const double t91 = x[5]*t10; /* s*1/D */
    const double t92 = t42*t91; /* 2*m*a3^2*gamma3*s*omega_tau*s*1/D */
    out[20] = t92;
    const double t93 = x[2]*t42; /* omega_tau*2*m*a3^2*gamma3*s*omega_tau */
    const double t94 = JLT_FNMA(x[5], p[46], t93); /* omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 */
    const double t95 = JLT_FNMA(x[4], t28, t94); /* d(numerator of d(omega_tau)/dt over D)/d(s) = omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 - omega3*omega_n*I3 */
    const double t96 = t28*t91; /* omega_n*I3*s*1/D */
    const double t97 = -t96; /* -omega_n*I3*s*1/D */
    out[22] = t97;
    const double t98 = p[44]*t91; /* 2*m*a3^2*s*1/D */
    const double t99 = t31*t98; /* 1/D*t30*2*m*a3^2*s*1/D */
    const double t100 = JLT_FMA(t10, t95, t99); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) + 1/D*t30*2*m*a3^2*s*1/D */
    out[23] = t100;
    const double t101 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t102 = t78*t101; /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 */
    const double t103 = JLT_FNMA(t38, t65, t102); /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    out[29] = t103;
    const double t104 = x[3]*t16; /* omega_n*omega_n*b */
    const double t105 = 2.0*t16; /* 2*omega_n*b */
    const double t106 = JLT_FMA(p[1], t27, t105); /* R*s*omega3 + 2*omega_n*b */
    out[15] = t106;
    const double t107 = x[3]*p[1]; /* omega_n*R */
    const double t108 = JLT_FMA(t27, t107, t104); /* s*omega3*omega_n*R + omega_n*omega_n*b */
    out[1] = t108;
    const double t109 = x[3]*t107; /* omega_n*omega_n*R */
    out[12] = t109;
    const double t110 = x[5]*t107; /* s*omega_n*R */
    out[16] = t110;
    const double t111 = x[4]*t107; /* omega3*omega_n*R */
    out[17] = t111;
    const double t112 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t113 = JLT_FNMA(t9, t19, t112); /* omega_tau*gamma3 - 1/Theta*m*I3*b*V */
    out[27] = t113;
    const double t114 = JLT_FMA(x[3], t112, t38); /* omega_n*omega_tau*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t114;
    const double t115 = -t112; /* -omega_tau*gamma3 */
    out[41] = t115;
    const double t116 = x[5]*x[0]; /* s*gamma3 */
    const double t117 = -t116; /* -s*gamma3 */
    out[38] = t117;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[0]*t1; /* gamma3*omega_tau*s*s */
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = p[43]*t2; /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s */
    const double t5 = JLT_FNMA(p[42], t1, t4); /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s - m*R*a3*I3*omega_tau*s*s */
    const double t6 = p[44]*t2; /* 2*m*a3^2*gamma3*omega_tau*s*s */
    const double t7 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t8 = JLT_FMA(x[2], t7, x[1]); /* V = omega_tau*e + v_nu */
    const double t9 = p[37]*t3; /* m*I3*b */
    const double t10 = JLT_FNMA(t8, t9, t5); /* t5 - V*m*I3*b */
    const double t11 = JLT_FMA(p[38], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t12 = JLT_FMA(p[36], t0, p[35]); /* m*R^2*I1*s*s + I1*I3 */
    const double t13 = JLT_FMA(t3, t9, t12); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t14 = t10*t11; /* (t5 - V*m*I3*b)*D */
    const double t15 = JLT_FMA(t6, t13, t14); /* 2*m*a3^2*gamma3*omega_tau*s*s*Theta + (t5 - V*m*I3*b)*D */
    const double t16 = t11*t13; /* D*Theta */
    const double t17 = t15/t16; /* (2*m*a3^2*gamma3*omega_tau*s*s*Theta + (t5 - V*m*I3*b)*D)/(D*Theta) */
    out[0] = t17;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[54]*x[0]; /* 2*g*a3*gamma3 */
    const double t1 = JLT_FMA(x[1], x[1], t0); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t2 = p[56]*x[3]; /* I1/m*omega_n */
    const double t3 = JLT_FMA(x[3], t2, t1); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t4 = p[38]*x[5]; /* m*a3^2*s */
    const double t5 = JLT_FMA(x[5], t4, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t6 = p[55]*x[2]; /* 1/m*omega_tau */
    const double t7 = x[2]*t6; /* omega_tau*1/m*omega_tau */
    const double t8 = p[57]*x[4]; /* I3/m*omega3 */
    const double t9 = JLT_FMA(x[4], t8, t3); /* omega3*I3/m*omega3 + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t10 = JLT_FMA(t5, t7, t9); /* D*omega_tau*1/m*omega_tau + t9 */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = x[3]*t11; /* omega_n*b */
    const double t13 = x[5]*p[1]; /* s*R */
    const double t14 = JLT_FMA(x[4], t13, t12); /* v_tau = omega3*s*R + omega_n*b */
    const double t15 = JLT_FMA(t14, t14, t10); /* energy/(1/2*m) = v_tau*v_tau + D*omega_tau*1/m*omega_tau + t9 */
    const double t16 = p[53]*t15; /* 1/2*m*energy/(1/2*m) */
    out[0] = t16;
    const double t17 = x[5]*p[58]; /* s*R*I1 */
    const double t18 = x[3]*t17; /* omega_n*s*R*I1 */
    const double t19 = x[4]*p[5]; /* omega3*I3 */
    const double t20 = JLT_FNMA(t11, t19, t18); /* omega_n*s*R*I1 - b*omega3*I3 */
    out[1] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[7] = 0.0;
    out[8] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = x[4]*p[60]; /* omega3*(-R*I3) */
    out[6] = t1;
    const double t2 = x[5]*p[58]; /* s*R*I1 */
    out[9] = t2;
    const double t3 = x[3]*p[58]; /* omega_n*R*I1 */
    out[11] = t3;
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = p[61]*t4; /* (-I3)*b */
    out[10] = t5;
    const double t6 = x[3]*t4; /* omega_n*b */
    const double t7 = p[0]*t4; /* m*b */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(x[5], t8, t6); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = x[5]*p[38]; /* s*m*a3^2 */
    const double t11 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t12 = t10*t11; /* s*m*a3^2*omega_tau*omega_tau */
    const double t13 = JLT_FMA(x[5], t10, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = x[2]*t13; /* omega_tau*D */
    out[2] = t14;
    const double t15 = p[59]*t9; /* m*R*v_tau */
    const double t16 = JLT_FMA(x[4], t15, t12); /* d(energy)/d(s) = omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    out[5] = t16;
    const double t17 = JLT_FMA(x[3], t15, p[34]); /* d(energy)/d(gamma3) = omega_n*m*R*v_tau + m*g*a3 */
    out[0] = t17;
    const double t18 = x[3]*p[4]; /* omega_n*I1 */
    const double t19 = JLT_FMA(t7, t9, t18); /* d(energy)/d(omega_n) = m*b*v_tau + omega_n*I1 */
    out[3] = t19;
    const double t20 = x[4]*p[5]; /* omega3*I3 */
    const double t21 = JLT_FMA(x[5], t15, t20); /* d(energy)/d(omega3) = s*m*R*v_tau + omega3*I3 */
    out[4] = t21;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[5];
}

static void observe_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = p[10]*t0; /* m*g*a3/I1*s*s */
    const double t2 = JLT_FMA(p[38], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t3 = x[5]*p[9]; /* s*I3/I1 */
    const double t4 = x[3]*x[4]; /* omega_n*omega3 */
    const double t5 = JLT_FMA(t3, t4, t1); /* s*I3/I1*omega_n*omega3 + m*g*a3/I1*s*s */
    const double t6 = x[3]*x[3]; /* omega_n*omega_n */
    const double t7 = JLT_FMA(x[2], x[2], t6); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t8 = JLT_FMA(x[0], t7, t5); /* gamma3*(omega_tau*omega_tau + omega_n*omega_n) + s*I3/I1*omega_n*omega3 + m*g*a3/I1*s*s */
    const double t9 = p[62]*t8; /* a3*I1*t8 */
    const double t10 = t9/t2; /* a3*I1*t8/D */
    const double t11 = p[2] - t10; /* g - a3*I1*t8/D */
    const double t12 = p[0]*t11; /* m*(g - a3*I1*t8/D) */
    out[0] = t12;
}

static void valid_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = p[10]*t0; /* m*g*a3/I1*s*s */
    const double t2 = JLT_FMA(p[38], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t3 = x[5]*p[9]; /* s*I3/I1 */
    const double t4 = x[3]*x[4]; /* omega_n*omega3 */
    const double t5 = JLT_FMA(t3, t4, t1); /* s*I3/I1*omega_n*omega3 + m*g*a3/I1*s*s */
    const double t6 = x[3]*x[3]; /* omega_n*omega_n */
    const double t7 = JLT_FMA(x[2], x[2], t6); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t8 = JLT_FMA(x[0], t7, t5); /* gamma3*(omega_tau*omega_tau + omega_n*omega_n) + s*I3/I1*omega_n*omega3 + m*g*a3/I1*s*s */
    const double t9 = p[62]*t8; /* a3*I1*t8 */
    const double t10 = t9/t2; /* a3*I1*t8/D */
    const double t11 = p[2] - t10; /* g - a3*I1*t8/D */
    const double t12 = p[0]*t11; /* m*(g - a3*I1*t8/D) */
    out[0] = t12;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double x5[JLT_JET_ORDER_MAX + 1];
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x5, x2, k);
        t3[k] = jlt_jet_product(x5, t2, k);
        t8[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t9[k] = jlt_jet_product(x3, t8, k);
        t11[k] = jlt_jet_product(x5, x4, k);
        t12[k] = p[1]*t11[k] + t9[k];
        t13[k] = jlt_jet_product(x3, t12, k);
        t16[k] = jlt_jet_product(x5, x5, k);
        t17[k] = p[8]*t16[k] + (k == 0 ? 1.0 : 0);
        t18[k] = jlt_jet_product(t2, x0, k);
        t19[k] = t2[k]*p[8];
        t20[k] = jlt_jet_product(t18, t19, k);
        t22[k] = jlt_jet_product(x3, x0, k);
        t23[k] = t11[k]*p[9] + t22[k];
        t25[k] = t20[k] - t16[k]*p[10];
        t26[k] = t25[k] - jlt_jet_product(x3, t23, k);
        t27[k] = jlt_jet_quotient(t26[k], t17, t27, k);
        t28[k] = jlt_jet_product(x2, t22, k);
        t32[k] = t8[k]*p[37];
        t33[k] = t16[k]*p[36] + (k == 0 ? p[35] : 0);
        t34[k] = jlt_jet_product(t8, t32, k) + t33[k];
        t35[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t34, t35, k);
        t38[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t39[k] = (k == 0 ? p[12] : 0) + t38[k];
        t40[k] = jlt_jet_product(t2, x4, k);
        t41[k] = p[40]*t40[k];
        t42[k] = jlt_jet_product(t39, t41, k);
        t44[k] = jlt_jet_product(x2, t38, k) + x1[k];
        t45[k] = jlt_jet_product(x3, t44, k);
        t46[k] = t42[k] - jlt_jet_product(t32, t45, k);
        t47[k] = jlt_jet_product(t35, t46, k) + t28[k];
        t51[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t52[k] = jlt_jet_product(t40, t51, k) + t45[k];
        t53[k] = x5[k]*p[63];
        t54[k] = jlt_jet_product(t52, t53, k);
        t55[k] = jlt_jet_product(t35, t54, k);
        t56[k] = -t18[k];
        double *restrict next = coefficients + (k + 1)*7;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t13[k]/(k + 1);
        next[2] = x2[k + 1] = t27[k]/(k + 1);
        next[3] = x3[k + 1] = t47[k]/(k + 1);
        next[4] = x4[k + 1] = t55[k]/(k + 1);
        next[5] = x5[k + 1] = t56[k]/(k + 1);
        next[6] = x5[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[5];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega3 = x[4];
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = params[5];
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta));
    out[4] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[5] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    out[3] = x[3];
    out[4] = x[4];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[5] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[5]*x[5]; /* s*s */
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
    out[4] = 0.0;
    const double t1 = 2.0*x[5]; /* 2*s */
    out[5] = t1;
}

/* The reduction level, to the table spherical_top_level, SHA-256
 * 5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d. */
static void way0_coordinates(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = 1.0;
    out[3] = 1.0;
    out[5] = 1.0;
    out[7] = 1.0;
    out[2] = x[1];
    out[4] = x[2];
    const double t0 = x[0]*params[1]; /* gamma3*R */
    const double t1 = params[3] + t0; /* b = a3 + gamma3*R */
    const double t2 = x[3]*t1; /* omega_n*b */
    const double t3 = params[1]*x[4]; /* R*omega3 */
    const double t4 = t3*x[5]; /* R*omega3*s */
    const double t5 = t2 + t4; /* v_tau = omega_n*b + R*omega3*s */
    out[6] = t5;
}

static void way0_params(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[4];
    out[4] = params[5];
    out[5] = params[3];
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = t0*x[3]; /* R*I1*omega_n */
    const double t2 = t1*x[5]; /* R*I1*omega_n*s */
    const double t3 = params[5]*x[4]; /* I3*omega3 */
    const double t4 = params[1]*x[0]; /* R*gamma3 */
    const double t5 = params[3] + t4; /* b = a3 + R*gamma3 */
    const double t6 = t3*t5; /* I3*omega3*b */
    const double t7 = t2 - t6; /* R*I1*omega_n*s - I3*omega3*b */
    out[6] = t7;
}

static void way0_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    out[5] = x[4];
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = t1*t2; /* R*R*I1*s*s */
    const double t4 = x[0]*params[1]; /* gamma3*R */
    const double t5 = params[5] + t4; /* b = a3 + gamma3*R */
    const double t6 = t5*t5; /* b*b */
    const double t7 = params[4]*t6; /* I3*b*b */
    const double t8 = t3 + t7; /* K = R*R*I1*s*s + I3*b*b */
    const double t9 = params[1]*params[6]; /* R*G */
    const double t10 = x[4]*t9; /* s*R*G */
    const double t11 = params[4]*x[3]; /* I3*v_tau */
    const double t12 = t5*t11; /* b*I3*v_tau */
    const double t13 = t10 + t12; /* s*R*G + b*I3*v_tau */
    const double t14 = t13/t8; /* (s*R*G + b*I3*v_tau)/K */
    out[3] = t14;
    const double t15 = params[1]*params[3]; /* R*I1 */
    const double t16 = x[3]*t15; /* v_tau*R*I1 */
    const double t17 = x[4]*t16; /* s*v_tau*R*I1 */
    const double t18 = t5*params[6]; /* b*G */
    const double t19 = t17 - t18; /* s*v_tau*R*I1 - b*G */
    const double t20 = t19/t8; /* (s*v_tau*R*I1 - b*G)/K */
    out[4] = t20;
}

static const unsigned char way0_is_angle[] = { 0, 0, 0, 0 };

static const unsigned char way0_is_root[] = { 0, 0, 0, 0, 0, 0, 0 };

static const unsigned char way0_sources[] = { 0, 0, 0, 0, 0, 0, 2 };

/* The reduction momentum, to the table spherical_top_balanced, SHA-256
 * 24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33. */
static void way1_coordinates(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = 1.0;
    out[3] = 1.0;
    const double t0 = params[1]*x[2]; /* R*omega_tau */
    const double t1 = x[1] + t0; /* v_nu + R*omega_tau */
    out[2] = t1;
    const double t2 = params[1]*params[0]; /* R*m */
    const double t3 = x[1]*t2; /* v_nu*R*m */
    const double t4 = x[2]*params[4]; /* omega_tau*I1 */
    const double t5 = t3 - t4; /* v_nu*R*m - omega_tau*I1 */
    out[4] = t5;
    const double t6 = x[0]*x[3]; /* gamma3*omega_n */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = params[0]*t7; /* m*R*R */
    const double t9 = params[4] + t8; /* I1 + m*R*R */
    const double t10 = t6*t9; /* gamma3*omega_n*(I1 + m*R*R) */
    const double t11 = x[4]*x[5]; /* omega3*s */
    const double t12 = t8 + params[5]; /* m*R*R + I3 */
    const double t13 = t11*t12; /* omega3*s*(m*R*R + I3) */
    const double t14 = t10 + t13; /* gamma3*omega_n*(I1 + m*R*R) + omega3*s*(m*R*R + I3) */
    out[5] = t14;
}

static void way1_params(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[4];
    out[3] = params[5];
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = t0*x[3]; /* R*I1*omega_n */
    const double t2 = t1*x[5]; /* R*I1*omega_n*s */
    const double t3 = params[5]*x[4]; /* I3*omega3 */
    const double t4 = params[1]*x[0]; /* R*gamma3 */
    const double t5 = params[3] + t4; /* b = a3 + R*gamma3 */
    const double t6 = t3*t5; /* I3*omega3*b */
    const double t7 = t2 - t6; /* R*I1*omega_n*s - I3*omega3*b */
    out[4] = t7;
    const double t8 = params[0]*params[1]; /* m*R */
    const double t9 = t8*x[1]; /* m*R*v_nu */
    const double t10 = params[4]*x[2]; /* I1*omega_tau */
    const double t11 = t9 - t10; /* m*R*v_nu - I1*omega_tau */
    const double t12 = t11*t11; /* (m*R*v_nu - I1*omega_tau)*(m*R*v_nu - I1*omega_tau) */
    const double t13 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t14 = params[1]*params[1]; /* R*R */
    const double t15 = params[0]*t14; /* m*R*R */
    const double t16 = params[4] + t15; /* I1 + m*R*R */
    const double t17 = t13*t16; /* omega_n*gamma3*(I1 + m*R*R) */
    const double t18 = x[5]*x[4]; /* s*omega3 */
    const double t19 = params[5] + t15; /* I3 + m*R*R */
    const double t20 = t18*t19; /* s*omega3*(I3 + m*R*R) */
    const double t21 = t17 + t20; /* omega_n*gamma3*(I1 + m*R*R) + s*omega3*(I3 + m*R*R) */
    const double t22 = t21*t21; /* (omega_n*gamma3*(I1 + m*R*R) + s*omega3*(I3 + m*R*R))*(omega_n*gamma3*(I1 + m*R*R) + s*omega3*(I3 + m*R*R)) */
    const double t23 = t12 + t22; /* (m*R*v_nu - I1*omega_tau)*(m*R*v_nu - I1*omega_tau) + t22 */
    out[5] = t23;
}

static const jlt_way_condition way1_conditions[] = {
    { "a3 = 0", 1 },
    { "omega_n^2 + omega3^2 > 0", 0 },
    { "I3 + (I1*R*s*omega_n - I3*b*omega3)^2 > 0", 0 },
};

static void way1_condition_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[3];
    const double t0 = x[3]*x[3]; /* omega_n*omega_n */
    const double t1 = x[4]*x[4]; /* omega3*omega3 */
    const double t2 = t0 + t1; /* omega_n*omega_n + omega3*omega3 */
    out[1] = t2;
    const double t3 = params[1]*params[4]; /* R*I1 */
    const double t4 = x[3]*t3; /* omega_n*R*I1 */
    const double t5 = t4*x[5]; /* omega_n*R*I1*s */
    const double t6 = x[4]*params[5]; /* omega3*I3 */
    const double t7 = params[1]*x[0]; /* R*gamma3 */
    const double t8 = params[3] + t7; /* b = a3 + R*gamma3 */
    const double t9 = t6*t8; /* omega3*I3*b */
    const double t10 = t5 - t9; /* omega_n*R*I1*s - omega3*I3*b */
    const double t11 = t10*t10; /* (omega_n*R*I1*s - omega3*I3*b)*(omega_n*R*I1*s - omega3*I3*b) */
    const double t12 = params[5] + t11; /* I3 + t11 */
    out[2] = t12;
}

static void way1_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[2] + t1; /* J1 = I1 + m*R*R */
    const double t3 = params[2]*x[1]; /* I1*v_slip */
    const double t4 = params[1]*params[5]; /* R*M */
    const double t5 = sin(x[2]); /* S = sin(psi) */
    const double t6 = t4*t5; /* R*M*S */
    const double t7 = t3 + t6; /* I1*v_slip + R*M*S */
    const double t8 = t7/t2; /* (I1*v_slip + R*M*S)/J1 */
    out[1] = t8;
    const double t9 = params[0]*params[1]; /* m*R */
    const double t10 = x[1]*t9; /* v_slip*m*R */
    const double t11 = params[5]*t5; /* M*S */
    const double t12 = t10 - t11; /* v_slip*m*R - M*S */
    const double t13 = t12/t2; /* (v_slip*m*R - M*S)/J1 */
    out[2] = t13;
    const double t14 = params[2]*params[3]; /* I1*I3 */
    out[5] = x[3];
    const double t15 = x[3]*x[3]; /* s*s */
    const double t16 = params[2]*t15; /* I1*s*s */
    const double t17 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t18 = params[3]*t17; /* I3*gamma3*gamma3 */
    const double t19 = t16 + t18; /* I1*s*s + I3*gamma3*gamma3 */
    const double t20 = t1*t19; /* m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t21 = t14 + t20; /* Theta = I1*I3 + m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t22 = x[3]*params[4]; /* s*G */
    const double t23 = t1 + params[3]; /* J3 = m*R*R + I3 */
    const double t24 = t22*t23; /* s*G*J3 */
    const double t25 = t24/params[1]; /* s*G*J3/R */
    const double t26 = params[5]*params[3]; /* M*I3 */
    const double t27 = x[0]*t26; /* gamma3*M*I3 */
    const double t28 = cos(x[2]); /* C = cos(psi) */
    const double t29 = t27*t28; /* gamma3*M*I3*C */
    const double t30 = t25 + t29; /* s*G*J3/R + gamma3*M*I3*C */
    const double t31 = t30/t21; /* (s*G*J3/R + gamma3*M*I3*C)/Theta */
    out[3] = t31;
    const double t32 = params[2]*params[5]; /* I1*M */
    const double t33 = x[3]*t32; /* s*I1*M */
    const double t34 = t28*t33; /* C*s*I1*M */
    const double t35 = x[0]*params[4]; /* gamma3*G */
    const double t36 = t2*t35; /* J1*gamma3*G */
    const double t37 = t36/params[1]; /* J1*gamma3*G/R */
    const double t38 = t34 - t37; /* C*s*I1*M - J1*gamma3*G/R */
    const double t39 = t38/t21; /* (C*s*I1*M - J1*gamma3*G/R)/Theta */
    out[4] = t39;
}

static const unsigned char way1_is_angle[] = { 0, 0, 1 };

static const unsigned char way1_is_root[] = { 0, 0, 0, 0, 0, 1 };

static const unsigned char way1_sources[] = { 0, 0, 0, 0, 2, 2 };

/* The lift track, to the table spherical_top_track, SHA-256
 * 625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735. */
static void way2_coordinates(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = 1.0;
    out[3] = 1.0;
    out[5] = 1.0;
    out[7] = 1.0;
    out[9] = 1.0;
    out[11] = 1.0;
    out[13] = 1.0;
    out[15] = 1.0;
    out[17] = 1.0;
    out[2] = x[1];
    out[4] = x[2];
    out[6] = x[3];
    out[8] = x[4];
    out[10] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    const double t0 = params[3]*x[5]; /* a3*s */
    out[14] = t0;
}

static void way2_params(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
}

static void way2_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    out[3] = x[3];
    out[4] = x[4];
    out[5] = x[9];
}

static const unsigned char way2_is_angle[] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 };

static const unsigned char way2_is_root[] = { 0, 0, 0, 0, 0, 0 };

static const unsigned char way2_sources[] = { 0, 0, 0, 0, 0, 0 };

/* The lift full, to the table spherical_top_full, SHA-256
 * 5de9745ff1945082f709f85b1765ec2e95addd9d5431b2def563648618d9e642. */
static void way3_coordinates(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = 0.0;
    out[18] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    out[32] = 0.0;
    out[1] = 1.0;
    out[3] = 1.0;
    out[5] = 1.0;
    out[7] = 1.0;
    out[9] = 1.0;
    out[11] = 1.0;
    out[13] = 1.0;
    out[15] = 1.0;
    out[17] = 1.0;
    out[19] = 1.0;
    out[21] = 1.0;
    out[23] = 1.0;
    out[25] = 1.0;
    out[27] = 1.0;
    out[29] = 1.0;
    out[31] = 1.0;
    out[33] = 1.0;
    out[24] = (-1.0);
    out[22] = x[5];
    const double t0 = -x[5]; /* -s */
    out[2] = t0;
    out[4] = x[0];
    out[20] = x[0];
    out[14] = x[3];
    const double t1 = x[0]*params[1]; /* gamma3*R */
    const double t2 = params[3] + t1; /* b = a3 + gamma3*R */
    const double t3 = x[3]*t2; /* omega_n*b */
    out[16] = x[4];
    const double t4 = params[1]*x[4]; /* R*omega3 */
    const double t5 = x[5]*t4; /* s*R*omega3 */
    const double t6 = t3 + t5; /* v_tau = omega_n*b + s*R*omega3 */
    out[6] = t6;
    const double t7 = x[0]*x[1]; /* gamma3*v_nu */
    out[12] = x[2];
    const double t8 = params[3]*x[2]; /* a3*omega_tau */
    const double t9 = x[5]*x[5]; /* s*s */
    const double t10 = t8*t9; /* a3*omega_tau*s*s */
    const double t11 = t7 - t10; /* gamma3*v_nu - a3*omega_tau*s*s */
    out[8] = t11;
    const double t12 = x[5]*x[1]; /* s*v_nu */
    const double t13 = x[0]*params[3]; /* gamma3*a3 */
    const double t14 = x[2]*t13; /* omega_tau*gamma3*a3 */
    const double t15 = x[5]*t14; /* s*omega_tau*gamma3*a3 */
    const double t16 = t12 + t15; /* s*v_nu + s*omega_tau*gamma3*a3 */
    out[10] = t16;
    const double t17 = x[5]*params[3]; /* s*a3 */
    out[30] = t17;
}

static void way3_params(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
}

static const jlt_way_condition way3_conditions[] = {
    { "I3 > 0", 0 },
};

static void way3_condition_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[5];
}

static void way3_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[2];
    const double t0 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t1 = x[1]*x[1]; /* gamma2*gamma2 */
    const double t2 = t0 + t1; /* gamma1*gamma1 + gamma2*gamma2 */
    const double t3 = sqrt(t2); /* s = sqrt(gamma1*gamma1 + gamma2*gamma2) */
    out[5] = t3;
    const double t4 = x[0]*x[3]; /* gamma1*v1 */
    const double t5 = x[1]*x[4]; /* gamma2*v2 */
    const double t6 = t4 + t5; /* gamma1*v1 + gamma2*v2 */
    const double t7 = x[2]*x[5]; /* gamma3*v3 */
    const double t8 = t6 + t7; /* gamma1*v1 + gamma2*v2 + gamma3*v3 */
    const double t9 = x[2]*t8; /* gamma3*(gamma1*v1 + gamma2*v2 + gamma3*v3) */
    const double t10 = x[5] - t9; /* v3 - gamma3*(gamma1*v1 + gamma2*v2 + gamma3*v3) */
    const double t11 = t10/t3; /* (v3 - gamma3*(gamma1*v1 + gamma2*v2 + gamma3*v3))/s */
    out[1] = t11;
    const double t12 = x[0]*x[7]; /* gamma1*omega2 */
    const double t13 = x[1]*x[6]; /* gamma2*omega1 */
    const double t14 = t12 - t13; /* dgamma3 = gamma1*omega2 - gamma2*omega1 */
    const double t15 = t14/t3; /* dgamma3/s */
    out[2] = t15;
    const double t16 = x[0]*x[6]; /* gamma1*omega1 */
    const double t17 = x[1]*x[7]; /* gamma2*omega2 */
    const double t18 = t16 + t17; /* q = gamma1*omega1 + gamma2*omega2 */
    const double t19 = t18/t3; /* q/s */
    const double t20 = -t19; /* -q/s */
    out[3] = t20;
    out[4] = x[8];
}

static const unsigned char way3_is_angle[] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 };

static const unsigned char way3_is_root[] = { 0, 0, 0, 0, 0, 0 };

static const unsigned char way3_sources[] = { 0, 0, 0, 0, 0, 0 };

static const jlt_way ways[] = {
    { .name = "level", .kind = "reduction", .model = "spherical_top_level", .file = "spherical_top_level.tt",
      .sha256 = "5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d",
      .time = "regular", .claim = 25,
      .state_count = 5, .param_count = 7, .coordinate_count = 4,
      .is_angle = way0_is_angle,
      .coordinates = way0_coordinates,
      .back = way0_back,
      .is_root = way0_is_root, .sources = way0_sources,
      .params = way0_params,
    },
    { .name = "momentum", .kind = "reduction", .model = "spherical_top_balanced", .file = "spherical_top_balanced.tt",
      .sha256 = "24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33",
      .time = "regular", .claim = 26,
      .state_count = 4, .param_count = 6, .coordinate_count = 3,
      .is_angle = way1_is_angle,
      .coordinates = way1_coordinates,
      .back = way1_back,
      .is_root = way1_is_root, .sources = way1_sources,
      .params = way1_params,
      .condition_count = 3, .conditions = way1_conditions,
      .condition_values = way1_condition_values,
    },
    { .name = "track", .kind = "lift", .model = "spherical_top_track", .file = "spherical_top_track.tt",
      .sha256 = "625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735",
      .time = "regular", .claim = 27,
      .state_count = 10, .param_count = 6, .coordinate_count = 9,
      .is_angle = way2_is_angle,
      .coordinates = way2_coordinates,
      .back = way2_back,
      .is_root = way2_is_root, .sources = way2_sources,
      .params = way2_params,
    },
    { .name = "full", .kind = "lift", .model = "spherical_top_full", .file = "spherical_top_full.tt",
      .sha256 = "5de9745ff1945082f709f85b1765ec2e95addd9d5431b2def563648618d9e642",
      .time = "", .claim = 28,
      .state_count = 17, .param_count = 6, .coordinate_count = 17,
      .is_angle = way3_is_angle,
      .coordinates = way3_coordinates,
      .back = way3_back,
      .is_root = way3_is_root, .sources = way3_sources,
      .params = way3_params,
      .condition_count = 1, .conditions = way3_conditions,
      .condition_values = way3_condition_values,
    },
};

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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
    { "G", "" },
};

static const jlt_quantity observes[] = {
    { "contact_force", "kg*m/s^2", "force of the plane on the sphere, upwards", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_validity valids[] = {
    { "contact", "kg*m/s^2", "the plane only pushes" },
};

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .scales = 1,
    .state_count = 6, .param_count = 6, .prepared_count = 64,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 6, { 3, 23, 13, 1, 0, 0, 7, 10 }, { 17, 78, 0, 10, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, R*s*omega3 + omega_n*b, s*omega3*(I3/I1) + omega_n*gamma3, a part of d(omega_tau)/dtau, e = a3*gamma3 + R, V = omega_tau*e + v_nu, e + I3/(m*R), a part of d(omega_n)/dtau, d(omega_n)/dtau, a3*I3/I1 - gamma3*(R*(I1 - I3)/I1), omega_tau*s*omega3*(a3*I3/I1 - gamma3*(R*(I1 - I3)/I1)) + omega_n*V" },
    .jacobian = { jacobian, 36, { 12, 67, 30, 1, 0, 0, 13, 20 }, { 56, 375, 0, 49, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, d(d(v_nu)/dtau)/d(omega_n), d(d(omega_tau)/dtau)/d(gamma3), omega3*(I3/I1)*s*1/(D/I1) + 1/(D/I1)*(2)*omega_n*gamma3, a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_n)/dtau)/d(gamma3), e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega_tau - 1/(Theta/(m*R^2*I1))*(I3/(R*I1))*V, a part of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s), d(d(omega_n)/dtau)/d(gamma3), (I3/(R*I1))*e + I3^2/(m*R^2*I1), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(s), 2*a3*I3^2/(R*I1^2) - gamma3*(2*I3*(I1 - I3)/I1^2), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(gamma3), a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), e*omega_n*(1/R) + omega3*s*(a3*I3/(R*I1) - gamma3*((I1 - I3)/I1)), a part of d(d(omega3)/dtau)/d(s), d(d(omega3)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 42, { 14, 69, 34, 1, 0, 0, 12, 24 }, { 67, 437, 0, 59, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, V = omega_tau*e + v_nu, omega_n*omega_n - s*omega_tau*(m*a3^2/I1)*s*omega_tau, a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), (m*R*I3)*e + I3^2, numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*((m*R*I3)*e + I3^2) - V*(m*I3)*omega_n*b, d(numerator of d(omega_n)/dt over Theta)/d(gamma3), a part of d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(gamma3), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s), d(numerator of d(omega3)/dt over Theta)/d(gamma3) = (m*R^2*(I1 - I3))*s*omega_tau*s*omega3 - s*omega_tau*omega_n*(m*R*a3*I1), a part of d(d(omega3)/dtau)/d(gamma3), d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*((m*R*I3)*e + I3^2) - e*(m*I3)*omega_n*b, d(d(omega_n)/dtau)/d(omega_tau), I3*s*omega3 + (2*I1)*omega_n*gamma3, a part of d(d(omega3)/dtau)/d(omega_tau), d(numerator of d(omega3)/dt over Theta)/d(s), d(d(omega3)/dtau)/d(s), d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s), d(d(omega_n)/dtau)/d(s), d(d(v_nu)/dtau)/d(omega_n), d(v_nu)/dtau, d(d(omega_n)/dtau)/d(omega_n), d(omega_n)/dtau" },
    .divergence = { divergence, 1, { 0, 8, 9, 1, 0, 0, 9, 7 }, { 10, 39, 0, 4, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, V = omega_tau*e + v_nu, a part of the divergence, a part of the divergence" },
    .integral_values = { integral_values, 2, { 0, 12, 9, 0, 0, 0, 7, 5 }, { 9, 31, 0, 0, 0, 0, 10, 5 },
        "digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = omega3*s*R + omega_n*b, energy/(1/2*m), G" },
    .integral_gradients = { integral_gradients, 12, { 0, 15, 7, 0, 0, 0, 5, 5 }, { 9, 37, 0, 0, 0, 0, 6, 6 },
        "digits are lost where terms nearly cancel in b = R*gamma3 + a3, v_tau = s*R*omega3 + omega_n*b, d(E)/d(s), d(E)/d(gamma3), d(E)/d(omega_n), d(E)/d(omega3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { observe_values, 1, { 1, 7, 4, 1, 0, 0, 8, 5 }, { 6, 25, 0, 4, 0, 0, 13, 5 },
        "digits are lost where terms nearly cancel in a part of contact_force, a part of contact_force" },
    .valid_values = { valid_values, 1, { 1, 7, 4, 1, 0, 0, 8, 5 }, { 6, 25, 0, 4, 0, 0, 13, 5 },
        "digits are lost where terms nearly cancel in a part of contact, a part of contact" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .observe_count = 1, .observes = observes,
    .valid_count = 1, .valids = valids,
    .pole_count = 1, .poles = poles,
    .lifted = lifted,
    .tier = "five", .tier_meaning = "the reduced system (3.2)",
    .way_count = 4, .ways = ways,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_general_in_regular) },
#endif
};
