/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   28   13    1    0    0     13   10   (111)
 *  jacobian            9   71   36    1    0    0     16   25   (746)
 *  rhs_jacobian        10   79   38    1    0    0     16   31   (836)
 *  divergence          2   16    9    1    0    0     11    8   (56)
 *  integral_values     2    6    6    1    0    0      8    5   (37)
 *  integral_gradients  1   13    6    1    0    0      7    6   (75)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*v_tau*(R*I3) + s*(R*G),
 *      s*v_tau - (G/I1)*b/R, gamma3*(R*(I1 - I3)) - (I3*a3), e = gamma3*a3 + R, V = omega_tau*e + v_nu,
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s),
 *      numerator of d(omega_tau)/dt over D, v_nu - (I1*I3/m)*1/(Theta/m)*V, d(d(v_nu)/dtau)/d(v_tau),
 *      a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s),
 *      d(numerator of d(v_tau)/dt over K)/d(omega_tau), d(numerator of d(v_tau)/dt over K)/d(v_nu),
 *      a part of d(v_tau)/dtau and of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s),
 *      a part of d(d(v_tau)/dtau)/d(v_tau), d(numerator of d(v_tau)/dt over K)/d(gamma3),
 *      a part of d(d(omega_tau)/dtau)/d(gamma3), d(numerator of d(omega_tau)/dt over D)/d(gamma3),
 *      d(d(v_nu)/dtau)/d(s), d(d(v_nu)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(gamma3),
 *      a part of d(d(omega_tau)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(s),
 *      d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

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
    out[33] = t6;
    const double t7 = t6/params[0]; /* I1*I3/m */
    out[10] = t7;
    const double t8 = params[0]*params[2]; /* m*g */
    const double t9 = params[5]*t8; /* a3*m*g */
    out[30] = t9;
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
    out[41] = t26;
    const double t27 = t26/params[3]; /* G*R*I3/I1 */
    out[24] = t27;
    const double t28 = params[0]*2.0; /* m*2 */
    const double t29 = t1*t28; /* a3*a3*m*2 */
    out[42] = t29;
    const double t30 = t29/params[3]; /* a3*a3*m*2/I1 */
    out[25] = t30;
    const double t31 = -t17; /* -R*I3 */
    out[26] = t31;
    const double t32 = 2.0/params[3]; /* 2/I1 */
    out[28] = t32;
    const double t33 = params[3]*params[3]; /* I1*I1 */
    const double t34 = t29/t33; /* a3*a3*m*2/(I1*I1) */
    out[29] = t34;
    const double t35 = params[1]*2.0; /* R*2 */
    const double t36 = params[3]*params[2]; /* I1*g */
    const double t37 = params[4]*t35; /* I3*R*2 */
    const double t38 = params[5]*t37; /* a3*I3*R*2 */
    const double t39 = t38/t36; /* a3*I3*R*2/(I1*g) */
    out[31] = t39;
    const double t40 = params[3]*t23; /* I1*R*R*4 */
    out[32] = t40;
    const double t41 = t4*t14; /* R*R*(I1 - I3) */
    const double t42 = t41/params[0]; /* R*R*(I1 - I3)/m */
    out[34] = t42;
    const double t43 = params[5]/params[0]; /* a3/m */
    out[35] = t43;
    const double t44 = t21/params[0]; /* I3*R*R*2/m */
    out[36] = t44;
    const double t45 = t26/params[0]; /* G*R*I3/m */
    out[37] = t45;
    const double t46 = params[4]*t12; /* I3*R*I1 */
    out[40] = t46;
    const double t47 = t46/params[0]; /* I3*R*I1/m */
    out[38] = t47;
    const double t48 = params[4]*t40; /* I3*I1*R*R*4 */
    out[39] = t48;
    const double t49 = -t46; /* -I3*R*I1 */
    out[43] = t49;
    const double t50 = params[2]*t28; /* g*m*2 */
    const double t51 = params[5]*t50; /* a3*g*m*2 */
    out[44] = t51;
    const double t52 = params[6]*t12; /* G*R*I1 */
    out[45] = t52;
    const double t53 = t23*t33; /* R*R*4*I1*I1 */
    out[46] = t53;
    const double t54 = params[5]*t6; /* a3*I1*I3 */
    const double t55 = t54/params[0]; /* a3*I1*I3/m */
    out[47] = t55;
    const double t56 = params[1]*t4; /* R*R*R */
    const double t57 = 2.0*t56; /* 2*R*R*R */
    const double t58 = params[3]*t57; /* I1*2*R*R*R */
    const double t59 = params[4]*params[4]; /* I3*I3 */
    const double t60 = t58*t59; /* I1*2*R*R*R*I3*I3 */
    const double t61 = t60/params[0]; /* I1*2*R*R*R*I3*I3/m */
    out[48] = t61;
    const double t62 = 1.0/params[1]; /* 1/R */
    out[49] = t62;
    const double t63 = t5*params[4]; /* I1*R*R*I3 */
    const double t64 = t14*t63; /* (I1 - I3)*I1*R*R*I3 */
    const double t65 = t64/params[0]; /* (I1 - I3)*I1*R*R*I3/m */
    out[50] = t65;
    const double t66 = t33*t57; /* I1*I1*2*R*R*R */
    const double t67 = params[4]*t66; /* I3*I1*I1*2*R*R*R */
    const double t68 = t67/params[0]; /* I3*I1*I1*2*R*R*R/m */
    out[51] = t68;
    const double t69 = params[0]*t4; /* m*R*R */
    const double t70 = params[4]/t69; /* I3/(m*R*R) */
    out[52] = t70;
    const double t71 = params[0]*t56; /* m*R*R*R */
    const double t72 = params[3]*t71; /* I1*m*R*R*R */
    const double t73 = params[4]/t72; /* I3/(I1*m*R*R*R) */
    out[53] = t73;
    const double t74 = params[4]/t12; /* I3/(R*I1) */
    out[54] = t74;
    const double t75 = t59/t72; /* I3*I3/(I1*m*R*R*R) */
    out[55] = t75;
    const double t76 = params[0]/2.0; /* m/2 */
    out[56] = t76;
    const double t77 = params[3]*t69; /* I1*m*R*R */
    const double t78 = params[6]*params[6]; /* G*G */
    out[58] = t78;
    const double t79 = t78/t77; /* G*G/(I1*m*R*R) */
    out[57] = t79;
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
    const double t16 = x[3]*p[17]; /* v_tau*R*I3 */
    const double t17 = x[4]*p[7]; /* s*R*G */
    const double t18 = JLT_FMA(t1, t16, t17); /* b/R*v_tau*R*I3 + s*R*G */
    const double t19 = x[4]*x[3]; /* s*v_tau */
    const double t20 = JLT_FNMA(p[23], t1, t19); /* s*v_tau - G/I1*b/R */
    const double t21 = t1*t13; /* b/R*1/K */
    const double t22 = x[4]*x[2]; /* s*omega_tau */
    const double t23 = 2.0*t22; /* 2*s*omega_tau */
    out[4] = t23;
    const double t24 = -t22; /* -s*omega_tau */
    out[20] = t24;
    const double t25 = t13*t18; /* 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t26 = JLT_FMA(t16, t21, t25); /* v_tau*R*I3*b/R*1/K + 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[8] = t26;
    const double t27 = t13*t16; /* 1/K*v_tau*R*I3 */
    const double t28 = x[4]*t13; /* s*1/K */
    const double t29 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t30 = -t29; /* -omega_tau*gamma3 */
    out[24] = t30;
    const double t31 = p[27]*t29; /* m*a3^2*omega_tau*gamma3 */
    const double t32 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t33 = t14*t22; /* 1/(D/I1)*s*omega_tau */
    const double t34 = t31*t33; /* m*a3^2*omega_tau*gamma3*1/(D/I1)*s*omega_tau */
    const double t35 = t15*t34; /* (2/I1 - 2*m*a3^2/I1^2*s*s*1/(D/I1))*m*a3^2*omega_tau*gamma3*1/(D/I1)*s*omega_tau */
    const double t36 = t20*t28; /* (s*v_tau - G/I1*b/R)*s*1/K */
    const double t37 = t14*t25; /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t38 = JLT_FMA(x[2], t32, x[1]); /* V = omega_tau*e + v_nu */
    const double t39 = t18*t38; /* (b/R*v_tau*R*I3 + s*R*G)*V */
    const double t40 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t41 = p[1]*t22; /* R*s*omega_tau */
    const double t42 = t40*t41; /* (gamma3*R*(I1 - I3) - I3*a3)*R*s*omega_tau */
    const double t43 = JLT_FNMA(t20, t42, t39); /* (b/R*v_tau*R*I3 + s*R*G)*V - (s*v_tau - G/I1*b/R)*(gamma3*R*(I1 - I3) - I3*a3)*R*s*omega_tau */
    const double t44 = t12*t40; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t45 = p[17]*t36; /* R*I3*(s*v_tau - G/I1*b/R)*s*1/K */
    const double t46 = x[0]*t25; /* gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t47 = t28*t37; /* s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t48 = x[4]*x[0]; /* s*gamma3 */
    const double t49 = -t48; /* -s*gamma3 */
    out[22] = t49;
    const double t50 = p[25]*t48; /* 2*m*a3^2/I1*s*gamma3 */
    const double t51 = t33*t50; /* 1/(D/I1)*s*omega_tau*2*m*a3^2/I1*s*gamma3 */
    out[12] = t51;
    const double t52 = t37*t50; /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*m*a3^2/I1*s*gamma3 */
    const double t53 = p[10]*t12; /* I1*I3/m*1/(Theta/m) */
    const double t54 = JLT_FNMA(t38, t53, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t55 = p[8]*t22; /* m*a3^2/I1*s*omega_tau */
    const double t56 = t33*t55; /* 1/(D/I1)*s*omega_tau*m*a3^2/I1*s*omega_tau */
    const double t57 = JLT_FMA(p[24], t47, t56); /* R*I3*G/I1*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) + 1/(D/I1)*s*omega_tau*m*a3^2/I1*s*omega_tau */
    const double t58 = t22*t28; /* s*omega_tau*s*1/K */
    const double t59 = t45 + t46; /* R*I3*(s*v_tau - G/I1*b/R)*s*1/K + gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t60 = JLT_FMA(2.0, t46, t45); /* 2*gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) + R*I3*(s*v_tau - G/I1*b/R)*s*1/K */
    const double t61 = t14*t60; /* 1/(D/I1)*t60 */
    const double t62 = JLT_FNMA(t27, t61, t57); /* t57 - 1/K*v_tau*R*I3*1/(D/I1)*t60 */
    const double t63 = p[31]*t36; /* 2*R*I3*a3/(g*I1)*(s*v_tau - G/I1*b/R)*s*1/K */
    const double t64 = JLT_FNMA(t37, t63, t15); /* 2/I1 - 2*m*a3^2/I1^2*s*s*1/(D/I1) - 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R*I3*a3/(g*I1)*(s*v_tau - G/I1*b/R)*s*1/K */
    const double t65 = x[4]*p[30]; /* s*m*g*a3 */
    const double t66 = t14*t65; /* 1/(D/I1)*s*m*g*a3 */
    const double t67 = x[3]*t28; /* v_tau*s*1/K */
    const double t68 = JLT_FMA(t13, t20, t67); /* 1/K*(s*v_tau - G/I1*b/R) + v_tau*s*1/K */
    const double t69 = JLT_FNMA(p[17], t68, t52); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*m*a3^2/I1*s*gamma3 - R*I3*(1/K*(s*v_tau - G/I1*b/R) + v_tau*s*1/K) */
    const double t70 = p[32]*t47; /* 4*R^2*I1*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t71 = JLT_FMA(t59, t70, t35); /* t59*4*R^2*I1*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) + t35 */
    const double t72 = JLT_FNMA(t64, t66, t71); /* t71 - t64*1/(D/I1)*s*m*g*a3 */
    const double t73 = JLT_FMA(t37, t69, t72); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*t69 + t71 - t64*1/(D/I1)*s*m*g*a3 */
    const double t74 = x[4]*t47; /* s*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t75 = JLT_FMA(t21, t61, t74); /* b/R*1/K*1/(D/I1)*t60 + s*s*1/K*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t76 = p[26]*t75; /* (-R*I3)*t75 */
    out[13] = t76;
    const double t77 = p[34]*t36; /* R^2*(I1 - I3)/m*(s*v_tau - G/I1*b/R)*s*1/K */
    const double t78 = JLT_FNMA(p[35], t25, t77); /* R^2*(I1 - I3)/m*(s*v_tau - G/I1*b/R)*s*1/K - a3/m*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t79 = x[2]*t78; /* omega_tau*t78 */
    const double t80 = t12 + t13; /* 1/(Theta/m) + 1/K */
    const double t81 = t43*t80; /* t43*(1/(Theta/m) + 1/K) */
    const double t82 = p[7]*t13; /* R*G*1/K */
    const double t83 = JLT_FNMA(t61, t82, t73); /* t73 - 1/(D/I1)*t60*R*G*1/K */
    out[14] = t83;
    const double t84 = p[33]*t12; /* I1*I3*1/(Theta/m) */
    const double t85 = x[2]*p[37]; /* omega_tau*R*I3*G/m */
    const double t86 = t44*t85; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I3*G/m */
    const double t87 = p[38]*t44; /* R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t88 = t27*t54; /* 1/K*v_tau*R*I3*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t89 = JLT_FMS(t28, t86, t88); /* s*1/K*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I3*G/m - 1/K*v_tau*R*I3*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t90 = p[21]*t28; /* 2*R^2*I1*s*1/K */
    const double t91 = x[1]*t25; /* v_nu*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t92 = p[17]*t21; /* R*I3*b/R*1/K */
    const double t93 = t54*t92; /* (v_nu - V*I1*I3/m*1/(Theta/m))*R*I3*b/R*1/K */
    const double t94 = JLT_FMA(t58, t87, t93); /* s*omega_tau*s*1/K*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) + (v_nu - V*I1*I3/m*1/(Theta/m))*R*I3*b/R*1/K */
    const double t95 = -t94; /* -t94 */
    out[18] = t95;
    const double t96 = t54*t82; /* (v_nu - V*I1*I3/m*1/(Theta/m))*R*G*1/K */
    const double t97 = JLT_FNMA(t25, t90, t82); /* R*G*1/K - 1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I1*s*1/K */
    const double t98 = x[3]*t97; /* v_tau*(R*G*1/K - 1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I1*s*1/K) */
    out[9] = t98;
    const double t99 = p[20]*t21; /* 2*R^2*I3*b/R*1/K */
    const double t100 = JLT_FNMA(t25, t99, t27); /* 1/K*v_tau*R*I3 - 1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I3*b/R*1/K */
    const double t101 = JLT_FMA(t91, t99, t89); /* v_nu*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I3*b/R*1/K + t89 */
    const double t102 = x[3]*t100; /* v_tau*t100 */
    out[5] = t102;
    const double t103 = JLT_FNMA(t53, t81, t91); /* v_nu*1/K*(b/R*v_tau*R*I3 + s*R*G) - I1*I3/m*1/(Theta/m)*t43*(1/(Theta/m) + 1/K) */
    const double t104 = JLT_FMS(t90, t103, t96); /* 2*R^2*I1*s*1/K*t103 - (v_nu - V*I1*I3/m*1/(Theta/m))*R*G*1/K */
    const double t105 = t25*t53; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) */
    const double t106 = t32*t105; /* e*1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) */
    const double t107 = JLT_FNMA(t36, t87, t106); /* e*1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) - (s*v_tau - G/I1*b/R)*s*1/K*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    out[17] = t107;
    const double t108 = t105 - t25; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) - 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[16] = t108;
    const double t109 = x[2]*t87; /* omega_tau*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t110 = JLT_FNMA(t68, t109, t104); /* 2*R^2*I1*s*1/K*t103 - (v_nu - V*I1*I3/m*1/(Theta/m))*R*G*1/K - (1/K*(s*v_tau - G/I1*b/R) + v_tau*s*1/K)*omega_tau*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    out[19] = t110;
    const double t111 = p[22]*t21; /* 4*R^2*I3*b/R*1/K */
    const double t112 = JLT_FMS(t59, t111, t25); /* t59*4*R^2*I3*b/R*1/K - 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t113 = JLT_FMA(t37, t112, t62); /* 1/(D/I1)*1/K*(b/R*v_tau*R*I3 + s*R*G)*(t59*4*R^2*I3*b/R*1/K - 1/K*(b/R*v_tau*R*I3 + s*R*G)) + t57 - 1/K*v_tau*R*I3*1/(D/I1)*t60 */
    out[10] = t113;
    const double t114 = p[36]*t21; /* 2*R^2*I3/m*b/R*1/K */
    const double t115 = JLT_FMA(t81, t114, t79); /* t43*(1/(Theta/m) + 1/K)*2*R^2*I3/m*b/R*1/K + omega_tau*t78 */
    const double t116 = JLT_FNMA(t84, t115, t101); /* v_nu*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I3*b/R*1/K + t89 - I1*I3*1/(Theta/m)*(t43*(1/(Theta/m) + 1/K)*2*R^2*I3/m*b/R*1/K + omega_tau*t78) */
    out[15] = t116;
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
    const double t5 = JLT_FMA(p[27], t1, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t6 = p[10] + t4; /* Theta/m = I1*I3/m + K */
    const double t7 = t4*t5; /* K*D */
    const double t8 = t6*t7; /* Theta/m*K*D */
    const double t9 = 1.0/t8; /* 1/(Theta/m*K*D) */
    const double t10 = t7*t9; /* 1/(Theta/m) = K*D*1/(Theta/m*K*D) */
    const double t11 = t6*t9; /* 1/(K*D) = Theta/m*1/(Theta/m*K*D) */
    const double t12 = t5*t11; /* 1/K = D*1/(K*D) */
    const double t13 = t4*t11; /* 1/D = K*1/(K*D) */
    const double t14 = x[4]*p[7]; /* s*R*G */
    const double t15 = x[3]*p[17]; /* v_tau*R*I3 */
    const double t16 = JLT_FMA(t0, t15, t14); /* b/R*v_tau*R*I3 + s*R*G */
    const double t17 = x[4]*x[3]; /* s*v_tau */
    const double t18 = JLT_FNMA(p[23], t0, t17); /* s*v_tau - G/I1*b/R */
    const double t19 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t20 = t10*t19; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t21 = x[4]*x[2]; /* s*omega_tau */
    const double t22 = x[4]*t21; /* s*s*omega_tau */
    out[0] = t22;
    const double t23 = 2.0*t21; /* 2*s*omega_tau */
    out[9] = t23;
    const double t24 = -t21; /* -s*omega_tau */
    out[25] = t24;
    const double t25 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t26 = t10*t16; /* 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t27 = x[2]*p[47]; /* omega_tau*I1*I3*a3/m */
    const double t28 = t26*t27; /* 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G)*omega_tau*I1*I3*a3/m */
    const double t29 = t18*t20; /* (s*v_tau - G/I1*b/R)*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t30 = t20*t21; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*s*omega_tau */
    const double t31 = t12*t16; /* 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t32 = p[27]*t21; /* m*a3^2*s*omega_tau */
    const double t33 = x[0]*t21; /* gamma3*s*omega_tau */
    const double t34 = -t33; /* -gamma3*s*omega_tau */
    out[4] = t34;
    const double t35 = x[4]*t12; /* s*1/K */
    const double t36 = p[17]*t18; /* R*I3*(s*v_tau - G/I1*b/R) */
    const double t37 = t35*t36; /* s*1/K*R*I3*(s*v_tau - G/I1*b/R) */
    const double t38 = JLT_FMA(x[2], t25, x[1]); /* V = omega_tau*e + v_nu */
    const double t39 = t10*t38; /* 1/(Theta/m)*V */
    const double t40 = t10*t21; /* 1/(Theta/m)*s*omega_tau */
    const double t41 = t21*t32; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t42 = t32*t33; /* m*a3^2*s*omega_tau*gamma3*s*omega_tau */
    const double t43 = JLT_FNMA(p[30], t1, t42); /* m*a3^2*s*omega_tau*gamma3*s*omega_tau - m*g*a3*s*s */
    const double t44 = x[2]*p[42]; /* omega_tau*2*m*a3^2 */
    const double t45 = t33*t44; /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 */
    const double t46 = JLT_FNMA(x[4], p[44], t45); /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t47 = p[50]*t18; /* R^2*I1*I3*(I1 - I3)/m*(s*v_tau - G/I1*b/R) */
    const double t48 = JLT_FNMA(t40, t47, t28); /* 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G)*omega_tau*I1*I3*a3/m - 1/(Theta/m)*s*omega_tau*R^2*I1*I3*(I1 - I3)/m*(s*v_tau - G/I1*b/R) */
    const double t49 = t29*t40; /* t29*1/(Theta/m)*s*omega_tau */
    const double t50 = p[38]*t29; /* R*I1*I3/m*t29 */
    const double t51 = JLT_FMA(p[37], t30, t48); /* R*I3*G/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*s*omega_tau + t48 */
    const double t52 = p[38]*t30; /* R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*s*omega_tau */
    const double t53 = x[0]*t31; /* gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t54 = t31*t35; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t55 = JLT_FMA(p[41], t54, t41); /* R*I3*G*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + s*omega_tau*m*a3^2*s*omega_tau */
    const double t56 = p[21]*t35; /* 2*R^2*I1*s*1/K */
    const double t57 = x[2]*t50; /* omega_tau*R*I1*I3/m*t29 */
    const double t58 = JLT_FMA(x[3], t52, t57); /* v_tau*t52 + omega_tau*R*I1*I3/m*t29 */
    const double t59 = p[3]*t31; /* I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t60 = t37 + t53; /* s*1/K*R*I3*(s*v_tau - G/I1*b/R) + gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t61 = JLT_FMA(2.0, t53, t37); /* 2*gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) + s*1/K*R*I3*(s*v_tau - G/I1*b/R) */
    const double t62 = JLT_FNMA(t59, t60, t43); /* numerator of d(omega_tau)/dt over D = m*a3^2*s*omega_tau*gamma3*s*omega_tau - m*g*a3*s*s - I1*1/K*(b/R*v_tau*R*I3 + s*R*G)*t60 */
    const double t63 = t13*t62; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t63;
    const double t64 = JLT_FNMA(p[10], t39, x[1]); /* v_nu - I1*I3/m*1/(Theta/m)*V */
    const double t65 = JLT_FNMA(t15, t64, t51); /* t51 - v_tau*R*I3*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t66 = JLT_FMA(p[7], t64, t58); /* R*G*(v_nu - I1*I3/m*1/(Theta/m)*V) + v_tau*t52 + omega_tau*R*I1*I3/m*t29 */
    const double t67 = x[3]*t12; /* v_tau*1/K */
    const double t68 = t0*t12; /* b/R*1/K */
    const double t69 = JLT_FMA(t15, t68, t31); /* v_tau*R*I3*b/R*1/K + 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[13] = t69;
    const double t70 = t15*t67; /* v_tau*R*I3*v_tau*1/K */
    const double t71 = x[3]*t54; /* v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t72 = t12*t18; /* 1/K*(s*v_tau - G/I1*b/R) */
    const double t73 = JLT_FMA(t31, t72, t71); /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*1/K*(s*v_tau - G/I1*b/R) + v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t74 = p[46]*t54; /* 4*R^2*I1^2*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t75 = JLT_FMA(t60, t74, t46); /* t60*4*R^2*I1^2*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t76 = JLT_FNMA(p[40], t73, t75); /* t75 - R*I1*I3*t73 */
    const double t77 = p[49]*t26; /* 1/R*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t78 = JLT_FNMA(t39, t77, t49); /* t29*1/(Theta/m)*s*omega_tau - 1/(Theta/m)*V*1/R*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t79 = p[10]*t26; /* I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t80 = t25*t79; /* e*I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t81 = JLT_FNMA(x[4], t50, t80); /* d(numerator of d(v_tau)/dt over K)/d(omega_tau) = e*I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) - s*R*I1*I3/m*t29 */
    const double t82 = t12*t81; /* 1/K*d(numerator of d(v_tau)/dt over K)/d(omega_tau) */
    out[22] = t82;
    const double t83 = t79 - t16; /* d(numerator of d(v_tau)/dt over K)/d(v_nu) = I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) - (b/R*v_tau*R*I3 + s*R*G) */
    const double t84 = t12*t83; /* 1/K*d(numerator of d(v_tau)/dt over K)/d(v_nu) */
    out[21] = t84;
    const double t85 = t16*t64; /* (b/R*v_tau*R*I3 + s*R*G)*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t86 = JLT_FMA(t18, t52, t85); /* (s*v_tau - G/I1*b/R)*t52 + (b/R*v_tau*R*I3 + s*R*G)*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t87 = p[17]*t0; /* R*I3*b/R */
    const double t88 = t64*t87; /* (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*b/R */
    const double t89 = JLT_FMA(x[4], t52, t88); /* s*t52 + (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*b/R */
    const double t90 = p[48]*t0; /* 2*R^3*I1*I3^2/m*b/R */
    const double t91 = JLT_FMA(t78, t90, t65); /* d(numerator of d(v_tau)/dt over K)/d(gamma3) = t78*2*R^3*I1*I3^2/m*b/R + t51 - v_tau*R*I3*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t92 = t12*t89; /* 1/K*(s*t52 + (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*b/R) */
    const double t93 = -t92; /* -1/K*(s*t52 + (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*b/R) */
    out[23] = t93;
    const double t94 = p[39]*t68; /* 4*R^2*I1*I3*b/R*1/K */
    const double t95 = JLT_FMS(t60, t94, t59); /* t60*4*R^2*I1*I3*b/R*1/K - I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t96 = p[40]*t67; /* R*I1*I3*v_tau*1/K */
    const double t97 = JLT_FNMA(t61, t96, t55); /* t55 - t61*R*I1*I3*v_tau*1/K */
    const double t98 = JLT_FMA(t31, t95, t97); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = 1/K*(b/R*v_tau*R*I3 + s*R*G)*(t60*4*R^2*I1*I3*b/R*1/K - I1*1/K*(b/R*v_tau*R*I3 + s*R*G)) + t55 - t61*R*I1*I3*v_tau*1/K */
    const double t99 = t13*t98; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    out[15] = t99;
    const double t100 = x[3]*t31; /* v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[1] = t100;
    const double t101 = p[7]*t67; /* R*G*v_tau*1/K */
    const double t102 = JLT_FNMA(p[21], t71, t101); /* R*G*v_tau*1/K - 2*R^2*I1*v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    out[14] = t102;
    const double t103 = x[4]*t13; /* s*1/D */
    const double t104 = t13*t68; /* 1/D*b/R*1/K */
    const double t105 = p[20]*t68; /* 2*R^2*I3*b/R*1/K */
    const double t106 = JLT_FNMA(t100, t105, t70); /* v_tau*R*I3*v_tau*1/K - v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I3*b/R*1/K */
    out[10] = t106;
    const double t107 = JLT_FMA(t86, t105, t91); /* t86*2*R^2*I3*b/R*1/K + d(numerator of d(v_tau)/dt over K)/d(gamma3) */
    const double t108 = t12*t107; /* 1/K*t107 */
    out[20] = t108;
    const double t109 = t61*t104; /* t61*1/D*b/R*1/K */
    const double t110 = JLT_FMA(t54, t103, t109); /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K*s*1/D + t61*1/D*b/R*1/K */
    const double t111 = p[43]*t110; /* (-R*I1*I3)*(1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K*s*1/D + t61*1/D*b/R*1/K) */
    out[18] = t111;
    const double t112 = p[42]*t103; /* 2*m*a3^2*s*1/D */
    const double t113 = t33*t112; /* gamma3*s*omega_tau*2*m*a3^2*s*1/D */
    out[17] = t113;
    const double t114 = t63*t112; /* 1/D*numerator of d(omega_tau)/dt over D*2*m*a3^2*s*1/D */
    const double t115 = t12*t86; /* 1/K*t86 */
    const double t116 = -t115; /* -1/K*t86 */
    out[3] = t116;
    const double t117 = x[4]*p[51]; /* s*2*R^3*I1^2*I3/m */
    const double t118 = JLT_FNMA(t78, t117, t66); /* t66 - t78*s*2*R^3*I1^2*I3/m */
    const double t119 = t12*t118; /* 1/K*(t66 - t78*s*2*R^3*I1^2*I3/m) */
    const double t120 = JLT_FMS(t56, t115, t119); /* 2*R^2*I1*s*1/K*1/K*t86 - 1/K*(t66 - t78*s*2*R^3*I1^2*I3/m) */
    out[24] = t120;
    const double t121 = p[45]*t12; /* R*I1*G*1/K */
    const double t122 = JLT_FNMA(t61, t121, t76); /* d(numerator of d(omega_tau)/dt over D)/d(s) = t75 - R*I1*I3*t73 - t61*R*I1*G*1/K */
    const double t123 = JLT_FMS(t13, t122, t114); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) - 1/D*numerator of d(omega_tau)/dt over D*2*m*a3^2*s*1/D */
    out[19] = t123;
    const double t124 = x[4]*x[0]; /* s*gamma3 */
    const double t125 = -t124; /* -s*gamma3 */
    out[27] = t125;
    const double t126 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t127 = -t126; /* -omega_tau*gamma3 */
    out[29] = t127;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[0] + p[19]; /* b/R = gamma3 + a3/R */
    const double t2 = p[12]*t1; /* I3/I1*b/R */
    const double t3 = JLT_FMA(t1, t2, t0); /* K/(R^2*I1) = b/R*I3/I1*b/R + s*s */
    const double t4 = t3 + p[52]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t5 = JLT_FMA(t0, p[27], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t3*t5; /* K/(R^2*I1)*D */
    const double t7 = t4*t6; /* Theta/(m*R^2*I1)*K/(R^2*I1)*D */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t9 = t4*t8; /* 1/(D*(K/(R^2*I1))) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t10 = x[0]*p[42]; /* gamma3*2*m*a3^2 */
    const double t11 = t3*t10; /* K/(R^2*I1)*gamma3*2*m*a3^2 */
    const double t12 = t9*t11; /* 1/(D*(K/(R^2*I1)))*K/(R^2*I1)*gamma3*2*m*a3^2 */
    const double t13 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t14 = t5*t8; /* 1/((K/(R^2*I1))*(Theta/(m*R^2*I1))) = D*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t15 = p[53]*t13; /* I3/(m*R^3*I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t16 = JLT_FNMA(t14, t15, t12); /* 1/(D*(K/(R^2*I1)))*K/(R^2*I1)*gamma3*2*m*a3^2 - 1/((K/(R^2*I1))*(Theta/(m*R^2*I1)))*I3/(m*R^3*I1)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t17 = JLT_FNMA(t0, t16, x[0]); /* gamma3 - s*s*t16 */
    const double t18 = p[54]*x[1]; /* I3/(R*I1)*v_nu */
    const double t19 = t1*t18; /* b/R*I3/(R*I1)*v_nu */
    const double t20 = t5*t19; /* D*b/R*I3/(R*I1)*v_nu */
    const double t21 = t9*t20; /* 1/(D*(K/(R^2*I1)))*D*b/R*I3/(R*I1)*v_nu */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = t1*p[55]; /* b/R*I3^2/(m*R^3*I1) */
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
    const double t5 = p[52] + t3; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[57]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = t7/t3; /* (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t10 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/2*omega_tau */
    const double t12 = p[30]*x[0]; /* m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t4, t11, t12); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(p[56], t9, t13); /* 1/2*m*t9 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
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
    const double t6 = p[33]*x[3]; /* I1*I3*v_tau */
    const double t7 = JLT_FMA(x[3], t6, p[58]); /* v_tau*I1*I3*v_tau + G^2 */
    const double t8 = 1.0/t5; /* 1/K */
    const double t9 = t7*t8; /* (v_tau*I1*I3*v_tau + G^2)*1/K */
    const double t10 = JLT_FMA(p[0], t5, p[33]); /* Theta = m*K + I1*I3 */
    const double t11 = t8*t9; /* 1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
    const double t12 = JLT_FNMA(t4, t11, p[30]); /* m*g*a3 - R^2*I3*b/R*1/K*(v_tau*I1*I3*v_tau + G^2)*1/K */
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
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t20[k] = jlt_jet_product(x4, x4, k);
        t21[k] = (k == 0 ? p[19] : 0) + x0[k];
        t22[k] = p[9]*t20[k];
        t23[k] = p[18]*t21[k];
        t24[k] = jlt_jet_product(t21, t23, k) + t22[k];
        t25[k] = p[8]*t20[k] + (k == 0 ? 1.0 : 0);
        t26[k] = (k == 0 ? p[10] : 0) + t24[k];
        t27[k] = jlt_jet_product(t24, t25, k);
        t28[k] = jlt_jet_product(t26, t27, k);
        t29[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t28, t29, k);
        t30[k] = jlt_jet_product(t26, t29, k);
        t31[k] = jlt_jet_product(t27, t29, k);
        t32[k] = jlt_jet_product(t25, t30, k);
        t33[k] = jlt_jet_product(t24, t30, k);
        t34[k] = x4[k]*p[7];
        t35[k] = x3[k]*p[17];
        t36[k] = jlt_jet_product(t21, t35, k) + t34[k];
        t37[k] = jlt_jet_product(t32, t36, k);
        t38[k] = jlt_jet_product(x3, t37, k);
        t39[k] = jlt_jet_product(x4, x3, k);
        t40[k] = t39[k] - p[23]*t21[k];
        t41[k] = jlt_jet_product(x4, t40, k);
        t42[k] = jlt_jet_product(t32, t41, k);
        t43[k] = x0[k]*p[5] + (k == 0 ? p[1] : 0);
        t44[k] = jlt_jet_product(x2, t43, k) + x1[k];
        t45[k] = p[10]*t44[k];
        t46[k] = x1[k] - jlt_jet_product(t31, t45, k);
        t47[k] = jlt_jet_product(t37, t46, k);
        t48[k] = jlt_jet_product(x2, x0, k);
        t49[k] = jlt_jet_product(x2, t20, k);
        t50[k] = p[8]*t48[k];
        t51[k] = jlt_jet_product(t49, t50, k);
        t52[k] = t51[k] - p[11]*t20[k];
        t53[k] = jlt_jet_product(x4, t48, k);
        t54[k] = -t53[k];
        t55[k] = x0[k]*p[15] - (k == 0 ? p[16] : 0);
        t56[k] = x2[k]*p[38];
        t57[k] = jlt_jet_product(t55, t56, k);
        t58[k] = jlt_jet_product(t31, t57, k);
        t59[k] = jlt_jet_product(t42, t58, k) + t47[k];
        t60[k] = -t59[k];
        t61[k] = jlt_jet_product(x0, t37, k);
        t62[k] = p[17]*t42[k] + t61[k];
        t63[k] = t52[k] - jlt_jet_product(t37, t62, k);
        t64[k] = jlt_jet_product(t33, t63, k);
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t49[k]/(k + 1);
        next[1] = x1[k + 1] = t38[k]/(k + 1);
        next[2] = x2[k + 1] = t64[k]/(k + 1);
        next[3] = x3[k + 1] = t60[k]/(k + 1);
        next[4] = x4[k + 1] = t54[k]/(k + 1);
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
    .sha256 = "0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 59,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 28, 13, 1, 0, 0, 13, 10 }, { 21, 82, 0, 8, 0, 0, 11, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, v_tau*s*(R*I1) - G*b, v_tau*I3*b + s*(R*G), e = a3*gamma3 + R, V = omega_tau*e + v_nu, gamma3*1/K*(v_tau*I3*b + s*(R*G)) + 1/K*(v_tau*s*(R*I1) - G*b)*s*(I3/I1), a part of d(omega_tau)/dtau, gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(v_tau)/dtau, d(v_tau)/dtau" },
    .jacobian = { jacobian, 25, { 9, 71, 36, 1, 0, 0, 16, 25 }, { 114, 577, 0, 55, 0, 0, 18, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, 2/I1 - (2*m*a3^2/I1^2)*s*s*1/(D/I1), b/R*v_tau*(R*I3) + s*(R*G), s*v_tau - (G/I1)*b/R, d(d(v_nu)/dtau)/d(v_tau), e = gamma3*a3 + R, V = omega_tau*e + v_nu, gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), v_nu - V*(I1*I3/m)*1/(Theta/m), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), 1/K*(s*v_tau - (G/I1)*b/R) + v_tau*s*1/K, a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(v_tau), (R*G)*1/K - 1/K*(b/R*v_tau*(R*I3) + s*(R*G))*(2*R^2*I1)*s*1/K, 1/K*v_tau*(R*I3) - 1/K*(b/R*v_tau*(R*I3) + s*(R*G))*(2*R^2*I3)*b/R*1/K, a part of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(omega_tau), d(d(v_tau)/dtau)/d(v_nu), d(d(v_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(gamma3), d(d(v_tau)/dtau)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 79, 38, 1, 0, 0, 16, 31 }, { 129, 644, 0, 63, 0, 0, 18, 12 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, b/R*v_tau*(R*I3) + s*(R*G), s*v_tau - (G/I1)*b/R, gamma3*(R*(I1 - I3)) - (I3*a3), e = gamma3*a3 + R, V = omega_tau*e + v_nu, a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(gamma3) and of d(d(omega_tau)/dtau)/d(v_tau) and of d(d(omega_tau)/dtau)/d(s), numerator of d(omega_tau)/dt over D, v_nu - (I1*I3/m)*1/(Theta/m)*V, d(d(v_nu)/dtau)/d(v_tau), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), d(numerator of d(v_tau)/dt over K)/d(omega_tau), d(numerator of d(v_tau)/dt over K)/d(v_nu), a part of d(v_tau)/dtau and of d(d(v_tau)/dtau)/d(gamma3) and of d(d(v_tau)/dtau)/d(s), a part of d(d(v_tau)/dtau)/d(v_tau), d(numerator of d(v_tau)/dt over K)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3), d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(d(v_nu)/dtau)/d(s), d(d(v_nu)/dtau)/d(gamma3), a part of d(d(v_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(v_tau), a part of d(d(v_tau)/dtau)/d(s), d(d(v_tau)/dtau)/d(s), d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s)" },
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
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_general_in_regular_baseline,
        &jlt_batch_spherical_top_level_general_in_regular_avx2,
        &jlt_batch_spherical_top_level_general_in_regular_avx512,
    },
};
