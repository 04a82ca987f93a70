/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   25   12    1    1    0     14   10   (82)
 *  jacobian            8   51   29    1    1    0     17   22   (318)
 *  rhs_jacobian        9   54   32    1    1    0     20   26   (369)
 *  divergence          4   18    7    1    1    0     13   10   (54)
 *  integral_values     2    9    9    1    1    0      9    7   (43)
 *  integral_gradients  2   21   13    1    1    0     14   11   (75)
 *  eliminated          3    2    1    1    1    0      5    3   (11)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by b: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
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
    out[25] = t1;
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    out[7] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    out[8] = t5;
    const double t6 = params[4]*t3; /* I1*R*R */
    const double t7 = params[5]/t6; /* I3/(I1*R*R) */
    out[9] = t7;
    const double t8 = t6/params[5]; /* I1*R*R/I3 */
    out[10] = t8;
    const double t9 = params[4]*params[1]; /* I1*R */
    out[33] = t9;
    const double t10 = params[6]/t9; /* G_level/(I1*R) */
    out[11] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[3]*t11; /* a3*m*g */
    out[31] = t12;
    const double t13 = t12/params[4]; /* a3*m*g/I1 */
    out[12] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[13] = t15;
    const double t16 = t9/params[5]; /* I1*R/I3 */
    out[14] = t16;
    const double t17 = params[0]*2.0; /* m*2 */
    const double t18 = t0*t17; /* a3*a3*m*2 */
    out[24] = t18;
    const double t19 = t18/params[4]; /* a3*a3*m*2/I1 */
    out[15] = t19;
    const double t20 = params[1]*t17; /* R*m*2 */
    const double t21 = t0*t20; /* a3*a3*R*m*2 */
    const double t22 = t21/params[4]; /* a3*a3*R*m*2/I1 */
    out[16] = t22;
    const double t23 = params[5]/params[4]; /* I3/I1 */
    out[17] = t23;
    const double t24 = -params[1]; /* -R */
    out[18] = t24;
    const double t25 = 2.0/params[1]; /* 2/R */
    out[19] = t25;
    const double t26 = params[5]/t9; /* I3/(I1*R) */
    out[20] = t26;
    const double t27 = params[0]*params[0]; /* m*m */
    const double t28 = 2.0*t27; /* 2*m*m */
    const double t29 = params[2]*t28; /* g*2*m*m */
    const double t30 = params[3]*t0; /* a3*a3*a3 */
    const double t31 = t29*t30; /* g*2*m*m*a3*a3*a3 */
    const double t32 = params[4]*params[4]; /* I1*I1 */
    const double t33 = t31/t32; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    out[21] = t33;
    const double t34 = params[3]/2.0; /* a3/2 */
    out[22] = t34;
    const double t35 = params[1]*2.0; /* R*2 */
    const double t36 = params[4]*t35; /* I1*R*2 */
    const double t37 = params[5]/t36; /* I3/(I1*R*2) */
    out[23] = t37;
    const double t38 = params[0]/2.0; /* m/2 */
    out[26] = t38;
    const double t39 = params[2]*2.0; /* g*2 */
    const double t40 = params[3]*t39; /* a3*g*2 */
    out[27] = t40;
    const double t41 = 1.0/params[0]; /* 1/m */
    out[28] = t41;
    const double t42 = params[4]/params[0]; /* I1/m */
    out[29] = t42;
    const double t43 = t3*t32; /* R*R*I1*I1 */
    const double t44 = params[0]*params[5]; /* m*I3 */
    const double t45 = t43/t44; /* R*R*I1*I1/(m*I3) */
    out[30] = t45;
    const double t46 = params[1]/params[5]; /* R/I3 */
    out[32] = t46;
    const double t47 = params[4]/params[5]; /* I1/I3 */
    const double t48 = -t47; /* -I1/I3 */
    out[34] = t48;
    const double t49 = params[3]/params[1]; /* a3/R */
    out[35] = t49;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(1 + gamma3) + 1 */
    const double t6 = p[8] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t7 = p[9]*t4; /* I3/(R^2*I1)*b */
    const double t8 = JLT_FMA(t4, t7, t6); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t9 = t3*t4; /* s*b */
    const double t10 = t5*t9; /* D/I1*s*b */
    const double t11 = t8*t10; /* Theta/(m*R^2*I1)*D/I1*s*b */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*D/I1*s*b) */
    const double t13 = t8*t12; /* 1/(s*b*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s*b) */
    const double t14 = t10*t12; /* D/I1*s*b*1/(Theta/(m*R^2*I1)*D/I1*s*b) */
    const double t15 = t5*t13; /* 1/(s*b) = D/I1*1/(s*b*(D/I1)) */
    const double t16 = t9*t13; /* s*b*1/(s*b*(D/I1)) */
    const double t17 = x[3]*t4; /* omega_n*b */
    const double t18 = t15*t17; /* 1/(s*b)*omega_n*b */
    const double t19 = t4*t18; /* b*1/(s*b)*omega_n*b */
    const double t20 = x[0]*t18; /* gamma3*1/(s*b)*omega_n*b */
    const double t21 = JLT_FNMA(x[3], t3, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t22 = t3*t21; /* s*(G_level/(R*I1) - omega_n*s) */
    const double t23 = t15*t22; /* 1/(s*b)*s*(G_level/(R*I1) - omega_n*s) */
    const double t24 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t25 = x[0]*t24; /* gamma3*omega_tau*m*a3^2/I1 */
    const double t26 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t27 = x[2]*t3; /* omega_tau*s */
    out[0] = t27;
    const double t28 = t25*t27; /* gamma3*omega_tau*m*a3^2/I1*omega_tau*s */
    const double t29 = JLT_FNMA(p[12], t3, t28); /* gamma3*omega_tau*m*a3^2/I1*omega_tau*s - m*g*a3/I1*s */
    const double t30 = p[13] + t26; /* I3/(m*R) + e */
    const double t31 = x[2]*t30; /* omega_tau*(I3/(m*R) + e) */
    const double t32 = JLT_FMA(x[2], t26, x[1]); /* V = omega_tau*e + v_nu */
    const double t33 = t23*t31; /* 1/(s*b)*s*(G_level/(R*I1) - omega_n*s)*omega_tau*(I3/(m*R) + e) */
    const double t34 = p[9]*t32; /* I3/(R^2*I1)*V */
    const double t35 = JLT_FMA(t19, t34, t33); /* b*1/(s*b)*omega_n*b*I3/(R^2*I1)*V + t33 */
    const double t36 = JLT_FNMA(p[10], t23, t19); /* b*1/(s*b)*omega_n*b - R^2*I1/I3*1/(s*b)*s*(G_level/(R*I1) - omega_n*s) */
    const double t37 = x[3]*t36; /* omega_n*t36 */
    out[1] = t37;
    const double t38 = JLT_FNMA(p[1], t23, t20); /* gamma3*1/(s*b)*omega_n*b - R*1/(s*b)*s*(G_level/(R*I1) - omega_n*s) */
    const double t39 = JLT_FNMA(x[3], t38, t29); /* gamma3*omega_tau*m*a3^2/I1*omega_tau*s - m*g*a3/I1*s - omega_n*t38 */
    const double t40 = t16*t39; /* s*b*1/(s*b*(D/I1))*t39 */
    out[2] = t40;
    const double t41 = x[2]*t20; /* omega_tau*gamma3*1/(s*b)*omega_n*b */
    const double t42 = JLT_FNMA(t14, t35, t41); /* omega_tau*gamma3*1/(s*b)*omega_n*b - D/I1*s*b*1/(Theta/(m*R^2*I1)*D/I1*s*b)*(b*1/(s*b)*omega_n*b*I3/(R^2*I1)*V + t33) */
    out[3] = t42;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t4;
    const double t5 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(gamma3 + 1) + 1 */
    const double t6 = p[8] + t2; /* I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t7 = p[9]*t3; /* I3/(R^2*I1)*b */
    const double t8 = JLT_FMA(t3, t7, t6); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t9 = t3*t4; /* b*s */
    const double t10 = t5*t9; /* D/I1*b*s */
    const double t11 = t8*t10; /* Theta/(m*R^2*I1)*D/I1*b*s */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*D/I1*b*s) */
    const double t13 = t8*t12; /* 1/(s*b*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*b*s) */
    const double t14 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = D/I1*b*s*1/(Theta/(m*R^2*I1)*D/I1*b*s) */
    const double t15 = t5*t13; /* 1/(s*b) = D/I1*1/(s*b*(D/I1)) */
    const double t16 = t9*t13; /* 1/(D/I1) = b*s*1/(s*b*(D/I1)) */
    const double t17 = t3*t15; /* 1/s = b*1/(s*b) */
    const double t18 = t4*t15; /* 1/b = s*1/(s*b) */
    const double t19 = JLT_FNMA(x[3], t4, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t20 = t18*t19; /* 1/b*(G_level/(R*I1) - omega_n*s) */
    const double t21 = x[0]*t16; /* gamma3*1/(D/I1) */
    const double t22 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t23 = p[10]*t18; /* R^2*I1/I3*1/b */
    const double t24 = t20*t23; /* 1/b*(G_level/(R*I1) - omega_n*s)*R^2*I1/I3*1/b */
    const double t25 = x[3]*t17; /* omega_n*1/s */
    const double t26 = p[15]*t21; /* 2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t27 = p[16]*t21; /* 2*m*R*a3^2/I1*gamma3*1/(D/I1) */
    const double t28 = p[13] + t22; /* I3/(m*R) + e */
    const double t29 = t7*t14; /* I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    const double t30 = JLT_FMA(t7, t25, t20); /* I3/(R^2*I1)*b*omega_n*1/s + 1/b*(G_level/(R*I1) - omega_n*s) */
    const double t31 = x[0]*t25; /* gamma3*omega_n*1/s */
    const double t32 = p[14]*t18; /* R*I1/I3*1/b */
    const double t33 = JLT_FNMA(t31, t32, t24); /* d(omega3)/d(gamma3) = 1/b*(G_level/(R*I1) - omega_n*s)*R^2*I1/I3*1/b - gamma3*omega_n*1/s*R*I1/I3*1/b */
    const double t34 = t4*t18; /* s*1/b */
    const double t35 = t4*t26; /* s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t36 = t26*t31; /* 2*m*a3^2/I1*gamma3*1/(D/I1)*gamma3*omega_n*1/s */
    const double t37 = JLT_FNMA(t20, t27, t36); /* 2*m*a3^2/I1*gamma3*1/(D/I1)*gamma3*omega_n*1/s - 1/b*(G_level/(R*I1) - omega_n*s)*2*m*R*a3^2/I1*gamma3*1/(D/I1) */
    const double t38 = JLT_FMA(p[17], t33, t37); /* I3/I1*d(omega3)/d(gamma3) + t37 */
    const double t39 = x[2]*t35; /* omega_tau*s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    out[10] = t39;
    const double t40 = JLT_FMS(x[0], t17, t35); /* gamma3*1/s - s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t41 = JLT_FMS(x[0], t40, t4); /* gamma3*(gamma3*1/s - s*2*m*a3^2/I1*gamma3*1/(D/I1)) - s */
    const double t42 = t17*t25; /* 1/s*omega_n*1/s */
    const double t43 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t44 = t25*t29; /* omega_n*1/s*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    const double t45 = t29*t43; /* I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V */
    const double t46 = t17*t45; /* 1/s*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V */
    const double t47 = -t44; /* -omega_n*1/s*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    out[13] = t47;
    const double t48 = t14*t28; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t49 = p[20]*t28; /* I3/(R*I1)*(I3/(m*R) + e) */
    const double t50 = t33*t49; /* d(omega3)/d(gamma3)*I3/(R*I1)*(I3/(m*R) + e) */
    const double t51 = JLT_FNMA(p[3], t30, t50); /* d(omega3)/d(gamma3)*I3/(R*I1)*(I3/(m*R) + e) - a3*(I3/(R^2*I1)*b*omega_n*1/s + 1/b*(G_level/(R*I1) - omega_n*s)) */
    const double t52 = t25 + t33; /* omega_n*1/s + d(omega3)/d(gamma3) */
    const double t53 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t54 = x[2]*t53; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t55 = t25*t42; /* omega_n*1/s*1/s*omega_n*1/s */
    const double t56 = JLT_FMS(p[12], t40, t55); /* m*g*a3/I1*(gamma3*1/s - s*2*m*a3^2/I1*gamma3*1/(D/I1)) - omega_n*1/s*1/s*omega_n*1/s */
    const double t57 = JLT_FNMA(t41, t54, t56); /* t56 - (gamma3*(gamma3*1/s - s*2*m*a3^2/I1*gamma3*1/(D/I1)) - s)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t58 = JLT_FNMA(x[3], t38, t57); /* t57 - omega_n*(I3/I1*d(omega3)/d(gamma3) + t37) */
    const double t59 = t16*t58; /* 1/(D/I1)*(t57 - omega_n*(I3/I1*d(omega3)/d(gamma3) + t37)) */
    out[8] = t59;
    const double t60 = p[18]*t16; /* (-R)*1/(D/I1) */
    const double t61 = p[20]*t43; /* I3/(R*I1)*V */
    const double t62 = t43*t44; /* V*omega_n*1/s*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    const double t63 = t25*t61; /* omega_n*1/s*I3/(R*I1)*V */
    const double t64 = t3*t25; /* b*omega_n*1/s */
    const double t65 = JLT_FMS(p[20], t3, x[0]); /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = I3/(R*I1)*b - gamma3 */
    const double t66 = 2.0*t65; /* 2*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t67 = x[2]*t48; /* omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t68 = JLT_FMA(t20, t67, t62); /* 1/b*(G_level/(R*I1) - omega_n*s)*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) + V*omega_n*1/s*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    const double t69 = JLT_FMS(t66, t68, t63); /* 2*d(Theta)/d(gamma3)/(2*m*R^2*I1)*t68 - omega_n*1/s*I3/(R*I1)*V */
    const double t70 = JLT_FMA(x[2], t51, t69); /* omega_tau*t51 + t69 */
    const double t71 = JLT_FNMA(t20, t48, t31); /* gamma3*omega_n*1/s - 1/b*(G_level/(R*I1) - omega_n*s)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t72 = JLT_FNMA(t22, t44, t71); /* t71 - e*omega_n*1/s*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    out[14] = t72;
    const double t73 = JLT_FMS(x[3], t34, t20); /* omega_n*s*1/b - 1/b*(G_level/(R*I1) - omega_n*s) */
    const double t74 = x[2]*t17; /* omega_tau*1/s */
    const double t75 = t17*t31; /* 1/s*gamma3*omega_n*1/s */
    const double t76 = t42*t74; /* 1/s*omega_n*1/s*omega_tau*1/s */
    const double t77 = x[0]*t74; /* gamma3*omega_tau*1/s */
    const double t78 = JLT_FMA(p[19], t31, t73); /* 2/R*gamma3*omega_n*1/s + omega_n*s*1/b - 1/b*(G_level/(R*I1) - omega_n*s) */
    const double t79 = t60*t78; /* (-R)*1/(D/I1)*t78 */
    out[11] = t79;
    const double t80 = p[10]*t73; /* R^2*I1/I3*(omega_n*s*1/b - 1/b*(G_level/(R*I1) - omega_n*s)) */
    const double t81 = JLT_FMA(2.0, t64, t80); /* 2*b*omega_n*1/s + R^2*I1/I3*(omega_n*s*1/b - 1/b*(G_level/(R*I1) - omega_n*s)) */
    out[7] = t81;
    const double t82 = JLT_FNMA(t46, t75, t76); /* 1/s*omega_n*1/s*omega_tau*1/s - 1/s*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V*1/s*gamma3*omega_n*1/s */
    const double t83 = JLT_FMA(t14, t70, t82); /* 1/(Theta/(m*R^2*I1))*(omega_tau*t51 + t69) + t82 */
    out[12] = t83;
    const double t84 = t77 - t46; /* gamma3*omega_tau*1/s - 1/s*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V */
    const double t85 = JLT_FMA(t34, t67, t84); /* s*1/b*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) + t84 */
    out[15] = t85;
    const double t86 = -t77; /* -gamma3*omega_tau*1/s */
    out[0] = t86;
    const double t87 = p[1]*x[3]; /* R*omega_n */
    const double t88 = t52*t87; /* (omega_n*1/s + d(omega3)/d(gamma3))*R*omega_n */
    const double t89 = JLT_FMA(t64, t75, t88); /* b*omega_n*1/s*1/s*gamma3*omega_n*1/s + (omega_n*1/s + d(omega3)/d(gamma3))*R*omega_n */
    out[4] = t89;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[6] = t3;
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(1 + gamma3) + 1 */
    const double t6 = p[8] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t7 = p[9]*t4; /* I3/(R^2*I1)*b */
    const double t8 = JLT_FMA(t4, t7, t6); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t9 = t3*t4; /* s*b */
    const double t10 = t5*t9; /* D/I1*s*b */
    const double t11 = t8*t10; /* Theta/(m*R^2*I1)*D/I1*s*b */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*D/I1*s*b) */
    const double t13 = t8*t12; /* 1/(s*b*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s*b) */
    const double t14 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = D/I1*s*b*1/(Theta/(m*R^2*I1)*D/I1*s*b) */
    const double t15 = t5*t13; /* 1/(s*b) = D/I1*1/(s*b*(D/I1)) */
    const double t16 = t9*t13; /* 1/(D/I1) = s*b*1/(s*b*(D/I1)) */
    const double t17 = x[3]*t3; /* omega_n*s */
    const double t18 = p[11] - t17; /* G_level/(R*I1) - omega_n*s */
    const double t19 = t3*t15; /* 1/b = s*1/(s*b) */
    const double t20 = t4*t15; /* 1/s = b*1/(s*b) */
    const double t21 = t18*t19; /* (G_level/(R*I1) - omega_n*s)*1/b */
    const double t22 = JLT_FMS(t17, t19, t21); /* omega_n*s*1/b - (G_level/(R*I1) - omega_n*s)*1/b */
    const double t23 = x[2]*t3; /* omega_tau*s */
    out[0] = t23;
    const double t24 = t3*t16; /* s*1/(D/I1) */
    const double t25 = x[3]*p[1]; /* omega_n*R */
    const double t26 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t27 = x[3]*t20; /* omega_n*1/s */
    const double t28 = t21*t25; /* (G_level/(R*I1) - omega_n*s)*1/b*omega_n*R */
    const double t29 = t23*t26; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t30 = JLT_FMA(x[0], t29, t28); /* gamma3*omega_tau*s*omega_tau*m*a3^2/I1 + (G_level/(R*I1) - omega_n*s)*1/b*omega_n*R */
    const double t31 = t4*t27; /* b*omega_n*1/s */
    const double t32 = JLT_FMS(p[20], t4, x[0]); /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = I3/(R*I1)*b - gamma3 */
    const double t33 = x[0]*t27; /* gamma3*omega_n*1/s */
    const double t34 = JLT_FNMA(x[3], t33, t30); /* t30 - omega_n*gamma3*omega_n*1/s */
    const double t35 = t16*t34; /* 1/(D/I1)*(t30 - omega_n*gamma3*omega_n*1/s) */
    const double t36 = JLT_FNMA(p[12], t24, t35); /* 1/(D/I1)*(t30 - omega_n*gamma3*omega_n*1/s) - m*g*a3/I1*s*1/(D/I1) */
    out[2] = t36;
    const double t37 = p[15]*t35; /* 2*m*a3^2/I1*1/(D/I1)*(t30 - omega_n*gamma3*omega_n*1/s) */
    const double t38 = JLT_FNMA(p[21], t24, t37); /* 2*m*a3^2/I1*1/(D/I1)*(t30 - omega_n*gamma3*omega_n*1/s) - 2*m^2*g*a3^3/I1^2*s*1/(D/I1) */
    const double t39 = p[10]*t21; /* R^2*I1/I3*(G_level/(R*I1) - omega_n*s)*1/b */
    const double t40 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t41 = p[9]*t31; /* I3/(R^2*I1)*b*omega_n*1/s */
    const double t42 = x[2]*t21; /* omega_tau*(G_level/(R*I1) - omega_n*s)*1/b */
    const double t43 = p[13] + t40; /* I3/(m*R) + e */
    const double t44 = JLT_FMA(x[2], t40, x[1]); /* V = omega_tau*e + v_nu */
    const double t45 = t7*t44; /* I3/(R^2*I1)*b*V */
    const double t46 = t14*t45; /* 1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*V */
    const double t47 = t14*t41; /* 1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*omega_n*1/s */
    const double t48 = JLT_FMA(x[2], t41, t42); /* omega_tau*I3/(R^2*I1)*b*omega_n*1/s + omega_tau*(G_level/(R*I1) - omega_n*s)*1/b */
    const double t49 = p[22]*t48; /* 1/2*a3*t48 */
    const double t50 = -t47; /* -1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*omega_n*1/s */
    out[17] = t50;
    const double t51 = x[0]*t20; /* gamma3*1/s */
    const double t52 = JLT_FMA(p[12], t51, t29); /* m*g*a3/I1*gamma3*1/s + omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t53 = JLT_FMS(p[14], t33, t39); /* R*I1/I3*gamma3*omega_n*1/s - R^2*I1/I3*(G_level/(R*I1) - omega_n*s)*1/b */
    const double t54 = t19*t53; /* 1/b*t53 */
    const double t55 = t31 - t39; /* b*omega_n*1/s - R^2*I1/I3*(G_level/(R*I1) - omega_n*s)*1/b */
    const double t56 = x[3]*t55; /* omega_n*(b*omega_n*1/s - R^2*I1/I3*(G_level/(R*I1) - omega_n*s)*1/b) */
    out[1] = t56;
    const double t57 = t14*t43; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t58 = x[2]*t43; /* omega_tau*(I3/(m*R) + e) */
    const double t59 = t54*t58; /* 1/b*t53*omega_tau*(I3/(m*R) + e) */
    const double t60 = JLT_FMA(t27, t44, t59); /* omega_n*1/s*V + 1/b*t53*omega_tau*(I3/(m*R) + e) */
    const double t61 = t44*t47; /* V*1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*omega_n*1/s */
    const double t62 = JLT_FMA(t42, t57, t61); /* omega_tau*(G_level/(R*I1) - omega_n*s)*1/b*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) + V*1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*omega_n*1/s */
    const double t63 = JLT_FNMA(t32, t62, t49); /* 1/2*a3*t48 - d(Theta)/d(gamma3)/(2*m*R^2*I1)*t62 */
    const double t64 = JLT_FMA(p[23], t60, t63); /* 1/2*I3/(R*I1)*(omega_n*1/s*V + 1/b*t53*omega_tau*(I3/(m*R) + e)) + 1/2*a3*t48 - d(Theta)/d(gamma3)/(2*m*R^2*I1)*t62 */
    const double t65 = JLT_FMS(x[2], t33, t62); /* omega_tau*gamma3*omega_n*1/s - t62 */
    out[3] = t65;
    const double t66 = 2.0*t14; /* 2*1/(Theta/(m*R^2*I1)) */
    const double t67 = JLT_FNMA(t21, t57, t33); /* gamma3*omega_n*1/s - (G_level/(R*I1) - omega_n*s)*1/b*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t68 = JLT_FNMA(t40, t47, t67); /* t67 - e*1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*omega_n*1/s */
    out[18] = t68;
    const double t69 = t23*t57; /* omega_tau*s*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t70 = t20*t27; /* 1/s*omega_n*1/s */
    const double t71 = JLT_FNMA(t27, t70, t52); /* m*g*a3/I1*gamma3*1/s + omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*1/s*1/s*omega_n*1/s */
    const double t72 = x[2]*t70; /* omega_tau*1/s*omega_n*1/s */
    const double t73 = JLT_FNMA(t51, t61, t72); /* omega_tau*1/s*omega_n*1/s - gamma3*1/s*V*1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*omega_n*1/s */
    const double t74 = x[2]*t51; /* omega_tau*gamma3*1/s */
    const double t75 = JLT_FNMA(t26, t74, t38); /* t38 - omega_tau*m*a3^2/I1*omega_tau*gamma3*1/s */
    const double t76 = t54 - t27; /* 1/b*t53 - omega_n*1/s */
    const double t77 = t25*t76; /* omega_n*R*(1/b*t53 - omega_n*1/s) */
    const double t78 = t20*t73; /* 1/s*t73 */
    const double t79 = JLT_FNMA(t64, t66, t78); /* 1/s*t73 - t64*2*1/(Theta/(m*R^2*I1)) */
    out[16] = t79;
    const double t80 = JLT_FNMA(t20, t46, t74); /* omega_tau*gamma3*1/s - 1/s*1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*V */
    const double t81 = JLT_FMA(t19, t69, t80); /* 1/b*omega_tau*s*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) + t80 */
    out[19] = t81;
    const double t82 = -t74; /* -omega_tau*gamma3*1/s */
    out[4] = t82;
    const double t83 = t20*t33; /* 1/s*gamma3*omega_n*1/s */
    const double t84 = JLT_FMS(t31, t83, t77); /* b*omega_n*1/s*1/s*gamma3*omega_n*1/s - omega_n*R*(1/b*t53 - omega_n*1/s) */
    out[8] = t84;
    const double t85 = JLT_FMA(p[19], t33, t22); /* 2/R*gamma3*omega_n*1/s + omega_n*s*1/b - (G_level/(R*I1) - omega_n*s)*1/b */
    const double t86 = p[10]*t22; /* R^2*I1/I3*(omega_n*s*1/b - (G_level/(R*I1) - omega_n*s)*1/b) */
    const double t87 = JLT_FMA(2.0, t31, t86); /* 2*b*omega_n*1/s + R^2*I1/I3*(omega_n*s*1/b - (G_level/(R*I1) - omega_n*s)*1/b) */
    out[11] = t87;
    const double t88 = x[3]*p[17]; /* omega_n*I3/I1 */
    const double t89 = JLT_FMA(t54, t88, t71); /* 1/b*t53*omega_n*I3/I1 + t71 */
    const double t90 = JLT_FMA(x[0], t75, t89); /* gamma3*(t38 - omega_tau*m*a3^2/I1*omega_tau*gamma3*1/s) + 1/b*t53*omega_n*I3/I1 + t71 */
    const double t91 = t16*t90; /* 1/(D/I1)*t90 */
    out[12] = t91;
    const double t92 = x[0]*p[15]; /* gamma3*2*m*a3^2/I1 */
    const double t93 = t23*t92; /* omega_tau*s*gamma3*2*m*a3^2/I1 */
    const double t94 = t16*t93; /* 1/(D/I1)*omega_tau*s*gamma3*2*m*a3^2/I1 */
    out[14] = t94;
    const double t95 = p[18]*t16; /* (-R)*1/(D/I1) */
    const double t96 = t85*t95; /* t85*(-R)*1/(D/I1) */
    out[15] = t96;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t5 = p[9]*t3; /* I3/(R^2*I1)*b */
    const double t6 = p[8] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t7 = JLT_FMA(p[25], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t8 = JLT_FMA(t3, t5, t6); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t9 = t5*t7; /* I3/(R^2*I1)*b*D */
    const double t10 = t4*t7; /* s*D */
    const double t11 = t8*t10; /* Theta/(m*R^2*I1)*s*D */
    const double t12 = t3*t11; /* b*Theta/(m*R^2*I1)*s*D */
    const double t13 = 1.0/t12; /* 1/(b*Theta/(m*R^2*I1)*s*D) */
    const double t14 = t3*t13; /* 1/(D*s*(Theta/(m*R^2*I1))) = b*1/(b*Theta/(m*R^2*I1)*s*D) */
    const double t15 = t8*t14; /* 1/(D*s) = Theta/(m*R^2*I1)*1/(D*s*(Theta/(m*R^2*I1))) */
    const double t16 = t10*t14; /* 1/(Theta/(m*R^2*I1)) = s*D*1/(D*s*(Theta/(m*R^2*I1))) */
    const double t17 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t18 = x[0]*p[24]; /* gamma3*2*m*a3^2 */
    const double t19 = t4*t18; /* s*gamma3*2*m*a3^2 */
    const double t20 = t15*t19; /* 1/(D*s)*s*gamma3*2*m*a3^2 */
    const double t21 = x[2]*t4; /* omega_tau*s */
    const double t22 = p[13] + t17; /* I3/(m*R) + e */
    const double t23 = t11*t22; /* Theta/(m*R^2*I1)*s*D*(I3/(m*R) + e) */
    const double t24 = t13*t23; /* 1/(b*Theta/(m*R^2*I1)*s*D)*Theta/(m*R^2*I1)*s*D*(I3/(m*R) + e) */
    const double t25 = JLT_FMA(t16, t24, t20); /* 1/(Theta/(m*R^2*I1))*t24 + 1/(D*s)*s*gamma3*2*m*a3^2 */
    const double t26 = t21*t25; /* omega_tau*s*(1/(Theta/(m*R^2*I1))*t24 + 1/(D*s)*s*gamma3*2*m*a3^2) */
    const double t27 = JLT_FMA(x[2], t17, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = t9*t27; /* I3/(R^2*I1)*b*D*V */
    const double t29 = t16*t28; /* 1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*D*V */
    const double t30 = JLT_FNMA(t15, t29, t26); /* t26 - 1/(D*s)*1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*D*V */
    out[0] = t30;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(p[25], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FNMA(x[3], t3, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t7 = t6/t5; /* (G_level/(R*I1) - omega_n*s)/b */
    const double t8 = x[3]*t5; /* omega_n*b */
    const double t9 = p[10]*t3; /* R^2*I1/I3*s */
    const double t10 = JLT_FNMA(t7, t9, t8); /* v_tau = omega_n*b - (G_level/(R*I1) - omega_n*s)/b*R^2*I1/I3*s */
    const double t11 = p[27]*x[0]; /* 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(x[1], x[1], t11); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[28]*x[2]; /* 1/m*omega_tau */
    const double t14 = x[2]*t13; /* omega_tau*1/m*omega_tau */
    const double t15 = p[29]*x[3]; /* I1/m*omega_n */
    const double t16 = JLT_FMA(x[3], t15, t12); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t17 = JLT_FMA(t4, t14, t16); /* D*omega_tau*1/m*omega_tau + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = p[30]*t7; /* R^2*I1^2/(m*I3)*(G_level/(R*I1) - omega_n*s)/b */
    const double t19 = JLT_FMA(t7, t18, t17); /* (G_level/(R*I1) - omega_n*s)/b*R^2*I1^2/(m*I3)*(G_level/(R*I1) - omega_n*s)/b + t17 */
    const double t20 = JLT_FMA(t10, t10, t19); /* energy/(1/2*m) = v_tau*v_tau + t19 */
    const double t21 = p[26]*t20; /* 1/2*m*energy/(1/2*m) */
    out[0] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = t4*t5; /* b*s */
    const double t7 = 1.0/t6; /* 1/(b*s) */
    const double t8 = x[3]*p[33]; /* omega_n*R*I1 */
    const double t9 = JLT_FNMA(t5, t8, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t10 = t5*t7; /* 1/b = s*1/(b*s) */
    const double t11 = t9*t10; /* (G_level - s*omega_n*R*I1)*1/b */
    const double t12 = x[0]*t4; /* gamma3*b */
    const double t13 = t7*t12; /* 1/(b*s)*gamma3*b */
    const double t14 = p[14]*x[3]; /* R*I1/I3*omega_n */
    const double t15 = p[32]*t11; /* R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t16 = JLT_FMS(t13, t14, t15); /* 1/(b*s)*gamma3*b*R*I1/I3*omega_n - R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t17 = t10*t16; /* 1/b*t16 */
    const double t18 = p[25]*x[0]; /* m*a3^2*gamma3 */
    const double t19 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t20 = JLT_FNMA(t18, t19, p[31]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t21 = JLT_FMA(t11, t17, t20); /* (G_level - s*omega_n*R*I1)*1/b*1/b*t16 + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t22 = JLT_FNMA(t5, t17, x[3]); /* omega_n - s*1/b*t16 */
    const double t23 = p[1]*t22; /* R*(omega_n - s*1/b*t16) */
    const double t24 = JLT_FMA(t13, t15, t23); /* d(v_tau)/d(gamma3) = 1/(b*s)*gamma3*b*R/I3*(G_level - s*omega_n*R*I1)*1/b + R*(omega_n - s*1/b*t16) */
    const double t25 = x[3]*t4; /* omega_n*b */
    const double t26 = JLT_FNMA(t5, t15, t25); /* v_tau = omega_n*b - s*R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t27 = p[14]*t5; /* R*I1/I3*s */
    const double t28 = t10*t27; /* 1/b*R*I1/I3*s */
    const double t29 = p[0]*t26; /* m*v_tau */
    const double t30 = JLT_FMA(t24, t29, t21); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau + t21 */
    out[0] = t30;
    const double t31 = x[3]*p[4]; /* omega_n*I1 */
    const double t32 = JLT_FNMA(t11, t28, t31); /* omega_n*I1 - (G_level - s*omega_n*R*I1)*1/b*1/b*R*I1/I3*s */
    const double t33 = p[10]*t3; /* R^2*I1/I3*(1 - gamma3)*(gamma3 + 1) */
    const double t34 = JLT_FMA(t10, t33, t4); /* d(v_tau)/d(omega_n) = 1/b*R^2*I1/I3*(1 - gamma3)*(gamma3 + 1) + b */
    const double t35 = JLT_FMA(t29, t34, t32); /* d(energy)/d(omega_n) = m*v_tau*d(v_tau)/d(omega_n) + omega_n*I1 - (G_level - s*omega_n*R*I1)*1/b*1/b*R*I1/I3*s */
    out[3] = t35;
    const double t36 = JLT_FMA(p[25], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t37 = x[2]*t36; /* omega_tau*D */
    out[2] = t37;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FNMA(x[3], t3, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t5 = p[35] + x[0]; /* b/R = a3/R + gamma3 */
    const double t6 = p[34]/t5; /* (-I1/I3)/(b/R) */
    const double t7 = t4*t6; /* (G_level/(R*I1) - omega_n*s)*(-I1/I3)/(b/R) */
    out[0] = t7;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
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
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t14[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t15[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t16[k] = jlt_jet_product(t14, t15, k);
        t17[k] = jlt_jet_root(t16[k], t17, k);
        t18[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t19[k] = p[7]*t16[k] + (k == 0 ? 1.0 : 0);
        t20[k] = (k == 0 ? p[8] : 0) + t16[k];
        t21[k] = p[9]*t18[k];
        t22[k] = jlt_jet_product(t18, t21, k) + t20[k];
        t23[k] = jlt_jet_product(t17, t18, k);
        t24[k] = jlt_jet_product(t19, t23, k);
        t25[k] = jlt_jet_product(t22, t24, k);
        t26[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t25, t26, k);
        t27[k] = jlt_jet_product(t22, t26, k);
        t28[k] = jlt_jet_product(t24, t26, k);
        t29[k] = jlt_jet_product(t19, t27, k);
        t30[k] = jlt_jet_product(t23, t27, k);
        t31[k] = jlt_jet_product(x3, t18, k);
        t32[k] = jlt_jet_product(t29, t31, k);
        t33[k] = jlt_jet_product(t18, t32, k);
        t34[k] = jlt_jet_product(x0, t32, k);
        t35[k] = (k == 0 ? p[11] : 0) - jlt_jet_product(x3, t17, k);
        t36[k] = jlt_jet_product(t17, t35, k);
        t37[k] = jlt_jet_product(t29, t36, k);
        t38[k] = x2[k]*p[7];
        t39[k] = jlt_jet_product(x0, t38, k);
        t40[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t41[k] = jlt_jet_product(x2, t17, k);
        t42[k] = jlt_jet_product(t39, t41, k);
        t43[k] = t42[k] - p[12]*t17[k];
        t44[k] = (k == 0 ? p[13] : 0) + t40[k];
        t45[k] = jlt_jet_product(x2, t44, k);
        t46[k] = jlt_jet_product(x2, t40, k) + x1[k];
        t47[k] = jlt_jet_product(t37, t45, k);
        t48[k] = p[9]*t46[k];
        t49[k] = jlt_jet_product(t33, t48, k) + t47[k];
        t50[k] = t33[k] - p[10]*t37[k];
        t51[k] = jlt_jet_product(x3, t50, k);
        t52[k] = t34[k] - p[1]*t37[k];
        t53[k] = t43[k] - jlt_jet_product(x3, t52, k);
        t54[k] = jlt_jet_product(t30, t53, k);
        t55[k] = jlt_jet_product(x2, t34, k);
        t56[k] = t55[k] - jlt_jet_product(t28, t49, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t41[k]/(k + 1);
        next[1] = x1[k + 1] = t51[k]/(k + 1);
        next[2] = x2[k + 1] = t54[k]/(k + 1);
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
    .sha256 = "0e279c3be65fce16666172ab5cb8604a9e517a6b4e013b63a672fd315ee5a03d",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 36,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 25, 12, 1, 1, 0, 14, 10 }, { 15, 56, 0, 10, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .jacobian = { jacobian, 16, { 8, 51, 29, 1, 1, 0, 17, 22 }, { 45, 230, 0, 42, 1, 0, 18, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 20, { 9, 54, 32, 1, 1, 0, 20, 26 }, { 52, 265, 0, 51, 1, 0, 18, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .divergence = { divergence, 1, { 4, 18, 7, 1, 1, 0, 13, 10 }, { 10, 39, 0, 4, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_values = { integral_values, 1, { 2, 9, 9, 1, 1, 0, 9, 7 }, { 10, 31, 0, 1, 1, 0, 13, 6 },
        "divides by b: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_gradients = { integral_gradients, 4, { 2, 21, 13, 1, 1, 0, 14, 11 }, { 15, 53, 0, 6, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 2, 1, 1, 1, 0, 5, 3 }, { 3, 6, 0, 1, 1, 0, 6, 4 },
        "divides by b: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
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
