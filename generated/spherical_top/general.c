/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   25   13    1    1    0     14   11   (99)
 *  jacobian            9   55   30    1    1    0     16   20   (373)
 *  rhs_jacobian        15   60   33    1    1    0     15   32   (447)
 *  divergence          4   15    7    1    1    0     11    9   (54)
 *  integral_values     2   12    9    0    1    0      7   10   (43)
 *  integral_gradients  2   15    9    1    1    0      6   10   (53)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[3]*params[3]; /* a3*a3 */
    const double t1 = params[0]*t0; /* m*a3*a3 */
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    const double t6 = params[4]*t3; /* I1*R*R */
    const double t7 = params[5]/t6; /* I3/(I1*R*R) */
    const double t8 = params[0]*params[2]; /* m*g */
    const double t9 = params[3]*t8; /* a3*m*g */
    const double t10 = t9/params[4]; /* a3*m*g/I1 */
    const double t11 = params[5]/params[4]; /* I3/I1 */
    const double t12 = params[4]*params[1]; /* I1*R */
    const double t13 = params[5]/t12; /* I3/(I1*R) */
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = params[5]/t14; /* I3/(m*R) */
    const double t16 = 1.0/params[1]; /* 1/R */
    const double t17 = params[3]*params[5]; /* a3*I3 */
    const double t18 = t17/t12; /* a3*I3/(I1*R) */
    const double t19 = params[4] - params[5]; /* I1 - I3 */
    const double t20 = t19/params[4]; /* (I1 - I3)/I1 */
    const double t21 = params[4]*params[5]; /* I1*I3 */
    const double t22 = params[4]*t4; /* I1*m*R*R */
    const double t23 = params[0]*params[5]; /* m*I3 */
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t0*t24; /* a3*a3*m*2 */
    const double t26 = params[5]*2.0; /* I3*2 */
    const double t27 = params[4]*2.0; /* I1*2 */
    const double t28 = -params[5]; /* -I3 */
    const double t29 = t3*t24; /* R*R*m*2 */
    const double t30 = params[4]*t29; /* I1*R*R*m*2 */
    const double t31 = params[1]*t24; /* R*m*2 */
    const double t32 = params[5]*t31; /* I3*R*m*2 */
    const double t33 = params[5]*t14; /* I3*m*R */
    const double t34 = params[3]*t14; /* a3*m*R */
    const double t35 = params[5]*t34; /* I3*a3*m*R */
    const double t36 = params[5]*params[5]; /* I3*I3 */
    const double t37 = params[4]*t14; /* I1*m*R */
    const double t38 = t4*t19; /* m*R*R*(I1 - I3) */
    const double t39 = -t37; /* -I1*m*R */
    const double t40 = t25/params[4]; /* a3*a3*m*2/I1 */
    const double t41 = t26/t6; /* I3*2/(I1*R*R) */
    const double t42 = t17/t6; /* a3*I3/(I1*R*R) */
    const double t43 = t26/t12; /* I3*2/(I1*R) */
    const double t44 = params[3]/2.0; /* a3/2 */
    const double t45 = 2.0/params[1]; /* 2/R */
    const double t46 = params[3]*2.0; /* a3*2 */
    const double t47 = params[5]*t46; /* I3*a3*2 */
    const double t48 = t47/t12; /* I3*a3*2/(I1*R) */
    const double t49 = t19*2.0; /* (I1 - I3)*2 */
    const double t50 = t49/params[4]; /* (I1 - I3)*2/I1 */
    const double t51 = (-1.0)/params[1]; /* (-1)/R */
    const double t52 = params[3]/params[1]; /* a3/R */
    const double t53 = params[0]/2.0; /* m/2 */
    const double t54 = params[2]*2.0; /* g*2 */
    const double t55 = params[3]*t54; /* a3*g*2 */
    const double t56 = 1.0/params[0]; /* 1/m */
    const double t57 = params[4]/params[0]; /* I1/m */
    const double t58 = params[5]/params[0]; /* I3/m */
    const double t59 = -t12; /* -I1*R */
    const double t60 = params[1]*params[5]; /* R*I3 */
    const double t61 = -t60; /* -R*I3 */
    out[6] = t2;
    out[7] = t5;
    out[8] = t7;
    out[9] = t10;
    out[10] = t11;
    out[11] = t13;
    out[12] = t15;
    out[13] = t16;
    out[14] = t18;
    out[15] = t20;
    out[16] = t1;
    out[17] = t21;
    out[18] = t22;
    out[19] = t23;
    out[20] = t25;
    out[21] = t26;
    out[22] = t27;
    out[23] = t28;
    out[24] = t30;
    out[25] = t32;
    out[26] = t33;
    out[27] = t35;
    out[28] = t36;
    out[29] = t37;
    out[30] = t38;
    out[31] = t39;
    out[32] = t40;
    out[33] = t41;
    out[34] = t42;
    out[35] = t43;
    out[36] = t44;
    out[37] = t45;
    out[38] = t48;
    out[39] = t50;
    out[40] = t51;
    out[41] = t52;
    out[42] = t53;
    out[43] = t55;
    out[44] = t56;
    out[45] = t57;
    out[46] = t58;
    out[47] = t12;
    out[48] = t9;
    out[49] = t14;
    out[50] = t59;
    out[51] = t61;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[6], 1.0); /* D scaled = (1 - gamma3)*(1 + gamma3)*m*a3^2/I1 + 1 */
    const double t7 = t5*p[8]; /* b*I3/(R^2*I1) */
    const double t8 = t2 + p[7]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t9 = JLT_FMA(t5, t7, t8); /* Theta scaled = b*b*I3/(R^2*I1) + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t10 = t3*t6; /* s*D scaled */
    const double t11 = t9*t10; /* Theta scaled*s*D scaled */
    const double t12 = 1.0/t11; /* 1/(Theta scaled*s*D scaled) */
    const double t13 = t9*t12; /* Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t14 = x[3]*t6; /* omega_n*D scaled */
    const double t15 = t13*t14; /* Theta scaled*1/(Theta scaled*s*D scaled)*omega_n*D scaled */
    const double t16 = x[3]*t15; /* omega_n*Theta scaled*1/(Theta scaled*s*D scaled)*omega_n*D scaled */
    const double t17 = t5*t16; /* b*t16 */
    const double t18 = x[3]*x[4]; /* omega_n*omega3 */
    const double t19 = JLT_FMA(p[1], t18, t17); /* R*omega_n*omega3 + b*t16 */
    const double t20 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t21 = JLT_FMS(t4, t20, t16); /* omega_tau*s*omega_tau*m*a3^2/I1 - t16 */
    const double t22 = x[0]*t21; /* gamma3*(omega_tau*s*omega_tau*m*a3^2/I1 - t16) */
    const double t23 = JLT_FNMA(t18, p[10], t22); /* gamma3*(omega_tau*s*omega_tau*m*a3^2/I1 - t16) - omega_n*omega3*I3/I1 */
    const double t24 = JLT_FNMA(t3, p[9], t23); /* t23 - s*m*g*a3/I1 */
    const double t25 = t3*t13; /* s*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t26 = t24*t25; /* (t23 - s*m*g*a3/I1)*s*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t27 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t28 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t29 = JLT_FMA(x[2], t28, x[1]); /* V = omega_tau*e + v_nu */
    const double t30 = t10*t12; /* s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t31 = t29*t30; /* V*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t32 = JLT_FNMA(t7, t31, t27); /* omega_tau*gamma3 - b*I3/(R^2*I1)*V*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t33 = t15*t32; /* Theta scaled*1/(Theta scaled*s*D scaled)*omega_n*D scaled*t32 */
    const double t34 = t28 + p[12]; /* e + I3/(m*R) */
    const double t35 = x[4]*t30; /* omega3*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t36 = x[2]*p[11]; /* omega_tau*I3/(R*I1) */
    const double t37 = t34*t36; /* (e + I3/(m*R))*omega_tau*I3/(R*I1) */
    const double t38 = JLT_FMA(t35, t37, t33); /* omega3*s*D scaled*1/(Theta scaled*s*D scaled)*(e + I3/(m*R))*omega_tau*I3/(R*I1) + t33 */
    const double t39 = x[3]*p[13]; /* omega_n*1/R */
    const double t40 = t31*t39; /* V*s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R */
    const double t41 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t42 = t4*t41; /* omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t43 = JLT_FMA(t35, t42, t40); /* omega3*s*D scaled*1/(Theta scaled*s*D scaled)*omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + V*s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R */
    const double t44 = -t43; /* -t43 */
    out[0] = t4;
    out[1] = t19;
    out[2] = t26;
    out[3] = t38;
    out[4] = t44;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = t4*p[19]; /* b*m*I3 */
    const double t6 = JLT_FMA(t2, p[18], p[17]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*b*m*I3 + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t8 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = t3*t8; /* D*s */
    const double t10 = t7*t9; /* Theta*D*s */
    const double t11 = 1.0/t10; /* 1/(Theta*D*s) */
    const double t12 = t7*t11; /* Theta*1/(Theta*D*s) */
    const double t13 = t3*t12; /* D*Theta*1/(Theta*D*s) */
    const double t14 = x[0]*t13; /* gamma3*D*Theta*1/(Theta*D*s) */
    const double t15 = x[2]*t14; /* omega_tau*gamma3*D*Theta*1/(Theta*D*s) */
    const double t16 = -t15; /* -omega_tau*gamma3*D*Theta*1/(Theta*D*s) */
    const double t17 = t13*x[3]; /* D*Theta*1/(Theta*D*s)*omega_n */
    const double t18 = t4*t17; /* b*D*Theta*1/(Theta*D*s)*omega_n */
    const double t19 = p[1]*x[3]; /* R*omega_n */
    const double t20 = JLT_FMA(t14, t18, t19); /* gamma3*D*Theta*1/(Theta*D*s)*b*D*Theta*1/(Theta*D*s)*omega_n + R*omega_n */
    const double t21 = t17*t20; /* D*Theta*1/(Theta*D*s)*omega_n*t20 */
    const double t22 = p[1]*x[4]; /* R*omega3 */
    const double t23 = JLT_FMA(t18, 2.0, t22); /* b*D*Theta*1/(Theta*D*s)*omega_n*2 + R*omega3 */
    const double t24 = t8*t12; /* s*Theta*1/(Theta*D*s) */
    const double t25 = t8*t24; /* s*s*Theta*1/(Theta*D*s) */
    const double t26 = x[0]*t24; /* gamma3*s*Theta*1/(Theta*D*s) */
    const double t27 = t8*p[20]; /* s*2*m*a3^2 */
    const double t28 = t26*t27; /* gamma3*s*Theta*1/(Theta*D*s)*s*2*m*a3^2 */
    const double t29 = t14 - t28; /* gamma3*D*Theta*1/(Theta*D*s) - gamma3*s*Theta*1/(Theta*D*s)*s*2*m*a3^2 */
    const double t30 = JLT_FNMA(t26, t29, t25); /* s*s*Theta*1/(Theta*D*s) - gamma3*s*Theta*1/(Theta*D*s)*t29 */
    const double t31 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t32 = t30*t31; /* (s*s*Theta*1/(Theta*D*s) - gamma3*s*Theta*1/(Theta*D*s)*t29)*omega_tau*omega_tau */
    const double t33 = x[4]*t24; /* omega3*s*Theta*1/(Theta*D*s) */
    const double t34 = t17*p[22]; /* D*Theta*1/(Theta*D*s)*omega_n*2*I1 */
    const double t35 = t26*t34; /* gamma3*s*Theta*1/(Theta*D*s)*D*Theta*1/(Theta*D*s)*omega_n*2*I1 */
    const double t36 = JLT_FMA(p[21], t33, t35); /* 2*I3*omega3*s*Theta*1/(Theta*D*s) + t35 */
    const double t37 = x[3]*t26; /* omega_n*gamma3*s*Theta*1/(Theta*D*s) */
    const double t38 = JLT_FNMA(t36, t37, t32); /* t32 - (2*I3*omega3*s*Theta*1/(Theta*D*s) + t35)*omega_n*gamma3*s*Theta*1/(Theta*D*s) */
    const double t39 = p[16]*t38; /* m*a3^2*t38 */
    const double t40 = t29*p[9]; /* t29*m*g*a3/I1 */
    const double t41 = t13*t17; /* D*Theta*1/(Theta*D*s)*D*Theta*1/(Theta*D*s)*omega_n */
    const double t42 = JLT_FNMA(t17, t41, t40); /* t29*m*g*a3/I1 - D*Theta*1/(Theta*D*s)*omega_n*D*Theta*1/(Theta*D*s)*D*Theta*1/(Theta*D*s)*omega_n */
    const double t43 = p[4]*t24; /* I1*s*Theta*1/(Theta*D*s) */
    const double t44 = JLT_FMA(t42, t43, t39); /* t42*I1*s*Theta*1/(Theta*D*s) + m*a3^2*t38 */
    const double t45 = x[2]*t28; /* omega_tau*gamma3*s*Theta*1/(Theta*D*s)*s*2*m*a3^2 */
    const double t46 = JLT_FMA(t33, p[5], t35); /* omega3*s*Theta*1/(Theta*D*s)*I3 + t35 */
    const double t47 = -t46; /* -(omega3*s*Theta*1/(Theta*D*s)*I3 + t35) */
    const double t48 = x[3]*p[23]; /* omega_n*(-I3) */
    const double t49 = t24*t48; /* s*Theta*1/(Theta*D*s)*omega_n*(-I3) */
    const double t50 = x[2]*t13; /* omega_tau*D*Theta*1/(Theta*D*s) */
    const double t51 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t52 = JLT_FMA(x[2], t51, x[1]); /* V = omega_tau*e + v_nu */
    const double t53 = t9*t11; /* D*s*1/(Theta*D*s) */
    const double t54 = t52*t53; /* V*D*s*1/(Theta*D*s) */
    const double t55 = t5*t54; /* b*m*I3*V*D*s*1/(Theta*D*s) */
    const double t56 = JLT_FNMA(t14, t55, t50); /* omega_tau*D*Theta*1/(Theta*D*s) - gamma3*D*Theta*1/(Theta*D*s)*b*m*I3*V*D*s*1/(Theta*D*s) */
    const double t57 = x[2]*p[3]; /* omega_tau*a3 */
    const double t58 = x[0]*p[24]; /* gamma3*2*m*R^2*I1 */
    const double t59 = JLT_FMS(t4, p[25], t58); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t60 = JLT_FNMA(t54, t59, t57); /* omega_tau*a3 - V*D*s*1/(Theta*D*s)*d(Theta)/d(gamma3) */
    const double t61 = t5*t53; /* b*m*I3*D*s*1/(Theta*D*s) */
    const double t62 = t17*t61; /* D*Theta*1/(Theta*D*s)*omega_n*b*m*I3*D*s*1/(Theta*D*s) */
    const double t63 = t54*p[26]; /* V*D*s*1/(Theta*D*s)*m*R*I3 */
    const double t64 = t17*t63; /* D*Theta*1/(Theta*D*s)*omega_n*V*D*s*1/(Theta*D*s)*m*R*I3 */
    const double t65 = x[4]*t53; /* omega3*D*s*1/(Theta*D*s) */
    const double t66 = x[2]*t65; /* omega_tau*omega3*D*s*1/(Theta*D*s) */
    const double t67 = JLT_FMA(t51, p[26], p[28]); /* e*m*R*I3 + I3^2 */
    const double t68 = t53*t59; /* D*s*1/(Theta*D*s)*d(Theta)/d(gamma3) */
    const double t69 = JLT_FNMA(t67, t68, p[27]); /* m*R*a3*I3 - (e*m*R*I3 + I3^2)*D*s*1/(Theta*D*s)*d(Theta)/d(gamma3) */
    const double t70 = JLT_FMS(t66, t69, t64); /* omega_tau*omega3*D*s*1/(Theta*D*s)*t69 - D*Theta*1/(Theta*D*s)*omega_n*V*D*s*1/(Theta*D*s)*m*R*I3 */
    const double t71 = JLT_FNMA(t60, t62, t70); /* t70 - (omega_tau*a3 - V*D*s*1/(Theta*D*s)*d(Theta)/d(gamma3))*D*Theta*1/(Theta*D*s)*omega_n*b*m*I3*D*s*1/(Theta*D*s) */
    const double t72 = JLT_FMA(t41, t56, t71); /* D*Theta*1/(Theta*D*s)*D*Theta*1/(Theta*D*s)*omega_n*t56 + t71 */
    const double t73 = -t62; /* -D*Theta*1/(Theta*D*s)*omega_n*b*m*I3*D*s*1/(Theta*D*s) */
    const double t74 = x[0]*t17; /* gamma3*D*Theta*1/(Theta*D*s)*omega_n */
    const double t75 = JLT_FMA(t65, t67, t74); /* omega3*D*s*1/(Theta*D*s)*(e*m*R*I3 + I3^2) + gamma3*D*Theta*1/(Theta*D*s)*omega_n */
    const double t76 = JLT_FNMA(t51, t62, t75); /* t75 - e*D*Theta*1/(Theta*D*s)*omega_n*b*m*I3*D*s*1/(Theta*D*s) */
    const double t77 = JLT_FNMA(t13, t55, t15); /* omega_tau*gamma3*D*Theta*1/(Theta*D*s) - D*Theta*1/(Theta*D*s)*b*m*I3*V*D*s*1/(Theta*D*s) */
    const double t78 = x[2]*t53; /* omega_tau*D*s*1/(Theta*D*s) */
    const double t79 = t67*t78; /* (e*m*R*I3 + I3^2)*omega_tau*D*s*1/(Theta*D*s) */
    const double t80 = x[3]*p[29]; /* omega_n*m*R*I1 */
    const double t81 = t53*t80; /* D*s*1/(Theta*D*s)*omega_n*m*R*I1 */
    const double t82 = t60*t81; /* (omega_tau*a3 - V*D*s*1/(Theta*D*s)*d(Theta)/d(gamma3))*D*s*1/(Theta*D*s)*omega_n*m*R*I1 */
    const double t83 = JLT_FNMA(x[0], p[30], p[27]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t84 = JLT_FMA(t68, t83, p[30]); /* D*s*1/(Theta*D*s)*d(Theta)/d(gamma3)*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + m*R^2*(I1 - I3) */
    const double t85 = t8*t84; /* s*t84 */
    const double t86 = JLT_FMA(t14, t83, t85); /* gamma3*D*Theta*1/(Theta*D*s)*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + s*t84 */
    const double t87 = JLT_FMS(t66, t86, t82); /* omega_tau*omega3*D*s*1/(Theta*D*s)*t86 - t82 */
    const double t88 = -t81; /* -D*s*1/(Theta*D*s)*omega_n*m*R*I1 */
    const double t89 = t8*t83; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t90 = t65*t89; /* omega3*D*s*1/(Theta*D*s)*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t91 = JLT_FMA(t51, t81, t90); /* e*D*s*1/(Theta*D*s)*omega_n*m*R*I1 + t90 */
    const double t92 = -t91; /* -(e*D*s*1/(Theta*D*s)*omega_n*m*R*I1 + t90) */
    const double t93 = t54*p[31]; /* V*D*s*1/(Theta*D*s)*(-m*R*I1) */
    const double t94 = t78*t89; /* omega_tau*D*s*1/(Theta*D*s)*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t95 = -t94; /* -t94 */
    out[0] = t16;
    out[1] = 0.0;
    out[2] = t8;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t21;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t23;
    out[9] = t19;
    out[10] = t44;
    out[11] = 0.0;
    out[12] = t45;
    out[13] = t47;
    out[14] = t49;
    out[15] = t72;
    out[16] = t73;
    out[17] = t76;
    out[18] = t77;
    out[19] = t79;
    out[20] = t87;
    out[21] = t88;
    out[22] = t92;
    out[23] = t93;
    out[24] = t95;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[6], 1.0); /* D scaled = (1 - gamma3)*(1 + gamma3)*m*a3^2/I1 + 1 */
    const double t7 = t5*p[8]; /* b*I3/(R^2*I1) */
    const double t8 = t2 + p[7]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t9 = JLT_FMA(t5, t7, t8); /* Theta scaled = b*b*I3/(R^2*I1) + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t10 = t3*t6; /* s*D scaled */
    const double t11 = t9*t10; /* Theta scaled*s*D scaled */
    const double t12 = 1.0/t11; /* 1/(Theta scaled*s*D scaled) */
    const double t13 = t9*t12; /* Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t14 = t6*t13; /* D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t15 = x[3]*t14; /* omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t16 = t5*t15; /* b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t17 = p[1]*x[4]; /* R*omega3 */
    const double t18 = t16 + t17; /* b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) + R*omega3 */
    const double t19 = x[3]*t18; /* omega_n*t18 */
    const double t20 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t21 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t22 = JLT_FNMA(t20, t21, p[9]); /* m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3 */
    const double t23 = t3*t13; /* s*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t24 = t3*t22; /* s*(m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3) */
    const double t25 = t23*t24; /* s*Theta scaled*1/(Theta scaled*s*D scaled)*s*(m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3) */
    const double t26 = x[0]*t14; /* gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t27 = x[3]*t26; /* omega_n*gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t28 = t23*t27; /* s*Theta scaled*1/(Theta scaled*s*D scaled)*t27 */
    const double t29 = t23*p[10]; /* s*Theta scaled*1/(Theta scaled*s*D scaled)*I3/I1 */
    const double t30 = x[4]*t29; /* omega3*s*Theta scaled*1/(Theta scaled*s*D scaled)*I3/I1 */
    const double t31 = t28 + t30; /* s*Theta scaled*1/(Theta scaled*s*D scaled)*t27 + omega3*s*Theta scaled*1/(Theta scaled*s*D scaled)*I3/I1 */
    const double t32 = JLT_FMA(x[3], t31, t25); /* omega_n*t31 + t25 */
    const double t33 = -t32; /* -(omega_n*t31 + t25) */
    const double t34 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t35 = JLT_FMA(x[2], t34, x[1]); /* V = omega_tau*e + v_nu */
    const double t36 = t10*t12; /* s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t37 = t35*t36; /* V*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t38 = p[8]*t16; /* I3/(R^2*I1)*b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t39 = t37*t38; /* V*s*D scaled*1/(Theta scaled*s*D scaled)*t38 */
    const double t40 = t34 + p[12]; /* e + I3/(m*R) */
    const double t41 = p[11]*t40; /* I3/(R*I1)*(e + I3/(m*R)) */
    const double t42 = x[2]*t36; /* omega_tau*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t43 = x[4]*t42; /* omega3*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t44 = JLT_FMS(t41, t43, t39); /* I3/(R*I1)*(e + I3/(m*R))*omega3*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled) - V*s*D scaled*1/(Theta scaled*s*D scaled)*t38 */
    const double t45 = JLT_FMA(x[2], t27, t44); /* omega_tau*t27 + t44 */
    const double t46 = x[3]*p[13]; /* omega_n*1/R */
    const double t47 = t37*t46; /* V*s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R */
    const double t48 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t49 = t3*t48; /* s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t50 = JLT_FMA(t43, t49, t47); /* omega3*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + V*s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R */
    const double t51 = -t50; /* -t50 */
    const double t52 = x[2]*t26; /* omega_tau*gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t53 = -t52; /* -t52 */
    const double t54 = x[3]*p[1]; /* omega_n*R */
    const double t55 = JLT_FMA(t16, t26, t54); /* b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) + omega_n*R */
    const double t56 = t15*t55; /* omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t55 */
    const double t57 = JLT_FMA(t16, 2.0, t17); /* b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*2 + R*omega3 */
    const double t58 = t4*t20; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t59 = t14*t15; /* D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t60 = JLT_FMA(t22, t26, t58); /* (m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3)*gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) + omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t61 = JLT_FNMA(t15, t59, t60); /* t60 - omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t59 */
    const double t62 = t23*t61; /* s*Theta scaled*1/(Theta scaled*s*D scaled)*t61 */
    const double t63 = x[0]*p[32]; /* gamma3*2*m*a3^2/I1 */
    const double t64 = t23*t63; /* s*Theta scaled*1/(Theta scaled*s*D scaled)*gamma3*2*m*a3^2/I1 */
    const double t65 = JLT_FNMA(t32, t64, t62); /* s*Theta scaled*1/(Theta scaled*s*D scaled)*t61 - (omega_n*t31 + t25)*t64 */
    const double t66 = t4*t64; /* omega_tau*s*t64 */
    const double t67 = JLT_FMA(t28, 2.0, t30); /* s*Theta scaled*1/(Theta scaled*s*D scaled)*t27*2 + omega3*s*Theta scaled*1/(Theta scaled*s*D scaled)*I3/I1 */
    const double t68 = -t67; /* -t67 */
    const double t69 = x[3]*t29; /* omega_n*s*Theta scaled*1/(Theta scaled*s*D scaled)*I3/I1 */
    const double t70 = -t69; /* -omega_n*s*Theta scaled*1/(Theta scaled*s*D scaled)*I3/I1 */
    const double t71 = JLT_FMS(t5, p[11], x[0]); /* d(Theta)/d(gamma3) scaled = b*I3/(R*I1) - gamma3 */
    const double t72 = t36*t71; /* s*D scaled*1/(Theta scaled*s*D scaled)*d(Theta)/d(gamma3) scaled */
    const double t73 = t37*t72; /* V*s*D scaled*1/(Theta scaled*s*D scaled)*t72 */
    const double t74 = p[33]*t73; /* 2*I3/(R^2*I1)*V*s*D scaled*1/(Theta scaled*s*D scaled)*t72 */
    const double t75 = t16*t74; /* b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*2*I3/(R^2*I1)*V*s*D scaled*1/(Theta scaled*s*D scaled)*t72 */
    const double t76 = x[2]*t59; /* omega_tau*t59 */
    const double t77 = JLT_FNMA(t26, t39, t76); /* omega_tau*t59 - gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*V*s*D scaled*1/(Theta scaled*s*D scaled)*t38 */
    const double t78 = t37*p[11]; /* V*s*D scaled*1/(Theta scaled*s*D scaled)*I3/(R*I1) */
    const double t79 = t42*p[34]; /* omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*a3*I3/(R^2*I1) */
    const double t80 = JLT_FNMA(t40, t72, p[36]); /* 1/2*a3 - (e + I3/(m*R))*t72 */
    const double t81 = t43*p[35]; /* omega3*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*2*I3/(R*I1) */
    const double t82 = JLT_FNMA(t15, t78, t75); /* t75 - omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*V*s*D scaled*1/(Theta scaled*s*D scaled)*I3/(R*I1) */
    const double t83 = JLT_FNMA(t16, t79, t82); /* t82 - b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t79 */
    const double t84 = JLT_FMA(t80, t81, t83); /* (1/2*a3 - (e + I3/(m*R))*t72)*t81 + t83 */
    const double t85 = JLT_FMA(t14, t77, t84); /* D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t77 + (1/2*a3 - (e + I3/(m*R))*t72)*t81 + t83 */
    const double t86 = t36*t38; /* s*D scaled*1/(Theta scaled*s*D scaled)*t38 */
    const double t87 = -t86; /* -s*D scaled*1/(Theta scaled*s*D scaled)*t38 */
    const double t88 = x[4]*t36; /* omega3*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t89 = JLT_FMA(t41, t88, t27); /* I3/(R*I1)*(e + I3/(m*R))*omega3*s*D scaled*1/(Theta scaled*s*D scaled) + t27 */
    const double t90 = JLT_FNMA(t34, t86, t89); /* t89 - e*s*D scaled*1/(Theta scaled*s*D scaled)*t38 */
    const double t91 = t7*t37; /* b*I3/(R^2*I1)*V*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t92 = JLT_FNMA(t14, t91, t52); /* t52 - D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*b*I3/(R^2*I1)*V*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t93 = t41*t42; /* I3/(R*I1)*(e + I3/(m*R))*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t94 = JLT_FNMA(t42, p[36], t73); /* V*s*D scaled*1/(Theta scaled*s*D scaled)*t72 - omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*1/2*a3 */
    const double t95 = x[3]*p[37]; /* omega_n*2/R */
    const double t96 = t94*t95; /* t94*omega_n*2/R */
    const double t97 = JLT_FNMA(x[0], p[39], p[38]); /* 2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1 */
    const double t98 = JLT_FMA(t72, t97, p[15]); /* t72*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) + (I1 - I3)/I1 */
    const double t99 = t3*t98; /* s*(t72*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) + (I1 - I3)/I1) */
    const double t100 = JLT_FMA(t26, t48, t99); /* gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + t99 */
    const double t101 = JLT_FMA(t43, t100, t96); /* omega3*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*t100 + t94*omega_n*2/R */
    const double t102 = t36*t46; /* s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R */
    const double t103 = -t102; /* -s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R */
    const double t104 = t49*t88; /* s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*omega3*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t105 = JLT_FMA(t34, t102, t104); /* e*s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R + t104 */
    const double t106 = -t105; /* -(e*s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R + t104) */
    const double t107 = t37*p[40]; /* V*s*D scaled*1/(Theta scaled*s*D scaled)*(-1/R) */
    const double t108 = t42*t49; /* omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t109 = -t108; /* -t108 */
    out[0] = t4;
    out[1] = t19;
    out[2] = t33;
    out[3] = t45;
    out[4] = t51;
    out[5] = t53;
    out[6] = 0.0;
    out[7] = t3;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = t56;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t57;
    out[14] = t54;
    out[15] = t65;
    out[16] = 0.0;
    out[17] = t66;
    out[18] = t68;
    out[19] = t70;
    out[20] = t85;
    out[21] = t87;
    out[22] = t90;
    out[23] = t92;
    out[24] = t93;
    out[25] = t101;
    out[26] = t103;
    out[27] = t106;
    out[28] = t107;
    out[29] = t109;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0] + p[41]; /* b scaled = gamma3 + a3/R */
    const double t5 = p[10]*t4; /* I3/I1*b scaled */
    const double t6 = t2 + p[7]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta scaled = b scaled*I3/I1*b scaled + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t8 = JLT_FMA(t2, p[16], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t9 = t3*t8; /* s*D */
    const double t10 = t7*t9; /* Theta scaled*s*D */
    const double t11 = 1.0/t10; /* 1/(Theta scaled*s*D) */
    const double t12 = t7*t11; /* Theta scaled*1/(Theta scaled*s*D) */
    const double t13 = x[0]*p[20]; /* gamma3*2*m*a3^2 */
    const double t14 = t3*t13; /* s*gamma3*2*m*a3^2 */
    const double t15 = t12*t14; /* Theta scaled*1/(Theta scaled*s*D)*s*gamma3*2*m*a3^2 */
    const double t16 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t17 = t9*t11; /* s*D*1/(Theta scaled*s*D) */
    const double t18 = JLT_FNMA(t16, t17, t15); /* Theta scaled*1/(Theta scaled*s*D)*s*gamma3*2*m*a3^2 - (a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*s*D*1/(Theta scaled*s*D) */
    const double t19 = x[2]*t3; /* omega_tau*s */
    const double t20 = t18*t19; /* t18*omega_tau*s */
    const double t21 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t22 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t23 = t4*p[11]; /* b scaled*I3/(R*I1) */
    const double t24 = t8*t23; /* D*b scaled*I3/(R*I1) */
    const double t25 = t22*t24; /* V*D*b scaled*I3/(R*I1) */
    const double t26 = t12*t25; /* Theta scaled*1/(Theta scaled*s*D)*V*D*b scaled*I3/(R*I1) */
    const double t27 = JLT_FNMA(t17, t26, t20); /* t18*omega_tau*s - s*D*1/(Theta scaled*s*D)*Theta scaled*1/(Theta scaled*s*D)*V*D*b scaled*I3/(R*I1) */
    out[0] = t27;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[43]*x[0]; /* 2*g*a3*gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(p[16], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = p[44]*x[2]; /* 1/m*omega_tau */
    const double t6 = x[2]*t5; /* omega_tau*1/m*omega_tau */
    const double t7 = p[45]*x[3]; /* I1/m*omega_n */
    const double t8 = p[46]*x[4]; /* I3/m*omega3 */
    const double t9 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = x[3]*t9; /* omega_n*b */
    const double t11 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t12 = x[4]*p[1]; /* omega3*R */
    const double t13 = JLT_FMA(t11, t12, t10); /* v_tau = s*omega3*R + omega_n*b */
    const double t14 = JLT_FMA(x[1], x[1], t0); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t15 = JLT_FMA(x[3], t7, t14); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t16 = JLT_FMA(x[4], t8, t15); /* omega3*I3/m*omega3 + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t17 = JLT_FMA(t4, t6, t16); /* D*omega_tau*1/m*omega_tau + t16 */
    const double t18 = JLT_FMA(t13, t13, t17); /* energy scaled = v_tau*v_tau + D*omega_tau*1/m*omega_tau + t16 */
    const double t19 = p[42]*t18; /* 1/2*m*energy scaled */
    const double t20 = x[3]*p[47]; /* omega_n*R*I1 */
    const double t21 = t11*t20; /* s*omega_n*R*I1 */
    const double t22 = x[4]*p[5]; /* omega3*I3 */
    const double t23 = JLT_FNMA(t9, t22, t21); /* s*omega_n*R*I1 - b*omega3*I3 */
    out[0] = t19;
    out[1] = t23;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[16]*x[0]; /* m*a3^2*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = x[0]/t5; /* gamma3/s */
    const double t7 = JLT_FNMA(x[4], t6, x[3]); /* d(v_tau)/d(gamma3) scaled = omega_n - omega3*gamma3/s */
    const double t8 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t9 = x[3]*t8; /* omega_n*b */
    const double t10 = x[4]*p[1]; /* omega3*R */
    const double t11 = JLT_FMA(t5, t10, t9); /* v_tau = s*omega3*R + omega_n*b */
    const double t12 = p[49]*t11; /* m*R*v_tau */
    const double t13 = JLT_FNMA(t0, t1, p[48]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t14 = JLT_FMA(t7, t12, t13); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3) scaled*m*R*v_tau + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t15 = p[0]*x[1]; /* m*v_nu */
    const double t16 = JLT_FMA(p[16], t4, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t17 = x[2]*t16; /* omega_tau*D */
    const double t18 = x[3]*p[4]; /* omega_n*I1 */
    const double t19 = t8*p[0]; /* b*m */
    const double t20 = JLT_FMA(t11, t19, t18); /* d(energy)/d(omega_n) = v_tau*b*m + omega_n*I1 */
    const double t21 = x[4]*p[5]; /* omega3*I3 */
    const double t22 = JLT_FMA(t5, t12, t21); /* d(energy)/d(omega3) = s*m*R*v_tau + omega3*I3 */
    const double t23 = x[3]*p[50]; /* omega_n*(-R*I1) */
    const double t24 = t6*t23; /* gamma3/s*omega_n*(-R*I1) */
    const double t25 = JLT_FMA(x[4], p[51], t24); /* omega3*(-R*I3) + gamma3/s*omega_n*(-R*I1) */
    const double t26 = t5*p[47]; /* s*R*I1 */
    const double t27 = t8*p[23]; /* b*(-I3) */
    out[0] = t14;
    out[1] = t15;
    out[2] = t17;
    out[3] = t20;
    out[4] = t22;
    out[5] = t25;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t26;
    out[9] = t27;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
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
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t10[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t13[k] = t5[k]*p[6] + (k == 0 ? 1.0 : 0);
        t16[k] = t10[k]*p[8];
        t17[k] = t5[k] + (k == 0 ? p[7] : 0);
        t18[k] = jlt_jet_product(t10, t16, k) + t17[k];
        t19[k] = jlt_jet_product(t6, t13, k);
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t20, t21, k);
        t22[k] = jlt_jet_product(t18, t21, k);
        t23[k] = jlt_jet_product(x3, t13, k);
        t24[k] = jlt_jet_product(t22, t23, k);
        t25[k] = jlt_jet_product(x3, t24, k);
        t26[k] = jlt_jet_product(t10, t25, k);
        t28[k] = jlt_jet_product(x3, x4, k);
        t29[k] = p[1]*t28[k] + t26[k];
        t30[k] = x2[k]*p[6];
        t31[k] = jlt_jet_product(t7, t30, k) - t25[k];
        t32[k] = jlt_jet_product(x0, t31, k);
        t35[k] = t32[k] - t28[k]*p[10];
        t36[k] = t35[k] - t6[k]*p[9];
        t37[k] = jlt_jet_product(t6, t22, k);
        t38[k] = jlt_jet_product(t36, t37, k);
        t39[k] = jlt_jet_product(x2, x0, k);
        t41[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t42[k] = jlt_jet_product(x2, t41, k) + x1[k];
        t43[k] = jlt_jet_product(t19, t21, k);
        t44[k] = jlt_jet_product(t42, t43, k);
        t45[k] = t39[k] - jlt_jet_product(t16, t44, k);
        t46[k] = jlt_jet_product(t24, t45, k);
        t49[k] = t41[k] + (k == 0 ? p[12] : 0);
        t50[k] = jlt_jet_product(x4, t43, k);
        t51[k] = x2[k]*p[11];
        t52[k] = jlt_jet_product(t49, t51, k);
        t53[k] = jlt_jet_product(t50, t52, k) + t46[k];
        t55[k] = x3[k]*p[13];
        t56[k] = jlt_jet_product(t44, t55, k);
        t59[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t60[k] = jlt_jet_product(t7, t59, k);
        t61[k] = jlt_jet_product(t50, t60, k) + t56[k];
        t62[k] = -t61[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t29[k]/(k + 1);
        next[2] = x2[k + 1] = t38[k]/(k + 1);
        next[3] = x3[k + 1] = t53[k]/(k + 1);
        next[4] = x4[k + 1] = t62[k]/(k + 1);
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
    const double complex v_omega3 = x[4];
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = params[5];
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
    out[4] = (-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta);
}

static const unsigned char family0_is_free[] = { 1, 1, 0, 0, 1 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = x[4];
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[5]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I3*gamma3*v_nu */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = t4*t5; /* (1 + gamma3)*(1 - gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t8 = params[5]*params[4]; /* I3*I1 */
    const double t9 = params[1]*params[1]; /* R*R */
    const double t10 = params[0]*t9; /* m*R*R */
    const double t11 = params[4]*t10; /* I1*m*R*R */
    const double t12 = t7*t7; /* s*s */
    const double t13 = t11*t12; /* I1*m*R*R*s*s */
    const double t14 = t8 + t13; /* I3*I1 + I1*m*R*R*s*s */
    const double t15 = params[0]*params[5]; /* m*I3 */
    const double t16 = params[1]*x[0]; /* R*gamma3 */
    const double t17 = params[3] + t16; /* b = a3 + R*gamma3 */
    const double t18 = t17*t17; /* b*b */
    const double t19 = t15*t18; /* m*I3*b*b */
    const double t20 = t14 + t19; /* Theta = I3*I1 + I1*m*R*R*s*s + m*I3*b*b */
    const double t21 = t7*t20; /* s*Theta */
    const double t22 = t3/t21; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t23 = -t22; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t23;
}

static void family0_charpoly(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = t0*t1; /* (1 + gamma3)*(1 - gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t4 = params[4]*t3; /* I1*s */
    const double t5 = params[4]*params[5]; /* I1*I3 */
    const double t6 = params[1]*params[1]; /* R*R */
    const double t7 = params[0]*t6; /* m*R*R */
    const double t8 = params[4]*t7; /* I1*m*R*R */
    const double t9 = t3*t3; /* s*s */
    const double t10 = t8*t9; /* I1*m*R*R*s*s */
    const double t11 = t5 + t10; /* I1*I3 + I1*m*R*R*s*s */
    const double t12 = params[5]*params[0]; /* I3*m */
    const double t13 = x[0]*params[1]; /* gamma3*R */
    const double t14 = params[3] + t13; /* b = a3 + gamma3*R */
    const double t15 = t14*t14; /* b*b */
    const double t16 = t12*t15; /* I3*m*b*b */
    const double t17 = t11 + t16; /* Theta = I1*I3 + I1*m*R*R*s*s + I3*m*b*b */
    const double t18 = t4*t17; /* I1*s*Theta */
    const double t19 = params[0]*params[1]; /* m*R */
    const double t20 = params[4]*t19; /* I1*m*R */
    const double t21 = params[5]*t20; /* I3*I1*m*R */
    const double t22 = x[0]*t21; /* gamma3*I3*I1*m*R */
    const double t23 = t22*x[1]; /* gamma3*I3*I1*m*R*v_nu */
    const double t24 = params[5]*params[5]; /* I3*I3 */
    const double t25 = x[4]*x[4]; /* omega3*omega3 */
    const double t26 = t24*t25; /* I3*I3*omega3*omega3 */
    const double t27 = t3*t26; /* s*I3*I3*omega3*omega3 */
    const double t28 = params[5] + t7; /* I3 + m*R*R */
    const double t29 = t27*t28; /* s*I3*I3*omega3*omega3*(I3 + m*R*R) */
    out[0] = t18;
    out[1] = t23;
    out[2] = t29;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = x[0] + 1.0; /* gamma3 + 1 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = t0*t1; /* (gamma3 + 1)*(1 - gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((gamma3 + 1)*(1 - gamma3)) */
    const double t4 = params[1]*x[4]; /* R*omega3 */
    const double t5 = x[4]*params[5]; /* omega3*I3 */
    const double t6 = t5/params[4]; /* omega3*I3/I1 */
    const double t7 = -t6; /* -omega3*I3/I1 */
    const double t8 = params[4]*params[5]; /* I1*I3 */
    const double t9 = params[1]*params[1]; /* R*R */
    const double t10 = params[0]*t9; /* m*R*R */
    const double t11 = params[4]*t10; /* I1*m*R*R */
    const double t12 = t3*t3; /* s*s */
    const double t13 = t11*t12; /* I1*m*R*R*s*s */
    const double t14 = t8 + t13; /* I1*I3 + I1*m*R*R*s*s */
    const double t15 = params[5]*params[0]; /* I3*m */
    const double t16 = x[0]*params[1]; /* gamma3*R */
    const double t17 = params[3] + t16; /* b = a3 + gamma3*R */
    const double t18 = t17*t17; /* b*b */
    const double t19 = t15*t18; /* I3*m*b*b */
    const double t20 = t14 + t19; /* Theta = I1*I3 + I1*m*R*R*s*s + I3*m*b*b */
    const double t21 = params[5] + t10; /* I3 + m*R*R */
    const double t22 = t5*t21; /* omega3*I3*(I3 + m*R*R) */
    const double t23 = t22/t20; /* omega3*I3*(I3 + m*R*R)/Theta */
    const double t24 = params[1]*params[0]; /* R*m */
    const double t25 = params[5]*t24; /* I3*R*m */
    const double t26 = x[0]*t25; /* gamma3*I3*R*m */
    const double t27 = t26*x[1]; /* gamma3*I3*R*m*v_nu */
    const double t28 = t3*t20; /* s*Theta */
    const double t29 = t27/t28; /* gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t30 = -t29; /* -gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t31 = x[0]*t10; /* gamma3*m*R*R */
    const double t32 = x[4]*t31; /* omega3*gamma3*m*R*R */
    const double t33 = t3*t32; /* s*omega3*gamma3*m*R*R */
    const double t34 = params[4] - params[5]; /* I1 - I3 */
    const double t35 = t33*t34; /* s*omega3*gamma3*m*R*R*(I1 - I3) */
    const double t36 = t35/t20; /* s*omega3*gamma3*m*R*R*(I1 - I3)/Theta */
    const double t37 = params[4]*t24; /* I1*R*m */
    const double t38 = x[1]*t37; /* v_nu*I1*R*m */
    const double t39 = t38/t20; /* v_nu*I1*R*m/Theta */
    const double t40 = -t39; /* -v_nu*I1*R*m/Theta */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t3;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t4;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t7;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = t23;
    out[18] = t30;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = t36;
    out[23] = t40;
    out[24] = 0.0;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = params[3]*t0; /* a3*m*g */
    const double t2 = x[0]*params[1]; /* gamma3*R */
    const double t3 = params[3] + t2; /* b = a3 + gamma3*R */
    const double t4 = params[1]*x[4]; /* R*omega3 */
    const double t5 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t6 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t7 = t5*t6; /* (1 + gamma3)*(1 - gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t9 = t4*t8; /* v_tau = R*omega3*s */
    const double t10 = params[0]*t9; /* m*v_tau */
    const double t11 = t2*x[4]; /* gamma3*R*omega3 */
    const double t12 = t11/t8; /* gamma3*R*omega3/s */
    const double t13 = t10*t12; /* m*v_tau*gamma3*R*omega3/s */
    const double t14 = t1 - t13; /* d(energy)/d(gamma3) = a3*m*g - m*v_tau*gamma3*R*omega3/s */
    const double t15 = params[0]*x[1]; /* m*v_nu */
    const double t16 = t8*t8; /* s*s */
    const double t17 = params[0]*t3; /* m*b */
    const double t18 = t9*t17; /* d(energy)/d(omega_n) = v_tau*m*b */
    const double t19 = x[4]*params[5]; /* omega3*I3 */
    const double t20 = params[0]*params[1]; /* m*R */
    const double t21 = t8*t20; /* s*m*R */
    const double t22 = t9*t21; /* v_tau*s*m*R */
    const double t23 = t19 + t22; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    const double t24 = params[1]*params[4]; /* R*I1 */
    const double t25 = params[1]*params[5]; /* R*I3 */
    const double t26 = x[4]*t25; /* omega3*R*I3 */
    const double t27 = -t26; /* -omega3*R*I3 */
    const double t28 = t8*t24; /* s*R*I1 */
    const double t29 = t3*params[5]; /* b*I3 */
    const double t30 = -t29; /* -b*I3 */
    const double t31 = x[4]*x[4]; /* omega3*omega3 */
    const double t32 = params[4] - params[5]; /* I1 - I3 */
    const double t33 = t31*t32; /* omega3*omega3*(I1 - I3) */
    const double t34 = params[1]*params[1]; /* R*R */
    const double t35 = params[0]*t34; /* m*R*R */
    const double t36 = params[4]*t35; /* I1*m*R*R */
    const double t37 = x[0]*t36; /* gamma3*I1*m*R*R */
    const double t38 = t37*2.0; /* gamma3*I1*m*R*R*2 */
    const double t39 = params[5]*t20; /* I3*m*R */
    const double t40 = t3*t39; /* b*I3*m*R */
    const double t41 = 2.0*t40; /* 2*b*I3*m*R */
    const double t42 = t41 - t38; /* d(Theta)/d(gamma3) = 2*b*I3*m*R - gamma3*I1*m*R*R*2 */
    const double t43 = t33*t42; /* omega3*omega3*(I1 - I3)*d(Theta)/d(gamma3) */
    const double t44 = params[0]*2.0; /* m*2 */
    const double t45 = params[4]*params[4]; /* I1*I1 */
    const double t46 = t44*t45; /* m*2*I1*I1 */
    const double t47 = x[1]*t46; /* v_nu*m*2*I1*I1 */
    const double t48 = params[1]*t44; /* R*m*2 */
    const double t49 = t45*t48; /* I1*I1*R*m*2 */
    const double t50 = x[1]*t49; /* v_nu*I1*I1*R*m*2 */
    const double t51 = x[4]*2.0; /* omega3*2 */
    const double t52 = params[4]*params[5]; /* I1*I3 */
    const double t53 = t16*t36; /* s*s*I1*m*R*R */
    const double t54 = t52 + t53; /* I1*I3 + s*s*I1*m*R*R */
    const double t55 = params[0]*params[5]; /* m*I3 */
    const double t56 = t3*t3; /* b*b */
    const double t57 = t55*t56; /* m*I3*b*b */
    const double t58 = t54 + t57; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t59 = t51*t58; /* omega3*2*Theta */
    const double t60 = t32*t59; /* (I1 - I3)*omega3*2*Theta */
    out[0] = t14;
    out[1] = t15;
    out[2] = 0.0;
    out[3] = t18;
    out[4] = t23;
    out[5] = t27;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t28;
    out[9] = t30;
    out[10] = t43;
    out[11] = t47;
    out[12] = t50;
    out[13] = 0.0;
    out[14] = t60;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "G", "" },
    { "F0", "a3 = 0" },
};

static const unsigned char family1_is_free[] = { 1, 1, 0, 0, 1 };

static void family1_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = 0.0;
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
}

static void family1_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = x[4];
}

static void family1_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[5]; /* m*I3 */
    const double t1 = t0*x[1]; /* m*I3*v_nu */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = t2*t3; /* (1 + gamma3)*(1 - gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t6 = x[0]*params[1]; /* gamma3*R */
    const double t7 = params[3] + t6; /* b = a3 + gamma3*R */
    const double t8 = t1*t7; /* m*I3*v_nu*b */
    const double t9 = params[5]*params[4]; /* I3*I1 */
    const double t10 = params[1]*params[1]; /* R*R */
    const double t11 = params[0]*t10; /* m*R*R */
    const double t12 = params[4]*t11; /* I1*m*R*R */
    const double t13 = t5*t5; /* s*s */
    const double t14 = t12*t13; /* I1*m*R*R*s*s */
    const double t15 = t9 + t14; /* I3*I1 + I1*m*R*R*s*s */
    const double t16 = t7*t7; /* b*b */
    const double t17 = t0*t16; /* m*I3*b*b */
    const double t18 = t15 + t17; /* Theta = I3*I1 + I1*m*R*R*s*s + m*I3*b*b */
    const double t19 = t5*t18; /* s*Theta */
    const double t20 = t8/t19; /* m*I3*v_nu*b/(s*Theta) */
    const double t21 = -t20; /* -m*I3*v_nu*b/(s*Theta) */
    out[0] = t21;
}

static void family1_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = params[3]*t0; /* a3*m*g */
    const double t2 = x[0]*params[1]; /* gamma3*R */
    const double t3 = params[3] + t2; /* b = a3 + gamma3*R */
    const double t4 = params[1]*x[4]; /* R*omega3 */
    const double t5 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t6 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t7 = t5*t6; /* (1 + gamma3)*(1 - gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t9 = t4*t8; /* v_tau = R*omega3*s */
    const double t10 = params[0]*t9; /* m*v_tau */
    const double t11 = t2*x[4]; /* gamma3*R*omega3 */
    const double t12 = t11/t8; /* gamma3*R*omega3/s */
    const double t13 = t10*t12; /* m*v_tau*gamma3*R*omega3/s */
    const double t14 = t1 - t13; /* d(energy)/d(gamma3) = a3*m*g - m*v_tau*gamma3*R*omega3/s */
    const double t15 = params[0]*x[1]; /* m*v_nu */
    const double t16 = params[0]*t3; /* m*b */
    const double t17 = t9*t16; /* d(energy)/d(omega_n) = v_tau*m*b */
    const double t18 = x[4]*params[5]; /* omega3*I3 */
    const double t19 = params[0]*params[1]; /* m*R */
    const double t20 = t8*t19; /* s*m*R */
    const double t21 = t9*t20; /* v_tau*s*m*R */
    const double t22 = t18 + t21; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    const double t23 = params[1]*params[4]; /* R*I1 */
    const double t24 = params[1]*params[5]; /* R*I3 */
    const double t25 = x[4]*t24; /* omega3*R*I3 */
    const double t26 = -t25; /* -omega3*R*I3 */
    const double t27 = t8*t23; /* s*R*I1 */
    const double t28 = t3*params[5]; /* b*I3 */
    const double t29 = -t28; /* -b*I3 */
    out[0] = t14;
    out[1] = t15;
    out[2] = 0.0;
    out[3] = t17;
    out[4] = t22;
    out[5] = t26;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t27;
    out[9] = t29;
}

static const jlt_named family1_left_null[] = {
    { "E", "" },
    { "G", "" },
};

static const unsigned char family2_is_free[] = { 1, 0, 0, 1, 0 };

static void family2_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[3]; /* m*R*a3 */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = t3*t4; /* (1 + gamma3)*(1 - gamma3) */
    const double t6 = sqrt(t5); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t7 = t6*t6; /* s*s */
    const double t8 = t1*t7; /* m*R*a3*s*s */
    const double t9 = params[1]*x[0]; /* R*gamma3 */
    const double t10 = params[3] + t9; /* b = a3 + R*gamma3 */
    const double t11 = params[5]*t10; /* I3*b */
    const double t12 = params[1]*params[4]; /* R*I1 */
    const double t13 = x[0]*t12; /* gamma3*R*I1 */
    const double t14 = t11 - t13; /* I3*b - gamma3*R*I1 */
    const double t15 = t2*t14; /* omega_n*omega_n*(I3*b - gamma3*R*I1) */
    const double t16 = t15/t8; /* g = omega_n*omega_n*(I3*b - gamma3*R*I1)/(m*R*a3*s*s) */
    out[0] = params[0];
    out[1] = params[1];
    out[2] = t16;
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
}

static void family2_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = x[0] + 1.0; /* gamma3 + 1 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = t0*t1; /* (gamma3 + 1)*(1 - gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((gamma3 + 1)*(1 - gamma3)) */
    const double t4 = params[1]*t3; /* R*s */
    const double t5 = x[0]*params[1]; /* gamma3*R */
    const double t6 = params[3] + t5; /* b = a3 + gamma3*R */
    const double t7 = x[3]*t6; /* omega_n*b */
    const double t8 = t7/t4; /* omega_n*b/(R*s) */
    const double t9 = -t8; /* omega3 = -omega_n*b/(R*s) */
    out[0] = x[0];
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = x[3];
    out[4] = t9;
}

static void family2_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
}

static void family2_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = params[3]*t0; /* a3*m*g */
    const double t2 = x[0]*params[1]; /* gamma3*R */
    const double t3 = params[3] + t2; /* b = a3 + gamma3*R */
    const double t4 = x[3]*t3; /* omega_n*b */
    const double t5 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t6 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t7 = t5*t6; /* (1 + gamma3)*(1 - gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t9 = params[1]*t8; /* R*s */
    const double t10 = t4/t9; /* omega_n*b/(R*s) */
    const double t11 = params[1]*t10; /* R*omega_n*b/(R*s) */
    const double t12 = t8*t11; /* s*R*omega_n*b/(R*s) */
    const double t13 = t4 - t12; /* v_tau = omega_n*b - s*R*omega_n*b/(R*s) */
    const double t14 = params[0]*t13; /* m*v_tau */
    const double t15 = x[3]*params[1]; /* omega_n*R */
    const double t16 = t2*t10; /* gamma3*R*omega_n*b/(R*s) */
    const double t17 = t16/t8; /* gamma3*R*omega_n*b/(R*s)/s */
    const double t18 = t15 + t17; /* d(v_tau)/d(gamma3) = omega_n*R + gamma3*R*omega_n*b/(R*s)/s */
    const double t19 = t14*t18; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t20 = t1 + t19; /* d(energy)/d(gamma3) = a3*m*g + m*v_tau*d(v_tau)/d(gamma3) */
    const double t21 = x[3]*params[4]; /* omega_n*I1 */
    const double t22 = params[0]*t3; /* m*b */
    const double t23 = t13*t22; /* v_tau*m*b */
    const double t24 = t21 + t23; /* d(energy)/d(omega_n) = omega_n*I1 + v_tau*m*b */
    const double t25 = t10*params[5]; /* omega_n*b/(R*s)*I3 */
    const double t26 = params[0]*params[1]; /* m*R */
    const double t27 = t8*t26; /* s*m*R */
    const double t28 = t13*t27; /* v_tau*s*m*R */
    const double t29 = t28 - t25; /* d(energy)/d(omega3) = v_tau*s*m*R - omega_n*b/(R*s)*I3 */
    const double t30 = params[1]*params[4]; /* R*I1 */
    const double t31 = x[0]*t30; /* gamma3*R*I1 */
    const double t32 = x[3]*t31; /* omega_n*gamma3*R*I1 */
    const double t33 = t32/t8; /* omega_n*gamma3*R*I1/s */
    const double t34 = params[1]*params[5]; /* R*I3 */
    const double t35 = t10*t34; /* omega_n*b/(R*s)*R*I3 */
    const double t36 = t35 - t33; /* omega_n*b/(R*s)*R*I3 - omega_n*gamma3*R*I1/s */
    const double t37 = t8*t30; /* s*R*I1 */
    const double t38 = t3*params[5]; /* b*I3 */
    const double t39 = -t38; /* -b*I3 */
    out[0] = t20;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = t24;
    out[4] = t29;
    out[5] = t36;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t37;
    out[9] = t39;
}

static const jlt_named family2_left_null[] = {
    { "E", "" },
    { "G", "" },
};

static const jlt_equilibria equilibria[] = {
    { .name = "spin", .condition = "a3 = 0",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .charpoly = family0_charpoly,
      .matrix = family0_matrix,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 3, .obstructs = 1 },
    { .name = "spin_weightless", .condition = "g = 0",
      .is_free = family1_is_free,
      .impose = family1_impose,
      .point = family1_point,
      .trace = family1_trace,
      .left_null = family1_left_null,
      .left_null_gradients = family1_left_null_gradients,
      .left_null_count = 2, .obstructs = 1 },
    { .name = "precession", .condition = "g = omega_n^2*(I3*b - R*I1*gamma3)/(m*R*a3*s^2)",
      .is_free = family2_is_free,
      .impose = family2_impose,
      .point = family2_point,
      .trace = family2_trace,
      .left_null = family2_left_null,
      .left_null_gradients = family2_left_null_gradients,
      .left_null_count = 2, .obstructs = 0 },
};

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
};

const jlt_descriptor jlt_kernels_spherical_top_general = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 5, .param_count = 6, .block_count = 52,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 5, 25, 13, 1, 1, 0, 14, 11 }, { 17, 69, 0, 12, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 25, { 9, 55, 30, 1, 1, 0, 16, 20 }, { 52, 271, 0, 49, 1, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 15, 60, 33, 1, 1, 0, 15, 32 }, { 62, 323, 0, 61, 1, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 4, 15, 7, 1, 1, 0, 11, 9 }, { 11, 38, 0, 4, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 2, 12, 9, 0, 1, 0, 7, 10 }, { 10, 32, 0, 0, 1, 0, 12, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 10, { 2, 15, 9, 1, 1, 0, 6, 10 }, { 12, 38, 0, 2, 1, 0, 8, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 3,
    .integrals = integrals,
    .equilibria = equilibria,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_general_baseline,
        &jlt_batch_spherical_top_general_avx2,
        &jlt_batch_spherical_top_general_avx512,
    },
};
