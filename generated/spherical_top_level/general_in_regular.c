/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 a03ac57982f08b300ad072746897d22dbcd0a4e4ebdedbf1bb5bf573f26d0de6
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   28   13    1    0    0     13   10   (111)
 *  jacobian            8   72   37    1    0    0     16   25   (746)
 *  rhs_jacobian        10   74   40    1    0    0     15   27   (836)
 *  divergence          2   16    9    1    0    0     11    8   (56)
 *  integral_values     2    6    6    1    0    0      8    5   (37)
 *  integral_gradients  1   13    6    1    0    0      7    6   (75)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*v_tau*(R*I3) + s*(R*G), e = gamma3*a3 + R,
 *      V = omega_tau*e + v_nu, s*v_tau - (G/I1)*b/R, v_nu - 1/(Theta/m)*(I1*I3/m)*V, gamma3*(R*(I1 - I3)) - (I3*a3),
 *      d(d(v_tau)/dtau)/d(v_nu), omega_tau - s*1/(D/I1)*(m*a3^2/I1)*s*omega_tau, d(d(v_tau)/dtau)/d(omega_tau),
 *      d(d(v_nu)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(gamma3),
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s),
 *      d(omega_tau)/dtau, 1/K*v_tau*(R*I3) - 1/K*(b/R*v_tau*(R*I3) + s*(R*G))*(2*R^2*I3)*b/R*1/K,
 *      a part of d(d(omega_tau)/dtau)/d(v_tau), 1/K*(b/R*v_tau*(R*I3) + s*(R*G)) - (R*I3*G/I1)*s*1/K,
 *      v_tau*s*1/K + 1/K*(s*v_tau - (G/I1)*b/R), d(d(omega_tau)/dtau)/d(s), a part of d(v_tau)/dtau,
 *      a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(gamma3),
 *      d(d(v_tau)/dtau)/d(s), (R*G)*1/K - (2*R^2*I1)*1/K*(b/R*v_tau*(R*I3) + s*(R*G))*s*1/K,
 *      d(d(omega_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(v_tau)
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
    out[27] = t2;
    const double t3 = t2/params[3]; /* m*a3*a3/I1 */
    out[8] = t3;
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[3]*t4; /* I1*R*R */
    out[9] = t5;
    const double t6 = params[3]*params[4]; /* I1*I3 */
    out[52] = t6;
    const double t7 = t6/params[0]; /* I1*I3/m */
    out[10] = t7;
    const double t8 = params[0]*params[2]; /* m*g */
    const double t9 = params[5]*t8; /* a3*m*g */
    out[32] = t9;
    const double t10 = t9/params[3]; /* a3*m*g/I1 */
    out[11] = t10;
    const double t11 = params[4]/params[3]; /* I3/I1 */
    out[12] = t11;
    const double t12 = params[1]*params[3]; /* R*I1 */
    out[13] = t12;
    const double t13 = params[4]/params[0]; /* I3/m */
    out[14] = t13;
    const double t14 = params[3] - params[4]; /* I1 - I3 */
    const double t15 = params[1]*t14; /* R*(I1 - I3) */
    out[15] = t15;
    const double t16 = params[5]*params[4]; /* a3*I3 */
    out[16] = t16;
    const double t17 = params[1]*params[4]; /* R*I3 */
    out[17] = t17;
    const double t18 = t4*params[4]; /* R*R*I3 */
    out[18] = t18;
    const double t19 = params[5]/params[1]; /* a3/R */
    out[19] = t19;
    const double t20 = t4*2.0; /* R*R*2 */
    const double t21 = params[4]*t20; /* I3*R*R*2 */
    out[20] = t21;
    const double t22 = params[3]*t20; /* I1*R*R*2 */
    out[21] = t22;
    const double t23 = t4*4.0; /* R*R*4 */
    const double t24 = params[4]*t23; /* I3*R*R*4 */
    out[22] = t24;
    const double t25 = params[6]/params[3]; /* G/I1 */
    out[23] = t25;
    const double t26 = params[6]*t17; /* G*R*I3 */
    const double t27 = t26/params[3]; /* G*R*I3/I1 */
    out[24] = t27;
    const double t28 = params[0]*2.0; /* m*2 */
    const double t29 = t1*t28; /* a3*a3*m*2 */
    out[44] = t29;
    const double t30 = t29/params[3]; /* a3*a3*m*2/I1 */
    out[25] = t30;
    const double t31 = -t17; /* -R*I3 */
    out[26] = t31;
    const double t32 = 2.0/params[3]; /* 2/I1 */
    out[28] = t32;
    const double t33 = params[3]*params[3]; /* I1*I1 */
    const double t34 = t29/t33; /* a3*a3*m*2/(I1*I1) */
    out[29] = t34;
    const double t35 = params[3]*t23; /* I1*R*R*4 */
    out[30] = t35;
    const double t36 = params[1]*2.0; /* R*2 */
    const double t37 = t33*t36; /* I1*I1*R*2 */
    const double t38 = params[0]*params[4]; /* m*I3 */
    const double t39 = t1*t38; /* a3*a3*m*I3 */
    const double t40 = t39/t37; /* a3*a3*m*I3/(I1*I1*R*2) */
    out[31] = t40;
    const double t41 = params[5]*t6; /* a3*I1*I3 */
    const double t42 = t41/params[0]; /* a3*I1*I3/m */
    out[33] = t42;
    const double t43 = params[4]*params[4]; /* I3*I3 */
    const double t44 = t22*t43; /* I1*R*R*2*I3*I3 */
    const double t45 = t44/params[0]; /* I1*R*R*2*I3*I3/m */
    out[34] = t45;
    const double t46 = t5*params[4]; /* I1*R*R*I3 */
    const double t47 = t14*t46; /* (I1 - I3)*I1*R*R*I3 */
    const double t48 = t47/params[0]; /* (I1 - I3)*I1*R*R*I3/m */
    out[35] = t48;
    const double t49 = t26/params[0]; /* G*R*I3/m */
    out[36] = t49;
    const double t50 = params[4]*t12; /* I3*R*I1 */
    const double t51 = t50/params[0]; /* I3*R*I1/m */
    out[37] = t51;
    const double t52 = t20*t33; /* R*R*2*I1*I1 */
    const double t53 = params[4]*t52; /* I3*R*R*2*I1*I1 */
    const double t54 = t53/params[0]; /* I3*R*R*2*I1*I1/m */
    out[38] = t54;
    const double t55 = t17/2.0; /* R*I3/2 */
    out[39] = t55;
    const double t56 = t2/t52; /* m*a3*a3/(R*R*2*I1*I1) */
    out[40] = t56;
    const double t57 = params[2]*t28; /* g*m*2 */
    const double t58 = params[5]*t57; /* a3*g*m*2 */
    const double t59 = t58/params[3]; /* a3*g*m*2/I1 */
    out[41] = t59;
    const double t60 = params[0]*params[0]; /* m*m */
    const double t61 = 2.0*t60; /* 2*m*m */
    const double t62 = params[2]*t61; /* g*2*m*m */
    const double t63 = params[5]*t1; /* a3*a3*a3 */
    const double t64 = t62*t63; /* g*2*m*m*a3*a3*a3 */
    const double t65 = t64/t33; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    out[42] = t65;
    const double t66 = -t51; /* -I3*R*I1/m */
    out[43] = t66;
    const double t67 = params[0]*t4; /* m*R*R */
    const double t68 = params[4]/t67; /* I3/(m*R*R) */
    out[45] = t68;
    const double t69 = params[1]*t4; /* R*R*R */
    const double t70 = params[0]*t69; /* m*R*R*R */
    const double t71 = params[3]*t70; /* I1*m*R*R*R */
    const double t72 = params[4]/t71; /* I3/(I1*m*R*R*R) */
    out[46] = t72;
    const double t73 = params[4]/t12; /* I3/(R*I1) */
    out[47] = t73;
    const double t74 = t43/t71; /* I3*I3/(I1*m*R*R*R) */
    out[48] = t74;
    const double t75 = params[0]/2.0; /* m/2 */
    out[49] = t75;
    const double t76 = params[3]*t67; /* I1*m*R*R */
    const double t77 = params[6]*params[6]; /* G*G */
    out[51] = t77;
    const double t78 = t77/t76; /* G*G/(I1*m*R*R) */
    out[50] = t78;
    const double t79 = params[6]/t12; /* G/(R*I1) */
    out[53] = t79;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t1;
    const double t2 = JLT_FMA(p[1], x[0], p[5]); /* b = R*gamma3 + a3 */
    const double t3 = p[4]*t2; /* I3*b */
    const double t4 = p[9]*t0; /* R^2*I1*s*s */
    const double t5 = JLT_FMA(t2, t3, t4); /* K = b*I3*b + R^2*I1*s*s */
    const double t6 = JLT_FMA(p[8], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t7 = p[10] + t5; /* Theta/m = I1*I3/m + K */
    const double t8 = t5*t6; /* K*D/I1 */
    const double t9 = t7*t8; /* Theta/m*K*D/I1 */
    const double t10 = 1.0/t9; /* 1/(Theta/m*K*D/I1) */
    const double t11 = t7*t10; /* 1/(K*(D/I1)) = Theta/m*1/(Theta/m*K*D/I1) */
    const double t12 = t6*t11; /* 1/K = D/I1*1/(K*(D/I1)) */
    const double t13 = t5*t11; /* K*1/(K*(D/I1)) */
    const double t14 = p[14]*t8; /* I3/m*K*D/I1 */
    const double t15 = t10*t14; /* 1/(Theta/m*K*D/I1)*I3/m*K*D/I1 */
    const double t16 = x[4]*p[13]; /* s*R*I1 */
    const double t17 = x[3]*t16; /* v_tau*s*R*I1 */
    const double t18 = JLT_FNMA(p[6], t2, t17); /* v_tau*s*R*I1 - G*b */
    const double t19 = t12*t18; /* 1/K*(v_tau*s*R*I1 - G*b) */
    const double t20 = x[4]*p[7]; /* s*R*G */
    const double t21 = JLT_FMA(x[3], t3, t20); /* v_tau*I3*b + s*R*G */
    const double t22 = t12*t21; /* 1/K*(v_tau*I3*b + s*R*G) */
    const double t23 = x[3]*t22; /* v_tau*1/K*(v_tau*I3*b + s*R*G) */
    out[1] = t23;
    const double t24 = x[2]*x[4]; /* omega_tau*s */
    const double t25 = JLT_FMA(p[5], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t26 = JLT_FMA(x[2], t25, x[1]); /* V = omega_tau*e + v_nu */
    const double t27 = p[3]*t26; /* I1*V */
    const double t28 = t22*t27; /* 1/K*(v_tau*I3*b + s*R*G)*I1*V */
    const double t29 = x[0]*t24; /* gamma3*omega_tau*s */
    const double t30 = -t29; /* -gamma3*omega_tau*s */
    out[4] = t30;
    const double t31 = p[8]*t24; /* m*a3^2/I1*omega_tau*s */
    const double t32 = t29*t31; /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s */
    const double t33 = JLT_FNMA(p[11], t0, t32); /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s - m*g*a3/I1*s*s */
    const double t34 = x[4]*p[12]; /* s*I3/I1 */
    const double t35 = t19*t34; /* 1/K*(v_tau*s*R*I1 - G*b)*s*I3/I1 */
    const double t36 = JLT_FMA(x[0], t22, t35); /* gamma3*1/K*(v_tau*I3*b + s*R*G) + 1/K*(v_tau*s*R*I1 - G*b)*s*I3/I1 */
    const double t37 = JLT_FNMA(t22, t36, t33); /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s - m*g*a3/I1*s*s - 1/K*(v_tau*I3*b + s*R*G)*t36 */
    const double t38 = t13*t37; /* K*1/(K*(D/I1))*t37 */
    out[2] = t38;
    const double t39 = x[1]*t22; /* v_nu*1/K*(v_tau*I3*b + s*R*G) */
    const double t40 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t41 = t24*t40; /* omega_tau*s*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t42 = JLT_FNMA(t19, t41, t28); /* 1/K*(v_tau*I3*b + s*R*G)*I1*V - 1/K*(v_tau*s*R*I1 - G*b)*omega_tau*s*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t43 = JLT_FMS(t15, t42, t39); /* 1/(Theta/m*K*D/I1)*I3/m*K*D/I1*t42 - v_nu*1/K*(v_tau*I3*b + s*R*G) */
    out[3] = t43;
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
    const double t1 = p[19] + x[0]; /* b/R = a3/R + gamma3 */
    const double t2 = p[9]*t0; /* R^2*I1*s*s */
    const double t3 = p[18]*t1; /* R^2*I3*b/R */
    const double t4 = JLT_FMA(t1, t3, t2); /* K = b/R*R^2*I3*b/R + R^2*I1*s*s */
    const double t5 = JLT_FMA(p[8], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t6 = p[29]*t0; /* 2*m*a3^2/I1^2*s*s */
    const double t7 = p[10] + t4; /* Theta/m = I1*I3/m + K */
    const double t8 = t4*t5; /* K*D/I1 */
    const double t9 = t7*t8; /* Theta/m*K*D/I1 */
    const double t10 = 1.0/t9; /* 1/(Theta/m*K*D/I1) */
    const double t11 = t7*t10; /* 1/(K*(D/I1)) = Theta/m*1/(Theta/m*K*D/I1) */
    const double t12 = t8*t10; /* 1/(Theta/m) = K*D/I1*1/(Theta/m*K*D/I1) */
    const double t13 = t5*t11; /* 1/K = D/I1*1/(K*(D/I1)) */
    const double t14 = t4*t11; /* 1/(D/I1) = K*1/(K*(D/I1)) */
    const double t15 = JLT_FNMA(t6, t14, p[28]); /* 2/I1 - 2*m*a3^2/I1^2*s*s*1/(D/I1) */
    const double t16 = x[4]*x[2]; /* s*omega_tau */
    const double t17 = 2.0*t16; /* 2*s*omega_tau */
    out[4] = t17;
    const double t18 = -t16; /* -s*omega_tau */
    out[20] = t18;
    const double t19 = x[3]*p[17]; /* v_tau*R*I3 */
    const double t20 = x[4]*p[7]; /* s*R*G */
    const double t21 = JLT_FMA(t1, t19, t20); /* b/R*v_tau*R*I3 + s*R*G */
    const double t22 = t13*t19; /* 1/K*v_tau*R*I3 */
    const double t23 = x[4]*x[3]; /* s*v_tau */
    const double t24 = JLT_FNMA(p[23], t1, t23); /* s*v_tau - G/I1*b/R */
    const double t25 = t1*t13; /* b/R*1/K */
    const double t26 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t27 = x[4]*t13; /* s*1/K */
    const double t28 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t29 = -t28; /* -omega_tau*gamma3 */
    out[24] = t29;
    const double t30 = p[27]*t28; /* m*a3^2*omega_tau*gamma3 */
    const double t31 = JLT_FMA(x[2], t26, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t33 = p[1]*t16; /* R*s*omega_tau */
    const double t34 = t32*t33; /* (gamma3*R*(I1 - I3) - I3*a3)*R*s*omega_tau */
    const double t35 = t13*t21; /* 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t36 = t21*t31; /* (b/R*v_tau*R*I3 + s*R*G)*V */
    const double t37 = JLT_FNMA(t24, t34, t36); /* (b/R*v_tau*R*I3 + s*R*G)*V - (s*v_tau - G/I1*b/R)*(gamma3*R*(I1 - I3) - I3*a3)*R*s*omega_tau */
    const double t38 = t12*t37; /* 1/(Theta/m)*t37 */
    const double t39 = t14*t16; /* 1/(D/I1)*s*omega_tau */
    const double t40 = t30*t39; /* m*a3^2*omega_tau*gamma3*1/(D/I1)*s*omega_tau */
    const double t41 = t15*t40; /* (2/I1 - 2*m*a3^2/I1^2*s*s*1/(D/I1))*m*a3^2*omega_tau*gamma3*1/(D/I1)*s*omega_tau */
    const double t42 = t24*t27; /* (s*v_tau - G/I1*b/R)*s*1/K */
    const double t43 = p[10]*t12; /* I1*I3/m*1/(Theta/m) */
    const double t44 = JLT_FNMA(t31, t43, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t45 = t35*t43; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) */
    const double t46 = t26*t45; /* e*1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) */
    const double t47 = t45 - t35; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) - 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[16] = t47;
    const double t48 = x[2]*t12; /* omega_tau*1/(Theta/m) */
    const double t49 = p[17]*t42; /* R*I3*(s*v_tau - G/I1*b/R)*s*1/K */
    const double t50 = t14*t35; /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t51 = x[4]*x[0]; /* s*gamma3 */
    const double t52 = -t51; /* -s*gamma3 */
    out[22] = t52;
    const double t53 = p[25]*t51; /* 2*m*a3^2/I1*s*gamma3 */
    const double t54 = t39*t53; /* 1/(D/I1)*s*omega_tau*2*m*a3^2/I1*s*gamma3 */
    out[12] = t54;
    const double t55 = t50*t53; /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*m*a3^2/I1*s*gamma3 */
    const double t56 = x[4]*t14; /* s*1/(D/I1) */
    const double t57 = t32*t48; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m) */
    const double t58 = p[37]*t32; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t59 = t12*t58; /* 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t60 = JLT_FNMA(t42, t59, t46); /* e*1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) - (s*v_tau - G/I1*b/R)*s*1/K*1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    out[17] = t60;
    const double t61 = t12 + t13; /* 1/(Theta/m) + 1/K */
    const double t62 = t38*t61; /* 1/(Theta/m)*t37*(1/(Theta/m) + 1/K) */
    const double t63 = t16*t59; /* s*omega_tau*1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t64 = p[8]*t16; /* m*a3^2/I1*s*omega_tau */
    const double t65 = t39*t64; /* 1/(D/I1)*s*omega_tau*m*a3^2/I1*s*omega_tau */
    const double t66 = x[3]*t27; /* v_tau*s*1/K */
    const double t67 = p[21]*t35; /* 2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t68 = JLT_FMA(x[0], t35, t49); /* gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) + R*I3*(s*v_tau - G/I1*b/R)*s*1/K */
    const double t69 = 2.0*x[0]; /* 2*gamma3 */
    const double t70 = t50*t69; /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*gamma3 */
    const double t71 = JLT_FMA(t14, t49, t70); /* 1/(D/I1)*R*I3*(s*v_tau - G/I1*b/R)*s*1/K + 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*gamma3 */
    const double t72 = t27*t50; /* s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t73 = JLT_FMA(p[24], t72, t65); /* R*I3*G/I1*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) + 1/(D/I1)*s*omega_tau*m*a3^2/I1*s*omega_tau */
    const double t74 = JLT_FNMA(t22, t71, t73); /* t73 - 1/K*v_tau*R*I3*t71 */
    const double t75 = p[31]*t24; /* 1/2*m*I3*a3^2/(R*I1^2)*(s*v_tau - G/I1*b/R) */
    const double t76 = JLT_FMA(t56, t75, t68); /* s*1/(D/I1)*1/2*m*I3*a3^2/(R*I1^2)*(s*v_tau - G/I1*b/R) + t68 */
    const double t77 = p[32]*t56; /* m*g*a3*s*1/(D/I1) */
    const double t78 = JLT_FNMA(t15, t77, t41); /* t41 - (2/I1 - 2*m*a3^2/I1^2*s*s*1/(D/I1))*m*g*a3*s*1/(D/I1) */
    const double t79 = JLT_FMA(t13, t24, t66); /* 1/K*(s*v_tau - G/I1*b/R) + v_tau*s*1/K */
    const double t80 = p[7]*t13; /* R*G*1/K */
    const double t81 = JLT_FNMA(p[17], t79, t55); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*m*a3^2/I1*s*gamma3 - R*I3*(1/K*(s*v_tau - G/I1*b/R) + v_tau*s*1/K) */
    const double t82 = t66*t67; /* v_tau*s*1/K*2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t83 = JLT_FMS(x[3], t80, t82); /* v_tau*R*G*1/K - v_tau*s*1/K*2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[9] = t83;
    const double t84 = x[1]*t67; /* v_nu*2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t85 = JLT_FNMA(p[38], t62, t84); /* v_nu*2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) - 2*R^2*I1^2*I3/m*1/(Theta/m)*t37*(1/(Theta/m) + 1/K) */
    const double t86 = t22*t44; /* 1/K*v_tau*R*I3*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t87 = p[36]*t57; /* R*I3*G/m*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m) */
    const double t88 = JLT_FMS(t27, t87, t86); /* s*1/K*R*I3*G/m*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m) - 1/K*v_tau*R*I3*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t89 = p[37]*t57; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m) */
    const double t90 = p[20]*t25; /* 2*R^2*I3*b/R*1/K */
    const double t91 = JLT_FNMA(t35, t90, t22); /* 1/K*v_tau*R*I3 - 1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I3*b/R*1/K */
    const double t92 = x[3]*t91; /* v_tau*t91 */
    out[5] = t92;
    const double t93 = x[1]*t90; /* v_nu*2*R^2*I3*b/R*1/K */
    const double t94 = JLT_FMA(p[33], t48, t93); /* I1*I3*a3/m*omega_tau*1/(Theta/m) + v_nu*2*R^2*I3*b/R*1/K */
    const double t95 = p[35]*t48; /* R^2*I1*I3*(I1 - I3)/m*omega_tau*1/(Theta/m) */
    const double t96 = p[17]*t25; /* R*I3*b/R*1/K */
    const double t97 = JLT_FMA(x[3], t96, t35); /* v_tau*R*I3*b/R*1/K + 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[8] = t97;
    const double t98 = t44*t96; /* (v_nu - V*I1*I3/m*1/(Theta/m))*R*I3*b/R*1/K */
    const double t99 = JLT_FMA(t27, t63, t98); /* s*1/K*t63 + (v_nu - V*I1*I3/m*1/(Theta/m))*R*I3*b/R*1/K */
    const double t100 = -t99; /* -(s*1/K*t63 + (v_nu - V*I1*I3/m*1/(Theta/m))*R*I3*b/R*1/K) */
    out[18] = t100;
    const double t101 = t44*t80; /* (v_nu - V*I1*I3/m*1/(Theta/m))*R*G*1/K */
    const double t102 = JLT_FMS(t27, t85, t101); /* s*1/K*t85 - (v_nu - V*I1*I3/m*1/(Theta/m))*R*G*1/K */
    const double t103 = JLT_FNMA(t79, t89, t102); /* s*1/K*t85 - (v_nu - V*I1*I3/m*1/(Theta/m))*R*G*1/K - (1/K*(s*v_tau - G/I1*b/R) + v_tau*s*1/K)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m) */
    out[19] = t103;
    const double t104 = p[30]*t72; /* 4*R^2*I1*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t105 = JLT_FMA(t76, t104, t78); /* (s*1/(D/I1)*1/2*m*I3*a3^2/(R*I1^2)*(s*v_tau - G/I1*b/R) + t68)*4*R^2*I1*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) + t41 - (2/I1 - 2*m*a3^2/I1^2*s*s*1/(D/I1))*m*g*a3*s*1/(D/I1) */
    const double t106 = JLT_FMA(t50, t81, t105); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*t81 + t105 */
    const double t107 = JLT_FNMA(t71, t80, t106); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*t81 + t105 - t71*R*G*1/K */
    out[14] = t107;
    const double t108 = x[4]*t72; /* s*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t109 = JLT_FMA(t25, t71, t108); /* b/R*1/K*t71 + s*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t110 = p[26]*t109; /* (-R*I3)*(b/R*1/K*t71 + s*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)) */
    out[13] = t110;
    const double t111 = p[34]*t25; /* 2*R^2*I1*I3^2/m*b/R*1/K */
    const double t112 = JLT_FNMA(t62, t111, t88); /* t88 - 1/(Theta/m)*t37*(1/(Theta/m) + 1/K)*2*R^2*I1*I3^2/m*b/R*1/K */
    const double t113 = JLT_FNMA(t42, t95, t112); /* t112 - (s*v_tau - G/I1*b/R)*s*1/K*R^2*I1*I3*(I1 - I3)/m*omega_tau*1/(Theta/m) */
    const double t114 = JLT_FMA(t35, t94, t113); /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*(I1*I3*a3/m*omega_tau*1/(Theta/m) + v_nu*2*R^2*I3*b/R*1/K) + t113 */
    out[15] = t114;
    const double t115 = p[22]*t25; /* 4*R^2*I3*b/R*1/K */
    const double t116 = JLT_FMS(t68, t115, t35); /* t68*4*R^2*I3*b/R*1/K - 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t117 = JLT_FMA(t50, t116, t74); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*(t68*4*R^2*I3*b/R*1/K - 1/K*(b/R*v_tau*R*I3 + s*R*G)) + t73 - 1/K*v_tau*R*I3*t71 */
    out[10] = t117;
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
    const double t0 = p[19] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = x[4]*x[4]; /* s*s */
    out[7] = t1;
    const double t2 = p[9]*t1; /* R^2*I1*s*s */
    const double t3 = JLT_FMA(p[8], t1, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t4 = p[18]*t0; /* R^2*I3*b/R */
    const double t5 = JLT_FMA(t0, t4, t2); /* K = b/R*R^2*I3*b/R + R^2*I1*s*s */
    const double t6 = p[10] + t5; /* Theta/m = I1*I3/m + K */
    const double t7 = t3*t5; /* D/I1*K */
    const double t8 = t6*t7; /* Theta/m*D/I1*K */
    const double t9 = 1.0/t8; /* 1/(Theta/m*D/I1*K) */
    const double t10 = t6*t9; /* 1/(K*(D/I1)) = Theta/m*1/(Theta/m*D/I1*K) */
    const double t11 = t7*t9; /* 1/(Theta/m) = D/I1*K*1/(Theta/m*D/I1*K) */
    const double t12 = t3*t10; /* 1/K = D/I1*1/(K*(D/I1)) */
    const double t13 = t5*t10; /* 1/(D/I1) = K*1/(K*(D/I1)) */
    const double t14 = x[4]*p[7]; /* s*R*G */
    const double t15 = x[3]*p[17]; /* v_tau*R*I3 */
    const double t16 = JLT_FMA(t0, t15, t14); /* b/R*v_tau*R*I3 + s*R*G */
    const double t17 = t12*t16; /* 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t18 = x[3]*t17; /* v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[1] = t18;
    const double t19 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t20 = x[4]*x[2]; /* s*omega_tau */
    const double t21 = x[4]*t20; /* s*s*omega_tau */
    out[0] = t21;
    const double t22 = 2.0*t20; /* 2*s*omega_tau */
    out[9] = t22;
    const double t23 = -t20; /* -s*omega_tau */
    out[25] = t23;
    const double t24 = JLT_FMA(x[2], t19, x[1]); /* V = omega_tau*e + v_nu */
    const double t25 = x[0]*t20; /* gamma3*s*omega_tau */
    const double t26 = -t25; /* -gamma3*s*omega_tau */
    out[4] = t26;
    const double t27 = x[4]*t13; /* s*1/(D/I1) */
    const double t28 = x[4]*x[3]; /* s*v_tau */
    const double t29 = JLT_FNMA(p[23], t0, t28); /* s*v_tau - G/I1*b/R */
    const double t30 = p[10]*t24; /* I1*I3/m*V */
    const double t31 = JLT_FNMA(t11, t30, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t32 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t33 = t11*t32; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t34 = p[8]*t20; /* m*a3^2/I1*s*omega_tau */
    const double t35 = x[4]*t27; /* s*s*1/(D/I1) */
    const double t36 = x[4]*t12; /* s*1/K */
    const double t37 = p[25]*t25; /* 2*m*a3^2/I1*gamma3*s*omega_tau */
    const double t38 = t27*t37; /* s*1/(D/I1)*2*m*a3^2/I1*gamma3*s*omega_tau */
    out[17] = t38;
    const double t39 = t13*t37; /* 1/(D/I1)*2*m*a3^2/I1*gamma3*s*omega_tau */
    const double t40 = p[41]*t27; /* 2*m*g*a3/I1*s*1/(D/I1) */
    const double t41 = p[42]*t27; /* 2*m^2*g*a3^3/I1^2*s*1/(D/I1) */
    const double t42 = JLT_FMS(t35, t41, t40); /* s*s*1/(D/I1)*2*m^2*g*a3^3/I1^2*s*1/(D/I1) - 2*m*g*a3/I1*s*1/(D/I1) */
    const double t43 = t11*t17; /* 1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t44 = t24*t43; /* V*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t45 = x[2]*p[33]; /* omega_tau*I1*I3*a3/m */
    const double t46 = t43*t45; /* 1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G)*omega_tau*I1*I3*a3/m */
    const double t47 = p[10]*t43; /* I1*I3/m*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t48 = t19*t47; /* e*I1*I3/m*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t49 = t47 - t17; /* I1*I3/m*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) - 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[21] = t49;
    const double t50 = p[35]*t20; /* R^2*I1*I3*(I1 - I3)/m*s*omega_tau */
    const double t51 = t11*t50; /* 1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*s*omega_tau */
    const double t52 = t13*t34; /* 1/(D/I1)*m*a3^2/I1*s*omega_tau */
    const double t53 = JLT_FNMA(t27, t34, x[2]); /* omega_tau - s*1/(D/I1)*m*a3^2/I1*s*omega_tau */
    const double t54 = JLT_FMA(t39, t53, t42); /* 1/(D/I1)*2*m*a3^2/I1*gamma3*s*omega_tau*(omega_tau - s*1/(D/I1)*m*a3^2/I1*s*omega_tau) + t42 */
    const double t55 = t13*t17; /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t56 = 2.0*t13; /* 2*1/(D/I1) */
    const double t57 = x[0]*t17; /* gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t58 = t29*t36; /* (s*v_tau - G/I1*b/R)*s*1/K */
    const double t59 = t12*t29; /* 1/K*(s*v_tau - G/I1*b/R) */
    const double t60 = JLT_FNMA(t51, t59, t46); /* t46 - 1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*s*omega_tau*1/K*(s*v_tau - G/I1*b/R) */
    const double t61 = t20*t33; /* s*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t62 = t20*t52; /* s*omega_tau*1/(D/I1)*m*a3^2/I1*s*omega_tau */
    const double t63 = p[37]*t33; /* R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t64 = JLT_FNMA(t58, t63, t48); /* e*I1*I3/m*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) - (s*v_tau - G/I1*b/R)*s*1/K*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    out[22] = t64;
    const double t65 = x[2]*t63; /* omega_tau*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t66 = t0*t12; /* b/R*1/K */
    const double t67 = JLT_FMA(t0, t11, t66); /* b/R*1/(Theta/m) + b/R*1/K */
    const double t68 = JLT_FMA(x[4], t11, t36); /* s*1/(Theta/m) + s*1/K */
    const double t69 = p[34]*t67; /* 2*R^2*I1*I3^2/m*(b/R*1/(Theta/m) + b/R*1/K) */
    const double t70 = p[38]*t68; /* 2*R^2*I1^2*I3/m*(s*1/(Theta/m) + s*1/K) */
    const double t71 = JLT_FMA(t15, t66, t17); /* v_tau*R*I3*b/R*1/K + 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[13] = t71;
    const double t72 = p[7]*t12; /* R*G*1/K */
    const double t73 = t17*t36; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t74 = t15*t31; /* v_tau*R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t75 = JLT_FNMA(p[36], t61, t74); /* v_tau*R*I3*(v_nu - 1/(Theta/m)*I1*I3/m*V) - R*I3*G/m*s*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t76 = JLT_FNMA(t12, t75, t60); /* t60 - 1/K*t75 */
    const double t77 = t12*t15; /* 1/K*v_tau*R*I3 */
    const double t78 = JLT_FMA(p[17], t58, t57); /* R*I3*(s*v_tau - G/I1*b/R)*s*1/K + gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t79 = JLT_FMA(p[39], t58, t57); /* 1/2*R*I3*(s*v_tau - G/I1*b/R)*s*1/K + gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t80 = t56*t79; /* 2*1/(D/I1)*t79 */
    const double t81 = t55*t78; /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*t78 */
    const double t82 = JLT_FMS(t25, t52, t81); /* gamma3*s*omega_tau*1/(D/I1)*m*a3^2/I1*s*omega_tau - 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*t78 */
    const double t83 = JLT_FNMA(p[11], t35, t82); /* t82 - m*g*a3/I1*s*s*1/(D/I1) */
    out[2] = t83;
    const double t84 = p[20]*t66; /* 2*R^2*I3*b/R*1/K */
    const double t85 = t17*t84; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I3*b/R*1/K */
    const double t86 = JLT_FMA(x[1], t85, t76); /* v_nu*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I3*b/R*1/K + t60 - 1/K*t75 */
    const double t87 = t77 - t85; /* 1/K*v_tau*R*I3 - 1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I3*b/R*1/K */
    const double t88 = x[3]*t87; /* v_tau*t87 */
    out[10] = t88;
    const double t89 = p[21]*t73; /* 2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t90 = t27*t73; /* s*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t91 = JLT_FMA(p[40], t27, t36); /* 1/2*m*a3^2/(R^2*I1^2)*s*1/(D/I1) + s*1/K */
    const double t92 = p[30]*t91; /* 4*R^2*I1*(1/2*m*a3^2/(R^2*I1^2)*s*1/(D/I1) + s*1/K) */
    const double t93 = JLT_FMA(t66, t80, t90); /* b/R*1/K*2*1/(D/I1)*t79 + s*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t94 = p[26]*t93; /* (-R*I3)*t93 */
    out[18] = t94;
    const double t95 = JLT_FNMA(p[24], t36, t17); /* 1/K*(b/R*v_tau*R*I3 + s*R*G) - R*I3*G/I1*s*1/K */
    const double t96 = JLT_FNMA(t55, t95, t62); /* s*omega_tau*1/(D/I1)*m*a3^2/I1*s*omega_tau - 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*(1/K*(b/R*v_tau*R*I3 + s*R*G) - R*I3*G/I1*s*1/K) */
    const double t97 = p[17]*t55; /* R*I3*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t98 = t17*t31; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t99 = JLT_FMA(x[3], t36, t59); /* v_tau*s*1/K + 1/K*(s*v_tau - G/I1*b/R) */
    const double t100 = JLT_FNMA(t97, t99, t54); /* t54 - R*I3*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*(v_tau*s*1/K + 1/K*(s*v_tau - G/I1*b/R)) */
    const double t101 = JLT_FMA(t81, t92, t100); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*t78*4*R^2*I1*(1/2*m*a3^2/(R^2*I1^2)*s*1/(D/I1) + s*1/K) + t100 */
    const double t102 = JLT_FNMA(t72, t80, t101); /* t101 - R*G*1/K*2*1/(D/I1)*t79 */
    out[19] = t102;
    const double t103 = t59*t61; /* 1/K*(s*v_tau - G/I1*b/R)*s*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t104 = JLT_FMA(p[37], t103, t98); /* R*I1*I3/m*t103 + 1/K*(b/R*v_tau*R*I3 + s*R*G)*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t105 = JLT_FNMA(p[1], t103, t44); /* V*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) - R*t103 */
    const double t106 = JLT_FNMA(t69, t105, t86); /* t86 - 2*R^2*I1*I3^2/m*(b/R*1/(Theta/m) + b/R*1/K)*(V*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) - R*t103) */
    out[20] = t106;
    const double t107 = -t104; /* -t104 */
    out[3] = t107;
    const double t108 = p[43]*t61; /* (-R*I1*I3/m)*s*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t109 = t31*t72; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t110 = JLT_FMS(x[1], t89, t109); /* v_nu*2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K - (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t111 = JLT_FNMA(t65, t99, t110); /* t110 - omega_tau*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*(v_tau*s*1/K + 1/K*(s*v_tau - G/I1*b/R)) */
    const double t112 = JLT_FNMA(t70, t105, t111); /* t111 - 2*R^2*I1^2*I3/m*(s*1/(Theta/m) + s*1/K)*(V*1/(Theta/m)*1/K*(b/R*v_tau*R*I3 + s*R*G) - R*t103) */
    out[24] = t112;
    const double t113 = t72 - t89; /* R*G*1/K - 2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t114 = x[3]*t113; /* v_tau*(R*G*1/K - 2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[14] = t114;
    const double t115 = p[22]*t66; /* 4*R^2*I3*b/R*1/K */
    const double t116 = JLT_FMA(t81, t115, t96); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*t78*4*R^2*I3*b/R*1/K + t96 */
    const double t117 = JLT_FNMA(t77, t80, t116); /* t116 - 1/K*v_tau*R*I3*2*1/(D/I1)*t79 */
    out[15] = t117;
    const double t118 = p[26]*t66; /* (-R*I3)*b/R*1/K */
    const double t119 = t31*t118; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*(-R*I3)*b/R*1/K */
    const double t120 = JLT_FMA(t36, t108, t119); /* s*1/K*t108 + (v_nu - 1/(Theta/m)*I1*I3/m*V)*(-R*I3)*b/R*1/K */
    out[23] = t120;
    const double t121 = x[4]*x[0]; /* s*gamma3 */
    const double t122 = -t121; /* -s*gamma3 */
    out[27] = t122;
    const double t123 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t124 = -t123; /* -omega_tau*gamma3 */
    out[29] = t124;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[0] + p[19]; /* b/R = gamma3 + a3/R */
    const double t2 = p[12]*t1; /* I3/I1*b/R */
    const double t3 = JLT_FMA(t1, t2, t0); /* K/(R^2*I1) = b/R*I3/I1*b/R + s*s */
    const double t4 = t3 + p[45]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t5 = JLT_FMA(t0, p[27], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t3*t5; /* K/(R^2*I1)*D */
    const double t7 = t4*t6; /* Theta/(m*R^2*I1)*K/(R^2*I1)*D */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t9 = t4*t8; /* 1/(D*(K/(R^2*I1))) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t10 = x[0]*p[44]; /* gamma3*2*m*a3^2 */
    const double t11 = t3*t10; /* K/(R^2*I1)*gamma3*2*m*a3^2 */
    const double t12 = t9*t11; /* 1/(D*(K/(R^2*I1)))*K/(R^2*I1)*gamma3*2*m*a3^2 */
    const double t13 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t14 = t5*t8; /* 1/((K/(R^2*I1))*(Theta/(m*R^2*I1))) = D*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t15 = p[46]*t13; /* I3/(m*R^3*I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t16 = JLT_FNMA(t14, t15, t12); /* 1/(D*(K/(R^2*I1)))*K/(R^2*I1)*gamma3*2*m*a3^2 - 1/((K/(R^2*I1))*(Theta/(m*R^2*I1)))*I3/(m*R^3*I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t17 = JLT_FNMA(t0, t16, x[0]); /* gamma3 - s*s*t16 */
    const double t18 = p[47]*x[1]; /* I3/(R*I1)*v_nu */
    const double t19 = t1*t18; /* b/R*I3/(R*I1)*v_nu */
    const double t20 = t5*t19; /* D*b/R*I3/(R*I1)*v_nu */
    const double t21 = t9*t20; /* 1/(D*(K/(R^2*I1)))*D*b/R*I3/(R*I1)*v_nu */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = t1*p[48]; /* b/R*I3^2/(m*R^3*I1) */
    const double t25 = t23*t24; /* V*b/R*I3^2/(m*R^3*I1) */
    const double t26 = JLT_FMS(t14, t25, t21); /* 1/((K/(R^2*I1))*(Theta/(m*R^2*I1)))*V*b/R*I3^2/(m*R^3*I1) - 1/(D*(K/(R^2*I1)))*D*b/R*I3/(R*I1)*v_nu */
    const double t27 = JLT_FNMA(x[2], t17, t26); /* t26 - omega_tau*(gamma3 - s*s*t16) */
    out[0] = t27;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0] + p[19]; /* b/R = gamma3 + a3/R */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[12]*t0; /* I3/I1*b/R */
    const double t3 = JLT_FMA(t0, t2, t1); /* K/(R^2*I1) = b/R*I3/I1*b/R + s*s */
    const double t4 = JLT_FMA(p[27], t1, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t5 = p[45] + t3; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[50]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = t7/t3; /* (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t10 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/2*omega_tau */
    const double t12 = p[32]*x[0]; /* m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t4, t11, t12); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(p[49], t9, t13); /* 1/2*m*t9 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    out[0] = t14;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = x[4]*p[9]; /* s*R^2*I1 */
    const double t2 = p[19] + x[0]; /* b/R = a3/R + gamma3 */
    const double t3 = x[4]*t1; /* s*s*R^2*I1 */
    const double t4 = p[18]*t2; /* R^2*I3*b/R */
    const double t5 = JLT_FMA(t2, t4, t3); /* K = b/R*R^2*I3*b/R + s*s*R^2*I1 */
    const double t6 = p[52]*x[3]; /* I1*I3*v_tau */
    const double t7 = JLT_FMA(x[3], t6, p[51]); /* v_tau*I1*I3*v_tau + G^2 */
    const double t8 = 1.0/t5; /* 1/K */
    const double t9 = t7*t8; /* (v_tau*I1*I3*v_tau + G^2)*1/K */
    const double t10 = JLT_FMA(p[0], t5, p[52]); /* Theta = m*K + I1*I3 */
    const double t11 = t8*t9; /* 1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
    const double t12 = JLT_FNMA(t4, t11, p[32]); /* m*g*a3 - R^2*I3*b/R*1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
    out[0] = t12;
    const double t13 = x[3]*t10; /* v_tau*Theta */
    const double t14 = t8*t13; /* 1/K*v_tau*Theta */
    out[3] = t14;
    const double t15 = x[4]*p[27]; /* s*m*a3^2 */
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

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t18[k] = jlt_jet_product(x4, x4, k);
        t19[k] = p[1]*x0[k] + (k == 0 ? p[5] : 0);
        t20[k] = p[4]*t19[k];
        t21[k] = p[9]*t18[k];
        t22[k] = jlt_jet_product(t19, t20, k) + t21[k];
        t23[k] = p[8]*t18[k] + (k == 0 ? 1.0 : 0);
        t24[k] = (k == 0 ? p[10] : 0) + t22[k];
        t25[k] = jlt_jet_product(t22, t23, k);
        t26[k] = jlt_jet_product(t24, t25, k);
        t27[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t26, t27, k);
        t28[k] = jlt_jet_product(t24, t27, k);
        t29[k] = jlt_jet_product(t23, t28, k);
        t30[k] = jlt_jet_product(t22, t28, k);
        t31[k] = p[10]*t25[k];
        t32[k] = jlt_jet_product(t27, t31, k);
        t33[k] = jlt_jet_product(x4, x3, k);
        t34[k] = t33[k] - p[53]*t19[k];
        t35[k] = jlt_jet_product(x4, t34, k);
        t36[k] = jlt_jet_product(t29, t35, k);
        t37[k] = x4[k]*p[7];
        t38[k] = jlt_jet_product(x3, t20, k) + t37[k];
        t39[k] = jlt_jet_product(t29, t38, k);
        t40[k] = jlt_jet_product(x3, t39, k);
        t41[k] = jlt_jet_product(x2, x0, k);
        t42[k] = jlt_jet_product(x2, t18, k);
        t43[k] = p[8]*t41[k];
        t44[k] = jlt_jet_product(t42, t43, k);
        t45[k] = t44[k] - p[11]*t18[k];
        t46[k] = jlt_jet_product(x4, t41, k);
        t47[k] = -t46[k];
        t48[k] = p[5]*x0[k] + (k == 0 ? p[1] : 0);
        t49[k] = jlt_jet_product(x2, t48, k) + x1[k];
        t50[k] = jlt_jet_product(t39, t49, k);
        t51[k] = p[17]*t36[k];
        t52[k] = jlt_jet_product(x0, t39, k) + t51[k];
        t53[k] = t45[k] - jlt_jet_product(t39, t52, k);
        t54[k] = jlt_jet_product(t30, t53, k);
        t55[k] = jlt_jet_product(x1, t39, k);
        t56[k] = x0[k]*p[15] - (k == 0 ? p[16] : 0);
        t57[k] = x2[k]*p[1];
        t58[k] = jlt_jet_product(t56, t57, k);
        t59[k] = t50[k] - jlt_jet_product(t36, t58, k);
        t60[k] = jlt_jet_product(t32, t59, k) - t55[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t42[k]/(k + 1);
        next[1] = x1[k + 1] = t40[k]/(k + 1);
        next[2] = x2[k + 1] = t54[k]/(k + 1);
        next[3] = x3[k + 1] = t60[k]/(k + 1);
        next[4] = x4[k + 1] = t47[k]/(k + 1);
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
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
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
    .sha256 = "a03ac57982f08b300ad072746897d22dbcd0a4e4ebdedbf1bb5bf573f26d0de6",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 54,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 28, 13, 1, 0, 0, 13, 10 }, { 21, 82, 0, 8, 0, 0, 11, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, v_tau*s*(R*I1) - G*b, v_tau*I3*b + s*(R*G), e = a3*gamma3 + R, V = omega_tau*e + v_nu, gamma3*1/K*(v_tau*I3*b + s*(R*G)) + 1/K*(v_tau*s*(R*I1) - G*b)*s*(I3/I1), a part of d(omega_tau)/dtau, gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(v_tau)/dtau, d(v_tau)/dtau" },
    .jacobian = { jacobian, 25, { 8, 72, 37, 1, 0, 0, 16, 25 }, { 114, 577, 0, 55, 0, 0, 18, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, 2/I1 - (2*m*a3^2/I1^2)*s*s*1/(D/I1), b/R*v_tau*(R*I3) + s*(R*G), s*v_tau - (G/I1)*b/R, e = gamma3*a3 + R, V = omega_tau*e + v_nu, gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), v_nu - V*(I1*I3/m)*1/(Theta/m), d(d(v_tau)/dtau)/d(v_nu), d(d(v_tau)/dtau)/d(omega_tau), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), 1/K*(s*v_tau - (G/I1)*b/R) + v_tau*s*1/K, a part of d(d(omega_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(s), 1/K*v_tau*(R*I3) - 1/K*(b/R*v_tau*(R*I3) + s*(R*G))*(2*R^2*I3)*b/R*1/K, (I1*I3*a3/m)*omega_tau*1/(Theta/m) + v_nu*(2*R^2*I3)*b/R*1/K, d(d(v_nu)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(v_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 74, 40, 1, 0, 0, 15, 27 }, { 129, 644, 0, 63, 0, 0, 18, 12 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*v_tau*(R*I3) + s*(R*G), e = gamma3*a3 + R, V = omega_tau*e + v_nu, s*v_tau - (G/I1)*b/R, v_nu - 1/(Theta/m)*(I1*I3/m)*V, gamma3*(R*(I1 - I3)) - (I3*a3), d(d(v_tau)/dtau)/d(v_nu), omega_tau - s*1/(D/I1)*(m*a3^2/I1)*s*omega_tau, d(d(v_tau)/dtau)/d(omega_tau), d(d(v_nu)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(gamma3), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), d(omega_tau)/dtau, 1/K*v_tau*(R*I3) - 1/K*(b/R*v_tau*(R*I3) + s*(R*G))*(2*R^2*I3)*b/R*1/K, a part of d(d(omega_tau)/dtau)/d(v_tau), 1/K*(b/R*v_tau*(R*I3) + s*(R*G)) - (R*I3*G/I1)*s*1/K, v_tau*s*1/K + 1/K*(s*v_tau - (G/I1)*b/R), d(d(omega_tau)/dtau)/d(s), a part of d(v_tau)/dtau, a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(s), (R*G)*1/K - (2*R^2*I1)*1/K*(b/R*v_tau*(R*I3) + s*(R*G))*s*1/K, d(d(omega_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(v_tau)" },
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
