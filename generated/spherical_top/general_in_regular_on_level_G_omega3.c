/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   27   14    1    0    0     10   13   (85)
 *  jacobian            6   70   33    1    0    0     14   20   (397)
 *  rhs_jacobian        7   76   38    1    0    0     15   26   (454)
 *  divergence          2   16    7    1    0    0     11   10   (53)
 *  integral_values     0   12    9    1    0    0      7    8   (40)
 *  integral_gradients  0   19   13    1    0    0      8   11   (82)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          0    3    2    1    0    0      4    3   (8)
 *
 *  Accuracy: divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
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
    const double t0 = 1.0/params[5]; /* 1/I3 */
    const double t1 = params[1]*params[4]; /* R*I1 */
    const double t2 = params[3]*params[3]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    const double t4 = params[5]*params[4]; /* I3*I1 */
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    const double t7 = params[4]*t6; /* I1*m*R*R */
    const double t8 = params[5]*params[0]; /* I3*m */
    const double t9 = -params[4]; /* -I1 */
    const double t10 = params[0]*params[2]; /* m*g */
    const double t11 = params[3]*t10; /* a3*m*g */
    const double t12 = t11/params[4]; /* a3*m*g/I1 */
    const double t13 = t3/params[4]; /* m*a3*a3/I1 */
    const double t14 = params[5]/params[4]; /* I3/I1 */
    const double t15 = params[1]*params[0]; /* R*m */
    const double t16 = t5/params[5]; /* R*R/I3 */
    const double t17 = t1/params[5]; /* R*I1/I3 */
    const double t18 = params[0]*2.0; /* m*2 */
    const double t19 = t2*t18; /* a3*a3*m*2 */
    const double t20 = params[4]*2.0; /* I1*2 */
    const double t21 = params[0]*params[0]; /* m*m */
    const double t22 = 2.0*t21; /* 2*m*m */
    const double t23 = params[2]*t22; /* g*2*m*m */
    const double t24 = params[3]*t2; /* a3*a3*a3 */
    const double t25 = t23*t24; /* g*2*m*m*a3*a3*a3 */
    const double t26 = params[4]*t19; /* I1*a3*a3*m*2 */
    const double t27 = params[2]*t18; /* g*m*2 */
    const double t28 = params[3]*t27; /* a3*g*m*2 */
    const double t29 = params[5]*t19; /* I3*a3*a3*m*2 */
    const double t30 = t29/t1; /* I3*a3*a3*m*2/(R*I1) */
    const double t31 = params[3]*t15; /* a3*R*m */
    const double t32 = params[5]*t31; /* I3*a3*R*m */
    const double t33 = params[5]*t15; /* I3*R*m */
    const double t34 = params[0]*params[3]; /* m*a3 */
    const double t35 = params[5]*t34; /* I3*m*a3 */
    const double t36 = params[5]*params[5]; /* I3*I3 */
    const double t37 = t15*t36; /* R*m*I3*I3 */
    const double t38 = params[5]*2.0; /* I3*2 */
    const double t39 = params[1]*2.0; /* R*2 */
    const double t40 = params[5]/t15; /* I3/(R*m) */
    const double t41 = params[5]*t7; /* I3*I1*m*R*R */
    const double t42 = params[1]*t18; /* R*m*2 */
    const double t43 = t2*2.0; /* a3*a3*2 */
    const double t44 = params[4]*t5; /* I1*R*R */
    const double t45 = t43/t44; /* a3*a3*2/(I1*R*R) */
    const double t46 = params[0]/2.0; /* m/2 */
    const double t47 = params[4]/2.0; /* I1/2 */
    const double t48 = params[5]/2.0; /* I3/2 */
    const double t49 = t44/params[5]; /* I1*R*R/I3 */
    const double t50 = (-1.0)/params[5]; /* (-1)/I3 */
    out[7] = t0;
    out[8] = t1;
    out[9] = t3;
    out[10] = t4;
    out[11] = t7;
    out[12] = t8;
    out[13] = t9;
    out[14] = t12;
    out[15] = t13;
    out[16] = t14;
    out[17] = t15;
    out[18] = t16;
    out[19] = t17;
    out[20] = t19;
    out[21] = t20;
    out[22] = t25;
    out[23] = t26;
    out[24] = t28;
    out[25] = t30;
    out[26] = t32;
    out[27] = t33;
    out[28] = t35;
    out[29] = t37;
    out[30] = t38;
    out[31] = t39;
    out[32] = t6;
    out[33] = t40;
    out[34] = t41;
    out[35] = t11;
    out[36] = t29;
    out[37] = t42;
    out[38] = t18;
    out[39] = t45;
    out[40] = t46;
    out[41] = t47;
    out[42] = t48;
    out[43] = t49;
    out[44] = t50;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = t2*t3; /* b*omega_n*omega_n */
    const double t5 = x[4]*x[3]; /* s*omega_n */
    const double t6 = JLT_FNMA(p[8], t5, p[6]); /* G_level - R*I1*s*omega_n */
    const double t7 = x[4]*x[4]; /* s*s */
    const double t8 = JLT_FMA(p[9], t7, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t9 = t2*p[12]; /* b*m*I3 */
    const double t10 = JLT_FMA(t7, p[11], p[10]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t11 = JLT_FMA(t2, t9, t10); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t12 = t2*t8; /* b*D */
    const double t13 = t11*t12; /* Theta*b*D */
    const double t14 = 1.0/t13; /* 1/(Theta*b*D) */
    const double t15 = t11*t14; /* Theta*1/(Theta*b*D) */
    const double t16 = p[7]*t6; /* 1/I3*(G_level - R*I1*s*omega_n) */
    const double t17 = t8*t16; /* D*1/I3*(G_level - R*I1*s*omega_n) */
    const double t18 = t15*t17; /* Theta*1/(Theta*b*D)*D*1/I3*(G_level - R*I1*s*omega_n) */
    const double t19 = t5*t18; /* s*omega_n*Theta*1/(Theta*b*D)*D*1/I3*(G_level - R*I1*s*omega_n) */
    const double t20 = JLT_FNMA(p[1], t19, t4); /* b*omega_n*omega_n - R*t19 */
    const double t21 = t7*p[14]; /* s*s*m*g*a3/I1 */
    const double t22 = t0*p[15]; /* s*omega_tau*m*a3^2/I1 */
    const double t23 = JLT_FNMA(t0, t22, t3); /* omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t24 = JLT_FMA(x[0], t23, t21); /* gamma3*(omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1) + s*s*m*g*a3/I1 */
    const double t25 = JLT_FNMA(t19, p[16], t24); /* t24 - t19*I3/I1 */
    const double t26 = t2*p[13]; /* b*(-I1) */
    const double t27 = t15*t26; /* Theta*1/(Theta*b*D)*b*(-I1) */
    const double t28 = t25*t27; /* (t24 - t19*I3/I1)*Theta*1/(Theta*b*D)*b*(-I1) */
    const double t29 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t30 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t31 = JLT_FMA(x[2], t30, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = t12*t14; /* b*D*1/(Theta*b*D) */
    const double t33 = t9*t31; /* b*m*I3*V */
    const double t34 = JLT_FNMA(t32, t33, t29); /* omega_tau*gamma3 - b*D*1/(Theta*b*D)*b*m*I3*V */
    const double t35 = x[3]*t34; /* omega_n*(omega_tau*gamma3 - b*D*1/(Theta*b*D)*b*m*I3*V) */
    const double t36 = JLT_FMA(t30, p[17], p[5]); /* e*m*R + I3 */
    const double t37 = t0*p[5]; /* s*omega_tau*I3 */
    const double t38 = t36*t37; /* (e*m*R + I3)*s*omega_tau*I3 */
    const double t39 = t32*t38; /* b*D*1/(Theta*b*D)*(e*m*R + I3)*s*omega_tau*I3 */
    const double t40 = JLT_FNMA(t18, t39, t35); /* omega_n*(omega_tau*gamma3 - b*D*1/(Theta*b*D)*b*m*I3*V) - Theta*1/(Theta*b*D)*D*1/I3*(G_level - R*I1*s*omega_n)*b*D*1/(Theta*b*D)*(e*m*R + I3)*s*omega_tau*I3 */
    const double t41 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t42 = -t41; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t20;
    out[2] = t28;
    out[3] = t40;
    out[4] = t42;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = x[3]*p[8]; /* omega_n*R*I1 */
    const double t6 = JLT_FNMA(x[4], t5, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t7 = JLT_FMA(t0, p[9], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t8 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t9 = p[12]*t8; /* m*I3*b */
    const double t10 = JLT_FMA(t0, p[11], p[10]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t11 = JLT_FMA(t8, t9, t10); /* Theta = b*m*I3*b + s*s*m*R^2*I1 + I1*I3 */
    const double t12 = t7*t8; /* D*b */
    const double t13 = t11*t12; /* Theta*D*b */
    const double t14 = 1.0/t13; /* 1/(Theta*D*b) */
    const double t15 = t11*t14; /* Theta*1/(Theta*D*b) */
    const double t16 = t7*t15; /* D*Theta*1/(Theta*D*b) */
    const double t17 = t6*t16; /* (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b) */
    const double t18 = x[3]*t16; /* omega_n*D*Theta*1/(Theta*D*b) */
    const double t19 = x[4]*t18; /* s*omega_n*D*Theta*1/(Theta*D*b) */
    const double t20 = p[18]*t17; /* R^2/I3*(G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b) */
    const double t21 = JLT_FMA(t19, t20, t4); /* s*omega_n*D*Theta*1/(Theta*D*b)*R^2/I3*(G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b) + R*omega_n*omega_n */
    const double t22 = x[3]*t8; /* omega_n*b */
    const double t23 = 2.0*t22; /* 2*omega_n*b */
    const double t24 = t17*p[7]; /* (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*1/I3 */
    const double t25 = JLT_FMS(t19, p[19], t24); /* s*omega_n*D*Theta*1/(Theta*D*b)*R*I1/I3 - (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*1/I3 */
    const double t26 = p[1]*t25; /* R*t25 */
    const double t27 = JLT_FMA(x[4], t26, t23); /* s*R*t25 + 2*omega_n*b */
    const double t28 = x[3]*t26; /* omega_n*R*t25 */
    const double t29 = t1*p[15]; /* s*omega_tau*m*a3^2/I1 */
    const double t30 = JLT_FMS(t1, t29, t3); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n */
    const double t31 = t8*t15; /* b*Theta*1/(Theta*D*b) */
    const double t32 = p[4]*t30; /* I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t33 = t31*t32; /* b*Theta*1/(Theta*D*b)*I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t34 = x[4]*t31; /* s*b*Theta*1/(Theta*D*b) */
    const double t35 = p[1]*t34; /* R*s*b*Theta*1/(Theta*D*b) */
    const double t36 = t17*t18; /* (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*omega_n*D*Theta*1/(Theta*D*b) */
    const double t37 = JLT_FNMA(t35, t36, t33); /* t33 - R*s*b*Theta*1/(Theta*D*b)*t36 */
    const double t38 = t1*p[20]; /* s*omega_tau*2*m*a3^2 */
    const double t39 = x[0]*t38; /* gamma3*s*omega_tau*2*m*a3^2 */
    const double t40 = t34*t39; /* s*b*Theta*1/(Theta*D*b)*gamma3*s*omega_tau*2*m*a3^2 */
    const double t41 = x[0]*t31; /* gamma3*b*Theta*1/(Theta*D*b) */
    const double t42 = x[3]*p[21]; /* omega_n*2*I1 */
    const double t43 = t41*t42; /* gamma3*b*Theta*1/(Theta*D*b)*omega_n*2*I1 */
    const double t44 = t24*p[5]; /* (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*1/I3*I3 */
    const double t45 = JLT_FMS(p[8], t19, t44); /* R*I1*s*omega_n*D*Theta*1/(Theta*D*b) - (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*1/I3*I3 */
    const double t46 = JLT_FMA(t34, t45, t43); /* s*b*Theta*1/(Theta*D*b)*t45 + gamma3*b*Theta*1/(Theta*D*b)*omega_n*2*I1 */
    const double t47 = -t46; /* -t46 */
    const double t48 = x[2]*t38; /* omega_tau*s*omega_tau*2*m*a3^2 */
    const double t49 = t41*t48; /* gamma3*b*Theta*1/(Theta*D*b)*omega_tau*s*omega_tau*2*m*a3^2 */
    const double t50 = x[4]*p[22]; /* s*2*m^2*g*a3^3 */
    const double t51 = t30*p[23]; /* (s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n)*2*m*a3^2*I1 */
    const double t52 = t34*p[25]; /* s*b*Theta*1/(Theta*D*b)*2*m*a3^2*I3/(R*I1) */
    const double t53 = JLT_FMA(t24, t52, t18); /* (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*1/I3*s*b*Theta*1/(Theta*D*b)*2*m*a3^2*I3/(R*I1) + omega_n*D*Theta*1/(Theta*D*b) */
    const double t54 = JLT_FMS(t34, t50, p[24]); /* s*b*Theta*1/(Theta*D*b)*s*2*m^2*g*a3^3 - 2*m*g*a3 */
    const double t55 = JLT_FNMA(t41, t51, t54); /* s*b*Theta*1/(Theta*D*b)*s*2*m^2*g*a3^3 - 2*m*g*a3 - gamma3*b*Theta*1/(Theta*D*b)*t51 */
    const double t56 = JLT_FNMA(t5, t53, t55); /* t55 - omega_n*R*I1*t53 */
    const double t57 = x[3]*t31; /* omega_n*b*Theta*1/(Theta*D*b) */
    const double t58 = JLT_FMA(t44, t57, t49); /* (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*1/I3*I3*omega_n*b*Theta*1/(Theta*D*b) + gamma3*b*Theta*1/(Theta*D*b)*omega_tau*s*omega_tau*2*m*a3^2 */
    const double t59 = JLT_FMA(t34, t56, t58); /* s*b*Theta*1/(Theta*D*b)*(t55 - omega_n*R*I1*t53) + t58 */
    const double t60 = t12*t14; /* D*b*1/(Theta*D*b) */
    const double t61 = t1*t60; /* s*omega_tau*D*b*1/(Theta*D*b) */
    const double t62 = p[26]*t61; /* m*R*a3*I3*s*omega_tau*D*b*1/(Theta*D*b) */
    const double t63 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t64 = JLT_FMA(x[2], t63, x[1]); /* V = omega_tau*e + v_nu */
    const double t65 = p[27]*t64; /* m*R*I3*V */
    const double t66 = JLT_FNMA(t60, t65, x[2]); /* omega_tau - D*b*1/(Theta*D*b)*m*R*I3*V */
    const double t67 = x[3]*t66; /* omega_n*(omega_tau - D*b*1/(Theta*D*b)*m*R*I3*V) */
    const double t68 = x[2]*p[28]; /* omega_tau*m*a3*I3 */
    const double t69 = t22*t68; /* omega_n*b*omega_tau*m*a3*I3 */
    const double t70 = t1*t24; /* s*omega_tau*(G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*1/I3 */
    const double t71 = p[30]*t70; /* 2*I3*t70 */
    const double t72 = t23*t64; /* 2*omega_n*b*V */
    const double t73 = t63*p[31]; /* e*2*R */
    const double t74 = JLT_FMA(t70, t73, t72); /* t70*e*2*R + 2*omega_n*b*V */
    const double t75 = JLT_FMA(p[0], t74, t71); /* m*(t70*e*2*R + 2*omega_n*b*V) + 2*I3*t70 */
    const double t76 = t60*t60; /* D*b*1/(Theta*D*b)*D*b*1/(Theta*D*b) */
    const double t77 = t75*t76; /* (m*(t70*e*2*R + 2*omega_n*b*V) + 2*I3*t70)*D*b*1/(Theta*D*b)*D*b*1/(Theta*D*b) */
    const double t78 = t8*p[29]; /* b*m*R*I3^2 */
    const double t79 = t63 + p[33]; /* e + I3/(m*R) */
    const double t80 = t61*t79; /* s*omega_tau*D*b*1/(Theta*D*b)*(e + I3/(m*R)) */
    const double t81 = t16*t80; /* D*Theta*1/(Theta*D*b)*s*omega_tau*D*b*1/(Theta*D*b)*(e + I3/(m*R)) */
    const double t82 = t17*p[32]; /* (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*m*R^2 */
    const double t83 = JLT_FNMA(t60, t69, t67); /* omega_n*(omega_tau - D*b*1/(Theta*D*b)*m*R*I3*V) - D*b*1/(Theta*D*b)*omega_n*b*omega_tau*m*a3*I3 */
    const double t84 = JLT_FNMA(t24, t62, t83); /* t83 - (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*1/I3*m*R*a3*I3*s*omega_tau*D*b*1/(Theta*D*b) */
    const double t85 = JLT_FMA(t81, t82, t84); /* t81*(G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*m*R^2 + t84 */
    const double t86 = JLT_FMA(t77, t78, t85); /* t77*b*m*R*I3^2 + t85 */
    const double t87 = p[12]*t60; /* m*I3*D*b*1/(Theta*D*b) */
    const double t88 = t22*t87; /* omega_n*b*m*I3*D*b*1/(Theta*D*b) */
    const double t89 = -t88; /* -omega_n*b*m*I3*D*b*1/(Theta*D*b) */
    const double t90 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t91 = t79*p[17]; /* (e + I3/(m*R))*m*R */
    const double t92 = t60*t91; /* D*b*1/(Theta*D*b)*(e + I3/(m*R))*m*R */
    const double t93 = t44*t92; /* (G_level - s*omega_n*R*I1)*D*Theta*1/(Theta*D*b)*1/I3*I3*D*b*1/(Theta*D*b)*(e + I3/(m*R))*m*R */
    const double t94 = JLT_FNMA(t63, t88, t90); /* omega_n*gamma3 - e*omega_n*b*m*I3*D*b*1/(Theta*D*b) */
    const double t95 = JLT_FNMA(x[4], t93, t94); /* omega_n*gamma3 - e*omega_n*b*m*I3*D*b*1/(Theta*D*b) - s*t93 */
    const double t96 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t97 = t8*t64; /* b*V */
    const double t98 = x[4]*p[11]; /* s*m*R^2*I1 */
    const double t99 = JLT_FNMA(t87, t97, t96); /* omega_tau*gamma3 - m*I3*D*b*1/(Theta*D*b)*b*V */
    const double t100 = JLT_FMA(t81, t98, t99); /* t81*s*m*R^2*I1 + omega_tau*gamma3 - m*I3*D*b*1/(Theta*D*b)*b*V */
    const double t101 = x[2]*t93; /* omega_tau*t93 */
    const double t102 = x[4]*p[34]; /* s*m*R^2*I1*I3 */
    const double t103 = p[11]*t18; /* m*R^2*I1*omega_n*D*Theta*1/(Theta*D*b) */
    const double t104 = JLT_FMS(t80, t103, t101); /* s*omega_tau*D*b*1/(Theta*D*b)*(e + I3/(m*R))*m*R^2*I1*omega_n*D*Theta*1/(Theta*D*b) - omega_tau*t93 */
    const double t105 = JLT_FMA(t77, t102, t104); /* t77*s*m*R^2*I1*I3 + t104 */
    const double t106 = -t1; /* -s*omega_tau */
    const double t107 = x[4]*x[0]; /* s*gamma3 */
    const double t108 = -t107; /* -s*gamma3 */
    const double t109 = -t96; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t21;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t27;
    out[9] = t28;
    out[10] = t37;
    out[11] = 0.0;
    out[12] = t40;
    out[13] = t47;
    out[14] = t59;
    out[15] = t86;
    out[16] = t89;
    out[17] = t95;
    out[18] = t100;
    out[19] = t105;
    out[20] = t106;
    out[21] = 0.0;
    out[22] = t108;
    out[23] = 0.0;
    out[24] = t109;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = t2*t3; /* b*omega_n*omega_n */
    const double t5 = x[4]*x[3]; /* s*omega_n */
    const double t6 = JLT_FNMA(p[8], t5, p[6]); /* G_level - R*I1*s*omega_n */
    const double t7 = x[4]*x[4]; /* s*s */
    const double t8 = JLT_FMA(p[9], t7, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t9 = t2*p[12]; /* b*m*I3 */
    const double t10 = JLT_FMA(t7, p[11], p[10]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t11 = JLT_FMA(t2, t9, t10); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t12 = t2*t8; /* b*D */
    const double t13 = t11*t12; /* Theta*b*D */
    const double t14 = 1.0/t13; /* 1/(Theta*b*D) */
    const double t15 = t11*t14; /* Theta*1/(Theta*b*D) */
    const double t16 = t8*t15; /* D*Theta*1/(Theta*b*D) */
    const double t17 = t6*t16; /* (G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D) */
    const double t18 = p[7]*t17; /* 1/I3*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D) */
    const double t19 = p[1]*t5; /* R*s*omega_n */
    const double t20 = JLT_FNMA(t18, t19, t4); /* b*omega_n*omega_n - 1/I3*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*R*s*omega_n */
    const double t21 = t2*t15; /* b*Theta*1/(Theta*b*D) */
    const double t22 = x[0]*t21; /* gamma3*b*Theta*1/(Theta*b*D) */
    const double t23 = t0*p[15]; /* s*omega_tau*m*a3^2/I1 */
    const double t24 = JLT_FNMA(t0, t23, t3); /* omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t25 = p[4]*t24; /* I1*(omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1) */
    const double t26 = t22*t25; /* gamma3*b*Theta*1/(Theta*b*D)*I1*(omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1) */
    const double t27 = x[4]*t21; /* s*b*Theta*1/(Theta*b*D) */
    const double t28 = x[4]*t27; /* s*s*b*Theta*1/(Theta*b*D) */
    const double t29 = x[3]*t27; /* omega_n*s*b*Theta*1/(Theta*b*D) */
    const double t30 = t18*p[5]; /* 1/I3*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*I3 */
    const double t31 = JLT_FMS(t29, t30, t26); /* omega_n*s*b*Theta*1/(Theta*b*D)*1/I3*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*I3 - t26 */
    const double t32 = JLT_FNMA(p[35], t28, t31); /* t31 - m*g*a3*s*s*b*Theta*1/(Theta*b*D) */
    const double t33 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t34 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t35 = JLT_FMA(x[2], t34, x[1]); /* V = omega_tau*e + v_nu */
    const double t36 = t12*t14; /* b*D*1/(Theta*b*D) */
    const double t37 = t2*t36; /* b*b*D*1/(Theta*b*D) */
    const double t38 = p[12]*t35; /* m*I3*V */
    const double t39 = JLT_FNMA(t37, t38, t33); /* omega_tau*gamma3 - b*b*D*1/(Theta*b*D)*m*I3*V */
    const double t40 = x[3]*t39; /* omega_n*(omega_tau*gamma3 - b*b*D*1/(Theta*b*D)*m*I3*V) */
    const double t41 = t18*t36; /* 1/I3*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*b*D*1/(Theta*b*D) */
    const double t42 = t0*t41; /* s*omega_tau*t41 */
    const double t43 = t34 + p[33]; /* e + I3/(m*R) */
    const double t44 = p[27]*t43; /* m*R*I3*(e + I3/(m*R)) */
    const double t45 = JLT_FNMA(t42, t44, t40); /* omega_n*(omega_tau*gamma3 - b*b*D*1/(Theta*b*D)*m*I3*V) - s*omega_tau*t41*m*R*I3*(e + I3/(m*R)) */
    const double t46 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t47 = -t46; /* -s*omega_tau*gamma3 */
    const double t48 = t0*2.0; /* s*omega_tau*2 */
    const double t49 = p[1]*t3; /* R*omega_n*omega_n */
    const double t50 = t5*t16; /* s*omega_n*D*Theta*1/(Theta*b*D) */
    const double t51 = t17*p[18]; /* (G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*R^2/I3 */
    const double t52 = JLT_FMA(t50, t51, t49); /* s*omega_n*D*Theta*1/(Theta*b*D)*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*R^2/I3 + R*omega_n*omega_n */
    const double t53 = x[3]*2.0; /* omega_n*2 */
    const double t54 = t2*t53; /* b*omega_n*2 */
    const double t55 = JLT_FMS(t50, p[19], t18); /* s*omega_n*D*Theta*1/(Theta*b*D)*R*I1/I3 - 1/I3*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D) */
    const double t56 = p[1]*t55; /* R*t55 */
    const double t57 = JLT_FMA(x[4], t56, t54); /* s*R*t55 + b*omega_n*2 */
    const double t58 = x[3]*t56; /* omega_n*R*t55 */
    const double t59 = t21*t25; /* b*Theta*1/(Theta*b*D)*I1*(omega_n*omega_n - s*omega_tau*s*omega_tau*m*a3^2/I1) */
    const double t60 = t16*t29; /* D*Theta*1/(Theta*b*D)*omega_n*s*b*Theta*1/(Theta*b*D) */
    const double t61 = p[1]*t17; /* R*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D) */
    const double t62 = JLT_FMA(t60, t61, t59); /* D*Theta*1/(Theta*b*D)*omega_n*s*b*Theta*1/(Theta*b*D)*R*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D) + t59 */
    const double t63 = -t62; /* -t62 */
    const double t64 = t0*p[20]; /* s*omega_tau*2*m*a3^2 */
    const double t65 = t27*t64; /* s*b*Theta*1/(Theta*b*D)*s*omega_tau*2*m*a3^2 */
    const double t66 = x[0]*t65; /* gamma3*s*b*Theta*1/(Theta*b*D)*s*omega_tau*2*m*a3^2 */
    const double t67 = x[3]*t22; /* omega_n*gamma3*b*Theta*1/(Theta*b*D) */
    const double t68 = p[21]*t67; /* 2*I1*omega_n*gamma3*b*Theta*1/(Theta*b*D) */
    const double t69 = p[8]*t60; /* R*I1*D*Theta*1/(Theta*b*D)*omega_n*s*b*Theta*1/(Theta*b*D) */
    const double t70 = JLT_FMS(t27, t30, t68); /* s*b*Theta*1/(Theta*b*D)*1/I3*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*I3 - 2*I1*omega_n*gamma3*b*Theta*1/(Theta*b*D) */
    const double t71 = JLT_FNMA(x[4], t69, t70); /* t70 - s*R*I1*D*Theta*1/(Theta*b*D)*omega_n*s*b*Theta*1/(Theta*b*D) */
    const double t72 = JLT_FMS(x[2], 2.0, t65); /* omega_tau*2 - s*b*Theta*1/(Theta*b*D)*s*omega_tau*2*m*a3^2 */
    const double t73 = t0*p[9]; /* s*omega_tau*m*a3^2 */
    const double t74 = t22*t73; /* gamma3*b*Theta*1/(Theta*b*D)*s*omega_tau*m*a3^2 */
    const double t75 = t27*p[24]; /* s*b*Theta*1/(Theta*b*D)*2*m*g*a3 */
    const double t76 = JLT_FNMA(t21, t30, t69); /* R*I1*D*Theta*1/(Theta*b*D)*omega_n*s*b*Theta*1/(Theta*b*D) - b*Theta*1/(Theta*b*D)*1/I3*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*I3 */
    const double t77 = t27*p[22]; /* s*b*Theta*1/(Theta*b*D)*2*m^2*g*a3^3 */
    const double t78 = t29*p[23]; /* omega_n*s*b*Theta*1/(Theta*b*D)*2*m*a3^2*I1 */
    const double t79 = t27*p[36]; /* s*b*Theta*1/(Theta*b*D)*2*m*a3^2*I3 */
    const double t80 = t18*t79; /* 1/I3*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*s*b*Theta*1/(Theta*b*D)*2*m*a3^2*I3 */
    const double t81 = JLT_FMS(t28, t77, t75); /* s*s*b*Theta*1/(Theta*b*D)*s*b*Theta*1/(Theta*b*D)*2*m^2*g*a3^3 - s*b*Theta*1/(Theta*b*D)*2*m*g*a3 */
    const double t82 = JLT_FMA(t72, t74, t81); /* (omega_tau*2 - s*b*Theta*1/(Theta*b*D)*s*omega_tau*2*m*a3^2)*gamma3*b*Theta*1/(Theta*b*D)*s*omega_tau*m*a3^2 + t81 */
    const double t83 = JLT_FMA(t67, t78, t82); /* omega_n*gamma3*b*Theta*1/(Theta*b*D)*omega_n*s*b*Theta*1/(Theta*b*D)*2*m*a3^2*I1 + t82 */
    const double t84 = JLT_FNMA(t29, t80, t83); /* t83 - omega_n*s*b*Theta*1/(Theta*b*D)*t80 */
    const double t85 = JLT_FNMA(x[3], t76, t84); /* t83 - omega_n*s*b*Theta*1/(Theta*b*D)*t80 - omega_n*t76 */
    const double t86 = x[3]*t37; /* omega_n*b*b*D*1/(Theta*b*D) */
    const double t87 = JLT_FNMA(p[28], t86, x[3]); /* omega_n - m*a3*I3*omega_n*b*b*D*1/(Theta*b*D) */
    const double t88 = x[3]*p[27]; /* omega_n*m*R*I3 */
    const double t89 = t35*t88; /* V*omega_n*m*R*I3 */
    const double t90 = t36*t89; /* b*D*1/(Theta*b*D)*V*omega_n*m*R*I3 */
    const double t91 = t34*p[37]; /* e*2*m*R */
    const double t92 = t42*t91; /* s*omega_tau*t41*e*2*m*R */
    const double t93 = t35*p[38]; /* V*2*m */
    const double t94 = JLT_FMA(t86, t93, t92); /* omega_n*b*b*D*1/(Theta*b*D)*V*2*m + s*omega_tau*t41*e*2*m*R */
    const double t95 = JLT_FMA(t42, p[30], t94); /* s*omega_tau*t41*2*I3 + omega_n*b*b*D*1/(Theta*b*D)*V*2*m + s*omega_tau*t41*e*2*m*R */
    const double t96 = t37*p[29]; /* b*b*D*1/(Theta*b*D)*m*R*I3^2 */
    const double t97 = t0*t43; /* s*omega_tau*(e + I3/(m*R)) */
    const double t98 = t36*t97; /* b*D*1/(Theta*b*D)*s*omega_tau*(e + I3/(m*R)) */
    const double t99 = t16*t98; /* D*Theta*1/(Theta*b*D)*b*D*1/(Theta*b*D)*s*omega_tau*(e + I3/(m*R)) */
    const double t100 = t17*p[32]; /* (G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*m*R^2 */
    const double t101 = JLT_FMS(t99, t100, t90); /* t99*(G_level - R*I1*s*omega_n)*D*Theta*1/(Theta*b*D)*m*R^2 - b*D*1/(Theta*b*D)*V*omega_n*m*R*I3 */
    const double t102 = JLT_FMA(x[2], t87, t101); /* omega_tau*(omega_n - m*a3*I3*omega_n*b*b*D*1/(Theta*b*D)) + t101 */
    const double t103 = JLT_FNMA(t42, p[26], t102); /* t102 - s*omega_tau*t41*m*R*a3*I3 */
    const double t104 = JLT_FMA(t95, t96, t103); /* t95*b*b*D*1/(Theta*b*D)*m*R*I3^2 + t102 - s*omega_tau*t41*m*R*a3*I3 */
    const double t105 = p[12]*t86; /* m*I3*omega_n*b*b*D*1/(Theta*b*D) */
    const double t106 = -t105; /* -m*I3*omega_n*b*b*D*1/(Theta*b*D) */
    const double t107 = x[0]*x[3]; /* gamma3*omega_n */
    const double t108 = t41*t44; /* t41*m*R*I3*(e + I3/(m*R)) */
    const double t109 = JLT_FNMA(t34, t105, t107); /* gamma3*omega_n - e*m*I3*omega_n*b*b*D*1/(Theta*b*D) */
    const double t110 = JLT_FNMA(x[4], t108, t109); /* gamma3*omega_n - e*m*I3*omega_n*b*b*D*1/(Theta*b*D) - s*t41*m*R*I3*(e + I3/(m*R)) */
    const double t111 = p[11]*t99; /* m*R^2*I1*t99 */
    const double t112 = JLT_FMA(x[4], t111, t39); /* s*m*R^2*I1*t99 + omega_tau*gamma3 - b*b*D*1/(Theta*b*D)*m*I3*V */
    const double t113 = x[2]*t108; /* omega_tau*t41*m*R*I3*(e + I3/(m*R)) */
    const double t114 = x[4]*p[34]; /* s*m*R^2*I1*I3 */
    const double t115 = t36*t114; /* b*D*1/(Theta*b*D)*s*m*R^2*I1*I3 */
    const double t116 = JLT_FMS(x[3], t111, t113); /* omega_n*m*R^2*I1*t99 - omega_tau*t41*m*R*I3*(e + I3/(m*R)) */
    const double t117 = JLT_FMA(t95, t115, t116); /* t95*b*D*1/(Theta*b*D)*s*m*R^2*I1*I3 + omega_n*m*R^2*I1*t99 - omega_tau*t41*m*R*I3*(e + I3/(m*R)) */
    const double t118 = -t0; /* -s*omega_tau */
    const double t119 = x[4]*x[0]; /* s*gamma3 */
    const double t120 = -t119; /* -s*gamma3 */
    const double t121 = -t33; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t20;
    out[2] = t32;
    out[3] = t45;
    out[4] = t47;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t7;
    out[8] = 0.0;
    out[9] = t48;
    out[10] = t52;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t57;
    out[14] = t58;
    out[15] = t63;
    out[16] = 0.0;
    out[17] = t66;
    out[18] = t71;
    out[19] = t85;
    out[20] = t104;
    out[21] = t106;
    out[22] = t110;
    out[23] = t112;
    out[24] = t117;
    out[25] = t118;
    out[26] = 0.0;
    out[27] = t120;
    out[28] = 0.0;
    out[29] = t121;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[11]*t0; /* m*R^2*I1*s*s */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = t2*p[12]; /* b*m*I3 */
    const double t4 = p[10] + t1; /* I1*I3 + m*R^2*I1*s*s */
    const double t5 = JLT_FMA(t2, t3, t4); /* Theta = b*b*m*I3 + I1*I3 + m*R^2*I1*s*s */
    const double t6 = JLT_FMA(t0, p[9], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t7 = t2*t6; /* b*D */
    const double t8 = t5*t7; /* Theta*b*D */
    const double t9 = 1.0/t8; /* 1/(Theta*b*D) */
    const double t10 = t2*t9; /* b*1/(Theta*b*D) */
    const double t11 = p[39]*x[0]; /* 2*a3^2/(R^2*I1)*gamma3 */
    const double t12 = t5*t11; /* Theta*2*a3^2/(R^2*I1)*gamma3 */
    const double t13 = t10*t12; /* b*1/(Theta*b*D)*Theta*2*a3^2/(R^2*I1)*gamma3 */
    const double t14 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t15 = p[33] + t14; /* I3/(m*R) + e */
    const double t16 = t6*t10; /* D*b*1/(Theta*b*D) */
    const double t17 = t6*t15; /* D*(I3/(m*R) + e) */
    const double t18 = t5*t17; /* Theta*D*(I3/(m*R) + e) */
    const double t19 = t9*t18; /* 1/(Theta*b*D)*Theta*D*(I3/(m*R) + e) */
    const double t20 = JLT_FMA(t16, t19, t13); /* D*b*1/(Theta*b*D)*1/(Theta*b*D)*Theta*D*(I3/(m*R) + e) + b*1/(Theta*b*D)*Theta*2*a3^2/(R^2*I1)*gamma3 */
    const double t21 = x[2]*t1; /* omega_tau*m*R^2*I1*s*s */
    const double t22 = t20*t21; /* t20*omega_tau*m*R^2*I1*s*s */
    const double t23 = JLT_FMA(x[2], t14, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = t3*t23; /* b*m*I3*V */
    const double t25 = JLT_FNMA(t16, t24, t22); /* t20*omega_tau*m*R^2*I1*s*s - D*b*1/(Theta*b*D)*b*m*I3*V */
    out[0] = t25;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[35]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = 1.0/t2; /* 1/b */
    const double t5 = x[4]*p[8]; /* s*R*I1 */
    const double t6 = JLT_FNMA(x[3], t5, p[6]); /* G_level - omega_n*s*R*I1 */
    const double t7 = p[7]*t6; /* 1/I3*(G_level - omega_n*s*R*I1) */
    const double t8 = t4*t7; /* 1/b*1/I3*(G_level - omega_n*s*R*I1) */
    const double t9 = p[1]*x[4]; /* R*s */
    const double t10 = JLT_FNMA(t8, t9, t3); /* v_tau = omega_n*b - 1/b*1/I3*(G_level - omega_n*s*R*I1)*R*s */
    const double t11 = JLT_FMA(t10, t10, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t12 = x[4]*p[9]; /* s*m*a3^2 */
    const double t13 = JLT_FMA(x[4], t12, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t15 = x[2]*t14; /* omega_tau*1/2*omega_tau */
    const double t16 = x[3]*p[41]; /* omega_n*1/2*I1 */
    const double t17 = t8*p[42]; /* 1/b*1/I3*(G_level - omega_n*s*R*I1)*1/2*I3 */
    const double t18 = JLT_FMA(x[3], t16, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t19 = JLT_FMA(t13, t15, t18); /* D*omega_tau*1/2*omega_tau + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t20 = JLT_FMA(t8, t17, t19); /* 1/b*1/I3*(G_level - omega_n*s*R*I1)*1/b*1/I3*(G_level - omega_n*s*R*I1)*1/2*I3 + t19 */
    const double t21 = JLT_FMA(p[40], t11, t20); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t20 */
    out[0] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*x[3]; /* R*omega_n */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = 1.0/t1; /* 1/b */
    const double t3 = t2*x[4]; /* 1/b*s */
    const double t4 = x[3]*p[8]; /* omega_n*R*I1 */
    const double t5 = JLT_FNMA(x[4], t4, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t6 = t2*t5; /* 1/b*(G_level - s*omega_n*R*I1) */
    const double t7 = p[18]*t3; /* R^2/I3*1/b*s */
    const double t8 = JLT_FMA(t6, t7, t0); /* d(v_tau)/d(gamma3) = 1/b*(G_level - s*omega_n*R*I1)*R^2/I3*1/b*s + R*omega_n */
    const double t9 = x[3]*t1; /* omega_n*b */
    const double t10 = t6*p[7]; /* 1/b*(G_level - s*omega_n*R*I1)*1/I3 */
    const double t11 = p[1]*t10; /* R*1/b*(G_level - s*omega_n*R*I1)*1/I3 */
    const double t12 = JLT_FNMA(x[4], t11, t9); /* v_tau = omega_n*b - s*R*1/b*(G_level - s*omega_n*R*I1)*1/I3 */
    const double t13 = p[0]*t12; /* m*v_tau */
    const double t14 = t2*t6; /* 1/b*1/b*(G_level - s*omega_n*R*I1) */
    const double t15 = JLT_FNMA(t11, t14, p[35]); /* m*g*a3 - R*1/b*(G_level - s*omega_n*R*I1)*1/I3*1/b*1/b*(G_level - s*omega_n*R*I1) */
    const double t16 = JLT_FMA(t8, t13, t15); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau + t15 */
    const double t17 = p[0]*x[1]; /* m*v_nu */
    const double t18 = x[4]*p[9]; /* s*m*a3^2 */
    const double t19 = JLT_FMA(x[4], t18, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t20 = x[2]*t19; /* omega_tau*D */
    const double t21 = x[3]*p[4]; /* omega_n*I1 */
    const double t22 = t3*p[43]; /* 1/b*s*R^2*I1/I3 */
    const double t23 = JLT_FMA(x[4], t22, t1); /* d(v_tau)/d(omega_n) = s*1/b*s*R^2*I1/I3 + b */
    const double t24 = t3*p[8]; /* 1/b*s*R*I1 */
    const double t25 = JLT_FNMA(t10, t24, t21); /* omega_n*I1 - 1/b*(G_level - s*omega_n*R*I1)*1/I3*1/b*s*R*I1 */
    const double t26 = JLT_FMA(t13, t23, t25); /* d(energy)/d(omega_n) = m*v_tau*d(v_tau)/d(omega_n) + omega_n*I1 - 1/b*(G_level - s*omega_n*R*I1)*1/I3*1/b*s*R*I1 */
    const double t27 = JLT_FMS(x[3], t22, t11); /* d(v_tau)/d(s) = omega_n*1/b*s*R^2*I1/I3 - R*1/b*(G_level - s*omega_n*R*I1)*1/I3 */
    const double t28 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t29 = t18*t28; /* s*m*a3^2*omega_tau*omega_tau */
    const double t30 = t2*t4; /* 1/b*omega_n*R*I1 */
    const double t31 = JLT_FNMA(t10, t30, t29); /* s*m*a3^2*omega_tau*omega_tau - 1/b*(G_level - s*omega_n*R*I1)*1/I3*1/b*omega_n*R*I1 */
    const double t32 = JLT_FMA(t13, t27, t31); /* d(energy)/d(s) = m*v_tau*d(v_tau)/d(s) + t31 */
    out[0] = t16;
    out[1] = t17;
    out[2] = t20;
    out[3] = t26;
    out[4] = t32;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = 1.0/t0; /* 1/b */
    const double t2 = p[8]*x[3]; /* R*I1*omega_n */
    const double t3 = JLT_FNMA(x[4], t2, p[6]); /* G_level - s*R*I1*omega_n */
    const double t4 = p[44]*t3; /* (-1/I3)*(G_level - s*R*I1*omega_n) */
    const double t5 = t1*t4; /* 1/b*(-1/I3)*(G_level - s*R*I1*omega_n) */
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
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t7[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t9[k] = jlt_jet_product(x3, x3, k);
        t10[k] = jlt_jet_product(t7, t9, k);
        t14[k] = jlt_jet_product(x4, x3, k);
        t15[k] = (k == 0 ? p[6] : 0) - p[8]*t14[k];
        t18[k] = jlt_jet_product(x4, x4, k);
        t19[k] = p[9]*t18[k] + (k == 0 ? p[4] : 0);
        t23[k] = t7[k]*p[12];
        t24[k] = t18[k]*p[11] + (k == 0 ? p[10] : 0);
        t25[k] = jlt_jet_product(t7, t23, k) + t24[k];
        t26[k] = jlt_jet_product(t7, t19, k);
        t27[k] = jlt_jet_product(t25, t26, k);
        t29[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t27, t29, k);
        t30[k] = jlt_jet_product(t25, t29, k);
        t31[k] = p[7]*t15[k];
        t32[k] = jlt_jet_product(t19, t31, k);
        t33[k] = jlt_jet_product(t30, t32, k);
        t34[k] = jlt_jet_product(t14, t33, k);
        t35[k] = t10[k] - p[1]*t34[k];
        t38[k] = t18[k]*p[14];
        t40[k] = t2[k]*p[15];
        t41[k] = t9[k] - jlt_jet_product(t2, t40, k);
        t43[k] = jlt_jet_product(x0, t41, k) + t38[k];
        t44[k] = t43[k] - t34[k]*p[16];
        t45[k] = t7[k]*p[13];
        t46[k] = jlt_jet_product(t30, t45, k);
        t47[k] = jlt_jet_product(t44, t46, k);
        t48[k] = jlt_jet_product(x2, x0, k);
        t50[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t51[k] = jlt_jet_product(x2, t50, k) + x1[k];
        t52[k] = jlt_jet_product(t26, t29, k);
        t53[k] = jlt_jet_product(t23, t51, k);
        t54[k] = t48[k] - jlt_jet_product(t52, t53, k);
        t55[k] = jlt_jet_product(x3, t54, k);
        t58[k] = t50[k]*p[17] + (k == 0 ? p[5] : 0);
        t59[k] = t2[k]*p[5];
        t60[k] = jlt_jet_product(t58, t59, k);
        t61[k] = jlt_jet_product(t52, t60, k);
        t62[k] = t55[k] - jlt_jet_product(t33, t61, k);
        t63[k] = jlt_jet_product(t2, x0, k);
        t64[k] = -t63[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t35[k]/(k + 1);
        next[2] = x2[k + 1] = t47[k]/(k + 1);
        next[3] = x3[k + 1] = t62[k]/(k + 1);
        next[4] = x4[k + 1] = t64[k]/(k + 1);
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
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 45,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 1, 27, 14, 1, 0, 0, 10, 13 }, { 15, 62, 0, 8, 0, 0, 10, 8 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 25, { 6, 70, 33, 1, 0, 0, 14, 20 }, { 51, 305, 0, 41, 0, 0, 16, 10 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 7, 76, 38, 1, 0, 0, 15, 26 }, { 59, 347, 0, 48, 0, 0, 16, 11 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 2, 16, 7, 1, 0, 0, 11, 10 }, { 9, 40, 0, 4, 0, 0, 10, 7 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 1, { 0, 12, 9, 1, 0, 0, 7, 8 }, { 9, 30, 0, 1, 0, 0, 12, 5 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_gradients = { integral_gradients, 5, { 0, 19, 13, 1, 0, 0, 8, 11 }, { 15, 60, 0, 7, 0, 0, 12, 10 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 0, 3, 2, 1, 0, 0, 4, 3 }, { 2, 5, 0, 1, 0, 0, 5, 3 },
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
