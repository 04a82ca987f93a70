/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 15   50    0   10    1    0     12    9   (82)
 *  jacobian            45  145    0   41    1    0     18   22   (318)
 *  rhs_jacobian        52  155    0   50    1    0     18   40   (369)
 *  divergence          10   30    0    4    1    0     12   10   (54)
 *  integral_values     10   31    0    1    1    0     13    6   (43)
 *  integral_gradients  15   40    0    6    1    0     13   14   (75)
 *  eliminated          3    6    0    1    1    0      6    4   (11)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_omega3_avx512;

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
    const double t10 = t6*p[5]; /* b*I3 */
    const double t11 = p[1]*p[4]; /* R*I1 */
    const double t12 = x[3]*t11; /* omega_n*R*I1 */
    const double t13 = t2*t12; /* s*omega_n*R*I1 */
    const double t14 = t13 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t15 = t14/t10; /* omega3 = (s*omega_n*R*I1 - G_level)/(b*I3) */
    const double t16 = t9*t15; /* omega_n*R*omega3 */
    const double t17 = t8 + t16; /* omega_n*omega_n*b/s + omega_n*R*omega3 */
    const double t18 = p[3]*p[3]; /* a3*a3 */
    const double t19 = p[0]*t18; /* m*a3*a3 */
    const double t20 = x[0]*t19; /* gamma3*m*a3*a3 */
    const double t21 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t22 = t20*t21; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t23 = t2*t22; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t24 = t2*t2; /* s*s */
    const double t25 = t19*t24; /* m*a3*a3*s*s */
    const double t26 = p[4] + t25; /* D = I1 + m*a3*a3*s*s */
    const double t27 = t23/t26; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t28 = p[0]*p[2]; /* m*g */
    const double t29 = p[3]*t28; /* a3*m*g */
    const double t30 = t2*t29; /* s*a3*m*g */
    const double t31 = t30/t26; /* s*a3*m*g/D */
    const double t32 = t27 - t31; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D */
    const double t33 = x[0]*p[4]; /* gamma3*I1 */
    const double t34 = t4*t33; /* omega_n*omega_n*gamma3*I1 */
    const double t35 = t2*t26; /* s*D */
    const double t36 = t34/t35; /* omega_n*omega_n*gamma3*I1/(s*D) */
    const double t37 = t32 - t36; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - omega_n*omega_n*gamma3*I1/(s*D) */
    const double t38 = x[3]*p[5]; /* omega_n*I3 */
    const double t39 = t15*t38; /* omega3*omega_n*I3 */
    const double t40 = t39/t26; /* omega3*omega_n*I3/D */
    const double t41 = t37 - t40; /* t37 - omega3*omega_n*I3/D */
    const double t42 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t43 = x[3]*t42; /* omega_n*omega_tau*gamma3 */
    const double t44 = t43/t2; /* omega_n*omega_tau*gamma3/s */
    const double t45 = p[5]*p[0]; /* I3*m */
    const double t46 = x[3]*t45; /* omega_n*I3*m */
    const double t47 = t6*t46; /* b*omega_n*I3*m */
    const double t48 = p[1]*p[1]; /* R*R */
    const double t49 = p[0]*t48; /* m*R*R */
    const double t50 = p[4]*t49; /* I1*m*R*R */
    const double t51 = t24*t50; /* s*s*I1*m*R*R */
    const double t52 = p[7] + t51; /* I1*I3 + s*s*I1*m*R*R */
    const double t53 = t6*t6; /* b*b */
    const double t54 = t45*t53; /* I3*m*b*b */
    const double t55 = t52 + t54; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*b*b */
    const double t56 = t2*t55; /* s*Theta */
    const double t57 = x[0]*p[3]; /* gamma3*a3 */
    const double t58 = p[1] + t57; /* e = R + gamma3*a3 */
    const double t59 = x[2]*t58; /* omega_tau*e */
    const double t60 = x[1] + t59; /* V = v_nu + omega_tau*e */
    const double t61 = t47*t60; /* b*omega_n*I3*m*V */
    const double t62 = t61/t56; /* b*omega_n*I3*m*V/(s*Theta) */
    const double t63 = t44 - t62; /* omega_n*omega_tau*gamma3/s - b*omega_n*I3*m*V/(s*Theta) */
    const double t64 = p[5]*p[5]; /* I3*I3 */
    const double t65 = x[2]*t64; /* omega_tau*I3*I3 */
    const double t66 = t15*t65; /* omega3*omega_tau*I3*I3 */
    const double t67 = t66/t55; /* omega3*omega_tau*I3*I3/Theta */
    const double t68 = t63 + t67; /* omega_n*omega_tau*gamma3/s - b*omega_n*I3*m*V/(s*Theta) + omega3*omega_tau*I3*I3/Theta */
    const double t69 = p[1]*p[0]; /* R*m */
    const double t70 = p[5]*t69; /* I3*R*m */
    const double t71 = x[2]*t70; /* omega_tau*I3*R*m */
    const double t72 = t15*t71; /* omega3*omega_tau*I3*R*m */
    const double t73 = t58*t72; /* e*omega3*omega_tau*I3*R*m */
    const double t74 = t73/t55; /* e*omega3*omega_tau*I3*R*m/Theta */
    const double t75 = t68 + t74; /* t68 + e*omega3*omega_tau*I3*R*m/Theta */
    out[0] = t3;
    out[1] = t17;
    out[2] = t41;
    out[3] = t75;
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
    const double t17 = p[1]*x[3]; /* R*omega_n */
    const double t18 = t13*t13; /* b*b */
    const double t19 = p[5]*t18; /* I3*b*b */
    const double t20 = p[1]*p[4]; /* R*I1 */
    const double t21 = x[3]*t20; /* omega_n*R*I1 */
    const double t22 = t3*t21; /* s*omega_n*R*I1 */
    const double t23 = p[6] - t22; /* G_level - s*omega_n*R*I1 */
    const double t24 = p[1]*t23; /* R*(G_level - s*omega_n*R*I1) */
    const double t25 = t24/t19; /* R*(G_level - s*omega_n*R*I1)/(I3*b*b) */
    const double t26 = x[0]*t20; /* gamma3*R*I1 */
    const double t27 = x[3]*t26; /* omega_n*gamma3*R*I1 */
    const double t28 = t3*p[5]; /* s*I3 */
    const double t29 = t13*t28; /* b*s*I3 */
    const double t30 = t27/t29; /* omega_n*gamma3*R*I1/(b*s*I3) */
    const double t31 = t25 - t30; /* d(omega3)/d(gamma3) = R*(G_level - s*omega_n*R*I1)/(I3*b*b) - omega_n*gamma3*R*I1/(b*s*I3) */
    const double t32 = t17*t31; /* R*omega_n*d(omega3)/d(gamma3) */
    const double t33 = t16 + t32; /* R*omega_n*omega_n/s + gamma3*omega_n*omega_n*b/(s*s*s) + R*omega_n*d(omega3)/d(gamma3) */
    const double t34 = t13*p[5]; /* b*I3 */
    const double t35 = t22 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t36 = t35/t34; /* omega3 = (s*omega_n*R*I1 - G_level)/(b*I3) */
    const double t37 = p[1]*t36; /* R*omega3 */
    const double t38 = x[3]*t13; /* omega_n*b */
    const double t39 = t38/t3; /* omega_n*b/s */
    const double t40 = t39*2.0; /* omega_n*b/s*2 */
    const double t41 = t37 + t40; /* R*omega3 + omega_n*b/s*2 */
    const double t42 = p[1]*p[1]; /* R*R */
    const double t43 = p[4]*t42; /* I1*R*R */
    const double t44 = x[3]*t43; /* omega_n*I1*R*R */
    const double t45 = t3*t44; /* s*omega_n*I1*R*R */
    const double t46 = t45/t34; /* s*omega_n*I1*R*R/(b*I3) */
    const double t47 = t41 + t46; /* R*omega3 + omega_n*b/s*2 + s*omega_n*I1*R*R/(b*I3) */
    const double t48 = p[3]*p[3]; /* a3*a3 */
    const double t49 = p[0]*t48; /* m*a3*a3 */
    const double t50 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t51 = t49*t50; /* m*a3*a3*omega_tau*omega_tau */
    const double t52 = t3*t51; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t53 = t10*t49; /* s*s*m*a3*a3 */
    const double t54 = p[4] + t53; /* D = I1 + s*s*m*a3*a3 */
    const double t55 = t52/t54; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t56 = t1*t49; /* gamma3*gamma3*m*a3*a3 */
    const double t57 = t50*t56; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t58 = t3*t54; /* s*D */
    const double t59 = t57/t58; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t60 = t55 - t59; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t61 = p[0]*p[0]; /* m*m */
    const double t62 = t48*t48; /* a3*a3*a3*a3 */
    const double t63 = t61*t62; /* m*m*a3*a3*a3*a3 */
    const double t64 = t1*t63; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t65 = t50*t64; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t66 = t3*t65; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t67 = t54*t54; /* D*D */
    const double t68 = t66/t67; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t69 = 2.0*t68; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t70 = t60 + t69; /* t60 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t71 = p[0]*p[2]; /* m*g */
    const double t72 = p[3]*t71; /* a3*m*g */
    const double t73 = x[0]*t72; /* gamma3*a3*m*g */
    const double t74 = t73/t58; /* gamma3*a3*m*g/(s*D) */
    const double t75 = t70 + t74; /* t70 + gamma3*a3*m*g/(s*D) */
    const double t76 = t61*p[2]; /* m*m*g */
    const double t77 = p[3]*t48; /* a3*a3*a3 */
    const double t78 = t76*t77; /* m*m*g*a3*a3*a3 */
    const double t79 = x[0]*t78; /* gamma3*m*m*g*a3*a3*a3 */
    const double t80 = t3*t79; /* s*gamma3*m*m*g*a3*a3*a3 */
    const double t81 = t80/t67; /* s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t82 = 2.0*t81; /* 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t83 = t75 - t82; /* t70 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t84 = t6*p[4]; /* omega_n*omega_n*I1 */
    const double t85 = t84/t58; /* omega_n*omega_n*I1/(s*D) */
    const double t86 = t83 - t85; /* t70 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) - omega_n*omega_n*I1/(s*D) */
    const double t87 = t1*p[4]; /* gamma3*gamma3*I1 */
    const double t88 = t6*t87; /* omega_n*omega_n*gamma3*gamma3*I1 */
    const double t89 = t11*t54; /* s*s*s*D */
    const double t90 = t88/t89; /* omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) */
    const double t91 = t86 - t90; /* t86 - omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) */
    const double t92 = p[4]*t49; /* I1*m*a3*a3 */
    const double t93 = t1*t92; /* gamma3*gamma3*I1*m*a3*a3 */
    const double t94 = t6*t93; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3 */
    const double t95 = t3*t67; /* s*D*D */
    const double t96 = t94/t95; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t97 = 2.0*t96; /* 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t98 = t91 - t97; /* t86 - omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) - 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t99 = p[5]*t49; /* I3*m*a3*a3 */
    const double t100 = x[0]*t99; /* gamma3*I3*m*a3*a3 */
    const double t101 = x[3]*t100; /* omega_n*gamma3*I3*m*a3*a3 */
    const double t102 = t36*t101; /* omega3*omega_n*gamma3*I3*m*a3*a3 */
    const double t103 = t102/t67; /* omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t104 = 2.0*t103; /* 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t105 = t98 - t104; /* t98 - 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t106 = x[3]*p[5]; /* omega_n*I3 */
    const double t107 = t31*t106; /* d(omega3)/d(gamma3)*omega_n*I3 */
    const double t108 = t107/t54; /* d(omega3)/d(gamma3)*omega_n*I3/D */
    const double t109 = t105 - t108; /* t98 - 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) - d(omega3)/d(gamma3)*omega_n*I3/D */
    const double t110 = 2.0*p[0]; /* 2*m */
    const double t111 = t48*t110; /* a3*a3*2*m */
    const double t112 = x[0]*t111; /* gamma3*a3*a3*2*m */
    const double t113 = x[2]*t112; /* omega_tau*gamma3*a3*a3*2*m */
    const double t114 = t3*t113; /* s*omega_tau*gamma3*a3*a3*2*m */
    const double t115 = t114/t54; /* s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t116 = x[0]*p[4]; /* gamma3*I1 */
    const double t117 = x[3]*t116; /* omega_n*gamma3*I1 */
    const double t118 = t117/t58; /* omega_n*gamma3*I1/(s*D) */
    const double t119 = 2.0*t118; /* 2*omega_n*gamma3*I1/(s*D) */
    const double t120 = -t119; /* -2*omega_n*gamma3*I1/(s*D) */
    const double t121 = p[5]*t36; /* I3*omega3 */
    const double t122 = t121/t54; /* I3*omega3/D */
    const double t123 = t120 - t122; /* -2*omega_n*gamma3*I1/(s*D) - I3*omega3/D */
    const double t124 = t13*t54; /* b*D */
    const double t125 = t22/t124; /* s*omega_n*R*I1/(b*D) */
    const double t126 = t123 - t125; /* -2*omega_n*gamma3*I1/(s*D) - I3*omega3/D - s*omega_n*R*I1/(b*D) */
    const double t127 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t128 = t127/t3; /* omega_tau*omega_n/s */
    const double t129 = x[2]*t1; /* omega_tau*gamma3*gamma3 */
    const double t130 = x[3]*t129; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t131 = t130/t11; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t132 = t128 + t131; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t133 = p[1]*p[0]; /* R*m */
    const double t134 = p[5]*t133; /* I3*R*m */
    const double t135 = x[3]*t134; /* omega_n*I3*R*m */
    const double t136 = t42*p[0]; /* R*R*m */
    const double t137 = p[4]*t136; /* I1*R*R*m */
    const double t138 = t10*t137; /* s*s*I1*R*R*m */
    const double t139 = p[7] + t138; /* I1*I3 + s*s*I1*R*R*m */
    const double t140 = p[5]*p[0]; /* I3*m */
    const double t141 = t18*t140; /* b*b*I3*m */
    const double t142 = t139 + t141; /* Theta = I1*I3 + s*s*I1*R*R*m + b*b*I3*m */
    const double t143 = t3*t142; /* s*Theta */
    const double t144 = x[0]*p[3]; /* gamma3*a3 */
    const double t145 = p[1] + t144; /* e = R + gamma3*a3 */
    const double t146 = x[2]*t145; /* omega_tau*e */
    const double t147 = x[1] + t146; /* V = v_nu + omega_tau*e */
    const double t148 = t135*t147; /* omega_n*I3*R*m*V */
    const double t149 = t148/t143; /* omega_n*I3*R*m*V/(s*Theta) */
    const double t150 = t132 - t149; /* t132 - omega_n*I3*R*m*V/(s*Theta) */
    const double t151 = p[3]*p[0]; /* a3*m */
    const double t152 = p[5]*t151; /* I3*a3*m */
    const double t153 = x[2]*t152; /* omega_tau*I3*a3*m */
    const double t154 = x[3]*t153; /* omega_n*omega_tau*I3*a3*m */
    const double t155 = t13*t154; /* b*omega_n*omega_tau*I3*a3*m */
    const double t156 = t155/t143; /* b*omega_n*omega_tau*I3*a3*m/(s*Theta) */
    const double t157 = t150 - t156; /* t132 - omega_n*I3*R*m*V/(s*Theta) - b*omega_n*omega_tau*I3*a3*m/(s*Theta) */
    const double t158 = x[0]*t140; /* gamma3*I3*m */
    const double t159 = x[3]*t158; /* omega_n*gamma3*I3*m */
    const double t160 = t13*t159; /* b*omega_n*gamma3*I3*m */
    const double t161 = t11*t142; /* s*s*s*Theta */
    const double t162 = t147*t160; /* V*b*omega_n*gamma3*I3*m */
    const double t163 = t162/t161; /* V*b*omega_n*gamma3*I3*m/(s*s*s*Theta) */
    const double t164 = t157 - t163; /* t157 - V*b*omega_n*gamma3*I3*m/(s*s*s*Theta) */
    const double t165 = p[3]*t133; /* a3*R*m */
    const double t166 = p[5]*t165; /* I3*a3*R*m */
    const double t167 = x[2]*t166; /* omega_tau*I3*a3*R*m */
    const double t168 = t36*t167; /* omega3*omega_tau*I3*a3*R*m */
    const double t169 = t168/t142; /* omega3*omega_tau*I3*a3*R*m/Theta */
    const double t170 = t164 + t169; /* t157 - V*b*omega_n*gamma3*I3*m/(s*s*s*Theta) + omega3*omega_tau*I3*a3*R*m/Theta */
    const double t171 = x[3]*t140; /* omega_n*I3*m */
    const double t172 = t13*t171; /* b*omega_n*I3*m */
    const double t173 = t142*t142; /* Theta*Theta */
    const double t174 = t3*t173; /* s*Theta*Theta */
    const double t175 = t147*t172; /* V*b*omega_n*I3*m */
    const double t176 = x[0]*t137; /* gamma3*I1*R*R*m */
    const double t177 = 2.0*t176; /* 2*gamma3*I1*R*R*m */
    const double t178 = t13*t134; /* b*I3*R*m */
    const double t179 = 2.0*t178; /* 2*b*I3*R*m */
    const double t180 = t179 - t177; /* d(Theta)/d(gamma3) = 2*b*I3*R*m - 2*gamma3*I1*R*R*m */
    const double t181 = t175*t180; /* V*b*omega_n*I3*m*d(Theta)/d(gamma3) */
    const double t182 = t181/t174; /* V*b*omega_n*I3*m*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t183 = t170 + t182; /* t170 + V*b*omega_n*I3*m*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t184 = p[5]*p[5]; /* I3*I3 */
    const double t185 = x[2]*t184; /* omega_tau*I3*I3 */
    const double t186 = t31*t185; /* d(omega3)/d(gamma3)*omega_tau*I3*I3 */
    const double t187 = t186/t142; /* d(omega3)/d(gamma3)*omega_tau*I3*I3/Theta */
    const double t188 = t183 + t187; /* t170 + V*b*omega_n*I3*m*d(Theta)/d(gamma3)/(s*Theta*Theta) + d(omega3)/d(gamma3)*omega_tau*I3*I3/Theta */
    const double t189 = t36*t185; /* omega3*omega_tau*I3*I3 */
    const double t190 = t180*t189; /* d(Theta)/d(gamma3)*omega3*omega_tau*I3*I3 */
    const double t191 = t190/t173; /* d(Theta)/d(gamma3)*omega3*omega_tau*I3*I3/(Theta*Theta) */
    const double t192 = t188 - t191; /* t188 - d(Theta)/d(gamma3)*omega3*omega_tau*I3*I3/(Theta*Theta) */
    const double t193 = x[2]*t134; /* omega_tau*I3*R*m */
    const double t194 = t145*t193; /* e*omega_tau*I3*R*m */
    const double t195 = t31*t194; /* d(omega3)/d(gamma3)*e*omega_tau*I3*R*m */
    const double t196 = t195/t142; /* d(omega3)/d(gamma3)*e*omega_tau*I3*R*m/Theta */
    const double t197 = t192 + t196; /* t192 + d(omega3)/d(gamma3)*e*omega_tau*I3*R*m/Theta */
    const double t198 = t36*t193; /* omega3*omega_tau*I3*R*m */
    const double t199 = t145*t198; /* e*omega3*omega_tau*I3*R*m */
    const double t200 = t180*t199; /* d(Theta)/d(gamma3)*e*omega3*omega_tau*I3*R*m */
    const double t201 = t200/t173; /* d(Theta)/d(gamma3)*e*omega3*omega_tau*I3*R*m/(Theta*Theta) */
    const double t202 = t197 - t201; /* t192 + d(omega3)/d(gamma3)*e*omega_tau*I3*R*m/Theta - d(Theta)/d(gamma3)*e*omega3*omega_tau*I3*R*m/(Theta*Theta) */
    const double t203 = t172/t143; /* b*omega_n*I3*m/(s*Theta) */
    const double t204 = -t203; /* -b*omega_n*I3*m/(s*Theta) */
    const double t205 = x[0]*x[3]; /* gamma3*omega_n */
    const double t206 = t205/t3; /* gamma3*omega_n/s */
    const double t207 = t145*t172; /* e*b*omega_n*I3*m */
    const double t208 = t207/t143; /* e*b*omega_n*I3*m/(s*Theta) */
    const double t209 = t206 - t208; /* gamma3*omega_n/s - e*b*omega_n*I3*m/(s*Theta) */
    const double t210 = t36*t184; /* omega3*I3*I3 */
    const double t211 = t210/t142; /* omega3*I3*I3/Theta */
    const double t212 = t209 + t211; /* gamma3*omega_n/s - e*b*omega_n*I3*m/(s*Theta) + omega3*I3*I3/Theta */
    const double t213 = t36*t134; /* omega3*I3*R*m */
    const double t214 = t145*t213; /* e*omega3*I3*R*m */
    const double t215 = t214/t142; /* e*omega3*I3*R*m/Theta */
    const double t216 = t212 + t215; /* t212 + e*omega3*I3*R*m/Theta */
    const double t217 = t13*t140; /* b*I3*m */
    const double t218 = t147*t217; /* V*b*I3*m */
    const double t219 = t218/t143; /* V*b*I3*m/(s*Theta) */
    const double t220 = t4 - t219; /* gamma3*omega_tau/s - V*b*I3*m/(s*Theta) */
    const double t221 = p[5]*t20; /* I3*R*I1 */
    const double t222 = x[2]*t221; /* omega_tau*I3*R*I1 */
    const double t223 = t3*t222; /* s*omega_tau*I3*R*I1 */
    const double t224 = t13*t142; /* b*Theta */
    const double t225 = t223/t224; /* s*omega_tau*I3*R*I1/(b*Theta) */
    const double t226 = t220 + t225; /* gamma3*omega_tau/s - V*b*I3*m/(s*Theta) + s*omega_tau*I3*R*I1/(b*Theta) */
    const double t227 = x[2]*t137; /* omega_tau*I1*R*R*m */
    const double t228 = t3*t227; /* s*omega_tau*I1*R*R*m */
    const double t229 = t145*t228; /* e*s*omega_tau*I1*R*R*m */
    const double t230 = t229/t224; /* e*s*omega_tau*I1*R*R*m/(b*Theta) */
    const double t231 = t226 + t230; /* t226 + e*s*omega_tau*I1*R*R*m/(b*Theta) */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t33;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t47;
    out[8] = t109;
    out[9] = 0.0;
    out[10] = t115;
    out[11] = t126;
    out[12] = t202;
    out[13] = t204;
    out[14] = t216;
    out[15] = t231;
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
    const double t10 = t6*p[5]; /* b*I3 */
    const double t11 = p[1]*p[4]; /* R*I1 */
    const double t12 = x[3]*t11; /* omega_n*R*I1 */
    const double t13 = t2*t12; /* s*omega_n*R*I1 */
    const double t14 = p[6] - t13; /* G_level - s*omega_n*R*I1 */
    const double t15 = t13 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t16 = t15/t10; /* omega3 = (s*omega_n*R*I1 - G_level)/(b*I3) */
    const double t17 = t9*t16; /* omega_n*R*omega3 */
    const double t18 = t8 + t17; /* omega_n*omega_n*b/s + omega_n*R*omega3 */
    const double t19 = p[3]*p[3]; /* a3*a3 */
    const double t20 = p[0]*t19; /* m*a3*a3 */
    const double t21 = x[0]*t20; /* gamma3*m*a3*a3 */
    const double t22 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t23 = t21*t22; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t24 = t2*t23; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t25 = t2*t2; /* s*s */
    const double t26 = t20*t25; /* m*a3*a3*s*s */
    const double t27 = p[4] + t26; /* D = I1 + m*a3*a3*s*s */
    const double t28 = t24/t27; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t29 = p[0]*p[2]; /* m*g */
    const double t30 = p[3]*t29; /* a3*m*g */
    const double t31 = t2*t30; /* s*a3*m*g */
    const double t32 = t31/t27; /* s*a3*m*g/D */
    const double t33 = t28 - t32; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D */
    const double t34 = x[0]*p[4]; /* gamma3*I1 */
    const double t35 = t4*t34; /* omega_n*omega_n*gamma3*I1 */
    const double t36 = t2*t27; /* s*D */
    const double t37 = t35/t36; /* omega_n*omega_n*gamma3*I1/(s*D) */
    const double t38 = t33 - t37; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - omega_n*omega_n*gamma3*I1/(s*D) */
    const double t39 = x[3]*p[5]; /* omega_n*I3 */
    const double t40 = t16*t39; /* omega3*omega_n*I3 */
    const double t41 = t40/t27; /* omega3*omega_n*I3/D */
    const double t42 = t38 - t41; /* t38 - omega3*omega_n*I3/D */
    const double t43 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t44 = x[3]*t43; /* omega_n*omega_tau*gamma3 */
    const double t45 = t44/t2; /* omega_n*omega_tau*gamma3/s */
    const double t46 = p[5]*p[0]; /* I3*m */
    const double t47 = x[3]*t46; /* omega_n*I3*m */
    const double t48 = t6*t47; /* b*omega_n*I3*m */
    const double t49 = p[1]*p[1]; /* R*R */
    const double t50 = p[0]*t49; /* m*R*R */
    const double t51 = p[4]*t50; /* I1*m*R*R */
    const double t52 = t25*t51; /* s*s*I1*m*R*R */
    const double t53 = p[7] + t52; /* I1*I3 + s*s*I1*m*R*R */
    const double t54 = t6*t6; /* b*b */
    const double t55 = t46*t54; /* I3*m*b*b */
    const double t56 = t53 + t55; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*b*b */
    const double t57 = t2*t56; /* s*Theta */
    const double t58 = x[0]*p[3]; /* gamma3*a3 */
    const double t59 = p[1] + t58; /* e = R + gamma3*a3 */
    const double t60 = x[2]*t59; /* omega_tau*e */
    const double t61 = x[1] + t60; /* V = v_nu + omega_tau*e */
    const double t62 = t48*t61; /* b*omega_n*I3*m*V */
    const double t63 = t62/t57; /* b*omega_n*I3*m*V/(s*Theta) */
    const double t64 = t45 - t63; /* omega_n*omega_tau*gamma3/s - b*omega_n*I3*m*V/(s*Theta) */
    const double t65 = p[5]*p[5]; /* I3*I3 */
    const double t66 = x[2]*t65; /* omega_tau*I3*I3 */
    const double t67 = t16*t66; /* omega3*omega_tau*I3*I3 */
    const double t68 = t67/t56; /* omega3*omega_tau*I3*I3/Theta */
    const double t69 = t64 + t68; /* omega_n*omega_tau*gamma3/s - b*omega_n*I3*m*V/(s*Theta) + omega3*omega_tau*I3*I3/Theta */
    const double t70 = p[1]*p[0]; /* R*m */
    const double t71 = p[5]*t70; /* I3*R*m */
    const double t72 = x[2]*t71; /* omega_tau*I3*R*m */
    const double t73 = t16*t72; /* omega3*omega_tau*I3*R*m */
    const double t74 = t59*t73; /* e*omega3*omega_tau*I3*R*m */
    const double t75 = t74/t56; /* e*omega3*omega_tau*I3*R*m/Theta */
    const double t76 = t69 + t75; /* t69 + e*omega3*omega_tau*I3*R*m/Theta */
    const double t77 = t43/t2; /* omega_tau*gamma3/s */
    const double t78 = -t77; /* -omega_tau*gamma3/s */
    const double t79 = t4*p[1]; /* omega_n*omega_n*R */
    const double t80 = t79/t2; /* omega_n*omega_n*R/s */
    const double t81 = x[0]*t4; /* gamma3*omega_n*omega_n */
    const double t82 = t2*t25; /* s*s*s */
    const double t83 = t6*t81; /* b*gamma3*omega_n*omega_n */
    const double t84 = t83/t82; /* b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t85 = t80 + t84; /* omega_n*omega_n*R/s + b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t86 = p[5]*t54; /* I3*b*b */
    const double t87 = p[1]*t14; /* R*(G_level - s*omega_n*R*I1) */
    const double t88 = t87/t86; /* R*(G_level - s*omega_n*R*I1)/(I3*b*b) */
    const double t89 = x[0]*t11; /* gamma3*R*I1 */
    const double t90 = x[3]*t89; /* omega_n*gamma3*R*I1 */
    const double t91 = t2*p[5]; /* s*I3 */
    const double t92 = t6*t91; /* b*s*I3 */
    const double t93 = t90/t92; /* omega_n*gamma3*R*I1/(b*s*I3) */
    const double t94 = t88 - t93; /* d(omega3)/d(gamma3) = R*(G_level - s*omega_n*R*I1)/(I3*b*b) - omega_n*gamma3*R*I1/(b*s*I3) */
    const double t95 = t9*t94; /* omega_n*R*d(omega3)/d(gamma3) */
    const double t96 = t85 + t95; /* omega_n*omega_n*R/s + b*gamma3*omega_n*omega_n/(s*s*s) + omega_n*R*d(omega3)/d(gamma3) */
    const double t97 = p[1]*t16; /* R*omega3 */
    const double t98 = x[3]*t6; /* omega_n*b */
    const double t99 = t98/t2; /* omega_n*b/s */
    const double t100 = t99*2.0; /* omega_n*b/s*2 */
    const double t101 = t97 + t100; /* R*omega3 + omega_n*b/s*2 */
    const double t102 = p[4]*t49; /* I1*R*R */
    const double t103 = x[3]*t102; /* omega_n*I1*R*R */
    const double t104 = t2*t103; /* s*omega_n*I1*R*R */
    const double t105 = t104/t10; /* s*omega_n*I1*R*R/(b*I3) */
    const double t106 = t101 + t105; /* R*omega3 + omega_n*b/s*2 + s*omega_n*I1*R*R/(b*I3) */
    const double t107 = t20*t22; /* m*a3*a3*omega_tau*omega_tau */
    const double t108 = t2*t107; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t109 = t108/t27; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t110 = t0*t20; /* gamma3*gamma3*m*a3*a3 */
    const double t111 = t22*t110; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t112 = t111/t36; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t113 = t109 - t112; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t114 = p[0]*p[0]; /* m*m */
    const double t115 = t19*t19; /* a3*a3*a3*a3 */
    const double t116 = t114*t115; /* m*m*a3*a3*a3*a3 */
    const double t117 = t0*t116; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t118 = t22*t117; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t119 = t2*t118; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t120 = t27*t27; /* D*D */
    const double t121 = t119/t120; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t122 = 2.0*t121; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t123 = t113 + t122; /* t113 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t124 = x[0]*t30; /* gamma3*a3*m*g */
    const double t125 = t124/t36; /* gamma3*a3*m*g/(s*D) */
    const double t126 = t123 + t125; /* t123 + gamma3*a3*m*g/(s*D) */
    const double t127 = p[2]*t114; /* g*m*m */
    const double t128 = p[3]*t19; /* a3*a3*a3 */
    const double t129 = t127*t128; /* g*m*m*a3*a3*a3 */
    const double t130 = x[0]*t129; /* gamma3*g*m*m*a3*a3*a3 */
    const double t131 = t2*t130; /* s*gamma3*g*m*m*a3*a3*a3 */
    const double t132 = t131/t120; /* s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t133 = 2.0*t132; /* 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t134 = t126 - t133; /* t123 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t135 = t4*p[4]; /* omega_n*omega_n*I1 */
    const double t136 = t135/t36; /* omega_n*omega_n*I1/(s*D) */
    const double t137 = t134 - t136; /* t123 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) - omega_n*omega_n*I1/(s*D) */
    const double t138 = t0*p[4]; /* gamma3*gamma3*I1 */
    const double t139 = t4*t138; /* omega_n*omega_n*gamma3*gamma3*I1 */
    const double t140 = t27*t82; /* D*s*s*s */
    const double t141 = t139/t140; /* omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) */
    const double t142 = t137 - t141; /* t137 - omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) */
    const double t143 = p[4]*t20; /* I1*m*a3*a3 */
    const double t144 = t0*t143; /* gamma3*gamma3*I1*m*a3*a3 */
    const double t145 = t4*t144; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3 */
    const double t146 = t2*t120; /* s*D*D */
    const double t147 = t145/t146; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t148 = 2.0*t147; /* 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t149 = t142 - t148; /* t137 - omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) - 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t150 = p[5]*t20; /* I3*m*a3*a3 */
    const double t151 = x[0]*t150; /* gamma3*I3*m*a3*a3 */
    const double t152 = x[3]*t151; /* omega_n*gamma3*I3*m*a3*a3 */
    const double t153 = t16*t152; /* omega3*omega_n*gamma3*I3*m*a3*a3 */
    const double t154 = t153/t120; /* omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t155 = 2.0*t154; /* 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t156 = t149 - t155; /* t149 - 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t157 = t39*t94; /* omega_n*I3*d(omega3)/d(gamma3) */
    const double t158 = t157/t27; /* omega_n*I3*d(omega3)/d(gamma3)/D */
    const double t159 = t156 - t158; /* t149 - 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) - omega_n*I3*d(omega3)/d(gamma3)/D */
    const double t160 = p[0]*2.0; /* m*2 */
    const double t161 = t19*t160; /* a3*a3*m*2 */
    const double t162 = x[0]*t161; /* gamma3*a3*a3*m*2 */
    const double t163 = x[2]*t162; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t164 = t2*t163; /* s*omega_tau*gamma3*a3*a3*m*2 */
    const double t165 = t164/t27; /* s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t166 = x[3]*t34; /* omega_n*gamma3*I1 */
    const double t167 = t166/t36; /* omega_n*gamma3*I1/(s*D) */
    const double t168 = 2.0*t167; /* 2*omega_n*gamma3*I1/(s*D) */
    const double t169 = -t168; /* -2*omega_n*gamma3*I1/(s*D) */
    const double t170 = p[5]*t16; /* I3*omega3 */
    const double t171 = t170/t27; /* I3*omega3/D */
    const double t172 = t169 - t171; /* -2*omega_n*gamma3*I1/(s*D) - I3*omega3/D */
    const double t173 = t6*t27; /* b*D */
    const double t174 = t13/t173; /* s*omega_n*R*I1/(b*D) */
    const double t175 = t172 - t174; /* -2*omega_n*gamma3*I1/(s*D) - I3*omega3/D - s*omega_n*R*I1/(b*D) */
    const double t176 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t177 = t176/t2; /* omega_tau*omega_n/s */
    const double t178 = x[2]*t0; /* omega_tau*gamma3*gamma3 */
    const double t179 = x[3]*t178; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t180 = t179/t82; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t181 = t177 + t180; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t182 = x[3]*t71; /* omega_n*I3*R*m */
    const double t183 = t61*t182; /* V*omega_n*I3*R*m */
    const double t184 = t183/t57; /* V*omega_n*I3*R*m/(s*Theta) */
    const double t185 = t181 - t184; /* t181 - V*omega_n*I3*R*m/(s*Theta) */
    const double t186 = p[3]*p[0]; /* a3*m */
    const double t187 = p[5]*t186; /* I3*a3*m */
    const double t188 = x[2]*t187; /* omega_tau*I3*a3*m */
    const double t189 = x[3]*t188; /* omega_n*omega_tau*I3*a3*m */
    const double t190 = t6*t189; /* b*omega_n*omega_tau*I3*a3*m */
    const double t191 = t190/t57; /* b*omega_n*omega_tau*I3*a3*m/(s*Theta) */
    const double t192 = t185 - t191; /* t181 - V*omega_n*I3*R*m/(s*Theta) - b*omega_n*omega_tau*I3*a3*m/(s*Theta) */
    const double t193 = x[0]*t46; /* gamma3*I3*m */
    const double t194 = x[3]*t193; /* omega_n*gamma3*I3*m */
    const double t195 = t6*t194; /* b*omega_n*gamma3*I3*m */
    const double t196 = t56*t82; /* Theta*s*s*s */
    const double t197 = t61*t195; /* V*b*omega_n*gamma3*I3*m */
    const double t198 = t197/t196; /* V*b*omega_n*gamma3*I3*m/(Theta*s*s*s) */
    const double t199 = t192 - t198; /* t192 - V*b*omega_n*gamma3*I3*m/(Theta*s*s*s) */
    const double t200 = p[3]*t70; /* a3*R*m */
    const double t201 = p[5]*t200; /* I3*a3*R*m */
    const double t202 = x[2]*t201; /* omega_tau*I3*a3*R*m */
    const double t203 = t16*t202; /* omega3*omega_tau*I3*a3*R*m */
    const double t204 = t203/t56; /* omega3*omega_tau*I3*a3*R*m/Theta */
    const double t205 = t199 + t204; /* t192 - V*b*omega_n*gamma3*I3*m/(Theta*s*s*s) + omega3*omega_tau*I3*a3*R*m/Theta */
    const double t206 = t56*t56; /* Theta*Theta */
    const double t207 = t2*t206; /* s*Theta*Theta */
    const double t208 = x[0]*t51; /* gamma3*I1*m*R*R */
    const double t209 = 2.0*t208; /* 2*gamma3*I1*m*R*R */
    const double t210 = t6*t71; /* b*I3*R*m */
    const double t211 = 2.0*t210; /* 2*b*I3*R*m */
    const double t212 = t211 - t209; /* d(Theta)/d(gamma3) = 2*b*I3*R*m - 2*gamma3*I1*m*R*R */
    const double t213 = t62*t212; /* b*omega_n*I3*m*V*d(Theta)/d(gamma3) */
    const double t214 = t213/t207; /* b*omega_n*I3*m*V*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t215 = t205 + t214; /* t205 + b*omega_n*I3*m*V*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t216 = t66*t94; /* omega_tau*I3*I3*d(omega3)/d(gamma3) */
    const double t217 = t216/t56; /* omega_tau*I3*I3*d(omega3)/d(gamma3)/Theta */
    const double t218 = t215 + t217; /* t205 + b*omega_n*I3*m*V*d(Theta)/d(gamma3)/(s*Theta*Theta) + omega_tau*I3*I3*d(omega3)/d(gamma3)/Theta */
    const double t219 = t67*t212; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3) */
    const double t220 = t219/t206; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t221 = t218 - t220; /* t218 - omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t222 = t59*t72; /* e*omega_tau*I3*R*m */
    const double t223 = t94*t222; /* d(omega3)/d(gamma3)*e*omega_tau*I3*R*m */
    const double t224 = t223/t56; /* d(omega3)/d(gamma3)*e*omega_tau*I3*R*m/Theta */
    const double t225 = t221 + t224; /* t221 + d(omega3)/d(gamma3)*e*omega_tau*I3*R*m/Theta */
    const double t226 = t74*t212; /* e*omega3*omega_tau*I3*R*m*d(Theta)/d(gamma3) */
    const double t227 = t226/t206; /* e*omega3*omega_tau*I3*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t228 = t225 - t227; /* t221 + d(omega3)/d(gamma3)*e*omega_tau*I3*R*m/Theta - e*omega3*omega_tau*I3*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t229 = t48/t57; /* b*omega_n*I3*m/(s*Theta) */
    const double t230 = -t229; /* -b*omega_n*I3*m/(s*Theta) */
    const double t231 = x[0]*x[3]; /* gamma3*omega_n */
    const double t232 = t231/t2; /* gamma3*omega_n/s */
    const double t233 = t48*t59; /* b*omega_n*I3*m*e */
    const double t234 = t233/t57; /* b*omega_n*I3*m*e/(s*Theta) */
    const double t235 = t232 - t234; /* gamma3*omega_n/s - b*omega_n*I3*m*e/(s*Theta) */
    const double t236 = t16*t65; /* omega3*I3*I3 */
    const double t237 = t236/t56; /* omega3*I3*I3/Theta */
    const double t238 = t235 + t237; /* gamma3*omega_n/s - b*omega_n*I3*m*e/(s*Theta) + omega3*I3*I3/Theta */
    const double t239 = t16*t71; /* omega3*I3*R*m */
    const double t240 = t59*t239; /* e*omega3*I3*R*m */
    const double t241 = t240/t56; /* e*omega3*I3*R*m/Theta */
    const double t242 = t238 + t241; /* t238 + e*omega3*I3*R*m/Theta */
    const double t243 = t6*t46; /* b*I3*m */
    const double t244 = t61*t243; /* V*b*I3*m */
    const double t245 = t244/t57; /* V*b*I3*m/(s*Theta) */
    const double t246 = t77 - t245; /* omega_tau*gamma3/s - V*b*I3*m/(s*Theta) */
    const double t247 = p[5]*t11; /* I3*R*I1 */
    const double t248 = x[2]*t247; /* omega_tau*I3*R*I1 */
    const double t249 = t2*t248; /* s*omega_tau*I3*R*I1 */
    const double t250 = t6*t56; /* b*Theta */
    const double t251 = t249/t250; /* s*omega_tau*I3*R*I1/(b*Theta) */
    const double t252 = t246 + t251; /* omega_tau*gamma3/s - V*b*I3*m/(s*Theta) + s*omega_tau*I3*R*I1/(b*Theta) */
    const double t253 = x[2]*t51; /* omega_tau*I1*m*R*R */
    const double t254 = t2*t253; /* s*omega_tau*I1*m*R*R */
    const double t255 = t59*t254; /* e*s*omega_tau*I1*m*R*R */
    const double t256 = t255/t250; /* e*s*omega_tau*I1*m*R*R/(b*Theta) */
    const double t257 = t252 + t256; /* t252 + e*s*omega_tau*I1*m*R*R/(b*Theta) */
    out[0] = t3;
    out[1] = t18;
    out[2] = t42;
    out[3] = t76;
    out[4] = t78;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = t96;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t106;
    out[12] = t159;
    out[13] = 0.0;
    out[14] = t165;
    out[15] = t175;
    out[16] = t228;
    out[17] = t230;
    out[18] = t242;
    out[19] = t257;
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
    const double t21 = p[7] + t20; /* I1*I3 + s*s*I1*m*R*R */
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
    const double t33 = p[4]*p[1]; /* I1*R */
    const double t34 = p[5]*t33; /* I3*I1*R */
    const double t35 = x[2]*t34; /* omega_tau*I3*I1*R */
    const double t36 = t6*t35; /* s*omega_tau*I3*I1*R */
    const double t37 = t15*t24; /* b*Theta */
    const double t38 = t36/t37; /* s*omega_tau*I3*I1*R/(b*Theta) */
    const double t39 = t32 + t38; /* m*a3*a3*gamma3*omega_tau*s/D*2 - m*I3*b*V/(s*Theta) + s*omega_tau*I3*I1*R/(b*Theta) */
    const double t40 = x[2]*t19; /* omega_tau*I1*m*R*R */
    const double t41 = t6*t40; /* s*omega_tau*I1*m*R*R */
    const double t42 = t27*t41; /* e*s*omega_tau*I1*m*R*R */
    const double t43 = t42/t37; /* e*s*omega_tau*I1*m*R*R/(b*Theta) */
    const double t44 = t39 + t43; /* t39 + e*s*omega_tau*I1*m*R*R/(b*Theta) */
    out[0] = t44;
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
    const double t23 = x[0]*p[1]; /* gamma3*R */
    const double t24 = p[3] + t23; /* b = a3 + gamma3*R */
    const double t25 = p[5]*t24; /* I3*b */
    const double t26 = p[4]*p[1]; /* I1*R */
    const double t27 = x[3]*t26; /* omega_n*I1*R */
    const double t28 = t12*t27; /* s*omega_n*I1*R */
    const double t29 = t28 - p[6]; /* s*omega_n*I1*R - G_level */
    const double t30 = t29/t25; /* omega3 = (s*omega_n*I1*R - G_level)/(I3*b) */
    const double t31 = t30*t30; /* omega3*omega3 */
    const double t32 = p[5]*t31; /* I3*omega3*omega3 */
    const double t33 = (1.0 / 2.0)*t32; /* 1/2*I3*omega3*omega3 */
    const double t34 = t22 + t33; /* t22 + 1/2*I3*omega3*omega3 */
    const double t35 = x[3]*t24; /* omega_n*b */
    const double t36 = p[1]*t30; /* R*omega3 */
    const double t37 = t12*t36; /* s*R*omega3 */
    const double t38 = t35 + t37; /* v_tau = omega_n*b + s*R*omega3 */
    const double t39 = t38*t38; /* v_tau*v_tau */
    const double t40 = p[0]*t39; /* m*v_tau*v_tau */
    const double t41 = (1.0 / 2.0)*t40; /* 1/2*m*v_tau*v_tau */
    const double t42 = t34 + t41; /* energy = t22 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    out[0] = t42;
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
    const double t9 = t7*p[5]; /* b*I3 */
    const double t10 = p[1]*p[4]; /* R*I1 */
    const double t11 = x[3]*t10; /* omega_n*R*I1 */
    const double t12 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t13 = 1.0 - t12; /* 1 - gamma3*gamma3 */
    const double t14 = sqrt(t13); /* s = sqrt(1 - gamma3*gamma3) */
    const double t15 = t11*t14; /* omega_n*R*I1*s */
    const double t16 = p[6] - t15; /* G_level - omega_n*R*I1*s */
    const double t17 = t15 - p[6]; /* omega_n*R*I1*s - G_level */
    const double t18 = t17/t9; /* omega3 = (omega_n*R*I1*s - G_level)/(b*I3) */
    const double t19 = p[1]*t18; /* R*omega3 */
    const double t20 = t14*t19; /* s*R*omega3 */
    const double t21 = t8 + t20; /* v_tau = omega_n*b + s*R*omega3 */
    const double t22 = p[0]*t21; /* m*v_tau */
    const double t23 = x[3]*p[1]; /* omega_n*R */
    const double t24 = t6*t18; /* gamma3*R*omega3 */
    const double t25 = t24/t14; /* gamma3*R*omega3/s */
    const double t26 = t23 - t25; /* omega_n*R - gamma3*R*omega3/s */
    const double t27 = p[1]*t14; /* R*s */
    const double t28 = t7*t7; /* b*b */
    const double t29 = p[5]*t28; /* I3*b*b */
    const double t30 = p[1]*t16; /* R*(G_level - omega_n*R*I1*s) */
    const double t31 = t30/t29; /* R*(G_level - omega_n*R*I1*s)/(I3*b*b) */
    const double t32 = x[0]*t10; /* gamma3*R*I1 */
    const double t33 = x[3]*t32; /* omega_n*gamma3*R*I1 */
    const double t34 = p[5]*t14; /* I3*s */
    const double t35 = t7*t34; /* b*I3*s */
    const double t36 = t33/t35; /* omega_n*gamma3*R*I1/(b*I3*s) */
    const double t37 = t31 - t36; /* d(omega3)/d(gamma3) = R*(G_level - omega_n*R*I1*s)/(I3*b*b) - omega_n*gamma3*R*I1/(b*I3*s) */
    const double t38 = t27*t37; /* R*s*d(omega3)/d(gamma3) */
    const double t39 = t26 + t38; /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*R*omega3/s + R*s*d(omega3)/d(gamma3) */
    const double t40 = t22*t39; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t41 = t5 + t40; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau + m*v_tau*d(v_tau)/d(gamma3) */
    const double t42 = p[5]*t18; /* I3*omega3 */
    const double t43 = t37*t42; /* d(omega3)/d(gamma3)*I3*omega3 */
    const double t44 = t41 + t43; /* d(energy)/d(gamma3) = t41 + d(omega3)/d(gamma3)*I3*omega3 */
    const double t45 = p[0]*x[1]; /* m*v_nu */
    const double t46 = t14*t14; /* s*s */
    const double t47 = t1*t46; /* m*a3*a3*s*s */
    const double t48 = p[4] + t47; /* D = I1 + m*a3*a3*s*s */
    const double t49 = x[2]*t48; /* omega_tau*D */
    const double t50 = x[3]*p[4]; /* omega_n*I1 */
    const double t51 = p[1]*p[1]; /* R*R */
    const double t52 = p[4]*t51; /* I1*R*R */
    const double t53 = t46*t52; /* s*s*I1*R*R */
    const double t54 = t53/t9; /* s*s*I1*R*R/(b*I3) */
    const double t55 = t7 + t54; /* d(v_tau)/d(omega_n) = b + s*s*I1*R*R/(b*I3) */
    const double t56 = t22*t55; /* m*v_tau*d(v_tau)/d(omega_n) */
    const double t57 = t50 + t56; /* omega_n*I1 + m*v_tau*d(v_tau)/d(omega_n) */
    const double t58 = t10*t18; /* R*I1*omega3 */
    const double t59 = t14*t58; /* s*R*I1*omega3 */
    const double t60 = t59/t7; /* s*R*I1*omega3/b */
    const double t61 = t57 + t60; /* d(energy)/d(omega_n) = omega_n*I1 + m*v_tau*d(v_tau)/d(omega_n) + s*R*I1*omega3/b */
    out[0] = t44;
    out[1] = t45;
    out[2] = t49;
    out[3] = t61;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*x[0]; /* R*gamma3 */
    const double t1 = p[3] + t0; /* b = a3 + R*gamma3 */
    const double t2 = p[5]*t1; /* I3*b */
    const double t3 = p[1]*p[4]; /* R*I1 */
    const double t4 = t3*x[3]; /* R*I1*omega_n */
    const double t5 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t6 = 1.0 - t5; /* 1 - gamma3*gamma3 */
    const double t7 = sqrt(t6); /* s = sqrt(1 - gamma3*gamma3) */
    const double t8 = t4*t7; /* R*I1*omega_n*s */
    const double t9 = t8 - p[6]; /* R*I1*omega_n*s - G_level */
    const double t10 = t9/t2; /* omega3 = (R*I1*omega_n*s - G_level)/(I3*b) */
    out[0] = t10;
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
    const double v_I3 = params[5];
    const double v_G_level = params[6];
    const double v_I1 = params[4];
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
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
    out[3] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 9,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 15, 50, 0, 10, 1, 0, 12, 9 }, { 15, 56, 0, 10, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 45, 145, 0, 41, 1, 0, 18, 22 }, { 45, 230, 0, 42, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 52, 155, 0, 50, 1, 0, 18, 40 }, { 52, 265, 0, 51, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 10, 30, 0, 4, 1, 0, 12, 10 }, { 10, 39, 0, 4, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 10, 31, 0, 1, 1, 0, 13, 6 }, { 10, 31, 0, 1, 1, 0, 13, 6 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 15, 40, 0, 6, 1, 0, 13, 14 }, { 15, 53, 0, 6, 1, 0, 13, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 6, 0, 1, 1, 0, 6, 4 }, { 3, 6, 0, 1, 1, 0, 6, 4 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_general_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_general_on_level_G_omega3_avx512,
    },
};
