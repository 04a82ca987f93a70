/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 15   50    0    8    0    0     11    9   (111)
 *  jacobian            57  237    0   54    0    0     18   29   (746)
 *  rhs_jacobian        63  252    0   62    0    0     18   36   (836)
 *  divergence          11   31    0    4    0    0     12    8   (56)
 *  integral_values     8   25    0    2    0    0     12    5   (37)
 *  integral_gradients  10   39    0    7    0    0     12   12   (75)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_in_regular_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[3]*params[4]; /* I1*I3 */
    const double t1 = params[3] - params[4]; /* I1 - I3 */
    const double t2 = params[4]*params[5]; /* I3*a3 */
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[5]*t3; /* a3*m*g */
    out[7] = t0;
    out[8] = t1;
    out[9] = t2;
    out[10] = t4;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[1]; /* R*R */
    const double t3 = t2*p[3]; /* R*R*I1 */
    const double t4 = t0*t3; /* s*s*R*R*I1 */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = p[5] + t5; /* b = a3 + R*gamma3 */
    const double t7 = t6*t6; /* b*b */
    const double t8 = p[4]*t7; /* I3*b*b */
    const double t9 = t4 + t8; /* K = s*s*R*R*I1 + I3*b*b */
    const double t10 = p[1]*p[6]; /* R*G */
    const double t11 = x[4]*t10; /* s*R*G */
    const double t12 = x[3]*p[4]; /* v_tau*I3 */
    const double t13 = t6*t12; /* b*v_tau*I3 */
    const double t14 = t11 + t13; /* s*R*G + b*v_tau*I3 */
    const double t15 = x[3]*t14; /* v_tau*(s*R*G + b*v_tau*I3) */
    const double t16 = t15/t9; /* v_tau*(s*R*G + b*v_tau*I3)/K */
    const double t17 = p[5]*p[5]; /* a3*a3 */
    const double t18 = p[0]*t17; /* m*a3*a3 */
    const double t19 = x[0]*t18; /* gamma3*m*a3*a3 */
    const double t20 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t21 = t19*t20; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t22 = t0*t21; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t23 = t0*t18; /* s*s*m*a3*a3 */
    const double t24 = p[3] + t23; /* D = I1 + s*s*m*a3*a3 */
    const double t25 = t22/t24; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t26 = p[0]*p[2]; /* m*g */
    const double t27 = p[5]*t26; /* a3*m*g */
    const double t28 = t0*t27; /* s*s*a3*m*g */
    const double t29 = t28/t24; /* s*s*a3*m*g/D */
    const double t30 = t25 - t29; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t31 = p[3]*x[0]; /* I1*gamma3 */
    const double t32 = t9*t9; /* K*K */
    const double t33 = t24*t32; /* D*K*K */
    const double t34 = t14*t14; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t35 = t31*t34; /* I1*gamma3*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t36 = t35/t33; /* I1*gamma3*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(D*K*K) */
    const double t37 = t30 - t36; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - I1*gamma3*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(D*K*K) */
    const double t38 = x[4]*p[4]; /* s*I3 */
    const double t39 = t14*t38; /* (s*R*G + b*v_tau*I3)*s*I3 */
    const double t40 = p[1]*p[3]; /* R*I1 */
    const double t41 = x[3]*t40; /* v_tau*R*I1 */
    const double t42 = x[4]*t41; /* s*v_tau*R*I1 */
    const double t43 = t6*p[6]; /* b*G */
    const double t44 = t42 - t43; /* s*v_tau*R*I1 - b*G */
    const double t45 = t39*t44; /* (s*R*G + b*v_tau*I3)*s*I3*(s*v_tau*R*I1 - b*G) */
    const double t46 = t45/t33; /* (s*R*G + b*v_tau*I3)*s*I3*(s*v_tau*R*I1 - b*G)/(D*K*K) */
    const double t47 = t37 - t46; /* t37 - (s*R*G + b*v_tau*I3)*s*I3*(s*v_tau*R*I1 - b*G)/(D*K*K) */
    const double t48 = t14*x[1]; /* (s*R*G + b*v_tau*I3)*v_nu */
    const double t49 = t48/t9; /* (s*R*G + b*v_tau*I3)*v_nu/K */
    const double t50 = p[3]*p[4]; /* I1*I3 */
    const double t51 = t9*p[0]; /* K*m */
    const double t52 = t51 + p[7]; /* Theta = K*m + I1*I3 */
    const double t53 = t9*t52; /* K*Theta */
    const double t54 = p[5]*x[0]; /* a3*gamma3 */
    const double t55 = p[1] + t54; /* e = R + a3*gamma3 */
    const double t56 = x[2]*t55; /* omega_tau*e */
    const double t57 = x[1] + t56; /* V = v_nu + omega_tau*e */
    const double t58 = t50*t57; /* I1*I3*V */
    const double t59 = t14*t58; /* (s*R*G + b*v_tau*I3)*I1*I3*V */
    const double t60 = t59/t53; /* (s*R*G + b*v_tau*I3)*I1*I3*V/(K*Theta) */
    const double t61 = t60 - t49; /* (s*R*G + b*v_tau*I3)*I1*I3*V/(K*Theta) - (s*R*G + b*v_tau*I3)*v_nu/K */
    const double t62 = x[2]*p[4]; /* omega_tau*I3 */
    const double t63 = x[4]*t62; /* s*omega_tau*I3 */
    const double t64 = t44*t63; /* (s*v_tau*R*I1 - b*G)*s*omega_tau*I3 */
    const double t65 = t5*p[8]; /* R*gamma3*(I1 - I3) */
    const double t66 = t65 - p[9]; /* R*gamma3*(I1 - I3) - I3*a3 */
    const double t67 = t64*t66; /* (s*v_tau*R*I1 - b*G)*s*omega_tau*I3*(R*gamma3*(I1 - I3) - I3*a3) */
    const double t68 = t67/t53; /* t67/(K*Theta) */
    const double t69 = t61 - t68; /* t61 - t67/(K*Theta) */
    const double t70 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t71 = x[4]*t70; /* s*omega_tau*gamma3 */
    const double t72 = -t71; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t16;
    out[2] = t47;
    out[3] = t69;
    out[4] = t72;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = 2.0*x[2]; /* 2*omega_tau */
    const double t2 = x[4]*t1; /* s*2*omega_tau */
    const double t3 = p[1]*p[4]; /* R*I3 */
    const double t4 = x[3]*x[3]; /* v_tau*v_tau */
    const double t5 = t3*t4; /* R*I3*v_tau*v_tau */
    const double t6 = p[1]*p[1]; /* R*R */
    const double t7 = t6*p[3]; /* R*R*I1 */
    const double t8 = t0*t7; /* s*s*R*R*I1 */
    const double t9 = p[1]*x[0]; /* R*gamma3 */
    const double t10 = p[5] + t9; /* b = a3 + R*gamma3 */
    const double t11 = t10*t10; /* b*b */
    const double t12 = p[4]*t11; /* I3*b*b */
    const double t13 = t8 + t12; /* K = s*s*R*R*I1 + I3*b*b */
    const double t14 = t5/t13; /* R*I3*v_tau*v_tau/K */
    const double t15 = t3*x[3]; /* R*I3*v_tau */
    const double t16 = t10*t15; /* b*R*I3*v_tau */
    const double t17 = t13*t13; /* K*K */
    const double t18 = p[1]*p[6]; /* R*G */
    const double t19 = x[4]*t18; /* s*R*G */
    const double t20 = p[4]*x[3]; /* I3*v_tau */
    const double t21 = t10*t20; /* b*I3*v_tau */
    const double t22 = t19 + t21; /* s*R*G + b*I3*v_tau */
    const double t23 = t16*t22; /* b*R*I3*v_tau*(s*R*G + b*I3*v_tau) */
    const double t24 = t23/t17; /* b*R*I3*v_tau*(s*R*G + b*I3*v_tau)/(K*K) */
    const double t25 = 2.0*t24; /* 2*b*R*I3*v_tau*(s*R*G + b*I3*v_tau)/(K*K) */
    const double t26 = t14 - t25; /* R*I3*v_tau*v_tau/K - 2*b*R*I3*v_tau*(s*R*G + b*I3*v_tau)/(K*K) */
    const double t27 = t22/t13; /* (s*R*G + b*I3*v_tau)/K */
    const double t28 = t21/t13; /* b*I3*v_tau/K */
    const double t29 = t27 + t28; /* (s*R*G + b*I3*v_tau)/K + b*I3*v_tau/K */
    const double t30 = x[3]*t18; /* v_tau*R*G */
    const double t31 = t30/t13; /* v_tau*R*G/K */
    const double t32 = x[3]*t7; /* v_tau*R*R*I1 */
    const double t33 = x[4]*t32; /* s*v_tau*R*R*I1 */
    const double t34 = t22*t33; /* (s*R*G + b*I3*v_tau)*s*v_tau*R*R*I1 */
    const double t35 = t34/t17; /* (s*R*G + b*I3*v_tau)*s*v_tau*R*R*I1/(K*K) */
    const double t36 = 2.0*t35; /* 2*(s*R*G + b*I3*v_tau)*s*v_tau*R*R*I1/(K*K) */
    const double t37 = t31 - t36; /* v_tau*R*G/K - 2*(s*R*G + b*I3*v_tau)*s*v_tau*R*R*I1/(K*K) */
    const double t38 = p[5]*p[5]; /* a3*a3 */
    const double t39 = p[0]*t38; /* m*a3*a3 */
    const double t40 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t41 = t39*t40; /* m*a3*a3*omega_tau*omega_tau */
    const double t42 = t0*t41; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t43 = t0*t39; /* s*s*m*a3*a3 */
    const double t44 = p[3] + t43; /* D = I1 + s*s*m*a3*a3 */
    const double t45 = t42/t44; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t46 = t17*t44; /* K*K*D */
    const double t47 = t22*t22; /* (s*R*G + b*I3*v_tau)*(s*R*G + b*I3*v_tau) */
    const double t48 = p[3]*t47; /* I1*(s*R*G + b*I3*v_tau)*(s*R*G + b*I3*v_tau) */
    const double t49 = t48/t46; /* I1*(s*R*G + b*I3*v_tau)*(s*R*G + b*I3*v_tau)/(K*K*D) */
    const double t50 = t45 - t49; /* s*s*m*a3*a3*omega_tau*omega_tau/D - I1*(s*R*G + b*I3*v_tau)*(s*R*G + b*I3*v_tau)/(K*K*D) */
    const double t51 = p[1]*p[3]; /* R*I1 */
    const double t52 = p[4]*t51; /* I3*R*I1 */
    const double t53 = x[0]*t52; /* gamma3*I3*R*I1 */
    const double t54 = x[3]*t53; /* v_tau*gamma3*I3*R*I1 */
    const double t55 = t22*t54; /* (s*R*G + b*I3*v_tau)*v_tau*gamma3*I3*R*I1 */
    const double t56 = t55/t46; /* (s*R*G + b*I3*v_tau)*v_tau*gamma3*I3*R*I1/(K*K*D) */
    const double t57 = 2.0*t56; /* 2*(s*R*G + b*I3*v_tau)*v_tau*gamma3*I3*R*I1/(K*K*D) */
    const double t58 = t50 - t57; /* t50 - 2*(s*R*G + b*I3*v_tau)*v_tau*gamma3*I3*R*I1/(K*K*D) */
    const double t59 = t10*t53; /* b*gamma3*I3*R*I1 */
    const double t60 = t13*t17; /* K*K*K */
    const double t61 = t44*t60; /* D*K*K*K */
    const double t62 = t47*t59; /* (s*R*G + b*I3*v_tau)*(s*R*G + b*I3*v_tau)*b*gamma3*I3*R*I1 */
    const double t63 = t62/t61; /* (s*R*G + b*I3*v_tau)*(s*R*G + b*I3*v_tau)*b*gamma3*I3*R*I1/(D*K*K*K) */
    const double t64 = t63*4.0; /* t63*4 */
    const double t65 = t58 + t64; /* t50 - 2*(s*R*G + b*I3*v_tau)*v_tau*gamma3*I3*R*I1/(K*K*D) + t63*4 */
    const double t66 = p[4]*p[4]; /* I3*I3 */
    const double t67 = p[1]*t66; /* R*I3*I3 */
    const double t68 = x[3]*t67; /* v_tau*R*I3*I3 */
    const double t69 = x[4]*t68; /* s*v_tau*R*I3*I3 */
    const double t70 = x[3]*t51; /* v_tau*R*I1 */
    const double t71 = x[4]*t70; /* s*v_tau*R*I1 */
    const double t72 = t10*p[6]; /* b*G */
    const double t73 = t71 - t72; /* s*v_tau*R*I1 - b*G */
    const double t74 = t69*t73; /* s*v_tau*R*I3*I3*(s*v_tau*R*I1 - b*G) */
    const double t75 = t74/t46; /* s*v_tau*R*I3*I3*(s*v_tau*R*I1 - b*G)/(K*K*D) */
    const double t76 = t65 - t75; /* t65 - s*v_tau*R*I3*I3*(s*v_tau*R*I1 - b*G)/(K*K*D) */
    const double t77 = x[4]*t67; /* s*R*I3*I3 */
    const double t78 = t10*t77; /* b*s*R*I3*I3 */
    const double t79 = t22*t78; /* (s*R*G + b*I3*v_tau)*b*s*R*I3*I3 */
    const double t80 = t73*t79; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*I3*v_tau)*b*s*R*I3*I3 */
    const double t81 = t80/t61; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*I3*v_tau)*b*s*R*I3*I3/(D*K*K*K) */
    const double t82 = 4.0*t81; /* 4*t81 */
    const double t83 = t76 + t82; /* t65 - s*v_tau*R*I3*I3*(s*v_tau*R*I1 - b*G)/(K*K*D) + 4*t81 */
    const double t84 = t3*p[6]; /* R*I3*G */
    const double t85 = x[4]*t84; /* s*R*I3*G */
    const double t86 = t22*t85; /* (s*R*G + b*I3*v_tau)*s*R*I3*G */
    const double t87 = t86/t46; /* (s*R*G + b*I3*v_tau)*s*R*I3*G/(K*K*D) */
    const double t88 = t83 + t87; /* t65 - s*v_tau*R*I3*I3*(s*v_tau*R*I1 - b*G)/(K*K*D) + 4*t81 + (s*R*G + b*I3*v_tau)*s*R*I3*G/(K*K*D) */
    const double t89 = 2.0*p[0]; /* 2*m */
    const double t90 = t38*t89; /* a3*a3*2*m */
    const double t91 = x[0]*t90; /* gamma3*a3*a3*2*m */
    const double t92 = x[2]*t91; /* omega_tau*gamma3*a3*a3*2*m */
    const double t93 = t0*t92; /* s*s*omega_tau*gamma3*a3*a3*2*m */
    const double t94 = t93/t44; /* s*s*omega_tau*gamma3*a3*a3*2*m/D */
    const double t95 = p[4]*p[3]; /* I3*I1 */
    const double t96 = x[0]*t95; /* gamma3*I3*I1 */
    const double t97 = t10*t96; /* b*gamma3*I3*I1 */
    const double t98 = t22*t97; /* (s*R*G + b*I3*v_tau)*b*gamma3*I3*I1 */
    const double t99 = t98/t46; /* (s*R*G + b*I3*v_tau)*b*gamma3*I3*I1/(K*K*D) */
    const double t100 = 2.0*t99; /* 2*(s*R*G + b*I3*v_tau)*b*gamma3*I3*I1/(K*K*D) */
    const double t101 = -t100; /* -2*(s*R*G + b*I3*v_tau)*b*gamma3*I3*I1/(K*K*D) */
    const double t102 = x[4]*t66; /* s*I3*I3 */
    const double t103 = t10*t102; /* b*s*I3*I3 */
    const double t104 = t73*t103; /* (s*v_tau*R*I1 - b*G)*b*s*I3*I3 */
    const double t105 = t104/t46; /* (s*v_tau*R*I1 - b*G)*b*s*I3*I3/(K*K*D) */
    const double t106 = t101 - t105; /* -2*(s*R*G + b*I3*v_tau)*b*gamma3*I3*I1/(K*K*D) - (s*v_tau*R*I1 - b*G)*b*s*I3*I3/(K*K*D) */
    const double t107 = t0*t52; /* s*s*I3*R*I1 */
    const double t108 = t22*t107; /* (s*R*G + b*I3*v_tau)*s*s*I3*R*I1 */
    const double t109 = t108/t46; /* (s*R*G + b*I3*v_tau)*s*s*I3*R*I1/(K*K*D) */
    const double t110 = t106 - t109; /* t106 - (s*R*G + b*I3*v_tau)*s*s*I3*R*I1/(K*K*D) */
    const double t111 = x[0]*t39; /* gamma3*m*a3*a3 */
    const double t112 = t40*t111; /* omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t113 = x[4]*t112; /* s*omega_tau*omega_tau*gamma3*m*a3*a3 */
    const double t114 = t113/t44; /* s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t115 = 2.0*t114; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D */
    const double t116 = p[0]*p[2]; /* m*g */
    const double t117 = p[5]*t116; /* a3*m*g */
    const double t118 = x[4]*t117; /* s*a3*m*g */
    const double t119 = t118/t44; /* s*a3*m*g/D */
    const double t120 = 2.0*t119; /* 2*s*a3*m*g/D */
    const double t121 = t115 - t120; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D */
    const double t122 = p[4]*t22; /* I3*(s*R*G + b*I3*v_tau) */
    const double t123 = t73*t122; /* (s*v_tau*R*I1 - b*G)*I3*(s*R*G + b*I3*v_tau) */
    const double t124 = t123/t46; /* (s*v_tau*R*I1 - b*G)*I3*(s*R*G + b*I3*v_tau)/(K*K*D) */
    const double t125 = t121 - t124; /* 2*s*omega_tau*omega_tau*gamma3*m*a3*a3/D - 2*s*a3*m*g/D - (s*v_tau*R*I1 - b*G)*I3*(s*R*G + b*I3*v_tau)/(K*K*D) */
    const double t126 = p[0]*p[0]; /* m*m */
    const double t127 = t38*t38; /* a3*a3*a3*a3 */
    const double t128 = t126*t127; /* m*m*a3*a3*a3*a3 */
    const double t129 = x[0]*t128; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t130 = t40*t129; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t131 = x[4]*t0; /* s*s*s */
    const double t132 = t130*t131; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t133 = t44*t44; /* D*D */
    const double t134 = t132/t133; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t135 = 2.0*t134; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t136 = t125 - t135; /* t125 - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t137 = p[2]*t126; /* g*m*m */
    const double t138 = p[5]*t38; /* a3*a3*a3 */
    const double t139 = t137*t138; /* g*m*m*a3*a3*a3 */
    const double t140 = t131*t139; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t141 = t140/t133; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t142 = 2.0*t141; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t143 = t136 + t142; /* t136 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t144 = p[6]*t51; /* G*R*I1 */
    const double t145 = x[0]*t144; /* gamma3*G*R*I1 */
    const double t146 = t22*t145; /* (s*R*G + b*I3*v_tau)*gamma3*G*R*I1 */
    const double t147 = t146/t46; /* (s*R*G + b*I3*v_tau)*gamma3*G*R*I1/(K*K*D) */
    const double t148 = 2.0*t147; /* 2*(s*R*G + b*I3*v_tau)*gamma3*G*R*I1/(K*K*D) */
    const double t149 = t143 - t148; /* t136 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) - 2*(s*R*G + b*I3*v_tau)*gamma3*G*R*I1/(K*K*D) */
    const double t150 = p[3]*p[3]; /* I1*I1 */
    const double t151 = t6*t150; /* R*R*I1*I1 */
    const double t152 = x[0]*t151; /* gamma3*R*R*I1*I1 */
    const double t153 = x[4]*t152; /* s*gamma3*R*R*I1*I1 */
    const double t154 = t47*t153; /* (s*R*G + b*I3*v_tau)*(s*R*G + b*I3*v_tau)*s*gamma3*R*R*I1*I1 */
    const double t155 = t154/t61; /* (s*R*G + b*I3*v_tau)*(s*R*G + b*I3*v_tau)*s*gamma3*R*R*I1*I1/(D*K*K*K) */
    const double t156 = 4.0*t155; /* 4*t155 */
    const double t157 = t149 + t156; /* t149 + 4*t155 */
    const double t158 = p[3]*p[0]; /* I1*m */
    const double t159 = t38*t158; /* a3*a3*I1*m */
    const double t160 = x[0]*t159; /* gamma3*a3*a3*I1*m */
    const double t161 = x[4]*t160; /* s*gamma3*a3*a3*I1*m */
    const double t162 = t17*t133; /* K*K*D*D */
    const double t163 = t47*t161; /* (s*R*G + b*I3*v_tau)*(s*R*G + b*I3*v_tau)*s*gamma3*a3*a3*I1*m */
    const double t164 = t163/t162; /* t163/(K*K*D*D) */
    const double t165 = 2.0*t164; /* 2*t163/(K*K*D*D) */
    const double t166 = t157 + t165; /* t149 + 4*t155 + 2*t163/(K*K*D*D) */
    const double t167 = t73*t85; /* (s*v_tau*R*I1 - b*G)*s*R*I3*G */
    const double t168 = t167/t46; /* (s*v_tau*R*I1 - b*G)*s*R*I3*G/(K*K*D) */
    const double t169 = t166 - t168; /* t149 + 4*t155 + 2*t163/(K*K*D*D) - (s*v_tau*R*I1 - b*G)*s*R*I3*G/(K*K*D) */
    const double t170 = x[3]*t52; /* v_tau*I3*R*I1 */
    const double t171 = x[4]*t170; /* s*v_tau*I3*R*I1 */
    const double t172 = t22*t171; /* (s*R*G + b*I3*v_tau)*s*v_tau*I3*R*I1 */
    const double t173 = t172/t46; /* (s*R*G + b*I3*v_tau)*s*v_tau*I3*R*I1/(K*K*D) */
    const double t174 = t169 - t173; /* t169 - (s*R*G + b*I3*v_tau)*s*v_tau*I3*R*I1/(K*K*D) */
    const double t175 = p[4]*t7; /* I3*R*R*I1 */
    const double t176 = t0*t175; /* s*s*I3*R*R*I1 */
    const double t177 = t22*t176; /* (s*R*G + b*I3*v_tau)*s*s*I3*R*R*I1 */
    const double t178 = t73*t177; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*I3*v_tau)*s*s*I3*R*R*I1 */
    const double t179 = t178/t61; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*I3*v_tau)*s*s*I3*R*R*I1/(D*K*K*K) */
    const double t180 = 4.0*t179; /* 4*t179 */
    const double t181 = t174 + t180; /* t169 - (s*R*G + b*I3*v_tau)*s*v_tau*I3*R*I1/(K*K*D) + 4*t179 */
    const double t182 = p[4]*p[0]; /* I3*m */
    const double t183 = t38*t182; /* a3*a3*I3*m */
    const double t184 = t0*t183; /* s*s*a3*a3*I3*m */
    const double t185 = t22*t184; /* (s*R*G + b*I3*v_tau)*s*s*a3*a3*I3*m */
    const double t186 = t73*t185; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*I3*v_tau)*s*s*a3*a3*I3*m */
    const double t187 = t186/t162; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*I3*v_tau)*s*s*a3*a3*I3*m/(K*K*D*D) */
    const double t188 = 2.0*t187; /* 2*t187 */
    const double t189 = t181 + t188; /* t169 - (s*R*G + b*I3*v_tau)*s*v_tau*I3*R*I1/(K*K*D) + 4*t179 + 2*t187 */
    const double t190 = t3*x[1]; /* R*I3*v_nu */
    const double t191 = x[3]*t190; /* v_tau*R*I3*v_nu */
    const double t192 = t191/t13; /* v_tau*R*I3*v_nu/K */
    const double t193 = t10*t190; /* b*R*I3*v_nu */
    const double t194 = t22*t193; /* (s*R*G + b*I3*v_tau)*b*R*I3*v_nu */
    const double t195 = t194/t17; /* (s*R*G + b*I3*v_tau)*b*R*I3*v_nu/(K*K) */
    const double t196 = 2.0*t195; /* 2*(s*R*G + b*I3*v_tau)*b*R*I3*v_nu/(K*K) */
    const double t197 = t196 - t192; /* 2*(s*R*G + b*I3*v_tau)*b*R*I3*v_nu/(K*K) - v_tau*R*I3*v_nu/K */
    const double t198 = p[5]*t95; /* a3*I3*I1 */
    const double t199 = x[2]*t198; /* omega_tau*a3*I3*I1 */
    const double t200 = t13*p[0]; /* K*m */
    const double t201 = t200 + p[7]; /* Theta = K*m + I1*I3 */
    const double t202 = t13*t201; /* K*Theta */
    const double t203 = t22*t199; /* (s*R*G + b*I3*v_tau)*omega_tau*a3*I3*I1 */
    const double t204 = t203/t202; /* (s*R*G + b*I3*v_tau)*omega_tau*a3*I3*I1/(K*Theta) */
    const double t205 = t197 + t204; /* 2*(s*R*G + b*I3*v_tau)*b*R*I3*v_nu/(K*K) - v_tau*R*I3*v_nu/K + (s*R*G + b*I3*v_tau)*omega_tau*a3*I3*I1/(K*Theta) */
    const double t206 = t51*t66; /* R*I1*I3*I3 */
    const double t207 = x[3]*t206; /* v_tau*R*I1*I3*I3 */
    const double t208 = p[5]*x[0]; /* a3*gamma3 */
    const double t209 = p[1] + t208; /* e = R + a3*gamma3 */
    const double t210 = x[2]*t209; /* omega_tau*e */
    const double t211 = x[1] + t210; /* V = v_nu + omega_tau*e */
    const double t212 = t207*t211; /* v_tau*R*I1*I3*I3*V */
    const double t213 = t212/t202; /* v_tau*R*I1*I3*I3*V/(K*Theta) */
    const double t214 = t205 + t213; /* t205 + v_tau*R*I1*I3*I3*V/(K*Theta) */
    const double t215 = t10*t206; /* b*R*I1*I3*I3 */
    const double t216 = t17*t201; /* K*K*Theta */
    const double t217 = t211*t215; /* V*b*R*I1*I3*I3 */
    const double t218 = t22*t217; /* (s*R*G + b*I3*v_tau)*V*b*R*I1*I3*I3 */
    const double t219 = t218/t216; /* (s*R*G + b*I3*v_tau)*V*b*R*I1*I3*I3/(K*K*Theta) */
    const double t220 = 2.0*t219; /* 2*(s*R*G + b*I3*v_tau)*V*b*R*I1*I3*I3/(K*K*Theta) */
    const double t221 = t214 - t220; /* t205 + v_tau*R*I1*I3*I3*V/(K*Theta) - 2*(s*R*G + b*I3*v_tau)*V*b*R*I1*I3*I3/(K*K*Theta) */
    const double t222 = p[1]*p[0]; /* R*m */
    const double t223 = p[3]*t222; /* I1*R*m */
    const double t224 = t66*t223; /* I3*I3*I1*R*m */
    const double t225 = t10*t224; /* b*I3*I3*I1*R*m */
    const double t226 = t201*t201; /* Theta*Theta */
    const double t227 = t13*t226; /* K*Theta*Theta */
    const double t228 = t211*t225; /* V*b*I3*I3*I1*R*m */
    const double t229 = t22*t228; /* (s*R*G + b*I3*v_tau)*V*b*I3*I3*I1*R*m */
    const double t230 = t229/t227; /* (s*R*G + b*I3*v_tau)*V*b*I3*I3*I1*R*m/(K*Theta*Theta) */
    const double t231 = 2.0*t230; /* 2*(s*R*G + b*I3*v_tau)*V*b*I3*I3*I1*R*m/(K*Theta*Theta) */
    const double t232 = t221 - t231; /* t221 - 2*(s*R*G + b*I3*v_tau)*V*b*I3*I3*I1*R*m/(K*Theta*Theta) */
    const double t233 = x[2]*t3; /* omega_tau*R*I3 */
    const double t234 = x[4]*t233; /* s*omega_tau*R*I3 */
    const double t235 = t73*t234; /* (s*v_tau*R*I1 - b*G)*s*omega_tau*R*I3 */
    const double t236 = t235*p[8]; /* (s*v_tau*R*I1 - b*G)*s*omega_tau*R*I3*(I1 - I3) */
    const double t237 = t236/t202; /* (s*v_tau*R*I1 - b*G)*s*omega_tau*R*I3*(I1 - I3)/(K*Theta) */
    const double t238 = t232 - t237; /* t232 - (s*v_tau*R*I1 - b*G)*s*omega_tau*R*I3*(I1 - I3)/(K*Theta) */
    const double t239 = x[2]*t67; /* omega_tau*R*I3*I3 */
    const double t240 = x[4]*t239; /* s*omega_tau*R*I3*I3 */
    const double t241 = t10*t240; /* b*s*omega_tau*R*I3*I3 */
    const double t242 = t73*t241; /* (s*v_tau*R*I1 - b*G)*b*s*omega_tau*R*I3*I3 */
    const double t243 = t9*p[8]; /* R*gamma3*(I1 - I3) */
    const double t244 = t243 - p[9]; /* R*gamma3*(I1 - I3) - I3*a3 */
    const double t245 = t242*t244; /* (s*v_tau*R*I1 - b*G)*b*s*omega_tau*R*I3*I3*(R*gamma3*(I1 - I3) - I3*a3) */
    const double t246 = t245/t216; /* t245/(K*K*Theta) */
    const double t247 = 2.0*t246; /* 2*t245/(K*K*Theta) */
    const double t248 = t238 + t247; /* t238 + 2*t245/(K*K*Theta) */
    const double t249 = t66*t222; /* I3*I3*R*m */
    const double t250 = x[2]*t249; /* omega_tau*I3*I3*R*m */
    const double t251 = x[4]*t250; /* s*omega_tau*I3*I3*R*m */
    const double t252 = t10*t251; /* b*s*omega_tau*I3*I3*R*m */
    const double t253 = t73*t252; /* (s*v_tau*R*I1 - b*G)*b*s*omega_tau*I3*I3*R*m */
    const double t254 = t244*t253; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*b*s*omega_tau*I3*I3*R*m */
    const double t255 = t254/t227; /* t254/(K*Theta*Theta) */
    const double t256 = 2.0*t255; /* 2*t254/(K*Theta*Theta) */
    const double t257 = t248 + t256; /* t238 + 2*t245/(K*K*Theta) + 2*t254/(K*Theta*Theta) */
    const double t258 = x[2]*t84; /* omega_tau*R*I3*G */
    const double t259 = x[4]*t258; /* s*omega_tau*R*I3*G */
    const double t260 = t244*t259; /* (R*gamma3*(I1 - I3) - I3*a3)*s*omega_tau*R*I3*G */
    const double t261 = t260/t202; /* (R*gamma3*(I1 - I3) - I3*a3)*s*omega_tau*R*I3*G/(K*Theta) */
    const double t262 = t257 + t261; /* t238 + 2*t245/(K*K*Theta) + 2*t254/(K*Theta*Theta) + (R*gamma3*(I1 - I3) - I3*a3)*s*omega_tau*R*I3*G/(K*Theta) */
    const double t263 = t22*t95; /* (s*R*G + b*I3*v_tau)*I3*I1 */
    const double t264 = t263/t202; /* (s*R*G + b*I3*v_tau)*I3*I1/(K*Theta) */
    const double t265 = t264 - t27; /* (s*R*G + b*I3*v_tau)*I3*I1/(K*Theta) - (s*R*G + b*I3*v_tau)/K */
    const double t266 = t95*t209; /* I3*I1*e */
    const double t267 = t22*t266; /* (s*R*G + b*I3*v_tau)*I3*I1*e */
    const double t268 = t267/t202; /* (s*R*G + b*I3*v_tau)*I3*I1*e/(K*Theta) */
    const double t269 = x[4]*p[4]; /* s*I3 */
    const double t270 = t73*t269; /* (s*v_tau*R*I1 - b*G)*s*I3 */
    const double t271 = t244*t270; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*s*I3 */
    const double t272 = t271/t202; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*s*I3/(K*Theta) */
    const double t273 = t268 - t272; /* (s*R*G + b*I3*v_tau)*I3*I1*e/(K*Theta) - t272 */
    const double t274 = p[4]*x[1]; /* I3*v_nu */
    const double t275 = t10*t274; /* b*I3*v_nu */
    const double t276 = t275/t13; /* b*I3*v_nu/K */
    const double t277 = p[3]*t66; /* I1*I3*I3 */
    const double t278 = t10*t277; /* b*I1*I3*I3 */
    const double t279 = t211*t278; /* V*b*I1*I3*I3 */
    const double t280 = t279/t202; /* V*b*I1*I3*I3/(K*Theta) */
    const double t281 = t280 - t276; /* V*b*I1*I3*I3/(K*Theta) - b*I3*v_nu/K */
    const double t282 = x[2]*t52; /* omega_tau*I3*R*I1 */
    const double t283 = t0*t282; /* s*s*omega_tau*I3*R*I1 */
    const double t284 = t244*t283; /* (R*gamma3*(I1 - I3) - I3*a3)*s*s*omega_tau*I3*R*I1 */
    const double t285 = t284/t202; /* (R*gamma3*(I1 - I3) - I3*a3)*s*s*omega_tau*I3*R*I1/(K*Theta) */
    const double t286 = t281 - t285; /* V*b*I1*I3*I3/(K*Theta) - b*I3*v_nu/K - (R*gamma3*(I1 - I3) - I3*a3)*s*s*omega_tau*I3*R*I1/(K*Theta) */
    const double t287 = x[2]*p[4]; /* omega_tau*I3 */
    const double t288 = t73*t287; /* (s*v_tau*R*I1 - b*G)*omega_tau*I3 */
    const double t289 = t244*t288; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*omega_tau*I3 */
    const double t290 = t289/t202; /* t289/(K*Theta) */
    const double t291 = -t290; /* -t289/(K*Theta) */
    const double t292 = t18*x[1]; /* R*G*v_nu */
    const double t293 = t292/t13; /* R*G*v_nu/K */
    const double t294 = t291 - t293; /* -t289/(K*Theta) - R*G*v_nu/K */
    const double t295 = t7*x[1]; /* R*R*I1*v_nu */
    const double t296 = x[4]*t295; /* s*R*R*I1*v_nu */
    const double t297 = t22*t296; /* (s*R*G + b*I3*v_tau)*s*R*R*I1*v_nu */
    const double t298 = t297/t17; /* (s*R*G + b*I3*v_tau)*s*R*R*I1*v_nu/(K*K) */
    const double t299 = 2.0*t298; /* 2*(s*R*G + b*I3*v_tau)*s*R*R*I1*v_nu/(K*K) */
    const double t300 = t294 + t299; /* -t289/(K*Theta) - R*G*v_nu/K + 2*(s*R*G + b*I3*v_tau)*s*R*R*I1*v_nu/(K*K) */
    const double t301 = p[6]*t52; /* G*I3*R*I1 */
    const double t302 = t211*t301; /* V*G*I3*R*I1 */
    const double t303 = t302/t202; /* V*G*I3*R*I1/(K*Theta) */
    const double t304 = t300 + t303; /* t300 + V*G*I3*R*I1/(K*Theta) */
    const double t305 = p[4]*t151; /* I3*R*R*I1*I1 */
    const double t306 = x[4]*t305; /* s*I3*R*R*I1*I1 */
    const double t307 = t211*t306; /* V*s*I3*R*R*I1*I1 */
    const double t308 = t22*t307; /* (s*R*G + b*I3*v_tau)*V*s*I3*R*R*I1*I1 */
    const double t309 = t308/t216; /* (s*R*G + b*I3*v_tau)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t310 = 2.0*t309; /* 2*(s*R*G + b*I3*v_tau)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t311 = t304 - t310; /* t300 + V*G*I3*R*I1/(K*Theta) - 2*(s*R*G + b*I3*v_tau)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t312 = t6*p[0]; /* R*R*m */
    const double t313 = t150*t312; /* I1*I1*R*R*m */
    const double t314 = p[4]*t313; /* I3*I1*I1*R*R*m */
    const double t315 = x[4]*t314; /* s*I3*I1*I1*R*R*m */
    const double t316 = t211*t315; /* V*s*I3*I1*I1*R*R*m */
    const double t317 = t22*t316; /* (s*R*G + b*I3*v_tau)*V*s*I3*I1*I1*R*R*m */
    const double t318 = t317/t227; /* (s*R*G + b*I3*v_tau)*V*s*I3*I1*I1*R*R*m/(K*Theta*Theta) */
    const double t319 = 2.0*t318; /* 2*(s*R*G + b*I3*v_tau)*V*s*I3*I1*I1*R*R*m/(K*Theta*Theta) */
    const double t320 = t311 - t319; /* t311 - 2*(s*R*G + b*I3*v_tau)*V*s*I3*I1*I1*R*R*m/(K*Theta*Theta) */
    const double t321 = x[3]*t282; /* v_tau*omega_tau*I3*R*I1 */
    const double t322 = x[4]*t321; /* s*v_tau*omega_tau*I3*R*I1 */
    const double t323 = t244*t322; /* (R*gamma3*(I1 - I3) - I3*a3)*s*v_tau*omega_tau*I3*R*I1 */
    const double t324 = t323/t202; /* (R*gamma3*(I1 - I3) - I3*a3)*s*v_tau*omega_tau*I3*R*I1/(K*Theta) */
    const double t325 = t320 - t324; /* t320 - t324 */
    const double t326 = x[2]*t175; /* omega_tau*I3*R*R*I1 */
    const double t327 = t0*t326; /* s*s*omega_tau*I3*R*R*I1 */
    const double t328 = t73*t327; /* (s*v_tau*R*I1 - b*G)*s*s*omega_tau*I3*R*R*I1 */
    const double t329 = t244*t328; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*s*s*omega_tau*I3*R*R*I1 */
    const double t330 = t329/t216; /* t329/(K*K*Theta) */
    const double t331 = 2.0*t330; /* 2*t329/(K*K*Theta) */
    const double t332 = t325 + t331; /* t320 - t324 + 2*t329/(K*K*Theta) */
    const double t333 = p[3]*t312; /* I1*R*R*m */
    const double t334 = p[4]*t333; /* I3*I1*R*R*m */
    const double t335 = x[2]*t334; /* omega_tau*I3*I1*R*R*m */
    const double t336 = t0*t335; /* s*s*omega_tau*I3*I1*R*R*m */
    const double t337 = t73*t336; /* (s*v_tau*R*I1 - b*G)*s*s*omega_tau*I3*I1*R*R*m */
    const double t338 = t244*t337; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*s*s*omega_tau*I3*I1*R*R*m */
    const double t339 = t338/t227; /* t338/(K*Theta*Theta) */
    const double t340 = 2.0*t339; /* 2*t338/(K*Theta*Theta) */
    const double t341 = t332 + t340; /* t320 - t324 + 2*t329/(K*K*Theta) + 2*t338/(K*Theta*Theta) */
    const double t342 = x[4]*x[2]; /* s*omega_tau */
    const double t343 = -t342; /* -s*omega_tau */
    const double t344 = x[4]*x[0]; /* s*gamma3 */
    const double t345 = -t344; /* -s*gamma3 */
    const double t346 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t347 = -t346; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t26;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t29;
    out[9] = t37;
    out[10] = t88;
    out[11] = 0.0;
    out[12] = t94;
    out[13] = t110;
    out[14] = t189;
    out[15] = t262;
    out[16] = t265;
    out[17] = t273;
    out[18] = t286;
    out[19] = t341;
    out[20] = t343;
    out[21] = 0.0;
    out[22] = t345;
    out[23] = 0.0;
    out[24] = t347;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = p[1]*p[1]; /* R*R */
    const double t3 = t2*p[3]; /* R*R*I1 */
    const double t4 = t0*t3; /* s*s*R*R*I1 */
    const double t5 = p[1]*x[0]; /* R*gamma3 */
    const double t6 = p[5] + t5; /* b = a3 + R*gamma3 */
    const double t7 = t6*t6; /* b*b */
    const double t8 = p[4]*t7; /* I3*b*b */
    const double t9 = t4 + t8; /* K = s*s*R*R*I1 + I3*b*b */
    const double t10 = p[1]*p[6]; /* R*G */
    const double t11 = x[4]*t10; /* s*R*G */
    const double t12 = x[3]*p[4]; /* v_tau*I3 */
    const double t13 = t6*t12; /* b*v_tau*I3 */
    const double t14 = t11 + t13; /* s*R*G + b*v_tau*I3 */
    const double t15 = x[3]*t14; /* v_tau*(s*R*G + b*v_tau*I3) */
    const double t16 = t15/t9; /* v_tau*(s*R*G + b*v_tau*I3)/K */
    const double t17 = p[5]*p[5]; /* a3*a3 */
    const double t18 = p[0]*t17; /* m*a3*a3 */
    const double t19 = x[0]*t18; /* gamma3*m*a3*a3 */
    const double t20 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t21 = t19*t20; /* gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t22 = t0*t21; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t23 = t0*t18; /* s*s*m*a3*a3 */
    const double t24 = p[3] + t23; /* D = I1 + s*s*m*a3*a3 */
    const double t25 = t22/t24; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t26 = p[0]*p[2]; /* m*g */
    const double t27 = p[5]*t26; /* a3*m*g */
    const double t28 = t0*t27; /* s*s*a3*m*g */
    const double t29 = t28/t24; /* s*s*a3*m*g/D */
    const double t30 = t25 - t29; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D */
    const double t31 = p[3]*x[0]; /* I1*gamma3 */
    const double t32 = t9*t9; /* K*K */
    const double t33 = t24*t32; /* D*K*K */
    const double t34 = t14*t14; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t35 = t31*t34; /* I1*gamma3*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t36 = t35/t33; /* I1*gamma3*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(D*K*K) */
    const double t37 = t30 - t36; /* s*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - s*s*a3*m*g/D - I1*gamma3*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(D*K*K) */
    const double t38 = x[4]*p[4]; /* s*I3 */
    const double t39 = t14*t38; /* (s*R*G + b*v_tau*I3)*s*I3 */
    const double t40 = p[1]*p[3]; /* R*I1 */
    const double t41 = x[3]*t40; /* v_tau*R*I1 */
    const double t42 = x[4]*t41; /* s*v_tau*R*I1 */
    const double t43 = t6*p[6]; /* b*G */
    const double t44 = t42 - t43; /* s*v_tau*R*I1 - b*G */
    const double t45 = t39*t44; /* (s*R*G + b*v_tau*I3)*s*I3*(s*v_tau*R*I1 - b*G) */
    const double t46 = t45/t33; /* (s*R*G + b*v_tau*I3)*s*I3*(s*v_tau*R*I1 - b*G)/(D*K*K) */
    const double t47 = t37 - t46; /* t37 - (s*R*G + b*v_tau*I3)*s*I3*(s*v_tau*R*I1 - b*G)/(D*K*K) */
    const double t48 = t14*x[1]; /* (s*R*G + b*v_tau*I3)*v_nu */
    const double t49 = t48/t9; /* (s*R*G + b*v_tau*I3)*v_nu/K */
    const double t50 = p[3]*p[4]; /* I1*I3 */
    const double t51 = t9*p[0]; /* K*m */
    const double t52 = t51 + p[7]; /* Theta = K*m + I1*I3 */
    const double t53 = t9*t52; /* K*Theta */
    const double t54 = p[5]*x[0]; /* a3*gamma3 */
    const double t55 = p[1] + t54; /* e = R + a3*gamma3 */
    const double t56 = x[2]*t55; /* omega_tau*e */
    const double t57 = x[1] + t56; /* V = v_nu + omega_tau*e */
    const double t58 = t50*t57; /* I1*I3*V */
    const double t59 = t14*t58; /* (s*R*G + b*v_tau*I3)*I1*I3*V */
    const double t60 = t59/t53; /* (s*R*G + b*v_tau*I3)*I1*I3*V/(K*Theta) */
    const double t61 = t60 - t49; /* (s*R*G + b*v_tau*I3)*I1*I3*V/(K*Theta) - (s*R*G + b*v_tau*I3)*v_nu/K */
    const double t62 = x[2]*p[4]; /* omega_tau*I3 */
    const double t63 = x[4]*t62; /* s*omega_tau*I3 */
    const double t64 = t44*t63; /* (s*v_tau*R*I1 - b*G)*s*omega_tau*I3 */
    const double t65 = t5*p[8]; /* R*gamma3*(I1 - I3) */
    const double t66 = t65 - p[9]; /* R*gamma3*(I1 - I3) - I3*a3 */
    const double t67 = t64*t66; /* (s*v_tau*R*I1 - b*G)*s*omega_tau*I3*(R*gamma3*(I1 - I3) - I3*a3) */
    const double t68 = t67/t53; /* t67/(K*Theta) */
    const double t69 = t61 - t68; /* t61 - t67/(K*Theta) */
    const double t70 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t71 = -t70; /* -omega_tau*gamma3 */
    const double t72 = x[4]*t70; /* s*omega_tau*gamma3 */
    const double t73 = -t72; /* -s*omega_tau*gamma3 */
    const double t74 = x[2]*2.0; /* omega_tau*2 */
    const double t75 = x[4]*t74; /* s*omega_tau*2 */
    const double t76 = p[1]*p[4]; /* R*I3 */
    const double t77 = x[3]*x[3]; /* v_tau*v_tau */
    const double t78 = t76*t77; /* R*I3*v_tau*v_tau */
    const double t79 = t78/t9; /* R*I3*v_tau*v_tau/K */
    const double t80 = x[3]*t76; /* v_tau*R*I3 */
    const double t81 = t6*t80; /* b*v_tau*R*I3 */
    const double t82 = t14*t81; /* (s*R*G + b*v_tau*I3)*b*v_tau*R*I3 */
    const double t83 = t82/t32; /* (s*R*G + b*v_tau*I3)*b*v_tau*R*I3/(K*K) */
    const double t84 = 2.0*t83; /* 2*(s*R*G + b*v_tau*I3)*b*v_tau*R*I3/(K*K) */
    const double t85 = t79 - t84; /* R*I3*v_tau*v_tau/K - 2*(s*R*G + b*v_tau*I3)*b*v_tau*R*I3/(K*K) */
    const double t86 = t14/t9; /* (s*R*G + b*v_tau*I3)/K */
    const double t87 = t13/t9; /* b*v_tau*I3/K */
    const double t88 = t86 + t87; /* (s*R*G + b*v_tau*I3)/K + b*v_tau*I3/K */
    const double t89 = x[3]*t10; /* v_tau*R*G */
    const double t90 = t89/t9; /* v_tau*R*G/K */
    const double t91 = x[3]*t3; /* v_tau*R*R*I1 */
    const double t92 = x[4]*t91; /* s*v_tau*R*R*I1 */
    const double t93 = t14*t92; /* (s*R*G + b*v_tau*I3)*s*v_tau*R*R*I1 */
    const double t94 = t93/t32; /* (s*R*G + b*v_tau*I3)*s*v_tau*R*R*I1/(K*K) */
    const double t95 = 2.0*t94; /* 2*(s*R*G + b*v_tau*I3)*s*v_tau*R*R*I1/(K*K) */
    const double t96 = t90 - t95; /* v_tau*R*G/K - 2*(s*R*G + b*v_tau*I3)*s*v_tau*R*R*I1/(K*K) */
    const double t97 = t18*t20; /* m*a3*a3*omega_tau*omega_tau */
    const double t98 = t0*t97; /* s*s*m*a3*a3*omega_tau*omega_tau */
    const double t99 = t98/t24; /* s*s*m*a3*a3*omega_tau*omega_tau/D */
    const double t100 = p[3]*t34; /* I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3) */
    const double t101 = t100/t33; /* I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(D*K*K) */
    const double t102 = t99 - t101; /* s*s*m*a3*a3*omega_tau*omega_tau/D - I1*(s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)/(D*K*K) */
    const double t103 = p[4]*t40; /* I3*R*I1 */
    const double t104 = x[0]*t103; /* gamma3*I3*R*I1 */
    const double t105 = x[3]*t104; /* v_tau*gamma3*I3*R*I1 */
    const double t106 = t14*t105; /* (s*R*G + b*v_tau*I3)*v_tau*gamma3*I3*R*I1 */
    const double t107 = t106/t33; /* (s*R*G + b*v_tau*I3)*v_tau*gamma3*I3*R*I1/(D*K*K) */
    const double t108 = 2.0*t107; /* 2*(s*R*G + b*v_tau*I3)*v_tau*gamma3*I3*R*I1/(D*K*K) */
    const double t109 = t102 - t108; /* t102 - 2*(s*R*G + b*v_tau*I3)*v_tau*gamma3*I3*R*I1/(D*K*K) */
    const double t110 = t6*t104; /* b*gamma3*I3*R*I1 */
    const double t111 = t9*t32; /* K*K*K */
    const double t112 = t24*t111; /* D*K*K*K */
    const double t113 = t34*t110; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*b*gamma3*I3*R*I1 */
    const double t114 = t113/t112; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*b*gamma3*I3*R*I1/(D*K*K*K) */
    const double t115 = t114*4.0; /* t114*4 */
    const double t116 = t109 + t115; /* t102 - 2*(s*R*G + b*v_tau*I3)*v_tau*gamma3*I3*R*I1/(D*K*K) + t114*4 */
    const double t117 = p[4]*p[4]; /* I3*I3 */
    const double t118 = p[1]*t117; /* R*I3*I3 */
    const double t119 = x[3]*t118; /* v_tau*R*I3*I3 */
    const double t120 = x[4]*t119; /* s*v_tau*R*I3*I3 */
    const double t121 = t44*t120; /* (s*v_tau*R*I1 - b*G)*s*v_tau*R*I3*I3 */
    const double t122 = t121/t33; /* (s*v_tau*R*I1 - b*G)*s*v_tau*R*I3*I3/(D*K*K) */
    const double t123 = t116 - t122; /* t116 - (s*v_tau*R*I1 - b*G)*s*v_tau*R*I3*I3/(D*K*K) */
    const double t124 = x[4]*t118; /* s*R*I3*I3 */
    const double t125 = t6*t124; /* b*s*R*I3*I3 */
    const double t126 = t14*t125; /* (s*R*G + b*v_tau*I3)*b*s*R*I3*I3 */
    const double t127 = t44*t126; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*v_tau*I3)*b*s*R*I3*I3 */
    const double t128 = t127/t112; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*v_tau*I3)*b*s*R*I3*I3/(D*K*K*K) */
    const double t129 = 4.0*t128; /* 4*t128 */
    const double t130 = t123 + t129; /* t116 - (s*v_tau*R*I1 - b*G)*s*v_tau*R*I3*I3/(D*K*K) + 4*t128 */
    const double t131 = p[6]*t76; /* G*R*I3 */
    const double t132 = x[4]*t131; /* s*G*R*I3 */
    const double t133 = t14*t132; /* (s*R*G + b*v_tau*I3)*s*G*R*I3 */
    const double t134 = t133/t33; /* (s*R*G + b*v_tau*I3)*s*G*R*I3/(D*K*K) */
    const double t135 = t130 + t134; /* t116 - (s*v_tau*R*I1 - b*G)*s*v_tau*R*I3*I3/(D*K*K) + 4*t128 + (s*R*G + b*v_tau*I3)*s*G*R*I3/(D*K*K) */
    const double t136 = p[0]*2.0; /* m*2 */
    const double t137 = t17*t136; /* a3*a3*m*2 */
    const double t138 = x[0]*t137; /* gamma3*a3*a3*m*2 */
    const double t139 = x[2]*t138; /* omega_tau*gamma3*a3*a3*m*2 */
    const double t140 = t0*t139; /* s*s*omega_tau*gamma3*a3*a3*m*2 */
    const double t141 = t140/t24; /* s*s*omega_tau*gamma3*a3*a3*m*2/D */
    const double t142 = x[0]*t50; /* gamma3*I1*I3 */
    const double t143 = t6*t142; /* b*gamma3*I1*I3 */
    const double t144 = t14*t143; /* (s*R*G + b*v_tau*I3)*b*gamma3*I1*I3 */
    const double t145 = t144/t33; /* (s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(D*K*K) */
    const double t146 = 2.0*t145; /* 2*(s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(D*K*K) */
    const double t147 = -t146; /* -2*(s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(D*K*K) */
    const double t148 = x[4]*t117; /* s*I3*I3 */
    const double t149 = t6*t148; /* b*s*I3*I3 */
    const double t150 = t44*t149; /* (s*v_tau*R*I1 - b*G)*b*s*I3*I3 */
    const double t151 = t150/t33; /* (s*v_tau*R*I1 - b*G)*b*s*I3*I3/(D*K*K) */
    const double t152 = t147 - t151; /* -2*(s*R*G + b*v_tau*I3)*b*gamma3*I1*I3/(D*K*K) - (s*v_tau*R*I1 - b*G)*b*s*I3*I3/(D*K*K) */
    const double t153 = t0*t103; /* s*s*I3*R*I1 */
    const double t154 = t14*t153; /* (s*R*G + b*v_tau*I3)*s*s*I3*R*I1 */
    const double t155 = t154/t33; /* (s*R*G + b*v_tau*I3)*s*s*I3*R*I1/(D*K*K) */
    const double t156 = t152 - t155; /* t152 - (s*R*G + b*v_tau*I3)*s*s*I3*R*I1/(D*K*K) */
    const double t157 = x[4]*t21; /* s*gamma3*m*a3*a3*omega_tau*omega_tau */
    const double t158 = t157/t24; /* s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t159 = 2.0*t158; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D */
    const double t160 = x[4]*t27; /* s*a3*m*g */
    const double t161 = t160/t24; /* s*a3*m*g/D */
    const double t162 = 2.0*t161; /* 2*s*a3*m*g/D */
    const double t163 = t159 - t162; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D */
    const double t164 = p[4]*t14; /* I3*(s*R*G + b*v_tau*I3) */
    const double t165 = t44*t164; /* (s*v_tau*R*I1 - b*G)*I3*(s*R*G + b*v_tau*I3) */
    const double t166 = t165/t33; /* (s*v_tau*R*I1 - b*G)*I3*(s*R*G + b*v_tau*I3)/(D*K*K) */
    const double t167 = t163 - t166; /* 2*s*gamma3*m*a3*a3*omega_tau*omega_tau/D - 2*s*a3*m*g/D - (s*v_tau*R*I1 - b*G)*I3*(s*R*G + b*v_tau*I3)/(D*K*K) */
    const double t168 = p[0]*p[0]; /* m*m */
    const double t169 = t17*t17; /* a3*a3*a3*a3 */
    const double t170 = t168*t169; /* m*m*a3*a3*a3*a3 */
    const double t171 = x[0]*t170; /* gamma3*m*m*a3*a3*a3*a3 */
    const double t172 = t20*t171; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3 */
    const double t173 = x[4]*t0; /* s*s*s */
    const double t174 = t172*t173; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s */
    const double t175 = t24*t24; /* D*D */
    const double t176 = t174/t175; /* omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t177 = 2.0*t176; /* 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t178 = t167 - t177; /* t167 - 2*omega_tau*omega_tau*gamma3*m*m*a3*a3*a3*a3*s*s*s/(D*D) */
    const double t179 = p[2]*t168; /* g*m*m */
    const double t180 = p[5]*t17; /* a3*a3*a3 */
    const double t181 = t179*t180; /* g*m*m*a3*a3*a3 */
    const double t182 = t173*t181; /* s*s*s*g*m*m*a3*a3*a3 */
    const double t183 = t182/t175; /* s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t184 = 2.0*t183; /* 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t185 = t178 + t184; /* t178 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) */
    const double t186 = p[6]*t40; /* G*R*I1 */
    const double t187 = x[0]*t186; /* gamma3*G*R*I1 */
    const double t188 = t14*t187; /* (s*R*G + b*v_tau*I3)*gamma3*G*R*I1 */
    const double t189 = t188/t33; /* (s*R*G + b*v_tau*I3)*gamma3*G*R*I1/(D*K*K) */
    const double t190 = 2.0*t189; /* 2*(s*R*G + b*v_tau*I3)*gamma3*G*R*I1/(D*K*K) */
    const double t191 = t185 - t190; /* t178 + 2*s*s*s*g*m*m*a3*a3*a3/(D*D) - 2*(s*R*G + b*v_tau*I3)*gamma3*G*R*I1/(D*K*K) */
    const double t192 = p[3]*p[3]; /* I1*I1 */
    const double t193 = t2*t192; /* R*R*I1*I1 */
    const double t194 = x[0]*t193; /* gamma3*R*R*I1*I1 */
    const double t195 = x[4]*t194; /* s*gamma3*R*R*I1*I1 */
    const double t196 = t34*t195; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*s*gamma3*R*R*I1*I1 */
    const double t197 = t196/t112; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*s*gamma3*R*R*I1*I1/(D*K*K*K) */
    const double t198 = 4.0*t197; /* 4*t197 */
    const double t199 = t191 + t198; /* t191 + 4*t197 */
    const double t200 = p[3]*p[0]; /* I1*m */
    const double t201 = t17*t200; /* a3*a3*I1*m */
    const double t202 = x[0]*t201; /* gamma3*a3*a3*I1*m */
    const double t203 = x[4]*t202; /* s*gamma3*a3*a3*I1*m */
    const double t204 = t32*t175; /* K*K*D*D */
    const double t205 = t34*t203; /* (s*R*G + b*v_tau*I3)*(s*R*G + b*v_tau*I3)*s*gamma3*a3*a3*I1*m */
    const double t206 = t205/t204; /* t205/(K*K*D*D) */
    const double t207 = 2.0*t206; /* 2*t205/(K*K*D*D) */
    const double t208 = t199 + t207; /* t191 + 4*t197 + 2*t205/(K*K*D*D) */
    const double t209 = t44*t132; /* (s*v_tau*R*I1 - b*G)*s*G*R*I3 */
    const double t210 = t209/t33; /* (s*v_tau*R*I1 - b*G)*s*G*R*I3/(D*K*K) */
    const double t211 = t208 - t210; /* t191 + 4*t197 + 2*t205/(K*K*D*D) - (s*v_tau*R*I1 - b*G)*s*G*R*I3/(D*K*K) */
    const double t212 = x[3]*t103; /* v_tau*I3*R*I1 */
    const double t213 = x[4]*t212; /* s*v_tau*I3*R*I1 */
    const double t214 = t14*t213; /* (s*R*G + b*v_tau*I3)*s*v_tau*I3*R*I1 */
    const double t215 = t214/t33; /* (s*R*G + b*v_tau*I3)*s*v_tau*I3*R*I1/(D*K*K) */
    const double t216 = t211 - t215; /* t211 - (s*R*G + b*v_tau*I3)*s*v_tau*I3*R*I1/(D*K*K) */
    const double t217 = t3*p[4]; /* R*R*I1*I3 */
    const double t218 = t0*t217; /* s*s*R*R*I1*I3 */
    const double t219 = t14*t218; /* (s*R*G + b*v_tau*I3)*s*s*R*R*I1*I3 */
    const double t220 = t44*t219; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*v_tau*I3)*s*s*R*R*I1*I3 */
    const double t221 = t220/t112; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*v_tau*I3)*s*s*R*R*I1*I3/(D*K*K*K) */
    const double t222 = 4.0*t221; /* 4*t221 */
    const double t223 = t216 + t222; /* t211 - (s*R*G + b*v_tau*I3)*s*v_tau*I3*R*I1/(D*K*K) + 4*t221 */
    const double t224 = p[4]*p[0]; /* I3*m */
    const double t225 = t17*t224; /* a3*a3*I3*m */
    const double t226 = t0*t225; /* s*s*a3*a3*I3*m */
    const double t227 = t14*t226; /* (s*R*G + b*v_tau*I3)*s*s*a3*a3*I3*m */
    const double t228 = t44*t227; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*v_tau*I3)*s*s*a3*a3*I3*m */
    const double t229 = t228/t204; /* (s*v_tau*R*I1 - b*G)*(s*R*G + b*v_tau*I3)*s*s*a3*a3*I3*m/(K*K*D*D) */
    const double t230 = 2.0*t229; /* 2*t229 */
    const double t231 = t223 + t230; /* t211 - (s*R*G + b*v_tau*I3)*s*v_tau*I3*R*I1/(D*K*K) + 4*t221 + 2*t229 */
    const double t232 = x[1]*t76; /* v_nu*R*I3 */
    const double t233 = x[3]*t232; /* v_tau*v_nu*R*I3 */
    const double t234 = t233/t9; /* v_tau*v_nu*R*I3/K */
    const double t235 = t6*t232; /* b*v_nu*R*I3 */
    const double t236 = t14*t235; /* (s*R*G + b*v_tau*I3)*b*v_nu*R*I3 */
    const double t237 = t236/t32; /* (s*R*G + b*v_tau*I3)*b*v_nu*R*I3/(K*K) */
    const double t238 = 2.0*t237; /* 2*(s*R*G + b*v_tau*I3)*b*v_nu*R*I3/(K*K) */
    const double t239 = t238 - t234; /* 2*(s*R*G + b*v_tau*I3)*b*v_nu*R*I3/(K*K) - v_tau*v_nu*R*I3/K */
    const double t240 = p[5]*t50; /* a3*I1*I3 */
    const double t241 = x[2]*t240; /* omega_tau*a3*I1*I3 */
    const double t242 = t14*t241; /* (s*R*G + b*v_tau*I3)*omega_tau*a3*I1*I3 */
    const double t243 = t242/t53; /* (s*R*G + b*v_tau*I3)*omega_tau*a3*I1*I3/(K*Theta) */
    const double t244 = t239 + t243; /* 2*(s*R*G + b*v_tau*I3)*b*v_nu*R*I3/(K*K) - v_tau*v_nu*R*I3/K + (s*R*G + b*v_tau*I3)*omega_tau*a3*I1*I3/(K*Theta) */
    const double t245 = t40*t117; /* R*I1*I3*I3 */
    const double t246 = x[3]*t245; /* v_tau*R*I1*I3*I3 */
    const double t247 = t57*t246; /* V*v_tau*R*I1*I3*I3 */
    const double t248 = t247/t53; /* V*v_tau*R*I1*I3*I3/(K*Theta) */
    const double t249 = t244 + t248; /* t244 + V*v_tau*R*I1*I3*I3/(K*Theta) */
    const double t250 = t6*t245; /* b*R*I1*I3*I3 */
    const double t251 = t32*t52; /* K*K*Theta */
    const double t252 = t57*t250; /* V*b*R*I1*I3*I3 */
    const double t253 = t14*t252; /* (s*R*G + b*v_tau*I3)*V*b*R*I1*I3*I3 */
    const double t254 = t253/t251; /* (s*R*G + b*v_tau*I3)*V*b*R*I1*I3*I3/(K*K*Theta) */
    const double t255 = 2.0*t254; /* 2*(s*R*G + b*v_tau*I3)*V*b*R*I1*I3*I3/(K*K*Theta) */
    const double t256 = t249 - t255; /* t244 + V*v_tau*R*I1*I3*I3/(K*Theta) - 2*(s*R*G + b*v_tau*I3)*V*b*R*I1*I3*I3/(K*K*Theta) */
    const double t257 = p[1]*p[0]; /* R*m */
    const double t258 = p[3]*t257; /* I1*R*m */
    const double t259 = t117*t258; /* I3*I3*I1*R*m */
    const double t260 = t6*t259; /* b*I3*I3*I1*R*m */
    const double t261 = t52*t52; /* Theta*Theta */
    const double t262 = t9*t261; /* K*Theta*Theta */
    const double t263 = t57*t260; /* V*b*I3*I3*I1*R*m */
    const double t264 = t14*t263; /* (s*R*G + b*v_tau*I3)*V*b*I3*I3*I1*R*m */
    const double t265 = t264/t262; /* (s*R*G + b*v_tau*I3)*V*b*I3*I3*I1*R*m/(K*Theta*Theta) */
    const double t266 = 2.0*t265; /* 2*(s*R*G + b*v_tau*I3)*V*b*I3*I3*I1*R*m/(K*Theta*Theta) */
    const double t267 = t256 - t266; /* t256 - 2*(s*R*G + b*v_tau*I3)*V*b*I3*I3*I1*R*m/(K*Theta*Theta) */
    const double t268 = x[2]*t76; /* omega_tau*R*I3 */
    const double t269 = x[4]*t268; /* s*omega_tau*R*I3 */
    const double t270 = t44*t269; /* (s*v_tau*R*I1 - b*G)*s*omega_tau*R*I3 */
    const double t271 = p[8]*t270; /* (I1 - I3)*(s*v_tau*R*I1 - b*G)*s*omega_tau*R*I3 */
    const double t272 = t271/t53; /* (I1 - I3)*(s*v_tau*R*I1 - b*G)*s*omega_tau*R*I3/(K*Theta) */
    const double t273 = t267 - t272; /* t267 - (I1 - I3)*(s*v_tau*R*I1 - b*G)*s*omega_tau*R*I3/(K*Theta) */
    const double t274 = x[2]*t118; /* omega_tau*R*I3*I3 */
    const double t275 = x[4]*t274; /* s*omega_tau*R*I3*I3 */
    const double t276 = t6*t275; /* b*s*omega_tau*R*I3*I3 */
    const double t277 = t44*t276; /* (s*v_tau*R*I1 - b*G)*b*s*omega_tau*R*I3*I3 */
    const double t278 = t66*t277; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*b*s*omega_tau*R*I3*I3 */
    const double t279 = t278/t251; /* t278/(K*K*Theta) */
    const double t280 = 2.0*t279; /* 2*t278/(K*K*Theta) */
    const double t281 = t273 + t280; /* t273 + 2*t278/(K*K*Theta) */
    const double t282 = t117*t257; /* I3*I3*R*m */
    const double t283 = x[2]*t282; /* omega_tau*I3*I3*R*m */
    const double t284 = x[4]*t283; /* s*omega_tau*I3*I3*R*m */
    const double t285 = t6*t284; /* b*s*omega_tau*I3*I3*R*m */
    const double t286 = t44*t285; /* (s*v_tau*R*I1 - b*G)*b*s*omega_tau*I3*I3*R*m */
    const double t287 = t66*t286; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*b*s*omega_tau*I3*I3*R*m */
    const double t288 = t287/t262; /* t287/(K*Theta*Theta) */
    const double t289 = 2.0*t288; /* 2*t287/(K*Theta*Theta) */
    const double t290 = t281 + t289; /* t273 + 2*t278/(K*K*Theta) + 2*t287/(K*Theta*Theta) */
    const double t291 = x[2]*t131; /* omega_tau*G*R*I3 */
    const double t292 = x[4]*t291; /* s*omega_tau*G*R*I3 */
    const double t293 = t66*t292; /* (R*gamma3*(I1 - I3) - I3*a3)*s*omega_tau*G*R*I3 */
    const double t294 = t293/t53; /* (R*gamma3*(I1 - I3) - I3*a3)*s*omega_tau*G*R*I3/(K*Theta) */
    const double t295 = t290 + t294; /* t273 + 2*t278/(K*K*Theta) + 2*t287/(K*Theta*Theta) + (R*gamma3*(I1 - I3) - I3*a3)*s*omega_tau*G*R*I3/(K*Theta) */
    const double t296 = t14*t50; /* (s*R*G + b*v_tau*I3)*I1*I3 */
    const double t297 = t296/t53; /* (s*R*G + b*v_tau*I3)*I1*I3/(K*Theta) */
    const double t298 = t297 - t86; /* (s*R*G + b*v_tau*I3)*I1*I3/(K*Theta) - (s*R*G + b*v_tau*I3)/K */
    const double t299 = t50*t55; /* I1*I3*e */
    const double t300 = t14*t299; /* (s*R*G + b*v_tau*I3)*I1*I3*e */
    const double t301 = t300/t53; /* (s*R*G + b*v_tau*I3)*I1*I3*e/(K*Theta) */
    const double t302 = t38*t44; /* s*I3*(s*v_tau*R*I1 - b*G) */
    const double t303 = t66*t302; /* (R*gamma3*(I1 - I3) - I3*a3)*s*I3*(s*v_tau*R*I1 - b*G) */
    const double t304 = t303/t53; /* (R*gamma3*(I1 - I3) - I3*a3)*s*I3*(s*v_tau*R*I1 - b*G)/(K*Theta) */
    const double t305 = t301 - t304; /* (s*R*G + b*v_tau*I3)*I1*I3*e/(K*Theta) - t304 */
    const double t306 = p[4]*x[1]; /* I3*v_nu */
    const double t307 = t6*t306; /* b*I3*v_nu */
    const double t308 = t307/t9; /* b*I3*v_nu/K */
    const double t309 = p[3]*t117; /* I1*I3*I3 */
    const double t310 = t6*t309; /* b*I1*I3*I3 */
    const double t311 = t57*t310; /* V*b*I1*I3*I3 */
    const double t312 = t311/t53; /* V*b*I1*I3*I3/(K*Theta) */
    const double t313 = t312 - t308; /* V*b*I1*I3*I3/(K*Theta) - b*I3*v_nu/K */
    const double t314 = x[2]*t103; /* omega_tau*I3*R*I1 */
    const double t315 = t0*t314; /* s*s*omega_tau*I3*R*I1 */
    const double t316 = t66*t315; /* (R*gamma3*(I1 - I3) - I3*a3)*s*s*omega_tau*I3*R*I1 */
    const double t317 = t316/t53; /* (R*gamma3*(I1 - I3) - I3*a3)*s*s*omega_tau*I3*R*I1/(K*Theta) */
    const double t318 = t313 - t317; /* V*b*I1*I3*I3/(K*Theta) - b*I3*v_nu/K - (R*gamma3*(I1 - I3) - I3*a3)*s*s*omega_tau*I3*R*I1/(K*Theta) */
    const double t319 = t44*t62; /* (s*v_tau*R*I1 - b*G)*omega_tau*I3 */
    const double t320 = t66*t319; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*omega_tau*I3 */
    const double t321 = t320/t53; /* t320/(K*Theta) */
    const double t322 = -t321; /* -t320/(K*Theta) */
    const double t323 = t10*x[1]; /* R*G*v_nu */
    const double t324 = t323/t9; /* R*G*v_nu/K */
    const double t325 = t322 - t324; /* -t320/(K*Theta) - R*G*v_nu/K */
    const double t326 = t3*x[1]; /* R*R*I1*v_nu */
    const double t327 = x[4]*t326; /* s*R*R*I1*v_nu */
    const double t328 = t14*t327; /* (s*R*G + b*v_tau*I3)*s*R*R*I1*v_nu */
    const double t329 = t328/t32; /* (s*R*G + b*v_tau*I3)*s*R*R*I1*v_nu/(K*K) */
    const double t330 = 2.0*t329; /* 2*(s*R*G + b*v_tau*I3)*s*R*R*I1*v_nu/(K*K) */
    const double t331 = t325 + t330; /* -t320/(K*Theta) - R*G*v_nu/K + 2*(s*R*G + b*v_tau*I3)*s*R*R*I1*v_nu/(K*K) */
    const double t332 = p[6]*t103; /* G*I3*R*I1 */
    const double t333 = t57*t332; /* V*G*I3*R*I1 */
    const double t334 = t333/t53; /* V*G*I3*R*I1/(K*Theta) */
    const double t335 = t331 + t334; /* t331 + V*G*I3*R*I1/(K*Theta) */
    const double t336 = p[4]*t193; /* I3*R*R*I1*I1 */
    const double t337 = x[4]*t336; /* s*I3*R*R*I1*I1 */
    const double t338 = t57*t337; /* V*s*I3*R*R*I1*I1 */
    const double t339 = t14*t338; /* (s*R*G + b*v_tau*I3)*V*s*I3*R*R*I1*I1 */
    const double t340 = t339/t251; /* (s*R*G + b*v_tau*I3)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t341 = 2.0*t340; /* 2*(s*R*G + b*v_tau*I3)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t342 = t335 - t341; /* t331 + V*G*I3*R*I1/(K*Theta) - 2*(s*R*G + b*v_tau*I3)*V*s*I3*R*R*I1*I1/(K*K*Theta) */
    const double t343 = t2*p[0]; /* R*R*m */
    const double t344 = t192*t343; /* I1*I1*R*R*m */
    const double t345 = p[4]*t344; /* I3*I1*I1*R*R*m */
    const double t346 = x[4]*t345; /* s*I3*I1*I1*R*R*m */
    const double t347 = t57*t346; /* V*s*I3*I1*I1*R*R*m */
    const double t348 = t14*t347; /* (s*R*G + b*v_tau*I3)*V*s*I3*I1*I1*R*R*m */
    const double t349 = t348/t262; /* (s*R*G + b*v_tau*I3)*V*s*I3*I1*I1*R*R*m/(K*Theta*Theta) */
    const double t350 = 2.0*t349; /* 2*(s*R*G + b*v_tau*I3)*V*s*I3*I1*I1*R*R*m/(K*Theta*Theta) */
    const double t351 = t342 - t350; /* t342 - 2*(s*R*G + b*v_tau*I3)*V*s*I3*I1*I1*R*R*m/(K*Theta*Theta) */
    const double t352 = x[3]*t314; /* v_tau*omega_tau*I3*R*I1 */
    const double t353 = x[4]*t352; /* s*v_tau*omega_tau*I3*R*I1 */
    const double t354 = t66*t353; /* (R*gamma3*(I1 - I3) - I3*a3)*s*v_tau*omega_tau*I3*R*I1 */
    const double t355 = t354/t53; /* (R*gamma3*(I1 - I3) - I3*a3)*s*v_tau*omega_tau*I3*R*I1/(K*Theta) */
    const double t356 = t351 - t355; /* t351 - t355 */
    const double t357 = x[2]*t217; /* omega_tau*R*R*I1*I3 */
    const double t358 = t0*t357; /* s*s*omega_tau*R*R*I1*I3 */
    const double t359 = t44*t358; /* (s*v_tau*R*I1 - b*G)*s*s*omega_tau*R*R*I1*I3 */
    const double t360 = t66*t359; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*s*s*omega_tau*R*R*I1*I3 */
    const double t361 = t360/t251; /* t360/(K*K*Theta) */
    const double t362 = 2.0*t361; /* 2*t360/(K*K*Theta) */
    const double t363 = t356 + t362; /* t351 - t355 + 2*t360/(K*K*Theta) */
    const double t364 = p[3]*t343; /* I1*R*R*m */
    const double t365 = p[4]*t364; /* I3*I1*R*R*m */
    const double t366 = x[2]*t365; /* omega_tau*I3*I1*R*R*m */
    const double t367 = t0*t366; /* s*s*omega_tau*I3*I1*R*R*m */
    const double t368 = t44*t367; /* (s*v_tau*R*I1 - b*G)*s*s*omega_tau*I3*I1*R*R*m */
    const double t369 = t66*t368; /* (R*gamma3*(I1 - I3) - I3*a3)*(s*v_tau*R*I1 - b*G)*s*s*omega_tau*I3*I1*R*R*m */
    const double t370 = t369/t262; /* t369/(K*Theta*Theta) */
    const double t371 = 2.0*t370; /* 2*t369/(K*Theta*Theta) */
    const double t372 = t363 + t371; /* t351 - t355 + 2*t360/(K*K*Theta) + 2*t369/(K*Theta*Theta) */
    const double t373 = x[2]*x[4]; /* omega_tau*s */
    const double t374 = -t373; /* -omega_tau*s */
    const double t375 = x[4]*x[0]; /* s*gamma3 */
    const double t376 = -t375; /* -s*gamma3 */
    out[0] = t1;
    out[1] = t16;
    out[2] = t47;
    out[3] = t69;
    out[4] = t73;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t0;
    out[8] = 0.0;
    out[9] = t75;
    out[10] = t85;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t88;
    out[14] = t96;
    out[15] = t135;
    out[16] = 0.0;
    out[17] = t141;
    out[18] = t156;
    out[19] = t231;
    out[20] = t295;
    out[21] = t298;
    out[22] = t305;
    out[23] = t318;
    out[24] = t372;
    out[25] = t374;
    out[26] = 0.0;
    out[27] = t376;
    out[28] = 0.0;
    out[29] = t71;
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
    const double t10 = p[4]*x[1]; /* I3*v_nu */
    const double t11 = x[0]*p[1]; /* gamma3*R */
    const double t12 = p[5] + t11; /* b = a3 + gamma3*R */
    const double t13 = t10*t12; /* I3*v_nu*b */
    const double t14 = p[1]*p[1]; /* R*R */
    const double t15 = p[3]*t14; /* I1*R*R */
    const double t16 = t4*t15; /* s*s*I1*R*R */
    const double t17 = t12*t12; /* b*b */
    const double t18 = p[4]*t17; /* I3*b*b */
    const double t19 = t16 + t18; /* K = s*s*I1*R*R + I3*b*b */
    const double t20 = t13/t19; /* I3*v_nu*b/K */
    const double t21 = t9 - t20; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 - I3*v_nu*b/K */
    const double t22 = p[4]*p[4]; /* I3*I3 */
    const double t23 = p[3]*t22; /* I1*I3*I3 */
    const double t24 = t12*t23; /* b*I1*I3*I3 */
    const double t25 = p[0]*t19; /* m*K */
    const double t26 = t25 + p[7]; /* Theta = m*K + I1*I3 */
    const double t27 = t19*t26; /* K*Theta */
    const double t28 = p[5]*x[0]; /* a3*gamma3 */
    const double t29 = p[1] + t28; /* e = R + a3*gamma3 */
    const double t30 = x[2]*t29; /* omega_tau*e */
    const double t31 = x[1] + t30; /* V = v_nu + omega_tau*e */
    const double t32 = t24*t31; /* b*I1*I3*I3*V */
    const double t33 = t32/t27; /* b*I1*I3*I3*V/(K*Theta) */
    const double t34 = t21 + t33; /* m*a3*a3*gamma3*omega_tau*s*s/D*2 - I3*v_nu*b/K + b*I1*I3*I3*V/(K*Theta) */
    const double t35 = p[3]*p[1]; /* I1*R */
    const double t36 = p[4]*t35; /* I3*I1*R */
    const double t37 = x[2]*t36; /* omega_tau*I3*I1*R */
    const double t38 = t4*t37; /* s*s*omega_tau*I3*I1*R */
    const double t39 = t11*p[8]; /* gamma3*R*(I1 - I3) */
    const double t40 = t39 - p[9]; /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t41 = t38*t40; /* s*s*omega_tau*I3*I1*R*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t42 = t41/t27; /* s*s*omega_tau*I3*I1*R*(gamma3*R*(I1 - I3) - I3*a3)/(K*Theta) */
    const double t43 = t34 - t42; /* t34 - s*s*omega_tau*I3*I1*R*(gamma3*R*(I1 - I3) - I3*a3)/(K*Theta) */
    const double t44 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t45 = t43 - t44; /* t43 - gamma3*omega_tau */
    out[0] = t45;
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
    const double t17 = p[1]*p[1]; /* R*R */
    const double t18 = p[3]*t17; /* I1*R*R */
    const double t19 = t10*t18; /* s*s*I1*R*R */
    const double t20 = x[0]*p[1]; /* gamma3*R */
    const double t21 = p[5] + t20; /* b = a3 + gamma3*R */
    const double t22 = t21*t21; /* b*b */
    const double t23 = p[4]*t22; /* I3*b*b */
    const double t24 = t19 + t23; /* K = s*s*I1*R*R + I3*b*b */
    const double t25 = p[0]*t24; /* m*K */
    const double t26 = t25 + p[7]; /* Theta = m*K + I1*I3 */
    const double t27 = t16*t26; /* v_tau*v_tau*Theta */
    const double t28 = t27/t24; /* v_tau*v_tau*Theta/K */
    const double t29 = (1.0 / 2.0)*t28; /* 1/2*v_tau*v_tau*Theta/K */
    const double t30 = t15 + t29; /* m*g*a3*gamma3 + m*v_nu*v_nu*1/2 + 1/2*omega_tau*omega_tau*D + 1/2*v_tau*v_tau*Theta/K */
    const double t31 = p[6]*p[6]; /* G*G */
    const double t32 = t31/t24; /* G*G/K */
    const double t33 = (1.0 / 2.0)*t32; /* 1/2*G*G/K */
    const double t34 = t30 + t33; /* t30 + 1/2*G*G/K */
    out[0] = t34;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*p[4]; /* R*I3 */
    const double t1 = x[3]*x[3]; /* v_tau*v_tau */
    const double t2 = t0*t1; /* R*I3*v_tau*v_tau */
    const double t3 = p[1]*x[0]; /* R*gamma3 */
    const double t4 = p[5] + t3; /* b = a3 + R*gamma3 */
    const double t5 = t2*t4; /* R*I3*v_tau*v_tau*b */
    const double t6 = p[1]*p[1]; /* R*R */
    const double t7 = t6*p[3]; /* R*R*I1 */
    const double t8 = x[4]*x[4]; /* s*s */
    const double t9 = t7*t8; /* R*R*I1*s*s */
    const double t10 = t4*t4; /* b*b */
    const double t11 = p[4]*t10; /* I3*b*b */
    const double t12 = t9 + t11; /* K = R*R*I1*s*s + I3*b*b */
    const double t13 = t12*t12; /* K*K */
    const double t14 = t12*p[0]; /* K*m */
    const double t15 = t14 + p[7]; /* Theta = K*m + I1*I3 */
    const double t16 = t5*t15; /* R*I3*v_tau*v_tau*b*Theta */
    const double t17 = t16/t13; /* R*I3*v_tau*v_tau*b*Theta/(K*K) */
    const double t18 = p[10] - t17; /* m*g*a3 - R*I3*v_tau*v_tau*b*Theta/(K*K) */
    const double t19 = p[1]*p[0]; /* R*m */
    const double t20 = p[4]*t19; /* I3*R*m */
    const double t21 = t1*t20; /* v_tau*v_tau*I3*R*m */
    const double t22 = t4*t21; /* b*v_tau*v_tau*I3*R*m */
    const double t23 = t22/t12; /* b*v_tau*v_tau*I3*R*m/K */
    const double t24 = t18 + t23; /* m*g*a3 - R*I3*v_tau*v_tau*b*Theta/(K*K) + b*v_tau*v_tau*I3*R*m/K */
    const double t25 = p[6]*p[6]; /* G*G */
    const double t26 = t0*t25; /* R*I3*G*G */
    const double t27 = t4*t26; /* b*R*I3*G*G */
    const double t28 = t27/t13; /* b*R*I3*G*G/(K*K) */
    const double t29 = t24 - t28; /* t24 - b*R*I3*G*G/(K*K) */
    const double t30 = p[0]*x[1]; /* m*v_nu */
    const double t31 = p[5]*p[5]; /* a3*a3 */
    const double t32 = p[0]*t31; /* m*a3*a3 */
    const double t33 = t8*t32; /* s*s*m*a3*a3 */
    const double t34 = p[3] + t33; /* D = I1 + s*s*m*a3*a3 */
    const double t35 = x[2]*t34; /* omega_tau*D */
    const double t36 = x[3]*t15; /* v_tau*Theta */
    const double t37 = t36/t12; /* v_tau*Theta/K */
    const double t38 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t39 = t32*t38; /* m*a3*a3*omega_tau*omega_tau */
    const double t40 = x[4]*t39; /* s*m*a3*a3*omega_tau*omega_tau */
    const double t41 = t1*t7; /* v_tau*v_tau*R*R*I1 */
    const double t42 = x[4]*t41; /* s*v_tau*v_tau*R*R*I1 */
    const double t43 = t15*t42; /* Theta*s*v_tau*v_tau*R*R*I1 */
    const double t44 = t43/t13; /* Theta*s*v_tau*v_tau*R*R*I1/(K*K) */
    const double t45 = t40 - t44; /* s*m*a3*a3*omega_tau*omega_tau - Theta*s*v_tau*v_tau*R*R*I1/(K*K) */
    const double t46 = t6*p[0]; /* R*R*m */
    const double t47 = p[3]*t46; /* I1*R*R*m */
    const double t48 = t1*t47; /* v_tau*v_tau*I1*R*R*m */
    const double t49 = x[4]*t48; /* s*v_tau*v_tau*I1*R*R*m */
    const double t50 = t49/t12; /* s*v_tau*v_tau*I1*R*R*m/K */
    const double t51 = t45 + t50; /* t45 + s*v_tau*v_tau*I1*R*R*m/K */
    const double t52 = t7*t25; /* R*R*I1*G*G */
    const double t53 = x[4]*t52; /* s*R*R*I1*G*G */
    const double t54 = t53/t13; /* s*R*R*I1*G*G/(K*K) */
    const double t55 = t51 - t54; /* t45 + s*v_tau*v_tau*I1*R*R*m/K - s*R*R*I1*G*G/(K*K) */
    out[0] = t29;
    out[1] = t30;
    out[2] = t35;
    out[3] = t37;
    out[4] = t55;
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
    const double v_I3 = params[4];
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
};

const jlt_descriptor jlt_kernels_spherical_top_level_general_in_regular = {
    .model = "spherical_top_level",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "10a4c2de6469ad072fa1ca7ab501e8e1bb7a8aedea3e7ae81b5ab2fa6f887a1f",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 11,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 15, 50, 0, 8, 0, 0, 11, 9 }, { 21, 82, 0, 8, 0, 0, 11, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .jacobian = { jacobian, 25, { 57, 237, 0, 54, 0, 0, 18, 29 }, { 114, 577, 0, 55, 0, 0, 18, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 63, 252, 0, 62, 0, 0, 18, 36 }, { 129, 644, 0, 63, 0, 0, 18, 12 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .divergence = { divergence, 1, { 11, 31, 0, 4, 0, 0, 12, 8 }, { 12, 40, 0, 4, 0, 0, 12, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .integral_values = { integral_values, 1, { 8, 25, 0, 2, 0, 0, 12, 5 }, { 8, 27, 0, 2, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are" },
    .integral_gradients = { integral_gradients, 5, { 10, 39, 0, 7, 0, 0, 12, 12 }, { 10, 58, 0, 7, 0, 0, 12, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_general_in_regular_baseline,
        &jlt_batch_spherical_top_level_general_in_regular_avx2,
        &jlt_batch_spherical_top_level_general_in_regular_avx512,
    },
};
