/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   25   12    1    1    0     14   11   (82)
 *  jacobian            8   52   29    1    1    0     19   22   (318)
 *  rhs_jacobian        7   57   34    1    1    0     21   22   (369)
 *  divergence          4   18    7    1    1    0     13   10   (54)
 *  integral_values     2    9    9    1    1    0      9    7   (43)
 *  integral_gradients  2   21   13    1    1    0     14   11   (75)
 *  eliminated          3    2    1    1    1    0      5    3   (11)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_omega3_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[3]*params[3]; /* a3*a3 */
    const double t1 = params[0]*t0; /* m*a3*a3 */
    out[21] = t1;
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    out[7] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    out[8] = t5;
    const double t6 = params[4]*t3; /* I1*R*R */
    const double t7 = params[5]/t6; /* I3/(I1*R*R) */
    out[9] = t7;
    const double t8 = t6/params[5]; /* I1*R*R/I3 */
    out[10] = t8;
    const double t9 = params[4]*params[1]; /* I1*R */
    out[26] = t9;
    const double t10 = params[6]/t9; /* G_level/(I1*R) */
    out[11] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[3]*t11; /* a3*m*g */
    out[27] = t12;
    const double t13 = t12/params[4]; /* a3*m*g/I1 */
    out[12] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[28] = t14;
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[13] = t15;
    const double t16 = t9/params[5]; /* I1*R/I3 */
    out[14] = t16;
    const double t17 = params[0]*2.0; /* m*2 */
    const double t18 = t0*t17; /* a3*a3*m*2 */
    out[31] = t18;
    const double t19 = t18/params[4]; /* a3*a3*m*2/I1 */
    out[15] = t19;
    const double t20 = params[5]/params[4]; /* I3/I1 */
    out[16] = t20;
    const double t21 = params[1]*t17; /* R*m*2 */
    const double t22 = t0*t21; /* a3*a3*R*m*2 */
    const double t23 = t22/params[4]; /* a3*a3*R*m*2/I1 */
    out[17] = t23;
    const double t24 = params[1]/2.0; /* R/2 */
    out[18] = t24;
    const double t25 = params[5]*2.0; /* I3*2 */
    const double t26 = t25/t6; /* I3*2/(I1*R*R) */
    out[19] = t26;
    const double t27 = params[5]/t9; /* I3/(I1*R) */
    out[20] = t27;
    const double t28 = t3*2.0; /* R*R*2 */
    const double t29 = params[4]*t28; /* I1*R*R*2 */
    const double t30 = params[3]*params[5]; /* a3*I3 */
    const double t31 = t30/t29; /* a3*I3/(I1*R*R*2) */
    out[21] = t31;
    const double t32 = params[3]/2.0; /* a3/2 */
    out[22] = t32;
    const double t33 = params[4]*params[5]; /* I1*I3 */
    out[24] = t33;
    const double t34 = params[4]*t4; /* I1*m*R*R */
    out[25] = t34;
    const double t35 = params[0]*params[5]; /* m*I3 */
    out[26] = t35;
    const double t36 = params[1]/params[5]; /* R/I3 */
    out[27] = t36;
    const double t37 = params[4]*2.0; /* I1*2 */
    out[32] = t37;
    const double t38 = t3*t17; /* R*R*m*2 */
    const double t39 = params[4]*t38; /* I1*R*R*m*2 */
    out[33] = t39;
    const double t40 = params[5]*t21; /* I3*R*m*2 */
    out[34] = t40;
    const double t41 = params[0]*params[3]; /* m*a3 */
    const double t42 = params[5]*t41; /* I3*m*a3 */
    out[35] = t42;
    const double t43 = params[3]*t14; /* a3*m*R */
    out[36] = t43;
    const double t44 = params[5]*t14; /* I3*m*R */
    out[37] = t44;
    const double t45 = params[0]/2.0; /* m/2 */
    out[38] = t45;
    const double t46 = params[2]*2.0; /* g*2 */
    const double t47 = params[3]*t46; /* a3*g*2 */
    out[39] = t47;
    const double t48 = 1.0/params[0]; /* 1/m */
    out[40] = t48;
    const double t49 = params[4]/params[0]; /* I1/m */
    out[41] = t49;
    const double t50 = params[4]*params[4]; /* I1*I1 */
    const double t51 = t3*t50; /* R*R*I1*I1 */
    const double t52 = t51/t35; /* R*R*I1*I1/(m*I3) */
    out[42] = t52;
    const double t53 = params[4]/params[5]; /* I1/I3 */
    const double t54 = -t53; /* -I1/I3 */
    out[43] = t54;
    const double t55 = params[3]/params[1]; /* a3/R */
    out[44] = t55;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(1 + gamma3) + 1 */
    const double t6 = p[8] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t7 = p[9]*t4; /* I3/(R^2*I1)*b */
    const double t8 = JLT_FMA(t4, t7, t6); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t9 = t3*t4; /* s*b */
    const double t10 = t5*t9; /* D/I1*s*b */
    const double t11 = t8*t10; /* Theta/(m*R^2*I1)*D/I1*s*b */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*D/I1*s*b) */
    const double t13 = t8*t12; /* 1/(s*b*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s*b) */
    const double t14 = t10*t12; /* D/I1*s*b*1/(Theta/(m*R^2*I1)*D/I1*s*b) */
    const double t15 = t5*t13; /* 1/(s*b) = D/I1*1/(s*b*(D/I1)) */
    const double t16 = t9*t13; /* s*b*1/(s*b*(D/I1)) */
    const double t17 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t18 = x[2]*t3; /* omega_tau*s */
    out[0] = t18;
    const double t19 = x[3]*t4; /* omega_n*b */
    const double t20 = t15*t19; /* 1/(s*b)*omega_n*b */
    const double t21 = JLT_FNMA(x[3], t3, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t22 = t3*t21; /* s*(G_level/(R*I1) - omega_n*s) */
    const double t23 = t15*t22; /* 1/(s*b)*s*(G_level/(R*I1) - omega_n*s) */
    const double t24 = p[7]*t17; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t25 = t18*t24; /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t26 = JLT_FNMA(p[12], t3, t25); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s */
    const double t27 = t17*t20; /* omega_tau*gamma3*1/(s*b)*omega_n*b */
    const double t28 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t29 = p[13] + t28; /* I3/(m*R) + e */
    const double t30 = x[2]*t29; /* omega_tau*(I3/(m*R) + e) */
    const double t31 = JLT_FMA(x[2], t28, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = t7*t31; /* I3/(R^2*I1)*b*V */
    const double t33 = t23*t30; /* 1/(s*b)*s*(G_level/(R*I1) - omega_n*s)*omega_tau*(I3/(m*R) + e) */
    const double t34 = JLT_FMA(t20, t32, t33); /* 1/(s*b)*omega_n*b*I3/(R^2*I1)*b*V + t33 */
    const double t35 = JLT_FNMA(t14, t34, t27); /* omega_tau*gamma3*1/(s*b)*omega_n*b - D/I1*s*b*1/(Theta/(m*R^2*I1)*D/I1*s*b)*(1/(s*b)*omega_n*b*I3/(R^2*I1)*b*V + t33) */
    out[3] = t35;
    const double t36 = x[3]*t20; /* omega_n*1/(s*b)*omega_n*b */
    const double t37 = x[3]*t23; /* omega_n*1/(s*b)*s*(G_level/(R*I1) - omega_n*s) */
    const double t38 = JLT_FNMA(x[0], t36, t26); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s - gamma3*omega_n*1/(s*b)*omega_n*b */
    const double t39 = t4*t36; /* b*omega_n*1/(s*b)*omega_n*b */
    const double t40 = JLT_FNMA(p[10], t37, t39); /* b*omega_n*1/(s*b)*omega_n*b - R^2*I1/I3*omega_n*1/(s*b)*s*(G_level/(R*I1) - omega_n*s) */
    out[1] = t40;
    const double t41 = JLT_FMA(p[1], t37, t38); /* R*omega_n*1/(s*b)*s*(G_level/(R*I1) - omega_n*s) + t38 */
    const double t42 = t16*t41; /* s*b*1/(s*b*(D/I1))*(R*omega_n*1/(s*b)*s*(G_level/(R*I1) - omega_n*s) + t38) */
    out[2] = t42;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(p[7], t4, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(gamma3 + 1) + 1 */
    const double t6 = t1*p[9]; /* b*I3/(R^2*I1) */
    const double t7 = t4 + p[8]; /* (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t8 = JLT_FMA(t1, t6, t7); /* Theta/(m*R^2*I1) = b*b*I3/(R^2*I1) + (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t9 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t9;
    const double t10 = t1*t9; /* b*s */
    const double t11 = t5*t10; /* D/I1*b*s */
    const double t12 = t8*t11; /* Theta/(m*R^2*I1)*D/I1*b*s */
    const double t13 = 1.0/t12; /* 1/(Theta/(m*R^2*I1)*D/I1*b*s) */
    const double t14 = t8*t13; /* 1/(s*b*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*b*s) */
    const double t15 = t5*t14; /* 1/(s*b) = D/I1*1/(s*b*(D/I1)) */
    const double t16 = t1*t15; /* 1/s = b*1/(s*b) */
    const double t17 = t0*t16; /* gamma3*omega_tau*1/s */
    const double t18 = -t17; /* -gamma3*omega_tau*1/s */
    out[0] = t18;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    const double t19 = t15*x[3]; /* 1/s*omega_n */
    const double t20 = x[0]*t19; /* gamma3*1/s*omega_n */
    const double t21 = p[14]*t20; /* R*I1/I3*gamma3*1/s*omega_n */
    const double t22 = JLT_FNMA(t8, x[3], p[11]); /* G_level/(R*I1) - s*omega_n */
    const double t23 = t8*t14; /* 1/b = s*1/(s*b) */
    const double t24 = t22*t23; /* (G_level/(R*I1) - s*omega_n)*1/b */
    const double t25 = JLT_FNMA(p[10], t24, t21); /* R*I1/I3*gamma3*1/s*omega_n - R^2*I1/I3*(G_level/(R*I1) - s*omega_n)*1/b */
    const double t26 = t23*t25; /* 1/b*t25 */
    const double t27 = t26 - t19; /* 1/b*t25 - 1/s*omega_n */
    const double t28 = p[1]*x[3]; /* R*omega_n */
    const double t29 = t27*t28; /* (1/b*t25 - 1/s*omega_n)*R*omega_n */
    const double t30 = t0*t19; /* b*1/s*omega_n */
    const double t31 = t16*t19; /* gamma3*1/s*1/s*omega_n */
    const double t32 = JLT_FMS(t30, t31, t29); /* b*1/s*omega_n*gamma3*1/s*1/s*omega_n - (1/b*t25 - 1/s*omega_n)*R*omega_n */
    out[4] = t32;
    const double t33 = t8*t23; /* s*1/b */
    const double t34 = JLT_FMS(x[3], t33, t24); /* omega_n*s*1/b - (G_level/(R*I1) - s*omega_n)*1/b */
    const double t35 = p[10]*t34; /* R^2*I1/I3*(omega_n*s*1/b - (G_level/(R*I1) - s*omega_n)*1/b) */
    const double t36 = JLT_FMA(t30, 2.0, t35); /* b*1/s*omega_n*2 + R^2*I1/I3*(omega_n*s*1/b - (G_level/(R*I1) - s*omega_n)*1/b) */
    out[7] = t36;
    const double t37 = t9*t13; /* 1/(D/I1) = b*s*1/(s*b*(D/I1)) */
    const double t38 = x[0]*t37; /* gamma3*1/(D/I1) */
    const double t39 = p[15]*t38; /* 2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t40 = t8*t39; /* s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t41 = t16 - t40; /* gamma3*1/s - s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t42 = JLT_FNMA(x[0], t41, t8); /* s - gamma3*(gamma3*1/s - s*2*m*a3^2/I1*gamma3*1/(D/I1)) */
    const double t43 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t44 = x[2]*t43; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t45 = t41*p[12]; /* (gamma3*1/s - s*2*m*a3^2/I1*gamma3*1/(D/I1))*m*g*a3/I1 */
    const double t46 = t20*t39; /* gamma3*1/s*omega_n*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t47 = t38*p[17]; /* gamma3*1/(D/I1)*2*m*R*a3^2/I1 */
    const double t48 = JLT_FNMA(t24, t47, t46); /* gamma3*1/s*omega_n*2*m*a3^2/I1*gamma3*1/(D/I1) - (G_level/(R*I1) - s*omega_n)*1/b*gamma3*1/(D/I1)*2*m*R*a3^2/I1 */
    const double t49 = JLT_FNMA(t26, p[16], t48); /* t48 - 1/b*t25*I3/I1 */
    const double t50 = t15*t19; /* 1/s*1/s*omega_n */
    const double t51 = JLT_FNMA(t19, t50, t45); /* (gamma3*1/s - s*2*m*a3^2/I1*gamma3*1/(D/I1))*m*g*a3/I1 - 1/s*omega_n*1/s*1/s*omega_n */
    const double t52 = JLT_FMA(t42, t44, t51); /* (s - gamma3*(gamma3*1/s - s*2*m*a3^2/I1*gamma3*1/(D/I1)))*omega_tau*omega_tau*m*a3^2/I1 + t51 */
    const double t53 = JLT_FNMA(x[3], t49, t52); /* t52 - omega_n*(t48 - 1/b*t25*I3/I1) */
    const double t54 = t37*t53; /* 1/(D/I1)*(t52 - omega_n*(t48 - 1/b*t25*I3/I1)) */
    out[8] = t54;
    const double t55 = x[2]*t40; /* omega_tau*s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    out[10] = t55;
    const double t56 = JLT_FMA(t34, p[18], t20); /* (omega_n*s*1/b - (G_level/(R*I1) - s*omega_n)*1/b)*1/2*R + gamma3*1/s*omega_n */
    const double t57 = t37*(-2.0); /* 1/(D/I1)*(-2) */
    const double t58 = t56*t57; /* t56*1/(D/I1)*(-2) */
    out[11] = t58;
    const double t59 = JLT_FMS(t0, p[20], x[0]); /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = b*I3/(R*I1) - gamma3 */
    const double t60 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = D/I1*b*s*1/(Theta/(m*R^2*I1)*D/I1*b*s) */
    const double t61 = t30*t60; /* b*1/s*omega_n*1/(Theta/(m*R^2*I1)) */
    const double t62 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t63 = JLT_FMA(x[2], t62, x[1]); /* V = omega_tau*e + v_nu */
    const double t64 = t60*t63; /* 1/(Theta/(m*R^2*I1))*V */
    const double t65 = p[19]*t59; /* 2*I3/(R^2*I1)*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t66 = t64*t65; /* 1/(Theta/(m*R^2*I1))*V*2*I3/(R^2*I1)*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t67 = t61*t66; /* b*1/s*omega_n*1/(Theta/(m*R^2*I1))*t66 */
    const double t68 = t62 + p[13]; /* e + I3/(m*R) */
    const double t69 = t60*t68; /* 1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t70 = x[2]*t69; /* omega_tau*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t71 = t26*t70; /* 1/b*t25*omega_tau*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t72 = JLT_FMA(t19, t64, t71); /* 1/s*omega_n*1/(Theta/(m*R^2*I1))*V + 1/b*t25*omega_tau*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t73 = t15*t50; /* 1/s*1/s*1/s*omega_n */
    const double t74 = t61*p[21]; /* b*1/s*omega_n*1/(Theta/(m*R^2*I1))*1/2*a3*I3/(R^2*I1) */
    const double t75 = t24*t60; /* (G_level/(R*I1) - s*omega_n)*1/b*1/(Theta/(m*R^2*I1)) */
    const double t76 = JLT_FNMA(t59, t69, p[22]); /* 1/2*a3 - d(Theta)/d(gamma3)/(2*m*R^2*I1)*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t77 = JLT_FMA(t75, t76, t74); /* (G_level/(R*I1) - s*omega_n)*1/b*1/(Theta/(m*R^2*I1))*t76 + b*1/s*omega_n*1/(Theta/(m*R^2*I1))*1/2*a3*I3/(R^2*I1) */
    const double t78 = JLT_FNMA(2.0, t77, t73); /* 1/s*1/s*1/s*omega_n - 2*t77 */
    const double t79 = p[9]*t61; /* I3/(R^2*I1)*b*1/s*omega_n*1/(Theta/(m*R^2*I1)) */
    const double t80 = t15*t63; /* 1/s*V */
    const double t81 = t16*t80; /* gamma3*1/s*1/s*V */
    const double t82 = JLT_FNMA(t79, t81, t67); /* b*1/s*omega_n*1/(Theta/(m*R^2*I1))*t66 - I3/(R^2*I1)*b*1/s*omega_n*1/(Theta/(m*R^2*I1))*gamma3*1/s*1/s*V */
    const double t83 = JLT_FNMA(p[20], t72, t82); /* t82 - I3/(R*I1)*t72 */
    const double t84 = JLT_FMA(x[2], t78, t83); /* omega_tau*(1/s*1/s*1/s*omega_n - 2*t77) + t82 - I3/(R*I1)*t72 */
    out[12] = t84;
    const double t85 = -t79; /* -I3/(R^2*I1)*b*1/s*omega_n*1/(Theta/(m*R^2*I1)) */
    out[13] = t85;
    const double t86 = JLT_FNMA(t68, t75, t20); /* gamma3*1/s*omega_n - (e + I3/(m*R))*(G_level/(R*I1) - s*omega_n)*1/b*1/(Theta/(m*R^2*I1)) */
    const double t87 = JLT_FNMA(t62, t79, t86); /* t86 - e*I3/(R^2*I1)*b*1/s*omega_n*1/(Theta/(m*R^2*I1)) */
    out[14] = t87;
    const double t88 = t5*t64; /* b*I3/(R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t89 = JLT_FNMA(t15, t88, t17); /* omega_tau*gamma3*1/s - 1/s*b*I3/(R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t90 = JLT_FMA(t33, t70, t89); /* s*1/b*omega_tau*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) + t89 */
    out[15] = t90;
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
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[6] = t3;
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = JLT_FMA(p[21], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t6 = JLT_FMA(p[23], t2, p[22]); /* m*R^2*I1*(1 - gamma3)*(1 + gamma3) + I1*I3 */
    const double t7 = p[24]*t4; /* m*I3*b */
    const double t8 = JLT_FMA(t4, t7, t6); /* Theta = b*m*I3*b + m*R^2*I1*(1 - gamma3)*(1 + gamma3) + I1*I3 */
    const double t9 = t3*t4; /* s*b */
    const double t10 = t5*t9; /* D*s*b */
    const double t11 = t8*t10; /* Theta*D*s*b */
    const double t12 = 1.0/t11; /* 1/(Theta*D*s*b) */
    const double t13 = t8*t12; /* 1/(s*b*D) = Theta*1/(Theta*D*s*b) */
    const double t14 = t10*t12; /* 1/Theta = D*s*b*1/(Theta*D*s*b) */
    const double t15 = t5*t13; /* 1/(s*b) = D*1/(s*b*D) */
    const double t16 = t9*t13; /* 1/D = s*b*1/(s*b*D) */
    const double t17 = t4*t15; /* 1/s = b*1/(s*b) */
    const double t18 = t3*t15; /* 1/b = s*1/(s*b) */
    const double t19 = x[3]*t17; /* omega_n*1/s */
    const double t20 = x[3]*t3; /* omega_n*s */
    const double t21 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t22 = t4*t19; /* b*omega_n*1/s */
    const double t23 = JLT_FNMA(p[28], t20, p[6]); /* G_level - R*I1*omega_n*s */
    const double t24 = t18*t23; /* 1/b*(G_level - R*I1*omega_n*s) */
    const double t25 = t18*t20; /* 1/b*omega_n*s */
    const double t26 = p[13] + t21; /* I3/(m*R) + e */
    const double t27 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = t7*t27; /* m*I3*b*V */
    const double t29 = t17*t28; /* 1/s*m*I3*b*V */
    const double t30 = p[26]*t22; /* m*I3*b*omega_n*1/s */
    const double t31 = p[30]*t26; /* m*R*(I3/(m*R) + e) */
    const double t32 = p[25]*t26; /* m*R^2*I1*(I3/(m*R) + e) */
    const double t33 = p[27]*t24; /* R/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t34 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t35 = x[0]*t19; /* gamma3*omega_n*1/s */
    const double t36 = t27*t30; /* V*m*I3*b*omega_n*1/s */
    const double t37 = t24*t31; /* 1/b*(G_level - R*I1*omega_n*s)*m*R*(I3/(m*R) + e) */
    const double t38 = JLT_FMA(x[2], t37, t36); /* omega_tau*1/b*(G_level - R*I1*omega_n*s)*m*R*(I3/(m*R) + e) + V*m*I3*b*omega_n*1/s */
    const double t39 = JLT_FMA(t21, t30, t37); /* e*m*I3*b*omega_n*1/s + 1/b*(G_level - R*I1*omega_n*s)*m*R*(I3/(m*R) + e) */
    const double t40 = JLT_FNMA(t14, t39, t35); /* gamma3*omega_n*1/s - 1/Theta*t39 */
    out[18] = t40;
    const double t41 = t14*t38; /* 1/Theta*t38 */
    const double t42 = t14*t30; /* 1/Theta*m*I3*b*omega_n*1/s */
    const double t43 = JLT_FMS(x[2], t35, t41); /* omega_tau*gamma3*omega_n*1/s - 1/Theta*t38 */
    out[3] = t43;
    const double t44 = -t42; /* -1/Theta*m*I3*b*omega_n*1/s */
    out[17] = t44;
    const double t45 = x[2]*t3; /* omega_tau*s */
    out[0] = t45;
    const double t46 = t32*t45; /* m*R^2*I1*(I3/(m*R) + e)*omega_tau*s */
    const double t47 = JLT_FMS(t18, t46, t29); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = 1/b*m*R^2*I1*(I3/(m*R) + e)*omega_tau*s - 1/s*m*I3*b*V */
    const double t48 = p[23]*t34; /* m*a3^2*omega_tau*gamma3 */
    const double t49 = t45*t48; /* omega_tau*s*m*a3^2*omega_tau*gamma3 */
    const double t50 = JLT_FNMA(p[29], t3, t49); /* omega_tau*s*m*a3^2*omega_tau*gamma3 - m*g*a3*s */
    const double t51 = t17*t34; /* 1/s*omega_tau*gamma3 */
    const double t52 = JLT_FMA(t14, t47, t51); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_n) + 1/s*omega_tau*gamma3 */
    out[19] = t52;
    const double t53 = -t51; /* -1/s*omega_tau*gamma3 */
    out[4] = t53;
    const double t54 = JLT_FMS(x[0], t51, t45); /* gamma3*1/s*omega_tau*gamma3 - omega_tau*s */
    const double t55 = JLT_FNMA(p[14], t35, t33); /* R/I3*1/b*(G_level - R*I1*omega_n*s) - R*I1/I3*gamma3*omega_n*1/s */
    const double t56 = t18*t55; /* 1/b*t55 */
    const double t57 = x[0]*p[33]; /* gamma3*2*m*R^2*I1 */
    const double t58 = JLT_FMS(p[34], t4, t57); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t59 = t41*t58; /* 1/Theta*t38*d(Theta)/d(gamma3) */
    const double t60 = p[35]*t22; /* m*a3*I3*b*omega_n*1/s */
    const double t61 = JLT_FMA(p[36], t24, t60); /* m*R*a3*1/b*(G_level - R*I1*omega_n*s) + m*a3*I3*b*omega_n*1/s */
    const double t62 = JLT_FNMA(p[4], t35, t24); /* 1/b*(G_level - R*I1*omega_n*s) - I1*gamma3*omega_n*1/s */
    const double t63 = JLT_FMA(x[3], t62, t50); /* numerator of d(omega_tau)/dt over D = omega_n*(1/b*(G_level - R*I1*omega_n*s) - I1*gamma3*omega_n*1/s) + omega_tau*s*m*a3^2*omega_tau*gamma3 - m*g*a3*s */
    const double t64 = t16*t63; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t64;
    const double t65 = JLT_FNMA(p[28], t25, t24); /* 1/b*(G_level - R*I1*omega_n*s) - R*I1*1/b*omega_n*s */
    const double t66 = JLT_FMS(p[10], t25, t33); /* R^2*I1/I3*1/b*omega_n*s - R/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t67 = JLT_FMA(2.0, t22, t66); /* 2*b*omega_n*1/s + t66 */
    out[11] = t67;
    const double t68 = t22 - t33; /* b*omega_n*1/s - R/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t69 = x[3]*t68; /* omega_n*(b*omega_n*1/s - R/I3*1/b*(G_level - R*I1*omega_n*s)) */
    out[1] = t69;
    const double t70 = JLT_FNMA(p[32], t35, t65); /* d(numerator of d(omega_tau)/dt over D)/d(omega_n) = 1/b*(G_level - R*I1*omega_n*s) - R*I1*1/b*omega_n*s - 2*I1*gamma3*omega_n*1/s */
    const double t71 = t16*t70; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(omega_n) */
    out[15] = t71;
    const double t72 = t17*t35; /* 1/s*gamma3*omega_n*1/s */
    const double t73 = x[2]*p[23]; /* omega_tau*m*a3^2 */
    const double t74 = t54*t73; /* (gamma3*1/s*omega_tau*gamma3 - omega_tau*s)*omega_tau*m*a3^2 */
    const double t75 = x[0]*p[12]; /* gamma3*m*g*a3/I1 */
    const double t76 = JLT_FNMA(t19, t19, t75); /* gamma3*m*g*a3/I1 - omega_n*1/s*omega_n*1/s */
    const double t77 = p[5]*t56; /* I3*1/b*t55 */
    const double t78 = JLT_FNMA(t31, t77, t61); /* t61 - m*R*(I3/(m*R) + e)*I3*1/b*t55 */
    const double t79 = t19 + t56; /* omega_n*1/s + 1/b*t55 */
    const double t80 = p[37]*t27; /* m*R*I3*V */
    const double t81 = JLT_FNMA(t19, t80, t59); /* 1/Theta*t38*d(Theta)/d(gamma3) - omega_n*1/s*m*R*I3*V */
    const double t82 = JLT_FNMA(x[2], t78, t81); /* 1/Theta*t38*d(Theta)/d(gamma3) - omega_n*1/s*m*R*I3*V - omega_tau*(t61 - m*R*(I3/(m*R) + e)*I3*1/b*t55) */
    const double t83 = t14*t82; /* 1/Theta*t82 */
    const double t84 = x[2]*t19; /* omega_tau*omega_n*1/s */
    const double t85 = x[0]*t27; /* gamma3*V */
    const double t86 = JLT_FNMA(t42, t85, t84); /* omega_tau*omega_n*1/s - 1/Theta*m*I3*b*omega_n*1/s*gamma3*V */
    const double t87 = x[0]*p[31]; /* gamma3*2*m*a3^2 */
    const double t88 = t16*t87; /* 1/D*gamma3*2*m*a3^2 */
    const double t89 = t45*t88; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[14] = t89;
    const double t90 = t64*t88; /* 1/D*numerator of d(omega_tau)/dt over D*1/D*gamma3*2*m*a3^2 */
    const double t91 = p[4]*t17; /* I1*1/s */
    const double t92 = JLT_FMS(t76, t91, t74); /* (gamma3*m*g*a3/I1 - omega_n*1/s*omega_n*1/s)*I1*1/s - (gamma3*1/s*omega_tau*gamma3 - omega_tau*s)*omega_tau*m*a3^2 */
    const double t93 = JLT_FNMA(x[3], t77, t92); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t92 - omega_n*I3*1/b*t55 */
    const double t94 = JLT_FMA(t16, t93, t90); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) + 1/D*numerator of d(omega_tau)/dt over D*1/D*gamma3*2*m*a3^2 */
    out[12] = t94;
    const double t95 = t17*t17; /* 1/s*1/s */
    const double t96 = JLT_FMA(t86, t95, t83); /* (omega_tau*omega_n*1/s - 1/Theta*m*I3*b*omega_n*1/s*gamma3*V)*1/s*1/s + 1/Theta*t82 */
    out[16] = t96;
    const double t97 = x[3]*p[1]; /* omega_n*R */
    const double t98 = t79*t97; /* (omega_n*1/s + 1/b*t55)*omega_n*R */
    const double t99 = JLT_FMA(t22, t72, t98); /* b*omega_n*1/s*1/s*gamma3*omega_n*1/s + (omega_n*1/s + 1/b*t55)*omega_n*R */
    out[8] = t99;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t5 = p[9]*t3; /* I3/(R^2*I1)*b */
    const double t6 = p[8] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t7 = JLT_FMA(p[23], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t8 = JLT_FMA(t3, t5, t6); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t9 = t5*t7; /* I3/(R^2*I1)*b*D */
    const double t10 = t4*t7; /* s*D */
    const double t11 = t8*t10; /* Theta/(m*R^2*I1)*s*D */
    const double t12 = t3*t11; /* b*Theta/(m*R^2*I1)*s*D */
    const double t13 = 1.0/t12; /* 1/(b*Theta/(m*R^2*I1)*s*D) */
    const double t14 = t3*t13; /* 1/(D*s*(Theta/(m*R^2*I1))) = b*1/(b*Theta/(m*R^2*I1)*s*D) */
    const double t15 = t8*t14; /* 1/(D*s) = Theta/(m*R^2*I1)*1/(D*s*(Theta/(m*R^2*I1))) */
    const double t16 = t10*t14; /* 1/(Theta/(m*R^2*I1)) = s*D*1/(D*s*(Theta/(m*R^2*I1))) */
    const double t17 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t18 = x[0]*p[31]; /* gamma3*2*m*a3^2 */
    const double t19 = t4*t18; /* s*gamma3*2*m*a3^2 */
    const double t20 = t15*t19; /* 1/(D*s)*s*gamma3*2*m*a3^2 */
    const double t21 = x[2]*t4; /* omega_tau*s */
    const double t22 = p[13] + t17; /* I3/(m*R) + e */
    const double t23 = t11*t22; /* Theta/(m*R^2*I1)*s*D*(I3/(m*R) + e) */
    const double t24 = t13*t23; /* 1/(b*Theta/(m*R^2*I1)*s*D)*Theta/(m*R^2*I1)*s*D*(I3/(m*R) + e) */
    const double t25 = JLT_FMA(t16, t24, t20); /* 1/(Theta/(m*R^2*I1))*t24 + 1/(D*s)*s*gamma3*2*m*a3^2 */
    const double t26 = t21*t25; /* omega_tau*s*(1/(Theta/(m*R^2*I1))*t24 + 1/(D*s)*s*gamma3*2*m*a3^2) */
    const double t27 = JLT_FMA(x[2], t17, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = t9*t27; /* I3/(R^2*I1)*b*D*V */
    const double t29 = t16*t28; /* 1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*D*V */
    const double t30 = JLT_FNMA(t15, t29, t26); /* t26 - 1/(D*s)*1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*D*V */
    out[0] = t30;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(p[21], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FNMA(x[3], t3, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t7 = t6/t5; /* (G_level/(R*I1) - omega_n*s)/b */
    const double t8 = x[3]*t5; /* omega_n*b */
    const double t9 = p[10]*t3; /* R^2*I1/I3*s */
    const double t10 = JLT_FNMA(t7, t9, t8); /* v_tau = omega_n*b - (G_level/(R*I1) - omega_n*s)/b*R^2*I1/I3*s */
    const double t11 = p[38]*x[0]; /* 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(x[1], x[1], t11); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[39]*x[2]; /* 1/m*omega_tau */
    const double t14 = x[2]*t13; /* omega_tau*1/m*omega_tau */
    const double t15 = p[40]*x[3]; /* I1/m*omega_n */
    const double t16 = JLT_FMA(x[3], t15, t12); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t17 = JLT_FMA(t4, t14, t16); /* D*omega_tau*1/m*omega_tau + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = p[41]*t7; /* R^2*I1^2/(m*I3)*(G_level/(R*I1) - omega_n*s)/b */
    const double t19 = JLT_FMA(t7, t18, t17); /* (G_level/(R*I1) - omega_n*s)/b*R^2*I1^2/(m*I3)*(G_level/(R*I1) - omega_n*s)/b + t17 */
    const double t20 = JLT_FMA(t10, t10, t19); /* energy/(1/2*m) = v_tau*v_tau + t19 */
    const double t21 = p[37]*t20; /* 1/2*m*energy/(1/2*m) */
    out[0] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = t4*t5; /* b*s */
    const double t7 = 1.0/t6; /* 1/(b*s) */
    const double t8 = x[3]*p[26]; /* omega_n*R*I1 */
    const double t9 = JLT_FNMA(t5, t8, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t10 = t5*t7; /* 1/b = s*1/(b*s) */
    const double t11 = t9*t10; /* (G_level - s*omega_n*R*I1)*1/b */
    const double t12 = x[0]*t4; /* gamma3*b */
    const double t13 = t7*t12; /* 1/(b*s)*gamma3*b */
    const double t14 = p[14]*x[3]; /* R*I1/I3*omega_n */
    const double t15 = p[25]*t11; /* R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t16 = JLT_FMS(t13, t14, t15); /* 1/(b*s)*gamma3*b*R*I1/I3*omega_n - R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t17 = t10*t16; /* 1/b*t16 */
    const double t18 = p[21]*x[0]; /* m*a3^2*gamma3 */
    const double t19 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t20 = JLT_FNMA(t18, t19, p[27]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t21 = JLT_FMA(t11, t17, t20); /* (G_level - s*omega_n*R*I1)*1/b*1/b*t16 + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t22 = JLT_FNMA(t5, t17, x[3]); /* omega_n - s*1/b*t16 */
    const double t23 = p[1]*t22; /* R*(omega_n - s*1/b*t16) */
    const double t24 = JLT_FMA(t13, t15, t23); /* d(v_tau)/d(gamma3) = 1/(b*s)*gamma3*b*R/I3*(G_level - s*omega_n*R*I1)*1/b + R*(omega_n - s*1/b*t16) */
    const double t25 = x[3]*t4; /* omega_n*b */
    const double t26 = JLT_FNMA(t5, t15, t25); /* v_tau = omega_n*b - s*R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t27 = p[14]*t5; /* R*I1/I3*s */
    const double t28 = t10*t27; /* 1/b*R*I1/I3*s */
    const double t29 = p[0]*t26; /* m*v_tau */
    const double t30 = JLT_FMA(t24, t29, t21); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau + t21 */
    out[0] = t30;
    const double t31 = x[3]*p[4]; /* omega_n*I1 */
    const double t32 = JLT_FNMA(t11, t28, t31); /* omega_n*I1 - (G_level - s*omega_n*R*I1)*1/b*1/b*R*I1/I3*s */
    const double t33 = p[10]*t3; /* R^2*I1/I3*(1 - gamma3)*(gamma3 + 1) */
    const double t34 = JLT_FMA(t10, t33, t4); /* d(v_tau)/d(omega_n) = 1/b*R^2*I1/I3*(1 - gamma3)*(gamma3 + 1) + b */
    const double t35 = JLT_FMA(t29, t34, t32); /* d(energy)/d(omega_n) = m*v_tau*d(v_tau)/d(omega_n) + omega_n*I1 - (G_level - s*omega_n*R*I1)*1/b*1/b*R*I1/I3*s */
    out[3] = t35;
    const double t36 = JLT_FMA(p[21], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t37 = x[2]*t36; /* omega_tau*D */
    out[2] = t37;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FNMA(x[3], t3, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t5 = p[43] + x[0]; /* b/R = a3/R + gamma3 */
    const double t6 = p[42]/t5; /* (-I1/I3)/(b/R) */
    const double t7 = t4*t6; /* (G_level/(R*I1) - omega_n*s)*(-I1/I3)/(b/R) */
    out[0] = t7;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t14[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t15[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t16[k] = jlt_jet_product(t14, t15, k);
        t17[k] = jlt_jet_root(t16[k], t17, k);
        t18[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t19[k] = p[7]*t16[k] + (k == 0 ? 1.0 : 0);
        t20[k] = (k == 0 ? p[8] : 0) + t16[k];
        t21[k] = p[9]*t18[k];
        t22[k] = jlt_jet_product(t18, t21, k) + t20[k];
        t23[k] = jlt_jet_product(t17, t18, k);
        t24[k] = jlt_jet_product(t19, t23, k);
        t25[k] = jlt_jet_product(t22, t24, k);
        t26[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t25, t26, k);
        t27[k] = jlt_jet_product(t22, t26, k);
        t28[k] = jlt_jet_product(t24, t26, k);
        t29[k] = jlt_jet_product(t19, t27, k);
        t30[k] = jlt_jet_product(t23, t27, k);
        t31[k] = jlt_jet_product(x2, x0, k);
        t32[k] = jlt_jet_product(x2, t17, k);
        t33[k] = jlt_jet_product(x3, t18, k);
        t34[k] = jlt_jet_product(t29, t33, k);
        t35[k] = (k == 0 ? p[11] : 0) - jlt_jet_product(x3, t17, k);
        t36[k] = jlt_jet_product(t17, t35, k);
        t37[k] = jlt_jet_product(t29, t36, k);
        t38[k] = p[7]*t31[k];
        t39[k] = jlt_jet_product(t32, t38, k);
        t40[k] = t39[k] - p[12]*t17[k];
        t41[k] = jlt_jet_product(t31, t34, k);
        t42[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t43[k] = (k == 0 ? p[13] : 0) + t42[k];
        t44[k] = jlt_jet_product(x2, t43, k);
        t45[k] = jlt_jet_product(x2, t42, k) + x1[k];
        t46[k] = jlt_jet_product(t21, t45, k);
        t47[k] = jlt_jet_product(t37, t44, k);
        t48[k] = jlt_jet_product(t34, t46, k) + t47[k];
        t49[k] = t41[k] - jlt_jet_product(t28, t48, k);
        t50[k] = jlt_jet_product(x3, t34, k);
        t51[k] = jlt_jet_product(x3, t37, k);
        t52[k] = t40[k] - jlt_jet_product(x0, t50, k);
        t53[k] = jlt_jet_product(t18, t50, k);
        t54[k] = t53[k] - p[10]*t51[k];
        t55[k] = p[1]*t51[k] + t52[k];
        t56[k] = jlt_jet_product(t30, t55, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t32[k]/(k + 1);
        next[1] = x1[k + 1] = t54[k]/(k + 1);
        next[2] = x2[k + 1] = t56[k]/(k + 1);
        next[3] = x3[k + 1] = t49[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double complex v_omega_n = x[3];
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double v_I3 = params[5];
    const double v_G_level = params[6];
    const double v_I1 = params[4];
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
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
    out[3] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 44,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 25, 12, 1, 1, 0, 14, 11 }, { 15, 56, 0, 10, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 8, 52, 29, 1, 1, 0, 19, 22 }, { 45, 230, 0, 42, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 57, 34, 1, 1, 0, 21, 22 }, { 52, 265, 0, 51, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 4, 18, 7, 1, 1, 0, 13, 10 }, { 10, 39, 0, 4, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 2, 9, 9, 1, 1, 0, 9, 7 }, { 10, 31, 0, 1, 1, 0, 13, 6 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 2, 21, 13, 1, 1, 0, 14, 11 }, { 15, 53, 0, 6, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 2, 1, 1, 1, 0, 5, 3 }, { 3, 6, 0, 1, 1, 0, 6, 4 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_general_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_general_on_level_G_omega3_avx512,
    },
};
