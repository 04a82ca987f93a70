/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   23   14    1    0    0      7   10   (105)
 *  jacobian            11   66   32    1    0    0     12   17   (480)
 *  rhs_jacobian        12   70   34    1    0    0     11   26   (563)
 *  divergence          0    8    9    1    0    0      9    7   (53)
 *  integral_values     0   12    9    0    0    0      7    5   (40)
 *  integral_gradients  0   15    7    0    0    0      5    5   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
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
    const double t0 = params[4]*params[5]; /* I1*I3 */
    out[6] = t0;
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    const double t3 = params[4]*t2; /* I1*m*R*R */
    out[7] = t3;
    const double t4 = params[5]*params[0]; /* I3*m */
    out[8] = t4;
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[17] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[9] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[10] = t8;
    const double t9 = params[0]*params[2]; /* m*g */
    const double t10 = params[3]*t9; /* a3*m*g */
    out[20] = t10;
    const double t11 = t10/params[4]; /* a3*m*g/I1 */
    out[11] = t11;
    const double t12 = params[0]*params[1]; /* m*R */
    out[38] = t12;
    const double t13 = params[5]*t12; /* I3*m*R */
    out[12] = t13;
    const double t14 = params[5]/t12; /* I3/(m*R) */
    out[13] = t14;
    const double t15 = params[4]*t12; /* I1*m*R */
    out[29] = t15;
    const double t16 = -t15; /* -I1*m*R */
    out[14] = t16;
    const double t17 = params[5]*params[3]; /* I3*a3 */
    const double t18 = t17/params[4]; /* I3*a3/I1 */
    out[15] = t18;
    const double t19 = params[4] - params[5]; /* I1 - I3 */
    const double t20 = params[1]*t19; /* R*(I1 - I3) */
    const double t21 = t20/params[4]; /* R*(I1 - I3)/I1 */
    out[16] = t21;
    const double t22 = params[0]*2.0; /* m*2 */
    const double t23 = t5*t22; /* a3*a3*m*2 */
    out[18] = t23;
    const double t24 = params[4]*2.0; /* I1*2 */
    out[19] = t24;
    const double t25 = params[2]*t22; /* g*m*2 */
    const double t26 = params[3]*t25; /* a3*g*m*2 */
    out[21] = t26;
    const double t27 = params[3]*t12; /* a3*m*R */
    const double t28 = params[5]*t27; /* I3*a3*m*R */
    out[22] = t28;
    const double t29 = params[0]*params[3]; /* m*a3 */
    const double t30 = params[5]*t29; /* I3*m*a3 */
    out[23] = t30;
    const double t31 = params[5]*params[5]; /* I3*I3 */
    out[24] = t31;
    const double t32 = params[1]*t22; /* R*m*2 */
    const double t33 = params[5]*t32; /* I3*R*m*2 */
    out[25] = t33;
    const double t34 = t1*t22; /* R*R*m*2 */
    const double t35 = params[4]*t34; /* I1*R*R*m*2 */
    out[26] = t35;
    const double t36 = params[4]*t27; /* I1*a3*m*R */
    out[27] = t36;
    const double t37 = t2*t19; /* m*R*R*(I1 - I3) */
    out[28] = t37;
    const double t38 = t19*t34; /* (I1 - I3)*R*R*m*2 */
    out[30] = t38;
    const double t39 = params[3]*t32; /* a3*R*m*2 */
    const double t40 = params[5]*t39; /* I3*a3*R*m*2 */
    out[31] = t40;
    const double t41 = params[0]/2.0; /* m/2 */
    out[32] = t41;
    const double t42 = params[2]*2.0; /* g*2 */
    const double t43 = params[3]*t42; /* a3*g*2 */
    out[33] = t43;
    const double t44 = 1.0/params[0]; /* 1/m */
    out[34] = t44;
    const double t45 = params[4]/params[0]; /* I1/m */
    out[35] = t45;
    const double t46 = params[5]/params[0]; /* I3/m */
    out[36] = t46;
    const double t47 = params[4]*params[1]; /* I1*R */
    out[37] = t47;
    const double t48 = params[5]*params[1]; /* I3*R */
    const double t49 = -t48; /* -I3*R */
    out[39] = t49;
    const double t50 = -params[5]; /* -I3 */
    out[40] = t50;
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
    const double t8 = t2*p[8]; /* b*m*I3 */
    const double t9 = JLT_FMA(p[7], t7, p[6]); /* m*R^2*I1*s*s + I1*I3 */
    const double t10 = JLT_FMA(t2, t8, t9); /* Theta = b*b*m*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t11 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t12 = t0*p[9]; /* s*omega_tau*m*a3^2/I1 */
    const double t13 = t11*t12; /* s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 */
    const double t14 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t15 = JLT_FMA(t4, p[10], t14); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t16 = JLT_FNMA(t7, p[11], t13); /* s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 - s*s*m*g*a3/I1 */
    const double t17 = JLT_FNMA(x[3], t15, t16); /* s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 - s*s*m*g*a3/I1 - omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t18 = JLT_FMA(t7, p[9], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t19 = t10*t18; /* Theta*D/I1 */
    const double t20 = 1.0/t19; /* 1/(Theta*D/I1) */
    const double t21 = t10*t17; /* Theta*t17 */
    const double t22 = t20*t21; /* 1/(Theta*D/I1)*Theta*t17 */
    out[2] = t22;
    const double t23 = x[2]*t14; /* omega_tau*omega_n*gamma3 */
    const double t24 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t25 = p[13] + t24; /* I3/(m*R) + e */
    const double t26 = t0*x[4]; /* s*omega_tau*omega3 */
    const double t27 = p[12]*t26; /* m*R*I3*s*omega_tau*omega3 */
    const double t28 = t25*t27; /* (I3/(m*R) + e)*m*R*I3*s*omega_tau*omega3 */
    const double t29 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t30 = x[3]*t29; /* omega_n*V */
    const double t31 = JLT_FNMA(t8, t30, t28); /* (I3/(m*R) + e)*m*R*I3*s*omega_tau*omega3 - b*m*I3*omega_n*V */
    const double t32 = t18*t20; /* 1/Theta = D/I1*1/(Theta*D/I1) */
    const double t33 = JLT_FMA(t31, t32, t23); /* ((I3/(m*R) + e)*m*R*I3*s*omega_tau*omega3 - b*m*I3*omega_n*V)*1/Theta + omega_tau*omega_n*gamma3 */
    out[3] = t33;
    const double t34 = JLT_FNMA(x[0], p[16], p[15]); /* a3*I3/I1 - gamma3*R*(I1 - I3)/I1 */
    const double t35 = JLT_FMA(t26, t34, t30); /* s*omega_tau*omega3*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) + omega_n*V */
    const double t36 = x[5]*p[14]; /* s*(-m*R*I1) */
    const double t37 = t35*t36; /* t35*s*(-m*R*I1) */
    const double t38 = t32*t37; /* 1/Theta*t35*s*(-m*R*I1) */
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
    const double t5 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t6 = x[3]*t5; /* omega_n*b */
    const double t7 = 2.0*t6; /* 2*omega_n*b */
    const double t8 = x[5]*x[4]; /* s*omega3 */
    const double t9 = JLT_FMA(p[1], t8, t7); /* R*s*omega3 + 2*omega_n*b */
    out[9] = t9;
    const double t10 = x[5]*t3; /* s*omega_n*R */
    out[10] = t10;
    const double t11 = t3*x[4]; /* omega_n*R*omega3 */
    out[11] = t11;
    const double t12 = x[3]*p[4]; /* omega_n*I1 */
    const double t13 = x[3]*t12; /* omega_n*omega_n*I1 */
    const double t14 = t1*p[17]; /* s*omega_tau*m*a3^2 */
    const double t15 = JLT_FNMA(t1, t14, t13); /* omega_n*omega_n*I1 - s*omega_tau*s*omega_tau*m*a3^2 */
    const double t16 = t5*p[8]; /* b*m*I3 */
    const double t17 = JLT_FMA(t0, p[7], p[6]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t18 = JLT_FMA(t5, t16, t17); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t19 = JLT_FMA(t0, p[17], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t20 = t18*t19; /* Theta*D */
    const double t21 = 1.0/t20; /* 1/(Theta*D) */
    const double t22 = t18*t21; /* 1/D = Theta*1/(Theta*D) */
    const double t23 = t15*t22; /* (omega_n*omega_n*I1 - s*omega_tau*s*omega_tau*m*a3^2)*1/D */
    const double t24 = -t23; /* -(omega_n*omega_n*I1 - s*omega_tau*s*omega_tau*m*a3^2)*1/D */
    out[12] = t24;
    const double t25 = x[5]*x[0]; /* s*gamma3 */
    const double t26 = t1*p[18]; /* s*omega_tau*2*m*a3^2 */
    const double t27 = t25*t26; /* s*gamma3*s*omega_tau*2*m*a3^2 */
    const double t28 = t22*t27; /* 1/D*s*gamma3*s*omega_tau*2*m*a3^2 */
    out[14] = t28;
    const double t29 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t30 = p[19]*t29; /* 2*I1*omega_n*gamma3 */
    const double t31 = JLT_FMA(t8, p[5], t30); /* s*omega3*I3 + 2*I1*omega_n*gamma3 */
    const double t32 = t22*t31; /* 1/D*(s*omega3*I3 + 2*I1*omega_n*gamma3) */
    const double t33 = -t32; /* -1/D*(s*omega3*I3 + 2*I1*omega_n*gamma3) */
    out[15] = t33;
    const double t34 = x[3]*p[5]; /* omega_n*I3 */
    const double t35 = x[5]*t22; /* s*1/D */
    const double t36 = t34*t35; /* omega_n*I3*s*1/D */
    const double t37 = -t36; /* -omega_n*I3*s*1/D */
    out[16] = t37;
    const double t38 = t0*p[20]; /* s*s*m*g*a3 */
    const double t39 = JLT_FMA(t8, t34, t38); /* s*omega3*omega_n*I3 + s*s*m*g*a3 */
    const double t40 = JLT_FMA(x[0], t15, t39); /* gamma3*(omega_n*omega_n*I1 - s*omega_tau*s*omega_tau*m*a3^2) + s*omega3*omega_n*I3 + s*s*m*g*a3 */
    const double t41 = p[18]*t40; /* 2*m*a3^2*t40 */
    const double t42 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t43 = t26*t42; /* s*omega_tau*2*m*a3^2*omega_tau*gamma3 */
    const double t44 = JLT_FNMA(x[5], p[21], t43); /* s*omega_tau*2*m*a3^2*omega_tau*gamma3 - s*2*m*g*a3 */
    const double t45 = JLT_FNMA(x[4], t34, t44); /* d(numerator of d(omega_tau)/dt over D)/d(s) = s*omega_tau*2*m*a3^2*omega_tau*gamma3 - s*2*m*g*a3 - omega3*omega_n*I3 */
    const double t46 = JLT_FMA(t35, t41, t45); /* s*1/D*2*m*a3^2*t40 + d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t47 = t22*t46; /* 1/D*t46 */
    out[17] = t47;
    const double t48 = t1*x[4]; /* s*omega_tau*omega3 */
    const double t49 = p[22]*t48; /* m*R*a3*I3*s*omega_tau*omega3 */
    const double t50 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t51 = JLT_FMA(x[2], t50, x[1]); /* V = omega_tau*e + v_nu */
    const double t52 = x[3]*t51; /* omega_n*V */
    const double t53 = x[2]*p[23]; /* omega_tau*m*a3*I3 */
    const double t54 = JLT_FNMA(t6, t53, t49); /* m*R*a3*I3*s*omega_tau*omega3 - omega_n*b*omega_tau*m*a3*I3 */
    const double t55 = JLT_FNMA(p[12], t52, t54); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = m*R*a3*I3*s*omega_tau*omega3 - omega_n*b*omega_tau*m*a3*I3 - m*R*I3*omega_n*V */
    const double t56 = t6*p[8]; /* omega_n*b*m*I3 */
    const double t57 = t51*t56; /* V*omega_n*b*m*I3 */
    const double t58 = JLT_FMA(p[12], t50, p[24]); /* m*R*I3*e + I3^2 */
    const double t59 = JLT_FMS(t48, t58, t57); /* numerator of d(omega_n)/dt over Theta = s*omega_tau*omega3*(m*R*I3*e + I3^2) - V*omega_n*b*m*I3 */
    const double t60 = t19*t21; /* 1/Theta = D*1/(Theta*D) */
    const double t61 = t5*t60; /* b*1/Theta */
    const double t62 = p[25]*t61; /* 2*m*R*I3*b*1/Theta */
    const double t63 = JLT_FNMA(t59, t62, t55); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) - numerator of d(omega_n)/dt over Theta*2*m*R*I3*b*1/Theta */
    const double t64 = t60*t63; /* 1/Theta*t63 */
    const double t65 = JLT_FMA(x[2], x[3], t64); /* omega_tau*omega_n + 1/Theta*t63 */
    out[18] = t65;
    const double t66 = t56*t60; /* omega_n*b*m*I3*1/Theta */
    const double t67 = -t66; /* -omega_n*b*m*I3*1/Theta */
    out[19] = t67;
    const double t68 = t50*t56; /* e*omega_n*b*m*I3 */
    const double t69 = JLT_FMS(t8, t58, t68); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(m*R*I3*e + I3^2) - e*omega_n*b*m*I3 */
    const double t70 = JLT_FMA(t60, t69, t29); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[20] = t70;
    const double t71 = p[8]*t51; /* m*I3*V */
    const double t72 = JLT_FNMA(t61, t71, t42); /* omega_tau*gamma3 - b*1/Theta*m*I3*V */
    out[21] = t72;
    const double t73 = t1*t58; /* s*omega_tau*(m*R*I3*e + I3^2) */
    const double t74 = t60*t73; /* 1/Theta*s*omega_tau*(m*R*I3*e + I3^2) */
    out[22] = t74;
    const double t75 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t76 = t58*t75; /* (m*R*I3*e + I3^2)*omega_tau*omega3 */
    const double t77 = x[5]*t60; /* s*1/Theta */
    const double t78 = p[26]*t77; /* 2*m*R^2*I1*s*1/Theta */
    const double t79 = JLT_FNMA(t59, t78, t76); /* (m*R*I3*e + I3^2)*omega_tau*omega3 - numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    const double t80 = t60*t79; /* 1/Theta*t79 */
    out[23] = t80;
    const double t81 = x[3]*p[27]; /* omega_n*m*R*a3*I1 */
    const double t82 = t1*t81; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t83 = t1*t8; /* s*omega_tau*s*omega3 */
    const double t84 = JLT_FMS(p[28], t83, t82); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = m*R^2*(I1 - I3)*s*omega_tau*s*omega3 - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t85 = t52*p[29]; /* omega_n*V*m*R*I1 */
    const double t86 = x[5]*t85; /* s*omega_n*V*m*R*I1 */
    const double t87 = JLT_FNMA(x[0], p[28], p[22]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t88 = JLT_FMA(t83, t87, t86); /* s*omega_tau*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + s*omega_n*V*m*R*I1 */
    const double t89 = JLT_FMA(t62, t88, t84); /* 2*m*R*I3*b*1/Theta*t88 + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t90 = t60*t89; /* 1/Theta*t89 */
    out[24] = t90;
    const double t91 = t77*p[29]; /* s*1/Theta*m*R*I1 */
    const double t92 = x[3]*t91; /* omega_n*s*1/Theta*m*R*I1 */
    const double t93 = -t92; /* -omega_n*s*1/Theta*m*R*I1 */
    out[25] = t93;
    const double t94 = t50*t92; /* e*omega_n*s*1/Theta*m*R*I1 */
    const double t95 = t77*t87; /* s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t96 = JLT_FMA(t8, t95, t94); /* s*omega3*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*omega_n*s*1/Theta*m*R*I1 */
    const double t97 = -t96; /* -t96 */
    out[26] = t97;
    const double t98 = t51*t91; /* V*s*1/Theta*m*R*I1 */
    const double t99 = -t98; /* -V*s*1/Theta*m*R*I1 */
    out[27] = t99;
    const double t100 = t1*t95; /* s*omega_tau*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t101 = -t100; /* -s*omega_tau*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[28] = t101;
    const double t102 = x[0]*p[30]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t103 = JLT_FMS(t48, t102, t85); /* s*omega_tau*omega3*gamma3*2*m*R^2*(I1 - I3) - omega_n*V*m*R*I1 */
    const double t104 = JLT_FNMA(t48, p[31], t103); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t103 - s*omega_tau*omega3*2*m*R*a3*I3 */
    const double t105 = JLT_FMA(t78, t88, t104); /* 2*m*R^2*I1*s*1/Theta*t88 + d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t106 = t60*t105; /* 1/Theta*t105 */
    out[29] = t106;
    const double t107 = -t1; /* -s*omega_tau */
    out[30] = t107;
    const double t108 = -t25; /* -s*gamma3 */
    out[32] = t108;
    const double t109 = -t42; /* -omega_tau*gamma3 */
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
    const double t2 = p[8]*t0; /* m*I3*b */
    const double t3 = JLT_FMA(p[7], t1, p[6]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t0, t2, t3); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(p[17], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t6 = p[20]*t1; /* m*g*a3*s*s */
    const double t7 = t4*t5; /* Theta*D */
    const double t8 = 1.0/t7; /* 1/(Theta*D) */
    const double t9 = t5*t8; /* 1/Theta = D*1/(Theta*D) */
    const double t10 = t4*t8; /* 1/D = Theta*1/(Theta*D) */
    const double t11 = x[5]*x[2]; /* s*omega_tau */
    const double t12 = x[5]*t11; /* s*s*omega_tau */
    out[0] = t12;
    const double t13 = 2.0*t11; /* 2*s*omega_tau */
    out[11] = t13;
    const double t14 = -t11; /* -s*omega_tau */
    out[36] = t14;
    const double t15 = x[3]*t0; /* omega_n*b */
    const double t16 = p[25]*t0; /* 2*m*R*I3*b */
    const double t17 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t18 = JLT_FMA(x[2], t17, x[1]); /* V = omega_tau*e + v_nu */
    const double t19 = t2*t18; /* m*I3*b*V */
    const double t20 = p[8]*t15; /* m*I3*omega_n*b */
    const double t21 = x[4]*t11; /* omega3*s*omega_tau */
    const double t22 = x[3]*p[29]; /* omega_n*m*R*I1 */
    const double t23 = x[5]*x[4]; /* s*omega3 */
    const double t24 = p[17]*t11; /* m*a3^2*s*omega_tau */
    const double t25 = t11*t24; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t26 = t18*t20; /* V*m*I3*omega_n*b */
    const double t27 = JLT_FMA(p[12], t17, p[24]); /* m*R*I3*e + I3^2 */
    const double t28 = JLT_FMS(t21, t27, t26); /* numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*(m*R*I3*e + I3^2) - V*m*I3*omega_n*b */
    const double t29 = t9*t28; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t30 = t18*t22; /* V*omega_n*m*R*I1 */
    const double t31 = x[0]*t11; /* gamma3*s*omega_tau */
    const double t32 = -t31; /* -gamma3*s*omega_tau */
    out[5] = t32;
    const double t33 = x[2]*p[18]; /* omega_tau*2*m*a3^2 */
    const double t34 = t31*t33; /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 */
    const double t35 = JLT_FNMA(x[5], p[21], t34); /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t36 = p[22]*t21; /* m*R*a3*I3*omega3*s*omega_tau */
    const double t37 = x[2]*p[23]; /* omega_tau*m*a3*I3 */
    const double t38 = JLT_FNMA(t15, t37, t36); /* m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 */
    const double t39 = x[3]*p[4]; /* omega_n*I1 */
    const double t40 = JLT_FNMA(x[3], t39, t25); /* s*omega_tau*m*a3^2*s*omega_tau - omega_n*omega_n*I1 */
    const double t41 = t10*t40; /* 1/D*(s*omega_tau*m*a3^2*s*omega_tau - omega_n*omega_n*I1) */
    out[18] = t41;
    const double t42 = x[3]*p[5]; /* omega_n*I3 */
    const double t43 = JLT_FMA(t23, t42, t6); /* s*omega3*omega_n*I3 + m*g*a3*s*s */
    const double t44 = JLT_FNMA(x[0], t40, t43); /* s*omega3*omega_n*I3 + m*g*a3*s*s - gamma3*(s*omega_tau*m*a3^2*s*omega_tau - omega_n*omega_n*I1) */
    const double t45 = JLT_FNMA(x[4], t42, t35); /* d(numerator of d(omega_tau)/dt over D)/d(s) = gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 - omega3*omega_n*I3 */
    const double t46 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t47 = JLT_FMA(x[2], t46, t29); /* omega_tau*omega_n*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t47;
    const double t48 = x[5]*t30; /* s*V*omega_n*m*R*I1 */
    const double t49 = JLT_FNMA(x[0], p[28], p[22]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t50 = t11*t23; /* s*omega_tau*s*omega3 */
    const double t51 = JLT_FMA(t49, t50, t48); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*omega_tau*s*omega3 + s*V*omega_n*m*R*I1 */
    const double t52 = x[3]*p[12]; /* omega_n*m*R*I3 */
    const double t53 = JLT_FNMA(t18, t52, t38); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 - V*omega_n*m*R*I3 */
    const double t54 = JLT_FNMA(t16, t29, t53); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) - 2*m*R*I3*b*1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t55 = t9*t54; /* 1/Theta*t54 */
    const double t56 = JLT_FMA(x[2], x[3], t55); /* omega_tau*omega_n + 1/Theta*t54 */
    out[24] = t56;
    const double t57 = p[14]*t18; /* (-m*R*I1)*V */
    const double t58 = x[5]*t9; /* s*1/Theta */
    const double t59 = t57*t58; /* (-m*R*I1)*V*s*1/Theta */
    out[33] = t59;
    const double t60 = t22*t58; /* omega_n*m*R*I1*s*1/Theta */
    const double t61 = t49*t58; /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*1/Theta */
    const double t62 = p[26]*t58; /* 2*m*R^2*I1*s*1/Theta */
    const double t63 = -t60; /* -omega_n*m*R*I1*s*1/Theta */
    out[31] = t63;
    const double t64 = t17*t60; /* e*omega_n*m*R*I1*s*1/Theta */
    const double t65 = t17*t20; /* e*m*I3*omega_n*b */
    const double t66 = t9*t20; /* 1/Theta*m*I3*omega_n*b */
    const double t67 = -t66; /* -1/Theta*m*I3*omega_n*b */
    out[25] = t67;
    const double t68 = JLT_FMS(t23, t27, t65); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(m*R*I3*e + I3^2) - e*m*I3*omega_n*b */
    const double t69 = JLT_FMA(t9, t68, t46); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[26] = t69;
    const double t70 = p[19]*t46; /* 2*I1*omega_n*gamma3 */
    const double t71 = JLT_FMA(p[5], t23, t70); /* I3*s*omega3 + 2*I1*omega_n*gamma3 */
    const double t72 = t9*t27; /* 1/Theta*(m*R*I3*e + I3^2) */
    const double t73 = t10*t71; /* 1/D*(I3*s*omega3 + 2*I1*omega_n*gamma3) */
    const double t74 = -t73; /* -1/D*(I3*s*omega3 + 2*I1*omega_n*gamma3) */
    out[21] = t74;
    const double t75 = JLT_FMA(t23, t61, t64); /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*1/Theta + e*omega_n*m*R*I1*s*1/Theta */
    const double t76 = -t75; /* -t75 */
    out[32] = t76;
    const double t77 = t11*t61; /* s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*1/Theta */
    const double t78 = -t77; /* -s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*1/Theta */
    out[34] = t78;
    const double t79 = t11*t72; /* s*omega_tau*1/Theta*(m*R*I3*e + I3^2) */
    out[28] = t79;
    const double t80 = x[3]*p[27]; /* omega_n*m*R*a3*I1 */
    const double t81 = t11*t80; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t82 = JLT_FMS(p[28], t50, t81); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = m*R^2*(I1 - I3)*s*omega_tau*s*omega3 - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t83 = x[0]*p[30]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t84 = JLT_FMS(t21, t83, t30); /* omega3*s*omega_tau*gamma3*2*m*R^2*(I1 - I3) - V*omega_n*m*R*I1 */
    const double t85 = JLT_FNMA(p[31], t21, t84); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t84 - 2*m*R*a3*I3*omega3*s*omega_tau */
    const double t86 = JLT_FMA(t51, t62, t85); /* t51*2*m*R^2*I1*s*1/Theta + d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t87 = t9*t86; /* 1/Theta*t86 */
    out[35] = t87;
    const double t88 = t9*t51; /* 1/Theta*t51 */
    const double t89 = JLT_FMA(t16, t88, t82); /* 2*m*R*I3*b*1/Theta*t51 + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t90 = -t88; /* -1/Theta*t51 */
    out[4] = t90;
    const double t91 = t9*t89; /* 1/Theta*t89 */
    out[30] = t91;
    const double t92 = x[5]*t10; /* s*1/D */
    const double t93 = t42*t92; /* omega_n*I3*s*1/D */
    const double t94 = -t93; /* -omega_n*I3*s*1/D */
    out[22] = t94;
    const double t95 = p[18]*t92; /* 2*m*a3^2*s*1/D */
    const double t96 = t31*t95; /* gamma3*s*omega_tau*2*m*a3^2*s*1/D */
    out[20] = t96;
    const double t97 = JLT_FMA(t44, t95, t45); /* t44*2*m*a3^2*s*1/D + d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t98 = t10*t97; /* 1/D*t97 */
    out[23] = t98;
    const double t99 = t10*t44; /* 1/D*t44 */
    const double t100 = -t99; /* -1/D*t44 */
    out[2] = t100;
    const double t101 = p[1]*x[3]; /* R*omega_n */
    const double t102 = x[3]*t101; /* omega_n*R*omega_n */
    out[12] = t102;
    const double t103 = x[5]*t101; /* s*R*omega_n */
    out[16] = t103;
    const double t104 = x[4]*t101; /* omega3*R*omega_n */
    out[17] = t104;
    const double t105 = t23*t101; /* s*omega3*R*omega_n */
    const double t106 = JLT_FMA(x[3], t15, t105); /* omega_n*omega_n*b + s*omega3*R*omega_n */
    out[1] = t106;
    const double t107 = 2.0*t15; /* 2*omega_n*b */
    const double t108 = JLT_FMA(p[1], t23, t107); /* R*s*omega3 + 2*omega_n*b */
    out[15] = t108;
    const double t109 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t110 = t72*t109; /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 */
    const double t111 = JLT_FNMA(t29, t62, t110); /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    out[29] = t111;
    const double t112 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t113 = JLT_FNMA(t9, t19, t112); /* omega_tau*gamma3 - 1/Theta*m*I3*b*V */
    out[27] = t113;
    const double t114 = -t112; /* -omega_tau*gamma3 */
    out[41] = t114;
    const double t115 = x[5]*x[0]; /* s*gamma3 */
    const double t116 = -t115; /* -s*gamma3 */
    out[38] = t116;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[0]*t1; /* gamma3*omega_tau*s*s */
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = p[28]*t2; /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s */
    const double t5 = JLT_FNMA(p[22], t1, t4); /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s - m*R*a3*I3*omega_tau*s*s */
    const double t6 = p[18]*t2; /* 2*m*a3^2*gamma3*omega_tau*s*s */
    const double t7 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t8 = JLT_FMA(x[2], t7, x[1]); /* V = omega_tau*e + v_nu */
    const double t9 = p[8]*t3; /* m*I3*b */
    const double t10 = JLT_FNMA(t8, t9, t5); /* t5 - V*m*I3*b */
    const double t11 = JLT_FMA(p[17], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t12 = JLT_FMA(p[7], t0, p[6]); /* m*R^2*I1*s*s + I1*I3 */
    const double t13 = JLT_FMA(t3, t9, t12); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t14 = t10*t11; /* (t5 - V*m*I3*b)*D */
    const double t15 = JLT_FMA(t6, t13, t14); /* 2*m*a3^2*gamma3*omega_tau*s*s*Theta + (t5 - V*m*I3*b)*D */
    const double t16 = t11*t13; /* D*Theta */
    const double t17 = t15/t16; /* (2*m*a3^2*gamma3*omega_tau*s*s*Theta + (t5 - V*m*I3*b)*D)/(D*Theta) */
    out[0] = t17;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[33]*x[0]; /* 2*g*a3*gamma3 */
    const double t1 = JLT_FMA(x[1], x[1], t0); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t2 = p[35]*x[3]; /* I1/m*omega_n */
    const double t3 = JLT_FMA(x[3], t2, t1); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t4 = p[17]*x[5]; /* m*a3^2*s */
    const double t5 = JLT_FMA(x[5], t4, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t6 = p[34]*x[2]; /* 1/m*omega_tau */
    const double t7 = x[2]*t6; /* omega_tau*1/m*omega_tau */
    const double t8 = p[36]*x[4]; /* I3/m*omega3 */
    const double t9 = JLT_FMA(x[4], t8, t3); /* omega3*I3/m*omega3 + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t10 = JLT_FMA(t5, t7, t9); /* D*omega_tau*1/m*omega_tau + t9 */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = x[3]*t11; /* omega_n*b */
    const double t13 = x[5]*p[1]; /* s*R */
    const double t14 = JLT_FMA(x[4], t13, t12); /* v_tau = omega3*s*R + omega_n*b */
    const double t15 = JLT_FMA(t14, t14, t10); /* energy/(1/2*m) = v_tau*v_tau + D*omega_tau*1/m*omega_tau + t9 */
    const double t16 = p[32]*t15; /* 1/2*m*energy/(1/2*m) */
    out[0] = t16;
    const double t17 = x[5]*p[37]; /* s*R*I1 */
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
    const double t1 = x[4]*p[39]; /* omega3*(-R*I3) */
    out[6] = t1;
    const double t2 = x[5]*p[37]; /* s*R*I1 */
    out[9] = t2;
    const double t3 = x[3]*p[37]; /* omega_n*R*I1 */
    out[11] = t3;
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = p[40]*t4; /* (-I3)*b */
    out[10] = t5;
    const double t6 = x[3]*t4; /* omega_n*b */
    const double t7 = p[0]*t4; /* m*b */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(x[5], t8, t6); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = x[5]*p[17]; /* s*m*a3^2 */
    const double t11 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t12 = t10*t11; /* s*m*a3^2*omega_tau*omega_tau */
    const double t13 = JLT_FMA(x[5], t10, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = x[2]*t13; /* omega_tau*D */
    out[2] = t14;
    const double t15 = p[38]*t9; /* m*R*v_tau */
    const double t16 = JLT_FMA(x[4], t15, t12); /* d(energy)/d(s) = omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    out[5] = t16;
    const double t17 = JLT_FMA(x[3], t15, p[20]); /* d(energy)/d(gamma3) = omega_n*m*R*v_tau + m*g*a3 */
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
    double t27[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
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
        t18[k] = t8[k]*p[8];
        t19[k] = p[7]*t16[k] + (k == 0 ? p[6] : 0);
        t20[k] = jlt_jet_product(t8, t18, k) + t19[k];
        t22[k] = jlt_jet_product(t2, x0, k);
        t23[k] = t2[k]*p[9];
        t24[k] = jlt_jet_product(t22, t23, k);
        t26[k] = jlt_jet_product(x3, x0, k);
        t27[k] = t11[k]*p[10] + t26[k];
        t29[k] = t24[k] - t16[k]*p[11];
        t30[k] = t29[k] - jlt_jet_product(x3, t27, k);
        t32[k] = t16[k]*p[9] + (k == 0 ? 1.0 : 0);
        t33[k] = jlt_jet_product(t20, t32, k);
        t34[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t33, t34, k);
        t35[k] = jlt_jet_product(t20, t30, k);
        t36[k] = jlt_jet_product(t34, t35, k);
        t37[k] = jlt_jet_product(x2, t26, k);
        t40[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t41[k] = (k == 0 ? p[13] : 0) + t40[k];
        t42[k] = jlt_jet_product(t2, x4, k);
        t43[k] = p[12]*t42[k];
        t44[k] = jlt_jet_product(t41, t43, k);
        t46[k] = jlt_jet_product(x2, t40, k) + x1[k];
        t47[k] = jlt_jet_product(x3, t46, k);
        t48[k] = t44[k] - jlt_jet_product(t18, t47, k);
        t49[k] = jlt_jet_product(t32, t34, k);
        t50[k] = jlt_jet_product(t48, t49, k) + t37[k];
        t54[k] = (k == 0 ? p[15] : 0) - x0[k]*p[16];
        t55[k] = jlt_jet_product(t42, t54, k) + t47[k];
        t56[k] = x5[k]*p[14];
        t57[k] = jlt_jet_product(t55, t56, k);
        t58[k] = jlt_jet_product(t49, t57, k);
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
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 41,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 6, { 2, 23, 14, 1, 0, 0, 7, 10 }, { 17, 78, 0, 10, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 36, { 11, 66, 32, 1, 0, 0, 12, 17 }, { 56, 375, 0, 49, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 42, { 12, 70, 34, 1, 0, 0, 11, 26 }, { 67, 437, 0, 59, 0, 0, 14, 9 },
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
