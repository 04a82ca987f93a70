/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   31   18    1    1    2     13   15   (116)
 *  jacobian            15   67   36    1    1    2     17   22   (415)
 *  rhs_jacobian        18   79   41    1    1    2     16   39   (500)
 *  divergence          2   16    9    1    1    0     14    8   (54)
 *  integral_values     2   12    9    0    1    0      6    9   (43)
 *  integral_gradients  2   17    9    1    1    0      7   11   (53)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_track[];
extern const jlt_descriptor jlt_kernels_spherical_top_track_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_avx512;

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
    const double t2 = params[4]*params[5]; /* I1*I3 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[4]*t4; /* I1*m*R*R */
    const double t6 = params[0]*params[5]; /* m*I3 */
    const double t7 = -params[4]; /* -I1 */
    const double t8 = params[0]*params[2]; /* m*g */
    const double t9 = params[3]*t8; /* a3*m*g */
    const double t10 = t9/params[4]; /* a3*m*g/I1 */
    const double t11 = t1/params[4]; /* m*a3*a3/I1 */
    const double t12 = params[5]/params[4]; /* I3/I1 */
    const double t13 = params[5]*params[5]; /* I3*I3 */
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = params[5]*t14; /* I3*m*R */
    const double t16 = -t14; /* -m*R */
    const double t17 = params[4]*t14; /* I1*m*R */
    const double t18 = -t17; /* -I1*m*R */
    const double t19 = params[3]*params[5]; /* a3*I3 */
    const double t20 = params[4] - params[5]; /* I1 - I3 */
    const double t21 = params[1]*t20; /* R*(I1 - I3) */
    const double t22 = params[0]*2.0; /* m*2 */
    const double t23 = t0*t22; /* a3*a3*m*2 */
    const double t24 = params[5]*t23; /* I3*a3*a3*m*2 */
    const double t25 = t24/params[4]; /* I3*a3*a3*m*2/I1 */
    const double t26 = params[4]*2.0; /* I1*2 */
    const double t27 = t3*t22; /* R*R*m*2 */
    const double t28 = params[4]*t27; /* I1*R*R*m*2 */
    const double t29 = params[1]*t22; /* R*m*2 */
    const double t30 = params[5]*t29; /* I3*R*m*2 */
    const double t31 = params[3]*t14; /* a3*m*R */
    const double t32 = params[5]*t31; /* I3*a3*m*R */
    const double t33 = t4*t20; /* m*R*R*(I1 - I3) */
    const double t34 = -params[5]; /* -I3 */
    const double t35 = params[0]*params[3]; /* m*a3 */
    const double t36 = params[5]*t35; /* I3*m*a3 */
    const double t37 = params[4]*t31; /* I1*a3*m*R */
    const double t38 = t0*2.0; /* a3*a3*2 */
    const double t39 = t3*t20; /* R*R*(I1 - I3) */
    const double t40 = params[3]*params[1]; /* a3*R */
    const double t41 = params[5]*t40; /* I3*a3*R */
    const double t42 = params[0]/2.0; /* m/2 */
    const double t43 = params[4]/2.0; /* I1/2 */
    const double t44 = params[5]/2.0; /* I3/2 */
    const double t45 = params[4]*params[1]; /* I1*R */
    const double t46 = -t45; /* -I1*R */
    const double t47 = params[5]*params[1]; /* I3*R */
    const double t48 = -t47; /* -I3*R */
    out[6] = t1;
    out[7] = t2;
    out[8] = t5;
    out[9] = t6;
    out[10] = t7;
    out[11] = t10;
    out[12] = t11;
    out[13] = t12;
    out[14] = t13;
    out[15] = t15;
    out[16] = t18;
    out[17] = t16;
    out[18] = t19;
    out[19] = t21;
    out[20] = t23;
    out[21] = t25;
    out[22] = t26;
    out[23] = t28;
    out[24] = t30;
    out[25] = t32;
    out[26] = t14;
    out[27] = t17;
    out[28] = t33;
    out[29] = t9;
    out[30] = t34;
    out[31] = t36;
    out[32] = t37;
    out[33] = t38;
    out[34] = t39;
    out[35] = t41;
    out[36] = t42;
    out[37] = t43;
    out[38] = t44;
    out[39] = t45;
    out[40] = t46;
    out[41] = t48;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[6], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t7 = t5*p[9]; /* b*m*I3 */
    const double t8 = JLT_FMA(t2, p[8], p[7]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(t5, t7, t8); /* Theta = b*b*m*I3 + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t10 = t6*t9; /* D*Theta */
    const double t11 = t3*t10; /* s*D*Theta */
    const double t12 = 1.0/t11; /* 1/(s*D*Theta) */
    const double t13 = t9*t12; /* Theta*1/(s*D*Theta) */
    const double t14 = x[3]*t6; /* omega_n*D */
    const double t15 = t13*t14; /* Theta*1/(s*D*Theta)*omega_n*D */
    const double t16 = p[1]*x[4]; /* R*omega3 */
    const double t17 = JLT_FMA(t5, t15, t16); /* b*Theta*1/(s*D*Theta)*omega_n*D + R*omega3 */
    const double t18 = x[3]*t17; /* omega_n*(b*Theta*1/(s*D*Theta)*omega_n*D + R*omega3) */
    const double t19 = t3*p[11]; /* s*m*g*a3/I1 */
    const double t20 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t21 = p[12]*t20; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t22 = x[0]*t15; /* gamma3*Theta*1/(s*D*Theta)*omega_n*D */
    const double t23 = JLT_FMA(x[4], p[13], t22); /* omega3*I3/I1 + gamma3*Theta*1/(s*D*Theta)*omega_n*D */
    const double t24 = JLT_FNMA(t4, t21, t19); /* s*m*g*a3/I1 - omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t25 = JLT_FMA(x[3], t23, t24); /* omega_n*(omega3*I3/I1 + gamma3*Theta*1/(s*D*Theta)*omega_n*D) + s*m*g*a3/I1 - omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t26 = t3*p[10]; /* s*(-I1) */
    const double t27 = t13*t26; /* Theta*1/(s*D*Theta)*s*(-I1) */
    const double t28 = t25*t27; /* t25*Theta*1/(s*D*Theta)*s*(-I1) */
    const double t29 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t30 = JLT_FMA(x[2], t29, x[1]); /* V = omega_tau*e + v_nu */
    const double t31 = t3*t6; /* s*D */
    const double t32 = t12*t31; /* 1/(s*D*Theta)*s*D */
    const double t33 = t30*t32; /* V*1/(s*D*Theta)*s*D */
    const double t34 = JLT_FNMA(t7, t33, t20); /* omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D */
    const double t35 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t36 = t32*t35; /* 1/(s*D*Theta)*s*D*omega_tau*omega3 */
    const double t37 = p[14]*t36; /* I3^2*1/(s*D*Theta)*s*D*omega_tau*omega3 */
    const double t38 = t29*p[15]; /* e*m*R*I3 */
    const double t39 = JLT_FMA(t36, t38, t37); /* 1/(s*D*Theta)*s*D*omega_tau*omega3*e*m*R*I3 + I3^2*1/(s*D*Theta)*s*D*omega_tau*omega3 */
    const double t40 = JLT_FMA(t15, t34, t39); /* Theta*1/(s*D*Theta)*omega_n*D*(omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D) + t39 */
    const double t41 = x[3]*p[16]; /* omega_n*(-m*R*I1) */
    const double t42 = t33*t41; /* V*1/(s*D*Theta)*s*D*omega_n*(-m*R*I1) */
    const double t43 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t44 = p[17]*t43; /* (-m*R)*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t45 = t3*t44; /* s*(-m*R)*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t46 = JLT_FMA(t36, t45, t42); /* 1/(s*D*Theta)*s*D*omega_tau*omega3*s*(-m*R)*(a3*I3 - gamma3*R*(I1 - I3)) + V*1/(s*D*Theta)*s*D*omega_n*(-m*R*I1) */
    const double t47 = -t15; /* -Theta*1/(s*D*Theta)*omega_n*D */
    const double t48 = x[4] + t22; /* omega3 + gamma3*Theta*1/(s*D*Theta)*omega_n*D */
    const double t49 = cos(x[5]); /* C = cos(chi) */
    const double t50 = x[1]*t49; /* v_nu*C */
    const double t51 = sin(x[5]); /* S = sin(chi) */
    const double t52 = x[3]*t5; /* omega_n*b */
    const double t53 = JLT_FMA(t3, t16, t52); /* v_tau = s*R*omega3 + omega_n*b */
    const double t54 = JLT_FMA(t51, t53, t50); /* S*v_tau + v_nu*C */
    const double t55 = x[1]*t51; /* v_nu*S */
    const double t56 = JLT_FNMA(t49, t53, t55); /* v_nu*S - C*v_tau */
    out[0] = t4;
    out[1] = t18;
    out[2] = t28;
    out[3] = t40;
    out[4] = t46;
    out[5] = t47;
    out[6] = t48;
    out[7] = t54;
    out[8] = t56;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[6], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = t4*p[9]; /* b*m*I3 */
    const double t6 = JLT_FMA(t2, p[8], p[7]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*b*m*I3 + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t8 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = t3*t7; /* D*Theta */
    const double t10 = t8*t9; /* s*D*Theta */
    const double t11 = 1.0/t10; /* 1/(s*D*Theta) */
    const double t12 = t7*t11; /* Theta*1/(s*D*Theta) */
    const double t13 = t3*t12; /* D*Theta*1/(s*D*Theta) */
    const double t14 = x[0]*t13; /* gamma3*D*Theta*1/(s*D*Theta) */
    const double t15 = x[2]*t14; /* omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t16 = -t15; /* -omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t17 = t13*x[3]; /* D*Theta*1/(s*D*Theta)*omega_n */
    const double t18 = p[1]*x[3]; /* R*omega_n */
    const double t19 = t17*t18; /* D*Theta*1/(s*D*Theta)*omega_n*R*omega_n */
    const double t20 = t4*t17; /* b*D*Theta*1/(s*D*Theta)*omega_n */
    const double t21 = t14*t17; /* gamma3*D*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*omega_n */
    const double t22 = JLT_FMA(t20, t21, t19); /* b*D*Theta*1/(s*D*Theta)*omega_n*gamma3*D*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*omega_n + D*Theta*1/(s*D*Theta)*omega_n*R*omega_n */
    const double t23 = p[1]*x[4]; /* R*omega3 */
    const double t24 = JLT_FMA(t20, 2.0, t23); /* b*D*Theta*1/(s*D*Theta)*omega_n*2 + R*omega3 */
    const double t25 = t8*t12; /* s*Theta*1/(s*D*Theta) */
    const double t26 = t8*t25; /* s*s*Theta*1/(s*D*Theta) */
    const double t27 = x[0]*t25; /* gamma3*s*Theta*1/(s*D*Theta) */
    const double t28 = p[20]*t27; /* 2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) */
    const double t29 = t8*t28; /* s*2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) */
    const double t30 = t29 - t14; /* s*2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) - gamma3*D*Theta*1/(s*D*Theta) */
    const double t31 = JLT_FMA(t27, t30, t26); /* gamma3*s*Theta*1/(s*D*Theta)*t30 + s*s*Theta*1/(s*D*Theta) */
    const double t32 = x[2]*p[6]; /* omega_tau*m*a3^2 */
    const double t33 = x[2]*t32; /* omega_tau*omega_tau*m*a3^2 */
    const double t34 = t31*t33; /* (gamma3*s*Theta*1/(s*D*Theta)*t30 + s*s*Theta*1/(s*D*Theta))*omega_tau*omega_tau*m*a3^2 */
    const double t35 = x[4]*p[21]; /* omega3*2*m*a3^2*I3/I1 */
    const double t36 = JLT_FMA(t27, t35, t17); /* gamma3*s*Theta*1/(s*D*Theta)*omega3*2*m*a3^2*I3/I1 + D*Theta*1/(s*D*Theta)*omega_n */
    const double t37 = x[3]*t36; /* omega_n*t36 */
    const double t38 = JLT_FMA(t30, p[11], t37); /* t30*m*g*a3/I1 + omega_n*t36 */
    const double t39 = t25*t38; /* s*Theta*1/(s*D*Theta)*(t30*m*g*a3/I1 + omega_n*t36) */
    const double t40 = JLT_FMA(x[3], t28, t21); /* omega_n*2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) + gamma3*D*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*omega_n */
    const double t41 = t17*t27; /* D*Theta*1/(s*D*Theta)*omega_n*gamma3*s*Theta*1/(s*D*Theta) */
    const double t42 = JLT_FMA(t40, t41, t39); /* t40*D*Theta*1/(s*D*Theta)*omega_n*gamma3*s*Theta*1/(s*D*Theta) + s*Theta*1/(s*D*Theta)*(t30*m*g*a3/I1 + omega_n*t36) */
    const double t43 = JLT_FNMA(p[4], t42, t34); /* t34 - I1*t42 */
    const double t44 = x[2]*t29; /* omega_tau*s*2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) */
    const double t45 = t41*p[22]; /* D*Theta*1/(s*D*Theta)*omega_n*gamma3*s*Theta*1/(s*D*Theta)*2*I1 */
    const double t46 = t25*p[5]; /* s*Theta*1/(s*D*Theta)*I3 */
    const double t47 = JLT_FMA(x[4], t46, t45); /* omega3*s*Theta*1/(s*D*Theta)*I3 + t45 */
    const double t48 = -t47; /* -(omega3*s*Theta*1/(s*D*Theta)*I3 + t45) */
    const double t49 = x[3]*t46; /* omega_n*s*Theta*1/(s*D*Theta)*I3 */
    const double t50 = -t49; /* -omega_n*s*Theta*1/(s*D*Theta)*I3 */
    const double t51 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t52 = JLT_FMA(x[2], t51, x[1]); /* V = omega_tau*e + v_nu */
    const double t53 = t3*t8; /* D*s */
    const double t54 = t11*t53; /* 1/(s*D*Theta)*D*s */
    const double t55 = t52*t54; /* V*1/(s*D*Theta)*D*s */
    const double t56 = JLT_FNMA(p[15], t55, x[2]); /* omega_tau - m*R*I3*V*1/(s*D*Theta)*D*s */
    const double t57 = t17*t56; /* D*Theta*1/(s*D*Theta)*omega_n*(omega_tau - m*R*I3*V*1/(s*D*Theta)*D*s) */
    const double t58 = t5*t55; /* b*m*I3*V*1/(s*D*Theta)*D*s */
    const double t59 = JLT_FNMA(t13, t58, t15); /* omega_tau*gamma3*D*Theta*1/(s*D*Theta) - D*Theta*1/(s*D*Theta)*b*m*I3*V*1/(s*D*Theta)*D*s */
    const double t60 = x[2]*p[3]; /* omega_tau*a3 */
    const double t61 = x[0]*p[23]; /* gamma3*2*m*R^2*I1 */
    const double t62 = JLT_FMS(t4, p[24], t61); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t63 = JLT_FNMA(t55, t62, t60); /* omega_tau*a3 - V*1/(s*D*Theta)*D*s*d(Theta)/d(gamma3) */
    const double t64 = p[9]*t54; /* m*I3*1/(s*D*Theta)*D*s */
    const double t65 = t20*t64; /* b*D*Theta*1/(s*D*Theta)*omega_n*m*I3*1/(s*D*Theta)*D*s */
    const double t66 = x[2]*t54; /* omega_tau*1/(s*D*Theta)*D*s */
    const double t67 = x[4]*t66; /* omega3*omega_tau*1/(s*D*Theta)*D*s */
    const double t68 = JLT_FMA(t51, p[26], p[5]); /* e*m*R + I3 */
    const double t69 = p[5]*t68; /* I3*(e*m*R + I3) */
    const double t70 = t54*t69; /* 1/(s*D*Theta)*D*s*I3*(e*m*R + I3) */
    const double t71 = JLT_FNMA(t62, t70, p[25]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*1/(s*D*Theta)*D*s*I3*(e*m*R + I3) */
    const double t72 = JLT_FMA(t67, t71, t57); /* omega3*omega_tau*1/(s*D*Theta)*D*s*t71 + t57 */
    const double t73 = JLT_FMA(t21, t59, t72); /* gamma3*D*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*omega_n*t59 + omega3*omega_tau*1/(s*D*Theta)*D*s*t71 + t57 */
    const double t74 = JLT_FNMA(t63, t65, t73); /* t73 - (omega_tau*a3 - V*1/(s*D*Theta)*D*s*d(Theta)/d(gamma3))*b*D*Theta*1/(s*D*Theta)*omega_n*m*I3*1/(s*D*Theta)*D*s */
    const double t75 = -t65; /* -b*D*Theta*1/(s*D*Theta)*omega_n*m*I3*1/(s*D*Theta)*D*s */
    const double t76 = x[0]*t17; /* gamma3*D*Theta*1/(s*D*Theta)*omega_n */
    const double t77 = JLT_FMA(x[4], t70, t76); /* omega3*1/(s*D*Theta)*D*s*I3*(e*m*R + I3) + gamma3*D*Theta*1/(s*D*Theta)*omega_n */
    const double t78 = JLT_FNMA(t51, t65, t77); /* t77 - e*b*D*Theta*1/(s*D*Theta)*omega_n*m*I3*1/(s*D*Theta)*D*s */
    const double t79 = t66*t69; /* omega_tau*1/(s*D*Theta)*D*s*I3*(e*m*R + I3) */
    const double t80 = x[3]*p[27]; /* omega_n*m*R*I1 */
    const double t81 = t54*t80; /* 1/(s*D*Theta)*D*s*omega_n*m*R*I1 */
    const double t82 = t63*t81; /* (omega_tau*a3 - V*1/(s*D*Theta)*D*s*d(Theta)/d(gamma3))*1/(s*D*Theta)*D*s*omega_n*m*R*I1 */
    const double t83 = t8*p[28]; /* s*m*R^2*(I1 - I3) */
    const double t84 = t8*t54; /* s*1/(s*D*Theta)*D*s */
    const double t85 = JLT_FMA(t62, t84, t14); /* d(Theta)/d(gamma3)*s*1/(s*D*Theta)*D*s + gamma3*D*Theta*1/(s*D*Theta) */
    const double t86 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t87 = p[26]*t86; /* m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t88 = JLT_FMA(t85, t87, t83); /* t85*m*R*(a3*I3 - gamma3*R*(I1 - I3)) + s*m*R^2*(I1 - I3) */
    const double t89 = JLT_FMS(t67, t88, t82); /* omega3*omega_tau*1/(s*D*Theta)*D*s*(t85*m*R*(a3*I3 - gamma3*R*(I1 - I3)) + s*m*R^2*(I1 - I3)) - t82 */
    const double t90 = -t81; /* -1/(s*D*Theta)*D*s*omega_n*m*R*I1 */
    const double t91 = t51*t81; /* e*1/(s*D*Theta)*D*s*omega_n*m*R*I1 */
    const double t92 = x[4]*t87; /* omega3*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t93 = JLT_FMA(t84, t92, t91); /* s*1/(s*D*Theta)*D*s*omega3*m*R*(a3*I3 - gamma3*R*(I1 - I3)) + e*1/(s*D*Theta)*D*s*omega_n*m*R*I1 */
    const double t94 = -t93; /* -t93 */
    const double t95 = t55*p[16]; /* V*1/(s*D*Theta)*D*s*(-m*R*I1) */
    const double t96 = t8*t87; /* s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t97 = t66*t96; /* omega_tau*1/(s*D*Theta)*D*s*s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t98 = -t97; /* -t97 */
    const double t99 = t13*t21; /* D*Theta*1/(s*D*Theta)*gamma3*D*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*omega_n */
    const double t100 = -t99; /* -t99 */
    const double t101 = -t13; /* -D*Theta*1/(s*D*Theta) */
    const double t102 = JLT_FMA(t14, t21, t17); /* gamma3*D*Theta*1/(s*D*Theta)*gamma3*D*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*omega_n + D*Theta*1/(s*D*Theta)*omega_n */
    const double t103 = sin(x[5]); /* S = sin(chi) */
    const double t104 = JLT_FNMA(t14, t23, t18); /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*D*Theta*1/(s*D*Theta)*R*omega3 */
    const double t105 = t103*t104; /* S*d(v_tau)/d(gamma3) */
    const double t106 = cos(x[5]); /* C = cos(chi) */
    const double t107 = t4*t103; /* b*S */
    const double t108 = p[1]*t8; /* R*s */
    const double t109 = t103*t108; /* S*R*s */
    const double t110 = x[1]*t103; /* v_nu*S */
    const double t111 = t4*x[3]; /* b*omega_n */
    const double t112 = JLT_FMA(x[4], t108, t111); /* v_tau = omega3*R*s + b*omega_n */
    const double t113 = JLT_FMS(t106, t112, t110); /* C*v_tau - v_nu*S */
    const double t114 = t104*t106; /* d(v_tau)/d(gamma3)*C */
    const double t115 = -t114; /* -d(v_tau)/d(gamma3)*C */
    const double t116 = t4*t106; /* b*C */
    const double t117 = -t116; /* -b*C */
    const double t118 = t106*t108; /* C*R*s */
    const double t119 = -t118; /* -C*R*s */
    const double t120 = x[1]*t106; /* v_nu*C */
    const double t121 = JLT_FMA(t103, t112, t120); /* S*v_tau + v_nu*C */
    out[0] = t16;
    out[1] = 0.0;
    out[2] = t8;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t22;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t24;
    out[13] = t18;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t43;
    out[19] = 0.0;
    out[20] = t44;
    out[21] = t48;
    out[22] = t50;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t74;
    out[28] = t75;
    out[29] = t78;
    out[30] = t59;
    out[31] = t79;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t89;
    out[37] = t90;
    out[38] = t94;
    out[39] = t95;
    out[40] = t98;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t100;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = t101;
    out[49] = 0.0;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[54] = t102;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t14;
    out[58] = 1.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = t105;
    out[64] = t106;
    out[65] = 0.0;
    out[66] = t107;
    out[67] = t109;
    out[68] = t113;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t115;
    out[73] = t103;
    out[74] = 0.0;
    out[75] = t117;
    out[76] = t119;
    out[77] = t121;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[6], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t7 = t5*p[9]; /* b*m*I3 */
    const double t8 = JLT_FMA(t2, p[8], p[7]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(t5, t7, t8); /* Theta = b*b*m*I3 + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t10 = t6*t9; /* D*Theta */
    const double t11 = t3*t10; /* s*D*Theta */
    const double t12 = 1.0/t11; /* 1/(s*D*Theta) */
    const double t13 = t9*t12; /* Theta*1/(s*D*Theta) */
    const double t14 = t6*t13; /* D*Theta*1/(s*D*Theta) */
    const double t15 = x[3]*t14; /* omega_n*D*Theta*1/(s*D*Theta) */
    const double t16 = t5*t15; /* b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t17 = x[3]*t16; /* omega_n*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t18 = x[3]*p[1]; /* omega_n*R */
    const double t19 = JLT_FMA(x[4], t18, t17); /* omega3*omega_n*R + omega_n*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t20 = t3*t13; /* s*Theta*1/(s*D*Theta) */
    const double t21 = x[0]*t20; /* gamma3*s*Theta*1/(s*D*Theta) */
    const double t22 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t23 = t4*t22; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t24 = JLT_FNMA(x[3], t15, t23); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n*D*Theta*1/(s*D*Theta) */
    const double t25 = p[4]*t24; /* I1*t24 */
    const double t26 = t21*t25; /* gamma3*s*Theta*1/(s*D*Theta)*I1*t24 */
    const double t27 = t3*t20; /* s*s*Theta*1/(s*D*Theta) */
    const double t28 = x[4]*p[5]; /* omega3*I3 */
    const double t29 = x[3]*t20; /* omega_n*s*Theta*1/(s*D*Theta) */
    const double t30 = JLT_FNMA(p[29], t27, t26); /* gamma3*s*Theta*1/(s*D*Theta)*I1*t24 - m*g*a3*s*s*Theta*1/(s*D*Theta) */
    const double t31 = JLT_FNMA(t28, t29, t30); /* t30 - omega3*I3*omega_n*s*Theta*1/(s*D*Theta) */
    const double t32 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t33 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t34 = JLT_FMA(x[2], t33, x[1]); /* V = omega_tau*e + v_nu */
    const double t35 = t3*t6; /* s*D */
    const double t36 = t12*t35; /* 1/(s*D*Theta)*s*D */
    const double t37 = t34*t36; /* V*1/(s*D*Theta)*s*D */
    const double t38 = JLT_FNMA(t7, t37, t32); /* omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D */
    const double t39 = JLT_FMA(t33, p[26], p[5]); /* e*m*R + I3 */
    const double t40 = x[2]*t36; /* omega_tau*1/(s*D*Theta)*s*D */
    const double t41 = t39*t40; /* (e*m*R + I3)*omega_tau*1/(s*D*Theta)*s*D */
    const double t42 = t28*t41; /* omega3*I3*(e*m*R + I3)*omega_tau*1/(s*D*Theta)*s*D */
    const double t43 = JLT_FMA(t15, t38, t42); /* omega_n*D*Theta*1/(s*D*Theta)*(omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D) + omega3*I3*(e*m*R + I3)*omega_tau*1/(s*D*Theta)*s*D */
    const double t44 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t45 = x[4]*t40; /* omega3*omega_tau*1/(s*D*Theta)*s*D */
    const double t46 = t3*t45; /* s*omega3*omega_tau*1/(s*D*Theta)*s*D */
    const double t47 = t44*t46; /* (a3*I3 - gamma3*R*(I1 - I3))*s*omega3*omega_tau*1/(s*D*Theta)*s*D */
    const double t48 = x[3]*p[4]; /* omega_n*I1 */
    const double t49 = JLT_FMA(t37, t48, t47); /* V*1/(s*D*Theta)*s*D*omega_n*I1 + t47 */
    const double t50 = p[26]*t49; /* m*R*(V*1/(s*D*Theta)*s*D*omega_n*I1 + t47) */
    const double t51 = -t50; /* -m*R*(V*1/(s*D*Theta)*s*D*omega_n*I1 + t47) */
    const double t52 = -t15; /* -omega_n*D*Theta*1/(s*D*Theta) */
    const double t53 = x[0]*t15; /* gamma3*omega_n*D*Theta*1/(s*D*Theta) */
    const double t54 = x[4] + t53; /* omega3 + gamma3*omega_n*D*Theta*1/(s*D*Theta) */
    const double t55 = cos(x[5]); /* C = cos(chi) */
    const double t56 = x[1]*t55; /* v_nu*C */
    const double t57 = sin(x[5]); /* S = sin(chi) */
    const double t58 = x[3]*t5; /* omega_n*b */
    const double t59 = t3*p[1]; /* s*R */
    const double t60 = JLT_FMA(x[4], t59, t58); /* v_tau = omega3*s*R + omega_n*b */
    const double t61 = JLT_FMA(t57, t60, t56); /* S*v_tau + v_nu*C */
    const double t62 = x[1]*t57; /* v_nu*S */
    const double t63 = t55*t60; /* C*v_tau */
    const double t64 = t62 - t63; /* v_nu*S - C*v_tau */
    const double t65 = x[0]*t14; /* gamma3*D*Theta*1/(s*D*Theta) */
    const double t66 = x[2]*t65; /* omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t67 = -t66; /* -omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t68 = t15*t18; /* omega_n*D*Theta*1/(s*D*Theta)*omega_n*R */
    const double t69 = t15*t65; /* omega_n*D*Theta*1/(s*D*Theta)*gamma3*D*Theta*1/(s*D*Theta) */
    const double t70 = JLT_FMA(t16, t69, t68); /* b*omega_n*D*Theta*1/(s*D*Theta)*omega_n*D*Theta*1/(s*D*Theta)*gamma3*D*Theta*1/(s*D*Theta) + omega_n*D*Theta*1/(s*D*Theta)*omega_n*R */
    const double t71 = p[1]*x[4]; /* R*omega3 */
    const double t72 = JLT_FMA(t16, 2.0, t71); /* b*omega_n*D*Theta*1/(s*D*Theta)*2 + R*omega3 */
    const double t73 = t21*p[20]; /* gamma3*s*Theta*1/(s*D*Theta)*2*m*a3^2 */
    const double t74 = JLT_FMA(t21, t73, t20); /* gamma3*s*Theta*1/(s*D*Theta)*gamma3*s*Theta*1/(s*D*Theta)*2*m*a3^2 + s*Theta*1/(s*D*Theta) */
    const double t75 = t25*t74; /* I1*t24*t74 */
    const double t76 = JLT_FMS(t27, p[20], t14); /* s*s*Theta*1/(s*D*Theta)*2*m*a3^2 - D*Theta*1/(s*D*Theta) */
    const double t77 = t22*t66; /* omega_tau*m*a3^2/I1*omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t78 = x[4]*p[21]; /* omega3*2*m*a3^2*I3/I1 */
    const double t79 = JLT_FMA(t29, t78, t77); /* omega_n*s*Theta*1/(s*D*Theta)*omega3*2*m*a3^2*I3/I1 + omega_tau*m*a3^2/I1*omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t80 = JLT_FMA(t15, t69, t79); /* omega_n*D*Theta*1/(s*D*Theta)*omega_n*D*Theta*1/(s*D*Theta)*gamma3*D*Theta*1/(s*D*Theta) + t79 */
    const double t81 = JLT_FMA(p[11], t76, t80); /* m*g*a3/I1*(s*s*Theta*1/(s*D*Theta)*2*m*a3^2 - D*Theta*1/(s*D*Theta)) + t80 */
    const double t82 = p[4]*t21; /* I1*gamma3*s*Theta*1/(s*D*Theta) */
    const double t83 = JLT_FNMA(t81, t82, t75); /* I1*t24*t74 - t81*I1*gamma3*s*Theta*1/(s*D*Theta) */
    const double t84 = t4*t73; /* omega_tau*s*gamma3*s*Theta*1/(s*D*Theta)*2*m*a3^2 */
    const double t85 = t15*p[22]; /* omega_n*D*Theta*1/(s*D*Theta)*2*I1 */
    const double t86 = t21*t85; /* gamma3*s*Theta*1/(s*D*Theta)*omega_n*D*Theta*1/(s*D*Theta)*2*I1 */
    const double t87 = JLT_FMA(t20, t28, t86); /* s*Theta*1/(s*D*Theta)*omega3*I3 + t86 */
    const double t88 = -t87; /* -(s*Theta*1/(s*D*Theta)*omega3*I3 + t86) */
    const double t89 = t29*p[30]; /* omega_n*s*Theta*1/(s*D*Theta)*(-I3) */
    const double t90 = JLT_FNMA(t37, p[15], x[2]); /* omega_tau - V*1/(s*D*Theta)*s*D*m*R*I3 */
    const double t91 = t15*t90; /* omega_n*D*Theta*1/(s*D*Theta)*(omega_tau - V*1/(s*D*Theta)*s*D*m*R*I3) */
    const double t92 = t14*t69; /* D*Theta*1/(s*D*Theta)*omega_n*D*Theta*1/(s*D*Theta)*gamma3*D*Theta*1/(s*D*Theta) */
    const double t93 = p[9]*t16; /* m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t94 = JLT_FNMA(t37, t93, t42); /* omega3*I3*(e*m*R + I3)*omega_tau*1/(s*D*Theta)*s*D - V*1/(s*D*Theta)*s*D*m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t95 = x[0]*p[23]; /* gamma3*2*m*R^2*I1 */
    const double t96 = JLT_FMS(t5, p[24], t95); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t97 = t36*t96; /* 1/(s*D*Theta)*s*D*d(Theta)/d(gamma3) */
    const double t98 = t40*p[31]; /* omega_tau*1/(s*D*Theta)*s*D*m*a3*I3 */
    const double t99 = JLT_FMA(t45, p[25], t91); /* omega3*omega_tau*1/(s*D*Theta)*s*D*m*R*a3*I3 + t91 */
    const double t100 = JLT_FNMA(t16, t98, t99); /* omega3*omega_tau*1/(s*D*Theta)*s*D*m*R*a3*I3 + t91 - b*omega_n*D*Theta*1/(s*D*Theta)*omega_tau*1/(s*D*Theta)*s*D*m*a3*I3 */
    const double t101 = JLT_FMA(t38, t92, t100); /* (omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D)*t92 + t100 */
    const double t102 = JLT_FNMA(t94, t97, t101); /* (omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D)*t92 + t100 - t94*1/(s*D*Theta)*s*D*d(Theta)/d(gamma3) */
    const double t103 = t36*t93; /* 1/(s*D*Theta)*s*D*m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t104 = -t103; /* -1/(s*D*Theta)*s*D*m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t105 = t33*t93; /* e*m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t106 = JLT_FNMA(t28, t39, t105); /* e*m*I3*b*omega_n*D*Theta*1/(s*D*Theta) - omega3*I3*(e*m*R + I3) */
    const double t107 = JLT_FNMA(t36, t106, t53); /* gamma3*omega_n*D*Theta*1/(s*D*Theta) - 1/(s*D*Theta)*s*D*t106 */
    const double t108 = t14*t38; /* D*Theta*1/(s*D*Theta)*(omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D) */
    const double t109 = p[5]*t41; /* I3*(e*m*R + I3)*omega_tau*1/(s*D*Theta)*s*D */
    const double t110 = x[3]*p[32]; /* omega_n*m*R*a3*I1 */
    const double t111 = t40*t110; /* omega_tau*1/(s*D*Theta)*s*D*omega_n*m*R*a3*I1 */
    const double t112 = p[26]*t44; /* m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t113 = t65*t112; /* gamma3*D*Theta*1/(s*D*Theta)*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t114 = JLT_FMS(t46, p[28], t111); /* s*omega3*omega_tau*1/(s*D*Theta)*s*D*m*R^2*(I1 - I3) - omega_tau*1/(s*D*Theta)*s*D*omega_n*m*R*a3*I1 */
    const double t115 = JLT_FMA(t45, t113, t114); /* omega3*omega_tau*1/(s*D*Theta)*s*D*t113 + t114 */
    const double t116 = JLT_FMA(t50, t97, t115); /* m*R*(V*1/(s*D*Theta)*s*D*omega_n*I1 + t47)*1/(s*D*Theta)*s*D*d(Theta)/d(gamma3) + omega3*omega_tau*1/(s*D*Theta)*s*D*t113 + t114 */
    const double t117 = x[3]*p[27]; /* omega_n*m*R*I1 */
    const double t118 = t36*t117; /* 1/(s*D*Theta)*s*D*omega_n*m*R*I1 */
    const double t119 = -t118; /* -1/(s*D*Theta)*s*D*omega_n*m*R*I1 */
    const double t120 = t3*t112; /* s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t121 = x[4]*t120; /* omega3*s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t122 = JLT_FMA(t33, t117, t121); /* e*omega_n*m*R*I1 + omega3*s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t123 = t36*t122; /* 1/(s*D*Theta)*s*D*(e*omega_n*m*R*I1 + omega3*s*m*R*(a3*I3 - gamma3*R*(I1 - I3))) */
    const double t124 = -t123; /* -t123 */
    const double t125 = t37*p[16]; /* V*1/(s*D*Theta)*s*D*(-m*R*I1) */
    const double t126 = t40*t120; /* omega_tau*1/(s*D*Theta)*s*D*s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t127 = -t126; /* -t126 */
    const double t128 = -t92; /* -t92 */
    const double t129 = -t14; /* -D*Theta*1/(s*D*Theta) */
    const double t130 = JLT_FMA(t65, t69, t15); /* gamma3*D*Theta*1/(s*D*Theta)*omega_n*D*Theta*1/(s*D*Theta)*gamma3*D*Theta*1/(s*D*Theta) + omega_n*D*Theta*1/(s*D*Theta) */
    const double t131 = JLT_FNMA(t65, t71, t18); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*D*Theta*1/(s*D*Theta)*R*omega3 */
    const double t132 = t57*t131; /* S*d(v_tau)/d(gamma3) */
    const double t133 = t5*t57; /* b*S */
    const double t134 = t57*t59; /* S*s*R */
    const double t135 = t63 - t62; /* C*v_tau - v_nu*S */
    const double t136 = t55*t131; /* C*d(v_tau)/d(gamma3) */
    const double t137 = -t136; /* -C*d(v_tau)/d(gamma3) */
    const double t138 = t5*t55; /* b*C */
    const double t139 = -t138; /* -b*C */
    const double t140 = t55*t59; /* C*s*R */
    const double t141 = -t140; /* -C*s*R */
    out[0] = t4;
    out[1] = t19;
    out[2] = t31;
    out[3] = t43;
    out[4] = t51;
    out[5] = t52;
    out[6] = t54;
    out[7] = t61;
    out[8] = t64;
    out[9] = t67;
    out[10] = 0.0;
    out[11] = t3;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t70;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = t72;
    out[22] = t18;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t83;
    out[28] = 0.0;
    out[29] = t84;
    out[30] = t88;
    out[31] = t89;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t102;
    out[37] = t104;
    out[38] = t107;
    out[39] = t108;
    out[40] = t109;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t116;
    out[46] = t119;
    out[47] = t124;
    out[48] = t125;
    out[49] = t127;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[54] = t128;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t129;
    out[58] = 0.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = t130;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = t65;
    out[67] = 1.0;
    out[68] = 0.0;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t132;
    out[73] = t55;
    out[74] = 0.0;
    out[75] = t133;
    out[76] = t134;
    out[77] = t135;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[81] = t137;
    out[82] = t57;
    out[83] = 0.0;
    out[84] = t139;
    out[85] = t141;
    out[86] = t61;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = 0.0;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = t4*p[9]; /* b*m*I3 */
    const double t6 = JLT_FMA(t2, p[8], p[7]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*b*m*I3 + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t2, p[6], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t9 = t7*t8; /* Theta*D */
    const double t10 = t3*t9; /* s*Theta*D */
    const double t11 = 1.0/t10; /* 1/(s*Theta*D) */
    const double t12 = t7*t11; /* Theta*1/(s*Theta*D) */
    const double t13 = t3*p[33]; /* s*2*a3^2 */
    const double t14 = t12*t13; /* Theta*1/(s*Theta*D)*s*2*a3^2 */
    const double t15 = t3*t8; /* s*D */
    const double t16 = t11*t15; /* 1/(s*Theta*D)*s*D */
    const double t17 = JLT_FMA(p[34], t16, t14); /* R^2*(I1 - I3)*1/(s*Theta*D)*s*D + Theta*1/(s*Theta*D)*s*2*a3^2 */
    const double t18 = x[0]*t17; /* gamma3*t17 */
    const double t19 = JLT_FNMA(t16, p[35], t18); /* gamma3*t17 - 1/(s*Theta*D)*s*D*R*a3*I3 */
    const double t20 = p[0]*x[2]; /* m*omega_tau */
    const double t21 = t3*t20; /* s*m*omega_tau */
    const double t22 = t19*t21; /* (gamma3*t17 - 1/(s*Theta*D)*s*D*R*a3*I3)*s*m*omega_tau */
    const double t23 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t24 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t25 = t5*t8; /* b*m*I3*D */
    const double t26 = t24*t25; /* V*b*m*I3*D */
    const double t27 = t16*t26; /* 1/(s*Theta*D)*s*D*V*b*m*I3*D */
    const double t28 = JLT_FNMA(t12, t27, t22); /* (gamma3*t17 - 1/(s*Theta*D)*s*D*R*a3*I3)*s*m*omega_tau - Theta*1/(s*Theta*D)*1/(s*Theta*D)*s*D*V*b*m*I3*D */
    out[0] = t28;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[29]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = x[0] + 1.0; /* gamma3 + 1 */
    const double t6 = t4*t5; /* (1 - gamma3)*(gamma3 + 1) */
    const double t7 = sqrt(t6); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(t7, t8, t3); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = JLT_FMA(t9, t9, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t11 = JLT_FMA(t6, p[6], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = x[3]*p[37]; /* omega_n*1/2*I1 */
    const double t15 = x[4]*p[38]; /* omega3*1/2*I3 */
    const double t16 = JLT_FMA(x[3], t14, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t17 = JLT_FMA(x[4], t15, t16); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t18 = JLT_FMA(t11, t13, t17); /* D*omega_tau*1/2*omega_tau + t17 */
    const double t19 = JLT_FMA(p[36], t10, t18); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t17 */
    const double t20 = x[3]*p[39]; /* omega_n*R*I1 */
    const double t21 = t7*t20; /* s*omega_n*R*I1 */
    const double t22 = x[4]*p[5]; /* omega3*I3 */
    const double t23 = JLT_FNMA(t2, t22, t21); /* s*omega_n*R*I1 - b*omega3*I3 */
    out[0] = t19;
    out[1] = t23;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[6]*x[0]; /* m*a3^2*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = 1.0/t5; /* 1/s */
    const double t7 = x[0]*t6; /* gamma3*1/s */
    const double t8 = JLT_FMS(x[4], t7, x[3]); /* omega3*gamma3*1/s - omega_n */
    const double t9 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = x[3]*t9; /* omega_n*b */
    const double t11 = p[1]*x[4]; /* R*omega3 */
    const double t12 = JLT_FMA(t5, t11, t10); /* v_tau = s*R*omega3 + omega_n*b */
    const double t13 = p[0]*t12; /* m*v_tau */
    const double t14 = p[1]*t13; /* R*m*v_tau */
    const double t15 = JLT_FNMA(t0, t1, p[29]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t16 = JLT_FNMA(t8, t14, t15); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau - (omega3*gamma3*1/s - omega_n)*R*m*v_tau */
    const double t17 = p[0]*x[1]; /* m*v_nu */
    const double t18 = JLT_FMA(p[6], t4, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t19 = x[2]*t18; /* omega_tau*D */
    const double t20 = x[3]*p[4]; /* omega_n*I1 */
    const double t21 = JLT_FMA(t9, t13, t20); /* b*m*v_tau + omega_n*I1 */
    const double t22 = x[4]*p[5]; /* omega3*I3 */
    const double t23 = t5*p[26]; /* s*m*R */
    const double t24 = JLT_FMA(t12, t23, t22); /* v_tau*s*m*R + omega3*I3 */
    const double t25 = x[3]*p[40]; /* omega_n*(-R*I1) */
    const double t26 = t7*t25; /* gamma3*1/s*omega_n*(-R*I1) */
    const double t27 = JLT_FMA(x[4], p[41], t26); /* omega3*(-R*I3) + gamma3*1/s*omega_n*(-R*I1) */
    const double t28 = t5*p[39]; /* s*R*I1 */
    const double t29 = t9*p[30]; /* b*(-I3) */
    out[0] = t16;
    out[1] = t17;
    out[2] = t19;
    out[3] = t21;
    out[4] = t24;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t27;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t28;
    out[13] = t29;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
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
    double x6[JLT_JET_ORDER_MAX + 1];
    double x7[JLT_JET_ORDER_MAX + 1];
    double x8[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
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
    double t33[JLT_JET_ORDER_MAX + 1];
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
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
    double t68[JLT_JET_ORDER_MAX + 1];
    double t69[JLT_JET_ORDER_MAX + 1];
    double t70[JLT_JET_ORDER_MAX + 1];
    double t71[JLT_JET_ORDER_MAX + 1];
    double t73[JLT_JET_ORDER_MAX + 1];
    double u73[JLT_JET_ORDER_MAX + 1];
    double t74[JLT_JET_ORDER_MAX + 1];
    double t75[JLT_JET_ORDER_MAX + 1];
    double u75[JLT_JET_ORDER_MAX + 1];
    double t76[JLT_JET_ORDER_MAX + 1];
    double t77[JLT_JET_ORDER_MAX + 1];
    double t78[JLT_JET_ORDER_MAX + 1];
    double t79[JLT_JET_ORDER_MAX + 1];
    double t80[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = x6[0] = x[6];
    coefficients[7] = x7[0] = x[7];
    coefficients[8] = x8[0] = x[8];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t11[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t14[k] = t5[k]*p[6] + (k == 0 ? p[4] : 0);
        t18[k] = t11[k]*p[9];
        t19[k] = t5[k]*p[8] + (k == 0 ? p[7] : 0);
        t20[k] = jlt_jet_product(t11, t18, k) + t19[k];
        t21[k] = jlt_jet_product(t14, t20, k);
        t22[k] = jlt_jet_product(t6, t21, k);
        t23[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t22, t23, k);
        t24[k] = jlt_jet_product(t20, t23, k);
        t25[k] = jlt_jet_product(x3, t14, k);
        t26[k] = jlt_jet_product(t24, t25, k);
        t28[k] = p[1]*x4[k];
        t29[k] = jlt_jet_product(t11, t26, k) + t28[k];
        t30[k] = jlt_jet_product(x3, t29, k);
        t33[k] = t6[k]*p[11];
        t35[k] = jlt_jet_product(x2, x0, k);
        t36[k] = p[12]*t35[k];
        t37[k] = jlt_jet_product(x0, t26, k);
        t39[k] = x4[k]*p[13] + t37[k];
        t40[k] = t33[k] - jlt_jet_product(t7, t36, k);
        t41[k] = jlt_jet_product(x3, t39, k) + t40[k];
        t42[k] = t6[k]*p[10];
        t43[k] = jlt_jet_product(t24, t42, k);
        t44[k] = jlt_jet_product(t41, t43, k);
        t46[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t47[k] = jlt_jet_product(x2, t46, k) + x1[k];
        t48[k] = jlt_jet_product(t6, t14, k);
        t49[k] = jlt_jet_product(t23, t48, k);
        t50[k] = jlt_jet_product(t47, t49, k);
        t51[k] = t35[k] - jlt_jet_product(t18, t50, k);
        t53[k] = jlt_jet_product(x2, x4, k);
        t54[k] = jlt_jet_product(t49, t53, k);
        t55[k] = p[14]*t54[k];
        t57[k] = t46[k]*p[15];
        t58[k] = jlt_jet_product(t54, t57, k) + t55[k];
        t59[k] = jlt_jet_product(t26, t51, k) + t58[k];
        t61[k] = x3[k]*p[16];
        t62[k] = jlt_jet_product(t50, t61, k);
        t66[k] = (k == 0 ? p[18] : 0) - x0[k]*p[19];
        t67[k] = p[17]*t66[k];
        t68[k] = jlt_jet_product(t6, t67, k);
        t69[k] = jlt_jet_product(t54, t68, k) + t62[k];
        t70[k] = -t26[k];
        t71[k] = x4[k] + t37[k];
        t73[k] = jlt_jet_cosine(x5, t73, u73, k);
        t74[k] = jlt_jet_product(x1, t73, k);
        t75[k] = jlt_jet_sine(x5, t75, u75, k);
        t76[k] = jlt_jet_product(x3, t11, k);
        t77[k] = jlt_jet_product(t6, t28, k) + t76[k];
        t78[k] = jlt_jet_product(t75, t77, k) + t74[k];
        t79[k] = jlt_jet_product(x1, t75, k);
        t80[k] = t79[k] - jlt_jet_product(t73, t77, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t30[k]/(k + 1);
        next[2] = x2[k + 1] = t44[k]/(k + 1);
        next[3] = x3[k + 1] = t59[k]/(k + 1);
        next[4] = x4[k + 1] = t69[k]/(k + 1);
        next[5] = x5[k + 1] = t70[k]/(k + 1);
        next[6] = x6[k + 1] = t71[k]/(k + 1);
        next[7] = x7[k + 1] = t78[k]/(k + 1);
        next[8] = x8[k + 1] = t80[k]/(k + 1);
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
    out[5] = (-v_omega_n/v_s);
    out[6] = (v_omega3)
        + (v_gamma3*v_omega_n/v_s);
    const double complex v_chi = x[5];
    const double complex v_C = ccos(v_chi);
    const double complex v_S = csin(v_chi);
    const double complex v_v_tau = (v_omega_n*v_b + v_R*v_omega3*v_s);
    out[7] = (v_v_nu*v_C)
        + (v_S*v_v_tau);
    out[8] = (v_v_nu*v_S)
        + (-v_C*v_v_tau);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "chi", "rad", "direction of nu in the plane: precession", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "spin", "rad", "proper rotation about the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "x", "m", "centre of mass, along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "y", "m", "centre of mass, along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_track_general = {
    .model = "spherical_top_track",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_track,
    .state_count = 9, .param_count = 6, .block_count = 42,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 9, { 4, 31, 18, 1, 1, 2, 13, 15 }, { 22, 77, 0, 14, 1, 2, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 81, { 15, 67, 36, 1, 1, 2, 17, 22 }, { 61, 296, 0, 55, 1, 2, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 90, { 18, 79, 41, 1, 1, 2, 16, 39 }, { 75, 353, 0, 69, 1, 2, 16, 14 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 16, 9, 1, 1, 0, 14, 8 }, { 11, 38, 0, 4, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 2, 12, 9, 0, 1, 0, 6, 9 }, { 10, 32, 0, 0, 1, 0, 12, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 18, { 2, 17, 9, 1, 1, 0, 7, 11 }, { 12, 38, 0, 2, 1, 0, 8, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_track_general_baseline,
        &jlt_batch_spherical_top_track_general_avx2,
        &jlt_batch_spherical_top_track_general_avx512,
    },
};
