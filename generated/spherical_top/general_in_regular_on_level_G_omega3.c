/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23   12    1    0    0     10   10   (85)
 *  jacobian            9   56   27    1    0    0     13   18   (397)
 *  rhs_jacobian        9   61   32    1    0    0     13   27   (454)
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
    out[28] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[9] = t7;
    const double t8 = t0*params[0]; /* R*R*m */
    const double t9 = params[5]/t8; /* I3/(R*R*m) */
    out[10] = t9;
    const double t10 = params[5]/t1; /* I3/(R*R*I1) */
    out[11] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[3]*t11; /* a3*m*g */
    out[35] = t12;
    const double t13 = t12/params[4]; /* a3*m*g/I1 */
    out[12] = t13;
    const double t14 = params[1]*params[0]; /* R*m */
    out[36] = t14;
    const double t15 = params[5]/t14; /* I3/(R*m) */
    out[13] = t15;
    const double t16 = params[4]/params[5]; /* I1/I3 */
    out[14] = t16;
    const double t17 = params[5]/params[4]; /* I3/I1 */
    out[15] = t17;
    const double t18 = params[3]/params[1]; /* a3/R */
    out[16] = t18;
    const double t19 = params[1]*2.0; /* R*2 */
    out[17] = t19;
    const double t20 = t3/params[5]; /* R*I1/I3 */
    out[18] = t20;
    const double t21 = params[0]*2.0; /* m*2 */
    const double t22 = t5*t21; /* a3*a3*m*2 */
    out[29] = t22;
    const double t23 = t22/params[4]; /* a3*a3*m*2/I1 */
    out[19] = t23;
    const double t24 = params[2]*t21; /* g*m*2 */
    const double t25 = params[3]*t24; /* a3*g*m*2 */
    const double t26 = t25/params[4]; /* a3*g*m*2/I1 */
    out[20] = t26;
    const double t27 = params[0]*params[0]; /* m*m */
    const double t28 = 2.0*t27; /* 2*m*m */
    const double t29 = params[2]*t28; /* g*2*m*m */
    const double t30 = params[3]*t5; /* a3*a3*a3 */
    const double t31 = t29*t30; /* g*2*m*m*a3*a3*a3 */
    const double t32 = params[4]*params[4]; /* I1*I1 */
    const double t33 = t31/t32; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    out[21] = t33;
    const double t34 = params[5]*2.0; /* I3*2 */
    const double t35 = t34/params[4]; /* I3*2/I1 */
    out[22] = t35;
    const double t36 = params[5]*params[3]; /* I3*a3 */
    const double t37 = t36/t3; /* I3*a3/(R*I1) */
    out[23] = t37;
    const double t38 = params[5]/t3; /* I3/(R*I1) */
    out[24] = t38;
    const double t39 = params[1]*t32; /* R*I1*I1 */
    const double t40 = params[5]*params[5]; /* I3*I3 */
    const double t41 = 2.0*t40; /* 2*I3*I3 */
    const double t42 = t41/t39; /* 2*I3*I3/(R*I1*I1) */
    out[25] = t42;
    const double t43 = -t38; /* -I3/(R*I1) */
    out[26] = t43;
    const double t44 = t5*t5; /* a3*a3*a3*a3 */
    const double t45 = t28*t44; /* 2*m*m*a3*a3*a3*a3 */
    const double t46 = t45/t32; /* 2*m*m*a3*a3*a3*a3/(I1*I1) */
    out[27] = t46;
    const double t47 = params[0]/2.0; /* m/2 */
    out[30] = t47;
    const double t48 = params[2]*2.0; /* g*2 */
    const double t49 = params[3]*t48; /* a3*g*2 */
    out[31] = t49;
    const double t50 = 1.0/params[0]; /* 1/m */
    out[32] = t50;
    const double t51 = params[4]/params[0]; /* I1/m */
    out[33] = t51;
    const double t52 = t0*t32; /* R*R*I1*I1 */
    const double t53 = params[5]*params[0]; /* I3*m */
    const double t54 = t52/t53; /* R*R*I1*I1/(I3*m) */
    out[34] = t54;
    const double t55 = params[1]*t0; /* R*R*R */
    const double t56 = t32*t55; /* I1*I1*R*R*R */
    const double t57 = t56/params[5]; /* I1*I1*R*R*R/I3 */
    out[37] = t57;
    const double t58 = t52/params[5]; /* R*R*I1*I1/I3 */
    out[38] = t58;
    const double t59 = -t16; /* -I1/I3 */
    out[39] = t59;
    const double t60 = -params[1]; /* -R */
    out[40] = t60;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = JLT_FMA(p[9], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t3 = p[11]*t1; /* I3/(R^2*I1)*b */
    const double t4 = p[10] + t0; /* I3/(m*R^2) + s*s */
    const double t5 = JLT_FMA(t1, t3, t4); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s*s */
    const double t6 = t1*t2; /* b*D/I1 */
    const double t7 = t5*t6; /* Theta/(m*R^2*I1)*b*D/I1 */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*b*D/I1) */
    const double t9 = t5*t8; /* 1/(b*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*b*D/I1) */
    const double t10 = t6*t8; /* b*D/I1*1/(Theta/(m*R^2*I1)*b*D/I1) */
    const double t11 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t12 = x[4]*t11; /* s*(G_level/(R*I1) - s*omega_n) */
    const double t13 = t2*t12; /* D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t14 = t9*t13; /* 1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t15 = t1*t9; /* b*1/(b*(D/I1)) */
    const double t16 = x[3]*t1; /* omega_n*b */
    const double t17 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t18 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t19 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t19;
    const double t20 = p[9]*t17; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t21 = t19*t20; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t22 = JLT_FNMA(p[12], t0, t21); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s*s */
    const double t23 = p[13] + t18; /* I3/(m*R) + e */
    const double t24 = x[2]*t23; /* omega_tau*(I3/(m*R) + e) */
    const double t25 = t14*t24; /* 1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n)*omega_tau*(I3/(m*R) + e) */
    const double t26 = JLT_FMA(x[2], t18, x[1]); /* V = omega_tau*e + v_nu */
    const double t27 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t28 = JLT_FNMA(p[1], t14, t27); /* omega_n*gamma3 - R*1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t29 = JLT_FNMA(x[3], t28, t22); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s*s - omega_n*t28 */
    const double t30 = t15*t29; /* b*1/(b*(D/I1))*t29 */
    out[2] = t30;
    const double t31 = JLT_FNMA(p[7], t14, t16); /* omega_n*b - R^2*I1/I3*1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t32 = x[3]*t31; /* omega_n*t31 */
    out[1] = t32;
    const double t33 = p[11]*t16; /* I3/(R^2*I1)*omega_n*b */
    const double t34 = JLT_FMA(t26, t33, t25); /* V*I3/(R^2*I1)*omega_n*b + t25 */
    const double t35 = x[3]*t17; /* omega_n*omega_tau*gamma3 */
    const double t36 = JLT_FNMA(t10, t34, t35); /* omega_n*omega_tau*gamma3 - b*D/I1*1/(Theta/(m*R^2*I1)*b*D/I1)*(V*I3/(R^2*I1)*omega_n*b + t25) */
    out[3] = t36;
    const double t37 = x[4]*t17; /* s*omega_tau*gamma3 */
    const double t38 = -t37; /* -s*omega_tau*gamma3 */
    out[4] = t38;
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
    const double t3 = JLT_FMA(t0, p[9], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t4 = p[16] + x[0]; /* b/R = a3/R + gamma3 */
    const double t5 = p[15]*t4; /* I3/I1*b/R */
    const double t6 = t0 + p[10]; /* s*s + I3/(m*R^2) */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + s*s + I3/(m*R^2) */
    const double t8 = t3*t4; /* D/I1*b/R */
    const double t9 = t7*t8; /* Theta/(m*R^2*I1)*D/I1*b/R */
    const double t10 = 1.0/t9; /* 1/(Theta/(m*R^2*I1)*D/I1*b/R) */
    const double t11 = t7*t10; /* 1/((b/R)*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*b/R) */
    const double t12 = t3*t11; /* 1/(b/R) = D/I1*1/((b/R)*(D/I1)) */
    const double t13 = x[4]*t12; /* s*1/(b/R) */
    const double t14 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t15 = t12*t14; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t16 = p[14]*t13; /* I1/I3*s*1/(b/R) */
    const double t17 = JLT_FMA(t15, t16, x[3]); /* 1/(b/R)*(G_level/(R*I1) - s*omega_n)*I1/I3*s*1/(b/R) + omega_n */
    const double t18 = p[1]*x[3]; /* R*omega_n */
    const double t19 = t17*t18; /* t17*R*omega_n */
    out[5] = t19;
    const double t20 = x[3]*t4; /* omega_n*b/R */
    const double t21 = p[17]*t20; /* 2*R*omega_n*b/R */
    const double t22 = JLT_FMS(x[3], t13, t15); /* omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t23 = p[18]*t22; /* R*I1/I3*(omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n)) */
    const double t24 = JLT_FMA(x[4], t23, t21); /* s*t23 + 2*R*omega_n*b/R */
    out[8] = t24;
    const double t25 = x[3]*t23; /* omega_n*t23 */
    out[9] = t25;
    const double t26 = t4*t11; /* 1/(D/I1) = b/R*1/((b/R)*(D/I1)) */
    const double t27 = x[4]*t26; /* s*1/(D/I1) */
    const double t28 = t15*t27; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(D/I1) */
    const double t29 = x[3]*t26; /* omega_n*1/(D/I1) */
    const double t30 = JLT_FMA(t12, t28, t29); /* 1/(b/R)*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(D/I1) + omega_n*1/(D/I1) */
    const double t31 = x[3]*t30; /* omega_n*t30 */
    const double t32 = t1*p[9]; /* s*omega_tau*m*a3^2/I1 */
    const double t33 = t27*t32; /* s*1/(D/I1)*s*omega_tau*m*a3^2/I1 */
    const double t34 = JLT_FMS(x[2], t33, t31); /* omega_tau*s*1/(D/I1)*s*omega_tau*m*a3^2/I1 - omega_n*t30 */
    out[10] = t34;
    const double t35 = t27*p[19]; /* s*1/(D/I1)*2*m*a3^2/I1 */
    const double t36 = t1*x[0]; /* s*omega_tau*gamma3 */
    const double t37 = t35*t36; /* s*1/(D/I1)*2*m*a3^2/I1*s*omega_tau*gamma3 */
    out[12] = t37;
    const double t38 = x[0]*t29; /* gamma3*omega_n*1/(D/I1) */
    const double t39 = 2.0*t38; /* 2*gamma3*omega_n*1/(D/I1) */
    const double t40 = JLT_FMA(t22, t27, t39); /* (omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n))*s*1/(D/I1) + 2*gamma3*omega_n*1/(D/I1) */
    const double t41 = -t40; /* -t40 */
    out[13] = t41;
    const double t42 = t27*p[20]; /* s*1/(D/I1)*2*m*g*a3/I1 */
    const double t43 = t38 - t28; /* gamma3*omega_n*1/(D/I1) - 1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(D/I1) */
    const double t44 = x[3]*t43; /* omega_n*t43 */
    const double t45 = x[2] - t33; /* omega_tau - s*1/(D/I1)*s*omega_tau*m*a3^2/I1 */
    const double t46 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t47 = JLT_FMA(t45, t46, t44); /* (omega_tau - s*1/(D/I1)*s*omega_tau*m*a3^2/I1)*omega_tau*gamma3 + omega_n*t43 */
    const double t48 = x[4]*p[21]; /* s*2*m^2*g*a3^3/I1^2 */
    const double t49 = t27*t48; /* s*1/(D/I1)*s*2*m^2*g*a3^3/I1^2 */
    const double t50 = JLT_FMS(t27, t49, t42); /* s*1/(D/I1)*s*1/(D/I1)*s*2*m^2*g*a3^3/I1^2 - s*1/(D/I1)*2*m*g*a3/I1 */
    const double t51 = JLT_FNMA(t22, t29, t50); /* t50 - (omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n))*omega_n*1/(D/I1) */
    const double t52 = JLT_FMA(t35, t47, t51); /* s*1/(D/I1)*2*m*a3^2/I1*t47 + t51 */
    out[14] = t52;
    const double t53 = t8*t10; /* 1/(Theta/(m*R^2*I1)) = D/I1*b/R*1/(Theta/(m*R^2*I1)*D/I1*b/R) */
    const double t54 = t1*t53; /* s*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t55 = JLT_FMA(p[16], x[0], 1.0); /* e/R = a3/R*gamma3 + 1 */
    const double t56 = p[10] + t55; /* I3/(m*R^2) + e/R */
    const double t57 = t53*t56; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t58 = t14*p[22]; /* (G_level/(R*I1) - s*omega_n)*2*I3/I1 */
    const double t59 = t57*t58; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R)*(G_level/(R*I1) - s*omega_n)*2*I3/I1 */
    const double t60 = JLT_FNMA(t12, t56, p[16]); /* a3/R - 1/(b/R)*(I3/(m*R^2) + e/R) */
    const double t61 = JLT_FNMA(t15, t60, t59); /* t59 - 1/(b/R)*(G_level/(R*I1) - s*omega_n)*(a3/R - 1/(b/R)*(I3/(m*R^2) + e/R)) */
    const double t62 = t20*t53; /* omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t63 = JLT_FNMA(p[23], t62, x[3]); /* omega_n - a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t64 = x[2]*p[1]; /* omega_tau*R */
    const double t65 = JLT_FMA(t55, t64, x[1]); /* V = e/R*omega_tau*R + v_nu */
    const double t66 = t53*t65; /* 1/(Theta/(m*R^2*I1))*V */
    const double t67 = p[24]*t66; /* I3/(R*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t68 = x[3]*t67; /* omega_n*I3/(R*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t69 = t4*p[25]; /* b/R*2*I3^2/(R*I1^2) */
    const double t70 = t66*t69; /* 1/(Theta/(m*R^2*I1))*V*b/R*2*I3^2/(R*I1^2) */
    const double t71 = JLT_FMS(t62, t70, t68); /* omega_n*b/R*1/(Theta/(m*R^2*I1))*1/(Theta/(m*R^2*I1))*V*b/R*2*I3^2/(R*I1^2) - omega_n*I3/(R*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t72 = JLT_FMA(x[2], t63, t71); /* omega_tau*(omega_n - a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1))) + t71 */
    const double t73 = JLT_FMA(t54, t61, t72); /* s*omega_tau*1/(Theta/(m*R^2*I1))*t61 + t72 */
    out[15] = t73;
    const double t74 = t62*p[26]; /* omega_n*b/R*1/(Theta/(m*R^2*I1))*(-I3/(R*I1)) */
    out[16] = t74;
    const double t75 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t76 = p[15]*t55; /* I3/I1*e/R */
    const double t77 = t15*t57; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t78 = JLT_FNMA(t62, t76, t75); /* omega_n*gamma3 - omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/I1*e/R */
    const double t79 = JLT_FNMA(x[4], t77, t78); /* omega_n*gamma3 - omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/I1*e/R - s*t77 */
    out[17] = t79;
    const double t80 = t54*t56; /* s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t81 = JLT_FNMA(t4, t67, t46); /* omega_tau*gamma3 - b/R*I3/(R*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t82 = JLT_FMA(t13, t80, t81); /* s*1/(b/R)*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) + omega_tau*gamma3 - b/R*I3/(R*I1)*1/(Theta/(m*R^2*I1))*V */
    out[18] = t82;
    const double t83 = x[2]*t57; /* omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t84 = t22*t83; /* (omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n))*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t85 = t54*t77; /* s*omega_tau*1/(Theta/(m*R^2*I1))*t77 */
    const double t86 = JLT_FMA(t62, t67, t85); /* omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*1/(Theta/(m*R^2*I1))*V + s*omega_tau*1/(Theta/(m*R^2*I1))*t77 */
    const double t87 = x[4]*2.0; /* s*2 */
    const double t88 = JLT_FMA(t86, t87, t84); /* t86*s*2 + t84 */
    out[19] = t88;
    const double t89 = -t1; /* -s*omega_tau */
    out[20] = t89;
    const double t90 = x[4]*x[0]; /* s*gamma3 */
    const double t91 = -t90; /* -s*gamma3 */
    out[22] = t91;
    const double t92 = -t46; /* -omega_tau*gamma3 */
    out[24] = t92;
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
    const double t0 = p[16] + x[0]; /* b/R = a3/R + gamma3 */
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
    const double t13 = JLT_FMA(p[16], x[0], 1.0); /* e/R = a3/R*gamma3 + 1 */
    const double t14 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t15 = p[10] + t13; /* I3/(m*R^2) + e/R */
    const double t16 = x[2]*p[1]; /* omega_tau*R */
    const double t17 = JLT_FMA(t13, t16, x[1]); /* V = e/R*omega_tau*R + v_nu */
    const double t18 = p[15]*t13; /* I3/I1*e/R */
    const double t19 = x[4]*x[2]; /* s*omega_tau */
    const double t20 = x[4]*t19; /* s*s*omega_tau */
    out[0] = t20;
    const double t21 = 2.0*t19; /* 2*s*omega_tau */
    out[9] = t21;
    const double t22 = -t19; /* -s*omega_tau */
    out[25] = t22;
    const double t23 = t11*t14; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t24 = p[22]*t14; /* 2*I3/I1*(G_level/(R*I1) - s*omega_n) */
    const double t25 = x[4]*t12; /* s*1/(D/I1) */
    const double t26 = t10*t15; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t27 = t24*t26; /* 2*I3/I1*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t28 = JLT_FNMA(p[16], t23, t27); /* t27 - a3/R*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t29 = x[3]*t0; /* omega_n*b/R */
    const double t30 = x[4]*t23; /* s*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t31 = x[0]*t19; /* gamma3*s*omega_tau */
    const double t32 = -t31; /* -gamma3*s*omega_tau */
    out[4] = t32;
    const double t33 = t12*t19; /* 1/(D/I1)*s*omega_tau */
    const double t34 = x[3]*t12; /* omega_n*1/(D/I1) */
    const double t35 = x[4]*t25; /* s*s*1/(D/I1) */
    const double t36 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t37 = p[24]*t17; /* I3/(R*I1)*V */
    const double t38 = p[20]*t25; /* 2*m*g*a3/I1*s*1/(D/I1) */
    const double t39 = p[21]*t25; /* 2*m^2*g*a3^3/I1^2*s*1/(D/I1) */
    const double t40 = JLT_FMS(t35, t39, t38); /* s*s*1/(D/I1)*2*m^2*g*a3^3/I1^2*s*1/(D/I1) - 2*m*g*a3/I1*s*1/(D/I1) */
    const double t41 = p[25]*t0; /* 2*I3^2/(R*I1^2)*b/R */
    const double t42 = t17*t41; /* V*2*I3^2/(R*I1^2)*b/R */
    const double t43 = x[3]*p[18]; /* omega_n*R*I1/I3 */
    const double t44 = t30 - t36; /* s*1/(b/R)*(G_level/(R*I1) - s*omega_n) - omega_n*gamma3 */
    const double t45 = t34*t44; /* omega_n*1/(D/I1)*(s*1/(b/R)*(G_level/(R*I1) - s*omega_n) - omega_n*gamma3) */
    const double t46 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t47 = -t46; /* -omega_tau*gamma3 */
    out[29] = t47;
    const double t48 = t19*t26; /* s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t49 = t10*t29; /* 1/(Theta/(m*R^2*I1))*omega_n*b/R */
    const double t50 = JLT_FNMA(t18, t49, t36); /* omega_n*gamma3 - I3/I1*e/R*1/(Theta/(m*R^2*I1))*omega_n*b/R */
    const double t51 = JLT_FNMA(t26, t30, t50); /* omega_n*gamma3 - I3/I1*e/R*1/(Theta/(m*R^2*I1))*omega_n*b/R - 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R)*s*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    out[22] = t51;
    const double t52 = t30*t43; /* s*1/(b/R)*(G_level/(R*I1) - s*omega_n)*omega_n*R*I1/I3 */
    const double t53 = t42*t49; /* V*2*I3^2/(R*I1^2)*b/R*1/(Theta/(m*R^2*I1))*omega_n*b/R */
    const double t54 = x[2]*t26; /* omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t55 = p[26]*t49; /* (-I3/(R*I1))*1/(Theta/(m*R^2*I1))*omega_n*b/R */
    out[21] = t55;
    const double t56 = x[4]*t11; /* s*1/(b/R) */
    const double t57 = t11*t23; /* 1/(b/R)*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t58 = JLT_FMA(t15, t57, t28); /* (I3/(m*R^2) + e/R)*1/(b/R)*1/(b/R)*(G_level/(R*I1) - s*omega_n) + t27 - a3/R*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t59 = JLT_FMA(t19, t58, t53); /* s*omega_tau*t58 + V*2*I3^2/(R*I1^2)*b/R*1/(Theta/(m*R^2*I1))*omega_n*b/R */
    const double t60 = t11*t52; /* 1/(b/R)*s*1/(b/R)*(G_level/(R*I1) - s*omega_n)*omega_n*R*I1/I3 */
    const double t61 = JLT_FMA(t25, t57, t34); /* s*1/(D/I1)*1/(b/R)*1/(b/R)*(G_level/(R*I1) - s*omega_n) + omega_n*1/(D/I1) */
    const double t62 = t25*t31; /* s*1/(D/I1)*gamma3*s*omega_tau */
    const double t63 = p[19]*t62; /* 2*m*a3^2/I1*s*1/(D/I1)*gamma3*s*omega_tau */
    out[17] = t63;
    const double t64 = x[0]*2.0; /* gamma3*2 */
    const double t65 = t34*t64; /* omega_n*1/(D/I1)*gamma3*2 */
    const double t66 = p[27]*t33; /* 2*m^2*a3^4/I1^2*1/(D/I1)*s*omega_tau */
    const double t67 = JLT_FNMA(t62, t66, t40); /* t40 - s*1/(D/I1)*gamma3*s*omega_tau*2*m^2*a3^4/I1^2*1/(D/I1)*s*omega_tau */
    const double t68 = t10*t37; /* 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t69 = JLT_FNMA(t0, t68, t46); /* omega_tau*gamma3 - b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t70 = JLT_FMA(t48, t56, t69); /* s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R)*s*1/(b/R) + omega_tau*gamma3 - b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    out[23] = t70;
    const double t71 = t23*t48; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t72 = JLT_FMS(x[3], t56, t23); /* omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t73 = JLT_FMA(t37, t49, t71); /* I3/(R*I1)*V*1/(Theta/(m*R^2*I1))*omega_n*b/R + t71 */
    const double t74 = JLT_FNMA(t34, t72, t67); /* t67 - omega_n*1/(D/I1)*(omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n)) */
    const double t75 = t43*t72; /* omega_n*R*I1/I3*(omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n)) */
    out[14] = t75;
    const double t76 = x[3]*t68; /* omega_n*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t77 = JLT_FNMA(p[23], t49, x[3]); /* omega_n - a3*I3/(R*I1)*1/(Theta/(m*R^2*I1))*omega_n*b/R */
    const double t78 = JLT_FMS(x[2], t77, t76); /* omega_tau*(omega_n - a3*I3/(R*I1)*1/(Theta/(m*R^2*I1))*omega_n*b/R) - omega_n*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t79 = JLT_FMA(t10, t59, t78); /* 1/(Theta/(m*R^2*I1))*t59 + t78 */
    out[20] = t79;
    const double t80 = JLT_FMA(t25, t72, t65); /* s*1/(D/I1)*(omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n)) + omega_n*1/(D/I1)*gamma3*2 */
    const double t81 = -t80; /* -t80 */
    out[18] = t81;
    const double t82 = t54*t72; /* omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R)*(omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n)) */
    const double t83 = JLT_FMS(x[3], t46, t73); /* omega_n*omega_tau*gamma3 - (I3/(R*I1)*V*1/(Theta/(m*R^2*I1))*omega_n*b/R + t71) */
    out[3] = t83;
    const double t84 = t33*t46; /* 1/(D/I1)*s*omega_tau*omega_tau*gamma3 */
    const double t85 = JLT_FNMA(t25, t45, t84); /* 1/(D/I1)*s*omega_tau*omega_tau*gamma3 - s*1/(D/I1)*t45 */
    const double t86 = JLT_FMA(p[19], t85, t74); /* 2*m*a3^2/I1*(1/(D/I1)*s*omega_tau*omega_tau*gamma3 - s*1/(D/I1)*t45) + t74 */
    out[19] = t86;
    const double t87 = p[9]*t33; /* m*a3^2/I1*1/(D/I1)*s*omega_tau */
    const double t88 = JLT_FMA(t31, t87, t45); /* gamma3*s*omega_tau*m*a3^2/I1*1/(D/I1)*s*omega_tau + t45 */
    const double t89 = JLT_FNMA(p[12], t35, t88); /* gamma3*s*omega_tau*m*a3^2/I1*1/(D/I1)*s*omega_tau + t45 - m*g*a3/I1*s*s*1/(D/I1) */
    out[2] = t89;
    const double t90 = t19*t87; /* s*omega_tau*m*a3^2/I1*1/(D/I1)*s*omega_tau */
    const double t91 = JLT_FNMA(x[3], t61, t90); /* s*omega_tau*m*a3^2/I1*1/(D/I1)*s*omega_tau - omega_n*t61 */
    out[15] = t91;
    const double t92 = x[4]*2.0; /* s*2 */
    const double t93 = t10*t92; /* 1/(Theta/(m*R^2*I1))*s*2 */
    const double t94 = JLT_FMA(t73, t93, t82); /* (I3/(R*I1)*V*1/(Theta/(m*R^2*I1))*omega_n*b/R + t71)*1/(Theta/(m*R^2*I1))*s*2 + t82 */
    out[24] = t94;
    const double t95 = p[1]*x[3]; /* R*omega_n */
    const double t96 = JLT_FMS(t29, t95, t52); /* omega_n*b/R*R*omega_n - s*1/(b/R)*(G_level/(R*I1) - s*omega_n)*omega_n*R*I1/I3 */
    out[1] = t96;
    const double t97 = JLT_FMA(x[3], t95, t60); /* omega_n*R*omega_n + t60 */
    out[10] = t97;
    const double t98 = p[17]*t29; /* 2*R*omega_n*b/R */
    const double t99 = x[4]*p[18]; /* s*R*I1/I3 */
    const double t100 = JLT_FMA(t72, t99, t98); /* (omega_n*s*1/(b/R) - 1/(b/R)*(G_level/(R*I1) - s*omega_n))*s*R*I1/I3 + 2*R*omega_n*b/R */
    out[13] = t100;
    const double t101 = x[4]*x[0]; /* s*gamma3 */
    const double t102 = -t101; /* -s*gamma3 */
    out[27] = t102;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = JLT_FMA(p[28], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t3 = t0*p[11]; /* b*I3/(R^2*I1) */
    const double t4 = t1 + p[10]; /* s*s + I3/(m*R^2) */
    const double t5 = JLT_FMA(t0, t3, t4); /* Theta/(m*R^2*I1) = b*b*I3/(R^2*I1) + s*s + I3/(m*R^2) */
    const double t6 = t2*t5; /* D*Theta/(m*R^2*I1) */
    const double t7 = t0*t6; /* b*D*Theta/(m*R^2*I1) */
    const double t8 = 1.0/t7; /* 1/(b*D*Theta/(m*R^2*I1)) */
    const double t9 = t1*x[2]; /* s*s*omega_tau */
    const double t10 = x[0]*p[29]; /* gamma3*2*m*a3^2 */
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
    const double t4 = p[31]*x[0]; /* 2*g*a3*gamma3 */
    const double t5 = JLT_FMA(x[1], x[1], t4); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t6 = p[28]*x[4]; /* m*a3^2*s */
    const double t7 = JLT_FMA(x[4], t6, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t8 = p[32]*x[2]; /* 1/m*omega_tau */
    const double t9 = x[2]*t8; /* omega_tau*1/m*omega_tau */
    const double t10 = p[33]*x[3]; /* I1/m*omega_n */
    const double t11 = JLT_FMA(x[3], t10, t5); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(t7, t9, t11); /* D*omega_tau*1/m*omega_tau + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[34]*t2; /* R^2*I1^2/(m*I3)*(G_level/(R*I1) - s*omega_n)/b */
    const double t14 = JLT_FMA(t2, t13, t12); /* (G_level/(R*I1) - s*omega_n)/b*R^2*I1^2/(m*I3)*(G_level/(R*I1) - s*omega_n)/b + t12 */
    const double t15 = x[4]*p[7]; /* s*R^2*I1/I3 */
    const double t16 = JLT_FNMA(t2, t15, t3); /* v_tau = omega_n*b - (G_level/(R*I1) - s*omega_n)/b*s*R^2*I1/I3 */
    const double t17 = JLT_FMA(t16, t16, t14); /* energy/(1/2*m) = v_tau*v_tau + t14 */
    const double t18 = p[30]*t17; /* 1/2*m*energy/(1/2*m) */
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
    const double t12 = x[4]*p[28]; /* s*m*a3^2 */
    const double t13 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t14 = t12*t13; /* s*m*a3^2*omega_tau*omega_tau */
    const double t15 = JLT_FMA(x[4], t12, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t16 = x[2]*t15; /* omega_tau*D */
    out[2] = t16;
    const double t17 = p[37]*t4; /* R^3*I1^2/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t18 = p[7]*t4; /* R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t19 = JLT_FMS(x[3], t9, t18); /* d(v_tau)/d(s) = omega_n*1/b*R^2*I1/I3*s - R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t20 = JLT_FNMA(t8, t17, p[35]); /* m*g*a3 - 1/b*1/b*(G_level/(R*I1) - omega_n*s)*R^3*I1^2/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t21 = p[38]*t8; /* R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t22 = JLT_FNMA(x[3], t21, t14); /* s*m*a3^2*omega_tau*omega_tau - omega_n*R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t23 = x[3]*p[4]; /* omega_n*I1 */
    const double t24 = JLT_FNMA(x[4], t21, t23); /* omega_n*I1 - s*R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t25 = p[36]*t7; /* m*R*v_tau */
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
    const double t0 = p[16] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t2 = p[39]*t1; /* (-I1/I3)*(G_level/(R*I1) - omega_n*s) */
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
    .state_count = 5, .param_count = 7, .block_count = 41,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 23, 12, 1, 0, 0, 10, 10 }, { 15, 62, 0, 8, 0, 0, 10, 8 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 25, { 9, 56, 27, 1, 0, 0, 13, 18 }, { 51, 305, 0, 41, 0, 0, 16, 10 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 9, 61, 32, 1, 0, 0, 13, 27 }, { 59, 347, 0, 48, 0, 0, 16, 11 },
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
