/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   20    6    1    0    0     10    9   (59)
 *  jacobian            5   48   19    1    0    0     12   13   (279)
 *  rhs_jacobian        7   54   21    1    0    0     13   17   (316)
 *  divergence          0    6    5    1    0    0      7    4   (32)
 *  integral_values     0   14   10    1    0    0      9    5   (55)
 *  integral_gradients  0   29   12    1    0    0      8   11   (111)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    3    1    1    0    0      4    3   (7)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_on_level_G_avx512;

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
    const double t1 = 1.0/t0; /* 1/(R*I1) */
    const double t2 = params[1]*params[5]; /* R*I3 */
    const double t3 = params[4]*params[5]; /* I1*I3 */
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[0]*t4; /* m*R*R */
    const double t6 = params[4]*t5; /* I1*m*R*R */
    const double t7 = params[5]*t5; /* I3*m*R*R */
    const double t8 = params[5]/params[4]; /* I3/I1 */
    const double t9 = params[1]*params[0]; /* R*m */
    const double t10 = params[4]*t9; /* I1*R*m */
    const double t11 = params[4] - params[5]; /* I1 - I3 */
    const double t12 = params[1]*t11; /* R*(I1 - I3) */
    const double t13 = t12/params[4]; /* R*(I1 - I3)/I1 */
    const double t14 = params[5]*2.0; /* I3*2 */
    const double t15 = t14/params[4]; /* I3*2/I1 */
    const double t16 = t2/params[4]; /* R*I3/I1 */
    const double t17 = params[1]*2.0; /* R*2 */
    const double t18 = params[5]*t17; /* I3*R*2 */
    const double t19 = t18/params[4]; /* I3*R*2/I1 */
    const double t20 = 2.0/params[4]; /* 2/I1 */
    const double t21 = params[4]*params[4]; /* I1*I1 */
    const double t22 = params[5]*params[5]; /* I3*I3 */
    const double t23 = t22/t21; /* I3*I3/(I1*I1) */
    const double t24 = -t8; /* -I3/I1 */
    const double t25 = params[5]*(-2.0); /* I3*(-2) */
    const double t26 = t25/params[4]; /* I3*(-2)/I1 */
    const double t27 = -t23; /* -I3*I3/(I1*I1) */
    const double t28 = 2.0/t0; /* 2/(R*I1) */
    const double t29 = params[4]*2.0; /* I1*2 */
    const double t30 = params[5]/t29; /* I3/(I1*2) */
    const double t31 = params[0]*params[0]; /* m*m */
    const double t32 = 2.0*t31; /* 2*m*m */
    const double t33 = params[1]*t4; /* R*R*R */
    const double t34 = t32*t33; /* 2*m*m*R*R*R */
    const double t35 = params[4]*t34; /* I1*2*m*m*R*R*R */
    const double t36 = params[5]*t35; /* I3*I1*2*m*m*R*R*R */
    const double t37 = t4*t4; /* R*R*R*R */
    const double t38 = t32*t37; /* 2*m*m*R*R*R*R */
    const double t39 = params[5]*t38; /* I3*2*m*m*R*R*R*R */
    const double t40 = t11*t39; /* (I1 - I3)*I3*2*m*m*R*R*R*R */
    const double t41 = -t10; /* -I1*R*m */
    const double t42 = t5*t11; /* m*R*R*(I1 - I3) */
    const double t43 = params[0]*2.0; /* m*2 */
    const double t44 = t4*t43; /* R*R*m*2 */
    const double t45 = t11*t44; /* (I1 - I3)*R*R*m*2 */
    const double t46 = t21*t34; /* I1*I1*2*m*m*R*R*R */
    const double t47 = params[1]*t21; /* R*I1*I1 */
    const double t48 = params[5]/t47; /* I3/(R*I1*I1) */
    const double t49 = params[5]*t9; /* I3*R*m */
    const double t50 = params[0]/2.0; /* m/2 */
    const double t51 = params[4]/2.0; /* I1/2 */
    const double t52 = params[5]/2.0; /* I3/2 */
    const double t53 = params[0]*t21; /* m*I1*I1 */
    const double t54 = 1.0/params[4]; /* 1/I1 */
    const double t55 = 1.0/params[1]; /* 1/R */
    const double t56 = params[5]*t44; /* I3*R*R*m*2 */
    const double t57 = t11*t56; /* (I1 - I3)*I3*R*R*m*2 */
    const double t58 = t21*t43; /* I1*I1*m*2 */
    const double t59 = params[1]*t43; /* R*m*2 */
    const double t60 = t21*t59; /* I1*I1*R*m*2 */
    const double t61 = t29 - t14; /* I1*2 - I3*2 */
    const double t62 = params[4]*t44; /* I1*R*R*m*2 */
    const double t63 = t11*t62; /* (I1 - I3)*I1*R*R*m*2 */
    out[7] = t1;
    out[8] = t2;
    out[9] = t3;
    out[10] = t6;
    out[11] = t7;
    out[12] = t8;
    out[13] = t10;
    out[14] = t13;
    out[15] = t15;
    out[16] = t16;
    out[17] = t19;
    out[18] = t20;
    out[19] = t23;
    out[20] = t24;
    out[21] = t26;
    out[22] = t27;
    out[23] = t28;
    out[24] = t30;
    out[25] = t9;
    out[26] = t12;
    out[27] = t36;
    out[28] = t40;
    out[29] = t41;
    out[30] = t42;
    out[31] = t45;
    out[32] = t46;
    out[33] = t48;
    out[34] = t49;
    out[35] = t50;
    out[36] = t51;
    out[37] = t52;
    out[38] = t53;
    out[39] = t11;
    out[40] = t54;
    out[41] = t55;
    out[42] = t57;
    out[43] = t58;
    out[44] = t60;
    out[45] = t61;
    out[46] = t63;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[0]*x[3]; /* gamma3*omega3 */
    const double t3 = JLT_FMA(p[8], t2, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t4 = x[4]*p[10]; /* s*m*R^2*I1 */
    const double t5 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t6 = JLT_FMA(x[4], t4, p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t8 = x[4]*t7; /* s*Theta */
    const double t9 = 1.0/t8; /* 1/(s*Theta) */
    const double t10 = p[7]*t3; /* 1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t11 = t7*t10; /* Theta*1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t12 = t9*t11; /* omega_n = 1/(s*Theta)*Theta*1/(R*I1)*(R*I3*gamma3*omega3 + G_level) */
    const double t13 = x[0]*t12; /* gamma3*omega_n */
    const double t14 = t12*t13; /* omega_n*gamma3*omega_n */
    const double t15 = x[4]*t12; /* s*omega_n */
    const double t16 = x[3]*t15; /* omega3*s*omega_n */
    const double t17 = t14 + t16; /* omega_n*gamma3*omega_n + omega3*s*omega_n */
    const double t18 = p[1]*t17; /* R*(omega_n*gamma3*omega_n + omega3*s*omega_n) */
    const double t19 = JLT_FMA(t16, p[12], t14); /* omega3*s*omega_n*I3/I1 + omega_n*gamma3*omega_n */
    const double t20 = -t19; /* -(omega3*s*omega_n*I3/I1 + omega_n*gamma3*omega_n) */
    const double t21 = t2*p[14]; /* gamma3*omega3*R*(I1 - I3)/I1 */
    const double t22 = t1*t21; /* s*s*omega_tau*gamma3*omega3*R*(I1 - I3)/I1 */
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t24 = JLT_FNMA(t15, t23, t22); /* s*s*omega_tau*gamma3*omega3*R*(I1 - I3)/I1 - s*omega_n*V */
    const double t25 = x[4]*p[13]; /* s*m*R*I1 */
    const double t26 = t9*t25; /* 1/(s*Theta)*s*m*R*I1 */
    const double t27 = t24*t26; /* (s*s*omega_tau*gamma3*omega3*R*(I1 - I3)/I1 - s*omega_n*V)*1/(s*Theta)*s*m*R*I1 */
    const double t28 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t29 = -t28; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t18;
    out[2] = t20;
    out[3] = t27;
    out[4] = t29;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[0]*x[3]; /* gamma3*omega3 */
    const double t4 = JLT_FMA(p[8], t3, p[6]); /* R*I3*gamma3*omega3 + G_level */
    const double t5 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t6 = JLT_FMA(t0, p[10], p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t8 = x[4]*t7; /* s*Theta */
    const double t9 = 1.0/t8; /* 1/(s*Theta) */
    const double t10 = t7*t9; /* Theta*1/(s*Theta) */
    const double t11 = t4*t10; /* (R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta) */
    const double t12 = p[7]*t11; /* 1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta) */
    const double t13 = t3*p[15]; /* gamma3*omega3*2*I3/I1 */
    const double t14 = JLT_FMA(t10, t13, t12); /* Theta*1/(s*Theta)*gamma3*omega3*2*I3/I1 + 1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta) */
    const double t15 = t12*t14; /* 1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta)*t14 */
    const double t16 = p[1]*t15; /* R*t15 */
    const double t17 = x[3]*x[3]; /* omega3*omega3 */
    const double t18 = JLT_FMA(p[16], t17, t16); /* R*I3/I1*omega3*omega3 + R*t15 */
    const double t19 = x[4]*t12; /* s*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta) */
    const double t20 = p[1]*t19; /* R*s*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta) */
    const double t21 = x[0]*t12; /* gamma3*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta) */
    const double t22 = t10*t21; /* Theta*1/(s*Theta)*t21 */
    const double t23 = x[0]*t22; /* gamma3*Theta*1/(s*Theta)*t21 */
    const double t24 = JLT_FMA(t3, p[16], t20); /* gamma3*omega3*R*I3/I1 + t20 */
    const double t25 = JLT_FMA(p[17], t23, t24); /* 2*R*I3/I1*gamma3*Theta*1/(s*Theta)*t21 + gamma3*omega3*R*I3/I1 + t20 */
    const double t26 = t11*p[18]; /* (R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta)*2/I1 */
    const double t27 = t22*t26; /* Theta*1/(s*Theta)*t21*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta)*2/I1 */
    const double t28 = -t27; /* -t27 */
    const double t29 = JLT_FMA(t17, p[19], t15); /* omega3*omega3*I3^2/I1^2 + t15 */
    const double t30 = -t29; /* -(omega3*omega3*I3^2/I1^2 + t15) */
    const double t31 = t19*p[20]; /* s*1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta)*(-I3/I1) */
    const double t32 = JLT_FMA(t3, p[22], t31); /* gamma3*omega3*(-I3^2/I1^2) + t31 */
    const double t33 = JLT_FMA(t23, p[21], t32); /* gamma3*Theta*1/(s*Theta)*t21*(-2*I3/I1) + gamma3*omega3*(-I3^2/I1^2) + t31 */
    const double t34 = x[3]*p[12]; /* omega3*I3/I1 */
    const double t35 = t12*t34; /* 1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta)*omega3*I3/I1 */
    const double t36 = JLT_FMA(x[3], p[24], t22); /* omega3*1/2*I3/I1 + Theta*1/(s*Theta)*t21 */
    const double t37 = t11*p[23]; /* (R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta)*2/(R*I1) */
    const double t38 = JLT_FMS(t36, t37, t35); /* (omega3*1/2*I3/I1 + Theta*1/(s*Theta)*t21)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta)*2/(R*I1) - t35 */
    const double t39 = x[4]*t9; /* s*1/(s*Theta) */
    const double t40 = x[4]*t39; /* s*s*1/(s*Theta) */
    const double t41 = t1*p[26]; /* s*omega_tau*R*(I1 - I3) */
    const double t42 = t40*t41; /* s*s*1/(s*Theta)*s*omega_tau*R*(I1 - I3) */
    const double t43 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t44 = t39*t43; /* s*1/(s*Theta)*V */
    const double t45 = JLT_FNMA(p[5], t44, t42); /* s*s*1/(s*Theta)*s*omega_tau*R*(I1 - I3) - I3*s*1/(s*Theta)*V */
    const double t46 = p[25]*t45; /* m*R*(s*s*1/(s*Theta)*s*omega_tau*R*(I1 - I3) - I3*s*1/(s*Theta)*V) */
    const double t47 = t40*p[27]; /* s*s*1/(s*Theta)*2*m^2*R^3*I1*I3 */
    const double t48 = t44*t47; /* s*1/(s*Theta)*V*s*s*1/(s*Theta)*2*m^2*R^3*I1*I3 */
    const double t49 = t21*t48; /* t21*s*1/(s*Theta)*V*s*s*1/(s*Theta)*2*m^2*R^3*I1*I3 */
    const double t50 = t3*t40; /* gamma3*omega3*s*s*1/(s*Theta) */
    const double t51 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t52 = p[28]*t51; /* 2*m^2*R^4*I3*(I1 - I3)*omega_tau*gamma3 */
    const double t53 = t40*t52; /* s*s*1/(s*Theta)*2*m^2*R^4*I3*(I1 - I3)*omega_tau*gamma3 */
    const double t54 = JLT_FNMA(t50, t53, t49); /* t21*s*1/(s*Theta)*V*s*s*1/(s*Theta)*2*m^2*R^3*I1*I3 - gamma3*omega3*s*s*1/(s*Theta)*s*s*1/(s*Theta)*2*m^2*R^4*I3*(I1 - I3)*omega_tau*gamma3 */
    const double t55 = JLT_FMA(x[3], t46, t54); /* omega3*t46 + t54 */
    const double t56 = t12*t40; /* 1/(R*I1)*(R*I3*gamma3*omega3 + G_level)*Theta*1/(s*Theta)*s*s*1/(s*Theta) */
    const double t57 = p[29]*t56; /* (-m*R*I1)*t56 */
    const double t58 = x[4]*p[30]; /* s*m*R^2*(I1 - I3) */
    const double t59 = t50*t58; /* gamma3*omega3*s*s*1/(s*Theta)*s*m*R^2*(I1 - I3) */
    const double t60 = JLT_FNMA(p[10], t56, t59); /* gamma3*omega3*s*s*1/(s*Theta)*s*m*R^2*(I1 - I3) - m*R^2*I1*t56 */
    const double t61 = x[0]*t46; /* gamma3*t46 */
    const double t62 = x[2]*p[31]; /* omega_tau*2*m*R^2*(I1 - I3) */
    const double t63 = t50*t62; /* gamma3*omega3*s*s*1/(s*Theta)*omega_tau*2*m*R^2*(I1 - I3) */
    const double t64 = t43*t56; /* V*t56 */
    const double t65 = t1*p[14]; /* s*omega_tau*R*(I1 - I3)/I1 */
    const double t66 = JLT_FNMA(t50, t65, t64); /* V*t56 - gamma3*omega3*s*s*1/(s*Theta)*s*omega_tau*R*(I1 - I3)/I1 */
    const double t67 = t40*p[32]; /* s*s*1/(s*Theta)*2*m^2*R^3*I1^2 */
    const double t68 = JLT_FMA(t66, t67, t63); /* t66*s*s*1/(s*Theta)*2*m^2*R^3*I1^2 + gamma3*omega3*s*s*1/(s*Theta)*omega_tau*2*m*R^2*(I1 - I3) */
    const double t69 = -t1; /* -s*omega_tau */
    const double t70 = x[4]*x[0]; /* s*gamma3 */
    const double t71 = -t70; /* -s*gamma3 */
    const double t72 = -t51; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t18;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t25;
    out[9] = t28;
    out[10] = t30;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t33;
    out[14] = t38;
    out[15] = t55;
    out[16] = t57;
    out[17] = t60;
    out[18] = t61;
    out[19] = t68;
    out[20] = t69;
    out[21] = 0.0;
    out[22] = t71;
    out[23] = 0.0;
    out[24] = t72;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[3]*x[0]; /* omega3*gamma3 */
    const double t3 = JLT_FMA(p[8], t2, p[6]); /* R*I3*omega3*gamma3 + G_level */
    const double t4 = x[4]*x[4]; /* s*s */
    const double t5 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t6 = JLT_FMA(p[10], t4, p[9]); /* m*R^2*I1*s*s + I1*I3 */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta = gamma3*gamma3*m*R^2*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t8 = x[4]*t7; /* s*Theta */
    const double t9 = 1.0/t8; /* 1/(s*Theta) */
    const double t10 = t7*t9; /* Theta*1/(s*Theta) */
    const double t11 = t3*t10; /* (R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta) */
    const double t12 = p[7]*t11; /* 1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta) */
    const double t13 = x[4]*t12; /* s*1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta) */
    const double t14 = p[1]*t13; /* R*s*1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta) */
    const double t15 = x[3]*t14; /* omega3*t14 */
    const double t16 = x[0]*t12; /* gamma3*1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta) */
    const double t17 = t12*t16; /* 1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta)*t16 */
    const double t18 = JLT_FMA(p[1], t17, t15); /* R*t17 + omega3*t14 */
    const double t19 = x[3]*p[12]; /* omega3*I3/I1 */
    const double t20 = JLT_FMA(t13, t19, t17); /* s*1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta)*omega3*I3/I1 + t17 */
    const double t21 = -t20; /* -t20 */
    const double t22 = x[4]*t9; /* s*1/(s*Theta) */
    const double t23 = x[4]*t22; /* s*s*1/(s*Theta) */
    const double t24 = t2*p[14]; /* omega3*gamma3*R*(I1 - I3)/I1 */
    const double t25 = t0*t24; /* s*omega_tau*omega3*gamma3*R*(I1 - I3)/I1 */
    const double t26 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t27 = JLT_FNMA(t12, t26, t25); /* s*omega_tau*omega3*gamma3*R*(I1 - I3)/I1 - 1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta)*V */
    const double t28 = t23*t27; /* s*s*1/(s*Theta)*t27 */
    const double t29 = p[13]*t28; /* m*R*I1*s*s*1/(s*Theta)*t27 */
    const double t30 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t31 = -t30; /* -s*omega_tau*gamma3 */
    const double t32 = t0*2.0; /* s*omega_tau*2 */
    const double t33 = t12*t12; /* 1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta)*1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta) */
    const double t34 = t10*t16; /* Theta*1/(s*Theta)*t16 */
    const double t35 = x[3]*p[15]; /* omega3*2*I3/I1 */
    const double t36 = JLT_FMA(t34, t35, t33); /* Theta*1/(s*Theta)*t16*omega3*2*I3/I1 + t33 */
    const double t37 = p[1]*t36; /* R*(Theta*1/(s*Theta)*t16*omega3*2*I3/I1 + t33) */
    const double t38 = x[3]*x[3]; /* omega3*omega3 */
    const double t39 = JLT_FMA(p[16], t38, t37); /* R*I3/I1*omega3*omega3 + R*(Theta*1/(s*Theta)*t16*omega3*2*I3/I1 + t33) */
    const double t40 = x[0]*t34; /* gamma3*Theta*1/(s*Theta)*t16 */
    const double t41 = JLT_FMA(t2, p[16], t14); /* omega3*gamma3*R*I3/I1 + t14 */
    const double t42 = JLT_FMA(p[17], t40, t41); /* 2*R*I3/I1*gamma3*Theta*1/(s*Theta)*t16 + omega3*gamma3*R*I3/I1 + t14 */
    const double t43 = t11*t34; /* (R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta)*Theta*1/(s*Theta)*t16 */
    const double t44 = p[18]*t43; /* 2/I1*t43 */
    const double t45 = -t44; /* -2/I1*t43 */
    const double t46 = JLT_FMA(t38, p[19], t36); /* omega3*omega3*I3^2/I1^2 + Theta*1/(s*Theta)*t16*omega3*2*I3/I1 + t33 */
    const double t47 = -t46; /* -t46 */
    const double t48 = t13*p[20]; /* s*1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta)*(-I3/I1) */
    const double t49 = JLT_FMA(t2, p[22], t48); /* omega3*gamma3*(-I3^2/I1^2) + t48 */
    const double t50 = JLT_FMA(t40, p[21], t49); /* gamma3*Theta*1/(s*Theta)*t16*(-2*I3/I1) + omega3*gamma3*(-I3^2/I1^2) + t48 */
    const double t51 = t12*t19; /* 1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta)*omega3*I3/I1 */
    const double t52 = x[3]*p[33]; /* omega3*I3/(R*I1^2) */
    const double t53 = JLT_FMS(t11, t52, t51); /* (R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta)*omega3*I3/(R*I1^2) - t51 */
    const double t54 = JLT_FMA(t43, p[23], t53); /* t43*2/(R*I1) + t53 */
    const double t55 = t0*p[26]; /* s*omega_tau*R*(I1 - I3) */
    const double t56 = t23*t55; /* s*s*1/(s*Theta)*s*omega_tau*R*(I1 - I3) */
    const double t57 = t22*t26; /* s*1/(s*Theta)*V */
    const double t58 = JLT_FNMA(p[5], t57, t56); /* s*s*1/(s*Theta)*s*omega_tau*R*(I1 - I3) - I3*s*1/(s*Theta)*V */
    const double t59 = p[25]*t58; /* m*R*(s*s*1/(s*Theta)*s*omega_tau*R*(I1 - I3) - I3*s*1/(s*Theta)*V) */
    const double t60 = t23*p[27]; /* s*s*1/(s*Theta)*2*m^2*R^3*I1*I3 */
    const double t61 = t57*t60; /* s*1/(s*Theta)*V*s*s*1/(s*Theta)*2*m^2*R^3*I1*I3 */
    const double t62 = t16*t61; /* t16*s*1/(s*Theta)*V*s*s*1/(s*Theta)*2*m^2*R^3*I1*I3 */
    const double t63 = t2*t23; /* omega3*gamma3*s*s*1/(s*Theta) */
    const double t64 = x[2]*t63; /* omega_tau*omega3*gamma3*s*s*1/(s*Theta) */
    const double t65 = x[0]*p[28]; /* gamma3*2*m^2*R^4*I3*(I1 - I3) */
    const double t66 = t23*t65; /* s*s*1/(s*Theta)*gamma3*2*m^2*R^4*I3*(I1 - I3) */
    const double t67 = JLT_FNMA(t64, t66, t62); /* t16*s*1/(s*Theta)*V*s*s*1/(s*Theta)*2*m^2*R^3*I1*I3 - omega_tau*omega3*gamma3*s*s*1/(s*Theta)*s*s*1/(s*Theta)*gamma3*2*m^2*R^4*I3*(I1 - I3) */
    const double t68 = JLT_FMA(x[3], t59, t67); /* omega3*t59 + t67 */
    const double t69 = t12*t23; /* 1/(R*I1)*(R*I3*omega3*gamma3 + G_level)*Theta*1/(s*Theta)*s*s*1/(s*Theta) */
    const double t70 = p[29]*t69; /* (-m*R*I1)*t69 */
    const double t71 = x[4]*p[30]; /* s*m*R^2*(I1 - I3) */
    const double t72 = t63*t71; /* omega3*gamma3*s*s*1/(s*Theta)*s*m*R^2*(I1 - I3) */
    const double t73 = JLT_FNMA(p[10], t69, t72); /* omega3*gamma3*s*s*1/(s*Theta)*s*m*R^2*(I1 - I3) - m*R^2*I1*t69 */
    const double t74 = x[0]*t59; /* gamma3*t59 */
    const double t75 = t64*p[31]; /* omega_tau*omega3*gamma3*s*s*1/(s*Theta)*2*m*R^2*(I1 - I3) */
    const double t76 = t23*p[32]; /* s*s*1/(s*Theta)*2*m^2*R^3*I1^2 */
    const double t77 = JLT_FNMA(t28, t76, t75); /* omega_tau*omega3*gamma3*s*s*1/(s*Theta)*2*m*R^2*(I1 - I3) - s*s*1/(s*Theta)*t27*s*s*1/(s*Theta)*2*m^2*R^3*I1^2 */
    const double t78 = -t0; /* -s*omega_tau */
    const double t79 = x[4]*x[0]; /* s*gamma3 */
    const double t80 = -t79; /* -s*gamma3 */
    const double t81 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t82 = -t81; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t18;
    out[2] = t21;
    out[3] = t29;
    out[4] = t31;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t4;
    out[8] = 0.0;
    out[9] = t32;
    out[10] = t39;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t42;
    out[14] = t45;
    out[15] = t47;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t50;
    out[19] = t54;
    out[20] = t68;
    out[21] = t70;
    out[22] = t73;
    out[23] = t74;
    out[24] = t77;
    out[25] = t78;
    out[26] = 0.0;
    out[27] = t80;
    out[28] = 0.0;
    out[29] = t82;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t2 = JLT_FMA(p[10], t0, p[9]); /* m*R^2*I1*s*s + I1*I3 */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta = gamma3*gamma3*m*R^2*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t4 = 1.0/t3; /* 1/Theta */
    const double t5 = p[30]*x[2]; /* m*R^2*(I1 - I3)*omega_tau */
    const double t6 = t0*t5; /* s*s*m*R^2*(I1 - I3)*omega_tau */
    const double t7 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t8 = p[34]*t7; /* m*R*I3*V */
    const double t9 = JLT_FMS(t4, t6, x[2]); /* 1/Theta*s*s*m*R^2*(I1 - I3)*omega_tau - omega_tau */
    const double t10 = JLT_FNMA(t4, t8, t9); /* 1/Theta*s*s*m*R^2*(I1 - I3)*omega_tau - omega_tau - 1/Theta*m*R*I3*V */
    const double t11 = x[0]*t10; /* gamma3*t10 */
    out[0] = t11;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = 1.0/x[4]; /* 1/s */
    const double t2 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t3 = JLT_FMA(x[3], t2, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t4 = p[7]*t3; /* 1/(R*I1)*(omega3*R*I3*gamma3 + G_level) */
    const double t5 = t1*t4; /* omega_n = 1/s*1/(R*I1)*(omega3*R*I3*gamma3 + G_level) */
    const double t6 = x[0]*t5; /* gamma3*omega_n */
    const double t7 = JLT_FMA(x[4], x[3], t6); /* s*omega3 + gamma3*omega_n */
    const double t8 = p[1]*t7; /* v_tau = R*(s*omega3 + gamma3*omega_n) */
    const double t9 = JLT_FMA(t8, t8, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t10 = t5*t5; /* omega_n*omega_n */
    const double t11 = JLT_FMA(x[2], x[2], t10); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t12 = p[36]*t11; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t13 = x[3]*x[3]; /* omega3*omega3 */
    const double t14 = JLT_FMA(p[37], t13, t12); /* 1/2*I3*omega3*omega3 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t15 = JLT_FMA(p[35], t9, t14); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t14 */
    const double t16 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t17 = p[38]*t16; /* m*I1^2*(R*omega_tau + v_nu) */
    const double t18 = t16*t17; /* (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    const double t19 = x[4]*p[10]; /* s*m*R^2*I1 */
    const double t20 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t21 = JLT_FMA(x[4], t19, p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t22 = JLT_FMA(x[0], t20, t21); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t23 = t13*p[39]; /* omega3*omega3*(I1 - I3) */
    const double t24 = JLT_FMA(t22, t23, t18); /* Theta*omega3*omega3*(I1 - I3) + (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    out[0] = t15;
    out[1] = t24;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[4]; /* 1/s */
    const double t1 = x[3]*x[0]; /* omega3*gamma3 */
    const double t2 = JLT_FMA(p[8], t1, p[6]); /* R*I3*omega3*gamma3 + G_level */
    const double t3 = t0*t2; /* 1/s*(R*I3*omega3*gamma3 + G_level) */
    const double t4 = p[7]*t3; /* omega_n = 1/(R*I1)*1/s*(R*I3*omega3*gamma3 + G_level) */
    const double t5 = t0*t4; /* 1/s*omega_n */
    const double t6 = p[5]*x[3]; /* I3*omega3 */
    const double t7 = t5*t6; /* 1/s*omega_n*I3*omega3 */
    const double t8 = t4*p[1]; /* omega_n*R */
    const double t9 = t0*x[0]; /* 1/s*gamma3 */
    const double t10 = p[16]*t9; /* R*I3/I1*1/s*gamma3 */
    const double t11 = JLT_FMA(x[3], t10, t8); /* d(v_tau)/d(gamma3) = omega3*R*I3/I1*1/s*gamma3 + omega_n*R */
    const double t12 = x[3]*x[4]; /* omega3*s */
    const double t13 = JLT_FMA(x[0], t4, t12); /* gamma3*omega_n + omega3*s */
    const double t14 = p[25]*t13; /* m*R*(gamma3*omega_n + omega3*s) */
    const double t15 = JLT_FMA(t11, t14, t7); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*R*(gamma3*omega_n + omega3*s) + 1/s*omega_n*I3*omega3 */
    const double t16 = p[0]*x[1]; /* m*v_nu */
    const double t17 = p[4]*x[2]; /* I1*omega_tau */
    const double t18 = JLT_FMA(t4, t9, x[3]); /* omega_n*1/s*gamma3 + omega3 */
    const double t19 = p[5]*t18; /* I3*(omega_n*1/s*gamma3 + omega3) */
    const double t20 = x[4]*p[1]; /* s*R */
    const double t21 = JLT_FMA(x[0], t10, t20); /* d(v_tau)/d(omega3) = gamma3*R*I3/I1*1/s*gamma3 + s*R */
    const double t22 = JLT_FMA(t14, t21, t19); /* d(energy)/d(omega3) = m*R*(gamma3*omega_n + omega3*s)*d(v_tau)/d(omega3) + I3*(omega_n*1/s*gamma3 + omega3) */
    const double t23 = x[3]*p[1]; /* omega3*R */
    const double t24 = t9*p[40]; /* 1/s*gamma3*1/I1 */
    const double t25 = JLT_FNMA(t3, t24, t23); /* d(v_tau)/d(s) = omega3*R - 1/s*(R*I3*omega3*gamma3 + G_level)*1/s*gamma3*1/I1 */
    const double t26 = t14*t25; /* m*R*(gamma3*omega_n + omega3*s)*d(v_tau)/d(s) */
    const double t27 = t3*p[41]; /* 1/s*(R*I3*omega3*gamma3 + G_level)*1/R */
    const double t28 = JLT_FNMA(t5, t27, t26); /* d(energy)/d(s) = m*R*(gamma3*omega_n + omega3*s)*d(v_tau)/d(s) - 1/s*omega_n*1/s*(R*I3*omega3*gamma3 + G_level)*1/R */
    const double t29 = x[3]*p[42]; /* omega3*2*m*R^2*I3*(I1 - I3) */
    const double t30 = t1*t29; /* omega3*gamma3*omega3*2*m*R^2*I3*(I1 - I3) */
    const double t31 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t32 = p[43]*t31; /* 2*m*I1^2*(R*omega_tau + v_nu) */
    const double t33 = t31*p[44]; /* (R*omega_tau + v_nu)*2*m*R*I1^2 */
    const double t34 = x[4]*p[10]; /* s*m*R^2*I1 */
    const double t35 = x[0]*p[11]; /* gamma3*m*R^2*I3 */
    const double t36 = JLT_FMA(x[4], t34, p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t37 = JLT_FMA(x[0], t35, t36); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t38 = x[3]*p[45]; /* omega3*(2*I1 - 2*I3) */
    const double t39 = t37*t38; /* Theta*omega3*(2*I1 - 2*I3) */
    const double t40 = x[3]*p[46]; /* omega3*2*m*R^2*I1*(I1 - I3) */
    const double t41 = t12*t40; /* omega3*s*omega3*2*m*R^2*I1*(I1 - I3) */
    out[0] = t15;
    out[1] = t16;
    out[2] = t17;
    out[3] = t22;
    out[4] = t28;
    out[5] = t30;
    out[6] = t32;
    out[7] = t33;
    out[8] = t39;
    out[9] = t41;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[4]; /* 1/s */
    const double t1 = p[8]*x[0]; /* R*I3*gamma3 */
    const double t2 = JLT_FMA(x[3], t1, p[6]); /* omega3*R*I3*gamma3 + G_level */
    const double t3 = p[7]*t2; /* 1/(R*I1)*(omega3*R*I3*gamma3 + G_level) */
    const double t4 = t0*t3; /* 1/s*1/(R*I1)*(omega3*R*I3*gamma3 + G_level) */
    out[0] = t4;
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
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
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
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t10[k] = jlt_jet_product(x0, x3, k);
        t11[k] = p[8]*t10[k] + (k == 0 ? p[6] : 0);
        t14[k] = x4[k]*p[10];
        t16[k] = x0[k]*p[11];
        t17[k] = jlt_jet_product(x4, t14, k) + (k == 0 ? p[9] : 0);
        t18[k] = jlt_jet_product(x0, t16, k) + t17[k];
        t19[k] = jlt_jet_product(x4, t18, k);
        t21[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t19, t21, k);
        t22[k] = p[7]*t11[k];
        t23[k] = jlt_jet_product(t18, t22, k);
        t24[k] = jlt_jet_product(t21, t23, k);
        t25[k] = jlt_jet_product(x0, t24, k);
        t26[k] = jlt_jet_product(t24, t25, k);
        t27[k] = jlt_jet_product(x4, t24, k);
        t28[k] = jlt_jet_product(x3, t27, k);
        t29[k] = t26[k] + t28[k];
        t30[k] = p[1]*t29[k];
        t32[k] = t28[k]*p[12] + t26[k];
        t33[k] = -t32[k];
        t36[k] = t10[k]*p[14];
        t37[k] = jlt_jet_product(t3, t36, k);
        t39[k] = x2[k]*p[1] + x1[k];
        t40[k] = t37[k] - jlt_jet_product(t27, t39, k);
        t41[k] = x4[k]*p[13];
        t42[k] = jlt_jet_product(t21, t41, k);
        t43[k] = jlt_jet_product(t40, t42, k);
        t44[k] = jlt_jet_product(t2, x0, k);
        t45[k] = -t44[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t30[k]/(k + 1);
        next[2] = x2[k + 1] = t33[k]/(k + 1);
        next[3] = x3[k + 1] = t43[k]/(k + 1);
        next[4] = x4[k + 1] = t45[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double v_a3 = (0.0);
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
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
    out[3] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular_on_level_G = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "regular",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 47,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 20, 6, 1, 0, 0, 10, 9 }, { 10, 45, 0, 4, 0, 0, 10, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .jacobian = { jacobian, 25, { 5, 48, 19, 1, 0, 0, 12, 13 }, { 42, 208, 0, 29, 0, 0, 13, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 7, 54, 21, 1, 0, 0, 13, 17 }, { 48, 236, 0, 32, 0, 0, 13, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .divergence = { divergence, 1, { 0, 6, 5, 1, 0, 0, 7, 4 }, { 6, 24, 0, 2, 0, 0, 9, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .integral_values = { integral_values, 2, { 0, 14, 10, 1, 0, 0, 9, 5 }, { 11, 43, 0, 1, 0, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 10, { 0, 29, 12, 1, 0, 0, 8, 11 }, { 18, 86, 0, 7, 0, 0, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 3, 1, 1, 0, 0, 4, 3 }, { 1, 5, 0, 1, 0, 0, 5, 3 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_baseline,
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_avx2,
        &jlt_batch_spherical_top_balanced_in_regular_on_level_G_avx512,
    },
};
