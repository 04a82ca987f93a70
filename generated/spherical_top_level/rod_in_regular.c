/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   24    0    5    0    0      8    7   (42)
 *  jacobian            12   58    0   12    0    0     12   13   (119)
 *  rhs_jacobian        16   62    0   17    0    0     12   17   (156)
 *  divergence          2    9    0    1    0    0      8    4   (15)
 *  integral_values     6   21    0    1    0    0      9    7   (35)
 *  integral_gradients  2   15    0    1    0    0      5    5   (25)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_rod_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = 0.0;
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
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = t0*params[5]; /* m*g*a3 */
    out[7] = t1;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[3]; /* R*I1 */
    const double t3 = p[6]*x[3]; /* G*v_tau */
    const double t4 = x[4]*t2; /* s*R*I1 */
    const double t5 = t3/t4; /* G*v_tau/(s*R*I1) */
    const double t6 = p[5]*p[5]; /* a3*a3 */
    const double t7 = p[0]*t6; /* m*a3*a3 */
    const double t8 = t7*x[0]; /* m*a3*a3*gamma3 */
    const double t9 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t10 = t8*t9; /* m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t11 = t0*t10; /* s*s*m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t12 = t0*t7; /* s*s*m*a3*a3 */
    const double t13 = p[3] + t12; /* D = I1 + s*s*m*a3*a3 */
    const double t14 = t11/t13; /* s*s*m*a3*a3*gamma3*omega_tau*omega_tau/D */
    const double t15 = p[0]*p[2]; /* m*g */
    const double t16 = p[5]*t15; /* a3*m*g */
    const double t17 = t0*t16; /* s*s*a3*m*g */
    const double t18 = t17/t13; /* s*s*a3*m*g/D */
    const double t19 = t14 - t18; /* s*s*m*a3*a3*gamma3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t20 = p[1]*p[1]; /* R*R */
    const double t21 = p[3]*t20; /* I1*R*R */
    const double t22 = p[6]*p[6]; /* G*G */
    const double t23 = x[0]*t22; /* gamma3*G*G */
    const double t24 = t0*t21; /* s*s*I1*R*R */
    const double t25 = t13*t24; /* D*s*s*I1*R*R */
    const double t26 = t23/t25; /* gamma3*G*G/(D*s*s*I1*R*R) */
    const double t27 = t19 - t26; /* s*s*m*a3*a3*gamma3*omega_tau*omega_tau/D - s*s*a3*m*g/D - gamma3*G*G/(D*s*s*I1*R*R) */
    const double t28 = p[6]*x[1]; /* G*v_nu */
    const double t29 = t28/t4; /* G*v_nu/(s*R*I1) */
    const double t30 = -t29; /* -G*v_nu/(s*R*I1) */
    const double t31 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t32 = x[4]*t31; /* s*omega_tau*gamma3 */
    const double t33 = -t32; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t5;
    out[2] = t27;
    out[3] = t30;
    out[4] = t33;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[4]*t1; /* s*2*omega_tau */
    const double t3 = p[1]*p[3]; /* R*I1 */
    const double t4 = x[4]*t3; /* s*R*I1 */
    const double t5 = p[6]/t4; /* G/(s*R*I1) */
    const double t6 = p[6]*x[3]; /* G*v_tau */
    const double t7 = t0*t3; /* s*s*R*I1 */
    const double t8 = t6/t7; /* G*v_tau/(s*s*R*I1) */
    const double t9 = -t8; /* -G*v_tau/(s*s*R*I1) */
    const double t10 = p[5]*p[5]; /* a3*a3 */
    const double t11 = p[0]*t10; /* m*a3*a3 */
    const double t12 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t13 = t11*t12; /* m*a3*a3*omega_tau*omega_tau */
    const double t14 = t0*t13; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t15 = t0*t11; /* s*s*m*a3*a3 */
    const double t16 = p[3] + t15; /* D = I1 + s*s*m*a3*a3 */
    const double t17 = t14/t16; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t18 = p[1]*p[1]; /* R*R */
    const double t19 = p[3]*t18; /* I1*R*R */
    const double t20 = p[6]*p[6]; /* G*G */
    const double t21 = t0*t19; /* s*s*I1*R*R */
    const double t22 = t16*t21; /* D*s*s*I1*R*R */
    const double t23 = t20/t22; /* G*G/(D*s*s*I1*R*R) */
    const double t24 = t17 - t23; /* s*s*m*a3*a3*omega_tau*omega_tau/D - G*G/(D*s*s*I1*R*R) */
    const double t25 = 2.0*p[0]; /* 2*m */
    const double t26 = t10*t25; /* a3*a3*2*m */
    const double t27 = t26*x[0]; /* a3*a3*2*m*gamma3 */
    const double t28 = x[2]*t27; /* omega_tau*a3*a3*2*m*gamma3 */
    const double t29 = t0*t28; /* s*s*omega_tau*a3*a3*2*m*gamma3 */
    const double t30 = t29/t16; /* s*s*omega_tau*a3*a3*2*m*gamma3/D */
    const double t31 = t11*x[0]; /* m*a3*a3*gamma3 */
    const double t32 = t12*t31; /* omega_tau*omega_tau*m*a3*a3*gamma3 */
    const double t33 = x[4]*t32; /* s*omega_tau*omega_tau*m*a3*a3*gamma3 */
    const double t34 = t33/t16; /* s*omega_tau*omega_tau*m*a3*a3*gamma3/D */
    const double t35 = 2.0*t34; /* 2*s*omega_tau*omega_tau*m*a3*a3*gamma3/D */
    const double t36 = p[0]*p[2]; /* m*g */
    const double t37 = p[5]*t36; /* a3*m*g */
    const double t38 = x[4]*t37; /* s*a3*m*g */
    const double t39 = t38/t16; /* s*a3*m*g/D */
    const double t40 = 2.0*t39; /* 2*s*a3*m*g/D */
    const double t41 = t35 - t40; /* 2*s*omega_tau*omega_tau*m*a3*a3*gamma3/D - 2*s*a3*m*g/D */
    const double t42 = p[0]*p[0]; /* m*m */
    const double t43 = t10*t10; /* a3*a3*a3*a3 */
    const double t44 = t42*t43; /* m*m*a3*a3*a3*a3 */
    const double t45 = x[0]*t44; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t46 = t12*t45; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t47 = x[4]*t0; /* s*s*s */
    const double t48 = t46*t47; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t49 = t16*t16; /* D*D */
    const double t50 = t48/t49; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t51 = 2.0*t50; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t52 = t41 - t51; /* 2*s*omega_tau*omega_tau*m*a3*a3*gamma3/D - 2*s*a3*m*g/D - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t53 = p[2]*t42; /* g*m*m */
    const double t54 = p[5]*t10; /* a3*a3*a3 */
    const double t55 = t53*t54; /* g*m*m*a3*a3*a3 */
    const double t56 = t47*t55; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t57 = t56/t49; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t58 = 2.0*t57; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t59 = t52 + t58; /* t52 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t60 = t20*x[0]; /* G*G*gamma3 */
    const double t61 = t19*t47; /* I1*R*R*s*s*s */
    const double t62 = t16*t61; /* D*I1*R*R*s*s*s */
    const double t63 = t60/t62; /* G*G*gamma3/(D*I1*R*R*s*s*s) */
    const double t64 = 2.0*t63; /* 2*G*G*gamma3/(D*I1*R*R*s*s*s) */
    const double t65 = t59 + t64; /* t52 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*G*G*gamma3/(D*I1*R*R*s*s*s) */
    const double t66 = t11*t20; /* m*a3*a3*G*G */
    const double t67 = x[0]*t66; /* gamma3*m*a3*a3*G*G */
    const double t68 = x[4]*t19; /* s*I1*R*R */
    const double t69 = t49*t68; /* D*D*s*I1*R*R */
    const double t70 = t67/t69; /* gamma3*m*a3*a3*G*G/(D*D*s*I1*R*R) */
    const double t71 = 2.0*t70; /* 2*gamma3*m*a3*a3*G*G/(D*D*s*I1*R*R) */
    const double t72 = t65 + t71; /* t65 + 2*gamma3*m*a3*a3*G*G/(D*D*s*I1*R*R) */
    const double t73 = -t5; /* -G/(s*R*I1) */
    const double t74 = p[6]*x[1]; /* G*v_nu */
    const double t75 = t74/t7; /* G*v_nu/(s*s*R*I1) */
    const double t76 = x[4]*x[2]; /* s*omega_tau */
    const double t77 = -t76; /* -s*omega_tau */
    const double t78 = x[4]*x[0]; /* s*gamma3 */
    const double t79 = -t78; /* -s*gamma3 */
    const double t80 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t81 = -t80; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t5;
    out[9] = t9;
    out[10] = t24;
    out[11] = 0.0;
    out[12] = t30;
    out[13] = 0.0;
    out[14] = t72;
    out[15] = 0.0;
    out[16] = t73;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t75;
    out[20] = t77;
    out[21] = 0.0;
    out[22] = t79;
    out[23] = 0.0;
    out[24] = t81;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[3]; /* R*I1 */
    const double t3 = p[6]*x[3]; /* G*v_tau */
    const double t4 = x[4]*t2; /* s*R*I1 */
    const double t5 = t3/t4; /* G*v_tau/(s*R*I1) */
    const double t6 = p[5]*p[5]; /* a3*a3 */
    const double t7 = p[0]*t6; /* m*a3*a3 */
    const double t8 = t7*x[0]; /* m*a3*a3*gamma3 */
    const double t9 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t10 = t8*t9; /* m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t11 = t0*t10; /* s*s*m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t12 = t0*t7; /* s*s*m*a3*a3 */
    const double t13 = p[3] + t12; /* D = I1 + s*s*m*a3*a3 */
    const double t14 = t11/t13; /* s*s*m*a3*a3*gamma3*omega_tau*omega_tau/D */
    const double t15 = p[0]*p[2]; /* m*g */
    const double t16 = p[5]*t15; /* a3*m*g */
    const double t17 = t0*t16; /* s*s*a3*m*g */
    const double t18 = t17/t13; /* s*s*a3*m*g/D */
    const double t19 = t14 - t18; /* s*s*m*a3*a3*gamma3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t20 = p[1]*p[1]; /* R*R */
    const double t21 = p[3]*t20; /* I1*R*R */
    const double t22 = p[6]*p[6]; /* G*G */
    const double t23 = x[0]*t22; /* gamma3*G*G */
    const double t24 = t0*t21; /* s*s*I1*R*R */
    const double t25 = t13*t24; /* D*s*s*I1*R*R */
    const double t26 = t23/t25; /* gamma3*G*G/(D*s*s*I1*R*R) */
    const double t27 = t19 - t26; /* s*s*m*a3*a3*gamma3*omega_tau*omega_tau/D - s*s*a3*m*g/D - gamma3*G*G/(D*s*s*I1*R*R) */
    const double t28 = p[6]*x[1]; /* G*v_nu */
    const double t29 = t28/t4; /* G*v_nu/(s*R*I1) */
    const double t30 = -t29; /* -G*v_nu/(s*R*I1) */
    const double t31 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t32 = -t31; /* -omega_tau*gamma3 */
    const double t33 = x[4]*t31; /* s*omega_tau*gamma3 */
    const double t34 = -t33; /* -s*omega_tau*gamma3 */
    const double t35 = x[2]*2.0; /* omega_tau*2 */
    const double t36 = x[4]*t35; /* s*omega_tau*2 */
    const double t37 = p[6]/t4; /* G/(s*R*I1) */
    const double t38 = t0*t2; /* s*s*R*I1 */
    const double t39 = t3/t38; /* G*v_tau/(s*s*R*I1) */
    const double t40 = -t39; /* -G*v_tau/(s*s*R*I1) */
    const double t41 = t7*t9; /* m*a3*a3*omega_tau*omega_tau */
    const double t42 = t0*t41; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t43 = t42/t13; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t44 = t22/t25; /* G*G/(D*s*s*I1*R*R) */
    const double t45 = t43 - t44; /* s*s*m*a3*a3*omega_tau*omega_tau/D - G*G/(D*s*s*I1*R*R) */
    const double t46 = p[0]*2.0; /* m*2 */
    const double t47 = t6*t46; /* a3*a3*m*2 */
    const double t48 = x[0]*t47; /* gamma3*a3*a3*m*2 */
    const double t49 = x[2]*t48; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t50 = t0*t49; /* s*s*omega_tau*gamma3*a3*a3*m*2 */
    const double t51 = t50/t13; /* s*s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t52 = x[4]*t10; /* s*m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t53 = t52/t13; /* s*m*a3*a3*gamma3*omega_tau*omega_tau/D */
    const double t54 = 2.0*t53; /* 2*s*m*a3*a3*gamma3*omega_tau*omega_tau/D */
    const double t55 = x[4]*t16; /* s*a3*m*g */
    const double t56 = t55/t13; /* s*a3*m*g/D */
    const double t57 = 2.0*t56; /* 2*s*a3*m*g/D */
    const double t58 = t54 - t57; /* 2*s*m*a3*a3*gamma3*omega_tau*omega_tau/D - 2*s*a3*m*g/D */
    const double t59 = p[0]*p[0]; /* m*m */
    const double t60 = t6*t6; /* a3*a3*a3*a3 */
    const double t61 = t59*t60; /* m*m*a3*a3*a3*a3 */
    const double t62 = x[0]*t61; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t63 = t9*t62; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t64 = x[4]*t0; /* s*s*s */
    const double t65 = t63*t64; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t66 = t13*t13; /* D*D */
    const double t67 = t65/t66; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t68 = 2.0*t67; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t69 = t58 - t68; /* 2*s*m*a3*a3*gamma3*omega_tau*omega_tau/D - 2*s*a3*m*g/D - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t70 = p[2]*t59; /* g*m*m */
    const double t71 = p[5]*t6; /* a3*a3*a3 */
    const double t72 = t70*t71; /* g*m*m*a3*a3*a3 */
    const double t73 = t64*t72; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t74 = t73/t66; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t75 = 2.0*t74; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t76 = t69 + t75; /* t69 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t77 = t21*t64; /* I1*R*R*s*s*s */
    const double t78 = t13*t77; /* D*I1*R*R*s*s*s */
    const double t79 = t23/t78; /* gamma3*G*G/(D*I1*R*R*s*s*s) */
    const double t80 = 2.0*t79; /* 2*gamma3*G*G/(D*I1*R*R*s*s*s) */
    const double t81 = t76 + t80; /* t69 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*gamma3*G*G/(D*I1*R*R*s*s*s) */
    const double t82 = t7*t22; /* m*a3*a3*G*G */
    const double t83 = x[0]*t82; /* gamma3*m*a3*a3*G*G */
    const double t84 = x[4]*t21; /* s*I1*R*R */
    const double t85 = t66*t84; /* D*D*s*I1*R*R */
    const double t86 = t83/t85; /* gamma3*m*a3*a3*G*G/(D*D*s*I1*R*R) */
    const double t87 = 2.0*t86; /* 2*gamma3*m*a3*a3*G*G/(D*D*s*I1*R*R) */
    const double t88 = t81 + t87; /* t81 + 2*gamma3*m*a3*a3*G*G/(D*D*s*I1*R*R) */
    const double t89 = -t37; /* -G/(s*R*I1) */
    const double t90 = t28/t38; /* G*v_nu/(s*s*R*I1) */
    const double t91 = x[2]*x[4]; /* omega_tau*s */
    const double t92 = -t91; /* -omega_tau*s */
    const double t93 = x[4]*x[0]; /* s*gamma3 */
    const double t94 = -t93; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t5;
    out[2] = t27;
    out[3] = t30;
    out[4] = t34;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t36;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t37;
    out[14] = t40;
    out[15] = t45;
    out[16] = 0.0;
    out[17] = t51;
    out[18] = 0.0;
    out[19] = t88;
    out[20] = 0.0;
    out[21] = t89;
    out[22] = 0.0;
    out[23] = 0.0;
    out[24] = t90;
    out[25] = t92;
    out[26] = 0.0;
    out[27] = t94;
    out[28] = 0.0;
    out[29] = t32;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[5]*p[5]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = t2*x[2]; /* m*a3*a3*gamma3*omega_tau */
    const double t4 = x[4]*x[4]; /* s*s */
    const double t5 = t3*t4; /* m*a3*a3*gamma3*omega_tau*s*s */
    const double t6 = t1*t4; /* m*a3*a3*s*s */
    const double t7 = p[3] + t6; /* D = I1 + m*a3*a3*s*s */
    const double t8 = t5/t7; /* m*a3*a3*gamma3*omega_tau*s*s/D */
    const double t9 = t8*2.0; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 */
    const double t10 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t11 = t9 - t10; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 - gamma3*omega_tau */
    out[0] = t11;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[2]; /* m*g */
    const double t1 = t0*p[5]; /* m*g*a3 */
    const double t2 = t1*x[0]; /* m*g*a3*gamma3 */
    const double t3 = x[1]*x[1]; /* v_nu*v_nu */
    const double t4 = p[0]*t3; /* m*v_nu*v_nu */
    const double t5 = t4*(1.0 / 2.0); /* m*v_nu*v_nu*1/2 */
    const double t6 = t2 + t5; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 */
    const double t7 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t8 = p[5]*p[5]; /* a3*a3 */
    const double t9 = p[0]*t8; /* m*a3*a3 */
    const double t10 = x[4]*x[4]; /* s*s */
    const double t11 = t9*t10; /* m*a3*a3*s*s */
    const double t12 = p[3] + t11; /* D = I1 + m*a3*a3*s*s */
    const double t13 = t7*t12; /* omega_tau*omega_tau*D */
    const double t14 = (1.0 / 2.0)*t13; /* 1/2*omega_tau*omega_tau*D */
    const double t15 = t6 + t14; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D */
    const double t16 = x[3]*x[3]; /* v_tau*v_tau */
    const double t17 = p[0]*t16; /* m*v_tau*v_tau */
    const double t18 = (1.0 / 2.0)*t17; /* 1/2*m*v_tau*v_tau */
    const double t19 = t15 + t18; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*m*v_tau*v_tau */
    const double t20 = p[1]*p[1]; /* R*R */
    const double t21 = p[3]*t20; /* I1*R*R */
    const double t22 = p[6]*p[6]; /* G*G */
    const double t23 = t10*t21; /* s*s*I1*R*R */
    const double t24 = t22/t23; /* G*G/(s*s*I1*R*R) */
    const double t25 = (1.0 / 2.0)*t24; /* 1/2*G*G/(s*s*I1*R*R) */
    const double t26 = t19 + t25; /* t19 + 1/2*G*G/(s*s*I1*R*R) */
    const double t27 = t5 + t18; /* m*v_nu*v_nu*1/2 + 1/2*m*v_tau*v_tau */
    out[0] = t26;
    out[1] = t27;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    const double t1 = p[5]*p[5]; /* a3*a3 */
    const double t2 = p[0]*t1; /* m*a3*a3 */
    const double t3 = x[4]*x[4]; /* s*s */
    const double t4 = t2*t3; /* m*a3*a3*s*s */
    const double t5 = p[3] + t4; /* D = I1 + m*a3*a3*s*s */
    const double t6 = x[2]*t5; /* omega_tau*D */
    const double t7 = p[0]*x[3]; /* m*v_tau */
    const double t8 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t9 = t2*t8; /* m*a3*a3*omega_tau*omega_tau */
    const double t10 = x[4]*t9; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t11 = p[1]*p[1]; /* R*R */
    const double t12 = p[3]*t11; /* I1*R*R */
    const double t13 = p[6]*p[6]; /* G*G */
    const double t14 = x[4]*t3; /* s*s*s */
    const double t15 = t12*t14; /* I1*R*R*s*s*s */
    const double t16 = t13/t15; /* G*G/(I1*R*R*s*s*s) */
    const double t17 = t10 - t16; /* s*m*a3*a3*omega_tau*omega_tau - G*G/(I1*R*R*s*s*s) */
    out[0] = p[7];
    out[1] = t0;
    out[2] = t6;
    out[3] = t7;
    out[4] = t17;
    out[5] = 0.0;
    out[6] = t0;
    out[7] = 0.0;
    out[8] = t7;
    out[9] = 0.0;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_v_tau = x[3];
    const double v_R = params[1];
    const double v_I1 = params[3];
    const double v_I3 = (0.0);
    const double v_a3 = params[5];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_K = (v_R*v_R*v_I1*v_s*v_s + v_I3*v_b*v_b);
    const double v_G = params[6];
    const double complex v_omega_n = ((v_R*v_G*v_s + v_I3*v_v_tau*v_b)/v_K);
    out[1] = (v_s)*((v_v_tau*v_omega_n/v_s));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double complex v_omega3 = ((v_R*v_I1*v_v_tau*v_s - v_G*v_b)/v_K);
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_v_nu = x[1];
    const double complex v_Theta = (v_m*v_K + v_I1*v_I3);
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((-v_v_nu*v_omega_n/v_s)
        + (v_I1*v_I3*v_V*v_omega_n/(v_s*v_Theta))
        + (-v_I3*v_omega_tau*v_omega3*(v_R*v_gamma3*(v_I1 - v_I3) - v_I3*v_a3)/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0) },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "E1", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_rod_in_regular = {
    .model = "spherical_top_level",
    .variant = "rod",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 8,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 5, 24, 0, 5, 0, 0, 8, 7 }, { 5, 32, 0, 5, 0, 0, 8, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .jacobian = { jacobian, 25, { 12, 58, 0, 12, 0, 0, 12, 13 }, { 12, 94, 0, 13, 0, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 16, 62, 0, 17, 0, 0, 12, 17 }, { 16, 122, 0, 18, 0, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .divergence = { divergence, 1, { 2, 9, 0, 1, 0, 0, 8, 4 }, { 2, 12, 0, 1, 0, 0, 8, 4 },
        "" },
    .integral_values = { integral_values, 2, { 6, 21, 0, 1, 0, 0, 9, 7 }, { 6, 28, 0, 1, 0, 0, 9, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 10, { 2, 15, 0, 1, 0, 0, 5, 5 }, { 2, 22, 0, 1, 0, 0, 5, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_rod_in_regular_baseline,
        &jlt_batch_spherical_top_level_rod_in_regular_avx2,
        &jlt_batch_spherical_top_level_rod_in_regular_avx512,
    },
};
