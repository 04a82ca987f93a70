/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23   13    1    0    0      7   10   (105)
 *  jacobian            11   64   33    1    0    0     13   19   (480)
 *  rhs_jacobian        12   72   33    1    0    0     10   25   (563)
 *  divergence          2    9    7    1    0    0      6    7   (53)
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
    out[34] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[8] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[9] = t8;
    const double t9 = params[0]*params[2]; /* m*g */
    const double t10 = params[3]*t9; /* a3*m*g */
    out[35] = t10;
    const double t11 = t10/params[4]; /* a3*m*g/I1 */
    out[10] = t11;
    const double t12 = params[1]*params[4]; /* R*I1 */
    out[60] = t12;
    const double t13 = params[5]/t12; /* I3/(R*I1) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[61] = t14;
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
    out[46] = t27;
    const double t28 = -t8; /* -I3/I1 */
    out[19] = t28;
    const double t29 = params[2]*t24; /* g*m*2 */
    const double t30 = params[3]*t29; /* a3*g*m*2 */
    out[47] = t30;
    const double t31 = t30/params[4]; /* a3*g*m*2/I1 */
    out[20] = t31;
    const double t32 = t17/t12; /* I3*a3/(R*I1) */
    out[21] = t32;
    const double t33 = params[4]*params[4]; /* I1*I1 */
    const double t34 = params[1]*t33; /* R*I1*I1 */
    const double t35 = params[5]*params[5]; /* I3*I3 */
    out[39] = t35;
    const double t36 = 2.0*t35; /* 2*I3*I3 */
    const double t37 = t36/t34; /* 2*I3*I3/(R*I1*I1) */
    out[22] = t37;
    const double t38 = t1*t33; /* m*R*R*I1*I1 */
    const double t39 = params[5]*t35; /* I3*I3*I3 */
    const double t40 = 2.0*t39; /* 2*I3*I3*I3 */
    const double t41 = t40/t38; /* 2*I3*I3*I3/(m*R*R*I1*I1) */
    out[23] = t41;
    const double t42 = t1*params[4]; /* m*R*R*I1 */
    out[37] = t42;
    const double t43 = t35/t42; /* I3*I3/(m*R*R*I1) */
    out[24] = t43;
    const double t44 = params[5]*2.0; /* I3*2 */
    const double t45 = t44/t12; /* I3*2/(R*I1) */
    out[25] = t45;
    const double t46 = t36/t42; /* 2*I3*I3/(m*R*R*I1) */
    out[26] = t46;
    const double t47 = t19/params[4]; /* (I1 - I3)/I1 */
    out[27] = t47;
    const double t48 = params[3]*2.0; /* a3*2 */
    const double t49 = t35*t48; /* I3*I3*a3*2 */
    const double t50 = t49/t34; /* I3*I3*a3*2/(R*I1*I1) */
    out[28] = t50;
    const double t51 = t19*t44; /* (I1 - I3)*I3*2 */
    const double t52 = t51/t33; /* (I1 - I3)*I3*2/(I1*I1) */
    out[29] = t52;
    const double t53 = 1.0/params[1]; /* 1/R */
    out[30] = t53;
    const double t54 = 2.0/params[1]; /* 2/R */
    out[31] = t54;
    const double t55 = params[5]*t48; /* I3*a3*2 */
    const double t56 = t55/t12; /* I3*a3*2/(R*I1) */
    out[32] = t56;
    const double t57 = t19*2.0; /* (I1 - I3)*2 */
    const double t58 = t57/params[4]; /* (I1 - I3)*2/I1 */
    out[33] = t58;
    const double t59 = params[5]*params[4]; /* I3*I1 */
    out[36] = t59;
    const double t60 = params[0]*params[5]; /* m*I3 */
    out[38] = t60;
    const double t61 = params[5]*t14; /* I3*m*R */
    out[40] = t61;
    const double t62 = params[3]*t14; /* a3*m*R */
    const double t63 = params[5]*t62; /* I3*a3*m*R */
    out[41] = t63;
    const double t64 = t1*t19; /* m*R*R*(I1 - I3) */
    out[42] = t64;
    const double t65 = params[4]*t14; /* I1*m*R */
    out[43] = t65;
    const double t66 = params[4]*2.0; /* I1*2 */
    out[45] = t66;
    const double t67 = params[0]*params[3]; /* m*a3 */
    const double t68 = params[5]*t67; /* I3*m*a3 */
    out[48] = t68;
    const double t69 = params[1]*t24; /* R*m*2 */
    const double t70 = params[5]*t69; /* I3*R*m*2 */
    out[49] = t70;
    const double t71 = t0*t24; /* R*R*m*2 */
    const double t72 = params[4]*t71; /* I1*R*R*m*2 */
    out[50] = t72;
    const double t73 = params[4]*t62; /* I1*a3*m*R */
    out[51] = t73;
    const double t74 = -t65; /* -I1*m*R */
    out[52] = t74;
    const double t75 = t19*t71; /* (I1 - I3)*R*R*m*2 */
    out[53] = t75;
    const double t76 = params[3]*t69; /* a3*R*m*2 */
    const double t77 = params[5]*t76; /* I3*a3*R*m*2 */
    out[54] = t77;
    const double t78 = params[0]/2.0; /* m/2 */
    out[55] = t78;
    const double t79 = params[2]*2.0; /* g*2 */
    const double t80 = params[3]*t79; /* a3*g*2 */
    out[56] = t80;
    const double t81 = 1.0/params[0]; /* 1/m */
    out[57] = t81;
    const double t82 = params[4]/params[0]; /* I1/m */
    out[58] = t82;
    const double t83 = params[5]/params[0]; /* I3/m */
    out[59] = t83;
    const double t84 = params[1]*params[5]; /* R*I3 */
    const double t85 = -t84; /* -R*I3 */
    out[62] = t85;
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
    const double t10 = x[5]*t3; /* s*omega_n*R */
    out[10] = t10;
    const double t11 = t3*x[4]; /* omega_n*R*omega3 */
    out[11] = t11;
    const double t12 = t5*p[9]; /* b/R*I3/I1 */
    const double t13 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t14 = JLT_FMA(t5, t12, t13); /* Theta/(m*R^2*I1) = b/R*b/R*I3/I1 + s*s + I3/(m*R^2) */
    const double t15 = JLT_FMA(t0, p[8], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t16 = t14*t15; /* Theta/(m*R^2*I1)*D/I1 */
    const double t17 = 1.0/t16; /* 1/(Theta/(m*R^2*I1)*D/I1) */
    const double t18 = t14*t17; /* 1/(D/I1) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t19 = t0*t18; /* s*s*1/(D/I1) */
    const double t20 = p[8]*t19; /* m*a3^2/I1*s*s*1/(D/I1) */
    const double t21 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t22 = t20*t21; /* m*a3^2/I1*s*s*1/(D/I1)*omega_tau*omega_tau */
    const double t23 = x[3]*t18; /* omega_n*1/(D/I1) */
    const double t24 = JLT_FNMA(x[3], t23, t22); /* m*a3^2/I1*s*s*1/(D/I1)*omega_tau*omega_tau - omega_n*omega_n*1/(D/I1) */
    out[12] = t24;
    const double t25 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t26 = p[18]*t25; /* 2*m*a3^2/I1*omega_tau*gamma3 */
    const double t27 = t19*t26; /* s*s*1/(D/I1)*2*m*a3^2/I1*omega_tau*gamma3 */
    out[14] = t27;
    const double t28 = x[0]*t23; /* gamma3*omega_n*1/(D/I1) */
    const double t29 = t8*p[9]; /* s*omega3*I3/I1 */
    const double t30 = t18*t29; /* 1/(D/I1)*s*omega3*I3/I1 */
    const double t31 = JLT_FMA(2.0, t28, t30); /* 2*gamma3*omega_n*1/(D/I1) + 1/(D/I1)*s*omega3*I3/I1 */
    const double t32 = -t31; /* -(2*gamma3*omega_n*1/(D/I1) + 1/(D/I1)*s*omega3*I3/I1) */
    out[15] = t32;
    const double t33 = x[5]*p[19]; /* s*(-I3/I1) */
    const double t34 = t23*t33; /* omega_n*1/(D/I1)*s*(-I3/I1) */
    out[16] = t34;
    const double t35 = x[5]*p[20]; /* s*2*m*g*a3/I1 */
    const double t36 = JLT_FNMA(t1, t26, t35); /* s*2*m*g*a3/I1 - s*omega_tau*2*m*a3^2/I1*omega_tau*gamma3 */
    const double t37 = t18*t36; /* 1/(D/I1)*(s*2*m*g*a3/I1 - s*omega_tau*2*m*a3^2/I1*omega_tau*gamma3) */
    const double t38 = t28 + t30; /* gamma3*omega_n*1/(D/I1) + 1/(D/I1)*s*omega3*I3/I1 */
    const double t39 = x[5]*p[18]; /* s*2*m*a3^2/I1 */
    const double t40 = t38*t39; /* (gamma3*omega_n*1/(D/I1) + 1/(D/I1)*s*omega3*I3/I1)*s*2*m*a3^2/I1 */
    const double t41 = JLT_FNMA(x[4], p[9], t40); /* t40 - omega3*I3/I1 */
    const double t42 = JLT_FMS(t20, t37, t37); /* m*a3^2/I1*s*s*1/(D/I1)*t37 - t37 */
    const double t43 = JLT_FMA(t23, t41, t42); /* omega_n*1/(D/I1)*(t40 - omega3*I3/I1) + m*a3^2/I1*s*s*1/(D/I1)*t37 - t37 */
    out[17] = t43;
    const double t44 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t45 = t15*t17; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t46 = t5*t45; /* b/R*1/(Theta/(m*R^2*I1)) */
    const double t47 = x[5]*t45; /* s*1/(Theta/(m*R^2*I1)) */
    const double t48 = x[2]*t47; /* omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t49 = x[4]*t48; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t50 = JLT_FMS(t44, t46, t49); /* omega_tau*omega_n*b/R*1/(Theta/(m*R^2*I1)) - omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t51 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t52 = JLT_FMA(x[2], t51, x[1]); /* V = omega_tau*e + v_nu */
    const double t53 = x[3]*t52; /* omega_n*V */
    const double t54 = t45*t53; /* 1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t55 = t46*t53; /* b/R*1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t56 = JLT_FMS(t49, t51, t55); /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*e - b/R*1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t57 = t46*p[22]; /* b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2) */
    const double t58 = t46*p[23]; /* b/R*1/(Theta/(m*R^2*I1))*2*I3^3/(m*R^2*I1^2) */
    const double t59 = JLT_FNMA(p[11], t54, t44); /* omega_tau*omega_n - I3/(R*I1)*1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t60 = JLT_FNMA(t49, t58, t59); /* omega_tau*omega_n - I3/(R*I1)*1/(Theta/(m*R^2*I1))*omega_n*V - omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*b/R*1/(Theta/(m*R^2*I1))*2*I3^3/(m*R^2*I1^2) */
    const double t61 = JLT_FNMA(p[21], t50, t60); /* t60 - a3*I3/(R*I1)*t50 */
    const double t62 = JLT_FNMA(t56, t57, t61); /* t60 - a3*I3/(R*I1)*t50 - t56*b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2) */
    out[18] = t62;
    const double t63 = t46*p[11]; /* b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    const double t64 = x[3]*t63; /* omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    const double t65 = -t64; /* -omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    out[19] = t65;
    const double t66 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t67 = JLT_FMA(p[11], t51, p[24]); /* I3/(R*I1)*e + I3^2/(m*R^2*I1) */
    const double t68 = x[4]*t67; /* omega3*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    const double t69 = JLT_FMA(t47, t68, t66); /* s*1/(Theta/(m*R^2*I1))*omega3*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) + omega_n*gamma3 */
    const double t70 = JLT_FNMA(t51, t64, t69); /* t69 - e*omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    out[20] = t70;
    const double t71 = JLT_FNMA(t52, t63, t25); /* omega_tau*gamma3 - V*b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    out[21] = t71;
    const double t72 = t48*t67; /* omega_tau*s*1/(Theta/(m*R^2*I1))*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    out[22] = t72;
    const double t73 = x[2]*t68; /* omega_tau*omega3*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    const double t74 = t45*t73; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*(I3/(R*I1)*e + I3^2/(m*R^2*I1)) */
    const double t75 = t47*p[25]; /* s*1/(Theta/(m*R^2*I1))*2*I3/(R*I1) */
    const double t76 = t47*t49; /* s*1/(Theta/(m*R^2*I1))*omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t77 = JLT_FNMA(p[26], t76, t74); /* t74 - 2*I3^2/(m*R^2*I1)*t76 */
    const double t78 = JLT_FNMA(t56, t75, t77); /* t74 - 2*I3^2/(m*R^2*I1)*t76 - t56*s*1/(Theta/(m*R^2*I1))*2*I3/(R*I1) */
    out[23] = t78;
    const double t79 = t55*t75; /* b/R*1/(Theta/(m*R^2*I1))*omega_n*V*s*1/(Theta/(m*R^2*I1))*2*I3/(R*I1) */
    const double t80 = x[3]*p[17]; /* omega_n*a3/R */
    const double t81 = JLT_FNMA(t8, p[27], t80); /* omega_n*a3/R - s*omega3*(I1 - I3)/I1 */
    const double t82 = t5*t76; /* b/R*t76 */
    const double t83 = x[0]*p[29]; /* gamma3*2*I3*(I1 - I3)/I1^2 */
    const double t84 = JLT_FNMA(t48, t81, t79); /* t79 - omega_tau*s*1/(Theta/(m*R^2*I1))*(omega_n*a3/R - s*omega3*(I1 - I3)/I1) */
    const double t85 = JLT_FMA(p[28], t82, t84); /* 2*a3*I3^2/(R*I1^2)*b/R*t76 + t84 */
    const double t86 = JLT_FNMA(t82, t83, t85); /* 2*a3*I3^2/(R*I1^2)*b/R*t76 + t84 - b/R*t76*gamma3*2*I3*(I1 - I3)/I1^2 */
    out[24] = t86;
    const double t87 = x[3]*t47; /* omega_n*s*1/(Theta/(m*R^2*I1)) */
    const double t88 = p[30]*t87; /* 1/R*omega_n*s*1/(Theta/(m*R^2*I1)) */
    const double t89 = -t88; /* -1/R*omega_n*s*1/(Theta/(m*R^2*I1)) */
    out[25] = t89;
    const double t90 = t51*t88; /* e*1/R*omega_n*s*1/(Theta/(m*R^2*I1)) */
    const double t91 = JLT_FNMA(x[0], p[27], p[21]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t92 = t47*t91; /* s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t93 = JLT_FMA(t8, t92, t90); /* s*omega3*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + e*1/R*omega_n*s*1/(Theta/(m*R^2*I1)) */
    const double t94 = -t93; /* -t93 */
    out[26] = t94;
    const double t95 = t47*t52; /* s*1/(Theta/(m*R^2*I1))*V */
    const double t96 = p[13]*t95; /* (-1/R)*s*1/(Theta/(m*R^2*I1))*V */
    out[27] = t96;
    const double t97 = t1*t92; /* s*omega_tau*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t98 = -t97; /* -t97 */
    out[28] = t98;
    const double t99 = t54*p[30]; /* 1/(Theta/(m*R^2*I1))*omega_n*V*1/R */
    const double t100 = t95*p[31]; /* s*1/(Theta/(m*R^2*I1))*V*2/R */
    const double t101 = JLT_FMS(x[5], t76, t49); /* s*t76 - omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t102 = JLT_FNMA(x[0], p[33], p[32]); /* 2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1 */
    const double t103 = JLT_FMS(t87, t100, t99); /* omega_n*s*1/(Theta/(m*R^2*I1))*s*1/(Theta/(m*R^2*I1))*V*2/R - 1/(Theta/(m*R^2*I1))*omega_n*V*1/R */
    const double t104 = JLT_FMA(t101, t102, t103); /* (s*t76 - omega3*omega_tau*s*1/(Theta/(m*R^2*I1)))*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) + t103 */
    out[29] = t104;
    const double t105 = -t1; /* -s*omega_tau */
    out[30] = t105;
    const double t106 = x[5]*x[0]; /* s*gamma3 */
    const double t107 = -t106; /* -s*gamma3 */
    out[32] = t107;
    const double t108 = -t25; /* -omega_tau*gamma3 */
    out[35] = t108;
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
    const double t2 = p[38]*t0; /* m*I3*b */
    const double t3 = JLT_FMA(p[37], t1, p[36]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t0, t2, t3); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(p[34], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t6 = t4*t5; /* Theta*D */
    const double t7 = 1.0/t6; /* 1/(Theta*D) */
    const double t8 = t5*t7; /* 1/Theta = D*1/(Theta*D) */
    const double t9 = t4*t7; /* 1/D = Theta*1/(Theta*D) */
    const double t10 = x[5]*x[2]; /* s*omega_tau */
    const double t11 = x[5]*t10; /* s*s*omega_tau */
    out[0] = t11;
    const double t12 = 2.0*t10; /* 2*s*omega_tau */
    out[11] = t12;
    const double t13 = -t10; /* -s*omega_tau */
    out[36] = t13;
    const double t14 = x[3]*t0; /* omega_n*b */
    const double t15 = p[49]*t0; /* 2*m*R*I3*b */
    const double t16 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t17 = x[5]*x[4]; /* s*omega3 */
    const double t18 = p[34]*t10; /* m*a3^2*s*omega_tau */
    const double t19 = t10*t18; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t20 = JLT_FMA(x[2], t16, x[1]); /* V = omega_tau*e + v_nu */
    const double t21 = t2*t20; /* m*I3*b*V */
    const double t22 = p[38]*t14; /* m*I3*omega_n*b */
    const double t23 = x[4]*t10; /* omega3*s*omega_tau */
    const double t24 = x[0]*t10; /* gamma3*s*omega_tau */
    const double t25 = -t24; /* -gamma3*s*omega_tau */
    out[5] = t25;
    const double t26 = p[44]*t24; /* 2*m*a3^2*gamma3*s*omega_tau */
    const double t27 = x[3]*x[3]; /* omega_n*omega_n */
    const double t28 = JLT_FNMA(p[4], t27, t19); /* s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n */
    const double t29 = p[1]*t27; /* R*omega_n*omega_n */
    out[12] = t29;
    const double t30 = t9*t28; /* 1/D*(s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n) */
    out[18] = t30;
    const double t31 = p[35]*t1; /* m*g*a3*s*s */
    const double t32 = x[4]*t1; /* omega3*s*s */
    const double t33 = p[5]*t17; /* I3*s*omega3 */
    const double t34 = JLT_FMA(x[3], t33, t31); /* omega_n*I3*s*omega3 + m*g*a3*s*s */
    const double t35 = JLT_FNMA(x[0], t28, t34); /* omega_n*I3*s*omega3 + m*g*a3*s*s - gamma3*(s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n) */
    const double t36 = t20*t22; /* V*m*I3*omega_n*b */
    const double t37 = JLT_FMA(p[40], t16, p[39]); /* m*R*I3*e + I3^2 */
    const double t38 = JLT_FMS(t23, t37, t36); /* numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*(m*R*I3*e + I3^2) - V*m*I3*omega_n*b */
    const double t39 = t8*t38; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t40 = x[3]*t20; /* omega_n*V */
    const double t41 = p[52]*t20; /* (-m*R*I1)*V */
    const double t42 = x[5]*x[3]; /* s*omega_n */
    const double t43 = p[1]*t42; /* R*s*omega_n */
    out[16] = t43;
    const double t44 = p[43]*t42; /* m*R*I1*s*omega_n */
    const double t45 = p[41]*t23; /* m*R*a3*I3*omega3*s*omega_tau */
    const double t46 = x[2]*p[48]; /* omega_tau*m*a3*I3 */
    const double t47 = JLT_FNMA(t14, t46, t45); /* m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 */
    const double t48 = JLT_FNMA(p[40], t40, t47); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 - m*R*I3*omega_n*V */
    const double t49 = p[43]*t40; /* m*R*I1*omega_n*V */
    const double t50 = JLT_FNMA(t15, t39, t48); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) - 2*m*R*I3*b*1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t51 = t8*t50; /* 1/Theta*t50 */
    const double t52 = JLT_FMA(x[2], x[3], t51); /* omega_tau*omega_n + 1/Theta*t50 */
    out[24] = t52;
    const double t53 = JLT_FNMA(x[0], p[42], p[41]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t54 = x[2]*t26; /* omega_tau*2*m*a3^2*gamma3*s*omega_tau */
    const double t55 = JLT_FNMA(x[5], p[47], t54); /* omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 */
    const double t56 = x[3]*p[51]; /* omega_n*m*R*a3*I1 */
    const double t57 = t10*t56; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t58 = x[0]*p[53]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t59 = JLT_FMS(t23, t58, t49); /* omega3*s*omega_tau*gamma3*2*m*R^2*(I1 - I3) - m*R*I1*omega_n*V */
    const double t60 = JLT_FMA(t23, t53, t49); /* omega3*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + m*R*I1*omega_n*V */
    const double t61 = JLT_FNMA(p[54], t23, t59); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t59 - 2*m*R*a3*I3*omega3*s*omega_tau */
    const double t62 = t8*t61; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t63 = x[5]*t8; /* s*1/Theta */
    const double t64 = t41*t63; /* (-m*R*I1)*V*s*1/Theta */
    out[33] = t64;
    const double t65 = t60*t63; /* t60*s*1/Theta */
    const double t66 = -t65; /* -t60*s*1/Theta */
    out[4] = t66;
    const double t67 = x[3]*x[4]; /* omega_n*omega3 */
    const double t68 = JLT_FNMA(p[5], t67, t55); /* d(numerator of d(omega_tau)/dt over D)/d(s) = omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 - I3*omega_n*omega3 */
    const double t69 = p[1]*t67; /* R*omega_n*omega3 */
    out[17] = t69;
    const double t70 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t71 = JLT_FMA(p[45], t70, t33); /* 2*I1*omega_n*gamma3 + I3*s*omega3 */
    const double t72 = t9*t71; /* 1/D*(2*I1*omega_n*gamma3 + I3*s*omega3) */
    const double t73 = -t72; /* -1/D*(2*I1*omega_n*gamma3 + I3*s*omega3) */
    out[21] = t73;
    const double t74 = x[5]*p[42]; /* s*m*R^2*(I1 - I3) */
    const double t75 = JLT_FMS(t23, t74, t57); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = omega3*s*omega_tau*s*m*R^2*(I1 - I3) - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t76 = JLT_FMA(t15, t65, t75); /* 2*m*R*I3*b*t60*s*1/Theta + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t77 = t8*t76; /* 1/Theta*t76 */
    out[30] = t77;
    const double t78 = t16*t44; /* e*m*R*I1*s*omega_n */
    const double t79 = JLT_FMA(t32, t53, t78); /* omega3*s*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*m*R*I1*s*omega_n */
    const double t80 = t16*t22; /* e*m*I3*omega_n*b */
    const double t81 = t10*t53; /* s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t82 = t8*t22; /* 1/Theta*m*I3*omega_n*b */
    const double t83 = -t82; /* -1/Theta*m*I3*omega_n*b */
    out[25] = t83;
    const double t84 = JLT_FMS(t17, t37, t80); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(m*R*I3*e + I3^2) - e*m*I3*omega_n*b */
    const double t85 = JLT_FMA(t8, t84, t70); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[26] = t85;
    const double t86 = p[1]*t17; /* R*s*omega3 */
    const double t87 = t8*t37; /* 1/Theta*(m*R*I3*e + I3^2) */
    const double t88 = t10*t87; /* s*omega_tau*1/Theta*(m*R*I3*e + I3^2) */
    out[28] = t88;
    const double t89 = t8*t44; /* 1/Theta*m*R*I1*s*omega_n */
    const double t90 = -t89; /* -1/Theta*m*R*I1*s*omega_n */
    out[31] = t90;
    const double t91 = t8*t79; /* 1/Theta*t79 */
    const double t92 = -t91; /* -1/Theta*t79 */
    out[32] = t92;
    const double t93 = t63*t81; /* s*1/Theta*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t94 = -t93; /* -s*1/Theta*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[34] = t94;
    const double t95 = p[50]*t63; /* 2*m*R^2*I1*s*1/Theta */
    const double t96 = JLT_FMA(t65, t95, t62); /* t60*s*1/Theta*2*m*R^2*I1*s*1/Theta + 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    out[35] = t96;
    const double t97 = JLT_FMA(2.0, t14, t86); /* 2*omega_n*b + R*s*omega3 */
    out[15] = t97;
    const double t98 = t14 + t86; /* omega_n*b + R*s*omega3 */
    const double t99 = x[3]*t98; /* omega_n*(omega_n*b + R*s*omega3) */
    out[1] = t99;
    const double t100 = x[5]*t9; /* s*1/D */
    const double t101 = t26*t100; /* 2*m*a3^2*gamma3*s*omega_tau*s*1/D */
    out[20] = t101;
    const double t102 = p[44]*t35; /* 2*m*a3^2*t35 */
    const double t103 = JLT_FMA(t100, t102, t68); /* s*1/D*2*m*a3^2*t35 + d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t104 = t9*t103; /* 1/D*t103 */
    out[23] = t104;
    const double t105 = t9*t35; /* 1/D*t35 */
    const double t106 = -t105; /* -1/D*t35 */
    out[2] = t106;
    const double t107 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t108 = t87*t107; /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 */
    const double t109 = JLT_FNMA(t39, t95, t108); /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    out[29] = t109;
    const double t110 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t111 = JLT_FNMA(t8, t21, t110); /* omega_tau*gamma3 - 1/Theta*m*I3*b*V */
    out[27] = t111;
    const double t112 = JLT_FMA(x[3], t110, t39); /* omega_n*omega_tau*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t112;
    const double t113 = -t110; /* -omega_tau*gamma3 */
    out[41] = t113;
    const double t114 = x[3]*p[46]; /* omega_n*(-I3) */
    const double t115 = t100*t114; /* s*1/D*omega_n*(-I3) */
    out[22] = t115;
    const double t116 = x[5]*x[0]; /* s*gamma3 */
    const double t117 = -t116; /* -s*gamma3 */
    out[38] = t117;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = JLT_FMA(p[34], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t2 = p[17] + x[0]; /* b/R = a3/R + gamma3 */
    const double t3 = p[9]*t2; /* I3/I1*b/R */
    const double t4 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t5 = JLT_FMA(t2, t3, t4); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + s*s + I3/(m*R^2) */
    const double t6 = t1*t5; /* D*Theta/(m*R^2*I1) */
    const double t7 = t0*x[2]; /* s*s*omega_tau */
    const double t8 = x[0]*p[44]; /* gamma3*2*m*a3^2 */
    const double t9 = t7*t8; /* s*s*omega_tau*gamma3*2*m*a3^2 */
    const double t10 = t5*t9; /* Theta/(m*R^2*I1)*s*s*omega_tau*gamma3*2*m*a3^2 */
    const double t11 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t12 = JLT_FMA(x[2], t11, x[1]); /* V = omega_tau*e + v_nu */
    const double t13 = t2*p[11]; /* b/R*I3/(R*I1) */
    const double t14 = t12*t13; /* V*b/R*I3/(R*I1) */
    const double t15 = JLT_FNMA(x[0], p[27], p[21]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t16 = JLT_FMA(t7, t15, t14); /* s*s*omega_tau*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + V*b/R*I3/(R*I1) */
    const double t17 = JLT_FNMA(t1, t16, t10); /* Theta/(m*R^2*I1)*s*s*omega_tau*gamma3*2*m*a3^2 - D*t16 */
    const double t18 = t17/t6; /* (Theta/(m*R^2*I1)*s*s*omega_tau*gamma3*2*m*a3^2 - D*t16)/(D*Theta/(m*R^2*I1)) */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[56]*x[0]; /* 2*g*a3*gamma3 */
    const double t1 = JLT_FMA(x[1], x[1], t0); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t2 = p[58]*x[3]; /* I1/m*omega_n */
    const double t3 = JLT_FMA(x[3], t2, t1); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t4 = p[34]*x[5]; /* m*a3^2*s */
    const double t5 = JLT_FMA(x[5], t4, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t6 = p[57]*x[2]; /* 1/m*omega_tau */
    const double t7 = x[2]*t6; /* omega_tau*1/m*omega_tau */
    const double t8 = p[59]*x[4]; /* I3/m*omega3 */
    const double t9 = JLT_FMA(x[4], t8, t3); /* omega3*I3/m*omega3 + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t10 = JLT_FMA(t5, t7, t9); /* D*omega_tau*1/m*omega_tau + t9 */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = x[3]*t11; /* omega_n*b */
    const double t13 = x[5]*p[1]; /* s*R */
    const double t14 = JLT_FMA(x[4], t13, t12); /* v_tau = omega3*s*R + omega_n*b */
    const double t15 = JLT_FMA(t14, t14, t10); /* energy/(1/2*m) = v_tau*v_tau + D*omega_tau*1/m*omega_tau + t9 */
    const double t16 = p[55]*t15; /* 1/2*m*energy/(1/2*m) */
    out[0] = t16;
    const double t17 = x[5]*p[60]; /* s*R*I1 */
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
    const double t1 = x[4]*p[62]; /* omega3*(-R*I3) */
    out[6] = t1;
    const double t2 = x[5]*p[60]; /* s*R*I1 */
    out[9] = t2;
    const double t3 = x[3]*p[60]; /* omega_n*R*I1 */
    out[11] = t3;
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = p[46]*t4; /* (-I3)*b */
    out[10] = t5;
    const double t6 = x[3]*t4; /* omega_n*b */
    const double t7 = p[0]*t4; /* m*b */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(x[5], t8, t6); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = x[5]*p[34]; /* s*m*a3^2 */
    const double t11 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t12 = t10*t11; /* s*m*a3^2*omega_tau*omega_tau */
    const double t13 = JLT_FMA(x[5], t10, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = x[2]*t13; /* omega_tau*D */
    out[2] = t14;
    const double t15 = p[61]*t9; /* m*R*v_tau */
    const double t16 = JLT_FMA(x[4], t15, t12); /* d(energy)/d(s) = omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    out[5] = t16;
    const double t17 = JLT_FMA(x[3], t15, p[35]); /* d(energy)/d(gamma3) = omega_n*m*R*v_tau + m*g*a3 */
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
        t18[k] = t8[k]*p[38];
        t19[k] = p[37]*t16[k] + (k == 0 ? p[36] : 0);
        t20[k] = jlt_jet_product(t8, t18, k) + t19[k];
        t22[k] = jlt_jet_product(t2, x0, k);
        t23[k] = t2[k]*p[8];
        t24[k] = jlt_jet_product(t22, t23, k);
        t26[k] = jlt_jet_product(x3, x0, k);
        t27[k] = t11[k]*p[9] + t26[k];
        t29[k] = t24[k] - t16[k]*p[10];
        t30[k] = t29[k] - jlt_jet_product(x3, t27, k);
        t32[k] = t16[k]*p[8] + (k == 0 ? 1.0 : 0);
        t33[k] = jlt_jet_product(t20, t32, k);
        t34[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t33, t34, k);
        t35[k] = jlt_jet_product(t20, t30, k);
        t36[k] = jlt_jet_product(t34, t35, k);
        t37[k] = jlt_jet_product(x2, t26, k);
        t40[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t41[k] = (k == 0 ? p[12] : 0) + t40[k];
        t42[k] = jlt_jet_product(t2, x4, k);
        t43[k] = p[40]*t42[k];
        t44[k] = jlt_jet_product(t41, t43, k);
        t46[k] = jlt_jet_product(x2, t40, k) + x1[k];
        t47[k] = jlt_jet_product(x3, t46, k);
        t48[k] = t44[k] - jlt_jet_product(t18, t47, k);
        t49[k] = jlt_jet_product(t32, t34, k);
        t50[k] = jlt_jet_product(t48, t49, k) + t37[k];
        t54[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t55[k] = jlt_jet_product(t42, t54, k) + t47[k];
        t56[k] = x5[k]*p[52];
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
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 63,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 6, { 3, 23, 13, 1, 0, 0, 7, 10 }, { 17, 78, 0, 10, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 36, { 11, 64, 33, 1, 0, 0, 13, 19 }, { 56, 375, 0, 49, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 42, { 12, 72, 33, 1, 0, 0, 10, 25 }, { 67, 437, 0, 59, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 2, 9, 7, 1, 0, 0, 6, 7 }, { 10, 39, 0, 4, 0, 0, 10, 7 },
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
