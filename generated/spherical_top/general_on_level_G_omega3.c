/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   25   12    1    1    0     14   11   (82)
 *  jacobian            9   53   28    1    1    0     18   21   (318)
 *  rhs_jacobian        7   56   33    1    1    0     20   29   (369)
 *  divergence          3   18    8    1    1    0     13   12   (54)
 *  integral_values     2    9    9    1    1    0      9    9   (43)
 *  integral_gradients  2   21   13    1    1    0     14   12   (75)
 *  eliminated          3    2    1    1    1    0      5    4   (11)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
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
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    const double t6 = params[4]*t3; /* I1*R*R */
    const double t7 = params[5]/t6; /* I3/(I1*R*R) */
    const double t8 = t6/params[5]; /* I1*R*R/I3 */
    const double t9 = params[4]*params[1]; /* I1*R */
    const double t10 = params[6]/t9; /* G_level/(I1*R) */
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[3]*t11; /* a3*m*g */
    const double t13 = t12/params[4]; /* a3*m*g/I1 */
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = params[5]/t14; /* I3/(m*R) */
    const double t16 = t9/params[5]; /* I1*R/I3 */
    const double t17 = params[0]*2.0; /* m*2 */
    const double t18 = params[1]*t17; /* R*m*2 */
    const double t19 = t0*t18; /* a3*a3*R*m*2 */
    const double t20 = t19/params[4]; /* a3*a3*R*m*2/I1 */
    const double t21 = params[5]/params[4]; /* I3/I1 */
    const double t22 = t0*t17; /* a3*a3*m*2 */
    const double t23 = t22/params[4]; /* a3*a3*m*2/I1 */
    const double t24 = params[1]/2.0; /* R/2 */
    const double t25 = params[3]/2.0; /* a3/2 */
    const double t26 = params[1]*2.0; /* R*2 */
    const double t27 = params[4]*t26; /* I1*R*2 */
    const double t28 = params[5]/t27; /* I3/(I1*R*2) */
    const double t29 = params[5]/t9; /* I3/(I1*R) */
    const double t30 = params[5]*2.0; /* I3*2 */
    const double t31 = t30/t6; /* I3*2/(I1*R*R) */
    const double t32 = params[4]*params[5]; /* I1*I3 */
    const double t33 = params[4]*t4; /* I1*m*R*R */
    const double t34 = params[0]*params[5]; /* m*I3 */
    const double t35 = params[1]/params[5]; /* R/I3 */
    const double t36 = params[4]*2.0; /* I1*2 */
    const double t37 = params[3]*t14; /* a3*m*R */
    const double t38 = params[0]*params[3]; /* m*a3 */
    const double t39 = params[5]*t38; /* I3*m*a3 */
    const double t40 = params[5]*t14; /* I3*m*R */
    const double t41 = t3*t17; /* R*R*m*2 */
    const double t42 = params[4]*t41; /* I1*R*R*m*2 */
    const double t43 = params[5]*t18; /* I3*R*m*2 */
    const double t44 = params[0]/2.0; /* m/2 */
    const double t45 = params[2]*2.0; /* g*2 */
    const double t46 = params[3]*t45; /* a3*g*2 */
    const double t47 = 1.0/params[0]; /* 1/m */
    const double t48 = params[4]/params[0]; /* I1/m */
    const double t49 = params[4]*params[4]; /* I1*I1 */
    const double t50 = t3*t49; /* R*R*I1*I1 */
    const double t51 = t50/t34; /* R*R*I1*I1/(m*I3) */
    const double t52 = params[4]/params[5]; /* I1/I3 */
    const double t53 = -t52; /* -I1/I3 */
    const double t54 = params[3]/params[1]; /* a3/R */
    out[7] = t2;
    out[8] = t5;
    out[9] = t7;
    out[10] = t8;
    out[11] = t10;
    out[12] = t13;
    out[13] = t15;
    out[14] = t16;
    out[15] = t20;
    out[16] = t21;
    out[17] = t23;
    out[18] = t24;
    out[19] = t25;
    out[20] = t28;
    out[21] = t29;
    out[22] = t31;
    out[23] = t1;
    out[24] = t32;
    out[25] = t33;
    out[26] = t34;
    out[27] = t35;
    out[28] = t9;
    out[29] = t12;
    out[30] = t14;
    out[31] = t22;
    out[32] = t36;
    out[33] = t37;
    out[34] = t39;
    out[35] = t40;
    out[36] = t42;
    out[37] = t43;
    out[38] = t44;
    out[39] = t46;
    out[40] = t47;
    out[41] = t48;
    out[42] = t51;
    out[43] = t53;
    out[44] = t54;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[7], 1.0); /* D scaled = (1 - gamma3)*(1 + gamma3)*m*a3^2/I1 + 1 */
    const double t7 = t5*p[9]; /* b*I3/(R^2*I1) */
    const double t8 = t2 + p[8]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t9 = JLT_FMA(t5, t7, t8); /* Theta scaled = b*b*I3/(R^2*I1) + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t10 = t3*t5; /* s*b */
    const double t11 = t6*t10; /* D scaled*s*b */
    const double t12 = t9*t11; /* Theta scaled*D scaled*s*b */
    const double t13 = 1.0/t12; /* 1/(Theta scaled*D scaled*s*b) */
    const double t14 = t9*t13; /* Theta scaled*1/(Theta scaled*D scaled*s*b) */
    const double t15 = t6*t14; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*s*b) */
    const double t16 = x[3]*t5; /* omega_n*b */
    const double t17 = t15*t16; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*s*b)*omega_n*b */
    const double t18 = t5*t17; /* b*t17 */
    const double t19 = JLT_FNMA(t3, x[3], p[11]); /* G_level/(R*I1) - s*omega_n */
    const double t20 = t3*t19; /* s*(G_level/(R*I1) - s*omega_n) */
    const double t21 = t15*t20; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*s*b)*s*(G_level/(R*I1) - s*omega_n) */
    const double t22 = JLT_FNMA(p[10], t21, t18); /* b*t17 - R^2*I1/I3*t21 */
    const double t23 = x[3]*t22; /* omega_n*(b*t17 - R^2*I1/I3*t21) */
    const double t24 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t25 = x[0]*t24; /* gamma3*omega_tau*m*a3^2/I1 */
    const double t26 = t4*t25; /* omega_tau*s*gamma3*omega_tau*m*a3^2/I1 */
    const double t27 = x[0]*t17; /* gamma3*t17 */
    const double t28 = JLT_FNMA(p[1], t21, t27); /* gamma3*t17 - R*t21 */
    const double t29 = JLT_FNMA(t3, p[12], t26); /* omega_tau*s*gamma3*omega_tau*m*a3^2/I1 - s*m*g*a3/I1 */
    const double t30 = JLT_FNMA(x[3], t28, t29); /* omega_tau*s*gamma3*omega_tau*m*a3^2/I1 - s*m*g*a3/I1 - omega_n*(gamma3*t17 - R*t21) */
    const double t31 = t10*t14; /* s*b*Theta scaled*1/(Theta scaled*D scaled*s*b) */
    const double t32 = t30*t31; /* t30*s*b*Theta scaled*1/(Theta scaled*D scaled*s*b) */
    const double t33 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t34 = p[13] + t33; /* I3/(m*R) + e */
    const double t35 = t11*t13; /* D scaled*s*b*1/(Theta scaled*D scaled*s*b) */
    const double t36 = t34*t35; /* (I3/(m*R) + e)*D scaled*s*b*1/(Theta scaled*D scaled*s*b) */
    const double t37 = JLT_FNMA(t21, t36, t27); /* gamma3*t17 - t21*(I3/(m*R) + e)*D scaled*s*b*1/(Theta scaled*D scaled*s*b) */
    const double t38 = x[2]*t37; /* omega_tau*t37 */
    const double t39 = JLT_FMA(x[2], t33, x[1]); /* V = omega_tau*e + v_nu */
    const double t40 = p[9]*t39; /* I3/(R^2*I1)*V */
    const double t41 = t35*t40; /* D scaled*s*b*1/(Theta scaled*D scaled*s*b)*I3/(R^2*I1)*V */
    const double t42 = JLT_FNMA(t18, t41, t38); /* omega_tau*t37 - b*t17*D scaled*s*b*1/(Theta scaled*D scaled*s*b)*I3/(R^2*I1)*V */
    out[0] = t4;
    out[1] = t23;
    out[2] = t32;
    out[3] = t42;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[7], t3, 1.0); /* D scaled = m*a3^2/I1*(1 - gamma3)*(gamma3 + 1) + 1 */
    const double t5 = t0*p[9]; /* b*I3/(R^2*I1) */
    const double t6 = t3 + p[8]; /* (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t7 = JLT_FMA(t0, t5, t6); /* Theta scaled = b*b*I3/(R^2*I1) + (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t8 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = t0*t8; /* b*s */
    const double t10 = t4*t9; /* D scaled*b*s */
    const double t11 = t7*t10; /* Theta scaled*D scaled*b*s */
    const double t12 = 1.0/t11; /* 1/(Theta scaled*D scaled*b*s) */
    const double t13 = t7*t12; /* Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t14 = t4*t13; /* D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t15 = t0*t14; /* b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t16 = x[0]*t15; /* gamma3*b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t17 = x[2]*t16; /* omega_tau*gamma3*b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t18 = -t17; /* -t17 */
    const double t19 = JLT_FNMA(t8, x[3], p[11]); /* G_level/(R*I1) - s*omega_n */
    const double t20 = t8*t14; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t21 = t19*t20; /* (G_level/(R*I1) - s*omega_n)*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t22 = p[10]*t20; /* R^2*I1/I3*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t23 = t21*t22; /* t21*t22 */
    const double t24 = t15*x[3]; /* b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*omega_n */
    const double t25 = x[0]*t24; /* gamma3*t24 */
    const double t26 = t20*p[14]; /* s*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*R*I1/I3 */
    const double t27 = JLT_FNMA(t25, t26, t23); /* d(omega3)/d(gamma3) = t21*t22 - gamma3*t24*t26 */
    const double t28 = t24 + t27; /* t24 + d(omega3)/d(gamma3) */
    const double t29 = p[1]*x[3]; /* R*omega_n */
    const double t30 = t28*t29; /* (t24 + d(omega3)/d(gamma3))*R*omega_n */
    const double t31 = t15*t24; /* b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*t24 */
    const double t32 = t0*t24; /* b*t24 */
    const double t33 = x[0]*t31; /* gamma3*b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*t24 */
    const double t34 = JLT_FMA(t32, t33, t30); /* b*t24*t33 + (t24 + d(omega3)/d(gamma3))*R*omega_n */
    const double t35 = t8*t20; /* s*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t36 = JLT_FMS(x[3], t35, t21); /* omega_n*s*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) - t21 */
    const double t37 = p[10]*t36; /* R^2*I1/I3*t36 */
    const double t38 = JLT_FMA(t32, 2.0, t37); /* b*t24*2 + R^2*I1/I3*t36 */
    const double t39 = t9*t13; /* b*s*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t40 = x[0]*t39; /* gamma3*b*s*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t41 = p[15]*t40; /* 2*m*R*a3^2/I1*gamma3*b*s*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t42 = t21*t41; /* t21*t41 */
    const double t43 = t40*p[17]; /* gamma3*b*s*Theta scaled*1/(Theta scaled*D scaled*b*s)*2*m*a3^2/I1 */
    const double t44 = JLT_FNMA(t25, t43, t42); /* t21*t41 - gamma3*t24*t43 */
    const double t45 = JLT_FNMA(t27, p[16], t44); /* t21*t41 - gamma3*t24*t43 - d(omega3)/d(gamma3)*I3/I1 */
    const double t46 = t8*t43; /* s*t43 */
    const double t47 = t16 - t46; /* gamma3*b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) - s*t43 */
    const double t48 = p[12]*t47; /* m*g*a3/I1*t47 */
    const double t49 = JLT_FNMA(x[0], t47, t8); /* s - gamma3*t47 */
    const double t50 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t51 = x[2]*t50; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t52 = JLT_FNMA(t24, t31, t48); /* m*g*a3/I1*t47 - t24*b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*t24 */
    const double t53 = JLT_FMA(t49, t51, t52); /* (s - gamma3*t47)*omega_tau*omega_tau*m*a3^2/I1 + t52 */
    const double t54 = JLT_FMA(x[3], t45, t53); /* omega_n*(t21*t41 - gamma3*t24*t43 - d(omega3)/d(gamma3)*I3/I1) + (s - gamma3*t47)*omega_tau*omega_tau*m*a3^2/I1 + t52 */
    const double t55 = t39*t54; /* b*s*Theta scaled*1/(Theta scaled*D scaled*b*s)*t54 */
    const double t56 = x[2]*t46; /* omega_tau*s*t43 */
    const double t57 = JLT_FMA(t36, p[18], t25); /* t36*1/2*R + gamma3*t24 */
    const double t58 = t39*(-2.0); /* b*s*Theta scaled*1/(Theta scaled*D scaled*b*s)*(-2) */
    const double t59 = t57*t58; /* (t36*1/2*R + gamma3*t24)*b*s*Theta scaled*1/(Theta scaled*D scaled*b*s)*(-2) */
    const double t60 = x[2]*t31; /* omega_tau*b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*t24 */
    const double t61 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t62 = JLT_FMA(x[2], t61, x[1]); /* V = omega_tau*e + v_nu */
    const double t63 = t10*t12; /* D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    const double t64 = t32*t63; /* b*t24*D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    const double t65 = p[9]*t64; /* I3/(R^2*I1)*b*t24*D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    const double t66 = t16*t62; /* gamma3*b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*V */
    const double t67 = JLT_FNMA(t65, t66, t60); /* t60 - I3/(R^2*I1)*b*t24*D scaled*b*s*1/(Theta scaled*D scaled*b*s)*t66 */
    const double t68 = t15*t67; /* b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*t67 */
    const double t69 = t21*t63; /* t21*D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    const double t70 = t65 + t69; /* I3/(R^2*I1)*b*t24*D scaled*b*s*1/(Theta scaled*D scaled*b*s) + t21*D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    const double t71 = p[19]*t70; /* 1/2*a3*t70 */
    const double t72 = t27*p[20]; /* d(omega3)/d(gamma3)*1/2*I3/(R*I1) */
    const double t73 = JLT_FMS(t0, p[21], x[0]); /* d(Theta)/d(gamma3) scaled = b*I3/(R*I1) - gamma3 */
    const double t74 = JLT_FMA(t69, t73, t72); /* t21*D scaled*b*s*1/(Theta scaled*D scaled*b*s)*d(Theta)/d(gamma3) scaled + d(omega3)/d(gamma3)*1/2*I3/(R*I1) */
    const double t75 = t61 + p[13]; /* e + I3/(m*R) */
    const double t76 = t63*t75; /* D scaled*b*s*1/(Theta scaled*D scaled*b*s)*(e + I3/(m*R)) */
    const double t77 = JLT_FNMA(t74, t76, t71); /* 1/2*a3*t70 - t74*D scaled*b*s*1/(Theta scaled*D scaled*b*s)*(e + I3/(m*R)) */
    const double t78 = x[2]*2.0; /* omega_tau*2 */
    const double t79 = t64*t73; /* b*t24*D scaled*b*s*1/(Theta scaled*D scaled*b*s)*d(Theta)/d(gamma3) scaled */
    const double t80 = JLT_FNMA(t24, p[18], t79); /* t79 - t24*1/2*R */
    const double t81 = t62*t63; /* V*D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    const double t82 = p[22]*t81; /* 2*I3/(R^2*I1)*V*D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    const double t83 = JLT_FMA(t80, t82, t68); /* (t79 - t24*1/2*R)*2*I3/(R^2*I1)*V*D scaled*b*s*1/(Theta scaled*D scaled*b*s) + b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*t67 */
    const double t84 = JLT_FNMA(t77, t78, t83); /* t83 - t77*omega_tau*2 */
    const double t85 = -t65; /* -I3/(R^2*I1)*b*t24*D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    const double t86 = JLT_FNMA(t21, t76, t25); /* gamma3*t24 - t21*D scaled*b*s*1/(Theta scaled*D scaled*b*s)*(e + I3/(m*R)) */
    const double t87 = JLT_FNMA(t61, t65, t86); /* t86 - e*I3/(R^2*I1)*b*t24*D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    const double t88 = JLT_FMA(t35, t76, t16); /* s*s*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*D scaled*b*s*1/(Theta scaled*D scaled*b*s)*(e + I3/(m*R)) + gamma3*b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s) */
    const double t89 = x[2]*t88; /* omega_tau*t88 */
    const double t90 = t5*t81; /* b*I3/(R^2*I1)*V*D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    const double t91 = JLT_FNMA(t15, t90, t89); /* omega_tau*t88 - b*D scaled*Theta scaled*1/(Theta scaled*D scaled*b*s)*b*I3/(R^2*I1)*V*D scaled*b*s*1/(Theta scaled*D scaled*b*s) */
    out[0] = t18;
    out[1] = 0.0;
    out[2] = t8;
    out[3] = 0.0;
    out[4] = t34;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t38;
    out[8] = t55;
    out[9] = 0.0;
    out[10] = t56;
    out[11] = t59;
    out[12] = t84;
    out[13] = t85;
    out[14] = t87;
    out[15] = t91;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[23], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t7 = t5*p[26]; /* b*m*I3 */
    const double t8 = JLT_FMA(t2, p[25], p[24]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(t5, t7, t8); /* Theta = b*b*m*I3 + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t10 = t3*t5; /* s*b */
    const double t11 = t6*t10; /* D*s*b */
    const double t12 = t9*t11; /* Theta*D*s*b */
    const double t13 = 1.0/t12; /* 1/(Theta*D*s*b) */
    const double t14 = t9*t13; /* Theta*1/(Theta*D*s*b) */
    const double t15 = t6*t14; /* D*Theta*1/(Theta*D*s*b) */
    const double t16 = t5*t15; /* b*D*Theta*1/(Theta*D*s*b) */
    const double t17 = x[3]*t16; /* omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t18 = t5*t17; /* b*omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t19 = t3*x[3]; /* s*omega_n */
    const double t20 = JLT_FNMA(p[28], t19, p[6]); /* G_level - R*I1*s*omega_n */
    const double t21 = t3*t15; /* s*D*Theta*1/(Theta*D*s*b) */
    const double t22 = t20*t21; /* (G_level - R*I1*s*omega_n)*s*D*Theta*1/(Theta*D*s*b) */
    const double t23 = p[27]*t22; /* R/I3*(G_level - R*I1*s*omega_n)*s*D*Theta*1/(Theta*D*s*b) */
    const double t24 = t18 - t23; /* b*omega_n*b*D*Theta*1/(Theta*D*s*b) - R/I3*(G_level - R*I1*s*omega_n)*s*D*Theta*1/(Theta*D*s*b) */
    const double t25 = x[3]*t24; /* omega_n*t24 */
    const double t26 = x[2]*p[23]; /* omega_tau*m*a3^2 */
    const double t27 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t28 = JLT_FNMA(t26, t27, p[29]); /* m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t29 = t3*t28; /* s*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t30 = x[0]*t17; /* gamma3*omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t31 = JLT_FNMA(p[4], t30, t22); /* (G_level - R*I1*s*omega_n)*s*D*Theta*1/(Theta*D*s*b) - I1*gamma3*omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t32 = JLT_FMS(x[3], t31, t29); /* numerator of d(omega_tau)/dt over D = omega_n*t31 - s*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t33 = t10*t14; /* s*b*Theta*1/(Theta*D*s*b) */
    const double t34 = t32*t33; /* numerator of d(omega_tau)/dt over D*s*b*Theta*1/(Theta*D*s*b) */
    const double t35 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t36 = JLT_FMA(x[2], t35, x[1]); /* V = omega_tau*e + v_nu */
    const double t37 = p[26]*t18; /* m*I3*b*omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t38 = t36*t37; /* V*m*I3*b*omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t39 = t35 + p[13]; /* e + I3/(m*R) */
    const double t40 = p[30]*t39; /* m*R*(e + I3/(m*R)) */
    const double t41 = t22*t40; /* (G_level - R*I1*s*omega_n)*s*D*Theta*1/(Theta*D*s*b)*m*R*(e + I3/(m*R)) */
    const double t42 = JLT_FMA(x[2], t41, t38); /* omega_tau*t41 + V*m*I3*b*omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t43 = t11*t13; /* D*s*b*1/(Theta*D*s*b) */
    const double t44 = t42*t43; /* (omega_tau*t41 + V*m*I3*b*omega_n*b*D*Theta*1/(Theta*D*s*b))*D*s*b*1/(Theta*D*s*b) */
    const double t45 = JLT_FMS(x[2], t30, t44); /* omega_tau*gamma3*omega_n*b*D*Theta*1/(Theta*D*s*b) - t44 */
    const double t46 = x[0]*t16; /* gamma3*b*D*Theta*1/(Theta*D*s*b) */
    const double t47 = x[2]*t46; /* omega_tau*gamma3*b*D*Theta*1/(Theta*D*s*b) */
    const double t48 = -t47; /* -omega_tau*gamma3*b*D*Theta*1/(Theta*D*s*b) */
    const double t49 = JLT_FMS(t30, p[14], t23); /* gamma3*omega_n*b*D*Theta*1/(Theta*D*s*b)*R*I1/I3 - R/I3*(G_level - R*I1*s*omega_n)*s*D*Theta*1/(Theta*D*s*b) */
    const double t50 = t21*t49; /* s*D*Theta*1/(Theta*D*s*b)*t49 */
    const double t51 = t50 - t17; /* s*D*Theta*1/(Theta*D*s*b)*t49 - omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t52 = x[3]*p[1]; /* omega_n*R */
    const double t53 = t51*t52; /* t51*omega_n*R */
    const double t54 = t16*t30; /* b*D*Theta*1/(Theta*D*s*b)*gamma3*omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t55 = JLT_FMS(t18, t54, t53); /* b*omega_n*b*D*Theta*1/(Theta*D*s*b)*t54 - t51*omega_n*R */
    const double t56 = t19*t21; /* s*omega_n*s*D*Theta*1/(Theta*D*s*b) */
    const double t57 = JLT_FMS(p[10], t56, t23); /* R^2*I1/I3*s*omega_n*s*D*Theta*1/(Theta*D*s*b) - R/I3*(G_level - R*I1*s*omega_n)*s*D*Theta*1/(Theta*D*s*b) */
    const double t58 = JLT_FMA(t18, 2.0, t57); /* b*omega_n*b*D*Theta*1/(Theta*D*s*b)*2 + t57 */
    const double t59 = x[0]*p[31]; /* gamma3*2*m*a3^2 */
    const double t60 = t33*t59; /* s*b*Theta*1/(Theta*D*s*b)*gamma3*2*m*a3^2 */
    const double t61 = t34*t60; /* t34*s*b*Theta*1/(Theta*D*s*b)*gamma3*2*m*a3^2 */
    const double t62 = t28*t46; /* (m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3)*gamma3*b*D*Theta*1/(Theta*D*s*b) */
    const double t63 = t16*t17; /* b*D*Theta*1/(Theta*D*s*b)*omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t64 = p[4]*t17; /* I1*omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t65 = t50*p[5]; /* s*D*Theta*1/(Theta*D*s*b)*t49*I3 */
    const double t66 = JLT_FMA(t4, t26, t62); /* omega_tau*s*omega_tau*m*a3^2 + t62 */
    const double t67 = JLT_FNMA(t63, t64, t66); /* omega_tau*s*omega_tau*m*a3^2 + t62 - b*D*Theta*1/(Theta*D*s*b)*omega_n*b*D*Theta*1/(Theta*D*s*b)*I1*omega_n*b*D*Theta*1/(Theta*D*s*b) */
    const double t68 = JLT_FMA(x[3], t65, t67); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = omega_n*s*D*Theta*1/(Theta*D*s*b)*t49*I3 + t67 */
    const double t69 = JLT_FMA(t33, t68, t61); /* s*b*Theta*1/(Theta*D*s*b)*d(numerator of d(omega_tau)/dt over D)/d(gamma3) + t34*s*b*Theta*1/(Theta*D*s*b)*gamma3*2*m*a3^2 */
    const double t70 = t4*t60; /* omega_tau*s*s*b*Theta*1/(Theta*D*s*b)*gamma3*2*m*a3^2 */
    const double t71 = JLT_FNMA(p[28], t56, t22); /* (G_level - R*I1*s*omega_n)*s*D*Theta*1/(Theta*D*s*b) - R*I1*s*omega_n*s*D*Theta*1/(Theta*D*s*b) */
    const double t72 = JLT_FNMA(t30, p[32], t71); /* d(numerator of d(omega_tau)/dt over D)/d(omega_n) = t71 - gamma3*omega_n*b*D*Theta*1/(Theta*D*s*b)*2*I1 */
    const double t73 = t33*t72; /* s*b*Theta*1/(Theta*D*s*b)*d(numerator of d(omega_tau)/dt over D)/d(omega_n) */
    const double t74 = t22*p[33]; /* (G_level - R*I1*s*omega_n)*s*D*Theta*1/(Theta*D*s*b)*m*R*a3 */
    const double t75 = JLT_FMA(t18, p[34], t74); /* b*omega_n*b*D*Theta*1/(Theta*D*s*b)*m*a3*I3 + (G_level - R*I1*s*omega_n)*s*D*Theta*1/(Theta*D*s*b)*m*R*a3 */
    const double t76 = JLT_FMA(t40, t65, t75); /* m*R*(e + I3/(m*R))*s*D*Theta*1/(Theta*D*s*b)*t49*I3 + t75 */
    const double t77 = t16*t46; /* b*D*Theta*1/(Theta*D*s*b)*gamma3*b*D*Theta*1/(Theta*D*s*b) */
    const double t78 = t37*t77; /* m*I3*b*omega_n*b*D*Theta*1/(Theta*D*s*b)*b*D*Theta*1/(Theta*D*s*b)*gamma3*b*D*Theta*1/(Theta*D*s*b) */
    const double t79 = JLT_FMA(t17, p[35], t78); /* omega_n*b*D*Theta*1/(Theta*D*s*b)*m*R*I3 + t78 */
    const double t80 = t36*t79; /* V*(omega_n*b*D*Theta*1/(Theta*D*s*b)*m*R*I3 + t78) */
    const double t81 = x[0]*p[36]; /* gamma3*2*m*R^2*I1 */
    const double t82 = JLT_FMS(t5, p[37], t81); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t83 = JLT_FNMA(t44, t82, t80); /* V*(omega_n*b*D*Theta*1/(Theta*D*s*b)*m*R*I3 + t78) - t44*d(Theta)/d(gamma3) */
    const double t84 = JLT_FMA(x[2], t76, t83); /* omega_tau*(m*R*(e + I3/(m*R))*s*D*Theta*1/(Theta*D*s*b)*t49*I3 + t75) + t83 */
    const double t85 = t43*t84; /* D*s*b*1/(Theta*D*s*b)*t84 */
    const double t86 = x[2]*t16; /* omega_tau*b*D*Theta*1/(Theta*D*s*b) */
    const double t87 = JLT_FMS(t63, t86, t85); /* b*D*Theta*1/(Theta*D*s*b)*omega_n*b*D*Theta*1/(Theta*D*s*b)*omega_tau*b*D*Theta*1/(Theta*D*s*b) - D*s*b*1/(Theta*D*s*b)*t84 */
    const double t88 = t37*t43; /* m*I3*b*omega_n*b*D*Theta*1/(Theta*D*s*b)*D*s*b*1/(Theta*D*s*b) */
    const double t89 = -t88; /* -t88 */
    const double t90 = JLT_FMA(t35, t37, t41); /* e*m*I3*b*omega_n*b*D*Theta*1/(Theta*D*s*b) + t41 */
    const double t91 = JLT_FNMA(t43, t90, t30); /* gamma3*omega_n*b*D*Theta*1/(Theta*D*s*b) - D*s*b*1/(Theta*D*s*b)*(e*m*I3*b*omega_n*b*D*Theta*1/(Theta*D*s*b) + t41) */
    const double t92 = t7*t36; /* b*m*I3*V */
    const double t93 = t16*t92; /* b*D*Theta*1/(Theta*D*s*b)*b*m*I3*V */
    const double t94 = p[25]*t39; /* m*R^2*I1*(e + I3/(m*R)) */
    const double t95 = t4*t94; /* omega_tau*s*m*R^2*I1*(e + I3/(m*R)) */
    const double t96 = JLT_FMS(t21, t95, t93); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = s*D*Theta*1/(Theta*D*s*b)*omega_tau*s*m*R^2*I1*(e + I3/(m*R)) - b*D*Theta*1/(Theta*D*s*b)*b*m*I3*V */
    const double t97 = JLT_FMA(t43, t96, t47); /* D*s*b*1/(Theta*D*s*b)*d(numerator of d(omega_n)/dt over Theta)/d(omega_n) + omega_tau*gamma3*b*D*Theta*1/(Theta*D*s*b) */
    out[0] = t4;
    out[1] = t25;
    out[2] = t34;
    out[3] = t45;
    out[4] = t48;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t55;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t58;
    out[12] = t69;
    out[13] = 0.0;
    out[14] = t70;
    out[15] = t73;
    out[16] = t87;
    out[17] = t89;
    out[18] = t91;
    out[19] = t97;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = JLT_FMA(t2, p[23], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t6 = t4*p[26]; /* b*m*I3 */
    const double t7 = JLT_FMA(t2, p[25], p[24]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t4, t6, t7); /* Theta = b*b*m*I3 + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t9 = t5*t8; /* D*Theta */
    const double t10 = t3*t9; /* s*D*Theta */
    const double t11 = t4*t10; /* b*s*D*Theta */
    const double t12 = 1.0/t11; /* 1/(b*s*D*Theta) */
    const double t13 = t4*t12; /* b*1/(b*s*D*Theta) */
    const double t14 = t3*x[2]; /* s*omega_tau */
    const double t15 = x[0]*p[31]; /* gamma3*2*m*a3^2 */
    const double t16 = t8*t15; /* Theta*gamma3*2*m*a3^2 */
    const double t17 = t14*t16; /* s*omega_tau*Theta*gamma3*2*m*a3^2 */
    const double t18 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t19 = JLT_FMA(x[2], t18, x[1]); /* V = omega_tau*e + v_nu */
    const double t20 = t6*t19; /* b*m*I3*V */
    const double t21 = t9*t20; /* D*Theta*b*m*I3*V */
    const double t22 = t13*t21; /* b*1/(b*s*D*Theta)*D*Theta*b*m*I3*V */
    const double t23 = t18 + p[13]; /* e + I3/(m*R) */
    const double t24 = p[25]*t23; /* m*R^2*I1*(e + I3/(m*R)) */
    const double t25 = t10*t24; /* s*D*Theta*m*R^2*I1*(e + I3/(m*R)) */
    const double t26 = t14*t25; /* s*omega_tau*s*D*Theta*m*R^2*I1*(e + I3/(m*R)) */
    const double t27 = JLT_FMS(t12, t26, t22); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = 1/(b*s*D*Theta)*s*omega_tau*s*D*Theta*m*R^2*I1*(e + I3/(m*R)) - b*1/(b*s*D*Theta)*D*Theta*b*m*I3*V */
    const double t28 = JLT_FMA(t5, t27, t17); /* D*d(numerator of d(omega_n)/dt over Theta)/d(omega_n) + s*omega_tau*Theta*gamma3*2*m*a3^2 */
    const double t29 = t3*t13; /* s*b*1/(b*s*D*Theta) */
    const double t30 = t28*t29; /* t28*s*b*1/(b*s*D*Theta) */
    out[0] = t30;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[39]*x[0]; /* 2*g*a3*gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[23], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = p[40]*x[2]; /* 1/m*omega_tau */
    const double t6 = x[2]*t5; /* omega_tau*1/m*omega_tau */
    const double t7 = p[41]*x[3]; /* I1/m*omega_n */
    const double t8 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t9 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t10 = JLT_FNMA(x[3], t9, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t11 = t10/t8; /* (G_level/(R*I1) - omega_n*s)/b */
    const double t12 = p[42]*t11; /* R^2*I1^2/(m*I3)*(G_level/(R*I1) - omega_n*s)/b */
    const double t13 = x[3]*t8; /* omega_n*b */
    const double t14 = t9*p[10]; /* s*R^2*I1/I3 */
    const double t15 = JLT_FNMA(t11, t14, t13); /* v_tau = omega_n*b - (G_level/(R*I1) - omega_n*s)/b*s*R^2*I1/I3 */
    const double t16 = JLT_FMA(x[1], x[1], t0); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t17 = JLT_FMA(x[3], t7, t16); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = JLT_FMA(t4, t6, t17); /* D*omega_tau*1/m*omega_tau + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t19 = JLT_FMA(t11, t12, t18); /* (G_level/(R*I1) - omega_n*s)/b*R^2*I1^2/(m*I3)*(G_level/(R*I1) - omega_n*s)/b + t18 */
    const double t20 = JLT_FMA(t15, t15, t19); /* energy scaled = v_tau*v_tau + t19 */
    const double t21 = p[38]*t20; /* 1/2*m*energy scaled */
    out[0] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[23]*x[0]; /* m*a3^2*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = x[0] + 1.0; /* gamma3 + 1 */
    const double t5 = t3*t4; /* (1 - gamma3)*(gamma3 + 1) */
    const double t6 = sqrt(t5); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = t2*t6; /* b*s */
    const double t8 = 1.0/t7; /* 1/(b*s) */
    const double t9 = x[0]*t2; /* gamma3*b */
    const double t10 = t8*t9; /* 1/(b*s)*gamma3*b */
    const double t11 = p[14]*x[3]; /* R*I1/I3*omega_n */
    const double t12 = x[3]*p[28]; /* omega_n*R*I1 */
    const double t13 = JLT_FNMA(t6, t12, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t14 = t6*t8; /* s*1/(b*s) */
    const double t15 = t13*t14; /* (G_level - s*omega_n*R*I1)*s*1/(b*s) */
    const double t16 = p[27]*t15; /* R/I3*(G_level - s*omega_n*R*I1)*s*1/(b*s) */
    const double t17 = JLT_FMS(t10, t11, t16); /* 1/(b*s)*gamma3*b*R*I1/I3*omega_n - R/I3*(G_level - s*omega_n*R*I1)*s*1/(b*s) */
    const double t18 = t14*t17; /* s*1/(b*s)*t17 */
    const double t19 = JLT_FNMA(t6, t18, x[3]); /* omega_n - s*s*1/(b*s)*t17 */
    const double t20 = p[1]*t19; /* R*(omega_n - s*s*1/(b*s)*t17) */
    const double t21 = JLT_FMA(t10, t16, t20); /* d(v_tau)/d(gamma3) = 1/(b*s)*gamma3*b*R/I3*(G_level - s*omega_n*R*I1)*s*1/(b*s) + R*(omega_n - s*s*1/(b*s)*t17) */
    const double t22 = x[3]*t2; /* omega_n*b */
    const double t23 = JLT_FNMA(t6, t16, t22); /* v_tau = omega_n*b - s*R/I3*(G_level - s*omega_n*R*I1)*s*1/(b*s) */
    const double t24 = p[0]*t23; /* m*v_tau */
    const double t25 = JLT_FNMA(t0, t1, p[29]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t26 = JLT_FMA(t15, t18, t25); /* (G_level - s*omega_n*R*I1)*s*1/(b*s)*s*1/(b*s)*t17 + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t27 = JLT_FMA(t21, t24, t26); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau + t26 */
    const double t28 = p[0]*x[1]; /* m*v_nu */
    const double t29 = JLT_FMA(p[23], t5, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t30 = x[2]*t29; /* omega_tau*D */
    const double t31 = x[3]*p[4]; /* omega_n*I1 */
    const double t32 = t5*p[10]; /* (1 - gamma3)*(gamma3 + 1)*R^2*I1/I3 */
    const double t33 = JLT_FMA(t14, t32, t2); /* d(v_tau)/d(omega_n) = s*1/(b*s)*(1 - gamma3)*(gamma3 + 1)*R^2*I1/I3 + b */
    const double t34 = p[14]*t6; /* R*I1/I3*s */
    const double t35 = t14*t34; /* s*1/(b*s)*R*I1/I3*s */
    const double t36 = JLT_FNMA(t15, t35, t31); /* omega_n*I1 - (G_level - s*omega_n*R*I1)*s*1/(b*s)*s*1/(b*s)*R*I1/I3*s */
    const double t37 = JLT_FMA(t24, t33, t36); /* d(energy)/d(omega_n) = m*v_tau*d(v_tau)/d(omega_n) + t36 */
    out[0] = t27;
    out[1] = t28;
    out[2] = t30;
    out[3] = t37;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[44] + x[0]; /* b scaled = a3/R + gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = JLT_FNMA(x[3], t4, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t6 = p[43]/t0; /* (-I1/I3)/b scaled */
    const double t7 = t5*t6; /* (G_level/(R*I1) - omega_n*s)*(-I1/I3)/b scaled */
    out[0] = t7;
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
    double t11[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
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
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
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
        t11[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t13[k] = t5[k]*p[7] + (k == 0 ? 1.0 : 0);
        t16[k] = t11[k]*p[9];
        t17[k] = t5[k] + (k == 0 ? p[8] : 0);
        t18[k] = jlt_jet_product(t11, t16, k) + t17[k];
        t19[k] = jlt_jet_product(t6, t11, k);
        t20[k] = jlt_jet_product(t13, t19, k);
        t21[k] = jlt_jet_product(t18, t20, k);
        t22[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t21, t22, k);
        t23[k] = jlt_jet_product(t18, t22, k);
        t24[k] = jlt_jet_product(t13, t23, k);
        t25[k] = jlt_jet_product(x3, t11, k);
        t26[k] = jlt_jet_product(t24, t25, k);
        t27[k] = jlt_jet_product(t11, t26, k);
        t30[k] = (k == 0 ? p[11] : 0) - jlt_jet_product(t6, x3, k);
        t31[k] = jlt_jet_product(t6, t30, k);
        t32[k] = jlt_jet_product(t24, t31, k);
        t33[k] = t27[k] - p[10]*t32[k];
        t34[k] = jlt_jet_product(x3, t33, k);
        t35[k] = x2[k]*p[7];
        t36[k] = jlt_jet_product(x0, t35, k);
        t37[k] = jlt_jet_product(t7, t36, k);
        t39[k] = jlt_jet_product(x0, t26, k);
        t40[k] = t39[k] - p[1]*t32[k];
        t41[k] = t37[k] - t6[k]*p[12];
        t42[k] = t41[k] - jlt_jet_product(x3, t40, k);
        t43[k] = jlt_jet_product(t19, t23, k);
        t44[k] = jlt_jet_product(t42, t43, k);
        t46[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t47[k] = (k == 0 ? p[13] : 0) + t46[k];
        t48[k] = jlt_jet_product(t20, t22, k);
        t49[k] = jlt_jet_product(t47, t48, k);
        t50[k] = t39[k] - jlt_jet_product(t32, t49, k);
        t51[k] = jlt_jet_product(x2, t50, k);
        t53[k] = jlt_jet_product(x2, t46, k) + x1[k];
        t54[k] = p[9]*t53[k];
        t55[k] = jlt_jet_product(t48, t54, k);
        t56[k] = t51[k] - jlt_jet_product(t27, t55, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t34[k]/(k + 1);
        next[2] = x2[k + 1] = t44[k]/(k + 1);
        next[3] = x3[k + 1] = t56[k]/(k + 1);
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
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 45,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 25, 12, 1, 1, 0, 14, 11 }, { 15, 56, 0, 10, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 9, 53, 28, 1, 1, 0, 18, 21 }, { 45, 230, 0, 42, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 56, 33, 1, 1, 0, 20, 29 }, { 52, 265, 0, 51, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 18, 8, 1, 1, 0, 13, 12 }, { 10, 39, 0, 4, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 2, 9, 9, 1, 1, 0, 9, 9 }, { 10, 31, 0, 1, 1, 0, 13, 6 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 2, 21, 13, 1, 1, 0, 14, 12 }, { 15, 53, 0, 6, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 2, 1, 1, 1, 0, 5, 4 }, { 3, 6, 0, 1, 1, 0, 6, 4 },
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
