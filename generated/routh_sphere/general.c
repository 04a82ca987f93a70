/* Sphere with displaced centre of mass rolling without slipping, reduced system
 *
 *  Source:     E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243
 *  Table:      routh_sphere, SHA-256 7ea5d7e192247bbb71a43cf42803dc35e835526f39f8f2b9ef8220743e084b9e
 *  Command:    ttc generate --out DIR routh_sphere.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   24   11    1    1    0     14   11   (86)
 *  jacobian            9   46   23    1    1    0     15   19   (295)
 *  rhs_jacobian        6   48   27    1    1    0     17   26   (350)
 *  divergence          4    7    4    1    1    0      8    6   (42)
 *  integral_values     2   13   12    0    2    0      6    9   (57)
 *  integral_gradients  4   25   13    1    2    0     11   11   (86)
 *  measure_values      3    3    4    0    1    0      6    6   (27)
 *  measure_divergences 3   16    9    1    2    0     11    9   (66)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_routh_sphere[];
extern const jlt_descriptor jlt_kernels_routh_sphere_general;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_baseline;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_avx2;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[3]*params[3]; /* a3*a3 */
    const double t2 = t0 + t1; /* R*R + a3*a3 */
    const double t3 = params[4]/params[0]; /* I1/m */
    const double t4 = t2 + t3; /* R*R + a3*a3 + I1/m */
    const double t5 = params[1]*2.0; /* R*2 */
    const double t6 = params[3]*t5; /* a3*R*2 */
    const double t7 = t0*params[0]; /* R*R*m */
    const double t8 = params[5]/t7; /* I3/(R*R*m) */
    const double t9 = t0*params[4]; /* R*R*I1 */
    const double t10 = params[5]/t9; /* I3/(R*R*I1) */
    const double t11 = params[1]*params[0]; /* R*m */
    const double t12 = params[3]*t11; /* a3*R*m */
    const double t13 = t12/params[4]; /* a3*R*m/I1 */
    const double t14 = params[0]*params[2]; /* m*g */
    const double t15 = params[3]*t14; /* a3*m*g */
    const double t16 = t15/params[4]; /* a3*m*g/I1 */
    const double t17 = params[5]/params[4]; /* I3/I1 */
    const double t18 = params[1]*params[4]; /* R*I1 */
    const double t19 = params[5]/t18; /* I3/(R*I1) */
    const double t20 = params[5]/t11; /* I3/(R*m) */
    const double t21 = 1.0/t18; /* 1/(R*I1) */
    const double t22 = params[4] - params[5]; /* I1 - I3 */
    const double t23 = params[1]*t22; /* R*(I1 - I3) */
    const double t24 = params[3]*params[5]; /* a3*I3 */
    const double t25 = params[4]*params[5]; /* I1*I3 */
    const double t26 = params[4]*t7; /* I1*R*R*m */
    const double t27 = params[0]*params[5]; /* m*I3 */
    const double t28 = t6*params[5]; /* a3*R*2*I3 */
    const double t29 = t28/params[0]; /* a3*R*2*I3/m */
    const double t30 = params[1]*params[3]; /* R*a3 */
    const double t31 = params[2]/params[1]; /* g/R */
    const double t32 = params[5]/params[0]; /* I3/m */
    const double t33 = params[4]*2.0; /* I1*2 */
    const double t34 = t33/params[0]; /* I1*2/m */
    const double t35 = -params[1]; /* -R */
    const double t36 = params[5]*t12; /* I3*a3*R*m */
    const double t37 = params[0]*2.0; /* m*2 */
    const double t38 = t0*t37; /* R*R*m*2 */
    const double t39 = params[4]*t38; /* I1*R*R*m*2 */
    const double t40 = params[1]*t37; /* R*m*2 */
    const double t41 = params[5]*t40; /* I3*R*m*2 */
    const double t42 = params[5]*t11; /* I3*R*m */
    const double t43 = t7*t22; /* R*R*m*(I1 - I3) */
    const double t44 = params[3]*params[2]; /* a3*g */
    const double t45 = params[3]*params[0]; /* a3*m */
    const double t46 = t45/params[4]; /* a3*m/I1 */
    const double t47 = params[1]*(-2.0); /* R*(-2) */
    const double t48 = params[3]*t47; /* a3*R*(-2) */
    const double t49 = params[3]/params[1]; /* a3/R */
    const double t50 = t0*2.0; /* R*R*2 */
    const double t51 = params[3]*t50; /* a3*R*R*2 */
    const double t52 = params[4]*t51; /* I1*a3*R*R*2 */
    const double t53 = params[0]/2.0; /* m/2 */
    const double t54 = params[4]/2.0; /* I1/2 */
    const double t55 = params[5]/2.0; /* I3/2 */
    const double t56 = -t18; /* -R*I1 */
    const double t57 = params[1]*params[5]; /* R*I3 */
    const double t58 = -t57; /* -R*I3 */
    const double t59 = -params[5]; /* -I3 */
    const double t60 = t7*params[5]; /* R*R*m*I3 */
    const double t61 = params[3]*2.0; /* a3*2 */
    const double t62 = 1.0/t40; /* 1/(R*m*2) */
    const double t63 = params[0]*4.0; /* m*4 */
    const double t64 = params[1]*t63; /* R*m*4 */
    const double t65 = params[3]*t64; /* a3*R*m*4 */
    const double t66 = params[5]*t38; /* I3*R*R*m*2 */
    out[6] = t4;
    out[7] = t6;
    out[8] = t8;
    out[9] = t10;
    out[10] = t3;
    out[11] = t13;
    out[12] = t16;
    out[13] = t17;
    out[14] = t19;
    out[15] = t20;
    out[16] = t21;
    out[17] = t23;
    out[18] = t24;
    out[19] = t25;
    out[20] = t26;
    out[21] = t27;
    out[22] = t29;
    out[23] = t30;
    out[24] = t31;
    out[25] = t32;
    out[26] = t34;
    out[27] = t35;
    out[28] = t36;
    out[29] = t39;
    out[30] = t41;
    out[31] = t42;
    out[32] = t43;
    out[33] = t11;
    out[34] = t44;
    out[35] = t46;
    out[36] = t48;
    out[37] = t49;
    out[38] = t52;
    out[39] = t15;
    out[40] = t53;
    out[41] = t1;
    out[42] = t54;
    out[43] = t55;
    out[44] = t18;
    out[45] = t56;
    out[46] = t58;
    out[47] = t59;
    out[48] = t2;
    out[49] = t60;
    out[50] = t61;
    out[51] = t62;
    out[52] = t65;
    out[53] = t66;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[1]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t6 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t7 = x[2]*t6; /* omega_n*b */
    const double t8 = p[1]*x[3]; /* R*omega3 */
    const double t9 = JLT_FMA(t3, t8, t7); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = JLT_FMA(x[0], p[7], p[6]); /* K scaled = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t11 = t6*p[9]; /* b*I3/(R^2*I1) */
    const double t12 = t2 + p[8]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t13 = JLT_FMA(t6, t11, t12); /* Theta scaled = b*b*I3/(R^2*I1) + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t14 = t3*t10; /* s*K scaled */
    const double t15 = t13*t14; /* Theta scaled*s*K scaled */
    const double t16 = 1.0/t15; /* 1/(Theta scaled*s*K scaled) */
    const double t17 = t13*t16; /* Theta scaled*1/(Theta scaled*s*K scaled) */
    const double t18 = x[2]*t10; /* omega_n*K scaled */
    const double t19 = t17*t18; /* Theta scaled*1/(Theta scaled*s*K scaled)*omega_n*K scaled */
    const double t20 = t5*t9; /* e*v_tau */
    const double t21 = t19*t20; /* Theta scaled*1/(Theta scaled*s*K scaled)*omega_n*K scaled*e*v_tau */
    const double t22 = x[1]*p[11]; /* omega_tau*m*R*a3/I1 */
    const double t23 = t4*t22; /* omega_tau*s*omega_tau*m*R*a3/I1 */
    const double t24 = x[0]*t19; /* gamma3*Theta scaled*1/(Theta scaled*s*K scaled)*omega_n*K scaled */
    const double t25 = JLT_FMA(x[3], p[13], t24); /* omega3*I3/I1 + t24 */
    const double t26 = JLT_FMA(t3, p[12], t23); /* s*m*g*a3/I1 + omega_tau*s*omega_tau*m*R*a3/I1 */
    const double t27 = JLT_FMA(x[2], t25, t26); /* omega_n*(omega3*I3/I1 + t24) + s*m*g*a3/I1 + omega_tau*s*omega_tau*m*R*a3/I1 */
    const double t28 = JLT_FMA(p[10], t27, t21); /* I1/m*t27 + t21 */
    const double t29 = t3*t17; /* s*Theta scaled*1/(Theta scaled*s*K scaled) */
    const double t30 = t28*t29; /* (I1/m*t27 + t21)*s*Theta scaled*1/(Theta scaled*s*K scaled) */
    const double t31 = -t30; /* -(I1/m*t27 + t21)*s*Theta scaled*1/(Theta scaled*s*K scaled) */
    const double t32 = t5 + p[15]; /* e + I3/(m*R) */
    const double t33 = x[3]*t14; /* omega3*s*K scaled */
    const double t34 = t16*t33; /* 1/(Theta scaled*s*K scaled)*omega3*s*K scaled */
    const double t35 = p[14]*t32; /* I3/(R*I1)*(e + I3/(m*R)) */
    const double t36 = JLT_FMA(t34, t35, t24); /* 1/(Theta scaled*s*K scaled)*omega3*s*K scaled*I3/(R*I1)*(e + I3/(m*R)) + t24 */
    const double t37 = x[1]*t36; /* omega_tau*t36 */
    const double t38 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t39 = p[16]*t38; /* 1/(R*I1)*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t40 = t4*t39; /* omega_tau*s*1/(R*I1)*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t41 = t34*t40; /* 1/(Theta scaled*s*K scaled)*omega3*s*K scaled*omega_tau*s*1/(R*I1)*(gamma3*R*(I1 - I3) - a3*I3) */
    out[0] = t4;
    out[1] = t31;
    out[2] = t37;
    out[3] = t41;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[0], p[7], p[6]); /* K scaled = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = p[21]*t4; /* m*I3*b */
    const double t6 = JLT_FMA(p[20], t3, p[19]); /* m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*m*I3*b + m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t8 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = t0*t8; /* K scaled*s */
    const double t10 = t7*t9; /* Theta*K scaled*s */
    const double t11 = 1.0/t10; /* 1/(Theta*K scaled*s) */
    const double t12 = t7*t11; /* Theta*1/(Theta*K scaled*s) */
    const double t13 = t0*t12; /* K scaled*Theta*1/(Theta*K scaled*s) */
    const double t14 = x[0]*t13; /* gamma3*K scaled*Theta*1/(Theta*K scaled*s) */
    const double t15 = x[1]*t14; /* omega_tau*gamma3*K scaled*Theta*1/(Theta*K scaled*s) */
    const double t16 = -t15; /* -omega_tau*gamma3*K scaled*Theta*1/(Theta*K scaled*s) */
    const double t17 = t8*t12; /* s*Theta*1/(Theta*K scaled*s) */
    const double t18 = x[2]*t17; /* omega_n*s*Theta*1/(Theta*K scaled*s) */
    const double t19 = t4*x[2]; /* b*omega_n */
    const double t20 = p[1]*x[3]; /* R*omega3 */
    const double t21 = JLT_FMA(t8, t20, t19); /* v_tau = s*R*omega3 + b*omega_n */
    const double t22 = t13*t21; /* K scaled*Theta*1/(Theta*K scaled*s)*v_tau */
    const double t23 = p[3]*t22; /* a3*K scaled*Theta*1/(Theta*K scaled*s)*v_tau */
    const double t24 = p[1]*x[2]; /* R*omega_n */
    const double t25 = p[7]*t17; /* 2*R*a3*s*Theta*1/(Theta*K scaled*s) */
    const double t26 = t22 - t20; /* K scaled*Theta*1/(Theta*K scaled*s)*v_tau - R*omega3 */
    const double t27 = JLT_FNMA(t21, t25, t24); /* R*omega_n - v_tau*2*R*a3*s*Theta*1/(Theta*K scaled*s) */
    const double t28 = JLT_FMA(t14, t26, t27); /* gamma3*K scaled*Theta*1/(Theta*K scaled*s)*(K scaled*Theta*1/(Theta*K scaled*s)*v_tau - R*omega3) + R*omega_n - v_tau*2*R*a3*s*Theta*1/(Theta*K scaled*s) */
    const double t29 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t30 = t13*t29; /* K scaled*Theta*1/(Theta*K scaled*s)*e */
    const double t31 = x[3]*p[22]; /* omega3*2*R*a3*I3/m */
    const double t32 = t13*x[2]; /* K scaled*Theta*1/(Theta*K scaled*s)*omega_n */
    const double t33 = t13*t13; /* K scaled*Theta*1/(Theta*K scaled*s)*K scaled*Theta*1/(Theta*K scaled*s) */
    const double t34 = t32*t33; /* K scaled*Theta*1/(Theta*K scaled*s)*omega_n*t33 */
    const double t35 = t14*x[2]; /* gamma3*K scaled*Theta*1/(Theta*K scaled*s)*omega_n */
    const double t36 = JLT_FNMA(t25, t35, t34); /* K scaled*Theta*1/(Theta*K scaled*s)*omega_n*t33 - 2*R*a3*s*Theta*1/(Theta*K scaled*s)*gamma3*K scaled*Theta*1/(Theta*K scaled*s)*omega_n */
    const double t37 = JLT_FNMA(t17, t31, t23); /* a3*K scaled*Theta*1/(Theta*K scaled*s)*v_tau - s*Theta*1/(Theta*K scaled*s)*omega3*2*R*a3*I3/m */
    const double t38 = JLT_FMA(t28, t30, t37); /* t28*K scaled*Theta*1/(Theta*K scaled*s)*e + t37 */
    const double t39 = JLT_FMA(p[10], t36, t38); /* I1/m*t36 + t28*K scaled*Theta*1/(Theta*K scaled*s)*e + t37 */
    const double t40 = t18*t39; /* omega_n*s*Theta*1/(Theta*K scaled*s)*(I1/m*t36 + t28*K scaled*Theta*1/(Theta*K scaled*s)*e + t37) */
    const double t41 = JLT_FMA(x[1], x[1], p[24]); /* omega_tau*omega_tau + g/R */
    const double t42 = t8*t25; /* s*2*R*a3*s*Theta*1/(Theta*K scaled*s) */
    const double t43 = t14 + t42; /* gamma3*K scaled*Theta*1/(Theta*K scaled*s) + s*2*R*a3*s*Theta*1/(Theta*K scaled*s) */
    const double t44 = p[23]*t41; /* R*a3*(omega_tau*omega_tau + g/R) */
    const double t45 = t17*t44; /* s*Theta*1/(Theta*K scaled*s)*R*a3*(omega_tau*omega_tau + g/R) */
    const double t46 = JLT_FMS(t43, t45, t40); /* t43*t45 - t40 */
    const double t47 = x[1]*t42; /* omega_tau*s*2*R*a3*s*Theta*1/(Theta*K scaled*s) */
    const double t48 = -t47; /* -omega_tau*s*2*R*a3*s*Theta*1/(Theta*K scaled*s) */
    const double t49 = x[3]*p[25]; /* omega3*I3/m */
    const double t50 = t19 + t21; /* b*omega_n + v_tau */
    const double t51 = JLT_FMA(t30, t50, t49); /* K scaled*Theta*1/(Theta*K scaled*s)*e*(b*omega_n + v_tau) + omega3*I3/m */
    const double t52 = JLT_FMA(t35, p[26], t51); /* gamma3*K scaled*Theta*1/(Theta*K scaled*s)*omega_n*2*I1/m + t51 */
    const double t53 = t17*t52; /* s*Theta*1/(Theta*K scaled*s)*t52 */
    const double t54 = -t53; /* -s*Theta*1/(Theta*K scaled*s)*t52 */
    const double t55 = t29 + p[15]; /* e + I3/(m*R) */
    const double t56 = p[27]*t55; /* (-R)*(e + I3/(m*R)) */
    const double t57 = t18*t56; /* omega_n*s*Theta*1/(Theta*K scaled*s)*(-R)*(e + I3/(m*R)) */
    const double t58 = t9*t11; /* K scaled*s*1/(Theta*K scaled*s) */
    const double t59 = x[3]*t58; /* omega3*K scaled*s*1/(Theta*K scaled*s) */
    const double t60 = x[1]*t59; /* omega_tau*omega3*K scaled*s*1/(Theta*K scaled*s) */
    const double t61 = x[0]*p[29]; /* gamma3*2*m*R^2*I1 */
    const double t62 = JLT_FMS(t4, p[30], t61); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t63 = t55*p[31]; /* (e + I3/(m*R))*m*R*I3 */
    const double t64 = t58*t63; /* K scaled*s*1/(Theta*K scaled*s)*(e + I3/(m*R))*m*R*I3 */
    const double t65 = JLT_FNMA(t62, t64, p[28]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*K scaled*s*1/(Theta*K scaled*s)*(e + I3/(m*R))*m*R*I3 */
    const double t66 = t60*t65; /* omega_tau*omega3*K scaled*s*1/(Theta*K scaled*s)*t65 */
    const double t67 = JLT_FMA(x[1], t34, t66); /* omega_tau*K scaled*Theta*1/(Theta*K scaled*s)*omega_n*t33 + omega_tau*omega3*K scaled*s*1/(Theta*K scaled*s)*t65 */
    const double t68 = JLT_FMA(t59, t63, t35); /* omega3*K scaled*s*1/(Theta*K scaled*s)*(e + I3/(m*R))*m*R*I3 + gamma3*K scaled*Theta*1/(Theta*K scaled*s)*omega_n */
    const double t69 = x[1]*t64; /* omega_tau*K scaled*s*1/(Theta*K scaled*s)*(e + I3/(m*R))*m*R*I3 */
    const double t70 = t8*p[32]; /* s*m*R^2*(I1 - I3) */
    const double t71 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t72 = p[33]*t71; /* m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t73 = t8*t72; /* s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t74 = t58*t73; /* K scaled*s*1/(Theta*K scaled*s)*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t75 = JLT_FNMA(t62, t74, t70); /* s*m*R^2*(I1 - I3) - d(Theta)/d(gamma3)*t74 */
    const double t76 = JLT_FNMA(t14, t72, t75); /* s*m*R^2*(I1 - I3) - d(Theta)/d(gamma3)*t74 - gamma3*K scaled*Theta*1/(Theta*K scaled*s)*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t77 = t60*t76; /* omega_tau*omega3*K scaled*s*1/(Theta*K scaled*s)*t76 */
    const double t78 = t59*t73; /* omega3*K scaled*s*1/(Theta*K scaled*s)*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t79 = x[1]*t74; /* omega_tau*t74 */
    out[0] = t16;
    out[1] = t8;
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = t46;
    out[5] = t48;
    out[6] = t54;
    out[7] = t57;
    out[8] = t67;
    out[9] = t68;
    out[10] = t15;
    out[11] = t69;
    out[12] = t77;
    out[13] = t78;
    out[14] = 0.0;
    out[15] = t79;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[1]*t3; /* omega_tau*s */
    const double t5 = p[25]*x[3]; /* I3/m*omega3 */
    const double t6 = JLT_FMA(x[0], p[7], p[6]); /* K scaled = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t7 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t8 = p[21]*t7; /* m*I3*b */
    const double t9 = JLT_FMA(t2, p[20], p[19]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t10 = JLT_FMA(t7, t8, t9); /* Theta = b*m*I3*b + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t11 = t3*t6; /* s*K scaled */
    const double t12 = t10*t11; /* Theta*s*K scaled */
    const double t13 = 1.0/t12; /* 1/(Theta*s*K scaled) */
    const double t14 = t10*t13; /* Theta*1/(Theta*s*K scaled) */
    const double t15 = t6*t14; /* K scaled*Theta*1/(Theta*s*K scaled) */
    const double t16 = x[2]*t15; /* omega_n*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t17 = x[0]*t16; /* gamma3*omega_n*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t18 = JLT_FMA(p[10], t17, t5); /* I1/m*gamma3*omega_n*K scaled*Theta*1/(Theta*s*K scaled) + I3/m*omega3 */
    const double t19 = x[2]*t7; /* omega_n*b */
    const double t20 = x[3]*p[1]; /* omega3*R */
    const double t21 = JLT_FMA(t3, t20, t19); /* v_tau = s*omega3*R + omega_n*b */
    const double t22 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t23 = t16*t22; /* omega_n*K scaled*Theta*1/(Theta*s*K scaled)*e */
    const double t24 = t21*t23; /* v_tau*omega_n*K scaled*Theta*1/(Theta*s*K scaled)*e */
    const double t25 = x[1]*p[23]; /* omega_tau*R*a3 */
    const double t26 = JLT_FMA(t3, p[34], t24); /* s*g*a3 + v_tau*omega_n*K scaled*Theta*1/(Theta*s*K scaled)*e */
    const double t27 = JLT_FMA(t4, t25, t26); /* omega_tau*s*omega_tau*R*a3 + s*g*a3 + v_tau*omega_n*K scaled*Theta*1/(Theta*s*K scaled)*e */
    const double t28 = JLT_FMA(x[2], t18, t27); /* omega_n*t18 + t27 */
    const double t29 = t3*t14; /* s*Theta*1/(Theta*s*K scaled) */
    const double t30 = t28*t29; /* (omega_n*t18 + t27)*s*Theta*1/(Theta*s*K scaled) */
    const double t31 = -t30; /* -(omega_n*t18 + t27)*s*Theta*1/(Theta*s*K scaled) */
    const double t32 = t22 + p[15]; /* e + I3/(m*R) */
    const double t33 = p[31]*t32; /* m*R*I3*(e + I3/(m*R)) */
    const double t34 = t11*t13; /* s*K scaled*1/(Theta*s*K scaled) */
    const double t35 = x[3]*t34; /* omega3*s*K scaled*1/(Theta*s*K scaled) */
    const double t36 = JLT_FMA(t33, t35, t17); /* m*R*I3*(e + I3/(m*R))*omega3*s*K scaled*1/(Theta*s*K scaled) + gamma3*omega_n*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t37 = x[1]*t36; /* omega_tau*t36 */
    const double t38 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t39 = p[33]*t38; /* m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t40 = t35*t39; /* omega3*s*K scaled*1/(Theta*s*K scaled)*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t41 = t4*t40; /* omega_tau*s*t40 */
    const double t42 = x[0]*t15; /* gamma3*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t43 = x[1]*t42; /* omega_tau*gamma3*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t44 = -t43; /* -omega_tau*gamma3*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t45 = t15*t16; /* K scaled*Theta*1/(Theta*s*K scaled)*omega_n*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t46 = JLT_FMA(t21, p[35], t45); /* v_tau*m*a3/I1 + t45 */
    const double t47 = p[10]*t16; /* I1/m*omega_n*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t48 = t46*t47; /* (v_tau*m*a3/I1 + t45)*I1/m*omega_n*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t49 = JLT_FNMA(x[3], t42, x[2]); /* d(v_tau)/d(gamma3) scaled = omega_n - omega3*gamma3*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t50 = p[1]*t23; /* R*omega_n*K scaled*Theta*1/(Theta*s*K scaled)*e */
    const double t51 = JLT_FNMA(t15, t24, p[34]); /* g*a3 - K scaled*Theta*1/(Theta*s*K scaled)*v_tau*omega_n*K scaled*Theta*1/(Theta*s*K scaled)*e */
    const double t52 = JLT_FMS(t25, t43, t48); /* omega_tau*R*a3*omega_tau*gamma3*K scaled*Theta*1/(Theta*s*K scaled) - t48 */
    const double t53 = JLT_FNMA(t49, t50, t52); /* t52 - d(v_tau)/d(gamma3) scaled*R*omega_n*K scaled*Theta*1/(Theta*s*K scaled)*e */
    const double t54 = JLT_FMA(t42, t51, t53); /* d(numerator of d(omega_tau)/dt over K)/d(gamma3) scaled = gamma3*K scaled*Theta*1/(Theta*s*K scaled)*t51 + t53 */
    const double t55 = JLT_FMA(p[7], t30, t54); /* 2*R*a3*(omega_n*t18 + t27)*s*Theta*1/(Theta*s*K scaled) + d(numerator of d(omega_tau)/dt over K)/d(gamma3) scaled */
    const double t56 = t29*t55; /* s*Theta*1/(Theta*s*K scaled)*t55 */
    const double t57 = t4*p[36]; /* omega_tau*s*(-2*R*a3) */
    const double t58 = t29*t57; /* s*Theta*1/(Theta*s*K scaled)*omega_tau*s*(-2*R*a3) */
    const double t59 = t21*t22; /* v_tau*e */
    const double t60 = JLT_FMA(t15, t59, t5); /* K scaled*Theta*1/(Theta*s*K scaled)*v_tau*e + I3/m*omega3 */
    const double t61 = JLT_FMA(t17, p[26], t60); /* gamma3*omega_n*K scaled*Theta*1/(Theta*s*K scaled)*2*I1/m + K scaled*Theta*1/(Theta*s*K scaled)*v_tau*e + I3/m*omega3 */
    const double t62 = JLT_FMA(t7, t23, t61); /* b*omega_n*K scaled*Theta*1/(Theta*s*K scaled)*e + t61 */
    const double t63 = t29*t62; /* s*Theta*1/(Theta*s*K scaled)*(b*omega_n*K scaled*Theta*1/(Theta*s*K scaled)*e + t61) */
    const double t64 = -t63; /* -t63 */
    const double t65 = x[2]*p[27]; /* omega_n*(-R) */
    const double t66 = t32*t65; /* (e + I3/(m*R))*omega_n*(-R) */
    const double t67 = t29*t66; /* s*Theta*1/(Theta*s*K scaled)*(e + I3/(m*R))*omega_n*(-R) */
    const double t68 = t15*t45; /* K scaled*Theta*1/(Theta*s*K scaled)*t45 */
    const double t69 = x[0]*p[29]; /* gamma3*2*m*R^2*I1 */
    const double t70 = JLT_FMS(t7, p[30], t69); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t71 = t33*t34; /* m*R*I3*(e + I3/(m*R))*s*K scaled*1/(Theta*s*K scaled) */
    const double t72 = JLT_FNMA(t70, t71, p[28]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*m*R*I3*(e + I3/(m*R))*s*K scaled*1/(Theta*s*K scaled) */
    const double t73 = JLT_FMA(t35, t72, t68); /* omega3*s*K scaled*1/(Theta*s*K scaled)*t72 + K scaled*Theta*1/(Theta*s*K scaled)*t45 */
    const double t74 = x[1]*t73; /* omega_tau*t73 */
    const double t75 = x[1]*t71; /* omega_tau*m*R*I3*(e + I3/(m*R))*s*K scaled*1/(Theta*s*K scaled) */
    const double t76 = t4*p[32]; /* omega_tau*s*m*R^2*(I1 - I3) */
    const double t77 = t35*t76; /* omega3*s*K scaled*1/(Theta*s*K scaled)*omega_tau*s*m*R^2*(I1 - I3) */
    const double t78 = t4*t34; /* omega_tau*s*s*K scaled*1/(Theta*s*K scaled) */
    const double t79 = JLT_FMA(t70, t78, t43); /* d(Theta)/d(gamma3)*omega_tau*s*s*K scaled*1/(Theta*s*K scaled) + omega_tau*gamma3*K scaled*Theta*1/(Theta*s*K scaled) */
    const double t80 = JLT_FNMA(t40, t79, t77); /* t77 - t40*t79 */
    const double t81 = t3*t40; /* s*t40 */
    const double t82 = t39*t78; /* m*R*(gamma3*R*(I1 - I3) - a3*I3)*omega_tau*s*s*K scaled*1/(Theta*s*K scaled) */
    out[0] = t4;
    out[1] = t31;
    out[2] = t37;
    out[3] = t41;
    out[4] = t44;
    out[5] = t3;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t56;
    out[9] = t58;
    out[10] = t64;
    out[11] = t67;
    out[12] = t74;
    out[13] = t36;
    out[14] = t43;
    out[15] = t75;
    out[16] = t80;
    out[17] = t81;
    out[18] = 0.0;
    out[19] = t82;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], p[7], p[6]); /* K scaled = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t5 = x[0] + p[37]; /* b scaled = gamma3 + a3/R */
    const double t6 = p[13]*t5; /* I3/I1*b scaled */
    const double t7 = t2 + p[8]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta scaled = b scaled*I3/I1*b scaled + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t9 = t4*t8; /* K scaled*Theta scaled */
    const double t10 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t11 = t4*t10; /* K scaled*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t12 = JLT_FNMA(t8, p[38], t11); /* K scaled*(gamma3*R*(I1 - I3) - a3*I3) - Theta scaled*2*R^2*a3*I1 */
    const double t13 = p[16]*x[1]; /* 1/(R*I1)*omega_tau */
    const double t14 = t12*t13; /* t12*1/(R*I1)*omega_tau */
    const double t15 = t3*t14; /* s*t12*1/(R*I1)*omega_tau */
    const double t16 = t15/t9; /* s*t12*1/(R*I1)*omega_tau/(K scaled*Theta scaled) */
    out[0] = t16;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[39]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t2 = t1*t1; /* e*e */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = x[0] + 1.0; /* gamma3 + 1 */
    const double t5 = t3*t4; /* (1 - gamma3)*(gamma3 + 1) */
    const double t6 = JLT_FMA(p[41], t5, t2); /* a3^2*(1 - gamma3)*(gamma3 + 1) + e*e */
    const double t7 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t8 = t6*t7; /* (a3^2*(1 - gamma3)*(gamma3 + 1) + e*e)*omega_tau*omega_tau */
    const double t9 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = x[2]*t9; /* omega_n*b */
    const double t11 = sqrt(t5); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t12 = p[1]*x[3]; /* R*omega3 */
    const double t13 = JLT_FMA(t11, t12, t10); /* v_tau = s*R*omega3 + omega_n*b */
    const double t14 = JLT_FMA(t13, t13, t8); /* v_tau*v_tau + (a3^2*(1 - gamma3)*(gamma3 + 1) + e*e)*omega_tau*omega_tau */
    const double t15 = JLT_FMA(x[2], x[2], t7); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t16 = x[3]*p[43]; /* omega3*1/2*I3 */
    const double t17 = JLT_FMA(x[3], t16, t0); /* omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t18 = JLT_FMA(p[42], t15, t17); /* 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) + omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t19 = JLT_FMA(p[40], t14, t18); /* 1/2*m*t14 + t18 */
    const double t20 = x[2]*p[44]; /* omega_n*R*I1 */
    const double t21 = t11*t20; /* s*omega_n*R*I1 */
    const double t22 = x[3]*p[5]; /* omega3*I3 */
    const double t23 = JLT_FNMA(t9, t22, t21); /* s*omega_n*R*I1 - b*omega3*I3 */
    const double t24 = t9*p[21]; /* b*m*I3 */
    const double t25 = JLT_FMA(t5, p[20], p[19]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t26 = JLT_FMA(t9, t24, t25); /* Theta = b*b*m*I3 + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t27 = sqrt(t26); /* h = sqrt(Theta) */
    const double t28 = x[3]*t27; /* omega3*h */
    out[0] = t19;
    out[1] = t23;
    out[2] = t28;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*x[0]; /* a3*gamma3 */
    const double t1 = p[1] + t0; /* e = R + a3*gamma3 */
    const double t2 = t1 - t0; /* e - a3*gamma3 */
    const double t3 = p[37]*x[1]; /* a3/R*omega_tau */
    const double t4 = x[1]*t3; /* omega_tau*a3/R*omega_tau */
    const double t5 = t2*t4; /* (e - a3*gamma3)*omega_tau*a3/R*omega_tau */
    const double t6 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t7 = x[2]*t6; /* omega_n*b */
    const double t8 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t9 = x[0] + 1.0; /* gamma3 + 1 */
    const double t10 = t8*t9; /* (1 - gamma3)*(gamma3 + 1) */
    const double t11 = sqrt(t10); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t12 = x[3]*t11; /* omega3*s */
    const double t13 = JLT_FMA(p[1], t12, t7); /* v_tau = R*omega3*s + omega_n*b */
    const double t14 = t6*p[21]; /* b*m*I3 */
    const double t15 = JLT_FMA(t10, p[20], p[19]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t16 = JLT_FMA(t6, t14, t15); /* Theta = b*b*m*I3 + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t17 = sqrt(t16); /* h = sqrt(Theta) */
    const double t18 = t11*t17; /* s*h */
    const double t19 = 1.0/t18; /* 1/(s*h) */
    const double t20 = x[0]*t17; /* gamma3*h */
    const double t21 = t19*t20; /* 1/(s*h)*gamma3*h */
    const double t22 = JLT_FNMA(x[3], t21, x[2]); /* d(v_tau)/d(gamma3) scaled = omega_n - omega3*1/(s*h)*gamma3*h */
    const double t23 = JLT_FMA(t13, t22, t5); /* v_tau*d(v_tau)/d(gamma3) scaled + (e - a3*gamma3)*omega_tau*a3/R*omega_tau */
    const double t24 = JLT_FMA(p[33], t23, p[39]); /* m*R*t23 + m*g*a3 */
    const double t25 = t1*t1; /* e*e */
    const double t26 = JLT_FMA(t10, p[41], t25); /* (1 - gamma3)*(gamma3 + 1)*a3^2 + e*e */
    const double t27 = x[1]*p[0]; /* omega_tau*m */
    const double t28 = t26*t27; /* ((1 - gamma3)*(gamma3 + 1)*a3^2 + e*e)*omega_tau*m */
    const double t29 = JLT_FMA(x[1], p[4], t28); /* omega_tau*I1 + ((1 - gamma3)*(gamma3 + 1)*a3^2 + e*e)*omega_tau*m */
    const double t30 = t6*p[0]; /* b*m */
    const double t31 = t13*t30; /* v_tau*b*m */
    const double t32 = JLT_FMA(x[2], p[4], t31); /* omega_n*I1 + v_tau*b*m */
    const double t33 = x[3]*p[5]; /* omega3*I3 */
    const double t34 = p[33]*t11; /* m*R*s */
    const double t35 = JLT_FMA(t13, t34, t33); /* v_tau*m*R*s + omega3*I3 */
    const double t36 = x[2]*p[45]; /* omega_n*(-R*I1) */
    const double t37 = t21*t36; /* 1/(s*h)*gamma3*h*omega_n*(-R*I1) */
    const double t38 = JLT_FMA(x[3], p[46], t37); /* omega3*(-R*I3) + 1/(s*h)*gamma3*h*omega_n*(-R*I1) */
    const double t39 = t11*p[44]; /* s*R*I1 */
    const double t40 = t6*p[47]; /* b*(-I3) */
    const double t41 = JLT_FMS(t6, p[14], x[0]); /* d(Theta)/d(gamma3) scaled = b*I3/(R*I1) - gamma3 */
    const double t42 = p[20]*t41; /* m*R^2*I1*d(Theta)/d(gamma3) scaled */
    const double t43 = t12*t42; /* omega3*s*m*R^2*I1*d(Theta)/d(gamma3) scaled */
    const double t44 = t19*t43; /* 1/(s*h)*omega3*s*m*R^2*I1*d(Theta)/d(gamma3) scaled */
    out[0] = t24;
    out[1] = t29;
    out[2] = t32;
    out[3] = t35;
    out[4] = t38;
    out[5] = 0.0;
    out[6] = t39;
    out[7] = t40;
    out[8] = t44;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t17;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[7], x[0], p[48]); /* 2*R*a3*gamma3 + R^2 + a3^2 */
    const double t1 = JLT_FMA(p[0], t0, p[4]); /* K = m*(2*R*a3*gamma3 + R^2 + a3^2) + I1 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = p[20]*t2; /* m*R^2*I1*(1 - gamma3) */
    const double t5 = x[0] + p[37]; /* b scaled = gamma3 + a3/R */
    const double t6 = p[49]*t5; /* m*R^2*I3*b scaled */
    const double t7 = JLT_FMA(t3, t4, p[19]); /* (gamma3 + 1)*m*R^2*I1*(1 - gamma3) + I1*I3 */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta = b scaled*m*R^2*I3*b scaled + (gamma3 + 1)*m*R^2*I1*(1 - gamma3) + I1*I3 */
    const double t9 = sqrt(t8); /* h = sqrt(Theta) */
    const double t10 = t1*t9; /* K*h */
    out[0] = t10;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], p[7], p[48]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t5 = JLT_FMA(p[0], t4, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t6 = x[0] + p[37]; /* b scaled = gamma3 + a3/R */
    const double t7 = p[49]*t6; /* m*R^2*I3*b scaled */
    const double t8 = JLT_FMA(t2, p[20], p[19]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(t6, t7, t8); /* Theta = b scaled*m*R^2*I3*b scaled + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t10 = sqrt(t9); /* h = sqrt(Theta) */
    const double t11 = t5*t9; /* K*Theta */
    const double t12 = t10*t11; /* h*K*Theta */
    const double t13 = 1.0/t12; /* 1/(h*K*Theta) */
    const double t14 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t15 = t5*t14; /* K*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t16 = JLT_FNMA(t9, p[50], t15); /* K*(gamma3*R*(I1 - I3) - a3*I3) - Theta*2*a3 */
    const double t17 = t5*t16; /* K*(K*(gamma3*R*(I1 - I3) - a3*I3) - Theta*2*a3) */
    const double t18 = t10*t17; /* h*K*(K*(gamma3*R*(I1 - I3) - a3*I3) - Theta*2*a3) */
    const double t19 = t10*t18; /* h*h*K*(K*(gamma3*R*(I1 - I3) - a3*I3) - Theta*2*a3) */
    const double t20 = t13*t19; /* 1/(h*K*Theta)*h*h*K*(K*(gamma3*R*(I1 - I3) - a3*I3) - Theta*2*a3) */
    const double t21 = t10*p[52]; /* h*4*m*R*a3 */
    const double t22 = x[0]*p[29]; /* gamma3*2*m*R^2*I1 */
    const double t23 = JLT_FMS(t6, p[53], t22); /* d(Theta)/d(gamma3) = b scaled*2*m*R^2*I3 - gamma3*2*m*R^2*I1 */
    const double t24 = t5*t23; /* K*d(Theta)/d(gamma3) */
    const double t25 = t11*t24; /* K*Theta*K*d(Theta)/d(gamma3) */
    const double t26 = JLT_FMA(t13, t25, t21); /* 1/(h*K*Theta)*K*Theta*K*d(Theta)/d(gamma3) + h*4*m*R*a3 */
    const double t27 = JLT_FMA(p[51], t26, t20); /* 1/2/(m*R)*(1/(h*K*Theta)*K*Theta*K*d(Theta)/d(gamma3) + h*4*m*R*a3) + t20 */
    const double t28 = p[33]*x[1]; /* m*R*omega_tau */
    const double t29 = t3*t28; /* s*m*R*omega_tau */
    const double t30 = t27*t29; /* t27*s*m*R*omega_tau */
    out[0] = t30;
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
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
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
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
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
    double t54[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x1, t6, k);
        t10[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t12[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t13[k] = jlt_jet_product(x2, t12, k);
        t15[k] = p[1]*x3[k];
        t16[k] = jlt_jet_product(t6, t15, k) + t13[k];
        t19[k] = x0[k]*p[7] + (k == 0 ? p[6] : 0);
        t22[k] = t12[k]*p[9];
        t23[k] = t5[k] + (k == 0 ? p[8] : 0);
        t24[k] = jlt_jet_product(t12, t22, k) + t23[k];
        t25[k] = jlt_jet_product(t6, t19, k);
        t26[k] = jlt_jet_product(t24, t25, k);
        t27[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t26, t27, k);
        t28[k] = jlt_jet_product(t24, t27, k);
        t29[k] = jlt_jet_product(x2, t19, k);
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = jlt_jet_product(t10, t16, k);
        t32[k] = jlt_jet_product(t30, t31, k);
        t35[k] = x1[k]*p[11];
        t36[k] = jlt_jet_product(t7, t35, k);
        t39[k] = jlt_jet_product(x0, t30, k);
        t40[k] = x3[k]*p[13] + t39[k];
        t41[k] = t6[k]*p[12] + t36[k];
        t42[k] = jlt_jet_product(x2, t40, k) + t41[k];
        t43[k] = p[10]*t42[k] + t32[k];
        t44[k] = jlt_jet_product(t6, t28, k);
        t45[k] = jlt_jet_product(t43, t44, k);
        t46[k] = -t45[k];
        t49[k] = t10[k] + (k == 0 ? p[15] : 0);
        t50[k] = jlt_jet_product(x3, t25, k);
        t51[k] = jlt_jet_product(t27, t50, k);
        t52[k] = p[14]*t49[k];
        t53[k] = jlt_jet_product(t51, t52, k) + t39[k];
        t54[k] = jlt_jet_product(x1, t53, k);
        t58[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t59[k] = p[16]*t58[k];
        t60[k] = jlt_jet_product(t7, t59, k);
        t61[k] = jlt_jet_product(t51, t60, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t46[k]/(k + 1);
        next[2] = x2[k + 1] = t54[k]/(k + 1);
        next[3] = x3[k + 1] = t61[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[1];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_I1 = params[4];
    const double complex v_omega_n = x[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double v_a3 = params[3];
    const double complex v_K = (v_I1 + v_m*(v_R*v_R + v_a3*v_a3 + 2.0*v_R*v_a3*v_gamma3));
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_v_tau = (v_omega_n*v_b + v_R*v_omega3*v_s);
    const double v_g = params[2];
    out[1] = (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_K))
        + (-v_I3*v_omega_n*v_omega3/v_K)
        + (-v_m*v_omega_n*v_e*v_v_tau/(v_s*v_K))
        + (-v_m*v_R*v_a3*v_omega_tau*v_omega_tau*v_s/v_K)
        + (-v_m*v_g*v_a3*v_s/v_K);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    out[2] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta)
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta);
    out[3] = (v_m*v_R*v_omega_tau*v_omega3*v_s*(v_R*v_gamma3*(v_I1 - v_I3) - v_a3*v_I3)/v_Theta);
}

static const unsigned char family0_is_free[] = { 1, 0, 1, 1 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[3]; /* m*a3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = t1*t2; /* (1 + gamma3)*(1 - gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t5 = t4*t4; /* s*s */
    const double t6 = t0*t5; /* m*a3*s*s */
    const double t7 = x[0]*params[4]; /* gamma3*I1 */
    const double t8 = x[2]*t7; /* omega_n*gamma3*I1 */
    const double t9 = params[5]*x[3]; /* I3*omega3 */
    const double t10 = t4*t9; /* s*I3*omega3 */
    const double t11 = t8 + t10; /* omega_n*gamma3*I1 + s*I3*omega3 */
    const double t12 = params[3]*x[0]; /* a3*gamma3 */
    const double t13 = params[1] + t12; /* e = R + a3*gamma3 */
    const double t14 = params[0]*t13; /* m*e */
    const double t15 = params[1]*x[0]; /* R*gamma3 */
    const double t16 = params[3] + t15; /* b = a3 + R*gamma3 */
    const double t17 = x[2]*t16; /* omega_n*b */
    const double t18 = params[1]*x[3]; /* R*omega3 */
    const double t19 = t4*t18; /* s*R*omega3 */
    const double t20 = t17 + t19; /* v_tau = omega_n*b + s*R*omega3 */
    const double t21 = t14*t20; /* m*e*v_tau */
    const double t22 = t11 + t21; /* omega_n*gamma3*I1 + s*I3*omega3 + m*e*v_tau */
    const double t23 = x[2]*t22; /* omega_n*(omega_n*gamma3*I1 + s*I3*omega3 + m*e*v_tau) */
    const double t24 = t23/t6; /* omega_n*(omega_n*gamma3*I1 + s*I3*omega3 + m*e*v_tau)/(m*a3*s*s) */
    const double t25 = -t24; /* g = -t24 */
    out[0] = params[0];
    out[1] = params[1];
    out[2] = t25;
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = 0.0;
    out[2] = x[2];
    out[3] = x[3];
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = t0*params[3]; /* m*g*a3 */
    const double t2 = params[1]*x[0]; /* R*gamma3 */
    const double t3 = params[3] + t2; /* b = a3 + R*gamma3 */
    const double t4 = x[2]*t3; /* omega_n*b */
    const double t5 = params[1]*x[3]; /* R*omega3 */
    const double t6 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t7 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t8 = t6*t7; /* (1 + gamma3)*(1 - gamma3) */
    const double t9 = sqrt(t8); /* s = sqrt((1 + gamma3)*(1 - gamma3)) */
    const double t10 = t5*t9; /* R*omega3*s */
    const double t11 = t4 + t10; /* v_tau = omega_n*b + R*omega3*s */
    const double t12 = params[1]*x[2]; /* R*omega_n */
    const double t13 = t2*x[3]; /* R*gamma3*omega3 */
    const double t14 = t13/t9; /* R*gamma3*omega3/s */
    const double t15 = t12 - t14; /* d(v_tau)/d(gamma3) = R*omega_n - R*gamma3*omega3/s */
    const double t16 = t11*t15; /* v_tau*d(v_tau)/d(gamma3) */
    const double t17 = params[0]*t16; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t18 = t1 + t17; /* m*g*a3 + m*v_tau*d(v_tau)/d(gamma3) */
    const double t19 = t9*t9; /* s*s */
    const double t20 = params[0]*t3; /* m*b */
    const double t21 = t11*t20; /* v_tau*m*b */
    const double t22 = x[2]*params[4]; /* omega_n*I1 */
    const double t23 = t21 + t22; /* v_tau*m*b + omega_n*I1 */
    const double t24 = x[3]*params[5]; /* omega3*I3 */
    const double t25 = params[0]*params[1]; /* m*R */
    const double t26 = t9*t25; /* s*m*R */
    const double t27 = t11*t26; /* v_tau*s*m*R */
    const double t28 = t24 + t27; /* omega3*I3 + v_tau*s*m*R */
    const double t29 = params[1]*params[4]; /* R*I1 */
    const double t30 = x[0]*t29; /* gamma3*R*I1 */
    const double t31 = x[2]*t30; /* omega_n*gamma3*R*I1 */
    const double t32 = t31/t9; /* omega_n*gamma3*R*I1/s */
    const double t33 = -t32; /* -omega_n*gamma3*R*I1/s */
    const double t34 = params[1]*params[5]; /* R*I3 */
    const double t35 = x[3]*t34; /* omega3*R*I3 */
    const double t36 = t33 - t35; /* -omega_n*gamma3*R*I1/s - omega3*R*I3 */
    const double t37 = t9*t29; /* s*R*I1 */
    const double t38 = t3*params[5]; /* b*I3 */
    const double t39 = -t38; /* -b*I3 */
    const double t40 = params[4]*params[5]; /* I1*I3 */
    const double t41 = params[1]*params[1]; /* R*R */
    const double t42 = params[0]*t41; /* m*R*R */
    const double t43 = params[4]*t42; /* I1*m*R*R */
    const double t44 = t19*t43; /* s*s*I1*m*R*R */
    const double t45 = t40 + t44; /* I1*I3 + s*s*I1*m*R*R */
    const double t46 = params[0]*params[5]; /* m*I3 */
    const double t47 = t3*t3; /* b*b */
    const double t48 = t46*t47; /* m*I3*b*b */
    const double t49 = t45 + t48; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t50 = sqrt(t49); /* h = sqrt(Theta) */
    const double t51 = 2.0*t50; /* 2*h */
    const double t52 = x[0]*t43; /* gamma3*I1*m*R*R */
    const double t53 = 2.0*t52; /* 2*gamma3*I1*m*R*R */
    const double t54 = params[5]*t25; /* I3*m*R */
    const double t55 = t3*t54; /* b*I3*m*R */
    const double t56 = 2.0*t55; /* 2*b*I3*m*R */
    const double t57 = t56 - t53; /* d(Theta)/d(gamma3) = 2*b*I3*m*R - 2*gamma3*I1*m*R*R */
    const double t58 = x[3]*t57; /* omega3*d(Theta)/d(gamma3) */
    const double t59 = t58/t51; /* omega3*d(Theta)/d(gamma3)/(2*h) */
    out[0] = t18;
    out[1] = 0.0;
    out[2] = t23;
    out[3] = t28;
    out[4] = t36;
    out[5] = 0.0;
    out[6] = t37;
    out[7] = t39;
    out[8] = t59;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t50;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "Jellett", "" },
    { "Routh", "" },
};

static const unsigned char family1_is_free[] = { 1, 0, 0, 1 };

static void family1_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
}

static void family1_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = x[3];
}

static void family1_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
}

static const jlt_equilibria equilibria[] = {
    { .name = "precession", .condition = "g = -omega_n*(I1*gamma3*omega_n + I3*omega3*s + m*e*v_tau)/(m*a3*s^2)",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 3, .obstructs = 0 },
    { .name = "rolling", .condition = "a3 = 0",
      .is_free = family1_is_free,
      .impose = family1_impose,
      .point = family1_point,
      .trace = family1_trace,
      .left_null_count = 0, .obstructs = 0 },
};

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
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
    { "Jellett", "" },
    { "Routh", "" },
};

static const jlt_named measures[] = {
    { "rho", "" },
};

const jlt_descriptor jlt_kernels_routh_sphere_general = {
    .model = "routh_sphere",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Sphere with displaced centre of mass rolling without slipping, reduced system",
    .source = "E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243",
    .sha256 = "7ea5d7e192247bbb71a43cf42803dc35e835526f39f8f2b9ef8220743e084b9e",
    .generator = "ttc 0.1.0",
    .table = jlt_table_routh_sphere,
    .state_count = 4, .param_count = 6, .block_count = 54,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 24, 11, 1, 1, 0, 14, 11 }, { 18, 58, 0, 9, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 9, 46, 23, 1, 1, 0, 15, 19 }, { 48, 209, 0, 37, 1, 0, 20, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 6, 48, 27, 1, 1, 0, 17, 26 }, { 57, 246, 0, 46, 1, 0, 20, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 4, 7, 4, 1, 1, 0, 8, 6 }, { 10, 29, 0, 2, 1, 0, 9, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 2, 13, 12, 0, 2, 0, 6, 9 }, { 13, 42, 0, 0, 2, 0, 13, 7 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 12, { 4, 25, 13, 1, 2, 0, 11, 11 }, { 18, 63, 0, 3, 2, 0, 10, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by h: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { measure_values, 1, { 3, 3, 4, 0, 1, 0, 6, 6 }, { 7, 18, 0, 0, 2, 0, 9, 5 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .measure_divergences = { measure_divergences, 1, { 3, 16, 9, 1, 2, 0, 11, 9 }, { 13, 48, 0, 3, 2, 0, 14, 11 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes; divides by h: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 3, .measure_count = 1, .equilibria_count = 2,
    .integrals = integrals,
    .measures = measures,
    .equilibria = equilibria,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_routh_sphere_general_baseline,
        &jlt_batch_routh_sphere_general_avx2,
        &jlt_batch_routh_sphere_general_avx512,
    },
};
