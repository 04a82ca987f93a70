/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23   13    1    0    0      7   10   (105)
 *  jacobian            8   70   32    1    0    0      9   19   (480)
 *  rhs_jacobian        14   72   34    1    0    0     10   27   (563)
 *  divergence          0    8    9    1    0    0      9    7   (53)
 *  integral_values     0   12    9    0    0    0      7    5   (40)
 *  integral_gradients  0   15    7    0    0    0      5    5   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular;
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
    out[19] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[8] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[9] = t8;
    const double t9 = params[0]*params[2]; /* m*g */
    const double t10 = params[3]*t9; /* a3*m*g */
    out[23] = t10;
    const double t11 = t10/params[4]; /* a3*m*g/I1 */
    out[10] = t11;
    const double t12 = params[1]*params[4]; /* R*I1 */
    out[42] = t12;
    const double t13 = params[5]/t12; /* I3/(R*I1) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[43] = t14;
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
    const double t22 = params[5]*params[4]; /* I3*I1 */
    out[16] = t22;
    const double t23 = t1*params[4]; /* m*R*R*I1 */
    out[17] = t23;
    const double t24 = params[0]*params[5]; /* m*I3 */
    out[18] = t24;
    const double t25 = params[0]*2.0; /* m*2 */
    const double t26 = t5*t25; /* a3*a3*m*2 */
    out[20] = t26;
    const double t27 = params[4]*2.0; /* I1*2 */
    out[21] = t27;
    const double t28 = -params[5]; /* -I3 */
    out[22] = t28;
    const double t29 = params[2]*t25; /* g*m*2 */
    const double t30 = params[3]*t29; /* a3*g*m*2 */
    out[24] = t30;
    const double t31 = params[3]*t14; /* a3*m*R */
    const double t32 = params[5]*t31; /* I3*a3*m*R */
    out[25] = t32;
    const double t33 = params[5]*t14; /* I3*m*R */
    out[26] = t33;
    const double t34 = params[0]*params[3]; /* m*a3 */
    const double t35 = params[5]*t34; /* I3*m*a3 */
    out[27] = t35;
    const double t36 = params[5]*params[5]; /* I3*I3 */
    out[28] = t36;
    const double t37 = params[1]*t25; /* R*m*2 */
    const double t38 = params[5]*t37; /* I3*R*m*2 */
    out[29] = t38;
    const double t39 = t0*t25; /* R*R*m*2 */
    const double t40 = params[4]*t39; /* I1*R*R*m*2 */
    out[30] = t40;
    const double t41 = params[4]*t31; /* I1*a3*m*R */
    out[31] = t41;
    const double t42 = t1*t19; /* m*R*R*(I1 - I3) */
    out[32] = t42;
    const double t43 = params[4]*t14; /* I1*m*R */
    out[33] = t43;
    const double t44 = -t43; /* -I1*m*R */
    out[34] = t44;
    const double t45 = t19*t39; /* (I1 - I3)*R*R*m*2 */
    out[35] = t45;
    const double t46 = params[3]*t37; /* a3*R*m*2 */
    const double t47 = params[5]*t46; /* I3*a3*R*m*2 */
    out[36] = t47;
    const double t48 = params[0]/2.0; /* m/2 */
    out[37] = t48;
    const double t49 = params[2]*2.0; /* g*2 */
    const double t50 = params[3]*t49; /* a3*g*2 */
    out[38] = t50;
    const double t51 = 1.0/params[0]; /* 1/m */
    out[39] = t51;
    const double t52 = params[4]/params[0]; /* I1/m */
    out[40] = t52;
    const double t53 = params[5]/params[0]; /* I3/m */
    out[41] = t53;
    const double t54 = params[1]*params[5]; /* R*I3 */
    const double t55 = -t54; /* -R*I3 */
    out[44] = t55;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[2]; /* s*omega_tau */
    const double t1 = x[5]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[5]*x[4]; /* s*omega3 */
    const double t5 = JLT_FMA(p[1], t4, t3); /* R*s*omega3 + omega_n*b */
    const double t6 = x[3]*t5; /* omega_n*(R*s*omega3 + omega_n*b) */
    out[1] = t6;
    const double t7 = x[5]*x[5]; /* s*s */
    const double t8 = t2*p[7]; /* b*I3/(R^2*I1) */
    const double t9 = p[6] + t7; /* I3/(m*R^2) + s*s */
    const double t10 = JLT_FMA(t2, t8, t9); /* Theta/(m*R^2*I1) = b*b*I3/(R^2*I1) + I3/(m*R^2) + s*s */
    const double t11 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t12 = t0*p[8]; /* s*omega_tau*m*a3^2/I1 */
    const double t13 = t11*t12; /* s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 */
    const double t14 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t15 = JLT_FMA(t4, p[9], t14); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t16 = JLT_FNMA(t7, p[10], t13); /* s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 - s*s*m*g*a3/I1 */
    const double t17 = JLT_FNMA(x[3], t15, t16); /* s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 - s*s*m*g*a3/I1 - omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t18 = JLT_FMA(t7, p[8], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t19 = t10*t18; /* Theta/(m*R^2*I1)*D/I1 */
    const double t20 = 1.0/t19; /* 1/(Theta/(m*R^2*I1)*D/I1) */
    const double t21 = t10*t17; /* Theta/(m*R^2*I1)*t17 */
    const double t22 = t20*t21; /* 1/(Theta/(m*R^2*I1)*D/I1)*Theta/(m*R^2*I1)*t17 */
    out[2] = t22;
    const double t23 = x[2]*t14; /* omega_tau*omega_n*gamma3 */
    const double t24 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t25 = p[12] + t24; /* I3/(m*R) + e */
    const double t26 = t0*x[4]; /* s*omega_tau*omega3 */
    const double t27 = p[11]*t26; /* I3/(R*I1)*s*omega_tau*omega3 */
    const double t28 = t25*t27; /* (I3/(m*R) + e)*I3/(R*I1)*s*omega_tau*omega3 */
    const double t29 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t30 = x[3]*t29; /* omega_n*V */
    const double t31 = JLT_FNMA(t8, t30, t28); /* (I3/(m*R) + e)*I3/(R*I1)*s*omega_tau*omega3 - b*I3/(R^2*I1)*omega_n*V */
    const double t32 = t18*t20; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t33 = JLT_FMA(t31, t32, t23); /* t31*1/(Theta/(m*R^2*I1)) + omega_tau*omega_n*gamma3 */
    out[3] = t33;
    const double t34 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/I1 - gamma3*R*(I1 - I3)/I1 */
    const double t35 = JLT_FMA(t26, t34, t30); /* s*omega_tau*omega3*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) + omega_n*V */
    const double t36 = x[5]*p[13]; /* s*(-1/R) */
    const double t37 = t35*t36; /* t35*s*(-1/R) */
    const double t38 = t32*t37; /* 1/(Theta/(m*R^2*I1))*t35*s*(-1/R) */
    out[4] = t38;
    const double t39 = -t11; /* -s*omega_tau*gamma3 */
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
    const double t10 = x[5]*x[3]; /* s*omega_n */
    const double t11 = p[1]*t10; /* R*s*omega_n */
    out[10] = t11;
    const double t12 = x[3]*x[4]; /* omega_n*omega3 */
    const double t13 = p[1]*t12; /* R*omega_n*omega3 */
    out[11] = t13;
    const double t14 = t1*p[8]; /* s*omega_tau*m*a3^2/I1 */
    const double t15 = JLT_FMS(t1, t14, t3); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n */
    const double t16 = p[4]*t15; /* I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t17 = t5*p[18]; /* b*m*I3 */
    const double t18 = JLT_FMA(t0, p[17], p[16]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t19 = JLT_FMA(t5, t17, t18); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t20 = JLT_FMA(t0, p[19], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t21 = t19*t20; /* Theta*D */
    const double t22 = 1.0/t21; /* 1/(Theta*D) */
    const double t23 = t19*t22; /* 1/D = Theta*1/(Theta*D) */
    const double t24 = t16*t23; /* I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n)*1/D */
    out[12] = t24;
    const double t25 = t1*p[20]; /* s*omega_tau*2*m*a3^2 */
    const double t26 = x[5]*x[0]; /* s*gamma3 */
    const double t27 = t25*t26; /* s*omega_tau*2*m*a3^2*s*gamma3 */
    const double t28 = t23*t27; /* 1/D*s*omega_tau*2*m*a3^2*s*gamma3 */
    out[14] = t28;
    const double t29 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t30 = t8*p[5]; /* s*omega3*I3 */
    const double t31 = JLT_FMA(p[21], t29, t30); /* 2*I1*omega_n*gamma3 + s*omega3*I3 */
    const double t32 = t23*t31; /* 1/D*(2*I1*omega_n*gamma3 + s*omega3*I3) */
    const double t33 = -t32; /* -1/D*(2*I1*omega_n*gamma3 + s*omega3*I3) */
    out[15] = t33;
    const double t34 = t10*p[22]; /* s*omega_n*(-I3) */
    const double t35 = t23*t34; /* 1/D*s*omega_n*(-I3) */
    out[16] = t35;
    const double t36 = t0*p[23]; /* s*s*m*g*a3 */
    const double t37 = JLT_FMA(x[3], t30, t36); /* omega_n*s*omega3*I3 + s*s*m*g*a3 */
    const double t38 = JLT_FNMA(x[0], t16, t37); /* omega_n*s*omega3*I3 + s*s*m*g*a3 - gamma3*I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t39 = x[5]*p[20]; /* s*2*m*a3^2 */
    const double t40 = t38*t39; /* t38*s*2*m*a3^2 */
    const double t41 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t42 = t25*t41; /* s*omega_tau*2*m*a3^2*omega_tau*gamma3 */
    const double t43 = JLT_FNMA(x[5], p[24], t42); /* s*omega_tau*2*m*a3^2*omega_tau*gamma3 - s*2*m*g*a3 */
    const double t44 = JLT_FNMA(t12, p[5], t43); /* d(numerator of d(omega_tau)/dt over D)/d(s) = s*omega_tau*2*m*a3^2*omega_tau*gamma3 - s*2*m*g*a3 - omega_n*omega3*I3 */
    const double t45 = JLT_FMA(t23, t40, t44); /* 1/D*t38*s*2*m*a3^2 + d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t46 = t23*t45; /* 1/D*t45 */
    out[17] = t46;
    const double t47 = t1*x[4]; /* s*omega_tau*omega3 */
    const double t48 = p[25]*t47; /* m*R*a3*I3*s*omega_tau*omega3 */
    const double t49 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t50 = JLT_FMA(x[2], t49, x[1]); /* V = omega_tau*e + v_nu */
    const double t51 = x[3]*t50; /* omega_n*V */
    const double t52 = x[2]*p[27]; /* omega_tau*m*a3*I3 */
    const double t53 = JLT_FNMA(t6, t52, t48); /* m*R*a3*I3*s*omega_tau*omega3 - omega_n*b*omega_tau*m*a3*I3 */
    const double t54 = JLT_FNMA(p[26], t51, t53); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = m*R*a3*I3*s*omega_tau*omega3 - omega_n*b*omega_tau*m*a3*I3 - m*R*I3*omega_n*V */
    const double t55 = t20*t22; /* 1/Theta = D*1/(Theta*D) */
    const double t56 = t54*t55; /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3)*1/Theta */
    const double t57 = x[3]*t17; /* omega_n*b*m*I3 */
    const double t58 = t50*t57; /* V*omega_n*b*m*I3 */
    const double t59 = JLT_FMA(p[26], t49, p[28]); /* m*R*I3*e + I3^2 */
    const double t60 = JLT_FMS(t47, t59, t58); /* numerator of d(omega_n)/dt over Theta = s*omega_tau*omega3*(m*R*I3*e + I3^2) - V*omega_n*b*m*I3 */
    const double t61 = t55*t55; /* 1/Theta*1/Theta */
    const double t62 = t5*p[29]; /* b*2*m*R*I3 */
    const double t63 = t61*t62; /* 1/Theta*1/Theta*b*2*m*R*I3 */
    const double t64 = JLT_FMA(x[2], x[3], t56); /* omega_tau*omega_n + d(numerator of d(omega_n)/dt over Theta)/d(gamma3)*1/Theta */
    const double t65 = JLT_FNMA(t60, t63, t64); /* t64 - numerator of d(omega_n)/dt over Theta*1/Theta*1/Theta*b*2*m*R*I3 */
    out[18] = t65;
    const double t66 = t55*t57; /* 1/Theta*omega_n*b*m*I3 */
    const double t67 = -t66; /* -1/Theta*omega_n*b*m*I3 */
    out[19] = t67;
    const double t68 = t49*t57; /* e*omega_n*b*m*I3 */
    const double t69 = JLT_FMS(t8, t59, t68); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(m*R*I3*e + I3^2) - e*omega_n*b*m*I3 */
    const double t70 = JLT_FMA(t55, t69, t29); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[20] = t70;
    const double t71 = t50*t55; /* V*1/Theta */
    const double t72 = JLT_FNMA(t17, t71, t41); /* omega_tau*gamma3 - b*m*I3*V*1/Theta */
    out[21] = t72;
    const double t73 = t55*t59; /* 1/Theta*(m*R*I3*e + I3^2) */
    const double t74 = t1*t73; /* s*omega_tau*1/Theta*(m*R*I3*e + I3^2) */
    out[22] = t74;
    const double t75 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t76 = t73*t75; /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 */
    const double t77 = x[5]*p[30]; /* s*2*m*R^2*I1 */
    const double t78 = t61*t77; /* 1/Theta*1/Theta*s*2*m*R^2*I1 */
    const double t79 = JLT_FNMA(t60, t78, t76); /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 - numerator of d(omega_n)/dt over Theta*1/Theta*1/Theta*s*2*m*R^2*I1 */
    out[23] = t79;
    const double t80 = x[3]*p[31]; /* omega_n*m*R*a3*I1 */
    const double t81 = t1*t80; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t82 = t1*t8; /* s*omega_tau*s*omega3 */
    const double t83 = JLT_FMS(p[32], t82, t81); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = m*R^2*(I1 - I3)*s*omega_tau*s*omega3 - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t84 = t55*t83; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t85 = t10*p[33]; /* s*omega_n*m*R*I1 */
    const double t86 = t50*t85; /* V*s*omega_n*m*R*I1 */
    const double t87 = JLT_FNMA(x[0], p[32], p[25]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t88 = JLT_FMA(t82, t87, t86); /* s*omega_tau*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*s*omega_n*m*R*I1 */
    const double t89 = JLT_FMA(t63, t88, t84); /* 1/Theta*1/Theta*b*2*m*R*I3*t88 + 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    out[24] = t89;
    const double t90 = t55*t85; /* 1/Theta*s*omega_n*m*R*I1 */
    const double t91 = -t90; /* -1/Theta*s*omega_n*m*R*I1 */
    out[25] = t91;
    const double t92 = t49*t85; /* e*s*omega_n*m*R*I1 */
    const double t93 = x[5]*t87; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t94 = JLT_FMA(t8, t93, t92); /* s*omega3*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*s*omega_n*m*R*I1 */
    const double t95 = t55*t94; /* 1/Theta*t94 */
    const double t96 = -t95; /* -1/Theta*t94 */
    out[26] = t96;
    const double t97 = x[5]*p[34]; /* s*(-m*R*I1) */
    const double t98 = t71*t97; /* V*1/Theta*s*(-m*R*I1) */
    out[27] = t98;
    const double t99 = t1*t93; /* s*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t100 = t55*t99; /* 1/Theta*s*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t101 = -t100; /* -1/Theta*s*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[28] = t101;
    const double t102 = x[0]*p[35]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t103 = t47*t102; /* s*omega_tau*omega3*gamma3*2*m*R^2*(I1 - I3) */
    const double t104 = JLT_FNMA(t47, p[36], t103); /* s*omega_tau*omega3*gamma3*2*m*R^2*(I1 - I3) - s*omega_tau*omega3*2*m*R*a3*I3 */
    const double t105 = JLT_FNMA(t51, p[33], t104); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t104 - omega_n*V*m*R*I1 */
    const double t106 = t55*t105; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t107 = JLT_FMA(t78, t88, t106); /* 1/Theta*1/Theta*s*2*m*R^2*I1*t88 + 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    out[29] = t107;
    const double t108 = -t1; /* -s*omega_tau */
    out[30] = t108;
    const double t109 = -t26; /* -s*gamma3 */
    out[32] = t109;
    const double t110 = -t41; /* -omega_tau*gamma3 */
    out[35] = t110;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[2]; /* s*omega_tau */
    const double t1 = x[5]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[3]*t3; /* omega_n*omega_n*b */
    const double t5 = x[3]*p[1]; /* omega_n*R */
    const double t6 = x[5]*x[4]; /* s*omega3 */
    const double t7 = JLT_FMA(t5, t6, t4); /* omega_n*R*s*omega3 + omega_n*omega_n*b */
    out[1] = t7;
    const double t8 = x[3]*x[3]; /* omega_n*omega_n */
    const double t9 = t0*p[8]; /* s*omega_tau*m*a3^2/I1 */
    const double t10 = JLT_FNMA(t0, t9, t8); /* omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t11 = p[4]*t10; /* I1*(omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1) */
    const double t12 = x[5]*x[5]; /* s*s */
    out[8] = t12;
    const double t13 = p[23]*t12; /* m*g*a3*s*s */
    const double t14 = x[3]*p[5]; /* omega_n*I3 */
    const double t15 = JLT_FMA(t6, t14, t13); /* s*omega3*omega_n*I3 + m*g*a3*s*s */
    const double t16 = JLT_FMA(x[0], t11, t15); /* gamma3*I1*(omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1) + s*omega3*omega_n*I3 + m*g*a3*s*s */
    const double t17 = t2*p[18]; /* b*m*I3 */
    const double t18 = JLT_FMA(t12, p[17], p[16]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t19 = JLT_FMA(t2, t17, t18); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t20 = JLT_FMA(t12, p[19], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t21 = t19*t20; /* Theta*D */
    const double t22 = 1.0/t21; /* 1/(Theta*D) */
    const double t23 = t19*t22; /* 1/D = Theta*1/(Theta*D) */
    const double t24 = t16*t23; /* t16*1/D */
    const double t25 = -t24; /* -t16*1/D */
    out[2] = t25;
    const double t26 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t27 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t28 = JLT_FMA(x[2], t27, x[1]); /* V = omega_tau*e + v_nu */
    const double t29 = t3*p[18]; /* omega_n*b*m*I3 */
    const double t30 = t28*t29; /* V*omega_n*b*m*I3 */
    const double t31 = JLT_FMA(t27, p[26], p[28]); /* e*m*R*I3 + I3^2 */
    const double t32 = t0*x[4]; /* s*omega_tau*omega3 */
    const double t33 = JLT_FMS(t31, t32, t30); /* numerator of d(omega_n)/dt over Theta = (e*m*R*I3 + I3^2)*s*omega_tau*omega3 - V*omega_n*b*m*I3 */
    const double t34 = t20*t22; /* 1/Theta = D*1/(Theta*D) */
    const double t35 = t33*t34; /* numerator of d(omega_n)/dt over Theta*1/Theta */
    const double t36 = JLT_FMA(x[0], t26, t35); /* gamma3*omega_tau*omega_n + numerator of d(omega_n)/dt over Theta*1/Theta */
    out[3] = t36;
    const double t37 = x[3]*t28; /* omega_n*V */
    const double t38 = x[5]*p[33]; /* s*m*R*I1 */
    const double t39 = t37*t38; /* omega_n*V*s*m*R*I1 */
    const double t40 = JLT_FNMA(x[0], p[32], p[25]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t41 = t6*t40; /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t42 = JLT_FMA(t0, t41, t39); /* s*omega_tau*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + omega_n*V*s*m*R*I1 */
    const double t43 = t34*t42; /* 1/Theta*t42 */
    const double t44 = -t43; /* -1/Theta*t42 */
    out[4] = t44;
    const double t45 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t46 = -t45; /* -s*omega_tau*gamma3 */
    out[5] = t46;
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
    const double t47 = t0*2.0; /* s*omega_tau*2 */
    out[11] = t47;
    const double t48 = x[3]*t5; /* omega_n*omega_n*R */
    out[12] = t48;
    const double t49 = t3*2.0; /* omega_n*b*2 */
    const double t50 = JLT_FMA(p[1], t6, t49); /* R*s*omega3 + omega_n*b*2 */
    out[15] = t50;
    const double t51 = x[5]*t5; /* s*omega_n*R */
    out[16] = t51;
    const double t52 = t5*x[4]; /* omega_n*R*omega3 */
    out[17] = t52;
    const double t53 = t11*t23; /* I1*(omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1)*1/D */
    const double t54 = -t53; /* -I1*(omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1)*1/D */
    out[18] = t54;
    const double t55 = x[5]*t23; /* s*1/D */
    const double t56 = p[20]*t55; /* 2*m*a3^2*s*1/D */
    const double t57 = t45*t56; /* s*omega_tau*gamma3*2*m*a3^2*s*1/D */
    out[20] = t57;
    const double t58 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t59 = p[21]*t58; /* 2*I1*omega_n*gamma3 */
    const double t60 = JLT_FMA(t6, p[5], t59); /* s*omega3*I3 + 2*I1*omega_n*gamma3 */
    const double t61 = t23*t60; /* 1/D*(s*omega3*I3 + 2*I1*omega_n*gamma3) */
    const double t62 = -t61; /* -1/D*(s*omega3*I3 + 2*I1*omega_n*gamma3) */
    out[21] = t62;
    const double t63 = t14*t55; /* omega_n*I3*s*1/D */
    const double t64 = -t63; /* -omega_n*I3*s*1/D */
    out[22] = t64;
    const double t65 = x[2]*p[20]; /* omega_tau*2*m*a3^2 */
    const double t66 = t45*t65; /* s*omega_tau*gamma3*omega_tau*2*m*a3^2 */
    const double t67 = JLT_FNMA(x[5], p[24], t66); /* s*omega_tau*gamma3*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t68 = JLT_FNMA(x[4], t14, t67); /* d(numerator of d(omega_tau)/dt over D)/d(s) = s*omega_tau*gamma3*omega_tau*2*m*a3^2 - s*2*m*g*a3 - omega3*omega_n*I3 */
    const double t69 = JLT_FMA(t16, t56, t68); /* t16*2*m*a3^2*s*1/D + d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t70 = t23*t69; /* 1/D*t69 */
    out[23] = t70;
    const double t71 = t32*p[25]; /* s*omega_tau*omega3*m*R*a3*I3 */
    const double t72 = t26*p[27]; /* omega_tau*omega_n*m*a3*I3 */
    const double t73 = JLT_FNMA(t2, t72, t71); /* s*omega_tau*omega3*m*R*a3*I3 - b*omega_tau*omega_n*m*a3*I3 */
    const double t74 = JLT_FNMA(p[26], t37, t73); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = s*omega_tau*omega3*m*R*a3*I3 - b*omega_tau*omega_n*m*a3*I3 - m*R*I3*omega_n*V */
    const double t75 = t34*t35; /* 1/Theta*numerator of d(omega_n)/dt over Theta*1/Theta */
    const double t76 = t2*p[29]; /* b*2*m*R*I3 */
    const double t77 = JLT_FMA(t34, t74, t26); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(gamma3) + omega_tau*omega_n */
    const double t78 = JLT_FNMA(t75, t76, t77); /* t77 - 1/Theta*numerator of d(omega_n)/dt over Theta*1/Theta*b*2*m*R*I3 */
    out[24] = t78;
    const double t79 = t29*t34; /* omega_n*b*m*I3*1/Theta */
    const double t80 = -t79; /* -omega_n*b*m*I3*1/Theta */
    out[25] = t80;
    const double t81 = t27*t29; /* e*omega_n*b*m*I3 */
    const double t82 = JLT_FMS(t6, t31, t81); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(e*m*R*I3 + I3^2) - e*omega_n*b*m*I3 */
    const double t83 = JLT_FMA(t34, t82, t58); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[26] = t83;
    const double t84 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t85 = t28*t34; /* V*1/Theta */
    const double t86 = JLT_FNMA(t17, t85, t84); /* omega_tau*gamma3 - b*m*I3*V*1/Theta */
    out[27] = t86;
    const double t87 = t31*t34; /* (e*m*R*I3 + I3^2)*1/Theta */
    const double t88 = t0*t87; /* s*omega_tau*(e*m*R*I3 + I3^2)*1/Theta */
    out[28] = t88;
    const double t89 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t90 = t87*t89; /* (e*m*R*I3 + I3^2)*1/Theta*omega_tau*omega3 */
    const double t91 = x[5]*p[30]; /* s*2*m*R^2*I1 */
    const double t92 = JLT_FNMA(t75, t91, t90); /* (e*m*R*I3 + I3^2)*1/Theta*omega_tau*omega3 - 1/Theta*numerator of d(omega_n)/dt over Theta*1/Theta*s*2*m*R^2*I1 */
    out[29] = t92;
    const double t93 = x[3]*p[31]; /* omega_n*m*R*a3*I1 */
    const double t94 = t0*t93; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t95 = t0*p[32]; /* s*omega_tau*m*R^2*(I1 - I3) */
    const double t96 = JLT_FMS(t6, t95, t94); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = s*omega3*s*omega_tau*m*R^2*(I1 - I3) - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t97 = JLT_FMA(t43, t76, t96); /* 1/Theta*t42*b*2*m*R*I3 + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t98 = t34*t97; /* 1/Theta*t97 */
    out[30] = t98;
    const double t99 = x[3]*t38; /* omega_n*s*m*R*I1 */
    const double t100 = t34*t99; /* 1/Theta*omega_n*s*m*R*I1 */
    const double t101 = -t100; /* -1/Theta*omega_n*s*m*R*I1 */
    out[31] = t101;
    const double t102 = t27*t99; /* e*omega_n*s*m*R*I1 */
    const double t103 = JLT_FMA(x[5], t41, t102); /* s*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*omega_n*s*m*R*I1 */
    const double t104 = t34*t103; /* 1/Theta*t103 */
    const double t105 = -t104; /* -1/Theta*t103 */
    out[32] = t105;
    const double t106 = t38*t85; /* s*m*R*I1*V*1/Theta */
    const double t107 = -t106; /* -s*m*R*I1*V*1/Theta */
    out[33] = t107;
    const double t108 = t1*t40; /* s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t109 = t34*t108; /* 1/Theta*s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t110 = -t109; /* -1/Theta*s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[34] = t110;
    const double t111 = x[0]*p[35]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t112 = t32*t111; /* s*omega_tau*omega3*gamma3*2*m*R^2*(I1 - I3) */
    const double t113 = JLT_FNMA(t32, p[36], t112); /* s*omega_tau*omega3*gamma3*2*m*R^2*(I1 - I3) - s*omega_tau*omega3*2*m*R*a3*I3 */
    const double t114 = JLT_FNMA(t37, p[33], t113); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t113 - omega_n*V*m*R*I1 */
    const double t115 = JLT_FMA(t43, t91, t114); /* 1/Theta*t42*s*2*m*R^2*I1 + d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t116 = t34*t115; /* 1/Theta*t115 */
    out[35] = t116;
    const double t117 = -t0; /* -s*omega_tau */
    out[36] = t117;
    const double t118 = x[5]*x[0]; /* s*gamma3 */
    const double t119 = -t118; /* -s*gamma3 */
    out[38] = t119;
    const double t120 = -t84; /* -omega_tau*gamma3 */
    out[41] = t120;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[0]*t1; /* gamma3*omega_tau*s*s */
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = p[32]*t2; /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s */
    const double t5 = JLT_FNMA(p[25], t1, t4); /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s - m*R*a3*I3*omega_tau*s*s */
    const double t6 = p[20]*t2; /* 2*m*a3^2*gamma3*omega_tau*s*s */
    const double t7 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t8 = JLT_FMA(x[2], t7, x[1]); /* V = omega_tau*e + v_nu */
    const double t9 = p[18]*t3; /* m*I3*b */
    const double t10 = JLT_FNMA(t8, t9, t5); /* t5 - V*m*I3*b */
    const double t11 = JLT_FMA(p[19], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t12 = JLT_FMA(p[17], t0, p[16]); /* m*R^2*I1*s*s + I1*I3 */
    const double t13 = JLT_FMA(t3, t9, t12); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t14 = t10*t11; /* (t5 - V*m*I3*b)*D */
    const double t15 = JLT_FMA(t6, t13, t14); /* 2*m*a3^2*gamma3*omega_tau*s*s*Theta + (t5 - V*m*I3*b)*D */
    const double t16 = t11*t13; /* D*Theta */
    const double t17 = t15/t16; /* (2*m*a3^2*gamma3*omega_tau*s*s*Theta + (t5 - V*m*I3*b)*D)/(D*Theta) */
    out[0] = t17;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[38]*x[0]; /* 2*g*a3*gamma3 */
    const double t1 = JLT_FMA(x[1], x[1], t0); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t2 = p[40]*x[3]; /* I1/m*omega_n */
    const double t3 = JLT_FMA(x[3], t2, t1); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t4 = p[19]*x[5]; /* m*a3^2*s */
    const double t5 = JLT_FMA(x[5], t4, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t6 = p[39]*x[2]; /* 1/m*omega_tau */
    const double t7 = x[2]*t6; /* omega_tau*1/m*omega_tau */
    const double t8 = p[41]*x[4]; /* I3/m*omega3 */
    const double t9 = JLT_FMA(x[4], t8, t3); /* omega3*I3/m*omega3 + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t10 = JLT_FMA(t5, t7, t9); /* D*omega_tau*1/m*omega_tau + t9 */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = x[3]*t11; /* omega_n*b */
    const double t13 = x[5]*p[1]; /* s*R */
    const double t14 = JLT_FMA(x[4], t13, t12); /* v_tau = omega3*s*R + omega_n*b */
    const double t15 = JLT_FMA(t14, t14, t10); /* energy/(1/2*m) = v_tau*v_tau + D*omega_tau*1/m*omega_tau + t9 */
    const double t16 = p[37]*t15; /* 1/2*m*energy/(1/2*m) */
    out[0] = t16;
    const double t17 = x[5]*p[42]; /* s*R*I1 */
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
    const double t1 = x[4]*p[44]; /* omega3*(-R*I3) */
    out[6] = t1;
    const double t2 = x[5]*p[42]; /* s*R*I1 */
    out[9] = t2;
    const double t3 = x[3]*p[42]; /* omega_n*R*I1 */
    out[11] = t3;
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = p[22]*t4; /* (-I3)*b */
    out[10] = t5;
    const double t6 = x[3]*t4; /* omega_n*b */
    const double t7 = p[0]*t4; /* m*b */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(x[5], t8, t6); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = x[5]*p[19]; /* s*m*a3^2 */
    const double t11 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t12 = t10*t11; /* s*m*a3^2*omega_tau*omega_tau */
    const double t13 = JLT_FMA(x[5], t10, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = x[2]*t13; /* omega_tau*D */
    out[2] = t14;
    const double t15 = p[43]*t9; /* m*R*v_tau */
    const double t16 = JLT_FMA(x[4], t15, t12); /* d(energy)/d(s) = omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    out[5] = t16;
    const double t17 = JLT_FMA(x[3], t15, p[23]); /* d(energy)/d(gamma3) = omega_n*m*R*v_tau + m*g*a3 */
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
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
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
    double t50[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
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
        t18[k] = t8[k]*p[18];
        t19[k] = p[17]*t16[k] + (k == 0 ? p[16] : 0);
        t20[k] = jlt_jet_product(t8, t18, k) + t19[k];
        t22[k] = jlt_jet_product(t2, x0, k);
        t23[k] = t2[k]*p[8];
        t24[k] = jlt_jet_product(t22, t23, k);
        t26[k] = jlt_jet_product(x3, x0, k);
        t28[k] = t11[k]*p[9] + t26[k];
        t29[k] = t24[k] - t16[k]*p[10];
        t30[k] = t29[k] - jlt_jet_product(x3, t28, k);
        t32[k] = t16[k]*p[8] + (k == 0 ? 1.0 : 0);
        t33[k] = jlt_jet_product(t20, t32, k);
        t34[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t33, t34, k);
        t35[k] = jlt_jet_product(t20, t30, k);
        t36[k] = jlt_jet_product(t34, t35, k);
        t39[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t40[k] = (k == 0 ? p[12] : 0) + t39[k];
        t41[k] = jlt_jet_product(x2, t11, k);
        t42[k] = p[26]*t41[k];
        t43[k] = jlt_jet_product(t40, t42, k);
        t45[k] = jlt_jet_product(x2, t39, k) + x1[k];
        t46[k] = jlt_jet_product(x3, t45, k);
        t47[k] = t43[k] - jlt_jet_product(t18, t46, k);
        t48[k] = jlt_jet_product(t32, t34, k);
        t49[k] = jlt_jet_product(t47, t48, k);
        t50[k] = jlt_jet_product(x2, t26, k) + t49[k];
        t54[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t55[k] = jlt_jet_product(t41, t54, k) + t46[k];
        t56[k] = x5[k]*p[34];
        t57[k] = jlt_jet_product(t55, t56, k);
        t58[k] = jlt_jet_product(t48, t57, k);
        t59[k] = -t22[k];
        double *restrict next = coefficients + (k + 1)*7;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t13[k]/(k + 1);
        next[2] = x2[k + 1] = t36[k]/(k + 1);
        next[3] = x3[k + 1] = t50[k]/(k + 1);
        next[4] = x4[k + 1] = t58[k]/(k + 1);
        next[5] = x5[k + 1] = t59[k]/(k + 1);
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "G", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 45,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 6, { 3, 23, 13, 1, 0, 0, 7, 10 }, { 17, 78, 0, 10, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 36, { 11, 64, 33, 1, 0, 0, 13, 19 }, { 56, 375, 0, 49, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 42, { 14, 72, 34, 1, 0, 0, 10, 27 }, { 67, 437, 0, 59, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 0, 8, 9, 1, 0, 0, 9, 7 }, { 10, 39, 0, 4, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 2, { 0, 12, 9, 0, 0, 0, 7, 5 }, { 9, 31, 0, 0, 0, 0, 10, 5 },
        "" },
    .integral_gradients = { integral_gradients, 12, { 0, 15, 7, 0, 0, 0, 5, 5 }, { 9, 37, 0, 0, 0, 0, 6, 6 },
        "" },
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
        &jlt_batch_spherical_top_general_in_regular_baseline,
        &jlt_batch_spherical_top_general_in_regular_avx2,
        &jlt_batch_spherical_top_general_in_regular_avx512,
    },
};
