/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   32   14    1    1    0     17   13   (110)
 *  jacobian            8   67   36    1    1    0     20   28   (567)
 *  rhs_jacobian        7   75   41    1    1    0     19   38   (653)
 *  divergence          2   22   11    1    1    0     16   10   (60)
 *  integral_values     2    8    8    1    0    0      8    7   (40)
 *  integral_gradients  2   13    9    1    0    0     10    8   (59)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    const double t2 = params[1]*params[6]; /* R*G */
    const double t3 = params[5]*params[5]; /* a3*a3 */
    const double t4 = params[0]*t3; /* m*a3*a3 */
    const double t5 = params[3]*params[4]; /* I1*I3 */
    const double t6 = t4/params[3]; /* m*a3*a3/I1 */
    const double t7 = params[0]*params[2]; /* m*g */
    const double t8 = params[5]*t7; /* a3*m*g */
    const double t9 = t8/params[3]; /* a3*m*g/I1 */
    const double t10 = params[4]/params[3]; /* I3/I1 */
    const double t11 = params[1]*params[3]; /* R*I1 */
    const double t12 = params[3] - params[4]; /* I1 - I3 */
    const double t13 = params[1]*t12; /* R*(I1 - I3) */
    const double t14 = params[5]*params[4]; /* a3*I3 */
    const double t15 = t0*2.0; /* R*R*2 */
    const double t16 = params[3]*t15; /* I1*R*R*2 */
    const double t17 = params[1]*2.0; /* R*2 */
    const double t18 = params[4]*t17; /* I3*R*2 */
    const double t19 = params[1]*params[4]; /* R*I3 */
    const double t20 = params[0]*2.0; /* m*2 */
    const double t21 = t3*t20; /* a3*a3*m*2 */
    const double t22 = params[3]*2.0; /* I1*2 */
    const double t23 = params[4]*t22; /* I3*I1*2 */
    const double t24 = params[4]*params[4]; /* I3*I3 */
    const double t25 = params[4]*t11; /* I3*R*I1 */
    const double t26 = params[3]*params[0]; /* I1*m */
    const double t27 = params[4]*t26; /* I3*I1*m */
    const double t28 = params[3]*params[5]; /* I1*a3 */
    const double t29 = params[4]*t20; /* I3*m*2 */
    const double t30 = t3*t29; /* a3*a3*I3*m*2 */
    const double t31 = params[0]*params[4]; /* m*I3 */
    const double t32 = params[5]*t5; /* a3*I1*I3 */
    const double t33 = t12*t19; /* (I1 - I3)*R*I3 */
    const double t34 = params[0]/2.0; /* m/2 */
    const double t35 = params[6]*params[6]; /* G*G */
    const double t36 = t35/params[0]; /* G*G/m */
    const double t37 = 1.0/params[0]; /* 1/m */
    out[7] = t1;
    out[8] = t2;
    out[9] = t4;
    out[10] = t5;
    out[11] = t6;
    out[12] = t9;
    out[13] = t10;
    out[14] = t11;
    out[15] = t13;
    out[16] = t14;
    out[17] = t16;
    out[18] = t18;
    out[19] = t19;
    out[20] = t21;
    out[21] = t8;
    out[22] = t22;
    out[23] = t23;
    out[24] = t24;
    out[25] = t25;
    out[26] = t27;
    out[27] = t28;
    out[28] = t30;
    out[29] = t31;
    out[30] = t32;
    out[31] = t33;
    out[32] = t34;
    out[33] = t35;
    out[34] = t36;
    out[35] = t37;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = t2*p[7]; /* (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t6 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t7 = t6*p[4]; /* b*I3 */
    const double t8 = JLT_FMA(t6, t7, t5); /* K = b*b*I3 + (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t9 = t3*p[8]; /* s*R*G */
    const double t10 = JLT_FMA(x[3], t7, t9); /* v_tau*b*I3 + s*R*G */
    const double t11 = JLT_FMA(t2, p[9], p[3]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t12 = JLT_FMA(t8, p[0], p[10]); /* Theta = K*m + I1*I3 */
    const double t13 = t8*t11; /* K*D */
    const double t14 = t3*t13; /* s*K*D */
    const double t15 = t12*t14; /* Theta*s*K*D */
    const double t16 = 1.0/t15; /* 1/(Theta*s*K*D) */
    const double t17 = t12*t16; /* Theta*1/(Theta*s*K*D) */
    const double t18 = t11*t17; /* D*Theta*1/(Theta*s*K*D) */
    const double t19 = t3*t18; /* s*D*Theta*1/(Theta*s*K*D) */
    const double t20 = t10*t19; /* (v_tau*b*I3 + s*R*G)*s*D*Theta*1/(Theta*s*K*D) */
    const double t21 = t8*t18; /* K*D*Theta*1/(Theta*s*K*D) */
    const double t22 = t20*t21; /* (v_tau*b*I3 + s*R*G)*s*D*Theta*1/(Theta*s*K*D)*K*D*Theta*1/(Theta*s*K*D) */
    const double t23 = x[3]*t22; /* v_tau*t22 */
    const double t24 = x[2]*p[11]; /* omega_tau*m*a3^2/I1 */
    const double t25 = x[0]*t24; /* gamma3*omega_tau*m*a3^2/I1 */
    const double t26 = t4*t25; /* omega_tau*s*gamma3*omega_tau*m*a3^2/I1 */
    const double t27 = x[0]*t22; /* gamma3*t22 */
    const double t28 = x[3]*p[14]; /* v_tau*R*I1 */
    const double t29 = t3*t28; /* s*v_tau*R*I1 */
    const double t30 = JLT_FNMA(t6, p[6], t29); /* s*v_tau*R*I1 - b*G */
    const double t31 = t19*t30; /* s*D*Theta*1/(Theta*s*K*D)*(s*v_tau*R*I1 - b*G) */
    const double t32 = JLT_FMA(p[13], t31, t27); /* I3/I1*s*D*Theta*1/(Theta*s*K*D)*(s*v_tau*R*I1 - b*G) + gamma3*t22 */
    const double t33 = JLT_FNMA(t3, p[12], t26); /* omega_tau*s*gamma3*omega_tau*m*a3^2/I1 - s*m*g*a3/I1 */
    const double t34 = JLT_FNMA(t20, t32, t33); /* omega_tau*s*gamma3*omega_tau*m*a3^2/I1 - s*m*g*a3/I1 - (v_tau*b*I3 + s*R*G)*s*D*Theta*1/(Theta*s*K*D)*t32 */
    const double t35 = t8*p[3]; /* K*I1 */
    const double t36 = t3*t35; /* s*K*I1 */
    const double t37 = t17*t36; /* Theta*1/(Theta*s*K*D)*s*K*I1 */
    const double t38 = t34*t37; /* t34*Theta*1/(Theta*s*K*D)*s*K*I1 */
    const double t39 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t40 = JLT_FMA(x[2], t39, x[1]); /* V = omega_tau*e + v_nu */
    const double t41 = t14*t16; /* s*K*D*1/(Theta*s*K*D) */
    const double t42 = p[10]*t40; /* I1*I3*V */
    const double t43 = JLT_FNMA(t41, t42, x[1]); /* v_nu - s*K*D*1/(Theta*s*K*D)*I1*I3*V */
    const double t44 = t22*t43; /* t22*(v_nu - s*K*D*1/(Theta*s*K*D)*I1*I3*V) */
    const double t45 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t46 = x[2]*p[4]; /* omega_tau*I3 */
    const double t47 = t45*t46; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3 */
    const double t48 = t41*t47; /* s*K*D*1/(Theta*s*K*D)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3 */
    const double t49 = JLT_FMA(t31, t48, t44); /* s*D*Theta*1/(Theta*s*K*D)*(s*v_tau*R*I1 - b*G)*t48 + t22*(v_nu - s*K*D*1/(Theta*s*K*D)*I1*I3*V) */
    const double t50 = -t49; /* -t49 */
    out[0] = t4;
    out[1] = t23;
    out[2] = t38;
    out[3] = t50;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = p[7]*t2; /* R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t5 = t4*p[4]; /* b*I3 */
    const double t6 = JLT_FMA(t4, t5, t3); /* K = b*b*I3 + R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t7 = JLT_FMA(t2, p[9], p[3]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t8 = JLT_FMA(t6, p[0], p[10]); /* Theta = K*m + I1*I3 */
    const double t9 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t10 = t6*t7; /* K*D */
    const double t11 = t9*t10; /* s*K*D */
    const double t12 = t8*t11; /* Theta*s*K*D */
    const double t13 = 1.0/t12; /* 1/(Theta*s*K*D) */
    const double t14 = t8*t13; /* Theta*1/(Theta*s*K*D) */
    const double t15 = t7*t14; /* D*Theta*1/(Theta*s*K*D) */
    const double t16 = t6*t15; /* K*D*Theta*1/(Theta*s*K*D) */
    const double t17 = x[0]*t16; /* gamma3*K*D*Theta*1/(Theta*s*K*D) */
    const double t18 = x[2]*t17; /* omega_tau*gamma3*K*D*Theta*1/(Theta*s*K*D) */
    const double t19 = -t18; /* -omega_tau*gamma3*K*D*Theta*1/(Theta*s*K*D) */
    const double t20 = t9*p[8]; /* s*R*G */
    const double t21 = JLT_FMA(t5, x[3], t20); /* b*I3*v_tau + s*R*G */
    const double t22 = t16*t21; /* K*D*Theta*1/(Theta*s*K*D)*(b*I3*v_tau + s*R*G) */
    const double t23 = x[0]*p[17]; /* gamma3*2*R^2*I1 */
    const double t24 = JLT_FMS(t4, p[18], t23); /* d(K)/d(gamma3) = b*2*R*I3 - gamma3*2*R^2*I1 */
    const double t25 = t9*t15; /* s*D*Theta*1/(Theta*s*K*D) */
    const double t26 = t21*t25; /* (b*I3*v_tau + s*R*G)*s*D*Theta*1/(Theta*s*K*D) */
    const double t27 = t17*p[8]; /* gamma3*K*D*Theta*1/(Theta*s*K*D)*R*G */
    const double t28 = JLT_FNMA(x[3], p[19], t27); /* gamma3*K*D*Theta*1/(Theta*s*K*D)*R*G - v_tau*R*I3 */
    const double t29 = JLT_FMA(t24, t26, t28); /* d(K)/d(gamma3)*(b*I3*v_tau + s*R*G)*s*D*Theta*1/(Theta*s*K*D) + gamma3*K*D*Theta*1/(Theta*s*K*D)*R*G - v_tau*R*I3 */
    const double t30 = JLT_FMS(t17, t22, t29); /* gamma3*K*D*Theta*1/(Theta*s*K*D)*K*D*Theta*1/(Theta*s*K*D)*(b*I3*v_tau + s*R*G) - t29 */
    const double t31 = t15*x[3]; /* D*Theta*1/(Theta*s*K*D)*v_tau */
    const double t32 = t30*t31; /* t30*D*Theta*1/(Theta*s*K*D)*v_tau */
    const double t33 = t15*t21; /* D*Theta*1/(Theta*s*K*D)*(b*I3*v_tau + s*R*G) */
    const double t34 = JLT_FMA(t5, t31, t33); /* b*I3*D*Theta*1/(Theta*s*K*D)*v_tau + D*Theta*1/(Theta*s*K*D)*(b*I3*v_tau + s*R*G) */
    const double t35 = t9*t14; /* s*Theta*1/(Theta*s*K*D) */
    const double t36 = t6*t35; /* K*s*Theta*1/(Theta*s*K*D) */
    const double t37 = x[0]*t36; /* gamma3*K*s*Theta*1/(Theta*s*K*D) */
    const double t38 = t37*p[20]; /* gamma3*K*s*Theta*1/(Theta*s*K*D)*2*m*a3^2 */
    const double t39 = JLT_FMA(t37, t38, t36); /* gamma3*K*s*Theta*1/(Theta*s*K*D)*gamma3*K*s*Theta*1/(Theta*s*K*D)*2*m*a3^2 + K*s*Theta*1/(Theta*s*K*D) */
    const double t40 = t9*t39; /* s*t39 */
    const double t41 = JLT_FNMA(t17, t37, t40); /* s*t39 - gamma3*K*D*Theta*1/(Theta*s*K*D)*gamma3*K*s*Theta*1/(Theta*s*K*D) */
    const double t42 = x[2]*p[9]; /* omega_tau*m*a3^2 */
    const double t43 = x[2]*t42; /* omega_tau*omega_tau*m*a3^2 */
    const double t44 = t9*p[20]; /* s*2*m*a3^2 */
    const double t45 = JLT_FMS(t36, t44, t16); /* K*s*Theta*1/(Theta*s*K*D)*s*2*m*a3^2 - K*D*Theta*1/(Theta*s*K*D) */
    const double t46 = t37*p[21]; /* gamma3*K*s*Theta*1/(Theta*s*K*D)*m*g*a3 */
    const double t47 = t45*t46; /* t45*gamma3*K*s*Theta*1/(Theta*s*K*D)*m*g*a3 */
    const double t48 = t33*t37; /* D*Theta*1/(Theta*s*K*D)*(b*I3*v_tau + s*R*G)*gamma3*K*s*Theta*1/(Theta*s*K*D) */
    const double t49 = t17*t48; /* gamma3*K*D*Theta*1/(Theta*s*K*D)*t48 */
    const double t50 = JLT_FMA(t26, t39, t49); /* (b*I3*v_tau + s*R*G)*s*D*Theta*1/(Theta*s*K*D)*t39 + gamma3*K*D*Theta*1/(Theta*s*K*D)*t48 */
    const double t51 = p[3]*t33; /* I1*D*Theta*1/(Theta*s*K*D)*(b*I3*v_tau + s*R*G) */
    const double t52 = t25*t48; /* s*D*Theta*1/(Theta*s*K*D)*t48 */
    const double t53 = p[22]*t52; /* 2*I1*s*D*Theta*1/(Theta*s*K*D)*t48 */
    const double t54 = x[3]*p[14]; /* v_tau*R*I1 */
    const double t55 = t9*t54; /* s*v_tau*R*I1 */
    const double t56 = JLT_FNMA(t4, p[6], t55); /* s*v_tau*R*I1 - b*G */
    const double t57 = t25*t56; /* s*D*Theta*1/(Theta*s*K*D)*(s*v_tau*R*I1 - b*G) */
    const double t58 = t24*t57; /* d(K)/d(gamma3)*s*D*Theta*1/(Theta*s*K*D)*(s*v_tau*R*I1 - b*G) */
    const double t59 = JLT_FMA(t17, t54, p[8]); /* gamma3*K*D*Theta*1/(Theta*s*K*D)*v_tau*R*I1 + R*G */
    const double t60 = JLT_FMA(2.0, t58, t59); /* 2*t58 + gamma3*K*D*Theta*1/(Theta*s*K*D)*v_tau*R*I1 + R*G */
    const double t61 = t26*t35; /* (b*I3*v_tau + s*R*G)*s*D*Theta*1/(Theta*s*K*D)*s*Theta*1/(Theta*s*K*D) */
    const double t62 = t60*t61; /* (2*t58 + gamma3*K*D*Theta*1/(Theta*s*K*D)*v_tau*R*I1 + R*G)*t61 */
    const double t63 = t35*t57; /* s*Theta*1/(Theta*s*K*D)*s*D*Theta*1/(Theta*s*K*D)*(s*v_tau*R*I1 - b*G) */
    const double t64 = JLT_FMS(t21, t38, t28); /* (b*I3*v_tau + s*R*G)*gamma3*K*s*Theta*1/(Theta*s*K*D)*2*m*a3^2 - (gamma3*K*D*Theta*1/(Theta*s*K*D)*R*G - v_tau*R*I3) */
    const double t65 = JLT_FNMA(t63, t64, t62); /* t62 - t63*t64 */
    const double t66 = JLT_FMS(t29, t53, t47); /* t29*2*I1*s*D*Theta*1/(Theta*s*K*D)*t48 - t45*gamma3*K*s*Theta*1/(Theta*s*K*D)*m*g*a3 */
    const double t67 = JLT_FMA(t41, t43, t66); /* t41*omega_tau*omega_tau*m*a3^2 + t66 */
    const double t68 = JLT_FNMA(t50, t51, t67); /* t41*omega_tau*omega_tau*m*a3^2 + t66 - t50*I1*D*Theta*1/(Theta*s*K*D)*(b*I3*v_tau + s*R*G) */
    const double t69 = JLT_FMA(p[4], t65, t68); /* I3*(t62 - t63*t64) + t68 */
    const double t70 = x[2]*t9; /* omega_tau*s */
    const double t71 = t38*t70; /* gamma3*K*s*Theta*1/(Theta*s*K*D)*2*m*a3^2*omega_tau*s */
    const double t72 = t4*p[23]; /* b*2*I1*I3 */
    const double t73 = t4*p[24]; /* b*I3^2 */
    const double t74 = t63*t73; /* t63*b*I3^2 */
    const double t75 = t9*p[25]; /* s*R*I1*I3 */
    const double t76 = JLT_FMA(t61, t75, t74); /* t61*s*R*I1*I3 + t63*b*I3^2 */
    const double t77 = JLT_FMA(t52, t72, t76); /* s*D*Theta*1/(Theta*s*K*D)*t48*b*2*I1*I3 + t61*s*R*I1*I3 + t63*b*I3^2 */
    const double t78 = -t77; /* -t77 */
    const double t79 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t80 = JLT_FMA(x[2], t79, x[1]); /* V = omega_tau*e + v_nu */
    const double t81 = t11*t13; /* s*K*D*1/(Theta*s*K*D) */
    const double t82 = t80*t81; /* V*s*K*D*1/(Theta*s*K*D) */
    const double t83 = JLT_FNMA(p[10], t82, x[1]); /* v_nu - I1*I3*V*s*K*D*1/(Theta*s*K*D) */
    const double t84 = t15*t83; /* D*Theta*1/(Theta*s*K*D)*(v_nu - I1*I3*V*s*K*D*1/(Theta*s*K*D)) */
    const double t85 = t30*t84; /* t30*t84 */
    const double t86 = t33*t81; /* D*Theta*1/(Theta*s*K*D)*(b*I3*v_tau + s*R*G)*s*K*D*1/(Theta*s*K*D) */
    const double t87 = t24*p[26]; /* d(K)/d(gamma3)*m*I1*I3 */
    const double t88 = t82*t87; /* V*s*K*D*1/(Theta*s*K*D)*d(K)/d(gamma3)*m*I1*I3 */
    const double t89 = x[2]*t81; /* omega_tau*s*K*D*1/(Theta*s*K*D) */
    const double t90 = t57*p[15]; /* s*D*Theta*1/(Theta*s*K*D)*(s*v_tau*R*I1 - b*G)*R*(I1 - I3) */
    const double t91 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t92 = t58 + t59; /* t58 + gamma3*K*D*Theta*1/(Theta*s*K*D)*v_tau*R*I1 + R*G */
    const double t93 = t25*t92; /* s*D*Theta*1/(Theta*s*K*D)*(t58 + gamma3*K*D*Theta*1/(Theta*s*K*D)*v_tau*R*I1 + R*G) */
    const double t94 = p[0]*t81; /* m*s*K*D*1/(Theta*s*K*D) */
    const double t95 = JLT_FMA(t58, t94, t93); /* t58*m*s*K*D*1/(Theta*s*K*D) + t93 */
    const double t96 = JLT_FNMA(t33, p[27], t90); /* s*D*Theta*1/(Theta*s*K*D)*(s*v_tau*R*I1 - b*G)*R*(I1 - I3) - D*Theta*1/(Theta*s*K*D)*(b*I3*v_tau + s*R*G)*I1*a3 */
    const double t97 = JLT_FNMA(t91, t95, t96); /* t96 - (gamma3*R*(I1 - I3) - I3*a3)*(t58*m*s*K*D*1/(Theta*s*K*D) + t93) */
    const double t98 = p[4]*t89; /* I3*omega_tau*s*K*D*1/(Theta*s*K*D) */
    const double t99 = JLT_FMA(t86, t88, t85); /* t86*V*s*K*D*1/(Theta*s*K*D)*d(K)/d(gamma3)*m*I1*I3 + t30*t84 */
    const double t100 = JLT_FMA(t97, t98, t99); /* t97*I3*omega_tau*s*K*D*1/(Theta*s*K*D) + t86*V*s*K*D*1/(Theta*s*K*D)*d(K)/d(gamma3)*m*I1*I3 + t30*t84 */
    const double t101 = -t100; /* -t100 */
    const double t102 = p[10]*t86; /* I1*I3*t86 */
    const double t103 = t102 - t33; /* I1*I3*t86 - D*Theta*1/(Theta*s*K*D)*(b*I3*v_tau + s*R*G) */
    const double t104 = t79*t102; /* e*I1*I3*t86 */
    const double t105 = p[4]*t91; /* I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t106 = t81*t105; /* s*K*D*1/(Theta*s*K*D)*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t107 = JLT_FNMA(t57, t106, t104); /* e*I1*I3*t86 - s*D*Theta*1/(Theta*s*K*D)*(s*v_tau*R*I1 - b*G)*s*K*D*1/(Theta*s*K*D)*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t108 = t5*t84; /* b*I3*t84 */
    const double t109 = t75*t91; /* s*R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t110 = t89*t109; /* omega_tau*s*K*D*1/(Theta*s*K*D)*s*R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t111 = JLT_FMA(t25, t110, t108); /* s*D*Theta*1/(Theta*s*K*D)*t110 + b*I3*t84 */
    const double t112 = -t111; /* -(s*D*Theta*1/(Theta*s*K*D)*t110 + b*I3*t84) */
    out[0] = t19;
    out[1] = 0.0;
    out[2] = t9;
    out[3] = 0.0;
    out[4] = t32;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t34;
    out[8] = t69;
    out[9] = 0.0;
    out[10] = t71;
    out[11] = t78;
    out[12] = t101;
    out[13] = t103;
    out[14] = t107;
    out[15] = t112;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = t3*p[8]; /* s*R*G */
    const double t6 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t7 = p[4]*t6; /* I3*b */
    const double t8 = JLT_FMA(x[3], t7, t5); /* v_tau*I3*b + s*R*G */
    const double t9 = JLT_FMA(t2, p[9], p[3]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t10 = t2*p[7]; /* (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t11 = JLT_FMA(t6, t7, t10); /* K = b*I3*b + (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t12 = JLT_FMA(p[0], t11, p[10]); /* Theta = m*K + I1*I3 */
    const double t13 = t9*t11; /* D*K */
    const double t14 = t3*t13; /* s*D*K */
    const double t15 = t12*t14; /* Theta*s*D*K */
    const double t16 = 1.0/t15; /* 1/(Theta*s*D*K) */
    const double t17 = t12*t16; /* Theta*1/(Theta*s*D*K) */
    const double t18 = t9*t17; /* D*Theta*1/(Theta*s*D*K) */
    const double t19 = t3*t18; /* s*D*Theta*1/(Theta*s*D*K) */
    const double t20 = t8*t19; /* (v_tau*I3*b + s*R*G)*s*D*Theta*1/(Theta*s*D*K) */
    const double t21 = t11*t18; /* K*D*Theta*1/(Theta*s*D*K) */
    const double t22 = t20*t21; /* (v_tau*I3*b + s*R*G)*s*D*Theta*1/(Theta*s*D*K)*K*D*Theta*1/(Theta*s*D*K) */
    const double t23 = x[3]*t22; /* v_tau*t22 */
    const double t24 = t3*t11; /* s*K */
    const double t25 = t17*t24; /* Theta*1/(Theta*s*D*K)*s*K */
    const double t26 = x[0]*t25; /* gamma3*Theta*1/(Theta*s*D*K)*s*K */
    const double t27 = x[2]*p[9]; /* omega_tau*m*a3^2 */
    const double t28 = t4*t27; /* omega_tau*s*omega_tau*m*a3^2 */
    const double t29 = t26*t28; /* gamma3*Theta*1/(Theta*s*D*K)*s*K*omega_tau*s*omega_tau*m*a3^2 */
    const double t30 = t3*t25; /* s*Theta*1/(Theta*s*D*K)*s*K */
    const double t31 = x[3]*p[14]; /* v_tau*R*I1 */
    const double t32 = t3*t31; /* s*v_tau*R*I1 */
    const double t33 = JLT_FNMA(t6, p[6], t32); /* s*v_tau*R*I1 - b*G */
    const double t34 = t19*t33; /* s*D*Theta*1/(Theta*s*D*K)*(s*v_tau*R*I1 - b*G) */
    const double t35 = t25*t34; /* Theta*1/(Theta*s*D*K)*s*K*s*D*Theta*1/(Theta*s*D*K)*(s*v_tau*R*I1 - b*G) */
    const double t36 = t22*t26; /* t22*gamma3*Theta*1/(Theta*s*D*K)*s*K */
    const double t37 = JLT_FMA(p[13], t35, t36); /* I3/I1*t35 + t22*gamma3*Theta*1/(Theta*s*D*K)*s*K */
    const double t38 = t20*t37; /* (v_tau*I3*b + s*R*G)*s*D*Theta*1/(Theta*s*D*K)*(I3/I1*t35 + t22*gamma3*Theta*1/(Theta*s*D*K)*s*K) */
    const double t39 = JLT_FNMA(p[21], t30, t29); /* t29 - m*g*a3*s*Theta*1/(Theta*s*D*K)*s*K */
    const double t40 = JLT_FNMA(p[3], t38, t39); /* t29 - m*g*a3*s*Theta*1/(Theta*s*D*K)*s*K - I1*t38 */
    const double t41 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t42 = t14*t16; /* s*D*K*1/(Theta*s*D*K) */
    const double t43 = x[2]*t42; /* omega_tau*s*D*K*1/(Theta*s*D*K) */
    const double t44 = t41*t43; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*s*D*K*1/(Theta*s*D*K) */
    const double t45 = t34*t44; /* s*D*Theta*1/(Theta*s*D*K)*(s*v_tau*R*I1 - b*G)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*s*D*K*1/(Theta*s*D*K) */
    const double t46 = p[4]*t45; /* I3*t45 */
    const double t47 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t48 = JLT_FMA(x[2], t47, x[1]); /* V = omega_tau*e + v_nu */
    const double t49 = p[10]*t42; /* I1*I3*s*D*K*1/(Theta*s*D*K) */
    const double t50 = JLT_FNMA(t48, t49, x[1]); /* v_nu - V*I1*I3*s*D*K*1/(Theta*s*D*K) */
    const double t51 = JLT_FMA(t22, t50, t46); /* t22*(v_nu - V*I1*I3*s*D*K*1/(Theta*s*D*K)) + I3*t45 */
    const double t52 = -t51; /* -(t22*(v_nu - V*I1*I3*s*D*K*1/(Theta*s*D*K)) + I3*t45) */
    const double t53 = x[0]*t21; /* gamma3*K*D*Theta*1/(Theta*s*D*K) */
    const double t54 = x[2]*t53; /* omega_tau*gamma3*K*D*Theta*1/(Theta*s*D*K) */
    const double t55 = -t54; /* -omega_tau*gamma3*K*D*Theta*1/(Theta*s*D*K) */
    const double t56 = t22*t53; /* t22*gamma3*K*D*Theta*1/(Theta*s*D*K) */
    const double t57 = p[8]*t53; /* R*G*gamma3*K*D*Theta*1/(Theta*s*D*K) */
    const double t58 = JLT_FNMA(x[3], p[19], t57); /* R*G*gamma3*K*D*Theta*1/(Theta*s*D*K) - v_tau*R*I3 */
    const double t59 = JLT_FNMA(t19, t58, t56); /* t22*gamma3*K*D*Theta*1/(Theta*s*D*K) - s*D*Theta*1/(Theta*s*D*K)*(R*G*gamma3*K*D*Theta*1/(Theta*s*D*K) - v_tau*R*I3) */
    const double t60 = t21*t59; /* K*D*Theta*1/(Theta*s*D*K)*t59 */
    const double t61 = x[0]*p[17]; /* gamma3*2*R^2*I1 */
    const double t62 = JLT_FMS(t6, p[18], t61); /* d(K)/d(gamma3) = b*2*R*I3 - gamma3*2*R^2*I1 */
    const double t63 = t19*t62; /* s*D*Theta*1/(Theta*s*D*K)*d(K)/d(gamma3) */
    const double t64 = JLT_FNMA(t22, t63, t60); /* K*D*Theta*1/(Theta*s*D*K)*t59 - t22*s*D*Theta*1/(Theta*s*D*K)*d(K)/d(gamma3) */
    const double t65 = x[3]*t64; /* v_tau*t64 */
    const double t66 = p[4]*t19; /* I3*s*D*Theta*1/(Theta*s*D*K) */
    const double t67 = t6*t21; /* b*K*D*Theta*1/(Theta*s*D*K) */
    const double t68 = t66*t67; /* I3*s*D*Theta*1/(Theta*s*D*K)*b*K*D*Theta*1/(Theta*s*D*K) */
    const double t69 = JLT_FMA(x[3], t68, t22); /* v_tau*I3*s*D*Theta*1/(Theta*s*D*K)*b*K*D*Theta*1/(Theta*s*D*K) + t22 */
    const double t70 = t26*t54; /* gamma3*Theta*1/(Theta*s*D*K)*s*K*omega_tau*gamma3*K*D*Theta*1/(Theta*s*D*K) */
    const double t71 = t26*p[20]; /* gamma3*Theta*1/(Theta*s*D*K)*s*K*2*m*a3^2 */
    const double t72 = JLT_FMA(t26, t71, t25); /* gamma3*Theta*1/(Theta*s*D*K)*s*K*gamma3*Theta*1/(Theta*s*D*K)*s*K*2*m*a3^2 + Theta*1/(Theta*s*D*K)*s*K */
    const double t73 = JLT_FNMA(t4, t72, t70); /* t70 - omega_tau*s*t72 */
    const double t74 = JLT_FNMA(t30, p[20], t21); /* K*D*Theta*1/(Theta*s*D*K) - s*Theta*1/(Theta*s*D*K)*s*K*2*m*a3^2 */
    const double t75 = t26*p[21]; /* gamma3*Theta*1/(Theta*s*D*K)*s*K*m*g*a3 */
    const double t76 = t74*t75; /* t74*gamma3*Theta*1/(Theta*s*D*K)*s*K*m*g*a3 */
    const double t77 = t20*t72; /* (v_tau*I3*b + s*R*G)*s*D*Theta*1/(Theta*s*D*K)*t72 */
    const double t78 = JLT_FMA(t36, t53, t77); /* t22*gamma3*Theta*1/(Theta*s*D*K)*s*K*gamma3*K*D*Theta*1/(Theta*s*D*K) + (v_tau*I3*b + s*R*G)*s*D*Theta*1/(Theta*s*D*K)*t72 */
    const double t79 = p[3]*t22; /* I1*t22 */
    const double t80 = t38*t62; /* t38*d(K)/d(gamma3) */
    const double t81 = JLT_FMA(t36, t58, t80); /* t22*gamma3*Theta*1/(Theta*s*D*K)*s*K*(R*G*gamma3*K*D*Theta*1/(Theta*s*D*K) - v_tau*R*I3) + t38*d(K)/d(gamma3) */
    const double t82 = t19*p[22]; /* s*D*Theta*1/(Theta*s*D*K)*2*I1 */
    const double t83 = t58*t66; /* (R*G*gamma3*K*D*Theta*1/(Theta*s*D*K) - v_tau*R*I3)*I3*s*D*Theta*1/(Theta*s*D*K) */
    const double t84 = t26*p[28]; /* gamma3*Theta*1/(Theta*s*D*K)*s*K*2*m*I3*a3^2 */
    const double t85 = JLT_FNMA(t20, t84, t83); /* t83 - (v_tau*I3*b + s*R*G)*s*D*Theta*1/(Theta*s*D*K)*gamma3*Theta*1/(Theta*s*D*K)*s*K*2*m*I3*a3^2 */
    const double t86 = JLT_FMA(t31, t53, p[8]); /* v_tau*R*I1*gamma3*K*D*Theta*1/(Theta*s*D*K) + R*G */
    const double t87 = t66*t86; /* I3*s*D*Theta*1/(Theta*s*D*K)*(v_tau*R*I1*gamma3*K*D*Theta*1/(Theta*s*D*K) + R*G) */
    const double t88 = t20*t25; /* (v_tau*I3*b + s*R*G)*s*D*Theta*1/(Theta*s*D*K)*Theta*1/(Theta*s*D*K)*s*K */
    const double t89 = JLT_FMA(t87, t88, t76); /* t87*t88 + t74*gamma3*Theta*1/(Theta*s*D*K)*s*K*m*g*a3 */
    const double t90 = JLT_FNMA(t27, t73, t89); /* t87*t88 + t74*gamma3*Theta*1/(Theta*s*D*K)*s*K*m*g*a3 - omega_tau*m*a3^2*(t70 - omega_tau*s*t72) */
    const double t91 = JLT_FNMA(t78, t79, t90); /* t90 - t78*I1*t22 */
    const double t92 = JLT_FMA(t35, t85, t91); /* t35*t85 + t90 - t78*I1*t22 */
    const double t93 = JLT_FMA(t81, t82, t92); /* t81*s*D*Theta*1/(Theta*s*D*K)*2*I1 + t35*t85 + t90 - t78*I1*t22 */
    const double t94 = t4*t71; /* omega_tau*s*gamma3*Theta*1/(Theta*s*D*K)*s*K*2*m*a3^2 */
    const double t95 = p[4]*t35; /* I3*t35 */
    const double t96 = JLT_FMA(t36, p[22], t95); /* t22*gamma3*Theta*1/(Theta*s*D*K)*s*K*2*I1 + I3*t35 */
    const double t97 = t7*t19; /* I3*b*s*D*Theta*1/(Theta*s*D*K) */
    const double t98 = t96*t97; /* (t22*gamma3*Theta*1/(Theta*s*D*K)*s*K*2*I1 + I3*t35)*I3*b*s*D*Theta*1/(Theta*s*D*K) */
    const double t99 = t19*p[25]; /* s*D*Theta*1/(Theta*s*D*K)*R*I1*I3 */
    const double t100 = t20*t30; /* (v_tau*I3*b + s*R*G)*s*D*Theta*1/(Theta*s*D*K)*s*Theta*1/(Theta*s*D*K)*s*K */
    const double t101 = JLT_FMA(t99, t100, t98); /* s*D*Theta*1/(Theta*s*D*K)*R*I1*I3*t100 + t98 */
    const double t102 = -t101; /* -(s*D*Theta*1/(Theta*s*D*K)*R*I1*I3*t100 + t98) */
    const double t103 = t19*t51; /* s*D*Theta*1/(Theta*s*D*K)*(t22*(v_nu - V*I1*I3*s*D*K*1/(Theta*s*D*K)) + I3*t45) */
    const double t104 = t42*t48; /* s*D*K*1/(Theta*s*D*K)*V */
    const double t105 = JLT_FMS(t79, t104, t45); /* I1*t22*s*D*K*1/(Theta*s*D*K)*V - t45 */
    const double t106 = t42*p[29]; /* s*D*K*1/(Theta*s*D*K)*m*I3 */
    const double t107 = JLT_FNMA(t105, t106, t103); /* t103 - (I1*t22*s*D*K*1/(Theta*s*D*K)*V - t45)*s*D*K*1/(Theta*s*D*K)*m*I3 */
    const double t108 = t43*p[30]; /* omega_tau*s*D*K*1/(Theta*s*D*K)*I1*I3*a3 */
    const double t109 = t22*t108; /* t22*omega_tau*s*D*K*1/(Theta*s*D*K)*I1*I3*a3 */
    const double t110 = t43*p[31]; /* omega_tau*s*D*K*1/(Theta*s*D*K)*R*I3*(I1 - I3) */
    const double t111 = JLT_FNMA(t34, t110, t109); /* t22*omega_tau*s*D*K*1/(Theta*s*D*K)*I1*I3*a3 - s*D*Theta*1/(Theta*s*D*K)*(s*v_tau*R*I1 - b*G)*omega_tau*s*D*K*1/(Theta*s*D*K)*R*I3*(I1 - I3) */
    const double t112 = JLT_FMA(t44, t87, t111); /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*s*D*K*1/(Theta*s*D*K)*t87 + t111 */
    const double t113 = JLT_FNMA(t50, t60, t112); /* t112 - (v_nu - V*I1*I3*s*D*K*1/(Theta*s*D*K))*K*D*Theta*1/(Theta*s*D*K)*t59 */
    const double t114 = JLT_FMA(t62, t107, t113); /* d(K)/d(gamma3)*t107 + t113 */
    const double t115 = t22*t49; /* t22*I1*I3*s*D*K*1/(Theta*s*D*K) */
    const double t116 = t115 - t22; /* t22*I1*I3*s*D*K*1/(Theta*s*D*K) - t22 */
    const double t117 = t47*t115; /* e*t22*I1*I3*s*D*K*1/(Theta*s*D*K) */
    const double t118 = p[4]*t41; /* I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t119 = t42*t118; /* s*D*K*1/(Theta*s*D*K)*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t120 = JLT_FNMA(t34, t119, t117); /* e*t22*I1*I3*s*D*K*1/(Theta*s*D*K) - s*D*Theta*1/(Theta*s*D*K)*(s*v_tau*R*I1 - b*G)*s*D*K*1/(Theta*s*D*K)*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t121 = t50*t68; /* (v_nu - V*I1*I3*s*D*K*1/(Theta*s*D*K))*I3*s*D*Theta*1/(Theta*s*D*K)*b*K*D*Theta*1/(Theta*s*D*K) */
    const double t122 = t3*t44; /* s*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*s*D*K*1/(Theta*s*D*K) */
    const double t123 = JLT_FMA(t99, t122, t121); /* s*D*Theta*1/(Theta*s*D*K)*R*I1*I3*t122 + t121 */
    const double t124 = -t123; /* -(s*D*Theta*1/(Theta*s*D*K)*R*I1*I3*t122 + t121) */
    out[0] = t4;
    out[1] = t23;
    out[2] = t40;
    out[3] = t52;
    out[4] = t55;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t65;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t69;
    out[12] = t93;
    out[13] = 0.0;
    out[14] = t94;
    out[15] = t102;
    out[16] = t114;
    out[17] = t116;
    out[18] = t120;
    out[19] = t124;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = t2*p[7]; /* (1 - gamma3)*(gamma3 + 1)*R^2*I1 */
    const double t5 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t6 = t5*p[4]; /* b*I3 */
    const double t7 = JLT_FMA(t5, t6, t4); /* K = b*b*I3 + (1 - gamma3)*(gamma3 + 1)*R^2*I1 */
    const double t8 = JLT_FMA(t7, p[0], p[10]); /* Theta = K*m + I1*I3 */
    const double t9 = JLT_FMA(t2, p[9], p[3]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t10 = t7*t9; /* K*D */
    const double t11 = t3*t10; /* s*K*D */
    const double t12 = t8*t11; /* Theta*s*K*D */
    const double t13 = 1.0/t12; /* 1/(Theta*s*K*D) */
    const double t14 = t8*t13; /* Theta*1/(Theta*s*K*D) */
    const double t15 = t7*t14; /* K*Theta*1/(Theta*s*K*D) */
    const double t16 = p[20]*t3; /* 2*m*a3^2*s */
    const double t17 = t3*t16; /* s*2*m*a3^2*s */
    const double t18 = t9*t15; /* D*K*Theta*1/(Theta*s*K*D) */
    const double t19 = JLT_FMS(t15, t17, t18); /* K*Theta*1/(Theta*s*K*D)*s*2*m*a3^2*s - D*K*Theta*1/(Theta*s*K*D) */
    const double t20 = x[0]*t19; /* gamma3*t19 */
    const double t21 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t22 = t3*t9; /* s*D */
    const double t23 = t14*t22; /* Theta*1/(Theta*s*K*D)*s*D */
    const double t24 = t11*t13; /* s*K*D*1/(Theta*s*K*D) */
    const double t25 = p[25]*t21; /* R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t26 = t3*t25; /* s*R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t27 = t24*t26; /* s*K*D*1/(Theta*s*K*D)*s*R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t28 = JLT_FNMA(t23, t27, t20); /* gamma3*t19 - Theta*1/(Theta*s*K*D)*s*D*s*K*D*1/(Theta*s*K*D)*s*R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t29 = x[2]*t28; /* omega_tau*t28 */
    const double t30 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t31 = JLT_FMA(x[2], t30, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = p[10]*t31; /* I1*I3*V */
    const double t33 = JLT_FNMA(t24, t32, x[1]); /* v_nu - s*K*D*1/(Theta*s*K*D)*I1*I3*V */
    const double t34 = t6*t23; /* b*I3*Theta*1/(Theta*s*K*D)*s*D */
    const double t35 = t33*t34; /* (v_nu - s*K*D*1/(Theta*s*K*D)*I1*I3*V)*b*I3*Theta*1/(Theta*s*K*D)*s*D */
    const double t36 = JLT_FNMA(t18, t35, t29); /* omega_tau*t28 - D*K*Theta*1/(Theta*s*K*D)*t35 */
    out[0] = t36;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[21]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = p[32]*x[1]; /* 1/2*m*v_nu */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(p[9], t4, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t7 = t5*t6; /* D*omega_tau*omega_tau */
    const double t8 = t4*p[7]; /* (1 - gamma3)*(gamma3 + 1)*R^2*I1 */
    const double t9 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t10 = p[4]*t9; /* I3*b */
    const double t11 = JLT_FMA(t9, t10, t8); /* K = b*I3*b + (1 - gamma3)*(gamma3 + 1)*R^2*I1 */
    const double t12 = 1.0/t11; /* 1/K */
    const double t13 = JLT_FMA(t11, p[0], p[10]); /* Theta = K*m + I1*I3 */
    const double t14 = x[3]*x[3]; /* v_tau*v_tau */
    const double t15 = JLT_FMA(t13, t14, p[33]); /* Theta*v_tau*v_tau + G^2 */
    const double t16 = JLT_FMA(t12, t15, t7); /* 1/K*(Theta*v_tau*v_tau + G^2) + D*omega_tau*omega_tau */
    const double t17 = JLT_FMA(x[1], t1, t0); /* v_nu*1/2*m*v_nu + m*g*a3*gamma3 */
    const double t18 = JLT_FMA((1.0 / 2.0), t16, t17); /* 1/2*(1/K*(Theta*v_tau*v_tau + G^2) + D*omega_tau*omega_tau) + v_nu*1/2*m*v_nu + m*g*a3*gamma3 */
    out[0] = t18;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[9]*x[0]; /* m*a3^2*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = x[0]*p[17]; /* gamma3*2*R^2*I1 */
    const double t3 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t4 = JLT_FMS(p[18], t3, t2); /* d(K)/d(gamma3) = 2*R*I3*b - gamma3*2*R^2*I1 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = x[0] + 1.0; /* gamma3 + 1 */
    const double t7 = t5*t6; /* (1 - gamma3)*(gamma3 + 1) */
    const double t8 = p[7]*t7; /* R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t9 = t3*p[4]; /* b*I3 */
    const double t10 = JLT_FMA(t3, t9, t8); /* K = b*b*I3 + R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t11 = 1.0/t10; /* 1/K */
    const double t12 = p[34]*t11; /* G^2/m*1/K */
    const double t13 = t11*t12; /* 1/K*G^2/m*1/K */
    const double t14 = t11*x[3]; /* 1/K*v_tau */
    const double t15 = JLT_FMA(t10, p[0], p[10]); /* Theta = K*m + I1*I3 */
    const double t16 = t14*t15; /* 1/K*v_tau*Theta */
    const double t17 = JLT_FNMA(p[35], t16, x[3]); /* v_tau - 1/m*1/K*v_tau*Theta */
    const double t18 = JLT_FNMA(t14, t17, t13); /* 1/K*G^2/m*1/K - 1/K*v_tau*(v_tau - 1/m*1/K*v_tau*Theta) */
    const double t19 = p[32]*t4; /* 1/2*m*d(K)/d(gamma3) */
    const double t20 = JLT_FNMA(t0, t1, p[21]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t21 = JLT_FNMA(t18, t19, t20); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau - (1/K*G^2/m*1/K - 1/K*v_tau*(v_tau - 1/m*1/K*v_tau*Theta))*1/2*m*d(K)/d(gamma3) */
    const double t22 = p[0]*x[1]; /* m*v_nu */
    const double t23 = JLT_FMA(p[9], t7, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t24 = x[2]*t23; /* omega_tau*D */
    out[0] = t21;
    out[1] = t22;
    out[2] = t24;
    out[3] = t16;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
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
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
    double t68[JLT_JET_ORDER_MAX + 1];
    double t69[JLT_JET_ORDER_MAX + 1];
    double t70[JLT_JET_ORDER_MAX + 1];
    double t71[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t10[k] = t5[k]*p[7];
        t13[k] = x0[k]*p[1] + (k == 0 ? p[5] : 0);
        t15[k] = t13[k]*p[4];
        t16[k] = jlt_jet_product(t13, t15, k) + t10[k];
        t18[k] = t6[k]*p[8];
        t19[k] = jlt_jet_product(x3, t15, k) + t18[k];
        t22[k] = t5[k]*p[9] + (k == 0 ? p[3] : 0);
        t25[k] = t16[k]*p[0] + (k == 0 ? p[10] : 0);
        t26[k] = jlt_jet_product(t16, t22, k);
        t27[k] = jlt_jet_product(t6, t26, k);
        t28[k] = jlt_jet_product(t25, t27, k);
        t29[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t28, t29, k);
        t30[k] = jlt_jet_product(t25, t29, k);
        t31[k] = jlt_jet_product(t22, t30, k);
        t32[k] = jlt_jet_product(t6, t31, k);
        t33[k] = jlt_jet_product(t19, t32, k);
        t34[k] = jlt_jet_product(t16, t31, k);
        t35[k] = jlt_jet_product(t33, t34, k);
        t36[k] = jlt_jet_product(x3, t35, k);
        t38[k] = x2[k]*p[11];
        t39[k] = jlt_jet_product(x0, t38, k);
        t40[k] = jlt_jet_product(t7, t39, k);
        t42[k] = jlt_jet_product(x0, t35, k);
        t45[k] = x3[k]*p[14];
        t46[k] = jlt_jet_product(t6, t45, k);
        t48[k] = t46[k] - t13[k]*p[6];
        t49[k] = jlt_jet_product(t32, t48, k);
        t50[k] = p[13]*t49[k] + t42[k];
        t51[k] = t40[k] - t6[k]*p[12];
        t52[k] = t51[k] - jlt_jet_product(t33, t50, k);
        t53[k] = t16[k]*p[3];
        t54[k] = jlt_jet_product(t6, t53, k);
        t55[k] = jlt_jet_product(t30, t54, k);
        t56[k] = jlt_jet_product(t52, t55, k);
        t58[k] = x0[k]*p[5] + (k == 0 ? p[1] : 0);
        t59[k] = jlt_jet_product(x2, t58, k) + x1[k];
        t60[k] = jlt_jet_product(t27, t29, k);
        t61[k] = p[10]*t59[k];
        t62[k] = x1[k] - jlt_jet_product(t60, t61, k);
        t63[k] = jlt_jet_product(t35, t62, k);
        t66[k] = x0[k]*p[15] - (k == 0 ? p[16] : 0);
        t67[k] = x2[k]*p[4];
        t68[k] = jlt_jet_product(t66, t67, k);
        t69[k] = jlt_jet_product(t60, t68, k);
        t70[k] = jlt_jet_product(t49, t69, k) + t63[k];
        t71[k] = -t70[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t36[k]/(k + 1);
        next[2] = x2[k + 1] = t56[k]/(k + 1);
        next[3] = x3[k + 1] = t71[k]/(k + 1);
    }
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
    const double v_I3 = params[4];
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

static const unsigned char family0_is_free[] = { 1, 1, 0, 0 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
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

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[1]*params[6]; /* R*G */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = t1*t2; /* (gamma3 + 1)*(1 - gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((gamma3 + 1)*(1 - gamma3)) */
    const double t5 = t0*t4; /* R*G*s */
    const double t6 = x[0]*params[1]; /* gamma3*R */
    const double t7 = params[5] + t6; /* b = a3 + gamma3*R */
    const double t8 = params[4]*t7; /* I3*b */
    const double t9 = t5/t8; /* R*G*s/(I3*b) */
    const double t10 = -t9; /* v_tau = -R*G*s/(I3*b) */
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    out[3] = t10;
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[4]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I3*gamma3*v_nu */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = t4*t5; /* (1 + gamma3)*(1 - gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t8 = params[1]*params[1]; /* R*R */
    const double t9 = t8*params[3]; /* R*R*I1 */
    const double t10 = t7*t7; /* s*s */
    const double t11 = t9*t10; /* R*R*I1*s*s */
    const double t12 = params[1]*x[0]; /* R*gamma3 */
    const double t13 = params[5] + t12; /* b = a3 + R*gamma3 */
    const double t14 = t13*t13; /* b*b */
    const double t15 = params[4]*t14; /* I3*b*b */
    const double t16 = t11 + t15; /* K = R*R*I1*s*s + I3*b*b */
    const double t17 = params[0]*t16; /* m*K */
    const double t18 = params[4]*params[3]; /* I3*I1 */
    const double t19 = t17 + t18; /* Theta = m*K + I3*I1 */
    const double t20 = t7*t19; /* s*Theta */
    const double t21 = t3/t20; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t22 = -t21; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t22;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = t0*params[5]; /* m*g*a3 */
    const double t2 = params[1]*params[6]; /* R*G */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = t3*t4; /* (1 + gamma3)*(1 - gamma3) */
    const double t6 = sqrt(t5); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t7 = t2*t6; /* R*G*s */
    const double t8 = x[0]*params[1]; /* gamma3*R */
    const double t9 = params[5] + t8; /* b = a3 + gamma3*R */
    const double t10 = params[4]*t9; /* I3*b */
    const double t11 = t7/t10; /* R*G*s/(I3*b) */
    const double t12 = t11*t11; /* R*G*s/(I3*b)*R*G*s/(I3*b) */
    const double t13 = params[1]*params[1]; /* R*R */
    const double t14 = t13*params[3]; /* R*R*I1 */
    const double t15 = t6*t6; /* s*s */
    const double t16 = t14*t15; /* R*R*I1*s*s */
    const double t17 = t9*t9; /* b*b */
    const double t18 = params[4]*t17; /* I3*b*b */
    const double t19 = t16 + t18; /* K = R*R*I1*s*s + I3*b*b */
    const double t20 = t19*t19; /* K*K */
    const double t21 = params[0]*t19; /* m*K */
    const double t22 = params[4]*params[3]; /* I3*I1 */
    const double t23 = t21 + t22; /* Theta = m*K + I3*I1 */
    const double t24 = t12*t23; /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta */
    const double t25 = x[0]*t14; /* gamma3*R*R*I1 */
    const double t26 = t25*2.0; /* gamma3*R*R*I1*2 */
    const double t27 = params[1]*params[4]; /* R*I3 */
    const double t28 = t9*t27; /* b*R*I3 */
    const double t29 = 2.0*t28; /* 2*b*R*I3 */
    const double t30 = t29 - t26; /* d(K)/d(gamma3) = 2*b*R*I3 - gamma3*R*R*I1*2 */
    const double t31 = t24*t30; /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3) */
    const double t32 = t31/t20; /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3)/(K*K) */
    const double t33 = t32*(1.0 / 2.0); /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t34 = t1 - t33; /* m*g*a3 - R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t35 = params[0]*t12; /* m*R*G*s/(I3*b)*R*G*s/(I3*b) */
    const double t36 = t30*t35; /* d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b) */
    const double t37 = t36/t19; /* d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K */
    const double t38 = (1.0 / 2.0)*t37; /* 1/2*d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K */
    const double t39 = t34 + t38; /* t34 + 1/2*d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K */
    const double t40 = params[6]*params[6]; /* G*G */
    const double t41 = t30*t40; /* d(K)/d(gamma3)*G*G */
    const double t42 = t41/t20; /* d(K)/d(gamma3)*G*G/(K*K) */
    const double t43 = (1.0 / 2.0)*t42; /* 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t44 = t39 - t43; /* t34 + 1/2*d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K - 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t45 = params[0]*x[1]; /* m*v_nu */
    const double t46 = t11*t23; /* R*G*s/(I3*b)*Theta */
    const double t47 = t46/t19; /* R*G*s/(I3*b)*Theta/K */
    const double t48 = -t47; /* -R*G*s/(I3*b)*Theta/K */
    const double t49 = t19*t20; /* K*K*K */
    const double t50 = params[1]*params[3]; /* R*I1 */
    const double t51 = t11*t50; /* R*G*s/(I3*b)*R*I1 */
    const double t52 = t6*t51; /* s*R*G*s/(I3*b)*R*I1 */
    const double t53 = -t52; /* -s*R*G*s/(I3*b)*R*I1 */
    const double t54 = params[6]*t9; /* G*b */
    const double t55 = t53 - t54; /* -s*R*G*s/(I3*b)*R*I1 - G*b */
    const double t56 = t55*t55; /* (-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t57 = t23*t56; /* Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t58 = params[3] - params[4]; /* I1 - I3 */
    const double t59 = t57*t58; /* t57*(I1 - I3) */
    const double t60 = t30*t59; /* d(K)/d(gamma3)*t57*(I1 - I3) */
    const double t61 = t60/t49; /* d(K)/d(gamma3)*t57*(I1 - I3)/(K*K*K) */
    const double t62 = 2.0*t61; /* 2*d(K)/d(gamma3)*t57*(I1 - I3)/(K*K*K) */
    const double t63 = params[0]*t56; /* m*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t64 = t58*t63; /* (I1 - I3)*m*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t65 = t30*t64; /* d(K)/d(gamma3)*t64 */
    const double t66 = t65/t20; /* d(K)/d(gamma3)*t64/(K*K) */
    const double t67 = t66 - t62; /* d(K)/d(gamma3)*t64/(K*K) - 2*d(K)/d(gamma3)*t57*(I1 - I3)/(K*K*K) */
    const double t68 = t23*t55; /* Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t69 = t58*t68; /* (I1 - I3)*Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t70 = x[0]*t50; /* gamma3*R*I1 */
    const double t71 = t11*t70; /* R*G*s/(I3*b)*gamma3*R*I1 */
    const double t72 = t71/t6; /* R*G*s/(I3*b)*gamma3*R*I1/s */
    const double t73 = t2 - t72; /* R*G - R*G*s/(I3*b)*gamma3*R*I1/s */
    const double t74 = t69*t73; /* (I1 - I3)*Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(R*G - R*G*s/(I3*b)*gamma3*R*I1/s) */
    const double t75 = t74/t20; /* t74/(K*K) */
    const double t76 = 2.0*t75; /* 2*t74/(K*K) */
    const double t77 = t67 - t76; /* t67 - 2*t74/(K*K) */
    const double t78 = params[0]*2.0; /* m*2 */
    const double t79 = params[3]*params[3]; /* I1*I1 */
    const double t80 = t78*t79; /* m*2*I1*I1 */
    const double t81 = x[1]*t80; /* v_nu*m*2*I1*I1 */
    const double t82 = params[1]*t78; /* R*m*2 */
    const double t83 = t79*t82; /* I1*I1*R*m*2 */
    const double t84 = x[1]*t83; /* v_nu*I1*I1*R*m*2 */
    const double t85 = params[1]*2.0; /* R*2 */
    const double t86 = params[3]*t85; /* I1*R*2 */
    const double t87 = t6*t86; /* s*I1*R*2 */
    const double t88 = t23*t87; /* Theta*s*I1*R*2 */
    const double t89 = t55*t88; /* (-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2 */
    const double t90 = t58*t89; /* (I1 - I3)*(-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2 */
    const double t91 = t90/t20; /* (I1 - I3)*(-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2/(K*K) */
    out[0] = t44;
    out[1] = t45;
    out[2] = 0.0;
    out[3] = t48;
    out[4] = t77;
    out[5] = t81;
    out[6] = t84;
    out[7] = t91;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

static const jlt_equilibria equilibria[] = {
    { .name = "spinning", .condition = "a3 = 0",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 2, .obstructs = 1 },
};

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
};

const jlt_descriptor jlt_kernels_spherical_top_level_general = {
    .model = "spherical_top_level",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 4, .param_count = 7, .block_count = 36,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 32, 14, 1, 1, 0, 17, 13 }, { 21, 80, 0, 8, 1, 0, 12, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 8, 67, 36, 1, 1, 0, 20, 28 }, { 91, 425, 0, 50, 1, 0, 21, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 75, 41, 1, 1, 0, 19, 38 }, { 105, 489, 0, 58, 1, 0, 21, 14 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 22, 11, 1, 1, 0, 16, 10 }, { 13, 41, 0, 5, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 2, 8, 8, 1, 0, 0, 8, 7 }, { 9, 28, 0, 2, 1, 0, 13, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 2, 13, 9, 1, 0, 0, 10, 8 }, { 10, 44, 0, 4, 1, 0, 15, 10 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_general_baseline,
        &jlt_batch_spherical_top_level_general_avx2,
        &jlt_batch_spherical_top_level_general_avx512,
    },
};
