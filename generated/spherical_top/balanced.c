/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 11   39    0    9    1    0     11   10   (72)
 *  jacobian            31   83    0   32    1    0     14   24   (239)
 *  rhs_jacobian        38   89    0   41    1    0     14   32   (293)
 *  divergence          5   18    0    2    1    0     10    7   (33)
 *  integral_values     11   40    0    0    1    0     10    7   (58)
 *  integral_gradients  12   50    0    2    1    0      9    9   (85)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
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
    const double t0 = params[4]*params[5]; /* I1*I3 */
    const double t1 = params[4] - params[5]; /* I1 - I3 */
    out[6] = t0;
    out[7] = t1;
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
    const double t14 = x[3]*p[5]; /* omega_n*I3 */
    const double t15 = x[4]*t14; /* omega3*omega_n*I3 */
    const double t16 = t15/p[4]; /* omega3*omega_n*I3/I1 */
    const double t17 = t13 - t16; /* -gamma3*omega_n*omega_n/s - omega3*omega_n*I3/I1 */
    const double t18 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t19 = x[3]*t18; /* omega_n*omega_tau*gamma3 */
    const double t20 = t19/t2; /* omega_n*omega_tau*gamma3/s */
    const double t21 = p[5]*p[5]; /* I3*I3 */
    const double t22 = x[2]*t21; /* omega_tau*I3*I3 */
    const double t23 = x[4]*t22; /* omega3*omega_tau*I3*I3 */
    const double t24 = p[1]*p[1]; /* R*R */
    const double t25 = p[0]*t24; /* m*R*R */
    const double t26 = p[4]*t25; /* I1*m*R*R */
    const double t27 = t2*t2; /* s*s */
    const double t28 = t26*t27; /* I1*m*R*R*s*s */
    const double t29 = p[6] + t28; /* I1*I3 + I1*m*R*R*s*s */
    const double t30 = p[5]*t25; /* I3*m*R*R */
    const double t31 = t0*t30; /* gamma3*gamma3*I3*m*R*R */
    const double t32 = t29 + t31; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t33 = t23/t32; /* omega3*omega_tau*I3*I3/Theta */
    const double t34 = t20 + t33; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta */
    const double t35 = p[1]*p[0]; /* R*m */
    const double t36 = p[5]*t35; /* I3*R*m */
    const double t37 = x[0]*t36; /* gamma3*I3*R*m */
    const double t38 = x[3]*t37; /* omega_n*gamma3*I3*R*m */
    const double t39 = t2*t32; /* s*Theta */
    const double t40 = x[2]*p[1]; /* omega_tau*R */
    const double t41 = x[1] + t40; /* V = v_nu + omega_tau*R */
    const double t42 = t38*t41; /* omega_n*gamma3*I3*R*m*V */
    const double t43 = t42/t39; /* omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t44 = t34 - t43; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t45 = x[2]*t30; /* omega_tau*I3*m*R*R */
    const double t46 = x[4]*t45; /* omega3*omega_tau*I3*m*R*R */
    const double t47 = t46/t32; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t48 = t44 + t47; /* t44 + omega3*omega_tau*I3*m*R*R/Theta */
    const double t49 = p[4]*t35; /* I1*R*m */
    const double t50 = x[3]*t49; /* omega_n*I1*R*m */
    const double t51 = t41*t50; /* V*omega_n*I1*R*m */
    const double t52 = t51/t32; /* V*omega_n*I1*R*m/Theta */
    const double t53 = x[0]*t25; /* gamma3*m*R*R */
    const double t54 = x[2]*t53; /* omega_tau*gamma3*m*R*R */
    const double t55 = x[4]*t54; /* omega3*omega_tau*gamma3*m*R*R */
    const double t56 = t2*t55; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t57 = t56*p[7]; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t58 = t57/t32; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t59 = t58 - t52; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - V*omega_n*I1*R*m/Theta */
    out[0] = t3;
    out[1] = t10;
    out[2] = t17;
    out[3] = t48;
    out[4] = t59;
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
    const double t27 = x[4]*p[5]; /* omega3*I3 */
    const double t28 = t27/p[4]; /* omega3*I3/I1 */
    const double t29 = -t28; /* -omega3*I3/I1 */
    const double t30 = x[0]*x[3]; /* gamma3*omega_n */
    const double t31 = t30/t3; /* gamma3*omega_n/s */
    const double t32 = 2.0*t31; /* 2*gamma3*omega_n/s */
    const double t33 = t29 - t32; /* -omega3*I3/I1 - 2*gamma3*omega_n/s */
    const double t34 = x[3]*p[5]; /* omega_n*I3 */
    const double t35 = t34/p[4]; /* omega_n*I3/I1 */
    const double t36 = -t35; /* -omega_n*I3/I1 */
    const double t37 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t38 = t37/t3; /* omega_tau*omega_n/s */
    const double t39 = x[2]*t1; /* omega_tau*gamma3*gamma3 */
    const double t40 = x[3]*t39; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t41 = t40/t12; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t42 = t38 + t41; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t43 = p[1]*p[0]; /* R*m */
    const double t44 = p[5]*t43; /* I3*R*m */
    const double t45 = x[3]*t44; /* omega_n*I3*R*m */
    const double t46 = p[1]*p[1]; /* R*R */
    const double t47 = p[0]*t46; /* m*R*R */
    const double t48 = p[4]*t47; /* I1*m*R*R */
    const double t49 = t11*t48; /* s*s*I1*m*R*R */
    const double t50 = p[6] + t49; /* I1*I3 + s*s*I1*m*R*R */
    const double t51 = p[5]*t47; /* I3*m*R*R */
    const double t52 = t1*t51; /* gamma3*gamma3*I3*m*R*R */
    const double t53 = t50 + t52; /* Theta = I1*I3 + s*s*I1*m*R*R + gamma3*gamma3*I3*m*R*R */
    const double t54 = t3*t53; /* s*Theta */
    const double t55 = x[2]*p[1]; /* omega_tau*R */
    const double t56 = x[1] + t55; /* V = v_nu + omega_tau*R */
    const double t57 = t45*t56; /* omega_n*I3*R*m*V */
    const double t58 = t57/t54; /* omega_n*I3*R*m*V/(s*Theta) */
    const double t59 = t42 - t58; /* t42 - omega_n*I3*R*m*V/(s*Theta) */
    const double t60 = p[5]*p[5]; /* I3*I3 */
    const double t61 = x[2]*t60; /* omega_tau*I3*I3 */
    const double t62 = x[4]*t61; /* omega3*omega_tau*I3*I3 */
    const double t63 = t53*t53; /* Theta*Theta */
    const double t64 = x[0]*t48; /* gamma3*I1*m*R*R */
    const double t65 = 2.0*t64; /* 2*gamma3*I1*m*R*R */
    const double t66 = x[0]*t51; /* gamma3*I3*m*R*R */
    const double t67 = 2.0*t66; /* 2*gamma3*I3*m*R*R */
    const double t68 = t67 - t65; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - 2*gamma3*I1*m*R*R */
    const double t69 = t62*t68; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3) */
    const double t70 = t69/t63; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t71 = t59 - t70; /* t42 - omega_n*I3*R*m*V/(s*Theta) - omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t72 = x[0]*t44; /* gamma3*I3*R*m */
    const double t73 = x[3]*t72; /* omega_n*gamma3*I3*R*m */
    const double t74 = t3*t63; /* s*Theta*Theta */
    const double t75 = t56*t73; /* V*omega_n*gamma3*I3*R*m */
    const double t76 = t68*t75; /* d(Theta)/d(gamma3)*V*omega_n*gamma3*I3*R*m */
    const double t77 = t76/t74; /* d(Theta)/d(gamma3)*V*omega_n*gamma3*I3*R*m/(s*Theta*Theta) */
    const double t78 = t71 + t77; /* t71 + d(Theta)/d(gamma3)*V*omega_n*gamma3*I3*R*m/(s*Theta*Theta) */
    const double t79 = t1*t44; /* gamma3*gamma3*I3*R*m */
    const double t80 = x[3]*t79; /* omega_n*gamma3*gamma3*I3*R*m */
    const double t81 = t12*t53; /* s*s*s*Theta */
    const double t82 = t56*t80; /* V*omega_n*gamma3*gamma3*I3*R*m */
    const double t83 = t82/t81; /* V*omega_n*gamma3*gamma3*I3*R*m/(s*s*s*Theta) */
    const double t84 = t78 - t83; /* t78 - V*omega_n*gamma3*gamma3*I3*R*m/(s*s*s*Theta) */
    const double t85 = x[2]*t51; /* omega_tau*I3*m*R*R */
    const double t86 = x[4]*t85; /* omega3*omega_tau*I3*m*R*R */
    const double t87 = t68*t86; /* d(Theta)/d(gamma3)*omega3*omega_tau*I3*m*R*R */
    const double t88 = t87/t63; /* d(Theta)/d(gamma3)*omega3*omega_tau*I3*m*R*R/(Theta*Theta) */
    const double t89 = t84 - t88; /* t78 - V*omega_n*gamma3*gamma3*I3*R*m/(s*s*s*Theta) - d(Theta)/d(gamma3)*omega3*omega_tau*I3*m*R*R/(Theta*Theta) */
    const double t90 = t73/t54; /* omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t91 = -t90; /* -omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t92 = x[4]*t60; /* omega3*I3*I3 */
    const double t93 = t92/t53; /* omega3*I3*I3/Theta */
    const double t94 = t31 + t93; /* gamma3*omega_n/s + omega3*I3*I3/Theta */
    const double t95 = x[3]*t66; /* omega_n*gamma3*I3*m*R*R */
    const double t96 = t95/t54; /* omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t97 = t94 - t96; /* gamma3*omega_n/s + omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t98 = x[4]*t51; /* omega3*I3*m*R*R */
    const double t99 = t98/t53; /* omega3*I3*m*R*R/Theta */
    const double t100 = t97 + t99; /* t97 + omega3*I3*m*R*R/Theta */
    const double t101 = t56*t72; /* V*gamma3*I3*R*m */
    const double t102 = t101/t54; /* V*gamma3*I3*R*m/(s*Theta) */
    const double t103 = t4 - t102; /* gamma3*omega_tau/s - V*gamma3*I3*R*m/(s*Theta) */
    const double t104 = t61/t53; /* omega_tau*I3*I3/Theta */
    const double t105 = t85/t53; /* omega_tau*I3*m*R*R/Theta */
    const double t106 = t104 + t105; /* omega_tau*I3*I3/Theta + omega_tau*I3*m*R*R/Theta */
    const double t107 = p[4]*t43; /* I1*R*m */
    const double t108 = x[3]*t107; /* omega_n*I1*R*m */
    const double t109 = t56*t108; /* V*omega_n*I1*R*m */
    const double t110 = t68*t109; /* d(Theta)/d(gamma3)*V*omega_n*I1*R*m */
    const double t111 = t110/t63; /* d(Theta)/d(gamma3)*V*omega_n*I1*R*m/(Theta*Theta) */
    const double t112 = x[2]*t47; /* omega_tau*m*R*R */
    const double t113 = x[4]*t112; /* omega3*omega_tau*m*R*R */
    const double t114 = t3*t113; /* s*omega3*omega_tau*m*R*R */
    const double t115 = t114*p[7]; /* s*omega3*omega_tau*m*R*R*(I1 - I3) */
    const double t116 = t115/t53; /* s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t117 = t111 + t116; /* d(Theta)/d(gamma3)*V*omega_n*I1*R*m/(Theta*Theta) + s*omega3*omega_tau*m*R*R*(I1 - I3)/Theta */
    const double t118 = x[0]*t47; /* gamma3*m*R*R */
    const double t119 = x[2]*t118; /* omega_tau*gamma3*m*R*R */
    const double t120 = x[4]*t119; /* omega3*omega_tau*gamma3*m*R*R */
    const double t121 = t3*t120; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t122 = p[7]*t121; /* (I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t123 = t68*t122; /* d(Theta)/d(gamma3)*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R */
    const double t124 = t123/t63; /* d(Theta)/d(gamma3)*(I1 - I3)*s*omega3*omega_tau*gamma3*m*R*R/(Theta*Theta) */
    const double t125 = t117 - t124; /* t117 - t124 */
    const double t126 = t1*t47; /* gamma3*gamma3*m*R*R */
    const double t127 = x[2]*t126; /* omega_tau*gamma3*gamma3*m*R*R */
    const double t128 = x[4]*t127; /* omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t129 = p[7]*t128; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t130 = t129/t54; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t131 = t125 - t130; /* t117 - t124 - (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t132 = t108/t53; /* omega_n*I1*R*m/Theta */
    const double t133 = -t132; /* -omega_n*I1*R*m/Theta */
    const double t134 = x[4]*t118; /* omega3*gamma3*m*R*R */
    const double t135 = t3*t134; /* s*omega3*gamma3*m*R*R */
    const double t136 = p[7]*t135; /* (I1 - I3)*s*omega3*gamma3*m*R*R */
    const double t137 = t136/t53; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta */
    const double t138 = x[3]*t48; /* omega_n*I1*m*R*R */
    const double t139 = t138/t53; /* omega_n*I1*m*R*R/Theta */
    const double t140 = t137 - t139; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta - omega_n*I1*m*R*R/Theta */
    const double t141 = t56*t107; /* V*I1*R*m */
    const double t142 = t141/t53; /* V*I1*R*m/Theta */
    const double t143 = -t142; /* -V*I1*R*m/Theta */
    const double t144 = t3*t119; /* s*omega_tau*gamma3*m*R*R */
    const double t145 = p[7]*t144; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R */
    const double t146 = t145/t53; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta */
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
    out[13] = t33;
    out[14] = t36;
    out[15] = t89;
    out[16] = t91;
    out[17] = t100;
    out[18] = t103;
    out[19] = t106;
    out[20] = t131;
    out[21] = t133;
    out[22] = t140;
    out[23] = t143;
    out[24] = t146;
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
    const double t14 = x[3]*p[5]; /* omega_n*I3 */
    const double t15 = x[4]*t14; /* omega3*omega_n*I3 */
    const double t16 = t15/p[4]; /* omega3*omega_n*I3/I1 */
    const double t17 = t13 - t16; /* -gamma3*omega_n*omega_n/s - omega3*omega_n*I3/I1 */
    const double t18 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t19 = x[3]*t18; /* omega_n*omega_tau*gamma3 */
    const double t20 = t19/t2; /* omega_n*omega_tau*gamma3/s */
    const double t21 = p[5]*p[5]; /* I3*I3 */
    const double t22 = x[2]*t21; /* omega_tau*I3*I3 */
    const double t23 = x[4]*t22; /* omega3*omega_tau*I3*I3 */
    const double t24 = p[1]*p[1]; /* R*R */
    const double t25 = p[0]*t24; /* m*R*R */
    const double t26 = p[4]*t25; /* I1*m*R*R */
    const double t27 = t2*t2; /* s*s */
    const double t28 = t26*t27; /* I1*m*R*R*s*s */
    const double t29 = p[6] + t28; /* I1*I3 + I1*m*R*R*s*s */
    const double t30 = p[5]*t25; /* I3*m*R*R */
    const double t31 = t0*t30; /* gamma3*gamma3*I3*m*R*R */
    const double t32 = t29 + t31; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t33 = t23/t32; /* omega3*omega_tau*I3*I3/Theta */
    const double t34 = t20 + t33; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta */
    const double t35 = p[1]*p[0]; /* R*m */
    const double t36 = p[5]*t35; /* I3*R*m */
    const double t37 = x[0]*t36; /* gamma3*I3*R*m */
    const double t38 = x[3]*t37; /* omega_n*gamma3*I3*R*m */
    const double t39 = t2*t32; /* s*Theta */
    const double t40 = x[2]*p[1]; /* omega_tau*R */
    const double t41 = x[1] + t40; /* V = v_nu + omega_tau*R */
    const double t42 = t38*t41; /* omega_n*gamma3*I3*R*m*V */
    const double t43 = t42/t39; /* omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t44 = t34 - t43; /* omega_n*omega_tau*gamma3/s + omega3*omega_tau*I3*I3/Theta - omega_n*gamma3*I3*R*m*V/(s*Theta) */
    const double t45 = x[2]*t30; /* omega_tau*I3*m*R*R */
    const double t46 = x[4]*t45; /* omega3*omega_tau*I3*m*R*R */
    const double t47 = t46/t32; /* omega3*omega_tau*I3*m*R*R/Theta */
    const double t48 = t44 + t47; /* t44 + omega3*omega_tau*I3*m*R*R/Theta */
    const double t49 = p[4]*t35; /* I1*R*m */
    const double t50 = x[3]*t49; /* omega_n*I1*R*m */
    const double t51 = t41*t50; /* V*omega_n*I1*R*m */
    const double t52 = t51/t32; /* V*omega_n*I1*R*m/Theta */
    const double t53 = x[0]*t25; /* gamma3*m*R*R */
    const double t54 = x[2]*t53; /* omega_tau*gamma3*m*R*R */
    const double t55 = x[4]*t54; /* omega3*omega_tau*gamma3*m*R*R */
    const double t56 = t2*t55; /* s*omega3*omega_tau*gamma3*m*R*R */
    const double t57 = t56*p[7]; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3) */
    const double t58 = t57/t32; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t59 = t58 - t52; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)/Theta - V*omega_n*I1*R*m/Theta */
    const double t60 = t18/t2; /* omega_tau*gamma3/s */
    const double t61 = -t60; /* -omega_tau*gamma3/s */
    const double t62 = p[1]*t7; /* R*omega_n*omega_n */
    const double t63 = t62/t2; /* R*omega_n*omega_n/s */
    const double t64 = t0*p[1]; /* gamma3*gamma3*R */
    const double t65 = t7*t64; /* omega_n*omega_n*gamma3*gamma3*R */
    const double t66 = t2*t27; /* s*s*s */
    const double t67 = t65/t66; /* omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t68 = t63 + t67; /* R*omega_n*omega_n/s + omega_n*omega_n*gamma3*gamma3*R/(s*s*s) */
    const double t69 = p[1]*x[4]; /* R*omega3 */
    const double t70 = x[3]*t6; /* omega_n*gamma3*R */
    const double t71 = t70/t2; /* omega_n*gamma3*R/s */
    const double t72 = t71*2.0; /* omega_n*gamma3*R/s*2 */
    const double t73 = t69 + t72; /* R*omega3 + omega_n*gamma3*R/s*2 */
    const double t74 = t7/t2; /* omega_n*omega_n/s */
    const double t75 = -t74; /* -omega_n*omega_n/s */
    const double t76 = t0*t7; /* gamma3*gamma3*omega_n*omega_n */
    const double t77 = t76/t66; /* gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t78 = t75 - t77; /* -omega_n*omega_n/s - gamma3*gamma3*omega_n*omega_n/(s*s*s) */
    const double t79 = x[4]*p[5]; /* omega3*I3 */
    const double t80 = t79/p[4]; /* omega3*I3/I1 */
    const double t81 = -t80; /* -omega3*I3/I1 */
    const double t82 = x[0]*x[3]; /* gamma3*omega_n */
    const double t83 = t82/t2; /* gamma3*omega_n/s */
    const double t84 = 2.0*t83; /* 2*gamma3*omega_n/s */
    const double t85 = t81 - t84; /* -omega3*I3/I1 - 2*gamma3*omega_n/s */
    const double t86 = t14/p[4]; /* omega_n*I3/I1 */
    const double t87 = -t86; /* -omega_n*I3/I1 */
    const double t88 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t89 = t88/t2; /* omega_tau*omega_n/s */
    const double t90 = x[2]*t0; /* omega_tau*gamma3*gamma3 */
    const double t91 = x[3]*t90; /* omega_n*omega_tau*gamma3*gamma3 */
    const double t92 = t91/t66; /* omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t93 = t89 + t92; /* omega_tau*omega_n/s + omega_n*omega_tau*gamma3*gamma3/(s*s*s) */
    const double t94 = x[3]*t36; /* omega_n*I3*R*m */
    const double t95 = t41*t94; /* V*omega_n*I3*R*m */
    const double t96 = t95/t39; /* V*omega_n*I3*R*m/(s*Theta) */
    const double t97 = t93 - t96; /* t93 - V*omega_n*I3*R*m/(s*Theta) */
    const double t98 = t32*t32; /* Theta*Theta */
    const double t99 = x[0]*t26; /* gamma3*I1*m*R*R */
    const double t100 = 2.0*t99; /* 2*gamma3*I1*m*R*R */
    const double t101 = x[0]*t30; /* gamma3*I3*m*R*R */
    const double t102 = 2.0*t101; /* 2*gamma3*I3*m*R*R */
    const double t103 = t102 - t100; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - 2*gamma3*I1*m*R*R */
    const double t104 = t23*t103; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3) */
    const double t105 = t104/t98; /* omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t106 = t97 - t105; /* t93 - V*omega_n*I3*R*m/(s*Theta) - omega3*omega_tau*I3*I3*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t107 = t2*t98; /* s*Theta*Theta */
    const double t108 = t42*t103; /* omega_n*gamma3*I3*R*m*V*d(Theta)/d(gamma3) */
    const double t109 = t108/t107; /* omega_n*gamma3*I3*R*m*V*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t110 = t106 + t109; /* t106 + omega_n*gamma3*I3*R*m*V*d(Theta)/d(gamma3)/(s*Theta*Theta) */
    const double t111 = t0*t36; /* gamma3*gamma3*I3*R*m */
    const double t112 = x[3]*t111; /* omega_n*gamma3*gamma3*I3*R*m */
    const double t113 = t32*t66; /* Theta*s*s*s */
    const double t114 = t41*t112; /* V*omega_n*gamma3*gamma3*I3*R*m */
    const double t115 = t114/t113; /* V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) */
    const double t116 = t110 - t115; /* t110 - V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) */
    const double t117 = t46*t103; /* omega3*omega_tau*I3*m*R*R*d(Theta)/d(gamma3) */
    const double t118 = t117/t98; /* omega3*omega_tau*I3*m*R*R*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t119 = t116 - t118; /* t110 - V*omega_n*gamma3*gamma3*I3*R*m/(Theta*s*s*s) - omega3*omega_tau*I3*m*R*R*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t120 = t38/t39; /* omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t121 = -t120; /* -omega_n*gamma3*I3*R*m/(s*Theta) */
    const double t122 = x[4]*t21; /* omega3*I3*I3 */
    const double t123 = t122/t32; /* omega3*I3*I3/Theta */
    const double t124 = t83 + t123; /* gamma3*omega_n/s + omega3*I3*I3/Theta */
    const double t125 = x[3]*t101; /* omega_n*gamma3*I3*m*R*R */
    const double t126 = t125/t39; /* omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t127 = t124 - t126; /* gamma3*omega_n/s + omega3*I3*I3/Theta - omega_n*gamma3*I3*m*R*R/(s*Theta) */
    const double t128 = x[4]*t30; /* omega3*I3*m*R*R */
    const double t129 = t128/t32; /* omega3*I3*m*R*R/Theta */
    const double t130 = t127 + t129; /* t127 + omega3*I3*m*R*R/Theta */
    const double t131 = t37*t41; /* gamma3*I3*R*m*V */
    const double t132 = t131/t39; /* gamma3*I3*R*m*V/(s*Theta) */
    const double t133 = t60 - t132; /* omega_tau*gamma3/s - gamma3*I3*R*m*V/(s*Theta) */
    const double t134 = t22/t32; /* omega_tau*I3*I3/Theta */
    const double t135 = t45/t32; /* omega_tau*I3*m*R*R/Theta */
    const double t136 = t134 + t135; /* omega_tau*I3*I3/Theta + omega_tau*I3*m*R*R/Theta */
    const double t137 = t51*t103; /* V*omega_n*I1*R*m*d(Theta)/d(gamma3) */
    const double t138 = t137/t98; /* V*omega_n*I1*R*m*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t139 = x[2]*t25; /* omega_tau*m*R*R */
    const double t140 = x[4]*t139; /* omega3*omega_tau*m*R*R */
    const double t141 = t2*t140; /* s*omega3*omega_tau*m*R*R */
    const double t142 = p[7]*t141; /* (I1 - I3)*s*omega3*omega_tau*m*R*R */
    const double t143 = t142/t32; /* (I1 - I3)*s*omega3*omega_tau*m*R*R/Theta */
    const double t144 = t138 + t143; /* V*omega_n*I1*R*m*d(Theta)/d(gamma3)/(Theta*Theta) + (I1 - I3)*s*omega3*omega_tau*m*R*R/Theta */
    const double t145 = t57*t103; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t146 = t145/t98; /* s*omega3*omega_tau*gamma3*m*R*R*(I1 - I3)*d(Theta)/d(gamma3)/(Theta*Theta) */
    const double t147 = t144 - t146; /* t144 - t146 */
    const double t148 = t0*t25; /* gamma3*gamma3*m*R*R */
    const double t149 = x[2]*t148; /* omega_tau*gamma3*gamma3*m*R*R */
    const double t150 = x[4]*t149; /* omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t151 = p[7]*t150; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R */
    const double t152 = t151/t39; /* (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t153 = t147 - t152; /* t144 - t146 - (I1 - I3)*omega3*omega_tau*gamma3*gamma3*m*R*R/(s*Theta) */
    const double t154 = t50/t32; /* omega_n*I1*R*m/Theta */
    const double t155 = -t154; /* -omega_n*I1*R*m/Theta */
    const double t156 = x[4]*t53; /* omega3*gamma3*m*R*R */
    const double t157 = t2*t156; /* s*omega3*gamma3*m*R*R */
    const double t158 = p[7]*t157; /* (I1 - I3)*s*omega3*gamma3*m*R*R */
    const double t159 = t158/t32; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta */
    const double t160 = x[3]*t26; /* omega_n*I1*m*R*R */
    const double t161 = t160/t32; /* omega_n*I1*m*R*R/Theta */
    const double t162 = t159 - t161; /* (I1 - I3)*s*omega3*gamma3*m*R*R/Theta - omega_n*I1*m*R*R/Theta */
    const double t163 = t41*t49; /* V*I1*R*m */
    const double t164 = t163/t32; /* V*I1*R*m/Theta */
    const double t165 = -t164; /* -V*I1*R*m/Theta */
    const double t166 = t2*t54; /* s*omega_tau*gamma3*m*R*R */
    const double t167 = p[7]*t166; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R */
    const double t168 = t167/t32; /* (I1 - I3)*s*omega_tau*gamma3*m*R*R/Theta */
    out[0] = t3;
    out[1] = t10;
    out[2] = t17;
    out[3] = t48;
    out[4] = t59;
    out[5] = t61;
    out[6] = 0.0;
    out[7] = t2;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = t68;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t73;
    out[14] = t4;
    out[15] = t78;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t85;
    out[19] = t87;
    out[20] = t119;
    out[21] = t121;
    out[22] = t130;
    out[23] = t133;
    out[24] = t136;
    out[25] = t153;
    out[26] = t155;
    out[27] = t162;
    out[28] = t165;
    out[29] = t168;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[1]; /* R*R */
    const double t1 = p[0]*t0; /* m*R*R */
    const double t2 = t1*x[0]; /* m*R*R*gamma3 */
    const double t3 = t2*x[2]; /* m*R*R*gamma3*omega_tau */
    const double t4 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t5 = 1.0 - t4; /* 1 - gamma3*gamma3 */
    const double t6 = sqrt(t5); /* s = sqrt(1 - gamma3*gamma3) */
    const double t7 = t3*t6; /* m*R*R*gamma3*omega_tau*s */
    const double t8 = t1*p[4]; /* m*R*R*I1 */
    const double t9 = t6*t6; /* s*s */
    const double t10 = t8*t9; /* m*R*R*I1*s*s */
    const double t11 = p[6] + t10; /* I1*I3 + m*R*R*I1*s*s */
    const double t12 = t1*p[5]; /* m*R*R*I3 */
    const double t13 = t4*t12; /* gamma3*gamma3*m*R*R*I3 */
    const double t14 = t11 + t13; /* Theta = I1*I3 + m*R*R*I1*s*s + gamma3*gamma3*m*R*R*I3 */
    const double t15 = t7*p[7]; /* m*R*R*gamma3*omega_tau*s*(I1 - I3) */
    const double t16 = t15/t14; /* m*R*R*gamma3*omega_tau*s*(I1 - I3)/Theta */
    const double t17 = p[0]*p[1]; /* m*R */
    const double t18 = p[5]*t17; /* I3*m*R */
    const double t19 = x[0]*t18; /* gamma3*I3*m*R */
    const double t20 = t6*t14; /* s*Theta */
    const double t21 = p[1]*x[2]; /* R*omega_tau */
    const double t22 = x[1] + t21; /* V = v_nu + R*omega_tau */
    const double t23 = t19*t22; /* gamma3*I3*m*R*V */
    const double t24 = t23/t20; /* gamma3*I3*m*R*V/(s*Theta) */
    const double t25 = t16 - t24; /* m*R*R*gamma3*omega_tau*s*(I1 - I3)/Theta - gamma3*I3*m*R*V/(s*Theta) */
    out[0] = t25;
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
    const double t7 = x[4]*x[4]; /* omega3*omega3 */
    const double t8 = p[5]*t7; /* I3*omega3*omega3 */
    const double t9 = (1.0 / 2.0)*t8; /* 1/2*I3*omega3*omega3 */
    const double t10 = t6 + t9; /* m*v_nu*v_nu*1/2 + 1/2*I1*omega_n*omega_n + 1/2*I3*omega3*omega3 */
    const double t11 = x[4]*p[1]; /* omega3*R */
    const double t12 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t13 = 1.0 - t12; /* 1 - gamma3*gamma3 */
    const double t14 = sqrt(t13); /* s = sqrt(1 - gamma3*gamma3) */
    const double t15 = t11*t14; /* omega3*R*s */
    const double t16 = p[1]*x[0]; /* R*gamma3 */
    const double t17 = x[3]*t16; /* omega_n*R*gamma3 */
    const double t18 = t15 + t17; /* v_tau = omega3*R*s + omega_n*R*gamma3 */
    const double t19 = t18*t18; /* v_tau*v_tau */
    const double t20 = p[0]*t19; /* m*v_tau*v_tau */
    const double t21 = (1.0 / 2.0)*t20; /* 1/2*m*v_tau*v_tau */
    const double t22 = t10 + t21; /* t10 + 1/2*m*v_tau*v_tau */
    const double t23 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t24 = p[4]*t23; /* I1*omega_tau*omega_tau */
    const double t25 = (1.0 / 2.0)*t24; /* 1/2*I1*omega_tau*omega_tau */
    const double t26 = t22 + t25; /* energy = t10 + 1/2*m*v_tau*v_tau + 1/2*I1*omega_tau*omega_tau */
    const double t27 = p[4]*p[1]; /* I1*R */
    const double t28 = x[3]*t27; /* omega_n*I1*R */
    const double t29 = t14*t28; /* s*omega_n*I1*R */
    const double t30 = p[5]*p[1]; /* I3*R */
    const double t31 = x[0]*t30; /* gamma3*I3*R */
    const double t32 = x[4]*t31; /* omega3*gamma3*I3*R */
    const double t33 = t29 - t32; /* s*omega_n*I1*R - omega3*gamma3*I3*R */
    const double t34 = p[4]*p[4]; /* I1*I1 */
    const double t35 = p[0]*t34; /* m*I1*I1 */
    const double t36 = p[1]*x[2]; /* R*omega_tau */
    const double t37 = x[1] + t36; /* v_nu + R*omega_tau */
    const double t38 = t37*t37; /* (v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t39 = t35*t38; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) */
    const double t40 = p[1]*p[1]; /* R*R */
    const double t41 = p[0]*t40; /* m*R*R */
    const double t42 = p[4]*t41; /* I1*m*R*R */
    const double t43 = t14*t14; /* s*s */
    const double t44 = t42*t43; /* I1*m*R*R*s*s */
    const double t45 = p[6] + t44; /* I1*I3 + I1*m*R*R*s*s */
    const double t46 = p[5]*t41; /* I3*m*R*R */
    const double t47 = t12*t46; /* gamma3*gamma3*I3*m*R*R */
    const double t48 = t45 + t47; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t49 = t7*t48; /* omega3*omega3*Theta */
    const double t50 = t49*p[7]; /* omega3*omega3*Theta*(I1 - I3) */
    const double t51 = t39 + t50; /* m*I1*I1*(v_nu + R*omega_tau)*(v_nu + R*omega_tau) + omega3*omega3*Theta*(I1 - I3) */
    out[0] = t26;
    out[1] = t33;
    out[2] = t51;
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
    const double t15 = p[4]*x[2]; /* I1*omega_tau */
    const double t16 = x[3]*p[4]; /* omega_n*I1 */
    const double t17 = p[0]*p[1]; /* m*R */
    const double t18 = x[0]*t17; /* gamma3*m*R */
    const double t19 = t7*t18; /* v_tau*gamma3*m*R */
    const double t20 = t16 + t19; /* d(energy)/d(omega_n) = omega_n*I1 + v_tau*gamma3*m*R */
    const double t21 = x[4]*p[5]; /* omega3*I3 */
    const double t22 = t3*t17; /* s*m*R */
    const double t23 = t7*t22; /* v_tau*s*m*R */
    const double t24 = t21 + t23; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    const double t25 = p[1]*p[4]; /* R*I1 */
    const double t26 = x[0]*t25; /* gamma3*R*I1 */
    const double t27 = x[3]*t26; /* omega_n*gamma3*R*I1 */
    const double t28 = t27/t3; /* omega_n*gamma3*R*I1/s */
    const double t29 = -t28; /* -omega_n*gamma3*R*I1/s */
    const double t30 = p[1]*p[5]; /* R*I3 */
    const double t31 = x[4]*t30; /* omega3*R*I3 */
    const double t32 = t29 - t31; /* -omega_n*gamma3*R*I1/s - omega3*R*I3 */
    const double t33 = t3*t25; /* s*R*I1 */
    const double t34 = x[0]*t30; /* gamma3*R*I3 */
    const double t35 = -t34; /* -gamma3*R*I3 */
    const double t36 = x[4]*x[4]; /* omega3*omega3 */
    const double t37 = t36*p[7]; /* omega3*omega3*(I1 - I3) */
    const double t38 = p[1]*p[1]; /* R*R */
    const double t39 = p[0]*t38; /* m*R*R */
    const double t40 = p[4]*t39; /* I1*m*R*R */
    const double t41 = x[0]*t40; /* gamma3*I1*m*R*R */
    const double t42 = t41*2.0; /* gamma3*I1*m*R*R*2 */
    const double t43 = p[5]*t39; /* I3*m*R*R */
    const double t44 = x[0]*t43; /* gamma3*I3*m*R*R */
    const double t45 = 2.0*t44; /* 2*gamma3*I3*m*R*R */
    const double t46 = t45 - t42; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - gamma3*I1*m*R*R*2 */
    const double t47 = t37*t46; /* omega3*omega3*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t48 = p[0]*2.0; /* m*2 */
    const double t49 = p[4]*p[4]; /* I1*I1 */
    const double t50 = t48*t49; /* m*2*I1*I1 */
    const double t51 = p[1]*x[2]; /* R*omega_tau */
    const double t52 = x[1] + t51; /* v_nu + R*omega_tau */
    const double t53 = t50*t52; /* m*2*I1*I1*(v_nu + R*omega_tau) */
    const double t54 = p[1]*t48; /* R*m*2 */
    const double t55 = t49*t54; /* I1*I1*R*m*2 */
    const double t56 = t52*t55; /* (v_nu + R*omega_tau)*I1*I1*R*m*2 */
    const double t57 = x[4]*2.0; /* omega3*2 */
    const double t58 = t3*t3; /* s*s */
    const double t59 = t40*t58; /* I1*m*R*R*s*s */
    const double t60 = p[6] + t59; /* I1*I3 + I1*m*R*R*s*s */
    const double t61 = t1*t43; /* gamma3*gamma3*I3*m*R*R */
    const double t62 = t60 + t61; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t63 = t57*t62; /* omega3*2*Theta */
    const double t64 = p[7]*t63; /* (I1 - I3)*omega3*2*Theta */
    out[0] = t13;
    out[1] = t14;
    out[2] = t15;
    out[3] = t20;
    out[4] = t24;
    out[5] = t32;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t33;
    out[9] = t35;
    out[10] = t47;
    out[11] = t53;
    out[12] = t56;
    out[13] = 0.0;
    out[14] = t64;
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
    const double t14 = params[5]*t9; /* I3*m*R*R */
    const double t15 = t4*t14; /* gamma3*gamma3*I3*m*R*R */
    const double t16 = t13 + t15; /* Theta = I3*I1 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t17 = t6*t16; /* s*Theta */
    const double t18 = t3/t17; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t19 = -t18; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t19;
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
    const double t11 = params[5]*t6; /* I3*m*R*R */
    const double t12 = t0*t11; /* gamma3*gamma3*I3*m*R*R */
    const double t13 = t10 + t12; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t14 = t3*t13; /* I1*s*Theta */
    const double t15 = params[0]*params[1]; /* m*R */
    const double t16 = params[4]*t15; /* I1*m*R */
    const double t17 = params[5]*t16; /* I3*I1*m*R */
    const double t18 = x[0]*t17; /* gamma3*I3*I1*m*R */
    const double t19 = t18*x[1]; /* gamma3*I3*I1*m*R*v_nu */
    const double t20 = params[5]*params[5]; /* I3*I3 */
    const double t21 = x[4]*x[4]; /* omega3*omega3 */
    const double t22 = t20*t21; /* I3*I3*omega3*omega3 */
    const double t23 = t2*t22; /* s*I3*I3*omega3*omega3 */
    const double t24 = params[5] + t6; /* I3 + m*R*R */
    const double t25 = t23*t24; /* s*I3*I3*omega3*omega3*(I3 + m*R*R) */
    out[0] = t14;
    out[1] = t19;
    out[2] = t25;
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
    const double t14 = params[5]*t9; /* I3*m*R*R */
    const double t15 = t0*t14; /* gamma3*gamma3*I3*m*R*R */
    const double t16 = t13 + t15; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t17 = params[5] + t9; /* I3 + m*R*R */
    const double t18 = t4*t17; /* omega3*I3*(I3 + m*R*R) */
    const double t19 = t18/t16; /* omega3*I3*(I3 + m*R*R)/Theta */
    const double t20 = params[1]*params[0]; /* R*m */
    const double t21 = params[5]*t20; /* I3*R*m */
    const double t22 = x[0]*t21; /* gamma3*I3*R*m */
    const double t23 = t22*x[1]; /* gamma3*I3*R*m*v_nu */
    const double t24 = t2*t16; /* s*Theta */
    const double t25 = t23/t24; /* gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t26 = -t25; /* -gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t27 = x[0]*t9; /* gamma3*m*R*R */
    const double t28 = x[4]*t27; /* omega3*gamma3*m*R*R */
    const double t29 = t2*t28; /* s*omega3*gamma3*m*R*R */
    const double t30 = params[4] - params[5]; /* I1 - I3 */
    const double t31 = t29*t30; /* s*omega3*gamma3*m*R*R*(I1 - I3) */
    const double t32 = t31/t16; /* s*omega3*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t33 = params[4]*t20; /* I1*R*m */
    const double t34 = x[1]*t33; /* v_nu*I1*R*m */
    const double t35 = t34/t16; /* v_nu*I1*R*m/Theta */
    const double t36 = -t35; /* -v_nu*I1*R*m/Theta */
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
    out[17] = t19;
    out[18] = t26;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = t32;
    out[23] = t36;
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
    const double t19 = params[1]*params[4]; /* R*I1 */
    const double t20 = params[1]*params[5]; /* R*I3 */
    const double t21 = x[4]*t20; /* omega3*R*I3 */
    const double t22 = -t21; /* -omega3*R*I3 */
    const double t23 = t3*t19; /* s*R*I1 */
    const double t24 = x[0]*t20; /* gamma3*R*I3 */
    const double t25 = -t24; /* -gamma3*R*I3 */
    const double t26 = x[4]*x[4]; /* omega3*omega3 */
    const double t27 = params[4] - params[5]; /* I1 - I3 */
    const double t28 = t26*t27; /* omega3*omega3*(I1 - I3) */
    const double t29 = params[1]*params[1]; /* R*R */
    const double t30 = params[0]*t29; /* m*R*R */
    const double t31 = params[4]*t30; /* I1*m*R*R */
    const double t32 = x[0]*t31; /* gamma3*I1*m*R*R */
    const double t33 = t32*2.0; /* gamma3*I1*m*R*R*2 */
    const double t34 = params[5]*t30; /* I3*m*R*R */
    const double t35 = x[0]*t34; /* gamma3*I3*m*R*R */
    const double t36 = 2.0*t35; /* 2*gamma3*I3*m*R*R */
    const double t37 = t36 - t33; /* d(Theta)/d(gamma3) = 2*gamma3*I3*m*R*R - gamma3*I1*m*R*R*2 */
    const double t38 = t28*t37; /* omega3*omega3*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t39 = params[0]*2.0; /* m*2 */
    const double t40 = params[4]*params[4]; /* I1*I1 */
    const double t41 = t39*t40; /* m*2*I1*I1 */
    const double t42 = x[1]*t41; /* v_nu*m*2*I1*I1 */
    const double t43 = params[1]*t39; /* R*m*2 */
    const double t44 = t40*t43; /* I1*I1*R*m*2 */
    const double t45 = x[1]*t44; /* v_nu*I1*I1*R*m*2 */
    const double t46 = x[4]*2.0; /* omega3*2 */
    const double t47 = params[4]*params[5]; /* I1*I3 */
    const double t48 = t3*t3; /* s*s */
    const double t49 = t31*t48; /* I1*m*R*R*s*s */
    const double t50 = t47 + t49; /* I1*I3 + I1*m*R*R*s*s */
    const double t51 = t1*t34; /* gamma3*gamma3*I3*m*R*R */
    const double t52 = t50 + t51; /* Theta = I1*I3 + I1*m*R*R*s*s + gamma3*gamma3*I3*m*R*R */
    const double t53 = t46*t52; /* omega3*2*Theta */
    const double t54 = t27*t53; /* (I1 - I3)*omega3*2*Theta */
    out[0] = t10;
    out[1] = t11;
    out[2] = 0.0;
    out[3] = t14;
    out[4] = t18;
    out[5] = t22;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t23;
    out[9] = t25;
    out[10] = t38;
    out[11] = t42;
    out[12] = t45;
    out[13] = 0.0;
    out[14] = t54;
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
};

const jlt_descriptor jlt_kernels_spherical_top_balanced = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 6, .block_count = 8,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 11, 39, 0, 9, 1, 0, 11, 10 }, { 12, 50, 0, 9, 1, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 25, { 31, 83, 0, 32, 1, 0, 14, 24 }, { 36, 168, 0, 34, 1, 0, 14, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 38, 89, 0, 41, 1, 0, 14, 32 }, { 44, 205, 0, 43, 1, 0, 14, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 5, 18, 0, 2, 1, 0, 10, 7 }, { 6, 24, 0, 2, 1, 0, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 11, 40, 0, 0, 1, 0, 10, 7 }, { 12, 45, 0, 0, 1, 0, 10, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 15, { 12, 50, 0, 2, 1, 0, 9, 9 }, { 15, 67, 0, 2, 1, 0, 9, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_baseline,
        &jlt_batch_spherical_top_balanced_avx2,
        &jlt_batch_spherical_top_balanced_avx512,
    },
};
