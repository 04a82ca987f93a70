/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   23    9    1    0    2      7    8   (96)
 *  jacobian            10   63   23    1    0    2     10   18   (375)
 *  rhs_jacobian        14   72   24    1    0    2      9   27   (449)
 *  divergence          0    7    4    1    0    0      5    4   (30)
 *  integral_values     1   14   10    0    0    2      6    7   (51)
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
    const double t1 = params[0]*params[1]; /* m*R */
    const double t2 = params[5]*t1; /* I3*m*R */
    const double t3 = params[4]*params[5]; /* I1*I3 */
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[0]*t4; /* m*R*R */
    const double t6 = params[4]*t5; /* I1*m*R*R */
    const double t7 = params[5]*t5; /* I3*m*R*R */
    const double t8 = params[5]*params[5]; /* I3*I3 */
    const double t9 = t7 + t8; /* I3*m*R*R + I3*I3 */
    const double t10 = -t1; /* -m*R */
    const double t11 = params[4]*t1; /* I1*m*R */
    const double t12 = -t11; /* -I1*m*R */
    const double t13 = params[4] - params[5]; /* I1 - I3 */
    const double t14 = params[1]*t13; /* R*(I1 - I3) */
    const double t15 = t14/params[4]; /* R*(I1 - I3)/I1 */
    const double t16 = params[1]*2.0; /* R*2 */
    const double t17 = -t0; /* -I3/I1 */
    const double t18 = params[0]*params[0]; /* m*m */
    const double t19 = 2.0*t18; /* 2*m*m */
    const double t20 = params[1]*t4; /* R*R*R */
    const double t21 = t19*t20; /* 2*m*m*R*R*R */
    const double t22 = t8*t21; /* I3*I3*2*m*m*R*R*R */
    const double t23 = params[5]*t8; /* I3*I3*I3 */
    const double t24 = t5*t23; /* m*R*R*I3*I3*I3 */
    const double t25 = 2.0*t24; /* 2*m*R*R*I3*I3*I3 */
    const double t26 = t4*t4; /* R*R*R*R */
    const double t27 = t18*t26; /* m*m*R*R*R*R */
    const double t28 = t8*t27; /* I3*I3*m*m*R*R*R*R */
    const double t29 = 2.0*t28; /* 2*I3*I3*m*m*R*R*R*R */
    const double t30 = t25 + t29; /* 2*m*R*R*I3*I3*I3 + 2*I3*I3*m*m*R*R*R*R */
    const double t31 = -t2; /* -I3*m*R */
    const double t32 = t6*t8; /* I1*m*R*R*I3*I3 */
    const double t33 = 2.0*t32; /* 2*I1*m*R*R*I3*I3 */
    const double t34 = params[4]*t27; /* I1*m*m*R*R*R*R */
    const double t35 = params[5]*t34; /* I3*I1*m*m*R*R*R*R */
    const double t36 = 2.0*t35; /* 2*I3*I1*m*m*R*R*R*R */
    const double t37 = t33 + t36; /* 2*I1*m*R*R*I3*I3 + 2*I3*I1*m*m*R*R*R*R */
    const double t38 = params[4]*t21; /* I1*2*m*m*R*R*R */
    const double t39 = params[5]*t38; /* I3*I1*2*m*m*R*R*R */
    const double t40 = t5*t13; /* m*R*R*(I1 - I3) */
    const double t41 = t19*t26; /* 2*m*m*R*R*R*R */
    const double t42 = params[5]*t41; /* I3*2*m*m*R*R*R*R */
    const double t43 = t13*t42; /* (I1 - I3)*I3*2*m*m*R*R*R*R */
    const double t44 = params[0]*2.0; /* m*2 */
    const double t45 = t4*t44; /* R*R*m*2 */
    const double t46 = t13*t45; /* (I1 - I3)*R*R*m*2 */
    const double t47 = params[4]*params[4]; /* I1*I1 */
    const double t48 = t21*t47; /* 2*m*m*R*R*R*I1*I1 */
    const double t49 = params[4]*t41; /* I1*2*m*m*R*R*R*R */
    const double t50 = t13*t49; /* (I1 - I3)*I1*2*m*m*R*R*R*R */
    const double t51 = params[0]/2.0; /* m/2 */
    const double t52 = params[4]/2.0; /* I1/2 */
    const double t53 = params[5]/2.0; /* I3/2 */
    const double t54 = params[4]*params[1]; /* I1*R */
    const double t55 = params[5]*params[1]; /* I3*R */
    const double t56 = -t55; /* -I3*R */
    const double t57 = params[4] + t5; /* I1 + m*R*R */
    const double t58 = params[5] + t5; /* I3 + m*R*R */
    const double t59 = -params[4]; /* -I1 */
    out[6] = t0;
    out[7] = t2;
    out[8] = t3;
    out[9] = t6;
    out[10] = t7;
    out[11] = t9;
    out[12] = t12;
    out[13] = t15;
    out[14] = t16;
    out[15] = t17;
    out[16] = t22;
    out[17] = t30;
    out[18] = t31;
    out[19] = t37;
    out[20] = t39;
    out[21] = t40;
    out[22] = t43;
    out[23] = t11;
    out[24] = t46;
    out[25] = t48;
    out[26] = t50;
    out[27] = t1;
    out[28] = t14;
    out[29] = t51;
    out[30] = t52;
    out[31] = t53;
    out[32] = t54;
    out[33] = t55;
    out[34] = t5;
    out[35] = t56;
    out[36] = t57;
    out[37] = t10;
    out[38] = t58;
    out[39] = t59;
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
    const double t10 = x[9]*p[9]; /* s*m*R^2*I1 */
    const double t11 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t12 = JLT_FMA(x[9], t10, p[8]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t13 = JLT_FMA(x[0], t11, t12); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t14 = 1.0/t13; /* 1/Theta */
    const double t15 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t16 = p[7]*t15; /* m*R*I3*V */
    const double t17 = JLT_FNMA(t14, t16, x[2]); /* omega_tau - 1/Theta*m*R*I3*V */
    const double t18 = t3*t17; /* omega_n*gamma3*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t19 = t0*x[4]; /* s*omega_tau*omega3 */
    const double t20 = p[11]*t19; /* (I3^2 + m*R^2*I3)*s*omega_tau*omega3 */
    const double t21 = JLT_FMA(t14, t20, t18); /* 1/Theta*(I3^2 + m*R^2*I3)*s*omega_tau*omega3 + omega_n*gamma3*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t22 = x[3]*t15; /* omega_n*V */
    const double t23 = x[0]*p[13]; /* gamma3*R*(I1 - I3)/I1 */
    const double t24 = JLT_FNMA(t19, t23, t22); /* omega_n*V - s*omega_tau*omega3*gamma3*R*(I1 - I3)/I1 */
    const double t25 = x[9]*p[12]; /* s*(-m*R*I1) */
    const double t26 = t24*t25; /* (omega_n*V - s*omega_tau*omega3*gamma3*R*(I1 - I3)/I1)*s*(-m*R*I1) */
    const double t27 = t14*t26; /* 1/Theta*t26 */
    const double t28 = -x[3]; /* -omega_n */
    const double t29 = cos(x[5]); /* C = cos(chi) */
    const double t30 = x[1]*t29; /* v_nu*C */
    const double t31 = sin(x[5]); /* S = sin(chi) */
    const double t32 = JLT_FMA(t5, t31, t30); /* R*(s*omega3 + omega_n*gamma3)*S + v_nu*C */
    const double t33 = x[9]*t32; /* s*(R*(s*omega3 + omega_n*gamma3)*S + v_nu*C) */
    const double t34 = x[1]*t31; /* v_nu*S */
    const double t35 = JLT_FNMA(t5, t29, t34); /* v_nu*S - R*(s*omega3 + omega_n*gamma3)*C */
    const double t36 = x[9]*t35; /* s*(v_nu*S - R*(s*omega3 + omega_n*gamma3)*C) */
    const double t37 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t38 = -t37; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t6;
    out[2] = t9;
    out[3] = t21;
    out[4] = t27;
    out[5] = t28;
    out[6] = t4;
    out[7] = t33;
    out[8] = t36;
    out[9] = t38;
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
    const double t8 = JLT_FMA(p[14], t7, t6); /* 2*R*omega_n*gamma3 + omega3*s*R */
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
    const double t19 = t10*p[15]; /* omega_n*omega3*(-I3/I1) */
    const double t20 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t21 = JLT_FMA(t0, p[9], p[8]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t22 = JLT_FMA(p[10], t20, t21); /* Theta = m*R^2*I3*gamma3*gamma3 + s*s*m*R^2*I1 + I1*I3 */
    const double t23 = 1.0/t22; /* 1/Theta */
    const double t24 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t25 = t23*t24; /* 1/Theta*V */
    const double t26 = JLT_FNMA(p[7], t25, x[2]); /* omega_tau - m*R*I3*1/Theta*V */
    const double t27 = x[3]*t26; /* omega_n*(omega_tau - m*R*I3*1/Theta*V) */
    const double t28 = t7*t25; /* omega_n*gamma3*1/Theta*V */
    const double t29 = p[16]*t28; /* 2*m^2*R^3*I3^2*omega_n*gamma3*1/Theta*V */
    const double t30 = x[9]*t23; /* s*1/Theta */
    const double t31 = x[2]*t30; /* omega_tau*s*1/Theta */
    const double t32 = x[4]*t31; /* omega3*omega_tau*s*1/Theta */
    const double t33 = JLT_FNMA(p[17], t32, t29); /* 2*m^2*R^3*I3^2*omega_n*gamma3*1/Theta*V - (2*m*R^2*I3^3 + 2*m^2*R^4*I3^2)*omega3*omega_tau*s*1/Theta */
    const double t34 = x[0]*t23; /* gamma3*1/Theta */
    const double t35 = JLT_FMA(t33, t34, t27); /* t33*gamma3*1/Theta + omega_n*(omega_tau - m*R*I3*1/Theta*V) */
    const double t36 = t7*t23; /* omega_n*gamma3*1/Theta */
    const double t37 = p[18]*t36; /* (-m*R*I3)*omega_n*gamma3*1/Theta */
    const double t38 = x[4]*t30; /* omega3*s*1/Theta */
    const double t39 = JLT_FNMA(p[10], t36, t7); /* omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*1/Theta */
    const double t40 = JLT_FMA(p[11], t38, t39); /* (I3^2 + m*R^2*I3)*omega3*s*1/Theta + omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*1/Theta */
    const double t41 = x[0]*t26; /* gamma3*(omega_tau - m*R*I3*1/Theta*V) */
    const double t42 = t31*p[11]; /* omega_tau*s*1/Theta*(I3^2 + m*R^2*I3) */
    const double t43 = x[2]*p[11]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t44 = x[4]*t43; /* omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t45 = t30*t32; /* s*1/Theta*omega3*omega_tau*s*1/Theta */
    const double t46 = t30*p[20]; /* s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t47 = t28*t46; /* omega_n*gamma3*1/Theta*V*s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t48 = JLT_FMA(t23, t44, t47); /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) + omega_n*gamma3*1/Theta*V*s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t49 = JLT_FNMA(p[19], t45, t48); /* t48 - (2*m*R^2*I1*I3^2 + 2*m^2*R^4*I1*I3)*s*1/Theta*omega3*omega_tau*s*1/Theta */
    const double t50 = x[9]*p[21]; /* s*m*R^2*(I1 - I3) */
    const double t51 = t20*p[22]; /* gamma3*gamma3*2*m^2*R^4*I3*(I1 - I3) */
    const double t52 = JLT_FMA(t32, t50, t47); /* omega3*omega_tau*s*1/Theta*s*m*R^2*(I1 - I3) + omega_n*gamma3*1/Theta*V*s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t53 = JLT_FNMA(t45, t51, t52); /* t52 - s*1/Theta*omega3*omega_tau*s*1/Theta*gamma3*gamma3*2*m^2*R^4*I3*(I1 - I3) */
    const double t54 = x[3]*t30; /* omega_n*s*1/Theta */
    const double t55 = p[12]*t54; /* (-m*R*I1)*omega_n*s*1/Theta */
    const double t56 = x[9]*x[0]; /* s*gamma3 */
    const double t57 = p[21]*t56; /* m*R^2*(I1 - I3)*s*gamma3 */
    const double t58 = t38*t57; /* omega3*s*1/Theta*m*R^2*(I1 - I3)*s*gamma3 */
    const double t59 = JLT_FNMA(p[9], t54, t58); /* omega3*s*1/Theta*m*R^2*(I1 - I3)*s*gamma3 - m*R^2*I1*omega_n*s*1/Theta */
    const double t60 = t24*t30; /* V*s*1/Theta */
    const double t61 = p[12]*t60; /* (-m*R*I1)*V*s*1/Theta */
    const double t62 = t31*t57; /* omega_tau*s*1/Theta*m*R^2*(I1 - I3)*s*gamma3 */
    const double t63 = x[3]*p[23]; /* omega_n*m*R*I1 */
    const double t64 = t25*t63; /* 1/Theta*V*omega_n*m*R*I1 */
    const double t65 = x[0]*p[24]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t66 = t54*p[25]; /* omega_n*s*1/Theta*2*m^2*R^3*I1^2 */
    const double t67 = t56*p[26]; /* s*gamma3*2*m^2*R^4*I1*(I1 - I3) */
    const double t68 = JLT_FMS(t32, t65, t64); /* omega3*omega_tau*s*1/Theta*gamma3*2*m*R^2*(I1 - I3) - 1/Theta*V*omega_n*m*R*I1 */
    const double t69 = JLT_FMA(t60, t66, t68); /* V*s*1/Theta*omega_n*s*1/Theta*2*m^2*R^3*I1^2 + t68 */
    const double t70 = JLT_FNMA(t45, t67, t69); /* V*s*1/Theta*omega_n*s*1/Theta*2*m^2*R^3*I1^2 + t68 - s*1/Theta*omega3*omega_tau*s*1/Theta*s*gamma3*2*m^2*R^4*I1*(I1 - I3) */
    const double t71 = sin(x[5]); /* S = sin(chi) */
    const double t72 = t9*t71; /* omega_n*s*R*S */
    const double t73 = cos(x[5]); /* C = cos(chi) */
    const double t74 = x[9]*t73; /* s*C */
    const double t75 = t5*x[0]; /* s*R*gamma3 */
    const double t76 = t71*t75; /* S*s*R*gamma3 */
    const double t77 = x[9]*t71; /* s*S */
    const double t78 = t5*t77; /* s*R*s*S */
    const double t79 = x[1]*t71; /* v_nu*S */
    const double t80 = JLT_FMA(p[1], t7, t6); /* v_tau = R*omega_n*gamma3 + omega3*s*R */
    const double t81 = JLT_FNMA(t73, t80, t79); /* v_nu*S - C*v_tau */
    const double t82 = x[9]*t81; /* s*(v_nu*S - C*v_tau) */
    const double t83 = -t82; /* -s*(v_nu*S - C*v_tau) */
    const double t84 = x[1]*t73; /* v_nu*C */
    const double t85 = JLT_FMA(t71, t80, t84); /* S*v_tau + v_nu*C */
    const double t86 = JLT_FMA(t6, t71, t85); /* omega3*s*R*S + S*v_tau + v_nu*C */
    const double t87 = t9*t73; /* omega_n*s*R*C */
    const double t88 = -t87; /* -omega_n*s*R*C */
    const double t89 = t73*t75; /* C*s*R*gamma3 */
    const double t90 = -t89; /* -C*s*R*gamma3 */
    const double t91 = t5*t74; /* s*R*s*C */
    const double t92 = -t91; /* -s*R*s*C */
    const double t93 = x[9]*t85; /* s*(S*v_tau + v_nu*C) */
    const double t94 = JLT_FNMA(t6, t73, t81); /* v_nu*S - C*v_tau - omega3*s*R*C */
    const double t95 = -t1; /* -s*omega_tau */
    const double t96 = -t56; /* -s*gamma3 */
    const double t97 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t98 = -t97; /* -omega_tau*gamma3 */
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
    out[32] = t40;
    out[33] = t41;
    out[34] = t42;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t49;
    out[40] = t53;
    out[41] = t55;
    out[42] = t59;
    out[43] = t61;
    out[44] = t62;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t70;
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
    out[70] = t72;
    out[71] = t74;
    out[72] = 0.0;
    out[73] = t76;
    out[74] = t78;
    out[75] = t83;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = t86;
    out[80] = t88;
    out[81] = t77;
    out[82] = 0.0;
    out[83] = t90;
    out[84] = t92;
    out[85] = t93;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t94;
    out[90] = t95;
    out[91] = 0.0;
    out[92] = t96;
    out[93] = 0.0;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t98;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[2]; /* s*omega_tau */
    const double t1 = x[9]*t0; /* s*s*omega_tau */
    const double t2 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t3 = x[9]*x[4]; /* s*omega3 */
    const double t4 = t2 + t3; /* omega_n*gamma3 + s*omega3 */
    const double t5 = x[3]*p[1]; /* omega_n*R */
    const double t6 = t4*t5; /* (omega_n*gamma3 + s*omega3)*omega_n*R */
    const double t7 = x[3]*t2; /* omega_n*omega_n*gamma3 */
    const double t8 = x[3]*p[6]; /* omega_n*I3/I1 */
    const double t9 = JLT_FMA(t3, t8, t7); /* s*omega3*omega_n*I3/I1 + omega_n*omega_n*gamma3 */
    const double t10 = -t9; /* -(s*omega3*omega_n*I3/I1 + omega_n*omega_n*gamma3) */
    const double t11 = x[9]*x[9]; /* s*s */
    const double t12 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t13 = JLT_FMA(p[9], t11, p[8]); /* m*R^2*I1*s*s + I1*I3 */
    const double t14 = JLT_FMA(p[10], t12, t13); /* Theta = m*R^2*I3*gamma3*gamma3 + m*R^2*I1*s*s + I1*I3 */
    const double t15 = 1.0/t14; /* 1/Theta */
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = t15*t16; /* 1/Theta*V */
    const double t18 = JLT_FNMA(p[7], t17, x[2]); /* omega_tau - m*R*I3*1/Theta*V */
    const double t19 = t2*t18; /* omega_n*gamma3*(omega_tau - m*R*I3*1/Theta*V) */
    const double t20 = x[9]*t15; /* s*1/Theta */
    const double t21 = x[2]*t20; /* omega_tau*s*1/Theta */
    const double t22 = x[4]*t21; /* omega3*omega_tau*s*1/Theta */
    const double t23 = JLT_FMA(p[11], t22, t19); /* (I3^2 + m*R^2*I3)*omega3*omega_tau*s*1/Theta + omega_n*gamma3*(omega_tau - m*R*I3*1/Theta*V) */
    const double t24 = x[3]*t20; /* omega_n*s*1/Theta */
    const double t25 = t16*t24; /* V*omega_n*s*1/Theta */
    const double t26 = x[0]*t3; /* gamma3*s*omega3 */
    const double t27 = p[13]*t26; /* R*(I1 - I3)/I1*gamma3*s*omega3 */
    const double t28 = JLT_FNMA(t21, t27, t25); /* V*omega_n*s*1/Theta - omega_tau*s*1/Theta*R*(I1 - I3)/I1*gamma3*s*omega3 */
    const double t29 = p[12]*t28; /* (-m*R*I1)*t28 */
    const double t30 = -x[3]; /* -omega_n */
    const double t31 = cos(x[5]); /* C = cos(chi) */
    const double t32 = x[1]*t31; /* v_nu*C */
    const double t33 = sin(x[5]); /* S = sin(chi) */
    const double t34 = t4*p[1]; /* v_tau = (omega_n*gamma3 + s*omega3)*R */
    const double t35 = JLT_FMA(t33, t34, t32); /* S*v_tau + v_nu*C */
    const double t36 = x[9]*t35; /* s*(S*v_tau + v_nu*C) */
    const double t37 = x[1]*t33; /* v_nu*S */
    const double t38 = JLT_FNMA(t31, t34, t37); /* v_nu*S - C*v_tau */
    const double t39 = x[9]*t38; /* s*(v_nu*S - C*v_tau) */
    const double t40 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t41 = -t40; /* -s*omega_tau*gamma3 */
    const double t42 = t0*2.0; /* s*omega_tau*2 */
    const double t43 = x[3]*t5; /* omega_n*omega_n*R */
    const double t44 = t3*p[1]; /* s*omega3*R */
    const double t45 = JLT_FMA(t2, p[14], t44); /* omega_n*gamma3*2*R + s*omega3*R */
    const double t46 = x[9]*p[1]; /* s*R */
    const double t47 = x[3]*t46; /* omega_n*s*R */
    const double t48 = x[4]*t5; /* omega3*omega_n*R */
    const double t49 = x[3]*x[3]; /* omega_n*omega_n */
    const double t50 = -t49; /* -omega_n*omega_n */
    const double t51 = t2*(-2.0); /* omega_n*gamma3*(-2) */
    const double t52 = JLT_FMA(t3, p[15], t51); /* s*omega3*(-I3/I1) + omega_n*gamma3*(-2) */
    const double t53 = x[9]*t8; /* s*omega_n*I3/I1 */
    const double t54 = -t53; /* -s*omega_n*I3/I1 */
    const double t55 = x[4]*t8; /* omega3*omega_n*I3/I1 */
    const double t56 = -t55; /* -omega3*omega_n*I3/I1 */
    const double t57 = x[3]*t18; /* omega_n*(omega_tau - m*R*I3*1/Theta*V) */
    const double t58 = t2*t17; /* omega_n*gamma3*1/Theta*V */
    const double t59 = p[16]*t58; /* 2*m^2*R^3*I3^2*omega_n*gamma3*1/Theta*V */
    const double t60 = JLT_FNMA(t22, p[17], t59); /* 2*m^2*R^3*I3^2*omega_n*gamma3*1/Theta*V - omega3*omega_tau*s*1/Theta*(2*m*R^2*I3^3 + 2*m^2*R^4*I3^2) */
    const double t61 = x[0]*t15; /* gamma3*1/Theta */
    const double t62 = JLT_FMA(t60, t61, t57); /* t60*gamma3*1/Theta + omega_n*(omega_tau - m*R*I3*1/Theta*V) */
    const double t63 = t2*t15; /* omega_n*gamma3*1/Theta */
    const double t64 = p[18]*t63; /* (-m*R*I3)*omega_n*gamma3*1/Theta */
    const double t65 = x[4]*p[11]; /* omega3*(I3^2 + m*R^2*I3) */
    const double t66 = JLT_FMA(t20, t65, t2); /* s*1/Theta*omega3*(I3^2 + m*R^2*I3) + omega_n*gamma3 */
    const double t67 = JLT_FNMA(p[10], t63, t66); /* s*1/Theta*omega3*(I3^2 + m*R^2*I3) + omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*1/Theta */
    const double t68 = x[0]*t18; /* gamma3*(omega_tau - m*R*I3*1/Theta*V) */
    const double t69 = p[11]*t21; /* (I3^2 + m*R^2*I3)*omega_tau*s*1/Theta */
    const double t70 = x[2]*t65; /* omega_tau*omega3*(I3^2 + m*R^2*I3) */
    const double t71 = t15*t70; /* 1/Theta*omega_tau*omega3*(I3^2 + m*R^2*I3) */
    const double t72 = t58*p[20]; /* omega_n*gamma3*1/Theta*V*2*m^2*R^3*I1*I3 */
    const double t73 = JLT_FMS(t22, p[19], t72); /* omega3*omega_tau*s*1/Theta*(2*m*R^2*I1*I3^2 + 2*m^2*R^4*I1*I3) - omega_n*gamma3*1/Theta*V*2*m^2*R^3*I1*I3 */
    const double t74 = JLT_FNMA(t20, t73, t71); /* 1/Theta*omega_tau*omega3*(I3^2 + m*R^2*I3) - s*1/Theta*t73 */
    const double t75 = t21*p[21]; /* omega_tau*s*1/Theta*m*R^2*(I1 - I3) */
    const double t76 = t3*t75; /* s*omega3*omega_tau*s*1/Theta*m*R^2*(I1 - I3) */
    const double t77 = t12*p[22]; /* gamma3*gamma3*2*m^2*R^4*I3*(I1 - I3) */
    const double t78 = JLT_FMS(t22, t77, t72); /* omega3*omega_tau*s*1/Theta*gamma3*gamma3*2*m^2*R^4*I3*(I1 - I3) - omega_n*gamma3*1/Theta*V*2*m^2*R^3*I1*I3 */
    const double t79 = JLT_FNMA(t20, t78, t76); /* s*omega3*omega_tau*s*1/Theta*m*R^2*(I1 - I3) - s*1/Theta*t78 */
    const double t80 = p[12]*t24; /* (-m*R*I1)*omega_n*s*1/Theta */
    const double t81 = t26*p[21]; /* gamma3*s*omega3*m*R^2*(I1 - I3) */
    const double t82 = t20*t81; /* s*1/Theta*gamma3*s*omega3*m*R^2*(I1 - I3) */
    const double t83 = JLT_FNMA(p[9], t24, t82); /* s*1/Theta*gamma3*s*omega3*m*R^2*(I1 - I3) - m*R^2*I1*omega_n*s*1/Theta */
    const double t84 = t16*p[12]; /* V*(-m*R*I1) */
    const double t85 = t20*t84; /* s*1/Theta*V*(-m*R*I1) */
    const double t86 = x[9]*x[0]; /* s*gamma3 */
    const double t87 = t75*t86; /* omega_tau*s*1/Theta*m*R^2*(I1 - I3)*s*gamma3 */
    const double t88 = x[3]*p[23]; /* omega_n*m*R*I1 */
    const double t89 = t17*t88; /* 1/Theta*V*omega_n*m*R*I1 */
    const double t90 = x[0]*p[24]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t91 = t20*p[25]; /* s*1/Theta*2*m^2*R^3*I1^2 */
    const double t92 = JLT_FMS(t22, t90, t89); /* omega3*omega_tau*s*1/Theta*gamma3*2*m*R^2*(I1 - I3) - 1/Theta*V*omega_n*m*R*I1 */
    const double t93 = JLT_FMA(t28, t91, t92); /* t28*s*1/Theta*2*m^2*R^3*I1^2 + t92 */
    const double t94 = t33*t47; /* S*omega_n*s*R */
    const double t95 = x[9]*t31; /* s*C */
    const double t96 = x[0]*t46; /* gamma3*s*R */
    const double t97 = t33*t96; /* S*gamma3*s*R */
    const double t98 = x[9]*t33; /* s*S */
    const double t99 = t46*t98; /* s*R*s*S */
    const double t100 = -t39; /* -s*(v_nu*S - C*v_tau) */
    const double t101 = JLT_FMA(t33, t44, t35); /* S*s*omega3*R + S*v_tau + v_nu*C */
    const double t102 = t31*t47; /* C*omega_n*s*R */
    const double t103 = -t102; /* -C*omega_n*s*R */
    const double t104 = t31*t96; /* C*gamma3*s*R */
    const double t105 = -t104; /* -C*gamma3*s*R */
    const double t106 = t46*t95; /* s*R*s*C */
    const double t107 = -t106; /* -s*R*s*C */
    const double t108 = JLT_FNMA(t31, t44, t38); /* v_nu*S - C*v_tau - C*s*omega3*R */
    const double t109 = -t0; /* -s*omega_tau */
    const double t110 = -t86; /* -s*gamma3 */
    const double t111 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t112 = -t111; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t6;
    out[2] = t10;
    out[3] = t23;
    out[4] = t29;
    out[5] = t30;
    out[6] = t4;
    out[7] = t36;
    out[8] = t39;
    out[9] = t41;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t11;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t42;
    out[20] = t43;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = t45;
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
    out[34] = t54;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t56;
    out[40] = t62;
    out[41] = t64;
    out[42] = t67;
    out[43] = t68;
    out[44] = t69;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t74;
    out[50] = t79;
    out[51] = t80;
    out[52] = t83;
    out[53] = t85;
    out[54] = t87;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = t93;
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
    out[80] = t94;
    out[81] = t95;
    out[82] = 0.0;
    out[83] = t97;
    out[84] = t99;
    out[85] = t100;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t101;
    out[90] = t103;
    out[91] = t98;
    out[92] = 0.0;
    out[93] = t105;
    out[94] = t107;
    out[95] = t36;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t108;
    out[100] = t109;
    out[101] = 0.0;
    out[102] = t110;
    out[103] = 0.0;
    out[104] = 0.0;
    out[105] = 0.0;
    out[106] = 0.0;
    out[107] = 0.0;
    out[108] = 0.0;
    out[109] = t112;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t2 = JLT_FMA(p[9], t0, p[8]); /* m*R^2*I1*s*s + I1*I3 */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta = gamma3*gamma3*m*R^2*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t4 = 1.0/t3; /* 1/Theta */
    const double t5 = p[28]*x[2]; /* R*(I1 - I3)*omega_tau */
    const double t6 = t0*t5; /* s*s*R*(I1 - I3)*omega_tau */
    const double t7 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t8 = JLT_FNMA(p[5], t7, t6); /* s*s*R*(I1 - I3)*omega_tau - I3*V */
    const double t9 = p[27]*x[0]; /* m*R*gamma3 */
    const double t10 = t8*t9; /* (s*s*R*(I1 - I3)*omega_tau - I3*V)*m*R*gamma3 */
    const double t11 = t4*t10; /* 1/Theta*(s*s*R*(I1 - I3)*omega_tau - I3*V)*m*R*gamma3 */
    out[0] = t11;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t2 = x[4]*x[9]; /* omega3*s */
    const double t3 = t1 + t2; /* omega_n*gamma3 + omega3*s */
    const double t4 = p[1]*t3; /* v_tau = R*(omega_n*gamma3 + omega3*s) */
    const double t5 = JLT_FMA(t4, t4, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t6 = x[3]*x[3]; /* omega_n*omega_n */
    const double t7 = JLT_FMA(x[2], x[2], t6); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t8 = p[30]*t7; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t9 = x[4]*p[31]; /* omega3*1/2*I3 */
    const double t10 = JLT_FMA(x[4], t9, t8); /* omega3*omega3*1/2*I3 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t11 = JLT_FMA(p[29], t5, t10); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t10 */
    const double t12 = x[3]*p[32]; /* omega_n*R*I1 */
    const double t13 = x[9]*t12; /* s*omega_n*R*I1 */
    const double t14 = x[4]*p[33]; /* omega3*R*I3 */
    const double t15 = JLT_FNMA(x[0], t14, t13); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    const double t16 = cos(x[5]); /* C = cos(chi) */
    const double t17 = t1*p[4]; /* omega_n*gamma3*I1 */
    const double t18 = JLT_FMA(t2, p[5], t17); /* omega3*s*I3 + omega_n*gamma3*I1 */
    const double t19 = JLT_FMA(t4, p[27], t18); /* M_nu = v_tau*m*R + omega3*s*I3 + omega_n*gamma3*I1 */
    const double t20 = t16*t19; /* C*M_nu */
    const double t21 = sin(x[5]); /* S = sin(chi) */
    const double t22 = x[2]*p[4]; /* omega_tau*I1 */
    const double t23 = JLT_FNMA(x[1], p[27], t22); /* M_tau = omega_tau*I1 - v_nu*m*R */
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
    const double t1 = JLT_FMA(x[3], x[0], t0); /* omega_n*gamma3 + omega3*s */
    const double t2 = p[34]*t1; /* m*R^2*(omega_n*gamma3 + omega3*s) */
    const double t3 = x[3]*t2; /* omega_n*m*R^2*(omega_n*gamma3 + omega3*s) */
    const double t4 = p[0]*x[1]; /* m*v_nu */
    const double t5 = p[4]*x[2]; /* I1*omega_tau */
    const double t6 = x[3]*p[4]; /* omega_n*I1 */
    const double t7 = JLT_FMA(x[0], t2, t6); /* gamma3*m*R^2*(omega_n*gamma3 + omega3*s) + omega_n*I1 */
    const double t8 = x[4]*p[5]; /* omega3*I3 */
    const double t9 = JLT_FMA(x[9], t2, t8); /* s*m*R^2*(omega_n*gamma3 + omega3*s) + omega3*I3 */
    const double t10 = x[4]*t2; /* omega3*m*R^2*(omega_n*gamma3 + omega3*s) */
    const double t11 = x[4]*p[35]; /* omega3*(-R*I3) */
    const double t12 = x[9]*p[32]; /* s*R*I1 */
    const double t13 = x[0]*p[35]; /* gamma3*(-R*I3) */
    const double t14 = x[3]*p[32]; /* omega_n*R*I1 */
    const double t15 = cos(x[5]); /* C = cos(chi) */
    const double t16 = x[3]*p[36]; /* d(M_nu)/d(gamma3) = omega_n*(I1 + m*R^2) */
    const double t17 = t15*t16; /* C*d(M_nu)/d(gamma3) */
    const double t18 = sin(x[5]); /* S = sin(chi) */
    const double t19 = p[37]*t18; /* (-m*R)*S */
    const double t20 = p[4]*t18; /* I1*S */
    const double t21 = x[0]*p[36]; /* d(M_nu)/d(omega_n) = gamma3*(I1 + m*R^2) */
    const double t22 = t15*t21; /* C*d(M_nu)/d(omega_n) */
    const double t23 = x[9]*p[38]; /* d(M_nu)/d(omega3) = s*(I3 + m*R^2) */
    const double t24 = t15*t23; /* C*d(M_nu)/d(omega3) */
    const double t25 = JLT_FMA(x[0], t6, t2); /* gamma3*omega_n*I1 + m*R^2*(omega_n*gamma3 + omega3*s) */
    const double t26 = JLT_FMA(t0, p[5], t25); /* M_nu = omega3*s*I3 + gamma3*omega_n*I1 + m*R^2*(omega_n*gamma3 + omega3*s) */
    const double t27 = t18*t26; /* S*M_nu */
    const double t28 = JLT_FNMA(x[1], p[27], t5); /* M_tau = I1*omega_tau - v_nu*m*R */
    const double t29 = JLT_FMS(t15, t28, t27); /* C*M_tau - S*M_nu */
    const double t30 = x[4]*p[38]; /* d(M_nu)/d(s) = omega3*(I3 + m*R^2) */
    const double t31 = t15*t30; /* C*d(M_nu)/d(s) */
    const double t32 = t16*t18; /* d(M_nu)/d(gamma3)*S */
    const double t33 = t15*p[27]; /* C*m*R */
    const double t34 = t15*p[39]; /* C*(-I1) */
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
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double u46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double u48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
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
        t20[k] = x9[k]*p[9];
        t22[k] = x0[k]*p[10];
        t23[k] = jlt_jet_product(x9, t20, k) + (k == 0 ? p[8] : 0);
        t24[k] = jlt_jet_product(x0, t22, k) + t23[k];
        t26[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t24, t26, k);
        t28[k] = x2[k]*p[1] + x1[k];
        t29[k] = jlt_jet_product(t26, t28, k);
        t30[k] = x2[k] - p[7]*t29[k];
        t31[k] = jlt_jet_product(t9, t30, k);
        t33[k] = jlt_jet_product(t7, t26, k);
        t34[k] = x2[k]*p[11];
        t35[k] = jlt_jet_product(t33, t34, k) + t31[k];
        t37[k] = x9[k]*p[23];
        t38[k] = jlt_jet_product(x3, t37, k);
        t39[k] = jlt_jet_product(t29, t38, k);
        t41[k] = jlt_jet_product(t2, x0, k);
        t42[k] = p[21]*t41[k];
        t43[k] = jlt_jet_product(t33, t42, k) - t39[k];
        t44[k] = -x3[k];
        t46[k] = jlt_jet_cosine(x5, t46, u46, k);
        t47[k] = jlt_jet_product(x1, t46, k);
        t48[k] = jlt_jet_sine(x5, t48, u48, k);
        t49[k] = jlt_jet_product(t11, t48, k) + t47[k];
        t50[k] = jlt_jet_product(x9, t49, k);
        t51[k] = jlt_jet_product(x1, t48, k);
        t52[k] = t51[k] - jlt_jet_product(t11, t46, k);
        t53[k] = jlt_jet_product(x9, t52, k);
        t54[k] = -t41[k];
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t12[k]/(k + 1);
        next[2] = x2[k + 1] = t16[k]/(k + 1);
        next[3] = x3[k + 1] = t35[k]/(k + 1);
        next[4] = x4[k + 1] = t43[k]/(k + 1);
        next[5] = x5[k + 1] = t44[k]/(k + 1);
        next[6] = x6[k + 1] = t10[k]/(k + 1);
        next[7] = x7[k + 1] = t50[k]/(k + 1);
        next[8] = x8[k + 1] = t53[k]/(k + 1);
        next[9] = x9[k + 1] = t54[k]/(k + 1);
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
    .state_count = 10, .param_count = 6, .block_count = 40,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 10, { 4, 23, 9, 1, 0, 2, 7, 8 }, { 17, 71, 0, 6, 0, 2, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .jacobian = { jacobian, 100, { 10, 63, 23, 1, 0, 2, 10, 18 }, { 50, 292, 0, 31, 0, 2, 13, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .rhs_jacobian = { rhs_jacobian, 110, { 14, 72, 24, 1, 0, 2, 9, 27 }, { 63, 347, 0, 37, 0, 2, 13, 10 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .divergence = { divergence, 1, { 0, 7, 4, 1, 0, 0, 5, 4 }, { 5, 23, 0, 2, 0, 0, 8, 5 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .integral_values = { integral_values, 4, { 1, 14, 10, 0, 0, 2, 6, 7 }, { 11, 38, 0, 0, 0, 2, 8, 7 },
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
