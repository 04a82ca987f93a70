/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 a0362d7aafe4ac095061c9e2c7f9417b05b6c21c51ed0a0e3c3f227f5c7cacca
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   27   13    1    0    0     13    9   (111)
 *  jacobian            7   72   37    1    0    0     15   27   (746)
 *  rhs_jacobian        13   77   38    1    0    0     17   30   (836)
 *  divergence          2   16    9    1    0    0     11    8   (56)
 *  integral_values     2    6    6    1    0    0      8    5   (37)
 *  integral_gradients  1   13    6    1    0    0      7    6   (75)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  observe_values      0   19   10    1    0    0     11    9   (63)
 *  valid_values        0   19   10    1    0    0     11    9   (63)
 *
 *  Accuracy
 *    divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    digits are lost where terms nearly cancel in b/R = a3/R + gamma3, e = gamma3*a3 + R, b/R*v_tau*(R*I3) + s*(R*G),
 *      V = omega_tau*e + v_nu, gamma3*(R*(I1 - I3)) - (I3*a3), v_nu - 1/(Theta/m)*(I1*I3/m)*V,
 *      a part of d(d(v_tau)/dtau)/d(gamma3), s*v_tau - (G/I1)*b/R, s*v_tau + s*v_tau - (G/I1)*b/R,
 *      d(d(v_nu)/dtau)/d(v_tau),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s),
 *      d(omega_tau)/dtau, 1/K*v_tau*(R*I3) - b/R*1/K*(2*R^2*I3)*1/K*(b/R*v_tau*(R*I3) + s*(R*G)),
 *      d(d(v_tau)/dtau)/d(v_nu), d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(gamma3),
 *      d(d(v_tau)/dtau)/d(omega_tau), a part of d(v_tau)/dtau, a part of d(d(v_tau)/dtau)/d(v_tau),
 *      (R*G)*1/K - (2*R^2*I1)*1/K*(b/R*v_tau*(R*I3) + s*(R*G))*s*1/K, d(d(omega_tau)/dtau)/d(gamma3),
 *      a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(s)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_claim jlt_claims_spherical_top_level[];
extern const jlt_descriptor *const jlt_family_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_general_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_level_general_in_regular;
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
    const double t0 = params[1]*params[6]; /* R*G */
    out[7] = t0;
    const double t1 = params[5]*params[5]; /* a3*a3 */
    const double t2 = params[0]*t1; /* m*a3*a3 */
    out[26] = t2;
    const double t3 = t2/params[3]; /* m*a3*a3/I1 */
    out[8] = t3;
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[3]*t4; /* I1*R*R */
    out[9] = t5;
    const double t6 = params[3]*params[4]; /* I1*I3 */
    out[51] = t6;
    const double t7 = t6/params[0]; /* I1*I3/m */
    out[10] = t7;
    const double t8 = params[1]*params[4]; /* R*I3 */
    out[11] = t8;
    const double t9 = params[1]*params[3]; /* R*I1 */
    const double t10 = params[6]/t9; /* G/(R*I1) */
    out[12] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    out[52] = t11;
    const double t12 = params[5]*t11; /* a3*m*g */
    out[29] = t12;
    const double t13 = t12/params[3]; /* a3*m*g/I1 */
    out[13] = t13;
    const double t14 = params[3] - params[4]; /* I1 - I3 */
    const double t15 = params[1]*t14; /* R*(I1 - I3) */
    out[14] = t15;
    const double t16 = params[5]*params[4]; /* a3*I3 */
    out[15] = t16;
    const double t17 = t4*params[4]; /* R*R*I3 */
    out[16] = t17;
    const double t18 = params[5]/params[1]; /* a3/R */
    out[17] = t18;
    const double t19 = t4*2.0; /* R*R*2 */
    const double t20 = params[4]*t19; /* I3*R*R*2 */
    out[18] = t20;
    const double t21 = params[3]*t19; /* I1*R*R*2 */
    out[19] = t21;
    const double t22 = t4*4.0; /* R*R*4 */
    const double t23 = params[4]*t22; /* I3*R*R*4 */
    out[20] = t23;
    const double t24 = params[6]/params[3]; /* G/I1 */
    out[21] = t24;
    const double t25 = t8/2.0; /* R*I3/2 */
    out[22] = t25;
    const double t26 = params[6]*t8; /* G*R*I3 */
    const double t27 = t26/params[3]; /* G*R*I3/I1 */
    out[23] = t27;
    const double t28 = params[0]*2.0; /* m*2 */
    const double t29 = t1*t28; /* a3*a3*m*2 */
    out[42] = t29;
    const double t30 = t29/params[3]; /* a3*a3*m*2/I1 */
    out[24] = t30;
    const double t31 = -t8; /* -R*I3 */
    out[25] = t31;
    const double t32 = 2.0/params[3]; /* 2/I1 */
    out[27] = t32;
    const double t33 = params[3]*params[3]; /* I1*I1 */
    const double t34 = t29/t33; /* a3*a3*m*2/(I1*I1) */
    out[28] = t34;
    const double t35 = params[3]*t22; /* I1*R*R*4 */
    out[30] = t35;
    const double t36 = params[5]*t6; /* a3*I1*I3 */
    const double t37 = t36/params[0]; /* a3*I1*I3/m */
    out[31] = t37;
    const double t38 = params[4]*params[4]; /* I3*I3 */
    const double t39 = t21*t38; /* I1*R*R*2*I3*I3 */
    const double t40 = t39/params[0]; /* I1*R*R*2*I3*I3/m */
    out[32] = t40;
    const double t41 = t5*params[4]; /* I1*R*R*I3 */
    const double t42 = t14*t41; /* (I1 - I3)*I1*R*R*I3 */
    const double t43 = t42/params[0]; /* (I1 - I3)*I1*R*R*I3/m */
    out[33] = t43;
    const double t44 = t26/params[0]; /* G*R*I3/m */
    out[34] = t44;
    const double t45 = params[4]*t9; /* I3*R*I1 */
    const double t46 = t45/params[0]; /* I3*R*I1/m */
    out[35] = t46;
    const double t47 = -t46; /* -I3*R*I1/m */
    out[36] = t47;
    const double t48 = t19*t33; /* R*R*2*I1*I1 */
    const double t49 = params[4]*t48; /* I3*R*R*2*I1*I1 */
    const double t50 = t49/params[0]; /* I3*R*R*2*I1*I1/m */
    out[37] = t50;
    const double t51 = params[1]*t4; /* R*R*R */
    const double t52 = 4.0*t51; /* 4*R*R*R */
    const double t53 = t38*t52; /* I3*I3*4*R*R*R */
    out[38] = t53;
    const double t54 = params[0]*params[0]; /* m*m */
    const double t55 = 2.0*t54; /* 2*m*m */
    const double t56 = t1*t1; /* a3*a3*a3*a3 */
    const double t57 = t55*t56; /* 2*m*m*a3*a3*a3*a3 */
    const double t58 = t57/t33; /* 2*m*m*a3*a3*a3*a3/(I1*I1) */
    out[39] = t58;
    const double t59 = params[2]*t28; /* g*m*2 */
    const double t60 = params[5]*t59; /* a3*g*m*2 */
    const double t61 = t60/params[3]; /* a3*g*m*2/I1 */
    out[40] = t61;
    const double t62 = params[2]*t55; /* g*2*m*m */
    const double t63 = params[5]*t1; /* a3*a3*a3 */
    const double t64 = t62*t63; /* g*2*m*m*a3*a3*a3 */
    const double t65 = t64/t33; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    out[41] = t65;
    const double t66 = params[4]/params[3]; /* I3/I1 */
    out[43] = t66;
    const double t67 = params[0]*t4; /* m*R*R */
    const double t68 = params[4]/t67; /* I3/(m*R*R) */
    out[44] = t68;
    const double t69 = params[0]*t51; /* m*R*R*R */
    const double t70 = params[3]*t69; /* I1*m*R*R*R */
    const double t71 = params[4]/t70; /* I3/(I1*m*R*R*R) */
    out[45] = t71;
    const double t72 = params[4]/t9; /* I3/(R*I1) */
    out[46] = t72;
    const double t73 = t38/t70; /* I3*I3/(I1*m*R*R*R) */
    out[47] = t73;
    const double t74 = params[0]/2.0; /* m/2 */
    out[48] = t74;
    const double t75 = params[3]*t67; /* I1*m*R*R */
    const double t76 = params[6]*params[6]; /* G*G */
    out[50] = t76;
    const double t77 = t76/t75; /* G*G/(I1*m*R*R) */
    out[49] = t77;
    const double t78 = params[0]*params[5]; /* m*a3 */
    out[53] = t78;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[5]); /* b = R*gamma3 + a3 */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[4]*t0; /* I3*b */
    const double t3 = p[9]*t1; /* R^2*I1*s*s */
    const double t4 = JLT_FMA(t0, t2, t3); /* K = b*I3*b + R^2*I1*s*s */
    const double t5 = JLT_FMA(p[8], t1, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t6 = p[10] + t4; /* Theta/m = I1*I3/m + K */
    const double t7 = t4*t5; /* K*D/I1 */
    const double t8 = t6*t7; /* Theta/m*K*D/I1 */
    const double t9 = 1.0/t8; /* 1/(Theta/m*K*D/I1) */
    const double t10 = t6*t9; /* 1/(K*(D/I1)) = Theta/m*1/(Theta/m*K*D/I1) */
    const double t11 = t5*t10; /* 1/K = D/I1*1/(K*(D/I1)) */
    const double t12 = t4*t10; /* K*1/(K*(D/I1)) */
    const double t13 = p[10]*t7; /* I1*I3/m*K*D/I1 */
    const double t14 = t9*t13; /* 1/(Theta/m*K*D/I1)*I1*I3/m*K*D/I1 */
    const double t15 = x[4]*x[3]; /* s*v_tau */
    const double t16 = JLT_FNMA(p[12], t0, t15); /* s*v_tau - G/(R*I1)*b */
    const double t17 = t11*t16; /* 1/K*(s*v_tau - G/(R*I1)*b) */
    const double t18 = x[4]*x[2]; /* s*omega_tau */
    const double t19 = x[4]*t18; /* s*s*omega_tau */
    out[0] = t19;
    const double t20 = x[4]*p[7]; /* s*R*G */
    const double t21 = JLT_FMA(x[3], t2, t20); /* v_tau*I3*b + s*R*G */
    const double t22 = t11*t21; /* 1/K*(v_tau*I3*b + s*R*G) */
    const double t23 = x[3]*t22; /* v_tau*1/K*(v_tau*I3*b + s*R*G) */
    out[1] = t23;
    const double t24 = x[0]*t18; /* gamma3*s*omega_tau */
    const double t25 = -t24; /* -gamma3*s*omega_tau */
    out[4] = t25;
    const double t26 = p[8]*t18; /* m*a3^2/I1*s*omega_tau */
    const double t27 = t24*t26; /* gamma3*s*omega_tau*m*a3^2/I1*s*omega_tau */
    const double t28 = JLT_FNMA(p[13], t1, t27); /* gamma3*s*omega_tau*m*a3^2/I1*s*omega_tau - m*g*a3/I1*s*s */
    const double t29 = p[1]*t18; /* R*s*omega_tau */
    const double t30 = x[4]*p[11]; /* s*R*I3 */
    const double t31 = t17*t30; /* 1/K*(s*v_tau - G/(R*I1)*b)*s*R*I3 */
    const double t32 = JLT_FMA(x[0], t22, t31); /* gamma3*1/K*(v_tau*I3*b + s*R*G) + 1/K*(s*v_tau - G/(R*I1)*b)*s*R*I3 */
    const double t33 = JLT_FNMA(t22, t32, t28); /* gamma3*s*omega_tau*m*a3^2/I1*s*omega_tau - m*g*a3/I1*s*s - 1/K*(v_tau*I3*b + s*R*G)*t32 */
    const double t34 = t12*t33; /* K*1/(K*(D/I1))*t33 */
    out[2] = t34;
    const double t35 = JLT_FMA(p[5], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t36 = JLT_FMA(x[2], t35, x[1]); /* V = omega_tau*e + v_nu */
    const double t37 = t22*t36; /* 1/K*(v_tau*I3*b + s*R*G)*V */
    const double t38 = x[1]*t22; /* v_nu*1/K*(v_tau*I3*b + s*R*G) */
    const double t39 = JLT_FMS(x[0], p[14], p[15]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t40 = t29*t39; /* R*s*omega_tau*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t41 = JLT_FNMA(t17, t40, t37); /* 1/K*(v_tau*I3*b + s*R*G)*V - 1/K*(s*v_tau - G/(R*I1)*b)*R*s*omega_tau*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t42 = JLT_FMS(t14, t41, t38); /* 1/(Theta/m*K*D/I1)*I1*I3/m*K*D/I1*t41 - v_nu*1/K*(v_tau*I3*b + s*R*G) */
    out[3] = t42;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[21] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[2] = t0;
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[4] = t2;
    const double t3 = x[3]*p[11]; /* v_tau*R*I3 */
    const double t4 = JLT_FMA(t0, p[8], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t5 = t0*p[9]; /* s*s*R^2*I1 */
    const double t6 = p[17] + x[0]; /* b/R = a3/R + gamma3 */
    const double t7 = p[16]*t6; /* R^2*I3*b/R */
    const double t8 = JLT_FMA(t6, t7, t5); /* K = b/R*R^2*I3*b/R + s*s*R^2*I1 */
    const double t9 = t8 + p[10]; /* Theta/m = K + I1*I3/m */
    const double t10 = t4*t8; /* D/I1*K */
    const double t11 = t9*t10; /* Theta/m*D/I1*K */
    const double t12 = 1.0/t11; /* 1/(Theta/m*D/I1*K) */
    const double t13 = t9*t12; /* 1/(K*(D/I1)) = Theta/m*1/(Theta/m*D/I1*K) */
    const double t14 = t4*t13; /* 1/K = D/I1*1/(K*(D/I1)) */
    const double t15 = t3*t14; /* v_tau*R*I3*1/K */
    const double t16 = x[4]*p[7]; /* s*R*G */
    const double t17 = JLT_FMA(t3, t6, t16); /* v_tau*R*I3*b/R + s*R*G */
    const double t18 = t14*t17; /* 1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t19 = t6*t14; /* b/R*1/K */
    const double t20 = p[18]*t19; /* 2*R^2*I3*b/R*1/K */
    const double t21 = JLT_FNMA(t18, t20, t15); /* v_tau*R*I3*1/K - 1/K*(v_tau*R*I3*b/R + s*R*G)*2*R^2*I3*b/R*1/K */
    const double t22 = x[3]*t21; /* v_tau*t21 */
    out[5] = t22;
    const double t23 = JLT_FMA(t3, t19, t18); /* v_tau*R*I3*b/R*1/K + 1/K*(v_tau*R*I3*b/R + s*R*G) */
    out[8] = t23;
    const double t24 = t14*p[7]; /* 1/K*R*G */
    const double t25 = x[3]*t24; /* v_tau*1/K*R*G */
    const double t26 = t18*p[19]; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*2*R^2*I1 */
    const double t27 = x[4]*t14; /* s*1/K */
    const double t28 = x[3]*t27; /* v_tau*s*1/K */
    const double t29 = JLT_FNMA(t26, t28, t25); /* v_tau*1/K*R*G - 1/K*(v_tau*R*I3*b/R + s*R*G)*2*R^2*I1*v_tau*s*1/K */
    out[9] = t29;
    const double t30 = t8*t13; /* 1/(D/I1) = K*1/(K*(D/I1)) */
    const double t31 = t1*t30; /* s*omega_tau*1/(D/I1) */
    const double t32 = t1*p[8]; /* s*omega_tau*m*a3^2/I1 */
    const double t33 = t31*t32; /* s*omega_tau*1/(D/I1)*s*omega_tau*m*a3^2/I1 */
    const double t34 = t18*t30; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1) */
    const double t35 = x[4]*x[3]; /* s*v_tau */
    const double t36 = JLT_FNMA(t6, p[21], t35); /* s*v_tau - b/R*G/I1 */
    const double t37 = t27*t36; /* s*1/K*(s*v_tau - b/R*G/I1) */
    const double t38 = x[0]*t18; /* gamma3*1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t39 = JLT_FMA(p[11], t37, t38); /* R*I3*s*1/K*(s*v_tau - b/R*G/I1) + gamma3*1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t40 = t19*p[20]; /* b/R*1/K*4*R^2*I3 */
    const double t41 = JLT_FMS(t39, t40, t18); /* t39*b/R*1/K*4*R^2*I3 - 1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t42 = JLT_FMA(t37, p[22], t38); /* s*1/K*(s*v_tau - b/R*G/I1)*1/2*R*I3 + gamma3*1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t43 = 2.0*t30; /* 2*1/(D/I1) */
    const double t44 = t42*t43; /* t42*2*1/(D/I1) */
    const double t45 = t27*t34; /* s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1) */
    const double t46 = JLT_FMA(p[23], t45, t33); /* R*I3*G/I1*s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1) + s*omega_tau*1/(D/I1)*s*omega_tau*m*a3^2/I1 */
    const double t47 = JLT_FNMA(t15, t44, t46); /* t46 - v_tau*R*I3*1/K*t42*2*1/(D/I1) */
    const double t48 = JLT_FMA(t34, t41, t47); /* 1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*(t39*b/R*1/K*4*R^2*I3 - 1/K*(v_tau*R*I3*b/R + s*R*G)) + t46 - v_tau*R*I3*1/K*t42*2*1/(D/I1) */
    out[10] = t48;
    const double t49 = x[4]*x[0]; /* s*gamma3 */
    const double t50 = p[24]*t49; /* 2*m*a3^2/I1*s*gamma3 */
    const double t51 = t31*t50; /* s*omega_tau*1/(D/I1)*2*m*a3^2/I1*s*gamma3 */
    out[12] = t51;
    const double t52 = x[4]*t45; /* s*s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1) */
    const double t53 = JLT_FMA(t19, t44, t52); /* b/R*1/K*t42*2*1/(D/I1) + s*s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1) */
    const double t54 = p[25]*t53; /* (-R*I3)*t53 */
    out[13] = t54;
    const double t55 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t56 = x[4]*t30; /* s*1/(D/I1) */
    const double t57 = x[4]*p[28]; /* s*2*m*a3^2/I1^2 */
    const double t58 = JLT_FNMA(t56, t57, p[27]); /* 2/I1 - s*1/(D/I1)*s*2*m*a3^2/I1^2 */
    const double t59 = p[26]*t55; /* m*a3^2*omega_tau*gamma3 */
    const double t60 = t31*t59; /* s*omega_tau*1/(D/I1)*m*a3^2*omega_tau*gamma3 */
    const double t61 = t58*t60; /* (2/I1 - s*1/(D/I1)*s*2*m*a3^2/I1^2)*s*omega_tau*1/(D/I1)*m*a3^2*omega_tau*gamma3 */
    const double t62 = t56*p[29]; /* s*1/(D/I1)*m*g*a3 */
    const double t63 = t34*t50; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*2*m*a3^2/I1*s*gamma3 */
    const double t64 = p[24]*t56; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t65 = JLT_FMA(t14, t36, t28); /* 1/K*(s*v_tau - b/R*G/I1) + v_tau*s*1/K */
    const double t66 = JLT_FMS(t37, t64, t65); /* s*1/K*(s*v_tau - b/R*G/I1)*2*m*a3^2/I1*s*1/(D/I1) - (1/K*(s*v_tau - b/R*G/I1) + v_tau*s*1/K) */
    const double t67 = JLT_FMA(p[11], t66, t63); /* R*I3*t66 + 1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*2*m*a3^2/I1*s*gamma3 */
    const double t68 = t45*p[30]; /* s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*4*R^2*I1 */
    const double t69 = JLT_FNMA(t58, t62, t61); /* t61 - (2/I1 - s*1/(D/I1)*s*2*m*a3^2/I1^2)*s*1/(D/I1)*m*g*a3 */
    const double t70 = JLT_FMA(t39, t68, t69); /* t39*s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*4*R^2*I1 + t61 - (2/I1 - s*1/(D/I1)*s*2*m*a3^2/I1^2)*s*1/(D/I1)*m*g*a3 */
    const double t71 = JLT_FNMA(t24, t44, t70); /* t70 - 1/K*R*G*t42*2*1/(D/I1) */
    const double t72 = JLT_FMA(t34, t67, t71); /* 1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*t67 + t70 - 1/K*R*G*t42*2*1/(D/I1) */
    out[14] = t72;
    const double t73 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t74 = JLT_FMA(x[2], t73, x[1]); /* V = omega_tau*e + v_nu */
    const double t75 = t10*t12; /* 1/(Theta/m) = D/I1*K*1/(Theta/m*D/I1*K) */
    const double t76 = t74*t75; /* V*1/(Theta/m) */
    const double t77 = JLT_FNMA(p[10], t76, x[1]); /* v_nu - I1*I3/m*V*1/(Theta/m) */
    const double t78 = t15*t77; /* v_tau*R*I3*1/K*(v_nu - I1*I3/m*V*1/(Theta/m)) */
    const double t79 = t20*x[1]; /* 2*R^2*I3*b/R*1/K*v_nu */
    const double t80 = x[2]*t75; /* omega_tau*1/(Theta/m) */
    const double t81 = JLT_FMA(p[31], t80, t79); /* I1*I3*a3/m*omega_tau*1/(Theta/m) + 2*R^2*I3*b/R*1/K*v_nu */
    const double t82 = t14 + t75; /* 1/K + 1/(Theta/m) */
    const double t83 = t17*t76; /* (v_tau*R*I3*b/R + s*R*G)*V*1/(Theta/m) */
    const double t84 = JLT_FMS(x[0], p[14], p[15]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t85 = t75*t84; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t86 = t1*t85; /* s*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t87 = t36*p[1]; /* (s*v_tau - b/R*G/I1)*R */
    const double t88 = JLT_FNMA(t86, t87, t83); /* (v_tau*R*I3*b/R + s*R*G)*V*1/(Theta/m) - s*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*(s*v_tau - b/R*G/I1)*R */
    const double t89 = t82*t88; /* (1/K + 1/(Theta/m))*t88 */
    const double t90 = t19*p[32]; /* b/R*1/K*2*R^2*I1*I3^2/m */
    const double t91 = t80*p[33]; /* omega_tau*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    const double t92 = x[2]*t85; /* omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t93 = p[34]*t92; /* R*I3*G/m*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t94 = JLT_FMS(t27, t93, t78); /* s*1/K*R*I3*G/m*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) - v_tau*R*I3*1/K*(v_nu - I1*I3/m*V*1/(Theta/m)) */
    const double t95 = JLT_FNMA(t37, t91, t94); /* t94 - s*1/K*(s*v_tau - b/R*G/I1)*omega_tau*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    const double t96 = JLT_FMA(t18, t81, t95); /* 1/K*(v_tau*R*I3*b/R + s*R*G)*(I1*I3*a3/m*omega_tau*1/(Theta/m) + 2*R^2*I3*b/R*1/K*v_nu) + t95 */
    const double t97 = JLT_FNMA(t89, t90, t96); /* t96 - (1/K + 1/(Theta/m))*t88*b/R*1/K*2*R^2*I1*I3^2/m */
    out[15] = t97;
    const double t98 = p[10]*t75; /* I1*I3/m*1/(Theta/m) */
    const double t99 = t18*t98; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*I1*I3/m*1/(Theta/m) */
    const double t100 = t99 - t18; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*I1*I3/m*1/(Theta/m) - 1/K*(v_tau*R*I3*b/R + s*R*G) */
    out[16] = t100;
    const double t101 = t73*t99; /* e*1/K*(v_tau*R*I3*b/R + s*R*G)*I1*I3/m*1/(Theta/m) */
    const double t102 = t85*p[35]; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*R*I1*I3/m */
    const double t103 = JLT_FNMA(t37, t102, t101); /* e*1/K*(v_tau*R*I3*b/R + s*R*G)*I1*I3/m*1/(Theta/m) - s*1/K*(s*v_tau - b/R*G/I1)*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*R*I1*I3/m */
    out[17] = t103;
    const double t104 = t19*p[25]; /* b/R*1/K*(-R*I3) */
    const double t105 = t77*t104; /* (v_nu - I1*I3/m*V*1/(Theta/m))*b/R*1/K*(-R*I3) */
    const double t106 = t86*p[36]; /* s*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*(-R*I1*I3/m) */
    const double t107 = JLT_FMA(t27, t106, t105); /* s*1/K*t106 + (v_nu - I1*I3/m*V*1/(Theta/m))*b/R*1/K*(-R*I3) */
    out[18] = t107;
    const double t108 = t92*p[35]; /* omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*R*I1*I3/m */
    const double t109 = t24*t77; /* 1/K*R*G*(v_nu - I1*I3/m*V*1/(Theta/m)) */
    const double t110 = t26*x[1]; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*2*R^2*I1*v_nu */
    const double t111 = JLT_FNMA(t89, p[37], t110); /* 1/K*(v_tau*R*I3*b/R + s*R*G)*2*R^2*I1*v_nu - (1/K + 1/(Theta/m))*t88*2*R^2*I1^2*I3/m */
    const double t112 = JLT_FMS(t27, t111, t109); /* s*1/K*t111 - 1/K*R*G*(v_nu - I1*I3/m*V*1/(Theta/m)) */
    const double t113 = JLT_FNMA(t65, t108, t112); /* s*1/K*t111 - 1/K*R*G*(v_nu - I1*I3/m*V*1/(Theta/m)) - (1/K*(s*v_tau - b/R*G/I1) + v_tau*s*1/K)*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*R*I1*I3/m */
    out[19] = t113;
    const double t114 = -t1; /* -s*omega_tau */
    out[20] = t114;
    const double t115 = -t49; /* -s*gamma3 */
    out[22] = t115;
    const double t116 = -t55; /* -omega_tau*gamma3 */
    out[24] = t116;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t0 = p[17] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = x[4]*x[4]; /* s*s */
    out[7] = t1;
    const double t2 = p[9]*t1; /* R^2*I1*s*s */
    const double t3 = JLT_FMA(p[8], t1, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t4 = p[16]*t0; /* R^2*I3*b/R */
    const double t5 = JLT_FMA(t0, t4, t2); /* K = b/R*R^2*I3*b/R + R^2*I1*s*s */
    const double t6 = p[10] + t5; /* Theta/m = I1*I3/m + K */
    const double t7 = t3*t5; /* D/I1*K */
    const double t8 = t6*t7; /* Theta/m*D/I1*K */
    const double t9 = 1.0/t8; /* 1/(Theta/m*D/I1*K) */
    const double t10 = t6*t9; /* 1/(K*(D/I1)) = Theta/m*1/(Theta/m*D/I1*K) */
    const double t11 = t7*t9; /* 1/(Theta/m) = D/I1*K*1/(Theta/m*D/I1*K) */
    const double t12 = t5*t10; /* 1/(D/I1) = K*1/(K*(D/I1)) */
    const double t13 = t3*t10; /* 1/K = D/I1*1/(K*(D/I1)) */
    const double t14 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t15 = x[4]*x[2]; /* s*omega_tau */
    const double t16 = x[4]*t15; /* s*s*omega_tau */
    out[0] = t16;
    const double t17 = 2.0*t15; /* 2*s*omega_tau */
    out[9] = t17;
    const double t18 = -t15; /* -s*omega_tau */
    out[25] = t18;
    const double t19 = x[4]*p[7]; /* s*R*G */
    const double t20 = x[3]*p[11]; /* v_tau*R*I3 */
    const double t21 = JLT_FMA(t0, t20, t19); /* b/R*v_tau*R*I3 + s*R*G */
    const double t22 = t13*t21; /* 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t23 = x[3]*t22; /* v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[1] = t23;
    const double t24 = x[4]*t12; /* s*1/(D/I1) */
    const double t25 = JLT_FMA(x[2], t14, x[1]); /* V = omega_tau*e + v_nu */
    const double t26 = JLT_FMS(x[0], p[14], p[15]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t27 = t11*t26; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t28 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t29 = -t28; /* -omega_tau*gamma3 */
    out[29] = t29;
    const double t30 = p[24]*t28; /* 2*m*a3^2/I1*omega_tau*gamma3 */
    const double t31 = x[2]*t24; /* omega_tau*s*1/(D/I1) */
    const double t32 = t30*t31; /* 2*m*a3^2/I1*omega_tau*gamma3*omega_tau*s*1/(D/I1) */
    const double t33 = JLT_FNMA(p[40], t24, t32); /* 2*m*a3^2/I1*omega_tau*gamma3*omega_tau*s*1/(D/I1) - 2*m*g*a3/I1*s*1/(D/I1) */
    const double t34 = x[4]*x[3]; /* s*v_tau */
    const double t35 = p[10]*t25; /* I1*I3/m*V */
    const double t36 = JLT_FNMA(t11, t35, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t37 = p[34]*t15; /* R*I3*G/m*s*omega_tau */
    const double t38 = t27*t37; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*R*I3*G/m*s*omega_tau */
    const double t39 = JLT_FNMA(t20, t36, t38); /* t38 - v_tau*R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t40 = t13*t39; /* 1/K*(t38 - v_tau*R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V)) */
    const double t41 = JLT_FNMA(p[21], t0, t34); /* s*v_tau - G/I1*b/R */
    const double t42 = t34 + t41; /* s*v_tau + s*v_tau - G/I1*b/R */
    const double t43 = t13*t42; /* 1/K*(s*v_tau + s*v_tau - G/I1*b/R) */
    const double t44 = x[4]*t13; /* s*1/K */
    const double t45 = t41*t44; /* (s*v_tau - G/I1*b/R)*s*1/K */
    const double t46 = x[0]*t15; /* gamma3*s*omega_tau */
    const double t47 = -t46; /* -gamma3*s*omega_tau */
    out[4] = t47;
    const double t48 = x[4]*t24; /* s*s*1/(D/I1) */
    const double t49 = t12*t22; /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t50 = p[11]*t12; /* R*I3*1/(D/I1) */
    const double t51 = t45*t50; /* (s*v_tau - G/I1*b/R)*s*1/K*R*I3*1/(D/I1) */
    const double t52 = t0*t13; /* b/R*1/K */
    const double t53 = p[32]*t0; /* 2*R^2*I1*I3^2/m*b/R */
    const double t54 = JLT_FMA(t20, t52, t22); /* v_tau*R*I3*b/R*1/K + 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[13] = t54;
    const double t55 = t13*t20; /* 1/K*v_tau*R*I3 */
    const double t56 = p[41]*t24; /* 2*m^2*g*a3^3/I1^2*s*1/(D/I1) */
    const double t57 = JLT_FMA(t48, t56, t33); /* s*s*1/(D/I1)*2*m^2*g*a3^3/I1^2*s*1/(D/I1) + t33 */
    const double t58 = t31*t46; /* omega_tau*s*1/(D/I1)*gamma3*s*omega_tau */
    const double t59 = x[0]*t49; /* gamma3*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t60 = JLT_FMA(2.0, t59, t51); /* 2*gamma3*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) + (s*v_tau - G/I1*b/R)*s*1/K*R*I3*1/(D/I1) */
    const double t61 = t22*t59; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*gamma3*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t62 = p[18]*t22; /* 2*R^2*I3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t63 = t52*t62; /* b/R*1/K*2*R^2*I3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t64 = p[7]*t13; /* R*G*1/K */
    const double t65 = t11 + t13; /* 1/(Theta/m) + 1/K */
    const double t66 = t22*t44; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t67 = p[8]*t15; /* m*a3^2/I1*s*omega_tau */
    const double t68 = t31*t67; /* omega_tau*s*1/(D/I1)*m*a3^2/I1*s*omega_tau */
    const double t69 = t15*t44; /* s*omega_tau*s*1/K */
    const double t70 = p[38]*t52; /* 4*R^3*I3^2*b/R*1/K */
    const double t71 = JLT_FMS(p[23], t44, t22); /* R*I3*G/I1*s*1/K - 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t72 = JLT_FMA(t45, t70, t71); /* (s*v_tau - G/I1*b/R)*s*1/K*4*R^3*I3^2*b/R*1/K + R*I3*G/I1*s*1/K - 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t73 = JLT_FMA(t49, t72, t68); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*t72 + omega_tau*s*1/(D/I1)*m*a3^2/I1*s*omega_tau */
    const double t74 = p[11]*t49; /* R*I3*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t75 = p[39]*t24; /* 2*m^2*a3^4/I1^2*s*1/(D/I1) */
    const double t76 = JLT_FNMA(t58, t75, t57); /* s*s*1/(D/I1)*2*m^2*g*a3^3/I1^2*s*1/(D/I1) + t33 - omega_tau*s*1/(D/I1)*gamma3*s*omega_tau*2*m^2*a3^4/I1^2*s*1/(D/I1) */
    const double t77 = JLT_FNMA(t43, t74, t76); /* t76 - 1/K*(s*v_tau + s*v_tau - G/I1*b/R)*R*I3*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t78 = JLT_FMA(t45, t74, t61); /* (s*v_tau - G/I1*b/R)*s*1/K*R*I3*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) + t61 */
    const double t79 = x[2]*t43; /* omega_tau*1/K*(s*v_tau + s*v_tau - G/I1*b/R) */
    const double t80 = JLT_FMA(p[13], t48, t78); /* m*g*a3/I1*s*s*1/(D/I1) + t78 */
    const double t81 = JLT_FMS(p[8], t58, t80); /* m*a3^2/I1*omega_tau*s*1/(D/I1)*gamma3*s*omega_tau - (m*g*a3/I1*s*s*1/(D/I1) + t78) */
    out[2] = t81;
    const double t82 = t11*t22; /* 1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t83 = t25*t82; /* V*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t84 = p[33]*t11; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t85 = x[2]*p[31]; /* omega_tau*I1*I3*a3/m */
    const double t86 = JLT_FMA(t82, t85, t40); /* 1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G)*omega_tau*I1*I3*a3/m + 1/K*(t38 - v_tau*R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V)) */
    const double t87 = JLT_FMA(x[1], t63, t86); /* v_nu*b/R*1/K*2*R^2*I3*1/K*(b/R*v_tau*R*I3 + s*R*G) + t86 */
    const double t88 = p[10]*t82; /* I1*I3/m*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t89 = t55 - t63; /* 1/K*v_tau*R*I3 - b/R*1/K*2*R^2*I3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t90 = x[3]*t89; /* v_tau*t89 */
    out[10] = t90;
    const double t91 = t14*t88; /* e*I1*I3/m*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t92 = t88 - t22; /* I1*I3/m*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) - 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[21] = t92;
    const double t93 = t22*t36; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t94 = x[2]*t45; /* omega_tau*(s*v_tau - G/I1*b/R)*s*1/K */
    const double t95 = JLT_FNMA(t84, t94, t87); /* v_nu*b/R*1/K*2*R^2*I3*1/K*(b/R*v_tau*R*I3 + s*R*G) + t86 - R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*omega_tau*(s*v_tau - G/I1*b/R)*s*1/K */
    const double t96 = p[19]*t66; /* 2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t97 = p[24]*t24; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t98 = t46*t97; /* gamma3*s*omega_tau*2*m*a3^2/I1*s*1/(D/I1) */
    out[17] = t98;
    const double t99 = JLT_FMA(p[30], t44, t97); /* 4*R^2*I1*s*1/K + 2*m*a3^2/I1*s*1/(D/I1) */
    const double t100 = JLT_FMA(t78, t99, t77); /* t78*(4*R^2*I1*s*1/K + 2*m*a3^2/I1*s*1/(D/I1)) + t77 */
    const double t101 = JLT_FNMA(t60, t64, t100); /* t78*(4*R^2*I1*s*1/K + 2*m*a3^2/I1*s*1/(D/I1)) + t77 - t60*R*G*1/K */
    out[19] = t101;
    const double t102 = p[1]*t27; /* R*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t103 = JLT_FNMA(t94, t102, t83); /* V*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) - omega_tau*(s*v_tau - G/I1*b/R)*s*1/K*R*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t104 = t65*t103; /* (1/(Theta/m) + 1/K)*t103 */
    const double t105 = JLT_FNMA(t53, t104, t95); /* t95 - 2*R^2*I1*I3^2/m*b/R*(1/(Theta/m) + 1/K)*t103 */
    out[20] = t105;
    const double t106 = p[35]*t27; /* R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t107 = JLT_FNMA(t45, t106, t91); /* e*I1*I3/m*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) - (s*v_tau - G/I1*b/R)*s*1/K*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    out[22] = t107;
    const double t108 = JLT_FMA(t94, t106, t93); /* omega_tau*(s*v_tau - G/I1*b/R)*s*1/K*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) + 1/K*(b/R*v_tau*R*I3 + s*R*G)*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t109 = -t108; /* -t108 */
    out[3] = t109;
    const double t110 = p[11]*t36; /* R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t111 = t36*t64; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t112 = t52*t110; /* b/R*1/K*R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t113 = JLT_FMA(t69, t106, t112); /* s*omega_tau*s*1/K*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) + b/R*1/K*R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t114 = -t113; /* -t113 */
    out[23] = t114;
    const double t115 = JLT_FMS(x[1], t96, t111); /* v_nu*2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K - (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t116 = JLT_FNMA(t79, t106, t115); /* t115 - omega_tau*1/K*(s*v_tau + s*v_tau - G/I1*b/R)*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t117 = t64 - t96; /* R*G*1/K - 2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t118 = x[3]*t117; /* v_tau*(R*G*1/K - 2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[14] = t118;
    const double t119 = p[20]*t52; /* 4*R^2*I3*b/R*1/K */
    const double t120 = JLT_FMA(t61, t119, t73); /* t61*4*R^2*I3*b/R*1/K + t73 */
    const double t121 = JLT_FNMA(t55, t60, t120); /* t61*4*R^2*I3*b/R*1/K + t73 - 1/K*v_tau*R*I3*t60 */
    out[15] = t121;
    const double t122 = t52*t60; /* b/R*1/K*t60 */
    const double t123 = JLT_FMA(t24, t66, t122); /* s*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + b/R*1/K*t60 */
    const double t124 = p[25]*t123; /* (-R*I3)*(s*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + b/R*1/K*t60) */
    out[18] = t124;
    const double t125 = x[4]*p[37]; /* s*2*R^2*I1^2*I3/m */
    const double t126 = JLT_FNMA(t104, t125, t116); /* t116 - (1/(Theta/m) + 1/K)*t103*s*2*R^2*I1^2*I3/m */
    out[24] = t126;
    const double t127 = x[4]*x[0]; /* s*gamma3 */
    const double t128 = -t127; /* -s*gamma3 */
    out[27] = t128;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[0] + p[17]; /* b/R = gamma3 + a3/R */
    const double t2 = p[43]*t1; /* I3/I1*b/R */
    const double t3 = JLT_FMA(t1, t2, t0); /* K/(R^2*I1) = b/R*I3/I1*b/R + s*s */
    const double t4 = t3 + p[44]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t5 = JLT_FMA(t0, p[26], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t3*t5; /* K/(R^2*I1)*D */
    const double t7 = t4*t6; /* Theta/(m*R^2*I1)*K/(R^2*I1)*D */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t9 = t4*t8; /* 1/(D*(K/(R^2*I1))) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t10 = x[0]*p[42]; /* gamma3*2*m*a3^2 */
    const double t11 = t3*t10; /* K/(R^2*I1)*gamma3*2*m*a3^2 */
    const double t12 = t9*t11; /* 1/(D*(K/(R^2*I1)))*K/(R^2*I1)*gamma3*2*m*a3^2 */
    const double t13 = JLT_FMS(x[0], p[14], p[15]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t14 = t5*t8; /* 1/((K/(R^2*I1))*(Theta/(m*R^2*I1))) = D*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t15 = p[45]*t13; /* I3/(m*R^3*I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t16 = JLT_FNMA(t14, t15, t12); /* 1/(D*(K/(R^2*I1)))*K/(R^2*I1)*gamma3*2*m*a3^2 - 1/((K/(R^2*I1))*(Theta/(m*R^2*I1)))*I3/(m*R^3*I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t17 = JLT_FNMA(t0, t16, x[0]); /* gamma3 - s*s*t16 */
    const double t18 = p[46]*x[1]; /* I3/(R*I1)*v_nu */
    const double t19 = t1*t18; /* b/R*I3/(R*I1)*v_nu */
    const double t20 = t5*t19; /* D*b/R*I3/(R*I1)*v_nu */
    const double t21 = t9*t20; /* 1/(D*(K/(R^2*I1)))*D*b/R*I3/(R*I1)*v_nu */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = t1*p[47]; /* b/R*I3^2/(m*R^3*I1) */
    const double t25 = t23*t24; /* V*b/R*I3^2/(m*R^3*I1) */
    const double t26 = JLT_FMS(t14, t25, t21); /* 1/((K/(R^2*I1))*(Theta/(m*R^2*I1)))*V*b/R*I3^2/(m*R^3*I1) - 1/(D*(K/(R^2*I1)))*D*b/R*I3/(R*I1)*v_nu */
    const double t27 = JLT_FNMA(x[2], t17, t26); /* t26 - omega_tau*(gamma3 - s*s*t16) */
    out[0] = t27;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0] + p[17]; /* b/R = gamma3 + a3/R */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[43]*t0; /* I3/I1*b/R */
    const double t3 = JLT_FMA(t0, t2, t1); /* K/(R^2*I1) = b/R*I3/I1*b/R + s*s */
    const double t4 = JLT_FMA(p[26], t1, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t5 = p[44] + t3; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[49]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = t7/t3; /* (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t10 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/2*omega_tau */
    const double t12 = p[29]*x[0]; /* m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t4, t11, t12); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(p[48], t9, t13); /* 1/2*m*t9 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    out[0] = t14;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = x[4]*p[9]; /* s*R^2*I1 */
    const double t2 = p[17] + x[0]; /* b/R = a3/R + gamma3 */
    const double t3 = x[4]*t1; /* s*s*R^2*I1 */
    const double t4 = p[16]*t2; /* R^2*I3*b/R */
    const double t5 = JLT_FMA(t2, t4, t3); /* K = b/R*R^2*I3*b/R + s*s*R^2*I1 */
    const double t6 = p[51]*x[3]; /* I1*I3*v_tau */
    const double t7 = JLT_FMA(x[3], t6, p[50]); /* v_tau*I1*I3*v_tau + G^2 */
    const double t8 = 1.0/t5; /* 1/K */
    const double t9 = t7*t8; /* (v_tau*I1*I3*v_tau + G^2)*1/K */
    const double t10 = JLT_FMA(p[0], t5, p[51]); /* Theta = m*K + I1*I3 */
    const double t11 = t8*t9; /* 1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
    const double t12 = JLT_FNMA(t4, t11, p[29]); /* m*g*a3 - R^2*I3*b/R*1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
    out[0] = t12;
    const double t13 = x[3]*t10; /* v_tau*Theta */
    const double t14 = t8*t13; /* 1/K*v_tau*Theta */
    out[3] = t14;
    const double t15 = x[4]*p[26]; /* s*m*a3^2 */
    const double t16 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t17 = t15*t16; /* s*m*a3^2*omega_tau*omega_tau */
    const double t18 = JLT_FNMA(t1, t11, t17); /* s*m*a3^2*omega_tau*omega_tau - s*R^2*I1*1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
    out[4] = t18;
    const double t19 = JLT_FMA(x[4], t15, p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t20 = x[2]*t19; /* omega_tau*D */
    out[2] = t20;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void observe_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*p[8]; /* s*m*a3^2/I1 */
    const double t1 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = p[4]*t1; /* I3*b */
    const double t4 = JLT_FMA(x[4], t0, 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t5 = p[9]*t2; /* R^2*I1*s*s */
    const double t6 = JLT_FMA(t1, t3, t5); /* K = b*I3*b + R^2*I1*s*s */
    const double t7 = x[4]*t4; /* s*D/I1 */
    const double t8 = x[0]*t4; /* gamma3*D/I1 */
    const double t9 = t6*t7; /* K*s*D/I1 */
    const double t10 = 1.0/t9; /* 1/(K*s*D/I1) */
    const double t11 = t6*t10; /* 1/((D/I1)*s) = K*1/(K*s*D/I1) */
    const double t12 = t7*t10; /* 1/K = s*D/I1*1/(K*s*D/I1) */
    const double t13 = t2*t11; /* s*s*1/((D/I1)*s) */
    const double t14 = x[4]*p[7]; /* s*R*G */
    const double t15 = JLT_FMA(x[3], t3, t14); /* v_tau*I3*b + s*R*G */
    const double t16 = t8*t15; /* gamma3*D/I1*(v_tau*I3*b + s*R*G) */
    const double t17 = t11*t16; /* 1/((D/I1)*s)*gamma3*D/I1*(v_tau*I3*b + s*R*G) */
    const double t18 = t12*t15; /* 1/K*(v_tau*I3*b + s*R*G) */
    const double t19 = t12*t18; /* 1/K*1/K*(v_tau*I3*b + s*R*G) */
    const double t20 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t21 = x[2]*t20; /* omega_tau*gamma3*omega_tau */
    const double t22 = x[4]*x[3]; /* s*v_tau */
    const double t23 = JLT_FNMA(p[12], t1, t22); /* s*v_tau - G/(R*I1)*b */
    const double t24 = JLT_FMA(p[11], t23, t17); /* R*I3*(s*v_tau - G/(R*I1)*b) + 1/((D/I1)*s)*gamma3*D/I1*(v_tau*I3*b + s*R*G) */
    const double t25 = p[13]*x[4]; /* m*g*a3/I1*s */
    const double t26 = JLT_FNMA(t0, t21, t25); /* m*g*a3/I1*s - s*m*a3^2/I1*omega_tau*gamma3*omega_tau */
    const double t27 = JLT_FMA(t19, t24, t26); /* 1/K*1/K*(v_tau*I3*b + s*R*G)*t24 + m*g*a3/I1*s - s*m*a3^2/I1*omega_tau*gamma3*omega_tau */
    const double t28 = JLT_FMA(t13, t27, t21); /* s*s*1/((D/I1)*s)*t27 + omega_tau*gamma3*omega_tau */
    const double t29 = JLT_FNMA(p[53], t28, p[52]); /* contact_force = m*g - m*a3*(s*s*1/((D/I1)*s)*t27 + omega_tau*gamma3*omega_tau) */
    out[0] = t29;
}

static void valid_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*p[8]; /* s*m*a3^2/I1 */
    const double t1 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = p[4]*t1; /* I3*b */
    const double t4 = JLT_FMA(x[4], t0, 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t5 = p[9]*t2; /* R^2*I1*s*s */
    const double t6 = JLT_FMA(t1, t3, t5); /* K = b*I3*b + R^2*I1*s*s */
    const double t7 = x[4]*t4; /* s*D/I1 */
    const double t8 = x[0]*t4; /* gamma3*D/I1 */
    const double t9 = t6*t7; /* K*s*D/I1 */
    const double t10 = 1.0/t9; /* 1/(K*s*D/I1) */
    const double t11 = t6*t10; /* 1/((D/I1)*s) = K*1/(K*s*D/I1) */
    const double t12 = t7*t10; /* 1/K = s*D/I1*1/(K*s*D/I1) */
    const double t13 = t2*t11; /* s*s*1/((D/I1)*s) */
    const double t14 = x[4]*p[7]; /* s*R*G */
    const double t15 = JLT_FMA(x[3], t3, t14); /* v_tau*I3*b + s*R*G */
    const double t16 = t8*t15; /* gamma3*D/I1*(v_tau*I3*b + s*R*G) */
    const double t17 = t11*t16; /* 1/((D/I1)*s)*gamma3*D/I1*(v_tau*I3*b + s*R*G) */
    const double t18 = t12*t15; /* 1/K*(v_tau*I3*b + s*R*G) */
    const double t19 = t12*t18; /* 1/K*1/K*(v_tau*I3*b + s*R*G) */
    const double t20 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t21 = x[2]*t20; /* omega_tau*gamma3*omega_tau */
    const double t22 = x[4]*x[3]; /* s*v_tau */
    const double t23 = JLT_FNMA(p[12], t1, t22); /* s*v_tau - G/(R*I1)*b */
    const double t24 = JLT_FMA(p[11], t23, t17); /* R*I3*(s*v_tau - G/(R*I1)*b) + 1/((D/I1)*s)*gamma3*D/I1*(v_tau*I3*b + s*R*G) */
    const double t25 = p[13]*x[4]; /* m*g*a3/I1*s */
    const double t26 = JLT_FNMA(t0, t21, t25); /* m*g*a3/I1*s - s*m*a3^2/I1*omega_tau*gamma3*omega_tau */
    const double t27 = JLT_FMA(t19, t24, t26); /* 1/K*1/K*(v_tau*I3*b + s*R*G)*t24 + m*g*a3/I1*s - s*m*a3^2/I1*omega_tau*gamma3*omega_tau */
    const double t28 = JLT_FMA(t13, t27, t21); /* s*s*1/((D/I1)*s)*t27 + omega_tau*gamma3*omega_tau */
    const double t29 = JLT_FNMA(p[53], t28, p[52]); /* contact_force = m*g - m*a3*(s*s*1/((D/I1)*s)*t27 + omega_tau*gamma3*omega_tau) */
    out[0] = t29;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t19[k] = jlt_jet_product(x4, x4, k);
        t20[k] = jlt_jet_product(x2, t19, k);
        t21[k] = p[1]*x0[k] + (k == 0 ? p[5] : 0);
        t22[k] = p[4]*t21[k];
        t23[k] = p[9]*t19[k];
        t24[k] = jlt_jet_product(t21, t22, k) + t23[k];
        t25[k] = p[8]*t19[k] + (k == 0 ? 1.0 : 0);
        t26[k] = (k == 0 ? p[10] : 0) + t24[k];
        t27[k] = jlt_jet_product(t24, t25, k);
        t28[k] = jlt_jet_product(t26, t27, k);
        t29[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t28, t29, k);
        t30[k] = jlt_jet_product(t26, t29, k);
        t31[k] = jlt_jet_product(t27, t29, k);
        t32[k] = jlt_jet_product(t25, t30, k);
        t33[k] = jlt_jet_product(t24, t30, k);
        t34[k] = jlt_jet_product(x4, x3, k);
        t35[k] = t34[k] - p[12]*t21[k];
        t36[k] = jlt_jet_product(t32, t35, k);
        t37[k] = p[5]*x0[k] + (k == 0 ? p[1] : 0);
        t38[k] = jlt_jet_product(x2, t37, k) + x1[k];
        t39[k] = p[10]*t38[k];
        t40[k] = x1[k] - jlt_jet_product(t31, t39, k);
        t41[k] = x4[k]*p[7];
        t42[k] = jlt_jet_product(x3, t22, k) + t41[k];
        t43[k] = jlt_jet_product(t32, t42, k);
        t44[k] = jlt_jet_product(t40, t43, k);
        t45[k] = jlt_jet_product(x3, t43, k);
        t46[k] = jlt_jet_product(x2, x4, k);
        t47[k] = jlt_jet_product(x0, t46, k);
        t48[k] = -t47[k];
        t49[k] = p[8]*t46[k];
        t50[k] = jlt_jet_product(t47, t49, k);
        t51[k] = t50[k] - p[13]*t19[k];
        t52[k] = p[35]*t46[k];
        t53[k] = x4[k]*p[11];
        t54[k] = jlt_jet_product(t36, t53, k);
        t55[k] = jlt_jet_product(x0, t43, k) + t54[k];
        t56[k] = t51[k] - jlt_jet_product(t43, t55, k);
        t57[k] = jlt_jet_product(t33, t56, k);
        t58[k] = x0[k]*p[14] - (k == 0 ? p[15] : 0);
        t59[k] = jlt_jet_product(t52, t58, k);
        t60[k] = jlt_jet_product(t31, t59, k);
        t61[k] = jlt_jet_product(t36, t60, k) + t44[k];
        t62[k] = -t61[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t20[k]/(k + 1);
        next[1] = x1[k + 1] = t45[k]/(k + 1);
        next[2] = x2[k + 1] = t57[k]/(k + 1);
        next[3] = x3[k + 1] = t62[k]/(k + 1);
        next[4] = x4[k + 1] = t48[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
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
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0), 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
};

static const jlt_quantity observes[] = {
    { "contact_force", "kg*m/s^2", "force of the plane on the sphere, upwards", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_validity valids[] = {
    { "contact", "kg*m/s^2", "the plane only pushes" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_general_in_regular = {
    .model = "spherical_top_level",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "a0362d7aafe4ac095061c9e2c7f9417b05b6c21c51ed0a0e3c3f227f5c7cacca",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 54,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 27, 13, 1, 0, 0, 13, 9 }, { 21, 82, 0, 8, 0, 0, 11, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, s*v_tau - (G/(R*I1))*b, v_tau*I3*b + s*(R*G), a part of d(omega_tau)/dtau, a part of d(omega_tau)/dtau, e = a3*gamma3 + R, V = omega_tau*e + v_nu, gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(v_tau)/dtau, d(v_tau)/dtau" },
    .jacobian = { jacobian, 25, { 7, 72, 37, 1, 0, 0, 15, 27 }, { 114, 577, 0, 55, 0, 0, 18, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, v_tau*(R*I3)*b/R + s*(R*G), v_tau*(R*I3)*1/K - 1/K*(v_tau*(R*I3)*b/R + s*(R*G))*(2*R^2*I3)*b/R*1/K, d(d(v_nu)/dtau)/d(v_tau), d(d(v_nu)/dtau)/d(s), s*v_tau - b/R*(G/I1), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), 2/I1 - s*1/(D/I1)*s*(2*m*a3^2/I1^2), 1/K*(s*v_tau - b/R*(G/I1)) + v_tau*s*1/K, a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), e = gamma3*a3 + R, V = omega_tau*e + v_nu, v_nu - (I1*I3/m)*V*1/(Theta/m), (I1*I3*a3/m)*omega_tau*1/(Theta/m) + (2*R^2*I3)*b/R*1/K*v_nu, gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(v_nu), d(d(v_tau)/dtau)/d(omega_tau), d(d(v_tau)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 13, 77, 38, 1, 0, 0, 17, 30 }, { 129, 644, 0, 63, 0, 0, 18, 12 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, e = gamma3*a3 + R, b/R*v_tau*(R*I3) + s*(R*G), V = omega_tau*e + v_nu, gamma3*(R*(I1 - I3)) - (I3*a3), v_nu - 1/(Theta/m)*(I1*I3/m)*V, a part of d(d(v_tau)/dtau)/d(gamma3), s*v_tau - (G/I1)*b/R, s*v_tau + s*v_tau - (G/I1)*b/R, d(d(v_nu)/dtau)/d(v_tau), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), d(omega_tau)/dtau, 1/K*v_tau*(R*I3) - b/R*1/K*(2*R^2*I3)*1/K*(b/R*v_tau*(R*I3) + s*(R*G)), d(d(v_tau)/dtau)/d(v_nu), d(d(omega_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(omega_tau), a part of d(v_tau)/dtau, a part of d(d(v_tau)/dtau)/d(v_tau), (R*G)*1/K - (2*R^2*I1)*1/K*(b/R*v_tau*(R*I3) + s*(R*G))*s*1/K, d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(s)" },
    .divergence = { divergence, 1, { 2, 16, 9, 1, 0, 0, 11, 8 }, { 12, 40, 0, 4, 0, 0, 12, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, gamma3*(R*(I1 - I3)) - (I3*a3), a part of the divergence, a part of the divergence, e = gamma3*a3 + R, V = omega_tau*e + v_nu, the divergence" },
    .integral_values = { integral_values, 1, { 2, 6, 6, 1, 0, 0, 8, 5 }, { 8, 27, 0, 2, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, E" },
    .integral_gradients = { integral_gradients, 5, { 1, 13, 6, 1, 0, 0, 7, 6 }, { 10, 58, 0, 7, 0, 0, 12, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, d(E)/d(gamma3), d(E)/d(s)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { observe_values, 1, { 0, 19, 10, 1, 0, 0, 11, 9 }, { 11, 48, 0, 4, 0, 0, 15, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau*I3*b + s*(R*G), s*v_tau - (G/(R*I1))*b, a part of contact_force, a part of contact_force, a part of contact_force, contact_force" },
    .valid_values = { valid_values, 1, { 0, 19, 10, 1, 0, 0, 11, 9 }, { 11, 48, 0, 4, 0, 0, 15, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau*I3*b + s*(R*G), s*v_tau - (G/(R*I1))*b, a part of contact, a part of contact, a part of contact, contact" },
    .observe_count = 1, .observes = observes,
    .valid_count = 1, .valids = valids,
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_level_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_level_general_in_regular_baseline,
        &jlt_batch_spherical_top_level_general_in_regular_avx2,
        &jlt_batch_spherical_top_level_general_in_regular_avx512,
    },
#endif
};
