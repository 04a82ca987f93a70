/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 9   28    0    4    0    0      8    6   (49)
 *  jacobian            17   70    0   14    0    0     11   10   (130)
 *  rhs_jacobian        22   80    0   18    0    0     11   18   (168)
 *  divergence          2    9    0    1    0    0      8    4   (15)
 *  integral_values     10   26    0    0    0    0      9    8   (51)
 *  integral_gradients  6   26    0    0    0    0      6    6   (60)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_avx512;

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
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = p[1]*x[0]; /* R*gamma3 */
    const double t4 = p[3] + t3; /* b = a3 + R*gamma3 */
    const double t5 = t2*t4; /* omega_n*omega_n*b */
    const double t6 = x[3]*p[1]; /* omega_n*R */
    const double t7 = t6*x[4]; /* omega_n*R*omega3 */
    const double t8 = x[5]*t7; /* s*omega_n*R*omega3 */
    const double t9 = t5 + t8; /* omega_n*omega_n*b + s*omega_n*R*omega3 */
    const double t10 = p[3]*p[3]; /* a3*a3 */
    const double t11 = p[0]*t10; /* m*a3*a3 */
    const double t12 = x[0]*t11; /* gamma3*m*a3*a3 */
    const double t13 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t14 = t12*t13; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t15 = t0*t14; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t16 = t0*t11; /* s*s*m*a3*a3 */
    const double t17 = p[4] + t16; /* D = I1 + s*s*m*a3*a3 */
    const double t18 = t15/t17; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t19 = p[0]*p[2]; /* m*g */
    const double t20 = p[3]*t19; /* a3*m*g */
    const double t21 = t0*t20; /* s*s*a3*m*g */
    const double t22 = t21/t17; /* s*s*a3*m*g/D */
    const double t23 = t18 - t22; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t24 = x[0]*p[4]; /* gamma3*I1 */
    const double t25 = t2*t24; /* omega_n*omega_n*gamma3*I1 */
    const double t26 = t25/t17; /* omega_n*omega_n*gamma3*I1/D */
    const double t27 = t23 - t26; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - omega_n*omega_n*gamma3*I1/D */
    const double t28 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t29 = x[3]*t28; /* omega_n*omega_tau*gamma3 */
    const double t30 = x[5]*p[1]; /* s*R */
    const double t31 = p[3]*x[0]; /* a3*gamma3 */
    const double t32 = p[1] + t31; /* e = R + a3*gamma3 */
    const double t33 = x[2]*t32; /* omega_tau*e */
    const double t34 = x[1] + t33; /* V = v_nu + omega_tau*e */
    const double t35 = x[3]*t34; /* omega_n*V */
    const double t36 = t35/t30; /* omega_n*V/(s*R) */
    const double t37 = x[4]*t28; /* omega3*omega_tau*gamma3 */
    const double t38 = t37 - t36; /* omega3*omega_tau*gamma3 - omega_n*V/(s*R) */
    const double t39 = x[5]*t28; /* s*omega_tau*gamma3 */
    const double t40 = -t39; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t9;
    out[2] = t27;
    out[3] = t29;
    out[4] = t38;
    out[5] = t40;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[5]*t1; /* s*2*omega_tau */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = p[3] + t5; /* b = a3 + R*gamma3 */
    const double t7 = x[3]*t6; /* omega_n*b */
    const double t8 = 2.0*t7; /* 2*omega_n*b */
    const double t9 = p[1]*x[4]; /* R*omega3 */
    const double t10 = x[5]*t9; /* s*R*omega3 */
    const double t11 = t8 + t10; /* 2*omega_n*b + s*R*omega3 */
    const double t12 = p[1]*x[3]; /* R*omega_n */
    const double t13 = x[5]*t12; /* s*R*omega_n */
    const double t14 = x[4]*t12; /* omega3*R*omega_n */
    const double t15 = p[3]*p[3]; /* a3*a3 */
    const double t16 = p[0]*t15; /* m*a3*a3 */
    const double t17 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t18 = t16*t17; /* m*a3*a3*omega_tau*omega_tau */
    const double t19 = t0*t18; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t20 = t0*t16; /* s*s*m*a3*a3 */
    const double t21 = p[4] + t20; /* D = I1 + s*s*m*a3*a3 */
    const double t22 = t19/t21; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t23 = t3*p[4]; /* omega_n*omega_n*I1 */
    const double t24 = t23/t21; /* omega_n*omega_n*I1/D */
    const double t25 = t22 - t24; /* s*s*m*a3*a3*omega_tau*omega_tau/D - omega_n*omega_n*I1/D */
    const double t26 = 2.0*p[0]; /* 2*m */
    const double t27 = t15*t26; /* a3*a3*2*m */
    const double t28 = x[0]*t27; /* gamma3*a3*a3*2*m */
    const double t29 = x[2]*t28; /* omega_tau*gamma3*a3*a3*2*m */
    const double t30 = t0*t29; /* s*s*omega_tau*gamma3*a3*a3*2*m */
    const double t31 = t30/t21; /* s*s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t32 = p[4]*(-2.0); /* I1*(-2) */
    const double t33 = x[0]*t32; /* gamma3*I1*(-2) */
    const double t34 = x[3]*t33; /* omega_n*gamma3*I1*(-2) */
    const double t35 = t34/t21; /* omega_n*gamma3*I1*(-2)/D */
    const double t36 = x[0]*t16; /* gamma3*m*a3*a3 */
    const double t37 = t17*t36; /* omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t38 = x[5]*t37; /* s*omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t39 = t38/t21; /* s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t40 = 2.0*t39; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t41 = p[0]*p[2]; /* m*g */
    const double t42 = p[3]*t41; /* a3*m*g */
    const double t43 = x[5]*t42; /* s*a3*m*g */
    const double t44 = t43/t21; /* s*a3*m*g/D */
    const double t45 = 2.0*t44; /* 2*s*a3*m*g/D */
    const double t46 = t40 - t45; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D */
    const double t47 = p[0]*p[0]; /* m*m */
    const double t48 = t15*t15; /* a3*a3*a3*a3 */
    const double t49 = t47*t48; /* m*m*a3*a3*a3*a3 */
    const double t50 = x[0]*t49; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t51 = t17*t50; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t52 = x[5]*t0; /* s*s*s */
    const double t53 = t51*t52; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t54 = t21*t21; /* D*D */
    const double t55 = t53/t54; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t56 = 2.0*t55; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t57 = t46 - t56; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t58 = p[2]*t47; /* g*m*m */
    const double t59 = p[3]*t15; /* a3*a3*a3 */
    const double t60 = t58*t59; /* g*m*m*a3*a3*a3 */
    const double t61 = t52*t60; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t62 = t61/t54; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t63 = 2.0*t62; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t64 = t57 + t63; /* t57 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t65 = t16*p[4]; /* m*a3*a3*I1 */
    const double t66 = x[0]*t65; /* gamma3*m*a3*a3*I1 */
    const double t67 = t3*t66; /* omega_n*omega_n*gamma3*m*a3*a3*I1 */
    const double t68 = x[5]*t67; /* s*omega_n*omega_n*gamma3*m*a3*a3*I1 */
    const double t69 = t68/t54; /* s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t70 = 2.0*t69; /* 2*s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t71 = t64 + t70; /* t57 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t72 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t73 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t74 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t75 = x[2]*p[3]; /* omega_tau*a3 */
    const double t76 = x[3]*t75; /* omega_n*omega_tau*a3 */
    const double t77 = x[5]*p[1]; /* s*R */
    const double t78 = t76/t77; /* omega_n*omega_tau*a3/(s*R) */
    const double t79 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t80 = t79 - t78; /* omega_tau*omega3 - omega_n*omega_tau*a3/(s*R) */
    const double t81 = x[3]/t77; /* omega_n/(s*R) */
    const double t82 = -t81; /* -omega_n/(s*R) */
    const double t83 = p[3]*x[0]; /* a3*gamma3 */
    const double t84 = p[1] + t83; /* e = R + a3*gamma3 */
    const double t85 = x[3]*t84; /* omega_n*e */
    const double t86 = t85/t77; /* omega_n*e/(s*R) */
    const double t87 = x[0]*x[4]; /* gamma3*omega3 */
    const double t88 = t87 - t86; /* gamma3*omega3 - omega_n*e/(s*R) */
    const double t89 = x[2]*t84; /* omega_tau*e */
    const double t90 = x[1] + t89; /* V = v_nu + omega_tau*e */
    const double t91 = t90/t77; /* V/(s*R) */
    const double t92 = -t91; /* -V/(s*R) */
    const double t93 = t0*p[1]; /* s*s*R */
    const double t94 = x[3]*t90; /* omega_n*V */
    const double t95 = t94/t93; /* omega_n*V/(s*s*R) */
    const double t96 = x[5]*x[2]; /* s*omega_tau */
    const double t97 = -t96; /* -s*omega_tau */
    const double t98 = x[5]*x[0]; /* s*gamma3 */
    const double t99 = -t98; /* -s*gamma3 */
    const double t100 = -t74; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t2;
    out[6] = t4;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t11;
    out[10] = t13;
    out[11] = t14;
    out[12] = t25;
    out[13] = 0.0;
    out[14] = t31;
    out[15] = t35;
    out[16] = 0.0;
    out[17] = t71;
    out[18] = t72;
    out[19] = 0.0;
    out[20] = t73;
    out[21] = t74;
    out[22] = 0.0;
    out[23] = 0.0;
    out[24] = t80;
    out[25] = t82;
    out[26] = t88;
    out[27] = t92;
    out[28] = t74;
    out[29] = t95;
    out[30] = t97;
    out[31] = 0.0;
    out[32] = t99;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = t100;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = p[1]*x[0]; /* R*gamma3 */
    const double t4 = p[3] + t3; /* b = a3 + R*gamma3 */
    const double t5 = t2*t4; /* omega_n*omega_n*b */
    const double t6 = x[3]*p[1]; /* omega_n*R */
    const double t7 = t6*x[4]; /* omega_n*R*omega3 */
    const double t8 = x[5]*t7; /* s*omega_n*R*omega3 */
    const double t9 = t5 + t8; /* omega_n*omega_n*b + s*omega_n*R*omega3 */
    const double t10 = p[3]*p[3]; /* a3*a3 */
    const double t11 = p[0]*t10; /* m*a3*a3 */
    const double t12 = x[0]*t11; /* gamma3*m*a3*a3 */
    const double t13 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t14 = t12*t13; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t15 = t0*t14; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t16 = t0*t11; /* s*s*m*a3*a3 */
    const double t17 = p[4] + t16; /* D = I1 + s*s*m*a3*a3 */
    const double t18 = t15/t17; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t19 = p[0]*p[2]; /* m*g */
    const double t20 = p[3]*t19; /* a3*m*g */
    const double t21 = t0*t20; /* s*s*a3*m*g */
    const double t22 = t21/t17; /* s*s*a3*m*g/D */
    const double t23 = t18 - t22; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t24 = x[0]*p[4]; /* gamma3*I1 */
    const double t25 = t2*t24; /* omega_n*omega_n*gamma3*I1 */
    const double t26 = t25/t17; /* omega_n*omega_n*gamma3*I1/D */
    const double t27 = t23 - t26; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - omega_n*omega_n*gamma3*I1/D */
    const double t28 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t29 = x[3]*t28; /* omega_n*omega_tau*gamma3 */
    const double t30 = x[5]*p[1]; /* s*R */
    const double t31 = p[3]*x[0]; /* a3*gamma3 */
    const double t32 = p[1] + t31; /* e = R + a3*gamma3 */
    const double t33 = x[2]*t32; /* omega_tau*e */
    const double t34 = x[1] + t33; /* V = v_nu + omega_tau*e */
    const double t35 = x[3]*t34; /* omega_n*V */
    const double t36 = t35/t30; /* omega_n*V/(s*R) */
    const double t37 = x[4]*t28; /* omega3*omega_tau*gamma3 */
    const double t38 = t37 - t36; /* omega3*omega_tau*gamma3 - omega_n*V/(s*R) */
    const double t39 = -t28; /* -omega_tau*gamma3 */
    const double t40 = x[5]*t28; /* s*omega_tau*gamma3 */
    const double t41 = -t40; /* -s*omega_tau*gamma3 */
    const double t42 = x[2]*2.0; /* omega_tau*2 */
    const double t43 = x[5]*t42; /* s*omega_tau*2 */
    const double t44 = t2*p[1]; /* omega_n*omega_n*R */
    const double t45 = x[3]*t4; /* omega_n*b */
    const double t46 = 2.0*t45; /* 2*omega_n*b */
    const double t47 = p[1]*x[4]; /* R*omega3 */
    const double t48 = x[5]*t47; /* s*R*omega3 */
    const double t49 = t46 + t48; /* 2*omega_n*b + s*R*omega3 */
    const double t50 = x[5]*t6; /* s*omega_n*R */
    const double t51 = t11*t13; /* m*a3*a3*omega_tau*omega_tau */
    const double t52 = t0*t51; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t53 = t52/t17; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t54 = t2*p[4]; /* omega_n*omega_n*I1 */
    const double t55 = t54/t17; /* omega_n*omega_n*I1/D */
    const double t56 = t53 - t55; /* s*s*m*a3*a3*omega_tau*omega_tau/D - omega_n*omega_n*I1/D */
    const double t57 = p[0]*2.0; /* m*2 */
    const double t58 = t10*t57; /* a3*a3*m*2 */
    const double t59 = x[0]*t58; /* gamma3*a3*a3*m*2 */
    const double t60 = x[2]*t59; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t61 = t0*t60; /* s*s*omega_tau*gamma3*a3*a3*m*2 */
    const double t62 = t61/t17; /* s*s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t63 = p[4]*(-2.0); /* I1*(-2) */
    const double t64 = x[0]*t63; /* gamma3*I1*(-2) */
    const double t65 = x[3]*t64; /* omega_n*gamma3*I1*(-2) */
    const double t66 = t65/t17; /* omega_n*gamma3*I1*(-2)/D */
    const double t67 = x[5]*t14; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t68 = t67/t17; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t69 = 2.0*t68; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t70 = x[5]*t20; /* s*a3*m*g */
    const double t71 = t70/t17; /* s*a3*m*g/D */
    const double t72 = 2.0*t71; /* 2*s*a3*m*g/D */
    const double t73 = t69 - t72; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D */
    const double t74 = p[0]*p[0]; /* m*m */
    const double t75 = t10*t10; /* a3*a3*a3*a3 */
    const double t76 = t74*t75; /* m*m*a3*a3*a3*a3 */
    const double t77 = x[0]*t76; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t78 = t13*t77; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t79 = x[5]*t0; /* s*s*s */
    const double t80 = t78*t79; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t81 = t17*t17; /* D*D */
    const double t82 = t80/t81; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t83 = 2.0*t82; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t84 = t73 - t83; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t85 = p[2]*t74; /* g*m*m */
    const double t86 = p[3]*t10; /* a3*a3*a3 */
    const double t87 = t85*t86; /* g*m*m*a3*a3*a3 */
    const double t88 = t79*t87; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t89 = t88/t81; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t90 = 2.0*t89; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t91 = t84 + t90; /* t84 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t92 = t11*p[4]; /* m*a3*a3*I1 */
    const double t93 = x[0]*t92; /* gamma3*m*a3*a3*I1 */
    const double t94 = t2*t93; /* omega_n*omega_n*gamma3*m*a3*a3*I1 */
    const double t95 = x[5]*t94; /* s*omega_n*omega_n*gamma3*m*a3*a3*I1 */
    const double t96 = t95/t81; /* s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t97 = 2.0*t96; /* 2*s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t98 = t91 + t97; /* t84 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*s*omega_n*omega_n*gamma3*m*a3*a3*I1/(D*D) */
    const double t99 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t100 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t101 = x[2]*p[3]; /* omega_tau*a3 */
    const double t102 = x[3]*t101; /* omega_n*omega_tau*a3 */
    const double t103 = t102/t30; /* omega_n*omega_tau*a3/(s*R) */
    const double t104 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t105 = t104 - t103; /* omega_tau*omega3 - omega_n*omega_tau*a3/(s*R) */
    const double t106 = x[3]/t30; /* omega_n/(s*R) */
    const double t107 = -t106; /* -omega_n/(s*R) */
    const double t108 = x[3]*t32; /* omega_n*e */
    const double t109 = t108/t30; /* omega_n*e/(s*R) */
    const double t110 = x[0]*x[4]; /* gamma3*omega3 */
    const double t111 = t110 - t109; /* gamma3*omega3 - omega_n*e/(s*R) */
    const double t112 = t34/t30; /* V/(s*R) */
    const double t113 = -t112; /* -V/(s*R) */
    const double t114 = t0*p[1]; /* s*s*R */
    const double t115 = t35/t114; /* omega_n*V/(s*s*R) */
    const double t116 = x[2]*x[5]; /* omega_tau*s */
    const double t117 = -t116; /* -omega_tau*s */
    const double t118 = x[5]*x[0]; /* s*gamma3 */
    const double t119 = -t118; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t9;
    out[2] = t27;
    out[3] = t29;
    out[4] = t38;
    out[5] = t41;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t43;
    out[12] = t44;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t49;
    out[16] = t50;
    out[17] = t7;
    out[18] = t56;
    out[19] = 0.0;
    out[20] = t62;
    out[21] = t66;
    out[22] = 0.0;
    out[23] = t98;
    out[24] = t99;
    out[25] = 0.0;
    out[26] = t100;
    out[27] = t28;
    out[28] = 0.0;
    out[29] = 0.0;
    out[30] = t105;
    out[31] = t107;
    out[32] = t111;
    out[33] = t113;
    out[34] = t28;
    out[35] = t115;
    out[36] = t117;
    out[37] = 0.0;
    out[38] = t119;
    out[39] = 0.0;
    out[40] = 0.0;
    out[41] = t39;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*p[3]; /* a3*a3 */
    const double t1 = p[0]*t0; /* m*a3*a3 */
    const double t2 = t1*x[0]; /* m*a3*a3*gamma3 */
    const double t3 = t2*x[2]; /* m*a3*a3*gamma3*omega_tau */
    const double t4 = x[5]*x[5]; /* s*s */
    const double t5 = t3*t4; /* m*a3*a3*gamma3*omega_tau*s*s */
    const double t6 = t1*t4; /* m*a3*a3*s*s */
    const double t7 = p[4] + t6; /* D = I1 + m*a3*a3*s*s */
    const double t8 = t5/t7; /* m*a3*a3*gamma3*omega_tau*s*s/D */
    const double t9 = t8*2.0; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 */
    const double t10 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t11 = t9 + t10; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 + gamma3*omega_tau */
    out[0] = t11;
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
    const double t10 = x[5]*x[5]; /* s*s */
    const double t11 = t9*t10; /* m*a3*a3*s*s */
    const double t12 = p[4] + t11; /* D = I1 + m*a3*a3*s*s */
    const double t13 = t7*t12; /* omega_tau*omega_tau*D */
    const double t14 = (1.0 / 2.0)*t13; /* 1/2*omega_tau*omega_tau*D */
    const double t15 = t6 + t14; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D */
    const double t16 = x[3]*x[3]; /* omega_n*omega_n */
    const double t17 = p[4]*t16; /* I1*omega_n*omega_n */
    const double t18 = (1.0 / 2.0)*t17; /* 1/2*I1*omega_n*omega_n */
    const double t19 = t15 + t18; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*I1*omega_n*omega_n */
    const double t20 = x[0]*p[1]; /* gamma3*R */
    const double t21 = p[3] + t20; /* b = a3 + gamma3*R */
    const double t22 = x[3]*t21; /* omega_n*b */
    const double t23 = p[1]*x[4]; /* R*omega3 */
    const double t24 = x[5]*t23; /* s*R*omega3 */
    const double t25 = t22 + t24; /* v_tau = omega_n*b + s*R*omega3 */
    const double t26 = t25*t25; /* v_tau*v_tau */
    const double t27 = p[0]*t26; /* m*v_tau*v_tau */
    const double t28 = (1.0 / 2.0)*t27; /* 1/2*m*v_tau*v_tau */
    const double t29 = t19 + t28; /* energy = t19 + 1/2*m*v_tau*v_tau */
    const double t30 = p[4]*p[1]; /* I1*R */
    const double t31 = x[3]*t30; /* omega_n*I1*R */
    const double t32 = x[5]*t31; /* s*omega_n*I1*R */
    const double t33 = t5 + t28; /* m*v_nu*v_nu*1/2 + 1/2*m*v_tau*v_tau */
    const double t34 = t2 + t14; /* m*g*a3*gamma3 + 1/2*omega_tau*omega_tau*D */
    const double t35 = t18 + t34; /* 1/2*I1*omega_n*omega_n + m*g*a3*gamma3 + 1/2*omega_tau*omega_tau*D */
    out[0] = t29;
    out[1] = t32;
    out[2] = t33;
    out[3] = t35;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[1]; /* m*R */
    const double t1 = t0*x[3]; /* m*R*omega_n */
    const double t2 = p[1]*x[0]; /* R*gamma3 */
    const double t3 = p[3] + t2; /* b = a3 + R*gamma3 */
    const double t4 = x[3]*t3; /* omega_n*b */
    const double t5 = p[1]*x[4]; /* R*omega3 */
    const double t6 = t5*x[5]; /* R*omega3*s */
    const double t7 = t4 + t6; /* v_tau = omega_n*b + R*omega3*s */
    const double t8 = t1*t7; /* m*R*omega_n*v_tau */
    const double t9 = p[6] + t8; /* d(energy)/d(gamma3) = m*g*a3 + m*R*omega_n*v_tau */
    const double t10 = p[0]*x[1]; /* m*v_nu */
    const double t11 = p[3]*p[3]; /* a3*a3 */
    const double t12 = p[0]*t11; /* m*a3*a3 */
    const double t13 = x[5]*x[5]; /* s*s */
    const double t14 = t12*t13; /* m*a3*a3*s*s */
    const double t15 = p[4] + t14; /* D = I1 + m*a3*a3*s*s */
    const double t16 = x[2]*t15; /* omega_tau*D */
    const double t17 = x[3]*p[4]; /* omega_n*I1 */
    const double t18 = p[0]*t3; /* m*b */
    const double t19 = t7*t18; /* v_tau*m*b */
    const double t20 = t17 + t19; /* d(energy)/d(omega_n) = omega_n*I1 + v_tau*m*b */
    const double t21 = t0*x[5]; /* m*R*s */
    const double t22 = t7*t21; /* v_tau*m*R*s */
    const double t23 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t24 = t12*t23; /* m*a3*a3*omega_tau*omega_tau */
    const double t25 = x[5]*t24; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t26 = t0*x[4]; /* m*R*omega3 */
    const double t27 = t7*t26; /* v_tau*m*R*omega3 */
    const double t28 = t25 + t27; /* d(energy)/d(s) = s*m*a3*a3*omega_tau*omega_tau + v_tau*m*R*omega3 */
    const double t29 = p[1]*p[4]; /* R*I1 */
    const double t30 = x[5]*t29; /* s*R*I1 */
    const double t31 = x[3]*t29; /* omega_n*R*I1 */
    out[0] = t9;
    out[1] = t10;
    out[2] = t16;
    out[3] = t20;
    out[4] = t22;
    out[5] = t28;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t30;
    out[10] = 0.0;
    out[11] = t31;
    out[12] = t8;
    out[13] = t10;
    out[14] = 0.0;
    out[15] = t19;
    out[16] = t22;
    out[17] = t27;
    out[18] = p[6];
    out[19] = 0.0;
    out[20] = t16;
    out[21] = t17;
    out[22] = 0.0;
    out[23] = t25;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[5];
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[5];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega3 = x[4];
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = (0.0);
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta));
    out[4] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[5] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "G", "" },
    { "E1", "I3 = 0" },
    { "E2", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular = {
    .model = "spherical_top",
    .variant = "rod",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 7,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 6, { 9, 28, 0, 4, 0, 0, 8, 6 }, { 9, 36, 0, 4, 0, 0, 8, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .jacobian = { jacobian, 36, { 17, 70, 0, 14, 0, 0, 11, 10 }, { 17, 99, 0, 14, 0, 0, 11, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 42, { 22, 80, 0, 18, 0, 0, 11, 18 }, { 22, 128, 0, 18, 0, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .divergence = { divergence, 1, { 2, 9, 0, 1, 0, 0, 8, 4 }, { 2, 12, 0, 1, 0, 0, 8, 4 },
        "" },
    .integral_values = { integral_values, 4, { 10, 26, 0, 0, 0, 0, 9, 8 }, { 10, 41, 0, 0, 0, 0, 9, 5 },
        "" },
    .integral_gradients = { integral_gradients, 24, { 6, 26, 0, 0, 0, 0, 6, 6 }, { 6, 54, 0, 0, 0, 0, 6, 6 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_rod_in_regular_baseline,
        &jlt_batch_spherical_top_rod_in_regular_avx2,
        &jlt_batch_spherical_top_rod_in_regular_avx512,
    },
};
