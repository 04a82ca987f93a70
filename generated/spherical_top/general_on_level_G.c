/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   23   11    1    1    0     15   11   (83)
 *  jacobian            11   53   27    1    1    0     16   18   (327)
 *  rhs_jacobian        12   57   29    1    1    0     17   23   (379)
 *  divergence          4   14    8    1    1    0     11    8   (57)
 *  integral_values     3   11    8    1    1    0      8    8   (43)
 *  integral_gradients  3   17   12    1    1    0     10   10   (72)
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
    const double t0 = 1.0/params[4]; /* 1/I1 */
    out[7] = t0;
    const double t1 = params[3]/params[1]; /* a3/R */
    out[8] = t1;
    const double t2 = params[1]*params[5]; /* R*I3 */
    out[9] = t2;
    const double t3 = params[3]*params[3]; /* a3*a3 */
    const double t4 = params[0]*t3; /* m*a3*a3 */
    out[10] = t4;
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    out[44] = t6;
    const double t7 = params[5]/t6; /* I3/(m*R*R) */
    out[11] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[12] = t8;
    const double t9 = params[4]*params[1]; /* I1*R */
    const double t10 = 1.0/t9; /* 1/(I1*R) */
    out[13] = t10;
    const double t11 = params[4]*t5; /* I1*R*R */
    const double t12 = 1.0/t11; /* 1/(I1*R*R) */
    out[14] = t12;
    const double t13 = params[0]*params[2]; /* m*g */
    const double t14 = params[3]*t13; /* a3*m*g */
    out[15] = t14;
    const double t15 = params[3]*params[5]; /* a3*I3 */
    const double t16 = t15/t9; /* a3*I3/(I1*R) */
    out[16] = t16;
    const double t17 = params[4] - params[5]; /* I1 - I3 */
    const double t18 = t17/params[4]; /* (I1 - I3)/I1 */
    out[17] = t18;
    const double t19 = 2.0/t9; /* 2/(I1*R) */
    out[18] = t19;
    const double t20 = params[4]*params[4]; /* I1*I1 */
    const double t21 = params[1]*t20; /* R*I1*I1 */
    const double t22 = 1.0/t21; /* 1/(R*I1*I1) */
    out[19] = t22;
    const double t23 = params[5]*2.0; /* I3*2 */
    const double t24 = t23/t20; /* I3*2/(I1*I1) */
    out[20] = t24;
    const double t25 = t2/params[4]; /* R*I3/I1 */
    out[21] = t25;
    const double t26 = params[0]*2.0; /* m*2 */
    const double t27 = t3*t26; /* a3*a3*m*2 */
    out[22] = t27;
    const double t28 = params[5]/t9; /* I3/(I1*R) */
    out[29] = t28;
    const double t29 = -t28; /* -I3/(I1*R) */
    out[23] = t29;
    const double t30 = params[5]*(-2.0); /* I3*(-2) */
    const double t31 = t30/t9; /* I3*(-2)/(I1*R) */
    out[24] = t31;
    const double t32 = params[5]*params[5]; /* I3*I3 */
    const double t33 = t32/params[4]; /* I3*I3/I1 */
    const double t34 = -t33; /* -I3*I3/I1 */
    out[25] = t34;
    const double t35 = params[3]*2.0; /* a3*2 */
    const double t36 = params[5]*t35; /* I3*a3*2 */
    const double t37 = t36/t9; /* I3*a3*2/(I1*R) */
    out[26] = t37;
    const double t38 = t17*2.0; /* (I1 - I3)*2 */
    const double t39 = t38/params[4]; /* (I1 - I3)*2/I1 */
    out[27] = t39;
    const double t40 = params[3]/t11; /* a3/(I1*R*R) */
    out[28] = t40;
    const double t41 = (-1.0)/t11; /* (-1)/(I1*R*R) */
    out[30] = t41;
    const double t42 = t6*params[2]; /* m*R*R*g */
    const double t43 = params[3]*t42; /* a3*m*R*R*g */
    const double t44 = params[4]*t43; /* I1*a3*m*R*R*g */
    out[31] = t44;
    const double t45 = t3*t6; /* a3*a3*m*R*R */
    const double t46 = params[4]*t45; /* I1*a3*a3*m*R*R */
    out[32] = t46;
    const double t47 = 2.0/t21; /* 2/(R*I1*I1) */
    out[33] = t47;
    const double t48 = (-2.0)/t11; /* (-2)/(I1*R*R) */
    out[34] = t48;
    const double t49 = t2/2.0; /* R*I3/2 */
    out[35] = t49;
    const double t50 = 2.0/t11; /* 2/(I1*R*R) */
    out[36] = t50;
    const double t51 = params[3]/2.0; /* a3/2 */
    out[37] = t51;
    const double t52 = params[0]/2.0; /* m/2 */
    out[38] = t52;
    const double t53 = params[2]*2.0; /* g*2 */
    const double t54 = params[3]*t53; /* a3*g*2 */
    out[39] = t54;
    const double t55 = 1.0/params[0]; /* 1/m */
    out[40] = t55;
    const double t56 = params[4]*t6; /* I1*m*R*R */
    const double t57 = 1.0/t56; /* 1/(I1*m*R*R) */
    out[41] = t57;
    const double t58 = params[5]/params[0]; /* I3/m */
    out[42] = t58;
    const double t59 = 1.0/params[1]; /* 1/R */
    out[43] = t59;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    out[0] = t4;
    const double t5 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t6 = p[9]*x[3]; /* R*I3*omega3 */
    const double t7 = JLT_FMA(t5, t6, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t8 = JLT_FMA(t2, p[10], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t9 = t5*p[12]; /* b/R*I3/I1 */
    const double t10 = t2 + p[11]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t11 = JLT_FMA(t5, t9, t10); /* Theta/(m*R^2*I1) = b/R*b/R*I3/I1 + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t12 = t3*t8; /* s*D */
    const double t13 = t11*t12; /* Theta/(m*R^2*I1)*s*D */
    const double t14 = 1.0/t13; /* 1/(Theta/(m*R^2*I1)*s*D) */
    const double t15 = t11*t14; /* 1/(s*D) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D) */
    const double t16 = t8*t15; /* 1/s = D*1/(s*D) */
    const double t17 = t7*t16; /* (b/R*R*I3*omega3 + G_level)*1/s */
    const double t18 = t16*t17; /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t19 = t5*p[13]; /* b/R*1/(R*I1) */
    const double t20 = JLT_FMA(t18, t19, x[3]); /* 1/s*(b/R*R*I3*omega3 + G_level)*1/s*b/R*1/(R*I1) + omega3 */
    const double t21 = p[7]*t17; /* 1/I1*(b/R*R*I3*omega3 + G_level)*1/s */
    const double t22 = t20*t21; /* (1/s*(b/R*R*I3*omega3 + G_level)*1/s*b/R*1/(R*I1) + omega3)*1/I1*(b/R*R*I3*omega3 + G_level)*1/s */
    out[1] = t22;
    const double t23 = x[2]*p[10]; /* omega_tau*m*a3^2 */
    const double t24 = t4*t23; /* omega_tau*s*omega_tau*m*a3^2 */
    const double t25 = t17*p[14]; /* (b/R*R*I3*omega3 + G_level)*1/s*1/(R^2*I1) */
    const double t26 = JLT_FNMA(t18, t25, t24); /* omega_tau*s*omega_tau*m*a3^2 - 1/s*(b/R*R*I3*omega3 + G_level)*1/s*(b/R*R*I3*omega3 + G_level)*1/s*1/(R^2*I1) */
    const double t27 = x[0]*t26; /* gamma3*t26 */
    const double t28 = JLT_FNMA(t3, p[15], t27); /* gamma3*t26 - s*m*g*a3 */
    const double t29 = JLT_FNMA(t6, t25, t28); /* gamma3*t26 - s*m*g*a3 - R*I3*omega3*(b/R*R*I3*omega3 + G_level)*1/s*1/(R^2*I1) */
    const double t30 = t3*t15; /* s*1/(s*D) */
    const double t31 = t29*t30; /* t29*s*1/(s*D) */
    out[2] = t31;
    const double t32 = JLT_FNMA(x[0], p[17], p[16]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t33 = x[3]*t32; /* omega3*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t34 = t4*t33; /* omega_tau*s*omega3*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t35 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t36 = JLT_FMA(x[2], t35, x[1]); /* V = omega_tau*e + v_nu */
    const double t37 = JLT_FMA(t25, t36, t34); /* (b/R*R*I3*omega3 + G_level)*1/s*1/(R^2*I1)*V + omega_tau*s*omega3*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t38 = t12*t14; /* s*D*1/(Theta/(m*R^2*I1)*s*D) */
    const double t39 = t37*t38; /* t37*s*D*1/(Theta/(m*R^2*I1)*s*D) */
    const double t40 = -t39; /* -t37*s*D*1/(Theta/(m*R^2*I1)*s*D) */
    out[3] = t40;
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
    const double t3 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t4 = JLT_FMA(p[10], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = p[12]*t3; /* I3/I1*b/R */
    const double t6 = p[11] + t2; /* I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t7;
    const double t8 = JLT_FMA(t3, t5, t6); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t9 = t5 - x[0]; /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = I3/I1*b/R - gamma3 */
    const double t10 = t4*t7; /* D*s */
    const double t11 = t8*t10; /* Theta/(m*R^2*I1)*D*s */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*D*s) */
    const double t13 = t8*t12; /* 1/(s*D) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D*s) */
    const double t14 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = D*s*1/(Theta/(m*R^2*I1)*D*s) */
    const double t15 = t9*t14; /* d(Theta)/d(gamma3)/(2*m*R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t16 = t4*t13; /* 1/s = D*1/(s*D) */
    const double t17 = t7*t13; /* 1/D = s*1/(s*D) */
    const double t18 = p[9]*x[3]; /* R*I3*omega3 */
    const double t19 = x[0]*p[22]; /* gamma3*2*m*a3^2 */
    const double t20 = t17*t19; /* 1/D*gamma3*2*m*a3^2 */
    const double t21 = JLT_FNMA(x[0], p[27], p[26]); /* 2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1 */
    const double t22 = JLT_FMA(t15, t21, p[17]); /* d(Theta)/d(gamma3)/(2*m*R^2*I1)*1/(Theta/(m*R^2*I1))*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) + (I1 - I3)/I1 */
    const double t23 = t7*t22; /* s*t22 */
    const double t24 = JLT_FMA(t3, t18, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t25 = t16*t24; /* 1/s*(b/R*R*I3*omega3 + G_level) */
    const double t26 = t3*t16; /* b/R*1/s */
    const double t27 = x[0]*t16; /* gamma3*1/s */
    const double t28 = t7*t20; /* s*1/D*gamma3*2*m*a3^2 */
    const double t29 = x[2]*t28; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[10] = t29;
    const double t30 = t27 - t28; /* gamma3*1/s - s*1/D*gamma3*2*m*a3^2 */
    const double t31 = JLT_FNMA(x[0], p[17], p[16]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t32 = JLT_FMA(t27, t31, t23); /* gamma3*1/s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + s*t22 */
    const double t33 = x[3]*t32; /* omega3*(gamma3*1/s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + s*t22) */
    const double t34 = t7*t31; /* s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t35 = JLT_FMS(x[0], t30, t7); /* gamma3*(gamma3*1/s - s*1/D*gamma3*2*m*a3^2) - s */
    const double t36 = p[15]*t30; /* m*g*a3*(gamma3*1/s - s*1/D*gamma3*2*m*a3^2) */
    const double t37 = JLT_FNMA(p[28], t25, t33); /* t33 - a3/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t38 = t14*t34; /* 1/(Theta/(m*R^2*I1))*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t39 = x[2]*t37; /* omega_tau*(t33 - a3/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level)) */
    const double t40 = t16*t25; /* 1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t41 = p[14]*t25; /* 1/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t42 = t20*t41; /* 1/D*gamma3*2*m*a3^2*1/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t43 = t14*t41; /* 1/(Theta/(m*R^2*I1))*1/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t44 = -t43; /* -t43 */
    out[13] = t44;
    const double t45 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t46 = JLT_FMA(t25, t27, t18); /* 1/s*(b/R*R*I3*omega3 + G_level)*gamma3*1/s + R*I3*omega3 */
    const double t47 = JLT_FNMA(t42, t46, t36); /* m*g*a3*(gamma3*1/s - s*1/D*gamma3*2*m*a3^2) - t42*(1/s*(b/R*R*I3*omega3 + G_level)*gamma3*1/s + R*I3*omega3) */
    const double t48 = t16*t46; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/s*(1/s*(b/R*R*I3*omega3 + G_level)*gamma3*1/s + R*I3*omega3) */
    const double t49 = t16*t40; /* 1/s*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t50 = t40*t49; /* 1/s*1/s*(b/R*R*I3*omega3 + G_level)*1/s*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t51 = p[19]*t40; /* 1/(R*I1^2)*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t52 = x[2]*p[10]; /* omega_tau*m*a3^2 */
    const double t53 = x[2]*t52; /* omega_tau*omega_tau*m*a3^2 */
    const double t54 = JLT_FNMA(t35, t53, t47); /* t47 - (gamma3*(gamma3*1/s - s*1/D*gamma3*2*m*a3^2) - s)*omega_tau*omega_tau*m*a3^2 */
    const double t55 = 2.0*t25; /* 2*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t56 = JLT_FMA(t27, t55, t18); /* gamma3*1/s*2*1/s*(b/R*R*I3*omega3 + G_level) + R*I3*omega3 */
    const double t57 = JLT_FMA(t48, t56, t50); /* d(omega_n)/d(gamma3)/(1/(R*I1))*(gamma3*1/s*2*1/s*(b/R*R*I3*omega3 + G_level) + R*I3*omega3) + t50 */
    const double t58 = JLT_FNMA(t15, t55, t48); /* d(omega_n)/d(gamma3)/(1/(R*I1)) - d(Theta)/d(gamma3)/(2*m*R^2*I1)*1/(Theta/(m*R^2*I1))*2*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t59 = JLT_FNMA(p[14], t57, t54); /* t54 - 1/(R^2*I1)*t57 */
    const double t60 = t17*t59; /* 1/D*(t54 - 1/(R^2*I1)*t57) */
    out[8] = t60;
    const double t61 = p[7]*t48; /* 1/I1*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    const double t62 = JLT_FMA(x[2], t45, x[1]); /* V = omega_tau*e + v_nu */
    const double t63 = t25*t26; /* 1/s*(b/R*R*I3*omega3 + G_level)*b/R*1/s */
    const double t64 = p[23]*t17; /* (-I3/(R*I1))*1/D */
    const double t65 = t25*t64; /* 1/s*(b/R*R*I3*omega3 + G_level)*(-I3/(R*I1))*1/D */
    const double t66 = p[29]*t62; /* I3/(R*I1)*V */
    const double t67 = p[14]*t62; /* 1/(R^2*I1)*V */
    const double t68 = JLT_FNMA(t58, t67, t39); /* t39 - t58*1/(R^2*I1)*V */
    const double t69 = t14*t68; /* 1/(Theta/(m*R^2*I1))*(t39 - t58*1/(R^2*I1)*V) */
    out[12] = t69;
    const double t70 = t14*t66; /* 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t71 = JLT_FMA(p[18], t63, x[3]); /* 2/(R*I1)*1/s*(b/R*R*I3*omega3 + G_level)*b/R*1/s + omega3 */
    const double t72 = t61*t71; /* 1/I1*d(omega_n)/d(gamma3)/(1/(R*I1))*(2/(R*I1)*1/s*(b/R*R*I3*omega3 + G_level)*b/R*1/s + omega3) */
    const double t73 = t27*t63; /* gamma3*1/s*1/s*(b/R*R*I3*omega3 + G_level)*b/R*1/s */
    const double t74 = x[2]*t27; /* omega_tau*gamma3*1/s */
    const double t75 = -t74; /* -omega_tau*gamma3*1/s */
    out[0] = t75;
    const double t76 = p[7]*t25; /* 1/I1*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t77 = t25 + t73; /* 1/s*(b/R*R*I3*omega3 + G_level) + gamma3*1/s*1/s*(b/R*R*I3*omega3 + G_level)*b/R*1/s */
    const double t78 = JLT_FMA(t51, t77, t72); /* 1/(R*I1^2)*1/s*1/s*(b/R*R*I3*omega3 + G_level)*t77 + t72 */
    out[4] = t78;
    const double t79 = p[20]*t26; /* 2*I3/I1^2*b/R*1/s */
    const double t80 = JLT_FMA(t63, t79, t76); /* 1/s*(b/R*R*I3*omega3 + G_level)*b/R*1/s*2*I3/I1^2*b/R*1/s + 1/I1*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t81 = x[3]*t26; /* omega3*b/R*1/s */
    const double t82 = JLT_FMA(p[21], t81, t80); /* R*I3/I1*omega3*b/R*1/s + t80 */
    out[7] = t82;
    const double t83 = p[25]*t17; /* (-I3^2/I1)*1/D */
    const double t84 = JLT_FMA(t81, t83, t65); /* omega3*b/R*1/s*(-I3^2/I1)*1/D + 1/s*(b/R*R*I3*omega3 + G_level)*(-I3/(R*I1))*1/D */
    const double t85 = p[24]*t17; /* (-2*I3/(R*I1))*1/D */
    const double t86 = JLT_FMA(t73, t85, t84); /* gamma3*1/s*1/s*(b/R*R*I3*omega3 + G_level)*b/R*1/s*(-2*I3/(R*I1))*1/D + t84 */
    out[11] = t86;
    const double t87 = x[3]*t38; /* omega3*1/(Theta/(m*R^2*I1))*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t88 = JLT_FMA(t43, t45, t87); /* t43*e + t87 */
    const double t89 = -t88; /* -(t43*e + t87) */
    out[14] = t89;
    const double t90 = x[2]*t38; /* omega_tau*1/(Theta/(m*R^2*I1))*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t91 = JLT_FMA(t26, t70, t90); /* b/R*1/s*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V + t90 */
    const double t92 = -t91; /* -(b/R*1/s*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V + t90) */
    out[15] = t92;
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
    const double t3 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[6] = t4;
    const double t5 = JLT_FMA(p[10], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t6 = p[11] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
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
    const double t17 = x[3]*p[9]; /* omega3*R*I3 */
    const double t18 = JLT_FMA(t3, t17, p[6]); /* b/R*omega3*R*I3 + G_level */
    const double t19 = t15*t18; /* 1/s*(b/R*omega3*R*I3 + G_level) */
    const double t20 = x[2]*p[32]; /* omega_tau*m*R^2*a3^2*I1 */
    const double t21 = x[0]*t15; /* gamma3*1/s */
    const double t22 = x[0]*t20; /* gamma3*omega_tau*m*R^2*a3^2*I1 */
    const double t23 = x[2]*t21; /* omega_tau*gamma3*1/s */
    const double t24 = -t23; /* -omega_tau*gamma3*1/s */
    out[4] = t24;
    const double t25 = x[2]*t4; /* omega_tau*s */
    out[0] = t25;
    const double t26 = t15*t19; /* 1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t27 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t28 = t22*t23; /* gamma3*omega_tau*m*R^2*a3^2*I1*omega_tau*gamma3*1/s */
    const double t29 = JLT_FNMA(t20, t25, t28); /* gamma3*omega_tau*m*R^2*a3^2*I1*omega_tau*gamma3*1/s - omega_tau*m*R^2*a3^2*I1*omega_tau*s */
    const double t30 = JLT_FNMA(p[31], t21, t29); /* t29 - m*R^2*g*a3*I1*gamma3*1/s */
    const double t31 = JLT_FNMA(x[0], p[27], p[26]); /* 2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1 */
    const double t32 = t9*t31; /* d(Theta)/d(gamma3)/(2*m*R^2*I1)*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) */
    const double t33 = JLT_FMA(t14, t32, p[17]); /* 1/(Theta/(m*R^2*I1))*t32 + (I1 - I3)/I1 */
    const double t34 = p[31]*t4; /* m*R^2*g*a3*I1*s */
    const double t35 = JLT_FNMA(t22, t25, t34); /* m*R^2*g*a3*I1*s - gamma3*omega_tau*m*R^2*a3^2*I1*omega_tau*s */
    const double t36 = x[0]*t26; /* gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t37 = JLT_FMA(x[2], t27, x[1]); /* V = omega_tau*e + v_nu */
    const double t38 = t14*t37; /* 1/(Theta/(m*R^2*I1))*V */
    const double t39 = JLT_FNMA(x[0], p[17], p[16]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t40 = t14*t39; /* 1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t41 = t17 + t36; /* omega3*R*I3 + gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t42 = JLT_FMA(t19, t41, t35); /* 1/s*(b/R*omega3*R*I3 + G_level)*(omega3*R*I3 + gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level)) + m*R^2*g*a3*I1*s - gamma3*omega_tau*m*R^2*a3^2*I1*omega_tau*s */
    const double t43 = t15*t41; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/s*(omega3*R*I3 + gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level)) */
    const double t44 = t3*t15; /* b/R*1/s */
    const double t45 = t15*t26; /* 1/s*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t46 = JLT_FMA(t26, t45, t30); /* 1/s*1/s*(b/R*omega3*R*I3 + G_level)*1/s*1/s*1/s*(b/R*omega3*R*I3 + G_level) + t29 - m*R^2*g*a3*I1*gamma3*1/s */
    const double t47 = t3*t26; /* b/R*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t48 = p[19]*t26; /* 1/(R*I1^2)*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t49 = JLT_FMA(t17, t44, t19); /* omega3*R*I3*b/R*1/s + 1/s*(b/R*omega3*R*I3 + G_level) */
    const double t50 = x[0]*p[22]; /* gamma3*2*m*a3^2 */
    const double t51 = t16*t50; /* 1/D*gamma3*2*m*a3^2 */
    const double t52 = JLT_FMA(t42, t51, t46); /* t42*1/D*gamma3*2*m*a3^2 + t46 */
    const double t53 = t25*t51; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[14] = t53;
    const double t54 = x[3]*t25; /* omega3*omega_tau*s */
    const double t55 = t33*t54; /* (1/(Theta/(m*R^2*I1))*t32 + (I1 - I3)/I1)*omega3*omega_tau*s */
    const double t56 = x[2]*p[37]; /* omega_tau*1/2*a3 */
    const double t57 = JLT_FNMA(t9, t38, t56); /* omega_tau*1/2*a3 - d(Theta)/d(gamma3)/(2*m*R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t58 = p[14]*t19; /* 1/(R^2*I1)*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t59 = x[3]*t40; /* omega3*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t60 = t23*t59; /* omega_tau*gamma3*1/s*t59 */
    const double t61 = t4*t59; /* s*t59 */
    const double t62 = t36*t44; /* gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level)*b/R*1/s */
    const double t63 = JLT_FMA(x[3], p[35], t36); /* omega3*1/2*R*I3 + gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t64 = t43*t63; /* d(omega_n)/d(gamma3)/(1/(R*I1))*(omega3*1/2*R*I3 + gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level)) */
    const double t65 = JLT_FMA((1.0 / 2.0), t52, t64); /* 1/2*(t42*1/D*gamma3*2*m*a3^2 + t46) + t64 */
    const double t66 = p[36]*t19; /* 2/(R^2*I1)*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t67 = JLT_FNMA(t57, t66, t55); /* (1/(Theta/(m*R^2*I1))*t32 + (I1 - I3)/I1)*omega3*omega_tau*s - t57*2/(R^2*I1)*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t68 = JLT_FMA(t14, t67, t60); /* 1/(Theta/(m*R^2*I1))*t67 + omega_tau*gamma3*1/s*t59 */
    const double t69 = t14*t58; /* 1/(Theta/(m*R^2*I1))*1/(R^2*I1)*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t70 = JLT_FMA(t27, t69, t61); /* e*t69 + s*t59 */
    const double t71 = -t69; /* -t69 */
    out[17] = t71;
    const double t72 = -t70; /* -(e*t69 + s*t59) */
    out[18] = t72;
    const double t73 = t38*t58; /* 1/(Theta/(m*R^2*I1))*V*1/(R^2*I1)*1/s*(b/R*omega3*R*I3 + G_level) */
    const double t74 = JLT_FMA(t25, t59, t73); /* omega_tau*s*t59 + t73 */
    const double t75 = -t74; /* -(omega_tau*s*t59 + t73) */
    out[3] = t75;
    const double t76 = p[29]*t38; /* I3/(R*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t77 = t44*t76; /* b/R*1/s*I3/(R*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t78 = JLT_FMA(t25, t40, t77); /* omega_tau*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + b/R*1/s*I3/(R*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t79 = -t78; /* -t78 */
    out[19] = t79;
    const double t80 = p[20]*t44; /* 2*I3/I1^2*b/R*1/s */
    const double t81 = p[14]*t38; /* 1/(R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t82 = JLT_FNMA(t43, t81, t68); /* 1/(Theta/(m*R^2*I1))*t67 + omega_tau*gamma3*1/s*t59 - d(omega_n)/d(gamma3)/(1/(R*I1))*1/(R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    out[16] = t82;
    const double t83 = p[7]*x[3]; /* 1/I1*omega3 */
    const double t84 = t19 + t62; /* 1/s*(b/R*omega3*R*I3 + G_level) + gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level)*b/R*1/s */
    const double t85 = t48*t84; /* 1/(R*I1^2)*1/s*1/s*(b/R*omega3*R*I3 + G_level)*t84 */
    const double t86 = p[23]*t16; /* (-I3/(R*I1))*1/D */
    const double t87 = t49*t86; /* (omega3*R*I3*b/R*1/s + 1/s*(b/R*omega3*R*I3 + G_level))*(-I3/(R*I1))*1/D */
    const double t88 = p[7]*t49; /* 1/I1*(omega3*R*I3*b/R*1/s + 1/s*(b/R*omega3*R*I3 + G_level)) */
    const double t89 = JLT_FMA(t47, t80, t88); /* b/R*1/s*1/s*(b/R*omega3*R*I3 + G_level)*2*I3/I1^2*b/R*1/s + 1/I1*(omega3*R*I3*b/R*1/s + 1/s*(b/R*omega3*R*I3 + G_level)) */
    out[11] = t89;
    const double t90 = JLT_FMA(p[19], t47, t83); /* 1/(R*I1^2)*b/R*1/s*1/s*(b/R*omega3*R*I3 + G_level) + 1/I1*omega3 */
    const double t91 = t19*t90; /* 1/s*(b/R*omega3*R*I3 + G_level)*t90 */
    out[1] = t91;
    const double t92 = JLT_FMA(p[33], t47, t83); /* 2/(R*I1^2)*b/R*1/s*1/s*(b/R*omega3*R*I3 + G_level) + 1/I1*omega3 */
    const double t93 = JLT_FMA(t43, t92, t85); /* d(omega_n)/d(gamma3)/(1/(R*I1))*t92 + 1/(R*I1^2)*1/s*1/s*(b/R*omega3*R*I3 + G_level)*t84 */
    out[8] = t93;
    const double t94 = p[30]*t16; /* (-1/(R^2*I1))*1/D */
    const double t95 = t42*t94; /* t42*(-1/(R^2*I1))*1/D */
    out[2] = t95;
    const double t96 = p[34]*t16; /* (-2/(R^2*I1))*1/D */
    const double t97 = t65*t96; /* (1/2*(t42*1/D*gamma3*2*m*a3^2 + t46) + t64)*(-2/(R^2*I1))*1/D */
    out[12] = t97;
    const double t98 = p[24]*t16; /* (-2*I3/(R*I1))*1/D */
    const double t99 = JLT_FMA(t62, t98, t87); /* gamma3*1/s*1/s*(b/R*omega3*R*I3 + G_level)*b/R*1/s*(-2*I3/(R*I1))*1/D + t87 */
    out[15] = t99;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t4 = p[12]*t3; /* I3/I1*b/R */
    const double t5 = t2 + p[11]; /* (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = JLT_FMA(t2, p[10], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t9 = t7*t8; /* s*D */
    const double t10 = t6*t9; /* Theta/(m*R^2*I1)*s*D */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s*D) */
    const double t12 = t6*t11; /* 1/(s*D) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D) */
    const double t13 = p[22]*t2; /* 2*m*a3^2*(1 - gamma3)*(gamma3 + 1) */
    const double t14 = t8*t12; /* 1/s = D*1/(s*D) */
    const double t15 = JLT_FMS(t12, t13, t14); /* 1/(s*D)*2*m*a3^2*(1 - gamma3)*(gamma3 + 1) - 1/s */
    const double t16 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t17 = t15*t16; /* (1/(s*D)*2*m*a3^2*(1 - gamma3)*(gamma3 + 1) - 1/s)*gamma3*omega_tau */
    const double t18 = JLT_FNMA(x[0], p[17], p[16]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t19 = x[2]*t18; /* omega_tau*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t20 = t7*t19; /* s*omega_tau*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t21 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t22 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t23 = t3*p[29]; /* b/R*I3/(R*I1) */
    const double t24 = t22*t23; /* V*b/R*I3/(R*I1) */
    const double t25 = JLT_FMA(t14, t24, t20); /* 1/s*V*b/R*I3/(R*I1) + s*omega_tau*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t26 = t9*t11; /* s*D*1/(Theta/(m*R^2*I1)*s*D) */
    const double t27 = JLT_FNMA(t25, t26, t17); /* t17 - t25*s*D*1/(Theta/(m*R^2*I1)*s*D) */
    out[0] = t27;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t4 = p[9]*x[3]; /* R*I3*omega3 */
    const double t5 = JLT_FMA(t3, t4, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t6 = p[7]*t3; /* 1/I1*b/R */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = JLT_FMA(p[10], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t9 = t5/t7; /* (b/R*R*I3*omega3 + G_level)/s */
    const double t10 = t6*t9; /* 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s */
    const double t11 = p[39]*x[0]; /* 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(x[1], x[1], t11); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[40]*x[2]; /* 1/m*omega_tau */
    const double t14 = x[2]*t13; /* omega_tau*1/m*omega_tau */
    const double t15 = x[3]*p[42]; /* omega3*I3/m */
    const double t16 = JLT_FMA(x[3], t15, t12); /* omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t17 = JLT_FMA(t8, t14, t16); /* D*omega_tau*1/m*omega_tau + omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = p[41]*t9; /* 1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s */
    const double t19 = JLT_FMA(t9, t18, t17); /* (b/R*R*I3*omega3 + G_level)/s*1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s + t17 */
    const double t20 = x[3]*p[1]; /* omega3*R */
    const double t21 = JLT_FMA(t7, t20, t10); /* v_tau = s*omega3*R + 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s */
    const double t22 = JLT_FMA(t21, t21, t19); /* energy/(1/2*m) = v_tau*v_tau + t19 */
    const double t23 = p[38]*t22; /* 1/2*m*energy/(1/2*m) */
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
    const double t5 = JLT_FMA(p[10], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*t5; /* omega_tau*D */
    out[2] = t6;
    const double t7 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t8 = x[3]*p[9]; /* omega3*R*I3 */
    const double t9 = JLT_FMA(t7, t8, p[6]); /* b/R*omega3*R*I3 + G_level */
    const double t10 = 1.0/t4; /* 1/s */
    const double t11 = t9*t10; /* (b/R*omega3*R*I3 + G_level)*1/s */
    const double t12 = p[12]*x[3]; /* I3/I1*omega3 */
    const double t13 = p[13]*t11; /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t14 = p[43]*t11; /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t15 = x[0]*t10; /* gamma3*1/s */
    const double t16 = JLT_FMA(t13, t15, t12); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*gamma3*1/s + I3/I1*omega3 */
    const double t17 = t10*t16; /* d(omega_n)/d(gamma3) = 1/s*t16 */
    const double t18 = t7*t10; /* b/R*1/s */
    const double t19 = JLT_FNMA(x[3], t15, t13); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t20 = JLT_FMA(t7, t17, t19); /* d(v_tau)/d(gamma3)/R = b/R*d(omega_n)/d(gamma3) + 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t21 = p[10]*x[0]; /* m*a3^2*gamma3 */
    const double t22 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t23 = JLT_FNMA(t21, t22, p[15]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t24 = JLT_FMA(t14, t17, t23); /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s*d(omega_n)/d(gamma3) + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t25 = t7*t13; /* b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t26 = JLT_FMA(x[3], t4, t25); /* v_tau/R = omega3*s + b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t27 = JLT_FMA(t13, t18, x[3]); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*b/R*1/s + omega3 */
    const double t28 = p[12]*t7; /* I3/I1*b/R */
    const double t29 = JLT_FMA(t18, t28, t4); /* d(v_tau)/d(omega3)/R = b/R*1/s*I3/I1*b/R + s */
    const double t30 = p[44]*t26; /* m*R^2*v_tau/R */
    const double t31 = JLT_FMA(t20, t30, t24); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R + t24 */
    out[0] = t31;
    const double t32 = p[5]*t27; /* I3*(1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*b/R*1/s + omega3) */
    const double t33 = JLT_FMA(t29, t30, t32); /* d(energy)/d(omega3) = d(v_tau)/d(omega3)/R*m*R^2*v_tau/R + t32 */
    out[3] = t33;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t5 = p[9]*x[3]; /* R*I3*omega3 */
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
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
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
        t11[k] = x0[k] + (k == 0 ? p[8] : 0);
        t14[k] = p[9]*x3[k];
        t15[k] = jlt_jet_product(t11, t14, k) + (k == 0 ? p[6] : 0);
        t18[k] = t5[k]*p[10] + (k == 0 ? p[4] : 0);
        t21[k] = t11[k]*p[12];
        t22[k] = t5[k] + (k == 0 ? p[11] : 0);
        t23[k] = jlt_jet_product(t11, t21, k) + t22[k];
        t24[k] = jlt_jet_product(t6, t18, k);
        t25[k] = jlt_jet_product(t23, t24, k);
        t26[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t25, t26, k);
        t27[k] = jlt_jet_product(t23, t26, k);
        t28[k] = jlt_jet_product(t18, t27, k);
        t29[k] = jlt_jet_product(t15, t28, k);
        t31[k] = jlt_jet_product(t28, t29, k);
        t32[k] = t11[k]*p[13];
        t33[k] = jlt_jet_product(t31, t32, k) + x3[k];
        t34[k] = p[7]*t29[k];
        t35[k] = jlt_jet_product(t33, t34, k);
        t36[k] = x2[k]*p[10];
        t37[k] = jlt_jet_product(t7, t36, k);
        t39[k] = t29[k]*p[14];
        t40[k] = t37[k] - jlt_jet_product(t31, t39, k);
        t41[k] = jlt_jet_product(x0, t40, k);
        t43[k] = t41[k] - t6[k]*p[15];
        t44[k] = t43[k] - jlt_jet_product(t14, t39, k);
        t45[k] = jlt_jet_product(t6, t27, k);
        t46[k] = jlt_jet_product(t44, t45, k);
        t49[k] = (k == 0 ? p[16] : 0) - x0[k]*p[17];
        t50[k] = jlt_jet_product(x3, t49, k);
        t51[k] = jlt_jet_product(t7, t50, k);
        t55[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t56[k] = jlt_jet_product(x2, t55, k) + x1[k];
        t57[k] = jlt_jet_product(t39, t56, k) + t51[k];
        t58[k] = jlt_jet_product(t24, t26, k);
        t59[k] = jlt_jet_product(t57, t58, k);
        t60[k] = -t59[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t35[k]/(k + 1);
        next[2] = x2[k + 1] = t46[k]/(k + 1);
        next[3] = x3[k + 1] = t60[k]/(k + 1);
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
    .state_count = 4, .param_count = 7, .block_count = 45,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 23, 11, 1, 1, 0, 15, 11 }, { 15, 58, 0, 9, 1, 0, 10, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 11, 53, 27, 1, 1, 0, 16, 18 }, { 47, 240, 0, 39, 1, 0, 18, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 12, 57, 29, 1, 1, 0, 17, 23 }, { 54, 277, 0, 47, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 4, 14, 8, 1, 1, 0, 11, 8 }, { 12, 39, 0, 5, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 3, 11, 8, 1, 1, 0, 8, 8 }, { 10, 31, 0, 1, 1, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 3, 17, 12, 1, 1, 0, 10, 10 }, { 15, 50, 0, 6, 1, 0, 12, 10 },
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
