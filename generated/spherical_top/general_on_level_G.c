/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 fc02698dfaa723ad1ea75564f8c31787118d59caf1a28dca9dba5c224a5c0918
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   24   11    1    1    0     13   10   (83)
 *  jacobian            12   50   26    1    1    0     16   23   (327)
 *  rhs_jacobian        9   57   31    1    1    0     17   23   (379)
 *  divergence          2   14   10    1    1    0     15    7   (57)
 *  integral_values     3   12    8    1    1    0      8    8   (43)
 *  integral_gradients  3   17   12    1    1    0     10   11   (72)
 *  eliminated          3    3    1    1    1    0      4    4   (11)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, b*I3*omega3 + G_level,
 *      m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), e = gamma3*a3 + R, a part of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(omega3)/dt)/d(omega_tau),
 *      a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(numerator of d(omega_tau)/dt over D)/d(gamma3),
 *      d(numerator of d(omega3)/dt over Theta)/d(gamma3), a part of d(d(omega3)/dt)/d(omega3),
 *      numerator of d(omega_tau)/dt over D, a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(omega3), d(d(v_nu)/dt)/d(omega3),
 *      d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), a part of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(v_nu)/dt, a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_claim jlt_claims_spherical_top[];
extern const jlt_descriptor *const jlt_family_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_on_level_G;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[4]*params[4]; /* I1*I1 */
    const double t1 = params[1]*t0; /* R*I1*I1 */
    const double t2 = 1.0/t1; /* 1/(R*I1*I1) */
    out[7] = t2;
    const double t3 = params[3]/params[1]; /* a3/R */
    out[8] = t3;
    const double t4 = params[1]*params[5]; /* R*I3 */
    out[9] = t4;
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[10] = t6;
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = params[0]*t7; /* m*R*R */
    out[50] = t8;
    const double t9 = params[5]/t8; /* I3/(m*R*R) */
    out[11] = t9;
    const double t10 = params[5]/params[4]; /* I3/I1 */
    out[12] = t10;
    const double t11 = params[1]*params[4]; /* R*I1 */
    out[13] = t11;
    const double t12 = params[0]*params[2]; /* m*g */
    const double t13 = params[3]*t12; /* a3*m*g */
    out[14] = t13;
    const double t14 = params[4]*t7; /* I1*R*R */
    const double t15 = 1.0/t14; /* 1/(I1*R*R) */
    out[15] = t15;
    const double t16 = params[4] - params[5]; /* I1 - I3 */
    const double t17 = t16/params[4]; /* (I1 - I3)/I1 */
    out[16] = t17;
    const double t18 = params[3]*params[5]; /* a3*I3 */
    const double t19 = t18/t11; /* a3*I3/(R*I1) */
    out[17] = t19;
    const double t20 = 1.0/params[4]; /* 1/I1 */
    out[18] = t20;
    const double t21 = 2.0/t11; /* 2/(R*I1) */
    out[19] = t21;
    const double t22 = params[5]*2.0; /* I3*2 */
    const double t23 = t22/t0; /* I3*2/(I1*I1) */
    out[20] = t23;
    const double t24 = t8*params[2]; /* m*R*R*g */
    const double t25 = params[3]*t24; /* a3*m*R*R*g */
    const double t26 = params[4]*t25; /* I1*a3*m*R*R*g */
    out[21] = t26;
    const double t27 = t5*t8; /* a3*a3*m*R*R */
    const double t28 = params[4]*t27; /* I1*a3*a3*m*R*R */
    out[22] = t28;
    const double t29 = params[0]*2.0; /* m*2 */
    const double t30 = t5*t29; /* a3*a3*m*2 */
    out[23] = t30;
    const double t31 = params[5]*(-2.0); /* I3*(-2) */
    const double t32 = t31/t11; /* I3*(-2)/(R*I1) */
    out[24] = t32;
    const double t33 = params[3]*2.0; /* a3*2 */
    const double t34 = params[5]*t33; /* I3*a3*2 */
    const double t35 = t34/t11; /* I3*a3*2/(R*I1) */
    out[25] = t35;
    const double t36 = t16*2.0; /* (I1 - I3)*2 */
    const double t37 = t36/params[4]; /* (I1 - I3)*2/I1 */
    out[26] = t37;
    const double t38 = t7*2.0; /* R*R*2 */
    const double t39 = params[4]*t38; /* I1*R*R*2 */
    out[27] = t39;
    const double t40 = params[3]/t39; /* a3/(I1*R*R*2) */
    out[28] = t40;
    const double t41 = params[5]/t11; /* I3/(R*I1) */
    out[29] = t41;
    const double t42 = 1.0/t11; /* 1/(R*I1) */
    out[30] = t42;
    const double t43 = params[4]*params[5]; /* I1*I3 */
    out[31] = t43;
    const double t44 = params[4]*t8; /* I1*m*R*R */
    out[32] = t44;
    const double t45 = params[5]*params[0]; /* I3*m */
    out[33] = t45;
    const double t46 = 1.0/params[1]; /* 1/R */
    out[34] = t46;
    const double t47 = params[1]*params[0]; /* R*m */
    const double t48 = params[3]*t47; /* a3*R*m */
    const double t49 = params[5]*t48; /* I3*a3*R*m */
    out[35] = t49;
    const double t50 = t8*t16; /* m*R*R*(I1 - I3) */
    out[36] = t50;
    const double t51 = t22/t11; /* I3*2/(R*I1) */
    out[37] = t51;
    const double t52 = t13/params[4]; /* a3*m*g/I1 */
    out[38] = t52;
    const double t53 = params[4]*2.0; /* I1*2 */
    out[39] = t53;
    const double t54 = t22/params[1]; /* I3*2/R */
    out[40] = t54;
    const double t55 = params[3]*params[0]; /* a3*m */
    out[41] = t55;
    const double t56 = params[4]*t47; /* I1*R*m */
    out[42] = t56;
    const double t57 = t7*t29; /* R*R*m*2 */
    const double t58 = params[4]*t57; /* I1*R*R*m*2 */
    out[43] = t58;
    const double t59 = params[1]*t29; /* R*m*2 */
    const double t60 = params[5]*t59; /* I3*R*m*2 */
    out[44] = t60;
    const double t61 = params[0]/2.0; /* m/2 */
    out[45] = t61;
    const double t62 = params[2]*2.0; /* g*2 */
    const double t63 = params[3]*t62; /* a3*g*2 */
    out[46] = t63;
    const double t64 = 1.0/params[0]; /* 1/m */
    out[47] = t64;
    const double t65 = 1.0/t44; /* 1/(I1*m*R*R) */
    out[48] = t65;
    const double t66 = params[5]/params[0]; /* I3/m */
    out[49] = t66;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t4 = p[12]*t3; /* I3/I1*b/R */
    const double t5 = p[11] + t2; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + I3/(m*R^2) + s^2 */
    const double t7 = JLT_FMA(p[10], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t6*t7; /* Theta/(m*R^2*I1)*D */
    const double t9 = t2*t8; /* s^2*Theta/(m*R^2*I1)*D */
    const double t10 = 1.0/t9; /* 1/(s^2*Theta/(m*R^2*I1)*D) */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    const double t12 = t8*t11; /* Theta/(m*R^2*I1)*D*s */
    const double t13 = t10*t12; /* 1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s */
    const double t14 = t2*t10; /* 1/(D*(Theta/(m*R^2*I1))) = s^2*1/(s^2*Theta/(m*R^2*I1)*D) */
    const double t15 = t6*t14; /* Theta/(m*R^2*I1)*1/(D*(Theta/(m*R^2*I1))) */
    const double t16 = t7*t14; /* D*1/(D*(Theta/(m*R^2*I1))) */
    const double t17 = x[2]*t11; /* omega_tau*s */
    out[0] = t17;
    const double t18 = p[9]*x[3]; /* R*I3*omega3 */
    const double t19 = JLT_FMA(t3, t18, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t20 = t13*t19; /* 1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t21 = t13*t20; /* 1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 */
    const double t22 = t3*t21; /* b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 */
    const double t23 = JLT_FMA(x[0], t21, t18); /* gamma3*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 + R*I3*omega3 */
    const double t24 = JLT_FMA(x[3], p[13], t22); /* omega3*R*I1 + b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 */
    const double t25 = x[0]*t17; /* gamma3*omega_tau*s */
    const double t26 = x[2]*p[10]; /* omega_tau*m*a3^2 */
    const double t27 = t25*t26; /* gamma3*omega_tau*s*omega_tau*m*a3^2 */
    const double t28 = JLT_FNMA(p[14], t11, t27); /* gamma3*omega_tau*s*omega_tau*m*a3^2 - m*g*a3*s */
    const double t29 = p[16]*t25; /* (I1 - I3)/I1*gamma3*omega_tau*s */
    const double t30 = JLT_FNMA(p[17], t17, t29); /* (I1 - I3)/I1*gamma3*omega_tau*s - a3*I3/(R*I1)*omega_tau*s */
    const double t31 = x[3]*t30; /* omega3*((I1 - I3)/I1*gamma3*omega_tau*s - a3*I3/(R*I1)*omega_tau*s) */
    const double t32 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t33 = JLT_FMA(x[2], t32, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = p[15]*t20; /* 1/(R^2*I1)*t20 */
    const double t35 = JLT_FNMA(t23, t34, t28); /* gamma3*omega_tau*s*omega_tau*m*a3^2 - m*g*a3*s - t23*1/(R^2*I1)*t20 */
    const double t36 = JLT_FNMA(t33, t34, t31); /* t31 - V*1/(R^2*I1)*t20 */
    const double t37 = t15*t35; /* Theta/(m*R^2*I1)*1/(D*(Theta/(m*R^2*I1)))*t35 */
    out[2] = t37;
    const double t38 = t16*t36; /* D*1/(D*(Theta/(m*R^2*I1)))*(t31 - V*1/(R^2*I1)*t20) */
    out[3] = t38;
    const double t39 = p[7]*t20; /* 1/(R*I1^2)*t20 */
    const double t40 = t24*t39; /* t24*1/(R*I1^2)*t20 */
    out[1] = t40;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = JLT_FMA(t2, p[10], p[4]); /* D = s^2*m*a3^2 + I1 */
    const double t5 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t6 = t5*p[12]; /* b/R*I3/I1 */
    const double t7 = t2 + p[11]; /* s^2 + I3/(m*R^2) */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta/(m*R^2*I1) = b/R*b/R*I3/I1 + s^2 + I3/(m*R^2) */
    const double t9 = t2*t4; /* s^2*D */
    const double t10 = t8*t9; /* Theta/(m*R^2*I1)*s^2*D */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t12 = t8*t11; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t13 = t3*t4; /* s*D */
    const double t14 = t12*t13; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D */
    const double t15 = x[0]*t14; /* gamma3*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D */
    const double t16 = x[2]*t15; /* omega_tau*gamma3*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D */
    const double t17 = -t16; /* -t16 */
    out[0] = t17;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    const double t18 = p[9]*x[3]; /* R*I3*omega3 */
    const double t19 = JLT_FMA(t5, t18, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t20 = t14*t19; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*(b/R*R*I3*omega3 + G_level) */
    const double t21 = t14*t20; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*t20 */
    const double t22 = x[0]*t21; /* gamma3*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*t20 */
    const double t23 = t18 + t22; /* R*I3*omega3 + gamma3*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*t20 */
    const double t24 = t14*t23; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*t23 */
    const double t25 = t5*t14; /* b/R*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D */
    const double t26 = t20*t25; /* t20*b/R*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D */
    const double t27 = JLT_FMA(p[19], t26, x[3]); /* 2/(R*I1)*t20*b/R*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D + omega3 */
    const double t28 = p[18]*t27; /* 1/I1*t27 */
    const double t29 = t24*t28; /* d(omega_n)/d(gamma3)/(1/(R*I1))*1/I1*t27 */
    const double t30 = t22*t25; /* gamma3*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*t20*b/R*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D */
    const double t31 = t20 + t30; /* t20 + t30 */
    const double t32 = t21*p[7]; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*t20*1/(R*I1^2) */
    const double t33 = JLT_FMA(t31, t32, t29); /* (t20 + t30)*t32 + d(omega_n)/d(gamma3)/(1/(R*I1))*1/I1*t27 */
    out[4] = t33;
    const double t34 = JLT_FMA(t18, t25, t20); /* R*I3*omega3*b/R*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D + t20 */
    const double t35 = p[18]*t34; /* 1/I1*t34 */
    const double t36 = t25*p[20]; /* b/R*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*2*I3/I1^2 */
    const double t37 = JLT_FMA(t26, t36, t35); /* t20*b/R*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*t36 + 1/I1*t34 */
    out[7] = t37;
    const double t38 = t15*p[21]; /* gamma3*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*m*R^2*g*a3*I1 */
    const double t39 = t14*t21; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*t20 */
    const double t40 = t2*t12; /* 1/D = s^2*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t41 = x[0]*p[23]; /* gamma3*2*m*a3^2 */
    const double t42 = t40*t41; /* 1/D*gamma3*2*m*a3^2 */
    const double t43 = x[2]*t3; /* omega_tau*s */
    const double t44 = t42*t43; /* 1/D*gamma3*2*m*a3^2*omega_tau*s */
    out[10] = t44;
    const double t45 = t44 - t16; /* 1/D*gamma3*2*m*a3^2*omega_tau*s - t16 */
    const double t46 = JLT_FMA(x[0], t45, t43); /* gamma3*(1/D*gamma3*2*m*a3^2*omega_tau*s - t16) + omega_tau*s */
    const double t47 = x[2]*p[22]; /* omega_tau*m*R^2*a3^2*I1 */
    const double t48 = t3*p[21]; /* s*m*R^2*g*a3*I1 */
    const double t49 = JLT_FMA(t20, t23, t48); /* t20*t23 + s*m*R^2*g*a3*I1 */
    const double t50 = JLT_FMA(t22, 2.0, t18); /* gamma3*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*t20*2 + R*I3*omega3 */
    const double t51 = JLT_FNMA(t21, t39, t38); /* t38 - Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*t20*t39 */
    const double t52 = JLT_FMA(t46, t47, t51); /* (gamma3*(1/D*gamma3*2*m*a3^2*omega_tau*s - t16) + omega_tau*s)*omega_tau*m*R^2*a3^2*I1 + t51 */
    const double t53 = JLT_FNMA(t24, t50, t52); /* t52 - d(omega_n)/d(gamma3)/(1/(R*I1))*t50 */
    const double t54 = JLT_FNMA(t42, t49, t53); /* t52 - d(omega_n)/d(gamma3)/(1/(R*I1))*t50 - 1/D*gamma3*2*m*a3^2*(t20*t23 + s*m*R^2*g*a3*I1) */
    const double t55 = p[15]*t40; /* 1/(R^2*I1)*1/D */
    const double t56 = t54*t55; /* t54*1/(R^2*I1)*1/D */
    out[8] = t56;
    const double t57 = JLT_FMA(t34, (1.0 / 2.0), t30); /* t34*1/2 + t30 */
    const double t58 = t40*p[24]; /* 1/D*(-2*I3/(R*I1)) */
    const double t59 = t57*t58; /* (t34*1/2 + t30)*1/D*(-2*I3/(R*I1)) */
    out[11] = t59;
    const double t60 = t9*t11; /* 1/(Theta/(m*R^2*I1)) = s^2*D*1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t61 = x[3]*t60; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t62 = t6 - x[0]; /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = b/R*I3/I1 - gamma3 */
    const double t63 = JLT_FNMA(x[0], p[26], p[25]); /* 2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1 */
    const double t64 = t62*t63; /* d(Theta)/d(gamma3)/(2*m*R^2*I1)*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) */
    const double t65 = JLT_FMA(t60, t64, p[16]); /* 1/(Theta/(m*R^2*I1))*t64 + (I1 - I3)/I1 */
    const double t66 = t43*t61; /* omega_tau*s*omega3*1/(Theta/(m*R^2*I1)) */
    const double t67 = t65*t66; /* (1/(Theta/(m*R^2*I1))*t64 + (I1 - I3)/I1)*omega_tau*s*omega3*1/(Theta/(m*R^2*I1)) */
    const double t68 = JLT_FNMA(x[0], p[16], p[17]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t69 = t61*t68; /* omega3*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t70 = x[2]*p[28]; /* omega_tau*1/2*a3/(R^2*I1) */
    const double t71 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t72 = JLT_FMA(x[2], t71, x[1]); /* V = omega_tau*e + v_nu */
    const double t73 = p[15]*t60; /* 1/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t74 = t72*t73; /* V*1/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t75 = JLT_FNMA(t62, t74, t70); /* omega_tau*1/2*a3/(R^2*I1) - d(Theta)/d(gamma3)/(2*m*R^2*I1)*V*1/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t76 = t20*t73; /* t20*1/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t77 = p[27]*t76; /* 2*R^2*I1*t20*1/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t78 = JLT_FMA(t16, t69, t67); /* t16*t69 + t67 */
    const double t79 = JLT_FNMA(t75, t77, t78); /* t16*t69 + t67 - t75*2*R^2*I1*t20*1/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t80 = JLT_FNMA(t24, t74, t79); /* t79 - d(omega_n)/d(gamma3)/(1/(R*I1))*V*1/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    out[12] = t80;
    const double t81 = -t76; /* -t20*1/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    out[13] = t81;
    const double t82 = t3*t69; /* s*t69 */
    const double t83 = JLT_FMA(t71, t76, t82); /* e*t20*1/(R^2*I1)*1/(Theta/(m*R^2*I1)) + s*t69 */
    const double t84 = -t83; /* -(e*t20*1/(R^2*I1)*1/(Theta/(m*R^2*I1)) + s*t69) */
    out[14] = t84;
    const double t85 = t72*p[29]; /* V*I3/(R*I1) */
    const double t86 = t25*t85; /* b/R*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s*D*V*I3/(R*I1) */
    const double t87 = JLT_FMA(t43, t68, t86); /* omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + t86 */
    const double t88 = t60*t87; /* 1/(Theta/(m*R^2*I1))*(omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + t86) */
    const double t89 = -t88; /* -t88 */
    out[15] = t89;
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
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[33]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[32], t2, p[31]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[10], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t6*t7; /* Theta*D */
    const double t9 = t2*t8; /* s^2*Theta*D */
    const double t10 = 1.0/t9; /* 1/(s^2*Theta*D) */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t11;
    const double t12 = t8*t11; /* Theta*D*s */
    const double t13 = t10*t12; /* 1/(s^2*Theta*D)*Theta*D*s */
    const double t14 = t2*t10; /* 1/(D*Theta) = s^2*1/(s^2*Theta*D) */
    const double t15 = t6*t14; /* 1/D = Theta*1/(D*Theta) */
    const double t16 = t7*t14; /* 1/Theta = D*1/(D*Theta) */
    const double t17 = p[5]*x[3]; /* I3*omega3 */
    const double t18 = JLT_FMA(t3, t17, p[6]); /* b*I3*omega3 + G_level */
    const double t19 = t13*t18; /* 1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t20 = JLT_FNMA(x[0], p[36], p[35]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t21 = p[30]*t19; /* 1/(R*I1)*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t22 = x[2]*p[10]; /* omega_tau*m*a3^2 */
    const double t23 = x[3]*t20; /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t24 = x[2]*t13; /* omega_tau*1/(s^2*Theta*D)*Theta*D*s */
    const double t25 = t13*t21; /* 1/(s^2*Theta*D)*Theta*D*s*1/(R*I1)*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t26 = x[0]*t22; /* gamma3*omega_tau*m*a3^2 */
    const double t27 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t28 = x[0]*t24; /* gamma3*omega_tau*1/(s^2*Theta*D)*Theta*D*s */
    const double t29 = -t28; /* -gamma3*omega_tau*1/(s^2*Theta*D)*Theta*D*s */
    out[4] = t29;
    const double t30 = t26*t28; /* gamma3*omega_tau*m*a3^2*gamma3*omega_tau*1/(s^2*Theta*D)*Theta*D*s */
    const double t31 = x[0]*t23; /* gamma3*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t32 = JLT_FNMA(p[41], t18, t31); /* gamma3*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) - m*a3*(b*I3*omega3 + G_level) */
    const double t33 = t24*t32; /* omega_tau*1/(s^2*Theta*D)*Theta*D*s*t32 */
    const double t34 = x[2]*t11; /* omega_tau*s */
    out[0] = t34;
    const double t35 = JLT_FMS(t22, t34, t30); /* omega_tau*m*a3^2*omega_tau*s - t30 */
    const double t36 = t26*t34; /* gamma3*omega_tau*m*a3^2*omega_tau*s */
    const double t37 = JLT_FNMA(p[14], t11, t36); /* gamma3*omega_tau*m*a3^2*omega_tau*s - m*g*a3*s */
    const double t38 = x[0]*t25; /* gamma3*t25 */
    const double t39 = JLT_FMA(p[39], t38, t17); /* 2*I1*gamma3*t25 + I3*omega3 */
    const double t40 = JLT_FMA(x[2], t27, x[1]); /* V = omega_tau*e + v_nu */
    const double t41 = p[0]*t19; /* m*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t42 = t27*t41; /* e*m*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t43 = JLT_FMA(t11, t23, t42); /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*m*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t44 = t16*t43; /* 1/Theta*t43 */
    const double t45 = -t44; /* -1/Theta*t43 */
    out[18] = t45;
    const double t46 = t3*t13; /* b*1/(s^2*Theta*D)*Theta*D*s */
    const double t47 = x[3]*p[29]; /* omega3*I3/(R*I1) */
    const double t48 = JLT_FMA(t46, t47, t21); /* b*1/(s^2*Theta*D)*Theta*D*s*omega3*I3/(R*I1) + 1/(R*I1)*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t49 = x[0]*p[38]; /* gamma3*m*g*a3/I1 */
    const double t50 = JLT_FNMA(t25, t25, t49); /* gamma3*m*g*a3/I1 - t25*t25 */
    const double t51 = JLT_FMA(x[3], p[12], t38); /* omega3*I3/I1 + gamma3*t25 */
    const double t52 = t38*t46; /* gamma3*t25*b*1/(s^2*Theta*D)*Theta*D*s */
    const double t53 = t40*t41; /* V*m*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t54 = JLT_FMA(t23, t34, t53); /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*s + V*m*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t55 = t16*t54; /* 1/Theta*t54 */
    const double t56 = t16*t41; /* 1/Theta*m*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t57 = -t56; /* -1/Theta*m*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    out[17] = t57;
    const double t58 = -t55; /* -1/Theta*t54 */
    out[3] = t58;
    const double t59 = p[4]*t13; /* I1*1/(s^2*Theta*D)*Theta*D*s */
    const double t60 = JLT_FMA(t50, t59, t35); /* (gamma3*m*g*a3/I1 - t25*t25)*I1*1/(s^2*Theta*D)*Theta*D*s + omega_tau*m*a3^2*omega_tau*s - t30 */
    const double t61 = t13*t51; /* d(omega_n)/d(gamma3) = 1/(s^2*Theta*D)*Theta*D*s*(omega3*I3/I1 + gamma3*t25) */
    const double t62 = JLT_FNMA(t39, t61, t60); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t60 - (2*I1*gamma3*t25 + I3*omega3)*d(omega_n)/d(gamma3) */
    const double t63 = x[3]*p[36]; /* omega3*m*R^2*(I1 - I3) */
    const double t64 = JLT_FMA(t34, t63, t33); /* omega_tau*s*omega3*m*R^2*(I1 - I3) + omega_tau*1/(s^2*Theta*D)*Theta*D*s*t32 */
    const double t65 = p[33]*t40; /* m*I3*V */
    const double t66 = p[42]*t40; /* m*R*I1*V */
    const double t67 = JLT_FNMA(t61, t66, t64); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = t64 - d(omega_n)/d(gamma3)*m*R*I1*V */
    const double t68 = t46*t65; /* b*1/(s^2*Theta*D)*Theta*D*s*m*I3*V */
    const double t69 = JLT_FMA(t20, t34, t68); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*s + b*1/(s^2*Theta*D)*Theta*D*s*m*I3*V */
    const double t70 = p[37]*t46; /* 2*I3/(R*I1)*b*1/(s^2*Theta*D)*Theta*D*s */
    const double t71 = t16*t69; /* 1/Theta*t69 */
    const double t72 = -t71; /* -1/Theta*t69 */
    out[19] = t72;
    const double t73 = p[34]*t19; /* 1/R*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t74 = JLT_FNMA(t51, t73, t37); /* numerator of d(omega_tau)/dt over D = gamma3*omega_tau*m*a3^2*omega_tau*s - m*g*a3*s - (omega3*I3/I1 + gamma3*t25)*1/R*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) */
    const double t75 = JLT_FMA(p[18], t19, t52); /* 1/I1*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level) + gamma3*t25*b*1/(s^2*Theta*D)*Theta*D*s */
    const double t76 = t25*t75; /* t25*t75 */
    const double t77 = t3*t25; /* b*t25 */
    const double t78 = t15*t74; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t78;
    const double t79 = x[0]*p[23]; /* gamma3*2*m*a3^2 */
    const double t80 = t15*t79; /* 1/D*gamma3*2*m*a3^2 */
    const double t81 = JLT_FMA(t74, t80, t62); /* numerator of d(omega_tau)/dt over D*1/D*gamma3*2*m*a3^2 + d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    const double t82 = t34*t80; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[14] = t82;
    const double t83 = t15*t81; /* 1/D*t81 */
    out[12] = t83;
    const double t84 = p[5]*t48; /* I3*t48 */
    const double t85 = JLT_FMA(p[40], t52, t84); /* 2*I3/R*gamma3*t25*b*1/(s^2*Theta*D)*Theta*D*s + I3*t48 */
    const double t86 = t15*t85; /* 1/D*(2*I3/R*gamma3*t25*b*1/(s^2*Theta*D)*Theta*D*s + I3*t48) */
    const double t87 = -t86; /* -1/D*(2*I3/R*gamma3*t25*b*1/(s^2*Theta*D)*Theta*D*s + I3*t48) */
    out[15] = t87;
    const double t88 = p[1]*t48; /* R*t48 */
    const double t89 = JLT_FMA(t70, t77, t88); /* 2*I3/(R*I1)*b*1/(s^2*Theta*D)*Theta*D*s*b*t25 + R*t48 */
    out[11] = t89;
    const double t90 = x[0]*p[43]; /* gamma3*2*m*R^2*I1 */
    const double t91 = JLT_FMS(p[44], t3, t90); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t92 = JLT_FMA(t55, t91, t67); /* 1/Theta*t54*d(Theta)/d(gamma3) + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t93 = t16*t92; /* 1/Theta*t92 */
    out[16] = t93;
    const double t94 = p[1]*x[3]; /* R*omega3 */
    const double t95 = t77 + t94; /* b*t25 + R*omega3 */
    const double t96 = t21*t95; /* 1/(R*I1)*1/(s^2*Theta*D)*Theta*D*s*(b*I3*omega3 + G_level)*(b*t25 + R*omega3) */
    out[1] = t96;
    const double t97 = JLT_FMA(2.0, t77, t94); /* 2*b*t25 + R*omega3 */
    const double t98 = JLT_FMA(t61, t97, t76); /* d(omega_n)/d(gamma3)*(2*b*t25 + R*omega3) + t25*t75 */
    out[8] = t98;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[33]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[32], t2, p[31]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[10], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t6*t7; /* Theta*D */
    const double t9 = p[23]*t6; /* 2*m*a3^2*Theta */
    const double t10 = t2*t8; /* s^2*Theta*D */
    const double t11 = 1.0/t10; /* 1/(s^2*Theta*D) */
    const double t12 = t8*t11; /* 1/s^2 = Theta*D*1/(s^2*Theta*D) */
    const double t13 = t2*t11; /* 1/(D*Theta) = s^2*1/(s^2*Theta*D) */
    const double t14 = sqrt(t2); /* s = sqrt(s^2) */
    const double t15 = JLT_FMS(t9, t13, t12); /* 2*m*a3^2*Theta*1/(D*Theta) - 1/s^2 */
    const double t16 = t7*t14; /* D*s */
    const double t17 = t14*t15; /* s*(2*m*a3^2*Theta*1/(D*Theta) - 1/s^2) */
    const double t18 = t13*t16; /* 1/(D*Theta)*D*s */
    const double t19 = JLT_FMA(p[36], t18, t17); /* m*R^2*(I1 - I3)*1/(D*Theta)*D*s + s*(2*m*a3^2*Theta*1/(D*Theta) - 1/s^2) */
    const double t20 = x[0]*t19; /* gamma3*t19 */
    const double t21 = JLT_FNMA(p[35], t18, t20); /* gamma3*t19 - m*R*a3*I3*1/(D*Theta)*D*s */
    const double t22 = x[2]*t21; /* omega_tau*(gamma3*t19 - m*R*a3*I3*1/(D*Theta)*D*s) */
    const double t23 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t24 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t25 = t4*t24; /* m*I3*b*V */
    const double t26 = t12*t25; /* 1/s^2*m*I3*b*V */
    const double t27 = JLT_FNMA(t18, t26, t22); /* omega_tau*(gamma3*t19 - m*R*a3*I3*1/(D*Theta)*D*s) - 1/(D*Theta)*D*s*1/s^2*m*I3*b*V */
    out[0] = t27;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t4 = p[9]*x[3]; /* R*I3*omega3 */
    const double t5 = JLT_FMA(t3, t4, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t6 = t5/t2; /* (b/R*R*I3*omega3 + G_level)/s^2 */
    const double t7 = p[18]*t3; /* 1/I1*b/R */
    const double t8 = p[46]*x[0]; /* 2*g*a3*gamma3 */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t10 = p[47]*x[2]; /* 1/m*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/m*omega_tau */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    const double t13 = JLT_FMA(p[10], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t14 = t6*t12; /* (b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t15 = t7*t14; /* 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t16 = x[3]*p[49]; /* omega3*I3/m */
    const double t17 = JLT_FMA(x[3], t16, t9); /* omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = JLT_FMA(t11, t13, t17); /* omega_tau*1/m*omega_tau*D + omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t19 = p[48]*t14; /* 1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t20 = JLT_FMA(t14, t19, t18); /* (b/R*R*I3*omega3 + G_level)/s^2*s*1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s^2*s + t18 */
    const double t21 = x[3]*p[1]; /* omega3*R */
    const double t22 = JLT_FMA(t12, t21, t15); /* v_tau = s*omega3*R + 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t23 = JLT_FMA(t22, t22, t20); /* energy/(1/2*m) = v_tau*v_tau + t20 */
    const double t24 = p[45]*t23; /* 1/2*m*energy/(1/2*m) */
    out[0] = t24;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = JLT_FMA(p[10], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*t5; /* omega_tau*D */
    out[2] = t6;
    const double t7 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t8 = x[3]*p[9]; /* omega3*R*I3 */
    const double t9 = JLT_FMA(t7, t8, p[6]); /* b/R*omega3*R*I3 + G_level */
    const double t10 = 1.0/t4; /* 1/s */
    const double t11 = t9*t10; /* (b/R*omega3*R*I3 + G_level)*1/s */
    const double t12 = p[12]*t10; /* I3/I1*1/s */
    const double t13 = p[30]*t11; /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t14 = p[34]*t11; /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t15 = x[0]*t10; /* gamma3*1/s */
    const double t16 = p[10]*x[0]; /* m*a3^2*gamma3 */
    const double t17 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t18 = JLT_FNMA(t16, t17, p[14]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t19 = x[3]*t12; /* omega3*I3/I1*1/s */
    const double t20 = t10*t15; /* 1/s*gamma3*1/s */
    const double t21 = JLT_FMA(t13, t20, t19); /* d(omega_n)/d(gamma3) = 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*1/s*gamma3*1/s + omega3*I3/I1*1/s */
    const double t22 = JLT_FMA(t14, t21, t18); /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s*d(omega_n)/d(gamma3) + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t23 = JLT_FNMA(x[3], t15, t13); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t24 = JLT_FMA(t7, t21, t23); /* d(v_tau)/d(gamma3)/R = b/R*d(omega_n)/d(gamma3) + 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t25 = t7*t13; /* b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t26 = JLT_FMA(t10, t25, x[3]); /* 1/s*b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s + omega3 */
    const double t27 = JLT_FMA(x[3], t4, t25); /* v_tau/R = omega3*s + b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t28 = t7*t7; /* b/R*b/R */
    const double t29 = JLT_FMA(t12, t28, t4); /* d(v_tau)/d(omega3)/R = I3/I1*1/s*b/R*b/R + s */
    const double t30 = p[50]*t27; /* m*R^2*v_tau/R */
    const double t31 = JLT_FMA(t24, t30, t22); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R + t22 */
    out[0] = t31;
    const double t32 = p[5]*t26; /* I3*(1/s*b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s + omega3) */
    const double t33 = JLT_FMA(t29, t30, t32); /* d(energy)/d(omega3) = d(v_tau)/d(omega3)/R*m*R^2*v_tau/R + t32 */
    out[3] = t33;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0] + p[8]; /* b/R = gamma3 + a3/R */
    const double t5 = p[9]*x[3]; /* R*I3*omega3 */
    const double t6 = JLT_FMA(t4, t5, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t7 = p[30]*t6; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level) */
    const double t8 = t7/t3; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level)/s */
    out[0] = t8;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
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
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t20[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t21[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t22[k] = jlt_jet_product(t20, t21, k);
        t23[k] = x0[k] + (k == 0 ? p[8] : 0);
        t24[k] = jlt_jet_root(t22[k], t24, k);
        t25[k] = p[10]*t22[k] + (k == 0 ? p[4] : 0);
        t26[k] = (k == 0 ? p[11] : 0) + t22[k];
        t27[k] = p[12]*t23[k];
        t28[k] = jlt_jet_product(t23, t27, k) + t26[k];
        t29[k] = jlt_jet_product(t24, t25, k);
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t30, t31, k);
        t32[k] = jlt_jet_product(t28, t31, k);
        t33[k] = jlt_jet_product(t29, t31, k);
        t34[k] = jlt_jet_product(t25, t32, k);
        t35[k] = jlt_jet_product(t24, t32, k);
        t36[k] = jlt_jet_product(x2, t24, k);
        t37[k] = p[9]*x3[k];
        t38[k] = jlt_jet_product(t23, t37, k) + (k == 0 ? p[6] : 0);
        t39[k] = jlt_jet_product(t34, t38, k);
        t40[k] = jlt_jet_product(t34, t39, k);
        t41[k] = jlt_jet_product(t23, t40, k);
        t42[k] = jlt_jet_product(x0, t40, k) + t37[k];
        t43[k] = x3[k]*p[13] + t41[k];
        t44[k] = jlt_jet_product(x0, t36, k);
        t45[k] = x2[k]*p[10];
        t46[k] = jlt_jet_product(t44, t45, k);
        t47[k] = t46[k] - p[14]*t24[k];
        t48[k] = p[16]*t44[k];
        t49[k] = t48[k] - p[17]*t36[k];
        t50[k] = jlt_jet_product(x3, t49, k);
        t51[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t52[k] = jlt_jet_product(x2, t51, k) + x1[k];
        t53[k] = p[15]*t39[k];
        t54[k] = t47[k] - jlt_jet_product(t42, t53, k);
        t55[k] = t50[k] - jlt_jet_product(t52, t53, k);
        t56[k] = jlt_jet_product(t35, t54, k);
        t57[k] = jlt_jet_product(t33, t55, k);
        t58[k] = p[7]*t39[k];
        t59[k] = jlt_jet_product(t43, t58, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t36[k]/(k + 1);
        next[1] = x1[k + 1] = t59[k]/(k + 1);
        next[2] = x2[k + 1] = t56[k]/(k + 1);
        next[3] = x3[k + 1] = t57[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_R = params[1];
    const double v_I1 = params[4];
    const double v_G_level = params[6];
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double v_a3 = params[3];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega_n = ((v_G_level + v_I3*v_omega3*v_b)/(v_R*v_I1*v_s));
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
    out[3] = (-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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

const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "fc02698dfaa723ad1ea75564f8c31787118d59caf1a28dca9dba5c224a5c0918",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 51,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 24, 11, 1, 1, 0, 13, 10 }, { 15, 58, 0, 9, 1, 0, 10, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*(R*I3)*omega3 + G_level, a part of d(omega_tau)/dt, a part of d(v_nu)/dt, ((I1 - I3)/I1)*gamma3*omega_tau*s - (a3*I3/(R*I1))*omega_tau*s, e = gamma3*a3 + R, V = omega_tau*e + v_nu, a part of d(omega_tau)/dt, a part of d(omega3)/dt" },
    .jacobian = { jacobian, 16, { 12, 50, 26, 1, 1, 0, 16, 23 }, { 47, 240, 0, 39, 1, 0, 18, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*(R*I3)*omega3 + G_level, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3), d(d(v_nu)/dt)/d(omega3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(omega3), d(Theta)/d(gamma3)/(2*m*R^2*I1) = b/R*(I3/I1) - gamma3, 2*a3*I3/(R*I1) - gamma3*(2*(I1 - I3)/I1), a part of d(d(omega3)/dt)/d(gamma3), a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), e = gamma3*a3 + R, V = omega_tau*e + v_nu, a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau), a part of d(d(omega3)/dt)/d(omega3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 9, 57, 31, 1, 1, 0, 17, 23 }, { 54, 277, 0, 47, 1, 0, 18, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, b*I3*omega3 + G_level, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), e = gamma3*a3 + R, a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(omega3)/dt)/d(omega_tau), a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(gamma3), a part of d(d(omega3)/dt)/d(omega3), numerator of d(omega_tau)/dt over D, a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(omega3), d(d(v_nu)/dt)/d(omega3), d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), a part of d(d(omega3)/dt)/d(gamma3), a part of d(v_nu)/dt, a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 2, 14, 10, 1, 1, 0, 15, 7 }, { 12, 39, 0, 5, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, (2*m*a3^2)*Theta*1/(D*Theta) - 1/s^2, a part of the divergence, a part of the divergence, e = gamma3*a3 + R, V = omega_tau*e + v_nu, the divergence" },
    .integral_values = { integral_values, 1, { 3, 12, 8, 1, 1, 0, 8, 8 }, { 10, 31, 0, 1, 1, 0, 12, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*(R*I3)*omega3 + G_level, v_tau = s*omega3*R + (1/I1)*b/R*((b/R*(R*I3)*omega3 + G_level)/s^2)*s, energy/(1/2*m)" },
    .integral_gradients = { integral_gradients, 4, { 3, 17, 12, 1, 1, 0, 10, 11 }, { 15, 50, 0, 6, 1, 0, 12, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*omega3*(R*I3) + G_level, d(omega_n)/d(gamma3), d(v_tau)/d(gamma3)/R, ((1)/s)*b/R*(1/(R*I1))*(b/R*omega3*(R*I3) + G_level)*((1)/s) + omega3, v_tau/R = omega3*s + b/R*(1/(R*I1))*(b/R*omega3*(R*I3) + G_level)*((1)/s), d(E)/d(gamma3), d(E)/d(omega3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 3, 1, 1, 1, 0, 4, 4 }, { 3, 6, 0, 1, 1, 0, 5, 4 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*(R*I3)*omega3 + G_level" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_on_level_G,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_general_on_level_G_baseline,
        &jlt_batch_spherical_top_general_on_level_G_avx2,
        &jlt_batch_spherical_top_general_on_level_G_avx512,
    },
#endif
};
