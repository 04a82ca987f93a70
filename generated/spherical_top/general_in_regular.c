/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 16   62    0   10    0    0     10   10   (105)
 *  jacobian            50  222    0   47    0    0     14   24   (480)
 *  rhs_jacobian        60  239    0   57    0    0     14   43   (563)
 *  divergence          9   29    0    4    0    0     10    8   (53)
 *  integral_values     9   31    0    0    0    0     10    5   (40)
 *  integral_gradients  9   30    0    0    0    0      6    7   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_avx512;

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
    const double t2 = params[0]*params[2]; /* m*g */
    const double t3 = t2*params[3]; /* m*g*a3 */
    out[6] = t0;
    out[7] = t1;
    out[8] = t3;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = p[1]*x[0]; /* R*gamma3 */
    const double t4 = p[3] + t3; /* b = a3 + R*gamma3 */
    const double t5 = t2*t4; /* omega_n*omega_n*b */
    const double t6 = x[3]*p[1]; /* omega_n*R */
    const double t7 = t6*x[4]; /* omega_n*R*omega3 */
    const double t8 = x[5]*t7; /* s*omega_n*R*omega3 */
    const double t9 = t5 + t8; /* omega_n*omega_n*b + s*omega_n*R*omega3 */
    const double t10 = p[3]*p[3]; /* a3*a3 */
    const double t11 = p[0]*t10; /* m*a3*a3 */
    const double t12 = x[0]*t11; /* gamma3*m*a3*a3 */
    const double t13 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t14 = t12*t13; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t15 = t0*t14; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t16 = t0*t11; /* s*s*m*a3*a3 */
    const double t17 = p[4] + t16; /* D = I1 + s*s*m*a3*a3 */
    const double t18 = t15/t17; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t19 = p[0]*p[2]; /* m*g */
    const double t20 = p[3]*t19; /* a3*m*g */
    const double t21 = t0*t20; /* s*s*a3*m*g */
    const double t22 = t21/t17; /* s*s*a3*m*g/D */
    const double t23 = t18 - t22; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t24 = x[0]*p[4]; /* gamma3*I1 */
    const double t25 = t2*t24; /* omega_n*omega_n*gamma3*I1 */
    const double t26 = t25/t17; /* omega_n*omega_n*gamma3*I1/D */
    const double t27 = t23 - t26; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - omega_n*omega_n*gamma3*I1/D */
    const double t28 = x[3]*p[5]; /* omega_n*I3 */
    const double t29 = x[4]*t28; /* omega3*omega_n*I3 */
    const double t30 = x[5]*t29; /* s*omega3*omega_n*I3 */
    const double t31 = t30/t17; /* s*omega3*omega_n*I3/D */
    const double t32 = t27 - t31; /* t27 - s*omega3*omega_n*I3/D */
    const double t33 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t34 = x[3]*t33; /* omega_n*omega_tau*gamma3 */
    const double t35 = p[0]*p[5]; /* m*I3 */
    const double t36 = x[3]*t35; /* omega_n*m*I3 */
    const double t37 = t4*t36; /* b*omega_n*m*I3 */
    const double t38 = p[1]*p[1]; /* R*R */
    const double t39 = p[0]*t38; /* m*R*R */
    const double t40 = p[4]*t39; /* I1*m*R*R */
    const double t41 = t0*t40; /* s*s*I1*m*R*R */
    const double t42 = p[6] + t41; /* I1*I3 + s*s*I1*m*R*R */
    const double t43 = t4*t4; /* b*b */
    const double t44 = t35*t43; /* m*I3*b*b */
    const double t45 = t42 + t44; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t46 = p[3]*x[0]; /* a3*gamma3 */
    const double t47 = p[1] + t46; /* e = R + a3*gamma3 */
    const double t48 = x[2]*t47; /* omega_tau*e */
    const double t49 = x[1] + t48; /* V = v_nu + omega_tau*e */
    const double t50 = t37*t49; /* b*omega_n*m*I3*V */
    const double t51 = t50/t45; /* b*omega_n*m*I3*V/Theta */
    const double t52 = t34 - t51; /* omega_n*omega_tau*gamma3 - b*omega_n*m*I3*V/Theta */
    const double t53 = p[5]*p[5]; /* I3*I3 */
    const double t54 = x[2]*t53; /* omega_tau*I3*I3 */
    const double t55 = x[4]*t54; /* omega3*omega_tau*I3*I3 */
    const double t56 = x[5]*t55; /* s*omega3*omega_tau*I3*I3 */
    const double t57 = t56/t45; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t58 = t52 + t57; /* omega_n*omega_tau*gamma3 - b*omega_n*m*I3*V/Theta + s*omega3*omega_tau*I3*I3/Theta */
    const double t59 = p[1]*p[0]; /* R*m */
    const double t60 = p[5]*t59; /* I3*R*m */
    const double t61 = x[2]*t60; /* omega_tau*I3*R*m */
    const double t62 = x[4]*t61; /* omega3*omega_tau*I3*R*m */
    const double t63 = x[5]*t62; /* s*omega3*omega_tau*I3*R*m */
    const double t64 = t47*t63; /* e*s*omega3*omega_tau*I3*R*m */
    const double t65 = t64/t45; /* e*s*omega3*omega_tau*I3*R*m/Theta */
    const double t66 = t58 + t65; /* t58 + e*s*omega3*omega_tau*I3*R*m/Theta */
    const double t67 = p[4]*t59; /* I1*R*m */
    const double t68 = x[3]*t67; /* omega_n*I1*R*m */
    const double t69 = x[5]*t68; /* s*omega_n*I1*R*m */
    const double t70 = t49*t69; /* V*s*omega_n*I1*R*m */
    const double t71 = t70/t45; /* V*s*omega_n*I1*R*m/Theta */
    const double t72 = x[0]*t39; /* gamma3*m*R*R */
    const double t73 = x[2]*t72; /* omega_tau*gamma3*m*R*R */
    const double t74 = x[4]*t73; /* omega3*omega_tau*gamma3*m*R*R */
    const double t75 = t0*t74; /* s*s*omega3*omega_tau*gamma3*m*R*R */
    const double t76 = t75*p[7]; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t77 = t76/t45; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t78 = t77 - t71; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - V*s*omega_n*I1*R*m/Theta */
    const double t79 = p[3]*t59; /* a3*R*m */
    const double t80 = p[5]*t79; /* I3*a3*R*m */
    const double t81 = x[2]*t80; /* omega_tau*I3*a3*R*m */
    const double t82 = x[4]*t81; /* omega3*omega_tau*I3*a3*R*m */
    const double t83 = t0*t82; /* s*s*omega3*omega_tau*I3*a3*R*m */
    const double t84 = t83/t45; /* s*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t85 = t78 - t84; /* t78 - s*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t86 = x[5]*t33; /* s*omega_tau*gamma3 */
    const double t87 = -t86; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t9;
    out[2] = t32;
    out[3] = t66;
    out[4] = t85;
    out[5] = t87;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[5]*t1; /* s*2*omega_tau */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = p[3] + t5; /* b = a3 + R*gamma3 */
    const double t7 = x[3]*t6; /* omega_n*b */
    const double t8 = 2.0*t7; /* 2*omega_n*b */
    const double t9 = p[1]*x[4]; /* R*omega3 */
    const double t10 = x[5]*t9; /* s*R*omega3 */
    const double t11 = t8 + t10; /* 2*omega_n*b + s*R*omega3 */
    const double t12 = p[1]*x[3]; /* R*omega_n */
    const double t13 = x[5]*t12; /* s*R*omega_n */
    const double t14 = x[4]*t12; /* omega3*R*omega_n */
    const double t15 = p[3]*p[3]; /* a3*a3 */
    const double t16 = p[0]*t15; /* m*a3*a3 */
    const double t17 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t18 = t16*t17; /* m*a3*a3*omega_tau*omega_tau */
    const double t19 = t0*t18; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t20 = t0*t16; /* s*s*m*a3*a3 */
    const double t21 = p[4] + t20; /* D = I1 + s*s*m*a3*a3 */
    const double t22 = t19/t21; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t23 = t3*p[4]; /* omega_n*omega_n*I1 */
    const double t24 = t23/t21; /* omega_n*omega_n*I1/D */
    const double t25 = t22 - t24; /* s*s*m*a3*a3*omega_tau*omega_tau/D - omega_n*omega_n*I1/D */
    const double t26 = 2.0*p[0]; /* 2*m */
    const double t27 = t15*t26; /* a3*a3*2*m */
    const double t28 = x[0]*t27; /* gamma3*a3*a3*2*m */
    const double t29 = x[2]*t28; /* omega_tau*gamma3*a3*a3*2*m */
    const double t30 = t0*t29; /* s*s*omega_tau*gamma3*a3*a3*2*m */
    const double t31 = t30/t21; /* s*s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t32 = x[0]*p[4]; /* gamma3*I1 */
    const double t33 = x[3]*t32; /* omega_n*gamma3*I1 */
    const double t34 = t33/t21; /* omega_n*gamma3*I1/D */
    const double t35 = 2.0*t34; /* 2*omega_n*gamma3*I1/D */
    const double t36 = -t35; /* -2*omega_n*gamma3*I1/D */
    const double t37 = x[4]*p[5]; /* omega3*I3 */
    const double t38 = x[5]*t37; /* s*omega3*I3 */
    const double t39 = t38/t21; /* s*omega3*I3/D */
    const double t40 = t36 - t39; /* -2*omega_n*gamma3*I1/D - s*omega3*I3/D */
    const double t41 = x[3]*p[5]; /* omega_n*I3 */
    const double t42 = x[5]*t41; /* s*omega_n*I3 */
    const double t43 = t42/t21; /* s*omega_n*I3/D */
    const double t44 = -t43; /* -s*omega_n*I3/D */
    const double t45 = x[0]*t16; /* gamma3*m*a3*a3 */
    const double t46 = t17*t45; /* omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t47 = x[5]*t46; /* s*omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t48 = t47/t21; /* s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t49 = 2.0*t48; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t50 = p[0]*p[2]; /* m*g */
    const double t51 = p[3]*t50; /* a3*m*g */
    const double t52 = x[5]*t51; /* s*a3*m*g */
    const double t53 = t52/t21; /* s*a3*m*g/D */
    const double t54 = 2.0*t53; /* 2*s*a3*m*g/D */
    const double t55 = t49 - t54; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D */
    const double t56 = x[4]*t41; /* omega3*omega_n*I3 */
    const double t57 = t56/t21; /* omega3*omega_n*I3/D */
    const double t58 = t55 - t57; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D - omega3*omega_n*I3/D */
    const double t59 = p[0]*p[0]; /* m*m */
    const double t60 = t15*t15; /* a3*a3*a3*a3 */
    const double t61 = t59*t60; /* m*m*a3*a3*a3*a3 */
    const double t62 = x[0]*t61; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t63 = t17*t62; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t64 = x[5]*t0; /* s*s*s */
    const double t65 = t63*t64; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t66 = t21*t21; /* D*D */
    const double t67 = t65/t66; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t68 = 2.0*t67; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t69 = t58 - t68; /* t58 - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t70 = p[2]*t59; /* g*m*m */
    const double t71 = p[3]*t15; /* a3*a3*a3 */
    const double t72 = t70*t71; /* g*m*m*a3*a3*a3 */
    const double t73 = t64*t72; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t74 = t73/t66; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t75 = 2.0*t74; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t76 = t69 + t75; /* t69 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t77 = t16*p[4]; /* m*a3*a3*I1 */
    const double t78 = x[0]*t77; /* gamma3*m*a3*a3*I1 */
    const double t79 = t3*t78; /* omega_n*omega_n*gamma3*m*a3*a3*I1 */
    const double t80 = x[5]*t79; /* s*omega_n*omega_n*gamma3*m*a3*a3*I1 */
    const double t81 = t80/t66; /* s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t82 = 2.0*t81; /* 2*s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t83 = t76 + t82; /* t69 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t84 = t16*p[5]; /* m*a3*a3*I3 */
    const double t85 = x[3]*t84; /* omega_n*m*a3*a3*I3 */
    const double t86 = x[4]*t85; /* omega3*omega_n*m*a3*a3*I3 */
    const double t87 = t0*t86; /* s*s*omega3*omega_n*m*a3*a3*I3 */
    const double t88 = t87/t66; /* s*s*omega3*omega_n*m*a3*a3*I3/(D*D) */
    const double t89 = 2.0*t88; /* 2*s*s*omega3*omega_n*m*a3*a3*I3/(D*D) */
    const double t90 = t83 + t89; /* t83 + 2*s*s*omega3*omega_n*m*a3*a3*I3/(D*D) */
    const double t91 = p[1]*p[0]; /* R*m */
    const double t92 = p[3]*t91; /* a3*R*m */
    const double t93 = p[5]*t92; /* I3*a3*R*m */
    const double t94 = x[2]*t93; /* omega_tau*I3*a3*R*m */
    const double t95 = x[4]*t94; /* omega3*omega_tau*I3*a3*R*m */
    const double t96 = x[5]*t95; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t97 = p[1]*p[1]; /* R*R */
    const double t98 = p[0]*t97; /* m*R*R */
    const double t99 = p[4]*t98; /* I1*m*R*R */
    const double t100 = t0*t99; /* s*s*I1*m*R*R */
    const double t101 = p[6] + t100; /* I1*I3 + s*s*I1*m*R*R */
    const double t102 = p[0]*p[5]; /* m*I3 */
    const double t103 = t6*t6; /* b*b */
    const double t104 = t102*t103; /* m*I3*b*b */
    const double t105 = t101 + t104; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t106 = t96/t105; /* s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t107 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t108 = t106 + t107; /* s*omega3*omega_tau*I3*a3*R*m/Theta + omega_tau*omega_n */
    const double t109 = p[5]*t91; /* I3*R*m */
    const double t110 = x[3]*t109; /* omega_n*I3*R*m */
    const double t111 = p[3]*x[0]; /* a3*gamma3 */
    const double t112 = p[1] + t111; /* e = R + a3*gamma3 */
    const double t113 = x[2]*t112; /* omega_tau*e */
    const double t114 = x[1] + t113; /* V = v_nu + omega_tau*e */
    const double t115 = t110*t114; /* omega_n*I3*R*m*V */
    const double t116 = t115/t105; /* omega_n*I3*R*m*V/Theta */
    const double t117 = t108 - t116; /* s*omega3*omega_tau*I3*a3*R*m/Theta + omega_tau*omega_n - omega_n*I3*R*m*V/Theta */
    const double t118 = p[3]*p[0]; /* a3*m */
    const double t119 = p[5]*t118; /* I3*a3*m */
    const double t120 = x[2]*t119; /* omega_tau*I3*a3*m */
    const double t121 = x[3]*t120; /* omega_n*omega_tau*I3*a3*m */
    const double t122 = t6*t121; /* b*omega_n*omega_tau*I3*a3*m */
    const double t123 = t122/t105; /* b*omega_n*omega_tau*I3*a3*m/Theta */
    const double t124 = t117 - t123; /* t117 - b*omega_n*omega_tau*I3*a3*m/Theta */
    const double t125 = p[1]*t59; /* R*m*m */
    const double t126 = p[5]*p[5]; /* I3*I3 */
    const double t127 = t125*t126; /* R*m*m*I3*I3 */
    const double t128 = x[3]*t127; /* omega_n*R*m*m*I3*I3 */
    const double t129 = t103*t128; /* b*b*omega_n*R*m*m*I3*I3 */
    const double t130 = t105*t105; /* Theta*Theta */
    const double t131 = t114*t129; /* V*b*b*omega_n*R*m*m*I3*I3 */
    const double t132 = t131/t130; /* V*b*b*omega_n*R*m*m*I3*I3/(Theta*Theta) */
    const double t133 = 2.0*t132; /* 2*V*b*b*omega_n*R*m*m*I3*I3/(Theta*Theta) */
    const double t134 = t124 + t133; /* t117 - b*omega_n*omega_tau*I3*a3*m/Theta + 2*V*b*b*omega_n*R*m*m*I3*I3/(Theta*Theta) */
    const double t135 = p[5]*t126; /* I3*I3*I3 */
    const double t136 = t91*t135; /* R*m*I3*I3*I3 */
    const double t137 = x[2]*t136; /* omega_tau*R*m*I3*I3*I3 */
    const double t138 = x[4]*t137; /* omega3*omega_tau*R*m*I3*I3*I3 */
    const double t139 = x[5]*t138; /* s*omega3*omega_tau*R*m*I3*I3*I3 */
    const double t140 = t6*t139; /* b*s*omega3*omega_tau*R*m*I3*I3*I3 */
    const double t141 = t140/t130; /* b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t142 = 2.0*t141; /* 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t143 = t134 - t142; /* t134 - 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t144 = t59*t97; /* m*m*R*R */
    const double t145 = t126*t144; /* I3*I3*m*m*R*R */
    const double t146 = x[2]*t145; /* omega_tau*I3*I3*m*m*R*R */
    const double t147 = x[4]*t146; /* omega3*omega_tau*I3*I3*m*m*R*R */
    const double t148 = x[5]*t147; /* s*omega3*omega_tau*I3*I3*m*m*R*R */
    const double t149 = t6*t148; /* b*s*omega3*omega_tau*I3*I3*m*m*R*R */
    const double t150 = t112*t149; /* e*b*s*omega3*omega_tau*I3*I3*m*m*R*R */
    const double t151 = t150/t130; /* e*b*s*omega3*omega_tau*I3*I3*m*m*R*R/(Theta*Theta) */
    const double t152 = 2.0*t151; /* 2*e*b*s*omega3*omega_tau*I3*I3*m*m*R*R/(Theta*Theta) */
    const double t153 = t143 - t152; /* t134 - 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) - 2*e*b*s*omega3*omega_tau*I3*I3*m*m*R*R/(Theta*Theta) */
    const double t154 = x[3]*t102; /* omega_n*m*I3 */
    const double t155 = t6*t154; /* b*omega_n*m*I3 */
    const double t156 = t155/t105; /* b*omega_n*m*I3/Theta */
    const double t157 = -t156; /* -b*omega_n*m*I3/Theta */
    const double t158 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t159 = t112*t155; /* e*b*omega_n*m*I3 */
    const double t160 = t159/t105; /* e*b*omega_n*m*I3/Theta */
    const double t161 = t158 - t160; /* omega_n*gamma3 - e*b*omega_n*m*I3/Theta */
    const double t162 = x[4]*t126; /* omega3*I3*I3 */
    const double t163 = x[5]*t162; /* s*omega3*I3*I3 */
    const double t164 = t163/t105; /* s*omega3*I3*I3/Theta */
    const double t165 = t161 + t164; /* omega_n*gamma3 - e*b*omega_n*m*I3/Theta + s*omega3*I3*I3/Theta */
    const double t166 = x[4]*t109; /* omega3*I3*R*m */
    const double t167 = x[5]*t166; /* s*omega3*I3*R*m */
    const double t168 = t112*t167; /* e*s*omega3*I3*R*m */
    const double t169 = t168/t105; /* e*s*omega3*I3*R*m/Theta */
    const double t170 = t165 + t169; /* t165 + e*s*omega3*I3*R*m/Theta */
    const double t171 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t172 = t6*t102; /* b*m*I3 */
    const double t173 = t114*t172; /* V*b*m*I3 */
    const double t174 = t173/t105; /* V*b*m*I3/Theta */
    const double t175 = t171 - t174; /* omega_tau*gamma3 - V*b*m*I3/Theta */
    const double t176 = x[2]*t126; /* omega_tau*I3*I3 */
    const double t177 = x[5]*t176; /* s*omega_tau*I3*I3 */
    const double t178 = t177/t105; /* s*omega_tau*I3*I3/Theta */
    const double t179 = x[2]*t109; /* omega_tau*I3*R*m */
    const double t180 = x[5]*t179; /* s*omega_tau*I3*R*m */
    const double t181 = t112*t180; /* e*s*omega_tau*I3*R*m */
    const double t182 = t181/t105; /* e*s*omega_tau*I3*R*m/Theta */
    const double t183 = t178 + t182; /* s*omega_tau*I3*I3/Theta + e*s*omega_tau*I3*R*m/Theta */
    const double t184 = x[4]*t176; /* omega3*omega_tau*I3*I3 */
    const double t185 = t184/t105; /* omega3*omega_tau*I3*I3/Theta */
    const double t186 = x[4]*t179; /* omega3*omega_tau*I3*R*m */
    const double t187 = t112*t186; /* e*omega3*omega_tau*I3*R*m */
    const double t188 = t187/t105; /* e*omega3*omega_tau*I3*R*m/Theta */
    const double t189 = t185 + t188; /* omega3*omega_tau*I3*I3/Theta + e*omega3*omega_tau*I3*R*m/Theta */
    const double t190 = p[4]*t144; /* I1*m*m*R*R */
    const double t191 = p[5]*t190; /* I3*I1*m*m*R*R */
    const double t192 = x[3]*t191; /* omega_n*I3*I1*m*m*R*R */
    const double t193 = x[5]*t192; /* s*omega_n*I3*I1*m*m*R*R */
    const double t194 = t6*t193; /* b*s*omega_n*I3*I1*m*m*R*R */
    const double t195 = t114*t194; /* V*b*s*omega_n*I3*I1*m*m*R*R */
    const double t196 = t195/t130; /* V*b*s*omega_n*I3*I1*m*m*R*R/(Theta*Theta) */
    const double t197 = 2.0*t196; /* 2*V*b*s*omega_n*I3*I1*m*m*R*R/(Theta*Theta) */
    const double t198 = t189 + t197; /* t189 + 2*V*b*s*omega_n*I3*I1*m*m*R*R/(Theta*Theta) */
    const double t199 = t99*t126; /* I1*m*R*R*I3*I3 */
    const double t200 = x[2]*t199; /* omega_tau*I1*m*R*R*I3*I3 */
    const double t201 = x[4]*t200; /* omega3*omega_tau*I1*m*R*R*I3*I3 */
    const double t202 = t0*t201; /* s*s*omega3*omega_tau*I1*m*R*R*I3*I3 */
    const double t203 = t202/t130; /* s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t204 = 2.0*t203; /* 2*s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t205 = t198 - t204; /* t189 + 2*V*b*s*omega_n*I3*I1*m*m*R*R/(Theta*Theta) - 2*s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t206 = p[1]*t97; /* R*R*R */
    const double t207 = t59*t206; /* m*m*R*R*R */
    const double t208 = p[4]*t207; /* I1*m*m*R*R*R */
    const double t209 = p[5]*t208; /* I3*I1*m*m*R*R*R */
    const double t210 = x[2]*t209; /* omega_tau*I3*I1*m*m*R*R*R */
    const double t211 = x[4]*t210; /* omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t212 = t0*t211; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t213 = t112*t212; /* e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t214 = t213/t130; /* e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t215 = 2.0*t214; /* 2*e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t216 = t205 - t215; /* t205 - 2*e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t217 = p[4]*t92; /* I1*a3*R*m */
    const double t218 = x[2]*t217; /* omega_tau*I1*a3*R*m */
    const double t219 = x[3]*t218; /* omega_n*omega_tau*I1*a3*R*m */
    const double t220 = x[5]*t219; /* s*omega_n*omega_tau*I1*a3*R*m */
    const double t221 = t220/t105; /* s*omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t222 = t197 - t221; /* 2*V*b*s*omega_n*I3*I1*m*m*R*R/(Theta*Theta) - s*omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t223 = x[2]*t98; /* omega_tau*m*R*R */
    const double t224 = x[4]*t223; /* omega3*omega_tau*m*R*R */
    const double t225 = t0*t224; /* s*s*omega3*omega_tau*m*R*R */
    const double t226 = t225*p[7]; /* s*s*omega3*omega_tau*m*R*R*(I1 - I3) */
    const double t227 = t226/t105; /* s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t228 = t222 + t227; /* t222 + s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t229 = p[5]*t207; /* I3*m*m*R*R*R */
    const double t230 = x[0]*t229; /* gamma3*I3*m*m*R*R*R */
    const double t231 = x[2]*t230; /* omega_tau*gamma3*I3*m*m*R*R*R */
    const double t232 = x[4]*t231; /* omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t233 = t0*t232; /* s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t234 = t6*t233; /* b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t235 = p[7]*t234; /* (I1 - I3)*b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t236 = t235/t130; /* (I1 - I3)*b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t237 = 2.0*t236; /* 2*t236 */
    const double t238 = t228 - t237; /* t222 + s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta - 2*t236 */
    const double t239 = p[3]*t144; /* a3*m*m*R*R */
    const double t240 = t126*t239; /* I3*I3*a3*m*m*R*R */
    const double t241 = x[2]*t240; /* omega_tau*I3*I3*a3*m*m*R*R */
    const double t242 = x[4]*t241; /* omega3*omega_tau*I3*I3*a3*m*m*R*R */
    const double t243 = t0*t242; /* s*s*omega3*omega_tau*I3*I3*a3*m*m*R*R */
    const double t244 = t6*t243; /* b*s*s*omega3*omega_tau*I3*I3*a3*m*m*R*R */
    const double t245 = t244/t130; /* b*s*s*omega3*omega_tau*I3*I3*a3*m*m*R*R/(Theta*Theta) */
    const double t246 = 2.0*t245; /* 2*b*s*s*omega3*omega_tau*I3*I3*a3*m*m*R*R/(Theta*Theta) */
    const double t247 = t238 + t246; /* t222 + s*s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta - 2*t236 + 2*b*s*s*omega3*omega_tau*I3*I3*a3*m*m*R*R/(Theta*Theta) */
    const double t248 = p[4]*t91; /* I1*R*m */
    const double t249 = x[3]*t248; /* omega_n*I1*R*m */
    const double t250 = x[5]*t249; /* s*omega_n*I1*R*m */
    const double t251 = t250/t105; /* s*omega_n*I1*R*m/Theta */
    const double t252 = -t251; /* -s*omega_n*I1*R*m/Theta */
    const double t253 = t112*t250; /* e*s*omega_n*I1*R*m */
    const double t254 = t253/t105; /* e*s*omega_n*I1*R*m/Theta */
    const double t255 = x[0]*t98; /* gamma3*m*R*R */
    const double t256 = x[4]*t255; /* omega3*gamma3*m*R*R */
    const double t257 = t0*t256; /* s*s*omega3*gamma3*m*R*R */
    const double t258 = p[7]*t257; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R */
    const double t259 = t258/t105; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta */
    const double t260 = t259 - t254; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta - e*s*omega_n*I1*R*m/Theta */
    const double t261 = x[4]*t93; /* omega3*I3*a3*R*m */
    const double t262 = t0*t261; /* s*s*omega3*I3*a3*R*m */
    const double t263 = t262/t105; /* s*s*omega3*I3*a3*R*m/Theta */
    const double t264 = t260 - t263; /* t260 - s*s*omega3*I3*a3*R*m/Theta */
    const double t265 = x[5]*t248; /* s*I1*R*m */
    const double t266 = t114*t265; /* V*s*I1*R*m */
    const double t267 = t266/t105; /* V*s*I1*R*m/Theta */
    const double t268 = -t267; /* -V*s*I1*R*m/Theta */
    const double t269 = x[2]*t255; /* omega_tau*gamma3*m*R*R */
    const double t270 = t0*t269; /* s*s*omega_tau*gamma3*m*R*R */
    const double t271 = p[7]*t270; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R */
    const double t272 = t271/t105; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta */
    const double t273 = t0*t94; /* s*s*omega_tau*I3*a3*R*m */
    const double t274 = t273/t105; /* s*s*omega_tau*I3*a3*R*m/Theta */
    const double t275 = t272 - t274; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta - s*s*omega_tau*I3*a3*R*m/Theta */
    const double t276 = t114*t249; /* V*omega_n*I1*R*m */
    const double t277 = t276/t105; /* V*omega_n*I1*R*m/Theta */
    const double t278 = x[4]*t269; /* omega3*omega_tau*gamma3*m*R*R */
    const double t279 = x[5]*t278; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t280 = p[7]*t279; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t281 = t280/t105; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t282 = 2.0*t281; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t283 = t282 - t277; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta - V*omega_n*I1*R*m/Theta */
    const double t284 = 2.0*t106; /* 2*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t285 = t283 - t284; /* t283 - 2*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t286 = p[4]*p[4]; /* I1*I1 */
    const double t287 = t207*t286; /* m*m*R*R*R*I1*I1 */
    const double t288 = x[3]*t287; /* omega_n*m*m*R*R*R*I1*I1 */
    const double t289 = t0*t288; /* s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t290 = t114*t289; /* V*s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t291 = t290/t130; /* V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t292 = 2.0*t291; /* 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t293 = t285 + t292; /* t283 - 2*s*omega3*omega_tau*I3*a3*R*m/Theta + 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t294 = t97*t97; /* R*R*R*R */
    const double t295 = t59*t294; /* m*m*R*R*R*R */
    const double t296 = p[4]*t295; /* I1*m*m*R*R*R*R */
    const double t297 = x[0]*t296; /* gamma3*I1*m*m*R*R*R*R */
    const double t298 = x[2]*t297; /* omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t299 = x[4]*t298; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t300 = t64*t299; /* s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t301 = p[7]*t300; /* (I1 - I3)*s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t302 = t301/t130; /* (I1 - I3)*s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t303 = 2.0*t302; /* 2*t302 */
    const double t304 = t293 - t303; /* t293 - 2*t302 */
    const double t305 = p[3]*t207; /* a3*m*m*R*R*R */
    const double t306 = p[4]*t305; /* I1*a3*m*m*R*R*R */
    const double t307 = p[5]*t306; /* I3*I1*a3*m*m*R*R*R */
    const double t308 = x[2]*t307; /* omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t309 = x[4]*t308; /* omega3*omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t310 = t64*t309; /* s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t311 = t310/t130; /* s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t312 = 2.0*t311; /* 2*s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t313 = t304 + t312; /* t293 - 2*t302 + 2*s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t314 = x[5]*x[2]; /* s*omega_tau */
    const double t315 = -t314; /* -s*omega_tau */
    const double t316 = x[5]*x[0]; /* s*gamma3 */
    const double t317 = -t316; /* -s*gamma3 */
    const double t318 = -t171; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t2;
    out[6] = t4;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t11;
    out[10] = t13;
    out[11] = t14;
    out[12] = t25;
    out[13] = 0.0;
    out[14] = t31;
    out[15] = t40;
    out[16] = t44;
    out[17] = t90;
    out[18] = t153;
    out[19] = t157;
    out[20] = t170;
    out[21] = t175;
    out[22] = t183;
    out[23] = t216;
    out[24] = t247;
    out[25] = t252;
    out[26] = t264;
    out[27] = t268;
    out[28] = t275;
    out[29] = t313;
    out[30] = t315;
    out[31] = 0.0;
    out[32] = t317;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = t318;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = p[1]*x[0]; /* R*gamma3 */
    const double t4 = p[3] + t3; /* b = a3 + R*gamma3 */
    const double t5 = t2*t4; /* omega_n*omega_n*b */
    const double t6 = x[3]*p[1]; /* omega_n*R */
    const double t7 = t6*x[4]; /* omega_n*R*omega3 */
    const double t8 = x[5]*t7; /* s*omega_n*R*omega3 */
    const double t9 = t5 + t8; /* omega_n*omega_n*b + s*omega_n*R*omega3 */
    const double t10 = p[3]*p[3]; /* a3*a3 */
    const double t11 = p[0]*t10; /* m*a3*a3 */
    const double t12 = x[0]*t11; /* gamma3*m*a3*a3 */
    const double t13 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t14 = t12*t13; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t15 = t0*t14; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t16 = t0*t11; /* s*s*m*a3*a3 */
    const double t17 = p[4] + t16; /* D = I1 + s*s*m*a3*a3 */
    const double t18 = t15/t17; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t19 = p[0]*p[2]; /* m*g */
    const double t20 = p[3]*t19; /* a3*m*g */
    const double t21 = t0*t20; /* s*s*a3*m*g */
    const double t22 = t21/t17; /* s*s*a3*m*g/D */
    const double t23 = t18 - t22; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t24 = x[0]*p[4]; /* gamma3*I1 */
    const double t25 = t2*t24; /* omega_n*omega_n*gamma3*I1 */
    const double t26 = t25/t17; /* omega_n*omega_n*gamma3*I1/D */
    const double t27 = t23 - t26; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - omega_n*omega_n*gamma3*I1/D */
    const double t28 = x[3]*p[5]; /* omega_n*I3 */
    const double t29 = x[4]*t28; /* omega3*omega_n*I3 */
    const double t30 = x[5]*t29; /* s*omega3*omega_n*I3 */
    const double t31 = t30/t17; /* s*omega3*omega_n*I3/D */
    const double t32 = t27 - t31; /* t27 - s*omega3*omega_n*I3/D */
    const double t33 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t34 = x[3]*t33; /* omega_n*omega_tau*gamma3 */
    const double t35 = p[0]*p[5]; /* m*I3 */
    const double t36 = x[3]*t35; /* omega_n*m*I3 */
    const double t37 = t4*t36; /* b*omega_n*m*I3 */
    const double t38 = p[1]*p[1]; /* R*R */
    const double t39 = p[0]*t38; /* m*R*R */
    const double t40 = p[4]*t39; /* I1*m*R*R */
    const double t41 = t0*t40; /* s*s*I1*m*R*R */
    const double t42 = p[6] + t41; /* I1*I3 + s*s*I1*m*R*R */
    const double t43 = t4*t4; /* b*b */
    const double t44 = t35*t43; /* m*I3*b*b */
    const double t45 = t42 + t44; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t46 = p[3]*x[0]; /* a3*gamma3 */
    const double t47 = p[1] + t46; /* e = R + a3*gamma3 */
    const double t48 = x[2]*t47; /* omega_tau*e */
    const double t49 = x[1] + t48; /* V = v_nu + omega_tau*e */
    const double t50 = t37*t49; /* b*omega_n*m*I3*V */
    const double t51 = t50/t45; /* b*omega_n*m*I3*V/Theta */
    const double t52 = t34 - t51; /* omega_n*omega_tau*gamma3 - b*omega_n*m*I3*V/Theta */
    const double t53 = p[5]*p[5]; /* I3*I3 */
    const double t54 = x[2]*t53; /* omega_tau*I3*I3 */
    const double t55 = x[4]*t54; /* omega3*omega_tau*I3*I3 */
    const double t56 = x[5]*t55; /* s*omega3*omega_tau*I3*I3 */
    const double t57 = t56/t45; /* s*omega3*omega_tau*I3*I3/Theta */
    const double t58 = t52 + t57; /* omega_n*omega_tau*gamma3 - b*omega_n*m*I3*V/Theta + s*omega3*omega_tau*I3*I3/Theta */
    const double t59 = p[1]*p[0]; /* R*m */
    const double t60 = p[5]*t59; /* I3*R*m */
    const double t61 = x[2]*t60; /* omega_tau*I3*R*m */
    const double t62 = x[4]*t61; /* omega3*omega_tau*I3*R*m */
    const double t63 = x[5]*t62; /* s*omega3*omega_tau*I3*R*m */
    const double t64 = t47*t63; /* e*s*omega3*omega_tau*I3*R*m */
    const double t65 = t64/t45; /* e*s*omega3*omega_tau*I3*R*m/Theta */
    const double t66 = t58 + t65; /* t58 + e*s*omega3*omega_tau*I3*R*m/Theta */
    const double t67 = p[4]*t59; /* I1*R*m */
    const double t68 = x[3]*t67; /* omega_n*I1*R*m */
    const double t69 = x[5]*t68; /* s*omega_n*I1*R*m */
    const double t70 = t49*t69; /* V*s*omega_n*I1*R*m */
    const double t71 = t70/t45; /* V*s*omega_n*I1*R*m/Theta */
    const double t72 = x[0]*t39; /* gamma3*m*R*R */
    const double t73 = x[2]*t72; /* omega_tau*gamma3*m*R*R */
    const double t74 = x[4]*t73; /* omega3*omega_tau*gamma3*m*R*R */
    const double t75 = t0*t74; /* s*s*omega3*omega_tau*gamma3*m*R*R */
    const double t76 = t75*p[7]; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t77 = t76/t45; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t78 = t77 - t71; /* s*s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - V*s*omega_n*I1*R*m/Theta */
    const double t79 = p[3]*t59; /* a3*R*m */
    const double t80 = p[5]*t79; /* I3*a3*R*m */
    const double t81 = x[2]*t80; /* omega_tau*I3*a3*R*m */
    const double t82 = x[4]*t81; /* omega3*omega_tau*I3*a3*R*m */
    const double t83 = t0*t82; /* s*s*omega3*omega_tau*I3*a3*R*m */
    const double t84 = t83/t45; /* s*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t85 = t78 - t84; /* t78 - s*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t86 = -t33; /* -omega_tau*gamma3 */
    const double t87 = x[5]*t33; /* s*omega_tau*gamma3 */
    const double t88 = -t87; /* -s*omega_tau*gamma3 */
    const double t89 = x[2]*2.0; /* omega_tau*2 */
    const double t90 = x[5]*t89; /* s*omega_tau*2 */
    const double t91 = t2*p[1]; /* omega_n*omega_n*R */
    const double t92 = x[3]*t4; /* omega_n*b */
    const double t93 = 2.0*t92; /* 2*omega_n*b */
    const double t94 = p[1]*x[4]; /* R*omega3 */
    const double t95 = x[5]*t94; /* s*R*omega3 */
    const double t96 = t93 + t95; /* 2*omega_n*b + s*R*omega3 */
    const double t97 = x[5]*t6; /* s*omega_n*R */
    const double t98 = t11*t13; /* m*a3*a3*omega_tau*omega_tau */
    const double t99 = t0*t98; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t100 = t99/t17; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t101 = t2*p[4]; /* omega_n*omega_n*I1 */
    const double t102 = t101/t17; /* omega_n*omega_n*I1/D */
    const double t103 = t100 - t102; /* s*s*m*a3*a3*omega_tau*omega_tau/D - omega_n*omega_n*I1/D */
    const double t104 = p[0]*2.0; /* m*2 */
    const double t105 = t10*t104; /* a3*a3*m*2 */
    const double t106 = x[0]*t105; /* gamma3*a3*a3*m*2 */
    const double t107 = x[2]*t106; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t108 = t0*t107; /* s*s*omega_tau*gamma3*a3*a3*m*2 */
    const double t109 = t108/t17; /* s*s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t110 = x[3]*t24; /* omega_n*gamma3*I1 */
    const double t111 = t110/t17; /* omega_n*gamma3*I1/D */
    const double t112 = 2.0*t111; /* 2*omega_n*gamma3*I1/D */
    const double t113 = -t112; /* -2*omega_n*gamma3*I1/D */
    const double t114 = x[4]*p[5]; /* omega3*I3 */
    const double t115 = x[5]*t114; /* s*omega3*I3 */
    const double t116 = t115/t17; /* s*omega3*I3/D */
    const double t117 = t113 - t116; /* -2*omega_n*gamma3*I1/D - s*omega3*I3/D */
    const double t118 = x[5]*t28; /* s*omega_n*I3 */
    const double t119 = t118/t17; /* s*omega_n*I3/D */
    const double t120 = -t119; /* -s*omega_n*I3/D */
    const double t121 = x[5]*t14; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t122 = t121/t17; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t123 = 2.0*t122; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t124 = x[5]*t20; /* s*a3*m*g */
    const double t125 = t124/t17; /* s*a3*m*g/D */
    const double t126 = 2.0*t125; /* 2*s*a3*m*g/D */
    const double t127 = t123 - t126; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D */
    const double t128 = t29/t17; /* omega3*omega_n*I3/D */
    const double t129 = t127 - t128; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D - omega3*omega_n*I3/D */
    const double t130 = p[0]*p[0]; /* m*m */
    const double t131 = t10*t10; /* a3*a3*a3*a3 */
    const double t132 = t130*t131; /* m*m*a3*a3*a3*a3 */
    const double t133 = x[0]*t132; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t134 = t13*t133; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t135 = x[5]*t0; /* s*s*s */
    const double t136 = t134*t135; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t137 = t17*t17; /* D*D */
    const double t138 = t136/t137; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t139 = 2.0*t138; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t140 = t129 - t139; /* t129 - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t141 = p[2]*t130; /* g*m*m */
    const double t142 = p[3]*t10; /* a3*a3*a3 */
    const double t143 = t141*t142; /* g*m*m*a3*a3*a3 */
    const double t144 = t135*t143; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t145 = t144/t137; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t146 = 2.0*t145; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t147 = t140 + t146; /* t140 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t148 = t11*p[4]; /* m*a3*a3*I1 */
    const double t149 = x[0]*t148; /* gamma3*m*a3*a3*I1 */
    const double t150 = t2*t149; /* omega_n*omega_n*gamma3*m*a3*a3*I1 */
    const double t151 = x[5]*t150; /* s*omega_n*omega_n*gamma3*m*a3*a3*I1 */
    const double t152 = t151/t137; /* s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t153 = 2.0*t152; /* 2*s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t154 = t147 + t153; /* t140 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t155 = t11*p[5]; /* m*a3*a3*I3 */
    const double t156 = x[3]*t155; /* omega_n*m*a3*a3*I3 */
    const double t157 = x[4]*t156; /* omega3*omega_n*m*a3*a3*I3 */
    const double t158 = t0*t157; /* s*s*omega3*omega_n*m*a3*a3*I3 */
    const double t159 = t158/t137; /* s*s*omega3*omega_n*m*a3*a3*I3/(D*D) */
    const double t160 = 2.0*t159; /* 2*s*s*omega3*omega_n*m*a3*a3*I3/(D*D) */
    const double t161 = t154 + t160; /* t154 + 2*s*s*omega3*omega_n*m*a3*a3*I3/(D*D) */
    const double t162 = x[5]*t82; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t163 = t162/t45; /* s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t164 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t165 = t163 + t164; /* s*omega3*omega_tau*I3*a3*R*m/Theta + omega_tau*omega_n */
    const double t166 = x[3]*t60; /* omega_n*I3*R*m */
    const double t167 = t49*t166; /* V*omega_n*I3*R*m */
    const double t168 = t167/t45; /* V*omega_n*I3*R*m/Theta */
    const double t169 = t165 - t168; /* s*omega3*omega_tau*I3*a3*R*m/Theta + omega_tau*omega_n - V*omega_n*I3*R*m/Theta */
    const double t170 = p[3]*p[0]; /* a3*m */
    const double t171 = p[5]*t170; /* I3*a3*m */
    const double t172 = x[2]*t171; /* omega_tau*I3*a3*m */
    const double t173 = x[3]*t172; /* omega_n*omega_tau*I3*a3*m */
    const double t174 = t4*t173; /* b*omega_n*omega_tau*I3*a3*m */
    const double t175 = t174/t45; /* b*omega_n*omega_tau*I3*a3*m/Theta */
    const double t176 = t169 - t175; /* t169 - b*omega_n*omega_tau*I3*a3*m/Theta */
    const double t177 = p[1]*t130; /* R*m*m */
    const double t178 = t53*t177; /* I3*I3*R*m*m */
    const double t179 = x[3]*t178; /* omega_n*I3*I3*R*m*m */
    const double t180 = t43*t179; /* b*b*omega_n*I3*I3*R*m*m */
    const double t181 = t45*t45; /* Theta*Theta */
    const double t182 = t49*t180; /* V*b*b*omega_n*I3*I3*R*m*m */
    const double t183 = t182/t181; /* V*b*b*omega_n*I3*I3*R*m*m/(Theta*Theta) */
    const double t184 = 2.0*t183; /* 2*V*b*b*omega_n*I3*I3*R*m*m/(Theta*Theta) */
    const double t185 = t176 + t184; /* t169 - b*omega_n*omega_tau*I3*a3*m/Theta + 2*V*b*b*omega_n*I3*I3*R*m*m/(Theta*Theta) */
    const double t186 = p[5]*t53; /* I3*I3*I3 */
    const double t187 = t59*t186; /* R*m*I3*I3*I3 */
    const double t188 = x[2]*t187; /* omega_tau*R*m*I3*I3*I3 */
    const double t189 = x[4]*t188; /* omega3*omega_tau*R*m*I3*I3*I3 */
    const double t190 = x[5]*t189; /* s*omega3*omega_tau*R*m*I3*I3*I3 */
    const double t191 = t4*t190; /* b*s*omega3*omega_tau*R*m*I3*I3*I3 */
    const double t192 = t191/t181; /* b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t193 = 2.0*t192; /* 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t194 = t185 - t193; /* t185 - 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) */
    const double t195 = t38*t130; /* R*R*m*m */
    const double t196 = t53*t195; /* I3*I3*R*R*m*m */
    const double t197 = x[2]*t196; /* omega_tau*I3*I3*R*R*m*m */
    const double t198 = x[4]*t197; /* omega3*omega_tau*I3*I3*R*R*m*m */
    const double t199 = x[5]*t198; /* s*omega3*omega_tau*I3*I3*R*R*m*m */
    const double t200 = t4*t199; /* b*s*omega3*omega_tau*I3*I3*R*R*m*m */
    const double t201 = t47*t200; /* e*b*s*omega3*omega_tau*I3*I3*R*R*m*m */
    const double t202 = t201/t181; /* e*b*s*omega3*omega_tau*I3*I3*R*R*m*m/(Theta*Theta) */
    const double t203 = 2.0*t202; /* 2*e*b*s*omega3*omega_tau*I3*I3*R*R*m*m/(Theta*Theta) */
    const double t204 = t194 - t203; /* t185 - 2*b*s*omega3*omega_tau*R*m*I3*I3*I3/(Theta*Theta) - 2*e*b*s*omega3*omega_tau*I3*I3*R*R*m*m/(Theta*Theta) */
    const double t205 = t37/t45; /* b*omega_n*m*I3/Theta */
    const double t206 = -t205; /* -b*omega_n*m*I3/Theta */
    const double t207 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t208 = t37*t47; /* b*omega_n*m*I3*e */
    const double t209 = t208/t45; /* b*omega_n*m*I3*e/Theta */
    const double t210 = t207 - t209; /* omega_n*gamma3 - b*omega_n*m*I3*e/Theta */
    const double t211 = x[4]*t53; /* omega3*I3*I3 */
    const double t212 = x[5]*t211; /* s*omega3*I3*I3 */
    const double t213 = t212/t45; /* s*omega3*I3*I3/Theta */
    const double t214 = t210 + t213; /* omega_n*gamma3 - b*omega_n*m*I3*e/Theta + s*omega3*I3*I3/Theta */
    const double t215 = x[4]*t60; /* omega3*I3*R*m */
    const double t216 = x[5]*t215; /* s*omega3*I3*R*m */
    const double t217 = t47*t216; /* e*s*omega3*I3*R*m */
    const double t218 = t217/t45; /* e*s*omega3*I3*R*m/Theta */
    const double t219 = t214 + t218; /* t214 + e*s*omega3*I3*R*m/Theta */
    const double t220 = t4*t35; /* b*m*I3 */
    const double t221 = t49*t220; /* V*b*m*I3 */
    const double t222 = t221/t45; /* V*b*m*I3/Theta */
    const double t223 = t33 - t222; /* omega_tau*gamma3 - V*b*m*I3/Theta */
    const double t224 = x[5]*t54; /* s*omega_tau*I3*I3 */
    const double t225 = t224/t45; /* s*omega_tau*I3*I3/Theta */
    const double t226 = x[5]*t61; /* s*omega_tau*I3*R*m */
    const double t227 = t47*t226; /* e*s*omega_tau*I3*R*m */
    const double t228 = t227/t45; /* e*s*omega_tau*I3*R*m/Theta */
    const double t229 = t225 + t228; /* s*omega_tau*I3*I3/Theta + e*s*omega_tau*I3*R*m/Theta */
    const double t230 = t55/t45; /* omega3*omega_tau*I3*I3/Theta */
    const double t231 = t47*t62; /* e*omega3*omega_tau*I3*R*m */
    const double t232 = t231/t45; /* e*omega3*omega_tau*I3*R*m/Theta */
    const double t233 = t230 + t232; /* omega3*omega_tau*I3*I3/Theta + e*omega3*omega_tau*I3*R*m/Theta */
    const double t234 = p[4]*t195; /* I1*R*R*m*m */
    const double t235 = p[5]*t234; /* I3*I1*R*R*m*m */
    const double t236 = x[3]*t235; /* omega_n*I3*I1*R*R*m*m */
    const double t237 = x[5]*t236; /* s*omega_n*I3*I1*R*R*m*m */
    const double t238 = t4*t237; /* b*s*omega_n*I3*I1*R*R*m*m */
    const double t239 = t49*t238; /* V*b*s*omega_n*I3*I1*R*R*m*m */
    const double t240 = t239/t181; /* V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t241 = 2.0*t240; /* 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t242 = t233 + t241; /* t233 + 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) */
    const double t243 = t40*t53; /* I1*m*R*R*I3*I3 */
    const double t244 = x[2]*t243; /* omega_tau*I1*m*R*R*I3*I3 */
    const double t245 = x[4]*t244; /* omega3*omega_tau*I1*m*R*R*I3*I3 */
    const double t246 = t0*t245; /* s*s*omega3*omega_tau*I1*m*R*R*I3*I3 */
    const double t247 = t246/t181; /* s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t248 = 2.0*t247; /* 2*s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t249 = t242 - t248; /* t233 + 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) - 2*s*s*omega3*omega_tau*I1*m*R*R*I3*I3/(Theta*Theta) */
    const double t250 = p[1]*t38; /* R*R*R */
    const double t251 = t130*t250; /* m*m*R*R*R */
    const double t252 = p[4]*t251; /* I1*m*m*R*R*R */
    const double t253 = p[5]*t252; /* I3*I1*m*m*R*R*R */
    const double t254 = x[2]*t253; /* omega_tau*I3*I1*m*m*R*R*R */
    const double t255 = x[4]*t254; /* omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t256 = t0*t255; /* s*s*omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t257 = t47*t256; /* e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R */
    const double t258 = t257/t181; /* e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t259 = 2.0*t258; /* 2*e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t260 = t249 - t259; /* t249 - 2*e*s*s*omega3*omega_tau*I3*I1*m*m*R*R*R/(Theta*Theta) */
    const double t261 = p[4]*t79; /* I1*a3*R*m */
    const double t262 = x[2]*t261; /* omega_tau*I1*a3*R*m */
    const double t263 = x[3]*t262; /* omega_n*omega_tau*I1*a3*R*m */
    const double t264 = x[5]*t263; /* s*omega_n*omega_tau*I1*a3*R*m */
    const double t265 = t264/t45; /* s*omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t266 = t241 - t265; /* 2*V*b*s*omega_n*I3*I1*R*R*m*m/(Theta*Theta) - s*omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t267 = x[2]*t39; /* omega_tau*m*R*R */
    const double t268 = x[4]*t267; /* omega3*omega_tau*m*R*R */
    const double t269 = t0*t268; /* s*s*omega3*omega_tau*m*R*R */
    const double t270 = p[7]*t269; /* (I1 - I3)*s*s*omega3*omega_tau*m*R*R */
    const double t271 = t270/t45; /* (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta */
    const double t272 = t266 + t271; /* t266 + (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta */
    const double t273 = p[5]*t251; /* I3*m*m*R*R*R */
    const double t274 = x[0]*t273; /* gamma3*I3*m*m*R*R*R */
    const double t275 = x[2]*t274; /* omega_tau*gamma3*I3*m*m*R*R*R */
    const double t276 = x[4]*t275; /* omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t277 = t0*t276; /* s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t278 = t4*t277; /* b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t279 = p[7]*t278; /* (I1 - I3)*b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R */
    const double t280 = t279/t181; /* (I1 - I3)*b*s*s*omega3*omega_tau*gamma3*I3*m*m*R*R*R/(Theta*Theta) */
    const double t281 = 2.0*t280; /* 2*t280 */
    const double t282 = t272 - t281; /* t266 + (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta - 2*t280 */
    const double t283 = p[3]*t195; /* a3*R*R*m*m */
    const double t284 = t53*t283; /* I3*I3*a3*R*R*m*m */
    const double t285 = x[2]*t284; /* omega_tau*I3*I3*a3*R*R*m*m */
    const double t286 = x[4]*t285; /* omega3*omega_tau*I3*I3*a3*R*R*m*m */
    const double t287 = t0*t286; /* s*s*omega3*omega_tau*I3*I3*a3*R*R*m*m */
    const double t288 = t4*t287; /* b*s*s*omega3*omega_tau*I3*I3*a3*R*R*m*m */
    const double t289 = t288/t181; /* b*s*s*omega3*omega_tau*I3*I3*a3*R*R*m*m/(Theta*Theta) */
    const double t290 = 2.0*t289; /* 2*b*s*s*omega3*omega_tau*I3*I3*a3*R*R*m*m/(Theta*Theta) */
    const double t291 = t282 + t290; /* t266 + (I1 - I3)*s*s*omega3*omega_tau*m*R*R/Theta - 2*t280 + 2*b*s*s*omega3*omega_tau*I3*I3*a3*R*R*m*m/(Theta*Theta) */
    const double t292 = t69/t45; /* s*omega_n*I1*R*m/Theta */
    const double t293 = -t292; /* -s*omega_n*I1*R*m/Theta */
    const double t294 = t47*t69; /* e*s*omega_n*I1*R*m */
    const double t295 = t294/t45; /* e*s*omega_n*I1*R*m/Theta */
    const double t296 = x[4]*t72; /* omega3*gamma3*m*R*R */
    const double t297 = t0*t296; /* s*s*omega3*gamma3*m*R*R */
    const double t298 = p[7]*t297; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R */
    const double t299 = t298/t45; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta */
    const double t300 = t299 - t295; /* (I1 - I3)*s*s*omega3*gamma3*m*R*R/Theta - e*s*omega_n*I1*R*m/Theta */
    const double t301 = x[4]*t80; /* omega3*I3*a3*R*m */
    const double t302 = t0*t301; /* s*s*omega3*I3*a3*R*m */
    const double t303 = t302/t45; /* s*s*omega3*I3*a3*R*m/Theta */
    const double t304 = t300 - t303; /* t300 - s*s*omega3*I3*a3*R*m/Theta */
    const double t305 = x[5]*t67; /* s*I1*R*m */
    const double t306 = t49*t305; /* V*s*I1*R*m */
    const double t307 = t306/t45; /* V*s*I1*R*m/Theta */
    const double t308 = -t307; /* -V*s*I1*R*m/Theta */
    const double t309 = t0*t73; /* s*s*omega_tau*gamma3*m*R*R */
    const double t310 = p[7]*t309; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R */
    const double t311 = t310/t45; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta */
    const double t312 = t0*t81; /* s*s*omega_tau*I3*a3*R*m */
    const double t313 = t312/t45; /* s*s*omega_tau*I3*a3*R*m/Theta */
    const double t314 = t311 - t313; /* (I1 - I3)*s*s*omega_tau*gamma3*m*R*R/Theta - s*s*omega_tau*I3*a3*R*m/Theta */
    const double t315 = t49*t68; /* V*omega_n*I1*R*m */
    const double t316 = t315/t45; /* V*omega_n*I1*R*m/Theta */
    const double t317 = x[5]*t74; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t318 = p[7]*t317; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t319 = t318/t45; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t320 = 2.0*t319; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta */
    const double t321 = t320 - t316; /* 2*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/Theta - V*omega_n*I1*R*m/Theta */
    const double t322 = 2.0*t163; /* 2*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t323 = t321 - t322; /* t321 - 2*s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t324 = p[4]*p[4]; /* I1*I1 */
    const double t325 = t251*t324; /* m*m*R*R*R*I1*I1 */
    const double t326 = x[3]*t325; /* omega_n*m*m*R*R*R*I1*I1 */
    const double t327 = t0*t326; /* s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t328 = t49*t327; /* V*s*s*omega_n*m*m*R*R*R*I1*I1 */
    const double t329 = t328/t181; /* V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t330 = 2.0*t329; /* 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t331 = t323 + t330; /* t321 - 2*s*omega3*omega_tau*I3*a3*R*m/Theta + 2*V*s*s*omega_n*m*m*R*R*R*I1*I1/(Theta*Theta) */
    const double t332 = t38*t38; /* R*R*R*R */
    const double t333 = t130*t332; /* m*m*R*R*R*R */
    const double t334 = p[4]*t333; /* I1*m*m*R*R*R*R */
    const double t335 = x[0]*t334; /* gamma3*I1*m*m*R*R*R*R */
    const double t336 = x[2]*t335; /* omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t337 = x[4]*t336; /* omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t338 = t135*t337; /* s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t339 = p[7]*t338; /* (I1 - I3)*s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R */
    const double t340 = t339/t181; /* (I1 - I3)*s*s*s*omega3*omega_tau*gamma3*I1*m*m*R*R*R*R/(Theta*Theta) */
    const double t341 = 2.0*t340; /* 2*t340 */
    const double t342 = t331 - t341; /* t331 - 2*t340 */
    const double t343 = p[3]*t251; /* a3*m*m*R*R*R */
    const double t344 = p[4]*t343; /* I1*a3*m*m*R*R*R */
    const double t345 = p[5]*t344; /* I3*I1*a3*m*m*R*R*R */
    const double t346 = x[2]*t345; /* omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t347 = x[4]*t346; /* omega3*omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t348 = t135*t347; /* s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R */
    const double t349 = t348/t181; /* s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t350 = 2.0*t349; /* 2*s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t351 = t342 + t350; /* t331 - 2*t340 + 2*s*s*s*omega3*omega_tau*I3*I1*a3*m*m*R*R*R/(Theta*Theta) */
    const double t352 = x[2]*x[5]; /* omega_tau*s */
    const double t353 = -t352; /* -omega_tau*s */
    const double t354 = x[5]*x[0]; /* s*gamma3 */
    const double t355 = -t354; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t9;
    out[2] = t32;
    out[3] = t66;
    out[4] = t85;
    out[5] = t88;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t90;
    out[12] = t91;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t96;
    out[16] = t97;
    out[17] = t7;
    out[18] = t103;
    out[19] = 0.0;
    out[20] = t109;
    out[21] = t117;
    out[22] = t120;
    out[23] = t161;
    out[24] = t204;
    out[25] = t206;
    out[26] = t219;
    out[27] = t223;
    out[28] = t229;
    out[29] = t260;
    out[30] = t291;
    out[31] = t293;
    out[32] = t304;
    out[33] = t308;
    out[34] = t314;
    out[35] = t351;
    out[36] = t353;
    out[37] = 0.0;
    out[38] = t355;
    out[39] = 0.0;
    out[40] = 0.0;
    out[41] = t86;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*p[3]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = t2*x[2]; /* m*a3*a3*gamma3*omega_tau */
    const double t4 = x[5]*x[5]; /* s*s */
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
    const double t18 = p[6] + t17; /* I1*I3 + s*s*I1*m*R*R */
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
    const double t29 = x[0]*t15; /* gamma3*m*R*R */
    const double t30 = x[2]*t29; /* omega_tau*gamma3*m*R*R */
    const double t31 = t4*t30; /* s*s*omega_tau*gamma3*m*R*R */
    const double t32 = t31*p[7]; /* s*s*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t33 = t32/t21; /* s*s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t34 = t28 + t33; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 - m*I3*b*V/Theta + s*s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t35 = p[0]*p[1]; /* m*R */
    const double t36 = p[3]*t35; /* a3*m*R */
    const double t37 = p[5]*t36; /* I3*a3*m*R */
    const double t38 = x[2]*t37; /* omega_tau*I3*a3*m*R */
    const double t39 = t4*t38; /* s*s*omega_tau*I3*a3*m*R */
    const double t40 = t39/t21; /* s*s*omega_tau*I3*a3*m*R/Theta */
    const double t41 = t34 - t40; /* t34 - s*s*omega_tau*I3*a3*m*R/Theta */
    out[0] = t41;
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
    const double t10 = x[5]*x[5]; /* s*s */
    const double t11 = t9*t10; /* m*a3*a3*s*s */
    const double t12 = p[4] + t11; /* D = I1 + m*a3*a3*s*s */
    const double t13 = t7*t12; /* omega_tau*omega_tau*D */
    const double t14 = (1.0 / 2.0)*t13; /* 1/2*omega_tau*omega_tau*D */
    const double t15 = t6 + t14; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D */
    const double t16 = x[3]*x[3]; /* omega_n*omega_n */
    const double t17 = p[4]*t16; /* I1*omega_n*omega_n */
    const double t18 = (1.0 / 2.0)*t17; /* 1/2*I1*omega_n*omega_n */
    const double t19 = t15 + t18; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*I1*omega_n*omega_n */
    const double t20 = x[4]*x[4]; /* omega3*omega3 */
    const double t21 = p[5]*t20; /* I3*omega3*omega3 */
    const double t22 = (1.0 / 2.0)*t21; /* 1/2*I3*omega3*omega3 */
    const double t23 = t19 + t22; /* t19 + 1/2*I3*omega3*omega3 */
    const double t24 = x[0]*p[1]; /* gamma3*R */
    const double t25 = p[3] + t24; /* b = a3 + gamma3*R */
    const double t26 = x[3]*t25; /* omega_n*b */
    const double t27 = x[4]*p[1]; /* omega3*R */
    const double t28 = x[5]*t27; /* s*omega3*R */
    const double t29 = t26 + t28; /* v_tau = omega_n*b + s*omega3*R */
    const double t30 = t29*t29; /* v_tau*v_tau */
    const double t31 = p[0]*t30; /* m*v_tau*v_tau */
    const double t32 = (1.0 / 2.0)*t31; /* 1/2*m*v_tau*v_tau */
    const double t33 = t23 + t32; /* energy = t19 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    const double t34 = p[4]*p[1]; /* I1*R */
    const double t35 = x[3]*t34; /* omega_n*I1*R */
    const double t36 = x[5]*t35; /* s*omega_n*I1*R */
    const double t37 = p[5]*x[4]; /* I3*omega3 */
    const double t38 = t25*t37; /* b*I3*omega3 */
    const double t39 = t36 - t38; /* s*omega_n*I1*R - b*I3*omega3 */
    out[0] = t33;
    out[1] = t39;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[1]; /* m*R */
    const double t1 = t0*x[3]; /* m*R*omega_n */
    const double t2 = p[1]*x[0]; /* R*gamma3 */
    const double t3 = p[3] + t2; /* b = a3 + R*gamma3 */
    const double t4 = x[3]*t3; /* omega_n*b */
    const double t5 = p[1]*x[4]; /* R*omega3 */
    const double t6 = t5*x[5]; /* R*omega3*s */
    const double t7 = t4 + t6; /* v_tau = omega_n*b + R*omega3*s */
    const double t8 = t1*t7; /* m*R*omega_n*v_tau */
    const double t9 = p[8] + t8; /* d(energy)/d(gamma3) = m*g*a3 + m*R*omega_n*v_tau */
    const double t10 = p[0]*x[1]; /* m*v_nu */
    const double t11 = p[3]*p[3]; /* a3*a3 */
    const double t12 = p[0]*t11; /* m*a3*a3 */
    const double t13 = x[5]*x[5]; /* s*s */
    const double t14 = t12*t13; /* m*a3*a3*s*s */
    const double t15 = p[4] + t14; /* D = I1 + m*a3*a3*s*s */
    const double t16 = x[2]*t15; /* omega_tau*D */
    const double t17 = x[3]*p[4]; /* omega_n*I1 */
    const double t18 = p[0]*t3; /* m*b */
    const double t19 = t7*t18; /* v_tau*m*b */
    const double t20 = t17 + t19; /* d(energy)/d(omega_n) = omega_n*I1 + v_tau*m*b */
    const double t21 = x[4]*p[5]; /* omega3*I3 */
    const double t22 = t0*x[5]; /* m*R*s */
    const double t23 = t7*t22; /* v_tau*m*R*s */
    const double t24 = t21 + t23; /* d(energy)/d(omega3) = omega3*I3 + v_tau*m*R*s */
    const double t25 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t26 = t12*t25; /* m*a3*a3*omega_tau*omega_tau */
    const double t27 = x[5]*t26; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t28 = t0*x[4]; /* m*R*omega3 */
    const double t29 = t7*t28; /* v_tau*m*R*omega3 */
    const double t30 = t27 + t29; /* d(energy)/d(s) = s*m*a3*a3*omega_tau*omega_tau + v_tau*m*R*omega3 */
    const double t31 = p[1]*p[5]; /* R*I3 */
    const double t32 = x[4]*t31; /* omega3*R*I3 */
    const double t33 = -t32; /* -omega3*R*I3 */
    const double t34 = p[1]*p[4]; /* R*I1 */
    const double t35 = x[5]*t34; /* s*R*I1 */
    const double t36 = t3*p[5]; /* b*I3 */
    const double t37 = -t36; /* -b*I3 */
    const double t38 = x[3]*t34; /* omega_n*R*I1 */
    out[0] = t9;
    out[1] = t10;
    out[2] = t16;
    out[3] = t20;
    out[4] = t24;
    out[5] = t30;
    out[6] = t33;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t35;
    out[10] = t37;
    out[11] = t38;
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
    const double v_a3 = params[3];
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
};

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 9,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 6, { 16, 62, 0, 10, 0, 0, 10, 10 }, { 17, 78, 0, 10, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 36, { 50, 222, 0, 47, 0, 0, 14, 24 }, { 56, 375, 0, 49, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 42, { 60, 239, 0, 57, 0, 0, 14, 43 }, { 67, 437, 0, 59, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 9, 29, 0, 4, 0, 0, 10, 8 }, { 10, 39, 0, 4, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 2, { 9, 31, 0, 0, 0, 0, 10, 5 }, { 9, 31, 0, 0, 0, 0, 10, 5 },
        "" },
    .integral_gradients = { integral_gradients, 12, { 9, 30, 0, 0, 0, 0, 6, 7 }, { 9, 37, 0, 0, 0, 0, 6, 6 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_in_regular_baseline,
        &jlt_batch_spherical_top_general_in_regular_avx2,
        &jlt_batch_spherical_top_general_in_regular_avx512,
    },
};
