/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   30   12    1    1    0     18   12   (110)
 *  jacobian            10   58   33    1    1    0     20   27   (567)
 *  rhs_jacobian        11   59   35    1    1    0     22   35   (653)
 *  divergence          3   19   10    1    1    0     13   10   (60)
 *  integral_values     4    6    6    1    0    0      8    6   (40)
 *  integral_gradients  6   11    5    1    0    0     10    8   (59)
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
    const double t2 = t0*params[4]; /* R*R*I3 */
    const double t3 = params[5]/params[1]; /* a3/R */
    const double t4 = params[1]*params[6]; /* R*G */
    const double t5 = params[1]*params[4]; /* R*I3 */
    const double t6 = params[5]*params[5]; /* a3*a3 */
    const double t7 = params[0]*t6; /* m*a3*a3 */
    const double t8 = t7/params[3]; /* m*a3*a3/I1 */
    const double t9 = params[3]*params[4]; /* I1*I3 */
    const double t10 = t9/params[0]; /* I1*I3/m */
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
    const double t21 = t0*2.0; /* R*R*2 */
    const double t22 = params[3]*t21; /* I1*R*R*2 */
    const double t23 = params[4]*t21; /* I3*R*R*2 */
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t6*t24; /* a3*a3*m*2 */
    const double t26 = t25/params[3]; /* a3*a3*m*2/I1 */
    const double t27 = params[0]*params[0]; /* m*m */
    const double t28 = 2.0*t27; /* 2*m*m */
    const double t29 = params[2]*t28; /* g*2*m*m */
    const double t30 = params[3]*params[3]; /* I1*I1 */
    const double t31 = params[5]*t6; /* a3*a3*a3 */
    const double t32 = t29*t31; /* g*2*m*m*a3*a3*a3 */
    const double t33 = t32/t30; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    const double t34 = params[1]*t24; /* R*m*2 */
    const double t35 = params[4]*t34; /* I3*R*m*2 */
    const double t36 = t6*t35; /* a3*a3*I3*R*m*2 */
    const double t37 = t36/params[3]; /* a3*a3*I3*R*m*2/I1 */
    const double t38 = t1*params[4]; /* R*R*I1*I3 */
    const double t39 = t18*t38; /* (I1 - I3)*R*R*I1*I3 */
    const double t40 = t39/params[0]; /* (I1 - I3)*R*R*I1*I3/m */
    const double t41 = params[5]*t9; /* a3*I1*I3 */
    const double t42 = t41/params[0]; /* a3*I1*I3/m */
    const double t43 = t6*t6; /* a3*a3*a3*a3 */
    const double t44 = t28*t43; /* 2*m*m*a3*a3*a3*a3 */
    const double t45 = t44/t30; /* 2*m*m*a3*a3*a3*a3/(I1*I1) */
    const double t46 = params[4]/t1; /* I3/(R*R*I1) */
    const double t47 = t0*params[0]; /* R*R*m */
    const double t48 = params[4]/t47; /* I3/(R*R*m) */
    const double t49 = params[1]*t0; /* R*R*R */
    const double t50 = params[0]*t49; /* m*R*R*R */
    const double t51 = params[3]*t50; /* I1*m*R*R*R */
    const double t52 = params[4]/t51; /* I3/(I1*m*R*R*R) */
    const double t53 = params[0]/2.0; /* m/2 */
    const double t54 = params[4]/params[3]; /* I3/I1 */
    const double t55 = params[3]*t47; /* I1*R*R*m */
    const double t56 = params[6]*params[6]; /* G*G */
    const double t57 = t56/t55; /* G*G/(I1*R*R*m) */
    const double t58 = t56/t1; /* G*G/(R*R*I1) */
    out[7] = t1;
    out[8] = t2;
    out[9] = t3;
    out[10] = t4;
    out[11] = t5;
    out[12] = t8;
    out[13] = t10;
    out[14] = t13;
    out[15] = t14;
    out[16] = t17;
    out[17] = t19;
    out[18] = t20;
    out[19] = t22;
    out[20] = t23;
    out[21] = t26;
    out[22] = t33;
    out[23] = t37;
    out[24] = t40;
    out[25] = t42;
    out[26] = t45;
    out[27] = t25;
    out[28] = t46;
    out[29] = t48;
    out[30] = t7;
    out[31] = t52;
    out[32] = t12;
    out[33] = t53;
    out[34] = t54;
    out[35] = t57;
    out[36] = t58;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = t2*p[7]; /* (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t6 = x[0] + p[9]; /* b scaled = gamma3 + a3/R */
    const double t7 = p[8]*t6; /* R^2*I3*b scaled */
    const double t8 = JLT_FMA(t6, t7, t5); /* K = b scaled*R^2*I3*b scaled + (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t9 = t3*p[10]; /* s*R*G */
    const double t10 = x[3]*p[11]; /* v_tau*R*I3 */
    const double t11 = JLT_FMA(t6, t10, t9); /* b scaled*v_tau*R*I3 + s*R*G */
    const double t12 = JLT_FMA(t2, p[12], 1.0); /* D scaled = (1 - gamma3)*(1 + gamma3)*m*a3^2/I1 + 1 */
    const double t13 = t8 + p[13]; /* Theta scaled = K + I1*I3/m */
    const double t14 = t3*t8; /* s*K */
    const double t15 = t12*t14; /* D scaled*s*K */
    const double t16 = t13*t15; /* Theta scaled*D scaled*s*K */
    const double t17 = 1.0/t16; /* 1/(Theta scaled*D scaled*s*K) */
    const double t18 = t13*t17; /* Theta scaled*1/(Theta scaled*D scaled*s*K) */
    const double t19 = t12*t18; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*s*K) */
    const double t20 = t3*t19; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*s*K) */
    const double t21 = t11*t20; /* (b scaled*v_tau*R*I3 + s*R*G)*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*s*K) */
    const double t22 = t8*t19; /* K*D scaled*Theta scaled*1/(Theta scaled*D scaled*s*K) */
    const double t23 = t21*t22; /* t21*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*s*K) */
    const double t24 = x[3]*t23; /* v_tau*t21*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*s*K) */
    const double t25 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t26 = t4*t25; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t27 = JLT_FNMA(t21, t23, t26); /* omega_tau*s*omega_tau*m*a3^2/I1 - t21*t21*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*s*K) */
    const double t28 = x[0]*t27; /* gamma3*t27 */
    const double t29 = t3*x[3]; /* s*v_tau */
    const double t30 = JLT_FNMA(t6, p[15], t29); /* s*v_tau - b scaled*G/I1 */
    const double t31 = t20*t30; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*s*K)*(s*v_tau - b scaled*G/I1) */
    const double t32 = p[11]*t31; /* R*I3*t31 */
    const double t33 = JLT_FNMA(t3, p[14], t28); /* gamma3*t27 - s*m*g*a3/I1 */
    const double t34 = JLT_FNMA(t21, t32, t33); /* gamma3*t27 - s*m*g*a3/I1 - t21*R*I3*t31 */
    const double t35 = t14*t18; /* s*K*Theta scaled*1/(Theta scaled*D scaled*s*K) */
    const double t36 = t34*t35; /* (gamma3*t27 - s*m*g*a3/I1 - t21*R*I3*t31)*s*K*Theta scaled*1/(Theta scaled*D scaled*s*K) */
    const double t37 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t38 = JLT_FMA(x[2], t37, x[1]); /* V = omega_tau*e + v_nu */
    const double t39 = t15*t17; /* D scaled*s*K*1/(Theta scaled*D scaled*s*K) */
    const double t40 = p[13]*t38; /* I1*I3/m*V */
    const double t41 = JLT_FNMA(t39, t40, x[1]); /* v_nu - D scaled*s*K*1/(Theta scaled*D scaled*s*K)*I1*I3/m*V */
    const double t42 = t23*t41; /* t21*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*s*K)*(v_nu - D scaled*s*K*1/(Theta scaled*D scaled*s*K)*I1*I3/m*V) */
    const double t43 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t44 = x[2]*p[16]; /* omega_tau*R*I1*I3/m */
    const double t45 = t43*t44; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t46 = t39*t45; /* D scaled*s*K*1/(Theta scaled*D scaled*s*K)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t47 = JLT_FMA(t31, t46, t42); /* t31*t46 + t42 */
    const double t48 = -t47; /* -(t31*t46 + t42) */
    out[0] = t4;
    out[1] = t24;
    out[2] = t36;
    out[3] = t48;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = p[7]*t2; /* R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t4 = x[0] + p[9]; /* b scaled = gamma3 + a3/R */
    const double t5 = p[8]*t4; /* R^2*I3*b scaled */
    const double t6 = JLT_FMA(t4, t5, t3); /* K = b scaled*R^2*I3*b scaled + R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t7 = JLT_FMA(t2, p[12], 1.0); /* D scaled = (1 - gamma3)*(gamma3 + 1)*m*a3^2/I1 + 1 */
    const double t8 = t6 + p[13]; /* Theta scaled = K + I1*I3/m */
    const double t9 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t10 = t6*t9; /* K*s */
    const double t11 = t7*t10; /* D scaled*K*s */
    const double t12 = t8*t11; /* Theta scaled*D scaled*K*s */
    const double t13 = 1.0/t12; /* 1/(Theta scaled*D scaled*K*s) */
    const double t14 = t8*t13; /* Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t15 = t7*t14; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t16 = t6*t15; /* K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t17 = x[0]*t16; /* gamma3*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t18 = x[2]*t17; /* omega_tau*gamma3*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t19 = -t18; /* -t18 */
    const double t20 = t4*p[11]; /* b scaled*R*I3 */
    const double t21 = x[3]*t20; /* v_tau*b scaled*R*I3 */
    const double t22 = JLT_FMA(t9, p[10], t21); /* s*R*G + v_tau*b scaled*R*I3 */
    const double t23 = t16*t22; /* K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*(s*R*G + v_tau*b scaled*R*I3) */
    const double t24 = x[0]*p[19]; /* gamma3*2*R^2*I1 */
    const double t25 = JLT_FMS(t4, p[20], t24); /* d(K)/d(gamma3) = b scaled*2*R^2*I3 - gamma3*2*R^2*I1 */
    const double t26 = t9*t15; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t27 = t22*t26; /* (s*R*G + v_tau*b scaled*R*I3)*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t28 = t25*t27; /* d(K)/d(gamma3)*t27 */
    const double t29 = t17*p[10]; /* gamma3*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*R*G */
    const double t30 = JLT_FNMA(x[3], p[11], t29); /* t29 - v_tau*R*I3 */
    const double t31 = t28 + t30; /* d(K)/d(gamma3)*t27 + t29 - v_tau*R*I3 */
    const double t32 = JLT_FMS(t17, t23, t31); /* gamma3*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*t23 - (d(K)/d(gamma3)*t27 + t29 - v_tau*R*I3) */
    const double t33 = t15*x[3]; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*v_tau */
    const double t34 = t32*t33; /* t32*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*v_tau */
    const double t35 = t16*t27; /* K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*t27 */
    const double t36 = JLT_FMA(t15, t21, t35); /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*v_tau*b scaled*R*I3 + K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*t27 */
    const double t37 = t10*t14; /* K*s*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t38 = x[0]*t37; /* gamma3*K*s*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t39 = t9*t38; /* s*gamma3*K*s*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t40 = p[21]*t39; /* 2*m*a3^2/I1*s*gamma3*K*s*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t41 = t17 - t40; /* gamma3*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s) - t40 */
    const double t42 = JLT_FMS(x[0], t41, t9); /* gamma3*t41 - s */
    const double t43 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t44 = x[2]*t43; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t45 = JLT_FMA(t17, x[3], p[15]); /* gamma3*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*v_tau + G/I1 */
    const double t46 = t27*t45; /* t27*t45 */
    const double t47 = t9*x[3]; /* s*v_tau */
    const double t48 = JLT_FNMA(t4, p[15], t47); /* s*v_tau - b scaled*G/I1 */
    const double t49 = t26*t48; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*(s*v_tau - b scaled*G/I1) */
    const double t50 = JLT_FMA(t28, 2.0, t30); /* d(K)/d(gamma3)*t27*2 + t29 - v_tau*R*I3 */
    const double t51 = JLT_FMA(t49, t50, t46); /* t49*(d(K)/d(gamma3)*t27*2 + t29 - v_tau*R*I3) + t27*t45 */
    const double t52 = p[11]*t26; /* R*I3*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t53 = t39*p[22]; /* s*gamma3*K*s*Theta scaled*1/(Theta scaled*D scaled*K*s)*2*m^2*g*a3^3/I1^2 */
    const double t54 = t16*t35; /* K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*t27 */
    const double t55 = t27*t38; /* t27*gamma3*K*s*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t56 = t49*p[23]; /* t49*2*m*R*I3*a3^2/I1 */
    const double t57 = JLT_FNMA(t17, p[14], t53); /* t53 - gamma3*K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*m*g*a3/I1 */
    const double t58 = JLT_FMA(t55, t56, t57); /* t27*gamma3*K*s*Theta scaled*1/(Theta scaled*D scaled*K*s)*t49*2*m*R*I3*a3^2/I1 + t57 */
    const double t59 = JLT_FMA(t35, t54, t58); /* K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*t27*t54 + t58 */
    const double t60 = JLT_FMA(t42, t44, t59); /* (gamma3*t41 - s)*omega_tau*omega_tau*m*a3^2/I1 + t59 */
    const double t61 = JLT_FNMA(t51, t52, t60); /* (gamma3*t41 - s)*omega_tau*omega_tau*m*a3^2/I1 + t59 - (t49*(d(K)/d(gamma3)*t27*2 + t29 - v_tau*R*I3) + t27*t45)*R*I3*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t62 = t37*t61; /* K*s*Theta scaled*1/(Theta scaled*D scaled*K*s)*t61 */
    const double t63 = t26*t31; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*(d(K)/d(gamma3)*t27 + t29 - v_tau*R*I3) */
    const double t64 = JLT_FNMA(p[12], t55, t63); /* t63 - m*a3^2/I1*t27*gamma3*K*s*Theta scaled*1/(Theta scaled*D scaled*K*s) */
    const double t65 = t38*2.0; /* gamma3*K*s*Theta scaled*1/(Theta scaled*D scaled*K*s)*2 */
    const double t66 = t35*t65; /* K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*t27*gamma3*K*s*Theta scaled*1/(Theta scaled*D scaled*K*s)*2 */
    const double t67 = JLT_FMS(t64, t66, t62); /* t64*t66 - K*s*Theta scaled*1/(Theta scaled*D scaled*K*s)*t61 */
    const double t68 = x[2]*t40; /* omega_tau*t40 */
    const double t69 = t4*t66; /* b scaled*t66 */
    const double t70 = t9*t27; /* s*t27 */
    const double t71 = JLT_FMA(t20, t49, t70); /* b scaled*R*I3*t49 + s*t27 */
    const double t72 = JLT_FMA(t37, t71, t69); /* K*s*Theta scaled*1/(Theta scaled*D scaled*K*s)*(b scaled*R*I3*t49 + s*t27) + b scaled*t66 */
    const double t73 = t52*t72; /* R*I3*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*t72 */
    const double t74 = -t73; /* -t73 */
    const double t75 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t76 = JLT_FMA(x[2], t75, x[1]); /* V = omega_tau*e + v_nu */
    const double t77 = t11*t13; /* D scaled*K*s*1/(Theta scaled*D scaled*K*s) */
    const double t78 = p[13]*t77; /* I1*I3/m*D scaled*K*s*1/(Theta scaled*D scaled*K*s) */
    const double t79 = JLT_FNMA(t76, t78, x[1]); /* v_nu - V*I1*I3/m*D scaled*K*s*1/(Theta scaled*D scaled*K*s) */
    const double t80 = t15*t79; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*(v_nu - V*I1*I3/m*D scaled*K*s*1/(Theta scaled*D scaled*K*s)) */
    const double t81 = t32*t80; /* t32*t80 */
    const double t82 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t83 = p[16]*t82; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t84 = t77*t83; /* D scaled*K*s*1/(Theta scaled*D scaled*K*s)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t85 = x[2]*t84; /* omega_tau*t84 */
    const double t86 = t26*t85; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*omega_tau*t84 */
    const double t87 = JLT_FMA(t26, t83, t84); /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) + t84 */
    const double t88 = JLT_FNMA(t25, t87, p[24]); /* R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t87 */
    const double t89 = t49*t88; /* t49*(R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t87) */
    const double t90 = JLT_FNMA(t35, p[25], t89); /* t49*(R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t87) - K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*t27*I1*I3*a3/m */
    const double t91 = x[2]*t90; /* omega_tau*t90 */
    const double t92 = t35*t78; /* K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*t27*I1*I3/m*D scaled*K*s*1/(Theta scaled*D scaled*K*s) */
    const double t93 = t25*t76; /* d(K)/d(gamma3)*V */
    const double t94 = JLT_FMA(t92, t93, t91); /* t92*d(K)/d(gamma3)*V + omega_tau*t90 */
    const double t95 = JLT_FMS(t45, t86, t81); /* t45*t86 - t32*t80 */
    const double t96 = JLT_FNMA(t77, t94, t95); /* t45*t86 - t32*t80 - D scaled*K*s*1/(Theta scaled*D scaled*K*s)*(t92*d(K)/d(gamma3)*V + omega_tau*t90) */
    const double t97 = t92 - t35; /* t92 - K*D scaled*Theta scaled*1/(Theta scaled*D scaled*K*s)*t27 */
    const double t98 = t75*t92; /* e*t92 */
    const double t99 = JLT_FNMA(t49, t84, t98); /* e*t92 - t49*t84 */
    const double t100 = t20*t80; /* b scaled*R*I3*t80 */
    const double t101 = JLT_FMA(t9, t86, t100); /* s*t86 + b scaled*R*I3*t80 */
    const double t102 = -t101; /* -(s*t86 + b scaled*R*I3*t80) */
    out[0] = t19;
    out[1] = 0.0;
    out[2] = t9;
    out[3] = 0.0;
    out[4] = t34;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t36;
    out[8] = t67;
    out[9] = 0.0;
    out[10] = t68;
    out[11] = t74;
    out[12] = t96;
    out[13] = t97;
    out[14] = t99;
    out[15] = t102;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = t3*p[10]; /* s*R*G */
    const double t6 = x[0] + p[9]; /* b scaled = gamma3 + a3/R */
    const double t7 = x[3]*p[11]; /* v_tau*R*I3 */
    const double t8 = JLT_FMA(t6, t7, t5); /* b scaled*v_tau*R*I3 + s*R*G */
    const double t9 = t2*p[7]; /* (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t10 = t6*p[8]; /* b scaled*R^2*I3 */
    const double t11 = JLT_FMA(t6, t10, t9); /* K = b scaled*b scaled*R^2*I3 + (1 - gamma3)*(1 + gamma3)*R^2*I1 */
    const double t12 = t11 + p[13]; /* Theta scaled = K + I1*I3/m */
    const double t13 = JLT_FMA(t2, p[12], 1.0); /* D scaled = (1 - gamma3)*(1 + gamma3)*m*a3^2/I1 + 1 */
    const double t14 = t11*t12; /* K*Theta scaled */
    const double t15 = t3*t14; /* s*K*Theta scaled */
    const double t16 = t13*t15; /* D scaled*s*K*Theta scaled */
    const double t17 = 1.0/t16; /* 1/(D scaled*s*K*Theta scaled) */
    const double t18 = t13*t17; /* D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t19 = t12*t18; /* Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t20 = t3*t19; /* s*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t21 = t8*t20; /* (b scaled*v_tau*R*I3 + s*R*G)*s*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t22 = t11*t19; /* K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t23 = t21*t22; /* t21*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t24 = x[3]*t23; /* v_tau*t21*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t25 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t26 = t15*t17; /* s*K*Theta scaled*1/(D scaled*s*K*Theta scaled) */
    const double t27 = x[0]*t26; /* gamma3*s*K*Theta scaled*1/(D scaled*s*K*Theta scaled) */
    const double t28 = t4*t27; /* omega_tau*s*gamma3*s*K*Theta scaled*1/(D scaled*s*K*Theta scaled) */
    const double t29 = t3*t26; /* s*s*K*Theta scaled*1/(D scaled*s*K*Theta scaled) */
    const double t30 = t23*t27; /* t21*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*gamma3*s*K*Theta scaled*1/(D scaled*s*K*Theta scaled) */
    const double t31 = t3*x[3]; /* s*v_tau */
    const double t32 = JLT_FNMA(t6, p[15], t31); /* s*v_tau - b scaled*G/I1 */
    const double t33 = p[11]*t20; /* R*I3*s*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t34 = t26*t33; /* s*K*Theta scaled*1/(D scaled*s*K*Theta scaled)*R*I3*s*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t35 = t32*t34; /* (s*v_tau - b scaled*G/I1)*t34 */
    const double t36 = t30 + t35; /* t30 + (s*v_tau - b scaled*G/I1)*t34 */
    const double t37 = t21*t36; /* t21*(t30 + (s*v_tau - b scaled*G/I1)*t34) */
    const double t38 = JLT_FMA(p[14], t29, t37); /* m*g*a3/I1*s*s*K*Theta scaled*1/(D scaled*s*K*Theta scaled) + t21*(t30 + (s*v_tau - b scaled*G/I1)*t34) */
    const double t39 = JLT_FMS(t25, t28, t38); /* omega_tau*m*a3^2/I1*t28 - t38 */
    const double t40 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t41 = t3*t18; /* s*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t42 = p[16]*t40; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t43 = t41*t42; /* s*D scaled*1/(D scaled*s*K*Theta scaled)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t44 = t32*t43; /* (s*v_tau - b scaled*G/I1)*t43 */
    const double t45 = x[2]*t44; /* omega_tau*(s*v_tau - b scaled*G/I1)*t43 */
    const double t46 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t47 = JLT_FMA(x[2], t46, x[1]); /* V = omega_tau*e + v_nu */
    const double t48 = t11*t41; /* K*s*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t49 = t47*t48; /* V*K*s*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t50 = JLT_FNMA(p[13], t49, x[1]); /* v_nu - I1*I3/m*V*K*s*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t51 = JLT_FMA(t23, t50, t45); /* t21*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*(v_nu - I1*I3/m*V*K*s*D scaled*1/(D scaled*s*K*Theta scaled)) + omega_tau*(s*v_tau - b scaled*G/I1)*t43 */
    const double t52 = -t51; /* -t51 */
    const double t53 = x[0]*t22; /* gamma3*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t54 = x[2]*t53; /* omega_tau*gamma3*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t55 = -t54; /* -t54 */
    const double t56 = t22*t23; /* K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*t21*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t57 = t53*t56; /* gamma3*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*t56 */
    const double t58 = x[0]*p[19]; /* gamma3*2*R^2*I1 */
    const double t59 = JLT_FMS(t6, p[20], t58); /* d(K)/d(gamma3) = b scaled*2*R^2*I3 - gamma3*2*R^2*I1 */
    const double t60 = t20*t59; /* s*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*d(K)/d(gamma3) */
    const double t61 = JLT_FMS(p[10], t53, t7); /* R*G*gamma3*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) - v_tau*R*I3 */
    const double t62 = t20*t61; /* s*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*t61 */
    const double t63 = JLT_FNMA(t23, t60, t57); /* t57 - t21*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*t60 */
    const double t64 = JLT_FNMA(t22, t62, t63); /* t63 - K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*s*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*t61 */
    const double t65 = x[3]*t64; /* v_tau*t64 */
    const double t66 = t6*t33; /* b scaled*R*I3*s*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t67 = t22*t66; /* K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*t66 */
    const double t68 = JLT_FMA(x[3], t67, t23); /* v_tau*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*t66 + t21*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t69 = t22*p[14]; /* K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*m*g*a3/I1 */
    const double t70 = x[2]*p[26]; /* omega_tau*2*m^2*a3^4/I1^2 */
    const double t71 = JLT_FNMA(t29, p[22], t69); /* t69 - s*s*K*Theta scaled*1/(D scaled*s*K*Theta scaled)*2*m^2*g*a3^3/I1^2 */
    const double t72 = JLT_FMA(t28, t70, t71); /* t28*omega_tau*2*m^2*a3^4/I1^2 + t71 */
    const double t73 = JLT_FNMA(t25, t54, t72); /* t28*omega_tau*2*m^2*a3^4/I1^2 + t71 - omega_tau*m*a3^2/I1*t54 */
    const double t74 = JLT_FNMA(t37, p[21], t73); /* t73 - t21*(t30 + (s*v_tau - b scaled*G/I1)*t34)*2*m*a3^2/I1 */
    const double t75 = t60*2.0; /* t60*2 */
    const double t76 = t37*t75; /* t21*(t30 + (s*v_tau - b scaled*G/I1)*t34)*t60*2 */
    const double t77 = JLT_FMA(t30, 2.0, t35); /* t30*2 + (s*v_tau - b scaled*G/I1)*t34 */
    const double t78 = JLT_FMA(x[3], t53, p[15]); /* v_tau*gamma3*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) + G/I1 */
    const double t79 = t21*t34; /* t21*t34 */
    const double t80 = t23*t56; /* t21*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*t56 */
    const double t81 = JLT_FNMA(t4, t25, t80); /* t80 - omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t82 = JLT_FMA(t78, t79, t76); /* t78*t21*t34 + t21*(t30 + (s*v_tau - b scaled*G/I1)*t34)*t60*2 */
    const double t83 = JLT_FMA(t62, t77, t82); /* s*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*t61*(t30*2 + (s*v_tau - b scaled*G/I1)*t34) + t82 */
    const double t84 = JLT_FNMA(t26, t81, t83); /* t83 - s*K*Theta scaled*1/(D scaled*s*K*Theta scaled)*(t80 - omega_tau*s*omega_tau*m*a3^2/I1) */
    const double t85 = JLT_FMA(t27, t74, t84); /* gamma3*s*K*Theta scaled*1/(D scaled*s*K*Theta scaled)*(t73 - t21*(t30 + (s*v_tau - b scaled*G/I1)*t34)*2*m*a3^2/I1) + t84 */
    const double t86 = t28*p[21]; /* t28*2*m*a3^2/I1 */
    const double t87 = t66*t77; /* t66*(t30*2 + (s*v_tau - b scaled*G/I1)*t34) */
    const double t88 = JLT_FMA(t3, t79, t87); /* s*t21*t34 + t66*(t30*2 + (s*v_tau - b scaled*G/I1)*t34) */
    const double t89 = -t88; /* -(s*t21*t34 + t66*(t30*2 + (s*v_tau - b scaled*G/I1)*t34)) */
    const double t90 = t23*t48; /* t21*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*K*s*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t91 = p[25]*t90; /* I1*I3*a3/m*t90 */
    const double t92 = t32*p[24]; /* (s*v_tau - b scaled*G/I1)*R^2*I1*I3*(I1 - I3)/m */
    const double t93 = JLT_FNMA(t41, t92, t91); /* I1*I3*a3/m*t90 - s*D scaled*1/(D scaled*s*K*Theta scaled)*(s*v_tau - b scaled*G/I1)*R^2*I1*I3*(I1 - I3)/m */
    const double t94 = JLT_FMA(t43, t78, t93); /* t43*t78 + t93 */
    const double t95 = x[2]*t94; /* omega_tau*(t43*t78 + t93) */
    const double t96 = t20 + t48; /* s*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) + K*s*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t97 = t45*t96; /* omega_tau*(s*v_tau - b scaled*G/I1)*t43*t96 */
    const double t98 = p[13]*t90; /* I1*I3/m*t90 */
    const double t99 = JLT_FNMA(t49, t98, t97); /* omega_tau*(s*v_tau - b scaled*G/I1)*t43*t96 - V*K*s*D scaled*1/(D scaled*s*K*Theta scaled)*I1*I3/m*t90 */
    const double t100 = JLT_FMA(t59, t99, t95); /* d(K)/d(gamma3)*t99 + omega_tau*(t43*t78 + t93) */
    const double t101 = JLT_FNMA(t50, t64, t100); /* d(K)/d(gamma3)*t99 + omega_tau*(t43*t78 + t93) - (v_nu - I1*I3/m*V*K*s*D scaled*1/(D scaled*s*K*Theta scaled))*t64 */
    const double t102 = t98 - t23; /* I1*I3/m*t90 - t21*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled) */
    const double t103 = JLT_FMS(t46, t98, t44); /* e*I1*I3/m*t90 - (s*v_tau - b scaled*G/I1)*t43 */
    const double t104 = t50*t67; /* (v_nu - I1*I3/m*V*K*s*D scaled*1/(D scaled*s*K*Theta scaled))*K*Theta scaled*D scaled*1/(D scaled*s*K*Theta scaled)*t66 */
    const double t105 = JLT_FMA(t4, t43, t104); /* omega_tau*s*t43 + t104 */
    const double t106 = -t105; /* -(omega_tau*s*t43 + t104) */
    out[0] = t4;
    out[1] = t24;
    out[2] = t39;
    out[3] = t52;
    out[4] = t55;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t65;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t68;
    out[12] = t85;
    out[13] = 0.0;
    out[14] = t86;
    out[15] = t89;
    out[16] = t101;
    out[17] = t102;
    out[18] = t103;
    out[19] = t106;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t4 = t3*p[28]; /* b*I3/(R^2*I1) */
    const double t5 = JLT_FMA(t3, t4, t2); /* K scaled = b*b*I3/(R^2*I1) + (1 - gamma3)*(gamma3 + 1) */
    const double t6 = t5 + p[29]; /* Theta scaled = K scaled + I3/(m*R^2) */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = JLT_FMA(t2, p[30], p[3]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t9 = t7*t8; /* s*D */
    const double t10 = t5*t9; /* K scaled*s*D */
    const double t11 = t6*t10; /* Theta scaled*K scaled*s*D */
    const double t12 = 1.0/t11; /* 1/(Theta scaled*K scaled*s*D) */
    const double t13 = t6*t12; /* Theta scaled*1/(Theta scaled*K scaled*s*D) */
    const double t14 = t5*t13; /* K scaled*Theta scaled*1/(Theta scaled*K scaled*s*D) */
    const double t15 = p[27]*t2; /* 2*m*a3^2*(1 - gamma3)*(gamma3 + 1) */
    const double t16 = t8*t14; /* D*K scaled*Theta scaled*1/(Theta scaled*K scaled*s*D) */
    const double t17 = JLT_FMS(t14, t15, t16); /* K scaled*Theta scaled*1/(Theta scaled*K scaled*s*D)*2*m*a3^2*(1 - gamma3)*(gamma3 + 1) - D*K scaled*Theta scaled*1/(Theta scaled*K scaled*s*D) */
    const double t18 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t19 = t17*t18; /* t17*gamma3*omega_tau */
    const double t20 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t21 = t10*t12; /* K scaled*s*D*1/(Theta scaled*K scaled*s*D) */
    const double t22 = x[2]*p[31]; /* omega_tau*I3/(m*R^3*I1) */
    const double t23 = t20*t22; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3/(m*R^3*I1) */
    const double t24 = t7*t23; /* s*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3/(m*R^3*I1) */
    const double t25 = t21*t24; /* K scaled*s*D*1/(Theta scaled*K scaled*s*D)*s*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3/(m*R^3*I1) */
    const double t26 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t27 = JLT_FMA(x[2], t26, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = p[29]*t27; /* I3/(m*R^2)*V */
    const double t29 = JLT_FNMA(t21, t28, x[1]); /* v_nu - K scaled*s*D*1/(Theta scaled*K scaled*s*D)*I3/(m*R^2)*V */
    const double t30 = t4*t29; /* b*I3/(R^2*I1)*t29 */
    const double t31 = JLT_FMA(t16, t30, t25); /* D*K scaled*Theta scaled*1/(Theta scaled*K scaled*s*D)*b*I3/(R^2*I1)*t29 + t25 */
    const double t32 = t9*t13; /* s*D*Theta scaled*1/(Theta scaled*K scaled*s*D) */
    const double t33 = JLT_FNMA(t31, t32, t19); /* t17*gamma3*omega_tau - t31*s*D*Theta scaled*1/(Theta scaled*K scaled*s*D) */
    out[0] = t33;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[32]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = x[0] + p[9]; /* b scaled = gamma3 + a3/R */
    const double t5 = p[34]*t4; /* I3/I1*b scaled */
    const double t6 = JLT_FMA(t4, t5, t3); /* K scaled = b scaled*I3/I1*b scaled + (1 - gamma3)*(gamma3 + 1) */
    const double t7 = t6 + p[29]; /* Theta scaled = K scaled + I3/(m*R^2) */
    const double t8 = x[3]*x[3]; /* v_tau*v_tau */
    const double t9 = JLT_FMA(t7, t8, p[35]); /* Theta scaled*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t10 = t9/t6; /* (Theta scaled*v_tau*v_tau + G^2/(m*R^2*I1))/K scaled */
    const double t11 = JLT_FMA(x[1], x[1], t10); /* v_nu*v_nu + (Theta scaled*v_tau*v_tau + G^2/(m*R^2*I1))/K scaled */
    const double t12 = JLT_FMA(t3, p[30], p[3]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t13 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t14 = x[2]*t13; /* omega_tau*1/2*omega_tau */
    const double t15 = JLT_FMA(t12, t14, t0); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(p[33], t11, t15); /* 1/2*m*t11 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    out[0] = t16;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[30]*x[0]; /* m*a3^2*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = x[0] + p[9]; /* b scaled = gamma3 + a3/R */
    const double t6 = t5*p[34]; /* b scaled*I3/I1 */
    const double t7 = JLT_FMA(t5, t6, t4); /* K scaled = b scaled*b scaled*I3/I1 + (1 - gamma3)*(gamma3 + 1) */
    const double t8 = 1.0/t7; /* 1/K scaled */
    const double t9 = t6 - x[0]; /* d(K)/d(gamma3) scaled = b scaled*I3/I1 - gamma3 */
    const double t10 = t7 + p[29]; /* Theta scaled = K scaled + I3/(m*R^2) */
    const double t11 = x[3]*p[0]; /* v_tau*m */
    const double t12 = t10*t11; /* Theta scaled*v_tau*m */
    const double t13 = t8*t12; /* 1/K scaled*Theta scaled*v_tau*m */
    const double t14 = t13 - t11; /* 1/K scaled*Theta scaled*v_tau*m - v_tau*m */
    const double t15 = x[3]*t14; /* v_tau*(1/K scaled*Theta scaled*v_tau*m - v_tau*m) */
    const double t16 = JLT_FMA(t8, p[36], t15); /* 1/K scaled*G^2/(R^2*I1) + v_tau*(1/K scaled*Theta scaled*v_tau*m - v_tau*m) */
    const double t17 = t8*t9; /* 1/K scaled*d(K)/d(gamma3) scaled */
    const double t18 = JLT_FNMA(t0, t1, p[32]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t19 = JLT_FNMA(t16, t17, t18); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau - t16*1/K scaled*d(K)/d(gamma3) scaled */
    const double t20 = p[0]*x[1]; /* m*v_nu */
    const double t21 = JLT_FMA(p[30], t4, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t22 = x[2]*t21; /* omega_tau*D */
    out[0] = t19;
    out[1] = t20;
    out[2] = t22;
    out[3] = t13;
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
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
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
    double t41[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
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
        t13[k] = x0[k] + (k == 0 ? p[9] : 0);
        t14[k] = p[8]*t13[k];
        t15[k] = jlt_jet_product(t13, t14, k) + t10[k];
        t17[k] = t6[k]*p[10];
        t19[k] = x3[k]*p[11];
        t20[k] = jlt_jet_product(t13, t19, k) + t17[k];
        t22[k] = t5[k]*p[12] + (k == 0 ? 1.0 : 0);
        t24[k] = t15[k] + (k == 0 ? p[13] : 0);
        t25[k] = jlt_jet_product(t6, t15, k);
        t26[k] = jlt_jet_product(t22, t25, k);
        t27[k] = jlt_jet_product(t24, t26, k);
        t28[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t27, t28, k);
        t29[k] = jlt_jet_product(t24, t28, k);
        t30[k] = jlt_jet_product(t22, t29, k);
        t31[k] = jlt_jet_product(t6, t30, k);
        t32[k] = jlt_jet_product(t20, t31, k);
        t33[k] = jlt_jet_product(t15, t30, k);
        t34[k] = jlt_jet_product(t32, t33, k);
        t35[k] = jlt_jet_product(x3, t34, k);
        t36[k] = x2[k]*p[12];
        t37[k] = jlt_jet_product(t7, t36, k);
        t38[k] = t37[k] - jlt_jet_product(t32, t34, k);
        t39[k] = jlt_jet_product(x0, t38, k);
        t41[k] = jlt_jet_product(t6, x3, k);
        t43[k] = t41[k] - t13[k]*p[15];
        t44[k] = jlt_jet_product(t31, t43, k);
        t45[k] = p[11]*t44[k];
        t46[k] = t39[k] - t6[k]*p[14];
        t47[k] = t46[k] - jlt_jet_product(t32, t45, k);
        t48[k] = jlt_jet_product(t25, t29, k);
        t49[k] = jlt_jet_product(t47, t48, k);
        t53[k] = x0[k]*p[5] + (k == 0 ? p[1] : 0);
        t54[k] = jlt_jet_product(x2, t53, k) + x1[k];
        t55[k] = jlt_jet_product(t26, t28, k);
        t56[k] = p[13]*t54[k];
        t57[k] = x1[k] - jlt_jet_product(t55, t56, k);
        t58[k] = jlt_jet_product(t34, t57, k);
        t62[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t63[k] = x2[k]*p[16];
        t64[k] = jlt_jet_product(t62, t63, k);
        t65[k] = jlt_jet_product(t55, t64, k);
        t66[k] = jlt_jet_product(t44, t65, k) + t58[k];
        t67[k] = -t66[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t35[k]/(k + 1);
        next[2] = x2[k + 1] = t49[k]/(k + 1);
        next[3] = x3[k + 1] = t67[k]/(k + 1);
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
    const double t1 = params[5]*t0; /* a3*m*g */
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
    const double t34 = t1 - t33; /* a3*m*g - R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
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
    .state_count = 4, .param_count = 7, .block_count = 37,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 30, 12, 1, 1, 0, 18, 12 }, { 21, 80, 0, 8, 1, 0, 12, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 10, 58, 33, 1, 1, 0, 20, 27 }, { 91, 425, 0, 50, 1, 0, 21, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 11, 59, 35, 1, 1, 0, 22, 35 }, { 105, 489, 0, 58, 1, 0, 21, 14 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 19, 10, 1, 1, 0, 13, 10 }, { 13, 41, 0, 5, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 4, 6, 6, 1, 0, 0, 8, 6 }, { 9, 28, 0, 2, 1, 0, 13, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 6, 11, 5, 1, 0, 0, 10, 8 }, { 10, 44, 0, 4, 1, 0, 15, 10 },
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
