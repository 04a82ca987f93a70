/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_omega_n: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   24   12    1    1    0     16    9   (83)
 *  jacobian            11   52   26    1    1    0     17   17   (327)
 *  rhs_jacobian        11   55   30    1    1    0     17   23   (379)
 *  divergence          2   14   10    1    1    0     15    7   (57)
 *  integral_values     3   12    8    1    1    0      8    8   (43)
 *  integral_gradients  3   17   12    1    1    0     10   10   (72)
 *  eliminated          3    3    1    1    1    0      4    4   (11)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b/R = gamma3 + a3/R,
 *      d(Theta)/d(gamma3)/(2*m*R^2*I1) = (I3/I1)*b/R - gamma3, b/R*(R*I3)*omega3 + G_level,
 *      2*a3*I3/(R*I1) - gamma3*(2*(I1 - I3)/I1), a part of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3),
 *      e = gamma3*a3 + R, a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(omega3),
 *      a part of d(d(omega3)/dt)/d(omega_tau), a part of d(omega3)/dt, a part of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(d(omega3)/dt)/d(omega3), d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3),
 *      d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega3), a part of d(v_nu)/dt
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
extern const jlt_descriptor jlt_kernels_spherical_top_general_on_level_omega_n;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_on_level_omega_n;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_omega_n_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_omega_n_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_omega_n_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = 1.0/t0; /* 1/(R*I1) */
    out[7] = t1;
    const double t2 = params[3]*params[3]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    out[17] = t3;
    const double t4 = t3/params[4]; /* m*a3*a3/I1 */
    out[8] = t4;
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    out[50] = t6;
    const double t7 = params[5]/t6; /* I3/(m*R*R) */
    out[9] = t7;
    const double t8 = params[4]*t5; /* I1*R*R */
    const double t9 = params[5]/t8; /* I3/(I1*R*R) */
    out[10] = t9;
    const double t10 = params[0]*params[2]; /* m*g */
    const double t11 = params[3]*t10; /* a3*m*g */
    out[48] = t11;
    const double t12 = t11/params[4]; /* a3*m*g/I1 */
    out[11] = t12;
    const double t13 = params[5]/params[4]; /* I3/I1 */
    out[12] = t13;
    const double t14 = (-1.0)/params[1]; /* (-1)/R */
    out[13] = t14;
    const double t15 = params[3]*params[5]; /* a3*I3 */
    const double t16 = t15/params[4]; /* a3*I3/I1 */
    out[14] = t16;
    const double t17 = params[4] - params[5]; /* I1 - I3 */
    const double t18 = params[1]*t17; /* R*(I1 - I3) */
    const double t19 = t18/params[4]; /* R*(I1 - I3)/I1 */
    out[15] = t19;
    const double t20 = params[3]/params[1]; /* a3/R */
    out[16] = t20;
    const double t21 = 1.0/params[4]; /* 1/I1 */
    out[18] = t21;
    const double t22 = params[1]*params[5]; /* R*I3 */
    out[19] = t22;
    const double t23 = 2.0/t0; /* 2/(R*I1) */
    out[20] = t23;
    const double t24 = params[4]*params[4]; /* I1*I1 */
    const double t25 = params[1]*t24; /* R*I1*I1 */
    const double t26 = 1.0/t25; /* 1/(R*I1*I1) */
    out[21] = t26;
    const double t27 = params[5]*2.0; /* I3*2 */
    const double t28 = t27/t24; /* I3*2/(I1*I1) */
    out[22] = t28;
    const double t29 = t22/params[4]; /* R*I3/I1 */
    out[23] = t29;
    const double t30 = (-1.0)/t8; /* (-1)/(I1*R*R) */
    out[24] = t30;
    const double t31 = t6*params[2]; /* m*R*R*g */
    const double t32 = params[3]*t31; /* a3*m*R*R*g */
    const double t33 = params[4]*t32; /* I1*a3*m*R*R*g */
    out[25] = t33;
    const double t34 = params[0]*2.0; /* m*2 */
    const double t35 = t2*t34; /* a3*a3*m*2 */
    out[26] = t35;
    const double t36 = t2*t6; /* a3*a3*m*R*R */
    const double t37 = params[4]*t36; /* I1*a3*a3*m*R*R */
    out[27] = t37;
    const double t38 = params[5]/t0; /* I3/(R*I1) */
    out[35] = t38;
    const double t39 = -t38; /* -I3/(R*I1) */
    out[28] = t39;
    const double t40 = params[3]*2.0; /* a3*2 */
    const double t41 = params[5]*t40; /* I3*a3*2 */
    const double t42 = t41/t0; /* I3*a3*2/(R*I1) */
    out[29] = t42;
    const double t43 = t17*2.0; /* (I1 - I3)*2 */
    const double t44 = t43/params[4]; /* (I1 - I3)*2/I1 */
    out[30] = t44;
    const double t45 = t17/params[4]; /* (I1 - I3)/I1 */
    out[31] = t45;
    const double t46 = t15/t0; /* a3*I3/(R*I1) */
    out[32] = t46;
    const double t47 = params[3]/t8; /* a3/(I1*R*R) */
    out[33] = t47;
    const double t48 = 1.0/t8; /* 1/(I1*R*R) */
    out[34] = t48;
    const double t49 = 2.0/t8; /* 2/(I1*R*R) */
    out[36] = t49;
    const double t50 = params[3]/2.0; /* a3/2 */
    out[37] = t50;
    const double t51 = params[4]*params[5]; /* I1*I3 */
    out[38] = t51;
    const double t52 = params[4]*t6; /* I1*m*R*R */
    out[39] = t52;
    const double t53 = params[0]*params[5]; /* m*I3 */
    out[40] = t53;
    const double t54 = t6*t17; /* m*R*R*(I1 - I3) */
    out[41] = t54;
    const double t55 = params[1]*params[0]; /* R*m */
    const double t56 = params[3]*t55; /* a3*R*m */
    const double t57 = params[5]*t56; /* I3*a3*R*m */
    out[42] = t57;
    const double t58 = params[0]/2.0; /* m/2 */
    out[43] = t58;
    const double t59 = params[2]*2.0; /* g*2 */
    const double t60 = params[3]*t59; /* a3*g*2 */
    out[44] = t60;
    const double t61 = 1.0/params[0]; /* 1/m */
    out[45] = t61;
    const double t62 = 1.0/t52; /* 1/(I1*m*R*R) */
    out[46] = t62;
    const double t63 = params[5]/params[0]; /* I3/m */
    out[47] = t63;
    const double t64 = 1.0/params[1]; /* 1/R */
    out[49] = t64;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[10]*t3; /* I3/(R^2*I1)*b */
    const double t5 = p[9] + t2; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s^2 */
    const double t7 = JLT_FMA(p[8], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = t6*t7; /* Theta/(m*R^2*I1)*D/I1 */
    const double t9 = p[13]*t7; /* (-1/R)*D/I1 */
    const double t10 = t2*t8; /* s^2*Theta/(m*R^2*I1)*D/I1 */
    const double t11 = 1.0/t10; /* 1/(s^2*Theta/(m*R^2*I1)*D/I1) */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    const double t13 = t8*t12; /* Theta/(m*R^2*I1)*D/I1*s */
    const double t14 = t11*t13; /* 1/(s^2*Theta/(m*R^2*I1)*D/I1)*Theta/(m*R^2*I1)*D/I1*s */
    const double t15 = t2*t11; /* 1/((D/I1)*(Theta/(m*R^2*I1))) = s^2*1/(s^2*Theta/(m*R^2*I1)*D/I1) */
    const double t16 = t6*t15; /* Theta/(m*R^2*I1)*1/((D/I1)*(Theta/(m*R^2*I1))) */
    const double t17 = t9*t15; /* (-1/R)*D/I1*1/((D/I1)*(Theta/(m*R^2*I1))) */
    const double t18 = p[5]*x[3]; /* I3*omega3 */
    const double t19 = JLT_FMA(t3, t18, p[6]); /* b*I3*omega3 + G_level */
    const double t20 = p[7]*t19; /* 1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t21 = t14*t20; /* omega_n = 1/(s^2*Theta/(m*R^2*I1)*D/I1)*Theta/(m*R^2*I1)*D/I1*s*1/(R*I1)*(b*I3*omega3 + G_level) */
    const double t22 = t14*t21; /* 1/(s^2*Theta/(m*R^2*I1)*D/I1)*Theta/(m*R^2*I1)*D/I1*s*omega_n */
    const double t23 = t21*t22; /* omega_n*t22 */
    const double t24 = t3*t23; /* b*omega_n*t22 */
    const double t25 = x[2]*t12; /* omega_tau*s */
    out[0] = t25;
    const double t26 = x[2]*p[8]; /* omega_tau*m*a3^2/I1 */
    const double t27 = JLT_FMS(t25, t26, t23); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*t22 */
    const double t28 = x[0]*t27; /* gamma3*(omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*t22) */
    const double t29 = JLT_FNMA(p[11], t12, t28); /* gamma3*(omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*t22) - m*g*a3/I1*s */
    const double t30 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/I1 - gamma3*R*(I1 - I3)/I1 */
    const double t31 = x[3]*t30; /* omega3*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) */
    const double t32 = t25*t31; /* omega_tau*s*omega3*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) */
    const double t33 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t34 = JLT_FMA(x[2], t33, x[1]); /* V = omega_tau*e + v_nu */
    const double t35 = JLT_FMA(t21, t34, t32); /* omega_n*V + omega_tau*s*omega3*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) */
    const double t36 = t17*t35; /* (-1/R)*D/I1*1/((D/I1)*(Theta/(m*R^2*I1)))*t35 */
    out[3] = t36;
    const double t37 = x[3]*t21; /* omega3*omega_n */
    const double t38 = JLT_FMA(p[1], t37, t24); /* R*omega3*omega_n + b*omega_n*t22 */
    out[1] = t38;
    const double t39 = JLT_FNMA(p[12], t37, t29); /* t29 - I3/I1*omega3*omega_n */
    const double t40 = t16*t39; /* Theta/(m*R^2*I1)*1/((D/I1)*(Theta/(m*R^2*I1)))*(t29 - I3/I1*omega3*omega_n) */
    out[2] = t40;
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
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[16]; /* b/R = gamma3 + a3/R */
    const double t4 = p[12]*t3; /* I3/I1*b/R */
    const double t5 = p[9] + t2; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + I3/(m*R^2) + s^2 */
    const double t7 = t4 - x[0]; /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = I3/I1*b/R - gamma3 */
    const double t8 = JLT_FMA(p[17], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t9 = t2*t6; /* s^2*Theta/(m*R^2*I1) */
    const double t10 = t8*t9; /* D*s^2*Theta/(m*R^2*I1) */
    const double t11 = 1.0/t10; /* 1/(D*s^2*Theta/(m*R^2*I1)) */
    const double t12 = t8*t11; /* D*1/(D*s^2*Theta/(m*R^2*I1)) */
    const double t13 = t9*t11; /* 1/D = s^2*Theta/(m*R^2*I1)*1/(D*s^2*Theta/(m*R^2*I1)) */
    const double t14 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t14;
    const double t15 = t6*t14; /* Theta/(m*R^2*I1)*s */
    const double t16 = t12*t15; /* D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t17 = t2*t12; /* 1/(Theta/(m*R^2*I1)) = s^2*D*1/(D*s^2*Theta/(m*R^2*I1)) */
    const double t18 = p[19]*x[3]; /* R*I3*omega3 */
    const double t19 = x[0]*p[26]; /* gamma3*2*m*a3^2 */
    const double t20 = t13*t19; /* 1/D*gamma3*2*m*a3^2 */
    const double t21 = JLT_FMA(t3, t18, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t22 = t16*t21; /* D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*(b/R*R*I3*omega3 + G_level) */
    const double t23 = t3*t16; /* b/R*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t24 = JLT_FNMA(x[0], p[30], p[29]); /* 2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1 */
    const double t25 = t7*t24; /* d(Theta)/d(gamma3)/(2*m*R^2*I1)*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) */
    const double t26 = 2.0*t7; /* 2*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t27 = x[0]*t16; /* gamma3*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t28 = t14*t20; /* s*1/D*gamma3*2*m*a3^2 */
    const double t29 = t20*t22; /* 1/D*gamma3*2*m*a3^2*t22 */
    const double t30 = x[2]*t28; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[10] = t30;
    const double t31 = t28 - t27; /* s*1/D*gamma3*2*m*a3^2 - gamma3*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t32 = t14*t17; /* s*1/(Theta/(m*R^2*I1)) */
    const double t33 = t25*t32; /* t25*s*1/(Theta/(m*R^2*I1)) */
    const double t34 = JLT_FMA(p[31], t14, t33); /* (I1 - I3)/I1*s + t25*s*1/(Theta/(m*R^2*I1)) */
    const double t35 = JLT_FMA(x[0], t31, t14); /* gamma3*t31 + s */
    const double t36 = p[25]*t31; /* m*R^2*g*a3*I1*t31 */
    const double t37 = t16*t22; /* D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t22 */
    const double t38 = x[2]*p[27]; /* omega_tau*m*R^2*a3^2*I1 */
    const double t39 = x[2]*t38; /* omega_tau*omega_tau*m*R^2*a3^2*I1 */
    const double t40 = t16*t37; /* D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t22 */
    const double t41 = JLT_FMA(t37, t40, t36); /* D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t22*t40 + m*R^2*g*a3*I1*t31 */
    const double t42 = JLT_FNMA(t35, t39, t41); /* t41 - (gamma3*t31 + s)*omega_tau*omega_tau*m*R^2*a3^2*I1 */
    const double t43 = JLT_FNMA(x[0], p[31], p[32]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t44 = JLT_FMA(t27, t43, t34); /* gamma3*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + (I1 - I3)/I1*s + t25*s*1/(Theta/(m*R^2*I1)) */
    const double t45 = t32*t43; /* s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t46 = x[3]*t44; /* omega3*t44 */
    const double t47 = JLT_FNMA(p[33], t22, t46); /* omega3*t44 - a3/(R^2*I1)*t22 */
    const double t48 = x[2]*t27; /* omega_tau*gamma3*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t49 = -t48; /* -t48 */
    out[0] = t49;
    const double t50 = x[0]*t37; /* gamma3*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t22 */
    const double t51 = p[21]*t37; /* 1/(R*I1^2)*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t22 */
    const double t52 = t22*t23; /* t22*b/R*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t53 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t54 = t18 + t50; /* R*I3*omega3 + gamma3*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t22 */
    const double t55 = JLT_FMA(t29, t54, t42); /* 1/D*gamma3*2*m*a3^2*t22*t54 + t41 - (gamma3*t31 + s)*omega_tau*omega_tau*m*R^2*a3^2*I1 */
    const double t56 = t16*t54; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t54 */
    const double t57 = JLT_FMA(2.0, t50, t18); /* 2*gamma3*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t22 + R*I3*omega3 */
    const double t58 = JLT_FMA(t23, t50, t22); /* b/R*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*gamma3*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t22 + t22 */
    const double t59 = JLT_FMA(t56, t57, t55); /* d(omega_n)/d(gamma3)/(1/(R*I1))*t57 + t55 */
    const double t60 = JLT_FMA(t23, t57, t22); /* b/R*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t57 + t22 */
    const double t61 = JLT_FMA(p[20], t52, x[3]); /* 2/(R*I1)*t22*b/R*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s + omega3 */
    const double t62 = p[18]*t61; /* 1/I1*t61 */
    const double t63 = t56*t62; /* d(omega_n)/d(gamma3)/(1/(R*I1))*1/I1*t61 */
    const double t64 = JLT_FMA(t51, t58, t63); /* t51*t58 + d(omega_n)/d(gamma3)/(1/(R*I1))*1/I1*t61 */
    out[4] = t64;
    const double t65 = JLT_FMA(x[2], t53, x[1]); /* V = omega_tau*e + v_nu */
    const double t66 = t17*t65; /* 1/(Theta/(m*R^2*I1))*V */
    const double t67 = t17*t22; /* 1/(Theta/(m*R^2*I1))*t22 */
    const double t68 = JLT_FNMA(t26, t67, t56); /* d(omega_n)/d(gamma3)/(1/(R*I1)) - 2*d(Theta)/d(gamma3)/(2*m*R^2*I1)*1/(Theta/(m*R^2*I1))*t22 */
    const double t69 = p[18]*t22; /* 1/I1*t22 */
    const double t70 = x[2]*t17; /* omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t71 = t47*t70; /* (omega3*t44 - a3/(R^2*I1)*t22)*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t72 = p[34]*t67; /* 1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t22 */
    const double t73 = -t72; /* -1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t22 */
    out[13] = t73;
    const double t74 = x[3]*p[23]; /* omega3*R*I3/I1 */
    const double t75 = JLT_FMA(t23, t74, t69); /* b/R*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*omega3*R*I3/I1 + 1/I1*t22 */
    const double t76 = x[3]*t45; /* omega3*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t77 = JLT_FMA(t53, t72, t76); /* e*1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t22 + t76 */
    const double t78 = -t77; /* -(e*1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t22 + t76) */
    out[14] = t78;
    const double t79 = x[2]*t45; /* omega_tau*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t80 = p[35]*t23; /* I3/(R*I1)*b/R*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t81 = JLT_FMA(t66, t80, t79); /* 1/(Theta/(m*R^2*I1))*V*t80 + t79 */
    const double t82 = -t81; /* -(1/(Theta/(m*R^2*I1))*V*t80 + t79) */
    out[15] = t82;
    const double t83 = p[22]*t23; /* 2*I3/I1^2*b/R*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s */
    const double t84 = JLT_FMA(t52, t83, t75); /* t22*b/R*D*1/(D*s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*s*t83 + t75 */
    out[7] = t84;
    const double t85 = p[34]*t66; /* 1/(R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t86 = JLT_FNMA(t68, t85, t71); /* t71 - t68*1/(R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    out[12] = t86;
    const double t87 = p[24]*t13; /* (-1/(R^2*I1))*1/D */
    const double t88 = t59*t87; /* (d(omega_n)/d(gamma3)/(1/(R*I1))*t57 + t55)*(-1/(R^2*I1))*1/D */
    out[8] = t88;
    const double t89 = p[28]*t13; /* (-I3/(R*I1))*1/D */
    const double t90 = t60*t89; /* t60*(-I3/(R*I1))*1/D */
    out[11] = t90;
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
    const double t3 = x[0] + p[16]; /* b/R = gamma3 + a3/R */
    const double t4 = p[12]*t3; /* I3/I1*b/R */
    const double t5 = p[9] + t2; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + I3/(m*R^2) + s^2 */
    const double t7 = t4 - x[0]; /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = I3/I1*b/R - gamma3 */
    const double t8 = JLT_FMA(p[17], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t9 = t6*t8; /* Theta/(m*R^2*I1)*D */
    const double t10 = t2*t9; /* s^2*Theta/(m*R^2*I1)*D */
    const double t11 = 1.0/t10; /* 1/(s^2*Theta/(m*R^2*I1)*D) */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t12;
    const double t13 = t9*t12; /* Theta/(m*R^2*I1)*D*s */
    const double t14 = t11*t13; /* 1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s */
    const double t15 = t2*t11; /* 1/(D*(Theta/(m*R^2*I1))) = s^2*1/(s^2*Theta/(m*R^2*I1)*D) */
    const double t16 = t8*t15; /* 1/(Theta/(m*R^2*I1)) = D*1/(D*(Theta/(m*R^2*I1))) */
    const double t17 = t6*t15; /* 1/D = Theta/(m*R^2*I1)*1/(D*(Theta/(m*R^2*I1))) */
    const double t18 = p[19]*x[3]; /* R*I3*omega3 */
    const double t19 = JLT_FMA(t3, t18, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t20 = t14*t19; /* 1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t21 = t3*t14; /* b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s */
    const double t22 = x[2]*t12; /* omega_tau*s */
    out[0] = t22;
    const double t23 = x[2]*p[27]; /* omega_tau*m*R^2*a3^2*I1 */
    const double t24 = x[0]*t22; /* gamma3*omega_tau*s */
    const double t25 = t14*t20; /* 1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 */
    const double t26 = JLT_FNMA(x[0], p[30], p[29]); /* 2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1 */
    const double t27 = t7*t26; /* d(Theta)/d(gamma3)/(2*m*R^2*I1)*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) */
    const double t28 = JLT_FMA(t16, t27, p[31]); /* 1/(Theta/(m*R^2*I1))*t27 + (I1 - I3)/I1 */
    const double t29 = t22*t28; /* omega_tau*s*(1/(Theta/(m*R^2*I1))*t27 + (I1 - I3)/I1) */
    const double t30 = t23*t24; /* omega_tau*m*R^2*a3^2*I1*gamma3*omega_tau*s */
    const double t31 = JLT_FNMA(p[25], t12, t30); /* omega_tau*m*R^2*a3^2*I1*gamma3*omega_tau*s - m*R^2*g*a3*I1*s */
    const double t32 = x[0]*t25; /* gamma3*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 */
    const double t33 = t18 + t32; /* R*I3*omega3 + gamma3*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 */
    const double t34 = JLT_FNMA(t20, t33, t31); /* omega_tau*m*R^2*a3^2*I1*gamma3*omega_tau*s - m*R^2*g*a3*I1*s - t20*t33 */
    const double t35 = t14*t33; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t33 */
    const double t36 = JLT_FMA(2.0, t32, t18); /* 2*gamma3*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 + R*I3*omega3 */
    const double t37 = JLT_FMA(t21, t32, t20); /* b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*gamma3*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 + t20 */
    const double t38 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t39 = JLT_FNMA(x[0], p[31], p[32]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t40 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t41 = t14*t40; /* 1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*omega_tau*gamma3 */
    const double t42 = JLT_FMA(t39, t41, t29); /* (a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*t41 + omega_tau*s*(1/(Theta/(m*R^2*I1))*t27 + (I1 - I3)/I1) */
    const double t43 = t16*t39; /* 1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t44 = -t41; /* -t41 */
    out[4] = t44;
    const double t45 = x[0]*p[25]; /* gamma3*m*R^2*g*a3*I1 */
    const double t46 = JLT_FNMA(t25, t25, t45); /* gamma3*m*R^2*g*a3*I1 - 1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 */
    const double t47 = p[21]*t25; /* 1/(R*I1^2)*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t20 */
    const double t48 = t37*t47; /* t37*t47 */
    const double t49 = JLT_FMA(x[2], t38, x[1]); /* V = omega_tau*e + v_nu */
    const double t50 = t16*t20; /* 1/(Theta/(m*R^2*I1))*t20 */
    const double t51 = p[26]*t17; /* 2*m*a3^2*1/D */
    const double t52 = t24*t51; /* gamma3*omega_tau*s*2*m*a3^2*1/D */
    out[14] = t52;
    const double t53 = t34*t51; /* t34*2*m*a3^2*1/D */
    const double t54 = JLT_FNMA(t23, t41, t53); /* t34*2*m*a3^2*1/D - omega_tau*m*R^2*a3^2*I1*t41 */
    const double t55 = t22*t23; /* omega_tau*s*omega_tau*m*R^2*a3^2*I1 */
    const double t56 = JLT_FMA(t14, t46, t55); /* 1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t46 + omega_tau*s*omega_tau*m*R^2*a3^2*I1 */
    const double t57 = JLT_FNMA(t35, t36, t56); /* t56 - d(omega_n)/d(gamma3)/(1/(R*I1))*t36 */
    const double t58 = JLT_FMA(x[0], t54, t57); /* gamma3*(t34*2*m*a3^2*1/D - omega_tau*m*R^2*a3^2*I1*t41) + t56 - d(omega_n)/d(gamma3)/(1/(R*I1))*t36 */
    const double t59 = JLT_FMA(t21, t36, t20); /* b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t36 + t20 */
    const double t60 = t20*t21; /* t20*b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s */
    const double t61 = p[18]*t20; /* 1/I1*t20 */
    const double t62 = p[34]*t50; /* 1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t20 */
    const double t63 = p[36]*t50; /* 2/(R^2*I1)*1/(Theta/(m*R^2*I1))*t20 */
    const double t64 = -t62; /* -1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t20 */
    out[17] = t64;
    const double t65 = x[3]*t43; /* omega3*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t66 = t12*t65; /* s*t65 */
    const double t67 = JLT_FMA(t38, t62, t66); /* e*1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t20 + s*t65 */
    const double t68 = -t67; /* -(e*1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t20 + s*t65) */
    out[18] = t68;
    const double t69 = t49*t62; /* V*1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t20 */
    const double t70 = JLT_FMA(t22, t65, t69); /* omega_tau*s*t65 + V*1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t20 */
    const double t71 = -t70; /* -(omega_tau*s*t65 + V*1/(R^2*I1)*1/(Theta/(m*R^2*I1))*t20) */
    out[3] = t71;
    const double t72 = t16*t49; /* 1/(Theta/(m*R^2*I1))*V */
    const double t73 = x[3]*t16; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t74 = t42*t73; /* t42*omega3*1/(Theta/(m*R^2*I1)) */
    const double t75 = x[2]*p[37]; /* omega_tau*1/2*a3 */
    const double t76 = JLT_FNMA(t7, t72, t75); /* omega_tau*1/2*a3 - d(Theta)/d(gamma3)/(2*m*R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t77 = JLT_FNMA(t63, t76, t74); /* t42*omega3*1/(Theta/(m*R^2*I1)) - 2/(R^2*I1)*1/(Theta/(m*R^2*I1))*t20*t76 */
    const double t78 = p[35]*t21; /* I3/(R*I1)*b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s */
    const double t79 = t72*t78; /* 1/(Theta/(m*R^2*I1))*V*t78 */
    const double t80 = JLT_FMA(t22, t43, t79); /* omega_tau*s*1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + 1/(Theta/(m*R^2*I1))*V*t78 */
    const double t81 = -t80; /* -t80 */
    out[19] = t81;
    const double t82 = p[34]*t72; /* 1/(R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t83 = JLT_FNMA(t35, t82, t77); /* t77 - d(omega_n)/d(gamma3)/(1/(R*I1))*1/(R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    out[16] = t83;
    const double t84 = JLT_FMA(p[20], t60, x[3]); /* 2/(R*I1)*t20*b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s + omega3 */
    const double t85 = p[18]*t84; /* 1/I1*t84 */
    const double t86 = JLT_FMA(t35, t85, t48); /* d(omega_n)/d(gamma3)/(1/(R*I1))*1/I1*t84 + t37*t47 */
    out[8] = t86;
    const double t87 = x[3]*p[23]; /* omega3*R*I3/I1 */
    const double t88 = JLT_FMA(t21, t87, t61); /* b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*omega3*R*I3/I1 + 1/I1*t20 */
    const double t89 = p[22]*t21; /* 2*I3/I1^2*b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s */
    const double t90 = JLT_FMA(t60, t89, t88); /* t20*b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s*t89 + t88 */
    out[11] = t90;
    const double t91 = JLT_FMA(p[7], t60, x[3]); /* 1/(R*I1)*t20*b/R*1/(s^2*Theta/(m*R^2*I1)*D)*Theta/(m*R^2*I1)*D*s + omega3 */
    const double t92 = t61*t91; /* 1/I1*t20*t91 */
    out[1] = t92;
    const double t93 = p[34]*t17; /* 1/(R^2*I1)*1/D */
    const double t94 = t34*t93; /* t34*1/(R^2*I1)*1/D */
    out[2] = t94;
    const double t95 = t58*t93; /* t58*1/(R^2*I1)*1/D */
    out[12] = t95;
    const double t96 = p[28]*t17; /* (-I3/(R*I1))*1/D */
    const double t97 = t59*t96; /* t59*(-I3/(R*I1))*1/D */
    out[15] = t97;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[40]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[39], t2, p[38]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[17], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t6*t7; /* Theta*D */
    const double t9 = p[26]*t6; /* 2*m*a3^2*Theta */
    const double t10 = t2*t8; /* s^2*Theta*D */
    const double t11 = 1.0/t10; /* 1/(s^2*Theta*D) */
    const double t12 = t8*t11; /* 1/s^2 = Theta*D*1/(s^2*Theta*D) */
    const double t13 = t2*t11; /* 1/(D*Theta) = s^2*1/(s^2*Theta*D) */
    const double t14 = sqrt(t2); /* s = sqrt(s^2) */
    const double t15 = JLT_FMS(t9, t13, t12); /* 2*m*a3^2*Theta*1/(D*Theta) - 1/s^2 */
    const double t16 = t7*t14; /* D*s */
    const double t17 = t14*t15; /* s*(2*m*a3^2*Theta*1/(D*Theta) - 1/s^2) */
    const double t18 = t13*t16; /* 1/(D*Theta)*D*s */
    const double t19 = JLT_FMA(p[41], t18, t17); /* m*R^2*(I1 - I3)*1/(D*Theta)*D*s + s*(2*m*a3^2*Theta*1/(D*Theta) - 1/s^2) */
    const double t20 = x[0]*t19; /* gamma3*t19 */
    const double t21 = JLT_FNMA(p[42], t18, t20); /* gamma3*t19 - m*R*a3*I3*1/(D*Theta)*D*s */
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
    const double t3 = x[0] + p[16]; /* b/R = gamma3 + a3/R */
    const double t4 = p[19]*x[3]; /* R*I3*omega3 */
    const double t5 = JLT_FMA(t3, t4, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t6 = t5/t2; /* (b/R*R*I3*omega3 + G_level)/s^2 */
    const double t7 = p[18]*t3; /* 1/I1*b/R */
    const double t8 = p[44]*x[0]; /* 2*g*a3*gamma3 */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t10 = p[45]*x[2]; /* 1/m*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/m*omega_tau */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    const double t13 = JLT_FMA(p[17], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t14 = t6*t12; /* (b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t15 = t7*t14; /* 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t16 = x[3]*p[47]; /* omega3*I3/m */
    const double t17 = JLT_FMA(x[3], t16, t9); /* omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = JLT_FMA(t11, t13, t17); /* omega_tau*1/m*omega_tau*D + omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t19 = p[46]*t14; /* 1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t20 = JLT_FMA(t14, t19, t18); /* (b/R*R*I3*omega3 + G_level)/s^2*s*1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s^2*s + t18 */
    const double t21 = x[3]*p[1]; /* omega3*R */
    const double t22 = JLT_FMA(t12, t21, t15); /* v_tau = s*omega3*R + 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t23 = JLT_FMA(t22, t22, t20); /* energy/(1/2*m) = v_tau*v_tau + t20 */
    const double t24 = p[43]*t23; /* 1/2*m*energy/(1/2*m) */
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
    const double t5 = JLT_FMA(p[17], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*t5; /* omega_tau*D */
    out[2] = t6;
    const double t7 = x[0] + p[16]; /* b/R = gamma3 + a3/R */
    const double t8 = x[3]*p[19]; /* omega3*R*I3 */
    const double t9 = JLT_FMA(t7, t8, p[6]); /* b/R*omega3*R*I3 + G_level */
    const double t10 = 1.0/t4; /* 1/s */
    const double t11 = t9*t10; /* (b/R*omega3*R*I3 + G_level)*1/s */
    const double t12 = p[12]*x[3]; /* I3/I1*omega3 */
    const double t13 = p[7]*t11; /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t14 = p[49]*t11; /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t15 = x[0]*t10; /* gamma3*1/s */
    const double t16 = JLT_FMA(t13, t15, t12); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*gamma3*1/s + I3/I1*omega3 */
    const double t17 = t10*t16; /* d(omega_n)/d(gamma3) = 1/s*t16 */
    const double t18 = t7*t10; /* b/R*1/s */
    const double t19 = JLT_FNMA(x[3], t15, t13); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t20 = JLT_FMA(t7, t17, t19); /* d(v_tau)/d(gamma3)/R = b/R*d(omega_n)/d(gamma3) + 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t21 = p[17]*x[0]; /* m*a3^2*gamma3 */
    const double t22 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t23 = JLT_FNMA(t21, t22, p[48]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t24 = JLT_FMA(t14, t17, t23); /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s*d(omega_n)/d(gamma3) + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t25 = t7*t13; /* b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t26 = JLT_FMA(x[3], t4, t25); /* v_tau/R = omega3*s + b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t27 = JLT_FMA(t13, t18, x[3]); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*b/R*1/s + omega3 */
    const double t28 = p[12]*t7; /* I3/I1*b/R */
    const double t29 = JLT_FMA(t18, t28, t4); /* d(v_tau)/d(omega3)/R = b/R*1/s*I3/I1*b/R + s */
    const double t30 = p[50]*t26; /* m*R^2*v_tau/R */
    const double t31 = JLT_FMA(t20, t30, t24); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R^2*v_tau/R + t24 */
    out[0] = t31;
    const double t32 = p[5]*t27; /* I3*(1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*b/R*1/s + omega3) */
    const double t33 = JLT_FMA(t29, t30, t32); /* d(energy)/d(omega3) = d(v_tau)/d(omega3)/R*m*R^2*v_tau/R + t32 */
    out[3] = t33;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0] + p[16]; /* b/R = gamma3 + a3/R */
    const double t5 = p[19]*x[3]; /* R*I3*omega3 */
    const double t6 = JLT_FMA(t4, t5, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t7 = p[7]*t6; /* 1/(R*I1)*(b/R*R*I3*omega3 + G_level) */
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t18[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t19[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = jlt_jet_root(t20[k], t21, k);
        t22[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t23[k] = p[5]*x3[k];
        t24[k] = jlt_jet_product(t22, t23, k) + (k == 0 ? p[6] : 0);
        t25[k] = p[7]*t24[k];
        t26[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t21, t26, k);
        t27[k] = jlt_jet_product(t25, t26, k);
        t28[k] = jlt_jet_product(t26, t27, k);
        t29[k] = jlt_jet_product(t27, t28, k);
        t30[k] = jlt_jet_product(x2, t21, k);
        t31[k] = x2[k]*p[8];
        t32[k] = jlt_jet_product(t30, t31, k) - t29[k];
        t33[k] = jlt_jet_product(x0, t32, k);
        t34[k] = t33[k] - p[11]*t21[k];
        t35[k] = jlt_jet_product(t22, t29, k);
        t36[k] = p[10]*t22[k];
        t37[k] = (k == 0 ? p[9] : 0) + t20[k];
        t38[k] = jlt_jet_product(t22, t36, k) + t37[k];
        t39[k] = p[8]*t20[k] + (k == 0 ? 1.0 : 0);
        t40[k] = jlt_jet_quotient((k == 0 ? p[13] : 0), t38, t40, k);
        t41[k] = jlt_jet_product(x3, t27, k);
        t42[k] = p[1]*t41[k] + t35[k];
        t43[k] = t34[k] - p[12]*t41[k];
        t44[k] = jlt_jet_quotient(t43[k], t39, t44, k);
        t45[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t46[k] = jlt_jet_product(x3, t45, k);
        t47[k] = jlt_jet_product(t30, t46, k);
        t48[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t49[k] = jlt_jet_product(x2, t48, k) + x1[k];
        t50[k] = jlt_jet_product(t27, t49, k) + t47[k];
        t51[k] = jlt_jet_product(t40, t50, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t30[k]/(k + 1);
        next[1] = x1[k + 1] = t42[k]/(k + 1);
        next[2] = x2[k + 1] = t44[k]/(k + 1);
        next[3] = x3[k + 1] = t51[k]/(k + 1);
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_general_on_level_omega_n = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "level_omega_n",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .prepared_count = 51,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 24, 12, 1, 1, 0, 16, 9 }, { 15, 58, 0, 9, 1, 0, 10, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, b*I3*omega3 + G_level, a part of d(omega_tau)/dt, a3*I3/I1 - gamma3*(R*(I1 - I3)/I1), e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega_n*V + omega_tau*s*omega3*(a3*I3/I1 - gamma3*(R*(I1 - I3)/I1)), d(v_nu)/dt, a part of d(omega_tau)/dt" },
    .jacobian = { jacobian, 16, { 11, 52, 26, 1, 1, 0, 17, 17 }, { 47, 240, 0, 39, 1, 0, 18, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, d(Theta)/d(gamma3)/(2*m*R^2*I1) = (I3/I1)*b/R - gamma3, b/R*(R*I3)*omega3 + G_level, 2*a3*I3/(R*I1) - gamma3*(2*(I1 - I3)/I1), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), e = gamma3*a3 + R, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau), a part of d(d(omega3)/dt)/d(omega3), d(d(v_nu)/dt)/d(omega3), d(d(omega3)/dt)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 11, 55, 30, 1, 1, 0, 17, 23 }, { 54, 277, 0, 47, 1, 0, 18, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, d(Theta)/d(gamma3)/(2*m*R^2*I1) = (I3/I1)*b/R - gamma3, b/R*(R*I3)*omega3 + G_level, 2*a3*I3/(R*I1) - gamma3*(2*(I1 - I3)/I1), a part of d(d(omega3)/dt)/d(gamma3), a part of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3), e = gamma3*a3 + R, a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(omega3), a part of d(d(omega3)/dt)/d(omega_tau), a part of d(omega3)/dt, a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega3), d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega3), a part of d(v_nu)/dt" },
    .divergence = { divergence, 1, { 2, 14, 10, 1, 1, 0, 15, 7 }, { 12, 39, 0, 5, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, (2*m*a3^2)*Theta*1/(D*Theta) - 1/s^2, a part of the divergence, a part of the divergence, e = gamma3*a3 + R, V = omega_tau*e + v_nu, the divergence" },
    .integral_values = { integral_values, 1, { 3, 12, 8, 1, 1, 0, 8, 8 }, { 10, 31, 0, 1, 1, 0, 12, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*(R*I3)*omega3 + G_level, v_tau = s*omega3*R + (1/I1)*b/R*((b/R*(R*I3)*omega3 + G_level)/s^2)*s, energy/(1/2*m)" },
    .integral_gradients = { integral_gradients, 4, { 3, 17, 12, 1, 1, 0, 10, 10 }, { 15, 50, 0, 6, 1, 0, 12, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*omega3*(R*I3) + G_level, a part of d(E)/d(gamma3), d(v_tau)/d(gamma3)/R, v_tau/R = omega3*s + b/R*(1/(R*I1))*(b/R*omega3*(R*I3) + G_level)*((1)/s), (1/(R*I1))*(b/R*omega3*(R*I3) + G_level)*((1)/s)*b/R*((1)/s) + omega3, d(E)/d(gamma3), d(E)/d(omega3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 3, 1, 1, 1, 0, 4, 4 }, { 3, 6, 0, 1, 1, 0, 5, 4 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*(R*I3)*omega3 + G_level" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .eliminated_state = 3, .level_integral = 1,
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_on_level_omega_n,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_general_on_level_omega_n) },
#endif
};
