/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 14   50    0    9    1    0     10    9   (83)
 *  jacobian            41  146    0   39    1    0     18   21   (327)
 *  rhs_jacobian        47  155    0   47    1    0     18   45   (379)
 *  divergence          11   32    0    5    1    0     12    9   (57)
 *  integral_values     10   31    0    1    1    0     12    6   (43)
 *  integral_gradients  14   35    0    6    1    0     12   15   (72)
 *  eliminated          3    6    0    1    1    0      5    4   (11)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_avx512;

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
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[4]; /* R*I1 */
    const double t5 = t2*t4; /* s*R*I1 */
    const double t6 = p[5]*x[3]; /* I3*omega3 */
    const double t7 = x[0]*p[1]; /* gamma3*R */
    const double t8 = p[3] + t7; /* b = a3 + gamma3*R */
    const double t9 = t6*t8; /* I3*omega3*b */
    const double t10 = p[6] + t9; /* G_level + I3*omega3*b */
    const double t11 = t10/t5; /* omega_n = (G_level + I3*omega3*b)/(s*R*I1) */
    const double t12 = t11*t11; /* omega_n*omega_n */
    const double t13 = t8*t12; /* b*omega_n*omega_n */
    const double t14 = t13/t2; /* b*omega_n*omega_n/s */
    const double t15 = p[1]*t11; /* R*omega_n */
    const double t16 = x[3]*t15; /* omega3*R*omega_n */
    const double t17 = t14 + t16; /* b*omega_n*omega_n/s + omega3*R*omega_n */
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
    const double t34 = t12*t33; /* omega_n*omega_n*gamma3*I1 */
    const double t35 = t2*t26; /* s*D */
    const double t36 = t34/t35; /* omega_n*omega_n*gamma3*I1/(s*D) */
    const double t37 = t32 - t36; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - omega_n*omega_n*gamma3*I1/(s*D) */
    const double t38 = p[5]*t11; /* I3*omega_n */
    const double t39 = x[3]*t38; /* omega3*I3*omega_n */
    const double t40 = t39/t26; /* omega3*I3*omega_n/D */
    const double t41 = t37 - t40; /* t37 - omega3*I3*omega_n/D */
    const double t42 = p[1]*p[0]; /* R*m */
    const double t43 = p[4]*t42; /* I1*R*m */
    const double t44 = t11*t43; /* omega_n*I1*R*m */
    const double t45 = p[1]*p[1]; /* R*R */
    const double t46 = p[0]*t45; /* m*R*R */
    const double t47 = p[4]*t46; /* I1*m*R*R */
    const double t48 = t24*t47; /* s*s*I1*m*R*R */
    const double t49 = p[7] + t48; /* I1*I3 + s*s*I1*m*R*R */
    const double t50 = p[5]*p[0]; /* I3*m */
    const double t51 = t8*t8; /* b*b */
    const double t52 = t50*t51; /* I3*m*b*b */
    const double t53 = t49 + t52; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*b*b */
    const double t54 = x[0]*p[3]; /* gamma3*a3 */
    const double t55 = p[1] + t54; /* e = R + gamma3*a3 */
    const double t56 = x[2]*t55; /* omega_tau*e */
    const double t57 = x[1] + t56; /* V = v_nu + omega_tau*e */
    const double t58 = t44*t57; /* omega_n*I1*R*m*V */
    const double t59 = t58/t53; /* omega_n*I1*R*m*V/Theta */
    const double t60 = x[0]*t46; /* gamma3*m*R*R */
    const double t61 = x[2]*t60; /* omega_tau*gamma3*m*R*R */
    const double t62 = x[3]*t61; /* omega3*omega_tau*gamma3*m*R*R */
    const double t63 = t2*t62; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t64 = t63*p[8]; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t65 = t64/t53; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t66 = t65 - t59; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - omega_n*I1*R*m*V/Theta */
    const double t67 = p[3]*t42; /* a3*R*m */
    const double t68 = p[5]*t67; /* I3*a3*R*m */
    const double t69 = x[2]*t68; /* omega_tau*I3*a3*R*m */
    const double t70 = x[3]*t69; /* omega3*omega_tau*I3*a3*R*m */
    const double t71 = t2*t70; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t72 = t71/t53; /* s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t73 = t66 - t72; /* t66 - s*omega3*omega_tau*I3*a3*R*m/Theta */
    out[0] = t3;
    out[1] = t17;
    out[2] = t41;
    out[3] = t73;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = -t4; /* -gamma3*omega_tau/s */
    const double t6 = p[1]*p[4]; /* R*I1 */
    const double t7 = t3*t6; /* s*R*I1 */
    const double t8 = p[5]*x[3]; /* I3*omega3 */
    const double t9 = x[0]*p[1]; /* gamma3*R */
    const double t10 = p[3] + t9; /* b = a3 + gamma3*R */
    const double t11 = t8*t10; /* I3*omega3*b */
    const double t12 = p[6] + t11; /* G_level + I3*omega3*b */
    const double t13 = t12/t7; /* omega_n = (G_level + I3*omega3*b)/(s*R*I1) */
    const double t14 = t13*t13; /* omega_n*omega_n */
    const double t15 = p[1]*t14; /* R*omega_n*omega_n */
    const double t16 = t15/t3; /* R*omega_n*omega_n/s */
    const double t17 = x[0]*t14; /* gamma3*omega_n*omega_n */
    const double t18 = t3*t3; /* s*s */
    const double t19 = t3*t18; /* s*s*s */
    const double t20 = t10*t17; /* b*gamma3*omega_n*omega_n */
    const double t21 = t20/t19; /* b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t22 = t16 + t21; /* R*omega_n*omega_n/s + b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t23 = t10*t13; /* b*omega_n */
    const double t24 = t3*p[4]; /* s*I1 */
    const double t25 = t8/t24; /* I3*omega3/(s*I1) */
    const double t26 = t6*t19; /* R*I1*s*s*s */
    const double t27 = x[0]*t12; /* gamma3*(G_level + I3*omega3*b) */
    const double t28 = t27/t26; /* gamma3*(G_level + I3*omega3*b)/(R*I1*s*s*s) */
    const double t29 = t25 + t28; /* d(omega_n)/d(gamma3) = I3*omega3/(s*I1) + gamma3*(G_level + I3*omega3*b)/(R*I1*s*s*s) */
    const double t30 = t23*t29; /* b*omega_n*d(omega_n)/d(gamma3) */
    const double t31 = t30/t3; /* b*omega_n*d(omega_n)/d(gamma3)/s */
    const double t32 = t31*2.0; /* b*omega_n*d(omega_n)/d(gamma3)/s*2 */
    const double t33 = t22 + t32; /* R*omega_n*omega_n/s + b*gamma3*omega_n*omega_n/(s*s*s) + b*omega_n*d(omega_n)/d(gamma3)/s*2 */
    const double t34 = p[1]*x[3]; /* R*omega3 */
    const double t35 = t29*t34; /* d(omega_n)/d(gamma3)*R*omega3 */
    const double t36 = t33 + t35; /* t33 + d(omega_n)/d(gamma3)*R*omega3 */
    const double t37 = p[1]*t13; /* R*omega_n */
    const double t38 = p[5]*t13; /* I3*omega_n */
    const double t39 = t6*t18; /* R*I1*s*s */
    const double t40 = t10*t10; /* b*b */
    const double t41 = t38*t40; /* I3*omega_n*b*b */
    const double t42 = t41/t39; /* I3*omega_n*b*b/(R*I1*s*s) */
    const double t43 = 2.0*t42; /* 2*I3*omega_n*b*b/(R*I1*s*s) */
    const double t44 = t37 + t43; /* R*omega_n + 2*I3*omega_n*b*b/(R*I1*s*s) */
    const double t45 = t11/t24; /* I3*omega3*b/(s*I1) */
    const double t46 = t44 + t45; /* R*omega_n + 2*I3*omega_n*b*b/(R*I1*s*s) + I3*omega3*b/(s*I1) */
    const double t47 = p[3]*p[3]; /* a3*a3 */
    const double t48 = p[0]*t47; /* m*a3*a3 */
    const double t49 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t50 = t48*t49; /* m*a3*a3*omega_tau*omega_tau */
    const double t51 = t3*t50; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t52 = t18*t48; /* s*s*m*a3*a3 */
    const double t53 = p[4] + t52; /* D = I1 + s*s*m*a3*a3 */
    const double t54 = t51/t53; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t55 = t1*t48; /* gamma3*gamma3*m*a3*a3 */
    const double t56 = t49*t55; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t57 = t3*t53; /* s*D */
    const double t58 = t56/t57; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t59 = t54 - t58; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t60 = p[0]*p[0]; /* m*m */
    const double t61 = t47*t47; /* a3*a3*a3*a3 */
    const double t62 = t60*t61; /* m*m*a3*a3*a3*a3 */
    const double t63 = t1*t62; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t64 = t49*t63; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t65 = t3*t64; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t66 = t53*t53; /* D*D */
    const double t67 = t65/t66; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t68 = 2.0*t67; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t69 = t59 + t68; /* t59 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t70 = p[0]*p[2]; /* m*g */
    const double t71 = p[3]*t70; /* a3*m*g */
    const double t72 = x[0]*t71; /* gamma3*a3*m*g */
    const double t73 = t72/t57; /* gamma3*a3*m*g/(s*D) */
    const double t74 = t69 + t73; /* t69 + gamma3*a3*m*g/(s*D) */
    const double t75 = t60*p[2]; /* m*m*g */
    const double t76 = p[3]*t47; /* a3*a3*a3 */
    const double t77 = t75*t76; /* m*m*g*a3*a3*a3 */
    const double t78 = x[0]*t77; /* gamma3*m*m*g*a3*a3*a3 */
    const double t79 = t3*t78; /* s*gamma3*m*m*g*a3*a3*a3 */
    const double t80 = t79/t66; /* s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t81 = 2.0*t80; /* 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t82 = t74 - t81; /* t69 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t83 = p[4]*t14; /* I1*omega_n*omega_n */
    const double t84 = t83/t57; /* I1*omega_n*omega_n/(s*D) */
    const double t85 = t82 - t84; /* t69 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) - I1*omega_n*omega_n/(s*D) */
    const double t86 = t1*p[4]; /* gamma3*gamma3*I1 */
    const double t87 = t14*t86; /* omega_n*omega_n*gamma3*gamma3*I1 */
    const double t88 = t19*t53; /* s*s*s*D */
    const double t89 = t87/t88; /* omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) */
    const double t90 = t85 - t89; /* t85 - omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) */
    const double t91 = p[4]*t48; /* I1*m*a3*a3 */
    const double t92 = t1*t91; /* gamma3*gamma3*I1*m*a3*a3 */
    const double t93 = t14*t92; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3 */
    const double t94 = t3*t66; /* s*D*D */
    const double t95 = t93/t94; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t96 = 2.0*t95; /* 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t97 = t90 - t96; /* t85 - omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) - 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t98 = p[5]*t48; /* I3*m*a3*a3 */
    const double t99 = x[0]*t98; /* gamma3*I3*m*a3*a3 */
    const double t100 = t13*t99; /* omega_n*gamma3*I3*m*a3*a3 */
    const double t101 = x[3]*t100; /* omega3*omega_n*gamma3*I3*m*a3*a3 */
    const double t102 = t101/t66; /* omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t103 = 2.0*t102; /* 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t104 = t97 - t103; /* t97 - 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t105 = x[0]*p[4]; /* gamma3*I1 */
    const double t106 = t13*t105; /* omega_n*gamma3*I1 */
    const double t107 = t29*t106; /* d(omega_n)/d(gamma3)*omega_n*gamma3*I1 */
    const double t108 = t107/t57; /* d(omega_n)/d(gamma3)*omega_n*gamma3*I1/(s*D) */
    const double t109 = 2.0*t108; /* 2*d(omega_n)/d(gamma3)*omega_n*gamma3*I1/(s*D) */
    const double t110 = t104 - t109; /* t97 - 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) - 2*d(omega_n)/d(gamma3)*omega_n*gamma3*I1/(s*D) */
    const double t111 = t8*t29; /* I3*omega3*d(omega_n)/d(gamma3) */
    const double t112 = t111/t53; /* I3*omega3*d(omega_n)/d(gamma3)/D */
    const double t113 = t110 - t112; /* t110 - I3*omega3*d(omega_n)/d(gamma3)/D */
    const double t114 = 2.0*p[0]; /* 2*m */
    const double t115 = t47*t114; /* a3*a3*2*m */
    const double t116 = x[0]*t115; /* gamma3*a3*a3*2*m */
    const double t117 = x[2]*t116; /* omega_tau*gamma3*a3*a3*2*m */
    const double t118 = t3*t117; /* s*omega_tau*gamma3*a3*a3*2*m */
    const double t119 = t118/t53; /* s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t120 = t38/t53; /* I3*omega_n/D */
    const double t121 = -t120; /* -I3*omega_n/D */
    const double t122 = x[0]*p[5]; /* gamma3*I3 */
    const double t123 = t13*t122; /* omega_n*gamma3*I3 */
    const double t124 = p[1]*t18; /* R*s*s */
    const double t125 = t10*t123; /* b*omega_n*gamma3*I3 */
    const double t126 = t53*t124; /* D*R*s*s */
    const double t127 = t125/t126; /* b*omega_n*gamma3*I3/(D*R*s*s) */
    const double t128 = 2.0*t127; /* 2*b*omega_n*gamma3*I3/(D*R*s*s) */
    const double t129 = t121 - t128; /* -I3*omega_n/D - 2*b*omega_n*gamma3*I3/(D*R*s*s) */
    const double t130 = p[5]*p[5]; /* I3*I3 */
    const double t131 = x[3]*t130; /* omega3*I3*I3 */
    const double t132 = t10*t131; /* b*omega3*I3*I3 */
    const double t133 = t7*t53; /* s*R*I1*D */
    const double t134 = t132/t133; /* b*omega3*I3*I3/(s*R*I1*D) */
    const double t135 = t129 - t134; /* -I3*omega_n/D - 2*b*omega_n*gamma3*I3/(D*R*s*s) - b*omega3*I3*I3/(s*R*I1*D) */
    const double t136 = p[1]*p[0]; /* R*m */
    const double t137 = p[3]*t136; /* a3*R*m */
    const double t138 = p[4]*t137; /* I1*a3*R*m */
    const double t139 = x[2]*t138; /* omega_tau*I1*a3*R*m */
    const double t140 = t13*t139; /* omega_n*omega_tau*I1*a3*R*m */
    const double t141 = p[1]*p[1]; /* R*R */
    const double t142 = p[0]*t141; /* m*R*R */
    const double t143 = p[4]*t142; /* I1*m*R*R */
    const double t144 = t18*t143; /* s*s*I1*m*R*R */
    const double t145 = p[7] + t144; /* I1*I3 + s*s*I1*m*R*R */
    const double t146 = p[5]*p[0]; /* I3*m */
    const double t147 = t40*t146; /* b*b*I3*m */
    const double t148 = t145 + t147; /* Theta = I1*I3 + s*s*I1*m*R*R + b*b*I3*m */
    const double t149 = t140/t148; /* omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t150 = x[2]*t142; /* omega_tau*m*R*R */
    const double t151 = x[3]*t150; /* omega3*omega_tau*m*R*R */
    const double t152 = t3*t151; /* s*omega3*omega_tau*m*R*R */
    const double t153 = t152*p[8]; /* s*omega3*omega_tau*m*R*R*(I1 - I3) */
    const double t154 = t153/t148; /* s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t155 = t154 - t149; /* s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta - omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t156 = t1*t142; /* gamma3*gamma3*m*R*R */
    const double t157 = x[2]*t156; /* omega_tau*gamma3*gamma3*m*R*R */
    const double t158 = x[3]*t157; /* omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t159 = t3*t148; /* s*Theta */
    const double t160 = p[8]*t158; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t161 = t160/t159; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t162 = t155 - t161; /* t155 - (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t163 = p[5]*t137; /* I3*a3*R*m */
    const double t164 = x[0]*t163; /* gamma3*I3*a3*R*m */
    const double t165 = x[2]*t164; /* omega_tau*gamma3*I3*a3*R*m */
    const double t166 = x[3]*t165; /* omega3*omega_tau*gamma3*I3*a3*R*m */
    const double t167 = t166/t159; /* omega3*omega_tau*gamma3*I3*a3*R*m/(s*Theta) */
    const double t168 = t162 + t167; /* t162 + omega3*omega_tau*gamma3*I3*a3*R*m/(s*Theta) */
    const double t169 = p[4]*t136; /* I1*R*m */
    const double t170 = x[0]*p[3]; /* gamma3*a3 */
    const double t171 = p[1] + t170; /* e = R + gamma3*a3 */
    const double t172 = x[2]*t171; /* omega_tau*e */
    const double t173 = x[1] + t172; /* V = v_nu + omega_tau*e */
    const double t174 = t169*t173; /* I1*R*m*V */
    const double t175 = t29*t174; /* d(omega_n)/d(gamma3)*I1*R*m*V */
    const double t176 = t175/t148; /* d(omega_n)/d(gamma3)*I1*R*m*V/Theta */
    const double t177 = t168 - t176; /* t162 + omega3*omega_tau*gamma3*I3*a3*R*m/(s*Theta) - d(omega_n)/d(gamma3)*I1*R*m*V/Theta */
    const double t178 = t13*t169; /* omega_n*I1*R*m */
    const double t179 = t148*t148; /* Theta*Theta */
    const double t180 = t173*t178; /* V*omega_n*I1*R*m */
    const double t181 = x[0]*t143; /* gamma3*I1*m*R*R */
    const double t182 = 2.0*t181; /* 2*gamma3*I1*m*R*R */
    const double t183 = p[5]*t136; /* I3*R*m */
    const double t184 = t10*t183; /* b*I3*R*m */
    const double t185 = 2.0*t184; /* 2*b*I3*R*m */
    const double t186 = t185 - t182; /* d(Theta)/d(gamma3) = 2*b*I3*R*m - 2*gamma3*I1*m*R*R */
    const double t187 = t180*t186; /* V*omega_n*I1*R*m*d(Theta)/d(gamma3) */
    const double t188 = t187/t179; /* V*omega_n*I1*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t189 = t177 + t188; /* t177 + V*omega_n*I1*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t190 = x[0]*t142; /* gamma3*m*R*R */
    const double t191 = x[2]*t190; /* omega_tau*gamma3*m*R*R */
    const double t192 = x[3]*t191; /* omega3*omega_tau*gamma3*m*R*R */
    const double t193 = t3*t192; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t194 = p[8]*t193; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t195 = t186*t194; /* d(Theta)/d(gamma3)*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t196 = t195/t179; /* d(Theta)/d(gamma3)*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/(Theta*Theta) */
    const double t197 = t189 - t196; /* t177 + V*omega_n*I1*R*m*d(Theta)/d(gamma3)/(Theta*Theta) - t196 */
    const double t198 = x[2]*t163; /* omega_tau*I3*a3*R*m */
    const double t199 = x[3]*t198; /* omega3*omega_tau*I3*a3*R*m */
    const double t200 = t3*t199; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t201 = t186*t200; /* d(Theta)/d(gamma3)*s*omega3*omega_tau*I3*a3*R*m */
    const double t202 = t201/t179; /* d(Theta)/d(gamma3)*s*omega3*omega_tau*I3*a3*R*m/(Theta*Theta) */
    const double t203 = t197 + t202; /* t197 + t202 */
    const double t204 = t178/t148; /* omega_n*I1*R*m/Theta */
    const double t205 = -t204; /* -omega_n*I1*R*m/Theta */
    const double t206 = x[3]*t190; /* omega3*gamma3*m*R*R */
    const double t207 = t3*t206; /* s*omega3*gamma3*m*R*R */
    const double t208 = p[8]*t207; /* (I1 - I3)*s*omega3*gamma3*m*R*R */
    const double t209 = t208/t148; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta */
    const double t210 = t171*t178; /* e*omega_n*I1*R*m */
    const double t211 = t210/t148; /* e*omega_n*I1*R*m/Theta */
    const double t212 = t209 - t211; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta - e*omega_n*I1*R*m/Theta */
    const double t213 = x[3]*t163; /* omega3*I3*a3*R*m */
    const double t214 = t3*t213; /* s*omega3*I3*a3*R*m */
    const double t215 = t214/t148; /* s*omega3*I3*a3*R*m/Theta */
    const double t216 = t212 - t215; /* t212 - s*omega3*I3*a3*R*m/Theta */
    const double t217 = t10*t146; /* b*I3*m */
    const double t218 = t173*t217; /* V*b*I3*m */
    const double t219 = t218/t159; /* V*b*I3*m/(s*Theta) */
    const double t220 = t3*t191; /* s*omega_tau*gamma3*m*R*R */
    const double t221 = p[8]*t220; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R */
    const double t222 = t221/t148; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta */
    const double t223 = t222 - t219; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta - V*b*I3*m/(s*Theta) */
    const double t224 = t3*t198; /* s*omega_tau*I3*a3*R*m */
    const double t225 = t224/t148; /* s*omega_tau*I3*a3*R*m/Theta */
    const double t226 = t223 - t225; /* t223 - s*omega_tau*I3*a3*R*m/Theta */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t36;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t46;
    out[8] = t113;
    out[9] = 0.0;
    out[10] = t119;
    out[11] = t135;
    out[12] = t203;
    out[13] = t205;
    out[14] = t216;
    out[15] = t226;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[4]; /* R*I1 */
    const double t5 = t2*t4; /* s*R*I1 */
    const double t6 = p[5]*x[3]; /* I3*omega3 */
    const double t7 = x[0]*p[1]; /* gamma3*R */
    const double t8 = p[3] + t7; /* b = a3 + gamma3*R */
    const double t9 = t6*t8; /* I3*omega3*b */
    const double t10 = p[6] + t9; /* G_level + I3*omega3*b */
    const double t11 = t10/t5; /* omega_n = (G_level + I3*omega3*b)/(s*R*I1) */
    const double t12 = t11*t11; /* omega_n*omega_n */
    const double t13 = t8*t12; /* b*omega_n*omega_n */
    const double t14 = t13/t2; /* b*omega_n*omega_n/s */
    const double t15 = p[1]*t11; /* R*omega_n */
    const double t16 = x[3]*t15; /* omega3*R*omega_n */
    const double t17 = t14 + t16; /* b*omega_n*omega_n/s + omega3*R*omega_n */
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
    const double t34 = t12*t33; /* omega_n*omega_n*gamma3*I1 */
    const double t35 = t2*t26; /* s*D */
    const double t36 = t34/t35; /* omega_n*omega_n*gamma3*I1/(s*D) */
    const double t37 = t32 - t36; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - omega_n*omega_n*gamma3*I1/(s*D) */
    const double t38 = p[5]*t11; /* I3*omega_n */
    const double t39 = x[3]*t38; /* omega3*I3*omega_n */
    const double t40 = t39/t26; /* omega3*I3*omega_n/D */
    const double t41 = t37 - t40; /* t37 - omega3*I3*omega_n/D */
    const double t42 = p[1]*p[0]; /* R*m */
    const double t43 = p[4]*t42; /* I1*R*m */
    const double t44 = t11*t43; /* omega_n*I1*R*m */
    const double t45 = p[1]*p[1]; /* R*R */
    const double t46 = p[0]*t45; /* m*R*R */
    const double t47 = p[4]*t46; /* I1*m*R*R */
    const double t48 = t24*t47; /* s*s*I1*m*R*R */
    const double t49 = p[7] + t48; /* I1*I3 + s*s*I1*m*R*R */
    const double t50 = p[5]*p[0]; /* I3*m */
    const double t51 = t8*t8; /* b*b */
    const double t52 = t50*t51; /* I3*m*b*b */
    const double t53 = t49 + t52; /* Theta = I1*I3 + s*s*I1*m*R*R + I3*m*b*b */
    const double t54 = x[0]*p[3]; /* gamma3*a3 */
    const double t55 = p[1] + t54; /* e = R + gamma3*a3 */
    const double t56 = x[2]*t55; /* omega_tau*e */
    const double t57 = x[1] + t56; /* V = v_nu + omega_tau*e */
    const double t58 = t44*t57; /* omega_n*I1*R*m*V */
    const double t59 = t58/t53; /* omega_n*I1*R*m*V/Theta */
    const double t60 = x[0]*t46; /* gamma3*m*R*R */
    const double t61 = x[2]*t60; /* omega_tau*gamma3*m*R*R */
    const double t62 = x[3]*t61; /* omega3*omega_tau*gamma3*m*R*R */
    const double t63 = t2*t62; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t64 = t63*p[8]; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t65 = t64/t53; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t66 = t65 - t59; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - omega_n*I1*R*m*V/Theta */
    const double t67 = p[3]*t42; /* a3*R*m */
    const double t68 = p[5]*t67; /* I3*a3*R*m */
    const double t69 = x[2]*t68; /* omega_tau*I3*a3*R*m */
    const double t70 = x[3]*t69; /* omega3*omega_tau*I3*a3*R*m */
    const double t71 = t2*t70; /* s*omega3*omega_tau*I3*a3*R*m */
    const double t72 = t71/t53; /* s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t73 = t66 - t72; /* t66 - s*omega3*omega_tau*I3*a3*R*m/Theta */
    const double t74 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t75 = t74/t2; /* omega_tau*gamma3/s */
    const double t76 = -t75; /* -omega_tau*gamma3/s */
    const double t77 = p[1]*t12; /* R*omega_n*omega_n */
    const double t78 = t77/t2; /* R*omega_n*omega_n/s */
    const double t79 = x[0]*t12; /* gamma3*omega_n*omega_n */
    const double t80 = t2*t24; /* s*s*s */
    const double t81 = t8*t79; /* b*gamma3*omega_n*omega_n */
    const double t82 = t81/t80; /* b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t83 = t78 + t82; /* R*omega_n*omega_n/s + b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t84 = t8*t11; /* b*omega_n */
    const double t85 = t2*p[4]; /* s*I1 */
    const double t86 = t6/t85; /* I3*omega3/(s*I1) */
    const double t87 = t4*t80; /* R*I1*s*s*s */
    const double t88 = x[0]*t10; /* gamma3*(G_level + I3*omega3*b) */
    const double t89 = t88/t87; /* gamma3*(G_level + I3*omega3*b)/(R*I1*s*s*s) */
    const double t90 = t86 + t89; /* d(omega_n)/d(gamma3) = I3*omega3/(s*I1) + gamma3*(G_level + I3*omega3*b)/(R*I1*s*s*s) */
    const double t91 = t84*t90; /* b*omega_n*d(omega_n)/d(gamma3) */
    const double t92 = t91/t2; /* b*omega_n*d(omega_n)/d(gamma3)/s */
    const double t93 = t92*2.0; /* b*omega_n*d(omega_n)/d(gamma3)/s*2 */
    const double t94 = t83 + t93; /* R*omega_n*omega_n/s + b*gamma3*omega_n*omega_n/(s*s*s) + b*omega_n*d(omega_n)/d(gamma3)/s*2 */
    const double t95 = p[1]*x[3]; /* R*omega3 */
    const double t96 = t90*t95; /* d(omega_n)/d(gamma3)*R*omega3 */
    const double t97 = t94 + t96; /* t94 + d(omega_n)/d(gamma3)*R*omega3 */
    const double t98 = t4*t24; /* R*I1*s*s */
    const double t99 = t38*t51; /* I3*omega_n*b*b */
    const double t100 = t99/t98; /* I3*omega_n*b*b/(R*I1*s*s) */
    const double t101 = 2.0*t100; /* 2*I3*omega_n*b*b/(R*I1*s*s) */
    const double t102 = t15 + t101; /* R*omega_n + 2*I3*omega_n*b*b/(R*I1*s*s) */
    const double t103 = t9/t85; /* I3*omega3*b/(s*I1) */
    const double t104 = t102 + t103; /* R*omega_n + 2*I3*omega_n*b*b/(R*I1*s*s) + I3*omega3*b/(s*I1) */
    const double t105 = t19*t21; /* m*a3*a3*omega_tau*omega_tau */
    const double t106 = t2*t105; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t107 = t106/t26; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t108 = t0*t19; /* gamma3*gamma3*m*a3*a3 */
    const double t109 = t21*t108; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t110 = t109/t35; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t111 = t107 - t110; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t112 = p[0]*p[0]; /* m*m */
    const double t113 = t18*t18; /* a3*a3*a3*a3 */
    const double t114 = t112*t113; /* m*m*a3*a3*a3*a3 */
    const double t115 = t0*t114; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t116 = t21*t115; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t117 = t2*t116; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t118 = t26*t26; /* D*D */
    const double t119 = t117/t118; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t120 = 2.0*t119; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t121 = t111 + t120; /* t111 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t122 = x[0]*t29; /* gamma3*a3*m*g */
    const double t123 = t122/t35; /* gamma3*a3*m*g/(s*D) */
    const double t124 = t121 + t123; /* t121 + gamma3*a3*m*g/(s*D) */
    const double t125 = p[2]*t112; /* g*m*m */
    const double t126 = p[3]*t18; /* a3*a3*a3 */
    const double t127 = t125*t126; /* g*m*m*a3*a3*a3 */
    const double t128 = x[0]*t127; /* gamma3*g*m*m*a3*a3*a3 */
    const double t129 = t2*t128; /* s*gamma3*g*m*m*a3*a3*a3 */
    const double t130 = t129/t118; /* s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t131 = 2.0*t130; /* 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t132 = t124 - t131; /* t121 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t133 = p[4]*t12; /* I1*omega_n*omega_n */
    const double t134 = t133/t35; /* I1*omega_n*omega_n/(s*D) */
    const double t135 = t132 - t134; /* t121 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) - I1*omega_n*omega_n/(s*D) */
    const double t136 = t0*p[4]; /* gamma3*gamma3*I1 */
    const double t137 = t12*t136; /* omega_n*omega_n*gamma3*gamma3*I1 */
    const double t138 = t26*t80; /* D*s*s*s */
    const double t139 = t137/t138; /* omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) */
    const double t140 = t135 - t139; /* t135 - omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) */
    const double t141 = p[4]*t19; /* I1*m*a3*a3 */
    const double t142 = t0*t141; /* gamma3*gamma3*I1*m*a3*a3 */
    const double t143 = t12*t142; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3 */
    const double t144 = t2*t118; /* s*D*D */
    const double t145 = t143/t144; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t146 = 2.0*t145; /* 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t147 = t140 - t146; /* t135 - omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) - 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t148 = p[5]*t19; /* I3*m*a3*a3 */
    const double t149 = x[0]*t148; /* gamma3*I3*m*a3*a3 */
    const double t150 = t11*t149; /* omega_n*gamma3*I3*m*a3*a3 */
    const double t151 = x[3]*t150; /* omega3*omega_n*gamma3*I3*m*a3*a3 */
    const double t152 = t151/t118; /* omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t153 = 2.0*t152; /* 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t154 = t147 - t153; /* t147 - 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) */
    const double t155 = t11*t33; /* omega_n*gamma3*I1 */
    const double t156 = t90*t155; /* d(omega_n)/d(gamma3)*omega_n*gamma3*I1 */
    const double t157 = t156/t35; /* d(omega_n)/d(gamma3)*omega_n*gamma3*I1/(s*D) */
    const double t158 = 2.0*t157; /* 2*d(omega_n)/d(gamma3)*omega_n*gamma3*I1/(s*D) */
    const double t159 = t154 - t158; /* t147 - 2*omega3*omega_n*gamma3*I3*m*a3*a3/(D*D) - 2*d(omega_n)/d(gamma3)*omega_n*gamma3*I1/(s*D) */
    const double t160 = t6*t90; /* I3*omega3*d(omega_n)/d(gamma3) */
    const double t161 = t160/t26; /* I3*omega3*d(omega_n)/d(gamma3)/D */
    const double t162 = t159 - t161; /* t159 - I3*omega3*d(omega_n)/d(gamma3)/D */
    const double t163 = p[0]*2.0; /* m*2 */
    const double t164 = t18*t163; /* a3*a3*m*2 */
    const double t165 = x[0]*t164; /* gamma3*a3*a3*m*2 */
    const double t166 = x[2]*t165; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t167 = t2*t166; /* s*omega_tau*gamma3*a3*a3*m*2 */
    const double t168 = t167/t26; /* s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t169 = t38/t26; /* I3*omega_n/D */
    const double t170 = -t169; /* -I3*omega_n/D */
    const double t171 = x[0]*p[5]; /* gamma3*I3 */
    const double t172 = t11*t171; /* omega_n*gamma3*I3 */
    const double t173 = p[1]*t24; /* R*s*s */
    const double t174 = t8*t172; /* b*omega_n*gamma3*I3 */
    const double t175 = t26*t173; /* D*R*s*s */
    const double t176 = t174/t175; /* b*omega_n*gamma3*I3/(D*R*s*s) */
    const double t177 = 2.0*t176; /* 2*b*omega_n*gamma3*I3/(D*R*s*s) */
    const double t178 = t170 - t177; /* -I3*omega_n/D - 2*b*omega_n*gamma3*I3/(D*R*s*s) */
    const double t179 = p[5]*p[5]; /* I3*I3 */
    const double t180 = x[3]*t179; /* omega3*I3*I3 */
    const double t181 = t8*t180; /* b*omega3*I3*I3 */
    const double t182 = t5*t26; /* s*R*I1*D */
    const double t183 = t181/t182; /* b*omega3*I3*I3/(s*R*I1*D) */
    const double t184 = t178 - t183; /* -I3*omega_n/D - 2*b*omega_n*gamma3*I3/(D*R*s*s) - b*omega3*I3*I3/(s*R*I1*D) */
    const double t185 = p[4]*t67; /* I1*a3*R*m */
    const double t186 = x[2]*t185; /* omega_tau*I1*a3*R*m */
    const double t187 = t11*t186; /* omega_n*omega_tau*I1*a3*R*m */
    const double t188 = t187/t53; /* omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t189 = x[2]*t46; /* omega_tau*m*R*R */
    const double t190 = x[3]*t189; /* omega3*omega_tau*m*R*R */
    const double t191 = t2*t190; /* s*omega3*omega_tau*m*R*R */
    const double t192 = p[8]*t191; /* (I1 - I3)*s*omega3*omega_tau*m*R*R */
    const double t193 = t192/t53; /* (I1 - I3)*s*omega3*omega_tau*m*R*R/Theta */
    const double t194 = t193 - t188; /* (I1 - I3)*s*omega3*omega_tau*m*R*R/Theta - omega_n*omega_tau*I1*a3*R*m/Theta */
    const double t195 = t0*t46; /* gamma3*gamma3*m*R*R */
    const double t196 = x[2]*t195; /* omega_tau*gamma3*gamma3*m*R*R */
    const double t197 = x[3]*t196; /* omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t198 = t2*t53; /* s*Theta */
    const double t199 = p[8]*t197; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t200 = t199/t198; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t201 = t194 - t200; /* t194 - (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t202 = x[0]*t68; /* gamma3*I3*a3*R*m */
    const double t203 = x[2]*t202; /* omega_tau*gamma3*I3*a3*R*m */
    const double t204 = x[3]*t203; /* omega3*omega_tau*gamma3*I3*a3*R*m */
    const double t205 = t204/t198; /* omega3*omega_tau*gamma3*I3*a3*R*m/(s*Theta) */
    const double t206 = t201 + t205; /* t201 + omega3*omega_tau*gamma3*I3*a3*R*m/(s*Theta) */
    const double t207 = t43*t57; /* I1*R*m*V */
    const double t208 = t90*t207; /* d(omega_n)/d(gamma3)*I1*R*m*V */
    const double t209 = t208/t53; /* d(omega_n)/d(gamma3)*I1*R*m*V/Theta */
    const double t210 = t206 - t209; /* t201 + omega3*omega_tau*gamma3*I3*a3*R*m/(s*Theta) - d(omega_n)/d(gamma3)*I1*R*m*V/Theta */
    const double t211 = t53*t53; /* Theta*Theta */
    const double t212 = x[0]*t47; /* gamma3*I1*m*R*R */
    const double t213 = 2.0*t212; /* 2*gamma3*I1*m*R*R */
    const double t214 = p[5]*t42; /* I3*R*m */
    const double t215 = t8*t214; /* b*I3*R*m */
    const double t216 = 2.0*t215; /* 2*b*I3*R*m */
    const double t217 = t216 - t213; /* d(Theta)/d(gamma3) = 2*b*I3*R*m - 2*gamma3*I1*m*R*R */
    const double t218 = t58*t217; /* omega_n*I1*R*m*V*d(Theta)/d(gamma3) */
    const double t219 = t218/t211; /* omega_n*I1*R*m*V*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t220 = t210 + t219; /* t210 + omega_n*I1*R*m*V*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t221 = t64*t217; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t222 = t221/t211; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t223 = t220 - t222; /* t210 + omega_n*I1*R*m*V*d(Theta)/d(gamma3)/(Theta*Theta) - t222 */
    const double t224 = t71*t217; /* s*omega3*omega_tau*I3*a3*R*m*d(Theta)/d(gamma3) */
    const double t225 = t224/t211; /* s*omega3*omega_tau*I3*a3*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t226 = t223 + t225; /* t223 + t225 */
    const double t227 = t44/t53; /* omega_n*I1*R*m/Theta */
    const double t228 = -t227; /* -omega_n*I1*R*m/Theta */
    const double t229 = x[3]*t60; /* omega3*gamma3*m*R*R */
    const double t230 = t2*t229; /* s*omega3*gamma3*m*R*R */
    const double t231 = p[8]*t230; /* (I1 - I3)*s*omega3*gamma3*m*R*R */
    const double t232 = t231/t53; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta */
    const double t233 = t44*t55; /* omega_n*I1*R*m*e */
    const double t234 = t233/t53; /* omega_n*I1*R*m*e/Theta */
    const double t235 = t232 - t234; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta - omega_n*I1*R*m*e/Theta */
    const double t236 = x[3]*t68; /* omega3*I3*a3*R*m */
    const double t237 = t2*t236; /* s*omega3*I3*a3*R*m */
    const double t238 = t237/t53; /* s*omega3*I3*a3*R*m/Theta */
    const double t239 = t235 - t238; /* t235 - s*omega3*I3*a3*R*m/Theta */
    const double t240 = t8*t50; /* b*I3*m */
    const double t241 = t57*t240; /* V*b*I3*m */
    const double t242 = t241/t198; /* V*b*I3*m/(s*Theta) */
    const double t243 = t2*t61; /* s*omega_tau*gamma3*m*R*R */
    const double t244 = p[8]*t243; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R */
    const double t245 = t244/t53; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta */
    const double t246 = t245 - t242; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta - V*b*I3*m/(s*Theta) */
    const double t247 = t2*t69; /* s*omega_tau*I3*a3*R*m */
    const double t248 = t247/t53; /* s*omega_tau*I3*a3*R*m/Theta */
    const double t249 = t246 - t248; /* t246 - s*omega_tau*I3*a3*R*m/Theta */
    out[0] = t3;
    out[1] = t17;
    out[2] = t41;
    out[3] = t73;
    out[4] = t76;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = t97;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t104;
    out[12] = t162;
    out[13] = 0.0;
    out[14] = t168;
    out[15] = t184;
    out[16] = t226;
    out[17] = t228;
    out[18] = t239;
    out[19] = t249;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = p[3]*p[3]; /* a3*a3 */
    const double t6 = p[0]*t5; /* m*a3*a3 */
    const double t7 = x[0]*t6; /* gamma3*m*a3*a3 */
    const double t8 = x[2]*t7; /* omega_tau*gamma3*m*a3*a3 */
    const double t9 = t3*t8; /* s*omega_tau*gamma3*m*a3*a3 */
    const double t10 = t3*t3; /* s*s */
    const double t11 = t6*t10; /* m*a3*a3*s*s */
    const double t12 = p[4] + t11; /* D = I1 + m*a3*a3*s*s */
    const double t13 = t9/t12; /* s*omega_tau*gamma3*m*a3*a3/D */
    const double t14 = t13*2.0; /* s*omega_tau*gamma3*m*a3*a3/D*2 */
    const double t15 = t14 - t4; /* s*omega_tau*gamma3*m*a3*a3/D*2 - gamma3*omega_tau/s */
    const double t16 = p[0]*p[5]; /* m*I3 */
    const double t17 = x[0]*p[1]; /* gamma3*R */
    const double t18 = p[3] + t17; /* b = a3 + gamma3*R */
    const double t19 = t16*t18; /* m*I3*b */
    const double t20 = p[1]*p[1]; /* R*R */
    const double t21 = p[0]*t20; /* m*R*R */
    const double t22 = p[4]*t21; /* I1*m*R*R */
    const double t23 = t10*t22; /* s*s*I1*m*R*R */
    const double t24 = p[7] + t23; /* I1*I3 + s*s*I1*m*R*R */
    const double t25 = t18*t18; /* b*b */
    const double t26 = t16*t25; /* m*I3*b*b */
    const double t27 = t24 + t26; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t28 = t3*t27; /* s*Theta */
    const double t29 = x[0]*p[3]; /* gamma3*a3 */
    const double t30 = p[1] + t29; /* e = R + gamma3*a3 */
    const double t31 = x[2]*t30; /* omega_tau*e */
    const double t32 = x[1] + t31; /* V = v_nu + omega_tau*e */
    const double t33 = t19*t32; /* m*I3*b*V */
    const double t34 = t33/t28; /* m*I3*b*V/(s*Theta) */
    const double t35 = t15 - t34; /* s*omega_tau*gamma3*m*a3*a3/D*2 - gamma3*omega_tau/s - m*I3*b*V/(s*Theta) */
    const double t36 = x[0]*t21; /* gamma3*m*R*R */
    const double t37 = x[2]*t36; /* omega_tau*gamma3*m*R*R */
    const double t38 = t3*t37; /* s*omega_tau*gamma3*m*R*R */
    const double t39 = t38*p[8]; /* s*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t40 = t39/t27; /* s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t41 = t35 + t40; /* t35 + s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t42 = p[0]*p[1]; /* m*R */
    const double t43 = p[3]*t42; /* a3*m*R */
    const double t44 = p[5]*t43; /* I3*a3*m*R */
    const double t45 = x[2]*t44; /* omega_tau*I3*a3*m*R */
    const double t46 = t3*t45; /* s*omega_tau*I3*a3*m*R */
    const double t47 = t46/t27; /* s*omega_tau*I3*a3*m*R/Theta */
    const double t48 = t41 - t47; /* t35 + s*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - s*omega_tau*I3*a3*m*R/Theta */
    out[0] = t48;
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
    const double t19 = p[4]*p[1]; /* I1*R */
    const double t20 = t12*t19; /* s*I1*R */
    const double t21 = p[5]*x[3]; /* I3*omega3 */
    const double t22 = x[0]*p[1]; /* gamma3*R */
    const double t23 = p[3] + t22; /* b = a3 + gamma3*R */
    const double t24 = t21*t23; /* I3*omega3*b */
    const double t25 = p[6] + t24; /* G_level + I3*omega3*b */
    const double t26 = t25/t20; /* omega_n = (G_level + I3*omega3*b)/(s*I1*R) */
    const double t27 = t26*t26; /* omega_n*omega_n */
    const double t28 = p[4]*t27; /* I1*omega_n*omega_n */
    const double t29 = (1.0 / 2.0)*t28; /* 1/2*I1*omega_n*omega_n */
    const double t30 = t18 + t29; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*I1*omega_n*omega_n */
    const double t31 = x[3]*x[3]; /* omega3*omega3 */
    const double t32 = p[5]*t31; /* I3*omega3*omega3 */
    const double t33 = (1.0 / 2.0)*t32; /* 1/2*I3*omega3*omega3 */
    const double t34 = t30 + t33; /* t30 + 1/2*I3*omega3*omega3 */
    const double t35 = t23*t26; /* b*omega_n */
    const double t36 = p[1]*x[3]; /* R*omega3 */
    const double t37 = t12*t36; /* s*R*omega3 */
    const double t38 = t35 + t37; /* v_tau = b*omega_n + s*R*omega3 */
    const double t39 = t38*t38; /* v_tau*v_tau */
    const double t40 = p[0]*t39; /* m*v_tau*v_tau */
    const double t41 = (1.0 / 2.0)*t40; /* 1/2*m*v_tau*v_tau */
    const double t42 = t34 + t41; /* energy = t30 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    out[0] = t42;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*p[3]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t4 = t2*t3; /* m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t5 = p[9] - t4; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t6 = p[4]*p[1]; /* I1*R */
    const double t7 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t8 = 1.0 - t7; /* 1 - gamma3*gamma3 */
    const double t9 = sqrt(t8); /* s = sqrt(1 - gamma3*gamma3) */
    const double t10 = t6*t9; /* I1*R*s */
    const double t11 = p[5]*x[3]; /* I3*omega3 */
    const double t12 = x[0]*p[1]; /* gamma3*R */
    const double t13 = p[3] + t12; /* b = a3 + gamma3*R */
    const double t14 = t11*t13; /* I3*omega3*b */
    const double t15 = p[6] + t14; /* G_level + I3*omega3*b */
    const double t16 = t15/t10; /* omega_n = (G_level + I3*omega3*b)/(I1*R*s) */
    const double t17 = p[4]*t16; /* I1*omega_n */
    const double t18 = p[4]*t9; /* I1*s */
    const double t19 = t11/t18; /* I3*omega3/(I1*s) */
    const double t20 = t9*t9; /* s*s */
    const double t21 = t9*t20; /* s*s*s */
    const double t22 = t6*t21; /* I1*R*s*s*s */
    const double t23 = x[0]*t15; /* gamma3*(G_level + I3*omega3*b) */
    const double t24 = t23/t22; /* gamma3*(G_level + I3*omega3*b)/(I1*R*s*s*s) */
    const double t25 = t19 + t24; /* d(omega_n)/d(gamma3) = I3*omega3/(I1*s) + gamma3*(G_level + I3*omega3*b)/(I1*R*s*s*s) */
    const double t26 = t17*t25; /* I1*omega_n*d(omega_n)/d(gamma3) */
    const double t27 = t5 + t26; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau + I1*omega_n*d(omega_n)/d(gamma3) */
    const double t28 = t13*t16; /* b*omega_n */
    const double t29 = p[1]*x[3]; /* R*omega3 */
    const double t30 = t9*t29; /* s*R*omega3 */
    const double t31 = t28 + t30; /* v_tau = b*omega_n + s*R*omega3 */
    const double t32 = p[0]*t31; /* m*v_tau */
    const double t33 = p[1]*t16; /* R*omega_n */
    const double t34 = x[3]*t12; /* omega3*gamma3*R */
    const double t35 = t34/t9; /* omega3*gamma3*R/s */
    const double t36 = t33 - t35; /* R*omega_n - omega3*gamma3*R/s */
    const double t37 = t13*t25; /* b*d(omega_n)/d(gamma3) */
    const double t38 = t36 + t37; /* d(v_tau)/d(gamma3) = R*omega_n - omega3*gamma3*R/s + b*d(omega_n)/d(gamma3) */
    const double t39 = t32*t38; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t40 = t27 + t39; /* d(energy)/d(gamma3) = t27 + m*v_tau*d(v_tau)/d(gamma3) */
    const double t41 = p[0]*x[1]; /* m*v_nu */
    const double t42 = t1*t20; /* m*a3*a3*s*s */
    const double t43 = p[4] + t42; /* D = I1 + m*a3*a3*s*s */
    const double t44 = x[2]*t43; /* omega_tau*D */
    const double t45 = p[5]*t16; /* I3*omega_n */
    const double t46 = p[1]*t9; /* R*s */
    const double t47 = t13*t45; /* b*I3*omega_n */
    const double t48 = t47/t46; /* b*I3*omega_n/(R*s) */
    const double t49 = t11 + t48; /* I3*omega3 + b*I3*omega_n/(R*s) */
    const double t50 = t13*t13; /* b*b */
    const double t51 = p[5]*t50; /* I3*b*b */
    const double t52 = t51/t10; /* I3*b*b/(I1*R*s) */
    const double t53 = t46 + t52; /* d(v_tau)/d(omega3) = R*s + I3*b*b/(I1*R*s) */
    const double t54 = t32*t53; /* m*v_tau*d(v_tau)/d(omega3) */
    const double t55 = t49 + t54; /* d(energy)/d(omega3) = I3*omega3 + b*I3*omega_n/(R*s) + m*v_tau*d(v_tau)/d(omega3) */
    out[0] = t40;
    out[1] = t41;
    out[2] = t44;
    out[3] = t55;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[4]; /* R*I1 */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0*t3; /* R*I1*s */
    const double t5 = p[5]*x[3]; /* I3*omega3 */
    const double t6 = p[1]*x[0]; /* R*gamma3 */
    const double t7 = p[3] + t6; /* b = a3 + R*gamma3 */
    const double t8 = t5*t7; /* I3*omega3*b */
    const double t9 = p[6] + t8; /* G_level + I3*omega3*b */
    const double t10 = t9/t4; /* omega_n = (G_level + I3*omega3*b)/(R*I1*s) */
    out[0] = t10;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double v_a3 = params[3];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
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
    out[3] = (-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 10,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 14, 50, 0, 9, 1, 0, 10, 9 }, { 15, 58, 0, 9, 1, 0, 10, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 41, 146, 0, 39, 1, 0, 18, 21 }, { 47, 240, 0, 39, 1, 0, 18, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 47, 155, 0, 47, 1, 0, 18, 45 }, { 54, 277, 0, 47, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 11, 32, 0, 5, 1, 0, 12, 9 }, { 12, 39, 0, 5, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 10, 31, 0, 1, 1, 0, 12, 6 }, { 10, 31, 0, 1, 1, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 14, 35, 0, 6, 1, 0, 12, 15 }, { 15, 50, 0, 6, 1, 0, 12, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 6, 0, 1, 1, 0, 5, 4 }, { 3, 6, 0, 1, 1, 0, 5, 4 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_on_level_G_baseline,
        &jlt_batch_spherical_top_general_on_level_G_avx2,
        &jlt_batch_spherical_top_general_on_level_G_avx512,
    },
};
