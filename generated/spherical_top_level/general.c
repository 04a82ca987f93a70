/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Table:      spherical_top_level, SHA-256 10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 15   51    0    8    1    0     12   13   (110)
 *  jacobian            48  172    0   44    1    0     21   29   (567)
 *  rhs_jacobian        53  177    0   52    1    0     21   44   (653)
 *  divergence          12   34    0    5    1    0     12    9   (60)
 *  integral_values     9   26    0    2    1    0     13    5   (40)
 *  integral_gradients  10   34    0    4    1    0     15   12   (59)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_avx512;

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
    const double t2 = params[4]*params[5]; /* I3*a3 */
    const double t3 = params[1]*params[6]; /* R*G */
    const double t4 = params[0]*params[2]; /* m*g */
    const double t5 = params[5]*t4; /* a3*m*g */
    out[7] = t0;
    out[8] = t1;
    out[9] = t2;
    out[10] = t3;
    out[11] = t5;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[1]; /* R*R */
    const double t5 = t4*p[3]; /* R*R*I1 */
    const double t6 = t2*t2; /* s*s */
    const double t7 = t5*t6; /* R*R*I1*s*s */
    const double t8 = x[0]*p[1]; /* gamma3*R */
    const double t9 = p[5] + t8; /* b = a3 + gamma3*R */
    const double t10 = t9*t9; /* b*b */
    const double t11 = p[4]*t10; /* I3*b*b */
    const double t12 = t7 + t11; /* K = R*R*I1*s*s + I3*b*b */
    const double t13 = t2*t12; /* s*K */
    const double t14 = p[1]*p[6]; /* R*G */
    const double t15 = t2*t14; /* s*R*G */
    const double t16 = x[3]*p[4]; /* v_tau*I3 */
    const double t17 = t9*t16; /* b*v_tau*I3 */
    const double t18 = t15 + t17; /* s*R*G + b*v_tau*I3 */
    const double t19 = x[3]*t18; /* v_tau*(s*R*G + b*v_tau*I3) */
    const double t20 = t19/t13; /* v_tau*(s*R*G + b*v_tau*I3)/(s*K) */
    const double t21 = p[5]*p[5]; /* a3*a3 */
    const double t22 = p[0]*t21; /* m*a3*a3 */
    const double t23 = x[0]*t22; /* gamma3*m*a3*a3 */
    const double t24 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t25 = t23*t24; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t26 = t2*t25; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t27 = t6*t22; /* s*s*m*a3*a3 */
    const double t28 = p[3] + t27; /* D = I1 + s*s*m*a3*a3 */
    const double t29 = t26/t28; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t30 = p[0]*p[2]; /* m*g */
    const double t31 = p[5]*t30; /* a3*m*g */
    const double t32 = t2*t31; /* s*a3*m*g */
    const double t33 = t32/t28; /* s*a3*m*g/D */
    const double t34 = t29 - t33; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D */
    const double t35 = x[0]*p[3]; /* gamma3*I1 */
    const double t36 = t12*t12; /* K*K */
    const double t37 = t2*t36; /* s*K*K */
    const double t38 = t28*t37; /* D*s*K*K */
    const double t39 = t18*t18; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t40 = t35*t39; /* gamma3*I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t41 = t40/t38; /* gamma3*I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(D*s*K*K) */
    const double t42 = t34 - t41; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - t41 */
    const double t43 = t28*t36; /* D*K*K */
    const double t44 = p[4]*t18; /* I3*(s*R*G + b*v_tau*I3) */
    const double t45 = p[1]*p[3]; /* R*I1 */
    const double t46 = x[3]*t45; /* v_tau*R*I1 */
    const double t47 = t2*t46; /* s*v_tau*R*I1 */
    const double t48 = t9*p[6]; /* b*G */
    const double t49 = t47 - t48; /* s*v_tau*R*I1 - b*G */
    const double t50 = t44*t49; /* I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G) */
    const double t51 = t50/t43; /* I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G)/(D*K*K) */
    const double t52 = t42 - t51; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - t41 - I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G)/(D*K*K) */
    const double t53 = t18*x[1]; /* (s*R*G + b*v_tau*I3)*v_nu */
    const double t54 = t53/t13; /* (s*R*G + b*v_tau*I3)*v_nu/(s*K) */
    const double t55 = p[3]*p[4]; /* I1*I3 */
    const double t56 = t12*p[0]; /* K*m */
    const double t57 = t56 + p[7]; /* Theta = K*m + I1*I3 */
    const double t58 = t13*t57; /* s*K*Theta */
    const double t59 = x[0]*p[5]; /* gamma3*a3 */
    const double t60 = p[1] + t59; /* e = R + gamma3*a3 */
    const double t61 = x[2]*t60; /* omega_tau*e */
    const double t62 = x[1] + t61; /* V = v_nu + omega_tau*e */
    const double t63 = t55*t62; /* I1*I3*V */
    const double t64 = t18*t63; /* (s*R*G + b*v_tau*I3)*I1*I3*V */
    const double t65 = t64/t58; /* (s*R*G + b*v_tau*I3)*I1*I3*V/(s*K*Theta) */
    const double t66 = t65 - t54; /* (s*R*G + b*v_tau*I3)*I1*I3*V/(s*K*Theta) - (s*R*G + b*v_tau*I3)*v_nu/(s*K) */
    const double t67 = x[2]*p[4]; /* omega_tau*I3 */
    const double t68 = t12*t57; /* K*Theta */
    const double t69 = t49*t67; /* (s*v_tau*R*I1 - b*G)*omega_tau*I3 */
    const double t70 = t8*p[8]; /* gamma3*R*(I1 - I3) */
    const double t71 = t70 - p[9]; /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t72 = t69*t71; /* (s*v_tau*R*I1 - b*G)*omega_tau*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t73 = t72/t68; /* t72/(K*Theta) */
    const double t74 = t66 - t73; /* t66 - t72/(K*Theta) */
    out[0] = t3;
    out[1] = t20;
    out[2] = t52;
    out[3] = t74;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = -t4; /* -gamma3*omega_tau/s */
    const double t6 = p[1]*p[1]; /* R*R */
    const double t7 = t6*p[3]; /* R*R*I1 */
    const double t8 = t3*t3; /* s*s */
    const double t9 = t7*t8; /* R*R*I1*s*s */
    const double t10 = x[0]*p[1]; /* gamma3*R */
    const double t11 = p[5] + t10; /* b = a3 + gamma3*R */
    const double t12 = t11*t11; /* b*b */
    const double t13 = p[4]*t12; /* I3*b*b */
    const double t14 = t9 + t13; /* K = R*R*I1*s*s + I3*b*b */
    const double t15 = t14*t14; /* K*K */
    const double t16 = t3*t15; /* s*K*K */
    const double t17 = p[1]*p[6]; /* R*G */
    const double t18 = t3*t17; /* s*R*G */
    const double t19 = x[3]*p[4]; /* v_tau*I3 */
    const double t20 = t11*t19; /* b*v_tau*I3 */
    const double t21 = t18 + t20; /* s*R*G + b*v_tau*I3 */
    const double t22 = x[3]*t21; /* v_tau*(s*R*G + b*v_tau*I3) */
    const double t23 = x[0]*t7; /* gamma3*R*R*I1 */
    const double t24 = t23*2.0; /* gamma3*R*R*I1*2 */
    const double t25 = p[1]*p[4]; /* R*I3 */
    const double t26 = t11*t25; /* b*R*I3 */
    const double t27 = 2.0*t26; /* 2*b*R*I3 */
    const double t28 = t27 - t24; /* d(K)/d(gamma3) = 2*b*R*I3 - gamma3*R*R*I1*2 */
    const double t29 = t22*t28; /* v_tau*(s*R*G + b*v_tau*I3)*d(K)/d(gamma3) */
    const double t30 = t29/t16; /* v_tau*(s*R*G + b*v_tau*I3)*d(K)/d(gamma3)/(s*K*K) */
    const double t31 = x[0]*x[3]; /* gamma3*v_tau */
    const double t32 = t3*t8; /* s*s*s */
    const double t33 = t14*t32; /* K*s*s*s */
    const double t34 = t21*t31; /* (s*R*G + b*v_tau*I3)*gamma3*v_tau */
    const double t35 = t34/t33; /* (s*R*G + b*v_tau*I3)*gamma3*v_tau/(K*s*s*s) */
    const double t36 = t35 - t30; /* (s*R*G + b*v_tau*I3)*gamma3*v_tau/(K*s*s*s) - v_tau*(s*R*G + b*v_tau*I3)*d(K)/d(gamma3)/(s*K*K) */
    const double t37 = t3*t14; /* s*K */
    const double t38 = x[0]*t17; /* gamma3*R*G */
    const double t39 = t38/t3; /* gamma3*R*G/s */
    const double t40 = x[3]*t25; /* v_tau*R*I3 */
    const double t41 = t39 - t40; /* gamma3*R*G/s - v_tau*R*I3 */
    const double t42 = x[3]*t41; /* v_tau*(gamma3*R*G/s - v_tau*R*I3) */
    const double t43 = t42/t37; /* v_tau*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t44 = t36 - t43; /* t36 - v_tau*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t45 = t21/t37; /* (s*R*G + b*v_tau*I3)/(s*K) */
    const double t46 = t20/t37; /* b*v_tau*I3/(s*K) */
    const double t47 = t45 + t46; /* (s*R*G + b*v_tau*I3)/(s*K) + b*v_tau*I3/(s*K) */
    const double t48 = p[5]*p[5]; /* a3*a3 */
    const double t49 = p[0]*t48; /* m*a3*a3 */
    const double t50 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t51 = t49*t50; /* m*a3*a3*omega_tau*omega_tau */
    const double t52 = t3*t51; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t53 = t8*t49; /* s*s*m*a3*a3 */
    const double t54 = p[3] + t53; /* D = I1 + s*s*m*a3*a3 */
    const double t55 = t52/t54; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t56 = t1*t49; /* gamma3*gamma3*m*a3*a3 */
    const double t57 = t50*t56; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t58 = t3*t54; /* s*D */
    const double t59 = t57/t58; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t60 = t55 - t59; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t61 = p[0]*p[0]; /* m*m */
    const double t62 = t48*t48; /* a3*a3*a3*a3 */
    const double t63 = t61*t62; /* m*m*a3*a3*a3*a3 */
    const double t64 = t1*t63; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t65 = t50*t64; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t66 = t3*t65; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t67 = t54*t54; /* D*D */
    const double t68 = t66/t67; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t69 = 2.0*t68; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t70 = t60 + t69; /* t60 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t71 = p[0]*p[2]; /* m*g */
    const double t72 = p[5]*t71; /* a3*m*g */
    const double t73 = x[0]*t72; /* gamma3*a3*m*g */
    const double t74 = t73/t58; /* gamma3*a3*m*g/(s*D) */
    const double t75 = t70 + t74; /* t70 + gamma3*a3*m*g/(s*D) */
    const double t76 = t61*p[2]; /* m*m*g */
    const double t77 = p[5]*t48; /* a3*a3*a3 */
    const double t78 = t76*t77; /* m*m*g*a3*a3*a3 */
    const double t79 = x[0]*t78; /* gamma3*m*m*g*a3*a3*a3 */
    const double t80 = t3*t79; /* s*gamma3*m*m*g*a3*a3*a3 */
    const double t81 = t80/t67; /* s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t82 = 2.0*t81; /* 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t83 = t75 - t82; /* t70 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t84 = t16*t54; /* s*K*K*D */
    const double t85 = t21*t21; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t86 = p[3]*t85; /* I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t87 = t86/t84; /* I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(s*K*K*D) */
    const double t88 = t83 - t87; /* t70 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) - I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(s*K*K*D) */
    const double t89 = x[0]*p[3]; /* gamma3*I1 */
    const double t90 = t14*t15; /* K*K*K */
    const double t91 = t3*t90; /* s*K*K*K */
    const double t92 = t54*t91; /* D*s*K*K*K */
    const double t93 = t85*t89; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*gamma3*I1 */
    const double t94 = t28*t93; /* d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*gamma3*I1 */
    const double t95 = t94/t92; /* t94/(D*s*K*K*K) */
    const double t96 = 2.0*t95; /* 2*t94/(D*s*K*K*K) */
    const double t97 = t88 + t96; /* t88 + 2*t94/(D*s*K*K*K) */
    const double t98 = t1*p[3]; /* gamma3*gamma3*I1 */
    const double t99 = t15*t32; /* K*K*s*s*s */
    const double t100 = t54*t99; /* D*K*K*s*s*s */
    const double t101 = t85*t98; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*gamma3*gamma3*I1 */
    const double t102 = t101/t100; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*gamma3*gamma3*I1/(D*K*K*s*s*s) */
    const double t103 = t97 - t102; /* t88 + 2*t94/(D*s*K*K*K) - t102 */
    const double t104 = p[3]*p[0]; /* I1*m */
    const double t105 = t48*t104; /* a3*a3*I1*m */
    const double t106 = t1*t105; /* gamma3*gamma3*a3*a3*I1*m */
    const double t107 = t16*t67; /* s*K*K*D*D */
    const double t108 = t85*t106; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*gamma3*gamma3*a3*a3*I1*m */
    const double t109 = t108/t107; /* t108/(s*K*K*D*D) */
    const double t110 = 2.0*t109; /* 2*t108/(s*K*K*D*D) */
    const double t111 = t103 - t110; /* t88 + 2*t94/(D*s*K*K*K) - t102 - 2*t108/(s*K*K*D*D) */
    const double t112 = t21*t89; /* (s*R*G + b*v_tau*I3)*gamma3*I1 */
    const double t113 = t41*t112; /* (gamma3*R*G/s - v_tau*R*I3)*(s*R*G + b*v_tau*I3)*gamma3*I1 */
    const double t114 = t113/t84; /* (gamma3*R*G/s - v_tau*R*I3)*(s*R*G + b*v_tau*I3)*gamma3*I1/(s*K*K*D) */
    const double t115 = 2.0*t114; /* 2*t114 */
    const double t116 = t111 + t115; /* t88 + 2*t94/(D*s*K*K*K) - t102 - 2*t108/(s*K*K*D*D) + 2*t114 */
    const double t117 = t54*t90; /* D*K*K*K */
    const double t118 = p[4]*t21; /* I3*(s*R*G + b*v_tau*I3) */
    const double t119 = p[1]*p[3]; /* R*I1 */
    const double t120 = x[3]*t119; /* v_tau*R*I1 */
    const double t121 = t3*t120; /* s*v_tau*R*I1 */
    const double t122 = t11*p[6]; /* b*G */
    const double t123 = t121 - t122; /* s*v_tau*R*I1 - b*G */
    const double t124 = t118*t123; /* I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G) */
    const double t125 = t28*t124; /* d(K)/d(gamma3)*I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G) */
    const double t126 = t125/t117; /* d(K)/d(gamma3)*I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G)/(D*K*K*K) */
    const double t127 = 2.0*t126; /* 2*t126 */
    const double t128 = t116 + t127; /* t88 + 2*t94/(D*s*K*K*K) - t102 - 2*t108/(s*K*K*D*D) + 2*t114 + 2*t126 */
    const double t129 = p[4]*p[0]; /* I3*m */
    const double t130 = t48*t129; /* a3*a3*I3*m */
    const double t131 = x[0]*t130; /* gamma3*a3*a3*I3*m */
    const double t132 = t15*t67; /* K*K*D*D */
    const double t133 = t21*t131; /* (s*R*G + b*v_tau*I3)*gamma3*a3*a3*I3*m */
    const double t134 = t123*t133; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*v_tau*I3)*gamma3*a3*a3*I3*m */
    const double t135 = t134/t132; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*v_tau*I3)*gamma3*a3*a3*I3*m/(K*K*D*D) */
    const double t136 = 2.0*t135; /* 2*t135 */
    const double t137 = t128 - t136; /* t128 - 2*t135 */
    const double t138 = t15*t54; /* K*K*D */
    const double t139 = p[4]*t123; /* I3*(s*v_tau*R*I1 - b*G) */
    const double t140 = t41*t139; /* (gamma3*R*G/s - v_tau*R*I3)*I3*(s*v_tau*R*I1 - b*G) */
    const double t141 = t140/t138; /* (gamma3*R*G/s - v_tau*R*I3)*I3*(s*v_tau*R*I1 - b*G)/(K*K*D) */
    const double t142 = t137 + t141; /* t128 - 2*t135 + (gamma3*R*G/s - v_tau*R*I3)*I3*(s*v_tau*R*I1 - b*G)/(K*K*D) */
    const double t143 = x[0]*t119; /* gamma3*R*I1 */
    const double t144 = x[3]*t143; /* v_tau*gamma3*R*I1 */
    const double t145 = t144/t3; /* v_tau*gamma3*R*I1/s */
    const double t146 = p[10] + t145; /* R*G + v_tau*gamma3*R*I1/s */
    const double t147 = t118*t146; /* I3*(s*R*G + b*v_tau*I3)*(R*G + v_tau*gamma3*R*I1/s) */
    const double t148 = t147/t138; /* I3*(s*R*G + b*v_tau*I3)*(R*G + v_tau*gamma3*R*I1/s)/(K*K*D) */
    const double t149 = t142 + t148; /* t142 + I3*(s*R*G + b*v_tau*I3)*(R*G + v_tau*gamma3*R*I1/s)/(K*K*D) */
    const double t150 = 2.0*p[0]; /* 2*m */
    const double t151 = t48*t150; /* a3*a3*2*m */
    const double t152 = x[0]*t151; /* gamma3*a3*a3*2*m */
    const double t153 = x[2]*t152; /* omega_tau*gamma3*a3*a3*2*m */
    const double t154 = t3*t153; /* s*omega_tau*gamma3*a3*a3*2*m */
    const double t155 = t154/t54; /* s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t156 = p[3]*p[4]; /* I1*I3 */
    const double t157 = x[0]*t156; /* gamma3*I1*I3 */
    const double t158 = t11*t157; /* b*gamma3*I1*I3 */
    const double t159 = t21*t158; /* (s*R*G + b*v_tau*I3)*b*gamma3*I1*I3 */
    const double t160 = t159/t84; /* (s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(s*K*K*D) */
    const double t161 = 2.0*t160; /* 2*(s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(s*K*K*D) */
    const double t162 = -t161; /* -2*(s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(s*K*K*D) */
    const double t163 = p[4]*p[4]; /* I3*I3 */
    const double t164 = t11*t163; /* b*I3*I3 */
    const double t165 = t123*t164; /* (s*v_tau*R*I1 - b*G)*b*I3*I3 */
    const double t166 = t165/t138; /* (s*v_tau*R*I1 - b*G)*b*I3*I3/(K*K*D) */
    const double t167 = t162 - t166; /* -2*(s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(s*K*K*D) - (s*v_tau*R*I1 - b*G)*b*I3*I3/(K*K*D) */
    const double t168 = p[4]*t119; /* I3*R*I1 */
    const double t169 = t3*t168; /* s*I3*R*I1 */
    const double t170 = t21*t169; /* (s*R*G + b*v_tau*I3)*s*I3*R*I1 */
    const double t171 = t170/t138; /* (s*R*G + b*v_tau*I3)*s*I3*R*I1/(K*K*D) */
    const double t172 = t167 - t171; /* t167 - (s*R*G + b*v_tau*I3)*s*I3*R*I1/(K*K*D) */
    const double t173 = t21*x[1]; /* (s*R*G + b*v_tau*I3)*v_nu */
    const double t174 = t28*t173; /* d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*v_nu */
    const double t175 = t174/t16; /* d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*v_nu/(s*K*K) */
    const double t176 = x[0]*x[1]; /* gamma3*v_nu */
    const double t177 = t21*t176; /* (s*R*G + b*v_tau*I3)*gamma3*v_nu */
    const double t178 = t177/t33; /* (s*R*G + b*v_tau*I3)*gamma3*v_nu/(K*s*s*s) */
    const double t179 = t175 - t178; /* d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*v_nu/(s*K*K) - (s*R*G + b*v_tau*I3)*gamma3*v_nu/(K*s*s*s) */
    const double t180 = t41*x[1]; /* (gamma3*R*G/s - v_tau*R*I3)*v_nu */
    const double t181 = t180/t37; /* (gamma3*R*G/s - v_tau*R*I3)*v_nu/(s*K) */
    const double t182 = t179 + t181; /* t179 + (gamma3*R*G/s - v_tau*R*I3)*v_nu/(s*K) */
    const double t183 = t14*p[0]; /* K*m */
    const double t184 = t183 + p[7]; /* Theta = K*m + I1*I3 */
    const double t185 = t16*t184; /* s*K*K*Theta */
    const double t186 = x[0]*p[5]; /* gamma3*a3 */
    const double t187 = p[1] + t186; /* e = R + gamma3*a3 */
    const double t188 = x[2]*t187; /* omega_tau*e */
    const double t189 = x[1] + t188; /* V = v_nu + omega_tau*e */
    const double t190 = t156*t189; /* I1*I3*V */
    const double t191 = t21*t190; /* (s*R*G + b*v_tau*I3)*I1*I3*V */
    const double t192 = t28*t191; /* d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*I1*I3*V */
    const double t193 = t192/t185; /* d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*I1*I3*V/(s*K*K*Theta) */
    const double t194 = t182 - t193; /* t179 + (gamma3*R*G/s - v_tau*R*I3)*v_nu/(s*K) - d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*I1*I3*V/(s*K*K*Theta) */
    const double t195 = p[4]*t104; /* I3*I1*m */
    const double t196 = t184*t184; /* Theta*Theta */
    const double t197 = t37*t196; /* s*K*Theta*Theta */
    const double t198 = t189*t195; /* V*I3*I1*m */
    const double t199 = t21*t198; /* (s*R*G + b*v_tau*I3)*V*I3*I1*m */
    const double t200 = t28*t199; /* d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*V*I3*I1*m */
    const double t201 = t200/t197; /* d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*V*I3*I1*m/(s*K*Theta*Theta) */
    const double t202 = t194 - t201; /* t194 - t201 */
    const double t203 = p[5]*t156; /* a3*I1*I3 */
    const double t204 = x[2]*t203; /* omega_tau*a3*I1*I3 */
    const double t205 = t37*t184; /* s*K*Theta */
    const double t206 = t21*t204; /* (s*R*G + b*v_tau*I3)*omega_tau*a3*I1*I3 */
    const double t207 = t206/t205; /* (s*R*G + b*v_tau*I3)*omega_tau*a3*I1*I3/(s*K*Theta) */
    const double t208 = t202 + t207; /* t194 - t201 + (s*R*G + b*v_tau*I3)*omega_tau*a3*I1*I3/(s*K*Theta) */
    const double t209 = t33*t184; /* K*s*s*s*Theta */
    const double t210 = t157*t189; /* gamma3*I1*I3*V */
    const double t211 = t21*t210; /* (s*R*G + b*v_tau*I3)*gamma3*I1*I3*V */
    const double t212 = t211/t209; /* (s*R*G + b*v_tau*I3)*gamma3*I1*I3*V/(K*s*s*s*Theta) */
    const double t213 = t208 + t212; /* t208 + (s*R*G + b*v_tau*I3)*gamma3*I1*I3*V/(K*s*s*s*Theta) */
    const double t214 = t41*t190; /* (gamma3*R*G/s - v_tau*R*I3)*I1*I3*V */
    const double t215 = t214/t205; /* (gamma3*R*G/s - v_tau*R*I3)*I1*I3*V/(s*K*Theta) */
    const double t216 = t213 - t215; /* t208 + (s*R*G + b*v_tau*I3)*gamma3*I1*I3*V/(K*s*s*s*Theta) - (gamma3*R*G/s - v_tau*R*I3)*I1*I3*V/(s*K*Theta) */
    const double t217 = x[2]*p[4]; /* omega_tau*I3 */
    const double t218 = t15*t184; /* K*K*Theta */
    const double t219 = t123*t217; /* (s*v_tau*R*I1 - b*G)*omega_tau*I3 */
    const double t220 = t10*p[8]; /* gamma3*R*(I1 - I3) */
    const double t221 = t220 - p[9]; /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t222 = t219*t221; /* (s*v_tau*R*I1 - b*G)*omega_tau*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t223 = t28*t222; /* d(K)/d(gamma3)*t222 */
    const double t224 = t223/t218; /* d(K)/d(gamma3)*t222/(K*K*Theta) */
    const double t225 = t216 + t224; /* t216 + d(K)/d(gamma3)*t222/(K*K*Theta) */
    const double t226 = x[2]*t129; /* omega_tau*I3*m */
    const double t227 = t14*t196; /* K*Theta*Theta */
    const double t228 = t123*t226; /* (s*v_tau*R*I1 - b*G)*omega_tau*I3*m */
    const double t229 = t221*t228; /* (gamma3*R*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*omega_tau*I3*m */
    const double t230 = t28*t229; /* d(K)/d(gamma3)*t229 */
    const double t231 = t230/t227; /* d(K)/d(gamma3)*t229/(K*Theta*Theta) */
    const double t232 = t225 + t231; /* t216 + d(K)/d(gamma3)*t222/(K*K*Theta) + d(K)/d(gamma3)*t229/(K*Theta*Theta) */
    const double t233 = x[2]*t25; /* omega_tau*R*I3 */
    const double t234 = t14*t184; /* K*Theta */
    const double t235 = t123*t233; /* (s*v_tau*R*I1 - b*G)*omega_tau*R*I3 */
    const double t236 = p[8]*t235; /* (I1 - I3)*(s*v_tau*R*I1 - b*G)*omega_tau*R*I3 */
    const double t237 = t236/t234; /* (I1 - I3)*(s*v_tau*R*I1 - b*G)*omega_tau*R*I3/(K*Theta) */
    const double t238 = t232 - t237; /* t232 - (I1 - I3)*(s*v_tau*R*I1 - b*G)*omega_tau*R*I3/(K*Theta) */
    const double t239 = t217*t221; /* omega_tau*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t240 = t146*t239; /* (R*G + v_tau*gamma3*R*I1/s)*omega_tau*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t241 = t240/t234; /* t240/(K*Theta) */
    const double t242 = t238 + t241; /* t238 + t240/(K*Theta) */
    const double t243 = t21*t156; /* (s*R*G + b*v_tau*I3)*I1*I3 */
    const double t244 = t243/t205; /* (s*R*G + b*v_tau*I3)*I1*I3/(s*K*Theta) */
    const double t245 = t244 - t45; /* (s*R*G + b*v_tau*I3)*I1*I3/(s*K*Theta) - (s*R*G + b*v_tau*I3)/(s*K) */
    const double t246 = t156*t187; /* I1*I3*e */
    const double t247 = t21*t246; /* (s*R*G + b*v_tau*I3)*I1*I3*e */
    const double t248 = t247/t205; /* (s*R*G + b*v_tau*I3)*I1*I3*e/(s*K*Theta) */
    const double t249 = t139*t221; /* I3*(s*v_tau*R*I1 - b*G)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t250 = t249/t234; /* I3*(s*v_tau*R*I1 - b*G)*(gamma3*R*(I1 - I3) - I3*a3)/(K*Theta) */
    const double t251 = t248 - t250; /* (s*R*G + b*v_tau*I3)*I1*I3*e/(s*K*Theta) - t250 */
    const double t252 = p[4]*x[1]; /* I3*v_nu */
    const double t253 = t11*t252; /* b*I3*v_nu */
    const double t254 = t253/t37; /* b*I3*v_nu/(s*K) */
    const double t255 = p[3]*t163; /* I1*I3*I3 */
    const double t256 = t11*t255; /* b*I1*I3*I3 */
    const double t257 = t189*t256; /* V*b*I1*I3*I3 */
    const double t258 = t257/t205; /* V*b*I1*I3*I3/(s*K*Theta) */
    const double t259 = t258 - t254; /* V*b*I1*I3*I3/(s*K*Theta) - b*I3*v_nu/(s*K) */
    const double t260 = x[2]*t168; /* omega_tau*I3*R*I1 */
    const double t261 = t3*t260; /* s*omega_tau*I3*R*I1 */
    const double t262 = t221*t261; /* (gamma3*R*(I1 - I3) - I3*a3)*s*omega_tau*I3*R*I1 */
    const double t263 = t262/t234; /* (gamma3*R*(I1 - I3) - I3*a3)*s*omega_tau*I3*R*I1/(K*Theta) */
    const double t264 = t259 - t263; /* V*b*I1*I3*I3/(s*K*Theta) - b*I3*v_nu/(s*K) - (gamma3*R*(I1 - I3) - I3*a3)*s*omega_tau*I3*R*I1/(K*Theta) */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t44;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t47;
    out[8] = t149;
    out[9] = 0.0;
    out[10] = t155;
    out[11] = t172;
    out[12] = t242;
    out[13] = t245;
    out[14] = t251;
    out[15] = t264;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[1]; /* R*R */
    const double t5 = t4*p[3]; /* R*R*I1 */
    const double t6 = t2*t2; /* s*s */
    const double t7 = t5*t6; /* R*R*I1*s*s */
    const double t8 = x[0]*p[1]; /* gamma3*R */
    const double t9 = p[5] + t8; /* b = a3 + gamma3*R */
    const double t10 = t9*t9; /* b*b */
    const double t11 = p[4]*t10; /* I3*b*b */
    const double t12 = t7 + t11; /* K = R*R*I1*s*s + I3*b*b */
    const double t13 = t2*t12; /* s*K */
    const double t14 = p[1]*p[6]; /* R*G */
    const double t15 = t2*t14; /* s*R*G */
    const double t16 = x[3]*p[4]; /* v_tau*I3 */
    const double t17 = t9*t16; /* b*v_tau*I3 */
    const double t18 = t15 + t17; /* s*R*G + b*v_tau*I3 */
    const double t19 = x[3]*t18; /* v_tau*(s*R*G + b*v_tau*I3) */
    const double t20 = t19/t13; /* v_tau*(s*R*G + b*v_tau*I3)/(s*K) */
    const double t21 = p[5]*p[5]; /* a3*a3 */
    const double t22 = p[0]*t21; /* m*a3*a3 */
    const double t23 = x[0]*t22; /* gamma3*m*a3*a3 */
    const double t24 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t25 = t23*t24; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t26 = t2*t25; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t27 = t6*t22; /* s*s*m*a3*a3 */
    const double t28 = p[3] + t27; /* D = I1 + s*s*m*a3*a3 */
    const double t29 = t26/t28; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t30 = p[0]*p[2]; /* m*g */
    const double t31 = p[5]*t30; /* a3*m*g */
    const double t32 = t2*t31; /* s*a3*m*g */
    const double t33 = t32/t28; /* s*a3*m*g/D */
    const double t34 = t29 - t33; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D */
    const double t35 = x[0]*p[3]; /* gamma3*I1 */
    const double t36 = t12*t12; /* K*K */
    const double t37 = t2*t36; /* s*K*K */
    const double t38 = t28*t37; /* D*s*K*K */
    const double t39 = t18*t18; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t40 = t35*t39; /* gamma3*I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t41 = t40/t38; /* gamma3*I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(D*s*K*K) */
    const double t42 = t34 - t41; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - t41 */
    const double t43 = t28*t36; /* D*K*K */
    const double t44 = p[4]*t18; /* I3*(s*R*G + b*v_tau*I3) */
    const double t45 = p[1]*p[3]; /* R*I1 */
    const double t46 = x[3]*t45; /* v_tau*R*I1 */
    const double t47 = t2*t46; /* s*v_tau*R*I1 */
    const double t48 = t9*p[6]; /* b*G */
    const double t49 = t47 - t48; /* s*v_tau*R*I1 - b*G */
    const double t50 = t44*t49; /* I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G) */
    const double t51 = t50/t43; /* I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G)/(D*K*K) */
    const double t52 = t42 - t51; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - t41 - I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G)/(D*K*K) */
    const double t53 = t18*x[1]; /* (s*R*G + b*v_tau*I3)*v_nu */
    const double t54 = t53/t13; /* (s*R*G + b*v_tau*I3)*v_nu/(s*K) */
    const double t55 = p[3]*p[4]; /* I1*I3 */
    const double t56 = t12*p[0]; /* K*m */
    const double t57 = t56 + p[7]; /* Theta = K*m + I1*I3 */
    const double t58 = t13*t57; /* s*K*Theta */
    const double t59 = x[0]*p[5]; /* gamma3*a3 */
    const double t60 = p[1] + t59; /* e = R + gamma3*a3 */
    const double t61 = x[2]*t60; /* omega_tau*e */
    const double t62 = x[1] + t61; /* V = v_nu + omega_tau*e */
    const double t63 = t55*t62; /* I1*I3*V */
    const double t64 = t18*t63; /* (s*R*G + b*v_tau*I3)*I1*I3*V */
    const double t65 = t64/t58; /* (s*R*G + b*v_tau*I3)*I1*I3*V/(s*K*Theta) */
    const double t66 = t65 - t54; /* (s*R*G + b*v_tau*I3)*I1*I3*V/(s*K*Theta) - (s*R*G + b*v_tau*I3)*v_nu/(s*K) */
    const double t67 = x[2]*p[4]; /* omega_tau*I3 */
    const double t68 = t12*t57; /* K*Theta */
    const double t69 = t49*t67; /* (s*v_tau*R*I1 - b*G)*omega_tau*I3 */
    const double t70 = t8*p[8]; /* gamma3*R*(I1 - I3) */
    const double t71 = t70 - p[9]; /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t72 = t69*t71; /* (s*v_tau*R*I1 - b*G)*omega_tau*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t73 = t72/t68; /* t72/(K*Theta) */
    const double t74 = t66 - t73; /* t66 - t72/(K*Theta) */
    const double t75 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t76 = t75/t2; /* omega_tau*gamma3/s */
    const double t77 = -t76; /* -omega_tau*gamma3/s */
    const double t78 = x[0]*t5; /* gamma3*R*R*I1 */
    const double t79 = t78*2.0; /* gamma3*R*R*I1*2 */
    const double t80 = p[1]*p[4]; /* R*I3 */
    const double t81 = t9*t80; /* b*R*I3 */
    const double t82 = 2.0*t81; /* 2*b*R*I3 */
    const double t83 = t82 - t79; /* d(K)/d(gamma3) = 2*b*R*I3 - gamma3*R*R*I1*2 */
    const double t84 = t19*t83; /* v_tau*(s*R*G + b*v_tau*I3)*d(K)/d(gamma3) */
    const double t85 = t84/t37; /* v_tau*(s*R*G + b*v_tau*I3)*d(K)/d(gamma3)/(s*K*K) */
    const double t86 = x[0]*x[3]; /* gamma3*v_tau */
    const double t87 = t2*t6; /* s*s*s */
    const double t88 = t12*t87; /* K*s*s*s */
    const double t89 = t18*t86; /* (s*R*G + b*v_tau*I3)*gamma3*v_tau */
    const double t90 = t89/t88; /* (s*R*G + b*v_tau*I3)*gamma3*v_tau/(K*s*s*s) */
    const double t91 = t90 - t85; /* (s*R*G + b*v_tau*I3)*gamma3*v_tau/(K*s*s*s) - v_tau*(s*R*G + b*v_tau*I3)*d(K)/d(gamma3)/(s*K*K) */
    const double t92 = x[0]*t14; /* gamma3*R*G */
    const double t93 = t92/t2; /* gamma3*R*G/s */
    const double t94 = x[3]*t80; /* v_tau*R*I3 */
    const double t95 = t93 - t94; /* gamma3*R*G/s - v_tau*R*I3 */
    const double t96 = x[3]*t95; /* v_tau*(gamma3*R*G/s - v_tau*R*I3) */
    const double t97 = t96/t13; /* v_tau*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t98 = t91 - t97; /* t91 - v_tau*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t99 = t18/t13; /* (s*R*G + b*v_tau*I3)/(s*K) */
    const double t100 = t17/t13; /* b*v_tau*I3/(s*K) */
    const double t101 = t99 + t100; /* (s*R*G + b*v_tau*I3)/(s*K) + b*v_tau*I3/(s*K) */
    const double t102 = t22*t24; /* m*a3*a3*omega_tau*omega_tau */
    const double t103 = t2*t102; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t104 = t103/t28; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t105 = t0*t22; /* gamma3*gamma3*m*a3*a3 */
    const double t106 = t24*t105; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t107 = t2*t28; /* s*D */
    const double t108 = t106/t107; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t109 = t104 - t108; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t110 = p[0]*p[0]; /* m*m */
    const double t111 = t21*t21; /* a3*a3*a3*a3 */
    const double t112 = t110*t111; /* m*m*a3*a3*a3*a3 */
    const double t113 = t0*t112; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t114 = t24*t113; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t115 = t2*t114; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t116 = t28*t28; /* D*D */
    const double t117 = t115/t116; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t118 = 2.0*t117; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t119 = t109 + t118; /* t109 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t120 = x[0]*t31; /* gamma3*a3*m*g */
    const double t121 = t120/t107; /* gamma3*a3*m*g/(s*D) */
    const double t122 = t119 + t121; /* t119 + gamma3*a3*m*g/(s*D) */
    const double t123 = p[2]*t110; /* g*m*m */
    const double t124 = p[5]*t21; /* a3*a3*a3 */
    const double t125 = t123*t124; /* g*m*m*a3*a3*a3 */
    const double t126 = x[0]*t125; /* gamma3*g*m*m*a3*a3*a3 */
    const double t127 = t2*t126; /* s*gamma3*g*m*m*a3*a3*a3 */
    const double t128 = t127/t116; /* s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t129 = 2.0*t128; /* 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t130 = t122 - t129; /* t119 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t131 = p[3]*t39; /* I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t132 = t131/t38; /* I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(D*s*K*K) */
    const double t133 = t130 - t132; /* t119 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) - I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(D*s*K*K) */
    const double t134 = t12*t36; /* K*K*K */
    const double t135 = t2*t134; /* s*K*K*K */
    const double t136 = t28*t135; /* D*s*K*K*K */
    const double t137 = t40*t83; /* gamma3*I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*d(K)/d(gamma3) */
    const double t138 = t137/t136; /* t137/(D*s*K*K*K) */
    const double t139 = 2.0*t138; /* 2*t137/(D*s*K*K*K) */
    const double t140 = t133 + t139; /* t133 + 2*t137/(D*s*K*K*K) */
    const double t141 = t0*p[3]; /* gamma3*gamma3*I1 */
    const double t142 = t36*t87; /* K*K*s*s*s */
    const double t143 = t28*t142; /* D*K*K*s*s*s */
    const double t144 = t39*t141; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*gamma3*gamma3*I1 */
    const double t145 = t144/t143; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*gamma3*gamma3*I1/(D*K*K*s*s*s) */
    const double t146 = t140 - t145; /* t133 + 2*t137/(D*s*K*K*K) - t145 */
    const double t147 = p[3]*p[0]; /* I1*m */
    const double t148 = t21*t147; /* a3*a3*I1*m */
    const double t149 = t0*t148; /* gamma3*gamma3*a3*a3*I1*m */
    const double t150 = t37*t116; /* s*K*K*D*D */
    const double t151 = t39*t149; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*gamma3*gamma3*a3*a3*I1*m */
    const double t152 = t151/t150; /* t151/(s*K*K*D*D) */
    const double t153 = 2.0*t152; /* 2*t151/(s*K*K*D*D) */
    const double t154 = t146 - t153; /* t133 + 2*t137/(D*s*K*K*K) - t145 - 2*t151/(s*K*K*D*D) */
    const double t155 = t18*t35; /* (s*R*G + b*v_tau*I3)*gamma3*I1 */
    const double t156 = t95*t155; /* (gamma3*R*G/s - v_tau*R*I3)*(s*R*G + b*v_tau*I3)*gamma3*I1 */
    const double t157 = t156/t38; /* (gamma3*R*G/s - v_tau*R*I3)*(s*R*G + b*v_tau*I3)*gamma3*I1/(D*s*K*K) */
    const double t158 = 2.0*t157; /* 2*t157 */
    const double t159 = t154 + t158; /* t133 + 2*t137/(D*s*K*K*K) - t145 - 2*t151/(s*K*K*D*D) + 2*t157 */
    const double t160 = t28*t134; /* D*K*K*K */
    const double t161 = t50*t83; /* I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G)*d(K)/d(gamma3) */
    const double t162 = t161/t160; /* I3*(s*R*G + b*v_tau*I3)*(s*v_tau*R*I1 - b*G)*d(K)/d(gamma3)/(D*K*K*K) */
    const double t163 = 2.0*t162; /* 2*t162 */
    const double t164 = t159 + t163; /* t159 + 2*t162 */
    const double t165 = p[4]*p[0]; /* I3*m */
    const double t166 = t21*t165; /* a3*a3*I3*m */
    const double t167 = x[0]*t166; /* gamma3*a3*a3*I3*m */
    const double t168 = t36*t116; /* K*K*D*D */
    const double t169 = t18*t167; /* (s*R*G + b*v_tau*I3)*gamma3*a3*a3*I3*m */
    const double t170 = t49*t169; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*v_tau*I3)*gamma3*a3*a3*I3*m */
    const double t171 = t170/t168; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*v_tau*I3)*gamma3*a3*a3*I3*m/(K*K*D*D) */
    const double t172 = 2.0*t171; /* 2*t171 */
    const double t173 = t164 - t172; /* t159 + 2*t162 - 2*t171 */
    const double t174 = p[4]*t49; /* I3*(s*v_tau*R*I1 - b*G) */
    const double t175 = t95*t174; /* (gamma3*R*G/s - v_tau*R*I3)*I3*(s*v_tau*R*I1 - b*G) */
    const double t176 = t175/t43; /* (gamma3*R*G/s - v_tau*R*I3)*I3*(s*v_tau*R*I1 - b*G)/(D*K*K) */
    const double t177 = t173 + t176; /* t159 + 2*t162 - 2*t171 + (gamma3*R*G/s - v_tau*R*I3)*I3*(s*v_tau*R*I1 - b*G)/(D*K*K) */
    const double t178 = x[0]*t45; /* gamma3*R*I1 */
    const double t179 = x[3]*t178; /* v_tau*gamma3*R*I1 */
    const double t180 = t179/t2; /* v_tau*gamma3*R*I1/s */
    const double t181 = p[10] + t180; /* R*G + v_tau*gamma3*R*I1/s */
    const double t182 = t44*t181; /* I3*(s*R*G + b*v_tau*I3)*(R*G + v_tau*gamma3*R*I1/s) */
    const double t183 = t182/t43; /* I3*(s*R*G + b*v_tau*I3)*(R*G + v_tau*gamma3*R*I1/s)/(D*K*K) */
    const double t184 = t177 + t183; /* t177 + I3*(s*R*G + b*v_tau*I3)*(R*G + v_tau*gamma3*R*I1/s)/(D*K*K) */
    const double t185 = p[0]*2.0; /* m*2 */
    const double t186 = t21*t185; /* a3*a3*m*2 */
    const double t187 = x[0]*t186; /* gamma3*a3*a3*m*2 */
    const double t188 = x[2]*t187; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t189 = t2*t188; /* s*omega_tau*gamma3*a3*a3*m*2 */
    const double t190 = t189/t28; /* s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t191 = x[0]*t55; /* gamma3*I1*I3 */
    const double t192 = t9*t191; /* b*gamma3*I1*I3 */
    const double t193 = t18*t192; /* (s*R*G + b*v_tau*I3)*b*gamma3*I1*I3 */
    const double t194 = t193/t38; /* (s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(D*s*K*K) */
    const double t195 = 2.0*t194; /* 2*(s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(D*s*K*K) */
    const double t196 = -t195; /* -2*(s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(D*s*K*K) */
    const double t197 = p[4]*p[4]; /* I3*I3 */
    const double t198 = t9*t197; /* b*I3*I3 */
    const double t199 = t49*t198; /* (s*v_tau*R*I1 - b*G)*b*I3*I3 */
    const double t200 = t199/t43; /* (s*v_tau*R*I1 - b*G)*b*I3*I3/(D*K*K) */
    const double t201 = t196 - t200; /* -2*(s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(D*s*K*K) - (s*v_tau*R*I1 - b*G)*b*I3*I3/(D*K*K) */
    const double t202 = p[4]*t45; /* I3*R*I1 */
    const double t203 = t2*t202; /* s*I3*R*I1 */
    const double t204 = t18*t203; /* (s*R*G + b*v_tau*I3)*s*I3*R*I1 */
    const double t205 = t204/t43; /* (s*R*G + b*v_tau*I3)*s*I3*R*I1/(D*K*K) */
    const double t206 = t201 - t205; /* t201 - (s*R*G + b*v_tau*I3)*s*I3*R*I1/(D*K*K) */
    const double t207 = t53*t83; /* (s*R*G + b*v_tau*I3)*v_nu*d(K)/d(gamma3) */
    const double t208 = t207/t37; /* (s*R*G + b*v_tau*I3)*v_nu*d(K)/d(gamma3)/(s*K*K) */
    const double t209 = x[0]*x[1]; /* gamma3*v_nu */
    const double t210 = t18*t209; /* (s*R*G + b*v_tau*I3)*gamma3*v_nu */
    const double t211 = t210/t88; /* (s*R*G + b*v_tau*I3)*gamma3*v_nu/(K*s*s*s) */
    const double t212 = t208 - t211; /* (s*R*G + b*v_tau*I3)*v_nu*d(K)/d(gamma3)/(s*K*K) - (s*R*G + b*v_tau*I3)*gamma3*v_nu/(K*s*s*s) */
    const double t213 = x[1]*t95; /* v_nu*(gamma3*R*G/s - v_tau*R*I3) */
    const double t214 = t213/t13; /* v_nu*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t215 = t212 + t214; /* t212 + v_nu*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t216 = t37*t57; /* s*K*K*Theta */
    const double t217 = t64*t83; /* (s*R*G + b*v_tau*I3)*I1*I3*V*d(K)/d(gamma3) */
    const double t218 = t217/t216; /* (s*R*G + b*v_tau*I3)*I1*I3*V*d(K)/d(gamma3)/(s*K*K*Theta) */
    const double t219 = t215 - t218; /* t212 + v_nu*(gamma3*R*G/s - v_tau*R*I3)/(s*K) - (s*R*G + b*v_tau*I3)*I1*I3*V*d(K)/d(gamma3)/(s*K*K*Theta) */
    const double t220 = p[4]*t147; /* I3*I1*m */
    const double t221 = t57*t57; /* Theta*Theta */
    const double t222 = t13*t221; /* s*K*Theta*Theta */
    const double t223 = t62*t220; /* V*I3*I1*m */
    const double t224 = t18*t223; /* (s*R*G + b*v_tau*I3)*V*I3*I1*m */
    const double t225 = t83*t224; /* d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*V*I3*I1*m */
    const double t226 = t225/t222; /* d(K)/d(gamma3)*(s*R*G + b*v_tau*I3)*V*I3*I1*m/(s*K*Theta*Theta) */
    const double t227 = t219 - t226; /* t219 - t226 */
    const double t228 = p[5]*t55; /* a3*I1*I3 */
    const double t229 = x[2]*t228; /* omega_tau*a3*I1*I3 */
    const double t230 = t18*t229; /* (s*R*G + b*v_tau*I3)*omega_tau*a3*I1*I3 */
    const double t231 = t230/t58; /* (s*R*G + b*v_tau*I3)*omega_tau*a3*I1*I3/(s*K*Theta) */
    const double t232 = t227 + t231; /* t219 - t226 + (s*R*G + b*v_tau*I3)*omega_tau*a3*I1*I3/(s*K*Theta) */
    const double t233 = t57*t88; /* Theta*K*s*s*s */
    const double t234 = t62*t191; /* V*gamma3*I1*I3 */
    const double t235 = t18*t234; /* (s*R*G + b*v_tau*I3)*V*gamma3*I1*I3 */
    const double t236 = t235/t233; /* (s*R*G + b*v_tau*I3)*V*gamma3*I1*I3/(Theta*K*s*s*s) */
    const double t237 = t232 + t236; /* t232 + (s*R*G + b*v_tau*I3)*V*gamma3*I1*I3/(Theta*K*s*s*s) */
    const double t238 = t63*t95; /* I1*I3*V*(gamma3*R*G/s - v_tau*R*I3) */
    const double t239 = t238/t58; /* I1*I3*V*(gamma3*R*G/s - v_tau*R*I3)/(s*K*Theta) */
    const double t240 = t237 - t239; /* t232 + (s*R*G + b*v_tau*I3)*V*gamma3*I1*I3/(Theta*K*s*s*s) - I1*I3*V*(gamma3*R*G/s - v_tau*R*I3)/(s*K*Theta) */
    const double t241 = t36*t57; /* K*K*Theta */
    const double t242 = t72*t83; /* t72*d(K)/d(gamma3) */
    const double t243 = t242/t241; /* t72*d(K)/d(gamma3)/(K*K*Theta) */
    const double t244 = t240 + t243; /* t240 + t72*d(K)/d(gamma3)/(K*K*Theta) */
    const double t245 = x[2]*t165; /* omega_tau*I3*m */
    const double t246 = t12*t221; /* K*Theta*Theta */
    const double t247 = t49*t245; /* (s*v_tau*R*I1 - b*G)*omega_tau*I3*m */
    const double t248 = t71*t247; /* (gamma3*R*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*omega_tau*I3*m */
    const double t249 = t83*t248; /* d(K)/d(gamma3)*t248 */
    const double t250 = t249/t246; /* d(K)/d(gamma3)*t248/(K*Theta*Theta) */
    const double t251 = t244 + t250; /* t240 + t72*d(K)/d(gamma3)/(K*K*Theta) + d(K)/d(gamma3)*t248/(K*Theta*Theta) */
    const double t252 = x[2]*t80; /* omega_tau*R*I3 */
    const double t253 = t49*t252; /* (s*v_tau*R*I1 - b*G)*omega_tau*R*I3 */
    const double t254 = p[8]*t253; /* (I1 - I3)*(s*v_tau*R*I1 - b*G)*omega_tau*R*I3 */
    const double t255 = t254/t68; /* (I1 - I3)*(s*v_tau*R*I1 - b*G)*omega_tau*R*I3/(K*Theta) */
    const double t256 = t251 - t255; /* t251 - (I1 - I3)*(s*v_tau*R*I1 - b*G)*omega_tau*R*I3/(K*Theta) */
    const double t257 = t67*t71; /* omega_tau*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t258 = t181*t257; /* (R*G + v_tau*gamma3*R*I1/s)*omega_tau*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t259 = t258/t68; /* t258/(K*Theta) */
    const double t260 = t256 + t259; /* t256 + t258/(K*Theta) */
    const double t261 = t18*t55; /* (s*R*G + b*v_tau*I3)*I1*I3 */
    const double t262 = t261/t58; /* (s*R*G + b*v_tau*I3)*I1*I3/(s*K*Theta) */
    const double t263 = t262 - t99; /* (s*R*G + b*v_tau*I3)*I1*I3/(s*K*Theta) - (s*R*G + b*v_tau*I3)/(s*K) */
    const double t264 = t55*t60; /* I1*I3*e */
    const double t265 = t18*t264; /* (s*R*G + b*v_tau*I3)*I1*I3*e */
    const double t266 = t265/t58; /* (s*R*G + b*v_tau*I3)*I1*I3*e/(s*K*Theta) */
    const double t267 = t71*t174; /* (gamma3*R*(I1 - I3) - I3*a3)*I3*(s*v_tau*R*I1 - b*G) */
    const double t268 = t267/t68; /* (gamma3*R*(I1 - I3) - I3*a3)*I3*(s*v_tau*R*I1 - b*G)/(K*Theta) */
    const double t269 = t266 - t268; /* (s*R*G + b*v_tau*I3)*I1*I3*e/(s*K*Theta) - t268 */
    const double t270 = p[4]*x[1]; /* I3*v_nu */
    const double t271 = t9*t270; /* b*I3*v_nu */
    const double t272 = t271/t13; /* b*I3*v_nu/(s*K) */
    const double t273 = p[3]*t197; /* I1*I3*I3 */
    const double t274 = t9*t273; /* b*I1*I3*I3 */
    const double t275 = t62*t274; /* V*b*I1*I3*I3 */
    const double t276 = t275/t58; /* V*b*I1*I3*I3/(s*K*Theta) */
    const double t277 = t276 - t272; /* V*b*I1*I3*I3/(s*K*Theta) - b*I3*v_nu/(s*K) */
    const double t278 = x[2]*t202; /* omega_tau*I3*R*I1 */
    const double t279 = t2*t278; /* s*omega_tau*I3*R*I1 */
    const double t280 = t71*t279; /* (gamma3*R*(I1 - I3) - I3*a3)*s*omega_tau*I3*R*I1 */
    const double t281 = t280/t68; /* (gamma3*R*(I1 - I3) - I3*a3)*s*omega_tau*I3*R*I1/(K*Theta) */
    const double t282 = t277 - t281; /* V*b*I1*I3*I3/(s*K*Theta) - b*I3*v_nu/(s*K) - (gamma3*R*(I1 - I3) - I3*a3)*s*omega_tau*I3*R*I1/(K*Theta) */
    out[0] = t3;
    out[1] = t20;
    out[2] = t52;
    out[3] = t74;
    out[4] = t77;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = t98;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t101;
    out[12] = t184;
    out[13] = 0.0;
    out[14] = t190;
    out[15] = t206;
    out[16] = t260;
    out[17] = t263;
    out[18] = t269;
    out[19] = t282;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = p[5]*p[5]; /* a3*a3 */
    const double t6 = p[0]*t5; /* m*a3*a3 */
    const double t7 = x[0]*t6; /* gamma3*m*a3*a3 */
    const double t8 = x[2]*t7; /* omega_tau*gamma3*m*a3*a3 */
    const double t9 = t3*t8; /* s*omega_tau*gamma3*m*a3*a3 */
    const double t10 = t3*t3; /* s*s */
    const double t11 = t6*t10; /* m*a3*a3*s*s */
    const double t12 = p[3] + t11; /* D = I1 + m*a3*a3*s*s */
    const double t13 = t9/t12; /* s*omega_tau*gamma3*m*a3*a3/D */
    const double t14 = t13*2.0; /* s*omega_tau*gamma3*m*a3*a3/D*2 */
    const double t15 = t14 - t4; /* s*omega_tau*gamma3*m*a3*a3/D*2 - gamma3*omega_tau/s */
    const double t16 = p[4]*x[1]; /* I3*v_nu */
    const double t17 = x[0]*p[1]; /* gamma3*R */
    const double t18 = p[5] + t17; /* b = a3 + gamma3*R */
    const double t19 = t16*t18; /* I3*v_nu*b */
    const double t20 = p[1]*p[1]; /* R*R */
    const double t21 = p[3]*t20; /* I1*R*R */
    const double t22 = t10*t21; /* s*s*I1*R*R */
    const double t23 = t18*t18; /* b*b */
    const double t24 = p[4]*t23; /* I3*b*b */
    const double t25 = t22 + t24; /* K = s*s*I1*R*R + I3*b*b */
    const double t26 = t3*t25; /* s*K */
    const double t27 = t19/t26; /* I3*v_nu*b/(s*K) */
    const double t28 = t15 - t27; /* s*omega_tau*gamma3*m*a3*a3/D*2 - gamma3*omega_tau/s - I3*v_nu*b/(s*K) */
    const double t29 = p[4]*p[4]; /* I3*I3 */
    const double t30 = p[3]*t29; /* I1*I3*I3 */
    const double t31 = t18*t30; /* b*I1*I3*I3 */
    const double t32 = p[0]*t25; /* m*K */
    const double t33 = t32 + p[7]; /* Theta = m*K + I1*I3 */
    const double t34 = t26*t33; /* s*K*Theta */
    const double t35 = x[0]*p[5]; /* gamma3*a3 */
    const double t36 = p[1] + t35; /* e = R + gamma3*a3 */
    const double t37 = x[2]*t36; /* omega_tau*e */
    const double t38 = x[1] + t37; /* V = v_nu + omega_tau*e */
    const double t39 = t31*t38; /* b*I1*I3*I3*V */
    const double t40 = t39/t34; /* b*I1*I3*I3*V/(s*K*Theta) */
    const double t41 = t28 + t40; /* t28 + b*I1*I3*I3*V/(s*K*Theta) */
    const double t42 = p[3]*p[1]; /* I1*R */
    const double t43 = p[4]*t42; /* I3*I1*R */
    const double t44 = x[2]*t43; /* omega_tau*I3*I1*R */
    const double t45 = t3*t44; /* s*omega_tau*I3*I1*R */
    const double t46 = t25*t33; /* K*Theta */
    const double t47 = t17*p[8]; /* gamma3*R*(I1 - I3) */
    const double t48 = t47 - p[9]; /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t49 = t45*t48; /* s*omega_tau*I3*I1*R*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t50 = t49/t46; /* s*omega_tau*I3*I1*R*(gamma3*R*(I1 - I3) - I3*a3)/(K*Theta) */
    const double t51 = t41 - t50; /* t28 + b*I1*I3*I3*V/(s*K*Theta) - s*omega_tau*I3*I1*R*(gamma3*R*(I1 - I3) - I3*a3)/(K*Theta) */
    out[0] = t51;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[2]; /* m*g */
    const double t1 = t0*p[5]; /* m*g*a3 */
    const double t2 = t1*x[0]; /* m*g*a3*gamma3 */
    const double t3 = x[1]*x[1]; /* v_nu*v_nu */
    const double t4 = p[0]*t3; /* m*v_nu*v_nu */
    const double t5 = t4*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t6 = t2 + t5; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 */
    const double t7 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t8 = p[5]*p[5]; /* a3*a3 */
    const double t9 = p[0]*t8; /* m*a3*a3 */
    const double t10 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t11 = 1.0 - t10; /* 1 - gamma3*gamma3 */
    const double t12 = sqrt(t11); /* s = sqrt(1 - gamma3*gamma3) */
    const double t13 = t12*t12; /* s*s */
    const double t14 = t9*t13; /* m*a3*a3*s*s */
    const double t15 = p[3] + t14; /* D = I1 + m*a3*a3*s*s */
    const double t16 = t7*t15; /* omega_tau*omega_tau*D */
    const double t17 = (1.0 / 2.0)*t16; /* 1/2*omega_tau*omega_tau*D */
    const double t18 = t6 + t17; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D */
    const double t19 = x[3]*x[3]; /* v_tau*v_tau */
    const double t20 = p[1]*p[1]; /* R*R */
    const double t21 = p[3]*t20; /* I1*R*R */
    const double t22 = t13*t21; /* s*s*I1*R*R */
    const double t23 = x[0]*p[1]; /* gamma3*R */
    const double t24 = p[5] + t23; /* b = a3 + gamma3*R */
    const double t25 = t24*t24; /* b*b */
    const double t26 = p[4]*t25; /* I3*b*b */
    const double t27 = t22 + t26; /* K = s*s*I1*R*R + I3*b*b */
    const double t28 = p[0]*t27; /* m*K */
    const double t29 = t28 + p[7]; /* Theta = m*K + I1*I3 */
    const double t30 = t19*t29; /* v_tau*v_tau*Theta */
    const double t31 = t30/t27; /* v_tau*v_tau*Theta/K */
    const double t32 = (1.0 / 2.0)*t31; /* 1/2*v_tau*v_tau*Theta/K */
    const double t33 = t18 + t32; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*v_tau*v_tau*Theta/K */
    const double t34 = p[6]*p[6]; /* G*G */
    const double t35 = t34/t27; /* G*G/K */
    const double t36 = (1.0 / 2.0)*t35; /* 1/2*G*G/K */
    const double t37 = t33 + t36; /* t33 + 1/2*G*G/K */
    out[0] = t37;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[5]*p[5]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t4 = t2*t3; /* m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t5 = p[11] - t4; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = p[1]*p[1]; /* R*R */
    const double t8 = t7*p[3]; /* R*R*I1 */
    const double t9 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t10 = 1.0 - t9; /* 1 - gamma3*gamma3 */
    const double t11 = sqrt(t10); /* s = sqrt(1 - gamma3*gamma3) */
    const double t12 = t11*t11; /* s*s */
    const double t13 = t8*t12; /* R*R*I1*s*s */
    const double t14 = x[0]*p[1]; /* gamma3*R */
    const double t15 = p[5] + t14; /* b = a3 + gamma3*R */
    const double t16 = t15*t15; /* b*b */
    const double t17 = p[4]*t16; /* I3*b*b */
    const double t18 = t13 + t17; /* K = R*R*I1*s*s + I3*b*b */
    const double t19 = t18*t18; /* K*K */
    const double t20 = p[0]*t18; /* m*K */
    const double t21 = t20 + p[7]; /* Theta = m*K + I1*I3 */
    const double t22 = t6*t21; /* v_tau*v_tau*Theta */
    const double t23 = x[0]*t8; /* gamma3*R*R*I1 */
    const double t24 = t23*2.0; /* gamma3*R*R*I1*2 */
    const double t25 = p[1]*p[4]; /* R*I3 */
    const double t26 = t15*t25; /* b*R*I3 */
    const double t27 = 2.0*t26; /* 2*b*R*I3 */
    const double t28 = t27 - t24; /* d(K)/d(gamma3) = 2*b*R*I3 - gamma3*R*R*I1*2 */
    const double t29 = t22*t28; /* v_tau*v_tau*Theta*d(K)/d(gamma3) */
    const double t30 = t29/t19; /* v_tau*v_tau*Theta*d(K)/d(gamma3)/(K*K) */
    const double t31 = t30*(1.0 / 2.0); /* v_tau*v_tau*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t32 = t5 - t31; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau - v_tau*v_tau*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t33 = p[0]*t6; /* m*v_tau*v_tau */
    const double t34 = t28*t33; /* d(K)/d(gamma3)*m*v_tau*v_tau */
    const double t35 = t34/t18; /* d(K)/d(gamma3)*m*v_tau*v_tau/K */
    const double t36 = (1.0 / 2.0)*t35; /* 1/2*d(K)/d(gamma3)*m*v_tau*v_tau/K */
    const double t37 = t32 + t36; /* t32 + 1/2*d(K)/d(gamma3)*m*v_tau*v_tau/K */
    const double t38 = p[6]*p[6]; /* G*G */
    const double t39 = t28*t38; /* d(K)/d(gamma3)*G*G */
    const double t40 = t39/t19; /* d(K)/d(gamma3)*G*G/(K*K) */
    const double t41 = (1.0 / 2.0)*t40; /* 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t42 = t37 - t41; /* t32 + 1/2*d(K)/d(gamma3)*m*v_tau*v_tau/K - 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t43 = p[0]*x[1]; /* m*v_nu */
    const double t44 = t1*t12; /* m*a3*a3*s*s */
    const double t45 = p[3] + t44; /* D = I1 + m*a3*a3*s*s */
    const double t46 = x[2]*t45; /* omega_tau*D */
    const double t47 = x[3]*t21; /* v_tau*Theta */
    const double t48 = t47/t18; /* v_tau*Theta/K */
    out[0] = t42;
    out[1] = t43;
    out[2] = t46;
    out[3] = t48;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double complex v_v_tau = x[3];
    const double v_R = params[1];
    const double v_I1 = params[3];
    const double v_I3 = params[4];
    const double v_a3 = params[5];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_K = (v_R*v_R*v_I1*v_s*v_s + v_I3*v_b*v_b);
    const double v_G = params[6];
    const double complex v_omega_n = ((v_R*v_G*v_s + v_I3*v_v_tau*v_b)/v_K);
    out[1] = (v_v_tau*v_omega_n/v_s);
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double complex v_omega3 = ((v_R*v_I1*v_v_tau*v_s - v_G*v_b)/v_K);
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_v_nu = x[1];
    const double complex v_Theta = (v_m*v_K + v_I1*v_I3);
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (-v_v_nu*v_omega_n/v_s)
        + (v_I1*v_I3*v_V*v_omega_n/(v_s*v_Theta))
        + (-v_I3*v_omega_tau*v_omega3*(v_R*v_gamma3*(v_I1 - v_I3) - v_I3*v_a3)/v_Theta);
}

static const unsigned char family0_is_free[] = { 1, 1, 0, 0 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
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

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[1]*params[6]; /* R*G */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0*t3; /* R*G*s */
    const double t5 = x[0]*params[1]; /* gamma3*R */
    const double t6 = params[5] + t5; /* b = a3 + gamma3*R */
    const double t7 = params[4]*t6; /* I3*b */
    const double t8 = t4/t7; /* R*G*s/(I3*b) */
    const double t9 = -t8; /* v_tau = -R*G*s/(I3*b) */
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    out[3] = t9;
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[4]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I3*gamma3*v_nu */
    const double t4 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t5 = 1.0 - t4; /* 1 - gamma3*gamma3 */
    const double t6 = sqrt(t5); /* s = sqrt(1 - gamma3*gamma3) */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = t7*params[3]; /* R*R*I1 */
    const double t9 = t6*t6; /* s*s */
    const double t10 = t8*t9; /* R*R*I1*s*s */
    const double t11 = params[1]*x[0]; /* R*gamma3 */
    const double t12 = params[5] + t11; /* b = a3 + R*gamma3 */
    const double t13 = t12*t12; /* b*b */
    const double t14 = params[4]*t13; /* I3*b*b */
    const double t15 = t10 + t14; /* K = R*R*I1*s*s + I3*b*b */
    const double t16 = params[0]*t15; /* m*K */
    const double t17 = params[4]*params[3]; /* I3*I1 */
    const double t18 = t16 + t17; /* Theta = m*K + I3*I1 */
    const double t19 = t6*t18; /* s*Theta */
    const double t20 = t3/t19; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t21 = -t20; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t21;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = t0*params[5]; /* m*g*a3 */
    const double t2 = params[1]*params[6]; /* R*G */
    const double t3 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t4 = 1.0 - t3; /* 1 - gamma3*gamma3 */
    const double t5 = sqrt(t4); /* s = sqrt(1 - gamma3*gamma3) */
    const double t6 = t2*t5; /* R*G*s */
    const double t7 = x[0]*params[1]; /* gamma3*R */
    const double t8 = params[5] + t7; /* b = a3 + gamma3*R */
    const double t9 = params[4]*t8; /* I3*b */
    const double t10 = t6/t9; /* R*G*s/(I3*b) */
    const double t11 = t10*t10; /* R*G*s/(I3*b)*R*G*s/(I3*b) */
    const double t12 = params[1]*params[1]; /* R*R */
    const double t13 = t12*params[3]; /* R*R*I1 */
    const double t14 = t5*t5; /* s*s */
    const double t15 = t13*t14; /* R*R*I1*s*s */
    const double t16 = t8*t8; /* b*b */
    const double t17 = params[4]*t16; /* I3*b*b */
    const double t18 = t15 + t17; /* K = R*R*I1*s*s + I3*b*b */
    const double t19 = t18*t18; /* K*K */
    const double t20 = params[0]*t18; /* m*K */
    const double t21 = params[4]*params[3]; /* I3*I1 */
    const double t22 = t20 + t21; /* Theta = m*K + I3*I1 */
    const double t23 = t11*t22; /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta */
    const double t24 = x[0]*t13; /* gamma3*R*R*I1 */
    const double t25 = t24*2.0; /* gamma3*R*R*I1*2 */
    const double t26 = params[1]*params[4]; /* R*I3 */
    const double t27 = t8*t26; /* b*R*I3 */
    const double t28 = 2.0*t27; /* 2*b*R*I3 */
    const double t29 = t28 - t25; /* d(K)/d(gamma3) = 2*b*R*I3 - gamma3*R*R*I1*2 */
    const double t30 = t23*t29; /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3) */
    const double t31 = t30/t19; /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3)/(K*K) */
    const double t32 = t31*(1.0 / 2.0); /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t33 = t1 - t32; /* m*g*a3 - R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t34 = params[0]*t11; /* m*R*G*s/(I3*b)*R*G*s/(I3*b) */
    const double t35 = t29*t34; /* d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b) */
    const double t36 = t35/t18; /* d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K */
    const double t37 = (1.0 / 2.0)*t36; /* 1/2*d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K */
    const double t38 = t33 + t37; /* t33 + 1/2*d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K */
    const double t39 = params[6]*params[6]; /* G*G */
    const double t40 = t29*t39; /* d(K)/d(gamma3)*G*G */
    const double t41 = t40/t19; /* d(K)/d(gamma3)*G*G/(K*K) */
    const double t42 = (1.0 / 2.0)*t41; /* 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t43 = t38 - t42; /* t33 + 1/2*d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K - 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t44 = params[0]*x[1]; /* m*v_nu */
    const double t45 = t10*t22; /* R*G*s/(I3*b)*Theta */
    const double t46 = t45/t18; /* R*G*s/(I3*b)*Theta/K */
    const double t47 = -t46; /* -R*G*s/(I3*b)*Theta/K */
    const double t48 = t18*t19; /* K*K*K */
    const double t49 = params[1]*params[3]; /* R*I1 */
    const double t50 = t10*t49; /* R*G*s/(I3*b)*R*I1 */
    const double t51 = t5*t50; /* s*R*G*s/(I3*b)*R*I1 */
    const double t52 = -t51; /* -s*R*G*s/(I3*b)*R*I1 */
    const double t53 = params[6]*t8; /* G*b */
    const double t54 = t52 - t53; /* -s*R*G*s/(I3*b)*R*I1 - G*b */
    const double t55 = t54*t54; /* (-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t56 = t22*t55; /* Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t57 = params[3] - params[4]; /* I1 - I3 */
    const double t58 = t56*t57; /* t56*(I1 - I3) */
    const double t59 = t29*t58; /* d(K)/d(gamma3)*t56*(I1 - I3) */
    const double t60 = t59/t48; /* d(K)/d(gamma3)*t56*(I1 - I3)/(K*K*K) */
    const double t61 = 2.0*t60; /* 2*d(K)/d(gamma3)*t56*(I1 - I3)/(K*K*K) */
    const double t62 = params[0]*t55; /* m*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t63 = t57*t62; /* (I1 - I3)*m*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t64 = t29*t63; /* d(K)/d(gamma3)*t63 */
    const double t65 = t64/t19; /* d(K)/d(gamma3)*t63/(K*K) */
    const double t66 = t65 - t61; /* d(K)/d(gamma3)*t63/(K*K) - 2*d(K)/d(gamma3)*t56*(I1 - I3)/(K*K*K) */
    const double t67 = t22*t54; /* Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t68 = t57*t67; /* (I1 - I3)*Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t69 = x[0]*t49; /* gamma3*R*I1 */
    const double t70 = t10*t69; /* R*G*s/(I3*b)*gamma3*R*I1 */
    const double t71 = t70/t5; /* R*G*s/(I3*b)*gamma3*R*I1/s */
    const double t72 = t2 - t71; /* R*G - R*G*s/(I3*b)*gamma3*R*I1/s */
    const double t73 = t68*t72; /* (I1 - I3)*Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(R*G - R*G*s/(I3*b)*gamma3*R*I1/s) */
    const double t74 = t73/t19; /* t73/(K*K) */
    const double t75 = 2.0*t74; /* 2*t73/(K*K) */
    const double t76 = t66 - t75; /* t66 - 2*t73/(K*K) */
    const double t77 = params[0]*2.0; /* m*2 */
    const double t78 = params[3]*params[3]; /* I1*I1 */
    const double t79 = t77*t78; /* m*2*I1*I1 */
    const double t80 = x[1]*t79; /* v_nu*m*2*I1*I1 */
    const double t81 = params[1]*t77; /* R*m*2 */
    const double t82 = t78*t81; /* I1*I1*R*m*2 */
    const double t83 = x[1]*t82; /* v_nu*I1*I1*R*m*2 */
    const double t84 = params[1]*2.0; /* R*2 */
    const double t85 = params[3]*t84; /* I1*R*2 */
    const double t86 = t5*t85; /* s*I1*R*2 */
    const double t87 = t22*t86; /* Theta*s*I1*R*2 */
    const double t88 = t54*t87; /* (-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2 */
    const double t89 = t57*t88; /* (I1 - I3)*(-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2 */
    const double t90 = t89/t19; /* (I1 - I3)*(-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2/(K*K) */
    out[0] = t43;
    out[1] = t44;
    out[2] = 0.0;
    out[3] = t47;
    out[4] = t76;
    out[5] = t80;
    out[6] = t83;
    out[7] = t90;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

static const jlt_equilibria equilibria[] = {
    { .name = "spinning", .condition = "a3 = 0",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 2, .obstructs = 1 },
};

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
};

const jlt_descriptor jlt_kernels_spherical_top_level_general = {
    .model = "spherical_top_level",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 4, .param_count = 7, .block_count = 12,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 15, 51, 0, 8, 1, 0, 12, 13 }, { 21, 80, 0, 8, 1, 0, 12, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 48, 172, 0, 44, 1, 0, 21, 29 }, { 91, 425, 0, 50, 1, 0, 21, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 53, 177, 0, 52, 1, 0, 21, 44 }, { 105, 489, 0, 58, 1, 0, 21, 14 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 12, 34, 0, 5, 1, 0, 12, 9 }, { 13, 41, 0, 5, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 9, 26, 0, 2, 1, 0, 13, 5 }, { 9, 28, 0, 2, 1, 0, 13, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 10, 34, 0, 4, 1, 0, 15, 12 }, { 10, 44, 0, 4, 1, 0, 15, 10 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_general_baseline,
        &jlt_batch_spherical_top_level_general_avx2,
        &jlt_batch_spherical_top_level_general_avx512,
    },
};
