/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 10   38    0    6    0    0     10    9   (93)
 *  jacobian            46  187    0   45    0    0     16   25   (644)
 *  rhs_jacobian        51  200    0   51    0    0     16   30   (723)
 *  divergence          7   24    0    3    0    0     10    8   (41)
 *  integral_values     8   33    0    3    0    0     12    6   (47)
 *  integral_gradients  12   76    0   14    0    0     13   13   (195)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_balanced_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
    out[6] = params[6];
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[3]*params[4]; /* I1*I3 */
    const double t1 = params[3] - params[4]; /* I1 - I3 */
    out[7] = t0;
    out[8] = t1;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[1]; /* R*R */
    const double t3 = t2*p[3]; /* R*R*I1 */
    const double t4 = t0*t3; /* s*s*R*R*I1 */
    const double t5 = t2*p[4]; /* R*R*I3 */
    const double t6 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t7 = t5*t6; /* R*R*I3*gamma3*gamma3 */
    const double t8 = t4 + t7; /* K = s*s*R*R*I1 + R*R*I3*gamma3*gamma3 */
    const double t9 = p[1]*p[6]; /* R*G */
    const double t10 = x[4]*t9; /* s*R*G */
    const double t11 = p[1]*p[4]; /* R*I3 */
    const double t12 = x[0]*t11; /* gamma3*R*I3 */
    const double t13 = x[3]*t12; /* v_tau*gamma3*R*I3 */
    const double t14 = t10 + t13; /* s*R*G + v_tau*gamma3*R*I3 */
    const double t15 = x[3]*t14; /* v_tau*(s*R*G + v_tau*gamma3*R*I3) */
    const double t16 = t15/t8; /* v_tau*(s*R*G + v_tau*gamma3*R*I3)/K */
    const double t17 = t8*t8; /* K*K */
    const double t18 = t14*t14; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t19 = x[0]*t18; /* gamma3*(s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t20 = t19/t17; /* t19/(K*K) */
    const double t21 = -t20; /* -t19/(K*K) */
    const double t22 = x[4]*p[4]; /* s*I3 */
    const double t23 = p[3]*t17; /* I1*K*K */
    const double t24 = t14*t22; /* (s*R*G + v_tau*gamma3*R*I3)*s*I3 */
    const double t25 = p[1]*p[3]; /* R*I1 */
    const double t26 = x[3]*t25; /* v_tau*R*I1 */
    const double t27 = x[4]*t26; /* s*v_tau*R*I1 */
    const double t28 = x[0]*t9; /* gamma3*R*G */
    const double t29 = t27 - t28; /* s*v_tau*R*I1 - gamma3*R*G */
    const double t30 = t24*t29; /* (s*R*G + v_tau*gamma3*R*I3)*s*I3*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t31 = t30/t23; /* (s*R*G + v_tau*gamma3*R*I3)*s*I3*(s*v_tau*R*I1 - gamma3*R*G)/(I1*K*K) */
    const double t32 = t21 - t31; /* -t19/(K*K) - t31 */
    const double t33 = t14*x[1]; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu */
    const double t34 = t33/t8; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu/K */
    const double t35 = p[3]*p[4]; /* I1*I3 */
    const double t36 = t8*p[0]; /* K*m */
    const double t37 = t36 + p[7]; /* Theta = K*m + I1*I3 */
    const double t38 = t8*t37; /* K*Theta */
    const double t39 = x[2]*p[1]; /* omega_tau*R */
    const double t40 = x[1] + t39; /* V = v_nu + omega_tau*R */
    const double t41 = t35*t40; /* I1*I3*V */
    const double t42 = t14*t41; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V */
    const double t43 = t42/t38; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V/(K*Theta) */
    const double t44 = t43 - t34; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V/(K*Theta) - (s*R*G + v_tau*gamma3*R*I3)*v_nu/K */
    const double t45 = x[2]*t12; /* omega_tau*gamma3*R*I3 */
    const double t46 = x[4]*t45; /* s*omega_tau*gamma3*R*I3 */
    const double t47 = t46*p[8]; /* s*omega_tau*gamma3*R*I3*(I1 - I3) */
    const double t48 = t29*t47; /* (s*v_tau*R*I1 - gamma3*R*G)*s*omega_tau*gamma3*R*I3*(I1 - I3) */
    const double t49 = t48/t38; /* t48/(K*Theta) */
    const double t50 = t44 - t49; /* t44 - t48/(K*Theta) */
    const double t51 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t52 = x[4]*t51; /* s*omega_tau*gamma3 */
    const double t53 = -t52; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t16;
    out[2] = t32;
    out[3] = t50;
    out[4] = t53;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[4]*t1; /* s*2*omega_tau */
    const double t3 = p[1]*p[4]; /* R*I3 */
    const double t4 = x[3]*x[3]; /* v_tau*v_tau */
    const double t5 = t3*t4; /* R*I3*v_tau*v_tau */
    const double t6 = p[1]*p[1]; /* R*R */
    const double t7 = t6*p[3]; /* R*R*I1 */
    const double t8 = t0*t7; /* s*s*R*R*I1 */
    const double t9 = p[4]*t6; /* I3*R*R */
    const double t10 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t11 = t9*t10; /* I3*R*R*gamma3*gamma3 */
    const double t12 = t8 + t11; /* K = s*s*R*R*I1 + I3*R*R*gamma3*gamma3 */
    const double t13 = t5/t12; /* R*I3*v_tau*v_tau/K */
    const double t14 = t9*x[0]; /* I3*R*R*gamma3 */
    const double t15 = x[3]*t14; /* v_tau*I3*R*R*gamma3 */
    const double t16 = t12*t12; /* K*K */
    const double t17 = p[1]*p[6]; /* R*G */
    const double t18 = x[4]*t17; /* s*R*G */
    const double t19 = t3*x[0]; /* R*I3*gamma3 */
    const double t20 = x[3]*t19; /* v_tau*R*I3*gamma3 */
    const double t21 = t18 + t20; /* s*R*G + v_tau*R*I3*gamma3 */
    const double t22 = t15*t21; /* v_tau*I3*R*R*gamma3*(s*R*G + v_tau*R*I3*gamma3) */
    const double t23 = t22/t16; /* v_tau*I3*R*R*gamma3*(s*R*G + v_tau*R*I3*gamma3)/(K*K) */
    const double t24 = 2.0*t23; /* 2*v_tau*I3*R*R*gamma3*(s*R*G + v_tau*R*I3*gamma3)/(K*K) */
    const double t25 = t13 - t24; /* R*I3*v_tau*v_tau/K - 2*v_tau*I3*R*R*gamma3*(s*R*G + v_tau*R*I3*gamma3)/(K*K) */
    const double t26 = t21/t12; /* (s*R*G + v_tau*R*I3*gamma3)/K */
    const double t27 = t20/t12; /* v_tau*R*I3*gamma3/K */
    const double t28 = t26 + t27; /* (s*R*G + v_tau*R*I3*gamma3)/K + v_tau*R*I3*gamma3/K */
    const double t29 = x[3]*t17; /* v_tau*R*G */
    const double t30 = t29/t12; /* v_tau*R*G/K */
    const double t31 = x[3]*t7; /* v_tau*R*R*I1 */
    const double t32 = x[4]*t31; /* s*v_tau*R*R*I1 */
    const double t33 = t21*t32; /* (s*R*G + v_tau*R*I3*gamma3)*s*v_tau*R*R*I1 */
    const double t34 = t33/t16; /* (s*R*G + v_tau*R*I3*gamma3)*s*v_tau*R*R*I1/(K*K) */
    const double t35 = 2.0*t34; /* 2*(s*R*G + v_tau*R*I3*gamma3)*s*v_tau*R*R*I1/(K*K) */
    const double t36 = t30 - t35; /* v_tau*R*G/K - 2*(s*R*G + v_tau*R*I3*gamma3)*s*v_tau*R*R*I1/(K*K) */
    const double t37 = t21*t21; /* (s*R*G + v_tau*R*I3*gamma3)*(s*R*G + v_tau*R*I3*gamma3) */
    const double t38 = t37/t16; /* (s*R*G + v_tau*R*I3*gamma3)*(s*R*G + v_tau*R*I3*gamma3)/(K*K) */
    const double t39 = -t38; /* -t38 */
    const double t40 = t20*t21; /* v_tau*R*I3*gamma3*(s*R*G + v_tau*R*I3*gamma3) */
    const double t41 = t40/t16; /* v_tau*R*I3*gamma3*(s*R*G + v_tau*R*I3*gamma3)/(K*K) */
    const double t42 = 2.0*t41; /* 2*v_tau*R*I3*gamma3*(s*R*G + v_tau*R*I3*gamma3)/(K*K) */
    const double t43 = t39 - t42; /* -t38 - 2*v_tau*R*I3*gamma3*(s*R*G + v_tau*R*I3*gamma3)/(K*K) */
    const double t44 = t12*t16; /* K*K*K */
    const double t45 = t11*t37; /* I3*R*R*gamma3*gamma3*(s*R*G + v_tau*R*I3*gamma3)*(s*R*G + v_tau*R*I3*gamma3) */
    const double t46 = t45/t44; /* t45/(K*K*K) */
    const double t47 = t46*4.0; /* t45/(K*K*K)*4 */
    const double t48 = t43 + t47; /* -t38 - 2*v_tau*R*I3*gamma3*(s*R*G + v_tau*R*I3*gamma3)/(K*K) + t45/(K*K*K)*4 */
    const double t49 = p[4]*p[4]; /* I3*I3 */
    const double t50 = p[1]*t49; /* R*I3*I3 */
    const double t51 = x[3]*t50; /* v_tau*R*I3*I3 */
    const double t52 = x[4]*t51; /* s*v_tau*R*I3*I3 */
    const double t53 = p[3]*t16; /* I1*K*K */
    const double t54 = p[1]*p[3]; /* R*I1 */
    const double t55 = x[3]*t54; /* v_tau*R*I1 */
    const double t56 = x[4]*t55; /* s*v_tau*R*I1 */
    const double t57 = x[0]*t17; /* gamma3*R*G */
    const double t58 = t56 - t57; /* s*v_tau*R*I1 - gamma3*R*G */
    const double t59 = t52*t58; /* s*v_tau*R*I3*I3*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t60 = t59/t53; /* s*v_tau*R*I3*I3*(s*v_tau*R*I1 - gamma3*R*G)/(I1*K*K) */
    const double t61 = t48 - t60; /* t48 - s*v_tau*R*I3*I3*(s*v_tau*R*I1 - gamma3*R*G)/(I1*K*K) */
    const double t62 = t6*t49; /* R*R*I3*I3 */
    const double t63 = x[0]*t62; /* gamma3*R*R*I3*I3 */
    const double t64 = x[4]*t63; /* s*gamma3*R*R*I3*I3 */
    const double t65 = p[3]*t44; /* I1*K*K*K */
    const double t66 = t21*t64; /* (s*R*G + v_tau*R*I3*gamma3)*s*gamma3*R*R*I3*I3 */
    const double t67 = t58*t66; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*R*G + v_tau*R*I3*gamma3)*s*gamma3*R*R*I3*I3 */
    const double t68 = t67/t65; /* t67/(I1*K*K*K) */
    const double t69 = 4.0*t68; /* 4*t67/(I1*K*K*K) */
    const double t70 = t61 + t69; /* t48 - s*v_tau*R*I3*I3*(s*v_tau*R*I1 - gamma3*R*G)/(I1*K*K) + 4*t67/(I1*K*K*K) */
    const double t71 = t3*p[6]; /* R*I3*G */
    const double t72 = x[4]*t71; /* s*R*I3*G */
    const double t73 = t21*t72; /* (s*R*G + v_tau*R*I3*gamma3)*s*R*I3*G */
    const double t74 = t73/t53; /* (s*R*G + v_tau*R*I3*gamma3)*s*R*I3*G/(I1*K*K) */
    const double t75 = t70 + t74; /* t70 + (s*R*G + v_tau*R*I3*gamma3)*s*R*I3*G/(I1*K*K) */
    const double t76 = t3*t10; /* R*I3*gamma3*gamma3 */
    const double t77 = t21*t76; /* (s*R*G + v_tau*R*I3*gamma3)*R*I3*gamma3*gamma3 */
    const double t78 = t77/t16; /* (s*R*G + v_tau*R*I3*gamma3)*R*I3*gamma3*gamma3/(K*K) */
    const double t79 = 2.0*t78; /* 2*(s*R*G + v_tau*R*I3*gamma3)*R*I3*gamma3*gamma3/(K*K) */
    const double t80 = -t79; /* -2*(s*R*G + v_tau*R*I3*gamma3)*R*I3*gamma3*gamma3/(K*K) */
    const double t81 = x[0]*t50; /* gamma3*R*I3*I3 */
    const double t82 = x[4]*t81; /* s*gamma3*R*I3*I3 */
    const double t83 = t58*t82; /* (s*v_tau*R*I1 - gamma3*R*G)*s*gamma3*R*I3*I3 */
    const double t84 = t83/t53; /* (s*v_tau*R*I1 - gamma3*R*G)*s*gamma3*R*I3*I3/(I1*K*K) */
    const double t85 = t80 - t84; /* -2*(s*R*G + v_tau*R*I3*gamma3)*R*I3*gamma3*gamma3/(K*K) - (s*v_tau*R*I1 - gamma3*R*G)*s*gamma3*R*I3*I3/(I1*K*K) */
    const double t86 = t0*t3; /* s*s*R*I3 */
    const double t87 = t21*t86; /* (s*R*G + v_tau*R*I3*gamma3)*s*s*R*I3 */
    const double t88 = t87/t16; /* (s*R*G + v_tau*R*I3*gamma3)*s*s*R*I3/(K*K) */
    const double t89 = t85 - t88; /* t85 - (s*R*G + v_tau*R*I3*gamma3)*s*s*R*I3/(K*K) */
    const double t90 = p[4]*t21; /* I3*(s*R*G + v_tau*R*I3*gamma3) */
    const double t91 = t58*t90; /* (s*v_tau*R*I1 - gamma3*R*G)*I3*(s*R*G + v_tau*R*I3*gamma3) */
    const double t92 = t91/t53; /* (s*v_tau*R*I1 - gamma3*R*G)*I3*(s*R*G + v_tau*R*I3*gamma3)/(I1*K*K) */
    const double t93 = -t92; /* -t92 */
    const double t94 = t21*t57; /* (s*R*G + v_tau*R*I3*gamma3)*gamma3*R*G */
    const double t95 = t94/t16; /* (s*R*G + v_tau*R*I3*gamma3)*gamma3*R*G/(K*K) */
    const double t96 = 2.0*t95; /* 2*(s*R*G + v_tau*R*I3*gamma3)*gamma3*R*G/(K*K) */
    const double t97 = t93 - t96; /* -t92 - 2*(s*R*G + v_tau*R*I3*gamma3)*gamma3*R*G/(K*K) */
    const double t98 = t7*x[0]; /* R*R*I1*gamma3 */
    const double t99 = x[4]*t98; /* s*R*R*I1*gamma3 */
    const double t100 = t37*t99; /* (s*R*G + v_tau*R*I3*gamma3)*(s*R*G + v_tau*R*I3*gamma3)*s*R*R*I1*gamma3 */
    const double t101 = t100/t44; /* t100/(K*K*K) */
    const double t102 = 4.0*t101; /* 4*t100/(K*K*K) */
    const double t103 = t97 + t102; /* -t92 - 2*(s*R*G + v_tau*R*I3*gamma3)*gamma3*R*G/(K*K) + 4*t100/(K*K*K) */
    const double t104 = t58*t72; /* (s*v_tau*R*I1 - gamma3*R*G)*s*R*I3*G */
    const double t105 = t104/t53; /* (s*v_tau*R*I1 - gamma3*R*G)*s*R*I3*G/(I1*K*K) */
    const double t106 = t103 - t105; /* t103 - (s*v_tau*R*I1 - gamma3*R*G)*s*R*I3*G/(I1*K*K) */
    const double t107 = t3*x[3]; /* R*I3*v_tau */
    const double t108 = x[4]*t107; /* s*R*I3*v_tau */
    const double t109 = t21*t108; /* (s*R*G + v_tau*R*I3*gamma3)*s*R*I3*v_tau */
    const double t110 = t109/t16; /* (s*R*G + v_tau*R*I3*gamma3)*s*R*I3*v_tau/(K*K) */
    const double t111 = t106 - t110; /* t103 - (s*v_tau*R*I1 - gamma3*R*G)*s*R*I3*G/(I1*K*K) - (s*R*G + v_tau*R*I3*gamma3)*s*R*I3*v_tau/(K*K) */
    const double t112 = t0*t9; /* s*s*I3*R*R */
    const double t113 = t21*t112; /* (s*R*G + v_tau*R*I3*gamma3)*s*s*I3*R*R */
    const double t114 = t58*t113; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*R*G + v_tau*R*I3*gamma3)*s*s*I3*R*R */
    const double t115 = t114/t44; /* t114/(K*K*K) */
    const double t116 = 4.0*t115; /* 4*t114/(K*K*K) */
    const double t117 = t111 + t116; /* t111 + 4*t114/(K*K*K) */
    const double t118 = t3*x[1]; /* R*I3*v_nu */
    const double t119 = x[3]*t118; /* v_tau*R*I3*v_nu */
    const double t120 = t119/t12; /* v_tau*R*I3*v_nu/K */
    const double t121 = t49*t54; /* I3*I3*R*I1 */
    const double t122 = x[3]*t121; /* v_tau*I3*I3*R*I1 */
    const double t123 = t12*p[0]; /* K*m */
    const double t124 = t123 + p[7]; /* Theta = K*m + I1*I3 */
    const double t125 = t12*t124; /* K*Theta */
    const double t126 = x[2]*p[1]; /* omega_tau*R */
    const double t127 = x[1] + t126; /* V = v_nu + omega_tau*R */
    const double t128 = t122*t127; /* v_tau*I3*I3*R*I1*V */
    const double t129 = t128/t125; /* v_tau*I3*I3*R*I1*V/(K*Theta) */
    const double t130 = t129 - t120; /* v_tau*I3*I3*R*I1*V/(K*Theta) - v_tau*R*I3*v_nu/K */
    const double t131 = t14*x[1]; /* I3*R*R*gamma3*v_nu */
    const double t132 = t21*t131; /* (s*R*G + v_tau*R*I3*gamma3)*I3*R*R*gamma3*v_nu */
    const double t133 = t132/t16; /* (s*R*G + v_tau*R*I3*gamma3)*I3*R*R*gamma3*v_nu/(K*K) */
    const double t134 = 2.0*t133; /* 2*(s*R*G + v_tau*R*I3*gamma3)*I3*R*R*gamma3*v_nu/(K*K) */
    const double t135 = t130 + t134; /* v_tau*I3*I3*R*I1*V/(K*Theta) - v_tau*R*I3*v_nu/K + 2*(s*R*G + v_tau*R*I3*gamma3)*I3*R*R*gamma3*v_nu/(K*K) */
    const double t136 = t7*t49; /* R*R*I1*I3*I3 */
    const double t137 = x[0]*t136; /* gamma3*R*R*I1*I3*I3 */
    const double t138 = t16*t124; /* K*K*Theta */
    const double t139 = t127*t137; /* V*gamma3*R*R*I1*I3*I3 */
    const double t140 = t21*t139; /* (s*R*G + v_tau*R*I3*gamma3)*V*gamma3*R*R*I1*I3*I3 */
    const double t141 = t140/t138; /* (s*R*G + v_tau*R*I3*gamma3)*V*gamma3*R*R*I1*I3*I3/(K*K*Theta) */
    const double t142 = 2.0*t141; /* 2*t141 */
    const double t143 = t135 - t142; /* t135 - 2*t141 */
    const double t144 = t6*p[0]; /* R*R*m */
    const double t145 = p[3]*t144; /* I1*R*R*m */
    const double t146 = t49*t145; /* I3*I3*I1*R*R*m */
    const double t147 = x[0]*t146; /* gamma3*I3*I3*I1*R*R*m */
    const double t148 = t124*t124; /* Theta*Theta */
    const double t149 = t12*t148; /* K*Theta*Theta */
    const double t150 = t127*t147; /* V*gamma3*I3*I3*I1*R*R*m */
    const double t151 = t21*t150; /* (s*R*G + v_tau*R*I3*gamma3)*V*gamma3*I3*I3*I1*R*R*m */
    const double t152 = t151/t149; /* (s*R*G + v_tau*R*I3*gamma3)*V*gamma3*I3*I3*I1*R*R*m/(K*Theta*Theta) */
    const double t153 = 2.0*t152; /* 2*t152 */
    const double t154 = t143 - t153; /* t135 - 2*t141 - 2*t152 */
    const double t155 = x[2]*t3; /* omega_tau*R*I3 */
    const double t156 = x[4]*t155; /* s*omega_tau*R*I3 */
    const double t157 = t156*p[8]; /* s*omega_tau*R*I3*(I1 - I3) */
    const double t158 = t58*t157; /* (s*v_tau*R*I1 - gamma3*R*G)*s*omega_tau*R*I3*(I1 - I3) */
    const double t159 = t158/t125; /* (s*v_tau*R*I1 - gamma3*R*G)*s*omega_tau*R*I3*(I1 - I3)/(K*Theta) */
    const double t160 = t154 - t159; /* t135 - 2*t141 - 2*t152 - t159 */
    const double t161 = p[1]*t6; /* R*R*R */
    const double t162 = t49*t161; /* I3*I3*R*R*R */
    const double t163 = t10*t162; /* gamma3*gamma3*I3*I3*R*R*R */
    const double t164 = x[2]*t163; /* omega_tau*gamma3*gamma3*I3*I3*R*R*R */
    const double t165 = x[4]*t164; /* s*omega_tau*gamma3*gamma3*I3*I3*R*R*R */
    const double t166 = p[8]*t165; /* (I1 - I3)*s*omega_tau*gamma3*gamma3*I3*I3*R*R*R */
    const double t167 = t58*t166; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*omega_tau*gamma3*gamma3*I3*I3*R*R*R */
    const double t168 = t167/t138; /* t167/(K*K*Theta) */
    const double t169 = 2.0*t168; /* 2*t167/(K*K*Theta) */
    const double t170 = t160 + t169; /* t135 - 2*t141 - 2*t152 - t159 + 2*t167/(K*K*Theta) */
    const double t171 = p[0]*t161; /* m*R*R*R */
    const double t172 = t49*t171; /* I3*I3*m*R*R*R */
    const double t173 = t10*t172; /* gamma3*gamma3*I3*I3*m*R*R*R */
    const double t174 = x[2]*t173; /* omega_tau*gamma3*gamma3*I3*I3*m*R*R*R */
    const double t175 = x[4]*t174; /* s*omega_tau*gamma3*gamma3*I3*I3*m*R*R*R */
    const double t176 = p[8]*t175; /* (I1 - I3)*s*omega_tau*gamma3*gamma3*I3*I3*m*R*R*R */
    const double t177 = t58*t176; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*omega_tau*gamma3*gamma3*I3*I3*m*R*R*R */
    const double t178 = t177/t149; /* t177/(K*Theta*Theta) */
    const double t179 = 2.0*t178; /* 2*t177/(K*Theta*Theta) */
    const double t180 = t170 + t179; /* t135 - 2*t141 - 2*t152 - t159 + 2*t167/(K*K*Theta) + 2*t177/(K*Theta*Theta) */
    const double t181 = t9*p[6]; /* I3*R*R*G */
    const double t182 = x[0]*t181; /* gamma3*I3*R*R*G */
    const double t183 = x[2]*t182; /* omega_tau*gamma3*I3*R*R*G */
    const double t184 = x[4]*t183; /* s*omega_tau*gamma3*I3*R*R*G */
    const double t185 = p[8]*t184; /* (I1 - I3)*s*omega_tau*gamma3*I3*R*R*G */
    const double t186 = t185/t125; /* (I1 - I3)*s*omega_tau*gamma3*I3*R*R*G/(K*Theta) */
    const double t187 = t180 + t186; /* t180 + (I1 - I3)*s*omega_tau*gamma3*I3*R*R*G/(K*Theta) */
    const double t188 = p[4]*p[3]; /* I3*I1 */
    const double t189 = t21*t188; /* (s*R*G + v_tau*R*I3*gamma3)*I3*I1 */
    const double t190 = t189/t125; /* (s*R*G + v_tau*R*I3*gamma3)*I3*I1/(K*Theta) */
    const double t191 = t190 - t26; /* (s*R*G + v_tau*R*I3*gamma3)*I3*I1/(K*Theta) - (s*R*G + v_tau*R*I3*gamma3)/K */
    const double t192 = p[4]*t54; /* I3*R*I1 */
    const double t193 = t21*t192; /* (s*R*G + v_tau*R*I3*gamma3)*I3*R*I1 */
    const double t194 = t193/t125; /* (s*R*G + v_tau*R*I3*gamma3)*I3*R*I1/(K*Theta) */
    const double t195 = x[4]*t19; /* s*R*I3*gamma3 */
    const double t196 = p[8]*t195; /* (I1 - I3)*s*R*I3*gamma3 */
    const double t197 = t58*t196; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*R*I3*gamma3 */
    const double t198 = t197/t125; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*R*I3*gamma3/(K*Theta) */
    const double t199 = t194 - t198; /* (s*R*G + v_tau*R*I3*gamma3)*I3*R*I1/(K*Theta) - t198 */
    const double t200 = t19*x[1]; /* R*I3*gamma3*v_nu */
    const double t201 = t200/t12; /* R*I3*gamma3*v_nu/K */
    const double t202 = x[0]*t121; /* gamma3*I3*I3*R*I1 */
    const double t203 = t127*t202; /* V*gamma3*I3*I3*R*I1 */
    const double t204 = t203/t125; /* V*gamma3*I3*I3*R*I1/(K*Theta) */
    const double t205 = t204 - t201; /* V*gamma3*I3*I3*R*I1/(K*Theta) - R*I3*gamma3*v_nu/K */
    const double t206 = p[4]*t7; /* I3*R*R*I1 */
    const double t207 = x[0]*t206; /* gamma3*I3*R*R*I1 */
    const double t208 = x[2]*t207; /* omega_tau*gamma3*I3*R*R*I1 */
    const double t209 = t0*t208; /* s*s*omega_tau*gamma3*I3*R*R*I1 */
    const double t210 = p[8]*t209; /* (I1 - I3)*s*s*omega_tau*gamma3*I3*R*R*I1 */
    const double t211 = t210/t125; /* (I1 - I3)*s*s*omega_tau*gamma3*I3*R*R*I1/(K*Theta) */
    const double t212 = t205 - t211; /* V*gamma3*I3*I3*R*I1/(K*Theta) - R*I3*gamma3*v_nu/K - (I1 - I3)*s*s*omega_tau*gamma3*I3*R*R*I1/(K*Theta) */
    const double t213 = t17*x[1]; /* R*G*v_nu */
    const double t214 = t213/t12; /* R*G*v_nu/K */
    const double t215 = p[6]*t192; /* G*I3*R*I1 */
    const double t216 = t127*t215; /* V*G*I3*R*I1 */
    const double t217 = t216/t125; /* V*G*I3*R*I1/(K*Theta) */
    const double t218 = t217 - t214; /* V*G*I3*R*I1/(K*Theta) - R*G*v_nu/K */
    const double t219 = x[2]*t19; /* omega_tau*R*I3*gamma3 */
    const double t220 = p[8]*t219; /* (I1 - I3)*omega_tau*R*I3*gamma3 */
    const double t221 = t58*t220; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*omega_tau*R*I3*gamma3 */
    const double t222 = t221/t125; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*omega_tau*R*I3*gamma3/(K*Theta) */
    const double t223 = t218 - t222; /* V*G*I3*R*I1/(K*Theta) - R*G*v_nu/K - t222 */
    const double t224 = t7*x[1]; /* R*R*I1*v_nu */
    const double t225 = x[4]*t224; /* s*R*R*I1*v_nu */
    const double t226 = t21*t225; /* (s*R*G + v_tau*R*I3*gamma3)*s*R*R*I1*v_nu */
    const double t227 = t226/t16; /* (s*R*G + v_tau*R*I3*gamma3)*s*R*R*I1*v_nu/(K*K) */
    const double t228 = 2.0*t227; /* 2*(s*R*G + v_tau*R*I3*gamma3)*s*R*R*I1*v_nu/(K*K) */
    const double t229 = t223 + t228; /* V*G*I3*R*I1/(K*Theta) - R*G*v_nu/K - t222 + 2*(s*R*G + v_tau*R*I3*gamma3)*s*R*R*I1*v_nu/(K*K) */
    const double t230 = p[3]*p[3]; /* I1*I1 */
    const double t231 = t6*t230; /* R*R*I1*I1 */
    const double t232 = p[4]*t231; /* I3*R*R*I1*I1 */
    const double t233 = x[4]*t232; /* s*I3*R*R*I1*I1 */
    const double t234 = t127*t233; /* V*s*I3*R*R*I1*I1 */
    const double t235 = t21*t234; /* (s*R*G + v_tau*R*I3*gamma3)*V*s*I3*R*R*I1*I1 */
    const double t236 = t235/t138; /* (s*R*G + v_tau*R*I3*gamma3)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t237 = 2.0*t236; /* 2*(s*R*G + v_tau*R*I3*gamma3)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t238 = t229 - t237; /* t229 - 2*(s*R*G + v_tau*R*I3*gamma3)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t239 = t144*t230; /* R*R*m*I1*I1 */
    const double t240 = p[4]*t239; /* I3*R*R*m*I1*I1 */
    const double t241 = x[4]*t240; /* s*I3*R*R*m*I1*I1 */
    const double t242 = t127*t241; /* V*s*I3*R*R*m*I1*I1 */
    const double t243 = t21*t242; /* (s*R*G + v_tau*R*I3*gamma3)*V*s*I3*R*R*m*I1*I1 */
    const double t244 = t243/t149; /* (s*R*G + v_tau*R*I3*gamma3)*V*s*I3*R*R*m*I1*I1/(K*Theta*Theta) */
    const double t245 = 2.0*t244; /* 2*t244 */
    const double t246 = t238 - t245; /* t238 - 2*t244 */
    const double t247 = x[3]*t208; /* v_tau*omega_tau*gamma3*I3*R*R*I1 */
    const double t248 = x[4]*t247; /* s*v_tau*omega_tau*gamma3*I3*R*R*I1 */
    const double t249 = p[8]*t248; /* (I1 - I3)*s*v_tau*omega_tau*gamma3*I3*R*R*I1 */
    const double t250 = t249/t125; /* (I1 - I3)*s*v_tau*omega_tau*gamma3*I3*R*R*I1/(K*Theta) */
    const double t251 = t246 - t250; /* t238 - 2*t244 - (I1 - I3)*s*v_tau*omega_tau*gamma3*I3*R*R*I1/(K*Theta) */
    const double t252 = p[3]*t161; /* I1*R*R*R */
    const double t253 = p[4]*t252; /* I3*I1*R*R*R */
    const double t254 = x[0]*t253; /* gamma3*I3*I1*R*R*R */
    const double t255 = x[2]*t254; /* omega_tau*gamma3*I3*I1*R*R*R */
    const double t256 = t0*t255; /* s*s*omega_tau*gamma3*I3*I1*R*R*R */
    const double t257 = p[8]*t256; /* (I1 - I3)*s*s*omega_tau*gamma3*I3*I1*R*R*R */
    const double t258 = t58*t257; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*s*omega_tau*gamma3*I3*I1*R*R*R */
    const double t259 = t258/t138; /* t258/(K*K*Theta) */
    const double t260 = 2.0*t259; /* 2*t258/(K*K*Theta) */
    const double t261 = t251 + t260; /* t251 + 2*t258/(K*K*Theta) */
    const double t262 = p[3]*t171; /* I1*m*R*R*R */
    const double t263 = p[4]*t262; /* I3*I1*m*R*R*R */
    const double t264 = x[0]*t263; /* gamma3*I3*I1*m*R*R*R */
    const double t265 = x[2]*t264; /* omega_tau*gamma3*I3*I1*m*R*R*R */
    const double t266 = t0*t265; /* s*s*omega_tau*gamma3*I3*I1*m*R*R*R */
    const double t267 = p[8]*t266; /* (I1 - I3)*s*s*omega_tau*gamma3*I3*I1*m*R*R*R */
    const double t268 = t58*t267; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*s*omega_tau*gamma3*I3*I1*m*R*R*R */
    const double t269 = t268/t149; /* t268/(K*Theta*Theta) */
    const double t270 = 2.0*t269; /* 2*t268/(K*Theta*Theta) */
    const double t271 = t261 + t270; /* t251 + 2*t258/(K*K*Theta) + 2*t268/(K*Theta*Theta) */
    const double t272 = x[4]*x[2]; /* s*omega_tau */
    const double t273 = -t272; /* -s*omega_tau */
    const double t274 = x[4]*x[0]; /* s*gamma3 */
    const double t275 = -t274; /* -s*gamma3 */
    const double t276 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t277 = -t276; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t25;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t28;
    out[9] = t36;
    out[10] = t75;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t89;
    out[14] = t117;
    out[15] = t187;
    out[16] = t191;
    out[17] = t199;
    out[18] = t212;
    out[19] = t271;
    out[20] = t273;
    out[21] = 0.0;
    out[22] = t275;
    out[23] = 0.0;
    out[24] = t277;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[1]; /* R*R */
    const double t3 = t2*p[3]; /* R*R*I1 */
    const double t4 = t0*t3; /* s*s*R*R*I1 */
    const double t5 = t2*p[4]; /* R*R*I3 */
    const double t6 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t7 = t5*t6; /* R*R*I3*gamma3*gamma3 */
    const double t8 = t4 + t7; /* K = s*s*R*R*I1 + R*R*I3*gamma3*gamma3 */
    const double t9 = p[1]*p[6]; /* R*G */
    const double t10 = x[4]*t9; /* s*R*G */
    const double t11 = p[1]*p[4]; /* R*I3 */
    const double t12 = x[0]*t11; /* gamma3*R*I3 */
    const double t13 = x[3]*t12; /* v_tau*gamma3*R*I3 */
    const double t14 = t10 + t13; /* s*R*G + v_tau*gamma3*R*I3 */
    const double t15 = x[3]*t14; /* v_tau*(s*R*G + v_tau*gamma3*R*I3) */
    const double t16 = t15/t8; /* v_tau*(s*R*G + v_tau*gamma3*R*I3)/K */
    const double t17 = t8*t8; /* K*K */
    const double t18 = t14*t14; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t19 = x[0]*t18; /* gamma3*(s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t20 = t19/t17; /* t19/(K*K) */
    const double t21 = -t20; /* -t19/(K*K) */
    const double t22 = x[4]*p[4]; /* s*I3 */
    const double t23 = p[3]*t17; /* I1*K*K */
    const double t24 = t14*t22; /* (s*R*G + v_tau*gamma3*R*I3)*s*I3 */
    const double t25 = p[1]*p[3]; /* R*I1 */
    const double t26 = x[3]*t25; /* v_tau*R*I1 */
    const double t27 = x[4]*t26; /* s*v_tau*R*I1 */
    const double t28 = x[0]*t9; /* gamma3*R*G */
    const double t29 = t27 - t28; /* s*v_tau*R*I1 - gamma3*R*G */
    const double t30 = t24*t29; /* (s*R*G + v_tau*gamma3*R*I3)*s*I3*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t31 = t30/t23; /* (s*R*G + v_tau*gamma3*R*I3)*s*I3*(s*v_tau*R*I1 - gamma3*R*G)/(I1*K*K) */
    const double t32 = t21 - t31; /* -t19/(K*K) - t31 */
    const double t33 = t14*x[1]; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu */
    const double t34 = t33/t8; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu/K */
    const double t35 = p[3]*p[4]; /* I1*I3 */
    const double t36 = t8*p[0]; /* K*m */
    const double t37 = t36 + p[7]; /* Theta = K*m + I1*I3 */
    const double t38 = t8*t37; /* K*Theta */
    const double t39 = x[2]*p[1]; /* omega_tau*R */
    const double t40 = x[1] + t39; /* V = v_nu + omega_tau*R */
    const double t41 = t35*t40; /* I1*I3*V */
    const double t42 = t14*t41; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V */
    const double t43 = t42/t38; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V/(K*Theta) */
    const double t44 = t43 - t34; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V/(K*Theta) - (s*R*G + v_tau*gamma3*R*I3)*v_nu/K */
    const double t45 = x[2]*t12; /* omega_tau*gamma3*R*I3 */
    const double t46 = x[4]*t45; /* s*omega_tau*gamma3*R*I3 */
    const double t47 = t46*p[8]; /* s*omega_tau*gamma3*R*I3*(I1 - I3) */
    const double t48 = t29*t47; /* (s*v_tau*R*I1 - gamma3*R*G)*s*omega_tau*gamma3*R*I3*(I1 - I3) */
    const double t49 = t48/t38; /* t48/(K*Theta) */
    const double t50 = t44 - t49; /* t44 - t48/(K*Theta) */
    const double t51 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t52 = -t51; /* -omega_tau*gamma3 */
    const double t53 = x[4]*t51; /* s*omega_tau*gamma3 */
    const double t54 = -t53; /* -s*omega_tau*gamma3 */
    const double t55 = x[2]*2.0; /* omega_tau*2 */
    const double t56 = x[4]*t55; /* s*omega_tau*2 */
    const double t57 = x[3]*x[3]; /* v_tau*v_tau */
    const double t58 = t11*t57; /* R*I3*v_tau*v_tau */
    const double t59 = t58/t8; /* R*I3*v_tau*v_tau/K */
    const double t60 = t5*x[0]; /* R*R*I3*gamma3 */
    const double t61 = x[3]*t60; /* v_tau*R*R*I3*gamma3 */
    const double t62 = t14*t61; /* (s*R*G + v_tau*gamma3*R*I3)*v_tau*R*R*I3*gamma3 */
    const double t63 = t62/t17; /* (s*R*G + v_tau*gamma3*R*I3)*v_tau*R*R*I3*gamma3/(K*K) */
    const double t64 = 2.0*t63; /* 2*(s*R*G + v_tau*gamma3*R*I3)*v_tau*R*R*I3*gamma3/(K*K) */
    const double t65 = t59 - t64; /* R*I3*v_tau*v_tau/K - 2*(s*R*G + v_tau*gamma3*R*I3)*v_tau*R*R*I3*gamma3/(K*K) */
    const double t66 = t14/t8; /* (s*R*G + v_tau*gamma3*R*I3)/K */
    const double t67 = t13/t8; /* v_tau*gamma3*R*I3/K */
    const double t68 = t66 + t67; /* (s*R*G + v_tau*gamma3*R*I3)/K + v_tau*gamma3*R*I3/K */
    const double t69 = x[3]*t9; /* v_tau*R*G */
    const double t70 = t69/t8; /* v_tau*R*G/K */
    const double t71 = x[3]*t3; /* v_tau*R*R*I1 */
    const double t72 = x[4]*t71; /* s*v_tau*R*R*I1 */
    const double t73 = t14*t72; /* (s*R*G + v_tau*gamma3*R*I3)*s*v_tau*R*R*I1 */
    const double t74 = t73/t17; /* (s*R*G + v_tau*gamma3*R*I3)*s*v_tau*R*R*I1/(K*K) */
    const double t75 = 2.0*t74; /* 2*(s*R*G + v_tau*gamma3*R*I3)*s*v_tau*R*R*I1/(K*K) */
    const double t76 = t70 - t75; /* v_tau*R*G/K - 2*(s*R*G + v_tau*gamma3*R*I3)*s*v_tau*R*R*I1/(K*K) */
    const double t77 = t18/t17; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3)/(K*K) */
    const double t78 = -t77; /* -t77 */
    const double t79 = t13*t14; /* v_tau*gamma3*R*I3*(s*R*G + v_tau*gamma3*R*I3) */
    const double t80 = t79/t17; /* v_tau*gamma3*R*I3*(s*R*G + v_tau*gamma3*R*I3)/(K*K) */
    const double t81 = 2.0*t80; /* 2*v_tau*gamma3*R*I3*(s*R*G + v_tau*gamma3*R*I3)/(K*K) */
    const double t82 = t78 - t81; /* -t77 - 2*v_tau*gamma3*R*I3*(s*R*G + v_tau*gamma3*R*I3)/(K*K) */
    const double t83 = t8*t17; /* K*K*K */
    const double t84 = t7*t18; /* R*R*I3*gamma3*gamma3*(s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t85 = t84/t83; /* t84/(K*K*K) */
    const double t86 = t85*4.0; /* t84/(K*K*K)*4 */
    const double t87 = t82 + t86; /* -t77 - 2*v_tau*gamma3*R*I3*(s*R*G + v_tau*gamma3*R*I3)/(K*K) + t84/(K*K*K)*4 */
    const double t88 = p[4]*p[4]; /* I3*I3 */
    const double t89 = p[1]*t88; /* R*I3*I3 */
    const double t90 = x[3]*t89; /* v_tau*R*I3*I3 */
    const double t91 = x[4]*t90; /* s*v_tau*R*I3*I3 */
    const double t92 = t29*t91; /* (s*v_tau*R*I1 - gamma3*R*G)*s*v_tau*R*I3*I3 */
    const double t93 = t92/t23; /* (s*v_tau*R*I1 - gamma3*R*G)*s*v_tau*R*I3*I3/(I1*K*K) */
    const double t94 = t87 - t93; /* t87 - (s*v_tau*R*I1 - gamma3*R*G)*s*v_tau*R*I3*I3/(I1*K*K) */
    const double t95 = t2*t88; /* R*R*I3*I3 */
    const double t96 = x[0]*t95; /* gamma3*R*R*I3*I3 */
    const double t97 = x[4]*t96; /* s*gamma3*R*R*I3*I3 */
    const double t98 = p[3]*t83; /* I1*K*K*K */
    const double t99 = t14*t97; /* (s*R*G + v_tau*gamma3*R*I3)*s*gamma3*R*R*I3*I3 */
    const double t100 = t29*t99; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*R*G + v_tau*gamma3*R*I3)*s*gamma3*R*R*I3*I3 */
    const double t101 = t100/t98; /* t100/(I1*K*K*K) */
    const double t102 = 4.0*t101; /* 4*t100/(I1*K*K*K) */
    const double t103 = t94 + t102; /* t87 - (s*v_tau*R*I1 - gamma3*R*G)*s*v_tau*R*I3*I3/(I1*K*K) + 4*t100/(I1*K*K*K) */
    const double t104 = p[6]*t11; /* G*R*I3 */
    const double t105 = x[4]*t104; /* s*G*R*I3 */
    const double t106 = t14*t105; /* (s*R*G + v_tau*gamma3*R*I3)*s*G*R*I3 */
    const double t107 = t106/t23; /* (s*R*G + v_tau*gamma3*R*I3)*s*G*R*I3/(I1*K*K) */
    const double t108 = t103 + t107; /* t103 + (s*R*G + v_tau*gamma3*R*I3)*s*G*R*I3/(I1*K*K) */
    const double t109 = t6*t11; /* gamma3*gamma3*R*I3 */
    const double t110 = t14*t109; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3 */
    const double t111 = t110/t17; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(K*K) */
    const double t112 = 2.0*t111; /* 2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(K*K) */
    const double t113 = -t112; /* -2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(K*K) */
    const double t114 = x[0]*t89; /* gamma3*R*I3*I3 */
    const double t115 = x[4]*t114; /* s*gamma3*R*I3*I3 */
    const double t116 = t29*t115; /* (s*v_tau*R*I1 - gamma3*R*G)*s*gamma3*R*I3*I3 */
    const double t117 = t116/t23; /* (s*v_tau*R*I1 - gamma3*R*G)*s*gamma3*R*I3*I3/(I1*K*K) */
    const double t118 = t113 - t117; /* -2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(K*K) - (s*v_tau*R*I1 - gamma3*R*G)*s*gamma3*R*I3*I3/(I1*K*K) */
    const double t119 = t0*t11; /* s*s*R*I3 */
    const double t120 = t14*t119; /* (s*R*G + v_tau*gamma3*R*I3)*s*s*R*I3 */
    const double t121 = t120/t17; /* (s*R*G + v_tau*gamma3*R*I3)*s*s*R*I3/(K*K) */
    const double t122 = t118 - t121; /* t118 - (s*R*G + v_tau*gamma3*R*I3)*s*s*R*I3/(K*K) */
    const double t123 = p[4]*t14; /* I3*(s*R*G + v_tau*gamma3*R*I3) */
    const double t124 = t29*t123; /* (s*v_tau*R*I1 - gamma3*R*G)*I3*(s*R*G + v_tau*gamma3*R*I3) */
    const double t125 = t124/t23; /* (s*v_tau*R*I1 - gamma3*R*G)*I3*(s*R*G + v_tau*gamma3*R*I3)/(I1*K*K) */
    const double t126 = -t125; /* -t125 */
    const double t127 = t14*t28; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*R*G */
    const double t128 = t127/t17; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*R*G/(K*K) */
    const double t129 = 2.0*t128; /* 2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*R*G/(K*K) */
    const double t130 = t126 - t129; /* -t125 - 2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*R*G/(K*K) */
    const double t131 = t3*x[0]; /* R*R*I1*gamma3 */
    const double t132 = x[4]*t131; /* s*R*R*I1*gamma3 */
    const double t133 = t18*t132; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3)*s*R*R*I1*gamma3 */
    const double t134 = t133/t83; /* t133/(K*K*K) */
    const double t135 = 4.0*t134; /* 4*t133/(K*K*K) */
    const double t136 = t130 + t135; /* -t125 - 2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*R*G/(K*K) + 4*t133/(K*K*K) */
    const double t137 = t29*t105; /* (s*v_tau*R*I1 - gamma3*R*G)*s*G*R*I3 */
    const double t138 = t137/t23; /* (s*v_tau*R*I1 - gamma3*R*G)*s*G*R*I3/(I1*K*K) */
    const double t139 = t136 - t138; /* t136 - (s*v_tau*R*I1 - gamma3*R*G)*s*G*R*I3/(I1*K*K) */
    const double t140 = x[3]*t11; /* v_tau*R*I3 */
    const double t141 = x[4]*t140; /* s*v_tau*R*I3 */
    const double t142 = t14*t141; /* (s*R*G + v_tau*gamma3*R*I3)*s*v_tau*R*I3 */
    const double t143 = t142/t17; /* (s*R*G + v_tau*gamma3*R*I3)*s*v_tau*R*I3/(K*K) */
    const double t144 = t139 - t143; /* t136 - (s*v_tau*R*I1 - gamma3*R*G)*s*G*R*I3/(I1*K*K) - (s*R*G + v_tau*gamma3*R*I3)*s*v_tau*R*I3/(K*K) */
    const double t145 = t0*t5; /* s*s*R*R*I3 */
    const double t146 = t14*t145; /* (s*R*G + v_tau*gamma3*R*I3)*s*s*R*R*I3 */
    const double t147 = t29*t146; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*R*G + v_tau*gamma3*R*I3)*s*s*R*R*I3 */
    const double t148 = t147/t83; /* t147/(K*K*K) */
    const double t149 = 4.0*t148; /* 4*t147/(K*K*K) */
    const double t150 = t144 + t149; /* t144 + 4*t147/(K*K*K) */
    const double t151 = t11*x[1]; /* R*I3*v_nu */
    const double t152 = x[3]*t151; /* v_tau*R*I3*v_nu */
    const double t153 = t152/t8; /* v_tau*R*I3*v_nu/K */
    const double t154 = t25*t88; /* R*I1*I3*I3 */
    const double t155 = x[3]*t154; /* v_tau*R*I1*I3*I3 */
    const double t156 = t40*t155; /* V*v_tau*R*I1*I3*I3 */
    const double t157 = t156/t38; /* V*v_tau*R*I1*I3*I3/(K*Theta) */
    const double t158 = t157 - t153; /* V*v_tau*R*I1*I3*I3/(K*Theta) - v_tau*R*I3*v_nu/K */
    const double t159 = x[1]*t60; /* v_nu*R*R*I3*gamma3 */
    const double t160 = t14*t159; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu*R*R*I3*gamma3 */
    const double t161 = t160/t17; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu*R*R*I3*gamma3/(K*K) */
    const double t162 = 2.0*t161; /* 2*(s*R*G + v_tau*gamma3*R*I3)*v_nu*R*R*I3*gamma3/(K*K) */
    const double t163 = t158 + t162; /* V*v_tau*R*I1*I3*I3/(K*Theta) - v_tau*R*I3*v_nu/K + 2*(s*R*G + v_tau*gamma3*R*I3)*v_nu*R*R*I3*gamma3/(K*K) */
    const double t164 = t3*t88; /* R*R*I1*I3*I3 */
    const double t165 = x[0]*t164; /* gamma3*R*R*I1*I3*I3 */
    const double t166 = t17*t37; /* K*K*Theta */
    const double t167 = t40*t165; /* V*gamma3*R*R*I1*I3*I3 */
    const double t168 = t14*t167; /* (s*R*G + v_tau*gamma3*R*I3)*V*gamma3*R*R*I1*I3*I3 */
    const double t169 = t168/t166; /* (s*R*G + v_tau*gamma3*R*I3)*V*gamma3*R*R*I1*I3*I3/(K*K*Theta) */
    const double t170 = 2.0*t169; /* 2*t169 */
    const double t171 = t163 - t170; /* t163 - 2*t169 */
    const double t172 = t2*p[0]; /* R*R*m */
    const double t173 = p[3]*t172; /* I1*R*R*m */
    const double t174 = t88*t173; /* I3*I3*I1*R*R*m */
    const double t175 = x[0]*t174; /* gamma3*I3*I3*I1*R*R*m */
    const double t176 = t37*t37; /* Theta*Theta */
    const double t177 = t8*t176; /* K*Theta*Theta */
    const double t178 = t40*t175; /* V*gamma3*I3*I3*I1*R*R*m */
    const double t179 = t14*t178; /* (s*R*G + v_tau*gamma3*R*I3)*V*gamma3*I3*I3*I1*R*R*m */
    const double t180 = t179/t177; /* (s*R*G + v_tau*gamma3*R*I3)*V*gamma3*I3*I3*I1*R*R*m/(K*Theta*Theta) */
    const double t181 = 2.0*t180; /* 2*t180 */
    const double t182 = t171 - t181; /* t163 - 2*t169 - 2*t180 */
    const double t183 = x[2]*t11; /* omega_tau*R*I3 */
    const double t184 = x[4]*t183; /* s*omega_tau*R*I3 */
    const double t185 = p[8]*t184; /* (I1 - I3)*s*omega_tau*R*I3 */
    const double t186 = t29*t185; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*omega_tau*R*I3 */
    const double t187 = t186/t38; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*omega_tau*R*I3/(K*Theta) */
    const double t188 = t182 - t187; /* t163 - 2*t169 - 2*t180 - t187 */
    const double t189 = p[1]*t2; /* R*R*R */
    const double t190 = t88*t189; /* I3*I3*R*R*R */
    const double t191 = t6*t190; /* gamma3*gamma3*I3*I3*R*R*R */
    const double t192 = x[2]*t191; /* omega_tau*gamma3*gamma3*I3*I3*R*R*R */
    const double t193 = x[4]*t192; /* s*omega_tau*gamma3*gamma3*I3*I3*R*R*R */
    const double t194 = p[8]*t193; /* (I1 - I3)*s*omega_tau*gamma3*gamma3*I3*I3*R*R*R */
    const double t195 = t29*t194; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*omega_tau*gamma3*gamma3*I3*I3*R*R*R */
    const double t196 = t195/t166; /* t195/(K*K*Theta) */
    const double t197 = 2.0*t196; /* 2*t195/(K*K*Theta) */
    const double t198 = t188 + t197; /* t163 - 2*t169 - 2*t180 - t187 + 2*t195/(K*K*Theta) */
    const double t199 = p[0]*t189; /* m*R*R*R */
    const double t200 = t88*t199; /* I3*I3*m*R*R*R */
    const double t201 = t6*t200; /* gamma3*gamma3*I3*I3*m*R*R*R */
    const double t202 = x[2]*t201; /* omega_tau*gamma3*gamma3*I3*I3*m*R*R*R */
    const double t203 = x[4]*t202; /* s*omega_tau*gamma3*gamma3*I3*I3*m*R*R*R */
    const double t204 = p[8]*t203; /* (I1 - I3)*s*omega_tau*gamma3*gamma3*I3*I3*m*R*R*R */
    const double t205 = t29*t204; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*omega_tau*gamma3*gamma3*I3*I3*m*R*R*R */
    const double t206 = t205/t177; /* t205/(K*Theta*Theta) */
    const double t207 = 2.0*t206; /* 2*t205/(K*Theta*Theta) */
    const double t208 = t198 + t207; /* t163 - 2*t169 - 2*t180 - t187 + 2*t195/(K*K*Theta) + 2*t205/(K*Theta*Theta) */
    const double t209 = t5*p[6]; /* R*R*I3*G */
    const double t210 = x[0]*t209; /* gamma3*R*R*I3*G */
    const double t211 = x[2]*t210; /* omega_tau*gamma3*R*R*I3*G */
    const double t212 = x[4]*t211; /* s*omega_tau*gamma3*R*R*I3*G */
    const double t213 = p[8]*t212; /* (I1 - I3)*s*omega_tau*gamma3*R*R*I3*G */
    const double t214 = t213/t38; /* (I1 - I3)*s*omega_tau*gamma3*R*R*I3*G/(K*Theta) */
    const double t215 = t208 + t214; /* t208 + (I1 - I3)*s*omega_tau*gamma3*R*R*I3*G/(K*Theta) */
    const double t216 = t14*t35; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3 */
    const double t217 = t216/t38; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3/(K*Theta) */
    const double t218 = t217 - t66; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3/(K*Theta) - (s*R*G + v_tau*gamma3*R*I3)/K */
    const double t219 = p[4]*t25; /* I3*R*I1 */
    const double t220 = t14*t219; /* (s*R*G + v_tau*gamma3*R*I3)*I3*R*I1 */
    const double t221 = t220/t38; /* (s*R*G + v_tau*gamma3*R*I3)*I3*R*I1/(K*Theta) */
    const double t222 = x[4]*t12; /* s*gamma3*R*I3 */
    const double t223 = p[8]*t222; /* (I1 - I3)*s*gamma3*R*I3 */
    const double t224 = t29*t223; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*gamma3*R*I3 */
    const double t225 = t224/t38; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*gamma3*R*I3/(K*Theta) */
    const double t226 = t221 - t225; /* (s*R*G + v_tau*gamma3*R*I3)*I3*R*I1/(K*Theta) - t225 */
    const double t227 = t12*x[1]; /* gamma3*R*I3*v_nu */
    const double t228 = t227/t8; /* gamma3*R*I3*v_nu/K */
    const double t229 = x[0]*t154; /* gamma3*R*I1*I3*I3 */
    const double t230 = t40*t229; /* V*gamma3*R*I1*I3*I3 */
    const double t231 = t230/t38; /* V*gamma3*R*I1*I3*I3/(K*Theta) */
    const double t232 = t231 - t228; /* V*gamma3*R*I1*I3*I3/(K*Theta) - gamma3*R*I3*v_nu/K */
    const double t233 = t3*p[4]; /* R*R*I1*I3 */
    const double t234 = x[0]*t233; /* gamma3*R*R*I1*I3 */
    const double t235 = x[2]*t234; /* omega_tau*gamma3*R*R*I1*I3 */
    const double t236 = t0*t235; /* s*s*omega_tau*gamma3*R*R*I1*I3 */
    const double t237 = p[8]*t236; /* (I1 - I3)*s*s*omega_tau*gamma3*R*R*I1*I3 */
    const double t238 = t237/t38; /* (I1 - I3)*s*s*omega_tau*gamma3*R*R*I1*I3/(K*Theta) */
    const double t239 = t232 - t238; /* V*gamma3*R*I1*I3*I3/(K*Theta) - gamma3*R*I3*v_nu/K - (I1 - I3)*s*s*omega_tau*gamma3*R*R*I1*I3/(K*Theta) */
    const double t240 = t9*x[1]; /* R*G*v_nu */
    const double t241 = t240/t8; /* R*G*v_nu/K */
    const double t242 = p[6]*t219; /* G*I3*R*I1 */
    const double t243 = t40*t242; /* V*G*I3*R*I1 */
    const double t244 = t243/t38; /* V*G*I3*R*I1/(K*Theta) */
    const double t245 = t244 - t241; /* V*G*I3*R*I1/(K*Theta) - R*G*v_nu/K */
    const double t246 = t45*p[8]; /* omega_tau*gamma3*R*I3*(I1 - I3) */
    const double t247 = t29*t246; /* (s*v_tau*R*I1 - gamma3*R*G)*omega_tau*gamma3*R*I3*(I1 - I3) */
    const double t248 = t247/t38; /* (s*v_tau*R*I1 - gamma3*R*G)*omega_tau*gamma3*R*I3*(I1 - I3)/(K*Theta) */
    const double t249 = t245 - t248; /* V*G*I3*R*I1/(K*Theta) - R*G*v_nu/K - t248 */
    const double t250 = t3*x[1]; /* R*R*I1*v_nu */
    const double t251 = x[4]*t250; /* s*R*R*I1*v_nu */
    const double t252 = t14*t251; /* (s*R*G + v_tau*gamma3*R*I3)*s*R*R*I1*v_nu */
    const double t253 = t252/t17; /* (s*R*G + v_tau*gamma3*R*I3)*s*R*R*I1*v_nu/(K*K) */
    const double t254 = 2.0*t253; /* 2*(s*R*G + v_tau*gamma3*R*I3)*s*R*R*I1*v_nu/(K*K) */
    const double t255 = t249 + t254; /* V*G*I3*R*I1/(K*Theta) - R*G*v_nu/K - t248 + 2*(s*R*G + v_tau*gamma3*R*I3)*s*R*R*I1*v_nu/(K*K) */
    const double t256 = p[3]*p[3]; /* I1*I1 */
    const double t257 = t2*t256; /* R*R*I1*I1 */
    const double t258 = p[4]*t257; /* I3*R*R*I1*I1 */
    const double t259 = x[4]*t258; /* s*I3*R*R*I1*I1 */
    const double t260 = t40*t259; /* V*s*I3*R*R*I1*I1 */
    const double t261 = t14*t260; /* (s*R*G + v_tau*gamma3*R*I3)*V*s*I3*R*R*I1*I1 */
    const double t262 = t261/t166; /* (s*R*G + v_tau*gamma3*R*I3)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t263 = 2.0*t262; /* 2*(s*R*G + v_tau*gamma3*R*I3)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t264 = t255 - t263; /* t255 - 2*(s*R*G + v_tau*gamma3*R*I3)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t265 = t172*t256; /* R*R*m*I1*I1 */
    const double t266 = p[4]*t265; /* I3*R*R*m*I1*I1 */
    const double t267 = x[4]*t266; /* s*I3*R*R*m*I1*I1 */
    const double t268 = t40*t267; /* V*s*I3*R*R*m*I1*I1 */
    const double t269 = t14*t268; /* (s*R*G + v_tau*gamma3*R*I3)*V*s*I3*R*R*m*I1*I1 */
    const double t270 = t269/t177; /* (s*R*G + v_tau*gamma3*R*I3)*V*s*I3*R*R*m*I1*I1/(K*Theta*Theta) */
    const double t271 = 2.0*t270; /* 2*t270 */
    const double t272 = t264 - t271; /* t264 - 2*t270 */
    const double t273 = x[3]*t235; /* v_tau*omega_tau*gamma3*R*R*I1*I3 */
    const double t274 = x[4]*t273; /* s*v_tau*omega_tau*gamma3*R*R*I1*I3 */
    const double t275 = p[8]*t274; /* (I1 - I3)*s*v_tau*omega_tau*gamma3*R*R*I1*I3 */
    const double t276 = t275/t38; /* (I1 - I3)*s*v_tau*omega_tau*gamma3*R*R*I1*I3/(K*Theta) */
    const double t277 = t272 - t276; /* t264 - 2*t270 - (I1 - I3)*s*v_tau*omega_tau*gamma3*R*R*I1*I3/(K*Theta) */
    const double t278 = p[3]*t189; /* I1*R*R*R */
    const double t279 = p[4]*t278; /* I3*I1*R*R*R */
    const double t280 = x[0]*t279; /* gamma3*I3*I1*R*R*R */
    const double t281 = x[2]*t280; /* omega_tau*gamma3*I3*I1*R*R*R */
    const double t282 = t0*t281; /* s*s*omega_tau*gamma3*I3*I1*R*R*R */
    const double t283 = p[8]*t282; /* (I1 - I3)*s*s*omega_tau*gamma3*I3*I1*R*R*R */
    const double t284 = t29*t283; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*s*omega_tau*gamma3*I3*I1*R*R*R */
    const double t285 = t284/t166; /* t284/(K*K*Theta) */
    const double t286 = 2.0*t285; /* 2*t284/(K*K*Theta) */
    const double t287 = t277 + t286; /* t277 + 2*t284/(K*K*Theta) */
    const double t288 = p[3]*t199; /* I1*m*R*R*R */
    const double t289 = p[4]*t288; /* I3*I1*m*R*R*R */
    const double t290 = x[0]*t289; /* gamma3*I3*I1*m*R*R*R */
    const double t291 = x[2]*t290; /* omega_tau*gamma3*I3*I1*m*R*R*R */
    const double t292 = t0*t291; /* s*s*omega_tau*gamma3*I3*I1*m*R*R*R */
    const double t293 = p[8]*t292; /* (I1 - I3)*s*s*omega_tau*gamma3*I3*I1*m*R*R*R */
    const double t294 = t29*t293; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*s*omega_tau*gamma3*I3*I1*m*R*R*R */
    const double t295 = t294/t177; /* t294/(K*Theta*Theta) */
    const double t296 = 2.0*t295; /* 2*t294/(K*Theta*Theta) */
    const double t297 = t287 + t296; /* t277 + 2*t284/(K*K*Theta) + 2*t294/(K*Theta*Theta) */
    const double t298 = x[2]*x[4]; /* omega_tau*s */
    const double t299 = -t298; /* -omega_tau*s */
    const double t300 = x[4]*x[0]; /* s*gamma3 */
    const double t301 = -t300; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t16;
    out[2] = t32;
    out[3] = t50;
    out[4] = t54;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t56;
    out[10] = t65;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t68;
    out[14] = t76;
    out[15] = t108;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t122;
    out[19] = t150;
    out[20] = t215;
    out[21] = t218;
    out[22] = t226;
    out[23] = t239;
    out[24] = t297;
    out[25] = t299;
    out[26] = 0.0;
    out[27] = t301;
    out[28] = 0.0;
    out[29] = t52;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = -t0; /* -gamma3*omega_tau */
    const double t2 = p[1]*p[4]; /* R*I3 */
    const double t3 = x[0]*t2; /* gamma3*R*I3 */
    const double t4 = t3*x[1]; /* gamma3*R*I3*v_nu */
    const double t5 = p[1]*p[1]; /* R*R */
    const double t6 = t5*p[3]; /* R*R*I1 */
    const double t7 = x[4]*x[4]; /* s*s */
    const double t8 = t6*t7; /* R*R*I1*s*s */
    const double t9 = p[4]*t5; /* I3*R*R */
    const double t10 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t11 = t9*t10; /* I3*R*R*gamma3*gamma3 */
    const double t12 = t8 + t11; /* K = R*R*I1*s*s + I3*R*R*gamma3*gamma3 */
    const double t13 = t4/t12; /* gamma3*R*I3*v_nu/K */
    const double t14 = t1 - t13; /* -gamma3*omega_tau - gamma3*R*I3*v_nu/K */
    const double t15 = p[1]*p[3]; /* R*I1 */
    const double t16 = p[4]*p[4]; /* I3*I3 */
    const double t17 = t15*t16; /* R*I1*I3*I3 */
    const double t18 = x[0]*t17; /* gamma3*R*I1*I3*I3 */
    const double t19 = t12*p[0]; /* K*m */
    const double t20 = t19 + p[7]; /* Theta = K*m + I1*I3 */
    const double t21 = t12*t20; /* K*Theta */
    const double t22 = x[2]*p[1]; /* omega_tau*R */
    const double t23 = x[1] + t22; /* V = v_nu + omega_tau*R */
    const double t24 = t18*t23; /* gamma3*R*I1*I3*I3*V */
    const double t25 = t24/t21; /* gamma3*R*I1*I3*I3*V/(K*Theta) */
    const double t26 = t14 + t25; /* -gamma3*omega_tau - gamma3*R*I3*v_nu/K + gamma3*R*I1*I3*I3*V/(K*Theta) */
    const double t27 = p[4]*t6; /* I3*R*R*I1 */
    const double t28 = x[0]*t27; /* gamma3*I3*R*R*I1 */
    const double t29 = x[2]*t28; /* omega_tau*gamma3*I3*R*R*I1 */
    const double t30 = t7*t29; /* s*s*omega_tau*gamma3*I3*R*R*I1 */
    const double t31 = t30*p[8]; /* s*s*omega_tau*gamma3*I3*R*R*I1*(I1 - I3) */
    const double t32 = t31/t21; /* s*s*omega_tau*gamma3*I3*R*R*I1*(I1 - I3)/(K*Theta) */
    const double t33 = t26 - t32; /* t26 - s*s*omega_tau*gamma3*I3*R*R*I1*(I1 - I3)/(K*Theta) */
    out[0] = t33;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[0]*t0; /* m*v_nu*v_nu */
    const double t2 = t1*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t3 = x[3]*x[3]; /* v_tau*v_tau */
    const double t4 = p[1]*p[1]; /* R*R */
    const double t5 = t4*p[3]; /* R*R*I1 */
    const double t6 = x[4]*x[4]; /* s*s */
    const double t7 = t5*t6; /* R*R*I1*s*s */
    const double t8 = t4*p[4]; /* R*R*I3 */
    const double t9 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t10 = t8*t9; /* R*R*I3*gamma3*gamma3 */
    const double t11 = t7 + t10; /* K = R*R*I1*s*s + R*R*I3*gamma3*gamma3 */
    const double t12 = p[0]*t11; /* m*K */
    const double t13 = t12 + p[7]; /* Theta = m*K + I1*I3 */
    const double t14 = t3*t13; /* v_tau*v_tau*Theta */
    const double t15 = t14/t11; /* v_tau*v_tau*Theta/K */
    const double t16 = (1.0 / 2.0)*t15; /* 1/2*v_tau*v_tau*Theta/K */
    const double t17 = t2 + t16; /* m*v_nu*v_nu*1/2 + 1/2*v_tau*v_tau*Theta/K */
    const double t18 = p[6]*p[6]; /* G*G */
    const double t19 = t18/t11; /* G*G/K */
    const double t20 = (1.0 / 2.0)*t19; /* 1/2*G*G/K */
    const double t21 = t17 + t20; /* m*v_nu*v_nu*1/2 + 1/2*v_tau*v_tau*Theta/K + 1/2*G*G/K */
    const double t22 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t23 = p[3]*t22; /* I1*omega_tau*omega_tau */
    const double t24 = (1.0 / 2.0)*t23; /* 1/2*I1*omega_tau*omega_tau */
    const double t25 = t21 + t24; /* m*v_nu*v_nu*1/2 + 1/2*v_tau*v_tau*Theta/K + 1/2*G*G/K + 1/2*I1*omega_tau*omega_tau */
    const double t26 = p[3]*p[3]; /* I1*I1 */
    const double t27 = p[0]*t26; /* m*I1*I1 */
    const double t28 = p[1]*x[2]; /* R*omega_tau */
    const double t29 = x[1] + t28; /* v_nu + R*omega_tau */
    const double t30 = t29*t29; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t31 = t27*t30; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t32 = t11*t11; /* K*K */
    const double t33 = t13*p[8]; /* Theta*(I1 - I3) */
    const double t34 = p[1]*p[3]; /* R*I1 */
    const double t35 = x[3]*t34; /* v_tau*R*I1 */
    const double t36 = x[4]*t35; /* s*v_tau*R*I1 */
    const double t37 = p[1]*p[6]; /* R*G */
    const double t38 = x[0]*t37; /* gamma3*R*G */
    const double t39 = t36 - t38; /* s*v_tau*R*I1 - gamma3*R*G */
    const double t40 = t39*t39; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t41 = t33*t40; /* Theta*(I1 - I3)*(s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t42 = t41/t32; /* t41/(K*K) */
    const double t43 = t31 + t42; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) + t41/(K*K) */
    out[0] = t25;
    out[1] = t43;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[1]; /* R*R */
    const double t1 = t0*p[4]; /* R*R*I3 */
    const double t2 = t1*x[0]; /* R*R*I3*gamma3 */
    const double t3 = x[3]*x[3]; /* v_tau*v_tau */
    const double t4 = t2*t3; /* R*R*I3*gamma3*v_tau*v_tau */
    const double t5 = t0*p[3]; /* R*R*I1 */
    const double t6 = x[4]*x[4]; /* s*s */
    const double t7 = t5*t6; /* R*R*I1*s*s */
    const double t8 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t9 = t1*t8; /* R*R*I3*gamma3*gamma3 */
    const double t10 = t7 + t9; /* K = R*R*I1*s*s + R*R*I3*gamma3*gamma3 */
    const double t11 = t10*t10; /* K*K */
    const double t12 = t10*p[0]; /* K*m */
    const double t13 = t12 + p[7]; /* Theta = K*m + I1*I3 */
    const double t14 = t4*t13; /* R*R*I3*gamma3*v_tau*v_tau*Theta */
    const double t15 = t14/t11; /* R*R*I3*gamma3*v_tau*v_tau*Theta/(K*K) */
    const double t16 = t0*p[0]; /* R*R*m */
    const double t17 = p[4]*t16; /* I3*R*R*m */
    const double t18 = x[0]*t17; /* gamma3*I3*R*R*m */
    const double t19 = t3*t18; /* v_tau*v_tau*gamma3*I3*R*R*m */
    const double t20 = t19/t10; /* v_tau*v_tau*gamma3*I3*R*R*m/K */
    const double t21 = t20 - t15; /* v_tau*v_tau*gamma3*I3*R*R*m/K - R*R*I3*gamma3*v_tau*v_tau*Theta/(K*K) */
    const double t22 = p[6]*p[6]; /* G*G */
    const double t23 = t1*t22; /* R*R*I3*G*G */
    const double t24 = x[0]*t23; /* gamma3*R*R*I3*G*G */
    const double t25 = t24/t11; /* gamma3*R*R*I3*G*G/(K*K) */
    const double t26 = t21 - t25; /* t21 - gamma3*R*R*I3*G*G/(K*K) */
    const double t27 = p[0]*x[1]; /* m*v_nu */
    const double t28 = p[3]*x[2]; /* I1*omega_tau */
    const double t29 = x[3]*t13; /* v_tau*Theta */
    const double t30 = t29/t10; /* v_tau*Theta/K */
    const double t31 = t3*t5; /* v_tau*v_tau*R*R*I1 */
    const double t32 = x[4]*t31; /* s*v_tau*v_tau*R*R*I1 */
    const double t33 = t13*t32; /* Theta*s*v_tau*v_tau*R*R*I1 */
    const double t34 = t33/t11; /* Theta*s*v_tau*v_tau*R*R*I1/(K*K) */
    const double t35 = p[3]*t16; /* I1*R*R*m */
    const double t36 = t3*t35; /* v_tau*v_tau*I1*R*R*m */
    const double t37 = x[4]*t36; /* s*v_tau*v_tau*I1*R*R*m */
    const double t38 = t37/t10; /* s*v_tau*v_tau*I1*R*R*m/K */
    const double t39 = t38 - t34; /* s*v_tau*v_tau*I1*R*R*m/K - Theta*s*v_tau*v_tau*R*R*I1/(K*K) */
    const double t40 = t5*t22; /* R*R*I1*G*G */
    const double t41 = x[4]*t40; /* s*R*R*I1*G*G */
    const double t42 = t41/t11; /* s*R*R*I1*G*G/(K*K) */
    const double t43 = t39 - t42; /* s*v_tau*v_tau*I1*R*R*m/K - Theta*s*v_tau*v_tau*R*R*I1/(K*K) - s*R*R*I1*G*G/(K*K) */
    const double t44 = t10*t11; /* K*K*K */
    const double t45 = t2*t13; /* R*R*I3*gamma3*Theta */
    const double t46 = t45*p[8]; /* R*R*I3*gamma3*Theta*(I1 - I3) */
    const double t47 = p[1]*p[3]; /* R*I1 */
    const double t48 = x[3]*t47; /* v_tau*R*I1 */
    const double t49 = x[4]*t48; /* s*v_tau*R*I1 */
    const double t50 = p[1]*p[6]; /* R*G */
    const double t51 = x[0]*t50; /* gamma3*R*G */
    const double t52 = t49 - t51; /* s*v_tau*R*I1 - gamma3*R*G */
    const double t53 = t52*t52; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t54 = t46*t53; /* R*R*I3*gamma3*Theta*(I1 - I3)*(s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t55 = t54/t44; /* t54/(K*K*K) */
    const double t56 = t55*4.0; /* t54/(K*K*K)*4 */
    const double t57 = t18*p[8]; /* gamma3*I3*R*R*m*(I1 - I3) */
    const double t58 = t53*t57; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G)*gamma3*I3*R*R*m*(I1 - I3) */
    const double t59 = t58/t11; /* t58/(K*K) */
    const double t60 = t59*2.0; /* t58/(K*K)*2 */
    const double t61 = t60 - t56; /* t58/(K*K)*2 - t54/(K*K*K)*4 */
    const double t62 = t13*t50; /* Theta*R*G */
    const double t63 = p[8]*t62; /* (I1 - I3)*Theta*R*G */
    const double t64 = t52*t63; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*R*G */
    const double t65 = t64/t11; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*R*G/(K*K) */
    const double t66 = 2.0*t65; /* 2*(s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*R*G/(K*K) */
    const double t67 = t61 - t66; /* t58/(K*K)*2 - t54/(K*K*K)*4 - 2*(s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*R*G/(K*K) */
    const double t68 = p[0]*2.0; /* m*2 */
    const double t69 = p[3]*p[3]; /* I1*I1 */
    const double t70 = t68*t69; /* m*2*I1*I1 */
    const double t71 = p[1]*x[2]; /* R*omega_tau */
    const double t72 = x[1] + t71; /* v_nu + R*omega_tau */
    const double t73 = t70*t72; /* m*2*I1*I1*(v_nu + R*omega_tau) */
    const double t74 = p[1]*t68; /* R*m*2 */
    const double t75 = t69*t74; /* I1*I1*R*m*2 */
    const double t76 = t72*t75; /* (v_nu + R*omega_tau)*I1*I1*R*m*2 */
    const double t77 = p[1]*2.0; /* R*2 */
    const double t78 = p[3]*t77; /* I1*R*2 */
    const double t79 = x[4]*t78; /* s*I1*R*2 */
    const double t80 = t13*t79; /* Theta*s*I1*R*2 */
    const double t81 = p[8]*t80; /* (I1 - I3)*Theta*s*I1*R*2 */
    const double t82 = t52*t81; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*s*I1*R*2 */
    const double t83 = t82/t11; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*s*I1*R*2/(K*K) */
    const double t84 = t13*t48; /* Theta*v_tau*R*I1 */
    const double t85 = p[8]*t84; /* (I1 - I3)*Theta*v_tau*R*I1 */
    const double t86 = t52*t85; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*v_tau*R*I1 */
    const double t87 = t86/t11; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*v_tau*R*I1/(K*K) */
    const double t88 = 2.0*t87; /* 2*(s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*v_tau*R*I1/(K*K) */
    const double t89 = t5*x[4]; /* R*R*I1*s */
    const double t90 = t13*t89; /* Theta*R*R*I1*s */
    const double t91 = p[8]*t90; /* (I1 - I3)*Theta*R*R*I1*s */
    const double t92 = t53*t91; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*R*R*I1*s */
    const double t93 = t92/t44; /* t92/(K*K*K) */
    const double t94 = 4.0*t93; /* 4*t92/(K*K*K) */
    const double t95 = t88 - t94; /* t88 - 4*t92/(K*K*K) */
    const double t96 = x[4]*t35; /* s*I1*R*R*m */
    const double t97 = p[8]*t96; /* (I1 - I3)*s*I1*R*R*m */
    const double t98 = t53*t97; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*s*I1*R*R*m */
    const double t99 = t98/t11; /* t98/(K*K) */
    const double t100 = 2.0*t99; /* 2*t98/(K*K) */
    const double t101 = t95 + t100; /* t88 - 4*t92/(K*K*K) + 2*t98/(K*K) */
    out[0] = t26;
    out[1] = t27;
    out[2] = t28;
    out[3] = t30;
    out[4] = t43;
    out[5] = t67;
    out[6] = t73;
    out[7] = t76;
    out[8] = t83;
    out[9] = t101;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_v_tau = x[3];
    const double v_R = params[1];
    const double v_I1 = params[3];
    const double v_I3 = params[4];
    const double v_a3 = (0.0);
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_K = (v_R*v_R*v_I1*v_s*v_s + v_I3*v_b*v_b);
    const double v_G = params[6];
    const double complex v_omega_n = ((v_R*v_G*v_s + v_I3*v_v_tau*v_b)/v_K);
    out[1] = (v_s)*((v_v_tau*v_omega_n/v_s));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double complex v_omega3 = ((v_R*v_I1*v_v_tau*v_s - v_G*v_b)/v_K);
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_v_nu = x[1];
    const double complex v_Theta = (v_m*v_K + v_I1*v_I3);
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((-v_v_nu*v_omega_n/v_s)
        + (v_I1*v_I3*v_V*v_omega_n/(v_s*v_Theta))
        + (-v_I3*v_omega_tau*v_omega3*(v_R*v_gamma3*(v_I1 - v_I3) - v_I3*v_a3)/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0) },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_balanced_in_regular = {
    .model = "spherical_top_level",
    .variant = "balanced",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 9,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 10, 38, 0, 6, 0, 0, 10, 9 }, { 16, 71, 0, 6, 0, 0, 10, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .jacobian = { jacobian, 25, { 46, 187, 0, 45, 0, 0, 16, 25 }, { 91, 507, 0, 46, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 51, 200, 0, 51, 0, 0, 16, 30 }, { 104, 567, 0, 52, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .divergence = { divergence, 1, { 7, 24, 0, 3, 0, 0, 10, 8 }, { 8, 30, 0, 3, 0, 0, 10, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .integral_values = { integral_values, 2, { 8, 33, 0, 3, 0, 0, 12, 6 }, { 9, 35, 0, 3, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are" },
    .integral_gradients = { integral_gradients, 10, { 12, 76, 0, 14, 0, 0, 13, 13 }, { 26, 155, 0, 14, 0, 0, 13, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_balanced_in_regular_baseline,
        &jlt_batch_spherical_top_level_balanced_in_regular_avx2,
        &jlt_batch_spherical_top_level_balanced_in_regular_avx512,
    },
};
