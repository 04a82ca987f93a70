/* Sphere with displaced centre of mass rolling without slipping, reduced system
 *
 *  Source:     E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243
 *  Table:      routh_sphere, SHA-256 7ea5d7e192247bbb71a43cf42803dc35e835526f39f8f2b9ef8220743e084b9e
 *  Command:    ttc generate --out DIR routh_sphere.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   26   14    1    1    0     13   11   (86)
 *  jacobian            7   51   27    1    1    0     17   18   (295)
 *  rhs_jacobian        7   57   31    1    1    0     17   28   (350)
 *  divergence          2    9    7    1    1    0      9    6   (42)
 *  integral_values     2   13   12    0    2    0      6    9   (57)
 *  integral_gradients  4   28   13    1    2    0     11   11   (86)
 *  measure_values      2    3    5    0    1    0      6    6   (27)
 *  measure_divergences 2   19   10    1    2    0     12   10   (66)
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
    const double t0 = -params[4]; /* -I1 */
    const double t1 = params[0]*params[1]; /* m*R */
    const double t2 = t1*params[3]; /* m*R*a3 */
    const double t3 = t2/params[4]; /* m*R*a3/I1 */
    const double t4 = params[0]*params[2]; /* m*g */
    const double t5 = params[3]*t4; /* a3*m*g */
    const double t6 = t5/params[4]; /* a3*m*g/I1 */
    const double t7 = params[0]/params[4]; /* m/I1 */
    const double t8 = params[1]*params[1]; /* R*R */
    const double t9 = params[3]*params[3]; /* a3*a3 */
    const double t10 = t8 + t9; /* R*R + a3*a3 */
    const double t11 = params[1]*2.0; /* R*2 */
    const double t12 = params[3]*t11; /* a3*R*2 */
    const double t13 = params[4]*params[5]; /* I1*I3 */
    const double t14 = params[0]*t8; /* m*R*R */
    const double t15 = params[4]*t14; /* I1*m*R*R */
    const double t16 = params[0]*params[5]; /* m*I3 */
    const double t17 = params[5]/params[4]; /* I3/I1 */
    const double t18 = params[4] - params[5]; /* I1 - I3 */
    const double t19 = params[1]*t18; /* R*(I1 - I3) */
    const double t20 = params[3]*params[5]; /* a3*I3 */
    const double t21 = params[0]*2.0; /* m*2 */
    const double t22 = params[1]*t21; /* R*m*2 */
    const double t23 = params[3]*t22; /* a3*R*m*2 */
    const double t24 = params[4]/params[0]; /* I1/m */
    const double t25 = params[5]*t23; /* I3*a3*R*m*2 */
    const double t26 = t25/params[4]; /* I3*a3*R*m*2/I1 */
    const double t27 = params[4]*(-2.0); /* I1*(-2) */
    const double t28 = -params[5]; /* -I3 */
    const double t29 = -params[0]; /* -m */
    const double t30 = params[5]/t1; /* I3/(m*R) */
    const double t31 = t2*params[5]; /* m*R*a3*I3 */
    const double t32 = t8*t21; /* R*R*m*2 */
    const double t33 = params[4]*t32; /* I1*R*R*m*2 */
    const double t34 = params[5]*t22; /* I3*R*m*2 */
    const double t35 = t14*t18; /* m*R*R*(I1 - I3) */
    const double t36 = params[0]*params[3]; /* m*a3 */
    const double t37 = -t36; /* -m*a3 */
    const double t38 = params[4]*t23; /* I1*a3*R*m*2 */
    const double t39 = t11*params[5]; /* R*2*I3 */
    const double t40 = params[5]/params[0]; /* I3/m */
    const double t41 = -t1; /* -m*R */
    const double t42 = params[3]*2.0; /* a3*2 */
    const double t43 = params[0]/2.0; /* m/2 */
    const double t44 = params[4]/2.0; /* I1/2 */
    const double t45 = params[5]/2.0; /* I3/2 */
    const double t46 = params[4]*params[1]; /* I1*R */
    const double t47 = -t46; /* -I1*R */
    const double t48 = params[1]*params[5]; /* R*I3 */
    const double t49 = -t48; /* -R*I3 */
    const double t50 = params[0]*4.0; /* m*4 */
    const double t51 = params[1]*t50; /* R*m*4 */
    const double t52 = params[3]*t51; /* a3*R*m*4 */
    out[6] = t0;
    out[7] = t3;
    out[8] = t6;
    out[9] = t7;
    out[10] = t10;
    out[11] = t12;
    out[12] = t13;
    out[13] = t15;
    out[14] = t16;
    out[15] = t17;
    out[16] = t1;
    out[17] = t19;
    out[18] = t20;
    out[19] = t23;
    out[20] = t24;
    out[21] = t26;
    out[22] = t2;
    out[23] = t5;
    out[24] = t27;
    out[25] = t28;
    out[26] = t29;
    out[27] = t30;
    out[28] = t31;
    out[29] = t33;
    out[30] = t34;
    out[31] = t35;
    out[32] = t37;
    out[33] = t38;
    out[34] = t36;
    out[35] = t39;
    out[36] = t22;
    out[37] = t40;
    out[38] = t41;
    out[39] = t42;
    out[40] = t43;
    out[41] = t9;
    out[42] = t44;
    out[43] = t45;
    out[44] = t46;
    out[45] = t47;
    out[46] = t49;
    out[47] = t52;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[1]*t3; /* omega_tau*s */
    const double t5 = x[1]*p[7]; /* omega_tau*m*R*a3/I1 */
    const double t6 = t4*t5; /* omega_tau*s*omega_tau*m*R*a3/I1 */
    const double t7 = x[0]*x[2]; /* gamma3*omega_n */
    const double t8 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t9 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = x[2]*t9; /* omega_n*b */
    const double t11 = p[1]*x[3]; /* R*omega3 */
    const double t12 = JLT_FMA(t3, t11, t10); /* v_tau = s*R*omega3 + omega_n*b */
    const double t13 = p[9]*t8; /* m/I1*e */
    const double t14 = JLT_FMA(t12, t13, t7); /* v_tau*m/I1*e + gamma3*omega_n */
    const double t15 = JLT_FMA(x[0], p[11], p[10]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t16 = JLT_FMA(p[0], t15, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t17 = t9*p[14]; /* b*m*I3 */
    const double t18 = JLT_FMA(t2, p[13], p[12]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t19 = JLT_FMA(t9, t17, t18); /* Theta = b*b*m*I3 + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t20 = t16*t19; /* K*Theta */
    const double t21 = t3*t20; /* s*K*Theta */
    const double t22 = 1.0/t21; /* 1/(s*K*Theta) */
    const double t23 = t19*t22; /* Theta*1/(s*K*Theta) */
    const double t24 = t16*t23; /* K*Theta*1/(s*K*Theta) */
    const double t25 = t14*t24; /* (v_tau*m/I1*e + gamma3*omega_n)*K*Theta*1/(s*K*Theta) */
    const double t26 = JLT_FMA(x[3], p[15], t25); /* omega3*I3/I1 + (v_tau*m/I1*e + gamma3*omega_n)*K*Theta*1/(s*K*Theta) */
    const double t27 = JLT_FMA(t3, p[8], t6); /* s*m*g*a3/I1 + omega_tau*s*omega_tau*m*R*a3/I1 */
    const double t28 = JLT_FMA(x[2], t26, t27); /* omega_n*t26 + s*m*g*a3/I1 + omega_tau*s*omega_tau*m*R*a3/I1 */
    const double t29 = t3*p[6]; /* s*(-I1) */
    const double t30 = t23*t29; /* Theta*1/(s*K*Theta)*s*(-I1) */
    const double t31 = t28*t30; /* (omega_n*t26 + s*m*g*a3/I1 + omega_tau*s*omega_tau*m*R*a3/I1)*Theta*1/(s*K*Theta)*s*(-I1) */
    const double t32 = t7*t24; /* gamma3*omega_n*K*Theta*1/(s*K*Theta) */
    const double t33 = JLT_FMA(t8, p[16], p[5]); /* e*m*R + I3 */
    const double t34 = x[3]*t16; /* omega3*K */
    const double t35 = t3*t34; /* s*omega3*K */
    const double t36 = t22*t35; /* 1/(s*K*Theta)*s*omega3*K */
    const double t37 = p[5]*t33; /* I3*(e*m*R + I3) */
    const double t38 = JLT_FMA(t36, t37, t32); /* 1/(s*K*Theta)*s*omega3*K*I3*(e*m*R + I3) + gamma3*omega_n*K*Theta*1/(s*K*Theta) */
    const double t39 = x[1]*t38; /* omega_tau*t38 */
    const double t40 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t41 = p[16]*t40; /* m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t42 = t4*t41; /* omega_tau*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t43 = t36*t42; /* 1/(s*K*Theta)*s*omega3*K*omega_tau*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[0] = t4;
    out[1] = t31;
    out[2] = t39;
    out[3] = t43;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[0], p[11], p[10]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t1 = JLT_FMA(p[0], t0, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = p[14]*t5; /* m*I3*b */
    const double t7 = JLT_FMA(p[13], t4, p[12]); /* m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta = b*m*I3*b + m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t9 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t10 = t1*t8; /* K*Theta */
    const double t11 = t9*t10; /* s*K*Theta */
    const double t12 = 1.0/t11; /* 1/(s*K*Theta) */
    const double t13 = t8*t12; /* Theta*1/(s*K*Theta) */
    const double t14 = t1*t13; /* K*Theta*1/(s*K*Theta) */
    const double t15 = x[0]*t14; /* gamma3*K*Theta*1/(s*K*Theta) */
    const double t16 = x[1]*t15; /* omega_tau*gamma3*K*Theta*1/(s*K*Theta) */
    const double t17 = -t16; /* -omega_tau*gamma3*K*Theta*1/(s*K*Theta) */
    const double t18 = t9*t13; /* s*Theta*1/(s*K*Theta) */
    const double t19 = x[2]*t18; /* omega_n*s*Theta*1/(s*K*Theta) */
    const double t20 = t5*x[2]; /* b*omega_n */
    const double t21 = p[1]*x[3]; /* R*omega3 */
    const double t22 = JLT_FMA(t9, t21, t20); /* v_tau = s*R*omega3 + b*omega_n */
    const double t23 = p[3]*t22; /* a3*v_tau */
    const double t24 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t25 = t18*p[19]; /* s*Theta*1/(s*K*Theta)*2*m*R*a3 */
    const double t26 = JLT_FMS(t14, t15, t25); /* K*Theta*1/(s*K*Theta)*gamma3*K*Theta*1/(s*K*Theta) - s*Theta*1/(s*K*Theta)*2*m*R*a3 */
    const double t27 = t22*t26; /* v_tau*t26 */
    const double t28 = JLT_FNMA(t15, x[3], x[2]); /* omega_n - gamma3*K*Theta*1/(s*K*Theta)*omega3 */
    const double t29 = JLT_FMA(p[1], t28, t27); /* R*(omega_n - gamma3*K*Theta*1/(s*K*Theta)*omega3) + v_tau*t26 */
    const double t30 = JLT_FMA(t24, t29, t23); /* e*t29 + a3*v_tau */
    const double t31 = t14*t30; /* K*Theta*1/(s*K*Theta)*(e*t29 + a3*v_tau) */
    const double t32 = JLT_FMA(t15, t26, t14); /* gamma3*K*Theta*1/(s*K*Theta)*t26 + K*Theta*1/(s*K*Theta) */
    const double t33 = x[2]*t32; /* omega_n*(gamma3*K*Theta*1/(s*K*Theta)*t26 + K*Theta*1/(s*K*Theta)) */
    const double t34 = t18*x[3]; /* s*Theta*1/(s*K*Theta)*omega3 */
    const double t35 = JLT_FNMA(p[21], t34, t33); /* t33 - 2*m*R*a3*I3/I1*s*Theta*1/(s*K*Theta)*omega3 */
    const double t36 = JLT_FMA(p[20], t35, t31); /* I1/m*(t33 - 2*m*R*a3*I3/I1*s*Theta*1/(s*K*Theta)*omega3) + K*Theta*1/(s*K*Theta)*(e*t29 + a3*v_tau) */
    const double t37 = p[0]*t19; /* m*omega_n*s*Theta*1/(s*K*Theta) */
    const double t38 = t9*t25; /* s*s*Theta*1/(s*K*Theta)*2*m*R*a3 */
    const double t39 = t15 + t38; /* gamma3*K*Theta*1/(s*K*Theta) + s*s*Theta*1/(s*K*Theta)*2*m*R*a3 */
    const double t40 = t18*t39; /* s*Theta*1/(s*K*Theta)*t39 */
    const double t41 = x[1]*p[22]; /* omega_tau*m*R*a3 */
    const double t42 = x[1]*t41; /* omega_tau*omega_tau*m*R*a3 */
    const double t43 = t40*t42; /* s*Theta*1/(s*K*Theta)*t39*omega_tau*omega_tau*m*R*a3 */
    const double t44 = JLT_FMA(t40, p[23], t43); /* s*Theta*1/(s*K*Theta)*t39*m*g*a3 + s*Theta*1/(s*K*Theta)*t39*omega_tau*omega_tau*m*R*a3 */
    const double t45 = JLT_FNMA(t36, t37, t44); /* t44 - t36*m*omega_n*s*Theta*1/(s*K*Theta) */
    const double t46 = x[1]*t38; /* omega_tau*s*s*Theta*1/(s*K*Theta)*2*m*R*a3 */
    const double t47 = -t46; /* -omega_tau*s*s*Theta*1/(s*K*Theta)*2*m*R*a3 */
    const double t48 = t15*p[24]; /* gamma3*K*Theta*1/(s*K*Theta)*(-2*I1) */
    const double t49 = t19*t48; /* omega_n*s*Theta*1/(s*K*Theta)*gamma3*K*Theta*1/(s*K*Theta)*(-2*I1) */
    const double t50 = t18*t22; /* s*Theta*1/(s*K*Theta)*v_tau */
    const double t51 = JLT_FMA(t5, t19, t50); /* b*omega_n*s*Theta*1/(s*K*Theta) + s*Theta*1/(s*K*Theta)*v_tau */
    const double t52 = t24*p[26]; /* e*(-m) */
    const double t53 = t14*t52; /* K*Theta*1/(s*K*Theta)*e*(-m) */
    const double t54 = JLT_FMA(t34, p[25], t49); /* s*Theta*1/(s*K*Theta)*omega3*(-I3) + t49 */
    const double t55 = JLT_FMA(t51, t53, t54); /* t51*K*Theta*1/(s*K*Theta)*e*(-m) + s*Theta*1/(s*K*Theta)*omega3*(-I3) + t49 */
    const double t56 = t24 + p[27]; /* e + I3/(m*R) */
    const double t57 = p[16]*t56; /* m*R*(e + I3/(m*R)) */
    const double t58 = t19*t57; /* omega_n*s*Theta*1/(s*K*Theta)*m*R*(e + I3/(m*R)) */
    const double t59 = -t58; /* -omega_n*s*Theta*1/(s*K*Theta)*m*R*(e + I3/(m*R)) */
    const double t60 = JLT_FMA(t15, t16, x[1]); /* gamma3*K*Theta*1/(s*K*Theta)*omega_tau*gamma3*K*Theta*1/(s*K*Theta) + omega_tau */
    const double t61 = t14*x[2]; /* K*Theta*1/(s*K*Theta)*omega_n */
    const double t62 = t60*t61; /* t60*K*Theta*1/(s*K*Theta)*omega_n */
    const double t63 = t1*t9; /* K*s */
    const double t64 = t12*t63; /* 1/(s*K*Theta)*K*s */
    const double t65 = x[1]*t64; /* omega_tau*1/(s*K*Theta)*K*s */
    const double t66 = x[3]*t65; /* omega3*omega_tau*1/(s*K*Theta)*K*s */
    const double t67 = x[0]*p[29]; /* gamma3*2*m*R^2*I1 */
    const double t68 = JLT_FMS(t5, p[30], t67); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t69 = t57*p[5]; /* m*R*(e + I3/(m*R))*I3 */
    const double t70 = t64*t69; /* 1/(s*K*Theta)*K*s*m*R*(e + I3/(m*R))*I3 */
    const double t71 = JLT_FNMA(t68, t70, p[28]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*1/(s*K*Theta)*K*s*m*R*(e + I3/(m*R))*I3 */
    const double t72 = JLT_FMA(t66, t71, t62); /* omega3*omega_tau*1/(s*K*Theta)*K*s*t71 + t60*K*Theta*1/(s*K*Theta)*omega_n */
    const double t73 = t15*x[2]; /* gamma3*K*Theta*1/(s*K*Theta)*omega_n */
    const double t74 = JLT_FMA(x[3], t70, t73); /* omega3*1/(s*K*Theta)*K*s*m*R*(e + I3/(m*R))*I3 + gamma3*K*Theta*1/(s*K*Theta)*omega_n */
    const double t75 = t65*t69; /* omega_tau*1/(s*K*Theta)*K*s*m*R*(e + I3/(m*R))*I3 */
    const double t76 = t9*p[31]; /* s*m*R^2*(I1 - I3) */
    const double t77 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t78 = p[16]*t77; /* m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t79 = t9*t64; /* s*1/(s*K*Theta)*K*s */
    const double t80 = JLT_FMA(t68, t79, t15); /* d(Theta)/d(gamma3)*s*1/(s*K*Theta)*K*s + gamma3*K*Theta*1/(s*K*Theta) */
    const double t81 = JLT_FNMA(t78, t80, t76); /* s*m*R^2*(I1 - I3) - m*R*(gamma3*R*(I1 - I3) - a3*I3)*t80 */
    const double t82 = t66*t81; /* omega3*omega_tau*1/(s*K*Theta)*K*s*(s*m*R^2*(I1 - I3) - m*R*(gamma3*R*(I1 - I3) - a3*I3)*t80) */
    const double t83 = x[3]*t78; /* omega3*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t84 = t79*t83; /* s*1/(s*K*Theta)*K*s*omega3*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t85 = t9*t78; /* s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t86 = t65*t85; /* omega_tau*1/(s*K*Theta)*K*s*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[0] = t17;
    out[1] = t9;
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = t45;
    out[5] = t47;
    out[6] = t55;
    out[7] = t59;
    out[8] = t72;
    out[9] = t74;
    out[10] = t16;
    out[11] = t75;
    out[12] = t82;
    out[13] = t84;
    out[14] = 0.0;
    out[15] = t86;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[1]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = p[14]*t5; /* m*I3*b */
    const double t7 = JLT_FMA(t2, p[13], p[12]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta = b*m*I3*b + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(x[0], p[11], p[10]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t10 = JLT_FMA(p[0], t9, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t11 = t8*t10; /* Theta*K */
    const double t12 = t3*t11; /* s*Theta*K */
    const double t13 = 1.0/t12; /* 1/(s*Theta*K) */
    const double t14 = t8*t13; /* Theta*1/(s*Theta*K) */
    const double t15 = t3*t14; /* s*Theta*1/(s*Theta*K) */
    const double t16 = x[2]*t15; /* omega_n*s*Theta*1/(s*Theta*K) */
    const double t17 = t10*t14; /* K*Theta*1/(s*Theta*K) */
    const double t18 = x[0]*t17; /* gamma3*K*Theta*1/(s*Theta*K) */
    const double t19 = x[2]*t18; /* omega_n*gamma3*K*Theta*1/(s*Theta*K) */
    const double t20 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t21 = x[2]*t5; /* omega_n*b */
    const double t22 = p[1]*x[3]; /* R*omega3 */
    const double t23 = JLT_FMA(t3, t22, t21); /* v_tau = s*R*omega3 + omega_n*b */
    const double t24 = t20*t23; /* e*v_tau */
    const double t25 = t17*t24; /* K*Theta*1/(s*Theta*K)*e*v_tau */
    const double t26 = JLT_FMA(p[9], t25, t19); /* m/I1*K*Theta*1/(s*Theta*K)*e*v_tau + omega_n*gamma3*K*Theta*1/(s*Theta*K) */
    const double t27 = JLT_FMA(p[15], x[3], t26); /* I3/I1*omega3 + t26 */
    const double t28 = p[6]*t16; /* (-I1)*omega_n*s*Theta*1/(s*Theta*K) */
    const double t29 = t27*t28; /* (I3/I1*omega3 + t26)*(-I1)*omega_n*s*Theta*1/(s*Theta*K) */
    const double t30 = x[1]*p[1]; /* omega_tau*R */
    const double t31 = JLT_FMA(x[1], t30, p[2]); /* omega_tau*omega_tau*R + g */
    const double t32 = t3*t15; /* s*s*Theta*1/(s*Theta*K) */
    const double t33 = p[32]*t31; /* (-m*a3)*(omega_tau*omega_tau*R + g) */
    const double t34 = JLT_FMA(t32, t33, t29); /* s*s*Theta*1/(s*Theta*K)*(-m*a3)*(omega_tau*omega_tau*R + g) + (I3/I1*omega3 + t26)*(-I1)*omega_n*s*Theta*1/(s*Theta*K) */
    const double t35 = x[1]*t19; /* omega_tau*omega_n*gamma3*K*Theta*1/(s*Theta*K) */
    const double t36 = t3*t10; /* s*K */
    const double t37 = t13*t36; /* 1/(s*Theta*K)*s*K */
    const double t38 = x[1]*t37; /* omega_tau*1/(s*Theta*K)*s*K */
    const double t39 = x[3]*t38; /* omega3*omega_tau*1/(s*Theta*K)*s*K */
    const double t40 = t20 + p[27]; /* e + I3/(m*R) */
    const double t41 = p[16]*t40; /* m*R*(e + I3/(m*R)) */
    const double t42 = p[5]*t41; /* I3*m*R*(e + I3/(m*R)) */
    const double t43 = JLT_FMA(t39, t42, t35); /* omega3*omega_tau*1/(s*Theta*K)*s*K*I3*m*R*(e + I3/(m*R)) + omega_tau*omega_n*gamma3*K*Theta*1/(s*Theta*K) */
    const double t44 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t45 = p[16]*t44; /* m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t46 = t3*t45; /* s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t47 = t39*t46; /* omega3*omega_tau*1/(s*Theta*K)*s*K*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t48 = x[1]*t18; /* omega_tau*gamma3*K*Theta*1/(s*Theta*K) */
    const double t49 = -t48; /* -omega_tau*gamma3*K*Theta*1/(s*Theta*K) */
    const double t50 = t16*t17; /* omega_n*s*Theta*1/(s*Theta*K)*K*Theta*1/(s*Theta*K) */
    const double t51 = JLT_FMA(t18, t26, x[2]); /* gamma3*K*Theta*1/(s*Theta*K)*t26 + omega_n */
    const double t52 = p[4]*t50; /* I1*omega_n*s*Theta*1/(s*Theta*K)*K*Theta*1/(s*Theta*K) */
    const double t53 = t16*t18; /* omega_n*s*Theta*1/(s*Theta*K)*gamma3*K*Theta*1/(s*Theta*K) */
    const double t54 = t16*p[33]; /* omega_n*s*Theta*1/(s*Theta*K)*2*m*R*a3*I1 */
    const double t55 = t53*t54; /* omega_n*s*Theta*1/(s*Theta*K)*gamma3*K*Theta*1/(s*Theta*K)*omega_n*s*Theta*1/(s*Theta*K)*2*m*R*a3*I1 */
    const double t56 = x[3]*p[35]; /* omega3*2*R*I3 */
    const double t57 = t16*t56; /* omega_n*s*Theta*1/(s*Theta*K)*omega3*2*R*I3 */
    const double t58 = t20*t50; /* e*omega_n*s*Theta*1/(s*Theta*K)*K*Theta*1/(s*Theta*K) */
    const double t59 = t23*p[36]; /* v_tau*2*m*R */
    const double t60 = t32*p[19]; /* s*s*Theta*1/(s*Theta*K)*2*m*R*a3 */
    const double t61 = t18 + t60; /* gamma3*K*Theta*1/(s*Theta*K) + s*s*Theta*1/(s*Theta*K)*2*m*R*a3 */
    const double t62 = JLT_FMA(t58, t59, t57); /* e*omega_n*s*Theta*1/(s*Theta*K)*K*Theta*1/(s*Theta*K)*v_tau*2*m*R + omega_n*s*Theta*1/(s*Theta*K)*omega3*2*R*I3 */
    const double t63 = JLT_FMA(t31, t61, t62); /* (omega_tau*omega_tau*R + g)*t61 + t62 */
    const double t64 = t15*t63; /* s*Theta*1/(s*Theta*K)*((omega_tau*omega_tau*R + g)*t61 + t62) */
    const double t65 = JLT_FNMA(t23, t50, t64); /* t64 - v_tau*omega_n*s*Theta*1/(s*Theta*K)*K*Theta*1/(s*Theta*K) */
    const double t66 = JLT_FNMA(x[3], t18, x[2]); /* omega_n - omega3*gamma3*K*Theta*1/(s*Theta*K) */
    const double t67 = p[16]*t58; /* m*R*e*omega_n*s*Theta*1/(s*Theta*K)*K*Theta*1/(s*Theta*K) */
    const double t68 = JLT_FNMA(t66, t67, t55); /* t55 - (omega_n - omega3*gamma3*K*Theta*1/(s*Theta*K))*m*R*e*omega_n*s*Theta*1/(s*Theta*K)*K*Theta*1/(s*Theta*K) */
    const double t69 = JLT_FNMA(t51, t52, t68); /* t68 - (gamma3*K*Theta*1/(s*Theta*K)*t26 + omega_n)*I1*omega_n*s*Theta*1/(s*Theta*K)*K*Theta*1/(s*Theta*K) */
    const double t70 = JLT_FMA(p[34], t65, t69); /* m*a3*t65 + t69 */
    const double t71 = x[1]*t60; /* omega_tau*s*s*Theta*1/(s*Theta*K)*2*m*R*a3 */
    const double t72 = -t71; /* -omega_tau*s*s*Theta*1/(s*Theta*K)*2*m*R*a3 */
    const double t73 = t53*p[24]; /* omega_n*s*Theta*1/(s*Theta*K)*gamma3*K*Theta*1/(s*Theta*K)*(-2*I1) */
    const double t74 = JLT_FMA(x[3], p[37], t25); /* omega3*I3/m + K*Theta*1/(s*Theta*K)*e*v_tau */
    const double t75 = t15*t74; /* s*Theta*1/(s*Theta*K)*(omega3*I3/m + K*Theta*1/(s*Theta*K)*e*v_tau) */
    const double t76 = JLT_FMA(t5, t58, t75); /* b*e*omega_n*s*Theta*1/(s*Theta*K)*K*Theta*1/(s*Theta*K) + t75 */
    const double t77 = JLT_FMA(p[26], t76, t73); /* (-m)*t76 + t73 */
    const double t78 = t16*t41; /* omega_n*s*Theta*1/(s*Theta*K)*m*R*(e + I3/(m*R)) */
    const double t79 = -t78; /* -omega_n*s*Theta*1/(s*Theta*K)*m*R*(e + I3/(m*R)) */
    const double t80 = JLT_FMA(t18, t19, x[2]); /* gamma3*K*Theta*1/(s*Theta*K)*omega_n*gamma3*K*Theta*1/(s*Theta*K) + omega_n */
    const double t81 = x[1]*t17; /* omega_tau*K*Theta*1/(s*Theta*K) */
    const double t82 = t80*t81; /* t80*omega_tau*K*Theta*1/(s*Theta*K) */
    const double t83 = x[0]*p[29]; /* gamma3*2*m*R^2*I1 */
    const double t84 = JLT_FMS(t5, p[30], t83); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t85 = t37*t42; /* 1/(s*Theta*K)*s*K*I3*m*R*(e + I3/(m*R)) */
    const double t86 = JLT_FNMA(t84, t85, p[28]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*1/(s*Theta*K)*s*K*I3*m*R*(e + I3/(m*R)) */
    const double t87 = JLT_FMA(t39, t86, t82); /* omega3*omega_tau*1/(s*Theta*K)*s*K*t86 + t80*omega_tau*K*Theta*1/(s*Theta*K) */
    const double t88 = JLT_FMA(x[3], t85, t19); /* omega3*1/(s*Theta*K)*s*K*I3*m*R*(e + I3/(m*R)) + omega_n*gamma3*K*Theta*1/(s*Theta*K) */
    const double t89 = t38*t42; /* omega_tau*1/(s*Theta*K)*s*K*I3*m*R*(e + I3/(m*R)) */
    const double t90 = t3*p[31]; /* s*m*R^2*(I1 - I3) */
    const double t91 = t37*t46; /* 1/(s*Theta*K)*s*K*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t92 = JLT_FNMA(t84, t91, t90); /* s*m*R^2*(I1 - I3) - d(Theta)/d(gamma3)*1/(s*Theta*K)*s*K*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t93 = JLT_FNMA(t18, t45, t92); /* t92 - gamma3*K*Theta*1/(s*Theta*K)*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t94 = t39*t93; /* omega3*omega_tau*1/(s*Theta*K)*s*K*t93 */
    const double t95 = x[3]*t91; /* omega3*1/(s*Theta*K)*s*K*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t96 = t38*t46; /* omega_tau*1/(s*Theta*K)*s*K*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[0] = t4;
    out[1] = t34;
    out[2] = t43;
    out[3] = t47;
    out[4] = t49;
    out[5] = t3;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t70;
    out[9] = t72;
    out[10] = t77;
    out[11] = t79;
    out[12] = t87;
    out[13] = t88;
    out[14] = t48;
    out[15] = t89;
    out[16] = t94;
    out[17] = t95;
    out[18] = 0.0;
    out[19] = t96;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = p[14]*t4; /* m*I3*b */
    const double t6 = JLT_FMA(t2, p[13], p[12]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*m*I3*b + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(x[0], p[11], p[10]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t9 = JLT_FMA(p[0], t8, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t10 = t7*t9; /* Theta*K */
    const double t11 = 1.0/t10; /* 1/(Theta*K) */
    const double t12 = p[39]*t7; /* 2*a3*Theta */
    const double t13 = t11*t12; /* 1/(Theta*K)*2*a3*Theta */
    const double t14 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t15 = t9*t14; /* K*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t16 = JLT_FNMA(t11, t15, t13); /* 1/(Theta*K)*2*a3*Theta - 1/(Theta*K)*K*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t17 = p[38]*x[1]; /* (-m*R)*omega_tau */
    const double t18 = t3*t17; /* s*(-m*R)*omega_tau */
    const double t19 = t16*t18; /* t16*s*(-m*R)*omega_tau */
    out[0] = t19;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[23]*x[0]; /* m*g*a3*gamma3 */
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
    const double t24 = t9*p[14]; /* b*m*I3 */
    const double t25 = JLT_FMA(t5, p[13], p[12]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
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
    const double t3 = p[3]*x[1]; /* a3*omega_tau */
    const double t4 = x[1]*t3; /* omega_tau*a3*omega_tau */
    const double t5 = t2*t4; /* (e - a3*gamma3)*omega_tau*a3*omega_tau */
    const double t6 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t7 = x[2]*t6; /* omega_n*b */
    const double t8 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t9 = x[0] + 1.0; /* gamma3 + 1 */
    const double t10 = t8*t9; /* (1 - gamma3)*(gamma3 + 1) */
    const double t11 = sqrt(t10); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t12 = p[1]*x[3]; /* R*omega3 */
    const double t13 = JLT_FMA(t11, t12, t7); /* v_tau = s*R*omega3 + omega_n*b */
    const double t14 = t6*p[14]; /* b*m*I3 */
    const double t15 = JLT_FMA(t10, p[13], p[12]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t16 = JLT_FMA(t6, t14, t15); /* Theta = b*b*m*I3 + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t17 = sqrt(t16); /* h = sqrt(Theta) */
    const double t18 = t11*t17; /* s*h */
    const double t19 = 1.0/t18; /* 1/(s*h) */
    const double t20 = x[0]*t17; /* gamma3*h */
    const double t21 = t19*t20; /* 1/(s*h)*gamma3*h */
    const double t22 = JLT_FMS(x[3], t21, x[2]); /* omega3*1/(s*h)*gamma3*h - omega_n */
    const double t23 = p[1]*t13; /* R*v_tau */
    const double t24 = JLT_FNMA(t22, t23, t5); /* (e - a3*gamma3)*omega_tau*a3*omega_tau - (omega3*1/(s*h)*gamma3*h - omega_n)*R*v_tau */
    const double t25 = JLT_FMA(p[0], t24, p[23]); /* m*t24 + m*g*a3 */
    const double t26 = t1*t1; /* e*e */
    const double t27 = JLT_FMA(t10, p[41], t26); /* (1 - gamma3)*(gamma3 + 1)*a3^2 + e*e */
    const double t28 = p[0]*x[1]; /* m*omega_tau */
    const double t29 = t27*t28; /* ((1 - gamma3)*(gamma3 + 1)*a3^2 + e*e)*m*omega_tau */
    const double t30 = JLT_FMA(x[1], p[4], t29); /* omega_tau*I1 + ((1 - gamma3)*(gamma3 + 1)*a3^2 + e*e)*m*omega_tau */
    const double t31 = p[0]*t6; /* m*b */
    const double t32 = t13*t31; /* v_tau*m*b */
    const double t33 = JLT_FMA(x[2], p[4], t32); /* omega_n*I1 + v_tau*m*b */
    const double t34 = t11*p[16]; /* s*m*R */
    const double t35 = t13*t34; /* v_tau*s*m*R */
    const double t36 = JLT_FMA(x[3], p[5], t35); /* omega3*I3 + v_tau*s*m*R */
    const double t37 = x[2]*p[45]; /* omega_n*(-R*I1) */
    const double t38 = t21*t37; /* 1/(s*h)*gamma3*h*omega_n*(-R*I1) */
    const double t39 = JLT_FMA(x[3], p[46], t38); /* omega3*(-R*I3) + 1/(s*h)*gamma3*h*omega_n*(-R*I1) */
    const double t40 = t11*p[44]; /* s*R*I1 */
    const double t41 = t6*p[25]; /* b*(-I3) */
    const double t42 = x[0]*p[29]; /* gamma3*2*m*R^2*I1 */
    const double t43 = JLT_FMS(t6, p[30], t42); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t44 = x[3]*(1.0 / 2.0); /* omega3*1/2 */
    const double t45 = t43*t44; /* d(Theta)/d(gamma3)*omega3*1/2 */
    const double t46 = t11*t45; /* s*d(Theta)/d(gamma3)*omega3*1/2 */
    const double t47 = t19*t46; /* 1/(s*h)*s*d(Theta)/d(gamma3)*omega3*1/2 */
    out[0] = t25;
    out[1] = t30;
    out[2] = t33;
    out[3] = t36;
    out[4] = t39;
    out[5] = 0.0;
    out[6] = t40;
    out[7] = t41;
    out[8] = t47;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t17;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[11], x[0], p[10]); /* 2*R*a3*gamma3 + R^2 + a3^2 */
    const double t1 = JLT_FMA(p[0], t0, p[4]); /* K = m*(2*R*a3*gamma3 + R^2 + a3^2) + I1 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = p[13]*t2; /* m*R^2*I1*(1 - gamma3) */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = p[14]*t5; /* m*I3*b */
    const double t7 = JLT_FMA(t3, t4, p[12]); /* (gamma3 + 1)*m*R^2*I1*(1 - gamma3) + I1*I3 */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta = b*m*I3*b + (gamma3 + 1)*m*R^2*I1*(1 - gamma3) + I1*I3 */
    const double t9 = sqrt(t8); /* h = sqrt(Theta) */
    const double t10 = t1*t9; /* K*h */
    out[0] = t10;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[11], x[0], p[10]); /* 2*R*a3*gamma3 + R^2 + a3^2 */
    const double t1 = JLT_FMA(p[0], t0, p[4]); /* K = m*(2*R*a3*gamma3 + R^2 + a3^2) + I1 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = p[14]*t5; /* m*I3*b */
    const double t7 = JLT_FMA(p[13], t4, p[12]); /* m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta = b*m*I3*b + m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t9 = sqrt(t8); /* h = sqrt(Theta) */
    const double t10 = t1*t8; /* K*Theta */
    const double t11 = t9*t10; /* h*K*Theta */
    const double t12 = 1.0/t11; /* 1/(h*K*Theta) */
    const double t13 = t9*t12; /* h*1/(h*K*Theta) */
    const double t14 = t8*p[39]; /* Theta*2*a3 */
    const double t15 = t13*t14; /* h*1/(h*K*Theta)*Theta*2*a3 */
    const double t16 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t17 = t1*t16; /* K*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t18 = JLT_FNMA(t13, t17, t15); /* h*1/(h*K*Theta)*Theta*2*a3 - h*1/(h*K*Theta)*K*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t19 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t20 = t19*x[1]; /* s*omega_tau */
    const double t21 = p[16]*t1; /* m*R*K */
    const double t22 = t20*t21; /* s*omega_tau*m*R*K */
    const double t23 = t9*t22; /* h*s*omega_tau*m*R*K */
    const double t24 = t18*t23; /* t18*h*s*omega_tau*m*R*K */
    const double t25 = t9*p[47]; /* h*4*m*R*a3 */
    const double t26 = x[0]*p[29]; /* gamma3*2*m*R^2*I1 */
    const double t27 = JLT_FMS(t5, p[30], t26); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t28 = t1*t1; /* K*K */
    const double t29 = t27*t28; /* d(Theta)/d(gamma3)*K*K */
    const double t30 = t8*t29; /* Theta*d(Theta)/d(gamma3)*K*K */
    const double t31 = JLT_FMA(t12, t30, t25); /* 1/(h*K*Theta)*Theta*d(Theta)/d(gamma3)*K*K + h*4*m*R*a3 */
    const double t32 = t20*(1.0 / 2.0); /* s*omega_tau*1/2 */
    const double t33 = JLT_FMS(t31, t32, t24); /* (1/(h*K*Theta)*Theta*d(Theta)/d(gamma3)*K*K + h*4*m*R*a3)*s*omega_tau*1/2 - t18*h*s*omega_tau*m*R*K */
    out[0] = t33;
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
    double t11[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
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
        t10[k] = x1[k]*p[7];
        t11[k] = jlt_jet_product(t7, t10, k);
        t14[k] = jlt_jet_product(x0, x2, k);
        t18[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t19[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t20[k] = jlt_jet_product(x2, t19, k);
        t22[k] = p[1]*x3[k];
        t23[k] = jlt_jet_product(t6, t22, k) + t20[k];
        t24[k] = p[9]*t18[k];
        t25[k] = jlt_jet_product(t23, t24, k) + t14[k];
        t30[k] = x0[k]*p[11] + (k == 0 ? p[10] : 0);
        t31[k] = p[0]*t30[k] + (k == 0 ? p[4] : 0);
        t35[k] = t19[k]*p[14];
        t36[k] = t5[k]*p[13] + (k == 0 ? p[12] : 0);
        t37[k] = jlt_jet_product(t19, t35, k) + t36[k];
        t38[k] = jlt_jet_product(t31, t37, k);
        t39[k] = jlt_jet_product(t6, t38, k);
        t40[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t39, t40, k);
        t41[k] = jlt_jet_product(t37, t40, k);
        t42[k] = jlt_jet_product(t31, t41, k);
        t43[k] = jlt_jet_product(t25, t42, k);
        t45[k] = x3[k]*p[15] + t43[k];
        t46[k] = t6[k]*p[8] + t11[k];
        t47[k] = jlt_jet_product(x2, t45, k) + t46[k];
        t48[k] = t6[k]*p[6];
        t49[k] = jlt_jet_product(t41, t48, k);
        t50[k] = jlt_jet_product(t47, t49, k);
        t51[k] = jlt_jet_product(t14, t42, k);
        t54[k] = t18[k]*p[16] + (k == 0 ? p[5] : 0);
        t55[k] = jlt_jet_product(x3, t31, k);
        t56[k] = jlt_jet_product(t6, t55, k);
        t57[k] = jlt_jet_product(t40, t56, k);
        t58[k] = p[5]*t54[k];
        t59[k] = jlt_jet_product(t57, t58, k) + t51[k];
        t60[k] = jlt_jet_product(x1, t59, k);
        t63[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t64[k] = p[16]*t63[k];
        t65[k] = jlt_jet_product(t7, t64, k);
        t66[k] = jlt_jet_product(t57, t65, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t50[k]/(k + 1);
        next[2] = x2[k + 1] = t60[k]/(k + 1);
        next[3] = x3[k + 1] = t66[k]/(k + 1);
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
    const double t24 = params[0]*params[1]; /* m*R */
    const double t25 = t9*t24; /* s*m*R */
    const double t26 = t11*t25; /* v_tau*s*m*R */
    const double t27 = x[3]*params[5]; /* omega3*I3 */
    const double t28 = t26 + t27; /* v_tau*s*m*R + omega3*I3 */
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
    const double t54 = t24*params[5]; /* m*R*I3 */
    const double t55 = t3*t54; /* b*m*R*I3 */
    const double t56 = 2.0*t55; /* 2*b*m*R*I3 */
    const double t57 = t56 - t53; /* d(Theta)/d(gamma3) = 2*b*m*R*I3 - 2*gamma3*I1*m*R*R */
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
    .state_count = 4, .param_count = 6, .block_count = 48,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 2, 26, 14, 1, 1, 0, 13, 11 }, { 18, 58, 0, 9, 1, 0, 13, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 7, 51, 27, 1, 1, 0, 17, 18 }, { 48, 209, 0, 37, 1, 0, 20, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 57, 31, 1, 1, 0, 17, 28 }, { 57, 246, 0, 46, 1, 0, 20, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 9, 7, 1, 1, 0, 9, 6 }, { 10, 29, 0, 2, 1, 0, 9, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 3, { 2, 13, 12, 0, 2, 0, 6, 9 }, { 13, 42, 0, 0, 2, 0, 13, 7 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 12, { 4, 28, 13, 1, 2, 0, 11, 11 }, { 18, 63, 0, 3, 2, 0, 10, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by h: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { measure_values, 1, { 2, 3, 5, 0, 1, 0, 6, 6 }, { 7, 18, 0, 0, 2, 0, 9, 5 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .measure_divergences = { measure_divergences, 1, { 2, 19, 10, 1, 2, 0, 12, 10 }, { 13, 48, 0, 3, 2, 0, 14, 11 },
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
