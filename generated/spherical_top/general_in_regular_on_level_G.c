/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 14   53    0    8    0    0     11    8   (89)
 *  jacobian            46  197    0   44    0    0     16   21   (423)
 *  rhs_jacobian        53  210    0   51    0    0     16   41   (484)
 *  divergence          10   30    0    4    0    0     11    8   (55)
 *  integral_values     9   30    0    1    0    0     11    5   (40)
 *  integral_gradients  13   33    0    7    0    0     11   14   (76)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          2    5    0    1    0    0      5    4   (8)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_avx512;

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
    const double t2 = params[0]*params[2]; /* m*g */
    const double t3 = t2*params[3]; /* m*g*a3 */
    out[7] = t0;
    out[8] = t1;
    out[9] = t3;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = x[4]*t2; /* s*R*I1 */
    const double t4 = p[5]*x[3]; /* I3*omega3 */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = p[3] + t5; /* b = a3 + R*gamma3 */
    const double t7 = t4*t6; /* I3*omega3*b */
    const double t8 = p[6] + t7; /* G_level + I3*omega3*b */
    const double t9 = t8/t3; /* omega_n = (G_level + I3*omega3*b)/(s*R*I1) */
    const double t10 = t9*t9; /* omega_n*omega_n */
    const double t11 = t6*t10; /* b*omega_n*omega_n */
    const double t12 = p[1]*t9; /* R*omega_n */
    const double t13 = x[3]*t12; /* omega3*R*omega_n */
    const double t14 = x[4]*t13; /* s*omega3*R*omega_n */
    const double t15 = t11 + t14; /* b*omega_n*omega_n + s*omega3*R*omega_n */
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
    const double t30 = p[4]*x[0]; /* I1*gamma3 */
    const double t31 = t10*t30; /* omega_n*omega_n*I1*gamma3 */
    const double t32 = t31/t23; /* omega_n*omega_n*I1*gamma3/D */
    const double t33 = t29 - t32; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - omega_n*omega_n*I1*gamma3/D */
    const double t34 = p[5]*t9; /* I3*omega_n */
    const double t35 = x[3]*t34; /* omega3*I3*omega_n */
    const double t36 = x[4]*t35; /* s*omega3*I3*omega_n */
    const double t37 = t36/t23; /* s*omega3*I3*omega_n/D */
    const double t38 = t33 - t37; /* t33 - s*omega3*I3*omega_n/D */
    const double t39 = p[1]*p[0]; /* R*m */
    const double t40 = p[4]*t39; /* I1*R*m */
    const double t41 = t9*t40; /* omega_n*I1*R*m */
    const double t42 = x[4]*t41; /* s*omega_n*I1*R*m */
    const double t43 = p[1]*p[1]; /* R*R */
    const double t44 = p[0]*t43; /* m*R*R */
    const double t45 = p[4]*t44; /* I1*m*R*R */
    const double t46 = t0*t45; /* s*s*I1*m*R*R */
    const double t47 = p[7] + t46; /* I1*I3 + s*s*I1*m*R*R */
    const double t48 = p[5]*p[0]; /* I3*m */
    const double t49 = t6*t6; /* b*b */
    const double t50 = t48*t49; /* I3*m*b*b */
    const double t51 = t47 + t50; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*b*b */
    const double t52 = p[3]*x[0]; /* a3*gamma3 */
    const double t53 = p[1] + t52; /* e = R + a3*gamma3 */
    const double t54 = x[2]*t53; /* omega_tau*e */
    const double t55 = x[1] + t54; /* V = v_nu + omega_tau*e */
    const double t56 = t42*t55; /* s*omega_n*I1*R*m*V */
    const double t57 = t56/t51; /* s*omega_n*I1*R*m*V/Theta */
    const double t58 = x[0]*t44; /* gamma3*m*R*R */
    const double t59 = x[2]*t58; /* omega_tau*gamma3*m*R*R */
    const double t60 = x[3]*t59; /* omega3*omega_tau*gamma3*m*R*R */
    const double t61 = t0*t60; /* s*s*omega3*omega_tau*gamma3*m*R*R */
    const double t62 = t61*p[8]; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t63 = t62/t51; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t64 = t63 - t57; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - s*omega_n*I1*R*m*V/Theta */
    const double t65 = p[3]*t39; /* a3*R*m */
    const double t66 = p[5]*t65; /* I3*a3*R*m */
    const double t67 = x[2]*t66; /* omega_tau*I3*a3*R*m */
    const double t68 = x[3]*t67; /* omega3*omega_tau*I3*a3*R*m */
    const double t69 = t0*t68; /* s*s*omega3*omega_tau*I3*a3*R*m */
    const double t70 = t69/t51; /* s*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t71 = t64 - t70; /* t64 - s*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t72 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t73 = x[4]*t72; /* s*omega_tau*gamma3 */
    const double t74 = -t73; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t15;
    out[2] = t38;
    out[3] = t71;
    out[4] = t74;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[4]*t1; /* s*2*omega_tau */
    const double t3 = p[1]*p[4]; /* R*I1 */
    const double t4 = x[4]*t3; /* s*R*I1 */
    const double t5 = p[5]*x[3]; /* I3*omega3 */
    const double t6 = p[1]*x[0]; /* R*gamma3 */
    const double t7 = p[3] + t6; /* b = a3 + R*gamma3 */
    const double t8 = t5*t7; /* I3*omega3*b */
    const double t9 = p[6] + t8; /* G_level + I3*omega3*b */
    const double t10 = t9/t4; /* omega_n = (G_level + I3*omega3*b)/(s*R*I1) */
    const double t11 = t10*t10; /* omega_n*omega_n */
    const double t12 = p[1]*t11; /* R*omega_n*omega_n */
    const double t13 = p[5]*t10; /* I3*omega_n */
    const double t14 = x[3]*t13; /* omega3*I3*omega_n */
    const double t15 = x[4]*p[4]; /* s*I1 */
    const double t16 = t7*t14; /* b*omega3*I3*omega_n */
    const double t17 = t16/t15; /* b*omega3*I3*omega_n/(s*I1) */
    const double t18 = 2.0*t17; /* 2*b*omega3*I3*omega_n/(s*I1) */
    const double t19 = t12 + t18; /* R*omega_n*omega_n + 2*b*omega3*I3*omega_n/(s*I1) */
    const double t20 = p[1]*p[5]; /* R*I3 */
    const double t21 = x[3]*x[3]; /* omega3*omega3 */
    const double t22 = t20*t21; /* R*I3*omega3*omega3 */
    const double t23 = t22/p[4]; /* R*I3*omega3*omega3/I1 */
    const double t24 = t19 + t23; /* R*omega_n*omega_n + 2*b*omega3*I3*omega_n/(s*I1) + R*I3*omega3*omega3/I1 */
    const double t25 = p[1]*t10; /* R*omega_n */
    const double t26 = x[4]*t25; /* s*R*omega_n */
    const double t27 = t7*t7; /* b*b */
    const double t28 = t13*t27; /* I3*omega_n*b*b */
    const double t29 = t28/t4; /* I3*omega_n*b*b/(s*R*I1) */
    const double t30 = 2.0*t29; /* 2*I3*omega_n*b*b/(s*R*I1) */
    const double t31 = t26 + t30; /* s*R*omega_n + 2*I3*omega_n*b*b/(s*R*I1) */
    const double t32 = t8/p[4]; /* I3*omega3*b/I1 */
    const double t33 = t31 + t32; /* s*R*omega_n + 2*I3*omega_n*b*b/(s*R*I1) + I3*omega3*b/I1 */
    const double t34 = x[3]*t25; /* omega3*R*omega_n */
    const double t35 = t0*t3; /* s*s*R*I1 */
    const double t36 = t7*t10; /* b*omega_n */
    const double t37 = t9*t36; /* (G_level + I3*omega3*b)*b*omega_n */
    const double t38 = t37/t35; /* (G_level + I3*omega3*b)*b*omega_n/(s*s*R*I1) */
    const double t39 = 2.0*t38; /* 2*(G_level + I3*omega3*b)*b*omega_n/(s*s*R*I1) */
    const double t40 = t34 - t39; /* omega3*R*omega_n - 2*(G_level + I3*omega3*b)*b*omega_n/(s*s*R*I1) */
    const double t41 = x[3]*t9; /* omega3*(G_level + I3*omega3*b) */
    const double t42 = t41/t15; /* omega3*(G_level + I3*omega3*b)/(s*I1) */
    const double t43 = t40 - t42; /* t40 - omega3*(G_level + I3*omega3*b)/(s*I1) */
    const double t44 = p[3]*p[3]; /* a3*a3 */
    const double t45 = p[0]*t44; /* m*a3*a3 */
    const double t46 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t47 = t45*t46; /* m*a3*a3*omega_tau*omega_tau */
    const double t48 = t0*t47; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t49 = t0*t45; /* s*s*m*a3*a3 */
    const double t50 = p[4] + t49; /* D = I1 + s*s*m*a3*a3 */
    const double t51 = t48/t50; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t52 = p[4]*t11; /* I1*omega_n*omega_n */
    const double t53 = t52/t50; /* I1*omega_n*omega_n/D */
    const double t54 = t51 - t53; /* s*s*m*a3*a3*omega_tau*omega_tau/D - I1*omega_n*omega_n/D */
    const double t55 = p[5]*x[0]; /* I3*gamma3 */
    const double t56 = t10*t55; /* omega_n*I3*gamma3 */
    const double t57 = x[3]*t56; /* omega3*omega_n*I3*gamma3 */
    const double t58 = x[4]*t50; /* s*D */
    const double t59 = t57/t58; /* omega3*omega_n*I3*gamma3/(s*D) */
    const double t60 = 2.0*t59; /* 2*omega3*omega_n*I3*gamma3/(s*D) */
    const double t61 = t54 - t60; /* s*s*m*a3*a3*omega_tau*omega_tau/D - I1*omega_n*omega_n/D - 2*omega3*omega_n*I3*gamma3/(s*D) */
    const double t62 = p[5]*p[5]; /* I3*I3 */
    const double t63 = t21*t62; /* omega3*omega3*I3*I3 */
    const double t64 = p[4]*t50; /* I1*D */
    const double t65 = t63/t64; /* omega3*omega3*I3*I3/(I1*D) */
    const double t66 = t61 - t65; /* t61 - omega3*omega3*I3*I3/(I1*D) */
    const double t67 = 2.0*p[0]; /* 2*m */
    const double t68 = t44*t67; /* a3*a3*2*m */
    const double t69 = x[0]*t68; /* gamma3*a3*a3*2*m */
    const double t70 = x[2]*t69; /* omega_tau*gamma3*a3*a3*2*m */
    const double t71 = t0*t70; /* s*s*omega_tau*gamma3*a3*a3*2*m */
    const double t72 = t71/t50; /* s*s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t73 = x[4]*t13; /* s*I3*omega_n */
    const double t74 = t73/t50; /* s*I3*omega_n/D */
    const double t75 = -t74; /* -s*I3*omega_n/D */
    const double t76 = x[4]*p[1]; /* s*R */
    const double t77 = t7*t56; /* b*omega_n*I3*gamma3 */
    const double t78 = t50*t76; /* D*s*R */
    const double t79 = t77/t78; /* b*omega_n*I3*gamma3/(D*s*R) */
    const double t80 = 2.0*t79; /* 2*b*omega_n*I3*gamma3/(D*s*R) */
    const double t81 = t75 - t80; /* -s*I3*omega_n/D - 2*b*omega_n*I3*gamma3/(D*s*R) */
    const double t82 = x[3]*t62; /* omega3*I3*I3 */
    const double t83 = t7*t82; /* b*omega3*I3*I3 */
    const double t84 = t3*t50; /* R*I1*D */
    const double t85 = t83/t84; /* b*omega3*I3*I3/(R*I1*D) */
    const double t86 = t81 - t85; /* -s*I3*omega_n/D - 2*b*omega_n*I3*gamma3/(D*s*R) - b*omega3*I3*I3/(R*I1*D) */
    const double t87 = x[0]*t45; /* gamma3*m*a3*a3 */
    const double t88 = t46*t87; /* omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t89 = x[4]*t88; /* s*omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t90 = t89/t50; /* s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t91 = 2.0*t90; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t92 = p[0]*p[2]; /* m*g */
    const double t93 = p[3]*t92; /* a3*m*g */
    const double t94 = x[4]*t93; /* s*a3*m*g */
    const double t95 = t94/t50; /* s*a3*m*g/D */
    const double t96 = 2.0*t95; /* 2*s*a3*m*g/D */
    const double t97 = t91 - t96; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D */
    const double t98 = t14/t50; /* omega3*I3*omega_n/D */
    const double t99 = t97 - t98; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D - omega3*I3*omega_n/D */
    const double t100 = p[0]*p[0]; /* m*m */
    const double t101 = t44*t44; /* a3*a3*a3*a3 */
    const double t102 = t100*t101; /* m*m*a3*a3*a3*a3 */
    const double t103 = x[0]*t102; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t104 = t46*t103; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t105 = x[4]*t0; /* s*s*s */
    const double t106 = t104*t105; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t107 = t50*t50; /* D*D */
    const double t108 = t106/t107; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t109 = 2.0*t108; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t110 = t99 - t109; /* t99 - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t111 = p[2]*t100; /* g*m*m */
    const double t112 = p[3]*t44; /* a3*a3*a3 */
    const double t113 = t111*t112; /* g*m*m*a3*a3*a3 */
    const double t114 = t105*t113; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t115 = t114/t107; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t116 = 2.0*t115; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t117 = t110 + t116; /* t110 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t118 = p[4]*t45; /* I1*m*a3*a3 */
    const double t119 = x[0]*t118; /* gamma3*I1*m*a3*a3 */
    const double t120 = t11*t119; /* omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t121 = x[4]*t120; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t122 = t121/t107; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t123 = 2.0*t122; /* 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t124 = t117 + t123; /* t110 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t125 = p[5]*t45; /* I3*m*a3*a3 */
    const double t126 = t10*t125; /* omega_n*I3*m*a3*a3 */
    const double t127 = x[3]*t126; /* omega3*omega_n*I3*m*a3*a3 */
    const double t128 = t0*t127; /* s*s*omega3*omega_n*I3*m*a3*a3 */
    const double t129 = t128/t107; /* s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t130 = 2.0*t129; /* 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t131 = t124 + t130; /* t124 + 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t132 = x[0]*t10; /* gamma3*omega_n */
    const double t133 = t0*p[1]; /* s*s*R */
    const double t134 = t50*t133; /* D*s*s*R */
    const double t135 = t9*t132; /* (G_level + I3*omega3*b)*gamma3*omega_n */
    const double t136 = t135/t134; /* (G_level + I3*omega3*b)*gamma3*omega_n/(D*s*s*R) */
    const double t137 = 2.0*t136; /* 2*(G_level + I3*omega3*b)*gamma3*omega_n/(D*s*s*R) */
    const double t138 = t131 + t137; /* t124 + 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) + 2*(G_level + I3*omega3*b)*gamma3*omega_n/(D*s*s*R) */
    const double t139 = t4*t50; /* s*R*I1*D */
    const double t140 = t5*t9; /* I3*omega3*(G_level + I3*omega3*b) */
    const double t141 = t140/t139; /* I3*omega3*(G_level + I3*omega3*b)/(s*R*I1*D) */
    const double t142 = t138 + t141; /* t138 + I3*omega3*(G_level + I3*omega3*b)/(s*R*I1*D) */
    const double t143 = p[1]*p[1]; /* R*R */
    const double t144 = t100*t143; /* m*m*R*R */
    const double t145 = p[4]*t144; /* I1*m*m*R*R */
    const double t146 = p[5]*t145; /* I3*I1*m*m*R*R */
    const double t147 = t10*t146; /* omega_n*I3*I1*m*m*R*R */
    const double t148 = x[4]*t147; /* s*omega_n*I3*I1*m*m*R*R */
    const double t149 = t7*t148; /* b*s*omega_n*I3*I1*m*m*R*R */
    const double t150 = p[0]*t143; /* m*R*R */
    const double t151 = p[4]*t150; /* I1*m*R*R */
    const double t152 = t0*t151; /* s*s*I1*m*R*R */
    const double t153 = p[7] + t152; /* I1*I3 + s*s*I1*m*R*R */
    const double t154 = p[5]*p[0]; /* I3*m */
    const double t155 = t27*t154; /* b*b*I3*m */
    const double t156 = t153 + t155; /* Theta = I1*I3 + s*s*I1*m*R*R + b*b*I3*m */
    const double t157 = t156*t156; /* Theta*Theta */
    const double t158 = p[3]*x[0]; /* a3*gamma3 */
    const double t159 = p[1] + t158; /* e = R + a3*gamma3 */
    const double t160 = x[2]*t159; /* omega_tau*e */
    const double t161 = x[1] + t160; /* V = v_nu + omega_tau*e */
    const double t162 = t149*t161; /* b*s*omega_n*I3*I1*m*m*R*R*V */
    const double t163 = t162/t157; /* b*s*omega_n*I3*I1*m*m*R*R*V/(Theta*Theta) */
    const double t164 = 2.0*t163; /* 2*b*s*omega_n*I3*I1*m*m*R*R*V/(Theta*Theta) */
    const double t165 = p[1]*p[0]; /* R*m */
    const double t166 = p[3]*t165; /* a3*R*m */
    const double t167 = p[4]*t166; /* I1*a3*R*m */
    const double t168 = x[2]*t167; /* omega_tau*I1*a3*R*m */
    const double t169 = t10*t168; /* omega_n*omega_tau*I1*a3*R*m */
    const double t170 = x[4]*t169; /* s*omega_n*omega_tau*I1*a3*R*m */
    const double t171 = t170/t156; /* s*omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t172 = t164 - t171; /* 2*b*s*omega_n*I3*I1*m*m*R*R*V/(Theta*Theta) - s*omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t173 = x[2]*t150; /* omega_tau*m*R*R */
    const double t174 = x[3]*t173; /* omega3*omega_tau*m*R*R */
    const double t175 = t0*t174; /* s*s*omega3*omega_tau*m*R*R */
    const double t176 = t175*p[8]; /* s*s*omega3*omega_tau*m*R*R*(I1 - I3) */
    const double t177 = t176/t156; /* s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t178 = t172 + t177; /* t172 + s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t179 = p[1]*t143; /* R*R*R */
    const double t180 = t100*t179; /* m*m*R*R*R */
    const double t181 = p[5]*t180; /* I3*m*m*R*R*R */
    const double t182 = x[0]*t181; /* gamma3*I3*m*m*R*R*R */
    const double t183 = x[2]*t182; /* omega_tau*gamma3*I3*m*m*R*R*R */
    const double t184 = x[3]*t183; /* omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t185 = t0*t184; /* s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t186 = t7*t185; /* b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t187 = p[8]*t186; /* (I1 - I3)*b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t188 = t187/t157; /* (I1 - I3)*b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t189 = 2.0*t188; /* 2*t188 */
    const double t190 = t178 - t189; /* t172 + s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta - 2*t188 */
    const double t191 = p[3]*t144; /* a3*m*m*R*R */
    const double t192 = t62*t191; /* I3*I3*a3*m*m*R*R */
    const double t193 = x[2]*t192; /* omega_tau*I3*I3*a3*m*m*R*R */
    const double t194 = x[3]*t193; /* omega3*omega_tau*I3*I3*a3*m*m*R*R */
    const double t195 = t0*t194; /* s*s*omega3*omega_tau*I3*I3*a3*m*m*R*R */
    const double t196 = t7*t195; /* b*s*s*omega3*omega_tau*I3*I3*a3*m*m*R*R */
    const double t197 = t196/t157; /* b*s*s*omega3*omega_tau*I3*I3*a3*m*m*R*R/(Theta*Theta) */
    const double t198 = 2.0*t197; /* 2*b*s*s*omega3*omega_tau*I3*I3*a3*m*m*R*R/(Theta*Theta) */
    const double t199 = t190 + t198; /* t172 + s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta - 2*t188 + 2*b*s*s*omega3*omega_tau*I3*I3*a3*m*m*R*R/(Theta*Theta) */
    const double t200 = p[5]*t165; /* I3*R*m */
    const double t201 = x[3]*t200; /* omega3*I3*R*m */
    const double t202 = t161*t201; /* V*omega3*I3*R*m */
    const double t203 = t202/t156; /* V*omega3*I3*R*m/Theta */
    const double t204 = t199 - t203; /* t199 - V*omega3*I3*R*m/Theta */
    const double t205 = p[4]*t165; /* I1*R*m */
    const double t206 = t10*t205; /* omega_n*I1*R*m */
    const double t207 = x[4]*t206; /* s*omega_n*I1*R*m */
    const double t208 = t207/t156; /* s*omega_n*I1*R*m/Theta */
    const double t209 = -t208; /* -s*omega_n*I1*R*m/Theta */
    const double t210 = t159*t207; /* e*s*omega_n*I1*R*m */
    const double t211 = t210/t156; /* e*s*omega_n*I1*R*m/Theta */
    const double t212 = x[0]*t150; /* gamma3*m*R*R */
    const double t213 = x[3]*t212; /* omega3*gamma3*m*R*R */
    const double t214 = t0*t213; /* s*s*omega3*gamma3*m*R*R */
    const double t215 = p[8]*t214; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R */
    const double t216 = t215/t156; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta */
    const double t217 = t216 - t211; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta - e*s*omega_n*I1*R*m/Theta */
    const double t218 = p[5]*t166; /* I3*a3*R*m */
    const double t219 = x[3]*t218; /* omega3*I3*a3*R*m */
    const double t220 = t0*t219; /* s*s*omega3*I3*a3*R*m */
    const double t221 = t220/t156; /* s*s*omega3*I3*a3*R*m/Theta */
    const double t222 = t217 - t221; /* t217 - s*s*omega3*I3*a3*R*m/Theta */
    const double t223 = t7*t154; /* b*I3*m */
    const double t224 = t161*t223; /* V*b*I3*m */
    const double t225 = t224/t156; /* V*b*I3*m/Theta */
    const double t226 = x[2]*t212; /* omega_tau*gamma3*m*R*R */
    const double t227 = t0*t226; /* s*s*omega_tau*gamma3*m*R*R */
    const double t228 = p[8]*t227; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R */
    const double t229 = t228/t156; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta */
    const double t230 = t229 - t225; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta - V*b*I3*m/Theta */
    const double t231 = x[2]*t218; /* omega_tau*I3*a3*R*m */
    const double t232 = t0*t231; /* s*s*omega_tau*I3*a3*R*m */
    const double t233 = t232/t156; /* s*s*omega_tau*I3*a3*R*m/Theta */
    const double t234 = t230 - t233; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta - V*b*I3*m/Theta - s*s*omega_tau*I3*a3*R*m/Theta */
    const double t235 = t161*t206; /* V*omega_n*I1*R*m */
    const double t236 = t235/t156; /* V*omega_n*I1*R*m/Theta */
    const double t237 = x[3]*t226; /* omega3*omega_tau*gamma3*m*R*R */
    const double t238 = x[4]*t237; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t239 = p[8]*t238; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t240 = t239/t156; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t241 = 2.0*t240; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t242 = t241 - t236; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta - V*omega_n*I1*R*m/Theta */
    const double t243 = x[3]*t231; /* omega3*omega_tau*I3*a3*R*m */
    const double t244 = x[4]*t243; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t245 = t244/t156; /* s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t246 = 2.0*t245; /* 2*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t247 = t242 - t246; /* t242 - 2*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t248 = p[4]*p[4]; /* I1*I1 */
    const double t249 = t180*t248; /* m*m*R*R*R*I1*I1 */
    const double t250 = t10*t249; /* omega_n*m*m*R*R*R*I1*I1 */
    const double t251 = t0*t250; /* s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t252 = t161*t251; /* V*s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t253 = t252/t157; /* V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t254 = 2.0*t253; /* 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t255 = t247 + t254; /* t242 - 2*s*omega3*omega_tau*I3*a3*R*m/Theta + 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t256 = t143*t143; /* R*R*R*R */
    const double t257 = t100*t256; /* m*m*R*R*R*R */
    const double t258 = p[4]*t257; /* I1*m*m*R*R*R*R */
    const double t259 = x[0]*t258; /* gamma3*I1*m*m*R*R*R*R */
    const double t260 = x[2]*t259; /* omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t261 = x[3]*t260; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t262 = t105*t261; /* s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t263 = p[8]*t262; /* (I1 - I3)*s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t264 = t263/t157; /* (I1 - I3)*s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t265 = 2.0*t264; /* 2*t264 */
    const double t266 = t255 - t265; /* t255 - 2*t264 */
    const double t267 = p[3]*t180; /* a3*m*m*R*R*R */
    const double t268 = p[4]*t267; /* I1*a3*m*m*R*R*R */
    const double t269 = p[5]*t268; /* I3*I1*a3*m*m*R*R*R */
    const double t270 = x[2]*t269; /* omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t271 = x[3]*t270; /* omega3*omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t272 = t105*t271; /* s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t273 = t272/t157; /* s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t274 = 2.0*t273; /* 2*s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t275 = t266 + t274; /* t255 - 2*t264 + 2*s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t276 = x[4]*t156; /* s*Theta */
    const double t277 = p[0]*t161; /* m*V */
    const double t278 = t9*t277; /* (G_level + I3*omega3*b)*m*V */
    const double t279 = t278/t276; /* (G_level + I3*omega3*b)*m*V/(s*Theta) */
    const double t280 = t275 + t279; /* t275 + (G_level + I3*omega3*b)*m*V/(s*Theta) */
    const double t281 = x[4]*x[2]; /* s*omega_tau */
    const double t282 = -t281; /* -s*omega_tau */
    const double t283 = x[4]*x[0]; /* s*gamma3 */
    const double t284 = -t283; /* -s*gamma3 */
    const double t285 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t286 = -t285; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t24;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t33;
    out[9] = t43;
    out[10] = t66;
    out[11] = 0.0;
    out[12] = t72;
    out[13] = t86;
    out[14] = t142;
    out[15] = t204;
    out[16] = t209;
    out[17] = t222;
    out[18] = t234;
    out[19] = t280;
    out[20] = t282;
    out[21] = 0.0;
    out[22] = t284;
    out[23] = 0.0;
    out[24] = t286;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = x[4]*t2; /* s*R*I1 */
    const double t4 = p[5]*x[3]; /* I3*omega3 */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = p[3] + t5; /* b = a3 + R*gamma3 */
    const double t7 = t4*t6; /* I3*omega3*b */
    const double t8 = p[6] + t7; /* G_level + I3*omega3*b */
    const double t9 = t8/t3; /* omega_n = (G_level + I3*omega3*b)/(s*R*I1) */
    const double t10 = t9*t9; /* omega_n*omega_n */
    const double t11 = t6*t10; /* b*omega_n*omega_n */
    const double t12 = p[1]*t9; /* R*omega_n */
    const double t13 = x[3]*t12; /* omega3*R*omega_n */
    const double t14 = x[4]*t13; /* s*omega3*R*omega_n */
    const double t15 = t11 + t14; /* b*omega_n*omega_n + s*omega3*R*omega_n */
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
    const double t30 = p[4]*x[0]; /* I1*gamma3 */
    const double t31 = t10*t30; /* omega_n*omega_n*I1*gamma3 */
    const double t32 = t31/t23; /* omega_n*omega_n*I1*gamma3/D */
    const double t33 = t29 - t32; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - omega_n*omega_n*I1*gamma3/D */
    const double t34 = p[5]*t9; /* I3*omega_n */
    const double t35 = x[3]*t34; /* omega3*I3*omega_n */
    const double t36 = x[4]*t35; /* s*omega3*I3*omega_n */
    const double t37 = t36/t23; /* s*omega3*I3*omega_n/D */
    const double t38 = t33 - t37; /* t33 - s*omega3*I3*omega_n/D */
    const double t39 = p[1]*p[0]; /* R*m */
    const double t40 = p[4]*t39; /* I1*R*m */
    const double t41 = t9*t40; /* omega_n*I1*R*m */
    const double t42 = x[4]*t41; /* s*omega_n*I1*R*m */
    const double t43 = p[1]*p[1]; /* R*R */
    const double t44 = p[0]*t43; /* m*R*R */
    const double t45 = p[4]*t44; /* I1*m*R*R */
    const double t46 = t0*t45; /* s*s*I1*m*R*R */
    const double t47 = p[7] + t46; /* I1*I3 + s*s*I1*m*R*R */
    const double t48 = p[5]*p[0]; /* I3*m */
    const double t49 = t6*t6; /* b*b */
    const double t50 = t48*t49; /* I3*m*b*b */
    const double t51 = t47 + t50; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*b*b */
    const double t52 = p[3]*x[0]; /* a3*gamma3 */
    const double t53 = p[1] + t52; /* e = R + a3*gamma3 */
    const double t54 = x[2]*t53; /* omega_tau*e */
    const double t55 = x[1] + t54; /* V = v_nu + omega_tau*e */
    const double t56 = t42*t55; /* s*omega_n*I1*R*m*V */
    const double t57 = t56/t51; /* s*omega_n*I1*R*m*V/Theta */
    const double t58 = x[0]*t44; /* gamma3*m*R*R */
    const double t59 = x[2]*t58; /* omega_tau*gamma3*m*R*R */
    const double t60 = x[3]*t59; /* omega3*omega_tau*gamma3*m*R*R */
    const double t61 = t0*t60; /* s*s*omega3*omega_tau*gamma3*m*R*R */
    const double t62 = t61*p[8]; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t63 = t62/t51; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t64 = t63 - t57; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - s*omega_n*I1*R*m*V/Theta */
    const double t65 = p[3]*t39; /* a3*R*m */
    const double t66 = p[5]*t65; /* I3*a3*R*m */
    const double t67 = x[2]*t66; /* omega_tau*I3*a3*R*m */
    const double t68 = x[3]*t67; /* omega3*omega_tau*I3*a3*R*m */
    const double t69 = t0*t68; /* s*s*omega3*omega_tau*I3*a3*R*m */
    const double t70 = t69/t51; /* s*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t71 = t64 - t70; /* t64 - s*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t72 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t73 = -t72; /* -omega_tau*gamma3 */
    const double t74 = x[4]*t72; /* s*omega_tau*gamma3 */
    const double t75 = -t74; /* -s*omega_tau*gamma3 */
    const double t76 = x[2]*2.0; /* omega_tau*2 */
    const double t77 = x[4]*t76; /* s*omega_tau*2 */
    const double t78 = p[1]*t10; /* R*omega_n*omega_n */
    const double t79 = x[4]*p[4]; /* s*I1 */
    const double t80 = t6*t35; /* b*omega3*I3*omega_n */
    const double t81 = t80/t79; /* b*omega3*I3*omega_n/(s*I1) */
    const double t82 = 2.0*t81; /* 2*b*omega3*I3*omega_n/(s*I1) */
    const double t83 = t78 + t82; /* R*omega_n*omega_n + 2*b*omega3*I3*omega_n/(s*I1) */
    const double t84 = p[1]*p[5]; /* R*I3 */
    const double t85 = x[3]*x[3]; /* omega3*omega3 */
    const double t86 = t84*t85; /* R*I3*omega3*omega3 */
    const double t87 = t86/p[4]; /* R*I3*omega3*omega3/I1 */
    const double t88 = t83 + t87; /* R*omega_n*omega_n + 2*b*omega3*I3*omega_n/(s*I1) + R*I3*omega3*omega3/I1 */
    const double t89 = x[4]*t12; /* s*R*omega_n */
    const double t90 = t34*t49; /* I3*omega_n*b*b */
    const double t91 = t90/t3; /* I3*omega_n*b*b/(s*R*I1) */
    const double t92 = 2.0*t91; /* 2*I3*omega_n*b*b/(s*R*I1) */
    const double t93 = t89 + t92; /* s*R*omega_n + 2*I3*omega_n*b*b/(s*R*I1) */
    const double t94 = t7/p[4]; /* I3*omega3*b/I1 */
    const double t95 = t93 + t94; /* s*R*omega_n + 2*I3*omega_n*b*b/(s*R*I1) + I3*omega3*b/I1 */
    const double t96 = t0*t2; /* s*s*R*I1 */
    const double t97 = t6*t9; /* b*omega_n */
    const double t98 = t8*t97; /* (G_level + I3*omega3*b)*b*omega_n */
    const double t99 = t98/t96; /* (G_level + I3*omega3*b)*b*omega_n/(s*s*R*I1) */
    const double t100 = 2.0*t99; /* 2*(G_level + I3*omega3*b)*b*omega_n/(s*s*R*I1) */
    const double t101 = t13 - t100; /* omega3*R*omega_n - 2*(G_level + I3*omega3*b)*b*omega_n/(s*s*R*I1) */
    const double t102 = x[3]*t8; /* omega3*(G_level + I3*omega3*b) */
    const double t103 = t102/t79; /* omega3*(G_level + I3*omega3*b)/(s*I1) */
    const double t104 = t101 - t103; /* t101 - omega3*(G_level + I3*omega3*b)/(s*I1) */
    const double t105 = t17*t19; /* m*a3*a3*omega_tau*omega_tau */
    const double t106 = t0*t105; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t107 = t106/t23; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t108 = p[4]*t10; /* I1*omega_n*omega_n */
    const double t109 = t108/t23; /* I1*omega_n*omega_n/D */
    const double t110 = t107 - t109; /* s*s*m*a3*a3*omega_tau*omega_tau/D - I1*omega_n*omega_n/D */
    const double t111 = p[5]*x[0]; /* I3*gamma3 */
    const double t112 = t9*t111; /* omega_n*I3*gamma3 */
    const double t113 = x[3]*t112; /* omega3*omega_n*I3*gamma3 */
    const double t114 = x[4]*t23; /* s*D */
    const double t115 = t113/t114; /* omega3*omega_n*I3*gamma3/(s*D) */
    const double t116 = 2.0*t115; /* 2*omega3*omega_n*I3*gamma3/(s*D) */
    const double t117 = t110 - t116; /* s*s*m*a3*a3*omega_tau*omega_tau/D - I1*omega_n*omega_n/D - 2*omega3*omega_n*I3*gamma3/(s*D) */
    const double t118 = p[5]*p[5]; /* I3*I3 */
    const double t119 = t85*t118; /* omega3*omega3*I3*I3 */
    const double t120 = p[4]*t23; /* I1*D */
    const double t121 = t119/t120; /* omega3*omega3*I3*I3/(I1*D) */
    const double t122 = t117 - t121; /* t117 - omega3*omega3*I3*I3/(I1*D) */
    const double t123 = p[0]*2.0; /* m*2 */
    const double t124 = t16*t123; /* a3*a3*m*2 */
    const double t125 = x[0]*t124; /* gamma3*a3*a3*m*2 */
    const double t126 = x[2]*t125; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t127 = t0*t126; /* s*s*omega_tau*gamma3*a3*a3*m*2 */
    const double t128 = t127/t23; /* s*s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t129 = x[4]*t34; /* s*I3*omega_n */
    const double t130 = t129/t23; /* s*I3*omega_n/D */
    const double t131 = -t130; /* -s*I3*omega_n/D */
    const double t132 = x[4]*p[1]; /* s*R */
    const double t133 = t6*t112; /* b*omega_n*I3*gamma3 */
    const double t134 = t23*t132; /* D*s*R */
    const double t135 = t133/t134; /* b*omega_n*I3*gamma3/(D*s*R) */
    const double t136 = 2.0*t135; /* 2*b*omega_n*I3*gamma3/(D*s*R) */
    const double t137 = t131 - t136; /* -s*I3*omega_n/D - 2*b*omega_n*I3*gamma3/(D*s*R) */
    const double t138 = x[3]*t118; /* omega3*I3*I3 */
    const double t139 = t6*t138; /* b*omega3*I3*I3 */
    const double t140 = t2*t23; /* R*I1*D */
    const double t141 = t139/t140; /* b*omega3*I3*I3/(R*I1*D) */
    const double t142 = t137 - t141; /* -s*I3*omega_n/D - 2*b*omega_n*I3*gamma3/(D*s*R) - b*omega3*I3*I3/(R*I1*D) */
    const double t143 = x[4]*t20; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t144 = t143/t23; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t145 = 2.0*t144; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t146 = x[4]*t26; /* s*a3*m*g */
    const double t147 = t146/t23; /* s*a3*m*g/D */
    const double t148 = 2.0*t147; /* 2*s*a3*m*g/D */
    const double t149 = t145 - t148; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D */
    const double t150 = t35/t23; /* omega3*I3*omega_n/D */
    const double t151 = t149 - t150; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D - omega3*I3*omega_n/D */
    const double t152 = p[0]*p[0]; /* m*m */
    const double t153 = t16*t16; /* a3*a3*a3*a3 */
    const double t154 = t152*t153; /* m*m*a3*a3*a3*a3 */
    const double t155 = x[0]*t154; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t156 = t19*t155; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t157 = x[4]*t0; /* s*s*s */
    const double t158 = t156*t157; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t159 = t23*t23; /* D*D */
    const double t160 = t158/t159; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t161 = 2.0*t160; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t162 = t151 - t161; /* t151 - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t163 = p[2]*t152; /* g*m*m */
    const double t164 = p[3]*t16; /* a3*a3*a3 */
    const double t165 = t163*t164; /* g*m*m*a3*a3*a3 */
    const double t166 = t157*t165; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t167 = t166/t159; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t168 = 2.0*t167; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t169 = t162 + t168; /* t162 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t170 = p[4]*t17; /* I1*m*a3*a3 */
    const double t171 = x[0]*t170; /* gamma3*I1*m*a3*a3 */
    const double t172 = t10*t171; /* omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t173 = x[4]*t172; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t174 = t173/t159; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t175 = 2.0*t174; /* 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t176 = t169 + t175; /* t162 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t177 = p[5]*t17; /* I3*m*a3*a3 */
    const double t178 = t9*t177; /* omega_n*I3*m*a3*a3 */
    const double t179 = x[3]*t178; /* omega3*omega_n*I3*m*a3*a3 */
    const double t180 = t0*t179; /* s*s*omega3*omega_n*I3*m*a3*a3 */
    const double t181 = t180/t159; /* s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t182 = 2.0*t181; /* 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t183 = t176 + t182; /* t176 + 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) */
    const double t184 = x[0]*t9; /* gamma3*omega_n */
    const double t185 = t0*p[1]; /* s*s*R */
    const double t186 = t23*t185; /* D*s*s*R */
    const double t187 = t8*t184; /* (G_level + I3*omega3*b)*gamma3*omega_n */
    const double t188 = t187/t186; /* (G_level + I3*omega3*b)*gamma3*omega_n/(D*s*s*R) */
    const double t189 = 2.0*t188; /* 2*(G_level + I3*omega3*b)*gamma3*omega_n/(D*s*s*R) */
    const double t190 = t183 + t189; /* t176 + 2*s*s*omega3*omega_n*I3*m*a3*a3/(D*D) + 2*(G_level + I3*omega3*b)*gamma3*omega_n/(D*s*s*R) */
    const double t191 = t3*t23; /* s*R*I1*D */
    const double t192 = t4*t8; /* I3*omega3*(G_level + I3*omega3*b) */
    const double t193 = t192/t191; /* I3*omega3*(G_level + I3*omega3*b)/(s*R*I1*D) */
    const double t194 = t190 + t193; /* t190 + I3*omega3*(G_level + I3*omega3*b)/(s*R*I1*D) */
    const double t195 = t43*t152; /* R*R*m*m */
    const double t196 = p[4]*t195; /* I1*R*R*m*m */
    const double t197 = p[5]*t196; /* I3*I1*R*R*m*m */
    const double t198 = t9*t197; /* omega_n*I3*I1*R*R*m*m */
    const double t199 = x[4]*t198; /* s*omega_n*I3*I1*R*R*m*m */
    const double t200 = t6*t199; /* b*s*omega_n*I3*I1*R*R*m*m */
    const double t201 = t51*t51; /* Theta*Theta */
    const double t202 = t55*t200; /* V*b*s*omega_n*I3*I1*R*R*m*m */
    const double t203 = t202/t201; /* V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t204 = 2.0*t203; /* 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t205 = p[4]*t65; /* I1*a3*R*m */
    const double t206 = x[2]*t205; /* omega_tau*I1*a3*R*m */
    const double t207 = t9*t206; /* omega_n*omega_tau*I1*a3*R*m */
    const double t208 = x[4]*t207; /* s*omega_n*omega_tau*I1*a3*R*m */
    const double t209 = t208/t51; /* s*omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t210 = t204 - t209; /* 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) - s*omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t211 = x[2]*t44; /* omega_tau*m*R*R */
    const double t212 = x[3]*t211; /* omega3*omega_tau*m*R*R */
    const double t213 = t0*t212; /* s*s*omega3*omega_tau*m*R*R */
    const double t214 = p[8]*t213; /* (I1 - I3)*s*s*omega3*omega_tau*m*R*R */
    const double t215 = t214/t51; /* (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta */
    const double t216 = t210 + t215; /* t210 + (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta */
    const double t217 = p[1]*t43; /* R*R*R */
    const double t218 = t152*t217; /* m*m*R*R*R */
    const double t219 = p[5]*t218; /* I3*m*m*R*R*R */
    const double t220 = x[0]*t219; /* gamma3*I3*m*m*R*R*R */
    const double t221 = x[2]*t220; /* omega_tau*gamma3*I3*m*m*R*R*R */
    const double t222 = x[3]*t221; /* omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t223 = t0*t222; /* s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t224 = t6*t223; /* b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t225 = p[8]*t224; /* (I1 - I3)*b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t226 = t225/t201; /* (I1 - I3)*b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t227 = 2.0*t226; /* 2*t226 */
    const double t228 = t216 - t227; /* t210 + (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta - 2*t226 */
    const double t229 = p[3]*t195; /* a3*R*R*m*m */
    const double t230 = t118*t229; /* I3*I3*a3*R*R*m*m */
    const double t231 = x[2]*t230; /* omega_tau*I3*I3*a3*R*R*m*m */
    const double t232 = x[3]*t231; /* omega3*omega_tau*I3*I3*a3*R*R*m*m */
    const double t233 = t0*t232; /* s*s*omega3*omega_tau*I3*I3*a3*R*R*m*m */
    const double t234 = t6*t233; /* b*s*s*omega3*omega_tau*I3*I3*a3*R*R*m*m */
    const double t235 = t234/t201; /* b*s*s*omega3*omega_tau*I3*I3*a3*R*R*m*m/(Theta*Theta) */
    const double t236 = 2.0*t235; /* 2*b*s*s*omega3*omega_tau*I3*I3*a3*R*R*m*m/(Theta*Theta) */
    const double t237 = t228 + t236; /* t210 + (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta - 2*t226 + 2*b*s*s*omega3*omega_tau*I3*I3*a3*R*R*m*m/(Theta*Theta) */
    const double t238 = p[5]*t39; /* I3*R*m */
    const double t239 = x[3]*t238; /* omega3*I3*R*m */
    const double t240 = t55*t239; /* V*omega3*I3*R*m */
    const double t241 = t240/t51; /* V*omega3*I3*R*m/Theta */
    const double t242 = t237 - t241; /* t237 - V*omega3*I3*R*m/Theta */
    const double t243 = t42/t51; /* s*omega_n*I1*R*m/Theta */
    const double t244 = -t243; /* -s*omega_n*I1*R*m/Theta */
    const double t245 = t42*t53; /* s*omega_n*I1*R*m*e */
    const double t246 = t245/t51; /* s*omega_n*I1*R*m*e/Theta */
    const double t247 = x[3]*t58; /* omega3*gamma3*m*R*R */
    const double t248 = t0*t247; /* s*s*omega3*gamma3*m*R*R */
    const double t249 = p[8]*t248; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R */
    const double t250 = t249/t51; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta */
    const double t251 = t250 - t246; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta - s*omega_n*I1*R*m*e/Theta */
    const double t252 = x[3]*t66; /* omega3*I3*a3*R*m */
    const double t253 = t0*t252; /* s*s*omega3*I3*a3*R*m */
    const double t254 = t253/t51; /* s*s*omega3*I3*a3*R*m/Theta */
    const double t255 = t251 - t254; /* t251 - s*s*omega3*I3*a3*R*m/Theta */
    const double t256 = t6*t48; /* b*I3*m */
    const double t257 = t55*t256; /* V*b*I3*m */
    const double t258 = t257/t51; /* V*b*I3*m/Theta */
    const double t259 = t0*t59; /* s*s*omega_tau*gamma3*m*R*R */
    const double t260 = p[8]*t259; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R */
    const double t261 = t260/t51; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta */
    const double t262 = t261 - t258; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta - V*b*I3*m/Theta */
    const double t263 = t0*t67; /* s*s*omega_tau*I3*a3*R*m */
    const double t264 = t263/t51; /* s*s*omega_tau*I3*a3*R*m/Theta */
    const double t265 = t262 - t264; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta - V*b*I3*m/Theta - s*s*omega_tau*I3*a3*R*m/Theta */
    const double t266 = t41*t55; /* omega_n*I1*R*m*V */
    const double t267 = t266/t51; /* omega_n*I1*R*m*V/Theta */
    const double t268 = x[4]*t60; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t269 = p[8]*t268; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t270 = t269/t51; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t271 = 2.0*t270; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t272 = t271 - t267; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta - omega_n*I1*R*m*V/Theta */
    const double t273 = x[4]*t68; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t274 = t273/t51; /* s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t275 = 2.0*t274; /* 2*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t276 = t272 - t275; /* t272 - 2*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t277 = p[4]*p[4]; /* I1*I1 */
    const double t278 = t218*t277; /* m*m*R*R*R*I1*I1 */
    const double t279 = t9*t278; /* omega_n*m*m*R*R*R*I1*I1 */
    const double t280 = t0*t279; /* s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t281 = t55*t280; /* V*s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t282 = t281/t201; /* V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t283 = 2.0*t282; /* 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t284 = t276 + t283; /* t272 - 2*s*omega3*omega_tau*I3*a3*R*m/Theta + 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t285 = t43*t43; /* R*R*R*R */
    const double t286 = t152*t285; /* m*m*R*R*R*R */
    const double t287 = p[4]*t286; /* I1*m*m*R*R*R*R */
    const double t288 = x[0]*t287; /* gamma3*I1*m*m*R*R*R*R */
    const double t289 = x[2]*t288; /* omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t290 = x[3]*t289; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t291 = t157*t290; /* s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t292 = p[8]*t291; /* (I1 - I3)*s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t293 = t292/t201; /* (I1 - I3)*s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t294 = 2.0*t293; /* 2*t293 */
    const double t295 = t284 - t294; /* t284 - 2*t293 */
    const double t296 = p[3]*t218; /* a3*m*m*R*R*R */
    const double t297 = p[4]*t296; /* I1*a3*m*m*R*R*R */
    const double t298 = p[5]*t297; /* I3*I1*a3*m*m*R*R*R */
    const double t299 = x[2]*t298; /* omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t300 = x[3]*t299; /* omega3*omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t301 = t157*t300; /* s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t302 = t301/t201; /* s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t303 = 2.0*t302; /* 2*s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t304 = t295 + t303; /* t284 - 2*t293 + 2*s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t305 = x[4]*t51; /* s*Theta */
    const double t306 = p[0]*t55; /* m*V */
    const double t307 = t8*t306; /* (G_level + I3*omega3*b)*m*V */
    const double t308 = t307/t305; /* (G_level + I3*omega3*b)*m*V/(s*Theta) */
    const double t309 = t304 + t308; /* t304 + (G_level + I3*omega3*b)*m*V/(s*Theta) */
    const double t310 = x[2]*x[4]; /* omega_tau*s */
    const double t311 = -t310; /* -omega_tau*s */
    const double t312 = x[4]*x[0]; /* s*gamma3 */
    const double t313 = -t312; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t15;
    out[2] = t38;
    out[3] = t71;
    out[4] = t75;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t77;
    out[10] = t88;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t95;
    out[14] = t104;
    out[15] = t122;
    out[16] = 0.0;
    out[17] = t128;
    out[18] = t142;
    out[19] = t194;
    out[20] = t242;
    out[21] = t244;
    out[22] = t255;
    out[23] = t265;
    out[24] = t309;
    out[25] = t311;
    out[26] = 0.0;
    out[27] = t313;
    out[28] = 0.0;
    out[29] = t73;
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
    const double t10 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t11 = t9 - t10; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 - gamma3*omega_tau */
    const double t12 = p[0]*p[5]; /* m*I3 */
    const double t13 = x[0]*p[1]; /* gamma3*R */
    const double t14 = p[3] + t13; /* b = a3 + gamma3*R */
    const double t15 = t12*t14; /* m*I3*b */
    const double t16 = p[1]*p[1]; /* R*R */
    const double t17 = p[0]*t16; /* m*R*R */
    const double t18 = p[4]*t17; /* I1*m*R*R */
    const double t19 = t4*t18; /* s*s*I1*m*R*R */
    const double t20 = p[7] + t19; /* I1*I3 + s*s*I1*m*R*R */
    const double t21 = t14*t14; /* b*b */
    const double t22 = t12*t21; /* m*I3*b*b */
    const double t23 = t20 + t22; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t24 = p[3]*x[0]; /* a3*gamma3 */
    const double t25 = p[1] + t24; /* e = R + a3*gamma3 */
    const double t26 = x[2]*t25; /* omega_tau*e */
    const double t27 = x[1] + t26; /* V = v_nu + omega_tau*e */
    const double t28 = t15*t27; /* m*I3*b*V */
    const double t29 = t28/t23; /* m*I3*b*V/Theta */
    const double t30 = t11 - t29; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 - gamma3*omega_tau - m*I3*b*V/Theta */
    const double t31 = x[0]*t17; /* gamma3*m*R*R */
    const double t32 = x[2]*t31; /* omega_tau*gamma3*m*R*R */
    const double t33 = t4*t32; /* s*s*omega_tau*gamma3*m*R*R */
    const double t34 = t33*p[8]; /* s*s*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t35 = t34/t23; /* s*s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t36 = t30 + t35; /* t30 + s*s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t37 = p[0]*p[1]; /* m*R */
    const double t38 = p[3]*t37; /* a3*m*R */
    const double t39 = p[5]*t38; /* I3*a3*m*R */
    const double t40 = x[2]*t39; /* omega_tau*I3*a3*m*R */
    const double t41 = t4*t40; /* s*s*omega_tau*I3*a3*m*R */
    const double t42 = t41/t23; /* s*s*omega_tau*I3*a3*m*R/Theta */
    const double t43 = t36 - t42; /* t30 + s*s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - s*s*omega_tau*I3*a3*m*R/Theta */
    out[0] = t43;
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
    const double t16 = p[4]*p[1]; /* I1*R */
    const double t17 = x[4]*t16; /* s*I1*R */
    const double t18 = p[5]*x[3]; /* I3*omega3 */
    const double t19 = x[0]*p[1]; /* gamma3*R */
    const double t20 = p[3] + t19; /* b = a3 + gamma3*R */
    const double t21 = t18*t20; /* I3*omega3*b */
    const double t22 = p[6] + t21; /* G_level + I3*omega3*b */
    const double t23 = t22/t17; /* omega_n = (G_level + I3*omega3*b)/(s*I1*R) */
    const double t24 = t23*t23; /* omega_n*omega_n */
    const double t25 = p[4]*t24; /* I1*omega_n*omega_n */
    const double t26 = (1.0 / 2.0)*t25; /* 1/2*I1*omega_n*omega_n */
    const double t27 = t15 + t26; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*I1*omega_n*omega_n */
    const double t28 = x[3]*x[3]; /* omega3*omega3 */
    const double t29 = p[5]*t28; /* I3*omega3*omega3 */
    const double t30 = (1.0 / 2.0)*t29; /* 1/2*I3*omega3*omega3 */
    const double t31 = t27 + t30; /* t27 + 1/2*I3*omega3*omega3 */
    const double t32 = t20*t23; /* b*omega_n */
    const double t33 = p[1]*x[3]; /* R*omega3 */
    const double t34 = x[4]*t33; /* s*R*omega3 */
    const double t35 = t32 + t34; /* v_tau = b*omega_n + s*R*omega3 */
    const double t36 = t35*t35; /* v_tau*v_tau */
    const double t37 = p[0]*t36; /* m*v_tau*v_tau */
    const double t38 = (1.0 / 2.0)*t37; /* 1/2*m*v_tau*v_tau */
    const double t39 = t31 + t38; /* energy = t27 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    out[0] = t39;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[4]; /* R*I1 */
    const double t1 = t0*x[4]; /* R*I1*s */
    const double t2 = p[5]*x[3]; /* I3*omega3 */
    const double t3 = p[1]*x[0]; /* R*gamma3 */
    const double t4 = p[3] + t3; /* b = a3 + R*gamma3 */
    const double t5 = t2*t4; /* I3*omega3*b */
    const double t6 = p[6] + t5; /* G_level + I3*omega3*b */
    const double t7 = t6/t1; /* omega_n = (G_level + I3*omega3*b)/(R*I1*s) */
    const double t8 = p[5]*t7; /* I3*omega_n */
    const double t9 = x[3]*t8; /* omega3*I3*omega_n */
    const double t10 = t9/x[4]; /* omega3*I3*omega_n/s */
    const double t11 = p[9] + t10; /* m*g*a3 + omega3*I3*omega_n/s */
    const double t12 = t4*t7; /* b*omega_n */
    const double t13 = p[1]*x[3]; /* R*omega3 */
    const double t14 = x[4]*t13; /* s*R*omega3 */
    const double t15 = t12 + t14; /* v_tau = b*omega_n + s*R*omega3 */
    const double t16 = p[0]*t15; /* m*v_tau */
    const double t17 = p[1]*t7; /* R*omega_n */
    const double t18 = p[4]*x[4]; /* I1*s */
    const double t19 = t5/t18; /* I3*omega3*b/(I1*s) */
    const double t20 = t17 + t19; /* d(v_tau)/d(gamma3) = R*omega_n + I3*omega3*b/(I1*s) */
    const double t21 = t16*t20; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t22 = t11 + t21; /* d(energy)/d(gamma3) = m*g*a3 + omega3*I3*omega_n/s + m*v_tau*d(v_tau)/d(gamma3) */
    const double t23 = p[0]*x[1]; /* m*v_nu */
    const double t24 = p[3]*p[3]; /* a3*a3 */
    const double t25 = p[0]*t24; /* m*a3*a3 */
    const double t26 = x[4]*x[4]; /* s*s */
    const double t27 = t25*t26; /* m*a3*a3*s*s */
    const double t28 = p[4] + t27; /* D = I1 + m*a3*a3*s*s */
    const double t29 = x[2]*t28; /* omega_tau*D */
    const double t30 = p[1]*x[4]; /* R*s */
    const double t31 = t4*t4; /* b*b */
    const double t32 = p[5]*t31; /* I3*b*b */
    const double t33 = t32/t1; /* I3*b*b/(R*I1*s) */
    const double t34 = t30 + t33; /* d(v_tau)/d(omega3) = R*s + I3*b*b/(R*I1*s) */
    const double t35 = t16*t34; /* m*v_tau*d(v_tau)/d(omega3) */
    const double t36 = t2 + t35; /* I3*omega3 + m*v_tau*d(v_tau)/d(omega3) */
    const double t37 = t4*t8; /* b*I3*omega_n */
    const double t38 = t37/t30; /* b*I3*omega_n/(R*s) */
    const double t39 = t36 + t38; /* d(energy)/d(omega3) = I3*omega3 + m*v_tau*d(v_tau)/d(omega3) + b*I3*omega_n/(R*s) */
    const double t40 = t0*t26; /* R*I1*s*s */
    const double t41 = t4*t6; /* b*(G_level + I3*omega3*b) */
    const double t42 = t41/t40; /* b*(G_level + I3*omega3*b)/(R*I1*s*s) */
    const double t43 = t13 - t42; /* d(v_tau)/d(s) = R*omega3 - b*(G_level + I3*omega3*b)/(R*I1*s*s) */
    const double t44 = t16*t43; /* m*v_tau*d(v_tau)/d(s) */
    const double t45 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t46 = t25*t45; /* m*a3*a3*omega_tau*omega_tau */
    const double t47 = x[4]*t46; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t48 = t44 + t47; /* m*v_tau*d(v_tau)/d(s) + s*m*a3*a3*omega_tau*omega_tau */
    const double t49 = p[1]*t26; /* R*s*s */
    const double t50 = t6*t7; /* (G_level + I3*omega3*b)*omega_n */
    const double t51 = t50/t49; /* (G_level + I3*omega3*b)*omega_n/(R*s*s) */
    const double t52 = t48 - t51; /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) + s*m*a3*a3*omega_tau*omega_tau - (G_level + I3*omega3*b)*omega_n/(R*s*s) */
    out[0] = t22;
    out[1] = t23;
    out[2] = t29;
    out[3] = t39;
    out[4] = t52;
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
    const double t2 = p[5]*x[3]; /* I3*omega3 */
    const double t3 = p[1]*x[0]; /* R*gamma3 */
    const double t4 = p[3] + t3; /* b = a3 + R*gamma3 */
    const double t5 = t2*t4; /* I3*omega3*b */
    const double t6 = p[6] + t5; /* G_level + I3*omega3*b */
    const double t7 = t6/t1; /* omega_n = (G_level + I3*omega3*b)/(R*I1*s) */
    out[0] = t7;
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
    const double v_a3 = params[3];
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
};

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 10,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 14, 53, 0, 8, 0, 0, 11, 8 }, { 15, 66, 0, 8, 0, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 25, { 46, 197, 0, 44, 0, 0, 16, 21 }, { 57, 322, 0, 44, 0, 0, 16, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 53, 210, 0, 51, 0, 0, 16, 41 }, { 65, 368, 0, 51, 0, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 10, 30, 0, 4, 0, 0, 11, 8 }, { 11, 40, 0, 4, 0, 0, 11, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 1, { 9, 30, 0, 1, 0, 0, 11, 5 }, { 9, 30, 0, 1, 0, 0, 11, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 5, { 13, 33, 0, 7, 0, 0, 11, 14 }, { 15, 54, 0, 7, 0, 0, 11, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 2, 5, 0, 1, 0, 0, 5, 4 }, { 2, 5, 0, 1, 0, 0, 5, 4 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_in_regular_on_level_G_baseline,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_avx2,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_avx512,
    },
};
