/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 11   40    0    5    0    0     11    8   (65)
 *  jacobian            38  124    0   29    0    0     15   19   (286)
 *  rhs_jacobian        45  134    0   33    0    0     15   28   (329)
 *  divergence          5   19    0    3    0    0     10    7   (36)
 *  integral_values     10   39    0    1    0    0     13    6   (55)
 *  integral_gradients  15   64    0   10    0    0     12   13   (138)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          1    5    0    1    0    0      5    3   (7)
 *
 *  Accuracy: divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx512;

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
    const double t2 = p[1]*x[3]; /* R*omega_n */
    const double t3 = p[1]*p[5]; /* R*I3 */
    const double t4 = t3*x[0]; /* R*I3*gamma3 */
    const double t5 = p[1]*p[4]; /* R*I1 */
    const double t6 = x[3]*t5; /* omega_n*R*I1 */
    const double t7 = x[4]*t6; /* s*omega_n*R*I1 */
    const double t8 = t7 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t9 = t8/t4; /* omega3 = (s*omega_n*R*I1 - G_level)/(R*I3*gamma3) */
    const double t10 = t2*t9; /* R*omega_n*omega3 */
    const double t11 = x[4]*t10; /* s*R*omega_n*omega3 */
    const double t12 = p[1]*x[0]; /* R*gamma3 */
    const double t13 = x[3]*x[3]; /* omega_n*omega_n */
    const double t14 = t12*t13; /* R*gamma3*omega_n*omega_n */
    const double t15 = t11 + t14; /* s*R*omega_n*omega3 + R*gamma3*omega_n*omega_n */
    const double t16 = x[0]*t13; /* gamma3*omega_n*omega_n */
    const double t17 = -t16; /* -gamma3*omega_n*omega_n */
    const double t18 = x[3]*p[5]; /* omega_n*I3 */
    const double t19 = t9*t18; /* omega3*omega_n*I3 */
    const double t20 = x[4]*t19; /* s*omega3*omega_n*I3 */
    const double t21 = t20/p[4]; /* s*omega3*omega_n*I3/I1 */
    const double t22 = t17 - t21; /* -gamma3*omega_n*omega_n - s*omega3*omega_n*I3/I1 */
    const double t23 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t24 = x[3]*t23; /* omega_n*omega_tau*gamma3 */
    const double t25 = p[5]*p[5]; /* I3*I3 */
    const double t26 = x[2]*t25; /* omega_tau*I3*I3 */
    const double t27 = t9*t26; /* omega3*omega_tau*I3*I3 */
    const double t28 = x[4]*t27; /* s*omega3*omega_tau*I3*I3 */
    const double t29 = p[1]*p[1]; /* R*R */
    const double t30 = p[0]*t29; /* m*R*R */
    const double t31 = p[4]*t30; /* I1*m*R*R */
    const double t32 = t0*t31; /* s*s*I1*m*R*R */
    const double t33 = p[7] + t32; /* I1*I3 + s*s*I1*m*R*R */
    const double t34 = p[5]*t30; /* I3*m*R*R */
    const double t35 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t36 = t34*t35; /* I3*m*R*R*gamma3*gamma3 */
    const double t37 = t33 + t36; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*R*R*gamma3*gamma3 */
    const double t38 = t28/t37; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t39 = t24 + t38; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta */
    const double t40 = p[1]*p[0]; /* R*m */
    const double t41 = p[5]*t40; /* I3*R*m */
    const double t42 = x[0]*t41; /* gamma3*I3*R*m */
    const double t43 = x[3]*t42; /* omega_n*gamma3*I3*R*m */
    const double t44 = x[2]*p[1]; /* omega_tau*R */
    const double t45 = x[1] + t44; /* V = v_nu + omega_tau*R */
    const double t46 = t43*t45; /* omega_n*gamma3*I3*R*m*V */
    const double t47 = t46/t37; /* omega_n*gamma3*I3*R*m*V/Theta */
    const double t48 = t39 - t47; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/Theta */
    const double t49 = x[2]*t34; /* omega_tau*I3*m*R*R */
    const double t50 = t9*t49; /* omega3*omega_tau*I3*m*R*R */
    const double t51 = x[4]*t50; /* s*omega3*omega_tau*I3*m*R*R */
    const double t52 = t51/t37; /* s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t53 = t48 + t52; /* t48 + s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t54 = x[4]*t23; /* s*omega_tau*gamma3 */
    const double t55 = -t54; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t15;
    out[2] = t22;
    out[3] = t53;
    out[4] = t55;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[4]*t1; /* s*2*omega_tau */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t6 = p[5]*t5; /* I3*gamma3*gamma3 */
    const double t7 = x[4]*x[3]; /* s*omega_n */
    const double t8 = p[1]*p[4]; /* R*I1 */
    const double t9 = x[3]*t8; /* omega_n*R*I1 */
    const double t10 = x[4]*t9; /* s*omega_n*R*I1 */
    const double t11 = p[6] - t10; /* G_level - s*omega_n*R*I1 */
    const double t12 = t7*t11; /* s*omega_n*(G_level - s*omega_n*R*I1) */
    const double t13 = t12/t6; /* s*omega_n*(G_level - s*omega_n*R*I1)/(I3*gamma3*gamma3) */
    const double t14 = t4 + t13; /* R*omega_n*omega_n + s*omega_n*(G_level - s*omega_n*R*I1)/(I3*gamma3*gamma3) */
    const double t15 = p[1]*p[5]; /* R*I3 */
    const double t16 = x[0]*t15; /* gamma3*R*I3 */
    const double t17 = t10 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t18 = t17/t16; /* omega3 = (s*omega_n*R*I1 - G_level)/(gamma3*R*I3) */
    const double t19 = p[1]*t18; /* R*omega3 */
    const double t20 = x[4]*t19; /* s*R*omega3 */
    const double t21 = p[1]*x[0]; /* R*gamma3 */
    const double t22 = x[3]*t21; /* omega_n*R*gamma3 */
    const double t23 = 2.0*t22; /* 2*omega_n*R*gamma3 */
    const double t24 = t20 + t23; /* s*R*omega3 + 2*omega_n*R*gamma3 */
    const double t25 = p[5]*x[0]; /* I3*gamma3 */
    const double t26 = t0*t9; /* s*s*omega_n*R*I1 */
    const double t27 = t26/t25; /* s*s*omega_n*R*I1/(I3*gamma3) */
    const double t28 = t24 + t27; /* s*R*omega3 + 2*omega_n*R*gamma3 + s*s*omega_n*R*I1/(I3*gamma3) */
    const double t29 = p[1]*x[3]; /* R*omega_n */
    const double t30 = t18*t29; /* omega3*R*omega_n */
    const double t31 = t3*t8; /* omega_n*omega_n*R*I1 */
    const double t32 = x[4]*t31; /* s*omega_n*omega_n*R*I1 */
    const double t33 = t32/t25; /* s*omega_n*omega_n*R*I1/(I3*gamma3) */
    const double t34 = t30 + t33; /* omega3*R*omega_n + s*omega_n*omega_n*R*I1/(I3*gamma3) */
    const double t35 = -t3; /* -omega_n*omega_n */
    const double t36 = t5*t8; /* gamma3*gamma3*R*I1 */
    const double t37 = t12/t36; /* s*omega_n*(G_level - s*omega_n*R*I1)/(gamma3*gamma3*R*I1) */
    const double t38 = t35 - t37; /* -omega_n*omega_n - s*omega_n*(G_level - s*omega_n*R*I1)/(gamma3*gamma3*R*I1) */
    const double t39 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t40 = 2.0*t39; /* 2*omega_n*gamma3 */
    const double t41 = -t40; /* -2*omega_n*gamma3 */
    const double t42 = p[5]*t18; /* I3*omega3 */
    const double t43 = x[4]*t42; /* s*I3*omega3 */
    const double t44 = t43/p[4]; /* s*I3*omega3/I1 */
    const double t45 = t41 - t44; /* -2*omega_n*gamma3 - s*I3*omega3/I1 */
    const double t46 = t0*x[3]; /* s*s*omega_n */
    const double t47 = t46/x[0]; /* s*s*omega_n/gamma3 */
    const double t48 = t45 - t47; /* -2*omega_n*gamma3 - s*I3*omega3/I1 - s*s*omega_n/gamma3 */
    const double t49 = x[3]*p[5]; /* omega_n*I3 */
    const double t50 = t18*t49; /* omega3*omega_n*I3 */
    const double t51 = t50/p[4]; /* omega3*omega_n*I3/I1 */
    const double t52 = -t51; /* -omega3*omega_n*I3/I1 */
    const double t53 = x[4]*t3; /* s*omega_n*omega_n */
    const double t54 = t53/x[0]; /* s*omega_n*omega_n/gamma3 */
    const double t55 = t52 - t54; /* -omega3*omega_n*I3/I1 - s*omega_n*omega_n/gamma3 */
    const double t56 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t57 = p[1]*p[0]; /* R*m */
    const double t58 = p[5]*t57; /* I3*R*m */
    const double t59 = x[3]*t58; /* omega_n*I3*R*m */
    const double t60 = p[1]*p[1]; /* R*R */
    const double t61 = p[0]*t60; /* m*R*R */
    const double t62 = p[4]*t61; /* I1*m*R*R */
    const double t63 = t0*t62; /* s*s*I1*m*R*R */
    const double t64 = p[7] + t63; /* I1*I3 + s*s*I1*m*R*R */
    const double t65 = p[5]*t61; /* I3*m*R*R */
    const double t66 = t5*t65; /* gamma3*gamma3*I3*m*R*R */
    const double t67 = t64 + t66; /* Theta = I1*I3 + s*s*I1*m*R*R + gamma3*gamma3*I3*m*R*R */
    const double t68 = x[2]*p[1]; /* omega_tau*R */
    const double t69 = x[1] + t68; /* V = v_nu + omega_tau*R */
    const double t70 = t59*t69; /* omega_n*I3*R*m*V */
    const double t71 = t70/t67; /* omega_n*I3*R*m*V/Theta */
    const double t72 = t56 - t71; /* omega_tau*omega_n - omega_n*I3*R*m*V/Theta */
    const double t73 = p[5]*p[5]; /* I3*I3 */
    const double t74 = p[5]*t73; /* I3*I3*I3 */
    const double t75 = t61*t74; /* m*R*R*I3*I3*I3 */
    const double t76 = x[0]*t75; /* gamma3*m*R*R*I3*I3*I3 */
    const double t77 = x[2]*t76; /* omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t78 = t18*t77; /* omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t79 = x[4]*t78; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t80 = t67*t67; /* Theta*Theta */
    const double t81 = t79/t80; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t82 = 2.0*t81; /* 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t83 = t72 - t82; /* omega_tau*omega_n - omega_n*I3*R*m*V/Theta - 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t84 = p[0]*p[0]; /* m*m */
    const double t85 = p[1]*t60; /* R*R*R */
    const double t86 = t84*t85; /* m*m*R*R*R */
    const double t87 = t73*t86; /* I3*I3*m*m*R*R*R */
    const double t88 = t5*t87; /* gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t89 = x[3]*t88; /* omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t90 = t69*t89; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t91 = t90/t80; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t92 = 2.0*t91; /* 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t93 = t83 + t92; /* t83 + 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t94 = t60*t60; /* R*R*R*R */
    const double t95 = t84*t94; /* m*m*R*R*R*R */
    const double t96 = t73*t95; /* I3*I3*m*m*R*R*R*R */
    const double t97 = x[0]*t96; /* gamma3*I3*I3*m*m*R*R*R*R */
    const double t98 = x[2]*t97; /* omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t99 = t18*t98; /* omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t100 = x[4]*t99; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t101 = t100/t80; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t102 = 2.0*t101; /* 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t103 = t93 - t102; /* t93 - 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t104 = p[1]*t5; /* R*gamma3*gamma3 */
    const double t105 = x[2]*p[5]; /* omega_tau*I3 */
    const double t106 = x[4]*t105; /* s*omega_tau*I3 */
    const double t107 = t67*t104; /* Theta*R*gamma3*gamma3 */
    const double t108 = t11*t106; /* (G_level - s*omega_n*R*I1)*s*omega_tau*I3 */
    const double t109 = t108/t107; /* (G_level - s*omega_n*R*I1)*s*omega_tau*I3/(Theta*R*gamma3*gamma3) */
    const double t110 = t103 + t109; /* t103 + t109 */
    const double t111 = x[2]*t57; /* omega_tau*R*m */
    const double t112 = x[4]*t111; /* s*omega_tau*R*m */
    const double t113 = t5*t67; /* gamma3*gamma3*Theta */
    const double t114 = t11*t112; /* (G_level - s*omega_n*R*I1)*s*omega_tau*R*m */
    const double t115 = t114/t113; /* (G_level - s*omega_n*R*I1)*s*omega_tau*R*m/(gamma3*gamma3*Theta) */
    const double t116 = t110 + t115; /* t103 + t109 + t115 */
    const double t117 = x[0]*t58; /* gamma3*I3*R*m */
    const double t118 = x[3]*t117; /* omega_n*gamma3*I3*R*m */
    const double t119 = t118/t67; /* omega_n*gamma3*I3*R*m/Theta */
    const double t120 = -t119; /* -omega_n*gamma3*I3*R*m/Theta */
    const double t121 = t18*t73; /* omega3*I3*I3 */
    const double t122 = x[4]*t121; /* s*omega3*I3*I3 */
    const double t123 = t122/t67; /* s*omega3*I3*I3/Theta */
    const double t124 = t39 + t123; /* omega_n*gamma3 + s*omega3*I3*I3/Theta */
    const double t125 = x[0]*t65; /* gamma3*I3*m*R*R */
    const double t126 = x[3]*t125; /* omega_n*gamma3*I3*m*R*R */
    const double t127 = t126/t67; /* omega_n*gamma3*I3*m*R*R/Theta */
    const double t128 = t124 - t127; /* omega_n*gamma3 + s*omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/Theta */
    const double t129 = t18*t65; /* omega3*I3*m*R*R */
    const double t130 = x[4]*t129; /* s*omega3*I3*m*R*R */
    const double t131 = t130/t67; /* s*omega3*I3*m*R*R/Theta */
    const double t132 = t128 + t131; /* t128 + s*omega3*I3*m*R*R/Theta */
    const double t133 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t134 = t69*t117; /* V*gamma3*I3*R*m */
    const double t135 = t134/t67; /* V*gamma3*I3*R*m/Theta */
    const double t136 = t133 - t135; /* omega_tau*gamma3 - V*gamma3*I3*R*m/Theta */
    const double t137 = p[5]*p[4]; /* I3*I1 */
    const double t138 = x[2]*t137; /* omega_tau*I3*I1 */
    const double t139 = t0*t138; /* s*s*omega_tau*I3*I1 */
    const double t140 = x[0]*t67; /* gamma3*Theta */
    const double t141 = t139/t140; /* s*s*omega_tau*I3*I1/(gamma3*Theta) */
    const double t142 = t136 + t141; /* omega_tau*gamma3 - V*gamma3*I3*R*m/Theta + s*s*omega_tau*I3*I1/(gamma3*Theta) */
    const double t143 = x[2]*t62; /* omega_tau*I1*m*R*R */
    const double t144 = t0*t143; /* s*s*omega_tau*I1*m*R*R */
    const double t145 = t144/t140; /* s*s*omega_tau*I1*m*R*R/(gamma3*Theta) */
    const double t146 = t142 + t145; /* t142 + s*s*omega_tau*I1*m*R*R/(gamma3*Theta) */
    const double t147 = x[2]*t73; /* omega_tau*I3*I3 */
    const double t148 = t18*t147; /* omega3*omega_tau*I3*I3 */
    const double t149 = t148/t67; /* omega3*omega_tau*I3*I3/Theta */
    const double t150 = t62*t73; /* I1*m*R*R*I3*I3 */
    const double t151 = x[2]*t150; /* omega_tau*I1*m*R*R*I3*I3 */
    const double t152 = t18*t151; /* omega3*omega_tau*I1*m*R*R*I3*I3 */
    const double t153 = t0*t152; /* s*s*omega3*omega_tau*I1*m*R*R*I3*I3 */
    const double t154 = t153/t80; /* s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t155 = 2.0*t154; /* 2*s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t156 = t149 - t155; /* omega3*omega_tau*I3*I3/Theta - 2*s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t157 = x[2]*t65; /* omega_tau*I3*m*R*R */
    const double t158 = t18*t157; /* omega3*omega_tau*I3*m*R*R */
    const double t159 = t158/t67; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t160 = t156 + t159; /* t156 + omega3*omega_tau*I3*m*R*R/Theta */
    const double t161 = p[4]*t86; /* I1*m*m*R*R*R */
    const double t162 = p[5]*t161; /* I3*I1*m*m*R*R*R */
    const double t163 = x[0]*t162; /* gamma3*I3*I1*m*m*R*R*R */
    const double t164 = x[3]*t163; /* omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t165 = x[4]*t164; /* s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t166 = t69*t165; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t167 = t166/t80; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t168 = 2.0*t167; /* 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t169 = t160 + t168; /* t156 + omega3*omega_tau*I3*m*R*R/Theta + 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t170 = p[4]*t95; /* I1*m*m*R*R*R*R */
    const double t171 = p[5]*t170; /* I3*I1*m*m*R*R*R*R */
    const double t172 = x[2]*t171; /* omega_tau*I3*I1*m*m*R*R*R*R */
    const double t173 = t18*t172; /* omega3*omega_tau*I3*I1*m*m*R*R*R*R */
    const double t174 = t0*t173; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R */
    const double t175 = t174/t80; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t176 = 2.0*t175; /* 2*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t177 = t169 - t176; /* t169 - 2*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t178 = x[3]*t138; /* omega_n*omega_tau*I3*I1 */
    const double t179 = x[4]*t178; /* s*omega_n*omega_tau*I3*I1 */
    const double t180 = t179/t140; /* s*omega_n*omega_tau*I3*I1/(gamma3*Theta) */
    const double t181 = t177 + t180; /* t177 + s*omega_n*omega_tau*I3*I1/(gamma3*Theta) */
    const double t182 = x[3]*t143; /* omega_n*omega_tau*I1*m*R*R */
    const double t183 = x[4]*t182; /* s*omega_n*omega_tau*I1*m*R*R */
    const double t184 = t183/t140; /* s*omega_n*omega_tau*I1*m*R*R/(gamma3*Theta) */
    const double t185 = t181 + t184; /* t177 + s*omega_n*omega_tau*I3*I1/(gamma3*Theta) + s*omega_n*omega_tau*I1*m*R*R/(gamma3*Theta) */
    const double t186 = x[4]*x[2]; /* s*omega_tau */
    const double t187 = -t186; /* -s*omega_tau */
    const double t188 = x[4]*x[0]; /* s*gamma3 */
    const double t189 = -t188; /* -s*gamma3 */
    const double t190 = -t133; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t14;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t28;
    out[9] = t34;
    out[10] = t38;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t48;
    out[14] = t55;
    out[15] = t116;
    out[16] = t120;
    out[17] = t132;
    out[18] = t146;
    out[19] = t185;
    out[20] = t187;
    out[21] = 0.0;
    out[22] = t189;
    out[23] = 0.0;
    out[24] = t190;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*x[3]; /* R*omega_n */
    const double t3 = p[1]*p[5]; /* R*I3 */
    const double t4 = t3*x[0]; /* R*I3*gamma3 */
    const double t5 = p[1]*p[4]; /* R*I1 */
    const double t6 = x[3]*t5; /* omega_n*R*I1 */
    const double t7 = x[4]*t6; /* s*omega_n*R*I1 */
    const double t8 = p[6] - t7; /* G_level - s*omega_n*R*I1 */
    const double t9 = t7 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t10 = t9/t4; /* omega3 = (s*omega_n*R*I1 - G_level)/(R*I3*gamma3) */
    const double t11 = t2*t10; /* R*omega_n*omega3 */
    const double t12 = x[4]*t11; /* s*R*omega_n*omega3 */
    const double t13 = p[1]*x[0]; /* R*gamma3 */
    const double t14 = x[3]*x[3]; /* omega_n*omega_n */
    const double t15 = t13*t14; /* R*gamma3*omega_n*omega_n */
    const double t16 = t12 + t15; /* s*R*omega_n*omega3 + R*gamma3*omega_n*omega_n */
    const double t17 = x[0]*t14; /* gamma3*omega_n*omega_n */
    const double t18 = -t17; /* -gamma3*omega_n*omega_n */
    const double t19 = x[3]*p[5]; /* omega_n*I3 */
    const double t20 = t10*t19; /* omega3*omega_n*I3 */
    const double t21 = x[4]*t20; /* s*omega3*omega_n*I3 */
    const double t22 = t21/p[4]; /* s*omega3*omega_n*I3/I1 */
    const double t23 = t18 - t22; /* -gamma3*omega_n*omega_n - s*omega3*omega_n*I3/I1 */
    const double t24 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t25 = x[3]*t24; /* omega_n*omega_tau*gamma3 */
    const double t26 = p[5]*p[5]; /* I3*I3 */
    const double t27 = x[2]*t26; /* omega_tau*I3*I3 */
    const double t28 = t10*t27; /* omega3*omega_tau*I3*I3 */
    const double t29 = x[4]*t28; /* s*omega3*omega_tau*I3*I3 */
    const double t30 = p[1]*p[1]; /* R*R */
    const double t31 = p[0]*t30; /* m*R*R */
    const double t32 = p[4]*t31; /* I1*m*R*R */
    const double t33 = t0*t32; /* s*s*I1*m*R*R */
    const double t34 = p[7] + t33; /* I1*I3 + s*s*I1*m*R*R */
    const double t35 = p[5]*t31; /* I3*m*R*R */
    const double t36 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t37 = t35*t36; /* I3*m*R*R*gamma3*gamma3 */
    const double t38 = t34 + t37; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*R*R*gamma3*gamma3 */
    const double t39 = t29/t38; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t40 = t25 + t39; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta */
    const double t41 = p[1]*p[0]; /* R*m */
    const double t42 = p[5]*t41; /* I3*R*m */
    const double t43 = x[0]*t42; /* gamma3*I3*R*m */
    const double t44 = x[3]*t43; /* omega_n*gamma3*I3*R*m */
    const double t45 = x[2]*p[1]; /* omega_tau*R */
    const double t46 = x[1] + t45; /* V = v_nu + omega_tau*R */
    const double t47 = t44*t46; /* omega_n*gamma3*I3*R*m*V */
    const double t48 = t47/t38; /* omega_n*gamma3*I3*R*m*V/Theta */
    const double t49 = t40 - t48; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/Theta */
    const double t50 = x[2]*t35; /* omega_tau*I3*m*R*R */
    const double t51 = t10*t50; /* omega3*omega_tau*I3*m*R*R */
    const double t52 = x[4]*t51; /* s*omega3*omega_tau*I3*m*R*R */
    const double t53 = t52/t38; /* s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t54 = t49 + t53; /* t49 + s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t55 = -t24; /* -omega_tau*gamma3 */
    const double t56 = x[4]*t24; /* s*omega_tau*gamma3 */
    const double t57 = -t56; /* -s*omega_tau*gamma3 */
    const double t58 = x[2]*2.0; /* omega_tau*2 */
    const double t59 = x[4]*t58; /* s*omega_tau*2 */
    const double t60 = p[1]*t14; /* R*omega_n*omega_n */
    const double t61 = p[5]*t36; /* I3*gamma3*gamma3 */
    const double t62 = x[4]*x[3]; /* s*omega_n */
    const double t63 = t8*t62; /* (G_level - s*omega_n*R*I1)*s*omega_n */
    const double t64 = t63/t61; /* (G_level - s*omega_n*R*I1)*s*omega_n/(I3*gamma3*gamma3) */
    const double t65 = t60 + t64; /* R*omega_n*omega_n + (G_level - s*omega_n*R*I1)*s*omega_n/(I3*gamma3*gamma3) */
    const double t66 = p[1]*t10; /* R*omega3 */
    const double t67 = x[4]*t66; /* s*R*omega3 */
    const double t68 = x[3]*t13; /* omega_n*R*gamma3 */
    const double t69 = 2.0*t68; /* 2*omega_n*R*gamma3 */
    const double t70 = t67 + t69; /* s*R*omega3 + 2*omega_n*R*gamma3 */
    const double t71 = p[5]*x[0]; /* I3*gamma3 */
    const double t72 = t0*t6; /* s*s*omega_n*R*I1 */
    const double t73 = t72/t71; /* s*s*omega_n*R*I1/(I3*gamma3) */
    const double t74 = t70 + t73; /* s*R*omega3 + 2*omega_n*R*gamma3 + s*s*omega_n*R*I1/(I3*gamma3) */
    const double t75 = t5*t14; /* R*I1*omega_n*omega_n */
    const double t76 = x[4]*t75; /* s*R*I1*omega_n*omega_n */
    const double t77 = t76/t71; /* s*R*I1*omega_n*omega_n/(I3*gamma3) */
    const double t78 = t11 + t77; /* R*omega_n*omega3 + s*R*I1*omega_n*omega_n/(I3*gamma3) */
    const double t79 = -t14; /* -omega_n*omega_n */
    const double t80 = t5*t36; /* R*I1*gamma3*gamma3 */
    const double t81 = t63/t80; /* (G_level - s*omega_n*R*I1)*s*omega_n/(R*I1*gamma3*gamma3) */
    const double t82 = t79 - t81; /* -omega_n*omega_n - (G_level - s*omega_n*R*I1)*s*omega_n/(R*I1*gamma3*gamma3) */
    const double t83 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t84 = 2.0*t83; /* 2*omega_n*gamma3 */
    const double t85 = -t84; /* -2*omega_n*gamma3 */
    const double t86 = p[5]*t10; /* I3*omega3 */
    const double t87 = x[4]*t86; /* s*I3*omega3 */
    const double t88 = t87/p[4]; /* s*I3*omega3/I1 */
    const double t89 = t85 - t88; /* -2*omega_n*gamma3 - s*I3*omega3/I1 */
    const double t90 = t0*x[3]; /* s*s*omega_n */
    const double t91 = t90/x[0]; /* s*s*omega_n/gamma3 */
    const double t92 = t89 - t91; /* -2*omega_n*gamma3 - s*I3*omega3/I1 - s*s*omega_n/gamma3 */
    const double t93 = t20/p[4]; /* omega3*omega_n*I3/I1 */
    const double t94 = -t93; /* -omega3*omega_n*I3/I1 */
    const double t95 = x[4]*t14; /* s*omega_n*omega_n */
    const double t96 = t95/x[0]; /* s*omega_n*omega_n/gamma3 */
    const double t97 = t94 - t96; /* -omega3*omega_n*I3/I1 - s*omega_n*omega_n/gamma3 */
    const double t98 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t99 = x[3]*t42; /* omega_n*I3*R*m */
    const double t100 = t46*t99; /* V*omega_n*I3*R*m */
    const double t101 = t100/t38; /* V*omega_n*I3*R*m/Theta */
    const double t102 = t98 - t101; /* omega_tau*omega_n - V*omega_n*I3*R*m/Theta */
    const double t103 = p[5]*t26; /* I3*I3*I3 */
    const double t104 = t31*t103; /* m*R*R*I3*I3*I3 */
    const double t105 = x[0]*t104; /* gamma3*m*R*R*I3*I3*I3 */
    const double t106 = x[2]*t105; /* omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t107 = t10*t106; /* omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t108 = x[4]*t107; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t109 = t38*t38; /* Theta*Theta */
    const double t110 = t108/t109; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t111 = 2.0*t110; /* 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t112 = t102 - t111; /* omega_tau*omega_n - V*omega_n*I3*R*m/Theta - 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t113 = p[0]*p[0]; /* m*m */
    const double t114 = p[1]*t30; /* R*R*R */
    const double t115 = t113*t114; /* m*m*R*R*R */
    const double t116 = t26*t115; /* I3*I3*m*m*R*R*R */
    const double t117 = t36*t116; /* gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t118 = x[3]*t117; /* omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t119 = t46*t118; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t120 = t119/t109; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t121 = 2.0*t120; /* 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t122 = t112 + t121; /* t112 + 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t123 = t30*t30; /* R*R*R*R */
    const double t124 = t113*t123; /* m*m*R*R*R*R */
    const double t125 = t26*t124; /* I3*I3*m*m*R*R*R*R */
    const double t126 = x[0]*t125; /* gamma3*I3*I3*m*m*R*R*R*R */
    const double t127 = x[2]*t126; /* omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t128 = t10*t127; /* omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t129 = x[4]*t128; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t130 = t129/t109; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t131 = 2.0*t130; /* 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t132 = t122 - t131; /* t122 - 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t133 = p[1]*t36; /* R*gamma3*gamma3 */
    const double t134 = x[2]*p[5]; /* omega_tau*I3 */
    const double t135 = x[4]*t134; /* s*omega_tau*I3 */
    const double t136 = t38*t133; /* Theta*R*gamma3*gamma3 */
    const double t137 = t8*t135; /* (G_level - s*omega_n*R*I1)*s*omega_tau*I3 */
    const double t138 = t137/t136; /* (G_level - s*omega_n*R*I1)*s*omega_tau*I3/(Theta*R*gamma3*gamma3) */
    const double t139 = t132 + t138; /* t132 + t138 */
    const double t140 = x[2]*t41; /* omega_tau*R*m */
    const double t141 = x[4]*t140; /* s*omega_tau*R*m */
    const double t142 = t36*t38; /* gamma3*gamma3*Theta */
    const double t143 = t8*t141; /* (G_level - s*omega_n*R*I1)*s*omega_tau*R*m */
    const double t144 = t143/t142; /* (G_level - s*omega_n*R*I1)*s*omega_tau*R*m/(gamma3*gamma3*Theta) */
    const double t145 = t139 + t144; /* t132 + t138 + t144 */
    const double t146 = t44/t38; /* omega_n*gamma3*I3*R*m/Theta */
    const double t147 = -t146; /* -omega_n*gamma3*I3*R*m/Theta */
    const double t148 = t10*t26; /* omega3*I3*I3 */
    const double t149 = x[4]*t148; /* s*omega3*I3*I3 */
    const double t150 = t149/t38; /* s*omega3*I3*I3/Theta */
    const double t151 = t83 + t150; /* omega_n*gamma3 + s*omega3*I3*I3/Theta */
    const double t152 = x[0]*t35; /* gamma3*I3*m*R*R */
    const double t153 = x[3]*t152; /* omega_n*gamma3*I3*m*R*R */
    const double t154 = t153/t38; /* omega_n*gamma3*I3*m*R*R/Theta */
    const double t155 = t151 - t154; /* omega_n*gamma3 + s*omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/Theta */
    const double t156 = t10*t35; /* omega3*I3*m*R*R */
    const double t157 = x[4]*t156; /* s*omega3*I3*m*R*R */
    const double t158 = t157/t38; /* s*omega3*I3*m*R*R/Theta */
    const double t159 = t155 + t158; /* t155 + s*omega3*I3*m*R*R/Theta */
    const double t160 = t43*t46; /* gamma3*I3*R*m*V */
    const double t161 = t160/t38; /* gamma3*I3*R*m*V/Theta */
    const double t162 = t24 - t161; /* omega_tau*gamma3 - gamma3*I3*R*m*V/Theta */
    const double t163 = p[5]*p[4]; /* I3*I1 */
    const double t164 = x[2]*t163; /* omega_tau*I3*I1 */
    const double t165 = t0*t164; /* s*s*omega_tau*I3*I1 */
    const double t166 = x[0]*t38; /* gamma3*Theta */
    const double t167 = t165/t166; /* s*s*omega_tau*I3*I1/(gamma3*Theta) */
    const double t168 = t162 + t167; /* omega_tau*gamma3 - gamma3*I3*R*m*V/Theta + s*s*omega_tau*I3*I1/(gamma3*Theta) */
    const double t169 = x[2]*t32; /* omega_tau*I1*m*R*R */
    const double t170 = t0*t169; /* s*s*omega_tau*I1*m*R*R */
    const double t171 = t170/t166; /* s*s*omega_tau*I1*m*R*R/(gamma3*Theta) */
    const double t172 = t168 + t171; /* t168 + s*s*omega_tau*I1*m*R*R/(gamma3*Theta) */
    const double t173 = t28/t38; /* omega3*omega_tau*I3*I3/Theta */
    const double t174 = t26*t32; /* I3*I3*I1*m*R*R */
    const double t175 = x[2]*t174; /* omega_tau*I3*I3*I1*m*R*R */
    const double t176 = t10*t175; /* omega3*omega_tau*I3*I3*I1*m*R*R */
    const double t177 = t0*t176; /* s*s*omega3*omega_tau*I3*I3*I1*m*R*R */
    const double t178 = t177/t109; /* s*s*omega3*omega_tau*I3*I3*I1*m*R*R/(Theta*Theta) */
    const double t179 = 2.0*t178; /* 2*s*s*omega3*omega_tau*I3*I3*I1*m*R*R/(Theta*Theta) */
    const double t180 = t173 - t179; /* omega3*omega_tau*I3*I3/Theta - 2*s*s*omega3*omega_tau*I3*I3*I1*m*R*R/(Theta*Theta) */
    const double t181 = t51/t38; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t182 = t180 + t181; /* t180 + omega3*omega_tau*I3*m*R*R/Theta */
    const double t183 = p[4]*t115; /* I1*m*m*R*R*R */
    const double t184 = p[5]*t183; /* I3*I1*m*m*R*R*R */
    const double t185 = x[0]*t184; /* gamma3*I3*I1*m*m*R*R*R */
    const double t186 = x[3]*t185; /* omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t187 = x[4]*t186; /* s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t188 = t46*t187; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t189 = t188/t109; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t190 = 2.0*t189; /* 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t191 = t182 + t190; /* t180 + omega3*omega_tau*I3*m*R*R/Theta + 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t192 = p[4]*t124; /* I1*m*m*R*R*R*R */
    const double t193 = p[5]*t192; /* I3*I1*m*m*R*R*R*R */
    const double t194 = x[2]*t193; /* omega_tau*I3*I1*m*m*R*R*R*R */
    const double t195 = t10*t194; /* omega3*omega_tau*I3*I1*m*m*R*R*R*R */
    const double t196 = t0*t195; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R */
    const double t197 = t196/t109; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t198 = 2.0*t197; /* 2*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t199 = t191 - t198; /* t191 - 2*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t200 = x[3]*t164; /* omega_n*omega_tau*I3*I1 */
    const double t201 = x[4]*t200; /* s*omega_n*omega_tau*I3*I1 */
    const double t202 = t201/t166; /* s*omega_n*omega_tau*I3*I1/(gamma3*Theta) */
    const double t203 = t199 + t202; /* t199 + s*omega_n*omega_tau*I3*I1/(gamma3*Theta) */
    const double t204 = x[3]*t169; /* omega_n*omega_tau*I1*m*R*R */
    const double t205 = x[4]*t204; /* s*omega_n*omega_tau*I1*m*R*R */
    const double t206 = t205/t166; /* s*omega_n*omega_tau*I1*m*R*R/(gamma3*Theta) */
    const double t207 = t203 + t206; /* t199 + s*omega_n*omega_tau*I3*I1/(gamma3*Theta) + s*omega_n*omega_tau*I1*m*R*R/(gamma3*Theta) */
    const double t208 = x[2]*x[4]; /* omega_tau*s */
    const double t209 = -t208; /* -omega_tau*s */
    const double t210 = x[4]*x[0]; /* s*gamma3 */
    const double t211 = -t210; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t16;
    out[2] = t23;
    out[3] = t54;
    out[4] = t57;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t59;
    out[10] = t65;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t74;
    out[14] = t78;
    out[15] = t82;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t92;
    out[19] = t97;
    out[20] = t145;
    out[21] = t147;
    out[22] = t159;
    out[23] = t172;
    out[24] = t207;
    out[25] = t209;
    out[26] = 0.0;
    out[27] = t211;
    out[28] = 0.0;
    out[29] = t55;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[1]; /* m*R */
    const double t1 = t0*p[5]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = p[1]*p[1]; /* R*R */
    const double t4 = p[0]*t3; /* m*R*R */
    const double t5 = t4*p[4]; /* m*R*R*I1 */
    const double t6 = x[4]*x[4]; /* s*s */
    const double t7 = t5*t6; /* m*R*R*I1*s*s */
    const double t8 = p[7] + t7; /* I1*I3 + m*R*R*I1*s*s */
    const double t9 = p[5]*t4; /* I3*m*R*R */
    const double t10 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t11 = t9*t10; /* I3*m*R*R*gamma3*gamma3 */
    const double t12 = t8 + t11; /* Theta = I1*I3 + m*R*R*I1*s*s + I3*m*R*R*gamma3*gamma3 */
    const double t13 = p[1]*x[2]; /* R*omega_tau */
    const double t14 = x[1] + t13; /* V = v_nu + R*omega_tau */
    const double t15 = t2*t14; /* m*R*I3*gamma3*V */
    const double t16 = t15/t12; /* m*R*I3*gamma3*V/Theta */
    const double t17 = p[5]*p[4]; /* I3*I1 */
    const double t18 = x[2]*t17; /* omega_tau*I3*I1 */
    const double t19 = t6*t18; /* s*s*omega_tau*I3*I1 */
    const double t20 = x[0]*t12; /* gamma3*Theta */
    const double t21 = t19/t20; /* s*s*omega_tau*I3*I1/(gamma3*Theta) */
    const double t22 = t21 - t16; /* s*s*omega_tau*I3*I1/(gamma3*Theta) - m*R*I3*gamma3*V/Theta */
    const double t23 = t5*x[2]; /* m*R*R*I1*omega_tau */
    const double t24 = t6*t23; /* s*s*m*R*R*I1*omega_tau */
    const double t25 = t24/t20; /* s*s*m*R*R*I1*omega_tau/(gamma3*Theta) */
    const double t26 = t22 + t25; /* s*s*omega_tau*I3*I1/(gamma3*Theta) - m*R*I3*gamma3*V/Theta + s*s*m*R*R*I1*omega_tau/(gamma3*Theta) */
    out[0] = t26;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[0]*t0; /* m*v_nu*v_nu */
    const double t2 = t1*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[4]*t3; /* I1*omega_n*omega_n */
    const double t5 = (1.0 / 2.0)*t4; /* 1/2*I1*omega_n*omega_n */
    const double t6 = t2 + t5; /* m*v_nu*v_nu*1/2 + 1/2*I1*omega_n*omega_n */
    const double t7 = p[5]*p[1]; /* I3*R */
    const double t8 = t7*x[0]; /* I3*R*gamma3 */
    const double t9 = p[4]*p[1]; /* I1*R */
    const double t10 = x[3]*t9; /* omega_n*I1*R */
    const double t11 = t10*x[4]; /* omega_n*I1*R*s */
    const double t12 = t11 - p[6]; /* omega_n*I1*R*s - G_level */
    const double t13 = t12/t8; /* omega3 = (omega_n*I1*R*s - G_level)/(I3*R*gamma3) */
    const double t14 = t13*t13; /* omega3*omega3 */
    const double t15 = p[5]*t14; /* I3*omega3*omega3 */
    const double t16 = (1.0 / 2.0)*t15; /* 1/2*I3*omega3*omega3 */
    const double t17 = t6 + t16; /* m*v_nu*v_nu*1/2 + 1/2*I1*omega_n*omega_n + 1/2*I3*omega3*omega3 */
    const double t18 = p[1]*t13; /* R*omega3 */
    const double t19 = x[4]*t18; /* s*R*omega3 */
    const double t20 = p[1]*x[0]; /* R*gamma3 */
    const double t21 = x[3]*t20; /* omega_n*R*gamma3 */
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
    const double t0 = p[1]*p[5]; /* R*I3 */
    const double t1 = t0*x[0]; /* R*I3*gamma3 */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = t2*x[3]; /* R*I1*omega_n */
    const double t4 = t3*x[4]; /* R*I1*omega_n*s */
    const double t5 = p[6] - t4; /* G_level - R*I1*omega_n*s */
    const double t6 = t4 - p[6]; /* R*I1*omega_n*s - G_level */
    const double t7 = t6/t1; /* omega3 = (R*I1*omega_n*s - G_level)/(R*I3*gamma3) */
    const double t8 = p[1]*t7; /* R*omega3 */
    const double t9 = x[4]*t8; /* s*R*omega3 */
    const double t10 = p[1]*x[0]; /* R*gamma3 */
    const double t11 = x[3]*t10; /* omega_n*R*gamma3 */
    const double t12 = t9 + t11; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t13 = p[0]*t12; /* m*v_tau */
    const double t14 = p[1]*x[3]; /* R*omega_n */
    const double t15 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t16 = p[5]*t15; /* I3*gamma3*gamma3 */
    const double t17 = x[4]*t5; /* s*(G_level - R*I1*omega_n*s) */
    const double t18 = t17/t16; /* s*(G_level - R*I1*omega_n*s)/(I3*gamma3*gamma3) */
    const double t19 = t14 + t18; /* d(v_tau)/d(gamma3) = R*omega_n + s*(G_level - R*I1*omega_n*s)/(I3*gamma3*gamma3) */
    const double t20 = t13*t19; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t21 = p[1]*t15; /* R*gamma3*gamma3 */
    const double t22 = t5*t7; /* (G_level - R*I1*omega_n*s)*omega3 */
    const double t23 = t22/t21; /* (G_level - R*I1*omega_n*s)*omega3/(R*gamma3*gamma3) */
    const double t24 = t20 + t23; /* d(energy)/d(gamma3) = m*v_tau*d(v_tau)/d(gamma3) + (G_level - R*I1*omega_n*s)*omega3/(R*gamma3*gamma3) */
    const double t25 = p[0]*x[1]; /* m*v_nu */
    const double t26 = p[4]*x[2]; /* I1*omega_tau */
    const double t27 = p[4]*x[3]; /* I1*omega_n */
    const double t28 = p[5]*x[0]; /* I3*gamma3 */
    const double t29 = x[4]*x[4]; /* s*s */
    const double t30 = t2*t29; /* R*I1*s*s */
    const double t31 = t30/t28; /* R*I1*s*s/(I3*gamma3) */
    const double t32 = t10 + t31; /* d(v_tau)/d(omega_n) = R*gamma3 + R*I1*s*s/(I3*gamma3) */
    const double t33 = t13*t32; /* m*v_tau*d(v_tau)/d(omega_n) */
    const double t34 = t27 + t33; /* I1*omega_n + m*v_tau*d(v_tau)/d(omega_n) */
    const double t35 = p[4]*t7; /* I1*omega3 */
    const double t36 = x[4]*t35; /* s*I1*omega3 */
    const double t37 = t36/x[0]; /* s*I1*omega3/gamma3 */
    const double t38 = t34 + t37; /* d(energy)/d(omega_n) = I1*omega_n + m*v_tau*d(v_tau)/d(omega_n) + s*I1*omega3/gamma3 */
    const double t39 = t4/t28; /* R*I1*omega_n*s/(I3*gamma3) */
    const double t40 = t8 + t39; /* d(v_tau)/d(s) = R*omega3 + R*I1*omega_n*s/(I3*gamma3) */
    const double t41 = t13*t40; /* m*v_tau*d(v_tau)/d(s) */
    const double t42 = t7*t27; /* omega3*I1*omega_n */
    const double t43 = t42/x[0]; /* omega3*I1*omega_n/gamma3 */
    const double t44 = t41 + t43; /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) + omega3*I1*omega_n/gamma3 */
    const double t45 = p[1]*p[1]; /* R*R */
    const double t46 = p[0]*t45; /* m*R*R */
    const double t47 = p[5]*t46; /* I3*m*R*R */
    const double t48 = x[0]*t47; /* gamma3*I3*m*R*R */
    const double t49 = t7*t7; /* omega3*omega3 */
    const double t50 = t48*t49; /* gamma3*I3*m*R*R*omega3*omega3 */
    const double t51 = t50*p[8]; /* gamma3*I3*m*R*R*omega3*omega3*(I1 - I3) */
    const double t52 = t51*2.0; /* gamma3*I3*m*R*R*omega3*omega3*(I1 - I3)*2 */
    const double t53 = t0*t15; /* R*I3*gamma3*gamma3 */
    const double t54 = p[4]*t46; /* I1*m*R*R */
    const double t55 = t29*t54; /* s*s*I1*m*R*R */
    const double t56 = p[7] + t55; /* I1*I3 + s*s*I1*m*R*R */
    const double t57 = t15*t47; /* gamma3*gamma3*I3*m*R*R */
    const double t58 = t56 + t57; /* Theta = I1*I3 + s*s*I1*m*R*R + gamma3*gamma3*I3*m*R*R */
    const double t59 = t7*t58; /* omega3*Theta */
    const double t60 = p[8]*t59; /* (I1 - I3)*omega3*Theta */
    const double t61 = t5*t60; /* (G_level - R*I1*omega_n*s)*(I1 - I3)*omega3*Theta */
    const double t62 = t61/t53; /* (G_level - R*I1*omega_n*s)*(I1 - I3)*omega3*Theta/(R*I3*gamma3*gamma3) */
    const double t63 = 2.0*t62; /* 2*t62 */
    const double t64 = t52 + t63; /* gamma3*I3*m*R*R*omega3*omega3*(I1 - I3)*2 + 2*t62 */
    const double t65 = p[0]*2.0; /* m*2 */
    const double t66 = p[4]*p[4]; /* I1*I1 */
    const double t67 = t65*t66; /* m*2*I1*I1 */
    const double t68 = p[1]*x[2]; /* R*omega_tau */
    const double t69 = x[1] + t68; /* v_nu + R*omega_tau */
    const double t70 = t67*t69; /* m*2*I1*I1*(v_nu + R*omega_tau) */
    const double t71 = p[1]*t65; /* R*m*2 */
    const double t72 = t66*t71; /* I1*I1*R*m*2 */
    const double t73 = t69*t72; /* (v_nu + R*omega_tau)*I1*I1*R*m*2 */
    const double t74 = p[4]*2.0; /* I1*2 */
    const double t75 = t7*t74; /* omega3*I1*2 */
    const double t76 = x[4]*t75; /* s*omega3*I1*2 */
    const double t77 = t58*t76; /* Theta*s*omega3*I1*2 */
    const double t78 = p[8]*t77; /* (I1 - I3)*Theta*s*omega3*I1*2 */
    const double t79 = t78/t28; /* (I1 - I3)*Theta*s*omega3*I1*2/(I3*gamma3) */
    const double t80 = t49*t54; /* omega3*omega3*I1*m*R*R */
    const double t81 = x[4]*t80; /* s*omega3*omega3*I1*m*R*R */
    const double t82 = p[8]*t81; /* (I1 - I3)*s*omega3*omega3*I1*m*R*R */
    const double t83 = 2.0*t82; /* 2*(I1 - I3)*s*omega3*omega3*I1*m*R*R */
    const double t84 = t42*t58; /* omega3*I1*omega_n*Theta */
    const double t85 = p[8]*t84; /* (I1 - I3)*omega3*I1*omega_n*Theta */
    const double t86 = t85/t28; /* (I1 - I3)*omega3*I1*omega_n*Theta/(I3*gamma3) */
    const double t87 = 2.0*t86; /* 2*(I1 - I3)*omega3*I1*omega_n*Theta/(I3*gamma3) */
    const double t88 = t83 + t87; /* 2*(I1 - I3)*s*omega3*omega3*I1*m*R*R + 2*(I1 - I3)*omega3*I1*omega_n*Theta/(I3*gamma3) */
    out[0] = t24;
    out[1] = t25;
    out[2] = t26;
    out[3] = t38;
    out[4] = t44;
    out[5] = t64;
    out[6] = t70;
    out[7] = t73;
    out[8] = t79;
    out[9] = t88;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[5]; /* R*I3 */
    const double t1 = t0*x[0]; /* R*I3*gamma3 */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = t2*x[3]; /* R*I1*omega_n */
    const double t4 = t3*x[4]; /* R*I1*omega_n*s */
    const double t5 = t4 - p[6]; /* R*I1*omega_n*s - G_level */
    const double t6 = t5/t1; /* omega3 = (R*I1*omega_n*s - G_level)/(R*I3*gamma3) */
    out[0] = t6;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = (0.0);
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
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "balanced",
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
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 11, 40, 0, 5, 0, 0, 11, 8 }, { 11, 49, 0, 5, 0, 0, 11, 7 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .jacobian = { jacobian, 25, { 38, 124, 0, 29, 0, 0, 15, 19 }, { 41, 216, 0, 29, 0, 0, 15, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 45, 134, 0, 33, 0, 0, 15, 28 }, { 48, 248, 0, 33, 0, 0, 15, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .divergence = { divergence, 1, { 5, 19, 0, 3, 0, 0, 10, 7 }, { 5, 28, 0, 3, 0, 0, 10, 5 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .integral_values = { integral_values, 2, { 10, 39, 0, 1, 0, 0, 13, 6 }, { 11, 43, 0, 1, 0, 0, 13, 6 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 10, { 15, 64, 0, 10, 0, 0, 12, 13 }, { 23, 105, 0, 10, 0, 0, 12, 9 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 1, 5, 0, 1, 0, 0, 5, 3 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx512,
    },
};
