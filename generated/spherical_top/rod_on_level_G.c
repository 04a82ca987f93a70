/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 9   29    0    7    1    0      9    8   (50)
 *  jacobian            24   83    0   24    1    0     16   18   (183)
 *  rhs_jacobian        28   94    0   30    1    0     16   21   (216)
 *  divergence          2   10    0    1    1    0      7    4   (15)
 *  integral_values     11   26    0    1    1    0     11    9   (54)
 *  integral_gradients  10   30    0    4    1    0     11   12   (75)
 *  measure_values      2    6    0    1    1    0      7    4   (10)
 *  measure_divergences 3   13    0    2    1    0     10    5   (32)
 *  eliminated          1    3    0    1    1    0      5    3   (6)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_rod_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_on_level_G_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
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
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = t0*params[3]; /* m*g*a3 */
    out[7] = t1;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[4]; /* R*I1 */
    const double t5 = t2*t4; /* s*R*I1 */
    const double t6 = p[6]/t5; /* omega_n = G_level/(s*R*I1) */
    const double t7 = t6*t6; /* omega_n*omega_n */
    const double t8 = x[0]*p[1]; /* gamma3*R */
    const double t9 = p[3] + t8; /* b = a3 + gamma3*R */
    const double t10 = t7*t9; /* omega_n*omega_n*b */
    const double t11 = t10/t2; /* omega_n*omega_n*b/s */
    const double t12 = p[1]*t6; /* R*omega_n */
    const double t13 = t12*x[3]; /* R*omega_n*omega3 */
    const double t14 = t11 + t13; /* omega_n*omega_n*b/s + R*omega_n*omega3 */
    const double t15 = p[3]*p[3]; /* a3*a3 */
    const double t16 = p[0]*t15; /* m*a3*a3 */
    const double t17 = x[0]*t16; /* gamma3*m*a3*a3 */
    const double t18 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t19 = t17*t18; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t20 = t2*t19; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t21 = t2*t2; /* s*s */
    const double t22 = t16*t21; /* m*a3*a3*s*s */
    const double t23 = p[4] + t22; /* D = I1 + m*a3*a3*s*s */
    const double t24 = t20/t23; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t25 = p[0]*p[2]; /* m*g */
    const double t26 = p[3]*t25; /* a3*m*g */
    const double t27 = t2*t26; /* s*a3*m*g */
    const double t28 = t27/t23; /* s*a3*m*g/D */
    const double t29 = t24 - t28; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D */
    const double t30 = x[0]*p[4]; /* gamma3*I1 */
    const double t31 = t7*t30; /* omega_n*omega_n*gamma3*I1 */
    const double t32 = t2*t23; /* s*D */
    const double t33 = t31/t32; /* omega_n*omega_n*gamma3*I1/(s*D) */
    const double t34 = t29 - t33; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - omega_n*omega_n*gamma3*I1/(s*D) */
    const double t35 = p[1]*t21; /* R*s*s */
    const double t36 = x[0]*p[3]; /* gamma3*a3 */
    const double t37 = p[1] + t36; /* e = R + gamma3*a3 */
    const double t38 = x[2]*t37; /* omega_tau*e */
    const double t39 = x[1] + t38; /* V = v_nu + omega_tau*e */
    const double t40 = t6*t39; /* omega_n*V */
    const double t41 = t40/t35; /* omega_n*V/(R*s*s) */
    const double t42 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t43 = x[3]*t42; /* omega3*omega_tau*gamma3 */
    const double t44 = t43/t2; /* omega3*omega_tau*gamma3/s */
    const double t45 = t44 - t41; /* omega3*omega_tau*gamma3/s - omega_n*V/(R*s*s) */
    out[0] = t3;
    out[1] = t14;
    out[2] = t34;
    out[3] = t45;
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
    const double t8 = p[6]/t7; /* omega_n = G_level/(s*R*I1) */
    const double t9 = t8*t8; /* omega_n*omega_n */
    const double t10 = p[1]*t9; /* R*omega_n*omega_n */
    const double t11 = t10/t3; /* R*omega_n*omega_n/s */
    const double t12 = x[0]*t9; /* gamma3*omega_n*omega_n */
    const double t13 = t3*t3; /* s*s */
    const double t14 = t3*t13; /* s*s*s */
    const double t15 = x[0]*p[1]; /* gamma3*R */
    const double t16 = p[3] + t15; /* b = a3 + gamma3*R */
    const double t17 = t12*t16; /* gamma3*omega_n*omega_n*b */
    const double t18 = t17/t14; /* gamma3*omega_n*omega_n*b/(s*s*s) */
    const double t19 = t11 + t18; /* R*omega_n*omega_n/s + gamma3*omega_n*omega_n*b/(s*s*s) */
    const double t20 = x[0]*t8; /* gamma3*omega_n */
    const double t21 = t13*t13; /* s*s*s*s */
    const double t22 = t6*t21; /* R*I1*s*s*s*s */
    const double t23 = t16*t20; /* b*gamma3*omega_n */
    const double t24 = p[6]*t23; /* G_level*b*gamma3*omega_n */
    const double t25 = t24/t22; /* G_level*b*gamma3*omega_n/(R*I1*s*s*s*s) */
    const double t26 = t25*2.0; /* G_level*b*gamma3*omega_n/(R*I1*s*s*s*s)*2 */
    const double t27 = t19 + t26; /* R*omega_n*omega_n/s + gamma3*omega_n*omega_n*b/(s*s*s) + G_level*b*gamma3*omega_n/(R*I1*s*s*s*s)*2 */
    const double t28 = x[0]*x[3]; /* gamma3*omega3 */
    const double t29 = p[4]*t14; /* I1*s*s*s */
    const double t30 = p[6]*t28; /* G_level*gamma3*omega3 */
    const double t31 = t30/t29; /* G_level*gamma3*omega3/(I1*s*s*s) */
    const double t32 = t27 + t31; /* t27 + G_level*gamma3*omega3/(I1*s*s*s) */
    const double t33 = p[1]*t8; /* R*omega_n */
    const double t34 = p[3]*p[3]; /* a3*a3 */
    const double t35 = p[0]*t34; /* m*a3*a3 */
    const double t36 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t37 = t35*t36; /* m*a3*a3*omega_tau*omega_tau */
    const double t38 = t3*t37; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t39 = t13*t35; /* s*s*m*a3*a3 */
    const double t40 = p[4] + t39; /* D = I1 + s*s*m*a3*a3 */
    const double t41 = t38/t40; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t42 = t1*t35; /* gamma3*gamma3*m*a3*a3 */
    const double t43 = t36*t42; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t44 = t3*t40; /* s*D */
    const double t45 = t43/t44; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t46 = t41 - t45; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t47 = p[0]*p[0]; /* m*m */
    const double t48 = t34*t34; /* a3*a3*a3*a3 */
    const double t49 = t47*t48; /* m*m*a3*a3*a3*a3 */
    const double t50 = t1*t49; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t51 = t36*t50; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t52 = t3*t51; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t53 = t40*t40; /* D*D */
    const double t54 = t52/t53; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t55 = 2.0*t54; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t56 = t46 + t55; /* t46 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t57 = p[0]*p[2]; /* m*g */
    const double t58 = p[3]*t57; /* a3*m*g */
    const double t59 = x[0]*t58; /* gamma3*a3*m*g */
    const double t60 = t59/t44; /* gamma3*a3*m*g/(s*D) */
    const double t61 = t56 + t60; /* t56 + gamma3*a3*m*g/(s*D) */
    const double t62 = t47*p[2]; /* m*m*g */
    const double t63 = p[3]*t34; /* a3*a3*a3 */
    const double t64 = t62*t63; /* m*m*g*a3*a3*a3 */
    const double t65 = x[0]*t64; /* gamma3*m*m*g*a3*a3*a3 */
    const double t66 = t3*t65; /* s*gamma3*m*m*g*a3*a3*a3 */
    const double t67 = t66/t53; /* s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t68 = 2.0*t67; /* 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t69 = t61 - t68; /* t56 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t70 = p[4]*t9; /* I1*omega_n*omega_n */
    const double t71 = t70/t44; /* I1*omega_n*omega_n/(s*D) */
    const double t72 = t69 - t71; /* t56 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) - I1*omega_n*omega_n/(s*D) */
    const double t73 = t1*p[4]; /* gamma3*gamma3*I1 */
    const double t74 = t9*t73; /* omega_n*omega_n*gamma3*gamma3*I1 */
    const double t75 = t14*t40; /* s*s*s*D */
    const double t76 = t74/t75; /* omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) */
    const double t77 = t72 - t76; /* t72 - omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) */
    const double t78 = p[4]*t35; /* I1*m*a3*a3 */
    const double t79 = t1*t78; /* gamma3*gamma3*I1*m*a3*a3 */
    const double t80 = t9*t79; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3 */
    const double t81 = t3*t53; /* s*D*D */
    const double t82 = t80/t81; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t83 = 2.0*t82; /* 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t84 = t77 - t83; /* t72 - omega_n*omega_n*gamma3*gamma3*I1/(s*s*s*D) - 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t85 = t1*t8; /* gamma3*gamma3*omega_n */
    const double t86 = p[1]*t21; /* R*s*s*s*s */
    const double t87 = t40*t86; /* D*R*s*s*s*s */
    const double t88 = p[6]*t85; /* G_level*gamma3*gamma3*omega_n */
    const double t89 = t88/t87; /* G_level*gamma3*gamma3*omega_n/(D*R*s*s*s*s) */
    const double t90 = 2.0*t89; /* 2*G_level*gamma3*gamma3*omega_n/(D*R*s*s*s*s) */
    const double t91 = t84 - t90; /* t84 - 2*G_level*gamma3*gamma3*omega_n/(D*R*s*s*s*s) */
    const double t92 = 2.0*p[0]; /* 2*m */
    const double t93 = t34*t92; /* a3*a3*2*m */
    const double t94 = x[0]*t93; /* gamma3*a3*a3*2*m */
    const double t95 = x[2]*t94; /* omega_tau*gamma3*a3*a3*2*m */
    const double t96 = t3*t95; /* s*omega_tau*gamma3*a3*a3*2*m */
    const double t97 = t96/t40; /* s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t98 = x[2]*p[3]; /* omega_tau*a3 */
    const double t99 = t8*t98; /* omega_n*omega_tau*a3 */
    const double t100 = p[1]*t13; /* R*s*s */
    const double t101 = t99/t100; /* omega_n*omega_tau*a3/(R*s*s) */
    const double t102 = -t101; /* -omega_n*omega_tau*a3/(R*s*s) */
    const double t103 = x[0]*p[3]; /* gamma3*a3 */
    const double t104 = p[1] + t103; /* e = R + gamma3*a3 */
    const double t105 = x[2]*t104; /* omega_tau*e */
    const double t106 = x[1] + t105; /* V = v_nu + omega_tau*e */
    const double t107 = t20*t106; /* gamma3*omega_n*V */
    const double t108 = t107/t86; /* gamma3*omega_n*V/(R*s*s*s*s) */
    const double t109 = 2.0*t108; /* 2*gamma3*omega_n*V/(R*s*s*s*s) */
    const double t110 = t102 - t109; /* -omega_n*omega_tau*a3/(R*s*s) - 2*gamma3*omega_n*V/(R*s*s*s*s) */
    const double t111 = x[2]*x[3]; /* omega_tau*omega3 */
    const double t112 = t111/t3; /* omega_tau*omega3/s */
    const double t113 = t110 + t112; /* t110 + omega_tau*omega3/s */
    const double t114 = x[2]*t1; /* omega_tau*gamma3*gamma3 */
    const double t115 = x[3]*t114; /* omega3*omega_tau*gamma3*gamma3 */
    const double t116 = t115/t14; /* omega3*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t117 = t113 + t116; /* t110 + omega_tau*omega3/s + omega3*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t118 = p[1]*p[1]; /* R*R */
    const double t119 = p[4]*t118; /* I1*R*R */
    const double t120 = t3*t21; /* s*s*s*s*s */
    const double t121 = t119*t120; /* I1*R*R*s*s*s*s*s */
    const double t122 = x[0]*t106; /* gamma3*V */
    const double t123 = p[6]*t122; /* G_level*gamma3*V */
    const double t124 = t123/t121; /* G_level*gamma3*V/(I1*R*R*s*s*s*s*s) */
    const double t125 = t117 - t124; /* t117 - G_level*gamma3*V/(I1*R*R*s*s*s*s*s) */
    const double t126 = t8/t100; /* omega_n/(R*s*s) */
    const double t127 = -t126; /* -omega_n/(R*s*s) */
    const double t128 = t8*t104; /* omega_n*e */
    const double t129 = t128/t100; /* omega_n*e/(R*s*s) */
    const double t130 = t28/t3; /* gamma3*omega3/s */
    const double t131 = t130 - t129; /* gamma3*omega3/s - omega_n*e/(R*s*s) */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t32;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t33;
    out[8] = t91;
    out[9] = 0.0;
    out[10] = t97;
    out[11] = 0.0;
    out[12] = t125;
    out[13] = t127;
    out[14] = t131;
    out[15] = t4;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[4]; /* R*I1 */
    const double t5 = t2*t4; /* s*R*I1 */
    const double t6 = p[6]/t5; /* omega_n = G_level/(s*R*I1) */
    const double t7 = t6*t6; /* omega_n*omega_n */
    const double t8 = x[0]*p[1]; /* gamma3*R */
    const double t9 = p[3] + t8; /* b = a3 + gamma3*R */
    const double t10 = t7*t9; /* omega_n*omega_n*b */
    const double t11 = t10/t2; /* omega_n*omega_n*b/s */
    const double t12 = p[1]*t6; /* R*omega_n */
    const double t13 = t12*x[3]; /* R*omega_n*omega3 */
    const double t14 = t11 + t13; /* omega_n*omega_n*b/s + R*omega_n*omega3 */
    const double t15 = p[3]*p[3]; /* a3*a3 */
    const double t16 = p[0]*t15; /* m*a3*a3 */
    const double t17 = x[0]*t16; /* gamma3*m*a3*a3 */
    const double t18 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t19 = t17*t18; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t20 = t2*t19; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t21 = t2*t2; /* s*s */
    const double t22 = t16*t21; /* m*a3*a3*s*s */
    const double t23 = p[4] + t22; /* D = I1 + m*a3*a3*s*s */
    const double t24 = t20/t23; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t25 = p[0]*p[2]; /* m*g */
    const double t26 = p[3]*t25; /* a3*m*g */
    const double t27 = t2*t26; /* s*a3*m*g */
    const double t28 = t27/t23; /* s*a3*m*g/D */
    const double t29 = t24 - t28; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D */
    const double t30 = x[0]*p[4]; /* gamma3*I1 */
    const double t31 = t7*t30; /* omega_n*omega_n*gamma3*I1 */
    const double t32 = t2*t23; /* s*D */
    const double t33 = t31/t32; /* omega_n*omega_n*gamma3*I1/(s*D) */
    const double t34 = t29 - t33; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - omega_n*omega_n*gamma3*I1/(s*D) */
    const double t35 = p[1]*t21; /* R*s*s */
    const double t36 = x[0]*p[3]; /* gamma3*a3 */
    const double t37 = p[1] + t36; /* e = R + gamma3*a3 */
    const double t38 = x[2]*t37; /* omega_tau*e */
    const double t39 = x[1] + t38; /* V = v_nu + omega_tau*e */
    const double t40 = t6*t39; /* omega_n*V */
    const double t41 = t40/t35; /* omega_n*V/(R*s*s) */
    const double t42 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t43 = x[3]*t42; /* omega3*omega_tau*gamma3 */
    const double t44 = t43/t2; /* omega3*omega_tau*gamma3/s */
    const double t45 = t44 - t41; /* omega3*omega_tau*gamma3/s - omega_n*V/(R*s*s) */
    const double t46 = t42/t2; /* omega_tau*gamma3/s */
    const double t47 = -t46; /* -omega_tau*gamma3/s */
    const double t48 = p[1]*t7; /* R*omega_n*omega_n */
    const double t49 = t48/t2; /* R*omega_n*omega_n/s */
    const double t50 = x[0]*t7; /* gamma3*omega_n*omega_n */
    const double t51 = t2*t21; /* s*s*s */
    const double t52 = t9*t50; /* b*gamma3*omega_n*omega_n */
    const double t53 = t52/t51; /* b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t54 = t49 + t53; /* R*omega_n*omega_n/s + b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t55 = x[0]*t6; /* gamma3*omega_n */
    const double t56 = t21*t21; /* s*s*s*s */
    const double t57 = t4*t56; /* R*I1*s*s*s*s */
    const double t58 = t9*t55; /* b*gamma3*omega_n */
    const double t59 = p[6]*t58; /* G_level*b*gamma3*omega_n */
    const double t60 = t59/t57; /* G_level*b*gamma3*omega_n/(R*I1*s*s*s*s) */
    const double t61 = t60*2.0; /* G_level*b*gamma3*omega_n/(R*I1*s*s*s*s)*2 */
    const double t62 = t54 + t61; /* R*omega_n*omega_n/s + b*gamma3*omega_n*omega_n/(s*s*s) + G_level*b*gamma3*omega_n/(R*I1*s*s*s*s)*2 */
    const double t63 = x[0]*x[3]; /* gamma3*omega3 */
    const double t64 = p[4]*t51; /* I1*s*s*s */
    const double t65 = p[6]*t63; /* G_level*gamma3*omega3 */
    const double t66 = t65/t64; /* G_level*gamma3*omega3/(I1*s*s*s) */
    const double t67 = t62 + t66; /* t62 + G_level*gamma3*omega3/(I1*s*s*s) */
    const double t68 = t16*t18; /* m*a3*a3*omega_tau*omega_tau */
    const double t69 = t2*t68; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t70 = t69/t23; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t71 = t0*t16; /* gamma3*gamma3*m*a3*a3 */
    const double t72 = t18*t71; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t73 = t72/t32; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t74 = t70 - t73; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t75 = p[0]*p[0]; /* m*m */
    const double t76 = t15*t15; /* a3*a3*a3*a3 */
    const double t77 = t75*t76; /* m*m*a3*a3*a3*a3 */
    const double t78 = t0*t77; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t79 = t18*t78; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t80 = t2*t79; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t81 = t23*t23; /* D*D */
    const double t82 = t80/t81; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t83 = 2.0*t82; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t84 = t74 + t83; /* t74 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t85 = x[0]*t26; /* gamma3*a3*m*g */
    const double t86 = t85/t32; /* gamma3*a3*m*g/(s*D) */
    const double t87 = t84 + t86; /* t84 + gamma3*a3*m*g/(s*D) */
    const double t88 = p[2]*t75; /* g*m*m */
    const double t89 = p[3]*t15; /* a3*a3*a3 */
    const double t90 = t88*t89; /* g*m*m*a3*a3*a3 */
    const double t91 = x[0]*t90; /* gamma3*g*m*m*a3*a3*a3 */
    const double t92 = t2*t91; /* s*gamma3*g*m*m*a3*a3*a3 */
    const double t93 = t92/t81; /* s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t94 = 2.0*t93; /* 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t95 = t87 - t94; /* t84 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t96 = p[4]*t7; /* I1*omega_n*omega_n */
    const double t97 = t96/t32; /* I1*omega_n*omega_n/(s*D) */
    const double t98 = t95 - t97; /* t84 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) - I1*omega_n*omega_n/(s*D) */
    const double t99 = t0*p[4]; /* gamma3*gamma3*I1 */
    const double t100 = t7*t99; /* omega_n*omega_n*gamma3*gamma3*I1 */
    const double t101 = t23*t51; /* D*s*s*s */
    const double t102 = t100/t101; /* omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) */
    const double t103 = t98 - t102; /* t98 - omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) */
    const double t104 = p[4]*t16; /* I1*m*a3*a3 */
    const double t105 = t0*t104; /* gamma3*gamma3*I1*m*a3*a3 */
    const double t106 = t7*t105; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3 */
    const double t107 = t2*t81; /* s*D*D */
    const double t108 = t106/t107; /* omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t109 = 2.0*t108; /* 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t110 = t103 - t109; /* t98 - omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) - 2*omega_n*omega_n*gamma3*gamma3*I1*m*a3*a3/(s*D*D) */
    const double t111 = t0*t6; /* gamma3*gamma3*omega_n */
    const double t112 = p[1]*t56; /* R*s*s*s*s */
    const double t113 = t23*t112; /* D*R*s*s*s*s */
    const double t114 = p[6]*t111; /* G_level*gamma3*gamma3*omega_n */
    const double t115 = t114/t113; /* G_level*gamma3*gamma3*omega_n/(D*R*s*s*s*s) */
    const double t116 = 2.0*t115; /* 2*G_level*gamma3*gamma3*omega_n/(D*R*s*s*s*s) */
    const double t117 = t110 - t116; /* t110 - 2*G_level*gamma3*gamma3*omega_n/(D*R*s*s*s*s) */
    const double t118 = p[0]*2.0; /* m*2 */
    const double t119 = t15*t118; /* a3*a3*m*2 */
    const double t120 = x[0]*t119; /* gamma3*a3*a3*m*2 */
    const double t121 = x[2]*t120; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t122 = t2*t121; /* s*omega_tau*gamma3*a3*a3*m*2 */
    const double t123 = t122/t23; /* s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t124 = x[2]*p[3]; /* omega_tau*a3 */
    const double t125 = t6*t124; /* omega_n*omega_tau*a3 */
    const double t126 = t125/t35; /* omega_n*omega_tau*a3/(R*s*s) */
    const double t127 = -t126; /* -omega_n*omega_tau*a3/(R*s*s) */
    const double t128 = t39*t55; /* V*gamma3*omega_n */
    const double t129 = t128/t112; /* V*gamma3*omega_n/(R*s*s*s*s) */
    const double t130 = 2.0*t129; /* 2*V*gamma3*omega_n/(R*s*s*s*s) */
    const double t131 = t127 - t130; /* -omega_n*omega_tau*a3/(R*s*s) - 2*V*gamma3*omega_n/(R*s*s*s*s) */
    const double t132 = x[2]*x[3]; /* omega_tau*omega3 */
    const double t133 = t132/t2; /* omega_tau*omega3/s */
    const double t134 = t131 + t133; /* t131 + omega_tau*omega3/s */
    const double t135 = x[2]*t0; /* omega_tau*gamma3*gamma3 */
    const double t136 = x[3]*t135; /* omega3*omega_tau*gamma3*gamma3 */
    const double t137 = t136/t51; /* omega3*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t138 = t134 + t137; /* t131 + omega_tau*omega3/s + omega3*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t139 = p[1]*p[1]; /* R*R */
    const double t140 = p[4]*t139; /* I1*R*R */
    const double t141 = t2*t56; /* s*s*s*s*s */
    const double t142 = t140*t141; /* I1*R*R*s*s*s*s*s */
    const double t143 = x[0]*t39; /* gamma3*V */
    const double t144 = p[6]*t143; /* G_level*gamma3*V */
    const double t145 = t144/t142; /* G_level*gamma3*V/(I1*R*R*s*s*s*s*s) */
    const double t146 = t138 - t145; /* t138 - G_level*gamma3*V/(I1*R*R*s*s*s*s*s) */
    const double t147 = t6/t35; /* omega_n/(R*s*s) */
    const double t148 = -t147; /* -omega_n/(R*s*s) */
    const double t149 = t6*t37; /* omega_n*e */
    const double t150 = t149/t35; /* omega_n*e/(R*s*s) */
    const double t151 = t63/t2; /* gamma3*omega3/s */
    const double t152 = t151 - t150; /* gamma3*omega3/s - omega_n*e/(R*s*s) */
    out[0] = t3;
    out[1] = t14;
    out[2] = t34;
    out[3] = t45;
    out[4] = t47;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = t67;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t12;
    out[12] = t117;
    out[13] = 0.0;
    out[14] = t123;
    out[15] = 0.0;
    out[16] = t146;
    out[17] = t148;
    out[18] = t152;
    out[19] = t46;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 2.0*p[0]; /* 2*m */
    const double t1 = p[3]*p[3]; /* a3*a3 */
    const double t2 = t0*t1; /* 2*m*a3*a3 */
    const double t3 = t2*x[0]; /* 2*m*a3*a3*gamma3 */
    const double t4 = t3*x[2]; /* 2*m*a3*a3*gamma3*omega_tau */
    const double t5 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t6 = 1.0 - t5; /* 1 - gamma3*gamma3 */
    const double t7 = sqrt(t6); /* s = sqrt(1 - gamma3*gamma3) */
    const double t8 = t4*t7; /* 2*m*a3*a3*gamma3*omega_tau*s */
    const double t9 = p[0]*t1; /* m*a3*a3 */
    const double t10 = t7*t7; /* s*s */
    const double t11 = t9*t10; /* m*a3*a3*s*s */
    const double t12 = p[4] + t11; /* D = I1 + m*a3*a3*s*s */
    const double t13 = t8/t12; /* 2*m*a3*a3*gamma3*omega_tau*s/D */
    out[0] = t13;
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
    const double t21 = p[6]/t20; /* omega_n = G_level/(s*I1*R) */
    const double t22 = t21*t21; /* omega_n*omega_n */
    const double t23 = p[4]*t22; /* I1*omega_n*omega_n */
    const double t24 = (1.0 / 2.0)*t23; /* 1/2*I1*omega_n*omega_n */
    const double t25 = t18 + t24; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*I1*omega_n*omega_n */
    const double t26 = x[0]*p[1]; /* gamma3*R */
    const double t27 = p[3] + t26; /* b = a3 + gamma3*R */
    const double t28 = t21*t27; /* omega_n*b */
    const double t29 = p[1]*x[3]; /* R*omega3 */
    const double t30 = t12*t29; /* s*R*omega3 */
    const double t31 = t28 + t30; /* v_tau = omega_n*b + s*R*omega3 */
    const double t32 = t31*t31; /* v_tau*v_tau */
    const double t33 = p[0]*t32; /* m*v_tau*v_tau */
    const double t34 = (1.0 / 2.0)*t33; /* 1/2*m*v_tau*v_tau */
    const double t35 = t25 + t34; /* energy = t25 + 1/2*m*v_tau*v_tau */
    const double t36 = t5 + t34; /* m*v_nu*v_nu*1/2 + 1/2*m*v_tau*v_tau */
    const double t37 = t2 + t17; /* m*g*a3*gamma3 + 1/2*omega_tau*omega_tau*D */
    const double t38 = t24 + t37; /* 1/2*I1*omega_n*omega_n + m*g*a3*gamma3 + 1/2*omega_tau*omega_tau*D */
    out[0] = t35;
    out[1] = t36;
    out[2] = t38;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*p[3]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t4 = t2*t3; /* m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t5 = p[7] - t4; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t6 = p[1]*p[4]; /* R*I1 */
    const double t7 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t8 = 1.0 - t7; /* 1 - gamma3*gamma3 */
    const double t9 = sqrt(t8); /* s = sqrt(1 - gamma3*gamma3) */
    const double t10 = t6*t9; /* R*I1*s */
    const double t11 = p[6]/t10; /* omega_n = G_level/(R*I1*s) */
    const double t12 = x[0]*p[1]; /* gamma3*R */
    const double t13 = p[3] + t12; /* b = a3 + gamma3*R */
    const double t14 = t11*t13; /* omega_n*b */
    const double t15 = p[1]*x[3]; /* R*omega3 */
    const double t16 = t9*t15; /* s*R*omega3 */
    const double t17 = t14 + t16; /* v_tau = omega_n*b + s*R*omega3 */
    const double t18 = p[0]*t17; /* m*v_tau */
    const double t19 = p[1]*t11; /* R*omega_n */
    const double t20 = t12*x[3]; /* gamma3*R*omega3 */
    const double t21 = t20/t9; /* gamma3*R*omega3/s */
    const double t22 = t19 - t21; /* R*omega_n - gamma3*R*omega3/s */
    const double t23 = t9*t9; /* s*s */
    const double t24 = t9*t23; /* s*s*s */
    const double t25 = t6*t24; /* R*I1*s*s*s */
    const double t26 = x[0]*t13; /* gamma3*b */
    const double t27 = p[6]*t26; /* G_level*gamma3*b */
    const double t28 = t27/t25; /* G_level*gamma3*b/(R*I1*s*s*s) */
    const double t29 = t22 + t28; /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*R*omega3/s + G_level*gamma3*b/(R*I1*s*s*s) */
    const double t30 = t18*t29; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t31 = t5 + t30; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau + m*v_tau*d(v_tau)/d(gamma3) */
    const double t32 = x[0]*t11; /* gamma3*omega_n */
    const double t33 = p[1]*t24; /* R*s*s*s */
    const double t34 = p[6]*t32; /* G_level*gamma3*omega_n */
    const double t35 = t34/t33; /* G_level*gamma3*omega_n/(R*s*s*s) */
    const double t36 = t31 + t35; /* d(energy)/d(gamma3) = t31 + G_level*gamma3*omega_n/(R*s*s*s) */
    const double t37 = p[0]*x[1]; /* m*v_nu */
    const double t38 = t1*t23; /* m*a3*a3*s*s */
    const double t39 = p[4] + t38; /* D = I1 + m*a3*a3*s*s */
    const double t40 = x[2]*t39; /* omega_tau*D */
    const double t41 = p[0]*p[1]; /* m*R */
    const double t42 = t9*t41; /* s*m*R */
    const double t43 = t17*t42; /* v_tau*s*m*R */
    const double t44 = t5 + t35; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau + G_level*gamma3*omega_n/(R*s*s*s) */
    out[0] = t36;
    out[1] = t37;
    out[2] = t40;
    out[3] = t43;
    out[4] = t30;
    out[5] = t37;
    out[6] = 0.0;
    out[7] = t43;
    out[8] = t44;
    out[9] = 0.0;
    out[10] = t40;
    out[11] = 0.0;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[4]; /* R*I1 */
    const double t1 = p[3]*p[3]; /* a3*a3 */
    const double t2 = p[0]*t1; /* m*a3*a3 */
    const double t3 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t4 = 1.0 - t3; /* 1 - gamma3*gamma3 */
    const double t5 = sqrt(t4); /* s = sqrt(1 - gamma3*gamma3) */
    const double t6 = t5*t5; /* s*s */
    const double t7 = t2*t6; /* m*a3*a3*s*s */
    const double t8 = p[4] + t7; /* I1 + m*a3*a3*s*s */
    const double t9 = t8/t0; /* (I1 + m*a3*a3*s*s)/(R*I1) */
    out[0] = t9;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*p[3]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t4 = t3*x[2]; /* m*a3*a3*gamma3*omega_tau */
    const double t5 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t6 = 1.0 - t5; /* 1 - gamma3*gamma3 */
    const double t7 = sqrt(t6); /* s = sqrt(1 - gamma3*gamma3) */
    const double t8 = t4*t7; /* m*a3*a3*gamma3*omega_tau*s */
    const double t9 = t7*t7; /* s*s */
    const double t10 = t1*t9; /* m*a3*a3*s*s */
    const double t11 = p[4] + t10; /* D = I1 + m*a3*a3*s*s */
    const double t12 = t8*t11; /* m*a3*a3*gamma3*omega_tau*s*D */
    const double t13 = t2*t11; /* R*I1*D */
    const double t14 = t12/t13; /* m*a3*a3*gamma3*omega_tau*s*D/(R*I1*D) */
    const double t15 = t14*2.0; /* m*a3*a3*gamma3*omega_tau*s*D/(R*I1*D)*2 */
    const double t16 = t8/t2; /* m*a3*a3*gamma3*omega_tau*s/(R*I1) */
    const double t17 = 2.0*t16; /* 2*m*a3*a3*gamma3*omega_tau*s/(R*I1) */
    const double t18 = t15 - t17; /* m*a3*a3*gamma3*omega_tau*s*D/(R*I1*D)*2 - 2*m*a3*a3*gamma3*omega_tau*s/(R*I1) */
    out[0] = t18;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[4]; /* R*I1 */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0*t3; /* R*I1*s */
    const double t5 = p[6]/t4; /* omega_n = G_level/(R*I1*s) */
    out[0] = t5;
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
    const double v_I3 = (0.0);
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
    { "E1", "I3 = 0" },
    { "E2", "I3 = 0" },
};

static const jlt_named measures[] = {
    { "rho", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_rod_on_level_G = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 8,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 9, 29, 0, 7, 1, 0, 9, 8 }, { 9, 33, 0, 7, 1, 0, 9, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 24, 83, 0, 24, 1, 0, 16, 18 }, { 24, 133, 0, 25, 1, 0, 16, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 28, 94, 0, 30, 1, 0, 16, 21 }, { 28, 156, 0, 31, 1, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 10, 0, 1, 1, 0, 7, 4 }, { 2, 11, 0, 1, 1, 0, 7, 4 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 11, 26, 0, 1, 1, 0, 11, 9 }, { 11, 41, 0, 1, 1, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 12, { 10, 30, 0, 4, 1, 0, 11, 12 }, { 11, 58, 0, 5, 1, 0, 11, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { measure_values, 1, { 2, 6, 0, 1, 1, 0, 7, 4 }, { 2, 6, 0, 1, 1, 0, 7, 4 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_divergences = { measure_divergences, 1, { 3, 13, 0, 2, 1, 0, 10, 5 }, { 4, 25, 0, 2, 1, 0, 10, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 1, 3, 0, 1, 1, 0, 5, 3 }, { 1, 3, 0, 1, 1, 0, 5, 3 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 3, .measure_count = 1, .equilibria_count = 0,
    .integrals = integrals,
    .measures = measures,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_rod_on_level_G_baseline,
        &jlt_batch_spherical_top_rod_on_level_G_avx2,
        &jlt_batch_spherical_top_rod_on_level_G_avx512,
    },
};
