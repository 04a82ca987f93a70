/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23   12    1    1    0     16    9   (83)
 *  jacobian            9   51   28    1    1    0     18   21   (327)
 *  rhs_jacobian        12   55   30    1    1    0     17   25   (379)
 *  divergence          2   13   10    1    1    0     14    8   (57)
 *  integral_values     3   11    8    1    1    0      8    8   (43)
 *  integral_gradients  3   17   12    1    1    0     11   10   (72)
 *  eliminated          3    3    1    1    1    0      4    4   (11)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = 1.0/t0; /* 1/(R*I1) */
    out[7] = t1;
    const double t2 = params[3]*params[3]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    out[31] = t3;
    const double t4 = t3/params[4]; /* m*a3*a3/I1 */
    out[8] = t4;
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    out[55] = t6;
    const double t7 = params[5]/t6; /* I3/(m*R*R) */
    out[9] = t7;
    const double t8 = params[4]*t5; /* I1*R*R */
    const double t9 = params[5]/t8; /* I3/(I1*R*R) */
    out[10] = t9;
    const double t10 = params[0]*params[2]; /* m*g */
    const double t11 = params[3]*t10; /* a3*m*g */
    out[41] = t11;
    const double t12 = t11/params[4]; /* a3*m*g/I1 */
    out[11] = t12;
    const double t13 = params[5]/params[4]; /* I3/I1 */
    out[12] = t13;
    const double t14 = (-1.0)/params[1]; /* (-1)/R */
    out[13] = t14;
    const double t15 = params[3]*params[5]; /* a3*I3 */
    const double t16 = t15/params[4]; /* a3*I3/I1 */
    out[14] = t16;
    const double t17 = params[4] - params[5]; /* I1 - I3 */
    const double t18 = params[1]*t17; /* R*(I1 - I3) */
    const double t19 = t18/params[4]; /* R*(I1 - I3)/I1 */
    out[15] = t19;
    const double t20 = params[4]*params[5]; /* I1*I3 */
    out[16] = t20;
    const double t21 = params[4]*t6; /* I1*m*R*R */
    out[17] = t21;
    const double t22 = params[0]*params[5]; /* m*I3 */
    out[18] = t22;
    const double t23 = 1.0/params[4]; /* 1/I1 */
    out[19] = t23;
    const double t24 = params[5]*2.0; /* I3*2 */
    const double t25 = t24/t0; /* I3*2/(R*I1) */
    out[20] = t25;
    const double t26 = params[0]*2.0; /* m*2 */
    const double t27 = t2*t26; /* a3*a3*m*2 */
    out[43] = t27;
    const double t28 = t27/params[4]; /* a3*a3*m*2/I1 */
    out[21] = t28;
    const double t29 = params[4]*params[4]; /* I1*I1 */
    const double t30 = params[1]*t29; /* R*I1*I1 */
    const double t31 = params[5]/t30; /* I3/(R*I1*I1) */
    const double t32 = -t31; /* -I3/(R*I1*I1) */
    out[22] = t32;
    const double t33 = params[4]*2.0; /* I1*2 */
    out[23] = t33;
    const double t34 = t6*t17; /* m*R*R*(I1 - I3) */
    out[24] = t34;
    const double t35 = params[1]*params[0]; /* R*m */
    const double t36 = params[3]*t35; /* a3*R*m */
    const double t37 = params[5]*t36; /* I3*a3*R*m */
    out[25] = t37;
    const double t38 = t5*t26; /* R*R*m*2 */
    const double t39 = params[4]*t38; /* I1*R*R*m*2 */
    out[26] = t39;
    const double t40 = params[1]*t26; /* R*m*2 */
    const double t41 = params[5]*t40; /* I3*R*m*2 */
    out[27] = t41;
    const double t42 = params[0]*params[3]; /* m*a3 */
    out[28] = t42;
    const double t43 = params[4]*t35; /* I1*R*m */
    out[29] = t43;
    const double t44 = params[3]/params[1]; /* a3/R */
    out[30] = t44;
    const double t45 = params[1]*params[5]; /* R*I3 */
    out[32] = t45;
    const double t46 = t6*params[2]; /* m*R*R*g */
    const double t47 = params[3]*t46; /* a3*m*R*R*g */
    const double t48 = params[4]*t47; /* I1*a3*m*R*R*g */
    out[33] = t48;
    const double t49 = 1.0/t8; /* 1/(I1*R*R) */
    out[34] = t49;
    const double t50 = t15/t0; /* a3*I3/(R*I1) */
    out[35] = t50;
    const double t51 = t17/params[4]; /* (I1 - I3)/I1 */
    out[36] = t51;
    const double t52 = 1.0/t30; /* 1/(R*I1*I1) */
    out[37] = t52;
    const double t53 = 2.0/t0; /* 2/(R*I1) */
    out[38] = t53;
    const double t54 = t24/t29; /* I3*2/(I1*I1) */
    out[39] = t54;
    const double t55 = t45/params[4]; /* R*I3/I1 */
    out[40] = t55;
    const double t56 = t27/t8; /* a3*a3*m*2/(I1*R*R) */
    out[42] = t56;
    const double t57 = params[5]/t0; /* I3/(R*I1) */
    out[48] = t57;
    const double t58 = -t57; /* -I3/(R*I1) */
    out[44] = t58;
    const double t59 = params[3]/t8; /* a3/(I1*R*R) */
    out[45] = t59;
    const double t60 = params[3]*2.0; /* a3*2 */
    const double t61 = params[5]*t60; /* I3*a3*2 */
    const double t62 = t61/t0; /* I3*a3*2/(R*I1) */
    out[46] = t62;
    const double t63 = t17*2.0; /* (I1 - I3)*2 */
    const double t64 = t63/params[4]; /* (I1 - I3)*2/I1 */
    out[47] = t64;
    const double t65 = params[0]/2.0; /* m/2 */
    out[49] = t65;
    const double t66 = params[2]*2.0; /* g*2 */
    const double t67 = params[3]*t66; /* a3*g*2 */
    out[50] = t67;
    const double t68 = 1.0/params[0]; /* 1/m */
    out[51] = t68;
    const double t69 = 1.0/t21; /* 1/(I1*m*R*R) */
    out[52] = t69;
    const double t70 = params[5]/params[0]; /* I3/m */
    out[53] = t70;
    const double t71 = 1.0/params[1]; /* 1/R */
    out[54] = t71;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t5 = JLT_FMA(p[8], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(1 + gamma3) + 1 */
    const double t6 = p[9] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t7 = p[10]*t3; /* I3/(R^2*I1)*b */
    const double t8 = JLT_FMA(t3, t7, t6); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t9 = t4*t5; /* s*D/I1 */
    const double t10 = t8*t9; /* Theta/(m*R^2*I1)*s*D/I1 */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s*D/I1) */
    const double t12 = t8*t11; /* 1/(s*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D/I1) */
    const double t13 = t5*t12; /* 1/s = D/I1*1/(s*(D/I1)) */
    const double t14 = p[13]*t9; /* (-1/R)*s*D/I1 */
    const double t15 = t11*t14; /* 1/(Theta/(m*R^2*I1)*s*D/I1)*(-1/R)*s*D/I1 */
    const double t16 = t4*t12; /* s*1/(s*(D/I1)) */
    const double t17 = p[5]*x[3]; /* I3*omega3 */
    const double t18 = JLT_FMA(t3, t17, p[6]); /* b*I3*omega3 + G_level */
    const double t19 = p[7]*t18; /* 1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t20 = t13*t19; /* omega_n = 1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t21 = t13*t20; /* 1/s*omega_n */
    const double t22 = t20*t21; /* omega_n*1/s*omega_n */
    const double t23 = t3*t22; /* b*omega_n*1/s*omega_n */
    const double t24 = x[2]*t4; /* omega_tau*s */
    out[0] = t24;
    const double t25 = x[2]*p[8]; /* omega_tau*m*a3^2/I1 */
    const double t26 = JLT_FMS(t24, t25, t22); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*1/s*omega_n */
    const double t27 = x[0]*t26; /* gamma3*(omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*1/s*omega_n) */
    const double t28 = JLT_FNMA(p[11], t4, t27); /* t27 - m*g*a3/I1*s */
    const double t29 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t30 = JLT_FMA(x[2], t29, x[1]); /* V = omega_tau*e + v_nu */
    const double t31 = t20*t30; /* omega_n*V */
    const double t32 = x[3]*t20; /* omega3*omega_n */
    const double t33 = JLT_FMA(p[1], t32, t23); /* R*omega3*omega_n + b*omega_n*1/s*omega_n */
    out[1] = t33;
    const double t34 = JLT_FNMA(p[12], t32, t28); /* t27 - m*g*a3/I1*s - I3/I1*omega3*omega_n */
    const double t35 = t16*t34; /* s*1/(s*(D/I1))*(t27 - m*g*a3/I1*s - I3/I1*omega3*omega_n) */
    out[2] = t35;
    const double t36 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/I1 - gamma3*R*(I1 - I3)/I1 */
    const double t37 = x[3]*t36; /* omega3*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) */
    const double t38 = JLT_FMA(t24, t37, t31); /* omega_tau*s*omega3*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) + omega_n*V */
    const double t39 = t15*t38; /* 1/(Theta/(m*R^2*I1)*s*D/I1)*(-1/R)*s*D/I1*t38 */
    out[3] = t39;
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
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = JLT_FMA(p[8], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(gamma3 + 1) + 1 */
    const double t5 = p[18]*t3; /* m*I3*b */
    const double t6 = JLT_FMA(p[17], t2, p[16]); /* m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t7 = JLT_FMA(t3, t5, t6); /* Theta = b*m*I3*b + m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t8 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t8;
    const double t9 = t4*t8; /* D/I1*s */
    const double t10 = t7*t9; /* Theta*D/I1*s */
    const double t11 = 1.0/t10; /* 1/(Theta*D/I1*s) */
    const double t12 = t7*t11; /* 1/(s*(D/I1)) = Theta*1/(Theta*D/I1*s) */
    const double t13 = t9*t11; /* 1/Theta = D/I1*s*1/(Theta*D/I1*s) */
    const double t14 = t4*t12; /* 1/s = D/I1*1/(s*(D/I1)) */
    const double t15 = t8*t12; /* 1/(D/I1) = s*1/(s*(D/I1)) */
    const double t16 = p[5]*x[3]; /* I3*omega3 */
    const double t17 = JLT_FMA(t3, t16, p[6]); /* b*I3*omega3 + G_level */
    const double t18 = t14*t17; /* 1/s*(b*I3*omega3 + G_level) */
    const double t19 = x[0]*p[26]; /* gamma3*2*m*R^2*I1 */
    const double t20 = JLT_FMS(p[27], t3, t19); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t21 = t13*t20; /* 1/Theta*d(Theta)/d(gamma3) */
    const double t22 = p[7]*t18; /* 1/(R*I1)*1/s*(b*I3*omega3 + G_level) */
    const double t23 = x[3]*p[12]; /* omega3*I3/I1 */
    const double t24 = x[0]*p[21]; /* gamma3*2*m*a3^2/I1 */
    const double t25 = t15*t24; /* 1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t26 = JLT_FNMA(x[0], p[24], p[25]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t27 = x[0]*t14; /* gamma3*1/s */
    const double t28 = t14*t22; /* 1/s*1/(R*I1)*1/s*(b*I3*omega3 + G_level) */
    const double t29 = t14*t23; /* 1/s*omega3*I3/I1 */
    const double t30 = JLT_FMA(t27, t28, t29); /* d(omega_n)/d(gamma3) = gamma3*1/s*1/s*1/(R*I1)*1/s*(b*I3*omega3 + G_level) + 1/s*omega3*I3/I1 */
    const double t31 = p[24]*t8; /* m*R^2*(I1 - I3)*s */
    const double t32 = t8*t26; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t33 = JLT_FMA(t21, t32, t31); /* 1/Theta*d(Theta)/d(gamma3)*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + m*R^2*(I1 - I3)*s */
    const double t34 = JLT_FMA(t26, t27, t33); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*gamma3*1/s + t33 */
    const double t35 = x[3]*t34; /* omega3*((m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*gamma3*1/s + t33) */
    const double t36 = JLT_FNMA(p[28], t18, t35); /* t35 - m*a3*1/s*(b*I3*omega3 + G_level) */
    const double t37 = x[2]*t36; /* omega_tau*(t35 - m*a3*1/s*(b*I3*omega3 + G_level)) */
    const double t38 = JLT_FNMA(t21, t22, t30); /* d(omega_n)/d(gamma3) - 1/Theta*d(Theta)/d(gamma3)*1/(R*I1)*1/s*(b*I3*omega3 + G_level) */
    const double t39 = t22*t25; /* 1/(R*I1)*1/s*(b*I3*omega3 + G_level)*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t40 = t8*t25; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t41 = x[2]*t40; /* omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[10] = t41;
    const double t42 = t27 - t40; /* gamma3*1/s - s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t43 = JLT_FMS(x[0], t42, t8); /* gamma3*(gamma3*1/s - s*1/(D/I1)*gamma3*2*m*a3^2/I1) - s */
    const double t44 = p[11]*t42; /* m*g*a3/I1*(gamma3*1/s - s*1/(D/I1)*gamma3*2*m*a3^2/I1) */
    const double t45 = x[2]*t27; /* omega_tau*gamma3*1/s */
    const double t46 = -t45; /* -omega_tau*gamma3*1/s */
    out[0] = t46;
    const double t47 = t3*t14; /* b*1/s */
    const double t48 = JLT_FMA(t16, t47, t18); /* I3*omega3*b*1/s + 1/s*(b*I3*omega3 + G_level) */
    const double t49 = t28*t47; /* 1/s*1/(R*I1)*1/s*(b*I3*omega3 + G_level)*b*1/s */
    const double t50 = 2.0*t30; /* 2*d(omega_n)/d(gamma3) */
    const double t51 = x[2]*p[8]; /* omega_tau*m*a3^2/I1 */
    const double t52 = x[2]*t51; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t53 = JLT_FNMA(t43, t52, t44); /* m*g*a3/I1*(gamma3*1/s - s*1/(D/I1)*gamma3*2*m*a3^2/I1) - (gamma3*(gamma3*1/s - s*1/(D/I1)*gamma3*2*m*a3^2/I1) - s)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t54 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t55 = x[0]*t49; /* gamma3*1/s*1/(R*I1)*1/s*(b*I3*omega3 + G_level)*b*1/s */
    const double t56 = t39 + t50; /* t39 + 2*d(omega_n)/d(gamma3) */
    const double t57 = x[0]*t56; /* gamma3*(t39 + 2*d(omega_n)/d(gamma3)) */
    const double t58 = JLT_FMA(t14, t28, t57); /* 1/s*1/s*1/(R*I1)*1/s*(b*I3*omega3 + G_level) + gamma3*(t39 + 2*d(omega_n)/d(gamma3)) */
    const double t59 = t30 + t39; /* d(omega_n)/d(gamma3) + t39 */
    const double t60 = JLT_FNMA(t23, t59, t53); /* t53 - omega3*I3/I1*(d(omega_n)/d(gamma3) + t39) */
    const double t61 = JLT_FNMA(t28, t58, t60); /* t53 - omega3*I3/I1*(d(omega_n)/d(gamma3) + t39) - 1/s*1/(R*I1)*1/s*(b*I3*omega3 + G_level)*t58 */
    const double t62 = t15*t61; /* 1/(D/I1)*t61 */
    out[8] = t62;
    const double t63 = p[22]*t15; /* (-I3/(R*I1^2))*1/(D/I1) */
    const double t64 = JLT_FMA(x[2], t54, x[1]); /* V = omega_tau*e + v_nu */
    const double t65 = JLT_FMA(p[19], t18, t55); /* 1/I1*1/s*(b*I3*omega3 + G_level) + gamma3*1/s*1/(R*I1)*1/s*(b*I3*omega3 + G_level)*b*1/s */
    const double t66 = JLT_FMA(t3, t50, t65); /* b*2*d(omega_n)/d(gamma3) + t65 */
    const double t67 = t28*t66; /* 1/s*1/(R*I1)*1/s*(b*I3*omega3 + G_level)*(b*2*d(omega_n)/d(gamma3) + t65) */
    const double t68 = p[0]*t18; /* m*1/s*(b*I3*omega3 + G_level) */
    const double t69 = p[20]*t3; /* 2*I3/(R*I1)*b */
    const double t70 = JLT_FMA(p[23], t55, t48); /* 2*I1*gamma3*1/s*1/(R*I1)*1/s*(b*I3*omega3 + G_level)*b*1/s + I3*omega3*b*1/s + 1/s*(b*I3*omega3 + G_level) */
    const double t71 = t63*t70; /* (-I3/(R*I1^2))*1/(D/I1)*t70 */
    out[11] = t71;
    const double t72 = p[19]*t48; /* 1/I1*(I3*omega3*b*1/s + 1/s*(b*I3*omega3 + G_level)) */
    const double t73 = JLT_FMA(t49, t69, t72); /* 1/s*1/(R*I1)*1/s*(b*I3*omega3 + G_level)*b*1/s*2*I3/(R*I1)*b + 1/I1*(I3*omega3*b*1/s + 1/s*(b*I3*omega3 + G_level)) */
    out[7] = t73;
    const double t74 = x[3]*t32; /* omega3*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t75 = JLT_FMA(t54, t68, t74); /* e*m*1/s*(b*I3*omega3 + G_level) + omega3*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t76 = x[2]*t32; /* omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t77 = t13*t68; /* 1/Theta*m*1/s*(b*I3*omega3 + G_level) */
    const double t78 = -t77; /* -1/Theta*m*1/s*(b*I3*omega3 + G_level) */
    out[13] = t78;
    const double t79 = t13*t75; /* 1/Theta*t75 */
    const double t80 = -t79; /* -1/Theta*t75 */
    out[14] = t80;
    const double t81 = p[18]*t64; /* m*I3*V */
    const double t82 = JLT_FMA(t47, t81, t76); /* b*1/s*m*I3*V + omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t83 = p[29]*t64; /* m*R*I1*V */
    const double t84 = JLT_FNMA(t38, t83, t37); /* omega_tau*(t35 - m*a3*1/s*(b*I3*omega3 + G_level)) - t38*m*R*I1*V */
    const double t85 = t13*t84; /* 1/Theta*t84 */
    out[12] = t85;
    const double t86 = t13*t82; /* 1/Theta*t82 */
    const double t87 = -t86; /* -1/Theta*t82 */
    out[15] = t87;
    const double t88 = p[1]*x[3]; /* R*omega3 */
    const double t89 = JLT_FMA(t30, t88, t67); /* d(omega_n)/d(gamma3)*R*omega3 + t67 */
    out[4] = t89;
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
    const double t3 = x[0] + p[30]; /* b/R = gamma3 + a3/R */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[6] = t4;
    const double t5 = JLT_FMA(p[31], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t6 = p[9] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t7 = p[12]*t3; /* I3/I1*b/R */
    const double t8 = JLT_FMA(t3, t7, t6); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t9 = t7 - x[0]; /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = I3/I1*b/R - gamma3 */
    const double t10 = t4*t5; /* s*D */
    const double t11 = t8*t10; /* Theta/(m*R^2*I1)*s*D */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*s*D) */
    const double t13 = t8*t12; /* 1/(s*D) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D) */
    const double t14 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = s*D*1/(Theta/(m*R^2*I1)*s*D) */
    const double t15 = t5*t13; /* 1/s = D*1/(s*D) */
    const double t16 = t4*t13; /* 1/D = s*1/(s*D) */
    const double t17 = x[3]*p[32]; /* omega3*R*I3 */
    const double t18 = JLT_FMA(t3, t17, p[6]); /* b/R*omega3*R*I3 + G_level */
    const double t19 = t15*t18; /* 1/s*(b/R*omega3*R*I3 + G_level) */
    const double t20 = t3*t15; /* b/R*1/s */
    const double t21 = x[2]*t4; /* omega_tau*s */
    out[0] = t21;
    const double t22 = x[0]*t16; /* gamma3*1/D */
    const double t23 = t15*t19; /* 1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t24 = t21*t22; /* omega_tau*s*gamma3*1/D */
    const double t25 = p[42]*t22; /* 2*m*a3^2/(R^2*I1)*gamma3*1/D */
    const double t26 = x[0]*t23; /* gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t27 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t28 = x[0]*t15; /* gamma3*1/s */
    const double t29 = p[33]*t4; /* m*R^2*g*a3*I1*s */
    const double t30 = t17 + t26; /* omega3*R*I3 + gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t31 = JLT_FMA(t19, t30, t29); /* 1/s*(b/R*omega3*R*I3 + G_level)*(omega3*R*I3 + gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level)) + m*R^2*g*a3*I1*s */
    const double t32 = t15*t30; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/s*(omega3*R*I3 + gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level)) */
    const double t33 = t15*t23; /* 1/s*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t34 = t23*t33; /* 1/s*1/s*(b/R*omega3*R*I3 + G_level)*1/s*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t35 = p[37]*t23; /* 1/(R*I1^2)*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t36 = JLT_FMA(2.0, t26, t17); /* 2*gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level) + omega3*R*I3 */
    const double t37 = JLT_FMA(t20, t26, t19); /* b/R*1/s*gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level) + 1/s*(b/R*omega3*R*I3 + G_level) */
    const double t38 = t35*t37; /* 1/(R*I1^2)*1/s*1/s*(b/R*omega3*R*I3 + G_level)*t37 */
    const double t39 = JLT_FMA(t32, t36, t34); /* d(omega_n)/d(gamma3)/(1/(R*I1))*(2*gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level) + omega3*R*I3) + t34 */
    const double t40 = JLT_FMA(t20, t36, t19); /* b/R*1/s*(2*gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level) + omega3*R*I3) + 1/s*(b/R*omega3*R*I3 + G_level) */
    const double t41 = JLT_FMA(x[2], t27, x[1]); /* V = omega_tau*e + v_nu */
    const double t42 = x[2]*t28; /* omega_tau*gamma3*1/s */
    const double t43 = p[41]*t28; /* m*g*a3*gamma3*1/s */
    const double t44 = JLT_FNMA(t25, t31, t43); /* m*g*a3*gamma3*1/s - 2*m*a3^2/(R^2*I1)*gamma3*1/D*t31 */
    const double t45 = -t42; /* -omega_tau*gamma3*1/s */
    out[4] = t45;
    const double t46 = p[43]*t24; /* 2*m*a3^2*omega_tau*s*gamma3*1/D */
    out[14] = t46;
    const double t47 = t46 - t42; /* 2*m*a3^2*omega_tau*s*gamma3*1/D - omega_tau*gamma3*1/s */
    const double t48 = JLT_FMA(x[0], t47, t21); /* gamma3*(2*m*a3^2*omega_tau*s*gamma3*1/D - omega_tau*gamma3*1/s) + omega_tau*s */
    const double t49 = JLT_FNMA(x[0], p[47], p[46]); /* 2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1 */
    const double t50 = t9*t49; /* d(Theta)/d(gamma3)/(2*m*R^2*I1)*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) */
    const double t51 = JLT_FMA(t14, t50, p[36]); /* 1/(Theta/(m*R^2*I1))*t50 + (I1 - I3)/I1 */
    const double t52 = 2.0*t9; /* 2*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t53 = t14*t19; /* 1/(Theta/(m*R^2*I1))*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t54 = JLT_FNMA(t52, t53, t32); /* d(omega_n)/d(gamma3)/(1/(R*I1)) - 2*d(Theta)/d(gamma3)/(2*m*R^2*I1)*1/(Theta/(m*R^2*I1))*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t55 = JLT_FNMA(x[0], p[36], p[35]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t56 = x[3]*t14; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t57 = x[2]*p[45]; /* omega_tau*a3/(R^2*I1) */
    const double t58 = t53*t57; /* 1/(Theta/(m*R^2*I1))*1/s*(b/R*omega3*R*I3 + G_level)*omega_tau*a3/(R^2*I1) */
    const double t59 = p[34]*t53; /* 1/(R^2*I1)*1/(Theta/(m*R^2*I1))*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t60 = -t59; /* -t59 */
    out[17] = t60;
    const double t61 = p[48]*t41; /* I3/(R*I1)*V */
    const double t62 = t20*t61; /* b/R*1/s*I3/(R*I1)*V */
    const double t63 = JLT_FMA(t21, t55, t62); /* omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + b/R*1/s*I3/(R*I1)*V */
    const double t64 = t55*t56; /* (a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*omega3*1/(Theta/(m*R^2*I1)) */
    const double t65 = t21*t56; /* omega_tau*s*omega3*1/(Theta/(m*R^2*I1)) */
    const double t66 = JLT_FMS(t51, t65, t58); /* (1/(Theta/(m*R^2*I1))*t50 + (I1 - I3)/I1)*omega_tau*s*omega3*1/(Theta/(m*R^2*I1)) - t58 */
    const double t67 = JLT_FMA(t42, t64, t66); /* omega_tau*gamma3*1/s*t64 + t66 */
    const double t68 = t4*t64; /* s*t64 */
    const double t69 = JLT_FMA(t27, t59, t68); /* e*t59 + s*t64 */
    const double t70 = -t69; /* -(e*t59 + s*t64) */
    out[18] = t70;
    const double t71 = t41*t59; /* V*t59 */
    const double t72 = JLT_FMA(t21, t64, t71); /* omega_tau*s*t64 + V*t59 */
    const double t73 = -t72; /* -(omega_tau*s*t64 + V*t59) */
    out[3] = t73;
    const double t74 = p[34]*t41; /* 1/(R^2*I1)*V */
    const double t75 = t14*t74; /* 1/(Theta/(m*R^2*I1))*1/(R^2*I1)*V */
    const double t76 = JLT_FNMA(t54, t75, t67); /* omega_tau*gamma3*1/s*t64 + t66 - t54*1/(Theta/(m*R^2*I1))*1/(R^2*I1)*V */
    out[16] = t76;
    const double t77 = t14*t63; /* 1/(Theta/(m*R^2*I1))*t63 */
    const double t78 = -t77; /* -1/(Theta/(m*R^2*I1))*t63 */
    out[19] = t78;
    const double t79 = t19*t20; /* 1/s*(b/R*omega3*R*I3 + G_level)*b/R*1/s */
    const double t80 = p[19]*t19; /* 1/I1*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t81 = x[2]*p[31]; /* omega_tau*m*a3^2 */
    const double t82 = JLT_FMA(t48, t81, t44); /* t48*omega_tau*m*a3^2 + m*g*a3*gamma3*1/s - 2*m*a3^2/(R^2*I1)*gamma3*1/D*t31 */
    const double t83 = t24*t81; /* omega_tau*s*gamma3*1/D*omega_tau*m*a3^2 */
    const double t84 = t16*t82; /* 1/D*t82 */
    const double t85 = JLT_FMA(p[38], t79, x[3]); /* 2/(R*I1)*1/s*(b/R*omega3*R*I3 + G_level)*b/R*1/s + omega3 */
    const double t86 = p[19]*t85; /* 1/I1*(2/(R*I1)*1/s*(b/R*omega3*R*I3 + G_level)*b/R*1/s + omega3) */
    const double t87 = JLT_FMA(t32, t86, t38); /* d(omega_n)/d(gamma3)/(1/(R*I1))*t86 + 1/(R*I1^2)*1/s*1/s*(b/R*omega3*R*I3 + G_level)*t37 */
    out[8] = t87;
    const double t88 = x[3]*p[40]; /* omega3*R*I3/I1 */
    const double t89 = JLT_FMA(t20, t88, t80); /* b/R*1/s*omega3*R*I3/I1 + 1/I1*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t90 = p[39]*t20; /* 2*I3/I1^2*b/R*1/s */
    const double t91 = JLT_FMA(t79, t90, t89); /* 1/s*(b/R*omega3*R*I3 + G_level)*b/R*1/s*2*I3/I1^2*b/R*1/s + t89 */
    out[11] = t91;
    const double t92 = JLT_FMA(p[7], t79, x[3]); /* 1/(R*I1)*1/s*(b/R*omega3*R*I3 + G_level)*b/R*1/s + omega3 */
    const double t93 = t80*t92; /* 1/I1*1/s*(b/R*omega3*R*I3 + G_level)*(1/(R*I1)*1/s*(b/R*omega3*R*I3 + G_level)*b/R*1/s + omega3) */
    out[1] = t93;
    const double t94 = p[34]*t16; /* 1/(R^2*I1)*1/D */
    const double t95 = JLT_FNMA(t31, t94, t83); /* omega_tau*s*gamma3*1/D*omega_tau*m*a3^2 - t31*1/(R^2*I1)*1/D */
    out[2] = t95;
    const double t96 = JLT_FNMA(t39, t94, t84); /* 1/D*t82 - t39*1/(R^2*I1)*1/D */
    out[12] = t96;
    const double t97 = p[44]*t16; /* (-I3/(R*I1))*1/D */
    const double t98 = t40*t97; /* t40*(-I3/(R*I1))*1/D */
    out[15] = t98;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = t3*p[18]; /* b*m*I3 */
    const double t5 = JLT_FMA(t2, p[17], p[16]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*b*m*I3 + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = JLT_FMA(t2, p[31], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t9 = t7*t8; /* s*D */
    const double t10 = t6*t9; /* Theta*s*D */
    const double t11 = 1.0/t10; /* 1/(Theta*s*D) */
    const double t12 = t6*t11; /* 1/(s*D) = Theta*1/(Theta*s*D) */
    const double t13 = p[43]*t2; /* 2*m*a3^2*(1 - gamma3)*(gamma3 + 1) */
    const double t14 = t8*t12; /* 1/s = D*1/(s*D) */
    const double t15 = t9*t11; /* 1/Theta = s*D*1/(Theta*s*D) */
    const double t16 = t7*t15; /* s*1/Theta */
    const double t17 = JLT_FMS(t12, t13, t14); /* 1/(s*D)*2*m*a3^2*(1 - gamma3)*(gamma3 + 1) - 1/s */
    const double t18 = JLT_FMA(p[24], t16, t17); /* m*R^2*(I1 - I3)*s*1/Theta + 1/(s*D)*2*m*a3^2*(1 - gamma3)*(gamma3 + 1) - 1/s */
    const double t19 = x[0]*t18; /* gamma3*t18 */
    const double t20 = JLT_FNMA(t16, p[25], t19); /* gamma3*t18 - s*1/Theta*m*R*a3*I3 */
    const double t21 = x[2]*t20; /* omega_tau*(gamma3*t18 - s*1/Theta*m*R*a3*I3) */
    const double t22 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t23 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = t4*t23; /* b*m*I3*V */
    const double t25 = t15*t24; /* 1/Theta*b*m*I3*V */
    const double t26 = JLT_FNMA(t14, t25, t21); /* omega_tau*(gamma3*t18 - s*1/Theta*m*R*a3*I3) - 1/s*1/Theta*b*m*I3*V */
    out[0] = t26;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[30]; /* b/R = gamma3 + a3/R */
    const double t4 = p[32]*x[3]; /* R*I3*omega3 */
    const double t5 = JLT_FMA(t3, t4, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t6 = p[19]*t3; /* 1/I1*b/R */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = JLT_FMA(p[31], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t9 = t5/t7; /* (b/R*R*I3*omega3 + G_level)/s */
    const double t10 = t6*t9; /* 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s */
    const double t11 = p[50]*x[0]; /* 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(x[1], x[1], t11); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[51]*x[2]; /* 1/m*omega_tau */
    const double t14 = x[2]*t13; /* omega_tau*1/m*omega_tau */
    const double t15 = x[3]*p[53]; /* omega3*I3/m */
    const double t16 = JLT_FMA(x[3], t15, t12); /* omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t17 = JLT_FMA(t8, t14, t16); /* D*omega_tau*1/m*omega_tau + omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = p[52]*t9; /* 1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s */
    const double t19 = JLT_FMA(t9, t18, t17); /* (b/R*R*I3*omega3 + G_level)/s*1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s + t17 */
    const double t20 = x[3]*p[1]; /* omega3*R */
    const double t21 = JLT_FMA(t7, t20, t10); /* v_tau = s*omega3*R + 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s */
    const double t22 = JLT_FMA(t21, t21, t19); /* energy/(1/2*m) = v_tau*v_tau + t19 */
    const double t23 = p[49]*t22; /* 1/2*m*energy/(1/2*m) */
    out[0] = t23;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = JLT_FMA(p[31], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*t5; /* omega_tau*D */
    out[2] = t6;
    const double t7 = x[0] + p[30]; /* b/R = gamma3 + a3/R */
    const double t8 = p[32]*x[3]; /* R*I3*omega3 */
    const double t9 = JLT_FMA(t7, t8, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t10 = 1.0/t4; /* 1/s */
    const double t11 = t9*t10; /* (b/R*R*I3*omega3 + G_level)*1/s */
    const double t12 = p[7]*t11; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t13 = p[54]*t11; /* 1/R*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t14 = x[0]*t10; /* gamma3*1/s */
    const double t15 = t12*t14; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level)*1/s*gamma3*1/s */
    const double t16 = JLT_FMA(x[3], p[12], t15); /* omega3*I3/I1 + 1/(R*I1)*(b/R*R*I3*omega3 + G_level)*1/s*gamma3*1/s */
    const double t17 = t10*t16; /* d(omega_n)/d(gamma3) = 1/s*t16 */
    const double t18 = t7*t10; /* b/R*1/s */
    const double t19 = JLT_FNMA(x[3], t14, t12); /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t20 = JLT_FMA(t7, t17, t19); /* d(v_tau)/d(gamma3)/R = b/R*d(omega_n)/d(gamma3) + 1/(R*I1)*(b/R*R*I3*omega3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t21 = p[31]*x[0]; /* m*a3^2*gamma3 */
    const double t22 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t23 = JLT_FNMA(t21, t22, p[41]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t24 = JLT_FMA(t13, t17, t23); /* 1/R*(b/R*R*I3*omega3 + G_level)*1/s*d(omega_n)/d(gamma3) + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t25 = t7*t12; /* b/R*1/(R*I1)*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t26 = JLT_FMA(x[3], t4, t25); /* v_tau/R = omega3*s + b/R*1/(R*I1)*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t27 = JLT_FMA(t12, t18, x[3]); /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level)*1/s*b/R*1/s + omega3 */
    const double t28 = p[12]*t7; /* I3/I1*b/R */
    const double t29 = JLT_FMA(t18, t28, t4); /* d(v_tau)/d(omega3)/R = b/R*1/s*I3/I1*b/R + s */
    const double t30 = p[55]*t26; /* m*R^2*v_tau/R */
    const double t31 = JLT_FMA(t20, t30, t24); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R + t24 */
    out[0] = t31;
    const double t32 = p[5]*t27; /* I3*(1/(R*I1)*(b/R*R*I3*omega3 + G_level)*1/s*b/R*1/s + omega3) */
    const double t33 = JLT_FMA(t29, t30, t32); /* d(energy)/d(omega3) = d(v_tau)/d(omega3)/R*m*R^2*v_tau/R + t32 */
    out[3] = t33;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0] + p[30]; /* b/R = gamma3 + a3/R */
    const double t5 = p[32]*x[3]; /* R*I3*omega3 */
    const double t6 = JLT_FMA(t4, t5, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t7 = p[13]*t6; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t8 = t7/t3; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level)/s */
    out[0] = t8;
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
    double t11[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t18[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t19[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t22[k] = jlt_jet_root(t20[k], t22, k);
        t23[k] = p[8]*t20[k] + (k == 0 ? 1.0 : 0);
        t24[k] = (k == 0 ? p[9] : 0) + t20[k];
        t25[k] = p[10]*t21[k];
        t26[k] = jlt_jet_product(t21, t25, k) + t24[k];
        t27[k] = jlt_jet_product(t22, t23, k);
        t28[k] = jlt_jet_product(t26, t27, k);
        t29[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t28, t29, k);
        t30[k] = jlt_jet_product(t26, t29, k);
        t31[k] = jlt_jet_product(t23, t30, k);
        t32[k] = p[13]*t27[k];
        t33[k] = jlt_jet_product(t29, t32, k);
        t34[k] = jlt_jet_product(t22, t30, k);
        t35[k] = p[5]*x3[k];
        t36[k] = jlt_jet_product(t21, t35, k) + (k == 0 ? p[6] : 0);
        t37[k] = p[7]*t36[k];
        t38[k] = jlt_jet_product(t31, t37, k);
        t39[k] = jlt_jet_product(t31, t38, k);
        t40[k] = jlt_jet_product(t38, t39, k);
        t41[k] = jlt_jet_product(t21, t40, k);
        t42[k] = jlt_jet_product(x2, t22, k);
        t43[k] = x2[k]*p[8];
        t44[k] = jlt_jet_product(t42, t43, k) - t40[k];
        t45[k] = jlt_jet_product(x0, t44, k);
        t46[k] = t45[k] - p[11]*t22[k];
        t47[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t48[k] = jlt_jet_product(x2, t47, k) + x1[k];
        t49[k] = jlt_jet_product(t38, t48, k);
        t50[k] = jlt_jet_product(x3, t38, k);
        t51[k] = p[1]*t50[k] + t41[k];
        t52[k] = t46[k] - p[12]*t50[k];
        t53[k] = jlt_jet_product(t34, t52, k);
        t54[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t55[k] = jlt_jet_product(x3, t54, k);
        t56[k] = jlt_jet_product(t42, t55, k) + t49[k];
        t57[k] = jlt_jet_product(t33, t56, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t42[k]/(k + 1);
        next[1] = x1[k + 1] = t51[k]/(k + 1);
        next[2] = x2[k + 1] = t53[k]/(k + 1);
        next[3] = x3[k + 1] = t57[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double v_a3 = params[3];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_named integrals[] = {
    { "E", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 56,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 23, 12, 1, 1, 0, 16, 9 }, { 15, 58, 0, 9, 1, 0, 10, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 9, 51, 28, 1, 1, 0, 18, 21 }, { 47, 240, 0, 39, 1, 0, 18, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 12, 55, 30, 1, 1, 0, 17, 25 }, { 54, 277, 0, 47, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 13, 10, 1, 1, 0, 14, 8 }, { 12, 39, 0, 5, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 3, 11, 8, 1, 1, 0, 8, 8 }, { 10, 31, 0, 1, 1, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 3, 17, 12, 1, 1, 0, 11, 10 }, { 15, 50, 0, 6, 1, 0, 12, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 3, 1, 1, 1, 0, 4, 4 }, { 3, 6, 0, 1, 1, 0, 5, 4 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_on_level_G_baseline,
        &jlt_batch_spherical_top_general_on_level_G_avx2,
        &jlt_batch_spherical_top_general_on_level_G_avx512,
    },
};
