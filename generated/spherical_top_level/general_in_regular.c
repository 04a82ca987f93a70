/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   27   13    1    0    0     12   11   (111)
 *  jacobian            12   75   34    1    0    0     18   24   (746)
 *  rhs_jacobian        10   81   39    1    0    0     16   31   (836)
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
 *    digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*v_tau*(R*I3) + s*(R*G),
 *      s*v_tau - b/R*(G/I1), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s),
 *      numerator of d(omega_tau)/dt over D, e = gamma3*a3 + R, V = omega_tau*e + v_nu, v_nu - (I1*I3/m)*V*1/(Theta/m),
 *      gamma3*(R*(I1 - I3)) - (I3*a3),
 *      a part of d(v_tau)/dtau and of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s),
 *      d(d(v_nu)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(v_tau), d(d(v_nu)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s),
 *      d(numerator of d(omega_tau)/dt over D)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau),
 *      a part of d(d(omega_tau)/dtau)/d(s), d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(numerator of d(v_tau)/dt over K)/d(gamma3),
 *      d(d(v_tau)/dtau)/d(gamma3), d(numerator of d(v_tau)/dt over K)/d(v_nu),
 *      d(numerator of d(v_tau)/dt over K)/d(omega_tau), a part of d(d(v_tau)/dtau)/d(v_tau),
 *      a part of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(s)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_chart_spherical_top_level_5[];
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
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = t1*params[3]; /* R*R*I1 */
    out[8] = t2;
    const double t3 = params[3]*params[4]; /* I1*I3 */
    out[53] = t3;
    const double t4 = t3/params[0]; /* I1*I3/m */
    out[9] = t4;
    const double t5 = params[5]*params[5]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[34] = t6;
    const double t7 = t6/params[3]; /* m*a3*a3/I1 */
    out[10] = t7;
    const double t8 = params[1]*params[4]; /* R*I3 */
    out[11] = t8;
    const double t9 = params[1]*params[3]; /* R*I1 */
    const double t10 = params[6]/t9; /* G/(R*I1) */
    out[12] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    out[54] = t11;
    const double t12 = params[5]*t11; /* a3*m*g */
    out[35] = t12;
    const double t13 = t12/params[3]; /* a3*m*g/I1 */
    out[13] = t13;
    const double t14 = params[4]*t9; /* I3*R*I1 */
    out[37] = t14;
    const double t15 = t14/params[0]; /* I3*R*I1/m */
    out[14] = t15;
    const double t16 = params[3] - params[4]; /* I1 - I3 */
    const double t17 = params[1]*t16; /* R*(I1 - I3) */
    out[15] = t17;
    const double t18 = params[4]*params[5]; /* I3*a3 */
    out[16] = t18;
    const double t19 = t1*params[4]; /* R*R*I3 */
    out[17] = t19;
    const double t20 = params[5]/params[1]; /* a3/R */
    out[18] = t20;
    const double t21 = t1*2.0; /* R*R*2 */
    const double t22 = params[4]*t21; /* I3*R*R*2 */
    out[19] = t22;
    const double t23 = params[3]*t21; /* I1*R*R*2 */
    out[20] = t23;
    const double t24 = params[6]*t8; /* G*R*I3 */
    out[39] = t24;
    const double t25 = t24/params[3]; /* G*R*I3/I1 */
    out[21] = t25;
    const double t26 = t1*4.0; /* R*R*4 */
    const double t27 = params[4]*t26; /* I3*R*R*4 */
    out[22] = t27;
    const double t28 = params[6]/params[3]; /* G/I1 */
    out[23] = t28;
    const double t29 = params[0]*2.0; /* m*2 */
    const double t30 = t5*t29; /* a3*a3*m*2 */
    out[40] = t30;
    const double t31 = t30/params[3]; /* a3*a3*m*2/I1 */
    out[24] = t31;
    const double t32 = params[3]*t26; /* I1*R*R*4 */
    out[25] = t32;
    const double t33 = params[3]*params[3]; /* I1*I1 */
    const double t34 = t21*t33; /* R*R*2*I1*I1 */
    const double t35 = t12/t34; /* a3*m*g/(R*R*2*I1*I1) */
    out[26] = t35;
    const double t36 = t6/t34; /* m*a3*a3/(R*R*2*I1*I1) */
    out[27] = t36;
    const double t37 = params[1]*t1; /* R*R*R */
    const double t38 = 2.0*t37; /* 2*R*R*R */
    const double t39 = params[3]*t38; /* I1*2*R*R*R */
    const double t40 = params[4]*params[4]; /* I3*I3 */
    const double t41 = t39*t40; /* I1*2*R*R*R*I3*I3 */
    const double t42 = t41/params[0]; /* I1*2*R*R*R*I3*I3/m */
    out[28] = t42;
    const double t43 = 1.0/params[1]; /* 1/R */
    out[29] = t43;
    const double t44 = t3*params[5]; /* I1*I3*a3 */
    const double t45 = t44/params[0]; /* I1*I3*a3/m */
    out[30] = t45;
    const double t46 = t2*params[4]; /* R*R*I1*I3 */
    const double t47 = t16*t46; /* (I1 - I3)*R*R*I1*I3 */
    const double t48 = t47/params[0]; /* (I1 - I3)*R*R*I1*I3/m */
    out[31] = t48;
    const double t49 = t24/params[0]; /* G*R*I3/m */
    out[32] = t49;
    const double t50 = t33*t38; /* I1*I1*2*R*R*R */
    const double t51 = params[4]*t50; /* I3*I1*I1*2*R*R*R */
    const double t52 = t51/params[0]; /* I3*I1*I1*2*R*R*R/m */
    out[33] = t52;
    const double t53 = params[4]*t32; /* I3*I1*R*R*4 */
    out[36] = t53;
    const double t54 = 4.0*t37; /* 4*R*R*R */
    const double t55 = params[3]*t54; /* I1*4*R*R*R */
    const double t56 = t40*t55; /* I3*I3*I1*4*R*R*R */
    out[38] = t56;
    const double t57 = -t14; /* -I3*R*I1 */
    out[41] = t57;
    const double t58 = params[2]*t29; /* g*m*2 */
    const double t59 = params[5]*t58; /* a3*g*m*2 */
    out[42] = t59;
    const double t60 = params[6]*t9; /* G*R*I1 */
    out[43] = t60;
    const double t61 = t26*t33; /* R*R*4*I1*I1 */
    out[44] = t61;
    const double t62 = params[4]/params[3]; /* I3/I1 */
    out[45] = t62;
    const double t63 = t1*params[0]; /* R*R*m */
    const double t64 = params[4]/t63; /* I3/(R*R*m) */
    out[46] = t64;
    const double t65 = params[0]*t37; /* m*R*R*R */
    const double t66 = params[3]*t65; /* I1*m*R*R*R */
    const double t67 = params[4]/t66; /* I3/(I1*m*R*R*R) */
    out[47] = t67;
    const double t68 = params[4]/t9; /* I3/(R*I1) */
    out[48] = t68;
    const double t69 = t40/t66; /* I3*I3/(I1*m*R*R*R) */
    out[49] = t69;
    const double t70 = params[0]/2.0; /* m/2 */
    out[50] = t70;
    const double t71 = params[3]*t63; /* I1*R*R*m */
    const double t72 = params[6]*params[6]; /* G*G */
    out[52] = t72;
    const double t73 = t72/t71; /* G*G/(I1*R*R*m) */
    out[51] = t73;
    const double t74 = params[0]*params[5]; /* m*a3 */
    out[55] = t74;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t1;
    const double t2 = JLT_FMA(p[1], x[0], p[5]); /* b = R*gamma3 + a3 */
    const double t3 = p[4]*t2; /* I3*b */
    const double t4 = p[8]*t0; /* R^2*I1*s*s */
    const double t5 = JLT_FMA(t2, t3, t4); /* K = b*I3*b + R^2*I1*s*s */
    const double t6 = p[9] + t5; /* Theta/m = I1*I3/m + K */
    const double t7 = t5*t6; /* K*Theta/m */
    const double t8 = JLT_FMA(p[10], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t9 = t7*t8; /* K*Theta/m*D/I1 */
    const double t10 = 1.0/t9; /* 1/(K*Theta/m*D/I1) */
    const double t11 = t8*t10; /* 1/(K*(Theta/m)) = D/I1*1/(K*Theta/m*D/I1) */
    const double t12 = t7*t10; /* K*Theta/m*1/(K*Theta/m*D/I1) */
    const double t13 = t6*t11; /* 1/K = Theta/m*1/(K*(Theta/m)) */
    const double t14 = x[4]*x[3]; /* s*v_tau */
    const double t15 = JLT_FNMA(p[12], t2, t14); /* s*v_tau - G/(R*I1)*b */
    const double t16 = JLT_FMA(p[5], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t17 = JLT_FMA(x[2], t16, x[1]); /* V = omega_tau*e + v_nu */
    const double t18 = p[9]*t17; /* I1*I3/m*V */
    const double t19 = x[4]*p[7]; /* s*R*G */
    const double t20 = JLT_FMA(x[3], t3, t19); /* v_tau*I3*b + s*R*G */
    const double t21 = t18*t20; /* I1*I3/m*V*(v_tau*I3*b + s*R*G) */
    const double t22 = t11*t21; /* 1/(K*(Theta/m))*I1*I3/m*V*(v_tau*I3*b + s*R*G) */
    const double t23 = x[2]*x[4]; /* omega_tau*s */
    const double t24 = x[4]*p[11]; /* s*R*I3 */
    const double t25 = t15*t24; /* (s*v_tau - G/(R*I1)*b)*s*R*I3 */
    const double t26 = JLT_FMA(x[0], t20, t25); /* gamma3*(v_tau*I3*b + s*R*G) + (s*v_tau - G/(R*I1)*b)*s*R*I3 */
    const double t27 = t13*t20; /* 1/K*(v_tau*I3*b + s*R*G) */
    const double t28 = t13*t26; /* 1/K*(gamma3*(v_tau*I3*b + s*R*G) + (s*v_tau - G/(R*I1)*b)*s*R*I3) */
    const double t29 = x[3]*t27; /* v_tau*1/K*(v_tau*I3*b + s*R*G) */
    out[1] = t29;
    const double t30 = x[0]*t23; /* gamma3*omega_tau*s */
    const double t31 = -t30; /* -gamma3*omega_tau*s */
    out[4] = t31;
    const double t32 = p[10]*t23; /* m*a3^2/I1*omega_tau*s */
    const double t33 = t30*t32; /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s */
    const double t34 = JLT_FNMA(p[13], t0, t33); /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s - m*g*a3/I1*s*s */
    const double t35 = JLT_FNMA(t27, t28, t34); /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s - m*g*a3/I1*s*s - 1/K*(v_tau*I3*b + s*R*G)*t28 */
    const double t36 = t12*t35; /* K*Theta/m*1/(K*Theta/m*D/I1)*t35 */
    out[2] = t36;
    const double t37 = p[14]*t23; /* R*I1*I3/m*omega_tau*s */
    const double t38 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t39 = t37*t38; /* R*I1*I3/m*omega_tau*s*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t40 = t15*t39; /* (s*v_tau - G/(R*I1)*b)*R*I1*I3/m*omega_tau*s*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t41 = JLT_FNMA(t11, t40, t22); /* 1/(K*(Theta/m))*I1*I3/m*V*(v_tau*I3*b + s*R*G) - 1/(K*(Theta/m))*t40 */
    const double t42 = JLT_FNMA(x[1], t27, t41); /* t41 - v_nu*1/K*(v_tau*I3*b + s*R*G) */
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
    const double t3 = p[11]*x[3]; /* R*I3*v_tau */
    const double t4 = t0*p[8]; /* s*s*R^2*I1 */
    const double t5 = p[18] + x[0]; /* b/R = a3/R + gamma3 */
    const double t6 = p[17]*t5; /* R^2*I3*b/R */
    const double t7 = JLT_FMA(t5, t6, t4); /* K = b/R*R^2*I3*b/R + s*s*R^2*I1 */
    const double t8 = t7 + p[9]; /* Theta/m = K + I1*I3/m */
    const double t9 = JLT_FMA(t0, p[10], 1.0); /* s*s*m*a3^2/I1 + 1 */
    const double t10 = t7*t8; /* K*Theta/m */
    const double t11 = t9*t10; /* (s*s*m*a3^2/I1 + 1)*K*Theta/m */
    const double t12 = 1.0/t11; /* 1/((s*s*m*a3^2/I1 + 1)*K*Theta/m) */
    const double t13 = t9*t12; /* 1/(K*(Theta/m)) = (s*s*m*a3^2/I1 + 1)*1/((s*s*m*a3^2/I1 + 1)*K*Theta/m) */
    const double t14 = t8*t13; /* 1/K = Theta/m*1/(K*(Theta/m)) */
    const double t15 = x[3]*t14; /* v_tau*1/K */
    const double t16 = t3*t15; /* R*I3*v_tau*v_tau*1/K */
    const double t17 = t3*t5; /* R*I3*v_tau*b/R */
    const double t18 = JLT_FMA(x[4], p[7], t17); /* s*R*G + R*I3*v_tau*b/R */
    const double t19 = t14*t14; /* 1/K*1/K */
    const double t20 = t18*t19; /* (s*R*G + R*I3*v_tau*b/R)*1/K*1/K */
    const double t21 = p[19]*t20; /* 2*R^2*I3*(s*R*G + R*I3*v_tau*b/R)*1/K*1/K */
    const double t22 = x[3]*t5; /* v_tau*b/R */
    const double t23 = JLT_FNMA(t21, t22, t16); /* R*I3*v_tau*v_tau*1/K - 2*R^2*I3*(s*R*G + R*I3*v_tau*b/R)*1/K*1/K*v_tau*b/R */
    out[5] = t23;
    const double t24 = t17 + t18; /* R*I3*v_tau*b/R + s*R*G + R*I3*v_tau*b/R */
    const double t25 = t14*t24; /* 1/K*(R*I3*v_tau*b/R + s*R*G + R*I3*v_tau*b/R) */
    out[8] = t25;
    const double t26 = t15*p[7]; /* v_tau*1/K*R*G */
    const double t27 = t20*p[20]; /* (s*R*G + R*I3*v_tau*b/R)*1/K*1/K*2*R^2*I1 */
    const double t28 = x[4]*x[3]; /* s*v_tau */
    const double t29 = JLT_FNMA(t27, t28, t26); /* v_tau*1/K*R*G - (s*R*G + R*I3*v_tau*b/R)*1/K*1/K*2*R^2*I1*s*v_tau */
    out[9] = t29;
    const double t30 = t10*t12; /* 1/(D/I1) = K*Theta/m*1/((s*s*m*a3^2/I1 + 1)*K*Theta/m) */
    const double t31 = t0*x[2]; /* s*s*omega_tau */
    const double t32 = t30*t31; /* 1/(D/I1)*s*s*omega_tau */
    const double t33 = x[2]*p[10]; /* omega_tau*m*a3^2/I1 */
    const double t34 = t32*t33; /* 1/(D/I1)*s*s*omega_tau*omega_tau*m*a3^2/I1 */
    const double t35 = t20*t30; /* (s*R*G + R*I3*v_tau*b/R)*1/K*1/K*1/(D/I1) */
    const double t36 = x[0]*t18; /* gamma3*(s*R*G + R*I3*v_tau*b/R) */
    const double t37 = JLT_FNMA(t5, p[23], t28); /* s*v_tau - b/R*G/I1 */
    const double t38 = x[4]*t37; /* s*(s*v_tau - b/R*G/I1) */
    const double t39 = p[11]*t38; /* R*I3*s*(s*v_tau - b/R*G/I1) */
    const double t40 = t36 + t39; /* gamma3*(s*R*G + R*I3*v_tau*b/R) + R*I3*s*(s*v_tau - b/R*G/I1) */
    const double t41 = t5*p[22]; /* b/R*4*R^2*I3 */
    const double t42 = t40*t41; /* t40*b/R*4*R^2*I3 */
    const double t43 = JLT_FMS(x[4], p[21], t18); /* s*R*I3*G/I1 - (s*R*G + R*I3*v_tau*b/R) */
    const double t44 = JLT_FMA(t14, t42, t43); /* 1/K*t40*b/R*4*R^2*I3 + s*R*I3*G/I1 - (s*R*G + R*I3*v_tau*b/R) */
    const double t45 = JLT_FMA(2.0, t36, t39); /* 2*gamma3*(s*R*G + R*I3*v_tau*b/R) + R*I3*s*(s*v_tau - b/R*G/I1) */
    const double t46 = t30*t45; /* 1/(D/I1)*t45 */
    const double t47 = t19*t46; /* 1/K*1/K*1/(D/I1)*t45 */
    const double t48 = JLT_FNMA(t3, t47, t34); /* 1/(D/I1)*s*s*omega_tau*omega_tau*m*a3^2/I1 - R*I3*v_tau*1/K*1/K*1/(D/I1)*t45 */
    const double t49 = JLT_FMA(t35, t44, t48); /* (s*R*G + R*I3*v_tau*b/R)*1/K*1/K*1/(D/I1)*t44 + t48 */
    out[10] = t49;
    const double t50 = x[0]*p[24]; /* gamma3*2*m*a3^2/I1 */
    const double t51 = t32*t50; /* 1/(D/I1)*s*s*omega_tau*gamma3*2*m*a3^2/I1 */
    out[12] = t51;
    const double t52 = p[11]*t5; /* R*I3*b/R */
    const double t53 = p[11]*t35; /* R*I3*(s*R*G + R*I3*v_tau*b/R)*1/K*1/K*1/(D/I1) */
    const double t54 = t0*t53; /* s*s*R*I3*(s*R*G + R*I3*v_tau*b/R)*1/K*1/K*1/(D/I1) */
    const double t55 = JLT_FMA(t47, t52, t54); /* 1/K*1/K*1/(D/I1)*t45*R*I3*b/R + s*s*R*I3*(s*R*G + R*I3*v_tau*b/R)*1/K*1/K*1/(D/I1) */
    const double t56 = -t55; /* -t55 */
    out[13] = t56;
    const double t57 = x[2]*t7; /* omega_tau*K */
    const double t58 = t18*t18; /* (s*R*G + R*I3*v_tau*b/R)*(s*R*G + R*I3*v_tau*b/R) */
    const double t59 = JLT_FMA(t57, t57, t58); /* omega_tau*K*omega_tau*K + (s*R*G + R*I3*v_tau*b/R)*(s*R*G + R*I3*v_tau*b/R) */
    const double t60 = t7*p[27]; /* K*1/2*m*a3^2/(R^2*I1^2) */
    const double t61 = t59*t60; /* t59*K*1/2*m*a3^2/(R^2*I1^2) */
    const double t62 = JLT_FMA(t9, t58, t61); /* (s*s*m*a3^2/I1 + 1)*(s*R*G + R*I3*v_tau*b/R)*(s*R*G + R*I3*v_tau*b/R) + t59*K*1/2*m*a3^2/(R^2*I1^2) */
    const double t63 = x[0]*t62; /* gamma3*t62 */
    const double t64 = t14*t63; /* 1/K*gamma3*t62 */
    const double t65 = JLT_FNMA(t19, t64, p[26]); /* 1/2*m*g*a3/(R^2*I1^2) - 1/K*1/K*1/K*gamma3*t62 */
    const double t66 = x[4]*t30; /* s*1/(D/I1) */
    const double t67 = t30*t66; /* 1/(D/I1)*s*1/(D/I1) */
    const double t68 = t65*t67; /* (1/2*m*g*a3/(R^2*I1^2) - 1/K*1/K*1/K*gamma3*t62)*1/(D/I1)*s*1/(D/I1) */
    const double t69 = JLT_FMA(t30, p[27], t14); /* 1/(D/I1)*1/2*m*a3^2/(R^2*I1^2) + 1/K */
    const double t70 = t37*t69; /* (s*v_tau - b/R*G/I1)*(1/(D/I1)*1/2*m*a3^2/(R^2*I1^2) + 1/K) */
    const double t71 = JLT_FMS(t54, t70, t68); /* s*s*R*I3*(s*R*G + R*I3*v_tau*b/R)*1/K*1/K*1/(D/I1)*(s*v_tau - b/R*G/I1)*(1/(D/I1)*1/2*m*a3^2/(R^2*I1^2) + 1/K) - t68 */
    const double t72 = p[25]*t71; /* 4*R^2*I1*t71 */
    const double t73 = t28 + t37; /* s*v_tau + s*v_tau - b/R*G/I1 */
    const double t74 = JLT_FNMA(p[7], t47, t72); /* 4*R^2*I1*t71 - R*G*1/K*1/K*1/(D/I1)*t45 */
    const double t75 = JLT_FNMA(t53, t73, t74); /* 4*R^2*I1*t71 - R*G*1/K*1/K*1/(D/I1)*t45 - R*I3*(s*R*G + R*I3*v_tau*b/R)*1/K*1/K*1/(D/I1)*(s*v_tau + s*v_tau - b/R*G/I1) */
    out[14] = t75;
    const double t76 = t14*x[1]; /* 1/K*v_nu */
    const double t77 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t78 = JLT_FMA(x[2], t77, x[1]); /* V = omega_tau*e + v_nu */
    const double t79 = p[9]*t13; /* I1*I3/m*1/(K*(Theta/m)) */
    const double t80 = JLT_FNMA(t78, t79, t76); /* 1/K*v_nu - V*I1*I3/m*1/(K*(Theta/m)) */
    const double t81 = t21*x[1]; /* 2*R^2*I3*(s*R*G + R*I3*v_tau*b/R)*1/K*1/K*v_nu */
    const double t82 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t83 = t38*t82; /* s*(s*v_tau - b/R*G/I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t84 = x[2]*t83; /* omega_tau*s*(s*v_tau - b/R*G/I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t85 = t18*p[29]; /* (s*R*G + R*I3*v_tau*b/R)*1/R */
    const double t86 = JLT_FNMA(t78, t85, t84); /* t84 - V*(s*R*G + R*I3*v_tau*b/R)*1/R */
    const double t87 = t7*t13; /* 1/(Theta/m) = K*1/(K*(Theta/m)) */
    const double t88 = t14 + t87; /* 1/K + 1/(Theta/m) */
    const double t89 = t13*t86; /* 1/(K*(Theta/m))*(t84 - V*(s*R*G + R*I3*v_tau*b/R)*1/R) */
    const double t90 = t88*t89; /* (1/K + 1/(Theta/m))*1/(K*(Theta/m))*(t84 - V*(s*R*G + R*I3*v_tau*b/R)*1/R) */
    const double t91 = JLT_FMA(p[28], t90, t81); /* 2*R^3*I1*I3^2/m*t90 + 2*R^2*I3*(s*R*G + R*I3*v_tau*b/R)*1/K*1/K*v_nu */
    const double t92 = x[2]*t13; /* omega_tau*1/(K*(Theta/m)) */
    const double t93 = t18*p[30]; /* (s*R*G + R*I3*v_tau*b/R)*I1*I3*a3/m */
    const double t94 = t92*t93; /* omega_tau*1/(K*(Theta/m))*(s*R*G + R*I3*v_tau*b/R)*I1*I3*a3/m */
    const double t95 = t38*p[31]; /* s*(s*v_tau - b/R*G/I1)*R^2*I1*I3*(I1 - I3)/m */
    const double t96 = t82*t92; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(K*(Theta/m)) */
    const double t97 = x[4]*p[32]; /* s*R*I3*G/m */
    const double t98 = JLT_FNMA(t92, t95, t94); /* t94 - omega_tau*1/(K*(Theta/m))*s*(s*v_tau - b/R*G/I1)*R^2*I1*I3*(I1 - I3)/m */
    const double t99 = JLT_FMA(t96, t97, t98); /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(K*(Theta/m))*s*R*I3*G/m + t98 */
    const double t100 = JLT_FNMA(t3, t80, t99); /* t99 - R*I3*v_tau*(1/K*v_nu - V*I1*I3/m*1/(K*(Theta/m))) */
    const double t101 = JLT_FMA(t5, t91, t100); /* b/R*t91 + t99 - R*I3*v_tau*(1/K*v_nu - V*I1*I3/m*1/(K*(Theta/m))) */
    out[15] = t101;
    const double t102 = t18*t87; /* (s*R*G + R*I3*v_tau*b/R)*1/(Theta/m) */
    const double t103 = -t102; /* -(s*R*G + R*I3*v_tau*b/R)*1/(Theta/m) */
    out[16] = t103;
    const double t104 = t18*t77; /* (s*R*G + R*I3*v_tau*b/R)*e */
    const double t105 = t79*t104; /* I1*I3/m*1/(K*(Theta/m))*(s*R*G + R*I3*v_tau*b/R)*e */
    const double t106 = t83*p[14]; /* s*(s*v_tau - b/R*G/I1)*(gamma3*R*(I1 - I3) - I3*a3)*R*I1*I3/m */
    const double t107 = JLT_FNMA(t13, t106, t105); /* I1*I3/m*1/(K*(Theta/m))*(s*R*G + R*I3*v_tau*b/R)*e - 1/(K*(Theta/m))*t106 */
    out[17] = t107;
    const double t108 = t52*t80; /* R*I3*b/R*(1/K*v_nu - V*I1*I3/m*1/(K*(Theta/m))) */
    const double t109 = t96*p[14]; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(K*(Theta/m))*R*I1*I3/m */
    const double t110 = JLT_FMA(t0, t109, t108); /* s*s*t109 + R*I3*b/R*(1/K*v_nu - V*I1*I3/m*1/(K*(Theta/m))) */
    const double t111 = -t110; /* -(s*s*t109 + R*I3*b/R*(1/K*v_nu - V*I1*I3/m*1/(K*(Theta/m)))) */
    out[18] = t111;
    const double t112 = t73*t109; /* (s*v_tau + s*v_tau - b/R*G/I1)*t109 */
    const double t113 = t27*x[1]; /* (s*R*G + R*I3*v_tau*b/R)*1/K*1/K*2*R^2*I1*v_nu */
    const double t114 = JLT_FMA(t90, p[33], t113); /* t90*2*R^3*I1^2*I3/m + (s*R*G + R*I3*v_tau*b/R)*1/K*1/K*2*R^2*I1*v_nu */
    const double t115 = JLT_FMS(x[4], t114, t112); /* s*t114 - (s*v_tau + s*v_tau - b/R*G/I1)*t109 */
    const double t116 = JLT_FNMA(p[7], t80, t115); /* s*t114 - (s*v_tau + s*v_tau - b/R*G/I1)*t109 - R*G*(1/K*v_nu - V*I1*I3/m*1/(K*(Theta/m))) */
    out[19] = t116;
    const double t117 = -t1; /* -s*omega_tau */
    out[20] = t117;
    const double t118 = x[4]*x[0]; /* s*gamma3 */
    const double t119 = -t118; /* -s*gamma3 */
    out[22] = t119;
    const double t120 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t121 = -t120; /* -omega_tau*gamma3 */
    out[24] = t121;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = x[4]*p[7]; /* s*R*G */
    const double t3 = p[18] + x[0]; /* b/R = a3/R + gamma3 */
    const double t4 = x[3]*p[11]; /* v_tau*R*I3 */
    const double t5 = JLT_FMA(t3, t4, t2); /* b/R*v_tau*R*I3 + s*R*G */
    const double t6 = x[4]*x[4]; /* s*s */
    out[7] = t6;
    const double t7 = JLT_FMA(p[34], t6, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t8 = t6*p[8]; /* s*s*R^2*I1 */
    const double t9 = t3*p[17]; /* b/R*R^2*I3 */
    const double t10 = JLT_FMA(t3, t9, t8); /* K = b/R*b/R*R^2*I3 + s*s*R^2*I1 */
    const double t11 = t10 + p[9]; /* Theta/m = K + I1*I3/m */
    const double t12 = t7*t10; /* D*K */
    const double t13 = t11*t12; /* Theta/m*D*K */
    const double t14 = 1.0/t13; /* 1/(Theta/m*D*K) */
    const double t15 = t11*t14; /* 1/(K*D) = Theta/m*1/(Theta/m*D*K) */
    const double t16 = t7*t15; /* 1/K = D*1/(K*D) */
    const double t17 = t5*t16; /* (b/R*v_tau*R*I3 + s*R*G)*1/K */
    const double t18 = x[3]*t17; /* v_tau*(b/R*v_tau*R*I3 + s*R*G)*1/K */
    out[1] = t18;
    const double t19 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t20 = t0*p[34]; /* s*omega_tau*m*a3^2 */
    const double t21 = t19*t20; /* s*omega_tau*gamma3*s*omega_tau*m*a3^2 */
    const double t22 = p[3]*t17; /* I1*(b/R*v_tau*R*I3 + s*R*G)*1/K */
    const double t23 = x[0]*t17; /* gamma3*(b/R*v_tau*R*I3 + s*R*G)*1/K */
    const double t24 = x[4]*x[3]; /* s*v_tau */
    const double t25 = JLT_FNMA(t3, p[23], t24); /* s*v_tau - b/R*G/I1 */
    const double t26 = x[4]*t16; /* s*1/K */
    const double t27 = p[11]*t25; /* R*I3*(s*v_tau - b/R*G/I1) */
    const double t28 = t26*t27; /* s*1/K*R*I3*(s*v_tau - b/R*G/I1) */
    const double t29 = t23 + t28; /* gamma3*(b/R*v_tau*R*I3 + s*R*G)*1/K + s*1/K*R*I3*(s*v_tau - b/R*G/I1) */
    const double t30 = JLT_FNMA(t6, p[35], t21); /* s*omega_tau*gamma3*s*omega_tau*m*a3^2 - s*s*m*g*a3 */
    const double t31 = JLT_FNMA(t22, t29, t30); /* numerator of d(omega_tau)/dt over D = s*omega_tau*gamma3*s*omega_tau*m*a3^2 - s*s*m*g*a3 - I1*(b/R*v_tau*R*I3 + s*R*G)*1/K*t29 */
    const double t32 = t10*t15; /* 1/D = K*1/(K*D) */
    const double t33 = t31*t32; /* numerator of d(omega_tau)/dt over D*1/D */
    out[2] = t33;
    const double t34 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t35 = JLT_FMA(x[2], t34, x[1]); /* V = omega_tau*e + v_nu */
    const double t36 = t12*t14; /* 1/(Theta/m) = D*K*1/(Theta/m*D*K) */
    const double t37 = t35*t36; /* V*1/(Theta/m) */
    const double t38 = JLT_FNMA(p[9], t37, x[1]); /* v_nu - I1*I3/m*V*1/(Theta/m) */
    const double t39 = t5*t38; /* (b/R*v_tau*R*I3 + s*R*G)*(v_nu - I1*I3/m*V*1/(Theta/m)) */
    const double t40 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t41 = t36*t40; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t42 = t25*t41; /* (s*v_tau - b/R*G/I1)*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t43 = p[14]*t42; /* R*I1*I3/m*t42 */
    const double t44 = JLT_FMA(t0, t43, t39); /* s*omega_tau*R*I1*I3/m*t42 + (b/R*v_tau*R*I3 + s*R*G)*(v_nu - I1*I3/m*V*1/(Theta/m)) */
    const double t45 = t16*t44; /* 1/K*t44 */
    const double t46 = -t45; /* -1/K*t44 */
    out[3] = t46;
    const double t47 = -t19; /* -s*omega_tau*gamma3 */
    out[4] = t47;
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t48 = t0*2.0; /* s*omega_tau*2 */
    out[9] = t48;
    const double t49 = x[3]*t16; /* v_tau*1/K */
    const double t50 = t4*t49; /* v_tau*R*I3*v_tau*1/K */
    const double t51 = t3*t16; /* b/R*1/K */
    const double t52 = p[19]*t51; /* 2*R^2*I3*b/R*1/K */
    const double t53 = JLT_FNMA(t18, t52, t50); /* v_tau*R*I3*v_tau*1/K - v_tau*(b/R*v_tau*R*I3 + s*R*G)*1/K*2*R^2*I3*b/R*1/K */
    out[10] = t53;
    const double t54 = JLT_FMA(t4, t51, t17); /* v_tau*R*I3*b/R*1/K + (b/R*v_tau*R*I3 + s*R*G)*1/K */
    out[13] = t54;
    const double t55 = p[7]*t49; /* R*G*v_tau*1/K */
    const double t56 = t17*t26; /* (b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K */
    const double t57 = x[3]*t56; /* v_tau*(b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K */
    const double t58 = JLT_FNMA(p[20], t57, t55); /* R*G*v_tau*1/K - 2*R^2*I1*v_tau*(b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K */
    out[14] = t58;
    const double t59 = t0*t20; /* s*omega_tau*s*omega_tau*m*a3^2 */
    const double t60 = t51*p[36]; /* b/R*1/K*4*R^2*I1*I3 */
    const double t61 = JLT_FMS(t23, t60, t22); /* gamma3*(b/R*v_tau*R*I3 + s*R*G)*1/K*b/R*1/K*4*R^2*I1*I3 - I1*(b/R*v_tau*R*I3 + s*R*G)*1/K */
    const double t62 = JLT_FMA(t23, 2.0, t28); /* gamma3*(b/R*v_tau*R*I3 + s*R*G)*1/K*2 + s*1/K*R*I3*(s*v_tau - b/R*G/I1) */
    const double t63 = t49*p[37]; /* v_tau*1/K*R*I1*I3 */
    const double t64 = t25*p[38]; /* (s*v_tau - b/R*G/I1)*4*R^3*I1*I3^2 */
    const double t65 = t51*t64; /* b/R*1/K*(s*v_tau - b/R*G/I1)*4*R^3*I1*I3^2 */
    const double t66 = JLT_FMA(t56, t65, t59); /* (b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K*b/R*1/K*(s*v_tau - b/R*G/I1)*4*R^3*I1*I3^2 + s*omega_tau*s*omega_tau*m*a3^2 */
    const double t67 = JLT_FMA(t56, p[39], t66); /* (b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K*R*I3*G + t66 */
    const double t68 = JLT_FMA(t17, t61, t67); /* (b/R*v_tau*R*I3 + s*R*G)*1/K*t61 + (b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K*R*I3*G + t66 */
    const double t69 = JLT_FNMA(t62, t63, t68); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t68 - t62*v_tau*1/K*R*I1*I3 */
    const double t70 = t32*t69; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    out[15] = t70;
    const double t71 = x[4]*p[40]; /* s*2*m*a3^2 */
    const double t72 = t32*t71; /* 1/D*s*2*m*a3^2 */
    const double t73 = t19*t72; /* s*omega_tau*gamma3*1/D*s*2*m*a3^2 */
    out[17] = t73;
    const double t74 = x[4]*t56; /* s*(b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K */
    const double t75 = JLT_FMA(t51, t62, t74); /* b/R*1/K*t62 + s*(b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K */
    const double t76 = t32*p[41]; /* 1/D*(-R*I1*I3) */
    const double t77 = t75*t76; /* (b/R*1/K*t62 + s*(b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K)*1/D*(-R*I1*I3) */
    out[18] = t77;
    const double t78 = x[2]*p[40]; /* omega_tau*2*m*a3^2 */
    const double t79 = t19*t78; /* s*omega_tau*gamma3*omega_tau*2*m*a3^2 */
    const double t80 = t16*t25; /* 1/K*(s*v_tau - b/R*G/I1) */
    const double t81 = JLT_FMA(t17, t80, t57); /* (b/R*v_tau*R*I3 + s*R*G)*1/K*1/K*(s*v_tau - b/R*G/I1) + v_tau*(b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K */
    const double t82 = t16*p[43]; /* 1/K*R*I1*G */
    const double t83 = t56*p[44]; /* (b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K*4*R^2*I1^2 */
    const double t84 = JLT_FNMA(x[4], p[42], t79); /* s*omega_tau*gamma3*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t85 = JLT_FMA(t29, t83, t84); /* t29*(b/R*v_tau*R*I3 + s*R*G)*1/K*s*1/K*4*R^2*I1^2 + s*omega_tau*gamma3*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t86 = JLT_FNMA(p[37], t81, t85); /* t85 - R*I1*I3*t81 */
    const double t87 = JLT_FNMA(t62, t82, t86); /* d(numerator of d(omega_tau)/dt over D)/d(s) = t85 - R*I1*I3*t81 - t62*1/K*R*I1*G */
    const double t88 = t32*t87; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t89 = JLT_FNMA(t33, t72, t88); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) - numerator of d(omega_tau)/dt over D*1/D*1/D*s*2*m*a3^2 */
    out[19] = t89;
    const double t90 = t45*t52; /* 1/K*t44*2*R^2*I3*b/R*1/K */
    const double t91 = t5*t36; /* (b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m) */
    const double t92 = x[2]*p[30]; /* omega_tau*I1*I3*a3/m */
    const double t93 = t91*t92; /* (b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m)*omega_tau*I1*I3*a3/m */
    const double t94 = t0*t36; /* s*omega_tau*1/(Theta/m) */
    const double t95 = t42*t94; /* t42*s*omega_tau*1/(Theta/m) */
    const double t96 = t91*p[29]; /* (b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m)*1/R */
    const double t97 = JLT_FNMA(t37, t96, t95); /* t42*s*omega_tau*1/(Theta/m) - V*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m)*1/R */
    const double t98 = t3*p[28]; /* b/R*2*R^3*I1*I3^2/m */
    const double t99 = t25*p[31]; /* (s*v_tau - b/R*G/I1)*R^2*I1*I3*(I1 - I3)/m */
    const double t100 = t0*t41; /* s*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t101 = JLT_FNMA(t94, t99, t93); /* (b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m)*omega_tau*I1*I3*a3/m - s*omega_tau*1/(Theta/m)*(s*v_tau - b/R*G/I1)*R^2*I1*I3*(I1 - I3)/m */
    const double t102 = JLT_FMA(p[32], t100, t101); /* R*I3*G/m*s*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) + t101 */
    const double t103 = JLT_FNMA(t4, t38, t102); /* t102 - v_tau*R*I3*(v_nu - I1*I3/m*V*1/(Theta/m)) */
    const double t104 = JLT_FMA(t97, t98, t103); /* d(numerator of d(v_tau)/dt over K)/d(gamma3) = t97*b/R*2*R^3*I1*I3^2/m + t102 - v_tau*R*I3*(v_nu - I1*I3/m*V*1/(Theta/m)) */
    const double t105 = JLT_FMA(t16, t104, t90); /* 1/K*d(numerator of d(v_tau)/dt over K)/d(gamma3) + 1/K*t44*2*R^2*I3*b/R*1/K */
    out[20] = t105;
    const double t106 = p[9]*t91; /* I1*I3/m*(b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m) */
    const double t107 = t106 - t5; /* d(numerator of d(v_tau)/dt over K)/d(v_nu) = I1*I3/m*(b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m) - (b/R*v_tau*R*I3 + s*R*G) */
    const double t108 = t16*t107; /* 1/K*d(numerator of d(v_tau)/dt over K)/d(v_nu) */
    out[21] = t108;
    const double t109 = t34*t106; /* e*I1*I3/m*(b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m) */
    const double t110 = JLT_FNMA(x[4], t43, t109); /* d(numerator of d(v_tau)/dt over K)/d(omega_tau) = e*I1*I3/m*(b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m) - s*R*I1*I3/m*t42 */
    const double t111 = t16*t110; /* 1/K*d(numerator of d(v_tau)/dt over K)/d(omega_tau) */
    out[22] = t111;
    const double t112 = t3*p[11]; /* b/R*R*I3 */
    const double t113 = t38*t112; /* (v_nu - I1*I3/m*V*1/(Theta/m))*b/R*R*I3 */
    const double t114 = p[14]*t100; /* R*I1*I3/m*s*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t115 = JLT_FMA(x[4], t114, t113); /* s*t114 + (v_nu - I1*I3/m*V*1/(Theta/m))*b/R*R*I3 */
    const double t116 = t16*t115; /* 1/K*(s*t114 + (v_nu - I1*I3/m*V*1/(Theta/m))*b/R*R*I3) */
    const double t117 = -t116; /* -1/K*(s*t114 + (v_nu - I1*I3/m*V*1/(Theta/m))*b/R*R*I3) */
    out[23] = t117;
    const double t118 = x[2]*t43; /* omega_tau*R*I1*I3/m*t42 */
    const double t119 = x[4]*p[33]; /* s*2*R^3*I1^2*I3/m */
    const double t120 = JLT_FMA(x[3], t114, t118); /* v_tau*t114 + omega_tau*R*I1*I3/m*t42 */
    const double t121 = JLT_FMA(p[7], t38, t120); /* R*G*(v_nu - I1*I3/m*V*1/(Theta/m)) + v_tau*t114 + omega_tau*R*I1*I3/m*t42 */
    const double t122 = JLT_FNMA(t97, t119, t121); /* t121 - t97*s*2*R^3*I1^2*I3/m */
    const double t123 = t16*t122; /* 1/K*(t121 - t97*s*2*R^3*I1^2*I3/m) */
    const double t124 = t26*p[20]; /* s*1/K*2*R^2*I1 */
    const double t125 = JLT_FMS(t45, t124, t123); /* 1/K*t44*s*1/K*2*R^2*I1 - 1/K*(t121 - t97*s*2*R^3*I1^2*I3/m) */
    out[24] = t125;
    const double t126 = -t0; /* -s*omega_tau */
    out[25] = t126;
    const double t127 = x[4]*x[0]; /* s*gamma3 */
    const double t128 = -t127; /* -s*gamma3 */
    out[27] = t128;
    const double t129 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t130 = -t129; /* -omega_tau*gamma3 */
    out[29] = t130;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[0] + p[18]; /* b/R = gamma3 + a3/R */
    const double t2 = p[45]*t1; /* I3/I1*b/R */
    const double t3 = JLT_FMA(t1, t2, t0); /* K/(R^2*I1) = b/R*I3/I1*b/R + s*s */
    const double t4 = t3 + p[46]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t5 = JLT_FMA(t0, p[34], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t3*t5; /* K/(R^2*I1)*D */
    const double t7 = t4*t6; /* Theta/(m*R^2*I1)*K/(R^2*I1)*D */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t9 = t4*t8; /* 1/(D*(K/(R^2*I1))) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t10 = x[0]*p[40]; /* gamma3*2*m*a3^2 */
    const double t11 = t3*t10; /* K/(R^2*I1)*gamma3*2*m*a3^2 */
    const double t12 = t9*t11; /* 1/(D*(K/(R^2*I1)))*K/(R^2*I1)*gamma3*2*m*a3^2 */
    const double t13 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t14 = t5*t8; /* 1/((K/(R^2*I1))*(Theta/(m*R^2*I1))) = D*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t15 = p[47]*t13; /* I3/(m*R^3*I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t16 = JLT_FNMA(t14, t15, t12); /* 1/(D*(K/(R^2*I1)))*K/(R^2*I1)*gamma3*2*m*a3^2 - 1/((K/(R^2*I1))*(Theta/(m*R^2*I1)))*I3/(m*R^3*I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t17 = JLT_FNMA(t0, t16, x[0]); /* gamma3 - s*s*t16 */
    const double t18 = p[48]*x[1]; /* I3/(R*I1)*v_nu */
    const double t19 = t1*t18; /* b/R*I3/(R*I1)*v_nu */
    const double t20 = t5*t19; /* D*b/R*I3/(R*I1)*v_nu */
    const double t21 = t9*t20; /* 1/(D*(K/(R^2*I1)))*D*b/R*I3/(R*I1)*v_nu */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = t1*p[49]; /* b/R*I3^2/(m*R^3*I1) */
    const double t25 = t23*t24; /* V*b/R*I3^2/(m*R^3*I1) */
    const double t26 = JLT_FMS(t14, t25, t21); /* 1/((K/(R^2*I1))*(Theta/(m*R^2*I1)))*V*b/R*I3^2/(m*R^3*I1) - 1/(D*(K/(R^2*I1)))*D*b/R*I3/(R*I1)*v_nu */
    const double t27 = JLT_FNMA(x[2], t17, t26); /* t26 - omega_tau*(gamma3 - s*s*t16) */
    out[0] = t27;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0] + p[18]; /* b/R = gamma3 + a3/R */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[45]*t0; /* I3/I1*b/R */
    const double t3 = JLT_FMA(t0, t2, t1); /* K/(R^2*I1) = b/R*I3/I1*b/R + s*s */
    const double t4 = JLT_FMA(p[34], t1, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t5 = p[46] + t3; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[51]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = t7/t3; /* (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t10 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/2*omega_tau */
    const double t12 = p[35]*x[0]; /* m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t4, t11, t12); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(p[50], t9, t13); /* 1/2*m*t9 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    out[0] = t14;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = x[4]*p[8]; /* s*R^2*I1 */
    const double t2 = p[18] + x[0]; /* b/R = a3/R + gamma3 */
    const double t3 = x[4]*t1; /* s*s*R^2*I1 */
    const double t4 = p[17]*t2; /* R^2*I3*b/R */
    const double t5 = JLT_FMA(t2, t4, t3); /* K = b/R*R^2*I3*b/R + s*s*R^2*I1 */
    const double t6 = p[53]*x[3]; /* I1*I3*v_tau */
    const double t7 = JLT_FMA(x[3], t6, p[52]); /* v_tau*I1*I3*v_tau + G^2 */
    const double t8 = 1.0/t5; /* 1/K */
    const double t9 = t7*t8; /* (v_tau*I1*I3*v_tau + G^2)*1/K */
    const double t10 = JLT_FMA(p[0], t5, p[53]); /* Theta = m*K + I1*I3 */
    const double t11 = t8*t9; /* 1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
    const double t12 = JLT_FNMA(t4, t11, p[35]); /* m*g*a3 - R^2*I3*b/R*1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
    out[0] = t12;
    const double t13 = x[3]*t10; /* v_tau*Theta */
    const double t14 = t8*t13; /* 1/K*v_tau*Theta */
    out[3] = t14;
    const double t15 = x[4]*p[34]; /* s*m*a3^2 */
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
    const double t0 = x[4]*p[10]; /* s*m*a3^2/I1 */
    const double t1 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = p[4]*t1; /* I3*b */
    const double t4 = JLT_FMA(x[4], t0, 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t5 = p[8]*t2; /* R^2*I1*s*s */
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
    const double t29 = JLT_FNMA(p[55], t28, p[54]); /* contact_force = m*g - m*a3*(s*s*1/((D/I1)*s)*t27 + omega_tau*gamma3*omega_tau) */
    out[0] = t29;
}

static void valid_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*p[10]; /* s*m*a3^2/I1 */
    const double t1 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = p[4]*t1; /* I3*b */
    const double t4 = JLT_FMA(x[4], t0, 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t5 = p[8]*t2; /* R^2*I1*s*s */
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
    const double t29 = JLT_FNMA(p[55], t28, p[54]); /* contact_force = m*g - m*a3*(s*s*1/((D/I1)*s)*t27 + omega_tau*gamma3*omega_tau) */
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t19[k] = jlt_jet_product(x4, x4, k);
        t20[k] = p[1]*x0[k] + (k == 0 ? p[5] : 0);
        t21[k] = p[8]*t19[k];
        t22[k] = p[4]*t20[k];
        t23[k] = jlt_jet_product(t20, t22, k) + t21[k];
        t24[k] = jlt_jet_product(x4, x3, k);
        t25[k] = t24[k] - p[12]*t20[k];
        t26[k] = jlt_jet_product(x4, x2, k);
        t27[k] = jlt_jet_product(x4, t26, k);
        t28[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t23, t28, k);
        t29[k] = (k == 0 ? p[9] : 0) + t23[k];
        t30[k] = jlt_jet_product(t25, t28, k);
        t31[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t29, t31, k);
        t32[k] = x4[k]*p[7];
        t33[k] = jlt_jet_product(x3, t22, k) + t32[k];
        t34[k] = jlt_jet_product(t28, t33, k);
        t35[k] = jlt_jet_product(x3, t34, k);
        t36[k] = jlt_jet_product(x0, t26, k);
        t37[k] = -t36[k];
        t38[k] = p[10]*t26[k];
        t39[k] = jlt_jet_product(t36, t38, k);
        t40[k] = t39[k] - p[13]*t19[k];
        t41[k] = p[10]*t19[k] + (k == 0 ? 1.0 : 0);
        t42[k] = p[14]*t26[k];
        t43[k] = x4[k]*p[11];
        t44[k] = jlt_jet_product(t30, t43, k);
        t45[k] = jlt_jet_product(x0, t34, k) + t44[k];
        t46[k] = t40[k] - jlt_jet_product(t34, t45, k);
        t47[k] = jlt_jet_quotient(t46[k], t41, t47, k);
        t48[k] = p[5]*x0[k] + (k == 0 ? p[1] : 0);
        t49[k] = jlt_jet_product(x2, t48, k) + x1[k];
        t50[k] = p[9]*t49[k];
        t51[k] = x1[k] - jlt_jet_product(t31, t50, k);
        t52[k] = jlt_jet_product(t34, t51, k);
        t53[k] = x0[k]*p[15] - (k == 0 ? p[16] : 0);
        t54[k] = jlt_jet_product(t42, t53, k);
        t55[k] = jlt_jet_product(t31, t54, k);
        t56[k] = jlt_jet_product(t30, t55, k) + t52[k];
        t57[k] = -t56[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t27[k]/(k + 1);
        next[1] = x1[k + 1] = t35[k]/(k + 1);
        next[2] = x2[k + 1] = t47[k]/(k + 1);
        next[3] = x3[k + 1] = t57[k]/(k + 1);
        next[4] = x4[k + 1] = t37[k]/(k + 1);
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

/* Section turning: omega_tau = 0, in coordinates of the table spherical_top_section, SHA-256
 * bf5c565b976fefec01b0b9870e38f40c17511a13ec5354ac25e436f814722bac. */
static void section0_lift(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[1];
    out[2] = 0.0;
    const double t0 = params[7]*2.0; /* E*2 */
    const double t1 = params[0]*params[2]; /* m*g */
    const double t2 = t1*params[5]; /* m*g*a3 */
    const double t3 = x[1]*t2; /* gamma3*m*g*a3 */
    const double t4 = 2.0*t3; /* 2*gamma3*m*g*a3 */
    const double t5 = t0 - t4; /* E*2 - 2*gamma3*m*g*a3 */
    const double t6 = params[6]*params[6]; /* G*G */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = t7*params[3]; /* R*R*I1 */
    const double t9 = 1.0 - x[1]; /* 1 - gamma3 */
    const double t10 = x[1] + 1.0; /* gamma3 + 1 */
    const double t11 = t9*t10; /* (1 - gamma3)*(gamma3 + 1) */
    const double t12 = sqrt(t11); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[4] = t12;
    const double t13 = t12*t12; /* s*s */
    const double t14 = t8*t13; /* R*R*I1*s*s */
    const double t15 = x[1]*params[1]; /* gamma3*R */
    const double t16 = params[5] + t15; /* b = a3 + gamma3*R */
    const double t17 = t16*t16; /* b*b */
    const double t18 = params[4]*t17; /* I3*b*b */
    const double t19 = t14 + t18; /* K = R*R*I1*s*s + I3*b*b */
    const double t20 = t6/t19; /* G*G/K */
    const double t21 = t5 - t20; /* E*2 - 2*gamma3*m*g*a3 - G*G/K */
    const double t22 = t21/params[0]; /* (E*2 - 2*gamma3*m*g*a3 - G*G/K)/m */
    const double t23 = sqrt(t22); /* W = sqrt((E*2 - 2*gamma3*m*g*a3 - G*G/K)/m) */
    const double t24 = sin(x[0]); /* sin_eta = sin(eta) */
    const double t25 = t23*t24; /* W*sin_eta */
    out[1] = t25;
    const double t26 = params[0]*t19; /* m*K */
    const double t27 = params[3]*params[4]; /* I1*I3 */
    const double t28 = t26 + t27; /* Theta = m*K + I1*I3 */
    const double t29 = t26/t28; /* m*K/Theta */
    const double t30 = sqrt(t29); /* stretch = sqrt(m*K/Theta) */
    const double t31 = t23*t30; /* W*stretch */
    const double t32 = cos(x[0]); /* cos_eta = cos(eta) */
    const double t33 = t31*t32; /* W*stretch*cos_eta */
    out[3] = t33;
}

static void section0_lift_slopes(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = 0.0;
    out[2] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[12] = 0.0;
    out[14] = 0.0;
    out[1] = 1.0;
    const double t0 = params[7]*2.0; /* E*2 */
    const double t1 = params[0]*params[2]; /* m*g */
    const double t2 = t1*params[5]; /* m*g*a3 */
    const double t3 = t2*x[1]; /* m*g*a3*gamma3 */
    const double t4 = 2.0*t3; /* 2*m*g*a3*gamma3 */
    const double t5 = t0 - t4; /* E*2 - 2*m*g*a3*gamma3 */
    const double t6 = params[6]*params[6]; /* G*G */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = t7*params[3]; /* R*R*I1 */
    const double t9 = 1.0 - x[1]; /* 1 - gamma3 */
    const double t10 = 1.0 + x[1]; /* 1 + gamma3 */
    const double t11 = t9*t10; /* (1 - gamma3)*(1 + gamma3) */
    const double t12 = sqrt(t11); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t13 = t12*t12; /* s*s */
    const double t14 = t8*t13; /* R*R*I1*s*s */
    const double t15 = x[1]*params[1]; /* gamma3*R */
    const double t16 = params[5] + t15; /* b = a3 + gamma3*R */
    const double t17 = t16*t16; /* b*b */
    const double t18 = params[4]*t17; /* I3*b*b */
    const double t19 = t14 + t18; /* K = R*R*I1*s*s + I3*b*b */
    const double t20 = t6/t19; /* G*G/K */
    const double t21 = t5 - t20; /* E*2 - 2*m*g*a3*gamma3 - G*G/K */
    const double t22 = t21/params[0]; /* (E*2 - 2*m*g*a3*gamma3 - G*G/K)/m */
    const double t23 = sqrt(t22); /* W = sqrt((E*2 - 2*m*g*a3*gamma3 - G*G/K)/m) */
    const double t24 = cos(x[0]); /* cos_eta = cos(eta) */
    const double t25 = t23*t24; /* W*cos_eta */
    out[3] = t25;
    const double t26 = params[0]*t23; /* m*W */
    const double t27 = sin(x[0]); /* sin_eta = sin(eta) */
    const double t28 = t19*t19; /* K*K */
    const double t29 = x[1]*t8; /* gamma3*R*R*I1 */
    const double t30 = params[1]*params[4]; /* R*I3 */
    const double t31 = t16*t30; /* b*R*I3 */
    const double t32 = t29 - t31; /* gamma3*R*R*I1 - b*R*I3 */
    const double t33 = t6*t32; /* G*G*(gamma3*R*R*I1 - b*R*I3) */
    const double t34 = t33/t28; /* G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K) */
    const double t35 = t2 + t34; /* m*g*a3 + G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K) */
    const double t36 = t27*t35; /* sin_eta*(m*g*a3 + G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K)) */
    const double t37 = t36/t26; /* sin_eta*(m*g*a3 + G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K))/(m*W) */
    const double t38 = -t37; /* -sin_eta*(m*g*a3 + G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K))/(m*W) */
    out[4] = t38;
    const double t39 = t27/t26; /* sin_eta/(m*W) */
    out[5] = t39;
    const double t40 = params[0]*t19; /* m*K */
    const double t41 = params[3]*params[4]; /* I1*I3 */
    const double t42 = t40 + t41; /* Theta = m*K + I1*I3 */
    const double t43 = t40/t42; /* m*K/Theta */
    const double t44 = sqrt(t43); /* stretch = sqrt(m*K/Theta) */
    const double t45 = t23*t44; /* W*stretch */
    const double t46 = t27*t45; /* sin_eta*W*stretch */
    const double t47 = -t46; /* -sin_eta*W*stretch */
    out[9] = t47;
    const double t48 = t24*t44; /* cos_eta*stretch */
    const double t49 = t35*t48; /* (m*g*a3 + G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K))*cos_eta*stretch */
    const double t50 = t49/t26; /* t49/(m*W) */
    const double t51 = -t50; /* -t49/(m*W) */
    const double t52 = params[0]*t32; /* m*(gamma3*R*R*I1 - b*R*I3) */
    const double t53 = t52/t42; /* m*(gamma3*R*R*I1 - b*R*I3)/Theta */
    const double t54 = params[0]*params[0]; /* m*m */
    const double t55 = t19*t54; /* K*m*m */
    const double t56 = t42*t42; /* Theta*Theta */
    const double t57 = t32*t55; /* (gamma3*R*R*I1 - b*R*I3)*K*m*m */
    const double t58 = t57/t56; /* (gamma3*R*R*I1 - b*R*I3)*K*m*m/(Theta*Theta) */
    const double t59 = t53 - t58; /* m*(gamma3*R*R*I1 - b*R*I3)/Theta - (gamma3*R*R*I1 - b*R*I3)*K*m*m/(Theta*Theta) */
    const double t60 = t25*t59; /* W*cos_eta*t59 */
    const double t61 = t60/t44; /* W*cos_eta*t59/stretch */
    const double t62 = t51 - t61; /* -t49/(m*W) - W*cos_eta*t59/stretch */
    out[10] = t62;
    const double t63 = t48/t26; /* cos_eta*stretch/(m*W) */
    out[11] = t63;
    const double t64 = x[1]/t12; /* gamma3/s */
    const double t65 = -t64; /* -gamma3/s */
    out[13] = t65;
}

static void section0_region(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[7]*2.0; /* E*2 */
    const double t1 = params[0]*params[2]; /* m*g */
    const double t2 = t1*params[5]; /* m*g*a3 */
    const double t3 = t2*x[1]; /* m*g*a3*gamma3 */
    const double t4 = 2.0*t3; /* 2*m*g*a3*gamma3 */
    const double t5 = t0 - t4; /* E*2 - 2*m*g*a3*gamma3 */
    const double t6 = params[6]*params[6]; /* G*G */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = t7*params[3]; /* R*R*I1 */
    const double t9 = 1.0 - x[1]; /* 1 - gamma3 */
    const double t10 = 1.0 + x[1]; /* 1 + gamma3 */
    const double t11 = t9*t10; /* (1 - gamma3)*(1 + gamma3) */
    const double t12 = sqrt(t11); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t13 = t12*t12; /* s*s */
    const double t14 = t8*t13; /* R*R*I1*s*s */
    const double t15 = x[1]*params[1]; /* gamma3*R */
    const double t16 = params[5] + t15; /* b = a3 + gamma3*R */
    const double t17 = t16*t16; /* b*b */
    const double t18 = params[4]*t17; /* I3*b*b */
    const double t19 = t14 + t18; /* K = R*R*I1*s*s + I3*b*b */
    const double t20 = t6/t19; /* G*G/K */
    const double t21 = t5 - t20; /* E*2 - 2*m*g*a3*gamma3 - G*G/K */
    const double t22 = t21/params[0]; /* (E*2 - 2*m*g*a3*gamma3 - G*G/K)/m */
    out[0] = t22;
}

static void section0_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[1];
    out[3] = 1.0;
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = t1*t2; /* R*R*I1*s*s */
    out[2] = x[0];
    const double t4 = params[1]*x[0]; /* R*gamma3 */
    const double t5 = params[5] + t4; /* b = a3 + R*gamma3 */
    const double t6 = t5*t5; /* b*b */
    const double t7 = params[4]*t6; /* I3*b*b */
    const double t8 = t3 + t7; /* K = R*R*I1*s*s + I3*b*b */
    const double t9 = params[0]*t8; /* m*K */
    const double t10 = params[3]*params[4]; /* I1*I3 */
    const double t11 = t9 + t10; /* Theta = m*K + I1*I3 */
    const double t12 = t9/t11; /* m*K/Theta */
    const double t13 = sqrt(t12); /* stretch = sqrt(m*K/Theta) */
    const double t14 = x[3]/t13; /* v_tau/stretch */
    out[1] = t14;
}

static void section0_back_slopes(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = 0.0;
    out[1] = 1.0;
    out[10] = 1.0;
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = t1*t2; /* R*R*I1*s*s */
    const double t4 = params[1]*x[0]; /* R*gamma3 */
    const double t5 = params[5] + t4; /* b = a3 + R*gamma3 */
    const double t6 = t5*t5; /* b*b */
    const double t7 = params[4]*t6; /* I3*b*b */
    const double t8 = t3 + t7; /* K = R*R*I1*s*s + I3*b*b */
    const double t9 = params[0]*t8; /* m*K */
    const double t10 = params[3]*params[4]; /* I1*I3 */
    const double t11 = t9 + t10; /* Theta = m*K + I1*I3 */
    const double t12 = t9/t11; /* m*K/Theta */
    const double t13 = sqrt(t12); /* stretch = sqrt(m*K/Theta) */
    const double t14 = t13*t13; /* stretch*stretch */
    const double t15 = t13*t14; /* stretch*stretch*stretch */
    const double t16 = params[0]*params[1]; /* m*R */
    const double t17 = params[4]*t16; /* I3*m*R */
    const double t18 = t5*t17; /* b*I3*m*R */
    const double t19 = t18/t11; /* b*I3*m*R/Theta */
    const double t20 = params[0]*params[0]; /* m*m */
    const double t21 = params[1]*t20; /* R*m*m */
    const double t22 = params[4]*t21; /* I3*R*m*m */
    const double t23 = t5*t22; /* b*I3*R*m*m */
    const double t24 = t8*t23; /* K*b*I3*R*m*m */
    const double t25 = t11*t11; /* Theta*Theta */
    const double t26 = t24/t25; /* K*b*I3*R*m*m/(Theta*Theta) */
    const double t27 = t19 - t26; /* b*I3*m*R/Theta - K*b*I3*R*m*m/(Theta*Theta) */
    const double t28 = x[3]*t27; /* v_tau*(b*I3*m*R/Theta - K*b*I3*R*m*m/(Theta*Theta)) */
    const double t29 = t28/t15; /* v_tau*(b*I3*m*R/Theta - K*b*I3*R*m*m/(Theta*Theta))/(stretch*stretch*stretch) */
    const double t30 = -t29; /* -t29 */
    out[5] = t30;
    const double t31 = 1.0/t13; /* 1/stretch */
    out[8] = t31;
    const double t32 = params[0]*t0; /* m*R*R */
    const double t33 = params[3]*t32; /* I1*m*R*R */
    const double t34 = x[4]*t33; /* s*I1*m*R*R */
    const double t35 = t34/t11; /* s*I1*m*R*R/Theta */
    const double t36 = t0*t20; /* R*R*m*m */
    const double t37 = params[3]*t36; /* I1*R*R*m*m */
    const double t38 = x[4]*t37; /* s*I1*R*R*m*m */
    const double t39 = t8*t38; /* K*s*I1*R*R*m*m */
    const double t40 = t39/t25; /* K*s*I1*R*R*m*m/(Theta*Theta) */
    const double t41 = t35 - t40; /* s*I1*m*R*R/Theta - K*s*I1*R*R*m*m/(Theta*Theta) */
    const double t42 = x[3]*t41; /* v_tau*(s*I1*m*R*R/Theta - K*s*I1*R*R*m*m/(Theta*Theta)) */
    const double t43 = t42/t15; /* v_tau*(s*I1*m*R*R/Theta - K*s*I1*R*R*m*m/(Theta*Theta))/(stretch*stretch*stretch) */
    const double t44 = -t43; /* -t43 */
    out[9] = t44;
}

static void section0_beside_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[1];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = t1*t2; /* R*R*I1*s*s */
    const double t4 = params[1]*x[0]; /* R*gamma3 */
    const double t5 = params[5] + t4; /* b = a3 + R*gamma3 */
    const double t6 = t5*t5; /* b*b */
    const double t7 = params[4]*t6; /* I3*b*b */
    const double t8 = t3 + t7; /* K = R*R*I1*s*s + I3*b*b */
    const double t9 = params[1]*params[6]; /* R*G */
    const double t10 = x[4]*t9; /* s*R*G */
    const double t11 = params[4]*x[3]; /* I3*v_tau */
    const double t12 = t5*t11; /* b*I3*v_tau */
    const double t13 = t10 + t12; /* s*R*G + b*I3*v_tau */
    const double t14 = t13/t8; /* (s*R*G + b*I3*v_tau)/K */
    out[1] = t14;
    const double t15 = params[1]*params[3]; /* R*I1 */
    const double t16 = x[3]*t15; /* v_tau*R*I1 */
    const double t17 = x[4]*t16; /* s*v_tau*R*I1 */
    const double t18 = t5*params[6]; /* b*G */
    const double t19 = t17 - t18; /* s*v_tau*R*I1 - b*G */
    const double t20 = t19/t8; /* (s*v_tau*R*I1 - b*G)/K */
    out[2] = t20;
}

static const jlt_quantity section0_beside[] = {
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static void section0_ending_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[1];
    out[1] = x[2];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = t1*t2; /* R*R*I1*s*s */
    const double t4 = params[1]*x[0]; /* R*gamma3 */
    const double t5 = params[5] + t4; /* b = a3 + R*gamma3 */
    const double t6 = t5*t5; /* b*b */
    const double t7 = params[4]*t6; /* I3*b*b */
    const double t8 = t3 + t7; /* K = R*R*I1*s*s + I3*b*b */
    const double t9 = params[1]*params[3]; /* R*I1 */
    const double t10 = t9*x[3]; /* R*I1*v_tau */
    const double t11 = x[4]*t10; /* s*R*I1*v_tau */
    const double t12 = t5*params[6]; /* b*G */
    const double t13 = t11 - t12; /* s*R*I1*v_tau - b*G */
    const double t14 = t13/t8; /* (s*R*I1*v_tau - b*G)/K */
    out[2] = t14;
}

static const jlt_quantity section0_ending[] = {
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static void section0_turn(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[5]*x[1]; /* a3*gamma3 */
    out[0] = t0;
}

static const jlt_quantity section0_coordinates[] = {
    { "eta", "rad", "angle on the ellipse of energy", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 2.0*0x1.921fb54442d18p+1 },
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
};

static const unsigned char section0_is_angle[] = { 1, 0 };

static const jlt_quantity section0_levels[] = {
    { "E", "kg m^2/s^2", "energy", -INFINITY, INFINITY, JLT_ANY_SIGN, (43.0 / 20.0), 0.0 },
};

static const unsigned section0_integrals[] = { 0 };

static const double section0_start0[] = { (11.0 / 25.0), (-31.0 / 50.0) };
static const double section0_start1[] = { (1.0 / 10.0), (-3.0 / 5.0) };
static const double section0_start2[] = { 0.0, (-61.0 / 100.0) };
static const jlt_section_point section0_starts[] = {
    { "regular", section0_start0 },
    { "chaotic", section0_start1 },
    { "saddle", section0_start2 },
};

static const jlt_section_chart sections[] = {
    { .name = "turning", .chart = "spherical_top_section", .file = "spherical_top_section.tt",
      .sha256 = "bf5c565b976fefec01b0b9870e38f40c17511a13ec5354ac25e436f814722bac",
      .table = jlt_chart_spherical_top_level_5,
      .claim = 5, .column = 2, .level = 0.0,
      .coordinate_count = 2, .coordinates = section0_coordinates, .is_angle = section0_is_angle,
      .level_count = 1, .levels = section0_levels, .integrals = section0_integrals,
      .lift = section0_lift, .lift_slopes = section0_lift_slopes,
      .region_count = 1, .region = section0_region,
      .back = section0_back, .back_slopes = section0_back_slopes,
      .beside_count = 3, .beside = section0_beside, .beside_values = section0_beside_values,
      .ending_count = 3, .ending = section0_ending, .ending_values = section0_ending_values,
      .start_count = 3, .starts = section0_starts,
      .turn = section0_turn,
      .turn_meaning = "with a low centre of mass" },
};

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    out[3] = x[3];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[4] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = t1 + t2; /* -1 + gamma3*gamma3 + s*s */
    out[0] = t3;
}

static void root_relation_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = 2.0*x[0]; /* 2*gamma3 */
    out[0] = t0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
    const double t1 = 2.0*x[4]; /* 2*s */
    out[4] = t1;
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

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_general_in_regular = {
    .model = "spherical_top_level",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .scales = 1,
    .state_count = 5, .param_count = 7, .prepared_count = 56,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 27, 13, 1, 0, 0, 12, 11 }, { 21, 82, 0, 8, 0, 0, 11, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, s*v_tau - (G/(R*I1))*b, e = a3*gamma3 + R, V = omega_tau*e + v_nu, v_tau*I3*b + s*(R*G), gamma3*(v_tau*I3*b + s*(R*G)) + (s*v_tau - (G/(R*I1))*b)*s*(R*I3), a part of d(omega_tau)/dtau, gamma3*(R*(I1 - I3)) - (I3*a3), d(v_tau)/dtau" },
    .jacobian = { jacobian, 25, { 12, 75, 34, 1, 0, 0, 18, 24 }, { 114, 577, 0, 55, 0, 0, 18, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, s*(R*G) + (R*I3)*v_tau*b/R, d(d(v_nu)/dtau)/d(gamma3), (R*I3)*v_tau*b/R + s*(R*G) + (R*I3)*v_tau*b/R, d(d(v_nu)/dtau)/d(s), s*v_tau - b/R*(G/I1), gamma3*(s*(R*G) + (R*I3)*v_tau*b/R) + (R*I3)*s*(s*v_tau - b/R*(G/I1)), a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), s*v_tau + s*v_tau - b/R*(G/I1), d(d(omega_tau)/dtau)/d(s), e = gamma3*a3 + R, V = omega_tau*e + v_nu, 1/K*v_nu - V*(I1*I3/m)*1/(K*(Theta/m)), gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(omega_tau), a part of d(d(v_tau)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 81, 39, 1, 0, 0, 16, 31 }, { 129, 644, 0, 63, 0, 0, 18, 12 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*v_tau*(R*I3) + s*(R*G), s*v_tau - b/R*(G/I1), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), numerator of d(omega_tau)/dt over D, e = gamma3*a3 + R, V = omega_tau*e + v_nu, v_nu - (I1*I3/m)*V*1/(Theta/m), gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(v_tau)/dtau and of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(v_tau), d(d(v_nu)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), d(numerator of d(omega_tau)/dt over D)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), a part of d(d(omega_tau)/dtau)/d(s), d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(numerator of d(v_tau)/dt over K)/d(gamma3), d(d(v_tau)/dtau)/d(gamma3), d(numerator of d(v_tau)/dt over K)/d(v_nu), d(numerator of d(v_tau)/dt over K)/d(omega_tau), a part of d(d(v_tau)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(s)" },
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
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .observe_count = 1, .observes = observes,
    .valid_count = 1, .valids = valids,
    .pole_count = 1, .poles = poles,
    .section_count = 1, .sections = sections,
    .lifted = lifted,
    .tier = "level", .tier_meaning = "four states on a level of G, in coordinates that divide by nothing small",
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_level_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_level_general_in_regular) },
#endif
};
