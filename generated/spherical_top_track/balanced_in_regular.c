/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   21    9    1    0    2      7    8   (96)
 *  jacobian            12   59   22    1    0    2      9   18   (375)
 *  rhs_jacobian        15   69   21    1    0    2      7   24   (449)
 *  divergence          1    5    3    1    0    0      5    4   (30)
 *  integral_values     1   14   10    0    0    2      6    8   (51)
 *  integral_gradients  0   30    8    0    0    2      7   10   (89)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_track[];
extern const jlt_descriptor jlt_kernels_spherical_top_track_balanced_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_balanced_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_balanced_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_balanced_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[5]/params[4]; /* I3/I1 */
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    const double t3 = params[5]/t2; /* I3/(m*R*R) */
    const double t4 = 1.0/params[1]; /* 1/R */
    const double t5 = params[4]*t2; /* I1*m*R*R */
    const double t6 = params[5]*params[5]; /* I3*I3 */
    const double t7 = params[5]*t2; /* I3*m*R*R */
    const double t8 = t6 + t7; /* I3*I3 + I3*m*R*R */
    const double t9 = t8/t5; /* (I3*I3 + I3*m*R*R)/(I1*m*R*R) */
    const double t10 = params[4] - params[5]; /* I1 - I3 */
    const double t11 = t10/params[4]; /* (I1 - I3)/I1 */
    const double t12 = params[1]*2.0; /* R*2 */
    const double t13 = -t0; /* -I3/I1 */
    const double t14 = params[4]*params[4]; /* I1*I1 */
    const double t15 = t6*2.0; /* I3*I3*2 */
    const double t16 = t15/t14; /* I3*I3*2/(I1*I1) */
    const double t17 = params[0]*params[0]; /* m*m */
    const double t18 = t1*t1; /* R*R*R*R */
    const double t19 = t17*t18; /* m*m*R*R*R*R */
    const double t20 = t14*t19; /* I1*I1*m*m*R*R*R*R */
    const double t21 = params[5]*t6; /* I3*I3*I3 */
    const double t22 = t2*t21; /* m*R*R*I3*I3*I3 */
    const double t23 = t6*t19; /* I3*I3*m*m*R*R*R*R */
    const double t24 = t22 + t23; /* m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R */
    const double t25 = 2.0*t24; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R) */
    const double t26 = t25/t20; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R)/(I1*I1*m*m*R*R*R*R) */
    const double t27 = params[4]*params[1]; /* I1*R */
    const double t28 = params[5]/t27; /* I3/(I1*R) */
    const double t29 = -t28; /* -I3/(I1*R) */
    const double t30 = params[5]*2.0; /* I3*2 */
    const double t31 = t30/params[4]; /* I3*2/I1 */
    const double t32 = t5*t6; /* I1*m*R*R*I3*I3 */
    const double t33 = params[4]*t19; /* I1*m*m*R*R*R*R */
    const double t34 = params[5]*t33; /* I3*I1*m*m*R*R*R*R */
    const double t35 = t32 + t34; /* I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R */
    const double t36 = 2.0*t35; /* 2*(I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R) */
    const double t37 = t36/t20; /* 2*(I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R)/(I1*I1*m*m*R*R*R*R) */
    const double t38 = t10*t30; /* (I1 - I3)*I3*2 */
    const double t39 = t38/t14; /* (I1 - I3)*I3*2/(I1*I1) */
    const double t40 = (-1.0)/params[1]; /* (-1)/R */
    const double t41 = t10*2.0; /* (I1 - I3)*2 */
    const double t42 = t41/params[4]; /* (I1 - I3)*2/I1 */
    const double t43 = params[4]*params[5]; /* I1*I3 */
    const double t44 = params[0]*params[1]; /* m*R */
    const double t45 = params[5]*t44; /* I3*m*R */
    const double t46 = params[4]*t44; /* I1*m*R */
    const double t47 = t2*t10; /* m*R*R*(I1 - I3) */
    const double t48 = params[0]*2.0; /* m*2 */
    const double t49 = t1*t48; /* R*R*m*2 */
    const double t50 = params[5]*t49; /* I3*R*R*m*2 */
    const double t51 = -t44; /* -m*R */
    const double t52 = -t45; /* -I3*m*R */
    const double t53 = params[4]*t49; /* I1*R*R*m*2 */
    const double t54 = -t46; /* -I1*m*R */
    const double t55 = t10*t49; /* (I1 - I3)*R*R*m*2 */
    const double t56 = params[0]/2.0; /* m/2 */
    const double t57 = params[4]/2.0; /* I1/2 */
    const double t58 = params[5]/2.0; /* I3/2 */
    const double t59 = t2/2.0; /* m*R*R/2 */
    const double t60 = params[5]*params[1]; /* I3*R */
    const double t61 = -t60; /* -I3*R */
    const double t62 = params[4] + t2; /* I1 + m*R*R */
    const double t63 = params[5] + t2; /* I3 + m*R*R */
    const double t64 = -params[4]; /* -I1 */
    out[6] = t0;
    out[7] = t3;
    out[8] = t4;
    out[9] = t9;
    out[10] = t11;
    out[11] = t12;
    out[12] = t13;
    out[13] = t16;
    out[14] = t26;
    out[15] = t29;
    out[16] = t31;
    out[17] = t37;
    out[18] = t39;
    out[19] = t40;
    out[20] = t42;
    out[21] = t43;
    out[22] = t5;
    out[23] = t7;
    out[24] = t8;
    out[25] = t45;
    out[26] = t46;
    out[27] = t47;
    out[28] = t50;
    out[29] = t52;
    out[30] = t53;
    out[31] = t54;
    out[32] = t55;
    out[33] = t28;
    out[34] = t56;
    out[35] = t57;
    out[36] = t58;
    out[37] = t59;
    out[38] = t27;
    out[39] = t60;
    out[40] = t2;
    out[41] = t44;
    out[42] = t61;
    out[43] = t62;
    out[44] = t51;
    out[45] = t63;
    out[46] = t64;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[2]; /* s*omega_tau */
    const double t1 = x[9]*t0; /* s*s*omega_tau */
    const double t2 = x[9]*x[4]; /* s*omega3 */
    const double t3 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t4 = t2 + t3; /* s*omega3 + omega_n*gamma3 */
    const double t5 = p[1]*t4; /* R*(s*omega3 + omega_n*gamma3) */
    const double t6 = x[3]*t5; /* omega_n*R*(s*omega3 + omega_n*gamma3) */
    const double t7 = JLT_FMA(t2, p[6], t3); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t8 = x[3]*t7; /* omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t9 = -t8; /* -omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t10 = x[0]*p[6]; /* gamma3*I3/I1 */
    const double t11 = JLT_FMA(x[9], x[9], p[7]); /* s*s + I3/(m*R^2) */
    const double t12 = JLT_FMA(x[0], t10, t11); /* Theta scaled = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t13 = 1.0/t12; /* 1/Theta scaled */
    const double t14 = JLT_FMA(p[8], x[1], x[2]); /* V scaled = 1/R*v_nu + omega_tau */
    const double t15 = t13*t14; /* 1/Theta scaled*V scaled */
    const double t16 = JLT_FNMA(p[6], t15, x[2]); /* omega_tau - I3/I1*1/Theta scaled*V scaled */
    const double t17 = t3*t16; /* omega_n*gamma3*(omega_tau - I3/I1*1/Theta scaled*V scaled) */
    const double t18 = x[4]*p[9]; /* omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t19 = t0*t18; /* s*omega_tau*omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t20 = JLT_FMA(t13, t19, t17); /* 1/Theta scaled*s*omega_tau*omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) + omega_n*gamma3*(omega_tau - I3/I1*1/Theta scaled*V scaled) */
    const double t21 = x[9]*x[3]; /* s*omega_n */
    const double t22 = t15*t21; /* 1/Theta scaled*V scaled*s*omega_n */
    const double t23 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t24 = t2*p[10]; /* s*omega3*(I1 - I3)/I1 */
    const double t25 = t23*t24; /* s*omega_tau*gamma3*s*omega3*(I1 - I3)/I1 */
    const double t26 = JLT_FMS(t13, t25, t22); /* 1/Theta scaled*s*omega_tau*gamma3*s*omega3*(I1 - I3)/I1 - 1/Theta scaled*V scaled*s*omega_n */
    const double t27 = -x[3]; /* -omega_n */
    const double t28 = cos(x[5]); /* C = cos(chi) */
    const double t29 = x[9]*x[1]; /* s*v_nu */
    const double t30 = t28*t29; /* C*s*v_nu */
    const double t31 = sin(x[5]); /* S = sin(chi) */
    const double t32 = x[9]*t5; /* s*R*(s*omega3 + omega_n*gamma3) */
    const double t33 = JLT_FMA(t31, t32, t30); /* S*s*R*(s*omega3 + omega_n*gamma3) + C*s*v_nu */
    const double t34 = t29*t31; /* s*v_nu*S */
    const double t35 = JLT_FNMA(t28, t32, t34); /* s*v_nu*S - C*s*R*(s*omega3 + omega_n*gamma3) */
    const double t36 = -t23; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t6;
    out[2] = t9;
    out[3] = t20;
    out[4] = t26;
    out[5] = t27;
    out[6] = t4;
    out[7] = t33;
    out[8] = t35;
    out[9] = t36;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[9]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = x[9]*p[1]; /* s*R */
    const double t6 = x[4]*t5; /* omega3*s*R */
    const double t7 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t8 = JLT_FMA(p[11], t7, t6); /* 2*R*omega_n*gamma3 + omega3*s*R */
    const double t9 = x[3]*t5; /* omega_n*s*R */
    const double t10 = x[3]*x[4]; /* omega_n*omega3 */
    const double t11 = p[1]*t10; /* R*omega_n*omega3 */
    const double t12 = -t3; /* -omega_n*omega_n */
    const double t13 = 2.0*t7; /* 2*omega_n*gamma3 */
    const double t14 = x[9]*p[6]; /* s*I3/I1 */
    const double t15 = JLT_FMA(x[4], t14, t13); /* omega3*s*I3/I1 + 2*omega_n*gamma3 */
    const double t16 = -t15; /* -(omega3*s*I3/I1 + 2*omega_n*gamma3) */
    const double t17 = x[3]*t14; /* omega_n*s*I3/I1 */
    const double t18 = -t17; /* -omega_n*s*I3/I1 */
    const double t19 = t10*p[12]; /* omega_n*omega3*(-I3/I1) */
    const double t20 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t21 = t0 + p[7]; /* s*s + I3/(m*R^2) */
    const double t22 = JLT_FMA(p[6], t20, t21); /* Theta scaled = I3/I1*gamma3*gamma3 + s*s + I3/(m*R^2) */
    const double t23 = 1.0/t22; /* 1/Theta scaled */
    const double t24 = JLT_FMA(p[8], x[1], x[2]); /* V scaled = 1/R*v_nu + omega_tau */
    const double t25 = t23*t24; /* 1/Theta scaled*V scaled */
    const double t26 = JLT_FNMA(p[6], t25, x[2]); /* omega_tau - I3/I1*1/Theta scaled*V scaled */
    const double t27 = x[3]*t26; /* omega_n*(omega_tau - I3/I1*1/Theta scaled*V scaled) */
    const double t28 = t7*t25; /* omega_n*gamma3*1/Theta scaled*V scaled */
    const double t29 = p[13]*t28; /* 2*I3^2/I1^2*omega_n*gamma3*1/Theta scaled*V scaled */
    const double t30 = x[9]*t23; /* s*1/Theta scaled */
    const double t31 = x[4]*t30; /* omega3*s*1/Theta scaled */
    const double t32 = x[2]*t31; /* omega_tau*omega3*s*1/Theta scaled */
    const double t33 = JLT_FNMA(p[14], t32, t29); /* 2*I3^2/I1^2*omega_n*gamma3*1/Theta scaled*V scaled - 2*(m*R^2*I3^3 + m^2*R^4*I3^2)/(m^2*R^4*I1^2)*omega_tau*omega3*s*1/Theta scaled */
    const double t34 = x[0]*t23; /* gamma3*1/Theta scaled */
    const double t35 = JLT_FMA(t33, t34, t27); /* t33*gamma3*1/Theta scaled + omega_n*(omega_tau - I3/I1*1/Theta scaled*V scaled) */
    const double t36 = t7*t23; /* omega_n*gamma3*1/Theta scaled */
    const double t37 = p[15]*t36; /* (-I3/(R*I1))*omega_n*gamma3*1/Theta scaled */
    const double t38 = JLT_FNMA(p[6], t36, t7); /* omega_n*gamma3 - I3/I1*omega_n*gamma3*1/Theta scaled */
    const double t39 = JLT_FMA(t31, p[9], t38); /* omega3*s*1/Theta scaled*(I3^2 + m*R^2*I3)/(m*R^2*I1) + omega_n*gamma3 - I3/I1*omega_n*gamma3*1/Theta scaled */
    const double t40 = x[0]*t26; /* gamma3*(omega_tau - I3/I1*1/Theta scaled*V scaled) */
    const double t41 = x[2]*t30; /* omega_tau*s*1/Theta scaled */
    const double t42 = p[9]*t41; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*s*1/Theta scaled */
    const double t43 = x[2]*p[9]; /* omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t44 = x[4]*t43; /* omega3*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t45 = t23*t44; /* 1/Theta scaled*omega3*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t46 = t28*p[16]; /* omega_n*gamma3*1/Theta scaled*V scaled*2*I3/I1 */
    const double t47 = JLT_FNMA(t32, p[17], t46); /* omega_n*gamma3*1/Theta scaled*V scaled*2*I3/I1 - omega_tau*omega3*s*1/Theta scaled*2*(m*R^2*I1*I3^2 + m^2*R^4*I1*I3)/(m^2*R^4*I1^2) */
    const double t48 = JLT_FMA(t30, t47, t45); /* s*1/Theta scaled*t47 + 1/Theta scaled*omega3*omega_tau*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t49 = x[9]*p[10]; /* s*(I1 - I3)/I1 */
    const double t50 = t32*t49; /* omega_tau*omega3*s*1/Theta scaled*s*(I1 - I3)/I1 */
    const double t51 = t20*p[18]; /* gamma3*gamma3*2*I3*(I1 - I3)/I1^2 */
    const double t52 = JLT_FNMA(t32, t51, t46); /* omega_n*gamma3*1/Theta scaled*V scaled*2*I3/I1 - omega_tau*omega3*s*1/Theta scaled*gamma3*gamma3*2*I3*(I1 - I3)/I1^2 */
    const double t53 = JLT_FMA(t30, t52, t50); /* s*1/Theta scaled*t52 + omega_tau*omega3*s*1/Theta scaled*s*(I1 - I3)/I1 */
    const double t54 = x[3]*t30; /* omega_n*s*1/Theta scaled */
    const double t55 = p[19]*t54; /* (-1/R)*omega_n*s*1/Theta scaled */
    const double t56 = x[9]*x[0]; /* s*gamma3 */
    const double t57 = p[10]*t56; /* (I1 - I3)/I1*s*gamma3 */
    const double t58 = JLT_FMS(t31, t57, t54); /* omega3*s*1/Theta scaled*(I1 - I3)/I1*s*gamma3 - omega_n*s*1/Theta scaled */
    const double t59 = t24*t30; /* V scaled*s*1/Theta scaled */
    const double t60 = -t59; /* -V scaled*s*1/Theta scaled */
    const double t61 = t41*t57; /* omega_tau*s*1/Theta scaled*(I1 - I3)/I1*s*gamma3 */
    const double t62 = x[3]*t25; /* omega_n*1/Theta scaled*V scaled */
    const double t63 = 2.0*t59; /* 2*V scaled*s*1/Theta scaled */
    const double t64 = JLT_FNMA(t30, t56, x[0]); /* gamma3 - s*1/Theta scaled*s*gamma3 */
    const double t65 = p[20]*t64; /* 2*(I1 - I3)/I1*(gamma3 - s*1/Theta scaled*s*gamma3) */
    const double t66 = JLT_FMS(t54, t63, t62); /* omega_n*s*1/Theta scaled*2*V scaled*s*1/Theta scaled - omega_n*1/Theta scaled*V scaled */
    const double t67 = JLT_FMA(t32, t65, t66); /* omega_tau*omega3*s*1/Theta scaled*2*(I1 - I3)/I1*(gamma3 - s*1/Theta scaled*s*gamma3) + t66 */
    const double t68 = sin(x[5]); /* S = sin(chi) */
    const double t69 = t9*t68; /* omega_n*s*R*S */
    const double t70 = cos(x[5]); /* C = cos(chi) */
    const double t71 = x[9]*t70; /* s*C */
    const double t72 = t5*x[0]; /* s*R*gamma3 */
    const double t73 = t68*t72; /* S*s*R*gamma3 */
    const double t74 = x[9]*t68; /* s*S */
    const double t75 = t5*t74; /* s*R*s*S */
    const double t76 = x[1]*t68; /* v_nu*S */
    const double t77 = JLT_FMA(p[1], t7, t6); /* v_tau = R*omega_n*gamma3 + omega3*s*R */
    const double t78 = JLT_FNMA(t70, t77, t76); /* v_nu*S - C*v_tau */
    const double t79 = x[9]*t78; /* s*(v_nu*S - C*v_tau) */
    const double t80 = -t79; /* -s*(v_nu*S - C*v_tau) */
    const double t81 = x[1]*t70; /* v_nu*C */
    const double t82 = JLT_FMA(t68, t77, t81); /* S*v_tau + v_nu*C */
    const double t83 = JLT_FMA(t6, t68, t82); /* omega3*s*R*S + S*v_tau + v_nu*C */
    const double t84 = t9*t70; /* omega_n*s*R*C */
    const double t85 = -t84; /* -omega_n*s*R*C */
    const double t86 = t70*t72; /* C*s*R*gamma3 */
    const double t87 = -t86; /* -C*s*R*gamma3 */
    const double t88 = t5*t71; /* s*R*s*C */
    const double t89 = -t88; /* -s*R*s*C */
    const double t90 = x[9]*t82; /* s*(S*v_tau + v_nu*C) */
    const double t91 = JLT_FNMA(t6, t70, t78); /* v_nu*S - C*v_tau - omega3*s*R*C */
    const double t92 = -t1; /* -s*omega_tau */
    const double t93 = -t56; /* -s*gamma3 */
    const double t94 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t95 = -t94; /* -omega_tau*gamma3 */
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
    out[13] = t8;
    out[14] = t9;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t11;
    out[20] = t12;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = t16;
    out[24] = t18;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t19;
    out[30] = t35;
    out[31] = t37;
    out[32] = t39;
    out[33] = t40;
    out[34] = t42;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t48;
    out[40] = t53;
    out[41] = t55;
    out[42] = t58;
    out[43] = t60;
    out[44] = t61;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t67;
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
    out[70] = t69;
    out[71] = t71;
    out[72] = 0.0;
    out[73] = t73;
    out[74] = t75;
    out[75] = t80;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = t83;
    out[80] = t85;
    out[81] = t74;
    out[82] = 0.0;
    out[83] = t87;
    out[84] = t89;
    out[85] = t90;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t91;
    out[90] = t92;
    out[91] = 0.0;
    out[92] = t93;
    out[93] = 0.0;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t95;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*x[3]; /* R*omega_n */
    const double t3 = x[9]*x[4]; /* s*omega3 */
    const double t4 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t5 = t3 + t4; /* s*omega3 + omega_n*gamma3 */
    const double t6 = t2*t5; /* R*omega_n*(s*omega3 + omega_n*gamma3) */
    const double t7 = t3*p[6]; /* s*omega3*I3/I1 */
    const double t8 = t4 + t7; /* omega_n*gamma3 + s*omega3*I3/I1 */
    const double t9 = x[3]*t8; /* omega_n*(omega_n*gamma3 + s*omega3*I3/I1) */
    const double t10 = -t9; /* -omega_n*(omega_n*gamma3 + s*omega3*I3/I1) */
    const double t11 = x[0]*p[23]; /* gamma3*m*R^2*I3 */
    const double t12 = JLT_FMA(t0, p[22], p[21]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t13 = JLT_FMA(x[0], t11, t12); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t14 = 1.0/t13; /* 1/Theta */
    const double t15 = x[2]*p[24]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t16 = t3*t15; /* s*omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t17 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t18 = p[25]*t17; /* m*R*I3*V */
    const double t19 = JLT_FNMA(t4, t18, t16); /* numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*m*R*I3*V */
    const double t20 = t14*t19; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t21 = JLT_FMA(x[2], t4, t20); /* omega_tau*omega_n*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t22 = x[9]*x[3]; /* s*omega_n */
    const double t23 = t17*p[26]; /* V*m*R*I1 */
    const double t24 = t22*t23; /* s*omega_n*V*m*R*I1 */
    const double t25 = x[9]*x[0]; /* s*gamma3 */
    const double t26 = x[2]*t25; /* omega_tau*s*gamma3 */
    const double t27 = t3*p[27]; /* s*omega3*m*R^2*(I1 - I3) */
    const double t28 = JLT_FMS(t26, t27, t24); /* numerator of d(omega3)/dt over Theta = omega_tau*s*gamma3*s*omega3*m*R^2*(I1 - I3) - s*omega_n*V*m*R*I1 */
    const double t29 = t14*t28; /* 1/Theta*numerator of d(omega3)/dt over Theta */
    const double t30 = -x[3]; /* -omega_n */
    const double t31 = cos(x[5]); /* C = cos(chi) */
    const double t32 = x[1]*t31; /* v_nu*C */
    const double t33 = sin(x[5]); /* S = sin(chi) */
    const double t34 = p[1]*t33; /* R*S */
    const double t35 = JLT_FMA(t5, t34, t32); /* (s*omega3 + omega_n*gamma3)*R*S + v_nu*C */
    const double t36 = x[9]*t35; /* s*((s*omega3 + omega_n*gamma3)*R*S + v_nu*C) */
    const double t37 = x[1]*t33; /* v_nu*S */
    const double t38 = p[1]*t31; /* R*C */
    const double t39 = JLT_FNMA(t5, t38, t37); /* v_nu*S - (s*omega3 + omega_n*gamma3)*R*C */
    const double t40 = x[9]*t39; /* s*(v_nu*S - (s*omega3 + omega_n*gamma3)*R*C) */
    const double t41 = -t26; /* -omega_tau*s*gamma3 */
    const double t42 = x[2]*x[9]; /* omega_tau*s */
    const double t43 = 2.0*t42; /* 2*omega_tau*s */
    const double t44 = x[3]*t2; /* omega_n*R*omega_n */
    const double t45 = p[1]*t3; /* R*s*omega3 */
    const double t46 = JLT_FMA(t4, p[11], t45); /* omega_n*gamma3*2*R + R*s*omega3 */
    const double t47 = p[1]*t22; /* R*s*omega_n */
    const double t48 = t2*x[4]; /* R*omega_n*omega3 */
    const double t49 = x[3]*x[3]; /* omega_n*omega_n */
    const double t50 = -t49; /* -omega_n*omega_n */
    const double t51 = JLT_FMA(t4, 2.0, t7); /* omega_n*gamma3*2 + s*omega3*I3/I1 */
    const double t52 = -t51; /* -(omega_n*gamma3*2 + s*omega3*I3/I1) */
    const double t53 = t22*p[12]; /* s*omega_n*(-I3/I1) */
    const double t54 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    const double t55 = x[4]*t54; /* omega3*omega_n*(-I3/I1) */
    const double t56 = JLT_FNMA(t14, t18, x[2]); /* omega_tau - 1/Theta*m*R*I3*V */
    const double t57 = x[3]*t56; /* omega_n*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t58 = x[0]*p[28]; /* gamma3*2*m*R^2*I3 */
    const double t59 = t14*t58; /* 1/Theta*gamma3*2*m*R^2*I3 */
    const double t60 = JLT_FNMA(t20, t59, t57); /* omega_n*(omega_tau - 1/Theta*m*R*I3*V) - 1/Theta*numerator of d(omega_n)/dt over Theta*1/Theta*gamma3*2*m*R^2*I3 */
    const double t61 = t4*p[29]; /* omega_n*gamma3*(-m*R*I3) */
    const double t62 = t14*t61; /* 1/Theta*omega_n*gamma3*(-m*R*I3) */
    const double t63 = t3*p[24]; /* s*omega3*(I3^2 + m*R^2*I3) */
    const double t64 = JLT_FNMA(t4, p[23], t63); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(I3^2 + m*R^2*I3) - omega_n*gamma3*m*R^2*I3 */
    const double t65 = JLT_FMA(t14, t64, t4); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    const double t66 = x[0]*t56; /* gamma3*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t67 = t14*t42; /* 1/Theta*omega_tau*s */
    const double t68 = p[24]*t67; /* (I3^2 + m*R^2*I3)*1/Theta*omega_tau*s */
    const double t69 = x[4]*t15; /* omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t70 = t14*t69; /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t71 = x[9]*t14; /* s*1/Theta */
    const double t72 = p[30]*t71; /* 2*m*R^2*I1*s*1/Theta */
    const double t73 = JLT_FNMA(t20, t72, t70); /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    const double t74 = t27*t67; /* s*omega3*m*R^2*(I1 - I3)*1/Theta*omega_tau*s */
    const double t75 = JLT_FNMA(t29, t59, t74); /* s*omega3*m*R^2*(I1 - I3)*1/Theta*omega_tau*s - 1/Theta*numerator of d(omega3)/dt over Theta*1/Theta*gamma3*2*m*R^2*I3 */
    const double t76 = t22*p[31]; /* s*omega_n*(-m*R*I1) */
    const double t77 = t14*t76; /* 1/Theta*s*omega_n*(-m*R*I1) */
    const double t78 = t25*t27; /* s*gamma3*s*omega3*m*R^2*(I1 - I3) */
    const double t79 = JLT_FNMA(p[22], t22, t78); /* d(numerator of d(omega3)/dt over Theta)/d(omega_tau) = s*gamma3*s*omega3*m*R^2*(I1 - I3) - m*R^2*I1*s*omega_n */
    const double t80 = t14*t79; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(omega_tau) */
    const double t81 = t23*t71; /* V*m*R*I1*s*1/Theta */
    const double t82 = -t81; /* -V*m*R*I1*s*1/Theta */
    const double t83 = t25*p[27]; /* s*gamma3*m*R^2*(I1 - I3) */
    const double t84 = t67*t83; /* 1/Theta*omega_tau*s*s*gamma3*m*R^2*(I1 - I3) */
    const double t85 = x[3]*t23; /* omega_n*V*m*R*I1 */
    const double t86 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t87 = t3*p[32]; /* s*omega3*2*m*R^2*(I1 - I3) */
    const double t88 = JLT_FMS(t86, t87, t85); /* d(numerator of d(omega3)/dt over Theta)/d(s) = omega_tau*gamma3*s*omega3*2*m*R^2*(I1 - I3) - omega_n*V*m*R*I1 */
    const double t89 = t14*t88; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t90 = JLT_FNMA(t29, t72, t89); /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) - 1/Theta*numerator of d(omega3)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    const double t91 = t22*t34; /* s*omega_n*R*S */
    const double t92 = x[9]*t31; /* s*C */
    const double t93 = t25*t34; /* s*gamma3*R*S */
    const double t94 = t0*t34; /* s*s*R*S */
    const double t95 = -t40; /* -s*(v_nu*S - (s*omega3 + omega_n*gamma3)*R*C) */
    const double t96 = JLT_FMA(t3, t34, t35); /* s*omega3*R*S + (s*omega3 + omega_n*gamma3)*R*S + v_nu*C */
    const double t97 = t22*t38; /* s*omega_n*R*C */
    const double t98 = -t97; /* -s*omega_n*R*C */
    const double t99 = x[9]*t33; /* s*S */
    const double t100 = t25*t38; /* s*gamma3*R*C */
    const double t101 = -t100; /* -s*gamma3*R*C */
    const double t102 = t0*t38; /* s*s*R*C */
    const double t103 = -t102; /* -s*s*R*C */
    const double t104 = JLT_FNMA(t3, t38, t39); /* v_nu*S - (s*omega3 + omega_n*gamma3)*R*C - s*omega3*R*C */
    const double t105 = -t42; /* -omega_tau*s */
    const double t106 = -t25; /* -s*gamma3 */
    const double t107 = -t86; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t6;
    out[2] = t10;
    out[3] = t21;
    out[4] = t29;
    out[5] = t30;
    out[6] = t5;
    out[7] = t36;
    out[8] = t40;
    out[9] = t41;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t43;
    out[20] = t44;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = t46;
    out[24] = t47;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t48;
    out[30] = t50;
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = t52;
    out[34] = t53;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t55;
    out[40] = t60;
    out[41] = t62;
    out[42] = t65;
    out[43] = t66;
    out[44] = t68;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t73;
    out[50] = t75;
    out[51] = t77;
    out[52] = t80;
    out[53] = t82;
    out[54] = t84;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = t90;
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
    out[80] = t91;
    out[81] = t92;
    out[82] = 0.0;
    out[83] = t93;
    out[84] = t94;
    out[85] = t95;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t96;
    out[90] = t98;
    out[91] = t99;
    out[92] = 0.0;
    out[93] = t101;
    out[94] = t103;
    out[95] = t36;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t104;
    out[100] = t105;
    out[101] = 0.0;
    out[102] = t106;
    out[103] = 0.0;
    out[104] = 0.0;
    out[105] = 0.0;
    out[106] = 0.0;
    out[107] = 0.0;
    out[108] = 0.0;
    out[109] = t107;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[0]*p[6]; /* gamma3*I3/I1 */
    const double t2 = p[7] + t0; /* I3/(m*R^2) + s*s */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta scaled = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s*s */
    const double t4 = p[10]*x[2]; /* (I1 - I3)/I1*omega_tau */
    const double t5 = t0*t4; /* s*s*(I1 - I3)/I1*omega_tau */
    const double t6 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t7 = JLT_FNMA(p[33], t6, t5); /* s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V */
    const double t8 = x[0]*t7; /* gamma3*(s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V) */
    const double t9 = t8/t3; /* gamma3*(s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V)/Theta scaled */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[34]*x[1]; /* 1/2*m*v_nu */
    const double t1 = x[1]*t0; /* v_nu*1/2*m*v_nu */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = JLT_FMA(x[2], x[2], t2); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t4 = p[36]*x[4]; /* 1/2*I3*omega3 */
    const double t5 = x[4]*x[9]; /* omega3*s */
    const double t6 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t7 = t5 + t6; /* v_tau scaled = omega3*s + omega_n*gamma3 */
    const double t8 = p[37]*t7; /* 1/2*m*R^2*v_tau scaled */
    const double t9 = JLT_FMA(x[4], t4, t1); /* omega3*1/2*I3*omega3 + v_nu*1/2*m*v_nu */
    const double t10 = JLT_FMA(p[35], t3, t9); /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) + omega3*1/2*I3*omega3 + v_nu*1/2*m*v_nu */
    const double t11 = JLT_FMA(t7, t8, t10); /* v_tau scaled*1/2*m*R^2*v_tau scaled + t10 */
    const double t12 = x[3]*p[38]; /* omega_n*R*I1 */
    const double t13 = x[9]*t12; /* s*omega_n*R*I1 */
    const double t14 = x[4]*p[39]; /* omega3*R*I3 */
    const double t15 = JLT_FNMA(x[0], t14, t13); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    const double t16 = cos(x[5]); /* C = cos(chi) */
    const double t17 = t6*p[4]; /* omega_n*gamma3*I1 */
    const double t18 = JLT_FMA(t5, p[5], t17); /* omega3*s*I3 + omega_n*gamma3*I1 */
    const double t19 = JLT_FMA(t7, p[40], t18); /* M_nu = v_tau scaled*m*R^2 + omega3*s*I3 + omega_n*gamma3*I1 */
    const double t20 = t16*t19; /* C*M_nu */
    const double t21 = sin(x[5]); /* S = sin(chi) */
    const double t22 = x[2]*p[4]; /* omega_tau*I1 */
    const double t23 = JLT_FNMA(x[1], p[41], t22); /* M_tau = omega_tau*I1 - v_nu*m*R */
    const double t24 = JLT_FMA(t21, t23, t20); /* S*M_tau + C*M_nu */
    const double t25 = t19*t21; /* M_nu*S */
    const double t26 = JLT_FNMA(t16, t23, t25); /* M_nu*S - C*M_tau */
    out[0] = t11;
    out[1] = t15;
    out[2] = t24;
    out[3] = t26;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[9]; /* omega3*s */
    const double t1 = JLT_FMA(x[3], x[0], t0); /* v_tau scaled = omega_n*gamma3 + omega3*s */
    const double t2 = p[40]*t1; /* m*R^2*v_tau scaled */
    const double t3 = x[3]*t2; /* omega_n*m*R^2*v_tau scaled */
    const double t4 = p[0]*x[1]; /* m*v_nu */
    const double t5 = p[4]*x[2]; /* I1*omega_tau */
    const double t6 = x[3]*p[4]; /* omega_n*I1 */
    const double t7 = JLT_FMA(x[0], t2, t6); /* gamma3*m*R^2*v_tau scaled + omega_n*I1 */
    const double t8 = x[4]*p[5]; /* omega3*I3 */
    const double t9 = JLT_FMA(x[9], t2, t8); /* s*m*R^2*v_tau scaled + omega3*I3 */
    const double t10 = x[4]*t2; /* omega3*m*R^2*v_tau scaled */
    const double t11 = x[4]*p[42]; /* omega3*(-R*I3) */
    const double t12 = x[9]*p[38]; /* s*R*I1 */
    const double t13 = x[0]*p[42]; /* gamma3*(-R*I3) */
    const double t14 = x[3]*p[38]; /* omega_n*R*I1 */
    const double t15 = cos(x[5]); /* C = cos(chi) */
    const double t16 = x[3]*p[43]; /* d(M_nu)/d(gamma3) = omega_n*(I1 + m*R^2) */
    const double t17 = t15*t16; /* C*d(M_nu)/d(gamma3) */
    const double t18 = sin(x[5]); /* S = sin(chi) */
    const double t19 = p[44]*t18; /* (-m*R)*S */
    const double t20 = p[4]*t18; /* I1*S */
    const double t21 = x[0]*p[43]; /* d(M_nu)/d(omega_n) = gamma3*(I1 + m*R^2) */
    const double t22 = t15*t21; /* C*d(M_nu)/d(omega_n) */
    const double t23 = x[9]*p[45]; /* d(M_nu)/d(omega3) = s*(I3 + m*R^2) */
    const double t24 = t15*t23; /* C*d(M_nu)/d(omega3) */
    const double t25 = JLT_FMA(x[0], t6, t2); /* gamma3*omega_n*I1 + m*R^2*v_tau scaled */
    const double t26 = JLT_FMA(t0, p[5], t25); /* M_nu = omega3*s*I3 + gamma3*omega_n*I1 + m*R^2*v_tau scaled */
    const double t27 = t18*t26; /* S*M_nu */
    const double t28 = JLT_FNMA(x[1], p[41], t5); /* M_tau = I1*omega_tau - v_nu*m*R */
    const double t29 = JLT_FMS(t15, t28, t27); /* C*M_tau - S*M_nu */
    const double t30 = x[4]*p[45]; /* d(M_nu)/d(s) = omega3*(I3 + m*R^2) */
    const double t31 = t15*t30; /* C*d(M_nu)/d(s) */
    const double t32 = t16*t18; /* d(M_nu)/d(gamma3)*S */
    const double t33 = t15*p[41]; /* C*m*R */
    const double t34 = t15*p[46]; /* C*(-I1) */
    const double t35 = t18*t21; /* S*d(M_nu)/d(omega_n) */
    const double t36 = t18*t23; /* S*d(M_nu)/d(omega3) */
    const double t37 = t15*t26; /* C*M_nu */
    const double t38 = JLT_FMA(t18, t28, t37); /* S*M_tau + C*M_nu */
    const double t39 = t18*t30; /* S*d(M_nu)/d(s) */
    out[0] = t3;
    out[1] = t4;
    out[2] = t5;
    out[3] = t7;
    out[4] = t9;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t10;
    out[10] = t11;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t12;
    out[14] = t13;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t14;
    out[20] = t17;
    out[21] = t19;
    out[22] = t20;
    out[23] = t22;
    out[24] = t24;
    out[25] = t29;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t31;
    out[30] = t32;
    out[31] = t33;
    out[32] = t34;
    out[33] = t35;
    out[34] = t36;
    out[35] = t38;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t39;
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
    double t7[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double u41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double u43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
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
        t7[k] = jlt_jet_product(x9, x4, k);
        t9[k] = jlt_jet_product(x3, x0, k);
        t10[k] = t7[k] + t9[k];
        t11[k] = p[1]*t10[k];
        t12[k] = jlt_jet_product(x3, t11, k);
        t14[k] = t7[k]*p[6] + t9[k];
        t15[k] = jlt_jet_product(x3, t14, k);
        t16[k] = -t15[k];
        t19[k] = x0[k]*p[6];
        t20[k] = jlt_jet_product(x9, x9, k) + (k == 0 ? p[7] : 0);
        t21[k] = jlt_jet_product(x0, t19, k) + t20[k];
        t23[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t21, t23, k);
        t24[k] = jlt_jet_product(t7, t23, k);
        t25[k] = p[9]*t24[k] + t9[k];
        t26[k] = jlt_jet_product(x2, t25, k);
        t29[k] = p[8]*x1[k] + x2[k];
        t30[k] = jlt_jet_product(t23, t29, k);
        t31[k] = t9[k]*p[6];
        t32[k] = t26[k] - jlt_jet_product(t30, t31, k);
        t33[k] = jlt_jet_product(x9, x3, k);
        t34[k] = jlt_jet_product(t30, t33, k);
        t36[k] = jlt_jet_product(t2, x0, k);
        t37[k] = p[10]*t36[k];
        t38[k] = jlt_jet_product(t24, t37, k) - t34[k];
        t39[k] = -x3[k];
        t41[k] = jlt_jet_cosine(x5, t41, u41, k);
        t42[k] = jlt_jet_product(x1, t41, k);
        t43[k] = jlt_jet_sine(x5, t43, u43, k);
        t44[k] = jlt_jet_product(t11, t43, k) + t42[k];
        t45[k] = jlt_jet_product(x9, t44, k);
        t46[k] = jlt_jet_product(x1, t43, k);
        t47[k] = t46[k] - jlt_jet_product(t11, t41, k);
        t48[k] = jlt_jet_product(x9, t47, k);
        t49[k] = -t36[k];
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t12[k]/(k + 1);
        next[2] = x2[k + 1] = t16[k]/(k + 1);
        next[3] = x3[k + 1] = t32[k]/(k + 1);
        next[4] = x4[k + 1] = t38[k]/(k + 1);
        next[5] = x5[k + 1] = t39[k]/(k + 1);
        next[6] = x6[k + 1] = t10[k]/(k + 1);
        next[7] = x7[k + 1] = t45[k]/(k + 1);
        next[8] = x8[k + 1] = t48[k]/(k + 1);
        next[9] = x9[k + 1] = t49[k]/(k + 1);
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
    const double v_a3 = (0.0);
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
    { "M_x", "a3 = 0" },
    { "M_y", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_track_balanced_in_regular = {
    .model = "spherical_top_track",
    .variant = "balanced",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_track,
    .state_count = 10, .param_count = 6, .block_count = 47,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 10, { 4, 21, 9, 1, 0, 2, 7, 8 }, { 17, 71, 0, 6, 0, 2, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .jacobian = { jacobian, 100, { 12, 59, 22, 1, 0, 2, 9, 18 }, { 50, 292, 0, 31, 0, 2, 13, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .rhs_jacobian = { rhs_jacobian, 110, { 15, 69, 21, 1, 0, 2, 7, 24 }, { 63, 347, 0, 37, 0, 2, 13, 10 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .divergence = { divergence, 1, { 1, 5, 3, 1, 0, 0, 5, 4 }, { 5, 23, 0, 2, 0, 0, 8, 5 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .integral_values = { integral_values, 4, { 1, 14, 10, 0, 0, 2, 6, 8 }, { 11, 38, 0, 0, 0, 2, 8, 7 },
        "" },
    .integral_gradients = { integral_gradients, 40, { 0, 30, 8, 0, 0, 2, 7, 10 }, { 16, 71, 0, 0, 0, 2, 7, 10 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_track_balanced_in_regular_baseline,
        &jlt_batch_spherical_top_track_balanced_in_regular_avx2,
        &jlt_batch_spherical_top_track_balanced_in_regular_avx512,
    },
};
