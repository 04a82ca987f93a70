/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced_equal: a3 = 0, I1 = I3
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 11   31    0    7    1    0     10    8   (61)
 *  jacobian            24   46    0   21    1    0     10   13   (143)
 *  rhs_jacobian        31   55    0   28    1    0     10   21   (186)
 *  divergence          5   13    0    1    1    0      9    6   (25)
 *  integral_values     8   30    0    0    1    0     11    5   (42)
 *  integral_gradients  9   31    0    2    1    0      7    6   (53)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_equal;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_equal_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[5];
    out[5] = params[5];
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[5]*params[5]; /* I3*I3 */
    out[6] = t0;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*x[3]; /* R*omega_n */
    const double t5 = t4*x[4]; /* R*omega_n*omega3 */
    const double t6 = x[0]*p[1]; /* gamma3*R */
    const double t7 = x[3]*x[3]; /* omega_n*omega_n */
    const double t8 = t6*t7; /* gamma3*R*omega_n*omega_n */
    const double t9 = t8/t2; /* gamma3*R*omega_n*omega_n/s */
    const double t10 = t5 + t9; /* R*omega_n*omega3 + gamma3*R*omega_n*omega_n/s */
    const double t11 = x[0]*t7; /* gamma3*omega_n*omega_n */
    const double t12 = t11/t2; /* gamma3*omega_n*omega_n/s */
    const double t13 = -t12; /* -gamma3*omega_n*omega_n/s */
    const double t14 = x[3]*x[4]; /* omega_n*omega3 */
    const double t15 = t13 - t14; /* -gamma3*omega_n*omega_n/s - omega_n*omega3 */
    const double t16 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t17 = x[3]*t16; /* omega_n*omega_tau*gamma3 */
    const double t18 = t17/t2; /* omega_n*omega_tau*gamma3/s */
    const double t19 = p[5]*p[5]; /* I3*I3 */
    const double t20 = x[2]*t19; /* omega_tau*I3*I3 */
    const double t21 = x[4]*t20; /* omega3*omega_tau*I3*I3 */
    const double t22 = p[1]*p[1]; /* R*R */
    const double t23 = p[0]*t22; /* m*R*R */
    const double t24 = p[5]*t23; /* I3*m*R*R */
    const double t25 = t0*t24; /* gamma3*gamma3*I3*m*R*R */
    const double t26 = t25 + p[6]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t27 = t2*t2; /* s*s */
    const double t28 = t24*t27; /* I3*m*R*R*s*s */
    const double t29 = t26 + t28; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + I3*m*R*R*s*s */
    const double t30 = t21/t29; /* omega3*omega_tau*I3*I3/Theta */
    const double t31 = t18 + t30; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta */
    const double t32 = p[1]*p[0]; /* R*m */
    const double t33 = p[5]*t32; /* I3*R*m */
    const double t34 = x[0]*t33; /* gamma3*I3*R*m */
    const double t35 = x[3]*t34; /* omega_n*gamma3*I3*R*m */
    const double t36 = t2*t29; /* s*Theta */
    const double t37 = x[2]*p[1]; /* omega_tau*R */
    const double t38 = x[1] + t37; /* V = v_nu + omega_tau*R */
    const double t39 = t35*t38; /* omega_n*gamma3*I3*R*m*V */
    const double t40 = t39/t36; /* omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t41 = t31 - t40; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t42 = x[2]*t24; /* omega_tau*I3*m*R*R */
    const double t43 = x[4]*t42; /* omega3*omega_tau*I3*m*R*R */
    const double t44 = t43/t29; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t45 = t41 + t44; /* t41 + omega3*omega_tau*I3*m*R*R/Theta */
    const double t46 = x[3]*t33; /* omega_n*I3*R*m */
    const double t47 = t38*t46; /* V*omega_n*I3*R*m */
    const double t48 = t47/t29; /* V*omega_n*I3*R*m/Theta */
    const double t49 = -t48; /* -V*omega_n*I3*R*m/Theta */
    out[0] = t3;
    out[1] = t10;
    out[2] = t15;
    out[3] = t45;
    out[4] = t49;
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
    const double t9 = t1*p[1]; /* gamma3*gamma3*R */
    const double t10 = t6*t9; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t11 = t3*t3; /* s*s */
    const double t12 = t3*t11; /* s*s*s */
    const double t13 = t10/t12; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t14 = t8 + t13; /* R*omega_n*omega_n/s + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t15 = p[1]*x[4]; /* R*omega3 */
    const double t16 = x[0]*p[1]; /* gamma3*R */
    const double t17 = x[3]*t16; /* omega_n*gamma3*R */
    const double t18 = t17/t3; /* omega_n*gamma3*R/s */
    const double t19 = t18*2.0; /* omega_n*gamma3*R/s*2 */
    const double t20 = t15 + t19; /* R*omega3 + omega_n*gamma3*R/s*2 */
    const double t21 = p[1]*x[3]; /* R*omega_n */
    const double t22 = t6/t3; /* omega_n*omega_n/s */
    const double t23 = -t22; /* -omega_n*omega_n/s */
    const double t24 = t1*t6; /* gamma3*gamma3*omega_n*omega_n */
    const double t25 = t24/t12; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t26 = t23 - t25; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t27 = -x[4]; /* -omega3 */
    const double t28 = x[0]*x[3]; /* gamma3*omega_n */
    const double t29 = t28/t3; /* gamma3*omega_n/s */
    const double t30 = 2.0*t29; /* 2*gamma3*omega_n/s */
    const double t31 = t27 - t30; /* -omega3 - 2*gamma3*omega_n/s */
    const double t32 = -x[3]; /* -omega_n */
    const double t33 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t34 = t33/t3; /* omega_tau*omega_n/s */
    const double t35 = x[2]*t1; /* omega_tau*gamma3*gamma3 */
    const double t36 = x[3]*t35; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t37 = t36/t12; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t38 = t34 + t37; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t39 = p[1]*p[0]; /* R*m */
    const double t40 = t39*p[5]; /* R*m*I3 */
    const double t41 = x[3]*t40; /* omega_n*R*m*I3 */
    const double t42 = p[1]*p[1]; /* R*R */
    const double t43 = p[0]*t42; /* m*R*R */
    const double t44 = p[5]*t43; /* I3*m*R*R */
    const double t45 = t1*t44; /* gamma3*gamma3*I3*m*R*R */
    const double t46 = t45 + p[6]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t47 = t11*t44; /* s*s*I3*m*R*R */
    const double t48 = t46 + t47; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + s*s*I3*m*R*R */
    const double t49 = t3*t48; /* s*Theta */
    const double t50 = x[2]*p[1]; /* omega_tau*R */
    const double t51 = x[1] + t50; /* V = v_nu + omega_tau*R */
    const double t52 = t41*t51; /* omega_n*R*m*I3*V */
    const double t53 = t52/t49; /* omega_n*R*m*I3*V/(s*Theta) */
    const double t54 = t38 - t53; /* t38 - omega_n*R*m*I3*V/(s*Theta) */
    const double t55 = t1*t40; /* gamma3*gamma3*R*m*I3 */
    const double t56 = x[3]*t55; /* omega_n*gamma3*gamma3*R*m*I3 */
    const double t57 = t12*t48; /* s*s*s*Theta */
    const double t58 = t51*t56; /* V*omega_n*gamma3*gamma3*R*m*I3 */
    const double t59 = t58/t57; /* V*omega_n*gamma3*gamma3*R*m*I3/(s*s*s*Theta) */
    const double t60 = t54 - t59; /* t38 - omega_n*R*m*I3*V/(s*Theta) - V*omega_n*gamma3*gamma3*R*m*I3/(s*s*s*Theta) */
    const double t61 = x[0]*t40; /* gamma3*R*m*I3 */
    const double t62 = x[3]*t61; /* omega_n*gamma3*R*m*I3 */
    const double t63 = t62/t49; /* omega_n*gamma3*R*m*I3/(s*Theta) */
    const double t64 = -t63; /* -omega_n*gamma3*R*m*I3/(s*Theta) */
    const double t65 = p[5]*p[5]; /* I3*I3 */
    const double t66 = x[4]*t65; /* omega3*I3*I3 */
    const double t67 = t66/t48; /* omega3*I3*I3/Theta */
    const double t68 = t29 + t67; /* gamma3*omega_n/s + omega3*I3*I3/Theta */
    const double t69 = x[0]*t44; /* gamma3*I3*m*R*R */
    const double t70 = x[3]*t69; /* omega_n*gamma3*I3*m*R*R */
    const double t71 = t70/t49; /* omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t72 = t68 - t71; /* gamma3*omega_n/s + omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t73 = x[4]*t44; /* omega3*I3*m*R*R */
    const double t74 = t73/t48; /* omega3*I3*m*R*R/Theta */
    const double t75 = t72 + t74; /* t72 + omega3*I3*m*R*R/Theta */
    const double t76 = t51*t61; /* V*gamma3*R*m*I3 */
    const double t77 = t76/t49; /* V*gamma3*R*m*I3/(s*Theta) */
    const double t78 = t4 - t77; /* gamma3*omega_tau/s - V*gamma3*R*m*I3/(s*Theta) */
    const double t79 = x[2]*t65; /* omega_tau*I3*I3 */
    const double t80 = t79/t48; /* omega_tau*I3*I3/Theta */
    const double t81 = x[2]*t44; /* omega_tau*I3*m*R*R */
    const double t82 = t81/t48; /* omega_tau*I3*m*R*R/Theta */
    const double t83 = t80 + t82; /* omega_tau*I3*I3/Theta + omega_tau*I3*m*R*R/Theta */
    const double t84 = t41/t48; /* omega_n*R*m*I3/Theta */
    const double t85 = -t84; /* -omega_n*R*m*I3/Theta */
    const double t86 = x[3]*t44; /* omega_n*I3*m*R*R */
    const double t87 = t86/t48; /* omega_n*I3*m*R*R/Theta */
    const double t88 = -t87; /* -omega_n*I3*m*R*R/Theta */
    const double t89 = t40*t51; /* R*m*I3*V */
    const double t90 = t89/t48; /* R*m*I3*V/Theta */
    const double t91 = -t90; /* -R*m*I3*V/Theta */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t14;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t20;
    out[9] = t21;
    out[10] = t26;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t31;
    out[14] = t32;
    out[15] = t60;
    out[16] = t64;
    out[17] = t75;
    out[18] = t78;
    out[19] = t83;
    out[20] = 0.0;
    out[21] = t85;
    out[22] = t88;
    out[23] = t91;
    out[24] = 0.0;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*x[3]; /* R*omega_n */
    const double t5 = t4*x[4]; /* R*omega_n*omega3 */
    const double t6 = x[0]*p[1]; /* gamma3*R */
    const double t7 = x[3]*x[3]; /* omega_n*omega_n */
    const double t8 = t6*t7; /* gamma3*R*omega_n*omega_n */
    const double t9 = t8/t2; /* gamma3*R*omega_n*omega_n/s */
    const double t10 = t5 + t9; /* R*omega_n*omega3 + gamma3*R*omega_n*omega_n/s */
    const double t11 = x[0]*t7; /* gamma3*omega_n*omega_n */
    const double t12 = t11/t2; /* gamma3*omega_n*omega_n/s */
    const double t13 = -t12; /* -gamma3*omega_n*omega_n/s */
    const double t14 = x[3]*x[4]; /* omega_n*omega3 */
    const double t15 = t13 - t14; /* -gamma3*omega_n*omega_n/s - omega_n*omega3 */
    const double t16 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t17 = x[3]*t16; /* omega_n*omega_tau*gamma3 */
    const double t18 = t17/t2; /* omega_n*omega_tau*gamma3/s */
    const double t19 = p[5]*p[5]; /* I3*I3 */
    const double t20 = x[2]*t19; /* omega_tau*I3*I3 */
    const double t21 = x[4]*t20; /* omega3*omega_tau*I3*I3 */
    const double t22 = p[1]*p[1]; /* R*R */
    const double t23 = p[0]*t22; /* m*R*R */
    const double t24 = p[5]*t23; /* I3*m*R*R */
    const double t25 = t0*t24; /* gamma3*gamma3*I3*m*R*R */
    const double t26 = t25 + p[6]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t27 = t2*t2; /* s*s */
    const double t28 = t24*t27; /* I3*m*R*R*s*s */
    const double t29 = t26 + t28; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + I3*m*R*R*s*s */
    const double t30 = t21/t29; /* omega3*omega_tau*I3*I3/Theta */
    const double t31 = t18 + t30; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta */
    const double t32 = p[1]*p[0]; /* R*m */
    const double t33 = p[5]*t32; /* I3*R*m */
    const double t34 = x[0]*t33; /* gamma3*I3*R*m */
    const double t35 = x[3]*t34; /* omega_n*gamma3*I3*R*m */
    const double t36 = t2*t29; /* s*Theta */
    const double t37 = x[2]*p[1]; /* omega_tau*R */
    const double t38 = x[1] + t37; /* V = v_nu + omega_tau*R */
    const double t39 = t35*t38; /* omega_n*gamma3*I3*R*m*V */
    const double t40 = t39/t36; /* omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t41 = t31 - t40; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t42 = x[2]*t24; /* omega_tau*I3*m*R*R */
    const double t43 = x[4]*t42; /* omega3*omega_tau*I3*m*R*R */
    const double t44 = t43/t29; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t45 = t41 + t44; /* t41 + omega3*omega_tau*I3*m*R*R/Theta */
    const double t46 = x[3]*t33; /* omega_n*I3*R*m */
    const double t47 = t38*t46; /* V*omega_n*I3*R*m */
    const double t48 = t47/t29; /* V*omega_n*I3*R*m/Theta */
    const double t49 = -t48; /* -V*omega_n*I3*R*m/Theta */
    const double t50 = t16/t2; /* omega_tau*gamma3/s */
    const double t51 = -t50; /* -omega_tau*gamma3/s */
    const double t52 = p[1]*t7; /* R*omega_n*omega_n */
    const double t53 = t52/t2; /* R*omega_n*omega_n/s */
    const double t54 = t0*p[1]; /* gamma3*gamma3*R */
    const double t55 = t7*t54; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t56 = t2*t27; /* s*s*s */
    const double t57 = t55/t56; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t58 = t53 + t57; /* R*omega_n*omega_n/s + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t59 = p[1]*x[4]; /* R*omega3 */
    const double t60 = x[3]*t6; /* omega_n*gamma3*R */
    const double t61 = t60/t2; /* omega_n*gamma3*R/s */
    const double t62 = t61*2.0; /* omega_n*gamma3*R/s*2 */
    const double t63 = t59 + t62; /* R*omega3 + omega_n*gamma3*R/s*2 */
    const double t64 = t7/t2; /* omega_n*omega_n/s */
    const double t65 = -t64; /* -omega_n*omega_n/s */
    const double t66 = t0*t7; /* gamma3*gamma3*omega_n*omega_n */
    const double t67 = t66/t56; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t68 = t65 - t67; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t69 = -x[4]; /* -omega3 */
    const double t70 = x[0]*x[3]; /* gamma3*omega_n */
    const double t71 = t70/t2; /* gamma3*omega_n/s */
    const double t72 = 2.0*t71; /* 2*gamma3*omega_n/s */
    const double t73 = t69 - t72; /* -omega3 - 2*gamma3*omega_n/s */
    const double t74 = -x[3]; /* -omega_n */
    const double t75 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t76 = t75/t2; /* omega_tau*omega_n/s */
    const double t77 = x[2]*t0; /* omega_tau*gamma3*gamma3 */
    const double t78 = x[3]*t77; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t79 = t78/t56; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t80 = t76 + t79; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t81 = t47/t36; /* V*omega_n*I3*R*m/(s*Theta) */
    const double t82 = t80 - t81; /* t80 - V*omega_n*I3*R*m/(s*Theta) */
    const double t83 = t0*t33; /* gamma3*gamma3*I3*R*m */
    const double t84 = x[3]*t83; /* omega_n*gamma3*gamma3*I3*R*m */
    const double t85 = t29*t56; /* Theta*s*s*s */
    const double t86 = t38*t84; /* V*omega_n*gamma3*gamma3*I3*R*m */
    const double t87 = t86/t85; /* V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) */
    const double t88 = t82 - t87; /* t80 - V*omega_n*I3*R*m/(s*Theta) - V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) */
    const double t89 = t35/t36; /* omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t90 = -t89; /* -omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t91 = x[4]*t19; /* omega3*I3*I3 */
    const double t92 = t91/t29; /* omega3*I3*I3/Theta */
    const double t93 = t71 + t92; /* gamma3*omega_n/s + omega3*I3*I3/Theta */
    const double t94 = x[0]*t24; /* gamma3*I3*m*R*R */
    const double t95 = x[3]*t94; /* omega_n*gamma3*I3*m*R*R */
    const double t96 = t95/t36; /* omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t97 = t93 - t96; /* gamma3*omega_n/s + omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t98 = x[4]*t24; /* omega3*I3*m*R*R */
    const double t99 = t98/t29; /* omega3*I3*m*R*R/Theta */
    const double t100 = t97 + t99; /* t97 + omega3*I3*m*R*R/Theta */
    const double t101 = t34*t38; /* gamma3*I3*R*m*V */
    const double t102 = t101/t36; /* gamma3*I3*R*m*V/(s*Theta) */
    const double t103 = t50 - t102; /* omega_tau*gamma3/s - gamma3*I3*R*m*V/(s*Theta) */
    const double t104 = t20/t29; /* omega_tau*I3*I3/Theta */
    const double t105 = t42/t29; /* omega_tau*I3*m*R*R/Theta */
    const double t106 = t104 + t105; /* omega_tau*I3*I3/Theta + omega_tau*I3*m*R*R/Theta */
    const double t107 = t46/t29; /* omega_n*I3*R*m/Theta */
    const double t108 = -t107; /* -omega_n*I3*R*m/Theta */
    const double t109 = x[3]*t24; /* omega_n*I3*m*R*R */
    const double t110 = t109/t29; /* omega_n*I3*m*R*R/Theta */
    const double t111 = -t110; /* -omega_n*I3*m*R*R/Theta */
    const double t112 = t33*t38; /* I3*R*m*V */
    const double t113 = t112/t29; /* I3*R*m*V/Theta */
    const double t114 = -t113; /* -I3*R*m*V/Theta */
    out[0] = t3;
    out[1] = t10;
    out[2] = t15;
    out[3] = t45;
    out[4] = t49;
    out[5] = t51;
    out[6] = 0.0;
    out[7] = t2;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = t58;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t63;
    out[14] = t4;
    out[15] = t68;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t73;
    out[19] = t74;
    out[20] = t88;
    out[21] = t90;
    out[22] = t100;
    out[23] = t103;
    out[24] = t106;
    out[25] = 0.0;
    out[26] = t108;
    out[27] = t111;
    out[28] = t114;
    out[29] = 0.0;
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
    const double t10 = t9 + p[6]; /* gamma3*gamma3*I3*m*R*R + I3^2 */
    const double t11 = t5*t5; /* s*s */
    const double t12 = t8*t11; /* I3*m*R*R*s*s */
    const double t13 = t10 + t12; /* Theta = gamma3*gamma3*I3*m*R*R + I3^2 + I3*m*R*R*s*s */
    const double t14 = t5*t13; /* s*Theta */
    const double t15 = p[1]*x[2]; /* R*omega_tau */
    const double t16 = x[1] + t15; /* V = v_nu + R*omega_tau */
    const double t17 = t2*t16; /* m*R*I3*gamma3*V */
    const double t18 = t17/t14; /* m*R*I3*gamma3*V/(s*Theta) */
    const double t19 = -t18; /* -m*R*I3*gamma3*V/(s*Theta) */
    out[0] = t19;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = p[0]*t0; /* m*v_nu*v_nu */
    const double t2 = t1*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t3 = x[4]*x[4]; /* omega3*omega3 */
    const double t4 = p[5]*t3; /* I3*omega3*omega3 */
    const double t5 = (1.0 / 2.0)*t4; /* 1/2*I3*omega3*omega3 */
    const double t6 = t2 + t5; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 */
    const double t7 = x[4]*p[1]; /* omega3*R */
    const double t8 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t9 = 1.0 - t8; /* 1 - gamma3*gamma3 */
    const double t10 = sqrt(t9); /* s = sqrt(1 - gamma3*gamma3) */
    const double t11 = t7*t10; /* omega3*R*s */
    const double t12 = p[1]*x[0]; /* R*gamma3 */
    const double t13 = t12*x[3]; /* R*gamma3*omega_n */
    const double t14 = t11 + t13; /* v_tau = omega3*R*s + R*gamma3*omega_n */
    const double t15 = t14*t14; /* v_tau*v_tau */
    const double t16 = p[0]*t15; /* m*v_tau*v_tau */
    const double t17 = (1.0 / 2.0)*t16; /* 1/2*m*v_tau*v_tau */
    const double t18 = t6 + t17; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau */
    const double t19 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t20 = p[5]*t19; /* I3*omega_tau*omega_tau */
    const double t21 = (1.0 / 2.0)*t20; /* 1/2*I3*omega_tau*omega_tau */
    const double t22 = t18 + t21; /* m*v_nu*v_nu*1/2 + 1/2*I3*omega3*omega3 + 1/2*m*v_tau*v_tau + 1/2*I3*omega_tau*omega_tau */
    const double t23 = x[3]*x[3]; /* omega_n*omega_n */
    const double t24 = p[5]*t23; /* I3*omega_n*omega_n */
    const double t25 = (1.0 / 2.0)*t24; /* 1/2*I3*omega_n*omega_n */
    const double t26 = t22 + t25; /* energy = t22 + 1/2*I3*omega_n*omega_n */
    const double t27 = p[5]*p[1]; /* I3*R */
    const double t28 = x[0]*t27; /* gamma3*I3*R */
    const double t29 = x[4]*t28; /* omega3*gamma3*I3*R */
    const double t30 = x[3]*t27; /* omega_n*I3*R */
    const double t31 = t10*t30; /* s*omega_n*I3*R */
    const double t32 = t31 - t29; /* s*omega_n*I3*R - omega3*gamma3*I3*R */
    const double t33 = p[5]*p[5]; /* I3*I3 */
    const double t34 = p[0]*t33; /* m*I3*I3 */
    const double t35 = p[1]*x[2]; /* R*omega_tau */
    const double t36 = x[1] + t35; /* v_nu + R*omega_tau */
    const double t37 = t36*t36; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t38 = t34*t37; /* m*I3*I3*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    out[0] = t26;
    out[1] = t32;
    out[2] = t38;
    out[3] = t36;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*x[4]; /* R*omega3 */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0*t3; /* R*omega3*s */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = t5*x[3]; /* R*gamma3*omega_n */
    const double t7 = t4 + t6; /* v_tau = R*omega3*s + R*gamma3*omega_n */
    const double t8 = p[0]*t7; /* m*v_tau */
    const double t9 = p[1]*x[3]; /* R*omega_n */
    const double t10 = x[4]*t5; /* omega3*R*gamma3 */
    const double t11 = t10/t3; /* omega3*R*gamma3/s */
    const double t12 = t9 - t11; /* d(v_tau)/d(gamma3) = R*omega_n - omega3*R*gamma3/s */
    const double t13 = t8*t12; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t14 = p[0]*x[1]; /* m*v_nu */
    const double t15 = p[5]*x[2]; /* I3*omega_tau */
    const double t16 = p[0]*p[1]; /* m*R */
    const double t17 = x[0]*t16; /* gamma3*m*R */
    const double t18 = t7*t17; /* v_tau*gamma3*m*R */
    const double t19 = x[3]*p[5]; /* omega_n*I3 */
    const double t20 = t18 + t19; /* d(energy)/d(omega_n) = v_tau*gamma3*m*R + omega_n*I3 */
    const double t21 = x[4]*p[5]; /* omega3*I3 */
    const double t22 = t3*t16; /* s*m*R */
    const double t23 = t7*t22; /* v_tau*s*m*R */
    const double t24 = t21 + t23; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    const double t25 = p[1]*p[5]; /* R*I3 */
    const double t26 = x[4]*t25; /* omega3*R*I3 */
    const double t27 = -t26; /* -omega3*R*I3 */
    const double t28 = x[0]*t25; /* gamma3*R*I3 */
    const double t29 = x[3]*t28; /* omega_n*gamma3*R*I3 */
    const double t30 = t29/t3; /* omega_n*gamma3*R*I3/s */
    const double t31 = t27 - t30; /* -omega3*R*I3 - omega_n*gamma3*R*I3/s */
    const double t32 = t3*t25; /* s*R*I3 */
    const double t33 = -t28; /* -gamma3*R*I3 */
    const double t34 = p[0]*2.0; /* m*2 */
    const double t35 = p[5]*p[5]; /* I3*I3 */
    const double t36 = t34*t35; /* m*2*I3*I3 */
    const double t37 = p[1]*x[2]; /* R*omega_tau */
    const double t38 = x[1] + t37; /* v_nu + R*omega_tau */
    const double t39 = t36*t38; /* m*2*I3*I3*(v_nu + R*omega_tau) */
    const double t40 = p[1]*t34; /* R*m*2 */
    const double t41 = t35*t40; /* I3*I3*R*m*2 */
    const double t42 = t38*t41; /* (v_nu + R*omega_tau)*I3*I3*R*m*2 */
    out[0] = t13;
    out[1] = t14;
    out[2] = t15;
    out[3] = t20;
    out[4] = t24;
    out[5] = t31;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t32;
    out[9] = t33;
    out[10] = 0.0;
    out[11] = t39;
    out[12] = t42;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 1.0;
    out[17] = p[1];
    out[18] = 0.0;
    out[19] = 0.0;
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
    const double complex v_omega3 = x[4];
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double v_I3 = params[5];
    const double v_I1 = (v_I3);
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
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = params[0]*t7; /* m*R*R */
    const double t9 = params[5]*t8; /* I3*m*R*R */
    const double t10 = t4*t9; /* gamma3*gamma3*I3*m*R*R */
    const double t11 = params[5]*params[5]; /* I3*I3 */
    const double t12 = t10 + t11; /* gamma3*gamma3*I3*m*R*R + I3*I3 */
    const double t13 = t6*t6; /* s*s */
    const double t14 = t9*t13; /* I3*m*R*R*s*s */
    const double t15 = t12 + t14; /* Theta = gamma3*gamma3*I3*m*R*R + I3*I3 + I3*m*R*R*s*s */
    const double t16 = t6*t15; /* s*Theta */
    const double t17 = t3/t16; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t18 = -t17; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t18;
}

static void family0_charpoly(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = params[5]*t2; /* I3*s */
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[0]*t4; /* m*R*R */
    const double t6 = params[5]*t5; /* I3*m*R*R */
    const double t7 = t0*t6; /* gamma3*gamma3*I3*m*R*R */
    const double t8 = params[5]*params[5]; /* I3*I3 */
    const double t9 = t7 + t8; /* gamma3*gamma3*I3*m*R*R + I3*I3 */
    const double t10 = t2*t2; /* s*s */
    const double t11 = t6*t10; /* I3*m*R*R*s*s */
    const double t12 = t9 + t11; /* Theta = gamma3*gamma3*I3*m*R*R + I3*I3 + I3*m*R*R*s*s */
    const double t13 = t3*t12; /* I3*s*Theta */
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = t8*t14; /* I3*I3*m*R */
    const double t16 = x[0]*t15; /* gamma3*I3*I3*m*R */
    const double t17 = t16*x[1]; /* gamma3*I3*I3*m*R*v_nu */
    const double t18 = x[4]*x[4]; /* omega3*omega3 */
    const double t19 = t8*t18; /* I3*I3*omega3*omega3 */
    const double t20 = t2*t19; /* s*I3*I3*omega3*omega3 */
    const double t21 = params[5] + t5; /* I3 + m*R*R */
    const double t22 = t20*t21; /* s*I3*I3*omega3*omega3*(I3 + m*R*R) */
    out[0] = t13;
    out[1] = t17;
    out[2] = t22;
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
    const double t4 = -x[4]; /* -omega3 */
    const double t5 = x[4]*params[5]; /* omega3*I3 */
    const double t6 = params[1]*params[1]; /* R*R */
    const double t7 = params[0]*t6; /* m*R*R */
    const double t8 = params[5]*t7; /* I3*m*R*R */
    const double t9 = t0*t8; /* gamma3*gamma3*I3*m*R*R */
    const double t10 = params[5]*params[5]; /* I3*I3 */
    const double t11 = t9 + t10; /* gamma3*gamma3*I3*m*R*R + I3*I3 */
    const double t12 = t2*t2; /* s*s */
    const double t13 = t8*t12; /* I3*m*R*R*s*s */
    const double t14 = t11 + t13; /* Theta = gamma3*gamma3*I3*m*R*R + I3*I3 + I3*m*R*R*s*s */
    const double t15 = params[5] + t7; /* I3 + m*R*R */
    const double t16 = t5*t15; /* omega3*I3*(I3 + m*R*R) */
    const double t17 = t16/t14; /* omega3*I3*(I3 + m*R*R)/Theta */
    const double t18 = params[1]*params[0]; /* R*m */
    const double t19 = params[5]*t18; /* I3*R*m */
    const double t20 = x[0]*t19; /* gamma3*I3*R*m */
    const double t21 = t20*x[1]; /* gamma3*I3*R*m*v_nu */
    const double t22 = t2*t14; /* s*Theta */
    const double t23 = t21/t22; /* gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t24 = -t23; /* -gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t25 = t19*x[1]; /* I3*R*m*v_nu */
    const double t26 = t25/t14; /* I3*R*m*v_nu/Theta */
    const double t27 = -t26; /* -I3*R*m*v_nu/Theta */
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
    out[13] = t4;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = t17;
    out[18] = t24;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = t27;
    out[24] = 0.0;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[1]*x[4]; /* R*omega3 */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0*t3; /* v_tau = R*omega3*s */
    const double t5 = params[1]*x[0]; /* R*gamma3 */
    const double t6 = params[0]*t4; /* m*v_tau */
    const double t7 = x[4]*t5; /* omega3*R*gamma3 */
    const double t8 = t7/t3; /* omega3*R*gamma3/s */
    const double t9 = t6*t8; /* m*v_tau*omega3*R*gamma3/s */
    const double t10 = -t9; /* -m*v_tau*omega3*R*gamma3/s */
    const double t11 = params[0]*x[1]; /* m*v_nu */
    const double t12 = params[0]*params[1]; /* m*R */
    const double t13 = x[0]*t12; /* gamma3*m*R */
    const double t14 = t4*t13; /* d(energy)/d(omega_n) = v_tau*gamma3*m*R */
    const double t15 = x[4]*params[5]; /* omega3*I3 */
    const double t16 = t3*t12; /* s*m*R */
    const double t17 = t4*t16; /* v_tau*s*m*R */
    const double t18 = t15 + t17; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    const double t19 = params[1]*params[5]; /* R*I3 */
    const double t20 = x[4]*t19; /* omega3*R*I3 */
    const double t21 = -t20; /* -omega3*R*I3 */
    const double t22 = x[0]*t19; /* gamma3*R*I3 */
    const double t23 = t3*t19; /* s*R*I3 */
    const double t24 = -t22; /* -gamma3*R*I3 */
    const double t25 = params[0]*2.0; /* m*2 */
    const double t26 = params[5]*params[5]; /* I3*I3 */
    const double t27 = t25*t26; /* m*2*I3*I3 */
    const double t28 = x[1]*t27; /* v_nu*m*2*I3*I3 */
    const double t29 = params[1]*t25; /* R*m*2 */
    const double t30 = t26*t29; /* I3*I3*R*m*2 */
    const double t31 = x[1]*t30; /* v_nu*I3*I3*R*m*2 */
    out[0] = t10;
    out[1] = t11;
    out[2] = 0.0;
    out[3] = t14;
    out[4] = t18;
    out[5] = t21;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t23;
    out[9] = t24;
    out[10] = 0.0;
    out[11] = t28;
    out[12] = t31;
    out[13] = 0.0;
    out[14] = 0.0;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "G", "" },
    { "F0", "a3 = 0" },
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
    { "F0", "a3 = 0" },
    { "F_linear", "a3 = 0, I1 = I3" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_equal = {
    .model = "spherical_top",
    .variant = "balanced_equal",
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
    .rhs = { rhs, 5, { 11, 31, 0, 7, 1, 0, 10, 8 }, { 11, 42, 0, 7, 1, 0, 10, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 25, { 24, 46, 0, 21, 1, 0, 10, 13 }, { 24, 95, 0, 23, 1, 0, 10, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 31, 55, 0, 28, 1, 0, 10, 21 }, { 31, 124, 0, 30, 1, 0, 10, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 5, 13, 0, 1, 1, 0, 9, 6 }, { 5, 18, 0, 1, 1, 0, 9, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of m*R^2*I3*gamma3^2, I3^2 and m*R^2*I3*s^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 4, { 8, 30, 0, 0, 1, 0, 11, 5 }, { 9, 32, 0, 0, 1, 0, 11, 5 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 20, { 9, 31, 0, 2, 1, 0, 7, 6 }, { 10, 40, 0, 2, 1, 0, 7, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_equal_baseline,
        &jlt_batch_spherical_top_balanced_equal_avx2,
        &jlt_batch_spherical_top_balanced_equal_avx512,
    },
};
