/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   26   13    1    1    0     15   11   (83)
 *  jacobian            7   57   31    1    1    0     18   21   (327)
 *  rhs_jacobian        7   64   34    1    1    0     18   28   (379)
 *  divergence          2   15   10    1    1    0     15    8   (57)
 *  integral_values     2   12    9    1    1    0      9    8   (43)
 *  integral_gradients  2   19   13    1    1    0     10   13   (72)
 *  eliminated          2    4    2    1    1    0      5    4   (11)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
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
    const double t2 = params[3]*params[3]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    const double t4 = params[4]*params[5]; /* I1*I3 */
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    const double t7 = params[4]*t6; /* I1*m*R*R */
    const double t8 = params[0]*params[5]; /* m*I3 */
    const double t9 = -params[4]; /* -I1 */
    const double t10 = params[0]*params[2]; /* m*g */
    const double t11 = params[3]*t10; /* a3*m*g */
    const double t12 = t11/params[4]; /* a3*m*g/I1 */
    const double t13 = t3/params[4]; /* m*a3*a3/I1 */
    const double t14 = params[5]/params[4]; /* I3/I1 */
    const double t15 = params[1]*params[0]; /* R*m */
    const double t16 = params[4]*t15; /* I1*R*m */
    const double t17 = -t16; /* -I1*R*m */
    const double t18 = 1.0/params[4]; /* 1/I1 */
    const double t19 = params[3]*params[5]; /* a3*I3 */
    const double t20 = params[4] - params[5]; /* I1 - I3 */
    const double t21 = params[1]*t20; /* R*(I1 - I3) */
    const double t22 = params[5]/t0; /* I3/(R*I1) */
    const double t23 = params[5]*2.0; /* I3*2 */
    const double t24 = t23/t0; /* I3*2/(R*I1) */
    const double t25 = params[0]*2.0; /* m*2 */
    const double t26 = t2*t25; /* a3*a3*m*2 */
    const double t27 = params[0]*params[0]; /* m*m */
    const double t28 = 2.0*t27; /* 2*m*m */
    const double t29 = params[2]*t28; /* g*2*m*m */
    const double t30 = params[3]*t2; /* a3*a3*a3 */
    const double t31 = t29*t30; /* g*2*m*m*a3*a3*a3 */
    const double t32 = t31/params[4]; /* g*2*m*m*a3*a3*a3/I1 */
    const double t33 = -params[5]; /* -I3 */
    const double t34 = 2.0/params[1]; /* 2/R */
    const double t35 = params[4]*params[3]; /* I1*a3 */
    const double t36 = t5*t25; /* R*R*m*2 */
    const double t37 = params[4]*t36; /* I1*R*R*m*2 */
    const double t38 = params[1]*t25; /* R*m*2 */
    const double t39 = params[5]*t38; /* I3*R*m*2 */
    const double t40 = params[1]*params[5]; /* R*I3 */
    const double t41 = params[5]*t26; /* I3*a3*a3*m*2 */
    const double t42 = t41/params[4]; /* I3*a3*a3*m*2/I1 */
    const double t43 = params[5]*(-2.0); /* I3*(-2) */
    const double t44 = t43/params[1]; /* I3*(-2)/R */
    const double t45 = t6*t20; /* m*R*R*(I1 - I3) */
    const double t46 = params[3]*t15; /* a3*R*m */
    const double t47 = params[4]*t46; /* I1*a3*R*m */
    const double t48 = params[5]*t46; /* I3*a3*R*m */
    const double t49 = params[0]/2.0; /* m/2 */
    const double t50 = params[4]/2.0; /* I1/2 */
    const double t51 = params[5]/2.0; /* I3/2 */
    const double t52 = params[5]/params[1]; /* I3/R */
    out[7] = t1;
    out[8] = t3;
    out[9] = t4;
    out[10] = t7;
    out[11] = t8;
    out[12] = t9;
    out[13] = t12;
    out[14] = t13;
    out[15] = t14;
    out[16] = t17;
    out[17] = t18;
    out[18] = t19;
    out[19] = t21;
    out[20] = t22;
    out[21] = t24;
    out[22] = t26;
    out[23] = t32;
    out[24] = t33;
    out[25] = t34;
    out[26] = t15;
    out[27] = t35;
    out[28] = t37;
    out[29] = t39;
    out[30] = t16;
    out[31] = t11;
    out[32] = t40;
    out[33] = t42;
    out[34] = t31;
    out[35] = t44;
    out[36] = t45;
    out[37] = t47;
    out[38] = t48;
    out[39] = t49;
    out[40] = t50;
    out[41] = t51;
    out[42] = t52;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = p[5]*x[3]; /* I3*omega3 */
    const double t7 = JLT_FMA(t5, t6, p[6]); /* b*I3*omega3 + G_level */
    const double t8 = JLT_FMA(t2, p[8], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t9 = t5*p[11]; /* b*m*I3 */
    const double t10 = JLT_FMA(t2, p[10], p[9]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t11 = JLT_FMA(t5, t9, t10); /* Theta = b*b*m*I3 + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t12 = t8*t11; /* D*Theta */
    const double t13 = t3*t12; /* s*D*Theta */
    const double t14 = 1.0/t13; /* 1/(s*D*Theta) */
    const double t15 = t11*t14; /* Theta*1/(s*D*Theta) */
    const double t16 = t8*t15; /* D*Theta*1/(s*D*Theta) */
    const double t17 = p[7]*t7; /* 1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t18 = t16*t17; /* omega_n = D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t19 = t16*t18; /* D*Theta*1/(s*D*Theta)*omega_n */
    const double t20 = t18*t19; /* omega_n*D*Theta*1/(s*D*Theta)*omega_n */
    const double t21 = t5*t20; /* b*omega_n*D*Theta*1/(s*D*Theta)*omega_n */
    const double t22 = x[3]*t18; /* omega3*omega_n */
    const double t23 = JLT_FMA(p[1], t22, t21); /* R*omega3*omega_n + b*omega_n*D*Theta*1/(s*D*Theta)*omega_n */
    const double t24 = t3*p[13]; /* s*m*g*a3/I1 */
    const double t25 = x[2]*p[14]; /* omega_tau*m*a3^2/I1 */
    const double t26 = JLT_FMS(t4, t25, t20); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*D*Theta*1/(s*D*Theta)*omega_n */
    const double t27 = JLT_FMA(t22, p[15], t24); /* omega3*omega_n*I3/I1 + s*m*g*a3/I1 */
    const double t28 = JLT_FNMA(x[0], t26, t27); /* omega3*omega_n*I3/I1 + s*m*g*a3/I1 - gamma3*t26 */
    const double t29 = t3*p[12]; /* s*(-I1) */
    const double t30 = t15*t29; /* Theta*1/(s*D*Theta)*s*(-I1) */
    const double t31 = t28*t30; /* (omega3*omega_n*I3/I1 + s*m*g*a3/I1 - gamma3*t26)*Theta*1/(s*D*Theta)*s*(-I1) */
    const double t32 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t33 = JLT_FMA(x[2], t32, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = t18*t33; /* omega_n*V */
    const double t35 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t36 = x[3]*p[17]; /* omega3*1/I1 */
    const double t37 = t35*t36; /* (a3*I3 - gamma3*R*(I1 - I3))*omega3*1/I1 */
    const double t38 = JLT_FMA(t4, t37, t34); /* omega_tau*s*(a3*I3 - gamma3*R*(I1 - I3))*omega3*1/I1 + omega_n*V */
    const double t39 = t8*p[16]; /* D*(-m*R*I1) */
    const double t40 = t3*t39; /* s*D*(-m*R*I1) */
    const double t41 = t14*t40; /* 1/(s*D*Theta)*s*D*(-m*R*I1) */
    const double t42 = t38*t41; /* t38*1/(s*D*Theta)*s*D*(-m*R*I1) */
    out[0] = t4;
    out[1] = t23;
    out[2] = t31;
    out[3] = t42;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[8], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = p[11]*t4; /* m*I3*b */
    const double t6 = JLT_FMA(t2, p[10], p[9]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*m*I3*b + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t8 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = t3*t7; /* D*Theta */
    const double t10 = t8*t9; /* s*D*Theta */
    const double t11 = 1.0/t10; /* 1/(s*D*Theta) */
    const double t12 = t7*t11; /* Theta*1/(s*D*Theta) */
    const double t13 = t3*t12; /* D*Theta*1/(s*D*Theta) */
    const double t14 = x[0]*t13; /* gamma3*D*Theta*1/(s*D*Theta) */
    const double t15 = x[2]*t14; /* omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t16 = -t15; /* -omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t17 = p[5]*x[3]; /* I3*omega3 */
    const double t18 = JLT_FMA(t4, t17, p[6]); /* b*I3*omega3 + G_level */
    const double t19 = p[7]*t18; /* 1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t20 = t13*t19; /* D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t21 = t13*t20; /* D*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t22 = t20*t21; /* D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level)*t21 */
    const double t23 = x[3]*p[15]; /* omega3*I3/I1 */
    const double t24 = JLT_FMA(t14, t20, t23); /* gamma3*D*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level) + omega3*I3/I1 */
    const double t25 = t13*t24; /* d(omega_n)/d(gamma3) = D*Theta*1/(s*D*Theta)*t24 */
    const double t26 = JLT_FMA(x[3], t25, t22); /* omega3*d(omega_n)/d(gamma3) + D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level)*t21 */
    const double t27 = p[1]*t26; /* R*t26 */
    const double t28 = t14*t21; /* gamma3*D*Theta*1/(s*D*Theta)*t21 */
    const double t29 = JLT_FMA(t25, 2.0, t28); /* d(omega_n)/d(gamma3)*2 + gamma3*D*Theta*1/(s*D*Theta)*t21 */
    const double t30 = t4*t13; /* b*D*Theta*1/(s*D*Theta) */
    const double t31 = t20*t30; /* D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level)*b*D*Theta*1/(s*D*Theta) */
    const double t32 = JLT_FMA(t29, t31, t27); /* (d(omega_n)/d(gamma3)*2 + gamma3*D*Theta*1/(s*D*Theta)*t21)*t31 + R*t26 */
    const double t33 = x[3]*p[20]; /* omega3*I3/(R*I1) */
    const double t34 = JLT_FMA(t30, t33, t20); /* b*D*Theta*1/(s*D*Theta)*omega3*I3/(R*I1) + D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t35 = p[1]*t34; /* R*t34 */
    const double t36 = t30*p[21]; /* b*D*Theta*1/(s*D*Theta)*2*I3/(R*I1) */
    const double t37 = JLT_FMA(t31, t36, t35); /* t31*b*D*Theta*1/(s*D*Theta)*2*I3/(R*I1) + R*t34 */
    const double t38 = x[0]*t14; /* gamma3*gamma3*D*Theta*1/(s*D*Theta) */
    const double t39 = t8*t12; /* s*Theta*1/(s*D*Theta) */
    const double t40 = x[0]*t39; /* gamma3*s*Theta*1/(s*D*Theta) */
    const double t41 = p[22]*t40; /* 2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) */
    const double t42 = JLT_FMA(x[0], t41, 1.0); /* gamma3*2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) + 1 */
    const double t43 = JLT_FNMA(t8, t42, t38); /* gamma3*gamma3*D*Theta*1/(s*D*Theta) - s*(gamma3*2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) + 1) */
    const double t44 = x[2]*p[8]; /* omega_tau*m*a3^2 */
    const double t45 = x[2]*t44; /* omega_tau*omega_tau*m*a3^2 */
    const double t46 = t43*t45; /* t43*omega_tau*omega_tau*m*a3^2 */
    const double t47 = JLT_FMA(t20, t41, t25); /* D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level)*2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) + d(omega_n)/d(gamma3) */
    const double t48 = t8*p[23]; /* s*2*m^2*g*a3^3/I1 */
    const double t49 = t40*t48; /* gamma3*s*Theta*1/(s*D*Theta)*s*2*m^2*g*a3^3/I1 */
    const double t50 = t21*t42; /* t21*(gamma3*2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) + 1) */
    const double t51 = JLT_FMA(t14, t29, t50); /* gamma3*D*Theta*1/(s*D*Theta)*(d(omega_n)/d(gamma3)*2 + gamma3*D*Theta*1/(s*D*Theta)*t21) + t21*(gamma3*2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) + 1) */
    const double t52 = JLT_FNMA(t14, p[13], t49); /* gamma3*s*Theta*1/(s*D*Theta)*s*2*m^2*g*a3^3/I1 - gamma3*D*Theta*1/(s*D*Theta)*m*g*a3/I1 */
    const double t53 = JLT_FMA(t20, t51, t52); /* D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level)*t51 + t52 */
    const double t54 = JLT_FMA(t17, t47, t46); /* I3*omega3*t47 + t43*omega_tau*omega_tau*m*a3^2 */
    const double t55 = JLT_FMA(p[4], t53, t54); /* I1*t53 + I3*omega3*t47 + t43*omega_tau*omega_tau*m*a3^2 */
    const double t56 = t39*t55; /* s*Theta*1/(s*D*Theta)*(I1*t53 + I3*omega3*t47 + t43*omega_tau*omega_tau*m*a3^2) */
    const double t57 = -t56; /* -t56 */
    const double t58 = x[2]*t8; /* omega_tau*s */
    const double t59 = t41*t58; /* 2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta)*omega_tau*s */
    const double t60 = t14*p[25]; /* gamma3*D*Theta*1/(s*D*Theta)*2/R */
    const double t61 = JLT_FMA(t31, t60, t34); /* t31*gamma3*D*Theta*1/(s*D*Theta)*2/R + t34 */
    const double t62 = t39*p[24]; /* s*Theta*1/(s*D*Theta)*(-I3) */
    const double t63 = t61*t62; /* (t31*gamma3*D*Theta*1/(s*D*Theta)*2/R + t34)*s*Theta*1/(s*D*Theta)*(-I3) */
    const double t64 = t20*p[27]; /* D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level)*a3*I1 */
    const double t65 = x[0]*p[28]; /* gamma3*2*m*R^2*I1 */
    const double t66 = JLT_FMS(t4, p[29], t65); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t67 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t68 = t3*t8; /* D*s */
    const double t69 = t11*t68; /* 1/(s*D*Theta)*D*s */
    const double t70 = t67*t69; /* (a3*I3 - gamma3*R*(I1 - I3))*1/(s*D*Theta)*D*s */
    const double t71 = JLT_FMA(t66, t70, p[19]); /* d(Theta)/d(gamma3)*(a3*I3 - gamma3*R*(I1 - I3))*1/(s*D*Theta)*D*s + R*(I1 - I3) */
    const double t72 = t8*t71; /* s*t71 */
    const double t73 = JLT_FMA(t14, t67, t72); /* gamma3*D*Theta*1/(s*D*Theta)*(a3*I3 - gamma3*R*(I1 - I3)) + s*t71 */
    const double t74 = JLT_FNMA(x[3], t73, t64); /* D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level)*a3*I1 - omega3*t73 */
    const double t75 = x[2]*p[26]; /* omega_tau*m*R */
    const double t76 = t69*t75; /* 1/(s*D*Theta)*D*s*omega_tau*m*R */
    const double t77 = t74*t76; /* t74*1/(s*D*Theta)*D*s*omega_tau*m*R */
    const double t78 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t79 = JLT_FMA(x[2], t78, x[1]); /* V = omega_tau*e + v_nu */
    const double t80 = t69*p[30]; /* 1/(s*D*Theta)*D*s*m*R*I1 */
    const double t81 = t66*t69; /* d(Theta)/d(gamma3)*1/(s*D*Theta)*D*s */
    const double t82 = JLT_FMS(t20, t81, t25); /* D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level)*d(Theta)/d(gamma3)*1/(s*D*Theta)*D*s - d(omega_n)/d(gamma3) */
    const double t83 = t79*t80; /* V*1/(s*D*Theta)*D*s*m*R*I1 */
    const double t84 = JLT_FMS(t82, t83, t77); /* t82*V*1/(s*D*Theta)*D*s*m*R*I1 - t74*1/(s*D*Theta)*D*s*omega_tau*m*R */
    const double t85 = t20*t80; /* D*Theta*1/(s*D*Theta)*1/(R*I1)*(b*I3*omega3 + G_level)*1/(s*D*Theta)*D*s*m*R*I1 */
    const double t86 = -t85; /* -t85 */
    const double t87 = t8*p[26]; /* s*m*R */
    const double t88 = t70*t87; /* (a3*I3 - gamma3*R*(I1 - I3))*1/(s*D*Theta)*D*s*s*m*R */
    const double t89 = x[3]*t88; /* omega3*(a3*I3 - gamma3*R*(I1 - I3))*1/(s*D*Theta)*D*s*s*m*R */
    const double t90 = JLT_FMA(t78, t85, t89); /* e*t85 + omega3*(a3*I3 - gamma3*R*(I1 - I3))*1/(s*D*Theta)*D*s*s*m*R */
    const double t91 = -t90; /* -t90 */
    const double t92 = p[11]*t79; /* m*I3*V */
    const double t93 = t69*t92; /* 1/(s*D*Theta)*D*s*m*I3*V */
    const double t94 = t30*t93; /* b*D*Theta*1/(s*D*Theta)*1/(s*D*Theta)*D*s*m*I3*V */
    const double t95 = JLT_FMA(x[2], t88, t94); /* omega_tau*(a3*I3 - gamma3*R*(I1 - I3))*1/(s*D*Theta)*D*s*s*m*R + b*D*Theta*1/(s*D*Theta)*1/(s*D*Theta)*D*s*m*I3*V */
    const double t96 = -t95; /* -t95 */
    out[0] = t16;
    out[1] = 0.0;
    out[2] = t8;
    out[3] = 0.0;
    out[4] = t32;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t37;
    out[8] = t57;
    out[9] = 0.0;
    out[10] = t59;
    out[11] = t63;
    out[12] = t84;
    out[13] = t86;
    out[14] = t91;
    out[15] = t96;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = p[5]*x[3]; /* I3*omega3 */
    const double t7 = JLT_FMA(t5, t6, p[6]); /* b*I3*omega3 + G_level */
    const double t8 = JLT_FMA(t2, p[8], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t9 = t5*p[11]; /* b*m*I3 */
    const double t10 = JLT_FMA(t2, p[10], p[9]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t11 = JLT_FMA(t5, t9, t10); /* Theta = b*b*m*I3 + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t12 = t8*t11; /* D*Theta */
    const double t13 = t3*t12; /* s*D*Theta */
    const double t14 = 1.0/t13; /* 1/(s*D*Theta) */
    const double t15 = t11*t14; /* Theta*1/(s*D*Theta) */
    const double t16 = t8*t15; /* D*Theta*1/(s*D*Theta) */
    const double t17 = p[7]*t16; /* 1/(R*I1)*D*Theta*1/(s*D*Theta) */
    const double t18 = t7*t17; /* omega_n = (b*I3*omega3 + G_level)*1/(R*I1)*D*Theta*1/(s*D*Theta) */
    const double t19 = t16*t18; /* D*Theta*1/(s*D*Theta)*omega_n */
    const double t20 = t5*t19; /* b*D*Theta*1/(s*D*Theta)*omega_n */
    const double t21 = t18*t20; /* omega_n*b*D*Theta*1/(s*D*Theta)*omega_n */
    const double t22 = x[3]*t18; /* omega3*omega_n */
    const double t23 = JLT_FMA(p[1], t22, t21); /* R*omega3*omega_n + omega_n*b*D*Theta*1/(s*D*Theta)*omega_n */
    const double t24 = t3*t15; /* s*Theta*1/(s*D*Theta) */
    const double t25 = x[0]*t24; /* gamma3*s*Theta*1/(s*D*Theta) */
    const double t26 = x[2]*p[14]; /* omega_tau*m*a3^2/I1 */
    const double t27 = t18*t19; /* omega_n*D*Theta*1/(s*D*Theta)*omega_n */
    const double t28 = JLT_FMS(t4, t26, t27); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*D*Theta*1/(s*D*Theta)*omega_n */
    const double t29 = p[4]*t28; /* I1*t28 */
    const double t30 = t25*t29; /* gamma3*s*Theta*1/(s*D*Theta)*I1*t28 */
    const double t31 = t3*p[31]; /* s*m*g*a3 */
    const double t32 = JLT_FMA(t6, t18, t31); /* I3*omega3*omega_n + s*m*g*a3 */
    const double t33 = JLT_FNMA(t24, t32, t30); /* gamma3*s*Theta*1/(s*D*Theta)*I1*t28 - s*Theta*1/(s*D*Theta)*(I3*omega3*omega_n + s*m*g*a3) */
    const double t34 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t35 = t4*x[3]; /* omega_tau*s*omega3 */
    const double t36 = t34*t35; /* (a3*I3 - gamma3*R*(I1 - I3))*omega_tau*s*omega3 */
    const double t37 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t38 = JLT_FMA(x[2], t37, x[1]); /* V = omega_tau*e + v_nu */
    const double t39 = p[4]*t38; /* I1*V */
    const double t40 = JLT_FMA(t18, t39, t36); /* omega_n*I1*V + (a3*I3 - gamma3*R*(I1 - I3))*omega_tau*s*omega3 */
    const double t41 = t3*t8; /* s*D */
    const double t42 = t14*t41; /* 1/(s*D*Theta)*s*D */
    const double t43 = p[26]*t42; /* m*R*1/(s*D*Theta)*s*D */
    const double t44 = t40*t43; /* t40*m*R*1/(s*D*Theta)*s*D */
    const double t45 = -t44; /* -t40*m*R*1/(s*D*Theta)*s*D */
    const double t46 = x[0]*t16; /* gamma3*D*Theta*1/(s*D*Theta) */
    const double t47 = x[2]*t46; /* omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t48 = -t47; /* -omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t49 = t7*t16; /* (b*I3*omega3 + G_level)*D*Theta*1/(s*D*Theta) */
    const double t50 = t46*t49; /* gamma3*D*Theta*1/(s*D*Theta)*(b*I3*omega3 + G_level)*D*Theta*1/(s*D*Theta) */
    const double t51 = JLT_FMA(x[3], p[32], t50); /* omega3*R*I3 + t50 */
    const double t52 = t17*t51; /* d(omega_n)/d(gamma3) = 1/(R*I1)*D*Theta*1/(s*D*Theta)*(omega3*R*I3 + t50) */
    const double t53 = JLT_FMA(x[3], t52, t27); /* omega3*d(omega_n)/d(gamma3) + omega_n*D*Theta*1/(s*D*Theta)*omega_n */
    const double t54 = p[1]*t53; /* R*t53 */
    const double t55 = t19*t46; /* D*Theta*1/(s*D*Theta)*omega_n*gamma3*D*Theta*1/(s*D*Theta) */
    const double t56 = JLT_FMA(t52, 2.0, t55); /* d(omega_n)/d(gamma3)*2 + D*Theta*1/(s*D*Theta)*omega_n*gamma3*D*Theta*1/(s*D*Theta) */
    const double t57 = JLT_FMA(t20, t56, t54); /* b*D*Theta*1/(s*D*Theta)*omega_n*t56 + R*t53 */
    const double t58 = t5*t16; /* b*D*Theta*1/(s*D*Theta) */
    const double t59 = x[3]*p[20]; /* omega3*I3/(R*I1) */
    const double t60 = JLT_FMA(t58, t59, t18); /* b*D*Theta*1/(s*D*Theta)*omega3*I3/(R*I1) + omega_n */
    const double t61 = p[1]*t60; /* R*(b*D*Theta*1/(s*D*Theta)*omega3*I3/(R*I1) + omega_n) */
    const double t62 = t58*p[21]; /* b*D*Theta*1/(s*D*Theta)*2*I3/(R*I1) */
    const double t63 = JLT_FMA(t20, t62, t61); /* b*D*Theta*1/(s*D*Theta)*omega_n*b*D*Theta*1/(s*D*Theta)*2*I3/(R*I1) + R*(b*D*Theta*1/(s*D*Theta)*omega3*I3/(R*I1) + omega_n) */
    const double t64 = t25*p[22]; /* gamma3*s*Theta*1/(s*D*Theta)*2*m*a3^2 */
    const double t65 = JLT_FMA(t25, t64, t24); /* gamma3*s*Theta*1/(s*D*Theta)*gamma3*s*Theta*1/(s*D*Theta)*2*m*a3^2 + s*Theta*1/(s*D*Theta) */
    const double t66 = t29*t65; /* I1*t28*t65 */
    const double t67 = t26*t47; /* omega_tau*m*a3^2/I1*omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t68 = t24*p[33]; /* s*Theta*1/(s*D*Theta)*2*m*a3^2*I3/I1 */
    const double t69 = JLT_FNMA(t16, p[13], t67); /* omega_tau*m*a3^2/I1*omega_tau*gamma3*D*Theta*1/(s*D*Theta) - D*Theta*1/(s*D*Theta)*m*g*a3/I1 */
    const double t70 = JLT_FMA(t22, t68, t69); /* omega3*omega_n*s*Theta*1/(s*D*Theta)*2*m*a3^2*I3/I1 + t69 */
    const double t71 = JLT_FMA(t19, t56, t70); /* D*Theta*1/(s*D*Theta)*omega_n*t56 + omega3*omega_n*s*Theta*1/(s*D*Theta)*2*m*a3^2*I3/I1 + t69 */
    const double t72 = p[4]*t25; /* I1*gamma3*s*Theta*1/(s*D*Theta) */
    const double t73 = t3*p[34]; /* s*2*m^2*g*a3^3 */
    const double t74 = t25*t73; /* gamma3*s*Theta*1/(s*D*Theta)*s*2*m^2*g*a3^3 */
    const double t75 = JLT_FMA(t6, t52, t74); /* I3*omega3*d(omega_n)/d(gamma3) + gamma3*s*Theta*1/(s*D*Theta)*s*2*m^2*g*a3^3 */
    const double t76 = JLT_FNMA(t24, t75, t66); /* I1*t28*t65 - s*Theta*1/(s*D*Theta)*t75 */
    const double t77 = JLT_FNMA(t71, t72, t76); /* I1*t28*t65 - s*Theta*1/(s*D*Theta)*t75 - t71*I1*gamma3*s*Theta*1/(s*D*Theta) */
    const double t78 = t4*t64; /* omega_tau*s*gamma3*s*Theta*1/(s*D*Theta)*2*m*a3^2 */
    const double t79 = t24*p[24]; /* s*Theta*1/(s*D*Theta)*(-I3) */
    const double t80 = t60*t79; /* (b*D*Theta*1/(s*D*Theta)*omega3*I3/(R*I1) + omega_n)*s*Theta*1/(s*D*Theta)*(-I3) */
    const double t81 = t25*p[35]; /* gamma3*s*Theta*1/(s*D*Theta)*(-2*I3/R) */
    const double t82 = t58*t81; /* b*D*Theta*1/(s*D*Theta)*gamma3*s*Theta*1/(s*D*Theta)*(-2*I3/R) */
    const double t83 = JLT_FMA(t19, t82, t80); /* D*Theta*1/(s*D*Theta)*omega_n*t82 + t80 */
    const double t84 = t35*p[36]; /* omega_tau*s*omega3*m*R^2*(I1 - I3) */
    const double t85 = x[2]*p[37]; /* omega_tau*m*R*a3*I1 */
    const double t86 = x[0]*p[28]; /* gamma3*2*m*R^2*I1 */
    const double t87 = JLT_FMS(t5, p[29], t86); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t88 = JLT_FNMA(t18, t85, t84); /* omega_tau*s*omega3*m*R^2*(I1 - I3) - omega_n*omega_tau*m*R*a3*I1 */
    const double t89 = JLT_FMA(t44, t87, t88); /* t40*m*R*1/(s*D*Theta)*s*D*d(Theta)/d(gamma3) + t88 */
    const double t90 = t34*t43; /* (a3*I3 - gamma3*R*(I1 - I3))*m*R*1/(s*D*Theta)*s*D */
    const double t91 = x[3]*t90; /* omega3*(a3*I3 - gamma3*R*(I1 - I3))*m*R*1/(s*D*Theta)*s*D */
    const double t92 = t47*t91; /* omega_tau*gamma3*D*Theta*1/(s*D*Theta)*omega3*(a3*I3 - gamma3*R*(I1 - I3))*m*R*1/(s*D*Theta)*s*D */
    const double t93 = t42*p[30]; /* 1/(s*D*Theta)*s*D*m*R*I1 */
    const double t94 = t38*t93; /* V*1/(s*D*Theta)*s*D*m*R*I1 */
    const double t95 = JLT_FNMA(t52, t94, t92); /* t92 - d(omega_n)/d(gamma3)*V*1/(s*D*Theta)*s*D*m*R*I1 */
    const double t96 = JLT_FMA(t42, t89, t95); /* 1/(s*D*Theta)*s*D*(t40*m*R*1/(s*D*Theta)*s*D*d(Theta)/d(gamma3) + t88) + t92 - d(omega_n)/d(gamma3)*V*1/(s*D*Theta)*s*D*m*R*I1 */
    const double t97 = t18*t93; /* omega_n*1/(s*D*Theta)*s*D*m*R*I1 */
    const double t98 = -t97; /* -omega_n*1/(s*D*Theta)*s*D*m*R*I1 */
    const double t99 = t3*t91; /* s*omega3*(a3*I3 - gamma3*R*(I1 - I3))*m*R*1/(s*D*Theta)*s*D */
    const double t100 = JLT_FMA(t37, t97, t99); /* e*omega_n*1/(s*D*Theta)*s*D*m*R*I1 + s*omega3*(a3*I3 - gamma3*R*(I1 - I3))*m*R*1/(s*D*Theta)*s*D */
    const double t101 = -t100; /* -t100 */
    const double t102 = p[11]*t38; /* m*I3*V */
    const double t103 = t42*t102; /* 1/(s*D*Theta)*s*D*m*I3*V */
    const double t104 = t58*t103; /* b*D*Theta*1/(s*D*Theta)*1/(s*D*Theta)*s*D*m*I3*V */
    const double t105 = JLT_FMA(t4, t90, t104); /* omega_tau*s*(a3*I3 - gamma3*R*(I1 - I3))*m*R*1/(s*D*Theta)*s*D + b*D*Theta*1/(s*D*Theta)*1/(s*D*Theta)*s*D*m*I3*V */
    const double t106 = -t105; /* -t105 */
    out[0] = t4;
    out[1] = t23;
    out[2] = t33;
    out[3] = t45;
    out[4] = t48;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t57;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t63;
    out[12] = t77;
    out[13] = 0.0;
    out[14] = t78;
    out[15] = t83;
    out[16] = t96;
    out[17] = t98;
    out[18] = t101;
    out[19] = t106;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = t4*p[11]; /* b*m*I3 */
    const double t6 = JLT_FMA(t2, p[10], p[9]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*b*m*I3 + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t2, p[8], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t9 = t7*t8; /* Theta*D */
    const double t10 = t3*t9; /* s*Theta*D */
    const double t11 = 1.0/t10; /* 1/(s*Theta*D) */
    const double t12 = t7*t11; /* Theta*1/(s*Theta*D) */
    const double t13 = p[22]*t3; /* 2*m*a3^2*s */
    const double t14 = t3*t13; /* s*2*m*a3^2*s */
    const double t15 = t3*t8; /* s*D */
    const double t16 = t11*t15; /* 1/(s*Theta*D)*s*D */
    const double t17 = t3*t16; /* s*1/(s*Theta*D)*s*D */
    const double t18 = t8*t12; /* D*Theta*1/(s*Theta*D) */
    const double t19 = JLT_FMS(t12, t14, t18); /* Theta*1/(s*Theta*D)*s*2*m*a3^2*s - D*Theta*1/(s*Theta*D) */
    const double t20 = JLT_FMA(p[36], t17, t19); /* m*R^2*(I1 - I3)*s*1/(s*Theta*D)*s*D + Theta*1/(s*Theta*D)*s*2*m*a3^2*s - D*Theta*1/(s*Theta*D) */
    const double t21 = x[0]*t20; /* gamma3*t20 */
    const double t22 = JLT_FNMA(t17, p[38], t21); /* gamma3*t20 - s*1/(s*Theta*D)*s*D*m*R*a3*I3 */
    const double t23 = x[2]*t22; /* omega_tau*(gamma3*t20 - s*1/(s*Theta*D)*s*D*m*R*a3*I3) */
    const double t24 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t25 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t26 = t5*t25; /* b*m*I3*V */
    const double t27 = t16*t26; /* 1/(s*Theta*D)*s*D*b*m*I3*V */
    const double t28 = JLT_FNMA(t18, t27, t23); /* omega_tau*(gamma3*t20 - s*1/(s*Theta*D)*s*D*m*R*a3*I3) - D*Theta*1/(s*Theta*D)*1/(s*Theta*D)*s*D*b*m*I3*V */
    out[0] = t28;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[31]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = 1.0/t5; /* 1/s */
    const double t7 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t8 = p[5]*x[3]; /* I3*omega3 */
    const double t9 = JLT_FMA(t7, t8, p[6]); /* b*I3*omega3 + G_level */
    const double t10 = p[7]*t9; /* 1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t11 = t6*t10; /* omega_n = 1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t12 = t7*t11; /* b*omega_n */
    const double t13 = x[3]*p[1]; /* omega3*R */
    const double t14 = JLT_FMA(t5, t13, t12); /* v_tau = s*omega3*R + b*omega_n */
    const double t15 = JLT_FMA(t14, t14, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t16 = JLT_FMA(t4, p[8], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t17 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t18 = x[2]*t17; /* omega_tau*1/2*omega_tau */
    const double t19 = t11*p[40]; /* omega_n*1/2*I1 */
    const double t20 = x[3]*p[41]; /* omega3*1/2*I3 */
    const double t21 = JLT_FMA(x[3], t20, t0); /* omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t22 = JLT_FMA(t16, t18, t21); /* D*omega_tau*1/2*omega_tau + omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t23 = JLT_FMA(t11, t19, t22); /* omega_n*omega_n*1/2*I1 + t22 */
    const double t24 = JLT_FMA(p[39], t15, t23); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + omega_n*omega_n*1/2*I1 + t22 */
    out[0] = t24;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[8]*x[0]; /* m*a3^2*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = 1.0/t5; /* 1/s */
    const double t7 = x[0]*t6; /* gamma3*1/s */
    const double t8 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t9 = p[5]*x[3]; /* I3*omega3 */
    const double t10 = JLT_FMA(t8, t9, p[6]); /* b*I3*omega3 + G_level */
    const double t11 = p[7]*t10; /* 1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t12 = t6*t11; /* 1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t13 = t7*t12; /* gamma3*1/s*1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t14 = JLT_FMA(x[3], p[15], t13); /* omega3*I3/I1 + gamma3*1/s*1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t15 = t6*t14; /* d(omega_n)/d(gamma3) = 1/s*t14 */
    const double t16 = p[4]*t12; /* I1*1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t17 = JLT_FMS(t7, x[3], t12); /* gamma3*1/s*omega3 - 1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t18 = p[1]*t17; /* R*(gamma3*1/s*omega3 - 1/s*1/(R*I1)*(b*I3*omega3 + G_level)) */
    const double t19 = JLT_FMS(t8, t15, t18); /* d(v_tau)/d(gamma3) = b*d(omega_n)/d(gamma3) - R*(gamma3*1/s*omega3 - 1/s*1/(R*I1)*(b*I3*omega3 + G_level)) */
    const double t20 = t8*t12; /* b*1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t21 = t5*p[1]; /* s*R */
    const double t22 = JLT_FMA(x[3], t21, t20); /* v_tau = omega3*s*R + b*1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t23 = p[0]*t22; /* m*v_tau */
    const double t24 = JLT_FNMA(t0, t1, p[31]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t25 = JLT_FMA(t15, t16, t24); /* d(omega_n)/d(gamma3)*I1*1/s*1/(R*I1)*(b*I3*omega3 + G_level) + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t26 = JLT_FMA(t19, t23, t25); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau + t25 */
    const double t27 = p[0]*x[1]; /* m*v_nu */
    const double t28 = JLT_FMA(p[8], t4, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t29 = x[2]*t28; /* omega_tau*D */
    const double t30 = t6*p[42]; /* 1/s*I3/R */
    const double t31 = t8*p[20]; /* b*I3/(R*I1) */
    const double t32 = t8*t31; /* b*b*I3/(R*I1) */
    const double t33 = JLT_FMA(t6, t32, t21); /* d(v_tau)/d(omega3) = 1/s*b*b*I3/(R*I1) + s*R */
    const double t34 = JLT_FMA(t20, t30, t9); /* b*1/s*1/(R*I1)*(b*I3*omega3 + G_level)*1/s*I3/R + I3*omega3 */
    const double t35 = JLT_FMA(t23, t33, t34); /* d(energy)/d(omega3) = m*v_tau*d(v_tau)/d(omega3) + b*1/s*1/(R*I1)*(b*I3*omega3 + G_level)*1/s*I3/R + I3*omega3 */
    out[0] = t26;
    out[1] = t27;
    out[2] = t29;
    out[3] = t35;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = 1.0/t3; /* 1/s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = p[5]*x[3]; /* I3*omega3 */
    const double t7 = JLT_FMA(t5, t6, p[6]); /* b*I3*omega3 + G_level */
    const double t8 = p[7]*t7; /* 1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t9 = t4*t8; /* 1/s*1/(R*I1)*(b*I3*omega3 + G_level) */
    out[0] = t9;
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
    double t10[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
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
    double t40[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
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
        t10[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t15[k] = p[5]*x3[k];
        t16[k] = jlt_jet_product(t10, t15, k) + (k == 0 ? p[6] : 0);
        t19[k] = t5[k]*p[8] + (k == 0 ? p[4] : 0);
        t23[k] = t10[k]*p[11];
        t24[k] = t5[k]*p[10] + (k == 0 ? p[9] : 0);
        t25[k] = jlt_jet_product(t10, t23, k) + t24[k];
        t26[k] = jlt_jet_product(t19, t25, k);
        t27[k] = jlt_jet_product(t6, t26, k);
        t28[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t27, t28, k);
        t29[k] = jlt_jet_product(t25, t28, k);
        t30[k] = jlt_jet_product(t19, t29, k);
        t31[k] = p[7]*t16[k];
        t32[k] = jlt_jet_product(t30, t31, k);
        t33[k] = jlt_jet_product(t30, t32, k);
        t34[k] = jlt_jet_product(t32, t33, k);
        t35[k] = jlt_jet_product(t10, t34, k);
        t36[k] = jlt_jet_product(x3, t32, k);
        t37[k] = p[1]*t36[k] + t35[k];
        t40[k] = t6[k]*p[13];
        t42[k] = x2[k]*p[14];
        t43[k] = jlt_jet_product(t7, t42, k) - t34[k];
        t45[k] = t36[k]*p[15] + t40[k];
        t46[k] = t45[k] - jlt_jet_product(x0, t43, k);
        t47[k] = t6[k]*p[12];
        t48[k] = jlt_jet_product(t29, t47, k);
        t49[k] = jlt_jet_product(t46, t48, k);
        t52[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t53[k] = jlt_jet_product(x2, t52, k) + x1[k];
        t54[k] = jlt_jet_product(t32, t53, k);
        t58[k] = (k == 0 ? p[18] : 0) - x0[k]*p[19];
        t59[k] = x3[k]*p[17];
        t60[k] = jlt_jet_product(t58, t59, k);
        t61[k] = jlt_jet_product(t7, t60, k) + t54[k];
        t62[k] = t19[k]*p[16];
        t63[k] = jlt_jet_product(t6, t62, k);
        t64[k] = jlt_jet_product(t28, t63, k);
        t65[k] = jlt_jet_product(t61, t64, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t37[k]/(k + 1);
        next[2] = x2[k + 1] = t49[k]/(k + 1);
        next[3] = x3[k + 1] = t65[k]/(k + 1);
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
    .state_count = 4, .param_count = 7, .block_count = 43,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 2, 26, 13, 1, 1, 0, 15, 11 }, { 15, 58, 0, 9, 1, 0, 10, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 7, 57, 31, 1, 1, 0, 18, 21 }, { 47, 240, 0, 39, 1, 0, 18, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 64, 34, 1, 1, 0, 18, 28 }, { 54, 277, 0, 47, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 15, 10, 1, 1, 0, 15, 8 }, { 12, 39, 0, 5, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 2, 12, 9, 1, 1, 0, 9, 8 }, { 10, 31, 0, 1, 1, 0, 12, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 2, 19, 13, 1, 1, 0, 10, 13 }, { 15, 50, 0, 6, 1, 0, 12, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 4, 2, 1, 1, 0, 5, 4 }, { 3, 6, 0, 1, 1, 0, 5, 4 },
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
