/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 9   24    0    4    1    0     10    7   (45)
 *  jacobian            23   47    0   18    1    0     13   12   (123)
 *  rhs_jacobian        27   53    0   21    1    0     13   19   (143)
 *  divergence          6   14    0    2    1    0      9    7   (28)
 *  integral_values     8   29    0    1    1    0     13    6   (42)
 *  integral_gradients  11   36    0    6    1    0     12   11   (68)
 *  eliminated          2    5    0    1    1    0      5    3   (10)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_avx512;

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
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[5]; /* R*I3 */
    const double t5 = t2*t4; /* s*R*I3 */
    const double t6 = x[0]*t4; /* gamma3*R*I3 */
    const double t7 = t6*x[3]; /* gamma3*R*I3*omega3 */
    const double t8 = p[6] + t7; /* G_level + gamma3*R*I3*omega3 */
    const double t9 = t8/t5; /* omega_n = (G_level + gamma3*R*I3*omega3)/(s*R*I3) */
    const double t10 = p[1]*t9; /* R*omega_n */
    const double t11 = x[3]*t10; /* omega3*R*omega_n */
    const double t12 = x[0]*p[1]; /* gamma3*R */
    const double t13 = t9*t9; /* omega_n*omega_n */
    const double t14 = t12*t13; /* gamma3*R*omega_n*omega_n */
    const double t15 = t14/t2; /* gamma3*R*omega_n*omega_n/s */
    const double t16 = t11 + t15; /* omega3*R*omega_n + gamma3*R*omega_n*omega_n/s */
    const double t17 = x[0]*t13; /* gamma3*omega_n*omega_n */
    const double t18 = t17/t2; /* gamma3*omega_n*omega_n/s */
    const double t19 = -t18; /* -gamma3*omega_n*omega_n/s */
    const double t20 = x[3]*t9; /* omega3*omega_n */
    const double t21 = t19 - t20; /* -gamma3*omega_n*omega_n/s - omega3*omega_n */
    const double t22 = p[1]*p[0]; /* R*m */
    const double t23 = p[5]*t22; /* I3*R*m */
    const double t24 = t9*t23; /* omega_n*I3*R*m */
    const double t25 = p[1]*p[1]; /* R*R */
    const double t26 = p[0]*t25; /* m*R*R */
    const double t27 = p[5]*t26; /* I3*m*R*R */
    const double t28 = t0*t27; /* gamma3*gamma3*I3*m*R*R */
    const double t29 = t28 + p[7]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t30 = t2*t2; /* s*s */
    const double t31 = t27*t30; /* I3*m*R*R*s*s */
    const double t32 = t29 + t31; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + I3*m*R*R*s*s */
    const double t33 = x[2]*p[1]; /* omega_tau*R */
    const double t34 = x[1] + t33; /* V = v_nu + omega_tau*R */
    const double t35 = t24*t34; /* omega_n*I3*R*m*V */
    const double t36 = t35/t32; /* omega_n*I3*R*m*V/Theta */
    const double t37 = -t36; /* -omega_n*I3*R*m*V/Theta */
    out[0] = t3;
    out[1] = t16;
    out[2] = t21;
    out[3] = t37;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = -t4; /* -gamma3*omega_tau/s */
    const double t6 = p[1]*p[5]; /* R*I3 */
    const double t7 = t3*t6; /* s*R*I3 */
    const double t8 = x[0]*t6; /* gamma3*R*I3 */
    const double t9 = t8*x[3]; /* gamma3*R*I3*omega3 */
    const double t10 = p[6] + t9; /* G_level + gamma3*R*I3*omega3 */
    const double t11 = t10/t7; /* omega_n = (G_level + gamma3*R*I3*omega3)/(s*R*I3) */
    const double t12 = t11*t11; /* omega_n*omega_n */
    const double t13 = p[1]*t12; /* R*omega_n*omega_n */
    const double t14 = t13/t3; /* R*omega_n*omega_n/s */
    const double t15 = p[1]*x[3]; /* R*omega3 */
    const double t16 = x[3]/t3; /* omega3/s */
    const double t17 = t3*t3; /* s*s */
    const double t18 = t3*t17; /* s*s*s */
    const double t19 = t6*t18; /* R*I3*s*s*s */
    const double t20 = x[0]*t10; /* gamma3*(G_level + gamma3*R*I3*omega3) */
    const double t21 = t20/t19; /* gamma3*(G_level + gamma3*R*I3*omega3)/(R*I3*s*s*s) */
    const double t22 = t16 + t21; /* d(omega_n)/d(gamma3) = omega3/s + gamma3*(G_level + gamma3*R*I3*omega3)/(R*I3*s*s*s) */
    const double t23 = t15*t22; /* R*omega3*d(omega_n)/d(gamma3) */
    const double t24 = t14 + t23; /* R*omega_n*omega_n/s + R*omega3*d(omega_n)/d(gamma3) */
    const double t25 = t1*p[1]; /* gamma3*gamma3*R */
    const double t26 = t12*t25; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t27 = t26/t18; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t28 = t24 + t27; /* R*omega_n*omega_n/s + R*omega3*d(omega_n)/d(gamma3) + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t29 = x[0]*p[1]; /* gamma3*R */
    const double t30 = t11*t29; /* omega_n*gamma3*R */
    const double t31 = t22*t30; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R */
    const double t32 = t31/t3; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R/s */
    const double t33 = t32*2.0; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R/s*2 */
    const double t34 = t28 + t33; /* t28 + d(omega_n)/d(gamma3)*omega_n*gamma3*R/s*2 */
    const double t35 = p[1]*t11; /* R*omega_n */
    const double t36 = x[3]*t29; /* omega3*gamma3*R */
    const double t37 = t36/t3; /* omega3*gamma3*R/s */
    const double t38 = t35 + t37; /* R*omega_n + omega3*gamma3*R/s */
    const double t39 = t11*t25; /* omega_n*gamma3*gamma3*R */
    const double t40 = t39/t17; /* omega_n*gamma3*gamma3*R/(s*s) */
    const double t41 = 2.0*t40; /* 2*omega_n*gamma3*gamma3*R/(s*s) */
    const double t42 = t38 + t41; /* R*omega_n + omega3*gamma3*R/s + 2*omega_n*gamma3*gamma3*R/(s*s) */
    const double t43 = t12/t3; /* omega_n*omega_n/s */
    const double t44 = -t43; /* -omega_n*omega_n/s */
    const double t45 = t1*t12; /* gamma3*gamma3*omega_n*omega_n */
    const double t46 = t45/t18; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t47 = t44 - t46; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t48 = x[0]*t11; /* gamma3*omega_n */
    const double t49 = t22*t48; /* d(omega_n)/d(gamma3)*gamma3*omega_n */
    const double t50 = t49/t3; /* d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t51 = 2.0*t50; /* 2*d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t52 = t47 - t51; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) - 2*d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t53 = x[3]*t22; /* omega3*d(omega_n)/d(gamma3) */
    const double t54 = t52 - t53; /* t52 - omega3*d(omega_n)/d(gamma3) */
    const double t55 = -t11; /* -omega_n */
    const double t56 = x[0]*x[3]; /* gamma3*omega3 */
    const double t57 = t56/t3; /* gamma3*omega3/s */
    const double t58 = t55 - t57; /* -omega_n - gamma3*omega3/s */
    const double t59 = t1*t11; /* gamma3*gamma3*omega_n */
    const double t60 = t59/t17; /* gamma3*gamma3*omega_n/(s*s) */
    const double t61 = 2.0*t60; /* 2*gamma3*gamma3*omega_n/(s*s) */
    const double t62 = t58 - t61; /* -omega_n - gamma3*omega3/s - 2*gamma3*gamma3*omega_n/(s*s) */
    const double t63 = p[1]*p[0]; /* R*m */
    const double t64 = p[5]*t63; /* I3*R*m */
    const double t65 = p[1]*p[1]; /* R*R */
    const double t66 = p[0]*t65; /* m*R*R */
    const double t67 = p[5]*t66; /* I3*m*R*R */
    const double t68 = t1*t67; /* gamma3*gamma3*I3*m*R*R */
    const double t69 = t68 + p[7]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t70 = t17*t67; /* s*s*I3*m*R*R */
    const double t71 = t69 + t70; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + s*s*I3*m*R*R */
    const double t72 = x[2]*p[1]; /* omega_tau*R */
    const double t73 = x[1] + t72; /* V = v_nu + omega_tau*R */
    const double t74 = t64*t73; /* I3*R*m*V */
    const double t75 = t22*t74; /* d(omega_n)/d(gamma3)*I3*R*m*V */
    const double t76 = t75/t71; /* d(omega_n)/d(gamma3)*I3*R*m*V/Theta */
    const double t77 = -t76; /* -d(omega_n)/d(gamma3)*I3*R*m*V/Theta */
    const double t78 = t11*t64; /* omega_n*I3*R*m */
    const double t79 = t78/t71; /* omega_n*I3*R*m/Theta */
    const double t80 = -t79; /* -omega_n*I3*R*m/Theta */
    const double t81 = t11*t67; /* omega_n*I3*m*R*R */
    const double t82 = t81/t71; /* omega_n*I3*m*R*R/Theta */
    const double t83 = -t82; /* -omega_n*I3*m*R*R/Theta */
    const double t84 = x[0]*t64; /* gamma3*I3*R*m */
    const double t85 = t3*t71; /* s*Theta */
    const double t86 = t73*t84; /* V*gamma3*I3*R*m */
    const double t87 = t86/t85; /* V*gamma3*I3*R*m/(s*Theta) */
    const double t88 = -t87; /* -V*gamma3*I3*R*m/(s*Theta) */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t34;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t42;
    out[8] = t54;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t62;
    out[12] = t77;
    out[13] = t80;
    out[14] = t83;
    out[15] = t88;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[5]; /* R*I3 */
    const double t5 = t2*t4; /* s*R*I3 */
    const double t6 = x[0]*t4; /* gamma3*R*I3 */
    const double t7 = t6*x[3]; /* gamma3*R*I3*omega3 */
    const double t8 = p[6] + t7; /* G_level + gamma3*R*I3*omega3 */
    const double t9 = t8/t5; /* omega_n = (G_level + gamma3*R*I3*omega3)/(s*R*I3) */
    const double t10 = p[1]*t9; /* R*omega_n */
    const double t11 = x[3]*t10; /* omega3*R*omega_n */
    const double t12 = x[0]*p[1]; /* gamma3*R */
    const double t13 = t9*t9; /* omega_n*omega_n */
    const double t14 = t12*t13; /* gamma3*R*omega_n*omega_n */
    const double t15 = t14/t2; /* gamma3*R*omega_n*omega_n/s */
    const double t16 = t11 + t15; /* omega3*R*omega_n + gamma3*R*omega_n*omega_n/s */
    const double t17 = x[0]*t13; /* gamma3*omega_n*omega_n */
    const double t18 = t17/t2; /* gamma3*omega_n*omega_n/s */
    const double t19 = -t18; /* -gamma3*omega_n*omega_n/s */
    const double t20 = x[3]*t9; /* omega3*omega_n */
    const double t21 = t19 - t20; /* -gamma3*omega_n*omega_n/s - omega3*omega_n */
    const double t22 = p[1]*p[0]; /* R*m */
    const double t23 = p[5]*t22; /* I3*R*m */
    const double t24 = t9*t23; /* omega_n*I3*R*m */
    const double t25 = p[1]*p[1]; /* R*R */
    const double t26 = p[0]*t25; /* m*R*R */
    const double t27 = p[5]*t26; /* I3*m*R*R */
    const double t28 = t0*t27; /* gamma3*gamma3*I3*m*R*R */
    const double t29 = t28 + p[7]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t30 = t2*t2; /* s*s */
    const double t31 = t27*t30; /* I3*m*R*R*s*s */
    const double t32 = t29 + t31; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + I3*m*R*R*s*s */
    const double t33 = x[2]*p[1]; /* omega_tau*R */
    const double t34 = x[1] + t33; /* V = v_nu + omega_tau*R */
    const double t35 = t24*t34; /* omega_n*I3*R*m*V */
    const double t36 = t35/t32; /* omega_n*I3*R*m*V/Theta */
    const double t37 = -t36; /* -omega_n*I3*R*m*V/Theta */
    const double t38 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t39 = t38/t2; /* omega_tau*gamma3/s */
    const double t40 = -t39; /* -omega_tau*gamma3/s */
    const double t41 = p[1]*t13; /* R*omega_n*omega_n */
    const double t42 = t41/t2; /* R*omega_n*omega_n/s */
    const double t43 = p[1]*x[3]; /* R*omega3 */
    const double t44 = x[3]/t2; /* omega3/s */
    const double t45 = t2*t30; /* s*s*s */
    const double t46 = t4*t45; /* R*I3*s*s*s */
    const double t47 = x[0]*t8; /* gamma3*(G_level + gamma3*R*I3*omega3) */
    const double t48 = t47/t46; /* gamma3*(G_level + gamma3*R*I3*omega3)/(R*I3*s*s*s) */
    const double t49 = t44 + t48; /* d(omega_n)/d(gamma3) = omega3/s + gamma3*(G_level + gamma3*R*I3*omega3)/(R*I3*s*s*s) */
    const double t50 = t43*t49; /* R*omega3*d(omega_n)/d(gamma3) */
    const double t51 = t42 + t50; /* R*omega_n*omega_n/s + R*omega3*d(omega_n)/d(gamma3) */
    const double t52 = t0*p[1]; /* gamma3*gamma3*R */
    const double t53 = t13*t52; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t54 = t53/t45; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t55 = t51 + t54; /* R*omega_n*omega_n/s + R*omega3*d(omega_n)/d(gamma3) + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t56 = t9*t12; /* omega_n*gamma3*R */
    const double t57 = t49*t56; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R */
    const double t58 = t57/t2; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R/s */
    const double t59 = t58*2.0; /* d(omega_n)/d(gamma3)*omega_n*gamma3*R/s*2 */
    const double t60 = t55 + t59; /* t55 + d(omega_n)/d(gamma3)*omega_n*gamma3*R/s*2 */
    const double t61 = x[3]*t12; /* omega3*gamma3*R */
    const double t62 = t61/t2; /* omega3*gamma3*R/s */
    const double t63 = t10 + t62; /* R*omega_n + omega3*gamma3*R/s */
    const double t64 = t9*t52; /* omega_n*gamma3*gamma3*R */
    const double t65 = t64/t30; /* omega_n*gamma3*gamma3*R/(s*s) */
    const double t66 = 2.0*t65; /* 2*omega_n*gamma3*gamma3*R/(s*s) */
    const double t67 = t63 + t66; /* R*omega_n + omega3*gamma3*R/s + 2*omega_n*gamma3*gamma3*R/(s*s) */
    const double t68 = t13/t2; /* omega_n*omega_n/s */
    const double t69 = -t68; /* -omega_n*omega_n/s */
    const double t70 = t0*t13; /* gamma3*gamma3*omega_n*omega_n */
    const double t71 = t70/t45; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t72 = t69 - t71; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t73 = x[0]*t9; /* gamma3*omega_n */
    const double t74 = t49*t73; /* d(omega_n)/d(gamma3)*gamma3*omega_n */
    const double t75 = t74/t2; /* d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t76 = 2.0*t75; /* 2*d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t77 = t72 - t76; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) - 2*d(omega_n)/d(gamma3)*gamma3*omega_n/s */
    const double t78 = x[3]*t49; /* omega3*d(omega_n)/d(gamma3) */
    const double t79 = t77 - t78; /* t77 - omega3*d(omega_n)/d(gamma3) */
    const double t80 = -t9; /* -omega_n */
    const double t81 = x[0]*x[3]; /* gamma3*omega3 */
    const double t82 = t81/t2; /* gamma3*omega3/s */
    const double t83 = t80 - t82; /* -omega_n - gamma3*omega3/s */
    const double t84 = t0*t9; /* gamma3*gamma3*omega_n */
    const double t85 = t84/t30; /* gamma3*gamma3*omega_n/(s*s) */
    const double t86 = 2.0*t85; /* 2*gamma3*gamma3*omega_n/(s*s) */
    const double t87 = t83 - t86; /* -omega_n - gamma3*omega3/s - 2*gamma3*gamma3*omega_n/(s*s) */
    const double t88 = t23*t34; /* I3*R*m*V */
    const double t89 = t49*t88; /* d(omega_n)/d(gamma3)*I3*R*m*V */
    const double t90 = t89/t32; /* d(omega_n)/d(gamma3)*I3*R*m*V/Theta */
    const double t91 = -t90; /* -d(omega_n)/d(gamma3)*I3*R*m*V/Theta */
    const double t92 = t24/t32; /* omega_n*I3*R*m/Theta */
    const double t93 = -t92; /* -omega_n*I3*R*m/Theta */
    const double t94 = t9*t27; /* omega_n*I3*m*R*R */
    const double t95 = t94/t32; /* omega_n*I3*m*R*R/Theta */
    const double t96 = -t95; /* -omega_n*I3*m*R*R/Theta */
    const double t97 = x[0]*t23; /* gamma3*I3*R*m */
    const double t98 = t2*t32; /* s*Theta */
    const double t99 = t34*t97; /* V*gamma3*I3*R*m */
    const double t100 = t99/t98; /* V*gamma3*I3*R*m/(s*Theta) */
    const double t101 = -t100; /* -V*gamma3*I3*R*m/(s*Theta) */
    out[0] = t3;
    out[1] = t16;
    out[2] = t21;
    out[3] = t37;
    out[4] = t40;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = t60;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t67;
    out[12] = t79;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t87;
    out[16] = t91;
    out[17] = t93;
    out[18] = t96;
    out[19] = t101;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = -t4; /* -gamma3*omega_tau/s */
    const double t6 = p[0]*p[1]; /* m*R */
    const double t7 = t6*p[5]; /* m*R*I3 */
    const double t8 = x[0]*t7; /* gamma3*m*R*I3 */
    const double t9 = p[1]*p[1]; /* R*R */
    const double t10 = p[0]*t9; /* m*R*R */
    const double t11 = p[5]*t10; /* I3*m*R*R */
    const double t12 = t1*t11; /* gamma3*gamma3*I3*m*R*R */
    const double t13 = t12 + p[7]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t14 = t3*t3; /* s*s */
    const double t15 = t11*t14; /* I3*m*R*R*s*s */
    const double t16 = t13 + t15; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + I3*m*R*R*s*s */
    const double t17 = t3*t16; /* s*Theta */
    const double t18 = x[2]*p[1]; /* omega_tau*R */
    const double t19 = x[1] + t18; /* V = v_nu + omega_tau*R */
    const double t20 = t8*t19; /* gamma3*m*R*I3*V */
    const double t21 = t20/t17; /* gamma3*m*R*I3*V/(s*Theta) */
    const double t22 = t5 - t21; /* -gamma3*omega_tau/s - gamma3*m*R*I3*V/(s*Theta) */
    out[0] = t22;
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
    const double t8 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t9 = 1.0 - t8; /* 1 - gamma3*gamma3 */
    const double t10 = sqrt(t9); /* s = sqrt(1 - gamma3*gamma3) */
    const double t11 = t7*t10; /* omega3*R*s */
    const double t12 = p[1]*x[0]; /* R*gamma3 */
    const double t13 = p[5]*p[1]; /* I3*R */
    const double t14 = t10*t13; /* s*I3*R */
    const double t15 = x[0]*t13; /* gamma3*I3*R */
    const double t16 = x[3]*t15; /* omega3*gamma3*I3*R */
    const double t17 = p[6] + t16; /* G_level + omega3*gamma3*I3*R */
    const double t18 = t17/t14; /* omega_n = (G_level + omega3*gamma3*I3*R)/(s*I3*R) */
    const double t19 = t12*t18; /* R*gamma3*omega_n */
    const double t20 = t11 + t19; /* v_tau = omega3*R*s + R*gamma3*omega_n */
    const double t21 = t20*t20; /* v_tau*v_tau */
    const double t22 = p[0]*t21; /* m*v_tau*v_tau */
    const double t23 = (1.0 / 2.0)*t22; /* 1/2*m*v_tau*v_tau */
    const double t24 = t6 + t23; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    const double t25 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t26 = p[5]*t25; /* I3*omega_tau*omega_tau */
    const double t27 = (1.0 / 2.0)*t26; /* 1/2*I3*omega_tau*omega_tau */
    const double t28 = t24 + t27; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau + 1/2*I3*omega_tau*omega_tau */
    const double t29 = t18*t18; /* omega_n*omega_n */
    const double t30 = p[5]*t29; /* I3*omega_n*omega_n */
    const double t31 = (1.0 / 2.0)*t30; /* 1/2*I3*omega_n*omega_n */
    const double t32 = t28 + t31; /* energy = t28 + 1/2*I3*omega_n*omega_n */
    const double t33 = p[5]*p[5]; /* I3*I3 */
    const double t34 = p[0]*t33; /* m*I3*I3 */
    const double t35 = p[1]*x[2]; /* R*omega_tau */
    const double t36 = x[1] + t35; /* v_nu + R*omega_tau */
    const double t37 = t36*t36; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t38 = t34*t37; /* m*I3*I3*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    out[0] = t32;
    out[1] = t38;
    out[2] = t36;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*x[3]; /* R*omega3 */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0*t3; /* R*omega3*s */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = p[1]*p[5]; /* R*I3 */
    const double t7 = t3*t6; /* s*R*I3 */
    const double t8 = x[0]*t6; /* gamma3*R*I3 */
    const double t9 = x[3]*t8; /* omega3*gamma3*R*I3 */
    const double t10 = p[6] + t9; /* G_level + omega3*gamma3*R*I3 */
    const double t11 = t10/t7; /* omega_n = (G_level + omega3*gamma3*R*I3)/(s*R*I3) */
    const double t12 = t5*t11; /* R*gamma3*omega_n */
    const double t13 = t4 + t12; /* v_tau = R*omega3*s + R*gamma3*omega_n */
    const double t14 = p[0]*t13; /* m*v_tau */
    const double t15 = p[1]*t11; /* R*omega_n */
    const double t16 = x[3]*t5; /* omega3*R*gamma3 */
    const double t17 = t16/t3; /* omega3*R*gamma3/s */
    const double t18 = t15 - t17; /* R*omega_n - omega3*R*gamma3/s */
    const double t19 = x[3]/t3; /* omega3/s */
    const double t20 = t3*t3; /* s*s */
    const double t21 = t3*t20; /* s*s*s */
    const double t22 = t6*t21; /* R*I3*s*s*s */
    const double t23 = x[0]*t10; /* gamma3*(G_level + omega3*gamma3*R*I3) */
    const double t24 = t23/t22; /* gamma3*(G_level + omega3*gamma3*R*I3)/(R*I3*s*s*s) */
    const double t25 = t19 + t24; /* d(omega_n)/d(gamma3) = omega3/s + gamma3*(G_level + omega3*gamma3*R*I3)/(R*I3*s*s*s) */
    const double t26 = t5*t25; /* R*gamma3*d(omega_n)/d(gamma3) */
    const double t27 = t18 + t26; /* d(v_tau)/d(gamma3) = R*omega_n - omega3*R*gamma3/s + R*gamma3*d(omega_n)/d(gamma3) */
    const double t28 = t14*t27; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t29 = p[5]*t11; /* I3*omega_n */
    const double t30 = t25*t29; /* d(omega_n)/d(gamma3)*I3*omega_n */
    const double t31 = t28 + t30; /* d(energy)/d(gamma3) = m*v_tau*d(v_tau)/d(gamma3) + d(omega_n)/d(gamma3)*I3*omega_n */
    const double t32 = p[0]*x[1]; /* m*v_nu */
    const double t33 = p[5]*x[2]; /* I3*omega_tau */
    const double t34 = x[3]*p[5]; /* omega3*I3 */
    const double t35 = x[0]*p[5]; /* gamma3*I3 */
    const double t36 = t11*t35; /* omega_n*gamma3*I3 */
    const double t37 = t36/t3; /* omega_n*gamma3*I3/s */
    const double t38 = t34 + t37; /* omega3*I3 + omega_n*gamma3*I3/s */
    const double t39 = p[1]*t3; /* R*s */
    const double t40 = p[1]*t1; /* R*gamma3*gamma3 */
    const double t41 = t40/t3; /* R*gamma3*gamma3/s */
    const double t42 = t39 + t41; /* d(v_tau)/d(omega3) = R*s + R*gamma3*gamma3/s */
    const double t43 = t14*t42; /* m*v_tau*d(v_tau)/d(omega3) */
    const double t44 = t38 + t43; /* d(energy)/d(omega3) = omega3*I3 + omega_n*gamma3*I3/s + m*v_tau*d(v_tau)/d(omega3) */
    const double t45 = p[0]*2.0; /* m*2 */
    const double t46 = p[5]*p[5]; /* I3*I3 */
    const double t47 = t45*t46; /* m*2*I3*I3 */
    const double t48 = p[1]*x[2]; /* R*omega_tau */
    const double t49 = x[1] + t48; /* v_nu + R*omega_tau */
    const double t50 = t47*t49; /* m*2*I3*I3*(v_nu + R*omega_tau) */
    const double t51 = p[1]*t45; /* R*m*2 */
    const double t52 = t46*t51; /* I3*I3*R*m*2 */
    const double t53 = t49*t52; /* (v_nu + R*omega_tau)*I3*I3*R*m*2 */
    out[0] = t31;
    out[1] = t32;
    out[2] = t33;
    out[3] = t44;
    out[4] = 0.0;
    out[5] = t50;
    out[6] = t53;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = 1.0;
    out[10] = p[1];
    out[11] = 0.0;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[5]; /* R*I3 */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0*t3; /* R*I3*s */
    const double t5 = t0*x[0]; /* R*I3*gamma3 */
    const double t6 = t5*x[3]; /* R*I3*gamma3*omega3 */
    const double t7 = p[6] + t6; /* G_level + R*I3*gamma3*omega3 */
    const double t8 = t7/t4; /* omega_n = (G_level + R*I3*gamma3*omega3)/(R*I3*s) */
    out[0] = t8;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_R = params[1];
    const double v_I3 = params[5];
    const double v_I1 = (v_I3);
    const double v_G_level = params[6];
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
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
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_G = {
    .model = "spherical_top",
    .variant = "balanced_equal",
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
    .rhs = { rhs, 4, { 9, 24, 0, 4, 1, 0, 10, 7 }, { 9, 31, 0, 4, 1, 0, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 23, 47, 0, 18, 1, 0, 13, 12 }, { 24, 80, 0, 18, 1, 0, 13, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 27, 53, 0, 21, 1, 0, 13, 19 }, { 28, 93, 0, 21, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 6, 14, 0, 2, 1, 0, 9, 7 }, { 6, 19, 0, 2, 1, 0, 9, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 8, 29, 0, 1, 1, 0, 13, 6 }, { 9, 31, 0, 1, 1, 0, 13, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 12, { 11, 36, 0, 6, 1, 0, 12, 11 }, { 13, 48, 0, 6, 1, 0, 12, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 5, 0, 1, 1, 0, 5, 3 }, { 2, 6, 0, 1, 1, 0, 5, 3 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_on_level_G_baseline,
        &jlt_batch_spherical_top_balanced_equal_on_level_G_avx2,
        &jlt_batch_spherical_top_balanced_equal_on_level_G_avx512,
    },
};
