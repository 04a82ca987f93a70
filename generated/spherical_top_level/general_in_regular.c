/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   28   12    1    0    0     13   12   (111)
 *  jacobian            9   73   36    1    0    0     15   26   (746)
 *  rhs_jacobian        10   81   39    1    0    0     15   33   (836)
 *  divergence          0   15   11    1    0    0     12    8   (56)
 *  integral_values     2    6    6    1    0    0      8    6   (37)
 *  integral_gradients  1   13    7    1    0    0     10    7   (75)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are.
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
    const double t1 = params[1]*params[4]; /* R*I3 */
    const double t2 = params[5]/params[1]; /* a3/R */
    const double t3 = params[5]*params[5]; /* a3*a3 */
    const double t4 = params[0]*t3; /* m*a3*a3 */
    const double t5 = t4/params[3]; /* m*a3*a3/I1 */
    const double t6 = params[1]*params[1]; /* R*R */
    const double t7 = params[3]*t6; /* I1*R*R */
    const double t8 = params[4]*t6; /* I3*R*R */
    const double t9 = params[4]*params[3]; /* I3*I1 */
    const double t10 = t9/params[0]; /* I3*I1/m */
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[5]*t11; /* a3*m*g */
    const double t13 = t12/params[3]; /* a3*m*g/I1 */
    const double t14 = params[6]/params[3]; /* G/I1 */
    const double t15 = params[1]*params[3]; /* R*I1 */
    const double t16 = params[4]*t15; /* I3*R*I1 */
    const double t17 = t16/params[0]; /* I3*R*I1/m */
    const double t18 = params[3] - params[4]; /* I1 - I3 */
    const double t19 = params[1]*t18; /* R*(I1 - I3) */
    const double t20 = params[4]*params[5]; /* I3*a3 */
    const double t21 = t6*2.0; /* R*R*2 */
    const double t22 = params[4]*t21; /* I3*R*R*2 */
    const double t23 = params[3]*t21; /* I1*R*R*2 */
    const double t24 = params[6]*t1; /* G*R*I3 */
    const double t25 = t24/params[3]; /* G*R*I3/I1 */
    const double t26 = t6*4.0; /* R*R*4 */
    const double t27 = params[4]*t26; /* I3*R*R*4 */
    const double t28 = params[0]*2.0; /* m*2 */
    const double t29 = t3*t28; /* a3*a3*m*2 */
    const double t30 = t29/params[3]; /* a3*a3*m*2/I1 */
    const double t31 = -t1; /* -R*I3 */
    const double t32 = 2.0/params[3]; /* 2/I1 */
    const double t33 = params[3]*params[3]; /* I1*I1 */
    const double t34 = t29/t33; /* a3*a3*m*2/(I1*I1) */
    const double t35 = params[3]*t26; /* I1*R*R*4 */
    const double t36 = params[5]*t9; /* a3*I3*I1 */
    const double t37 = t36/params[0]; /* a3*I3*I1/m */
    const double t38 = params[4]*params[4]; /* I3*I3 */
    const double t39 = t23*t38; /* I1*R*R*2*I3*I3 */
    const double t40 = t39/params[0]; /* I1*R*R*2*I3*I3/m */
    const double t41 = params[4]*t7; /* I3*I1*R*R */
    const double t42 = t18*t41; /* (I1 - I3)*I3*I1*R*R */
    const double t43 = t42/params[0]; /* (I1 - I3)*I3*I1*R*R/m */
    const double t44 = t24/params[0]; /* G*R*I3/m */
    const double t45 = params[4]*t35; /* I3*I1*R*R*4 */
    const double t46 = params[1]*t6; /* R*R*R */
    const double t47 = 4.0*t46; /* 4*R*R*R */
    const double t48 = params[3]*t47; /* I1*4*R*R*R */
    const double t49 = t38*t48; /* I3*I3*I1*4*R*R*R */
    const double t50 = -t16; /* -I3*R*I1 */
    const double t51 = params[2]*t28; /* g*m*2 */
    const double t52 = params[5]*t51; /* a3*g*m*2 */
    const double t53 = params[6]*t15; /* G*R*I1 */
    const double t54 = t26*t33; /* R*R*4*I1*I1 */
    const double t55 = t21*t33; /* R*R*2*I1*I1 */
    const double t56 = params[4]*t55; /* I3*R*R*2*I1*I1 */
    const double t57 = t56/params[0]; /* I3*R*R*2*I1*I1/m */
    const double t58 = params[0]/2.0; /* m/2 */
    const double t59 = params[4]/params[3]; /* I3/I1 */
    const double t60 = params[0]*t6; /* m*R*R */
    const double t61 = params[3]*t60; /* I1*m*R*R */
    const double t62 = params[6]*params[6]; /* G*G */
    const double t63 = t62/t61; /* G*G/(I1*m*R*R) */
    const double t64 = params[4]/t60; /* I3/(m*R*R) */
    const double t65 = t4/t7; /* m*a3*a3/(I1*R*R) */
    out[7] = t0;
    out[8] = t1;
    out[9] = t2;
    out[10] = t5;
    out[11] = t7;
    out[12] = t8;
    out[13] = t10;
    out[14] = t13;
    out[15] = t14;
    out[16] = t17;
    out[17] = t19;
    out[18] = t20;
    out[19] = t22;
    out[20] = t23;
    out[21] = t25;
    out[22] = t27;
    out[23] = t30;
    out[24] = t31;
    out[25] = t4;
    out[26] = t32;
    out[27] = t34;
    out[28] = t12;
    out[29] = t35;
    out[30] = t37;
    out[31] = t40;
    out[32] = t43;
    out[33] = t44;
    out[34] = t45;
    out[35] = t16;
    out[36] = t49;
    out[37] = t24;
    out[38] = t29;
    out[39] = t50;
    out[40] = t52;
    out[41] = t53;
    out[42] = t54;
    out[43] = t57;
    out[44] = t9;
    out[45] = t58;
    out[46] = t59;
    out[47] = t63;
    out[48] = t64;
    out[49] = t62;
    out[50] = t65;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[4]*p[7]; /* s*R*G */
    const double t3 = p[9] + x[0]; /* b scaled = a3/R + gamma3 */
    const double t4 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t5 = JLT_FMA(t3, t4, t2); /* b scaled*v_tau*R*I3 + s*R*G */
    const double t6 = JLT_FMA(t0, p[10], 1.0); /* D scaled = s*s*m*a3^2/I1 + 1 */
    const double t7 = t0*p[11]; /* s*s*R^2*I1 */
    const double t8 = t3*p[12]; /* b scaled*R^2*I3 */
    const double t9 = JLT_FMA(t3, t8, t7); /* K = b scaled*b scaled*R^2*I3 + s*s*R^2*I1 */
    const double t10 = t9 + p[13]; /* Theta scaled = K + I1*I3/m */
    const double t11 = t6*t9; /* D scaled*K */
    const double t12 = t10*t11; /* Theta scaled*D scaled*K */
    const double t13 = 1.0/t12; /* 1/(Theta scaled*D scaled*K) */
    const double t14 = t10*t13; /* Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t15 = t6*t14; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t16 = t5*t15; /* (b scaled*v_tau*R*I3 + s*R*G)*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t17 = x[3]*t16; /* v_tau*t16 */
    const double t18 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t19 = p[10]*t18; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t20 = t1*t19; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t21 = x[4]*x[3]; /* s*v_tau */
    const double t22 = JLT_FNMA(t3, p[15], t21); /* s*v_tau - b scaled*G/I1 */
    const double t23 = x[4]*t22; /* s*(s*v_tau - b scaled*G/I1) */
    const double t24 = t15*t23; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*s*(s*v_tau - b scaled*G/I1) */
    const double t25 = p[8]*t24; /* R*I3*t24 */
    const double t26 = JLT_FMA(x[0], t16, t25); /* gamma3*t16 + R*I3*t24 */
    const double t27 = JLT_FNMA(t0, p[14], t20); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - s*s*m*g*a3/I1 */
    const double t28 = JLT_FNMA(t16, t26, t27); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - s*s*m*g*a3/I1 - t16*(gamma3*t16 + R*I3*t24) */
    const double t29 = t9*t14; /* K*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t30 = t28*t29; /* t28*K*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t31 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t32 = JLT_FMA(x[2], t31, x[1]); /* V = omega_tau*e + v_nu */
    const double t33 = t11*t13; /* D scaled*K*1/(Theta scaled*D scaled*K) */
    const double t34 = p[13]*t32; /* I1*I3/m*V */
    const double t35 = JLT_FNMA(t33, t34, x[1]); /* v_nu - D scaled*K*1/(Theta scaled*D scaled*K)*I1*I3/m*V */
    const double t36 = t16*t35; /* t16*(v_nu - D scaled*K*1/(Theta scaled*D scaled*K)*I1*I3/m*V) */
    const double t37 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t38 = x[2]*p[16]; /* omega_tau*R*I1*I3/m */
    const double t39 = t37*t38; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t40 = t33*t39; /* D scaled*K*1/(Theta scaled*D scaled*K)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t41 = JLT_FMA(t24, t40, t36); /* t24*t40 + t36 */
    const double t42 = -t41; /* -(t24*t40 + t36) */
    const double t43 = x[4]*t18; /* s*omega_tau*gamma3 */
    const double t44 = -t43; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t17;
    out[2] = t30;
    out[3] = t42;
    out[4] = t44;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t4 = JLT_FMA(t0, p[10], 1.0); /* D scaled = s*s*m*a3^2/I1 + 1 */
    const double t5 = t0*p[11]; /* s*s*R^2*I1 */
    const double t6 = p[9] + x[0]; /* b scaled = a3/R + gamma3 */
    const double t7 = p[12]*t6; /* R^2*I3*b scaled */
    const double t8 = JLT_FMA(t6, t7, t5); /* K = b scaled*R^2*I3*b scaled + s*s*R^2*I1 */
    const double t9 = t8 + p[13]; /* Theta scaled = K + I1*I3/m */
    const double t10 = t4*t8; /* D scaled*K */
    const double t11 = t9*t10; /* Theta scaled*D scaled*K */
    const double t12 = 1.0/t11; /* 1/(Theta scaled*D scaled*K) */
    const double t13 = t9*t12; /* Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t14 = t4*t13; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t15 = t3*t14; /* v_tau*R*I3*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t16 = t6*t14; /* b scaled*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t17 = p[19]*t16; /* 2*R^2*I3*b scaled*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t18 = x[4]*p[7]; /* s*R*G */
    const double t19 = JLT_FMA(t3, t6, t18); /* v_tau*R*I3*b scaled + s*R*G */
    const double t20 = t14*t19; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*(v_tau*R*I3*b scaled + s*R*G) */
    const double t21 = JLT_FNMA(t17, t20, t15); /* v_tau*R*I3*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) - t17*t20 */
    const double t22 = x[3]*t21; /* v_tau*t21 */
    const double t23 = JLT_FMA(t3, t16, t20); /* v_tau*R*I3*b scaled*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) + t20 */
    const double t24 = t14*p[7]; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*R*G */
    const double t25 = x[3]*t24; /* v_tau*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*R*G */
    const double t26 = x[4]*t14; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t27 = x[3]*t26; /* v_tau*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t28 = t20*p[20]; /* t20*2*R^2*I1 */
    const double t29 = JLT_FNMA(t27, t28, t25); /* v_tau*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*R*G - v_tau*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*t20*2*R^2*I1 */
    const double t30 = t8*t13; /* K*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t31 = t1*t30; /* s*omega_tau*K*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t32 = t1*p[10]; /* s*omega_tau*m*a3^2/I1 */
    const double t33 = t31*t32; /* s*omega_tau*K*Theta scaled*1/(Theta scaled*D scaled*K)*s*omega_tau*m*a3^2/I1 */
    const double t34 = x[4]*x[3]; /* s*v_tau */
    const double t35 = JLT_FNMA(t6, p[15], t34); /* s*v_tau - b scaled*G/I1 */
    const double t36 = t26*t35; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*(s*v_tau - b scaled*G/I1) */
    const double t37 = p[8]*t36; /* R*I3*t36 */
    const double t38 = x[0]*t20; /* gamma3*t20 */
    const double t39 = t37 + t38; /* R*I3*t36 + gamma3*t20 */
    const double t40 = t16*p[22]; /* b scaled*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*4*R^2*I3 */
    const double t41 = JLT_FMS(t26, p[21], t20); /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*R*I3*G/I1 - t20 */
    const double t42 = JLT_FMA(t39, t40, t41); /* (R*I3*t36 + gamma3*t20)*t40 + t41 */
    const double t43 = t20*t30; /* t20*K*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t44 = JLT_FMA(2.0, t38, t37); /* 2*gamma3*t20 + R*I3*t36 */
    const double t45 = t30*t44; /* K*Theta scaled*1/(Theta scaled*D scaled*K)*(2*gamma3*t20 + R*I3*t36) */
    const double t46 = JLT_FNMA(t15, t45, t33); /* t33 - v_tau*R*I3*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*t45 */
    const double t47 = JLT_FMA(t42, t43, t46); /* ((R*I3*t36 + gamma3*t20)*t40 + t41)*t20*K*Theta scaled*1/(Theta scaled*D scaled*K) + t46 */
    const double t48 = x[4]*x[0]; /* s*gamma3 */
    const double t49 = p[23]*t48; /* 2*m*a3^2/I1*s*gamma3 */
    const double t50 = t31*t49; /* s*omega_tau*K*Theta scaled*1/(Theta scaled*D scaled*K)*2*m*a3^2/I1*s*gamma3 */
    const double t51 = t26*t43; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*t20*K*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t52 = x[4]*t51; /* s*t51 */
    const double t53 = JLT_FMA(t16, t45, t52); /* b scaled*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*t45 + s*t51 */
    const double t54 = p[24]*t53; /* (-R*I3)*t53 */
    const double t55 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t56 = t0*p[27]; /* s*s*2*m*a3^2/I1^2 */
    const double t57 = JLT_FNMA(t30, t56, p[26]); /* 2/I1 - K*Theta scaled*1/(Theta scaled*D scaled*K)*s*s*2*m*a3^2/I1^2 */
    const double t58 = p[25]*t55; /* m*a3^2*omega_tau*gamma3 */
    const double t59 = t31*t58; /* s*omega_tau*K*Theta scaled*1/(Theta scaled*D scaled*K)*m*a3^2*omega_tau*gamma3 */
    const double t60 = t57*t59; /* t57*t59 */
    const double t61 = t43*t49; /* t20*K*Theta scaled*1/(Theta scaled*D scaled*K)*2*m*a3^2/I1*s*gamma3 */
    const double t62 = x[4]*t30; /* s*K*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t63 = p[23]*t62; /* 2*m*a3^2/I1*s*K*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t64 = JLT_FMA(t14, t35, t27); /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*(s*v_tau - b scaled*G/I1) + v_tau*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t65 = JLT_FMS(t36, t63, t64); /* t36*2*m*a3^2/I1*s*K*Theta scaled*1/(Theta scaled*D scaled*K) - t64 */
    const double t66 = JLT_FMA(p[8], t65, t61); /* R*I3*t65 + t61 */
    const double t67 = t62*p[28]; /* s*K*Theta scaled*1/(Theta scaled*D scaled*K)*m*g*a3 */
    const double t68 = t51*p[29]; /* t51*4*R^2*I1 */
    const double t69 = JLT_FNMA(t57, t67, t60); /* t57*t59 - t57*s*K*Theta scaled*1/(Theta scaled*D scaled*K)*m*g*a3 */
    const double t70 = JLT_FMA(t39, t68, t69); /* (R*I3*t36 + gamma3*t20)*t51*4*R^2*I1 + t69 */
    const double t71 = JLT_FNMA(t24, t45, t70); /* (R*I3*t36 + gamma3*t20)*t51*4*R^2*I1 + t69 - D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*R*G*t45 */
    const double t72 = JLT_FMA(t43, t66, t71); /* t20*K*Theta scaled*1/(Theta scaled*D scaled*K)*(R*I3*t65 + t61) + t71 */
    const double t73 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t74 = JLT_FMA(x[2], t73, x[1]); /* V = omega_tau*e + v_nu */
    const double t75 = t10*t12; /* D scaled*K*1/(Theta scaled*D scaled*K) */
    const double t76 = p[13]*t75; /* I1*I3/m*D scaled*K*1/(Theta scaled*D scaled*K) */
    const double t77 = JLT_FNMA(t74, t76, x[1]); /* v_nu - V*I1*I3/m*D scaled*K*1/(Theta scaled*D scaled*K) */
    const double t78 = t15*t77; /* v_tau*R*I3*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*(v_nu - V*I1*I3/m*D scaled*K*1/(Theta scaled*D scaled*K)) */
    const double t79 = t17*x[1]; /* t17*v_nu */
    const double t80 = x[2]*t75; /* omega_tau*D scaled*K*1/(Theta scaled*D scaled*K) */
    const double t81 = JLT_FMA(p[30], t80, t79); /* I1*I3*a3/m*omega_tau*D scaled*K*1/(Theta scaled*D scaled*K) + t17*v_nu */
    const double t82 = t14 + t75; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K) + D scaled*K*1/(Theta scaled*D scaled*K) */
    const double t83 = t19*t74; /* (v_tau*R*I3*b scaled + s*R*G)*V */
    const double t84 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t85 = t1*t84; /* s*omega_tau*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t86 = t35*p[1]; /* (s*v_tau - b scaled*G/I1)*R */
    const double t87 = JLT_FNMA(t85, t86, t83); /* (v_tau*R*I3*b scaled + s*R*G)*V - s*omega_tau*(gamma3*R*(I1 - I3) - I3*a3)*(s*v_tau - b scaled*G/I1)*R */
    const double t88 = t75*t87; /* D scaled*K*1/(Theta scaled*D scaled*K)*t87 */
    const double t89 = t82*t88; /* t82*D scaled*K*1/(Theta scaled*D scaled*K)*t87 */
    const double t90 = t16*p[31]; /* b scaled*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*2*R^2*I1*I3^2/m */
    const double t91 = t80*p[32]; /* omega_tau*D scaled*K*1/(Theta scaled*D scaled*K)*R^2*I1*I3*(I1 - I3)/m */
    const double t92 = t80*t84; /* omega_tau*D scaled*K*1/(Theta scaled*D scaled*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t93 = t26*p[33]; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*R*I3*G/m */
    const double t94 = JLT_FMS(t92, t93, t78); /* t92*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*R*I3*G/m - t78 */
    const double t95 = JLT_FNMA(t89, t90, t94); /* t94 - t82*D scaled*K*1/(Theta scaled*D scaled*K)*t87*t90 */
    const double t96 = JLT_FNMA(t36, t91, t95); /* t94 - t82*D scaled*K*1/(Theta scaled*D scaled*K)*t87*t90 - t36*t91 */
    const double t97 = JLT_FMA(t20, t81, t96); /* t20*t81 + t96 */
    const double t98 = t20*t76; /* t20*I1*I3/m*D scaled*K*1/(Theta scaled*D scaled*K) */
    const double t99 = t98 - t20; /* t20*I1*I3/m*D scaled*K*1/(Theta scaled*D scaled*K) - t20 */
    const double t100 = t73*t98; /* e*t20*I1*I3/m*D scaled*K*1/(Theta scaled*D scaled*K) */
    const double t101 = t75*p[16]; /* D scaled*K*1/(Theta scaled*D scaled*K)*R*I1*I3/m */
    const double t102 = t84*t101; /* (gamma3*R*(I1 - I3) - I3*a3)*D scaled*K*1/(Theta scaled*D scaled*K)*R*I1*I3/m */
    const double t103 = JLT_FNMA(t36, t102, t100); /* e*t20*I1*I3/m*D scaled*K*1/(Theta scaled*D scaled*K) - t36*t102 */
    const double t104 = p[8]*t16; /* R*I3*b scaled*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t105 = t77*t104; /* (v_nu - V*I1*I3/m*D scaled*K*1/(Theta scaled*D scaled*K))*t104 */
    const double t106 = t85*t101; /* s*omega_tau*(gamma3*R*(I1 - I3) - I3*a3)*D scaled*K*1/(Theta scaled*D scaled*K)*R*I1*I3/m */
    const double t107 = JLT_FMA(t26, t106, t105); /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*t106 + t105 */
    const double t108 = -t107; /* -t107 */
    const double t109 = t92*p[16]; /* t92*R*I1*I3/m */
    const double t110 = t24*t77; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K)*R*G*(v_nu - V*I1*I3/m*D scaled*K*1/(Theta scaled*D scaled*K)) */
    const double t111 = t20*x[1]; /* t20*v_nu */
    const double t112 = JLT_FNMA(p[13], t89, t111); /* t20*v_nu - I1*I3/m*t82*D scaled*K*1/(Theta scaled*D scaled*K)*t87 */
    const double t113 = p[20]*t26; /* 2*R^2*I1*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) */
    const double t114 = JLT_FMS(t112, t113, t110); /* t112*2*R^2*I1*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K) - t110 */
    const double t115 = JLT_FNMA(t64, t109, t114); /* t114 - t64*t92*R*I1*I3/m */
    const double t116 = -t1; /* -s*omega_tau */
    const double t117 = -t48; /* -s*gamma3 */
    const double t118 = -t55; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t22;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t23;
    out[9] = t29;
    out[10] = t47;
    out[11] = 0.0;
    out[12] = t50;
    out[13] = t54;
    out[14] = t72;
    out[15] = t97;
    out[16] = t99;
    out[17] = t103;
    out[18] = t108;
    out[19] = t115;
    out[20] = t116;
    out[21] = 0.0;
    out[22] = t117;
    out[23] = 0.0;
    out[24] = t118;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[4]*p[7]; /* s*R*G */
    const double t3 = p[9] + x[0]; /* b scaled = a3/R + gamma3 */
    const double t4 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t5 = JLT_FMA(t3, t4, t2); /* b scaled*v_tau*R*I3 + s*R*G */
    const double t6 = x[4]*x[4]; /* s*s */
    const double t7 = JLT_FMA(p[25], t6, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t8 = t6*p[11]; /* s*s*R^2*I1 */
    const double t9 = t3*p[12]; /* b scaled*R^2*I3 */
    const double t10 = JLT_FMA(t3, t9, t8); /* K = b scaled*b scaled*R^2*I3 + s*s*R^2*I1 */
    const double t11 = t10 + p[13]; /* Theta scaled = K + I1*I3/m */
    const double t12 = t7*t10; /* D*K */
    const double t13 = t11*t12; /* Theta scaled*D*K */
    const double t14 = 1.0/t13; /* 1/(Theta scaled*D*K) */
    const double t15 = t11*t14; /* Theta scaled*1/(Theta scaled*D*K) */
    const double t16 = t7*t15; /* D*Theta scaled*1/(Theta scaled*D*K) */
    const double t17 = t5*t16; /* (b scaled*v_tau*R*I3 + s*R*G)*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t18 = x[3]*t17; /* v_tau*t17 */
    const double t19 = t0*p[25]; /* s*omega_tau*m*a3^2 */
    const double t20 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t21 = t19*t20; /* s*omega_tau*m*a3^2*s*omega_tau*gamma3 */
    const double t22 = x[4]*x[3]; /* s*v_tau */
    const double t23 = JLT_FNMA(t3, p[15], t22); /* s*v_tau - b scaled*G/I1 */
    const double t24 = x[4]*t16; /* s*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t25 = p[8]*t23; /* R*I3*(s*v_tau - b scaled*G/I1) */
    const double t26 = t24*t25; /* s*D*Theta scaled*1/(Theta scaled*D*K)*R*I3*(s*v_tau - b scaled*G/I1) */
    const double t27 = x[0]*t17; /* gamma3*t17 */
    const double t28 = t26 + t27; /* t26 + gamma3*t17 */
    const double t29 = p[3]*t17; /* I1*t17 */
    const double t30 = JLT_FNMA(t6, p[28], t21); /* s*omega_tau*m*a3^2*s*omega_tau*gamma3 - s*s*m*g*a3 */
    const double t31 = JLT_FNMA(t28, t29, t30); /* numerator of d(omega_tau)/dt over D = s*omega_tau*m*a3^2*s*omega_tau*gamma3 - s*s*m*g*a3 - (t26 + gamma3*t17)*I1*t17 */
    const double t32 = t10*t15; /* K*Theta scaled*1/(Theta scaled*D*K) */
    const double t33 = t31*t32; /* numerator of d(omega_tau)/dt over D*K*Theta scaled*1/(Theta scaled*D*K) */
    const double t34 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t35 = JLT_FMA(x[2], t34, x[1]); /* V = omega_tau*e + v_nu */
    const double t36 = t12*t14; /* D*K*1/(Theta scaled*D*K) */
    const double t37 = t35*t36; /* V*D*K*1/(Theta scaled*D*K) */
    const double t38 = JLT_FNMA(p[13], t37, x[1]); /* v_nu - I1*I3/m*V*D*K*1/(Theta scaled*D*K) */
    const double t39 = t5*t38; /* (b scaled*v_tau*R*I3 + s*R*G)*(v_nu - I1*I3/m*V*D*K*1/(Theta scaled*D*K)) */
    const double t40 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t41 = t36*t40; /* D*K*1/(Theta scaled*D*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t42 = p[16]*t41; /* R*I1*I3/m*D*K*1/(Theta scaled*D*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t43 = t23*t42; /* (s*v_tau - b scaled*G/I1)*t42 */
    const double t44 = JLT_FMA(t0, t43, t39); /* s*omega_tau*(s*v_tau - b scaled*G/I1)*t42 + t39 */
    const double t45 = t16*t44; /* D*Theta scaled*1/(Theta scaled*D*K)*(s*omega_tau*(s*v_tau - b scaled*G/I1)*t42 + t39) */
    const double t46 = -t45; /* -t45 */
    const double t47 = -t20; /* -s*omega_tau*gamma3 */
    const double t48 = t0*2.0; /* s*omega_tau*2 */
    const double t49 = x[3]*t16; /* v_tau*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t50 = t4*t49; /* v_tau*R*I3*v_tau*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t51 = t3*t16; /* b scaled*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t52 = p[19]*t51; /* 2*R^2*I3*b scaled*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t53 = JLT_FNMA(t18, t52, t50); /* v_tau*R*I3*v_tau*D*Theta scaled*1/(Theta scaled*D*K) - v_tau*t17*2*R^2*I3*b scaled*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t54 = JLT_FMA(t4, t51, t17); /* v_tau*R*I3*b scaled*D*Theta scaled*1/(Theta scaled*D*K) + t17 */
    const double t55 = p[7]*t49; /* R*G*v_tau*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t56 = t17*t24; /* t17*s*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t57 = x[3]*t56; /* v_tau*t17*s*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t58 = JLT_FNMA(p[20], t57, t55); /* R*G*v_tau*D*Theta scaled*1/(Theta scaled*D*K) - 2*R^2*I1*v_tau*t17*s*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t59 = t0*t19; /* s*omega_tau*s*omega_tau*m*a3^2 */
    const double t60 = t51*p[34]; /* b scaled*D*Theta scaled*1/(Theta scaled*D*K)*4*R^2*I1*I3 */
    const double t61 = JLT_FNMA(t27, t60, t29); /* I1*t17 - gamma3*t17*b scaled*D*Theta scaled*1/(Theta scaled*D*K)*4*R^2*I1*I3 */
    const double t62 = JLT_FMA(t27, 2.0, t26); /* gamma3*t17*2 + t26 */
    const double t63 = t49*p[35]; /* v_tau*D*Theta scaled*1/(Theta scaled*D*K)*R*I1*I3 */
    const double t64 = t23*p[36]; /* (s*v_tau - b scaled*G/I1)*4*R^3*I1*I3^2 */
    const double t65 = t51*t64; /* b scaled*D*Theta scaled*1/(Theta scaled*D*K)*(s*v_tau - b scaled*G/I1)*4*R^3*I1*I3^2 */
    const double t66 = JLT_FMA(t56, t65, t59); /* t17*s*D*Theta scaled*1/(Theta scaled*D*K)*t65 + s*omega_tau*s*omega_tau*m*a3^2 */
    const double t67 = JLT_FMA(t56, p[37], t66); /* t17*s*D*Theta scaled*1/(Theta scaled*D*K)*R*I3*G + t66 */
    const double t68 = JLT_FNMA(t17, t61, t67); /* t17*s*D*Theta scaled*1/(Theta scaled*D*K)*R*I3*G + t66 - t17*t61 */
    const double t69 = JLT_FNMA(t62, t63, t68); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t68 - (gamma3*t17*2 + t26)*v_tau*D*Theta scaled*1/(Theta scaled*D*K)*R*I1*I3 */
    const double t70 = t32*t69; /* K*Theta scaled*1/(Theta scaled*D*K)*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    const double t71 = x[4]*t32; /* s*K*Theta scaled*1/(Theta scaled*D*K) */
    const double t72 = t20*p[38]; /* s*omega_tau*gamma3*2*m*a3^2 */
    const double t73 = t71*t72; /* s*K*Theta scaled*1/(Theta scaled*D*K)*s*omega_tau*gamma3*2*m*a3^2 */
    const double t74 = t32*t51; /* K*Theta scaled*1/(Theta scaled*D*K)*b scaled*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t75 = t62*t74; /* (gamma3*t17*2 + t26)*t74 */
    const double t76 = JLT_FMA(t56, t71, t75); /* t17*s*D*Theta scaled*1/(Theta scaled*D*K)*s*K*Theta scaled*1/(Theta scaled*D*K) + (gamma3*t17*2 + t26)*t74 */
    const double t77 = p[39]*t76; /* (-R*I1*I3)*t76 */
    const double t78 = t71*p[38]; /* s*K*Theta scaled*1/(Theta scaled*D*K)*2*m*a3^2 */
    const double t79 = t33*t78; /* t33*s*K*Theta scaled*1/(Theta scaled*D*K)*2*m*a3^2 */
    const double t80 = x[2]*t72; /* omega_tau*s*omega_tau*gamma3*2*m*a3^2 */
    const double t81 = t16*t23; /* D*Theta scaled*1/(Theta scaled*D*K)*(s*v_tau - b scaled*G/I1) */
    const double t82 = JLT_FMA(t17, t81, t57); /* t17*t81 + v_tau*t17*s*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t83 = t16*p[41]; /* D*Theta scaled*1/(Theta scaled*D*K)*R*I1*G */
    const double t84 = t56*p[42]; /* t17*s*D*Theta scaled*1/(Theta scaled*D*K)*4*R^2*I1^2 */
    const double t85 = JLT_FNMA(x[4], p[40], t80); /* omega_tau*s*omega_tau*gamma3*2*m*a3^2 - s*2*m*g*a3 */
    const double t86 = JLT_FMA(t28, t84, t85); /* (t26 + gamma3*t17)*t17*s*D*Theta scaled*1/(Theta scaled*D*K)*4*R^2*I1^2 + omega_tau*s*omega_tau*gamma3*2*m*a3^2 - s*2*m*g*a3 */
    const double t87 = JLT_FNMA(p[35], t82, t86); /* t86 - R*I1*I3*(t17*t81 + v_tau*t17*s*D*Theta scaled*1/(Theta scaled*D*K)) */
    const double t88 = JLT_FNMA(t62, t83, t87); /* d(numerator of d(omega_tau)/dt over D)/d(s) = t87 - (gamma3*t17*2 + t26)*D*Theta scaled*1/(Theta scaled*D*K)*R*I1*G */
    const double t89 = JLT_FMS(t32, t88, t79); /* K*Theta scaled*1/(Theta scaled*D*K)*d(numerator of d(omega_tau)/dt over D)/d(s) - t33*s*K*Theta scaled*1/(Theta scaled*D*K)*2*m*a3^2 */
    const double t90 = t45*t52; /* t45*2*R^2*I3*b scaled*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t91 = t5*t36; /* (b scaled*v_tau*R*I3 + s*R*G)*D*K*1/(Theta scaled*D*K) */
    const double t92 = x[2]*p[30]; /* omega_tau*I1*I3*a3/m */
    const double t93 = t91*t92; /* (b scaled*v_tau*R*I3 + s*R*G)*D*K*1/(Theta scaled*D*K)*omega_tau*I1*I3*a3/m */
    const double t94 = t37*t91; /* V*D*K*1/(Theta scaled*D*K)*(b scaled*v_tau*R*I3 + s*R*G)*D*K*1/(Theta scaled*D*K) */
    const double t95 = t0*t36; /* s*omega_tau*D*K*1/(Theta scaled*D*K) */
    const double t96 = t23*t95; /* (s*v_tau - b scaled*G/I1)*s*omega_tau*D*K*1/(Theta scaled*D*K) */
    const double t97 = p[1]*t41; /* R*D*K*1/(Theta scaled*D*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t98 = JLT_FNMA(t96, t97, t94); /* t94 - t96*R*D*K*1/(Theta scaled*D*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t99 = t3*p[31]; /* b scaled*2*R^2*I1*I3^2/m */
    const double t100 = t40*p[33]; /* (gamma3*R*(I1 - I3) - I3*a3)*R*I3*G/m */
    const double t101 = JLT_FMA(t95, t100, t93); /* s*omega_tau*D*K*1/(Theta scaled*D*K)*(gamma3*R*(I1 - I3) - I3*a3)*R*I3*G/m + t93 */
    const double t102 = JLT_FNMA(t96, p[32], t101); /* t101 - t96*R^2*I1*I3*(I1 - I3)/m */
    const double t103 = JLT_FNMA(t4, t38, t102); /* t101 - t96*R^2*I1*I3*(I1 - I3)/m - v_tau*R*I3*(v_nu - I1*I3/m*V*D*K*1/(Theta scaled*D*K)) */
    const double t104 = JLT_FNMA(t98, t99, t103); /* d(numerator of d(v_tau)/dt over K)/d(gamma3) = t103 - t98*b scaled*2*R^2*I1*I3^2/m */
    const double t105 = JLT_FMA(t16, t104, t90); /* D*Theta scaled*1/(Theta scaled*D*K)*d(numerator of d(v_tau)/dt over K)/d(gamma3) + t45*2*R^2*I3*b scaled*D*Theta scaled*1/(Theta scaled*D*K) */
    const double t106 = p[13]*t91; /* I1*I3/m*(b scaled*v_tau*R*I3 + s*R*G)*D*K*1/(Theta scaled*D*K) */
    const double t107 = t106 - t5; /* d(numerator of d(v_tau)/dt over K)/d(v_nu) = t106 - (b scaled*v_tau*R*I3 + s*R*G) */
    const double t108 = t16*t107; /* D*Theta scaled*1/(Theta scaled*D*K)*d(numerator of d(v_tau)/dt over K)/d(v_nu) */
    const double t109 = t34*t106; /* e*t106 */
    const double t110 = JLT_FNMA(x[4], t43, t109); /* d(numerator of d(v_tau)/dt over K)/d(omega_tau) = e*t106 - s*(s*v_tau - b scaled*G/I1)*t42 */
    const double t111 = t16*t110; /* D*Theta scaled*1/(Theta scaled*D*K)*d(numerator of d(v_tau)/dt over K)/d(omega_tau) */
    const double t112 = t3*p[8]; /* b scaled*R*I3 */
    const double t113 = t38*t112; /* (v_nu - I1*I3/m*V*D*K*1/(Theta scaled*D*K))*b scaled*R*I3 */
    const double t114 = JLT_FMA(t1, t42, t113); /* s*s*omega_tau*t42 + (v_nu - I1*I3/m*V*D*K*1/(Theta scaled*D*K))*b scaled*R*I3 */
    const double t115 = t16*t114; /* D*Theta scaled*1/(Theta scaled*D*K)*t114 */
    const double t116 = -t115; /* -D*Theta scaled*1/(Theta scaled*D*K)*t114 */
    const double t117 = x[2]*t23; /* omega_tau*(s*v_tau - b scaled*G/I1) */
    const double t118 = JLT_FMA(t0, x[3], t117); /* s*omega_tau*v_tau + omega_tau*(s*v_tau - b scaled*G/I1) */
    const double t119 = t42*t118; /* t42*(s*omega_tau*v_tau + omega_tau*(s*v_tau - b scaled*G/I1)) */
    const double t120 = x[4]*p[43]; /* s*2*R^2*I1^2*I3/m */
    const double t121 = JLT_FMA(p[7], t38, t119); /* R*G*(v_nu - I1*I3/m*V*D*K*1/(Theta scaled*D*K)) + t119 */
    const double t122 = JLT_FMA(t98, t120, t121); /* t98*s*2*R^2*I1^2*I3/m + R*G*(v_nu - I1*I3/m*V*D*K*1/(Theta scaled*D*K)) + t119 */
    const double t123 = t16*t122; /* D*Theta scaled*1/(Theta scaled*D*K)*t122 */
    const double t124 = t24*p[20]; /* s*D*Theta scaled*1/(Theta scaled*D*K)*2*R^2*I1 */
    const double t125 = JLT_FMS(t45, t124, t123); /* t45*s*D*Theta scaled*1/(Theta scaled*D*K)*2*R^2*I1 - D*Theta scaled*1/(Theta scaled*D*K)*t122 */
    const double t126 = -t0; /* -s*omega_tau */
    const double t127 = x[4]*x[0]; /* s*gamma3 */
    const double t128 = -t127; /* -s*gamma3 */
    const double t129 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t130 = -t129; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t18;
    out[2] = t33;
    out[3] = t46;
    out[4] = t47;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t6;
    out[8] = 0.0;
    out[9] = t48;
    out[10] = t53;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t54;
    out[14] = t58;
    out[15] = t70;
    out[16] = 0.0;
    out[17] = t73;
    out[18] = t77;
    out[19] = t89;
    out[20] = t105;
    out[21] = t108;
    out[22] = t111;
    out[23] = t116;
    out[24] = t125;
    out[25] = t126;
    out[26] = 0.0;
    out[27] = t128;
    out[28] = 0.0;
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
    const double t10 = t5*t9; /* Theta*1/(Theta*K*D) */
    const double t11 = p[38]*x[0]; /* 2*m*a3^2*gamma3 */
    const double t12 = t4*t11; /* K*2*m*a3^2*gamma3 */
    const double t13 = t10*t12; /* Theta*1/(Theta*K*D)*K*2*m*a3^2*gamma3 */
    const double t14 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t15 = t6*t9; /* D*1/(Theta*K*D) */
    const double t16 = p[35]*t14; /* R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t17 = JLT_FNMA(t15, t16, t13); /* Theta*1/(Theta*K*D)*K*2*m*a3^2*gamma3 - D*1/(Theta*K*D)*R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t18 = JLT_FMS(t0, t17, x[0]); /* s*s*t17 - gamma3 */
    const double t19 = x[2]*t18; /* omega_tau*(s*s*t17 - gamma3) */
    const double t20 = t6*x[1]; /* D*v_nu */
    const double t21 = t10*t20; /* Theta*1/(Theta*K*D)*D*v_nu */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = p[44]*t23; /* I1*I3*V */
    const double t25 = JLT_FNMA(t15, t24, t21); /* Theta*1/(Theta*K*D)*D*v_nu - D*1/(Theta*K*D)*I1*I3*V */
    const double t26 = JLT_FNMA(t3, t25, t19); /* omega_tau*(s*s*t17 - gamma3) - b*I3*(Theta*1/(Theta*K*D)*D*v_nu - D*1/(Theta*K*D)*I1*I3*V) */
    out[0] = t26;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[28]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = x[0] + p[9]; /* b scaled = gamma3 + a3/R */
    const double t3 = p[46]*t2; /* I3/I1*b scaled */
    const double t4 = JLT_FMA(t2, t3, t1); /* K scaled = b scaled*I3/I1*b scaled + s*s */
    const double t5 = t4 + p[48]; /* Theta scaled = K scaled + I3/(m*R^2) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[47]); /* Theta scaled*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = t7/t4; /* (Theta scaled*v_tau*v_tau + G^2/(m*R^2*I1))/K scaled */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + (Theta scaled*v_tau*v_tau + G^2/(m*R^2*I1))/K scaled */
    const double t10 = JLT_FMA(t1, p[25], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t11 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t12 = x[2]*t11; /* omega_tau*1/2*omega_tau */
    const double t13 = JLT_FMA(t10, t12, t0); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(p[45], t9, t13); /* 1/2*m*t9 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    out[0] = t14;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[9] + x[0]; /* b scaled = a3/R + gamma3 */
    const double t1 = p[12]*t0; /* R^2*I3*b scaled */
    const double t2 = x[4]*p[11]; /* s*R^2*I1 */
    const double t3 = x[4]*t2; /* s*s*R^2*I1 */
    const double t4 = JLT_FMA(t0, t1, t3); /* K = b scaled*R^2*I3*b scaled + s*s*R^2*I1 */
    const double t5 = 1.0/t4; /* 1/K */
    const double t6 = t5*p[49]; /* 1/K*G^2 */
    const double t7 = x[3]*x[3]; /* v_tau*v_tau */
    const double t8 = JLT_FMA(t4, p[0], p[44]); /* Theta = K*m + I1*I3 */
    const double t9 = t5*t8; /* 1/K*Theta */
    const double t10 = JLT_FNMA(t7, p[0], t6); /* 1/K*G^2 - v_tau*v_tau*m */
    const double t11 = JLT_FMA(t7, t9, t10); /* v_tau*v_tau*1/K*Theta + 1/K*G^2 - v_tau*v_tau*m */
    const double t12 = t5*t11; /* 1/K*(v_tau*v_tau*1/K*Theta + 1/K*G^2 - v_tau*v_tau*m) */
    const double t13 = JLT_FNMA(t1, t12, p[28]); /* m*g*a3 - R^2*I3*b scaled*1/K*(v_tau*v_tau*1/K*Theta + 1/K*G^2 - v_tau*v_tau*m) */
    const double t14 = p[0]*x[1]; /* m*v_nu */
    const double t15 = x[4]*p[25]; /* s*m*a3^2 */
    const double t16 = JLT_FMA(x[4], t15, p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t17 = x[2]*t16; /* omega_tau*D */
    const double t18 = x[3]*t9; /* v_tau*1/K*Theta */
    const double t19 = x[2]*p[50]; /* omega_tau*m*a3^2/(R^2*I1) */
    const double t20 = JLT_FMS(x[2], t19, t12); /* omega_tau*omega_tau*m*a3^2/(R^2*I1) - 1/K*(v_tau*v_tau*1/K*Theta + 1/K*G^2 - v_tau*v_tau*m) */
    const double t21 = t2*t20; /* s*R^2*I1*t20 */
    out[0] = t13;
    out[1] = t14;
    out[2] = t17;
    out[3] = t18;
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
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
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
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
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
        t2[k] = jlt_jet_product(x4, x4, k);
        t3[k] = jlt_jet_product(x2, t2, k);
        t6[k] = x4[k]*p[7];
        t10[k] = (k == 0 ? p[9] : 0) + x0[k];
        t11[k] = x3[k]*p[8];
        t12[k] = jlt_jet_product(t10, t11, k) + t6[k];
        t15[k] = t2[k]*p[10] + (k == 0 ? 1.0 : 0);
        t17[k] = t2[k]*p[11];
        t19[k] = t10[k]*p[12];
        t20[k] = jlt_jet_product(t10, t19, k) + t17[k];
        t22[k] = t20[k] + (k == 0 ? p[13] : 0);
        t23[k] = jlt_jet_product(t15, t20, k);
        t24[k] = jlt_jet_product(t22, t23, k);
        t25[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t24, t25, k);
        t26[k] = jlt_jet_product(t22, t25, k);
        t27[k] = jlt_jet_product(t15, t26, k);
        t28[k] = jlt_jet_product(t12, t27, k);
        t29[k] = jlt_jet_product(x3, t28, k);
        t30[k] = jlt_jet_product(x2, x0, k);
        t31[k] = p[10]*t30[k];
        t32[k] = jlt_jet_product(t3, t31, k);
        t34[k] = jlt_jet_product(x0, t28, k);
        t35[k] = jlt_jet_product(x4, x3, k);
        t37[k] = t35[k] - t10[k]*p[15];
        t38[k] = jlt_jet_product(x4, t37, k);
        t39[k] = jlt_jet_product(t27, t38, k);
        t40[k] = p[8]*t39[k] + t34[k];
        t41[k] = t32[k] - t2[k]*p[14];
        t42[k] = t41[k] - jlt_jet_product(t28, t40, k);
        t43[k] = jlt_jet_product(t20, t26, k);
        t44[k] = jlt_jet_product(t42, t43, k);
        t48[k] = x0[k]*p[5] + (k == 0 ? p[1] : 0);
        t49[k] = jlt_jet_product(x2, t48, k) + x1[k];
        t50[k] = jlt_jet_product(t23, t25, k);
        t51[k] = p[13]*t49[k];
        t52[k] = x1[k] - jlt_jet_product(t50, t51, k);
        t53[k] = jlt_jet_product(t28, t52, k);
        t57[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t58[k] = x2[k]*p[16];
        t59[k] = jlt_jet_product(t57, t58, k);
        t60[k] = jlt_jet_product(t50, t59, k);
        t61[k] = jlt_jet_product(t39, t60, k) + t53[k];
        t62[k] = -t61[k];
        t63[k] = jlt_jet_product(x4, t30, k);
        t64[k] = -t63[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t29[k]/(k + 1);
        next[2] = x2[k + 1] = t44[k]/(k + 1);
        next[3] = x3[k + 1] = t62[k]/(k + 1);
        next[4] = x4[k + 1] = t64[k]/(k + 1);
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
    .rhs = { rhs, 5, { 4, 28, 12, 1, 0, 0, 13, 12 }, { 21, 82, 0, 8, 0, 0, 11, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .jacobian = { jacobian, 25, { 9, 73, 36, 1, 0, 0, 15, 26 }, { 114, 577, 0, 55, 0, 0, 18, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 81, 39, 1, 0, 0, 15, 33 }, { 129, 644, 0, 63, 0, 0, 18, 12 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .divergence = { divergence, 1, { 0, 15, 11, 1, 0, 0, 12, 8 }, { 12, 40, 0, 4, 0, 0, 12, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .integral_values = { integral_values, 1, { 2, 6, 6, 1, 0, 0, 8, 6 }, { 8, 27, 0, 2, 0, 0, 12, 6 },
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
