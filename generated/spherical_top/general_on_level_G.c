/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   23   12    1    1    0     16    9   (83)
 *  jacobian            7   52   31    1    1    0     17   21   (327)
 *  rhs_jacobian        12   57   29    1    1    0     16   21   (379)
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
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = 1.0/t0; /* 1/(R*I1) */
    out[7] = t1;
    const double t2 = params[3]*params[3]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    out[16] = t3;
    const double t4 = t3/params[4]; /* m*a3*a3/I1 */
    out[8] = t4;
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    out[52] = t6;
    const double t7 = params[5]/t6; /* I3/(m*R*R) */
    out[9] = t7;
    const double t8 = params[4]*t5; /* I1*R*R */
    const double t9 = params[5]/t8; /* I3/(I1*R*R) */
    out[10] = t9;
    const double t10 = params[0]*params[2]; /* m*g */
    const double t11 = params[3]*t10; /* a3*m*g */
    out[23] = t11;
    const double t12 = t11/params[4]; /* a3*m*g/I1 */
    out[11] = t12;
    const double t13 = params[5]/params[4]; /* I3/I1 */
    out[12] = t13;
    const double t14 = params[3]*params[5]; /* a3*I3 */
    const double t15 = t14/t0; /* a3*I3/(R*I1) */
    out[13] = t15;
    const double t16 = params[4] - params[5]; /* I1 - I3 */
    const double t17 = t16/params[4]; /* (I1 - I3)/I1 */
    out[14] = t17;
    const double t18 = 1.0/params[1]; /* 1/R */
    out[15] = t18;
    const double t19 = params[4]*params[5]; /* I1*I3 */
    out[17] = t19;
    const double t20 = params[4]*t6; /* I1*m*R*R */
    out[18] = t20;
    const double t21 = params[0]*params[5]; /* m*I3 */
    out[19] = t21;
    const double t22 = 1.0/params[4]; /* 1/I1 */
    out[20] = t22;
    const double t23 = 2.0/t8; /* 2/(I1*R*R) */
    out[21] = t23;
    const double t24 = params[4]*params[4]; /* I1*I1 */
    const double t25 = t5*t24; /* R*R*I1*I1 */
    const double t26 = params[5]*2.0; /* I3*2 */
    const double t27 = t26/t25; /* I3*2/(R*R*I1*I1) */
    out[22] = t27;
    const double t28 = 1.0/t8; /* 1/(I1*R*R) */
    out[24] = t28;
    const double t29 = params[4]*2.0; /* I1*2 */
    out[25] = t29;
    const double t30 = params[0]*2.0; /* m*2 */
    const double t31 = t2*t30; /* a3*a3*m*2 */
    out[26] = t31;
    const double t32 = params[5]/t0; /* I3/(R*I1) */
    out[27] = t32;
    const double t33 = t26/params[1]; /* I3*2/R */
    out[28] = t33;
    const double t34 = t5*t30; /* R*R*m*2 */
    const double t35 = params[4]*t34; /* I1*R*R*m*2 */
    out[29] = t35;
    const double t36 = params[1]*t30; /* R*m*2 */
    const double t37 = params[5]*t36; /* I3*R*m*2 */
    out[30] = t37;
    const double t38 = params[1]*params[0]; /* R*m */
    const double t39 = params[3]*t38; /* a3*R*m */
    const double t40 = params[5]*t39; /* I3*a3*R*m */
    out[31] = t40;
    const double t41 = t6*t16; /* m*R*R*(I1 - I3) */
    out[32] = t41;
    const double t42 = params[0]*params[3]; /* m*a3 */
    out[33] = t42;
    const double t43 = params[4]*t38; /* I1*R*m */
    out[34] = t43;
    const double t44 = params[3]/params[1]; /* a3/R */
    out[35] = t44;
    const double t45 = params[1]*params[5]; /* R*I3 */
    out[36] = t45;
    const double t46 = t6*params[5]; /* m*R*R*I3 */
    out[37] = t46;
    const double t47 = params[1]*t24; /* R*I1*I1 */
    const double t48 = 1.0/t47; /* 1/(R*I1*I1) */
    out[38] = t48;
    const double t49 = 2.0/t0; /* 2/(R*I1) */
    out[39] = t49;
    const double t50 = t26/t24; /* I3*2/(I1*I1) */
    out[40] = t50;
    const double t51 = t45/params[4]; /* R*I3/I1 */
    out[41] = t51;
    const double t52 = t45/2.0; /* R*I3/2 */
    out[42] = t52;
    const double t53 = t26/t0; /* I3*2/(R*I1) */
    out[43] = t53;
    const double t54 = params[5]*params[5]; /* I3*I3 */
    const double t55 = t54/params[4]; /* I3*I3/I1 */
    out[44] = t55;
    const double t56 = params[5]*t34; /* I3*R*R*m*2 */
    out[45] = t56;
    const double t57 = params[5]*t38; /* I3*R*m */
    out[46] = t57;
    const double t58 = params[0]/2.0; /* m/2 */
    out[47] = t58;
    const double t59 = params[2]*2.0; /* g*2 */
    const double t60 = params[3]*t59; /* a3*g*2 */
    out[48] = t60;
    const double t61 = 1.0/params[0]; /* 1/m */
    out[49] = t61;
    const double t62 = 1.0/t20; /* 1/(I1*m*R*R) */
    out[50] = t62;
    const double t63 = params[5]/params[0]; /* I3/m */
    out[51] = t63;
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
    const double t13 = t9*t11; /* s*D/I1*1/(Theta/(m*R^2*I1)*s*D/I1) */
    const double t14 = t5*t12; /* 1/s = D/I1*1/(s*(D/I1)) */
    const double t15 = t4*t12; /* s*1/(s*(D/I1)) */
    const double t16 = p[5]*x[3]; /* I3*omega3 */
    const double t17 = JLT_FMA(t3, t16, p[6]); /* b*I3*omega3 + G_level */
    const double t18 = p[7]*t17; /* 1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t19 = t14*t18; /* omega_n = 1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t20 = t14*t19; /* 1/s*omega_n */
    const double t21 = t19*t20; /* omega_n*1/s*omega_n */
    const double t22 = t3*t21; /* b*omega_n*1/s*omega_n */
    const double t23 = x[2]*t4; /* omega_tau*s */
    out[0] = t23;
    const double t24 = x[2]*p[8]; /* omega_tau*m*a3^2/I1 */
    const double t25 = JLT_FMS(t23, t24, t21); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*1/s*omega_n */
    const double t26 = x[0]*t25; /* gamma3*(omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*1/s*omega_n) */
    const double t27 = JLT_FNMA(p[11], t4, t26); /* t26 - m*g*a3/I1*s */
    const double t28 = JLT_FNMA(x[0], p[14], p[13]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t29 = x[3]*t28; /* omega3*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t30 = t23*t29; /* omega_tau*s*omega3*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t31 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t32 = JLT_FMA(x[2], t31, x[1]); /* V = omega_tau*e + v_nu */
    const double t33 = p[15]*t32; /* 1/R*V */
    const double t34 = JLT_FMA(t19, t33, t30); /* omega_n*1/R*V + omega_tau*s*omega3*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t35 = t13*t34; /* s*D/I1*1/(Theta/(m*R^2*I1)*s*D/I1)*t34 */
    const double t36 = -t35; /* -s*D/I1*1/(Theta/(m*R^2*I1)*s*D/I1)*t34 */
    out[3] = t36;
    const double t37 = x[3]*t19; /* omega3*omega_n */
    const double t38 = JLT_FMA(p[1], t37, t22); /* R*omega3*omega_n + b*omega_n*1/s*omega_n */
    out[1] = t38;
    const double t39 = JLT_FNMA(p[12], t37, t27); /* t26 - m*g*a3/I1*s - I3/I1*omega3*omega_n */
    const double t40 = t15*t39; /* s*1/(s*(D/I1))*(t26 - m*g*a3/I1*s - I3/I1*omega3*omega_n) */
    out[2] = t40;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[16], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = p[19]*t5; /* m*I3*b */
    const double t7 = JLT_FMA(t3, p[18], p[17]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta = b*m*I3*b + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t9 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t9;
    const double t10 = t4*t9; /* D*s */
    const double t11 = t8*t10; /* Theta*D*s */
    const double t12 = 1.0/t11; /* 1/(Theta*D*s) */
    const double t13 = t8*t12; /* 1/(s*D) = Theta*1/(Theta*D*s) */
    const double t14 = t4*t13; /* 1/s = D*1/(s*D) */
    const double t15 = t0*t14; /* gamma3*omega_tau*1/s */
    const double t16 = -t15; /* -gamma3*omega_tau*1/s */
    out[0] = t16;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    const double t17 = t5*t14; /* b*1/s */
    const double t18 = p[5]*x[3]; /* I3*omega3 */
    const double t19 = JLT_FMA(t5, t18, p[6]); /* b*I3*omega3 + G_level */
    const double t20 = t14*t19; /* 1/s*(b*I3*omega3 + G_level) */
    const double t21 = t14*t20; /* 1/s*1/s*(b*I3*omega3 + G_level) */
    const double t22 = p[7]*t21; /* 1/(R*I1)*1/s*1/s*(b*I3*omega3 + G_level) */
    const double t23 = x[0]*t22; /* gamma3*1/(R*I1)*1/s*1/s*(b*I3*omega3 + G_level) */
    const double t24 = t17*t23; /* b*1/s*gamma3*1/(R*I1)*1/s*1/s*(b*I3*omega3 + G_level) */
    const double t25 = JLT_FMA(t20, p[20], t24); /* 1/s*(b*I3*omega3 + G_level)*1/I1 + b*1/s*gamma3*1/(R*I1)*1/s*1/s*(b*I3*omega3 + G_level) */
    const double t26 = t22*t25; /* 1/(R*I1)*1/s*1/s*(b*I3*omega3 + G_level)*t25 */
    const double t27 = JLT_FMA(x[3], p[12], t23); /* omega3*I3/I1 + gamma3*1/(R*I1)*1/s*1/s*(b*I3*omega3 + G_level) */
    const double t28 = t14*t27; /* d(omega_n)/d(gamma3) = 1/s*t27 */
    const double t29 = t17*t20; /* b*1/s*1/s*(b*I3*omega3 + G_level) */
    const double t30 = JLT_FMA(p[21], t29, x[3]); /* 2/(R^2*I1)*b*1/s*1/s*(b*I3*omega3 + G_level) + omega3 */
    const double t31 = p[1]*t30; /* R*(2/(R^2*I1)*b*1/s*1/s*(b*I3*omega3 + G_level) + omega3) */
    const double t32 = JLT_FMA(t28, t31, t26); /* d(omega_n)/d(gamma3)*R*(2/(R^2*I1)*b*1/s*1/s*(b*I3*omega3 + G_level) + omega3) + 1/(R*I1)*1/s*1/s*(b*I3*omega3 + G_level)*t25 */
    out[4] = t32;
    const double t33 = JLT_FMA(t17, t18, t20); /* b*1/s*I3*omega3 + 1/s*(b*I3*omega3 + G_level) */
    const double t34 = p[20]*t33; /* 1/I1*(b*1/s*I3*omega3 + 1/s*(b*I3*omega3 + G_level)) */
    const double t35 = t17*p[22]; /* b*1/s*2*I3/(R^2*I1^2) */
    const double t36 = JLT_FMA(t29, t35, t34); /* b*1/s*1/s*(b*I3*omega3 + G_level)*b*1/s*2*I3/(R^2*I1^2) + 1/I1*(b*1/s*I3*omega3 + 1/s*(b*I3*omega3 + G_level)) */
    out[7] = t36;
    const double t37 = x[2]*p[16]; /* omega_tau*m*a3^2 */
    const double t38 = JLT_FNMA(t0, t37, p[23]); /* m*g*a3 - gamma3*omega_tau*omega_tau*m*a3^2 */
    const double t39 = x[0]*t38; /* gamma3*(m*g*a3 - gamma3*omega_tau*omega_tau*m*a3^2) */
    const double t40 = t21*p[24]; /* 1/s*1/s*(b*I3*omega3 + G_level)*1/(R^2*I1) */
    const double t41 = JLT_FNMA(t21, t40, t39); /* gamma3*(m*g*a3 - gamma3*omega_tau*omega_tau*m*a3^2) - 1/s*1/s*(b*I3*omega3 + G_level)*1/s*1/s*(b*I3*omega3 + G_level)*1/(R^2*I1) */
    const double t42 = x[2]*t9; /* omega_tau*s */
    const double t43 = t37*t42; /* omega_tau*m*a3^2*omega_tau*s */
    const double t44 = JLT_FMA(t23, p[25], t18); /* gamma3*1/(R*I1)*1/s*1/s*(b*I3*omega3 + G_level)*2*I1 + I3*omega3 */
    const double t45 = JLT_FMA(t14, t41, t43); /* 1/s*t41 + omega_tau*m*a3^2*omega_tau*s */
    const double t46 = JLT_FNMA(t28, t44, t45); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = 1/s*t41 + omega_tau*m*a3^2*omega_tau*s - d(omega_n)/d(gamma3)*t44 */
    const double t47 = x[0]*t43; /* gamma3*omega_tau*m*a3^2*omega_tau*s */
    const double t48 = t20*p[15]; /* 1/s*(b*I3*omega3 + G_level)*1/R */
    const double t49 = JLT_FNMA(t9, p[23], t47); /* gamma3*omega_tau*m*a3^2*omega_tau*s - s*m*g*a3 */
    const double t50 = JLT_FNMA(t27, t48, t49); /* numerator of d(omega_tau)/dt over D = gamma3*omega_tau*m*a3^2*omega_tau*s - s*m*g*a3 - t27*1/s*(b*I3*omega3 + G_level)*1/R */
    const double t51 = t9*t13; /* 1/D = s*1/(s*D) */
    const double t52 = x[0]*p[26]; /* gamma3*2*m*a3^2 */
    const double t53 = t51*t52; /* 1/D*gamma3*2*m*a3^2 */
    const double t54 = JLT_FMA(t50, t53, t46); /* numerator of d(omega_tau)/dt over D*1/D*gamma3*2*m*a3^2 + d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    const double t55 = t51*t54; /* 1/D*t54 */
    out[8] = t55;
    const double t56 = t42*t53; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[10] = t56;
    const double t57 = t33*p[27]; /* (b*1/s*I3*omega3 + 1/s*(b*I3*omega3 + G_level))*I3/(R*I1) */
    const double t58 = JLT_FMA(t24, p[28], t57); /* b*1/s*gamma3*1/(R*I1)*1/s*1/s*(b*I3*omega3 + G_level)*2*I3/R + (b*1/s*I3*omega3 + 1/s*(b*I3*omega3 + G_level))*I3/(R*I1) */
    const double t59 = t51*t58; /* 1/D*t58 */
    const double t60 = -t59; /* -1/D*t58 */
    out[11] = t60;
    const double t61 = x[0]*p[29]; /* gamma3*2*m*R^2*I1 */
    const double t62 = JLT_FMS(t5, p[30], t61); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t63 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t64 = JLT_FMA(x[2], t63, x[1]); /* V = omega_tau*e + v_nu */
    const double t65 = t20*p[0]; /* 1/s*(b*I3*omega3 + G_level)*m */
    const double t66 = t64*t65; /* V*1/s*(b*I3*omega3 + G_level)*m */
    const double t67 = JLT_FNMA(x[0], p[32], p[31]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t68 = x[3]*t67; /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t69 = JLT_FMA(t42, t68, t66); /* omega_tau*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*1/s*(b*I3*omega3 + G_level)*m */
    const double t70 = t10*t12; /* 1/Theta = D*s*1/(Theta*D*s) */
    const double t71 = t62*t70; /* d(Theta)/d(gamma3)*1/Theta */
    const double t72 = x[2]*p[33]; /* omega_tau*m*a3 */
    const double t73 = t20*t72; /* 1/s*(b*I3*omega3 + G_level)*omega_tau*m*a3 */
    const double t74 = x[3]*p[32]; /* omega3*m*R^2*(I1 - I3) */
    const double t75 = t64*p[34]; /* V*m*R*I1 */
    const double t76 = JLT_FMS(t42, t74, t73); /* omega_tau*s*omega3*m*R^2*(I1 - I3) - 1/s*(b*I3*omega3 + G_level)*omega_tau*m*a3 */
    const double t77 = JLT_FMA(t15, t68, t76); /* gamma3*omega_tau*1/s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + t76 */
    const double t78 = JLT_FNMA(t28, t75, t77); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = t77 - d(omega_n)/d(gamma3)*V*m*R*I1 */
    const double t79 = JLT_FMA(t69, t71, t78); /* t69*d(Theta)/d(gamma3)*1/Theta + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t80 = t70*t79; /* 1/Theta*t79 */
    out[12] = t80;
    const double t81 = t65*t70; /* 1/s*(b*I3*omega3 + G_level)*m*1/Theta */
    const double t82 = -t81; /* -1/s*(b*I3*omega3 + G_level)*m*1/Theta */
    out[13] = t82;
    const double t83 = t63*t65; /* e*1/s*(b*I3*omega3 + G_level)*m */
    const double t84 = JLT_FMA(t9, t68, t83); /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*1/s*(b*I3*omega3 + G_level)*m */
    const double t85 = t70*t84; /* 1/Theta*t84 */
    const double t86 = -t85; /* -1/Theta*t84 */
    out[14] = t86;
    const double t87 = p[19]*t64; /* m*I3*V */
    const double t88 = t17*t87; /* b*1/s*m*I3*V */
    const double t89 = JLT_FMA(t42, t67, t88); /* omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + b*1/s*m*I3*V */
    const double t90 = t70*t89; /* 1/Theta*t89 */
    const double t91 = -t90; /* -1/Theta*t89 */
    out[15] = t91;
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
    const double t3 = x[0] + p[35]; /* b/R = gamma3 + a3/R */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[6] = t4;
    const double t5 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t6 = JLT_FMA(p[18], t2, p[17]); /* m*R^2*I1*(1 - gamma3)*(1 + gamma3) + I1*I3 */
    const double t7 = p[37]*t3; /* m*R^2*I3*b/R */
    const double t8 = JLT_FMA(t3, t7, t6); /* Theta = b/R*m*R^2*I3*b/R + m*R^2*I1*(1 - gamma3)*(1 + gamma3) + I1*I3 */
    const double t9 = t4*t5; /* s*D */
    const double t10 = t8*t9; /* Theta*s*D */
    const double t11 = 1.0/t10; /* 1/(Theta*s*D) */
    const double t12 = t8*t11; /* 1/(s*D) = Theta*1/(Theta*s*D) */
    const double t13 = t9*t11; /* 1/Theta = s*D*1/(Theta*s*D) */
    const double t14 = t5*t12; /* 1/s = D*1/(s*D) */
    const double t15 = t4*t12; /* 1/D = s*1/(s*D) */
    const double t16 = p[36]*x[3]; /* R*I3*omega3 */
    const double t17 = JLT_FNMA(x[0], p[32], p[31]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t18 = JLT_FMA(t3, t16, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t19 = t14*t18; /* 1/s*(b/R*R*I3*omega3 + G_level) */
    const double t20 = x[2]*p[16]; /* omega_tau*m*a3^2 */
    const double t21 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t22 = JLT_FNMA(t20, t21, p[23]); /* m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t23 = x[0]*t14; /* gamma3*1/s */
    const double t24 = x[3]*t17; /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t25 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t26 = t23*t24; /* gamma3*1/s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t27 = JLT_FNMA(p[33], t19, t26); /* gamma3*1/s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) - m*a3*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t28 = x[2]*t27; /* omega_tau*t27 */
    const double t29 = x[2]*t4; /* omega_tau*s */
    out[0] = t29;
    const double t30 = t14*t19; /* 1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t31 = t19*t23; /* 1/s*(b/R*R*I3*omega3 + G_level)*gamma3*1/s */
    const double t32 = t16 + t31; /* R*I3*omega3 + 1/s*(b/R*R*I3*omega3 + G_level)*gamma3*1/s */
    const double t33 = JLT_FMA(x[3], p[42], t31); /* omega3*1/2*R*I3 + 1/s*(b/R*R*I3*omega3 + G_level)*gamma3*1/s */
    const double t34 = p[21]*t33; /* 2/(R^2*I1)*(omega3*1/2*R*I3 + 1/s*(b/R*R*I3*omega3 + G_level)*gamma3*1/s) */
    const double t35 = JLT_FMA(x[2], t25, x[1]); /* V = omega_tau*e + v_nu */
    const double t36 = p[0]*t19; /* m*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t37 = t25*t36; /* e*m*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t38 = JLT_FMA(t4, t24, t37); /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*m*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t39 = t4*t22; /* s*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t40 = t22*t23; /* (m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3)*gamma3*1/s */
    const double t41 = JLT_FMA(t20, t29, t40); /* omega_tau*m*a3^2*omega_tau*s + (m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3)*gamma3*1/s */
    const double t42 = t13*t38; /* 1/Theta*t38 */
    const double t43 = -t42; /* -1/Theta*t38 */
    out[18] = t43;
    const double t44 = t3*t14; /* b/R*1/s */
    const double t45 = p[24]*t14; /* 1/(R^2*I1)*1/s */
    const double t46 = t30*t45; /* 1/s*1/s*(b/R*R*I3*omega3 + G_level)*1/(R^2*I1)*1/s */
    const double t47 = JLT_FNMA(t30, t46, t41); /* t41 - 1/s*1/s*(b/R*R*I3*omega3 + G_level)*1/s*1/s*(b/R*R*I3*omega3 + G_level)*1/(R^2*I1)*1/s */
    const double t48 = t14*t32; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/s*(R*I3*omega3 + 1/s*(b/R*R*I3*omega3 + G_level)*gamma3*1/s) */
    const double t49 = JLT_FNMA(t34, t48, t47); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t47 - t34*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    const double t50 = t15*t49; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    const double t51 = t3*t30; /* b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t52 = p[38]*t30; /* 1/(R*I1^2)*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t53 = t35*t36; /* V*m*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t54 = JLT_FMA(t24, t29, t53); /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*s + V*m*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t55 = t13*t54; /* 1/Theta*t54 */
    const double t56 = t13*t36; /* 1/Theta*m*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t57 = -t56; /* -1/Theta*m*1/s*(b/R*R*I3*omega3 + G_level) */
    out[17] = t57;
    const double t58 = -t55; /* -1/Theta*t54 */
    out[3] = t58;
    const double t59 = x[3]*t44; /* omega3*b/R*1/s */
    const double t60 = p[27]*t19; /* I3/(R*I1)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t61 = JLT_FMA(p[44], t59, t60); /* I3^2/I1*omega3*b/R*1/s + I3/(R*I1)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t62 = x[3]*p[32]; /* omega3*m*R^2*(I1 - I3) */
    const double t63 = JLT_FMA(t29, t62, t28); /* omega_tau*s*omega3*m*R^2*(I1 - I3) + omega_tau*t27 */
    const double t64 = p[46]*t35; /* m*R*I3*V */
    const double t65 = p[0]*t35; /* m*V */
    const double t66 = JLT_FNMA(t48, t65, t63); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = omega_tau*s*omega3*m*R^2*(I1 - I3) + omega_tau*t27 - d(omega_n)/d(gamma3)/(1/(R*I1))*m*V */
    const double t67 = t44*t64; /* b/R*1/s*m*R*I3*V */
    const double t68 = JLT_FMA(t17, t29, t67); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*s + b/R*1/s*m*R*I3*V */
    const double t69 = p[20]*t48; /* 1/I1*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    const double t70 = p[40]*t44; /* 2*I3/I1^2*b/R*1/s */
    const double t71 = t13*t68; /* 1/Theta*t68 */
    const double t72 = -t71; /* -1/Theta*t68 */
    out[19] = t72;
    const double t73 = p[24]*t19; /* 1/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t74 = JLT_FMA(t32, t73, t39); /* (R*I3*omega3 + 1/s*(b/R*R*I3*omega3 + G_level)*gamma3*1/s)*1/(R^2*I1)*1/s*(b/R*R*I3*omega3 + G_level) + s*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t75 = t15*t74; /* 1/D*t74 */
    const double t76 = -t75; /* -1/D*t74 */
    out[2] = t76;
    const double t77 = t23*t51; /* gamma3*1/s*b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t78 = JLT_FMA(p[43], t77, t61); /* 2*I3/(R*I1)*gamma3*1/s*b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) + t61 */
    const double t79 = t19 + t77; /* 1/s*(b/R*R*I3*omega3 + G_level) + gamma3*1/s*b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t80 = t52*t79; /* 1/(R*I1^2)*1/s*1/s*(b/R*R*I3*omega3 + G_level)*t79 */
    const double t81 = p[20]*t19; /* 1/I1*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t82 = x[2]*t23; /* omega_tau*gamma3*1/s */
    const double t83 = -t82; /* -omega_tau*gamma3*1/s */
    out[4] = t83;
    const double t84 = JLT_FMA(p[41], t59, t81); /* R*I3/I1*omega3*b/R*1/s + 1/I1*1/s*(b/R*R*I3*omega3 + G_level) */
    const double t85 = JLT_FMA(t51, t70, t84); /* b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level)*2*I3/I1^2*b/R*1/s + t84 */
    out[11] = t85;
    const double t86 = t15*t78; /* 1/D*t78 */
    const double t87 = -t86; /* -1/D*t78 */
    out[15] = t87;
    const double t88 = x[0]*p[29]; /* gamma3*2*m*R^2*I1 */
    const double t89 = JLT_FMS(p[45], t3, t88); /* d(Theta)/d(gamma3) = 2*m*R^2*I3*b/R - gamma3*2*m*R^2*I1 */
    const double t90 = JLT_FMA(t55, t89, t66); /* 1/Theta*t54*d(Theta)/d(gamma3) + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t91 = t13*t90; /* 1/Theta*t90 */
    out[16] = t91;
    const double t92 = x[0]*p[26]; /* gamma3*2*m*a3^2 */
    const double t93 = t15*t92; /* 1/D*gamma3*2*m*a3^2 */
    const double t94 = JLT_FNMA(t75, t93, t50); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) - 1/D*t74*1/D*gamma3*2*m*a3^2 */
    out[12] = t94;
    const double t95 = t29*t93; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[14] = t95;
    const double t96 = JLT_FMA(p[7], t51, x[3]); /* 1/(R*I1)*b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) + omega3 */
    const double t97 = t81*t96; /* 1/I1*1/s*(b/R*R*I3*omega3 + G_level)*(1/(R*I1)*b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) + omega3) */
    out[1] = t97;
    const double t98 = JLT_FMA(p[39], t51, x[3]); /* 2/(R*I1)*b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) + omega3 */
    const double t99 = JLT_FMA(t69, t98, t80); /* 1/I1*d(omega_n)/d(gamma3)/(1/(R*I1))*(2/(R*I1)*b/R*1/s*1/s*(b/R*R*I3*omega3 + G_level) + omega3) + 1/(R*I1^2)*1/s*1/s*(b/R*R*I3*omega3 + G_level)*t79 */
    out[8] = t99;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[35]; /* b/R = gamma3 + a3/R */
    const double t4 = p[12]*t3; /* I3/I1*b/R */
    const double t5 = t2 + p[9]; /* (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = JLT_FMA(t2, p[16], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t9 = t7*t8; /* s*D */
    const double t10 = t6*t9; /* Theta/(m*R^2*I1)*s*D */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s*D) */
    const double t12 = t6*t11; /* 1/(s*D) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s*D) */
    const double t13 = p[26]*t2; /* 2*m*a3^2*(1 - gamma3)*(gamma3 + 1) */
    const double t14 = t8*t12; /* 1/s = D*1/(s*D) */
    const double t15 = JLT_FMS(t12, t13, t14); /* 1/(s*D)*2*m*a3^2*(1 - gamma3)*(gamma3 + 1) - 1/s */
    const double t16 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t17 = t15*t16; /* (1/(s*D)*2*m*a3^2*(1 - gamma3)*(gamma3 + 1) - 1/s)*gamma3*omega_tau */
    const double t18 = JLT_FNMA(x[0], p[14], p[13]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t19 = x[2]*t18; /* omega_tau*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t20 = t7*t19; /* s*omega_tau*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t21 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t22 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t23 = t3*p[27]; /* b/R*I3/(R*I1) */
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
    const double t3 = x[0] + p[35]; /* b/R = gamma3 + a3/R */
    const double t4 = p[36]*x[3]; /* R*I3*omega3 */
    const double t5 = JLT_FMA(t3, t4, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t6 = p[20]*t3; /* 1/I1*b/R */
    const double t7 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t9 = t5/t7; /* (b/R*R*I3*omega3 + G_level)/s */
    const double t10 = t6*t9; /* 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s */
    const double t11 = p[48]*x[0]; /* 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(x[1], x[1], t11); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[49]*x[2]; /* 1/m*omega_tau */
    const double t14 = x[2]*t13; /* omega_tau*1/m*omega_tau */
    const double t15 = x[3]*p[51]; /* omega3*I3/m */
    const double t16 = JLT_FMA(x[3], t15, t12); /* omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t17 = JLT_FMA(t8, t14, t16); /* D*omega_tau*1/m*omega_tau + omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = p[50]*t9; /* 1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s */
    const double t19 = JLT_FMA(t9, t18, t17); /* (b/R*R*I3*omega3 + G_level)/s*1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s + t17 */
    const double t20 = x[3]*p[1]; /* omega3*R */
    const double t21 = JLT_FMA(t7, t20, t10); /* v_tau = s*omega3*R + 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s */
    const double t22 = JLT_FMA(t21, t21, t19); /* energy/(1/2*m) = v_tau*v_tau + t19 */
    const double t23 = p[47]*t22; /* 1/2*m*energy/(1/2*m) */
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
    const double t5 = JLT_FMA(p[16], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*t5; /* omega_tau*D */
    out[2] = t6;
    const double t7 = x[0] + p[35]; /* b/R = gamma3 + a3/R */
    const double t8 = x[3]*p[36]; /* omega3*R*I3 */
    const double t9 = JLT_FMA(t7, t8, p[6]); /* b/R*omega3*R*I3 + G_level */
    const double t10 = 1.0/t4; /* 1/s */
    const double t11 = t9*t10; /* (b/R*omega3*R*I3 + G_level)*1/s */
    const double t12 = p[12]*x[3]; /* I3/I1*omega3 */
    const double t13 = p[7]*t11; /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t14 = p[15]*t11; /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t15 = x[0]*t10; /* gamma3*1/s */
    const double t16 = JLT_FMA(t13, t15, t12); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*gamma3*1/s + I3/I1*omega3 */
    const double t17 = t10*t16; /* d(omega_n)/d(gamma3) = 1/s*t16 */
    const double t18 = t7*t10; /* b/R*1/s */
    const double t19 = JLT_FNMA(x[3], t15, t13); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t20 = JLT_FMA(t7, t17, t19); /* d(v_tau)/d(gamma3)/R = b/R*d(omega_n)/d(gamma3) + 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t21 = p[16]*x[0]; /* m*a3^2*gamma3 */
    const double t22 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t23 = JLT_FNMA(t21, t22, p[23]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t24 = JLT_FMA(t14, t17, t23); /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s*d(omega_n)/d(gamma3) + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t25 = t7*t13; /* b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t26 = JLT_FMA(x[3], t4, t25); /* v_tau/R = omega3*s + b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t27 = JLT_FMA(t13, t18, x[3]); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*b/R*1/s + omega3 */
    const double t28 = p[12]*t7; /* I3/I1*b/R */
    const double t29 = JLT_FMA(t18, t28, t4); /* d(v_tau)/d(omega3)/R = b/R*1/s*I3/I1*b/R + s */
    const double t30 = p[52]*t26; /* m*R^2*v_tau/R */
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
    const double t4 = x[0] + p[35]; /* b/R = gamma3 + a3/R */
    const double t5 = p[36]*x[3]; /* R*I3*omega3 */
    const double t6 = JLT_FMA(t4, t5, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t7 = p[7]*t6; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level) */
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
    double t58[JLT_JET_ORDER_MAX + 1];
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
        t31[k] = jlt_jet_product(t27, t29, k);
        t32[k] = jlt_jet_product(t23, t30, k);
        t33[k] = jlt_jet_product(t22, t30, k);
        t34[k] = p[5]*x3[k];
        t35[k] = jlt_jet_product(t21, t34, k) + (k == 0 ? p[6] : 0);
        t36[k] = p[7]*t35[k];
        t37[k] = jlt_jet_product(t32, t36, k);
        t38[k] = jlt_jet_product(t32, t37, k);
        t39[k] = jlt_jet_product(t37, t38, k);
        t40[k] = jlt_jet_product(t21, t39, k);
        t41[k] = jlt_jet_product(x2, t22, k);
        t42[k] = x2[k]*p[8];
        t43[k] = jlt_jet_product(t41, t42, k) - t39[k];
        t44[k] = jlt_jet_product(x0, t43, k);
        t45[k] = t44[k] - p[11]*t22[k];
        t46[k] = (k == 0 ? p[13] : 0) - x0[k]*p[14];
        t47[k] = jlt_jet_product(x3, t46, k);
        t48[k] = jlt_jet_product(t41, t47, k);
        t49[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t50[k] = jlt_jet_product(x2, t49, k) + x1[k];
        t51[k] = p[15]*t50[k];
        t52[k] = jlt_jet_product(t37, t51, k) + t48[k];
        t53[k] = jlt_jet_product(t31, t52, k);
        t54[k] = -t53[k];
        t55[k] = jlt_jet_product(x3, t37, k);
        t56[k] = p[1]*t55[k] + t40[k];
        t57[k] = t45[k] - p[12]*t55[k];
        t58[k] = jlt_jet_product(t33, t57, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t41[k]/(k + 1);
        next[1] = x1[k + 1] = t56[k]/(k + 1);
        next[2] = x2[k + 1] = t58[k]/(k + 1);
        next[3] = x3[k + 1] = t54[k]/(k + 1);
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
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 53,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 23, 12, 1, 1, 0, 16, 9 }, { 15, 58, 0, 9, 1, 0, 10, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 7, 52, 31, 1, 1, 0, 17, 21 }, { 47, 240, 0, 39, 1, 0, 18, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 12, 57, 29, 1, 1, 0, 16, 21 }, { 54, 277, 0, 47, 1, 0, 18, 13 },
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
