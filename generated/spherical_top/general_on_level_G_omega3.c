/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   31   14    1    1    0     15   13   (82)
 *  jacobian            7   59   32    1    1    0     18   22   (318)
 *  rhs_jacobian        7   65   36    1    1    0     19   32   (369)
 *  divergence          3   22    8    1    1    0     13   12   (54)
 *  integral_values     2   12    9    1    1    0      8    8   (43)
 *  integral_gradients  2   24   13    1    1    0     12   11   (75)
 *  eliminated          2    4    2    1    1    0      5    4   (11)
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
    const double t2 = params[4]*params[5]; /* I1*I3 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[4]*t4; /* I1*m*R*R */
    const double t6 = params[0]*params[5]; /* m*I3 */
    const double t7 = 1.0/params[5]; /* 1/I3 */
    const double t8 = params[4]*params[1]; /* I1*R */
    const double t9 = t1/params[4]; /* m*a3*a3/I1 */
    const double t10 = params[0]*params[2]; /* m*g */
    const double t11 = params[3]*t10; /* a3*m*g */
    const double t12 = t11/params[4]; /* a3*m*g/I1 */
    const double t13 = params[0]*params[1]; /* m*R */
    const double t14 = params[1]/params[5]; /* R/I3 */
    const double t15 = t8/params[5]; /* I1*R/I3 */
    const double t16 = params[4]*t3; /* I1*R*R */
    const double t17 = t16/params[5]; /* I1*R*R/I3 */
    const double t18 = params[0]*2.0; /* m*2 */
    const double t19 = t0*t18; /* a3*a3*m*2 */
    const double t20 = params[5]/params[4]; /* I3/I1 */
    const double t21 = params[4]*2.0; /* I1*2 */
    const double t22 = t3*t18; /* R*R*m*2 */
    const double t23 = params[4]*t22; /* I1*R*R*m*2 */
    const double t24 = params[1]*t18; /* R*m*2 */
    const double t25 = params[5]*t24; /* I3*R*m*2 */
    const double t26 = params[5]*t13; /* I3*m*R */
    const double t27 = params[5]/t13; /* I3/(m*R) */
    const double t28 = params[0]*params[3]; /* m*a3 */
    const double t29 = params[5]*t28; /* I3*m*a3 */
    const double t30 = params[0]*params[0]; /* m*m */
    const double t31 = 2.0*t30; /* 2*m*m */
    const double t32 = params[2]*t31; /* g*2*m*m */
    const double t33 = params[3]*t0; /* a3*a3*a3 */
    const double t34 = t32*t33; /* g*2*m*m*a3*a3*a3 */
    const double t35 = t34/params[4]; /* g*2*m*m*a3*a3*a3/I1 */
    const double t36 = params[3]*t13; /* a3*m*R */
    const double t37 = t0*2.0; /* a3*a3*2 */
    const double t38 = t37/t16; /* a3*a3*2/(I1*R*R) */
    const double t39 = params[0]/2.0; /* m/2 */
    const double t40 = params[4]/2.0; /* I1/2 */
    const double t41 = params[5]/2.0; /* I3/2 */
    const double t42 = (-1.0)/params[5]; /* (-1)/I3 */
    out[7] = t1;
    out[8] = t2;
    out[9] = t5;
    out[10] = t6;
    out[11] = t7;
    out[12] = t8;
    out[13] = t9;
    out[14] = t12;
    out[15] = t13;
    out[16] = t14;
    out[17] = t15;
    out[18] = t17;
    out[19] = t19;
    out[20] = t11;
    out[21] = t20;
    out[22] = t21;
    out[23] = t23;
    out[24] = t25;
    out[25] = t26;
    out[26] = t27;
    out[27] = t29;
    out[28] = t35;
    out[29] = t36;
    out[30] = t28;
    out[31] = t38;
    out[32] = t39;
    out[33] = t40;
    out[34] = t41;
    out[35] = t42;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[7], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t7 = t5*p[10]; /* b*m*I3 */
    const double t8 = JLT_FMA(t2, p[9], p[8]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(t5, t7, t8); /* Theta = b*b*m*I3 + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t10 = t5*t6; /* b*D */
    const double t11 = t9*t10; /* Theta*b*D */
    const double t12 = t3*t11; /* s*Theta*b*D */
    const double t13 = 1.0/t12; /* 1/(s*Theta*b*D) */
    const double t14 = t9*t13; /* Theta*1/(s*Theta*b*D) */
    const double t15 = t6*t14; /* D*Theta*1/(s*Theta*b*D) */
    const double t16 = x[3]*t5; /* omega_n*b */
    const double t17 = t15*t16; /* D*Theta*1/(s*Theta*b*D)*omega_n*b */
    const double t18 = t5*t17; /* b*D*Theta*1/(s*Theta*b*D)*omega_n*b */
    const double t19 = x[3]*p[12]; /* omega_n*R*I1 */
    const double t20 = JLT_FNMA(t3, t19, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t21 = t3*p[11]; /* s*1/I3 */
    const double t22 = t20*t21; /* (G_level - s*omega_n*R*I1)*s*1/I3 */
    const double t23 = t15*t22; /* D*Theta*1/(s*Theta*b*D)*(G_level - s*omega_n*R*I1)*s*1/I3 */
    const double t24 = JLT_FNMA(p[1], t23, t18); /* b*D*Theta*1/(s*Theta*b*D)*omega_n*b - R*D*Theta*1/(s*Theta*b*D)*(G_level - s*omega_n*R*I1)*s*1/I3 */
    const double t25 = x[3]*t24; /* omega_n*t24 */
    const double t26 = t23*p[5]; /* D*Theta*1/(s*Theta*b*D)*(G_level - s*omega_n*R*I1)*s*1/I3*I3 */
    const double t27 = x[3]*t26; /* omega_n*D*Theta*1/(s*Theta*b*D)*(G_level - s*omega_n*R*I1)*s*1/I3*I3 */
    const double t28 = x[2]*p[13]; /* omega_tau*m*a3^2/I1 */
    const double t29 = t4*t28; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t30 = JLT_FNMA(x[3], t17, t29); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*D*Theta*1/(s*Theta*b*D)*omega_n*b */
    const double t31 = x[0]*t30; /* gamma3*t30 */
    const double t32 = JLT_FNMA(t3, p[14], t31); /* gamma3*t30 - s*m*g*a3/I1 */
    const double t33 = JLT_FMA(p[4], t32, t27); /* I1*(gamma3*t30 - s*m*g*a3/I1) + t27 */
    const double t34 = t3*t5; /* s*b */
    const double t35 = t14*t34; /* Theta*1/(s*Theta*b*D)*s*b */
    const double t36 = t33*t35; /* (I1*(gamma3*t30 - s*m*g*a3/I1) + t27)*Theta*1/(s*Theta*b*D)*s*b */
    const double t37 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t38 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t39 = JLT_FMA(x[2], t38, x[1]); /* V = omega_tau*e + v_nu */
    const double t40 = t3*t10; /* s*b*D */
    const double t41 = t13*t40; /* 1/(s*Theta*b*D)*s*b*D */
    const double t42 = t7*t39; /* b*m*I3*V */
    const double t43 = JLT_FNMA(t41, t42, t37); /* omega_tau*gamma3 - 1/(s*Theta*b*D)*s*b*D*b*m*I3*V */
    const double t44 = t17*t43; /* D*Theta*1/(s*Theta*b*D)*omega_n*b*(omega_tau*gamma3 - 1/(s*Theta*b*D)*s*b*D*b*m*I3*V) */
    const double t45 = JLT_FMA(t38, p[15], p[5]); /* e*m*R + I3 */
    const double t46 = x[2]*t45; /* omega_tau*(e*m*R + I3) */
    const double t47 = t41*t46; /* 1/(s*Theta*b*D)*s*b*D*omega_tau*(e*m*R + I3) */
    const double t48 = JLT_FNMA(t26, t47, t44); /* t44 - D*Theta*1/(s*Theta*b*D)*(G_level - s*omega_n*R*I1)*s*1/I3*I3*1/(s*Theta*b*D)*s*b*D*omega_tau*(e*m*R + I3) */
    out[0] = t4;
    out[1] = t25;
    out[2] = t36;
    out[3] = t48;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(p[7], t4, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = t1*p[10]; /* b*m*I3 */
    const double t7 = JLT_FMA(t4, p[9], p[8]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t1, t6, t7); /* Theta = b*b*m*I3 + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t9 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t10 = t1*t5; /* b*D */
    const double t11 = t8*t10; /* Theta*b*D */
    const double t12 = t9*t11; /* s*Theta*b*D */
    const double t13 = 1.0/t12; /* 1/(s*Theta*b*D) */
    const double t14 = t8*t13; /* Theta*1/(s*Theta*b*D) */
    const double t15 = t5*t14; /* D*Theta*1/(s*Theta*b*D) */
    const double t16 = t1*t15; /* b*D*Theta*1/(s*Theta*b*D) */
    const double t17 = t0*t16; /* gamma3*omega_tau*b*D*Theta*1/(s*Theta*b*D) */
    const double t18 = -t17; /* -gamma3*omega_tau*b*D*Theta*1/(s*Theta*b*D) */
    const double t19 = x[3]*p[12]; /* omega_n*R*I1 */
    const double t20 = JLT_FNMA(t9, t19, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t21 = t9*t15; /* s*D*Theta*1/(s*Theta*b*D) */
    const double t22 = t20*t21; /* (G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D) */
    const double t23 = p[16]*t21; /* R/I3*s*D*Theta*1/(s*Theta*b*D) */
    const double t24 = t22*t23; /* (G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*R/I3*s*D*Theta*1/(s*Theta*b*D) */
    const double t25 = t16*x[3]; /* b*D*Theta*1/(s*Theta*b*D)*omega_n */
    const double t26 = x[0]*t25; /* gamma3*b*D*Theta*1/(s*Theta*b*D)*omega_n */
    const double t27 = t21*p[17]; /* s*D*Theta*1/(s*Theta*b*D)*R*I1/I3 */
    const double t28 = JLT_FNMA(t26, t27, t24); /* d(omega3)/d(gamma3) = t24 - gamma3*b*D*Theta*1/(s*Theta*b*D)*omega_n*s*D*Theta*1/(s*Theta*b*D)*R*I1/I3 */
    const double t29 = t25 + t28; /* b*D*Theta*1/(s*Theta*b*D)*omega_n + d(omega3)/d(gamma3) */
    const double t30 = p[1]*x[3]; /* R*omega_n */
    const double t31 = t29*t30; /* (b*D*Theta*1/(s*Theta*b*D)*omega_n + d(omega3)/d(gamma3))*R*omega_n */
    const double t32 = t1*t25; /* b*b*D*Theta*1/(s*Theta*b*D)*omega_n */
    const double t33 = t16*t26; /* b*D*Theta*1/(s*Theta*b*D)*gamma3*b*D*Theta*1/(s*Theta*b*D)*omega_n */
    const double t34 = JLT_FMA(t32, t33, t31); /* b*b*D*Theta*1/(s*Theta*b*D)*omega_n*t33 + t31 */
    const double t35 = t22*p[11]; /* (G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*1/I3 */
    const double t36 = p[1]*t35; /* R*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*1/I3 */
    const double t37 = t9*t21; /* s*s*D*Theta*1/(s*Theta*b*D) */
    const double t38 = x[3]*p[18]; /* omega_n*R^2*I1/I3 */
    const double t39 = JLT_FMS(t37, t38, t36); /* s*s*D*Theta*1/(s*Theta*b*D)*omega_n*R^2*I1/I3 - R*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*1/I3 */
    const double t40 = JLT_FMA(t32, 2.0, t39); /* b*b*D*Theta*1/(s*Theta*b*D)*omega_n*2 + t39 */
    const double t41 = t1*t9; /* b*s */
    const double t42 = t14*t41; /* Theta*1/(s*Theta*b*D)*b*s */
    const double t43 = t9*t42; /* s*Theta*1/(s*Theta*b*D)*b*s */
    const double t44 = JLT_FMS(p[19], t43, t16); /* 2*m*a3^2*s*Theta*1/(s*Theta*b*D)*b*s - b*D*Theta*1/(s*Theta*b*D) */
    const double t45 = x[0]*t42; /* gamma3*Theta*1/(s*Theta*b*D)*b*s */
    const double t46 = t44*t45; /* t44*gamma3*Theta*1/(s*Theta*b*D)*b*s */
    const double t47 = JLT_FMA(x[0], t46, t43); /* gamma3*t44*gamma3*Theta*1/(s*Theta*b*D)*b*s + s*Theta*1/(s*Theta*b*D)*b*s */
    const double t48 = x[2]*p[7]; /* omega_tau*m*a3^2 */
    const double t49 = x[2]*t48; /* omega_tau*omega_tau*m*a3^2 */
    const double t50 = t47*t49; /* t47*omega_tau*omega_tau*m*a3^2 */
    const double t51 = x[3]*t42; /* omega_n*Theta*1/(s*Theta*b*D)*b*s */
    const double t52 = p[19]*t45; /* 2*m*a3^2*gamma3*Theta*1/(s*Theta*b*D)*b*s */
    const double t53 = JLT_FNMA(t35, t52, t28); /* d(omega3)/d(gamma3) - (G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*1/I3*2*m*a3^2*gamma3*Theta*1/(s*Theta*b*D)*b*s */
    const double t54 = JLT_FMA(t26, t52, t25); /* gamma3*b*D*Theta*1/(s*Theta*b*D)*omega_n*2*m*a3^2*gamma3*Theta*1/(s*Theta*b*D)*b*s + b*D*Theta*1/(s*Theta*b*D)*omega_n */
    const double t55 = JLT_FMA(p[21], t53, t54); /* I3/I1*t53 + t54 */
    const double t56 = t51*t55; /* omega_n*Theta*1/(s*Theta*b*D)*b*s*(I3/I1*t53 + t54) */
    const double t57 = t26*t42; /* gamma3*b*D*Theta*1/(s*Theta*b*D)*omega_n*Theta*1/(s*Theta*b*D)*b*s */
    const double t58 = JLT_FMA(t33, t57, t56); /* t33*t57 + omega_n*Theta*1/(s*Theta*b*D)*b*s*(I3/I1*t53 + t54) */
    const double t59 = JLT_FNMA(t46, p[20], t50); /* t47*omega_tau*omega_tau*m*a3^2 - t44*gamma3*Theta*1/(s*Theta*b*D)*b*s*m*g*a3 */
    const double t60 = JLT_FNMA(p[4], t58, t59); /* t59 - I1*t58 */
    const double t61 = x[2]*t9; /* omega_tau*s */
    const double t62 = t52*t61; /* 2*m*a3^2*gamma3*Theta*1/(s*Theta*b*D)*b*s*omega_tau*s */
    const double t63 = t42*p[5]; /* Theta*1/(s*Theta*b*D)*b*s*I3 */
    const double t64 = t35*t63; /* (G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*1/I3*Theta*1/(s*Theta*b*D)*b*s*I3 */
    const double t65 = p[12]*t51; /* R*I1*omega_n*Theta*1/(s*Theta*b*D)*b*s */
    const double t66 = JLT_FNMA(t37, t65, t64); /* t64 - s*s*D*Theta*1/(s*Theta*b*D)*R*I1*omega_n*Theta*1/(s*Theta*b*D)*b*s */
    const double t67 = JLT_FNMA(t57, p[22], t66); /* t66 - t57*2*I1 */
    const double t68 = x[2]*t25; /* omega_tau*b*D*Theta*1/(s*Theta*b*D)*omega_n */
    const double t69 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t70 = JLT_FMA(x[2], t69, x[1]); /* V = omega_tau*e + v_nu */
    const double t71 = t9*t10; /* s*b*D */
    const double t72 = t13*t71; /* 1/(s*Theta*b*D)*s*b*D */
    const double t73 = p[10]*t72; /* m*I3*1/(s*Theta*b*D)*s*b*D */
    const double t74 = t1*t70; /* b*V */
    const double t75 = JLT_FNMA(t73, t74, t0); /* gamma3*omega_tau - m*I3*1/(s*Theta*b*D)*s*b*D*b*V */
    const double t76 = t16*t75; /* b*D*Theta*1/(s*Theta*b*D)*(gamma3*omega_tau - m*I3*1/(s*Theta*b*D)*s*b*D*b*V) */
    const double t77 = x[0]*p[23]; /* gamma3*2*m*R^2*I1 */
    const double t78 = JLT_FMS(t1, p[24], t77); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t79 = t32*t73; /* b*b*D*Theta*1/(s*Theta*b*D)*omega_n*m*I3*1/(s*Theta*b*D)*s*b*D */
    const double t80 = t78*t79; /* d(Theta)/d(gamma3)*t79 */
    const double t81 = JLT_FNMA(t25, p[25], t80); /* d(Theta)/d(gamma3)*t79 - b*D*Theta*1/(s*Theta*b*D)*omega_n*m*R*I3 */
    const double t82 = t70*t72; /* V*1/(s*Theta*b*D)*s*b*D */
    const double t83 = x[2]*t72; /* omega_tau*1/(s*Theta*b*D)*s*b*D */
    const double t84 = t35*t72; /* (G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*1/I3*1/(s*Theta*b*D)*s*b*D */
    const double t85 = JLT_FMA(t78, t84, t28); /* d(Theta)/d(gamma3)*t84 + d(omega3)/d(gamma3) */
    const double t86 = t69 + p[26]; /* e + I3/(m*R) */
    const double t87 = p[25]*t86; /* m*R*I3*(e + I3/(m*R)) */
    const double t88 = t85*t87; /* (d(Theta)/d(gamma3)*t84 + d(omega3)/d(gamma3))*m*R*I3*(e + I3/(m*R)) */
    const double t89 = t32 + t36; /* b*b*D*Theta*1/(s*Theta*b*D)*omega_n + R*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*1/I3 */
    const double t90 = JLT_FNMA(p[27], t89, t88); /* t88 - m*a3*I3*t89 */
    const double t91 = JLT_FMA(t33, t76, t68); /* t33*t76 + omega_tau*b*D*Theta*1/(s*Theta*b*D)*omega_n */
    const double t92 = JLT_FMA(t81, t82, t91); /* t81*V*1/(s*Theta*b*D)*s*b*D + t33*t76 + omega_tau*b*D*Theta*1/(s*Theta*b*D)*omega_n */
    const double t93 = JLT_FMA(t83, t90, t92); /* omega_tau*1/(s*Theta*b*D)*s*b*D*(t88 - m*a3*I3*t89) + t92 */
    const double t94 = -t79; /* -t79 */
    const double t95 = JLT_FNMA(t69, t79, t26); /* gamma3*b*D*Theta*1/(s*Theta*b*D)*omega_n - e*t79 */
    const double t96 = JLT_FNMA(t84, t87, t95); /* gamma3*b*D*Theta*1/(s*Theta*b*D)*omega_n - e*t79 - t84*m*R*I3*(e + I3/(m*R)) */
    const double t97 = p[9]*t86; /* m*R^2*I1*(e + I3/(m*R)) */
    const double t98 = t83*t97; /* omega_tau*1/(s*Theta*b*D)*s*b*D*m*R^2*I1*(e + I3/(m*R)) */
    const double t99 = JLT_FMA(t37, t98, t76); /* s*s*D*Theta*1/(s*Theta*b*D)*omega_tau*1/(s*Theta*b*D)*s*b*D*m*R^2*I1*(e + I3/(m*R)) + t76 */
    out[0] = t18;
    out[1] = 0.0;
    out[2] = t9;
    out[3] = 0.0;
    out[4] = t34;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t40;
    out[8] = t60;
    out[9] = 0.0;
    out[10] = t62;
    out[11] = t67;
    out[12] = t93;
    out[13] = t94;
    out[14] = t96;
    out[15] = t99;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[7], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t7 = t5*p[10]; /* b*m*I3 */
    const double t8 = JLT_FMA(t2, p[9], p[8]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(t5, t7, t8); /* Theta = b*b*m*I3 + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t10 = t5*t6; /* b*D */
    const double t11 = t9*t10; /* Theta*b*D */
    const double t12 = t3*t11; /* s*Theta*b*D */
    const double t13 = 1.0/t12; /* 1/(s*Theta*b*D) */
    const double t14 = t9*t13; /* Theta*1/(s*Theta*b*D) */
    const double t15 = t6*t14; /* D*Theta*1/(s*Theta*b*D) */
    const double t16 = t5*t15; /* b*D*Theta*1/(s*Theta*b*D) */
    const double t17 = x[3]*t16; /* omega_n*b*D*Theta*1/(s*Theta*b*D) */
    const double t18 = t5*t17; /* b*omega_n*b*D*Theta*1/(s*Theta*b*D) */
    const double t19 = x[3]*p[12]; /* omega_n*R*I1 */
    const double t20 = JLT_FNMA(t3, t19, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t21 = t3*t15; /* s*D*Theta*1/(s*Theta*b*D) */
    const double t22 = t20*t21; /* (G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D) */
    const double t23 = p[11]*t22; /* 1/I3*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D) */
    const double t24 = p[1]*t23; /* R*1/I3*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D) */
    const double t25 = t18 - t24; /* b*omega_n*b*D*Theta*1/(s*Theta*b*D) - R*1/I3*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D) */
    const double t26 = x[3]*t25; /* omega_n*t25 */
    const double t27 = t3*t5; /* s*b */
    const double t28 = t14*t27; /* Theta*1/(s*Theta*b*D)*s*b */
    const double t29 = x[0]*t28; /* gamma3*Theta*1/(s*Theta*b*D)*s*b */
    const double t30 = x[2]*p[13]; /* omega_tau*m*a3^2/I1 */
    const double t31 = t4*t30; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t32 = JLT_FNMA(x[3], t17, t31); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n*b*D*Theta*1/(s*Theta*b*D) */
    const double t33 = p[4]*t32; /* I1*t32 */
    const double t34 = t3*t28; /* s*Theta*1/(s*Theta*b*D)*s*b */
    const double t35 = p[20]*t34; /* m*g*a3*s*Theta*1/(s*Theta*b*D)*s*b */
    const double t36 = t23*p[5]; /* 1/I3*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*I3 */
    const double t37 = x[3]*t28; /* omega_n*Theta*1/(s*Theta*b*D)*s*b */
    const double t38 = JLT_FMS(t36, t37, t35); /* 1/I3*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*I3*omega_n*Theta*1/(s*Theta*b*D)*s*b - m*g*a3*s*Theta*1/(s*Theta*b*D)*s*b */
    const double t39 = JLT_FMA(t29, t33, t38); /* gamma3*Theta*1/(s*Theta*b*D)*s*b*I1*t32 + t38 */
    const double t40 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t41 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t42 = JLT_FMA(x[2], t41, x[1]); /* V = omega_tau*e + v_nu */
    const double t43 = t3*t10; /* s*b*D */
    const double t44 = t13*t43; /* 1/(s*Theta*b*D)*s*b*D */
    const double t45 = p[10]*t44; /* m*I3*1/(s*Theta*b*D)*s*b*D */
    const double t46 = t5*t42; /* b*V */
    const double t47 = JLT_FNMA(t45, t46, t40); /* omega_tau*gamma3 - m*I3*1/(s*Theta*b*D)*s*b*D*b*V */
    const double t48 = x[2]*t44; /* omega_tau*1/(s*Theta*b*D)*s*b*D */
    const double t49 = t41 + p[26]; /* e + I3/(m*R) */
    const double t50 = p[15]*t49; /* m*R*(e + I3/(m*R)) */
    const double t51 = t36*t50; /* 1/I3*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*I3*m*R*(e + I3/(m*R)) */
    const double t52 = t48*t51; /* omega_tau*1/(s*Theta*b*D)*s*b*D*t51 */
    const double t53 = JLT_FMS(t17, t47, t52); /* omega_n*b*D*Theta*1/(s*Theta*b*D)*(omega_tau*gamma3 - m*I3*1/(s*Theta*b*D)*s*b*D*b*V) - omega_tau*1/(s*Theta*b*D)*s*b*D*t51 */
    const double t54 = t16*t40; /* b*D*Theta*1/(s*Theta*b*D)*omega_tau*gamma3 */
    const double t55 = -t54; /* -b*D*Theta*1/(s*Theta*b*D)*omega_tau*gamma3 */
    const double t56 = t21*p[16]; /* s*D*Theta*1/(s*Theta*b*D)*R/I3 */
    const double t57 = t22*t56; /* (G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*s*D*Theta*1/(s*Theta*b*D)*R/I3 */
    const double t58 = x[0]*t17; /* gamma3*omega_n*b*D*Theta*1/(s*Theta*b*D) */
    const double t59 = t21*p[17]; /* s*D*Theta*1/(s*Theta*b*D)*R*I1/I3 */
    const double t60 = JLT_FNMA(t58, t59, t57); /* d(omega3)/d(gamma3) = t57 - gamma3*omega_n*b*D*Theta*1/(s*Theta*b*D)*s*D*Theta*1/(s*Theta*b*D)*R*I1/I3 */
    const double t61 = t17 + t60; /* omega_n*b*D*Theta*1/(s*Theta*b*D) + d(omega3)/d(gamma3) */
    const double t62 = x[3]*p[1]; /* omega_n*R */
    const double t63 = t61*t62; /* (omega_n*b*D*Theta*1/(s*Theta*b*D) + d(omega3)/d(gamma3))*omega_n*R */
    const double t64 = t16*t58; /* b*D*Theta*1/(s*Theta*b*D)*gamma3*omega_n*b*D*Theta*1/(s*Theta*b*D) */
    const double t65 = JLT_FMA(t18, t64, t63); /* b*omega_n*b*D*Theta*1/(s*Theta*b*D)*t64 + t63 */
    const double t66 = t3*t21; /* s*s*D*Theta*1/(s*Theta*b*D) */
    const double t67 = x[3]*p[18]; /* omega_n*R^2*I1/I3 */
    const double t68 = JLT_FMS(t66, t67, t24); /* s*s*D*Theta*1/(s*Theta*b*D)*omega_n*R^2*I1/I3 - R*1/I3*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D) */
    const double t69 = JLT_FMA(t18, 2.0, t68); /* b*omega_n*b*D*Theta*1/(s*Theta*b*D)*2 + t68 */
    const double t70 = t29*p[19]; /* gamma3*Theta*1/(s*Theta*b*D)*s*b*2*m*a3^2 */
    const double t71 = JLT_FMA(t29, t70, t28); /* gamma3*Theta*1/(s*Theta*b*D)*s*b*gamma3*Theta*1/(s*Theta*b*D)*s*b*2*m*a3^2 + Theta*1/(s*Theta*b*D)*s*b */
    const double t72 = t33*t71; /* I1*t32*t71 */
    const double t73 = JLT_FNMA(t30, t40, p[14]); /* m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3 */
    const double t74 = JLT_FNMA(t17, t58, t73); /* m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3 - omega_n*b*D*Theta*1/(s*Theta*b*D)*gamma3*omega_n*b*D*Theta*1/(s*Theta*b*D) */
    const double t75 = t16*t74; /* b*D*Theta*1/(s*Theta*b*D)*t74 */
    const double t76 = JLT_FNMA(t34, p[28], t75); /* b*D*Theta*1/(s*Theta*b*D)*t74 - s*Theta*1/(s*Theta*b*D)*s*b*2*m^2*g*a3^3/I1 */
    const double t77 = p[4]*t29; /* I1*gamma3*Theta*1/(s*Theta*b*D)*s*b */
    const double t78 = JLT_FNMA(t23, t70, t60); /* d(omega3)/d(gamma3) - 1/I3*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*gamma3*Theta*1/(s*Theta*b*D)*s*b*2*m*a3^2 */
    const double t79 = p[5]*t37; /* I3*omega_n*Theta*1/(s*Theta*b*D)*s*b */
    const double t80 = JLT_FNMA(t78, t79, t72); /* I1*t32*t71 - t78*I3*omega_n*Theta*1/(s*Theta*b*D)*s*b */
    const double t81 = JLT_FMA(t76, t77, t80); /* t76*I1*gamma3*Theta*1/(s*Theta*b*D)*s*b + I1*t32*t71 - t78*I3*omega_n*Theta*1/(s*Theta*b*D)*s*b */
    const double t82 = t4*t70; /* omega_tau*s*gamma3*Theta*1/(s*Theta*b*D)*s*b*2*m*a3^2 */
    const double t83 = t29*p[22]; /* gamma3*Theta*1/(s*Theta*b*D)*s*b*2*I1 */
    const double t84 = t17*t83; /* omega_n*b*D*Theta*1/(s*Theta*b*D)*gamma3*Theta*1/(s*Theta*b*D)*s*b*2*I1 */
    const double t85 = p[12]*t37; /* R*I1*omega_n*Theta*1/(s*Theta*b*D)*s*b */
    const double t86 = JLT_FMS(t28, t36, t84); /* Theta*1/(s*Theta*b*D)*s*b*1/I3*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*I3 - t84 */
    const double t87 = JLT_FNMA(t66, t85, t86); /* t86 - s*s*D*Theta*1/(s*Theta*b*D)*R*I1*omega_n*Theta*1/(s*Theta*b*D)*s*b */
    const double t88 = x[2]*t17; /* omega_tau*omega_n*b*D*Theta*1/(s*Theta*b*D) */
    const double t89 = t16*t47; /* b*D*Theta*1/(s*Theta*b*D)*(omega_tau*gamma3 - m*I3*1/(s*Theta*b*D)*s*b*D*b*V) */
    const double t90 = x[0]*p[23]; /* gamma3*2*m*R^2*I1 */
    const double t91 = JLT_FMS(t5, p[24], t90); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t92 = t18*t45; /* b*omega_n*b*D*Theta*1/(s*Theta*b*D)*m*I3*1/(s*Theta*b*D)*s*b*D */
    const double t93 = t91*t92; /* d(Theta)/d(gamma3)*t92 */
    const double t94 = JLT_FNMA(t17, p[25], t93); /* d(Theta)/d(gamma3)*t92 - omega_n*b*D*Theta*1/(s*Theta*b*D)*m*R*I3 */
    const double t95 = t42*t94; /* V*t94 */
    const double t96 = JLT_FMA(t52, t91, t95); /* omega_tau*1/(s*Theta*b*D)*s*b*D*t51*d(Theta)/d(gamma3) + V*t94 */
    const double t97 = t23*p[29]; /* 1/I3*(G_level - s*omega_n*R*I1)*s*D*Theta*1/(s*Theta*b*D)*m*R*a3 */
    const double t98 = JLT_FMS(t50, t60, t97); /* m*R*(e + I3/(m*R))*d(omega3)/d(gamma3) - t97 */
    const double t99 = JLT_FNMA(t18, p[30], t98); /* m*R*(e + I3/(m*R))*d(omega3)/d(gamma3) - t97 - b*omega_n*b*D*Theta*1/(s*Theta*b*D)*m*a3 */
    const double t100 = p[5]*t48; /* I3*omega_tau*1/(s*Theta*b*D)*s*b*D */
    const double t101 = JLT_FMA(t64, t89, t88); /* t64*t89 + omega_tau*omega_n*b*D*Theta*1/(s*Theta*b*D) */
    const double t102 = JLT_FMA(t44, t96, t101); /* 1/(s*Theta*b*D)*s*b*D*t96 + t64*t89 + omega_tau*omega_n*b*D*Theta*1/(s*Theta*b*D) */
    const double t103 = JLT_FMA(t99, t100, t102); /* t99*I3*omega_tau*1/(s*Theta*b*D)*s*b*D + t102 */
    const double t104 = -t92; /* -t92 */
    const double t105 = JLT_FNMA(t41, t92, t58); /* gamma3*omega_n*b*D*Theta*1/(s*Theta*b*D) - e*t92 */
    const double t106 = JLT_FNMA(t44, t51, t105); /* gamma3*omega_n*b*D*Theta*1/(s*Theta*b*D) - e*t92 - 1/(s*Theta*b*D)*s*b*D*t51 */
    const double t107 = p[9]*t49; /* m*R^2*I1*(e + I3/(m*R)) */
    const double t108 = t48*t107; /* omega_tau*1/(s*Theta*b*D)*s*b*D*m*R^2*I1*(e + I3/(m*R)) */
    const double t109 = JLT_FMA(t66, t108, t89); /* s*s*D*Theta*1/(s*Theta*b*D)*omega_tau*1/(s*Theta*b*D)*s*b*D*m*R^2*I1*(e + I3/(m*R)) + t89 */
    out[0] = t4;
    out[1] = t26;
    out[2] = t39;
    out[3] = t53;
    out[4] = t55;
    out[5] = 0.0;
    out[6] = t3;
    out[7] = 0.0;
    out[8] = t65;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t69;
    out[12] = t81;
    out[13] = 0.0;
    out[14] = t82;
    out[15] = t87;
    out[16] = t103;
    out[17] = t104;
    out[18] = t106;
    out[19] = t109;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = t4*p[10]; /* b*m*I3 */
    const double t6 = JLT_FMA(p[9], t2, p[8]); /* m*R^2*I1*(1 - gamma3)*(1 + gamma3) + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*b*m*I3 + m*R^2*I1*(1 - gamma3)*(1 + gamma3) + I1*I3 */
    const double t8 = JLT_FMA(t2, p[7], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t9 = t4*t8; /* b*D */
    const double t10 = t7*t9; /* Theta*b*D */
    const double t11 = t3*t10; /* s*Theta*b*D */
    const double t12 = 1.0/t11; /* 1/(s*Theta*b*D) */
    const double t13 = t4*t12; /* b*1/(s*Theta*b*D) */
    const double t14 = t7*t13; /* Theta*b*1/(s*Theta*b*D) */
    const double t15 = x[0]*p[31]; /* gamma3*2*a3^2/(R^2*I1) */
    const double t16 = t3*t15; /* s*gamma3*2*a3^2/(R^2*I1) */
    const double t17 = t14*t16; /* Theta*b*1/(s*Theta*b*D)*s*gamma3*2*a3^2/(R^2*I1) */
    const double t18 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t19 = p[26] + t18; /* I3/(m*R) + e */
    const double t20 = t3*t8; /* s*D */
    const double t21 = t13*t20; /* b*1/(s*Theta*b*D)*s*D */
    const double t22 = t8*t19; /* D*(I3/(m*R) + e) */
    const double t23 = t7*t22; /* Theta*D*(I3/(m*R) + e) */
    const double t24 = t3*t23; /* s*Theta*D*(I3/(m*R) + e) */
    const double t25 = t12*t24; /* 1/(s*Theta*b*D)*s*Theta*D*(I3/(m*R) + e) */
    const double t26 = JLT_FMA(t21, t25, t17); /* b*1/(s*Theta*b*D)*s*D*1/(s*Theta*b*D)*s*Theta*D*(I3/(m*R) + e) + Theta*b*1/(s*Theta*b*D)*s*gamma3*2*a3^2/(R^2*I1) */
    const double t27 = p[9]*x[2]; /* m*R^2*I1*omega_tau */
    const double t28 = t3*t27; /* s*m*R^2*I1*omega_tau */
    const double t29 = t26*t28; /* t26*s*m*R^2*I1*omega_tau */
    const double t30 = JLT_FMA(x[2], t18, x[1]); /* V = omega_tau*e + v_nu */
    const double t31 = t5*t8; /* b*m*I3*D */
    const double t32 = t30*t31; /* V*b*m*I3*D */
    const double t33 = t21*t32; /* b*1/(s*Theta*b*D)*s*D*V*b*m*I3*D */
    const double t34 = JLT_FNMA(t14, t33, t29); /* t26*s*m*R^2*I1*omega_tau - Theta*b*1/(s*Theta*b*D)*b*1/(s*Theta*b*D)*s*D*V*b*m*I3*D */
    out[0] = t34;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[20]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = x[0] + 1.0; /* gamma3 + 1 */
    const double t6 = t4*t5; /* (1 - gamma3)*(gamma3 + 1) */
    const double t7 = sqrt(t6); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = 1.0/t2; /* 1/b */
    const double t9 = x[3]*p[12]; /* omega_n*R*I1 */
    const double t10 = JLT_FNMA(t7, t9, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t11 = p[11]*t8; /* 1/I3*1/b */
    const double t12 = t10*t11; /* (G_level - s*omega_n*R*I1)*1/I3*1/b */
    const double t13 = p[1]*t7; /* R*s */
    const double t14 = JLT_FNMA(t12, t13, t3); /* v_tau = omega_n*b - (G_level - s*omega_n*R*I1)*1/I3*1/b*R*s */
    const double t15 = JLT_FMA(t14, t14, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t16 = JLT_FMA(t6, p[7], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t17 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t18 = x[2]*t17; /* omega_tau*1/2*omega_tau */
    const double t19 = x[3]*p[33]; /* omega_n*1/2*I1 */
    const double t20 = t12*p[34]; /* (G_level - s*omega_n*R*I1)*1/I3*1/b*1/2*I3 */
    const double t21 = JLT_FMA(x[3], t19, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t22 = JLT_FMA(t16, t18, t21); /* D*omega_tau*1/2*omega_tau + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t23 = JLT_FMA(t12, t20, t22); /* (G_level - s*omega_n*R*I1)*1/I3*1/b*(G_level - s*omega_n*R*I1)*1/I3*1/b*1/2*I3 + t22 */
    const double t24 = JLT_FMA(p[32], t15, t23); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t23 */
    out[0] = t24;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[7]*x[0]; /* m*a3^2*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = p[12]*x[3]; /* R*I1*omega_n */
    const double t7 = JLT_FNMA(t5, t6, p[6]); /* G_level - s*R*I1*omega_n */
    const double t8 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t9 = t5*t8; /* s*b */
    const double t10 = 1.0/t9; /* 1/(s*b) */
    const double t11 = t5*t10; /* s*1/(s*b) */
    const double t12 = t7*t11; /* (G_level - s*R*I1*omega_n)*s*1/(s*b) */
    const double t13 = p[11]*t12; /* 1/I3*(G_level - s*R*I1*omega_n)*s*1/(s*b) */
    const double t14 = x[0]*t8; /* gamma3*b */
    const double t15 = t10*t14; /* 1/(s*b)*gamma3*b */
    const double t16 = t11*p[16]; /* s*1/(s*b)*R/I3 */
    const double t17 = t12*t16; /* (G_level - s*R*I1*omega_n)*s*1/(s*b)*s*1/(s*b)*R/I3 */
    const double t18 = x[3]*p[17]; /* omega_n*R*I1/I3 */
    const double t19 = t11*t18; /* s*1/(s*b)*omega_n*R*I1/I3 */
    const double t20 = JLT_FNMA(t15, t19, t17); /* d(omega3)/d(gamma3) = (G_level - s*R*I1*omega_n)*s*1/(s*b)*s*1/(s*b)*R/I3 - 1/(s*b)*gamma3*b*s*1/(s*b)*omega_n*R*I1/I3 */
    const double t21 = JLT_FMA(t13, t15, x[3]); /* 1/I3*(G_level - s*R*I1*omega_n)*s*1/(s*b)*1/(s*b)*gamma3*b + omega_n */
    const double t22 = JLT_FMA(t5, t20, t21); /* s*d(omega3)/d(gamma3) + t21 */
    const double t23 = x[3]*t8; /* omega_n*b */
    const double t24 = t5*t13; /* s*1/I3*(G_level - s*R*I1*omega_n)*s*1/(s*b) */
    const double t25 = JLT_FNMA(p[1], t24, t23); /* v_tau = omega_n*b - R*s*1/I3*(G_level - s*R*I1*omega_n)*s*1/(s*b) */
    const double t26 = p[0]*t25; /* m*v_tau */
    const double t27 = p[1]*t22; /* R*(s*d(omega3)/d(gamma3) + t21) */
    const double t28 = t13*p[5]; /* 1/I3*(G_level - s*R*I1*omega_n)*s*1/(s*b)*I3 */
    const double t29 = JLT_FNMA(t0, t1, p[20]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t30 = JLT_FNMA(t20, t28, t29); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau - d(omega3)/d(gamma3)*1/I3*(G_level - s*R*I1*omega_n)*s*1/(s*b)*I3 */
    const double t31 = JLT_FMA(t26, t27, t30); /* d(energy)/d(gamma3) = m*v_tau*R*(s*d(omega3)/d(gamma3) + t21) + t30 */
    const double t32 = p[0]*x[1]; /* m*v_nu */
    const double t33 = JLT_FMA(p[7], t4, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t34 = x[2]*t33; /* omega_tau*D */
    const double t35 = x[3]*p[4]; /* omega_n*I1 */
    const double t36 = t4*p[18]; /* (1 - gamma3)*(gamma3 + 1)*R^2*I1/I3 */
    const double t37 = JLT_FMA(t11, t36, t8); /* d(v_tau)/d(omega_n) = s*1/(s*b)*(1 - gamma3)*(gamma3 + 1)*R^2*I1/I3 + b */
    const double t38 = p[12]*t11; /* R*I1*s*1/(s*b) */
    const double t39 = JLT_FNMA(t24, t38, t35); /* omega_n*I1 - s*1/I3*(G_level - s*R*I1*omega_n)*s*1/(s*b)*R*I1*s*1/(s*b) */
    const double t40 = JLT_FMA(t26, t37, t39); /* d(energy)/d(omega_n) = m*v_tau*d(v_tau)/d(omega_n) + t39 */
    out[0] = t31;
    out[1] = t32;
    out[2] = t34;
    out[3] = t40;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = 1.0/t0; /* 1/b */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = p[12]*x[3]; /* R*I1*omega_n */
    const double t7 = JLT_FNMA(t5, t6, p[6]); /* G_level - s*R*I1*omega_n */
    const double t8 = p[35]*t1; /* (-1/I3)*1/b */
    const double t9 = t7*t8; /* (G_level - s*R*I1*omega_n)*(-1/I3)*1/b */
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
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
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
        t14[k] = t5[k]*p[7] + (k == 0 ? p[4] : 0);
        t18[k] = t11[k]*p[10];
        t19[k] = t5[k]*p[9] + (k == 0 ? p[8] : 0);
        t20[k] = jlt_jet_product(t11, t18, k) + t19[k];
        t21[k] = jlt_jet_product(t11, t14, k);
        t22[k] = jlt_jet_product(t20, t21, k);
        t23[k] = jlt_jet_product(t6, t22, k);
        t24[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t23, t24, k);
        t25[k] = jlt_jet_product(t20, t24, k);
        t26[k] = jlt_jet_product(t14, t25, k);
        t27[k] = jlt_jet_product(x3, t11, k);
        t28[k] = jlt_jet_product(t26, t27, k);
        t29[k] = jlt_jet_product(t11, t28, k);
        t33[k] = x3[k]*p[12];
        t34[k] = (k == 0 ? p[6] : 0) - jlt_jet_product(t6, t33, k);
        t35[k] = t6[k]*p[11];
        t36[k] = jlt_jet_product(t34, t35, k);
        t37[k] = jlt_jet_product(t26, t36, k);
        t38[k] = t29[k] - p[1]*t37[k];
        t39[k] = jlt_jet_product(x3, t38, k);
        t41[k] = t37[k]*p[5];
        t42[k] = jlt_jet_product(x3, t41, k);
        t44[k] = x2[k]*p[13];
        t45[k] = jlt_jet_product(t7, t44, k);
        t46[k] = t45[k] - jlt_jet_product(x3, t28, k);
        t47[k] = jlt_jet_product(x0, t46, k);
        t49[k] = t47[k] - t6[k]*p[14];
        t50[k] = p[4]*t49[k] + t42[k];
        t51[k] = jlt_jet_product(t6, t11, k);
        t52[k] = jlt_jet_product(t25, t51, k);
        t53[k] = jlt_jet_product(t50, t52, k);
        t54[k] = jlt_jet_product(x2, x0, k);
        t56[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t57[k] = jlt_jet_product(x2, t56, k) + x1[k];
        t58[k] = jlt_jet_product(t6, t21, k);
        t59[k] = jlt_jet_product(t24, t58, k);
        t60[k] = jlt_jet_product(t18, t57, k);
        t61[k] = t54[k] - jlt_jet_product(t59, t60, k);
        t62[k] = jlt_jet_product(t28, t61, k);
        t64[k] = t56[k]*p[15] + (k == 0 ? p[5] : 0);
        t65[k] = jlt_jet_product(x2, t64, k);
        t66[k] = jlt_jet_product(t59, t65, k);
        t67[k] = t62[k] - jlt_jet_product(t41, t66, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t39[k]/(k + 1);
        next[2] = x2[k + 1] = t53[k]/(k + 1);
        next[3] = x3[k + 1] = t67[k]/(k + 1);
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
    .state_count = 4, .param_count = 7, .block_count = 36,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 2, 31, 14, 1, 1, 0, 15, 13 }, { 15, 56, 0, 10, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 16, { 7, 59, 32, 1, 1, 0, 18, 22 }, { 45, 230, 0, 42, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 65, 36, 1, 1, 0, 19, 32 }, { 52, 265, 0, 51, 1, 0, 18, 13 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 22, 8, 1, 1, 0, 13, 12 }, { 10, 39, 0, 4, 1, 0, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 1, { 2, 12, 9, 1, 1, 0, 8, 8 }, { 10, 31, 0, 1, 1, 0, 13, 6 },
        "divides by b: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 4, { 2, 24, 13, 1, 1, 0, 12, 11 }, { 15, 53, 0, 6, 1, 0, 13, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by b: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 2, 4, 2, 1, 1, 0, 5, 4 }, { 3, 6, 0, 1, 1, 0, 6, 4 },
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
