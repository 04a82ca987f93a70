/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 9   29    0    2    0    0     10    6   (47)
 *  jacobian            27   76    0   17    0    0     11   14   (180)
 *  rhs_jacobian        32   83    0   18    0    0     11   22   (205)
 *  divergence          5   13    0    1    0    0      8    6   (23)
 *  integral_values     7   28    0    1    0    0     13    6   (39)
 *  integral_gradients  10   37    0    7    0    0     11    8   (72)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          1    4    0    1    0    0      5    3   (7)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_avx512;

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
    const double t2 = p[1]*p[5]; /* R*I3 */
    const double t3 = x[4]*t2; /* s*R*I3 */
    const double t4 = t2*x[0]; /* R*I3*gamma3 */
    const double t5 = t4*x[3]; /* R*I3*gamma3*omega3 */
    const double t6 = p[6] + t5; /* G_level + R*I3*gamma3*omega3 */
    const double t7 = t6/t3; /* omega_n = (G_level + R*I3*gamma3*omega3)/(s*R*I3) */
    const double t8 = p[1]*t7; /* R*omega_n */
    const double t9 = x[3]*t8; /* omega3*R*omega_n */
    const double t10 = x[4]*t9; /* s*omega3*R*omega_n */
    const double t11 = p[1]*x[0]; /* R*gamma3 */
    const double t12 = t7*t7; /* omega_n*omega_n */
    const double t13 = t11*t12; /* R*gamma3*omega_n*omega_n */
    const double t14 = t10 + t13; /* s*omega3*R*omega_n + R*gamma3*omega_n*omega_n */
    const double t15 = x[0]*t12; /* gamma3*omega_n*omega_n */
    const double t16 = -t15; /* -gamma3*omega_n*omega_n */
    const double t17 = x[3]*t7; /* omega3*omega_n */
    const double t18 = x[4]*t17; /* s*omega3*omega_n */
    const double t19 = t16 - t18; /* -gamma3*omega_n*omega_n - s*omega3*omega_n */
    const double t20 = p[1]*p[0]; /* R*m */
    const double t21 = p[5]*t20; /* I3*R*m */
    const double t22 = t7*t21; /* omega_n*I3*R*m */
    const double t23 = x[4]*t22; /* s*omega_n*I3*R*m */
    const double t24 = p[1]*p[1]; /* R*R */
    const double t25 = p[0]*t24; /* m*R*R */
    const double t26 = p[5]*t25; /* I3*m*R*R */
    const double t27 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t28 = t26*t27; /* I3*m*R*R*gamma3*gamma3 */
    const double t29 = t28 + p[7]; /* I3*m*R*R*gamma3*gamma3 + I3^2 */
    const double t30 = t0*t26; /* s*s*I3*m*R*R */
    const double t31 = t29 + t30; /* Theta = I3*m*R*R*gamma3*gamma3 + I3^2 + s*s*I3*m*R*R */
    const double t32 = x[2]*p[1]; /* omega_tau*R */
    const double t33 = x[1] + t32; /* V = v_nu + omega_tau*R */
    const double t34 = t23*t33; /* s*omega_n*I3*R*m*V */
    const double t35 = t34/t31; /* s*omega_n*I3*R*m*V/Theta */
    const double t36 = -t35; /* -s*omega_n*I3*R*m*V/Theta */
    const double t37 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t38 = x[4]*t37; /* s*omega_tau*gamma3 */
    const double t39 = -t38; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t14;
    out[2] = t19;
    out[3] = t36;
    out[4] = t39;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[4]*t1; /* s*2*omega_tau */
    const double t3 = p[1]*p[5]; /* R*I3 */
    const double t4 = x[4]*t3; /* s*R*I3 */
    const double t5 = t3*x[0]; /* R*I3*gamma3 */
    const double t6 = t5*x[3]; /* R*I3*gamma3*omega3 */
    const double t7 = p[6] + t6; /* G_level + R*I3*gamma3*omega3 */
    const double t8 = t7/t4; /* omega_n = (G_level + R*I3*gamma3*omega3)/(s*R*I3) */
    const double t9 = t8*t8; /* omega_n*omega_n */
    const double t10 = p[1]*t9; /* R*omega_n*omega_n */
    const double t11 = x[3]*x[3]; /* omega3*omega3 */
    const double t12 = p[1]*t11; /* R*omega3*omega3 */
    const double t13 = t10 + t12; /* R*omega_n*omega_n + R*omega3*omega3 */
    const double t14 = p[1]*x[0]; /* R*gamma3 */
    const double t15 = t8*t14; /* omega_n*R*gamma3 */
    const double t16 = x[3]*t15; /* omega3*omega_n*R*gamma3 */
    const double t17 = t16/x[4]; /* omega3*omega_n*R*gamma3/s */
    const double t18 = 2.0*t17; /* 2*omega3*omega_n*R*gamma3/s */
    const double t19 = t13 + t18; /* R*omega_n*omega_n + R*omega3*omega3 + 2*omega3*omega_n*R*gamma3/s */
    const double t20 = p[1]*t8; /* R*omega_n */
    const double t21 = x[4]*t20; /* s*R*omega_n */
    const double t22 = x[3]*t14; /* omega3*R*gamma3 */
    const double t23 = t21 + t22; /* s*R*omega_n + omega3*R*gamma3 */
    const double t24 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t25 = p[1]*t24; /* R*gamma3*gamma3 */
    const double t26 = t8*t25; /* omega_n*R*gamma3*gamma3 */
    const double t27 = t26/x[4]; /* omega_n*R*gamma3*gamma3/s */
    const double t28 = 2.0*t27; /* 2*omega_n*R*gamma3*gamma3/s */
    const double t29 = t23 + t28; /* s*R*omega_n + omega3*R*gamma3 + 2*omega_n*R*gamma3*gamma3/s */
    const double t30 = x[3]*t20; /* omega3*R*omega_n */
    const double t31 = x[4]*p[5]; /* s*I3 */
    const double t32 = x[3]*t7; /* omega3*(G_level + R*I3*gamma3*omega3) */
    const double t33 = t32/t31; /* omega3*(G_level + R*I3*gamma3*omega3)/(s*I3) */
    const double t34 = t30 - t33; /* omega3*R*omega_n - omega3*(G_level + R*I3*gamma3*omega3)/(s*I3) */
    const double t35 = x[0]*t8; /* gamma3*omega_n */
    const double t36 = t0*p[5]; /* s*s*I3 */
    const double t37 = t7*t35; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n */
    const double t38 = t37/t36; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I3) */
    const double t39 = 2.0*t38; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I3) */
    const double t40 = t34 - t39; /* t34 - 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I3) */
    const double t41 = -t9; /* -omega_n*omega_n */
    const double t42 = x[3]*t35; /* omega3*gamma3*omega_n */
    const double t43 = t42/x[4]; /* omega3*gamma3*omega_n/s */
    const double t44 = 2.0*t43; /* 2*omega3*gamma3*omega_n/s */
    const double t45 = t41 - t44; /* -omega_n*omega_n - 2*omega3*gamma3*omega_n/s */
    const double t46 = t45 - t11; /* -omega_n*omega_n - 2*omega3*gamma3*omega_n/s - omega3*omega3 */
    const double t47 = x[0]*x[3]; /* gamma3*omega3 */
    const double t48 = -t47; /* -gamma3*omega3 */
    const double t49 = x[4]*t8; /* s*omega_n */
    const double t50 = t48 - t49; /* -gamma3*omega3 - s*omega_n */
    const double t51 = t8*t24; /* omega_n*gamma3*gamma3 */
    const double t52 = t51/x[4]; /* omega_n*gamma3*gamma3/s */
    const double t53 = 2.0*t52; /* 2*omega_n*gamma3*gamma3/s */
    const double t54 = t50 - t53; /* -gamma3*omega3 - s*omega_n - 2*omega_n*gamma3*gamma3/s */
    const double t55 = x[3]*t8; /* omega3*omega_n */
    const double t56 = t0*t3; /* s*s*R*I3 */
    const double t57 = t37/t56; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I3) */
    const double t58 = 2.0*t57; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I3) */
    const double t59 = t58 - t55; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I3) - omega3*omega_n */
    const double t60 = t32/t4; /* omega3*(G_level + R*I3*gamma3*omega3)/(s*R*I3) */
    const double t61 = t59 + t60; /* t59 + omega3*(G_level + R*I3*gamma3*omega3)/(s*R*I3) */
    const double t62 = p[1]*p[0]; /* R*m */
    const double t63 = p[5]*t62; /* I3*R*m */
    const double t64 = x[3]*t63; /* omega3*I3*R*m */
    const double t65 = p[1]*p[1]; /* R*R */
    const double t66 = p[0]*t65; /* m*R*R */
    const double t67 = p[5]*t66; /* I3*m*R*R */
    const double t68 = t24*t67; /* gamma3*gamma3*I3*m*R*R */
    const double t69 = t68 + p[7]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t70 = t0*t67; /* s*s*I3*m*R*R */
    const double t71 = t69 + t70; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + s*s*I3*m*R*R */
    const double t72 = x[2]*p[1]; /* omega_tau*R */
    const double t73 = x[1] + t72; /* V = v_nu + omega_tau*R */
    const double t74 = t64*t73; /* omega3*I3*R*m*V */
    const double t75 = t74/t71; /* omega3*I3*R*m*V/Theta */
    const double t76 = p[0]*p[0]; /* m*m */
    const double t77 = p[1]*t65; /* R*R*R */
    const double t78 = t76*t77; /* m*m*R*R*R */
    const double t79 = p[5]*p[5]; /* I3*I3 */
    const double t80 = t78*t79; /* m*m*R*R*R*I3*I3 */
    const double t81 = x[0]*t80; /* gamma3*m*m*R*R*R*I3*I3 */
    const double t82 = t8*t81; /* omega_n*gamma3*m*m*R*R*R*I3*I3 */
    const double t83 = x[4]*t82; /* s*omega_n*gamma3*m*m*R*R*R*I3*I3 */
    const double t84 = t71*t71; /* Theta*Theta */
    const double t85 = t73*t83; /* V*s*omega_n*gamma3*m*m*R*R*R*I3*I3 */
    const double t86 = t85/t84; /* V*s*omega_n*gamma3*m*m*R*R*R*I3*I3/(Theta*Theta) */
    const double t87 = 2.0*t86; /* 2*V*s*omega_n*gamma3*m*m*R*R*R*I3*I3/(Theta*Theta) */
    const double t88 = t87 - t75; /* 2*V*s*omega_n*gamma3*m*m*R*R*R*I3*I3/(Theta*Theta) - omega3*I3*R*m*V/Theta */
    const double t89 = t8*t63; /* omega_n*I3*R*m */
    const double t90 = x[4]*t89; /* s*omega_n*I3*R*m */
    const double t91 = t90/t71; /* s*omega_n*I3*R*m/Theta */
    const double t92 = -t91; /* -s*omega_n*I3*R*m/Theta */
    const double t93 = t8*t67; /* omega_n*I3*m*R*R */
    const double t94 = x[4]*t93; /* s*omega_n*I3*m*R*R */
    const double t95 = t94/t71; /* s*omega_n*I3*m*R*R/Theta */
    const double t96 = -t95; /* -s*omega_n*I3*m*R*R/Theta */
    const double t97 = x[0]*t63; /* gamma3*I3*R*m */
    const double t98 = t73*t97; /* V*gamma3*I3*R*m */
    const double t99 = t98/t71; /* V*gamma3*I3*R*m/Theta */
    const double t100 = -t99; /* -V*gamma3*I3*R*m/Theta */
    const double t101 = t73*t89; /* V*omega_n*I3*R*m */
    const double t102 = t101/t71; /* V*omega_n*I3*R*m/Theta */
    const double t103 = x[4]*t71; /* s*Theta */
    const double t104 = p[0]*t73; /* m*V */
    const double t105 = t7*t104; /* (G_level + R*I3*gamma3*omega3)*m*V */
    const double t106 = t105/t103; /* (G_level + R*I3*gamma3*omega3)*m*V/(s*Theta) */
    const double t107 = t106 - t102; /* (G_level + R*I3*gamma3*omega3)*m*V/(s*Theta) - V*omega_n*I3*R*m/Theta */
    const double t108 = t8*t80; /* omega_n*m*m*R*R*R*I3*I3 */
    const double t109 = t0*t108; /* s*s*omega_n*m*m*R*R*R*I3*I3 */
    const double t110 = t73*t109; /* V*s*s*omega_n*m*m*R*R*R*I3*I3 */
    const double t111 = t110/t84; /* V*s*s*omega_n*m*m*R*R*R*I3*I3/(Theta*Theta) */
    const double t112 = 2.0*t111; /* 2*V*s*s*omega_n*m*m*R*R*R*I3*I3/(Theta*Theta) */
    const double t113 = t107 + t112; /* t107 + 2*V*s*s*omega_n*m*m*R*R*R*I3*I3/(Theta*Theta) */
    const double t114 = x[4]*x[2]; /* s*omega_tau */
    const double t115 = -t114; /* -s*omega_tau */
    const double t116 = x[4]*x[0]; /* s*gamma3 */
    const double t117 = -t116; /* -s*gamma3 */
    const double t118 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t119 = -t118; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t19;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t29;
    out[9] = t40;
    out[10] = t46;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t54;
    out[14] = t61;
    out[15] = t88;
    out[16] = t92;
    out[17] = t96;
    out[18] = t100;
    out[19] = t113;
    out[20] = t115;
    out[21] = 0.0;
    out[22] = t117;
    out[23] = 0.0;
    out[24] = t119;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[5]; /* R*I3 */
    const double t3 = x[4]*t2; /* s*R*I3 */
    const double t4 = t2*x[0]; /* R*I3*gamma3 */
    const double t5 = t4*x[3]; /* R*I3*gamma3*omega3 */
    const double t6 = p[6] + t5; /* G_level + R*I3*gamma3*omega3 */
    const double t7 = t6/t3; /* omega_n = (G_level + R*I3*gamma3*omega3)/(s*R*I3) */
    const double t8 = p[1]*t7; /* R*omega_n */
    const double t9 = x[3]*t8; /* omega3*R*omega_n */
    const double t10 = x[4]*t9; /* s*omega3*R*omega_n */
    const double t11 = p[1]*x[0]; /* R*gamma3 */
    const double t12 = t7*t7; /* omega_n*omega_n */
    const double t13 = t11*t12; /* R*gamma3*omega_n*omega_n */
    const double t14 = t10 + t13; /* s*omega3*R*omega_n + R*gamma3*omega_n*omega_n */
    const double t15 = x[0]*t12; /* gamma3*omega_n*omega_n */
    const double t16 = -t15; /* -gamma3*omega_n*omega_n */
    const double t17 = x[3]*t7; /* omega3*omega_n */
    const double t18 = x[4]*t17; /* s*omega3*omega_n */
    const double t19 = t16 - t18; /* -gamma3*omega_n*omega_n - s*omega3*omega_n */
    const double t20 = p[1]*p[0]; /* R*m */
    const double t21 = p[5]*t20; /* I3*R*m */
    const double t22 = t7*t21; /* omega_n*I3*R*m */
    const double t23 = x[4]*t22; /* s*omega_n*I3*R*m */
    const double t24 = p[1]*p[1]; /* R*R */
    const double t25 = p[0]*t24; /* m*R*R */
    const double t26 = p[5]*t25; /* I3*m*R*R */
    const double t27 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t28 = t26*t27; /* I3*m*R*R*gamma3*gamma3 */
    const double t29 = t28 + p[7]; /* I3*m*R*R*gamma3*gamma3 + I3^2 */
    const double t30 = t0*t26; /* s*s*I3*m*R*R */
    const double t31 = t29 + t30; /* Theta = I3*m*R*R*gamma3*gamma3 + I3^2 + s*s*I3*m*R*R */
    const double t32 = x[2]*p[1]; /* omega_tau*R */
    const double t33 = x[1] + t32; /* V = v_nu + omega_tau*R */
    const double t34 = t23*t33; /* s*omega_n*I3*R*m*V */
    const double t35 = t34/t31; /* s*omega_n*I3*R*m*V/Theta */
    const double t36 = -t35; /* -s*omega_n*I3*R*m*V/Theta */
    const double t37 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t38 = -t37; /* -omega_tau*gamma3 */
    const double t39 = x[4]*t37; /* s*omega_tau*gamma3 */
    const double t40 = -t39; /* -s*omega_tau*gamma3 */
    const double t41 = x[2]*2.0; /* omega_tau*2 */
    const double t42 = x[4]*t41; /* s*omega_tau*2 */
    const double t43 = p[1]*t12; /* R*omega_n*omega_n */
    const double t44 = x[3]*x[3]; /* omega3*omega3 */
    const double t45 = p[1]*t44; /* R*omega3*omega3 */
    const double t46 = t43 + t45; /* R*omega_n*omega_n + R*omega3*omega3 */
    const double t47 = t7*t11; /* omega_n*R*gamma3 */
    const double t48 = x[3]*t47; /* omega3*omega_n*R*gamma3 */
    const double t49 = t48/x[4]; /* omega3*omega_n*R*gamma3/s */
    const double t50 = 2.0*t49; /* 2*omega3*omega_n*R*gamma3/s */
    const double t51 = t46 + t50; /* R*omega_n*omega_n + R*omega3*omega3 + 2*omega3*omega_n*R*gamma3/s */
    const double t52 = x[4]*t8; /* s*R*omega_n */
    const double t53 = x[3]*t11; /* omega3*R*gamma3 */
    const double t54 = t52 + t53; /* s*R*omega_n + omega3*R*gamma3 */
    const double t55 = p[1]*t27; /* R*gamma3*gamma3 */
    const double t56 = t7*t55; /* omega_n*R*gamma3*gamma3 */
    const double t57 = t56/x[4]; /* omega_n*R*gamma3*gamma3/s */
    const double t58 = 2.0*t57; /* 2*omega_n*R*gamma3*gamma3/s */
    const double t59 = t54 + t58; /* s*R*omega_n + omega3*R*gamma3 + 2*omega_n*R*gamma3*gamma3/s */
    const double t60 = x[4]*p[5]; /* s*I3 */
    const double t61 = x[3]*t6; /* omega3*(G_level + R*I3*gamma3*omega3) */
    const double t62 = t61/t60; /* omega3*(G_level + R*I3*gamma3*omega3)/(s*I3) */
    const double t63 = t9 - t62; /* omega3*R*omega_n - omega3*(G_level + R*I3*gamma3*omega3)/(s*I3) */
    const double t64 = x[0]*t7; /* gamma3*omega_n */
    const double t65 = t0*p[5]; /* s*s*I3 */
    const double t66 = t6*t64; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n */
    const double t67 = t66/t65; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I3) */
    const double t68 = 2.0*t67; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I3) */
    const double t69 = t63 - t68; /* t63 - 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*I3) */
    const double t70 = -t12; /* -omega_n*omega_n */
    const double t71 = x[3]*t64; /* omega3*gamma3*omega_n */
    const double t72 = t71/x[4]; /* omega3*gamma3*omega_n/s */
    const double t73 = 2.0*t72; /* 2*omega3*gamma3*omega_n/s */
    const double t74 = t70 - t73; /* -omega_n*omega_n - 2*omega3*gamma3*omega_n/s */
    const double t75 = t74 - t44; /* -omega_n*omega_n - 2*omega3*gamma3*omega_n/s - omega3*omega3 */
    const double t76 = x[0]*x[3]; /* gamma3*omega3 */
    const double t77 = -t76; /* -gamma3*omega3 */
    const double t78 = x[4]*t7; /* s*omega_n */
    const double t79 = t77 - t78; /* -gamma3*omega3 - s*omega_n */
    const double t80 = t7*t27; /* omega_n*gamma3*gamma3 */
    const double t81 = t80/x[4]; /* omega_n*gamma3*gamma3/s */
    const double t82 = 2.0*t81; /* 2*omega_n*gamma3*gamma3/s */
    const double t83 = t79 - t82; /* -gamma3*omega3 - s*omega_n - 2*omega_n*gamma3*gamma3/s */
    const double t84 = t0*t2; /* s*s*R*I3 */
    const double t85 = t66/t84; /* (G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I3) */
    const double t86 = 2.0*t85; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I3) */
    const double t87 = t86 - t17; /* 2*(G_level + R*I3*gamma3*omega3)*gamma3*omega_n/(s*s*R*I3) - omega3*omega_n */
    const double t88 = t61/t3; /* omega3*(G_level + R*I3*gamma3*omega3)/(s*R*I3) */
    const double t89 = t87 + t88; /* t87 + omega3*(G_level + R*I3*gamma3*omega3)/(s*R*I3) */
    const double t90 = x[3]*t21; /* omega3*I3*R*m */
    const double t91 = t33*t90; /* V*omega3*I3*R*m */
    const double t92 = t91/t31; /* V*omega3*I3*R*m/Theta */
    const double t93 = p[0]*p[0]; /* m*m */
    const double t94 = p[1]*t24; /* R*R*R */
    const double t95 = t93*t94; /* m*m*R*R*R */
    const double t96 = p[5]*p[5]; /* I3*I3 */
    const double t97 = t95*t96; /* m*m*R*R*R*I3*I3 */
    const double t98 = x[0]*t97; /* gamma3*m*m*R*R*R*I3*I3 */
    const double t99 = t7*t98; /* omega_n*gamma3*m*m*R*R*R*I3*I3 */
    const double t100 = x[4]*t99; /* s*omega_n*gamma3*m*m*R*R*R*I3*I3 */
    const double t101 = t31*t31; /* Theta*Theta */
    const double t102 = t33*t100; /* V*s*omega_n*gamma3*m*m*R*R*R*I3*I3 */
    const double t103 = t102/t101; /* V*s*omega_n*gamma3*m*m*R*R*R*I3*I3/(Theta*Theta) */
    const double t104 = 2.0*t103; /* 2*V*s*omega_n*gamma3*m*m*R*R*R*I3*I3/(Theta*Theta) */
    const double t105 = t104 - t92; /* 2*V*s*omega_n*gamma3*m*m*R*R*R*I3*I3/(Theta*Theta) - V*omega3*I3*R*m/Theta */
    const double t106 = t23/t31; /* s*omega_n*I3*R*m/Theta */
    const double t107 = -t106; /* -s*omega_n*I3*R*m/Theta */
    const double t108 = t7*t26; /* omega_n*I3*m*R*R */
    const double t109 = x[4]*t108; /* s*omega_n*I3*m*R*R */
    const double t110 = t109/t31; /* s*omega_n*I3*m*R*R/Theta */
    const double t111 = -t110; /* -s*omega_n*I3*m*R*R/Theta */
    const double t112 = x[0]*t21; /* gamma3*I3*R*m */
    const double t113 = t33*t112; /* V*gamma3*I3*R*m */
    const double t114 = t113/t31; /* V*gamma3*I3*R*m/Theta */
    const double t115 = -t114; /* -V*gamma3*I3*R*m/Theta */
    const double t116 = t22*t33; /* omega_n*I3*R*m*V */
    const double t117 = t116/t31; /* omega_n*I3*R*m*V/Theta */
    const double t118 = x[4]*t31; /* s*Theta */
    const double t119 = p[0]*t33; /* m*V */
    const double t120 = t6*t119; /* (G_level + R*I3*gamma3*omega3)*m*V */
    const double t121 = t120/t118; /* (G_level + R*I3*gamma3*omega3)*m*V/(s*Theta) */
    const double t122 = t121 - t117; /* (G_level + R*I3*gamma3*omega3)*m*V/(s*Theta) - omega_n*I3*R*m*V/Theta */
    const double t123 = t7*t97; /* omega_n*m*m*R*R*R*I3*I3 */
    const double t124 = t0*t123; /* s*s*omega_n*m*m*R*R*R*I3*I3 */
    const double t125 = t33*t124; /* V*s*s*omega_n*m*m*R*R*R*I3*I3 */
    const double t126 = t125/t101; /* V*s*s*omega_n*m*m*R*R*R*I3*I3/(Theta*Theta) */
    const double t127 = 2.0*t126; /* 2*V*s*s*omega_n*m*m*R*R*R*I3*I3/(Theta*Theta) */
    const double t128 = t122 + t127; /* t122 + 2*V*s*s*omega_n*m*m*R*R*R*I3*I3/(Theta*Theta) */
    const double t129 = x[2]*x[4]; /* omega_tau*s */
    const double t130 = -t129; /* -omega_tau*s */
    const double t131 = x[4]*x[0]; /* s*gamma3 */
    const double t132 = -t131; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t14;
    out[2] = t19;
    out[3] = t36;
    out[4] = t40;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t42;
    out[10] = t51;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t59;
    out[14] = t69;
    out[15] = t75;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t83;
    out[19] = t89;
    out[20] = t105;
    out[21] = t107;
    out[22] = t111;
    out[23] = t115;
    out[24] = t128;
    out[25] = t130;
    out[26] = 0.0;
    out[27] = t132;
    out[28] = 0.0;
    out[29] = t38;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = -t0; /* -gamma3*omega_tau */
    const double t2 = p[0]*p[1]; /* m*R */
    const double t3 = t2*p[5]; /* m*R*I3 */
    const double t4 = x[0]*t3; /* gamma3*m*R*I3 */
    const double t5 = p[1]*p[1]; /* R*R */
    const double t6 = p[0]*t5; /* m*R*R */
    const double t7 = p[5]*t6; /* I3*m*R*R */
    const double t8 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t9 = t7*t8; /* I3*m*R*R*gamma3*gamma3 */
    const double t10 = t9 + p[7]; /* I3*m*R*R*gamma3*gamma3 + I3^2 */
    const double t11 = x[4]*x[4]; /* s*s */
    const double t12 = t7*t11; /* I3*m*R*R*s*s */
    const double t13 = t10 + t12; /* Theta = I3*m*R*R*gamma3*gamma3 + I3^2 + I3*m*R*R*s*s */
    const double t14 = x[2]*p[1]; /* omega_tau*R */
    const double t15 = x[1] + t14; /* V = v_nu + omega_tau*R */
    const double t16 = t4*t15; /* gamma3*m*R*I3*V */
    const double t17 = t16/t13; /* gamma3*m*R*I3*V/Theta */
    const double t18 = t1 - t17; /* -gamma3*omega_tau - gamma3*m*R*I3*V/Theta */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[0]*t0; /* m*v_nu*v_nu */
    const double t2 = t1*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t3 = x[3]*x[3]; /* omega3*omega3 */
    const double t4 = p[5]*t3; /* I3*omega3*omega3 */
    const double t5 = (1.0 / 2.0)*t4; /* 1/2*I3*omega3*omega3 */
    const double t6 = t2 + t5; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 */
    const double t7 = x[3]*p[1]; /* omega3*R */
    const double t8 = t7*x[4]; /* omega3*R*s */
    const double t9 = p[1]*x[0]; /* R*gamma3 */
    const double t10 = p[5]*p[1]; /* I3*R */
    const double t11 = x[4]*t10; /* s*I3*R */
    const double t12 = x[0]*t10; /* gamma3*I3*R */
    const double t13 = x[3]*t12; /* omega3*gamma3*I3*R */
    const double t14 = p[6] + t13; /* G_level + omega3*gamma3*I3*R */
    const double t15 = t14/t11; /* omega_n = (G_level + omega3*gamma3*I3*R)/(s*I3*R) */
    const double t16 = t9*t15; /* R*gamma3*omega_n */
    const double t17 = t8 + t16; /* v_tau = omega3*R*s + R*gamma3*omega_n */
    const double t18 = t17*t17; /* v_tau*v_tau */
    const double t19 = p[0]*t18; /* m*v_tau*v_tau */
    const double t20 = (1.0 / 2.0)*t19; /* 1/2*m*v_tau*v_tau */
    const double t21 = t6 + t20; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    const double t22 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t23 = p[5]*t22; /* I3*omega_tau*omega_tau */
    const double t24 = (1.0 / 2.0)*t23; /* 1/2*I3*omega_tau*omega_tau */
    const double t25 = t21 + t24; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau + 1/2*I3*omega_tau*omega_tau */
    const double t26 = t15*t15; /* omega_n*omega_n */
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
    const double t0 = p[5]*p[1]; /* I3*R */
    const double t1 = t0*x[4]; /* I3*R*s */
    const double t2 = t0*x[0]; /* I3*R*gamma3 */
    const double t3 = t2*x[3]; /* I3*R*gamma3*omega3 */
    const double t4 = p[6] + t3; /* G_level + I3*R*gamma3*omega3 */
    const double t5 = t4/t1; /* omega_n = (G_level + I3*R*gamma3*omega3)/(I3*R*s) */
    const double t6 = p[5]*t5; /* I3*omega_n */
    const double t7 = x[3]*t6; /* omega3*I3*omega_n */
    const double t8 = t7/x[4]; /* omega3*I3*omega_n/s */
    const double t9 = p[1]*x[3]; /* R*omega3 */
    const double t10 = x[4]*t9; /* s*R*omega3 */
    const double t11 = p[1]*x[0]; /* R*gamma3 */
    const double t12 = t5*t11; /* omega_n*R*gamma3 */
    const double t13 = t10 + t12; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t14 = p[0]*t13; /* m*v_tau */
    const double t15 = p[1]*t5; /* R*omega_n */
    const double t16 = x[3]*t11; /* omega3*R*gamma3 */
    const double t17 = t16/x[4]; /* omega3*R*gamma3/s */
    const double t18 = t15 + t17; /* d(v_tau)/d(gamma3) = R*omega_n + omega3*R*gamma3/s */
    const double t19 = t14*t18; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t20 = t8 + t19; /* d(energy)/d(gamma3) = omega3*I3*omega_n/s + m*v_tau*d(v_tau)/d(gamma3) */
    const double t21 = p[0]*x[1]; /* m*v_nu */
    const double t22 = p[5]*x[2]; /* I3*omega_tau */
    const double t23 = p[5]*x[3]; /* I3*omega3 */
    const double t24 = p[1]*x[4]; /* R*s */
    const double t25 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t26 = p[1]*t25; /* R*gamma3*gamma3 */
    const double t27 = t26/x[4]; /* R*gamma3*gamma3/s */
    const double t28 = t24 + t27; /* d(v_tau)/d(omega3) = R*s + R*gamma3*gamma3/s */
    const double t29 = t14*t28; /* m*v_tau*d(v_tau)/d(omega3) */
    const double t30 = t23 + t29; /* I3*omega3 + m*v_tau*d(v_tau)/d(omega3) */
    const double t31 = p[5]*x[0]; /* I3*gamma3 */
    const double t32 = t5*t31; /* omega_n*I3*gamma3 */
    const double t33 = t32/x[4]; /* omega_n*I3*gamma3/s */
    const double t34 = t30 + t33; /* d(energy)/d(omega3) = I3*omega3 + m*v_tau*d(v_tau)/d(omega3) + omega_n*I3*gamma3/s */
    const double t35 = x[4]*x[4]; /* s*s */
    const double t36 = p[5]*t35; /* I3*s*s */
    const double t37 = x[0]*t4; /* gamma3*(G_level + I3*R*gamma3*omega3) */
    const double t38 = t37/t36; /* gamma3*(G_level + I3*R*gamma3*omega3)/(I3*s*s) */
    const double t39 = t9 - t38; /* d(v_tau)/d(s) = R*omega3 - gamma3*(G_level + I3*R*gamma3*omega3)/(I3*s*s) */
    const double t40 = t14*t39; /* m*v_tau*d(v_tau)/d(s) */
    const double t41 = p[1]*t35; /* R*s*s */
    const double t42 = t4*t5; /* (G_level + I3*R*gamma3*omega3)*omega_n */
    const double t43 = t42/t41; /* (G_level + I3*R*gamma3*omega3)*omega_n/(R*s*s) */
    const double t44 = t40 - t43; /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) - (G_level + I3*R*gamma3*omega3)*omega_n/(R*s*s) */
    const double t45 = p[0]*2.0; /* m*2 */
    const double t46 = p[5]*p[5]; /* I3*I3 */
    const double t47 = t45*t46; /* m*2*I3*I3 */
    const double t48 = p[1]*x[2]; /* R*omega_tau */
    const double t49 = x[1] + t48; /* v_nu + R*omega_tau */
    const double t50 = t47*t49; /* m*2*I3*I3*(v_nu + R*omega_tau) */
    const double t51 = p[1]*t45; /* R*m*2 */
    const double t52 = t46*t51; /* I3*I3*R*m*2 */
    const double t53 = t49*t52; /* (v_nu + R*omega_tau)*I3*I3*R*m*2 */
    out[0] = t20;
    out[1] = t21;
    out[2] = t22;
    out[3] = t34;
    out[4] = t44;
    out[5] = 0.0;
    out[6] = t50;
    out[7] = t53;
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
    const double t1 = t0*x[4]; /* R*I3*s */
    const double t2 = t0*x[0]; /* R*I3*gamma3 */
    const double t3 = t2*x[3]; /* R*I3*gamma3*omega3 */
    const double t4 = p[6] + t3; /* G_level + R*I3*gamma3*omega3 */
    const double t5 = t4/t1; /* omega_n = (G_level + R*I3*gamma3*omega3)/(R*I3*s) */
    out[0] = t5;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double v_R = params[1];
    const double v_I3 = params[5];
    const double v_I1 = (v_I3);
    const double v_G_level = params[6];
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
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
    out[3] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_in_regular_on_level_G = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "regular",
    .elimination = "level_G",
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
    .rhs = { rhs, 5, { 9, 29, 0, 2, 0, 0, 10, 6 }, { 9, 36, 0, 2, 0, 0, 10, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .jacobian = { jacobian, 25, { 27, 76, 0, 17, 0, 0, 11, 14 }, { 32, 131, 0, 17, 0, 0, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 32, 83, 0, 18, 0, 0, 11, 22 }, { 37, 150, 0, 18, 0, 0, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .divergence = { divergence, 1, { 5, 13, 0, 1, 0, 0, 8, 6 }, { 5, 17, 0, 1, 0, 0, 8, 6 },
        "divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are" },
    .integral_values = { integral_values, 3, { 7, 28, 0, 1, 0, 0, 13, 6 }, { 8, 30, 0, 1, 0, 0, 13, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 15, { 10, 37, 0, 7, 0, 0, 11, 8 }, { 13, 52, 0, 7, 0, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 1, 4, 0, 1, 0, 0, 5, 3 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_baseline,
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_avx2,
        &jlt_batch_spherical_top_balanced_equal_in_regular_on_level_G_avx512,
    },
};
