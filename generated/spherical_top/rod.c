/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 9   28    0    7    1    0      9    7   (50)
 *  jacobian            23   73    0   25    1    0     15   14   (170)
 *  rhs_jacobian        27   85    0   32    1    0     15   18   (206)
 *  divergence          3   10    0    2    1    0      9    5   (18)
 *  integral_values     11   27    0    0    1    0     11    9   (54)
 *  integral_gradients  9   28    0    2    1    0      8    9   (64)
 *  measure_values      2    6    0    0    1    0      7    4   (9)
 *  measure_divergences 5   17    0    3    1    0     11    7   (41)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_rod;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = t0*params[3]; /* m*g*a3 */
    out[6] = t1;
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
    const double t32 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t33 = x[3]*t32; /* omega_n*omega_tau*gamma3 */
    const double t34 = t33/t2; /* omega_n*omega_tau*gamma3/s */
    const double t35 = p[1]*t18; /* R*s*s */
    const double t36 = x[0]*p[3]; /* gamma3*a3 */
    const double t37 = p[1] + t36; /* e = R + gamma3*a3 */
    const double t38 = x[2]*t37; /* omega_tau*e */
    const double t39 = x[1] + t38; /* V = v_nu + omega_tau*e */
    const double t40 = x[3]*t39; /* omega_n*V */
    const double t41 = t40/t35; /* omega_n*V/(R*s*s) */
    const double t42 = x[4]*t32; /* omega3*omega_tau*gamma3 */
    const double t43 = t42/t2; /* omega3*omega_tau*gamma3/s */
    const double t44 = t43 - t41; /* omega3*omega_tau*gamma3/s - omega_n*V/(R*s*s) */
    out[0] = t3;
    out[1] = t11;
    out[2] = t31;
    out[3] = t34;
    out[4] = t44;
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
    const double t74 = 2.0*p[0]; /* 2*m */
    const double t75 = t23*t74; /* a3*a3*2*m */
    const double t76 = x[0]*t75; /* gamma3*a3*a3*2*m */
    const double t77 = x[2]*t76; /* omega_tau*gamma3*a3*a3*2*m */
    const double t78 = t3*t77; /* s*omega_tau*gamma3*a3*a3*2*m */
    const double t79 = t78/t29; /* s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t80 = p[4]*(-2.0); /* I1*(-2) */
    const double t81 = x[0]*t80; /* gamma3*I1*(-2) */
    const double t82 = x[3]*t81; /* omega_n*gamma3*I1*(-2) */
    const double t83 = t82/t33; /* omega_n*gamma3*I1*(-2)/(s*D) */
    const double t84 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t85 = t84/t3; /* omega_tau*omega_n/s */
    const double t86 = x[2]*t1; /* omega_tau*gamma3*gamma3 */
    const double t87 = x[3]*t86; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t88 = t87/t11; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t89 = t85 + t88; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t90 = x[0]*x[3]; /* gamma3*omega_n */
    const double t91 = t90/t3; /* gamma3*omega_n/s */
    const double t92 = x[2]*p[3]; /* omega_tau*a3 */
    const double t93 = x[3]*t92; /* omega_n*omega_tau*a3 */
    const double t94 = p[1]*t10; /* R*s*s */
    const double t95 = t93/t94; /* omega_n*omega_tau*a3/(R*s*s) */
    const double t96 = -t95; /* -omega_n*omega_tau*a3/(R*s*s) */
    const double t97 = t10*t10; /* s*s*s*s */
    const double t98 = p[1]*t97; /* R*s*s*s*s */
    const double t99 = x[0]*p[3]; /* gamma3*a3 */
    const double t100 = p[1] + t99; /* e = R + gamma3*a3 */
    const double t101 = x[2]*t100; /* omega_tau*e */
    const double t102 = x[1] + t101; /* V = v_nu + omega_tau*e */
    const double t103 = t90*t102; /* gamma3*omega_n*V */
    const double t104 = t103/t98; /* gamma3*omega_n*V/(R*s*s*s*s) */
    const double t105 = 2.0*t104; /* 2*gamma3*omega_n*V/(R*s*s*s*s) */
    const double t106 = t96 - t105; /* -omega_n*omega_tau*a3/(R*s*s) - 2*gamma3*omega_n*V/(R*s*s*s*s) */
    const double t107 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t108 = t107/t3; /* omega_tau*omega3/s */
    const double t109 = t106 + t108; /* t106 + omega_tau*omega3/s */
    const double t110 = x[4]*t86; /* omega3*omega_tau*gamma3*gamma3 */
    const double t111 = t110/t11; /* omega3*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t112 = t109 + t111; /* t106 + omega_tau*omega3/s + omega3*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t113 = x[3]/t94; /* omega_n/(R*s*s) */
    const double t114 = -t113; /* -omega_n/(R*s*s) */
    const double t115 = x[3]*t100; /* omega_n*e */
    const double t116 = t115/t94; /* omega_n*e/(R*s*s) */
    const double t117 = x[0]*x[4]; /* gamma3*omega3 */
    const double t118 = t117/t3; /* gamma3*omega3/s */
    const double t119 = t118 - t116; /* gamma3*omega3/s - omega_n*e/(R*s*s) */
    const double t120 = t102/t94; /* V/(R*s*s) */
    const double t121 = -t120; /* -V/(R*s*s) */
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
    out[10] = t73;
    out[11] = 0.0;
    out[12] = t79;
    out[13] = t83;
    out[14] = 0.0;
    out[15] = t89;
    out[16] = 0.0;
    out[17] = t91;
    out[18] = t4;
    out[19] = 0.0;
    out[20] = t112;
    out[21] = t114;
    out[22] = t119;
    out[23] = t121;
    out[24] = t4;
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
    const double t32 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t33 = x[3]*t32; /* omega_n*omega_tau*gamma3 */
    const double t34 = t33/t2; /* omega_n*omega_tau*gamma3/s */
    const double t35 = p[1]*t18; /* R*s*s */
    const double t36 = x[0]*p[3]; /* gamma3*a3 */
    const double t37 = p[1] + t36; /* e = R + gamma3*a3 */
    const double t38 = x[2]*t37; /* omega_tau*e */
    const double t39 = x[1] + t38; /* V = v_nu + omega_tau*e */
    const double t40 = x[3]*t39; /* omega_n*V */
    const double t41 = t40/t35; /* omega_n*V/(R*s*s) */
    const double t42 = x[4]*t32; /* omega3*omega_tau*gamma3 */
    const double t43 = t42/t2; /* omega3*omega_tau*gamma3/s */
    const double t44 = t43 - t41; /* omega3*omega_tau*gamma3/s - omega_n*V/(R*s*s) */
    const double t45 = t32/t2; /* omega_tau*gamma3/s */
    const double t46 = -t45; /* -omega_tau*gamma3/s */
    const double t47 = t4*p[1]; /* omega_n*omega_n*R */
    const double t48 = t47/t2; /* omega_n*omega_n*R/s */
    const double t49 = x[0]*t4; /* gamma3*omega_n*omega_n */
    const double t50 = t2*t18; /* s*s*s */
    const double t51 = t6*t49; /* b*gamma3*omega_n*omega_n */
    const double t52 = t51/t50; /* b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t53 = t48 + t52; /* omega_n*omega_n*R/s + b*gamma3*omega_n*omega_n/(s*s*s) */
    const double t54 = p[1]*x[4]; /* R*omega3 */
    const double t55 = x[3]*t6; /* omega_n*b */
    const double t56 = t55/t2; /* omega_n*b/s */
    const double t57 = t56*2.0; /* omega_n*b/s*2 */
    const double t58 = t54 + t57; /* R*omega3 + omega_n*b/s*2 */
    const double t59 = t13*t15; /* m*a3*a3*omega_tau*omega_tau */
    const double t60 = t2*t59; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t61 = t60/t20; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t62 = t0*t13; /* gamma3*gamma3*m*a3*a3 */
    const double t63 = t15*t62; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t64 = t63/t29; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t65 = t61 - t64; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t66 = p[0]*p[0]; /* m*m */
    const double t67 = t12*t12; /* a3*a3*a3*a3 */
    const double t68 = t66*t67; /* m*m*a3*a3*a3*a3 */
    const double t69 = t0*t68; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t70 = t15*t69; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t71 = t2*t70; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t72 = t20*t20; /* D*D */
    const double t73 = t71/t72; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t74 = 2.0*t73; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t75 = t65 + t74; /* t65 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t76 = x[0]*t23; /* gamma3*a3*m*g */
    const double t77 = t76/t29; /* gamma3*a3*m*g/(s*D) */
    const double t78 = t75 + t77; /* t75 + gamma3*a3*m*g/(s*D) */
    const double t79 = p[2]*t66; /* g*m*m */
    const double t80 = p[3]*t12; /* a3*a3*a3 */
    const double t81 = t79*t80; /* g*m*m*a3*a3*a3 */
    const double t82 = x[0]*t81; /* gamma3*g*m*m*a3*a3*a3 */
    const double t83 = t2*t82; /* s*gamma3*g*m*m*a3*a3*a3 */
    const double t84 = t83/t72; /* s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t85 = 2.0*t84; /* 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t86 = t78 - t85; /* t75 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t87 = t4*p[4]; /* omega_n*omega_n*I1 */
    const double t88 = t87/t29; /* omega_n*omega_n*I1/(s*D) */
    const double t89 = t86 - t88; /* t75 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) - omega_n*omega_n*I1/(s*D) */
    const double t90 = t0*p[4]; /* gamma3*gamma3*I1 */
    const double t91 = t4*t90; /* omega_n*omega_n*gamma3*gamma3*I1 */
    const double t92 = t20*t50; /* D*s*s*s */
    const double t93 = t91/t92; /* omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) */
    const double t94 = t89 - t93; /* t89 - omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) */
    const double t95 = t13*p[4]; /* m*a3*a3*I1 */
    const double t96 = t0*t95; /* gamma3*gamma3*m*a3*a3*I1 */
    const double t97 = t4*t96; /* omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1 */
    const double t98 = t2*t72; /* s*D*D */
    const double t99 = t97/t98; /* omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1/(s*D*D) */
    const double t100 = 2.0*t99; /* 2*omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1/(s*D*D) */
    const double t101 = t94 - t100; /* t89 - omega_n*omega_n*gamma3*gamma3*I1/(D*s*s*s) - 2*omega_n*omega_n*gamma3*gamma3*m*a3*a3*I1/(s*D*D) */
    const double t102 = p[0]*2.0; /* m*2 */
    const double t103 = t12*t102; /* a3*a3*m*2 */
    const double t104 = x[0]*t103; /* gamma3*a3*a3*m*2 */
    const double t105 = x[2]*t104; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t106 = t2*t105; /* s*omega_tau*gamma3*a3*a3*m*2 */
    const double t107 = t106/t20; /* s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t108 = p[4]*(-2.0); /* I1*(-2) */
    const double t109 = x[0]*t108; /* gamma3*I1*(-2) */
    const double t110 = x[3]*t109; /* omega_n*gamma3*I1*(-2) */
    const double t111 = t110/t29; /* omega_n*gamma3*I1*(-2)/(s*D) */
    const double t112 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t113 = t112/t2; /* omega_tau*omega_n/s */
    const double t114 = x[2]*t0; /* omega_tau*gamma3*gamma3 */
    const double t115 = x[3]*t114; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t116 = t115/t50; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t117 = t113 + t116; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t118 = x[0]*x[3]; /* gamma3*omega_n */
    const double t119 = t118/t2; /* gamma3*omega_n/s */
    const double t120 = x[2]*p[3]; /* omega_tau*a3 */
    const double t121 = x[3]*t120; /* omega_n*omega_tau*a3 */
    const double t122 = t121/t35; /* omega_n*omega_tau*a3/(R*s*s) */
    const double t123 = -t122; /* -omega_n*omega_tau*a3/(R*s*s) */
    const double t124 = t18*t18; /* s*s*s*s */
    const double t125 = p[1]*t124; /* R*s*s*s*s */
    const double t126 = t39*t118; /* V*gamma3*omega_n */
    const double t127 = t126/t125; /* V*gamma3*omega_n/(R*s*s*s*s) */
    const double t128 = 2.0*t127; /* 2*V*gamma3*omega_n/(R*s*s*s*s) */
    const double t129 = t123 - t128; /* -omega_n*omega_tau*a3/(R*s*s) - 2*V*gamma3*omega_n/(R*s*s*s*s) */
    const double t130 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t131 = t130/t2; /* omega_tau*omega3/s */
    const double t132 = t129 + t131; /* t129 + omega_tau*omega3/s */
    const double t133 = x[4]*t114; /* omega3*omega_tau*gamma3*gamma3 */
    const double t134 = t133/t50; /* omega3*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t135 = t132 + t134; /* t129 + omega_tau*omega3/s + omega3*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t136 = x[3]/t35; /* omega_n/(R*s*s) */
    const double t137 = -t136; /* -omega_n/(R*s*s) */
    const double t138 = x[3]*t37; /* omega_n*e */
    const double t139 = t138/t35; /* omega_n*e/(R*s*s) */
    const double t140 = x[0]*x[4]; /* gamma3*omega3 */
    const double t141 = t140/t2; /* gamma3*omega3/s */
    const double t142 = t141 - t139; /* gamma3*omega3/s - omega_n*e/(R*s*s) */
    const double t143 = t39/t35; /* V/(R*s*s) */
    const double t144 = -t143; /* -V/(R*s*s) */
    out[0] = t3;
    out[1] = t11;
    out[2] = t31;
    out[3] = t34;
    out[4] = t44;
    out[5] = t46;
    out[6] = 0.0;
    out[7] = t2;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = t53;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t58;
    out[14] = t9;
    out[15] = t101;
    out[16] = 0.0;
    out[17] = t107;
    out[18] = t111;
    out[19] = 0.0;
    out[20] = t117;
    out[21] = 0.0;
    out[22] = t119;
    out[23] = t45;
    out[24] = 0.0;
    out[25] = t135;
    out[26] = t137;
    out[27] = t142;
    out[28] = t144;
    out[29] = t45;
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
    const double t15 = t4 + t14; /* gamma3*omega_tau/s + s*omega_tau*gamma3*m*a3*a3/D*2 */
    out[0] = t15;
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
    const double t25 = x[3]*t24; /* omega_n*b */
    const double t26 = p[1]*x[4]; /* R*omega3 */
    const double t27 = t12*t26; /* s*R*omega3 */
    const double t28 = t25 + t27; /* v_tau = omega_n*b + s*R*omega3 */
    const double t29 = t28*t28; /* v_tau*v_tau */
    const double t30 = p[0]*t29; /* m*v_tau*v_tau */
    const double t31 = (1.0 / 2.0)*t30; /* 1/2*m*v_tau*v_tau */
    const double t32 = t22 + t31; /* energy = t22 + 1/2*m*v_tau*v_tau */
    const double t33 = p[4]*p[1]; /* I1*R */
    const double t34 = x[3]*t33; /* omega_n*I1*R */
    const double t35 = t12*t34; /* s*omega_n*I1*R */
    const double t36 = t5 + t31; /* m*v_nu*v_nu*1/2 + 1/2*m*v_tau*v_tau */
    const double t37 = t2 + t17; /* m*g*a3*gamma3 + 1/2*omega_tau*omega_tau*D */
    const double t38 = t21 + t37; /* 1/2*I1*omega_n*omega_n + m*g*a3*gamma3 + 1/2*omega_tau*omega_tau*D */
    out[0] = t32;
    out[1] = t35;
    out[2] = t36;
    out[3] = t38;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*p[3]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t4 = t2*t3; /* m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t5 = p[6] - t4; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau */
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
    const double t31 = p[0]*p[1]; /* m*R */
    const double t32 = t12*t31; /* s*m*R */
    const double t33 = t14*t32; /* v_tau*s*m*R */
    const double t34 = p[1]*p[4]; /* R*I1 */
    const double t35 = x[0]*t34; /* gamma3*R*I1 */
    const double t36 = x[3]*t35; /* omega_n*gamma3*R*I1 */
    const double t37 = t36/t12; /* omega_n*gamma3*R*I1/s */
    const double t38 = -t37; /* -omega_n*gamma3*R*I1/s */
    const double t39 = t12*t34; /* s*R*I1 */
    out[0] = t21;
    out[1] = t22;
    out[2] = t26;
    out[3] = t30;
    out[4] = t33;
    out[5] = t38;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t39;
    out[9] = 0.0;
    out[10] = t20;
    out[11] = t22;
    out[12] = 0.0;
    out[13] = t29;
    out[14] = t33;
    out[15] = t5;
    out[16] = 0.0;
    out[17] = t26;
    out[18] = t27;
    out[19] = 0.0;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = p[3]*p[3]; /* a3*a3 */
    const double t4 = p[0]*t3; /* m*a3*a3 */
    const double t5 = t2*t2; /* s*s */
    const double t6 = t4*t5; /* m*a3*a3*s*s */
    const double t7 = p[4] + t6; /* I1 + m*a3*a3*s*s */
    const double t8 = t2*t7; /* s*(I1 + m*a3*a3*s*s) */
    out[0] = t8;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = p[3]*p[3]; /* a3*a3 */
    const double t4 = p[0]*t3; /* m*a3*a3 */
    const double t5 = t2*t2; /* s*s */
    const double t6 = t4*t5; /* m*a3*a3*s*s */
    const double t7 = p[4] + t6; /* D = I1 + m*a3*a3*s*s */
    const double t8 = t2*t7; /* s*D */
    const double t9 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t10 = t9/t2; /* gamma3*omega_tau/s */
    const double t11 = x[0]*t4; /* gamma3*m*a3*a3 */
    const double t12 = x[2]*t11; /* omega_tau*gamma3*m*a3*a3 */
    const double t13 = t2*t12; /* s*omega_tau*gamma3*m*a3*a3 */
    const double t14 = t13/t7; /* s*omega_tau*gamma3*m*a3*a3/D */
    const double t15 = t14*2.0; /* s*omega_tau*gamma3*m*a3*a3/D*2 */
    const double t16 = t10 + t15; /* gamma3*omega_tau/s + s*omega_tau*gamma3*m*a3*a3/D*2 */
    const double t17 = t8*t16; /* s*D*(gamma3*omega_tau/s + s*omega_tau*gamma3*m*a3*a3/D*2) */
    const double t18 = t2*x[2]; /* s*omega_tau */
    const double t19 = x[0]*t7; /* gamma3*D */
    const double t20 = t19/t2; /* gamma3*D/s */
    const double t21 = t2*t11; /* s*gamma3*m*a3*a3 */
    const double t22 = 2.0*t21; /* 2*s*gamma3*m*a3*a3 */
    const double t23 = t20 + t22; /* gamma3*D/s + 2*s*gamma3*m*a3*a3 */
    const double t24 = t18*t23; /* s*omega_tau*(gamma3*D/s + 2*s*gamma3*m*a3*a3) */
    const double t25 = t17 - t24; /* s*D*(gamma3*omega_tau/s + s*omega_tau*gamma3*m*a3*a3/D*2) - s*omega_tau*(gamma3*D/s + 2*s*gamma3*m*a3*a3) */
    out[0] = t25;
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
    const double v_I3 = (0.0);
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
    { "E1", "I3 = 0" },
    { "E2", "I3 = 0" },
};

static const jlt_named measures[] = {
    { "rho", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_rod = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 6, .block_count = 7,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 9, 28, 0, 7, 1, 0, 9, 7 }, { 9, 33, 0, 7, 1, 0, 9, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 25, { 23, 73, 0, 25, 1, 0, 15, 14 }, { 23, 119, 0, 27, 1, 0, 15, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 27, 85, 0, 32, 1, 0, 15, 18 }, { 27, 144, 0, 34, 1, 0, 15, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 10, 0, 2, 1, 0, 9, 5 }, { 3, 12, 0, 2, 1, 0, 9, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 4, { 11, 27, 0, 0, 1, 0, 11, 9 }, { 11, 42, 0, 0, 1, 0, 11, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 20, { 9, 28, 0, 2, 1, 0, 8, 9 }, { 10, 51, 0, 2, 1, 0, 8, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { measure_values, 1, { 2, 6, 0, 0, 1, 0, 7, 4 }, { 2, 6, 0, 0, 1, 0, 7, 4 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_divergences = { measure_divergences, 1, { 5, 17, 0, 3, 1, 0, 11, 7 }, { 7, 30, 0, 3, 1, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 1, .equilibria_count = 0,
    .integrals = integrals,
    .measures = measures,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_rod_baseline,
        &jlt_batch_spherical_top_rod_avx2,
        &jlt_batch_spherical_top_rod_avx512,
    },
};
