/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 a3580c03c4e57c8611cf766b2671a74fbd573f922ecd03ff5771c0b58df91c97
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   29   17    1    0    2     10   12   (125)
 *  jacobian            14   87   38    1    0    2     14   24   (531)
 *  rhs_jacobian        17   94   45    1    0    2     14   34   (628)
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
    const double t23 = params[0]*params[3]; /* m*a3 */
    const double t24 = params[2]*2.0; /* g*2 */
    const double t25 = params[3]*2.0; /* a3*2 */
    const double t26 = params[5]*t25; /* I3*a3*2 */
    const double t27 = params[4]*t20; /* I1*a3*a3*m*2 */
    const double t28 = params[5]*t23; /* I3*m*a3 */
    const double t29 = params[5]*t13; /* I3*m*R */
    const double t30 = params[5]*params[5]; /* I3*I3 */
    const double t31 = t13*t30; /* m*R*I3*I3 */
    const double t32 = params[5]*2.0; /* I3*2 */
    const double t33 = params[1]*2.0; /* R*2 */
    const double t34 = params[5]*t4; /* I3*I1*m*R*R */
    const double t35 = params[0]*params[0]; /* m*m */
    const double t36 = t2*t35; /* R*R*m*m */
    const double t37 = params[5]*t36; /* I3*R*R*m*m */
    const double t38 = t15*t33; /* (I1 - I3)*R*2 */
    const double t39 = params[4]*t17; /* I1*a3*m*R */
    const double t40 = params[5]*params[3]; /* I3*a3 */
    const double t41 = params[1]*t15; /* R*(I1 - I3) */
    const double t42 = params[1]*t2; /* R*R*R */
    const double t43 = t35*t42; /* m*m*R*R*R */
    const double t44 = params[4]*t43; /* I1*m*m*R*R*R */
    const double t45 = params[2]*t19; /* g*m*2 */
    const double t46 = params[3]*t45; /* a3*g*m*2 */
    const double t47 = t2*t19; /* R*R*m*2 */
    const double t48 = params[4]*t47; /* I1*R*R*m*2 */
    const double t49 = t10*2.0; /* a3*a3*2 */
    const double t50 = t2*t15; /* R*R*(I1 - I3) */
    const double t51 = params[1]*params[3]; /* R*a3 */
    const double t52 = params[5]*t51; /* I3*R*a3 */
    const double t53 = params[0]/2.0; /* m/2 */
    const double t54 = params[4]/2.0; /* I1/2 */
    const double t55 = params[5]/2.0; /* I3/2 */
    const double t56 = params[4]*params[1]; /* I1*R */
    const double t57 = params[5]*params[1]; /* I3*R */
    const double t58 = -t57; /* -I3*R */
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
    out[21] = t23;
    out[22] = t24;
    out[23] = t25;
    out[24] = t26;
    out[25] = t27;
    out[26] = t28;
    out[27] = t29;
    out[28] = t31;
    out[29] = t32;
    out[30] = t33;
    out[31] = t34;
    out[32] = t37;
    out[33] = t38;
    out[34] = t39;
    out[35] = t40;
    out[36] = t41;
    out[37] = t44;
    out[38] = t7;
    out[39] = t46;
    out[40] = t48;
    out[41] = t49;
    out[42] = t50;
    out[43] = t52;
    out[44] = t53;
    out[45] = t54;
    out[46] = t55;
    out[47] = t56;
    out[48] = t58;
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
    const double t12 = t5*p[9]; /* b*m*I3 */
    const double t13 = JLT_FMA(t0, p[8], p[7]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t14 = JLT_FMA(t5, t12, t13); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t15 = JLT_FMA(t0, p[13], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t16 = t14*t15; /* Theta*D */
    const double t17 = 1.0/t16; /* 1/(Theta*D) */
    const double t18 = t14*t17; /* Theta*1/(Theta*D) */
    const double t19 = x[9]*t18; /* s*Theta*1/(Theta*D) */
    const double t20 = x[9]*t19; /* s*s*Theta*1/(Theta*D) */
    const double t21 = p[13]*t20; /* m*a3^2*s*s*Theta*1/(Theta*D) */
    const double t22 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t23 = t21*t22; /* m*a3^2*s*s*Theta*1/(Theta*D)*omega_tau*omega_tau */
    const double t24 = x[3]*t18; /* omega_n*Theta*1/(Theta*D) */
    const double t25 = x[3]*p[4]; /* omega_n*I1 */
    const double t26 = JLT_FNMA(t24, t25, t23); /* m*a3^2*s*s*Theta*1/(Theta*D)*omega_tau*omega_tau - omega_n*Theta*1/(Theta*D)*omega_n*I1 */
    const double t27 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t28 = p[18]*t27; /* 2*m*a3^2*omega_tau*gamma3 */
    const double t29 = t20*t28; /* s*s*Theta*1/(Theta*D)*2*m*a3^2*omega_tau*gamma3 */
    const double t30 = x[0]*t24; /* gamma3*omega_n*Theta*1/(Theta*D) */
    const double t31 = p[19]*t30; /* 2*I1*gamma3*omega_n*Theta*1/(Theta*D) */
    const double t32 = x[4]*p[5]; /* omega3*I3 */
    const double t33 = JLT_FMA(t19, t32, t31); /* s*Theta*1/(Theta*D)*omega3*I3 + 2*I1*gamma3*omega_n*Theta*1/(Theta*D) */
    const double t34 = -t33; /* -t33 */
    const double t35 = x[3]*t19; /* omega_n*s*Theta*1/(Theta*D) */
    const double t36 = p[20]*t35; /* (-I3)*omega_n*s*Theta*1/(Theta*D) */
    const double t37 = x[2]*p[23]; /* omega_tau*2*a3 */
    const double t38 = JLT_FNMA(t27, t37, p[22]); /* 2*g - omega_tau*gamma3*omega_tau*2*a3 */
    const double t39 = x[4]*p[24]; /* omega3*2*a3*I3 */
    const double t40 = JLT_FMS(t35, t39, t38); /* omega_n*s*Theta*1/(Theta*D)*omega3*2*a3*I3 - (2*g - omega_tau*gamma3*omega_tau*2*a3) */
    const double t41 = JLT_FMA(t21, t38, t40); /* m*a3^2*s*s*Theta*1/(Theta*D)*(2*g - omega_tau*gamma3*omega_tau*2*a3) + t40 */
    const double t42 = t19*p[21]; /* s*Theta*1/(Theta*D)*m*a3 */
    const double t43 = t24*t32; /* omega_n*Theta*1/(Theta*D)*omega3*I3 */
    const double t44 = t35*p[25]; /* omega_n*s*Theta*1/(Theta*D)*2*m*a3^2*I1 */
    const double t45 = JLT_FMS(t30, t44, t43); /* gamma3*omega_n*Theta*1/(Theta*D)*omega_n*s*Theta*1/(Theta*D)*2*m*a3^2*I1 - omega_n*Theta*1/(Theta*D)*omega3*I3 */
    const double t46 = JLT_FMA(t41, t42, t45); /* t41*s*Theta*1/(Theta*D)*m*a3 + t45 */
    const double t47 = t15*t17; /* D*1/(Theta*D) */
    const double t48 = x[9]*t47; /* s*D*1/(Theta*D) */
    const double t49 = x[2]*t48; /* omega_tau*s*D*1/(Theta*D) */
    const double t50 = x[4]*t49; /* omega3*omega_tau*s*D*1/(Theta*D) */
    const double t51 = p[17]*t50; /* m*R*a3*I3*omega3*omega_tau*s*D*1/(Theta*D) */
    const double t52 = t5*t47; /* b*D*1/(Theta*D) */
    const double t53 = JLT_FNMA(p[26], t52, 1.0); /* 1 - m*a3*I3*b*D*1/(Theta*D) */
    const double t54 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t55 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t56 = JLT_FMA(x[2], t55, x[1]); /* V = omega_tau*e + v_nu */
    const double t57 = x[3]*t56; /* omega_n*V */
    const double t58 = t47*t57; /* D*1/(Theta*D)*omega_n*V */
    const double t59 = t50*p[29]; /* omega3*omega_tau*s*D*1/(Theta*D)*2*I3 */
    const double t60 = 2.0*t57; /* 2*omega_n*V */
    const double t61 = t52*t60; /* b*D*1/(Theta*D)*2*omega_n*V */
    const double t62 = t55*p[30]; /* e*2*R */
    const double t63 = JLT_FNMA(t50, t62, t61); /* b*D*1/(Theta*D)*2*omega_n*V - omega3*omega_tau*s*D*1/(Theta*D)*e*2*R */
    const double t64 = JLT_FNMA(p[0], t63, t59); /* omega3*omega_tau*s*D*1/(Theta*D)*2*I3 - m*t63 */
    const double t65 = t52*p[28]; /* b*D*1/(Theta*D)*m*R*I3^2 */
    const double t66 = JLT_FNMA(p[27], t58, t51); /* m*R*a3*I3*omega3*omega_tau*s*D*1/(Theta*D) - m*R*I3*D*1/(Theta*D)*omega_n*V */
    const double t67 = JLT_FMA(t53, t54, t66); /* (1 - m*a3*I3*b*D*1/(Theta*D))*omega_tau*omega_n + t66 */
    const double t68 = JLT_FNMA(t64, t65, t67); /* (1 - m*a3*I3*b*D*1/(Theta*D))*omega_tau*omega_n + t66 - (omega3*omega_tau*s*D*1/(Theta*D)*2*I3 - m*t63)*b*D*1/(Theta*D)*m*R*I3^2 */
    const double t69 = p[9]*t52; /* m*I3*b*D*1/(Theta*D) */
    const double t70 = x[3]*t69; /* omega_n*m*I3*b*D*1/(Theta*D) */
    const double t71 = -t70; /* -omega_n*m*I3*b*D*1/(Theta*D) */
    const double t72 = JLT_FNMA(t55, t69, x[0]); /* gamma3 - e*m*I3*b*D*1/(Theta*D) */
    const double t73 = x[3]*t72; /* omega_n*(gamma3 - e*m*I3*b*D*1/(Theta*D)) */
    const double t74 = JLT_FMA(t55, p[14], p[5]); /* e*m*R + I3 */
    const double t75 = t32*t74; /* omega3*I3*(e*m*R + I3) */
    const double t76 = JLT_FMA(t48, t75, t73); /* s*D*1/(Theta*D)*omega3*I3*(e*m*R + I3) + omega_n*(gamma3 - e*m*I3*b*D*1/(Theta*D)) */
    const double t77 = JLT_FNMA(t56, t69, t27); /* omega_tau*gamma3 - V*m*I3*b*D*1/(Theta*D) */
    const double t78 = p[5]*t74; /* I3*(e*m*R + I3) */
    const double t79 = t49*t78; /* omega_tau*s*D*1/(Theta*D)*I3*(e*m*R + I3) */
    const double t80 = x[2]*t75; /* omega_tau*omega3*I3*(e*m*R + I3) */
    const double t81 = t47*t80; /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) */
    const double t82 = t48*p[31]; /* s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t83 = JLT_FNMA(t64, t82, t81); /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) - (omega3*omega_tau*s*D*1/(Theta*D)*2*I3 - m*t63)*s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t84 = JLT_FNMA(x[0], p[33], p[24]); /* 2*a3*I3 - gamma3*2*R*(I1 - I3) */
    const double t85 = t50*t84; /* omega3*omega_tau*s*D*1/(Theta*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t86 = t5*t85; /* b*t85 */
    const double t87 = p[19]*t57; /* 2*I1*omega_n*V */
    const double t88 = JLT_FMA(t52, t87, t86); /* b*D*1/(Theta*D)*2*I1*omega_n*V + b*t85 */
    const double t89 = t48*p[32]; /* s*D*1/(Theta*D)*m^2*R^2*I3 */
    const double t90 = x[3]*p[34]; /* omega_n*m*R*a3*I1 */
    const double t91 = t49*t90; /* omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t92 = x[9]*p[16]; /* s*m*R^2*(I1 - I3) */
    const double t93 = JLT_FMS(t50, t92, t91); /* omega3*omega_tau*s*D*1/(Theta*D)*s*m*R^2*(I1 - I3) - omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t94 = JLT_FMA(t88, t89, t93); /* (b*D*1/(Theta*D)*2*I1*omega_n*V + b*t85)*s*D*1/(Theta*D)*m^2*R^2*I3 + t93 */
    const double t95 = t48*p[15]; /* s*D*1/(Theta*D)*m*R*I1 */
    const double t96 = x[3]*t95; /* omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t97 = -t96; /* -omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t98 = t55*t96; /* e*omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t99 = JLT_FNMA(x[0], p[36], p[35]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t100 = x[9]*p[14]; /* s*m*R */
    const double t101 = t99*t100; /* (a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t102 = x[4]*t101; /* omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t103 = JLT_FMA(t48, t102, t98); /* s*D*1/(Theta*D)*omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R + e*omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t104 = -t103; /* -t103 */
    const double t105 = t56*t95; /* V*s*D*1/(Theta*D)*m*R*I1 */
    const double t106 = -t105; /* -V*s*D*1/(Theta*D)*m*R*I1 */
    const double t107 = t49*t101; /* omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t108 = -t107; /* -omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t109 = t58*p[15]; /* D*1/(Theta*D)*omega_n*V*m*R*I1 */
    const double t110 = x[9]*t85; /* s*t85 */
    const double t111 = JLT_FMA(t48, t87, t110); /* s*D*1/(Theta*D)*2*I1*omega_n*V + s*t85 */
    const double t112 = t48*p[37]; /* s*D*1/(Theta*D)*m^2*R^3*I1 */
    const double t113 = JLT_FMS(t111, t112, t109); /* (s*D*1/(Theta*D)*2*I1*omega_n*V + s*t85)*s*D*1/(Theta*D)*m^2*R^3*I1 - D*1/(Theta*D)*omega_n*V*m*R*I1 */
    const double t114 = JLT_FNMA(p[14], t85, t113); /* t113 - m*R*t85 */
    const double t115 = sin(x[5]); /* S = sin(chi) */
    const double t116 = t10*t115; /* omega_n*s*R*S */
    const double t117 = cos(x[5]); /* C = cos(chi) */
    const double t118 = x[9]*t117; /* s*C */
    const double t119 = x[9]*t115; /* s*S */
    const double t120 = t5*t119; /* b*s*S */
    const double t121 = t7*t119; /* s*R*s*S */
    const double t122 = x[1]*t115; /* v_nu*S */
    const double t123 = t6 + t8; /* v_tau = omega_n*b + omega3*s*R */
    const double t124 = JLT_FNMA(t117, t123, t122); /* v_nu*S - C*v_tau */
    const double t125 = x[9]*t124; /* s*(v_nu*S - C*v_tau) */
    const double t126 = -t125; /* -s*(v_nu*S - C*v_tau) */
    const double t127 = x[1]*t117; /* v_nu*C */
    const double t128 = JLT_FMA(t115, t123, t127); /* S*v_tau + v_nu*C */
    const double t129 = JLT_FMA(t8, t115, t128); /* omega3*s*R*S + S*v_tau + v_nu*C */
    const double t130 = t10*t117; /* omega_n*s*R*C */
    const double t131 = -t130; /* -omega_n*s*R*C */
    const double t132 = t5*t118; /* b*s*C */
    const double t133 = -t132; /* -b*s*C */
    const double t134 = t7*t118; /* s*R*s*C */
    const double t135 = -t134; /* -s*R*s*C */
    const double t136 = x[9]*t128; /* s*(S*v_tau + v_nu*C) */
    const double t137 = JLT_FNMA(t8, t117, t124); /* v_nu*S - C*v_tau - omega3*s*R*C */
    const double t138 = -t1; /* -s*omega_tau */
    const double t139 = x[9]*x[0]; /* s*gamma3 */
    const double t140 = -t139; /* -s*gamma3 */
    const double t141 = -t27; /* -omega_tau*gamma3 */
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
    out[20] = t26;
    out[21] = 0.0;
    out[22] = t29;
    out[23] = t34;
    out[24] = t36;
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
    out[40] = t94;
    out[41] = t97;
    out[42] = t104;
    out[43] = t106;
    out[44] = t108;
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
    out[75] = t126;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = t129;
    out[80] = t131;
    out[81] = t119;
    out[82] = 0.0;
    out[83] = t133;
    out[84] = t135;
    out[85] = t136;
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
    const double t0 = x[9]*x[2]; /* s*omega_tau */
    const double t1 = x[9]*t0; /* s*s*omega_tau */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[9]*p[1]; /* s*R */
    const double t5 = x[4]*t4; /* omega3*s*R */
    const double t6 = t3 + t5; /* omega_n*b + omega3*s*R */
    const double t7 = x[3]*t6; /* omega_n*(omega_n*b + omega3*s*R) */
    const double t8 = x[9]*x[9]; /* s*s */
    const double t9 = t2*p[9]; /* b*m*I3 */
    const double t10 = JLT_FMA(p[8], t8, p[7]); /* m*R^2*I1*s*s + I1*I3 */
    const double t11 = JLT_FMA(t2, t9, t10); /* Theta = b*b*m*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t12 = JLT_FMA(t8, p[13], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t13 = t11*t12; /* Theta*D */
    const double t14 = 1.0/t13; /* 1/(Theta*D) */
    const double t15 = t11*t14; /* Theta*1/(Theta*D) */
    const double t16 = x[9]*t15; /* s*Theta*1/(Theta*D) */
    const double t17 = t0*t16; /* s*omega_tau*s*Theta*1/(Theta*D) */
    const double t18 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t19 = t17*t18; /* s*omega_tau*s*Theta*1/(Theta*D)*omega_tau*m*a3^2/I1 */
    const double t20 = x[3]*t15; /* omega_n*Theta*1/(Theta*D) */
    const double t21 = JLT_FNMA(x[3], t20, t19); /* s*omega_tau*s*Theta*1/(Theta*D)*omega_tau*m*a3^2/I1 - omega_n*omega_n*Theta*1/(Theta*D) */
    const double t22 = p[4]*t21; /* I1*t21 */
    const double t23 = x[0]*t22; /* gamma3*I1*t21 */
    const double t24 = x[9]*t16; /* s*s*Theta*1/(Theta*D) */
    const double t25 = x[4]*p[5]; /* omega3*I3 */
    const double t26 = x[3]*t16; /* omega_n*s*Theta*1/(Theta*D) */
    const double t27 = JLT_FNMA(p[38], t24, t23); /* gamma3*I1*t21 - m*g*a3*s*s*Theta*1/(Theta*D) */
    const double t28 = JLT_FNMA(t25, t26, t27); /* gamma3*I1*t21 - m*g*a3*s*s*Theta*1/(Theta*D) - omega3*I3*omega_n*s*Theta*1/(Theta*D) */
    const double t29 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t30 = x[2]*t29; /* omega_tau*omega_n*gamma3 */
    const double t31 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t32 = JLT_FMA(x[2], t31, x[1]); /* V = omega_tau*e + v_nu */
    const double t33 = x[3]*t32; /* omega_n*V */
    const double t34 = t12*t14; /* D*1/(Theta*D) */
    const double t35 = t2*t34; /* b*D*1/(Theta*D) */
    const double t36 = p[9]*t35; /* m*I3*b*D*1/(Theta*D) */
    const double t37 = x[9]*t34; /* s*D*1/(Theta*D) */
    const double t38 = x[2]*t37; /* omega_tau*s*D*1/(Theta*D) */
    const double t39 = x[4]*t38; /* omega3*omega_tau*s*D*1/(Theta*D) */
    const double t40 = JLT_FMA(t31, p[14], p[5]); /* e*m*R + I3 */
    const double t41 = p[5]*t40; /* I3*(e*m*R + I3) */
    const double t42 = JLT_FNMA(t33, t36, t30); /* omega_tau*omega_n*gamma3 - omega_n*V*m*I3*b*D*1/(Theta*D) */
    const double t43 = JLT_FMA(t39, t41, t42); /* omega3*omega_tau*s*D*1/(Theta*D)*I3*(e*m*R + I3) + omega_tau*omega_n*gamma3 - omega_n*V*m*I3*b*D*1/(Theta*D) */
    const double t44 = t37*p[15]; /* s*D*1/(Theta*D)*m*R*I1 */
    const double t45 = t33*t44; /* omega_n*V*s*D*1/(Theta*D)*m*R*I1 */
    const double t46 = JLT_FNMA(x[0], p[36], p[35]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t47 = x[9]*p[14]; /* s*m*R */
    const double t48 = t46*t47; /* (a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t49 = JLT_FMA(t39, t48, t45); /* omega3*omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R + omega_n*V*s*D*1/(Theta*D)*m*R*I1 */
    const double t50 = -t49; /* -t49 */
    const double t51 = -x[3]; /* -omega_n */
    const double t52 = JLT_FMA(x[9], x[4], t29); /* s*omega3 + omega_n*gamma3 */
    const double t53 = cos(x[5]); /* C = cos(chi) */
    const double t54 = x[1]*t53; /* v_nu*C */
    const double t55 = sin(x[5]); /* S = sin(chi) */
    const double t56 = JLT_FMA(t6, t55, t54); /* (omega_n*b + omega3*s*R)*S + v_nu*C */
    const double t57 = x[9]*t56; /* s*((omega_n*b + omega3*s*R)*S + v_nu*C) */
    const double t58 = x[1]*t55; /* v_nu*S */
    const double t59 = JLT_FNMA(t6, t53, t58); /* v_nu*S - (omega_n*b + omega3*s*R)*C */
    const double t60 = x[9]*t59; /* s*(v_nu*S - (omega_n*b + omega3*s*R)*C) */
    const double t61 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t62 = -t61; /* -s*omega_tau*gamma3 */
    const double t63 = t0*2.0; /* s*omega_tau*2 */
    const double t64 = x[3]*p[1]; /* omega_n*R */
    const double t65 = x[3]*t64; /* omega_n*omega_n*R */
    const double t66 = JLT_FMA(t3, 2.0, t5); /* omega_n*b*2 + omega3*s*R */
    const double t67 = x[3]*t4; /* omega_n*s*R */
    const double t68 = x[4]*t64; /* omega3*omega_n*R */
    const double t69 = t17*p[18]; /* s*omega_tau*s*Theta*1/(Theta*D)*2*m*a3^2 */
    const double t70 = x[0]*t69; /* gamma3*s*omega_tau*s*Theta*1/(Theta*D)*2*m*a3^2 */
    const double t71 = t15*t29; /* Theta*1/(Theta*D)*omega_n*gamma3 */
    const double t72 = p[19]*t71; /* 2*I1*Theta*1/(Theta*D)*omega_n*gamma3 */
    const double t73 = JLT_FMA(t16, t25, t72); /* s*Theta*1/(Theta*D)*omega3*I3 + 2*I1*Theta*1/(Theta*D)*omega_n*gamma3 */
    const double t74 = -t73; /* -t73 */
    const double t75 = t26*p[20]; /* omega_n*s*Theta*1/(Theta*D)*(-I3) */
    const double t76 = x[4]*p[29]; /* omega3*2*I3 */
    const double t77 = t26*t76; /* omega_n*s*Theta*1/(Theta*D)*omega3*2*I3 */
    const double t78 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t79 = JLT_FMS(x[2], 2.0, t69); /* omega_tau*2 - s*omega_tau*s*Theta*1/(Theta*D)*2*m*a3^2 */
    const double t80 = JLT_FMA(t24, p[39], t77); /* s*s*Theta*1/(Theta*D)*2*m*g*a3 + omega_n*s*Theta*1/(Theta*D)*omega3*2*I3 */
    const double t81 = JLT_FMA(t78, t79, t80); /* omega_tau*gamma3*(omega_tau*2 - s*omega_tau*s*Theta*1/(Theta*D)*2*m*a3^2) + t80 */
    const double t82 = p[13]*t16; /* m*a3^2*s*Theta*1/(Theta*D) */
    const double t83 = t16*p[39]; /* s*Theta*1/(Theta*D)*2*m*g*a3 */
    const double t84 = t71*p[25]; /* Theta*1/(Theta*D)*omega_n*gamma3*2*m*a3^2*I1 */
    const double t85 = JLT_FMS(t26, t84, t83); /* omega_n*s*Theta*1/(Theta*D)*Theta*1/(Theta*D)*omega_n*gamma3*2*m*a3^2*I1 - s*Theta*1/(Theta*D)*2*m*g*a3 */
    const double t86 = JLT_FNMA(t20, t25, t85); /* t85 - omega_n*Theta*1/(Theta*D)*omega3*I3 */
    const double t87 = JLT_FMA(t81, t82, t86); /* t81*m*a3^2*s*Theta*1/(Theta*D) + t85 - omega_n*Theta*1/(Theta*D)*omega3*I3 */
    const double t88 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t89 = t33*p[27]; /* omega_n*V*m*R*I3 */
    const double t90 = t88*p[26]; /* omega_tau*omega_n*m*a3*I3 */
    const double t91 = t39*p[29]; /* omega3*omega_tau*s*D*1/(Theta*D)*2*I3 */
    const double t92 = t31*p[30]; /* e*2*R */
    const double t93 = t39*t92; /* omega3*omega_tau*s*D*1/(Theta*D)*e*2*R */
    const double t94 = t33*t35; /* omega_n*V*b*D*1/(Theta*D) */
    const double t95 = JLT_FNMA(2.0, t94, t93); /* omega3*omega_tau*s*D*1/(Theta*D)*e*2*R - 2*omega_n*V*b*D*1/(Theta*D) */
    const double t96 = JLT_FMA(p[0], t95, t91); /* m*t95 + omega3*omega_tau*s*D*1/(Theta*D)*2*I3 */
    const double t97 = t35*p[28]; /* b*D*1/(Theta*D)*m*R*I3^2 */
    const double t98 = JLT_FNMA(t34, t89, t88); /* omega_tau*omega_n - D*1/(Theta*D)*omega_n*V*m*R*I3 */
    const double t99 = JLT_FNMA(t35, t90, t98); /* omega_tau*omega_n - D*1/(Theta*D)*omega_n*V*m*R*I3 - b*D*1/(Theta*D)*omega_tau*omega_n*m*a3*I3 */
    const double t100 = JLT_FMA(t39, p[17], t99); /* omega3*omega_tau*s*D*1/(Theta*D)*m*R*a3*I3 + t99 */
    const double t101 = JLT_FNMA(t96, t97, t100); /* omega3*omega_tau*s*D*1/(Theta*D)*m*R*a3*I3 + t99 - (m*t95 + omega3*omega_tau*s*D*1/(Theta*D)*2*I3)*b*D*1/(Theta*D)*m*R*I3^2 */
    const double t102 = x[3]*t36; /* omega_n*m*I3*b*D*1/(Theta*D) */
    const double t103 = -t102; /* -omega_n*m*I3*b*D*1/(Theta*D) */
    const double t104 = t25*t40; /* omega3*I3*(e*m*R + I3) */
    const double t105 = JLT_FMA(t37, t104, t29); /* s*D*1/(Theta*D)*omega3*I3*(e*m*R + I3) + omega_n*gamma3 */
    const double t106 = JLT_FNMA(t31, t102, t105); /* s*D*1/(Theta*D)*omega3*I3*(e*m*R + I3) + omega_n*gamma3 - e*omega_n*m*I3*b*D*1/(Theta*D) */
    const double t107 = JLT_FNMA(t32, t36, t78); /* omega_tau*gamma3 - V*m*I3*b*D*1/(Theta*D) */
    const double t108 = t38*t41; /* omega_tau*s*D*1/(Theta*D)*I3*(e*m*R + I3) */
    const double t109 = x[2]*t104; /* omega_tau*omega3*I3*(e*m*R + I3) */
    const double t110 = t34*t109; /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) */
    const double t111 = t37*p[31]; /* s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t112 = JLT_FNMA(t96, t111, t110); /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) - (m*t95 + omega3*omega_tau*s*D*1/(Theta*D)*2*I3)*s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t113 = JLT_FNMA(x[0], p[33], p[24]); /* 2*a3*I3 - gamma3*2*R*(I1 - I3) */
    const double t114 = t39*t113; /* omega3*omega_tau*s*D*1/(Theta*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t115 = t2*t114; /* b*t114 */
    const double t116 = JLT_FMA(p[19], t94, t115); /* 2*I1*omega_n*V*b*D*1/(Theta*D) + b*t114 */
    const double t117 = t37*p[32]; /* s*D*1/(Theta*D)*m^2*R^2*I3 */
    const double t118 = x[3]*p[34]; /* omega_n*m*R*a3*I1 */
    const double t119 = t38*t118; /* omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t120 = x[9]*p[16]; /* s*m*R^2*(I1 - I3) */
    const double t121 = JLT_FMS(t39, t120, t119); /* omega3*omega_tau*s*D*1/(Theta*D)*s*m*R^2*(I1 - I3) - omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t122 = JLT_FMA(t116, t117, t121); /* (2*I1*omega_n*V*b*D*1/(Theta*D) + b*t114)*s*D*1/(Theta*D)*m^2*R^2*I3 + t121 */
    const double t123 = x[3]*t44; /* omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t124 = -t123; /* -omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t125 = t31*t123; /* e*omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t126 = x[4]*t48; /* omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t127 = JLT_FMA(t37, t126, t125); /* s*D*1/(Theta*D)*omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R + e*omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t128 = -t127; /* -t127 */
    const double t129 = t32*t44; /* V*s*D*1/(Theta*D)*m*R*I1 */
    const double t130 = -t129; /* -V*s*D*1/(Theta*D)*m*R*I1 */
    const double t131 = t38*t48; /* omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t132 = -t131; /* -omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t133 = t37*p[40]; /* s*D*1/(Theta*D)*2*m*R^2*I1 */
    const double t134 = JLT_FNMA(t37, t133, t34); /* D*1/(Theta*D) - s*D*1/(Theta*D)*s*D*1/(Theta*D)*2*m*R^2*I1 */
    const double t135 = t33*p[15]; /* omega_n*V*m*R*I1 */
    const double t136 = t134*t135; /* (D*1/(Theta*D) - s*D*1/(Theta*D)*s*D*1/(Theta*D)*2*m*R^2*I1)*omega_n*V*m*R*I1 */
    const double t137 = x[9]*p[37]; /* s*m^2*R^3*I1 */
    const double t138 = t37*t137; /* s*D*1/(Theta*D)*s*m^2*R^3*I1 */
    const double t139 = JLT_FMS(t114, t138, t136); /* t114*s*D*1/(Theta*D)*s*m^2*R^3*I1 - t136 */
    const double t140 = JLT_FNMA(p[14], t114, t139); /* t114*s*D*1/(Theta*D)*s*m^2*R^3*I1 - t136 - m*R*t114 */
    const double t141 = t55*t67; /* S*omega_n*s*R */
    const double t142 = x[9]*t53; /* s*C */
    const double t143 = x[9]*t55; /* s*S */
    const double t144 = t2*t143; /* b*s*S */
    const double t145 = t4*t143; /* s*R*s*S */
    const double t146 = -t60; /* -s*(v_nu*S - (omega_n*b + omega3*s*R)*C) */
    const double t147 = JLT_FMA(t5, t55, t56); /* omega3*s*R*S + (omega_n*b + omega3*s*R)*S + v_nu*C */
    const double t148 = t53*t67; /* C*omega_n*s*R */
    const double t149 = -t148; /* -C*omega_n*s*R */
    const double t150 = t2*t142; /* b*s*C */
    const double t151 = -t150; /* -b*s*C */
    const double t152 = t4*t142; /* s*R*s*C */
    const double t153 = -t152; /* -s*R*s*C */
    const double t154 = JLT_FNMA(t5, t53, t59); /* v_nu*S - (omega_n*b + omega3*s*R)*C - omega3*s*R*C */
    const double t155 = -t0; /* -s*omega_tau */
    const double t156 = x[9]*x[0]; /* s*gamma3 */
    const double t157 = -t156; /* -s*gamma3 */
    const double t158 = -t78; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t7;
    out[2] = t28;
    out[3] = t43;
    out[4] = t50;
    out[5] = t51;
    out[6] = t52;
    out[7] = t57;
    out[8] = t60;
    out[9] = t62;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t8;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t63;
    out[20] = t65;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = t66;
    out[24] = t67;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t68;
    out[30] = t22;
    out[31] = 0.0;
    out[32] = t70;
    out[33] = t74;
    out[34] = t75;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t87;
    out[40] = t101;
    out[41] = t103;
    out[42] = t106;
    out[43] = t107;
    out[44] = t108;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t112;
    out[50] = t122;
    out[51] = t124;
    out[52] = t128;
    out[53] = t130;
    out[54] = t132;
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
    const double t8 = p[41]*t4; /* 2*a3^2*Theta */
    const double t9 = t7*t8; /* 1/(Theta*D)*2*a3^2*Theta */
    const double t10 = t5*t7; /* D*1/(Theta*D) */
    const double t11 = JLT_FMA(p[42], t10, t9); /* R^2*(I1 - I3)*D*1/(Theta*D) + 1/(Theta*D)*2*a3^2*Theta */
    const double t12 = x[0]*t11; /* gamma3*(R^2*(I1 - I3)*D*1/(Theta*D) + 1/(Theta*D)*2*a3^2*Theta) */
    const double t13 = JLT_FNMA(t10, p[43], t12); /* t12 - D*1/(Theta*D)*R*a3*I3 */
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
    const double t0 = p[38]*x[0]; /* m*g*a3*gamma3 */
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
    const double t11 = x[3]*p[45]; /* omega_n*1/2*I1 */
    const double t12 = x[4]*p[46]; /* omega3*1/2*I3 */
    const double t13 = JLT_FMA(x[3], t11, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(x[4], t12, t13); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t15 = JLT_FMA(t8, t10, t14); /* D*omega_tau*1/2*omega_tau + t14 */
    const double t16 = JLT_FMA(p[44], t6, t15); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t14 */
    const double t17 = x[9]*p[47]; /* s*R*I1 */
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
    const double t5 = JLT_FMA(x[3], t4, p[38]); /* omega_n*m*R*v_tau + m*g*a3 */
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
    const double t18 = x[4]*p[48]; /* omega3*(-R*I3) */
    const double t19 = x[9]*p[47]; /* s*R*I1 */
    const double t20 = t0*p[20]; /* b*(-I3) */
    const double t21 = x[3]*p[47]; /* omega_n*R*I1 */
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
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double u66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
    double t68[JLT_JET_ORDER_MAX + 1];
    double u68[JLT_JET_ORDER_MAX + 1];
    double t69[JLT_JET_ORDER_MAX + 1];
    double t70[JLT_JET_ORDER_MAX + 1];
    double t71[JLT_JET_ORDER_MAX + 1];
    double t72[JLT_JET_ORDER_MAX + 1];
    double t73[JLT_JET_ORDER_MAX + 1];
    double t74[JLT_JET_ORDER_MAX + 1];
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
        t23[k] = jlt_jet_product(t2, x0, k);
        t24[k] = t2[k]*p[12];
        t25[k] = jlt_jet_product(t23, t24, k);
        t26[k] = jlt_jet_product(x3, x0, k);
        t28[k] = t11[k]*p[11] + t26[k];
        t30[k] = t25[k] - t17[k]*p[10];
        t31[k] = t30[k] - jlt_jet_product(x3, t28, k);
        t33[k] = t17[k]*p[13] + (k == 0 ? p[4] : 0);
        t34[k] = jlt_jet_product(t21, t33, k);
        t36[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t34, t36, k);
        t37[k] = p[4]*t21[k];
        t38[k] = jlt_jet_product(t31, t37, k);
        t39[k] = jlt_jet_product(t36, t38, k);
        t41[k] = jlt_jet_product(t33, t36, k);
        t42[k] = jlt_jet_product(t11, t41, k);
        t44[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t45[k] = p[14]*t44[k] + (k == 0 ? p[5] : 0);
        t46[k] = p[5]*t45[k];
        t47[k] = jlt_jet_product(t42, t46, k) + t26[k];
        t48[k] = jlt_jet_product(x2, t47, k);
        t50[k] = jlt_jet_product(x2, t44, k) + x1[k];
        t51[k] = jlt_jet_product(x3, t50, k);
        t52[k] = jlt_jet_product(t41, t51, k);
        t53[k] = t48[k] - jlt_jet_product(t19, t52, k);
        t55[k] = x9[k]*p[15];
        t56[k] = jlt_jet_product(t52, t55, k);
        t58[k] = t23[k]*p[16];
        t60[k] = t2[k]*p[17];
        t61[k] = jlt_jet_product(t42, t58, k) - t56[k];
        t62[k] = t61[k] - jlt_jet_product(t42, t60, k);
        t63[k] = -x3[k];
        t64[k] = t11[k] + t26[k];
        t66[k] = jlt_jet_cosine(x5, t66, u66, k);
        t67[k] = jlt_jet_product(x1, t66, k);
        t68[k] = jlt_jet_sine(x5, t68, u68, k);
        t69[k] = jlt_jet_product(t12, t68, k) + t67[k];
        t70[k] = jlt_jet_product(x9, t69, k);
        t71[k] = jlt_jet_product(x1, t68, k);
        t72[k] = t71[k] - jlt_jet_product(t12, t66, k);
        t73[k] = jlt_jet_product(x9, t72, k);
        t74[k] = -t23[k];
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t13[k]/(k + 1);
        next[2] = x2[k + 1] = t39[k]/(k + 1);
        next[3] = x3[k + 1] = t53[k]/(k + 1);
        next[4] = x4[k + 1] = t62[k]/(k + 1);
        next[5] = x5[k + 1] = t63[k]/(k + 1);
        next[6] = x6[k + 1] = t64[k]/(k + 1);
        next[7] = x7[k + 1] = t70[k]/(k + 1);
        next[8] = x8[k + 1] = t73[k]/(k + 1);
        next[9] = x9[k + 1] = t74[k]/(k + 1);
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
    .sha256 = "a3580c03c4e57c8611cf766b2671a74fbd573f922ecd03ff5771c0b58df91c97",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_track,
    .state_count = 10, .param_count = 6, .block_count = 49,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 10, { 3, 29, 17, 1, 0, 2, 10, 12 }, { 22, 91, 0, 10, 0, 2, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 100, { 14, 87, 38, 1, 0, 2, 14, 24 }, { 66, 414, 0, 49, 0, 2, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 110, { 17, 94, 45, 1, 0, 2, 14, 34 }, { 81, 486, 0, 59, 0, 2, 14, 12 },
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
