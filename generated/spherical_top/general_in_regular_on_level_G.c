/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   24   11    1    0    0     12   11   (89)
 *  jacobian            11   60   25    1    0    0     13   16   (423)
 *  rhs_jacobian        10   60   28    1    0    0     17   18   (484)
 *  divergence          0    8   10    1    0    0      9    8   (55)
 *  integral_values     1   11    8    1    0    0      7    7   (40)
 *  integral_gradients  0   16   13    1    0    0      7   10   (76)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          1    2    1    1    0    0      4    3   (8)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level,
 *      e = gamma3*a3 + R,
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s),
 *      V = omega_tau*e + v_nu, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)),
 *      a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s),
 *      b/R*(m*R*I3)*V + s*s*omega_tau*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))),
 *      (m*R*I3)*V - (m*R^2*(I1 - I3))*s*s*omega_tau, a part of d(d(omega3)/dtau)/d(omega_tau),
 *      numerator of d(omega_tau)/dt over D,
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(omega3),
 *      b/R*1/s*(b/R*(R*I3)*omega3 + G_level)*(2/(R*I1))*1/s + omega3, a part of d(d(omega_tau)/dtau)/d(omega3),
 *      d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(d(v_nu)/dtau)/d(gamma3),
 *      d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s), a part of d(d(omega3)/dtau)/d(gamma3),
 *      d(v_nu)/dtau, d(d(v_nu)/dtau)/d(omega3), a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(d(omega3)/dtau)/d(s)
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
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = 1.0/params[4]; /* 1/I1 */
    out[7] = t0;
    const double t1 = params[3]/params[1]; /* a3/R */
    out[8] = t1;
    const double t2 = params[1]*params[5]; /* R*I3 */
    out[9] = t2;
    const double t3 = params[4]*params[1]; /* I1*R */
    const double t4 = 1.0/t3; /* 1/(I1*R) */
    out[10] = t4;
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[11] = t6;
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = params[0]*t7; /* m*R*R */
    const double t9 = params[5]/t8; /* I3/(m*R*R) */
    out[12] = t9;
    const double t10 = params[5]/params[4]; /* I3/I1 */
    out[13] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[3]*t11; /* a3*m*g */
    out[14] = t12;
    const double t13 = params[4]*t7; /* I1*R*R */
    out[56] = t13;
    const double t14 = 1.0/t13; /* 1/(I1*R*R) */
    out[15] = t14;
    const double t15 = params[3]*params[5]; /* a3*I3 */
    const double t16 = t15/t3; /* a3*I3/(I1*R) */
    out[16] = t16;
    const double t17 = params[4] - params[5]; /* I1 - I3 */
    const double t18 = t17/params[4]; /* (I1 - I3)/I1 */
    out[17] = t18;
    const double t19 = params[4]*params[4]; /* I1*I1 */
    const double t20 = params[1]*t19; /* R*I1*I1 */
    const double t21 = 1.0/t20; /* 1/(R*I1*I1) */
    out[18] = t21;
    const double t22 = params[5]*2.0; /* I3*2 */
    const double t23 = t22/t19; /* I3*2/(I1*I1) */
    out[19] = t23;
    const double t24 = t3/2.0; /* I1*R/2 */
    out[20] = t24;
    const double t25 = (-2.0)/t20; /* (-2)/(R*I1*I1) */
    out[21] = t25;
    const double t26 = params[5]*params[5]; /* I3*I3 */
    const double t27 = t26/params[4]; /* I3*I3/I1 */
    out[22] = t27;
    const double t28 = t22/t3; /* I3*2/(I1*R) */
    out[23] = t28;
    const double t29 = params[0]*2.0; /* m*2 */
    const double t30 = t5*t29; /* a3*a3*m*2 */
    out[24] = t30;
    const double t31 = params[5]/t3; /* I3/(I1*R) */
    out[25] = t31;
    const double t32 = params[3]*params[0]; /* a3*m */
    out[26] = t32;
    const double t33 = params[2]*2.0; /* g*2 */
    const double t34 = params[4]*t33; /* I1*g*2 */
    out[27] = t34;
    const double t35 = params[3]*2.0; /* a3*2 */
    const double t36 = params[5]*t35; /* I3*a3*2 */
    const double t37 = t36/t3; /* I3*a3*2/(I1*R) */
    out[28] = t37;
    const double t38 = params[4]*t35; /* I1*a3*2 */
    out[29] = t38;
    const double t39 = t7*t19; /* R*R*I1*I1 */
    const double t40 = 1.0/t39; /* 1/(R*R*I1*I1) */
    out[30] = t40;
    const double t41 = 2.0/t13; /* 2/(I1*R*R) */
    out[31] = t41;
    const double t42 = params[3]/t13; /* a3/(I1*R*R) */
    out[32] = t42;
    const double t43 = t22/t39; /* I3*2/(R*R*I1*I1) */
    out[33] = t43;
    const double t44 = t26*t35; /* I3*I3*a3*2 */
    const double t45 = t44/t20; /* I3*I3*a3*2/(R*I1*I1) */
    out[34] = t45;
    const double t46 = t17*t22; /* (I1 - I3)*I3*2 */
    const double t47 = t46/t19; /* (I1 - I3)*I3*2/(I1*I1) */
    out[35] = t47;
    const double t48 = params[4]/t8; /* I1/(m*R*R) */
    out[36] = t48;
    const double t49 = params[4]*params[5]; /* I1*I3 */
    out[37] = t49;
    const double t50 = params[4]*t8; /* I1*m*R*R */
    out[38] = t50;
    const double t51 = params[5]*t8; /* I3*m*R*R */
    out[39] = t51;
    const double t52 = t5*t8; /* a3*a3*m*R*R */
    const double t53 = params[4]*t52; /* I1*a3*a3*m*R*R */
    out[40] = t53;
    const double t54 = params[1]*params[0]; /* R*m */
    const double t55 = params[3]*t54; /* a3*R*m */
    const double t56 = params[5]*t55; /* I3*a3*R*m */
    out[41] = t56;
    const double t57 = t8*t17; /* m*R*R*(I1 - I3) */
    out[42] = t57;
    const double t58 = t2/params[4]; /* R*I3/I1 */
    out[43] = t58;
    const double t59 = 2.0/t3; /* 2/(I1*R) */
    out[44] = t59;
    const double t60 = params[2]*t29; /* g*m*2 */
    const double t61 = params[3]*t60; /* a3*g*m*2 */
    out[45] = t61;
    const double t62 = t7*t29; /* R*R*m*2 */
    const double t63 = params[5]*t62; /* I3*R*R*m*2 */
    out[46] = t63;
    const double t64 = params[5]*t54; /* I3*R*m */
    out[47] = t64;
    const double t65 = params[4]*t62; /* I1*R*R*m*2 */
    out[48] = t65;
    const double t66 = params[5]*params[0]; /* I3*m */
    out[49] = t66;
    const double t67 = params[0]/2.0; /* m/2 */
    out[50] = t67;
    const double t68 = params[3]*t33; /* a3*g*2 */
    out[51] = t68;
    const double t69 = 1.0/params[0]; /* 1/m */
    out[52] = t69;
    const double t70 = 1.0/t50; /* 1/(I1*m*R*R) */
    out[53] = t70;
    const double t71 = params[5]/params[0]; /* I3/m */
    out[54] = t71;
    const double t72 = params[0]/t20; /* m/(R*I1*I1) */
    out[55] = t72;
    const double t73 = params[5]/t13; /* I3/(I1*R*R) */
    out[57] = t73;
    const double t74 = params[0]/params[4]; /* m/I1 */
    out[58] = t74;
    const double t75 = t6/params[4]; /* m*a3*a3/I1 */
    out[59] = t75;
    const double t76 = t12/params[4]; /* a3*m*g/I1 */
    out[60] = t76;
    const double t77 = (-1.0)/params[1]; /* (-1)/R */
    out[61] = t77;
    const double t78 = t15/params[4]; /* a3*I3/I1 */
    out[62] = t78;
    const double t79 = params[1]*t17; /* R*(I1 - I3) */
    const double t80 = t79/params[4]; /* R*(I1 - I3)/I1 */
    out[63] = t80;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t1;
    const double t2 = p[8] + x[0]; /* b/R = a3/R + gamma3 */
    const double t3 = p[9]*x[3]; /* R*I3*omega3 */
    const double t4 = JLT_FMA(t2, t3, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t5 = JLT_FMA(t0, p[11], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t2*p[13]; /* b/R*I3/I1 */
    const double t7 = t0 + p[12]; /* s*s + I3/(m*R^2) */
    const double t8 = JLT_FMA(t2, t6, t7); /* Theta/(m*R^2*I1) = b/R*b/R*I3/I1 + s*s + I3/(m*R^2) */
    const double t9 = x[4]*t5; /* s*D */
    const double t10 = t8*t9; /* Theta/(m*R^2*I1)*s*D */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s*D) */
    const double t12 = t8*t11; /* 1/(s*D) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D) */
    const double t13 = t5*t12; /* 1/s = D*1/(s*D) */
    const double t14 = t4*t13; /* (b/R*R*I3*omega3 + G_level)*1/s */
    const double t15 = t13*t14; /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t16 = t2*p[10]; /* b/R*1/(R*I1) */
    const double t17 = JLT_FMA(t15, t16, x[3]); /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s*b/R*1/(R*I1) + omega3 */
    const double t18 = p[7]*t4; /* 1/I1*(b/R*R*I3*omega3 + G_level) */
    const double t19 = t17*t18; /* (1/s*(b/R*R*I3*omega3 + G_level)*1/s*b/R*1/(R*I1) + omega3)*1/I1*(b/R*R*I3*omega3 + G_level) */
    out[1] = t19;
    const double t20 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t21 = p[11]*t20; /* m*a3^2*omega_tau*gamma3 */
    const double t22 = t1*t21; /* omega_tau*s*s*m*a3^2*omega_tau*gamma3 */
    const double t23 = JLT_FMA(x[0], t15, t3); /* gamma3*1/s*(b/R*R*I3*omega3 + G_level)*1/s + R*I3*omega3 */
    const double t24 = t4*p[15]; /* (b/R*R*I3*omega3 + G_level)*1/(R^2*I1) */
    const double t25 = JLT_FNMA(t0, p[14], t22); /* omega_tau*s*s*m*a3^2*omega_tau*gamma3 - s*s*m*g*a3 */
    const double t26 = JLT_FNMA(t23, t24, t25); /* omega_tau*s*s*m*a3^2*omega_tau*gamma3 - s*s*m*g*a3 - (gamma3*1/s*(b/R*R*I3*omega3 + G_level)*1/s + R*I3*omega3)*(b/R*R*I3*omega3 + G_level)*1/(R^2*I1) */
    const double t27 = x[4]*t12; /* s*1/(s*D) */
    const double t28 = t26*t27; /* t26*s*1/(s*D) */
    out[2] = t28;
    const double t29 = JLT_FNMA(x[0], p[17], p[16]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t30 = t1*x[3]; /* omega_tau*s*s*omega3 */
    const double t31 = t29*t30; /* (a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*omega_tau*s*s*omega3 */
    const double t32 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t33 = JLT_FMA(x[2], t32, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = JLT_FMA(t24, t33, t31); /* (b/R*R*I3*omega3 + G_level)*1/(R^2*I1)*V + (a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*omega_tau*s*s*omega3 */
    const double t35 = t9*t34; /* s*D*t34 */
    const double t36 = t11*t35; /* 1/(Theta/(m*R^2*I1)*s*D)*s*D*t34 */
    const double t37 = -t36; /* -1/(Theta/(m*R^2*I1)*s*D)*s*D*t34 */
    out[3] = t37;
    const double t38 = x[4]*t20; /* s*omega_tau*gamma3 */
    const double t39 = -t38; /* -s*omega_tau*gamma3 */
    out[4] = t39;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[21] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[2] = t0;
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[4] = t2;
    const double t3 = p[8] + x[0]; /* b/R = a3/R + gamma3 */
    const double t4 = p[9]*x[3]; /* R*I3*omega3 */
    const double t5 = JLT_FMA(t3, t4, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t6 = JLT_FMA(t0, p[11], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t7 = t3*t3; /* b/R*b/R */
    const double t8 = t0 + p[12]; /* s*s + I3/(m*R^2) */
    const double t9 = JLT_FMA(p[13], t7, t8); /* Theta/(m*R^2*I1) = I3/I1*b/R*b/R + s*s + I3/(m*R^2) */
    const double t10 = x[4]*t6; /* s*D */
    const double t11 = t9*t10; /* Theta/(m*R^2*I1)*s*D */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*s*D) */
    const double t13 = t9*t12; /* 1/(s*D) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D) */
    const double t14 = t6*t13; /* 1/s = D*1/(s*D) */
    const double t15 = t5*t14; /* (b/R*R*I3*omega3 + G_level)*1/s */
    const double t16 = t15*t15; /* (b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t17 = p[18]*t16; /* 1/(R*I1^2)*t16 */
    const double t18 = t14*t15; /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t19 = t3*t18; /* b/R*1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t20 = JLT_FMA(x[3], p[20], t19); /* omega3*1/2*R*I1 + b/R*1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t21 = p[19]*t20; /* 2*I3/I1^2*(omega3*1/2*R*I1 + b/R*1/s*(b/R*R*I3*omega3 + G_level)*1/s) */
    const double t22 = JLT_FMA(x[3], t21, t17); /* omega3*t21 + 1/(R*I1^2)*t16 */
    out[5] = t22;
    const double t23 = t5*p[7]; /* (b/R*R*I3*omega3 + G_level)*1/I1 */
    const double t24 = JLT_FMA(t3, t21, t23); /* b/R*t21 + (b/R*R*I3*omega3 + G_level)*1/I1 */
    out[8] = t24;
    const double t25 = t14*t16; /* 1/s*t16 */
    const double t26 = t3*p[21]; /* b/R*(-2/(R*I1^2)) */
    const double t27 = t25*t26; /* 1/s*t16*b/R*(-2/(R*I1^2)) */
    out[9] = t27;
    const double t28 = t0*x[2]; /* s*s*omega_tau */
    const double t29 = x[2]*p[11]; /* omega_tau*m*a3^2 */
    const double t30 = t28*t29; /* s*s*omega_tau*omega_tau*m*a3^2 */
    const double t31 = x[3]*p[22]; /* omega3*I3^2/I1 */
    const double t32 = x[0]*p[23]; /* gamma3*2*I3/(R*I1) */
    const double t33 = JLT_FMA(t18, t32, t31); /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s*gamma3*2*I3/(R*I1) + omega3*I3^2/I1 */
    const double t34 = JLT_FNMA(t16, p[15], t30); /* s*s*omega_tau*omega_tau*m*a3^2 - t16*1/(R^2*I1) */
    const double t35 = JLT_FNMA(x[3], t33, t34); /* s*s*omega_tau*omega_tau*m*a3^2 - t16*1/(R^2*I1) - omega3*t33 */
    const double t36 = x[4]*t13; /* 1/D = s*1/(s*D) */
    const double t37 = t35*t36; /* (s*s*omega_tau*omega_tau*m*a3^2 - t16*1/(R^2*I1) - omega3*t33)*1/D */
    out[10] = t37;
    const double t38 = x[0]*t36; /* gamma3*1/D */
    const double t39 = t28*p[24]; /* s*s*omega_tau*2*m*a3^2 */
    const double t40 = t38*t39; /* gamma3*1/D*s*s*omega_tau*2*m*a3^2 */
    out[12] = t40;
    const double t41 = t5*p[25]; /* (b/R*R*I3*omega3 + G_level)*I3/(R*I1) */
    const double t42 = JLT_FMA(t3, t33, t41); /* b/R*t33 + (b/R*R*I3*omega3 + G_level)*I3/(R*I1) */
    const double t43 = t36*t42; /* 1/D*(b/R*t33 + (b/R*R*I3*omega3 + G_level)*I3/(R*I1)) */
    const double t44 = -t43; /* -1/D*(b/R*t33 + (b/R*R*I3*omega3 + G_level)*I3/(R*I1)) */
    out[13] = t44;
    const double t45 = x[3]*p[28]; /* omega3*2*a3*I3/(R*I1) */
    const double t46 = JLT_FNMA(t5, t45, p[27]); /* 2*g*I1 - (b/R*R*I3*omega3 + G_level)*omega3*2*a3*I3/(R*I1) */
    const double t47 = t36*t46; /* 1/D*(2*g*I1 - (b/R*R*I3*omega3 + G_level)*omega3*2*a3*I3/(R*I1)) */
    const double t48 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t49 = JLT_FMA(t16, p[30], t48); /* t16*1/(R^2*I1^2) + omega_tau*omega_tau */
    const double t50 = t38*p[29]; /* gamma3*1/D*2*a3*I1 */
    const double t51 = JLT_FNMA(t49, t50, t47); /* t47 - (t16*1/(R^2*I1^2) + omega_tau*omega_tau)*gamma3*1/D*2*a3*I1 */
    const double t52 = x[4]*p[26]; /* s*m*a3 */
    const double t53 = t36*t52; /* 1/D*s*m*a3 */
    const double t54 = t51*t53; /* t51*1/D*s*m*a3 */
    const double t55 = t38*p[31]; /* gamma3*1/D*2/(R^2*I1) */
    const double t56 = JLT_FMS(t25, t55, t54); /* 1/s*t16*gamma3*1/D*2/(R^2*I1) - t51*1/D*s*m*a3 */
    out[14] = t56;
    const double t57 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = s*D*1/(Theta/(m*R^2*I1)*s*D) */
    const double t58 = t5*t57; /* (b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1)) */
    const double t59 = x[2]*p[32]; /* omega_tau*a3/(R^2*I1) */
    const double t60 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t61 = JLT_FMA(x[2], t60, x[1]); /* V = omega_tau*e + v_nu */
    const double t62 = t3*t57; /* b/R*1/(Theta/(m*R^2*I1)) */
    const double t63 = t61*t62; /* V*b/R*1/(Theta/(m*R^2*I1)) */
    const double t64 = JLT_FNMA(p[33], t63, t59); /* omega_tau*a3/(R^2*I1) - 2*I3/(R^2*I1^2)*V*b/R*1/(Theta/(m*R^2*I1)) */
    const double t65 = t58*t64; /* (b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1))*t64 */
    const double t66 = JLT_FNMA(x[0], p[35], p[34]); /* 2*a3*I3^2/(R*I1^2) - gamma3*2*I3*(I1 - I3)/I1^2 */
    const double t67 = JLT_FMA(t62, t66, p[17]); /* b/R*1/(Theta/(m*R^2*I1))*(2*a3*I3^2/(R*I1^2) - gamma3*2*I3*(I1 - I3)/I1^2) + (I1 - I3)/I1 */
    const double t68 = t28*t67; /* s*s*omega_tau*t67 */
    const double t69 = JLT_FNMA(p[25], t61, t68); /* s*s*omega_tau*t67 - I3/(R*I1)*V */
    const double t70 = x[3]*t57; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t71 = JLT_FMS(t69, t70, t65); /* (s*s*omega_tau*t67 - I3/(R*I1)*V)*omega3*1/(Theta/(m*R^2*I1)) - (b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1))*t64 */
    out[15] = t71;
    const double t72 = p[15]*t58; /* 1/(R^2*I1)*(b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1)) */
    const double t73 = -t72; /* -1/(R^2*I1)*(b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1)) */
    out[16] = t73;
    const double t74 = t60*t72; /* e*1/(R^2*I1)*(b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1)) */
    const double t75 = JLT_FNMA(x[0], p[17], p[16]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t76 = t0*t75; /* s*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t77 = JLT_FMA(t70, t76, t74); /* omega3*1/(Theta/(m*R^2*I1))*s*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + t74 */
    const double t78 = -t77; /* -t77 */
    out[17] = t78;
    const double t79 = p[25]*t63; /* I3/(R*I1)*V*b/R*1/(Theta/(m*R^2*I1)) */
    const double t80 = t28*t75; /* s*s*omega_tau*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t81 = JLT_FMA(t57, t80, t79); /* 1/(Theta/(m*R^2*I1))*s*s*omega_tau*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + I3/(R*I1)*V*b/R*1/(Theta/(m*R^2*I1)) */
    const double t82 = -t81; /* -t81 */
    out[18] = t82;
    const double t83 = t7 + p[36]; /* b/R*b/R + I1/(m*R^2) */
    const double t84 = x[2]*t66; /* omega_tau*(2*a3*I3^2/(R*I1^2) - gamma3*2*I3*(I1 - I3)/I1^2) */
    const double t85 = t83*t84; /* (b/R*b/R + I1/(m*R^2))*omega_tau*(2*a3*I3^2/(R*I1^2) - gamma3*2*I3*(I1 - I3)/I1^2) */
    const double t86 = t70*t85; /* omega3*1/(Theta/(m*R^2*I1))*t85 */
    const double t87 = p[31]*t61; /* 2/(R^2*I1)*V */
    const double t88 = JLT_FNMA(t58, t87, t86); /* omega3*1/(Theta/(m*R^2*I1))*t85 - (b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1))*2/(R^2*I1)*V */
    const double t89 = x[4]*t57; /* s*1/(Theta/(m*R^2*I1)) */
    const double t90 = t88*t89; /* t88*s*1/(Theta/(m*R^2*I1)) */
    const double t91 = -t90; /* -t88*s*1/(Theta/(m*R^2*I1)) */
    out[19] = t91;
    const double t92 = -t1; /* -s*omega_tau */
    out[20] = t92;
    const double t93 = x[4]*x[0]; /* s*gamma3 */
    const double t94 = -t93; /* -s*gamma3 */
    out[22] = t94;
    const double t95 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t96 = -t95; /* -omega_tau*gamma3 */
    out[24] = t96;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t0 = p[8] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = x[4]*x[4]; /* s*s */
    out[7] = t1;
    const double t2 = JLT_FMA(p[11], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t3 = p[39]*t0; /* m*R^2*I3*b/R */
    const double t4 = JLT_FMA(p[38], t1, p[37]); /* m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(t0, t3, t4); /* Theta = b/R*m*R^2*I3*b/R + m*R^2*I1*s*s + I1*I3 */
    const double t6 = x[4]*t2; /* s*D */
    const double t7 = t5*t6; /* Theta*s*D */
    const double t8 = 1.0/t7; /* 1/(Theta*s*D) */
    const double t9 = t5*t8; /* 1/(s*D) = Theta*1/(Theta*s*D) */
    const double t10 = t6*t8; /* 1/Theta = s*D*1/(Theta*s*D) */
    const double t11 = t2*t9; /* 1/s = D*1/(s*D) */
    const double t12 = x[4]*t9; /* 1/D = s*1/(s*D) */
    const double t13 = p[9]*x[3]; /* R*I3*omega3 */
    const double t14 = JLT_FMA(t0, t13, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t15 = x[4]*x[2]; /* s*omega_tau */
    const double t16 = 2.0*t15; /* 2*s*omega_tau */
    out[9] = t16;
    const double t17 = -t15; /* -s*omega_tau */
    out[25] = t17;
    const double t18 = t11*t14; /* 1/s*(b/R*R*I3*omega3 + G_level) */
    const double t19 = t18*t18; /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t20 = p[40]*t15; /* m*R^2*a3^2*I1*s*omega_tau */
    const double t21 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t22 = x[4]*t15; /* s*s*omega_tau */
    out[0] = t22;
    const double t23 = JLT_FMS(t15, t20, t19); /* s*omega_tau*m*R^2*a3^2*I1*s*omega_tau - t19 */
    const double t24 = p[15]*t23; /* 1/(R^2*I1)*(s*omega_tau*m*R^2*a3^2*I1*s*omega_tau - t19) */
    const double t25 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t26 = p[0]*t14; /* m*(b/R*R*I3*omega3 + G_level) */
    const double t27 = t21*t26; /* e*m*(b/R*R*I3*omega3 + G_level) */
    const double t28 = JLT_FNMA(x[0], p[42], p[41]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t29 = t25*t26; /* V*m*(b/R*R*I3*omega3 + G_level) */
    const double t30 = p[47]*t25; /* m*R*I3*V */
    const double t31 = t10*t26; /* 1/Theta*m*(b/R*R*I3*omega3 + G_level) */
    const double t32 = -t31; /* -1/Theta*m*(b/R*R*I3*omega3 + G_level) */
    out[21] = t32;
    const double t33 = t22*t28; /* s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t34 = JLT_FMA(x[3], t33, t29); /* omega3*s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*m*(b/R*R*I3*omega3 + G_level) */
    const double t35 = t10*t34; /* 1/Theta*t34 */
    const double t36 = JLT_FMA(t0, t30, t33); /* b/R*m*R*I3*V + s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t37 = JLT_FNMA(p[42], t22, t30); /* m*R*I3*V - m*R^2*(I1 - I3)*s*s*omega_tau */
    const double t38 = x[0]*t22; /* gamma3*s*s*omega_tau */
    const double t39 = t10*t36; /* 1/Theta*t36 */
    const double t40 = -t39; /* -1/Theta*t36 */
    out[23] = t40;
    const double t41 = -t35; /* -1/Theta*t34 */
    out[3] = t41;
    const double t42 = x[0]*t24; /* gamma3*1/(R^2*I1)*(s*omega_tau*m*R^2*a3^2*I1*s*omega_tau - t19) */
    const double t43 = JLT_FNMA(p[14], t1, t42); /* t42 - m*g*a3*s*s */
    const double t44 = x[3]*t1; /* omega3*s*s */
    const double t45 = JLT_FMA(t28, t44, t27); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega3*s*s + e*m*(b/R*R*I3*omega3 + G_level) */
    const double t46 = t10*t45; /* 1/Theta*t45 */
    const double t47 = -t46; /* -1/Theta*t45 */
    out[22] = t47;
    const double t48 = p[44]*t11; /* 2/(R*I1)*1/s */
    const double t49 = t18*t48; /* 1/s*(b/R*R*I3*omega3 + G_level)*2/(R*I1)*1/s */
    const double t50 = t11*t19; /* 1/s*t19 */
    const double t51 = JLT_FMA(x[2], t20, t50); /* omega_tau*m*R^2*a3^2*I1*s*omega_tau + 1/s*t19 */
    const double t52 = p[18]*t19; /* 1/(R*I1^2)*t19 */
    const double t53 = p[25]*t14; /* I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t54 = JLT_FNMA(x[3], t53, t43); /* numerator of d(omega_tau)/dt over D = t42 - m*g*a3*s*s - omega3*I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t55 = t12*t54; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t55;
    const double t56 = x[3]*p[22]; /* omega3*I3^2/I1 */
    const double t57 = x[0]*p[5]; /* gamma3*I3 */
    const double t58 = JLT_FMA(t49, t57, t56); /* 1/s*(b/R*R*I3*omega3 + G_level)*2/(R*I1)*1/s*gamma3*I3 + omega3*I3^2/I1 */
    const double t59 = JLT_FMA(t0, t49, x[3]); /* b/R*1/s*(b/R*R*I3*omega3 + G_level)*2/(R*I1)*1/s + omega3 */
    const double t60 = JLT_FMA(t0, t58, t53); /* b/R*t58 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t61 = JLT_FNMA(x[3], t58, t24); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = 1/(R^2*I1)*(s*omega_tau*m*R^2*a3^2*I1*s*omega_tau - t19) - omega3*t58 */
    const double t62 = t12*t61; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    out[15] = t62;
    const double t63 = p[43]*t59; /* R*I3/I1*(b/R*1/s*(b/R*R*I3*omega3 + G_level)*2/(R*I1)*1/s + omega3) */
    const double t64 = t12*t60; /* 1/D*(b/R*t58 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level)) */
    const double t65 = -t64; /* -1/D*(b/R*t58 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level)) */
    out[18] = t65;
    const double t66 = JLT_FMA(x[3], t63, t52); /* omega3*t63 + 1/(R*I1^2)*t19 */
    out[10] = t66;
    const double t67 = t0*t52; /* b/R*1/(R*I1^2)*t19 */
    const double t68 = p[46]*t0; /* 2*m*R^2*I3*b/R */
    const double t69 = t35*t68; /* 1/Theta*t34*2*m*R^2*I3*b/R */
    const double t70 = x[4]*t35; /* s*1/Theta*t34 */
    const double t71 = p[24]*t12; /* 2*m*a3^2*1/D */
    const double t72 = t38*t71; /* gamma3*s*s*omega_tau*2*m*a3^2*1/D */
    out[17] = t72;
    const double t73 = x[4]*t71; /* s*2*m*a3^2*1/D */
    const double t74 = t55*t73; /* 1/D*numerator of d(omega_tau)/dt over D*s*2*m*a3^2*1/D */
    const double t75 = x[0]*p[31]; /* gamma3*2/(R^2*I1) */
    const double t76 = t51*t75; /* (omega_tau*m*R^2*a3^2*I1*s*omega_tau + 1/s*t19)*gamma3*2/(R^2*I1) */
    const double t77 = JLT_FNMA(x[4], p[45], t76); /* d(numerator of d(omega_tau)/dt over D)/d(s) = t76 - s*2*m*g*a3 */
    const double t78 = JLT_FMS(t12, t77, t74); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) - 1/D*numerator of d(omega_tau)/dt over D*s*2*m*a3^2*1/D */
    out[19] = t78;
    const double t79 = x[2]*p[26]; /* omega_tau*m*a3 */
    const double t80 = JLT_FNMA(t14, t79, t69); /* 1/Theta*t34*2*m*R^2*I3*b/R - (b/R*R*I3*omega3 + G_level)*omega_tau*m*a3 */
    const double t81 = JLT_FNMA(x[3], t37, t80); /* t80 - omega3*(m*R*I3*V - m*R^2*(I1 - I3)*s*s*omega_tau) */
    const double t82 = t10*t81; /* 1/Theta*(t80 - omega3*(m*R*I3*V - m*R^2*(I1 - I3)*s*s*omega_tau)) */
    out[20] = t82;
    const double t83 = p[7]*t14; /* 1/I1*(b/R*R*I3*omega3 + G_level) */
    const double t84 = JLT_FMA(x[3], t83, t67); /* omega3*1/I1*(b/R*R*I3*omega3 + G_level) + b/R*1/(R*I1^2)*t19 */
    out[1] = t84;
    const double t85 = JLT_FMA(t0, t63, t83); /* b/R*t63 + 1/I1*(b/R*R*I3*omega3 + G_level) */
    out[13] = t85;
    const double t86 = p[21]*t0; /* (-2/(R*I1^2))*b/R */
    const double t87 = t50*t86; /* 1/s*t19*(-2/(R*I1^2))*b/R */
    out[14] = t87;
    const double t88 = p[48]*t10; /* 2*m*R^2*I1*1/Theta */
    const double t89 = JLT_FNMA(x[0], p[17], p[16]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t90 = x[3]*t15; /* omega3*s*omega_tau */
    const double t91 = JLT_FNMA(t89, t90, t70); /* s*1/Theta*t34 - (a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*omega3*s*omega_tau */
    const double t92 = t88*t91; /* 2*m*R^2*I1*1/Theta*t91 */
    out[24] = t92;
    const double t93 = x[0]*t15; /* gamma3*s*omega_tau */
    const double t94 = -t93; /* -gamma3*s*omega_tau */
    out[4] = t94;
    const double t95 = x[4]*x[0]; /* s*gamma3 */
    const double t96 = -t95; /* -s*gamma3 */
    out[27] = t96;
    const double t97 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t98 = -t97; /* -omega_tau*gamma3 */
    out[29] = t98;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = t1*p[49]; /* b*m*I3 */
    const double t3 = JLT_FMA(p[38], t0, p[37]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t1, t2, t3); /* Theta = b*b*m*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(t0, p[11], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t4*t5; /* Theta*D */
    const double t7 = t0*x[2]; /* s*s*omega_tau */
    const double t8 = x[0]*t7; /* gamma3*s*s*omega_tau */
    const double t9 = p[24]*t8; /* 2*m*a3^2*gamma3*s*s*omega_tau */
    const double t10 = t4*t9; /* Theta*2*m*a3^2*gamma3*s*s*omega_tau */
    const double t11 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t12 = JLT_FMA(x[2], t11, x[1]); /* V = omega_tau*e + v_nu */
    const double t13 = t8*p[42]; /* gamma3*s*s*omega_tau*m*R^2*(I1 - I3) */
    const double t14 = JLT_FNMA(t7, p[41], t13); /* gamma3*s*s*omega_tau*m*R^2*(I1 - I3) - s*s*omega_tau*m*R*a3*I3 */
    const double t15 = JLT_FNMA(t2, t12, t14); /* d(numerator of d(omega3)/dt over Theta)/d(omega3) = t14 - b*m*I3*V */
    const double t16 = JLT_FMA(t5, t15, t10); /* D*d(numerator of d(omega3)/dt over Theta)/d(omega3) + Theta*2*m*a3^2*gamma3*s*s*omega_tau */
    const double t17 = t16/t6; /* t16/(Theta*D) */
    const double t18 = JLT_FNMA(x[0], x[2], t17); /* t16/(Theta*D) - gamma3*omega_tau */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t1 = p[9]*x[3]; /* R*I3*omega3 */
    const double t2 = JLT_FMA(t0, t1, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t3 = t2/x[4]; /* (b/R*R*I3*omega3 + G_level)/s */
    const double t4 = p[7]*t0; /* 1/I1*b/R */
    const double t5 = t3*t4; /* (b/R*R*I3*omega3 + G_level)/s*1/I1*b/R */
    const double t6 = p[51]*x[0]; /* 2*g*a3*gamma3 */
    const double t7 = JLT_FMA(x[1], x[1], t6); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t8 = p[11]*x[4]; /* m*a3^2*s */
    const double t9 = JLT_FMA(x[4], t8, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t10 = p[52]*x[2]; /* 1/m*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/m*omega_tau */
    const double t12 = x[3]*p[54]; /* omega3*I3/m */
    const double t13 = JLT_FMA(x[3], t12, t7); /* omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t14 = JLT_FMA(t9, t11, t13); /* D*omega_tau*1/m*omega_tau + omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t15 = p[53]*t3; /* 1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s */
    const double t16 = JLT_FMA(t3, t15, t14); /* (b/R*R*I3*omega3 + G_level)/s*1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s + t14 */
    const double t17 = x[4]*p[1]; /* s*R */
    const double t18 = JLT_FMA(x[3], t17, t5); /* v_tau = omega3*s*R + (b/R*R*I3*omega3 + G_level)/s*1/I1*b/R */
    const double t19 = JLT_FMA(t18, t18, t16); /* energy/(1/2*m) = v_tau*v_tau + t16 */
    const double t20 = p[50]*t19; /* 1/2*m*energy/(1/2*m) */
    out[0] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = 1.0/x[4]; /* 1/s */
    const double t2 = p[5]*x[3]; /* I3*omega3 */
    const double t3 = JLT_FMA(t0, t2, p[6]); /* b*I3*omega3 + G_level */
    const double t4 = t1*t3; /* 1/s*(b*I3*omega3 + G_level) */
    const double t5 = t0*t4; /* b*1/s*(b*I3*omega3 + G_level) */
    const double t6 = x[4]*p[56]; /* s*R^2*I1 */
    const double t7 = JLT_FMA(x[3], t6, t5); /* v_tau/(1/(R*I1)) = omega3*s*R^2*I1 + b*1/s*(b*I3*omega3 + G_level) */
    const double t8 = t0*t1; /* b*1/s */
    const double t9 = JLT_FMA(t2, t8, t4); /* d(v_tau)/d(gamma3)/(1/I1) = I3*omega3*b*1/s + 1/s*(b*I3*omega3 + G_level) */
    const double t10 = p[55]*t7; /* m/(R*I1^2)*v_tau/(1/(R*I1)) */
    const double t11 = t1*t4; /* 1/s*1/s*(b*I3*omega3 + G_level) */
    const double t12 = x[3]*p[25]; /* omega3*I3/(R*I1) */
    const double t13 = JLT_FMA(t11, t12, p[14]); /* 1/s*1/s*(b*I3*omega3 + G_level)*omega3*I3/(R*I1) + m*g*a3 */
    const double t14 = JLT_FMA(t9, t10, t13); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/(1/I1)*m/(R*I1^2)*v_tau/(1/(R*I1)) + 1/s*1/s*(b*I3*omega3 + G_level)*omega3*I3/(R*I1) + m*g*a3 */
    out[0] = t14;
    const double t15 = p[0]*x[1]; /* m*v_nu */
    out[1] = t15;
    const double t16 = x[4]*p[11]; /* s*m*a3^2 */
    const double t17 = JLT_FMA(x[4], t16, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t18 = x[2]*t17; /* omega_tau*D */
    out[2] = t18;
    const double t19 = t8*p[57]; /* b*1/s*I3/(R^2*I1) */
    const double t20 = JLT_FMA(t0, t19, x[4]); /* d(v_tau)/d(omega3)/R = b*b*1/s*I3/(R^2*I1) + s */
    const double t21 = t7*p[58]; /* v_tau/(1/(R*I1))*m/I1 */
    const double t22 = JLT_FMA(t4, t19, t2); /* 1/s*(b*I3*omega3 + G_level)*b*1/s*I3/(R^2*I1) + I3*omega3 */
    const double t23 = JLT_FMA(t20, t21, t22); /* d(energy)/d(omega3) = d(v_tau)/d(omega3)/R*v_tau/(1/(R*I1))*m/I1 + 1/s*(b*I3*omega3 + G_level)*b*1/s*I3/(R^2*I1) + I3*omega3 */
    out[3] = t23;
    const double t24 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t25 = t16*t24; /* s*m*a3^2*omega_tau*omega_tau */
    const double t26 = t11*p[15]; /* 1/s*1/s*(b*I3*omega3 + G_level)*1/(R^2*I1) */
    const double t27 = JLT_FNMA(t0, t26, x[3]); /* d(v_tau)/d(s)/R = omega3 - b*1/s*1/s*(b*I3*omega3 + G_level)*1/(R^2*I1) */
    const double t28 = JLT_FNMA(t4, t26, t25); /* s*m*a3^2*omega_tau*omega_tau - 1/s*(b*I3*omega3 + G_level)*1/s*1/s*(b*I3*omega3 + G_level)*1/(R^2*I1) */
    const double t29 = JLT_FMA(t21, t27, t28); /* d(energy)/d(s) = v_tau/(1/(R*I1))*m/I1*d(v_tau)/d(s)/R + t28 */
    out[4] = t29;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[8] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = p[9]*x[3]; /* R*I3*omega3 */
    const double t2 = JLT_FMA(t0, t1, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t3 = p[10]*t2; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t4 = t3/x[4]; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level)/s */
    out[0] = t4;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
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
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
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
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t19[k] = jlt_jet_product(x4, x4, k);
        t20[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t21[k] = p[59]*t19[k] + (k == 0 ? 1.0 : 0);
        t22[k] = p[57]*t20[k];
        t23[k] = (k == 0 ? p[12] : 0) + t19[k];
        t24[k] = jlt_jet_product(t20, t22, k) + t23[k];
        t25[k] = jlt_jet_product(x4, t21, k);
        t26[k] = p[10]*t21[k];
        t27[k] = jlt_jet_product(t24, t25, k);
        t28[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t27, t28, k);
        t29[k] = jlt_jet_product(t24, t28, k);
        t30[k] = p[61]*t25[k];
        t31[k] = jlt_jet_product(t28, t30, k);
        t32[k] = p[5]*x3[k];
        t33[k] = jlt_jet_product(t20, t32, k) + (k == 0 ? p[6] : 0);
        t34[k] = jlt_jet_product(t26, t33, k);
        t35[k] = jlt_jet_product(t29, t34, k);
        t36[k] = jlt_jet_product(x4, t29, k);
        t37[k] = jlt_jet_product(x2, x0, k);
        t38[k] = jlt_jet_product(x2, t19, k);
        t39[k] = p[59]*t37[k];
        t40[k] = jlt_jet_product(t38, t39, k);
        t41[k] = t40[k] - p[60]*t19[k];
        t42[k] = jlt_jet_product(x4, t37, k);
        t43[k] = -t42[k];
        t44[k] = (k == 0 ? p[62] : 0) - x0[k]*p[63];
        t45[k] = jlt_jet_product(x3, t44, k);
        t46[k] = jlt_jet_product(t38, t45, k);
        t47[k] = jlt_jet_product(t35, t35, k);
        t48[k] = jlt_jet_product(x4, t35, k);
        t49[k] = t41[k] - jlt_jet_product(x0, t47, k);
        t50[k] = jlt_jet_product(t20, t47, k);
        t51[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t52[k] = jlt_jet_product(x2, t51, k) + x1[k];
        t53[k] = jlt_jet_product(t48, t52, k) + t46[k];
        t54[k] = jlt_jet_product(t31, t53, k);
        t55[k] = jlt_jet_product(x3, t48, k);
        t56[k] = p[1]*t55[k] + t50[k];
        t57[k] = t49[k] - p[13]*t55[k];
        t58[k] = jlt_jet_product(t36, t57, k);
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t38[k]/(k + 1);
        next[1] = x1[k + 1] = t56[k]/(k + 1);
        next[2] = x2[k + 1] = t58[k]/(k + 1);
        next[3] = x3[k + 1] = t54[k]/(k + 1);
        next[4] = x4[k + 1] = t43[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double v_a3 = params[3];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 64,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 24, 11, 1, 0, 0, 12, 11 }, { 15, 66, 0, 8, 0, 0, 11, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level, 1/s*(b/R*(R*I3)*omega3 + G_level)*1/s*b/R*(1/(R*I1)) + omega3, gamma3*1/s*(b/R*(R*I3)*omega3 + G_level)*1/s + (R*I3)*omega3, a part of d(omega_tau)/dtau, a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), e = gamma3*a3 + R, V = omega_tau*e + v_nu, a part of d(omega3)/dtau" },
    .jacobian = { jacobian, 25, { 11, 60, 25, 1, 0, 0, 13, 16 }, { 57, 322, 0, 44, 0, 0, 16, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level, omega3*(1/2*R*I1) + b/R*1/s*(b/R*(R*I3)*omega3 + G_level)*1/s, d(d(v_nu)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(omega3), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(omega3), a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(omega3), 2*g*I1 - (b/R*(R*I3)*omega3 + G_level)*omega3*(2*a3*I3/(R*I1)), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega_tau*(a3/(R^2*I1)) - (2*I3/(R^2*I1^2))*V*b/R*1/(Theta/(m*R^2*I1)), 2*a3*I3^2/(R*I1^2) - gamma3*(2*I3*(I1 - I3)/I1^2), a part of d(d(omega3)/dtau)/d(gamma3), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(gamma3), a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(d(omega3)/dtau)/d(omega_tau), a part of d(d(omega3)/dtau)/d(omega3), a part of d(d(omega3)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 60, 28, 1, 0, 0, 17, 18 }, { 65, 368, 0, 51, 0, 0, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level, e = gamma3*a3 + R, a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), V = omega_tau*e + v_nu, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s), b/R*(m*R*I3)*V + s*s*omega_tau*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))), (m*R*I3)*V - (m*R^2*(I1 - I3))*s*s*omega_tau, a part of d(d(omega3)/dtau)/d(omega_tau), numerator of d(omega_tau)/dt over D, a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(omega3), b/R*1/s*(b/R*(R*I3)*omega3 + G_level)*(2/(R*I1))*1/s + omega3, a part of d(d(omega_tau)/dtau)/d(omega3), d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(d(v_nu)/dtau)/d(gamma3), d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s), a part of d(d(omega3)/dtau)/d(gamma3), d(v_nu)/dtau, d(d(v_nu)/dtau)/d(omega3), a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(d(omega3)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 0, 8, 10, 1, 0, 0, 9, 8 }, { 11, 40, 0, 4, 0, 0, 11, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, V = omega_tau*e + v_nu, d(numerator of d(omega3)/dt over Theta)/d(omega3), a part of the divergence, the divergence" },
    .integral_values = { integral_values, 1, { 1, 11, 8, 1, 0, 0, 7, 7 }, { 9, 30, 0, 1, 0, 0, 11, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*(R*I3)*omega3 + G_level, v_tau = omega3*s*R + ((b/R*(R*I3)*omega3 + G_level)/s)*(1/I1)*b/R, energy/(1/2*m)" },
    .integral_gradients = { integral_gradients, 5, { 0, 16, 13, 1, 0, 0, 7, 10 }, { 15, 54, 0, 7, 0, 0, 11, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, b*I3*omega3 + G_level, v_tau/(1/(R*I1)) = omega3*s*(R^2*I1) + b*((1)/s)*(b*I3*omega3 + G_level), d(v_tau)/d(gamma3)/(1/I1) = I3*omega3*b*((1)/s) + ((1)/s)*(b*I3*omega3 + G_level), d(E)/d(gamma3), d(E)/d(omega3), d(v_tau)/d(s)/R = omega3 - b*((1)/s)*((1)/s)*(b*I3*omega3 + G_level)*(1/(R^2*I1)), d(E)/d(s)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 1, 2, 1, 1, 0, 0, 4, 3 }, { 2, 5, 0, 1, 0, 0, 5, 4 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular_on_level_G,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_general_in_regular_on_level_G_baseline,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_avx2,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_avx512,
    },
#endif
};
