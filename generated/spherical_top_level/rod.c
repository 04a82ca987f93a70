/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top_level, SHA-256 10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   24    0    5    1    0      9    8   (42)
 *  jacobian            11   59    0   13    1    0     15   15   (126)
 *  rhs_jacobian        14   67    0   18    1    0     15   19   (160)
 *  divergence          3   10    0    2    1    0      9    5   (18)
 *  integral_values     7   22    0    1    1    0     11    7   (38)
 *  integral_gradients  4   17    0    1    1    0      8    7   (30)
 *  measure_values      2    5    0    1    1    0      7    4   (9)
 *  measure_divergences 5   16    0    5    1    0     12    7   (33)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_rod;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_rod_avx512;

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
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[3]; /* R*I1 */
    const double t5 = p[6]*x[3]; /* G*v_tau */
    const double t6 = t2*t2; /* s*s */
    const double t7 = t4*t6; /* R*I1*s*s */
    const double t8 = t5/t7; /* G*v_tau/(R*I1*s*s) */
    const double t9 = p[5]*p[5]; /* a3*a3 */
    const double t10 = p[0]*t9; /* m*a3*a3 */
    const double t11 = x[0]*t10; /* gamma3*m*a3*a3 */
    const double t12 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t13 = t11*t12; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t14 = t2*t13; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t15 = t6*t10; /* s*s*m*a3*a3 */
    const double t16 = p[3] + t15; /* D = I1 + s*s*m*a3*a3 */
    const double t17 = t14/t16; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t18 = p[0]*p[2]; /* m*g */
    const double t19 = p[5]*t18; /* a3*m*g */
    const double t20 = t2*t19; /* s*a3*m*g */
    const double t21 = t20/t16; /* s*a3*m*g/D */
    const double t22 = t17 - t21; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D */
    const double t23 = p[1]*p[1]; /* R*R */
    const double t24 = p[3]*t23; /* I1*R*R */
    const double t25 = p[6]*p[6]; /* G*G */
    const double t26 = x[0]*t25; /* gamma3*G*G */
    const double t27 = t2*t6; /* s*s*s */
    const double t28 = t24*t27; /* I1*R*R*s*s*s */
    const double t29 = t16*t28; /* D*I1*R*R*s*s*s */
    const double t30 = t26/t29; /* gamma3*G*G/(D*I1*R*R*s*s*s) */
    const double t31 = t22 - t30; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - gamma3*G*G/(D*I1*R*R*s*s*s) */
    const double t32 = p[6]*x[1]; /* G*v_nu */
    const double t33 = t32/t7; /* G*v_nu/(R*I1*s*s) */
    const double t34 = -t33; /* -G*v_nu/(R*I1*s*s) */
    out[0] = t3;
    out[1] = t8;
    out[2] = t31;
    out[3] = t34;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = -t4; /* -gamma3*omega_tau/s */
    const double t6 = p[1]*p[3]; /* R*I1 */
    const double t7 = 2.0*p[6]; /* 2*G */
    const double t8 = x[0]*t7; /* gamma3*2*G */
    const double t9 = t8*x[3]; /* gamma3*2*G*v_tau */
    const double t10 = t3*t3; /* s*s */
    const double t11 = t10*t10; /* s*s*s*s */
    const double t12 = t6*t11; /* R*I1*s*s*s*s */
    const double t13 = t9/t12; /* gamma3*2*G*v_tau/(R*I1*s*s*s*s) */
    const double t14 = t6*t10; /* R*I1*s*s */
    const double t15 = p[6]/t14; /* G/(R*I1*s*s) */
    const double t16 = p[5]*p[5]; /* a3*a3 */
    const double t17 = p[0]*t16; /* m*a3*a3 */
    const double t18 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t19 = t17*t18; /* m*a3*a3*omega_tau*omega_tau */
    const double t20 = t3*t19; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t21 = t10*t17; /* s*s*m*a3*a3 */
    const double t22 = p[3] + t21; /* D = I1 + s*s*m*a3*a3 */
    const double t23 = t20/t22; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t24 = t1*t17; /* gamma3*gamma3*m*a3*a3 */
    const double t25 = t18*t24; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t26 = t3*t22; /* s*D */
    const double t27 = t25/t26; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t28 = t23 - t27; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t29 = p[0]*p[0]; /* m*m */
    const double t30 = t16*t16; /* a3*a3*a3*a3 */
    const double t31 = t29*t30; /* m*m*a3*a3*a3*a3 */
    const double t32 = t1*t31; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t33 = t18*t32; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t34 = t3*t33; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t35 = t22*t22; /* D*D */
    const double t36 = t34/t35; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t37 = 2.0*t36; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t38 = t28 + t37; /* t28 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t39 = p[0]*p[2]; /* m*g */
    const double t40 = p[5]*t39; /* a3*m*g */
    const double t41 = x[0]*t40; /* gamma3*a3*m*g */
    const double t42 = t41/t26; /* gamma3*a3*m*g/(s*D) */
    const double t43 = t38 + t42; /* t38 + gamma3*a3*m*g/(s*D) */
    const double t44 = t29*p[2]; /* m*m*g */
    const double t45 = p[5]*t16; /* a3*a3*a3 */
    const double t46 = t44*t45; /* m*m*g*a3*a3*a3 */
    const double t47 = x[0]*t46; /* gamma3*m*m*g*a3*a3*a3 */
    const double t48 = t3*t47; /* s*gamma3*m*m*g*a3*a3*a3 */
    const double t49 = t48/t35; /* s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t50 = 2.0*t49; /* 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t51 = t43 - t50; /* t38 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) */
    const double t52 = p[1]*p[1]; /* R*R */
    const double t53 = p[3]*t52; /* I1*R*R */
    const double t54 = p[6]*p[6]; /* G*G */
    const double t55 = t3*t10; /* s*s*s */
    const double t56 = t53*t55; /* I1*R*R*s*s*s */
    const double t57 = t22*t56; /* D*I1*R*R*s*s*s */
    const double t58 = t54/t57; /* G*G/(D*I1*R*R*s*s*s) */
    const double t59 = t51 - t58; /* t38 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*m*m*g*a3*a3*a3/(D*D) - G*G/(D*I1*R*R*s*s*s) */
    const double t60 = t1*t54; /* gamma3*gamma3*G*G */
    const double t61 = t3*t11; /* s*s*s*s*s */
    const double t62 = t53*t61; /* I1*R*R*s*s*s*s*s */
    const double t63 = t22*t62; /* D*I1*R*R*s*s*s*s*s */
    const double t64 = t60/t63; /* gamma3*gamma3*G*G/(D*I1*R*R*s*s*s*s*s) */
    const double t65 = t64*3.0; /* gamma3*gamma3*G*G/(D*I1*R*R*s*s*s*s*s)*3 */
    const double t66 = t59 - t65; /* t59 - gamma3*gamma3*G*G/(D*I1*R*R*s*s*s*s*s)*3 */
    const double t67 = t17*t54; /* m*a3*a3*G*G */
    const double t68 = t1*t67; /* gamma3*gamma3*m*a3*a3*G*G */
    const double t69 = t35*t56; /* D*D*I1*R*R*s*s*s */
    const double t70 = t68/t69; /* gamma3*gamma3*m*a3*a3*G*G/(D*D*I1*R*R*s*s*s) */
    const double t71 = 2.0*t70; /* 2*gamma3*gamma3*m*a3*a3*G*G/(D*D*I1*R*R*s*s*s) */
    const double t72 = t66 - t71; /* t59 - gamma3*gamma3*G*G/(D*I1*R*R*s*s*s*s*s)*3 - 2*gamma3*gamma3*m*a3*a3*G*G/(D*D*I1*R*R*s*s*s) */
    const double t73 = 2.0*p[0]; /* 2*m */
    const double t74 = t16*t73; /* a3*a3*2*m */
    const double t75 = x[0]*t74; /* gamma3*a3*a3*2*m */
    const double t76 = x[2]*t75; /* omega_tau*gamma3*a3*a3*2*m */
    const double t77 = t3*t76; /* s*omega_tau*gamma3*a3*a3*2*m */
    const double t78 = t77/t22; /* s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t79 = p[6]*(-2.0); /* G*(-2) */
    const double t80 = x[0]*t79; /* gamma3*G*(-2) */
    const double t81 = t80*x[1]; /* gamma3*G*(-2)*v_nu */
    const double t82 = t81/t12; /* gamma3*G*(-2)*v_nu/(R*I1*s*s*s*s) */
    const double t83 = -t15; /* -G/(R*I1*s*s) */
    out[0] = t5;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = t13;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t15;
    out[8] = t72;
    out[9] = 0.0;
    out[10] = t78;
    out[11] = 0.0;
    out[12] = t82;
    out[13] = t83;
    out[14] = 0.0;
    out[15] = 0.0;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = p[1]*p[3]; /* R*I1 */
    const double t5 = p[6]*x[3]; /* G*v_tau */
    const double t6 = t2*t2; /* s*s */
    const double t7 = t4*t6; /* R*I1*s*s */
    const double t8 = t5/t7; /* G*v_tau/(R*I1*s*s) */
    const double t9 = p[5]*p[5]; /* a3*a3 */
    const double t10 = p[0]*t9; /* m*a3*a3 */
    const double t11 = x[0]*t10; /* gamma3*m*a3*a3 */
    const double t12 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t13 = t11*t12; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t14 = t2*t13; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t15 = t6*t10; /* s*s*m*a3*a3 */
    const double t16 = p[3] + t15; /* D = I1 + s*s*m*a3*a3 */
    const double t17 = t14/t16; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t18 = p[0]*p[2]; /* m*g */
    const double t19 = p[5]*t18; /* a3*m*g */
    const double t20 = t2*t19; /* s*a3*m*g */
    const double t21 = t20/t16; /* s*a3*m*g/D */
    const double t22 = t17 - t21; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D */
    const double t23 = p[1]*p[1]; /* R*R */
    const double t24 = p[3]*t23; /* I1*R*R */
    const double t25 = p[6]*p[6]; /* G*G */
    const double t26 = x[0]*t25; /* gamma3*G*G */
    const double t27 = t2*t6; /* s*s*s */
    const double t28 = t24*t27; /* I1*R*R*s*s*s */
    const double t29 = t16*t28; /* D*I1*R*R*s*s*s */
    const double t30 = t26/t29; /* gamma3*G*G/(D*I1*R*R*s*s*s) */
    const double t31 = t22 - t30; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*a3*m*g/D - gamma3*G*G/(D*I1*R*R*s*s*s) */
    const double t32 = p[6]*x[1]; /* G*v_nu */
    const double t33 = t32/t7; /* G*v_nu/(R*I1*s*s) */
    const double t34 = -t33; /* -G*v_nu/(R*I1*s*s) */
    const double t35 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t36 = t35/t2; /* omega_tau*gamma3/s */
    const double t37 = -t36; /* -omega_tau*gamma3/s */
    const double t38 = p[6]*2.0; /* G*2 */
    const double t39 = x[0]*t38; /* gamma3*G*2 */
    const double t40 = x[3]*t39; /* v_tau*gamma3*G*2 */
    const double t41 = t6*t6; /* s*s*s*s */
    const double t42 = t4*t41; /* R*I1*s*s*s*s */
    const double t43 = t40/t42; /* v_tau*gamma3*G*2/(R*I1*s*s*s*s) */
    const double t44 = p[6]/t7; /* G/(R*I1*s*s) */
    const double t45 = t10*t12; /* m*a3*a3*omega_tau*omega_tau */
    const double t46 = t2*t45; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t47 = t46/t16; /* s*m*a3*a3*omega_tau*omega_tau/D */
    const double t48 = t0*t10; /* gamma3*gamma3*m*a3*a3 */
    const double t49 = t12*t48; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3 */
    const double t50 = t2*t16; /* s*D */
    const double t51 = t49/t50; /* omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t52 = t47 - t51; /* s*m*a3*a3*omega_tau*omega_tau/D - omega_tau*omega_tau*gamma3*gamma3*m*a3*a3/(s*D) */
    const double t53 = p[0]*p[0]; /* m*m */
    const double t54 = t9*t9; /* a3*a3*a3*a3 */
    const double t55 = t53*t54; /* m*m*a3*a3*a3*a3 */
    const double t56 = t0*t55; /* gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t57 = t12*t56; /* omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t58 = t2*t57; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3 */
    const double t59 = t16*t16; /* D*D */
    const double t60 = t58/t59; /* s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t61 = 2.0*t60; /* 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t62 = t52 + t61; /* t52 + 2*s*omega_tau*omega_tau*gamma3*gamma3*m*m*a3*a3*a3*a3/(D*D) */
    const double t63 = x[0]*t19; /* gamma3*a3*m*g */
    const double t64 = t63/t50; /* gamma3*a3*m*g/(s*D) */
    const double t65 = t62 + t64; /* t62 + gamma3*a3*m*g/(s*D) */
    const double t66 = p[2]*t53; /* g*m*m */
    const double t67 = p[5]*t9; /* a3*a3*a3 */
    const double t68 = t66*t67; /* g*m*m*a3*a3*a3 */
    const double t69 = x[0]*t68; /* gamma3*g*m*m*a3*a3*a3 */
    const double t70 = t2*t69; /* s*gamma3*g*m*m*a3*a3*a3 */
    const double t71 = t70/t59; /* s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t72 = 2.0*t71; /* 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t73 = t65 - t72; /* t62 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) */
    const double t74 = t25/t29; /* G*G/(D*I1*R*R*s*s*s) */
    const double t75 = t73 - t74; /* t62 + gamma3*a3*m*g/(s*D) - 2*s*gamma3*g*m*m*a3*a3*a3/(D*D) - G*G/(D*I1*R*R*s*s*s) */
    const double t76 = t0*t25; /* gamma3*gamma3*G*G */
    const double t77 = t2*t41; /* s*s*s*s*s */
    const double t78 = t24*t77; /* I1*R*R*s*s*s*s*s */
    const double t79 = t16*t78; /* D*I1*R*R*s*s*s*s*s */
    const double t80 = t76/t79; /* gamma3*gamma3*G*G/(D*I1*R*R*s*s*s*s*s) */
    const double t81 = t80*3.0; /* gamma3*gamma3*G*G/(D*I1*R*R*s*s*s*s*s)*3 */
    const double t82 = t75 - t81; /* t75 - gamma3*gamma3*G*G/(D*I1*R*R*s*s*s*s*s)*3 */
    const double t83 = t10*t25; /* m*a3*a3*G*G */
    const double t84 = t0*t83; /* gamma3*gamma3*m*a3*a3*G*G */
    const double t85 = t28*t59; /* I1*R*R*s*s*s*D*D */
    const double t86 = t84/t85; /* gamma3*gamma3*m*a3*a3*G*G/(I1*R*R*s*s*s*D*D) */
    const double t87 = 2.0*t86; /* 2*gamma3*gamma3*m*a3*a3*G*G/(I1*R*R*s*s*s*D*D) */
    const double t88 = t82 - t87; /* t75 - gamma3*gamma3*G*G/(D*I1*R*R*s*s*s*s*s)*3 - 2*gamma3*gamma3*m*a3*a3*G*G/(I1*R*R*s*s*s*D*D) */
    const double t89 = p[0]*2.0; /* m*2 */
    const double t90 = t9*t89; /* a3*a3*m*2 */
    const double t91 = x[0]*t90; /* gamma3*a3*a3*m*2 */
    const double t92 = x[2]*t91; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t93 = t2*t92; /* s*omega_tau*gamma3*a3*a3*m*2 */
    const double t94 = t93/t16; /* s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t95 = p[6]*(-2.0); /* G*(-2) */
    const double t96 = x[0]*t95; /* gamma3*G*(-2) */
    const double t97 = x[1]*t96; /* v_nu*gamma3*G*(-2) */
    const double t98 = t97/t42; /* v_nu*gamma3*G*(-2)/(R*I1*s*s*s*s) */
    const double t99 = -t44; /* -G/(R*I1*s*s) */
    out[0] = t3;
    out[1] = t8;
    out[2] = t31;
    out[3] = t34;
    out[4] = t37;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = t43;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t44;
    out[12] = t88;
    out[13] = 0.0;
    out[14] = t94;
    out[15] = 0.0;
    out[16] = t98;
    out[17] = t99;
    out[18] = 0.0;
    out[19] = 0.0;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t2 = 1.0 - t1; /* 1 - gamma3*gamma3 */
    const double t3 = sqrt(t2); /* s = sqrt(1 - gamma3*gamma3) */
    const double t4 = t0/t3; /* gamma3*omega_tau/s */
    const double t5 = p[5]*p[5]; /* a3*a3 */
    const double t6 = p[0]*t5; /* m*a3*a3 */
    const double t7 = x[0]*t6; /* gamma3*m*a3*a3 */
    const double t8 = x[2]*t7; /* omega_tau*gamma3*m*a3*a3 */
    const double t9 = t3*t8; /* s*omega_tau*gamma3*m*a3*a3 */
    const double t10 = t3*t3; /* s*s */
    const double t11 = t6*t10; /* m*a3*a3*s*s */
    const double t12 = p[3] + t11; /* D = I1 + m*a3*a3*s*s */
    const double t13 = t9/t12; /* s*omega_tau*gamma3*m*a3*a3/D */
    const double t14 = t13*2.0; /* s*omega_tau*gamma3*m*a3*a3/D*2 */
    const double t15 = t14 - t4; /* s*omega_tau*gamma3*m*a3*a3/D*2 - gamma3*omega_tau/s */
    out[0] = t15;
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
    const double t10 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t11 = 1.0 - t10; /* 1 - gamma3*gamma3 */
    const double t12 = sqrt(t11); /* s = sqrt(1 - gamma3*gamma3) */
    const double t13 = t12*t12; /* s*s */
    const double t14 = t9*t13; /* m*a3*a3*s*s */
    const double t15 = p[3] + t14; /* D = I1 + m*a3*a3*s*s */
    const double t16 = t7*t15; /* omega_tau*omega_tau*D */
    const double t17 = (1.0 / 2.0)*t16; /* 1/2*omega_tau*omega_tau*D */
    const double t18 = t6 + t17; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D */
    const double t19 = x[3]*x[3]; /* v_tau*v_tau */
    const double t20 = p[0]*t19; /* m*v_tau*v_tau */
    const double t21 = (1.0 / 2.0)*t20; /* 1/2*m*v_tau*v_tau */
    const double t22 = t18 + t21; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*m*v_tau*v_tau */
    const double t23 = p[1]*p[1]; /* R*R */
    const double t24 = p[3]*t23; /* I1*R*R */
    const double t25 = p[6]*p[6]; /* G*G */
    const double t26 = t13*t24; /* s*s*I1*R*R */
    const double t27 = t25/t26; /* G*G/(s*s*I1*R*R) */
    const double t28 = (1.0 / 2.0)*t27; /* 1/2*G*G/(s*s*I1*R*R) */
    const double t29 = t22 + t28; /* t22 + 1/2*G*G/(s*s*I1*R*R) */
    const double t30 = t5 + t21; /* m*v_nu*v_nu*1/2 + 1/2*m*v_tau*v_tau */
    out[0] = t29;
    out[1] = t30;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[5]*p[5]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t4 = t2*t3; /* m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t5 = p[7] - t4; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau */
    const double t6 = p[1]*p[1]; /* R*R */
    const double t7 = t6*p[3]; /* R*R*I1 */
    const double t8 = p[6]*p[6]; /* G*G */
    const double t9 = x[0]*t8; /* gamma3*G*G */
    const double t10 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t11 = 1.0 - t10; /* 1 - gamma3*gamma3 */
    const double t12 = sqrt(t11); /* s = sqrt(1 - gamma3*gamma3) */
    const double t13 = t12*t12; /* s*s */
    const double t14 = t13*t13; /* s*s*s*s */
    const double t15 = t7*t14; /* R*R*I1*s*s*s*s */
    const double t16 = t9/t15; /* gamma3*G*G/(R*R*I1*s*s*s*s) */
    const double t17 = t5 + t16; /* m*g*a3 - m*a3*a3*gamma3*omega_tau*omega_tau + gamma3*G*G/(R*R*I1*s*s*s*s) */
    const double t18 = p[0]*x[1]; /* m*v_nu */
    const double t19 = t1*t13; /* m*a3*a3*s*s */
    const double t20 = p[3] + t19; /* D = I1 + m*a3*a3*s*s */
    const double t21 = x[2]*t20; /* omega_tau*D */
    const double t22 = p[0]*x[3]; /* m*v_tau */
    out[0] = t17;
    out[1] = t18;
    out[2] = t21;
    out[3] = t22;
    out[4] = 0.0;
    out[5] = t18;
    out[6] = 0.0;
    out[7] = t22;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = p[5]*p[5]; /* a3*a3 */
    const double t4 = p[0]*t3; /* m*a3*a3 */
    const double t5 = t2*t2; /* s*s */
    const double t6 = t4*t5; /* m*a3*a3*s*s */
    const double t7 = p[3] + t6; /* D = I1 + m*a3*a3*s*s */
    const double t8 = t7/t2; /* D/s */
    out[0] = t8;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = 1.0 - t0; /* 1 - gamma3*gamma3 */
    const double t2 = sqrt(t1); /* s = sqrt(1 - gamma3*gamma3) */
    const double t3 = x[2]*t2; /* omega_tau*s */
    const double t4 = t2*t2; /* s*s */
    const double t5 = t2*t4; /* s*s*s */
    const double t6 = p[5]*p[5]; /* a3*a3 */
    const double t7 = p[0]*t6; /* m*a3*a3 */
    const double t8 = t4*t7; /* s*s*m*a3*a3 */
    const double t9 = p[3] + t8; /* D = I1 + s*s*m*a3*a3 */
    const double t10 = x[0]*t9; /* gamma3*D */
    const double t11 = t10/t5; /* gamma3*D/(s*s*s) */
    const double t12 = x[0]*t7; /* gamma3*m*a3*a3 */
    const double t13 = t12/t2; /* gamma3*m*a3*a3/s */
    const double t14 = t13*2.0; /* gamma3*m*a3*a3/s*2 */
    const double t15 = t11 - t14; /* gamma3*D/(s*s*s) - gamma3*m*a3*a3/s*2 */
    const double t16 = t3*t15; /* omega_tau*s*(gamma3*D/(s*s*s) - gamma3*m*a3*a3/s*2) */
    const double t17 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t18 = t17/t2; /* omega_tau*gamma3/s */
    const double t19 = x[2]*t12; /* omega_tau*gamma3*m*a3*a3 */
    const double t20 = t2*t19; /* s*omega_tau*gamma3*m*a3*a3 */
    const double t21 = t20/t9; /* s*omega_tau*gamma3*m*a3*a3/D */
    const double t22 = 2.0*t21; /* 2*s*omega_tau*gamma3*m*a3*a3/D */
    const double t23 = t18 - t22; /* omega_tau*gamma3/s - 2*s*omega_tau*gamma3*m*a3*a3/D */
    const double t24 = t9*t23; /* D*(omega_tau*gamma3/s - 2*s*omega_tau*gamma3*m*a3*a3/D) */
    const double t25 = t24/t2; /* D*(omega_tau*gamma3/s - 2*s*omega_tau*gamma3*m*a3*a3/D)/s */
    const double t26 = t16 - t25; /* omega_tau*s*(gamma3*D/(s*s*s) - gamma3*m*a3*a3/s*2) - D*(omega_tau*gamma3/s - 2*s*omega_tau*gamma3*m*a3*a3/D)/s */
    out[0] = t26;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double complex v_v_tau = x[3];
    const double v_R = params[1];
    const double v_I1 = params[3];
    const double v_I3 = (0.0);
    const double v_a3 = params[5];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_K = (v_R*v_R*v_I1*v_s*v_s + v_I3*v_b*v_b);
    const double v_G = params[6];
    const double complex v_omega_n = ((v_R*v_G*v_s + v_I3*v_v_tau*v_b)/v_K);
    out[1] = (v_v_tau*v_omega_n/v_s);
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double complex v_omega3 = ((v_R*v_I1*v_v_tau*v_s - v_G*v_b)/v_K);
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_v_nu = x[1];
    const double complex v_Theta = (v_m*v_K + v_I1*v_I3);
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (-v_v_nu*v_omega_n/v_s)
        + (v_I1*v_I3*v_V*v_omega_n/(v_s*v_Theta))
        + (-v_I3*v_omega_tau*v_omega3*(v_R*v_gamma3*(v_I1 - v_I3) - v_I3*v_a3)/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

static const jlt_named measures[] = {
    { "density", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_rod = {
    .model = "spherical_top_level",
    .variant = "rod",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 4, .param_count = 7, .block_count = 8,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 24, 0, 5, 1, 0, 9, 8 }, { 5, 31, 0, 5, 1, 0, 9, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 11, 59, 0, 13, 1, 0, 15, 15 }, { 11, 100, 0, 14, 1, 0, 15, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 14, 67, 0, 18, 1, 0, 15, 19 }, { 14, 126, 0, 19, 1, 0, 15, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 10, 0, 2, 1, 0, 9, 5 }, { 3, 12, 0, 2, 1, 0, 9, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 7, 22, 0, 1, 1, 0, 11, 7 }, { 7, 29, 0, 1, 1, 0, 11, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 8, { 4, 17, 0, 1, 1, 0, 8, 7 }, { 4, 24, 0, 1, 1, 0, 8, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { measure_values, 1, { 2, 5, 0, 1, 1, 0, 7, 4 }, { 2, 5, 0, 1, 1, 0, 7, 4 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_divergences = { measure_divergences, 1, { 5, 16, 0, 5, 1, 0, 12, 7 }, { 5, 22, 0, 5, 1, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 1, .equilibria_count = 0,
    .integrals = integrals,
    .measures = measures,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_rod_baseline,
        &jlt_batch_spherical_top_level_rod_avx2,
        &jlt_batch_spherical_top_level_rod_avx512,
    },
};
