/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   17    6    1    0    0      8    7   (65)
 *  jacobian            8   39   15    1    0    0     11   15   (286)
 *  rhs_jacobian        8   43   19    1    0    0     14   13   (329)
 *  divergence          0   10    4    1    0    0      7    5   (36)
 *  integral_values     0   11   10    1    0    0      8    6   (55)
 *  integral_gradients  1   23   14    1    0    0      8    9   (138)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    1    1    1    0    0      3    2   (7)
 *
 *  Accuracy: divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
}

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
    const double t1 = t0/params[5]; /* R*I1/I3 */
    out[7] = t1;
    const double t2 = params[6]/t0; /* G_level/(R*I1) */
    out[8] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    out[38] = t4;
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    out[9] = t5;
    const double t6 = params[5]/params[4]; /* I3/I1 */
    out[10] = t6;
    const double t7 = params[5]/t0; /* I3/(R*I1) */
    out[11] = t7;
    const double t8 = params[5]*t4; /* I3*m*R*R */
    out[24] = t8;
    const double t9 = params[5]*params[5]; /* I3*I3 */
    const double t10 = t8 + t9; /* I3*m*R*R + I3*I3 */
    const double t11 = t10/t8; /* (I3*m*R*R + I3*I3)/(I3*m*R*R) */
    out[12] = t11;
    const double t12 = params[1]*2.0; /* R*2 */
    out[13] = t12;
    const double t13 = -t1; /* -R*I1/I3 */
    out[14] = t13;
    const double t14 = params[1]*params[0]; /* R*m */
    const double t15 = params[5]/params[1]; /* I3/R */
    const double t16 = t14 + t15; /* R*m + I3/R */
    const double t17 = t16/t14; /* (R*m + I3/R)/(R*m) */
    out[15] = t17;
    const double t18 = params[0]*params[0]; /* m*m */
    const double t19 = t3*t3; /* R*R*R*R */
    const double t20 = t18*t19; /* m*m*R*R*R*R */
    const double t21 = params[4]*t20; /* I1*m*m*R*R*R*R */
    const double t22 = params[5]*t21; /* I3*I1*m*m*R*R*R*R */
    const double t23 = params[5]*t9; /* I3*I3*I3 */
    const double t24 = t4*t23; /* m*R*R*I3*I3*I3 */
    const double t25 = t9*t20; /* I3*I3*m*m*R*R*R*R */
    const double t26 = t24 + t25; /* m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R */
    const double t27 = 2.0*t26; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R) */
    const double t28 = t27/t22; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R)/(I3*I1*m*m*R*R*R*R) */
    out[16] = t28;
    const double t29 = params[4]*params[4]; /* I1*I1 */
    const double t30 = params[1]*t29; /* R*I1*I1 */
    const double t31 = t9*2.0; /* I3*I3*2 */
    const double t32 = t31/t30; /* I3*I3*2/(R*I1*I1) */
    out[17] = t32;
    const double t33 = -t7; /* -I3/(R*I1) */
    out[18] = t33;
    const double t34 = params[4]*t4; /* I1*m*R*R */
    out[23] = t34;
    const double t35 = params[4]*params[5]; /* I1*I3 */
    out[22] = t35;
    const double t36 = t34 + t35; /* I1*m*R*R + I1*I3 */
    out[30] = t36;
    const double t37 = t36/t34; /* (I1*m*R*R + I1*I3)/(I1*m*R*R) */
    out[19] = t37;
    const double t38 = t9*t34; /* I3*I3*I1*m*R*R */
    const double t39 = t22 + t38; /* I3*I1*m*m*R*R*R*R + I3*I3*I1*m*R*R */
    const double t40 = 2.0*t39; /* 2*(I3*I1*m*m*R*R*R*R + I3*I3*I1*m*R*R) */
    const double t41 = t40/t22; /* 2*(I3*I1*m*m*R*R*R*R + I3*I3*I1*m*R*R)/(I3*I1*m*m*R*R*R*R) */
    out[20] = t41;
    const double t42 = params[5]*2.0; /* I3*2 */
    const double t43 = t42/t0; /* I3*2/(R*I1) */
    out[21] = t43;
    const double t44 = params[4]*t10; /* I1*(I3*m*R*R + I3*I3) */
    const double t45 = t44/params[5]; /* I1*(I3*m*R*R + I3*I3)/I3 */
    out[25] = t45;
    const double t46 = params[5]*t14; /* I3*R*m */
    out[26] = t46;
    const double t47 = params[0]*2.0; /* m*2 */
    const double t48 = t3*t47; /* R*R*m*2 */
    const double t49 = params[5]*t48; /* I3*R*R*m*2 */
    out[27] = t49;
    const double t50 = t0*t16; /* R*I1*(R*m + I3/R) */
    out[28] = t50;
    const double t51 = -t46; /* -I3*R*m */
    out[29] = t51;
    const double t52 = params[4]*t48; /* I1*R*R*m*2 */
    out[31] = t52;
    const double t53 = params[4]/2.0; /* I1/2 */
    out[32] = t53;
    const double t54 = params[0]/params[4]; /* m/I1 */
    out[33] = t54;
    const double t55 = params[4]/params[5]; /* I1/I3 */
    out[34] = t55;
    const double t56 = t4/params[4]; /* m*R*R/I1 */
    out[35] = t56;
    const double t57 = params[0]*t29; /* m*I1*I1 */
    out[36] = t57;
    const double t58 = params[4] - params[5]; /* I1 - I3 */
    const double t59 = t34*t58; /* I1*m*R*R*(I1 - I3) */
    out[37] = t59;
    const double t60 = t29/params[5]; /* I1*I1/I3 */
    out[39] = t60;
    const double t61 = t34/params[5]; /* I1*m*R*R/I3 */
    out[40] = t61;
    const double t62 = t29*t48; /* I1*I1*R*R*m*2 */
    const double t63 = t58*t62; /* (I1 - I3)*I1*I1*R*R*m*2 */
    const double t64 = t63/params[5]; /* (I1 - I3)*I1*I1*R*R*m*2/I3 */
    out[41] = t64;
    const double t65 = params[4]*t29; /* I1*I1*I1 */
    const double t66 = t48*t65; /* R*R*m*2*I1*I1*I1 */
    const double t67 = t58*t66; /* (I1 - I3)*R*R*m*2*I1*I1*I1 */
    const double t68 = t67/t9; /* (I1 - I3)*R*R*m*2*I1*I1*I1/(I3*I3) */
    out[42] = t68;
    const double t69 = t29*t47; /* I1*I1*m*2 */
    out[43] = t69;
    const double t70 = params[1]*t47; /* R*m*2 */
    const double t71 = t29*t70; /* I1*I1*R*m*2 */
    out[44] = t71;
    const double t72 = -t55; /* -I1/I3 */
    out[45] = t72;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t1 = JLT_FMA(x[4], x[4], p[9]); /* s*s + I3/(m*R^2) */
    const double t2 = JLT_FMA(x[0], t0, t1); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t3 = x[0]*t2; /* gamma3*Theta/(m*R^2*I1) */
    const double t4 = 1.0/t3; /* 1/(gamma3*Theta/(m*R^2*I1)) */
    const double t5 = x[4]*x[3]; /* s*omega_n */
    const double t6 = p[8] - t5; /* G_level/(R*I1) - s*omega_n */
    const double t7 = t2*t6; /* Theta/(m*R^2*I1)*(G_level/(R*I1) - s*omega_n) */
    const double t8 = t4*t7; /* 1/(gamma3*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*(G_level/(R*I1) - s*omega_n) */
    const double t9 = x[0]*t4; /* 1/(Theta/(m*R^2*I1)) = gamma3*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t10 = t5*t8; /* s*omega_n*t8 */
    const double t11 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t12 = p[11]*t11; /* I3/(R*I1)*V */
    const double t13 = JLT_FNMA(t9, t12, x[2]); /* omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t14 = x[4]*x[2]; /* s*omega_tau */
    const double t15 = x[4]*t14; /* s*s*omega_tau */
    out[0] = t15;
    const double t16 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t17 = t13*t16; /* (omega_tau - 1/(Theta/(m*R^2*I1))*I3/(R*I1)*V)*omega_n*gamma3 */
    const double t18 = x[3]*t16; /* omega_n*omega_n*gamma3 */
    const double t19 = t10 - t18; /* s*omega_n*t8 - omega_n*omega_n*gamma3 */
    out[2] = t19;
    const double t20 = p[1]*t18; /* R*omega_n*omega_n*gamma3 */
    const double t21 = JLT_FNMA(p[7], t10, t20); /* R*omega_n*omega_n*gamma3 - R*I1/I3*s*omega_n*t8 */
    out[1] = t21;
    const double t22 = p[12]*t14; /* (I3^2 + m*R^2*I3)/(m*R^2*I3)*s*omega_tau */
    const double t23 = t9*t22; /* 1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I3)*s*omega_tau */
    const double t24 = JLT_FNMA(t8, t23, t17); /* t17 - t8*t23 */
    out[3] = t24;
    const double t25 = x[0]*t14; /* gamma3*s*omega_tau */
    const double t26 = -t25; /* -gamma3*s*omega_tau */
    out[4] = t26;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[21] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[2] = t0;
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[4] = t2;
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = x[4]*x[3]; /* s*omega_n */
    const double t6 = p[8] - t5; /* G_level/(R*I1) - s*omega_n */
    const double t7 = p[10]*x[0]; /* I3/I1*gamma3 */
    const double t8 = t0 + p[9]; /* s*s + I3/(m*R^2) */
    const double t9 = JLT_FMA(x[0], t7, t8); /* Theta/(m*R^2*I1) = gamma3*I3/I1*gamma3 + s*s + I3/(m*R^2) */
    const double t10 = x[0]*t9; /* gamma3*Theta/(m*R^2*I1) */
    const double t11 = 1.0/t10; /* 1/(gamma3*Theta/(m*R^2*I1)) */
    const double t12 = t9*t11; /* 1/gamma3 = Theta/(m*R^2*I1)*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t13 = x[4]*t12; /* s*1/gamma3 */
    const double t14 = x[3]*t12; /* omega_n*1/gamma3 */
    const double t15 = t6*t13; /* (G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t16 = t14*t15; /* omega_n*1/gamma3*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t17 = JLT_FMA(p[7], t16, t4); /* R*I1/I3*omega_n*1/gamma3*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 + R*omega_n*omega_n */
    out[5] = t17;
    const double t18 = t6 - t5; /* G_level/(R*I1) - s*omega_n - s*omega_n */
    const double t19 = t13*t18; /* s*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t20 = p[7]*t19; /* R*I1/I3*s*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t21 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t22 = JLT_FMS(p[13], t21, t20); /* 2*R*omega_n*gamma3 - R*I1/I3*s*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[8] = t22;
    const double t23 = t14*t18; /* omega_n*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[14] = t23;
    const double t24 = p[14]*t23; /* (-R*I1/I3)*omega_n*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[9] = t24;
    const double t25 = t3 + t16; /* omega_n*omega_n + omega_n*1/gamma3*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t26 = -t25; /* -t25 */
    out[10] = t26;
    const double t27 = JLT_FNMA(2.0, t21, t19); /* s*1/gamma3*(G_level/(R*I1) - s*omega_n - s*omega_n) - 2*omega_n*gamma3 */
    out[13] = t27;
    const double t28 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t29 = x[0]*t11; /* 1/(Theta/(m*R^2*I1)) = gamma3*1/(gamma3*Theta/(m*R^2*I1)) */
    const double t30 = t28*t29; /* V*1/(Theta/(m*R^2*I1)) */
    const double t31 = JLT_FNMA(p[11], t30, x[2]); /* omega_tau - I3/(R*I1)*V*1/(Theta/(m*R^2*I1)) */
    const double t32 = x[3]*t31; /* omega_n*(omega_tau - I3/(R*I1)*V*1/(Theta/(m*R^2*I1))) */
    const double t33 = x[2]*t12; /* omega_tau*1/gamma3 */
    const double t34 = p[15]*t33; /* (m*R + I3/R)/(m*R)*omega_tau*1/gamma3 */
    const double t35 = t13*t34; /* s*1/gamma3*(m*R + I3/R)/(m*R)*omega_tau*1/gamma3 */
    const double t36 = t1*t29; /* s*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t37 = JLT_FMA(p[16], t36, t35); /* 2*(m*R^2*I3^3 + m^2*R^4*I3^2)/(m^2*R^4*I1*I3)*s*omega_tau*1/(Theta/(m*R^2*I1)) + s*1/gamma3*(m*R + I3/R)/(m*R)*omega_tau*1/gamma3 */
    const double t38 = t6*t29; /* (G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1)) */
    const double t39 = t21*t29; /* omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t40 = t30*t39; /* V*1/(Theta/(m*R^2*I1))*omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t41 = x[0]*p[17]; /* gamma3*2*I3^2/(R*I1^2) */
    const double t42 = JLT_FMA(t40, t41, t32); /* V*1/(Theta/(m*R^2*I1))*omega_n*gamma3*1/(Theta/(m*R^2*I1))*gamma3*2*I3^2/(R*I1^2) + omega_n*(omega_tau - I3/(R*I1)*V*1/(Theta/(m*R^2*I1))) */
    const double t43 = JLT_FMA(t37, t38, t42); /* t37*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1)) + t42 */
    out[15] = t43;
    const double t44 = t39*p[18]; /* omega_n*gamma3*1/(Theta/(m*R^2*I1))*(-I3/(R*I1)) */
    out[16] = t44;
    const double t45 = t38*p[12]; /* (G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I3) */
    const double t46 = JLT_FNMA(p[10], t39, t21); /* omega_n*gamma3 - I3/I1*omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t47 = JLT_FNMA(t13, t45, t46); /* omega_n*gamma3 - I3/I1*omega_n*gamma3*1/(Theta/(m*R^2*I1)) - s*1/gamma3*t45 */
    out[17] = t47;
    const double t48 = x[0]*t31; /* gamma3*(omega_tau - I3/(R*I1)*V*1/(Theta/(m*R^2*I1))) */
    const double t49 = t13*t36; /* s*1/gamma3*s*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t50 = JLT_FMA(p[19], t49, t48); /* (I1*I3 + m*R^2*I1)/(m*R^2*I1)*s*1/gamma3*s*omega_tau*1/(Theta/(m*R^2*I1)) + gamma3*(omega_tau - I3/(R*I1)*V*1/(Theta/(m*R^2*I1))) */
    out[18] = t50;
    const double t51 = t5*p[19]; /* s*omega_n*(I1*I3 + m*R^2*I1)/(m*R^2*I1) */
    const double t52 = JLT_FMS(t29, t51, t45); /* 1/(Theta/(m*R^2*I1))*s*omega_n*(I1*I3 + m*R^2*I1)/(m*R^2*I1) - t45 */
    const double t53 = t38*p[20]; /* (G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1))*2*(m*R^2*I1*I3^2 + m^2*R^4*I1*I3)/(m^2*R^4*I1*I3) */
    const double t54 = t49*t53; /* s*1/gamma3*s*omega_tau*1/(Theta/(m*R^2*I1))*t53 */
    const double t55 = x[4]*p[21]; /* s*2*I3/(R*I1) */
    const double t56 = JLT_FMA(t40, t55, t54); /* V*1/(Theta/(m*R^2*I1))*omega_n*gamma3*1/(Theta/(m*R^2*I1))*s*2*I3/(R*I1) + s*1/gamma3*s*omega_tau*1/(Theta/(m*R^2*I1))*t53 */
    const double t57 = JLT_FMA(t33, t52, t56); /* omega_tau*1/gamma3*t52 + t56 */
    out[19] = t57;
    const double t58 = -t1; /* -s*omega_tau */
    out[20] = t58;
    const double t59 = x[4]*x[0]; /* s*gamma3 */
    const double t60 = -t59; /* -s*gamma3 */
    out[22] = t60;
    const double t61 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t62 = -t61; /* -omega_tau*gamma3 */
    out[24] = t62;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[7] = t0;
    const double t1 = JLT_FMA(p[23], t0, p[22]); /* m*R^2*I1*s*s + I1*I3 */
    const double t2 = p[24]*x[0]; /* m*R^2*I3*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* Theta = gamma3*m*R^2*I3*gamma3 + m*R^2*I1*s*s + I1*I3 */
    const double t4 = x[0]*t3; /* gamma3*Theta */
    const double t5 = 1.0/t4; /* 1/(gamma3*Theta) */
    const double t6 = t3*t5; /* 1/gamma3 = Theta*1/(gamma3*Theta) */
    const double t7 = x[0]*t5; /* 1/Theta = gamma3*1/(gamma3*Theta) */
    const double t8 = x[4]*x[3]; /* s*omega_n */
    const double t9 = p[8] - t8; /* G_level/(R*I1) - s*omega_n */
    const double t10 = t9 - t8; /* G_level/(R*I1) - s*omega_n - s*omega_n */
    const double t11 = x[4]*t6; /* s*1/gamma3 */
    const double t12 = t9*t11; /* (G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t13 = p[25]*t9; /* I1*(I3^2 + m*R^2*I3)/I3*(G_level/(R*I1) - s*omega_n) */
    const double t14 = p[25]*t12; /* I1*(I3^2 + m*R^2*I3)/I3*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t15 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t16 = p[26]*t15; /* m*R*I3*V */
    const double t17 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t18 = x[2]*t14; /* omega_tau*t14 */
    const double t19 = JLT_FMA(t16, t17, t18); /* m*R*I3*V*omega_n*gamma3 + omega_tau*t14 */
    const double t20 = t7*t19; /* 1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t14) */
    const double t21 = JLT_FMA(p[24], t17, t14); /* m*R^2*I3*omega_n*gamma3 + t14 */
    const double t22 = JLT_FNMA(t7, t21, t17); /* omega_n*gamma3 - 1/Theta*(m*R^2*I3*omega_n*gamma3 + t14) */
    out[22] = t22;
    const double t23 = JLT_FMS(x[2], t17, t20); /* omega_tau*omega_n*gamma3 - 1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t14) */
    out[3] = t23;
    const double t24 = t7*t20; /* 1/Theta*1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t14) */
    const double t25 = x[2]*t6; /* omega_tau*1/gamma3 */
    const double t26 = t13*t25; /* I1*(I3^2 + m*R^2*I3)/I3*(G_level/(R*I1) - s*omega_n)*omega_tau*1/gamma3 */
    const double t27 = p[28]*t25; /* R*I1*(m*R + I3/R)*omega_tau*1/gamma3 */
    const double t28 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t29 = x[3]*t16; /* omega_n*m*R*I3*V */
    const double t30 = JLT_FMS(t12, t27, t29); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = (G_level/(R*I1) - s*omega_n)*s*1/gamma3*R*I1*(m*R + I3/R)*omega_tau*1/gamma3 - omega_n*m*R*I3*V */
    const double t31 = x[3]*t12; /* omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t32 = x[0]*t16; /* gamma3*m*R*I3*V */
    const double t33 = JLT_FMA(t7, t30, t28); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(gamma3) + omega_tau*omega_n */
    const double t34 = p[30]*t11; /* (I1*I3 + m*R^2*I1)*s*1/gamma3 */
    const double t35 = JLT_FMS(t28, t34, t26); /* d(numerator of d(omega_n)/dt over Theta)/d(s) = omega_tau*omega_n*(I1*I3 + m*R^2*I1)*s*1/gamma3 - t26 */
    const double t36 = t10*t11; /* (G_level/(R*I1) - s*omega_n - s*omega_n)*s*1/gamma3 */
    const double t37 = x[3]*t10; /* omega_n*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t38 = t6*t37; /* 1/gamma3*omega_n*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[19] = t38;
    const double t39 = p[14]*t38; /* (-R*I1/I3)*1/gamma3*omega_n*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[14] = t39;
    const double t40 = t7*t35; /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(s) */
    const double t41 = JLT_FNMA(2.0, t17, t36); /* (G_level/(R*I1) - s*omega_n - s*omega_n)*s*1/gamma3 - 2*omega_n*gamma3 */
    out[18] = t41;
    const double t42 = p[7]*t36; /* R*I1/I3*(G_level/(R*I1) - s*omega_n - s*omega_n)*s*1/gamma3 */
    const double t43 = JLT_FMS(p[13], t17, t42); /* 2*R*omega_n*gamma3 - R*I1/I3*(G_level/(R*I1) - s*omega_n - s*omega_n)*s*1/gamma3 */
    out[13] = t43;
    const double t44 = x[4]*x[2]; /* s*omega_tau */
    const double t45 = JLT_FMS(t34, t44, t32); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = (I1*I3 + m*R^2*I1)*s*1/gamma3*s*omega_tau - gamma3*m*R*I3*V */
    const double t46 = x[4]*t44; /* s*s*omega_tau */
    out[0] = t46;
    const double t47 = 2.0*t44; /* 2*s*omega_tau */
    out[9] = t47;
    const double t48 = -t44; /* -s*omega_tau */
    out[25] = t48;
    const double t49 = x[0]*t44; /* gamma3*s*omega_tau */
    const double t50 = -t49; /* -gamma3*s*omega_tau */
    out[4] = t50;
    const double t51 = x[3]*x[3]; /* omega_n*omega_n */
    const double t52 = p[7]*t31; /* R*I1/I3*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    const double t53 = x[3]*t17; /* omega_n*omega_n*gamma3 */
    const double t54 = p[29]*t17; /* (-m*R*I3)*omega_n*gamma3 */
    const double t55 = t7*t54; /* 1/Theta*(-m*R*I3)*omega_n*gamma3 */
    out[21] = t55;
    const double t56 = JLT_FMS(p[1], t53, t52); /* R*omega_n*omega_n*gamma3 - R*I1/I3*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 */
    out[1] = t56;
    const double t57 = t31 - t53; /* omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 - omega_n*omega_n*gamma3 */
    out[2] = t57;
    const double t58 = JLT_FMA(t6, t31, t51); /* 1/gamma3*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 + omega_n*omega_n */
    const double t59 = -t58; /* -t58 */
    out[15] = t59;
    const double t60 = p[1]*t51; /* R*omega_n*omega_n */
    const double t61 = JLT_FMA(t6, t52, t60); /* 1/gamma3*R*I1/I3*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/gamma3 + R*omega_n*omega_n */
    out[10] = t61;
    const double t62 = x[0]*p[27]; /* gamma3*2*m*R^2*I3 */
    const double t63 = JLT_FMA(t24, t62, t33); /* 1/Theta*1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t14)*gamma3*2*m*R^2*I3 + t33 */
    out[20] = t63;
    const double t64 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t65 = JLT_FMA(t7, t45, t64); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_n) + omega_tau*gamma3 */
    out[23] = t65;
    const double t66 = -t64; /* -omega_tau*gamma3 */
    out[29] = t66;
    const double t67 = x[4]*p[31]; /* s*2*m*R^2*I1 */
    const double t68 = JLT_FMA(t24, t67, t40); /* 1/Theta*1/Theta*(m*R*I3*V*omega_n*gamma3 + omega_tau*t14)*s*2*m*R^2*I1 + 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(s) */
    out[24] = t68;
    const double t69 = x[4]*x[0]; /* s*gamma3 */
    const double t70 = -t69; /* -s*gamma3 */
    out[27] = t70;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[0]*p[24]; /* gamma3*m*R^2*I3 */
    const double t2 = JLT_FMA(p[23], t0, p[22]); /* m*R^2*I1*s*s + I1*I3 */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta = gamma3*gamma3*m*R^2*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t4 = x[0]*t3; /* gamma3*Theta */
    const double t5 = 1.0/t4; /* 1/(gamma3*Theta) */
    const double t6 = x[2]*p[30]; /* omega_tau*(I1*I3 + m*R^2*I1) */
    const double t7 = t0*t6; /* s*s*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t8 = t3*t7; /* Theta*s*s*omega_tau*(I1*I3 + m*R^2*I1) */
    const double t9 = JLT_FMA(p[1], x[2], x[1]); /* V = R*omega_tau + v_nu */
    const double t10 = x[0]*p[26]; /* gamma3*m*R*I3 */
    const double t11 = t9*t10; /* V*gamma3*m*R*I3 */
    const double t12 = JLT_FMS(t5, t8, t11); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = 1/(gamma3*Theta)*Theta*s*s*omega_tau*(I1*I3 + m*R^2*I1) - V*gamma3*m*R*I3 */
    const double t13 = x[0]*t5; /* gamma3*1/(gamma3*Theta) */
    const double t14 = t12*t13; /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n)*gamma3*1/(gamma3*Theta) */
    out[0] = t14;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[33]*x[1]; /* m/I1*v_nu */
    const double t1 = x[3]*x[3]; /* omega_n*omega_n */
    const double t2 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t3 = p[34]*t2; /* I1/I3*(G_level/(R*I1) - omega_n*s) */
    const double t4 = t3/x[0]; /* I1/I3*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t5 = t4*t4; /* I1/I3*(G_level/(R*I1) - omega_n*s)/gamma3*I1/I3*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t6 = x[4]*t4; /* s*I1/I3*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t7 = JLT_FMS(x[3], x[0], t6); /* v_tau/R = omega_n*gamma3 - s*I1/I3*(G_level/(R*I1) - omega_n*s)/gamma3 */
    const double t8 = p[35]*t7; /* m*R^2/I1*v_tau/R */
    const double t9 = JLT_FMA(x[2], x[2], t1); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t10 = JLT_FMA(x[1], t0, t9); /* v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t11 = JLT_FMA(p[10], t5, t10); /* I3/I1*t5 + v_nu*m/I1*v_nu + omega_tau*omega_tau + omega_n*omega_n */
    const double t12 = JLT_FMA(t7, t8, t11); /* energy/(1/2*I1) = v_tau/R*m*R^2/I1*v_tau/R + t11 */
    const double t13 = p[32]*t12; /* 1/2*I1*energy/(1/2*I1) */
    out[0] = t13;
    const double t14 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t15 = p[36]*t14; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t16 = t14*t15; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t17 = p[10]*x[0]; /* I3/I1*gamma3 */
    const double t18 = JLT_FMA(x[4], x[4], p[9]); /* s*s + I3/(m*R^2) */
    const double t19 = JLT_FMA(x[0], t17, t18); /* Theta/(m*R^2*I1) = gamma3*I3/I1*gamma3 + s*s + I3/(m*R^2) */
    const double t20 = p[37]*t19; /* m*R^2*I1*(I1 - I3)*Theta/(m*R^2*I1) */
    const double t21 = JLT_FMA(t5, t20, t16); /* t5*m*R^2*I1*(I1 - I3)*Theta/(m*R^2*I1) + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t1;
    const double t2 = 1.0/x[0]; /* 1/gamma3 */
    const double t3 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t4 = t2*t3; /* 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t5 = x[4]*t4; /* s*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t6 = x[0]*p[10]; /* gamma3*I3/I1 */
    const double t7 = JLT_FMA(x[4], x[4], p[9]); /* s*s + I3/(m*R^2) */
    const double t8 = JLT_FMA(x[0], t6, t7); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t9 = p[42]*t8; /* 2*m*R^2*I1^3*(I1 - I3)/I3^2*Theta/(m*R^2*I1) */
    const double t10 = p[34]*t5; /* I1/I3*s*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t11 = JLT_FMS(x[3], x[0], t10); /* v_tau/R = omega_n*gamma3 - I1/I3*s*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t12 = x[4]*t2; /* s*1/gamma3 */
    const double t13 = t2*t4; /* 1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t14 = t9*t13; /* 2*m*R^2*I1^3*(I1 - I3)/I3^2*Theta/(m*R^2*I1)*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t15 = JLT_FMS(p[41], t3, t14); /* 2*m*R^2*I1^2*(I1 - I3)/I3*(G_level/(R*I1) - omega_n*s) - t14 */
    const double t16 = t4*t15; /* 1/gamma3*(G_level/(R*I1) - omega_n*s)*(2*m*R^2*I1^2*(I1 - I3)/I3*(G_level/(R*I1) - omega_n*s) - t14) */
    out[5] = t16;
    const double t17 = x[4]*p[34]; /* s*I1/I3 */
    const double t18 = JLT_FMS(x[3], t12, t4); /* omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t19 = p[40]*t18; /* m*R^2*I1/I3*(omega_n*s*1/gamma3 - 1/gamma3*(G_level/(R*I1) - omega_n*s)) */
    const double t20 = JLT_FMA(t12, t17, x[0]); /* d(v_tau)/d(omega_n)/R = s*1/gamma3*s*I1/I3 + gamma3 */
    const double t21 = JLT_FMA(t13, t17, x[3]); /* d(v_tau)/d(gamma3)/R = 1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s)*s*I1/I3 + omega_n */
    const double t22 = p[39]*t13; /* I1^2/I3*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t23 = t11*t19; /* v_tau/R*t19 */
    const double t24 = JLT_FNMA(x[3], t22, t23); /* d(energy)/d(s) = v_tau/R*t19 - omega_n*I1^2/I3*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    out[4] = t24;
    const double t25 = p[38]*t11; /* m*R^2*v_tau/R */
    const double t26 = t21*t25; /* d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R */
    const double t27 = JLT_FNMA(t4, t22, t26); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R - 1/gamma3*(G_level/(R*I1) - omega_n*s)*I1^2/I3*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    out[0] = t27;
    const double t28 = p[42]*t4; /* 2*m*R^2*I1^3*(I1 - I3)/I3^2*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t29 = t5*t28; /* s*1/gamma3*(G_level/(R*I1) - omega_n*s)*t28 */
    const double t30 = JLT_FNMA(x[3], t14, t29); /* s*1/gamma3*(G_level/(R*I1) - omega_n*s)*t28 - omega_n*t14 */
    out[9] = t30;
    const double t31 = x[4]*t14; /* s*t14 */
    const double t32 = -t31; /* -s*t14 */
    out[8] = t32;
    const double t33 = x[3]*p[4]; /* omega_n*I1 */
    const double t34 = JLT_FNMA(x[4], t22, t33); /* omega_n*I1 - s*I1^2/I3*1/gamma3*1/gamma3*(G_level/(R*I1) - omega_n*s) */
    const double t35 = JLT_FMA(t20, t25, t34); /* d(energy)/d(omega_n) = d(v_tau)/d(omega_n)/R*m*R^2*v_tau/R + t34 */
    out[3] = t35;
    const double t36 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t37 = p[43]*t36; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[6] = t37;
    const double t38 = p[44]*t36; /* 2*m*R*I1^2*(omega_tau*R + v_nu) */
    out[7] = t38;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t1 = p[45]*t0; /* (-I1/I3)*(G_level/(R*I1) - omega_n*s) */
    const double t2 = t1/x[0]; /* (-I1/I3)*(G_level/(R*I1) - omega_n*s)/gamma3 */
    out[0] = t2;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t13[k] = p[10]*x0[k];
        t14[k] = jlt_jet_product(x4, x4, k) + (k == 0 ? p[9] : 0);
        t15[k] = jlt_jet_product(x0, t13, k) + t14[k];
        t16[k] = jlt_jet_product(x0, t15, k);
        t17[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t16, t17, k);
        t18[k] = jlt_jet_product(x4, x3, k);
        t19[k] = (k == 0 ? p[8] : 0) - t18[k];
        t20[k] = jlt_jet_product(t15, t19, k);
        t21[k] = jlt_jet_product(t17, t20, k);
        t22[k] = jlt_jet_product(x0, t17, k);
        t23[k] = jlt_jet_product(t18, t21, k);
        t24[k] = x2[k]*p[1] + x1[k];
        t25[k] = p[11]*t24[k];
        t26[k] = x2[k] - jlt_jet_product(t22, t25, k);
        t27[k] = jlt_jet_product(x4, x2, k);
        t28[k] = jlt_jet_product(x4, t27, k);
        t29[k] = jlt_jet_product(x3, x0, k);
        t30[k] = jlt_jet_product(t26, t29, k);
        t31[k] = jlt_jet_product(x3, t29, k);
        t32[k] = t23[k] - t31[k];
        t33[k] = p[7]*t23[k];
        t34[k] = p[1]*t31[k] - t33[k];
        t35[k] = p[12]*t27[k];
        t36[k] = jlt_jet_product(t21, t35, k);
        t37[k] = t30[k] - jlt_jet_product(t22, t36, k);
        t38[k] = jlt_jet_product(x0, t27, k);
        t39[k] = -t38[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t28[k]/(k + 1);
        next[1] = x1[k + 1] = t34[k]/(k + 1);
        next[2] = x2[k + 1] = t32[k]/(k + 1);
        next[3] = x3[k + 1] = t37[k]/(k + 1);
        next[4] = x4[k + 1] = t39[k]/(k + 1);
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
    const double v_a3 = (0.0);
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
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "regular",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 46,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 17, 6, 1, 0, 0, 8, 7 }, { 11, 49, 0, 5, 0, 0, 11, 7 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .jacobian = { jacobian, 25, { 8, 39, 15, 1, 0, 0, 11, 15 }, { 41, 216, 0, 29, 0, 0, 15, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 8, 43, 19, 1, 0, 0, 14, 13 }, { 48, 248, 0, 33, 0, 0, 15, 8 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .divergence = { divergence, 1, { 0, 10, 4, 1, 0, 0, 7, 5 }, { 5, 28, 0, 3, 0, 0, 10, 5 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .integral_values = { integral_values, 2, { 0, 11, 10, 1, 0, 0, 8, 6 }, { 11, 43, 0, 1, 0, 0, 13, 6 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 10, { 1, 23, 14, 1, 0, 0, 8, 9 }, { 23, 105, 0, 10, 0, 0, 12, 9 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 1, 1, 1, 0, 0, 3, 2 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by gamma3: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_omega3_avx512,
    },
};
