/* Sphere with displaced centre of mass rolling without slipping, reduced system
 *
 *  Source:     E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      routh_sphere, SHA-256 7ea5d7e192247bbb71a43cf42803dc35e835526f39f8f2b9ef8220743e084b9e
 *  Command:    ttc generate --out DIR routh_sphere.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   22   14    1    0    0      8   10   (90)
 *  jacobian            6   57   25    1    0    0     13   14   (345)
 *  rhs_jacobian        7   68   30    1    0    0     12   25   (407)
 *  divergence          0    9    7    1    0    0      8    6   (41)
 *  integral_values     0   13   12    0    1    0      6    8   (54)
 *  integral_gradients  0   26   12    1    1    0      7    8   (77)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_routh_sphere[];
extern const jlt_descriptor jlt_kernels_routh_sphere_general_in_regular;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_in_regular_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = -params[4]; /* -I1 */
    const double t1 = params[4]*params[5]; /* I1*I3 */
    const double t2 = params[1]*params[1]; /* R*R */
    const double t3 = params[0]*t2; /* m*R*R */
    const double t4 = params[4]*t3; /* I1*m*R*R */
    const double t5 = params[5]*params[0]; /* I3*m */
    const double t6 = params[0]*params[2]; /* m*g */
    const double t7 = t6*params[3]; /* m*g*a3 */
    const double t8 = t7/params[4]; /* m*g*a3/I1 */
    const double t9 = params[5]/params[4]; /* I3/I1 */
    const double t10 = params[0]/params[4]; /* m/I1 */
    const double t11 = params[0]*params[1]; /* m*R */
    const double t12 = params[3]*t11; /* a3*m*R */
    const double t13 = t12/params[4]; /* a3*m*R/I1 */
    const double t14 = params[3]*params[3]; /* a3*a3 */
    const double t15 = t2 + t14; /* R*R + a3*a3 */
    const double t16 = params[1]*2.0; /* R*2 */
    const double t17 = params[3]*t16; /* a3*R*2 */
    const double t18 = params[4] - params[5]; /* I1 - I3 */
    const double t19 = params[1]*t18; /* R*(I1 - I3) */
    const double t20 = params[5]*params[3]; /* I3*a3 */
    const double t21 = params[3]/params[1]; /* a3/R */
    const double t22 = params[0]*2.0; /* m*2 */
    const double t23 = params[3]*t22; /* a3*m*2 */
    const double t24 = params[4]/t11; /* I1/(m*R) */
    const double t25 = params[1]*t22; /* R*m*2 */
    const double t26 = params[3]*t25; /* a3*R*m*2 */
    const double t27 = params[5]*t26; /* I3*a3*R*m*2 */
    const double t28 = t27/params[4]; /* I3*a3*R*m*2/I1 */
    const double t29 = params[0]*params[0]; /* m*m */
    const double t30 = params[1]*t29; /* R*m*m */
    const double t31 = t14*t30; /* a3*a3*R*m*m */
    const double t32 = params[2]*2.0; /* g*2 */
    const double t33 = params[0]*(-2.0); /* m*(-2) */
    const double t34 = params[1]*t33; /* R*m*(-2) */
    const double t35 = params[3]*t34; /* a3*R*m*(-2) */
    const double t36 = params[4]*(-2.0); /* I1*(-2) */
    const double t37 = -params[5]; /* -I3 */
    const double t38 = -params[0]; /* -m */
    const double t39 = params[5]/t11; /* I3/(m*R) */
    const double t40 = params[0]*params[3]; /* m*a3 */
    const double t41 = params[5]*t12; /* I3*a3*m*R */
    const double t42 = params[5]*params[5]; /* I3*I3 */
    const double t43 = t11*t42; /* m*R*I3*I3 */
    const double t44 = params[5]*t4; /* I3*I1*m*R*R */
    const double t45 = t3*t18; /* m*R*R*(I1 - I3) */
    const double t46 = 2.0*t29; /* 2*m*m */
    const double t47 = t2*t46; /* R*R*2*m*m */
    const double t48 = params[5]*t47; /* I3*R*R*2*m*m */
    const double t49 = params[1]*t2; /* R*R*R */
    const double t50 = t46*t49; /* 2*m*m*R*R*R */
    const double t51 = params[4]*t50; /* I1*2*m*m*R*R*R */
    const double t52 = params[5]/params[0]; /* I3/m */
    const double t53 = -t11; /* -m*R */
    const double t54 = -t12; /* -a3*m*R */
    const double t55 = -t7; /* -m*g*a3 */
    const double t56 = params[5]*t11; /* I3*m*R */
    const double t57 = params[5]*t16; /* I3*R*2 */
    const double t58 = params[4]*t16; /* I1*R*2 */
    const double t59 = t14*t47; /* a3*a3*R*R*2*m*m */
    const double t60 = params[1]*t46; /* R*2*m*m */
    const double t61 = params[2]*t60; /* g*R*2*m*m */
    const double t62 = t14*t61; /* a3*a3*g*R*2*m*m */
    const double t63 = params[2]*t22; /* g*m*2 */
    const double t64 = params[3]*t63; /* a3*g*m*2 */
    const double t65 = params[3]*2.0; /* a3*2 */
    const double t66 = params[0]/2.0; /* m/2 */
    const double t67 = params[4]/2.0; /* I1/2 */
    const double t68 = params[5]/2.0; /* I3/2 */
    const double t69 = params[4]*params[1]; /* I1*R */
    const double t70 = params[5]*params[1]; /* I3*R */
    const double t71 = -t70; /* -I3*R */
    out[6] = t0;
    out[7] = t1;
    out[8] = t4;
    out[9] = t5;
    out[10] = t8;
    out[11] = t9;
    out[12] = t10;
    out[13] = t13;
    out[14] = t15;
    out[15] = t17;
    out[16] = t11;
    out[17] = t19;
    out[18] = t20;
    out[19] = t21;
    out[20] = t23;
    out[21] = t24;
    out[22] = t28;
    out[23] = t26;
    out[24] = t31;
    out[25] = t32;
    out[26] = t16;
    out[27] = t35;
    out[28] = t36;
    out[29] = t37;
    out[30] = t38;
    out[31] = t39;
    out[32] = t40;
    out[33] = t41;
    out[34] = t43;
    out[35] = t25;
    out[36] = t44;
    out[37] = t45;
    out[38] = t48;
    out[39] = t51;
    out[40] = t52;
    out[41] = t54;
    out[42] = t55;
    out[43] = t56;
    out[44] = t57;
    out[45] = t58;
    out[46] = t59;
    out[47] = t62;
    out[48] = t64;
    out[49] = t53;
    out[50] = t65;
    out[51] = t7;
    out[52] = t66;
    out[53] = t14;
    out[54] = t67;
    out[55] = t68;
    out[56] = t69;
    out[57] = t71;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[1]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = p[9]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[8], t2, p[7]); /* m*R^2*I1*s*s + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t7 = t2*p[10]; /* s*s*m*g*a3/I1 */
    const double t8 = x[4]*x[3]; /* s*omega3 */
    const double t9 = x[0]*x[2]; /* gamma3*omega_n */
    const double t10 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t11 = t3*x[2]; /* b*omega_n */
    const double t12 = JLT_FMA(p[1], t8, t11); /* v_tau = R*s*omega3 + b*omega_n */
    const double t13 = p[12]*t10; /* m/I1*e */
    const double t14 = JLT_FMA(p[11], t8, t9); /* I3/I1*s*omega3 + gamma3*omega_n */
    const double t15 = JLT_FMA(t12, t13, t14); /* v_tau*m/I1*e + I3/I1*s*omega3 + gamma3*omega_n */
    const double t16 = t0*p[13]; /* s*omega_tau*m*R*a3/I1 */
    const double t17 = JLT_FMA(t0, t16, t7); /* s*omega_tau*s*omega_tau*m*R*a3/I1 + s*s*m*g*a3/I1 */
    const double t18 = JLT_FMA(x[2], t15, t17); /* omega_n*(v_tau*m/I1*e + I3/I1*s*omega3 + gamma3*omega_n) + s*omega_tau*s*omega_tau*m*R*a3/I1 + s*s*m*g*a3/I1 */
    const double t19 = JLT_FMA(x[0], p[15], p[14]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t20 = JLT_FMA(p[0], t19, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t21 = t6*t20; /* Theta*K */
    const double t22 = 1.0/t21; /* 1/(Theta*K) */
    const double t23 = p[6]*t6; /* (-I1)*Theta */
    const double t24 = t18*t23; /* t18*(-I1)*Theta */
    const double t25 = t22*t24; /* 1/(Theta*K)*t18*(-I1)*Theta */
    const double t26 = JLT_FMA(t10, p[16], p[5]); /* e*m*R + I3 */
    const double t27 = t8*t20; /* s*omega3*K */
    const double t28 = t22*t27; /* 1/(Theta*K)*s*omega3*K */
    const double t29 = p[5]*t26; /* I3*(e*m*R + I3) */
    const double t30 = JLT_FMA(t28, t29, t9); /* 1/(Theta*K)*s*omega3*K*I3*(e*m*R + I3) + gamma3*omega_n */
    const double t31 = x[1]*t30; /* omega_tau*(1/(Theta*K)*s*omega3*K*I3*(e*m*R + I3) + gamma3*omega_n) */
    const double t32 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t33 = t0*p[16]; /* s*omega_tau*m*R */
    const double t34 = t32*t33; /* (gamma3*R*(I1 - I3) - a3*I3)*s*omega_tau*m*R */
    const double t35 = t28*t34; /* 1/(Theta*K)*s*omega3*K*(gamma3*R*(I1 - I3) - a3*I3)*s*omega_tau*m*R */
    const double t36 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t37 = -t36; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t25;
    out[2] = t31;
    out[3] = t35;
    out[4] = t37;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[1]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = p[9]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(t0, p[8], p[7]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + s*s*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(x[0], p[15], p[14]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t8 = JLT_FMA(p[0], t7, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t9 = t6*t8; /* Theta*K */
    const double t10 = 1.0/t9; /* 1/(Theta*K) */
    const double t11 = t6*t10; /* Theta*1/(Theta*K) */
    const double t12 = x[2]*t11; /* omega_n*Theta*1/(Theta*K) */
    const double t13 = x[2]*t3; /* omega_n*b */
    const double t14 = x[4]*p[1]; /* s*R */
    const double t15 = JLT_FMA(x[3], t14, t13); /* v_tau = omega3*s*R + omega_n*b */
    const double t16 = p[19]*t15; /* a3/R*v_tau */
    const double t17 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t18 = t11*t15; /* Theta*1/(Theta*K)*v_tau */
    const double t19 = JLT_FNMA(p[20], t18, x[2]); /* omega_n - 2*m*a3*Theta*1/(Theta*K)*v_tau */
    const double t20 = x[4]*t11; /* s*Theta*1/(Theta*K) */
    const double t21 = x[3]*t20; /* omega3*s*Theta*1/(Theta*K) */
    const double t22 = x[0]*t12; /* gamma3*omega_n*Theta*1/(Theta*K) */
    const double t23 = JLT_FMS(p[22], t21, x[2]); /* 2*m*R*a3*I3/I1*omega3*s*Theta*1/(Theta*K) - omega_n */
    const double t24 = JLT_FMA(p[23], t22, t23); /* 2*m*R*a3*gamma3*omega_n*Theta*1/(Theta*K) + 2*m*R*a3*I3/I1*omega3*s*Theta*1/(Theta*K) - omega_n */
    const double t25 = JLT_FMA(t17, t19, t16); /* e*(omega_n - 2*m*a3*Theta*1/(Theta*K)*v_tau) + a3/R*v_tau */
    const double t26 = JLT_FNMA(p[21], t24, t25); /* e*(omega_n - 2*m*a3*Theta*1/(Theta*K)*v_tau) + a3/R*v_tau - I1/(m*R)*t24 */
    const double t27 = p[16]*t12; /* m*R*omega_n*Theta*1/(Theta*K) */
    const double t28 = t26*t27; /* t26*m*R*omega_n*Theta*1/(Theta*K) */
    const double t29 = x[1]*p[26]; /* omega_tau*2*R */
    const double t30 = JLT_FMA(x[1], t29, p[25]); /* omega_tau*omega_tau*2*R + 2*g */
    const double t31 = t20*t30; /* s*Theta*1/(Theta*K)*(omega_tau*omega_tau*2*R + 2*g) */
    const double t32 = t20*p[24]; /* s*Theta*1/(Theta*K)*m^2*R*a3^2 */
    const double t33 = JLT_FMS(t31, t32, t28); /* s*Theta*1/(Theta*K)*(omega_tau*omega_tau*2*R + 2*g)*s*Theta*1/(Theta*K)*m^2*R*a3^2 - t26*m*R*omega_n*Theta*1/(Theta*K) */
    const double t34 = t1*p[27]; /* s*omega_tau*(-2*m*R*a3) */
    const double t35 = t20*t34; /* s*Theta*1/(Theta*K)*s*omega_tau*(-2*m*R*a3) */
    const double t36 = t22*p[28]; /* gamma3*omega_n*Theta*1/(Theta*K)*(-2*I1) */
    const double t37 = JLT_FMA(t3, t12, t18); /* b*omega_n*Theta*1/(Theta*K) + Theta*1/(Theta*K)*v_tau */
    const double t38 = t17*p[30]; /* e*(-m) */
    const double t39 = JLT_FMA(t21, p[29], t36); /* omega3*s*Theta*1/(Theta*K)*(-I3) + gamma3*omega_n*Theta*1/(Theta*K)*(-2*I1) */
    const double t40 = JLT_FMA(t37, t38, t39); /* (b*omega_n*Theta*1/(Theta*K) + Theta*1/(Theta*K)*v_tau)*e*(-m) + t39 */
    const double t41 = t17 + p[31]; /* e + I3/(m*R) */
    const double t42 = p[16]*t41; /* m*R*(e + I3/(m*R)) */
    const double t43 = t12*t42; /* omega_n*Theta*1/(Theta*K)*m*R*(e + I3/(m*R)) */
    const double t44 = x[4]*t43; /* s*omega_n*Theta*1/(Theta*K)*m*R*(e + I3/(m*R)) */
    const double t45 = -t44; /* -s*omega_n*Theta*1/(Theta*K)*m*R*(e + I3/(m*R)) */
    const double t46 = x[3]*t43; /* omega3*omega_n*Theta*1/(Theta*K)*m*R*(e + I3/(m*R)) */
    const double t47 = JLT_FMA(t31, p[32], t46); /* s*Theta*1/(Theta*K)*(omega_tau*omega_tau*2*R + 2*g)*m*a3 + omega3*omega_n*Theta*1/(Theta*K)*m*R*(e + I3/(m*R)) */
    const double t48 = -t47; /* -t47 */
    const double t49 = x[1]*x[2]; /* omega_tau*omega_n */
    const double t50 = t8*t10; /* K*1/(Theta*K) */
    const double t51 = x[4]*t50; /* s*K*1/(Theta*K) */
    const double t52 = x[1]*t51; /* omega_tau*s*K*1/(Theta*K) */
    const double t53 = x[3]*t52; /* omega3*omega_tau*s*K*1/(Theta*K) */
    const double t54 = t41*p[35]; /* (e + I3/(m*R))*2*m*R */
    const double t55 = t53*t54; /* omega3*omega_tau*s*K*1/(Theta*K)*(e + I3/(m*R))*2*m*R */
    const double t56 = t3*p[34]; /* b*m*R*I3^2 */
    const double t57 = t50*t56; /* K*1/(Theta*K)*b*m*R*I3^2 */
    const double t58 = JLT_FMA(p[33], t53, t49); /* m*R*a3*I3*omega3*omega_tau*s*K*1/(Theta*K) + omega_tau*omega_n */
    const double t59 = JLT_FNMA(t55, t57, t58); /* t58 - omega3*omega_tau*s*K*1/(Theta*K)*(e + I3/(m*R))*2*m*R*K*1/(Theta*K)*b*m*R*I3^2 */
    const double t60 = x[2]*x[0]; /* omega_n*gamma3 */
    const double t61 = t42*p[5]; /* m*R*(e + I3/(m*R))*I3 */
    const double t62 = x[3]*t61; /* omega3*m*R*(e + I3/(m*R))*I3 */
    const double t63 = JLT_FMA(t51, t62, t60); /* s*K*1/(Theta*K)*omega3*m*R*(e + I3/(m*R))*I3 + omega_n*gamma3 */
    const double t64 = x[1]*x[0]; /* omega_tau*gamma3 */
    const double t65 = t52*t61; /* omega_tau*s*K*1/(Theta*K)*m*R*(e + I3/(m*R))*I3 */
    const double t66 = x[1]*t62; /* omega_tau*omega3*m*R*(e + I3/(m*R))*I3 */
    const double t67 = t50*t66; /* K*1/(Theta*K)*omega_tau*omega3*m*R*(e + I3/(m*R))*I3 */
    const double t68 = t51*p[36]; /* s*K*1/(Theta*K)*m*R^2*I1*I3 */
    const double t69 = JLT_FNMA(t55, t68, t67); /* K*1/(Theta*K)*omega_tau*omega3*m*R*(e + I3/(m*R))*I3 - omega3*omega_tau*s*K*1/(Theta*K)*(e + I3/(m*R))*2*m*R*s*K*1/(Theta*K)*m*R^2*I1*I3 */
    const double t70 = x[4]*p[37]; /* s*m*R^2*(I1 - I3) */
    const double t71 = t53*t70; /* omega3*omega_tau*s*K*1/(Theta*K)*s*m*R^2*(I1 - I3) */
    const double t72 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t73 = t53*t72; /* omega3*omega_tau*s*K*1/(Theta*K)*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t74 = t51*t73; /* s*K*1/(Theta*K)*t73 */
    const double t75 = t3*p[38]; /* b*2*m^2*R^2*I3 */
    const double t76 = JLT_FNMA(t74, t75, t71); /* omega3*omega_tau*s*K*1/(Theta*K)*s*m*R^2*(I1 - I3) - s*K*1/(Theta*K)*t73*b*2*m^2*R^2*I3 */
    const double t77 = x[4]*p[16]; /* s*m*R */
    const double t78 = t72*t77; /* (gamma3*R*(I1 - I3) - a3*I3)*s*m*R */
    const double t79 = x[3]*t78; /* omega3*(gamma3*R*(I1 - I3) - a3*I3)*s*m*R */
    const double t80 = t51*t79; /* s*K*1/(Theta*K)*omega3*(gamma3*R*(I1 - I3) - a3*I3)*s*m*R */
    const double t81 = t52*t78; /* omega_tau*s*K*1/(Theta*K)*(gamma3*R*(I1 - I3) - a3*I3)*s*m*R */
    const double t82 = p[35]*t73; /* 2*m*R*t73 */
    const double t83 = x[4]*p[39]; /* s*2*m^2*R^3*I1 */
    const double t84 = JLT_FNMA(t74, t83, t82); /* 2*m*R*t73 - s*K*1/(Theta*K)*t73*s*2*m^2*R^3*I1 */
    const double t85 = -t1; /* -s*omega_tau */
    const double t86 = x[4]*x[0]; /* s*gamma3 */
    const double t87 = -t86; /* -s*gamma3 */
    const double t88 = -t64; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = t0;
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t33;
    out[6] = t35;
    out[7] = t40;
    out[8] = t45;
    out[9] = t48;
    out[10] = t59;
    out[11] = t63;
    out[12] = t64;
    out[13] = t65;
    out[14] = t69;
    out[15] = t76;
    out[16] = t80;
    out[17] = 0.0;
    out[18] = t81;
    out[19] = t84;
    out[20] = t85;
    out[21] = t87;
    out[22] = 0.0;
    out[23] = 0.0;
    out[24] = t88;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[1]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[9]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[8], t2, p[7]); /* m*R^2*I1*s*s + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t7 = JLT_FMA(x[0], p[15], p[14]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t8 = JLT_FMA(p[0], t7, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t9 = t6*t8; /* Theta*K */
    const double t10 = 1.0/t9; /* 1/(Theta*K) */
    const double t11 = t6*t10; /* Theta*1/(Theta*K) */
    const double t12 = x[2]*t11; /* omega_n*Theta*1/(Theta*K) */
    const double t13 = x[0]*t12; /* gamma3*omega_n*Theta*1/(Theta*K) */
    const double t14 = p[6]*x[2]; /* (-I1)*omega_n */
    const double t15 = x[4]*x[3]; /* s*omega3 */
    const double t16 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t17 = x[2]*t3; /* omega_n*b */
    const double t18 = JLT_FMA(p[1], t15, t17); /* v_tau = R*s*omega3 + omega_n*b */
    const double t19 = t16*t18; /* e*v_tau */
    const double t20 = JLT_FMA(p[40], t15, t19); /* I3/m*s*omega3 + e*v_tau */
    const double t21 = p[30]*t20; /* (-m)*(I3/m*s*omega3 + e*v_tau) */
    const double t22 = t12*t21; /* omega_n*Theta*1/(Theta*K)*(-m)*(I3/m*s*omega3 + e*v_tau) */
    const double t23 = t0*t11; /* s*omega_tau*Theta*1/(Theta*K) */
    const double t24 = t0*p[41]; /* s*omega_tau*(-m*R*a3) */
    const double t25 = x[4]*t11; /* s*Theta*1/(Theta*K) */
    const double t26 = x[4]*p[42]; /* s*(-m*g*a3) */
    const double t27 = JLT_FMA(t23, t24, t22); /* s*omega_tau*Theta*1/(Theta*K)*s*omega_tau*(-m*R*a3) + omega_n*Theta*1/(Theta*K)*(-m)*(I3/m*s*omega3 + e*v_tau) */
    const double t28 = JLT_FMA(t25, t26, t27); /* s*Theta*1/(Theta*K)*s*(-m*g*a3) + t27 */
    const double t29 = JLT_FMA(t13, t14, t28); /* gamma3*omega_n*Theta*1/(Theta*K)*(-I1)*omega_n + s*Theta*1/(Theta*K)*s*(-m*g*a3) + t27 */
    const double t30 = x[1]*x[0]; /* omega_tau*gamma3 */
    const double t31 = x[2]*t30; /* omega_n*omega_tau*gamma3 */
    const double t32 = t8*t10; /* K*1/(Theta*K) */
    const double t33 = x[3]*t32; /* omega3*K*1/(Theta*K) */
    const double t34 = t0*t33; /* s*omega_tau*omega3*K*1/(Theta*K) */
    const double t35 = t16 + p[31]; /* e + I3/(m*R) */
    const double t36 = p[43]*t35; /* m*R*I3*(e + I3/(m*R)) */
    const double t37 = JLT_FMA(t34, t36, t31); /* s*omega_tau*omega3*K*1/(Theta*K)*m*R*I3*(e + I3/(m*R)) + omega_n*omega_tau*gamma3 */
    const double t38 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t39 = x[4]*t38; /* s*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t40 = p[16]*t39; /* m*R*s*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t41 = t34*t40; /* s*omega_tau*omega3*K*1/(Theta*K)*m*R*s*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t42 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t43 = -t42; /* -s*omega_tau*gamma3 */
    const double t44 = t0*2.0; /* s*omega_tau*2 */
    const double t45 = t12*p[16]; /* omega_n*Theta*1/(Theta*K)*m*R */
    const double t46 = t16*t45; /* e*omega_n*Theta*1/(Theta*K)*m*R */
    const double t47 = JLT_FMA(p[4], t12, t46); /* I1*omega_n*Theta*1/(Theta*K) + e*omega_n*Theta*1/(Theta*K)*m*R */
    const double t48 = x[3]*p[44]; /* omega3*2*R*I3 */
    const double t49 = t19*p[35]; /* e*v_tau*2*m*R */
    const double t50 = JLT_FMS(t11, t49, t18); /* Theta*1/(Theta*K)*e*v_tau*2*m*R - v_tau */
    const double t51 = JLT_FMA(t25, t48, t50); /* s*Theta*1/(Theta*K)*omega3*2*R*I3 + Theta*1/(Theta*K)*e*v_tau*2*m*R - v_tau */
    const double t52 = JLT_FMA(t13, p[45], t51); /* gamma3*omega_n*Theta*1/(Theta*K)*2*R*I1 + t51 */
    const double t53 = t12*p[32]; /* omega_n*Theta*1/(Theta*K)*m*a3 */
    const double t54 = t23*p[46]; /* s*omega_tau*Theta*1/(Theta*K)*2*m^2*R^2*a3^2 */
    const double t55 = t23*t54; /* s*omega_tau*Theta*1/(Theta*K)*s*omega_tau*Theta*1/(Theta*K)*2*m^2*R^2*a3^2 */
    const double t56 = t25*p[47]; /* s*Theta*1/(Theta*K)*2*m^2*R*g*a3^2 */
    const double t57 = JLT_FMA(t25, t56, t55); /* s*Theta*1/(Theta*K)*s*Theta*1/(Theta*K)*2*m^2*R*g*a3^2 + t55 */
    const double t58 = JLT_FNMA(x[2], t47, t57); /* s*Theta*1/(Theta*K)*s*Theta*1/(Theta*K)*2*m^2*R*g*a3^2 + t55 - omega_n*t47 */
    const double t59 = JLT_FMA(t52, t53, t58); /* (gamma3*omega_n*Theta*1/(Theta*K)*2*R*I1 + t51)*omega_n*Theta*1/(Theta*K)*m*a3 + t58 */
    const double t60 = t0*p[27]; /* s*omega_tau*(-2*m*R*a3) */
    const double t61 = t25*t60; /* s*Theta*1/(Theta*K)*s*omega_tau*(-2*m*R*a3) */
    const double t62 = t13*p[28]; /* gamma3*omega_n*Theta*1/(Theta*K)*(-2*I1) */
    const double t63 = t11*t20; /* Theta*1/(Theta*K)*(I3/m*s*omega3 + e*v_tau) */
    const double t64 = t3*t16; /* b*e */
    const double t65 = JLT_FMA(t12, t64, t63); /* omega_n*Theta*1/(Theta*K)*b*e + Theta*1/(Theta*K)*(I3/m*s*omega3 + e*v_tau) */
    const double t66 = JLT_FMA(p[30], t65, t62); /* (-m)*t65 + gamma3*omega_n*Theta*1/(Theta*K)*(-2*I1) */
    const double t67 = t35*t45; /* (e + I3/(m*R))*omega_n*Theta*1/(Theta*K)*m*R */
    const double t68 = x[4]*t67; /* s*(e + I3/(m*R))*omega_n*Theta*1/(Theta*K)*m*R */
    const double t69 = -t68; /* -s*(e + I3/(m*R))*omega_n*Theta*1/(Theta*K)*m*R */
    const double t70 = x[1]*p[23]; /* omega_tau*2*m*R*a3 */
    const double t71 = t23*t70; /* s*omega_tau*Theta*1/(Theta*K)*omega_tau*2*m*R*a3 */
    const double t72 = JLT_FMA(t25, p[48], t71); /* s*Theta*1/(Theta*K)*2*m*g*a3 + s*omega_tau*Theta*1/(Theta*K)*omega_tau*2*m*R*a3 */
    const double t73 = JLT_FMA(x[3], t67, t72); /* omega3*(e + I3/(m*R))*omega_n*Theta*1/(Theta*K)*m*R + t72 */
    const double t74 = -t73; /* -(omega3*(e + I3/(m*R))*omega_n*Theta*1/(Theta*K)*m*R + t72) */
    const double t75 = x[1]*x[2]; /* omega_tau*omega_n */
    const double t76 = t35*p[35]; /* (e + I3/(m*R))*2*m*R */
    const double t77 = t32*t34; /* K*1/(Theta*K)*s*omega_tau*omega3*K*1/(Theta*K) */
    const double t78 = t3*t77; /* b*K*1/(Theta*K)*s*omega_tau*omega3*K*1/(Theta*K) */
    const double t79 = p[34]*t76; /* m*R*I3^2*(e + I3/(m*R))*2*m*R */
    const double t80 = JLT_FMA(t34, p[33], t75); /* s*omega_tau*omega3*K*1/(Theta*K)*m*R*a3*I3 + omega_tau*omega_n */
    const double t81 = JLT_FNMA(t78, t79, t80); /* t80 - b*K*1/(Theta*K)*s*omega_tau*omega3*K*1/(Theta*K)*m*R*I3^2*(e + I3/(m*R))*2*m*R */
    const double t82 = x[2]*x[0]; /* omega_n*gamma3 */
    const double t83 = x[4]*t33; /* s*omega3*K*1/(Theta*K) */
    const double t84 = JLT_FMA(t36, t83, t82); /* m*R*I3*(e + I3/(m*R))*s*omega3*K*1/(Theta*K) + omega_n*gamma3 */
    const double t85 = t0*t32; /* s*omega_tau*K*1/(Theta*K) */
    const double t86 = t36*t85; /* m*R*I3*(e + I3/(m*R))*s*omega_tau*K*1/(Theta*K) */
    const double t87 = x[1]*t36; /* omega_tau*m*R*I3*(e + I3/(m*R)) */
    const double t88 = t33*t87; /* omega3*K*1/(Theta*K)*omega_tau*m*R*I3*(e + I3/(m*R)) */
    const double t89 = x[4]*t77; /* s*K*1/(Theta*K)*s*omega_tau*omega3*K*1/(Theta*K) */
    const double t90 = t76*p[36]; /* (e + I3/(m*R))*2*m*R*m*R^2*I1*I3 */
    const double t91 = JLT_FNMA(t89, t90, t88); /* omega3*K*1/(Theta*K)*omega_tau*m*R*I3*(e + I3/(m*R)) - s*K*1/(Theta*K)*s*omega_tau*omega3*K*1/(Theta*K)*(e + I3/(m*R))*2*m*R*m*R^2*I1*I3 */
    const double t92 = x[4]*p[37]; /* s*m*R^2*(I1 - I3) */
    const double t93 = t34*t92; /* s*omega_tau*omega3*K*1/(Theta*K)*s*m*R^2*(I1 - I3) */
    const double t94 = t39*p[38]; /* s*(gamma3*R*(I1 - I3) - a3*I3)*2*m^2*R^2*I3 */
    const double t95 = JLT_FNMA(t78, t94, t93); /* s*omega_tau*omega3*K*1/(Theta*K)*s*m*R^2*(I1 - I3) - b*K*1/(Theta*K)*s*omega_tau*omega3*K*1/(Theta*K)*s*(gamma3*R*(I1 - I3) - a3*I3)*2*m^2*R^2*I3 */
    const double t96 = t40*t83; /* m*R*s*(gamma3*R*(I1 - I3) - a3*I3)*s*omega3*K*1/(Theta*K) */
    const double t97 = t40*t85; /* m*R*s*(gamma3*R*(I1 - I3) - a3*I3)*s*omega_tau*K*1/(Theta*K) */
    const double t98 = t38*p[35]; /* (gamma3*R*(I1 - I3) - a3*I3)*2*m*R */
    const double t99 = t34*t98; /* s*omega_tau*omega3*K*1/(Theta*K)*(gamma3*R*(I1 - I3) - a3*I3)*2*m*R */
    const double t100 = t39*p[39]; /* s*(gamma3*R*(I1 - I3) - a3*I3)*2*m^2*R^3*I1 */
    const double t101 = JLT_FNMA(t89, t100, t99); /* t99 - s*K*1/(Theta*K)*s*omega_tau*omega3*K*1/(Theta*K)*s*(gamma3*R*(I1 - I3) - a3*I3)*2*m^2*R^3*I1 */
    const double t102 = -t0; /* -s*omega_tau */
    const double t103 = x[4]*x[0]; /* s*gamma3 */
    const double t104 = -t103; /* -s*gamma3 */
    const double t105 = -t30; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t29;
    out[2] = t37;
    out[3] = t41;
    out[4] = t43;
    out[5] = 0.0;
    out[6] = t2;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t44;
    out[10] = t59;
    out[11] = t61;
    out[12] = t66;
    out[13] = t69;
    out[14] = t74;
    out[15] = t81;
    out[16] = t84;
    out[17] = t30;
    out[18] = t86;
    out[19] = t91;
    out[20] = t95;
    out[21] = t96;
    out[22] = 0.0;
    out[23] = t97;
    out[24] = t101;
    out[25] = t102;
    out[26] = t104;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t105;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = p[9]*t1; /* m*I3*b */
    const double t3 = JLT_FMA(p[8], t0, p[7]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t1, t2, t3); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(x[0], p[15], p[14]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t6 = JLT_FMA(p[0], t5, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t7 = t4*t6; /* Theta*K */
    const double t8 = 1.0/t7; /* 1/(Theta*K) */
    const double t9 = p[50]*t4; /* 2*a3*Theta */
    const double t10 = t8*t9; /* 1/(Theta*K)*2*a3*Theta */
    const double t11 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t12 = t6*t11; /* K*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t13 = JLT_FNMA(t8, t12, t10); /* 1/(Theta*K)*2*a3*Theta - 1/(Theta*K)*K*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t14 = p[49]*x[1]; /* (-m*R)*omega_tau */
    const double t15 = t0*t14; /* s*s*(-m*R)*omega_tau */
    const double t16 = t13*t15; /* t13*s*s*(-m*R)*omega_tau */
    out[0] = t16;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[51]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t2 = t1*t1; /* e*e */
    const double t3 = x[4]*x[4]; /* s*s */
    const double t4 = JLT_FMA(p[53], t3, t2); /* a3^2*s*s + e*e */
    const double t5 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t6 = t4*t5; /* (a3^2*s*s + e*e)*omega_tau*omega_tau */
    const double t7 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t8 = x[2]*t7; /* omega_n*b */
    const double t9 = p[1]*x[3]; /* R*omega3 */
    const double t10 = JLT_FMA(x[4], t9, t8); /* v_tau = s*R*omega3 + omega_n*b */
    const double t11 = JLT_FMA(t10, t10, t6); /* v_tau*v_tau + (a3^2*s*s + e*e)*omega_tau*omega_tau */
    const double t12 = JLT_FMA(x[2], x[2], t5); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t13 = x[3]*p[55]; /* omega3*1/2*I3 */
    const double t14 = JLT_FMA(x[3], t13, t0); /* omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t15 = JLT_FMA(p[54], t12, t14); /* 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) + omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(p[52], t11, t15); /* 1/2*m*(v_tau*v_tau + (a3^2*s*s + e*e)*omega_tau*omega_tau) + t15 */
    const double t17 = x[2]*p[56]; /* omega_n*R*I1 */
    const double t18 = x[4]*t17; /* s*omega_n*R*I1 */
    const double t19 = x[3]*p[5]; /* omega3*I3 */
    const double t20 = JLT_FNMA(t7, t19, t18); /* s*omega_n*R*I1 - b*omega3*I3 */
    const double t21 = t7*p[9]; /* b*m*I3 */
    const double t22 = JLT_FMA(t3, p[8], p[7]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t23 = JLT_FMA(t7, t21, t22); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t24 = sqrt(t23); /* h = sqrt(Theta) */
    const double t25 = x[3]*t24; /* omega3*h */
    out[0] = t16;
    out[1] = t20;
    out[2] = t25;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t1 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t2 = p[3]*t1; /* a3*omega_tau*omega_tau */
    const double t3 = t0*t2; /* e*a3*omega_tau*omega_tau */
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = x[2]*t4; /* omega_n*b */
    const double t6 = p[1]*x[3]; /* R*omega3 */
    const double t7 = JLT_FMA(x[4], t6, t5); /* v_tau = s*R*omega3 + omega_n*b */
    const double t8 = p[1]*x[2]; /* R*omega_n */
    const double t9 = JLT_FMA(t7, t8, t3); /* v_tau*R*omega_n + e*a3*omega_tau*omega_tau */
    const double t10 = JLT_FMA(p[0], t9, p[51]); /* m*(v_tau*R*omega_n + e*a3*omega_tau*omega_tau) + m*g*a3 */
    const double t11 = t0*t0; /* e*e */
    const double t12 = x[4]*p[53]; /* s*a3^2 */
    const double t13 = JLT_FMA(x[4], t12, t11); /* s*s*a3^2 + e*e */
    const double t14 = p[0]*x[1]; /* m*omega_tau */
    const double t15 = t13*t14; /* (s*s*a3^2 + e*e)*m*omega_tau */
    const double t16 = JLT_FMA(x[1], p[4], t15); /* omega_tau*I1 + (s*s*a3^2 + e*e)*m*omega_tau */
    const double t17 = p[0]*t4; /* m*b */
    const double t18 = t7*t17; /* v_tau*m*b */
    const double t19 = JLT_FMA(x[2], p[4], t18); /* omega_n*I1 + v_tau*m*b */
    const double t20 = x[4]*p[16]; /* s*m*R */
    const double t21 = t7*t20; /* v_tau*s*m*R */
    const double t22 = JLT_FMA(x[3], p[5], t21); /* omega3*I3 + v_tau*s*m*R */
    const double t23 = t1*t12; /* omega_tau*omega_tau*s*a3^2 */
    const double t24 = JLT_FMA(t6, t7, t23); /* R*omega3*v_tau + omega_tau*omega_tau*s*a3^2 */
    const double t25 = p[0]*t24; /* m*(R*omega3*v_tau + omega_tau*omega_tau*s*a3^2) */
    const double t26 = x[3]*p[57]; /* omega3*(-R*I3) */
    const double t27 = x[4]*p[56]; /* s*R*I1 */
    const double t28 = t4*p[29]; /* b*(-I3) */
    const double t29 = x[2]*p[56]; /* omega_n*R*I1 */
    const double t30 = x[4]*p[8]; /* s*m*R^2*I1 */
    const double t31 = t4*p[9]; /* b*m*I3 */
    const double t32 = JLT_FMA(x[4], t30, p[7]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t33 = JLT_FMA(t4, t31, t32); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t34 = sqrt(t33); /* h = sqrt(Theta) */
    const double t35 = 1.0/t34; /* 1/h */
    const double t36 = x[3]*t35; /* omega3*1/h */
    const double t37 = t4*p[43]; /* b*m*R*I3 */
    const double t38 = t36*t37; /* omega3*1/h*b*m*R*I3 */
    const double t39 = t30*t36; /* s*m*R^2*I1*omega3*1/h */
    out[0] = t10;
    out[1] = t16;
    out[2] = t19;
    out[3] = t22;
    out[4] = t25;
    out[5] = t26;
    out[6] = 0.0;
    out[7] = t27;
    out[8] = t28;
    out[9] = t29;
    out[10] = t38;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t34;
    out[14] = t39;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
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
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x1, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t7[k] = jlt_jet_product(x4, x4, k);
        t12[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t13[k] = p[9]*t12[k];
        t14[k] = p[8]*t7[k] + (k == 0 ? p[7] : 0);
        t15[k] = jlt_jet_product(t12, t13, k) + t14[k];
        t17[k] = t7[k]*p[10];
        t21[k] = jlt_jet_product(x4, x3, k);
        t22[k] = jlt_jet_product(x0, x2, k);
        t24[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t25[k] = jlt_jet_product(t12, x2, k);
        t26[k] = p[1]*t21[k] + t25[k];
        t27[k] = p[12]*t24[k];
        t28[k] = p[11]*t21[k] + t22[k];
        t29[k] = jlt_jet_product(t26, t27, k) + t28[k];
        t31[k] = t2[k]*p[13];
        t32[k] = jlt_jet_product(t2, t31, k) + t17[k];
        t33[k] = jlt_jet_product(x2, t29, k) + t32[k];
        t38[k] = x0[k]*p[15] + (k == 0 ? p[14] : 0);
        t39[k] = p[0]*t38[k] + (k == 0 ? p[4] : 0);
        t40[k] = jlt_jet_product(t15, t39, k);
        t42[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t40, t42, k);
        t43[k] = p[6]*t15[k];
        t44[k] = jlt_jet_product(t33, t43, k);
        t45[k] = jlt_jet_product(t42, t44, k);
        t48[k] = t24[k]*p[16] + (k == 0 ? p[5] : 0);
        t49[k] = jlt_jet_product(t21, t39, k);
        t50[k] = jlt_jet_product(t42, t49, k);
        t51[k] = p[5]*t48[k];
        t52[k] = jlt_jet_product(t50, t51, k) + t22[k];
        t53[k] = jlt_jet_product(x1, t52, k);
        t56[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t57[k] = t2[k]*p[16];
        t58[k] = jlt_jet_product(t56, t57, k);
        t59[k] = jlt_jet_product(t50, t58, k);
        t60[k] = jlt_jet_product(t2, x0, k);
        t61[k] = -t60[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t45[k]/(k + 1);
        next[2] = x2[k + 1] = t53[k]/(k + 1);
        next[3] = x3[k + 1] = t59[k]/(k + 1);
        next[4] = x4[k + 1] = t61[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[1];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double v_I1 = params[4];
    const double complex v_gamma3 = x[0];
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
    out[1] = (v_s)*((-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_K))
        + (-v_I3*v_omega_n*v_omega3/v_K)
        + (-v_m*v_omega_n*v_e*v_v_tau/(v_s*v_K))
        + (-v_m*v_R*v_a3*v_omega_tau*v_omega_tau*v_s/v_K)
        + (-v_m*v_g*v_a3*v_s/v_K));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    out[2] = (v_s)*((v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta)
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta));
    out[3] = (v_s)*((v_m*v_R*v_omega_tau*v_omega3*v_s*(v_R*v_gamma3*(v_I1 - v_I3) - v_a3*v_I3)/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
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
    { "Jellett", "" },
    { "Routh", "" },
};

const jlt_descriptor jlt_kernels_routh_sphere_general_in_regular = {
    .model = "routh_sphere",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Sphere with displaced centre of mass rolling without slipping, reduced system",
    .source = "E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243",
    .sha256 = "7ea5d7e192247bbb71a43cf42803dc35e835526f39f8f2b9ef8220743e084b9e",
    .generator = "ttc 0.1.0",
    .table = jlt_table_routh_sphere,
    .state_count = 5, .param_count = 6, .block_count = 58,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 1, 22, 14, 1, 0, 0, 8, 10 }, { 18, 64, 0, 8, 0, 0, 12, 8 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes" },
    .jacobian = { jacobian, 25, { 6, 57, 25, 1, 0, 0, 13, 14 }, { 50, 259, 0, 36, 0, 0, 16, 8 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 7, 68, 30, 1, 0, 0, 12, 25 }, { 60, 303, 0, 44, 0, 0, 16, 10 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes" },
    .divergence = { divergence, 1, { 0, 9, 7, 1, 0, 0, 8, 6 }, { 9, 30, 0, 2, 0, 0, 9, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_values = { integral_values, 3, { 0, 13, 12, 0, 1, 0, 6, 8 }, { 12, 41, 0, 0, 1, 0, 12, 6 },
        "takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 15, { 0, 26, 12, 1, 1, 0, 7, 8 }, { 14, 60, 0, 2, 1, 0, 8, 8 },
        "divides by h: grows without bound, and so do rounding errors, where it vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
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
        &jlt_batch_routh_sphere_general_in_regular_baseline,
        &jlt_batch_routh_sphere_general_in_regular_avx2,
        &jlt_batch_routh_sphere_general_in_regular_avx512,
    },
};
