/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 9   32    0    6    1    0     10    7   (56)
 *  jacobian            27   85    0   26    1    0     13   16   (205)
 *  rhs_jacobian        31   90    0   31    1    0     13   31   (236)
 *  divergence          6   19    0    3    1    0     10    8   (36)
 *  integral_values     11   39    0    1    1    0     12    8   (58)
 *  integral_gradients  14   54    0    6    1    0     12   14   (104)
 *  eliminated          2    6    0    1    1    0      5    3   (10)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
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
    const double t0 = params[4]*params[5]; /* I1*I3 */
    const double t1 = params[4] - params[5]; /* I1 - I3 */
    out[7] = t0;
    out[8] = t1;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[4]; /* R*I1 */
    const double t5 = t2*t4; /* s*R*I1 */
    const double t6 = p[1]*p[5]; /* R*I3 */
    const double t7 = x[0]*t6; /* gamma3*R*I3 */
    const double t8 = t7*x[3]; /* gamma3*R*I3*omega3 */
    const double t9 = p[6] + t8; /* G_level + gamma3*R*I3*omega3 */
    const double t10 = t9/t5; /* omega_n = (G_level + gamma3*R*I3*omega3)/(s*R*I1) */
    const double t11 = p[1]*t10; /* R*omega_n */
    const double t12 = x[3]*t11; /* omega3*R*omega_n */
    const double t13 = x[0]*p[1]; /* gamma3*R */
    const double t14 = t10*t10; /* omega_n*omega_n */
    const double t15 = t13*t14; /* gamma3*R*omega_n*omega_n */
    const double t16 = t15/t2; /* gamma3*R*omega_n*omega_n/s */
    const double t17 = t12 + t16; /* omega3*R*omega_n + gamma3*R*omega_n*omega_n/s */
    const double t18 = x[0]*t14; /* gamma3*omega_n*omega_n */
    const double t19 = t18/t2; /* gamma3*omega_n*omega_n/s */
    const double t20 = -t19; /* -gamma3*omega_n*omega_n/s */
    const double t21 = p[5]*t10; /* I3*omega_n */
    const double t22 = x[3]*t21; /* omega3*I3*omega_n */
    const double t23 = t22/p[4]; /* omega3*I3*omega_n/I1 */
    const double t24 = t20 - t23; /* -gamma3*omega_n*omega_n/s - omega3*I3*omega_n/I1 */
    const double t25 = p[1]*p[0]; /* R*m */
    const double t26 = p[4]*t25; /* I1*R*m */
    const double t27 = t10*t26; /* omega_n*I1*R*m */
    const double t28 = p[1]*p[1]; /* R*R */
    const double t29 = p[0]*t28; /* m*R*R */
    const double t30 = p[4]*t29; /* I1*m*R*R */
    const double t31 = t2*t2; /* s*s */
    const double t32 = t30*t31; /* I1*m*R*R*s*s */
    const double t33 = p[7] + t32; /* I1*I3 + I1*m*R*R*s*s */
    const double t34 = p[5]*t29; /* I3*m*R*R */
    const double t35 = t0*t34; /* gamma3*gamma3*I3*m*R*R */
    const double t36 = t33 + t35; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t37 = x[2]*p[1]; /* omega_tau*R */
    const double t38 = x[1] + t37; /* V = v_nu + omega_tau*R */
    const double t39 = t27*t38; /* omega_n*I1*R*m*V */
    const double t40 = t39/t36; /* omega_n*I1*R*m*V/Theta */
    const double t41 = x[0]*t29; /* gamma3*m*R*R */
    const double t42 = x[2]*t41; /* omega_tau*gamma3*m*R*R */
    const double t43 = x[3]*t42; /* omega3*omega_tau*gamma3*m*R*R */
    const double t44 = t2*t43; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t45 = t44*p[8]; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t46 = t45/t36; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t47 = t46 - t40; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - omega_n*I1*R*m*V/Theta */
    out[0] = t3;
    out[1] = t17;
    out[2] = t24;
    out[3] = t47;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = -t4; /* -gamma3*omega_tau/s */
    const double t6 = p[1]*p[4]; /* R*I1 */
    const double t7 = t3*t6; /* s*R*I1 */
    const double t8 = p[1]*p[5]; /* R*I3 */
    const double t9 = x[0]*t8; /* gamma3*R*I3 */
    const double t10 = t9*x[3]; /* gamma3*R*I3*omega3 */
    const double t11 = p[6] + t10; /* G_level + gamma3*R*I3*omega3 */
    const double t12 = t11/t7; /* omega_n = (G_level + gamma3*R*I3*omega3)/(s*R*I1) */
    const double t13 = t12*t12; /* omega_n*omega_n */
    const double t14 = p[1]*t13; /* R*omega_n*omega_n */
    const double t15 = t14/t3; /* R*omega_n*omega_n/s */
    const double t16 = p[1]*x[3]; /* R*omega3 */
    const double t17 = p[5]*x[3]; /* I3*omega3 */
    const double t18 = t3*p[4]; /* s*I1 */
    const double t19 = t17/t18; /* I3*omega3/(s*I1) */
    const double t20 = t3*t3; /* s*s */
    const double t21 = t3*t20; /* s*s*s */
    const double t22 = t6*t21; /* R*I1*s*s*s */
    const double t23 = x[0]*t11; /* gamma3*(G_level + gamma3*R*I3*omega3) */
    const double t24 = t23/t22; /* gamma3*(G_level + gamma3*R*I3*omega3)/(R*I1*s*s*s) */
    const double t25 = t19 + t24; /* d(omega_n)/d(gamma3) = I3*omega3/(s*I1) + gamma3*(G_level + gamma3*R*I3*omega3)/(R*I1*s*s*s) */
    const double t26 = t16*t25; /* R*omega3*d(omega_n)/d(gamma3) */
    const double t27 = t15 + t26; /* R*omega_n*omega_n/s + R*omega3*d(omega_n)/d(gamma3) */
    const double t28 = t1*p[1]; /* gamma3*gamma3*R */
    const double t29 = t13*t28; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t30 = t29/t21; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t31 = t27 + t30; /* R*omega_n*omega_n/s + R*omega3*d(omega_n)/d(gamma3) + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t32 = x[0]*p[1]; /* gamma3*R */
    const double t33 = t12*t32; /* omega_n*gamma3*R */
    const double t34 = t25*t33; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R */
    const double t35 = t34/t3; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R/s */
    const double t36 = t35*2.0; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R/s*2 */
    const double t37 = t31 + t36; /* t31 + d(omega_n)/d(gamma3)*omega_n*gamma3*R/s*2 */
    const double t38 = p[1]*t12; /* R*omega_n */
    const double t39 = t10/t18; /* gamma3*R*I3*omega3/(s*I1) */
    const double t40 = t38 + t39; /* R*omega_n + gamma3*R*I3*omega3/(s*I1) */
    const double t41 = t1*t8; /* gamma3*gamma3*R*I3 */
    const double t42 = t12*t41; /* omega_n*gamma3*gamma3*R*I3 */
    const double t43 = p[4]*t20; /* I1*s*s */
    const double t44 = t42/t43; /* omega_n*gamma3*gamma3*R*I3/(I1*s*s) */
    const double t45 = 2.0*t44; /* 2*omega_n*gamma3*gamma3*R*I3/(I1*s*s) */
    const double t46 = t40 + t45; /* R*omega_n + gamma3*R*I3*omega3/(s*I1) + 2*omega_n*gamma3*gamma3*R*I3/(I1*s*s) */
    const double t47 = t13/t3; /* omega_n*omega_n/s */
    const double t48 = -t47; /* -omega_n*omega_n/s */
    const double t49 = t1*t13; /* gamma3*gamma3*omega_n*omega_n */
    const double t50 = t49/t21; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t51 = t48 - t50; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t52 = x[0]*t12; /* gamma3*omega_n */
    const double t53 = t25*t52; /* d(omega_n)/d(gamma3)*gamma3*omega_n */
    const double t54 = t53/t3; /* d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t55 = 2.0*t54; /* 2*d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t56 = t51 - t55; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) - 2*d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t57 = t17*t25; /* I3*omega3*d(omega_n)/d(gamma3) */
    const double t58 = t57/p[4]; /* I3*omega3*d(omega_n)/d(gamma3)/I1 */
    const double t59 = t56 - t58; /* t56 - I3*omega3*d(omega_n)/d(gamma3)/I1 */
    const double t60 = p[5]*t12; /* I3*omega_n */
    const double t61 = t60/p[4]; /* I3*omega_n/I1 */
    const double t62 = -t61; /* -I3*omega_n/I1 */
    const double t63 = t1*p[5]; /* gamma3*gamma3*I3 */
    const double t64 = t12*t63; /* omega_n*gamma3*gamma3*I3 */
    const double t65 = t64/t43; /* omega_n*gamma3*gamma3*I3/(I1*s*s) */
    const double t66 = 2.0*t65; /* 2*omega_n*gamma3*gamma3*I3/(I1*s*s) */
    const double t67 = t62 - t66; /* -I3*omega_n/I1 - 2*omega_n*gamma3*gamma3*I3/(I1*s*s) */
    const double t68 = p[4]*p[4]; /* I1*I1 */
    const double t69 = p[5]*p[5]; /* I3*I3 */
    const double t70 = x[0]*t69; /* gamma3*I3*I3 */
    const double t71 = x[3]*t70; /* omega3*gamma3*I3*I3 */
    const double t72 = t3*t68; /* s*I1*I1 */
    const double t73 = t71/t72; /* omega3*gamma3*I3*I3/(s*I1*I1) */
    const double t74 = t67 - t73; /* -I3*omega_n/I1 - 2*omega_n*gamma3*gamma3*I3/(I1*s*s) - omega3*gamma3*I3*I3/(s*I1*I1) */
    const double t75 = p[1]*p[1]; /* R*R */
    const double t76 = p[0]*t75; /* m*R*R */
    const double t77 = x[2]*t76; /* omega_tau*m*R*R */
    const double t78 = x[3]*t77; /* omega3*omega_tau*m*R*R */
    const double t79 = t3*t78; /* s*omega3*omega_tau*m*R*R */
    const double t80 = p[4]*t76; /* I1*m*R*R */
    const double t81 = t20*t80; /* s*s*I1*m*R*R */
    const double t82 = p[7] + t81; /* I1*I3 + s*s*I1*m*R*R */
    const double t83 = p[5]*t76; /* I3*m*R*R */
    const double t84 = t1*t83; /* gamma3*gamma3*I3*m*R*R */
    const double t85 = t82 + t84; /* Theta = I1*I3 + s*s*I1*m*R*R + gamma3*gamma3*I3*m*R*R */
    const double t86 = t79*p[8]; /* s*omega3*omega_tau*m*R*R*(I1 - I3) */
    const double t87 = t86/t85; /* s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t88 = t1*t76; /* gamma3*gamma3*m*R*R */
    const double t89 = x[2]*t88; /* omega_tau*gamma3*gamma3*m*R*R */
    const double t90 = x[3]*t89; /* omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t91 = t3*t85; /* s*Theta */
    const double t92 = p[8]*t90; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t93 = t92/t91; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t94 = t87 - t93; /* s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta - (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t95 = p[1]*p[0]; /* R*m */
    const double t96 = p[4]*t95; /* I1*R*m */
    const double t97 = x[2]*p[1]; /* omega_tau*R */
    const double t98 = x[1] + t97; /* V = v_nu + omega_tau*R */
    const double t99 = t96*t98; /* I1*R*m*V */
    const double t100 = t25*t99; /* d(omega_n)/d(gamma3)*I1*R*m*V */
    const double t101 = t100/t85; /* d(omega_n)/d(gamma3)*I1*R*m*V/Theta */
    const double t102 = t94 - t101; /* t94 - d(omega_n)/d(gamma3)*I1*R*m*V/Theta */
    const double t103 = t12*t96; /* omega_n*I1*R*m */
    const double t104 = t85*t85; /* Theta*Theta */
    const double t105 = t98*t103; /* V*omega_n*I1*R*m */
    const double t106 = x[0]*t80; /* gamma3*I1*m*R*R */
    const double t107 = 2.0*t106; /* 2*gamma3*I1*m*R*R */
    const double t108 = x[0]*t83; /* gamma3*I3*m*R*R */
    const double t109 = 2.0*t108; /* 2*gamma3*I3*m*R*R */
    const double t110 = t109 - t107; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - 2*gamma3*I1*m*R*R */
    const double t111 = t105*t110; /* V*omega_n*I1*R*m*d(Theta)/d(gamma3) */
    const double t112 = t111/t104; /* V*omega_n*I1*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t113 = t102 + t112; /* t94 - d(omega_n)/d(gamma3)*I1*R*m*V/Theta + V*omega_n*I1*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t114 = x[0]*t76; /* gamma3*m*R*R */
    const double t115 = x[2]*t114; /* omega_tau*gamma3*m*R*R */
    const double t116 = x[3]*t115; /* omega3*omega_tau*gamma3*m*R*R */
    const double t117 = t3*t116; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t118 = p[8]*t117; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t119 = t110*t118; /* d(Theta)/d(gamma3)*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t120 = t119/t104; /* d(Theta)/d(gamma3)*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/(Theta*Theta) */
    const double t121 = t113 - t120; /* t113 - t120 */
    const double t122 = t103/t85; /* omega_n*I1*R*m/Theta */
    const double t123 = -t122; /* -omega_n*I1*R*m/Theta */
    const double t124 = x[3]*t114; /* omega3*gamma3*m*R*R */
    const double t125 = t3*t124; /* s*omega3*gamma3*m*R*R */
    const double t126 = p[8]*t125; /* (I1 - I3)*s*omega3*gamma3*m*R*R */
    const double t127 = t126/t85; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta */
    const double t128 = t12*t80; /* omega_n*I1*m*R*R */
    const double t129 = t128/t85; /* omega_n*I1*m*R*R/Theta */
    const double t130 = t127 - t129; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta - omega_n*I1*m*R*R/Theta */
    const double t131 = t3*t115; /* s*omega_tau*gamma3*m*R*R */
    const double t132 = p[8]*t131; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R */
    const double t133 = t132/t85; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta */
    const double t134 = p[5]*t95; /* I3*R*m */
    const double t135 = x[0]*t134; /* gamma3*I3*R*m */
    const double t136 = t98*t135; /* V*gamma3*I3*R*m */
    const double t137 = t136/t91; /* V*gamma3*I3*R*m/(s*Theta) */
    const double t138 = t133 - t137; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta - V*gamma3*I3*R*m/(s*Theta) */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t37;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t46;
    out[8] = t59;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t74;
    out[12] = t121;
    out[13] = t123;
    out[14] = t130;
    out[15] = t138;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[4]; /* R*I1 */
    const double t5 = t2*t4; /* s*R*I1 */
    const double t6 = p[1]*p[5]; /* R*I3 */
    const double t7 = x[0]*t6; /* gamma3*R*I3 */
    const double t8 = t7*x[3]; /* gamma3*R*I3*omega3 */
    const double t9 = p[6] + t8; /* G_level + gamma3*R*I3*omega3 */
    const double t10 = t9/t5; /* omega_n = (G_level + gamma3*R*I3*omega3)/(s*R*I1) */
    const double t11 = p[1]*t10; /* R*omega_n */
    const double t12 = x[3]*t11; /* omega3*R*omega_n */
    const double t13 = x[0]*p[1]; /* gamma3*R */
    const double t14 = t10*t10; /* omega_n*omega_n */
    const double t15 = t13*t14; /* gamma3*R*omega_n*omega_n */
    const double t16 = t15/t2; /* gamma3*R*omega_n*omega_n/s */
    const double t17 = t12 + t16; /* omega3*R*omega_n + gamma3*R*omega_n*omega_n/s */
    const double t18 = x[0]*t14; /* gamma3*omega_n*omega_n */
    const double t19 = t18/t2; /* gamma3*omega_n*omega_n/s */
    const double t20 = -t19; /* -gamma3*omega_n*omega_n/s */
    const double t21 = p[5]*t10; /* I3*omega_n */
    const double t22 = x[3]*t21; /* omega3*I3*omega_n */
    const double t23 = t22/p[4]; /* omega3*I3*omega_n/I1 */
    const double t24 = t20 - t23; /* -gamma3*omega_n*omega_n/s - omega3*I3*omega_n/I1 */
    const double t25 = p[1]*p[0]; /* R*m */
    const double t26 = p[4]*t25; /* I1*R*m */
    const double t27 = t10*t26; /* omega_n*I1*R*m */
    const double t28 = p[1]*p[1]; /* R*R */
    const double t29 = p[0]*t28; /* m*R*R */
    const double t30 = p[4]*t29; /* I1*m*R*R */
    const double t31 = t2*t2; /* s*s */
    const double t32 = t30*t31; /* I1*m*R*R*s*s */
    const double t33 = p[7] + t32; /* I1*I3 + I1*m*R*R*s*s */
    const double t34 = p[5]*t29; /* I3*m*R*R */
    const double t35 = t0*t34; /* gamma3*gamma3*I3*m*R*R */
    const double t36 = t33 + t35; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t37 = x[2]*p[1]; /* omega_tau*R */
    const double t38 = x[1] + t37; /* V = v_nu + omega_tau*R */
    const double t39 = t27*t38; /* omega_n*I1*R*m*V */
    const double t40 = t39/t36; /* omega_n*I1*R*m*V/Theta */
    const double t41 = x[0]*t29; /* gamma3*m*R*R */
    const double t42 = x[2]*t41; /* omega_tau*gamma3*m*R*R */
    const double t43 = x[3]*t42; /* omega3*omega_tau*gamma3*m*R*R */
    const double t44 = t2*t43; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t45 = t44*p[8]; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t46 = t45/t36; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t47 = t46 - t40; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - omega_n*I1*R*m*V/Theta */
    const double t48 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t49 = t48/t2; /* omega_tau*gamma3/s */
    const double t50 = -t49; /* -omega_tau*gamma3/s */
    const double t51 = p[1]*t14; /* R*omega_n*omega_n */
    const double t52 = t51/t2; /* R*omega_n*omega_n/s */
    const double t53 = p[1]*x[3]; /* R*omega3 */
    const double t54 = p[5]*x[3]; /* I3*omega3 */
    const double t55 = t2*p[4]; /* s*I1 */
    const double t56 = t54/t55; /* I3*omega3/(s*I1) */
    const double t57 = t2*t31; /* s*s*s */
    const double t58 = t4*t57; /* R*I1*s*s*s */
    const double t59 = x[0]*t9; /* gamma3*(G_level + gamma3*R*I3*omega3) */
    const double t60 = t59/t58; /* gamma3*(G_level + gamma3*R*I3*omega3)/(R*I1*s*s*s) */
    const double t61 = t56 + t60; /* d(omega_n)/d(gamma3) = I3*omega3/(s*I1) + gamma3*(G_level + gamma3*R*I3*omega3)/(R*I1*s*s*s) */
    const double t62 = t53*t61; /* R*omega3*d(omega_n)/d(gamma3) */
    const double t63 = t52 + t62; /* R*omega_n*omega_n/s + R*omega3*d(omega_n)/d(gamma3) */
    const double t64 = t0*p[1]; /* gamma3*gamma3*R */
    const double t65 = t14*t64; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t66 = t65/t57; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t67 = t63 + t66; /* R*omega_n*omega_n/s + R*omega3*d(omega_n)/d(gamma3) + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t68 = t10*t13; /* omega_n*gamma3*R */
    const double t69 = t61*t68; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R */
    const double t70 = t69/t2; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R/s */
    const double t71 = t70*2.0; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R/s*2 */
    const double t72 = t67 + t71; /* t67 + d(omega_n)/d(gamma3)*omega_n*gamma3*R/s*2 */
    const double t73 = t8/t55; /* gamma3*R*I3*omega3/(s*I1) */
    const double t74 = t11 + t73; /* R*omega_n + gamma3*R*I3*omega3/(s*I1) */
    const double t75 = t0*t6; /* gamma3*gamma3*R*I3 */
    const double t76 = t10*t75; /* omega_n*gamma3*gamma3*R*I3 */
    const double t77 = p[4]*t31; /* I1*s*s */
    const double t78 = t76/t77; /* omega_n*gamma3*gamma3*R*I3/(I1*s*s) */
    const double t79 = 2.0*t78; /* 2*omega_n*gamma3*gamma3*R*I3/(I1*s*s) */
    const double t80 = t74 + t79; /* R*omega_n + gamma3*R*I3*omega3/(s*I1) + 2*omega_n*gamma3*gamma3*R*I3/(I1*s*s) */
    const double t81 = t14/t2; /* omega_n*omega_n/s */
    const double t82 = -t81; /* -omega_n*omega_n/s */
    const double t83 = t0*t14; /* gamma3*gamma3*omega_n*omega_n */
    const double t84 = t83/t57; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t85 = t82 - t84; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t86 = x[0]*t10; /* gamma3*omega_n */
    const double t87 = t61*t86; /* d(omega_n)/d(gamma3)*gamma3*omega_n */
    const double t88 = t87/t2; /* d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t89 = 2.0*t88; /* 2*d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t90 = t85 - t89; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) - 2*d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t91 = t54*t61; /* I3*omega3*d(omega_n)/d(gamma3) */
    const double t92 = t91/p[4]; /* I3*omega3*d(omega_n)/d(gamma3)/I1 */
    const double t93 = t90 - t92; /* t90 - I3*omega3*d(omega_n)/d(gamma3)/I1 */
    const double t94 = t21/p[4]; /* I3*omega_n/I1 */
    const double t95 = -t94; /* -I3*omega_n/I1 */
    const double t96 = t0*p[5]; /* gamma3*gamma3*I3 */
    const double t97 = t10*t96; /* omega_n*gamma3*gamma3*I3 */
    const double t98 = t97/t77; /* omega_n*gamma3*gamma3*I3/(I1*s*s) */
    const double t99 = 2.0*t98; /* 2*omega_n*gamma3*gamma3*I3/(I1*s*s) */
    const double t100 = t95 - t99; /* -I3*omega_n/I1 - 2*omega_n*gamma3*gamma3*I3/(I1*s*s) */
    const double t101 = p[4]*p[4]; /* I1*I1 */
    const double t102 = p[5]*p[5]; /* I3*I3 */
    const double t103 = x[0]*t102; /* gamma3*I3*I3 */
    const double t104 = x[3]*t103; /* omega3*gamma3*I3*I3 */
    const double t105 = t2*t101; /* s*I1*I1 */
    const double t106 = t104/t105; /* omega3*gamma3*I3*I3/(s*I1*I1) */
    const double t107 = t100 - t106; /* -I3*omega_n/I1 - 2*omega_n*gamma3*gamma3*I3/(I1*s*s) - omega3*gamma3*I3*I3/(s*I1*I1) */
    const double t108 = x[2]*t29; /* omega_tau*m*R*R */
    const double t109 = x[3]*t108; /* omega3*omega_tau*m*R*R */
    const double t110 = t2*t109; /* s*omega3*omega_tau*m*R*R */
    const double t111 = p[8]*t110; /* (I1 - I3)*s*omega3*omega_tau*m*R*R */
    const double t112 = t111/t36; /* (I1 - I3)*s*omega3*omega_tau*m*R*R/Theta */
    const double t113 = t0*t29; /* gamma3*gamma3*m*R*R */
    const double t114 = x[2]*t113; /* omega_tau*gamma3*gamma3*m*R*R */
    const double t115 = x[3]*t114; /* omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t116 = t2*t36; /* s*Theta */
    const double t117 = p[8]*t115; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t118 = t117/t116; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t119 = t112 - t118; /* (I1 - I3)*s*omega3*omega_tau*m*R*R/Theta - (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t120 = t26*t38; /* I1*R*m*V */
    const double t121 = t61*t120; /* d(omega_n)/d(gamma3)*I1*R*m*V */
    const double t122 = t121/t36; /* d(omega_n)/d(gamma3)*I1*R*m*V/Theta */
    const double t123 = t119 - t122; /* t119 - d(omega_n)/d(gamma3)*I1*R*m*V/Theta */
    const double t124 = t36*t36; /* Theta*Theta */
    const double t125 = x[0]*t30; /* gamma3*I1*m*R*R */
    const double t126 = 2.0*t125; /* 2*gamma3*I1*m*R*R */
    const double t127 = x[0]*t34; /* gamma3*I3*m*R*R */
    const double t128 = 2.0*t127; /* 2*gamma3*I3*m*R*R */
    const double t129 = t128 - t126; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - 2*gamma3*I1*m*R*R */
    const double t130 = t39*t129; /* omega_n*I1*R*m*V*d(Theta)/d(gamma3) */
    const double t131 = t130/t124; /* omega_n*I1*R*m*V*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t132 = t123 + t131; /* t119 - d(omega_n)/d(gamma3)*I1*R*m*V/Theta + omega_n*I1*R*m*V*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t133 = t45*t129; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t134 = t133/t124; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t135 = t132 - t134; /* t132 - t134 */
    const double t136 = t27/t36; /* omega_n*I1*R*m/Theta */
    const double t137 = -t136; /* -omega_n*I1*R*m/Theta */
    const double t138 = x[3]*t41; /* omega3*gamma3*m*R*R */
    const double t139 = t2*t138; /* s*omega3*gamma3*m*R*R */
    const double t140 = p[8]*t139; /* (I1 - I3)*s*omega3*gamma3*m*R*R */
    const double t141 = t140/t36; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta */
    const double t142 = t10*t30; /* omega_n*I1*m*R*R */
    const double t143 = t142/t36; /* omega_n*I1*m*R*R/Theta */
    const double t144 = t141 - t143; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta - omega_n*I1*m*R*R/Theta */
    const double t145 = t2*t42; /* s*omega_tau*gamma3*m*R*R */
    const double t146 = p[8]*t145; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R */
    const double t147 = t146/t36; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta */
    const double t148 = p[5]*t25; /* I3*R*m */
    const double t149 = x[0]*t148; /* gamma3*I3*R*m */
    const double t150 = t38*t149; /* V*gamma3*I3*R*m */
    const double t151 = t150/t116; /* V*gamma3*I3*R*m/(s*Theta) */
    const double t152 = t147 - t151; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta - V*gamma3*I3*R*m/(s*Theta) */
    out[0] = t3;
    out[1] = t17;
    out[2] = t24;
    out[3] = t47;
    out[4] = t50;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = t72;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t80;
    out[12] = t93;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t107;
    out[16] = t135;
    out[17] = t137;
    out[18] = t144;
    out[19] = t152;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = p[1]*p[1]; /* R*R */
    const double t6 = p[0]*t5; /* m*R*R */
    const double t7 = x[0]*t6; /* gamma3*m*R*R */
    const double t8 = x[2]*t7; /* omega_tau*gamma3*m*R*R */
    const double t9 = t3*t8; /* s*omega_tau*gamma3*m*R*R */
    const double t10 = t6*p[4]; /* m*R*R*I1 */
    const double t11 = t3*t3; /* s*s */
    const double t12 = t10*t11; /* m*R*R*I1*s*s */
    const double t13 = p[7] + t12; /* I1*I3 + m*R*R*I1*s*s */
    const double t14 = t6*p[5]; /* m*R*R*I3 */
    const double t15 = t1*t14; /* gamma3*gamma3*m*R*R*I3 */
    const double t16 = t13 + t15; /* Theta = I1*I3 + m*R*R*I1*s*s + gamma3*gamma3*m*R*R*I3 */
    const double t17 = t9*p[8]; /* s*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t18 = t17/t16; /* s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t19 = t18 - t4; /* s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - gamma3*omega_tau/s */
    const double t20 = p[0]*p[1]; /* m*R */
    const double t21 = p[5]*t20; /* I3*m*R */
    const double t22 = x[0]*t21; /* gamma3*I3*m*R */
    const double t23 = t3*t16; /* s*Theta */
    const double t24 = x[2]*p[1]; /* omega_tau*R */
    const double t25 = x[1] + t24; /* V = v_nu + omega_tau*R */
    const double t26 = t22*t25; /* gamma3*I3*m*R*V */
    const double t27 = t26/t23; /* gamma3*I3*m*R*V/(s*Theta) */
    const double t28 = t19 - t27; /* t19 - gamma3*I3*m*R*V/(s*Theta) */
    out[0] = t28;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[0]*t0; /* m*v_nu*v_nu */
    const double t2 = t1*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t3 = p[4]*p[1]; /* I1*R */
    const double t4 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t5 = 1.0 - t4; /* 1 - gamma3*gamma3 */
    const double t6 = sqrt(t5); /* s = sqrt(1 - gamma3*gamma3) */
    const double t7 = t3*t6; /* I1*R*s */
    const double t8 = p[1]*p[5]; /* R*I3 */
    const double t9 = x[0]*t8; /* gamma3*R*I3 */
    const double t10 = t9*x[3]; /* gamma3*R*I3*omega3 */
    const double t11 = p[6] + t10; /* G_level + gamma3*R*I3*omega3 */
    const double t12 = t11/t7; /* omega_n = (G_level + gamma3*R*I3*omega3)/(I1*R*s) */
    const double t13 = t12*t12; /* omega_n*omega_n */
    const double t14 = p[4]*t13; /* I1*omega_n*omega_n */
    const double t15 = (1.0 / 2.0)*t14; /* 1/2*I1*omega_n*omega_n */
    const double t16 = t2 + t15; /* m*v_nu*v_nu*1/2 + 1/2*I1*omega_n*omega_n */
    const double t17 = x[3]*x[3]; /* omega3*omega3 */
    const double t18 = p[5]*t17; /* I3*omega3*omega3 */
    const double t19 = (1.0 / 2.0)*t18; /* 1/2*I3*omega3*omega3 */
    const double t20 = t16 + t19; /* m*v_nu*v_nu*1/2 + 1/2*I1*omega_n*omega_n + 1/2*I3*omega3*omega3 */
    const double t21 = p[1]*x[3]; /* R*omega3 */
    const double t22 = t6*t21; /* s*R*omega3 */
    const double t23 = p[1]*x[0]; /* R*gamma3 */
    const double t24 = t12*t23; /* omega_n*R*gamma3 */
    const double t25 = t22 + t24; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t26 = t25*t25; /* v_tau*v_tau */
    const double t27 = p[0]*t26; /* m*v_tau*v_tau */
    const double t28 = (1.0 / 2.0)*t27; /* 1/2*m*v_tau*v_tau */
    const double t29 = t20 + t28; /* t20 + 1/2*m*v_tau*v_tau */
    const double t30 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t31 = p[4]*t30; /* I1*omega_tau*omega_tau */
    const double t32 = (1.0 / 2.0)*t31; /* 1/2*I1*omega_tau*omega_tau */
    const double t33 = t29 + t32; /* energy = t20 + 1/2*m*v_tau*v_tau + 1/2*I1*omega_tau*omega_tau */
    const double t34 = p[4]*p[4]; /* I1*I1 */
    const double t35 = p[0]*t34; /* m*I1*I1 */
    const double t36 = p[1]*x[2]; /* R*omega_tau */
    const double t37 = x[1] + t36; /* v_nu + R*omega_tau */
    const double t38 = t37*t37; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t39 = t35*t38; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t40 = p[1]*p[1]; /* R*R */
    const double t41 = p[0]*t40; /* m*R*R */
    const double t42 = p[4]*t41; /* I1*m*R*R */
    const double t43 = t6*t6; /* s*s */
    const double t44 = t42*t43; /* I1*m*R*R*s*s */
    const double t45 = p[7] + t44; /* I1*I3 + I1*m*R*R*s*s */
    const double t46 = p[5]*t41; /* I3*m*R*R */
    const double t47 = t4*t46; /* gamma3*gamma3*I3*m*R*R */
    const double t48 = t45 + t47; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t49 = t17*t48; /* omega3*omega3*Theta */
    const double t50 = t49*p[8]; /* omega3*omega3*Theta*(I1 - I3) */
    const double t51 = t39 + t50; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) + omega3*omega3*Theta*(I1 - I3) */
    out[0] = t33;
    out[1] = t51;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[4]*p[1]; /* I1*R */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0*t3; /* I1*R*s */
    const double t5 = p[1]*p[5]; /* R*I3 */
    const double t6 = x[0]*t5; /* gamma3*R*I3 */
    const double t7 = t6*x[3]; /* gamma3*R*I3*omega3 */
    const double t8 = p[6] + t7; /* G_level + gamma3*R*I3*omega3 */
    const double t9 = t8/t4; /* omega_n = (G_level + gamma3*R*I3*omega3)/(I1*R*s) */
    const double t10 = p[4]*t9; /* I1*omega_n */
    const double t11 = p[5]*x[3]; /* I3*omega3 */
    const double t12 = p[4]*t3; /* I1*s */
    const double t13 = t11/t12; /* I3*omega3/(I1*s) */
    const double t14 = t3*t3; /* s*s */
    const double t15 = t3*t14; /* s*s*s */
    const double t16 = t0*t15; /* I1*R*s*s*s */
    const double t17 = x[0]*t8; /* gamma3*(G_level + gamma3*R*I3*omega3) */
    const double t18 = t17/t16; /* gamma3*(G_level + gamma3*R*I3*omega3)/(I1*R*s*s*s) */
    const double t19 = t13 + t18; /* d(omega_n)/d(gamma3) = I3*omega3/(I1*s) + gamma3*(G_level + gamma3*R*I3*omega3)/(I1*R*s*s*s) */
    const double t20 = t10*t19; /* I1*omega_n*d(omega_n)/d(gamma3) */
    const double t21 = p[1]*x[3]; /* R*omega3 */
    const double t22 = t3*t21; /* s*R*omega3 */
    const double t23 = p[1]*x[0]; /* R*gamma3 */
    const double t24 = t9*t23; /* omega_n*R*gamma3 */
    const double t25 = t22 + t24; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t26 = p[0]*t25; /* m*v_tau */
    const double t27 = p[1]*t9; /* R*omega_n */
    const double t28 = x[3]*t23; /* omega3*R*gamma3 */
    const double t29 = t28/t3; /* omega3*R*gamma3/s */
    const double t30 = t27 - t29; /* R*omega_n - omega3*R*gamma3/s */
    const double t31 = t19*t23; /* d(omega_n)/d(gamma3)*R*gamma3 */
    const double t32 = t30 + t31; /* d(v_tau)/d(gamma3) = R*omega_n - omega3*R*gamma3/s + d(omega_n)/d(gamma3)*R*gamma3 */
    const double t33 = t26*t32; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t34 = t20 + t33; /* d(energy)/d(gamma3) = I1*omega_n*d(omega_n)/d(gamma3) + m*v_tau*d(v_tau)/d(gamma3) */
    const double t35 = p[0]*x[1]; /* m*v_nu */
    const double t36 = p[4]*x[2]; /* I1*omega_tau */
    const double t37 = p[1]*t3; /* R*s */
    const double t38 = t1*t5; /* gamma3*gamma3*R*I3 */
    const double t39 = t38/t12; /* gamma3*gamma3*R*I3/(I1*s) */
    const double t40 = t37 + t39; /* d(v_tau)/d(omega3) = R*s + gamma3*gamma3*R*I3/(I1*s) */
    const double t41 = t26*t40; /* m*v_tau*d(v_tau)/d(omega3) */
    const double t42 = t11 + t41; /* I3*omega3 + m*v_tau*d(v_tau)/d(omega3) */
    const double t43 = x[0]*p[5]; /* gamma3*I3 */
    const double t44 = t9*t43; /* omega_n*gamma3*I3 */
    const double t45 = t44/t3; /* omega_n*gamma3*I3/s */
    const double t46 = t42 + t45; /* d(energy)/d(omega3) = I3*omega3 + m*v_tau*d(v_tau)/d(omega3) + omega_n*gamma3*I3/s */
    const double t47 = x[3]*x[3]; /* omega3*omega3 */
    const double t48 = t47*p[8]; /* omega3*omega3*(I1 - I3) */
    const double t49 = p[1]*p[1]; /* R*R */
    const double t50 = p[0]*t49; /* m*R*R */
    const double t51 = p[4]*t50; /* I1*m*R*R */
    const double t52 = x[0]*t51; /* gamma3*I1*m*R*R */
    const double t53 = t52*2.0; /* gamma3*I1*m*R*R*2 */
    const double t54 = p[5]*t50; /* I3*m*R*R */
    const double t55 = x[0]*t54; /* gamma3*I3*m*R*R */
    const double t56 = 2.0*t55; /* 2*gamma3*I3*m*R*R */
    const double t57 = t56 - t53; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - gamma3*I1*m*R*R*2 */
    const double t58 = t48*t57; /* omega3*omega3*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t59 = p[0]*2.0; /* m*2 */
    const double t60 = p[4]*p[4]; /* I1*I1 */
    const double t61 = t59*t60; /* m*2*I1*I1 */
    const double t62 = p[1]*x[2]; /* R*omega_tau */
    const double t63 = x[1] + t62; /* v_nu + R*omega_tau */
    const double t64 = t61*t63; /* m*2*I1*I1*(v_nu + R*omega_tau) */
    const double t65 = p[1]*t59; /* R*m*2 */
    const double t66 = t60*t65; /* I1*I1*R*m*2 */
    const double t67 = t63*t66; /* (v_nu + R*omega_tau)*I1*I1*R*m*2 */
    const double t68 = x[3]*2.0; /* omega3*2 */
    const double t69 = t14*t51; /* s*s*I1*m*R*R */
    const double t70 = p[7] + t69; /* I1*I3 + s*s*I1*m*R*R */
    const double t71 = t1*t54; /* gamma3*gamma3*I3*m*R*R */
    const double t72 = t70 + t71; /* Theta = I1*I3 + s*s*I1*m*R*R + gamma3*gamma3*I3*m*R*R */
    const double t73 = t68*t72; /* omega3*2*Theta */
    const double t74 = p[8]*t73; /* (I1 - I3)*omega3*2*Theta */
    out[0] = t34;
    out[1] = t35;
    out[2] = t36;
    out[3] = t46;
    out[4] = t58;
    out[5] = t64;
    out[6] = t67;
    out[7] = t74;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[4]; /* R*I1 */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0*t3; /* R*I1*s */
    const double t5 = p[1]*p[5]; /* R*I3 */
    const double t6 = x[0]*t5; /* gamma3*R*I3 */
    const double t7 = t6*x[3]; /* gamma3*R*I3*omega3 */
    const double t8 = p[6] + t7; /* G_level + gamma3*R*I3*omega3 */
    const double t9 = t8/t4; /* omega_n = (G_level + gamma3*R*I3*omega3)/(R*I1*s) */
    out[0] = t9;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 9,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 9, 32, 0, 6, 1, 0, 10, 7 }, { 10, 39, 0, 6, 1, 0, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 27, 85, 0, 26, 1, 0, 13, 16 }, { 33, 145, 0, 26, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 31, 90, 0, 31, 1, 0, 13, 31 }, { 38, 166, 0, 31, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 6, 19, 0, 3, 1, 0, 10, 8 }, { 7, 25, 0, 3, 1, 0, 10, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 11, 39, 0, 1, 1, 0, 12, 8 }, { 12, 44, 0, 1, 1, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 8, { 14, 54, 0, 6, 1, 0, 12, 14 }, { 18, 79, 0, 6, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 6, 0, 1, 1, 0, 5, 3 }, { 2, 6, 0, 1, 1, 0, 5, 3 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_on_level_G_baseline,
        &jlt_batch_spherical_top_balanced_on_level_G_avx2,
        &jlt_batch_spherical_top_balanced_on_level_G_avx512,
    },
};
