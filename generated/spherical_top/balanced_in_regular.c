/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   18    7    1    0    0      8    7   (75)
 *  jacobian            6   50   18    1    0    0     10   15   (321)
 *  rhs_jacobian        9   56   20    1    0    0      9   18   (381)
 *  divergence          0    7    4    1    0    0      5    4   (30)
 *  integral_values     0   14   10    0    0    0      5    5   (55)
 *  integral_gradients  0   23    6    0    0    0      4    4   (81)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_balanced_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[5]/params[4]; /* I3/I1 */
    const double t1 = params[0]*params[1]; /* m*R */
    const double t2 = params[5]*t1; /* I3*m*R */
    const double t3 = params[4]*params[5]; /* I1*I3 */
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[0]*t4; /* m*R*R */
    const double t6 = params[4]*t5; /* I1*m*R*R */
    const double t7 = params[5]*t5; /* I3*m*R*R */
    const double t8 = params[5]*params[5]; /* I3*I3 */
    const double t9 = t7 + t8; /* I3*m*R*R + I3*I3 */
    const double t10 = params[4]*t1; /* I1*m*R */
    const double t11 = params[4] - params[5]; /* I1 - I3 */
    const double t12 = t5*t11; /* m*R*R*(I1 - I3) */
    const double t13 = params[1]*2.0; /* R*2 */
    const double t14 = -t0; /* -I3/I1 */
    const double t15 = params[0]*params[0]; /* m*m */
    const double t16 = 2.0*t15; /* 2*m*m */
    const double t17 = params[1]*t4; /* R*R*R */
    const double t18 = t16*t17; /* 2*m*m*R*R*R */
    const double t19 = t8*t18; /* I3*I3*2*m*m*R*R*R */
    const double t20 = params[5]*t8; /* I3*I3*I3 */
    const double t21 = t5*t20; /* m*R*R*I3*I3*I3 */
    const double t22 = 2.0*t21; /* 2*m*R*R*I3*I3*I3 */
    const double t23 = t4*t4; /* R*R*R*R */
    const double t24 = t15*t23; /* m*m*R*R*R*R */
    const double t25 = t8*t24; /* I3*I3*m*m*R*R*R*R */
    const double t26 = 2.0*t25; /* 2*I3*I3*m*m*R*R*R*R */
    const double t27 = t22 + t26; /* 2*m*R*R*I3*I3*I3 + 2*I3*I3*m*m*R*R*R*R */
    const double t28 = -t2; /* -I3*m*R */
    const double t29 = t6*t8; /* I1*m*R*R*I3*I3 */
    const double t30 = 2.0*t29; /* 2*I1*m*R*R*I3*I3 */
    const double t31 = params[4]*t24; /* I1*m*m*R*R*R*R */
    const double t32 = params[5]*t31; /* I3*I1*m*m*R*R*R*R */
    const double t33 = 2.0*t32; /* 2*I3*I1*m*m*R*R*R*R */
    const double t34 = t30 + t33; /* 2*I1*m*R*R*I3*I3 + 2*I3*I1*m*m*R*R*R*R */
    const double t35 = params[4]*t18; /* I1*2*m*m*R*R*R */
    const double t36 = params[5]*t35; /* I3*I1*2*m*m*R*R*R */
    const double t37 = t16*t23; /* 2*m*m*R*R*R*R */
    const double t38 = params[5]*t37; /* I3*2*m*m*R*R*R*R */
    const double t39 = t11*t38; /* (I1 - I3)*I3*2*m*m*R*R*R*R */
    const double t40 = -t10; /* -I1*m*R */
    const double t41 = params[0]*2.0; /* m*2 */
    const double t42 = t4*t41; /* R*R*m*2 */
    const double t43 = t11*t42; /* (I1 - I3)*R*R*m*2 */
    const double t44 = params[4]*params[4]; /* I1*I1 */
    const double t45 = t18*t44; /* 2*m*m*R*R*R*I1*I1 */
    const double t46 = params[4]*t37; /* I1*2*m*m*R*R*R*R */
    const double t47 = t11*t46; /* (I1 - I3)*I1*2*m*m*R*R*R*R */
    const double t48 = params[1]*t11; /* R*(I1 - I3) */
    const double t49 = t48/params[4]; /* R*(I1 - I3)/I1 */
    const double t50 = params[0]/2.0; /* m/2 */
    const double t51 = params[4]/2.0; /* I1/2 */
    const double t52 = params[5]/2.0; /* I3/2 */
    const double t53 = params[4]*params[1]; /* I1*R */
    const double t54 = params[5]*params[1]; /* I3*R */
    const double t55 = params[0]*t44; /* m*I1*I1 */
    const double t56 = -t54; /* -I3*R */
    const double t57 = params[5]*t42; /* I3*R*R*m*2 */
    const double t58 = t11*t57; /* (I1 - I3)*I3*R*R*m*2 */
    const double t59 = t41*t44; /* m*2*I1*I1 */
    const double t60 = params[1]*t41; /* R*m*2 */
    const double t61 = t44*t60; /* I1*I1*R*m*2 */
    const double t62 = params[4]*2.0; /* I1*2 */
    const double t63 = params[5]*2.0; /* I3*2 */
    const double t64 = t62 - t63; /* I1*2 - I3*2 */
    const double t65 = params[4]*t42; /* I1*R*R*m*2 */
    const double t66 = t11*t65; /* (I1 - I3)*I1*R*R*m*2 */
    out[6] = t0;
    out[7] = t2;
    out[8] = t3;
    out[9] = t6;
    out[10] = t7;
    out[11] = t9;
    out[12] = t10;
    out[13] = t12;
    out[14] = t13;
    out[15] = t14;
    out[16] = t19;
    out[17] = t27;
    out[18] = t28;
    out[19] = t34;
    out[20] = t36;
    out[21] = t39;
    out[22] = t40;
    out[23] = t43;
    out[24] = t45;
    out[25] = t47;
    out[26] = t49;
    out[27] = t1;
    out[28] = t48;
    out[29] = t50;
    out[30] = t51;
    out[31] = t52;
    out[32] = t53;
    out[33] = t54;
    out[34] = t55;
    out[35] = t11;
    out[36] = t5;
    out[37] = t56;
    out[38] = t58;
    out[39] = t59;
    out[40] = t61;
    out[41] = t64;
    out[42] = t66;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[2]; /* s*omega_tau */
    const double t1 = x[5]*t0; /* s*s*omega_tau */
    const double t2 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t3 = x[3]*t2; /* omega_n*omega_n*gamma3 */
    const double t4 = x[5]*x[3]; /* s*omega_n */
    const double t5 = x[4]*t4; /* omega3*s*omega_n */
    const double t6 = t3 + t5; /* omega_n*omega_n*gamma3 + omega3*s*omega_n */
    const double t7 = p[1]*t6; /* R*(omega_n*omega_n*gamma3 + omega3*s*omega_n) */
    const double t8 = JLT_FMA(t5, p[6], t3); /* omega3*s*omega_n*I3/I1 + omega_n*omega_n*gamma3 */
    const double t9 = -t8; /* -(omega3*s*omega_n*I3/I1 + omega_n*omega_n*gamma3) */
    const double t10 = x[5]*p[9]; /* s*m*R^2*I1 */
    const double t11 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t12 = JLT_FMA(x[5], t10, p[8]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t13 = JLT_FMA(x[0], t11, t12); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t14 = 1.0/t13; /* 1/Theta */
    const double t15 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t16 = t14*t15; /* 1/Theta*V */
    const double t17 = JLT_FNMA(p[7], t16, x[2]); /* omega_tau - m*R*I3*1/Theta*V */
    const double t18 = t2*t17; /* omega_n*gamma3*(omega_tau - m*R*I3*1/Theta*V) */
    const double t19 = t0*x[4]; /* s*omega_tau*omega3 */
    const double t20 = t14*t19; /* 1/Theta*s*omega_tau*omega3 */
    const double t21 = JLT_FMA(p[11], t20, t18); /* (I3^2 + m*R^2*I3)*1/Theta*s*omega_tau*omega3 + omega_n*gamma3*(omega_tau - m*R*I3*1/Theta*V) */
    const double t22 = t4*p[12]; /* s*omega_n*m*R*I1 */
    const double t23 = t16*t22; /* 1/Theta*V*s*omega_n*m*R*I1 */
    const double t24 = x[5]*p[13]; /* s*m*R^2*(I1 - I3) */
    const double t25 = x[0]*t24; /* gamma3*s*m*R^2*(I1 - I3) */
    const double t26 = JLT_FMS(t20, t25, t23); /* 1/Theta*s*omega_tau*omega3*gamma3*s*m*R^2*(I1 - I3) - 1/Theta*V*s*omega_n*m*R*I1 */
    const double t27 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t28 = -t27; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t7;
    out[2] = t9;
    out[3] = t21;
    out[4] = t26;
    out[5] = t28;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[5]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*p[1]; /* omega_n*R */
    const double t4 = x[3]*t3; /* omega_n*omega_n*R */
    const double t5 = x[5]*x[4]; /* s*omega3 */
    const double t6 = p[1]*t5; /* R*s*omega3 */
    const double t7 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t8 = JLT_FMA(p[14], t7, t6); /* 2*R*omega_n*gamma3 + R*s*omega3 */
    const double t9 = x[5]*t3; /* s*omega_n*R */
    const double t10 = t3*x[4]; /* omega_n*R*omega3 */
    const double t11 = x[3]*x[3]; /* omega_n*omega_n */
    const double t12 = -t11; /* -omega_n*omega_n */
    const double t13 = t7*(-2.0); /* omega_n*gamma3*(-2) */
    const double t14 = JLT_FMA(t5, p[15], t13); /* s*omega3*(-I3/I1) + omega_n*gamma3*(-2) */
    const double t15 = x[3]*p[6]; /* omega_n*I3/I1 */
    const double t16 = x[5]*t15; /* s*omega_n*I3/I1 */
    const double t17 = -t16; /* -s*omega_n*I3/I1 */
    const double t18 = x[4]*t15; /* omega3*omega_n*I3/I1 */
    const double t19 = -t18; /* -omega3*omega_n*I3/I1 */
    const double t20 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t21 = JLT_FMA(t0, p[9], p[8]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t22 = JLT_FMA(p[10], t20, t21); /* Theta = m*R^2*I3*gamma3*gamma3 + s*s*m*R^2*I1 + I1*I3 */
    const double t23 = 1.0/t22; /* 1/Theta */
    const double t24 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t25 = t23*t24; /* 1/Theta*V */
    const double t26 = JLT_FNMA(p[7], t25, x[2]); /* omega_tau - m*R*I3*1/Theta*V */
    const double t27 = x[3]*t26; /* omega_n*(omega_tau - m*R*I3*1/Theta*V) */
    const double t28 = t7*t25; /* omega_n*gamma3*1/Theta*V */
    const double t29 = p[16]*t28; /* 2*m^2*R^3*I3^2*omega_n*gamma3*1/Theta*V */
    const double t30 = x[5]*t23; /* s*1/Theta */
    const double t31 = x[2]*t30; /* omega_tau*s*1/Theta */
    const double t32 = x[4]*t31; /* omega3*omega_tau*s*1/Theta */
    const double t33 = JLT_FNMA(p[17], t32, t29); /* 2*m^2*R^3*I3^2*omega_n*gamma3*1/Theta*V - (2*m*R^2*I3^3 + 2*m^2*R^4*I3^2)*omega3*omega_tau*s*1/Theta */
    const double t34 = x[0]*t23; /* gamma3*1/Theta */
    const double t35 = JLT_FMA(t33, t34, t27); /* t33*gamma3*1/Theta + omega_n*(omega_tau - m*R*I3*1/Theta*V) */
    const double t36 = t7*t23; /* omega_n*gamma3*1/Theta */
    const double t37 = p[18]*t36; /* (-m*R*I3)*omega_n*gamma3*1/Theta */
    const double t38 = x[4]*p[11]; /* omega3*(I3^2 + m*R^2*I3) */
    const double t39 = JLT_FMA(t30, t38, t7); /* s*1/Theta*omega3*(I3^2 + m*R^2*I3) + omega_n*gamma3 */
    const double t40 = JLT_FNMA(p[10], t36, t39); /* s*1/Theta*omega3*(I3^2 + m*R^2*I3) + omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*1/Theta */
    const double t41 = x[0]*t26; /* gamma3*(omega_tau - m*R*I3*1/Theta*V) */
    const double t42 = t31*p[11]; /* omega_tau*s*1/Theta*(I3^2 + m*R^2*I3) */
    const double t43 = x[2]*t38; /* omega_tau*omega3*(I3^2 + m*R^2*I3) */
    const double t44 = t30*t32; /* s*1/Theta*omega3*omega_tau*s*1/Theta */
    const double t45 = t30*p[20]; /* s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t46 = t28*t45; /* omega_n*gamma3*1/Theta*V*s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t47 = JLT_FMA(t23, t43, t46); /* 1/Theta*omega_tau*omega3*(I3^2 + m*R^2*I3) + omega_n*gamma3*1/Theta*V*s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t48 = JLT_FNMA(p[19], t44, t47); /* t47 - (2*m*R^2*I1*I3^2 + 2*m^2*R^4*I1*I3)*s*1/Theta*omega3*omega_tau*s*1/Theta */
    const double t49 = x[5]*p[13]; /* s*m*R^2*(I1 - I3) */
    const double t50 = t20*p[21]; /* gamma3*gamma3*2*m^2*R^4*I3*(I1 - I3) */
    const double t51 = JLT_FMA(t32, t49, t46); /* omega3*omega_tau*s*1/Theta*s*m*R^2*(I1 - I3) + omega_n*gamma3*1/Theta*V*s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t52 = JLT_FNMA(t44, t50, t51); /* t51 - s*1/Theta*omega3*omega_tau*s*1/Theta*gamma3*gamma3*2*m^2*R^4*I3*(I1 - I3) */
    const double t53 = x[3]*t30; /* omega_n*s*1/Theta */
    const double t54 = p[22]*t53; /* (-m*R*I1)*omega_n*s*1/Theta */
    const double t55 = x[5]*x[0]; /* s*gamma3 */
    const double t56 = p[13]*t55; /* m*R^2*(I1 - I3)*s*gamma3 */
    const double t57 = x[4]*t56; /* omega3*m*R^2*(I1 - I3)*s*gamma3 */
    const double t58 = t30*t57; /* s*1/Theta*omega3*m*R^2*(I1 - I3)*s*gamma3 */
    const double t59 = JLT_FNMA(p[9], t53, t58); /* s*1/Theta*omega3*m*R^2*(I1 - I3)*s*gamma3 - m*R^2*I1*omega_n*s*1/Theta */
    const double t60 = t24*t30; /* V*s*1/Theta */
    const double t61 = p[22]*t60; /* (-m*R*I1)*V*s*1/Theta */
    const double t62 = t31*t56; /* omega_tau*s*1/Theta*m*R^2*(I1 - I3)*s*gamma3 */
    const double t63 = x[3]*p[12]; /* omega_n*m*R*I1 */
    const double t64 = t25*t63; /* 1/Theta*V*omega_n*m*R*I1 */
    const double t65 = x[0]*p[23]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t66 = t60*p[24]; /* V*s*1/Theta*2*m^2*R^3*I1^2 */
    const double t67 = t55*p[25]; /* s*gamma3*2*m^2*R^4*I1*(I1 - I3) */
    const double t68 = JLT_FMS(t32, t65, t64); /* omega3*omega_tau*s*1/Theta*gamma3*2*m*R^2*(I1 - I3) - 1/Theta*V*omega_n*m*R*I1 */
    const double t69 = JLT_FMA(t53, t66, t68); /* omega_n*s*1/Theta*V*s*1/Theta*2*m^2*R^3*I1^2 + t68 */
    const double t70 = JLT_FNMA(t44, t67, t69); /* omega_n*s*1/Theta*V*s*1/Theta*2*m^2*R^3*I1^2 + t68 - s*1/Theta*omega3*omega_tau*s*1/Theta*s*gamma3*2*m^2*R^4*I1*(I1 - I3) */
    const double t71 = -t1; /* -s*omega_tau */
    const double t72 = -t55; /* -s*gamma3 */
    const double t73 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t74 = -t73; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t2;
    out[6] = t4;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t8;
    out[10] = t9;
    out[11] = t10;
    out[12] = t12;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t14;
    out[16] = t17;
    out[17] = t19;
    out[18] = t35;
    out[19] = t37;
    out[20] = t40;
    out[21] = t41;
    out[22] = t42;
    out[23] = t48;
    out[24] = t52;
    out[25] = t54;
    out[26] = t59;
    out[27] = t61;
    out[28] = t62;
    out[29] = t70;
    out[30] = t71;
    out[31] = 0.0;
    out[32] = t72;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = t74;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[2]; /* s*omega_tau */
    const double t1 = x[5]*t0; /* s*s*omega_tau */
    const double t2 = p[1]*x[3]; /* R*omega_n */
    const double t3 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t4 = x[5]*x[4]; /* s*omega3 */
    const double t5 = t3 + t4; /* omega_n*gamma3 + s*omega3 */
    const double t6 = t2*t5; /* R*omega_n*(omega_n*gamma3 + s*omega3) */
    const double t7 = x[3]*t3; /* omega_n*omega_n*gamma3 */
    const double t8 = x[3]*p[6]; /* omega_n*I3/I1 */
    const double t9 = JLT_FMA(t4, t8, t7); /* s*omega3*omega_n*I3/I1 + omega_n*omega_n*gamma3 */
    const double t10 = -t9; /* -(s*omega3*omega_n*I3/I1 + omega_n*omega_n*gamma3) */
    const double t11 = x[5]*x[5]; /* s*s */
    const double t12 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t13 = JLT_FMA(p[9], t11, p[8]); /* m*R^2*I1*s*s + I1*I3 */
    const double t14 = JLT_FMA(p[10], t12, t13); /* Theta = m*R^2*I3*gamma3*gamma3 + m*R^2*I1*s*s + I1*I3 */
    const double t15 = 1.0/t14; /* 1/Theta */
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = t15*t16; /* 1/Theta*V */
    const double t18 = JLT_FNMA(p[7], t17, x[2]); /* omega_tau - m*R*I3*1/Theta*V */
    const double t19 = t3*t18; /* omega_n*gamma3*(omega_tau - m*R*I3*1/Theta*V) */
    const double t20 = x[5]*t15; /* s*1/Theta */
    const double t21 = x[4]*t20; /* omega3*s*1/Theta */
    const double t22 = x[2]*t21; /* omega_tau*omega3*s*1/Theta */
    const double t23 = JLT_FMA(p[11], t22, t19); /* (I3^2 + m*R^2*I3)*omega_tau*omega3*s*1/Theta + omega_n*gamma3*(omega_tau - m*R*I3*1/Theta*V) */
    const double t24 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t25 = p[26]*t24; /* R*(I1 - I3)/I1*s*omega_tau*gamma3 */
    const double t26 = t21*t25; /* omega3*s*1/Theta*R*(I1 - I3)/I1*s*omega_tau*gamma3 */
    const double t27 = x[3]*t20; /* omega_n*s*1/Theta */
    const double t28 = JLT_FNMA(t16, t27, t26); /* omega3*s*1/Theta*R*(I1 - I3)/I1*s*omega_tau*gamma3 - V*omega_n*s*1/Theta */
    const double t29 = p[12]*t28; /* m*R*I1*t28 */
    const double t30 = -t24; /* -s*omega_tau*gamma3 */
    const double t31 = t0*2.0; /* s*omega_tau*2 */
    const double t32 = x[3]*t2; /* omega_n*R*omega_n */
    const double t33 = p[1]*t4; /* R*s*omega3 */
    const double t34 = JLT_FMA(t3, p[14], t33); /* omega_n*gamma3*2*R + R*s*omega3 */
    const double t35 = x[5]*t2; /* s*R*omega_n */
    const double t36 = t2*x[4]; /* R*omega_n*omega3 */
    const double t37 = x[3]*x[3]; /* omega_n*omega_n */
    const double t38 = -t37; /* -omega_n*omega_n */
    const double t39 = t3*(-2.0); /* omega_n*gamma3*(-2) */
    const double t40 = JLT_FMA(t4, p[15], t39); /* s*omega3*(-I3/I1) + omega_n*gamma3*(-2) */
    const double t41 = x[5]*t8; /* s*omega_n*I3/I1 */
    const double t42 = -t41; /* -s*omega_n*I3/I1 */
    const double t43 = x[4]*t8; /* omega3*omega_n*I3/I1 */
    const double t44 = -t43; /* -omega3*omega_n*I3/I1 */
    const double t45 = x[3]*t18; /* omega_n*(omega_tau - m*R*I3*1/Theta*V) */
    const double t46 = t3*t17; /* omega_n*gamma3*1/Theta*V */
    const double t47 = p[16]*t46; /* 2*m^2*R^3*I3^2*omega_n*gamma3*1/Theta*V */
    const double t48 = JLT_FNMA(t22, p[17], t47); /* 2*m^2*R^3*I3^2*omega_n*gamma3*1/Theta*V - omega_tau*omega3*s*1/Theta*(2*m*R^2*I3^3 + 2*m^2*R^4*I3^2) */
    const double t49 = x[0]*t15; /* gamma3*1/Theta */
    const double t50 = JLT_FMA(t48, t49, t45); /* t48*gamma3*1/Theta + omega_n*(omega_tau - m*R*I3*1/Theta*V) */
    const double t51 = t3*t15; /* omega_n*gamma3*1/Theta */
    const double t52 = p[18]*t51; /* (-m*R*I3)*omega_n*gamma3*1/Theta */
    const double t53 = JLT_FNMA(p[10], t51, t3); /* omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*1/Theta */
    const double t54 = JLT_FMA(p[11], t21, t53); /* (I3^2 + m*R^2*I3)*omega3*s*1/Theta + omega_n*gamma3 - m*R^2*I3*omega_n*gamma3*1/Theta */
    const double t55 = x[0]*t18; /* gamma3*(omega_tau - m*R*I3*1/Theta*V) */
    const double t56 = x[2]*p[11]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t57 = t20*t56; /* s*1/Theta*omega_tau*(I3^2 + m*R^2*I3) */
    const double t58 = x[4]*t56; /* omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t59 = t20*t22; /* s*1/Theta*omega_tau*omega3*s*1/Theta */
    const double t60 = t20*p[20]; /* s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t61 = t46*t60; /* omega_n*gamma3*1/Theta*V*s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t62 = JLT_FMA(t15, t58, t61); /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) + omega_n*gamma3*1/Theta*V*s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t63 = JLT_FNMA(p[19], t59, t62); /* t62 - (2*m*R^2*I1*I3^2 + 2*m^2*R^4*I1*I3)*s*1/Theta*omega_tau*omega3*s*1/Theta */
    const double t64 = t21*p[13]; /* omega3*s*1/Theta*m*R^2*(I1 - I3) */
    const double t65 = t12*p[21]; /* gamma3*gamma3*2*m^2*R^4*I3*(I1 - I3) */
    const double t66 = JLT_FMA(t0, t64, t61); /* s*omega_tau*omega3*s*1/Theta*m*R^2*(I1 - I3) + omega_n*gamma3*1/Theta*V*s*1/Theta*2*m^2*R^3*I1*I3 */
    const double t67 = JLT_FNMA(t59, t65, t66); /* t66 - s*1/Theta*omega_tau*omega3*s*1/Theta*gamma3*gamma3*2*m^2*R^4*I3*(I1 - I3) */
    const double t68 = t27*p[22]; /* omega_n*s*1/Theta*(-m*R*I1) */
    const double t69 = x[5]*x[0]; /* s*gamma3 */
    const double t70 = t64*t69; /* omega3*s*1/Theta*m*R^2*(I1 - I3)*s*gamma3 */
    const double t71 = JLT_FNMA(p[9], t27, t70); /* omega3*s*1/Theta*m*R^2*(I1 - I3)*s*gamma3 - m*R^2*I1*omega_n*s*1/Theta */
    const double t72 = t16*p[22]; /* V*(-m*R*I1) */
    const double t73 = t20*t72; /* s*1/Theta*V*(-m*R*I1) */
    const double t74 = t24*p[13]; /* s*omega_tau*gamma3*m*R^2*(I1 - I3) */
    const double t75 = t20*t74; /* s*1/Theta*s*omega_tau*gamma3*m*R^2*(I1 - I3) */
    const double t76 = x[3]*p[12]; /* omega_n*m*R*I1 */
    const double t77 = t17*t76; /* 1/Theta*V*omega_n*m*R*I1 */
    const double t78 = x[0]*p[23]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t79 = t20*p[24]; /* s*1/Theta*2*m^2*R^3*I1^2 */
    const double t80 = JLT_FMS(t22, t78, t77); /* omega_tau*omega3*s*1/Theta*gamma3*2*m*R^2*(I1 - I3) - 1/Theta*V*omega_n*m*R*I1 */
    const double t81 = JLT_FNMA(t28, t79, t80); /* t80 - t28*s*1/Theta*2*m^2*R^3*I1^2 */
    const double t82 = -t0; /* -s*omega_tau */
    const double t83 = -t69; /* -s*gamma3 */
    const double t84 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t85 = -t84; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t6;
    out[2] = t10;
    out[3] = t23;
    out[4] = t29;
    out[5] = t30;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t11;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t31;
    out[12] = t32;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t34;
    out[16] = t35;
    out[17] = t36;
    out[18] = t38;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = t40;
    out[22] = t42;
    out[23] = t44;
    out[24] = t50;
    out[25] = t52;
    out[26] = t54;
    out[27] = t55;
    out[28] = t57;
    out[29] = t63;
    out[30] = t67;
    out[31] = t68;
    out[32] = t71;
    out[33] = t73;
    out[34] = t75;
    out[35] = t81;
    out[36] = t82;
    out[37] = 0.0;
    out[38] = t83;
    out[39] = 0.0;
    out[40] = 0.0;
    out[41] = t85;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t2 = JLT_FMA(p[9], t0, p[8]); /* m*R^2*I1*s*s + I1*I3 */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta = gamma3*gamma3*m*R^2*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t4 = 1.0/t3; /* 1/Theta */
    const double t5 = p[28]*x[2]; /* R*(I1 - I3)*omega_tau */
    const double t6 = t0*t5; /* s*s*R*(I1 - I3)*omega_tau */
    const double t7 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t8 = JLT_FNMA(p[5], t7, t6); /* s*s*R*(I1 - I3)*omega_tau - I3*V */
    const double t9 = p[27]*x[0]; /* m*R*gamma3 */
    const double t10 = t8*t9; /* (s*s*R*(I1 - I3)*omega_tau - I3*V)*m*R*gamma3 */
    const double t11 = t4*t10; /* 1/Theta*(s*s*R*(I1 - I3)*omega_tau - I3*V)*m*R*gamma3 */
    out[0] = t11;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t2 = JLT_FMA(x[4], x[5], t1); /* omega3*s + omega_n*gamma3 */
    const double t3 = p[1]*t2; /* v_tau = R*(omega3*s + omega_n*gamma3) */
    const double t4 = JLT_FMA(t3, t3, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t5 = x[3]*x[3]; /* omega_n*omega_n */
    const double t6 = JLT_FMA(x[2], x[2], t5); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t7 = p[30]*t6; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t8 = x[4]*x[4]; /* omega3*omega3 */
    const double t9 = JLT_FMA(p[31], t8, t7); /* 1/2*I3*omega3*omega3 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t10 = JLT_FMA(p[29], t4, t9); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t9 */
    const double t11 = x[3]*p[32]; /* omega_n*R*I1 */
    const double t12 = x[5]*t11; /* s*omega_n*R*I1 */
    const double t13 = x[4]*p[33]; /* omega3*R*I3 */
    const double t14 = JLT_FNMA(x[0], t13, t12); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    const double t15 = JLT_FMA(p[1], x[2], x[1]); /* R*omega_tau + v_nu */
    const double t16 = p[34]*t15; /* m*I1^2*(R*omega_tau + v_nu) */
    const double t17 = t15*t16; /* (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    const double t18 = x[5]*p[9]; /* s*m*R^2*I1 */
    const double t19 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t20 = JLT_FMA(x[5], t18, p[8]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t21 = JLT_FMA(x[0], t19, t20); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t22 = t8*p[35]; /* omega3*omega3*(I1 - I3) */
    const double t23 = JLT_FMA(t21, t22, t17); /* Theta*omega3*omega3*(I1 - I3) + (R*omega_tau + v_nu)*m*I1^2*(R*omega_tau + v_nu) */
    out[0] = t10;
    out[1] = t14;
    out[2] = t23;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t1 = JLT_FMA(x[4], x[5], t0); /* omega3*s + omega_n*gamma3 */
    const double t2 = p[36]*t1; /* m*R^2*(omega3*s + omega_n*gamma3) */
    const double t3 = x[3]*t2; /* omega_n*m*R^2*(omega3*s + omega_n*gamma3) */
    const double t4 = p[0]*x[1]; /* m*v_nu */
    const double t5 = p[4]*x[2]; /* I1*omega_tau */
    const double t6 = x[3]*p[4]; /* omega_n*I1 */
    const double t7 = JLT_FMA(x[0], t2, t6); /* d(energy)/d(omega_n) = gamma3*m*R^2*(omega3*s + omega_n*gamma3) + omega_n*I1 */
    const double t8 = x[4]*p[5]; /* omega3*I3 */
    const double t9 = JLT_FMA(x[5], t2, t8); /* d(energy)/d(omega3) = s*m*R^2*(omega3*s + omega_n*gamma3) + omega3*I3 */
    const double t10 = x[4]*t2; /* omega3*m*R^2*(omega3*s + omega_n*gamma3) */
    const double t11 = x[4]*p[37]; /* omega3*(-R*I3) */
    const double t12 = x[5]*p[32]; /* s*R*I1 */
    const double t13 = x[0]*p[37]; /* gamma3*(-R*I3) */
    const double t14 = x[3]*p[32]; /* omega_n*R*I1 */
    const double t15 = x[4]*x[4]; /* omega3*omega3 */
    const double t16 = x[0]*p[38]; /* gamma3*2*m*R^2*I3*(I1 - I3) */
    const double t17 = t15*t16; /* omega3*omega3*gamma3*2*m*R^2*I3*(I1 - I3) */
    const double t18 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t19 = p[39]*t18; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    const double t20 = t18*p[40]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    const double t21 = x[5]*p[9]; /* s*m*R^2*I1 */
    const double t22 = x[0]*p[10]; /* gamma3*m*R^2*I3 */
    const double t23 = JLT_FMA(x[5], t21, p[8]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t24 = JLT_FMA(x[0], t22, t23); /* Theta = gamma3*gamma3*m*R^2*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t25 = x[4]*p[41]; /* omega3*(2*I1 - 2*I3) */
    const double t26 = t24*t25; /* Theta*omega3*(2*I1 - 2*I3) */
    const double t27 = x[5]*p[42]; /* s*2*m*R^2*I1*(I1 - I3) */
    const double t28 = t15*t27; /* omega3*omega3*s*2*m*R^2*I1*(I1 - I3) */
    out[0] = t3;
    out[1] = t4;
    out[2] = t5;
    out[3] = t7;
    out[4] = t9;
    out[5] = t10;
    out[6] = t11;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t12;
    out[10] = t13;
    out[11] = t14;
    out[12] = t17;
    out[13] = t19;
    out[14] = t20;
    out[15] = 0.0;
    out[16] = t26;
    out[17] = t28;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[5];
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double x5[JLT_JET_ORDER_MAX + 1];
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x5, x2, k);
        t3[k] = jlt_jet_product(x5, t2, k);
        t7[k] = jlt_jet_product(x5, x4, k);
        t9[k] = jlt_jet_product(x3, x0, k);
        t10[k] = t7[k] + t9[k];
        t11[k] = p[1]*x3[k];
        t12[k] = jlt_jet_product(t10, t11, k);
        t14[k] = t7[k]*p[6] + t9[k];
        t15[k] = jlt_jet_product(x3, t14, k);
        t16[k] = -t15[k];
        t20[k] = x5[k]*p[9];
        t22[k] = x0[k]*p[10];
        t23[k] = jlt_jet_product(x5, t20, k) + (k == 0 ? p[8] : 0);
        t24[k] = jlt_jet_product(x0, t22, k) + t23[k];
        t26[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t24, t26, k);
        t27[k] = jlt_jet_product(t7, t26, k);
        t28[k] = p[11]*t27[k] + t9[k];
        t29[k] = jlt_jet_product(x2, t28, k);
        t32[k] = x2[k]*p[1] + x1[k];
        t33[k] = jlt_jet_product(x3, t32, k);
        t34[k] = jlt_jet_product(t26, t33, k);
        t35[k] = x0[k]*p[7];
        t36[k] = t29[k] - jlt_jet_product(t34, t35, k);
        t38[k] = x5[k]*p[12];
        t39[k] = jlt_jet_product(t34, t38, k);
        t41[k] = jlt_jet_product(t2, x0, k);
        t42[k] = p[13]*t41[k];
        t43[k] = jlt_jet_product(t27, t42, k) - t39[k];
        t44[k] = -t41[k];
        double *restrict next = coefficients + (k + 1)*7;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t12[k]/(k + 1);
        next[2] = x2[k + 1] = t16[k]/(k + 1);
        next[3] = x3[k + 1] = t36[k]/(k + 1);
        next[4] = x4[k + 1] = t43[k]/(k + 1);
        next[5] = x5[k + 1] = t44[k]/(k + 1);
        next[6] = x5[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[5];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = (0.0);
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega3 = x[4];
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = params[5];
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
    out[4] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[5] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "G", "" },
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_balanced_in_regular = {
    .model = "spherical_top",
    .variant = "balanced",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 43,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 6, { 3, 18, 7, 1, 0, 0, 8, 7 }, { 12, 57, 0, 6, 0, 0, 10, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .jacobian = { jacobian, 36, { 6, 50, 18, 1, 0, 0, 10, 15 }, { 40, 250, 0, 31, 0, 0, 13, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .rhs_jacobian = { rhs_jacobian, 42, { 9, 56, 20, 1, 0, 0, 9, 18 }, { 49, 295, 0, 37, 0, 0, 13, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .divergence = { divergence, 1, { 0, 7, 4, 1, 0, 0, 5, 4 }, { 5, 23, 0, 2, 0, 0, 8, 5 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are" },
    .integral_values = { integral_values, 3, { 0, 14, 10, 0, 0, 0, 5, 5 }, { 11, 44, 0, 0, 0, 0, 9, 6 },
        "" },
    .integral_gradients = { integral_gradients, 18, { 0, 23, 6, 0, 0, 0, 4, 4 }, { 12, 69, 0, 0, 0, 0, 8, 5 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_balanced_in_regular_baseline,
        &jlt_batch_spherical_top_balanced_in_regular_avx2,
        &jlt_batch_spherical_top_balanced_in_regular_avx512,
    },
};
