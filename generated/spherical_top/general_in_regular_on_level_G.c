/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   25   12    1    0    0     11    9   (89)
 *  jacobian            9   59   28    1    0    0     14   16   (423)
 *  rhs_jacobian        11   62   27    1    0    0     16   21   (484)
 *  divergence          0    8   10    1    0    0     10    7   (55)
 *  integral_values     1   11    8    1    0    0      7    7   (40)
 *  integral_gradients  0   16   13    1    0    0      7   10   (76)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          1    2    1    1    0    0      4    3   (8)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G;
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
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = 1.0/t0; /* 1/(R*I1) */
    out[7] = t1;
    const double t2 = params[3]*params[3]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    out[19] = t3;
    const double t4 = t3/params[4]; /* m*a3*a3/I1 */
    out[8] = t4;
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    const double t7 = params[5]/t6; /* I3/(m*R*R) */
    out[9] = t7;
    const double t8 = params[4]*t5; /* I1*R*R */
    out[62] = t8;
    const double t9 = params[5]/t8; /* I3/(I1*R*R) */
    out[10] = t9;
    const double t10 = params[0]*params[2]; /* m*g */
    const double t11 = params[3]*t10; /* a3*m*g */
    out[43] = t11;
    const double t12 = t11/params[4]; /* a3*m*g/I1 */
    out[11] = t12;
    const double t13 = params[5]/params[4]; /* I3/I1 */
    out[12] = t13;
    const double t14 = (-1.0)/params[1]; /* (-1)/R */
    out[13] = t14;
    const double t15 = params[3]*params[5]; /* a3*I3 */
    const double t16 = t15/params[4]; /* a3*I3/I1 */
    out[14] = t16;
    const double t17 = params[4] - params[5]; /* I1 - I3 */
    const double t18 = params[1]*t17; /* R*(I1 - I3) */
    const double t19 = t18/params[4]; /* R*(I1 - I3)/I1 */
    out[15] = t19;
    const double t20 = params[4]*params[4]; /* I1*I1 */
    const double t21 = params[1]*t20; /* R*I1*I1 */
    const double t22 = 1.0/t21; /* 1/(R*I1*I1) */
    out[16] = t22;
    const double t23 = params[3]/params[1]; /* a3/R */
    out[17] = t23;
    const double t24 = params[1]*params[5]; /* R*I3 */
    out[18] = t24;
    const double t25 = t24/params[4]; /* R*I3/I1 */
    out[20] = t25;
    const double t26 = 2.0/t0; /* 2/(R*I1) */
    out[21] = t26;
    const double t27 = 1.0/params[4]; /* 1/I1 */
    out[22] = t27;
    const double t28 = (-2.0)/t21; /* (-2)/(R*I1*I1) */
    out[23] = t28;
    const double t29 = (-1.0)/t8; /* (-1)/(I1*R*R) */
    out[24] = t29;
    const double t30 = params[5]*t8; /* I3*I1*R*R */
    out[25] = t30;
    const double t31 = t2*t6; /* a3*a3*m*R*R */
    const double t32 = params[4]*t31; /* I1*a3*a3*m*R*R */
    out[26] = t32;
    const double t33 = params[0]*2.0; /* m*2 */
    const double t34 = t2*t33; /* a3*a3*m*2 */
    out[27] = t34;
    const double t35 = params[5]/t0; /* I3/(R*I1) */
    out[28] = t35;
    const double t36 = 2.0/t8; /* 2/(I1*R*R) */
    out[29] = t36;
    const double t37 = t6*params[2]; /* m*R*R*g */
    const double t38 = params[3]*t37; /* a3*m*R*R*g */
    const double t39 = params[4]*t38; /* I1*a3*m*R*R*g */
    out[30] = t39;
    const double t40 = t17/params[4]; /* (I1 - I3)/I1 */
    out[31] = t40;
    const double t41 = params[3]*2.0; /* a3*2 */
    const double t42 = params[5]*t41; /* I3*a3*2 */
    const double t43 = t42/t21; /* I3*a3*2/(R*I1*I1) */
    out[32] = t43;
    const double t44 = t17*2.0; /* (I1 - I3)*2 */
    const double t45 = t44/t20; /* (I1 - I3)*2/(I1*I1) */
    out[33] = t45;
    const double t46 = t5*t20; /* R*R*I1*I1 */
    const double t47 = 2.0/t46; /* 2/(R*R*I1*I1) */
    out[34] = t47;
    const double t48 = params[4]*params[3]; /* I1*a3 */
    const double t49 = t48/2.0; /* I1*a3/2 */
    out[35] = t49;
    const double t50 = 1.0/t8; /* 1/(I1*R*R) */
    out[36] = t50;
    const double t51 = t15/t0; /* a3*I3/(R*I1) */
    out[37] = t51;
    const double t52 = t42/t0; /* I3*a3*2/(R*I1) */
    out[38] = t52;
    const double t53 = t44/params[4]; /* (I1 - I3)*2/I1 */
    out[39] = t53;
    const double t54 = params[4]*params[5]; /* I1*I3 */
    out[40] = t54;
    const double t55 = params[4]*t6; /* I1*m*R*R */
    out[41] = t55;
    const double t56 = t6*params[5]; /* m*R*R*I3 */
    out[42] = t56;
    const double t57 = params[1]*params[0]; /* R*m */
    const double t58 = params[3]*t57; /* a3*R*m */
    const double t59 = params[5]*t58; /* I3*a3*R*m */
    out[44] = t59;
    const double t60 = t6*t17; /* m*R*R*(I1 - I3) */
    out[45] = t60;
    const double t61 = params[5]*2.0; /* I3*2 */
    const double t62 = t61/t0; /* I3*2/(R*I1) */
    out[46] = t62;
    const double t63 = t24/2.0; /* R*I3/2 */
    out[47] = t63;
    const double t64 = params[2]*t33; /* g*m*2 */
    const double t65 = params[3]*t64; /* a3*g*m*2 */
    out[48] = t65;
    const double t66 = t5*t33; /* R*R*m*2 */
    const double t67 = params[5]*t66; /* I3*R*R*m*2 */
    out[49] = t67;
    const double t68 = params[0]*params[3]; /* m*a3 */
    out[50] = t68;
    const double t69 = params[5]*t57; /* I3*R*m */
    out[51] = t69;
    const double t70 = t17*t66; /* (I1 - I3)*R*R*m*2 */
    out[52] = t70;
    const double t71 = params[1]*t33; /* R*m*2 */
    const double t72 = params[3]*t71; /* a3*R*m*2 */
    const double t73 = params[5]*t72; /* I3*a3*R*m*2 */
    out[53] = t73;
    const double t74 = params[4]*t66; /* I1*R*R*m*2 */
    out[54] = t74;
    const double t75 = params[0]*params[5]; /* m*I3 */
    out[55] = t75;
    const double t76 = params[0]/2.0; /* m/2 */
    out[56] = t76;
    const double t77 = params[2]*2.0; /* g*2 */
    const double t78 = params[3]*t77; /* a3*g*2 */
    out[57] = t78;
    const double t79 = 1.0/params[0]; /* 1/m */
    out[58] = t79;
    const double t80 = 1.0/t55; /* 1/(I1*m*R*R) */
    out[59] = t80;
    const double t81 = params[5]/params[0]; /* I3/m */
    out[60] = t81;
    const double t82 = params[0]/t21; /* m/(R*I1*I1) */
    out[61] = t82;
    const double t83 = params[0]/params[4]; /* m/I1 */
    out[63] = t83;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = JLT_FMA(p[8], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t3 = p[10]*t1; /* I3/(R^2*I1)*b */
    const double t4 = p[9] + t0; /* I3/(m*R^2) + s*s */
    const double t5 = JLT_FMA(t1, t3, t4); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s*s */
    const double t6 = x[4]*t2; /* s*D/I1 */
    const double t7 = p[7]*t2; /* 1/(R*I1)*D/I1 */
    const double t8 = t5*t6; /* Theta/(m*R^2*I1)*s*D/I1 */
    const double t9 = 1.0/t8; /* 1/(Theta/(m*R^2*I1)*s*D/I1) */
    const double t10 = t5*t9; /* 1/(s*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D/I1) */
    const double t11 = p[13]*t6; /* (-1/R)*s*D/I1 */
    const double t12 = t9*t11; /* 1/(Theta/(m*R^2*I1)*s*D/I1)*(-1/R)*s*D/I1 */
    const double t13 = p[5]*x[3]; /* I3*omega3 */
    const double t14 = JLT_FMA(t1, t13, p[6]); /* b*I3*omega3 + G_level */
    const double t15 = t7*t14; /* 1/(R*I1)*D/I1*(b*I3*omega3 + G_level) */
    const double t16 = t10*t15; /* omega_n = 1/(s*(D/I1))*1/(R*I1)*D/I1*(b*I3*omega3 + G_level) */
    const double t17 = x[4]*t10; /* s*1/(s*(D/I1)) */
    const double t18 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t19 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t19;
    const double t20 = p[8]*t18; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t21 = t19*t20; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t22 = JLT_FNMA(p[11], t0, t21); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s*s */
    const double t23 = x[3]*t19; /* omega3*omega_tau*s*s */
    const double t24 = x[4]*t18; /* s*omega_tau*gamma3 */
    const double t25 = -t24; /* -s*omega_tau*gamma3 */
    out[4] = t25;
    const double t26 = t16*t16; /* omega_n*omega_n */
    const double t27 = x[4]*t16; /* s*omega_n */
    const double t28 = JLT_FNMA(x[0], t26, t22); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s*s - gamma3*omega_n*omega_n */
    const double t29 = t1*t26; /* b*omega_n*omega_n */
    const double t30 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/I1 - gamma3*R*(I1 - I3)/I1 */
    const double t31 = t23*t30; /* omega3*omega_tau*s*s*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) */
    const double t32 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t33 = JLT_FMA(x[2], t32, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = JLT_FMA(t27, t33, t31); /* s*omega_n*V + omega3*omega_tau*s*s*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) */
    const double t35 = t12*t34; /* 1/(Theta/(m*R^2*I1)*s*D/I1)*(-1/R)*s*D/I1*t34 */
    out[3] = t35;
    const double t36 = x[3]*t27; /* omega3*s*omega_n */
    const double t37 = JLT_FMA(p[1], t36, t29); /* R*omega3*s*omega_n + b*omega_n*omega_n */
    out[1] = t37;
    const double t38 = JLT_FNMA(p[12], t36, t28); /* t28 - I3/I1*omega3*s*omega_n */
    const double t39 = t17*t38; /* s*1/(s*(D/I1))*(t28 - I3/I1*omega3*s*omega_n) */
    out[2] = t39;
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
    const double t3 = p[17] + x[0]; /* b/R = a3/R + gamma3 */
    const double t4 = p[18]*x[3]; /* R*I3*omega3 */
    const double t5 = JLT_FMA(t3, t4, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t6 = JLT_FMA(t0, p[19], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t7 = t3*p[12]; /* b/R*I3/I1 */
    const double t8 = t0 + p[9]; /* s*s + I3/(m*R^2) */
    const double t9 = JLT_FMA(t3, t7, t8); /* Theta/(m*R^2*I1) = b/R*b/R*I3/I1 + s*s + I3/(m*R^2) */
    const double t10 = x[4]*t6; /* s*D */
    const double t11 = t9*t10; /* Theta/(m*R^2*I1)*s*D */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*s*D) */
    const double t13 = t9*t12; /* 1/(s*D) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D) */
    const double t14 = t6*t13; /* 1/s = D*1/(s*D) */
    const double t15 = t5*t14; /* (b/R*R*I3*omega3 + G_level)*1/s */
    const double t16 = t15*t15; /* (b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t17 = p[16]*t16; /* 1/(R*I1^2)*t16 */
    const double t18 = t14*p[21]; /* 1/s*2/(R*I1) */
    const double t19 = t15*t18; /* (b/R*R*I3*omega3 + G_level)*1/s*1/s*2/(R*I1) */
    const double t20 = JLT_FMA(t3, t19, x[3]); /* b/R*(b/R*R*I3*omega3 + G_level)*1/s*1/s*2/(R*I1) + omega3 */
    const double t21 = p[20]*t20; /* R*I3/I1*(b/R*(b/R*R*I3*omega3 + G_level)*1/s*1/s*2/(R*I1) + omega3) */
    const double t22 = JLT_FMA(x[3], t21, t17); /* omega3*t21 + 1/(R*I1^2)*t16 */
    out[5] = t22;
    const double t23 = t5*p[22]; /* (b/R*R*I3*omega3 + G_level)*1/I1 */
    const double t24 = JLT_FMA(t3, t21, t23); /* b/R*t21 + (b/R*R*I3*omega3 + G_level)*1/I1 */
    out[8] = t24;
    const double t25 = t14*t16; /* 1/s*t16 */
    const double t26 = t3*p[23]; /* b/R*(-2/(R*I1^2)) */
    const double t27 = t25*t26; /* 1/s*t16*b/R*(-2/(R*I1^2)) */
    out[9] = t27;
    const double t28 = x[3]*p[12]; /* omega3*I3/I1 */
    const double t29 = JLT_FMA(x[0], t19, t28); /* gamma3*(b/R*R*I3*omega3 + G_level)*1/s*1/s*2/(R*I1) + omega3*I3/I1 */
    const double t30 = x[3]*p[25]; /* omega3*R^2*I1*I3 */
    const double t31 = t1*p[26]; /* s*omega_tau*m*R^2*a3^2*I1 */
    const double t32 = JLT_FNMA(t1, t31, t16); /* t16 - s*omega_tau*s*omega_tau*m*R^2*a3^2*I1 */
    const double t33 = JLT_FMA(t29, t30, t32); /* t29*omega3*R^2*I1*I3 + t16 - s*omega_tau*s*omega_tau*m*R^2*a3^2*I1 */
    const double t34 = x[4]*t13; /* 1/D = s*1/(s*D) */
    const double t35 = p[24]*t34; /* (-1/(R^2*I1))*1/D */
    const double t36 = t33*t35; /* t33*(-1/(R^2*I1))*1/D */
    out[10] = t36;
    const double t37 = x[4]*x[0]; /* s*gamma3 */
    const double t38 = t1*p[27]; /* s*omega_tau*2*m*a3^2 */
    const double t39 = t37*t38; /* s*gamma3*s*omega_tau*2*m*a3^2 */
    const double t40 = t34*t39; /* 1/D*s*gamma3*s*omega_tau*2*m*a3^2 */
    out[12] = t40;
    const double t41 = t5*p[28]; /* (b/R*R*I3*omega3 + G_level)*I3/(R*I1) */
    const double t42 = t3*p[5]; /* b/R*I3 */
    const double t43 = JLT_FMA(t29, t42, t41); /* t29*b/R*I3 + (b/R*R*I3*omega3 + G_level)*I3/(R*I1) */
    const double t44 = t34*t43; /* 1/D*(t29*b/R*I3 + (b/R*R*I3*omega3 + G_level)*I3/(R*I1)) */
    const double t45 = -t44; /* -1/D*(t29*b/R*I3 + (b/R*R*I3*omega3 + G_level)*I3/(R*I1)) */
    out[13] = t45;
    const double t46 = x[0]*t15; /* gamma3*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t47 = JLT_FMA(x[4], t4, t46); /* s*R*I3*omega3 + gamma3*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t48 = t5*t47; /* (b/R*R*I3*omega3 + G_level)*(s*R*I3*omega3 + gamma3*(b/R*R*I3*omega3 + G_level)*1/s) */
    const double t49 = x[4]*p[30]; /* s*m*R^2*g*a3*I1 */
    const double t50 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t51 = JLT_FNMA(t31, t50, t49); /* s*m*R^2*g*a3*I1 - s*omega_tau*m*R^2*a3^2*I1*omega_tau*gamma3 */
    const double t52 = JLT_FMA(t0, t51, t48); /* s*s*(s*m*R^2*g*a3*I1 - s*omega_tau*m*R^2*a3^2*I1*omega_tau*gamma3) + t48 */
    const double t53 = p[19]*t34; /* m*a3^2*1/D */
    const double t54 = JLT_FMS(x[0], t25, t51); /* gamma3*1/s*t16 - (s*m*R^2*g*a3*I1 - s*omega_tau*m*R^2*a3^2*I1*omega_tau*gamma3) */
    const double t55 = JLT_FMA(t52, t53, t54); /* t52*m*a3^2*1/D + t54 */
    const double t56 = t34*p[29]; /* 1/D*2/(R^2*I1) */
    const double t57 = t55*t56; /* (t52*m*a3^2*1/D + t54)*1/D*2/(R^2*I1) */
    out[14] = t57;
    const double t58 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = s*D*1/(Theta/(m*R^2*I1)*s*D) */
    const double t59 = t42*t58; /* b/R*I3*1/(Theta/(m*R^2*I1)) */
    const double t60 = JLT_FNMA(x[0], p[33], p[32]); /* 2*a3*I3/(R*I1^2) - gamma3*2*(I1 - I3)/I1^2 */
    const double t61 = JLT_FMA(t59, t60, p[31]); /* b/R*I3*1/(Theta/(m*R^2*I1))*(2*a3*I3/(R*I1^2) - gamma3*2*(I1 - I3)/I1^2) + (I1 - I3)/I1 */
    const double t62 = x[4]*t58; /* s*1/(Theta/(m*R^2*I1)) */
    const double t63 = t1*t62; /* s*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t64 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t65 = JLT_FMA(x[2], t64, x[1]); /* V = omega_tau*e + v_nu */
    const double t66 = p[28]*t65; /* I3/(R*I1)*V */
    const double t67 = t58*t66; /* 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t68 = JLT_FMS(t61, t63, t67); /* t61*s*omega_tau*s*1/(Theta/(m*R^2*I1)) - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t69 = x[3]*t68; /* omega3*t68 */
    const double t70 = t5*t58; /* (b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1)) */
    const double t71 = x[2]*p[35]; /* omega_tau*1/2*a3*I1 */
    const double t72 = JLT_FNMA(t59, t65, t71); /* omega_tau*1/2*a3*I1 - b/R*I3*1/(Theta/(m*R^2*I1))*V */
    const double t73 = p[34]*t70; /* 2/(R^2*I1^2)*(b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1)) */
    const double t74 = JLT_FNMA(t72, t73, t69); /* omega3*t68 - (omega_tau*1/2*a3*I1 - b/R*I3*1/(Theta/(m*R^2*I1))*V)*t73 */
    out[15] = t74;
    const double t75 = t70*p[36]; /* (b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1))*1/(R^2*I1) */
    const double t76 = -t75; /* -(b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1))*1/(R^2*I1) */
    out[16] = t76;
    const double t77 = t64*t75; /* e*(b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1))*1/(R^2*I1) */
    const double t78 = JLT_FNMA(x[0], p[31], p[37]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t79 = t62*t78; /* s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t80 = x[4]*x[3]; /* s*omega3 */
    const double t81 = JLT_FMA(t79, t80, t77); /* s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*s*omega3 + t77 */
    const double t82 = -t81; /* -t81 */
    out[17] = t82;
    const double t83 = t3*t67; /* b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t84 = JLT_FMA(t1, t79, t83); /* s*omega_tau*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t85 = -t84; /* -t84 */
    out[18] = t85;
    const double t86 = JLT_FNMA(x[0], p[39], p[38]); /* 2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1 */
    const double t87 = JLT_FNMA(t62, t62, t58); /* 1/(Theta/(m*R^2*I1)) - s*1/(Theta/(m*R^2*I1))*s*1/(Theta/(m*R^2*I1)) */
    const double t88 = t1*x[3]; /* s*omega_tau*omega3 */
    const double t89 = t86*t88; /* (2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1)*s*omega_tau*omega3 */
    const double t90 = t87*t89; /* t87*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1)*s*omega_tau*omega3 */
    const double t91 = p[29]*t65; /* 2/(R^2*I1)*V */
    const double t92 = t70*t91; /* (b/R*R*I3*omega3 + G_level)*1/(Theta/(m*R^2*I1))*2/(R^2*I1)*V */
    const double t93 = JLT_FMS(t62, t92, t90); /* s*1/(Theta/(m*R^2*I1))*t92 - t90 */
    out[19] = t93;
    const double t94 = -t1; /* -s*omega_tau */
    out[20] = t94;
    const double t95 = -t37; /* -s*gamma3 */
    out[22] = t95;
    const double t96 = -t50; /* -omega_tau*gamma3 */
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
    const double t0 = x[4]*x[4]; /* s*s */
    out[7] = t0;
    const double t1 = p[17] + x[0]; /* b/R = a3/R + gamma3 */
    const double t2 = p[19]*t0; /* m*a3^2*s*s */
    const double t3 = p[4] + t2; /* D = I1 + m*a3^2*s*s */
    const double t4 = p[42]*t1; /* m*R^2*I3*b/R */
    const double t5 = JLT_FMA(p[41], t0, p[40]); /* m*R^2*I1*s*s + I1*I3 */
    const double t6 = JLT_FMA(t1, t4, t5); /* Theta = b/R*m*R^2*I3*b/R + m*R^2*I1*s*s + I1*I3 */
    const double t7 = x[4]*t3; /* s*D */
    const double t8 = t6*t7; /* Theta*s*D */
    const double t9 = 1.0/t8; /* 1/(Theta*s*D) */
    const double t10 = t6*t9; /* 1/(s*D) = Theta*1/(Theta*s*D) */
    const double t11 = t7*t9; /* 1/Theta = s*D*1/(Theta*s*D) */
    const double t12 = t3*t10; /* 1/s = D*1/(s*D) */
    const double t13 = x[4]*t10; /* 1/D = s*1/(s*D) */
    const double t14 = p[18]*x[3]; /* R*I3*omega3 */
    const double t15 = JLT_FMA(t1, t14, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t16 = t12*t15; /* 1/s*(b/R*R*I3*omega3 + G_level) */
    const double t17 = t12*t16; /* 1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t18 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t19 = t2*t18; /* m*a3^2*s*s*omega_tau*omega_tau */
    const double t20 = x[4]*x[2]; /* s*omega_tau */
    const double t21 = 2.0*t20; /* 2*s*omega_tau */
    out[9] = t21;
    const double t22 = -t20; /* -s*omega_tau */
    out[25] = t22;
    const double t23 = t16*t16; /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t24 = JLT_FNMA(p[36], t23, t19); /* m*a3^2*s*s*omega_tau*omega_tau - 1/(R^2*I1)*t23 */
    const double t25 = p[16]*t23; /* 1/(R*I1^2)*t23 */
    const double t26 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t27 = JLT_FMA(x[2], t26, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = p[0]*t15; /* m*(b/R*R*I3*omega3 + G_level) */
    const double t29 = t26*t28; /* e*m*(b/R*R*I3*omega3 + G_level) */
    const double t30 = JLT_FNMA(x[0], p[45], p[44]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t31 = x[0]*t20; /* gamma3*s*omega_tau */
    const double t32 = -t31; /* -gamma3*s*omega_tau */
    out[4] = t32;
    const double t33 = x[0]*t17; /* gamma3*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t34 = t1*t17; /* b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t35 = x[2]*p[27]; /* omega_tau*2*m*a3^2 */
    const double t36 = t31*t35; /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 */
    const double t37 = JLT_FNMA(x[4], p[48], t36); /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t38 = x[4]*t20; /* s*s*omega_tau */
    out[0] = t38;
    const double t39 = x[0]*t24; /* gamma3*(m*a3^2*s*s*omega_tau*omega_tau - 1/(R^2*I1)*t23) */
    const double t40 = JLT_FNMA(p[43], t0, t39); /* gamma3*(m*a3^2*s*s*omega_tau*omega_tau - 1/(R^2*I1)*t23) - m*g*a3*s*s */
    const double t41 = t27*t28; /* V*m*(b/R*R*I3*omega3 + G_level) */
    const double t42 = p[51]*t27; /* m*R*I3*V */
    const double t43 = t11*t28; /* 1/Theta*m*(b/R*R*I3*omega3 + G_level) */
    const double t44 = -t43; /* -1/Theta*m*(b/R*R*I3*omega3 + G_level) */
    out[21] = t44;
    const double t45 = x[3]*t30; /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t46 = JLT_FMA(t0, t45, t29); /* s*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*m*(b/R*R*I3*omega3 + G_level) */
    const double t47 = JLT_FMA(t38, t45, t41); /* s*s*omega_tau*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*m*(b/R*R*I3*omega3 + G_level) */
    const double t48 = t11*t47; /* 1/Theta*t47 */
    const double t49 = t11*t46; /* 1/Theta*t46 */
    const double t50 = -t49; /* -1/Theta*t46 */
    out[22] = t50;
    const double t51 = -t48; /* -1/Theta*t47 */
    out[3] = t51;
    const double t52 = JLT_FMA(x[3], p[47], t33); /* omega3*1/2*R*I3 + gamma3*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t53 = p[46]*t52; /* 2*I3/(R*I1)*(omega3*1/2*R*I3 + gamma3*1/s*1/s*(b/R*R*I3*omega3 + G_level)) */
    const double t54 = JLT_FNMA(x[3], t53, t24); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = m*a3^2*s*s*omega_tau*omega_tau - 1/(R^2*I1)*t23 - omega3*t53 */
    const double t55 = t13*t54; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    out[15] = t55;
    const double t56 = x[2]*p[50]; /* omega_tau*m*a3 */
    const double t57 = t15*t56; /* (b/R*R*I3*omega3 + G_level)*omega_tau*m*a3 */
    const double t58 = x[3]*p[52]; /* omega3*2*m*R^2*(I1 - I3) */
    const double t59 = t31*t58; /* gamma3*s*omega_tau*omega3*2*m*R^2*(I1 - I3) */
    const double t60 = p[28]*t15; /* I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t61 = JLT_FNMA(x[3], t60, t40); /* numerator of d(omega_tau)/dt over D = t40 - omega3*I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t62 = JLT_FMA(t1, t53, t60); /* b/R*t53 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t63 = p[22]*t15; /* 1/I1*(b/R*R*I3*omega3 + G_level) */
    const double t64 = t13*t61; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t64;
    const double t65 = t13*t62; /* 1/D*(b/R*t53 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level)) */
    const double t66 = -t65; /* -1/D*(b/R*t53 + I3/(R*I1)*(b/R*R*I3*omega3 + G_level)) */
    out[18] = t66;
    const double t67 = p[29]*t16; /* 2/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t68 = JLT_FMA(t33, t67, t37); /* d(numerator of d(omega_tau)/dt over D)/d(s) = gamma3*1/s*1/s*(b/R*R*I3*omega3 + G_level)*2/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level) + gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t69 = p[23]*t16; /* (-2/(R*I1^2))*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t70 = t34*t69; /* b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level)*(-2/(R*I1^2))*1/s*(b/R*R*I3*omega3 + G_level) */
    out[14] = t70;
    const double t71 = JLT_FMA(p[21], t34, x[3]); /* 2/(R*I1)*b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) + omega3 */
    const double t72 = p[20]*t71; /* R*I3/I1*(2/(R*I1)*b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) + omega3) */
    const double t73 = t13*t68; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t74 = JLT_FMA(x[3], t72, t25); /* omega3*t72 + 1/(R*I1^2)*t23 */
    out[10] = t74;
    const double t75 = JLT_FMA(t1, t72, t63); /* b/R*t72 + 1/I1*(b/R*R*I3*omega3 + G_level) */
    out[13] = t75;
    const double t76 = t1*t25; /* b/R*1/(R*I1^2)*t23 */
    const double t77 = JLT_FMA(x[3], t63, t76); /* omega3*1/I1*(b/R*R*I3*omega3 + G_level) + b/R*1/(R*I1^2)*t23 */
    out[1] = t77;
    const double t78 = JLT_FMS(p[45], t38, t42); /* m*R^2*(I1 - I3)*s*s*omega_tau - m*R*I3*V */
    const double t79 = JLT_FMS(x[3], t78, t57); /* omega3*(m*R^2*(I1 - I3)*s*s*omega_tau - m*R*I3*V) - (b/R*R*I3*omega3 + G_level)*omega_tau*m*a3 */
    const double t80 = t1*t42; /* b/R*m*R*I3*V */
    const double t81 = JLT_FMA(t30, t38, t80); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*s*omega_tau + b/R*m*R*I3*V */
    const double t82 = p[49]*t1; /* 2*m*R^2*I3*b/R */
    const double t83 = JLT_FMA(t48, t82, t79); /* 1/Theta*t47*2*m*R^2*I3*b/R + t79 */
    const double t84 = t11*t83; /* 1/Theta*(1/Theta*t47*2*m*R^2*I3*b/R + t79) */
    out[20] = t84;
    const double t85 = t11*t81; /* 1/Theta*t81 */
    const double t86 = -t85; /* -1/Theta*t81 */
    out[23] = t86;
    const double t87 = x[3]*p[53]; /* omega3*2*m*R*a3*I3 */
    const double t88 = JLT_FNMA(t20, t87, t59); /* d(numerator of d(omega3)/dt over Theta)/d(s) = gamma3*s*omega_tau*omega3*2*m*R^2*(I1 - I3) - s*omega_tau*omega3*2*m*R*a3*I3 */
    const double t89 = t11*t88; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t90 = x[4]*p[27]; /* s*2*m*a3^2 */
    const double t91 = t13*t90; /* 1/D*s*2*m*a3^2 */
    const double t92 = JLT_FNMA(t64, t91, t73); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) - 1/D*numerator of d(omega_tau)/dt over D*1/D*s*2*m*a3^2 */
    out[19] = t92;
    const double t93 = t31*t91; /* gamma3*s*omega_tau*1/D*s*2*m*a3^2 */
    out[17] = t93;
    const double t94 = x[4]*p[54]; /* s*2*m*R^2*I1 */
    const double t95 = t11*t94; /* 1/Theta*s*2*m*R^2*I1 */
    const double t96 = JLT_FMA(t48, t95, t89); /* 1/Theta*t47*1/Theta*s*2*m*R^2*I1 + 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
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
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[0]*t1; /* gamma3*omega_tau*s*s */
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = p[45]*t2; /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s */
    const double t5 = JLT_FNMA(p[44], t1, t4); /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s - m*R*a3*I3*omega_tau*s*s */
    const double t6 = p[27]*t2; /* 2*m*a3^2*gamma3*omega_tau*s*s */
    const double t7 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t8 = JLT_FMA(x[2], t7, x[1]); /* V = omega_tau*e + v_nu */
    const double t9 = p[55]*t3; /* m*I3*b */
    const double t10 = JLT_FNMA(t8, t9, t5); /* t5 - V*m*I3*b */
    const double t11 = JLT_FMA(p[19], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t12 = JLT_FMA(p[41], t0, p[40]); /* m*R^2*I1*s*s + I1*I3 */
    const double t13 = JLT_FMA(t3, t9, t12); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t14 = t10*t11; /* (t5 - V*m*I3*b)*D */
    const double t15 = JLT_FMA(t6, t13, t14); /* 2*m*a3^2*gamma3*omega_tau*s*s*Theta + (t5 - V*m*I3*b)*D */
    const double t16 = t11*t13; /* D*Theta */
    const double t17 = t15/t16; /* (2*m*a3^2*gamma3*omega_tau*s*s*Theta + (t5 - V*m*I3*b)*D)/(D*Theta) */
    const double t18 = JLT_FNMA(x[0], x[2], t17); /* t17 - gamma3*omega_tau */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0] + p[17]; /* b/R = gamma3 + a3/R */
    const double t1 = p[18]*x[3]; /* R*I3*omega3 */
    const double t2 = JLT_FMA(t0, t1, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t3 = t2/x[4]; /* (b/R*R*I3*omega3 + G_level)/s */
    const double t4 = p[22]*t0; /* 1/I1*b/R */
    const double t5 = t3*t4; /* (b/R*R*I3*omega3 + G_level)/s*1/I1*b/R */
    const double t6 = p[57]*x[0]; /* 2*g*a3*gamma3 */
    const double t7 = JLT_FMA(x[1], x[1], t6); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t8 = p[19]*x[4]; /* m*a3^2*s */
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
    const double t12 = x[3]*p[28]; /* omega3*I3/(R*I1) */
    const double t13 = JLT_FMA(t11, t12, p[43]); /* 1/s*1/s*(b*I3*omega3 + G_level)*omega3*I3/(R*I1) + m*g*a3 */
    const double t14 = JLT_FMA(t9, t10, t13); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/(1/I1)*m/(R*I1^2)*v_tau/(1/(R*I1)) + 1/s*1/s*(b*I3*omega3 + G_level)*omega3*I3/(R*I1) + m*g*a3 */
    out[0] = t14;
    const double t15 = p[0]*x[1]; /* m*v_nu */
    out[1] = t15;
    const double t16 = x[4]*p[19]; /* s*m*a3^2 */
    const double t17 = JLT_FMA(x[4], t16, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t18 = x[2]*t17; /* omega_tau*D */
    out[2] = t18;
    const double t19 = t8*p[10]; /* b*1/s*I3/(R^2*I1) */
    const double t20 = JLT_FMA(t0, t19, x[4]); /* d(v_tau)/d(omega3)/R = b*b*1/s*I3/(R^2*I1) + s */
    const double t21 = t7*p[63]; /* v_tau/(1/(R*I1))*m/I1 */
    const double t22 = JLT_FMA(t4, t19, t2); /* 1/s*(b*I3*omega3 + G_level)*b*1/s*I3/(R^2*I1) + I3*omega3 */
    const double t23 = JLT_FMA(t20, t21, t22); /* d(energy)/d(omega3) = d(v_tau)/d(omega3)/R*v_tau/(1/(R*I1))*m/I1 + 1/s*(b*I3*omega3 + G_level)*b*1/s*I3/(R^2*I1) + I3*omega3 */
    out[3] = t23;
    const double t24 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t25 = t16*t24; /* s*m*a3^2*omega_tau*omega_tau */
    const double t26 = t11*p[36]; /* 1/s*1/s*(b*I3*omega3 + G_level)*1/(R^2*I1) */
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
    const double t0 = p[17] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = p[18]*x[3]; /* R*I3*omega3 */
    const double t2 = JLT_FMA(t0, t1, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t3 = p[7]*t2; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level) */
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
        t21[k] = p[8]*t19[k] + (k == 0 ? 1.0 : 0);
        t22[k] = p[10]*t20[k];
        t23[k] = (k == 0 ? p[9] : 0) + t19[k];
        t24[k] = jlt_jet_product(t20, t22, k) + t23[k];
        t25[k] = jlt_jet_product(x4, t21, k);
        t26[k] = p[7]*t21[k];
        t27[k] = jlt_jet_product(t24, t25, k);
        t28[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t27, t28, k);
        t29[k] = jlt_jet_product(t24, t28, k);
        t30[k] = p[13]*t25[k];
        t31[k] = jlt_jet_product(t28, t30, k);
        t32[k] = p[5]*x3[k];
        t33[k] = jlt_jet_product(t20, t32, k) + (k == 0 ? p[6] : 0);
        t34[k] = jlt_jet_product(t26, t33, k);
        t35[k] = jlt_jet_product(t29, t34, k);
        t36[k] = jlt_jet_product(x4, t29, k);
        t37[k] = jlt_jet_product(x2, t19, k);
        t38[k] = jlt_jet_product(t35, t35, k);
        t39[k] = jlt_jet_product(x4, t35, k);
        t40[k] = jlt_jet_product(t20, t38, k);
        t41[k] = x2[k]*p[8];
        t42[k] = jlt_jet_product(t37, t41, k) - t38[k];
        t43[k] = jlt_jet_product(x0, t42, k);
        t44[k] = t43[k] - p[11]*t19[k];
        t45[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t46[k] = jlt_jet_product(x3, t45, k);
        t47[k] = jlt_jet_product(t37, t46, k);
        t48[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t49[k] = jlt_jet_product(x2, t48, k) + x1[k];
        t50[k] = jlt_jet_product(t39, t49, k) + t47[k];
        t51[k] = jlt_jet_product(t31, t50, k);
        t52[k] = jlt_jet_product(x3, t39, k);
        t53[k] = p[1]*t52[k] + t40[k];
        t54[k] = t44[k] - p[12]*t52[k];
        t55[k] = jlt_jet_product(t36, t54, k);
        t56[k] = jlt_jet_product(x2, x4, k);
        t57[k] = jlt_jet_product(x0, t56, k);
        t58[k] = -t57[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t37[k]/(k + 1);
        next[1] = x1[k + 1] = t53[k]/(k + 1);
        next[2] = x2[k + 1] = t55[k]/(k + 1);
        next[3] = x3[k + 1] = t51[k]/(k + 1);
        next[4] = x4[k + 1] = t58[k]/(k + 1);
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
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 64,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 25, 12, 1, 0, 0, 11, 9 }, { 15, 66, 0, 8, 0, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 25, { 9, 59, 28, 1, 0, 0, 14, 16 }, { 57, 322, 0, 44, 0, 0, 16, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 11, 62, 27, 1, 0, 0, 16, 21 }, { 65, 368, 0, 51, 0, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 0, 8, 10, 1, 0, 0, 10, 7 }, { 11, 40, 0, 4, 0, 0, 11, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 1, { 1, 11, 8, 1, 0, 0, 7, 7 }, { 9, 30, 0, 1, 0, 0, 11, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 5, { 0, 16, 13, 1, 0, 0, 7, 10 }, { 15, 54, 0, 7, 0, 0, 11, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 1, 2, 1, 1, 0, 0, 4, 3 }, { 2, 5, 0, 1, 0, 0, 5, 4 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_in_regular_on_level_G_baseline,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_avx2,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_avx512,
    },
};
