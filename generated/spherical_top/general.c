/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 16   59    0   12    1    0     12    9   (99)
 *  jacobian            47  156    0   48    1    0     16   25   (373)
 *  rhs_jacobian        56  166    0   60    1    0     16   44   (447)
 *  divergence          10   31    0    4    1    0     12    9   (54)
 *  integral_values     10   32    0    0    1    0     12    6   (43)
 *  integral_gradients  12   32    0    2    1    0      8    9   (53)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_avx512;

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
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = x[3]*x[3]; /* omega_n*omega_n */
    const double t5 = x[0]*p[1]; /* gamma3*R */
    const double t6 = p[3] + t5; /* b = a3 + gamma3*R */
    const double t7 = t4*t6; /* omega_n*omega_n*b */
    const double t8 = t7/t2; /* omega_n*omega_n*b/s */
    const double t9 = x[3]*p[1]; /* omega_n*R */
    const double t10 = t9*x[4]; /* omega_n*R*omega3 */
    const double t11 = t8 + t10; /* omega_n*omega_n*b/s + omega_n*R*omega3 */
    const double t12 = p[3]*p[3]; /* a3*a3 */
    const double t13 = p[0]*t12; /* m*a3*a3 */
    const double t14 = x[0]*t13; /* gamma3*m*a3*a3 */
    const double t15 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t16 = t14*t15; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t17 = t2*t16; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t18 = t2*t2; /* s*s */
    const double t19 = t13*t18; /* m*a3*a3*s*s */
    const double t20 = p[4] + t19; /* D = I1 + m*a3*a3*s*s */
    const double t21 = t17/t20; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t22 = p[0]*p[2]; /* m*g */
    const double t23 = p[3]*t22; /* a3*m*g */
    const double t24 = t2*t23; /* s*a3*m*g */
    const double t25 = t24/t20; /* s*a3*m*g/D */
    const double t26 = t21 - t25; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D */
    const double t27 = x[0]*p[4]; /* gamma3*I1 */
    const double t28 = t4*t27; /* omega_n*omega_n*gamma3*I1 */
    const double t29 = t2*t20; /* s*D */
    const double t30 = t28/t29; /* omega_n*omega_n*gamma3*I1/(s*D) */
    const double t31 = t26 - t30; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - omega_n*omega_n*gamma3*I1/(s*D) */
    const double t32 = x[3]*p[5]; /* omega_n*I3 */
    const double t33 = x[4]*t32; /* omega3*omega_n*I3 */
    const double t34 = t33/t20; /* omega3*omega_n*I3/D */
    const double t35 = t31 - t34; /* t31 - omega3*omega_n*I3/D */
    const double t36 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t37 = x[3]*t36; /* omega_n*omega_tau*gamma3 */
    const double t38 = t37/t2; /* omega_n*omega_tau*gamma3/s */
    const double t39 = p[0]*p[5]; /* m*I3 */
    const double t40 = x[3]*t39; /* omega_n*m*I3 */
    const double t41 = t6*t40; /* b*omega_n*m*I3 */
    const double t42 = p[1]*p[1]; /* R*R */
    const double t43 = p[0]*t42; /* m*R*R */
    const double t44 = p[4]*t43; /* I1*m*R*R */
    const double t45 = t18*t44; /* s*s*I1*m*R*R */
    const double t46 = p[6] + t45; /* I1*I3 + s*s*I1*m*R*R */
    const double t47 = t6*t6; /* b*b */
    const double t48 = t39*t47; /* m*I3*b*b */
    const double t49 = t46 + t48; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t50 = t2*t49; /* s*Theta */
    const double t51 = x[0]*p[3]; /* gamma3*a3 */
    const double t52 = p[1] + t51; /* e = R + gamma3*a3 */
    const double t53 = x[2]*t52; /* omega_tau*e */
    const double t54 = x[1] + t53; /* V = v_nu + omega_tau*e */
    const double t55 = t41*t54; /* b*omega_n*m*I3*V */
    const double t56 = t55/t50; /* b*omega_n*m*I3*V/(s*Theta) */
    const double t57 = t38 - t56; /* omega_n*omega_tau*gamma3/s - b*omega_n*m*I3*V/(s*Theta) */
    const double t58 = p[5]*p[5]; /* I3*I3 */
    const double t59 = x[2]*t58; /* omega_tau*I3*I3 */
    const double t60 = x[4]*t59; /* omega3*omega_tau*I3*I3 */
    const double t61 = t60/t49; /* omega3*omega_tau*I3*I3/Theta */
    const double t62 = t57 + t61; /* omega_n*omega_tau*gamma3/s - b*omega_n*m*I3*V/(s*Theta) + omega3*omega_tau*I3*I3/Theta */
    const double t63 = p[1]*p[0]; /* R*m */
    const double t64 = p[5]*t63; /* I3*R*m */
    const double t65 = x[2]*t64; /* omega_tau*I3*R*m */
    const double t66 = x[4]*t65; /* omega3*omega_tau*I3*R*m */
    const double t67 = t52*t66; /* e*omega3*omega_tau*I3*R*m */
    const double t68 = t67/t49; /* e*omega3*omega_tau*I3*R*m/Theta */
    const double t69 = t62 + t68; /* t62 + e*omega3*omega_tau*I3*R*m/Theta */
    const double t70 = p[4]*t63; /* I1*R*m */
    const double t71 = x[3]*t70; /* omega_n*I1*R*m */
    const double t72 = t54*t71; /* V*omega_n*I1*R*m */
    const double t73 = t72/t49; /* V*omega_n*I1*R*m/Theta */
    const double t74 = x[0]*t43; /* gamma3*m*R*R */
    const double t75 = x[2]*t74; /* omega_tau*gamma3*m*R*R */
    const double t76 = x[4]*t75; /* omega3*omega_tau*gamma3*m*R*R */
    const double t77 = t2*t76; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t78 = t77*p[7]; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t79 = t78/t49; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t80 = t79 - t73; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - V*omega_n*I1*R*m/Theta */
    const double t81 = p[3]*t63; /* a3*R*m */
    const double t82 = p[5]*t81; /* I3*a3*R*m */
    const double t83 = x[2]*t82; /* omega_tau*I3*a3*R*m */
    const double t84 = x[4]*t83; /* omega3*omega_tau*I3*a3*R*m */
    const double t85 = t2*t84; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t86 = t85/t49; /* s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t87 = t80 - t86; /* t80 - s*omega3*omega_tau*I3*a3*R*m/Theta */
    out[0] = t3;
    out[1] = t11;
    out[2] = t35;
    out[3] = t69;
    out[4] = t87;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = -t4; /* -gamma3*omega_tau/s */
    const double t6 = x[3]*x[3]; /* omega_n*omega_n */
    const double t7 = p[1]*t6; /* R*omega_n*omega_n */
    const double t8 = t7/t3; /* R*omega_n*omega_n/s */
    const double t9 = x[0]*t6; /* gamma3*omega_n*omega_n */
    const double t10 = t3*t3; /* s*s */
    const double t11 = t3*t10; /* s*s*s */
    const double t12 = x[0]*p[1]; /* gamma3*R */
    const double t13 = p[3] + t12; /* b = a3 + gamma3*R */
    const double t14 = t9*t13; /* gamma3*omega_n*omega_n*b */
    const double t15 = t14/t11; /* gamma3*omega_n*omega_n*b/(s*s*s) */
    const double t16 = t8 + t15; /* R*omega_n*omega_n/s + gamma3*omega_n*omega_n*b/(s*s*s) */
    const double t17 = p[1]*x[4]; /* R*omega3 */
    const double t18 = x[3]*t13; /* omega_n*b */
    const double t19 = t18/t3; /* omega_n*b/s */
    const double t20 = t19*2.0; /* omega_n*b/s*2 */
    const double t21 = t17 + t20; /* R*omega3 + omega_n*b/s*2 */
    const double t22 = p[1]*x[3]; /* R*omega_n */
    const double t23 = p[3]*p[3]; /* a3*a3 */
    const double t24 = p[0]*t23; /* m*a3*a3 */
    const double t25 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t26 = t24*t25; /* m*a3*a3*omega_tau*omega_tau */
    const double t27 = t3*t26; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t28 = t10*t24; /* s*s*m*a3*a3 */
    const double t29 = p[4] + t28; /* D = I1 + s*s*m*a3*a3 */
    const double t30 = t27/t29; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t31 = t1*t24; /* gamma3*gamma3*m*a3*a3 */
    const double t32 = t25*t31; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t33 = t3*t29; /* s*D */
    const double t34 = t32/t33; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t35 = t30 - t34; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t36 = p[0]*p[0]; /* m*m */
    const double t37 = t23*t23; /* a3*a3*a3*a3 */
    const double t38 = t36*t37; /* m*m*a3*a3*a3*a3 */
    const double t39 = t1*t38; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t40 = t25*t39; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t41 = t3*t40; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t42 = t29*t29; /* D*D */
    const double t43 = t41/t42; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t44 = 2.0*t43; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t45 = t35 + t44; /* t35 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t46 = p[0]*p[2]; /* m*g */
    const double t47 = p[3]*t46; /* a3*m*g */
    const double t48 = x[0]*t47; /* gamma3*a3*m*g */
    const double t49 = t48/t33; /* gamma3*a3*m*g/(s*D) */
    const double t50 = t45 + t49; /* t45 + gamma3*a3*m*g/(s*D) */
    const double t51 = t36*p[2]; /* m*m*g */
    const double t52 = p[3]*t23; /* a3*a3*a3 */
    const double t53 = t51*t52; /* m*m*g*a3*a3*a3 */
    const double t54 = x[0]*t53; /* gamma3*m*m*g*a3*a3*a3 */
    const double t55 = t3*t54; /* s*gamma3*m*m*g*a3*a3*a3 */
    const double t56 = t55/t42; /* s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t57 = 2.0*t56; /* 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t58 = t50 - t57; /* t45 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t59 = t6*p[4]; /* omega_n*omega_n*I1 */
    const double t60 = t59/t33; /* omega_n*omega_n*I1/(s*D) */
    const double t61 = t58 - t60; /* t45 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) - omega_n*omega_n*I1/(s*D) */
    const double t62 = t1*p[4]; /* gamma3*gamma3*I1 */
    const double t63 = t6*t62; /* omega_n*omega_n*gamma3*gamma3*I1 */
    const double t64 = t11*t29; /* s*s*s*D */
    const double t65 = t63/t64; /* omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) */
    const double t66 = t61 - t65; /* t61 - omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) */
    const double t67 = t24*p[4]; /* m*a3*a3*I1 */
    const double t68 = t1*t67; /* gamma3*gamma3*m*a3*a3*I1 */
    const double t69 = t6*t68; /* omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1 */
    const double t70 = t3*t42; /* s*D*D */
    const double t71 = t69/t70; /* omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1/(s*D*D) */
    const double t72 = 2.0*t71; /* 2*omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1/(s*D*D) */
    const double t73 = t66 - t72; /* t61 - omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) - 2*omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1/(s*D*D) */
    const double t74 = t24*p[5]; /* m*a3*a3*I3 */
    const double t75 = x[0]*t74; /* gamma3*m*a3*a3*I3 */
    const double t76 = x[3]*t75; /* omega_n*gamma3*m*a3*a3*I3 */
    const double t77 = x[4]*t76; /* omega3*omega_n*gamma3*m*a3*a3*I3 */
    const double t78 = t77/t42; /* omega3*omega_n*gamma3*m*a3*a3*I3/(D*D) */
    const double t79 = 2.0*t78; /* 2*omega3*omega_n*gamma3*m*a3*a3*I3/(D*D) */
    const double t80 = t73 - t79; /* t73 - 2*omega3*omega_n*gamma3*m*a3*a3*I3/(D*D) */
    const double t81 = 2.0*p[0]; /* 2*m */
    const double t82 = t23*t81; /* a3*a3*2*m */
    const double t83 = x[0]*t82; /* gamma3*a3*a3*2*m */
    const double t84 = x[2]*t83; /* omega_tau*gamma3*a3*a3*2*m */
    const double t85 = t3*t84; /* s*omega_tau*gamma3*a3*a3*2*m */
    const double t86 = t85/t29; /* s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t87 = x[0]*p[4]; /* gamma3*I1 */
    const double t88 = x[3]*t87; /* omega_n*gamma3*I1 */
    const double t89 = t88/t33; /* omega_n*gamma3*I1/(s*D) */
    const double t90 = 2.0*t89; /* 2*omega_n*gamma3*I1/(s*D) */
    const double t91 = -t90; /* -2*omega_n*gamma3*I1/(s*D) */
    const double t92 = x[4]*p[5]; /* omega3*I3 */
    const double t93 = t92/t29; /* omega3*I3/D */
    const double t94 = t91 - t93; /* -2*omega_n*gamma3*I1/(s*D) - omega3*I3/D */
    const double t95 = x[3]*p[5]; /* omega_n*I3 */
    const double t96 = t95/t29; /* omega_n*I3/D */
    const double t97 = -t96; /* -omega_n*I3/D */
    const double t98 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t99 = t98/t3; /* omega_tau*omega_n/s */
    const double t100 = x[2]*t1; /* omega_tau*gamma3*gamma3 */
    const double t101 = x[3]*t100; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t102 = t101/t11; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t103 = t99 + t102; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t104 = p[1]*p[0]; /* R*m */
    const double t105 = p[5]*t104; /* I3*R*m */
    const double t106 = x[3]*t105; /* omega_n*I3*R*m */
    const double t107 = p[1]*p[1]; /* R*R */
    const double t108 = p[0]*t107; /* m*R*R */
    const double t109 = p[4]*t108; /* I1*m*R*R */
    const double t110 = t10*t109; /* s*s*I1*m*R*R */
    const double t111 = p[6] + t110; /* I1*I3 + s*s*I1*m*R*R */
    const double t112 = p[0]*p[5]; /* m*I3 */
    const double t113 = t13*t13; /* b*b */
    const double t114 = t112*t113; /* m*I3*b*b */
    const double t115 = t111 + t114; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t116 = t3*t115; /* s*Theta */
    const double t117 = x[0]*p[3]; /* gamma3*a3 */
    const double t118 = p[1] + t117; /* e = R + gamma3*a3 */
    const double t119 = x[2]*t118; /* omega_tau*e */
    const double t120 = x[1] + t119; /* V = v_nu + omega_tau*e */
    const double t121 = t106*t120; /* omega_n*I3*R*m*V */
    const double t122 = t121/t116; /* omega_n*I3*R*m*V/(s*Theta) */
    const double t123 = t103 - t122; /* t103 - omega_n*I3*R*m*V/(s*Theta) */
    const double t124 = x[3]*t112; /* omega_n*m*I3 */
    const double t125 = t13*t124; /* b*omega_n*m*I3 */
    const double t126 = t115*t115; /* Theta*Theta */
    const double t127 = t3*t126; /* s*Theta*Theta */
    const double t128 = t120*t125; /* V*b*omega_n*m*I3 */
    const double t129 = x[0]*t109; /* gamma3*I1*m*R*R */
    const double t130 = 2.0*t129; /* 2*gamma3*I1*m*R*R */
    const double t131 = t13*t105; /* b*I3*R*m */
    const double t132 = 2.0*t131; /* 2*b*I3*R*m */
    const double t133 = t132 - t130; /* d(Theta)/d(gamma3) = 2*b*I3*R*m - 2*gamma3*I1*m*R*R */
    const double t134 = t128*t133; /* V*b*omega_n*m*I3*d(Theta)/d(gamma3) */
    const double t135 = t134/t127; /* V*b*omega_n*m*I3*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t136 = t123 + t135; /* t103 - omega_n*I3*R*m*V/(s*Theta) + V*b*omega_n*m*I3*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t137 = p[3]*p[0]; /* a3*m */
    const double t138 = p[5]*t137; /* I3*a3*m */
    const double t139 = x[2]*t138; /* omega_tau*I3*a3*m */
    const double t140 = x[3]*t139; /* omega_n*omega_tau*I3*a3*m */
    const double t141 = t13*t140; /* b*omega_n*omega_tau*I3*a3*m */
    const double t142 = t141/t116; /* b*omega_n*omega_tau*I3*a3*m/(s*Theta) */
    const double t143 = t136 - t142; /* t136 - b*omega_n*omega_tau*I3*a3*m/(s*Theta) */
    const double t144 = x[0]*t112; /* gamma3*m*I3 */
    const double t145 = x[3]*t144; /* omega_n*gamma3*m*I3 */
    const double t146 = t13*t145; /* b*omega_n*gamma3*m*I3 */
    const double t147 = t11*t115; /* s*s*s*Theta */
    const double t148 = t120*t146; /* V*b*omega_n*gamma3*m*I3 */
    const double t149 = t148/t147; /* V*b*omega_n*gamma3*m*I3/(s*s*s*Theta) */
    const double t150 = t143 - t149; /* t136 - b*omega_n*omega_tau*I3*a3*m/(s*Theta) - V*b*omega_n*gamma3*m*I3/(s*s*s*Theta) */
    const double t151 = p[5]*p[5]; /* I3*I3 */
    const double t152 = x[2]*t151; /* omega_tau*I3*I3 */
    const double t153 = x[4]*t152; /* omega3*omega_tau*I3*I3 */
    const double t154 = t133*t153; /* d(Theta)/d(gamma3)*omega3*omega_tau*I3*I3 */
    const double t155 = t154/t126; /* d(Theta)/d(gamma3)*omega3*omega_tau*I3*I3/(Theta*Theta) */
    const double t156 = t150 - t155; /* t150 - d(Theta)/d(gamma3)*omega3*omega_tau*I3*I3/(Theta*Theta) */
    const double t157 = p[3]*t104; /* a3*R*m */
    const double t158 = p[5]*t157; /* I3*a3*R*m */
    const double t159 = x[2]*t158; /* omega_tau*I3*a3*R*m */
    const double t160 = x[4]*t159; /* omega3*omega_tau*I3*a3*R*m */
    const double t161 = t160/t115; /* omega3*omega_tau*I3*a3*R*m/Theta */
    const double t162 = t156 + t161; /* t156 + omega3*omega_tau*I3*a3*R*m/Theta */
    const double t163 = x[2]*t105; /* omega_tau*I3*R*m */
    const double t164 = x[4]*t163; /* omega3*omega_tau*I3*R*m */
    const double t165 = t118*t164; /* e*omega3*omega_tau*I3*R*m */
    const double t166 = t133*t165; /* d(Theta)/d(gamma3)*e*omega3*omega_tau*I3*R*m */
    const double t167 = t166/t126; /* d(Theta)/d(gamma3)*e*omega3*omega_tau*I3*R*m/(Theta*Theta) */
    const double t168 = t162 - t167; /* t156 + omega3*omega_tau*I3*a3*R*m/Theta - d(Theta)/d(gamma3)*e*omega3*omega_tau*I3*R*m/(Theta*Theta) */
    const double t169 = t125/t116; /* b*omega_n*m*I3/(s*Theta) */
    const double t170 = -t169; /* -b*omega_n*m*I3/(s*Theta) */
    const double t171 = x[0]*x[3]; /* gamma3*omega_n */
    const double t172 = t171/t3; /* gamma3*omega_n/s */
    const double t173 = t118*t125; /* e*b*omega_n*m*I3 */
    const double t174 = t173/t116; /* e*b*omega_n*m*I3/(s*Theta) */
    const double t175 = t172 - t174; /* gamma3*omega_n/s - e*b*omega_n*m*I3/(s*Theta) */
    const double t176 = x[4]*t151; /* omega3*I3*I3 */
    const double t177 = t176/t115; /* omega3*I3*I3/Theta */
    const double t178 = t175 + t177; /* gamma3*omega_n/s - e*b*omega_n*m*I3/(s*Theta) + omega3*I3*I3/Theta */
    const double t179 = x[4]*t105; /* omega3*I3*R*m */
    const double t180 = t118*t179; /* e*omega3*I3*R*m */
    const double t181 = t180/t115; /* e*omega3*I3*R*m/Theta */
    const double t182 = t178 + t181; /* t178 + e*omega3*I3*R*m/Theta */
    const double t183 = t13*t112; /* b*m*I3 */
    const double t184 = t120*t183; /* V*b*m*I3 */
    const double t185 = t184/t116; /* V*b*m*I3/(s*Theta) */
    const double t186 = t4 - t185; /* gamma3*omega_tau/s - V*b*m*I3/(s*Theta) */
    const double t187 = t152/t115; /* omega_tau*I3*I3/Theta */
    const double t188 = t118*t163; /* e*omega_tau*I3*R*m */
    const double t189 = t188/t115; /* e*omega_tau*I3*R*m/Theta */
    const double t190 = t187 + t189; /* omega_tau*I3*I3/Theta + e*omega_tau*I3*R*m/Theta */
    const double t191 = p[4]*t104; /* I1*R*m */
    const double t192 = x[3]*t191; /* omega_n*I1*R*m */
    const double t193 = t120*t192; /* V*omega_n*I1*R*m */
    const double t194 = t133*t193; /* d(Theta)/d(gamma3)*V*omega_n*I1*R*m */
    const double t195 = t194/t126; /* d(Theta)/d(gamma3)*V*omega_n*I1*R*m/(Theta*Theta) */
    const double t196 = p[4]*t157; /* I1*a3*R*m */
    const double t197 = x[2]*t196; /* omega_tau*I1*a3*R*m */
    const double t198 = x[3]*t197; /* omega_n*omega_tau*I1*a3*R*m */
    const double t199 = t198/t115; /* omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t200 = t195 - t199; /* d(Theta)/d(gamma3)*V*omega_n*I1*R*m/(Theta*Theta) - omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t201 = x[2]*t108; /* omega_tau*m*R*R */
    const double t202 = x[4]*t201; /* omega3*omega_tau*m*R*R */
    const double t203 = t3*t202; /* s*omega3*omega_tau*m*R*R */
    const double t204 = t203*p[7]; /* s*omega3*omega_tau*m*R*R*(I1 - I3) */
    const double t205 = t204/t115; /* s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t206 = t200 + t205; /* t200 + s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t207 = x[0]*t108; /* gamma3*m*R*R */
    const double t208 = x[2]*t207; /* omega_tau*gamma3*m*R*R */
    const double t209 = x[4]*t208; /* omega3*omega_tau*gamma3*m*R*R */
    const double t210 = t3*t209; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t211 = p[7]*t210; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t212 = t133*t211; /* d(Theta)/d(gamma3)*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t213 = t212/t126; /* d(Theta)/d(gamma3)*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/(Theta*Theta) */
    const double t214 = t206 - t213; /* t200 + s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta - t213 */
    const double t215 = t1*t108; /* gamma3*gamma3*m*R*R */
    const double t216 = x[2]*t215; /* omega_tau*gamma3*gamma3*m*R*R */
    const double t217 = x[4]*t216; /* omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t218 = p[7]*t217; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t219 = t218/t116; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t220 = t214 - t219; /* t200 + s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta - t213 - (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t221 = t3*t160; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t222 = t133*t221; /* d(Theta)/d(gamma3)*s*omega3*omega_tau*I3*a3*R*m */
    const double t223 = t222/t126; /* d(Theta)/d(gamma3)*s*omega3*omega_tau*I3*a3*R*m/(Theta*Theta) */
    const double t224 = t220 + t223; /* t220 + t223 */
    const double t225 = x[0]*t158; /* gamma3*I3*a3*R*m */
    const double t226 = x[2]*t225; /* omega_tau*gamma3*I3*a3*R*m */
    const double t227 = x[4]*t226; /* omega3*omega_tau*gamma3*I3*a3*R*m */
    const double t228 = t227/t116; /* omega3*omega_tau*gamma3*I3*a3*R*m/(s*Theta) */
    const double t229 = t224 + t228; /* t220 + t223 + omega3*omega_tau*gamma3*I3*a3*R*m/(s*Theta) */
    const double t230 = t192/t115; /* omega_n*I1*R*m/Theta */
    const double t231 = -t230; /* -omega_n*I1*R*m/Theta */
    const double t232 = x[4]*t207; /* omega3*gamma3*m*R*R */
    const double t233 = t3*t232; /* s*omega3*gamma3*m*R*R */
    const double t234 = p[7]*t233; /* (I1 - I3)*s*omega3*gamma3*m*R*R */
    const double t235 = t234/t115; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta */
    const double t236 = t118*t192; /* e*omega_n*I1*R*m */
    const double t237 = t236/t115; /* e*omega_n*I1*R*m/Theta */
    const double t238 = t235 - t237; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta - e*omega_n*I1*R*m/Theta */
    const double t239 = x[4]*t158; /* omega3*I3*a3*R*m */
    const double t240 = t3*t239; /* s*omega3*I3*a3*R*m */
    const double t241 = t240/t115; /* s*omega3*I3*a3*R*m/Theta */
    const double t242 = t238 - t241; /* t238 - s*omega3*I3*a3*R*m/Theta */
    const double t243 = t120*t191; /* V*I1*R*m */
    const double t244 = t243/t115; /* V*I1*R*m/Theta */
    const double t245 = -t244; /* -V*I1*R*m/Theta */
    const double t246 = t3*t208; /* s*omega_tau*gamma3*m*R*R */
    const double t247 = p[7]*t246; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R */
    const double t248 = t247/t115; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta */
    const double t249 = t3*t159; /* s*omega_tau*I3*a3*R*m */
    const double t250 = t249/t115; /* s*omega_tau*I3*a3*R*m/Theta */
    const double t251 = t248 - t250; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta - s*omega_tau*I3*a3*R*m/Theta */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t16;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t21;
    out[9] = t22;
    out[10] = t80;
    out[11] = 0.0;
    out[12] = t86;
    out[13] = t94;
    out[14] = t97;
    out[15] = t168;
    out[16] = t170;
    out[17] = t182;
    out[18] = t186;
    out[19] = t190;
    out[20] = t229;
    out[21] = t231;
    out[22] = t242;
    out[23] = t245;
    out[24] = t251;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = x[3]*x[3]; /* omega_n*omega_n */
    const double t5 = x[0]*p[1]; /* gamma3*R */
    const double t6 = p[3] + t5; /* b = a3 + gamma3*R */
    const double t7 = t4*t6; /* omega_n*omega_n*b */
    const double t8 = t7/t2; /* omega_n*omega_n*b/s */
    const double t9 = x[3]*p[1]; /* omega_n*R */
    const double t10 = t9*x[4]; /* omega_n*R*omega3 */
    const double t11 = t8 + t10; /* omega_n*omega_n*b/s + omega_n*R*omega3 */
    const double t12 = p[3]*p[3]; /* a3*a3 */
    const double t13 = p[0]*t12; /* m*a3*a3 */
    const double t14 = x[0]*t13; /* gamma3*m*a3*a3 */
    const double t15 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t16 = t14*t15; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t17 = t2*t16; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t18 = t2*t2; /* s*s */
    const double t19 = t13*t18; /* m*a3*a3*s*s */
    const double t20 = p[4] + t19; /* D = I1 + m*a3*a3*s*s */
    const double t21 = t17/t20; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t22 = p[0]*p[2]; /* m*g */
    const double t23 = p[3]*t22; /* a3*m*g */
    const double t24 = t2*t23; /* s*a3*m*g */
    const double t25 = t24/t20; /* s*a3*m*g/D */
    const double t26 = t21 - t25; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D */
    const double t27 = x[0]*p[4]; /* gamma3*I1 */
    const double t28 = t4*t27; /* omega_n*omega_n*gamma3*I1 */
    const double t29 = t2*t20; /* s*D */
    const double t30 = t28/t29; /* omega_n*omega_n*gamma3*I1/(s*D) */
    const double t31 = t26 - t30; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - omega_n*omega_n*gamma3*I1/(s*D) */
    const double t32 = x[3]*p[5]; /* omega_n*I3 */
    const double t33 = x[4]*t32; /* omega3*omega_n*I3 */
    const double t34 = t33/t20; /* omega3*omega_n*I3/D */
    const double t35 = t31 - t34; /* t31 - omega3*omega_n*I3/D */
    const double t36 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t37 = x[3]*t36; /* omega_n*omega_tau*gamma3 */
    const double t38 = t37/t2; /* omega_n*omega_tau*gamma3/s */
    const double t39 = p[0]*p[5]; /* m*I3 */
    const double t40 = x[3]*t39; /* omega_n*m*I3 */
    const double t41 = t6*t40; /* b*omega_n*m*I3 */
    const double t42 = p[1]*p[1]; /* R*R */
    const double t43 = p[0]*t42; /* m*R*R */
    const double t44 = p[4]*t43; /* I1*m*R*R */
    const double t45 = t18*t44; /* s*s*I1*m*R*R */
    const double t46 = p[6] + t45; /* I1*I3 + s*s*I1*m*R*R */
    const double t47 = t6*t6; /* b*b */
    const double t48 = t39*t47; /* m*I3*b*b */
    const double t49 = t46 + t48; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t50 = t2*t49; /* s*Theta */
    const double t51 = x[0]*p[3]; /* gamma3*a3 */
    const double t52 = p[1] + t51; /* e = R + gamma3*a3 */
    const double t53 = x[2]*t52; /* omega_tau*e */
    const double t54 = x[1] + t53; /* V = v_nu + omega_tau*e */
    const double t55 = t41*t54; /* b*omega_n*m*I3*V */
    const double t56 = t55/t50; /* b*omega_n*m*I3*V/(s*Theta) */
    const double t57 = t38 - t56; /* omega_n*omega_tau*gamma3/s - b*omega_n*m*I3*V/(s*Theta) */
    const double t58 = p[5]*p[5]; /* I3*I3 */
    const double t59 = x[2]*t58; /* omega_tau*I3*I3 */
    const double t60 = x[4]*t59; /* omega3*omega_tau*I3*I3 */
    const double t61 = t60/t49; /* omega3*omega_tau*I3*I3/Theta */
    const double t62 = t57 + t61; /* omega_n*omega_tau*gamma3/s - b*omega_n*m*I3*V/(s*Theta) + omega3*omega_tau*I3*I3/Theta */
    const double t63 = p[1]*p[0]; /* R*m */
    const double t64 = p[5]*t63; /* I3*R*m */
    const double t65 = x[2]*t64; /* omega_tau*I3*R*m */
    const double t66 = x[4]*t65; /* omega3*omega_tau*I3*R*m */
    const double t67 = t52*t66; /* e*omega3*omega_tau*I3*R*m */
    const double t68 = t67/t49; /* e*omega3*omega_tau*I3*R*m/Theta */
    const double t69 = t62 + t68; /* t62 + e*omega3*omega_tau*I3*R*m/Theta */
    const double t70 = p[4]*t63; /* I1*R*m */
    const double t71 = x[3]*t70; /* omega_n*I1*R*m */
    const double t72 = t54*t71; /* V*omega_n*I1*R*m */
    const double t73 = t72/t49; /* V*omega_n*I1*R*m/Theta */
    const double t74 = x[0]*t43; /* gamma3*m*R*R */
    const double t75 = x[2]*t74; /* omega_tau*gamma3*m*R*R */
    const double t76 = x[4]*t75; /* omega3*omega_tau*gamma3*m*R*R */
    const double t77 = t2*t76; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t78 = t77*p[7]; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t79 = t78/t49; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t80 = t79 - t73; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - V*omega_n*I1*R*m/Theta */
    const double t81 = p[3]*t63; /* a3*R*m */
    const double t82 = p[5]*t81; /* I3*a3*R*m */
    const double t83 = x[2]*t82; /* omega_tau*I3*a3*R*m */
    const double t84 = x[4]*t83; /* omega3*omega_tau*I3*a3*R*m */
    const double t85 = t2*t84; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t86 = t85/t49; /* s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t87 = t80 - t86; /* t80 - s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t88 = t36/t2; /* omega_tau*gamma3/s */
    const double t89 = -t88; /* -omega_tau*gamma3/s */
    const double t90 = t4*p[1]; /* omega_n*omega_n*R */
    const double t91 = t90/t2; /* omega_n*omega_n*R/s */
    const double t92 = x[0]*t4; /* gamma3*omega_n*omega_n */
    const double t93 = t2*t18; /* s*s*s */
    const double t94 = t6*t92; /* b*gamma3*omega_n*omega_n */
    const double t95 = t94/t93; /* b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t96 = t91 + t95; /* omega_n*omega_n*R/s + b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t97 = p[1]*x[4]; /* R*omega3 */
    const double t98 = x[3]*t6; /* omega_n*b */
    const double t99 = t98/t2; /* omega_n*b/s */
    const double t100 = t99*2.0; /* omega_n*b/s*2 */
    const double t101 = t97 + t100; /* R*omega3 + omega_n*b/s*2 */
    const double t102 = t13*t15; /* m*a3*a3*omega_tau*omega_tau */
    const double t103 = t2*t102; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t104 = t103/t20; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t105 = t0*t13; /* gamma3*gamma3*m*a3*a3 */
    const double t106 = t15*t105; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t107 = t106/t29; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t108 = t104 - t107; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t109 = p[0]*p[0]; /* m*m */
    const double t110 = t12*t12; /* a3*a3*a3*a3 */
    const double t111 = t109*t110; /* m*m*a3*a3*a3*a3 */
    const double t112 = t0*t111; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t113 = t15*t112; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t114 = t2*t113; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t115 = t20*t20; /* D*D */
    const double t116 = t114/t115; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t117 = 2.0*t116; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t118 = t108 + t117; /* t108 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t119 = x[0]*t23; /* gamma3*a3*m*g */
    const double t120 = t119/t29; /* gamma3*a3*m*g/(s*D) */
    const double t121 = t118 + t120; /* t118 + gamma3*a3*m*g/(s*D) */
    const double t122 = p[2]*t109; /* g*m*m */
    const double t123 = p[3]*t12; /* a3*a3*a3 */
    const double t124 = t122*t123; /* g*m*m*a3*a3*a3 */
    const double t125 = x[0]*t124; /* gamma3*g*m*m*a3*a3*a3 */
    const double t126 = t2*t125; /* s*gamma3*g*m*m*a3*a3*a3 */
    const double t127 = t126/t115; /* s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t128 = 2.0*t127; /* 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t129 = t121 - t128; /* t118 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t130 = t4*p[4]; /* omega_n*omega_n*I1 */
    const double t131 = t130/t29; /* omega_n*omega_n*I1/(s*D) */
    const double t132 = t129 - t131; /* t118 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) - omega_n*omega_n*I1/(s*D) */
    const double t133 = t0*p[4]; /* gamma3*gamma3*I1 */
    const double t134 = t4*t133; /* omega_n*omega_n*gamma3*gamma3*I1 */
    const double t135 = t20*t93; /* D*s*s*s */
    const double t136 = t134/t135; /* omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) */
    const double t137 = t132 - t136; /* t132 - omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) */
    const double t138 = t13*p[4]; /* m*a3*a3*I1 */
    const double t139 = t0*t138; /* gamma3*gamma3*m*a3*a3*I1 */
    const double t140 = t4*t139; /* omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1 */
    const double t141 = t2*t115; /* s*D*D */
    const double t142 = t140/t141; /* omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1/(s*D*D) */
    const double t143 = 2.0*t142; /* 2*omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1/(s*D*D) */
    const double t144 = t137 - t143; /* t132 - omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) - 2*omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1/(s*D*D) */
    const double t145 = t13*p[5]; /* m*a3*a3*I3 */
    const double t146 = x[0]*t145; /* gamma3*m*a3*a3*I3 */
    const double t147 = x[3]*t146; /* omega_n*gamma3*m*a3*a3*I3 */
    const double t148 = x[4]*t147; /* omega3*omega_n*gamma3*m*a3*a3*I3 */
    const double t149 = t148/t115; /* omega3*omega_n*gamma3*m*a3*a3*I3/(D*D) */
    const double t150 = 2.0*t149; /* 2*omega3*omega_n*gamma3*m*a3*a3*I3/(D*D) */
    const double t151 = t144 - t150; /* t144 - 2*omega3*omega_n*gamma3*m*a3*a3*I3/(D*D) */
    const double t152 = p[0]*2.0; /* m*2 */
    const double t153 = t12*t152; /* a3*a3*m*2 */
    const double t154 = x[0]*t153; /* gamma3*a3*a3*m*2 */
    const double t155 = x[2]*t154; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t156 = t2*t155; /* s*omega_tau*gamma3*a3*a3*m*2 */
    const double t157 = t156/t20; /* s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t158 = x[3]*t27; /* omega_n*gamma3*I1 */
    const double t159 = t158/t29; /* omega_n*gamma3*I1/(s*D) */
    const double t160 = 2.0*t159; /* 2*omega_n*gamma3*I1/(s*D) */
    const double t161 = -t160; /* -2*omega_n*gamma3*I1/(s*D) */
    const double t162 = x[4]*p[5]; /* omega3*I3 */
    const double t163 = t162/t20; /* omega3*I3/D */
    const double t164 = t161 - t163; /* -2*omega_n*gamma3*I1/(s*D) - omega3*I3/D */
    const double t165 = t32/t20; /* omega_n*I3/D */
    const double t166 = -t165; /* -omega_n*I3/D */
    const double t167 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t168 = t167/t2; /* omega_tau*omega_n/s */
    const double t169 = x[2]*t0; /* omega_tau*gamma3*gamma3 */
    const double t170 = x[3]*t169; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t171 = t170/t93; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t172 = t168 + t171; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t173 = x[3]*t64; /* omega_n*I3*R*m */
    const double t174 = t54*t173; /* V*omega_n*I3*R*m */
    const double t175 = t174/t50; /* V*omega_n*I3*R*m/(s*Theta) */
    const double t176 = t172 - t175; /* t172 - V*omega_n*I3*R*m/(s*Theta) */
    const double t177 = t49*t49; /* Theta*Theta */
    const double t178 = t2*t177; /* s*Theta*Theta */
    const double t179 = x[0]*t44; /* gamma3*I1*m*R*R */
    const double t180 = 2.0*t179; /* 2*gamma3*I1*m*R*R */
    const double t181 = t6*t64; /* b*I3*R*m */
    const double t182 = 2.0*t181; /* 2*b*I3*R*m */
    const double t183 = t182 - t180; /* d(Theta)/d(gamma3) = 2*b*I3*R*m - 2*gamma3*I1*m*R*R */
    const double t184 = t55*t183; /* b*omega_n*m*I3*V*d(Theta)/d(gamma3) */
    const double t185 = t184/t178; /* b*omega_n*m*I3*V*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t186 = t176 + t185; /* t172 - V*omega_n*I3*R*m/(s*Theta) + b*omega_n*m*I3*V*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t187 = p[3]*p[0]; /* a3*m */
    const double t188 = p[5]*t187; /* I3*a3*m */
    const double t189 = x[2]*t188; /* omega_tau*I3*a3*m */
    const double t190 = x[3]*t189; /* omega_n*omega_tau*I3*a3*m */
    const double t191 = t6*t190; /* b*omega_n*omega_tau*I3*a3*m */
    const double t192 = t191/t50; /* b*omega_n*omega_tau*I3*a3*m/(s*Theta) */
    const double t193 = t186 - t192; /* t186 - b*omega_n*omega_tau*I3*a3*m/(s*Theta) */
    const double t194 = x[0]*t39; /* gamma3*m*I3 */
    const double t195 = x[3]*t194; /* omega_n*gamma3*m*I3 */
    const double t196 = t6*t195; /* b*omega_n*gamma3*m*I3 */
    const double t197 = t49*t93; /* Theta*s*s*s */
    const double t198 = t54*t196; /* V*b*omega_n*gamma3*m*I3 */
    const double t199 = t198/t197; /* V*b*omega_n*gamma3*m*I3/(Theta*s*s*s) */
    const double t200 = t193 - t199; /* t186 - b*omega_n*omega_tau*I3*a3*m/(s*Theta) - V*b*omega_n*gamma3*m*I3/(Theta*s*s*s) */
    const double t201 = t60*t183; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3) */
    const double t202 = t201/t177; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t203 = t200 - t202; /* t200 - omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t204 = t84/t49; /* omega3*omega_tau*I3*a3*R*m/Theta */
    const double t205 = t203 + t204; /* t203 + omega3*omega_tau*I3*a3*R*m/Theta */
    const double t206 = t67*t183; /* e*omega3*omega_tau*I3*R*m*d(Theta)/d(gamma3) */
    const double t207 = t206/t177; /* e*omega3*omega_tau*I3*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t208 = t205 - t207; /* t203 + omega3*omega_tau*I3*a3*R*m/Theta - e*omega3*omega_tau*I3*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t209 = t41/t50; /* b*omega_n*m*I3/(s*Theta) */
    const double t210 = -t209; /* -b*omega_n*m*I3/(s*Theta) */
    const double t211 = x[0]*x[3]; /* gamma3*omega_n */
    const double t212 = t211/t2; /* gamma3*omega_n/s */
    const double t213 = t41*t52; /* b*omega_n*m*I3*e */
    const double t214 = t213/t50; /* b*omega_n*m*I3*e/(s*Theta) */
    const double t215 = t212 - t214; /* gamma3*omega_n/s - b*omega_n*m*I3*e/(s*Theta) */
    const double t216 = x[4]*t58; /* omega3*I3*I3 */
    const double t217 = t216/t49; /* omega3*I3*I3/Theta */
    const double t218 = t215 + t217; /* gamma3*omega_n/s - b*omega_n*m*I3*e/(s*Theta) + omega3*I3*I3/Theta */
    const double t219 = x[4]*t64; /* omega3*I3*R*m */
    const double t220 = t52*t219; /* e*omega3*I3*R*m */
    const double t221 = t220/t49; /* e*omega3*I3*R*m/Theta */
    const double t222 = t218 + t221; /* t218 + e*omega3*I3*R*m/Theta */
    const double t223 = t6*t39; /* b*m*I3 */
    const double t224 = t54*t223; /* V*b*m*I3 */
    const double t225 = t224/t50; /* V*b*m*I3/(s*Theta) */
    const double t226 = t88 - t225; /* omega_tau*gamma3/s - V*b*m*I3/(s*Theta) */
    const double t227 = t59/t49; /* omega_tau*I3*I3/Theta */
    const double t228 = t52*t65; /* e*omega_tau*I3*R*m */
    const double t229 = t228/t49; /* e*omega_tau*I3*R*m/Theta */
    const double t230 = t227 + t229; /* omega_tau*I3*I3/Theta + e*omega_tau*I3*R*m/Theta */
    const double t231 = t72*t183; /* V*omega_n*I1*R*m*d(Theta)/d(gamma3) */
    const double t232 = t231/t177; /* V*omega_n*I1*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t233 = p[4]*t81; /* I1*a3*R*m */
    const double t234 = x[2]*t233; /* omega_tau*I1*a3*R*m */
    const double t235 = x[3]*t234; /* omega_n*omega_tau*I1*a3*R*m */
    const double t236 = t235/t49; /* omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t237 = t232 - t236; /* V*omega_n*I1*R*m*d(Theta)/d(gamma3)/(Theta*Theta) - omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t238 = x[2]*t43; /* omega_tau*m*R*R */
    const double t239 = x[4]*t238; /* omega3*omega_tau*m*R*R */
    const double t240 = t2*t239; /* s*omega3*omega_tau*m*R*R */
    const double t241 = p[7]*t240; /* (I1 - I3)*s*omega3*omega_tau*m*R*R */
    const double t242 = t241/t49; /* (I1 - I3)*s*omega3*omega_tau*m*R*R/Theta */
    const double t243 = t237 + t242; /* t237 + (I1 - I3)*s*omega3*omega_tau*m*R*R/Theta */
    const double t244 = t78*t183; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t245 = t244/t177; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t246 = t243 - t245; /* t237 + (I1 - I3)*s*omega3*omega_tau*m*R*R/Theta - t245 */
    const double t247 = t0*t43; /* gamma3*gamma3*m*R*R */
    const double t248 = x[2]*t247; /* omega_tau*gamma3*gamma3*m*R*R */
    const double t249 = x[4]*t248; /* omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t250 = p[7]*t249; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t251 = t250/t50; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t252 = t246 - t251; /* t237 + (I1 - I3)*s*omega3*omega_tau*m*R*R/Theta - t245 - (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t253 = t85*t183; /* s*omega3*omega_tau*I3*a3*R*m*d(Theta)/d(gamma3) */
    const double t254 = t253/t177; /* s*omega3*omega_tau*I3*a3*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t255 = t252 + t254; /* t252 + t254 */
    const double t256 = x[0]*t82; /* gamma3*I3*a3*R*m */
    const double t257 = x[2]*t256; /* omega_tau*gamma3*I3*a3*R*m */
    const double t258 = x[4]*t257; /* omega3*omega_tau*gamma3*I3*a3*R*m */
    const double t259 = t258/t50; /* omega3*omega_tau*gamma3*I3*a3*R*m/(s*Theta) */
    const double t260 = t255 + t259; /* t252 + t254 + omega3*omega_tau*gamma3*I3*a3*R*m/(s*Theta) */
    const double t261 = t71/t49; /* omega_n*I1*R*m/Theta */
    const double t262 = -t261; /* -omega_n*I1*R*m/Theta */
    const double t263 = x[4]*t74; /* omega3*gamma3*m*R*R */
    const double t264 = t2*t263; /* s*omega3*gamma3*m*R*R */
    const double t265 = p[7]*t264; /* (I1 - I3)*s*omega3*gamma3*m*R*R */
    const double t266 = t265/t49; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta */
    const double t267 = t52*t71; /* e*omega_n*I1*R*m */
    const double t268 = t267/t49; /* e*omega_n*I1*R*m/Theta */
    const double t269 = t266 - t268; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta - e*omega_n*I1*R*m/Theta */
    const double t270 = x[4]*t82; /* omega3*I3*a3*R*m */
    const double t271 = t2*t270; /* s*omega3*I3*a3*R*m */
    const double t272 = t271/t49; /* s*omega3*I3*a3*R*m/Theta */
    const double t273 = t269 - t272; /* t269 - s*omega3*I3*a3*R*m/Theta */
    const double t274 = t54*t70; /* V*I1*R*m */
    const double t275 = t274/t49; /* V*I1*R*m/Theta */
    const double t276 = -t275; /* -V*I1*R*m/Theta */
    const double t277 = t2*t75; /* s*omega_tau*gamma3*m*R*R */
    const double t278 = p[7]*t277; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R */
    const double t279 = t278/t49; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta */
    const double t280 = t2*t83; /* s*omega_tau*I3*a3*R*m */
    const double t281 = t280/t49; /* s*omega_tau*I3*a3*R*m/Theta */
    const double t282 = t279 - t281; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta - s*omega_tau*I3*a3*R*m/Theta */
    out[0] = t3;
    out[1] = t11;
    out[2] = t35;
    out[3] = t69;
    out[4] = t87;
    out[5] = t89;
    out[6] = 0.0;
    out[7] = t2;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = t96;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t101;
    out[14] = t9;
    out[15] = t151;
    out[16] = 0.0;
    out[17] = t157;
    out[18] = t164;
    out[19] = t166;
    out[20] = t208;
    out[21] = t210;
    out[22] = t222;
    out[23] = t226;
    out[24] = t230;
    out[25] = t260;
    out[26] = t262;
    out[27] = t273;
    out[28] = t276;
    out[29] = t282;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*p[3]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = t2*x[2]; /* m*a3*a3*gamma3*omega_tau */
    const double t4 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t5 = 1.0 - t4; /* 1 - gamma3*gamma3 */
    const double t6 = sqrt(t5); /* s = sqrt(1 - gamma3*gamma3) */
    const double t7 = t3*t6; /* m*a3*a3*gamma3*omega_tau*s */
    const double t8 = t6*t6; /* s*s */
    const double t9 = t1*t8; /* m*a3*a3*s*s */
    const double t10 = p[4] + t9; /* D = I1 + m*a3*a3*s*s */
    const double t11 = t7/t10; /* m*a3*a3*gamma3*omega_tau*s/D */
    const double t12 = t11*2.0; /* m*a3*a3*gamma3*omega_tau*s/D*2 */
    const double t13 = p[0]*p[5]; /* m*I3 */
    const double t14 = x[0]*p[1]; /* gamma3*R */
    const double t15 = p[3] + t14; /* b = a3 + gamma3*R */
    const double t16 = t13*t15; /* m*I3*b */
    const double t17 = p[1]*p[1]; /* R*R */
    const double t18 = p[0]*t17; /* m*R*R */
    const double t19 = p[4]*t18; /* I1*m*R*R */
    const double t20 = t8*t19; /* s*s*I1*m*R*R */
    const double t21 = p[6] + t20; /* I1*I3 + s*s*I1*m*R*R */
    const double t22 = t15*t15; /* b*b */
    const double t23 = t13*t22; /* m*I3*b*b */
    const double t24 = t21 + t23; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t25 = t6*t24; /* s*Theta */
    const double t26 = p[3]*x[0]; /* a3*gamma3 */
    const double t27 = p[1] + t26; /* e = R + a3*gamma3 */
    const double t28 = x[2]*t27; /* omega_tau*e */
    const double t29 = x[1] + t28; /* V = v_nu + omega_tau*e */
    const double t30 = t16*t29; /* m*I3*b*V */
    const double t31 = t30/t25; /* m*I3*b*V/(s*Theta) */
    const double t32 = t12 - t31; /* m*a3*a3*gamma3*omega_tau*s/D*2 - m*I3*b*V/(s*Theta) */
    const double t33 = x[0]*t18; /* gamma3*m*R*R */
    const double t34 = x[2]*t33; /* omega_tau*gamma3*m*R*R */
    const double t35 = t6*t34; /* s*omega_tau*gamma3*m*R*R */
    const double t36 = t35*p[7]; /* s*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t37 = t36/t24; /* s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t38 = t32 + t37; /* m*a3*a3*gamma3*omega_tau*s/D*2 - m*I3*b*V/(s*Theta) + s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t39 = p[0]*p[1]; /* m*R */
    const double t40 = p[3]*t39; /* a3*m*R */
    const double t41 = p[5]*t40; /* I3*a3*m*R */
    const double t42 = x[2]*t41; /* omega_tau*I3*a3*m*R */
    const double t43 = t6*t42; /* s*omega_tau*I3*a3*m*R */
    const double t44 = t43/t24; /* s*omega_tau*I3*a3*m*R/Theta */
    const double t45 = t38 - t44; /* t38 - s*omega_tau*I3*a3*m*R/Theta */
    out[0] = t45;
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
    const double t10 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t11 = 1.0 - t10; /* 1 - gamma3*gamma3 */
    const double t12 = sqrt(t11); /* s = sqrt(1 - gamma3*gamma3) */
    const double t13 = t12*t12; /* s*s */
    const double t14 = t9*t13; /* m*a3*a3*s*s */
    const double t15 = p[4] + t14; /* D = I1 + m*a3*a3*s*s */
    const double t16 = t7*t15; /* omega_tau*omega_tau*D */
    const double t17 = (1.0 / 2.0)*t16; /* 1/2*omega_tau*omega_tau*D */
    const double t18 = t6 + t17; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D */
    const double t19 = x[3]*x[3]; /* omega_n*omega_n */
    const double t20 = p[4]*t19; /* I1*omega_n*omega_n */
    const double t21 = (1.0 / 2.0)*t20; /* 1/2*I1*omega_n*omega_n */
    const double t22 = t18 + t21; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*I1*omega_n*omega_n */
    const double t23 = x[4]*x[4]; /* omega3*omega3 */
    const double t24 = p[5]*t23; /* I3*omega3*omega3 */
    const double t25 = (1.0 / 2.0)*t24; /* 1/2*I3*omega3*omega3 */
    const double t26 = t22 + t25; /* t22 + 1/2*I3*omega3*omega3 */
    const double t27 = x[0]*p[1]; /* gamma3*R */
    const double t28 = p[3] + t27; /* b = a3 + gamma3*R */
    const double t29 = x[3]*t28; /* omega_n*b */
    const double t30 = x[4]*p[1]; /* omega3*R */
    const double t31 = t12*t30; /* s*omega3*R */
    const double t32 = t29 + t31; /* v_tau = omega_n*b + s*omega3*R */
    const double t33 = t32*t32; /* v_tau*v_tau */
    const double t34 = p[0]*t33; /* m*v_tau*v_tau */
    const double t35 = (1.0 / 2.0)*t34; /* 1/2*m*v_tau*v_tau */
    const double t36 = t26 + t35; /* energy = t22 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    const double t37 = p[4]*p[1]; /* I1*R */
    const double t38 = x[3]*t37; /* omega_n*I1*R */
    const double t39 = t12*t38; /* s*omega_n*I1*R */
    const double t40 = p[5]*x[4]; /* I3*omega3 */
    const double t41 = t28*t40; /* b*I3*omega3 */
    const double t42 = t39 - t41; /* s*omega_n*I1*R - b*I3*omega3 */
    out[0] = t36;
    out[1] = t42;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*p[3]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t4 = t2*t3; /* m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t5 = p[8] - t4; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t6 = x[0]*p[1]; /* gamma3*R */
    const double t7 = p[3] + t6; /* b = a3 + gamma3*R */
    const double t8 = x[3]*t7; /* omega_n*b */
    const double t9 = p[1]*x[4]; /* R*omega3 */
    const double t10 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t11 = 1.0 - t10; /* 1 - gamma3*gamma3 */
    const double t12 = sqrt(t11); /* s = sqrt(1 - gamma3*gamma3) */
    const double t13 = t9*t12; /* R*omega3*s */
    const double t14 = t8 + t13; /* v_tau = omega_n*b + R*omega3*s */
    const double t15 = p[0]*t14; /* m*v_tau */
    const double t16 = x[3]*p[1]; /* omega_n*R */
    const double t17 = t6*x[4]; /* gamma3*R*omega3 */
    const double t18 = t17/t12; /* gamma3*R*omega3/s */
    const double t19 = t16 - t18; /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*R*omega3/s */
    const double t20 = t15*t19; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t21 = t5 + t20; /* d(energy)/d(gamma3) = m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau + m*v_tau*d(v_tau)/d(gamma3) */
    const double t22 = p[0]*x[1]; /* m*v_nu */
    const double t23 = t12*t12; /* s*s */
    const double t24 = t1*t23; /* m*a3*a3*s*s */
    const double t25 = p[4] + t24; /* D = I1 + m*a3*a3*s*s */
    const double t26 = x[2]*t25; /* omega_tau*D */
    const double t27 = x[3]*p[4]; /* omega_n*I1 */
    const double t28 = p[0]*t7; /* m*b */
    const double t29 = t14*t28; /* v_tau*m*b */
    const double t30 = t27 + t29; /* d(energy)/d(omega_n) = omega_n*I1 + v_tau*m*b */
    const double t31 = x[4]*p[5]; /* omega3*I3 */
    const double t32 = p[0]*p[1]; /* m*R */
    const double t33 = t12*t32; /* s*m*R */
    const double t34 = t14*t33; /* v_tau*s*m*R */
    const double t35 = t31 + t34; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    const double t36 = p[1]*p[4]; /* R*I1 */
    const double t37 = x[0]*t36; /* gamma3*R*I1 */
    const double t38 = x[3]*t37; /* omega_n*gamma3*R*I1 */
    const double t39 = t38/t12; /* omega_n*gamma3*R*I1/s */
    const double t40 = -t39; /* -omega_n*gamma3*R*I1/s */
    const double t41 = p[1]*p[5]; /* R*I3 */
    const double t42 = x[4]*t41; /* omega3*R*I3 */
    const double t43 = t40 - t42; /* -omega_n*gamma3*R*I1/s - omega3*R*I3 */
    const double t44 = t12*t36; /* s*R*I1 */
    const double t45 = t7*p[5]; /* b*I3 */
    const double t46 = -t45; /* -b*I3 */
    out[0] = t21;
    out[1] = t22;
    out[2] = t26;
    out[3] = t30;
    out[4] = t35;
    out[5] = t43;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t44;
    out[9] = t46;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double complex v_omega_n = x[3];
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega3 = x[4];
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = params[5];
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta);
    out[4] = (-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta);
}

static const unsigned char family0_is_free[] = { 1, 1, 0, 0, 1 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = x[4];
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[5]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I3*gamma3*v_nu */
    const double t4 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t5 = 1.0 - t4; /* 1 - gamma3*gamma3 */
    const double t6 = sqrt(t5); /* s = sqrt(1 - gamma3*gamma3) */
    const double t7 = params[5]*params[4]; /* I3*I1 */
    const double t8 = params[1]*params[1]; /* R*R */
    const double t9 = params[0]*t8; /* m*R*R */
    const double t10 = params[4]*t9; /* I1*m*R*R */
    const double t11 = t6*t6; /* s*s */
    const double t12 = t10*t11; /* I1*m*R*R*s*s */
    const double t13 = t7 + t12; /* I3*I1 + I1*m*R*R*s*s */
    const double t14 = params[0]*params[5]; /* m*I3 */
    const double t15 = params[1]*x[0]; /* R*gamma3 */
    const double t16 = params[3] + t15; /* b = a3 + R*gamma3 */
    const double t17 = t16*t16; /* b*b */
    const double t18 = t14*t17; /* m*I3*b*b */
    const double t19 = t13 + t18; /* Theta = I3*I1 + I1*m*R*R*s*s + m*I3*b*b */
    const double t20 = t6*t19; /* s*Theta */
    const double t21 = t3/t20; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t22 = -t21; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t22;
}

static void family0_charpoly(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = params[4]*t2; /* I1*s */
    const double t4 = params[4]*params[5]; /* I1*I3 */
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    const double t7 = params[4]*t6; /* I1*m*R*R */
    const double t8 = t2*t2; /* s*s */
    const double t9 = t7*t8; /* I1*m*R*R*s*s */
    const double t10 = t4 + t9; /* I1*I3 + I1*m*R*R*s*s */
    const double t11 = params[5]*params[0]; /* I3*m */
    const double t12 = x[0]*params[1]; /* gamma3*R */
    const double t13 = params[3] + t12; /* b = a3 + gamma3*R */
    const double t14 = t13*t13; /* b*b */
    const double t15 = t11*t14; /* I3*m*b*b */
    const double t16 = t10 + t15; /* Theta = I1*I3 + I1*m*R*R*s*s + I3*m*b*b */
    const double t17 = t3*t16; /* I1*s*Theta */
    const double t18 = params[0]*params[1]; /* m*R */
    const double t19 = params[4]*t18; /* I1*m*R */
    const double t20 = params[5]*t19; /* I3*I1*m*R */
    const double t21 = x[0]*t20; /* gamma3*I3*I1*m*R */
    const double t22 = t21*x[1]; /* gamma3*I3*I1*m*R*v_nu */
    const double t23 = params[5]*params[5]; /* I3*I3 */
    const double t24 = x[4]*x[4]; /* omega3*omega3 */
    const double t25 = t23*t24; /* I3*I3*omega3*omega3 */
    const double t26 = t2*t25; /* s*I3*I3*omega3*omega3 */
    const double t27 = params[5] + t6; /* I3 + m*R*R */
    const double t28 = t26*t27; /* s*I3*I3*omega3*omega3*(I3 + m*R*R) */
    out[0] = t17;
    out[1] = t22;
    out[2] = t28;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = params[1]*x[4]; /* R*omega3 */
    const double t4 = x[4]*params[5]; /* omega3*I3 */
    const double t5 = t4/params[4]; /* omega3*I3/I1 */
    const double t6 = -t5; /* -omega3*I3/I1 */
    const double t7 = params[4]*params[5]; /* I1*I3 */
    const double t8 = params[1]*params[1]; /* R*R */
    const double t9 = params[0]*t8; /* m*R*R */
    const double t10 = params[4]*t9; /* I1*m*R*R */
    const double t11 = t2*t2; /* s*s */
    const double t12 = t10*t11; /* I1*m*R*R*s*s */
    const double t13 = t7 + t12; /* I1*I3 + I1*m*R*R*s*s */
    const double t14 = params[5]*params[0]; /* I3*m */
    const double t15 = x[0]*params[1]; /* gamma3*R */
    const double t16 = params[3] + t15; /* b = a3 + gamma3*R */
    const double t17 = t16*t16; /* b*b */
    const double t18 = t14*t17; /* I3*m*b*b */
    const double t19 = t13 + t18; /* Theta = I1*I3 + I1*m*R*R*s*s + I3*m*b*b */
    const double t20 = params[5] + t9; /* I3 + m*R*R */
    const double t21 = t4*t20; /* omega3*I3*(I3 + m*R*R) */
    const double t22 = t21/t19; /* omega3*I3*(I3 + m*R*R)/Theta */
    const double t23 = params[1]*params[0]; /* R*m */
    const double t24 = params[5]*t23; /* I3*R*m */
    const double t25 = x[0]*t24; /* gamma3*I3*R*m */
    const double t26 = t25*x[1]; /* gamma3*I3*R*m*v_nu */
    const double t27 = t2*t19; /* s*Theta */
    const double t28 = t26/t27; /* gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t29 = -t28; /* -gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t30 = x[0]*t9; /* gamma3*m*R*R */
    const double t31 = x[4]*t30; /* omega3*gamma3*m*R*R */
    const double t32 = t2*t31; /* s*omega3*gamma3*m*R*R */
    const double t33 = params[4] - params[5]; /* I1 - I3 */
    const double t34 = t32*t33; /* s*omega3*gamma3*m*R*R*(I1 - I3) */
    const double t35 = t34/t19; /* s*omega3*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t36 = params[4]*t23; /* I1*R*m */
    const double t37 = x[1]*t36; /* v_nu*I1*R*m */
    const double t38 = t37/t19; /* v_nu*I1*R*m/Theta */
    const double t39 = -t38; /* -v_nu*I1*R*m/Theta */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t2;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t3;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t6;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = t22;
    out[18] = t29;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = t35;
    out[23] = t39;
    out[24] = 0.0;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = t0*params[3]; /* m*g*a3 */
    const double t2 = x[0]*params[1]; /* gamma3*R */
    const double t3 = params[3] + t2; /* b = a3 + gamma3*R */
    const double t4 = params[1]*x[4]; /* R*omega3 */
    const double t5 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t6 = 1.0 - t5; /* 1 - gamma3*gamma3 */
    const double t7 = sqrt(t6); /* s = sqrt(1 - gamma3*gamma3) */
    const double t8 = t4*t7; /* v_tau = R*omega3*s */
    const double t9 = params[0]*t8; /* m*v_tau */
    const double t10 = t2*x[4]; /* gamma3*R*omega3 */
    const double t11 = t10/t7; /* gamma3*R*omega3/s */
    const double t12 = t9*t11; /* m*v_tau*gamma3*R*omega3/s */
    const double t13 = t1 - t12; /* d(energy)/d(gamma3) = m*g*a3 - m*v_tau*gamma3*R*omega3/s */
    const double t14 = params[0]*x[1]; /* m*v_nu */
    const double t15 = t7*t7; /* s*s */
    const double t16 = params[0]*t3; /* m*b */
    const double t17 = t8*t16; /* d(energy)/d(omega_n) = v_tau*m*b */
    const double t18 = x[4]*params[5]; /* omega3*I3 */
    const double t19 = params[0]*params[1]; /* m*R */
    const double t20 = t7*t19; /* s*m*R */
    const double t21 = t8*t20; /* v_tau*s*m*R */
    const double t22 = t18 + t21; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    const double t23 = params[1]*params[4]; /* R*I1 */
    const double t24 = params[1]*params[5]; /* R*I3 */
    const double t25 = x[4]*t24; /* omega3*R*I3 */
    const double t26 = -t25; /* -omega3*R*I3 */
    const double t27 = t7*t23; /* s*R*I1 */
    const double t28 = t3*params[5]; /* b*I3 */
    const double t29 = -t28; /* -b*I3 */
    const double t30 = x[4]*x[4]; /* omega3*omega3 */
    const double t31 = params[4] - params[5]; /* I1 - I3 */
    const double t32 = t30*t31; /* omega3*omega3*(I1 - I3) */
    const double t33 = params[1]*params[1]; /* R*R */
    const double t34 = params[0]*t33; /* m*R*R */
    const double t35 = params[4]*t34; /* I1*m*R*R */
    const double t36 = x[0]*t35; /* gamma3*I1*m*R*R */
    const double t37 = t36*2.0; /* gamma3*I1*m*R*R*2 */
    const double t38 = params[5]*t19; /* I3*m*R */
    const double t39 = t3*t38; /* b*I3*m*R */
    const double t40 = 2.0*t39; /* 2*b*I3*m*R */
    const double t41 = t40 - t37; /* d(Theta)/d(gamma3) = 2*b*I3*m*R - gamma3*I1*m*R*R*2 */
    const double t42 = t32*t41; /* omega3*omega3*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t43 = params[0]*2.0; /* m*2 */
    const double t44 = params[4]*params[4]; /* I1*I1 */
    const double t45 = t43*t44; /* m*2*I1*I1 */
    const double t46 = x[1]*t45; /* v_nu*m*2*I1*I1 */
    const double t47 = params[1]*t43; /* R*m*2 */
    const double t48 = t44*t47; /* I1*I1*R*m*2 */
    const double t49 = x[1]*t48; /* v_nu*I1*I1*R*m*2 */
    const double t50 = x[4]*2.0; /* omega3*2 */
    const double t51 = params[4]*params[5]; /* I1*I3 */
    const double t52 = t15*t35; /* s*s*I1*m*R*R */
    const double t53 = t51 + t52; /* I1*I3 + s*s*I1*m*R*R */
    const double t54 = params[0]*params[5]; /* m*I3 */
    const double t55 = t3*t3; /* b*b */
    const double t56 = t54*t55; /* m*I3*b*b */
    const double t57 = t53 + t56; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t58 = t50*t57; /* omega3*2*Theta */
    const double t59 = t31*t58; /* (I1 - I3)*omega3*2*Theta */
    out[0] = t13;
    out[1] = t14;
    out[2] = 0.0;
    out[3] = t17;
    out[4] = t22;
    out[5] = t26;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t27;
    out[9] = t29;
    out[10] = t42;
    out[11] = t46;
    out[12] = t49;
    out[13] = 0.0;
    out[14] = t59;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "G", "" },
    { "F0", "a3 = 0" },
};

static const unsigned char family1_is_free[] = { 1, 1, 0, 0, 1 };

static void family1_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = 0.0;
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
}

static void family1_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = x[4];
}

static void family1_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[5]; /* m*I3 */
    const double t1 = t0*x[1]; /* m*I3*v_nu */
    const double t2 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t3 = 1.0 - t2; /* 1 - gamma3*gamma3 */
    const double t4 = sqrt(t3); /* s = sqrt(1 - gamma3*gamma3) */
    const double t5 = x[0]*params[1]; /* gamma3*R */
    const double t6 = params[3] + t5; /* b = a3 + gamma3*R */
    const double t7 = t1*t6; /* m*I3*v_nu*b */
    const double t8 = params[5]*params[4]; /* I3*I1 */
    const double t9 = params[1]*params[1]; /* R*R */
    const double t10 = params[0]*t9; /* m*R*R */
    const double t11 = params[4]*t10; /* I1*m*R*R */
    const double t12 = t4*t4; /* s*s */
    const double t13 = t11*t12; /* I1*m*R*R*s*s */
    const double t14 = t8 + t13; /* I3*I1 + I1*m*R*R*s*s */
    const double t15 = t6*t6; /* b*b */
    const double t16 = t0*t15; /* m*I3*b*b */
    const double t17 = t14 + t16; /* Theta = I3*I1 + I1*m*R*R*s*s + m*I3*b*b */
    const double t18 = t4*t17; /* s*Theta */
    const double t19 = t7/t18; /* m*I3*v_nu*b/(s*Theta) */
    const double t20 = -t19; /* -m*I3*v_nu*b/(s*Theta) */
    out[0] = t20;
}

static void family1_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = t0*params[3]; /* m*g*a3 */
    const double t2 = x[0]*params[1]; /* gamma3*R */
    const double t3 = params[3] + t2; /* b = a3 + gamma3*R */
    const double t4 = params[1]*x[4]; /* R*omega3 */
    const double t5 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t6 = 1.0 - t5; /* 1 - gamma3*gamma3 */
    const double t7 = sqrt(t6); /* s = sqrt(1 - gamma3*gamma3) */
    const double t8 = t4*t7; /* v_tau = R*omega3*s */
    const double t9 = params[0]*t8; /* m*v_tau */
    const double t10 = t2*x[4]; /* gamma3*R*omega3 */
    const double t11 = t10/t7; /* gamma3*R*omega3/s */
    const double t12 = t9*t11; /* m*v_tau*gamma3*R*omega3/s */
    const double t13 = t1 - t12; /* d(energy)/d(gamma3) = m*g*a3 - m*v_tau*gamma3*R*omega3/s */
    const double t14 = params[0]*x[1]; /* m*v_nu */
    const double t15 = params[0]*t3; /* m*b */
    const double t16 = t8*t15; /* d(energy)/d(omega_n) = v_tau*m*b */
    const double t17 = x[4]*params[5]; /* omega3*I3 */
    const double t18 = params[0]*params[1]; /* m*R */
    const double t19 = t7*t18; /* s*m*R */
    const double t20 = t8*t19; /* v_tau*s*m*R */
    const double t21 = t17 + t20; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    const double t22 = params[1]*params[4]; /* R*I1 */
    const double t23 = params[1]*params[5]; /* R*I3 */
    const double t24 = x[4]*t23; /* omega3*R*I3 */
    const double t25 = -t24; /* -omega3*R*I3 */
    const double t26 = t7*t22; /* s*R*I1 */
    const double t27 = t3*params[5]; /* b*I3 */
    const double t28 = -t27; /* -b*I3 */
    out[0] = t13;
    out[1] = t14;
    out[2] = 0.0;
    out[3] = t16;
    out[4] = t21;
    out[5] = t25;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t26;
    out[9] = t28;
}

static const jlt_named family1_left_null[] = {
    { "E", "" },
    { "G", "" },
};

static const unsigned char family2_is_free[] = { 1, 0, 0, 1, 0 };

static void family2_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[3]; /* m*R*a3 */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t4 = 1.0 - t3; /* 1 - gamma3*gamma3 */
    const double t5 = sqrt(t4); /* s = sqrt(1 - gamma3*gamma3) */
    const double t6 = t5*t5; /* s*s */
    const double t7 = t1*t6; /* m*R*a3*s*s */
    const double t8 = params[1]*x[0]; /* R*gamma3 */
    const double t9 = params[3] + t8; /* b = a3 + R*gamma3 */
    const double t10 = params[5]*t9; /* I3*b */
    const double t11 = params[1]*params[4]; /* R*I1 */
    const double t12 = x[0]*t11; /* gamma3*R*I1 */
    const double t13 = t10 - t12; /* I3*b - gamma3*R*I1 */
    const double t14 = t2*t13; /* omega_n*omega_n*(I3*b - gamma3*R*I1) */
    const double t15 = t14/t7; /* g = omega_n*omega_n*(I3*b - gamma3*R*I1)/(m*R*a3*s*s) */
    out[0] = params[0];
    out[1] = params[1];
    out[2] = t15;
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
}

static void family2_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = params[1]*t2; /* R*s */
    const double t4 = x[0]*params[1]; /* gamma3*R */
    const double t5 = params[3] + t4; /* b = a3 + gamma3*R */
    const double t6 = x[3]*t5; /* omega_n*b */
    const double t7 = t6/t3; /* omega_n*b/(R*s) */
    const double t8 = -t7; /* omega3 = -omega_n*b/(R*s) */
    out[0] = x[0];
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = x[3];
    out[4] = t8;
}

static void family2_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
}

static void family2_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = t0*params[3]; /* m*g*a3 */
    const double t2 = x[0]*params[1]; /* gamma3*R */
    const double t3 = params[3] + t2; /* b = a3 + gamma3*R */
    const double t4 = x[3]*t3; /* omega_n*b */
    const double t5 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t6 = 1.0 - t5; /* 1 - gamma3*gamma3 */
    const double t7 = sqrt(t6); /* s = sqrt(1 - gamma3*gamma3) */
    const double t8 = params[1]*t7; /* R*s */
    const double t9 = t4/t8; /* omega_n*b/(R*s) */
    const double t10 = params[1]*t9; /* R*omega_n*b/(R*s) */
    const double t11 = t7*t10; /* s*R*omega_n*b/(R*s) */
    const double t12 = t4 - t11; /* v_tau = omega_n*b - s*R*omega_n*b/(R*s) */
    const double t13 = params[0]*t12; /* m*v_tau */
    const double t14 = x[3]*params[1]; /* omega_n*R */
    const double t15 = t2*t9; /* gamma3*R*omega_n*b/(R*s) */
    const double t16 = t15/t7; /* gamma3*R*omega_n*b/(R*s)/s */
    const double t17 = t14 + t16; /* d(v_tau)/d(gamma3) = omega_n*R + gamma3*R*omega_n*b/(R*s)/s */
    const double t18 = t13*t17; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t19 = t1 + t18; /* d(energy)/d(gamma3) = m*g*a3 + m*v_tau*d(v_tau)/d(gamma3) */
    const double t20 = x[3]*params[4]; /* omega_n*I1 */
    const double t21 = params[0]*t3; /* m*b */
    const double t22 = t12*t21; /* v_tau*m*b */
    const double t23 = t20 + t22; /* d(energy)/d(omega_n) = omega_n*I1 + v_tau*m*b */
    const double t24 = t9*params[5]; /* omega_n*b/(R*s)*I3 */
    const double t25 = params[0]*params[1]; /* m*R */
    const double t26 = t7*t25; /* s*m*R */
    const double t27 = t12*t26; /* v_tau*s*m*R */
    const double t28 = t27 - t24; /* d(energy)/d(omega3) = v_tau*s*m*R - omega_n*b/(R*s)*I3 */
    const double t29 = params[1]*params[4]; /* R*I1 */
    const double t30 = x[0]*t29; /* gamma3*R*I1 */
    const double t31 = x[3]*t30; /* omega_n*gamma3*R*I1 */
    const double t32 = t31/t7; /* omega_n*gamma3*R*I1/s */
    const double t33 = params[1]*params[5]; /* R*I3 */
    const double t34 = t9*t33; /* omega_n*b/(R*s)*R*I3 */
    const double t35 = t34 - t32; /* omega_n*b/(R*s)*R*I3 - omega_n*gamma3*R*I1/s */
    const double t36 = t7*t29; /* s*R*I1 */
    const double t37 = t3*params[5]; /* b*I3 */
    const double t38 = -t37; /* -b*I3 */
    out[0] = t19;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = t23;
    out[4] = t28;
    out[5] = t35;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t36;
    out[9] = t38;
}

static const jlt_named family2_left_null[] = {
    { "E", "" },
    { "G", "" },
};

static const jlt_equilibria equilibria[] = {
    { .name = "spin", .condition = "a3 = 0",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .charpoly = family0_charpoly,
      .matrix = family0_matrix,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 3, .obstructs = 1 },
    { .name = "spin_weightless", .condition = "g = 0",
      .is_free = family1_is_free,
      .impose = family1_impose,
      .point = family1_point,
      .trace = family1_trace,
      .left_null = family1_left_null,
      .left_null_gradients = family1_left_null_gradients,
      .left_null_count = 2, .obstructs = 1 },
    { .name = "precession", .condition = "g = omega_n^2*(I3*b - R*I1*gamma3)/(m*R*a3*s^2)",
      .is_free = family2_is_free,
      .impose = family2_impose,
      .point = family2_point,
      .trace = family2_trace,
      .left_null = family2_left_null,
      .left_null_gradients = family2_left_null_gradients,
      .left_null_count = 2, .obstructs = 0 },
};

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_general = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 6, .block_count = 9,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 16, 59, 0, 12, 1, 0, 12, 9 }, { 17, 69, 0, 12, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 25, { 47, 156, 0, 48, 1, 0, 16, 25 }, { 52, 271, 0, 49, 1, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 56, 166, 0, 60, 1, 0, 16, 44 }, { 62, 323, 0, 61, 1, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 10, 31, 0, 4, 1, 0, 12, 9 }, { 11, 38, 0, 4, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 10, 32, 0, 0, 1, 0, 12, 6 }, { 10, 32, 0, 0, 1, 0, 12, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 10, { 12, 32, 0, 2, 1, 0, 8, 9 }, { 12, 38, 0, 2, 1, 0, 8, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 3,
    .integrals = integrals,
    .equilibria = equilibria,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_baseline,
        &jlt_batch_spherical_top_general_avx2,
        &jlt_batch_spherical_top_general_avx512,
    },
};
