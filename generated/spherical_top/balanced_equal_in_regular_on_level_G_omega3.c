/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 11   37    0    4    0    0     11    8   (63)
 *  jacobian            38  110    0   27    0    0     14   19   (278)
 *  rhs_jacobian        45  120    0   30    0    0     14   29   (319)
 *  divergence          5   18    0    3    0    0     10    6   (36)
 *  integral_values     7   28    0    1    0    0     14    4   (39)
 *  integral_gradients  11   35    0    7    0    0     12   10   (72)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          1    4    0    1    0    0      5    3   (7)
 *
 *  Accuracy: divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[5];
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
    const double t0 = params[5]*params[5]; /* I3*I3 */
    out[7] = t0;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*x[3]; /* R*omega_n */
    const double t3 = p[1]*p[5]; /* R*I3 */
    const double t4 = t3*x[0]; /* R*I3*gamma3 */
    const double t5 = x[3]*t3; /* omega_n*R*I3 */
    const double t6 = x[4]*t5; /* s*omega_n*R*I3 */
    const double t7 = t6 - p[6]; /* s*omega_n*R*I3 - G_level */
    const double t8 = t7/t4; /* omega3 = (s*omega_n*R*I3 - G_level)/(R*I3*gamma3) */
    const double t9 = t2*t8; /* R*omega_n*omega3 */
    const double t10 = x[4]*t9; /* s*R*omega_n*omega3 */
    const double t11 = p[1]*x[0]; /* R*gamma3 */
    const double t12 = x[3]*x[3]; /* omega_n*omega_n */
    const double t13 = t11*t12; /* R*gamma3*omega_n*omega_n */
    const double t14 = t10 + t13; /* s*R*omega_n*omega3 + R*gamma3*omega_n*omega_n */
    const double t15 = x[0]*t12; /* gamma3*omega_n*omega_n */
    const double t16 = -t15; /* -gamma3*omega_n*omega_n */
    const double t17 = x[3]*t8; /* omega_n*omega3 */
    const double t18 = x[4]*t17; /* s*omega_n*omega3 */
    const double t19 = t16 - t18; /* -gamma3*omega_n*omega_n - s*omega_n*omega3 */
    const double t20 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t21 = x[3]*t20; /* omega_n*omega_tau*gamma3 */
    const double t22 = p[5]*p[5]; /* I3*I3 */
    const double t23 = x[2]*t22; /* omega_tau*I3*I3 */
    const double t24 = t8*t23; /* omega3*omega_tau*I3*I3 */
    const double t25 = x[4]*t24; /* s*omega3*omega_tau*I3*I3 */
    const double t26 = p[1]*p[1]; /* R*R */
    const double t27 = p[0]*t26; /* m*R*R */
    const double t28 = p[5]*t27; /* I3*m*R*R */
    const double t29 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t30 = t28*t29; /* I3*m*R*R*gamma3*gamma3 */
    const double t31 = t30 + p[7]; /* I3*m*R*R*gamma3*gamma3 + I3^2 */
    const double t32 = t0*t28; /* s*s*I3*m*R*R */
    const double t33 = t31 + t32; /* Theta = I3*m*R*R*gamma3*gamma3 + I3^2 + s*s*I3*m*R*R */
    const double t34 = t25/t33; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t35 = t21 + t34; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta */
    const double t36 = p[1]*p[0]; /* R*m */
    const double t37 = p[5]*t36; /* I3*R*m */
    const double t38 = x[0]*t37; /* gamma3*I3*R*m */
    const double t39 = x[3]*t38; /* omega_n*gamma3*I3*R*m */
    const double t40 = x[2]*p[1]; /* omega_tau*R */
    const double t41 = x[1] + t40; /* V = v_nu + omega_tau*R */
    const double t42 = t39*t41; /* omega_n*gamma3*I3*R*m*V */
    const double t43 = t42/t33; /* omega_n*gamma3*I3*R*m*V/Theta */
    const double t44 = t35 - t43; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/Theta */
    const double t45 = x[2]*t28; /* omega_tau*I3*m*R*R */
    const double t46 = t8*t45; /* omega3*omega_tau*I3*m*R*R */
    const double t47 = x[4]*t46; /* s*omega3*omega_tau*I3*m*R*R */
    const double t48 = t47/t33; /* s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t49 = t44 + t48; /* t44 + s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t50 = x[4]*t20; /* s*omega_tau*gamma3 */
    const double t51 = -t50; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t14;
    out[2] = t19;
    out[3] = t49;
    out[4] = t51;
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
    const double t8 = p[1]*p[5]; /* R*I3 */
    const double t9 = x[3]*t8; /* omega_n*R*I3 */
    const double t10 = x[4]*t9; /* s*omega_n*R*I3 */
    const double t11 = p[6] - t10; /* G_level - s*omega_n*R*I3 */
    const double t12 = t7*t11; /* s*omega_n*(G_level - s*omega_n*R*I3) */
    const double t13 = t12/t6; /* s*omega_n*(G_level - s*omega_n*R*I3)/(I3*gamma3*gamma3) */
    const double t14 = t4 + t13; /* R*omega_n*omega_n + s*omega_n*(G_level - s*omega_n*R*I3)/(I3*gamma3*gamma3) */
    const double t15 = x[0]*t8; /* gamma3*R*I3 */
    const double t16 = t10 - p[6]; /* s*omega_n*R*I3 - G_level */
    const double t17 = t16/t15; /* omega3 = (s*omega_n*R*I3 - G_level)/(gamma3*R*I3) */
    const double t18 = p[1]*t17; /* R*omega3 */
    const double t19 = x[4]*t18; /* s*R*omega3 */
    const double t20 = p[1]*x[0]; /* R*gamma3 */
    const double t21 = x[3]*t20; /* omega_n*R*gamma3 */
    const double t22 = 2.0*t21; /* 2*omega_n*R*gamma3 */
    const double t23 = t19 + t22; /* s*R*omega3 + 2*omega_n*R*gamma3 */
    const double t24 = p[1]*x[3]; /* R*omega_n */
    const double t25 = t0*t24; /* s*s*R*omega_n */
    const double t26 = t25/x[0]; /* s*s*R*omega_n/gamma3 */
    const double t27 = t23 + t26; /* s*R*omega3 + 2*omega_n*R*gamma3 + s*s*R*omega_n/gamma3 */
    const double t28 = t17*t24; /* omega3*R*omega_n */
    const double t29 = x[4]*t4; /* s*R*omega_n*omega_n */
    const double t30 = t29/x[0]; /* s*R*omega_n*omega_n/gamma3 */
    const double t31 = t28 + t30; /* omega3*R*omega_n + s*R*omega_n*omega_n/gamma3 */
    const double t32 = -t3; /* -omega_n*omega_n */
    const double t33 = t5*t8; /* gamma3*gamma3*R*I3 */
    const double t34 = t12/t33; /* s*omega_n*(G_level - s*omega_n*R*I3)/(gamma3*gamma3*R*I3) */
    const double t35 = t32 - t34; /* -omega_n*omega_n - s*omega_n*(G_level - s*omega_n*R*I3)/(gamma3*gamma3*R*I3) */
    const double t36 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t37 = 2.0*t36; /* 2*omega_n*gamma3 */
    const double t38 = -t37; /* -2*omega_n*gamma3 */
    const double t39 = t0*x[3]; /* s*s*omega_n */
    const double t40 = t39/x[0]; /* s*s*omega_n/gamma3 */
    const double t41 = t38 - t40; /* -2*omega_n*gamma3 - s*s*omega_n/gamma3 */
    const double t42 = x[4]*t17; /* s*omega3 */
    const double t43 = t41 - t42; /* -2*omega_n*gamma3 - s*s*omega_n/gamma3 - s*omega3 */
    const double t44 = x[4]*t3; /* s*omega_n*omega_n */
    const double t45 = t44/x[0]; /* s*omega_n*omega_n/gamma3 */
    const double t46 = -t45; /* -s*omega_n*omega_n/gamma3 */
    const double t47 = x[3]*t17; /* omega_n*omega3 */
    const double t48 = t46 - t47; /* -s*omega_n*omega_n/gamma3 - omega_n*omega3 */
    const double t49 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t50 = p[1]*p[0]; /* R*m */
    const double t51 = p[5]*t50; /* I3*R*m */
    const double t52 = x[3]*t51; /* omega_n*I3*R*m */
    const double t53 = p[1]*p[1]; /* R*R */
    const double t54 = p[0]*t53; /* m*R*R */
    const double t55 = p[5]*t54; /* I3*m*R*R */
    const double t56 = t5*t55; /* gamma3*gamma3*I3*m*R*R */
    const double t57 = t56 + p[7]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t58 = t0*t55; /* s*s*I3*m*R*R */
    const double t59 = t57 + t58; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + s*s*I3*m*R*R */
    const double t60 = x[2]*p[1]; /* omega_tau*R */
    const double t61 = x[1] + t60; /* V = v_nu + omega_tau*R */
    const double t62 = t52*t61; /* omega_n*I3*R*m*V */
    const double t63 = t62/t59; /* omega_n*I3*R*m*V/Theta */
    const double t64 = t49 - t63; /* omega_tau*omega_n - omega_n*I3*R*m*V/Theta */
    const double t65 = p[5]*p[5]; /* I3*I3 */
    const double t66 = p[5]*t65; /* I3*I3*I3 */
    const double t67 = t54*t66; /* m*R*R*I3*I3*I3 */
    const double t68 = x[0]*t67; /* gamma3*m*R*R*I3*I3*I3 */
    const double t69 = x[2]*t68; /* omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t70 = t17*t69; /* omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t71 = x[4]*t70; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t72 = t59*t59; /* Theta*Theta */
    const double t73 = t71/t72; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t74 = 2.0*t73; /* 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t75 = t64 - t74; /* omega_tau*omega_n - omega_n*I3*R*m*V/Theta - 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t76 = p[0]*p[0]; /* m*m */
    const double t77 = p[1]*t53; /* R*R*R */
    const double t78 = t76*t77; /* m*m*R*R*R */
    const double t79 = t65*t78; /* I3*I3*m*m*R*R*R */
    const double t80 = t5*t79; /* gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t81 = x[3]*t80; /* omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t82 = t61*t81; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t83 = t82/t72; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t84 = 2.0*t83; /* 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t85 = t75 + t84; /* t75 + 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t86 = t53*t53; /* R*R*R*R */
    const double t87 = t76*t86; /* m*m*R*R*R*R */
    const double t88 = t65*t87; /* I3*I3*m*m*R*R*R*R */
    const double t89 = x[0]*t88; /* gamma3*I3*I3*m*m*R*R*R*R */
    const double t90 = x[2]*t89; /* omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t91 = t17*t90; /* omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t92 = x[4]*t91; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t93 = t92/t72; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t94 = 2.0*t93; /* 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t95 = t85 - t94; /* t85 - 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t96 = p[1]*t5; /* R*gamma3*gamma3 */
    const double t97 = x[2]*p[5]; /* omega_tau*I3 */
    const double t98 = x[4]*t97; /* s*omega_tau*I3 */
    const double t99 = t59*t96; /* Theta*R*gamma3*gamma3 */
    const double t100 = t11*t98; /* (G_level - s*omega_n*R*I3)*s*omega_tau*I3 */
    const double t101 = t100/t99; /* (G_level - s*omega_n*R*I3)*s*omega_tau*I3/(Theta*R*gamma3*gamma3) */
    const double t102 = t95 + t101; /* t95 + t101 */
    const double t103 = x[2]*t50; /* omega_tau*R*m */
    const double t104 = x[4]*t103; /* s*omega_tau*R*m */
    const double t105 = t5*t59; /* gamma3*gamma3*Theta */
    const double t106 = t11*t104; /* (G_level - s*omega_n*R*I3)*s*omega_tau*R*m */
    const double t107 = t106/t105; /* (G_level - s*omega_n*R*I3)*s*omega_tau*R*m/(gamma3*gamma3*Theta) */
    const double t108 = t102 + t107; /* t95 + t101 + t107 */
    const double t109 = x[0]*t51; /* gamma3*I3*R*m */
    const double t110 = x[3]*t109; /* omega_n*gamma3*I3*R*m */
    const double t111 = t110/t59; /* omega_n*gamma3*I3*R*m/Theta */
    const double t112 = -t111; /* -omega_n*gamma3*I3*R*m/Theta */
    const double t113 = t17*t65; /* omega3*I3*I3 */
    const double t114 = x[4]*t113; /* s*omega3*I3*I3 */
    const double t115 = t114/t59; /* s*omega3*I3*I3/Theta */
    const double t116 = t36 + t115; /* omega_n*gamma3 + s*omega3*I3*I3/Theta */
    const double t117 = x[0]*t55; /* gamma3*I3*m*R*R */
    const double t118 = x[3]*t117; /* omega_n*gamma3*I3*m*R*R */
    const double t119 = t118/t59; /* omega_n*gamma3*I3*m*R*R/Theta */
    const double t120 = t116 - t119; /* omega_n*gamma3 + s*omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/Theta */
    const double t121 = t17*t55; /* omega3*I3*m*R*R */
    const double t122 = x[4]*t121; /* s*omega3*I3*m*R*R */
    const double t123 = t122/t59; /* s*omega3*I3*m*R*R/Theta */
    const double t124 = t120 + t123; /* t120 + s*omega3*I3*m*R*R/Theta */
    const double t125 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t126 = t61*t109; /* V*gamma3*I3*R*m */
    const double t127 = t126/t59; /* V*gamma3*I3*R*m/Theta */
    const double t128 = t125 - t127; /* omega_tau*gamma3 - V*gamma3*I3*R*m/Theta */
    const double t129 = x[2]*t65; /* omega_tau*I3*I3 */
    const double t130 = t0*t129; /* s*s*omega_tau*I3*I3 */
    const double t131 = x[0]*t59; /* gamma3*Theta */
    const double t132 = t130/t131; /* s*s*omega_tau*I3*I3/(gamma3*Theta) */
    const double t133 = t128 + t132; /* omega_tau*gamma3 - V*gamma3*I3*R*m/Theta + s*s*omega_tau*I3*I3/(gamma3*Theta) */
    const double t134 = x[2]*t55; /* omega_tau*I3*m*R*R */
    const double t135 = t0*t134; /* s*s*omega_tau*I3*m*R*R */
    const double t136 = t135/t131; /* s*s*omega_tau*I3*m*R*R/(gamma3*Theta) */
    const double t137 = t133 + t136; /* t133 + s*s*omega_tau*I3*m*R*R/(gamma3*Theta) */
    const double t138 = t17*t129; /* omega3*omega_tau*I3*I3 */
    const double t139 = t138/t59; /* omega3*omega_tau*I3*I3/Theta */
    const double t140 = t17*t134; /* omega3*omega_tau*I3*m*R*R */
    const double t141 = t140/t59; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t142 = t139 + t141; /* omega3*omega_tau*I3*I3/Theta + omega3*omega_tau*I3*m*R*R/Theta */
    const double t143 = x[2]*t67; /* omega_tau*m*R*R*I3*I3*I3 */
    const double t144 = t17*t143; /* omega3*omega_tau*m*R*R*I3*I3*I3 */
    const double t145 = t0*t144; /* s*s*omega3*omega_tau*m*R*R*I3*I3*I3 */
    const double t146 = t145/t72; /* s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t147 = 2.0*t146; /* 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t148 = t142 - t147; /* t142 - 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t149 = x[0]*t79; /* gamma3*I3*I3*m*m*R*R*R */
    const double t150 = x[3]*t149; /* omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t151 = x[4]*t150; /* s*omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t152 = t61*t151; /* V*s*omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t153 = t152/t72; /* V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t154 = 2.0*t153; /* 2*V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t155 = t148 + t154; /* t142 - 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) + 2*V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t156 = x[2]*t88; /* omega_tau*I3*I3*m*m*R*R*R*R */
    const double t157 = t17*t156; /* omega3*omega_tau*I3*I3*m*m*R*R*R*R */
    const double t158 = t0*t157; /* s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R */
    const double t159 = t158/t72; /* s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t160 = 2.0*t159; /* 2*s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t161 = t155 - t160; /* t155 - 2*s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t162 = x[3]*t129; /* omega_n*omega_tau*I3*I3 */
    const double t163 = x[4]*t162; /* s*omega_n*omega_tau*I3*I3 */
    const double t164 = t163/t131; /* s*omega_n*omega_tau*I3*I3/(gamma3*Theta) */
    const double t165 = t161 + t164; /* t161 + s*omega_n*omega_tau*I3*I3/(gamma3*Theta) */
    const double t166 = x[3]*t134; /* omega_n*omega_tau*I3*m*R*R */
    const double t167 = x[4]*t166; /* s*omega_n*omega_tau*I3*m*R*R */
    const double t168 = t167/t131; /* s*omega_n*omega_tau*I3*m*R*R/(gamma3*Theta) */
    const double t169 = t165 + t168; /* t161 + s*omega_n*omega_tau*I3*I3/(gamma3*Theta) + s*omega_n*omega_tau*I3*m*R*R/(gamma3*Theta) */
    const double t170 = x[4]*x[2]; /* s*omega_tau */
    const double t171 = -t170; /* -s*omega_tau */
    const double t172 = x[4]*x[0]; /* s*gamma3 */
    const double t173 = -t172; /* -s*gamma3 */
    const double t174 = -t125; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t14;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t27;
    out[9] = t31;
    out[10] = t35;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t43;
    out[14] = t48;
    out[15] = t108;
    out[16] = t112;
    out[17] = t124;
    out[18] = t137;
    out[19] = t169;
    out[20] = t171;
    out[21] = 0.0;
    out[22] = t173;
    out[23] = 0.0;
    out[24] = t174;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*x[3]; /* R*omega_n */
    const double t3 = p[1]*p[5]; /* R*I3 */
    const double t4 = t3*x[0]; /* R*I3*gamma3 */
    const double t5 = x[3]*t3; /* omega_n*R*I3 */
    const double t6 = x[4]*t5; /* s*omega_n*R*I3 */
    const double t7 = p[6] - t6; /* G_level - s*omega_n*R*I3 */
    const double t8 = t6 - p[6]; /* s*omega_n*R*I3 - G_level */
    const double t9 = t8/t4; /* omega3 = (s*omega_n*R*I3 - G_level)/(R*I3*gamma3) */
    const double t10 = t2*t9; /* R*omega_n*omega3 */
    const double t11 = x[4]*t10; /* s*R*omega_n*omega3 */
    const double t12 = p[1]*x[0]; /* R*gamma3 */
    const double t13 = x[3]*x[3]; /* omega_n*omega_n */
    const double t14 = t12*t13; /* R*gamma3*omega_n*omega_n */
    const double t15 = t11 + t14; /* s*R*omega_n*omega3 + R*gamma3*omega_n*omega_n */
    const double t16 = x[0]*t13; /* gamma3*omega_n*omega_n */
    const double t17 = -t16; /* -gamma3*omega_n*omega_n */
    const double t18 = x[3]*t9; /* omega_n*omega3 */
    const double t19 = x[4]*t18; /* s*omega_n*omega3 */
    const double t20 = t17 - t19; /* -gamma3*omega_n*omega_n - s*omega_n*omega3 */
    const double t21 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t22 = x[3]*t21; /* omega_n*omega_tau*gamma3 */
    const double t23 = p[5]*p[5]; /* I3*I3 */
    const double t24 = x[2]*t23; /* omega_tau*I3*I3 */
    const double t25 = t9*t24; /* omega3*omega_tau*I3*I3 */
    const double t26 = x[4]*t25; /* s*omega3*omega_tau*I3*I3 */
    const double t27 = p[1]*p[1]; /* R*R */
    const double t28 = p[0]*t27; /* m*R*R */
    const double t29 = p[5]*t28; /* I3*m*R*R */
    const double t30 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t31 = t29*t30; /* I3*m*R*R*gamma3*gamma3 */
    const double t32 = t31 + p[7]; /* I3*m*R*R*gamma3*gamma3 + I3^2 */
    const double t33 = t0*t29; /* s*s*I3*m*R*R */
    const double t34 = t32 + t33; /* Theta = I3*m*R*R*gamma3*gamma3 + I3^2 + s*s*I3*m*R*R */
    const double t35 = t26/t34; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t36 = t22 + t35; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta */
    const double t37 = p[1]*p[0]; /* R*m */
    const double t38 = p[5]*t37; /* I3*R*m */
    const double t39 = x[0]*t38; /* gamma3*I3*R*m */
    const double t40 = x[3]*t39; /* omega_n*gamma3*I3*R*m */
    const double t41 = x[2]*p[1]; /* omega_tau*R */
    const double t42 = x[1] + t41; /* V = v_nu + omega_tau*R */
    const double t43 = t40*t42; /* omega_n*gamma3*I3*R*m*V */
    const double t44 = t43/t34; /* omega_n*gamma3*I3*R*m*V/Theta */
    const double t45 = t36 - t44; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/Theta */
    const double t46 = x[2]*t29; /* omega_tau*I3*m*R*R */
    const double t47 = t9*t46; /* omega3*omega_tau*I3*m*R*R */
    const double t48 = x[4]*t47; /* s*omega3*omega_tau*I3*m*R*R */
    const double t49 = t48/t34; /* s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t50 = t45 + t49; /* t45 + s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t51 = -t21; /* -omega_tau*gamma3 */
    const double t52 = x[4]*t21; /* s*omega_tau*gamma3 */
    const double t53 = -t52; /* -s*omega_tau*gamma3 */
    const double t54 = x[2]*2.0; /* omega_tau*2 */
    const double t55 = x[4]*t54; /* s*omega_tau*2 */
    const double t56 = p[1]*t13; /* R*omega_n*omega_n */
    const double t57 = p[5]*t30; /* I3*gamma3*gamma3 */
    const double t58 = x[4]*x[3]; /* s*omega_n */
    const double t59 = t7*t58; /* (G_level - s*omega_n*R*I3)*s*omega_n */
    const double t60 = t59/t57; /* (G_level - s*omega_n*R*I3)*s*omega_n/(I3*gamma3*gamma3) */
    const double t61 = t56 + t60; /* R*omega_n*omega_n + (G_level - s*omega_n*R*I3)*s*omega_n/(I3*gamma3*gamma3) */
    const double t62 = p[1]*t9; /* R*omega3 */
    const double t63 = x[4]*t62; /* s*R*omega3 */
    const double t64 = x[3]*t12; /* omega_n*R*gamma3 */
    const double t65 = 2.0*t64; /* 2*omega_n*R*gamma3 */
    const double t66 = t63 + t65; /* s*R*omega3 + 2*omega_n*R*gamma3 */
    const double t67 = t0*t2; /* s*s*R*omega_n */
    const double t68 = t67/x[0]; /* s*s*R*omega_n/gamma3 */
    const double t69 = t66 + t68; /* s*R*omega3 + 2*omega_n*R*gamma3 + s*s*R*omega_n/gamma3 */
    const double t70 = x[4]*t56; /* s*R*omega_n*omega_n */
    const double t71 = t70/x[0]; /* s*R*omega_n*omega_n/gamma3 */
    const double t72 = t10 + t71; /* R*omega_n*omega3 + s*R*omega_n*omega_n/gamma3 */
    const double t73 = -t13; /* -omega_n*omega_n */
    const double t74 = t3*t30; /* R*I3*gamma3*gamma3 */
    const double t75 = t59/t74; /* (G_level - s*omega_n*R*I3)*s*omega_n/(R*I3*gamma3*gamma3) */
    const double t76 = t73 - t75; /* -omega_n*omega_n - (G_level - s*omega_n*R*I3)*s*omega_n/(R*I3*gamma3*gamma3) */
    const double t77 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t78 = 2.0*t77; /* 2*omega_n*gamma3 */
    const double t79 = -t78; /* -2*omega_n*gamma3 */
    const double t80 = t0*x[3]; /* s*s*omega_n */
    const double t81 = t80/x[0]; /* s*s*omega_n/gamma3 */
    const double t82 = t79 - t81; /* -2*omega_n*gamma3 - s*s*omega_n/gamma3 */
    const double t83 = x[4]*t9; /* s*omega3 */
    const double t84 = t82 - t83; /* -2*omega_n*gamma3 - s*s*omega_n/gamma3 - s*omega3 */
    const double t85 = x[4]*t13; /* s*omega_n*omega_n */
    const double t86 = t85/x[0]; /* s*omega_n*omega_n/gamma3 */
    const double t87 = -t86; /* -s*omega_n*omega_n/gamma3 */
    const double t88 = t87 - t18; /* -s*omega_n*omega_n/gamma3 - omega_n*omega3 */
    const double t89 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t90 = x[3]*t38; /* omega_n*I3*R*m */
    const double t91 = t42*t90; /* V*omega_n*I3*R*m */
    const double t92 = t91/t34; /* V*omega_n*I3*R*m/Theta */
    const double t93 = t89 - t92; /* omega_tau*omega_n - V*omega_n*I3*R*m/Theta */
    const double t94 = p[5]*t23; /* I3*I3*I3 */
    const double t95 = t28*t94; /* m*R*R*I3*I3*I3 */
    const double t96 = x[0]*t95; /* gamma3*m*R*R*I3*I3*I3 */
    const double t97 = x[2]*t96; /* omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t98 = t9*t97; /* omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t99 = x[4]*t98; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t100 = t34*t34; /* Theta*Theta */
    const double t101 = t99/t100; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t102 = 2.0*t101; /* 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t103 = t93 - t102; /* omega_tau*omega_n - V*omega_n*I3*R*m/Theta - 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t104 = p[0]*p[0]; /* m*m */
    const double t105 = p[1]*t27; /* R*R*R */
    const double t106 = t104*t105; /* m*m*R*R*R */
    const double t107 = t23*t106; /* I3*I3*m*m*R*R*R */
    const double t108 = t30*t107; /* gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t109 = x[3]*t108; /* omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t110 = t42*t109; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t111 = t110/t100; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t112 = 2.0*t111; /* 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t113 = t103 + t112; /* t103 + 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t114 = t27*t27; /* R*R*R*R */
    const double t115 = t104*t114; /* m*m*R*R*R*R */
    const double t116 = t23*t115; /* I3*I3*m*m*R*R*R*R */
    const double t117 = x[0]*t116; /* gamma3*I3*I3*m*m*R*R*R*R */
    const double t118 = x[2]*t117; /* omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t119 = t9*t118; /* omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t120 = x[4]*t119; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t121 = t120/t100; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t122 = 2.0*t121; /* 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t123 = t113 - t122; /* t113 - 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t124 = p[1]*t30; /* R*gamma3*gamma3 */
    const double t125 = x[2]*p[5]; /* omega_tau*I3 */
    const double t126 = x[4]*t125; /* s*omega_tau*I3 */
    const double t127 = t34*t124; /* Theta*R*gamma3*gamma3 */
    const double t128 = t7*t126; /* (G_level - s*omega_n*R*I3)*s*omega_tau*I3 */
    const double t129 = t128/t127; /* (G_level - s*omega_n*R*I3)*s*omega_tau*I3/(Theta*R*gamma3*gamma3) */
    const double t130 = t123 + t129; /* t123 + t129 */
    const double t131 = x[2]*t37; /* omega_tau*R*m */
    const double t132 = x[4]*t131; /* s*omega_tau*R*m */
    const double t133 = t30*t34; /* gamma3*gamma3*Theta */
    const double t134 = t7*t132; /* (G_level - s*omega_n*R*I3)*s*omega_tau*R*m */
    const double t135 = t134/t133; /* (G_level - s*omega_n*R*I3)*s*omega_tau*R*m/(gamma3*gamma3*Theta) */
    const double t136 = t130 + t135; /* t123 + t129 + t135 */
    const double t137 = t40/t34; /* omega_n*gamma3*I3*R*m/Theta */
    const double t138 = -t137; /* -omega_n*gamma3*I3*R*m/Theta */
    const double t139 = t9*t23; /* omega3*I3*I3 */
    const double t140 = x[4]*t139; /* s*omega3*I3*I3 */
    const double t141 = t140/t34; /* s*omega3*I3*I3/Theta */
    const double t142 = t77 + t141; /* omega_n*gamma3 + s*omega3*I3*I3/Theta */
    const double t143 = x[0]*t29; /* gamma3*I3*m*R*R */
    const double t144 = x[3]*t143; /* omega_n*gamma3*I3*m*R*R */
    const double t145 = t144/t34; /* omega_n*gamma3*I3*m*R*R/Theta */
    const double t146 = t142 - t145; /* omega_n*gamma3 + s*omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/Theta */
    const double t147 = t9*t29; /* omega3*I3*m*R*R */
    const double t148 = x[4]*t147; /* s*omega3*I3*m*R*R */
    const double t149 = t148/t34; /* s*omega3*I3*m*R*R/Theta */
    const double t150 = t146 + t149; /* t146 + s*omega3*I3*m*R*R/Theta */
    const double t151 = t39*t42; /* gamma3*I3*R*m*V */
    const double t152 = t151/t34; /* gamma3*I3*R*m*V/Theta */
    const double t153 = t21 - t152; /* omega_tau*gamma3 - gamma3*I3*R*m*V/Theta */
    const double t154 = t0*t24; /* s*s*omega_tau*I3*I3 */
    const double t155 = x[0]*t34; /* gamma3*Theta */
    const double t156 = t154/t155; /* s*s*omega_tau*I3*I3/(gamma3*Theta) */
    const double t157 = t153 + t156; /* omega_tau*gamma3 - gamma3*I3*R*m*V/Theta + s*s*omega_tau*I3*I3/(gamma3*Theta) */
    const double t158 = t0*t46; /* s*s*omega_tau*I3*m*R*R */
    const double t159 = t158/t155; /* s*s*omega_tau*I3*m*R*R/(gamma3*Theta) */
    const double t160 = t157 + t159; /* t157 + s*s*omega_tau*I3*m*R*R/(gamma3*Theta) */
    const double t161 = t25/t34; /* omega3*omega_tau*I3*I3/Theta */
    const double t162 = t47/t34; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t163 = t161 + t162; /* omega3*omega_tau*I3*I3/Theta + omega3*omega_tau*I3*m*R*R/Theta */
    const double t164 = x[2]*t95; /* omega_tau*m*R*R*I3*I3*I3 */
    const double t165 = t9*t164; /* omega3*omega_tau*m*R*R*I3*I3*I3 */
    const double t166 = t0*t165; /* s*s*omega3*omega_tau*m*R*R*I3*I3*I3 */
    const double t167 = t166/t100; /* s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t168 = 2.0*t167; /* 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t169 = t163 - t168; /* t163 - 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t170 = x[0]*t107; /* gamma3*I3*I3*m*m*R*R*R */
    const double t171 = x[3]*t170; /* omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t172 = x[4]*t171; /* s*omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t173 = t42*t172; /* V*s*omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t174 = t173/t100; /* V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t175 = 2.0*t174; /* 2*V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t176 = t169 + t175; /* t163 - 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) + 2*V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t177 = x[2]*t116; /* omega_tau*I3*I3*m*m*R*R*R*R */
    const double t178 = t9*t177; /* omega3*omega_tau*I3*I3*m*m*R*R*R*R */
    const double t179 = t0*t178; /* s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R */
    const double t180 = t179/t100; /* s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t181 = 2.0*t180; /* 2*s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t182 = t176 - t181; /* t176 - 2*s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t183 = x[3]*t24; /* omega_n*omega_tau*I3*I3 */
    const double t184 = x[4]*t183; /* s*omega_n*omega_tau*I3*I3 */
    const double t185 = t184/t155; /* s*omega_n*omega_tau*I3*I3/(gamma3*Theta) */
    const double t186 = t182 + t185; /* t182 + s*omega_n*omega_tau*I3*I3/(gamma3*Theta) */
    const double t187 = x[3]*t46; /* omega_n*omega_tau*I3*m*R*R */
    const double t188 = x[4]*t187; /* s*omega_n*omega_tau*I3*m*R*R */
    const double t189 = t188/t155; /* s*omega_n*omega_tau*I3*m*R*R/(gamma3*Theta) */
    const double t190 = t186 + t189; /* t182 + s*omega_n*omega_tau*I3*I3/(gamma3*Theta) + s*omega_n*omega_tau*I3*m*R*R/(gamma3*Theta) */
    const double t191 = x[2]*x[4]; /* omega_tau*s */
    const double t192 = -t191; /* -omega_tau*s */
    const double t193 = x[4]*x[0]; /* s*gamma3 */
    const double t194 = -t193; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t15;
    out[2] = t20;
    out[3] = t50;
    out[4] = t53;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t55;
    out[10] = t61;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t69;
    out[14] = t72;
    out[15] = t76;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t84;
    out[19] = t88;
    out[20] = t136;
    out[21] = t138;
    out[22] = t150;
    out[23] = t160;
    out[24] = t190;
    out[25] = t192;
    out[26] = 0.0;
    out[27] = t194;
    out[28] = 0.0;
    out[29] = t51;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[1]; /* m*R */
    const double t1 = t0*p[5]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = p[1]*p[1]; /* R*R */
    const double t4 = p[0]*t3; /* m*R*R */
    const double t5 = p[5]*t4; /* I3*m*R*R */
    const double t6 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t7 = t5*t6; /* I3*m*R*R*gamma3*gamma3 */
    const double t8 = t7 + p[7]; /* I3*m*R*R*gamma3*gamma3 + I3^2 */
    const double t9 = x[4]*x[4]; /* s*s */
    const double t10 = t5*t9; /* I3*m*R*R*s*s */
    const double t11 = t8 + t10; /* Theta = I3*m*R*R*gamma3*gamma3 + I3^2 + I3*m*R*R*s*s */
    const double t12 = p[1]*x[2]; /* R*omega_tau */
    const double t13 = x[1] + t12; /* V = v_nu + R*omega_tau */
    const double t14 = t2*t13; /* m*R*I3*gamma3*V */
    const double t15 = t14/t11; /* m*R*I3*gamma3*V/Theta */
    const double t16 = p[5]*p[5]; /* I3*I3 */
    const double t17 = x[2]*t16; /* omega_tau*I3*I3 */
    const double t18 = t9*t17; /* s*s*omega_tau*I3*I3 */
    const double t19 = x[0]*t11; /* gamma3*Theta */
    const double t20 = t18/t19; /* s*s*omega_tau*I3*I3/(gamma3*Theta) */
    const double t21 = t20 - t15; /* s*s*omega_tau*I3*I3/(gamma3*Theta) - m*R*I3*gamma3*V/Theta */
    const double t22 = t5*x[2]; /* I3*m*R*R*omega_tau */
    const double t23 = t9*t22; /* s*s*I3*m*R*R*omega_tau */
    const double t24 = t23/t19; /* s*s*I3*m*R*R*omega_tau/(gamma3*Theta) */
    const double t25 = t21 + t24; /* s*s*omega_tau*I3*I3/(gamma3*Theta) - m*R*I3*gamma3*V/Theta + s*s*I3*m*R*R*omega_tau/(gamma3*Theta) */
    out[0] = t25;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[0]*t0; /* m*v_nu*v_nu */
    const double t2 = t1*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t3 = p[5]*p[1]; /* I3*R */
    const double t4 = t3*x[0]; /* I3*R*gamma3 */
    const double t5 = t3*x[3]; /* I3*R*omega_n */
    const double t6 = t5*x[4]; /* I3*R*omega_n*s */
    const double t7 = t6 - p[6]; /* I3*R*omega_n*s - G_level */
    const double t8 = t7/t4; /* omega3 = (I3*R*omega_n*s - G_level)/(I3*R*gamma3) */
    const double t9 = t8*t8; /* omega3*omega3 */
    const double t10 = p[5]*t9; /* I3*omega3*omega3 */
    const double t11 = (1.0 / 2.0)*t10; /* 1/2*I3*omega3*omega3 */
    const double t12 = t2 + t11; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 */
    const double t13 = p[1]*t8; /* R*omega3 */
    const double t14 = x[4]*t13; /* s*R*omega3 */
    const double t15 = p[1]*x[0]; /* R*gamma3 */
    const double t16 = x[3]*t15; /* omega_n*R*gamma3 */
    const double t17 = t14 + t16; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t18 = t17*t17; /* v_tau*v_tau */
    const double t19 = p[0]*t18; /* m*v_tau*v_tau */
    const double t20 = (1.0 / 2.0)*t19; /* 1/2*m*v_tau*v_tau */
    const double t21 = t12 + t20; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    const double t22 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t23 = p[5]*t22; /* I3*omega_tau*omega_tau */
    const double t24 = (1.0 / 2.0)*t23; /* 1/2*I3*omega_tau*omega_tau */
    const double t25 = t21 + t24; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau + 1/2*I3*omega_tau*omega_tau */
    const double t26 = x[3]*x[3]; /* omega_n*omega_n */
    const double t27 = p[5]*t26; /* I3*omega_n*omega_n */
    const double t28 = (1.0 / 2.0)*t27; /* 1/2*I3*omega_n*omega_n */
    const double t29 = t25 + t28; /* energy = t25 + 1/2*I3*omega_n*omega_n */
    const double t30 = p[5]*p[5]; /* I3*I3 */
    const double t31 = p[0]*t30; /* m*I3*I3 */
    const double t32 = p[1]*x[2]; /* R*omega_tau */
    const double t33 = x[1] + t32; /* v_nu + R*omega_tau */
    const double t34 = t33*t33; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t35 = t31*t34; /* m*I3*I3*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    out[0] = t29;
    out[1] = t35;
    out[2] = t33;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[5]; /* R*I3 */
    const double t1 = t0*x[0]; /* R*I3*gamma3 */
    const double t2 = t0*x[3]; /* R*I3*omega_n */
    const double t3 = t2*x[4]; /* R*I3*omega_n*s */
    const double t4 = p[6] - t3; /* G_level - R*I3*omega_n*s */
    const double t5 = t3 - p[6]; /* R*I3*omega_n*s - G_level */
    const double t6 = t5/t1; /* omega3 = (R*I3*omega_n*s - G_level)/(R*I3*gamma3) */
    const double t7 = p[1]*t6; /* R*omega3 */
    const double t8 = x[4]*t7; /* s*R*omega3 */
    const double t9 = p[1]*x[0]; /* R*gamma3 */
    const double t10 = x[3]*t9; /* omega_n*R*gamma3 */
    const double t11 = t8 + t10; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t12 = p[0]*t11; /* m*v_tau */
    const double t13 = p[1]*x[3]; /* R*omega_n */
    const double t14 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t15 = p[5]*t14; /* I3*gamma3*gamma3 */
    const double t16 = x[4]*t4; /* s*(G_level - R*I3*omega_n*s) */
    const double t17 = t16/t15; /* s*(G_level - R*I3*omega_n*s)/(I3*gamma3*gamma3) */
    const double t18 = t13 + t17; /* d(v_tau)/d(gamma3) = R*omega_n + s*(G_level - R*I3*omega_n*s)/(I3*gamma3*gamma3) */
    const double t19 = t12*t18; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t20 = p[1]*t14; /* R*gamma3*gamma3 */
    const double t21 = t4*t6; /* (G_level - R*I3*omega_n*s)*omega3 */
    const double t22 = t21/t20; /* (G_level - R*I3*omega_n*s)*omega3/(R*gamma3*gamma3) */
    const double t23 = t19 + t22; /* d(energy)/d(gamma3) = m*v_tau*d(v_tau)/d(gamma3) + (G_level - R*I3*omega_n*s)*omega3/(R*gamma3*gamma3) */
    const double t24 = p[0]*x[1]; /* m*v_nu */
    const double t25 = p[5]*x[2]; /* I3*omega_tau */
    const double t26 = x[4]*x[4]; /* s*s */
    const double t27 = p[1]*t26; /* R*s*s */
    const double t28 = t27/x[0]; /* R*s*s/gamma3 */
    const double t29 = t9 + t28; /* d(v_tau)/d(omega_n) = R*gamma3 + R*s*s/gamma3 */
    const double t30 = t12*t29; /* m*v_tau*d(v_tau)/d(omega_n) */
    const double t31 = p[5]*x[3]; /* I3*omega_n */
    const double t32 = t30 + t31; /* m*v_tau*d(v_tau)/d(omega_n) + I3*omega_n */
    const double t33 = p[5]*t6; /* I3*omega3 */
    const double t34 = x[4]*t33; /* s*I3*omega3 */
    const double t35 = t34/x[0]; /* s*I3*omega3/gamma3 */
    const double t36 = t32 + t35; /* d(energy)/d(omega_n) = m*v_tau*d(v_tau)/d(omega_n) + I3*omega_n + s*I3*omega3/gamma3 */
    const double t37 = x[4]*t13; /* s*R*omega_n */
    const double t38 = t37/x[0]; /* s*R*omega_n/gamma3 */
    const double t39 = t7 + t38; /* d(v_tau)/d(s) = R*omega3 + s*R*omega_n/gamma3 */
    const double t40 = t12*t39; /* m*v_tau*d(v_tau)/d(s) */
    const double t41 = t6*t31; /* omega3*I3*omega_n */
    const double t42 = t41/x[0]; /* omega3*I3*omega_n/gamma3 */
    const double t43 = t40 + t42; /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) + omega3*I3*omega_n/gamma3 */
    const double t44 = p[0]*2.0; /* m*2 */
    const double t45 = p[5]*p[5]; /* I3*I3 */
    const double t46 = t44*t45; /* m*2*I3*I3 */
    const double t47 = p[1]*x[2]; /* R*omega_tau */
    const double t48 = x[1] + t47; /* v_nu + R*omega_tau */
    const double t49 = t46*t48; /* m*2*I3*I3*(v_nu + R*omega_tau) */
    const double t50 = p[1]*t44; /* R*m*2 */
    const double t51 = t45*t50; /* I3*I3*R*m*2 */
    const double t52 = t48*t51; /* (v_nu + R*omega_tau)*I3*I3*R*m*2 */
    out[0] = t23;
    out[1] = t24;
    out[2] = t25;
    out[3] = t36;
    out[4] = t43;
    out[5] = 0.0;
    out[6] = t49;
    out[7] = t52;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 1.0;
    out[12] = p[1];
    out[13] = 0.0;
    out[14] = 0.0;
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
    const double t2 = t0*x[3]; /* R*I3*omega_n */
    const double t3 = t2*x[4]; /* R*I3*omega_n*s */
    const double t4 = t3 - p[6]; /* R*I3*omega_n*s - G_level */
    const double t5 = t4/t1; /* omega3 = (R*I3*omega_n*s - G_level)/(R*I3*gamma3) */
    out[0] = t5;
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
    const double v_I1 = (v_I3);
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
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "regular",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 8,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 11, 37, 0, 4, 0, 0, 11, 8 }, { 11, 48, 0, 4, 0, 0, 11, 7 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .jacobian = { jacobian, 25, { 38, 110, 0, 27, 0, 0, 14, 19 }, { 41, 210, 0, 27, 0, 0, 14, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 45, 120, 0, 30, 0, 0, 14, 29 }, { 48, 241, 0, 30, 0, 0, 14, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .divergence = { divergence, 1, { 5, 18, 0, 3, 0, 0, 10, 6 }, { 5, 28, 0, 3, 0, 0, 10, 5 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .integral_values = { integral_values, 3, { 7, 28, 0, 1, 0, 0, 14, 4 }, { 8, 30, 0, 1, 0, 0, 14, 4 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 15, { 11, 35, 0, 7, 0, 0, 12, 10 }, { 13, 52, 0, 7, 0, 0, 12, 7 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 1, 4, 0, 1, 0, 0, 5, 3 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_omega3_avx512,
    },
};
