/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23   12    1    0    0     11    9   (85)
 *  jacobian            7   53   29    1    0    0     14   20   (397)
 *  rhs_jacobian        8   58   31    1    0    0     13   23   (454)
 *  divergence          2   13    7    1    0    0      9   10   (53)
 *  integral_values     0    9    9    1    0    0      7    7   (40)
 *  integral_gradients  0   16   13    1    0    0      7    9   (82)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          1    1    1    1    0    0      3    3   (8)
 *
 *  Accuracy: divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx512;

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
    const double t1 = t0*params[4]; /* R*R*I1 */
    const double t2 = t1/params[5]; /* R*R*I1/I3 */
    out[7] = t2;
    const double t3 = params[1]*params[4]; /* R*I1 */
    const double t4 = params[6]/t3; /* G_level/(R*I1) */
    out[8] = t4;
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[30] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[9] = t7;
    const double t8 = t0*params[0]; /* R*R*m */
    const double t9 = params[5]/t8; /* I3/(R*R*m) */
    out[10] = t9;
    const double t10 = params[5]/t1; /* I3/(R*R*I1) */
    out[11] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[3]*t11; /* a3*m*g */
    out[37] = t12;
    const double t13 = t12/params[4]; /* a3*m*g/I1 */
    out[12] = t13;
    const double t14 = params[1]*params[0]; /* R*m */
    out[38] = t14;
    const double t15 = params[5]/t14; /* I3/(R*m) */
    out[13] = t15;
    const double t16 = params[3]/params[1]; /* a3/R */
    out[14] = t16;
    const double t17 = params[5]/params[4]; /* I3/I1 */
    out[15] = t17;
    const double t18 = t3/params[5]; /* R*I1/I3 */
    out[16] = t18;
    const double t19 = params[1]*2.0; /* R*2 */
    out[17] = t19;
    const double t20 = params[4]/params[5]; /* I1/I3 */
    out[18] = t20;
    const double t21 = params[0]*2.0; /* m*2 */
    const double t22 = t5*t21; /* a3*a3*m*2 */
    out[31] = t22;
    const double t23 = t22/params[4]; /* a3*a3*m*2/I1 */
    out[19] = t23;
    const double t24 = params[0]*params[0]; /* m*m */
    const double t25 = 2.0*t24; /* 2*m*m */
    const double t26 = params[2]*t25; /* g*2*m*m */
    const double t27 = params[3]*t5; /* a3*a3*a3 */
    const double t28 = t26*t27; /* g*2*m*m*a3*a3*a3 */
    const double t29 = params[4]*params[4]; /* I1*I1 */
    const double t30 = t28/t29; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    out[20] = t30;
    const double t31 = params[2]*t21; /* g*m*2 */
    const double t32 = params[3]*t31; /* a3*g*m*2 */
    const double t33 = t32/params[4]; /* a3*g*m*2/I1 */
    out[21] = t33;
    const double t34 = params[5]*t22; /* I3*a3*a3*m*2 */
    const double t35 = t34/t29; /* I3*a3*a3*m*2/(I1*I1) */
    out[22] = t35;
    const double t36 = params[5]*params[3]; /* I3*a3 */
    const double t37 = t36/t3; /* I3*a3/(R*I1) */
    out[23] = t37;
    const double t38 = 1.0/params[1]; /* 1/R */
    out[24] = t38;
    const double t39 = params[5]*params[5]; /* I3*I3 */
    const double t40 = 2.0*t39; /* 2*I3*I3 */
    const double t41 = t40/t29; /* 2*I3*I3/(I1*I1) */
    out[25] = t41;
    const double t42 = params[5]/t3; /* I3/(R*I1) */
    out[28] = t42;
    const double t43 = -t42; /* -I3/(R*I1) */
    out[26] = t43;
    const double t44 = params[5]*2.0; /* I3*2 */
    const double t45 = t44/params[4]; /* I3*2/I1 */
    out[27] = t45;
    const double t46 = params[1]*t29; /* R*I1*I1 */
    const double t47 = t40/t46; /* 2*I3*I3/(R*I1*I1) */
    out[29] = t47;
    const double t48 = params[0]/2.0; /* m/2 */
    out[32] = t48;
    const double t49 = params[2]*2.0; /* g*2 */
    const double t50 = params[3]*t49; /* a3*g*2 */
    out[33] = t50;
    const double t51 = 1.0/params[0]; /* 1/m */
    out[34] = t51;
    const double t52 = params[4]/params[0]; /* I1/m */
    out[35] = t52;
    const double t53 = t0*t29; /* R*R*I1*I1 */
    const double t54 = params[5]*params[0]; /* I3*m */
    const double t55 = t53/t54; /* R*R*I1*I1/(I3*m) */
    out[36] = t55;
    const double t56 = params[1]*t0; /* R*R*R */
    const double t57 = t29*t56; /* I1*I1*R*R*R */
    const double t58 = t57/params[5]; /* I1*I1*R*R*R/I3 */
    out[39] = t58;
    const double t59 = t53/params[5]; /* R*R*I1*I1/I3 */
    out[40] = t59;
    const double t60 = -t20; /* -I1/I3 */
    out[41] = t60;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = JLT_FMA(p[9], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t3 = p[11]*t1; /* I3/(R^2*I1)*b */
    const double t4 = p[10] + t0; /* I3/(m*R^2) + s*s */
    const double t5 = JLT_FMA(t1, t3, t4); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s*s */
    const double t6 = x[3]*t3; /* omega_n*I3/(R^2*I1)*b */
    const double t7 = t1*t2; /* b*D/I1 */
    const double t8 = t5*t7; /* Theta/(m*R^2*I1)*b*D/I1 */
    const double t9 = 1.0/t8; /* 1/(Theta/(m*R^2*I1)*b*D/I1) */
    const double t10 = t5*t9; /* 1/(b*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*b*D/I1) */
    const double t11 = t7*t9; /* b*D/I1*1/(Theta/(m*R^2*I1)*b*D/I1) */
    const double t12 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t13 = x[4]*t12; /* s*(G_level/(R*I1) - s*omega_n) */
    const double t14 = t2*t13; /* D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t15 = t10*t14; /* 1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t16 = t1*t10; /* b*1/(b*(D/I1)) */
    const double t17 = x[3]*t1; /* omega_n*b */
    const double t18 = JLT_FNMA(p[7], t15, t17); /* omega_n*b - R^2*I1/I3*1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t19 = x[3]*t18; /* omega_n*t18 */
    out[1] = t19;
    const double t20 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t21 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t22 = p[13] + t20; /* I3/(m*R) + e */
    const double t23 = x[2]*t22; /* omega_tau*(I3/(m*R) + e) */
    const double t24 = t15*t23; /* 1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n)*omega_tau*(I3/(m*R) + e) */
    const double t25 = JLT_FMA(x[2], t20, x[1]); /* V = omega_tau*e + v_nu */
    const double t26 = JLT_FMA(t6, t25, t24); /* omega_n*I3/(R^2*I1)*b*V + t24 */
    const double t27 = t11*t26; /* b*D/I1*1/(Theta/(m*R^2*I1)*b*D/I1)*(omega_n*I3/(R^2*I1)*b*V + t24) */
    const double t28 = JLT_FMS(x[3], t21, t27); /* omega_n*omega_tau*gamma3 - t27 */
    out[3] = t28;
    const double t29 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t29;
    const double t30 = p[9]*t21; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t31 = t29*t30; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t32 = JLT_FNMA(p[12], t0, t31); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s*s */
    const double t33 = x[4]*t21; /* s*omega_tau*gamma3 */
    const double t34 = -t33; /* -s*omega_tau*gamma3 */
    out[4] = t34;
    const double t35 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t36 = JLT_FNMA(p[1], t15, t35); /* omega_n*gamma3 - R*1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t37 = JLT_FNMA(x[3], t36, t32); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s*s - omega_n*t36 */
    const double t38 = t16*t37; /* b*1/(b*(D/I1))*t37 */
    out[2] = t38;
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
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t6 = JLT_FMA(t0, p[9], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t7 = p[14] + x[0]; /* b/R = a3/R + gamma3 */
    const double t8 = t7*p[15]; /* b/R*I3/I1 */
    const double t9 = t0 + p[10]; /* s*s + I3/(m*R^2) */
    const double t10 = JLT_FMA(t7, t8, t9); /* Theta/(m*R^2*I1) = b/R*b/R*I3/I1 + s*s + I3/(m*R^2) */
    const double t11 = t6*t7; /* D/I1*b/R */
    const double t12 = t10*t11; /* Theta/(m*R^2*I1)*D/I1*b/R */
    const double t13 = 1.0/t12; /* 1/(Theta/(m*R^2*I1)*D/I1*b/R) */
    const double t14 = t10*t13; /* 1/((b/R)*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*b/R) */
    const double t15 = t6*t14; /* 1/(b/R) = D/I1*1/((b/R)*(D/I1)) */
    const double t16 = t5*t15; /* (G_level/(R*I1) - s*omega_n)*1/(b/R) */
    const double t17 = x[3]*t15; /* omega_n*1/(b/R) */
    const double t18 = x[4]*t17; /* s*omega_n*1/(b/R) */
    const double t19 = p[16]*t18; /* R*I1/I3*s*omega_n*1/(b/R) */
    const double t20 = JLT_FMA(t16, t19, t4); /* (G_level/(R*I1) - s*omega_n)*1/(b/R)*R*I1/I3*s*omega_n*1/(b/R) + R*omega_n*omega_n */
    out[5] = t20;
    const double t21 = x[3]*t7; /* omega_n*b/R */
    const double t22 = p[17]*t21; /* 2*R*omega_n*b/R */
    const double t23 = t16*p[18]; /* (G_level/(R*I1) - s*omega_n)*1/(b/R)*I1/I3 */
    const double t24 = JLT_FNMA(p[1], t23, t19); /* R*I1/I3*s*omega_n*1/(b/R) - R*(G_level/(R*I1) - s*omega_n)*1/(b/R)*I1/I3 */
    const double t25 = JLT_FMA(x[4], t24, t22); /* s*t24 + 2*R*omega_n*b/R */
    out[8] = t25;
    const double t26 = x[3]*t24; /* omega_n*t24 */
    out[9] = t26;
    const double t27 = t1*p[9]; /* s*omega_tau*m*a3^2/I1 */
    const double t28 = JLT_FMS(t1, t27, t3); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n */
    const double t29 = t7*t14; /* 1/(D/I1) = b/R*1/((b/R)*(D/I1)) */
    const double t30 = t28*t29; /* (s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n)*1/(D/I1) */
    const double t31 = x[4]*t29; /* s*1/(D/I1) */
    const double t32 = t16*t17; /* (G_level/(R*I1) - s*omega_n)*1/(b/R)*omega_n*1/(b/R) */
    const double t33 = JLT_FNMA(t31, t32, t30); /* t30 - s*1/(D/I1)*(G_level/(R*I1) - s*omega_n)*1/(b/R)*omega_n*1/(b/R) */
    out[10] = t33;
    const double t34 = x[0]*p[19]; /* gamma3*2*m*a3^2/I1 */
    const double t35 = t1*t34; /* s*omega_tau*gamma3*2*m*a3^2/I1 */
    const double t36 = t31*t35; /* s*1/(D/I1)*s*omega_tau*gamma3*2*m*a3^2/I1 */
    out[12] = t36;
    const double t37 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t38 = 2.0*t37; /* 2*omega_n*gamma3 */
    const double t39 = t29*t38; /* 1/(D/I1)*2*omega_n*gamma3 */
    const double t40 = p[15]*t23; /* I3/I1*(G_level/(R*I1) - s*omega_n)*1/(b/R)*I1/I3 */
    const double t41 = t40 - t18; /* I3/I1*(G_level/(R*I1) - s*omega_n)*1/(b/R)*I1/I3 - s*omega_n*1/(b/R) */
    const double t42 = JLT_FMS(t31, t41, t39); /* s*1/(D/I1)*t41 - 1/(D/I1)*2*omega_n*gamma3 */
    out[13] = t42;
    const double t43 = x[2]*t35; /* omega_tau*s*omega_tau*gamma3*2*m*a3^2/I1 */
    const double t44 = JLT_FMA(x[3], t40, t43); /* omega_n*I3/I1*(G_level/(R*I1) - s*omega_n)*1/(b/R)*I1/I3 + omega_tau*s*omega_tau*gamma3*2*m*a3^2/I1 */
    const double t45 = t29*t44; /* 1/(D/I1)*t44 */
    const double t46 = x[4]*p[20]; /* s*2*m^2*g*a3^3/I1^2 */
    const double t47 = t31*p[22]; /* s*1/(D/I1)*2*m*a3^2*I3/I1^2 */
    const double t48 = JLT_FMA(t23, t47, t17); /* (G_level/(R*I1) - s*omega_n)*1/(b/R)*I1/I3*s*1/(D/I1)*2*m*a3^2*I3/I1^2 + omega_n*1/(b/R) */
    const double t49 = JLT_FMS(t31, t46, p[21]); /* s*1/(D/I1)*s*2*m^2*g*a3^3/I1^2 - 2*m*g*a3/I1 */
    const double t50 = JLT_FNMA(t30, t34, t49); /* s*1/(D/I1)*s*2*m^2*g*a3^3/I1^2 - 2*m*g*a3/I1 - t30*gamma3*2*m*a3^2/I1 */
    const double t51 = JLT_FNMA(x[3], t48, t50); /* t50 - omega_n*t48 */
    const double t52 = JLT_FMA(t31, t51, t45); /* s*1/(D/I1)*(t50 - omega_n*t48) + 1/(D/I1)*t44 */
    out[14] = t52;
    const double t53 = t11*t13; /* 1/(Theta/(m*R^2*I1)) = D/I1*b/R*1/(Theta/(m*R^2*I1)*D/I1*b/R) */
    const double t54 = t21*t53; /* omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t55 = x[2]*t54; /* omega_tau*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t56 = t23*t53; /* (G_level/(R*I1) - s*omega_n)*1/(b/R)*I1/I3*1/(Theta/(m*R^2*I1)) */
    const double t57 = JLT_FMA(t1, t56, t55); /* s*omega_tau*t56 + omega_tau*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t58 = p[24]*x[1]; /* 1/R*v_nu */
    const double t59 = JLT_FMA(p[14], x[0], 1.0); /* e/R = a3/R*gamma3 + 1 */
    const double t60 = JLT_FMA(x[2], t59, t58); /* V/R = omega_tau*e/R + 1/R*v_nu */
    const double t61 = t53*t60; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t62 = JLT_FNMA(p[15], t61, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t63 = x[3]*t62; /* omega_n*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    const double t64 = p[10] + t59; /* I3/(m*R^2) + e/R */
    const double t65 = t53*t64; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t66 = t1*t65; /* s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t67 = t56*t66; /* t56*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t68 = JLT_FMA(t54, t61, t67); /* omega_n*b/R*1/(Theta/(m*R^2*I1))*1/(Theta/(m*R^2*I1))*V/R + t56*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t69 = t7*p[25]; /* b/R*2*I3^2/I1^2 */
    const double t70 = t15*t66; /* 1/(b/R)*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t71 = JLT_FMA(t16, t70, t63); /* (G_level/(R*I1) - s*omega_n)*1/(b/R)*1/(b/R)*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) + omega_n*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    const double t72 = JLT_FNMA(p[23], t57, t71); /* t71 - a3*I3/(R*I1)*(s*omega_tau*t56 + omega_tau*omega_n*b/R*1/(Theta/(m*R^2*I1))) */
    const double t73 = JLT_FMA(t68, t69, t72); /* t68*b/R*2*I3^2/I1^2 + t72 */
    out[15] = t73;
    const double t74 = t54*p[26]; /* omega_n*b/R*1/(Theta/(m*R^2*I1))*(-I3/(R*I1)) */
    out[16] = t74;
    const double t75 = p[15]*t59; /* I3/I1*e/R */
    const double t76 = t40*t65; /* I3/I1*(G_level/(R*I1) - s*omega_n)*1/(b/R)*I1/I3*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t77 = JLT_FNMA(t54, t75, t37); /* omega_n*gamma3 - omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/I1*e/R */
    const double t78 = JLT_FNMA(x[4], t76, t77); /* omega_n*gamma3 - omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/I1*e/R - s*t76 */
    out[17] = t78;
    const double t79 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t80 = JLT_FNMA(t8, t61, t79); /* omega_tau*gamma3 - b/R*I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t81 = JLT_FMA(x[4], t70, t80); /* s*1/(b/R)*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) + omega_tau*gamma3 - b/R*I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    out[18] = t81;
    const double t82 = x[4]*p[27]; /* s*2*I3/I1 */
    const double t83 = x[2]*t76; /* omega_tau*t76 */
    const double t84 = JLT_FMS(t17, t66, t83); /* omega_n*1/(b/R)*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) - omega_tau*t76 */
    const double t85 = JLT_FMA(t68, t82, t84); /* t68*s*2*I3/I1 + t84 */
    out[19] = t85;
    const double t86 = -t1; /* -s*omega_tau */
    out[20] = t86;
    const double t87 = x[4]*x[0]; /* s*gamma3 */
    const double t88 = -t87; /* -s*gamma3 */
    out[22] = t88;
    const double t89 = -t79; /* -omega_tau*gamma3 */
    out[24] = t89;
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
    const double t0 = p[14] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = x[4]*x[4]; /* s*s */
    out[7] = t1;
    const double t2 = JLT_FMA(p[9], t1, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t3 = p[10] + t1; /* I3/(m*R^2) + s*s */
    const double t4 = p[15]*t0; /* I3/I1*b/R */
    const double t5 = JLT_FMA(t0, t4, t3); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + I3/(m*R^2) + s*s */
    const double t6 = t0*t2; /* b/R*D/I1 */
    const double t7 = t5*t6; /* Theta/(m*R^2*I1)*b/R*D/I1 */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*b/R*D/I1) */
    const double t9 = t5*t8; /* 1/((b/R)*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*b/R*D/I1) */
    const double t10 = t6*t8; /* 1/(Theta/(m*R^2*I1)) = b/R*D/I1*1/(Theta/(m*R^2*I1)*b/R*D/I1) */
    const double t11 = t2*t9; /* 1/(b/R) = D/I1*1/((b/R)*(D/I1)) */
    const double t12 = t0*t9; /* 1/(D/I1) = b/R*1/((b/R)*(D/I1)) */
    const double t13 = x[4]*x[2]; /* s*omega_tau */
    const double t14 = x[4]*t13; /* s*s*omega_tau */
    out[0] = t14;
    const double t15 = 2.0*t13; /* 2*s*omega_tau */
    out[9] = t15;
    const double t16 = -t13; /* -s*omega_tau */
    out[25] = t16;
    const double t17 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t18 = JLT_FMA(p[14], x[0], 1.0); /* e/R = a3/R*gamma3 + 1 */
    const double t19 = x[2]*p[1]; /* omega_tau*R */
    const double t20 = JLT_FMA(t18, t19, x[1]); /* V = e/R*omega_tau*R + v_nu */
    const double t21 = x[3]*x[3]; /* omega_n*omega_n */
    const double t22 = t11*t17; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t23 = p[27]*t17; /* 2*I3/I1*(G_level/(R*I1) - s*omega_n) */
    const double t24 = p[9]*t13; /* m*a3^2/I1*s*omega_tau */
    const double t25 = JLT_FMS(t13, t24, t21); /* s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n */
    const double t26 = t12*t25; /* 1/(D/I1)*(s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n) */
    const double t27 = p[1]*t21; /* R*omega_n*omega_n */
    const double t28 = p[10] + t18; /* I3/(m*R^2) + e/R */
    const double t29 = p[15]*t18; /* I3/I1*e/R */
    const double t30 = x[3]*t22; /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t31 = x[4]*t12; /* s*1/(D/I1) */
    const double t32 = t0*t10; /* b/R*1/(Theta/(m*R^2*I1)) */
    const double t33 = t10*t28; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t34 = t23*t33; /* 2*I3/I1*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t35 = JLT_FNMA(t11, t28, p[14]); /* a3/R - 1/(b/R)*(I3/(m*R^2) + e/R) */
    const double t36 = JLT_FNMA(t22, t35, t34); /* t34 - 1/(b/R)*(G_level/(R*I1) - s*omega_n)*(a3/R - 1/(b/R)*(I3/(m*R^2) + e/R)) */
    const double t37 = x[4]*t11; /* s*1/(b/R) */
    const double t38 = x[0]*x[3]; /* gamma3*omega_n */
    const double t39 = p[29]*t20; /* 2*I3^2/(R*I1^2)*V */
    const double t40 = p[28]*t20; /* I3/(R*I1)*V */
    const double t41 = t32*t39; /* b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2)*V */
    const double t42 = t30*t31; /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(D/I1) */
    const double t43 = JLT_FNMA(t11, t42, t26); /* t26 - 1/(b/R)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(D/I1) */
    out[15] = t43;
    const double t44 = JLT_FMA(x[0], t26, t42); /* gamma3*t26 + omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(D/I1) */
    const double t45 = x[4]*t31; /* s*s*1/(D/I1) */
    const double t46 = JLT_FNMA(p[12], t45, t44); /* t44 - m*g*a3/I1*s*s*1/(D/I1) */
    out[2] = t46;
    const double t47 = x[3]*t32; /* omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t48 = t41*t47; /* b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2)*V*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t49 = JLT_FNMA(t29, t47, t38); /* gamma3*omega_n - I3/I1*e/R*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t50 = 2.0*t38; /* 2*gamma3*omega_n */
    const double t51 = t12*t50; /* 1/(D/I1)*2*gamma3*omega_n */
    const double t52 = p[26]*t47; /* (-I3/(R*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    out[21] = t52;
    const double t53 = JLT_FMS(x[3], t37, t22); /* omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t54 = JLT_FMA(t31, t53, t51); /* s*1/(D/I1)*(omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n)) + 1/(D/I1)*2*gamma3*omega_n */
    const double t55 = -t54; /* -t54 */
    out[18] = t55;
    const double t56 = p[21]*t31; /* 2*m*g*a3/I1*s*1/(D/I1) */
    const double t57 = p[20]*t31; /* 2*m^2*g*a3^3/I1^2*s*1/(D/I1) */
    const double t58 = JLT_FMS(t45, t57, t56); /* s*s*1/(D/I1)*2*m^2*g*a3^3/I1^2*s*1/(D/I1) - 2*m*g*a3/I1*s*1/(D/I1) */
    const double t59 = p[19]*t31; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t60 = JLT_FNMA(t44, t59, t58); /* t58 - t44*2*m*a3^2/I1*s*1/(D/I1) */
    const double t61 = x[4]*p[16]; /* s*R*I1/I3 */
    const double t62 = t30*t61; /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*R*I1/I3 */
    const double t63 = JLT_FMA(t11, t62, t27); /* 1/(b/R)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*R*I1/I3 + R*omega_n*omega_n */
    out[10] = t63;
    const double t64 = JLT_FMS(t0, t27, t62); /* b/R*R*omega_n*omega_n - omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*R*I1/I3 */
    out[1] = t64;
    const double t65 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t66 = JLT_FNMA(t32, t40, t65); /* omega_tau*gamma3 - b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t67 = -t65; /* -omega_tau*gamma3 */
    out[29] = t67;
    const double t68 = t40*t47; /* I3/(R*I1)*V*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t69 = x[3]*t40; /* omega_n*I3/(R*I1)*V */
    const double t70 = JLT_FNMA(t13, t36, t69); /* omega_n*I3/(R*I1)*V - s*omega_tau*t36 */
    const double t71 = JLT_FNMA(p[23], t47, x[3]); /* omega_n - a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t72 = JLT_FMA(x[2], t71, t48); /* omega_tau*(omega_n - a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1))) + t48 */
    const double t73 = JLT_FNMA(t10, t70, t72); /* t72 - 1/(Theta/(m*R^2*I1))*(omega_n*I3/(R*I1)*V - s*omega_tau*t36) */
    out[20] = t73;
    const double t74 = t13*t33; /* s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t75 = JLT_FMA(t37, t74, t66); /* s*1/(b/R)*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) + omega_tau*gamma3 - b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    out[23] = t75;
    const double t76 = JLT_FMA(t22, t74, t68); /* 1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) + I3/(R*I1)*V*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t77 = JLT_FMS(x[3], t65, t76); /* omega_n*omega_tau*gamma3 - t76 */
    out[3] = t77;
    const double t78 = x[3]*p[17]; /* omega_n*2*R */
    const double t79 = t0*t78; /* b/R*omega_n*2*R */
    const double t80 = JLT_FMA(t53, t61, t79); /* (omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n))*s*R*I1/I3 + b/R*omega_n*2*R */
    out[13] = t80;
    const double t81 = x[3]*t53; /* omega_n*(omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n)) */
    const double t82 = p[16]*t81; /* R*I1/I3*t81 */
    out[14] = t82;
    const double t83 = p[19]*t13; /* 2*m*a3^2/I1*s*omega_tau */
    const double t84 = JLT_FMS(t65, t83, t81); /* omega_tau*gamma3*2*m*a3^2/I1*s*omega_tau - t81 */
    const double t85 = JLT_FMA(t12, t84, t60); /* 1/(D/I1)*(omega_tau*gamma3*2*m*a3^2/I1*s*omega_tau - t81) + t58 - t44*2*m*a3^2/I1*s*1/(D/I1) */
    out[19] = t85;
    const double t86 = x[0]*t13; /* gamma3*s*omega_tau */
    const double t87 = t59*t86; /* 2*m*a3^2/I1*s*1/(D/I1)*gamma3*s*omega_tau */
    out[17] = t87;
    const double t88 = -t86; /* -gamma3*s*omega_tau */
    out[4] = t88;
    const double t89 = x[2]*t33; /* omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t90 = t53*t89; /* (omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n))*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t91 = x[4]*t33; /* s*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t92 = JLT_FNMA(t22, t91, t49); /* gamma3*omega_n - I3/I1*e/R*omega_n*b/R*1/(Theta/(m*R^2*I1)) - 1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    out[22] = t92;
    const double t93 = x[4]*2.0; /* s*2 */
    const double t94 = t10*t93; /* 1/(Theta/(m*R^2*I1))*s*2 */
    const double t95 = JLT_FMA(t76, t94, t90); /* t76*1/(Theta/(m*R^2*I1))*s*2 + t90 */
    out[24] = t95;
    const double t96 = x[4]*x[0]; /* s*gamma3 */
    const double t97 = -t96; /* -s*gamma3 */
    out[27] = t97;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = JLT_FMA(p[30], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t3 = t0*p[11]; /* b*I3/(R^2*I1) */
    const double t4 = t1 + p[10]; /* s*s + I3/(m*R^2) */
    const double t5 = JLT_FMA(t0, t3, t4); /* Theta/(m*R^2*I1) = b*b*I3/(R^2*I1) + s*s + I3/(m*R^2) */
    const double t6 = t2*t5; /* D*Theta/(m*R^2*I1) */
    const double t7 = t0*t6; /* b*D*Theta/(m*R^2*I1) */
    const double t8 = 1.0/t7; /* 1/(b*D*Theta/(m*R^2*I1)) */
    const double t9 = t1*x[2]; /* s*s*omega_tau */
    const double t10 = x[0]*p[31]; /* gamma3*2*m*a3^2 */
    const double t11 = t9*t10; /* s*s*omega_tau*gamma3*2*m*a3^2 */
    const double t12 = t5*t11; /* Theta/(m*R^2*I1)*s*s*omega_tau*gamma3*2*m*a3^2 */
    const double t13 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t14 = JLT_FMA(x[2], t13, x[1]); /* V = omega_tau*e + v_nu */
    const double t15 = t3*t14; /* b*I3/(R^2*I1)*V */
    const double t16 = t13 + p[13]; /* e + I3/(m*R) */
    const double t17 = t9*t16; /* s*s*omega_tau*(e + I3/(m*R)) */
    const double t18 = t6*t17; /* D*Theta/(m*R^2*I1)*s*s*omega_tau*(e + I3/(m*R)) */
    const double t19 = JLT_FNMA(t8, t18, t15); /* b*I3/(R^2*I1)*V - 1/(b*D*Theta/(m*R^2*I1))*D*Theta/(m*R^2*I1)*s*s*omega_tau*(e + I3/(m*R)) */
    const double t20 = JLT_FNMA(t2, t19, t12); /* Theta/(m*R^2*I1)*s*s*omega_tau*gamma3*2*m*a3^2 - D*t19 */
    const double t21 = t0*t8; /* b*1/(b*D*Theta/(m*R^2*I1)) */
    const double t22 = t20*t21; /* (Theta/(m*R^2*I1)*s*s*omega_tau*gamma3*2*m*a3^2 - D*t19)*b*1/(b*D*Theta/(m*R^2*I1)) */
    out[0] = t22;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t1 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t2 = t1/t0; /* (G_level/(R*I1) - s*omega_n)/b */
    const double t3 = x[3]*t0; /* omega_n*b */
    const double t4 = p[33]*x[0]; /* 2*g*a3*gamma3 */
    const double t5 = JLT_FMA(x[1], x[1], t4); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t6 = p[30]*x[4]; /* m*a3^2*s */
    const double t7 = JLT_FMA(x[4], t6, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t8 = p[34]*x[2]; /* 1/m*omega_tau */
    const double t9 = x[2]*t8; /* omega_tau*1/m*omega_tau */
    const double t10 = p[35]*x[3]; /* I1/m*omega_n */
    const double t11 = JLT_FMA(x[3], t10, t5); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(t7, t9, t11); /* D*omega_tau*1/m*omega_tau + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[36]*t2; /* R^2*I1^2/(m*I3)*(G_level/(R*I1) - s*omega_n)/b */
    const double t14 = JLT_FMA(t2, t13, t12); /* (G_level/(R*I1) - s*omega_n)/b*R^2*I1^2/(m*I3)*(G_level/(R*I1) - s*omega_n)/b + t12 */
    const double t15 = x[4]*p[7]; /* s*R^2*I1/I3 */
    const double t16 = JLT_FNMA(t2, t15, t3); /* v_tau = omega_n*b - (G_level/(R*I1) - s*omega_n)/b*s*R^2*I1/I3 */
    const double t17 = JLT_FMA(t16, t16, t14); /* energy/(1/2*m) = v_tau*v_tau + t14 */
    const double t18 = p[32]*t17; /* 1/2*m*energy/(1/2*m) */
    out[0] = t18;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = 1.0/t1; /* 1/b */
    const double t3 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t4 = t2*t3; /* 1/b*(G_level/(R*I1) - omega_n*s) */
    const double t5 = x[3]*t1; /* omega_n*b */
    const double t6 = p[7]*x[4]; /* R^2*I1/I3*s */
    const double t7 = JLT_FNMA(t4, t6, t5); /* v_tau = omega_n*b - 1/b*(G_level/(R*I1) - omega_n*s)*R^2*I1/I3*s */
    const double t8 = t2*t4; /* 1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t9 = t2*t6; /* 1/b*R^2*I1/I3*s */
    const double t10 = JLT_FMA(t6, t8, x[3]); /* d(v_tau)/d(gamma3)/R = R^2*I1/I3*s*1/b*1/b*(G_level/(R*I1) - omega_n*s) + omega_n */
    const double t11 = JLT_FMA(x[4], t9, t1); /* d(v_tau)/d(omega_n) = s*1/b*R^2*I1/I3*s + b */
    const double t12 = x[4]*p[30]; /* s*m*a3^2 */
    const double t13 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t14 = t12*t13; /* s*m*a3^2*omega_tau*omega_tau */
    const double t15 = JLT_FMA(x[4], t12, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t16 = x[2]*t15; /* omega_tau*D */
    out[2] = t16;
    const double t17 = p[39]*t4; /* R^3*I1^2/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t18 = p[7]*t4; /* R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t19 = JLT_FMS(x[3], t9, t18); /* d(v_tau)/d(s) = omega_n*1/b*R^2*I1/I3*s - R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t20 = JLT_FNMA(t8, t17, p[37]); /* m*g*a3 - 1/b*1/b*(G_level/(R*I1) - omega_n*s)*R^3*I1^2/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t21 = p[40]*t8; /* R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t22 = JLT_FNMA(x[3], t21, t14); /* s*m*a3^2*omega_tau*omega_tau - omega_n*R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t23 = x[3]*p[4]; /* omega_n*I1 */
    const double t24 = JLT_FNMA(x[4], t21, t23); /* omega_n*I1 - s*R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t25 = p[38]*t7; /* m*R*v_tau */
    const double t26 = JLT_FMA(t10, t25, t20); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R*v_tau + t20 */
    out[0] = t26;
    const double t27 = p[0]*t7; /* m*v_tau */
    const double t28 = JLT_FMA(t11, t27, t24); /* d(energy)/d(omega_n) = d(v_tau)/d(omega_n)*m*v_tau + t24 */
    out[3] = t28;
    const double t29 = JLT_FMA(t19, t27, t22); /* d(energy)/d(s) = d(v_tau)/d(s)*m*v_tau + t22 */
    out[4] = t29;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[14] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t2 = p[41]*t1; /* (-I1/I3)*(G_level/(R*I1) - omega_n*s) */
    const double t3 = t2/t0; /* (-I1/I3)*(G_level/(R*I1) - omega_n*s)/(b/R) */
    out[0] = t3;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
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
        t18[k] = jlt_jet_product(x4, x4, k);
        t19[k] = (k == 0 ? p[16] : 0) + x0[k];
        t20[k] = p[9]*t18[k] + (k == 0 ? 1.0 : 0);
        t21[k] = p[15]*t19[k];
        t22[k] = (k == 0 ? p[10] : 0) + t18[k];
        t23[k] = jlt_jet_product(t19, t21, k) + t22[k];
        t24[k] = jlt_jet_product(t19, t20, k);
        t25[k] = jlt_jet_product(t23, t24, k);
        t26[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t25, t26, k);
        t27[k] = jlt_jet_product(t23, t26, k);
        t28[k] = p[24]*t24[k];
        t29[k] = jlt_jet_product(t26, t28, k);
        t30[k] = (k == 0 ? p[8] : 0) - jlt_jet_product(x4, x3, k);
        t31[k] = jlt_jet_product(x4, t30, k);
        t32[k] = jlt_jet_product(t20, t31, k);
        t33[k] = jlt_jet_product(t27, t32, k);
        t34[k] = jlt_jet_product(t19, t27, k);
        t35[k] = jlt_jet_product(x3, t19, k);
        t36[k] = jlt_jet_product(x2, x0, k);
        t37[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t38[k] = jlt_jet_product(x2, t18, k);
        t39[k] = p[9]*t36[k];
        t40[k] = jlt_jet_product(t38, t39, k);
        t41[k] = t40[k] - p[12]*t18[k];
        t42[k] = (k == 0 ? p[13] : 0) + t37[k];
        t43[k] = jlt_jet_product(x2, t42, k);
        t44[k] = jlt_jet_product(x2, t37, k) + x1[k];
        t45[k] = p[14]*t33[k];
        t46[k] = jlt_jet_product(x3, x0, k) - t33[k];
        t47[k] = t41[k] - jlt_jet_product(x3, t46, k);
        t48[k] = jlt_jet_product(t34, t47, k);
        t49[k] = jlt_jet_product(t43, t45, k);
        t50[k] = jlt_jet_product(t35, t44, k) + t49[k];
        t51[k] = t45[k] - t35[k];
        t52[k] = p[40]*x3[k];
        t53[k] = jlt_jet_product(t51, t52, k);
        t54[k] = jlt_jet_product(x3, t36, k);
        t55[k] = t54[k] - jlt_jet_product(t29, t50, k);
        t56[k] = jlt_jet_product(x4, t36, k);
        t57[k] = -t56[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t38[k]/(k + 1);
        next[1] = x1[k + 1] = t53[k]/(k + 1);
        next[2] = x2[k + 1] = t48[k]/(k + 1);
        next[3] = x3[k + 1] = t55[k]/(k + 1);
        next[4] = x4[k + 1] = t57[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double v_I3 = params[5];
    const double v_G_level = params[6];
    const double v_I1 = params[4];
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 42,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 23, 12, 1, 0, 0, 11, 9 }, { 15, 62, 0, 8, 0, 0, 10, 8 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 25, { 7, 53, 29, 1, 0, 0, 14, 20 }, { 51, 305, 0, 41, 0, 0, 16, 10 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 8, 58, 31, 1, 0, 0, 13, 23 }, { 59, 347, 0, 48, 0, 0, 16, 11 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 2, 13, 7, 1, 0, 0, 9, 10 }, { 9, 40, 0, 4, 0, 0, 10, 7 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 1, { 0, 9, 9, 1, 0, 0, 7, 7 }, { 9, 30, 0, 1, 0, 0, 12, 5 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 5, { 0, 16, 13, 1, 0, 0, 7, 9 }, { 15, 60, 0, 7, 0, 0, 12, 10 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 1, 1, 1, 1, 0, 0, 3, 3 }, { 2, 5, 0, 1, 0, 0, 5, 3 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx512,
    },
};
