/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   29   17    1    0    2     10   12   (125)
 *  jacobian            14   87   38    1    0    2     14   23   (531)
 *  rhs_jacobian        17   95   44    1    0    2     14   33   (628)
 *  divergence          0   11    9    1    0    0     11    6   (53)
 *  integral_values     0   12    9    0    0    0      5    8   (40)
 *  integral_gradients  0   15    7    0    0    0      5    7   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_track[];
extern const jlt_descriptor jlt_kernels_spherical_top_track_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_in_regular_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = -params[4]; /* -I1 */
    const double t1 = params[4]*params[5]; /* I1*I3 */
    const double t2 = params[1]*params[1]; /* R*R */
    const double t3 = params[0]*t2; /* m*R*R */
    const double t4 = params[4]*t3; /* I1*m*R*R */
    const double t5 = params[5]*params[0]; /* I3*m */
    const double t6 = params[0]*params[2]; /* m*g */
    const double t7 = t6*params[3]; /* m*g*a3 */
    const double t8 = t7/params[4]; /* m*g*a3/I1 */
    const double t9 = params[5]/params[4]; /* I3/I1 */
    const double t10 = params[3]*params[3]; /* a3*a3 */
    const double t11 = params[0]*t10; /* m*a3*a3 */
    const double t12 = t11/params[4]; /* m*a3*a3/I1 */
    const double t13 = params[0]*params[1]; /* m*R */
    const double t14 = params[4]*t13; /* I1*m*R */
    const double t15 = params[4] - params[5]; /* I1 - I3 */
    const double t16 = t3*t15; /* m*R*R*(I1 - I3) */
    const double t17 = params[3]*t13; /* a3*m*R */
    const double t18 = params[5]*t17; /* I3*a3*m*R */
    const double t19 = params[0]*2.0; /* m*2 */
    const double t20 = t10*t19; /* a3*a3*m*2 */
    const double t21 = params[4]*2.0; /* I1*2 */
    const double t22 = -params[5]; /* -I3 */
    const double t23 = params[4]*t20; /* I1*a3*a3*m*2 */
    const double t24 = params[5]*t20; /* I3*a3*a3*m*2 */
    const double t25 = params[5]*t13; /* I3*m*R */
    const double t26 = params[0]*params[3]; /* m*a3 */
    const double t27 = params[5]*t26; /* I3*m*a3 */
    const double t28 = params[5]*params[5]; /* I3*I3 */
    const double t29 = t13*t28; /* m*R*I3*I3 */
    const double t30 = params[1]*2.0; /* R*2 */
    const double t31 = params[5]*2.0; /* I3*2 */
    const double t32 = params[5]*t4; /* I3*I1*m*R*R */
    const double t33 = params[0]*params[0]; /* m*m */
    const double t34 = t2*t33; /* R*R*m*m */
    const double t35 = params[5]*t34; /* I3*R*R*m*m */
    const double t36 = params[3]*2.0; /* a3*2 */
    const double t37 = params[5]*t36; /* I3*a3*2 */
    const double t38 = t15*t30; /* (I1 - I3)*R*2 */
    const double t39 = params[4]*t17; /* I1*a3*m*R */
    const double t40 = params[5]*params[3]; /* I3*a3 */
    const double t41 = params[1]*t15; /* R*(I1 - I3) */
    const double t42 = params[1]*t2; /* R*R*R */
    const double t43 = t33*t42; /* m*m*R*R*R */
    const double t44 = params[4]*t43; /* I1*m*m*R*R*R */
    const double t45 = params[2]*2.0; /* g*2 */
    const double t46 = t10*2.0; /* a3*a3*2 */
    const double t47 = t2*t15; /* R*R*(I1 - I3) */
    const double t48 = params[1]*params[3]; /* R*a3 */
    const double t49 = params[5]*t48; /* I3*R*a3 */
    const double t50 = params[0]/2.0; /* m/2 */
    const double t51 = params[4]/2.0; /* I1/2 */
    const double t52 = params[5]/2.0; /* I3/2 */
    const double t53 = params[4]*params[1]; /* I1*R */
    const double t54 = params[5]*params[1]; /* I3*R */
    const double t55 = -t54; /* -I3*R */
    out[6] = t0;
    out[7] = t1;
    out[8] = t4;
    out[9] = t5;
    out[10] = t8;
    out[11] = t9;
    out[12] = t12;
    out[13] = t11;
    out[14] = t13;
    out[15] = t14;
    out[16] = t16;
    out[17] = t18;
    out[18] = t20;
    out[19] = t21;
    out[20] = t22;
    out[21] = t7;
    out[22] = t23;
    out[23] = t24;
    out[24] = t25;
    out[25] = t27;
    out[26] = t29;
    out[27] = t30;
    out[28] = t31;
    out[29] = t32;
    out[30] = t35;
    out[31] = t37;
    out[32] = t38;
    out[33] = t39;
    out[34] = t40;
    out[35] = t41;
    out[36] = t44;
    out[37] = t26;
    out[38] = t45;
    out[39] = t36;
    out[40] = t46;
    out[41] = t47;
    out[42] = t49;
    out[43] = t50;
    out[44] = t51;
    out[45] = t52;
    out[46] = t53;
    out[47] = t55;
    out[48] = t28;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[2]; /* s*omega_tau */
    const double t1 = x[9]*t0; /* s*s*omega_tau */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[9]*x[4]; /* s*omega3 */
    const double t5 = JLT_FMA(p[1], t4, t3); /* R*s*omega3 + omega_n*b */
    const double t6 = x[3]*t5; /* omega_n*(R*s*omega3 + omega_n*b) */
    const double t7 = x[9]*x[9]; /* s*s */
    const double t8 = t2*p[9]; /* b*m*I3 */
    const double t9 = JLT_FMA(p[8], t7, p[7]); /* m*R^2*I1*s*s + I1*I3 */
    const double t10 = JLT_FMA(t2, t8, t9); /* Theta = b*b*m*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t11 = t7*p[10]; /* s*s*m*g*a3/I1 */
    const double t12 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t13 = JLT_FMA(t4, p[11], t12); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t14 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t15 = t0*p[12]; /* s*omega_tau*m*a3^2/I1 */
    const double t16 = JLT_FNMA(t14, t15, t11); /* s*s*m*g*a3/I1 - s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 */
    const double t17 = JLT_FMA(x[3], t13, t16); /* omega_n*(s*omega3*I3/I1 + omega_n*gamma3) + s*s*m*g*a3/I1 - s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 */
    const double t18 = JLT_FMA(t7, p[13], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t19 = t10*t18; /* Theta*D */
    const double t20 = 1.0/t19; /* 1/(Theta*D) */
    const double t21 = p[6]*t10; /* (-I1)*Theta */
    const double t22 = t17*t21; /* t17*(-I1)*Theta */
    const double t23 = t20*t22; /* 1/(Theta*D)*t17*(-I1)*Theta */
    const double t24 = t18*t20; /* D*1/(Theta*D) */
    const double t25 = t4*t24; /* s*omega3*D*1/(Theta*D) */
    const double t26 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t27 = JLT_FMA(p[14], t26, p[5]); /* m*R*e + I3 */
    const double t28 = p[5]*t27; /* I3*(m*R*e + I3) */
    const double t29 = JLT_FMA(t25, t28, t12); /* s*omega3*D*1/(Theta*D)*I3*(m*R*e + I3) + omega_n*gamma3 */
    const double t30 = x[2]*t29; /* omega_tau*(s*omega3*D*1/(Theta*D)*I3*(m*R*e + I3) + omega_n*gamma3) */
    const double t31 = JLT_FMA(x[2], t26, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = x[3]*t31; /* omega_n*V */
    const double t33 = t24*t32; /* D*1/(Theta*D)*omega_n*V */
    const double t34 = JLT_FNMA(t8, t33, t30); /* t30 - b*m*I3*D*1/(Theta*D)*omega_n*V */
    const double t35 = x[9]*p[15]; /* s*m*R*I1 */
    const double t36 = t33*t35; /* D*1/(Theta*D)*omega_n*V*s*m*R*I1 */
    const double t37 = t14*p[16]; /* s*omega_tau*gamma3*m*R^2*(I1 - I3) */
    const double t38 = t0*p[17]; /* s*omega_tau*m*R*a3*I3 */
    const double t39 = JLT_FMS(t25, t37, t36); /* s*omega3*D*1/(Theta*D)*s*omega_tau*gamma3*m*R^2*(I1 - I3) - D*1/(Theta*D)*omega_n*V*s*m*R*I1 */
    const double t40 = JLT_FNMA(t25, t38, t39); /* t39 - s*omega3*D*1/(Theta*D)*s*omega_tau*m*R*a3*I3 */
    const double t41 = -x[3]; /* -omega_n */
    const double t42 = t4 + t12; /* s*omega3 + omega_n*gamma3 */
    const double t43 = cos(x[5]); /* C = cos(chi) */
    const double t44 = x[1]*t43; /* v_nu*C */
    const double t45 = sin(x[5]); /* S = sin(chi) */
    const double t46 = JLT_FMA(t5, t45, t44); /* (R*s*omega3 + omega_n*b)*S + v_nu*C */
    const double t47 = x[9]*t46; /* s*((R*s*omega3 + omega_n*b)*S + v_nu*C) */
    const double t48 = x[1]*t45; /* v_nu*S */
    const double t49 = JLT_FNMA(t5, t43, t48); /* v_nu*S - (R*s*omega3 + omega_n*b)*C */
    const double t50 = x[9]*t49; /* s*(v_nu*S - (R*s*omega3 + omega_n*b)*C) */
    const double t51 = -t14; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t6;
    out[2] = t23;
    out[3] = t34;
    out[4] = t40;
    out[5] = t41;
    out[6] = t42;
    out[7] = t47;
    out[8] = t50;
    out[9] = t51;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[9]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*p[1]; /* omega_n*R */
    const double t4 = x[3]*t3; /* omega_n*omega_n*R */
    const double t5 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t6 = x[3]*t5; /* omega_n*b */
    const double t7 = x[9]*p[1]; /* s*R */
    const double t8 = x[4]*t7; /* omega3*s*R */
    const double t9 = JLT_FMA(2.0, t6, t8); /* 2*omega_n*b + omega3*s*R */
    const double t10 = x[3]*t7; /* omega_n*s*R */
    const double t11 = t3*x[4]; /* omega_n*R*omega3 */
    const double t12 = x[2]*p[13]; /* omega_tau*m*a3^2 */
    const double t13 = t5*p[9]; /* b*m*I3 */
    const double t14 = JLT_FMA(t0, p[8], p[7]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t15 = JLT_FMA(t5, t13, t14); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t16 = JLT_FMA(t0, p[13], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t17 = t15*t16; /* Theta*D */
    const double t18 = 1.0/t17; /* 1/(Theta*D) */
    const double t19 = t15*t18; /* Theta*1/(Theta*D) */
    const double t20 = x[9]*t19; /* s*Theta*1/(Theta*D) */
    const double t21 = t1*t20; /* s*omega_tau*s*Theta*1/(Theta*D) */
    const double t22 = t12*t21; /* omega_tau*m*a3^2*s*omega_tau*s*Theta*1/(Theta*D) */
    const double t23 = x[3]*t19; /* omega_n*Theta*1/(Theta*D) */
    const double t24 = x[3]*p[4]; /* omega_n*I1 */
    const double t25 = JLT_FNMA(t23, t24, t22); /* omega_tau*m*a3^2*s*omega_tau*s*Theta*1/(Theta*D) - omega_n*Theta*1/(Theta*D)*omega_n*I1 */
    const double t26 = x[0]*p[18]; /* gamma3*2*m*a3^2 */
    const double t27 = t21*t26; /* s*omega_tau*s*Theta*1/(Theta*D)*gamma3*2*m*a3^2 */
    const double t28 = x[0]*p[19]; /* gamma3*2*I1 */
    const double t29 = t23*t28; /* omega_n*Theta*1/(Theta*D)*gamma3*2*I1 */
    const double t30 = x[4]*p[5]; /* omega3*I3 */
    const double t31 = JLT_FMA(t20, t30, t29); /* s*Theta*1/(Theta*D)*omega3*I3 + omega_n*Theta*1/(Theta*D)*gamma3*2*I1 */
    const double t32 = -t31; /* -t31 */
    const double t33 = x[3]*t20; /* omega_n*s*Theta*1/(Theta*D) */
    const double t34 = p[20]*t33; /* (-I3)*omega_n*s*Theta*1/(Theta*D) */
    const double t35 = x[9]*p[18]; /* s*2*m*a3^2 */
    const double t36 = JLT_FNMA(t20, t35, 2.0); /* 2 - s*Theta*1/(Theta*D)*s*2*m*a3^2 */
    const double t37 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t38 = JLT_FNMA(t12, t37, p[21]); /* m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t39 = t20*t38; /* s*Theta*1/(Theta*D)*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t40 = t36*t39; /* (2 - s*Theta*1/(Theta*D)*s*2*m*a3^2)*t39 */
    const double t41 = x[0]*p[22]; /* gamma3*2*m*a3^2*I1 */
    const double t42 = JLT_FMS(t33, t41, t30); /* omega_n*s*Theta*1/(Theta*D)*gamma3*2*m*a3^2*I1 - omega3*I3 */
    const double t43 = x[4]*p[23]; /* omega3*2*m*a3^2*I3 */
    const double t44 = t20*t43; /* s*Theta*1/(Theta*D)*omega3*2*m*a3^2*I3 */
    const double t45 = JLT_FMS(t33, t44, t40); /* omega_n*s*Theta*1/(Theta*D)*s*Theta*1/(Theta*D)*omega3*2*m*a3^2*I3 - (2 - s*Theta*1/(Theta*D)*s*2*m*a3^2)*t39 */
    const double t46 = JLT_FMA(t23, t42, t45); /* omega_n*Theta*1/(Theta*D)*(omega_n*s*Theta*1/(Theta*D)*gamma3*2*m*a3^2*I1 - omega3*I3) + t45 */
    const double t47 = t16*t18; /* D*1/(Theta*D) */
    const double t48 = x[9]*t47; /* s*D*1/(Theta*D) */
    const double t49 = x[2]*t48; /* omega_tau*s*D*1/(Theta*D) */
    const double t50 = x[4]*t49; /* omega3*omega_tau*s*D*1/(Theta*D) */
    const double t51 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t52 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t53 = JLT_FMA(x[2], t52, x[1]); /* V = omega_tau*e + v_nu */
    const double t54 = x[3]*t53; /* omega_n*V */
    const double t55 = t47*t54; /* D*1/(Theta*D)*omega_n*V */
    const double t56 = t5*t47; /* b*D*1/(Theta*D) */
    const double t57 = t51*p[25]; /* omega_tau*omega_n*m*a3*I3 */
    const double t58 = t54*t56; /* omega_n*V*b*D*1/(Theta*D) */
    const double t59 = 2.0*t58; /* 2*omega_n*V*b*D*1/(Theta*D) */
    const double t60 = t52*p[27]; /* e*2*R */
    const double t61 = JLT_FNMA(t50, t60, t59); /* 2*omega_n*V*b*D*1/(Theta*D) - omega3*omega_tau*s*D*1/(Theta*D)*e*2*R */
    const double t62 = p[0]*t61; /* m*t61 */
    const double t63 = JLT_FNMA(t50, p[28], t62); /* m*t61 - omega3*omega_tau*s*D*1/(Theta*D)*2*I3 */
    const double t64 = t56*p[26]; /* b*D*1/(Theta*D)*m*R*I3^2 */
    const double t65 = JLT_FNMA(p[24], t55, t51); /* omega_tau*omega_n - m*R*I3*D*1/(Theta*D)*omega_n*V */
    const double t66 = JLT_FNMA(t56, t57, t65); /* omega_tau*omega_n - m*R*I3*D*1/(Theta*D)*omega_n*V - b*D*1/(Theta*D)*omega_tau*omega_n*m*a3*I3 */
    const double t67 = JLT_FMA(p[17], t50, t66); /* m*R*a3*I3*omega3*omega_tau*s*D*1/(Theta*D) + t66 */
    const double t68 = JLT_FMA(t63, t64, t67); /* (m*t61 - omega3*omega_tau*s*D*1/(Theta*D)*2*I3)*b*D*1/(Theta*D)*m*R*I3^2 + m*R*a3*I3*omega3*omega_tau*s*D*1/(Theta*D) + t66 */
    const double t69 = p[9]*t56; /* m*I3*b*D*1/(Theta*D) */
    const double t70 = x[3]*t69; /* omega_n*m*I3*b*D*1/(Theta*D) */
    const double t71 = -t70; /* -omega_n*m*I3*b*D*1/(Theta*D) */
    const double t72 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t73 = JLT_FMA(t52, p[14], p[5]); /* e*m*R + I3 */
    const double t74 = t30*t73; /* omega3*I3*(e*m*R + I3) */
    const double t75 = JLT_FMA(t48, t74, t72); /* s*D*1/(Theta*D)*omega3*I3*(e*m*R + I3) + omega_n*gamma3 */
    const double t76 = JLT_FNMA(t52, t70, t75); /* s*D*1/(Theta*D)*omega3*I3*(e*m*R + I3) + omega_n*gamma3 - e*omega_n*m*I3*b*D*1/(Theta*D) */
    const double t77 = JLT_FNMA(t53, t69, t37); /* omega_tau*gamma3 - V*m*I3*b*D*1/(Theta*D) */
    const double t78 = p[5]*t73; /* I3*(e*m*R + I3) */
    const double t79 = t49*t78; /* omega_tau*s*D*1/(Theta*D)*I3*(e*m*R + I3) */
    const double t80 = x[2]*t74; /* omega_tau*omega3*I3*(e*m*R + I3) */
    const double t81 = t47*t80; /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) */
    const double t82 = t48*p[29]; /* s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t83 = JLT_FMA(t63, t82, t81); /* (m*t61 - omega3*omega_tau*s*D*1/(Theta*D)*2*I3)*s*D*1/(Theta*D)*m*R^2*I1*I3 + D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) */
    const double t84 = JLT_FNMA(x[0], p[32], p[31]); /* 2*a3*I3 - gamma3*2*R*(I1 - I3) */
    const double t85 = t50*t84; /* omega3*omega_tau*s*D*1/(Theta*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t86 = t5*t85; /* b*t85 */
    const double t87 = JLT_FMA(p[19], t58, t86); /* 2*I1*omega_n*V*b*D*1/(Theta*D) + b*t85 */
    const double t88 = t48*p[30]; /* s*D*1/(Theta*D)*m^2*R^2*I3 */
    const double t89 = x[3]*p[33]; /* omega_n*m*R*a3*I1 */
    const double t90 = t49*t89; /* omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t91 = x[9]*p[16]; /* s*m*R^2*(I1 - I3) */
    const double t92 = JLT_FMS(t50, t91, t90); /* omega3*omega_tau*s*D*1/(Theta*D)*s*m*R^2*(I1 - I3) - omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t93 = JLT_FMA(t87, t88, t92); /* (2*I1*omega_n*V*b*D*1/(Theta*D) + b*t85)*s*D*1/(Theta*D)*m^2*R^2*I3 + t92 */
    const double t94 = t48*p[15]; /* s*D*1/(Theta*D)*m*R*I1 */
    const double t95 = x[3]*t94; /* omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t96 = -t95; /* -omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t97 = t52*t95; /* e*omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t98 = JLT_FNMA(x[0], p[35], p[34]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t99 = x[9]*p[14]; /* s*m*R */
    const double t100 = t98*t99; /* (a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t101 = x[4]*t100; /* omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t102 = JLT_FMA(t48, t101, t97); /* s*D*1/(Theta*D)*omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R + e*omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t103 = -t102; /* -t102 */
    const double t104 = t53*t94; /* V*s*D*1/(Theta*D)*m*R*I1 */
    const double t105 = -t104; /* -V*s*D*1/(Theta*D)*m*R*I1 */
    const double t106 = t49*t100; /* omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t107 = -t106; /* -omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t108 = t55*p[15]; /* D*1/(Theta*D)*omega_n*V*m*R*I1 */
    const double t109 = x[9]*t85; /* s*t85 */
    const double t110 = p[19]*t54; /* 2*I1*omega_n*V */
    const double t111 = JLT_FMA(t48, t110, t109); /* s*D*1/(Theta*D)*2*I1*omega_n*V + s*t85 */
    const double t112 = t48*p[36]; /* s*D*1/(Theta*D)*m^2*R^3*I1 */
    const double t113 = JLT_FMS(t111, t112, t108); /* (s*D*1/(Theta*D)*2*I1*omega_n*V + s*t85)*s*D*1/(Theta*D)*m^2*R^3*I1 - D*1/(Theta*D)*omega_n*V*m*R*I1 */
    const double t114 = JLT_FNMA(p[14], t85, t113); /* t113 - m*R*t85 */
    const double t115 = sin(x[5]); /* S = sin(chi) */
    const double t116 = t10*t115; /* omega_n*s*R*S */
    const double t117 = cos(x[5]); /* C = cos(chi) */
    const double t118 = x[9]*t117; /* s*C */
    const double t119 = x[9]*t115; /* s*S */
    const double t120 = t5*t119; /* b*s*S */
    const double t121 = t7*t119; /* s*R*s*S */
    const double t122 = x[1]*t119; /* v_nu*s*S */
    const double t123 = t6 + t8; /* v_tau = omega_n*b + omega3*s*R */
    const double t124 = JLT_FMS(t118, t123, t122); /* s*C*v_tau - v_nu*s*S */
    const double t125 = x[1]*t117; /* v_nu*C */
    const double t126 = t8 + t123; /* omega3*s*R + v_tau */
    const double t127 = JLT_FMA(t115, t126, t125); /* S*(omega3*s*R + v_tau) + v_nu*C */
    const double t128 = t10*t117; /* omega_n*s*R*C */
    const double t129 = -t128; /* -omega_n*s*R*C */
    const double t130 = t5*t118; /* b*s*C */
    const double t131 = -t130; /* -b*s*C */
    const double t132 = t7*t118; /* s*R*s*C */
    const double t133 = -t132; /* -s*R*s*C */
    const double t134 = x[1]*t118; /* v_nu*s*C */
    const double t135 = JLT_FMA(t119, t123, t134); /* s*S*v_tau + v_nu*s*C */
    const double t136 = x[1]*t115; /* v_nu*S */
    const double t137 = JLT_FNMA(t117, t126, t136); /* v_nu*S - C*(omega3*s*R + v_tau) */
    const double t138 = -t1; /* -s*omega_tau */
    const double t139 = x[9]*x[0]; /* s*gamma3 */
    const double t140 = -t139; /* -s*gamma3 */
    const double t141 = -t37; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t2;
    out[10] = t4;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t9;
    out[14] = t10;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t11;
    out[20] = t25;
    out[21] = 0.0;
    out[22] = t27;
    out[23] = t32;
    out[24] = t34;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t46;
    out[30] = t68;
    out[31] = t71;
    out[32] = t76;
    out[33] = t77;
    out[34] = t79;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t83;
    out[40] = t93;
    out[41] = t96;
    out[42] = t103;
    out[43] = t105;
    out[44] = t107;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t114;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = (-1.0);
    out[54] = 0.0;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = 0.0;
    out[60] = x[3];
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = x[0];
    out[64] = x[9];
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[68] = 0.0;
    out[69] = x[4];
    out[70] = t116;
    out[71] = t118;
    out[72] = 0.0;
    out[73] = t120;
    out[74] = t121;
    out[75] = t124;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = t127;
    out[80] = t129;
    out[81] = t119;
    out[82] = 0.0;
    out[83] = t131;
    out[84] = t133;
    out[85] = t135;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t137;
    out[90] = t138;
    out[91] = 0.0;
    out[92] = t140;
    out[93] = 0.0;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t141;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[9]*p[1]; /* s*R */
    const double t5 = x[4]*t4; /* omega3*s*R */
    const double t6 = t3 + t5; /* omega_n*b + omega3*s*R */
    const double t7 = x[3]*t6; /* omega_n*(omega_n*b + omega3*s*R) */
    const double t8 = t2*p[9]; /* b*m*I3 */
    const double t9 = JLT_FMA(t0, p[8], p[7]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t10 = JLT_FMA(t2, t8, t9); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t11 = JLT_FMA(t0, p[13], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t12 = t10*t11; /* Theta*D */
    const double t13 = 1.0/t12; /* 1/(Theta*D) */
    const double t14 = t10*t13; /* Theta*1/(Theta*D) */
    const double t15 = x[9]*t14; /* s*Theta*1/(Theta*D) */
    const double t16 = x[9]*t15; /* s*s*Theta*1/(Theta*D) */
    const double t17 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t18 = x[2]*t17; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t19 = t16*t18; /* s*s*Theta*1/(Theta*D)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t20 = x[3]*t14; /* omega_n*Theta*1/(Theta*D) */
    const double t21 = JLT_FNMA(x[3], t20, t19); /* s*s*Theta*1/(Theta*D)*omega_tau*omega_tau*m*a3^2/I1 - omega_n*omega_n*Theta*1/(Theta*D) */
    const double t22 = p[4]*t21; /* I1*t21 */
    const double t23 = x[0]*t22; /* gamma3*I1*t21 */
    const double t24 = x[4]*p[5]; /* omega3*I3 */
    const double t25 = x[3]*t15; /* omega_n*s*Theta*1/(Theta*D) */
    const double t26 = JLT_FNMA(t16, p[21], t23); /* gamma3*I1*t21 - s*s*Theta*1/(Theta*D)*m*g*a3 */
    const double t27 = JLT_FNMA(t24, t25, t26); /* gamma3*I1*t21 - s*s*Theta*1/(Theta*D)*m*g*a3 - omega3*I3*omega_n*s*Theta*1/(Theta*D) */
    const double t28 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t29 = x[3]*t28; /* omega_n*omega_tau*gamma3 */
    const double t30 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t31 = JLT_FMA(x[2], t30, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = x[3]*t31; /* omega_n*V */
    const double t33 = t11*t13; /* D*1/(Theta*D) */
    const double t34 = t2*t33; /* b*D*1/(Theta*D) */
    const double t35 = p[9]*t34; /* m*I3*b*D*1/(Theta*D) */
    const double t36 = x[9]*t33; /* s*D*1/(Theta*D) */
    const double t37 = x[2]*t36; /* omega_tau*s*D*1/(Theta*D) */
    const double t38 = x[4]*t37; /* omega3*omega_tau*s*D*1/(Theta*D) */
    const double t39 = JLT_FMA(t30, p[14], p[5]); /* e*m*R + I3 */
    const double t40 = p[5]*t39; /* I3*(e*m*R + I3) */
    const double t41 = JLT_FNMA(t32, t35, t29); /* omega_n*omega_tau*gamma3 - omega_n*V*m*I3*b*D*1/(Theta*D) */
    const double t42 = JLT_FMA(t38, t40, t41); /* omega3*omega_tau*s*D*1/(Theta*D)*I3*(e*m*R + I3) + omega_n*omega_tau*gamma3 - omega_n*V*m*I3*b*D*1/(Theta*D) */
    const double t43 = t36*p[15]; /* s*D*1/(Theta*D)*m*R*I1 */
    const double t44 = t32*t43; /* omega_n*V*s*D*1/(Theta*D)*m*R*I1 */
    const double t45 = JLT_FNMA(x[0], p[35], p[34]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t46 = x[9]*p[14]; /* s*m*R */
    const double t47 = t45*t46; /* (a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t48 = JLT_FMA(t38, t47, t44); /* omega3*omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R + omega_n*V*s*D*1/(Theta*D)*m*R*I1 */
    const double t49 = -t48; /* -t48 */
    const double t50 = -x[3]; /* -omega_n */
    const double t51 = x[9]*x[4]; /* s*omega3 */
    const double t52 = JLT_FMA(x[3], x[0], t51); /* omega_n*gamma3 + s*omega3 */
    const double t53 = cos(x[5]); /* C = cos(chi) */
    const double t54 = x[1]*t53; /* v_nu*C */
    const double t55 = sin(x[5]); /* S = sin(chi) */
    const double t56 = JLT_FMA(t6, t55, t54); /* (omega_n*b + omega3*s*R)*S + v_nu*C */
    const double t57 = x[9]*t56; /* s*((omega_n*b + omega3*s*R)*S + v_nu*C) */
    const double t58 = x[1]*t55; /* v_nu*S */
    const double t59 = JLT_FNMA(t6, t53, t58); /* v_nu*S - (omega_n*b + omega3*s*R)*C */
    const double t60 = x[9]*t59; /* s*(v_nu*S - (omega_n*b + omega3*s*R)*C) */
    const double t61 = x[9]*t28; /* s*omega_tau*gamma3 */
    const double t62 = -t61; /* -s*omega_tau*gamma3 */
    const double t63 = x[2]*x[9]; /* omega_tau*s */
    const double t64 = 2.0*t63; /* 2*omega_tau*s */
    const double t65 = x[3]*p[1]; /* omega_n*R */
    const double t66 = x[3]*t65; /* omega_n*omega_n*R */
    const double t67 = JLT_FMA(t3, 2.0, t5); /* omega_n*b*2 + omega3*s*R */
    const double t68 = x[3]*t4; /* omega_n*s*R */
    const double t69 = x[4]*t65; /* omega3*omega_n*R */
    const double t70 = t28*p[18]; /* omega_tau*gamma3*2*m*a3^2 */
    const double t71 = t16*t70; /* s*s*Theta*1/(Theta*D)*omega_tau*gamma3*2*m*a3^2 */
    const double t72 = x[0]*p[19]; /* gamma3*2*I1 */
    const double t73 = t20*t72; /* omega_n*Theta*1/(Theta*D)*gamma3*2*I1 */
    const double t74 = JLT_FMA(t15, t24, t73); /* s*Theta*1/(Theta*D)*omega3*I3 + omega_n*Theta*1/(Theta*D)*gamma3*2*I1 */
    const double t75 = -t74; /* -t74 */
    const double t76 = t25*p[20]; /* omega_n*s*Theta*1/(Theta*D)*(-I3) */
    const double t77 = x[4]*p[31]; /* omega3*2*a3*I3 */
    const double t78 = t25*t77; /* omega_n*s*Theta*1/(Theta*D)*omega3*2*a3*I3 */
    const double t79 = x[2]*p[39]; /* omega_tau*2*a3 */
    const double t80 = JLT_FNMA(t28, t79, p[38]); /* 2*g - omega_tau*gamma3*omega_tau*2*a3 */
    const double t81 = JLT_FNMA(p[13], t16, 1.0); /* 1 - m*a3^2*s*s*Theta*1/(Theta*D) */
    const double t82 = JLT_FNMA(t80, t81, t78); /* omega_n*s*Theta*1/(Theta*D)*omega3*2*a3*I3 - (2*g - omega_tau*gamma3*omega_tau*2*a3)*(1 - m*a3^2*s*s*Theta*1/(Theta*D)) */
    const double t83 = t15*p[37]; /* s*Theta*1/(Theta*D)*m*a3 */
    const double t84 = t82*t83; /* t82*s*Theta*1/(Theta*D)*m*a3 */
    const double t85 = x[0]*p[22]; /* gamma3*2*m*a3^2*I1 */
    const double t86 = JLT_FMS(t25, t85, t24); /* omega_n*s*Theta*1/(Theta*D)*gamma3*2*m*a3^2*I1 - omega3*I3 */
    const double t87 = JLT_FMA(t20, t86, t84); /* omega_n*Theta*1/(Theta*D)*(omega_n*s*Theta*1/(Theta*D)*gamma3*2*m*a3^2*I1 - omega3*I3) + t82*s*Theta*1/(Theta*D)*m*a3 */
    const double t88 = t38*p[17]; /* omega3*omega_tau*s*D*1/(Theta*D)*m*R*a3*I3 */
    const double t89 = JLT_FNMA(t34, p[25], 1.0); /* 1 - b*D*1/(Theta*D)*m*a3*I3 */
    const double t90 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t91 = t32*t33; /* omega_n*V*D*1/(Theta*D) */
    const double t92 = t38*p[28]; /* omega3*omega_tau*s*D*1/(Theta*D)*2*I3 */
    const double t93 = t30*p[27]; /* e*2*R */
    const double t94 = t38*t93; /* omega3*omega_tau*s*D*1/(Theta*D)*e*2*R */
    const double t95 = t32*2.0; /* omega_n*V*2 */
    const double t96 = JLT_FNMA(t34, t95, t94); /* omega3*omega_tau*s*D*1/(Theta*D)*e*2*R - b*D*1/(Theta*D)*omega_n*V*2 */
    const double t97 = JLT_FMA(p[0], t96, t92); /* m*t96 + omega3*omega_tau*s*D*1/(Theta*D)*2*I3 */
    const double t98 = t34*p[26]; /* b*D*1/(Theta*D)*m*R*I3^2 */
    const double t99 = JLT_FNMA(p[24], t91, t88); /* omega3*omega_tau*s*D*1/(Theta*D)*m*R*a3*I3 - m*R*I3*omega_n*V*D*1/(Theta*D) */
    const double t100 = JLT_FMA(t89, t90, t99); /* (1 - b*D*1/(Theta*D)*m*a3*I3)*omega_tau*omega_n + t99 */
    const double t101 = JLT_FNMA(t97, t98, t100); /* (1 - b*D*1/(Theta*D)*m*a3*I3)*omega_tau*omega_n + t99 - (m*t96 + omega3*omega_tau*s*D*1/(Theta*D)*2*I3)*b*D*1/(Theta*D)*m*R*I3^2 */
    const double t102 = x[3]*t35; /* omega_n*m*I3*b*D*1/(Theta*D) */
    const double t103 = -t102; /* -omega_n*m*I3*b*D*1/(Theta*D) */
    const double t104 = JLT_FNMA(t30, t35, x[0]); /* gamma3 - e*m*I3*b*D*1/(Theta*D) */
    const double t105 = x[3]*t104; /* omega_n*(gamma3 - e*m*I3*b*D*1/(Theta*D)) */
    const double t106 = t24*t39; /* omega3*I3*(e*m*R + I3) */
    const double t107 = JLT_FMA(t36, t106, t105); /* s*D*1/(Theta*D)*omega3*I3*(e*m*R + I3) + omega_n*(gamma3 - e*m*I3*b*D*1/(Theta*D)) */
    const double t108 = JLT_FNMA(t31, t35, t28); /* omega_tau*gamma3 - V*m*I3*b*D*1/(Theta*D) */
    const double t109 = t37*t40; /* omega_tau*s*D*1/(Theta*D)*I3*(e*m*R + I3) */
    const double t110 = x[2]*t106; /* omega_tau*omega3*I3*(e*m*R + I3) */
    const double t111 = t33*t110; /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) */
    const double t112 = t36*p[29]; /* s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t113 = JLT_FNMA(t97, t112, t111); /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) - (m*t96 + omega3*omega_tau*s*D*1/(Theta*D)*2*I3)*s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t114 = JLT_FNMA(x[0], p[32], p[31]); /* 2*a3*I3 - gamma3*2*R*(I1 - I3) */
    const double t115 = t38*t114; /* omega3*omega_tau*s*D*1/(Theta*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t116 = t2*t115; /* b*t115 */
    const double t117 = t32*p[19]; /* omega_n*V*2*I1 */
    const double t118 = JLT_FMA(t34, t117, t116); /* b*D*1/(Theta*D)*omega_n*V*2*I1 + b*t115 */
    const double t119 = t36*p[30]; /* s*D*1/(Theta*D)*m^2*R^2*I3 */
    const double t120 = x[3]*p[33]; /* omega_n*m*R*a3*I1 */
    const double t121 = t37*t120; /* omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t122 = x[9]*p[16]; /* s*m*R^2*(I1 - I3) */
    const double t123 = JLT_FMS(t38, t122, t121); /* omega3*omega_tau*s*D*1/(Theta*D)*s*m*R^2*(I1 - I3) - omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t124 = JLT_FMA(t118, t119, t123); /* (b*D*1/(Theta*D)*omega_n*V*2*I1 + b*t115)*s*D*1/(Theta*D)*m^2*R^2*I3 + t123 */
    const double t125 = x[3]*t43; /* omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t126 = -t125; /* -omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t127 = t30*t125; /* e*omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t128 = x[4]*t47; /* omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t129 = JLT_FMA(t36, t128, t127); /* s*D*1/(Theta*D)*omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R + e*omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t130 = -t129; /* -t129 */
    const double t131 = t31*t43; /* V*s*D*1/(Theta*D)*m*R*I1 */
    const double t132 = -t131; /* -V*s*D*1/(Theta*D)*m*R*I1 */
    const double t133 = t37*t47; /* omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t134 = -t133; /* -omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t135 = p[15]*t91; /* m*R*I1*omega_n*V*D*1/(Theta*D) */
    const double t136 = x[9]*t115; /* s*t115 */
    const double t137 = JLT_FMA(t36, t117, t136); /* s*D*1/(Theta*D)*omega_n*V*2*I1 + s*t115 */
    const double t138 = t36*p[36]; /* s*D*1/(Theta*D)*m^2*R^3*I1 */
    const double t139 = JLT_FMS(t137, t138, t135); /* (s*D*1/(Theta*D)*omega_n*V*2*I1 + s*t115)*s*D*1/(Theta*D)*m^2*R^3*I1 - m*R*I1*omega_n*V*D*1/(Theta*D) */
    const double t140 = JLT_FNMA(p[14], t115, t139); /* t139 - m*R*t115 */
    const double t141 = t55*t68; /* S*omega_n*s*R */
    const double t142 = x[9]*t53; /* s*C */
    const double t143 = x[9]*t55; /* s*S */
    const double t144 = t2*t143; /* b*s*S */
    const double t145 = t4*t143; /* s*R*s*S */
    const double t146 = -t60; /* -s*(v_nu*S - (omega_n*b + omega3*s*R)*C) */
    const double t147 = JLT_FMA(t5, t55, t56); /* omega3*s*R*S + (omega_n*b + omega3*s*R)*S + v_nu*C */
    const double t148 = t53*t68; /* C*omega_n*s*R */
    const double t149 = -t148; /* -C*omega_n*s*R */
    const double t150 = t2*t142; /* b*s*C */
    const double t151 = -t150; /* -b*s*C */
    const double t152 = t4*t142; /* s*R*s*C */
    const double t153 = -t152; /* -s*R*s*C */
    const double t154 = JLT_FNMA(t5, t53, t59); /* v_nu*S - (omega_n*b + omega3*s*R)*C - omega3*s*R*C */
    const double t155 = -t63; /* -omega_tau*s */
    const double t156 = x[9]*x[0]; /* s*gamma3 */
    const double t157 = -t156; /* -s*gamma3 */
    const double t158 = -t28; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t7;
    out[2] = t27;
    out[3] = t42;
    out[4] = t49;
    out[5] = t50;
    out[6] = t52;
    out[7] = t57;
    out[8] = t60;
    out[9] = t62;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t64;
    out[20] = t66;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = t67;
    out[24] = t68;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t69;
    out[30] = t22;
    out[31] = 0.0;
    out[32] = t71;
    out[33] = t75;
    out[34] = t76;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t87;
    out[40] = t101;
    out[41] = t103;
    out[42] = t107;
    out[43] = t108;
    out[44] = t109;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t113;
    out[50] = t124;
    out[51] = t126;
    out[52] = t130;
    out[53] = t132;
    out[54] = t134;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = t140;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = (-1.0);
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[68] = 0.0;
    out[69] = 0.0;
    out[70] = x[3];
    out[71] = 0.0;
    out[72] = 0.0;
    out[73] = x[0];
    out[74] = x[9];
    out[75] = 0.0;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = x[4];
    out[80] = t141;
    out[81] = t142;
    out[82] = 0.0;
    out[83] = t144;
    out[84] = t145;
    out[85] = t146;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t147;
    out[90] = t149;
    out[91] = t143;
    out[92] = 0.0;
    out[93] = t151;
    out[94] = t153;
    out[95] = t57;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t154;
    out[100] = t155;
    out[101] = 0.0;
    out[102] = t157;
    out[103] = 0.0;
    out[104] = 0.0;
    out[105] = 0.0;
    out[106] = 0.0;
    out[107] = 0.0;
    out[108] = 0.0;
    out[109] = t158;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t2 = t1*p[9]; /* b*m*I3 */
    const double t3 = JLT_FMA(t0, p[8], p[7]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t4 = JLT_FMA(t1, t2, t3); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t5 = JLT_FMA(t0, p[13], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t4*t5; /* Theta*D */
    const double t7 = 1.0/t6; /* 1/(Theta*D) */
    const double t8 = p[40]*t4; /* 2*a3^2*Theta */
    const double t9 = t7*t8; /* 1/(Theta*D)*2*a3^2*Theta */
    const double t10 = t5*t7; /* D*1/(Theta*D) */
    const double t11 = JLT_FMA(p[41], t10, t9); /* R^2*(I1 - I3)*D*1/(Theta*D) + 1/(Theta*D)*2*a3^2*Theta */
    const double t12 = x[0]*t11; /* gamma3*(R^2*(I1 - I3)*D*1/(Theta*D) + 1/(Theta*D)*2*a3^2*Theta) */
    const double t13 = JLT_FNMA(t10, p[42], t12); /* t12 - D*1/(Theta*D)*R*a3*I3 */
    const double t14 = p[0]*x[2]; /* m*omega_tau */
    const double t15 = t0*t14; /* s*s*m*omega_tau */
    const double t16 = t13*t15; /* (t12 - D*1/(Theta*D)*R*a3*I3)*s*s*m*omega_tau */
    const double t17 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t18 = JLT_FMA(x[2], t17, x[1]); /* V = omega_tau*e + v_nu */
    const double t19 = t2*t18; /* b*m*I3*V */
    const double t20 = JLT_FNMA(t10, t19, t16); /* (t12 - D*1/(Theta*D)*R*a3*I3)*s*s*m*omega_tau - D*1/(Theta*D)*b*m*I3*V */
    out[0] = t20;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[21]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = p[1]*x[9]; /* R*s */
    const double t5 = JLT_FMA(x[4], t4, t3); /* v_tau = omega3*R*s + omega_n*b */
    const double t6 = JLT_FMA(t5, t5, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t7 = x[9]*p[13]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t10 = x[2]*t9; /* omega_tau*1/2*omega_tau */
    const double t11 = x[3]*p[44]; /* omega_n*1/2*I1 */
    const double t12 = x[4]*p[45]; /* omega3*1/2*I3 */
    const double t13 = JLT_FMA(x[3], t11, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(x[4], t12, t13); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t15 = JLT_FMA(t8, t10, t14); /* D*omega_tau*1/2*omega_tau + t14 */
    const double t16 = JLT_FMA(p[43], t6, t15); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t14 */
    const double t17 = x[9]*p[46]; /* s*R*I1 */
    const double t18 = x[3]*t17; /* omega_n*s*R*I1 */
    const double t19 = x[4]*p[5]; /* omega3*I3 */
    const double t20 = JLT_FNMA(t2, t19, t18); /* omega_n*s*R*I1 - b*omega3*I3 */
    out[0] = t16;
    out[1] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = x[3]*t0; /* omega_n*b */
    const double t2 = p[1]*x[4]; /* R*omega3 */
    const double t3 = JLT_FMA(x[9], t2, t1); /* v_tau = s*R*omega3 + omega_n*b */
    const double t4 = p[14]*t3; /* m*R*v_tau */
    const double t5 = JLT_FMA(x[3], t4, p[21]); /* omega_n*m*R*v_tau + m*g*a3 */
    const double t6 = p[0]*x[1]; /* m*v_nu */
    const double t7 = x[9]*p[13]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = x[2]*t8; /* omega_tau*D */
    const double t10 = x[3]*p[4]; /* omega_n*I1 */
    const double t11 = t0*p[0]; /* b*m */
    const double t12 = JLT_FMA(t3, t11, t10); /* v_tau*b*m + omega_n*I1 */
    const double t13 = x[4]*p[5]; /* omega3*I3 */
    const double t14 = JLT_FMA(x[9], t4, t13); /* s*m*R*v_tau + omega3*I3 */
    const double t15 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t16 = t7*t15; /* s*m*a3^2*omega_tau*omega_tau */
    const double t17 = JLT_FMA(x[4], t4, t16); /* omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    const double t18 = x[4]*p[47]; /* omega3*(-R*I3) */
    const double t19 = x[9]*p[46]; /* s*R*I1 */
    const double t20 = t0*p[20]; /* b*(-I3) */
    const double t21 = x[3]*p[46]; /* omega_n*R*I1 */
    out[0] = t5;
    out[1] = t6;
    out[2] = t9;
    out[3] = t12;
    out[4] = t14;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t17;
    out[10] = t18;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t19;
    out[14] = t20;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t21;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[9];
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
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
    double u67[JLT_JET_ORDER_MAX + 1];
    double t68[JLT_JET_ORDER_MAX + 1];
    double t69[JLT_JET_ORDER_MAX + 1];
    double t70[JLT_JET_ORDER_MAX + 1];
    double u70[JLT_JET_ORDER_MAX + 1];
    double t71[JLT_JET_ORDER_MAX + 1];
    double t72[JLT_JET_ORDER_MAX + 1];
    double t73[JLT_JET_ORDER_MAX + 1];
    double t74[JLT_JET_ORDER_MAX + 1];
    double t75[JLT_JET_ORDER_MAX + 1];
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
    coefficients[10] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x9, x2, k);
        t3[k] = jlt_jet_product(x9, t2, k);
        t8[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t9[k] = jlt_jet_product(x3, t8, k);
        t11[k] = jlt_jet_product(x9, x4, k);
        t12[k] = p[1]*t11[k] + t9[k];
        t13[k] = jlt_jet_product(x3, t12, k);
        t17[k] = jlt_jet_product(x9, x9, k);
        t19[k] = t8[k]*p[9];
        t20[k] = p[8]*t17[k] + (k == 0 ? p[7] : 0);
        t21[k] = jlt_jet_product(t8, t19, k) + t20[k];
        t23[k] = t17[k]*p[10];
        t24[k] = jlt_jet_product(x3, x0, k);
        t26[k] = t11[k]*p[11] + t24[k];
        t28[k] = jlt_jet_product(t2, x0, k);
        t29[k] = t2[k]*p[12];
        t30[k] = t23[k] - jlt_jet_product(t28, t29, k);
        t31[k] = jlt_jet_product(x3, t26, k) + t30[k];
        t34[k] = t17[k]*p[13] + (k == 0 ? p[4] : 0);
        t35[k] = jlt_jet_product(t21, t34, k);
        t37[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t35, t37, k);
        t38[k] = p[6]*t21[k];
        t39[k] = jlt_jet_product(t31, t38, k);
        t40[k] = jlt_jet_product(t37, t39, k);
        t42[k] = jlt_jet_product(t34, t37, k);
        t43[k] = jlt_jet_product(t11, t42, k);
        t45[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t46[k] = p[24]*t45[k];
        t47[k] = p[48]*t43[k] + t24[k];
        t48[k] = jlt_jet_product(t43, t46, k) + t47[k];
        t49[k] = jlt_jet_product(x2, t48, k);
        t51[k] = jlt_jet_product(x2, t45, k) + x1[k];
        t52[k] = jlt_jet_product(x3, t51, k);
        t53[k] = jlt_jet_product(t42, t52, k);
        t54[k] = t49[k] - jlt_jet_product(t19, t53, k);
        t56[k] = x9[k]*p[15];
        t57[k] = jlt_jet_product(t53, t56, k);
        t59[k] = t28[k]*p[16];
        t61[k] = t2[k]*p[17];
        t62[k] = jlt_jet_product(t43, t59, k) - t57[k];
        t63[k] = t62[k] - jlt_jet_product(t43, t61, k);
        t64[k] = -x3[k];
        t65[k] = t11[k] + t24[k];
        t67[k] = jlt_jet_cosine(x5, t67, u67, k);
        t68[k] = jlt_jet_product(x9, t67, k);
        t69[k] = jlt_jet_product(x1, t68, k);
        t70[k] = jlt_jet_sine(x5, t70, u70, k);
        t71[k] = jlt_jet_product(x9, t70, k);
        t72[k] = jlt_jet_product(t12, t71, k) + t69[k];
        t73[k] = jlt_jet_product(x1, t71, k);
        t74[k] = t73[k] - jlt_jet_product(t12, t68, k);
        t75[k] = -t28[k];
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t13[k]/(k + 1);
        next[2] = x2[k + 1] = t40[k]/(k + 1);
        next[3] = x3[k + 1] = t54[k]/(k + 1);
        next[4] = x4[k + 1] = t63[k]/(k + 1);
        next[5] = x5[k + 1] = t64[k]/(k + 1);
        next[6] = x6[k + 1] = t65[k]/(k + 1);
        next[7] = x7[k + 1] = t72[k]/(k + 1);
        next[8] = x8[k + 1] = t74[k]/(k + 1);
        next[9] = x9[k + 1] = t75[k]/(k + 1);
        next[10] = x9[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[9];
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
    out[5] = (v_s)*((-v_omega_n/v_s));
    out[6] = (v_s)*((v_omega3)
        + (v_gamma3*v_omega_n/v_s));
    const double complex v_chi = x[5];
    const double complex v_C = ccos(v_chi);
    const double complex v_S = csin(v_chi);
    const double complex v_v_tau = (v_omega_n*v_b + v_R*v_omega3*v_s);
    out[7] = (v_s)*((v_v_nu*v_C)
        + (v_S*v_v_tau));
    out[8] = (v_s)*((v_v_nu*v_S)
        + (-v_C*v_v_tau));
    out[9] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "chi", "rad", "direction of nu in the plane: precession", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "spin", "rad", "proper rotation about the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "x", "m", "centre of mass, along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "y", "m", "centre of mass, along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_track_general_in_regular = {
    .model = "spherical_top_track",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_track,
    .state_count = 10, .param_count = 6, .block_count = 49,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 10, { 3, 29, 17, 1, 0, 2, 10, 12 }, { 22, 91, 0, 10, 0, 2, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 100, { 14, 87, 38, 1, 0, 2, 14, 23 }, { 66, 414, 0, 49, 0, 2, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 110, { 17, 95, 44, 1, 0, 2, 14, 33 }, { 81, 486, 0, 59, 0, 2, 14, 12 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 0, 11, 9, 1, 0, 0, 11, 6 }, { 10, 39, 0, 4, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 2, { 0, 12, 9, 0, 0, 0, 5, 8 }, { 9, 31, 0, 0, 0, 0, 10, 5 },
        "" },
    .integral_gradients = { integral_gradients, 20, { 0, 15, 7, 0, 0, 0, 5, 7 }, { 9, 37, 0, 0, 0, 0, 6, 6 },
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
        &jlt_batch_spherical_top_track_general_in_regular_baseline,
        &jlt_batch_spherical_top_track_general_in_regular_avx2,
        &jlt_batch_spherical_top_track_general_in_regular_avx512,
    },
};
