/* Spherical top on a plane with one nonholonomic constraint, full system with multipliers
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (2.5)-(2.7)
 *  Table:      spherical_top_full, SHA-256 dc0d20f6ac74946b7b13744f3256847225086e5aac3162d5df985f3f2d8747c2
 *  Command:    ttc generate --out DIR spherical_top_full.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   43   39    1    1    0     15   13   (227)
 *  jacobian            27  107   80    1    1    0     17   38   (1510)
 *  rhs_jacobian        30  119  103    1    1    0     18   37   (1686)
 *  divergence          1   25   22    1    1    0     16   12   (136)
 *  integral_values     1   11   25    0    0    0      5    6   (70)
 *  integral_gradients  2   25    8    0    0    0      3    4   (64)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_full[];
extern const jlt_descriptor jlt_kernels_spherical_top_full_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_full_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_full_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_full_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[2]*params[4]; /* g*I1 */
    out[6] = t0;
    const double t1 = params[4]*params[3]; /* I1*a3 */
    out[7] = t1;
    const double t2 = params[5]/params[4]; /* I3/I1 */
    out[8] = t2;
    const double t3 = params[4]/params[0]; /* I1/m */
    out[9] = t3;
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[4]*t4; /* I1*R*R */
    const double t6 = t5/params[5]; /* I1*R*R/I3 */
    out[10] = t6;
    const double t7 = params[3]*params[3]; /* a3*a3 */
    const double t8 = params[0]*t7; /* m*a3*a3 */
    out[11] = t8;
    const double t9 = params[1]*2.0; /* R*2 */
    out[12] = t9;
    const double t10 = params[4] - params[5]; /* I1 - I3 */
    const double t11 = t10/params[4]; /* (I1 - I3)/I1 */
    out[13] = t11;
    const double t12 = params[3]*params[0]; /* a3*m */
    const double t13 = t12/params[4]; /* a3*m/I1 */
    out[14] = t13;
    const double t14 = params[4]*params[1]; /* I1*R */
    const double t15 = t14/params[5]; /* I1*R/I3 */
    out[15] = t15;
    const double t16 = params[4]*params[5]; /* I1*I3 */
    out[16] = t16;
    const double t17 = params[0]*t4; /* m*R*R */
    const double t18 = params[4]*t17; /* I1*m*R*R */
    out[17] = t18;
    const double t19 = params[5]*params[0]; /* I3*m */
    out[18] = t19;
    const double t20 = params[3]*params[5]; /* a3*I3 */
    out[19] = t20;
    const double t21 = params[2]*2.0; /* g*2 */
    const double t22 = params[4]*t21; /* I1*g*2 */
    out[20] = t22;
    const double t23 = params[4]*2.0; /* I1*2 */
    out[23] = t23;
    const double t24 = t8*2.0; /* m*a3*a3*2 */
    const double t25 = t23 + t24; /* I1*2 + m*a3*a3*2 */
    out[21] = t25;
    const double t26 = params[5]*t23; /* I3*I1*2 */
    out[22] = t26;
    const double t27 = params[0]*2.0; /* m*2 */
    const double t28 = params[1]*t27; /* R*m*2 */
    const double t29 = params[5]*t28; /* I3*R*m*2 */
    out[24] = t29;
    const double t30 = params[5]*params[1]; /* I3*R */
    const double t31 = t30/params[4]; /* I3*R/I1 */
    const double t32 = t9 - t31; /* R*2 - I3*R/I1 */
    out[25] = t32;
    const double t33 = params[5]*t27; /* I3*m*2 */
    out[26] = t33;
    const double t34 = params[0]*params[1]; /* m*R */
    const double t35 = params[5]*t34; /* I3*m*R */
    out[27] = t35;
    const double t36 = t8/params[4]; /* m*a3*a3/I1 */
    out[28] = t36;
    const double t37 = params[5]*t8; /* I3*m*a3*a3 */
    const double t38 = t37/params[4]; /* I3*m*a3*a3/I1 */
    out[29] = t38;
    const double t39 = params[4]*t34; /* I1*m*R */
    out[30] = t39;
    const double t40 = params[0]*params[0]; /* m*m */
    const double t41 = 2.0*t40; /* 2*m*m */
    const double t42 = params[1]*t4; /* R*R*R */
    const double t43 = t41*t42; /* 2*m*m*R*R*R */
    const double t44 = params[4]*params[4]; /* I1*I1 */
    const double t45 = t43*t44; /* 2*m*m*R*R*R*I1*I1 */
    out[31] = t45;
    const double t46 = t23/params[0]; /* I1*2/m */
    out[32] = t46;
    const double t47 = params[3]/2.0; /* a3/2 */
    out[33] = t47;
    const double t48 = t32/t9; /* (R*2 - I3*R/I1)/(R*2) */
    out[34] = t48;
    const double t49 = params[3]*2.0; /* a3*2 */
    const double t50 = params[4]*t49; /* I1*a3*2 */
    out[35] = t50;
    const double t51 = params[5]/t23; /* I3/(I1*2) */
    out[36] = t51;
    const double t52 = params[3]*t27; /* a3*m*2 */
    out[37] = t52;
    const double t53 = t7*t27; /* a3*a3*m*2 */
    out[38] = t53;
    const double t54 = 2.0*t42; /* 2*R*R*R */
    const double t55 = t44*t54; /* I1*I1*2*R*R*R */
    const double t56 = params[5]*params[5]; /* I3*I3 */
    const double t57 = t55/t56; /* I1*I1*2*R*R*R/(I3*I3) */
    out[39] = t57;
    const double t58 = t53/params[4]; /* a3*a3*m*2/I1 */
    out[40] = t58;
    const double t59 = t34/params[5]; /* m*R/I3 */
    out[41] = t59;
    const double t60 = -params[1]; /* -R */
    out[46] = t60;
    const double t61 = -t14; /* -I1*R */
    out[42] = t61;
    const double t62 = -params[3]; /* -a3 */
    out[44] = t62;
    const double t63 = -t20; /* -a3*I3 */
    out[43] = t63;
    const double t64 = params[3]/params[1]; /* a3/R */
    out[45] = t64;
    const double t65 = -t30; /* -I3*R */
    out[47] = t65;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[8]; /* gamma2*omega3 */
    const double t1 = JLT_FNMA(x[2], x[7], t0); /* gamma2*omega3 - gamma3*omega2 */
    out[0] = t1;
    const double t2 = x[2]*x[6]; /* gamma3*omega1 */
    const double t3 = JLT_FNMA(x[8], x[0], t2); /* gamma3*omega1 - omega3*gamma1 */
    out[1] = t3;
    const double t4 = x[1]*x[6]; /* gamma2*omega1 */
    const double t5 = x[7]*x[0]; /* omega2*gamma1 */
    const double t6 = t4 - t5; /* gamma2*omega1 - omega2*gamma1 */
    const double t7 = t5 - t4; /* omega2*gamma1 - gamma2*omega1 */
    out[2] = t7;
    const double t8 = x[8]*x[4]; /* omega3*v2 */
    const double t9 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t10 = JLT_FMA(x[1], x[1], t9); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t11 = sqrt(t10); /* s = sqrt(gamma2*gamma2 + gamma1*gamma1) */
    const double t12 = JLT_FMA(x[2], x[2], t10); /* one = gamma3*gamma3 + gamma2*gamma2 + gamma1*gamma1 */
    const double t13 = p[6]*t12; /* g*I1*one */
    const double t14 = x[6]*x[6]; /* omega1*omega1 */
    const double t15 = JLT_FMA(x[7], x[7], t14); /* omega2*omega2 + omega1*omega1 */
    const double t16 = x[2]*t15; /* gamma3*(omega2*omega2 + omega1*omega1) */
    const double t17 = x[6]*x[0]; /* omega1*gamma1 */
    const double t18 = JLT_FMA(x[1], x[7], t17); /* q = gamma2*omega2 + omega1*gamma1 */
    const double t19 = x[8]*p[8]; /* omega3*I3/I1 */
    const double t20 = JLT_FNMA(t18, t19, t16); /* gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*I3/I1 */
    const double t21 = JLT_FNMA(p[7], t20, t13); /* g*I1*one - a3*I1*(gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*I3/I1) */
    const double t22 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t23 = JLT_FMA(t10, p[10], p[9]); /* (gamma2*gamma2 + gamma1*gamma1)*R^2*I1/I3 + I1/m */
    const double t24 = JLT_FMA(t22, t22, t23); /* Theta/(m*I3) = b*b + (gamma2*gamma2 + gamma1*gamma1)*R^2*I1/I3 + I1/m */
    const double t25 = t12*p[4]; /* one*I1 */
    const double t26 = JLT_FMA(t10, p[11], t25); /* D = (gamma2*gamma2 + gamma1*gamma1)*m*a3^2 + one*I1 */
    const double t27 = t11*t26; /* s*D */
    const double t28 = t24*t27; /* Theta/(m*I3)*s*D */
    const double t29 = 1.0/t28; /* 1/(Theta/(m*I3)*s*D) */
    const double t30 = t24*t29; /* 1/(D*s) = Theta/(m*I3)*1/(Theta/(m*I3)*s*D) */
    const double t31 = t11*t21; /* s*t21 */
    const double t32 = t30*t31; /* 1/(D*s)*s*t21 */
    const double t33 = p[2] - t32; /* g - 1/(D*s)*s*t21 */
    const double t34 = x[5]*t18; /* v3*q */
    const double t35 = x[2]*p[12]; /* gamma3*2*R */
    const double t36 = JLT_FNMA(p[8], t22, t35); /* gamma3*2*R - I3/I1*b */
    const double t37 = x[8]*t36; /* omega3*(gamma3*2*R - I3/I1*b) */
    const double t38 = JLT_FMA(t18, p[1], t37); /* q*R + omega3*(gamma3*2*R - I3/I1*b) */
    const double t39 = x[6]*x[3]; /* omega1*v1 */
    const double t40 = JLT_FMA(x[7], x[4], t39); /* omega2*v2 + omega1*v1 */
    const double t41 = JLT_FNMA(x[2], t40, t34); /* v3*q - gamma3*(omega2*v2 + omega1*v1) */
    const double t42 = JLT_FNMA(t6, t38, t41); /* gyroscopic = v3*q - gamma3*(omega2*v2 + omega1*v1) - (gamma2*omega1 - omega2*gamma1)*(q*R + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t43 = t27*t42; /* s*D*gyroscopic */
    const double t44 = t29*t43; /* 1/(Theta/(m*I3)*s*D)*s*D*gyroscopic */
    const double t45 = t26*t30; /* 1/s = D*1/(D*s) */
    const double t46 = t44*t45; /* 1/(Theta/(m*I3)*s*D)*s*D*gyroscopic*1/s */
    const double t47 = t45*t46; /* 1/s*1/(Theta/(m*I3)*s*D)*s*D*gyroscopic*1/s */
    const double t48 = x[1]*t47; /* gamma2*1/s*1/(Theta/(m*I3)*s*D)*s*D*gyroscopic*1/s */
    const double t49 = JLT_FNMA(x[7], x[5], t8); /* omega3*v2 - omega2*v3 */
    const double t50 = JLT_FNMA(x[0], t33, t49); /* omega3*v2 - omega2*v3 - gamma1*(g - 1/(D*s)*s*t21) */
    const double t51 = JLT_FMA(p[9], t48, t50); /* I1/m*gamma2*1/s*1/(Theta/(m*I3)*s*D)*s*D*gyroscopic*1/s + omega3*v2 - omega2*v3 - gamma1*(g - 1/(D*s)*s*t21) */
    out[3] = t51;
    const double t52 = x[6]*x[5]; /* omega1*v3 */
    const double t53 = x[0]*t47; /* gamma1*1/s*1/(Theta/(m*I3)*s*D)*s*D*gyroscopic*1/s */
    const double t54 = JLT_FNMA(x[8], x[3], t52); /* omega1*v3 - omega3*v1 */
    const double t55 = JLT_FNMA(x[1], t33, t54); /* omega1*v3 - omega3*v1 - gamma2*(g - 1/(D*s)*s*t21) */
    const double t56 = JLT_FNMA(p[9], t53, t55); /* omega1*v3 - omega3*v1 - gamma2*(g - 1/(D*s)*s*t21) - I1/m*gamma1*1/s*1/(Theta/(m*I3)*s*D)*s*D*gyroscopic*1/s */
    out[4] = t56;
    const double t57 = x[7]*x[3]; /* omega2*v1 */
    const double t58 = JLT_FNMA(x[6], x[4], t57); /* omega2*v1 - omega1*v2 */
    const double t59 = JLT_FNMA(x[2], t33, t58); /* omega2*v1 - omega1*v2 - gamma3*(g - 1/(D*s)*s*t21) */
    out[5] = t59;
    const double t60 = x[8]*p[13]; /* omega3*(I1 - I3)/I1 */
    const double t61 = x[7]*t60; /* omega2*omega3*(I1 - I3)/I1 */
    const double t62 = t32*p[14]; /* 1/(D*s)*s*t21*m*a3/I1 */
    const double t63 = JLT_FMA(x[1], t62, t61); /* gamma2*1/(D*s)*s*t21*m*a3/I1 + omega2*omega3*(I1 - I3)/I1 */
    const double t64 = JLT_FNMA(t22, t53, t63); /* gamma2*1/(D*s)*s*t21*m*a3/I1 + omega2*omega3*(I1 - I3)/I1 - b*gamma1*1/s*1/(Theta/(m*I3)*s*D)*s*D*gyroscopic*1/s */
    out[6] = t64;
    const double t65 = x[6]*t60; /* omega1*omega3*(I1 - I3)/I1 */
    const double t66 = JLT_FMA(x[0], t62, t65); /* gamma1*1/(D*s)*s*t21*m*a3/I1 + omega1*omega3*(I1 - I3)/I1 */
    const double t67 = JLT_FMA(t22, t48, t66); /* b*gamma2*1/s*1/(Theta/(m*I3)*s*D)*s*D*gyroscopic*1/s + gamma1*1/(D*s)*s*t21*m*a3/I1 + omega1*omega3*(I1 - I3)/I1 */
    const double t68 = -t67; /* -t67 */
    out[7] = t68;
    const double t69 = t44*p[15]; /* 1/(Theta/(m*I3)*s*D)*s*D*gyroscopic*R*I1/I3 */
    out[8] = t69;
    const double t70 = x[8]*x[10]; /* omega3*alpha2 */
    const double t71 = JLT_FNMA(x[7], x[11], t70); /* omega3*alpha2 - omega2*alpha3 */
    out[9] = t71;
    const double t72 = x[6]*x[11]; /* omega1*alpha3 */
    const double t73 = JLT_FNMA(x[8], x[9], t72); /* omega1*alpha3 - omega3*alpha1 */
    out[10] = t73;
    const double t74 = x[7]*x[9]; /* omega2*alpha1 */
    const double t75 = JLT_FNMA(x[6], x[10], t74); /* omega2*alpha1 - omega1*alpha2 */
    out[11] = t75;
    const double t76 = x[8]*x[13]; /* omega3*beta2 */
    const double t77 = JLT_FNMA(x[7], x[14], t76); /* omega3*beta2 - omega2*beta3 */
    out[12] = t77;
    const double t78 = x[6]*x[14]; /* omega1*beta3 */
    const double t79 = JLT_FNMA(x[8], x[12], t78); /* omega1*beta3 - omega3*beta1 */
    out[13] = t79;
    const double t80 = x[7]*x[12]; /* omega2*beta1 */
    const double t81 = JLT_FNMA(x[6], x[13], t80); /* omega2*beta1 - omega1*beta2 */
    out[14] = t81;
    const double t82 = x[3]*x[9]; /* v1*alpha1 */
    const double t83 = JLT_FMA(x[4], x[10], t82); /* v2*alpha2 + v1*alpha1 */
    const double t84 = JLT_FMA(x[5], x[11], t83); /* v3*alpha3 + v2*alpha2 + v1*alpha1 */
    out[15] = t84;
    const double t85 = x[3]*x[12]; /* v1*beta1 */
    const double t86 = JLT_FMA(x[4], x[13], t85); /* v2*beta2 + v1*beta1 */
    const double t87 = JLT_FMA(x[5], x[14], t86); /* v3*beta3 + v2*beta2 + v1*beta1 */
    out[16] = t87;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[18] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[24] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = 0.0;
    out[30] = 0.0;
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = 0.0;
    out[50] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = 0.0;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[81] = 0.0;
    out[82] = 0.0;
    out[83] = 0.0;
    out[84] = 0.0;
    out[90] = 0.0;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = 0.0;
    out[100] = 0.0;
    out[101] = 0.0;
    out[111] = 0.0;
    out[112] = 0.0;
    out[113] = 0.0;
    out[114] = 0.0;
    out[115] = 0.0;
    out[116] = 0.0;
    out[117] = 0.0;
    out[118] = 0.0;
    out[128] = 0.0;
    out[129] = 0.0;
    out[130] = 0.0;
    out[131] = 0.0;
    out[132] = 0.0;
    out[133] = 0.0;
    out[134] = 0.0;
    out[135] = 0.0;
    out[145] = 0.0;
    out[146] = 0.0;
    out[147] = 0.0;
    out[148] = 0.0;
    out[149] = 0.0;
    out[150] = 0.0;
    out[151] = 0.0;
    out[152] = 0.0;
    out[153] = 0.0;
    out[154] = 0.0;
    out[155] = 0.0;
    out[156] = 0.0;
    out[157] = 0.0;
    out[158] = 0.0;
    out[159] = 0.0;
    out[162] = 0.0;
    out[165] = 0.0;
    out[166] = 0.0;
    out[167] = 0.0;
    out[168] = 0.0;
    out[169] = 0.0;
    out[170] = 0.0;
    out[171] = 0.0;
    out[172] = 0.0;
    out[173] = 0.0;
    out[174] = 0.0;
    out[175] = 0.0;
    out[177] = 0.0;
    out[180] = 0.0;
    out[182] = 0.0;
    out[183] = 0.0;
    out[184] = 0.0;
    out[185] = 0.0;
    out[186] = 0.0;
    out[187] = 0.0;
    out[188] = 0.0;
    out[189] = 0.0;
    out[190] = 0.0;
    out[191] = 0.0;
    out[192] = 0.0;
    out[195] = 0.0;
    out[198] = 0.0;
    out[199] = 0.0;
    out[200] = 0.0;
    out[201] = 0.0;
    out[202] = 0.0;
    out[203] = 0.0;
    out[204] = 0.0;
    out[205] = 0.0;
    out[206] = 0.0;
    out[207] = 0.0;
    out[208] = 0.0;
    out[209] = 0.0;
    out[210] = 0.0;
    out[213] = 0.0;
    out[214] = 0.0;
    out[215] = 0.0;
    out[216] = 0.0;
    out[219] = 0.0;
    out[220] = 0.0;
    out[221] = 0.0;
    out[222] = 0.0;
    out[223] = 0.0;
    out[224] = 0.0;
    out[225] = 0.0;
    out[226] = 0.0;
    out[228] = 0.0;
    out[230] = 0.0;
    out[231] = 0.0;
    out[232] = 0.0;
    out[234] = 0.0;
    out[236] = 0.0;
    out[237] = 0.0;
    out[238] = 0.0;
    out[239] = 0.0;
    out[240] = 0.0;
    out[241] = 0.0;
    out[242] = 0.0;
    out[243] = 0.0;
    out[246] = 0.0;
    out[247] = 0.0;
    out[248] = 0.0;
    out[249] = 0.0;
    out[252] = 0.0;
    out[253] = 0.0;
    out[254] = 0.0;
    out[255] = 0.0;
    out[256] = 0.0;
    out[257] = 0.0;
    out[261] = 0.0;
    out[262] = 0.0;
    out[263] = 0.0;
    out[267] = 0.0;
    out[268] = 0.0;
    out[269] = 0.0;
    out[270] = 0.0;
    out[271] = 0.0;
    out[272] = 0.0;
    out[273] = 0.0;
    out[274] = 0.0;
    out[278] = 0.0;
    out[279] = 0.0;
    out[280] = 0.0;
    out[281] = 0.0;
    out[282] = 0.0;
    out[283] = 0.0;
    out[287] = 0.0;
    out[288] = 0.0;
    out[1] = x[8];
    out[163] = x[8];
    out[217] = x[8];
    out[34] = x[7];
    out[88] = x[7];
    out[196] = x[7];
    out[250] = x[7];
    const double t0 = -x[7]; /* -omega2 */
    out[2] = t0;
    out[164] = t0;
    out[218] = t0;
    out[23] = x[2];
    const double t1 = -x[2]; /* -gamma3 */
    out[7] = t1;
    out[8] = x[1];
    const double t2 = -x[8]; /* -omega3 */
    out[17] = t2;
    out[179] = t2;
    out[233] = t2;
    out[19] = x[6];
    out[181] = x[6];
    out[235] = x[6];
    out[41] = x[0];
    const double t3 = -x[0]; /* -gamma1 */
    out[25] = t3;
    const double t4 = -x[6]; /* -omega1 */
    out[35] = t4;
    out[89] = t4;
    out[197] = t4;
    out[251] = t4;
    const double t5 = -x[1]; /* -gamma2 */
    out[40] = t5;
    const double t6 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t7 = JLT_FMA(x[1], x[1], t6); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t8 = sqrt(t7); /* s = sqrt(gamma2*gamma2 + gamma1*gamma1) */
    const double t9 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = p[18]*t9; /* m*I3*b */
    const double t11 = JLT_FMA(t7, p[17], p[16]); /* (gamma2*gamma2 + gamma1*gamma1)*m*R^2*I1 + I1*I3 */
    const double t12 = JLT_FMA(t9, t10, t11); /* Theta = b*m*I3*b + (gamma2*gamma2 + gamma1*gamma1)*m*R^2*I1 + I1*I3 */
    const double t13 = JLT_FMA(x[2], x[2], t7); /* one = gamma3*gamma3 + gamma2*gamma2 + gamma1*gamma1 */
    const double t14 = p[4]*t13; /* I1*one */
    const double t15 = JLT_FMA(t7, p[11], t14); /* D = (gamma2*gamma2 + gamma1*gamma1)*m*a3^2 + I1*one */
    const double t16 = t8*t15; /* s*D */
    const double t17 = t12*t16; /* Theta*s*D */
    const double t18 = 1.0/t17; /* 1/(Theta*s*D) */
    const double t19 = t12*t18; /* 1/(D*s) = Theta*1/(Theta*s*D) */
    const double t20 = t8*t19; /* 1/D = s*1/(D*s) */
    const double t21 = x[0]*t20; /* gamma1*1/D */
    const double t22 = x[8]*p[19]; /* omega3*a3*I3 */
    const double t23 = x[6]*t22; /* omega1*omega3*a3*I3 */
    const double t24 = t13*p[6]; /* one*g*I1 */
    const double t25 = x[6]*x[6]; /* omega1*omega1 */
    const double t26 = JLT_FMA(x[7], x[7], t25); /* omega2*omega2 + omega1*omega1 */
    const double t27 = x[2]*p[4]; /* gamma3*I1 */
    const double t28 = t26*t27; /* (omega2*omega2 + omega1*omega1)*gamma3*I1 */
    const double t29 = x[6]*x[0]; /* omega1*gamma1 */
    const double t30 = JLT_FMA(x[7], x[1], t29); /* q = omega2*gamma2 + omega1*gamma1 */
    const double t31 = x[8]*p[5]; /* omega3*I3 */
    const double t32 = JLT_FNMA(t30, t31, t28); /* (omega2*omega2 + omega1*omega1)*gamma3*I1 - q*omega3*I3 */
    const double t33 = JLT_FNMA(p[3], t32, t24); /* one*g*I1 - a3*((omega2*omega2 + omega1*omega1)*gamma3*I1 - q*omega3*I3) */
    const double t34 = t20*t33; /* 1/D*t33 */
    const double t35 = JLT_FNMA(p[21], t34, p[20]); /* 2*g*I1 - (2*I1 + 2*m*a3^2)*1/D*t33 */
    const double t36 = JLT_FMA(x[0], t35, t23); /* gamma1*(2*g*I1 - (2*I1 + 2*m*a3^2)*1/D*t33) + omega1*omega3*a3*I3 */
    const double t37 = JLT_FMA(t21, t36, t34); /* gamma1*1/D*t36 + 1/D*t33 */
    out[266] = x[5];
    out[286] = x[5];
    const double t38 = t30*x[5]; /* q*v3 */
    out[265] = x[4];
    out[285] = x[4];
    const double t39 = x[7]*x[4]; /* omega2*v2 */
    out[264] = x[3];
    out[284] = x[3];
    const double t40 = JLT_FMA(x[6], x[3], t39); /* omega1*v1 + omega2*v2 */
    const double t41 = x[7]*x[0]; /* omega2*gamma1 */
    const double t42 = JLT_FNMA(x[1], x[6], t41); /* dgamma3 = omega2*gamma1 - gamma2*omega1 */
    const double t43 = x[2]*p[12]; /* gamma3*2*R */
    const double t44 = JLT_FNMA(t9, p[8], t43); /* gamma3*2*R - b*I3/I1 */
    const double t45 = x[8]*t44; /* omega3*(gamma3*2*R - b*I3/I1) */
    const double t46 = JLT_FMA(p[1], t30, t45); /* R*q + omega3*(gamma3*2*R - b*I3/I1) */
    const double t47 = JLT_FNMA(x[2], t40, t38); /* q*v3 - gamma3*(omega1*v1 + omega2*v2) */
    const double t48 = JLT_FMA(t42, t46, t47); /* gyroscopic = dgamma3*(R*q + omega3*(gamma3*2*R - b*I3/I1)) + q*v3 - gamma3*(omega1*v1 + omega2*v2) */
    const double t49 = t15*t19; /* 1/s = D*1/(D*s) */
    const double t50 = t49*t49; /* 1/s*1/s */
    const double t51 = t48*t50; /* gyroscopic*1/s*1/s */
    const double t52 = t16*t18; /* 1/Theta = s*D*1/(Theta*s*D) */
    const double t53 = t48*t52; /* gyroscopic*1/Theta */
    const double t54 = JLT_FMA(p[17], t53, t51); /* m*R^2*I1*gyroscopic*1/Theta + gyroscopic*1/s*1/s */
    const double t55 = x[0]*t54; /* gamma1*(m*R^2*I1*gyroscopic*1/Theta + gyroscopic*1/s*1/s) */
    const double t56 = JLT_FMA(p[1], t42, x[5]); /* R*dgamma3 + v3 */
    const double t57 = x[6]*t56; /* omega1*(R*dgamma3 + v3) */
    const double t58 = JLT_FMA(x[7], t46, t57); /* d(gyroscopic)/d(gamma1) = omega2*(R*q + omega3*(gamma3*2*R - b*I3/I1)) + omega1*(R*dgamma3 + v3) */
    const double t59 = JLT_FNMA((1.0 / 2.0), t58, t55); /* gamma1*(m*R^2*I1*gyroscopic*1/Theta + gyroscopic*1/s*1/s) - 1/2*d(gyroscopic)/d(gamma1) */
    const double t60 = t50*t52; /* 1/s*1/s*1/Theta */
    const double t61 = p[22]*t60; /* 2*I1*I3*1/s*1/s*1/Theta */
    const double t62 = t59*t61; /* t59*2*I1*I3*1/s*1/s*1/Theta */
    const double t63 = t37 - p[2]; /* gamma1*1/D*t36 + 1/D*t33 - g */
    const double t64 = JLT_FNMA(x[1], t62, t63); /* gamma1*1/D*t36 + 1/D*t33 - g - gamma2*t59*2*I1*I3*1/s*1/s*1/Theta */
    out[51] = t64;
    const double t65 = p[16]*t60; /* I1*I3*1/s*1/s*1/Theta */
    const double t66 = t48*t65; /* gyroscopic*I1*I3*1/s*1/s*1/Theta */
    const double t67 = x[7]*t22; /* omega2*omega3*a3*I3 */
    const double t68 = JLT_FMA(x[1], t35, t67); /* gamma2*(2*g*I1 - (2*I1 + 2*m*a3^2)*1/D*t33) + omega2*omega3*a3*I3 */
    const double t69 = t21*t68; /* gamma1*1/D*t68 */
    const double t70 = x[1]*t54; /* gamma2*(m*R^2*I1*gyroscopic*1/Theta + gyroscopic*1/s*1/s) */
    const double t71 = x[7]*t56; /* omega2*(R*dgamma3 + v3) */
    const double t72 = JLT_FNMA(x[6], t46, t71); /* d(gyroscopic)/d(gamma2) = omega2*(R*dgamma3 + v3) - omega1*(R*q + omega3*(gamma3*2*R - b*I3/I1)) */
    const double t73 = JLT_FNMA((1.0 / 2.0), t72, t70); /* gamma2*(m*R^2*I1*gyroscopic*1/Theta + gyroscopic*1/s*1/s) - 1/2*d(gyroscopic)/d(gamma2) */
    const double t74 = t61*t73; /* 2*I1*I3*1/s*1/s*1/Theta*t73 */
    const double t75 = t66 + t69; /* gyroscopic*I1*I3*1/s*1/s*1/Theta + gamma1*1/D*t68 */
    const double t76 = JLT_FNMA(x[1], t74, t75); /* gyroscopic*I1*I3*1/s*1/s*1/Theta + gamma1*1/D*t68 - gamma2*2*I1*I3*1/s*1/s*1/Theta*t73 */
    out[52] = t76;
    const double t77 = p[2] - t34; /* g - 1/D*t33 */
    const double t78 = x[2]*p[23]; /* gamma3*2*I1 */
    const double t79 = t77*t78; /* (g - 1/D*t33)*gamma3*2*I1 */
    const double t80 = JLT_FNMA(t26, p[7], t79); /* (g - 1/D*t33)*gamma3*2*I1 - (omega2*omega2 + omega1*omega1)*a3*I1 */
    const double t81 = t21*t80; /* gamma1*1/D*t80 */
    const double t82 = x[1]*t65; /* gamma2*I1*I3*1/s*1/s*1/Theta */
    const double t83 = t9*p[24]; /* b*2*m*R*I3 */
    const double t84 = x[8]*p[25]; /* omega3*(2*R - R*I3/I1) */
    const double t85 = JLT_FMS(t42, t84, t40); /* d(gyroscopic)/d(gamma3) = dgamma3*omega3*(2*R - R*I3/I1) - (omega1*v1 + omega2*v2) */
    const double t86 = JLT_FMS(t53, t83, t85); /* gyroscopic*1/Theta*b*2*m*R*I3 - d(gyroscopic)/d(gamma3) */
    const double t87 = JLT_FNMA(t82, t86, t81); /* gamma1*1/D*t80 - gamma2*I1*I3*1/s*1/s*1/Theta*(gyroscopic*1/Theta*b*2*m*R*I3 - d(gyroscopic)/d(gamma3)) */
    out[53] = t87;
    const double t88 = x[2]*x[6]; /* gamma3*omega1 */
    const double t89 = t82*t88; /* gamma2*I1*I3*1/s*1/s*1/Theta*gamma3*omega1 */
    const double t90 = -t89; /* -gamma2*I1*I3*1/s*1/s*1/Theta*gamma3*omega1 */
    out[54] = t90;
    const double t91 = x[7]*x[2]; /* omega2*gamma3 */
    const double t92 = JLT_FNMA(t82, t91, x[8]); /* omega3 - gamma2*I1*I3*1/s*1/s*1/Theta*omega2*gamma3 */
    out[55] = t92;
    const double t93 = JLT_FMS(t30, t82, x[7]); /* q*gamma2*I1*I3*1/s*1/s*1/Theta - omega2 */
    out[56] = t93;
    const double t94 = p[23]*t88; /* 2*I1*gamma3*omega1 */
    const double t95 = JLT_FNMA(x[0], t31, t94); /* 2*I1*gamma3*omega1 - gamma1*omega3*I3 */
    const double t96 = p[3]*t95; /* a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3) */
    const double t97 = t21*t96; /* gamma1*1/D*a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3) */
    const double t98 = x[0]*t56; /* gamma1*(R*dgamma3 + v3) */
    const double t99 = JLT_FNMA(x[2], x[3], t98); /* gamma1*(R*dgamma3 + v3) - gamma3*v1 */
    const double t100 = JLT_FNMA(x[1], t46, t99); /* d(gyroscopic)/d(omega1) = gamma1*(R*dgamma3 + v3) - gamma3*v1 - gamma2*(R*q + omega3*(gamma3*2*R - b*I3/I1)) */
    const double t101 = JLT_FMS(t82, t100, t97); /* gamma2*I1*I3*1/s*1/s*1/Theta*d(gyroscopic)/d(omega1) - gamma1*1/D*a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3) */
    out[57] = t101;
    const double t102 = p[23]*t91; /* 2*I1*omega2*gamma3 */
    const double t103 = JLT_FNMA(x[1], t31, t102); /* 2*I1*omega2*gamma3 - gamma2*omega3*I3 */
    const double t104 = p[3]*t103; /* a3*(2*I1*omega2*gamma3 - gamma2*omega3*I3) */
    const double t105 = x[1]*t56; /* gamma2*(R*dgamma3 + v3) */
    const double t106 = JLT_FNMA(x[2], x[4], t105); /* gamma2*(R*dgamma3 + v3) - gamma3*v2 */
    const double t107 = JLT_FMA(x[0], t46, t106); /* d(gyroscopic)/d(omega2) = gamma1*(R*q + omega3*(gamma3*2*R - b*I3/I1)) + gamma2*(R*dgamma3 + v3) - gamma3*v2 */
    const double t108 = JLT_FMA(t21, t104, x[5]); /* gamma1*1/D*a3*(2*I1*omega2*gamma3 - gamma2*omega3*I3) + v3 */
    const double t109 = JLT_FMS(t82, t107, t108); /* gamma2*I1*I3*1/s*1/s*1/Theta*d(gyroscopic)/d(omega2) - (gamma1*1/D*a3*(2*I1*omega2*gamma3 - gamma2*omega3*I3) + v3) */
    out[58] = t109;
    const double t110 = p[19]*t30; /* a3*I3*q */
    const double t111 = t42*t44; /* dgamma3*(gamma3*2*R - b*I3/I1) */
    const double t112 = JLT_FMA(t21, t110, x[4]); /* gamma1*1/D*a3*I3*q + v2 */
    const double t113 = JLT_FMA(t82, t111, t112); /* gamma2*I1*I3*1/s*1/s*1/Theta*dgamma3*(gamma3*2*R - b*I3/I1) + gamma1*1/D*a3*I3*q + v2 */
    out[59] = t113;
    const double t114 = x[1]*t20; /* gamma2*1/D */
    const double t115 = t36*t114; /* t36*gamma2*1/D */
    const double t116 = t115 - t66; /* t36*gamma2*1/D - gyroscopic*I1*I3*1/s*1/s*1/Theta */
    const double t117 = JLT_FMA(x[0], t62, t116); /* gamma1*t59*2*I1*I3*1/s*1/s*1/Theta + t36*gamma2*1/D - gyroscopic*I1*I3*1/s*1/s*1/Theta */
    out[68] = t117;
    const double t118 = JLT_FMA(t68, t114, t34); /* t68*gamma2*1/D + 1/D*t33 */
    const double t119 = t118 - p[2]; /* t68*gamma2*1/D + 1/D*t33 - g */
    const double t120 = JLT_FMA(x[0], t74, t119); /* gamma1*2*I1*I3*1/s*1/s*1/Theta*t73 + t68*gamma2*1/D + 1/D*t33 - g */
    out[69] = t120;
    const double t121 = t80*t114; /* t80*gamma2*1/D */
    const double t122 = x[0]*t65; /* gamma1*I1*I3*1/s*1/s*1/Theta */
    const double t123 = JLT_FMA(t86, t122, t121); /* (gyroscopic*1/Theta*b*2*m*R*I3 - d(gyroscopic)/d(gamma3))*gamma1*I1*I3*1/s*1/s*1/Theta + t80*gamma2*1/D */
    out[70] = t123;
    const double t124 = JLT_FMS(t88, t122, x[8]); /* gamma3*omega1*gamma1*I1*I3*1/s*1/s*1/Theta - omega3 */
    out[71] = t124;
    const double t125 = t91*t122; /* omega2*gamma3*gamma1*I1*I3*1/s*1/s*1/Theta */
    out[72] = t125;
    const double t126 = JLT_FNMA(t30, t122, x[6]); /* omega1 - q*gamma1*I1*I3*1/s*1/s*1/Theta */
    out[73] = t126;
    const double t127 = JLT_FNMA(t96, t114, x[5]); /* v3 - a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3)*gamma2*1/D */
    const double t128 = JLT_FNMA(t100, t122, t127); /* v3 - a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3)*gamma2*1/D - d(gyroscopic)/d(omega1)*gamma1*I1*I3*1/s*1/s*1/Theta */
    out[74] = t128;
    const double t129 = t104*t114; /* a3*(2*I1*omega2*gamma3 - gamma2*omega3*I3)*gamma2*1/D */
    const double t130 = JLT_FMA(t107, t122, t129); /* d(gyroscopic)/d(omega2)*gamma1*I1*I3*1/s*1/s*1/Theta + a3*(2*I1*omega2*gamma3 - gamma2*omega3*I3)*gamma2*1/D */
    const double t131 = -t130; /* -t130 */
    out[75] = t131;
    const double t132 = JLT_FMS(t110, t114, x[3]); /* a3*I3*q*gamma2*1/D - v1 */
    const double t133 = JLT_FNMA(t111, t122, t132); /* a3*I3*q*gamma2*1/D - v1 - dgamma3*(gamma3*2*R - b*I3/I1)*gamma1*I1*I3*1/s*1/s*1/Theta */
    out[76] = t133;
    const double t134 = x[2]*t20; /* gamma3*1/D */
    const double t135 = t36*t134; /* t36*gamma3*1/D */
    out[85] = t135;
    const double t136 = t68*t134; /* t68*gamma3*1/D */
    out[86] = t136;
    const double t137 = JLT_FMS(t80, t134, t77); /* t80*gamma3*1/D - (g - 1/D*t33) */
    out[87] = t137;
    const double t138 = JLT_FMA(t96, t134, x[4]); /* a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3)*gamma3*1/D + v2 */
    const double t139 = -t138; /* -(a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3)*gamma3*1/D + v2) */
    out[91] = t139;
    const double t140 = JLT_FNMA(t104, t134, x[3]); /* v1 - a3*(2*I1*omega2*gamma3 - gamma2*omega3*I3)*gamma3*1/D */
    out[92] = t140;
    const double t141 = t110*t134; /* a3*I3*q*gamma3*1/D */
    out[93] = t141;
    const double t142 = t9*t60; /* b*1/s*1/s*1/Theta */
    const double t143 = p[18]*t142; /* m*I3*b*1/s*1/s*1/Theta */
    const double t144 = t48*t143; /* gyroscopic*m*I3*b*1/s*1/s*1/Theta */
    const double t145 = t142*p[26]; /* b*1/s*1/s*1/Theta*2*m*I3 */
    const double t146 = x[0]*t145; /* gamma1*b*1/s*1/s*1/Theta*2*m*I3 */
    const double t147 = JLT_FMS(t59, t146, t144); /* t59*gamma1*b*1/s*1/s*1/Theta*2*m*I3 - gyroscopic*m*I3*b*1/s*1/s*1/Theta */
    const double t148 = JLT_FMA(t115, p[14], t147); /* t36*gamma2*1/D*m*a3/I1 + t147 */
    out[102] = t148;
    const double t149 = t118*p[14]; /* (t68*gamma2*1/D + 1/D*t33)*m*a3/I1 */
    const double t150 = JLT_FMA(t73, t146, t149); /* t73*gamma1*b*1/s*1/s*1/Theta*2*m*I3 + (t68*gamma2*1/D + 1/D*t33)*m*a3/I1 */
    out[103] = t150;
    const double t151 = t121*p[14]; /* t80*gamma2*1/D*m*a3/I1 */
    const double t152 = t86*t143; /* (gyroscopic*1/Theta*b*2*m*R*I3 - d(gyroscopic)/d(gamma3))*m*I3*b*1/s*1/s*1/Theta */
    const double t153 = t48*p[27]; /* gyroscopic*m*R*I3 */
    const double t154 = JLT_FNMA(t60, t153, t152); /* t152 - 1/s*1/s*1/Theta*gyroscopic*m*R*I3 */
    const double t155 = JLT_FMA(x[0], t154, t151); /* gamma1*(t152 - 1/s*1/s*1/Theta*gyroscopic*m*R*I3) + t80*gamma2*1/D*m*a3/I1 */
    out[104] = t155;
    const double t156 = x[0]*t143; /* gamma1*m*I3*b*1/s*1/s*1/Theta */
    const double t157 = t88*t156; /* gamma3*omega1*gamma1*m*I3*b*1/s*1/s*1/Theta */
    out[105] = t157;
    const double t158 = t91*t156; /* omega2*gamma3*gamma1*m*I3*b*1/s*1/s*1/Theta */
    out[106] = t158;
    const double t159 = t30*t156; /* q*gamma1*m*I3*b*1/s*1/s*1/Theta */
    const double t160 = -t159; /* -q*gamma1*m*I3*b*1/s*1/s*1/Theta */
    out[107] = t160;
    const double t161 = t95*p[28]; /* (2*I1*gamma3*omega1 - gamma1*omega3*I3)*m*a3^2/I1 */
    const double t162 = t114*t161; /* gamma2*1/D*(2*I1*gamma3*omega1 - gamma1*omega3*I3)*m*a3^2/I1 */
    const double t163 = JLT_FMA(t100, t156, t162); /* d(gyroscopic)/d(omega1)*gamma1*m*I3*b*1/s*1/s*1/Theta + gamma2*1/D*(2*I1*gamma3*omega1 - gamma1*omega3*I3)*m*a3^2/I1 */
    const double t164 = -t163; /* -t163 */
    out[108] = t164;
    const double t165 = x[8]*p[13]; /* omega3*(I1 - I3)/I1 */
    const double t166 = t103*p[28]; /* (2*I1*omega2*gamma3 - gamma2*omega3*I3)*m*a3^2/I1 */
    const double t167 = JLT_FNMA(t114, t166, t165); /* omega3*(I1 - I3)/I1 - gamma2*1/D*(2*I1*omega2*gamma3 - gamma2*omega3*I3)*m*a3^2/I1 */
    const double t168 = JLT_FNMA(t107, t156, t167); /* t167 - d(gyroscopic)/d(omega2)*gamma1*m*I3*b*1/s*1/s*1/Theta */
    out[109] = t168;
    const double t169 = x[7]*p[13]; /* omega2*(I1 - I3)/I1 */
    const double t170 = t30*p[29]; /* q*m*a3^2*I3/I1 */
    const double t171 = JLT_FMA(t114, t170, t169); /* gamma2*1/D*q*m*a3^2*I3/I1 + omega2*(I1 - I3)/I1 */
    const double t172 = JLT_FNMA(t111, t156, t171); /* gamma2*1/D*q*m*a3^2*I3/I1 + omega2*(I1 - I3)/I1 - dgamma3*(gamma3*2*R - b*I3/I1)*gamma1*m*I3*b*1/s*1/s*1/Theta */
    out[110] = t172;
    const double t173 = t37*p[14]; /* (gamma1*1/D*t36 + 1/D*t33)*m*a3/I1 */
    const double t174 = x[1]*t145; /* gamma2*b*1/s*1/s*1/Theta*2*m*I3 */
    const double t175 = JLT_FMS(t59, t174, t173); /* t59*gamma2*b*1/s*1/s*1/Theta*2*m*I3 - (gamma1*1/D*t36 + 1/D*t33)*m*a3/I1 */
    out[119] = t175;
    const double t176 = JLT_FMS(t73, t174, t144); /* t73*gamma2*b*1/s*1/s*1/Theta*2*m*I3 - gyroscopic*m*I3*b*1/s*1/s*1/Theta */
    const double t177 = JLT_FNMA(t69, p[14], t176); /* t176 - gamma1*1/D*t68*m*a3/I1 */
    out[120] = t177;
    const double t178 = t81*p[14]; /* gamma1*1/D*t80*m*a3/I1 */
    const double t179 = JLT_FMS(x[1], t154, t178); /* gamma2*(t152 - 1/s*1/s*1/Theta*gyroscopic*m*R*I3) - gamma1*1/D*t80*m*a3/I1 */
    out[121] = t179;
    const double t180 = x[1]*t143; /* gamma2*m*I3*b*1/s*1/s*1/Theta */
    const double t181 = t88*t180; /* gamma3*omega1*gamma2*m*I3*b*1/s*1/s*1/Theta */
    out[122] = t181;
    const double t182 = t91*t180; /* omega2*gamma3*gamma2*m*I3*b*1/s*1/s*1/Theta */
    out[123] = t182;
    const double t183 = t30*t180; /* q*gamma2*m*I3*b*1/s*1/s*1/Theta */
    const double t184 = -t183; /* -q*gamma2*m*I3*b*1/s*1/s*1/Theta */
    out[124] = t184;
    const double t185 = JLT_FMS(t21, t161, t165); /* gamma1*1/D*(2*I1*gamma3*omega1 - gamma1*omega3*I3)*m*a3^2/I1 - omega3*(I1 - I3)/I1 */
    const double t186 = JLT_FNMA(t100, t180, t185); /* t185 - d(gyroscopic)/d(omega1)*gamma2*m*I3*b*1/s*1/s*1/Theta */
    out[125] = t186;
    const double t187 = t21*t166; /* gamma1*1/D*(2*I1*omega2*gamma3 - gamma2*omega3*I3)*m*a3^2/I1 */
    const double t188 = JLT_FNMA(t107, t180, t187); /* gamma1*1/D*(2*I1*omega2*gamma3 - gamma2*omega3*I3)*m*a3^2/I1 - d(gyroscopic)/d(omega2)*gamma2*m*I3*b*1/s*1/s*1/Theta */
    out[126] = t188;
    const double t189 = x[6]*p[13]; /* omega1*(I1 - I3)/I1 */
    const double t190 = JLT_FMA(t21, t170, t189); /* gamma1*1/D*q*m*a3^2*I3/I1 + omega1*(I1 - I3)/I1 */
    const double t191 = JLT_FMA(t111, t180, t190); /* dgamma3*(gamma3*2*R - b*I3/I1)*gamma2*m*I3*b*1/s*1/s*1/Theta + gamma1*1/D*q*m*a3^2*I3/I1 + omega1*(I1 - I3)/I1 */
    const double t192 = -t191; /* -t191 */
    out[127] = t192;
    const double t193 = t52*p[30]; /* 1/Theta*m*R*I1 */
    const double t194 = t58*t193; /* d(gyroscopic)/d(gamma1)*1/Theta*m*R*I1 */
    const double t195 = t52*p[31]; /* 1/Theta*2*m^2*R^3*I1^2 */
    const double t196 = t53*t195; /* gyroscopic*1/Theta*1/Theta*2*m^2*R^3*I1^2 */
    const double t197 = JLT_FNMA(x[0], t196, t194); /* d(gyroscopic)/d(gamma1)*1/Theta*m*R*I1 - gamma1*gyroscopic*1/Theta*1/Theta*2*m^2*R^3*I1^2 */
    out[136] = t197;
    const double t198 = t72*t193; /* d(gyroscopic)/d(gamma2)*1/Theta*m*R*I1 */
    const double t199 = JLT_FNMA(x[1], t196, t198); /* d(gyroscopic)/d(gamma2)*1/Theta*m*R*I1 - gamma2*gyroscopic*1/Theta*1/Theta*2*m^2*R^3*I1^2 */
    out[137] = t199;
    const double t200 = t86*t193; /* (gyroscopic*1/Theta*b*2*m*R*I3 - d(gyroscopic)/d(gamma3))*1/Theta*m*R*I1 */
    const double t201 = -t200; /* -t200 */
    out[138] = t201;
    const double t202 = t88*t193; /* gamma3*omega1*1/Theta*m*R*I1 */
    const double t203 = -t202; /* -gamma3*omega1*1/Theta*m*R*I1 */
    out[139] = t203;
    const double t204 = t91*t193; /* omega2*gamma3*1/Theta*m*R*I1 */
    const double t205 = -t204; /* -omega2*gamma3*1/Theta*m*R*I1 */
    out[140] = t205;
    const double t206 = t30*t193; /* q*1/Theta*m*R*I1 */
    out[141] = t206;
    const double t207 = t100*t193; /* d(gyroscopic)/d(omega1)*1/Theta*m*R*I1 */
    out[142] = t207;
    const double t208 = t107*t193; /* d(gyroscopic)/d(omega2)*1/Theta*m*R*I1 */
    out[143] = t208;
    const double t209 = t111*t193; /* dgamma3*(gamma3*2*R - b*I3/I1)*1/Theta*m*R*I1 */
    out[144] = t209;
    out[176] = x[11];
    out[260] = x[11];
    const double t210 = -x[11]; /* -alpha3 */
    out[160] = t210;
    out[161] = x[10];
    out[259] = x[10];
    out[194] = x[9];
    out[258] = x[9];
    const double t211 = -x[9]; /* -alpha1 */
    out[178] = t211;
    const double t212 = -x[10]; /* -alpha2 */
    out[193] = t212;
    out[227] = x[14];
    out[277] = x[14];
    const double t213 = -x[14]; /* -beta3 */
    out[211] = t213;
    out[212] = x[13];
    out[276] = x[13];
    out[245] = x[12];
    out[275] = x[12];
    const double t214 = -x[12]; /* -beta1 */
    out[229] = t214;
    const double t215 = -x[13]; /* -beta2 */
    out[244] = t215;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[25] = x[1];
    out[18] = x[8];
    out[180] = x[8];
    out[234] = x[8];
    out[40] = x[2];
    out[51] = x[7];
    out[105] = x[7];
    out[213] = x[7];
    out[267] = x[7];
    out[36] = x[6];
    out[198] = x[6];
    out[252] = x[6];
    out[58] = x[0];
    out[282] = x[4];
    out[302] = x[4];
    out[283] = x[5];
    out[303] = x[5];
    out[281] = x[3];
    out[301] = x[3];
    out[178] = x[10];
    out[276] = x[10];
    out[193] = x[11];
    out[277] = x[11];
    out[211] = x[9];
    out[275] = x[9];
    out[229] = x[13];
    out[293] = x[13];
    out[244] = x[14];
    out[294] = x[14];
    out[262] = x[12];
    out[292] = x[12];
    out[17] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = 0.0;
    out[30] = 0.0;
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[35] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = 0.0;
    out[41] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = 0.0;
    out[50] = 0.0;
    out[53] = 0.0;
    out[54] = 0.0;
    out[55] = 0.0;
    out[56] = 0.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = 0.0;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[81] = 0.0;
    out[82] = 0.0;
    out[83] = 0.0;
    out[84] = 0.0;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = 0.0;
    out[100] = 0.0;
    out[101] = 0.0;
    out[107] = 0.0;
    out[111] = 0.0;
    out[112] = 0.0;
    out[113] = 0.0;
    out[114] = 0.0;
    out[115] = 0.0;
    out[116] = 0.0;
    out[117] = 0.0;
    out[118] = 0.0;
    out[128] = 0.0;
    out[129] = 0.0;
    out[130] = 0.0;
    out[131] = 0.0;
    out[132] = 0.0;
    out[133] = 0.0;
    out[134] = 0.0;
    out[135] = 0.0;
    out[145] = 0.0;
    out[146] = 0.0;
    out[147] = 0.0;
    out[148] = 0.0;
    out[149] = 0.0;
    out[150] = 0.0;
    out[151] = 0.0;
    out[152] = 0.0;
    out[162] = 0.0;
    out[163] = 0.0;
    out[164] = 0.0;
    out[165] = 0.0;
    out[166] = 0.0;
    out[167] = 0.0;
    out[168] = 0.0;
    out[169] = 0.0;
    out[170] = 0.0;
    out[171] = 0.0;
    out[172] = 0.0;
    out[173] = 0.0;
    out[174] = 0.0;
    out[175] = 0.0;
    out[176] = 0.0;
    out[179] = 0.0;
    out[182] = 0.0;
    out[183] = 0.0;
    out[184] = 0.0;
    out[185] = 0.0;
    out[186] = 0.0;
    out[187] = 0.0;
    out[188] = 0.0;
    out[189] = 0.0;
    out[190] = 0.0;
    out[191] = 0.0;
    out[192] = 0.0;
    out[194] = 0.0;
    out[197] = 0.0;
    out[199] = 0.0;
    out[200] = 0.0;
    out[201] = 0.0;
    out[202] = 0.0;
    out[203] = 0.0;
    out[204] = 0.0;
    out[205] = 0.0;
    out[206] = 0.0;
    out[207] = 0.0;
    out[208] = 0.0;
    out[209] = 0.0;
    out[212] = 0.0;
    out[215] = 0.0;
    out[216] = 0.0;
    out[217] = 0.0;
    out[218] = 0.0;
    out[219] = 0.0;
    out[220] = 0.0;
    out[221] = 0.0;
    out[222] = 0.0;
    out[223] = 0.0;
    out[224] = 0.0;
    out[225] = 0.0;
    out[226] = 0.0;
    out[227] = 0.0;
    out[230] = 0.0;
    out[231] = 0.0;
    out[232] = 0.0;
    out[233] = 0.0;
    out[236] = 0.0;
    out[237] = 0.0;
    out[238] = 0.0;
    out[239] = 0.0;
    out[240] = 0.0;
    out[241] = 0.0;
    out[242] = 0.0;
    out[243] = 0.0;
    out[245] = 0.0;
    out[247] = 0.0;
    out[248] = 0.0;
    out[249] = 0.0;
    out[251] = 0.0;
    out[253] = 0.0;
    out[254] = 0.0;
    out[255] = 0.0;
    out[256] = 0.0;
    out[257] = 0.0;
    out[258] = 0.0;
    out[259] = 0.0;
    out[260] = 0.0;
    out[263] = 0.0;
    out[264] = 0.0;
    out[265] = 0.0;
    out[266] = 0.0;
    out[269] = 0.0;
    out[270] = 0.0;
    out[271] = 0.0;
    out[272] = 0.0;
    out[273] = 0.0;
    out[274] = 0.0;
    out[278] = 0.0;
    out[279] = 0.0;
    out[280] = 0.0;
    out[284] = 0.0;
    out[285] = 0.0;
    out[286] = 0.0;
    out[287] = 0.0;
    out[288] = 0.0;
    out[289] = 0.0;
    out[290] = 0.0;
    out[291] = 0.0;
    out[295] = 0.0;
    out[296] = 0.0;
    out[297] = 0.0;
    out[298] = 0.0;
    out[299] = 0.0;
    out[300] = 0.0;
    out[304] = 0.0;
    out[305] = 0.0;
    const double t0 = -x[7]; /* -omega2 */
    out[19] = t0;
    out[181] = t0;
    out[235] = t0;
    const double t1 = -x[2]; /* -gamma3 */
    out[24] = t1;
    const double t2 = -x[8]; /* -omega3 */
    out[34] = t2;
    out[196] = t2;
    out[250] = t2;
    const double t3 = -x[0]; /* -gamma1 */
    out[42] = t3;
    const double t4 = -x[6]; /* -omega1 */
    out[52] = t4;
    out[106] = t4;
    out[214] = t4;
    out[268] = t4;
    const double t5 = -x[1]; /* -gamma2 */
    out[57] = t5;
    const double t6 = -x[11]; /* -alpha3 */
    out[177] = t6;
    const double t7 = -x[9]; /* -alpha1 */
    out[195] = t7;
    const double t8 = -x[10]; /* -alpha2 */
    out[210] = t8;
    const double t9 = -x[14]; /* -beta3 */
    out[228] = t9;
    const double t10 = -x[12]; /* -beta1 */
    out[246] = t10;
    const double t11 = -x[13]; /* -beta2 */
    out[261] = t11;
    const double t12 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t13 = JLT_FMA(x[1], x[1], t12); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t14 = JLT_FMA(x[2], x[2], t13); /* one = gamma3*gamma3 + gamma2*gamma2 + gamma1*gamma1 */
    const double t15 = p[4]*t14; /* I1*one */
    const double t16 = JLT_FMA(p[11], t13, t15); /* D = m*a3^2*(gamma2*gamma2 + gamma1*gamma1) + I1*one */
    const double t17 = p[6]*t14; /* g*I1*one */
    const double t18 = sqrt(t13); /* s = sqrt(gamma2*gamma2 + gamma1*gamma1) */
    const double t19 = JLT_FMA(p[10], t13, p[9]); /* R^2*I1/I3*(gamma2*gamma2 + gamma1*gamma1) + I1/m */
    const double t20 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t21 = JLT_FMA(t20, t20, t19); /* Theta/(m*I3) = b*b + R^2*I1/I3*(gamma2*gamma2 + gamma1*gamma1) + I1/m */
    const double t22 = t16*t18; /* D*s */
    const double t23 = t21*t22; /* Theta/(m*I3)*D*s */
    const double t24 = 1.0/t23; /* 1/(Theta/(m*I3)*D*s) */
    const double t25 = t21*t24; /* 1/(D*s) = Theta/(m*I3)*1/(Theta/(m*I3)*D*s) */
    const double t26 = t22*t24; /* 1/(Theta/(m*I3)) = D*s*1/(Theta/(m*I3)*D*s) */
    const double t27 = t16*t25; /* 1/s = D*1/(D*s) */
    const double t28 = t18*t25; /* 1/D = s*1/(D*s) */
    const double t29 = t27*t27; /* 1/s*1/s */
    const double t30 = x[6]*x[6]; /* omega1*omega1 */
    const double t31 = JLT_FMA(x[7], x[7], t30); /* omega2*omega2 + omega1*omega1 */
    const double t32 = x[6]*x[0]; /* omega1*gamma1 */
    const double t33 = JLT_FMA(x[1], x[7], t32); /* q = gamma2*omega2 + omega1*gamma1 */
    const double t34 = x[2]*p[12]; /* gamma3*2*R */
    const double t35 = JLT_FNMA(p[8], t20, t34); /* gamma3*2*R - I3/I1*b */
    const double t36 = x[2]*t31; /* gamma3*(omega2*omega2 + omega1*omega1) */
    const double t37 = x[8]*p[8]; /* omega3*I3/I1 */
    const double t38 = JLT_FNMA(t33, t37, t36); /* gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*I3/I1 */
    const double t39 = JLT_FNMA(p[7], t38, t17); /* g*I1*one - a3*I1*(gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*I3/I1) */
    const double t40 = x[7]*x[4]; /* omega2*v2 */
    const double t41 = JLT_FMA(x[6], x[3], t40); /* omega1*v1 + omega2*v2 */
    const double t42 = x[1]*x[6]; /* gamma2*omega1 */
    const double t43 = x[7]*x[0]; /* omega2*gamma1 */
    const double t44 = t43 - t42; /* omega2*gamma1 - gamma2*omega1 */
    out[2] = t44;
    const double t45 = t42 - t43; /* gamma2*omega1 - omega2*gamma1 */
    const double t46 = x[5]*t33; /* v3*q */
    const double t47 = JLT_FNMA(x[2], t41, t46); /* v3*q - gamma3*(omega1*v1 + omega2*v2) */
    const double t48 = x[8]*t35; /* omega3*(gamma3*2*R - I3/I1*b) */
    const double t49 = JLT_FMA(p[1], t33, t48); /* R*q + omega3*(gamma3*2*R - I3/I1*b) */
    const double t50 = JLT_FNMA(t45, t49, t47); /* gyroscopic = v3*q - gamma3*(omega1*v1 + omega2*v2) - (gamma2*omega1 - omega2*gamma1)*(R*q + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t51 = t35*t45; /* (gamma3*2*R - I3/I1*b)*(gamma2*omega1 - omega2*gamma1) */
    const double t52 = t28*t39; /* 1/D*t39 */
    const double t53 = t26*t29; /* 1/(Theta/(m*I3))*1/s*1/s */
    const double t54 = JLT_FMA(p[10], t26, t29); /* R^2*I1/I3*1/(Theta/(m*I3)) + 1/s*1/s */
    const double t55 = x[8]*p[34]; /* omega3*1/2*(2*R - R*I3/I1)/R */
    const double t56 = t45*t55; /* (gamma2*omega1 - omega2*gamma1)*omega3*1/2*(2*R - R*I3/I1)/R */
    const double t57 = JLT_FNMA(p[1], t45, x[5]); /* v3 - R*(gamma2*omega1 - omega2*gamma1) */
    const double t58 = x[1]*x[8]; /* gamma2*omega3 */
    const double t59 = x[2]*x[7]; /* gamma3*omega2 */
    const double t60 = t58 - t59; /* gamma2*omega3 - gamma3*omega2 */
    out[0] = t60;
    const double t61 = JLT_FNMA(p[36], t58, t59); /* gamma3*omega2 - 1/2*I3/I1*gamma2*omega3 */
    const double t62 = x[2]*x[6]; /* gamma3*omega1 */
    const double t63 = x[8]*x[0]; /* omega3*gamma1 */
    const double t64 = t62 - t63; /* gamma3*omega1 - omega3*gamma1 */
    out[1] = t64;
    const double t65 = JLT_FNMA(p[36], t63, t62); /* gamma3*omega1 - 1/2*I3/I1*omega3*gamma1 */
    const double t66 = p[2] - t52; /* g - 1/D*t39 */
    const double t67 = t50*t53; /* gyroscopic*1/(Theta/(m*I3))*1/s*1/s */
    const double t68 = t54*t67; /* (R^2*I1/I3*1/(Theta/(m*I3)) + 1/s*1/s)*gyroscopic*1/(Theta/(m*I3))*1/s*1/s */
    const double t69 = x[8]*p[19]; /* omega3*a3*I3 */
    const double t70 = JLT_FNMA(p[21], t52, p[20]); /* 2*g*I1 - (2*I1 + 2*m*a3^2)*1/D*t39 */
    const double t71 = p[14]*t52; /* m*a3/I1*1/D*t39 */
    const double t72 = t26*t50; /* 1/(Theta/(m*I3))*gyroscopic */
    const double t73 = JLT_FMA(t20, t72, t56); /* b*1/(Theta/(m*I3))*gyroscopic + (gamma2*omega1 - omega2*gamma1)*omega3*1/2*(2*R - R*I3/I1)/R */
    const double t74 = JLT_FMA(p[12], t73, t41); /* 2*R*t73 + omega1*v1 + omega2*v2 */
    const double t75 = x[2]*t66; /* gamma3*(g - 1/D*t39) */
    const double t76 = JLT_FNMA(p[33], t31, t75); /* gamma3*(g - 1/D*t39) - 1/2*a3*(omega2*omega2 + omega1*omega1) */
    const double t77 = JLT_FMS(x[7], x[3], t75); /* omega2*v1 - gamma3*(g - 1/D*t39) */
    const double t78 = JLT_FNMA(x[6], x[4], t77); /* omega2*v1 - gamma3*(g - 1/D*t39) - omega1*v2 */
    out[5] = t78;
    const double t79 = x[8]*p[13]; /* omega3*(I1 - I3)/I1 */
    const double t80 = x[0]*t28; /* gamma1*1/D */
    const double t81 = x[6]*t69; /* omega1*omega3*a3*I3 */
    const double t82 = JLT_FMA(x[0], t70, t81); /* gamma1*(2*g*I1 - (2*I1 + 2*m*a3^2)*1/D*t39) + omega1*omega3*a3*I3 */
    const double t83 = x[1]*t70; /* gamma2*(2*g*I1 - (2*I1 + 2*m*a3^2)*1/D*t39) */
    const double t84 = JLT_FMA(x[7], t69, t83); /* omega2*omega3*a3*I3 + gamma2*(2*g*I1 - (2*I1 + 2*m*a3^2)*1/D*t39) */
    const double t85 = x[6]*t57; /* omega1*(v3 - R*(gamma2*omega1 - omega2*gamma1)) */
    const double t86 = JLT_FMA(x[7], t49, t85); /* d(gyroscopic)/d(gamma1) = omega2*(R*q + omega3*(gamma3*2*R - I3/I1*b)) + omega1*(v3 - R*(gamma2*omega1 - omega2*gamma1)) */
    const double t87 = x[7]*t57; /* omega2*(v3 - R*(gamma2*omega1 - omega2*gamma1)) */
    const double t88 = JLT_FNMA(x[6], t49, t87); /* d(gyroscopic)/d(gamma2) = omega2*(v3 - R*(gamma2*omega1 - omega2*gamma1)) - omega1*(R*q + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t89 = x[0]*t57; /* gamma1*(v3 - R*(gamma2*omega1 - omega2*gamma1)) */
    const double t90 = x[1]*t57; /* gamma2*(v3 - R*(gamma2*omega1 - omega2*gamma1)) */
    const double t91 = JLT_FNMA(x[2], x[3], t89); /* gamma1*(v3 - R*(gamma2*omega1 - omega2*gamma1)) - gamma3*v1 */
    const double t92 = JLT_FNMA(x[2], x[4], t90); /* gamma2*(v3 - R*(gamma2*omega1 - omega2*gamma1)) - gamma3*v2 */
    const double t93 = JLT_FNMA(x[1], t49, t91); /* d(gyroscopic)/d(omega1) = gamma1*(v3 - R*(gamma2*omega1 - omega2*gamma1)) - gamma3*v1 - gamma2*(R*q + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t94 = JLT_FMA(x[0], t49, t92); /* d(gyroscopic)/d(omega2) = gamma1*(R*q + omega3*(gamma3*2*R - I3/I1*b)) + gamma2*(v3 - R*(gamma2*omega1 - omega2*gamma1)) - gamma3*v2 */
    const double t95 = x[8]*x[4]; /* omega3*v2 */
    const double t96 = JLT_FNMA(x[7], x[5], t95); /* omega3*v2 - omega2*v3 */
    const double t97 = JLT_FNMA(x[0], t66, t96); /* omega3*v2 - omega2*v3 - gamma1*(g - 1/D*t39) */
    const double t98 = x[6]*x[5]; /* omega1*v3 */
    const double t99 = JLT_FNMA(x[8], x[3], t98); /* omega1*v3 - omega3*v1 */
    const double t100 = JLT_FNMA(x[1], t66, t99); /* omega1*v3 - omega3*v1 - gamma2*(g - 1/D*t39) */
    const double t101 = t20*t53; /* b*1/(Theta/(m*I3))*1/s*1/s */
    const double t102 = 2.0*t20; /* 2*b */
    const double t103 = x[6]*t79; /* omega1*omega3*(I1 - I3)/I1 */
    const double t104 = p[14]*t80; /* m*a3/I1*gamma1*1/D */
    const double t105 = JLT_FMA(t39, t104, t103); /* t39*m*a3/I1*gamma1*1/D + omega1*omega3*(I1 - I3)/I1 */
    const double t106 = x[0]*t68; /* gamma1*t68 */
    const double t107 = x[1]*t68; /* gamma2*t68 */
    const double t108 = (1.0 / 2.0)*t53; /* 1/2*1/(Theta/(m*I3))*1/s*1/s */
    const double t109 = p[9]*t53; /* I1/m*1/(Theta/(m*I3))*1/s*1/s */
    const double t110 = JLT_FNMA(t86, t108, t106); /* gamma1*t68 - d(gyroscopic)/d(gamma1)*1/2*1/(Theta/(m*I3))*1/s*1/s */
    const double t111 = JLT_FNMA(t88, t108, t107); /* gamma2*t68 - d(gyroscopic)/d(gamma2)*1/2*1/(Theta/(m*I3))*1/s*1/s */
    const double t112 = p[35]*t61; /* 2*a3*I1*(gamma3*omega2 - 1/2*I3/I1*gamma2*omega3) */
    const double t113 = p[38]*t61; /* 2*m*a3^2*(gamma3*omega2 - 1/2*I3/I1*gamma2*omega3) */
    const double t114 = x[1]*t28; /* gamma2*1/D */
    const double t115 = x[2]*t28; /* gamma3*1/D */
    const double t116 = t82*t115; /* t82*gamma3*1/D */
    out[102] = t116;
    const double t117 = t84*t115; /* t84*gamma3*1/D */
    out[103] = t117;
    const double t118 = JLT_FNMA(t112, t115, x[3]); /* v1 - 2*a3*I1*(gamma3*omega2 - 1/2*I3/I1*gamma2*omega3)*gamma3*1/D */
    out[109] = t118;
    const double t119 = p[38]*t65; /* 2*m*a3^2*(gamma3*omega1 - 1/2*I3/I1*omega3*gamma1) */
    const double t120 = p[35]*t65; /* 2*a3*I1*(gamma3*omega1 - 1/2*I3/I1*omega3*gamma1) */
    const double t121 = p[9]*t67; /* I1/m*gyroscopic*1/(Theta/(m*I3))*1/s*1/s */
    const double t122 = JLT_FMA(x[1], t121, t97); /* gamma2*I1/m*gyroscopic*1/(Theta/(m*I3))*1/s*1/s + omega3*v2 - omega2*v3 - gamma1*(g - 1/D*t39) */
    out[3] = t122;
    const double t123 = JLT_FNMA(x[0], t121, t100); /* omega1*v3 - omega3*v1 - gamma2*(g - 1/D*t39) - gamma1*I1/m*gyroscopic*1/(Theta/(m*I3))*1/s*1/s */
    out[4] = t123;
    const double t124 = x[7]*t79; /* omega2*omega3*(I1 - I3)/I1 */
    const double t125 = JLT_FMA(x[1], t71, t124); /* gamma2*m*a3/I1*1/D*t39 + omega2*omega3*(I1 - I3)/I1 */
    const double t126 = x[0]*t101; /* gamma1*b*1/(Theta/(m*I3))*1/s*1/s */
    const double t127 = JLT_FNMA(t50, t126, t125); /* gamma2*m*a3/I1*1/D*t39 + omega2*omega3*(I1 - I3)/I1 - gyroscopic*gamma1*b*1/(Theta/(m*I3))*1/s*1/s */
    out[6] = t127;
    const double t128 = t62*t126; /* gamma3*omega1*gamma1*b*1/(Theta/(m*I3))*1/s*1/s */
    out[122] = t128;
    const double t129 = t59*t126; /* gamma3*omega2*gamma1*b*1/(Theta/(m*I3))*1/s*1/s */
    out[123] = t129;
    const double t130 = x[1]*t101; /* gamma2*b*1/(Theta/(m*I3))*1/s*1/s */
    const double t131 = JLT_FMA(t50, t130, t105); /* gyroscopic*gamma2*b*1/(Theta/(m*I3))*1/s*1/s + t39*m*a3/I1*gamma1*1/D + omega1*omega3*(I1 - I3)/I1 */
    const double t132 = -t131; /* -t131 */
    out[7] = t132;
    const double t133 = t62*t130; /* gamma3*omega1*gamma2*b*1/(Theta/(m*I3))*1/s*1/s */
    out[139] = t133;
    const double t134 = t59*t130; /* gamma3*omega2*gamma2*b*1/(Theta/(m*I3))*1/s*1/s */
    out[140] = t134;
    const double t135 = p[15]*t26; /* R*I1/I3*1/(Theta/(m*I3)) */
    const double t136 = p[39]*t26; /* 2*R^3*I1^2/I3^2*1/(Theta/(m*I3)) */
    const double t137 = t72*t136; /* 1/(Theta/(m*I3))*gyroscopic*2*R^3*I1^2/I3^2*1/(Theta/(m*I3)) */
    const double t138 = t86*t135; /* d(gyroscopic)/d(gamma1)*R*I1/I3*1/(Theta/(m*I3)) */
    const double t139 = JLT_FNMA(x[0], t137, t138); /* d(gyroscopic)/d(gamma1)*R*I1/I3*1/(Theta/(m*I3)) - gamma1*1/(Theta/(m*I3))*gyroscopic*2*R^3*I1^2/I3^2*1/(Theta/(m*I3)) */
    out[153] = t139;
    const double t140 = t88*t135; /* d(gyroscopic)/d(gamma2)*R*I1/I3*1/(Theta/(m*I3)) */
    const double t141 = JLT_FNMA(x[1], t137, t140); /* d(gyroscopic)/d(gamma2)*R*I1/I3*1/(Theta/(m*I3)) - gamma2*1/(Theta/(m*I3))*gyroscopic*2*R^3*I1^2/I3^2*1/(Theta/(m*I3)) */
    out[154] = t141;
    const double t142 = t50*t135; /* gyroscopic*R*I1/I3*1/(Theta/(m*I3)) */
    out[8] = t142;
    const double t143 = t50*t101; /* gyroscopic*b*1/(Theta/(m*I3))*1/s*1/s */
    const double t144 = t74*t101; /* (2*R*t73 + omega1*v1 + omega2*v2)*b*1/(Theta/(m*I3))*1/s*1/s */
    const double t145 = JLT_FNMA(p[1], t67, t144); /* (2*R*t73 + omega1*v1 + omega2*v2)*b*1/(Theta/(m*I3))*1/s*1/s - R*gyroscopic*1/(Theta/(m*I3))*1/s*1/s */
    const double t146 = t33*t135; /* q*R*I1/I3*1/(Theta/(m*I3)) */
    out[158] = t146;
    const double t147 = t93*t135; /* d(gyroscopic)/d(omega1)*R*I1/I3*1/(Theta/(m*I3)) */
    out[159] = t147;
    const double t148 = t94*t135; /* d(gyroscopic)/d(omega2)*R*I1/I3*1/(Theta/(m*I3)) */
    out[160] = t148;
    const double t149 = x[3]*x[9]; /* v1*alpha1 */
    const double t150 = JLT_FMA(x[4], x[10], t149); /* v2*alpha2 + v1*alpha1 */
    const double t151 = JLT_FMA(x[5], x[11], t150); /* v3*alpha3 + v2*alpha2 + v1*alpha1 */
    out[15] = t151;
    const double t152 = x[3]*x[12]; /* v1*beta1 */
    const double t153 = JLT_FMA(x[4], x[13], t152); /* v2*beta2 + v1*beta1 */
    const double t154 = JLT_FMA(x[5], x[14], t153); /* v3*beta3 + v2*beta2 + v1*beta1 */
    out[16] = t154;
    const double t155 = p[23]*t76; /* 2*I1*t76 */
    const double t156 = p[37]*t76; /* 2*m*a3*t76 */
    const double t157 = JLT_FMS(t115, t155, t66); /* gamma3*1/D*2*I1*t76 - (g - 1/D*t39) */
    out[104] = t157;
    const double t158 = x[1]*t109; /* gamma2*I1/m*1/(Theta/(m*I3))*1/s*1/s */
    const double t159 = x[0]*t109; /* gamma1*I1/m*1/(Theta/(m*I3))*1/s*1/s */
    const double t160 = JLT_FNMA(t59, t158, x[8]); /* omega3 - gamma3*omega2*gamma2*I1/m*1/(Theta/(m*I3))*1/s*1/s */
    out[72] = t160;
    const double t161 = JLT_FMS(t33, t158, x[7]); /* q*gamma2*I1/m*1/(Theta/(m*I3))*1/s*1/s - omega2 */
    out[73] = t161;
    const double t162 = JLT_FMS(t62, t159, x[8]); /* gamma3*omega1*gamma1*I1/m*1/(Theta/(m*I3))*1/s*1/s - omega3 */
    out[88] = t162;
    const double t163 = t59*t159; /* gamma3*omega2*gamma1*I1/m*1/(Theta/(m*I3))*1/s*1/s */
    out[89] = t163;
    const double t164 = t59*t135; /* gamma3*omega2*R*I1/I3*1/(Theta/(m*I3)) */
    const double t165 = -t164; /* -gamma3*omega2*R*I1/I3*1/(Theta/(m*I3)) */
    out[157] = t165;
    const double t166 = JLT_FNMA(t33, t159, x[6]); /* omega1 - q*gamma1*I1/m*1/(Theta/(m*I3))*1/s*1/s */
    out[90] = t166;
    const double t167 = p[19]*t33; /* a3*I3*q */
    const double t168 = t115*t167; /* gamma3*1/D*a3*I3*q */
    out[110] = t168;
    const double t169 = JLT_FMA(t115, t120, x[4]); /* gamma3*1/D*2*a3*I1*(gamma3*omega1 - 1/2*I3/I1*omega3*gamma1) + v2 */
    const double t170 = -t169; /* -t169 */
    out[108] = t170;
    const double t171 = t82*t114; /* t82*gamma2*1/D */
    const double t172 = t84*t114; /* t84*gamma2*1/D */
    const double t173 = t112*t114; /* 2*a3*I1*(gamma3*omega2 - 1/2*I3/I1*gamma2*omega3)*gamma2*1/D */
    const double t174 = JLT_FMA(t80, t112, x[5]); /* gamma1*1/D*2*a3*I1*(gamma3*omega2 - 1/2*I3/I1*gamma2*omega3) + v3 */
    const double t175 = JLT_FMS(t94, t158, t174); /* d(gyroscopic)/d(omega2)*gamma2*I1/m*1/(Theta/(m*I3))*1/s*1/s - t174 */
    out[75] = t175;
    const double t176 = JLT_FMA(t94, t159, t173); /* d(gyroscopic)/d(omega2)*gamma1*I1/m*1/(Theta/(m*I3))*1/s*1/s + 2*a3*I1*(gamma3*omega2 - 1/2*I3/I1*gamma2*omega3)*gamma2*1/D */
    const double t177 = -t176; /* -t176 */
    out[92] = t177;
    const double t178 = t114*t119; /* gamma2*1/D*2*m*a3^2*(gamma3*omega1 - 1/2*I3/I1*omega3*gamma1) */
    const double t179 = JLT_FMA(t93, t126, t178); /* d(gyroscopic)/d(omega1)*gamma1*b*1/(Theta/(m*I3))*1/s*1/s + t178 */
    const double t180 = -t179; /* -t179 */
    out[125] = t180;
    const double t181 = JLT_FMS(t80, t119, t79); /* gamma1*1/D*2*m*a3^2*(gamma3*omega1 - 1/2*I3/I1*omega3*gamma1) - omega3*(I1 - I3)/I1 */
    const double t182 = JLT_FNMA(t93, t130, t181); /* t181 - d(gyroscopic)/d(omega1)*gamma2*b*1/(Theta/(m*I3))*1/s*1/s */
    out[142] = t182;
    const double t183 = JLT_FNMA(t113, t114, t79); /* omega3*(I1 - I3)/I1 - 2*m*a3^2*(gamma3*omega2 - 1/2*I3/I1*gamma2*omega3)*gamma2*1/D */
    const double t184 = JLT_FNMA(t94, t126, t183); /* t183 - d(gyroscopic)/d(omega2)*gamma1*b*1/(Theta/(m*I3))*1/s*1/s */
    out[126] = t184;
    const double t185 = t80*t113; /* gamma1*1/D*2*m*a3^2*(gamma3*omega2 - 1/2*I3/I1*gamma2*omega3) */
    const double t186 = JLT_FNMA(t94, t130, t185); /* t185 - d(gyroscopic)/d(omega2)*gamma2*b*1/(Theta/(m*I3))*1/s*1/s */
    out[143] = t186;
    const double t187 = x[7]*p[13]; /* omega2*(I1 - I3)/I1 */
    const double t188 = p[29]*t33; /* m*a3^2*I3/I1*q */
    const double t189 = JLT_FMA(t114, t188, t187); /* gamma2*1/D*m*a3^2*I3/I1*q + omega2*(I1 - I3)/I1 */
    const double t190 = JLT_FMA(t51, t126, t189); /* (gamma3*2*R - I3/I1*b)*(gamma2*omega1 - omega2*gamma1)*gamma1*b*1/(Theta/(m*I3))*1/s*1/s + gamma2*1/D*m*a3^2*I3/I1*q + omega2*(I1 - I3)/I1 */
    out[127] = t190;
    const double t191 = t33*t126; /* q*gamma1*b*1/(Theta/(m*I3))*1/s*1/s */
    const double t192 = -t191; /* -q*gamma1*b*1/(Theta/(m*I3))*1/s*1/s */
    out[124] = t192;
    const double t193 = t33*t130; /* q*gamma2*b*1/(Theta/(m*I3))*1/s*1/s */
    const double t194 = -t193; /* -q*gamma2*b*1/(Theta/(m*I3))*1/s*1/s */
    out[141] = t194;
    const double t195 = x[6]*p[13]; /* omega1*(I1 - I3)/I1 */
    const double t196 = JLT_FMS(t51, t130, t195); /* (gamma3*2*R - I3/I1*b)*(gamma2*omega1 - omega2*gamma1)*gamma2*b*1/(Theta/(m*I3))*1/s*1/s - omega1*(I1 - I3)/I1 */
    const double t197 = JLT_FNMA(t80, t188, t196); /* t196 - gamma1*1/D*m*a3^2*I3/I1*q */
    out[144] = t197;
    const double t198 = x[8]*x[10]; /* omega3*alpha2 */
    const double t199 = JLT_FNMA(x[7], x[11], t198); /* omega3*alpha2 - omega2*alpha3 */
    out[9] = t199;
    const double t200 = x[6]*x[11]; /* omega1*alpha3 */
    const double t201 = JLT_FNMA(x[8], x[9], t200); /* omega1*alpha3 - omega3*alpha1 */
    out[10] = t201;
    const double t202 = x[7]*x[9]; /* omega2*alpha1 */
    const double t203 = JLT_FNMA(x[6], x[10], t202); /* omega2*alpha1 - omega1*alpha2 */
    out[11] = t203;
    const double t204 = x[8]*x[13]; /* omega3*beta2 */
    const double t205 = JLT_FNMA(x[7], x[14], t204); /* omega3*beta2 - omega2*beta3 */
    out[12] = t205;
    const double t206 = x[6]*x[14]; /* omega1*beta3 */
    const double t207 = JLT_FNMA(x[8], x[12], t206); /* omega1*beta3 - omega3*beta1 */
    out[13] = t207;
    const double t208 = x[7]*x[12]; /* omega2*beta1 */
    const double t209 = JLT_FNMA(x[6], x[13], t208); /* omega2*beta1 - omega1*beta2 */
    out[14] = t209;
    const double t210 = x[1]*p[32]; /* gamma2*2*I1/m */
    const double t211 = JLT_FMS(t80, t82, t66); /* gamma1*1/D*t82 - (g - 1/D*t39) */
    const double t212 = JLT_FNMA(t110, t210, t211); /* gamma1*1/D*t82 - (g - 1/D*t39) - t110*gamma2*2*I1/m */
    out[68] = t212;
    const double t213 = t172 - t66; /* t84*gamma2*1/D - (g - 1/D*t39) */
    const double t214 = JLT_FMA(p[14], t172, t71); /* m*a3/I1*t84*gamma2*1/D + m*a3/I1*1/D*t39 */
    const double t215 = JLT_FMA(t82, t104, t71); /* t82*m*a3/I1*gamma1*1/D + m*a3/I1*1/D*t39 */
    const double t216 = JLT_FMA(t84, t104, t143); /* t84*m*a3/I1*gamma1*1/D + gyroscopic*b*1/(Theta/(m*I3))*1/s*1/s */
    const double t217 = JLT_FMA(t80, t84, t121); /* gamma1*1/D*t84 + I1/m*gyroscopic*1/(Theta/(m*I3))*1/s*1/s */
    const double t218 = JLT_FNMA(t111, t210, t217); /* gamma1*1/D*t84 + I1/m*gyroscopic*1/(Theta/(m*I3))*1/s*1/s - t111*gamma2*2*I1/m */
    out[69] = t218;
    const double t219 = t171 - t121; /* t82*gamma2*1/D - I1/m*gyroscopic*1/(Theta/(m*I3))*1/s*1/s */
    const double t220 = JLT_FMS(p[14], t171, t143); /* m*a3/I1*t82*gamma2*1/D - gyroscopic*b*1/(Theta/(m*I3))*1/s*1/s */
    const double t221 = t80*t155; /* gamma1*1/D*2*I1*t76 */
    const double t222 = JLT_FNMA(t74, t158, t221); /* gamma1*1/D*2*I1*t76 - (2*R*t73 + omega1*v1 + omega2*v2)*gamma2*I1/m*1/(Theta/(m*I3))*1/s*1/s */
    out[70] = t222;
    const double t223 = t114*t155; /* gamma2*1/D*2*I1*t76 */
    const double t224 = JLT_FMA(t74, t159, t223); /* (2*R*t73 + omega1*v1 + omega2*v2)*gamma1*I1/m*1/(Theta/(m*I3))*1/s*1/s + gamma2*1/D*2*I1*t76 */
    out[87] = t224;
    const double t225 = t74*t135; /* (2*R*t73 + omega1*v1 + omega2*v2)*R*I1/I3*1/(Theta/(m*I3)) */
    const double t226 = -t225; /* -(2*R*t73 + omega1*v1 + omega2*v2)*R*I1/I3*1/(Theta/(m*I3)) */
    out[155] = t226;
    const double t227 = t62*t158; /* gamma3*omega1*gamma2*I1/m*1/(Theta/(m*I3))*1/s*1/s */
    const double t228 = -t227; /* -gamma3*omega1*gamma2*I1/m*1/(Theta/(m*I3))*1/s*1/s */
    out[71] = t228;
    const double t229 = t62*t135; /* gamma3*omega1*R*I1/I3*1/(Theta/(m*I3)) */
    const double t230 = -t229; /* -gamma3*omega1*R*I1/I3*1/(Theta/(m*I3)) */
    out[156] = t230;
    const double t231 = t51*t135; /* (gamma3*2*R - I3/I1*b)*(gamma2*omega1 - omega2*gamma1)*R*I1/I3*1/(Theta/(m*I3)) */
    const double t232 = -t231; /* -t231 */
    out[161] = t232;
    const double t233 = t80*t120; /* gamma1*1/D*2*a3*I1*(gamma3*omega1 - 1/2*I3/I1*omega3*gamma1) */
    const double t234 = JLT_FMS(t93, t158, t233); /* d(gyroscopic)/d(omega1)*gamma2*I1/m*1/(Theta/(m*I3))*1/s*1/s - gamma1*1/D*2*a3*I1*(gamma3*omega1 - 1/2*I3/I1*omega3*gamma1) */
    out[74] = t234;
    const double t235 = JLT_FNMA(t114, t120, x[5]); /* v3 - gamma2*1/D*2*a3*I1*(gamma3*omega1 - 1/2*I3/I1*omega3*gamma1) */
    const double t236 = JLT_FNMA(t93, t159, t235); /* t235 - d(gyroscopic)/d(omega1)*gamma1*I1/m*1/(Theta/(m*I3))*1/s*1/s */
    out[91] = t236;
    const double t237 = JLT_FMA(t80, t167, x[4]); /* gamma1*1/D*a3*I3*q + v2 */
    const double t238 = JLT_FNMA(t51, t158, t237); /* gamma1*1/D*a3*I3*q + v2 - (gamma3*2*R - I3/I1*b)*(gamma2*omega1 - omega2*gamma1)*gamma2*I1/m*1/(Theta/(m*I3))*1/s*1/s */
    out[76] = t238;
    const double t239 = JLT_FMS(t114, t167, x[3]); /* gamma2*1/D*a3*I3*q - v1 */
    const double t240 = JLT_FMA(t51, t159, t239); /* (gamma3*2*R - I3/I1*b)*(gamma2*omega1 - omega2*gamma1)*gamma1*I1/m*1/(Theta/(m*I3))*1/s*1/s + gamma2*1/D*a3*I3*q - v1 */
    out[93] = t240;
    const double t241 = t114*t156; /* gamma2*1/D*2*m*a3*t76 */
    const double t242 = t80*t156; /* gamma1*1/D*2*m*a3*t76 */
    const double t243 = JLT_FMA(x[0], t145, t241); /* gamma1*t145 + gamma2*1/D*2*m*a3*t76 */
    out[121] = t243;
    const double t244 = JLT_FMS(x[1], t145, t242); /* gamma2*t145 - gamma1*1/D*2*m*a3*t76 */
    out[138] = t244;
    const double t245 = x[0]*t110; /* gamma1*t110 */
    const double t246 = JLT_FMA(p[32], t245, t219); /* 2*I1/m*gamma1*t110 + t82*gamma2*1/D - I1/m*gyroscopic*1/(Theta/(m*I3))*1/s*1/s */
    out[85] = t246;
    const double t247 = JLT_FMA(t102, t245, t220); /* 2*b*gamma1*t110 + t220 */
    out[119] = t247;
    const double t248 = x[0]*t111; /* gamma1*t111 */
    const double t249 = JLT_FMA(p[32], t248, t213); /* 2*I1/m*gamma1*t111 + t84*gamma2*1/D - (g - 1/D*t39) */
    out[86] = t249;
    const double t250 = JLT_FMA(t102, t248, t214); /* 2*b*gamma1*t111 + m*a3/I1*t84*gamma2*1/D + m*a3/I1*1/D*t39 */
    out[120] = t250;
    const double t251 = x[1]*t102; /* gamma2*2*b */
    const double t252 = JLT_FMS(t110, t251, t215); /* t110*gamma2*2*b - (t82*m*a3/I1*gamma1*1/D + m*a3/I1*1/D*t39) */
    out[136] = t252;
    const double t253 = JLT_FMS(t111, t251, t216); /* t111*gamma2*2*b - t216 */
    out[137] = t253;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t1 = JLT_FMA(x[1], x[1], t0); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t2 = sqrt(t1); /* s = sqrt(gamma2*gamma2 + gamma1*gamma1) */
    const double t3 = JLT_FMA(p[1], x[2], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = JLT_FMA(t1, p[10], p[9]); /* (gamma2*gamma2 + gamma1*gamma1)*R^2*I1/I3 + I1/m */
    const double t5 = JLT_FMA(t3, t3, t4); /* Theta/(m*I3) = b*b + (gamma2*gamma2 + gamma1*gamma1)*R^2*I1/I3 + I1/m */
    const double t6 = x[2]*x[6]; /* gamma3*omega1 */
    const double t7 = p[36]*x[8]; /* 1/2*I3/I1*omega3 */
    const double t8 = JLT_FNMA(x[0], t7, t6); /* gamma3*omega1 - gamma1*1/2*I3/I1*omega3 */
    const double t9 = x[1]*t8; /* gamma2*(gamma3*omega1 - gamma1*1/2*I3/I1*omega3) */
    const double t10 = x[2]*x[7]; /* gamma3*omega2 */
    const double t11 = JLT_FNMA(x[1], t7, t10); /* gamma3*omega2 - gamma2*1/2*I3/I1*omega3 */
    const double t12 = JLT_FNMA(x[0], t11, t9); /* gamma2*(gamma3*omega1 - gamma1*1/2*I3/I1*omega3) - gamma1*(gamma3*omega2 - gamma2*1/2*I3/I1*omega3) */
    const double t13 = JLT_FMA(x[2], x[2], t1); /* one = gamma3*gamma3 + gamma2*gamma2 + gamma1*gamma1 */
    const double t14 = JLT_FMA(t1, p[28], t13); /* D/I1 = (gamma2*gamma2 + gamma1*gamma1)*m*a3^2/I1 + one */
    const double t15 = t5*t14; /* Theta/(m*I3)*D/I1 */
    const double t16 = t2*t15; /* s*Theta/(m*I3)*D/I1 */
    const double t17 = 1.0/t16; /* 1/(s*Theta/(m*I3)*D/I1) */
    const double t18 = p[40]*t5; /* 2*m*a3^2/I1*Theta/(m*I3) */
    const double t19 = t12*t18; /* t12*2*m*a3^2/I1*Theta/(m*I3) */
    const double t20 = t17*t19; /* 1/(s*Theta/(m*I3)*D/I1)*t12*2*m*a3^2/I1*Theta/(m*I3) */
    const double t21 = t14*t17; /* 1/(s*(Theta/(m*I3))) = D/I1*1/(s*Theta/(m*I3)*D/I1) */
    const double t22 = t5*t21; /* 1/s = Theta/(m*I3)*1/(s*(Theta/(m*I3))) */
    const double t23 = t22*t22; /* 1/s*1/s */
    const double t24 = x[1]*x[6]; /* gamma2*omega1 */
    const double t25 = JLT_FNMA(x[0], x[7], t24); /* gamma2*omega1 - gamma1*omega2 */
    const double t26 = JLT_FNMA(p[1], t25, x[5]); /* v3 - R*(gamma2*omega1 - gamma1*omega2) */
    const double t27 = x[1]*t26; /* gamma2*(v3 - R*(gamma2*omega1 - gamma1*omega2)) */
    const double t28 = x[2]*p[12]; /* gamma3*2*R */
    const double t29 = JLT_FNMA(t3, p[8], t28); /* gamma3*2*R - b*I3/I1 */
    const double t30 = x[8]*t29; /* omega3*(gamma3*2*R - b*I3/I1) */
    const double t31 = x[0]*x[6]; /* gamma1*omega1 */
    const double t32 = JLT_FMA(x[1], x[7], t31); /* q = gamma2*omega2 + gamma1*omega1 */
    const double t33 = JLT_FMA(p[1], t32, t30); /* R*q + omega3*(gamma3*2*R - b*I3/I1) */
    const double t34 = JLT_FNMA(x[2], x[4], t27); /* gamma2*(v3 - R*(gamma2*omega1 - gamma1*omega2)) - gamma3*v2 */
    const double t35 = JLT_FMA(x[0], t33, t34); /* d(gyroscopic)/d(omega2) = gamma1*(R*q + omega3*(gamma3*2*R - b*I3/I1)) + gamma2*(v3 - R*(gamma2*omega1 - gamma1*omega2)) - gamma3*v2 */
    const double t36 = x[1]*t35; /* gamma2*d(gyroscopic)/d(omega2) */
    const double t37 = x[0]*t26; /* gamma1*(v3 - R*(gamma2*omega1 - gamma1*omega2)) */
    const double t38 = JLT_FNMA(x[2], x[3], t37); /* gamma1*(v3 - R*(gamma2*omega1 - gamma1*omega2)) - gamma3*v1 */
    const double t39 = JLT_FNMA(x[1], t33, t38); /* d(gyroscopic)/d(omega1) = gamma1*(v3 - R*(gamma2*omega1 - gamma1*omega2)) - gamma3*v1 - gamma2*(R*q + omega3*(gamma3*2*R - b*I3/I1)) */
    const double t40 = JLT_FMA(x[0], t39, t36); /* gamma1*d(gyroscopic)/d(omega1) + gamma2*d(gyroscopic)/d(omega2) */
    const double t41 = t3*t40; /* b*t40 */
    const double t42 = t23*t41; /* 1/s*1/s*b*t40 */
    const double t43 = x[2]*t23; /* gamma3*1/s*1/s */
    const double t44 = JLT_FMA(t29, p[41], t43); /* (gamma3*2*R - b*I3/I1)*m*R/I3 + gamma3*1/s*1/s */
    const double t45 = p[9]*t25; /* I1/m*(gamma2*omega1 - gamma1*omega2) */
    const double t46 = JLT_FMA(t44, t45, t42); /* ((gamma3*2*R - b*I3/I1)*m*R/I3 + gamma3*1/s*1/s)*I1/m*(gamma2*omega1 - gamma1*omega2) + 1/s*1/s*b*t40 */
    const double t47 = JLT_FMA(t21, t46, t20); /* 1/(s*(Theta/(m*I3)))*t46 + 1/(s*Theta/(m*I3)*D/I1)*t12*2*m*a3^2/I1*Theta/(m*I3) */
    const double t48 = t2*t47; /* s*t47 */
    const double t49 = -t48; /* -s*t47 */
    out[0] = t49;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t1 = JLT_FMA(x[1], x[1], t0); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t2 = t1 - 1.0; /* gamma2*gamma2 + gamma1*gamma1 - 1 */
    const double t3 = JLT_FMA(x[2], x[2], t2); /* gamma3*gamma3 + gamma2*gamma2 + gamma1*gamma1 - 1 */
    out[0] = t3;
    const double t4 = JLT_FMS(x[9], x[9], 1.0); /* alpha1*alpha1 - 1 */
    const double t5 = JLT_FMA(x[10], x[10], t4); /* alpha2*alpha2 + alpha1*alpha1 - 1 */
    const double t6 = JLT_FMA(x[11], x[11], t5); /* alpha3*alpha3 + alpha2*alpha2 + alpha1*alpha1 - 1 */
    out[1] = t6;
    const double t7 = JLT_FMS(x[12], x[12], 1.0); /* beta1*beta1 - 1 */
    const double t8 = JLT_FMA(x[13], x[13], t7); /* beta2*beta2 + beta1*beta1 - 1 */
    const double t9 = JLT_FMA(x[14], x[14], t8); /* beta3*beta3 + beta2*beta2 + beta1*beta1 - 1 */
    out[2] = t9;
    const double t10 = x[0]*x[9]; /* gamma1*alpha1 */
    const double t11 = JLT_FMA(x[1], x[10], t10); /* gamma2*alpha2 + gamma1*alpha1 */
    const double t12 = JLT_FMA(x[2], x[11], t11); /* gamma3*alpha3 + gamma2*alpha2 + gamma1*alpha1 */
    out[3] = t12;
    const double t13 = x[0]*x[12]; /* gamma1*beta1 */
    const double t14 = JLT_FMA(x[1], x[13], t13); /* gamma2*beta2 + gamma1*beta1 */
    const double t15 = JLT_FMA(x[2], x[14], t14); /* gamma3*beta3 + gamma2*beta2 + gamma1*beta1 */
    out[4] = t15;
    const double t16 = x[9]*x[12]; /* alpha1*beta1 */
    const double t17 = JLT_FMA(x[10], x[13], t16); /* alpha2*beta2 + alpha1*beta1 */
    const double t18 = JLT_FMA(x[11], x[14], t17); /* alpha3*beta3 + alpha2*beta2 + alpha1*beta1 */
    out[5] = t18;
    const double t19 = x[0]*x[3]; /* gamma1*v1 */
    const double t20 = x[0]*x[7]; /* gamma1*omega2 */
    const double t21 = JLT_FNMA(x[1], x[6], t20); /* dgamma3 = gamma1*omega2 - gamma2*omega1 */
    const double t22 = JLT_FMA(x[1], x[4], t19); /* gamma2*v2 + gamma1*v1 */
    const double t23 = JLT_FMA(x[2], x[5], t22); /* gamma3*v3 + gamma2*v2 + gamma1*v1 */
    const double t24 = JLT_FNMA(p[3], t21, t23); /* gamma3*v3 + gamma2*v2 + gamma1*v1 - a3*dgamma3 */
    out[6] = t24;
    const double t25 = x[0]*x[4]; /* gamma1*v2 */
    const double t26 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t27 = x[0]*x[6]; /* gamma1*omega1 */
    const double t28 = JLT_FMA(x[1], x[7], t27); /* q = gamma2*omega2 + gamma1*omega1 */
    const double t29 = p[1]*x[8]; /* R*omega3 */
    const double t30 = JLT_FNMA(x[1], x[3], t25); /* gamma1*v2 - gamma2*v1 */
    const double t31 = JLT_FMA(t26, t28, t30); /* b*q + gamma1*v2 - gamma2*v1 */
    const double t32 = JLT_FNMA(t1, t29, t31); /* b*q + gamma1*v2 - gamma2*v1 - (gamma2*gamma2 + gamma1*gamma1)*R*omega3 */
    out[7] = t32;
    const double t33 = x[2]*p[8]; /* gamma3*I3/I1 */
    const double t34 = JLT_FMA(x[8], t33, t28); /* omega3*gamma3*I3/I1 + q */
    const double t35 = p[42]*t34; /* (-R*I1)*(omega3*gamma3*I3/I1 + q) */
    const double t36 = JLT_FMA(x[8], p[43], t35); /* omega3*(-a3*I3) + (-R*I1)*(omega3*gamma3*I3/I1 + q) */
    out[8] = t36;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[60] = x[0];
    out[80] = x[0];
    out[105] = x[0];
    out[123] = x[0];
    out[61] = x[1];
    out[81] = x[1];
    out[106] = x[1];
    out[62] = x[2];
    out[82] = x[2];
    out[107] = x[2];
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[29] = 0.0;
    out[30] = 0.0;
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = 0.0;
    out[40] = 0.0;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = 0.0;
    out[49] = 0.0;
    out[50] = 0.0;
    out[54] = 0.0;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = 0.0;
    out[63] = 0.0;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[71] = 0.0;
    out[72] = 0.0;
    out[73] = 0.0;
    out[74] = 0.0;
    out[75] = 0.0;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = 0.0;
    out[83] = 0.0;
    out[84] = 0.0;
    out[85] = 0.0;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = 0.0;
    out[90] = 0.0;
    out[91] = 0.0;
    out[92] = 0.0;
    out[93] = 0.0;
    out[100] = 0.0;
    out[101] = 0.0;
    out[110] = 0.0;
    out[111] = 0.0;
    out[112] = 0.0;
    out[113] = 0.0;
    out[114] = 0.0;
    out[115] = 0.0;
    out[116] = 0.0;
    out[117] = 0.0;
    out[118] = 0.0;
    out[124] = 0.0;
    out[128] = 0.0;
    out[129] = 0.0;
    out[130] = 0.0;
    out[131] = 0.0;
    out[132] = 0.0;
    out[133] = 0.0;
    out[134] = 0.0;
    out[135] = 0.0;
    out[139] = 0.0;
    out[140] = 0.0;
    out[141] = 0.0;
    out[145] = 0.0;
    out[146] = 0.0;
    out[147] = 0.0;
    out[148] = 0.0;
    out[149] = 0.0;
    out[150] = 0.0;
    out[151] = 0.0;
    out[152] = 0.0;
    out[51] = x[9];
    out[97] = x[9];
    out[52] = x[10];
    out[98] = x[10];
    out[53] = x[11];
    out[99] = x[11];
    out[68] = x[12];
    out[94] = x[12];
    out[69] = x[13];
    out[95] = x[13];
    out[70] = x[14];
    out[96] = x[14];
    out[104] = x[5];
    const double t0 = 2.0*x[0]; /* 2*gamma1 */
    out[0] = t0;
    const double t1 = 2.0*x[1]; /* 2*gamma2 */
    out[1] = t1;
    const double t2 = 2.0*x[2]; /* 2*gamma3 */
    out[2] = t2;
    const double t3 = 2.0*x[9]; /* 2*alpha1 */
    out[26] = t3;
    const double t4 = 2.0*x[10]; /* 2*alpha2 */
    out[27] = t4;
    const double t5 = 2.0*x[11]; /* 2*alpha3 */
    out[28] = t5;
    const double t6 = 2.0*x[12]; /* 2*beta1 */
    out[46] = t6;
    const double t7 = 2.0*x[13]; /* 2*beta2 */
    out[47] = t7;
    const double t8 = 2.0*x[14]; /* 2*beta3 */
    out[48] = t8;
    const double t9 = JLT_FNMA(p[3], x[7], x[3]); /* v1 - a3*omega2 */
    out[102] = t9;
    const double t10 = JLT_FMA(p[3], x[6], x[4]); /* a3*omega1 + v2 */
    out[103] = t10;
    const double t11 = x[1]*p[3]; /* gamma2*a3 */
    out[108] = t11;
    const double t12 = x[0]*p[44]; /* gamma1*(-a3) */
    out[109] = t12;
    const double t13 = -x[1]; /* -gamma2 */
    out[122] = t13;
    const double t14 = x[6]*p[42]; /* omega1*(-R*I1) */
    out[136] = t14;
    const double t15 = x[7]*p[42]; /* omega2*(-R*I1) */
    out[137] = t15;
    const double t16 = x[8]*p[47]; /* omega3*(-R*I3) */
    out[138] = t16;
    const double t17 = x[0]*p[42]; /* gamma1*(-R*I1) */
    out[142] = t17;
    const double t18 = x[1]*p[42]; /* gamma2*(-R*I1) */
    out[143] = t18;
    const double t19 = x[2] + p[45]; /* gamma3 + a3/R */
    const double t20 = p[47]*t19; /* (-R*I3)*(gamma3 + a3/R) */
    out[144] = t20;
    const double t21 = p[1]*t19; /* b = R*(gamma3 + a3/R) */
    const double t22 = x[0]*t21; /* gamma1*b */
    out[125] = t22;
    const double t23 = x[1]*t21; /* gamma2*b */
    out[126] = t23;
    const double t24 = p[12]*x[8]; /* 2*R*omega3 */
    const double t25 = x[0]*x[6]; /* gamma1*omega1 */
    const double t26 = JLT_FMA(x[1], x[7], t25); /* q = gamma2*omega2 + gamma1*omega1 */
    const double t27 = p[1]*t26; /* R*q */
    out[121] = t27;
    const double t28 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t29 = JLT_FMA(x[1], x[1], t28); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t30 = p[46]*t29; /* (-R)*(gamma2*gamma2 + gamma1*gamma1) */
    out[127] = t30;
    const double t31 = JLT_FNMA(x[0], t24, x[4]); /* v2 - gamma1*2*R*omega3 */
    const double t32 = JLT_FMA(x[6], t21, t31); /* omega1*b + v2 - gamma1*2*R*omega3 */
    out[119] = t32;
    const double t33 = JLT_FMA(x[1], t24, x[3]); /* gamma2*2*R*omega3 + v1 */
    const double t34 = JLT_FMS(x[7], t21, t33); /* omega2*b - (gamma2*2*R*omega3 + v1) */
    out[120] = t34;
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
    double x6[JLT_JET_ORDER_MAX + 1];
    double x7[JLT_JET_ORDER_MAX + 1];
    double x8[JLT_JET_ORDER_MAX + 1];
    double x9[JLT_JET_ORDER_MAX + 1];
    double x10[JLT_JET_ORDER_MAX + 1];
    double x11[JLT_JET_ORDER_MAX + 1];
    double x12[JLT_JET_ORDER_MAX + 1];
    double x13[JLT_JET_ORDER_MAX + 1];
    double x14[JLT_JET_ORDER_MAX + 1];
    double x15[JLT_JET_ORDER_MAX + 1];
    double x16[JLT_JET_ORDER_MAX + 1];
    double t2[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
    double t68[JLT_JET_ORDER_MAX + 1];
    double t69[JLT_JET_ORDER_MAX + 1];
    double t70[JLT_JET_ORDER_MAX + 1];
    double t71[JLT_JET_ORDER_MAX + 1];
    double t72[JLT_JET_ORDER_MAX + 1];
    double t73[JLT_JET_ORDER_MAX + 1];
    double t74[JLT_JET_ORDER_MAX + 1];
    double t75[JLT_JET_ORDER_MAX + 1];
    double t76[JLT_JET_ORDER_MAX + 1];
    double t77[JLT_JET_ORDER_MAX + 1];
    double t78[JLT_JET_ORDER_MAX + 1];
    double t79[JLT_JET_ORDER_MAX + 1];
    double t80[JLT_JET_ORDER_MAX + 1];
    double t82[JLT_JET_ORDER_MAX + 1];
    double t83[JLT_JET_ORDER_MAX + 1];
    double t85[JLT_JET_ORDER_MAX + 1];
    double t86[JLT_JET_ORDER_MAX + 1];
    double t87[JLT_JET_ORDER_MAX + 1];
    double t88[JLT_JET_ORDER_MAX + 1];
    double t89[JLT_JET_ORDER_MAX + 1];
    double t90[JLT_JET_ORDER_MAX + 1];
    double t91[JLT_JET_ORDER_MAX + 1];
    double t93[JLT_JET_ORDER_MAX + 1];
    double t95[JLT_JET_ORDER_MAX + 1];
    double t97[JLT_JET_ORDER_MAX + 1];
    double t98[JLT_JET_ORDER_MAX + 1];
    double t100[JLT_JET_ORDER_MAX + 1];
    double t101[JLT_JET_ORDER_MAX + 1];
    double t102[JLT_JET_ORDER_MAX + 1];
    double t104[JLT_JET_ORDER_MAX + 1];
    double t106[JLT_JET_ORDER_MAX + 1];
    double t107[JLT_JET_ORDER_MAX + 1];
    double t109[JLT_JET_ORDER_MAX + 1];
    double t110[JLT_JET_ORDER_MAX + 1];
    double t111[JLT_JET_ORDER_MAX + 1];
    double t112[JLT_JET_ORDER_MAX + 1];
    double t113[JLT_JET_ORDER_MAX + 1];
    double t114[JLT_JET_ORDER_MAX + 1];
    double t115[JLT_JET_ORDER_MAX + 1];
    double t116[JLT_JET_ORDER_MAX + 1];
    double t117[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = x6[0] = x[6];
    coefficients[7] = x7[0] = x[7];
    coefficients[8] = x8[0] = x[8];
    coefficients[9] = x9[0] = x[9];
    coefficients[10] = x10[0] = x[10];
    coefficients[11] = x11[0] = x[11];
    coefficients[12] = x12[0] = x[12];
    coefficients[13] = x13[0] = x[13];
    coefficients[14] = x14[0] = x[14];
    coefficients[15] = x15[0] = x[15];
    coefficients[16] = x16[0] = x[16];
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x1, x8, k);
        t5[k] = t2[k] - jlt_jet_product(x2, x7, k);
        t7[k] = jlt_jet_product(x2, x6, k);
        t9[k] = t7[k] - jlt_jet_product(x8, x0, k);
        t10[k] = jlt_jet_product(x1, x6, k);
        t11[k] = jlt_jet_product(x7, x0, k);
        t12[k] = t10[k] - t11[k];
        t13[k] = t11[k] - t10[k];
        t15[k] = jlt_jet_product(x8, x4, k);
        t18[k] = jlt_jet_product(x0, x0, k);
        t19[k] = jlt_jet_product(x1, x1, k) + t18[k];
        t20[k] = jlt_jet_root(t19[k], t20, k);
        t22[k] = jlt_jet_product(x2, x2, k) + t19[k];
        t23[k] = p[6]*t22[k];
        t25[k] = jlt_jet_product(x6, x6, k);
        t26[k] = jlt_jet_product(x7, x7, k) + t25[k];
        t27[k] = jlt_jet_product(x2, t26, k);
        t29[k] = jlt_jet_product(x6, x0, k);
        t30[k] = jlt_jet_product(x1, x7, k) + t29[k];
        t31[k] = x8[k]*p[8];
        t32[k] = t27[k] - jlt_jet_product(t30, t31, k);
        t33[k] = t23[k] - p[7]*t32[k];
        t38[k] = x2[k]*p[1] + (k == 0 ? p[3] : 0);
        t39[k] = t19[k]*p[10] + (k == 0 ? p[9] : 0);
        t40[k] = jlt_jet_product(t38, t38, k) + t39[k];
        t42[k] = t22[k]*p[4];
        t44[k] = t19[k]*p[11] + t42[k];
        t45[k] = jlt_jet_product(t20, t44, k);
        t46[k] = jlt_jet_product(t40, t45, k);
        t48[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t46, t48, k);
        t49[k] = jlt_jet_product(t40, t48, k);
        t50[k] = jlt_jet_product(t20, t33, k);
        t51[k] = jlt_jet_product(t49, t50, k);
        t52[k] = (k == 0 ? p[2] : 0) - t51[k];
        t53[k] = jlt_jet_product(x5, t30, k);
        t55[k] = x2[k]*p[12];
        t56[k] = t55[k] - p[8]*t38[k];
        t57[k] = jlt_jet_product(x8, t56, k);
        t58[k] = t30[k]*p[1] + t57[k];
        t60[k] = jlt_jet_product(x6, x3, k);
        t61[k] = jlt_jet_product(x7, x4, k) + t60[k];
        t62[k] = t53[k] - jlt_jet_product(x2, t61, k);
        t63[k] = t62[k] - jlt_jet_product(t12, t58, k);
        t64[k] = jlt_jet_product(t45, t63, k);
        t65[k] = jlt_jet_product(t48, t64, k);
        t66[k] = jlt_jet_product(t44, t49, k);
        t67[k] = jlt_jet_product(t65, t66, k);
        t68[k] = jlt_jet_product(t66, t67, k);
        t69[k] = jlt_jet_product(x1, t68, k);
        t70[k] = t15[k] - jlt_jet_product(x7, x5, k);
        t71[k] = t70[k] - jlt_jet_product(x0, t52, k);
        t72[k] = p[9]*t69[k] + t71[k];
        t73[k] = jlt_jet_product(x6, x5, k);
        t74[k] = jlt_jet_product(x0, t68, k);
        t75[k] = t73[k] - jlt_jet_product(x8, x3, k);
        t76[k] = t75[k] - jlt_jet_product(x1, t52, k);
        t77[k] = t76[k] - p[9]*t74[k];
        t78[k] = jlt_jet_product(x7, x3, k);
        t79[k] = t78[k] - jlt_jet_product(x6, x4, k);
        t80[k] = t79[k] - jlt_jet_product(x2, t52, k);
        t82[k] = x8[k]*p[13];
        t83[k] = jlt_jet_product(x7, t82, k);
        t85[k] = t51[k]*p[14];
        t86[k] = jlt_jet_product(x1, t85, k) + t83[k];
        t87[k] = t86[k] - jlt_jet_product(t38, t74, k);
        t88[k] = jlt_jet_product(x6, t82, k);
        t89[k] = jlt_jet_product(x0, t85, k) + t88[k];
        t90[k] = jlt_jet_product(t38, t69, k) + t89[k];
        t91[k] = -t90[k];
        t93[k] = t65[k]*p[15];
        t95[k] = jlt_jet_product(x8, x10, k);
        t97[k] = t95[k] - jlt_jet_product(x7, x11, k);
        t98[k] = jlt_jet_product(x6, x11, k);
        t100[k] = t98[k] - jlt_jet_product(x8, x9, k);
        t101[k] = jlt_jet_product(x7, x9, k);
        t102[k] = t101[k] - jlt_jet_product(x6, x10, k);
        t104[k] = jlt_jet_product(x8, x13, k);
        t106[k] = t104[k] - jlt_jet_product(x7, x14, k);
        t107[k] = jlt_jet_product(x6, x14, k);
        t109[k] = t107[k] - jlt_jet_product(x8, x12, k);
        t110[k] = jlt_jet_product(x7, x12, k);
        t111[k] = t110[k] - jlt_jet_product(x6, x13, k);
        t112[k] = jlt_jet_product(x3, x9, k);
        t113[k] = jlt_jet_product(x4, x10, k) + t112[k];
        t114[k] = jlt_jet_product(x5, x11, k) + t113[k];
        t115[k] = jlt_jet_product(x3, x12, k);
        t116[k] = jlt_jet_product(x4, x13, k) + t115[k];
        t117[k] = jlt_jet_product(x5, x14, k) + t116[k];
        double *restrict next = coefficients + (k + 1)*17;
        next[0] = x0[k + 1] = t5[k]/(k + 1);
        next[1] = x1[k + 1] = t9[k]/(k + 1);
        next[2] = x2[k + 1] = t13[k]/(k + 1);
        next[3] = x3[k + 1] = t72[k]/(k + 1);
        next[4] = x4[k + 1] = t77[k]/(k + 1);
        next[5] = x5[k + 1] = t80[k]/(k + 1);
        next[6] = x6[k + 1] = t87[k]/(k + 1);
        next[7] = x7[k + 1] = t91[k]/(k + 1);
        next[8] = x8[k + 1] = t93[k]/(k + 1);
        next[9] = x9[k + 1] = t97[k]/(k + 1);
        next[10] = x10[k + 1] = t100[k]/(k + 1);
        next[11] = x11[k + 1] = t102[k]/(k + 1);
        next[12] = x12[k + 1] = t106[k]/(k + 1);
        next[13] = x13[k + 1] = t109[k]/(k + 1);
        next[14] = x14[k + 1] = t111[k]/(k + 1);
        next[15] = x15[k + 1] = t114[k]/(k + 1);
        next[16] = x16[k + 1] = t117[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_gamma2 = x[1];
    const double complex v_omega3 = x[8];
    const double complex v_gamma3 = x[2];
    const double complex v_omega2 = x[7];
    out[0] = (v_gamma2*v_omega3)
        + (-v_gamma3*v_omega2);
    const double complex v_omega1 = x[6];
    const double complex v_gamma1 = x[0];
    out[1] = (v_gamma3*v_omega1)
        + (-v_gamma1*v_omega3);
    out[2] = (v_gamma1*v_omega2)
        + (-v_gamma2*v_omega1);
    const double complex v_v2 = x[4];
    const double complex v_v3 = x[5];
    const double v_g = params[2];
    const double v_I1 = params[4];
    const double complex v_one = (v_gamma1*v_gamma1 + v_gamma2*v_gamma2 + v_gamma3*v_gamma3);
    const double v_m = params[0];
    const double v_a3 = params[3];
    const double complex v_s = csqrt(v_gamma1*v_gamma1 + v_gamma2*v_gamma2);
    const double complex v_D = (v_I1*v_one + v_m*v_a3*v_a3*v_s*v_s);
    const double v_I3 = params[5];
    const double complex v_q = (v_gamma1*v_omega1 + v_gamma2*v_omega2);
    const double complex v_N_m = ((v_g*v_I1*v_one - v_a3*(v_I1*v_gamma3*(v_omega1*v_omega1 + v_omega2*v_omega2) - v_I3*v_omega3*v_q))/v_D);
    const double v_R = params[1];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v1 = x[3];
    const double complex v_dgamma3 = (v_gamma1*v_omega2 - v_gamma2*v_omega1);
    const double complex v_gyroscopic = (v_v3*v_q - v_gamma3*(v_v1*v_omega1 + v_v2*v_omega2) + v_R*v_dgamma3*v_q + v_omega3*v_dgamma3*(2.0*v_R*v_gamma3 - v_I3*v_b/v_I1));
    const double complex v_L_ms = (-v_I1*v_I3*v_gyroscopic/(v_s*v_s*v_Theta));
    out[3] = (v_v2*v_omega3)
        + (-v_v3*v_omega2)
        + (-v_g*v_gamma1)
        + (v_gamma1*v_N_m)
        + (-v_gamma2*v_L_ms);
    out[4] = (v_v3*v_omega1)
        + (-v_v1*v_omega3)
        + (-v_g*v_gamma2)
        + (v_gamma2*v_N_m)
        + (v_gamma1*v_L_ms);
    out[5] = (v_v1*v_omega2)
        + (-v_v2*v_omega1)
        + (-v_g*v_gamma3)
        + (v_gamma3*v_N_m);
    out[6] = (v_omega2*v_omega3*(v_I1 - v_I3)/v_I1)
        + (v_m*v_a3*v_gamma2*v_N_m/v_I1)
        + (v_m*v_gamma1*v_b*v_L_ms/v_I1);
    out[7] = (-v_omega1*v_omega3*(v_I1 - v_I3)/v_I1)
        + (-v_m*v_a3*v_gamma1*v_N_m/v_I1)
        + (v_m*v_gamma2*v_b*v_L_ms/v_I1);
    out[8] = (-v_m*v_R*v_s*v_s*v_L_ms/v_I3);
    const double complex v_alpha2 = x[10];
    const double complex v_alpha3 = x[11];
    out[9] = (v_omega3*v_alpha2)
        + (-v_omega2*v_alpha3);
    const double complex v_alpha1 = x[9];
    out[10] = (v_omega1*v_alpha3)
        + (-v_omega3*v_alpha1);
    out[11] = (v_omega2*v_alpha1)
        + (-v_omega1*v_alpha2);
    const double complex v_beta2 = x[13];
    const double complex v_beta3 = x[14];
    out[12] = (v_omega3*v_beta2)
        + (-v_omega2*v_beta3);
    const double complex v_beta1 = x[12];
    out[13] = (v_omega1*v_beta3)
        + (-v_omega3*v_beta1);
    out[14] = (v_omega2*v_beta1)
        + (-v_omega1*v_beta2);
    out[15] = (v_v1*v_alpha1)
        + (v_v2*v_alpha2)
        + (v_v3*v_alpha3);
    out[16] = (v_v1*v_beta1)
        + (v_v2*v_beta2)
        + (v_v3*v_beta3);
}

static const jlt_quantity states[] = {
    { "gamma1", "1", "vertical unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "gamma2", "1", "vertical unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "gamma3", "1", "vertical unit vector in the body frame: cosine of the tilt", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v1", "m/s", "velocity of the centre of mass", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v2", "m/s", "velocity of the centre of mass", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v3", "m/s", "velocity of the centre of mass", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega1", "rad/s", "angular velocity", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega2", "rad/s", "angular velocity", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "alpha1", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "alpha2", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "alpha3", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "beta1", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "beta2", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "beta3", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "x", "m", "horizontal coordinate of the centre of mass along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "y", "m", "horizontal coordinate of the centre of mass along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
};

static const jlt_named integrals[] = {
    { "gamma_norm", "" },
    { "alpha_norm", "" },
    { "beta_norm", "" },
    { "alpha_gamma", "" },
    { "beta_gamma", "" },
    { "alpha_beta", "" },
    { "f1", "" },
    { "f2", "" },
    { "G", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_full_general = {
    .model = "spherical_top_full",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top on a plane with one nonholonomic constraint, full system with multipliers",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (2.5)-(2.7)",
    .sha256 = "dc0d20f6ac74946b7b13744f3256847225086e5aac3162d5df985f3f2d8747c2",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_full,
    .state_count = 17, .param_count = 6, .block_count = 48,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 17, { 4, 43, 39, 1, 1, 0, 15, 13 }, { 60, 153, 0, 13, 1, 0, 10, 15 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 289, { 27, 107, 80, 1, 1, 0, 17, 38 }, { 257, 1113, 0, 139, 1, 0, 15, 23 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 306, { 30, 119, 103, 1, 1, 0, 18, 37 }, { 303, 1231, 0, 151, 1, 0, 15, 23 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 1, 25, 22, 1, 1, 0, 16, 12 }, { 28, 97, 0, 10, 1, 0, 15, 14 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 9, { 1, 11, 25, 0, 0, 0, 5, 6 }, { 28, 41, 0, 0, 1, 0, 7, 6 },
        "takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 153, { 2, 25, 8, 0, 0, 0, 3, 4 }, { 19, 44, 0, 0, 1, 0, 6, 4 },
        "takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 9, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_full_general_baseline,
        &jlt_batch_spherical_top_full_general_avx2,
        &jlt_batch_spherical_top_full_general_avx512,
    },
};
