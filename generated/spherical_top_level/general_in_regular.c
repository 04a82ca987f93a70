/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 354294165bef88c837abd694874137bb7226933952335bdf43bb9a6a47b2a4af
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   28   14    1    0    0     11   11   (111)
 *  jacobian            8   72   36    1    0    0     15   25   (746)
 *  rhs_jacobian        10   81   39    1    0    0     15   30   (836)
 *  divergence          2   16    9    1    0    0     11    8   (56)
 *  integral_values     2    6    6    1    0    0      8    5   (37)
 *  integral_gradients  1   13    6    1    0    0      7    6   (75)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  observe_values      0   16    9    1    0    0     11    6   (64)
 *  valid_values        0   16    9    1    0    0     11    6   (64)
 *
 *  Accuracy
 *    divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*v_tau*(R*I3) + s*(R*G),
 *      s*v_tau - (G/I1)*b/R, gamma3*(R*(I1 - I3)) - (I3*a3), e = gamma3*a3 + R, V = omega_tau*e + v_nu,
 *      d(d(v_nu)/dtau)/d(v_tau), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s),
 *      numerator of d(omega_tau)/dt over D, v_nu - (I1*I3/m)*1/(Theta/m)*V,
 *      a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(numerator of d(v_tau)/dt over K)/d(v_nu),
 *      a part of d(v_tau)/dtau and of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s),
 *      d(numerator of d(v_tau)/dt over K)/d(omega_tau), a part of d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau),
 *      a part of d(d(v_tau)/dtau)/d(v_tau), d(numerator of d(v_tau)/dt over K)/d(gamma3), d(d(v_tau)/dtau)/d(gamma3),
 *      d(d(v_nu)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(s),
 *      d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s),
 *      d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(d(v_nu)/dtau)/d(s)
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
    out[8] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = t3*params[3]; /* R*R*I1 */
    out[9] = t4;
    const double t5 = params[3]*params[4]; /* I1*I3 */
    out[10] = t5;
    const double t6 = params[1]*params[3]; /* R*I1 */
    out[58] = t6;
    const double t7 = params[4]*t6; /* I3*R*I1 */
    out[11] = t7;
    const double t8 = params[6]/t6; /* G/(R*I1) */
    out[12] = t8;
    const double t9 = params[0]*params[2]; /* m*g */
    out[55] = t9;
    const double t10 = params[5]*t9; /* a3*m*g */
    out[13] = t10;
    const double t11 = params[3] - params[4]; /* I1 - I3 */
    const double t12 = params[1]*t11; /* R*(I1 - I3) */
    out[14] = t12;
    const double t13 = params[5]*params[4]; /* a3*I3 */
    out[15] = t13;
    const double t14 = params[1]*params[4]; /* R*I3 */
    out[16] = t14;
    const double t15 = t2/params[3]; /* m*a3*a3/I1 */
    out[17] = t15;
    const double t16 = t3*params[4]; /* R*R*I3 */
    out[18] = t16;
    const double t17 = params[5]/params[1]; /* a3/R */
    out[19] = t17;
    const double t18 = t5/params[0]; /* I1*I3/m */
    out[20] = t18;
    const double t19 = t3*2.0; /* R*R*2 */
    const double t20 = params[4]*t19; /* I3*R*R*2 */
    out[21] = t20;
    const double t21 = params[3]*t19; /* I1*R*R*2 */
    out[22] = t21;
    const double t22 = t3*4.0; /* R*R*4 */
    const double t23 = params[4]*t22; /* I3*R*R*4 */
    out[23] = t23;
    const double t24 = params[6]/params[3]; /* G/I1 */
    out[24] = t24;
    const double t25 = params[6]*t14; /* G*R*I3 */
    out[41] = t25;
    const double t26 = t25/params[3]; /* G*R*I3/I1 */
    out[25] = t26;
    const double t27 = t14/2.0; /* R*I3/2 */
    out[26] = t27;
    const double t28 = params[0]*2.0; /* m*2 */
    const double t29 = t1*t28; /* a3*a3*m*2 */
    out[42] = t29;
    const double t30 = t29/params[3]; /* a3*a3*m*2/I1 */
    out[27] = t30;
    const double t31 = -t14; /* -R*I3 */
    out[28] = t31;
    const double t32 = 2.0/params[3]; /* 2/I1 */
    out[29] = t32;
    const double t33 = params[3]*params[3]; /* I1*I1 */
    const double t34 = t29/t33; /* a3*a3*m*2/(I1*I1) */
    out[30] = t34;
    const double t35 = params[3]*t22; /* I1*R*R*4 */
    out[31] = t35;
    const double t36 = params[4]*params[4]; /* I3*I3 */
    const double t37 = t21*t36; /* I1*R*R*2*I3*I3 */
    const double t38 = t37/params[0]; /* I1*R*R*2*I3*I3/m */
    out[32] = t38;
    const double t39 = params[5]*t5; /* a3*I1*I3 */
    const double t40 = t39/params[0]; /* a3*I1*I3/m */
    out[33] = t40;
    const double t41 = t4*params[4]; /* R*R*I1*I3 */
    const double t42 = t11*t41; /* (I1 - I3)*R*R*I1*I3 */
    const double t43 = t42/params[0]; /* (I1 - I3)*R*R*I1*I3/m */
    out[34] = t43;
    const double t44 = t25/params[0]; /* G*R*I3/m */
    out[35] = t44;
    const double t45 = t7/params[0]; /* I3*R*I1/m */
    out[36] = t45;
    const double t46 = -t7; /* -I3*R*I1 */
    out[43] = t46;
    const double t47 = -t45; /* -I3*R*I1/m */
    out[37] = t47;
    const double t48 = t19*t33; /* R*R*2*I1*I1 */
    const double t49 = params[4]*t48; /* I3*R*R*2*I1*I1 */
    const double t50 = t49/params[0]; /* I3*R*R*2*I1*I1/m */
    out[38] = t50;
    const double t51 = params[4]*t35; /* I3*I1*R*R*4 */
    out[39] = t51;
    const double t52 = params[1]*t3; /* R*R*R */
    const double t53 = 4.0*t52; /* 4*R*R*R */
    const double t54 = params[3]*t53; /* I1*4*R*R*R */
    const double t55 = t36*t54; /* I3*I3*I1*4*R*R*R */
    out[40] = t55;
    const double t56 = params[2]*t28; /* g*m*2 */
    const double t57 = params[5]*t56; /* a3*g*m*2 */
    out[44] = t57;
    const double t58 = params[6]*t6; /* G*R*I1 */
    out[45] = t58;
    const double t59 = t22*t33; /* R*R*4*I1*I1 */
    out[46] = t59;
    const double t60 = params[4]/params[3]; /* I3/I1 */
    out[47] = t60;
    const double t61 = params[0]*t3; /* m*R*R */
    const double t62 = params[4]/t61; /* I3/(m*R*R) */
    out[48] = t62;
    const double t63 = params[0]*t52; /* m*R*R*R */
    const double t64 = params[3]*t63; /* I1*m*R*R*R */
    const double t65 = params[4]/t64; /* I3/(I1*m*R*R*R) */
    out[49] = t65;
    const double t66 = params[4]/t6; /* I3/(R*I1) */
    out[50] = t66;
    const double t67 = t36/t64; /* I3*I3/(I1*m*R*R*R) */
    out[51] = t67;
    const double t68 = params[0]/2.0; /* m/2 */
    out[52] = t68;
    const double t69 = params[3]*t61; /* I1*m*R*R */
    const double t70 = params[6]*params[6]; /* G*G */
    out[54] = t70;
    const double t71 = t70/t69; /* G*G/(I1*m*R*R) */
    out[53] = t71;
    const double t72 = params[0]*params[3]; /* m*I1 */
    const double t73 = params[5]*t72; /* a3*m*I1 */
    out[56] = t73;
    const double t74 = t10/params[3]; /* a3*m*g/I1 */
    out[57] = t74;
    const double t75 = params[4]/params[0]; /* I3/m */
    out[59] = t75;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[5]); /* b = R*gamma3 + a3 */
    const double t2 = p[4]*t1; /* I3*b */
    const double t3 = p[9]*t0; /* R^2*I1*s*s */
    const double t4 = JLT_FMA(t1, t2, t3); /* K = b*I3*b + R^2*I1*s*s */
    const double t5 = JLT_FMA(p[8], t0, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t6 = JLT_FMA(p[0], t4, p[10]); /* Theta = m*K + I1*I3 */
    const double t7 = t4*t5; /* K*D */
    const double t8 = t6*t7; /* Theta*K*D */
    const double t9 = 1.0/t8; /* 1/(Theta*K*D) */
    const double t10 = t6*t9; /* 1/(K*D) = Theta*1/(Theta*K*D) */
    const double t11 = t5*t10; /* 1/K = D*1/(K*D) */
    const double t12 = t4*t10; /* K*1/(K*D) */
    const double t13 = JLT_FMA(p[5], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t14 = JLT_FMA(x[2], t13, x[1]); /* V = omega_tau*e + v_nu */
    const double t15 = p[10]*t14; /* I1*I3*V */
    const double t16 = x[4]*p[7]; /* s*R*G */
    const double t17 = JLT_FMA(x[3], t2, t16); /* v_tau*I3*b + s*R*G */
    const double t18 = t15*t17; /* I1*I3*V*(v_tau*I3*b + s*R*G) */
    const double t19 = x[4]*x[3]; /* s*v_tau */
    const double t20 = JLT_FNMA(p[12], t1, t19); /* s*v_tau - G/(R*I1)*b */
    const double t21 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t22 = x[4]*p[11]; /* s*R*I1*I3 */
    const double t23 = t20*t22; /* (s*v_tau - G/(R*I1)*b)*s*R*I1*I3 */
    const double t24 = JLT_FMS(x[0], p[14], p[15]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t25 = x[2]*t24; /* omega_tau*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t26 = JLT_FNMA(t23, t25, t18); /* I1*I3*V*(v_tau*I3*b + s*R*G) - (s*v_tau - G/(R*I1)*b)*s*R*I1*I3*omega_tau*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t27 = t7*t26; /* K*D*t26 */
    const double t28 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t28;
    const double t29 = p[8]*t21; /* m*a3^2*omega_tau*gamma3 */
    const double t30 = t28*t29; /* omega_tau*s*s*m*a3^2*omega_tau*gamma3 */
    const double t31 = JLT_FNMA(p[13], t0, t30); /* omega_tau*s*s*m*a3^2*omega_tau*gamma3 - m*g*a3*s*s */
    const double t32 = x[4]*t21; /* s*omega_tau*gamma3 */
    const double t33 = -t32; /* -s*omega_tau*gamma3 */
    out[4] = t33;
    const double t34 = x[0]*p[3]; /* gamma3*I1 */
    const double t35 = JLT_FMA(t17, t34, t23); /* (v_tau*I3*b + s*R*G)*gamma3*I1 + (s*v_tau - G/(R*I1)*b)*s*R*I1*I3 */
    const double t36 = t11*t35; /* 1/K*t35 */
    const double t37 = t11*t17; /* 1/K*(v_tau*I3*b + s*R*G) */
    const double t38 = JLT_FNMA(t36, t37, t31); /* numerator of d(omega_tau)/dt over D = omega_tau*s*s*m*a3^2*omega_tau*gamma3 - m*g*a3*s*s - 1/K*t35*1/K*(v_tau*I3*b + s*R*G) */
    const double t39 = t12*t38; /* K*1/(K*D)*numerator of d(omega_tau)/dt over D */
    out[2] = t39;
    const double t40 = x[3]*t37; /* v_tau*1/K*(v_tau*I3*b + s*R*G) */
    out[1] = t40;
    const double t41 = x[1]*t17; /* v_nu*(v_tau*I3*b + s*R*G) */
    const double t42 = JLT_FMS(t9, t27, t41); /* numerator of d(v_tau)/dt over K = 1/(Theta*K*D)*K*D*t26 - v_nu*(v_tau*I3*b + s*R*G) */
    const double t43 = t11*t42; /* 1/K*numerator of d(v_tau)/dt over K */
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
    const double t5 = JLT_FMA(p[17], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t6 = p[30]*t0; /* 2*m*a3^2/I1^2*s*s */
    const double t7 = p[20] + t4; /* Theta/m = I1*I3/m + K */
    const double t8 = t4*t5; /* K*D/I1 */
    const double t9 = t7*t8; /* Theta/m*K*D/I1 */
    const double t10 = 1.0/t9; /* 1/(Theta/m*K*D/I1) */
    const double t11 = t7*t10; /* 1/(K*(D/I1)) = Theta/m*1/(Theta/m*K*D/I1) */
    const double t12 = t8*t10; /* 1/(Theta/m) = K*D/I1*1/(Theta/m*K*D/I1) */
    const double t13 = t5*t11; /* 1/K = D/I1*1/(K*(D/I1)) */
    const double t14 = t4*t11; /* 1/(D/I1) = K*1/(K*(D/I1)) */
    const double t15 = JLT_FNMA(t6, t14, p[29]); /* 2/I1 - 2*m*a3^2/I1^2*s*s*1/(D/I1) */
    const double t16 = x[4]*x[2]; /* s*omega_tau */
    const double t17 = 2.0*t16; /* 2*s*omega_tau */
    out[4] = t17;
    const double t18 = -t16; /* -s*omega_tau */
    out[20] = t18;
    const double t19 = x[3]*p[16]; /* v_tau*R*I3 */
    const double t20 = x[4]*p[7]; /* s*R*G */
    const double t21 = JLT_FMA(t1, t19, t20); /* b/R*v_tau*R*I3 + s*R*G */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = x[4]*x[3]; /* s*v_tau */
    const double t24 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t25 = -t24; /* -omega_tau*gamma3 */
    out[24] = t25;
    const double t26 = p[8]*t24; /* m*a3^2*omega_tau*gamma3 */
    const double t27 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = JLT_FMS(x[0], p[14], p[15]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t29 = p[1]*t16; /* R*s*omega_tau */
    const double t30 = t28*t29; /* (gamma3*R*(I1 - I3) - I3*a3)*R*s*omega_tau */
    const double t31 = t13*t21; /* 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t32 = t21*t27; /* (b/R*v_tau*R*I3 + s*R*G)*V */
    const double t33 = t14*t16; /* 1/(D/I1)*s*omega_tau */
    const double t34 = t26*t33; /* m*a3^2*omega_tau*gamma3*1/(D/I1)*s*omega_tau */
    const double t35 = p[17]*t16; /* m*a3^2/I1*s*omega_tau */
    const double t36 = t15*t34; /* (2/I1 - 2*m*a3^2/I1^2*s*s*1/(D/I1))*m*a3^2*omega_tau*gamma3*1/(D/I1)*s*omega_tau */
    const double t37 = t33*t35; /* 1/(D/I1)*s*omega_tau*m*a3^2/I1*s*omega_tau */
    const double t38 = JLT_FNMA(p[24], t1, t23); /* s*v_tau - G/I1*b/R */
    const double t39 = JLT_FNMA(t30, t38, t32); /* (b/R*v_tau*R*I3 + s*R*G)*V - (gamma3*R*(I1 - I3) - I3*a3)*R*s*omega_tau*(s*v_tau - G/I1*b/R) */
    const double t40 = t23 + t38; /* s*v_tau + s*v_tau - G/I1*b/R */
    const double t41 = t12*t39; /* 1/(Theta/m)*t39 */
    const double t42 = t1*t13; /* b/R*1/K */
    const double t43 = t13*t40; /* 1/K*(s*v_tau + s*v_tau - G/I1*b/R) */
    const double t44 = JLT_FMA(t19, t42, t31); /* v_tau*R*I3*b/R*1/K + 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[8] = t44;
    const double t45 = t13*t19; /* 1/K*v_tau*R*I3 */
    const double t46 = p[20]*t12; /* I1*I3/m*1/(Theta/m) */
    const double t47 = JLT_FNMA(t27, t46, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t48 = t31*t46; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) */
    const double t49 = t22*t48; /* e*1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) */
    const double t50 = t48 - t31; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) - 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[16] = t50;
    const double t51 = x[4]*t13; /* s*1/K */
    const double t52 = t38*t51; /* (s*v_tau - G/I1*b/R)*s*1/K */
    const double t53 = t14*t31; /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t54 = x[4]*t14; /* s*1/(D/I1) */
    const double t55 = 2.0*t14; /* 2*1/(D/I1) */
    const double t56 = x[2]*t12; /* omega_tau*1/(Theta/m) */
    const double t57 = p[22]*t31; /* 2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t58 = x[0]*t31; /* gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t59 = t51*t53; /* s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t60 = JLT_FMA(p[25], t59, t37); /* R*I3*G/I1*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) + 1/(D/I1)*s*omega_tau*m*a3^2/I1*s*omega_tau */
    const double t61 = x[4]*x[0]; /* s*gamma3 */
    const double t62 = -t61; /* -s*gamma3 */
    out[22] = t62;
    const double t63 = p[27]*t61; /* 2*m*a3^2/I1*s*gamma3 */
    const double t64 = t33*t63; /* 1/(D/I1)*s*omega_tau*2*m*a3^2/I1*s*gamma3 */
    out[12] = t64;
    const double t65 = t53*t63; /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*m*a3^2/I1*s*gamma3 */
    const double t66 = p[13]*t54; /* m*g*a3*s*1/(D/I1) */
    const double t67 = JLT_FNMA(t15, t66, t36); /* t36 - (2/I1 - 2*m*a3^2/I1^2*s*s*1/(D/I1))*m*g*a3*s*1/(D/I1) */
    const double t68 = p[27]*t54; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t69 = JLT_FNMA(t52, t68, t43); /* 1/K*(s*v_tau + s*v_tau - G/I1*b/R) - (s*v_tau - G/I1*b/R)*s*1/K*2*m*a3^2/I1*s*1/(D/I1) */
    const double t70 = JLT_FNMA(p[16], t69, t65); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*m*a3^2/I1*s*gamma3 - R*I3*t69 */
    const double t71 = t45*t47; /* 1/K*v_tau*R*I3*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t72 = t12 + t13; /* 1/(Theta/m) + 1/K */
    const double t73 = t41*t72; /* 1/(Theta/m)*t39*(1/(Theta/m) + 1/K) */
    const double t74 = p[7]*t13; /* R*G*1/K */
    const double t75 = p[33]*t56; /* I1*I3*a3/m*omega_tau*1/(Theta/m) */
    const double t76 = JLT_FMS(t31, t75, t71); /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3*a3/m*omega_tau*1/(Theta/m) - 1/K*v_tau*R*I3*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t77 = t28*t56; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m) */
    const double t78 = p[34]*t56; /* R^2*I1*I3*(I1 - I3)/m*omega_tau*1/(Theta/m) */
    const double t79 = JLT_FNMA(t52, t78, t76); /* t76 - (s*v_tau - G/I1*b/R)*s*1/K*R^2*I1*I3*(I1 - I3)/m*omega_tau*1/(Theta/m) */
    const double t80 = p[36]*t28; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t81 = t12*t80; /* 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t82 = JLT_FNMA(t52, t81, t49); /* e*1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) - (s*v_tau - G/I1*b/R)*s*1/K*1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    out[17] = t82;
    const double t83 = p[21]*t31; /* 2*R^2*I3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t84 = JLT_FMA(p[16], t52, t58); /* R*I3*(s*v_tau - G/I1*b/R)*s*1/K + gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t85 = JLT_FMA(p[26], t52, t58); /* 1/2*R*I3*(s*v_tau - G/I1*b/R)*s*1/K + gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t86 = t55*t85; /* 2*1/(D/I1)*t85 */
    const double t87 = JLT_FNMA(t45, t86, t60); /* t60 - 1/K*v_tau*R*I3*2*1/(D/I1)*t85 */
    const double t88 = JLT_FNMA(t42, t83, t45); /* 1/K*v_tau*R*I3 - b/R*1/K*2*R^2*I3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t89 = x[3]*t88; /* v_tau*t88 */
    out[5] = t89;
    const double t90 = x[1]*t83; /* v_nu*2*R^2*I3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t91 = JLT_FNMA(p[32], t73, t90); /* v_nu*2*R^2*I3*1/K*(b/R*v_tau*R*I3 + s*R*G) - 2*R^2*I1*I3^2/m*1/(Theta/m)*t39*(1/(Theta/m) + 1/K) */
    const double t92 = p[31]*t59; /* 4*R^2*I1*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t93 = JLT_FMA(t84, t92, t67); /* t84*4*R^2*I1*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) + t36 - (2/I1 - 2*m*a3^2/I1^2*s*s*1/(D/I1))*m*g*a3*s*1/(D/I1) */
    const double t94 = x[4]*t59; /* s*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t95 = JLT_FMA(t42, t86, t94); /* b/R*1/K*2*1/(D/I1)*t85 + s*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t96 = JLT_FNMA(t74, t86, t93); /* t93 - R*G*1/K*2*1/(D/I1)*t85 */
    const double t97 = JLT_FMA(t53, t70, t96); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*t70 + t93 - R*G*1/K*2*1/(D/I1)*t85 */
    out[14] = t97;
    const double t98 = p[28]*t95; /* (-R*I3)*t95 */
    out[13] = t98;
    const double t99 = p[36]*t77; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m) */
    const double t100 = t43*t99; /* 1/K*(s*v_tau + s*v_tau - G/I1*b/R)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m) */
    const double t101 = t51*t77; /* s*1/K*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m) */
    const double t102 = JLT_FMA(p[35], t101, t79); /* R*I3*G/m*s*1/K*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m) + t79 */
    const double t103 = JLT_FMA(t42, t91, t102); /* b/R*1/K*t91 + t102 */
    out[15] = t103;
    const double t104 = x[1]*t57; /* v_nu*2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t105 = JLT_FNMA(p[38], t73, t104); /* v_nu*2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) - 2*R^2*I1^2*I3/m*1/(Theta/m)*t39*(1/(Theta/m) + 1/K) */
    const double t106 = JLT_FMS(t51, t105, t100); /* s*1/K*t105 - t100 */
    const double t107 = JLT_FNMA(t51, t57, t74); /* R*G*1/K - s*1/K*2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t108 = JLT_FNMA(t47, t74, t106); /* s*1/K*t105 - t100 - (v_nu - V*I1*I3/m*1/(Theta/m))*R*G*1/K */
    out[19] = t108;
    const double t109 = x[3]*t107; /* v_tau*(R*G*1/K - s*1/K*2*R^2*I1*1/K*(b/R*v_tau*R*I3 + s*R*G)) */
    out[9] = t109;
    const double t110 = p[23]*t42; /* 4*R^2*I3*b/R*1/K */
    const double t111 = JLT_FMS(t84, t110, t31); /* t84*4*R^2*I3*b/R*1/K - 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t112 = JLT_FMA(t53, t111, t87); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*(t84*4*R^2*I3*b/R*1/K - 1/K*(b/R*v_tau*R*I3 + s*R*G)) + t60 - 1/K*v_tau*R*I3*2*1/(D/I1)*t85 */
    out[10] = t112;
    const double t113 = p[28]*t42; /* (-R*I3)*b/R*1/K */
    const double t114 = t47*t113; /* (v_nu - V*I1*I3/m*1/(Theta/m))*(-R*I3)*b/R*1/K */
    const double t115 = x[4]*p[37]; /* s*(-R*I1*I3/m) */
    const double t116 = JLT_FMA(t101, t115, t114); /* s*1/K*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*1/(Theta/m)*s*(-R*I1*I3/m) + (v_nu - V*I1*I3/m*1/(Theta/m))*(-R*I3)*b/R*1/K */
    out[18] = t116;
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
    const double t3 = p[18]*t0; /* R^2*I3*b/R */
    const double t4 = JLT_FMA(t0, t3, t2); /* K = b/R*R^2*I3*b/R + R^2*I1*s*s */
    const double t5 = JLT_FMA(p[8], t1, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t6 = p[20] + t4; /* Theta/m = I1*I3/m + K */
    const double t7 = t4*t5; /* K*D */
    const double t8 = t6*t7; /* Theta/m*K*D */
    const double t9 = 1.0/t8; /* 1/(Theta/m*K*D) */
    const double t10 = t6*t9; /* 1/(K*D) = Theta/m*1/(Theta/m*K*D) */
    const double t11 = t7*t9; /* 1/(Theta/m) = K*D*1/(Theta/m*K*D) */
    const double t12 = t5*t10; /* 1/K = D*1/(K*D) */
    const double t13 = t4*t10; /* 1/D = K*1/(K*D) */
    const double t14 = x[4]*p[7]; /* s*R*G */
    const double t15 = x[3]*p[16]; /* v_tau*R*I3 */
    const double t16 = JLT_FMA(t0, t15, t14); /* b/R*v_tau*R*I3 + s*R*G */
    const double t17 = x[4]*x[3]; /* s*v_tau */
    const double t18 = JLT_FNMA(p[24], t0, t17); /* s*v_tau - G/I1*b/R */
    const double t19 = JLT_FMS(x[0], p[14], p[15]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t20 = x[4]*x[2]; /* s*omega_tau */
    const double t21 = x[4]*t20; /* s*s*omega_tau */
    out[0] = t21;
    const double t22 = 2.0*t20; /* 2*s*omega_tau */
    out[9] = t22;
    const double t23 = -t20; /* -s*omega_tau */
    out[25] = t23;
    const double t24 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t25 = p[36]*t19; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t26 = t11*t18; /* 1/(Theta/m)*(s*v_tau - G/I1*b/R) */
    const double t27 = t11*t16; /* 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t28 = x[2]*p[33]; /* omega_tau*I1*I3*a3/m */
    const double t29 = t27*t28; /* 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G)*omega_tau*I1*I3*a3/m */
    const double t30 = t12*t16; /* 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t31 = x[0]*t20; /* gamma3*s*omega_tau */
    const double t32 = -t31; /* -gamma3*s*omega_tau */
    out[4] = t32;
    const double t33 = p[8]*t20; /* m*a3^2*s*omega_tau */
    const double t34 = x[4]*t12; /* s*1/K */
    const double t35 = p[16]*t18; /* R*I3*(s*v_tau - G/I1*b/R) */
    const double t36 = t34*t35; /* s*1/K*R*I3*(s*v_tau - G/I1*b/R) */
    const double t37 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t38 = t11*t37; /* 1/(Theta/m)*V */
    const double t39 = t11*t20; /* 1/(Theta/m)*s*omega_tau */
    const double t40 = t19*t39; /* (gamma3*R*(I1 - I3) - I3*a3)*1/(Theta/m)*s*omega_tau */
    const double t41 = t25*t39; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*1/(Theta/m)*s*omega_tau */
    const double t42 = t25*t26; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*1/(Theta/m)*(s*v_tau - G/I1*b/R) */
    const double t43 = t0*t12; /* b/R*1/K */
    const double t44 = JLT_FMA(t15, t43, t30); /* v_tau*R*I3*b/R*1/K + 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[13] = t44;
    const double t45 = p[40]*t18; /* 4*R^3*I1*I3^2*(s*v_tau - G/I1*b/R) */
    const double t46 = t43*t45; /* b/R*1/K*4*R^3*I1*I3^2*(s*v_tau - G/I1*b/R) */
    const double t47 = t12*t18; /* 1/K*(s*v_tau - G/I1*b/R) */
    const double t48 = x[2]*p[42]; /* omega_tau*2*m*a3^2 */
    const double t49 = t31*t48; /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 */
    const double t50 = JLT_FNMA(x[4], p[44], t49); /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t51 = p[34]*t20; /* R^2*I1*I3*(I1 - I3)/m*s*omega_tau */
    const double t52 = JLT_FNMA(t26, t51, t29); /* 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G)*omega_tau*I1*I3*a3/m - 1/(Theta/m)*(s*v_tau - G/I1*b/R)*R^2*I1*I3*(I1 - I3)/m*s*omega_tau */
    const double t53 = p[1]*t26; /* R*1/(Theta/m)*(s*v_tau - G/I1*b/R) */
    const double t54 = JLT_FMA(p[35], t40, t52); /* R*I3*G/m*(gamma3*R*(I1 - I3) - I3*a3)*1/(Theta/m)*s*omega_tau + t52 */
    const double t55 = t31*t33; /* gamma3*s*omega_tau*m*a3^2*s*omega_tau */
    const double t56 = JLT_FNMA(p[13], t1, t55); /* gamma3*s*omega_tau*m*a3^2*s*omega_tau - m*g*a3*s*s */
    const double t57 = t20*t33; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t58 = x[0]*t30; /* gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t59 = t30*t34; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t60 = JLT_FMA(t46, t59, t57); /* b/R*1/K*4*R^3*I1*I3^2*(s*v_tau - G/I1*b/R)*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + s*omega_tau*m*a3^2*s*omega_tau */
    const double t61 = JLT_FMA(p[41], t59, t60); /* R*I3*G*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + t60 */
    const double t62 = p[22]*t34; /* 2*R^2*I1*s*1/K */
    const double t63 = x[2]*t42; /* omega_tau*t42 */
    const double t64 = JLT_FMA(x[3], t41, t63); /* v_tau*t41 + omega_tau*t42 */
    const double t65 = t36 + t58; /* s*1/K*R*I3*(s*v_tau - G/I1*b/R) + gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t66 = JLT_FMA(2.0, t58, t36); /* 2*gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) + s*1/K*R*I3*(s*v_tau - G/I1*b/R) */
    const double t67 = p[3]*t30; /* I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t68 = JLT_FNMA(t65, t67, t56); /* numerator of d(omega_tau)/dt over D = gamma3*s*omega_tau*m*a3^2*s*omega_tau - m*g*a3*s*s - t65*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t69 = t13*t68; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t69;
    const double t70 = JLT_FNMA(p[20], t38, x[1]); /* v_nu - I1*I3/m*1/(Theta/m)*V */
    const double t71 = t27*t38; /* 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m)*V */
    const double t72 = JLT_FNMA(t40, t53, t71); /* 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G)*1/(Theta/m)*V - (gamma3*R*(I1 - I3) - I3*a3)*1/(Theta/m)*s*omega_tau*R*1/(Theta/m)*(s*v_tau - G/I1*b/R) */
    const double t73 = JLT_FNMA(t15, t70, t54); /* t54 - v_tau*R*I3*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t74 = p[20]*t27; /* I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t75 = JLT_FMA(p[7], t70, t64); /* R*G*(v_nu - I1*I3/m*1/(Theta/m)*V) + v_tau*t41 + omega_tau*t42 */
    const double t76 = t24*t74; /* e*I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t77 = t74 - t16; /* d(numerator of d(v_tau)/dt over K)/d(v_nu) = I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) - (b/R*v_tau*R*I3 + s*R*G) */
    const double t78 = t12*t77; /* 1/K*d(numerator of d(v_tau)/dt over K)/d(v_nu) */
    out[21] = t78;
    const double t79 = t16*t70; /* (b/R*v_tau*R*I3 + s*R*G)*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t80 = JLT_FMA(t20, t42, t79); /* s*omega_tau*t42 + (b/R*v_tau*R*I3 + s*R*G)*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t81 = JLT_FNMA(x[4], t42, t76); /* d(numerator of d(v_tau)/dt over K)/d(omega_tau) = e*I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) - s*t42 */
    const double t82 = t12*t81; /* 1/K*d(numerator of d(v_tau)/dt over K)/d(omega_tau) */
    out[22] = t82;
    const double t83 = t12*t80; /* 1/K*t80 */
    const double t84 = -t83; /* -1/K*t80 */
    out[3] = t84;
    const double t85 = x[3]*t59; /* v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t86 = JLT_FMA(t30, t47, t85); /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*1/K*(s*v_tau - G/I1*b/R) + v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t87 = p[39]*t43; /* 4*R^2*I1*I3*b/R*1/K */
    const double t88 = JLT_FNMA(t58, t87, t67); /* I1*1/K*(b/R*v_tau*R*I3 + s*R*G) - gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G)*4*R^2*I1*I3*b/R*1/K */
    const double t89 = JLT_FNMA(t30, t88, t61); /* R*I3*G*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + t60 - 1/K*(b/R*v_tau*R*I3 + s*R*G)*t88 */
    const double t90 = x[3]*t30; /* v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[1] = t90;
    const double t91 = p[46]*t59; /* 4*R^2*I1^2*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t92 = JLT_FMA(t65, t91, t50); /* t65*4*R^2*I1^2*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t93 = JLT_FNMA(p[11], t86, t92); /* t92 - R*I1*I3*t86 */
    const double t94 = x[4]*t59; /* s*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t95 = JLT_FMA(t43, t66, t94); /* b/R*1/K*t66 + s*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t96 = p[21]*t43; /* 2*R^2*I3*b/R*1/K */
    const double t97 = p[16]*t0; /* R*I3*b/R */
    const double t98 = t70*t97; /* (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*b/R */
    const double t99 = JLT_FMA(x[4], t41, t98); /* s*t41 + (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*b/R */
    const double t100 = p[32]*t0; /* 2*R^2*I1*I3^2/m*b/R */
    const double t101 = JLT_FNMA(t72, t100, t73); /* d(numerator of d(v_tau)/dt over K)/d(gamma3) = t54 - v_tau*R*I3*(v_nu - I1*I3/m*1/(Theta/m)*V) - t72*2*R^2*I1*I3^2/m*b/R */
    const double t102 = t12*t101; /* 1/K*d(numerator of d(v_tau)/dt over K)/d(gamma3) */
    const double t103 = JLT_FMA(t83, t96, t102); /* 1/K*t80*2*R^2*I3*b/R*1/K + 1/K*d(numerator of d(v_tau)/dt over K)/d(gamma3) */
    out[20] = t103;
    const double t104 = t12*t99; /* 1/K*(s*t41 + (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*b/R) */
    const double t105 = -t104; /* -1/K*(s*t41 + (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*b/R) */
    out[23] = t105;
    const double t106 = x[3]*t12; /* v_tau*1/K */
    const double t107 = t15*t106; /* v_tau*R*I3*v_tau*1/K */
    const double t108 = JLT_FNMA(t90, t96, t107); /* v_tau*R*I3*v_tau*1/K - v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I3*b/R*1/K */
    out[10] = t108;
    const double t109 = x[4]*p[42]; /* s*2*m*a3^2 */
    const double t110 = t13*t109; /* 1/D*s*2*m*a3^2 */
    const double t111 = t31*t110; /* gamma3*s*omega_tau*1/D*s*2*m*a3^2 */
    out[17] = t111;
    const double t112 = t69*t110; /* 1/D*numerator of d(omega_tau)/dt over D*1/D*s*2*m*a3^2 */
    const double t113 = x[4]*p[38]; /* s*2*R^2*I1^2*I3/m */
    const double t114 = JLT_FMA(t72, t113, t75); /* t72*s*2*R^2*I1^2*I3/m + t75 */
    const double t115 = t12*t114; /* 1/K*(t72*s*2*R^2*I1^2*I3/m + t75) */
    const double t116 = JLT_FMS(t62, t83, t115); /* 2*R^2*I1*s*1/K*1/K*t80 - 1/K*(t72*s*2*R^2*I1^2*I3/m + t75) */
    out[24] = t116;
    const double t117 = p[45]*t12; /* R*I1*G*1/K */
    const double t118 = JLT_FNMA(t66, t117, t93); /* d(numerator of d(omega_tau)/dt over D)/d(s) = t92 - R*I1*I3*t86 - t66*R*I1*G*1/K */
    const double t119 = JLT_FMS(t13, t118, t112); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) - 1/D*numerator of d(omega_tau)/dt over D*1/D*s*2*m*a3^2 */
    out[19] = t119;
    const double t120 = p[11]*t106; /* R*I1*I3*v_tau*1/K */
    const double t121 = JLT_FNMA(t66, t120, t89); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t89 - t66*R*I1*I3*v_tau*1/K */
    const double t122 = t13*t121; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    out[15] = t122;
    const double t123 = p[7]*t106; /* R*G*v_tau*1/K */
    const double t124 = JLT_FNMA(p[22], t85, t123); /* R*G*v_tau*1/K - 2*R^2*I1*v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    out[14] = t124;
    const double t125 = p[43]*t13; /* (-R*I1*I3)*1/D */
    const double t126 = t95*t125; /* (b/R*1/K*t66 + s*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K)*(-R*I1*I3)*1/D */
    out[18] = t126;
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
    const double t1 = x[0] + p[19]; /* b/R = gamma3 + a3/R */
    const double t2 = p[47]*t1; /* I3/I1*b/R */
    const double t3 = JLT_FMA(t1, t2, t0); /* K/(R^2*I1) = b/R*I3/I1*b/R + s*s */
    const double t4 = t3 + p[48]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t5 = JLT_FMA(t0, p[8], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t3*t5; /* K/(R^2*I1)*D */
    const double t7 = t4*t6; /* Theta/(m*R^2*I1)*K/(R^2*I1)*D */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t9 = t4*t8; /* 1/(D*(K/(R^2*I1))) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t10 = x[0]*p[42]; /* gamma3*2*m*a3^2 */
    const double t11 = t3*t10; /* K/(R^2*I1)*gamma3*2*m*a3^2 */
    const double t12 = t9*t11; /* 1/(D*(K/(R^2*I1)))*K/(R^2*I1)*gamma3*2*m*a3^2 */
    const double t13 = JLT_FMS(x[0], p[14], p[15]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t14 = t5*t8; /* 1/((K/(R^2*I1))*(Theta/(m*R^2*I1))) = D*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t15 = p[49]*t13; /* I3/(m*R^3*I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t16 = JLT_FNMA(t14, t15, t12); /* 1/(D*(K/(R^2*I1)))*K/(R^2*I1)*gamma3*2*m*a3^2 - 1/((K/(R^2*I1))*(Theta/(m*R^2*I1)))*I3/(m*R^3*I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t17 = JLT_FNMA(t0, t16, x[0]); /* gamma3 - s*s*t16 */
    const double t18 = p[50]*x[1]; /* I3/(R*I1)*v_nu */
    const double t19 = t1*t18; /* b/R*I3/(R*I1)*v_nu */
    const double t20 = t5*t19; /* D*b/R*I3/(R*I1)*v_nu */
    const double t21 = t9*t20; /* 1/(D*(K/(R^2*I1)))*D*b/R*I3/(R*I1)*v_nu */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = t1*p[51]; /* b/R*I3^2/(m*R^3*I1) */
    const double t25 = t23*t24; /* V*b/R*I3^2/(m*R^3*I1) */
    const double t26 = JLT_FMS(t14, t25, t21); /* 1/((K/(R^2*I1))*(Theta/(m*R^2*I1)))*V*b/R*I3^2/(m*R^3*I1) - 1/(D*(K/(R^2*I1)))*D*b/R*I3/(R*I1)*v_nu */
    const double t27 = JLT_FNMA(x[2], t17, t26); /* t26 - omega_tau*(gamma3 - s*s*t16) */
    out[0] = t27;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0] + p[19]; /* b/R = gamma3 + a3/R */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[47]*t0; /* I3/I1*b/R */
    const double t3 = JLT_FMA(t0, t2, t1); /* K/(R^2*I1) = b/R*I3/I1*b/R + s*s */
    const double t4 = JLT_FMA(p[8], t1, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t5 = p[48] + t3; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[53]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = t7/t3; /* (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t10 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/2*omega_tau */
    const double t12 = p[13]*x[0]; /* m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t4, t11, t12); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(p[52], t9, t13); /* 1/2*m*t9 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
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
    const double t6 = p[10]*x[3]; /* I1*I3*v_tau */
    const double t7 = JLT_FMA(x[3], t6, p[54]); /* v_tau*I1*I3*v_tau + G^2 */
    const double t8 = 1.0/t5; /* 1/K */
    const double t9 = t7*t8; /* (v_tau*I1*I3*v_tau + G^2)*1/K */
    const double t10 = JLT_FMA(p[0], t5, p[10]); /* Theta = m*K + I1*I3 */
    const double t11 = t8*t9; /* 1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
    const double t12 = JLT_FNMA(t4, t11, p[13]); /* m*g*a3 - R^2*I3*b/R*1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
    out[0] = t12;
    const double t13 = x[3]*t10; /* v_tau*Theta */
    const double t14 = t8*t13; /* 1/K*v_tau*Theta */
    out[3] = t14;
    const double t15 = x[4]*p[8]; /* s*m*a3^2 */
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
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[5]); /* b = R*gamma3 + a3 */
    const double t3 = t2*p[4]; /* b*I3 */
    const double t4 = JLT_FMA(t2, t3, t1); /* K = b*b*I3 + R^2*I1*s*s */
    const double t5 = x[4]*p[7]; /* s*R*G */
    const double t6 = JLT_FMA(t3, x[3], t5); /* b*I3*v_tau + s*R*G */
    const double t7 = x[4]*x[3]; /* s*v_tau */
    const double t8 = JLT_FNMA(t2, p[12], t7); /* s*v_tau - b*G/(R*I1) */
    const double t9 = x[4]*p[16]; /* s*R*I3 */
    const double t10 = t8*t9; /* (s*v_tau - b*G/(R*I1))*s*R*I3 */
    const double t11 = t6*t10; /* (b*I3*v_tau + s*R*G)*(s*v_tau - b*G/(R*I1))*s*R*I3 */
    const double t12 = t4*x[2]; /* K*omega_tau */
    const double t13 = t12*t12; /* K*omega_tau*K*omega_tau */
    const double t14 = JLT_FMA(t6, t6, t13); /* (b*I3*v_tau + s*R*G)*(b*I3*v_tau + s*R*G) + K*omega_tau*K*omega_tau */
    const double t15 = JLT_FMA(x[0], t14, t11); /* gamma3*t14 + (b*I3*v_tau + s*R*G)*(s*v_tau - b*G/(R*I1))*s*R*I3 */
    const double t16 = JLT_FMA(t0, p[8], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t17 = t4*t16; /* K*D */
    const double t18 = 1.0/t17; /* 1/(K*D) */
    const double t19 = t16*t18; /* 1/K = D*1/(K*D) */
    const double t20 = t15*t19; /* t15*1/K */
    const double t21 = t19*t20; /* 1/K*t15*1/K */
    const double t22 = JLT_FMA(t0, p[57], t21); /* s*s*m*g*a3/I1 + 1/K*t15*1/K */
    const double t23 = p[56]*t4; /* m*I1*a3*K */
    const double t24 = t18*t23; /* 1/(K*D)*m*I1*a3*K */
    const double t25 = JLT_FNMA(t22, t24, p[55]); /* contact_force = m*g - (s*s*m*g*a3/I1 + 1/K*t15*1/K)*1/(K*D)*m*I1*a3*K */
    out[0] = t25;
}

static void valid_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[5]); /* b = R*gamma3 + a3 */
    const double t3 = t2*p[4]; /* b*I3 */
    const double t4 = JLT_FMA(t2, t3, t1); /* K = b*b*I3 + R^2*I1*s*s */
    const double t5 = x[4]*p[7]; /* s*R*G */
    const double t6 = JLT_FMA(t3, x[3], t5); /* b*I3*v_tau + s*R*G */
    const double t7 = x[4]*x[3]; /* s*v_tau */
    const double t8 = JLT_FNMA(t2, p[12], t7); /* s*v_tau - b*G/(R*I1) */
    const double t9 = x[4]*p[16]; /* s*R*I3 */
    const double t10 = t8*t9; /* (s*v_tau - b*G/(R*I1))*s*R*I3 */
    const double t11 = t6*t10; /* (b*I3*v_tau + s*R*G)*(s*v_tau - b*G/(R*I1))*s*R*I3 */
    const double t12 = t4*x[2]; /* K*omega_tau */
    const double t13 = t12*t12; /* K*omega_tau*K*omega_tau */
    const double t14 = JLT_FMA(t6, t6, t13); /* (b*I3*v_tau + s*R*G)*(b*I3*v_tau + s*R*G) + K*omega_tau*K*omega_tau */
    const double t15 = JLT_FMA(x[0], t14, t11); /* gamma3*t14 + (b*I3*v_tau + s*R*G)*(s*v_tau - b*G/(R*I1))*s*R*I3 */
    const double t16 = JLT_FMA(t0, p[8], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t17 = t4*t16; /* K*D */
    const double t18 = 1.0/t17; /* 1/(K*D) */
    const double t19 = t16*t18; /* 1/K = D*1/(K*D) */
    const double t20 = t15*t19; /* t15*1/K */
    const double t21 = t19*t20; /* 1/K*t15*1/K */
    const double t22 = JLT_FMA(t0, p[57], t21); /* s*s*m*g*a3/I1 + 1/K*t15*1/K */
    const double t23 = p[56]*t4; /* m*I1*a3*K */
    const double t24 = t18*t23; /* 1/(K*D)*m*I1*a3*K */
    const double t25 = JLT_FNMA(t22, t24, p[55]); /* contact_force = m*g - (s*s*m*g*a3/I1 + 1/K*t15*1/K)*1/(K*D)*m*I1*a3*K */
    out[0] = t25;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
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
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t21[k] = p[1]*x0[k] + (k == 0 ? p[5] : 0);
        t22[k] = jlt_jet_product(x4, x4, k);
        t23[k] = p[4]*t21[k];
        t24[k] = p[9]*t22[k];
        t25[k] = jlt_jet_product(t21, t23, k) + t24[k];
        t26[k] = p[17]*t22[k] + (k == 0 ? 1.0 : 0);
        t27[k] = (k == 0 ? p[20] : 0) + t25[k];
        t28[k] = jlt_jet_product(t25, t26, k);
        t29[k] = jlt_jet_product(t27, t28, k);
        t30[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t29, t30, k);
        t31[k] = jlt_jet_product(t27, t30, k);
        t32[k] = jlt_jet_product(t26, t31, k);
        t33[k] = jlt_jet_product(t25, t31, k);
        t34[k] = p[59]*t28[k];
        t35[k] = jlt_jet_product(t30, t34, k);
        t36[k] = x4[k]*p[58];
        t37[k] = jlt_jet_product(x3, t36, k);
        t38[k] = t37[k] - p[6]*t21[k];
        t39[k] = jlt_jet_product(t32, t38, k);
        t40[k] = jlt_jet_product(x4, x2, k);
        t41[k] = jlt_jet_product(x4, t40, k);
        t42[k] = x4[k]*p[7];
        t43[k] = jlt_jet_product(x3, t23, k) + t42[k];
        t44[k] = jlt_jet_product(t32, t43, k);
        t45[k] = jlt_jet_product(x3, t44, k);
        t46[k] = p[5]*x0[k] + (k == 0 ? p[1] : 0);
        t47[k] = jlt_jet_product(x2, t46, k) + x1[k];
        t48[k] = p[3]*t47[k];
        t49[k] = jlt_jet_product(t44, t48, k);
        t50[k] = jlt_jet_product(x0, t40, k);
        t51[k] = -t50[k];
        t52[k] = p[17]*t40[k];
        t53[k] = jlt_jet_product(t50, t52, k);
        t54[k] = t53[k] - p[57]*t22[k];
        t55[k] = x4[k]*p[47];
        t56[k] = jlt_jet_product(t39, t55, k);
        t57[k] = jlt_jet_product(x0, t44, k) + t56[k];
        t58[k] = t54[k] - jlt_jet_product(t44, t57, k);
        t59[k] = jlt_jet_product(t33, t58, k);
        t60[k] = jlt_jet_product(x1, t44, k);
        t61[k] = x0[k]*p[14] - (k == 0 ? p[15] : 0);
        t62[k] = jlt_jet_product(t40, t61, k);
        t63[k] = t49[k] - jlt_jet_product(t39, t62, k);
        t64[k] = jlt_jet_product(t35, t63, k) - t60[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t41[k]/(k + 1);
        next[1] = x1[k + 1] = t45[k]/(k + 1);
        next[2] = x2[k + 1] = t59[k]/(k + 1);
        next[3] = x3[k + 1] = t64[k]/(k + 1);
        next[4] = x4[k + 1] = t51[k]/(k + 1);
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

static const jlt_quantity observes[] = {
    { "contact_force", "kg*m/s^2", "force of the plane on the sphere, upwards", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    .sha256 = "354294165bef88c837abd694874137bb7226933952335bdf43bb9a6a47b2a4af",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 60,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 1, 28, 14, 1, 0, 0, 11, 11 }, { 21, 82, 0, 8, 0, 0, 11, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, V = omega_tau*e + v_nu, v_tau*I3*b + s*(R*G), s*v_tau - (G/(R*I1))*b, gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(v_tau)/dtau, (v_tau*I3*b + s*(R*G))*gamma3*I1 + (s*v_tau - (G/(R*I1))*b)*s*(R*I1*I3), numerator of d(omega_tau)/dt over D, numerator of d(v_tau)/dt over K" },
    .jacobian = { jacobian, 25, { 8, 72, 36, 1, 0, 0, 15, 25 }, { 114, 577, 0, 55, 0, 0, 18, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, 2/I1 - (2*m*a3^2/I1^2)*s*s*1/(D/I1), b/R*v_tau*(R*I3) + s*(R*G), e = gamma3*a3 + R, V = omega_tau*e + v_nu, gamma3*(R*(I1 - I3)) - (I3*a3), s*v_tau - (G/I1)*b/R, a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), s*v_tau + s*v_tau - (G/I1)*b/R, d(d(v_nu)/dtau)/d(v_tau), v_nu - V*(I1*I3/m)*1/(Theta/m), d(d(v_tau)/dtau)/d(v_nu), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(omega_tau), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), 1/K*v_tau*(R*I3) - b/R*1/K*(2*R^2*I3)*1/K*(b/R*v_tau*(R*I3) + s*(R*G)), a part of d(d(v_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), d(d(omega_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(s), (R*G)*1/K - s*1/K*(2*R^2*I1)*1/K*(b/R*v_tau*(R*I3) + s*(R*G)), d(d(v_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(v_tau)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 81, 39, 1, 0, 0, 15, 30 }, { 129, 644, 0, 63, 0, 0, 18, 12 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*v_tau*(R*I3) + s*(R*G), s*v_tau - (G/I1)*b/R, gamma3*(R*(I1 - I3)) - (I3*a3), e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(d(v_nu)/dtau)/d(v_tau), a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), numerator of d(omega_tau)/dt over D, v_nu - (I1*I3/m)*1/(Theta/m)*V, a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(numerator of d(v_tau)/dt over K)/d(v_nu), a part of d(v_tau)/dtau and of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(numerator of d(v_tau)/dt over K)/d(omega_tau), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(v_tau), d(numerator of d(v_tau)/dt over K)/d(gamma3), d(d(v_tau)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(s), d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s), d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(d(v_nu)/dtau)/d(s)" },
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
    .observe_values = { observe_values, 1, { 0, 16, 9, 1, 0, 0, 11, 6 }, { 11, 49, 0, 4, 0, 0, 12, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, b*I3*v_tau + s*(R*G), s*v_tau - b*(G/(R*I1)), a part of contact_force, a part of contact_force, contact_force" },
    .valid_values = { valid_values, 1, { 0, 16, 9, 1, 0, 0, 11, 6 }, { 11, 49, 0, 4, 0, 0, 12, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, b*I3*v_tau + s*(R*G), s*v_tau - b*(G/(R*I1)), a part of contact, a part of contact, contact" },
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
