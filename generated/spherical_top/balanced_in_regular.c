/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 11   44    0    6    0    0     10   10   (75)
 *  jacobian            34  137    0   30    0    0     13   18   (321)
 *  rhs_jacobian        42  150    0   36    0    0     13   31   (381)
 *  divergence          4   17    0    2    0    0      8    5   (30)
 *  integral_values     10   40    0    0    0    0      9    6   (55)
 *  integral_gradients  8   52    0    0    0    0      8    8   (81)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
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
    const double t0 = params[4]*params[5]; /* I1*I3 */
    const double t1 = params[4] - params[5]; /* I1 - I3 */
    out[6] = t0;
    out[7] = t1;
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
    const double t11 = x[3]*p[5]; /* omega_n*I3 */
    const double t12 = x[4]*t11; /* omega3*omega_n*I3 */
    const double t13 = x[5]*t12; /* s*omega3*omega_n*I3 */
    const double t14 = t13/p[4]; /* s*omega3*omega_n*I3/I1 */
    const double t15 = t10 - t14; /* -gamma3*omega_n*omega_n - s*omega3*omega_n*I3/I1 */
    const double t16 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t17 = x[3]*t16; /* omega_n*omega_tau*gamma3 */
    const double t18 = p[5]*p[5]; /* I3*I3 */
    const double t19 = x[2]*t18; /* omega_tau*I3*I3 */
    const double t20 = x[4]*t19; /* omega3*omega_tau*I3*I3 */
    const double t21 = x[5]*t20; /* s*omega3*omega_tau*I3*I3 */
    const double t22 = p[1]*p[1]; /* R*R */
    const double t23 = p[0]*t22; /* m*R*R */
    const double t24 = p[4]*t23; /* I1*m*R*R */
    const double t25 = t0*t24; /* s*s*I1*m*R*R */
    const double t26 = p[6] + t25; /* I1*I3 + s*s*I1*m*R*R */
    const double t27 = p[5]*t23; /* I3*m*R*R */
    const double t28 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t29 = t27*t28; /* I3*m*R*R*gamma3*gamma3 */
    const double t30 = t26 + t29; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*R*R*gamma3*gamma3 */
    const double t31 = t21/t30; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t32 = t17 + t31; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta */
    const double t33 = p[1]*p[0]; /* R*m */
    const double t34 = p[5]*t33; /* I3*R*m */
    const double t35 = x[0]*t34; /* gamma3*I3*R*m */
    const double t36 = x[3]*t35; /* omega_n*gamma3*I3*R*m */
    const double t37 = x[2]*p[1]; /* omega_tau*R */
    const double t38 = x[1] + t37; /* V = v_nu + omega_tau*R */
    const double t39 = t36*t38; /* omega_n*gamma3*I3*R*m*V */
    const double t40 = t39/t30; /* omega_n*gamma3*I3*R*m*V/Theta */
    const double t41 = t32 - t40; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/Theta */
    const double t42 = x[2]*t27; /* omega_tau*I3*m*R*R */
    const double t43 = x[4]*t42; /* omega3*omega_tau*I3*m*R*R */
    const double t44 = x[5]*t43; /* s*omega3*omega_tau*I3*m*R*R */
    const double t45 = t44/t30; /* s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t46 = t41 + t45; /* t41 + s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t47 = p[4]*t33; /* I1*R*m */
    const double t48 = x[3]*t47; /* omega_n*I1*R*m */
    const double t49 = x[5]*t48; /* s*omega_n*I1*R*m */
    const double t50 = t38*t49; /* V*s*omega_n*I1*R*m */
    const double t51 = t50/t30; /* V*s*omega_n*I1*R*m/Theta */
    const double t52 = x[0]*t23; /* gamma3*m*R*R */
    const double t53 = x[2]*t52; /* omega_tau*gamma3*m*R*R */
    const double t54 = x[4]*t53; /* omega3*omega_tau*gamma3*m*R*R */
    const double t55 = t0*t54; /* s*s*omega3*omega_tau*gamma3*m*R*R */
    const double t56 = t55*p[7]; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t57 = t56/t30; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t58 = t57 - t51; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - V*s*omega_n*I1*R*m/Theta */
    const double t59 = x[5]*t16; /* s*omega_tau*gamma3 */
    const double t60 = -t59; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t8;
    out[2] = t15;
    out[3] = t46;
    out[4] = t58;
    out[5] = t60;
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
    const double t18 = x[4]*p[5]; /* omega3*I3 */
    const double t19 = x[5]*t18; /* s*omega3*I3 */
    const double t20 = t19/p[4]; /* s*omega3*I3/I1 */
    const double t21 = t17 - t20; /* -2*omega_n*gamma3 - s*omega3*I3/I1 */
    const double t22 = x[3]*p[5]; /* omega_n*I3 */
    const double t23 = x[5]*t22; /* s*omega_n*I3 */
    const double t24 = t23/p[4]; /* s*omega_n*I3/I1 */
    const double t25 = -t24; /* -s*omega_n*I3/I1 */
    const double t26 = x[4]*t22; /* omega3*omega_n*I3 */
    const double t27 = t26/p[4]; /* omega3*omega_n*I3/I1 */
    const double t28 = -t27; /* -omega3*omega_n*I3/I1 */
    const double t29 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t30 = p[1]*p[0]; /* R*m */
    const double t31 = p[5]*t30; /* I3*R*m */
    const double t32 = x[3]*t31; /* omega_n*I3*R*m */
    const double t33 = p[1]*p[1]; /* R*R */
    const double t34 = p[0]*t33; /* m*R*R */
    const double t35 = p[4]*t34; /* I1*m*R*R */
    const double t36 = t0*t35; /* s*s*I1*m*R*R */
    const double t37 = p[6] + t36; /* I1*I3 + s*s*I1*m*R*R */
    const double t38 = p[5]*t34; /* I3*m*R*R */
    const double t39 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t40 = t38*t39; /* I3*m*R*R*gamma3*gamma3 */
    const double t41 = t37 + t40; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*R*R*gamma3*gamma3 */
    const double t42 = x[2]*p[1]; /* omega_tau*R */
    const double t43 = x[1] + t42; /* V = v_nu + omega_tau*R */
    const double t44 = t32*t43; /* omega_n*I3*R*m*V */
    const double t45 = t44/t41; /* omega_n*I3*R*m*V/Theta */
    const double t46 = t29 - t45; /* omega_tau*omega_n - omega_n*I3*R*m*V/Theta */
    const double t47 = p[5]*p[5]; /* I3*I3 */
    const double t48 = p[5]*t47; /* I3*I3*I3 */
    const double t49 = t34*t48; /* m*R*R*I3*I3*I3 */
    const double t50 = x[0]*t49; /* gamma3*m*R*R*I3*I3*I3 */
    const double t51 = x[2]*t50; /* omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t52 = x[4]*t51; /* omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t53 = x[5]*t52; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t54 = t41*t41; /* Theta*Theta */
    const double t55 = t53/t54; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t56 = 2.0*t55; /* 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t57 = t46 - t56; /* omega_tau*omega_n - omega_n*I3*R*m*V/Theta - 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t58 = p[0]*p[0]; /* m*m */
    const double t59 = p[1]*t33; /* R*R*R */
    const double t60 = t58*t59; /* m*m*R*R*R */
    const double t61 = t47*t60; /* I3*I3*m*m*R*R*R */
    const double t62 = t39*t61; /* gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t63 = x[3]*t62; /* omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t64 = t43*t63; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t65 = t64/t54; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t66 = 2.0*t65; /* 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t67 = t57 + t66; /* t57 + 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t68 = t33*t33; /* R*R*R*R */
    const double t69 = t58*t68; /* m*m*R*R*R*R */
    const double t70 = t47*t69; /* I3*I3*m*m*R*R*R*R */
    const double t71 = x[0]*t70; /* gamma3*I3*I3*m*m*R*R*R*R */
    const double t72 = x[2]*t71; /* omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t73 = x[4]*t72; /* omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t74 = x[5]*t73; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t75 = t74/t54; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t76 = 2.0*t75; /* 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t77 = t67 - t76; /* t67 - 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t78 = x[0]*t31; /* gamma3*I3*R*m */
    const double t79 = x[3]*t78; /* omega_n*gamma3*I3*R*m */
    const double t80 = t79/t41; /* omega_n*gamma3*I3*R*m/Theta */
    const double t81 = -t80; /* -omega_n*gamma3*I3*R*m/Theta */
    const double t82 = x[4]*t47; /* omega3*I3*I3 */
    const double t83 = x[5]*t82; /* s*omega3*I3*I3 */
    const double t84 = t83/t41; /* s*omega3*I3*I3/Theta */
    const double t85 = t15 + t84; /* omega_n*gamma3 + s*omega3*I3*I3/Theta */
    const double t86 = x[0]*t38; /* gamma3*I3*m*R*R */
    const double t87 = x[3]*t86; /* omega_n*gamma3*I3*m*R*R */
    const double t88 = t87/t41; /* omega_n*gamma3*I3*m*R*R/Theta */
    const double t89 = t85 - t88; /* omega_n*gamma3 + s*omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/Theta */
    const double t90 = x[4]*t38; /* omega3*I3*m*R*R */
    const double t91 = x[5]*t90; /* s*omega3*I3*m*R*R */
    const double t92 = t91/t41; /* s*omega3*I3*m*R*R/Theta */
    const double t93 = t89 + t92; /* t89 + s*omega3*I3*m*R*R/Theta */
    const double t94 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t95 = t43*t78; /* V*gamma3*I3*R*m */
    const double t96 = t95/t41; /* V*gamma3*I3*R*m/Theta */
    const double t97 = t94 - t96; /* omega_tau*gamma3 - V*gamma3*I3*R*m/Theta */
    const double t98 = x[2]*t47; /* omega_tau*I3*I3 */
    const double t99 = x[5]*t98; /* s*omega_tau*I3*I3 */
    const double t100 = t99/t41; /* s*omega_tau*I3*I3/Theta */
    const double t101 = x[2]*t38; /* omega_tau*I3*m*R*R */
    const double t102 = x[5]*t101; /* s*omega_tau*I3*m*R*R */
    const double t103 = t102/t41; /* s*omega_tau*I3*m*R*R/Theta */
    const double t104 = t100 + t103; /* s*omega_tau*I3*I3/Theta + s*omega_tau*I3*m*R*R/Theta */
    const double t105 = x[4]*t98; /* omega3*omega_tau*I3*I3 */
    const double t106 = t105/t41; /* omega3*omega_tau*I3*I3/Theta */
    const double t107 = t35*t47; /* I1*m*R*R*I3*I3 */
    const double t108 = x[2]*t107; /* omega_tau*I1*m*R*R*I3*I3 */
    const double t109 = x[4]*t108; /* omega3*omega_tau*I1*m*R*R*I3*I3 */
    const double t110 = t0*t109; /* s*s*omega3*omega_tau*I1*m*R*R*I3*I3 */
    const double t111 = t110/t54; /* s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t112 = 2.0*t111; /* 2*s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t113 = t106 - t112; /* omega3*omega_tau*I3*I3/Theta - 2*s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t114 = x[4]*t101; /* omega3*omega_tau*I3*m*R*R */
    const double t115 = t114/t41; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t116 = t113 + t115; /* t113 + omega3*omega_tau*I3*m*R*R/Theta */
    const double t117 = p[4]*t60; /* I1*m*m*R*R*R */
    const double t118 = p[5]*t117; /* I3*I1*m*m*R*R*R */
    const double t119 = x[0]*t118; /* gamma3*I3*I1*m*m*R*R*R */
    const double t120 = x[3]*t119; /* omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t121 = x[5]*t120; /* s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t122 = t43*t121; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t123 = t122/t54; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t124 = 2.0*t123; /* 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t125 = t116 + t124; /* t113 + omega3*omega_tau*I3*m*R*R/Theta + 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t126 = p[4]*t69; /* I1*m*m*R*R*R*R */
    const double t127 = p[5]*t126; /* I3*I1*m*m*R*R*R*R */
    const double t128 = x[2]*t127; /* omega_tau*I3*I1*m*m*R*R*R*R */
    const double t129 = x[4]*t128; /* omega3*omega_tau*I3*I1*m*m*R*R*R*R */
    const double t130 = t0*t129; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R */
    const double t131 = t130/t54; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t132 = 2.0*t131; /* 2*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t133 = t125 - t132; /* t125 - 2*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t134 = x[2]*t34; /* omega_tau*m*R*R */
    const double t135 = x[4]*t134; /* omega3*omega_tau*m*R*R */
    const double t136 = t0*t135; /* s*s*omega3*omega_tau*m*R*R */
    const double t137 = t136*p[7]; /* s*s*omega3*omega_tau*m*R*R*(I1 - I3) */
    const double t138 = t137/t41; /* s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t139 = t124 + t138; /* 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) + s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t140 = p[5]*t69; /* I3*m*m*R*R*R*R */
    const double t141 = t39*t140; /* gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t142 = x[2]*t141; /* omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t143 = x[4]*t142; /* omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t144 = t0*t143; /* s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t145 = p[7]*t144; /* (I1 - I3)*s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t146 = t145/t54; /* (I1 - I3)*s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t147 = 2.0*t146; /* 2*t146 */
    const double t148 = t139 - t147; /* t139 - 2*t146 */
    const double t149 = p[4]*t30; /* I1*R*m */
    const double t150 = x[3]*t149; /* omega_n*I1*R*m */
    const double t151 = x[5]*t150; /* s*omega_n*I1*R*m */
    const double t152 = t151/t41; /* s*omega_n*I1*R*m/Theta */
    const double t153 = -t152; /* -s*omega_n*I1*R*m/Theta */
    const double t154 = x[0]*t34; /* gamma3*m*R*R */
    const double t155 = x[4]*t154; /* omega3*gamma3*m*R*R */
    const double t156 = t0*t155; /* s*s*omega3*gamma3*m*R*R */
    const double t157 = p[7]*t156; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R */
    const double t158 = t157/t41; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta */
    const double t159 = x[3]*t35; /* omega_n*I1*m*R*R */
    const double t160 = x[5]*t159; /* s*omega_n*I1*m*R*R */
    const double t161 = t160/t41; /* s*omega_n*I1*m*R*R/Theta */
    const double t162 = t158 - t161; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta - s*omega_n*I1*m*R*R/Theta */
    const double t163 = x[5]*t149; /* s*I1*R*m */
    const double t164 = t43*t163; /* V*s*I1*R*m */
    const double t165 = t164/t41; /* V*s*I1*R*m/Theta */
    const double t166 = -t165; /* -V*s*I1*R*m/Theta */
    const double t167 = x[2]*t154; /* omega_tau*gamma3*m*R*R */
    const double t168 = t0*t167; /* s*s*omega_tau*gamma3*m*R*R */
    const double t169 = p[7]*t168; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R */
    const double t170 = t169/t41; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta */
    const double t171 = t43*t150; /* V*omega_n*I1*R*m */
    const double t172 = t171/t41; /* V*omega_n*I1*R*m/Theta */
    const double t173 = x[4]*t167; /* omega3*omega_tau*gamma3*m*R*R */
    const double t174 = x[5]*t173; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t175 = p[7]*t174; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t176 = t175/t41; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t177 = 2.0*t176; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t178 = t177 - t172; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta - V*omega_n*I1*R*m/Theta */
    const double t179 = p[4]*p[4]; /* I1*I1 */
    const double t180 = t60*t179; /* m*m*R*R*R*I1*I1 */
    const double t181 = x[3]*t180; /* omega_n*m*m*R*R*R*I1*I1 */
    const double t182 = t0*t181; /* s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t183 = t43*t182; /* V*s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t184 = t183/t54; /* V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t185 = 2.0*t184; /* 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t186 = t178 + t185; /* t178 + 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t187 = x[0]*t126; /* gamma3*I1*m*m*R*R*R*R */
    const double t188 = x[2]*t187; /* omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t189 = x[4]*t188; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t190 = x[5]*t0; /* s*s*s */
    const double t191 = t189*t190; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s */
    const double t192 = p[7]*t191; /* (I1 - I3)*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s */
    const double t193 = t192/t54; /* (I1 - I3)*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s/(Theta*Theta) */
    const double t194 = 2.0*t193; /* 2*t193 */
    const double t195 = t186 - t194; /* t178 + 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) - 2*t193 */
    const double t196 = x[5]*x[2]; /* s*omega_tau */
    const double t197 = -t196; /* -s*omega_tau */
    const double t198 = x[5]*x[0]; /* s*gamma3 */
    const double t199 = -t198; /* -s*gamma3 */
    const double t200 = -t94; /* -omega_tau*gamma3 */
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
    out[15] = t21;
    out[16] = t25;
    out[17] = t28;
    out[18] = t77;
    out[19] = t81;
    out[20] = t93;
    out[21] = t97;
    out[22] = t104;
    out[23] = t133;
    out[24] = t148;
    out[25] = t153;
    out[26] = t162;
    out[27] = t166;
    out[28] = t170;
    out[29] = t195;
    out[30] = t197;
    out[31] = 0.0;
    out[32] = t199;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = t200;
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
    const double t11 = x[3]*p[5]; /* omega_n*I3 */
    const double t12 = x[4]*t11; /* omega3*omega_n*I3 */
    const double t13 = x[5]*t12; /* s*omega3*omega_n*I3 */
    const double t14 = t13/p[4]; /* s*omega3*omega_n*I3/I1 */
    const double t15 = t10 - t14; /* -gamma3*omega_n*omega_n - s*omega3*omega_n*I3/I1 */
    const double t16 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t17 = x[3]*t16; /* omega_n*omega_tau*gamma3 */
    const double t18 = p[5]*p[5]; /* I3*I3 */
    const double t19 = x[2]*t18; /* omega_tau*I3*I3 */
    const double t20 = x[4]*t19; /* omega3*omega_tau*I3*I3 */
    const double t21 = x[5]*t20; /* s*omega3*omega_tau*I3*I3 */
    const double t22 = p[1]*p[1]; /* R*R */
    const double t23 = p[0]*t22; /* m*R*R */
    const double t24 = p[4]*t23; /* I1*m*R*R */
    const double t25 = t0*t24; /* s*s*I1*m*R*R */
    const double t26 = p[6] + t25; /* I1*I3 + s*s*I1*m*R*R */
    const double t27 = p[5]*t23; /* I3*m*R*R */
    const double t28 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t29 = t27*t28; /* I3*m*R*R*gamma3*gamma3 */
    const double t30 = t26 + t29; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*R*R*gamma3*gamma3 */
    const double t31 = t21/t30; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t32 = t17 + t31; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta */
    const double t33 = p[1]*p[0]; /* R*m */
    const double t34 = p[5]*t33; /* I3*R*m */
    const double t35 = x[0]*t34; /* gamma3*I3*R*m */
    const double t36 = x[3]*t35; /* omega_n*gamma3*I3*R*m */
    const double t37 = x[2]*p[1]; /* omega_tau*R */
    const double t38 = x[1] + t37; /* V = v_nu + omega_tau*R */
    const double t39 = t36*t38; /* omega_n*gamma3*I3*R*m*V */
    const double t40 = t39/t30; /* omega_n*gamma3*I3*R*m*V/Theta */
    const double t41 = t32 - t40; /* omega_n*omega_tau*gamma3 + s*omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/Theta */
    const double t42 = x[2]*t27; /* omega_tau*I3*m*R*R */
    const double t43 = x[4]*t42; /* omega3*omega_tau*I3*m*R*R */
    const double t44 = x[5]*t43; /* s*omega3*omega_tau*I3*m*R*R */
    const double t45 = t44/t30; /* s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t46 = t41 + t45; /* t41 + s*omega3*omega_tau*I3*m*R*R/Theta */
    const double t47 = p[4]*t33; /* I1*R*m */
    const double t48 = x[3]*t47; /* omega_n*I1*R*m */
    const double t49 = x[5]*t48; /* s*omega_n*I1*R*m */
    const double t50 = t38*t49; /* V*s*omega_n*I1*R*m */
    const double t51 = t50/t30; /* V*s*omega_n*I1*R*m/Theta */
    const double t52 = x[0]*t23; /* gamma3*m*R*R */
    const double t53 = x[2]*t52; /* omega_tau*gamma3*m*R*R */
    const double t54 = x[4]*t53; /* omega3*omega_tau*gamma3*m*R*R */
    const double t55 = t0*t54; /* s*s*omega3*omega_tau*gamma3*m*R*R */
    const double t56 = t55*p[7]; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t57 = t56/t30; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t58 = t57 - t51; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - V*s*omega_n*I1*R*m/Theta */
    const double t59 = -t16; /* -omega_tau*gamma3 */
    const double t60 = x[5]*t16; /* s*omega_tau*gamma3 */
    const double t61 = -t60; /* -s*omega_tau*gamma3 */
    const double t62 = x[2]*2.0; /* omega_tau*2 */
    const double t63 = x[5]*t62; /* s*omega_tau*2 */
    const double t64 = p[1]*t6; /* R*omega_n*omega_n */
    const double t65 = p[1]*x[4]; /* R*omega3 */
    const double t66 = x[5]*t65; /* s*R*omega3 */
    const double t67 = x[3]*t5; /* omega_n*R*gamma3 */
    const double t68 = 2.0*t67; /* 2*omega_n*R*gamma3 */
    const double t69 = t66 + t68; /* s*R*omega3 + 2*omega_n*R*gamma3 */
    const double t70 = x[5]*t2; /* s*R*omega_n */
    const double t71 = -t6; /* -omega_n*omega_n */
    const double t72 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t73 = 2.0*t72; /* 2*omega_n*gamma3 */
    const double t74 = -t73; /* -2*omega_n*gamma3 */
    const double t75 = x[4]*p[5]; /* omega3*I3 */
    const double t76 = x[5]*t75; /* s*omega3*I3 */
    const double t77 = t76/p[4]; /* s*omega3*I3/I1 */
    const double t78 = t74 - t77; /* -2*omega_n*gamma3 - s*omega3*I3/I1 */
    const double t79 = x[5]*t11; /* s*omega_n*I3 */
    const double t80 = t79/p[4]; /* s*omega_n*I3/I1 */
    const double t81 = -t80; /* -s*omega_n*I3/I1 */
    const double t82 = t12/p[4]; /* omega3*omega_n*I3/I1 */
    const double t83 = -t82; /* -omega3*omega_n*I3/I1 */
    const double t84 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t85 = x[3]*t34; /* omega_n*I3*R*m */
    const double t86 = t38*t85; /* V*omega_n*I3*R*m */
    const double t87 = t86/t30; /* V*omega_n*I3*R*m/Theta */
    const double t88 = t84 - t87; /* omega_tau*omega_n - V*omega_n*I3*R*m/Theta */
    const double t89 = p[5]*t18; /* I3*I3*I3 */
    const double t90 = t23*t89; /* m*R*R*I3*I3*I3 */
    const double t91 = x[0]*t90; /* gamma3*m*R*R*I3*I3*I3 */
    const double t92 = x[2]*t91; /* omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t93 = x[4]*t92; /* omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t94 = x[5]*t93; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3 */
    const double t95 = t30*t30; /* Theta*Theta */
    const double t96 = t94/t95; /* s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t97 = 2.0*t96; /* 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t98 = t88 - t97; /* omega_tau*omega_n - V*omega_n*I3*R*m/Theta - 2*s*omega3*omega_tau*gamma3*m*R*R*I3*I3*I3/(Theta*Theta) */
    const double t99 = p[0]*p[0]; /* m*m */
    const double t100 = p[1]*t22; /* R*R*R */
    const double t101 = t99*t100; /* m*m*R*R*R */
    const double t102 = t18*t101; /* I3*I3*m*m*R*R*R */
    const double t103 = t28*t102; /* gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t104 = x[3]*t103; /* omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t105 = t38*t104; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R */
    const double t106 = t105/t95; /* V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t107 = 2.0*t106; /* 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t108 = t98 + t107; /* t98 + 2*V*omega_n*gamma3*gamma3*I3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t109 = t22*t22; /* R*R*R*R */
    const double t110 = t99*t109; /* m*m*R*R*R*R */
    const double t111 = t18*t110; /* I3*I3*m*m*R*R*R*R */
    const double t112 = x[0]*t111; /* gamma3*I3*I3*m*m*R*R*R*R */
    const double t113 = x[2]*t112; /* omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t114 = x[4]*t113; /* omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t115 = x[5]*t114; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R */
    const double t116 = t115/t95; /* s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t117 = 2.0*t116; /* 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t118 = t108 - t117; /* t108 - 2*s*omega3*omega_tau*gamma3*I3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t119 = t36/t30; /* omega_n*gamma3*I3*R*m/Theta */
    const double t120 = -t119; /* -omega_n*gamma3*I3*R*m/Theta */
    const double t121 = x[4]*t18; /* omega3*I3*I3 */
    const double t122 = x[5]*t121; /* s*omega3*I3*I3 */
    const double t123 = t122/t30; /* s*omega3*I3*I3/Theta */
    const double t124 = t72 + t123; /* omega_n*gamma3 + s*omega3*I3*I3/Theta */
    const double t125 = x[0]*t27; /* gamma3*I3*m*R*R */
    const double t126 = x[3]*t125; /* omega_n*gamma3*I3*m*R*R */
    const double t127 = t126/t30; /* omega_n*gamma3*I3*m*R*R/Theta */
    const double t128 = t124 - t127; /* omega_n*gamma3 + s*omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/Theta */
    const double t129 = x[4]*t27; /* omega3*I3*m*R*R */
    const double t130 = x[5]*t129; /* s*omega3*I3*m*R*R */
    const double t131 = t130/t30; /* s*omega3*I3*m*R*R/Theta */
    const double t132 = t128 + t131; /* t128 + s*omega3*I3*m*R*R/Theta */
    const double t133 = t35*t38; /* gamma3*I3*R*m*V */
    const double t134 = t133/t30; /* gamma3*I3*R*m*V/Theta */
    const double t135 = t16 - t134; /* omega_tau*gamma3 - gamma3*I3*R*m*V/Theta */
    const double t136 = x[5]*t19; /* s*omega_tau*I3*I3 */
    const double t137 = t136/t30; /* s*omega_tau*I3*I3/Theta */
    const double t138 = x[5]*t42; /* s*omega_tau*I3*m*R*R */
    const double t139 = t138/t30; /* s*omega_tau*I3*m*R*R/Theta */
    const double t140 = t137 + t139; /* s*omega_tau*I3*I3/Theta + s*omega_tau*I3*m*R*R/Theta */
    const double t141 = t20/t30; /* omega3*omega_tau*I3*I3/Theta */
    const double t142 = t18*t24; /* I3*I3*I1*m*R*R */
    const double t143 = x[2]*t142; /* omega_tau*I3*I3*I1*m*R*R */
    const double t144 = x[4]*t143; /* omega3*omega_tau*I3*I3*I1*m*R*R */
    const double t145 = t0*t144; /* s*s*omega3*omega_tau*I3*I3*I1*m*R*R */
    const double t146 = t145/t95; /* s*s*omega3*omega_tau*I3*I3*I1*m*R*R/(Theta*Theta) */
    const double t147 = 2.0*t146; /* 2*s*s*omega3*omega_tau*I3*I3*I1*m*R*R/(Theta*Theta) */
    const double t148 = t141 - t147; /* omega3*omega_tau*I3*I3/Theta - 2*s*s*omega3*omega_tau*I3*I3*I1*m*R*R/(Theta*Theta) */
    const double t149 = t43/t30; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t150 = t148 + t149; /* t148 + omega3*omega_tau*I3*m*R*R/Theta */
    const double t151 = p[4]*t101; /* I1*m*m*R*R*R */
    const double t152 = p[5]*t151; /* I3*I1*m*m*R*R*R */
    const double t153 = x[0]*t152; /* gamma3*I3*I1*m*m*R*R*R */
    const double t154 = x[3]*t153; /* omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t155 = x[5]*t154; /* s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t156 = t38*t155; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R */
    const double t157 = t156/t95; /* V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t158 = 2.0*t157; /* 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t159 = t150 + t158; /* t148 + omega3*omega_tau*I3*m*R*R/Theta + 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t160 = p[4]*t110; /* I1*m*m*R*R*R*R */
    const double t161 = p[5]*t160; /* I3*I1*m*m*R*R*R*R */
    const double t162 = x[2]*t161; /* omega_tau*I3*I1*m*m*R*R*R*R */
    const double t163 = x[4]*t162; /* omega3*omega_tau*I3*I1*m*m*R*R*R*R */
    const double t164 = t0*t163; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R */
    const double t165 = t164/t95; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t166 = 2.0*t165; /* 2*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t167 = t159 - t166; /* t159 - 2*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t168 = x[2]*t23; /* omega_tau*m*R*R */
    const double t169 = x[4]*t168; /* omega3*omega_tau*m*R*R */
    const double t170 = t0*t169; /* s*s*omega3*omega_tau*m*R*R */
    const double t171 = p[7]*t170; /* (I1 - I3)*s*s*omega3*omega_tau*m*R*R */
    const double t172 = t171/t30; /* (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta */
    const double t173 = t158 + t172; /* 2*V*s*omega_n*gamma3*I3*I1*m*m*R*R*R/(Theta*Theta) + (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta */
    const double t174 = p[5]*t110; /* I3*m*m*R*R*R*R */
    const double t175 = t28*t174; /* gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t176 = x[2]*t175; /* omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t177 = x[4]*t176; /* omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t178 = t0*t177; /* s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t179 = p[7]*t178; /* (I1 - I3)*s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R */
    const double t180 = t179/t95; /* (I1 - I3)*s*s*omega3*omega_tau*gamma3*gamma3*I3*m*m*R*R*R*R/(Theta*Theta) */
    const double t181 = 2.0*t180; /* 2*t180 */
    const double t182 = t173 - t181; /* t173 - 2*t180 */
    const double t183 = t49/t30; /* s*omega_n*I1*R*m/Theta */
    const double t184 = -t183; /* -s*omega_n*I1*R*m/Theta */
    const double t185 = x[4]*t52; /* omega3*gamma3*m*R*R */
    const double t186 = t0*t185; /* s*s*omega3*gamma3*m*R*R */
    const double t187 = p[7]*t186; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R */
    const double t188 = t187/t30; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta */
    const double t189 = x[3]*t24; /* omega_n*I1*m*R*R */
    const double t190 = x[5]*t189; /* s*omega_n*I1*m*R*R */
    const double t191 = t190/t30; /* s*omega_n*I1*m*R*R/Theta */
    const double t192 = t188 - t191; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta - s*omega_n*I1*m*R*R/Theta */
    const double t193 = x[5]*t47; /* s*I1*R*m */
    const double t194 = t38*t193; /* V*s*I1*R*m */
    const double t195 = t194/t30; /* V*s*I1*R*m/Theta */
    const double t196 = -t195; /* -V*s*I1*R*m/Theta */
    const double t197 = t0*t53; /* s*s*omega_tau*gamma3*m*R*R */
    const double t198 = p[7]*t197; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R */
    const double t199 = t198/t30; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta */
    const double t200 = t38*t48; /* V*omega_n*I1*R*m */
    const double t201 = t200/t30; /* V*omega_n*I1*R*m/Theta */
    const double t202 = x[5]*t54; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t203 = p[7]*t202; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t204 = t203/t30; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t205 = 2.0*t204; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t206 = t205 - t201; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta - V*omega_n*I1*R*m/Theta */
    const double t207 = p[4]*p[4]; /* I1*I1 */
    const double t208 = t101*t207; /* m*m*R*R*R*I1*I1 */
    const double t209 = x[3]*t208; /* omega_n*m*m*R*R*R*I1*I1 */
    const double t210 = t0*t209; /* s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t211 = t38*t210; /* V*s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t212 = t211/t95; /* V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t213 = 2.0*t212; /* 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t214 = t206 + t213; /* t206 + 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t215 = x[0]*t160; /* gamma3*I1*m*m*R*R*R*R */
    const double t216 = x[2]*t215; /* omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t217 = x[4]*t216; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t218 = x[5]*t0; /* s*s*s */
    const double t219 = t217*t218; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s */
    const double t220 = p[7]*t219; /* (I1 - I3)*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s */
    const double t221 = t220/t95; /* (I1 - I3)*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R*s*s*s/(Theta*Theta) */
    const double t222 = 2.0*t221; /* 2*t221 */
    const double t223 = t214 - t222; /* t206 + 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) - 2*t221 */
    const double t224 = x[2]*x[5]; /* omega_tau*s */
    const double t225 = -t224; /* -omega_tau*s */
    const double t226 = x[5]*x[0]; /* s*gamma3 */
    const double t227 = -t226; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t8;
    out[2] = t15;
    out[3] = t46;
    out[4] = t58;
    out[5] = t61;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t63;
    out[12] = t64;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t69;
    out[16] = t70;
    out[17] = t3;
    out[18] = t71;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = t78;
    out[22] = t81;
    out[23] = t83;
    out[24] = t118;
    out[25] = t120;
    out[26] = t132;
    out[27] = t135;
    out[28] = t140;
    out[29] = t167;
    out[30] = t182;
    out[31] = t184;
    out[32] = t192;
    out[33] = t196;
    out[34] = t199;
    out[35] = t223;
    out[36] = t225;
    out[37] = 0.0;
    out[38] = t227;
    out[39] = 0.0;
    out[40] = 0.0;
    out[41] = t59;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[1]; /* R*R */
    const double t1 = p[0]*t0; /* m*R*R */
    const double t2 = t1*x[0]; /* m*R*R*gamma3 */
    const double t3 = t2*x[2]; /* m*R*R*gamma3*omega_tau */
    const double t4 = x[5]*x[5]; /* s*s */
    const double t5 = t3*t4; /* m*R*R*gamma3*omega_tau*s*s */
    const double t6 = t1*p[4]; /* m*R*R*I1 */
    const double t7 = t4*t6; /* s*s*m*R*R*I1 */
    const double t8 = p[6] + t7; /* I1*I3 + s*s*m*R*R*I1 */
    const double t9 = t1*p[5]; /* m*R*R*I3 */
    const double t10 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t11 = t9*t10; /* m*R*R*I3*gamma3*gamma3 */
    const double t12 = t8 + t11; /* Theta = I1*I3 + s*s*m*R*R*I1 + m*R*R*I3*gamma3*gamma3 */
    const double t13 = t5*p[7]; /* m*R*R*gamma3*omega_tau*s*s*(I1 - I3) */
    const double t14 = t13/t12; /* m*R*R*gamma3*omega_tau*s*s*(I1 - I3)/Theta */
    const double t15 = p[0]*p[1]; /* m*R */
    const double t16 = p[5]*t15; /* I3*m*R */
    const double t17 = x[0]*t16; /* gamma3*I3*m*R */
    const double t18 = p[1]*x[2]; /* R*omega_tau */
    const double t19 = x[1] + t18; /* V = v_nu + R*omega_tau */
    const double t20 = t17*t19; /* gamma3*I3*m*R*V */
    const double t21 = t20/t12; /* gamma3*I3*m*R*V/Theta */
    const double t22 = t14 - t21; /* m*R*R*gamma3*omega_tau*s*s*(I1 - I3)/Theta - gamma3*I3*m*R*V/Theta */
    out[0] = t22;
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
    const double t7 = x[4]*x[4]; /* omega3*omega3 */
    const double t8 = p[5]*t7; /* I3*omega3*omega3 */
    const double t9 = (1.0 / 2.0)*t8; /* 1/2*I3*omega3*omega3 */
    const double t10 = t6 + t9; /* m*v_nu*v_nu*1/2 + 1/2*I1*omega_n*omega_n + 1/2*I3*omega3*omega3 */
    const double t11 = x[4]*p[1]; /* omega3*R */
    const double t12 = t11*x[5]; /* omega3*R*s */
    const double t13 = p[1]*x[0]; /* R*gamma3 */
    const double t14 = x[3]*t13; /* omega_n*R*gamma3 */
    const double t15 = t12 + t14; /* v_tau = omega3*R*s + omega_n*R*gamma3 */
    const double t16 = t15*t15; /* v_tau*v_tau */
    const double t17 = p[0]*t16; /* m*v_tau*v_tau */
    const double t18 = (1.0 / 2.0)*t17; /* 1/2*m*v_tau*v_tau */
    const double t19 = t10 + t18; /* t10 + 1/2*m*v_tau*v_tau */
    const double t20 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t21 = p[4]*t20; /* I1*omega_tau*omega_tau */
    const double t22 = (1.0 / 2.0)*t21; /* 1/2*I1*omega_tau*omega_tau */
    const double t23 = t19 + t22; /* energy = t10 + 1/2*m*v_tau*v_tau + 1/2*I1*omega_tau*omega_tau */
    const double t24 = p[4]*p[1]; /* I1*R */
    const double t25 = x[3]*t24; /* omega_n*I1*R */
    const double t26 = x[5]*t25; /* s*omega_n*I1*R */
    const double t27 = p[5]*p[1]; /* I3*R */
    const double t28 = x[0]*t27; /* gamma3*I3*R */
    const double t29 = x[4]*t28; /* omega3*gamma3*I3*R */
    const double t30 = t26 - t29; /* s*omega_n*I1*R - omega3*gamma3*I3*R */
    const double t31 = p[4]*p[4]; /* I1*I1 */
    const double t32 = p[0]*t31; /* m*I1*I1 */
    const double t33 = p[1]*x[2]; /* R*omega_tau */
    const double t34 = x[1] + t33; /* v_nu + R*omega_tau */
    const double t35 = t34*t34; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t36 = t32*t35; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t37 = p[1]*p[1]; /* R*R */
    const double t38 = p[0]*t37; /* m*R*R */
    const double t39 = p[4]*t38; /* I1*m*R*R */
    const double t40 = x[5]*x[5]; /* s*s */
    const double t41 = t39*t40; /* I1*m*R*R*s*s */
    const double t42 = p[6] + t41; /* I1*I3 + I1*m*R*R*s*s */
    const double t43 = p[5]*t38; /* I3*m*R*R */
    const double t44 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t45 = t43*t44; /* I3*m*R*R*gamma3*gamma3 */
    const double t46 = t42 + t45; /* Theta = I1*I3 + I1*m*R*R*s*s + I3*m*R*R*gamma3*gamma3 */
    const double t47 = t7*t46; /* omega3*omega3*Theta */
    const double t48 = t47*p[7]; /* omega3*omega3*Theta*(I1 - I3) */
    const double t49 = t36 + t48; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) + omega3*omega3*Theta*(I1 - I3) */
    out[0] = t23;
    out[1] = t30;
    out[2] = t49;
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
    const double t9 = p[4]*x[2]; /* I1*omega_tau */
    const double t10 = x[3]*p[4]; /* omega_n*I1 */
    const double t11 = t0*x[0]; /* m*R*gamma3 */
    const double t12 = t6*t11; /* v_tau*m*R*gamma3 */
    const double t13 = t10 + t12; /* d(energy)/d(omega_n) = omega_n*I1 + v_tau*m*R*gamma3 */
    const double t14 = x[4]*p[5]; /* omega3*I3 */
    const double t15 = t0*x[5]; /* m*R*s */
    const double t16 = t6*t15; /* v_tau*m*R*s */
    const double t17 = t14 + t16; /* d(energy)/d(omega3) = omega3*I3 + v_tau*m*R*s */
    const double t18 = t0*x[4]; /* m*R*omega3 */
    const double t19 = t6*t18; /* v_tau*m*R*omega3 */
    const double t20 = p[1]*p[5]; /* R*I3 */
    const double t21 = x[4]*t20; /* omega3*R*I3 */
    const double t22 = -t21; /* -omega3*R*I3 */
    const double t23 = p[1]*p[4]; /* R*I1 */
    const double t24 = x[5]*t23; /* s*R*I1 */
    const double t25 = x[0]*t20; /* gamma3*R*I3 */
    const double t26 = -t25; /* -gamma3*R*I3 */
    const double t27 = x[3]*t23; /* omega_n*R*I1 */
    const double t28 = p[0]*2.0; /* m*2 */
    const double t29 = p[1]*p[1]; /* R*R */
    const double t30 = t28*t29; /* m*2*R*R */
    const double t31 = p[5]*t30; /* I3*m*2*R*R */
    const double t32 = x[0]*t31; /* gamma3*I3*m*2*R*R */
    const double t33 = x[4]*x[4]; /* omega3*omega3 */
    const double t34 = t32*t33; /* gamma3*I3*m*2*R*R*omega3*omega3 */
    const double t35 = t34*p[7]; /* gamma3*I3*m*2*R*R*omega3*omega3*(I1 - I3) */
    const double t36 = p[4]*p[4]; /* I1*I1 */
    const double t37 = t28*t36; /* m*2*I1*I1 */
    const double t38 = p[1]*x[2]; /* R*omega_tau */
    const double t39 = x[1] + t38; /* v_nu + R*omega_tau */
    const double t40 = t37*t39; /* m*2*I1*I1*(v_nu + R*omega_tau) */
    const double t41 = p[1]*t28; /* R*m*2 */
    const double t42 = t36*t41; /* I1*I1*R*m*2 */
    const double t43 = t39*t42; /* (v_nu + R*omega_tau)*I1*I1*R*m*2 */
    const double t44 = x[4]*2.0; /* omega3*2 */
    const double t45 = p[0]*t29; /* m*R*R */
    const double t46 = p[4]*t45; /* I1*m*R*R */
    const double t47 = x[5]*x[5]; /* s*s */
    const double t48 = t46*t47; /* I1*m*R*R*s*s */
    const double t49 = p[6] + t48; /* I1*I3 + I1*m*R*R*s*s */
    const double t50 = p[5]*t45; /* I3*m*R*R */
    const double t51 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t52 = t50*t51; /* I3*m*R*R*gamma3*gamma3 */
    const double t53 = t49 + t52; /* Theta = I1*I3 + I1*m*R*R*s*s + I3*m*R*R*gamma3*gamma3 */
    const double t54 = t44*t53; /* omega3*2*Theta */
    const double t55 = p[7]*t54; /* (I1 - I3)*omega3*2*Theta */
    const double t56 = p[4]*t30; /* I1*m*2*R*R */
    const double t57 = t33*t56; /* omega3*omega3*I1*m*2*R*R */
    const double t58 = x[5]*t57; /* s*omega3*omega3*I1*m*2*R*R */
    const double t59 = p[7]*t58; /* (I1 - I3)*s*omega3*omega3*I1*m*2*R*R */
    out[0] = t7;
    out[1] = t8;
    out[2] = t9;
    out[3] = t13;
    out[4] = t17;
    out[5] = t19;
    out[6] = t22;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t24;
    out[10] = t26;
    out[11] = t27;
    out[12] = t35;
    out[13] = t40;
    out[14] = t43;
    out[15] = 0.0;
    out[16] = t55;
    out[17] = t59;
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
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = params[5];
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
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 8,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 6, { 11, 44, 0, 6, 0, 0, 10, 10 }, { 12, 57, 0, 6, 0, 0, 10, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .jacobian = { jacobian, 36, { 34, 137, 0, 30, 0, 0, 13, 18 }, { 40, 250, 0, 31, 0, 0, 13, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .rhs_jacobian = { rhs_jacobian, 42, { 42, 150, 0, 36, 0, 0, 13, 31 }, { 49, 295, 0, 37, 0, 0, 13, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .divergence = { divergence, 1, { 4, 17, 0, 2, 0, 0, 8, 5 }, { 5, 23, 0, 2, 0, 0, 8, 5 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .integral_values = { integral_values, 3, { 10, 40, 0, 0, 0, 0, 9, 6 }, { 11, 44, 0, 0, 0, 0, 9, 6 },
        "" },
    .integral_gradients = { integral_gradients, 18, { 8, 52, 0, 0, 0, 0, 8, 8 }, { 12, 69, 0, 0, 0, 0, 8, 5 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_in_regular_baseline,
        &jlt_batch_spherical_top_balanced_in_regular_avx2,
        &jlt_batch_spherical_top_balanced_in_regular_avx512,
    },
};
