/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 9   37    0    4    0    0     10    7   (59)
 *  jacobian            31  122    0   29    0    0     13   18   (279)
 *  rhs_jacobian        36  132    0   32    0    0     13   28   (316)
 *  divergence          5   18    0    2    0    0      9    6   (32)
 *  integral_values     10   39    0    1    0    0     12    6   (55)
 *  integral_gradients  12   57    0    7    0    0     11   10   (111)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          1    5    0    1    0    0      5    3   (7)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_avx512;

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
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = x[4]*t2; /* s*R*I1 */
    const double t4 = p[1]*p[5]; /* R*I3 */
    const double t5 = t4*x[0]; /* R*I3*gamma3 */
    const double t6 = t5*x[3]; /* R*I3*gamma3*omega3 */
    const double t7 = p[6] + t6; /* G_level + R*I3*gamma3*omega3 */
    const double t8 = t7/t3; /* omega_n = (G_level + R*I3*gamma3*omega3)/(s*R*I1) */
    const double t9 = p[1]*t8; /* R*omega_n */
    const double t10 = x[3]*t9; /* omega3*R*omega_n */
    const double t11 = x[4]*t10; /* s*omega3*R*omega_n */
    const double t12 = p[1]*x[0]; /* R*gamma3 */
    const double t13 = t8*t8; /* omega_n*omega_n */
    const double t14 = t12*t13; /* R*gamma3*omega_n*omega_n */
    const double t15 = t11 + t14; /* s*omega3*R*omega_n + R*gamma3*omega_n*omega_n */
    const double t16 = x[0]*t13; /* gamma3*omega_n*omega_n */
    const double t17 = -t16; /* -gamma3*omega_n*omega_n */
    const double t18 = p[5]*t8; /* I3*omega_n */
    const double t19 = x[3]*t18; /* omega3*I3*omega_n */
    const double t20 = x[4]*t19; /* s*omega3*I3*omega_n */
    const double t21 = t20/p[4]; /* s*omega3*I3*omega_n/I1 */
    const double t22 = t17 - t21; /* -gamma3*omega_n*omega_n - s*omega3*I3*omega_n/I1 */
    const double t23 = p[1]*p[0]; /* R*m */
    const double t24 = p[4]*t23; /* I1*R*m */
    const double t25 = t8*t24; /* omega_n*I1*R*m */
    const double t26 = x[4]*t25; /* s*omega_n*I1*R*m */
    const double t27 = p[1]*p[1]; /* R*R */
    const double t28 = p[0]*t27; /* m*R*R */
    const double t29 = p[4]*t28; /* I1*m*R*R */
    const double t30 = t0*t29; /* s*s*I1*m*R*R */
    const double t31 = p[7] + t30; /* I1*I3 + s*s*I1*m*R*R */
    const double t32 = p[5]*t28; /* I3*m*R*R */
    const double t33 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t34 = t32*t33; /* I3*m*R*R*gamma3*gamma3 */
    const double t35 = t31 + t34; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*R*R*gamma3*gamma3 */
    const double t36 = x[2]*p[1]; /* omega_tau*R */
    const double t37 = x[1] + t36; /* V = v_nu + omega_tau*R */
    const double t38 = t26*t37; /* s*omega_n*I1*R*m*V */
    const double t39 = t38/t35; /* s*omega_n*I1*R*m*V/Theta */
    const double t40 = x[0]*t28; /* gamma3*m*R*R */
    const double t41 = x[2]*t40; /* omega_tau*gamma3*m*R*R */
    const double t42 = x[3]*t41; /* omega3*omega_tau*gamma3*m*R*R */
    const double t43 = t0*t42; /* s*s*omega3*omega_tau*gamma3*m*R*R */
    const double t44 = t43*p[8]; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t45 = t44/t35; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t46 = t45 - t39; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - s*omega_n*I1*R*m*V/Theta */
    const double t47 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t48 = x[4]*t47; /* s*omega_tau*gamma3 */
    const double t49 = -t48; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t15;
    out[2] = t22;
    out[3] = t46;
    out[4] = t49;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[4]*t1; /* s*2*omega_tau */
    const double t3 = p[1]*p[4]; /* R*I1 */
    const double t4 = x[4]*t3; /* s*R*I1 */
    const double t5 = p[1]*p[5]; /* R*I3 */
    const double t6 = t5*x[0]; /* R*I3*gamma3 */
    const double t7 = t6*x[3]; /* R*I3*gamma3*omega3 */
    const double t8 = p[6] + t7; /* G_level + R*I3*gamma3*omega3 */
    const double t9 = t8/t4; /* omega_n = (G_level + R*I3*gamma3*omega3)/(s*R*I1) */
    const double t10 = t9*t9; /* omega_n*omega_n */
    const double t11 = p[1]*t10; /* R*omega_n*omega_n */
    const double t12 = x[3]*x[3]; /* omega3*omega3 */
    const double t13 = t5*t12; /* R*I3*omega3*omega3 */
    const double t14 = t13/p[4]; /* R*I3*omega3*omega3/I1 */
    const double t15 = t11 + t14; /* R*omega_n*omega_n + R*I3*omega3*omega3/I1 */
    const double t16 = t6*t9; /* R*I3*gamma3*omega_n */
    const double t17 = x[3]*t16; /* omega3*R*I3*gamma3*omega_n */
    const double t18 = x[4]*p[4]; /* s*I1 */
    const double t19 = t17/t18; /* omega3*R*I3*gamma3*omega_n/(s*I1) */
    const double t20 = 2.0*t19; /* 2*omega3*R*I3*gamma3*omega_n/(s*I1) */
    const double t21 = t15 + t20; /* R*omega_n*omega_n + R*I3*omega3*omega3/I1 + 2*omega3*R*I3*gamma3*omega_n/(s*I1) */
    const double t22 = p[1]*t9; /* R*omega_n */
    const double t23 = x[4]*t22; /* s*R*omega_n */
    const double t24 = t7/p[4]; /* R*I3*gamma3*omega3/I1 */
    const double t25 = t23 + t24; /* s*R*omega_n + R*I3*gamma3*omega3/I1 */
    const double t26 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t27 = t5*t26; /* R*I3*gamma3*gamma3 */
    const double t28 = t9*t27; /* omega_n*R*I3*gamma3*gamma3 */
    const double t29 = t28/t18; /* omega_n*R*I3*gamma3*gamma3/(s*I1) */
    const double t30 = 2.0*t29; /* 2*omega_n*R*I3*gamma3*gamma3/(s*I1) */
    const double t31 = t25 + t30; /* s*R*omega_n + R*I3*gamma3*omega3/I1 + 2*omega_n*R*I3*gamma3*gamma3/(s*I1) */
    const double t32 = x[3]*t22; /* omega3*R*omega_n */
    const double t33 = x[3]*t8; /* omega3*(G_level + R*I3*gamma3*omega3) */
    const double t34 = t33/t18; /* omega3*(G_level + R*I3*gamma3*omega3)/(s*I1) */
    const double t35 = t32 - t34; /* omega3*R*omega_n - omega3*(G_level + R*I3*gamma3*omega3)/(s*I1) */
    const double t36 = x[0]*t9; /* gamma3*omega_n */
    const double t37 = t0*p[4]; /* s*s*I1 */
    const double t38 = t8*t36; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n */
    const double t39 = t38/t37; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I1) */
    const double t40 = 2.0*t39; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I1) */
    const double t41 = t35 - t40; /* t35 - 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I1) */
    const double t42 = -t10; /* -omega_n*omega_n */
    const double t43 = p[5]*x[0]; /* I3*gamma3 */
    const double t44 = t9*t43; /* omega_n*I3*gamma3 */
    const double t45 = x[3]*t44; /* omega3*omega_n*I3*gamma3 */
    const double t46 = t45/t18; /* omega3*omega_n*I3*gamma3/(s*I1) */
    const double t47 = 2.0*t46; /* 2*omega3*omega_n*I3*gamma3/(s*I1) */
    const double t48 = t42 - t47; /* -omega_n*omega_n - 2*omega3*omega_n*I3*gamma3/(s*I1) */
    const double t49 = p[4]*p[4]; /* I1*I1 */
    const double t50 = p[5]*p[5]; /* I3*I3 */
    const double t51 = t12*t50; /* omega3*omega3*I3*I3 */
    const double t52 = t51/t49; /* omega3*omega3*I3*I3/(I1*I1) */
    const double t53 = t48 - t52; /* -omega_n*omega_n - 2*omega3*omega_n*I3*gamma3/(s*I1) - omega3*omega3*I3*I3/(I1*I1) */
    const double t54 = p[5]*t9; /* I3*omega_n */
    const double t55 = x[4]*t54; /* s*I3*omega_n */
    const double t56 = t55/p[4]; /* s*I3*omega_n/I1 */
    const double t57 = -t56; /* -s*I3*omega_n/I1 */
    const double t58 = p[5]*t26; /* I3*gamma3*gamma3 */
    const double t59 = t9*t58; /* omega_n*I3*gamma3*gamma3 */
    const double t60 = t59/t18; /* omega_n*I3*gamma3*gamma3/(s*I1) */
    const double t61 = 2.0*t60; /* 2*omega_n*I3*gamma3*gamma3/(s*I1) */
    const double t62 = t57 - t61; /* -s*I3*omega_n/I1 - 2*omega_n*I3*gamma3*gamma3/(s*I1) */
    const double t63 = x[0]*t50; /* gamma3*I3*I3 */
    const double t64 = x[3]*t63; /* omega3*gamma3*I3*I3 */
    const double t65 = t64/t49; /* omega3*gamma3*I3*I3/(I1*I1) */
    const double t66 = t62 - t65; /* -s*I3*omega_n/I1 - 2*omega_n*I3*gamma3*gamma3/(s*I1) - omega3*gamma3*I3*I3/(I1*I1) */
    const double t67 = x[3]*t54; /* omega3*I3*omega_n */
    const double t68 = t67/p[4]; /* omega3*I3*omega_n/I1 */
    const double t69 = t0*t3; /* s*s*R*I1 */
    const double t70 = t38/t69; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I1) */
    const double t71 = 2.0*t70; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I1) */
    const double t72 = t71 - t68; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I1) - omega3*I3*omega_n/I1 */
    const double t73 = p[1]*t49; /* R*I1*I1 */
    const double t74 = p[5]*x[3]; /* I3*omega3 */
    const double t75 = x[4]*t73; /* s*R*I1*I1 */
    const double t76 = t8*t74; /* (G_level + R*I3*gamma3*omega3)*I3*omega3 */
    const double t77 = t76/t75; /* (G_level + R*I3*gamma3*omega3)*I3*omega3/(s*R*I1*I1) */
    const double t78 = t72 + t77; /* t72 + (G_level + R*I3*gamma3*omega3)*I3*omega3/(s*R*I1*I1) */
    const double t79 = p[1]*p[1]; /* R*R */
    const double t80 = p[0]*t79; /* m*R*R */
    const double t81 = x[2]*t80; /* omega_tau*m*R*R */
    const double t82 = x[3]*t81; /* omega3*omega_tau*m*R*R */
    const double t83 = t0*t82; /* s*s*omega3*omega_tau*m*R*R */
    const double t84 = p[4]*t80; /* I1*m*R*R */
    const double t85 = t0*t84; /* s*s*I1*m*R*R */
    const double t86 = p[7] + t85; /* I1*I3 + s*s*I1*m*R*R */
    const double t87 = p[5]*t80; /* I3*m*R*R */
    const double t88 = t26*t87; /* gamma3*gamma3*I3*m*R*R */
    const double t89 = t86 + t88; /* Theta = I1*I3 + s*s*I1*m*R*R + gamma3*gamma3*I3*m*R*R */
    const double t90 = t83*p[8]; /* s*s*omega3*omega_tau*m*R*R*(I1 - I3) */
    const double t91 = t90/t89; /* s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t92 = p[1]*p[0]; /* R*m */
    const double t93 = p[5]*t92; /* I3*R*m */
    const double t94 = x[3]*t93; /* omega3*I3*R*m */
    const double t95 = x[2]*p[1]; /* omega_tau*R */
    const double t96 = x[1] + t95; /* V = v_nu + omega_tau*R */
    const double t97 = t94*t96; /* omega3*I3*R*m*V */
    const double t98 = t97/t89; /* omega3*I3*R*m*V/Theta */
    const double t99 = t91 - t98; /* s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta - omega3*I3*R*m*V/Theta */
    const double t100 = p[0]*p[0]; /* m*m */
    const double t101 = p[1]*t79; /* R*R*R */
    const double t102 = t100*t101; /* m*m*R*R*R */
    const double t103 = p[4]*t102; /* I1*m*m*R*R*R */
    const double t104 = p[5]*t103; /* I3*I1*m*m*R*R*R */
    const double t105 = x[0]*t104; /* gamma3*I3*I1*m*m*R*R*R */
    const double t106 = t9*t105; /* omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t107 = x[4]*t106; /* s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t108 = t89*t89; /* Theta*Theta */
    const double t109 = t96*t107; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t110 = t109/t108; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t111 = 2.0*t110; /* 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t112 = t99 + t111; /* t99 + 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t113 = t79*t79; /* R*R*R*R */
    const double t114 = t100*t113; /* m*m*R*R*R*R */
    const double t115 = p[5]*t114; /* I3*m*m*R*R*R*R */
    const double t116 = t26*t115; /* gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t117 = x[2]*t116; /* omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t118 = x[3]*t117; /* omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t119 = t0*t118; /* s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t120 = p[8]*t119; /* (I1 - I3)*s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t121 = t120/t108; /* (I1 - I3)*s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t122 = 2.0*t121; /* 2*t121 */
    const double t123 = t112 - t122; /* t99 + 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) - 2*t121 */
    const double t124 = p[4]*t92; /* I1*R*m */
    const double t125 = t9*t124; /* omega_n*I1*R*m */
    const double t126 = x[4]*t125; /* s*omega_n*I1*R*m */
    const double t127 = t126/t89; /* s*omega_n*I1*R*m/Theta */
    const double t128 = -t127; /* -s*omega_n*I1*R*m/Theta */
    const double t129 = x[0]*t80; /* gamma3*m*R*R */
    const double t130 = x[3]*t129; /* omega3*gamma3*m*R*R */
    const double t131 = t0*t130; /* s*s*omega3*gamma3*m*R*R */
    const double t132 = p[8]*t131; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R */
    const double t133 = t132/t89; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta */
    const double t134 = t9*t84; /* omega_n*I1*m*R*R */
    const double t135 = x[4]*t134; /* s*omega_n*I1*m*R*R */
    const double t136 = t135/t89; /* s*omega_n*I1*m*R*R/Theta */
    const double t137 = t133 - t136; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta - s*omega_n*I1*m*R*R/Theta */
    const double t138 = x[2]*t129; /* omega_tau*gamma3*m*R*R */
    const double t139 = t0*t138; /* s*s*omega_tau*gamma3*m*R*R */
    const double t140 = p[8]*t139; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R */
    const double t141 = t140/t89; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta */
    const double t142 = x[0]*t93; /* gamma3*I3*R*m */
    const double t143 = t96*t142; /* V*gamma3*I3*R*m */
    const double t144 = t143/t89; /* V*gamma3*I3*R*m/Theta */
    const double t145 = t141 - t144; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta - V*gamma3*I3*R*m/Theta */
    const double t146 = t96*t125; /* V*omega_n*I1*R*m */
    const double t147 = t146/t89; /* V*omega_n*I1*R*m/Theta */
    const double t148 = x[3]*t138; /* omega3*omega_tau*gamma3*m*R*R */
    const double t149 = x[4]*t148; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t150 = p[8]*t149; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t151 = t150/t89; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t152 = 2.0*t151; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t153 = t152 - t147; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta - V*omega_n*I1*R*m/Theta */
    const double t154 = t49*t102; /* I1*I1*m*m*R*R*R */
    const double t155 = t9*t154; /* omega_n*I1*I1*m*m*R*R*R */
    const double t156 = t0*t155; /* s*s*omega_n*I1*I1*m*m*R*R*R */
    const double t157 = t96*t156; /* V*s*s*omega_n*I1*I1*m*m*R*R*R */
    const double t158 = t157/t108; /* V*s*s*omega_n*I1*I1*m*m*R*R*R/(Theta*Theta) */
    const double t159 = 2.0*t158; /* 2*V*s*s*omega_n*I1*I1*m*m*R*R*R/(Theta*Theta) */
    const double t160 = t153 + t159; /* t153 + 2*V*s*s*omega_n*I1*I1*m*m*R*R*R/(Theta*Theta) */
    const double t161 = p[4]*t114; /* I1*m*m*R*R*R*R */
    const double t162 = x[0]*t161; /* gamma3*I1*m*m*R*R*R*R */
    const double t163 = x[2]*t162; /* omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t164 = x[3]*t163; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t165 = x[4]*t0; /* s*s*s */
    const double t166 = t164*t165; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s */
    const double t167 = p[8]*t166; /* (I1 - I3)*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s */
    const double t168 = t167/t108; /* (I1 - I3)*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s/(Theta*Theta) */
    const double t169 = 2.0*t168; /* 2*t168 */
    const double t170 = t160 - t169; /* t153 + 2*V*s*s*omega_n*I1*I1*m*m*R*R*R/(Theta*Theta) - 2*t168 */
    const double t171 = x[4]*t89; /* s*Theta */
    const double t172 = p[0]*t96; /* m*V */
    const double t173 = t8*t172; /* (G_level + R*I3*gamma3*omega3)*m*V */
    const double t174 = t173/t171; /* (G_level + R*I3*gamma3*omega3)*m*V/(s*Theta) */
    const double t175 = t170 + t174; /* t170 + (G_level + R*I3*gamma3*omega3)*m*V/(s*Theta) */
    const double t176 = x[4]*x[2]; /* s*omega_tau */
    const double t177 = -t176; /* -s*omega_tau */
    const double t178 = x[4]*x[0]; /* s*gamma3 */
    const double t179 = -t178; /* -s*gamma3 */
    const double t180 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t181 = -t180; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t21;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t31;
    out[9] = t41;
    out[10] = t53;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t66;
    out[14] = t78;
    out[15] = t123;
    out[16] = t128;
    out[17] = t137;
    out[18] = t145;
    out[19] = t175;
    out[20] = t177;
    out[21] = 0.0;
    out[22] = t179;
    out[23] = 0.0;
    out[24] = t181;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = x[4]*t2; /* s*R*I1 */
    const double t4 = p[1]*p[5]; /* R*I3 */
    const double t5 = t4*x[0]; /* R*I3*gamma3 */
    const double t6 = t5*x[3]; /* R*I3*gamma3*omega3 */
    const double t7 = p[6] + t6; /* G_level + R*I3*gamma3*omega3 */
    const double t8 = t7/t3; /* omega_n = (G_level + R*I3*gamma3*omega3)/(s*R*I1) */
    const double t9 = p[1]*t8; /* R*omega_n */
    const double t10 = x[3]*t9; /* omega3*R*omega_n */
    const double t11 = x[4]*t10; /* s*omega3*R*omega_n */
    const double t12 = p[1]*x[0]; /* R*gamma3 */
    const double t13 = t8*t8; /* omega_n*omega_n */
    const double t14 = t12*t13; /* R*gamma3*omega_n*omega_n */
    const double t15 = t11 + t14; /* s*omega3*R*omega_n + R*gamma3*omega_n*omega_n */
    const double t16 = x[0]*t13; /* gamma3*omega_n*omega_n */
    const double t17 = -t16; /* -gamma3*omega_n*omega_n */
    const double t18 = p[5]*t8; /* I3*omega_n */
    const double t19 = x[3]*t18; /* omega3*I3*omega_n */
    const double t20 = x[4]*t19; /* s*omega3*I3*omega_n */
    const double t21 = t20/p[4]; /* s*omega3*I3*omega_n/I1 */
    const double t22 = t17 - t21; /* -gamma3*omega_n*omega_n - s*omega3*I3*omega_n/I1 */
    const double t23 = p[1]*p[0]; /* R*m */
    const double t24 = p[4]*t23; /* I1*R*m */
    const double t25 = t8*t24; /* omega_n*I1*R*m */
    const double t26 = x[4]*t25; /* s*omega_n*I1*R*m */
    const double t27 = p[1]*p[1]; /* R*R */
    const double t28 = p[0]*t27; /* m*R*R */
    const double t29 = p[4]*t28; /* I1*m*R*R */
    const double t30 = t0*t29; /* s*s*I1*m*R*R */
    const double t31 = p[7] + t30; /* I1*I3 + s*s*I1*m*R*R */
    const double t32 = p[5]*t28; /* I3*m*R*R */
    const double t33 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t34 = t32*t33; /* I3*m*R*R*gamma3*gamma3 */
    const double t35 = t31 + t34; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*R*R*gamma3*gamma3 */
    const double t36 = x[2]*p[1]; /* omega_tau*R */
    const double t37 = x[1] + t36; /* V = v_nu + omega_tau*R */
    const double t38 = t26*t37; /* s*omega_n*I1*R*m*V */
    const double t39 = t38/t35; /* s*omega_n*I1*R*m*V/Theta */
    const double t40 = x[0]*t28; /* gamma3*m*R*R */
    const double t41 = x[2]*t40; /* omega_tau*gamma3*m*R*R */
    const double t42 = x[3]*t41; /* omega3*omega_tau*gamma3*m*R*R */
    const double t43 = t0*t42; /* s*s*omega3*omega_tau*gamma3*m*R*R */
    const double t44 = t43*p[8]; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t45 = t44/t35; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t46 = t45 - t39; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - s*omega_n*I1*R*m*V/Theta */
    const double t47 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t48 = -t47; /* -omega_tau*gamma3 */
    const double t49 = x[4]*t47; /* s*omega_tau*gamma3 */
    const double t50 = -t49; /* -s*omega_tau*gamma3 */
    const double t51 = x[2]*2.0; /* omega_tau*2 */
    const double t52 = x[4]*t51; /* s*omega_tau*2 */
    const double t53 = p[1]*t13; /* R*omega_n*omega_n */
    const double t54 = x[3]*x[3]; /* omega3*omega3 */
    const double t55 = t4*t54; /* R*I3*omega3*omega3 */
    const double t56 = t55/p[4]; /* R*I3*omega3*omega3/I1 */
    const double t57 = t53 + t56; /* R*omega_n*omega_n + R*I3*omega3*omega3/I1 */
    const double t58 = t5*t8; /* R*I3*gamma3*omega_n */
    const double t59 = x[3]*t58; /* omega3*R*I3*gamma3*omega_n */
    const double t60 = x[4]*p[4]; /* s*I1 */
    const double t61 = t59/t60; /* omega3*R*I3*gamma3*omega_n/(s*I1) */
    const double t62 = 2.0*t61; /* 2*omega3*R*I3*gamma3*omega_n/(s*I1) */
    const double t63 = t57 + t62; /* R*omega_n*omega_n + R*I3*omega3*omega3/I1 + 2*omega3*R*I3*gamma3*omega_n/(s*I1) */
    const double t64 = x[4]*t9; /* s*R*omega_n */
    const double t65 = t6/p[4]; /* R*I3*gamma3*omega3/I1 */
    const double t66 = t64 + t65; /* s*R*omega_n + R*I3*gamma3*omega3/I1 */
    const double t67 = t4*t33; /* R*I3*gamma3*gamma3 */
    const double t68 = t8*t67; /* omega_n*R*I3*gamma3*gamma3 */
    const double t69 = t68/t60; /* omega_n*R*I3*gamma3*gamma3/(s*I1) */
    const double t70 = 2.0*t69; /* 2*omega_n*R*I3*gamma3*gamma3/(s*I1) */
    const double t71 = t66 + t70; /* s*R*omega_n + R*I3*gamma3*omega3/I1 + 2*omega_n*R*I3*gamma3*gamma3/(s*I1) */
    const double t72 = x[3]*t7; /* omega3*(G_level + R*I3*gamma3*omega3) */
    const double t73 = t72/t60; /* omega3*(G_level + R*I3*gamma3*omega3)/(s*I1) */
    const double t74 = t10 - t73; /* omega3*R*omega_n - omega3*(G_level + R*I3*gamma3*omega3)/(s*I1) */
    const double t75 = x[0]*t8; /* gamma3*omega_n */
    const double t76 = t0*p[4]; /* s*s*I1 */
    const double t77 = t7*t75; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n */
    const double t78 = t77/t76; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I1) */
    const double t79 = 2.0*t78; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I1) */
    const double t80 = t74 - t79; /* t74 - 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I1) */
    const double t81 = -t13; /* -omega_n*omega_n */
    const double t82 = p[5]*x[0]; /* I3*gamma3 */
    const double t83 = t8*t82; /* omega_n*I3*gamma3 */
    const double t84 = x[3]*t83; /* omega3*omega_n*I3*gamma3 */
    const double t85 = t84/t60; /* omega3*omega_n*I3*gamma3/(s*I1) */
    const double t86 = 2.0*t85; /* 2*omega3*omega_n*I3*gamma3/(s*I1) */
    const double t87 = t81 - t86; /* -omega_n*omega_n - 2*omega3*omega_n*I3*gamma3/(s*I1) */
    const double t88 = p[4]*p[4]; /* I1*I1 */
    const double t89 = p[5]*p[5]; /* I3*I3 */
    const double t90 = t54*t89; /* omega3*omega3*I3*I3 */
    const double t91 = t90/t88; /* omega3*omega3*I3*I3/(I1*I1) */
    const double t92 = t87 - t91; /* -omega_n*omega_n - 2*omega3*omega_n*I3*gamma3/(s*I1) - omega3*omega3*I3*I3/(I1*I1) */
    const double t93 = x[4]*t18; /* s*I3*omega_n */
    const double t94 = t93/p[4]; /* s*I3*omega_n/I1 */
    const double t95 = -t94; /* -s*I3*omega_n/I1 */
    const double t96 = p[5]*t33; /* I3*gamma3*gamma3 */
    const double t97 = t8*t96; /* omega_n*I3*gamma3*gamma3 */
    const double t98 = t97/t60; /* omega_n*I3*gamma3*gamma3/(s*I1) */
    const double t99 = 2.0*t98; /* 2*omega_n*I3*gamma3*gamma3/(s*I1) */
    const double t100 = t95 - t99; /* -s*I3*omega_n/I1 - 2*omega_n*I3*gamma3*gamma3/(s*I1) */
    const double t101 = x[0]*t89; /* gamma3*I3*I3 */
    const double t102 = x[3]*t101; /* omega3*gamma3*I3*I3 */
    const double t103 = t102/t88; /* omega3*gamma3*I3*I3/(I1*I1) */
    const double t104 = t100 - t103; /* -s*I3*omega_n/I1 - 2*omega_n*I3*gamma3*gamma3/(s*I1) - omega3*gamma3*I3*I3/(I1*I1) */
    const double t105 = t19/p[4]; /* omega3*I3*omega_n/I1 */
    const double t106 = t0*t2; /* s*s*R*I1 */
    const double t107 = t77/t106; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I1) */
    const double t108 = 2.0*t107; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I1) */
    const double t109 = t108 - t105; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I1) - omega3*I3*omega_n/I1 */
    const double t110 = p[1]*t88; /* R*I1*I1 */
    const double t111 = p[5]*x[3]; /* I3*omega3 */
    const double t112 = x[4]*t110; /* s*R*I1*I1 */
    const double t113 = t7*t111; /* (G_level + R*I3*gamma3*omega3)*I3*omega3 */
    const double t114 = t113/t112; /* (G_level + R*I3*gamma3*omega3)*I3*omega3/(s*R*I1*I1) */
    const double t115 = t109 + t114; /* t109 + (G_level + R*I3*gamma3*omega3)*I3*omega3/(s*R*I1*I1) */
    const double t116 = x[2]*t28; /* omega_tau*m*R*R */
    const double t117 = x[3]*t116; /* omega3*omega_tau*m*R*R */
    const double t118 = t0*t117; /* s*s*omega3*omega_tau*m*R*R */
    const double t119 = p[8]*t118; /* (I1 - I3)*s*s*omega3*omega_tau*m*R*R */
    const double t120 = t119/t35; /* (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta */
    const double t121 = p[5]*t23; /* I3*R*m */
    const double t122 = x[3]*t121; /* omega3*I3*R*m */
    const double t123 = t37*t122; /* V*omega3*I3*R*m */
    const double t124 = t123/t35; /* V*omega3*I3*R*m/Theta */
    const double t125 = t120 - t124; /* (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta - V*omega3*I3*R*m/Theta */
    const double t126 = p[0]*p[0]; /* m*m */
    const double t127 = p[1]*t27; /* R*R*R */
    const double t128 = t126*t127; /* m*m*R*R*R */
    const double t129 = p[4]*t128; /* I1*m*m*R*R*R */
    const double t130 = p[5]*t129; /* I3*I1*m*m*R*R*R */
    const double t131 = x[0]*t130; /* gamma3*I3*I1*m*m*R*R*R */
    const double t132 = t8*t131; /* omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t133 = x[4]*t132; /* s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t134 = t35*t35; /* Theta*Theta */
    const double t135 = t37*t133; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t136 = t135/t134; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t137 = 2.0*t136; /* 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t138 = t125 + t137; /* t125 + 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t139 = t27*t27; /* R*R*R*R */
    const double t140 = t126*t139; /* m*m*R*R*R*R */
    const double t141 = p[5]*t140; /* I3*m*m*R*R*R*R */
    const double t142 = t33*t141; /* gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t143 = x[2]*t142; /* omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t144 = x[3]*t143; /* omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t145 = t0*t144; /* s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t146 = p[8]*t145; /* (I1 - I3)*s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t147 = t146/t134; /* (I1 - I3)*s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t148 = 2.0*t147; /* 2*t147 */
    const double t149 = t138 - t148; /* t125 + 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) - 2*t147 */
    const double t150 = t26/t35; /* s*omega_n*I1*R*m/Theta */
    const double t151 = -t150; /* -s*omega_n*I1*R*m/Theta */
    const double t152 = x[3]*t40; /* omega3*gamma3*m*R*R */
    const double t153 = t0*t152; /* s*s*omega3*gamma3*m*R*R */
    const double t154 = p[8]*t153; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R */
    const double t155 = t154/t35; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta */
    const double t156 = t8*t29; /* omega_n*I1*m*R*R */
    const double t157 = x[4]*t156; /* s*omega_n*I1*m*R*R */
    const double t158 = t157/t35; /* s*omega_n*I1*m*R*R/Theta */
    const double t159 = t155 - t158; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta - s*omega_n*I1*m*R*R/Theta */
    const double t160 = t0*t41; /* s*s*omega_tau*gamma3*m*R*R */
    const double t161 = p[8]*t160; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R */
    const double t162 = t161/t35; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta */
    const double t163 = x[0]*t121; /* gamma3*I3*R*m */
    const double t164 = t37*t163; /* V*gamma3*I3*R*m */
    const double t165 = t164/t35; /* V*gamma3*I3*R*m/Theta */
    const double t166 = t162 - t165; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta - V*gamma3*I3*R*m/Theta */
    const double t167 = t25*t37; /* omega_n*I1*R*m*V */
    const double t168 = t167/t35; /* omega_n*I1*R*m*V/Theta */
    const double t169 = x[4]*t42; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t170 = p[8]*t169; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t171 = t170/t35; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t172 = 2.0*t171; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t173 = t172 - t168; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta - omega_n*I1*R*m*V/Theta */
    const double t174 = t88*t128; /* I1*I1*m*m*R*R*R */
    const double t175 = t8*t174; /* omega_n*I1*I1*m*m*R*R*R */
    const double t176 = t0*t175; /* s*s*omega_n*I1*I1*m*m*R*R*R */
    const double t177 = t37*t176; /* V*s*s*omega_n*I1*I1*m*m*R*R*R */
    const double t178 = t177/t134; /* V*s*s*omega_n*I1*I1*m*m*R*R*R/(Theta*Theta) */
    const double t179 = 2.0*t178; /* 2*V*s*s*omega_n*I1*I1*m*m*R*R*R/(Theta*Theta) */
    const double t180 = t173 + t179; /* t173 + 2*V*s*s*omega_n*I1*I1*m*m*R*R*R/(Theta*Theta) */
    const double t181 = p[4]*t140; /* I1*m*m*R*R*R*R */
    const double t182 = x[0]*t181; /* gamma3*I1*m*m*R*R*R*R */
    const double t183 = x[2]*t182; /* omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t184 = x[3]*t183; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t185 = x[4]*t0; /* s*s*s */
    const double t186 = t184*t185; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s */
    const double t187 = p[8]*t186; /* (I1 - I3)*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s */
    const double t188 = t187/t134; /* (I1 - I3)*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s/(Theta*Theta) */
    const double t189 = 2.0*t188; /* 2*t188 */
    const double t190 = t180 - t189; /* t173 + 2*V*s*s*omega_n*I1*I1*m*m*R*R*R/(Theta*Theta) - 2*t188 */
    const double t191 = x[4]*t35; /* s*Theta */
    const double t192 = p[0]*t37; /* m*V */
    const double t193 = t7*t192; /* (G_level + R*I3*gamma3*omega3)*m*V */
    const double t194 = t193/t191; /* (G_level + R*I3*gamma3*omega3)*m*V/(s*Theta) */
    const double t195 = t190 + t194; /* t190 + (G_level + R*I3*gamma3*omega3)*m*V/(s*Theta) */
    const double t196 = x[2]*x[4]; /* omega_tau*s */
    const double t197 = -t196; /* -omega_tau*s */
    const double t198 = x[4]*x[0]; /* s*gamma3 */
    const double t199 = -t198; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t15;
    out[2] = t22;
    out[3] = t46;
    out[4] = t50;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t52;
    out[10] = t63;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t71;
    out[14] = t80;
    out[15] = t92;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t104;
    out[19] = t115;
    out[20] = t149;
    out[21] = t151;
    out[22] = t159;
    out[23] = t166;
    out[24] = t195;
    out[25] = t197;
    out[26] = 0.0;
    out[27] = t199;
    out[28] = 0.0;
    out[29] = t48;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = p[1]*p[1]; /* R*R */
    const double t2 = p[0]*t1; /* m*R*R */
    const double t3 = x[0]*t2; /* gamma3*m*R*R */
    const double t4 = x[2]*t3; /* omega_tau*gamma3*m*R*R */
    const double t5 = x[4]*x[4]; /* s*s */
    const double t6 = t4*t5; /* omega_tau*gamma3*m*R*R*s*s */
    const double t7 = t2*p[4]; /* m*R*R*I1 */
    const double t8 = t5*t7; /* s*s*m*R*R*I1 */
    const double t9 = p[7] + t8; /* I1*I3 + s*s*m*R*R*I1 */
    const double t10 = t2*p[5]; /* m*R*R*I3 */
    const double t11 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t12 = t10*t11; /* m*R*R*I3*gamma3*gamma3 */
    const double t13 = t9 + t12; /* Theta = I1*I3 + s*s*m*R*R*I1 + m*R*R*I3*gamma3*gamma3 */
    const double t14 = t6*p[8]; /* omega_tau*gamma3*m*R*R*s*s*(I1 - I3) */
    const double t15 = t14/t13; /* omega_tau*gamma3*m*R*R*s*s*(I1 - I3)/Theta */
    const double t16 = t15 - t0; /* omega_tau*gamma3*m*R*R*s*s*(I1 - I3)/Theta - gamma3*omega_tau */
    const double t17 = p[0]*p[1]; /* m*R */
    const double t18 = p[5]*t17; /* I3*m*R */
    const double t19 = x[0]*t18; /* gamma3*I3*m*R */
    const double t20 = x[2]*p[1]; /* omega_tau*R */
    const double t21 = x[1] + t20; /* V = v_nu + omega_tau*R */
    const double t22 = t19*t21; /* gamma3*I3*m*R*V */
    const double t23 = t22/t13; /* gamma3*I3*m*R*V/Theta */
    const double t24 = t16 - t23; /* t16 - gamma3*I3*m*R*V/Theta */
    out[0] = t24;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[0]*t0; /* m*v_nu*v_nu */
    const double t2 = t1*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t3 = p[4]*p[1]; /* I1*R */
    const double t4 = t3*x[4]; /* I1*R*s */
    const double t5 = p[1]*p[5]; /* R*I3 */
    const double t6 = t5*x[0]; /* R*I3*gamma3 */
    const double t7 = t6*x[3]; /* R*I3*gamma3*omega3 */
    const double t8 = p[6] + t7; /* G_level + R*I3*gamma3*omega3 */
    const double t9 = t8/t4; /* omega_n = (G_level + R*I3*gamma3*omega3)/(I1*R*s) */
    const double t10 = t9*t9; /* omega_n*omega_n */
    const double t11 = p[4]*t10; /* I1*omega_n*omega_n */
    const double t12 = (1.0 / 2.0)*t11; /* 1/2*I1*omega_n*omega_n */
    const double t13 = t2 + t12; /* m*v_nu*v_nu*1/2 + 1/2*I1*omega_n*omega_n */
    const double t14 = x[3]*x[3]; /* omega3*omega3 */
    const double t15 = p[5]*t14; /* I3*omega3*omega3 */
    const double t16 = (1.0 / 2.0)*t15; /* 1/2*I3*omega3*omega3 */
    const double t17 = t13 + t16; /* m*v_nu*v_nu*1/2 + 1/2*I1*omega_n*omega_n + 1/2*I3*omega3*omega3 */
    const double t18 = p[1]*x[3]; /* R*omega3 */
    const double t19 = x[4]*t18; /* s*R*omega3 */
    const double t20 = p[1]*x[0]; /* R*gamma3 */
    const double t21 = t9*t20; /* omega_n*R*gamma3 */
    const double t22 = t19 + t21; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t23 = t22*t22; /* v_tau*v_tau */
    const double t24 = p[0]*t23; /* m*v_tau*v_tau */
    const double t25 = (1.0 / 2.0)*t24; /* 1/2*m*v_tau*v_tau */
    const double t26 = t17 + t25; /* t17 + 1/2*m*v_tau*v_tau */
    const double t27 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t28 = p[4]*t27; /* I1*omega_tau*omega_tau */
    const double t29 = (1.0 / 2.0)*t28; /* 1/2*I1*omega_tau*omega_tau */
    const double t30 = t26 + t29; /* energy = t17 + 1/2*m*v_tau*v_tau + 1/2*I1*omega_tau*omega_tau */
    const double t31 = p[4]*p[4]; /* I1*I1 */
    const double t32 = p[0]*t31; /* m*I1*I1 */
    const double t33 = p[1]*x[2]; /* R*omega_tau */
    const double t34 = x[1] + t33; /* v_nu + R*omega_tau */
    const double t35 = t34*t34; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t36 = t32*t35; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t37 = p[1]*p[1]; /* R*R */
    const double t38 = p[0]*t37; /* m*R*R */
    const double t39 = p[4]*t38; /* I1*m*R*R */
    const double t40 = x[4]*x[4]; /* s*s */
    const double t41 = t39*t40; /* I1*m*R*R*s*s */
    const double t42 = p[7] + t41; /* I1*I3 + I1*m*R*R*s*s */
    const double t43 = p[5]*t38; /* I3*m*R*R */
    const double t44 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t45 = t43*t44; /* I3*m*R*R*gamma3*gamma3 */
    const double t46 = t42 + t45; /* Theta = I1*I3 + I1*m*R*R*s*s + I3*m*R*R*gamma3*gamma3 */
    const double t47 = t14*t46; /* omega3*omega3*Theta */
    const double t48 = t47*p[8]; /* omega3*omega3*Theta*(I1 - I3) */
    const double t49 = t36 + t48; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) + omega3*omega3*Theta*(I1 - I3) */
    out[0] = t30;
    out[1] = t49;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[4]; /* R*I1 */
    const double t1 = t0*x[4]; /* R*I1*s */
    const double t2 = p[5]*p[1]; /* I3*R */
    const double t3 = t2*x[0]; /* I3*R*gamma3 */
    const double t4 = t3*x[3]; /* I3*R*gamma3*omega3 */
    const double t5 = p[6] + t4; /* G_level + I3*R*gamma3*omega3 */
    const double t6 = t5/t1; /* omega_n = (G_level + I3*R*gamma3*omega3)/(R*I1*s) */
    const double t7 = p[5]*t6; /* I3*omega_n */
    const double t8 = x[3]*t7; /* omega3*I3*omega_n */
    const double t9 = t8/x[4]; /* omega3*I3*omega_n/s */
    const double t10 = p[1]*x[3]; /* R*omega3 */
    const double t11 = x[4]*t10; /* s*R*omega3 */
    const double t12 = p[1]*x[0]; /* R*gamma3 */
    const double t13 = t6*t12; /* omega_n*R*gamma3 */
    const double t14 = t11 + t13; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t15 = p[0]*t14; /* m*v_tau */
    const double t16 = p[1]*t6; /* R*omega_n */
    const double t17 = p[4]*x[4]; /* I1*s */
    const double t18 = t4/t17; /* I3*R*gamma3*omega3/(I1*s) */
    const double t19 = t16 + t18; /* d(v_tau)/d(gamma3) = R*omega_n + I3*R*gamma3*omega3/(I1*s) */
    const double t20 = t15*t19; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t21 = t9 + t20; /* d(energy)/d(gamma3) = omega3*I3*omega_n/s + m*v_tau*d(v_tau)/d(gamma3) */
    const double t22 = p[0]*x[1]; /* m*v_nu */
    const double t23 = p[4]*x[2]; /* I1*omega_tau */
    const double t24 = p[5]*x[3]; /* I3*omega3 */
    const double t25 = p[1]*x[4]; /* R*s */
    const double t26 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t27 = t2*t26; /* I3*R*gamma3*gamma3 */
    const double t28 = t27/t17; /* I3*R*gamma3*gamma3/(I1*s) */
    const double t29 = t25 + t28; /* d(v_tau)/d(omega3) = R*s + I3*R*gamma3*gamma3/(I1*s) */
    const double t30 = t15*t29; /* m*v_tau*d(v_tau)/d(omega3) */
    const double t31 = t24 + t30; /* I3*omega3 + m*v_tau*d(v_tau)/d(omega3) */
    const double t32 = p[5]*x[0]; /* I3*gamma3 */
    const double t33 = t6*t32; /* omega_n*I3*gamma3 */
    const double t34 = t33/x[4]; /* omega_n*I3*gamma3/s */
    const double t35 = t31 + t34; /* d(energy)/d(omega3) = I3*omega3 + m*v_tau*d(v_tau)/d(omega3) + omega_n*I3*gamma3/s */
    const double t36 = x[4]*x[4]; /* s*s */
    const double t37 = p[4]*t36; /* I1*s*s */
    const double t38 = x[0]*t5; /* gamma3*(G_level + I3*R*gamma3*omega3) */
    const double t39 = t38/t37; /* gamma3*(G_level + I3*R*gamma3*omega3)/(I1*s*s) */
    const double t40 = t10 - t39; /* d(v_tau)/d(s) = R*omega3 - gamma3*(G_level + I3*R*gamma3*omega3)/(I1*s*s) */
    const double t41 = t15*t40; /* m*v_tau*d(v_tau)/d(s) */
    const double t42 = p[1]*t36; /* R*s*s */
    const double t43 = t5*t6; /* (G_level + I3*R*gamma3*omega3)*omega_n */
    const double t44 = t43/t42; /* (G_level + I3*R*gamma3*omega3)*omega_n/(R*s*s) */
    const double t45 = t41 - t44; /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) - (G_level + I3*R*gamma3*omega3)*omega_n/(R*s*s) */
    const double t46 = p[0]*2.0; /* m*2 */
    const double t47 = p[1]*p[1]; /* R*R */
    const double t48 = t46*t47; /* m*2*R*R */
    const double t49 = p[5]*t48; /* I3*m*2*R*R */
    const double t50 = x[0]*t49; /* gamma3*I3*m*2*R*R */
    const double t51 = x[3]*x[3]; /* omega3*omega3 */
    const double t52 = t50*t51; /* gamma3*I3*m*2*R*R*omega3*omega3 */
    const double t53 = t52*p[8]; /* gamma3*I3*m*2*R*R*omega3*omega3*(I1 - I3) */
    const double t54 = p[4]*p[4]; /* I1*I1 */
    const double t55 = t46*t54; /* m*2*I1*I1 */
    const double t56 = p[1]*x[2]; /* R*omega_tau */
    const double t57 = x[1] + t56; /* v_nu + R*omega_tau */
    const double t58 = t55*t57; /* m*2*I1*I1*(v_nu + R*omega_tau) */
    const double t59 = p[1]*t46; /* R*m*2 */
    const double t60 = t54*t59; /* I1*I1*R*m*2 */
    const double t61 = t57*t60; /* (v_nu + R*omega_tau)*I1*I1*R*m*2 */
    const double t62 = x[3]*2.0; /* omega3*2 */
    const double t63 = p[0]*t47; /* m*R*R */
    const double t64 = p[4]*t63; /* I1*m*R*R */
    const double t65 = t36*t64; /* s*s*I1*m*R*R */
    const double t66 = p[7] + t65; /* I1*I3 + s*s*I1*m*R*R */
    const double t67 = p[5]*t63; /* I3*m*R*R */
    const double t68 = t26*t67; /* gamma3*gamma3*I3*m*R*R */
    const double t69 = t66 + t68; /* Theta = I1*I3 + s*s*I1*m*R*R + gamma3*gamma3*I3*m*R*R */
    const double t70 = t62*t69; /* omega3*2*Theta */
    const double t71 = p[8]*t70; /* (I1 - I3)*omega3*2*Theta */
    const double t72 = p[4]*t48; /* I1*m*2*R*R */
    const double t73 = t51*t72; /* omega3*omega3*I1*m*2*R*R */
    const double t74 = x[4]*t73; /* s*omega3*omega3*I1*m*2*R*R */
    const double t75 = p[8]*t74; /* (I1 - I3)*s*omega3*omega3*I1*m*2*R*R */
    out[0] = t21;
    out[1] = t22;
    out[2] = t23;
    out[3] = t35;
    out[4] = t45;
    out[5] = t53;
    out[6] = t58;
    out[7] = t61;
    out[8] = t71;
    out[9] = t75;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[4]; /* R*I1 */
    const double t1 = t0*x[4]; /* R*I1*s */
    const double t2 = p[1]*p[5]; /* R*I3 */
    const double t3 = t2*x[0]; /* R*I3*gamma3 */
    const double t4 = t3*x[3]; /* R*I3*gamma3*omega3 */
    const double t5 = p[6] + t4; /* G_level + R*I3*gamma3*omega3 */
    const double t6 = t5/t1; /* omega_n = (G_level + R*I3*gamma3*omega3)/(R*I1*s) */
    out[0] = t6;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "regular",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 9,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 9, 37, 0, 4, 0, 0, 10, 7 }, { 10, 45, 0, 4, 0, 0, 10, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .jacobian = { jacobian, 25, { 31, 122, 0, 29, 0, 0, 13, 18 }, { 42, 208, 0, 29, 0, 0, 13, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 36, 132, 0, 32, 0, 0, 13, 28 }, { 48, 236, 0, 32, 0, 0, 13, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .divergence = { divergence, 1, { 5, 18, 0, 2, 0, 0, 9, 6 }, { 6, 24, 0, 2, 0, 0, 9, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .integral_values = { integral_values, 2, { 10, 39, 0, 1, 0, 0, 12, 6 }, { 11, 43, 0, 1, 0, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 10, { 12, 57, 0, 7, 0, 0, 11, 10 }, { 18, 86, 0, 7, 0, 0, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 1, 5, 0, 1, 0, 0, 5, 3 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_baseline,
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_avx2,
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_avx512,
    },
};
