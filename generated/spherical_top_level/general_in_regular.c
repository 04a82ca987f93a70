/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   28   12    1    0    0     13   10   (111)
 *  jacobian            9   73   36    1    0    0     15   26   (746)
 *  rhs_jacobian        10   81   39    1    0    0     15   27   (836)
 *  divergence          0   15   11    1    0    0     12    8   (56)
 *  integral_values     2    6    6    1    0    0      8    5   (37)
 *  integral_gradients  1   13    7    1    0    0     10    7   (75)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
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
    const double t1 = params[1]*params[4]; /* R*I3 */
    out[8] = t1;
    const double t2 = params[5]/params[1]; /* a3/R */
    out[9] = t2;
    const double t3 = params[5]*params[5]; /* a3*a3 */
    const double t4 = params[0]*t3; /* m*a3*a3 */
    out[25] = t4;
    const double t5 = t4/params[3]; /* m*a3*a3/I1 */
    out[10] = t5;
    const double t6 = params[1]*params[1]; /* R*R */
    const double t7 = params[3]*t6; /* I1*R*R */
    out[11] = t7;
    const double t8 = params[4]*t6; /* I3*R*R */
    out[12] = t8;
    const double t9 = params[4]*params[3]; /* I3*I1 */
    out[44] = t9;
    const double t10 = t9/params[0]; /* I3*I1/m */
    out[13] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[5]*t11; /* a3*m*g */
    out[28] = t12;
    const double t13 = t12/params[3]; /* a3*m*g/I1 */
    out[14] = t13;
    const double t14 = params[6]/params[3]; /* G/I1 */
    out[15] = t14;
    const double t15 = params[1]*params[3]; /* R*I1 */
    const double t16 = params[4]*t15; /* I3*R*I1 */
    out[35] = t16;
    const double t17 = t16/params[0]; /* I3*R*I1/m */
    out[16] = t17;
    const double t18 = params[3] - params[4]; /* I1 - I3 */
    const double t19 = params[1]*t18; /* R*(I1 - I3) */
    out[17] = t19;
    const double t20 = params[4]*params[5]; /* I3*a3 */
    out[18] = t20;
    const double t21 = t6*2.0; /* R*R*2 */
    const double t22 = params[4]*t21; /* I3*R*R*2 */
    out[19] = t22;
    const double t23 = params[3]*t21; /* I1*R*R*2 */
    out[20] = t23;
    const double t24 = params[6]*t1; /* G*R*I3 */
    out[37] = t24;
    const double t25 = t24/params[3]; /* G*R*I3/I1 */
    out[21] = t25;
    const double t26 = t6*4.0; /* R*R*4 */
    const double t27 = params[4]*t26; /* I3*R*R*4 */
    out[22] = t27;
    const double t28 = params[0]*2.0; /* m*2 */
    const double t29 = t3*t28; /* a3*a3*m*2 */
    out[38] = t29;
    const double t30 = t29/params[3]; /* a3*a3*m*2/I1 */
    out[23] = t30;
    const double t31 = -t1; /* -R*I3 */
    out[24] = t31;
    const double t32 = 2.0/params[3]; /* 2/I1 */
    out[26] = t32;
    const double t33 = params[3]*params[3]; /* I1*I1 */
    const double t34 = t29/t33; /* a3*a3*m*2/(I1*I1) */
    out[27] = t34;
    const double t35 = params[3]*t26; /* I1*R*R*4 */
    out[29] = t35;
    const double t36 = params[5]*t9; /* a3*I3*I1 */
    const double t37 = t36/params[0]; /* a3*I3*I1/m */
    out[30] = t37;
    const double t38 = params[4]*params[4]; /* I3*I3 */
    const double t39 = t23*t38; /* I1*R*R*2*I3*I3 */
    const double t40 = t39/params[0]; /* I1*R*R*2*I3*I3/m */
    out[31] = t40;
    const double t41 = params[4]*t7; /* I3*I1*R*R */
    const double t42 = t18*t41; /* (I1 - I3)*I3*I1*R*R */
    const double t43 = t42/params[0]; /* (I1 - I3)*I3*I1*R*R/m */
    out[32] = t43;
    const double t44 = t24/params[0]; /* G*R*I3/m */
    out[33] = t44;
    const double t45 = params[4]*t35; /* I3*I1*R*R*4 */
    out[34] = t45;
    const double t46 = params[1]*t6; /* R*R*R */
    const double t47 = 4.0*t46; /* 4*R*R*R */
    const double t48 = params[3]*t47; /* I1*4*R*R*R */
    const double t49 = t38*t48; /* I3*I3*I1*4*R*R*R */
    out[36] = t49;
    const double t50 = -t16; /* -I3*R*I1 */
    out[39] = t50;
    const double t51 = params[2]*t28; /* g*m*2 */
    const double t52 = params[5]*t51; /* a3*g*m*2 */
    out[40] = t52;
    const double t53 = params[6]*t15; /* G*R*I1 */
    out[41] = t53;
    const double t54 = t26*t33; /* R*R*4*I1*I1 */
    out[42] = t54;
    const double t55 = t21*t33; /* R*R*2*I1*I1 */
    const double t56 = params[4]*t55; /* I3*R*R*2*I1*I1 */
    const double t57 = t56/params[0]; /* I3*R*R*2*I1*I1/m */
    out[43] = t57;
    const double t58 = params[0]/2.0; /* m/2 */
    out[45] = t58;
    const double t59 = params[4]/params[3]; /* I3/I1 */
    out[46] = t59;
    const double t60 = params[0]*t6; /* m*R*R */
    const double t61 = params[3]*t60; /* I1*m*R*R */
    const double t62 = params[6]*params[6]; /* G*G */
    out[49] = t62;
    const double t63 = t62/t61; /* G*G/(I1*m*R*R) */
    out[47] = t63;
    const double t64 = params[4]/t60; /* I3/(m*R*R) */
    out[48] = t64;
    const double t65 = t4/t7; /* m*a3*a3/(I1*R*R) */
    out[50] = t65;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9] + x[0]; /* b/R = a3/R + gamma3 */
    const double t2 = p[11]*t0; /* R^2*I1*s*s */
    const double t3 = p[12]*t1; /* R^2*I3*b/R */
    const double t4 = JLT_FMA(t1, t3, t2); /* K = b/R*R^2*I3*b/R + R^2*I1*s*s */
    const double t5 = JLT_FMA(p[10], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t6 = p[13] + t4; /* Theta/m = I1*I3/m + K */
    const double t7 = t4*t5; /* K*D/I1 */
    const double t8 = t6*t7; /* Theta/m*K*D/I1 */
    const double t9 = 1.0/t8; /* 1/(Theta/m*K*D/I1) */
    const double t10 = t6*t9; /* 1/(K*(D/I1)) = Theta/m*1/(Theta/m*K*D/I1) */
    const double t11 = t7*t9; /* 1/(Theta/m) = K*D/I1*1/(Theta/m*K*D/I1) */
    const double t12 = t5*t10; /* 1/K = D/I1*1/(K*(D/I1)) */
    const double t13 = t4*t10; /* K*1/(K*(D/I1)) */
    const double t14 = x[4]*x[3]; /* s*v_tau */
    const double t15 = JLT_FNMA(p[15], t1, t14); /* s*v_tau - G/I1*b/R */
    const double t16 = x[4]*t15; /* s*(s*v_tau - G/I1*b/R) */
    const double t17 = t12*t16; /* 1/K*s*(s*v_tau - G/I1*b/R) */
    const double t18 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t19 = JLT_FMA(x[2], t18, x[1]); /* V = omega_tau*e + v_nu */
    const double t20 = p[13]*t19; /* I1*I3/m*V */
    const double t21 = JLT_FNMA(t11, t20, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t22 = x[4]*p[7]; /* s*R*G */
    const double t23 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t24 = JLT_FMA(t1, t23, t22); /* b/R*v_tau*R*I3 + s*R*G */
    const double t25 = t12*t24; /* 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t26 = t21*t25; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t27 = x[3]*t25; /* v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[1] = t27;
    const double t28 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t29 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t29;
    const double t30 = p[10]*t28; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t31 = t29*t30; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t32 = JLT_FNMA(p[14], t0, t31); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s*s */
    const double t33 = x[4]*t28; /* s*omega_tau*gamma3 */
    const double t34 = -t33; /* -s*omega_tau*gamma3 */
    out[4] = t34;
    const double t35 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t36 = x[2]*p[16]; /* omega_tau*R*I1*I3/m */
    const double t37 = t35*t36; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t38 = t11*t37; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t39 = JLT_FMA(t17, t38, t26); /* 1/K*s*(s*v_tau - G/I1*b/R)*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m + (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t40 = -t39; /* -t39 */
    out[3] = t40;
    const double t41 = p[8]*t17; /* R*I3*1/K*s*(s*v_tau - G/I1*b/R) */
    const double t42 = JLT_FMA(x[0], t25, t41); /* gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) + R*I3*1/K*s*(s*v_tau - G/I1*b/R) */
    const double t43 = JLT_FNMA(t25, t42, t32); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s*s - 1/K*(b/R*v_tau*R*I3 + s*R*G)*t42 */
    const double t44 = t13*t43; /* K*1/(K*(D/I1))*t43 */
    out[2] = t44;
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
    const double t3 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t4 = JLT_FMA(t0, p[10], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t5 = t0*p[11]; /* s*s*R^2*I1 */
    const double t6 = p[9] + x[0]; /* b/R = a3/R + gamma3 */
    const double t7 = p[12]*t6; /* R^2*I3*b/R */
    const double t8 = JLT_FMA(t6, t7, t5); /* K = b/R*R^2*I3*b/R + s*s*R^2*I1 */
    const double t9 = t8 + p[13]; /* Theta/m = K + I1*I3/m */
    const double t10 = t4*t8; /* D/I1*K */
    const double t11 = t9*t10; /* Theta/m*D/I1*K */
    const double t12 = 1.0/t11; /* 1/(Theta/m*D/I1*K) */
    const double t13 = t9*t12; /* 1/(K*(D/I1)) = Theta/m*1/(Theta/m*D/I1*K) */
    const double t14 = t4*t13; /* 1/K = D/I1*1/(K*(D/I1)) */
    const double t15 = t3*t14; /* v_tau*R*I3*1/K */
    const double t16 = t6*t14; /* b/R*1/K */
    const double t17 = p[19]*t16; /* 2*R^2*I3*b/R*1/K */
    const double t18 = x[4]*p[7]; /* s*R*G */
    const double t19 = JLT_FMA(t3, t6, t18); /* v_tau*R*I3*b/R + s*R*G */
    const double t20 = t14*t19; /* 1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t21 = JLT_FNMA(t17, t20, t15); /* v_tau*R*I3*1/K - 2*R^2*I3*b/R*1/K*1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t22 = x[3]*t21; /* v_tau*t21 */
    out[5] = t22;
    const double t23 = JLT_FMA(t3, t16, t20); /* v_tau*R*I3*b/R*1/K + 1/K*(v_tau*R*I3*b/R + s*R*G) */
    out[8] = t23;
    const double t24 = t14*p[7]; /* 1/K*R*G */
    const double t25 = x[3]*t24; /* v_tau*1/K*R*G */
    const double t26 = x[4]*t14; /* s*1/K */
    const double t27 = x[3]*t26; /* v_tau*s*1/K */
    const double t28 = t20*p[20]; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*2*R^2*I1 */
    const double t29 = JLT_FNMA(t27, t28, t25); /* v_tau*1/K*R*G - v_tau*s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*2*R^2*I1 */
    out[9] = t29;
    const double t30 = t8*t13; /* 1/(D/I1) = K*1/(K*(D/I1)) */
    const double t31 = t1*t30; /* s*omega_tau*1/(D/I1) */
    const double t32 = t1*p[10]; /* s*omega_tau*m*a3^2/I1 */
    const double t33 = t31*t32; /* s*omega_tau*1/(D/I1)*s*omega_tau*m*a3^2/I1 */
    const double t34 = x[4]*x[3]; /* s*v_tau */
    const double t35 = JLT_FNMA(t6, p[15], t34); /* s*v_tau - b/R*G/I1 */
    const double t36 = t26*t35; /* s*1/K*(s*v_tau - b/R*G/I1) */
    const double t37 = p[8]*t36; /* R*I3*s*1/K*(s*v_tau - b/R*G/I1) */
    const double t38 = x[0]*t20; /* gamma3*1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t39 = t37 + t38; /* R*I3*s*1/K*(s*v_tau - b/R*G/I1) + gamma3*1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t40 = t16*p[22]; /* b/R*1/K*4*R^2*I3 */
    const double t41 = JLT_FMS(t26, p[21], t20); /* s*1/K*R*I3*G/I1 - 1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t42 = JLT_FMA(t39, t40, t41); /* t39*b/R*1/K*4*R^2*I3 + s*1/K*R*I3*G/I1 - 1/K*(v_tau*R*I3*b/R + s*R*G) */
    const double t43 = t20*t30; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1) */
    const double t44 = JLT_FMA(2.0, t38, t37); /* 2*gamma3*1/K*(v_tau*R*I3*b/R + s*R*G) + R*I3*s*1/K*(s*v_tau - b/R*G/I1) */
    const double t45 = t30*t44; /* 1/(D/I1)*t44 */
    const double t46 = JLT_FNMA(t15, t45, t33); /* s*omega_tau*1/(D/I1)*s*omega_tau*m*a3^2/I1 - v_tau*R*I3*1/K*1/(D/I1)*t44 */
    const double t47 = JLT_FMA(t42, t43, t46); /* t42*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1) + t46 */
    out[10] = t47;
    const double t48 = x[4]*x[0]; /* s*gamma3 */
    const double t49 = p[23]*t48; /* 2*m*a3^2/I1*s*gamma3 */
    const double t50 = t31*t49; /* s*omega_tau*1/(D/I1)*2*m*a3^2/I1*s*gamma3 */
    out[12] = t50;
    const double t51 = t26*t43; /* s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1) */
    const double t52 = x[4]*t51; /* s*s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1) */
    const double t53 = JLT_FMA(t16, t45, t52); /* b/R*1/K*1/(D/I1)*t44 + s*s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1) */
    const double t54 = p[24]*t53; /* (-R*I3)*t53 */
    out[13] = t54;
    const double t55 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t56 = t0*p[27]; /* s*s*2*m*a3^2/I1^2 */
    const double t57 = JLT_FNMA(t30, t56, p[26]); /* 2/I1 - 1/(D/I1)*s*s*2*m*a3^2/I1^2 */
    const double t58 = p[25]*t55; /* m*a3^2*omega_tau*gamma3 */
    const double t59 = t31*t58; /* s*omega_tau*1/(D/I1)*m*a3^2*omega_tau*gamma3 */
    const double t60 = t57*t59; /* (2/I1 - 1/(D/I1)*s*s*2*m*a3^2/I1^2)*s*omega_tau*1/(D/I1)*m*a3^2*omega_tau*gamma3 */
    const double t61 = t43*t49; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*2*m*a3^2/I1*s*gamma3 */
    const double t62 = x[4]*t30; /* s*1/(D/I1) */
    const double t63 = p[23]*t62; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t64 = JLT_FMA(t14, t35, t27); /* 1/K*(s*v_tau - b/R*G/I1) + v_tau*s*1/K */
    const double t65 = JLT_FMS(t36, t63, t64); /* s*1/K*(s*v_tau - b/R*G/I1)*2*m*a3^2/I1*s*1/(D/I1) - (1/K*(s*v_tau - b/R*G/I1) + v_tau*s*1/K) */
    const double t66 = JLT_FMA(p[8], t65, t61); /* R*I3*t65 + 1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*2*m*a3^2/I1*s*gamma3 */
    const double t67 = t62*p[28]; /* s*1/(D/I1)*m*g*a3 */
    const double t68 = t51*p[29]; /* s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*4*R^2*I1 */
    const double t69 = JLT_FNMA(t57, t67, t60); /* t60 - (2/I1 - 1/(D/I1)*s*s*2*m*a3^2/I1^2)*s*1/(D/I1)*m*g*a3 */
    const double t70 = JLT_FMA(t39, t68, t69); /* t39*s*1/K*1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*4*R^2*I1 + t60 - (2/I1 - 1/(D/I1)*s*s*2*m*a3^2/I1^2)*s*1/(D/I1)*m*g*a3 */
    const double t71 = JLT_FNMA(t24, t45, t70); /* t70 - 1/K*R*G*1/(D/I1)*t44 */
    const double t72 = JLT_FMA(t43, t66, t71); /* 1/K*(v_tau*R*I3*b/R + s*R*G)*1/(D/I1)*t66 + t70 - 1/K*R*G*1/(D/I1)*t44 */
    out[14] = t72;
    const double t73 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t74 = JLT_FMA(x[2], t73, x[1]); /* V = omega_tau*e + v_nu */
    const double t75 = t10*t12; /* 1/(Theta/m) = D/I1*K*1/(Theta/m*D/I1*K) */
    const double t76 = p[13]*t75; /* I1*I3/m*1/(Theta/m) */
    const double t77 = JLT_FNMA(t74, t76, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t78 = t15*t77; /* v_tau*R*I3*1/K*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t79 = t17*x[1]; /* 2*R^2*I3*b/R*1/K*v_nu */
    const double t80 = x[2]*t75; /* omega_tau*1/(Theta/m) */
    const double t81 = JLT_FMA(p[30], t80, t79); /* I1*I3*a3/m*omega_tau*1/(Theta/m) + 2*R^2*I3*b/R*1/K*v_nu */
    const double t82 = t14 + t75; /* 1/K + 1/(Theta/m) */
    const double t83 = t19*t74; /* (v_tau*R*I3*b/R + s*R*G)*V */
    const double t84 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t85 = t1*t84; /* s*omega_tau*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t86 = t35*p[1]; /* (s*v_tau - b/R*G/I1)*R */
    const double t87 = JLT_FNMA(t85, t86, t83); /* (v_tau*R*I3*b/R + s*R*G)*V - s*omega_tau*(gamma3*R*(I1 - I3) - I3*a3)*(s*v_tau - b/R*G/I1)*R */
    const double t88 = t75*t87; /* 1/(Theta/m)*t87 */
    const double t89 = t82*t88; /* (1/K + 1/(Theta/m))*1/(Theta/m)*t87 */
    const double t90 = t16*p[31]; /* b/R*1/K*2*R^2*I1*I3^2/m */
    const double t91 = t80*p[32]; /* omega_tau*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    const double t92 = t80*t84; /* omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t93 = t26*p[33]; /* s*1/K*R*I3*G/m */
    const double t94 = JLT_FMS(t92, t93, t78); /* omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*s*1/K*R*I3*G/m - v_tau*R*I3*1/K*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t95 = JLT_FNMA(t89, t90, t94); /* t94 - (1/K + 1/(Theta/m))*1/(Theta/m)*t87*b/R*1/K*2*R^2*I1*I3^2/m */
    const double t96 = JLT_FNMA(t36, t91, t95); /* t95 - s*1/K*(s*v_tau - b/R*G/I1)*omega_tau*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m */
    const double t97 = JLT_FMA(t20, t81, t96); /* 1/K*(v_tau*R*I3*b/R + s*R*G)*(I1*I3*a3/m*omega_tau*1/(Theta/m) + 2*R^2*I3*b/R*1/K*v_nu) + t96 */
    out[15] = t97;
    const double t98 = t20*t76; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*I1*I3/m*1/(Theta/m) */
    const double t99 = t98 - t20; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*I1*I3/m*1/(Theta/m) - 1/K*(v_tau*R*I3*b/R + s*R*G) */
    out[16] = t99;
    const double t100 = t73*t98; /* e*1/K*(v_tau*R*I3*b/R + s*R*G)*I1*I3/m*1/(Theta/m) */
    const double t101 = t75*p[16]; /* 1/(Theta/m)*R*I1*I3/m */
    const double t102 = t84*t101; /* (gamma3*R*(I1 - I3) - I3*a3)*1/(Theta/m)*R*I1*I3/m */
    const double t103 = JLT_FNMA(t36, t102, t100); /* e*1/K*(v_tau*R*I3*b/R + s*R*G)*I1*I3/m*1/(Theta/m) - s*1/K*(s*v_tau - b/R*G/I1)*(gamma3*R*(I1 - I3) - I3*a3)*1/(Theta/m)*R*I1*I3/m */
    out[17] = t103;
    const double t104 = p[8]*t16; /* R*I3*b/R*1/K */
    const double t105 = t77*t104; /* (v_nu - V*I1*I3/m*1/(Theta/m))*R*I3*b/R*1/K */
    const double t106 = t85*t101; /* s*omega_tau*(gamma3*R*(I1 - I3) - I3*a3)*1/(Theta/m)*R*I1*I3/m */
    const double t107 = JLT_FMA(t26, t106, t105); /* s*1/K*t106 + (v_nu - V*I1*I3/m*1/(Theta/m))*R*I3*b/R*1/K */
    const double t108 = -t107; /* -(s*1/K*t106 + (v_nu - V*I1*I3/m*1/(Theta/m))*R*I3*b/R*1/K) */
    out[18] = t108;
    const double t109 = t92*p[16]; /* omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*R*I1*I3/m */
    const double t110 = t24*t77; /* 1/K*R*G*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t111 = t20*x[1]; /* 1/K*(v_tau*R*I3*b/R + s*R*G)*v_nu */
    const double t112 = JLT_FNMA(p[13], t89, t111); /* 1/K*(v_tau*R*I3*b/R + s*R*G)*v_nu - I1*I3/m*(1/K + 1/(Theta/m))*1/(Theta/m)*t87 */
    const double t113 = p[20]*t26; /* 2*R^2*I1*s*1/K */
    const double t114 = JLT_FMS(t112, t113, t110); /* t112*2*R^2*I1*s*1/K - 1/K*R*G*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t115 = JLT_FNMA(t64, t109, t114); /* t112*2*R^2*I1*s*1/K - 1/K*R*G*(v_nu - V*I1*I3/m*1/(Theta/m)) - (1/K*(s*v_tau - b/R*G/I1) + v_tau*s*1/K)*omega_tau*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*R*I1*I3/m */
    out[19] = t115;
    const double t116 = -t1; /* -s*omega_tau */
    out[20] = t116;
    const double t117 = -t48; /* -s*gamma3 */
    out[22] = t117;
    const double t118 = -t55; /* -omega_tau*gamma3 */
    out[24] = t118;
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
    const double t0 = p[9] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = x[4]*x[4]; /* s*s */
    out[7] = t1;
    const double t2 = p[11]*t1; /* R^2*I1*s*s */
    const double t3 = p[12]*t0; /* R^2*I3*b/R */
    const double t4 = JLT_FMA(t0, t3, t2); /* K = b/R*R^2*I3*b/R + R^2*I1*s*s */
    const double t5 = JLT_FMA(p[25], t1, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t6 = p[13] + t4; /* Theta/m = I1*I3/m + K */
    const double t7 = t4*t5; /* K*D */
    const double t8 = t6*t7; /* Theta/m*K*D */
    const double t9 = 1.0/t8; /* 1/(Theta/m*K*D) */
    const double t10 = t6*t9; /* 1/(K*D) = Theta/m*1/(Theta/m*K*D) */
    const double t11 = t7*t9; /* 1/(Theta/m) = K*D*1/(Theta/m*K*D) */
    const double t12 = t5*t10; /* 1/K = D*1/(K*D) */
    const double t13 = t4*t10; /* 1/D = K*1/(K*D) */
    const double t14 = x[4]*x[2]; /* s*omega_tau */
    const double t15 = 2.0*t14; /* 2*s*omega_tau */
    out[9] = t15;
    const double t16 = -t14; /* -s*omega_tau */
    out[25] = t16;
    const double t17 = x[4]*p[7]; /* s*R*G */
    const double t18 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t19 = JLT_FMA(t0, t18, t17); /* b/R*v_tau*R*I3 + s*R*G */
    const double t20 = x[4]*x[3]; /* s*v_tau */
    const double t21 = JLT_FNMA(p[15], t0, t20); /* s*v_tau - G/I1*b/R */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = x[0]*t14; /* gamma3*s*omega_tau */
    const double t24 = -t23; /* -gamma3*s*omega_tau */
    out[4] = t24;
    const double t25 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t26 = t11*t25; /* 1/(Theta/m)*V */
    const double t27 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t28 = t12*t19; /* 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t29 = p[25]*t14; /* m*a3^2*s*omega_tau */
    const double t30 = x[4]*t12; /* s*1/K */
    const double t31 = p[8]*t21; /* R*I3*(s*v_tau - G/I1*b/R) */
    const double t32 = t30*t31; /* s*1/K*R*I3*(s*v_tau - G/I1*b/R) */
    const double t33 = t11*t27; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t34 = p[33]*t27; /* R*I3*G/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t35 = t0*t12; /* b/R*1/K */
    const double t36 = JLT_FMA(t18, t35, t28); /* v_tau*R*I3*b/R*1/K + 1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[13] = t36;
    const double t37 = p[36]*t21; /* 4*R^3*I1*I3^2*(s*v_tau - G/I1*b/R) */
    const double t38 = t35*t37; /* b/R*1/K*4*R^3*I1*I3^2*(s*v_tau - G/I1*b/R) */
    const double t39 = p[38]*t23; /* 2*m*a3^2*gamma3*s*omega_tau */
    const double t40 = t23*t29; /* gamma3*s*omega_tau*m*a3^2*s*omega_tau */
    const double t41 = JLT_FNMA(p[28], t1, t40); /* gamma3*s*omega_tau*m*a3^2*s*omega_tau - m*g*a3*s*s */
    const double t42 = t14*t29; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t43 = t11*t19; /* 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t44 = t11*t14; /* 1/(Theta/m)*s*omega_tau */
    const double t45 = x[2]*p[30]; /* omega_tau*I1*I3*a3/m */
    const double t46 = t43*t45; /* 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G)*omega_tau*I1*I3*a3/m */
    const double t47 = JLT_FMA(t34, t44, t46); /* R*I3*G/m*(gamma3*R*(I1 - I3) - I3*a3)*1/(Theta/m)*s*omega_tau + 1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G)*omega_tau*I1*I3*a3/m */
    const double t48 = t21*t44; /* (s*v_tau - G/I1*b/R)*1/(Theta/m)*s*omega_tau */
    const double t49 = JLT_FNMA(p[32], t48, t47); /* t47 - R^2*I1*I3*(I1 - I3)/m*(s*v_tau - G/I1*b/R)*1/(Theta/m)*s*omega_tau */
    const double t50 = x[2]*t21; /* omega_tau*(s*v_tau - G/I1*b/R) */
    const double t51 = JLT_FMA(x[3], t14, t50); /* v_tau*s*omega_tau + omega_tau*(s*v_tau - G/I1*b/R) */
    const double t52 = x[0]*t28; /* gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t53 = JLT_FNMA(p[13], t26, x[1]); /* v_nu - I1*I3/m*1/(Theta/m)*V */
    const double t54 = t26*t43; /* 1/(Theta/m)*V*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t55 = p[13]*t43; /* I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t56 = JLT_FNMA(t18, t53, t49); /* t49 - v_tau*R*I3*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t57 = t22*t55; /* e*I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) */
    const double t58 = t55 - t19; /* d(numerator of d(v_tau)/dt over K)/d(v_nu) = I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) - (b/R*v_tau*R*I3 + s*R*G) */
    const double t59 = t12*t58; /* 1/K*d(numerator of d(v_tau)/dt over K)/d(v_nu) */
    out[21] = t59;
    const double t60 = t19*t53; /* (b/R*v_tau*R*I3 + s*R*G)*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t61 = p[16]*t33; /* R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t62 = p[1]*t33; /* R*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t63 = JLT_FNMA(t48, t62, t54); /* 1/(Theta/m)*V*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) - (s*v_tau - G/I1*b/R)*1/(Theta/m)*s*omega_tau*R*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t64 = t51*t61; /* (v_tau*s*omega_tau + omega_tau*(s*v_tau - G/I1*b/R))*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t65 = JLT_FMA(p[7], t53, t64); /* R*G*(v_nu - I1*I3/m*1/(Theta/m)*V) + t64 */
    const double t66 = t28*t30; /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t67 = JLT_FMA(t38, t66, t42); /* b/R*1/K*4*R^3*I1*I3^2*(s*v_tau - G/I1*b/R)*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + s*omega_tau*m*a3^2*s*omega_tau */
    const double t68 = JLT_FMA(p[37], t66, t67); /* R*I3*G*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + t67 */
    const double t69 = p[20]*t30; /* 2*R^2*I1*s*1/K */
    const double t70 = x[2]*t39; /* omega_tau*2*m*a3^2*gamma3*s*omega_tau */
    const double t71 = JLT_FNMA(x[4], p[40], t70); /* omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 */
    const double t72 = t32 + t52; /* s*1/K*R*I3*(s*v_tau - G/I1*b/R) + gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t73 = JLT_FMA(2.0, t52, t32); /* 2*gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G) + s*1/K*R*I3*(s*v_tau - G/I1*b/R) */
    const double t74 = p[3]*t28; /* I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t75 = JLT_FNMA(t72, t74, t41); /* numerator of d(omega_tau)/dt over D = gamma3*s*omega_tau*m*a3^2*s*omega_tau - m*g*a3*s*s - t72*I1*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    const double t76 = t13*t75; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t76;
    const double t77 = t21*t61; /* (s*v_tau - G/I1*b/R)*R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t78 = t12*t21; /* 1/K*(s*v_tau - G/I1*b/R) */
    const double t79 = JLT_FMA(t14, t77, t60); /* s*omega_tau*t77 + (b/R*v_tau*R*I3 + s*R*G)*(v_nu - I1*I3/m*1/(Theta/m)*V) */
    const double t80 = JLT_FNMA(x[4], t77, t57); /* d(numerator of d(v_tau)/dt over K)/d(omega_tau) = e*I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + s*R*G) - s*t77 */
    const double t81 = t12*t80; /* 1/K*d(numerator of d(v_tau)/dt over K)/d(omega_tau) */
    out[22] = t81;
    const double t82 = x[4]*t14; /* s*s*omega_tau */
    out[0] = t82;
    const double t83 = t12*t79; /* 1/K*t79 */
    const double t84 = -t83; /* -1/K*t79 */
    out[3] = t84;
    const double t85 = x[3]*t66; /* v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t86 = JLT_FMA(t28, t78, t85); /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*1/K*(s*v_tau - G/I1*b/R) + v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t87 = p[34]*t35; /* 4*R^2*I1*I3*b/R*1/K */
    const double t88 = JLT_FNMA(t52, t87, t74); /* I1*1/K*(b/R*v_tau*R*I3 + s*R*G) - gamma3*1/K*(b/R*v_tau*R*I3 + s*R*G)*4*R^2*I1*I3*b/R*1/K */
    const double t89 = JLT_FNMA(t28, t88, t68); /* R*I3*G*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + t67 - 1/K*(b/R*v_tau*R*I3 + s*R*G)*t88 */
    const double t90 = x[3]*t28; /* v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G) */
    out[1] = t90;
    const double t91 = p[42]*t66; /* 4*R^2*I1^2*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t92 = JLT_FMA(t72, t91, t71); /* t72*4*R^2*I1^2*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K + omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 */
    const double t93 = JLT_FNMA(p[35], t86, t92); /* t92 - R*I1*I3*t86 */
    const double t94 = p[8]*t0; /* R*I3*b/R */
    const double t95 = t53*t94; /* (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*b/R */
    const double t96 = JLT_FMA(t61, t82, t95); /* R*I1*I3/m*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*s*s*omega_tau + (v_nu - I1*I3/m*1/(Theta/m)*V)*R*I3*b/R */
    const double t97 = p[31]*t0; /* 2*R^2*I1*I3^2/m*b/R */
    const double t98 = JLT_FNMA(t63, t97, t56); /* d(numerator of d(v_tau)/dt over K)/d(gamma3) = t49 - v_tau*R*I3*(v_nu - I1*I3/m*1/(Theta/m)*V) - t63*2*R^2*I1*I3^2/m*b/R */
    const double t99 = t12*t96; /* 1/K*t96 */
    const double t100 = -t99; /* -1/K*t96 */
    out[23] = t100;
    const double t101 = x[3]*t12; /* v_tau*1/K */
    const double t102 = t18*t101; /* v_tau*R*I3*v_tau*1/K */
    const double t103 = x[4]*t13; /* s*1/D */
    const double t104 = t39*t103; /* 2*m*a3^2*gamma3*s*omega_tau*s*1/D */
    out[17] = t104;
    const double t105 = t13*t35; /* 1/D*b/R*1/K */
    const double t106 = p[19]*t35; /* 2*R^2*I3*b/R*1/K */
    const double t107 = JLT_FNMA(t90, t106, t102); /* v_tau*R*I3*v_tau*1/K - v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*2*R^2*I3*b/R*1/K */
    out[10] = t107;
    const double t108 = t73*t105; /* t73*1/D*b/R*1/K */
    const double t109 = JLT_FMA(t66, t103, t108); /* 1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K*s*1/D + t73*1/D*b/R*1/K */
    const double t110 = p[39]*t109; /* (-R*I1*I3)*(1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K*s*1/D + t73*1/D*b/R*1/K) */
    out[18] = t110;
    const double t111 = p[38]*t103; /* 2*m*a3^2*s*1/D */
    const double t112 = t76*t111; /* 1/D*numerator of d(omega_tau)/dt over D*2*m*a3^2*s*1/D */
    const double t113 = t83*t106; /* 1/K*t79*2*R^2*I3*b/R*1/K */
    const double t114 = JLT_FMA(t12, t98, t113); /* 1/K*d(numerator of d(v_tau)/dt over K)/d(gamma3) + 1/K*t79*2*R^2*I3*b/R*1/K */
    out[20] = t114;
    const double t115 = x[4]*p[43]; /* s*2*R^2*I1^2*I3/m */
    const double t116 = JLT_FMA(t63, t115, t65); /* t63*s*2*R^2*I1^2*I3/m + R*G*(v_nu - I1*I3/m*1/(Theta/m)*V) + t64 */
    const double t117 = t12*t116; /* 1/K*t116 */
    const double t118 = JLT_FMS(t69, t83, t117); /* 2*R^2*I1*s*1/K*1/K*t79 - 1/K*t116 */
    out[24] = t118;
    const double t119 = p[41]*t12; /* R*I1*G*1/K */
    const double t120 = JLT_FNMA(t73, t119, t93); /* d(numerator of d(omega_tau)/dt over D)/d(s) = t92 - R*I1*I3*t86 - t73*R*I1*G*1/K */
    const double t121 = JLT_FMS(t13, t120, t112); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) - 1/D*numerator of d(omega_tau)/dt over D*2*m*a3^2*s*1/D */
    out[19] = t121;
    const double t122 = p[35]*t101; /* R*I1*I3*v_tau*1/K */
    const double t123 = JLT_FNMA(t73, t122, t89); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t89 - t73*R*I1*I3*v_tau*1/K */
    const double t124 = t13*t123; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    out[15] = t124;
    const double t125 = p[7]*t101; /* R*G*v_tau*1/K */
    const double t126 = JLT_FNMA(p[20], t85, t125); /* R*G*v_tau*1/K - 2*R^2*I1*v_tau*1/K*(b/R*v_tau*R*I3 + s*R*G)*s*1/K */
    out[14] = t126;
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
    const double t1 = p[11]*t0; /* R^2*I1*s*s */
    const double t2 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t3 = t2*p[4]; /* b*I3 */
    const double t4 = JLT_FMA(t2, t3, t1); /* K = b*b*I3 + R^2*I1*s*s */
    const double t5 = JLT_FMA(t4, p[0], p[44]); /* Theta = K*m + I1*I3 */
    const double t6 = JLT_FMA(t0, p[25], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t7 = t4*t6; /* K*D */
    const double t8 = t5*t7; /* Theta*K*D */
    const double t9 = 1.0/t8; /* 1/(Theta*K*D) */
    const double t10 = t5*t9; /* 1/(D*K) = Theta*1/(Theta*K*D) */
    const double t11 = p[38]*x[0]; /* 2*m*a3^2*gamma3 */
    const double t12 = t4*t11; /* K*2*m*a3^2*gamma3 */
    const double t13 = t10*t12; /* 1/(D*K)*K*2*m*a3^2*gamma3 */
    const double t14 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t15 = t6*t9; /* 1/(K*Theta) = D*1/(Theta*K*D) */
    const double t16 = p[35]*t14; /* R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t17 = JLT_FNMA(t15, t16, t13); /* 1/(D*K)*K*2*m*a3^2*gamma3 - 1/(K*Theta)*R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t18 = JLT_FMS(t0, t17, x[0]); /* s*s*t17 - gamma3 */
    const double t19 = x[2]*t18; /* omega_tau*(s*s*t17 - gamma3) */
    const double t20 = t6*x[1]; /* D*v_nu */
    const double t21 = t10*t20; /* 1/(D*K)*D*v_nu */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = p[44]*t23; /* I1*I3*V */
    const double t25 = JLT_FNMA(t15, t24, t21); /* 1/(D*K)*D*v_nu - 1/(K*Theta)*I1*I3*V */
    const double t26 = JLT_FNMA(t3, t25, t19); /* omega_tau*(s*s*t17 - gamma3) - b*I3*(1/(D*K)*D*v_nu - 1/(K*Theta)*I1*I3*V) */
    out[0] = t26;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0] + p[9]; /* b/R = gamma3 + a3/R */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[46]*t0; /* I3/I1*b/R */
    const double t3 = JLT_FMA(t0, t2, t1); /* K/(R^2*I1) = b/R*I3/I1*b/R + s*s */
    const double t4 = JLT_FMA(p[25], t1, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t5 = p[48] + t3; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[47]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = t7/t3; /* (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t10 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/2*omega_tau */
    const double t12 = p[28]*x[0]; /* m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t4, t11, t12); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(p[45], t9, t13); /* 1/2*m*t9 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    out[0] = t14;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[9] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = p[12]*t0; /* R^2*I3*b/R */
    const double t2 = x[4]*p[11]; /* s*R^2*I1 */
    const double t3 = x[4]*t2; /* s*s*R^2*I1 */
    const double t4 = JLT_FMA(t0, t1, t3); /* K = b/R*R^2*I3*b/R + s*s*R^2*I1 */
    const double t5 = 1.0/t4; /* 1/K */
    const double t6 = t5*p[49]; /* 1/K*G^2 */
    const double t7 = x[3]*x[3]; /* v_tau*v_tau */
    const double t8 = JLT_FMA(t4, p[0], p[44]); /* Theta = K*m + I1*I3 */
    const double t9 = t5*t8; /* 1/K*Theta */
    const double t10 = JLT_FNMA(t7, p[0], t6); /* 1/K*G^2 - v_tau*v_tau*m */
    const double t11 = JLT_FMA(t7, t9, t10); /* v_tau*v_tau*1/K*Theta + 1/K*G^2 - v_tau*v_tau*m */
    const double t12 = t5*t11; /* 1/K*(v_tau*v_tau*1/K*Theta + 1/K*G^2 - v_tau*v_tau*m) */
    const double t13 = JLT_FNMA(t1, t12, p[28]); /* m*g*a3 - R^2*I3*b/R*1/K*(v_tau*v_tau*1/K*Theta + 1/K*G^2 - v_tau*v_tau*m) */
    out[0] = t13;
    const double t14 = p[0]*x[1]; /* m*v_nu */
    out[1] = t14;
    const double t15 = x[4]*p[25]; /* s*m*a3^2 */
    const double t16 = JLT_FMA(x[4], t15, p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t17 = x[2]*t16; /* omega_tau*D */
    out[2] = t17;
    const double t18 = x[3]*t9; /* v_tau*1/K*Theta */
    out[3] = t18;
    const double t19 = x[2]*p[50]; /* omega_tau*m*a3^2/(R^2*I1) */
    const double t20 = JLT_FMS(x[2], t19, t12); /* omega_tau*omega_tau*m*a3^2/(R^2*I1) - 1/K*(v_tau*v_tau*1/K*Theta + 1/K*G^2 - v_tau*v_tau*m) */
    const double t21 = t2*t20; /* s*R^2*I1*t20 */
    out[4] = t21;
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
        t21[k] = (k == 0 ? p[9] : 0) + x0[k];
        t22[k] = p[11]*t20[k];
        t23[k] = p[12]*t21[k];
        t24[k] = jlt_jet_product(t21, t23, k) + t22[k];
        t25[k] = p[10]*t20[k] + (k == 0 ? 1.0 : 0);
        t26[k] = (k == 0 ? p[13] : 0) + t24[k];
        t27[k] = jlt_jet_product(t24, t25, k);
        t28[k] = jlt_jet_product(t26, t27, k);
        t29[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t28, t29, k);
        t30[k] = jlt_jet_product(t26, t29, k);
        t31[k] = jlt_jet_product(t27, t29, k);
        t32[k] = jlt_jet_product(t25, t30, k);
        t33[k] = jlt_jet_product(t24, t30, k);
        t34[k] = x4[k]*p[7];
        t35[k] = x3[k]*p[8];
        t36[k] = jlt_jet_product(t21, t35, k) + t34[k];
        t37[k] = jlt_jet_product(t32, t36, k);
        t38[k] = jlt_jet_product(x3, t37, k);
        t39[k] = jlt_jet_product(x4, x3, k);
        t40[k] = t39[k] - p[15]*t21[k];
        t41[k] = jlt_jet_product(x4, t40, k);
        t42[k] = jlt_jet_product(t32, t41, k);
        t43[k] = x0[k]*p[5] + (k == 0 ? p[1] : 0);
        t44[k] = jlt_jet_product(x2, t43, k) + x1[k];
        t45[k] = p[13]*t44[k];
        t46[k] = x1[k] - jlt_jet_product(t31, t45, k);
        t47[k] = jlt_jet_product(t37, t46, k);
        t48[k] = jlt_jet_product(x2, x0, k);
        t49[k] = jlt_jet_product(x2, t20, k);
        t50[k] = p[10]*t48[k];
        t51[k] = jlt_jet_product(t49, t50, k);
        t52[k] = t51[k] - p[14]*t20[k];
        t53[k] = jlt_jet_product(x4, t48, k);
        t54[k] = -t53[k];
        t55[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t56[k] = x2[k]*p[16];
        t57[k] = jlt_jet_product(t55, t56, k);
        t58[k] = jlt_jet_product(t31, t57, k);
        t59[k] = jlt_jet_product(t42, t58, k) + t47[k];
        t60[k] = -t59[k];
        t61[k] = jlt_jet_product(x0, t37, k);
        t62[k] = p[8]*t42[k] + t61[k];
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
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 51,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 28, 12, 1, 0, 0, 13, 10 }, { 21, 82, 0, 8, 0, 0, 11, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .jacobian = { jacobian, 25, { 9, 73, 36, 1, 0, 0, 15, 26 }, { 114, 577, 0, 55, 0, 0, 18, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 81, 39, 1, 0, 0, 15, 27 }, { 129, 644, 0, 63, 0, 0, 18, 12 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .divergence = { divergence, 1, { 0, 15, 11, 1, 0, 0, 12, 8 }, { 12, 40, 0, 4, 0, 0, 12, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .integral_values = { integral_values, 1, { 2, 6, 6, 1, 0, 0, 8, 5 }, { 8, 27, 0, 2, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are" },
    .integral_gradients = { integral_gradients, 5, { 1, 13, 7, 1, 0, 0, 10, 7 }, { 10, 58, 0, 7, 0, 0, 12, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are" },
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
