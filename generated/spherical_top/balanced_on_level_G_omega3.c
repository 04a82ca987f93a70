/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 11   36    0    8    1    0     11    9   (64)
 *  jacobian            34   78    0   30    1    0     16   21   (216)
 *  rhs_jacobian        40   84    0   37    1    0     16   29   (255)
 *  divergence          6   20    0    3    1    0     11    7   (38)
 *  integral_values     11   39    0    1    1    0     14    7   (58)
 *  integral_gradients  16   59    0    7    1    0     13   12   (112)
 *  eliminated          2    6    0    1    1    0      6    4   (10)
 *
 *  Accuracy: divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_on_level_G_omega3_avx512;

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
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*x[3]; /* R*omega_n */
    const double t5 = p[1]*p[5]; /* R*I3 */
    const double t6 = x[0]*t5; /* gamma3*R*I3 */
    const double t7 = p[1]*p[4]; /* R*I1 */
    const double t8 = x[3]*t7; /* omega_n*R*I1 */
    const double t9 = t2*t8; /* s*omega_n*R*I1 */
    const double t10 = t9 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t11 = t10/t6; /* omega3 = (s*omega_n*R*I1 - G_level)/(gamma3*R*I3) */
    const double t12 = t4*t11; /* R*omega_n*omega3 */
    const double t13 = x[0]*p[1]; /* gamma3*R */
    const double t14 = x[3]*x[3]; /* omega_n*omega_n */
    const double t15 = t13*t14; /* gamma3*R*omega_n*omega_n */
    const double t16 = t15/t2; /* gamma3*R*omega_n*omega_n/s */
    const double t17 = t12 + t16; /* R*omega_n*omega3 + gamma3*R*omega_n*omega_n/s */
    const double t18 = x[0]*t14; /* gamma3*omega_n*omega_n */
    const double t19 = t18/t2; /* gamma3*omega_n*omega_n/s */
    const double t20 = -t19; /* -gamma3*omega_n*omega_n/s */
    const double t21 = x[3]*p[5]; /* omega_n*I3 */
    const double t22 = t11*t21; /* omega3*omega_n*I3 */
    const double t23 = t22/p[4]; /* omega3*omega_n*I3/I1 */
    const double t24 = t20 - t23; /* -gamma3*omega_n*omega_n/s - omega3*omega_n*I3/I1 */
    const double t25 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t26 = x[3]*t25; /* omega_n*omega_tau*gamma3 */
    const double t27 = t26/t2; /* omega_n*omega_tau*gamma3/s */
    const double t28 = p[5]*p[5]; /* I3*I3 */
    const double t29 = x[2]*t28; /* omega_tau*I3*I3 */
    const double t30 = t11*t29; /* omega3*omega_tau*I3*I3 */
    const double t31 = p[1]*p[1]; /* R*R */
    const double t32 = p[0]*t31; /* m*R*R */
    const double t33 = p[4]*t32; /* I1*m*R*R */
    const double t34 = t2*t2; /* s*s */
    const double t35 = t33*t34; /* I1*m*R*R*s*s */
    const double t36 = p[7] + t35; /* I1*I3 + I1*m*R*R*s*s */
    const double t37 = p[5]*t32; /* I3*m*R*R */
    const double t38 = t0*t37; /* gamma3*gamma3*I3*m*R*R */
    const double t39 = t36 + t38; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t40 = t30/t39; /* omega3*omega_tau*I3*I3/Theta */
    const double t41 = t27 + t40; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta */
    const double t42 = p[1]*p[0]; /* R*m */
    const double t43 = p[5]*t42; /* I3*R*m */
    const double t44 = x[0]*t43; /* gamma3*I3*R*m */
    const double t45 = x[3]*t44; /* omega_n*gamma3*I3*R*m */
    const double t46 = t2*t39; /* s*Theta */
    const double t47 = x[2]*p[1]; /* omega_tau*R */
    const double t48 = x[1] + t47; /* V = v_nu + omega_tau*R */
    const double t49 = t45*t48; /* omega_n*gamma3*I3*R*m*V */
    const double t50 = t49/t46; /* omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t51 = t41 - t50; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t52 = x[2]*t37; /* omega_tau*I3*m*R*R */
    const double t53 = t11*t52; /* omega3*omega_tau*I3*m*R*R */
    const double t54 = t53/t39; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t55 = t51 + t54; /* t51 + omega3*omega_tau*I3*m*R*R/Theta */
    out[0] = t3;
    out[1] = t17;
    out[2] = t24;
    out[3] = t55;
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
    const double t9 = p[1]*x[3]; /* R*omega_n */
    const double t10 = p[1]*p[5]; /* R*I3 */
    const double t11 = t1*t10; /* gamma3*gamma3*R*I3 */
    const double t12 = p[1]*p[4]; /* R*I1 */
    const double t13 = x[3]*t12; /* omega_n*R*I1 */
    const double t14 = t3*t13; /* s*omega_n*R*I1 */
    const double t15 = p[6] - t14; /* G_level - s*omega_n*R*I1 */
    const double t16 = t15/t11; /* (G_level - s*omega_n*R*I1)/(gamma3*gamma3*R*I3) */
    const double t17 = x[3]*p[4]; /* omega_n*I1 */
    const double t18 = t3*p[5]; /* s*I3 */
    const double t19 = t17/t18; /* omega_n*I1/(s*I3) */
    const double t20 = t16 - t19; /* d(omega3)/d(gamma3) = (G_level - s*omega_n*R*I1)/(gamma3*gamma3*R*I3) - omega_n*I1/(s*I3) */
    const double t21 = t9*t20; /* R*omega_n*d(omega3)/d(gamma3) */
    const double t22 = t8 + t21; /* R*omega_n*omega_n/s + R*omega_n*d(omega3)/d(gamma3) */
    const double t23 = t1*p[1]; /* gamma3*gamma3*R */
    const double t24 = t6*t23; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t25 = t3*t3; /* s*s */
    const double t26 = t3*t25; /* s*s*s */
    const double t27 = t24/t26; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t28 = t22 + t27; /* R*omega_n*omega_n/s + R*omega_n*d(omega3)/d(gamma3) + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t29 = x[0]*t10; /* gamma3*R*I3 */
    const double t30 = t14 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t31 = t30/t29; /* omega3 = (s*omega_n*R*I1 - G_level)/(gamma3*R*I3) */
    const double t32 = p[1]*t31; /* R*omega3 */
    const double t33 = x[0]*p[1]; /* gamma3*R */
    const double t34 = x[3]*t33; /* omega_n*gamma3*R */
    const double t35 = t34/t3; /* omega_n*gamma3*R/s */
    const double t36 = t35*2.0; /* omega_n*gamma3*R/s*2 */
    const double t37 = t32 + t36; /* R*omega3 + omega_n*gamma3*R/s*2 */
    const double t38 = x[0]*p[5]; /* gamma3*I3 */
    const double t39 = t14/t38; /* s*omega_n*R*I1/(gamma3*I3) */
    const double t40 = t37 + t39; /* R*omega3 + omega_n*gamma3*R/s*2 + s*omega_n*R*I1/(gamma3*I3) */
    const double t41 = t6/t3; /* omega_n*omega_n/s */
    const double t42 = -t41; /* -omega_n*omega_n/s */
    const double t43 = t1*t6; /* gamma3*gamma3*omega_n*omega_n */
    const double t44 = t43/t26; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t45 = t42 - t44; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t46 = x[3]*p[5]; /* omega_n*I3 */
    const double t47 = t20*t46; /* d(omega3)/d(gamma3)*omega_n*I3 */
    const double t48 = t47/p[4]; /* d(omega3)/d(gamma3)*omega_n*I3/I1 */
    const double t49 = t45 - t48; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) - d(omega3)/d(gamma3)*omega_n*I3/I1 */
    const double t50 = p[5]*t31; /* I3*omega3 */
    const double t51 = t50/p[4]; /* I3*omega3/I1 */
    const double t52 = -t51; /* -I3*omega3/I1 */
    const double t53 = x[0]*x[3]; /* gamma3*omega_n */
    const double t54 = t53/t3; /* gamma3*omega_n/s */
    const double t55 = 2.0*t54; /* 2*gamma3*omega_n/s */
    const double t56 = t52 - t55; /* -I3*omega3/I1 - 2*gamma3*omega_n/s */
    const double t57 = t3*x[3]; /* s*omega_n */
    const double t58 = t57/x[0]; /* s*omega_n/gamma3 */
    const double t59 = t56 - t58; /* -I3*omega3/I1 - 2*gamma3*omega_n/s - s*omega_n/gamma3 */
    const double t60 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t61 = t60/t3; /* omega_tau*omega_n/s */
    const double t62 = x[2]*t1; /* omega_tau*gamma3*gamma3 */
    const double t63 = x[3]*t62; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t64 = t63/t26; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t65 = t61 + t64; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t66 = p[1]*p[0]; /* R*m */
    const double t67 = p[5]*t66; /* I3*R*m */
    const double t68 = x[3]*t67; /* omega_n*I3*R*m */
    const double t69 = p[1]*p[1]; /* R*R */
    const double t70 = p[0]*t69; /* m*R*R */
    const double t71 = p[4]*t70; /* I1*m*R*R */
    const double t72 = t25*t71; /* s*s*I1*m*R*R */
    const double t73 = p[7] + t72; /* I1*I3 + s*s*I1*m*R*R */
    const double t74 = p[5]*t70; /* I3*m*R*R */
    const double t75 = t1*t74; /* gamma3*gamma3*I3*m*R*R */
    const double t76 = t73 + t75; /* Theta = I1*I3 + s*s*I1*m*R*R + gamma3*gamma3*I3*m*R*R */
    const double t77 = t3*t76; /* s*Theta */
    const double t78 = x[2]*p[1]; /* omega_tau*R */
    const double t79 = x[1] + t78; /* V = v_nu + omega_tau*R */
    const double t80 = t68*t79; /* omega_n*I3*R*m*V */
    const double t81 = t80/t77; /* omega_n*I3*R*m*V/(s*Theta) */
    const double t82 = t65 - t81; /* t65 - omega_n*I3*R*m*V/(s*Theta) */
    const double t83 = p[5]*p[5]; /* I3*I3 */
    const double t84 = x[2]*t83; /* omega_tau*I3*I3 */
    const double t85 = t20*t84; /* d(omega3)/d(gamma3)*omega_tau*I3*I3 */
    const double t86 = t85/t76; /* d(omega3)/d(gamma3)*omega_tau*I3*I3/Theta */
    const double t87 = t82 + t86; /* t65 - omega_n*I3*R*m*V/(s*Theta) + d(omega3)/d(gamma3)*omega_tau*I3*I3/Theta */
    const double t88 = t31*t84; /* omega3*omega_tau*I3*I3 */
    const double t89 = t76*t76; /* Theta*Theta */
    const double t90 = x[0]*t71; /* gamma3*I1*m*R*R */
    const double t91 = 2.0*t90; /* 2*gamma3*I1*m*R*R */
    const double t92 = x[0]*t74; /* gamma3*I3*m*R*R */
    const double t93 = 2.0*t92; /* 2*gamma3*I3*m*R*R */
    const double t94 = t93 - t91; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - 2*gamma3*I1*m*R*R */
    const double t95 = t88*t94; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3) */
    const double t96 = t95/t89; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t97 = t87 - t96; /* t87 - omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t98 = t1*t67; /* gamma3*gamma3*I3*R*m */
    const double t99 = x[3]*t98; /* omega_n*gamma3*gamma3*I3*R*m */
    const double t100 = t26*t76; /* s*s*s*Theta */
    const double t101 = t79*t99; /* V*omega_n*gamma3*gamma3*I3*R*m */
    const double t102 = t101/t100; /* V*omega_n*gamma3*gamma3*I3*R*m/(s*s*s*Theta) */
    const double t103 = t97 - t102; /* t97 - V*omega_n*gamma3*gamma3*I3*R*m/(s*s*s*Theta) */
    const double t104 = x[0]*t67; /* gamma3*I3*R*m */
    const double t105 = x[3]*t104; /* omega_n*gamma3*I3*R*m */
    const double t106 = t3*t89; /* s*Theta*Theta */
    const double t107 = t79*t105; /* V*omega_n*gamma3*I3*R*m */
    const double t108 = t94*t107; /* d(Theta)/d(gamma3)*V*omega_n*gamma3*I3*R*m */
    const double t109 = t108/t106; /* d(Theta)/d(gamma3)*V*omega_n*gamma3*I3*R*m/(s*Theta*Theta) */
    const double t110 = t103 + t109; /* t97 - V*omega_n*gamma3*gamma3*I3*R*m/(s*s*s*Theta) + d(Theta)/d(gamma3)*V*omega_n*gamma3*I3*R*m/(s*Theta*Theta) */
    const double t111 = x[2]*t74; /* omega_tau*I3*m*R*R */
    const double t112 = t20*t111; /* d(omega3)/d(gamma3)*omega_tau*I3*m*R*R */
    const double t113 = t112/t76; /* d(omega3)/d(gamma3)*omega_tau*I3*m*R*R/Theta */
    const double t114 = t110 + t113; /* t110 + d(omega3)/d(gamma3)*omega_tau*I3*m*R*R/Theta */
    const double t115 = t31*t111; /* omega3*omega_tau*I3*m*R*R */
    const double t116 = t94*t115; /* d(Theta)/d(gamma3)*omega3*omega_tau*I3*m*R*R */
    const double t117 = t116/t89; /* d(Theta)/d(gamma3)*omega3*omega_tau*I3*m*R*R/(Theta*Theta) */
    const double t118 = t114 - t117; /* t110 + d(omega3)/d(gamma3)*omega_tau*I3*m*R*R/Theta - d(Theta)/d(gamma3)*omega3*omega_tau*I3*m*R*R/(Theta*Theta) */
    const double t119 = t105/t77; /* omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t120 = -t119; /* -omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t121 = t31*t83; /* omega3*I3*I3 */
    const double t122 = t121/t76; /* omega3*I3*I3/Theta */
    const double t123 = t54 + t122; /* gamma3*omega_n/s + omega3*I3*I3/Theta */
    const double t124 = x[3]*t92; /* omega_n*gamma3*I3*m*R*R */
    const double t125 = t124/t77; /* omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t126 = t123 - t125; /* gamma3*omega_n/s + omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t127 = t31*t74; /* omega3*I3*m*R*R */
    const double t128 = t127/t76; /* omega3*I3*m*R*R/Theta */
    const double t129 = t126 + t128; /* t126 + omega3*I3*m*R*R/Theta */
    const double t130 = t79*t104; /* V*gamma3*I3*R*m */
    const double t131 = t130/t77; /* V*gamma3*I3*R*m/(s*Theta) */
    const double t132 = t4 - t131; /* gamma3*omega_tau/s - V*gamma3*I3*R*m/(s*Theta) */
    const double t133 = p[5]*p[4]; /* I3*I1 */
    const double t134 = x[2]*t133; /* omega_tau*I3*I1 */
    const double t135 = t3*t134; /* s*omega_tau*I3*I1 */
    const double t136 = x[0]*t76; /* gamma3*Theta */
    const double t137 = t135/t136; /* s*omega_tau*I3*I1/(gamma3*Theta) */
    const double t138 = t132 + t137; /* gamma3*omega_tau/s - V*gamma3*I3*R*m/(s*Theta) + s*omega_tau*I3*I1/(gamma3*Theta) */
    const double t139 = x[2]*t71; /* omega_tau*I1*m*R*R */
    const double t140 = t3*t139; /* s*omega_tau*I1*m*R*R */
    const double t141 = t140/t136; /* s*omega_tau*I1*m*R*R/(gamma3*Theta) */
    const double t142 = t138 + t141; /* t138 + s*omega_tau*I1*m*R*R/(gamma3*Theta) */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t28;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t40;
    out[8] = t49;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t59;
    out[12] = t118;
    out[13] = t120;
    out[14] = t129;
    out[15] = t142;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*x[3]; /* R*omega_n */
    const double t5 = p[1]*p[5]; /* R*I3 */
    const double t6 = x[0]*t5; /* gamma3*R*I3 */
    const double t7 = p[1]*p[4]; /* R*I1 */
    const double t8 = x[3]*t7; /* omega_n*R*I1 */
    const double t9 = t2*t8; /* s*omega_n*R*I1 */
    const double t10 = p[6] - t9; /* G_level - s*omega_n*R*I1 */
    const double t11 = t9 - p[6]; /* s*omega_n*R*I1 - G_level */
    const double t12 = t11/t6; /* omega3 = (s*omega_n*R*I1 - G_level)/(gamma3*R*I3) */
    const double t13 = t4*t12; /* R*omega_n*omega3 */
    const double t14 = x[0]*p[1]; /* gamma3*R */
    const double t15 = x[3]*x[3]; /* omega_n*omega_n */
    const double t16 = t14*t15; /* gamma3*R*omega_n*omega_n */
    const double t17 = t16/t2; /* gamma3*R*omega_n*omega_n/s */
    const double t18 = t13 + t17; /* R*omega_n*omega3 + gamma3*R*omega_n*omega_n/s */
    const double t19 = x[0]*t15; /* gamma3*omega_n*omega_n */
    const double t20 = t19/t2; /* gamma3*omega_n*omega_n/s */
    const double t21 = -t20; /* -gamma3*omega_n*omega_n/s */
    const double t22 = x[3]*p[5]; /* omega_n*I3 */
    const double t23 = t12*t22; /* omega3*omega_n*I3 */
    const double t24 = t23/p[4]; /* omega3*omega_n*I3/I1 */
    const double t25 = t21 - t24; /* -gamma3*omega_n*omega_n/s - omega3*omega_n*I3/I1 */
    const double t26 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t27 = x[3]*t26; /* omega_n*omega_tau*gamma3 */
    const double t28 = t27/t2; /* omega_n*omega_tau*gamma3/s */
    const double t29 = p[5]*p[5]; /* I3*I3 */
    const double t30 = x[2]*t29; /* omega_tau*I3*I3 */
    const double t31 = t12*t30; /* omega3*omega_tau*I3*I3 */
    const double t32 = p[1]*p[1]; /* R*R */
    const double t33 = p[0]*t32; /* m*R*R */
    const double t34 = p[4]*t33; /* I1*m*R*R */
    const double t35 = t2*t2; /* s*s */
    const double t36 = t34*t35; /* I1*m*R*R*s*s */
    const double t37 = p[7] + t36; /* I1*I3 + I1*m*R*R*s*s */
    const double t38 = p[5]*t33; /* I3*m*R*R */
    const double t39 = t0*t38; /* gamma3*gamma3*I3*m*R*R */
    const double t40 = t37 + t39; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t41 = t31/t40; /* omega3*omega_tau*I3*I3/Theta */
    const double t42 = t28 + t41; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta */
    const double t43 = p[1]*p[0]; /* R*m */
    const double t44 = p[5]*t43; /* I3*R*m */
    const double t45 = x[0]*t44; /* gamma3*I3*R*m */
    const double t46 = x[3]*t45; /* omega_n*gamma3*I3*R*m */
    const double t47 = t2*t40; /* s*Theta */
    const double t48 = x[2]*p[1]; /* omega_tau*R */
    const double t49 = x[1] + t48; /* V = v_nu + omega_tau*R */
    const double t50 = t46*t49; /* omega_n*gamma3*I3*R*m*V */
    const double t51 = t50/t47; /* omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t52 = t42 - t51; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t53 = x[2]*t38; /* omega_tau*I3*m*R*R */
    const double t54 = t12*t53; /* omega3*omega_tau*I3*m*R*R */
    const double t55 = t54/t40; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t56 = t52 + t55; /* t52 + omega3*omega_tau*I3*m*R*R/Theta */
    const double t57 = t26/t2; /* omega_tau*gamma3/s */
    const double t58 = -t57; /* -omega_tau*gamma3/s */
    const double t59 = p[1]*t15; /* R*omega_n*omega_n */
    const double t60 = t59/t2; /* R*omega_n*omega_n/s */
    const double t61 = t0*t5; /* gamma3*gamma3*R*I3 */
    const double t62 = t10/t61; /* (G_level - s*omega_n*R*I1)/(gamma3*gamma3*R*I3) */
    const double t63 = x[3]*p[4]; /* omega_n*I1 */
    const double t64 = t2*p[5]; /* s*I3 */
    const double t65 = t63/t64; /* omega_n*I1/(s*I3) */
    const double t66 = t62 - t65; /* d(omega3)/d(gamma3) = (G_level - s*omega_n*R*I1)/(gamma3*gamma3*R*I3) - omega_n*I1/(s*I3) */
    const double t67 = t4*t66; /* R*omega_n*d(omega3)/d(gamma3) */
    const double t68 = t60 + t67; /* R*omega_n*omega_n/s + R*omega_n*d(omega3)/d(gamma3) */
    const double t69 = t0*p[1]; /* gamma3*gamma3*R */
    const double t70 = t15*t69; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t71 = t2*t35; /* s*s*s */
    const double t72 = t70/t71; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t73 = t68 + t72; /* R*omega_n*omega_n/s + R*omega_n*d(omega3)/d(gamma3) + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t74 = p[1]*t12; /* R*omega3 */
    const double t75 = x[3]*t14; /* omega_n*gamma3*R */
    const double t76 = t75/t2; /* omega_n*gamma3*R/s */
    const double t77 = t76*2.0; /* omega_n*gamma3*R/s*2 */
    const double t78 = t74 + t77; /* R*omega3 + omega_n*gamma3*R/s*2 */
    const double t79 = x[0]*p[5]; /* gamma3*I3 */
    const double t80 = t9/t79; /* s*omega_n*R*I1/(gamma3*I3) */
    const double t81 = t78 + t80; /* R*omega3 + omega_n*gamma3*R/s*2 + s*omega_n*R*I1/(gamma3*I3) */
    const double t82 = t15/t2; /* omega_n*omega_n/s */
    const double t83 = -t82; /* -omega_n*omega_n/s */
    const double t84 = t0*t15; /* gamma3*gamma3*omega_n*omega_n */
    const double t85 = t84/t71; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t86 = t83 - t85; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t87 = t22*t66; /* omega_n*I3*d(omega3)/d(gamma3) */
    const double t88 = t87/p[4]; /* omega_n*I3*d(omega3)/d(gamma3)/I1 */
    const double t89 = t86 - t88; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) - omega_n*I3*d(omega3)/d(gamma3)/I1 */
    const double t90 = p[5]*t12; /* I3*omega3 */
    const double t91 = t90/p[4]; /* I3*omega3/I1 */
    const double t92 = -t91; /* -I3*omega3/I1 */
    const double t93 = x[0]*x[3]; /* gamma3*omega_n */
    const double t94 = t93/t2; /* gamma3*omega_n/s */
    const double t95 = 2.0*t94; /* 2*gamma3*omega_n/s */
    const double t96 = t92 - t95; /* -I3*omega3/I1 - 2*gamma3*omega_n/s */
    const double t97 = t2*x[3]; /* s*omega_n */
    const double t98 = t97/x[0]; /* s*omega_n/gamma3 */
    const double t99 = t96 - t98; /* -I3*omega3/I1 - 2*gamma3*omega_n/s - s*omega_n/gamma3 */
    const double t100 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t101 = t100/t2; /* omega_tau*omega_n/s */
    const double t102 = x[2]*t0; /* omega_tau*gamma3*gamma3 */
    const double t103 = x[3]*t102; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t104 = t103/t71; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t105 = t101 + t104; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t106 = x[3]*t44; /* omega_n*I3*R*m */
    const double t107 = t49*t106; /* V*omega_n*I3*R*m */
    const double t108 = t107/t47; /* V*omega_n*I3*R*m/(s*Theta) */
    const double t109 = t105 - t108; /* t105 - V*omega_n*I3*R*m/(s*Theta) */
    const double t110 = t30*t66; /* omega_tau*I3*I3*d(omega3)/d(gamma3) */
    const double t111 = t110/t40; /* omega_tau*I3*I3*d(omega3)/d(gamma3)/Theta */
    const double t112 = t109 + t111; /* t105 - V*omega_n*I3*R*m/(s*Theta) + omega_tau*I3*I3*d(omega3)/d(gamma3)/Theta */
    const double t113 = t40*t40; /* Theta*Theta */
    const double t114 = x[0]*t34; /* gamma3*I1*m*R*R */
    const double t115 = 2.0*t114; /* 2*gamma3*I1*m*R*R */
    const double t116 = x[0]*t38; /* gamma3*I3*m*R*R */
    const double t117 = 2.0*t116; /* 2*gamma3*I3*m*R*R */
    const double t118 = t117 - t115; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - 2*gamma3*I1*m*R*R */
    const double t119 = t31*t118; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3) */
    const double t120 = t119/t113; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t121 = t112 - t120; /* t112 - omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t122 = t0*t44; /* gamma3*gamma3*I3*R*m */
    const double t123 = x[3]*t122; /* omega_n*gamma3*gamma3*I3*R*m */
    const double t124 = t40*t71; /* Theta*s*s*s */
    const double t125 = t49*t123; /* V*omega_n*gamma3*gamma3*I3*R*m */
    const double t126 = t125/t124; /* V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) */
    const double t127 = t121 - t126; /* t121 - V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) */
    const double t128 = t2*t113; /* s*Theta*Theta */
    const double t129 = t50*t118; /* omega_n*gamma3*I3*R*m*V*d(Theta)/d(gamma3) */
    const double t130 = t129/t128; /* omega_n*gamma3*I3*R*m*V*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t131 = t127 + t130; /* t121 - V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) + omega_n*gamma3*I3*R*m*V*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t132 = t53*t66; /* omega_tau*I3*m*R*R*d(omega3)/d(gamma3) */
    const double t133 = t132/t40; /* omega_tau*I3*m*R*R*d(omega3)/d(gamma3)/Theta */
    const double t134 = t131 + t133; /* t131 + omega_tau*I3*m*R*R*d(omega3)/d(gamma3)/Theta */
    const double t135 = t54*t118; /* omega3*omega_tau*I3*m*R*R*d(Theta)/d(gamma3) */
    const double t136 = t135/t113; /* omega3*omega_tau*I3*m*R*R*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t137 = t134 - t136; /* t131 + omega_tau*I3*m*R*R*d(omega3)/d(gamma3)/Theta - omega3*omega_tau*I3*m*R*R*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t138 = t46/t47; /* omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t139 = -t138; /* -omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t140 = t12*t29; /* omega3*I3*I3 */
    const double t141 = t140/t40; /* omega3*I3*I3/Theta */
    const double t142 = t94 + t141; /* gamma3*omega_n/s + omega3*I3*I3/Theta */
    const double t143 = x[3]*t116; /* omega_n*gamma3*I3*m*R*R */
    const double t144 = t143/t47; /* omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t145 = t142 - t144; /* gamma3*omega_n/s + omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t146 = t12*t38; /* omega3*I3*m*R*R */
    const double t147 = t146/t40; /* omega3*I3*m*R*R/Theta */
    const double t148 = t145 + t147; /* t145 + omega3*I3*m*R*R/Theta */
    const double t149 = t45*t49; /* gamma3*I3*R*m*V */
    const double t150 = t149/t47; /* gamma3*I3*R*m*V/(s*Theta) */
    const double t151 = t57 - t150; /* omega_tau*gamma3/s - gamma3*I3*R*m*V/(s*Theta) */
    const double t152 = p[5]*p[4]; /* I3*I1 */
    const double t153 = x[2]*t152; /* omega_tau*I3*I1 */
    const double t154 = t2*t153; /* s*omega_tau*I3*I1 */
    const double t155 = x[0]*t40; /* gamma3*Theta */
    const double t156 = t154/t155; /* s*omega_tau*I3*I1/(gamma3*Theta) */
    const double t157 = t151 + t156; /* omega_tau*gamma3/s - gamma3*I3*R*m*V/(s*Theta) + s*omega_tau*I3*I1/(gamma3*Theta) */
    const double t158 = x[2]*t34; /* omega_tau*I1*m*R*R */
    const double t159 = t2*t158; /* s*omega_tau*I1*m*R*R */
    const double t160 = t159/t155; /* s*omega_tau*I1*m*R*R/(gamma3*Theta) */
    const double t161 = t157 + t160; /* t157 + s*omega_tau*I1*m*R*R/(gamma3*Theta) */
    out[0] = t3;
    out[1] = t18;
    out[2] = t25;
    out[3] = t56;
    out[4] = t58;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = t73;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t81;
    out[12] = t89;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t99;
    out[16] = t137;
    out[17] = t139;
    out[18] = t148;
    out[19] = t161;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[1]; /* m*R */
    const double t1 = t0*p[5]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t4 = 1.0 - t3; /* 1 - gamma3*gamma3 */
    const double t5 = sqrt(t4); /* s = sqrt(1 - gamma3*gamma3) */
    const double t6 = p[1]*p[1]; /* R*R */
    const double t7 = p[0]*t6; /* m*R*R */
    const double t8 = t7*p[4]; /* m*R*R*I1 */
    const double t9 = t5*t5; /* s*s */
    const double t10 = t8*t9; /* m*R*R*I1*s*s */
    const double t11 = p[7] + t10; /* I1*I3 + m*R*R*I1*s*s */
    const double t12 = p[5]*t7; /* I3*m*R*R */
    const double t13 = t3*t12; /* gamma3*gamma3*I3*m*R*R */
    const double t14 = t11 + t13; /* Theta = I1*I3 + m*R*R*I1*s*s + gamma3*gamma3*I3*m*R*R */
    const double t15 = t5*t14; /* s*Theta */
    const double t16 = p[1]*x[2]; /* R*omega_tau */
    const double t17 = x[1] + t16; /* V = v_nu + R*omega_tau */
    const double t18 = t2*t17; /* m*R*I3*gamma3*V */
    const double t19 = t18/t15; /* m*R*I3*gamma3*V/(s*Theta) */
    const double t20 = p[5]*p[4]; /* I3*I1 */
    const double t21 = x[2]*t20; /* omega_tau*I3*I1 */
    const double t22 = t5*t21; /* s*omega_tau*I3*I1 */
    const double t23 = x[0]*t14; /* gamma3*Theta */
    const double t24 = t22/t23; /* s*omega_tau*I3*I1/(gamma3*Theta) */
    const double t25 = t24 - t19; /* s*omega_tau*I3*I1/(gamma3*Theta) - m*R*I3*gamma3*V/(s*Theta) */
    const double t26 = t8*x[2]; /* m*R*R*I1*omega_tau */
    const double t27 = t5*t26; /* s*m*R*R*I1*omega_tau */
    const double t28 = t27/t23; /* s*m*R*R*I1*omega_tau/(gamma3*Theta) */
    const double t29 = t25 + t28; /* s*omega_tau*I3*I1/(gamma3*Theta) - m*R*I3*gamma3*V/(s*Theta) + s*m*R*R*I1*omega_tau/(gamma3*Theta) */
    out[0] = t29;
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
    const double t11 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t12 = 1.0 - t11; /* 1 - gamma3*gamma3 */
    const double t13 = sqrt(t12); /* s = sqrt(1 - gamma3*gamma3) */
    const double t14 = t10*t13; /* omega_n*I1*R*s */
    const double t15 = t14 - p[6]; /* omega_n*I1*R*s - G_level */
    const double t16 = t15/t8; /* omega3 = (omega_n*I1*R*s - G_level)/(I3*R*gamma3) */
    const double t17 = t16*t16; /* omega3*omega3 */
    const double t18 = p[5]*t17; /* I3*omega3*omega3 */
    const double t19 = (1.0 / 2.0)*t18; /* 1/2*I3*omega3*omega3 */
    const double t20 = t6 + t19; /* m*v_nu*v_nu*1/2 + 1/2*I1*omega_n*omega_n + 1/2*I3*omega3*omega3 */
    const double t21 = p[1]*t16; /* R*omega3 */
    const double t22 = t13*t21; /* s*R*omega3 */
    const double t23 = p[1]*x[0]; /* R*gamma3 */
    const double t24 = x[3]*t23; /* omega_n*R*gamma3 */
    const double t25 = t22 + t24; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t26 = t25*t25; /* v_tau*v_tau */
    const double t27 = p[0]*t26; /* m*v_tau*v_tau */
    const double t28 = (1.0 / 2.0)*t27; /* 1/2*m*v_tau*v_tau */
    const double t29 = t20 + t28; /* t20 + 1/2*m*v_tau*v_tau */
    const double t30 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t31 = p[4]*t30; /* I1*omega_tau*omega_tau */
    const double t32 = (1.0 / 2.0)*t31; /* 1/2*I1*omega_tau*omega_tau */
    const double t33 = t29 + t32; /* energy = t20 + 1/2*m*v_tau*v_tau + 1/2*I1*omega_tau*omega_tau */
    const double t34 = p[4]*p[4]; /* I1*I1 */
    const double t35 = p[0]*t34; /* m*I1*I1 */
    const double t36 = p[1]*x[2]; /* R*omega_tau */
    const double t37 = x[1] + t36; /* v_nu + R*omega_tau */
    const double t38 = t37*t37; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t39 = t35*t38; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t40 = p[1]*p[1]; /* R*R */
    const double t41 = p[0]*t40; /* m*R*R */
    const double t42 = p[4]*t41; /* I1*m*R*R */
    const double t43 = t13*t13; /* s*s */
    const double t44 = t42*t43; /* I1*m*R*R*s*s */
    const double t45 = p[7] + t44; /* I1*I3 + I1*m*R*R*s*s */
    const double t46 = p[5]*t41; /* I3*m*R*R */
    const double t47 = t11*t46; /* gamma3*gamma3*I3*m*R*R */
    const double t48 = t45 + t47; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t49 = t17*t48; /* omega3*omega3*Theta */
    const double t50 = t49*p[8]; /* omega3*omega3*Theta*(I1 - I3) */
    const double t51 = t39 + t50; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) + omega3*omega3*Theta*(I1 - I3) */
    out[0] = t33;
    out[1] = t51;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[5]; /* R*I3 */
    const double t1 = t0*x[0]; /* R*I3*gamma3 */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = t2*x[3]; /* R*I1*omega_n */
    const double t4 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t5 = 1.0 - t4; /* 1 - gamma3*gamma3 */
    const double t6 = sqrt(t5); /* s = sqrt(1 - gamma3*gamma3) */
    const double t7 = t3*t6; /* R*I1*omega_n*s */
    const double t8 = p[6] - t7; /* G_level - R*I1*omega_n*s */
    const double t9 = t7 - p[6]; /* R*I1*omega_n*s - G_level */
    const double t10 = t9/t1; /* omega3 = (R*I1*omega_n*s - G_level)/(R*I3*gamma3) */
    const double t11 = p[1]*t10; /* R*omega3 */
    const double t12 = t6*t11; /* s*R*omega3 */
    const double t13 = p[1]*x[0]; /* R*gamma3 */
    const double t14 = x[3]*t13; /* omega_n*R*gamma3 */
    const double t15 = t12 + t14; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t16 = p[0]*t15; /* m*v_tau */
    const double t17 = p[1]*x[3]; /* R*omega_n */
    const double t18 = t10*t13; /* omega3*R*gamma3 */
    const double t19 = t18/t6; /* omega3*R*gamma3/s */
    const double t20 = t17 - t19; /* R*omega_n - omega3*R*gamma3/s */
    const double t21 = p[1]*t6; /* R*s */
    const double t22 = t0*t4; /* R*I3*gamma3*gamma3 */
    const double t23 = t8/t22; /* (G_level - R*I1*omega_n*s)/(R*I3*gamma3*gamma3) */
    const double t24 = p[4]*x[3]; /* I1*omega_n */
    const double t25 = p[5]*t6; /* I3*s */
    const double t26 = t24/t25; /* I1*omega_n/(I3*s) */
    const double t27 = t23 - t26; /* d(omega3)/d(gamma3) = (G_level - R*I1*omega_n*s)/(R*I3*gamma3*gamma3) - I1*omega_n/(I3*s) */
    const double t28 = t21*t27; /* R*s*d(omega3)/d(gamma3) */
    const double t29 = t20 + t28; /* d(v_tau)/d(gamma3) = R*omega_n - omega3*R*gamma3/s + R*s*d(omega3)/d(gamma3) */
    const double t30 = t16*t29; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t31 = p[5]*t10; /* I3*omega3 */
    const double t32 = t27*t31; /* d(omega3)/d(gamma3)*I3*omega3 */
    const double t33 = t30 + t32; /* d(energy)/d(gamma3) = m*v_tau*d(v_tau)/d(gamma3) + d(omega3)/d(gamma3)*I3*omega3 */
    const double t34 = p[0]*x[1]; /* m*v_nu */
    const double t35 = p[4]*x[2]; /* I1*omega_tau */
    const double t36 = p[5]*x[0]; /* I3*gamma3 */
    const double t37 = t6*t6; /* s*s */
    const double t38 = t2*t37; /* R*I1*s*s */
    const double t39 = t38/t36; /* R*I1*s*s/(I3*gamma3) */
    const double t40 = t13 + t39; /* d(v_tau)/d(omega_n) = R*gamma3 + R*I1*s*s/(I3*gamma3) */
    const double t41 = t16*t40; /* m*v_tau*d(v_tau)/d(omega_n) */
    const double t42 = t24 + t41; /* I1*omega_n + m*v_tau*d(v_tau)/d(omega_n) */
    const double t43 = p[4]*t10; /* I1*omega3 */
    const double t44 = t6*t43; /* s*I1*omega3 */
    const double t45 = t44/x[0]; /* s*I1*omega3/gamma3 */
    const double t46 = t42 + t45; /* d(energy)/d(omega_n) = I1*omega_n + m*v_tau*d(v_tau)/d(omega_n) + s*I1*omega3/gamma3 */
    const double t47 = t10*t10; /* omega3*omega3 */
    const double t48 = t47*p[8]; /* omega3*omega3*(I1 - I3) */
    const double t49 = p[1]*p[1]; /* R*R */
    const double t50 = p[0]*t49; /* m*R*R */
    const double t51 = p[4]*t50; /* I1*m*R*R */
    const double t52 = x[0]*t51; /* gamma3*I1*m*R*R */
    const double t53 = t52*2.0; /* gamma3*I1*m*R*R*2 */
    const double t54 = p[5]*t50; /* I3*m*R*R */
    const double t55 = x[0]*t54; /* gamma3*I3*m*R*R */
    const double t56 = 2.0*t55; /* 2*gamma3*I3*m*R*R */
    const double t57 = t56 - t53; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - gamma3*I1*m*R*R*2 */
    const double t58 = t48*t57; /* omega3*omega3*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t59 = t37*t51; /* s*s*I1*m*R*R */
    const double t60 = p[7] + t59; /* I1*I3 + s*s*I1*m*R*R */
    const double t61 = t4*t54; /* gamma3*gamma3*I3*m*R*R */
    const double t62 = t60 + t61; /* Theta = I1*I3 + s*s*I1*m*R*R + gamma3*gamma3*I3*m*R*R */
    const double t63 = t10*t62; /* omega3*Theta */
    const double t64 = p[8]*t63; /* (I1 - I3)*omega3*Theta */
    const double t65 = t27*t64; /* d(omega3)/d(gamma3)*(I1 - I3)*omega3*Theta */
    const double t66 = 2.0*t65; /* 2*d(omega3)/d(gamma3)*(I1 - I3)*omega3*Theta */
    const double t67 = t58 + t66; /* omega3*omega3*(I1 - I3)*d(Theta)/d(gamma3) + 2*d(omega3)/d(gamma3)*(I1 - I3)*omega3*Theta */
    const double t68 = p[0]*2.0; /* m*2 */
    const double t69 = p[4]*p[4]; /* I1*I1 */
    const double t70 = t68*t69; /* m*2*I1*I1 */
    const double t71 = p[1]*x[2]; /* R*omega_tau */
    const double t72 = x[1] + t71; /* v_nu + R*omega_tau */
    const double t73 = t70*t72; /* m*2*I1*I1*(v_nu + R*omega_tau) */
    const double t74 = p[1]*t68; /* R*m*2 */
    const double t75 = t69*t74; /* I1*I1*R*m*2 */
    const double t76 = t72*t75; /* (v_nu + R*omega_tau)*I1*I1*R*m*2 */
    const double t77 = p[4]*2.0; /* I1*2 */
    const double t78 = t10*t77; /* omega3*I1*2 */
    const double t79 = t6*t78; /* s*omega3*I1*2 */
    const double t80 = t62*t79; /* Theta*s*omega3*I1*2 */
    const double t81 = p[8]*t80; /* (I1 - I3)*Theta*s*omega3*I1*2 */
    const double t82 = t81/t36; /* (I1 - I3)*Theta*s*omega3*I1*2/(I3*gamma3) */
    out[0] = t33;
    out[1] = t34;
    out[2] = t35;
    out[3] = t46;
    out[4] = t67;
    out[5] = t73;
    out[6] = t76;
    out[7] = t82;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[5]; /* R*I3 */
    const double t1 = t0*x[0]; /* R*I3*gamma3 */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = t2*x[3]; /* R*I1*omega_n */
    const double t4 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t5 = 1.0 - t4; /* 1 - gamma3*gamma3 */
    const double t6 = sqrt(t5); /* s = sqrt(1 - gamma3*gamma3) */
    const double t7 = t3*t6; /* R*I1*omega_n*s */
    const double t8 = t7 - p[6]; /* R*I1*omega_n*s - G_level */
    const double t9 = t8/t1; /* omega3 = (R*I1*omega_n*s - G_level)/(R*I3*gamma3) */
    out[0] = t9;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double complex v_omega_n = x[3];
    const double v_a3 = (0.0);
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
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "balanced",
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
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 11, 36, 0, 8, 1, 0, 11, 9 }, { 11, 44, 0, 8, 1, 0, 11, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 34, 78, 0, 30, 1, 0, 16, 21 }, { 34, 149, 0, 32, 1, 0, 16, 11 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 40, 84, 0, 37, 1, 0, 16, 29 }, { 40, 175, 0, 39, 1, 0, 16, 11 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 6, 20, 0, 3, 1, 0, 11, 7 }, { 6, 28, 0, 3, 1, 0, 11, 6 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 11, 39, 0, 1, 1, 0, 14, 7 }, { 12, 44, 0, 1, 1, 0, 14, 6 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 8, { 16, 59, 0, 7, 1, 0, 13, 12 }, { 20, 84, 0, 7, 1, 0, 13, 10 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 6, 0, 1, 1, 0, 6, 4 }, { 2, 6, 0, 1, 1, 0, 6, 4 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_balanced_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_balanced_on_level_G_omega3_avx512,
    },
};
