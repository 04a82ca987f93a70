/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   28   13    1    0    0     13   10   (89)
 *  jacobian            7   69   32    1    0    0     15   20   (423)
 *  rhs_jacobian        9   79   35    1    0    0     15   29   (484)
 *  divergence          0   10   10    1    0    0      8    8   (55)
 *  integral_values     0   12    9    1    0    0      7    8   (40)
 *  integral_gradients  0   19   13    1    0    0      8   11   (76)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    3    2    1    0    0      3    4   (8)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_avx512;

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
    const double t10 = params[5]/params[4]; /* I3/I1 */
    const double t11 = t3/params[4]; /* m*a3*a3/I1 */
    const double t12 = params[0]*params[2]; /* m*g */
    const double t13 = params[3]*t12; /* a3*m*g */
    const double t14 = t13/params[4]; /* a3*m*g/I1 */
    const double t15 = params[1]*params[0]; /* R*m */
    const double t16 = -t15; /* -R*m */
    const double t17 = params[3]*params[5]; /* a3*I3 */
    const double t18 = params[4] - params[5]; /* I1 - I3 */
    const double t19 = params[1]*t18; /* R*(I1 - I3) */
    const double t20 = params[5]*2.0; /* I3*2 */
    const double t21 = t20/params[4]; /* I3*2/I1 */
    const double t22 = params[1]*params[5]; /* R*I3 */
    const double t23 = t22/params[4]; /* R*I3/I1 */
    const double t24 = t20/t0; /* I3*2/(R*I1) */
    const double t25 = 2.0/t0; /* 2/(R*I1) */
    const double t26 = params[4]*params[4]; /* I1*I1 */
    const double t27 = params[5]*params[5]; /* I3*I3 */
    const double t28 = t27/t26; /* I3*I3/(I1*I1) */
    const double t29 = params[0]*2.0; /* m*2 */
    const double t30 = t2*t29; /* a3*a3*m*2 */
    const double t31 = -params[5]; /* -I3 */
    const double t32 = params[5]*(-2.0); /* I3*(-2) */
    const double t33 = t32/params[1]; /* I3*(-2)/R */
    const double t34 = t27/t0; /* I3*I3/(R*I1) */
    const double t35 = -t34; /* -I3*I3/(R*I1) */
    const double t36 = params[4]*2.0; /* I1*2 */
    const double t37 = params[2]*t29; /* g*m*2 */
    const double t38 = params[3]*t37; /* a3*g*m*2 */
    const double t39 = 2.0/params[1]; /* 2/R */
    const double t40 = params[5]*t15; /* I3*R*m */
    const double t41 = params[1]*t29; /* R*m*2 */
    const double t42 = params[4]*t41; /* I1*R*m*2 */
    const double t43 = params[3]*t15; /* a3*R*m */
    const double t44 = params[4]*t43; /* I1*a3*R*m */
    const double t45 = t6*t18; /* m*R*R*(I1 - I3) */
    const double t46 = params[0]*params[0]; /* m*m */
    const double t47 = t5*t46; /* R*R*m*m */
    const double t48 = params[5]*t47; /* I3*R*R*m*m */
    const double t49 = params[3]*2.0; /* a3*2 */
    const double t50 = params[5]*t49; /* I3*a3*2 */
    const double t51 = params[1]*2.0; /* R*2 */
    const double t52 = t18*t51; /* (I1 - I3)*R*2 */
    const double t53 = params[4]*t15; /* I1*R*m */
    const double t54 = 2.0*t46; /* 2*m*m */
    const double t55 = params[1]*t5; /* R*R*R */
    const double t56 = t54*t55; /* 2*m*m*R*R*R */
    const double t57 = t26*t56; /* I1*I1*2*m*m*R*R*R */
    const double t58 = t27/params[4]; /* I3*I3/I1 */
    const double t59 = t2*t15; /* a3*a3*R*m */
    const double t60 = params[5]*t43; /* I3*a3*R*m */
    const double t61 = params[0]/2.0; /* m/2 */
    const double t62 = params[4]/2.0; /* I1/2 */
    const double t63 = params[5]/2.0; /* I3/2 */
    const double t64 = params[5]/t0; /* I3/(R*I1) */
    const double t65 = params[5]/params[1]; /* I3/R */
    const double t66 = 1.0/params[1]; /* 1/R */
    out[7] = t1;
    out[8] = t3;
    out[9] = t4;
    out[10] = t7;
    out[11] = t8;
    out[12] = t9;
    out[13] = t10;
    out[14] = t11;
    out[15] = t14;
    out[16] = t16;
    out[17] = t17;
    out[18] = t19;
    out[19] = t21;
    out[20] = t23;
    out[21] = t24;
    out[22] = t25;
    out[23] = t28;
    out[24] = t20;
    out[25] = t30;
    out[26] = t31;
    out[27] = t33;
    out[28] = t35;
    out[29] = t36;
    out[30] = t38;
    out[31] = t39;
    out[32] = t40;
    out[33] = t42;
    out[34] = t44;
    out[35] = t45;
    out[36] = t48;
    out[37] = t50;
    out[38] = t52;
    out[39] = t53;
    out[40] = t15;
    out[41] = t57;
    out[42] = t13;
    out[43] = t58;
    out[44] = t59;
    out[45] = t60;
    out[46] = t61;
    out[47] = t62;
    out[48] = t63;
    out[49] = t64;
    out[50] = t65;
    out[51] = t66;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = p[5]*x[3]; /* I3*omega3 */
    const double t4 = JLT_FMA(t2, t3, p[6]); /* b*I3*omega3 + G_level */
    const double t5 = JLT_FMA(t0, p[8], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t2*p[11]; /* b*m*I3 */
    const double t7 = JLT_FMA(t0, p[10], p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t2, t6, t7); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t9 = x[4]*t5; /* s*D */
    const double t10 = t8*t9; /* Theta*s*D */
    const double t11 = 1.0/t10; /* 1/(Theta*s*D) */
    const double t12 = t8*t11; /* Theta*1/(Theta*s*D) */
    const double t13 = p[7]*t5; /* 1/(R*I1)*D */
    const double t14 = t4*t13; /* (b*I3*omega3 + G_level)*1/(R*I1)*D */
    const double t15 = t12*t14; /* omega_n = Theta*1/(Theta*s*D)*(b*I3*omega3 + G_level)*1/(R*I1)*D */
    const double t16 = t15*t15; /* omega_n*omega_n */
    const double t17 = t2*t16; /* b*omega_n*omega_n */
    const double t18 = x[4]*t15; /* s*omega_n */
    const double t19 = x[3]*t18; /* omega3*s*omega_n */
    const double t20 = JLT_FMA(p[1], t19, t17); /* R*omega3*s*omega_n + b*omega_n*omega_n */
    const double t21 = t19*p[13]; /* omega3*s*omega_n*I3/I1 */
    const double t22 = x[2]*p[14]; /* omega_tau*m*a3^2/I1 */
    const double t23 = JLT_FMS(t1, t22, t16); /* omega_tau*s*s*omega_tau*m*a3^2/I1 - omega_n*omega_n */
    const double t24 = JLT_FMA(t0, p[15], t21); /* s*s*m*g*a3/I1 + omega3*s*omega_n*I3/I1 */
    const double t25 = JLT_FNMA(x[0], t23, t24); /* s*s*m*g*a3/I1 + omega3*s*omega_n*I3/I1 - gamma3*(omega_tau*s*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t26 = x[4]*p[12]; /* s*(-I1) */
    const double t27 = t12*t26; /* Theta*1/(Theta*s*D)*s*(-I1) */
    const double t28 = t25*t27; /* t25*Theta*1/(Theta*s*D)*s*(-I1) */
    const double t29 = JLT_FNMA(x[0], p[18], p[17]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t30 = t1*x[3]; /* omega_tau*s*s*omega3 */
    const double t31 = t29*t30; /* (a3*I3 - gamma3*R*(I1 - I3))*omega_tau*s*s*omega3 */
    const double t32 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t33 = JLT_FMA(x[2], t32, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = p[4]*t33; /* I1*V */
    const double t35 = JLT_FMA(t18, t34, t31); /* s*omega_n*I1*V + (a3*I3 - gamma3*R*(I1 - I3))*omega_tau*s*s*omega3 */
    const double t36 = x[4]*p[16]; /* s*(-m*R) */
    const double t37 = t5*t36; /* D*s*(-m*R) */
    const double t38 = t11*t37; /* 1/(Theta*s*D)*D*s*(-m*R) */
    const double t39 = t35*t38; /* t35*1/(Theta*s*D)*D*s*(-m*R) */
    const double t40 = x[2]*x[4]; /* omega_tau*s */
    const double t41 = x[0]*t40; /* gamma3*omega_tau*s */
    const double t42 = -t41; /* -gamma3*omega_tau*s */
    out[0] = t1;
    out[1] = t20;
    out[2] = t28;
    out[3] = t39;
    out[4] = t42;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = x[3]*t3; /* omega3*b */
    const double t5 = JLT_FMA(p[5], t4, p[6]); /* I3*omega3*b + G_level */
    const double t6 = JLT_FMA(t0, p[8], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t7 = t3*p[11]; /* b*m*I3 */
    const double t8 = JLT_FMA(t0, p[10], p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(t3, t7, t8); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t10 = x[4]*t6; /* s*D */
    const double t11 = t9*t10; /* Theta*s*D */
    const double t12 = 1.0/t11; /* 1/(Theta*s*D) */
    const double t13 = t9*t12; /* Theta*1/(Theta*s*D) */
    const double t14 = t6*t13; /* D*Theta*1/(Theta*s*D) */
    const double t15 = t5*t14; /* (I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D) */
    const double t16 = p[7]*t15; /* 1/(R*I1)*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D) */
    const double t17 = t16*t16; /* 1/(R*I1)*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D)*1/(R*I1)*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D) */
    const double t18 = p[1]*t17; /* R*t17 */
    const double t19 = t14*t16; /* D*Theta*1/(Theta*s*D)*1/(R*I1)*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D) */
    const double t20 = t4*p[19]; /* omega3*b*2*I3/I1 */
    const double t21 = x[3]*x[3]; /* omega3*omega3 */
    const double t22 = JLT_FMA(p[20], t21, t18); /* R*I3/I1*omega3*omega3 + R*t17 */
    const double t23 = JLT_FMA(t19, t20, t22); /* t19*omega3*b*2*I3/I1 + R*I3/I1*omega3*omega3 + R*t17 */
    const double t24 = x[4]*p[1]; /* s*R */
    const double t25 = t16*t24; /* 1/(R*I1)*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D)*s*R */
    const double t26 = t3*t19; /* b*t19 */
    const double t27 = t3*p[21]; /* b*2*I3/(R*I1) */
    const double t28 = JLT_FMA(t4, p[13], t25); /* omega3*b*I3/I1 + 1/(R*I1)*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D)*s*R */
    const double t29 = JLT_FMA(t26, t27, t28); /* b*t19*b*2*I3/(R*I1) + t28 */
    const double t30 = t15*p[22]; /* (I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D)*2/(R*I1) */
    const double t31 = t26*t30; /* b*t19*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D)*2/(R*I1) */
    const double t32 = -t31; /* -b*t19*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D)*2/(R*I1) */
    const double t33 = x[4]*t13; /* s*Theta*1/(Theta*s*D) */
    const double t34 = x[4]*t33; /* s*s*Theta*1/(Theta*s*D) */
    const double t35 = t1*t34; /* s*omega_tau*s*s*Theta*1/(Theta*s*D) */
    const double t36 = x[2]*p[8]; /* omega_tau*m*a3^2 */
    const double t37 = t35*t36; /* s*omega_tau*s*s*Theta*1/(Theta*s*D)*omega_tau*m*a3^2 */
    const double t38 = JLT_FMA(t21, p[23], t17); /* omega3*omega3*I3^2/I1^2 + t17 */
    const double t39 = p[4]*t33; /* I1*s*Theta*1/(Theta*s*D) */
    const double t40 = x[0]*t33; /* gamma3*s*Theta*1/(Theta*s*D) */
    const double t41 = t19*t40; /* t19*gamma3*s*Theta*1/(Theta*s*D) */
    const double t42 = x[3]*p[24]; /* omega3*2*I3 */
    const double t43 = JLT_FNMA(t38, t39, t37); /* s*omega_tau*s*s*Theta*1/(Theta*s*D)*omega_tau*m*a3^2 - (omega3*omega3*I3^2/I1^2 + t17)*I1*s*Theta*1/(Theta*s*D) */
    const double t44 = JLT_FNMA(t41, t42, t43); /* t43 - t19*gamma3*s*Theta*1/(Theta*s*D)*omega3*2*I3 */
    const double t45 = t35*p[25]; /* s*omega_tau*s*s*Theta*1/(Theta*s*D)*2*m*a3^2 */
    const double t46 = x[0]*t45; /* gamma3*s*omega_tau*s*s*Theta*1/(Theta*s*D)*2*m*a3^2 */
    const double t47 = t16*t34; /* 1/(R*I1)*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D)*s*s*Theta*1/(Theta*s*D) */
    const double t48 = p[26]*t47; /* (-I3)*t47 */
    const double t49 = t3*p[27]; /* b*(-2*I3/R) */
    const double t50 = t4*p[28]; /* omega3*b*(-I3^2/(R*I1)) */
    const double t51 = JLT_FMA(t33, t50, t48); /* s*Theta*1/(Theta*s*D)*omega3*b*(-I3^2/(R*I1)) + (-I3)*t47 */
    const double t52 = JLT_FMA(t41, t49, t51); /* t19*gamma3*s*Theta*1/(Theta*s*D)*b*(-2*I3/R) + s*Theta*1/(Theta*s*D)*omega3*b*(-I3^2/(R*I1)) + (-I3)*t47 */
    const double t53 = t40*p[29]; /* gamma3*s*Theta*1/(Theta*s*D)*2*I1 */
    const double t54 = t17*t53; /* t17*gamma3*s*Theta*1/(Theta*s*D)*2*I1 */
    const double t55 = t34*p[30]; /* s*s*Theta*1/(Theta*s*D)*2*m*g*a3 */
    const double t56 = JLT_FMS(2.0, x[2], t45); /* 2*omega_tau - s*omega_tau*s*s*Theta*1/(Theta*s*D)*2*m*a3^2 */
    const double t57 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t58 = JLT_FMA(x[4], t55, t54); /* s*s*s*Theta*1/(Theta*s*D)*2*m*g*a3 + t17*gamma3*s*Theta*1/(Theta*s*D)*2*I1 */
    const double t59 = JLT_FMA(t42, t47, t58); /* omega3*2*I3*t47 + t58 */
    const double t60 = JLT_FMA(t56, t57, t59); /* (2*omega_tau - s*omega_tau*s*s*Theta*1/(Theta*s*D)*2*m*a3^2)*omega_tau*gamma3 + omega3*2*I3*t47 + t58 */
    const double t61 = p[8]*t34; /* m*a3^2*s*s*Theta*1/(Theta*s*D) */
    const double t62 = t15*p[31]; /* (I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D)*2/R */
    const double t63 = JLT_FMS(t41, t62, t55); /* t19*gamma3*s*Theta*1/(Theta*s*D)*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D)*2/R - s*s*Theta*1/(Theta*s*D)*2*m*g*a3 */
    const double t64 = JLT_FMA(t60, t61, t63); /* t60*m*a3^2*s*s*Theta*1/(Theta*s*D) + t63 */
    const double t65 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t66 = JLT_FMA(x[2], t65, x[1]); /* V = omega_tau*e + v_nu */
    const double t67 = t10*t12; /* s*D*1/(Theta*s*D) */
    const double t68 = t66*t67; /* V*s*D*1/(Theta*s*D) */
    const double t69 = x[4]*t67; /* s*s*D*1/(Theta*s*D) */
    const double t70 = t16*t69; /* 1/(R*I1)*(I3*omega3*b + G_level)*D*Theta*1/(Theta*s*D)*s*s*D*1/(Theta*s*D) */
    const double t71 = t3*p[33]; /* b*2*m*R*I1 */
    const double t72 = JLT_FNMA(t70, t71, x[3]); /* omega3 - t70*b*2*m*R*I1 */
    const double t73 = p[32]*t68; /* m*R*I3*V*s*D*1/(Theta*s*D) */
    const double t74 = x[2]*p[34]; /* omega_tau*m*R*a3*I1 */
    const double t75 = t1*t69; /* s*omega_tau*s*s*D*1/(Theta*s*D) */
    const double t76 = x[3]*p[35]; /* omega3*m*R^2*(I1 - I3) */
    const double t77 = t75*t76; /* s*omega_tau*s*s*D*1/(Theta*s*D)*omega3*m*R^2*(I1 - I3) */
    const double t78 = JLT_FNMA(x[0], p[38], p[37]); /* 2*a3*I3 - gamma3*2*R*(I1 - I3) */
    const double t79 = x[2]*p[36]; /* omega_tau*m^2*R^2*I3 */
    const double t80 = t78*t79; /* (2*a3*I3 - gamma3*2*R*(I1 - I3))*omega_tau*m^2*R^2*I3 */
    const double t81 = t4*t80; /* omega3*b*(2*a3*I3 - gamma3*2*R*(I1 - I3))*omega_tau*m^2*R^2*I3 */
    const double t82 = t69*t81; /* s*s*D*1/(Theta*s*D)*t81 */
    const double t83 = JLT_FMA(t69, t82, t77); /* s*s*D*1/(Theta*s*D)*s*s*D*1/(Theta*s*D)*t81 + s*omega_tau*s*s*D*1/(Theta*s*D)*omega3*m*R^2*(I1 - I3) */
    const double t84 = JLT_FNMA(t70, t74, t83); /* t83 - t70*omega_tau*m*R*a3*I1 */
    const double t85 = JLT_FNMA(t72, t73, t84); /* t83 - t70*omega_tau*m*R*a3*I1 - (omega3 - t70*b*2*m*R*I1)*m*R*I3*V*s*D*1/(Theta*s*D) */
    const double t86 = t70*p[39]; /* t70*m*R*I1 */
    const double t87 = -t86; /* -t70*m*R*I1 */
    const double t88 = t65*t86; /* e*t70*m*R*I1 */
    const double t89 = JLT_FNMA(x[0], p[18], p[17]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t90 = t69*p[40]; /* s*s*D*1/(Theta*s*D)*m*R */
    const double t91 = x[3]*t90; /* omega3*s*s*D*1/(Theta*s*D)*m*R */
    const double t92 = x[4]*t89; /* s*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t93 = JLT_FMA(t91, t92, t88); /* omega3*s*s*D*1/(Theta*s*D)*m*R*s*(a3*I3 - gamma3*R*(I1 - I3)) + e*t70*m*R*I1 */
    const double t94 = -t93; /* -t93 */
    const double t95 = t7*t68; /* b*m*I3*V*s*D*1/(Theta*s*D) */
    const double t96 = t1*t89; /* s*omega_tau*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t97 = JLT_FMA(t90, t96, t95); /* s*s*D*1/(Theta*s*D)*m*R*s*omega_tau*(a3*I3 - gamma3*R*(I1 - I3)) + b*m*I3*V*s*D*1/(Theta*s*D) */
    const double t98 = -t97; /* -t97 */
    const double t99 = JLT_FNMA(p[10], t75, x[2]); /* omega_tau - m*R^2*I1*s*omega_tau*s*s*D*1/(Theta*s*D) */
    const double t100 = t78*t91; /* (2*a3*I3 - gamma3*2*R*(I1 - I3))*omega3*s*s*D*1/(Theta*s*D)*m*R */
    const double t101 = t99*t100; /* (omega_tau - m*R^2*I1*s*omega_tau*s*s*D*1/(Theta*s*D))*t100 */
    const double t102 = t66*p[41]; /* V*2*m^2*R^3*I1^2 */
    const double t103 = t69*t102; /* s*s*D*1/(Theta*s*D)*V*2*m^2*R^3*I1^2 */
    const double t104 = JLT_FMS(t70, t103, t101); /* t70*s*s*D*1/(Theta*s*D)*V*2*m^2*R^3*I1^2 - (omega_tau - m*R^2*I1*s*omega_tau*s*s*D*1/(Theta*s*D))*t100 */
    const double t105 = -t1; /* -s*omega_tau */
    const double t106 = x[4]*x[0]; /* s*gamma3 */
    const double t107 = -t106; /* -s*gamma3 */
    const double t108 = -t57; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t23;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t29;
    out[9] = t32;
    out[10] = t44;
    out[11] = 0.0;
    out[12] = t46;
    out[13] = t52;
    out[14] = t64;
    out[15] = t85;
    out[16] = t87;
    out[17] = t94;
    out[18] = t98;
    out[19] = t104;
    out[20] = t105;
    out[21] = 0.0;
    out[22] = t107;
    out[23] = 0.0;
    out[24] = t108;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = t2*x[3]; /* b*omega3 */
    const double t4 = JLT_FMA(p[5], t3, p[6]); /* I3*b*omega3 + G_level */
    const double t5 = x[4]*x[4]; /* s*s */
    const double t6 = JLT_FMA(p[8], t5, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t7 = t2*p[11]; /* b*m*I3 */
    const double t8 = JLT_FMA(t5, p[10], p[9]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(t2, t7, t8); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t10 = x[4]*t6; /* s*D */
    const double t11 = t9*t10; /* Theta*s*D */
    const double t12 = 1.0/t11; /* 1/(Theta*s*D) */
    const double t13 = t9*t12; /* Theta*1/(Theta*s*D) */
    const double t14 = t6*t13; /* D*Theta*1/(Theta*s*D) */
    const double t15 = t4*t14; /* (I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D) */
    const double t16 = p[7]*t15; /* 1/(R*I1)*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D) */
    const double t17 = t16*t16; /* 1/(R*I1)*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D)*1/(R*I1)*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D) */
    const double t18 = t2*t17; /* b*t17 */
    const double t19 = x[3]*t16; /* omega3*1/(R*I1)*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D) */
    const double t20 = x[4]*p[1]; /* s*R */
    const double t21 = JLT_FMA(t19, t20, t18); /* t19*s*R + b*t17 */
    const double t22 = x[4]*t13; /* s*Theta*1/(Theta*s*D) */
    const double t23 = x[0]*t22; /* gamma3*s*Theta*1/(Theta*s*D) */
    const double t24 = t0*p[14]; /* s*omega_tau*m*a3^2/I1 */
    const double t25 = JLT_FMS(t0, t24, t17); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - t17 */
    const double t26 = p[4]*t25; /* I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - t17) */
    const double t27 = t23*t26; /* gamma3*s*Theta*1/(Theta*s*D)*I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - t17) */
    const double t28 = x[4]*t22; /* s*s*Theta*1/(Theta*s*D) */
    const double t29 = x[4]*p[42]; /* s*m*g*a3 */
    const double t30 = JLT_FMA(p[5], t19, t29); /* I3*t19 + s*m*g*a3 */
    const double t31 = JLT_FNMA(t28, t30, t27); /* t27 - s*s*Theta*1/(Theta*s*D)*(I3*t19 + s*m*g*a3) */
    const double t32 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t33 = JLT_FMA(x[2], t32, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = t10*t12; /* s*D*1/(Theta*s*D) */
    const double t35 = x[4]*t34; /* s*s*D*1/(Theta*s*D) */
    const double t36 = t16*t35; /* 1/(R*I1)*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D)*s*s*D*1/(Theta*s*D) */
    const double t37 = p[39]*t36; /* m*R*I1*t36 */
    const double t38 = t33*t37; /* V*m*R*I1*t36 */
    const double t39 = x[3]*t35; /* omega3*s*s*D*1/(Theta*s*D) */
    const double t40 = JLT_FNMA(x[0], p[18], p[17]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t41 = p[40]*t40; /* m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t42 = t39*t41; /* omega3*s*s*D*1/(Theta*s*D)*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t43 = JLT_FMA(t0, t42, t38); /* s*omega_tau*omega3*s*s*D*1/(Theta*s*D)*m*R*(a3*I3 - gamma3*R*(I1 - I3)) + V*m*R*I1*t36 */
    const double t44 = -t43; /* -t43 */
    const double t45 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t46 = -t45; /* -s*omega_tau*gamma3 */
    const double t47 = t0*2.0; /* s*omega_tau*2 */
    const double t48 = p[1]*t17; /* R*t17 */
    const double t49 = t14*t16; /* D*Theta*1/(Theta*s*D)*1/(R*I1)*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D) */
    const double t50 = t2*t49; /* b*t49 */
    const double t51 = x[3]*p[19]; /* omega3*2*I3/I1 */
    const double t52 = x[3]*p[20]; /* omega3*R*I3/I1 */
    const double t53 = JLT_FMA(x[3], t52, t48); /* omega3*omega3*R*I3/I1 + R*t17 */
    const double t54 = JLT_FMA(t50, t51, t53); /* b*t49*omega3*2*I3/I1 + omega3*omega3*R*I3/I1 + R*t17 */
    const double t55 = t16*t20; /* 1/(R*I1)*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D)*s*R */
    const double t56 = t2*p[21]; /* b*2*I3/(R*I1) */
    const double t57 = JLT_FMA(t3, p[13], t55); /* b*omega3*I3/I1 + 1/(R*I1)*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D)*s*R */
    const double t58 = JLT_FMA(t50, t56, t57); /* b*t49*b*2*I3/(R*I1) + t57 */
    const double t59 = t15*p[22]; /* (I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D)*2/(R*I1) */
    const double t60 = t50*t59; /* b*t49*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D)*2/(R*I1) */
    const double t61 = -t60; /* -b*t49*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D)*2/(R*I1) */
    const double t62 = t22*t26; /* s*Theta*1/(Theta*s*D)*I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - t17) */
    const double t63 = x[3]*p[24]; /* omega3*2*I3 */
    const double t64 = t23*t63; /* gamma3*s*Theta*1/(Theta*s*D)*omega3*2*I3 */
    const double t65 = x[3]*t22; /* omega3*s*Theta*1/(Theta*s*D) */
    const double t66 = x[3]*p[43]; /* omega3*I3^2/I1 */
    const double t67 = JLT_FNMA(t65, t66, t62); /* t62 - omega3*s*Theta*1/(Theta*s*D)*omega3*I3^2/I1 */
    const double t68 = JLT_FNMA(t49, t64, t67); /* t62 - omega3*s*Theta*1/(Theta*s*D)*omega3*I3^2/I1 - t49*gamma3*s*Theta*1/(Theta*s*D)*omega3*2*I3 */
    const double t69 = t45*p[25]; /* s*omega_tau*gamma3*2*m*a3^2 */
    const double t70 = t28*t69; /* s*s*Theta*1/(Theta*s*D)*s*omega_tau*gamma3*2*m*a3^2 */
    const double t71 = t28*p[26]; /* s*s*Theta*1/(Theta*s*D)*(-I3) */
    const double t72 = t16*t71; /* 1/(R*I1)*(I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D)*s*s*Theta*1/(Theta*s*D)*(-I3) */
    const double t73 = t23*p[27]; /* gamma3*s*Theta*1/(Theta*s*D)*(-2*I3/R) */
    const double t74 = t2*p[28]; /* b*(-I3^2/(R*I1)) */
    const double t75 = JLT_FMA(t65, t74, t72); /* omega3*s*Theta*1/(Theta*s*D)*b*(-I3^2/(R*I1)) + t72 */
    const double t76 = JLT_FMA(t50, t73, t75); /* b*t49*gamma3*s*Theta*1/(Theta*s*D)*(-2*I3/R) + omega3*s*Theta*1/(Theta*s*D)*b*(-I3^2/(R*I1)) + t72 */
    const double t77 = x[2]*p[44]; /* omega_tau*m*R*a3^2 */
    const double t78 = t0*t77; /* s*omega_tau*omega_tau*m*R*a3^2 */
    const double t79 = JLT_FMA(t15, t49, t78); /* (I3*b*omega3 + G_level)*D*Theta*1/(Theta*s*D)*t49 + s*omega_tau*omega_tau*m*R*a3^2 */
    const double t80 = t23*p[31]; /* gamma3*s*Theta*1/(Theta*s*D)*2/R */
    const double t81 = t79*t80; /* t79*gamma3*s*Theta*1/(Theta*s*D)*2/R */
    const double t82 = x[4]*p[30]; /* s*2*m*g*a3 */
    const double t83 = JLT_FMA(t19, p[24], t82); /* t19*2*I3 + s*2*m*g*a3 */
    const double t84 = t28*t83; /* s*s*Theta*1/(Theta*s*D)*(t19*2*I3 + s*2*m*g*a3) */
    const double t85 = t23*p[29]; /* gamma3*s*Theta*1/(Theta*s*D)*2*I1 */
    const double t86 = JLT_FNMA(t25, t85, t84); /* s*s*Theta*1/(Theta*s*D)*(t19*2*I3 + s*2*m*g*a3) - (s*omega_tau*s*omega_tau*m*a3^2/I1 - t17)*gamma3*s*Theta*1/(Theta*s*D)*2*I1 */
    const double t87 = p[8]*t28; /* m*a3^2*s*s*Theta*1/(Theta*s*D) */
    const double t88 = JLT_FNMA(t28, p[30], t81); /* t79*gamma3*s*Theta*1/(Theta*s*D)*2/R - s*s*Theta*1/(Theta*s*D)*2*m*g*a3 */
    const double t89 = JLT_FMA(t86, t87, t88); /* t86*m*a3^2*s*s*Theta*1/(Theta*s*D) + t88 */
    const double t90 = t33*t34; /* V*s*D*1/(Theta*s*D) */
    const double t91 = t2*p[33]; /* b*2*m*R*I1 */
    const double t92 = JLT_FNMA(t36, t91, x[3]); /* omega3 - t36*b*2*m*R*I1 */
    const double t93 = p[32]*t90; /* m*R*I3*V*s*D*1/(Theta*s*D) */
    const double t94 = x[2]*p[34]; /* omega_tau*m*R*a3*I1 */
    const double t95 = t0*p[35]; /* s*omega_tau*m*R^2*(I1 - I3) */
    const double t96 = t39*t95; /* omega3*s*s*D*1/(Theta*s*D)*s*omega_tau*m*R^2*(I1 - I3) */
    const double t97 = JLT_FNMA(x[0], p[38], p[37]); /* 2*a3*I3 - gamma3*2*R*(I1 - I3) */
    const double t98 = t39*t97; /* omega3*s*s*D*1/(Theta*s*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t99 = x[2]*p[36]; /* omega_tau*m^2*R^2*I3 */
    const double t100 = t2*t99; /* b*omega_tau*m^2*R^2*I3 */
    const double t101 = t35*t100; /* s*s*D*1/(Theta*s*D)*b*omega_tau*m^2*R^2*I3 */
    const double t102 = JLT_FMA(t98, t101, t96); /* omega3*s*s*D*1/(Theta*s*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3))*s*s*D*1/(Theta*s*D)*b*omega_tau*m^2*R^2*I3 + omega3*s*s*D*1/(Theta*s*D)*s*omega_tau*m*R^2*(I1 - I3) */
    const double t103 = JLT_FNMA(t36, t94, t102); /* t102 - t36*omega_tau*m*R*a3*I1 */
    const double t104 = JLT_FNMA(t92, t93, t103); /* t102 - t36*omega_tau*m*R*a3*I1 - (omega3 - t36*b*2*m*R*I1)*m*R*I3*V*s*D*1/(Theta*s*D) */
    const double t105 = -t37; /* -m*R*I1*t36 */
    const double t106 = t32*t37; /* e*m*R*I1*t36 */
    const double t107 = JLT_FMA(x[4], t42, t106); /* s*omega3*s*s*D*1/(Theta*s*D)*m*R*(a3*I3 - gamma3*R*(I1 - I3)) + e*m*R*I1*t36 */
    const double t108 = -t107; /* -t107 */
    const double t109 = t7*t90; /* b*m*I3*V*s*D*1/(Theta*s*D) */
    const double t110 = t0*t35; /* s*omega_tau*s*s*D*1/(Theta*s*D) */
    const double t111 = JLT_FMA(t41, t110, t109); /* m*R*(a3*I3 - gamma3*R*(I1 - I3))*s*omega_tau*s*s*D*1/(Theta*s*D) + b*m*I3*V*s*D*1/(Theta*s*D) */
    const double t112 = -t111; /* -t111 */
    const double t113 = JLT_FNMA(p[10], t110, x[2]); /* omega_tau - m*R^2*I1*s*omega_tau*s*s*D*1/(Theta*s*D) */
    const double t114 = p[40]*t98; /* m*R*omega3*s*s*D*1/(Theta*s*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t115 = t113*t114; /* (omega_tau - m*R^2*I1*s*omega_tau*s*s*D*1/(Theta*s*D))*t114 */
    const double t116 = t33*p[41]; /* V*2*m^2*R^3*I1^2 */
    const double t117 = t35*t116; /* s*s*D*1/(Theta*s*D)*V*2*m^2*R^3*I1^2 */
    const double t118 = JLT_FMS(t36, t117, t115); /* t36*s*s*D*1/(Theta*s*D)*V*2*m^2*R^3*I1^2 - (omega_tau - m*R^2*I1*s*omega_tau*s*s*D*1/(Theta*s*D))*t114 */
    const double t119 = -t0; /* -s*omega_tau */
    const double t120 = x[4]*x[0]; /* s*gamma3 */
    const double t121 = -t120; /* -s*gamma3 */
    const double t122 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t123 = -t122; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t21;
    out[2] = t31;
    out[3] = t44;
    out[4] = t46;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t5;
    out[8] = 0.0;
    out[9] = t47;
    out[10] = t54;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t58;
    out[14] = t61;
    out[15] = t68;
    out[16] = 0.0;
    out[17] = t70;
    out[18] = t76;
    out[19] = t89;
    out[20] = t104;
    out[21] = t105;
    out[22] = t108;
    out[23] = t112;
    out[24] = t118;
    out[25] = t119;
    out[26] = 0.0;
    out[27] = t121;
    out[28] = 0.0;
    out[29] = t123;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = t1*p[11]; /* b*m*I3 */
    const double t3 = JLT_FMA(p[10], t0, p[9]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t1, t2, t3); /* Theta = b*b*m*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t5 = t0*x[2]; /* s*s*omega_tau */
    const double t6 = x[0]*t5; /* gamma3*s*s*omega_tau */
    const double t7 = JLT_FMA(t0, p[8], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t8 = t4*t7; /* Theta*D */
    const double t9 = 1.0/t8; /* 1/(Theta*D) */
    const double t10 = p[25]*t6; /* 2*m*a3^2*gamma3*s*s*omega_tau */
    const double t11 = t4*t10; /* Theta*2*m*a3^2*gamma3*s*s*omega_tau */
    const double t12 = t9*t11; /* 1/(Theta*D)*Theta*2*m*a3^2*gamma3*s*s*omega_tau */
    const double t13 = t6*p[35]; /* gamma3*s*s*omega_tau*m*R^2*(I1 - I3) */
    const double t14 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t15 = JLT_FMA(x[2], t14, x[1]); /* V = omega_tau*e + v_nu */
    const double t16 = JLT_FNMA(t5, p[45], t13); /* gamma3*s*s*omega_tau*m*R^2*(I1 - I3) - s*s*omega_tau*m*R*a3*I3 */
    const double t17 = JLT_FNMA(t2, t15, t16); /* t16 - b*m*I3*V */
    const double t18 = t7*t17; /* D*(t16 - b*m*I3*V) */
    const double t19 = JLT_FNMA(x[0], x[2], t12); /* 1/(Theta*D)*Theta*2*m*a3^2*gamma3*s*s*omega_tau - gamma3*omega_tau */
    const double t20 = JLT_FMA(t9, t18, t19); /* 1/(Theta*D)*D*(t16 - b*m*I3*V) + t19 */
    out[0] = t20;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[42]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = 1.0/x[4]; /* 1/s */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[5]*x[3]; /* I3*omega3 */
    const double t5 = JLT_FMA(t3, t4, p[6]); /* b*I3*omega3 + G_level */
    const double t6 = p[7]*t2; /* 1/(R*I1)*1/s */
    const double t7 = t5*t6; /* omega_n = (b*I3*omega3 + G_level)*1/(R*I1)*1/s */
    const double t8 = t3*t7; /* b*omega_n */
    const double t9 = x[4]*p[1]; /* s*R */
    const double t10 = JLT_FMA(x[3], t9, t8); /* v_tau = omega3*s*R + b*omega_n */
    const double t11 = JLT_FMA(t10, t10, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t12 = x[4]*p[8]; /* s*m*a3^2 */
    const double t13 = JLT_FMA(x[4], t12, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t15 = x[2]*t14; /* omega_tau*1/2*omega_tau */
    const double t16 = t7*p[47]; /* omega_n*1/2*I1 */
    const double t17 = x[3]*p[48]; /* omega3*1/2*I3 */
    const double t18 = JLT_FMA(x[3], t17, t0); /* omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t19 = JLT_FMA(t13, t15, t18); /* D*omega_tau*1/2*omega_tau + omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t20 = JLT_FMA(t7, t16, t19); /* omega_n*omega_n*1/2*I1 + t19 */
    const double t21 = JLT_FMA(p[46], t11, t20); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + omega_n*omega_n*1/2*I1 + t19 */
    out[0] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[5]*x[3]; /* I3*omega3 */
    const double t1 = 1.0/x[4]; /* 1/s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = JLT_FMA(t0, t2, p[6]); /* I3*omega3*b + G_level */
    const double t4 = t1*t3; /* 1/s*(I3*omega3*b + G_level) */
    const double t5 = p[7]*t4; /* 1/(R*I1)*1/s*(I3*omega3*b + G_level) */
    const double t6 = t1*t5; /* 1/s*1/(R*I1)*1/s*(I3*omega3*b + G_level) */
    const double t7 = p[1]*t5; /* R*1/(R*I1)*1/s*(I3*omega3*b + G_level) */
    const double t8 = t1*t2; /* 1/s*b */
    const double t9 = x[3]*p[13]; /* omega3*I3/I1 */
    const double t10 = JLT_FMA(t8, t9, t7); /* d(v_tau)/d(gamma3) = 1/s*b*omega3*I3/I1 + R*1/(R*I1)*1/s*(I3*omega3*b + G_level) */
    const double t11 = t2*t5; /* b*1/(R*I1)*1/s*(I3*omega3*b + G_level) */
    const double t12 = x[4]*p[1]; /* s*R */
    const double t13 = JLT_FMA(x[3], t12, t11); /* v_tau = omega3*s*R + b*1/(R*I1)*1/s*(I3*omega3*b + G_level) */
    const double t14 = p[0]*t13; /* m*v_tau */
    const double t15 = JLT_FMA(t0, t6, p[42]); /* I3*omega3*1/s*1/(R*I1)*1/s*(I3*omega3*b + G_level) + m*g*a3 */
    const double t16 = JLT_FMA(t10, t14, t15); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau + I3*omega3*1/s*1/(R*I1)*1/s*(I3*omega3*b + G_level) + m*g*a3 */
    const double t17 = p[0]*x[1]; /* m*v_nu */
    const double t18 = x[4]*p[8]; /* s*m*a3^2 */
    const double t19 = JLT_FMA(x[4], t18, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t20 = x[2]*t19; /* omega_tau*D */
    const double t21 = t2*p[49]; /* b*I3/(R*I1) */
    const double t22 = JLT_FMA(t8, t21, t12); /* d(v_tau)/d(omega3) = 1/s*b*b*I3/(R*I1) + s*R */
    const double t23 = t8*p[50]; /* 1/s*b*I3/R */
    const double t24 = JLT_FMA(t5, t23, t0); /* 1/(R*I1)*1/s*(I3*omega3*b + G_level)*1/s*b*I3/R + I3*omega3 */
    const double t25 = JLT_FMA(t14, t22, t24); /* d(energy)/d(omega3) = m*v_tau*d(v_tau)/d(omega3) + 1/(R*I1)*1/s*(I3*omega3*b + G_level)*1/s*b*I3/R + I3*omega3 */
    const double t26 = x[3]*p[1]; /* omega3*R */
    const double t27 = JLT_FNMA(t5, t8, t26); /* d(v_tau)/d(s) = omega3*R - 1/(R*I1)*1/s*(I3*omega3*b + G_level)*1/s*b */
    const double t28 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t29 = t18*t28; /* s*m*a3^2*omega_tau*omega_tau */
    const double t30 = t4*p[51]; /* 1/s*(I3*omega3*b + G_level)*1/R */
    const double t31 = JLT_FNMA(t6, t30, t29); /* s*m*a3^2*omega_tau*omega_tau - 1/s*1/(R*I1)*1/s*(I3*omega3*b + G_level)*1/s*(I3*omega3*b + G_level)*1/R */
    const double t32 = JLT_FMA(t14, t27, t31); /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) + t31 */
    out[0] = t16;
    out[1] = t17;
    out[2] = t20;
    out[3] = t25;
    out[4] = t32;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0/x[4]; /* 1/s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = p[5]*x[3]; /* I3*omega3 */
    const double t3 = JLT_FMA(t1, t2, p[6]); /* b*I3*omega3 + G_level */
    const double t4 = p[7]*t0; /* 1/(R*I1)*1/s */
    const double t5 = t3*t4; /* (b*I3*omega3 + G_level)*1/(R*I1)*1/s */
    out[0] = t5;
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
    double t7[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
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
    double t38[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
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
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x4, k);
        t3[k] = jlt_jet_product(x2, t2, k);
        t7[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t12[k] = p[5]*x3[k];
        t13[k] = jlt_jet_product(t7, t12, k) + (k == 0 ? p[6] : 0);
        t16[k] = t2[k]*p[8] + (k == 0 ? p[4] : 0);
        t20[k] = t7[k]*p[11];
        t21[k] = t2[k]*p[10] + (k == 0 ? p[9] : 0);
        t22[k] = jlt_jet_product(t7, t20, k) + t21[k];
        t23[k] = jlt_jet_product(x4, t16, k);
        t24[k] = jlt_jet_product(t22, t23, k);
        t26[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t24, t26, k);
        t27[k] = jlt_jet_product(t22, t26, k);
        t28[k] = p[7]*t16[k];
        t29[k] = jlt_jet_product(t13, t28, k);
        t30[k] = jlt_jet_product(t27, t29, k);
        t31[k] = jlt_jet_product(t30, t30, k);
        t32[k] = jlt_jet_product(t7, t31, k);
        t33[k] = jlt_jet_product(x4, t30, k);
        t34[k] = jlt_jet_product(x3, t33, k);
        t35[k] = p[1]*t34[k] + t32[k];
        t38[k] = t2[k]*p[15];
        t41[k] = x2[k]*p[14];
        t42[k] = jlt_jet_product(t3, t41, k) - t31[k];
        t43[k] = t34[k]*p[13] + t38[k];
        t44[k] = t43[k] - jlt_jet_product(x0, t42, k);
        t45[k] = x4[k]*p[12];
        t46[k] = jlt_jet_product(t27, t45, k);
        t47[k] = jlt_jet_product(t44, t46, k);
        t51[k] = (k == 0 ? p[17] : 0) - x0[k]*p[18];
        t52[k] = jlt_jet_product(x3, t51, k);
        t53[k] = jlt_jet_product(t3, t52, k);
        t55[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t56[k] = jlt_jet_product(x2, t55, k) + x1[k];
        t57[k] = p[4]*t56[k];
        t58[k] = jlt_jet_product(t33, t57, k) + t53[k];
        t59[k] = x4[k]*p[16];
        t60[k] = jlt_jet_product(t16, t59, k);
        t61[k] = jlt_jet_product(t26, t60, k);
        t62[k] = jlt_jet_product(t58, t61, k);
        t63[k] = jlt_jet_product(x2, x4, k);
        t64[k] = jlt_jet_product(x0, t63, k);
        t65[k] = -t64[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t35[k]/(k + 1);
        next[2] = x2[k + 1] = t47[k]/(k + 1);
        next[3] = x3[k + 1] = t62[k]/(k + 1);
        next[4] = x4[k + 1] = t65[k]/(k + 1);
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
    const double v_a3 = params[3];
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
};

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 52,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 1, 28, 13, 1, 0, 0, 13, 10 }, { 15, 66, 0, 8, 0, 0, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 25, { 7, 69, 32, 1, 0, 0, 15, 20 }, { 57, 322, 0, 44, 0, 0, 16, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 9, 79, 35, 1, 0, 0, 15, 29 }, { 65, 368, 0, 51, 0, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 0, 10, 10, 1, 0, 0, 8, 8 }, { 11, 40, 0, 4, 0, 0, 11, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 1, { 0, 12, 9, 1, 0, 0, 7, 8 }, { 9, 30, 0, 1, 0, 0, 11, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 5, { 0, 19, 13, 1, 0, 0, 8, 11 }, { 15, 54, 0, 7, 0, 0, 11, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 3, 2, 1, 0, 0, 3, 4 }, { 2, 5, 0, 1, 0, 0, 5, 4 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_in_regular_on_level_G_baseline,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_avx2,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_avx512,
    },
};
