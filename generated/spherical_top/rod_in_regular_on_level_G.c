/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 9   29    0    5    0    0      8    7   (50)
 *  jacobian            19   77    0   17    0    0     12   12   (146)
 *  rhs_jacobian        24   86    0   21    0    0     12   21   (182)
 *  divergence          1    9    0    1    0    0      6    4   (13)
 *  integral_values     10   25    0    1    0    0      9    8   (51)
 *  integral_gradients  8   26    0    3    0    0      9   10   (67)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    2    0    1    0    0      3    2   (3)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_rod_in_regular_on_level_G_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
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
    const double t1 = t0*params[3]; /* m*g*a3 */
    out[7] = t1;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = x[4]*t2; /* s*R*I1 */
    const double t4 = p[6]/t3; /* omega_n = G_level/(s*R*I1) */
    const double t5 = t4*t4; /* omega_n*omega_n */
    const double t6 = p[1]*x[0]; /* R*gamma3 */
    const double t7 = p[3] + t6; /* b = a3 + R*gamma3 */
    const double t8 = t5*t7; /* omega_n*omega_n*b */
    const double t9 = p[1]*t4; /* R*omega_n */
    const double t10 = t9*x[3]; /* R*omega_n*omega3 */
    const double t11 = x[4]*t10; /* s*R*omega_n*omega3 */
    const double t12 = t8 + t11; /* omega_n*omega_n*b + s*R*omega_n*omega3 */
    const double t13 = p[3]*p[3]; /* a3*a3 */
    const double t14 = p[0]*t13; /* m*a3*a3 */
    const double t15 = x[0]*t14; /* gamma3*m*a3*a3 */
    const double t16 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t17 = t15*t16; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t18 = t0*t17; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t19 = t0*t14; /* s*s*m*a3*a3 */
    const double t20 = p[4] + t19; /* D = I1 + s*s*m*a3*a3 */
    const double t21 = t18/t20; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t22 = p[0]*p[2]; /* m*g */
    const double t23 = p[3]*t22; /* a3*m*g */
    const double t24 = t0*t23; /* s*s*a3*m*g */
    const double t25 = t24/t20; /* s*s*a3*m*g/D */
    const double t26 = t21 - t25; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t27 = p[4]*x[0]; /* I1*gamma3 */
    const double t28 = t5*t27; /* omega_n*omega_n*I1*gamma3 */
    const double t29 = t28/t20; /* omega_n*omega_n*I1*gamma3/D */
    const double t30 = t26 - t29; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - omega_n*omega_n*I1*gamma3/D */
    const double t31 = x[4]*p[1]; /* s*R */
    const double t32 = p[3]*x[0]; /* a3*gamma3 */
    const double t33 = p[1] + t32; /* e = R + a3*gamma3 */
    const double t34 = x[2]*t33; /* omega_tau*e */
    const double t35 = x[1] + t34; /* V = v_nu + omega_tau*e */
    const double t36 = t4*t35; /* omega_n*V */
    const double t37 = t36/t31; /* omega_n*V/(s*R) */
    const double t38 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t39 = x[3]*t38; /* omega3*omega_tau*gamma3 */
    const double t40 = t39 - t37; /* omega3*omega_tau*gamma3 - omega_n*V/(s*R) */
    const double t41 = x[4]*t38; /* s*omega_tau*gamma3 */
    const double t42 = -t41; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t12;
    out[2] = t30;
    out[3] = t40;
    out[4] = t42;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[4]*t1; /* s*2*omega_tau */
    const double t3 = p[1]*p[4]; /* R*I1 */
    const double t4 = x[4]*t3; /* s*R*I1 */
    const double t5 = p[6]/t4; /* omega_n = G_level/(s*R*I1) */
    const double t6 = t5*t5; /* omega_n*omega_n */
    const double t7 = p[1]*t6; /* R*omega_n*omega_n */
    const double t8 = p[1]*t5; /* R*omega_n */
    const double t9 = x[4]*t8; /* s*R*omega_n */
    const double t10 = t8*x[3]; /* R*omega_n*omega3 */
    const double t11 = t0*t3; /* s*s*R*I1 */
    const double t12 = p[1]*x[0]; /* R*gamma3 */
    const double t13 = p[3] + t12; /* b = a3 + R*gamma3 */
    const double t14 = t5*t13; /* omega_n*b */
    const double t15 = p[6]*t14; /* G_level*omega_n*b */
    const double t16 = t15/t11; /* G_level*omega_n*b/(s*s*R*I1) */
    const double t17 = 2.0*t16; /* 2*G_level*omega_n*b/(s*s*R*I1) */
    const double t18 = t10 - t17; /* R*omega_n*omega3 - 2*G_level*omega_n*b/(s*s*R*I1) */
    const double t19 = x[4]*p[4]; /* s*I1 */
    const double t20 = p[6]*x[3]; /* G_level*omega3 */
    const double t21 = t20/t19; /* G_level*omega3/(s*I1) */
    const double t22 = t18 - t21; /* R*omega_n*omega3 - 2*G_level*omega_n*b/(s*s*R*I1) - G_level*omega3/(s*I1) */
    const double t23 = p[3]*p[3]; /* a3*a3 */
    const double t24 = p[0]*t23; /* m*a3*a3 */
    const double t25 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t26 = t24*t25; /* m*a3*a3*omega_tau*omega_tau */
    const double t27 = t0*t26; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t28 = t0*t24; /* s*s*m*a3*a3 */
    const double t29 = p[4] + t28; /* D = I1 + s*s*m*a3*a3 */
    const double t30 = t27/t29; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t31 = p[4]*t6; /* I1*omega_n*omega_n */
    const double t32 = t31/t29; /* I1*omega_n*omega_n/D */
    const double t33 = t30 - t32; /* s*s*m*a3*a3*omega_tau*omega_tau/D - I1*omega_n*omega_n/D */
    const double t34 = 2.0*p[0]; /* 2*m */
    const double t35 = t23*t34; /* a3*a3*2*m */
    const double t36 = x[0]*t35; /* gamma3*a3*a3*2*m */
    const double t37 = x[2]*t36; /* omega_tau*gamma3*a3*a3*2*m */
    const double t38 = t0*t37; /* s*s*omega_tau*gamma3*a3*a3*2*m */
    const double t39 = t38/t29; /* s*s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t40 = x[0]*t24; /* gamma3*m*a3*a3 */
    const double t41 = t25*t40; /* omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t42 = x[4]*t41; /* s*omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t43 = t42/t29; /* s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t44 = 2.0*t43; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t45 = p[0]*p[2]; /* m*g */
    const double t46 = p[3]*t45; /* a3*m*g */
    const double t47 = x[4]*t46; /* s*a3*m*g */
    const double t48 = t47/t29; /* s*a3*m*g/D */
    const double t49 = 2.0*t48; /* 2*s*a3*m*g/D */
    const double t50 = t44 - t49; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D */
    const double t51 = p[0]*p[0]; /* m*m */
    const double t52 = t23*t23; /* a3*a3*a3*a3 */
    const double t53 = t51*t52; /* m*m*a3*a3*a3*a3 */
    const double t54 = x[0]*t53; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t55 = t25*t54; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t56 = x[4]*t0; /* s*s*s */
    const double t57 = t55*t56; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t58 = t29*t29; /* D*D */
    const double t59 = t57/t58; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t60 = 2.0*t59; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t61 = t50 - t60; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t62 = p[2]*t51; /* g*m*m */
    const double t63 = p[3]*t23; /* a3*a3*a3 */
    const double t64 = t62*t63; /* g*m*m*a3*a3*a3 */
    const double t65 = t56*t64; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t66 = t65/t58; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t67 = 2.0*t66; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t68 = t61 + t67; /* t61 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t69 = p[4]*t24; /* I1*m*a3*a3 */
    const double t70 = x[0]*t69; /* gamma3*I1*m*a3*a3 */
    const double t71 = t6*t70; /* omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t72 = x[4]*t71; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t73 = t72/t58; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t74 = 2.0*t73; /* 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t75 = t68 + t74; /* t61 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t76 = t5*x[0]; /* omega_n*gamma3 */
    const double t77 = t0*p[1]; /* s*s*R */
    const double t78 = t29*t77; /* D*s*s*R */
    const double t79 = p[6]*t76; /* G_level*omega_n*gamma3 */
    const double t80 = t79/t78; /* G_level*omega_n*gamma3/(D*s*s*R) */
    const double t81 = 2.0*t80; /* 2*G_level*omega_n*gamma3/(D*s*s*R) */
    const double t82 = t75 + t81; /* t75 + 2*G_level*omega_n*gamma3/(D*s*s*R) */
    const double t83 = x[2]*p[3]; /* omega_tau*a3 */
    const double t84 = t5*t83; /* omega_n*omega_tau*a3 */
    const double t85 = x[4]*p[1]; /* s*R */
    const double t86 = t84/t85; /* omega_n*omega_tau*a3/(s*R) */
    const double t87 = x[2]*x[3]; /* omega_tau*omega3 */
    const double t88 = t87 - t86; /* omega_tau*omega3 - omega_n*omega_tau*a3/(s*R) */
    const double t89 = t5/t85; /* omega_n/(s*R) */
    const double t90 = -t89; /* -omega_n/(s*R) */
    const double t91 = p[3]*x[0]; /* a3*gamma3 */
    const double t92 = p[1] + t91; /* e = R + a3*gamma3 */
    const double t93 = t5*t92; /* omega_n*e */
    const double t94 = t93/t85; /* omega_n*e/(s*R) */
    const double t95 = x[3]*x[0]; /* omega3*gamma3 */
    const double t96 = t95 - t94; /* omega3*gamma3 - omega_n*e/(s*R) */
    const double t97 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t98 = x[2]*t92; /* omega_tau*e */
    const double t99 = x[1] + t98; /* V = v_nu + omega_tau*e */
    const double t100 = t5*t99; /* omega_n*V */
    const double t101 = t100/t77; /* omega_n*V/(s*s*R) */
    const double t102 = p[1]*p[1]; /* R*R */
    const double t103 = p[4]*t102; /* I1*R*R */
    const double t104 = t56*t103; /* s*s*s*I1*R*R */
    const double t105 = p[6]*t99; /* G_level*V */
    const double t106 = t105/t104; /* G_level*V/(s*s*s*I1*R*R) */
    const double t107 = t101 + t106; /* omega_n*V/(s*s*R) + G_level*V/(s*s*s*I1*R*R) */
    const double t108 = x[4]*x[2]; /* s*omega_tau */
    const double t109 = -t108; /* -s*omega_tau */
    const double t110 = x[4]*x[0]; /* s*gamma3 */
    const double t111 = -t110; /* -s*gamma3 */
    const double t112 = -t97; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t7;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t9;
    out[9] = t22;
    out[10] = t33;
    out[11] = 0.0;
    out[12] = t39;
    out[13] = 0.0;
    out[14] = t82;
    out[15] = t88;
    out[16] = t90;
    out[17] = t96;
    out[18] = t97;
    out[19] = t107;
    out[20] = t109;
    out[21] = 0.0;
    out[22] = t111;
    out[23] = 0.0;
    out[24] = t112;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[4]; /* R*I1 */
    const double t3 = x[4]*t2; /* s*R*I1 */
    const double t4 = p[6]/t3; /* omega_n = G_level/(s*R*I1) */
    const double t5 = t4*t4; /* omega_n*omega_n */
    const double t6 = p[1]*x[0]; /* R*gamma3 */
    const double t7 = p[3] + t6; /* b = a3 + R*gamma3 */
    const double t8 = t5*t7; /* omega_n*omega_n*b */
    const double t9 = p[1]*t4; /* R*omega_n */
    const double t10 = t9*x[3]; /* R*omega_n*omega3 */
    const double t11 = x[4]*t10; /* s*R*omega_n*omega3 */
    const double t12 = t8 + t11; /* omega_n*omega_n*b + s*R*omega_n*omega3 */
    const double t13 = p[3]*p[3]; /* a3*a3 */
    const double t14 = p[0]*t13; /* m*a3*a3 */
    const double t15 = x[0]*t14; /* gamma3*m*a3*a3 */
    const double t16 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t17 = t15*t16; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t18 = t0*t17; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t19 = t0*t14; /* s*s*m*a3*a3 */
    const double t20 = p[4] + t19; /* D = I1 + s*s*m*a3*a3 */
    const double t21 = t18/t20; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t22 = p[0]*p[2]; /* m*g */
    const double t23 = p[3]*t22; /* a3*m*g */
    const double t24 = t0*t23; /* s*s*a3*m*g */
    const double t25 = t24/t20; /* s*s*a3*m*g/D */
    const double t26 = t21 - t25; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t27 = p[4]*x[0]; /* I1*gamma3 */
    const double t28 = t5*t27; /* omega_n*omega_n*I1*gamma3 */
    const double t29 = t28/t20; /* omega_n*omega_n*I1*gamma3/D */
    const double t30 = t26 - t29; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - omega_n*omega_n*I1*gamma3/D */
    const double t31 = x[4]*p[1]; /* s*R */
    const double t32 = p[3]*x[0]; /* a3*gamma3 */
    const double t33 = p[1] + t32; /* e = R + a3*gamma3 */
    const double t34 = x[2]*t33; /* omega_tau*e */
    const double t35 = x[1] + t34; /* V = v_nu + omega_tau*e */
    const double t36 = t4*t35; /* omega_n*V */
    const double t37 = t36/t31; /* omega_n*V/(s*R) */
    const double t38 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t39 = x[3]*t38; /* omega3*omega_tau*gamma3 */
    const double t40 = t39 - t37; /* omega3*omega_tau*gamma3 - omega_n*V/(s*R) */
    const double t41 = -t38; /* -omega_tau*gamma3 */
    const double t42 = x[4]*t38; /* s*omega_tau*gamma3 */
    const double t43 = -t42; /* -s*omega_tau*gamma3 */
    const double t44 = x[2]*2.0; /* omega_tau*2 */
    const double t45 = x[4]*t44; /* s*omega_tau*2 */
    const double t46 = p[1]*t5; /* R*omega_n*omega_n */
    const double t47 = x[4]*t9; /* s*R*omega_n */
    const double t48 = t0*t2; /* s*s*R*I1 */
    const double t49 = t4*t7; /* omega_n*b */
    const double t50 = p[6]*t49; /* G_level*omega_n*b */
    const double t51 = t50/t48; /* G_level*omega_n*b/(s*s*R*I1) */
    const double t52 = 2.0*t51; /* 2*G_level*omega_n*b/(s*s*R*I1) */
    const double t53 = t10 - t52; /* R*omega_n*omega3 - 2*G_level*omega_n*b/(s*s*R*I1) */
    const double t54 = x[4]*p[4]; /* s*I1 */
    const double t55 = p[6]*x[3]; /* G_level*omega3 */
    const double t56 = t55/t54; /* G_level*omega3/(s*I1) */
    const double t57 = t53 - t56; /* R*omega_n*omega3 - 2*G_level*omega_n*b/(s*s*R*I1) - G_level*omega3/(s*I1) */
    const double t58 = t14*t16; /* m*a3*a3*omega_tau*omega_tau */
    const double t59 = t0*t58; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t60 = t59/t20; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t61 = p[4]*t5; /* I1*omega_n*omega_n */
    const double t62 = t61/t20; /* I1*omega_n*omega_n/D */
    const double t63 = t60 - t62; /* s*s*m*a3*a3*omega_tau*omega_tau/D - I1*omega_n*omega_n/D */
    const double t64 = p[0]*2.0; /* m*2 */
    const double t65 = t13*t64; /* a3*a3*m*2 */
    const double t66 = x[0]*t65; /* gamma3*a3*a3*m*2 */
    const double t67 = x[2]*t66; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t68 = t0*t67; /* s*s*omega_tau*gamma3*a3*a3*m*2 */
    const double t69 = t68/t20; /* s*s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t70 = x[4]*t17; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t71 = t70/t20; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t72 = 2.0*t71; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t73 = x[4]*t23; /* s*a3*m*g */
    const double t74 = t73/t20; /* s*a3*m*g/D */
    const double t75 = 2.0*t74; /* 2*s*a3*m*g/D */
    const double t76 = t72 - t75; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D */
    const double t77 = p[0]*p[0]; /* m*m */
    const double t78 = t13*t13; /* a3*a3*a3*a3 */
    const double t79 = t77*t78; /* m*m*a3*a3*a3*a3 */
    const double t80 = x[0]*t79; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t81 = t16*t80; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t82 = x[4]*t0; /* s*s*s */
    const double t83 = t81*t82; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t84 = t20*t20; /* D*D */
    const double t85 = t83/t84; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t86 = 2.0*t85; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t87 = t76 - t86; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t88 = p[2]*t77; /* g*m*m */
    const double t89 = p[3]*t13; /* a3*a3*a3 */
    const double t90 = t88*t89; /* g*m*m*a3*a3*a3 */
    const double t91 = t82*t90; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t92 = t91/t84; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t93 = 2.0*t92; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t94 = t87 + t93; /* t87 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t95 = p[4]*t14; /* I1*m*a3*a3 */
    const double t96 = x[0]*t95; /* gamma3*I1*m*a3*a3 */
    const double t97 = t5*t96; /* omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t98 = x[4]*t97; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3 */
    const double t99 = t98/t84; /* s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t100 = 2.0*t99; /* 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t101 = t94 + t100; /* t87 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) + 2*s*omega_n*omega_n*gamma3*I1*m*a3*a3/(D*D) */
    const double t102 = t4*x[0]; /* omega_n*gamma3 */
    const double t103 = t0*p[1]; /* s*s*R */
    const double t104 = t20*t103; /* D*s*s*R */
    const double t105 = p[6]*t102; /* G_level*omega_n*gamma3 */
    const double t106 = t105/t104; /* G_level*omega_n*gamma3/(D*s*s*R) */
    const double t107 = 2.0*t106; /* 2*G_level*omega_n*gamma3/(D*s*s*R) */
    const double t108 = t101 + t107; /* t101 + 2*G_level*omega_n*gamma3/(D*s*s*R) */
    const double t109 = x[2]*p[3]; /* omega_tau*a3 */
    const double t110 = t4*t109; /* omega_n*omega_tau*a3 */
    const double t111 = t110/t31; /* omega_n*omega_tau*a3/(s*R) */
    const double t112 = x[2]*x[3]; /* omega_tau*omega3 */
    const double t113 = t112 - t111; /* omega_tau*omega3 - omega_n*omega_tau*a3/(s*R) */
    const double t114 = t4/t31; /* omega_n/(s*R) */
    const double t115 = -t114; /* -omega_n/(s*R) */
    const double t116 = t4*t33; /* omega_n*e */
    const double t117 = t116/t31; /* omega_n*e/(s*R) */
    const double t118 = x[0]*x[3]; /* gamma3*omega3 */
    const double t119 = t118 - t117; /* gamma3*omega3 - omega_n*e/(s*R) */
    const double t120 = t36/t103; /* omega_n*V/(s*s*R) */
    const double t121 = p[1]*p[1]; /* R*R */
    const double t122 = p[4]*t121; /* I1*R*R */
    const double t123 = t82*t122; /* s*s*s*I1*R*R */
    const double t124 = p[6]*t35; /* G_level*V */
    const double t125 = t124/t123; /* G_level*V/(s*s*s*I1*R*R) */
    const double t126 = t120 + t125; /* omega_n*V/(s*s*R) + G_level*V/(s*s*s*I1*R*R) */
    const double t127 = x[2]*x[4]; /* omega_tau*s */
    const double t128 = -t127; /* -omega_tau*s */
    const double t129 = x[4]*x[0]; /* s*gamma3 */
    const double t130 = -t129; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t12;
    out[2] = t30;
    out[3] = t40;
    out[4] = t43;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t45;
    out[10] = t46;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t47;
    out[14] = t57;
    out[15] = t63;
    out[16] = 0.0;
    out[17] = t69;
    out[18] = 0.0;
    out[19] = t108;
    out[20] = t113;
    out[21] = t115;
    out[22] = t119;
    out[23] = t38;
    out[24] = t126;
    out[25] = t128;
    out[26] = 0.0;
    out[27] = t130;
    out[28] = 0.0;
    out[29] = t41;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 2.0*p[0]; /* 2*m */
    const double t1 = p[3]*p[3]; /* a3*a3 */
    const double t2 = t0*t1; /* 2*m*a3*a3 */
    const double t3 = t2*x[0]; /* 2*m*a3*a3*gamma3 */
    const double t4 = t3*x[2]; /* 2*m*a3*a3*gamma3*omega_tau */
    const double t5 = x[4]*x[4]; /* s*s */
    const double t6 = t4*t5; /* 2*m*a3*a3*gamma3*omega_tau*s*s */
    const double t7 = p[0]*t1; /* m*a3*a3 */
    const double t8 = t5*t7; /* s*s*m*a3*a3 */
    const double t9 = p[4] + t8; /* D = I1 + s*s*m*a3*a3 */
    const double t10 = t6/t9; /* 2*m*a3*a3*gamma3*omega_tau*s*s/D */
    out[0] = t10;
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
    const double t10 = x[4]*x[4]; /* s*s */
    const double t11 = t9*t10; /* m*a3*a3*s*s */
    const double t12 = p[4] + t11; /* D = I1 + m*a3*a3*s*s */
    const double t13 = t7*t12; /* omega_tau*omega_tau*D */
    const double t14 = (1.0 / 2.0)*t13; /* 1/2*omega_tau*omega_tau*D */
    const double t15 = t6 + t14; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D */
    const double t16 = p[4]*p[1]; /* I1*R */
    const double t17 = x[4]*t16; /* s*I1*R */
    const double t18 = p[6]/t17; /* omega_n = G_level/(s*I1*R) */
    const double t19 = t18*t18; /* omega_n*omega_n */
    const double t20 = p[4]*t19; /* I1*omega_n*omega_n */
    const double t21 = (1.0 / 2.0)*t20; /* 1/2*I1*omega_n*omega_n */
    const double t22 = t15 + t21; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*I1*omega_n*omega_n */
    const double t23 = x[0]*p[1]; /* gamma3*R */
    const double t24 = p[3] + t23; /* b = a3 + gamma3*R */
    const double t25 = t18*t24; /* omega_n*b */
    const double t26 = p[1]*x[3]; /* R*omega3 */
    const double t27 = x[4]*t26; /* s*R*omega3 */
    const double t28 = t25 + t27; /* v_tau = omega_n*b + s*R*omega3 */
    const double t29 = t28*t28; /* v_tau*v_tau */
    const double t30 = p[0]*t29; /* m*v_tau*v_tau */
    const double t31 = (1.0 / 2.0)*t30; /* 1/2*m*v_tau*v_tau */
    const double t32 = t22 + t31; /* energy = t22 + 1/2*m*v_tau*v_tau */
    const double t33 = t5 + t31; /* m*v_nu*v_nu*1/2 + 1/2*m*v_tau*v_tau */
    const double t34 = t2 + t14; /* m*g*a3*gamma3 + 1/2*omega_tau*omega_tau*D */
    const double t35 = t21 + t34; /* 1/2*I1*omega_n*omega_n + m*g*a3*gamma3 + 1/2*omega_tau*omega_tau*D */
    out[0] = t32;
    out[1] = t33;
    out[2] = t35;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*p[1]; /* m*R */
    const double t1 = p[1]*p[4]; /* R*I1 */
    const double t2 = t1*x[4]; /* R*I1*s */
    const double t3 = p[6]/t2; /* omega_n = G_level/(R*I1*s) */
    const double t4 = t0*t3; /* m*R*omega_n */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = p[3] + t5; /* b = a3 + R*gamma3 */
    const double t7 = t3*t6; /* omega_n*b */
    const double t8 = p[1]*x[3]; /* R*omega3 */
    const double t9 = x[4]*t8; /* s*R*omega3 */
    const double t10 = t7 + t9; /* v_tau = omega_n*b + s*R*omega3 */
    const double t11 = t4*t10; /* m*R*omega_n*v_tau */
    const double t12 = p[7] + t11; /* d(energy)/d(gamma3) = m*g*a3 + m*R*omega_n*v_tau */
    const double t13 = p[0]*x[1]; /* m*v_nu */
    const double t14 = p[3]*p[3]; /* a3*a3 */
    const double t15 = p[0]*t14; /* m*a3*a3 */
    const double t16 = x[4]*x[4]; /* s*s */
    const double t17 = t15*t16; /* m*a3*a3*s*s */
    const double t18 = p[4] + t17; /* D = I1 + m*a3*a3*s*s */
    const double t19 = x[2]*t18; /* omega_tau*D */
    const double t20 = t0*x[4]; /* m*R*s */
    const double t21 = t10*t20; /* v_tau*m*R*s */
    const double t22 = p[0]*t10; /* m*v_tau */
    const double t23 = t1*t16; /* R*I1*s*s */
    const double t24 = p[6]*t6; /* G_level*b */
    const double t25 = t24/t23; /* G_level*b/(R*I1*s*s) */
    const double t26 = t8 - t25; /* d(v_tau)/d(s) = R*omega3 - G_level*b/(R*I1*s*s) */
    const double t27 = t22*t26; /* m*v_tau*d(v_tau)/d(s) */
    const double t28 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t29 = t15*t28; /* m*a3*a3*omega_tau*omega_tau */
    const double t30 = x[4]*t29; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t31 = t27 + t30; /* m*v_tau*d(v_tau)/d(s) + s*m*a3*a3*omega_tau*omega_tau */
    const double t32 = p[1]*t16; /* R*s*s */
    const double t33 = p[6]*t3; /* G_level*omega_n */
    const double t34 = t33/t32; /* G_level*omega_n/(R*s*s) */
    const double t35 = t31 - t34; /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) + s*m*a3*a3*omega_tau*omega_tau - G_level*omega_n/(R*s*s) */
    const double t36 = t30 - t34; /* s*m*a3*a3*omega_tau*omega_tau - G_level*omega_n/(R*s*s) */
    out[0] = t12;
    out[1] = t13;
    out[2] = t19;
    out[3] = t21;
    out[4] = t35;
    out[5] = t11;
    out[6] = t13;
    out[7] = 0.0;
    out[8] = t21;
    out[9] = t27;
    out[10] = p[7];
    out[11] = 0.0;
    out[12] = t19;
    out[13] = 0.0;
    out[14] = t36;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[4]; /* R*I1 */
    const double t1 = t0*x[4]; /* R*I1*s */
    const double t2 = p[6]/t1; /* omega_n = G_level/(R*I1*s) */
    out[0] = t2;
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = (0.0);
    const double complex v_omega3 = x[3];
    const double v_a3 = params[3];
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
    { "E1", "I3 = 0" },
    { "E2", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_rod_in_regular_on_level_G = {
    .model = "spherical_top",
    .variant = "rod",
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
    .rhs = { rhs, 5, { 9, 29, 0, 5, 0, 0, 8, 7 }, { 9, 36, 0, 5, 0, 0, 8, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .jacobian = { jacobian, 25, { 19, 77, 0, 17, 0, 0, 12, 12 }, { 19, 110, 0, 17, 0, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 24, 86, 0, 21, 0, 0, 12, 21 }, { 24, 137, 0, 21, 0, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .divergence = { divergence, 1, { 1, 9, 0, 1, 0, 0, 6, 4 }, { 1, 11, 0, 1, 0, 0, 6, 4 },
        "" },
    .integral_values = { integral_values, 3, { 10, 25, 0, 1, 0, 0, 9, 8 }, { 10, 40, 0, 1, 0, 0, 9, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 15, { 8, 26, 0, 3, 0, 0, 9, 10 }, { 8, 55, 0, 4, 0, 0, 9, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 2, 0, 1, 0, 0, 3, 2 }, { 0, 2, 0, 1, 0, 0, 3, 2 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_rod_in_regular_on_level_G_baseline,
        &jlt_batch_spherical_top_rod_in_regular_on_level_G_avx2,
        &jlt_batch_spherical_top_rod_in_regular_on_level_G_avx512,
    },
};
