/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_omega_n: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   26   11    1    0    0     11   10   (89)
 *  jacobian            11   60   25    1    0    0     14   15   (423)
 *  rhs_jacobian        10   59   28    1    0    0     15   20   (484)
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
 *      a part of d(d(omega3)/dtau)/d(omega_tau), ((I1 - I3)/I1)*gamma3*s*omega_tau - (a3*I3/(R*I1))*s*omega_tau,
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(omega3),
 *      d(numerator of d(omega_tau)/dt over D)/d(gamma3), numerator of d(omega_tau)/dt over D,
 *      a part of d(d(omega_tau)/dtau)/d(omega3), d(numerator of d(omega_tau)/dt over D)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(s), (m*R^2*(I1 - I3))*s*s*omega_tau - (m*R*I3)*V,
 *      (m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)))*s*s*omega_tau + b/R*(m*R*I3)*V,
 *      (2*I3/I1^2)*b/R*1/s*1/s*(b/R*(R*I3)*omega3 + G_level) + omega3*(R*I3/I1), d(d(v_nu)/dtau)/d(gamma3),
 *      d(d(v_nu)/dtau)/d(omega3), d(v_nu)/dtau, a part of d(d(omega3)/dtau)/d(gamma3), a part of d(d(omega3)/dtau)/d(s)
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
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_omega_n;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega_n;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_omega_n_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_omega_n_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_omega_n_avx512;

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
    out[63] = t12;
    const double t13 = (-1.0)/t12; /* (-1)/(I1*R*R) */
    out[14] = t13;
    const double t14 = t5*t8; /* a3*a3*m*R*R */
    const double t15 = params[4]*t14; /* I1*a3*a3*m*R*R */
    out[15] = t15;
    const double t16 = t8*params[2]; /* m*R*R*g */
    const double t17 = params[3]*t16; /* a3*m*R*R*g */
    const double t18 = params[4]*t17; /* I1*a3*m*R*R*g */
    out[16] = t18;
    const double t19 = params[3]*params[5]; /* a3*I3 */
    out[17] = t19;
    const double t20 = params[4] - params[5]; /* I1 - I3 */
    const double t21 = params[1]*t20; /* R*(I1 - I3) */
    out[18] = t21;
    const double t22 = t6/params[4]; /* m*a3*a3/I1 */
    out[19] = t22;
    const double t23 = t4/params[4]; /* R*I3/I1 */
    out[20] = t23;
    const double t24 = params[1]*params[4]; /* R*I1 */
    const double t25 = 2.0/t24; /* 2/(R*I1) */
    out[21] = t25;
    const double t26 = (-2.0)/t1; /* (-2)/(R*I1*I1) */
    out[22] = t26;
    const double t27 = params[5]*params[5]; /* I3*I3 */
    const double t28 = t27/t0; /* I3*I3/(I1*I1) */
    out[23] = t28;
    const double t29 = params[5]*2.0; /* I3*2 */
    const double t30 = t29/t1; /* I3*2/(R*I1*I1) */
    out[24] = t30;
    const double t31 = t0*t7; /* I1*I1*R*R */
    const double t32 = 1.0/t31; /* 1/(I1*I1*R*R) */
    out[25] = t32;
    const double t33 = params[0]*2.0; /* m*2 */
    const double t34 = t5*t33; /* a3*a3*m*2 */
    out[50] = t34;
    const double t35 = t34/params[4]; /* a3*a3*m*2/I1 */
    out[26] = t35;
    const double t36 = params[5]/t1; /* I3/(R*I1*I1) */
    out[27] = t36;
    const double t37 = params[4]*t0; /* I1*I1*I1 */
    const double t38 = params[1]*t37; /* R*I1*I1*I1 */
    const double t39 = params[5]*t34; /* I3*a3*a3*m*2 */
    const double t40 = t39/t38; /* I3*a3*a3*m*2/(R*I1*I1*I1) */
    out[28] = t40;
    const double t41 = params[2]*t33; /* g*m*2 */
    const double t42 = params[3]*t41; /* a3*g*m*2 */
    out[51] = t42;
    const double t43 = t42/params[4]; /* a3*g*m*2/I1 */
    out[29] = t43;
    const double t44 = 2.0/t31; /* 2/(I1*I1*R*R) */
    out[30] = t44;
    const double t45 = params[3]/t12; /* a3/(I1*R*R) */
    out[31] = t45;
    const double t46 = t29/t31; /* I3*2/(I1*I1*R*R) */
    out[32] = t46;
    const double t47 = t20/params[4]; /* (I1 - I3)/I1 */
    out[33] = t47;
    const double t48 = params[3]*2.0; /* a3*2 */
    const double t49 = params[5]*t48; /* I3*a3*2 */
    const double t50 = t49/t1; /* I3*a3*2/(R*I1*I1) */
    out[34] = t50;
    const double t51 = t20*2.0; /* (I1 - I3)*2 */
    const double t52 = t51/t0; /* (I1 - I3)*2/(I1*I1) */
    out[35] = t52;
    const double t53 = params[5]/t24; /* I3/(R*I1) */
    out[36] = t53;
    const double t54 = 1.0/t12; /* 1/(I1*R*R) */
    out[37] = t54;
    const double t55 = t19/t24; /* a3*I3/(R*I1) */
    out[38] = t55;
    const double t56 = params[4]/t8; /* I1/(m*R*R) */
    out[39] = t56;
    const double t57 = 2.0/t12; /* 2/(I1*R*R) */
    out[40] = t57;
    const double t58 = params[4]*params[5]; /* I1*I3 */
    out[41] = t58;
    const double t59 = params[4]*t8; /* I1*m*R*R */
    out[42] = t59;
    const double t60 = params[5]*t8; /* I3*m*R*R */
    out[43] = t60;
    const double t61 = params[0]*params[2]; /* m*g */
    const double t62 = params[3]*t61; /* a3*m*g */
    out[44] = t62;
    const double t63 = params[1]*params[0]; /* R*m */
    const double t64 = params[3]*t63; /* a3*R*m */
    const double t65 = params[5]*t64; /* I3*a3*R*m */
    out[45] = t65;
    const double t66 = t8*t20; /* m*R*R*(I1 - I3) */
    out[46] = t66;
    const double t67 = t29/t0; /* I3*2/(I1*I1) */
    out[47] = t67;
    const double t68 = t27/params[4]; /* I3*I3/I1 */
    out[48] = t68;
    const double t69 = t29/t24; /* I3*2/(R*I1) */
    out[49] = t69;
    const double t70 = t7*t33; /* R*R*m*2 */
    const double t71 = params[5]*t70; /* I3*R*R*m*2 */
    out[52] = t71;
    const double t72 = params[3]*params[0]; /* a3*m */
    out[53] = t72;
    const double t73 = params[5]*t63; /* I3*R*m */
    out[54] = t73;
    const double t74 = params[4]*t70; /* I1*R*R*m*2 */
    out[55] = t74;
    const double t75 = params[5]*params[0]; /* I3*m */
    out[56] = t75;
    const double t76 = params[0]/2.0; /* m/2 */
    out[57] = t76;
    const double t77 = params[2]*2.0; /* g*2 */
    const double t78 = params[3]*t77; /* a3*g*2 */
    out[58] = t78;
    const double t79 = 1.0/params[0]; /* 1/m */
    out[59] = t79;
    const double t80 = 1.0/t59; /* 1/(I1*m*R*R) */
    out[60] = t80;
    const double t81 = params[5]/params[0]; /* I3/m */
    out[61] = t81;
    const double t82 = params[0]/t1; /* m/(R*I1*I1) */
    out[62] = t82;
    const double t83 = params[5]/t12; /* I3/(I1*R*R) */
    out[64] = t83;
    const double t84 = params[0]/params[4]; /* m/I1 */
    out[65] = t84;
    const double t85 = 1.0/t24; /* 1/(R*I1) */
    out[66] = t85;
    const double t86 = t62/params[4]; /* a3*m*g/I1 */
    out[67] = t86;
    const double t87 = (-1.0)/params[1]; /* (-1)/R */
    out[68] = t87;
    const double t88 = t19/params[4]; /* a3*I3/I1 */
    out[69] = t88;
    const double t89 = t21/params[4]; /* R*(I1 - I3)/I1 */
    out[70] = t89;
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
    const double t18 = x[3]*t4; /* omega3*(b/R*R*I3*omega3 + G_level) */
    const double t19 = JLT_FMA(p[13], t18, t17); /* 1/I1*omega3*(b/R*R*I3*omega3 + G_level) + t15*1/(R*I1^2)*b/R */
    out[1] = t19;
    const double t20 = p[9]*t18; /* R*I3*omega3*(b/R*R*I3*omega3 + G_level) */
    const double t21 = x[2]*p[15]; /* omega_tau*m*R^2*a3^2*I1 */
    const double t22 = JLT_FMS(t1, t21, t15); /* omega_tau*s*s*omega_tau*m*R^2*a3^2*I1 - t15 */
    const double t23 = JLT_FMA(t0, p[16], t20); /* s*s*m*R^2*g*a3*I1 + R*I3*omega3*(b/R*R*I3*omega3 + G_level) */
    const double t24 = JLT_FNMA(x[0], t22, t23); /* s*s*m*R^2*g*a3*I1 + R*I3*omega3*(b/R*R*I3*omega3 + G_level) - gamma3*(omega_tau*s*s*omega_tau*m*R^2*a3^2*I1 - t15) */
    const double t25 = x[4]*p[14]; /* s*(-1/(R^2*I1)) */
    const double t26 = t12*t25; /* 1/(s*D)*s*(-1/(R^2*I1)) */
    const double t27 = t24*t26; /* t24*1/(s*D)*s*(-1/(R^2*I1)) */
    out[2] = t27;
    const double t28 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t29 = JLT_FMA(x[2], t28, x[1]); /* V = omega_tau*e + v_nu */
    const double t30 = t4*t29; /* (b/R*R*I3*omega3 + G_level)*V */
    const double t31 = JLT_FNMA(x[0], p[18], p[17]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t32 = x[3]*p[1]; /* omega3*R */
    const double t33 = t1*t32; /* omega_tau*s*s*omega3*R */
    const double t34 = JLT_FMA(t31, t33, t30); /* (a3*I3 - gamma3*R*(I1 - I3))*omega_tau*s*s*omega3*R + (b/R*R*I3*omega3 + G_level)*V */
    const double t35 = t9*p[14]; /* s*D*(-1/(R^2*I1)) */
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
    const double t6 = JLT_FMA(t0, p[19], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
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
    const double t18 = t14*t15; /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t19 = t3*t18; /* b/R*1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t20 = JLT_FMA(p[21], t19, x[3]); /* 2/(R*I1)*b/R*1/s*(b/R*R*I3*omega3 + G_level)*1/s + omega3 */
    const double t21 = p[20]*t20; /* R*I3/I1*(2/(R*I1)*b/R*1/s*(b/R*R*I3*omega3 + G_level)*1/s + omega3) */
    const double t22 = JLT_FMA(x[3], t21, t17); /* omega3*t21 + 1/(R*I1^2)*t16 */
    out[5] = t22;
    const double t23 = x[4]*p[13]; /* s*1/I1 */
    const double t24 = t15*t23; /* (b/R*R*I3*omega3 + G_level)*1/s*s*1/I1 */
    const double t25 = JLT_FMA(t3, t21, t24); /* b/R*t21 + (b/R*R*I3*omega3 + G_level)*1/s*s*1/I1 */
    out[8] = t25;
    const double t26 = t15*p[22]; /* (b/R*R*I3*omega3 + G_level)*1/s*(-2/(R*I1^2)) */
    const double t27 = t19*t26; /* b/R*1/s*(b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level)*1/s*(-2/(R*I1^2)) */
    out[9] = t27;
    const double t28 = x[4]*t13; /* 1/(D/I1) = s*1/(s*(D/I1)) */
    const double t29 = x[4]*t28; /* s*1/(D/I1) */
    const double t30 = t1*t29; /* s*omega_tau*s*1/(D/I1) */
    const double t31 = x[2]*p[19]; /* omega_tau*m*a3^2/I1 */
    const double t32 = t30*t31; /* s*omega_tau*s*1/(D/I1)*omega_tau*m*a3^2/I1 */
    const double t33 = x[3]*p[23]; /* omega3*I3^2/I1^2 */
    const double t34 = x[0]*t18; /* gamma3*1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t35 = JLT_FMA(p[24], t34, t33); /* 2*I3/(R*I1^2)*gamma3*1/s*(b/R*R*I3*omega3 + G_level)*1/s + omega3*I3^2/I1^2 */
    const double t36 = t16*p[25]; /* t16*1/(R^2*I1^2) */
    const double t37 = JLT_FMA(x[3], t35, t36); /* omega3*t35 + t16*1/(R^2*I1^2) */
    const double t38 = JLT_FNMA(t28, t37, t32); /* s*omega_tau*s*1/(D/I1)*omega_tau*m*a3^2/I1 - 1/(D/I1)*(omega3*t35 + t16*1/(R^2*I1^2)) */
    out[10] = t38;
    const double t39 = x[0]*p[26]; /* gamma3*2*m*a3^2/I1 */
    const double t40 = t30*t39; /* s*omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[12] = t40;
    const double t41 = t15*p[27]; /* (b/R*R*I3*omega3 + G_level)*1/s*I3/(R*I1^2) */
    const double t42 = t29*t41; /* s*1/(D/I1)*(b/R*R*I3*omega3 + G_level)*1/s*I3/(R*I1^2) */
    const double t43 = t3*t28; /* b/R*1/(D/I1) */
    const double t44 = JLT_FMA(t35, t43, t42); /* t35*b/R*1/(D/I1) + s*1/(D/I1)*(b/R*R*I3*omega3 + G_level)*1/s*I3/(R*I1^2) */
    const double t45 = -t44; /* -t44 */
    out[13] = t45;
    const double t46 = x[4]*x[3]; /* s*omega3 */
    const double t47 = p[28]*t46; /* 2*m*a3^2*I3/(R*I1^3)*s*omega3 */
    const double t48 = JLT_FMA(x[2], x[2], t36); /* omega_tau*omega_tau + t16*1/(R^2*I1^2) */
    const double t49 = JLT_FMS(t15, t47, p[29]); /* (b/R*R*I3*omega3 + G_level)*1/s*2*m*a3^2*I3/(R*I1^3)*s*omega3 - 2*m*g*a3/I1 */
    const double t50 = JLT_FMA(t39, t48, t49); /* gamma3*2*m*a3^2/I1*(omega_tau*omega_tau + t16*1/(R^2*I1^2)) + t49 */
    const double t51 = t28*t29; /* 1/(D/I1)*s*1/(D/I1) */
    const double t52 = t50*t51; /* t50*1/(D/I1)*s*1/(D/I1) */
    const double t53 = t28*p[30]; /* 1/(D/I1)*2/(R^2*I1^2) */
    const double t54 = t15*t53; /* (b/R*R*I3*omega3 + G_level)*1/s*1/(D/I1)*2/(R^2*I1^2) */
    const double t55 = JLT_FMA(t34, t54, t52); /* gamma3*1/s*(b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level)*1/s*1/(D/I1)*2/(R^2*I1^2) + t50*1/(D/I1)*s*1/(D/I1) */
    out[14] = t55;
    const double t56 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = s*D/I1*1/(Theta/(m*R^2*I1)*s*D/I1) */
    const double t57 = x[4]*t56; /* s*1/(Theta/(m*R^2*I1)) */
    const double t58 = t15*t57; /* (b/R*R*I3*omega3 + G_level)*1/s*s*1/(Theta/(m*R^2*I1)) */
    const double t59 = x[2]*p[31]; /* omega_tau*a3/(R^2*I1) */
    const double t60 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t61 = JLT_FMA(x[2], t60, x[1]); /* V = omega_tau*e + v_nu */
    const double t62 = t56*t61; /* 1/(Theta/(m*R^2*I1))*V */
    const double t63 = t3*p[32]; /* b/R*2*I3/(R^2*I1^2) */
    const double t64 = JLT_FNMA(t62, t63, t59); /* omega_tau*a3/(R^2*I1) - 1/(Theta/(m*R^2*I1))*V*b/R*2*I3/(R^2*I1^2) */
    const double t65 = t58*t64; /* (b/R*R*I3*omega3 + G_level)*1/s*s*1/(Theta/(m*R^2*I1))*t64 */
    const double t66 = t1*t57; /* s*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t67 = JLT_FNMA(x[0], p[35], p[34]); /* 2*a3*I3/(R*I1^2) - gamma3*2*(I1 - I3)/I1^2 */
    const double t68 = p[5]*t67; /* I3*(2*a3*I3/(R*I1^2) - gamma3*2*(I1 - I3)/I1^2) */
    const double t69 = t56*t68; /* 1/(Theta/(m*R^2*I1))*I3*(2*a3*I3/(R*I1^2) - gamma3*2*(I1 - I3)/I1^2) */
    const double t70 = JLT_FMA(t3, t69, p[33]); /* b/R*t69 + (I1 - I3)/I1 */
    const double t71 = t62*p[36]; /* 1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    const double t72 = JLT_FMS(t66, t70, t71); /* s*omega_tau*s*1/(Theta/(m*R^2*I1))*(b/R*t69 + (I1 - I3)/I1) - 1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    const double t73 = JLT_FMS(x[3], t72, t65); /* omega3*t72 - (b/R*R*I3*omega3 + G_level)*1/s*s*1/(Theta/(m*R^2*I1))*t64 */
    out[15] = t73;
    const double t74 = t58*p[37]; /* (b/R*R*I3*omega3 + G_level)*1/s*s*1/(Theta/(m*R^2*I1))*1/(R^2*I1) */
    const double t75 = -t74; /* -t74 */
    out[16] = t75;
    const double t76 = t60*t74; /* e*t74 */
    const double t77 = JLT_FNMA(x[0], p[33], p[38]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t78 = t46*t77; /* s*omega3*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t79 = JLT_FMA(t57, t78, t76); /* s*1/(Theta/(m*R^2*I1))*s*omega3*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + e*t74 */
    const double t80 = -t79; /* -t79 */
    out[17] = t80;
    const double t81 = t3*t71; /* b/R*1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    const double t82 = JLT_FMA(t66, t77, t81); /* s*omega_tau*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + b/R*1/(Theta/(m*R^2*I1))*V*I3/(R*I1) */
    const double t83 = -t82; /* -t82 */
    out[18] = t83;
    const double t84 = t7 + p[39]; /* b/R*b/R + I1/(m*R^2) */
    const double t85 = x[2]*x[3]; /* omega_tau*omega3 */
    const double t86 = t84*t85; /* (b/R*b/R + I1/(m*R^2))*omega_tau*omega3 */
    const double t87 = t69*t86; /* t69*(b/R*b/R + I1/(m*R^2))*omega_tau*omega3 */
    const double t88 = t61*p[40]; /* V*2/(R^2*I1) */
    const double t89 = JLT_FNMA(t58, t88, t87); /* t69*(b/R*b/R + I1/(m*R^2))*omega_tau*omega3 - (b/R*R*I3*omega3 + G_level)*1/s*s*1/(Theta/(m*R^2*I1))*V*2/(R^2*I1) */
    const double t90 = t57*t89; /* s*1/(Theta/(m*R^2*I1))*t89 */
    const double t91 = -t90; /* -s*1/(Theta/(m*R^2*I1))*t89 */
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
    const double t2 = JLT_FMA(p[10], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t3 = p[43]*t0; /* m*R^2*I3*b/R */
    const double t4 = JLT_FMA(p[42], t1, p[41]); /* m*R^2*I1*s*s + I1*I3 */
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
    const double t19 = t11*t18; /* 1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t20 = p[10]*t15; /* m*a3^2*s*omega_tau */
    const double t21 = t15*t20; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t22 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t23 = t18*t18; /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t24 = JLT_FNMA(p[37], t23, t21); /* s*omega_tau*m*a3^2*s*omega_tau - 1/(R^2*I1)*t23 */
    const double t25 = p[7]*t23; /* 1/(R*I1^2)*t23 */
    const double t26 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t27 = p[0]*t14; /* m*(b/R*R*I3*omega3 + G_level) */
    const double t28 = t22*t27; /* e*m*(b/R*R*I3*omega3 + G_level) */
    const double t29 = JLT_FNMA(x[0], p[46], p[45]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t30 = x[0]*t15; /* gamma3*s*omega_tau */
    const double t31 = -t30; /* -gamma3*s*omega_tau */
    out[4] = t31;
    const double t32 = x[4]*t15; /* s*s*omega_tau */
    out[0] = t32;
    const double t33 = t26*t27; /* V*m*(b/R*R*I3*omega3 + G_level) */
    const double t34 = p[54]*t26; /* m*R*I3*V */
    const double t35 = t10*t27; /* 1/Theta*m*(b/R*R*I3*omega3 + G_level) */
    const double t36 = -t35; /* -1/Theta*m*(b/R*R*I3*omega3 + G_level) */
    out[21] = t36;
    const double t37 = x[3]*t29; /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t38 = JLT_FMA(t32, t37, t33); /* s*s*omega_tau*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*m*(b/R*R*I3*omega3 + G_level) */
    const double t39 = JLT_FMA(t1, t37, t28); /* s*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*m*(b/R*R*I3*omega3 + G_level) */
    const double t40 = t10*t38; /* 1/Theta*t38 */
    const double t41 = t10*t39; /* 1/Theta*t39 */
    const double t42 = -t41; /* -1/Theta*t39 */
    out[22] = t42;
    const double t43 = -t40; /* -1/Theta*t38 */
    out[3] = t43;
    const double t44 = p[50]*t30; /* 2*m*a3^2*gamma3*s*omega_tau */
    const double t45 = p[33]*t30; /* (I1 - I3)/I1*gamma3*s*omega_tau */
    const double t46 = JLT_FNMA(p[38], t15, t45); /* (I1 - I3)/I1*gamma3*s*omega_tau - a3*I3/(R*I1)*s*omega_tau */
    const double t47 = x[0]*t24; /* gamma3*(s*omega_tau*m*a3^2*s*omega_tau - 1/(R^2*I1)*t23) */
    const double t48 = JLT_FNMA(p[44], t1, t47); /* gamma3*(s*omega_tau*m*a3^2*s*omega_tau - 1/(R^2*I1)*t23) - m*g*a3*s*s */
    const double t49 = x[3]*p[48]; /* omega3*I3^2/I1 */
    const double t50 = x[0]*t19; /* gamma3*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t51 = JLT_FMA(p[49], t50, t49); /* 2*I3/(R*I1)*gamma3*1/s*1/s*(b/R*R*I3*omega3 + G_level) + omega3*I3^2/I1 */
    const double t52 = t0*t19; /* b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t53 = JLT_FNMA(x[3], t51, t24); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = s*omega_tau*m*a3^2*s*omega_tau - 1/(R^2*I1)*t23 - omega3*t51 */
    const double t54 = t12*t53; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    out[15] = t54;
    const double t55 = x[2]*t44; /* omega_tau*2*m*a3^2*gamma3*s*omega_tau */
    const double t56 = JLT_FNMA(x[4], p[51], t55); /* omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 */
    const double t57 = x[2]*p[53]; /* omega_tau*m*a3 */
    const double t58 = t14*t57; /* (b/R*R*I3*omega3 + G_level)*omega_tau*m*a3 */
    const double t59 = p[36]*t14; /* I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t60 = JLT_FNMA(x[3], t59, t48); /* numerator of d(omega_tau)/dt over D = t48 - omega3*I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t61 = JLT_FMA(t0, t51, t59); /* b/R*t51 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t62 = p[13]*t14; /* 1/I1*(b/R*R*I3*omega3 + G_level) */
    const double t63 = t12*t61; /* 1/D*(b/R*t51 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level)) */
    const double t64 = -t63; /* -1/D*(b/R*t51 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level)) */
    out[18] = t64;
    const double t65 = t12*t60; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t65;
    const double t66 = x[4]*t12; /* s*1/D */
    const double t67 = t44*t66; /* 2*m*a3^2*gamma3*s*omega_tau*s*1/D */
    out[17] = t67;
    const double t68 = p[50]*t66; /* 2*m*a3^2*s*1/D */
    const double t69 = p[40]*t18; /* 2/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t70 = JLT_FMA(t50, t69, t56); /* d(numerator of d(omega_tau)/dt over D)/d(s) = gamma3*1/s*1/s*(b/R*R*I3*omega3 + G_level)*2/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level) + omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 */
    const double t71 = JLT_FNMA(t60, t68, t70); /* d(numerator of d(omega_tau)/dt over D)/d(s) - numerator of d(omega_tau)/dt over D*2*m*a3^2*s*1/D */
    const double t72 = t12*t71; /* 1/D*t71 */
    out[19] = t72;
    const double t73 = p[22]*t18; /* (-2/(R*I1^2))*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t74 = t52*t73; /* b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level)*(-2/(R*I1^2))*1/s*(b/R*R*I3*omega3 + G_level) */
    out[14] = t74;
    const double t75 = JLT_FMS(p[46], t32, t34); /* m*R^2*(I1 - I3)*s*s*omega_tau - m*R*I3*V */
    const double t76 = JLT_FMS(x[3], t75, t58); /* omega3*(m*R^2*(I1 - I3)*s*s*omega_tau - m*R*I3*V) - (b/R*R*I3*omega3 + G_level)*omega_tau*m*a3 */
    const double t77 = t0*t34; /* b/R*m*R*I3*V */
    const double t78 = JLT_FMA(t29, t32, t77); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*s*omega_tau + b/R*m*R*I3*V */
    const double t79 = t10*t78; /* 1/Theta*t78 */
    const double t80 = -t79; /* -1/Theta*t78 */
    out[23] = t80;
    const double t81 = x[3]*p[20]; /* omega3*R*I3/I1 */
    const double t82 = JLT_FMA(p[47], t52, t81); /* 2*I3/I1^2*b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) + omega3*R*I3/I1 */
    const double t83 = JLT_FMA(x[3], t82, t25); /* omega3*t82 + 1/(R*I1^2)*t23 */
    out[10] = t83;
    const double t84 = JLT_FMA(t0, t82, t62); /* b/R*t82 + 1/I1*(b/R*R*I3*omega3 + G_level) */
    out[13] = t84;
    const double t85 = t0*t25; /* b/R*1/(R*I1^2)*t23 */
    const double t86 = JLT_FMA(x[3], t62, t85); /* omega3*1/I1*(b/R*R*I3*omega3 + G_level) + b/R*1/(R*I1^2)*t23 */
    out[1] = t86;
    const double t87 = p[52]*t0; /* 2*m*R^2*I3*b/R */
    const double t88 = JLT_FMA(t40, t87, t76); /* 1/Theta*t38*2*m*R^2*I3*b/R + t76 */
    const double t89 = t10*t88; /* 1/Theta*(1/Theta*t38*2*m*R^2*I3*b/R + t76) */
    out[20] = t89;
    const double t90 = x[4]*t40; /* s*1/Theta*t38 */
    const double t91 = JLT_FMA(x[3], t46, t90); /* omega3*((I1 - I3)/I1*gamma3*s*omega_tau - a3*I3/(R*I1)*s*omega_tau) + s*1/Theta*t38 */
    const double t92 = p[55]*t10; /* 2*m*R^2*I1*1/Theta */
    const double t93 = t91*t92; /* t91*2*m*R^2*I1*1/Theta */
    out[24] = t93;
    const double t94 = x[4]*x[0]; /* s*gamma3 */
    const double t95 = -t94; /* -s*gamma3 */
    out[27] = t95;
    const double t96 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t97 = -t96; /* -omega_tau*gamma3 */
    out[29] = t97;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = t1*p[56]; /* b*m*I3 */
    const double t3 = JLT_FMA(p[42], t0, p[41]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t1, t2, t3); /* Theta = b*b*m*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(t0, p[10], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t4*t5; /* Theta*D */
    const double t7 = t0*x[2]; /* s*s*omega_tau */
    const double t8 = x[0]*t7; /* gamma3*s*s*omega_tau */
    const double t9 = p[50]*t8; /* 2*m*a3^2*gamma3*s*s*omega_tau */
    const double t10 = t4*t9; /* Theta*2*m*a3^2*gamma3*s*s*omega_tau */
    const double t11 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t12 = JLT_FMA(x[2], t11, x[1]); /* V = omega_tau*e + v_nu */
    const double t13 = t8*p[46]; /* gamma3*s*s*omega_tau*m*R^2*(I1 - I3) */
    const double t14 = JLT_FNMA(t7, p[45], t13); /* gamma3*s*s*omega_tau*m*R^2*(I1 - I3) - s*s*omega_tau*m*R*a3*I3 */
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
    const double t6 = p[58]*x[0]; /* 2*g*a3*gamma3 */
    const double t7 = JLT_FMA(x[1], x[1], t6); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t8 = p[10]*x[4]; /* m*a3^2*s */
    const double t9 = JLT_FMA(x[4], t8, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t10 = p[59]*x[2]; /* 1/m*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/m*omega_tau */
    const double t12 = x[3]*p[61]; /* omega3*I3/m */
    const double t13 = JLT_FMA(x[3], t12, t7); /* omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t14 = JLT_FMA(t9, t11, t13); /* D*omega_tau*1/m*omega_tau + omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t15 = p[60]*t3; /* 1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s */
    const double t16 = JLT_FMA(t3, t15, t14); /* (b/R*R*I3*omega3 + G_level)/s*1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s + t14 */
    const double t17 = x[4]*p[1]; /* s*R */
    const double t18 = JLT_FMA(x[3], t17, t5); /* v_tau = omega3*s*R + (b/R*R*I3*omega3 + G_level)/s*1/I1*b/R */
    const double t19 = JLT_FMA(t18, t18, t16); /* energy/(1/2*m) = v_tau*v_tau + t16 */
    const double t20 = p[57]*t19; /* 1/2*m*energy/(1/2*m) */
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
    const double t6 = x[4]*p[63]; /* s*R^2*I1 */
    const double t7 = JLT_FMA(x[3], t6, t5); /* v_tau/(1/(R*I1)) = omega3*s*R^2*I1 + b*1/s*(b*I3*omega3 + G_level) */
    const double t8 = t0*t1; /* b*1/s */
    const double t9 = JLT_FMA(t2, t8, t4); /* d(v_tau)/d(gamma3)/(1/I1) = I3*omega3*b*1/s + 1/s*(b*I3*omega3 + G_level) */
    const double t10 = p[62]*t7; /* m/(R*I1^2)*v_tau/(1/(R*I1)) */
    const double t11 = t1*t4; /* 1/s*1/s*(b*I3*omega3 + G_level) */
    const double t12 = x[3]*p[36]; /* omega3*I3/(R*I1) */
    const double t13 = JLT_FMA(t11, t12, p[44]); /* 1/s*1/s*(b*I3*omega3 + G_level)*omega3*I3/(R*I1) + m*g*a3 */
    const double t14 = JLT_FMA(t9, t10, t13); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/(1/I1)*m/(R*I1^2)*v_tau/(1/(R*I1)) + 1/s*1/s*(b*I3*omega3 + G_level)*omega3*I3/(R*I1) + m*g*a3 */
    out[0] = t14;
    const double t15 = p[0]*x[1]; /* m*v_nu */
    out[1] = t15;
    const double t16 = x[4]*p[10]; /* s*m*a3^2 */
    const double t17 = JLT_FMA(x[4], t16, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t18 = x[2]*t17; /* omega_tau*D */
    out[2] = t18;
    const double t19 = t8*p[64]; /* b*1/s*I3/(R^2*I1) */
    const double t20 = JLT_FMA(t0, t19, x[4]); /* d(v_tau)/d(omega3)/R = b*b*1/s*I3/(R^2*I1) + s */
    const double t21 = t7*p[65]; /* v_tau/(1/(R*I1))*m/I1 */
    const double t22 = JLT_FMA(t4, t19, t2); /* 1/s*(b*I3*omega3 + G_level)*b*1/s*I3/(R^2*I1) + I3*omega3 */
    const double t23 = JLT_FMA(t20, t21, t22); /* d(energy)/d(omega3) = d(v_tau)/d(omega3)/R*v_tau/(1/(R*I1))*m/I1 + 1/s*(b*I3*omega3 + G_level)*b*1/s*I3/(R^2*I1) + I3*omega3 */
    out[3] = t23;
    const double t24 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t25 = t16*t24; /* s*m*a3^2*omega_tau*omega_tau */
    const double t26 = t11*p[37]; /* 1/s*1/s*(b*I3*omega3 + G_level)*1/(R^2*I1) */
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
    const double t3 = p[66]*t2; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level) */
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t19[k] = jlt_jet_product(x4, x4, k);
        t20[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t21[k] = p[5]*x3[k];
        t22[k] = jlt_jet_product(t20, t21, k) + (k == 0 ? p[6] : 0);
        t23[k] = jlt_jet_product(x2, x0, k);
        t24[k] = jlt_jet_product(x2, t19, k);
        t25[k] = jlt_jet_quotient((k == 0 ? p[66] : 0), x4, t25, k);
        t26[k] = jlt_jet_product(t22, t25, k);
        t27[k] = p[19]*t23[k];
        t28[k] = jlt_jet_product(t24, t27, k);
        t29[k] = t28[k] - p[67]*t19[k];
        t30[k] = jlt_jet_product(x4, t23, k);
        t31[k] = -t30[k];
        t32[k] = jlt_jet_product(t26, t26, k);
        t33[k] = jlt_jet_product(x4, t26, k);
        t34[k] = t29[k] - jlt_jet_product(x0, t32, k);
        t35[k] = jlt_jet_product(t20, t32, k);
        t36[k] = p[64]*t20[k];
        t37[k] = (k == 0 ? p[11] : 0) + t19[k];
        t38[k] = jlt_jet_product(t20, t36, k) + t37[k];
        t39[k] = p[19]*t19[k] + (k == 0 ? 1.0 : 0);
        t40[k] = jlt_jet_quotient((k == 0 ? p[68] : 0), t38, t40, k);
        t41[k] = jlt_jet_product(x3, t33, k);
        t42[k] = p[1]*t41[k] + t35[k];
        t43[k] = t34[k] - p[12]*t41[k];
        t44[k] = jlt_jet_quotient(t43[k], t39, t44, k);
        t45[k] = (k == 0 ? p[69] : 0) - x0[k]*p[70];
        t46[k] = jlt_jet_product(x3, t45, k);
        t47[k] = jlt_jet_product(t24, t46, k);
        t48[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t49[k] = jlt_jet_product(x2, t48, k) + x1[k];
        t50[k] = jlt_jet_product(t33, t49, k) + t47[k];
        t51[k] = jlt_jet_product(t40, t50, k);
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t24[k]/(k + 1);
        next[1] = x1[k + 1] = t42[k]/(k + 1);
        next[2] = x2[k + 1] = t44[k]/(k + 1);
        next[3] = x3[k + 1] = t51[k]/(k + 1);
        next[4] = x4[k + 1] = t31[k]/(k + 1);
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

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_omega_n = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "level_omega_n",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 7, .prepared_count = 71,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 26, 11, 1, 0, 0, 11, 10 }, { 15, 66, 0, 8, 0, 0, 11, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level, d(v_nu)/dtau, a part of d(omega_tau)/dtau, a part of d(omega_tau)/dtau, e = gamma3*a3 + R, V = omega_tau*e + v_nu, a3*I3 - gamma3*(R*(I1 - I3)), a part of d(omega3)/dtau" },
    .jacobian = { jacobian, 25, { 11, 60, 25, 1, 0, 0, 14, 15 }, { 57, 322, 0, 44, 0, 0, 16, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level, (2/(R*I1))*b/R*1/s*(b/R*(R*I3)*omega3 + G_level)*1/s + omega3, d(d(v_nu)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(omega3), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(omega3), a part of d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(omega3), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega_tau*(a3/(R^2*I1)) - 1/(Theta/(m*R^2*I1))*V*b/R*(2*I3/(R^2*I1^2)), 2*a3*I3/(R*I1^2) - gamma3*(2*(I1 - I3)/I1^2), a part of d(d(omega3)/dtau)/d(gamma3), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(gamma3), a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(d(omega3)/dtau)/d(omega_tau), a part of d(d(omega3)/dtau)/d(omega3), a part of d(d(omega3)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 59, 28, 1, 0, 0, 15, 20 }, { 65, 368, 0, 51, 0, 0, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*(R*I3)*omega3 + G_level, e = gamma3*a3 + R, a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), V = omega_tau*e + v_nu, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s), a part of d(d(omega3)/dtau)/d(omega_tau), ((I1 - I3)/I1)*gamma3*s*omega_tau - (a3*I3/(R*I1))*s*omega_tau, a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(omega3), d(numerator of d(omega_tau)/dt over D)/d(gamma3), numerator of d(omega_tau)/dt over D, a part of d(d(omega_tau)/dtau)/d(omega3), d(numerator of d(omega_tau)/dt over D)/d(s), a part of d(d(omega_tau)/dtau)/d(s), (m*R^2*(I1 - I3))*s*s*omega_tau - (m*R*I3)*V, (m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)))*s*s*omega_tau + b/R*(m*R*I3)*V, (2*I3/I1^2)*b/R*1/s*1/s*(b/R*(R*I3)*omega3 + G_level) + omega3*(R*I3/I1), d(d(v_nu)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(omega3), d(v_nu)/dtau, a part of d(d(omega3)/dtau)/d(gamma3), a part of d(d(omega3)/dtau)/d(s)" },
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
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .eliminated_state = 3, .level_integral = 1,
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular_on_level_omega_n,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_general_in_regular_on_level_omega_n) },
#endif
};
