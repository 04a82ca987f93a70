/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 11   36    0    4    0    0     10    8   (63)
 *  jacobian            30  102    0   21    0    0     12   20   (242)
 *  rhs_jacobian        38  113    0   25    0    0     12   25   (290)
 *  divergence          4   12    0    1    0    0      8    5   (21)
 *  integral_values     7   29    0    0    0    0      9    4   (39)
 *  integral_gradients  6   30    0    0    0    0      5    5   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[5];
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
    const double t0 = params[5]*params[5]; /* I3*I3 */
    out[6] = t0;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*x[3]; /* R*omega_n */
    const double t3 = t2*x[4]; /* R*omega_n*omega3 */
    const double t4 = x[5]*t3; /* s*R*omega_n*omega3 */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = x[3]*x[3]; /* omega_n*omega_n */
    const double t7 = t5*t6; /* R*gamma3*omega_n*omega_n */
    const double t8 = t4 + t7; /* s*R*omega_n*omega3 + R*gamma3*omega_n*omega_n */
    const double t9 = x[0]*t6; /* gamma3*omega_n*omega_n */
    const double t10 = -t9; /* -gamma3*omega_n*omega_n */
    const double t11 = x[3]*x[4]; /* omega_n*omega3 */
    const double t12 = x[5]*t11; /* s*omega_n*omega3 */
    const double t13 = t10 - t12; /* -gamma3*omega_n*omega_n - s*omega_n*omega3 */
    const double t14 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t15 = x[3]*t14; /* omega_n*omega_tau*gamma3 */
    const double t16 = p[5]*p[5]; /* I3*I3 */
    const double t17 = x[2]*t16; /* omega_tau*I3*I3 */
    const double t18 = x[4]*t17; /* omega3*omega_tau*I3*I3 */
    const double t19 = x[5]*t18; /* s*omega3*omega_tau*I3*I3 */
    const double t20 = p[1]*p[1]; /* R*R */
    const double t21 = p[0]*t20; /* m*R*R */
    const double t22 = p[5]*t21; /* I3*m*R*R */
    const double t23 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t24 = t22*t23; /* I3*m*R*R*gamma3*gamma3 */
    const double t25 = t24 + p[6]; /* I3*m*R*R*gamma3*gamma3 + I3^2 */
    const double t26 = t0*t22; /* s*s*I3*m*R*R */
    const double t27 = t25 + t26; /* Theta = I3*m*R*R*gamma3*gamma3 + I3^2 + s*s*I3*m*R*R */
    const double t28 = t19/t27; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t29 = t15 + t28; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta */
    const double t30 = p[1]*p[0]; /* R*m */
    const double t31 = p[5]*t30; /* I3*R*m */
    const double t32 = x[0]*t31; /* gamma3*I3*R*m */
    const double t33 = x[3]*t32; /* omega_n*gamma3*I3*R*m */
    const double t34 = x[2]*p[1]; /* omega_tau*R */
    const double t35 = x[1] + t34; /* V = v_nu + omega_tau*R */
    const double t36 = t33*t35; /* omega_n*gamma3*I3*R*m*V */
    const double t37 = t36/t27; /* omega_n*gamma3*I3*R*m*V/Theta */
    const double t38 = t29 - t37; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/Theta */
    const double t39 = x[2]*t22; /* omega_tau*I3*m*R*R */
    const double t40 = x[4]*t39; /* omega3*omega_tau*I3*m*R*R */
    const double t41 = x[5]*t40; /* s*omega3*omega_tau*I3*m*R*R */
    const double t42 = t41/t27; /* s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t43 = t38 + t42; /* t38 + s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t44 = x[3]*t31; /* omega_n*I3*R*m */
    const double t45 = x[5]*t44; /* s*omega_n*I3*R*m */
    const double t46 = t35*t45; /* V*s*omega_n*I3*R*m */
    const double t47 = t46/t27; /* V*s*omega_n*I3*R*m/Theta */
    const double t48 = -t47; /* -V*s*omega_n*I3*R*m/Theta */
    const double t49 = x[5]*t14; /* s*omega_tau*gamma3 */
    const double t50 = -t49; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t8;
    out[2] = t13;
    out[3] = t43;
    out[4] = t48;
    out[5] = t50;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[5]*t1; /* s*2*omega_tau */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = p[1]*x[4]; /* R*omega3 */
    const double t6 = x[5]*t5; /* s*R*omega3 */
    const double t7 = p[1]*x[0]; /* R*gamma3 */
    const double t8 = x[3]*t7; /* omega_n*R*gamma3 */
    const double t9 = 2.0*t8; /* 2*omega_n*R*gamma3 */
    const double t10 = t6 + t9; /* s*R*omega3 + 2*omega_n*R*gamma3 */
    const double t11 = p[1]*x[3]; /* R*omega_n */
    const double t12 = x[5]*t11; /* s*R*omega_n */
    const double t13 = x[4]*t11; /* omega3*R*omega_n */
    const double t14 = -t3; /* -omega_n*omega_n */
    const double t15 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t16 = 2.0*t15; /* 2*omega_n*gamma3 */
    const double t17 = -t16; /* -2*omega_n*gamma3 */
    const double t18 = x[5]*x[4]; /* s*omega3 */
    const double t19 = t17 - t18; /* -2*omega_n*gamma3 - s*omega3 */
    const double t20 = x[5]*x[3]; /* s*omega_n */
    const double t21 = -t20; /* -s*omega_n */
    const double t22 = x[3]*x[4]; /* omega_n*omega3 */
    const double t23 = -t22; /* -omega_n*omega3 */
    const double t24 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t25 = p[1]*p[0]; /* R*m */
    const double t26 = t25*p[5]; /* R*m*I3 */
    const double t27 = x[3]*t26; /* omega_n*R*m*I3 */
    const double t28 = p[1]*p[1]; /* R*R */
    const double t29 = p[0]*t28; /* m*R*R */
    const double t30 = p[5]*t29; /* I3*m*R*R */
    const double t31 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t32 = t30*t31; /* I3*m*R*R*gamma3*gamma3 */
    const double t33 = t32 + p[6]; /* I3*m*R*R*gamma3*gamma3 + I3^2 */
    const double t34 = t0*t30; /* s*s*I3*m*R*R */
    const double t35 = t33 + t34; /* Theta = I3*m*R*R*gamma3*gamma3 + I3^2 + s*s*I3*m*R*R */
    const double t36 = x[2]*p[1]; /* omega_tau*R */
    const double t37 = x[1] + t36; /* V = v_nu + omega_tau*R */
    const double t38 = t27*t37; /* omega_n*R*m*I3*V */
    const double t39 = t38/t35; /* omega_n*R*m*I3*V/Theta */
    const double t40 = t24 - t39; /* omega_tau*omega_n - omega_n*R*m*I3*V/Theta */
    const double t41 = p[5]*p[5]; /* I3*I3 */
    const double t42 = p[5]*t41; /* I3*I3*I3 */
    const double t43 = t29*t42; /* m*R*R*I3*I3*I3 */
    const double t44 = x[0]*t43; /* gamma3*m*R*R*I3*I3*I3 */
    const double t45 = x[2]*t44; /* omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t46 = x[4]*t45; /* omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t47 = x[5]*t46; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t48 = t35*t35; /* Theta*Theta */
    const double t49 = t47/t48; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t50 = 2.0*t49; /* 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t51 = t40 - t50; /* omega_tau*omega_n - omega_n*R*m*I3*V/Theta - 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t52 = p[0]*p[0]; /* m*m */
    const double t53 = p[1]*t28; /* R*R*R */
    const double t54 = t52*t53; /* m*m*R*R*R */
    const double t55 = t41*t54; /* I3*I3*m*m*R*R*R */
    const double t56 = t31*t55; /* gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t57 = x[3]*t56; /* omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t58 = t37*t57; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t59 = t58/t48; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t60 = 2.0*t59; /* 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t61 = t51 + t60; /* t51 + 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t62 = t28*t28; /* R*R*R*R */
    const double t63 = t52*t62; /* m*m*R*R*R*R */
    const double t64 = t41*t63; /* I3*I3*m*m*R*R*R*R */
    const double t65 = x[0]*t64; /* gamma3*I3*I3*m*m*R*R*R*R */
    const double t66 = x[2]*t65; /* omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t67 = x[4]*t66; /* omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t68 = x[5]*t67; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t69 = t68/t48; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t70 = 2.0*t69; /* 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t71 = t61 - t70; /* t61 - 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t72 = x[0]*t26; /* gamma3*R*m*I3 */
    const double t73 = x[3]*t72; /* omega_n*gamma3*R*m*I3 */
    const double t74 = t73/t35; /* omega_n*gamma3*R*m*I3/Theta */
    const double t75 = -t74; /* -omega_n*gamma3*R*m*I3/Theta */
    const double t76 = x[4]*t41; /* omega3*I3*I3 */
    const double t77 = x[5]*t76; /* s*omega3*I3*I3 */
    const double t78 = t77/t35; /* s*omega3*I3*I3/Theta */
    const double t79 = t15 + t78; /* omega_n*gamma3 + s*omega3*I3*I3/Theta */
    const double t80 = x[0]*t30; /* gamma3*I3*m*R*R */
    const double t81 = x[3]*t80; /* omega_n*gamma3*I3*m*R*R */
    const double t82 = t81/t35; /* omega_n*gamma3*I3*m*R*R/Theta */
    const double t83 = t79 - t82; /* omega_n*gamma3 + s*omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/Theta */
    const double t84 = x[4]*t30; /* omega3*I3*m*R*R */
    const double t85 = x[5]*t84; /* s*omega3*I3*m*R*R */
    const double t86 = t85/t35; /* s*omega3*I3*m*R*R/Theta */
    const double t87 = t83 + t86; /* t83 + s*omega3*I3*m*R*R/Theta */
    const double t88 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t89 = t37*t72; /* V*gamma3*R*m*I3 */
    const double t90 = t89/t35; /* V*gamma3*R*m*I3/Theta */
    const double t91 = t88 - t90; /* omega_tau*gamma3 - V*gamma3*R*m*I3/Theta */
    const double t92 = x[2]*t41; /* omega_tau*I3*I3 */
    const double t93 = x[5]*t92; /* s*omega_tau*I3*I3 */
    const double t94 = t93/t35; /* s*omega_tau*I3*I3/Theta */
    const double t95 = x[2]*t30; /* omega_tau*I3*m*R*R */
    const double t96 = x[5]*t95; /* s*omega_tau*I3*m*R*R */
    const double t97 = t96/t35; /* s*omega_tau*I3*m*R*R/Theta */
    const double t98 = t94 + t97; /* s*omega_tau*I3*I3/Theta + s*omega_tau*I3*m*R*R/Theta */
    const double t99 = x[4]*t92; /* omega3*omega_tau*I3*I3 */
    const double t100 = t99/t35; /* omega3*omega_tau*I3*I3/Theta */
    const double t101 = x[4]*t95; /* omega3*omega_tau*I3*m*R*R */
    const double t102 = t101/t35; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t103 = t100 + t102; /* omega3*omega_tau*I3*I3/Theta + omega3*omega_tau*I3*m*R*R/Theta */
    const double t104 = x[2]*t43; /* omega_tau*m*R*R*I3*I3*I3 */
    const double t105 = x[4]*t104; /* omega3*omega_tau*m*R*R*I3*I3*I3 */
    const double t106 = t0*t105; /* s*s*omega3*omega_tau*m*R*R*I3*I3*I3 */
    const double t107 = t106/t48; /* s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t108 = 2.0*t107; /* 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t109 = t103 - t108; /* t103 - 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t110 = x[0]*t55; /* gamma3*I3*I3*m*m*R*R*R */
    const double t111 = x[3]*t110; /* omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t112 = x[5]*t111; /* s*omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t113 = t37*t112; /* V*s*omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t114 = t113/t48; /* V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t115 = 2.0*t114; /* 2*V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t116 = t109 + t115; /* t103 - 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) + 2*V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t117 = x[2]*t64; /* omega_tau*I3*I3*m*m*R*R*R*R */
    const double t118 = x[4]*t117; /* omega3*omega_tau*I3*I3*m*m*R*R*R*R */
    const double t119 = t0*t118; /* s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R */
    const double t120 = t119/t48; /* s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t121 = 2.0*t120; /* 2*s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t122 = t116 - t121; /* t116 - 2*s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t123 = 2.0*t52; /* 2*m*m */
    const double t124 = t53*t123; /* R*R*R*2*m*m */
    const double t125 = t41*t124; /* I3*I3*R*R*R*2*m*m */
    const double t126 = x[0]*t125; /* gamma3*I3*I3*R*R*R*2*m*m */
    const double t127 = x[3]*t126; /* omega_n*gamma3*I3*I3*R*R*R*2*m*m */
    const double t128 = x[5]*t127; /* s*omega_n*gamma3*I3*I3*R*R*R*2*m*m */
    const double t129 = t37*t128; /* V*s*omega_n*gamma3*I3*I3*R*R*R*2*m*m */
    const double t130 = t129/t48; /* V*s*omega_n*gamma3*I3*I3*R*R*R*2*m*m/(Theta*Theta) */
    const double t131 = x[5]*t27; /* s*omega_n*R*m*I3 */
    const double t132 = t131/t35; /* s*omega_n*R*m*I3/Theta */
    const double t133 = -t132; /* -s*omega_n*R*m*I3/Theta */
    const double t134 = x[3]*t30; /* omega_n*I3*m*R*R */
    const double t135 = x[5]*t134; /* s*omega_n*I3*m*R*R */
    const double t136 = t135/t35; /* s*omega_n*I3*m*R*R/Theta */
    const double t137 = -t136; /* -s*omega_n*I3*m*R*R/Theta */
    const double t138 = x[5]*t26; /* s*R*m*I3 */
    const double t139 = t37*t138; /* V*s*R*m*I3 */
    const double t140 = t139/t35; /* V*s*R*m*I3/Theta */
    const double t141 = -t140; /* -V*s*R*m*I3/Theta */
    const double t142 = x[3]*t55; /* omega_n*I3*I3*m*m*R*R*R */
    const double t143 = t0*t142; /* s*s*omega_n*I3*I3*m*m*R*R*R */
    const double t144 = t37*t143; /* V*s*s*omega_n*I3*I3*m*m*R*R*R */
    const double t145 = t144/t48; /* V*s*s*omega_n*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t146 = 2.0*t145; /* 2*V*s*s*omega_n*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t147 = t146 - t39; /* 2*V*s*s*omega_n*I3*I3*m*m*R*R*R/(Theta*Theta) - omega_n*R*m*I3*V/Theta */
    const double t148 = x[5]*x[2]; /* s*omega_tau */
    const double t149 = -t148; /* -s*omega_tau */
    const double t150 = x[5]*x[0]; /* s*gamma3 */
    const double t151 = -t150; /* -s*gamma3 */
    const double t152 = -t88; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t2;
    out[6] = t4;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t10;
    out[10] = t12;
    out[11] = t13;
    out[12] = t14;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t19;
    out[16] = t21;
    out[17] = t23;
    out[18] = t71;
    out[19] = t75;
    out[20] = t87;
    out[21] = t91;
    out[22] = t98;
    out[23] = t122;
    out[24] = t130;
    out[25] = t133;
    out[26] = t137;
    out[27] = t141;
    out[28] = 0.0;
    out[29] = t147;
    out[30] = t149;
    out[31] = 0.0;
    out[32] = t151;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = t152;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*x[3]; /* R*omega_n */
    const double t3 = t2*x[4]; /* R*omega_n*omega3 */
    const double t4 = x[5]*t3; /* s*R*omega_n*omega3 */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = x[3]*x[3]; /* omega_n*omega_n */
    const double t7 = t5*t6; /* R*gamma3*omega_n*omega_n */
    const double t8 = t4 + t7; /* s*R*omega_n*omega3 + R*gamma3*omega_n*omega_n */
    const double t9 = x[0]*t6; /* gamma3*omega_n*omega_n */
    const double t10 = -t9; /* -gamma3*omega_n*omega_n */
    const double t11 = x[3]*x[4]; /* omega_n*omega3 */
    const double t12 = x[5]*t11; /* s*omega_n*omega3 */
    const double t13 = t10 - t12; /* -gamma3*omega_n*omega_n - s*omega_n*omega3 */
    const double t14 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t15 = x[3]*t14; /* omega_n*omega_tau*gamma3 */
    const double t16 = p[5]*p[5]; /* I3*I3 */
    const double t17 = x[2]*t16; /* omega_tau*I3*I3 */
    const double t18 = x[4]*t17; /* omega3*omega_tau*I3*I3 */
    const double t19 = x[5]*t18; /* s*omega3*omega_tau*I3*I3 */
    const double t20 = p[1]*p[1]; /* R*R */
    const double t21 = p[0]*t20; /* m*R*R */
    const double t22 = p[5]*t21; /* I3*m*R*R */
    const double t23 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t24 = t22*t23; /* I3*m*R*R*gamma3*gamma3 */
    const double t25 = t24 + p[6]; /* I3*m*R*R*gamma3*gamma3 + I3^2 */
    const double t26 = t0*t22; /* s*s*I3*m*R*R */
    const double t27 = t25 + t26; /* Theta = I3*m*R*R*gamma3*gamma3 + I3^2 + s*s*I3*m*R*R */
    const double t28 = t19/t27; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t29 = t15 + t28; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta */
    const double t30 = p[1]*p[0]; /* R*m */
    const double t31 = p[5]*t30; /* I3*R*m */
    const double t32 = x[0]*t31; /* gamma3*I3*R*m */
    const double t33 = x[3]*t32; /* omega_n*gamma3*I3*R*m */
    const double t34 = x[2]*p[1]; /* omega_tau*R */
    const double t35 = x[1] + t34; /* V = v_nu + omega_tau*R */
    const double t36 = t33*t35; /* omega_n*gamma3*I3*R*m*V */
    const double t37 = t36/t27; /* omega_n*gamma3*I3*R*m*V/Theta */
    const double t38 = t29 - t37; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/Theta */
    const double t39 = x[2]*t22; /* omega_tau*I3*m*R*R */
    const double t40 = x[4]*t39; /* omega3*omega_tau*I3*m*R*R */
    const double t41 = x[5]*t40; /* s*omega3*omega_tau*I3*m*R*R */
    const double t42 = t41/t27; /* s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t43 = t38 + t42; /* t38 + s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t44 = x[3]*t31; /* omega_n*I3*R*m */
    const double t45 = x[5]*t44; /* s*omega_n*I3*R*m */
    const double t46 = t35*t45; /* V*s*omega_n*I3*R*m */
    const double t47 = t46/t27; /* V*s*omega_n*I3*R*m/Theta */
    const double t48 = -t47; /* -V*s*omega_n*I3*R*m/Theta */
    const double t49 = -t14; /* -omega_tau*gamma3 */
    const double t50 = x[5]*t14; /* s*omega_tau*gamma3 */
    const double t51 = -t50; /* -s*omega_tau*gamma3 */
    const double t52 = x[2]*2.0; /* omega_tau*2 */
    const double t53 = x[5]*t52; /* s*omega_tau*2 */
    const double t54 = p[1]*t6; /* R*omega_n*omega_n */
    const double t55 = p[1]*x[4]; /* R*omega3 */
    const double t56 = x[5]*t55; /* s*R*omega3 */
    const double t57 = x[3]*t5; /* omega_n*R*gamma3 */
    const double t58 = 2.0*t57; /* 2*omega_n*R*gamma3 */
    const double t59 = t56 + t58; /* s*R*omega3 + 2*omega_n*R*gamma3 */
    const double t60 = x[5]*t2; /* s*R*omega_n */
    const double t61 = -t6; /* -omega_n*omega_n */
    const double t62 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t63 = 2.0*t62; /* 2*omega_n*gamma3 */
    const double t64 = -t63; /* -2*omega_n*gamma3 */
    const double t65 = x[5]*x[4]; /* s*omega3 */
    const double t66 = t64 - t65; /* -2*omega_n*gamma3 - s*omega3 */
    const double t67 = x[5]*x[3]; /* s*omega_n */
    const double t68 = -t67; /* -s*omega_n */
    const double t69 = -t11; /* -omega_n*omega3 */
    const double t70 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t71 = t35*t44; /* V*omega_n*I3*R*m */
    const double t72 = t71/t27; /* V*omega_n*I3*R*m/Theta */
    const double t73 = t70 - t72; /* omega_tau*omega_n - V*omega_n*I3*R*m/Theta */
    const double t74 = p[5]*t16; /* I3*I3*I3 */
    const double t75 = t21*t74; /* m*R*R*I3*I3*I3 */
    const double t76 = x[0]*t75; /* gamma3*m*R*R*I3*I3*I3 */
    const double t77 = x[2]*t76; /* omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t78 = x[4]*t77; /* omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t79 = x[5]*t78; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t80 = t27*t27; /* Theta*Theta */
    const double t81 = t79/t80; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t82 = 2.0*t81; /* 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t83 = t73 - t82; /* omega_tau*omega_n - V*omega_n*I3*R*m/Theta - 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t84 = p[0]*p[0]; /* m*m */
    const double t85 = p[1]*t20; /* R*R*R */
    const double t86 = t84*t85; /* m*m*R*R*R */
    const double t87 = t16*t86; /* I3*I3*m*m*R*R*R */
    const double t88 = t23*t87; /* gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t89 = x[3]*t88; /* omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t90 = t35*t89; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t91 = t90/t80; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t92 = 2.0*t91; /* 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t93 = t83 + t92; /* t83 + 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t94 = t20*t20; /* R*R*R*R */
    const double t95 = t84*t94; /* m*m*R*R*R*R */
    const double t96 = t16*t95; /* I3*I3*m*m*R*R*R*R */
    const double t97 = x[0]*t96; /* gamma3*I3*I3*m*m*R*R*R*R */
    const double t98 = x[2]*t97; /* omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t99 = x[4]*t98; /* omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t100 = x[5]*t99; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t101 = t100/t80; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t102 = 2.0*t101; /* 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t103 = t93 - t102; /* t93 - 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t104 = t33/t27; /* omega_n*gamma3*I3*R*m/Theta */
    const double t105 = -t104; /* -omega_n*gamma3*I3*R*m/Theta */
    const double t106 = x[4]*t16; /* omega3*I3*I3 */
    const double t107 = x[5]*t106; /* s*omega3*I3*I3 */
    const double t108 = t107/t27; /* s*omega3*I3*I3/Theta */
    const double t109 = t62 + t108; /* omega_n*gamma3 + s*omega3*I3*I3/Theta */
    const double t110 = x[0]*t22; /* gamma3*I3*m*R*R */
    const double t111 = x[3]*t110; /* omega_n*gamma3*I3*m*R*R */
    const double t112 = t111/t27; /* omega_n*gamma3*I3*m*R*R/Theta */
    const double t113 = t109 - t112; /* omega_n*gamma3 + s*omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/Theta */
    const double t114 = x[4]*t22; /* omega3*I3*m*R*R */
    const double t115 = x[5]*t114; /* s*omega3*I3*m*R*R */
    const double t116 = t115/t27; /* s*omega3*I3*m*R*R/Theta */
    const double t117 = t113 + t116; /* t113 + s*omega3*I3*m*R*R/Theta */
    const double t118 = t32*t35; /* gamma3*I3*R*m*V */
    const double t119 = t118/t27; /* gamma3*I3*R*m*V/Theta */
    const double t120 = t14 - t119; /* omega_tau*gamma3 - gamma3*I3*R*m*V/Theta */
    const double t121 = x[5]*t17; /* s*omega_tau*I3*I3 */
    const double t122 = t121/t27; /* s*omega_tau*I3*I3/Theta */
    const double t123 = x[5]*t39; /* s*omega_tau*I3*m*R*R */
    const double t124 = t123/t27; /* s*omega_tau*I3*m*R*R/Theta */
    const double t125 = t122 + t124; /* s*omega_tau*I3*I3/Theta + s*omega_tau*I3*m*R*R/Theta */
    const double t126 = t18/t27; /* omega3*omega_tau*I3*I3/Theta */
    const double t127 = t40/t27; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t128 = t126 + t127; /* omega3*omega_tau*I3*I3/Theta + omega3*omega_tau*I3*m*R*R/Theta */
    const double t129 = x[2]*t75; /* omega_tau*m*R*R*I3*I3*I3 */
    const double t130 = x[4]*t129; /* omega3*omega_tau*m*R*R*I3*I3*I3 */
    const double t131 = t0*t130; /* s*s*omega3*omega_tau*m*R*R*I3*I3*I3 */
    const double t132 = t131/t80; /* s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t133 = 2.0*t132; /* 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t134 = t128 - t133; /* t128 - 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t135 = x[0]*t87; /* gamma3*I3*I3*m*m*R*R*R */
    const double t136 = x[3]*t135; /* omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t137 = x[5]*t136; /* s*omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t138 = t35*t137; /* V*s*omega_n*gamma3*I3*I3*m*m*R*R*R */
    const double t139 = t138/t80; /* V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t140 = 2.0*t139; /* 2*V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t141 = t134 + t140; /* t128 - 2*s*s*omega3*omega_tau*m*R*R*I3*I3*I3/(Theta*Theta) + 2*V*s*omega_n*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t142 = x[2]*t96; /* omega_tau*I3*I3*m*m*R*R*R*R */
    const double t143 = x[4]*t142; /* omega3*omega_tau*I3*I3*m*m*R*R*R*R */
    const double t144 = t0*t143; /* s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R */
    const double t145 = t144/t80; /* s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t146 = 2.0*t145; /* 2*s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t147 = t141 - t146; /* t141 - 2*s*s*omega3*omega_tau*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t148 = 2.0*t84; /* 2*m*m */
    const double t149 = t85*t148; /* R*R*R*2*m*m */
    const double t150 = t16*t149; /* I3*I3*R*R*R*2*m*m */
    const double t151 = x[0]*t150; /* gamma3*I3*I3*R*R*R*2*m*m */
    const double t152 = x[3]*t151; /* omega_n*gamma3*I3*I3*R*R*R*2*m*m */
    const double t153 = x[5]*t152; /* s*omega_n*gamma3*I3*I3*R*R*R*2*m*m */
    const double t154 = t35*t153; /* V*s*omega_n*gamma3*I3*I3*R*R*R*2*m*m */
    const double t155 = t154/t80; /* V*s*omega_n*gamma3*I3*I3*R*R*R*2*m*m/(Theta*Theta) */
    const double t156 = t45/t27; /* s*omega_n*I3*R*m/Theta */
    const double t157 = -t156; /* -s*omega_n*I3*R*m/Theta */
    const double t158 = x[3]*t22; /* omega_n*I3*m*R*R */
    const double t159 = x[5]*t158; /* s*omega_n*I3*m*R*R */
    const double t160 = t159/t27; /* s*omega_n*I3*m*R*R/Theta */
    const double t161 = -t160; /* -s*omega_n*I3*m*R*R/Theta */
    const double t162 = x[5]*t31; /* s*I3*R*m */
    const double t163 = t35*t162; /* V*s*I3*R*m */
    const double t164 = t163/t27; /* V*s*I3*R*m/Theta */
    const double t165 = -t164; /* -V*s*I3*R*m/Theta */
    const double t166 = x[3]*t87; /* omega_n*I3*I3*m*m*R*R*R */
    const double t167 = t0*t166; /* s*s*omega_n*I3*I3*m*m*R*R*R */
    const double t168 = t35*t167; /* V*s*s*omega_n*I3*I3*m*m*R*R*R */
    const double t169 = t168/t80; /* V*s*s*omega_n*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t170 = 2.0*t169; /* 2*V*s*s*omega_n*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t171 = t170 - t72; /* 2*V*s*s*omega_n*I3*I3*m*m*R*R*R/(Theta*Theta) - V*omega_n*I3*R*m/Theta */
    const double t172 = x[2]*x[5]; /* omega_tau*s */
    const double t173 = -t172; /* -omega_tau*s */
    const double t174 = x[5]*x[0]; /* s*gamma3 */
    const double t175 = -t174; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t8;
    out[2] = t13;
    out[3] = t43;
    out[4] = t48;
    out[5] = t51;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t53;
    out[12] = t54;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t59;
    out[16] = t60;
    out[17] = t3;
    out[18] = t61;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = t66;
    out[22] = t68;
    out[23] = t69;
    out[24] = t103;
    out[25] = t105;
    out[26] = t117;
    out[27] = t120;
    out[28] = t125;
    out[29] = t147;
    out[30] = t155;
    out[31] = t157;
    out[32] = t161;
    out[33] = t165;
    out[34] = 0.0;
    out[35] = t171;
    out[36] = t173;
    out[37] = 0.0;
    out[38] = t175;
    out[39] = 0.0;
    out[40] = 0.0;
    out[41] = t49;
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
    const double t8 = t7 + p[6]; /* I3*m*R*R*gamma3*gamma3 + I3^2 */
    const double t9 = x[5]*x[5]; /* s*s */
    const double t10 = t5*t9; /* I3*m*R*R*s*s */
    const double t11 = t8 + t10; /* Theta = I3*m*R*R*gamma3*gamma3 + I3^2 + I3*m*R*R*s*s */
    const double t12 = p[1]*x[2]; /* R*omega_tau */
    const double t13 = x[1] + t12; /* V = v_nu + R*omega_tau */
    const double t14 = t2*t13; /* m*R*I3*gamma3*V */
    const double t15 = t14/t11; /* m*R*I3*gamma3*V/Theta */
    const double t16 = -t15; /* -m*R*I3*gamma3*V/Theta */
    out[0] = t16;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[0]*t0; /* m*v_nu*v_nu */
    const double t2 = t1*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t3 = x[4]*x[4]; /* omega3*omega3 */
    const double t4 = p[5]*t3; /* I3*omega3*omega3 */
    const double t5 = (1.0 / 2.0)*t4; /* 1/2*I3*omega3*omega3 */
    const double t6 = t2 + t5; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 */
    const double t7 = x[4]*p[1]; /* omega3*R */
    const double t8 = t7*x[5]; /* omega3*R*s */
    const double t9 = p[1]*x[0]; /* R*gamma3 */
    const double t10 = t9*x[3]; /* R*gamma3*omega_n */
    const double t11 = t8 + t10; /* v_tau = omega3*R*s + R*gamma3*omega_n */
    const double t12 = t11*t11; /* v_tau*v_tau */
    const double t13 = p[0]*t12; /* m*v_tau*v_tau */
    const double t14 = (1.0 / 2.0)*t13; /* 1/2*m*v_tau*v_tau */
    const double t15 = t6 + t14; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    const double t16 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t17 = p[5]*t16; /* I3*omega_tau*omega_tau */
    const double t18 = (1.0 / 2.0)*t17; /* 1/2*I3*omega_tau*omega_tau */
    const double t19 = t15 + t18; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau + 1/2*I3*omega_tau*omega_tau */
    const double t20 = x[3]*x[3]; /* omega_n*omega_n */
    const double t21 = p[5]*t20; /* I3*omega_n*omega_n */
    const double t22 = (1.0 / 2.0)*t21; /* 1/2*I3*omega_n*omega_n */
    const double t23 = t19 + t22; /* energy = t19 + 1/2*I3*omega_n*omega_n */
    const double t24 = p[5]*p[1]; /* I3*R */
    const double t25 = x[0]*t24; /* gamma3*I3*R */
    const double t26 = x[4]*t25; /* omega3*gamma3*I3*R */
    const double t27 = x[3]*t24; /* omega_n*I3*R */
    const double t28 = x[5]*t27; /* s*omega_n*I3*R */
    const double t29 = t28 - t26; /* s*omega_n*I3*R - omega3*gamma3*I3*R */
    const double t30 = p[5]*p[5]; /* I3*I3 */
    const double t31 = p[0]*t30; /* m*I3*I3 */
    const double t32 = p[1]*x[2]; /* R*omega_tau */
    const double t33 = x[1] + t32; /* v_nu + R*omega_tau */
    const double t34 = t33*t33; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t35 = t31*t34; /* m*I3*I3*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    out[0] = t23;
    out[1] = t29;
    out[2] = t35;
    out[3] = t33;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[1]; /* m*R */
    const double t1 = t0*x[3]; /* m*R*omega_n */
    const double t2 = p[1]*x[4]; /* R*omega3 */
    const double t3 = t2*x[5]; /* R*omega3*s */
    const double t4 = p[1]*x[0]; /* R*gamma3 */
    const double t5 = x[3]*t4; /* omega_n*R*gamma3 */
    const double t6 = t3 + t5; /* v_tau = R*omega3*s + omega_n*R*gamma3 */
    const double t7 = t1*t6; /* m*R*omega_n*v_tau */
    const double t8 = p[0]*x[1]; /* m*v_nu */
    const double t9 = p[5]*x[2]; /* I3*omega_tau */
    const double t10 = t0*x[0]; /* m*R*gamma3 */
    const double t11 = t6*t10; /* v_tau*m*R*gamma3 */
    const double t12 = x[3]*p[5]; /* omega_n*I3 */
    const double t13 = t11 + t12; /* d(energy)/d(omega_n) = v_tau*m*R*gamma3 + omega_n*I3 */
    const double t14 = x[4]*p[5]; /* omega3*I3 */
    const double t15 = t0*x[5]; /* m*R*s */
    const double t16 = t6*t15; /* v_tau*m*R*s */
    const double t17 = t14 + t16; /* d(energy)/d(omega3) = omega3*I3 + v_tau*m*R*s */
    const double t18 = t0*x[4]; /* m*R*omega3 */
    const double t19 = t6*t18; /* v_tau*m*R*omega3 */
    const double t20 = p[1]*p[5]; /* R*I3 */
    const double t21 = x[4]*t20; /* omega3*R*I3 */
    const double t22 = -t21; /* -omega3*R*I3 */
    const double t23 = x[5]*t20; /* s*R*I3 */
    const double t24 = x[0]*t20; /* gamma3*R*I3 */
    const double t25 = -t24; /* -gamma3*R*I3 */
    const double t26 = x[3]*t20; /* omega_n*R*I3 */
    const double t27 = p[0]*2.0; /* m*2 */
    const double t28 = p[5]*p[5]; /* I3*I3 */
    const double t29 = t27*t28; /* m*2*I3*I3 */
    const double t30 = p[1]*x[2]; /* R*omega_tau */
    const double t31 = x[1] + t30; /* v_nu + R*omega_tau */
    const double t32 = t29*t31; /* m*2*I3*I3*(v_nu + R*omega_tau) */
    const double t33 = p[1]*t27; /* R*m*2 */
    const double t34 = t28*t33; /* I3*I3*R*m*2 */
    const double t35 = t31*t34; /* (v_nu + R*omega_tau)*I3*I3*R*m*2 */
    out[0] = t7;
    out[1] = t8;
    out[2] = t9;
    out[3] = t13;
    out[4] = t17;
    out[5] = t19;
    out[6] = t22;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t23;
    out[10] = t25;
    out[11] = t26;
    out[12] = 0.0;
    out[13] = t32;
    out[14] = t35;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = 1.0;
    out[20] = p[1];
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[5];
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[5];
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
    const double v_I3 = params[5];
    const double v_I1 = (v_I3);
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
    out[4] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[5] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "G", "" },
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 7,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 6, { 11, 36, 0, 4, 0, 0, 10, 8 }, { 11, 48, 0, 4, 0, 0, 10, 6 },
        "divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .jacobian = { jacobian, 36, { 30, 102, 0, 21, 0, 0, 12, 20 }, { 30, 190, 0, 22, 0, 0, 12, 6 },
        "divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .rhs_jacobian = { rhs_jacobian, 42, { 38, 113, 0, 25, 0, 0, 12, 25 }, { 38, 226, 0, 26, 0, 0, 12, 6 },
        "divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .divergence = { divergence, 1, { 4, 12, 0, 1, 0, 0, 8, 5 }, { 4, 16, 0, 1, 0, 0, 8, 5 },
        "divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .integral_values = { integral_values, 4, { 7, 29, 0, 0, 0, 0, 9, 4 }, { 8, 31, 0, 0, 0, 0, 9, 4 },
        "" },
    .integral_gradients = { integral_gradients, 24, { 6, 30, 0, 0, 0, 0, 5, 5 }, { 7, 39, 0, 0, 0, 0, 5, 4 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_in_regular_baseline,
        &jlt_batch_spherical_top_balanced_equal_in_regular_avx2,
        &jlt_batch_spherical_top_balanced_equal_in_regular_avx512,
    },
};
