/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 1b6d453374f697d58e1412b96ff746b2599a2a450f7166c0e5909287ba92fdcb
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   26   11    1    0    0     13   11   (89)
 *  jacobian            12   58   26    1    0    0     14   16   (423)
 *  rhs_jacobian        10   62   28    1    0    0     15   20   (484)
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
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s),
 *      e = gamma3*a3 + R, V = omega_tau*e + v_nu, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)),
 *      gamma3*1/s*(b/R*(R*I3)*omega3 + G_level)*(2/(R*I1))*1/s + omega3*(I3/I1),
 *      b/R*1/s*(b/R*(R*I3)*omega3 + G_level)*(2/(R*I1))*1/s + omega3, d(d(v_nu)/dtau)/d(gamma3),
 *      a part of d(d(omega3)/dtau)/d(omega_tau), d(numerator of d(omega_tau)/dt over D)/d(gamma3),
 *      a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s),
 *      (m*R^2*(I1 - I3))*s*s*omega_tau - (m*R*I3)*V,
 *      b/R*(m*R*I3)*V + s*s*omega_tau*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))), numerator of d(omega_tau)/dt over D,
 *      a part of d(d(omega_tau)/dtau)/d(omega3), d(v_nu)/dtau, d(d(v_nu)/dtau)/d(omega3),
 *      d(numerator of d(omega_tau)/dt over D)/d(s), a part of d(d(omega_tau)/dtau)/d(s),
 *      d(numerator of d(omega3)/dt over Theta)/d(s), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(s)
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
    const double t0 = params[4]*params[4]; /* I1*I1 */
    const double t1 = params[1]*t0; /* R*I1*I1 */
    const double t2 = 1.0/t1; /* 1/(R*I1*I1) */
    out[7] = t2;
    const double t3 = params[3]/params[1]; /* a3/R */
    out[8] = t3;
    const double t4 = params[1]*params[5]; /* R*I3 */
    out[9] = t4;
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[10] = t6;
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = params[0]*t7; /* m*R*R */
    const double t9 = params[5]/t8; /* I3/(m*R*R) */
    out[11] = t9;
    const double t10 = params[5]/params[4]; /* I3/I1 */
    out[12] = t10;
    const double t11 = 1.0/params[4]; /* 1/I1 */
    out[13] = t11;
    const double t12 = params[4]*t7; /* I1*R*R */
    out[62] = t12;
    const double t13 = 1.0/t12; /* 1/(I1*R*R) */
    out[14] = t13;
    const double t14 = t5*t8; /* a3*a3*m*R*R */
    const double t15 = params[4]*t14; /* I1*a3*a3*m*R*R */
    out[15] = t15;
    const double t16 = t8*params[2]; /* m*R*R*g */
    const double t17 = params[3]*t16; /* a3*m*R*R*g */
    const double t18 = params[4]*t17; /* I1*a3*m*R*R*g */
    out[16] = t18;
    const double t19 = (-1.0)/t12; /* (-1)/(I1*R*R) */
    out[17] = t19;
    const double t20 = params[3]*params[5]; /* a3*I3 */
    out[18] = t20;
    const double t21 = params[4] - params[5]; /* I1 - I3 */
    const double t22 = params[1]*t21; /* R*(I1 - I3) */
    out[19] = t22;
    const double t23 = t6/params[4]; /* m*a3*a3/I1 */
    out[20] = t23;
    const double t24 = t4/params[4]; /* R*I3/I1 */
    out[21] = t24;
    const double t25 = params[5]*2.0; /* I3*2 */
    const double t26 = t25/t0; /* I3*2/(I1*I1) */
    out[22] = t26;
    const double t27 = (-2.0)/t1; /* (-2)/(R*I1*I1) */
    out[23] = t27;
    const double t28 = t0*t7; /* I1*I1*R*R */
    const double t29 = 1.0/t28; /* 1/(I1*I1*R*R) */
    out[24] = t29;
    const double t30 = t25/t1; /* I3*2/(R*I1*I1) */
    out[25] = t30;
    const double t31 = t4/2.0; /* R*I3/2 */
    out[26] = t31;
    const double t32 = params[0]*2.0; /* m*2 */
    const double t33 = t5*t32; /* a3*a3*m*2 */
    out[47] = t33;
    const double t34 = t33/params[4]; /* a3*a3*m*2/I1 */
    out[27] = t34;
    const double t35 = params[5]/t1; /* I3/(R*I1*I1) */
    out[28] = t35;
    const double t36 = 2.0/t28; /* 2/(I1*I1*R*R) */
    out[29] = t36;
    const double t37 = params[2]*t32; /* g*m*2 */
    const double t38 = params[3]*t37; /* a3*g*m*2 */
    out[48] = t38;
    const double t39 = t38/params[4]; /* a3*g*m*2/I1 */
    out[30] = t39;
    const double t40 = params[3]/t12; /* a3/(I1*R*R) */
    out[31] = t40;
    const double t41 = t25/t28; /* I3*2/(I1*I1*R*R) */
    out[32] = t41;
    const double t42 = params[1]*params[4]; /* R*I1 */
    const double t43 = params[5]/t42; /* I3/(R*I1) */
    out[33] = t43;
    const double t44 = params[3]*2.0; /* a3*2 */
    const double t45 = params[5]*params[5]; /* I3*I3 */
    const double t46 = t44*t45; /* a3*2*I3*I3 */
    const double t47 = t46/t1; /* a3*2*I3*I3/(R*I1*I1) */
    out[34] = t47;
    const double t48 = t21*t25; /* (I1 - I3)*I3*2 */
    const double t49 = t48/t0; /* (I1 - I3)*I3*2/(I1*I1) */
    out[35] = t49;
    const double t50 = t21/params[4]; /* (I1 - I3)/I1 */
    out[36] = t50;
    const double t51 = t20/t42; /* a3*I3/(R*I1) */
    out[37] = t51;
    const double t52 = params[4]/t8; /* I1/(m*R*R) */
    out[38] = t52;
    const double t53 = 2.0/t12; /* 2/(I1*R*R) */
    out[39] = t53;
    const double t54 = params[4]*params[5]; /* I1*I3 */
    out[40] = t54;
    const double t55 = params[4]*t8; /* I1*m*R*R */
    out[41] = t55;
    const double t56 = params[5]*t8; /* I3*m*R*R */
    out[42] = t56;
    const double t57 = params[0]*params[2]; /* m*g */
    const double t58 = params[3]*t57; /* a3*m*g */
    out[43] = t58;
    const double t59 = params[1]*params[0]; /* R*m */
    const double t60 = params[3]*t59; /* a3*R*m */
    const double t61 = params[5]*t60; /* I3*a3*R*m */
    out[44] = t61;
    const double t62 = t8*t21; /* m*R*R*(I1 - I3) */
    out[45] = t62;
    const double t63 = 2.0/t42; /* 2/(R*I1) */
    out[46] = t63;
    const double t64 = t7*t32; /* R*R*m*2 */
    const double t65 = params[5]*t64; /* I3*R*R*m*2 */
    out[49] = t65;
    const double t66 = params[3]*params[0]; /* a3*m */
    out[50] = t66;
    const double t67 = params[5]*t59; /* I3*R*m */
    out[51] = t67;
    const double t68 = t21*t64; /* (I1 - I3)*R*R*m*2 */
    out[52] = t68;
    const double t69 = params[1]*t32; /* R*m*2 */
    const double t70 = params[3]*t69; /* a3*R*m*2 */
    const double t71 = params[5]*t70; /* I3*a3*R*m*2 */
    out[53] = t71;
    const double t72 = params[4]*t64; /* I1*R*R*m*2 */
    out[54] = t72;
    const double t73 = params[5]*params[0]; /* I3*m */
    out[55] = t73;
    const double t74 = params[0]/2.0; /* m/2 */
    out[56] = t74;
    const double t75 = params[2]*2.0; /* g*2 */
    const double t76 = params[3]*t75; /* a3*g*2 */
    out[57] = t76;
    const double t77 = 1.0/params[0]; /* 1/m */
    out[58] = t77;
    const double t78 = 1.0/t55; /* 1/(I1*m*R*R) */
    out[59] = t78;
    const double t79 = params[5]/params[0]; /* I3/m */
    out[60] = t79;
    const double t80 = params[0]/t1; /* m/(R*I1*I1) */
    out[61] = t80;
    const double t81 = params[5]/t12; /* I3/(I1*R*R) */
    out[63] = t81;
    const double t82 = params[0]/params[4]; /* m/I1 */
    out[64] = t82;
    const double t83 = 1.0/t42; /* 1/(R*I1) */
    out[65] = t83;
    const double t84 = t58/params[4]; /* a3*m*g/I1 */
    out[66] = t84;
    const double t85 = (-1.0)/params[1]; /* (-1)/R */
    out[67] = t85;
    const double t86 = t20/params[4]; /* a3*I3/I1 */
    out[68] = t86;
    const double t87 = t22/params[4]; /* R*(I1 - I3)/I1 */
    out[69] = t87;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t1;
    const double t2 = p[8] + x[0]; /* b/R = a3/R + gamma3 */
    const double t3 = p[9]*x[3]; /* R*I3*omega3 */
    const double t4 = JLT_FMA(t2, t3, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t5 = JLT_FMA(t0, p[10], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t2*p[12]; /* b/R*I3/I1 */
    const double t7 = t0 + p[11]; /* s*s + I3/(m*R^2) */
    const double t8 = JLT_FMA(t2, t6, t7); /* Theta/(m*R^2*I1) = b/R*b/R*I3/I1 + s*s + I3/(m*R^2) */
    const double t9 = x[4]*t5; /* s*D */
    const double t10 = t8*t9; /* Theta/(m*R^2*I1)*s*D */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s*D) */
    const double t12 = t8*t11; /* 1/(s*D) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D) */
    const double t13 = t4*t5; /* (b/R*R*I3*omega3 + G_level)*D */
    const double t14 = t12*t13; /* 1/(s*D)*(b/R*R*I3*omega3 + G_level)*D */
    const double t15 = t14*t14; /* 1/(s*D)*(b/R*R*I3*omega3 + G_level)*D*1/(s*D)*(b/R*R*I3*omega3 + G_level)*D */
    const double t16 = p[7]*t2; /* 1/(R*I1^2)*b/R */
    const double t17 = t15*t16; /* t15*1/(R*I1^2)*b/R */
    const double t18 = x[3]*p[13]; /* omega3*1/I1 */
    const double t19 = JLT_FMA(t4, t18, t17); /* (b/R*R*I3*omega3 + G_level)*omega3*1/I1 + t15*1/(R*I1^2)*b/R */
    out[1] = t19;
    const double t20 = x[2]*p[15]; /* omega_tau*m*R^2*a3^2*I1 */
    const double t21 = JLT_FMS(t1, t20, t15); /* omega_tau*s*s*omega_tau*m*R^2*a3^2*I1 - t15 */
    const double t22 = x[0]*t21; /* gamma3*(omega_tau*s*s*omega_tau*m*R^2*a3^2*I1 - t15) */
    const double t23 = JLT_FNMA(t0, p[16], t22); /* gamma3*(omega_tau*s*s*omega_tau*m*R^2*a3^2*I1 - t15) - s*s*m*R^2*g*a3*I1 */
    const double t24 = JLT_FNMA(t3, t4, t23); /* t23 - R*I3*omega3*(b/R*R*I3*omega3 + G_level) */
    const double t25 = x[4]*p[14]; /* s*1/(R^2*I1) */
    const double t26 = t12*t25; /* 1/(s*D)*s*1/(R^2*I1) */
    const double t27 = t24*t26; /* (t23 - R*I3*omega3*(b/R*R*I3*omega3 + G_level))*1/(s*D)*s*1/(R^2*I1) */
    out[2] = t27;
    const double t28 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t29 = JLT_FMA(x[2], t28, x[1]); /* V = omega_tau*e + v_nu */
    const double t30 = t4*t29; /* (b/R*R*I3*omega3 + G_level)*V */
    const double t31 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t32 = x[3]*p[1]; /* omega3*R */
    const double t33 = t1*t32; /* omega_tau*s*s*omega3*R */
    const double t34 = JLT_FMA(t31, t33, t30); /* (a3*I3 - gamma3*R*(I1 - I3))*omega_tau*s*s*omega3*R + (b/R*R*I3*omega3 + G_level)*V */
    const double t35 = t9*p[17]; /* s*D*(-1/(R^2*I1)) */
    const double t36 = t34*t35; /* t34*s*D*(-1/(R^2*I1)) */
    const double t37 = t11*t36; /* 1/(Theta/(m*R^2*I1)*s*D)*t34*s*D*(-1/(R^2*I1)) */
    out[3] = t37;
    const double t38 = x[2]*x[4]; /* omega_tau*s */
    const double t39 = x[0]*t38; /* gamma3*omega_tau*s */
    const double t40 = -t39; /* -gamma3*omega_tau*s */
    out[4] = t40;
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
    const double t6 = JLT_FMA(t0, p[20], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t7 = t3*t3; /* b/R*b/R */
    const double t8 = t0 + p[11]; /* s*s + I3/(m*R^2) */
    const double t9 = JLT_FMA(p[12], t7, t8); /* Theta/(m*R^2*I1) = I3/I1*b/R*b/R + s*s + I3/(m*R^2) */
    const double t10 = x[4]*t6; /* s*D/I1 */
    const double t11 = t9*t10; /* Theta/(m*R^2*I1)*s*D/I1 */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*s*D/I1) */
    const double t13 = t9*t12; /* 1/(s*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D/I1) */
    const double t14 = t6*t13; /* 1/s = D/I1*1/(s*(D/I1)) */
    const double t15 = t5*t14; /* (b/R*R*I3*omega3 + G_level)*1/s */
    const double t16 = t15*t15; /* (b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t17 = p[7]*t16; /* 1/(R*I1^2)*t16 */
    const double t18 = x[3]*p[21]; /* omega3*R*I3/I1 */
    const double t19 = t14*t15; /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t20 = t3*t19; /* b/R*1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t21 = JLT_FMA(p[22], t20, t18); /* 2*I3/I1^2*b/R*1/s*(b/R*R*I3*omega3 + G_level)*1/s + omega3*R*I3/I1 */
    const double t22 = JLT_FMA(x[3], t21, t17); /* omega3*t21 + 1/(R*I1^2)*t16 */
    out[5] = t22;
    const double t23 = x[4]*p[13]; /* s*1/I1 */
    const double t24 = t15*t23; /* (b/R*R*I3*omega3 + G_level)*1/s*s*1/I1 */
    const double t25 = JLT_FMA(t3, t21, t24); /* b/R*t21 + (b/R*R*I3*omega3 + G_level)*1/s*s*1/I1 */
    out[8] = t25;
    const double t26 = t15*p[23]; /* (b/R*R*I3*omega3 + G_level)*1/s*(-2/(R*I1^2)) */
    const double t27 = t20*t26; /* b/R*1/s*(b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level)*1/s*(-2/(R*I1^2)) */
    out[9] = t27;
    const double t28 = t1*p[20]; /* s*omega_tau*m*a3^2/I1 */
    const double t29 = t16*p[24]; /* t16*1/(R^2*I1^2) */
    const double t30 = JLT_FMS(t1, t28, t29); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - t16*1/(R^2*I1^2) */
    const double t31 = x[4]*t13; /* 1/(D/I1) = s*1/(s*(D/I1)) */
    const double t32 = t30*t31; /* (s*omega_tau*s*omega_tau*m*a3^2/I1 - t16*1/(R^2*I1^2))*1/(D/I1) */
    const double t33 = x[3]*p[26]; /* omega3*1/2*R*I3 */
    const double t34 = JLT_FMA(x[0], t19, t33); /* gamma3*1/s*(b/R*R*I3*omega3 + G_level)*1/s + omega3*1/2*R*I3 */
    const double t35 = t31*t34; /* 1/(D/I1)*(gamma3*1/s*(b/R*R*I3*omega3 + G_level)*1/s + omega3*1/2*R*I3) */
    const double t36 = p[25]*t35; /* 2*I3/(R*I1^2)*t35 */
    const double t37 = JLT_FNMA(x[3], t36, t32); /* t32 - omega3*2*I3/(R*I1^2)*t35 */
    out[10] = t37;
    const double t38 = x[4]*t31; /* s*1/(D/I1) */
    const double t39 = p[27]*t38; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t40 = x[0]*t39; /* gamma3*2*m*a3^2/I1*s*1/(D/I1) */
    const double t41 = t1*t40; /* s*omega_tau*gamma3*2*m*a3^2/I1*s*1/(D/I1) */
    out[12] = t41;
    const double t42 = t38*p[28]; /* s*1/(D/I1)*I3/(R*I1^2) */
    const double t43 = t15*t42; /* (b/R*R*I3*omega3 + G_level)*1/s*s*1/(D/I1)*I3/(R*I1^2) */
    const double t44 = JLT_FMA(t3, t36, t43); /* b/R*2*I3/(R*I1^2)*t35 + (b/R*R*I3*omega3 + G_level)*1/s*s*1/(D/I1)*I3/(R*I1^2) */
    const double t45 = -t44; /* -t44 */
    out[13] = t45;
    const double t46 = JLT_FNMA(t38, t39, t31); /* 1/(D/I1) - s*1/(D/I1)*2*m*a3^2/I1*s*1/(D/I1) */
    const double t47 = JLT_FNMA(t33, t46, t35); /* t35 - omega3*1/2*R*I3*(1/(D/I1) - s*1/(D/I1)*2*m*a3^2/I1*s*1/(D/I1)) */
    const double t48 = t15*p[29]; /* (b/R*R*I3*omega3 + G_level)*1/s*2/(R^2*I1^2) */
    const double t49 = t47*t48; /* t47*(b/R*R*I3*omega3 + G_level)*1/s*2/(R^2*I1^2) */
    const double t50 = JLT_FMA(x[2], x[2], t29); /* omega_tau*omega_tau + t16*1/(R^2*I1^2) */
    const double t51 = t40*t50; /* gamma3*2*m*a3^2/I1*s*1/(D/I1)*(omega_tau*omega_tau + t16*1/(R^2*I1^2)) */
    const double t52 = JLT_FNMA(t38, p[30], t51); /* t51 - s*1/(D/I1)*2*m*g*a3/I1 */
    const double t53 = JLT_FMA(t31, t52, t49); /* 1/(D/I1)*(t51 - s*1/(D/I1)*2*m*g*a3/I1) + t47*(b/R*R*I3*omega3 + G_level)*1/s*2/(R^2*I1^2) */
    out[14] = t53;
    const double t54 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = s*D/I1*1/(Theta/(m*R^2*I1)*s*D/I1) */
    const double t55 = x[4]*t54; /* s*1/(Theta/(m*R^2*I1)) */
    const double t56 = t15*t55; /* (b/R*R*I3*omega3 + G_level)*1/s*s*1/(Theta/(m*R^2*I1)) */
    const double t57 = x[2]*p[31]; /* omega_tau*a3/(R^2*I1) */
    const double t58 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t59 = JLT_FMA(x[2], t58, x[1]); /* V = omega_tau*e + v_nu */
    const double t60 = t54*t59; /* 1/(Theta/(m*R^2*I1))*V */
    const double t61 = t3*p[32]; /* b/R*2*I3/(R^2*I1^2) */
    const double t62 = JLT_FNMA(t60, t61, t57); /* omega_tau*a3/(R^2*I1) - 1/(Theta/(m*R^2*I1))*V*b/R*2*I3/(R^2*I1^2) */
    const double t63 = t56*t62; /* (b/R*R*I3*omega3 + G_level)*1/s*s*1/(Theta/(m*R^2*I1))*t62 */
    const double t64 = t60*p[33]; /* 1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    const double t65 = x[2]*p[34]; /* omega_tau*2*a3*I3^2/(R*I1^2) */
    const double t66 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t67 = JLT_FNMA(p[35], t66, t65); /* omega_tau*2*a3*I3^2/(R*I1^2) - 2*I3*(I1 - I3)/I1^2*omega_tau*gamma3 */
    const double t68 = t3*t67; /* b/R*t67 */
    const double t69 = t55*t68; /* s*1/(Theta/(m*R^2*I1))*b/R*t67 */
    const double t70 = JLT_FMA(t1, p[36], t69); /* s*omega_tau*(I1 - I3)/I1 + s*1/(Theta/(m*R^2*I1))*b/R*t67 */
    const double t71 = JLT_FNMA(t55, t70, t64); /* 1/(Theta/(m*R^2*I1))*V*I3/(R*I1) - s*1/(Theta/(m*R^2*I1))*(s*omega_tau*(I1 - I3)/I1 + s*1/(Theta/(m*R^2*I1))*b/R*t67) */
    const double t72 = JLT_FMA(x[3], t71, t63); /* omega3*t71 + (b/R*R*I3*omega3 + G_level)*1/s*s*1/(Theta/(m*R^2*I1))*t62 */
    const double t73 = -t72; /* -t72 */
    out[15] = t73;
    const double t74 = t56*p[14]; /* (b/R*R*I3*omega3 + G_level)*1/s*s*1/(Theta/(m*R^2*I1))*1/(R^2*I1) */
    const double t75 = -t74; /* -t74 */
    out[16] = t75;
    const double t76 = t58*t74; /* e*t74 */
    const double t77 = JLT_FNMA(x[0], p[36], p[37]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t78 = t55*t77; /* s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t79 = x[4]*x[3]; /* s*omega3 */
    const double t80 = JLT_FMA(t78, t79, t76); /* s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*s*omega3 + e*t74 */
    const double t81 = -t80; /* -t80 */
    out[17] = t81;
    const double t82 = t3*t64; /* b/R*1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    const double t83 = JLT_FMA(t1, t78, t82); /* s*omega_tau*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + b/R*1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    const double t84 = -t83; /* -t83 */
    out[18] = t84;
    const double t85 = t7 + p[38]; /* b/R*b/R + I1/(m*R^2) */
    const double t86 = x[3]*t85; /* omega3*(b/R*b/R + I1/(m*R^2)) */
    const double t87 = t67*t86; /* t67*omega3*(b/R*b/R + I1/(m*R^2)) */
    const double t88 = t54*t87; /* 1/(Theta/(m*R^2*I1))*t67*omega3*(b/R*b/R + I1/(m*R^2)) */
    const double t89 = t59*p[39]; /* V*2/(R^2*I1) */
    const double t90 = JLT_FNMA(t56, t89, t88); /* 1/(Theta/(m*R^2*I1))*t67*omega3*(b/R*b/R + I1/(m*R^2)) - (b/R*R*I3*omega3 + G_level)*1/s*s*1/(Theta/(m*R^2*I1))*V*2/(R^2*I1) */
    const double t91 = t55*t90; /* s*1/(Theta/(m*R^2*I1))*t90 */
    const double t92 = -t91; /* -s*1/(Theta/(m*R^2*I1))*t90 */
    out[19] = t92;
    const double t93 = -t1; /* -s*omega_tau */
    out[20] = t93;
    const double t94 = x[4]*x[0]; /* s*gamma3 */
    const double t95 = -t94; /* -s*gamma3 */
    out[22] = t95;
    const double t96 = -t66; /* -omega_tau*gamma3 */
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
    const double t2 = JLT_FMA(p[10], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t3 = p[42]*t0; /* m*R^2*I3*b/R */
    const double t4 = JLT_FMA(p[41], t1, p[40]); /* m*R^2*I1*s*s + I1*I3 */
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
    const double t19 = p[10]*t15; /* m*a3^2*s*omega_tau */
    const double t20 = t15*t19; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t21 = t18*t18; /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t22 = JLT_FNMA(p[14], t21, t20); /* s*omega_tau*m*a3^2*s*omega_tau - 1/(R^2*I1)*t21 */
    const double t23 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t24 = p[46]*t11; /* 2/(R*I1)*1/s */
    const double t25 = t18*t24; /* 1/s*(b/R*R*I3*omega3 + G_level)*2/(R*I1)*1/s */
    const double t26 = t11*t21; /* 1/s*t21 */
    const double t27 = p[7]*t21; /* 1/(R*I1^2)*t21 */
    const double t28 = x[4]*t15; /* s*s*omega_tau */
    out[0] = t28;
    const double t29 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t30 = p[0]*t14; /* m*(b/R*R*I3*omega3 + G_level) */
    const double t31 = t23*t30; /* e*m*(b/R*R*I3*omega3 + G_level) */
    const double t32 = JLT_FNMA(x[0], p[45], p[44]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t33 = x[0]*t15; /* gamma3*s*omega_tau */
    const double t34 = -t33; /* -gamma3*s*omega_tau */
    out[4] = t34;
    const double t35 = x[3]*p[12]; /* omega3*I3/I1 */
    const double t36 = JLT_FMA(x[0], t25, t35); /* gamma3*1/s*(b/R*R*I3*omega3 + G_level)*2/(R*I1)*1/s + omega3*I3/I1 */
    const double t37 = p[5]*t36; /* I3*t36 */
    const double t38 = JLT_FMA(t0, t25, x[3]); /* b/R*1/s*(b/R*R*I3*omega3 + G_level)*2/(R*I1)*1/s + omega3 */
    const double t39 = p[21]*t38; /* R*I3/I1*(b/R*1/s*(b/R*R*I3*omega3 + G_level)*2/(R*I1)*1/s + omega3) */
    const double t40 = JLT_FMA(x[3], t39, t27); /* omega3*t39 + 1/(R*I1^2)*t21 */
    out[10] = t40;
    const double t41 = t0*t27; /* b/R*1/(R*I1^2)*t21 */
    const double t42 = x[2]*p[47]; /* omega_tau*2*m*a3^2 */
    const double t43 = t33*t42; /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 */
    const double t44 = JLT_FNMA(x[4], p[48], t43); /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t45 = x[0]*t22; /* gamma3*(s*omega_tau*m*a3^2*s*omega_tau - 1/(R^2*I1)*t21) */
    const double t46 = JLT_FNMA(p[43], t1, t45); /* gamma3*(s*omega_tau*m*a3^2*s*omega_tau - 1/(R^2*I1)*t21) - m*g*a3*s*s */
    const double t47 = x[3]*t1; /* omega3*s*s */
    const double t48 = JLT_FMA(t32, t47, t31); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega3*s*s + e*m*(b/R*R*I3*omega3 + G_level) */
    const double t49 = t28*t32; /* s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t50 = JLT_FNMA(x[3], t37, t22); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = s*omega_tau*m*a3^2*s*omega_tau - 1/(R^2*I1)*t21 - omega3*I3*t36 */
    const double t51 = t12*t50; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    out[15] = t51;
    const double t52 = t10*t48; /* 1/Theta*t48 */
    const double t53 = -t52; /* -1/Theta*t48 */
    out[22] = t53;
    const double t54 = t29*t30; /* V*m*(b/R*R*I3*omega3 + G_level) */
    const double t55 = p[51]*t29; /* m*R*I3*V */
    const double t56 = JLT_FMA(x[3], t49, t54); /* omega3*s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*m*(b/R*R*I3*omega3 + G_level) */
    const double t57 = JLT_FMS(p[45], t28, t55); /* m*R^2*(I1 - I3)*s*s*omega_tau - m*R*I3*V */
    const double t58 = JLT_FMA(t0, t55, t49); /* b/R*m*R*I3*V + s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t59 = t10*t56; /* 1/Theta*t56 */
    const double t60 = t10*t30; /* 1/Theta*m*(b/R*R*I3*omega3 + G_level) */
    const double t61 = -t60; /* -1/Theta*m*(b/R*R*I3*omega3 + G_level) */
    out[21] = t61;
    const double t62 = t10*t58; /* 1/Theta*t58 */
    const double t63 = -t62; /* -1/Theta*t58 */
    out[23] = t63;
    const double t64 = -t59; /* -1/Theta*t56 */
    out[3] = t64;
    const double t65 = x[2]*p[50]; /* omega_tau*m*a3 */
    const double t66 = t14*t65; /* (b/R*R*I3*omega3 + G_level)*omega_tau*m*a3 */
    const double t67 = JLT_FMS(x[3], t57, t66); /* omega3*(m*R^2*(I1 - I3)*s*s*omega_tau - m*R*I3*V) - (b/R*R*I3*omega3 + G_level)*omega_tau*m*a3 */
    const double t68 = x[3]*p[52]; /* omega3*2*m*R^2*(I1 - I3) */
    const double t69 = t33*t68; /* gamma3*s*omega_tau*omega3*2*m*R^2*(I1 - I3) */
    const double t70 = p[33]*t14; /* I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t71 = JLT_FNMA(x[3], t70, t46); /* numerator of d(omega_tau)/dt over D = t46 - omega3*I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t72 = JLT_FMA(t0, t37, t70); /* b/R*I3*t36 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t73 = p[13]*t14; /* 1/I1*(b/R*R*I3*omega3 + G_level) */
    const double t74 = JLT_FMA(x[3], t73, t41); /* omega3*1/I1*(b/R*R*I3*omega3 + G_level) + b/R*1/(R*I1^2)*t21 */
    out[1] = t74;
    const double t75 = JLT_FMA(t0, t39, t73); /* b/R*t39 + 1/I1*(b/R*R*I3*omega3 + G_level) */
    out[13] = t75;
    const double t76 = t12*t72; /* 1/D*(b/R*I3*t36 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level)) */
    const double t77 = -t76; /* -1/D*(b/R*I3*t36 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level)) */
    out[18] = t77;
    const double t78 = t12*t71; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t78;
    const double t79 = x[4]*p[47]; /* s*2*m*a3^2 */
    const double t80 = t12*t79; /* 1/D*s*2*m*a3^2 */
    const double t81 = t33*t80; /* gamma3*s*omega_tau*1/D*s*2*m*a3^2 */
    out[17] = t81;
    const double t82 = x[0]*p[39]; /* gamma3*2/(R^2*I1) */
    const double t83 = JLT_FMA(t26, t82, t44); /* d(numerator of d(omega_tau)/dt over D)/d(s) = 1/s*t21*gamma3*2/(R^2*I1) + gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t84 = JLT_FNMA(t71, t80, t83); /* d(numerator of d(omega_tau)/dt over D)/d(s) - numerator of d(omega_tau)/dt over D*1/D*s*2*m*a3^2 */
    const double t85 = t12*t84; /* 1/D*t84 */
    out[19] = t85;
    const double t86 = x[3]*p[53]; /* omega3*2*m*R*a3*I3 */
    const double t87 = JLT_FNMA(t15, t86, t69); /* d(numerator of d(omega3)/dt over Theta)/d(s) = gamma3*s*omega_tau*omega3*2*m*R^2*(I1 - I3) - s*omega_tau*omega3*2*m*R*a3*I3 */
    const double t88 = t10*t87; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t89 = p[49]*t0; /* 2*m*R^2*I3*b/R */
    const double t90 = JLT_FMA(t59, t89, t67); /* 1/Theta*t56*2*m*R^2*I3*b/R + t67 */
    const double t91 = t10*t90; /* 1/Theta*(1/Theta*t56*2*m*R^2*I3*b/R + t67) */
    out[20] = t91;
    const double t92 = p[23]*t0; /* (-2/(R*I1^2))*b/R */
    const double t93 = t26*t92; /* 1/s*t21*(-2/(R*I1^2))*b/R */
    out[14] = t93;
    const double t94 = x[4]*p[54]; /* s*2*m*R^2*I1 */
    const double t95 = t10*t94; /* 1/Theta*s*2*m*R^2*I1 */
    const double t96 = JLT_FMA(t59, t95, t88); /* 1/Theta*t56*1/Theta*s*2*m*R^2*I1 + 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    out[24] = t96;
    const double t97 = x[4]*x[0]; /* s*gamma3 */
    const double t98 = -t97; /* -s*gamma3 */
    out[27] = t98;
    const double t99 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t100 = -t99; /* -omega_tau*gamma3 */
    out[29] = t100;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = t1*p[55]; /* b*m*I3 */
    const double t3 = JLT_FMA(p[41], t0, p[40]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t1, t2, t3); /* Theta = b*b*m*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(t0, p[10], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t4*t5; /* Theta*D */
    const double t7 = t0*x[2]; /* s*s*omega_tau */
    const double t8 = x[0]*t7; /* gamma3*s*s*omega_tau */
    const double t9 = p[47]*t8; /* 2*m*a3^2*gamma3*s*s*omega_tau */
    const double t10 = t4*t9; /* Theta*2*m*a3^2*gamma3*s*s*omega_tau */
    const double t11 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t12 = JLT_FMA(x[2], t11, x[1]); /* V = omega_tau*e + v_nu */
    const double t13 = t8*p[45]; /* gamma3*s*s*omega_tau*m*R^2*(I1 - I3) */
    const double t14 = JLT_FNMA(t7, p[44], t13); /* gamma3*s*s*omega_tau*m*R^2*(I1 - I3) - s*s*omega_tau*m*R*a3*I3 */
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
    const double t4 = p[13]*t0; /* 1/I1*b/R */
    const double t5 = t3*t4; /* (b/R*R*I3*omega3 + G_level)/s*1/I1*b/R */
    const double t6 = p[57]*x[0]; /* 2*g*a3*gamma3 */
    const double t7 = JLT_FMA(x[1], x[1], t6); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t8 = p[10]*x[4]; /* m*a3^2*s */
    const double t9 = JLT_FMA(x[4], t8, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t10 = p[58]*x[2]; /* 1/m*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/m*omega_tau */
    const double t12 = x[3]*p[60]; /* omega3*I3/m */
    const double t13 = JLT_FMA(x[3], t12, t7); /* omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t14 = JLT_FMA(t9, t11, t13); /* D*omega_tau*1/m*omega_tau + omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t15 = p[59]*t3; /* 1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s */
    const double t16 = JLT_FMA(t3, t15, t14); /* (b/R*R*I3*omega3 + G_level)/s*1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s + t14 */
    const double t17 = x[4]*p[1]; /* s*R */
    const double t18 = JLT_FMA(x[3], t17, t5); /* v_tau = omega3*s*R + (b/R*R*I3*omega3 + G_level)/s*1/I1*b/R */
    const double t19 = JLT_FMA(t18, t18, t16); /* energy/(1/2*m) = v_tau*v_tau + t16 */
    const double t20 = p[56]*t19; /* 1/2*m*energy/(1/2*m) */
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
    const double t6 = x[4]*p[62]; /* s*R^2*I1 */
    const double t7 = JLT_FMA(x[3], t6, t5); /* v_tau/(1/(R*I1)) = omega3*s*R^2*I1 + b*1/s*(b*I3*omega3 + G_level) */
    const double t8 = t0*t1; /* b*1/s */
    const double t9 = JLT_FMA(t2, t8, t4); /* d(v_tau)/d(gamma3)/(1/I1) = I3*omega3*b*1/s + 1/s*(b*I3*omega3 + G_level) */
    const double t10 = p[61]*t7; /* m/(R*I1^2)*v_tau/(1/(R*I1)) */
    const double t11 = t1*t4; /* 1/s*1/s*(b*I3*omega3 + G_level) */
    const double t12 = x[3]*p[33]; /* omega3*I3/(R*I1) */
    const double t13 = JLT_FMA(t11, t12, p[43]); /* 1/s*1/s*(b*I3*omega3 + G_level)*omega3*I3/(R*I1) + m*g*a3 */
    const double t14 = JLT_FMA(t9, t10, t13); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/(1/I1)*m/(R*I1^2)*v_tau/(1/(R*I1)) + 1/s*1/s*(b*I3*omega3 + G_level)*omega3*I3/(R*I1) + m*g*a3 */
    out[0] = t14;
    const double t15 = p[0]*x[1]; /* m*v_nu */
    out[1] = t15;
    const double t16 = x[4]*p[10]; /* s*m*a3^2 */
    const double t17 = JLT_FMA(x[4], t16, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t18 = x[2]*t17; /* omega_tau*D */
    out[2] = t18;
    const double t19 = t8*p[63]; /* b*1/s*I3/(R^2*I1) */
    const double t20 = JLT_FMA(t0, t19, x[4]); /* d(v_tau)/d(omega3)/R = b*b*1/s*I3/(R^2*I1) + s */
    const double t21 = t7*p[64]; /* v_tau/(1/(R*I1))*m/I1 */
    const double t22 = JLT_FMA(t4, t19, t2); /* 1/s*(b*I3*omega3 + G_level)*b*1/s*I3/(R^2*I1) + I3*omega3 */
    const double t23 = JLT_FMA(t20, t21, t22); /* d(energy)/d(omega3) = d(v_tau)/d(omega3)/R*v_tau/(1/(R*I1))*m/I1 + 1/s*(b*I3*omega3 + G_level)*b*1/s*I3/(R^2*I1) + I3*omega3 */
    out[3] = t23;
    const double t24 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t25 = t16*t24; /* s*m*a3^2*omega_tau*omega_tau */
    const double t26 = t11*p[14]; /* 1/s*1/s*(b*I3*omega3 + G_level)*1/(R^2*I1) */
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
    const double t3 = p[65]*t2; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level) */
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
        t21[k] = p[20]*t19[k] + (k == 0 ? 1.0 : 0);
        t22[k] = p[63]*t20[k];
        t23[k] = (k == 0 ? p[11] : 0) + t19[k];
        t24[k] = jlt_jet_product(t20, t22, k) + t23[k];
        t25[k] = jlt_jet_product(x4, t21, k);
        t26[k] = p[65]*t21[k];
        t27[k] = jlt_jet_product(t24, t25, k);
        t28[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t27, t28, k);
        t29[k] = jlt_jet_product(t24, t28, k);
        t30[k] = p[67]*t25[k];
        t31[k] = jlt_jet_product(t28, t30, k);
        t32[k] = p[5]*x3[k];
        t33[k] = jlt_jet_product(t20, t32, k) + (k == 0 ? p[6] : 0);
        t34[k] = jlt_jet_product(t26, t33, k);
        t35[k] = jlt_jet_product(t29, t34, k);
        t36[k] = jlt_jet_product(x4, t29, k);
        t37[k] = jlt_jet_product(x2, x0, k);
        t38[k] = jlt_jet_product(x2, t19, k);
        t39[k] = p[20]*t37[k];
        t40[k] = jlt_jet_product(t38, t39, k);
        t41[k] = t40[k] - p[66]*t19[k];
        t42[k] = jlt_jet_product(x4, t37, k);
        t43[k] = -t42[k];
        t44[k] = (k == 0 ? p[68] : 0) - x0[k]*p[69];
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
        t57[k] = t49[k] - p[12]*t55[k];
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    .sha256 = "1b6d453374f697d58e1412b96ff746b2599a2a450f7166c0e5909287ba92fdcb",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 70,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 26, 11, 1, 0, 0, 13, 11 }, { 15, 66, 0, 8, 0, 0, 11, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level, d(v_nu)/dtau, a part of d(omega_tau)/dtau, a part of d(omega_tau)/dtau, e = gamma3*a3 + R, V = omega_tau*e + v_nu, a3*I3 - gamma3*(R*(I1 - I3)), a part of d(omega3)/dtau" },
    .jacobian = { jacobian, 25, { 12, 58, 26, 1, 0, 0, 14, 16 }, { 57, 322, 0, 44, 0, 0, 16, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level, (2*I3/I1^2)*b/R*1/s*(b/R*(R*I3)*omega3 + G_level)*1/s + omega3*(R*I3/I1), d(d(v_nu)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(omega3), a part of d(d(omega_tau)/dtau)/d(gamma3), gamma3*1/s*(b/R*(R*I3)*omega3 + G_level)*1/s + omega3*(1/2*R*I3), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(omega3), 1/(D/I1) - s*1/(D/I1)*(2*m*a3^2/I1)*s*1/(D/I1), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega_tau*(a3/(R^2*I1)) - 1/(Theta/(m*R^2*I1))*V*b/R*(2*I3/(R^2*I1^2)), omega_tau*(2*a3*I3^2/(R*I1^2)) - (2*I3*(I1 - I3)/I1^2)*omega_tau*gamma3, a part of d(d(omega3)/dtau)/d(gamma3), a part of d(d(omega3)/dtau)/d(gamma3), a part of d(d(omega3)/dtau)/d(gamma3), a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(d(omega3)/dtau)/d(omega_tau), a part of d(d(omega3)/dtau)/d(omega3), a part of d(d(omega3)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 62, 28, 1, 0, 0, 15, 20 }, { 65, 368, 0, 51, 0, 0, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level, a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), e = gamma3*a3 + R, V = omega_tau*e + v_nu, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), gamma3*1/s*(b/R*(R*I3)*omega3 + G_level)*(2/(R*I1))*1/s + omega3*(I3/I1), b/R*1/s*(b/R*(R*I3)*omega3 + G_level)*(2/(R*I1))*1/s + omega3, d(d(v_nu)/dtau)/d(gamma3), a part of d(d(omega3)/dtau)/d(omega_tau), d(numerator of d(omega_tau)/dt over D)/d(gamma3), a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s), (m*R^2*(I1 - I3))*s*s*omega_tau - (m*R*I3)*V, b/R*(m*R*I3)*V + s*s*omega_tau*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))), numerator of d(omega_tau)/dt over D, a part of d(d(omega_tau)/dtau)/d(omega3), d(v_nu)/dtau, d(d(v_nu)/dtau)/d(omega3), d(numerator of d(omega_tau)/dt over D)/d(s), a part of d(d(omega_tau)/dtau)/d(s), d(numerator of d(omega3)/dt over Theta)/d(s), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(s)" },
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
