/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23   13    1    0    0      7   10   (105)
 *  jacobian            12   66   31    1    0    0     13   20   (480)
 *  rhs_jacobian        15   69   33    1    0    0     12   22   (563)
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
 *      d(d(omega_n)/dtau)/d(omega_n), omega_n*omega_n - s*omega_tau*(m*a3^2/I1)*s*omega_tau, (m*R*I3)*e + I3^2,
 *      numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*((m*R*I3)*e + I3^2) - V*(m*I3)*omega_n*b,
 *      d(omega_n)/dtau, d(numerator of d(omega_n)/dt over Theta)/d(gamma3), a part of d(d(omega_n)/dtau)/d(gamma3),
 *      d(d(omega_n)/dtau)/d(gamma3), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s),
 *      m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)),
 *      a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s),
 *      d(numerator of d(omega3)/dt over Theta)/d(gamma3) = (m*R^2*(I1 - I3))*s*omega_tau*s*omega3 - s*omega_tau*omega_n*(m*R*a3*I1),
 *      a part of d(d(omega3)/dtau)/d(gamma3),
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*((m*R*I3)*e + I3^2) - e*(m*I3)*omega_n*b,
 *      a part of d(d(omega3)/dtau)/d(omega_tau), d(d(v_nu)/dtau)/d(omega_n), omega_n*b + R*s*omega3,
 *      d(d(omega_n)/dtau)/d(omega_tau), (2*I1)*omega_n*gamma3 + I3*s*omega3,
 *      d(numerator of d(omega_tau)/dt over D)/d(s), a part of d(d(omega_tau)/dtau)/d(s),
 *      d(numerator of d(omega3)/dt over Theta)/d(s), d(d(omega3)/dtau)/d(s), d(d(omega_n)/dtau)/d(s)
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
    const double t27 = -params[5]; /* -I3 */
    out[61] = t27;
    const double t28 = -t8; /* -I3/I1 */
    out[19] = t28;
    const double t29 = params[4]*params[4]; /* I1*I1 */
    const double t30 = params[5]*t25; /* I3*a3*a3*m*2 */
    const double t31 = t30/t29; /* I3*a3*a3*m*2/(I1*I1) */
    out[20] = t31;
    const double t32 = params[2]*t24; /* g*m*2 */
    const double t33 = params[3]*t32; /* a3*g*m*2 */
    out[46] = t33;
    const double t34 = t33/params[4]; /* a3*g*m*2/I1 */
    out[21] = t34;
    const double t35 = t17/t12; /* I3*a3/(R*I1) */
    out[22] = t35;
    const double t36 = params[1]*t29; /* R*I1*I1 */
    const double t37 = params[5]*params[5]; /* I3*I3 */
    out[39] = t37;
    const double t38 = 2.0*t37; /* 2*I3*I3 */
    const double t39 = t38/t36; /* 2*I3*I3/(R*I1*I1) */
    out[23] = t39;
    const double t40 = t1*t29; /* m*R*R*I1*I1 */
    const double t41 = params[5]*t37; /* I3*I3*I3 */
    const double t42 = 2.0*t41; /* 2*I3*I3*I3 */
    const double t43 = t42/t40; /* 2*I3*I3*I3/(m*R*R*I1*I1) */
    out[24] = t43;
    const double t44 = t1*params[4]; /* m*R*R*I1 */
    out[36] = t44;
    const double t45 = t37/t44; /* I3*I3/(m*R*R*I1) */
    out[25] = t45;
    const double t46 = params[5]*2.0; /* I3*2 */
    const double t47 = t46/t12; /* I3*2/(R*I1) */
    out[26] = t47;
    const double t48 = t38/t44; /* 2*I3*I3/(m*R*R*I1) */
    out[27] = t48;
    const double t49 = params[3]*2.0; /* a3*2 */
    const double t50 = params[5]*t49; /* I3*a3*2 */
    const double t51 = t50/t36; /* I3*a3*2/(R*I1*I1) */
    out[28] = t51;
    const double t52 = t19*2.0; /* (I1 - I3)*2 */
    const double t53 = t52/t29; /* (I1 - I3)*2/(I1*I1) */
    out[29] = t53;
    const double t54 = t19/params[4]; /* (I1 - I3)/I1 */
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
    const double t10 = x[2]*x[5]; /* omega_tau*s */
    const double t11 = x[0]*t10; /* gamma3*omega_tau*s */
    const double t12 = p[8]*t10; /* m*a3^2/I1*omega_tau*s */
    const double t13 = t11*t12; /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s */
    const double t14 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t15 = JLT_FMA(t4, p[9], t14); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t16 = JLT_FNMA(t0, p[10], t13); /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s - s*s*m*g*a3/I1 */
    const double t17 = JLT_FNMA(x[3], t15, t16); /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s - s*s*m*g*a3/I1 - omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t18 = JLT_FMA(t0, p[8], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t19 = t9*t18; /* Theta/(m*R^2*I1)*D/I1 */
    const double t20 = 1.0/t19; /* 1/(Theta/(m*R^2*I1)*D/I1) */
    const double t21 = t9*t17; /* Theta/(m*R^2*I1)*t17 */
    const double t22 = t20*t21; /* 1/(Theta/(m*R^2*I1)*D/I1)*Theta/(m*R^2*I1)*t17 */
    out[2] = t22;
    const double t23 = x[2]*t14; /* omega_tau*omega_n*gamma3 */
    const double t24 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t25 = p[12] + t24; /* I3/(m*R) + e */
    const double t26 = x[4]*t10; /* omega3*omega_tau*s */
    const double t27 = p[11]*t26; /* I3/(R*I1)*omega3*omega_tau*s */
    const double t28 = t25*t27; /* (I3/(m*R) + e)*I3/(R*I1)*omega3*omega_tau*s */
    const double t29 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t30 = x[3]*t29; /* omega_n*V */
    const double t31 = JLT_FNMA(t7, t30, t28); /* (I3/(m*R) + e)*I3/(R*I1)*omega3*omega_tau*s - b*I3/(R^2*I1)*omega_n*V */
    const double t32 = t18*t20; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t33 = JLT_FMA(t31, t32, t23); /* t31*1/(Theta/(m*R^2*I1)) + omega_tau*omega_n*gamma3 */
    out[3] = t33;
    const double t34 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/I1 - gamma3*R*(I1 - I3)/I1 */
    const double t35 = JLT_FMA(t26, t34, t30); /* omega3*omega_tau*s*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) + omega_n*V */
    const double t36 = x[5]*p[13]; /* s*(-1/R) */
    const double t37 = t35*t36; /* t35*s*(-1/R) */
    const double t38 = t32*t37; /* 1/(Theta/(m*R^2*I1))*t35*s*(-1/R) */
    out[4] = t38;
    const double t39 = -t11; /* -gamma3*omega_tau*s */
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
    const double t3 = x[3]*p[1]; /* omega_n*R */
    const double t4 = x[3]*t3; /* omega_n*omega_n*R */
    out[6] = t4;
    const double t5 = p[17] + x[0]; /* b/R = a3/R + gamma3 */
    const double t6 = x[3]*p[16]; /* omega_n*2*R */
    const double t7 = t5*t6; /* b/R*omega_n*2*R */
    const double t8 = x[5]*x[4]; /* s*omega3 */
    const double t9 = JLT_FMA(p[1], t8, t7); /* R*s*omega3 + b/R*omega_n*2*R */
    out[9] = t9;
    const double t10 = x[5]*t3; /* s*omega_n*R */
    out[10] = t10;
    const double t11 = t3*x[4]; /* omega_n*R*omega3 */
    out[11] = t11;
    const double t12 = t5*t5; /* b/R*b/R */
    const double t13 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t14 = JLT_FMA(p[9], t12, t13); /* Theta/(m*R^2*I1) = I3/I1*b/R*b/R + s*s + I3/(m*R^2) */
    const double t15 = JLT_FMA(t0, p[8], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t16 = t14*t15; /* Theta/(m*R^2*I1)*D/I1 */
    const double t17 = 1.0/t16; /* 1/(Theta/(m*R^2*I1)*D/I1) */
    const double t18 = t14*t17; /* 1/(D/I1) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t19 = x[5]*t18; /* s*1/(D/I1) */
    const double t20 = t1*t19; /* s*omega_tau*s*1/(D/I1) */
    const double t21 = x[2]*p[8]; /* omega_tau*m*a3^2/I1 */
    const double t22 = t20*t21; /* s*omega_tau*s*1/(D/I1)*omega_tau*m*a3^2/I1 */
    const double t23 = x[3]*t18; /* omega_n*1/(D/I1) */
    const double t24 = JLT_FNMA(x[3], t23, t22); /* s*omega_tau*s*1/(D/I1)*omega_tau*m*a3^2/I1 - omega_n*omega_n*1/(D/I1) */
    out[12] = t24;
    const double t25 = x[0]*p[18]; /* gamma3*2*m*a3^2/I1 */
    const double t26 = t20*t25; /* s*omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[14] = t26;
    const double t27 = 2.0*x[0]; /* 2*gamma3 */
    const double t28 = t23*t27; /* omega_n*1/(D/I1)*2*gamma3 */
    const double t29 = x[4]*p[9]; /* omega3*I3/I1 */
    const double t30 = JLT_FMA(t19, t29, t28); /* s*1/(D/I1)*omega3*I3/I1 + omega_n*1/(D/I1)*2*gamma3 */
    const double t31 = -t30; /* -(s*1/(D/I1)*omega3*I3/I1 + omega_n*1/(D/I1)*2*gamma3) */
    out[15] = t31;
    const double t32 = x[3]*t19; /* omega_n*s*1/(D/I1) */
    const double t33 = p[19]*t32; /* (-I3/I1)*omega_n*s*1/(D/I1) */
    out[16] = t33;
    const double t34 = t23*t29; /* omega_n*1/(D/I1)*omega3*I3/I1 */
    const double t35 = x[4]*p[20]; /* omega3*2*m*a3^2*I3/I1^2 */
    const double t36 = t32*t35; /* omega_n*s*1/(D/I1)*omega3*2*m*a3^2*I3/I1^2 */
    const double t37 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t38 = JLT_FMA(x[3], x[3], t37); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t39 = JLT_FNMA(t25, t38, p[21]); /* 2*m*g*a3/I1 - gamma3*2*m*a3^2/I1*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t40 = JLT_FNMA(t18, t39, t36); /* omega_n*s*1/(D/I1)*omega3*2*m*a3^2*I3/I1^2 - 1/(D/I1)*t39 */
    const double t41 = JLT_FMS(t19, t40, t34); /* s*1/(D/I1)*(omega_n*s*1/(D/I1)*omega3*2*m*a3^2*I3/I1^2 - 1/(D/I1)*t39) - omega_n*1/(D/I1)*omega3*I3/I1 */
    out[17] = t41;
    const double t42 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t43 = t15*t17; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t44 = t5*t43; /* b/R*1/(Theta/(m*R^2*I1)) */
    const double t45 = x[5]*t43; /* s*1/(Theta/(m*R^2*I1)) */
    const double t46 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t47 = t45*t46; /* s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t48 = JLT_FMS(t42, t44, t47); /* omega_tau*omega_n*b/R*1/(Theta/(m*R^2*I1)) - s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t49 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t50 = JLT_FMA(x[2], t49, x[1]); /* V = omega_tau*e + v_nu */
    const double t51 = x[3]*t50; /* omega_n*V */
    const double t52 = p[11]*t51; /* I3/(R*I1)*omega_n*V */
    const double t53 = t44*t51; /* b/R*1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t54 = JLT_FMS(t47, t49, t53); /* s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*e - b/R*1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t55 = t44*p[23]; /* b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2) */
    const double t56 = t44*p[24]; /* b/R*1/(Theta/(m*R^2*I1))*2*I3^3/(m*R^2*I1^2) */
    const double t57 = JLT_FNMA(t43, t52, t42); /* omega_tau*omega_n - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*omega_n*V */
    const double t58 = JLT_FNMA(t47, t56, t57); /* omega_tau*omega_n - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*omega_n*V - s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*b/R*1/(Theta/(m*R^2*I1))*2*I3^3/(m*R^2*I1^2) */
    const double t59 = JLT_FNMA(p[22], t48, t58); /* t58 - a3*I3/(R*I1)*t48 */
    const double t60 = JLT_FNMA(t54, t55, t59); /* t58 - a3*I3/(R*I1)*t48 - t54*b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2) */
    out[18] = t60;
    const double t61 = t44*p[11]; /* b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    const double t62 = x[3]*t61; /* omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    const double t63 = -t62; /* -omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    out[19] = t63;
    const double t64 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t65 = JLT_FMA(p[11], t49, p[25]); /* I3/(R*I1)*e + I3^2/(m*R^2*I1) */
    const double t66 = t45*t65; /* s*1/(Theta/(m*R^2*I1))*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    const double t67 = JLT_FMA(x[4], t66, t64); /* omega3*s*1/(Theta/(m*R^2*I1))*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) + omega_n*gamma3 */
    const double t68 = JLT_FNMA(t49, t62, t67); /* t67 - e*omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    out[20] = t68;
    const double t69 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t70 = JLT_FNMA(t50, t61, t69); /* omega_tau*gamma3 - V*b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    out[21] = t70;
    const double t71 = x[2]*t66; /* omega_tau*s*1/(Theta/(m*R^2*I1))*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    out[22] = t71;
    const double t72 = t46*t65; /* omega_tau*omega3*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    const double t73 = t43*t72; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    const double t74 = t45*p[26]; /* s*1/(Theta/(m*R^2*I1))*2*I3/(R*I1) */
    const double t75 = t45*p[27]; /* s*1/(Theta/(m*R^2*I1))*2*I3^2/(m*R^2*I1) */
    const double t76 = JLT_FNMA(t47, t75, t73); /* t73 - s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*s*1/(Theta/(m*R^2*I1))*2*I3^2/(m*R^2*I1) */
    const double t77 = JLT_FNMA(t54, t74, t76); /* t76 - t54*s*1/(Theta/(m*R^2*I1))*2*I3/(R*I1) */
    out[23] = t77;
    const double t78 = JLT_FNMA(x[0], p[29], p[28]); /* 2*a3*I3/(R*I1^2) - gamma3*2*(I1 - I3)/I1^2 */
    const double t79 = p[5]*t78; /* I3*(2*a3*I3/(R*I1^2) - gamma3*2*(I1 - I3)/I1^2) */
    const double t80 = t47*t79; /* s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*I3*(2*a3*I3/(R*I1^2) - gamma3*2*(I1 - I3)/I1^2) */
    const double t81 = t5*t80; /* b/R*t80 */
    const double t82 = JLT_FNMA(p[17], t42, t81); /* b/R*t80 - a3/R*omega_tau*omega_n */
    const double t83 = t53*t74; /* b/R*1/(Theta/(m*R^2*I1))*omega_n*V*s*1/(Theta/(m*R^2*I1))*2*I3/(R*I1) */
    const double t84 = x[5]*p[30]; /* s*(I1 - I3)/I1 */
    const double t85 = JLT_FMA(t47, t84, t83); /* s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*s*(I1 - I3)/I1 + t83 */
    const double t86 = JLT_FMA(t45, t82, t85); /* s*1/(Theta/(m*R^2*I1))*(b/R*t80 - a3/R*omega_tau*omega_n) + s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*s*(I1 - I3)/I1 + t83 */
    out[24] = t86;
    const double t87 = t45*p[31]; /* s*1/(Theta/(m*R^2*I1))*1/R */
    const double t88 = x[3]*t87; /* omega_n*s*1/(Theta/(m*R^2*I1))*1/R */
    const double t89 = -t88; /* -omega_n*s*1/(Theta/(m*R^2*I1))*1/R */
    out[25] = t89;
    const double t90 = t49*t88; /* e*omega_n*s*1/(Theta/(m*R^2*I1))*1/R */
    const double t91 = JLT_FNMA(x[0], p[30], p[22]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t92 = t45*t91; /* s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t93 = JLT_FMA(t8, t92, t90); /* s*omega3*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + e*omega_n*s*1/(Theta/(m*R^2*I1))*1/R */
    const double t94 = -t93; /* -t93 */
    out[26] = t94;
    const double t95 = t50*t87; /* V*s*1/(Theta/(m*R^2*I1))*1/R */
    const double t96 = -t95; /* -V*s*1/(Theta/(m*R^2*I1))*1/R */
    out[27] = t96;
    const double t97 = t1*t92; /* s*omega_tau*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t98 = -t97; /* -t97 */
    out[28] = t98;
    const double t99 = t12 + p[32]; /* b/R*b/R + I1/(m*R^2) */
    const double t100 = t80*t99; /* t80*(b/R*b/R + I1/(m*R^2)) */
    const double t101 = JLT_FMA(t51, p[31], t100); /* omega_n*V*1/R + t80*(b/R*b/R + I1/(m*R^2)) */
    const double t102 = t43*t101; /* 1/(Theta/(m*R^2*I1))*(omega_n*V*1/R + t80*(b/R*b/R + I1/(m*R^2))) */
    const double t103 = t51*p[33]; /* omega_n*V*2/R */
    const double t104 = t45*t103; /* s*1/(Theta/(m*R^2*I1))*omega_n*V*2/R */
    const double t105 = JLT_FMS(t45, t104, t102); /* s*1/(Theta/(m*R^2*I1))*s*1/(Theta/(m*R^2*I1))*omega_n*V*2/R - t102 */
    out[29] = t105;
    const double t106 = -t1; /* -s*omega_tau */
    out[30] = t106;
    const double t107 = x[5]*x[0]; /* s*gamma3 */
    const double t108 = -t107; /* -s*gamma3 */
    out[32] = t108;
    const double t109 = -t69; /* -omega_tau*gamma3 */
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
    const double t20 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t21 = JLT_FNMA(t9, t19, t20); /* omega_tau*gamma3 - 1/Theta*m*I3*b*V */
    out[27] = t21;
    const double t22 = -t20; /* -omega_tau*gamma3 */
    out[41] = t22;
    const double t23 = p[37]*t16; /* m*I3*omega_n*b */
    const double t24 = x[4]*t12; /* omega3*s*omega_tau */
    const double t25 = x[3]*t18; /* omega_n*V */
    const double t26 = x[5]*x[4]; /* s*omega3 */
    const double t27 = x[3]*x[3]; /* omega_n*omega_n */
    const double t28 = p[8]*t12; /* m*a3^2/I1*s*omega_tau */
    const double t29 = JLT_FNMA(t12, t28, t27); /* omega_n*omega_n - s*omega_tau*m*a3^2/I1*s*omega_tau */
    const double t30 = p[4]*t29; /* I1*(omega_n*omega_n - s*omega_tau*m*a3^2/I1*s*omega_tau) */
    const double t31 = t18*t23; /* V*m*I3*omega_n*b */
    const double t32 = JLT_FMA(p[40], t11, p[39]); /* m*R*I3*e + I3^2 */
    const double t33 = JLT_FMS(t24, t32, t31); /* numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*(m*R*I3*e + I3^2) - V*m*I3*omega_n*b */
    const double t34 = t9*t33; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t35 = JLT_FMA(x[3], t20, t34); /* omega_n*omega_tau*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t35;
    const double t36 = p[44]*t20; /* 2*m*a3^2*omega_tau*gamma3 */
    const double t37 = t12*t36; /* s*omega_tau*2*m*a3^2*omega_tau*gamma3 */
    const double t38 = JLT_FNMA(x[5], p[46], t37); /* s*omega_tau*2*m*a3^2*omega_tau*gamma3 - s*2*m*g*a3 */
    const double t39 = p[41]*t25; /* m*R*I1*omega_n*V */
    const double t40 = p[42]*t24; /* m*R*a3*I3*omega3*s*omega_tau */
    const double t41 = x[2]*p[47]; /* omega_tau*m*a3*I3 */
    const double t42 = JLT_FNMA(t16, t41, t40); /* m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 */
    const double t43 = JLT_FNMA(p[40], t25, t42); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 - m*R*I3*omega_n*V */
    const double t44 = JLT_FNMA(t17, t34, t43); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) - 2*m*R*I3*b*1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t45 = t9*t44; /* 1/Theta*t44 */
    const double t46 = JLT_FMA(x[2], x[3], t45); /* omega_tau*omega_n + 1/Theta*t44 */
    out[24] = t46;
    const double t47 = x[5]*t9; /* s*1/Theta */
    const double t48 = p[5]*t26; /* I3*s*omega3 */
    const double t49 = JLT_FMA(x[3], t48, t6); /* omega_n*I3*s*omega3 + m*g*a3*s*s */
    const double t50 = JLT_FMA(x[0], t30, t49); /* gamma3*I1*(omega_n*omega_n - s*omega_tau*m*a3^2/I1*s*omega_tau) + omega_n*I3*s*omega3 + m*g*a3*s*s */
    const double t51 = t10*t30; /* 1/D*I1*(omega_n*omega_n - s*omega_tau*m*a3^2/I1*s*omega_tau) */
    const double t52 = -t51; /* -1/D*I1*(omega_n*omega_n - s*omega_tau*m*a3^2/I1*s*omega_tau) */
    out[18] = t52;
    const double t53 = x[5]*t39; /* s*m*R*I1*omega_n*V */
    const double t54 = JLT_FNMA(x[0], p[43], p[42]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t55 = t12*t26; /* s*omega_tau*s*omega3 */
    const double t56 = JLT_FMA(t54, t55, t53); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*omega_tau*s*omega3 + s*m*R*I1*omega_n*V */
    const double t57 = t9*t56; /* 1/Theta*t56 */
    const double t58 = t47*t54; /* s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t59 = -t57; /* -1/Theta*t56 */
    out[4] = t59;
    const double t60 = x[3]*p[50]; /* omega_n*m*R*a3*I1 */
    const double t61 = t12*t60; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t62 = JLT_FMS(p[43], t55, t61); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = m*R^2*(I1 - I3)*s*omega_tau*s*omega3 - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t63 = JLT_FMA(t17, t57, t62); /* 2*m*R*I3*b*1/Theta*t56 + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t64 = t9*t63; /* 1/Theta*t63 */
    out[30] = t64;
    const double t65 = p[41]*t47; /* m*R*I1*s*1/Theta */
    const double t66 = p[49]*t47; /* 2*m*R^2*I1*s*1/Theta */
    const double t67 = t18*t65; /* V*m*R*I1*s*1/Theta */
    const double t68 = -t67; /* -V*m*R*I1*s*1/Theta */
    out[33] = t68;
    const double t69 = x[3]*t65; /* omega_n*m*R*I1*s*1/Theta */
    const double t70 = t57*t66; /* 1/Theta*t56*2*m*R^2*I1*s*1/Theta */
    const double t71 = -t69; /* -omega_n*m*R*I1*s*1/Theta */
    out[31] = t71;
    const double t72 = t11*t69; /* e*omega_n*m*R*I1*s*1/Theta */
    const double t73 = t11*t23; /* e*m*I3*omega_n*b */
    const double t74 = t9*t23; /* 1/Theta*m*I3*omega_n*b */
    const double t75 = -t74; /* -1/Theta*m*I3*omega_n*b */
    out[25] = t75;
    const double t76 = JLT_FMS(t26, t32, t73); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(m*R*I3*e + I3^2) - e*m*I3*omega_n*b */
    const double t77 = t9*t32; /* 1/Theta*(m*R*I3*e + I3^2) */
    const double t78 = JLT_FMA(t26, t58, t72); /* s*omega3*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*omega_n*m*R*I1*s*1/Theta */
    const double t79 = -t78; /* -t78 */
    out[32] = t79;
    const double t80 = p[1]*t26; /* R*s*omega3 */
    const double t81 = t12*t58; /* s*omega_tau*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t82 = -t81; /* -s*omega_tau*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[34] = t82;
    const double t83 = JLT_FMA(2.0, t16, t80); /* 2*omega_n*b + R*s*omega3 */
    out[15] = t83;
    const double t84 = t16 + t80; /* omega_n*b + R*s*omega3 */
    const double t85 = x[3]*t84; /* omega_n*(omega_n*b + R*s*omega3) */
    out[1] = t85;
    const double t86 = t12*t77; /* s*omega_tau*1/Theta*(m*R*I3*e + I3^2) */
    out[28] = t86;
    const double t87 = x[0]*t12; /* gamma3*s*omega_tau */
    const double t88 = -t87; /* -gamma3*s*omega_tau */
    out[5] = t88;
    const double t89 = x[5]*t10; /* s*1/D */
    const double t90 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t91 = JLT_FMA(t9, t76, t90); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[26] = t91;
    const double t92 = JLT_FMA(p[45], t90, t48); /* 2*I1*omega_n*gamma3 + I3*s*omega3 */
    const double t93 = t10*t92; /* 1/D*(2*I1*omega_n*gamma3 + I3*s*omega3) */
    const double t94 = -t93; /* -1/D*(2*I1*omega_n*gamma3 + I3*s*omega3) */
    out[21] = t94;
    const double t95 = x[3]*p[5]; /* omega_n*I3 */
    const double t96 = JLT_FNMA(x[4], t95, t38); /* d(numerator of d(omega_tau)/dt over D)/d(s) = s*omega_tau*2*m*a3^2*omega_tau*gamma3 - s*2*m*g*a3 - omega3*omega_n*I3 */
    const double t97 = t89*t95; /* s*1/D*omega_n*I3 */
    const double t98 = -t97; /* -s*1/D*omega_n*I3 */
    out[22] = t98;
    const double t99 = p[44]*t89; /* 2*m*a3^2*s*1/D */
    const double t100 = t87*t99; /* gamma3*s*omega_tau*2*m*a3^2*s*1/D */
    out[20] = t100;
    const double t101 = JLT_FMA(t50, t99, t96); /* t50*2*m*a3^2*s*1/D + d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t102 = t10*t101; /* 1/D*t101 */
    out[23] = t102;
    const double t103 = t10*t50; /* 1/D*t50 */
    const double t104 = -t103; /* -1/D*t50 */
    out[2] = t104;
    const double t105 = x[0]*p[51]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t106 = JLT_FMS(t24, t105, t39); /* omega3*s*omega_tau*gamma3*2*m*R^2*(I1 - I3) - m*R*I1*omega_n*V */
    const double t107 = JLT_FNMA(p[52], t24, t106); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t106 - 2*m*R*a3*I3*omega3*s*omega_tau */
    const double t108 = JLT_FMA(t9, t107, t70); /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) + 1/Theta*t56*2*m*R^2*I1*s*1/Theta */
    out[35] = t108;
    const double t109 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t110 = t77*t109; /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 */
    const double t111 = JLT_FNMA(t34, t66, t110); /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    out[29] = t111;
    const double t112 = x[3]*p[1]; /* omega_n*R */
    const double t113 = x[3]*t112; /* omega_n*omega_n*R */
    out[12] = t113;
    const double t114 = x[5]*t112; /* s*omega_n*R */
    out[16] = t114;
    const double t115 = x[4]*t112; /* omega3*omega_n*R */
    out[17] = t115;
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
    const double t6 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t7 = JLT_FMA(x[3], x[3], t6); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t8 = JLT_FMA(x[0], t7, t5); /* gamma3*(omega_n*omega_n + omega_tau*omega_tau) + s*I3/I1*omega_n*omega3 + m*g*a3/I1*s*s */
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
    const double t6 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t7 = JLT_FMA(x[3], x[3], t6); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t8 = JLT_FMA(x[0], t7, t5); /* gamma3*(omega_n*omega_n + omega_tau*omega_tau) + s*I3/I1*omega_n*omega3 + m*g*a3/I1*s*s */
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
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
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
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
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
        t15[k] = jlt_jet_product(x5, x5, k);
        t17[k] = t8[k]*p[7];
        t18[k] = (k == 0 ? p[6] : 0) + t15[k];
        t19[k] = jlt_jet_product(t8, t17, k) + t18[k];
        t21[k] = jlt_jet_product(t2, x0, k);
        t22[k] = t2[k]*p[8];
        t23[k] = jlt_jet_product(t21, t22, k);
        t26[k] = jlt_jet_product(x3, x0, k);
        t27[k] = t11[k]*p[9] + t26[k];
        t28[k] = t23[k] - t15[k]*p[10];
        t29[k] = t28[k] - jlt_jet_product(x3, t27, k);
        t31[k] = t15[k]*p[8] + (k == 0 ? 1.0 : 0);
        t32[k] = jlt_jet_product(t19, t31, k);
        t33[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t32, t33, k);
        t34[k] = jlt_jet_product(t19, t29, k);
        t35[k] = jlt_jet_product(t33, t34, k);
        t36[k] = jlt_jet_product(x2, t26, k);
        t39[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t40[k] = (k == 0 ? p[12] : 0) + t39[k];
        t41[k] = jlt_jet_product(t2, x4, k);
        t42[k] = p[11]*t41[k];
        t43[k] = jlt_jet_product(t40, t42, k);
        t45[k] = jlt_jet_product(x2, t39, k) + x1[k];
        t46[k] = jlt_jet_product(x3, t45, k);
        t47[k] = t43[k] - jlt_jet_product(t17, t46, k);
        t48[k] = jlt_jet_product(t31, t33, k);
        t49[k] = jlt_jet_product(t47, t48, k) + t36[k];
        t53[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t54[k] = jlt_jet_product(t41, t53, k) + t46[k];
        t55[k] = x5[k]*p[13];
        t56[k] = jlt_jet_product(t54, t55, k);
        t57[k] = jlt_jet_product(t48, t56, k);
        t58[k] = -t21[k];
        double *restrict next = coefficients + (k + 1)*7;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t13[k]/(k + 1);
        next[2] = x2[k + 1] = t35[k]/(k + 1);
        next[3] = x3[k + 1] = t49[k]/(k + 1);
        next[4] = x4[k + 1] = t57[k]/(k + 1);
        next[5] = x5[k + 1] = t58[k]/(k + 1);
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
    .sha256 = "ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 63,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 6, { 3, 23, 13, 1, 0, 0, 7, 10 }, { 17, 78, 0, 10, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, R*s*omega3 + omega_n*b, s*omega3*(I3/I1) + omega_n*gamma3, a part of d(omega_tau)/dtau, e = a3*gamma3 + R, I3/(m*R) + e, V = omega_tau*e + v_nu, a part of d(omega_n)/dtau, d(omega_n)/dtau, a3*I3/I1 - gamma3*(R*(I1 - I3)/I1), omega3*omega_tau*s*(a3*I3/I1 - gamma3*(R*(I1 - I3)/I1)) + omega_n*V" },
    .jacobian = { jacobian, 36, { 12, 66, 31, 1, 0, 0, 13, 20 }, { 56, 375, 0, 49, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, d(d(v_nu)/dtau)/d(omega_n), d(d(omega_tau)/dtau)/d(gamma3), s*1/(D/I1)*omega3*(I3/I1) + omega_n*1/(D/I1)*(2)*gamma3, a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_n)/dtau)/d(gamma3), e = gamma3*a3 + R, V = omega_tau*e + v_nu, a part of d(d(omega_n)/dtau)/d(gamma3) and of d(d(omega_n)/dtau)/d(s), d(d(omega_n)/dtau)/d(gamma3), (I3/(R*I1))*e + I3^2/(m*R^2*I1), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(s), 2*a3*I3/(R*I1^2) - gamma3*(2*(I1 - I3)/I1^2), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(gamma3), a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(d(omega3)/dtau)/d(omega_tau), a part of d(d(omega3)/dtau)/d(s), d(d(omega3)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 42, { 15, 69, 33, 1, 0, 0, 12, 22 }, { 67, 437, 0, 59, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, V = omega_tau*e + v_nu, d(d(omega_n)/dtau)/d(omega_n), omega_n*omega_n - s*omega_tau*(m*a3^2/I1)*s*omega_tau, (m*R*I3)*e + I3^2, numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*((m*R*I3)*e + I3^2) - V*(m*I3)*omega_n*b, d(omega_n)/dtau, d(numerator of d(omega_n)/dt over Theta)/d(gamma3), a part of d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(gamma3), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s), d(numerator of d(omega3)/dt over Theta)/d(gamma3) = (m*R^2*(I1 - I3))*s*omega_tau*s*omega3 - s*omega_tau*omega_n*(m*R*a3*I1), a part of d(d(omega3)/dtau)/d(gamma3), d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*((m*R*I3)*e + I3^2) - e*(m*I3)*omega_n*b, a part of d(d(omega3)/dtau)/d(omega_tau), d(d(v_nu)/dtau)/d(omega_n), omega_n*b + R*s*omega3, d(d(omega_n)/dtau)/d(omega_tau), (2*I1)*omega_n*gamma3 + I3*s*omega3, d(numerator of d(omega_tau)/dt over D)/d(s), a part of d(d(omega_tau)/dtau)/d(s), d(numerator of d(omega3)/dt over Theta)/d(s), d(d(omega3)/dtau)/d(s), d(d(omega_n)/dtau)/d(s)" },
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
    .observe_count = 1, .observes = observes,
    .valid_count = 1, .valids = valids,
    .pole_count = 1, .poles = poles,
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_general_in_regular_baseline,
        &jlt_batch_spherical_top_general_in_regular_avx2,
        &jlt_batch_spherical_top_general_in_regular_avx512,
    },
#endif
};
