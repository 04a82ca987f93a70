/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Table:      spherical_top_level, SHA-256 10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 10   37    0    6    1    0     12   11   (94)
 *  jacobian            37  121    0   35    1    0     20   24   (464)
 *  rhs_jacobian        41  129    0   41    1    0     20   31   (541)
 *  divergence          8   26    0    4    1    0     12    9   (46)
 *  integral_values     9   33    0    3    1    0     14    8   (50)
 *  integral_gradients  11   59    0    9    1    0     15   11   (123)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_balanced;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_avx512;

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
    const double t2 = params[1]*params[6]; /* R*G */
    out[7] = t0;
    out[8] = t1;
    out[9] = t2;
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
    const double t8 = t4*p[4]; /* R*R*I3 */
    const double t9 = t0*t8; /* gamma3*gamma3*R*R*I3 */
    const double t10 = t7 + t9; /* K = R*R*I1*s*s + gamma3*gamma3*R*R*I3 */
    const double t11 = t2*t10; /* s*K */
    const double t12 = p[1]*p[6]; /* R*G */
    const double t13 = t2*t12; /* s*R*G */
    const double t14 = p[1]*p[4]; /* R*I3 */
    const double t15 = x[0]*t14; /* gamma3*R*I3 */
    const double t16 = x[3]*t15; /* v_tau*gamma3*R*I3 */
    const double t17 = t13 + t16; /* s*R*G + v_tau*gamma3*R*I3 */
    const double t18 = x[3]*t17; /* v_tau*(s*R*G + v_tau*gamma3*R*I3) */
    const double t19 = t18/t11; /* v_tau*(s*R*G + v_tau*gamma3*R*I3)/(s*K) */
    const double t20 = t10*t10; /* K*K */
    const double t21 = t2*t20; /* s*K*K */
    const double t22 = t17*t17; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t23 = x[0]*t22; /* gamma3*(s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t24 = t23/t21; /* t23/(s*K*K) */
    const double t25 = -t24; /* -t23/(s*K*K) */
    const double t26 = p[3]*t20; /* I1*K*K */
    const double t27 = p[4]*t17; /* I3*(s*R*G + v_tau*gamma3*R*I3) */
    const double t28 = p[1]*p[3]; /* R*I1 */
    const double t29 = x[3]*t28; /* v_tau*R*I1 */
    const double t30 = t2*t29; /* s*v_tau*R*I1 */
    const double t31 = x[0]*t12; /* gamma3*R*G */
    const double t32 = t30 - t31; /* s*v_tau*R*I1 - gamma3*R*G */
    const double t33 = t27*t32; /* I3*(s*R*G + v_tau*gamma3*R*I3)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t34 = t33/t26; /* I3*(s*R*G + v_tau*gamma3*R*I3)*(s*v_tau*R*I1 - gamma3*R*G)/(I1*K*K) */
    const double t35 = t25 - t34; /* -t23/(s*K*K) - t34 */
    const double t36 = t17*x[1]; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu */
    const double t37 = t36/t11; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu/(s*K) */
    const double t38 = p[3]*p[4]; /* I1*I3 */
    const double t39 = t10*p[0]; /* K*m */
    const double t40 = t39 + p[7]; /* Theta = K*m + I1*I3 */
    const double t41 = t11*t40; /* s*K*Theta */
    const double t42 = x[2]*p[1]; /* omega_tau*R */
    const double t43 = x[1] + t42; /* V = v_nu + omega_tau*R */
    const double t44 = t38*t43; /* I1*I3*V */
    const double t45 = t17*t44; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V */
    const double t46 = t45/t41; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V/(s*K*Theta) */
    const double t47 = t46 - t37; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V/(s*K*Theta) - (s*R*G + v_tau*gamma3*R*I3)*v_nu/(s*K) */
    const double t48 = x[2]*t15; /* omega_tau*gamma3*R*I3 */
    const double t49 = t10*t40; /* K*Theta */
    const double t50 = t48*p[8]; /* omega_tau*gamma3*R*I3*(I1 - I3) */
    const double t51 = t32*t50; /* (s*v_tau*R*I1 - gamma3*R*G)*omega_tau*gamma3*R*I3*(I1 - I3) */
    const double t52 = t51/t49; /* (s*v_tau*R*I1 - gamma3*R*G)*omega_tau*gamma3*R*I3*(I1 - I3)/(K*Theta) */
    const double t53 = t47 - t52; /* t47 - t52 */
    out[0] = t3;
    out[1] = t19;
    out[2] = t35;
    out[3] = t53;
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
    const double t10 = t6*p[4]; /* R*R*I3 */
    const double t11 = t1*t10; /* gamma3*gamma3*R*R*I3 */
    const double t12 = t9 + t11; /* K = R*R*I1*s*s + gamma3*gamma3*R*R*I3 */
    const double t13 = t3*t12; /* s*K */
    const double t14 = p[1]*p[6]; /* R*G */
    const double t15 = x[0]*t14; /* gamma3*R*G */
    const double t16 = t15/t3; /* gamma3*R*G/s */
    const double t17 = p[1]*p[4]; /* R*I3 */
    const double t18 = x[3]*t17; /* v_tau*R*I3 */
    const double t19 = t16 - t18; /* gamma3*R*G/s - v_tau*R*I3 */
    const double t20 = x[3]*t19; /* v_tau*(gamma3*R*G/s - v_tau*R*I3) */
    const double t21 = t20/t13; /* v_tau*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t22 = -t21; /* -v_tau*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t23 = t12*t12; /* K*K */
    const double t24 = t3*t23; /* s*K*K */
    const double t25 = x[0]*t7; /* gamma3*R*R*I1 */
    const double t26 = t25*2.0; /* gamma3*R*R*I1*2 */
    const double t27 = x[0]*t10; /* gamma3*R*R*I3 */
    const double t28 = 2.0*t27; /* 2*gamma3*R*R*I3 */
    const double t29 = t28 - t26; /* d(K)/d(gamma3) = 2*gamma3*R*R*I3 - gamma3*R*R*I1*2 */
    const double t30 = x[3]*t29; /* v_tau*d(K)/d(gamma3) */
    const double t31 = t3*t14; /* s*R*G */
    const double t32 = x[0]*t17; /* gamma3*R*I3 */
    const double t33 = x[3]*t32; /* v_tau*gamma3*R*I3 */
    const double t34 = t31 + t33; /* s*R*G + v_tau*gamma3*R*I3 */
    const double t35 = t30*t34; /* v_tau*d(K)/d(gamma3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t36 = t35/t24; /* v_tau*d(K)/d(gamma3)*(s*R*G + v_tau*gamma3*R*I3)/(s*K*K) */
    const double t37 = t22 - t36; /* -v_tau*(gamma3*R*G/s - v_tau*R*I3)/(s*K) - v_tau*d(K)/d(gamma3)*(s*R*G + v_tau*gamma3*R*I3)/(s*K*K) */
    const double t38 = x[0]*x[3]; /* gamma3*v_tau */
    const double t39 = t3*t8; /* s*s*s */
    const double t40 = t12*t39; /* K*s*s*s */
    const double t41 = t34*t38; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_tau */
    const double t42 = t41/t40; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_tau/(K*s*s*s) */
    const double t43 = t37 + t42; /* t37 + (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_tau/(K*s*s*s) */
    const double t44 = t34/t13; /* (s*R*G + v_tau*gamma3*R*I3)/(s*K) */
    const double t45 = t33/t13; /* v_tau*gamma3*R*I3/(s*K) */
    const double t46 = t44 + t45; /* (s*R*G + v_tau*gamma3*R*I3)/(s*K) + v_tau*gamma3*R*I3/(s*K) */
    const double t47 = t34*t34; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t48 = t47/t24; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3)/(s*K*K) */
    const double t49 = t12*t23; /* K*K*K */
    const double t50 = t3*t49; /* s*K*K*K */
    const double t51 = x[0]*t29; /* gamma3*d(K)/d(gamma3) */
    const double t52 = t47*t51; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3)*gamma3*d(K)/d(gamma3) */
    const double t53 = t52/t50; /* t52/(s*K*K*K) */
    const double t54 = 2.0*t53; /* 2*t52/(s*K*K*K) */
    const double t55 = t54 - t48; /* 2*t52/(s*K*K*K) - t48 */
    const double t56 = t23*t39; /* K*K*s*s*s */
    const double t57 = t1*t47; /* gamma3*gamma3*(s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t58 = t57/t56; /* t57/(K*K*s*s*s) */
    const double t59 = t55 - t58; /* 2*t52/(s*K*K*K) - t48 - t57/(K*K*s*s*s) */
    const double t60 = x[0]*t19; /* gamma3*(gamma3*R*G/s - v_tau*R*I3) */
    const double t61 = t34*t60; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*(gamma3*R*G/s - v_tau*R*I3) */
    const double t62 = t61/t24; /* t61/(s*K*K) */
    const double t63 = 2.0*t62; /* 2*t61/(s*K*K) */
    const double t64 = t59 + t63; /* 2*t52/(s*K*K*K) - t48 - t57/(K*K*s*s*s) + 2*t61/(s*K*K) */
    const double t65 = p[3]*t49; /* I1*K*K*K */
    const double t66 = p[4]*t29; /* I3*d(K)/d(gamma3) */
    const double t67 = t34*t66; /* (s*R*G + v_tau*gamma3*R*I3)*I3*d(K)/d(gamma3) */
    const double t68 = p[1]*p[3]; /* R*I1 */
    const double t69 = x[3]*t68; /* v_tau*R*I1 */
    const double t70 = t3*t69; /* s*v_tau*R*I1 */
    const double t71 = t70 - t15; /* s*v_tau*R*I1 - gamma3*R*G */
    const double t72 = t67*t71; /* (s*R*G + v_tau*gamma3*R*I3)*I3*d(K)/d(gamma3)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t73 = t72/t65; /* t72/(I1*K*K*K) */
    const double t74 = 2.0*t73; /* 2*t72/(I1*K*K*K) */
    const double t75 = t64 + t74; /* 2*t52/(s*K*K*K) - t48 - t57/(K*K*s*s*s) + 2*t61/(s*K*K) + 2*t72/(I1*K*K*K) */
    const double t76 = p[3]*t23; /* I1*K*K */
    const double t77 = p[4]*t19; /* I3*(gamma3*R*G/s - v_tau*R*I3) */
    const double t78 = t71*t77; /* (s*v_tau*R*I1 - gamma3*R*G)*I3*(gamma3*R*G/s - v_tau*R*I3) */
    const double t79 = t78/t76; /* (s*v_tau*R*I1 - gamma3*R*G)*I3*(gamma3*R*G/s - v_tau*R*I3)/(I1*K*K) */
    const double t80 = t75 + t79; /* t75 + t79 */
    const double t81 = x[0]*t68; /* gamma3*R*I1 */
    const double t82 = x[3]*t81; /* v_tau*gamma3*R*I1 */
    const double t83 = t82/t3; /* v_tau*gamma3*R*I1/s */
    const double t84 = p[9] + t83; /* R*G + v_tau*gamma3*R*I1/s */
    const double t85 = p[4]*t84; /* I3*(R*G + v_tau*gamma3*R*I1/s) */
    const double t86 = t34*t85; /* (s*R*G + v_tau*gamma3*R*I3)*I3*(R*G + v_tau*gamma3*R*I1/s) */
    const double t87 = t86/t76; /* (s*R*G + v_tau*gamma3*R*I3)*I3*(R*G + v_tau*gamma3*R*I1/s)/(I1*K*K) */
    const double t88 = t80 + t87; /* t75 + t79 + t87 */
    const double t89 = t1*t17; /* gamma3*gamma3*R*I3 */
    const double t90 = t34*t89; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3 */
    const double t91 = t90/t24; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(s*K*K) */
    const double t92 = 2.0*t91; /* 2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(s*K*K) */
    const double t93 = -t92; /* -2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(s*K*K) */
    const double t94 = p[4]*p[4]; /* I3*I3 */
    const double t95 = p[1]*t94; /* R*I3*I3 */
    const double t96 = x[0]*t95; /* gamma3*R*I3*I3 */
    const double t97 = t71*t96; /* (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*I3 */
    const double t98 = t97/t76; /* (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*I3/(I1*K*K) */
    const double t99 = t93 - t98; /* -2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(s*K*K) - (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*I3/(I1*K*K) */
    const double t100 = t3*t17; /* s*R*I3 */
    const double t101 = t34*t100; /* (s*R*G + v_tau*gamma3*R*I3)*s*R*I3 */
    const double t102 = t101/t23; /* (s*R*G + v_tau*gamma3*R*I3)*s*R*I3/(K*K) */
    const double t103 = t99 - t102; /* t99 - (s*R*G + v_tau*gamma3*R*I3)*s*R*I3/(K*K) */
    const double t104 = t19*x[1]; /* (gamma3*R*G/s - v_tau*R*I3)*v_nu */
    const double t105 = t104/t13; /* (gamma3*R*G/s - v_tau*R*I3)*v_nu/(s*K) */
    const double t106 = p[3]*p[4]; /* I1*I3 */
    const double t107 = t12*p[0]; /* K*m */
    const double t108 = t107 + p[7]; /* Theta = K*m + I1*I3 */
    const double t109 = t13*t108; /* s*K*Theta */
    const double t110 = x[2]*p[1]; /* omega_tau*R */
    const double t111 = x[1] + t110; /* V = v_nu + omega_tau*R */
    const double t112 = t106*t111; /* I1*I3*V */
    const double t113 = t19*t112; /* (gamma3*R*G/s - v_tau*R*I3)*I1*I3*V */
    const double t114 = t113/t109; /* (gamma3*R*G/s - v_tau*R*I3)*I1*I3*V/(s*K*Theta) */
    const double t115 = t105 - t114; /* (gamma3*R*G/s - v_tau*R*I3)*v_nu/(s*K) - (gamma3*R*G/s - v_tau*R*I3)*I1*I3*V/(s*K*Theta) */
    const double t116 = t29*x[1]; /* d(K)/d(gamma3)*v_nu */
    const double t117 = t34*t116; /* (s*R*G + v_tau*gamma3*R*I3)*d(K)/d(gamma3)*v_nu */
    const double t118 = t117/t24; /* (s*R*G + v_tau*gamma3*R*I3)*d(K)/d(gamma3)*v_nu/(s*K*K) */
    const double t119 = t115 + t118; /* t115 + (s*R*G + v_tau*gamma3*R*I3)*d(K)/d(gamma3)*v_nu/(s*K*K) */
    const double t120 = x[0]*x[1]; /* gamma3*v_nu */
    const double t121 = t34*t120; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_nu */
    const double t122 = t121/t40; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_nu/(K*s*s*s) */
    const double t123 = t119 - t122; /* t119 - (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_nu/(K*s*s*s) */
    const double t124 = t24*t108; /* s*K*K*Theta */
    const double t125 = t29*t112; /* d(K)/d(gamma3)*I1*I3*V */
    const double t126 = t34*t125; /* (s*R*G + v_tau*gamma3*R*I3)*d(K)/d(gamma3)*I1*I3*V */
    const double t127 = t126/t124; /* (s*R*G + v_tau*gamma3*R*I3)*d(K)/d(gamma3)*I1*I3*V/(s*K*K*Theta) */
    const double t128 = t123 - t127; /* t119 - (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_nu/(K*s*s*s) - t127 */
    const double t129 = p[3]*p[0]; /* I1*m */
    const double t130 = p[4]*t129; /* I3*I1*m */
    const double t131 = t108*t108; /* Theta*Theta */
    const double t132 = t13*t131; /* s*K*Theta*Theta */
    const double t133 = t111*t130; /* V*I3*I1*m */
    const double t134 = t29*t133; /* d(K)/d(gamma3)*V*I3*I1*m */
    const double t135 = t34*t134; /* (s*R*G + v_tau*gamma3*R*I3)*d(K)/d(gamma3)*V*I3*I1*m */
    const double t136 = t135/t132; /* (s*R*G + v_tau*gamma3*R*I3)*d(K)/d(gamma3)*V*I3*I1*m/(s*K*Theta*Theta) */
    const double t137 = t128 - t136; /* t128 - t136 */
    const double t138 = x[0]*t106; /* gamma3*I1*I3 */
    const double t139 = t40*t108; /* K*s*s*s*Theta */
    const double t140 = t111*t138; /* V*gamma3*I1*I3 */
    const double t141 = t34*t140; /* (s*R*G + v_tau*gamma3*R*I3)*V*gamma3*I1*I3 */
    const double t142 = t141/t139; /* (s*R*G + v_tau*gamma3*R*I3)*V*gamma3*I1*I3/(K*s*s*s*Theta) */
    const double t143 = t137 + t142; /* t128 - t136 + (s*R*G + v_tau*gamma3*R*I3)*V*gamma3*I1*I3/(K*s*s*s*Theta) */
    const double t144 = x[2]*t17; /* omega_tau*R*I3 */
    const double t145 = t12*t108; /* K*Theta */
    const double t146 = t144*p[8]; /* omega_tau*R*I3*(I1 - I3) */
    const double t147 = t71*t146; /* (s*v_tau*R*I1 - gamma3*R*G)*omega_tau*R*I3*(I1 - I3) */
    const double t148 = t147/t145; /* (s*v_tau*R*I1 - gamma3*R*G)*omega_tau*R*I3*(I1 - I3)/(K*Theta) */
    const double t149 = t143 - t148; /* t143 - t148 */
    const double t150 = x[2]*t32; /* omega_tau*gamma3*R*I3 */
    const double t151 = t23*t108; /* K*K*Theta */
    const double t152 = p[8]*t150; /* (I1 - I3)*omega_tau*gamma3*R*I3 */
    const double t153 = t29*t152; /* d(K)/d(gamma3)*(I1 - I3)*omega_tau*gamma3*R*I3 */
    const double t154 = t71*t153; /* (s*v_tau*R*I1 - gamma3*R*G)*d(K)/d(gamma3)*(I1 - I3)*omega_tau*gamma3*R*I3 */
    const double t155 = t154/t151; /* t154/(K*K*Theta) */
    const double t156 = t149 + t155; /* t143 - t148 + t154/(K*K*Theta) */
    const double t157 = p[1]*p[0]; /* R*m */
    const double t158 = p[4]*t157; /* I3*R*m */
    const double t159 = x[0]*t158; /* gamma3*I3*R*m */
    const double t160 = x[2]*t159; /* omega_tau*gamma3*I3*R*m */
    const double t161 = t12*t131; /* K*Theta*Theta */
    const double t162 = p[8]*t160; /* (I1 - I3)*omega_tau*gamma3*I3*R*m */
    const double t163 = t29*t162; /* d(K)/d(gamma3)*(I1 - I3)*omega_tau*gamma3*I3*R*m */
    const double t164 = t71*t163; /* (s*v_tau*R*I1 - gamma3*R*G)*d(K)/d(gamma3)*(I1 - I3)*omega_tau*gamma3*I3*R*m */
    const double t165 = t164/t161; /* t164/(K*Theta*Theta) */
    const double t166 = t156 + t165; /* t143 - t148 + t154/(K*K*Theta) + t164/(K*Theta*Theta) */
    const double t167 = t84*t152; /* (R*G + v_tau*gamma3*R*I1/s)*(I1 - I3)*omega_tau*gamma3*R*I3 */
    const double t168 = t167/t145; /* (R*G + v_tau*gamma3*R*I1/s)*(I1 - I3)*omega_tau*gamma3*R*I3/(K*Theta) */
    const double t169 = t166 + t168; /* t143 - t148 + t154/(K*K*Theta) + t164/(K*Theta*Theta) + t168 */
    const double t170 = t34*t106; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3 */
    const double t171 = t170/t109; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3/(s*K*Theta) */
    const double t172 = t171 - t44; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3/(s*K*Theta) - (s*R*G + v_tau*gamma3*R*I3)/(s*K) */
    const double t173 = p[4]*t68; /* I3*R*I1 */
    const double t174 = t34*t173; /* (s*R*G + v_tau*gamma3*R*I3)*I3*R*I1 */
    const double t175 = t174/t109; /* (s*R*G + v_tau*gamma3*R*I3)*I3*R*I1/(s*K*Theta) */
    const double t176 = t32*p[8]; /* gamma3*R*I3*(I1 - I3) */
    const double t177 = t71*t176; /* (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*(I1 - I3) */
    const double t178 = t177/t145; /* (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*(I1 - I3)/(K*Theta) */
    const double t179 = t175 - t178; /* (s*R*G + v_tau*gamma3*R*I3)*I3*R*I1/(s*K*Theta) - (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*(I1 - I3)/(K*Theta) */
    const double t180 = t32*x[1]; /* gamma3*R*I3*v_nu */
    const double t181 = t180/t13; /* gamma3*R*I3*v_nu/(s*K) */
    const double t182 = t68*t94; /* R*I1*I3*I3 */
    const double t183 = x[0]*t182; /* gamma3*R*I1*I3*I3 */
    const double t184 = t111*t183; /* V*gamma3*R*I1*I3*I3 */
    const double t185 = t184/t109; /* V*gamma3*R*I1*I3*I3/(s*K*Theta) */
    const double t186 = t185 - t181; /* V*gamma3*R*I1*I3*I3/(s*K*Theta) - gamma3*R*I3*v_nu/(s*K) */
    const double t187 = t7*p[4]; /* R*R*I1*I3 */
    const double t188 = x[0]*t187; /* gamma3*R*R*I1*I3 */
    const double t189 = x[2]*t188; /* omega_tau*gamma3*R*R*I1*I3 */
    const double t190 = t3*t189; /* s*omega_tau*gamma3*R*R*I1*I3 */
    const double t191 = p[8]*t190; /* (I1 - I3)*s*omega_tau*gamma3*R*R*I1*I3 */
    const double t192 = t191/t145; /* (I1 - I3)*s*omega_tau*gamma3*R*R*I1*I3/(K*Theta) */
    const double t193 = t186 - t192; /* V*gamma3*R*I1*I3*I3/(s*K*Theta) - gamma3*R*I3*v_nu/(s*K) - (I1 - I3)*s*omega_tau*gamma3*R*R*I1*I3/(K*Theta) */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t43;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t46;
    out[8] = t88;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t103;
    out[12] = t169;
    out[13] = t172;
    out[14] = t179;
    out[15] = t193;
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
    const double t8 = t4*p[4]; /* R*R*I3 */
    const double t9 = t0*t8; /* gamma3*gamma3*R*R*I3 */
    const double t10 = t7 + t9; /* K = R*R*I1*s*s + gamma3*gamma3*R*R*I3 */
    const double t11 = t2*t10; /* s*K */
    const double t12 = p[1]*p[6]; /* R*G */
    const double t13 = t2*t12; /* s*R*G */
    const double t14 = p[1]*p[4]; /* R*I3 */
    const double t15 = x[0]*t14; /* gamma3*R*I3 */
    const double t16 = x[3]*t15; /* v_tau*gamma3*R*I3 */
    const double t17 = t13 + t16; /* s*R*G + v_tau*gamma3*R*I3 */
    const double t18 = x[3]*t17; /* v_tau*(s*R*G + v_tau*gamma3*R*I3) */
    const double t19 = t18/t11; /* v_tau*(s*R*G + v_tau*gamma3*R*I3)/(s*K) */
    const double t20 = t10*t10; /* K*K */
    const double t21 = t2*t20; /* s*K*K */
    const double t22 = t17*t17; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t23 = x[0]*t22; /* gamma3*(s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t24 = t23/t21; /* t23/(s*K*K) */
    const double t25 = -t24; /* -t23/(s*K*K) */
    const double t26 = p[3]*t20; /* I1*K*K */
    const double t27 = p[4]*t17; /* I3*(s*R*G + v_tau*gamma3*R*I3) */
    const double t28 = p[1]*p[3]; /* R*I1 */
    const double t29 = x[3]*t28; /* v_tau*R*I1 */
    const double t30 = t2*t29; /* s*v_tau*R*I1 */
    const double t31 = x[0]*t12; /* gamma3*R*G */
    const double t32 = t30 - t31; /* s*v_tau*R*I1 - gamma3*R*G */
    const double t33 = t27*t32; /* I3*(s*R*G + v_tau*gamma3*R*I3)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t34 = t33/t26; /* I3*(s*R*G + v_tau*gamma3*R*I3)*(s*v_tau*R*I1 - gamma3*R*G)/(I1*K*K) */
    const double t35 = t25 - t34; /* -t23/(s*K*K) - t34 */
    const double t36 = t17*x[1]; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu */
    const double t37 = t36/t11; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu/(s*K) */
    const double t38 = p[3]*p[4]; /* I1*I3 */
    const double t39 = t10*p[0]; /* K*m */
    const double t40 = t39 + p[7]; /* Theta = K*m + I1*I3 */
    const double t41 = t11*t40; /* s*K*Theta */
    const double t42 = x[2]*p[1]; /* omega_tau*R */
    const double t43 = x[1] + t42; /* V = v_nu + omega_tau*R */
    const double t44 = t38*t43; /* I1*I3*V */
    const double t45 = t17*t44; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V */
    const double t46 = t45/t41; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V/(s*K*Theta) */
    const double t47 = t46 - t37; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V/(s*K*Theta) - (s*R*G + v_tau*gamma3*R*I3)*v_nu/(s*K) */
    const double t48 = x[2]*t15; /* omega_tau*gamma3*R*I3 */
    const double t49 = t10*t40; /* K*Theta */
    const double t50 = t48*p[8]; /* omega_tau*gamma3*R*I3*(I1 - I3) */
    const double t51 = t32*t50; /* (s*v_tau*R*I1 - gamma3*R*G)*omega_tau*gamma3*R*I3*(I1 - I3) */
    const double t52 = t51/t49; /* (s*v_tau*R*I1 - gamma3*R*G)*omega_tau*gamma3*R*I3*(I1 - I3)/(K*Theta) */
    const double t53 = t47 - t52; /* t47 - t52 */
    const double t54 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t55 = t54/t2; /* omega_tau*gamma3/s */
    const double t56 = -t55; /* -omega_tau*gamma3/s */
    const double t57 = t31/t2; /* gamma3*R*G/s */
    const double t58 = x[3]*t14; /* v_tau*R*I3 */
    const double t59 = t57 - t58; /* gamma3*R*G/s - v_tau*R*I3 */
    const double t60 = x[3]*t59; /* v_tau*(gamma3*R*G/s - v_tau*R*I3) */
    const double t61 = t60/t11; /* v_tau*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t62 = -t61; /* -v_tau*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t63 = x[0]*t5; /* gamma3*R*R*I1 */
    const double t64 = t63*2.0; /* gamma3*R*R*I1*2 */
    const double t65 = x[0]*t8; /* gamma3*R*R*I3 */
    const double t66 = 2.0*t65; /* 2*gamma3*R*R*I3 */
    const double t67 = t66 - t64; /* d(K)/d(gamma3) = 2*gamma3*R*R*I3 - gamma3*R*R*I1*2 */
    const double t68 = x[3]*t67; /* v_tau*d(K)/d(gamma3) */
    const double t69 = t17*t68; /* (s*R*G + v_tau*gamma3*R*I3)*v_tau*d(K)/d(gamma3) */
    const double t70 = t69/t21; /* (s*R*G + v_tau*gamma3*R*I3)*v_tau*d(K)/d(gamma3)/(s*K*K) */
    const double t71 = t62 - t70; /* -v_tau*(gamma3*R*G/s - v_tau*R*I3)/(s*K) - (s*R*G + v_tau*gamma3*R*I3)*v_tau*d(K)/d(gamma3)/(s*K*K) */
    const double t72 = x[0]*x[3]; /* gamma3*v_tau */
    const double t73 = t2*t6; /* s*s*s */
    const double t74 = t10*t73; /* K*s*s*s */
    const double t75 = t17*t72; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_tau */
    const double t76 = t75/t74; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_tau/(K*s*s*s) */
    const double t77 = t71 + t76; /* t71 + (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_tau/(K*s*s*s) */
    const double t78 = t17/t11; /* (s*R*G + v_tau*gamma3*R*I3)/(s*K) */
    const double t79 = t16/t11; /* v_tau*gamma3*R*I3/(s*K) */
    const double t80 = t78 + t79; /* (s*R*G + v_tau*gamma3*R*I3)/(s*K) + v_tau*gamma3*R*I3/(s*K) */
    const double t81 = t22/t21; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3)/(s*K*K) */
    const double t82 = t10*t20; /* K*K*K */
    const double t83 = t2*t82; /* s*K*K*K */
    const double t84 = x[0]*t67; /* gamma3*d(K)/d(gamma3) */
    const double t85 = t22*t84; /* (s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3)*gamma3*d(K)/d(gamma3) */
    const double t86 = t85/t83; /* t85/(s*K*K*K) */
    const double t87 = 2.0*t86; /* 2*t85/(s*K*K*K) */
    const double t88 = t87 - t81; /* 2*t85/(s*K*K*K) - t81 */
    const double t89 = t20*t73; /* K*K*s*s*s */
    const double t90 = t0*t22; /* gamma3*gamma3*(s*R*G + v_tau*gamma3*R*I3)*(s*R*G + v_tau*gamma3*R*I3) */
    const double t91 = t90/t89; /* t90/(K*K*s*s*s) */
    const double t92 = t88 - t91; /* 2*t85/(s*K*K*K) - t81 - t90/(K*K*s*s*s) */
    const double t93 = x[0]*t59; /* gamma3*(gamma3*R*G/s - v_tau*R*I3) */
    const double t94 = t17*t93; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*(gamma3*R*G/s - v_tau*R*I3) */
    const double t95 = t94/t21; /* t94/(s*K*K) */
    const double t96 = 2.0*t95; /* 2*t94/(s*K*K) */
    const double t97 = t92 + t96; /* 2*t85/(s*K*K*K) - t81 - t90/(K*K*s*s*s) + 2*t94/(s*K*K) */
    const double t98 = p[3]*t82; /* I1*K*K*K */
    const double t99 = p[4]*t67; /* I3*d(K)/d(gamma3) */
    const double t100 = t17*t99; /* (s*R*G + v_tau*gamma3*R*I3)*I3*d(K)/d(gamma3) */
    const double t101 = t32*t100; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*R*G + v_tau*gamma3*R*I3)*I3*d(K)/d(gamma3) */
    const double t102 = t101/t98; /* t101/(I1*K*K*K) */
    const double t103 = 2.0*t102; /* 2*t101/(I1*K*K*K) */
    const double t104 = t97 + t103; /* 2*t85/(s*K*K*K) - t81 - t90/(K*K*s*s*s) + 2*t94/(s*K*K) + 2*t101/(I1*K*K*K) */
    const double t105 = p[4]*t59; /* I3*(gamma3*R*G/s - v_tau*R*I3) */
    const double t106 = t32*t105; /* (s*v_tau*R*I1 - gamma3*R*G)*I3*(gamma3*R*G/s - v_tau*R*I3) */
    const double t107 = t106/t26; /* (s*v_tau*R*I1 - gamma3*R*G)*I3*(gamma3*R*G/s - v_tau*R*I3)/(I1*K*K) */
    const double t108 = t104 + t107; /* t104 + t107 */
    const double t109 = x[0]*t28; /* gamma3*R*I1 */
    const double t110 = x[3]*t109; /* v_tau*gamma3*R*I1 */
    const double t111 = t110/t2; /* v_tau*gamma3*R*I1/s */
    const double t112 = p[9] + t111; /* R*G + v_tau*gamma3*R*I1/s */
    const double t113 = p[4]*t112; /* I3*(R*G + v_tau*gamma3*R*I1/s) */
    const double t114 = t17*t113; /* (s*R*G + v_tau*gamma3*R*I3)*I3*(R*G + v_tau*gamma3*R*I1/s) */
    const double t115 = t114/t26; /* (s*R*G + v_tau*gamma3*R*I3)*I3*(R*G + v_tau*gamma3*R*I1/s)/(I1*K*K) */
    const double t116 = t108 + t115; /* t104 + t107 + t115 */
    const double t117 = t0*t14; /* gamma3*gamma3*R*I3 */
    const double t118 = t17*t117; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3 */
    const double t119 = t118/t21; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(s*K*K) */
    const double t120 = 2.0*t119; /* 2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(s*K*K) */
    const double t121 = -t120; /* -2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(s*K*K) */
    const double t122 = p[4]*p[4]; /* I3*I3 */
    const double t123 = p[1]*t122; /* R*I3*I3 */
    const double t124 = x[0]*t123; /* gamma3*R*I3*I3 */
    const double t125 = t32*t124; /* (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*I3 */
    const double t126 = t125/t26; /* (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*I3/(I1*K*K) */
    const double t127 = t121 - t126; /* -2*(s*R*G + v_tau*gamma3*R*I3)*gamma3*gamma3*R*I3/(s*K*K) - (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*I3/(I1*K*K) */
    const double t128 = t2*t14; /* s*R*I3 */
    const double t129 = t17*t128; /* (s*R*G + v_tau*gamma3*R*I3)*s*R*I3 */
    const double t130 = t129/t20; /* (s*R*G + v_tau*gamma3*R*I3)*s*R*I3/(K*K) */
    const double t131 = t127 - t130; /* t127 - (s*R*G + v_tau*gamma3*R*I3)*s*R*I3/(K*K) */
    const double t132 = x[1]*t59; /* v_nu*(gamma3*R*G/s - v_tau*R*I3) */
    const double t133 = t132/t11; /* v_nu*(gamma3*R*G/s - v_tau*R*I3)/(s*K) */
    const double t134 = t44*t59; /* I1*I3*V*(gamma3*R*G/s - v_tau*R*I3) */
    const double t135 = t134/t41; /* I1*I3*V*(gamma3*R*G/s - v_tau*R*I3)/(s*K*Theta) */
    const double t136 = t133 - t135; /* v_nu*(gamma3*R*G/s - v_tau*R*I3)/(s*K) - I1*I3*V*(gamma3*R*G/s - v_tau*R*I3)/(s*K*Theta) */
    const double t137 = x[1]*t67; /* v_nu*d(K)/d(gamma3) */
    const double t138 = t17*t137; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu*d(K)/d(gamma3) */
    const double t139 = t138/t21; /* (s*R*G + v_tau*gamma3*R*I3)*v_nu*d(K)/d(gamma3)/(s*K*K) */
    const double t140 = t136 + t139; /* t136 + (s*R*G + v_tau*gamma3*R*I3)*v_nu*d(K)/d(gamma3)/(s*K*K) */
    const double t141 = x[0]*x[1]; /* gamma3*v_nu */
    const double t142 = t17*t141; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_nu */
    const double t143 = t142/t74; /* (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_nu/(K*s*s*s) */
    const double t144 = t140 - t143; /* t140 - (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_nu/(K*s*s*s) */
    const double t145 = t21*t40; /* s*K*K*Theta */
    const double t146 = t44*t67; /* I1*I3*V*d(K)/d(gamma3) */
    const double t147 = t17*t146; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V*d(K)/d(gamma3) */
    const double t148 = t147/t145; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3*V*d(K)/d(gamma3)/(s*K*K*Theta) */
    const double t149 = t144 - t148; /* t140 - (s*R*G + v_tau*gamma3*R*I3)*gamma3*v_nu/(K*s*s*s) - t148 */
    const double t150 = p[3]*p[0]; /* I1*m */
    const double t151 = p[4]*t150; /* I3*I1*m */
    const double t152 = t40*t40; /* Theta*Theta */
    const double t153 = t11*t152; /* s*K*Theta*Theta */
    const double t154 = t43*t151; /* V*I3*I1*m */
    const double t155 = t67*t154; /* d(K)/d(gamma3)*V*I3*I1*m */
    const double t156 = t17*t155; /* (s*R*G + v_tau*gamma3*R*I3)*d(K)/d(gamma3)*V*I3*I1*m */
    const double t157 = t156/t153; /* (s*R*G + v_tau*gamma3*R*I3)*d(K)/d(gamma3)*V*I3*I1*m/(s*K*Theta*Theta) */
    const double t158 = t149 - t157; /* t149 - t157 */
    const double t159 = x[0]*t38; /* gamma3*I1*I3 */
    const double t160 = t40*t74; /* Theta*K*s*s*s */
    const double t161 = t43*t159; /* V*gamma3*I1*I3 */
    const double t162 = t17*t161; /* (s*R*G + v_tau*gamma3*R*I3)*V*gamma3*I1*I3 */
    const double t163 = t162/t160; /* (s*R*G + v_tau*gamma3*R*I3)*V*gamma3*I1*I3/(Theta*K*s*s*s) */
    const double t164 = t158 + t163; /* t149 - t157 + (s*R*G + v_tau*gamma3*R*I3)*V*gamma3*I1*I3/(Theta*K*s*s*s) */
    const double t165 = x[2]*t14; /* omega_tau*R*I3 */
    const double t166 = p[8]*t165; /* (I1 - I3)*omega_tau*R*I3 */
    const double t167 = t32*t166; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*omega_tau*R*I3 */
    const double t168 = t167/t49; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*omega_tau*R*I3/(K*Theta) */
    const double t169 = t164 - t168; /* t164 - t168 */
    const double t170 = t20*t40; /* K*K*Theta */
    const double t171 = t50*t67; /* omega_tau*gamma3*R*I3*(I1 - I3)*d(K)/d(gamma3) */
    const double t172 = t32*t171; /* (s*v_tau*R*I1 - gamma3*R*G)*omega_tau*gamma3*R*I3*(I1 - I3)*d(K)/d(gamma3) */
    const double t173 = t172/t170; /* t172/(K*K*Theta) */
    const double t174 = t169 + t173; /* t164 - t168 + t172/(K*K*Theta) */
    const double t175 = p[1]*p[0]; /* R*m */
    const double t176 = p[4]*t175; /* I3*R*m */
    const double t177 = x[0]*t176; /* gamma3*I3*R*m */
    const double t178 = x[2]*t177; /* omega_tau*gamma3*I3*R*m */
    const double t179 = t10*t152; /* K*Theta*Theta */
    const double t180 = p[8]*t178; /* (I1 - I3)*omega_tau*gamma3*I3*R*m */
    const double t181 = t67*t180; /* d(K)/d(gamma3)*(I1 - I3)*omega_tau*gamma3*I3*R*m */
    const double t182 = t32*t181; /* (s*v_tau*R*I1 - gamma3*R*G)*d(K)/d(gamma3)*(I1 - I3)*omega_tau*gamma3*I3*R*m */
    const double t183 = t182/t179; /* t182/(K*Theta*Theta) */
    const double t184 = t174 + t183; /* t164 - t168 + t172/(K*K*Theta) + t182/(K*Theta*Theta) */
    const double t185 = t50*t112; /* omega_tau*gamma3*R*I3*(I1 - I3)*(R*G + v_tau*gamma3*R*I1/s) */
    const double t186 = t185/t49; /* omega_tau*gamma3*R*I3*(I1 - I3)*(R*G + v_tau*gamma3*R*I1/s)/(K*Theta) */
    const double t187 = t184 + t186; /* t164 - t168 + t172/(K*K*Theta) + t182/(K*Theta*Theta) + t186 */
    const double t188 = t17*t38; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3 */
    const double t189 = t188/t41; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3/(s*K*Theta) */
    const double t190 = t189 - t78; /* (s*R*G + v_tau*gamma3*R*I3)*I1*I3/(s*K*Theta) - (s*R*G + v_tau*gamma3*R*I3)/(s*K) */
    const double t191 = p[4]*t28; /* I3*R*I1 */
    const double t192 = t17*t191; /* (s*R*G + v_tau*gamma3*R*I3)*I3*R*I1 */
    const double t193 = t192/t41; /* (s*R*G + v_tau*gamma3*R*I3)*I3*R*I1/(s*K*Theta) */
    const double t194 = t15*p[8]; /* gamma3*R*I3*(I1 - I3) */
    const double t195 = t32*t194; /* (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*(I1 - I3) */
    const double t196 = t195/t49; /* (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*(I1 - I3)/(K*Theta) */
    const double t197 = t193 - t196; /* (s*R*G + v_tau*gamma3*R*I3)*I3*R*I1/(s*K*Theta) - (s*v_tau*R*I1 - gamma3*R*G)*gamma3*R*I3*(I1 - I3)/(K*Theta) */
    const double t198 = t15*x[1]; /* gamma3*R*I3*v_nu */
    const double t199 = t198/t11; /* gamma3*R*I3*v_nu/(s*K) */
    const double t200 = t28*t122; /* R*I1*I3*I3 */
    const double t201 = x[0]*t200; /* gamma3*R*I1*I3*I3 */
    const double t202 = t43*t201; /* V*gamma3*R*I1*I3*I3 */
    const double t203 = t202/t41; /* V*gamma3*R*I1*I3*I3/(s*K*Theta) */
    const double t204 = t203 - t199; /* V*gamma3*R*I1*I3*I3/(s*K*Theta) - gamma3*R*I3*v_nu/(s*K) */
    const double t205 = t5*p[4]; /* R*R*I1*I3 */
    const double t206 = x[0]*t205; /* gamma3*R*R*I1*I3 */
    const double t207 = x[2]*t206; /* omega_tau*gamma3*R*R*I1*I3 */
    const double t208 = t2*t207; /* s*omega_tau*gamma3*R*R*I1*I3 */
    const double t209 = p[8]*t208; /* (I1 - I3)*s*omega_tau*gamma3*R*R*I1*I3 */
    const double t210 = t209/t49; /* (I1 - I3)*s*omega_tau*gamma3*R*R*I1*I3/(K*Theta) */
    const double t211 = t204 - t210; /* V*gamma3*R*I1*I3*I3/(s*K*Theta) - gamma3*R*I3*v_nu/(s*K) - (I1 - I3)*s*omega_tau*gamma3*R*R*I1*I3/(K*Theta) */
    out[0] = t3;
    out[1] = t19;
    out[2] = t35;
    out[3] = t53;
    out[4] = t56;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = t77;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t80;
    out[12] = t116;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t131;
    out[16] = t187;
    out[17] = t190;
    out[18] = t197;
    out[19] = t211;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = -t4; /* -gamma3*omega_tau/s */
    const double t6 = p[1]*p[4]; /* R*I3 */
    const double t7 = x[0]*t6; /* gamma3*R*I3 */
    const double t8 = t7*x[1]; /* gamma3*R*I3*v_nu */
    const double t9 = p[1]*p[1]; /* R*R */
    const double t10 = t9*p[3]; /* R*R*I1 */
    const double t11 = t3*t3; /* s*s */
    const double t12 = t10*t11; /* R*R*I1*s*s */
    const double t13 = p[4]*t9; /* I3*R*R */
    const double t14 = t1*t13; /* gamma3*gamma3*I3*R*R */
    const double t15 = t12 + t14; /* K = R*R*I1*s*s + gamma3*gamma3*I3*R*R */
    const double t16 = t3*t15; /* s*K */
    const double t17 = t8/t16; /* gamma3*R*I3*v_nu/(s*K) */
    const double t18 = t5 - t17; /* -gamma3*omega_tau/s - gamma3*R*I3*v_nu/(s*K) */
    const double t19 = p[1]*p[3]; /* R*I1 */
    const double t20 = p[4]*p[4]; /* I3*I3 */
    const double t21 = t19*t20; /* R*I1*I3*I3 */
    const double t22 = x[0]*t21; /* gamma3*R*I1*I3*I3 */
    const double t23 = t15*p[0]; /* K*m */
    const double t24 = t23 + p[7]; /* Theta = K*m + I1*I3 */
    const double t25 = t16*t24; /* s*K*Theta */
    const double t26 = x[2]*p[1]; /* omega_tau*R */
    const double t27 = x[1] + t26; /* V = v_nu + omega_tau*R */
    const double t28 = t22*t27; /* gamma3*R*I1*I3*I3*V */
    const double t29 = t28/t25; /* gamma3*R*I1*I3*I3*V/(s*K*Theta) */
    const double t30 = t18 + t29; /* -gamma3*omega_tau/s - gamma3*R*I3*v_nu/(s*K) + gamma3*R*I1*I3*I3*V/(s*K*Theta) */
    const double t31 = p[4]*t10; /* I3*R*R*I1 */
    const double t32 = x[0]*t31; /* gamma3*I3*R*R*I1 */
    const double t33 = x[2]*t32; /* omega_tau*gamma3*I3*R*R*I1 */
    const double t34 = t3*t33; /* s*omega_tau*gamma3*I3*R*R*I1 */
    const double t35 = t15*t24; /* K*Theta */
    const double t36 = t34*p[8]; /* s*omega_tau*gamma3*I3*R*R*I1*(I1 - I3) */
    const double t37 = t36/t35; /* s*omega_tau*gamma3*I3*R*R*I1*(I1 - I3)/(K*Theta) */
    const double t38 = t30 - t37; /* t30 - s*omega_tau*gamma3*I3*R*R*I1*(I1 - I3)/(K*Theta) */
    out[0] = t38;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[0]*t0; /* m*v_nu*v_nu */
    const double t2 = t1*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t3 = x[3]*x[3]; /* v_tau*v_tau */
    const double t4 = p[1]*p[1]; /* R*R */
    const double t5 = t4*p[3]; /* R*R*I1 */
    const double t6 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t7 = 1.0 - t6; /* 1 - gamma3*gamma3 */
    const double t8 = sqrt(t7); /* s = sqrt(1 - gamma3*gamma3) */
    const double t9 = t8*t8; /* s*s */
    const double t10 = t5*t9; /* R*R*I1*s*s */
    const double t11 = t4*p[4]; /* R*R*I3 */
    const double t12 = t6*t11; /* gamma3*gamma3*R*R*I3 */
    const double t13 = t10 + t12; /* K = R*R*I1*s*s + gamma3*gamma3*R*R*I3 */
    const double t14 = p[0]*t13; /* m*K */
    const double t15 = t14 + p[7]; /* Theta = m*K + I1*I3 */
    const double t16 = t3*t15; /* v_tau*v_tau*Theta */
    const double t17 = t16/t13; /* v_tau*v_tau*Theta/K */
    const double t18 = (1.0 / 2.0)*t17; /* 1/2*v_tau*v_tau*Theta/K */
    const double t19 = t2 + t18; /* m*v_nu*v_nu*1/2 + 1/2*v_tau*v_tau*Theta/K */
    const double t20 = p[6]*p[6]; /* G*G */
    const double t21 = t20/t13; /* G*G/K */
    const double t22 = (1.0 / 2.0)*t21; /* 1/2*G*G/K */
    const double t23 = t19 + t22; /* m*v_nu*v_nu*1/2 + 1/2*v_tau*v_tau*Theta/K + 1/2*G*G/K */
    const double t24 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t25 = p[3]*t24; /* I1*omega_tau*omega_tau */
    const double t26 = (1.0 / 2.0)*t25; /* 1/2*I1*omega_tau*omega_tau */
    const double t27 = t23 + t26; /* m*v_nu*v_nu*1/2 + 1/2*v_tau*v_tau*Theta/K + 1/2*G*G/K + 1/2*I1*omega_tau*omega_tau */
    const double t28 = p[3]*p[3]; /* I1*I1 */
    const double t29 = p[0]*t28; /* m*I1*I1 */
    const double t30 = p[1]*x[2]; /* R*omega_tau */
    const double t31 = x[1] + t30; /* v_nu + R*omega_tau */
    const double t32 = t31*t31; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t33 = t29*t32; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t34 = t13*t13; /* K*K */
    const double t35 = t15*p[8]; /* Theta*(I1 - I3) */
    const double t36 = p[1]*p[3]; /* R*I1 */
    const double t37 = x[3]*t36; /* v_tau*R*I1 */
    const double t38 = t8*t37; /* s*v_tau*R*I1 */
    const double t39 = p[1]*p[6]; /* R*G */
    const double t40 = x[0]*t39; /* gamma3*R*G */
    const double t41 = t38 - t40; /* s*v_tau*R*I1 - gamma3*R*G */
    const double t42 = t41*t41; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t43 = t35*t42; /* Theta*(I1 - I3)*(s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t44 = t43/t34; /* t43/(K*K) */
    const double t45 = t33 + t44; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) + t43/(K*K) */
    out[0] = t27;
    out[1] = t45;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*x[3]; /* v_tau*v_tau */
    const double t1 = p[1]*p[1]; /* R*R */
    const double t2 = t1*p[3]; /* R*R*I1 */
    const double t3 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t4 = 1.0 - t3; /* 1 - gamma3*gamma3 */
    const double t5 = sqrt(t4); /* s = sqrt(1 - gamma3*gamma3) */
    const double t6 = t5*t5; /* s*s */
    const double t7 = t2*t6; /* R*R*I1*s*s */
    const double t8 = t1*p[4]; /* R*R*I3 */
    const double t9 = t3*t8; /* gamma3*gamma3*R*R*I3 */
    const double t10 = t7 + t9; /* K = R*R*I1*s*s + gamma3*gamma3*R*R*I3 */
    const double t11 = t10*t10; /* K*K */
    const double t12 = t10*p[0]; /* K*m */
    const double t13 = t12 + p[7]; /* Theta = K*m + I1*I3 */
    const double t14 = t0*t13; /* v_tau*v_tau*Theta */
    const double t15 = t2*x[0]; /* R*R*I1*gamma3 */
    const double t16 = t15*2.0; /* R*R*I1*gamma3*2 */
    const double t17 = x[0]*t8; /* gamma3*R*R*I3 */
    const double t18 = 2.0*t17; /* 2*gamma3*R*R*I3 */
    const double t19 = t18 - t16; /* d(K)/d(gamma3) = 2*gamma3*R*R*I3 - R*R*I1*gamma3*2 */
    const double t20 = t14*t19; /* v_tau*v_tau*Theta*d(K)/d(gamma3) */
    const double t21 = t20/t11; /* v_tau*v_tau*Theta*d(K)/d(gamma3)/(K*K) */
    const double t22 = t21*(1.0 / 2.0); /* v_tau*v_tau*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t23 = t0*p[0]; /* v_tau*v_tau*m */
    const double t24 = t19*t23; /* d(K)/d(gamma3)*v_tau*v_tau*m */
    const double t25 = t24/t10; /* d(K)/d(gamma3)*v_tau*v_tau*m/K */
    const double t26 = (1.0 / 2.0)*t25; /* 1/2*d(K)/d(gamma3)*v_tau*v_tau*m/K */
    const double t27 = t26 - t22; /* 1/2*d(K)/d(gamma3)*v_tau*v_tau*m/K - v_tau*v_tau*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t28 = p[6]*p[6]; /* G*G */
    const double t29 = t19*t28; /* d(K)/d(gamma3)*G*G */
    const double t30 = t29/t11; /* d(K)/d(gamma3)*G*G/(K*K) */
    const double t31 = (1.0 / 2.0)*t30; /* 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t32 = t27 - t31; /* t27 - 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t33 = p[0]*x[1]; /* m*v_nu */
    const double t34 = p[3]*x[2]; /* I1*omega_tau */
    const double t35 = x[3]*t13; /* v_tau*Theta */
    const double t36 = t35/t10; /* v_tau*Theta/K */
    const double t37 = t10*t11; /* K*K*K */
    const double t38 = t13*p[8]; /* Theta*(I1 - I3) */
    const double t39 = t19*t38; /* d(K)/d(gamma3)*Theta*(I1 - I3) */
    const double t40 = p[1]*p[3]; /* R*I1 */
    const double t41 = x[3]*t40; /* v_tau*R*I1 */
    const double t42 = t5*t41; /* s*v_tau*R*I1 */
    const double t43 = p[1]*p[6]; /* R*G */
    const double t44 = x[0]*t43; /* gamma3*R*G */
    const double t45 = t42 - t44; /* s*v_tau*R*I1 - gamma3*R*G */
    const double t46 = t45*t45; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t47 = t39*t46; /* d(K)/d(gamma3)*Theta*(I1 - I3)*(s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G) */
    const double t48 = t47/t37; /* t47/(K*K*K) */
    const double t49 = 2.0*t48; /* 2*t47/(K*K*K) */
    const double t50 = p[0]*p[8]; /* m*(I1 - I3) */
    const double t51 = t19*t50; /* d(K)/d(gamma3)*m*(I1 - I3) */
    const double t52 = t46*t51; /* (s*v_tau*R*I1 - gamma3*R*G)*(s*v_tau*R*I1 - gamma3*R*G)*d(K)/d(gamma3)*m*(I1 - I3) */
    const double t53 = t52/t11; /* t52/(K*K) */
    const double t54 = t53 - t49; /* t52/(K*K) - 2*t47/(K*K*K) */
    const double t55 = x[0]*t40; /* gamma3*R*I1 */
    const double t56 = x[3]*t55; /* v_tau*gamma3*R*I1 */
    const double t57 = t56/t5; /* v_tau*gamma3*R*I1/s */
    const double t58 = p[9] + t57; /* R*G + v_tau*gamma3*R*I1/s */
    const double t59 = t38*t58; /* Theta*(I1 - I3)*(R*G + v_tau*gamma3*R*I1/s) */
    const double t60 = t45*t59; /* (s*v_tau*R*I1 - gamma3*R*G)*Theta*(I1 - I3)*(R*G + v_tau*gamma3*R*I1/s) */
    const double t61 = t60/t11; /* t60/(K*K) */
    const double t62 = 2.0*t61; /* 2*t60/(K*K) */
    const double t63 = t54 - t62; /* t52/(K*K) - 2*t47/(K*K*K) - 2*t60/(K*K) */
    const double t64 = p[0]*2.0; /* m*2 */
    const double t65 = p[3]*p[3]; /* I1*I1 */
    const double t66 = t64*t65; /* m*2*I1*I1 */
    const double t67 = p[1]*x[2]; /* R*omega_tau */
    const double t68 = x[1] + t67; /* v_nu + R*omega_tau */
    const double t69 = t66*t68; /* m*2*I1*I1*(v_nu + R*omega_tau) */
    const double t70 = p[1]*t64; /* R*m*2 */
    const double t71 = t65*t70; /* I1*I1*R*m*2 */
    const double t72 = t68*t71; /* (v_nu + R*omega_tau)*I1*I1*R*m*2 */
    const double t73 = p[1]*2.0; /* R*2 */
    const double t74 = p[3]*t73; /* I1*R*2 */
    const double t75 = t5*t74; /* s*I1*R*2 */
    const double t76 = t13*t75; /* Theta*s*I1*R*2 */
    const double t77 = p[8]*t76; /* (I1 - I3)*Theta*s*I1*R*2 */
    const double t78 = t45*t77; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*s*I1*R*2 */
    const double t79 = t78/t11; /* (s*v_tau*R*I1 - gamma3*R*G)*(I1 - I3)*Theta*s*I1*R*2/(K*K) */
    out[0] = t32;
    out[1] = t33;
    out[2] = t34;
    out[3] = t36;
    out[4] = t63;
    out[5] = t69;
    out[6] = t72;
    out[7] = t79;
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
    const double v_a3 = (0.0);
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
    const double t0 = x[0]*params[4]; /* gamma3*I3 */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = params[6]*t3; /* G*s */
    const double t5 = t4/t0; /* G*s/(gamma3*I3) */
    const double t6 = -t5; /* v_tau = -G*s/(gamma3*I3) */
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    out[3] = t6;
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
    const double t11 = params[4]*t7; /* I3*R*R */
    const double t12 = t4*t11; /* gamma3*gamma3*I3*R*R */
    const double t13 = t10 + t12; /* K = R*R*I1*s*s + gamma3*gamma3*I3*R*R */
    const double t14 = params[0]*t13; /* m*K */
    const double t15 = params[4]*params[3]; /* I3*I1 */
    const double t16 = t14 + t15; /* Theta = m*K + I3*I1 */
    const double t17 = t6*t16; /* s*Theta */
    const double t18 = t3/t17; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t19 = -t18; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t19;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[4]*x[0]; /* I3*gamma3 */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = params[6]*t3; /* G*s */
    const double t5 = t4/t0; /* G*s/(I3*gamma3) */
    const double t6 = t5*t5; /* G*s/(I3*gamma3)*G*s/(I3*gamma3) */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = t7*params[3]; /* R*R*I1 */
    const double t9 = t3*t3; /* s*s */
    const double t10 = t8*t9; /* R*R*I1*s*s */
    const double t11 = params[4]*t7; /* I3*R*R */
    const double t12 = t1*t11; /* gamma3*gamma3*I3*R*R */
    const double t13 = t10 + t12; /* K = R*R*I1*s*s + gamma3*gamma3*I3*R*R */
    const double t14 = t13*t13; /* K*K */
    const double t15 = t13*params[0]; /* K*m */
    const double t16 = params[4]*params[3]; /* I3*I1 */
    const double t17 = t15 + t16; /* Theta = K*m + I3*I1 */
    const double t18 = t6*t17; /* G*s/(I3*gamma3)*G*s/(I3*gamma3)*Theta */
    const double t19 = x[0]*t8; /* gamma3*R*R*I1 */
    const double t20 = t19*2.0; /* gamma3*R*R*I1*2 */
    const double t21 = x[0]*t11; /* gamma3*I3*R*R */
    const double t22 = 2.0*t21; /* 2*gamma3*I3*R*R */
    const double t23 = t22 - t20; /* d(K)/d(gamma3) = 2*gamma3*I3*R*R - gamma3*R*R*I1*2 */
    const double t24 = t18*t23; /* G*s/(I3*gamma3)*G*s/(I3*gamma3)*Theta*d(K)/d(gamma3) */
    const double t25 = t24/t14; /* G*s/(I3*gamma3)*G*s/(I3*gamma3)*Theta*d(K)/d(gamma3)/(K*K) */
    const double t26 = t25*(1.0 / 2.0); /* G*s/(I3*gamma3)*G*s/(I3*gamma3)*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t27 = t6*params[0]; /* G*s/(I3*gamma3)*G*s/(I3*gamma3)*m */
    const double t28 = t23*t27; /* d(K)/d(gamma3)*G*s/(I3*gamma3)*G*s/(I3*gamma3)*m */
    const double t29 = t28/t13; /* d(K)/d(gamma3)*G*s/(I3*gamma3)*G*s/(I3*gamma3)*m/K */
    const double t30 = (1.0 / 2.0)*t29; /* 1/2*d(K)/d(gamma3)*G*s/(I3*gamma3)*G*s/(I3*gamma3)*m/K */
    const double t31 = t30 - t26; /* 1/2*d(K)/d(gamma3)*G*s/(I3*gamma3)*G*s/(I3*gamma3)*m/K - t26 */
    const double t32 = params[6]*params[6]; /* G*G */
    const double t33 = t23*t32; /* d(K)/d(gamma3)*G*G */
    const double t34 = t33/t14; /* d(K)/d(gamma3)*G*G/(K*K) */
    const double t35 = (1.0 / 2.0)*t34; /* 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t36 = t31 - t35; /* 1/2*d(K)/d(gamma3)*G*s/(I3*gamma3)*G*s/(I3*gamma3)*m/K - t26 - 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t37 = params[0]*x[1]; /* m*v_nu */
    const double t38 = t5*t17; /* G*s/(I3*gamma3)*Theta */
    const double t39 = t38/t13; /* G*s/(I3*gamma3)*Theta/K */
    const double t40 = -t39; /* -G*s/(I3*gamma3)*Theta/K */
    const double t41 = t13*t14; /* K*K*K */
    const double t42 = params[3] - params[4]; /* I1 - I3 */
    const double t43 = t17*t42; /* Theta*(I1 - I3) */
    const double t44 = t23*t43; /* d(K)/d(gamma3)*Theta*(I1 - I3) */
    const double t45 = params[1]*params[3]; /* R*I1 */
    const double t46 = t5*t45; /* G*s/(I3*gamma3)*R*I1 */
    const double t47 = t3*t46; /* s*G*s/(I3*gamma3)*R*I1 */
    const double t48 = -t47; /* -s*G*s/(I3*gamma3)*R*I1 */
    const double t49 = params[6]*params[1]; /* G*R */
    const double t50 = x[0]*t49; /* gamma3*G*R */
    const double t51 = t48 - t50; /* -s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R */
    const double t52 = t51*t51; /* (-s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R)*(-s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R) */
    const double t53 = t44*t52; /* d(K)/d(gamma3)*Theta*(I1 - I3)*t52 */
    const double t54 = t53/t41; /* d(K)/d(gamma3)*Theta*(I1 - I3)*t52/(K*K*K) */
    const double t55 = 2.0*t54; /* 2*d(K)/d(gamma3)*Theta*(I1 - I3)*t52/(K*K*K) */
    const double t56 = params[0]*t42; /* m*(I1 - I3) */
    const double t57 = t23*t56; /* d(K)/d(gamma3)*m*(I1 - I3) */
    const double t58 = t52*t57; /* t52*d(K)/d(gamma3)*m*(I1 - I3) */
    const double t59 = t58/t14; /* t52*d(K)/d(gamma3)*m*(I1 - I3)/(K*K) */
    const double t60 = t59 - t55; /* t52*d(K)/d(gamma3)*m*(I1 - I3)/(K*K) - 2*d(K)/d(gamma3)*Theta*(I1 - I3)*t52/(K*K*K) */
    const double t61 = x[0]*t45; /* gamma3*R*I1 */
    const double t62 = t5*t61; /* G*s/(I3*gamma3)*gamma3*R*I1 */
    const double t63 = t62/t3; /* G*s/(I3*gamma3)*gamma3*R*I1/s */
    const double t64 = t49 - t63; /* G*R - G*s/(I3*gamma3)*gamma3*R*I1/s */
    const double t65 = t43*t64; /* Theta*(I1 - I3)*(G*R - G*s/(I3*gamma3)*gamma3*R*I1/s) */
    const double t66 = t51*t65; /* (-s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R)*Theta*(I1 - I3)*(G*R - G*s/(I3*gamma3)*gamma3*R*I1/s) */
    const double t67 = t66/t14; /* t66/(K*K) */
    const double t68 = 2.0*t67; /* 2*t66/(K*K) */
    const double t69 = t60 - t68; /* t60 - 2*t66/(K*K) */
    const double t70 = params[0]*2.0; /* m*2 */
    const double t71 = params[3]*params[3]; /* I1*I1 */
    const double t72 = t70*t71; /* m*2*I1*I1 */
    const double t73 = x[1]*t72; /* v_nu*m*2*I1*I1 */
    const double t74 = params[1]*t70; /* R*m*2 */
    const double t75 = t71*t74; /* I1*I1*R*m*2 */
    const double t76 = x[1]*t75; /* v_nu*I1*I1*R*m*2 */
    const double t77 = params[1]*2.0; /* R*2 */
    const double t78 = params[3]*t77; /* I1*R*2 */
    const double t79 = t3*t78; /* s*I1*R*2 */
    const double t80 = t17*t79; /* Theta*s*I1*R*2 */
    const double t81 = t42*t80; /* (I1 - I3)*Theta*s*I1*R*2 */
    const double t82 = t51*t81; /* (-s*G*s/(I3*gamma3)*R*I1 - gamma3*G*R)*(I1 - I3)*Theta*s*I1*R*2 */
    const double t83 = t82/t14; /* t82/(K*K) */
    out[0] = t36;
    out[1] = t37;
    out[2] = 0.0;
    out[3] = t40;
    out[4] = t69;
    out[5] = t73;
    out[6] = t76;
    out[7] = t83;
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
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_balanced = {
    .model = "spherical_top_level",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 4, .param_count = 7, .block_count = 10,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 10, 37, 0, 6, 1, 0, 12, 11 }, { 16, 71, 0, 6, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 37, 121, 0, 35, 1, 0, 20, 24 }, { 72, 350, 0, 41, 1, 0, 20, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 41, 129, 0, 41, 1, 0, 20, 31 }, { 84, 409, 0, 47, 1, 0, 20, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 8, 26, 0, 4, 1, 0, 12, 9 }, { 9, 32, 0, 4, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 9, 33, 0, 3, 1, 0, 14, 8 }, { 10, 36, 0, 3, 1, 0, 14, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 8, { 11, 59, 0, 9, 1, 0, 15, 11 }, { 19, 94, 0, 9, 1, 0, 15, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_balanced_baseline,
        &jlt_batch_spherical_top_level_balanced_avx2,
        &jlt_batch_spherical_top_level_balanced_avx512,
    },
};
