/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 15   52    0    8    0    0     10    9   (85)
 *  jacobian            48  191    0   41    0    0     16   21   (397)
 *  rhs_jacobian        56  204    0   48    0    0     16   37   (454)
 *  divergence          9   28    0    4    0    0     10    9   (53)
 *  integral_values     9   30    0    1    0    0     12    5   (40)
 *  integral_gradients  14   36    0    7    0    0     12   14   (82)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          2    5    0    1    0    0      5    3   (8)
 *
 *  Accuracy: divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx512;

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
    const double t1 = params[0]*params[2]; /* m*g */
    const double t2 = t1*params[3]; /* m*g*a3 */
    out[7] = t0;
    out[8] = t2;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = p[1]*x[0]; /* R*gamma3 */
    const double t4 = p[3] + t3; /* b = a3 + R*gamma3 */
    const double t5 = t2*t4; /* omega_n*omega_n*b */
    const double t6 = x[3]*p[1]; /* omega_n*R */
    const double t7 = t4*p[5]; /* b*I3 */
    const double t8 = p[1]*p[4]; /* R*I1 */
    const double t9 = x[3]*t8; /* omega_n*R*I1 */
    const double t10 = x[4]*t9; /* s*omega_n*R*I1 */
    const double t11 = t10 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t12 = t11/t7; /* omega3 = (s*omega_n*R*I1 - G_level)/(b*I3) */
    const double t13 = t6*t12; /* omega_n*R*omega3 */
    const double t14 = x[4]*t13; /* s*omega_n*R*omega3 */
    const double t15 = t5 + t14; /* omega_n*omega_n*b + s*omega_n*R*omega3 */
    const double t16 = p[3]*p[3]; /* a3*a3 */
    const double t17 = p[0]*t16; /* m*a3*a3 */
    const double t18 = x[0]*t17; /* gamma3*m*a3*a3 */
    const double t19 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t20 = t18*t19; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t21 = t0*t20; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t22 = t0*t17; /* s*s*m*a3*a3 */
    const double t23 = p[4] + t22; /* D = I1 + s*s*m*a3*a3 */
    const double t24 = t21/t23; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t25 = p[0]*p[2]; /* m*g */
    const double t26 = p[3]*t25; /* a3*m*g */
    const double t27 = t0*t26; /* s*s*a3*m*g */
    const double t28 = t27/t23; /* s*s*a3*m*g/D */
    const double t29 = t24 - t28; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t30 = x[0]*p[4]; /* gamma3*I1 */
    const double t31 = t2*t30; /* omega_n*omega_n*gamma3*I1 */
    const double t32 = t31/t23; /* omega_n*omega_n*gamma3*I1/D */
    const double t33 = t29 - t32; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - omega_n*omega_n*gamma3*I1/D */
    const double t34 = x[3]*p[5]; /* omega_n*I3 */
    const double t35 = t12*t34; /* omega3*omega_n*I3 */
    const double t36 = x[4]*t35; /* s*omega3*omega_n*I3 */
    const double t37 = t36/t23; /* s*omega3*omega_n*I3/D */
    const double t38 = t33 - t37; /* t33 - s*omega3*omega_n*I3/D */
    const double t39 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t40 = x[3]*t39; /* omega_n*omega_tau*gamma3 */
    const double t41 = p[5]*p[0]; /* I3*m */
    const double t42 = x[3]*t41; /* omega_n*I3*m */
    const double t43 = t4*t42; /* b*omega_n*I3*m */
    const double t44 = p[1]*p[1]; /* R*R */
    const double t45 = p[0]*t44; /* m*R*R */
    const double t46 = p[4]*t45; /* I1*m*R*R */
    const double t47 = t0*t46; /* s*s*I1*m*R*R */
    const double t48 = p[7] + t47; /* I1*I3 + s*s*I1*m*R*R */
    const double t49 = t4*t4; /* b*b */
    const double t50 = t41*t49; /* I3*m*b*b */
    const double t51 = t48 + t50; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*b*b */
    const double t52 = p[3]*x[0]; /* a3*gamma3 */
    const double t53 = p[1] + t52; /* e = R + a3*gamma3 */
    const double t54 = x[2]*t53; /* omega_tau*e */
    const double t55 = x[1] + t54; /* V = v_nu + omega_tau*e */
    const double t56 = t43*t55; /* b*omega_n*I3*m*V */
    const double t57 = t56/t51; /* b*omega_n*I3*m*V/Theta */
    const double t58 = t40 - t57; /* omega_n*omega_tau*gamma3 - b*omega_n*I3*m*V/Theta */
    const double t59 = p[5]*p[5]; /* I3*I3 */
    const double t60 = x[2]*t59; /* omega_tau*I3*I3 */
    const double t61 = t12*t60; /* omega3*omega_tau*I3*I3 */
    const double t62 = x[4]*t61; /* s*omega3*omega_tau*I3*I3 */
    const double t63 = t62/t51; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t64 = t58 + t63; /* omega_n*omega_tau*gamma3 - b*omega_n*I3*m*V/Theta + s*omega3*omega_tau*I3*I3/Theta */
    const double t65 = p[1]*p[0]; /* R*m */
    const double t66 = p[5]*t65; /* I3*R*m */
    const double t67 = x[2]*t66; /* omega_tau*I3*R*m */
    const double t68 = t12*t67; /* omega3*omega_tau*I3*R*m */
    const double t69 = x[4]*t68; /* s*omega3*omega_tau*I3*R*m */
    const double t70 = t53*t69; /* e*s*omega3*omega_tau*I3*R*m */
    const double t71 = t70/t51; /* e*s*omega3*omega_tau*I3*R*m/Theta */
    const double t72 = t64 + t71; /* t64 + e*s*omega3*omega_tau*I3*R*m/Theta */
    const double t73 = x[4]*t39; /* s*omega_tau*gamma3 */
    const double t74 = -t73; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t15;
    out[2] = t38;
    out[3] = t72;
    out[4] = t74;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[4]*t1; /* s*2*omega_tau */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = p[1]*p[1]; /* R*R */
    const double t6 = x[3]*t5; /* omega_n*R*R */
    const double t7 = x[4]*t6; /* s*omega_n*R*R */
    const double t8 = p[1]*x[0]; /* R*gamma3 */
    const double t9 = p[3] + t8; /* b = a3 + R*gamma3 */
    const double t10 = t9*t9; /* b*b */
    const double t11 = p[5]*t10; /* I3*b*b */
    const double t12 = p[1]*p[4]; /* R*I1 */
    const double t13 = x[3]*t12; /* omega_n*R*I1 */
    const double t14 = x[4]*t13; /* s*omega_n*R*I1 */
    const double t15 = p[6] - t14; /* G_level - s*omega_n*R*I1 */
    const double t16 = t7*t15; /* s*omega_n*R*R*(G_level - s*omega_n*R*I1) */
    const double t17 = t16/t11; /* s*omega_n*R*R*(G_level - s*omega_n*R*I1)/(I3*b*b) */
    const double t18 = t4 + t17; /* R*omega_n*omega_n + s*omega_n*R*R*(G_level - s*omega_n*R*I1)/(I3*b*b) */
    const double t19 = x[3]*t9; /* omega_n*b */
    const double t20 = 2.0*t19; /* 2*omega_n*b */
    const double t21 = p[5]*t9; /* I3*b */
    const double t22 = t14 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t23 = t22/t21; /* omega3 = (s*omega_n*R*I1 - G_level)/(I3*b) */
    const double t24 = p[1]*t23; /* R*omega3 */
    const double t25 = x[4]*t24; /* s*R*omega3 */
    const double t26 = t20 + t25; /* 2*omega_n*b + s*R*omega3 */
    const double t27 = t5*p[4]; /* R*R*I1 */
    const double t28 = x[3]*t27; /* omega_n*R*R*I1 */
    const double t29 = t0*t28; /* s*s*omega_n*R*R*I1 */
    const double t30 = t29/t21; /* s*s*omega_n*R*R*I1/(I3*b) */
    const double t31 = t26 + t30; /* 2*omega_n*b + s*R*omega3 + s*s*omega_n*R*R*I1/(I3*b) */
    const double t32 = p[1]*x[3]; /* R*omega_n */
    const double t33 = t23*t32; /* omega3*R*omega_n */
    const double t34 = t3*t27; /* omega_n*omega_n*R*R*I1 */
    const double t35 = x[4]*t34; /* s*omega_n*omega_n*R*R*I1 */
    const double t36 = t35/t21; /* s*omega_n*omega_n*R*R*I1/(I3*b) */
    const double t37 = t33 + t36; /* omega3*R*omega_n + s*omega_n*omega_n*R*R*I1/(I3*b) */
    const double t38 = p[3]*p[3]; /* a3*a3 */
    const double t39 = p[0]*t38; /* m*a3*a3 */
    const double t40 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t41 = t39*t40; /* m*a3*a3*omega_tau*omega_tau */
    const double t42 = t0*t41; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t43 = t0*t39; /* s*s*m*a3*a3 */
    const double t44 = p[4] + t43; /* D = I1 + s*s*m*a3*a3 */
    const double t45 = t42/t44; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t46 = t3*p[4]; /* omega_n*omega_n*I1 */
    const double t47 = t46/t44; /* omega_n*omega_n*I1/D */
    const double t48 = t45 - t47; /* s*s*m*a3*a3*omega_tau*omega_tau/D - omega_n*omega_n*I1/D */
    const double t49 = x[4]*t32; /* s*R*omega_n */
    const double t50 = t10*t44; /* b*b*D */
    const double t51 = t15*t49; /* (G_level - s*omega_n*R*I1)*s*R*omega_n */
    const double t52 = t51/t50; /* (G_level - s*omega_n*R*I1)*s*R*omega_n/(b*b*D) */
    const double t53 = t48 - t52; /* s*s*m*a3*a3*omega_tau*omega_tau/D - omega_n*omega_n*I1/D - (G_level - s*omega_n*R*I1)*s*R*omega_n/(b*b*D) */
    const double t54 = 2.0*p[0]; /* 2*m */
    const double t55 = t38*t54; /* a3*a3*2*m */
    const double t56 = x[0]*t55; /* gamma3*a3*a3*2*m */
    const double t57 = x[2]*t56; /* omega_tau*gamma3*a3*a3*2*m */
    const double t58 = t0*t57; /* s*s*omega_tau*gamma3*a3*a3*2*m */
    const double t59 = t58/t44; /* s*s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t60 = x[0]*p[4]; /* gamma3*I1 */
    const double t61 = x[3]*t60; /* omega_n*gamma3*I1 */
    const double t62 = t61/t44; /* omega_n*gamma3*I1/D */
    const double t63 = 2.0*t62; /* 2*omega_n*gamma3*I1/D */
    const double t64 = -t63; /* -2*omega_n*gamma3*I1/D */
    const double t65 = p[5]*t23; /* I3*omega3 */
    const double t66 = x[4]*t65; /* s*I3*omega3 */
    const double t67 = t66/t44; /* s*I3*omega3/D */
    const double t68 = t64 - t67; /* -2*omega_n*gamma3*I1/D - s*I3*omega3/D */
    const double t69 = t0*t13; /* s*s*omega_n*R*I1 */
    const double t70 = t9*t44; /* b*D */
    const double t71 = t69/t70; /* s*s*omega_n*R*I1/(b*D) */
    const double t72 = t68 - t71; /* -2*omega_n*gamma3*I1/D - s*I3*omega3/D - s*s*omega_n*R*I1/(b*D) */
    const double t73 = x[0]*t39; /* gamma3*m*a3*a3 */
    const double t74 = t40*t73; /* omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t75 = x[4]*t74; /* s*omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t76 = t75/t44; /* s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t77 = 2.0*t76; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t78 = p[0]*p[2]; /* m*g */
    const double t79 = p[3]*t78; /* a3*m*g */
    const double t80 = x[4]*t79; /* s*a3*m*g */
    const double t81 = t80/t44; /* s*a3*m*g/D */
    const double t82 = 2.0*t81; /* 2*s*a3*m*g/D */
    const double t83 = t77 - t82; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D */
    const double t84 = x[3]*p[5]; /* omega_n*I3 */
    const double t85 = t23*t84; /* omega3*omega_n*I3 */
    const double t86 = t85/t44; /* omega3*omega_n*I3/D */
    const double t87 = t83 - t86; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D - omega3*omega_n*I3/D */
    const double t88 = p[0]*p[0]; /* m*m */
    const double t89 = t38*t38; /* a3*a3*a3*a3 */
    const double t90 = t88*t89; /* m*m*a3*a3*a3*a3 */
    const double t91 = x[0]*t90; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t92 = t40*t91; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t93 = x[4]*t0; /* s*s*s */
    const double t94 = t92*t93; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t95 = t44*t44; /* D*D */
    const double t96 = t94/t95; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t97 = 2.0*t96; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t98 = t87 - t97; /* t87 - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t99 = p[2]*t88; /* g*m*m */
    const double t100 = p[3]*t38; /* a3*a3*a3 */
    const double t101 = t99*t100; /* g*m*m*a3*a3*a3 */
    const double t102 = t93*t101; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t103 = t102/t95; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t104 = 2.0*t103; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t105 = t98 + t104; /* t98 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t106 = p[4]*t39; /* I1*m*a3*a3 */
    const double t107 = x[0]*t106; /* gamma3*I1*m*a3*a3 */
    const double t108 = t3*t107; /* omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t109 = x[4]*t108; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t110 = t109/t95; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t111 = 2.0*t110; /* 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t112 = t105 + t111; /* t98 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t113 = p[5]*t39; /* I3*m*a3*a3 */
    const double t114 = x[3]*t113; /* omega_n*I3*m*a3*a3 */
    const double t115 = t23*t114; /* omega3*omega_n*I3*m*a3*a3 */
    const double t116 = t0*t115; /* s*s*omega3*omega_n*I3*m*a3*a3 */
    const double t117 = t116/t95; /* s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t118 = 2.0*t117; /* 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t119 = t112 + t118; /* t112 + 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t120 = t3*t12; /* omega_n*omega_n*R*I1 */
    const double t121 = x[4]*t120; /* s*omega_n*omega_n*R*I1 */
    const double t122 = t121/t70; /* s*omega_n*omega_n*R*I1/(b*D) */
    const double t123 = t119 - t122; /* t112 + 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) - s*omega_n*omega_n*R*I1/(b*D) */
    const double t124 = p[1]*p[0]; /* R*m */
    const double t125 = p[3]*t124; /* a3*R*m */
    const double t126 = p[5]*t125; /* I3*a3*R*m */
    const double t127 = x[2]*t126; /* omega_tau*I3*a3*R*m */
    const double t128 = t23*t127; /* omega3*omega_tau*I3*a3*R*m */
    const double t129 = x[4]*t128; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t130 = t5*p[0]; /* R*R*m */
    const double t131 = p[4]*t130; /* I1*R*R*m */
    const double t132 = t0*t131; /* s*s*I1*R*R*m */
    const double t133 = p[7] + t132; /* I1*I3 + s*s*I1*R*R*m */
    const double t134 = p[5]*p[0]; /* I3*m */
    const double t135 = t10*t134; /* b*b*I3*m */
    const double t136 = t133 + t135; /* Theta = I1*I3 + s*s*I1*R*R*m + b*b*I3*m */
    const double t137 = t129/t136; /* s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t138 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t139 = t137 + t138; /* s*omega3*omega_tau*I3*a3*R*m/Theta + omega_tau*omega_n */
    const double t140 = p[5]*t124; /* I3*R*m */
    const double t141 = x[3]*t140; /* omega_n*I3*R*m */
    const double t142 = p[3]*x[0]; /* a3*gamma3 */
    const double t143 = p[1] + t142; /* e = R + a3*gamma3 */
    const double t144 = x[2]*t143; /* omega_tau*e */
    const double t145 = x[1] + t144; /* V = v_nu + omega_tau*e */
    const double t146 = t141*t145; /* omega_n*I3*R*m*V */
    const double t147 = t146/t136; /* omega_n*I3*R*m*V/Theta */
    const double t148 = t139 - t147; /* s*omega3*omega_tau*I3*a3*R*m/Theta + omega_tau*omega_n - omega_n*I3*R*m*V/Theta */
    const double t149 = p[3]*p[0]; /* a3*m */
    const double t150 = p[5]*t149; /* I3*a3*m */
    const double t151 = x[2]*t150; /* omega_tau*I3*a3*m */
    const double t152 = x[3]*t151; /* omega_n*omega_tau*I3*a3*m */
    const double t153 = t9*t152; /* b*omega_n*omega_tau*I3*a3*m */
    const double t154 = t153/t136; /* b*omega_n*omega_tau*I3*a3*m/Theta */
    const double t155 = t148 - t154; /* t148 - b*omega_n*omega_tau*I3*a3*m/Theta */
    const double t156 = p[1]*t88; /* R*m*m */
    const double t157 = p[5]*p[5]; /* I3*I3 */
    const double t158 = t156*t157; /* R*m*m*I3*I3 */
    const double t159 = x[3]*t158; /* omega_n*R*m*m*I3*I3 */
    const double t160 = t10*t159; /* b*b*omega_n*R*m*m*I3*I3 */
    const double t161 = t136*t136; /* Theta*Theta */
    const double t162 = t145*t160; /* V*b*b*omega_n*R*m*m*I3*I3 */
    const double t163 = t162/t161; /* V*b*b*omega_n*R*m*m*I3*I3/(Theta*Theta) */
    const double t164 = 2.0*t163; /* 2*V*b*b*omega_n*R*m*m*I3*I3/(Theta*Theta) */
    const double t165 = t155 + t164; /* t148 - b*omega_n*omega_tau*I3*a3*m/Theta + 2*V*b*b*omega_n*R*m*m*I3*I3/(Theta*Theta) */
    const double t166 = p[5]*t157; /* I3*I3*I3 */
    const double t167 = t124*t166; /* R*m*I3*I3*I3 */
    const double t168 = x[2]*t167; /* omega_tau*R*m*I3*I3*I3 */
    const double t169 = t23*t168; /* omega3*omega_tau*R*m*I3*I3*I3 */
    const double t170 = x[4]*t169; /* s*omega3*omega_tau*R*m*I3*I3*I3 */
    const double t171 = t9*t170; /* b*s*omega3*omega_tau*R*m*I3*I3*I3 */
    const double t172 = t171/t161; /* b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t173 = 2.0*t172; /* 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t174 = t165 - t173; /* t165 - 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t175 = t5*t88; /* R*R*m*m */
    const double t176 = t157*t175; /* I3*I3*R*R*m*m */
    const double t177 = x[2]*t176; /* omega_tau*I3*I3*R*R*m*m */
    const double t178 = t23*t177; /* omega3*omega_tau*I3*I3*R*R*m*m */
    const double t179 = x[4]*t178; /* s*omega3*omega_tau*I3*I3*R*R*m*m */
    const double t180 = t9*t179; /* b*s*omega3*omega_tau*I3*I3*R*R*m*m */
    const double t181 = t143*t180; /* e*b*s*omega3*omega_tau*I3*I3*R*R*m*m */
    const double t182 = t181/t161; /* e*b*s*omega3*omega_tau*I3*I3*R*R*m*m/(Theta*Theta) */
    const double t183 = 2.0*t182; /* 2*e*b*s*omega3*omega_tau*I3*I3*R*R*m*m/(Theta*Theta) */
    const double t184 = t174 - t183; /* t165 - 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) - 2*e*b*s*omega3*omega_tau*I3*I3*R*R*m*m/(Theta*Theta) */
    const double t185 = p[1]*p[5]; /* R*I3 */
    const double t186 = x[2]*t185; /* omega_tau*R*I3 */
    const double t187 = x[4]*t186; /* s*omega_tau*R*I3 */
    const double t188 = t10*t136; /* b*b*Theta */
    const double t189 = t15*t187; /* (G_level - s*omega_n*R*I1)*s*omega_tau*R*I3 */
    const double t190 = t189/t188; /* (G_level - s*omega_n*R*I1)*s*omega_tau*R*I3/(b*b*Theta) */
    const double t191 = t184 + t190; /* t184 + (G_level - s*omega_n*R*I1)*s*omega_tau*R*I3/(b*b*Theta) */
    const double t192 = x[2]*t130; /* omega_tau*R*R*m */
    const double t193 = x[4]*t192; /* s*omega_tau*R*R*m */
    const double t194 = t143*t193; /* e*s*omega_tau*R*R*m */
    const double t195 = t15*t194; /* (G_level - s*omega_n*R*I1)*e*s*omega_tau*R*R*m */
    const double t196 = t195/t188; /* (G_level - s*omega_n*R*I1)*e*s*omega_tau*R*R*m/(b*b*Theta) */
    const double t197 = t191 + t196; /* t191 + (G_level - s*omega_n*R*I1)*e*s*omega_tau*R*R*m/(b*b*Theta) */
    const double t198 = x[3]*t134; /* omega_n*I3*m */
    const double t199 = t9*t198; /* b*omega_n*I3*m */
    const double t200 = t199/t136; /* b*omega_n*I3*m/Theta */
    const double t201 = -t200; /* -b*omega_n*I3*m/Theta */
    const double t202 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t203 = t143*t199; /* e*b*omega_n*I3*m */
    const double t204 = t203/t136; /* e*b*omega_n*I3*m/Theta */
    const double t205 = t202 - t204; /* omega_n*gamma3 - e*b*omega_n*I3*m/Theta */
    const double t206 = t23*t157; /* omega3*I3*I3 */
    const double t207 = x[4]*t206; /* s*omega3*I3*I3 */
    const double t208 = t207/t136; /* s*omega3*I3*I3/Theta */
    const double t209 = t205 + t208; /* omega_n*gamma3 - e*b*omega_n*I3*m/Theta + s*omega3*I3*I3/Theta */
    const double t210 = t23*t140; /* omega3*I3*R*m */
    const double t211 = x[4]*t210; /* s*omega3*I3*R*m */
    const double t212 = t143*t211; /* e*s*omega3*I3*R*m */
    const double t213 = t212/t136; /* e*s*omega3*I3*R*m/Theta */
    const double t214 = t209 + t213; /* t209 + e*s*omega3*I3*R*m/Theta */
    const double t215 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t216 = t9*t134; /* b*I3*m */
    const double t217 = t145*t216; /* V*b*I3*m */
    const double t218 = t217/t136; /* V*b*I3*m/Theta */
    const double t219 = t215 - t218; /* omega_tau*gamma3 - V*b*I3*m/Theta */
    const double t220 = p[5]*t12; /* I3*R*I1 */
    const double t221 = x[2]*t220; /* omega_tau*I3*R*I1 */
    const double t222 = t0*t221; /* s*s*omega_tau*I3*R*I1 */
    const double t223 = t9*t136; /* b*Theta */
    const double t224 = t222/t223; /* s*s*omega_tau*I3*R*I1/(b*Theta) */
    const double t225 = t219 + t224; /* omega_tau*gamma3 - V*b*I3*m/Theta + s*s*omega_tau*I3*R*I1/(b*Theta) */
    const double t226 = x[2]*t131; /* omega_tau*I1*R*R*m */
    const double t227 = t0*t226; /* s*s*omega_tau*I1*R*R*m */
    const double t228 = t143*t227; /* e*s*s*omega_tau*I1*R*R*m */
    const double t229 = t228/t223; /* e*s*s*omega_tau*I1*R*R*m/(b*Theta) */
    const double t230 = t225 + t229; /* t225 + e*s*s*omega_tau*I1*R*R*m/(b*Theta) */
    const double t231 = x[2]*t157; /* omega_tau*I3*I3 */
    const double t232 = t23*t231; /* omega3*omega_tau*I3*I3 */
    const double t233 = t232/t136; /* omega3*omega_tau*I3*I3/Theta */
    const double t234 = x[2]*t140; /* omega_tau*I3*R*m */
    const double t235 = t23*t234; /* omega3*omega_tau*I3*R*m */
    const double t236 = t143*t235; /* e*omega3*omega_tau*I3*R*m */
    const double t237 = t236/t136; /* e*omega3*omega_tau*I3*R*m/Theta */
    const double t238 = t233 + t237; /* omega3*omega_tau*I3*I3/Theta + e*omega3*omega_tau*I3*R*m/Theta */
    const double t239 = p[4]*t175; /* I1*R*R*m*m */
    const double t240 = p[5]*t239; /* I3*I1*R*R*m*m */
    const double t241 = x[3]*t240; /* omega_n*I3*I1*R*R*m*m */
    const double t242 = x[4]*t241; /* s*omega_n*I3*I1*R*R*m*m */
    const double t243 = t9*t242; /* b*s*omega_n*I3*I1*R*R*m*m */
    const double t244 = t145*t243; /* V*b*s*omega_n*I3*I1*R*R*m*m */
    const double t245 = t244/t161; /* V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t246 = 2.0*t245; /* 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t247 = t238 + t246; /* t238 + 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t248 = t131*t157; /* I1*R*R*m*I3*I3 */
    const double t249 = x[2]*t248; /* omega_tau*I1*R*R*m*I3*I3 */
    const double t250 = t23*t249; /* omega3*omega_tau*I1*R*R*m*I3*I3 */
    const double t251 = t0*t250; /* s*s*omega3*omega_tau*I1*R*R*m*I3*I3 */
    const double t252 = t251/t161; /* s*s*omega3*omega_tau*I1*R*R*m*I3*I3/(Theta*Theta) */
    const double t253 = 2.0*t252; /* 2*s*s*omega3*omega_tau*I1*R*R*m*I3*I3/(Theta*Theta) */
    const double t254 = t247 - t253; /* t238 + 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) - 2*s*s*omega3*omega_tau*I1*R*R*m*I3*I3/(Theta*Theta) */
    const double t255 = p[1]*t5; /* R*R*R */
    const double t256 = t88*t255; /* m*m*R*R*R */
    const double t257 = p[4]*t256; /* I1*m*m*R*R*R */
    const double t258 = p[5]*t257; /* I3*I1*m*m*R*R*R */
    const double t259 = x[2]*t258; /* omega_tau*I3*I1*m*m*R*R*R */
    const double t260 = t23*t259; /* omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t261 = t0*t260; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t262 = t143*t261; /* e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t263 = t262/t161; /* e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t264 = 2.0*t263; /* 2*e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t265 = t254 - t264; /* t254 - 2*e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t266 = x[3]*t221; /* omega_n*omega_tau*I3*R*I1 */
    const double t267 = x[4]*t266; /* s*omega_n*omega_tau*I3*R*I1 */
    const double t268 = t267/t223; /* s*omega_n*omega_tau*I3*R*I1/(b*Theta) */
    const double t269 = t265 + t268; /* t265 + s*omega_n*omega_tau*I3*R*I1/(b*Theta) */
    const double t270 = x[3]*t226; /* omega_n*omega_tau*I1*R*R*m */
    const double t271 = x[4]*t270; /* s*omega_n*omega_tau*I1*R*R*m */
    const double t272 = t143*t271; /* e*s*omega_n*omega_tau*I1*R*R*m */
    const double t273 = t272/t223; /* e*s*omega_n*omega_tau*I1*R*R*m/(b*Theta) */
    const double t274 = t269 + t273; /* t265 + s*omega_n*omega_tau*I3*R*I1/(b*Theta) + e*s*omega_n*omega_tau*I1*R*R*m/(b*Theta) */
    const double t275 = x[4]*x[2]; /* s*omega_tau */
    const double t276 = -t275; /* -s*omega_tau */
    const double t277 = x[4]*x[0]; /* s*gamma3 */
    const double t278 = -t277; /* -s*gamma3 */
    const double t279 = -t215; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t18;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t31;
    out[9] = t37;
    out[10] = t53;
    out[11] = 0.0;
    out[12] = t59;
    out[13] = t72;
    out[14] = t123;
    out[15] = t197;
    out[16] = t201;
    out[17] = t214;
    out[18] = t230;
    out[19] = t274;
    out[20] = t276;
    out[21] = 0.0;
    out[22] = t278;
    out[23] = 0.0;
    out[24] = t279;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = p[1]*x[0]; /* R*gamma3 */
    const double t4 = p[3] + t3; /* b = a3 + R*gamma3 */
    const double t5 = t2*t4; /* omega_n*omega_n*b */
    const double t6 = x[3]*p[1]; /* omega_n*R */
    const double t7 = t4*p[5]; /* b*I3 */
    const double t8 = p[1]*p[4]; /* R*I1 */
    const double t9 = x[3]*t8; /* omega_n*R*I1 */
    const double t10 = x[4]*t9; /* s*omega_n*R*I1 */
    const double t11 = p[6] - t10; /* G_level - s*omega_n*R*I1 */
    const double t12 = t10 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t13 = t12/t7; /* omega3 = (s*omega_n*R*I1 - G_level)/(b*I3) */
    const double t14 = t6*t13; /* omega_n*R*omega3 */
    const double t15 = x[4]*t14; /* s*omega_n*R*omega3 */
    const double t16 = t5 + t15; /* omega_n*omega_n*b + s*omega_n*R*omega3 */
    const double t17 = p[3]*p[3]; /* a3*a3 */
    const double t18 = p[0]*t17; /* m*a3*a3 */
    const double t19 = x[0]*t18; /* gamma3*m*a3*a3 */
    const double t20 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t21 = t19*t20; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t22 = t0*t21; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t23 = t0*t18; /* s*s*m*a3*a3 */
    const double t24 = p[4] + t23; /* D = I1 + s*s*m*a3*a3 */
    const double t25 = t22/t24; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t26 = p[0]*p[2]; /* m*g */
    const double t27 = p[3]*t26; /* a3*m*g */
    const double t28 = t0*t27; /* s*s*a3*m*g */
    const double t29 = t28/t24; /* s*s*a3*m*g/D */
    const double t30 = t25 - t29; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t31 = x[0]*p[4]; /* gamma3*I1 */
    const double t32 = t2*t31; /* omega_n*omega_n*gamma3*I1 */
    const double t33 = t32/t24; /* omega_n*omega_n*gamma3*I1/D */
    const double t34 = t30 - t33; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - omega_n*omega_n*gamma3*I1/D */
    const double t35 = x[3]*p[5]; /* omega_n*I3 */
    const double t36 = t13*t35; /* omega3*omega_n*I3 */
    const double t37 = x[4]*t36; /* s*omega3*omega_n*I3 */
    const double t38 = t37/t24; /* s*omega3*omega_n*I3/D */
    const double t39 = t34 - t38; /* t34 - s*omega3*omega_n*I3/D */
    const double t40 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t41 = x[3]*t40; /* omega_n*omega_tau*gamma3 */
    const double t42 = p[5]*p[0]; /* I3*m */
    const double t43 = x[3]*t42; /* omega_n*I3*m */
    const double t44 = t4*t43; /* b*omega_n*I3*m */
    const double t45 = p[1]*p[1]; /* R*R */
    const double t46 = p[0]*t45; /* m*R*R */
    const double t47 = p[4]*t46; /* I1*m*R*R */
    const double t48 = t0*t47; /* s*s*I1*m*R*R */
    const double t49 = p[7] + t48; /* I1*I3 + s*s*I1*m*R*R */
    const double t50 = t4*t4; /* b*b */
    const double t51 = t42*t50; /* I3*m*b*b */
    const double t52 = t49 + t51; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*b*b */
    const double t53 = p[3]*x[0]; /* a3*gamma3 */
    const double t54 = p[1] + t53; /* e = R + a3*gamma3 */
    const double t55 = x[2]*t54; /* omega_tau*e */
    const double t56 = x[1] + t55; /* V = v_nu + omega_tau*e */
    const double t57 = t44*t56; /* b*omega_n*I3*m*V */
    const double t58 = t57/t52; /* b*omega_n*I3*m*V/Theta */
    const double t59 = t41 - t58; /* omega_n*omega_tau*gamma3 - b*omega_n*I3*m*V/Theta */
    const double t60 = p[5]*p[5]; /* I3*I3 */
    const double t61 = x[2]*t60; /* omega_tau*I3*I3 */
    const double t62 = t13*t61; /* omega3*omega_tau*I3*I3 */
    const double t63 = x[4]*t62; /* s*omega3*omega_tau*I3*I3 */
    const double t64 = t63/t52; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t65 = t59 + t64; /* omega_n*omega_tau*gamma3 - b*omega_n*I3*m*V/Theta + s*omega3*omega_tau*I3*I3/Theta */
    const double t66 = p[1]*p[0]; /* R*m */
    const double t67 = p[5]*t66; /* I3*R*m */
    const double t68 = x[2]*t67; /* omega_tau*I3*R*m */
    const double t69 = t13*t68; /* omega3*omega_tau*I3*R*m */
    const double t70 = x[4]*t69; /* s*omega3*omega_tau*I3*R*m */
    const double t71 = t54*t70; /* e*s*omega3*omega_tau*I3*R*m */
    const double t72 = t71/t52; /* e*s*omega3*omega_tau*I3*R*m/Theta */
    const double t73 = t65 + t72; /* t65 + e*s*omega3*omega_tau*I3*R*m/Theta */
    const double t74 = -t40; /* -omega_tau*gamma3 */
    const double t75 = x[4]*t40; /* s*omega_tau*gamma3 */
    const double t76 = -t75; /* -s*omega_tau*gamma3 */
    const double t77 = x[2]*2.0; /* omega_tau*2 */
    const double t78 = x[4]*t77; /* s*omega_tau*2 */
    const double t79 = t2*p[1]; /* omega_n*omega_n*R */
    const double t80 = x[3]*t45; /* omega_n*R*R */
    const double t81 = x[4]*t80; /* s*omega_n*R*R */
    const double t82 = p[5]*t50; /* I3*b*b */
    const double t83 = t11*t81; /* (G_level - s*omega_n*R*I1)*s*omega_n*R*R */
    const double t84 = t83/t82; /* (G_level - s*omega_n*R*I1)*s*omega_n*R*R/(I3*b*b) */
    const double t85 = t79 + t84; /* omega_n*omega_n*R + (G_level - s*omega_n*R*I1)*s*omega_n*R*R/(I3*b*b) */
    const double t86 = x[3]*t4; /* omega_n*b */
    const double t87 = 2.0*t86; /* 2*omega_n*b */
    const double t88 = p[1]*t13; /* R*omega3 */
    const double t89 = x[4]*t88; /* s*R*omega3 */
    const double t90 = t87 + t89; /* 2*omega_n*b + s*R*omega3 */
    const double t91 = p[4]*t45; /* I1*R*R */
    const double t92 = x[3]*t91; /* omega_n*I1*R*R */
    const double t93 = t0*t92; /* s*s*omega_n*I1*R*R */
    const double t94 = t93/t7; /* s*s*omega_n*I1*R*R/(b*I3) */
    const double t95 = t90 + t94; /* 2*omega_n*b + s*R*omega3 + s*s*omega_n*I1*R*R/(b*I3) */
    const double t96 = t2*t91; /* omega_n*omega_n*I1*R*R */
    const double t97 = x[4]*t96; /* s*omega_n*omega_n*I1*R*R */
    const double t98 = t97/t7; /* s*omega_n*omega_n*I1*R*R/(b*I3) */
    const double t99 = t14 + t98; /* omega_n*R*omega3 + s*omega_n*omega_n*I1*R*R/(b*I3) */
    const double t100 = t18*t20; /* m*a3*a3*omega_tau*omega_tau */
    const double t101 = t0*t100; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t102 = t101/t24; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t103 = t2*p[4]; /* omega_n*omega_n*I1 */
    const double t104 = t103/t24; /* omega_n*omega_n*I1/D */
    const double t105 = t102 - t104; /* s*s*m*a3*a3*omega_tau*omega_tau/D - omega_n*omega_n*I1/D */
    const double t106 = x[4]*t6; /* s*omega_n*R */
    const double t107 = t24*t50; /* D*b*b */
    const double t108 = t11*t106; /* (G_level - s*omega_n*R*I1)*s*omega_n*R */
    const double t109 = t108/t107; /* (G_level - s*omega_n*R*I1)*s*omega_n*R/(D*b*b) */
    const double t110 = t105 - t109; /* s*s*m*a3*a3*omega_tau*omega_tau/D - omega_n*omega_n*I1/D - (G_level - s*omega_n*R*I1)*s*omega_n*R/(D*b*b) */
    const double t111 = p[0]*2.0; /* m*2 */
    const double t112 = t17*t111; /* a3*a3*m*2 */
    const double t113 = x[0]*t112; /* gamma3*a3*a3*m*2 */
    const double t114 = x[2]*t113; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t115 = t0*t114; /* s*s*omega_tau*gamma3*a3*a3*m*2 */
    const double t116 = t115/t24; /* s*s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t117 = x[3]*t31; /* omega_n*gamma3*I1 */
    const double t118 = t117/t24; /* omega_n*gamma3*I1/D */
    const double t119 = 2.0*t118; /* 2*omega_n*gamma3*I1/D */
    const double t120 = -t119; /* -2*omega_n*gamma3*I1/D */
    const double t121 = p[5]*t13; /* I3*omega3 */
    const double t122 = x[4]*t121; /* s*I3*omega3 */
    const double t123 = t122/t24; /* s*I3*omega3/D */
    const double t124 = t120 - t123; /* -2*omega_n*gamma3*I1/D - s*I3*omega3/D */
    const double t125 = t0*t9; /* s*s*omega_n*R*I1 */
    const double t126 = t4*t24; /* b*D */
    const double t127 = t125/t126; /* s*s*omega_n*R*I1/(b*D) */
    const double t128 = t124 - t127; /* -2*omega_n*gamma3*I1/D - s*I3*omega3/D - s*s*omega_n*R*I1/(b*D) */
    const double t129 = x[4]*t21; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t130 = t129/t24; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t131 = 2.0*t130; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t132 = x[4]*t27; /* s*a3*m*g */
    const double t133 = t132/t24; /* s*a3*m*g/D */
    const double t134 = 2.0*t133; /* 2*s*a3*m*g/D */
    const double t135 = t131 - t134; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D */
    const double t136 = t36/t24; /* omega3*omega_n*I3/D */
    const double t137 = t135 - t136; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D - omega3*omega_n*I3/D */
    const double t138 = p[0]*p[0]; /* m*m */
    const double t139 = t17*t17; /* a3*a3*a3*a3 */
    const double t140 = t138*t139; /* m*m*a3*a3*a3*a3 */
    const double t141 = x[0]*t140; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t142 = t20*t141; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t143 = x[4]*t0; /* s*s*s */
    const double t144 = t142*t143; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t145 = t24*t24; /* D*D */
    const double t146 = t144/t145; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t147 = 2.0*t146; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t148 = t137 - t147; /* t137 - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t149 = p[2]*t138; /* g*m*m */
    const double t150 = p[3]*t17; /* a3*a3*a3 */
    const double t151 = t149*t150; /* g*m*m*a3*a3*a3 */
    const double t152 = t143*t151; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t153 = t152/t145; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t154 = 2.0*t153; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t155 = t148 + t154; /* t148 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t156 = p[4]*t18; /* I1*m*a3*a3 */
    const double t157 = x[0]*t156; /* gamma3*I1*m*a3*a3 */
    const double t158 = t2*t157; /* omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t159 = x[4]*t158; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t160 = t159/t145; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t161 = 2.0*t160; /* 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t162 = t155 + t161; /* t148 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t163 = p[5]*t18; /* I3*m*a3*a3 */
    const double t164 = x[3]*t163; /* omega_n*I3*m*a3*a3 */
    const double t165 = t13*t164; /* omega3*omega_n*I3*m*a3*a3 */
    const double t166 = t0*t165; /* s*s*omega3*omega_n*I3*m*a3*a3 */
    const double t167 = t166/t145; /* s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t168 = 2.0*t167; /* 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t169 = t162 + t168; /* t162 + 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t170 = t2*t8; /* omega_n*omega_n*R*I1 */
    const double t171 = x[4]*t170; /* s*omega_n*omega_n*R*I1 */
    const double t172 = t171/t126; /* s*omega_n*omega_n*R*I1/(b*D) */
    const double t173 = t169 - t172; /* t162 + 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) - s*omega_n*omega_n*R*I1/(b*D) */
    const double t174 = p[3]*t66; /* a3*R*m */
    const double t175 = p[5]*t174; /* I3*a3*R*m */
    const double t176 = x[2]*t175; /* omega_tau*I3*a3*R*m */
    const double t177 = t13*t176; /* omega3*omega_tau*I3*a3*R*m */
    const double t178 = x[4]*t177; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t179 = t178/t52; /* s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t180 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t181 = t179 + t180; /* s*omega3*omega_tau*I3*a3*R*m/Theta + omega_tau*omega_n */
    const double t182 = x[3]*t67; /* omega_n*I3*R*m */
    const double t183 = t56*t182; /* V*omega_n*I3*R*m */
    const double t184 = t183/t52; /* V*omega_n*I3*R*m/Theta */
    const double t185 = t181 - t184; /* s*omega3*omega_tau*I3*a3*R*m/Theta + omega_tau*omega_n - V*omega_n*I3*R*m/Theta */
    const double t186 = p[3]*p[0]; /* a3*m */
    const double t187 = p[5]*t186; /* I3*a3*m */
    const double t188 = x[2]*t187; /* omega_tau*I3*a3*m */
    const double t189 = x[3]*t188; /* omega_n*omega_tau*I3*a3*m */
    const double t190 = t4*t189; /* b*omega_n*omega_tau*I3*a3*m */
    const double t191 = t190/t52; /* b*omega_n*omega_tau*I3*a3*m/Theta */
    const double t192 = t185 - t191; /* t185 - b*omega_n*omega_tau*I3*a3*m/Theta */
    const double t193 = p[1]*t138; /* R*m*m */
    const double t194 = t60*t193; /* I3*I3*R*m*m */
    const double t195 = x[3]*t194; /* omega_n*I3*I3*R*m*m */
    const double t196 = t50*t195; /* b*b*omega_n*I3*I3*R*m*m */
    const double t197 = t52*t52; /* Theta*Theta */
    const double t198 = t56*t196; /* V*b*b*omega_n*I3*I3*R*m*m */
    const double t199 = t198/t197; /* V*b*b*omega_n*I3*I3*R*m*m/(Theta*Theta) */
    const double t200 = 2.0*t199; /* 2*V*b*b*omega_n*I3*I3*R*m*m/(Theta*Theta) */
    const double t201 = t192 + t200; /* t185 - b*omega_n*omega_tau*I3*a3*m/Theta + 2*V*b*b*omega_n*I3*I3*R*m*m/(Theta*Theta) */
    const double t202 = p[5]*t60; /* I3*I3*I3 */
    const double t203 = t66*t202; /* R*m*I3*I3*I3 */
    const double t204 = x[2]*t203; /* omega_tau*R*m*I3*I3*I3 */
    const double t205 = t13*t204; /* omega3*omega_tau*R*m*I3*I3*I3 */
    const double t206 = x[4]*t205; /* s*omega3*omega_tau*R*m*I3*I3*I3 */
    const double t207 = t4*t206; /* b*s*omega3*omega_tau*R*m*I3*I3*I3 */
    const double t208 = t207/t197; /* b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t209 = 2.0*t208; /* 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t210 = t201 - t209; /* t201 - 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t211 = t45*t138; /* R*R*m*m */
    const double t212 = t60*t211; /* I3*I3*R*R*m*m */
    const double t213 = x[2]*t212; /* omega_tau*I3*I3*R*R*m*m */
    const double t214 = t13*t213; /* omega3*omega_tau*I3*I3*R*R*m*m */
    const double t215 = x[4]*t214; /* s*omega3*omega_tau*I3*I3*R*R*m*m */
    const double t216 = t4*t215; /* b*s*omega3*omega_tau*I3*I3*R*R*m*m */
    const double t217 = t54*t216; /* e*b*s*omega3*omega_tau*I3*I3*R*R*m*m */
    const double t218 = t217/t197; /* e*b*s*omega3*omega_tau*I3*I3*R*R*m*m/(Theta*Theta) */
    const double t219 = 2.0*t218; /* 2*e*b*s*omega3*omega_tau*I3*I3*R*R*m*m/(Theta*Theta) */
    const double t220 = t210 - t219; /* t201 - 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) - 2*e*b*s*omega3*omega_tau*I3*I3*R*R*m*m/(Theta*Theta) */
    const double t221 = p[1]*p[5]; /* R*I3 */
    const double t222 = x[2]*t221; /* omega_tau*R*I3 */
    const double t223 = x[4]*t222; /* s*omega_tau*R*I3 */
    const double t224 = t50*t52; /* b*b*Theta */
    const double t225 = t11*t223; /* (G_level - s*omega_n*R*I1)*s*omega_tau*R*I3 */
    const double t226 = t225/t224; /* (G_level - s*omega_n*R*I1)*s*omega_tau*R*I3/(b*b*Theta) */
    const double t227 = t220 + t226; /* t220 + (G_level - s*omega_n*R*I1)*s*omega_tau*R*I3/(b*b*Theta) */
    const double t228 = x[2]*t46; /* omega_tau*m*R*R */
    const double t229 = x[4]*t228; /* s*omega_tau*m*R*R */
    const double t230 = t54*t229; /* e*s*omega_tau*m*R*R */
    const double t231 = t11*t230; /* (G_level - s*omega_n*R*I1)*e*s*omega_tau*m*R*R */
    const double t232 = t231/t224; /* (G_level - s*omega_n*R*I1)*e*s*omega_tau*m*R*R/(b*b*Theta) */
    const double t233 = t227 + t232; /* t227 + (G_level - s*omega_n*R*I1)*e*s*omega_tau*m*R*R/(b*b*Theta) */
    const double t234 = t44/t52; /* b*omega_n*I3*m/Theta */
    const double t235 = -t234; /* -b*omega_n*I3*m/Theta */
    const double t236 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t237 = t44*t54; /* b*omega_n*I3*m*e */
    const double t238 = t237/t52; /* b*omega_n*I3*m*e/Theta */
    const double t239 = t236 - t238; /* omega_n*gamma3 - b*omega_n*I3*m*e/Theta */
    const double t240 = t13*t60; /* omega3*I3*I3 */
    const double t241 = x[4]*t240; /* s*omega3*I3*I3 */
    const double t242 = t241/t52; /* s*omega3*I3*I3/Theta */
    const double t243 = t239 + t242; /* omega_n*gamma3 - b*omega_n*I3*m*e/Theta + s*omega3*I3*I3/Theta */
    const double t244 = t13*t67; /* omega3*I3*R*m */
    const double t245 = x[4]*t244; /* s*omega3*I3*R*m */
    const double t246 = t54*t245; /* e*s*omega3*I3*R*m */
    const double t247 = t246/t52; /* e*s*omega3*I3*R*m/Theta */
    const double t248 = t243 + t247; /* t243 + e*s*omega3*I3*R*m/Theta */
    const double t249 = t4*t42; /* b*I3*m */
    const double t250 = t56*t249; /* V*b*I3*m */
    const double t251 = t250/t52; /* V*b*I3*m/Theta */
    const double t252 = t40 - t251; /* omega_tau*gamma3 - V*b*I3*m/Theta */
    const double t253 = p[5]*t8; /* I3*R*I1 */
    const double t254 = x[2]*t253; /* omega_tau*I3*R*I1 */
    const double t255 = t0*t254; /* s*s*omega_tau*I3*R*I1 */
    const double t256 = t4*t52; /* b*Theta */
    const double t257 = t255/t256; /* s*s*omega_tau*I3*R*I1/(b*Theta) */
    const double t258 = t252 + t257; /* omega_tau*gamma3 - V*b*I3*m/Theta + s*s*omega_tau*I3*R*I1/(b*Theta) */
    const double t259 = x[2]*t47; /* omega_tau*I1*m*R*R */
    const double t260 = t0*t259; /* s*s*omega_tau*I1*m*R*R */
    const double t261 = t54*t260; /* e*s*s*omega_tau*I1*m*R*R */
    const double t262 = t261/t256; /* e*s*s*omega_tau*I1*m*R*R/(b*Theta) */
    const double t263 = t258 + t262; /* t258 + e*s*s*omega_tau*I1*m*R*R/(b*Theta) */
    const double t264 = t62/t52; /* omega3*omega_tau*I3*I3/Theta */
    const double t265 = t54*t69; /* e*omega3*omega_tau*I3*R*m */
    const double t266 = t265/t52; /* e*omega3*omega_tau*I3*R*m/Theta */
    const double t267 = t264 + t266; /* omega3*omega_tau*I3*I3/Theta + e*omega3*omega_tau*I3*R*m/Theta */
    const double t268 = p[4]*t211; /* I1*R*R*m*m */
    const double t269 = p[5]*t268; /* I3*I1*R*R*m*m */
    const double t270 = x[3]*t269; /* omega_n*I3*I1*R*R*m*m */
    const double t271 = x[4]*t270; /* s*omega_n*I3*I1*R*R*m*m */
    const double t272 = t4*t271; /* b*s*omega_n*I3*I1*R*R*m*m */
    const double t273 = t56*t272; /* V*b*s*omega_n*I3*I1*R*R*m*m */
    const double t274 = t273/t197; /* V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t275 = 2.0*t274; /* 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t276 = t267 + t275; /* t267 + 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t277 = t47*t60; /* I1*m*R*R*I3*I3 */
    const double t278 = x[2]*t277; /* omega_tau*I1*m*R*R*I3*I3 */
    const double t279 = t13*t278; /* omega3*omega_tau*I1*m*R*R*I3*I3 */
    const double t280 = t0*t279; /* s*s*omega3*omega_tau*I1*m*R*R*I3*I3 */
    const double t281 = t280/t197; /* s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t282 = 2.0*t281; /* 2*s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t283 = t276 - t282; /* t267 + 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) - 2*s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t284 = p[1]*t45; /* R*R*R */
    const double t285 = t138*t284; /* m*m*R*R*R */
    const double t286 = p[4]*t285; /* I1*m*m*R*R*R */
    const double t287 = p[5]*t286; /* I3*I1*m*m*R*R*R */
    const double t288 = x[2]*t287; /* omega_tau*I3*I1*m*m*R*R*R */
    const double t289 = t13*t288; /* omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t290 = t0*t289; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t291 = t54*t290; /* e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t292 = t291/t197; /* e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t293 = 2.0*t292; /* 2*e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t294 = t283 - t293; /* t283 - 2*e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t295 = x[3]*t254; /* omega_n*omega_tau*I3*R*I1 */
    const double t296 = x[4]*t295; /* s*omega_n*omega_tau*I3*R*I1 */
    const double t297 = t296/t256; /* s*omega_n*omega_tau*I3*R*I1/(b*Theta) */
    const double t298 = t294 + t297; /* t294 + s*omega_n*omega_tau*I3*R*I1/(b*Theta) */
    const double t299 = x[3]*t259; /* omega_n*omega_tau*I1*m*R*R */
    const double t300 = x[4]*t299; /* s*omega_n*omega_tau*I1*m*R*R */
    const double t301 = t54*t300; /* e*s*omega_n*omega_tau*I1*m*R*R */
    const double t302 = t301/t256; /* e*s*omega_n*omega_tau*I1*m*R*R/(b*Theta) */
    const double t303 = t298 + t302; /* t294 + s*omega_n*omega_tau*I3*R*I1/(b*Theta) + e*s*omega_n*omega_tau*I1*m*R*R/(b*Theta) */
    const double t304 = x[2]*x[4]; /* omega_tau*s */
    const double t305 = -t304; /* -omega_tau*s */
    const double t306 = x[4]*x[0]; /* s*gamma3 */
    const double t307 = -t306; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t16;
    out[2] = t39;
    out[3] = t73;
    out[4] = t76;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t78;
    out[10] = t85;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t95;
    out[14] = t99;
    out[15] = t110;
    out[16] = 0.0;
    out[17] = t116;
    out[18] = t128;
    out[19] = t173;
    out[20] = t233;
    out[21] = t235;
    out[22] = t248;
    out[23] = t263;
    out[24] = t303;
    out[25] = t305;
    out[26] = 0.0;
    out[27] = t307;
    out[28] = 0.0;
    out[29] = t74;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*p[3]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = t2*x[2]; /* m*a3*a3*gamma3*omega_tau */
    const double t4 = x[4]*x[4]; /* s*s */
    const double t5 = t3*t4; /* m*a3*a3*gamma3*omega_tau*s*s */
    const double t6 = t1*t4; /* m*a3*a3*s*s */
    const double t7 = p[4] + t6; /* D = I1 + m*a3*a3*s*s */
    const double t8 = t5/t7; /* m*a3*a3*gamma3*omega_tau*s*s/D */
    const double t9 = t8*2.0; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 */
    const double t10 = p[0]*p[5]; /* m*I3 */
    const double t11 = x[0]*p[1]; /* gamma3*R */
    const double t12 = p[3] + t11; /* b = a3 + gamma3*R */
    const double t13 = t10*t12; /* m*I3*b */
    const double t14 = p[1]*p[1]; /* R*R */
    const double t15 = p[0]*t14; /* m*R*R */
    const double t16 = p[4]*t15; /* I1*m*R*R */
    const double t17 = t4*t16; /* s*s*I1*m*R*R */
    const double t18 = p[7] + t17; /* I1*I3 + s*s*I1*m*R*R */
    const double t19 = t12*t12; /* b*b */
    const double t20 = t10*t19; /* m*I3*b*b */
    const double t21 = t18 + t20; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t22 = p[3]*x[0]; /* a3*gamma3 */
    const double t23 = p[1] + t22; /* e = R + a3*gamma3 */
    const double t24 = x[2]*t23; /* omega_tau*e */
    const double t25 = x[1] + t24; /* V = v_nu + omega_tau*e */
    const double t26 = t13*t25; /* m*I3*b*V */
    const double t27 = t26/t21; /* m*I3*b*V/Theta */
    const double t28 = t9 - t27; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 - m*I3*b*V/Theta */
    const double t29 = p[4]*p[1]; /* I1*R */
    const double t30 = p[5]*t29; /* I3*I1*R */
    const double t31 = x[2]*t30; /* omega_tau*I3*I1*R */
    const double t32 = t4*t31; /* s*s*omega_tau*I3*I1*R */
    const double t33 = t12*t21; /* b*Theta */
    const double t34 = t32/t33; /* s*s*omega_tau*I3*I1*R/(b*Theta) */
    const double t35 = t28 + t34; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 - m*I3*b*V/Theta + s*s*omega_tau*I3*I1*R/(b*Theta) */
    const double t36 = x[2]*t16; /* omega_tau*I1*m*R*R */
    const double t37 = t4*t36; /* s*s*omega_tau*I1*m*R*R */
    const double t38 = t23*t37; /* e*s*s*omega_tau*I1*m*R*R */
    const double t39 = t38/t33; /* e*s*s*omega_tau*I1*m*R*R/(b*Theta) */
    const double t40 = t35 + t39; /* t35 + e*s*s*omega_tau*I1*m*R*R/(b*Theta) */
    out[0] = t40;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[2]; /* m*g */
    const double t1 = t0*p[3]; /* m*g*a3 */
    const double t2 = t1*x[0]; /* m*g*a3*gamma3 */
    const double t3 = x[1]*x[1]; /* v_nu*v_nu */
    const double t4 = p[0]*t3; /* m*v_nu*v_nu */
    const double t5 = t4*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t6 = t2 + t5; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 */
    const double t7 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t8 = p[3]*p[3]; /* a3*a3 */
    const double t9 = p[0]*t8; /* m*a3*a3 */
    const double t10 = x[4]*x[4]; /* s*s */
    const double t11 = t9*t10; /* m*a3*a3*s*s */
    const double t12 = p[4] + t11; /* D = I1 + m*a3*a3*s*s */
    const double t13 = t7*t12; /* omega_tau*omega_tau*D */
    const double t14 = (1.0 / 2.0)*t13; /* 1/2*omega_tau*omega_tau*D */
    const double t15 = t6 + t14; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D */
    const double t16 = x[3]*x[3]; /* omega_n*omega_n */
    const double t17 = p[4]*t16; /* I1*omega_n*omega_n */
    const double t18 = (1.0 / 2.0)*t17; /* 1/2*I1*omega_n*omega_n */
    const double t19 = t15 + t18; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*I1*omega_n*omega_n */
    const double t20 = x[0]*p[1]; /* gamma3*R */
    const double t21 = p[3] + t20; /* b = a3 + gamma3*R */
    const double t22 = p[5]*t21; /* I3*b */
    const double t23 = p[4]*p[1]; /* I1*R */
    const double t24 = x[3]*t23; /* omega_n*I1*R */
    const double t25 = x[4]*t24; /* s*omega_n*I1*R */
    const double t26 = t25 - p[6]; /* s*omega_n*I1*R - G_level */
    const double t27 = t26/t22; /* omega3 = (s*omega_n*I1*R - G_level)/(I3*b) */
    const double t28 = t27*t27; /* omega3*omega3 */
    const double t29 = p[5]*t28; /* I3*omega3*omega3 */
    const double t30 = (1.0 / 2.0)*t29; /* 1/2*I3*omega3*omega3 */
    const double t31 = t19 + t30; /* t19 + 1/2*I3*omega3*omega3 */
    const double t32 = x[3]*t21; /* omega_n*b */
    const double t33 = p[1]*t27; /* R*omega3 */
    const double t34 = x[4]*t33; /* s*R*omega3 */
    const double t35 = t32 + t34; /* v_tau = omega_n*b + s*R*omega3 */
    const double t36 = t35*t35; /* v_tau*v_tau */
    const double t37 = p[0]*t36; /* m*v_tau*v_tau */
    const double t38 = (1.0 / 2.0)*t37; /* 1/2*m*v_tau*v_tau */
    const double t39 = t31 + t38; /* energy = t19 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    out[0] = t39;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*x[0]; /* R*gamma3 */
    const double t1 = p[3] + t0; /* b = a3 + R*gamma3 */
    const double t2 = x[3]*t1; /* omega_n*b */
    const double t3 = t1*p[5]; /* b*I3 */
    const double t4 = p[1]*p[4]; /* R*I1 */
    const double t5 = x[3]*t4; /* omega_n*R*I1 */
    const double t6 = t5*x[4]; /* omega_n*R*I1*s */
    const double t7 = p[6] - t6; /* G_level - omega_n*R*I1*s */
    const double t8 = t6 - p[6]; /* omega_n*R*I1*s - G_level */
    const double t9 = t8/t3; /* omega3 = (omega_n*R*I1*s - G_level)/(b*I3) */
    const double t10 = p[1]*t9; /* R*omega3 */
    const double t11 = x[4]*t10; /* s*R*omega3 */
    const double t12 = t2 + t11; /* v_tau = omega_n*b + s*R*omega3 */
    const double t13 = p[0]*t12; /* m*v_tau */
    const double t14 = x[3]*p[1]; /* omega_n*R */
    const double t15 = p[1]*p[1]; /* R*R */
    const double t16 = x[4]*t15; /* s*R*R */
    const double t17 = t1*t1; /* b*b */
    const double t18 = p[5]*t17; /* I3*b*b */
    const double t19 = t7*t16; /* (G_level - omega_n*R*I1*s)*s*R*R */
    const double t20 = t19/t18; /* (G_level - omega_n*R*I1*s)*s*R*R/(I3*b*b) */
    const double t21 = t14 + t20; /* d(v_tau)/d(gamma3) = omega_n*R + (G_level - omega_n*R*I1*s)*s*R*R/(I3*b*b) */
    const double t22 = t13*t21; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t23 = p[8] + t22; /* m*g*a3 + m*v_tau*d(v_tau)/d(gamma3) */
    const double t24 = t7*t10; /* (G_level - omega_n*R*I1*s)*R*omega3 */
    const double t25 = t24/t17; /* (G_level - omega_n*R*I1*s)*R*omega3/(b*b) */
    const double t26 = t23 + t25; /* d(energy)/d(gamma3) = m*g*a3 + m*v_tau*d(v_tau)/d(gamma3) + (G_level - omega_n*R*I1*s)*R*omega3/(b*b) */
    const double t27 = p[0]*x[1]; /* m*v_nu */
    const double t28 = p[3]*p[3]; /* a3*a3 */
    const double t29 = p[0]*t28; /* m*a3*a3 */
    const double t30 = x[4]*x[4]; /* s*s */
    const double t31 = t29*t30; /* m*a3*a3*s*s */
    const double t32 = p[4] + t31; /* D = I1 + m*a3*a3*s*s */
    const double t33 = x[2]*t32; /* omega_tau*D */
    const double t34 = x[3]*p[4]; /* omega_n*I1 */
    const double t35 = p[4]*t15; /* I1*R*R */
    const double t36 = t30*t35; /* s*s*I1*R*R */
    const double t37 = t36/t3; /* s*s*I1*R*R/(b*I3) */
    const double t38 = t1 + t37; /* d(v_tau)/d(omega_n) = b + s*s*I1*R*R/(b*I3) */
    const double t39 = t13*t38; /* m*v_tau*d(v_tau)/d(omega_n) */
    const double t40 = t34 + t39; /* omega_n*I1 + m*v_tau*d(v_tau)/d(omega_n) */
    const double t41 = t4*t9; /* R*I1*omega3 */
    const double t42 = x[4]*t41; /* s*R*I1*omega3 */
    const double t43 = t42/t1; /* s*R*I1*omega3/b */
    const double t44 = t40 + t43; /* d(energy)/d(omega_n) = omega_n*I1 + m*v_tau*d(v_tau)/d(omega_n) + s*R*I1*omega3/b */
    const double t45 = x[3]*t35; /* omega_n*I1*R*R */
    const double t46 = x[4]*t45; /* s*omega_n*I1*R*R */
    const double t47 = t46/t3; /* s*omega_n*I1*R*R/(b*I3) */
    const double t48 = t10 + t47; /* d(v_tau)/d(s) = R*omega3 + s*omega_n*I1*R*R/(b*I3) */
    const double t49 = t13*t48; /* m*v_tau*d(v_tau)/d(s) */
    const double t50 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t51 = t29*t50; /* m*a3*a3*omega_tau*omega_tau */
    const double t52 = x[4]*t51; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t53 = t49 + t52; /* m*v_tau*d(v_tau)/d(s) + s*m*a3*a3*omega_tau*omega_tau */
    const double t54 = t5*t9; /* omega_n*R*I1*omega3 */
    const double t55 = t54/t1; /* omega_n*R*I1*omega3/b */
    const double t56 = t53 + t55; /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) + s*m*a3*a3*omega_tau*omega_tau + omega_n*R*I1*omega3/b */
    out[0] = t26;
    out[1] = t27;
    out[2] = t33;
    out[3] = t44;
    out[4] = t56;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*x[0]; /* R*gamma3 */
    const double t1 = p[3] + t0; /* b = a3 + R*gamma3 */
    const double t2 = p[5]*t1; /* I3*b */
    const double t3 = p[1]*p[4]; /* R*I1 */
    const double t4 = t3*x[3]; /* R*I1*omega_n */
    const double t5 = t4*x[4]; /* R*I1*omega_n*s */
    const double t6 = t5 - p[6]; /* R*I1*omega_n*s - G_level */
    const double t7 = t6/t2; /* omega3 = (R*I1*omega_n*s - G_level)/(I3*b) */
    out[0] = t7;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double v_I3 = params[5];
    const double v_G_level = params[6];
    const double v_I1 = params[4];
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
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
    out[3] = (v_s)*((v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
};

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 9,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 15, 52, 0, 8, 0, 0, 10, 9 }, { 15, 62, 0, 8, 0, 0, 10, 8 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 25, { 48, 191, 0, 41, 0, 0, 16, 21 }, { 51, 305, 0, 41, 0, 0, 16, 10 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 56, 204, 0, 48, 0, 0, 16, 37 }, { 59, 347, 0, 48, 0, 0, 16, 11 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 9, 28, 0, 4, 0, 0, 10, 9 }, { 9, 40, 0, 4, 0, 0, 10, 7 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 1, { 9, 30, 0, 1, 0, 0, 12, 5 }, { 9, 30, 0, 1, 0, 0, 12, 5 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 5, { 14, 36, 0, 7, 0, 0, 12, 14 }, { 15, 60, 0, 7, 0, 0, 12, 10 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 2, 5, 0, 1, 0, 0, 5, 3 }, { 2, 5, 0, 1, 0, 0, 5, 3 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx512,
    },
};
