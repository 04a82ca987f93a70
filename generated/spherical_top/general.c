/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   28   15    1    1    0     13   11   (99)
 *  jacobian            7   59   32    1    1    0     16   19   (373)
 *  rhs_jacobian        9   64   37    1    1    0     16   27   (447)
 *  divergence          2   16    9    1    1    0     12    9   (54)
 *  integral_values     2   12    9    0    1    0      6    9   (43)
 *  integral_gradients  2   17    9    1    1    0      7   11   (53)
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
    const double t2 = params[4]*params[5]; /* I1*I3 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[4]*t4; /* I1*m*R*R */
    const double t6 = params[0]*params[5]; /* m*I3 */
    const double t7 = -params[4]; /* -I1 */
    const double t8 = params[5]/params[4]; /* I3/I1 */
    const double t9 = t1/params[4]; /* m*a3*a3/I1 */
    const double t10 = params[0]*params[2]; /* m*g */
    const double t11 = params[3]*t10; /* a3*m*g */
    const double t12 = t11/params[4]; /* a3*m*g/I1 */
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
    const double t26 = params[4]*(-2.0); /* I1*(-2) */
    const double t27 = -params[5]; /* -I3 */
    const double t28 = t3*t22; /* R*R*m*2 */
    const double t29 = params[4]*t28; /* I1*R*R*m*2 */
    const double t30 = params[1]*t22; /* R*m*2 */
    const double t31 = params[5]*t30; /* I3*R*m*2 */
    const double t32 = params[3]*t14; /* a3*m*R */
    const double t33 = params[5]*t32; /* I3*a3*m*R */
    const double t34 = t4*t20; /* m*R*R*(I1 - I3) */
    const double t35 = params[0]*params[0]; /* m*m */
    const double t36 = 2.0*t35; /* 2*m*m */
    const double t37 = params[2]*t36; /* g*2*m*m */
    const double t38 = params[3]*t0; /* a3*a3*a3 */
    const double t39 = t37*t38; /* g*2*m*m*a3*a3*a3 */
    const double t40 = t0*2.0; /* a3*a3*2 */
    const double t41 = t40/params[1]; /* a3*a3*2/R */
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
    out[11] = t8;
    out[12] = t9;
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
    out[23] = t27;
    out[24] = t29;
    out[25] = t31;
    out[26] = t33;
    out[27] = t14;
    out[28] = t17;
    out[29] = t34;
    out[30] = t11;
    out[31] = t39;
    out[32] = t41;
    out[33] = t42;
    out[34] = t43;
    out[35] = t44;
    out[36] = t45;
    out[37] = t46;
    out[38] = t48;
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
    const double t16 = x[3]*t15; /* omega_n*Theta*1/(s*D*Theta)*omega_n*D */
    const double t17 = t5*t16; /* b*omega_n*Theta*1/(s*D*Theta)*omega_n*D */
    const double t18 = x[3]*x[4]; /* omega_n*omega3 */
    const double t19 = JLT_FMA(p[1], t18, t17); /* R*omega_n*omega3 + b*omega_n*Theta*1/(s*D*Theta)*omega_n*D */
    const double t20 = t18*p[11]; /* omega_n*omega3*I3/I1 */
    const double t21 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t22 = JLT_FMS(t4, t21, t16); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*Theta*1/(s*D*Theta)*omega_n*D */
    const double t23 = JLT_FMA(t3, p[13], t20); /* s*m*g*a3/I1 + omega_n*omega3*I3/I1 */
    const double t24 = JLT_FNMA(x[0], t22, t23); /* s*m*g*a3/I1 + omega_n*omega3*I3/I1 - gamma3*t22 */
    const double t25 = t3*p[10]; /* s*(-I1) */
    const double t26 = t13*t25; /* Theta*1/(s*D*Theta)*s*(-I1) */
    const double t27 = t24*t26; /* (s*m*g*a3/I1 + omega_n*omega3*I3/I1 - gamma3*t22)*Theta*1/(s*D*Theta)*s*(-I1) */
    const double t28 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t29 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t30 = JLT_FMA(x[2], t29, x[1]); /* V = omega_tau*e + v_nu */
    const double t31 = t3*t6; /* s*D */
    const double t32 = t12*t31; /* 1/(s*D*Theta)*s*D */
    const double t33 = t30*t32; /* V*1/(s*D*Theta)*s*D */
    const double t34 = JLT_FNMA(t7, t33, t28); /* omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D */
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
    out[0] = t4;
    out[1] = t19;
    out[2] = t27;
    out[3] = t40;
    out[4] = t46;
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
    const double t27 = JLT_FMS(p[20], t26, t13); /* 2*m*a3^2*s*s*Theta*1/(s*D*Theta) - D*Theta*1/(s*D*Theta) */
    const double t28 = x[0]*t25; /* gamma3*s*Theta*1/(s*D*Theta) */
    const double t29 = x[0]*t28; /* gamma3*gamma3*s*Theta*1/(s*D*Theta) */
    const double t30 = JLT_FMA(t27, t29, t26); /* (2*m*a3^2*s*s*Theta*1/(s*D*Theta) - D*Theta*1/(s*D*Theta))*gamma3*gamma3*s*Theta*1/(s*D*Theta) + s*s*Theta*1/(s*D*Theta) */
    const double t31 = x[2]*p[6]; /* omega_tau*m*a3^2 */
    const double t32 = x[2]*t31; /* omega_tau*omega_tau*m*a3^2 */
    const double t33 = t30*t32; /* t30*omega_tau*omega_tau*m*a3^2 */
    const double t34 = x[4]*p[21]; /* omega3*2*m*a3^2*I3/I1 */
    const double t35 = JLT_FMA(t28, t34, t17); /* gamma3*s*Theta*1/(s*D*Theta)*omega3*2*m*a3^2*I3/I1 + D*Theta*1/(s*D*Theta)*omega_n */
    const double t36 = x[3]*t25; /* omega_n*s*Theta*1/(s*D*Theta) */
    const double t37 = t35*t36; /* t35*omega_n*s*Theta*1/(s*D*Theta) */
    const double t38 = p[20]*t28; /* 2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) */
    const double t39 = JLT_FMA(x[3], t38, t21); /* omega_n*2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta) + gamma3*D*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*omega_n */
    const double t40 = t17*t39; /* D*Theta*1/(s*D*Theta)*omega_n*t39 */
    const double t41 = JLT_FMA(t27, p[13], t40); /* (2*m*a3^2*s*s*Theta*1/(s*D*Theta) - D*Theta*1/(s*D*Theta))*m*g*a3/I1 + D*Theta*1/(s*D*Theta)*omega_n*t39 */
    const double t42 = JLT_FMA(t28, t41, t37); /* gamma3*s*Theta*1/(s*D*Theta)*t41 + t35*omega_n*s*Theta*1/(s*D*Theta) */
    const double t43 = JLT_FNMA(p[4], t42, t33); /* t30*omega_tau*omega_tau*m*a3^2 - I1*t42 */
    const double t44 = x[2]*t8; /* omega_tau*s */
    const double t45 = t38*t44; /* 2*m*a3^2*gamma3*s*Theta*1/(s*D*Theta)*omega_tau*s */
    const double t46 = t17*p[22]; /* D*Theta*1/(s*D*Theta)*omega_n*(-2*I1) */
    const double t47 = t28*t46; /* gamma3*s*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*omega_n*(-2*I1) */
    const double t48 = x[4]*p[23]; /* omega3*(-I3) */
    const double t49 = JLT_FMA(t25, t48, t47); /* s*Theta*1/(s*D*Theta)*omega3*(-I3) + t47 */
    const double t50 = t36*p[23]; /* omega_n*s*Theta*1/(s*D*Theta)*(-I3) */
    const double t51 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t52 = JLT_FMA(x[2], t51, x[1]); /* V = omega_tau*e + v_nu */
    const double t53 = t3*t8; /* D*s */
    const double t54 = t11*t53; /* 1/(s*D*Theta)*D*s */
    const double t55 = t52*t54; /* V*1/(s*D*Theta)*D*s */
    const double t56 = JLT_FNMA(p[15], t55, x[2]); /* omega_tau - m*R*I3*V*1/(s*D*Theta)*D*s */
    const double t57 = t17*t56; /* D*Theta*1/(s*D*Theta)*omega_n*(omega_tau - m*R*I3*V*1/(s*D*Theta)*D*s) */
    const double t58 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t59 = JLT_FNMA(t5, t55, t58); /* omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*D*s */
    const double t60 = t13*t59; /* D*Theta*1/(s*D*Theta)*(omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*D*s) */
    const double t61 = x[2]*p[3]; /* omega_tau*a3 */
    const double t62 = x[0]*p[24]; /* gamma3*2*m*R^2*I1 */
    const double t63 = JLT_FMS(t4, p[25], t62); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t64 = JLT_FNMA(t55, t63, t61); /* omega_tau*a3 - V*1/(s*D*Theta)*D*s*d(Theta)/d(gamma3) */
    const double t65 = p[9]*t54; /* m*I3*1/(s*D*Theta)*D*s */
    const double t66 = t20*t65; /* b*D*Theta*1/(s*D*Theta)*omega_n*m*I3*1/(s*D*Theta)*D*s */
    const double t67 = x[2]*t54; /* omega_tau*1/(s*D*Theta)*D*s */
    const double t68 = x[4]*t67; /* omega3*omega_tau*1/(s*D*Theta)*D*s */
    const double t69 = JLT_FMA(t51, p[27], p[5]); /* e*m*R + I3 */
    const double t70 = p[5]*t69; /* I3*(e*m*R + I3) */
    const double t71 = t54*t70; /* 1/(s*D*Theta)*D*s*I3*(e*m*R + I3) */
    const double t72 = JLT_FNMA(t63, t71, p[26]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*1/(s*D*Theta)*D*s*I3*(e*m*R + I3) */
    const double t73 = JLT_FMA(t68, t72, t57); /* omega3*omega_tau*1/(s*D*Theta)*D*s*t72 + t57 */
    const double t74 = JLT_FMA(t21, t60, t73); /* gamma3*D*Theta*1/(s*D*Theta)*D*Theta*1/(s*D*Theta)*omega_n*t60 + omega3*omega_tau*1/(s*D*Theta)*D*s*t72 + t57 */
    const double t75 = JLT_FNMA(t64, t66, t74); /* t74 - (omega_tau*a3 - V*1/(s*D*Theta)*D*s*d(Theta)/d(gamma3))*b*D*Theta*1/(s*D*Theta)*omega_n*m*I3*1/(s*D*Theta)*D*s */
    const double t76 = -t66; /* -b*D*Theta*1/(s*D*Theta)*omega_n*m*I3*1/(s*D*Theta)*D*s */
    const double t77 = x[0]*t17; /* gamma3*D*Theta*1/(s*D*Theta)*omega_n */
    const double t78 = JLT_FMA(x[4], t71, t77); /* omega3*1/(s*D*Theta)*D*s*I3*(e*m*R + I3) + gamma3*D*Theta*1/(s*D*Theta)*omega_n */
    const double t79 = JLT_FNMA(t51, t66, t78); /* t78 - e*b*D*Theta*1/(s*D*Theta)*omega_n*m*I3*1/(s*D*Theta)*D*s */
    const double t80 = t67*t70; /* omega_tau*1/(s*D*Theta)*D*s*I3*(e*m*R + I3) */
    const double t81 = x[3]*p[28]; /* omega_n*m*R*I1 */
    const double t82 = t54*t81; /* 1/(s*D*Theta)*D*s*omega_n*m*R*I1 */
    const double t83 = t64*t82; /* (omega_tau*a3 - V*1/(s*D*Theta)*D*s*d(Theta)/d(gamma3))*1/(s*D*Theta)*D*s*omega_n*m*R*I1 */
    const double t84 = t8*p[29]; /* s*m*R^2*(I1 - I3) */
    const double t85 = t8*t54; /* s*1/(s*D*Theta)*D*s */
    const double t86 = JLT_FMA(t63, t85, t14); /* d(Theta)/d(gamma3)*s*1/(s*D*Theta)*D*s + gamma3*D*Theta*1/(s*D*Theta) */
    const double t87 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t88 = p[27]*t87; /* m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t89 = JLT_FMA(t86, t88, t84); /* t86*m*R*(a3*I3 - gamma3*R*(I1 - I3)) + s*m*R^2*(I1 - I3) */
    const double t90 = JLT_FMS(t68, t89, t83); /* omega3*omega_tau*1/(s*D*Theta)*D*s*(t86*m*R*(a3*I3 - gamma3*R*(I1 - I3)) + s*m*R^2*(I1 - I3)) - t83 */
    const double t91 = -t82; /* -1/(s*D*Theta)*D*s*omega_n*m*R*I1 */
    const double t92 = x[4]*t88; /* omega3*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t93 = t85*t92; /* s*1/(s*D*Theta)*D*s*omega3*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t94 = JLT_FMA(t51, t82, t93); /* e*1/(s*D*Theta)*D*s*omega_n*m*R*I1 + s*1/(s*D*Theta)*D*s*omega3*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t95 = -t94; /* -t94 */
    const double t96 = t55*p[16]; /* V*1/(s*D*Theta)*D*s*(-m*R*I1) */
    const double t97 = t8*t88; /* s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t98 = t67*t97; /* omega_tau*1/(s*D*Theta)*D*s*s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t99 = -t98; /* -t98 */
    out[0] = t16;
    out[1] = 0.0;
    out[2] = t8;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t22;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t24;
    out[9] = t18;
    out[10] = t43;
    out[11] = 0.0;
    out[12] = t45;
    out[13] = t49;
    out[14] = t50;
    out[15] = t75;
    out[16] = t76;
    out[17] = t79;
    out[18] = t60;
    out[19] = t80;
    out[20] = t90;
    out[21] = t91;
    out[22] = t95;
    out[23] = t96;
    out[24] = t99;
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
    const double t25 = p[4]*t21; /* I1*gamma3*s*Theta*1/(s*D*Theta) */
    const double t26 = t24*t25; /* t24*I1*gamma3*s*Theta*1/(s*D*Theta) */
    const double t27 = t3*t20; /* s*s*Theta*1/(s*D*Theta) */
    const double t28 = x[4]*t20; /* omega3*s*Theta*1/(s*D*Theta) */
    const double t29 = x[3]*p[5]; /* omega_n*I3 */
    const double t30 = JLT_FNMA(p[30], t27, t26); /* t24*I1*gamma3*s*Theta*1/(s*D*Theta) - m*g*a3*s*s*Theta*1/(s*D*Theta) */
    const double t31 = JLT_FNMA(t28, t29, t30); /* t30 - omega3*s*Theta*1/(s*D*Theta)*omega_n*I3 */
    const double t32 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t33 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t34 = JLT_FMA(x[2], t33, x[1]); /* V = omega_tau*e + v_nu */
    const double t35 = t3*t6; /* s*D */
    const double t36 = t12*t35; /* 1/(s*D*Theta)*s*D */
    const double t37 = t34*t36; /* V*1/(s*D*Theta)*s*D */
    const double t38 = JLT_FNMA(t7, t37, t32); /* omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D */
    const double t39 = t15*t38; /* omega_n*D*Theta*1/(s*D*Theta)*(omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D) */
    const double t40 = x[2]*t36; /* omega_tau*1/(s*D*Theta)*s*D */
    const double t41 = x[4]*t40; /* omega3*omega_tau*1/(s*D*Theta)*s*D */
    const double t42 = JLT_FMA(t33, p[27], p[5]); /* e*m*R + I3 */
    const double t43 = p[5]*t42; /* I3*(e*m*R + I3) */
    const double t44 = JLT_FMA(t41, t43, t39); /* omega3*omega_tau*1/(s*D*Theta)*s*D*I3*(e*m*R + I3) + t39 */
    const double t45 = x[3]*p[28]; /* omega_n*m*R*I1 */
    const double t46 = t37*t45; /* V*1/(s*D*Theta)*s*D*omega_n*m*R*I1 */
    const double t47 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t48 = p[27]*t47; /* m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t49 = t3*t48; /* s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t50 = JLT_FMA(t41, t49, t46); /* omega3*omega_tau*1/(s*D*Theta)*s*D*s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) + V*1/(s*D*Theta)*s*D*omega_n*m*R*I1 */
    const double t51 = -t50; /* -t50 */
    const double t52 = x[0]*t14; /* gamma3*D*Theta*1/(s*D*Theta) */
    const double t53 = x[2]*t52; /* omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t54 = -t53; /* -omega_tau*gamma3*D*Theta*1/(s*D*Theta) */
    const double t55 = JLT_FMA(t16, t52, t18); /* b*omega_n*D*Theta*1/(s*D*Theta)*gamma3*D*Theta*1/(s*D*Theta) + omega_n*R */
    const double t56 = t15*t55; /* omega_n*D*Theta*1/(s*D*Theta)*t55 */
    const double t57 = p[1]*x[4]; /* R*omega3 */
    const double t58 = JLT_FMA(t16, 2.0, t57); /* b*omega_n*D*Theta*1/(s*D*Theta)*2 + R*omega3 */
    const double t59 = t14*p[13]; /* D*Theta*1/(s*D*Theta)*m*g*a3/I1 */
    const double t60 = x[3]*p[21]; /* omega_n*2*m*a3^2*I3/I1 */
    const double t61 = x[2]*t22; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t62 = JLT_FMA(t15, t15, t61); /* omega_n*D*Theta*1/(s*D*Theta)*omega_n*D*Theta*1/(s*D*Theta) + omega_tau*omega_tau*m*a3^2/I1 */
    const double t63 = JLT_FNMA(t28, t60, t59); /* D*Theta*1/(s*D*Theta)*m*g*a3/I1 - omega3*s*Theta*1/(s*D*Theta)*omega_n*2*m*a3^2*I3/I1 */
    const double t64 = JLT_FNMA(t52, t62, t63); /* t63 - gamma3*D*Theta*1/(s*D*Theta)*t62 */
    const double t65 = t21*t64; /* gamma3*s*Theta*1/(s*D*Theta)*(t63 - gamma3*D*Theta*1/(s*D*Theta)*t62) */
    const double t66 = t21*p[20]; /* gamma3*s*Theta*1/(s*D*Theta)*2*m*a3^2 */
    const double t67 = JLT_FMA(t21, t66, t20); /* gamma3*s*Theta*1/(s*D*Theta)*gamma3*s*Theta*1/(s*D*Theta)*2*m*a3^2 + s*Theta*1/(s*D*Theta) */
    const double t68 = JLT_FMA(t24, t67, t65); /* t24*t67 + t65 */
    const double t69 = p[4]*t68; /* I1*(t24*t67 + t65) */
    const double t70 = t21*p[31]; /* gamma3*s*Theta*1/(s*D*Theta)*2*m^2*g*a3^3 */
    const double t71 = JLT_FNMA(t27, t70, t69); /* I1*(t24*t67 + t65) - s*s*Theta*1/(s*D*Theta)*gamma3*s*Theta*1/(s*D*Theta)*2*m^2*g*a3^3 */
    const double t72 = t4*t66; /* omega_tau*s*gamma3*s*Theta*1/(s*D*Theta)*2*m*a3^2 */
    const double t73 = t15*p[22]; /* omega_n*D*Theta*1/(s*D*Theta)*(-2*I1) */
    const double t74 = t21*t73; /* gamma3*s*Theta*1/(s*D*Theta)*omega_n*D*Theta*1/(s*D*Theta)*(-2*I1) */
    const double t75 = JLT_FMA(t28, p[23], t74); /* omega3*s*Theta*1/(s*D*Theta)*(-I3) + t74 */
    const double t76 = t20*t29; /* s*Theta*1/(s*D*Theta)*omega_n*I3 */
    const double t77 = -t76; /* -s*Theta*1/(s*D*Theta)*omega_n*I3 */
    const double t78 = t14*t38; /* D*Theta*1/(s*D*Theta)*(omega_tau*gamma3 - b*m*I3*V*1/(s*D*Theta)*s*D) */
    const double t79 = JLT_FMS(t37, p[15], x[2]); /* V*1/(s*D*Theta)*s*D*m*R*I3 - omega_tau */
    const double t80 = JLT_FNMA(t52, t78, t79); /* V*1/(s*D*Theta)*s*D*m*R*I3 - omega_tau - gamma3*D*Theta*1/(s*D*Theta)*t78 */
    const double t81 = x[0]*p[24]; /* gamma3*2*m*R^2*I1 */
    const double t82 = JLT_FMS(t5, p[25], t81); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t83 = t36*t82; /* 1/(s*D*Theta)*s*D*d(Theta)/d(gamma3) */
    const double t84 = t37*t83; /* V*1/(s*D*Theta)*s*D*1/(s*D*Theta)*s*D*d(Theta)/d(gamma3) */
    const double t85 = JLT_FNMA(p[3], t40, t84); /* V*1/(s*D*Theta)*s*D*1/(s*D*Theta)*s*D*d(Theta)/d(gamma3) - a3*omega_tau*1/(s*D*Theta)*s*D */
    const double t86 = p[9]*t16; /* m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t87 = t85*t86; /* t85*m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t88 = JLT_FNMA(t43, t83, p[26]); /* m*R*a3*I3 - I3*(e*m*R + I3)*1/(s*D*Theta)*s*D*d(Theta)/d(gamma3) */
    const double t89 = JLT_FMA(t41, t88, t87); /* omega3*omega_tau*1/(s*D*Theta)*s*D*t88 + t85*m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t90 = JLT_FNMA(t15, t80, t89); /* t89 - omega_n*D*Theta*1/(s*D*Theta)*t80 */
    const double t91 = t36*t86; /* 1/(s*D*Theta)*s*D*m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t92 = -t91; /* -1/(s*D*Theta)*s*D*m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t93 = x[0]*t15; /* gamma3*omega_n*D*Theta*1/(s*D*Theta) */
    const double t94 = x[4]*t43; /* omega3*I3*(e*m*R + I3) */
    const double t95 = JLT_FNMA(t33, t86, t94); /* omega3*I3*(e*m*R + I3) - e*m*I3*b*omega_n*D*Theta*1/(s*D*Theta) */
    const double t96 = JLT_FMA(t36, t95, t93); /* 1/(s*D*Theta)*s*D*t95 + gamma3*omega_n*D*Theta*1/(s*D*Theta) */
    const double t97 = t40*t43; /* omega_tau*1/(s*D*Theta)*s*D*I3*(e*m*R + I3) */
    const double t98 = t45*t85; /* omega_n*m*R*I1*t85 */
    const double t99 = t3*p[29]; /* s*m*R^2*(I1 - I3) */
    const double t100 = JLT_FMA(t49, t83, t99); /* s*m*R*(a3*I3 - gamma3*R*(I1 - I3))*1/(s*D*Theta)*s*D*d(Theta)/d(gamma3) + s*m*R^2*(I1 - I3) */
    const double t101 = JLT_FMA(t48, t52, t100); /* m*R*(a3*I3 - gamma3*R*(I1 - I3))*gamma3*D*Theta*1/(s*D*Theta) + t100 */
    const double t102 = JLT_FMA(t41, t101, t98); /* omega3*omega_tau*1/(s*D*Theta)*s*D*t101 + omega_n*m*R*I1*t85 */
    const double t103 = t36*t45; /* 1/(s*D*Theta)*s*D*omega_n*m*R*I1 */
    const double t104 = -t103; /* -1/(s*D*Theta)*s*D*omega_n*m*R*I1 */
    const double t105 = x[4]*t49; /* omega3*s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t106 = JLT_FMA(t33, t45, t105); /* e*omega_n*m*R*I1 + omega3*s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t107 = t36*t106; /* 1/(s*D*Theta)*s*D*(e*omega_n*m*R*I1 + omega3*s*m*R*(a3*I3 - gamma3*R*(I1 - I3))) */
    const double t108 = -t107; /* -t107 */
    const double t109 = t37*p[16]; /* V*1/(s*D*Theta)*s*D*(-m*R*I1) */
    const double t110 = t40*t49; /* omega_tau*1/(s*D*Theta)*s*D*s*m*R*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t111 = -t110; /* -t110 */
    out[0] = t4;
    out[1] = t19;
    out[2] = t31;
    out[3] = t44;
    out[4] = t51;
    out[5] = t54;
    out[6] = 0.0;
    out[7] = t3;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = t56;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t58;
    out[14] = t18;
    out[15] = t71;
    out[16] = 0.0;
    out[17] = t72;
    out[18] = t75;
    out[19] = t77;
    out[20] = t90;
    out[21] = t92;
    out[22] = t96;
    out[23] = t78;
    out[24] = t97;
    out[25] = t102;
    out[26] = t104;
    out[27] = t108;
    out[28] = t109;
    out[29] = t111;
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
    const double t13 = x[0]*p[32]; /* gamma3*2*a3^2/R */
    const double t14 = t3*t13; /* s*gamma3*2*a3^2/R */
    const double t15 = t12*t14; /* Theta*1/(s*Theta*D)*s*gamma3*2*a3^2/R */
    const double t16 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t17 = t3*t8; /* s*D */
    const double t18 = t11*t17; /* 1/(s*Theta*D)*s*D */
    const double t19 = JLT_FNMA(t16, t18, t15); /* Theta*1/(s*Theta*D)*s*gamma3*2*a3^2/R - (a3*I3 - gamma3*R*(I1 - I3))*1/(s*Theta*D)*s*D */
    const double t20 = p[27]*x[2]; /* m*R*omega_tau */
    const double t21 = t3*t20; /* s*m*R*omega_tau */
    const double t22 = t19*t21; /* t19*s*m*R*omega_tau */
    const double t23 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t24 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t25 = t5*t8; /* b*m*I3*D */
    const double t26 = t24*t25; /* V*b*m*I3*D */
    const double t27 = t18*t26; /* 1/(s*Theta*D)*s*D*V*b*m*I3*D */
    const double t28 = JLT_FNMA(t12, t27, t22); /* t19*s*m*R*omega_tau - Theta*1/(s*Theta*D)*1/(s*Theta*D)*s*D*V*b*m*I3*D */
    out[0] = t28;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[30]*x[0]; /* m*g*a3*gamma3 */
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
    const double t14 = x[3]*p[34]; /* omega_n*1/2*I1 */
    const double t15 = x[4]*p[35]; /* omega3*1/2*I3 */
    const double t16 = JLT_FMA(x[3], t14, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t17 = JLT_FMA(x[4], t15, t16); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t18 = JLT_FMA(t11, t13, t17); /* D*omega_tau*1/2*omega_tau + t17 */
    const double t19 = JLT_FMA(p[33], t10, t18); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t17 */
    const double t20 = x[3]*p[36]; /* omega_n*R*I1 */
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
    const double t15 = JLT_FNMA(t0, t1, p[30]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t16 = JLT_FNMA(t8, t14, t15); /* d(energy)/d(gamma3) = m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau - (omega3*gamma3*1/s - omega_n)*R*m*v_tau */
    const double t17 = p[0]*x[1]; /* m*v_nu */
    const double t18 = JLT_FMA(p[6], t4, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t19 = x[2]*t18; /* omega_tau*D */
    const double t20 = x[3]*p[4]; /* omega_n*I1 */
    const double t21 = JLT_FMA(t9, t13, t20); /* d(energy)/d(omega_n) = b*m*v_tau + omega_n*I1 */
    const double t22 = x[4]*p[5]; /* omega3*I3 */
    const double t23 = t5*p[27]; /* s*m*R */
    const double t24 = JLT_FMA(t12, t23, t22); /* d(energy)/d(omega3) = v_tau*s*m*R + omega3*I3 */
    const double t25 = x[3]*p[37]; /* omega_n*(-R*I1) */
    const double t26 = t7*t25; /* gamma3*1/s*omega_n*(-R*I1) */
    const double t27 = JLT_FMA(x[4], p[38], t26); /* omega3*(-R*I3) + gamma3*1/s*omega_n*(-R*I1) */
    const double t28 = t5*p[36]; /* s*R*I1 */
    const double t29 = t9*p[23]; /* b*(-I3) */
    out[0] = t16;
    out[1] = t17;
    out[2] = t19;
    out[3] = t21;
    out[4] = t24;
    out[5] = t27;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t28;
    out[9] = t29;
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
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
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
        t14[k] = t5[k]*p[6] + (k == 0 ? p[4] : 0);
        t18[k] = t10[k]*p[9];
        t19[k] = t5[k]*p[8] + (k == 0 ? p[7] : 0);
        t20[k] = jlt_jet_product(t10, t18, k) + t19[k];
        t21[k] = jlt_jet_product(t14, t20, k);
        t22[k] = jlt_jet_product(t6, t21, k);
        t23[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t22, t23, k);
        t24[k] = jlt_jet_product(t20, t23, k);
        t25[k] = jlt_jet_product(x3, t14, k);
        t26[k] = jlt_jet_product(t24, t25, k);
        t27[k] = jlt_jet_product(x3, t26, k);
        t28[k] = jlt_jet_product(t10, t27, k);
        t30[k] = jlt_jet_product(x3, x4, k);
        t31[k] = p[1]*t30[k] + t28[k];
        t34[k] = t30[k]*p[11];
        t36[k] = x2[k]*p[12];
        t37[k] = jlt_jet_product(t7, t36, k) - t27[k];
        t39[k] = t6[k]*p[13] + t34[k];
        t40[k] = t39[k] - jlt_jet_product(x0, t37, k);
        t41[k] = t6[k]*p[10];
        t42[k] = jlt_jet_product(t24, t41, k);
        t43[k] = jlt_jet_product(t40, t42, k);
        t44[k] = jlt_jet_product(x2, x0, k);
        t46[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t47[k] = jlt_jet_product(x2, t46, k) + x1[k];
        t48[k] = jlt_jet_product(t6, t14, k);
        t49[k] = jlt_jet_product(t23, t48, k);
        t50[k] = jlt_jet_product(t47, t49, k);
        t51[k] = t44[k] - jlt_jet_product(t18, t50, k);
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
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t31[k]/(k + 1);
        next[2] = x2[k + 1] = t43[k]/(k + 1);
        next[3] = x3[k + 1] = t59[k]/(k + 1);
        next[4] = x4[k + 1] = t69[k]/(k + 1);
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
    const double t1 = t0*params[3]; /* m*g*a3 */
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
    const double t14 = t1 - t13; /* d(energy)/d(gamma3) = m*g*a3 - m*v_tau*gamma3*R*omega3/s */
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
    const double t1 = t0*params[3]; /* m*g*a3 */
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
    const double t14 = t1 - t13; /* d(energy)/d(gamma3) = m*g*a3 - m*v_tau*gamma3*R*omega3/s */
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
    const double t1 = t0*params[3]; /* m*g*a3 */
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
    const double t20 = t1 + t19; /* d(energy)/d(gamma3) = m*g*a3 + m*v_tau*d(v_tau)/d(gamma3) */
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
    .state_count = 5, .param_count = 6, .block_count = 39,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 28, 15, 1, 1, 0, 13, 11 }, { 17, 69, 0, 12, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 25, { 7, 59, 32, 1, 1, 0, 16, 19 }, { 52, 271, 0, 49, 1, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 9, 64, 37, 1, 1, 0, 16, 27 }, { 62, 323, 0, 61, 1, 0, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 16, 9, 1, 1, 0, 12, 9 }, { 11, 38, 0, 4, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 2, 12, 9, 0, 1, 0, 6, 9 }, { 10, 32, 0, 0, 1, 0, 12, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 10, { 2, 17, 9, 1, 1, 0, 7, 11 }, { 12, 38, 0, 2, 1, 0, 8, 8 },
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
