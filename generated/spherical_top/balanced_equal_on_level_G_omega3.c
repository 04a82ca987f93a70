/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 11   33    0    7    1    0     11    8   (62)
 *  jacobian            30   58    0   25    1    0     12   17   (171)
 *  rhs_jacobian        36   67    0   31    1    0     12   23   (208)
 *  divergence          6   19    0    3    1    0     10    7   (38)
 *  integral_values     8   29    0    1    1    0     15    5   (42)
 *  integral_gradients  12   33    0    6    1    0     13   10   (66)
 *  eliminated          2    5    0    1    1    0      6    4   (10)
 *
 *  Accuracy: divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_avx512;

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
    const double t4 = p[1]*x[3]; /* R*omega_n */
    const double t5 = p[1]*p[5]; /* R*I3 */
    const double t6 = x[0]*t5; /* gamma3*R*I3 */
    const double t7 = x[3]*t5; /* omega_n*R*I3 */
    const double t8 = t2*t7; /* s*omega_n*R*I3 */
    const double t9 = t8 - p[6]; /* s*omega_n*R*I3 - G_level */
    const double t10 = t9/t6; /* omega3 = (s*omega_n*R*I3 - G_level)/(gamma3*R*I3) */
    const double t11 = t4*t10; /* R*omega_n*omega3 */
    const double t12 = x[0]*p[1]; /* gamma3*R */
    const double t13 = x[3]*x[3]; /* omega_n*omega_n */
    const double t14 = t12*t13; /* gamma3*R*omega_n*omega_n */
    const double t15 = t14/t2; /* gamma3*R*omega_n*omega_n/s */
    const double t16 = t11 + t15; /* R*omega_n*omega3 + gamma3*R*omega_n*omega_n/s */
    const double t17 = x[0]*t13; /* gamma3*omega_n*omega_n */
    const double t18 = t17/t2; /* gamma3*omega_n*omega_n/s */
    const double t19 = -t18; /* -gamma3*omega_n*omega_n/s */
    const double t20 = x[3]*t10; /* omega_n*omega3 */
    const double t21 = t19 - t20; /* -gamma3*omega_n*omega_n/s - omega_n*omega3 */
    const double t22 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t23 = x[3]*t22; /* omega_n*omega_tau*gamma3 */
    const double t24 = t23/t2; /* omega_n*omega_tau*gamma3/s */
    const double t25 = p[5]*p[5]; /* I3*I3 */
    const double t26 = x[2]*t25; /* omega_tau*I3*I3 */
    const double t27 = t10*t26; /* omega3*omega_tau*I3*I3 */
    const double t28 = p[1]*p[1]; /* R*R */
    const double t29 = p[0]*t28; /* m*R*R */
    const double t30 = p[5]*t29; /* I3*m*R*R */
    const double t31 = t0*t30; /* gamma3*gamma3*I3*m*R*R */
    const double t32 = t31 + p[7]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t33 = t2*t2; /* s*s */
    const double t34 = t30*t33; /* I3*m*R*R*s*s */
    const double t35 = t32 + t34; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + I3*m*R*R*s*s */
    const double t36 = t27/t35; /* omega3*omega_tau*I3*I3/Theta */
    const double t37 = t24 + t36; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta */
    const double t38 = p[1]*p[0]; /* R*m */
    const double t39 = p[5]*t38; /* I3*R*m */
    const double t40 = x[0]*t39; /* gamma3*I3*R*m */
    const double t41 = x[3]*t40; /* omega_n*gamma3*I3*R*m */
    const double t42 = t2*t35; /* s*Theta */
    const double t43 = x[2]*p[1]; /* omega_tau*R */
    const double t44 = x[1] + t43; /* V = v_nu + omega_tau*R */
    const double t45 = t41*t44; /* omega_n*gamma3*I3*R*m*V */
    const double t46 = t45/t42; /* omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t47 = t37 - t46; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t48 = x[2]*t30; /* omega_tau*I3*m*R*R */
    const double t49 = t10*t48; /* omega3*omega_tau*I3*m*R*R */
    const double t50 = t49/t35; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t51 = t47 + t50; /* t47 + omega3*omega_tau*I3*m*R*R/Theta */
    out[0] = t3;
    out[1] = t16;
    out[2] = t21;
    out[3] = t51;
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
    const double t12 = x[3]*t10; /* omega_n*R*I3 */
    const double t13 = t3*t12; /* s*omega_n*R*I3 */
    const double t14 = p[6] - t13; /* G_level - s*omega_n*R*I3 */
    const double t15 = t14/t11; /* (G_level - s*omega_n*R*I3)/(gamma3*gamma3*R*I3) */
    const double t16 = x[3]/t3; /* omega_n/s */
    const double t17 = t15 - t16; /* d(omega3)/d(gamma3) = (G_level - s*omega_n*R*I3)/(gamma3*gamma3*R*I3) - omega_n/s */
    const double t18 = t9*t17; /* R*omega_n*d(omega3)/d(gamma3) */
    const double t19 = t8 + t18; /* R*omega_n*omega_n/s + R*omega_n*d(omega3)/d(gamma3) */
    const double t20 = t1*p[1]; /* gamma3*gamma3*R */
    const double t21 = t6*t20; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t22 = t3*t3; /* s*s */
    const double t23 = t3*t22; /* s*s*s */
    const double t24 = t21/t23; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t25 = t19 + t24; /* R*omega_n*omega_n/s + R*omega_n*d(omega3)/d(gamma3) + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t26 = x[0]*t10; /* gamma3*R*I3 */
    const double t27 = t13 - p[6]; /* s*omega_n*R*I3 - G_level */
    const double t28 = t27/t26; /* omega3 = (s*omega_n*R*I3 - G_level)/(gamma3*R*I3) */
    const double t29 = p[1]*t28; /* R*omega3 */
    const double t30 = x[0]*p[1]; /* gamma3*R */
    const double t31 = x[3]*t30; /* omega_n*gamma3*R */
    const double t32 = t31/t3; /* omega_n*gamma3*R/s */
    const double t33 = t32*2.0; /* omega_n*gamma3*R/s*2 */
    const double t34 = t29 + t33; /* R*omega3 + omega_n*gamma3*R/s*2 */
    const double t35 = t3*t9; /* s*R*omega_n */
    const double t36 = t35/x[0]; /* s*R*omega_n/gamma3 */
    const double t37 = t34 + t36; /* R*omega3 + omega_n*gamma3*R/s*2 + s*R*omega_n/gamma3 */
    const double t38 = t6/t3; /* omega_n*omega_n/s */
    const double t39 = -t38; /* -omega_n*omega_n/s */
    const double t40 = t1*t6; /* gamma3*gamma3*omega_n*omega_n */
    const double t41 = t40/t23; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t42 = t39 - t41; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t43 = x[3]*t17; /* omega_n*d(omega3)/d(gamma3) */
    const double t44 = t42 - t43; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) - omega_n*d(omega3)/d(gamma3) */
    const double t45 = -t28; /* -omega3 */
    const double t46 = x[0]*x[3]; /* gamma3*omega_n */
    const double t47 = t46/t3; /* gamma3*omega_n/s */
    const double t48 = 2.0*t47; /* 2*gamma3*omega_n/s */
    const double t49 = t45 - t48; /* -omega3 - 2*gamma3*omega_n/s */
    const double t50 = t3*x[3]; /* s*omega_n */
    const double t51 = t50/x[0]; /* s*omega_n/gamma3 */
    const double t52 = t49 - t51; /* -omega3 - 2*gamma3*omega_n/s - s*omega_n/gamma3 */
    const double t53 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t54 = t53/t3; /* omega_tau*omega_n/s */
    const double t55 = x[2]*t1; /* omega_tau*gamma3*gamma3 */
    const double t56 = x[3]*t55; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t57 = t56/t23; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t58 = t54 + t57; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t59 = p[1]*p[0]; /* R*m */
    const double t60 = p[5]*t59; /* I3*R*m */
    const double t61 = x[3]*t60; /* omega_n*I3*R*m */
    const double t62 = p[1]*p[1]; /* R*R */
    const double t63 = p[0]*t62; /* m*R*R */
    const double t64 = p[5]*t63; /* I3*m*R*R */
    const double t65 = t1*t64; /* gamma3*gamma3*I3*m*R*R */
    const double t66 = t65 + p[7]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t67 = t22*t64; /* s*s*I3*m*R*R */
    const double t68 = t66 + t67; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + s*s*I3*m*R*R */
    const double t69 = t3*t68; /* s*Theta */
    const double t70 = x[2]*p[1]; /* omega_tau*R */
    const double t71 = x[1] + t70; /* V = v_nu + omega_tau*R */
    const double t72 = t61*t71; /* omega_n*I3*R*m*V */
    const double t73 = t72/t69; /* omega_n*I3*R*m*V/(s*Theta) */
    const double t74 = t58 - t73; /* t58 - omega_n*I3*R*m*V/(s*Theta) */
    const double t75 = p[5]*p[5]; /* I3*I3 */
    const double t76 = x[2]*t75; /* omega_tau*I3*I3 */
    const double t77 = t17*t76; /* d(omega3)/d(gamma3)*omega_tau*I3*I3 */
    const double t78 = t77/t68; /* d(omega3)/d(gamma3)*omega_tau*I3*I3/Theta */
    const double t79 = t74 + t78; /* t58 - omega_n*I3*R*m*V/(s*Theta) + d(omega3)/d(gamma3)*omega_tau*I3*I3/Theta */
    const double t80 = t1*t60; /* gamma3*gamma3*I3*R*m */
    const double t81 = x[3]*t80; /* omega_n*gamma3*gamma3*I3*R*m */
    const double t82 = t23*t68; /* s*s*s*Theta */
    const double t83 = t71*t81; /* V*omega_n*gamma3*gamma3*I3*R*m */
    const double t84 = t83/t82; /* V*omega_n*gamma3*gamma3*I3*R*m/(s*s*s*Theta) */
    const double t85 = t79 - t84; /* t79 - V*omega_n*gamma3*gamma3*I3*R*m/(s*s*s*Theta) */
    const double t86 = x[2]*t64; /* omega_tau*I3*m*R*R */
    const double t87 = t17*t86; /* d(omega3)/d(gamma3)*omega_tau*I3*m*R*R */
    const double t88 = t87/t68; /* d(omega3)/d(gamma3)*omega_tau*I3*m*R*R/Theta */
    const double t89 = t85 + t88; /* t79 - V*omega_n*gamma3*gamma3*I3*R*m/(s*s*s*Theta) + d(omega3)/d(gamma3)*omega_tau*I3*m*R*R/Theta */
    const double t90 = x[0]*t60; /* gamma3*I3*R*m */
    const double t91 = x[3]*t90; /* omega_n*gamma3*I3*R*m */
    const double t92 = t91/t69; /* omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t93 = -t92; /* -omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t94 = t28*t75; /* omega3*I3*I3 */
    const double t95 = t94/t68; /* omega3*I3*I3/Theta */
    const double t96 = t47 + t95; /* gamma3*omega_n/s + omega3*I3*I3/Theta */
    const double t97 = x[0]*t64; /* gamma3*I3*m*R*R */
    const double t98 = x[3]*t97; /* omega_n*gamma3*I3*m*R*R */
    const double t99 = t98/t69; /* omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t100 = t96 - t99; /* gamma3*omega_n/s + omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t101 = t28*t64; /* omega3*I3*m*R*R */
    const double t102 = t101/t68; /* omega3*I3*m*R*R/Theta */
    const double t103 = t100 + t102; /* t100 + omega3*I3*m*R*R/Theta */
    const double t104 = t71*t90; /* V*gamma3*I3*R*m */
    const double t105 = t104/t69; /* V*gamma3*I3*R*m/(s*Theta) */
    const double t106 = t4 - t105; /* gamma3*omega_tau/s - V*gamma3*I3*R*m/(s*Theta) */
    const double t107 = t3*t76; /* s*omega_tau*I3*I3 */
    const double t108 = x[0]*t68; /* gamma3*Theta */
    const double t109 = t107/t108; /* s*omega_tau*I3*I3/(gamma3*Theta) */
    const double t110 = t106 + t109; /* gamma3*omega_tau/s - V*gamma3*I3*R*m/(s*Theta) + s*omega_tau*I3*I3/(gamma3*Theta) */
    const double t111 = t3*t86; /* s*omega_tau*I3*m*R*R */
    const double t112 = t111/t108; /* s*omega_tau*I3*m*R*R/(gamma3*Theta) */
    const double t113 = t110 + t112; /* t110 + s*omega_tau*I3*m*R*R/(gamma3*Theta) */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t25;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t37;
    out[8] = t44;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t52;
    out[12] = t89;
    out[13] = t93;
    out[14] = t103;
    out[15] = t113;
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
    const double t7 = x[3]*t5; /* omega_n*R*I3 */
    const double t8 = t2*t7; /* s*omega_n*R*I3 */
    const double t9 = p[6] - t8; /* G_level - s*omega_n*R*I3 */
    const double t10 = t8 - p[6]; /* s*omega_n*R*I3 - G_level */
    const double t11 = t10/t6; /* omega3 = (s*omega_n*R*I3 - G_level)/(gamma3*R*I3) */
    const double t12 = t4*t11; /* R*omega_n*omega3 */
    const double t13 = x[0]*p[1]; /* gamma3*R */
    const double t14 = x[3]*x[3]; /* omega_n*omega_n */
    const double t15 = t13*t14; /* gamma3*R*omega_n*omega_n */
    const double t16 = t15/t2; /* gamma3*R*omega_n*omega_n/s */
    const double t17 = t12 + t16; /* R*omega_n*omega3 + gamma3*R*omega_n*omega_n/s */
    const double t18 = x[0]*t14; /* gamma3*omega_n*omega_n */
    const double t19 = t18/t2; /* gamma3*omega_n*omega_n/s */
    const double t20 = -t19; /* -gamma3*omega_n*omega_n/s */
    const double t21 = x[3]*t11; /* omega_n*omega3 */
    const double t22 = t20 - t21; /* -gamma3*omega_n*omega_n/s - omega_n*omega3 */
    const double t23 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t24 = x[3]*t23; /* omega_n*omega_tau*gamma3 */
    const double t25 = t24/t2; /* omega_n*omega_tau*gamma3/s */
    const double t26 = p[5]*p[5]; /* I3*I3 */
    const double t27 = x[2]*t26; /* omega_tau*I3*I3 */
    const double t28 = t11*t27; /* omega3*omega_tau*I3*I3 */
    const double t29 = p[1]*p[1]; /* R*R */
    const double t30 = p[0]*t29; /* m*R*R */
    const double t31 = p[5]*t30; /* I3*m*R*R */
    const double t32 = t0*t31; /* gamma3*gamma3*I3*m*R*R */
    const double t33 = t32 + p[7]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t34 = t2*t2; /* s*s */
    const double t35 = t31*t34; /* I3*m*R*R*s*s */
    const double t36 = t33 + t35; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + I3*m*R*R*s*s */
    const double t37 = t28/t36; /* omega3*omega_tau*I3*I3/Theta */
    const double t38 = t25 + t37; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta */
    const double t39 = p[1]*p[0]; /* R*m */
    const double t40 = p[5]*t39; /* I3*R*m */
    const double t41 = x[0]*t40; /* gamma3*I3*R*m */
    const double t42 = x[3]*t41; /* omega_n*gamma3*I3*R*m */
    const double t43 = t2*t36; /* s*Theta */
    const double t44 = x[2]*p[1]; /* omega_tau*R */
    const double t45 = x[1] + t44; /* V = v_nu + omega_tau*R */
    const double t46 = t42*t45; /* omega_n*gamma3*I3*R*m*V */
    const double t47 = t46/t43; /* omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t48 = t38 - t47; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t49 = x[2]*t31; /* omega_tau*I3*m*R*R */
    const double t50 = t11*t49; /* omega3*omega_tau*I3*m*R*R */
    const double t51 = t50/t36; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t52 = t48 + t51; /* t48 + omega3*omega_tau*I3*m*R*R/Theta */
    const double t53 = t23/t2; /* omega_tau*gamma3/s */
    const double t54 = -t53; /* -omega_tau*gamma3/s */
    const double t55 = p[1]*t14; /* R*omega_n*omega_n */
    const double t56 = t55/t2; /* R*omega_n*omega_n/s */
    const double t57 = t0*t5; /* gamma3*gamma3*R*I3 */
    const double t58 = t9/t57; /* (G_level - s*omega_n*R*I3)/(gamma3*gamma3*R*I3) */
    const double t59 = x[3]/t2; /* omega_n/s */
    const double t60 = t58 - t59; /* d(omega3)/d(gamma3) = (G_level - s*omega_n*R*I3)/(gamma3*gamma3*R*I3) - omega_n/s */
    const double t61 = t4*t60; /* R*omega_n*d(omega3)/d(gamma3) */
    const double t62 = t56 + t61; /* R*omega_n*omega_n/s + R*omega_n*d(omega3)/d(gamma3) */
    const double t63 = t0*p[1]; /* gamma3*gamma3*R */
    const double t64 = t14*t63; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t65 = t2*t34; /* s*s*s */
    const double t66 = t64/t65; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t67 = t62 + t66; /* R*omega_n*omega_n/s + R*omega_n*d(omega3)/d(gamma3) + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t68 = p[1]*t11; /* R*omega3 */
    const double t69 = x[3]*t13; /* omega_n*gamma3*R */
    const double t70 = t69/t2; /* omega_n*gamma3*R/s */
    const double t71 = t70*2.0; /* omega_n*gamma3*R/s*2 */
    const double t72 = t68 + t71; /* R*omega3 + omega_n*gamma3*R/s*2 */
    const double t73 = t2*t4; /* s*R*omega_n */
    const double t74 = t73/x[0]; /* s*R*omega_n/gamma3 */
    const double t75 = t72 + t74; /* R*omega3 + omega_n*gamma3*R/s*2 + s*R*omega_n/gamma3 */
    const double t76 = t14/t2; /* omega_n*omega_n/s */
    const double t77 = -t76; /* -omega_n*omega_n/s */
    const double t78 = t0*t14; /* gamma3*gamma3*omega_n*omega_n */
    const double t79 = t78/t65; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t80 = t77 - t79; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t81 = x[3]*t60; /* omega_n*d(omega3)/d(gamma3) */
    const double t82 = t80 - t81; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) - omega_n*d(omega3)/d(gamma3) */
    const double t83 = -t11; /* -omega3 */
    const double t84 = x[0]*x[3]; /* gamma3*omega_n */
    const double t85 = t84/t2; /* gamma3*omega_n/s */
    const double t86 = 2.0*t85; /* 2*gamma3*omega_n/s */
    const double t87 = t83 - t86; /* -omega3 - 2*gamma3*omega_n/s */
    const double t88 = t2*x[3]; /* s*omega_n */
    const double t89 = t88/x[0]; /* s*omega_n/gamma3 */
    const double t90 = t87 - t89; /* -omega3 - 2*gamma3*omega_n/s - s*omega_n/gamma3 */
    const double t91 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t92 = t91/t2; /* omega_tau*omega_n/s */
    const double t93 = x[2]*t0; /* omega_tau*gamma3*gamma3 */
    const double t94 = x[3]*t93; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t95 = t94/t65; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t96 = t92 + t95; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t97 = x[3]*t40; /* omega_n*I3*R*m */
    const double t98 = t45*t97; /* V*omega_n*I3*R*m */
    const double t99 = t98/t43; /* V*omega_n*I3*R*m/(s*Theta) */
    const double t100 = t96 - t99; /* t96 - V*omega_n*I3*R*m/(s*Theta) */
    const double t101 = t27*t60; /* omega_tau*I3*I3*d(omega3)/d(gamma3) */
    const double t102 = t101/t36; /* omega_tau*I3*I3*d(omega3)/d(gamma3)/Theta */
    const double t103 = t100 + t102; /* t96 - V*omega_n*I3*R*m/(s*Theta) + omega_tau*I3*I3*d(omega3)/d(gamma3)/Theta */
    const double t104 = t0*t40; /* gamma3*gamma3*I3*R*m */
    const double t105 = x[3]*t104; /* omega_n*gamma3*gamma3*I3*R*m */
    const double t106 = t36*t65; /* Theta*s*s*s */
    const double t107 = t45*t105; /* V*omega_n*gamma3*gamma3*I3*R*m */
    const double t108 = t107/t106; /* V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) */
    const double t109 = t103 - t108; /* t103 - V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) */
    const double t110 = t49*t60; /* omega_tau*I3*m*R*R*d(omega3)/d(gamma3) */
    const double t111 = t110/t36; /* omega_tau*I3*m*R*R*d(omega3)/d(gamma3)/Theta */
    const double t112 = t109 + t111; /* t103 - V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) + omega_tau*I3*m*R*R*d(omega3)/d(gamma3)/Theta */
    const double t113 = t42/t43; /* omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t114 = -t113; /* -omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t115 = t11*t26; /* omega3*I3*I3 */
    const double t116 = t115/t36; /* omega3*I3*I3/Theta */
    const double t117 = t85 + t116; /* gamma3*omega_n/s + omega3*I3*I3/Theta */
    const double t118 = x[0]*t31; /* gamma3*I3*m*R*R */
    const double t119 = x[3]*t118; /* omega_n*gamma3*I3*m*R*R */
    const double t120 = t119/t43; /* omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t121 = t117 - t120; /* gamma3*omega_n/s + omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t122 = t11*t31; /* omega3*I3*m*R*R */
    const double t123 = t122/t36; /* omega3*I3*m*R*R/Theta */
    const double t124 = t121 + t123; /* t121 + omega3*I3*m*R*R/Theta */
    const double t125 = t41*t45; /* gamma3*I3*R*m*V */
    const double t126 = t125/t43; /* gamma3*I3*R*m*V/(s*Theta) */
    const double t127 = t53 - t126; /* omega_tau*gamma3/s - gamma3*I3*R*m*V/(s*Theta) */
    const double t128 = t2*t27; /* s*omega_tau*I3*I3 */
    const double t129 = x[0]*t36; /* gamma3*Theta */
    const double t130 = t128/t129; /* s*omega_tau*I3*I3/(gamma3*Theta) */
    const double t131 = t127 + t130; /* omega_tau*gamma3/s - gamma3*I3*R*m*V/(s*Theta) + s*omega_tau*I3*I3/(gamma3*Theta) */
    const double t132 = t2*t49; /* s*omega_tau*I3*m*R*R */
    const double t133 = t132/t129; /* s*omega_tau*I3*m*R*R/(gamma3*Theta) */
    const double t134 = t131 + t133; /* t131 + s*omega_tau*I3*m*R*R/(gamma3*Theta) */
    out[0] = t3;
    out[1] = t17;
    out[2] = t22;
    out[3] = t52;
    out[4] = t54;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = t67;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t75;
    out[12] = t82;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t90;
    out[16] = t112;
    out[17] = t114;
    out[18] = t124;
    out[19] = t134;
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
    const double t8 = p[5]*t7; /* I3*m*R*R */
    const double t9 = t3*t8; /* gamma3*gamma3*I3*m*R*R */
    const double t10 = t9 + p[7]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t11 = t5*t5; /* s*s */
    const double t12 = t8*t11; /* I3*m*R*R*s*s */
    const double t13 = t10 + t12; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + I3*m*R*R*s*s */
    const double t14 = t5*t13; /* s*Theta */
    const double t15 = p[1]*x[2]; /* R*omega_tau */
    const double t16 = x[1] + t15; /* V = v_nu + R*omega_tau */
    const double t17 = t2*t16; /* m*R*I3*gamma3*V */
    const double t18 = t17/t14; /* m*R*I3*gamma3*V/(s*Theta) */
    const double t19 = p[5]*p[5]; /* I3*I3 */
    const double t20 = x[2]*t19; /* omega_tau*I3*I3 */
    const double t21 = t5*t20; /* s*omega_tau*I3*I3 */
    const double t22 = x[0]*t13; /* gamma3*Theta */
    const double t23 = t21/t22; /* s*omega_tau*I3*I3/(gamma3*Theta) */
    const double t24 = t23 - t18; /* s*omega_tau*I3*I3/(gamma3*Theta) - m*R*I3*gamma3*V/(s*Theta) */
    const double t25 = t8*x[2]; /* I3*m*R*R*omega_tau */
    const double t26 = t5*t25; /* s*I3*m*R*R*omega_tau */
    const double t27 = t26/t22; /* s*I3*m*R*R*omega_tau/(gamma3*Theta) */
    const double t28 = t24 + t27; /* s*omega_tau*I3*I3/(gamma3*Theta) - m*R*I3*gamma3*V/(s*Theta) + s*I3*m*R*R*omega_tau/(gamma3*Theta) */
    out[0] = t28;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[0]*t0; /* m*v_nu*v_nu */
    const double t2 = t1*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t3 = p[5]*p[1]; /* I3*R */
    const double t4 = t3*x[0]; /* I3*R*gamma3 */
    const double t5 = t3*x[3]; /* I3*R*omega_n */
    const double t6 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t7 = 1.0 - t6; /* 1 - gamma3*gamma3 */
    const double t8 = sqrt(t7); /* s = sqrt(1 - gamma3*gamma3) */
    const double t9 = t5*t8; /* I3*R*omega_n*s */
    const double t10 = t9 - p[6]; /* I3*R*omega_n*s - G_level */
    const double t11 = t10/t4; /* omega3 = (I3*R*omega_n*s - G_level)/(I3*R*gamma3) */
    const double t12 = t11*t11; /* omega3*omega3 */
    const double t13 = p[5]*t12; /* I3*omega3*omega3 */
    const double t14 = (1.0 / 2.0)*t13; /* 1/2*I3*omega3*omega3 */
    const double t15 = t2 + t14; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 */
    const double t16 = p[1]*t11; /* R*omega3 */
    const double t17 = t8*t16; /* s*R*omega3 */
    const double t18 = p[1]*x[0]; /* R*gamma3 */
    const double t19 = x[3]*t18; /* omega_n*R*gamma3 */
    const double t20 = t17 + t19; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t21 = t20*t20; /* v_tau*v_tau */
    const double t22 = p[0]*t21; /* m*v_tau*v_tau */
    const double t23 = (1.0 / 2.0)*t22; /* 1/2*m*v_tau*v_tau */
    const double t24 = t15 + t23; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    const double t25 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t26 = p[5]*t25; /* I3*omega_tau*omega_tau */
    const double t27 = (1.0 / 2.0)*t26; /* 1/2*I3*omega_tau*omega_tau */
    const double t28 = t24 + t27; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau + 1/2*I3*omega_tau*omega_tau */
    const double t29 = x[3]*x[3]; /* omega_n*omega_n */
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
    const double t0 = p[1]*p[5]; /* R*I3 */
    const double t1 = t0*x[0]; /* R*I3*gamma3 */
    const double t2 = t0*x[3]; /* R*I3*omega_n */
    const double t3 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t4 = 1.0 - t3; /* 1 - gamma3*gamma3 */
    const double t5 = sqrt(t4); /* s = sqrt(1 - gamma3*gamma3) */
    const double t6 = t2*t5; /* R*I3*omega_n*s */
    const double t7 = p[6] - t6; /* G_level - R*I3*omega_n*s */
    const double t8 = t6 - p[6]; /* R*I3*omega_n*s - G_level */
    const double t9 = t8/t1; /* omega3 = (R*I3*omega_n*s - G_level)/(R*I3*gamma3) */
    const double t10 = p[1]*t9; /* R*omega3 */
    const double t11 = t5*t10; /* s*R*omega3 */
    const double t12 = p[1]*x[0]; /* R*gamma3 */
    const double t13 = x[3]*t12; /* omega_n*R*gamma3 */
    const double t14 = t11 + t13; /* v_tau = s*R*omega3 + omega_n*R*gamma3 */
    const double t15 = p[0]*t14; /* m*v_tau */
    const double t16 = p[1]*x[3]; /* R*omega_n */
    const double t17 = t9*t12; /* omega3*R*gamma3 */
    const double t18 = t17/t5; /* omega3*R*gamma3/s */
    const double t19 = t16 - t18; /* R*omega_n - omega3*R*gamma3/s */
    const double t20 = p[1]*t5; /* R*s */
    const double t21 = t0*t3; /* R*I3*gamma3*gamma3 */
    const double t22 = t7/t21; /* (G_level - R*I3*omega_n*s)/(R*I3*gamma3*gamma3) */
    const double t23 = x[3]/t5; /* omega_n/s */
    const double t24 = t22 - t23; /* d(omega3)/d(gamma3) = (G_level - R*I3*omega_n*s)/(R*I3*gamma3*gamma3) - omega_n/s */
    const double t25 = t20*t24; /* R*s*d(omega3)/d(gamma3) */
    const double t26 = t19 + t25; /* d(v_tau)/d(gamma3) = R*omega_n - omega3*R*gamma3/s + R*s*d(omega3)/d(gamma3) */
    const double t27 = t15*t26; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t28 = p[5]*t9; /* I3*omega3 */
    const double t29 = t24*t28; /* d(omega3)/d(gamma3)*I3*omega3 */
    const double t30 = t27 + t29; /* d(energy)/d(gamma3) = m*v_tau*d(v_tau)/d(gamma3) + d(omega3)/d(gamma3)*I3*omega3 */
    const double t31 = p[0]*x[1]; /* m*v_nu */
    const double t32 = p[5]*x[2]; /* I3*omega_tau */
    const double t33 = p[5]*x[3]; /* I3*omega_n */
    const double t34 = t5*t5; /* s*s */
    const double t35 = p[1]*t34; /* R*s*s */
    const double t36 = t35/x[0]; /* R*s*s/gamma3 */
    const double t37 = t12 + t36; /* d(v_tau)/d(omega_n) = R*gamma3 + R*s*s/gamma3 */
    const double t38 = t15*t37; /* m*v_tau*d(v_tau)/d(omega_n) */
    const double t39 = t33 + t38; /* I3*omega_n + m*v_tau*d(v_tau)/d(omega_n) */
    const double t40 = t5*t28; /* s*I3*omega3 */
    const double t41 = t40/x[0]; /* s*I3*omega3/gamma3 */
    const double t42 = t39 + t41; /* d(energy)/d(omega_n) = I3*omega_n + m*v_tau*d(v_tau)/d(omega_n) + s*I3*omega3/gamma3 */
    const double t43 = p[0]*2.0; /* m*2 */
    const double t44 = p[5]*p[5]; /* I3*I3 */
    const double t45 = t43*t44; /* m*2*I3*I3 */
    const double t46 = p[1]*x[2]; /* R*omega_tau */
    const double t47 = x[1] + t46; /* v_nu + R*omega_tau */
    const double t48 = t45*t47; /* m*2*I3*I3*(v_nu + R*omega_tau) */
    const double t49 = p[1]*t43; /* R*m*2 */
    const double t50 = t44*t49; /* I3*I3*R*m*2 */
    const double t51 = t47*t50; /* (v_nu + R*omega_tau)*I3*I3*R*m*2 */
    out[0] = t30;
    out[1] = t31;
    out[2] = t32;
    out[3] = t42;
    out[4] = 0.0;
    out[5] = t48;
    out[6] = t51;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = 1.0;
    out[10] = p[1];
    out[11] = 0.0;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[5]; /* R*I3 */
    const double t1 = t0*x[0]; /* R*I3*gamma3 */
    const double t2 = t0*x[3]; /* R*I3*omega_n */
    const double t3 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t4 = 1.0 - t3; /* 1 - gamma3*gamma3 */
    const double t5 = sqrt(t4); /* s = sqrt(1 - gamma3*gamma3) */
    const double t6 = t2*t5; /* R*I3*omega_n*s */
    const double t7 = t6 - p[6]; /* R*I3*omega_n*s - G_level */
    const double t8 = t7/t1; /* omega3 = (R*I3*omega_n*s - G_level)/(R*I3*gamma3) */
    out[0] = t8;
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
    const double v_I1 = (v_I3);
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
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "balanced_equal",
    .time = "",
    .elimination = "level_G_omega3",
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
    .rhs = { rhs, 4, { 11, 33, 0, 7, 1, 0, 11, 8 }, { 11, 43, 0, 7, 1, 0, 11, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 30, 58, 0, 25, 1, 0, 12, 17 }, { 30, 113, 0, 27, 1, 0, 12, 9 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 36, 67, 0, 31, 1, 0, 12, 23 }, { 36, 138, 0, 33, 1, 0, 12, 9 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 6, 19, 0, 3, 1, 0, 10, 7 }, { 6, 28, 0, 3, 1, 0, 10, 6 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 8, 29, 0, 1, 1, 0, 15, 5 }, { 9, 31, 0, 1, 1, 0, 15, 5 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 12, { 12, 33, 0, 6, 1, 0, 13, 10 }, { 13, 46, 0, 6, 1, 0, 13, 9 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 5, 0, 1, 1, 0, 6, 4 }, { 2, 6, 0, 1, 1, 0, 6, 4 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_balanced_equal_on_level_G_omega3_avx512,
    },
};
