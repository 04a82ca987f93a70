/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   30   12    1    1    0     18   10   (110)
 *  jacobian            10   58   33    1    1    0     20   25   (567)
 *  rhs_jacobian        11   59   35    1    1    0     22   27   (653)
 *  divergence          3   19   10    1    1    0     13   10   (60)
 *  integral_values     4    6    6    1    0    0      8    5   (40)
 *  integral_gradients  6   11    5    1    0    0     10    5   (59)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
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
    out[7] = t1;
    const double t2 = t0*params[4]; /* R*R*I3 */
    out[8] = t2;
    const double t3 = params[5]/params[1]; /* a3/R */
    out[9] = t3;
    const double t4 = params[1]*params[6]; /* R*G */
    out[10] = t4;
    const double t5 = params[1]*params[4]; /* R*I3 */
    out[11] = t5;
    const double t6 = params[5]*params[5]; /* a3*a3 */
    const double t7 = params[0]*t6; /* m*a3*a3 */
    out[30] = t7;
    const double t8 = t7/params[3]; /* m*a3*a3/I1 */
    out[12] = t8;
    const double t9 = params[3]*params[4]; /* I1*I3 */
    const double t10 = t9/params[0]; /* I1*I3/m */
    out[13] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[5]*t11; /* a3*m*g */
    out[32] = t12;
    const double t13 = t12/params[3]; /* a3*m*g/I1 */
    out[14] = t13;
    const double t14 = params[6]/params[3]; /* G/I1 */
    out[15] = t14;
    const double t15 = params[1]*params[3]; /* R*I1 */
    const double t16 = params[4]*t15; /* I3*R*I1 */
    const double t17 = t16/params[0]; /* I3*R*I1/m */
    out[16] = t17;
    const double t18 = params[3] - params[4]; /* I1 - I3 */
    const double t19 = params[1]*t18; /* R*(I1 - I3) */
    out[17] = t19;
    const double t20 = params[4]*params[5]; /* I3*a3 */
    out[18] = t20;
    const double t21 = t0*2.0; /* R*R*2 */
    const double t22 = params[3]*t21; /* I1*R*R*2 */
    out[19] = t22;
    const double t23 = params[4]*t21; /* I3*R*R*2 */
    out[20] = t23;
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t6*t24; /* a3*a3*m*2 */
    out[27] = t25;
    const double t26 = t25/params[3]; /* a3*a3*m*2/I1 */
    out[21] = t26;
    const double t27 = params[0]*params[0]; /* m*m */
    const double t28 = 2.0*t27; /* 2*m*m */
    const double t29 = params[2]*t28; /* g*2*m*m */
    const double t30 = params[3]*params[3]; /* I1*I1 */
    const double t31 = params[5]*t6; /* a3*a3*a3 */
    const double t32 = t29*t31; /* g*2*m*m*a3*a3*a3 */
    const double t33 = t32/t30; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    out[22] = t33;
    const double t34 = params[1]*t24; /* R*m*2 */
    const double t35 = params[4]*t34; /* I3*R*m*2 */
    const double t36 = t6*t35; /* a3*a3*I3*R*m*2 */
    const double t37 = t36/params[3]; /* a3*a3*I3*R*m*2/I1 */
    out[23] = t37;
    const double t38 = t1*params[4]; /* R*R*I1*I3 */
    const double t39 = t18*t38; /* (I1 - I3)*R*R*I1*I3 */
    const double t40 = t39/params[0]; /* (I1 - I3)*R*R*I1*I3/m */
    out[24] = t40;
    const double t41 = params[5]*t9; /* a3*I1*I3 */
    const double t42 = t41/params[0]; /* a3*I1*I3/m */
    out[25] = t42;
    const double t43 = t6*t6; /* a3*a3*a3*a3 */
    const double t44 = t28*t43; /* 2*m*m*a3*a3*a3*a3 */
    const double t45 = t44/t30; /* 2*m*m*a3*a3*a3*a3/(I1*I1) */
    out[26] = t45;
    const double t46 = params[4]/t1; /* I3/(R*R*I1) */
    out[28] = t46;
    const double t47 = t0*params[0]; /* R*R*m */
    const double t48 = params[4]/t47; /* I3/(R*R*m) */
    out[29] = t48;
    const double t49 = params[1]*t0; /* R*R*R */
    const double t50 = params[0]*t49; /* m*R*R*R */
    const double t51 = params[3]*t50; /* I1*m*R*R*R */
    const double t52 = params[4]/t51; /* I3/(I1*m*R*R*R) */
    out[31] = t52;
    const double t53 = params[0]/2.0; /* m/2 */
    out[33] = t53;
    const double t54 = params[4]/params[3]; /* I3/I1 */
    out[34] = t54;
    const double t55 = params[3]*t47; /* I1*R*R*m */
    const double t56 = params[6]*params[6]; /* G*G */
    const double t57 = t56/t55; /* G*G/(I1*R*R*m) */
    out[35] = t57;
    const double t58 = t56/t1; /* G*G/(R*R*I1) */
    out[36] = t58;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0] + p[9]; /* b/R = gamma3 + a3/R */
    const double t4 = p[7]*t2; /* R^2*I1*(1 - gamma3)*(1 + gamma3) */
    const double t5 = p[8]*t3; /* R^2*I3*b/R */
    const double t6 = JLT_FMA(t3, t5, t4); /* K = b/R*R^2*I3*b/R + R^2*I1*(1 - gamma3)*(1 + gamma3) */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t8 = JLT_FMA(p[12], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(1 + gamma3) + 1 */
    const double t9 = t6*t7; /* K*s */
    const double t10 = p[13] + t6; /* Theta/m = I1*I3/m + K */
    const double t11 = t8*t9; /* D/I1*K*s */
    const double t12 = t10*t11; /* Theta/m*D/I1*K*s */
    const double t13 = 1.0/t12; /* 1/(Theta/m*D/I1*K*s) */
    const double t14 = t10*t13; /* 1/(s*K*(D/I1)) = Theta/m*1/(Theta/m*D/I1*K*s) */
    const double t15 = t11*t13; /* 1/(Theta/m) = D/I1*K*s*1/(Theta/m*D/I1*K*s) */
    const double t16 = t8*t14; /* 1/(s*K) = D/I1*1/(s*K*(D/I1)) */
    const double t17 = t9*t14; /* K*s*1/(s*K*(D/I1)) */
    const double t18 = t6*t16; /* K*1/(s*K) */
    const double t19 = t7*t16; /* 1/K = s*1/(s*K) */
    const double t20 = p[10]*t7; /* R*G*s */
    const double t21 = x[3]*p[11]; /* v_tau*R*I3 */
    const double t22 = JLT_FMA(t3, t21, t20); /* b/R*v_tau*R*I3 + R*G*s */
    const double t23 = t19*t22; /* 1/K*(b/R*v_tau*R*I3 + R*G*s) */
    const double t24 = t18*t23; /* K*1/(s*K)*1/K*(b/R*v_tau*R*I3 + R*G*s) */
    const double t25 = x[3]*t24; /* v_tau*K*1/(s*K)*1/K*(b/R*v_tau*R*I3 + R*G*s) */
    out[1] = t25;
    const double t26 = x[2]*t7; /* omega_tau*s */
    out[0] = t26;
    const double t27 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t28 = t26*t27; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t29 = JLT_FNMA(t23, t24, t28); /* omega_tau*s*omega_tau*m*a3^2/I1 - 1/K*(b/R*v_tau*R*I3 + R*G*s)*K*1/(s*K)*1/K*(b/R*v_tau*R*I3 + R*G*s) */
    const double t30 = x[0]*t29; /* gamma3*t29 */
    const double t31 = JLT_FNMA(p[14], t7, t30); /* gamma3*t29 - m*g*a3/I1*s */
    const double t32 = x[3]*t7; /* v_tau*s */
    const double t33 = JLT_FNMA(p[15], t3, t32); /* v_tau*s - G/I1*b/R */
    const double t34 = t19*t33; /* 1/K*(v_tau*s - G/I1*b/R) */
    const double t35 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t36 = JLT_FMA(x[2], t35, x[1]); /* V = omega_tau*e + v_nu */
    const double t37 = p[13]*t36; /* I1*I3/m*V */
    const double t38 = JLT_FNMA(t15, t37, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t39 = t24*t38; /* K*1/(s*K)*1/K*(b/R*v_tau*R*I3 + R*G*s)*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t40 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t41 = x[2]*p[16]; /* omega_tau*R*I1*I3/m */
    const double t42 = t40*t41; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t43 = t15*t42; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t44 = JLT_FMA(t34, t43, t39); /* 1/K*(v_tau*s - G/I1*b/R)*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m + t39 */
    const double t45 = -t44; /* -t44 */
    out[3] = t45;
    const double t46 = p[11]*t34; /* R*I3*1/K*(v_tau*s - G/I1*b/R) */
    const double t47 = JLT_FNMA(t23, t46, t31); /* gamma3*t29 - m*g*a3/I1*s - 1/K*(b/R*v_tau*R*I3 + R*G*s)*R*I3*1/K*(v_tau*s - G/I1*b/R) */
    const double t48 = t17*t47; /* K*s*1/(s*K*(D/I1))*t47 */
    out[2] = t48;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[9]; /* b/R = gamma3 + a3/R */
    const double t4 = p[7]*t2; /* R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t5 = p[8]*t3; /* R^2*I3*b/R */
    const double t6 = JLT_FMA(t3, t5, t4); /* K = b/R*R^2*I3*b/R + R^2*I1*(1 - gamma3)*(gamma3 + 1) */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t7;
    const double t8 = JLT_FMA(p[12], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(gamma3 + 1) + 1 */
    const double t9 = t6*t7; /* K*s */
    const double t10 = p[13] + t6; /* Theta/m = I1*I3/m + K */
    const double t11 = t8*t9; /* D/I1*K*s */
    const double t12 = t10*t11; /* Theta/m*D/I1*K*s */
    const double t13 = 1.0/t12; /* 1/(Theta/m*D/I1*K*s) */
    const double t14 = t10*t13; /* 1/(s*K*(D/I1)) = Theta/m*1/(Theta/m*D/I1*K*s) */
    const double t15 = t11*t13; /* 1/(Theta/m) = D/I1*K*s*1/(Theta/m*D/I1*K*s) */
    const double t16 = t9*t14; /* 1/(D/I1) = K*s*1/(s*K*(D/I1)) */
    const double t17 = t8*t14; /* 1/(s*K) = D/I1*1/(s*K*(D/I1)) */
    const double t18 = t6*t17; /* 1/s = K*1/(s*K) */
    const double t19 = p[11]*t3; /* R*I3*b/R */
    const double t20 = x[3]*t19; /* v_tau*R*I3*b/R */
    const double t21 = x[0]*t16; /* gamma3*1/(D/I1) */
    const double t22 = x[3]*t7; /* v_tau*s */
    const double t23 = JLT_FNMA(p[15], t3, t22); /* v_tau*s - G/I1*b/R */
    const double t24 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t25 = p[16]*t24; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t26 = JLT_FMA(p[10], t7, t20); /* R*G*s + v_tau*R*I3*b/R */
    const double t27 = t7*t17; /* 1/K = s*1/(s*K) */
    const double t28 = t23*t27; /* (v_tau*s - G/I1*b/R)*1/K */
    const double t29 = t7*t21; /* s*gamma3*1/(D/I1) */
    const double t30 = x[0]*t18; /* gamma3*1/s */
    const double t31 = x[0]*p[19]; /* gamma3*2*R^2*I1 */
    const double t32 = JLT_FMS(p[20], t3, t31); /* d(K)/d(gamma3) = 2*R^2*I3*b/R - gamma3*2*R^2*I1 */
    const double t33 = t26*t27; /* (R*G*s + v_tau*R*I3*b/R)*1/K */
    const double t34 = t18*t26; /* 1/s*(R*G*s + v_tau*R*I3*b/R) */
    const double t35 = p[22]*t29; /* 2*m^2*g*a3^3/I1^2*s*gamma3*1/(D/I1) */
    const double t36 = p[21]*t29; /* 2*m*a3^2/I1*s*gamma3*1/(D/I1) */
    const double t37 = JLT_FNMA(p[14], t30, t35); /* 2*m^2*g*a3^3/I1^2*s*gamma3*1/(D/I1) - m*g*a3/I1*gamma3*1/s */
    const double t38 = x[2]*t36; /* omega_tau*2*m*a3^2/I1*s*gamma3*1/(D/I1) */
    out[10] = t38;
    const double t39 = t30 - t36; /* gamma3*1/s - 2*m*a3^2/I1*s*gamma3*1/(D/I1) */
    const double t40 = JLT_FMS(x[0], t39, t7); /* gamma3*(gamma3*1/s - 2*m*a3^2/I1*s*gamma3*1/(D/I1)) - s */
    const double t41 = t15*t25; /* 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t42 = JLT_FMA(t25, t27, t41); /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*1/K + 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t43 = JLT_FNMA(t32, t42, p[24]); /* R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t42 */
    const double t44 = t28*t43; /* (v_tau*s - G/I1*b/R)*1/K*(R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t42) */
    const double t45 = p[10]*t30; /* R*G*gamma3*1/s */
    const double t46 = JLT_FNMA(x[3], p[11], t45); /* R*G*gamma3*1/s - v_tau*R*I3 */
    const double t47 = t18*t33; /* 1/s*(R*G*s + v_tau*R*I3*b/R)*1/K */
    const double t48 = JLT_FMA(t17, t20, t47); /* 1/(s*K)*v_tau*R*I3*b/R + 1/s*(R*G*s + v_tau*R*I3*b/R)*1/K */
    out[7] = t48;
    const double t49 = t18*t47; /* 1/s*1/s*(R*G*s + v_tau*R*I3*b/R)*1/K */
    const double t50 = JLT_FNMA(p[25], t47, t44); /* t44 - I1*I3*a3/m*1/s*(R*G*s + v_tau*R*I3*b/R)*1/K */
    const double t51 = x[2]*t50; /* omega_tau*(t44 - I1*I3*a3/m*1/s*(R*G*s + v_tau*R*I3*b/R)*1/K) */
    const double t52 = t21*t33; /* gamma3*1/(D/I1)*(R*G*s + v_tau*R*I3*b/R)*1/K */
    const double t53 = 2.0*t21; /* 2*gamma3*1/(D/I1) */
    const double t54 = t47*t53; /* 1/s*(R*G*s + v_tau*R*I3*b/R)*1/K*2*gamma3*1/(D/I1) */
    const double t55 = t3*t54; /* b/R*1/s*(R*G*s + v_tau*R*I3*b/R)*1/K*2*gamma3*1/(D/I1) */
    const double t56 = p[23]*t28; /* 2*m*R*I3*a3^2/I1*(v_tau*s - G/I1*b/R)*1/K */
    const double t57 = JLT_FMA(t52, t56, t37); /* gamma3*1/(D/I1)*(R*G*s + v_tau*R*I3*b/R)*1/K*2*m*R*I3*a3^2/I1*(v_tau*s - G/I1*b/R)*1/K + 2*m^2*g*a3^3/I1^2*s*gamma3*1/(D/I1) - m*g*a3/I1*gamma3*1/s */
    const double t58 = JLT_FMA(t47, t49, t57); /* 1/s*(R*G*s + v_tau*R*I3*b/R)*1/K*1/s*1/s*(R*G*s + v_tau*R*I3*b/R)*1/K + t57 */
    const double t59 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t60 = t32*t33; /* d(K)/d(gamma3)*(R*G*s + v_tau*R*I3*b/R)*1/K */
    const double t61 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t62 = x[2]*t61; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t63 = JLT_FMA(t40, t62, t58); /* (gamma3*(gamma3*1/s - 2*m*a3^2/I1*s*gamma3*1/(D/I1)) - s)*omega_tau*omega_tau*m*a3^2/I1 + t58 */
    const double t64 = JLT_FMA(x[3], t30, p[15]); /* v_tau*gamma3*1/s + G/I1 */
    const double t65 = JLT_FMA(x[2], t59, x[1]); /* V = omega_tau*e + v_nu */
    const double t66 = t32*t65; /* d(K)/d(gamma3)*V */
    const double t67 = p[13]*t15; /* I1*I3/m*1/(Theta/m) */
    const double t68 = JLT_FNMA(t65, t67, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t69 = t17*t68; /* 1/(s*K)*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t70 = t47*t67; /* 1/s*(R*G*s + v_tau*R*I3*b/R)*1/K*I1*I3/m*1/(Theta/m) */
    const double t71 = JLT_FMA(t66, t70, t51); /* d(K)/d(gamma3)*V*1/s*(R*G*s + v_tau*R*I3*b/R)*1/K*I1*I3/m*1/(Theta/m) + t51 */
    const double t72 = t70 - t47; /* 1/s*(R*G*s + v_tau*R*I3*b/R)*1/K*I1*I3/m*1/(Theta/m) - 1/s*(R*G*s + v_tau*R*I3*b/R)*1/K */
    out[13] = t72;
    const double t73 = t59*t70; /* e*1/s*(R*G*s + v_tau*R*I3*b/R)*1/K*I1*I3/m*1/(Theta/m) */
    const double t74 = JLT_FNMA(t28, t41, t73); /* e*1/s*(R*G*s + v_tau*R*I3*b/R)*1/K*I1*I3/m*1/(Theta/m) - (v_tau*s - G/I1*b/R)*1/K*1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    out[14] = t74;
    const double t75 = x[2]*t41; /* omega_tau*1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t76 = t27*t75; /* 1/K*omega_tau*1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t77 = x[3]*t17; /* v_tau*1/(s*K) */
    const double t78 = t46 + t60; /* R*G*gamma3*1/s - v_tau*R*I3 + d(K)/d(gamma3)*(R*G*s + v_tau*R*I3*b/R)*1/K */
    const double t79 = JLT_FMA(2.0, t60, t46); /* 2*d(K)/d(gamma3)*(R*G*s + v_tau*R*I3*b/R)*1/K + R*G*gamma3*1/s - v_tau*R*I3 */
    const double t80 = JLT_FMS(t30, t34, t78); /* gamma3*1/s*1/s*(R*G*s + v_tau*R*I3*b/R) - t78 */
    const double t81 = t77*t80; /* v_tau*1/(s*K)*(gamma3*1/s*1/s*(R*G*s + v_tau*R*I3*b/R) - t78) */
    out[4] = t81;
    const double t82 = t27*t78; /* 1/K*t78 */
    const double t83 = JLT_FNMA(p[12], t52, t82); /* 1/K*t78 - m*a3^2/I1*gamma3*1/(D/I1)*(R*G*s + v_tau*R*I3*b/R)*1/K */
    const double t84 = p[11]*t27; /* R*I3*1/K */
    const double t85 = t69*t80; /* 1/(s*K)*(v_nu - V*I1*I3/m*1/(Theta/m))*(gamma3*1/s*1/s*(R*G*s + v_tau*R*I3*b/R) - t78) */
    const double t86 = t19*t69; /* R*I3*b/R*1/(s*K)*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t87 = x[2]*t30; /* omega_tau*gamma3*1/s */
    const double t88 = -t87; /* -omega_tau*gamma3*1/s */
    out[0] = t88;
    const double t89 = JLT_FMS(t64, t76, t85); /* (v_tau*gamma3*1/s + G/I1)*t76 - t85 */
    const double t90 = JLT_FNMA(t15, t71, t89); /* (v_tau*gamma3*1/s + G/I1)*t76 - t85 - 1/(Theta/m)*t71 */
    out[12] = t90;
    const double t91 = JLT_FMA(t7, t76, t86); /* s*t76 + R*I3*b/R*1/(s*K)*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t92 = -t91; /* -(s*t76 + R*I3*b/R*1/(s*K)*(v_nu - V*I1*I3/m*1/(Theta/m))) */
    out[15] = t92;
    const double t93 = t33*t64; /* (R*G*s + v_tau*R*I3*b/R)*1/K*(v_tau*gamma3*1/s + G/I1) */
    const double t94 = t7*t33; /* s*(R*G*s + v_tau*R*I3*b/R)*1/K */
    const double t95 = JLT_FMA(t28, t79, t93); /* (v_tau*s - G/I1*b/R)*1/K*t79 + (R*G*s + v_tau*R*I3*b/R)*1/K*(v_tau*gamma3*1/s + G/I1) */
    const double t96 = JLT_FMA(t19, t28, t94); /* R*I3*b/R*(v_tau*s - G/I1*b/R)*1/K + s*(R*G*s + v_tau*R*I3*b/R)*1/K */
    const double t97 = JLT_FNMA(t84, t95, t63); /* t63 - R*I3*1/K*t95 */
    const double t98 = JLT_FMA(t16, t96, t55); /* 1/(D/I1)*t96 + b/R*1/s*(R*G*s + v_tau*R*I3*b/R)*1/K*2*gamma3*1/(D/I1) */
    const double t99 = t16*t97; /* 1/(D/I1)*(t63 - R*I3*1/K*t95) */
    const double t100 = JLT_FMS(t54, t83, t99); /* 1/s*(R*G*s + v_tau*R*I3*b/R)*1/K*2*gamma3*1/(D/I1)*t83 - 1/(D/I1)*(t63 - R*I3*1/K*t95) */
    out[8] = t100;
    const double t101 = t84*t98; /* R*I3*1/K*t98 */
    const double t102 = -t101; /* -R*I3*1/K*t98 */
    out[11] = t102;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0] + p[9]; /* b/R = gamma3 + a3/R */
    const double t4 = p[7]*t2; /* R^2*I1*(1 - gamma3)*(1 + gamma3) */
    const double t5 = p[8]*t3; /* R^2*I3*b/R */
    const double t6 = JLT_FMA(t3, t5, t4); /* K = b/R*R^2*I3*b/R + R^2*I1*(1 - gamma3)*(1 + gamma3) */
    const double t7 = p[13] + t6; /* Theta/m = I1*I3/m + K */
    const double t8 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[6] = t8;
    const double t9 = JLT_FMA(p[12], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(1 + gamma3) + 1 */
    const double t10 = t6*t7; /* K*Theta/m */
    const double t11 = t8*t10; /* s*K*Theta/m */
    const double t12 = t9*t11; /* D/I1*s*K*Theta/m */
    const double t13 = 1.0/t12; /* 1/(D/I1*s*K*Theta/m) */
    const double t14 = t9*t13; /* 1/(s*K*(Theta/m)) = D/I1*1/(D/I1*s*K*Theta/m) */
    const double t15 = t11*t13; /* 1/(D/I1) = s*K*Theta/m*1/(D/I1*s*K*Theta/m) */
    const double t16 = t7*t14; /* 1/(s*K) = Theta/m*1/(s*K*(Theta/m)) */
    const double t17 = t8*t14; /* 1/(K*(Theta/m)) = s*1/(s*K*(Theta/m)) */
    const double t18 = p[10]*t8; /* R*G*s */
    const double t19 = x[3]*p[11]; /* v_tau*R*I3 */
    const double t20 = JLT_FMA(t3, t19, t18); /* b/R*v_tau*R*I3 + R*G*s */
    const double t21 = t8*t16; /* 1/K = s*1/(s*K) */
    const double t22 = t20*t21; /* (b/R*v_tau*R*I3 + R*G*s)*1/K */
    const double t23 = t6*t16; /* 1/s = K*1/(s*K) */
    const double t24 = t6*t17; /* 1/(Theta/m) = K*1/(K*(Theta/m)) */
    const double t25 = x[3]*t8; /* v_tau*s */
    const double t26 = JLT_FNMA(p[15], t3, t25); /* v_tau*s - G/I1*b/R */
    const double t27 = p[11]*t21; /* R*I3*1/K */
    const double t28 = t22*t23; /* (b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    const double t29 = x[3]*t28; /* v_tau*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    out[1] = t29;
    const double t30 = x[0]*t15; /* gamma3*1/(D/I1) */
    const double t31 = t15*t27; /* 1/(D/I1)*R*I3*1/K */
    const double t32 = t3*t27; /* b/R*R*I3*1/K */
    const double t33 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t34 = p[16]*t33; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t35 = t17*t34; /* 1/(K*(Theta/m))*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t36 = x[0]*p[19]; /* gamma3*2*R^2*I1 */
    const double t37 = JLT_FMS(p[20], t3, t36); /* d(K)/d(gamma3) = 2*R^2*I3*b/R - gamma3*2*R^2*I1 */
    const double t38 = t28*t30; /* (b/R*v_tau*R*I3 + R*G*s)*1/K*1/s*gamma3*1/(D/I1) */
    const double t39 = t26*t31; /* (v_tau*s - G/I1*b/R)*1/(D/I1)*R*I3*1/K */
    const double t40 = t22*t31; /* (b/R*v_tau*R*I3 + R*G*s)*1/K*1/(D/I1)*R*I3*1/K */
    const double t41 = t38 + t39; /* (b/R*v_tau*R*I3 + R*G*s)*1/K*1/s*gamma3*1/(D/I1) + (v_tau*s - G/I1*b/R)*1/(D/I1)*R*I3*1/K */
    const double t42 = t22*t41; /* (b/R*v_tau*R*I3 + R*G*s)*1/K*t41 */
    const double t43 = JLT_FMA(2.0, t38, t39); /* 2*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s*gamma3*1/(D/I1) + (v_tau*s - G/I1*b/R)*1/(D/I1)*R*I3*1/K */
    const double t44 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t45 = t21*t37; /* 1/K*d(K)/d(gamma3) */
    const double t46 = t24*t28; /* 1/(Theta/m)*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    const double t47 = x[2]*t8; /* omega_tau*s */
    out[0] = t47;
    const double t48 = t8*t15; /* s*1/(D/I1) */
    const double t49 = t26*t35; /* (v_tau*s - G/I1*b/R)*1/(K*(Theta/m))*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t50 = p[24]*t26; /* R^2*I1*I3*(I1 - I3)/m*(v_tau*s - G/I1*b/R) */
    const double t51 = JLT_FMA(x[2], t44, x[1]); /* V = omega_tau*e + v_nu */
    const double t52 = t24*t51; /* 1/(Theta/m)*V */
    const double t53 = t21 + t24; /* 1/K + 1/(Theta/m) */
    const double t54 = x[0]*t23; /* gamma3*1/s */
    const double t55 = JLT_FMS(p[10], t54, t19); /* R*G*gamma3*1/s - v_tau*R*I3 */
    const double t56 = t21*t55; /* 1/K*(R*G*gamma3*1/s - v_tau*R*I3) */
    const double t57 = p[14]*t23; /* m*g*a3/I1*1/s */
    const double t58 = JLT_FNMA(p[22], t48, t57); /* m*g*a3/I1*1/s - 2*m^2*g*a3^3/I1^2*s*1/(D/I1) */
    const double t59 = JLT_FMA(p[14], t48, t42); /* m*g*a3/I1*s*1/(D/I1) + (b/R*v_tau*R*I3 + R*G*s)*1/K*t41 */
    const double t60 = 2.0*t45; /* 2*1/K*d(K)/d(gamma3) */
    const double t61 = t42*t60; /* (b/R*v_tau*R*I3 + R*G*s)*1/K*t41*2*1/K*d(K)/d(gamma3) */
    const double t62 = p[25]*t46; /* I1*I3*a3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    const double t63 = JLT_FNMA(t17, t50, t62); /* I1*I3*a3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s - 1/(K*(Theta/m))*R^2*I1*I3*(I1 - I3)/m*(v_tau*s - G/I1*b/R) */
    const double t64 = p[13]*t46; /* I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    const double t65 = JLT_FMS(t44, t64, t49); /* e*I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s - t49 */
    out[18] = t65;
    const double t66 = x[2]*t49; /* omega_tau*t49 */
    const double t67 = t53*t66; /* (1/K + 1/(Theta/m))*omega_tau*t49 */
    const double t68 = JLT_FNMA(t52, t64, t67); /* (1/K + 1/(Theta/m))*omega_tau*t49 - 1/(Theta/m)*V*I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    const double t69 = t64 - t28; /* I1*I3/m*1/(Theta/m)*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s - (b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    out[17] = t69;
    const double t70 = JLT_FNMA(p[13], t52, x[1]); /* v_nu - I1*I3/m*1/(Theta/m)*V */
    const double t71 = JLT_FMA(t28, t70, t66); /* (b/R*v_tau*R*I3 + R*G*s)*1/K*1/s*(v_nu - I1*I3/m*1/(Theta/m)*V) + omega_tau*t49 */
    const double t72 = -t71; /* -t71 */
    out[3] = t72;
    const double t73 = t30*t47; /* gamma3*1/(D/I1)*omega_tau*s */
    const double t74 = p[21]*t73; /* 2*m*a3^2/I1*gamma3*1/(D/I1)*omega_tau*s */
    out[14] = t74;
    const double t75 = t23*t28; /* 1/s*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    const double t76 = x[2]*p[26]; /* omega_tau*2*m^2*a3^4/I1^2 */
    const double t77 = JLT_FMA(t73, t76, t58); /* gamma3*1/(D/I1)*omega_tau*s*omega_tau*2*m^2*a3^4/I1^2 + m*g*a3/I1*1/s - 2*m^2*g*a3^3/I1^2*s*1/(D/I1) */
    const double t78 = JLT_FMA(x[3], t54, p[15]); /* v_tau*gamma3*1/s + G/I1 */
    const double t79 = JLT_FMA(t40, t78, t61); /* (b/R*v_tau*R*I3 + R*G*s)*1/K*1/(D/I1)*R*I3*1/K*(v_tau*gamma3*1/s + G/I1) + (b/R*v_tau*R*I3 + R*G*s)*1/K*t41*2*1/K*d(K)/d(gamma3) */
    const double t80 = JLT_FMA(t35, t78, t63); /* 1/(K*(Theta/m))*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*(v_tau*gamma3*1/s + G/I1) + t63 */
    const double t81 = JLT_FMA(t43, t56, t79); /* t43*1/K*(R*G*gamma3*1/s - v_tau*R*I3) + t79 */
    const double t82 = t32*t43; /* b/R*R*I3*1/K*t43 */
    const double t83 = JLT_FMA(t8, t40, t82); /* s*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/(D/I1)*R*I3*1/K + b/R*R*I3*1/K*t43 */
    const double t84 = -t83; /* -t83 */
    out[15] = t84;
    const double t85 = t23*t32; /* 1/s*b/R*R*I3*1/K */
    const double t86 = x[2]*t80; /* omega_tau*t80 */
    const double t87 = JLT_FMA(t37, t68, t86); /* d(K)/d(gamma3)*t68 + omega_tau*t80 */
    const double t88 = JLT_FMA(x[3], t85, t28); /* v_tau*1/s*b/R*R*I3*1/K + (b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    out[11] = t88;
    const double t89 = t70*t85; /* (v_nu - I1*I3/m*1/(Theta/m)*V)*1/s*b/R*R*I3*1/K */
    const double t90 = JLT_FMA(t35, t47, t89); /* 1/(K*(Theta/m))*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*s + (v_nu - I1*I3/m*1/(Theta/m)*V)*1/s*b/R*R*I3*1/K */
    const double t91 = -t90; /* -t90 */
    out[19] = t91;
    const double t92 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t93 = JLT_FMS(t73, t92, t59); /* gamma3*1/(D/I1)*omega_tau*s*omega_tau*m*a3^2/I1 - (m*g*a3/I1*s*1/(D/I1) + (b/R*v_tau*R*I3 + R*G*s)*1/K*t41) */
    out[2] = t93;
    const double t94 = x[2]*t54; /* omega_tau*gamma3*1/s */
    const double t95 = t54*t75; /* gamma3*1/s*1/s*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    const double t96 = JLT_FNMA(t28, t45, t95); /* gamma3*1/s*1/s*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s - (b/R*v_tau*R*I3 + R*G*s)*1/K*1/s*1/K*d(K)/d(gamma3) */
    const double t97 = JLT_FNMA(t23, t56, t96); /* t96 - 1/s*1/K*(R*G*gamma3*1/s - v_tau*R*I3) */
    const double t98 = JLT_FNMA(t70, t97, t87); /* d(K)/d(gamma3)*t68 + omega_tau*t80 - (v_nu - I1*I3/m*1/(Theta/m)*V)*(t96 - 1/s*1/K*(R*G*gamma3*1/s - v_tau*R*I3)) */
    out[16] = t98;
    const double t99 = t28*t75; /* (b/R*v_tau*R*I3 + R*G*s)*1/K*1/s*1/s*(b/R*v_tau*R*I3 + R*G*s)*1/K*1/s */
    const double t100 = JLT_FNMA(t47, t92, t99); /* t99 - omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t101 = JLT_FNMA(t15, t100, t81); /* t43*1/K*(R*G*gamma3*1/s - v_tau*R*I3) + t79 - 1/(D/I1)*(t99 - omega_tau*s*omega_tau*m*a3^2/I1) */
    const double t102 = JLT_FNMA(t92, t94, t77); /* t77 - omega_tau*m*a3^2/I1*omega_tau*gamma3*1/s */
    const double t103 = JLT_FNMA(p[21], t42, t102); /* t77 - omega_tau*m*a3^2/I1*omega_tau*gamma3*1/s - 2*m*a3^2/I1*(b/R*v_tau*R*I3 + R*G*s)*1/K*t41 */
    const double t104 = JLT_FMA(t30, t103, t101); /* gamma3*1/(D/I1)*t103 + t101 */
    out[12] = t104;
    const double t105 = -t94; /* -omega_tau*gamma3*1/s */
    out[4] = t105;
    const double t106 = x[3]*t97; /* v_tau*(t96 - 1/s*1/K*(R*G*gamma3*1/s - v_tau*R*I3)) */
    out[8] = t106;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t4 = t3*p[28]; /* b*I3/(R^2*I1) */
    const double t5 = JLT_FMA(t3, t4, t2); /* K/(R^2*I1) = b*b*I3/(R^2*I1) + (1 - gamma3)*(gamma3 + 1) */
    const double t6 = t5 + p[29]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = JLT_FMA(t2, p[30], p[3]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t9 = t7*t8; /* s*D */
    const double t10 = t5*t9; /* K/(R^2*I1)*s*D */
    const double t11 = t6*t10; /* Theta/(m*R^2*I1)*K/(R^2*I1)*s*D */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*K/(R^2*I1)*s*D) */
    const double t13 = t6*t12; /* 1/(s*D*(K/(R^2*I1))) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*s*D) */
    const double t14 = t5*t13; /* 1/(s*D) = K/(R^2*I1)*1/(s*D*(K/(R^2*I1))) */
    const double t15 = p[27]*t2; /* 2*m*a3^2*(1 - gamma3)*(gamma3 + 1) */
    const double t16 = t8*t14; /* 1/s = D*1/(s*D) */
    const double t17 = JLT_FMS(t14, t15, t16); /* 1/(s*D)*2*m*a3^2*(1 - gamma3)*(gamma3 + 1) - 1/s */
    const double t18 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t19 = t17*t18; /* (1/(s*D)*2*m*a3^2*(1 - gamma3)*(gamma3 + 1) - 1/s)*gamma3*omega_tau */
    const double t20 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t21 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = K/(R^2*I1)*s*D*1/(Theta/(m*R^2*I1)*K/(R^2*I1)*s*D) */
    const double t22 = x[2]*p[31]; /* omega_tau*I3/(m*R^3*I1) */
    const double t23 = t20*t22; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3/(m*R^3*I1) */
    const double t24 = t7*t23; /* s*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3/(m*R^3*I1) */
    const double t25 = t21*t24; /* 1/(Theta/(m*R^2*I1))*s*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3/(m*R^3*I1) */
    const double t26 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t27 = JLT_FMA(x[2], t26, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = p[29]*t27; /* I3/(m*R^2)*V */
    const double t29 = JLT_FNMA(t21, t28, x[1]); /* v_nu - 1/(Theta/(m*R^2*I1))*I3/(m*R^2)*V */
    const double t30 = t4*t29; /* b*I3/(R^2*I1)*(v_nu - 1/(Theta/(m*R^2*I1))*I3/(m*R^2)*V) */
    const double t31 = JLT_FMA(t16, t30, t25); /* 1/s*b*I3/(R^2*I1)*(v_nu - 1/(Theta/(m*R^2*I1))*I3/(m*R^2)*V) + t25 */
    const double t32 = t9*t13; /* s*D*1/(s*D*(K/(R^2*I1))) */
    const double t33 = JLT_FNMA(t31, t32, t19); /* t19 - t31*s*D*1/(s*D*(K/(R^2*I1))) */
    out[0] = t33;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[9]; /* b/R = gamma3 + a3/R */
    const double t4 = p[34]*t3; /* I3/I1*b/R */
    const double t5 = JLT_FMA(t3, t4, t2); /* K/(R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(gamma3 + 1) */
    const double t6 = JLT_FMA(p[30], t2, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t7 = p[29] + t5; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t8 = x[3]*x[3]; /* v_tau*v_tau */
    const double t9 = JLT_FMA(t7, t8, p[35]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t10 = t9/t5; /* (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t11 = JLT_FMA(x[1], x[1], t10); /* v_nu*v_nu + (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = p[32]*x[0]; /* m*g*a3*gamma3 */
    const double t15 = JLT_FMA(t6, t13, t14); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(p[33], t11, t15); /* 1/2*m*t11 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    out[0] = t16;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = x[0] + p[9]; /* b/R = gamma3 + a3/R */
    const double t5 = p[34]*t4; /* I3/I1*b/R */
    const double t6 = JLT_FMA(t4, t5, t3); /* K/(R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(gamma3 + 1) */
    const double t7 = t5 - x[0]; /* d(K)/d(gamma3)/(2*R^2*I1) = I3/I1*b/R - gamma3 */
    const double t8 = JLT_FMA(p[30], t3, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t9 = x[2]*t8; /* omega_tau*D */
    out[2] = t9;
    const double t10 = p[29] + t6; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t11 = 1.0/t6; /* 1/(K/(R^2*I1)) */
    const double t12 = t7*t11; /* d(K)/d(gamma3)/(2*R^2*I1)*1/(K/(R^2*I1)) */
    const double t13 = x[3]*p[0]; /* v_tau*m */
    const double t14 = t10*t13; /* Theta/(m*R^2*I1)*v_tau*m */
    const double t15 = t11*t14; /* 1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m */
    out[3] = t15;
    const double t16 = t15 - t13; /* 1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m - v_tau*m */
    const double t17 = x[3]*t16; /* v_tau*(1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m - v_tau*m) */
    const double t18 = JLT_FMA(p[36], t11, t17); /* G^2/(R^2*I1)*1/(K/(R^2*I1)) + v_tau*(1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m - v_tau*m) */
    const double t19 = p[30]*x[0]; /* m*a3^2*gamma3 */
    const double t20 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t21 = JLT_FNMA(t19, t20, p[32]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t22 = JLT_FNMA(t12, t18, t21); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau - d(K)/d(gamma3)/(2*R^2*I1)*1/(K/(R^2*I1))*t18 */
    out[0] = t22;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
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
        t19[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t20[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t21[k] = jlt_jet_product(t19, t20, k);
        t22[k] = x0[k] + (k == 0 ? p[9] : 0);
        t23[k] = p[7]*t21[k];
        t24[k] = p[8]*t22[k];
        t25[k] = jlt_jet_product(t22, t24, k) + t23[k];
        t26[k] = jlt_jet_root(t21[k], t26, k);
        t27[k] = p[12]*t21[k] + (k == 0 ? 1.0 : 0);
        t28[k] = jlt_jet_product(t25, t26, k);
        t29[k] = (k == 0 ? p[13] : 0) + t25[k];
        t30[k] = jlt_jet_product(t27, t28, k);
        t31[k] = jlt_jet_product(t29, t30, k);
        t32[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t31, t32, k);
        t33[k] = jlt_jet_product(t29, t32, k);
        t34[k] = jlt_jet_product(t30, t32, k);
        t35[k] = jlt_jet_product(t27, t33, k);
        t36[k] = jlt_jet_product(t28, t33, k);
        t37[k] = jlt_jet_product(t25, t35, k);
        t38[k] = jlt_jet_product(t26, t35, k);
        t39[k] = p[10]*t26[k];
        t40[k] = x3[k]*p[11];
        t41[k] = jlt_jet_product(t22, t40, k) + t39[k];
        t42[k] = jlt_jet_product(t38, t41, k);
        t43[k] = jlt_jet_product(t37, t42, k);
        t44[k] = jlt_jet_product(x3, t43, k);
        t45[k] = jlt_jet_product(x2, t26, k);
        t46[k] = x2[k]*p[12];
        t47[k] = jlt_jet_product(t45, t46, k);
        t48[k] = t47[k] - jlt_jet_product(t42, t43, k);
        t49[k] = jlt_jet_product(x0, t48, k);
        t50[k] = t49[k] - p[14]*t26[k];
        t51[k] = jlt_jet_product(x3, t26, k);
        t52[k] = t51[k] - p[15]*t22[k];
        t53[k] = jlt_jet_product(t38, t52, k);
        t54[k] = x0[k]*p[5] + (k == 0 ? p[1] : 0);
        t55[k] = jlt_jet_product(x2, t54, k) + x1[k];
        t56[k] = p[13]*t55[k];
        t57[k] = x1[k] - jlt_jet_product(t34, t56, k);
        t58[k] = jlt_jet_product(t43, t57, k);
        t59[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t60[k] = x2[k]*p[16];
        t61[k] = jlt_jet_product(t59, t60, k);
        t62[k] = jlt_jet_product(t34, t61, k);
        t63[k] = jlt_jet_product(t53, t62, k) + t58[k];
        t64[k] = -t63[k];
        t65[k] = p[11]*t53[k];
        t66[k] = t50[k] - jlt_jet_product(t42, t65, k);
        t67[k] = jlt_jet_product(t36, t66, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t45[k]/(k + 1);
        next[1] = x1[k + 1] = t44[k]/(k + 1);
        next[2] = x2[k + 1] = t67[k]/(k + 1);
        next[3] = x3[k + 1] = t64[k]/(k + 1);
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
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    const double t0 = params[1]*params[6]; /* R*G */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = t0*t4; /* R*G*s */
    const double t6 = x[0]*params[1]; /* gamma3*R */
    const double t7 = params[5] + t6; /* b = a3 + gamma3*R */
    const double t8 = params[4]*t7; /* I3*b */
    const double t9 = t5/t8; /* R*G*s/(I3*b) */
    const double t10 = -t9; /* v_tau = -R*G*s/(I3*b) */
    out[3] = t10;
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[4]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I3*gamma3*v_nu */
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t6 = t4*t5; /* (1 - gamma3)*(1 + gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
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
    out[2] = 0.0;
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = params[5]*t0; /* a3*m*g */
    const double t2 = params[1]*params[6]; /* R*G */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = t3*t4; /* (1 - gamma3)*(1 + gamma3) */
    const double t6 = sqrt(t5); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
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
    out[0] = t44;
    const double t45 = params[0]*x[1]; /* m*v_nu */
    out[1] = t45;
    const double t46 = t11*t23; /* R*G*s/(I3*b)*Theta */
    const double t47 = t46/t19; /* R*G*s/(I3*b)*Theta/K */
    const double t48 = -t47; /* -R*G*s/(I3*b)*Theta/K */
    out[3] = t48;
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
    out[4] = t77;
    const double t78 = params[0]*2.0; /* m*2 */
    const double t79 = params[3]*params[3]; /* I1*I1 */
    const double t80 = t78*t79; /* m*2*I1*I1 */
    const double t81 = x[1]*t80; /* v_nu*m*2*I1*I1 */
    out[5] = t81;
    const double t82 = params[1]*t78; /* R*m*2 */
    const double t83 = t79*t82; /* I1*I1*R*m*2 */
    const double t84 = x[1]*t83; /* v_nu*I1*I1*R*m*2 */
    out[6] = t84;
    const double t85 = params[1]*2.0; /* R*2 */
    const double t86 = params[3]*t85; /* I1*R*2 */
    const double t87 = t6*t86; /* s*I1*R*2 */
    const double t88 = t23*t87; /* Theta*s*I1*R*2 */
    const double t89 = t55*t88; /* (-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2 */
    const double t90 = t58*t89; /* (I1 - I3)*(-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2 */
    const double t91 = t90/t20; /* (I1 - I3)*(-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2/(K*K) */
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
    .rhs = { rhs, 4, { 5, 30, 12, 1, 1, 0, 18, 10 }, { 21, 80, 0, 8, 1, 0, 12, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 10, 58, 33, 1, 1, 0, 20, 25 }, { 91, 425, 0, 50, 1, 0, 21, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 11, 59, 35, 1, 1, 0, 22, 27 }, { 105, 489, 0, 58, 1, 0, 21, 14 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 19, 10, 1, 1, 0, 13, 10 }, { 13, 41, 0, 5, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 4, 6, 6, 1, 0, 0, 8, 5 }, { 9, 28, 0, 2, 1, 0, 13, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 6, 11, 5, 1, 0, 0, 10, 5 }, { 10, 44, 0, 4, 1, 0, 15, 10 },
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
