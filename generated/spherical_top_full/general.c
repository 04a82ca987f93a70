/* Spherical top on a plane with one nonholonomic constraint, full system with multipliers
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (2.5)-(2.7)
 *  Table:      spherical_top_full, SHA-256 dc0d20f6ac74946b7b13744f3256847225086e5aac3162d5df985f3f2d8747c2
 *  Command:    ttc generate --out DIR spherical_top_full.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   46   39    1    1    0     15   15   (227)
 *  jacobian            30  118   83    1    1    0     18   40   (1510)
 *  rhs_jacobian        33  133  108    1    1    0     19   44   (1686)
 *  divergence          0   30   22    1    1    0     15   11   (136)
 *  integral_values     1   12   25    0    0    0      6    6   (70)
 *  integral_gradients  2   25    8    0    0    0      3    5   (64)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes.
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
    const double t1 = params[4]*params[5]; /* I1*I3 */
    const double t2 = params[1]*params[1]; /* R*R */
    const double t3 = params[0]*t2; /* m*R*R */
    const double t4 = params[4]*t3; /* I1*m*R*R */
    const double t5 = params[5]*params[0]; /* I3*m */
    const double t6 = params[3]*params[3]; /* a3*a3 */
    const double t7 = params[0]*t6; /* m*a3*a3 */
    const double t8 = params[1]*2.0; /* R*2 */
    const double t9 = params[5]/params[4]; /* I3/I1 */
    const double t10 = params[4] - params[5]; /* I1 - I3 */
    const double t11 = t10/params[4]; /* (I1 - I3)/I1 */
    const double t12 = params[0]*params[3]; /* m*a3 */
    const double t13 = t12/params[4]; /* m*a3/I1 */
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = params[4]*t14; /* I1*m*R */
    const double t16 = params[4]*2.0; /* I1*2 */
    const double t17 = t7*2.0; /* m*a3*a3*2 */
    const double t18 = t16 + t17; /* I1*2 + m*a3*a3*2 */
    const double t19 = params[2]*2.0; /* g*2 */
    const double t20 = params[4]*t19; /* I1*g*2 */
    const double t21 = params[5]*params[3]; /* I3*a3 */
    const double t22 = params[5]*t16; /* I3*I1*2 */
    const double t23 = 1.0/t16; /* 1/(I1*2) */
    const double t24 = params[4]*params[3]; /* I1*a3 */
    const double t25 = params[0]*2.0; /* m*2 */
    const double t26 = params[1]*t25; /* R*m*2 */
    const double t27 = params[4]*t26; /* I1*R*m*2 */
    const double t28 = params[5]*params[5]; /* I3*I3 */
    const double t29 = t27*t28; /* I1*R*m*2*I3*I3 */
    const double t30 = params[5]*t26; /* I3*R*m*2 */
    const double t31 = 1.0/t30; /* 1/(I3*R*m*2) */
    const double t32 = params[5]*params[1]; /* I3*R */
    const double t33 = t32/params[4]; /* I3*R/I1 */
    const double t34 = t8 - t33; /* R*2 - I3*R/I1 */
    const double t35 = params[5]*t25; /* I3*m*2 */
    const double t36 = params[3]*t25; /* a3*m*2 */
    const double t37 = params[0]*params[0]; /* m*m */
    const double t38 = 2.0*t37; /* 2*m*m */
    const double t39 = params[1]*t38; /* R*2*m*m */
    const double t40 = t28*t39; /* I3*I3*R*2*m*m */
    const double t41 = 1.0/t35; /* 1/(I3*m*2) */
    const double t42 = t7/params[4]; /* m*a3*a3/I1 */
    const double t43 = params[5]*t7; /* I3*m*a3*a3 */
    const double t44 = t43/params[4]; /* I3*m*a3*a3/I1 */
    const double t45 = params[1]*t2; /* R*R*R */
    const double t46 = t38*t45; /* 2*m*m*R*R*R */
    const double t47 = params[4]*params[4]; /* I1*I1 */
    const double t48 = t46*t47; /* 2*m*m*R*R*R*I1*I1 */
    const double t49 = t2*t38; /* R*R*2*m*m */
    const double t50 = params[4]*t49; /* I1*R*R*2*m*m */
    const double t51 = params[5]*t50; /* I3*I1*R*R*2*m*m */
    const double t52 = -t1; /* -I1*I3 */
    const double t53 = params[0]/params[4]; /* m/I1 */
    const double t54 = t14/params[5]; /* m*R/I3 */
    const double t55 = -t42; /* -m*a3*a3/I1 */
    const double t56 = -params[1]; /* -R */
    const double t57 = -params[3]; /* -a3 */
    const double t58 = -t21; /* -I3*a3 */
    const double t59 = params[3]/params[1]; /* a3/R */
    const double t60 = params[4]*params[1]; /* I1*R */
    const double t61 = -t60; /* -I1*R */
    const double t62 = -t32; /* -I3*R */
    out[6] = t0;
    out[7] = t1;
    out[8] = t4;
    out[9] = t5;
    out[10] = t7;
    out[11] = t8;
    out[12] = t9;
    out[13] = t11;
    out[14] = t13;
    out[15] = t15;
    out[16] = t18;
    out[17] = t20;
    out[18] = t21;
    out[19] = t22;
    out[20] = t16;
    out[21] = t23;
    out[22] = t24;
    out[23] = t29;
    out[24] = t31;
    out[25] = t34;
    out[26] = t35;
    out[27] = t36;
    out[28] = t40;
    out[29] = t41;
    out[30] = t42;
    out[31] = t44;
    out[32] = t48;
    out[33] = t51;
    out[34] = t52;
    out[35] = t53;
    out[36] = t54;
    out[37] = t55;
    out[38] = t56;
    out[39] = t58;
    out[40] = t57;
    out[41] = t59;
    out[42] = t61;
    out[43] = t62;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[8]; /* gamma2*omega3 */
    const double t1 = JLT_FNMA(x[2], x[7], t0); /* gamma2*omega3 - gamma3*omega2 */
    const double t2 = x[2]*x[6]; /* gamma3*omega1 */
    const double t3 = JLT_FNMA(x[8], x[0], t2); /* gamma3*omega1 - omega3*gamma1 */
    const double t4 = x[1]*x[6]; /* gamma2*omega1 */
    const double t5 = x[7]*x[0]; /* omega2*gamma1 */
    const double t6 = t4 - t5; /* gamma2*omega1 - omega2*gamma1 */
    const double t7 = t5 - t4; /* omega2*gamma1 - gamma2*omega1 */
    const double t8 = x[8]*x[4]; /* omega3*v2 */
    const double t9 = x[1]*x[1]; /* gamma2*gamma2 */
    const double t10 = JLT_FMA(x[0], x[0], t9); /* gamma1*gamma1 + gamma2*gamma2 */
    const double t11 = sqrt(t10); /* s = sqrt(gamma1*gamma1 + gamma2*gamma2) */
    const double t12 = JLT_FMA(x[2], x[2], t10); /* one = gamma3*gamma3 + gamma1*gamma1 + gamma2*gamma2 */
    const double t13 = p[6]*t12; /* g*I1*one */
    const double t14 = x[6]*x[6]; /* omega1*omega1 */
    const double t15 = JLT_FMA(x[7], x[7], t14); /* omega2*omega2 + omega1*omega1 */
    const double t16 = x[2]*p[4]; /* gamma3*I1 */
    const double t17 = t15*t16; /* (omega2*omega2 + omega1*omega1)*gamma3*I1 */
    const double t18 = x[6]*x[0]; /* omega1*gamma1 */
    const double t19 = JLT_FMA(x[1], x[7], t18); /* q = gamma2*omega2 + omega1*gamma1 */
    const double t20 = x[8]*p[5]; /* omega3*I3 */
    const double t21 = JLT_FNMA(t19, t20, t17); /* (omega2*omega2 + omega1*omega1)*gamma3*I1 - q*omega3*I3 */
    const double t22 = JLT_FNMA(p[3], t21, t13); /* g*I1*one - a3*((omega2*omega2 + omega1*omega1)*gamma3*I1 - q*omega3*I3) */
    const double t23 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t24 = t23*p[9]; /* b*m*I3 */
    const double t25 = JLT_FMA(t10, p[8], p[7]); /* (gamma1*gamma1 + gamma2*gamma2)*m*R^2*I1 + I1*I3 */
    const double t26 = JLT_FMA(t23, t24, t25); /* Theta = b*b*m*I3 + (gamma1*gamma1 + gamma2*gamma2)*m*R^2*I1 + I1*I3 */
    const double t27 = t12*p[4]; /* one*I1 */
    const double t28 = JLT_FMA(t10, p[10], t27); /* D = (gamma1*gamma1 + gamma2*gamma2)*m*a3^2 + one*I1 */
    const double t29 = t26*t28; /* Theta*D */
    const double t30 = t11*t29; /* s*Theta*D */
    const double t31 = 1.0/t30; /* 1/(s*Theta*D) */
    const double t32 = t26*t31; /* Theta*1/(s*Theta*D) */
    const double t33 = t11*t22; /* s*t22 */
    const double t34 = t32*t33; /* Theta*1/(s*Theta*D)*s*t22 */
    const double t35 = p[2] - t34; /* g - Theta*1/(s*Theta*D)*s*t22 */
    const double t36 = x[5]*t19; /* v3*q */
    const double t37 = x[6]*x[3]; /* omega1*v1 */
    const double t38 = JLT_FMA(x[7], x[4], t37); /* omega2*v2 + omega1*v1 */
    const double t39 = x[2]*p[11]; /* gamma3*2*R */
    const double t40 = JLT_FNMA(t23, p[12], t39); /* gamma3*2*R - b*I3/I1 */
    const double t41 = x[8]*t40; /* omega3*(gamma3*2*R - b*I3/I1) */
    const double t42 = JLT_FMA(t19, p[1], t41); /* q*R + omega3*(gamma3*2*R - b*I3/I1) */
    const double t43 = JLT_FNMA(x[2], t38, t36); /* v3*q - gamma3*(omega2*v2 + omega1*v1) */
    const double t44 = JLT_FNMA(t6, t42, t43); /* gyroscopic = v3*q - gamma3*(omega2*v2 + omega1*v1) - (gamma2*omega1 - omega2*gamma1)*(q*R + omega3*(gamma3*2*R - b*I3/I1)) */
    const double t45 = t11*t28; /* s*D */
    const double t46 = t44*t45; /* gyroscopic*s*D */
    const double t47 = t31*t46; /* 1/(s*Theta*D)*gyroscopic*s*D */
    const double t48 = t28*t32; /* D*Theta*1/(s*Theta*D) */
    const double t49 = t47*t48; /* 1/(s*Theta*D)*gyroscopic*s*D*D*Theta*1/(s*Theta*D) */
    const double t50 = t48*t49; /* D*Theta*1/(s*Theta*D)*1/(s*Theta*D)*gyroscopic*s*D*D*Theta*1/(s*Theta*D) */
    const double t51 = x[1]*t50; /* gamma2*t50 */
    const double t52 = JLT_FNMA(x[7], x[5], t8); /* omega3*v2 - omega2*v3 */
    const double t53 = JLT_FNMA(x[0], t35, t52); /* omega3*v2 - omega2*v3 - gamma1*(g - Theta*1/(s*Theta*D)*s*t22) */
    const double t54 = JLT_FMA(p[7], t51, t53); /* I1*I3*gamma2*t50 + t53 */
    const double t55 = x[6]*x[5]; /* omega1*v3 */
    const double t56 = x[0]*t50; /* gamma1*t50 */
    const double t57 = JLT_FNMA(x[8], x[3], t55); /* omega1*v3 - omega3*v1 */
    const double t58 = JLT_FNMA(x[1], t35, t57); /* omega1*v3 - omega3*v1 - gamma2*(g - Theta*1/(s*Theta*D)*s*t22) */
    const double t59 = JLT_FNMA(p[7], t56, t58); /* t58 - I1*I3*gamma1*t50 */
    const double t60 = x[7]*x[3]; /* omega2*v1 */
    const double t61 = JLT_FNMA(x[6], x[4], t60); /* omega2*v1 - omega1*v2 */
    const double t62 = JLT_FNMA(x[2], t35, t61); /* omega2*v1 - omega1*v2 - gamma3*(g - Theta*1/(s*Theta*D)*s*t22) */
    const double t63 = x[8]*p[13]; /* omega3*(I1 - I3)/I1 */
    const double t64 = x[7]*t63; /* omega2*omega3*(I1 - I3)/I1 */
    const double t65 = t34*p[14]; /* Theta*1/(s*Theta*D)*s*t22*m*a3/I1 */
    const double t66 = JLT_FMA(x[1], t65, t64); /* gamma2*Theta*1/(s*Theta*D)*s*t22*m*a3/I1 + omega2*omega3*(I1 - I3)/I1 */
    const double t67 = JLT_FNMA(t24, t56, t66); /* t66 - b*m*I3*gamma1*t50 */
    const double t68 = x[6]*t63; /* omega1*omega3*(I1 - I3)/I1 */
    const double t69 = JLT_FMA(x[0], t65, t68); /* gamma1*Theta*1/(s*Theta*D)*s*t22*m*a3/I1 + omega1*omega3*(I1 - I3)/I1 */
    const double t70 = JLT_FMA(t24, t51, t69); /* b*m*I3*gamma2*t50 + t69 */
    const double t71 = -t70; /* -(b*m*I3*gamma2*t50 + t69) */
    const double t72 = t47*p[15]; /* 1/(s*Theta*D)*gyroscopic*s*D*m*R*I1 */
    const double t73 = x[8]*x[10]; /* omega3*alpha2 */
    const double t74 = JLT_FNMA(x[7], x[11], t73); /* omega3*alpha2 - omega2*alpha3 */
    const double t75 = x[6]*x[11]; /* omega1*alpha3 */
    const double t76 = JLT_FNMA(x[8], x[9], t75); /* omega1*alpha3 - omega3*alpha1 */
    const double t77 = x[7]*x[9]; /* omega2*alpha1 */
    const double t78 = JLT_FNMA(x[6], x[10], t77); /* omega2*alpha1 - omega1*alpha2 */
    const double t79 = x[8]*x[13]; /* omega3*beta2 */
    const double t80 = JLT_FNMA(x[7], x[14], t79); /* omega3*beta2 - omega2*beta3 */
    const double t81 = x[6]*x[14]; /* omega1*beta3 */
    const double t82 = JLT_FNMA(x[8], x[12], t81); /* omega1*beta3 - omega3*beta1 */
    const double t83 = x[7]*x[12]; /* omega2*beta1 */
    const double t84 = JLT_FNMA(x[6], x[13], t83); /* omega2*beta1 - omega1*beta2 */
    const double t85 = x[3]*x[9]; /* v1*alpha1 */
    const double t86 = JLT_FMA(x[4], x[10], t85); /* v2*alpha2 + v1*alpha1 */
    const double t87 = JLT_FMA(x[5], x[11], t86); /* v3*alpha3 + v2*alpha2 + v1*alpha1 */
    const double t88 = x[3]*x[12]; /* v1*beta1 */
    const double t89 = JLT_FMA(x[4], x[13], t88); /* v2*beta2 + v1*beta1 */
    const double t90 = JLT_FMA(x[5], x[14], t89); /* v3*beta3 + v2*beta2 + v1*beta1 */
    out[0] = t1;
    out[1] = t3;
    out[2] = t7;
    out[3] = t54;
    out[4] = t59;
    out[5] = t62;
    out[6] = t67;
    out[7] = t71;
    out[8] = t72;
    out[9] = t74;
    out[10] = t76;
    out[11] = t78;
    out[12] = t80;
    out[13] = t82;
    out[14] = t84;
    out[15] = t87;
    out[16] = t90;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = -x[7]; /* -omega2 */
    const double t1 = -x[2]; /* -gamma3 */
    const double t2 = -x[8]; /* -omega3 */
    const double t3 = -x[0]; /* -gamma1 */
    const double t4 = -x[6]; /* -omega1 */
    const double t5 = -x[1]; /* -gamma2 */
    const double t6 = x[1]*x[1]; /* gamma2*gamma2 */
    const double t7 = JLT_FMA(x[0], x[0], t6); /* gamma1*gamma1 + gamma2*gamma2 */
    const double t8 = JLT_FMA(x[2], x[2], t7); /* one = gamma3*gamma3 + gamma1*gamma1 + gamma2*gamma2 */
    const double t9 = p[6]*t8; /* g*I1*one */
    const double t10 = x[6]*x[6]; /* omega1*omega1 */
    const double t11 = JLT_FMA(x[7], x[7], t10); /* omega2*omega2 + omega1*omega1 */
    const double t12 = x[2]*p[4]; /* gamma3*I1 */
    const double t13 = t11*t12; /* (omega2*omega2 + omega1*omega1)*gamma3*I1 */
    const double t14 = x[6]*x[0]; /* omega1*gamma1 */
    const double t15 = JLT_FMA(x[7], x[1], t14); /* q = omega2*gamma2 + omega1*gamma1 */
    const double t16 = x[8]*p[5]; /* omega3*I3 */
    const double t17 = JLT_FNMA(t15, t16, t13); /* (omega2*omega2 + omega1*omega1)*gamma3*I1 - q*omega3*I3 */
    const double t18 = JLT_FNMA(p[3], t17, t9); /* g*I1*one - a3*((omega2*omega2 + omega1*omega1)*gamma3*I1 - q*omega3*I3) */
    const double t19 = sqrt(t7); /* s = sqrt(gamma1*gamma1 + gamma2*gamma2) */
    const double t20 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t21 = p[9]*t20; /* m*I3*b */
    const double t22 = JLT_FMA(t7, p[8], p[7]); /* (gamma1*gamma1 + gamma2*gamma2)*m*R^2*I1 + I1*I3 */
    const double t23 = JLT_FMA(t20, t21, t22); /* Theta = b*m*I3*b + (gamma1*gamma1 + gamma2*gamma2)*m*R^2*I1 + I1*I3 */
    const double t24 = t8*p[4]; /* one*I1 */
    const double t25 = JLT_FMA(t7, p[10], t24); /* D = (gamma1*gamma1 + gamma2*gamma2)*m*a3^2 + one*I1 */
    const double t26 = t23*t25; /* Theta*D */
    const double t27 = t19*t26; /* s*Theta*D */
    const double t28 = 1.0/t27; /* 1/(s*Theta*D) */
    const double t29 = t23*t28; /* Theta*1/(s*Theta*D) */
    const double t30 = t19*t29; /* s*Theta*1/(s*Theta*D) */
    const double t31 = t18*t30; /* t18*s*Theta*1/(s*Theta*D) */
    const double t32 = x[0]*p[16]; /* gamma1*(2*I1 + 2*m*a3^2) */
    const double t33 = t31*t32; /* t18*s*Theta*1/(s*Theta*D)*gamma1*(2*I1 + 2*m*a3^2) */
    const double t34 = x[8]*p[18]; /* omega3*a3*I3 */
    const double t35 = JLT_FNMA(x[0], p[17], t33); /* t18*s*Theta*1/(s*Theta*D)*gamma1*(2*I1 + 2*m*a3^2) - gamma1*2*g*I1 */
    const double t36 = JLT_FNMA(x[6], t34, t35); /* t35 - omega1*omega3*a3*I3 */
    const double t37 = x[0]*t30; /* gamma1*s*Theta*1/(s*Theta*D) */
    const double t38 = JLT_FMS(t36, t37, t31); /* (t35 - omega1*omega3*a3*I3)*gamma1*s*Theta*1/(s*Theta*D) - t18*s*Theta*1/(s*Theta*D) */
    const double t39 = t25*t28; /* D*1/(s*Theta*D) */
    const double t40 = t25*t29; /* D*Theta*1/(s*Theta*D) */
    const double t41 = t39*t40; /* D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t42 = p[19]*t41; /* 2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t43 = t15*x[5]; /* q*v3 */
    const double t44 = x[7]*x[4]; /* omega2*v2 */
    const double t45 = JLT_FMA(x[6], x[3], t44); /* omega1*v1 + omega2*v2 */
    const double t46 = x[7]*x[0]; /* omega2*gamma1 */
    const double t47 = JLT_FNMA(x[1], x[6], t46); /* dgamma3 = omega2*gamma1 - gamma2*omega1 */
    const double t48 = x[2]*p[11]; /* gamma3*2*R */
    const double t49 = JLT_FNMA(t20, p[12], t48); /* gamma3*2*R - b*I3/I1 */
    const double t50 = x[8]*t49; /* omega3*(gamma3*2*R - b*I3/I1) */
    const double t51 = JLT_FMA(t15, p[1], t50); /* q*R + omega3*(gamma3*2*R - b*I3/I1) */
    const double t52 = JLT_FNMA(x[2], t45, t43); /* q*v3 - gamma3*(omega1*v1 + omega2*v2) */
    const double t53 = JLT_FMA(t47, t51, t52); /* gyroscopic = dgamma3*(q*R + omega3*(gamma3*2*R - b*I3/I1)) + q*v3 - gamma3*(omega1*v1 + omega2*v2) */
    const double t54 = t40*t40; /* D*Theta*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t55 = t19*t39; /* s*D*1/(s*Theta*D) */
    const double t56 = JLT_FMA(p[8], t55, t54); /* m*R^2*I1*s*D*1/(s*Theta*D) + D*Theta*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t57 = t53*t56; /* gyroscopic*t56 */
    const double t58 = x[0]*t57; /* gamma1*gyroscopic*t56 */
    const double t59 = JLT_FMA(p[1], t47, x[5]); /* R*dgamma3 + v3 */
    const double t60 = x[6]*t59; /* omega1*(R*dgamma3 + v3) */
    const double t61 = JLT_FMA(x[7], t51, t60); /* d(gyroscopic)/d(gamma1) = omega2*(q*R + omega3*(gamma3*2*R - b*I3/I1)) + omega1*(R*dgamma3 + v3) */
    const double t62 = JLT_FNMA((1.0 / 2.0), t61, t58); /* gamma1*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma1) */
    const double t63 = x[1]*t62; /* gamma2*(gamma1*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma1)) */
    const double t64 = p[2] + t38; /* g + t38 */
    const double t65 = JLT_FMA(t42, t63, t64); /* 2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*gamma2*(gamma1*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma1)) + g + t38 */
    const double t66 = -t65; /* -t65 */
    const double t67 = p[7]*t41; /* I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t68 = t53*t67; /* gyroscopic*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t69 = x[1]*p[16]; /* gamma2*(2*I1 + 2*m*a3^2) */
    const double t70 = t31*t69; /* t18*s*Theta*1/(s*Theta*D)*gamma2*(2*I1 + 2*m*a3^2) */
    const double t71 = JLT_FNMA(x[1], p[17], t70); /* t18*s*Theta*1/(s*Theta*D)*gamma2*(2*I1 + 2*m*a3^2) - gamma2*2*g*I1 */
    const double t72 = JLT_FNMA(x[7], t34, t71); /* t71 - omega2*omega3*a3*I3 */
    const double t73 = t37*t72; /* gamma1*s*Theta*1/(s*Theta*D)*(t71 - omega2*omega3*a3*I3) */
    const double t74 = x[1]*t57; /* gamma2*gyroscopic*t56 */
    const double t75 = x[7]*t59; /* omega2*(R*dgamma3 + v3) */
    const double t76 = JLT_FNMA(x[6], t51, t75); /* d(gyroscopic)/d(gamma2) = omega2*(R*dgamma3 + v3) - omega1*(q*R + omega3*(gamma3*2*R - b*I3/I1)) */
    const double t77 = JLT_FNMA((1.0 / 2.0), t76, t74); /* gamma2*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma2) */
    const double t78 = x[1]*t77; /* gamma2*(gamma2*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma2)) */
    const double t79 = t68 - t73; /* gyroscopic*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) - gamma1*s*Theta*1/(s*Theta*D)*(t71 - omega2*omega3*a3*I3) */
    const double t80 = JLT_FNMA(t42, t78, t79); /* t79 - 2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*gamma2*(gamma2*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma2)) */
    const double t81 = x[2]*t30; /* gamma3*s*Theta*1/(s*Theta*D) */
    const double t82 = t18*t81; /* t18*gamma3*s*Theta*1/(s*Theta*D) */
    const double t83 = x[2]*p[17]; /* gamma3*2*g*I1 */
    const double t84 = JLT_FNMA(t11, p[22], t83); /* gamma3*2*g*I1 - (omega2*omega2 + omega1*omega1)*a3*I1 */
    const double t85 = JLT_FNMA(p[21], t84, t82); /* t18*gamma3*s*Theta*1/(s*Theta*D) - 1/2/I1*(gamma3*2*g*I1 - (omega2*omega2 + omega1*omega1)*a3*I1) */
    const double t86 = p[20]*t85; /* 2*I1*t85 */
    const double t87 = t37*t86; /* gamma1*s*Theta*1/(s*Theta*D)*2*I1*t85 */
    const double t88 = t20*t53; /* b*gyroscopic */
    const double t89 = t39*t88; /* D*1/(s*Theta*D)*b*gyroscopic */
    const double t90 = t39*t89; /* D*1/(s*Theta*D)*D*1/(s*Theta*D)*b*gyroscopic */
    const double t91 = x[8]*p[25]; /* omega3*(2*R - R*I3/I1) */
    const double t92 = JLT_FMS(t47, t91, t45); /* d(gyroscopic)/d(gamma3) = dgamma3*omega3*(2*R - R*I3/I1) - (omega1*v1 + omega2*v2) */
    const double t93 = p[24]*t92; /* 1/2/(m*R*I3)*d(gyroscopic)/d(gamma3) */
    const double t94 = JLT_FNMA(t41, t93, t90); /* D*1/(s*Theta*D)*D*1/(s*Theta*D)*b*gyroscopic - D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*1/2/(m*R*I3)*d(gyroscopic)/d(gamma3) */
    const double t95 = p[23]*t94; /* 2*m*R*I1*I3^2*t94 */
    const double t96 = JLT_FMA(x[1], t95, t87); /* gamma2*2*m*R*I1*I3^2*t94 + gamma1*s*Theta*1/(s*Theta*D)*2*I1*t85 */
    const double t97 = -t96; /* -t96 */
    const double t98 = x[2]*x[6]; /* gamma3*omega1 */
    const double t99 = x[1]*t67; /* gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t100 = t98*t99; /* gamma3*omega1*gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t101 = -t100; /* -t100 */
    const double t102 = x[7]*x[2]; /* omega2*gamma3 */
    const double t103 = JLT_FNMA(t99, t102, x[8]); /* omega3 - gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*omega2*gamma3 */
    const double t104 = JLT_FMS(t15, t99, x[7]); /* q*gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) - omega2 */
    const double t105 = p[20]*t98; /* 2*I1*gamma3*omega1 */
    const double t106 = JLT_FNMA(x[0], t16, t105); /* 2*I1*gamma3*omega1 - gamma1*omega3*I3 */
    const double t107 = p[3]*t106; /* a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3) */
    const double t108 = t37*t107; /* gamma1*s*Theta*1/(s*Theta*D)*a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3) */
    const double t109 = x[0]*t59; /* gamma1*(R*dgamma3 + v3) */
    const double t110 = JLT_FNMA(x[2], x[3], t109); /* gamma1*(R*dgamma3 + v3) - gamma3*v1 */
    const double t111 = JLT_FNMA(x[1], t51, t110); /* d(gyroscopic)/d(omega1) = gamma1*(R*dgamma3 + v3) - gamma3*v1 - gamma2*(q*R + omega3*(gamma3*2*R - b*I3/I1)) */
    const double t112 = JLT_FMS(t99, t111, t108); /* gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*d(gyroscopic)/d(omega1) - t108 */
    const double t113 = p[20]*t102; /* 2*I1*omega2*gamma3 */
    const double t114 = JLT_FNMA(x[1], t16, t113); /* 2*I1*omega2*gamma3 - gamma2*omega3*I3 */
    const double t115 = p[3]*t114; /* a3*(2*I1*omega2*gamma3 - gamma2*omega3*I3) */
    const double t116 = x[1]*t59; /* gamma2*(R*dgamma3 + v3) */
    const double t117 = JLT_FNMA(x[2], x[4], t116); /* gamma2*(R*dgamma3 + v3) - gamma3*v2 */
    const double t118 = JLT_FMA(x[0], t51, t117); /* d(gyroscopic)/d(omega2) = gamma1*(q*R + omega3*(gamma3*2*R - b*I3/I1)) + gamma2*(R*dgamma3 + v3) - gamma3*v2 */
    const double t119 = JLT_FMA(t37, t115, x[5]); /* gamma1*s*Theta*1/(s*Theta*D)*a3*(2*I1*omega2*gamma3 - gamma2*omega3*I3) + v3 */
    const double t120 = JLT_FMS(t99, t118, t119); /* gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*d(gyroscopic)/d(omega2) - t119 */
    const double t121 = t15*p[18]; /* q*a3*I3 */
    const double t122 = t47*t49; /* dgamma3*(gamma3*2*R - b*I3/I1) */
    const double t123 = JLT_FMA(t37, t121, x[4]); /* gamma1*s*Theta*1/(s*Theta*D)*q*a3*I3 + v2 */
    const double t124 = JLT_FMA(t99, t122, t123); /* gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*dgamma3*(gamma3*2*R - b*I3/I1) + gamma1*s*Theta*1/(s*Theta*D)*q*a3*I3 + v2 */
    const double t125 = x[1]*t30; /* gamma2*s*Theta*1/(s*Theta*D) */
    const double t126 = t36*t125; /* (t35 - omega1*omega3*a3*I3)*gamma2*s*Theta*1/(s*Theta*D) */
    const double t127 = x[0]*t62; /* gamma1*(gamma1*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma1)) */
    const double t128 = t68 + t126; /* gyroscopic*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) + (t35 - omega1*omega3*a3*I3)*gamma2*s*Theta*1/(s*Theta*D) */
    const double t129 = JLT_FMS(t42, t127, t128); /* 2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*gamma1*(gamma1*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma1)) - t128 */
    const double t130 = JLT_FMS(t72, t125, t31); /* (t71 - omega2*omega3*a3*I3)*gamma2*s*Theta*1/(s*Theta*D) - t18*s*Theta*1/(s*Theta*D) */
    const double t131 = x[0]*t77; /* gamma1*(gamma2*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma2)) */
    const double t132 = p[2] + t130; /* g + t130 */
    const double t133 = JLT_FMS(t42, t131, t132); /* 2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*gamma1*(gamma2*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma2)) - (g + t130) */
    const double t134 = t86*t125; /* 2*I1*t85*gamma2*s*Theta*1/(s*Theta*D) */
    const double t135 = JLT_FMS(x[0], t95, t134); /* gamma1*2*m*R*I1*I3^2*t94 - 2*I1*t85*gamma2*s*Theta*1/(s*Theta*D) */
    const double t136 = x[0]*t67; /* gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t137 = JLT_FMS(t98, t136, x[8]); /* gamma3*omega1*gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) - omega3 */
    const double t138 = t102*t136; /* omega2*gamma3*gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t139 = JLT_FNMA(t15, t136, x[6]); /* omega1 - q*gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t140 = JLT_FNMA(t107, t125, x[5]); /* v3 - a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3)*gamma2*s*Theta*1/(s*Theta*D) */
    const double t141 = JLT_FNMA(t111, t136, t140); /* t140 - d(gyroscopic)/d(omega1)*gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t142 = t115*t125; /* a3*(2*I1*omega2*gamma3 - gamma2*omega3*I3)*gamma2*s*Theta*1/(s*Theta*D) */
    const double t143 = JLT_FMA(t118, t136, t142); /* d(gyroscopic)/d(omega2)*gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) + t142 */
    const double t144 = -t143; /* -t143 */
    const double t145 = JLT_FMS(t121, t125, x[3]); /* q*a3*I3*gamma2*s*Theta*1/(s*Theta*D) - v1 */
    const double t146 = JLT_FNMA(t122, t136, t145); /* q*a3*I3*gamma2*s*Theta*1/(s*Theta*D) - v1 - dgamma3*(gamma3*2*R - b*I3/I1)*gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t147 = t36*t81; /* (t35 - omega1*omega3*a3*I3)*gamma3*s*Theta*1/(s*Theta*D) */
    const double t148 = -t147; /* -(t35 - omega1*omega3*a3*I3)*gamma3*s*Theta*1/(s*Theta*D) */
    const double t149 = t72*t81; /* (t71 - omega2*omega3*a3*I3)*gamma3*s*Theta*1/(s*Theta*D) */
    const double t150 = -t149; /* -(t71 - omega2*omega3*a3*I3)*gamma3*s*Theta*1/(s*Theta*D) */
    const double t151 = t31 - p[2]; /* t18*s*Theta*1/(s*Theta*D) - g */
    const double t152 = JLT_FNMA(t81, t86, t151); /* t18*s*Theta*1/(s*Theta*D) - g - gamma3*s*Theta*1/(s*Theta*D)*2*I1*t85 */
    const double t153 = JLT_FMA(t81, t107, x[4]); /* gamma3*s*Theta*1/(s*Theta*D)*a3*(2*I1*gamma3*omega1 - gamma1*omega3*I3) + v2 */
    const double t154 = -t153; /* -t153 */
    const double t155 = JLT_FNMA(t81, t115, x[3]); /* v1 - gamma3*s*Theta*1/(s*Theta*D)*a3*(2*I1*omega2*gamma3 - gamma2*omega3*I3) */
    const double t156 = t81*t121; /* gamma3*s*Theta*1/(s*Theta*D)*q*a3*I3 */
    const double t157 = t20*t41; /* b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t158 = p[9]*t157; /* m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t159 = t53*t158; /* gyroscopic*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t160 = t157*p[26]; /* b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*2*m*I3 */
    const double t161 = JLT_FMA(t126, p[14], t159); /* (t35 - omega1*omega3*a3*I3)*gamma2*s*Theta*1/(s*Theta*D)*m*a3/I1 + gyroscopic*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t162 = JLT_FMS(t127, t160, t161); /* gamma1*(gamma1*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma1))*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*2*m*I3 - t161 */
    const double t163 = t130*p[14]; /* t130*m*a3/I1 */
    const double t164 = JLT_FMS(t131, t160, t163); /* gamma1*(gamma2*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma2))*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*2*m*I3 - t130*m*a3/I1 */
    const double t165 = t85*p[27]; /* t85*2*m*a3 */
    const double t166 = t125*t165; /* gamma2*s*Theta*1/(s*Theta*D)*t85*2*m*a3 */
    const double t167 = t20*t94; /* b*t94 */
    const double t168 = t53*p[29]; /* gyroscopic*1/2/(m*I3) */
    const double t169 = JLT_FNMA(t41, t168, t167); /* b*t94 - D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*gyroscopic*1/2/(m*I3) */
    const double t170 = p[28]*t169; /* 2*m^2*R*I3^2*t169 */
    const double t171 = JLT_FMS(x[0], t170, t166); /* gamma1*2*m^2*R*I3^2*t169 - gamma2*s*Theta*1/(s*Theta*D)*t85*2*m*a3 */
    const double t172 = x[0]*t158; /* gamma1*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t173 = t98*t172; /* gamma3*omega1*gamma1*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t174 = t102*t172; /* omega2*gamma3*gamma1*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t175 = t15*t172; /* q*gamma1*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t176 = -t175; /* -q*gamma1*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t177 = t106*p[30]; /* (2*I1*gamma3*omega1 - gamma1*omega3*I3)*m*a3^2/I1 */
    const double t178 = t125*t177; /* gamma2*s*Theta*1/(s*Theta*D)*(2*I1*gamma3*omega1 - gamma1*omega3*I3)*m*a3^2/I1 */
    const double t179 = JLT_FMA(t111, t172, t178); /* d(gyroscopic)/d(omega1)*gamma1*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) + t178 */
    const double t180 = -t179; /* -t179 */
    const double t181 = x[8]*p[13]; /* omega3*(I1 - I3)/I1 */
    const double t182 = t114*p[30]; /* (2*I1*omega2*gamma3 - gamma2*omega3*I3)*m*a3^2/I1 */
    const double t183 = JLT_FNMA(t125, t182, t181); /* omega3*(I1 - I3)/I1 - gamma2*s*Theta*1/(s*Theta*D)*(2*I1*omega2*gamma3 - gamma2*omega3*I3)*m*a3^2/I1 */
    const double t184 = JLT_FNMA(t118, t172, t183); /* t183 - d(gyroscopic)/d(omega2)*gamma1*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t185 = x[7]*p[13]; /* omega2*(I1 - I3)/I1 */
    const double t186 = t15*p[31]; /* q*m*a3^2*I3/I1 */
    const double t187 = JLT_FMA(t125, t186, t185); /* gamma2*s*Theta*1/(s*Theta*D)*q*m*a3^2*I3/I1 + omega2*(I1 - I3)/I1 */
    const double t188 = JLT_FNMA(t122, t172, t187); /* t187 - dgamma3*(gamma3*2*R - b*I3/I1)*gamma1*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t189 = t38*p[14]; /* t38*m*a3/I1 */
    const double t190 = JLT_FMA(t63, t160, t189); /* gamma2*(gamma1*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma1))*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*2*m*I3 + t38*m*a3/I1 */
    const double t191 = JLT_FMS(t73, p[14], t159); /* gamma1*s*Theta*1/(s*Theta*D)*(t71 - omega2*omega3*a3*I3)*m*a3/I1 - gyroscopic*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t192 = JLT_FMA(t78, t160, t191); /* gamma2*(gamma2*gyroscopic*t56 - 1/2*d(gyroscopic)/d(gamma2))*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*2*m*I3 + t191 */
    const double t193 = t37*t165; /* gamma1*s*Theta*1/(s*Theta*D)*t85*2*m*a3 */
    const double t194 = JLT_FMA(x[1], t170, t193); /* gamma2*2*m^2*R*I3^2*t169 + gamma1*s*Theta*1/(s*Theta*D)*t85*2*m*a3 */
    const double t195 = x[1]*t158; /* gamma2*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t196 = t98*t195; /* gamma3*omega1*gamma2*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t197 = t102*t195; /* omega2*gamma3*gamma2*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t198 = t15*t195; /* q*gamma2*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t199 = -t198; /* -q*gamma2*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t200 = JLT_FMS(t37, t177, t181); /* gamma1*s*Theta*1/(s*Theta*D)*(2*I1*gamma3*omega1 - gamma1*omega3*I3)*m*a3^2/I1 - omega3*(I1 - I3)/I1 */
    const double t201 = JLT_FNMA(t111, t195, t200); /* t200 - d(gyroscopic)/d(omega1)*gamma2*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t202 = t37*t182; /* gamma1*s*Theta*1/(s*Theta*D)*(2*I1*omega2*gamma3 - gamma2*omega3*I3)*m*a3^2/I1 */
    const double t203 = JLT_FNMA(t118, t195, t202); /* t202 - d(gyroscopic)/d(omega2)*gamma2*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t204 = x[6]*p[13]; /* omega1*(I1 - I3)/I1 */
    const double t205 = JLT_FMA(t37, t186, t204); /* gamma1*s*Theta*1/(s*Theta*D)*q*m*a3^2*I3/I1 + omega1*(I1 - I3)/I1 */
    const double t206 = JLT_FMA(t122, t195, t205); /* dgamma3*(gamma3*2*R - b*I3/I1)*gamma2*m*I3*b*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) + t205 */
    const double t207 = -t206; /* -t206 */
    const double t208 = t55*p[15]; /* s*D*1/(s*Theta*D)*m*R*I1 */
    const double t209 = t61*t208; /* d(gyroscopic)/d(gamma1)*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t210 = t53*t55; /* gyroscopic*s*D*1/(s*Theta*D) */
    const double t211 = t55*t210; /* s*D*1/(s*Theta*D)*gyroscopic*s*D*1/(s*Theta*D) */
    const double t212 = p[32]*t211; /* 2*m^2*R^3*I1^2*s*D*1/(s*Theta*D)*gyroscopic*s*D*1/(s*Theta*D) */
    const double t213 = JLT_FNMA(x[0], t212, t209); /* d(gyroscopic)/d(gamma1)*s*D*1/(s*Theta*D)*m*R*I1 - gamma1*t212 */
    const double t214 = t76*t208; /* d(gyroscopic)/d(gamma2)*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t215 = JLT_FNMA(x[1], t212, t214); /* d(gyroscopic)/d(gamma2)*s*D*1/(s*Theta*D)*m*R*I1 - gamma2*t212 */
    const double t216 = t92*t208; /* d(gyroscopic)/d(gamma3)*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t217 = t20*p[33]; /* b*2*m^2*R^2*I1*I3 */
    const double t218 = JLT_FNMA(t211, t217, t216); /* d(gyroscopic)/d(gamma3)*s*D*1/(s*Theta*D)*m*R*I1 - s*D*1/(s*Theta*D)*gyroscopic*s*D*1/(s*Theta*D)*b*2*m^2*R^2*I1*I3 */
    const double t219 = t98*t208; /* gamma3*omega1*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t220 = -t219; /* -gamma3*omega1*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t221 = t102*t208; /* omega2*gamma3*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t222 = -t221; /* -omega2*gamma3*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t223 = t15*t208; /* q*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t224 = t111*t208; /* d(gyroscopic)/d(omega1)*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t225 = t118*t208; /* d(gyroscopic)/d(omega2)*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t226 = t122*t208; /* dgamma3*(gamma3*2*R - b*I3/I1)*s*D*1/(s*Theta*D)*m*R*I1 */
    const double t227 = -x[11]; /* -alpha3 */
    const double t228 = -x[9]; /* -alpha1 */
    const double t229 = -x[10]; /* -alpha2 */
    const double t230 = -x[14]; /* -beta3 */
    const double t231 = -x[12]; /* -beta1 */
    const double t232 = -x[13]; /* -beta2 */
    out[0] = 0.0;
    out[1] = x[8];
    out[2] = t0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t1;
    out[8] = x[1];
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = t2;
    out[18] = 0.0;
    out[19] = x[6];
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = x[2];
    out[24] = 0.0;
    out[25] = t3;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = 0.0;
    out[30] = 0.0;
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = x[7];
    out[35] = t4;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = 0.0;
    out[40] = t5;
    out[41] = x[0];
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = 0.0;
    out[50] = 0.0;
    out[51] = t66;
    out[52] = t80;
    out[53] = t97;
    out[54] = t101;
    out[55] = t103;
    out[56] = t104;
    out[57] = t112;
    out[58] = t120;
    out[59] = t124;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = 0.0;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[68] = t129;
    out[69] = t133;
    out[70] = t135;
    out[71] = t137;
    out[72] = t138;
    out[73] = t139;
    out[74] = t141;
    out[75] = t144;
    out[76] = t146;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[81] = 0.0;
    out[82] = 0.0;
    out[83] = 0.0;
    out[84] = 0.0;
    out[85] = t148;
    out[86] = t150;
    out[87] = t152;
    out[88] = x[7];
    out[89] = t4;
    out[90] = 0.0;
    out[91] = t154;
    out[92] = t155;
    out[93] = t156;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = 0.0;
    out[100] = 0.0;
    out[101] = 0.0;
    out[102] = t162;
    out[103] = t164;
    out[104] = t171;
    out[105] = t173;
    out[106] = t174;
    out[107] = t176;
    out[108] = t180;
    out[109] = t184;
    out[110] = t188;
    out[111] = 0.0;
    out[112] = 0.0;
    out[113] = 0.0;
    out[114] = 0.0;
    out[115] = 0.0;
    out[116] = 0.0;
    out[117] = 0.0;
    out[118] = 0.0;
    out[119] = t190;
    out[120] = t192;
    out[121] = t194;
    out[122] = t196;
    out[123] = t197;
    out[124] = t199;
    out[125] = t201;
    out[126] = t203;
    out[127] = t207;
    out[128] = 0.0;
    out[129] = 0.0;
    out[130] = 0.0;
    out[131] = 0.0;
    out[132] = 0.0;
    out[133] = 0.0;
    out[134] = 0.0;
    out[135] = 0.0;
    out[136] = t213;
    out[137] = t215;
    out[138] = t218;
    out[139] = t220;
    out[140] = t222;
    out[141] = t223;
    out[142] = t224;
    out[143] = t225;
    out[144] = t226;
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
    out[160] = t227;
    out[161] = x[10];
    out[162] = 0.0;
    out[163] = x[8];
    out[164] = t0;
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
    out[176] = x[11];
    out[177] = 0.0;
    out[178] = t228;
    out[179] = t2;
    out[180] = 0.0;
    out[181] = x[6];
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
    out[193] = t229;
    out[194] = x[9];
    out[195] = 0.0;
    out[196] = x[7];
    out[197] = t4;
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
    out[211] = t230;
    out[212] = x[13];
    out[213] = 0.0;
    out[214] = 0.0;
    out[215] = 0.0;
    out[216] = 0.0;
    out[217] = x[8];
    out[218] = t0;
    out[219] = 0.0;
    out[220] = 0.0;
    out[221] = 0.0;
    out[222] = 0.0;
    out[223] = 0.0;
    out[224] = 0.0;
    out[225] = 0.0;
    out[226] = 0.0;
    out[227] = x[14];
    out[228] = 0.0;
    out[229] = t231;
    out[230] = 0.0;
    out[231] = 0.0;
    out[232] = 0.0;
    out[233] = t2;
    out[234] = 0.0;
    out[235] = x[6];
    out[236] = 0.0;
    out[237] = 0.0;
    out[238] = 0.0;
    out[239] = 0.0;
    out[240] = 0.0;
    out[241] = 0.0;
    out[242] = 0.0;
    out[243] = 0.0;
    out[244] = t232;
    out[245] = x[12];
    out[246] = 0.0;
    out[247] = 0.0;
    out[248] = 0.0;
    out[249] = 0.0;
    out[250] = x[7];
    out[251] = t4;
    out[252] = 0.0;
    out[253] = 0.0;
    out[254] = 0.0;
    out[255] = 0.0;
    out[256] = 0.0;
    out[257] = 0.0;
    out[258] = x[9];
    out[259] = x[10];
    out[260] = x[11];
    out[261] = 0.0;
    out[262] = 0.0;
    out[263] = 0.0;
    out[264] = x[3];
    out[265] = x[4];
    out[266] = x[5];
    out[267] = 0.0;
    out[268] = 0.0;
    out[269] = 0.0;
    out[270] = 0.0;
    out[271] = 0.0;
    out[272] = 0.0;
    out[273] = 0.0;
    out[274] = 0.0;
    out[275] = x[12];
    out[276] = x[13];
    out[277] = x[14];
    out[278] = 0.0;
    out[279] = 0.0;
    out[280] = 0.0;
    out[281] = 0.0;
    out[282] = 0.0;
    out[283] = 0.0;
    out[284] = x[3];
    out[285] = x[4];
    out[286] = x[5];
    out[287] = 0.0;
    out[288] = 0.0;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[2]*x[7]; /* gamma3*omega2 */
    const double t1 = JLT_FMS(x[1], x[8], t0); /* gamma2*omega3 - gamma3*omega2 */
    const double t2 = x[2]*x[6]; /* gamma3*omega1 */
    const double t3 = JLT_FNMA(x[8], x[0], t2); /* gamma3*omega1 - omega3*gamma1 */
    const double t4 = x[1]*x[6]; /* gamma2*omega1 */
    const double t5 = x[7]*x[0]; /* omega2*gamma1 */
    const double t6 = t4 - t5; /* gamma2*omega1 - omega2*gamma1 */
    const double t7 = t5 - t4; /* omega2*gamma1 - gamma2*omega1 */
    const double t8 = x[8]*x[4]; /* omega3*v2 */
    const double t9 = x[1]*x[1]; /* gamma2*gamma2 */
    const double t10 = JLT_FMA(x[0], x[0], t9); /* gamma1*gamma1 + gamma2*gamma2 */
    const double t11 = JLT_FMA(x[2], x[2], t10); /* one = gamma3*gamma3 + gamma1*gamma1 + gamma2*gamma2 */
    const double t12 = p[6]*t11; /* g*I1*one */
    const double t13 = x[6]*x[6]; /* omega1*omega1 */
    const double t14 = JLT_FMA(x[7], x[7], t13); /* omega2*omega2 + omega1*omega1 */
    const double t15 = x[2]*p[4]; /* gamma3*I1 */
    const double t16 = t14*t15; /* (omega2*omega2 + omega1*omega1)*gamma3*I1 */
    const double t17 = x[6]*x[0]; /* omega1*gamma1 */
    const double t18 = JLT_FMA(x[1], x[7], t17); /* q = gamma2*omega2 + omega1*gamma1 */
    const double t19 = x[8]*p[5]; /* omega3*I3 */
    const double t20 = JLT_FNMA(t18, t19, t16); /* (omega2*omega2 + omega1*omega1)*gamma3*I1 - q*omega3*I3 */
    const double t21 = JLT_FNMA(p[3], t20, t12); /* g*I1*one - a3*((omega2*omega2 + omega1*omega1)*gamma3*I1 - q*omega3*I3) */
    const double t22 = sqrt(t10); /* s = sqrt(gamma1*gamma1 + gamma2*gamma2) */
    const double t23 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t24 = t23*p[9]; /* b*m*I3 */
    const double t25 = JLT_FMA(t10, p[8], p[7]); /* (gamma1*gamma1 + gamma2*gamma2)*m*R^2*I1 + I1*I3 */
    const double t26 = JLT_FMA(t23, t24, t25); /* Theta = b*b*m*I3 + (gamma1*gamma1 + gamma2*gamma2)*m*R^2*I1 + I1*I3 */
    const double t27 = t11*p[4]; /* one*I1 */
    const double t28 = JLT_FMA(t10, p[10], t27); /* D = (gamma1*gamma1 + gamma2*gamma2)*m*a3^2 + one*I1 */
    const double t29 = t26*t28; /* Theta*D */
    const double t30 = t22*t29; /* s*Theta*D */
    const double t31 = 1.0/t30; /* 1/(s*Theta*D) */
    const double t32 = t26*t31; /* Theta*1/(s*Theta*D) */
    const double t33 = t22*t32; /* s*Theta*1/(s*Theta*D) */
    const double t34 = t21*t33; /* t21*s*Theta*1/(s*Theta*D) */
    const double t35 = p[2] - t34; /* g - t21*s*Theta*1/(s*Theta*D) */
    const double t36 = x[5]*t18; /* v3*q */
    const double t37 = x[7]*x[4]; /* omega2*v2 */
    const double t38 = JLT_FMA(x[6], x[3], t37); /* omega1*v1 + omega2*v2 */
    const double t39 = x[2]*p[11]; /* gamma3*2*R */
    const double t40 = JLT_FNMA(t23, p[12], t39); /* gamma3*2*R - b*I3/I1 */
    const double t41 = x[8]*t40; /* omega3*(gamma3*2*R - b*I3/I1) */
    const double t42 = JLT_FMA(t18, p[1], t41); /* q*R + omega3*(gamma3*2*R - b*I3/I1) */
    const double t43 = JLT_FNMA(x[2], t38, t36); /* v3*q - gamma3*(omega1*v1 + omega2*v2) */
    const double t44 = JLT_FNMA(t6, t42, t43); /* gyroscopic = v3*q - gamma3*(omega1*v1 + omega2*v2) - (gamma2*omega1 - omega2*gamma1)*(q*R + omega3*(gamma3*2*R - b*I3/I1)) */
    const double t45 = t28*t31; /* D*1/(s*Theta*D) */
    const double t46 = t28*t32; /* D*Theta*1/(s*Theta*D) */
    const double t47 = t45*t46; /* D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t48 = p[7]*t47; /* I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t49 = x[1]*t48; /* gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t50 = JLT_FNMA(x[7], x[5], t8); /* omega3*v2 - omega2*v3 */
    const double t51 = JLT_FNMA(x[0], t35, t50); /* omega3*v2 - omega2*v3 - gamma1*(g - t21*s*Theta*1/(s*Theta*D)) */
    const double t52 = JLT_FMA(t44, t49, t51); /* gyroscopic*gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) + t51 */
    const double t53 = x[6]*x[5]; /* omega1*v3 */
    const double t54 = x[0]*t48; /* gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t55 = JLT_FNMA(x[8], x[3], t53); /* omega1*v3 - omega3*v1 */
    const double t56 = JLT_FNMA(x[1], t35, t55); /* omega1*v3 - omega3*v1 - gamma2*(g - t21*s*Theta*1/(s*Theta*D)) */
    const double t57 = JLT_FNMA(t44, t54, t56); /* t56 - gyroscopic*gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t58 = x[7]*x[3]; /* omega2*v1 */
    const double t59 = JLT_FNMA(x[6], x[4], t58); /* omega2*v1 - omega1*v2 */
    const double t60 = JLT_FNMA(x[2], t35, t59); /* omega2*v1 - omega1*v2 - gamma3*(g - t21*s*Theta*1/(s*Theta*D)) */
    const double t61 = x[8]*p[13]; /* omega3*(I1 - I3)/I1 */
    const double t62 = x[7]*t61; /* omega2*omega3*(I1 - I3)/I1 */
    const double t63 = t34*p[14]; /* t21*s*Theta*1/(s*Theta*D)*m*a3/I1 */
    const double t64 = t24*t47; /* b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t65 = x[0]*t64; /* gamma1*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t66 = JLT_FMA(x[1], t63, t62); /* gamma2*t21*s*Theta*1/(s*Theta*D)*m*a3/I1 + omega2*omega3*(I1 - I3)/I1 */
    const double t67 = JLT_FNMA(t44, t65, t66); /* t66 - gyroscopic*gamma1*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t68 = x[6]*t61; /* omega1*omega3*(I1 - I3)/I1 */
    const double t69 = x[1]*t64; /* gamma2*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t70 = JLT_FMA(x[0], t63, t68); /* gamma1*t21*s*Theta*1/(s*Theta*D)*m*a3/I1 + omega1*omega3*(I1 - I3)/I1 */
    const double t71 = JLT_FMA(t44, t69, t70); /* gyroscopic*gamma2*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) + t70 */
    const double t72 = -t71; /* -t71 */
    const double t73 = t22*t45; /* s*D*1/(s*Theta*D) */
    const double t74 = p[15]*t73; /* m*R*I1*s*D*1/(s*Theta*D) */
    const double t75 = t44*t74; /* gyroscopic*m*R*I1*s*D*1/(s*Theta*D) */
    const double t76 = x[8]*x[10]; /* omega3*alpha2 */
    const double t77 = JLT_FNMA(x[7], x[11], t76); /* omega3*alpha2 - omega2*alpha3 */
    const double t78 = x[6]*x[11]; /* omega1*alpha3 */
    const double t79 = JLT_FNMA(x[8], x[9], t78); /* omega1*alpha3 - omega3*alpha1 */
    const double t80 = x[7]*x[9]; /* omega2*alpha1 */
    const double t81 = JLT_FNMA(x[6], x[10], t80); /* omega2*alpha1 - omega1*alpha2 */
    const double t82 = x[8]*x[13]; /* omega3*beta2 */
    const double t83 = JLT_FNMA(x[7], x[14], t82); /* omega3*beta2 - omega2*beta3 */
    const double t84 = x[6]*x[14]; /* omega1*beta3 */
    const double t85 = JLT_FNMA(x[8], x[12], t84); /* omega1*beta3 - omega3*beta1 */
    const double t86 = x[7]*x[12]; /* omega2*beta1 */
    const double t87 = JLT_FNMA(x[6], x[13], t86); /* omega2*beta1 - omega1*beta2 */
    const double t88 = x[3]*x[9]; /* v1*alpha1 */
    const double t89 = JLT_FMA(x[4], x[10], t88); /* v2*alpha2 + v1*alpha1 */
    const double t90 = JLT_FMA(x[5], x[11], t89); /* v3*alpha3 + v2*alpha2 + v1*alpha1 */
    const double t91 = x[3]*x[12]; /* v1*beta1 */
    const double t92 = JLT_FMA(x[4], x[13], t91); /* v2*beta2 + v1*beta1 */
    const double t93 = JLT_FMA(x[5], x[14], t92); /* v3*beta3 + v2*beta2 + v1*beta1 */
    const double t94 = -x[7]; /* -omega2 */
    const double t95 = -x[2]; /* -gamma3 */
    const double t96 = -x[8]; /* -omega3 */
    const double t97 = -x[0]; /* -gamma1 */
    const double t98 = -x[6]; /* -omega1 */
    const double t99 = -x[1]; /* -gamma2 */
    const double t100 = x[0]*p[16]; /* gamma1*(2*I1 + 2*m*a3^2) */
    const double t101 = t34*t100; /* t21*s*Theta*1/(s*Theta*D)*gamma1*(2*I1 + 2*m*a3^2) */
    const double t102 = x[8]*p[18]; /* omega3*a3*I3 */
    const double t103 = JLT_FNMA(x[0], p[17], t101); /* t21*s*Theta*1/(s*Theta*D)*gamma1*(2*I1 + 2*m*a3^2) - gamma1*2*g*I1 */
    const double t104 = JLT_FNMA(x[6], t102, t103); /* t103 - omega1*omega3*a3*I3 */
    const double t105 = x[0]*t33; /* gamma1*s*Theta*1/(s*Theta*D) */
    const double t106 = t46*t46; /* D*Theta*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t107 = t46*t106; /* D*Theta*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t108 = JLT_FMA(p[8], t45, t107); /* m*R^2*I1*D*1/(s*Theta*D) + t107 */
    const double t109 = t44*t45; /* gyroscopic*D*1/(s*Theta*D) */
    const double t110 = t108*t109; /* (m*R^2*I1*D*1/(s*Theta*D) + t107)*gyroscopic*D*1/(s*Theta*D) */
    const double t111 = x[0]*t110; /* gamma1*(m*R^2*I1*D*1/(s*Theta*D) + t107)*gyroscopic*D*1/(s*Theta*D) */
    const double t112 = JLT_FNMA(t6, p[1], x[5]); /* v3 - (gamma2*omega1 - omega2*gamma1)*R */
    const double t113 = x[6]*t112; /* omega1*(v3 - (gamma2*omega1 - omega2*gamma1)*R) */
    const double t114 = JLT_FMA(x[7], t42, t113); /* d(gyroscopic)/d(gamma1) = omega2*(q*R + omega3*(gamma3*2*R - b*I3/I1)) + omega1*(v3 - (gamma2*omega1 - omega2*gamma1)*R) */
    const double t115 = t47*(1.0 / 2.0); /* D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*1/2 */
    const double t116 = JLT_FNMA(t114, t115, t111); /* t111 - d(gyroscopic)/d(gamma1)*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*1/2 */
    const double t117 = x[1]*t116; /* gamma2*t116 */
    const double t118 = JLT_FMA(t104, t105, t35); /* (t103 - omega1*omega3*a3*I3)*gamma1*s*Theta*1/(s*Theta*D) + g - t21*s*Theta*1/(s*Theta*D) */
    const double t119 = JLT_FMA(p[19], t117, t118); /* 2*I1*I3*gamma2*t116 + t118 */
    const double t120 = -t119; /* -(2*I1*I3*gamma2*t116 + t118) */
    const double t121 = t44*t48; /* gyroscopic*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t122 = x[1]*p[16]; /* gamma2*(2*I1 + 2*m*a3^2) */
    const double t123 = t34*t122; /* t21*s*Theta*1/(s*Theta*D)*gamma2*(2*I1 + 2*m*a3^2) */
    const double t124 = JLT_FNMA(x[1], p[17], t123); /* t21*s*Theta*1/(s*Theta*D)*gamma2*(2*I1 + 2*m*a3^2) - gamma2*2*g*I1 */
    const double t125 = JLT_FNMA(x[7], t102, t124); /* t124 - omega2*omega3*a3*I3 */
    const double t126 = t105*t125; /* gamma1*s*Theta*1/(s*Theta*D)*(t124 - omega2*omega3*a3*I3) */
    const double t127 = x[1]*t110; /* gamma2*(m*R^2*I1*D*1/(s*Theta*D) + t107)*gyroscopic*D*1/(s*Theta*D) */
    const double t128 = x[7]*t112; /* omega2*(v3 - (gamma2*omega1 - omega2*gamma1)*R) */
    const double t129 = JLT_FNMA(x[6], t42, t128); /* d(gyroscopic)/d(gamma2) = omega2*(v3 - (gamma2*omega1 - omega2*gamma1)*R) - omega1*(q*R + omega3*(gamma3*2*R - b*I3/I1)) */
    const double t130 = JLT_FNMA(t115, t129, t127); /* t127 - D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*1/2*d(gyroscopic)/d(gamma2) */
    const double t131 = x[1]*t130; /* gamma2*t130 */
    const double t132 = t121 - t126; /* gyroscopic*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) - gamma1*s*Theta*1/(s*Theta*D)*(t124 - omega2*omega3*a3*I3) */
    const double t133 = JLT_FNMA(p[19], t131, t132); /* t132 - 2*I1*I3*gamma2*t130 */
    const double t134 = x[2]*t34; /* gamma3*t21*s*Theta*1/(s*Theta*D) */
    const double t135 = x[2]*p[17]; /* gamma3*2*g*I1 */
    const double t136 = JLT_FNMA(t14, p[22], t135); /* gamma3*2*g*I1 - (omega2*omega2 + omega1*omega1)*a3*I1 */
    const double t137 = JLT_FNMA(p[21], t136, t134); /* gamma3*t21*s*Theta*1/(s*Theta*D) - 1/2/I1*(gamma3*2*g*I1 - (omega2*omega2 + omega1*omega1)*a3*I1) */
    const double t138 = p[20]*t137; /* 2*I1*t137 */
    const double t139 = t105*t138; /* gamma1*s*Theta*1/(s*Theta*D)*2*I1*t137 */
    const double t140 = t23*t45; /* b*D*1/(s*Theta*D) */
    const double t141 = t109*t140; /* gyroscopic*D*1/(s*Theta*D)*b*D*1/(s*Theta*D) */
    const double t142 = x[8]*p[25]; /* omega3*(2*R - R*I3/I1) */
    const double t143 = JLT_FMA(t6, t142, t38); /* (gamma2*omega1 - omega2*gamma1)*omega3*(2*R - R*I3/I1) + omega1*v1 + omega2*v2 */
    const double t144 = p[24]*t143; /* 1/2/(m*R*I3)*t143 */
    const double t145 = JLT_FMA(t47, t144, t141); /* D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*1/2/(m*R*I3)*t143 + gyroscopic*D*1/(s*Theta*D)*b*D*1/(s*Theta*D) */
    const double t146 = p[23]*t145; /* 2*m*R*I1*I3^2*t145 */
    const double t147 = JLT_FMA(x[1], t146, t139); /* gamma2*2*m*R*I1*I3^2*t145 + gamma1*s*Theta*1/(s*Theta*D)*2*I1*t137 */
    const double t148 = -t147; /* -t147 */
    const double t149 = t2*t49; /* gamma3*omega1*gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t150 = -t149; /* -t149 */
    const double t151 = JLT_FNMA(t0, t49, x[8]); /* omega3 - gamma3*omega2*gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t152 = JLT_FMS(t18, t49, x[7]); /* q*gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) - omega2 */
    const double t153 = t2*p[20]; /* gamma3*omega1*2*I1 */
    const double t154 = JLT_FNMA(x[0], t19, t153); /* gamma3*omega1*2*I1 - gamma1*omega3*I3 */
    const double t155 = p[3]*t154; /* a3*(gamma3*omega1*2*I1 - gamma1*omega3*I3) */
    const double t156 = t105*t155; /* gamma1*s*Theta*1/(s*Theta*D)*a3*(gamma3*omega1*2*I1 - gamma1*omega3*I3) */
    const double t157 = x[0]*t112; /* gamma1*(v3 - (gamma2*omega1 - omega2*gamma1)*R) */
    const double t158 = JLT_FNMA(x[2], x[3], t157); /* gamma1*(v3 - (gamma2*omega1 - omega2*gamma1)*R) - gamma3*v1 */
    const double t159 = JLT_FNMA(x[1], t42, t158); /* d(gyroscopic)/d(omega1) = gamma1*(v3 - (gamma2*omega1 - omega2*gamma1)*R) - gamma3*v1 - gamma2*(q*R + omega3*(gamma3*2*R - b*I3/I1)) */
    const double t160 = JLT_FMS(t49, t159, t156); /* gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*d(gyroscopic)/d(omega1) - t156 */
    const double t161 = t0*p[20]; /* gamma3*omega2*2*I1 */
    const double t162 = JLT_FNMA(x[1], t19, t161); /* gamma3*omega2*2*I1 - gamma2*omega3*I3 */
    const double t163 = p[3]*t162; /* a3*(gamma3*omega2*2*I1 - gamma2*omega3*I3) */
    const double t164 = x[1]*t112; /* gamma2*(v3 - (gamma2*omega1 - omega2*gamma1)*R) */
    const double t165 = JLT_FNMA(x[2], x[4], t164); /* gamma2*(v3 - (gamma2*omega1 - omega2*gamma1)*R) - gamma3*v2 */
    const double t166 = JLT_FMA(x[0], t42, t165); /* d(gyroscopic)/d(omega2) = gamma1*(q*R + omega3*(gamma3*2*R - b*I3/I1)) + gamma2*(v3 - (gamma2*omega1 - omega2*gamma1)*R) - gamma3*v2 */
    const double t167 = JLT_FMA(t105, t163, x[5]); /* gamma1*s*Theta*1/(s*Theta*D)*a3*(gamma3*omega2*2*I1 - gamma2*omega3*I3) + v3 */
    const double t168 = JLT_FMS(t49, t166, t167); /* gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*d(gyroscopic)/d(omega2) - t167 */
    const double t169 = t18*p[18]; /* q*a3*I3 */
    const double t170 = t6*t40; /* (gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - b*I3/I1) */
    const double t171 = JLT_FMA(t105, t169, x[4]); /* gamma1*s*Theta*1/(s*Theta*D)*q*a3*I3 + v2 */
    const double t172 = JLT_FNMA(t49, t170, t171); /* gamma1*s*Theta*1/(s*Theta*D)*q*a3*I3 + v2 - gamma2*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*(gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - b*I3/I1) */
    const double t173 = x[1]*t33; /* gamma2*s*Theta*1/(s*Theta*D) */
    const double t174 = x[0]*p[19]; /* gamma1*2*I1*I3 */
    const double t175 = JLT_FMA(t104, t173, t121); /* (t103 - omega1*omega3*a3*I3)*gamma2*s*Theta*1/(s*Theta*D) + gyroscopic*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t176 = JLT_FMS(t116, t174, t175); /* t116*gamma1*2*I1*I3 - t175 */
    const double t177 = t125*t173; /* (t124 - omega2*omega3*a3*I3)*gamma2*s*Theta*1/(s*Theta*D) */
    const double t178 = t35 + t177; /* g - t21*s*Theta*1/(s*Theta*D) + (t124 - omega2*omega3*a3*I3)*gamma2*s*Theta*1/(s*Theta*D) */
    const double t179 = JLT_FMS(t130, t174, t178); /* t130*gamma1*2*I1*I3 - t178 */
    const double t180 = t138*t173; /* 2*I1*t137*gamma2*s*Theta*1/(s*Theta*D) */
    const double t181 = JLT_FMS(x[0], t146, t180); /* gamma1*2*m*R*I1*I3^2*t145 - 2*I1*t137*gamma2*s*Theta*1/(s*Theta*D) */
    const double t182 = JLT_FMS(t2, t54, x[8]); /* gamma3*omega1*gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) - omega3 */
    const double t183 = t0*t54; /* gamma3*omega2*gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t184 = JLT_FNMA(t18, t54, x[6]); /* omega1 - q*gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t185 = JLT_FNMA(t155, t173, x[5]); /* v3 - a3*(gamma3*omega1*2*I1 - gamma1*omega3*I3)*gamma2*s*Theta*1/(s*Theta*D) */
    const double t186 = JLT_FNMA(t54, t159, t185); /* t185 - gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*d(gyroscopic)/d(omega1) */
    const double t187 = t163*t173; /* a3*(gamma3*omega2*2*I1 - gamma2*omega3*I3)*gamma2*s*Theta*1/(s*Theta*D) */
    const double t188 = JLT_FMA(t54, t166, t187); /* gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*d(gyroscopic)/d(omega2) + t187 */
    const double t189 = -t188; /* -t188 */
    const double t190 = JLT_FMS(t169, t173, x[3]); /* q*a3*I3*gamma2*s*Theta*1/(s*Theta*D) - v1 */
    const double t191 = JLT_FMA(t54, t170, t190); /* gamma1*I1*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*(gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - b*I3/I1) + q*a3*I3*gamma2*s*Theta*1/(s*Theta*D) - v1 */
    const double t192 = x[2]*t33; /* gamma3*s*Theta*1/(s*Theta*D) */
    const double t193 = t104*t192; /* (t103 - omega1*omega3*a3*I3)*gamma3*s*Theta*1/(s*Theta*D) */
    const double t194 = -t193; /* -(t103 - omega1*omega3*a3*I3)*gamma3*s*Theta*1/(s*Theta*D) */
    const double t195 = t125*t192; /* (t124 - omega2*omega3*a3*I3)*gamma3*s*Theta*1/(s*Theta*D) */
    const double t196 = -t195; /* -(t124 - omega2*omega3*a3*I3)*gamma3*s*Theta*1/(s*Theta*D) */
    const double t197 = JLT_FMA(t138, t192, t35); /* 2*I1*t137*gamma3*s*Theta*1/(s*Theta*D) + g - t21*s*Theta*1/(s*Theta*D) */
    const double t198 = -t197; /* -t197 */
    const double t199 = JLT_FMA(t155, t192, x[4]); /* a3*(gamma3*omega1*2*I1 - gamma1*omega3*I3)*gamma3*s*Theta*1/(s*Theta*D) + v2 */
    const double t200 = -t199; /* -t199 */
    const double t201 = JLT_FNMA(t163, t192, x[3]); /* v1 - a3*(gamma3*omega2*2*I1 - gamma2*omega3*I3)*gamma3*s*Theta*1/(s*Theta*D) */
    const double t202 = t169*t192; /* q*a3*I3*gamma3*s*Theta*1/(s*Theta*D) */
    const double t203 = p[14]*t104; /* m*a3/I1*(t103 - omega1*omega3*a3*I3) */
    const double t204 = t44*t64; /* gyroscopic*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t205 = t23*p[26]; /* b*2*m*I3 */
    const double t206 = x[0]*t205; /* gamma1*b*2*m*I3 */
    const double t207 = JLT_FMA(t173, t203, t204); /* gamma2*s*Theta*1/(s*Theta*D)*m*a3/I1*(t103 - omega1*omega3*a3*I3) + gyroscopic*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t208 = JLT_FMS(t116, t206, t207); /* t116*gamma1*b*2*m*I3 - t207 */
    const double t209 = JLT_FNMA(p[14], t177, t63); /* t21*s*Theta*1/(s*Theta*D)*m*a3/I1 - m*a3/I1*(t124 - omega2*omega3*a3*I3)*gamma2*s*Theta*1/(s*Theta*D) */
    const double t210 = JLT_FMA(t130, t206, t209); /* t130*gamma1*b*2*m*I3 + t209 */
    const double t211 = t137*p[27]; /* t137*2*m*a3 */
    const double t212 = t173*t211; /* gamma2*s*Theta*1/(s*Theta*D)*t137*2*m*a3 */
    const double t213 = t23*t145; /* b*t145 */
    const double t214 = t44*p[29]; /* gyroscopic*1/2/(m*I3) */
    const double t215 = JLT_FNMA(t47, t214, t213); /* b*t145 - D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*gyroscopic*1/2/(m*I3) */
    const double t216 = p[28]*t215; /* 2*m^2*R*I3^2*t215 */
    const double t217 = JLT_FMS(x[0], t216, t212); /* gamma1*2*m^2*R*I3^2*t215 - gamma2*s*Theta*1/(s*Theta*D)*t137*2*m*a3 */
    const double t218 = t2*t65; /* gamma3*omega1*gamma1*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t219 = t0*t65; /* gamma3*omega2*gamma1*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t220 = t18*t65; /* q*gamma1*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t221 = -t220; /* -q*gamma1*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t222 = t173*p[30]; /* gamma2*s*Theta*1/(s*Theta*D)*m*a3^2/I1 */
    const double t223 = t154*t222; /* (gamma3*omega1*2*I1 - gamma1*omega3*I3)*gamma2*s*Theta*1/(s*Theta*D)*m*a3^2/I1 */
    const double t224 = JLT_FMA(t65, t159, t223); /* gamma1*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*d(gyroscopic)/d(omega1) + t223 */
    const double t225 = -t224; /* -t224 */
    const double t226 = JLT_FNMA(t162, t222, t61); /* omega3*(I1 - I3)/I1 - (gamma3*omega2*2*I1 - gamma2*omega3*I3)*gamma2*s*Theta*1/(s*Theta*D)*m*a3^2/I1 */
    const double t227 = JLT_FNMA(t65, t166, t226); /* t226 - gamma1*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*d(gyroscopic)/d(omega2) */
    const double t228 = x[7]*p[13]; /* omega2*(I1 - I3)/I1 */
    const double t229 = t18*p[31]; /* q*m*a3^2*I3/I1 */
    const double t230 = JLT_FMA(t173, t229, t228); /* gamma2*s*Theta*1/(s*Theta*D)*q*m*a3^2*I3/I1 + omega2*(I1 - I3)/I1 */
    const double t231 = JLT_FMA(t65, t170, t230); /* gamma1*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*(gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - b*I3/I1) + t230 */
    const double t232 = JLT_FMS(t105, t203, t63); /* gamma1*s*Theta*1/(s*Theta*D)*m*a3/I1*(t103 - omega1*omega3*a3*I3) - t21*s*Theta*1/(s*Theta*D)*m*a3/I1 */
    const double t233 = JLT_FMA(t117, t205, t232); /* gamma2*t116*b*2*m*I3 + t232 */
    const double t234 = JLT_FMS(p[14], t126, t204); /* m*a3/I1*gamma1*s*Theta*1/(s*Theta*D)*(t124 - omega2*omega3*a3*I3) - gyroscopic*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t235 = JLT_FMA(t131, t205, t234); /* gamma2*t130*b*2*m*I3 + t234 */
    const double t236 = t105*t211; /* gamma1*s*Theta*1/(s*Theta*D)*t137*2*m*a3 */
    const double t237 = JLT_FMA(x[1], t216, t236); /* gamma2*2*m^2*R*I3^2*t215 + gamma1*s*Theta*1/(s*Theta*D)*t137*2*m*a3 */
    const double t238 = t2*t69; /* gamma3*omega1*gamma2*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t239 = t0*t69; /* gamma3*omega2*gamma2*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t240 = t18*t69; /* q*gamma2*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t241 = -t240; /* -q*gamma2*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D) */
    const double t242 = t105*p[30]; /* gamma1*s*Theta*1/(s*Theta*D)*m*a3^2/I1 */
    const double t243 = JLT_FMS(t154, t242, t61); /* (gamma3*omega1*2*I1 - gamma1*omega3*I3)*gamma1*s*Theta*1/(s*Theta*D)*m*a3^2/I1 - omega3*(I1 - I3)/I1 */
    const double t244 = JLT_FNMA(t69, t159, t243); /* t243 - gamma2*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*d(gyroscopic)/d(omega1) */
    const double t245 = t162*t242; /* (gamma3*omega2*2*I1 - gamma2*omega3*I3)*gamma1*s*Theta*1/(s*Theta*D)*m*a3^2/I1 */
    const double t246 = JLT_FNMA(t69, t166, t245); /* t245 - gamma2*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*d(gyroscopic)/d(omega2) */
    const double t247 = x[6]*p[13]; /* omega1*(I1 - I3)/I1 */
    const double t248 = JLT_FMS(t69, t170, t247); /* gamma2*b*m*I3*D*1/(s*Theta*D)*D*Theta*1/(s*Theta*D)*(gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - b*I3/I1) - omega1*(I1 - I3)/I1 */
    const double t249 = JLT_FNMA(t105, t229, t248); /* t248 - gamma1*s*Theta*1/(s*Theta*D)*q*m*a3^2*I3/I1 */
    const double t250 = t74*t114; /* m*R*I1*s*D*1/(s*Theta*D)*d(gyroscopic)/d(gamma1) */
    const double t251 = t44*t73; /* gyroscopic*s*D*1/(s*Theta*D) */
    const double t252 = t73*t251; /* s*D*1/(s*Theta*D)*gyroscopic*s*D*1/(s*Theta*D) */
    const double t253 = p[32]*t252; /* 2*m^2*R^3*I1^2*s*D*1/(s*Theta*D)*gyroscopic*s*D*1/(s*Theta*D) */
    const double t254 = JLT_FNMA(x[0], t253, t250); /* m*R*I1*s*D*1/(s*Theta*D)*d(gyroscopic)/d(gamma1) - gamma1*t253 */
    const double t255 = t74*t129; /* m*R*I1*s*D*1/(s*Theta*D)*d(gyroscopic)/d(gamma2) */
    const double t256 = JLT_FNMA(x[1], t253, t255); /* m*R*I1*s*D*1/(s*Theta*D)*d(gyroscopic)/d(gamma2) - gamma2*t253 */
    const double t257 = t74*t143; /* m*R*I1*s*D*1/(s*Theta*D)*t143 */
    const double t258 = t23*p[33]; /* b*2*m^2*R^2*I1*I3 */
    const double t259 = JLT_FMA(t252, t258, t257); /* s*D*1/(s*Theta*D)*gyroscopic*s*D*1/(s*Theta*D)*b*2*m^2*R^2*I1*I3 + m*R*I1*s*D*1/(s*Theta*D)*t143 */
    const double t260 = -t259; /* -t259 */
    const double t261 = t2*t74; /* gamma3*omega1*m*R*I1*s*D*1/(s*Theta*D) */
    const double t262 = -t261; /* -gamma3*omega1*m*R*I1*s*D*1/(s*Theta*D) */
    const double t263 = t0*t74; /* gamma3*omega2*m*R*I1*s*D*1/(s*Theta*D) */
    const double t264 = -t263; /* -gamma3*omega2*m*R*I1*s*D*1/(s*Theta*D) */
    const double t265 = t18*t74; /* q*m*R*I1*s*D*1/(s*Theta*D) */
    const double t266 = t74*t159; /* m*R*I1*s*D*1/(s*Theta*D)*d(gyroscopic)/d(omega1) */
    const double t267 = t74*t166; /* m*R*I1*s*D*1/(s*Theta*D)*d(gyroscopic)/d(omega2) */
    const double t268 = t74*t170; /* m*R*I1*s*D*1/(s*Theta*D)*(gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - b*I3/I1) */
    const double t269 = -t268; /* -t268 */
    const double t270 = -x[11]; /* -alpha3 */
    const double t271 = -x[9]; /* -alpha1 */
    const double t272 = -x[10]; /* -alpha2 */
    const double t273 = -x[14]; /* -beta3 */
    const double t274 = -x[12]; /* -beta1 */
    const double t275 = -x[13]; /* -beta2 */
    out[0] = t1;
    out[1] = t3;
    out[2] = t7;
    out[3] = t52;
    out[4] = t57;
    out[5] = t60;
    out[6] = t67;
    out[7] = t72;
    out[8] = t75;
    out[9] = t77;
    out[10] = t79;
    out[11] = t81;
    out[12] = t83;
    out[13] = t85;
    out[14] = t87;
    out[15] = t90;
    out[16] = t93;
    out[17] = 0.0;
    out[18] = x[8];
    out[19] = t94;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
    out[24] = t95;
    out[25] = x[1];
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = 0.0;
    out[30] = 0.0;
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = t96;
    out[35] = 0.0;
    out[36] = x[6];
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = 0.0;
    out[40] = x[2];
    out[41] = 0.0;
    out[42] = t97;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = 0.0;
    out[50] = 0.0;
    out[51] = x[7];
    out[52] = t98;
    out[53] = 0.0;
    out[54] = 0.0;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t99;
    out[58] = x[0];
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = 0.0;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[68] = t120;
    out[69] = t133;
    out[70] = t148;
    out[71] = t150;
    out[72] = t151;
    out[73] = t152;
    out[74] = t160;
    out[75] = t168;
    out[76] = t172;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[81] = 0.0;
    out[82] = 0.0;
    out[83] = 0.0;
    out[84] = 0.0;
    out[85] = t176;
    out[86] = t179;
    out[87] = t181;
    out[88] = t182;
    out[89] = t183;
    out[90] = t184;
    out[91] = t186;
    out[92] = t189;
    out[93] = t191;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = 0.0;
    out[100] = 0.0;
    out[101] = 0.0;
    out[102] = t194;
    out[103] = t196;
    out[104] = t198;
    out[105] = x[7];
    out[106] = t98;
    out[107] = 0.0;
    out[108] = t200;
    out[109] = t201;
    out[110] = t202;
    out[111] = 0.0;
    out[112] = 0.0;
    out[113] = 0.0;
    out[114] = 0.0;
    out[115] = 0.0;
    out[116] = 0.0;
    out[117] = 0.0;
    out[118] = 0.0;
    out[119] = t208;
    out[120] = t210;
    out[121] = t217;
    out[122] = t218;
    out[123] = t219;
    out[124] = t221;
    out[125] = t225;
    out[126] = t227;
    out[127] = t231;
    out[128] = 0.0;
    out[129] = 0.0;
    out[130] = 0.0;
    out[131] = 0.0;
    out[132] = 0.0;
    out[133] = 0.0;
    out[134] = 0.0;
    out[135] = 0.0;
    out[136] = t233;
    out[137] = t235;
    out[138] = t237;
    out[139] = t238;
    out[140] = t239;
    out[141] = t241;
    out[142] = t244;
    out[143] = t246;
    out[144] = t249;
    out[145] = 0.0;
    out[146] = 0.0;
    out[147] = 0.0;
    out[148] = 0.0;
    out[149] = 0.0;
    out[150] = 0.0;
    out[151] = 0.0;
    out[152] = 0.0;
    out[153] = t254;
    out[154] = t256;
    out[155] = t260;
    out[156] = t262;
    out[157] = t264;
    out[158] = t265;
    out[159] = t266;
    out[160] = t267;
    out[161] = t269;
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
    out[177] = t270;
    out[178] = x[10];
    out[179] = 0.0;
    out[180] = x[8];
    out[181] = t94;
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
    out[193] = x[11];
    out[194] = 0.0;
    out[195] = t271;
    out[196] = t96;
    out[197] = 0.0;
    out[198] = x[6];
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
    out[210] = t272;
    out[211] = x[9];
    out[212] = 0.0;
    out[213] = x[7];
    out[214] = t98;
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
    out[228] = t273;
    out[229] = x[13];
    out[230] = 0.0;
    out[231] = 0.0;
    out[232] = 0.0;
    out[233] = 0.0;
    out[234] = x[8];
    out[235] = t94;
    out[236] = 0.0;
    out[237] = 0.0;
    out[238] = 0.0;
    out[239] = 0.0;
    out[240] = 0.0;
    out[241] = 0.0;
    out[242] = 0.0;
    out[243] = 0.0;
    out[244] = x[14];
    out[245] = 0.0;
    out[246] = t274;
    out[247] = 0.0;
    out[248] = 0.0;
    out[249] = 0.0;
    out[250] = t96;
    out[251] = 0.0;
    out[252] = x[6];
    out[253] = 0.0;
    out[254] = 0.0;
    out[255] = 0.0;
    out[256] = 0.0;
    out[257] = 0.0;
    out[258] = 0.0;
    out[259] = 0.0;
    out[260] = 0.0;
    out[261] = t275;
    out[262] = x[12];
    out[263] = 0.0;
    out[264] = 0.0;
    out[265] = 0.0;
    out[266] = 0.0;
    out[267] = x[7];
    out[268] = t98;
    out[269] = 0.0;
    out[270] = 0.0;
    out[271] = 0.0;
    out[272] = 0.0;
    out[273] = 0.0;
    out[274] = 0.0;
    out[275] = x[9];
    out[276] = x[10];
    out[277] = x[11];
    out[278] = 0.0;
    out[279] = 0.0;
    out[280] = 0.0;
    out[281] = x[3];
    out[282] = x[4];
    out[283] = x[5];
    out[284] = 0.0;
    out[285] = 0.0;
    out[286] = 0.0;
    out[287] = 0.0;
    out[288] = 0.0;
    out[289] = 0.0;
    out[290] = 0.0;
    out[291] = 0.0;
    out[292] = x[12];
    out[293] = x[13];
    out[294] = x[14];
    out[295] = 0.0;
    out[296] = 0.0;
    out[297] = 0.0;
    out[298] = 0.0;
    out[299] = 0.0;
    out[300] = 0.0;
    out[301] = x[3];
    out[302] = x[4];
    out[303] = x[5];
    out[304] = 0.0;
    out[305] = 0.0;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* gamma2*gamma2 */
    const double t1 = JLT_FMA(x[0], x[0], t0); /* gamma1*gamma1 + gamma2*gamma2 */
    const double t2 = sqrt(t1); /* s = sqrt(gamma1*gamma1 + gamma2*gamma2) */
    const double t3 = x[1]*x[6]; /* gamma2*omega1 */
    const double t4 = JLT_FNMA(x[0], x[7], t3); /* gamma2*omega1 - gamma1*omega2 */
    const double t5 = x[2]*t4; /* gamma3*(gamma2*omega1 - gamma1*omega2) */
    const double t6 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t7 = JLT_FNMA(t4, p[1], x[5]); /* v3 - (gamma2*omega1 - gamma1*omega2)*R */
    const double t8 = x[1]*t7; /* gamma2*(v3 - (gamma2*omega1 - gamma1*omega2)*R) */
    const double t9 = x[2]*p[11]; /* gamma3*2*R */
    const double t10 = JLT_FNMA(t6, p[12], t9); /* gamma3*2*R - b*I3/I1 */
    const double t11 = x[8]*t10; /* omega3*(gamma3*2*R - b*I3/I1) */
    const double t12 = x[0]*x[6]; /* gamma1*omega1 */
    const double t13 = JLT_FMA(x[1], x[7], t12); /* q = gamma2*omega2 + gamma1*omega1 */
    const double t14 = JLT_FMA(p[1], t13, t11); /* R*q + omega3*(gamma3*2*R - b*I3/I1) */
    const double t15 = JLT_FNMA(x[2], x[4], t8); /* gamma2*(v3 - (gamma2*omega1 - gamma1*omega2)*R) - gamma3*v2 */
    const double t16 = JLT_FMA(x[0], t14, t15); /* d(gyroscopic)/d(omega2) = gamma1*(R*q + omega3*(gamma3*2*R - b*I3/I1)) + gamma2*(v3 - (gamma2*omega1 - gamma1*omega2)*R) - gamma3*v2 */
    const double t17 = x[1]*t16; /* gamma2*d(gyroscopic)/d(omega2) */
    const double t18 = x[0]*t7; /* gamma1*(v3 - (gamma2*omega1 - gamma1*omega2)*R) */
    const double t19 = JLT_FNMA(x[2], x[3], t18); /* gamma1*(v3 - (gamma2*omega1 - gamma1*omega2)*R) - gamma3*v1 */
    const double t20 = JLT_FNMA(x[1], t14, t19); /* d(gyroscopic)/d(omega1) = gamma1*(v3 - (gamma2*omega1 - gamma1*omega2)*R) - gamma3*v1 - gamma2*(R*q + omega3*(gamma3*2*R - b*I3/I1)) */
    const double t21 = JLT_FMA(x[0], t20, t17); /* gamma1*d(gyroscopic)/d(omega1) + gamma2*d(gyroscopic)/d(omega2) */
    const double t22 = p[35]*t6; /* m/I1*b */
    const double t23 = JLT_FMA(t21, t22, t5); /* t21*m/I1*b + gamma3*(gamma2*omega1 - gamma1*omega2) */
    const double t24 = t6*p[9]; /* b*m*I3 */
    const double t25 = JLT_FMA(t1, p[8], p[7]); /* (gamma1*gamma1 + gamma2*gamma2)*m*R^2*I1 + I1*I3 */
    const double t26 = JLT_FMA(t6, t24, t25); /* Theta = b*b*m*I3 + (gamma1*gamma1 + gamma2*gamma2)*m*R^2*I1 + I1*I3 */
    const double t27 = JLT_FMA(x[2], x[2], t1); /* one = gamma3*gamma3 + gamma1*gamma1 + gamma2*gamma2 */
    const double t28 = p[4]*t27; /* I1*one */
    const double t29 = JLT_FMA(t1, p[10], t28); /* D = (gamma1*gamma1 + gamma2*gamma2)*m*a3^2 + I1*one */
    const double t30 = t26*t29; /* Theta*D */
    const double t31 = t2*t30; /* s*Theta*D */
    const double t32 = 1.0/t31; /* 1/(s*Theta*D) */
    const double t33 = t29*t32; /* D*1/(s*Theta*D) */
    const double t34 = t26*t33; /* Theta*D*1/(s*Theta*D) */
    const double t35 = t23*t34; /* (t21*m/I1*b + gamma3*(gamma2*omega1 - gamma1*omega2))*Theta*D*1/(s*Theta*D) */
    const double t36 = t34*t35; /* Theta*D*1/(s*Theta*D)*t35 */
    const double t37 = t4*p[36]; /* (gamma2*omega1 - gamma1*omega2)*m*R/I3 */
    const double t38 = JLT_FMA(t10, t37, t36); /* (gamma3*2*R - b*I3/I1)*(gamma2*omega1 - gamma1*omega2)*m*R/I3 + Theta*D*1/(s*Theta*D)*t35 */
    const double t39 = p[34]*t2; /* (-I1*I3)*s */
    const double t40 = t33*t39; /* D*1/(s*Theta*D)*(-I1*I3)*s */
    const double t41 = t38*t40; /* t38*D*1/(s*Theta*D)*(-I1*I3)*s */
    const double t42 = x[2]*p[20]; /* gamma3*2*I1 */
    const double t43 = x[6]*t42; /* omega1*gamma3*2*I1 */
    const double t44 = x[8]*p[5]; /* omega3*I3 */
    const double t45 = JLT_FNMA(x[0], t44, t43); /* omega1*gamma3*2*I1 - gamma1*omega3*I3 */
    const double t46 = x[1]*t45; /* gamma2*(omega1*gamma3*2*I1 - gamma1*omega3*I3) */
    const double t47 = x[7]*t42; /* omega2*gamma3*2*I1 */
    const double t48 = JLT_FNMA(x[1], t44, t47); /* omega2*gamma3*2*I1 - gamma2*omega3*I3 */
    const double t49 = JLT_FNMA(x[0], t48, t46); /* gamma2*(omega1*gamma3*2*I1 - gamma1*omega3*I3) - gamma1*(omega2*gamma3*2*I1 - gamma2*omega3*I3) */
    const double t50 = t26*p[37]; /* Theta*(-m*a3^2/I1) */
    const double t51 = t49*t50; /* t49*Theta*(-m*a3^2/I1) */
    const double t52 = t2*t51; /* s*t49*Theta*(-m*a3^2/I1) */
    const double t53 = JLT_FMA(t32, t52, t41); /* 1/(s*Theta*D)*s*t49*Theta*(-m*a3^2/I1) + t38*D*1/(s*Theta*D)*(-I1*I3)*s */
    out[0] = t53;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t1 = JLT_FMA(x[1], x[1], t0); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t2 = t1 - 1.0; /* gamma2*gamma2 + gamma1*gamma1 - 1 */
    const double t3 = JLT_FMA(x[2], x[2], t2); /* gamma3*gamma3 + gamma2*gamma2 + gamma1*gamma1 - 1 */
    const double t4 = JLT_FMS(x[9], x[9], 1.0); /* alpha1*alpha1 - 1 */
    const double t5 = JLT_FMA(x[10], x[10], t4); /* alpha2*alpha2 + alpha1*alpha1 - 1 */
    const double t6 = JLT_FMA(x[11], x[11], t5); /* alpha3*alpha3 + alpha2*alpha2 + alpha1*alpha1 - 1 */
    const double t7 = JLT_FMS(x[12], x[12], 1.0); /* beta1*beta1 - 1 */
    const double t8 = JLT_FMA(x[13], x[13], t7); /* beta2*beta2 + beta1*beta1 - 1 */
    const double t9 = JLT_FMA(x[14], x[14], t8); /* beta3*beta3 + beta2*beta2 + beta1*beta1 - 1 */
    const double t10 = x[0]*x[9]; /* gamma1*alpha1 */
    const double t11 = JLT_FMA(x[1], x[10], t10); /* gamma2*alpha2 + gamma1*alpha1 */
    const double t12 = JLT_FMA(x[2], x[11], t11); /* gamma3*alpha3 + gamma2*alpha2 + gamma1*alpha1 */
    const double t13 = x[0]*x[12]; /* gamma1*beta1 */
    const double t14 = JLT_FMA(x[1], x[13], t13); /* gamma2*beta2 + gamma1*beta1 */
    const double t15 = JLT_FMA(x[2], x[14], t14); /* gamma3*beta3 + gamma2*beta2 + gamma1*beta1 */
    const double t16 = x[9]*x[12]; /* alpha1*beta1 */
    const double t17 = JLT_FMA(x[10], x[13], t16); /* alpha2*beta2 + alpha1*beta1 */
    const double t18 = JLT_FMA(x[11], x[14], t17); /* alpha3*beta3 + alpha2*beta2 + alpha1*beta1 */
    const double t19 = x[0]*x[3]; /* gamma1*v1 */
    const double t20 = x[0]*x[7]; /* gamma1*omega2 */
    const double t21 = JLT_FNMA(x[1], x[6], t20); /* dgamma3 = gamma1*omega2 - gamma2*omega1 */
    const double t22 = JLT_FMA(x[1], x[4], t19); /* gamma2*v2 + gamma1*v1 */
    const double t23 = JLT_FMA(x[2], x[5], t22); /* gamma3*v3 + gamma2*v2 + gamma1*v1 */
    const double t24 = JLT_FNMA(p[3], t21, t23); /* gamma3*v3 + gamma2*v2 + gamma1*v1 - a3*dgamma3 */
    const double t25 = x[0]*x[4]; /* gamma1*v2 */
    const double t26 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t27 = x[0]*x[6]; /* gamma1*omega1 */
    const double t28 = JLT_FMA(x[1], x[7], t27); /* q = gamma2*omega2 + gamma1*omega1 */
    const double t29 = p[1]*x[8]; /* R*omega3 */
    const double t30 = JLT_FNMA(x[1], x[3], t25); /* gamma1*v2 - gamma2*v1 */
    const double t31 = JLT_FMA(t26, t28, t30); /* b*q + gamma1*v2 - gamma2*v1 */
    const double t32 = JLT_FNMA(t1, t29, t31); /* b*q + gamma1*v2 - gamma2*v1 - (gamma2*gamma2 + gamma1*gamma1)*R*omega3 */
    const double t33 = t28*p[4]; /* q*I1 */
    const double t34 = x[2]*p[5]; /* gamma3*I3 */
    const double t35 = JLT_FMA(x[8], t34, t33); /* omega3*gamma3*I3 + q*I1 */
    const double t36 = p[38]*t35; /* (-R)*(omega3*gamma3*I3 + q*I1) */
    const double t37 = JLT_FMA(x[8], p[39], t36); /* omega3*(-a3*I3) + (-R)*(omega3*gamma3*I3 + q*I1) */
    out[0] = t3;
    out[1] = t6;
    out[2] = t9;
    out[3] = t12;
    out[4] = t15;
    out[5] = t18;
    out[6] = t24;
    out[7] = t32;
    out[8] = t37;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 2.0*x[0]; /* 2*gamma1 */
    const double t1 = 2.0*x[1]; /* 2*gamma2 */
    const double t2 = 2.0*x[2]; /* 2*gamma3 */
    const double t3 = 2.0*x[9]; /* 2*alpha1 */
    const double t4 = 2.0*x[10]; /* 2*alpha2 */
    const double t5 = 2.0*x[11]; /* 2*alpha3 */
    const double t6 = 2.0*x[12]; /* 2*beta1 */
    const double t7 = 2.0*x[13]; /* 2*beta2 */
    const double t8 = 2.0*x[14]; /* 2*beta3 */
    const double t9 = JLT_FNMA(p[3], x[7], x[3]); /* v1 - a3*omega2 */
    const double t10 = JLT_FMA(p[3], x[6], x[4]); /* a3*omega1 + v2 */
    const double t11 = x[1]*p[3]; /* gamma2*a3 */
    const double t12 = x[0]*p[40]; /* gamma1*(-a3) */
    const double t13 = x[2] + p[41]; /* gamma3 + a3/R */
    const double t14 = p[1]*t13; /* b = R*(gamma3 + a3/R) */
    const double t15 = p[11]*x[8]; /* 2*R*omega3 */
    const double t16 = JLT_FNMA(x[0], t15, x[4]); /* v2 - gamma1*2*R*omega3 */
    const double t17 = JLT_FMA(x[6], t14, t16); /* omega1*b + v2 - gamma1*2*R*omega3 */
    const double t18 = JLT_FMA(x[1], t15, x[3]); /* gamma2*2*R*omega3 + v1 */
    const double t19 = JLT_FMS(x[7], t14, t18); /* omega2*b - (gamma2*2*R*omega3 + v1) */
    const double t20 = x[0]*x[6]; /* gamma1*omega1 */
    const double t21 = JLT_FMA(x[1], x[7], t20); /* q = gamma2*omega2 + gamma1*omega1 */
    const double t22 = p[1]*t21; /* R*q */
    const double t23 = -x[1]; /* -gamma2 */
    const double t24 = x[0]*t14; /* gamma1*b */
    const double t25 = x[1]*t14; /* gamma2*b */
    const double t26 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t27 = JLT_FMA(x[1], x[1], t26); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t28 = p[38]*t27; /* (-R)*(gamma2*gamma2 + gamma1*gamma1) */
    const double t29 = x[6]*p[42]; /* omega1*(-R*I1) */
    const double t30 = x[7]*p[42]; /* omega2*(-R*I1) */
    const double t31 = x[8]*p[43]; /* omega3*(-R*I3) */
    const double t32 = x[0]*p[42]; /* gamma1*(-R*I1) */
    const double t33 = x[1]*p[42]; /* gamma2*(-R*I1) */
    const double t34 = t13*p[43]; /* (gamma3 + a3/R)*(-R*I3) */
    out[0] = t0;
    out[1] = t1;
    out[2] = t2;
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
    out[26] = t3;
    out[27] = t4;
    out[28] = t5;
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
    out[46] = t6;
    out[47] = t7;
    out[48] = t8;
    out[49] = 0.0;
    out[50] = 0.0;
    out[51] = x[9];
    out[52] = x[10];
    out[53] = x[11];
    out[54] = 0.0;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = 0.0;
    out[60] = x[0];
    out[61] = x[1];
    out[62] = x[2];
    out[63] = 0.0;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[68] = x[12];
    out[69] = x[13];
    out[70] = x[14];
    out[71] = 0.0;
    out[72] = 0.0;
    out[73] = 0.0;
    out[74] = 0.0;
    out[75] = 0.0;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = x[0];
    out[81] = x[1];
    out[82] = x[2];
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
    out[94] = x[12];
    out[95] = x[13];
    out[96] = x[14];
    out[97] = x[9];
    out[98] = x[10];
    out[99] = x[11];
    out[100] = 0.0;
    out[101] = 0.0;
    out[102] = t9;
    out[103] = t10;
    out[104] = x[5];
    out[105] = x[0];
    out[106] = x[1];
    out[107] = x[2];
    out[108] = t11;
    out[109] = t12;
    out[110] = 0.0;
    out[111] = 0.0;
    out[112] = 0.0;
    out[113] = 0.0;
    out[114] = 0.0;
    out[115] = 0.0;
    out[116] = 0.0;
    out[117] = 0.0;
    out[118] = 0.0;
    out[119] = t17;
    out[120] = t19;
    out[121] = t22;
    out[122] = t23;
    out[123] = x[0];
    out[124] = 0.0;
    out[125] = t24;
    out[126] = t25;
    out[127] = t28;
    out[128] = 0.0;
    out[129] = 0.0;
    out[130] = 0.0;
    out[131] = 0.0;
    out[132] = 0.0;
    out[133] = 0.0;
    out[134] = 0.0;
    out[135] = 0.0;
    out[136] = t29;
    out[137] = t30;
    out[138] = t31;
    out[139] = 0.0;
    out[140] = 0.0;
    out[141] = 0.0;
    out[142] = t32;
    out[143] = t33;
    out[144] = t34;
    out[145] = 0.0;
    out[146] = 0.0;
    out[147] = 0.0;
    out[148] = 0.0;
    out[149] = 0.0;
    out[150] = 0.0;
    out[151] = 0.0;
    out[152] = 0.0;
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
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
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
    double t81[JLT_JET_ORDER_MAX + 1];
    double t82[JLT_JET_ORDER_MAX + 1];
    double t83[JLT_JET_ORDER_MAX + 1];
    double t84[JLT_JET_ORDER_MAX + 1];
    double t86[JLT_JET_ORDER_MAX + 1];
    double t87[JLT_JET_ORDER_MAX + 1];
    double t89[JLT_JET_ORDER_MAX + 1];
    double t90[JLT_JET_ORDER_MAX + 1];
    double t91[JLT_JET_ORDER_MAX + 1];
    double t92[JLT_JET_ORDER_MAX + 1];
    double t93[JLT_JET_ORDER_MAX + 1];
    double t94[JLT_JET_ORDER_MAX + 1];
    double t95[JLT_JET_ORDER_MAX + 1];
    double t97[JLT_JET_ORDER_MAX + 1];
    double t99[JLT_JET_ORDER_MAX + 1];
    double t101[JLT_JET_ORDER_MAX + 1];
    double t102[JLT_JET_ORDER_MAX + 1];
    double t104[JLT_JET_ORDER_MAX + 1];
    double t105[JLT_JET_ORDER_MAX + 1];
    double t106[JLT_JET_ORDER_MAX + 1];
    double t108[JLT_JET_ORDER_MAX + 1];
    double t110[JLT_JET_ORDER_MAX + 1];
    double t111[JLT_JET_ORDER_MAX + 1];
    double t113[JLT_JET_ORDER_MAX + 1];
    double t114[JLT_JET_ORDER_MAX + 1];
    double t115[JLT_JET_ORDER_MAX + 1];
    double t116[JLT_JET_ORDER_MAX + 1];
    double t117[JLT_JET_ORDER_MAX + 1];
    double t118[JLT_JET_ORDER_MAX + 1];
    double t119[JLT_JET_ORDER_MAX + 1];
    double t120[JLT_JET_ORDER_MAX + 1];
    double t121[JLT_JET_ORDER_MAX + 1];
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
        t18[k] = jlt_jet_product(x1, x1, k);
        t19[k] = jlt_jet_product(x0, x0, k) + t18[k];
        t20[k] = jlt_jet_root(t19[k], t20, k);
        t22[k] = jlt_jet_product(x2, x2, k) + t19[k];
        t23[k] = p[6]*t22[k];
        t26[k] = jlt_jet_product(x6, x6, k);
        t27[k] = jlt_jet_product(x7, x7, k) + t26[k];
        t28[k] = x2[k]*p[4];
        t29[k] = jlt_jet_product(t27, t28, k);
        t31[k] = jlt_jet_product(x6, x0, k);
        t32[k] = jlt_jet_product(x1, x7, k) + t31[k];
        t33[k] = x8[k]*p[5];
        t34[k] = t29[k] - jlt_jet_product(t32, t33, k);
        t35[k] = t23[k] - p[3]*t34[k];
        t39[k] = x2[k]*p[1] + (k == 0 ? p[3] : 0);
        t41[k] = t39[k]*p[9];
        t42[k] = t19[k]*p[8] + (k == 0 ? p[7] : 0);
        t43[k] = jlt_jet_product(t39, t41, k) + t42[k];
        t44[k] = t22[k]*p[4];
        t46[k] = t19[k]*p[10] + t44[k];
        t47[k] = jlt_jet_product(t43, t46, k);
        t48[k] = jlt_jet_product(t20, t47, k);
        t50[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t48, t50, k);
        t51[k] = jlt_jet_product(t43, t50, k);
        t52[k] = jlt_jet_product(t20, t35, k);
        t53[k] = jlt_jet_product(t51, t52, k);
        t54[k] = (k == 0 ? p[2] : 0) - t53[k];
        t55[k] = jlt_jet_product(x5, t32, k);
        t57[k] = jlt_jet_product(x6, x3, k);
        t58[k] = jlt_jet_product(x7, x4, k) + t57[k];
        t60[k] = x2[k]*p[11];
        t62[k] = t60[k] - t39[k]*p[12];
        t63[k] = jlt_jet_product(x8, t62, k);
        t64[k] = t32[k]*p[1] + t63[k];
        t65[k] = t55[k] - jlt_jet_product(x2, t58, k);
        t66[k] = t65[k] - jlt_jet_product(t12, t64, k);
        t67[k] = jlt_jet_product(t20, t46, k);
        t68[k] = jlt_jet_product(t66, t67, k);
        t69[k] = jlt_jet_product(t50, t68, k);
        t70[k] = jlt_jet_product(t46, t51, k);
        t71[k] = jlt_jet_product(t69, t70, k);
        t72[k] = jlt_jet_product(t70, t71, k);
        t73[k] = jlt_jet_product(x1, t72, k);
        t74[k] = t15[k] - jlt_jet_product(x7, x5, k);
        t75[k] = t74[k] - jlt_jet_product(x0, t54, k);
        t76[k] = p[7]*t73[k] + t75[k];
        t77[k] = jlt_jet_product(x6, x5, k);
        t78[k] = jlt_jet_product(x0, t72, k);
        t79[k] = t77[k] - jlt_jet_product(x8, x3, k);
        t80[k] = t79[k] - jlt_jet_product(x1, t54, k);
        t81[k] = t80[k] - p[7]*t78[k];
        t82[k] = jlt_jet_product(x7, x3, k);
        t83[k] = t82[k] - jlt_jet_product(x6, x4, k);
        t84[k] = t83[k] - jlt_jet_product(x2, t54, k);
        t86[k] = x8[k]*p[13];
        t87[k] = jlt_jet_product(x7, t86, k);
        t89[k] = t53[k]*p[14];
        t90[k] = jlt_jet_product(x1, t89, k) + t87[k];
        t91[k] = t90[k] - jlt_jet_product(t41, t78, k);
        t92[k] = jlt_jet_product(x6, t86, k);
        t93[k] = jlt_jet_product(x0, t89, k) + t92[k];
        t94[k] = jlt_jet_product(t41, t73, k) + t93[k];
        t95[k] = -t94[k];
        t97[k] = t69[k]*p[15];
        t99[k] = jlt_jet_product(x8, x10, k);
        t101[k] = t99[k] - jlt_jet_product(x7, x11, k);
        t102[k] = jlt_jet_product(x6, x11, k);
        t104[k] = t102[k] - jlt_jet_product(x8, x9, k);
        t105[k] = jlt_jet_product(x7, x9, k);
        t106[k] = t105[k] - jlt_jet_product(x6, x10, k);
        t108[k] = jlt_jet_product(x8, x13, k);
        t110[k] = t108[k] - jlt_jet_product(x7, x14, k);
        t111[k] = jlt_jet_product(x6, x14, k);
        t113[k] = t111[k] - jlt_jet_product(x8, x12, k);
        t114[k] = jlt_jet_product(x7, x12, k);
        t115[k] = t114[k] - jlt_jet_product(x6, x13, k);
        t116[k] = jlt_jet_product(x3, x9, k);
        t117[k] = jlt_jet_product(x4, x10, k) + t116[k];
        t118[k] = jlt_jet_product(x5, x11, k) + t117[k];
        t119[k] = jlt_jet_product(x3, x12, k);
        t120[k] = jlt_jet_product(x4, x13, k) + t119[k];
        t121[k] = jlt_jet_product(x5, x14, k) + t120[k];
        double *restrict next = coefficients + (k + 1)*17;
        next[0] = x0[k + 1] = t5[k]/(k + 1);
        next[1] = x1[k + 1] = t9[k]/(k + 1);
        next[2] = x2[k + 1] = t13[k]/(k + 1);
        next[3] = x3[k + 1] = t76[k]/(k + 1);
        next[4] = x4[k + 1] = t81[k]/(k + 1);
        next[5] = x5[k + 1] = t84[k]/(k + 1);
        next[6] = x6[k + 1] = t91[k]/(k + 1);
        next[7] = x7[k + 1] = t95[k]/(k + 1);
        next[8] = x8[k + 1] = t97[k]/(k + 1);
        next[9] = x9[k + 1] = t101[k]/(k + 1);
        next[10] = x10[k + 1] = t104[k]/(k + 1);
        next[11] = x11[k + 1] = t106[k]/(k + 1);
        next[12] = x12[k + 1] = t110[k]/(k + 1);
        next[13] = x13[k + 1] = t113[k]/(k + 1);
        next[14] = x14[k + 1] = t115[k]/(k + 1);
        next[15] = x15[k + 1] = t118[k]/(k + 1);
        next[16] = x16[k + 1] = t121[k]/(k + 1);
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
    .state_count = 17, .param_count = 6, .block_count = 44,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 17, { 4, 46, 39, 1, 1, 0, 15, 15 }, { 60, 153, 0, 13, 1, 0, 10, 15 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 289, { 30, 118, 83, 1, 1, 0, 18, 40 }, { 257, 1113, 0, 139, 1, 0, 15, 23 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 306, { 33, 133, 108, 1, 1, 0, 19, 44 }, { 303, 1231, 0, 151, 1, 0, 15, 23 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 0, 30, 22, 1, 1, 0, 15, 11 }, { 28, 97, 0, 10, 1, 0, 15, 14 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 9, { 1, 12, 25, 0, 0, 0, 6, 6 }, { 28, 41, 0, 0, 1, 0, 7, 6 },
        "takes s = sqrt(gamma1^2 + gamma2^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 153, { 2, 25, 8, 0, 0, 0, 3, 5 }, { 19, 44, 0, 0, 1, 0, 6, 4 },
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
