/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   26   13    1    1    0     12   10   (99)
 *  jacobian            9   53   30    1    1    0     17   19   (373)
 *  rhs_jacobian        9   65   35    1    1    0     16   24   (447)
 *  divergence          2   14    9    1    1    0     11    9   (54)
 *  integral_values     2   12    9    0    1    0      7    6   (43)
 *  integral_gradients  2   16    9    1    1    0      6    7   (53)
 *  observe_values      2    6    5    1    1    0      7    6   (38)
 *  valid_values        2    6    5    1    1    0      7    6   (38)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, V = omega_tau*e + v_nu,
 *      d(d(omega_n)/dt)/d(omega_n), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      ((1)/s^2*Theta*D)*Theta*D*s - (2*m*a3^2)*s*1/D, a part of d(d(omega_n)/dt)/d(gamma3),
 *      (I3/I1)*omega3*1/D + omega_n*((1)/s^2*Theta*D)*Theta*D*s*gamma3*1/D, a part of d(d(omega_tau)/dt)/d(gamma3),
 *      d(omega_tau)/dt, d(d(omega_tau)/dt)/d(omega_n), a3*I3 - gamma3*(R*(I1 - I3)),
 *      a part of d(d(omega3)/dt)/d(gamma3), (m*R*I3)*e + I3^2, d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1),
 *      a part of d(d(v_nu)/dt)/d(gamma3), d(v_nu)/dt, a part of d(d(omega_tau)/dt)/d(gamma3),
 *      d(d(omega_tau)/dt)/d(gamma3), a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3),
 *      d(d(omega3)/dt)/d(gamma3), a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(gamma3),
 *      d(d(omega_n)/dt)/d(gamma3), d(omega_n)/dt, d(d(omega_n)/dt)/d(omega_tau),
 *      a part of d(d(omega3)/dt)/d(omega_tau), d(d(v_nu)/dt)/d(omega_n)
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
extern const jlt_descriptor jlt_kernels_spherical_top_general;
extern const struct jlt_ball_table jlt_balls_spherical_top_general;
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
    out[30] = t1;
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    out[6] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    out[7] = t5;
    const double t6 = params[4]*t3; /* I1*R*R */
    const double t7 = params[5]/t6; /* I3/(I1*R*R) */
    out[8] = t7;
    const double t8 = params[0]*params[2]; /* m*g */
    const double t9 = params[3]*t8; /* a3*m*g */
    out[31] = t9;
    const double t10 = t9/params[4]; /* a3*m*g/I1 */
    out[9] = t10;
    const double t11 = params[5]/params[4]; /* I3/I1 */
    out[10] = t11;
    const double t12 = params[4]*params[1]; /* I1*R */
    out[47] = t12;
    const double t13 = params[5]/t12; /* I3/(I1*R) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[32] = t14;
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[12] = t15;
    const double t16 = 1.0/params[1]; /* 1/R */
    out[13] = t16;
    const double t17 = params[4] - params[5]; /* I1 - I3 */
    const double t18 = t17/params[4]; /* (I1 - I3)/I1 */
    out[14] = t18;
    const double t19 = params[3]*params[5]; /* a3*I3 */
    out[33] = t19;
    const double t20 = t19/t12; /* a3*I3/(I1*R) */
    out[15] = t20;
    const double t21 = params[4]*params[5]; /* I1*I3 */
    out[16] = t21;
    const double t22 = params[4]*t4; /* I1*m*R*R */
    out[17] = t22;
    const double t23 = params[0]*params[5]; /* m*I3 */
    out[18] = t23;
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t0*t24; /* a3*a3*m*2 */
    out[35] = t25;
    const double t26 = t25/params[4]; /* a3*a3*m*2/I1 */
    out[19] = t26;
    const double t27 = params[4]*2.0; /* I1*2 */
    const double t28 = params[5]/t27; /* I3/(I1*2) */
    out[20] = t28;
    const double t29 = -params[5]; /* -I3 */
    out[37] = t29;
    const double t30 = -t11; /* -I3/I1 */
    out[21] = t30;
    const double t31 = params[5]*t14; /* I3*m*R */
    out[22] = t31;
    const double t32 = t3*t24; /* R*R*m*2 */
    const double t33 = params[4]*t32; /* I1*R*R*m*2 */
    out[23] = t33;
    const double t34 = params[1]*t24; /* R*m*2 */
    const double t35 = params[5]*t34; /* I3*R*m*2 */
    out[24] = t35;
    const double t36 = params[3]*t14; /* a3*m*R */
    const double t37 = params[5]*t36; /* I3*a3*m*R */
    out[25] = t37;
    const double t38 = params[5]*params[5]; /* I3*I3 */
    out[26] = t38;
    const double t39 = params[4]*t14; /* I1*m*R */
    out[27] = t39;
    const double t40 = t4*t17; /* m*R*R*(I1 - I3) */
    out[28] = t40;
    const double t41 = -t14; /* -m*R */
    out[41] = t41;
    const double t42 = -t39; /* -I1*m*R */
    out[29] = t42;
    const double t43 = params[1]*t17; /* R*(I1 - I3) */
    out[34] = t43;
    const double t44 = params[4]*t25; /* I1*a3*a3*m*2 */
    out[36] = t44;
    const double t45 = params[4]*(-2.0); /* I1*(-2) */
    out[38] = t45;
    const double t46 = params[0]*params[3]; /* m*a3 */
    const double t47 = params[5]*t46; /* I3*m*a3 */
    out[39] = t47;
    const double t48 = params[4]*t36; /* I1*a3*m*R */
    out[40] = t48;
    const double t49 = params[0]/2.0; /* m/2 */
    out[42] = t49;
    const double t50 = params[2]*2.0; /* g*2 */
    const double t51 = params[3]*t50; /* a3*g*2 */
    out[43] = t51;
    const double t52 = 1.0/params[0]; /* 1/m */
    out[44] = t52;
    const double t53 = params[4]/params[0]; /* I1/m */
    out[45] = t53;
    const double t54 = params[5]/params[0]; /* I3/m */
    out[46] = t54;
    const double t55 = -t12; /* -I1*R */
    out[48] = t55;
    const double t56 = params[1]*params[5]; /* R*I3 */
    const double t57 = -t56; /* -R*I3 */
    out[49] = t57;
    const double t58 = params[3]*params[4]; /* a3*I1 */
    out[50] = t58;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t5 = p[8]*t3; /* I3/(R^2*I1)*b */
    const double t6 = p[7] + t2; /* I3/(m*R^2) + s^2 */
    const double t7 = JLT_FMA(t3, t5, t6); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s^2 */
    const double t8 = t2*t4; /* s^2*D/I1 */
    const double t9 = x[3]*t4; /* omega_n*D/I1 */
    const double t10 = t7*t8; /* Theta/(m*R^2*I1)*s^2*D/I1 */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s^2*D/I1) */
    const double t12 = t7*t11; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D/I1) */
    const double t13 = t8*t11; /* 1/(Theta/(m*R^2*I1)) = s^2*D/I1*1/(Theta/(m*R^2*I1)*s^2*D/I1) */
    const double t14 = sqrt(t2); /* s = sqrt(s^2) */
    const double t15 = t9*t14; /* omega_n*D/I1*s */
    const double t16 = t12*t15; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D/I1)*omega_n*D/I1*s */
    const double t17 = t2*t12; /* s^2*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D/I1) */
    const double t18 = t3*t16; /* b*t16 */
    const double t19 = JLT_FMA(p[1], x[4], t18); /* R*omega3 + b*t16 */
    const double t20 = x[3]*t19; /* omega_n*(R*omega3 + b*t16) */
    out[1] = t20;
    const double t21 = t5*t16; /* I3/(R^2*I1)*b*t16 */
    const double t22 = x[0]*t16; /* gamma3*t16 */
    const double t23 = x[2]*t14; /* omega_tau*s */
    out[0] = t23;
    const double t24 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t25 = x[0]*t23; /* gamma3*omega_tau*s */
    const double t26 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t27 = t25*t26; /* gamma3*omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t28 = JLT_FNMA(p[9], t14, t27); /* gamma3*omega_tau*s*omega_tau*m*a3^2/I1 - m*g*a3/I1*s */
    const double t29 = p[14]*t25; /* (I1 - I3)/I1*gamma3*omega_tau*s */
    const double t30 = JLT_FNMA(p[15], t23, t29); /* (I1 - I3)/I1*gamma3*omega_tau*s - a3*I3/(R*I1)*omega_tau*s */
    const double t31 = p[12] + t24; /* I3/(m*R) + e */
    const double t32 = p[11]*t31; /* I3/(R*I1)*(I3/(m*R) + e) */
    const double t33 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = t13*t33; /* 1/(Theta/(m*R^2*I1))*V */
    const double t35 = x[4]*t13; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t36 = JLT_FMA(t32, t35, t22); /* I3/(R*I1)*(I3/(m*R) + e)*omega3*1/(Theta/(m*R^2*I1)) + gamma3*t16 */
    const double t37 = JLT_FMA(x[4], p[10], t22); /* omega3*I3/I1 + gamma3*t16 */
    const double t38 = JLT_FNMA(x[3], t37, t28); /* gamma3*omega_tau*s*omega_tau*m*a3^2/I1 - m*g*a3/I1*s - omega_n*(omega3*I3/I1 + gamma3*t16) */
    const double t39 = t17*t38; /* s^2*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D/I1)*t38 */
    out[2] = t39;
    const double t40 = x[2]*t36; /* omega_tau*t36 */
    const double t41 = JLT_FNMA(t21, t34, t40); /* omega_tau*t36 - I3/(R^2*I1)*b*t16*1/(Theta/(m*R^2*I1))*V */
    out[3] = t41;
    const double t42 = x[3]*p[13]; /* omega_n*1/R */
    const double t43 = t34*t42; /* 1/(Theta/(m*R^2*I1))*V*omega_n*1/R */
    const double t44 = JLT_FMS(t30, t35, t43); /* ((I1 - I3)/I1*gamma3*omega_tau*s - a3*I3/(R*I1)*omega_tau*s)*omega3*1/(Theta/(m*R^2*I1)) - 1/(Theta/(m*R^2*I1))*V*omega_n*1/R */
    out[4] = t44;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[18]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[17], t2, p[16]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = t6*t7; /* Theta*D/I1 */
    const double t9 = t2*t8; /* s^2*Theta*D/I1 */
    const double t10 = 1.0/t9; /* 1/(s^2*Theta*D/I1) */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t11;
    const double t12 = t8*t11; /* Theta*D/I1*s */
    const double t13 = t10*t12; /* 1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t14 = t2*t10; /* 1/((D/I1)*Theta) = s^2*1/(s^2*Theta*D/I1) */
    const double t15 = t6*t14; /* 1/(D/I1) = Theta*1/((D/I1)*Theta) */
    const double t16 = t7*t14; /* 1/Theta = D/I1*1/((D/I1)*Theta) */
    const double t17 = x[3]*t13; /* omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t18 = x[0]*p[19]; /* gamma3*2*m*a3^2/I1 */
    const double t19 = t15*t18; /* 1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t20 = x[0]*t17; /* gamma3*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t21 = JLT_FMA(x[4], p[10], t20); /* omega3*I3/I1 + gamma3*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t22 = x[3]*t19; /* omega_n*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t23 = t21*t22; /* t21*omega_n*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t24 = t11*t19; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t25 = x[2]*t24; /* omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[12] = t25;
    const double t26 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t27 = x[0]*t13; /* gamma3*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t28 = t24 - t27; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t29 = t13*t17; /* 1/(s^2*Theta*D/I1)*Theta*D/I1*s*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t30 = JLT_FMA(t17, t29, t23); /* omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s*t29 + t21*omega_n*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t31 = JLT_FMA(p[9], t28, t30); /* m*g*a3/I1*t28 + t30 */
    const double t32 = JLT_FMA(x[0], t28, t11); /* gamma3*t28 + s */
    const double t33 = JLT_FMA(x[2], t26, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = t16*t33; /* 1/Theta*V */
    const double t35 = p[29]*t34; /* (-m*R*I1)*1/Theta*V */
    out[23] = t35;
    const double t36 = x[0]*p[23]; /* gamma3*2*m*R^2*I1 */
    const double t37 = JLT_FMS(p[24], t3, t36); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t38 = t3*t17; /* b*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t39 = JLT_FMA(p[22], t26, p[26]); /* m*R*I3*e + I3^2 */
    const double t40 = JLT_FNMA(x[0], p[28], p[25]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t41 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t42 = x[2]*t41; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t43 = JLT_FNMA(t32, t42, t31); /* m*g*a3/I1*t28 + t30 - (gamma3*t28 + s)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t44 = t15*t43; /* 1/(D/I1)*t43 */
    const double t45 = -t44; /* -1/(D/I1)*t43 */
    out[10] = t45;
    const double t46 = p[22]*t17; /* m*R*I3*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t47 = t34*t46; /* 1/Theta*V*m*R*I3*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t48 = t16*t39; /* 1/Theta*(m*R*I3*e + I3^2) */
    const double t49 = x[2]*t16; /* omega_tau*1/Theta */
    const double t50 = t39*t49; /* (m*R*I3*e + I3^2)*omega_tau*1/Theta */
    out[19] = t50;
    const double t51 = x[4]*t49; /* omega3*omega_tau*1/Theta */
    const double t52 = t11*t40; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t53 = p[28]*t11; /* m*R^2*(I1 - I3)*s */
    const double t54 = JLT_FMA(t27, t40, t53); /* gamma3*1/(s^2*Theta*D/I1)*Theta*D/I1*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + m*R^2*(I1 - I3)*s */
    const double t55 = t16*t52; /* 1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t56 = JLT_FMA(t37, t55, t54); /* d(Theta)/d(gamma3)*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + t54 */
    const double t57 = x[2]*p[3]; /* omega_tau*a3 */
    const double t58 = JLT_FNMA(t34, t37, t57); /* omega_tau*a3 - 1/Theta*V*d(Theta)/d(gamma3) */
    const double t59 = JLT_FNMA(t37, t48, p[25]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(m*R*I3*e + I3^2) */
    const double t60 = JLT_FMS(t51, t59, t47); /* omega3*omega_tau*1/Theta*(m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(m*R*I3*e + I3^2)) - 1/Theta*V*m*R*I3*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t61 = t4*t34; /* m*I3*b*1/Theta*V */
    const double t62 = t4*t17; /* m*I3*b*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t63 = t16*t62; /* 1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t64 = JLT_FNMA(t58, t63, t60); /* t60 - (omega_tau*a3 - 1/Theta*V*d(Theta)/d(gamma3))*1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t65 = JLT_FMA(x[4], t48, t20); /* omega3*1/Theta*(m*R*I3*e + I3^2) + gamma3*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t66 = JLT_FNMA(t26, t63, t65); /* t65 - e*1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    out[17] = t66;
    const double t67 = -t63; /* -1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    out[16] = t67;
    const double t68 = JLT_FMA(x[4], p[20], t20); /* omega3*1/2*I3/I1 + gamma3*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t69 = x[3]*p[27]; /* omega_n*m*R*I1 */
    const double t70 = t16*t69; /* 1/Theta*omega_n*m*R*I1 */
    const double t71 = t58*t70; /* (omega_tau*a3 - 1/Theta*V*d(Theta)/d(gamma3))*1/Theta*omega_n*m*R*I1 */
    const double t72 = JLT_FMS(t51, t56, t71); /* omega3*omega_tau*1/Theta*t56 - t71 */
    out[20] = t72;
    const double t73 = -t70; /* -1/Theta*omega_n*m*R*I1 */
    out[21] = t73;
    const double t74 = p[1]*x[3]; /* R*omega_n */
    out[9] = t74;
    const double t75 = JLT_FMA(t27, t38, t74); /* gamma3*1/(s^2*Theta*D/I1)*Theta*D/I1*s*b*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s + R*omega_n */
    const double t76 = t17*t75; /* omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s*t75 */
    out[5] = t76;
    const double t77 = x[2]*t13; /* omega_tau*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t78 = JLT_FNMA(t27, t61, t77); /* omega_tau*1/(s^2*Theta*D/I1)*Theta*D/I1*s - gamma3*1/(s^2*Theta*D/I1)*Theta*D/I1*s*m*I3*b*1/Theta*V */
    const double t79 = JLT_FMA(t29, t78, t64); /* t29*t78 + t64 */
    out[15] = t79;
    const double t80 = x[2]*t27; /* omega_tau*gamma3*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    const double t81 = JLT_FNMA(t13, t61, t80); /* omega_tau*gamma3*1/(s^2*Theta*D/I1)*Theta*D/I1*s - 1/(s^2*Theta*D/I1)*Theta*D/I1*s*m*I3*b*1/Theta*V */
    out[18] = t81;
    const double t82 = -t80; /* -omega_tau*gamma3*1/(s^2*Theta*D/I1)*Theta*D/I1*s */
    out[0] = t82;
    const double t83 = x[4]*t55; /* omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t84 = JLT_FMA(t26, t70, t83); /* e*1/Theta*omega_n*m*R*I1 + omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t85 = -t84; /* -t84 */
    out[22] = t85;
    const double t86 = x[2]*t55; /* omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t87 = -t86; /* -omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[24] = t87;
    const double t88 = p[1]*x[4]; /* R*omega3 */
    const double t89 = JLT_FMA(2.0, t38, t88); /* 2*b*omega_n*1/(s^2*Theta*D/I1)*Theta*D/I1*s + R*omega3 */
    out[8] = t89;
    const double t90 = (-2.0)*t15; /* (-2)*1/(D/I1) */
    const double t91 = t68*t90; /* t68*(-2)*1/(D/I1) */
    out[13] = t91;
    const double t92 = x[3]*p[21]; /* omega_n*(-I3/I1) */
    const double t93 = t15*t92; /* 1/(D/I1)*omega_n*(-I3/I1) */
    out[14] = t93;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[18]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[17], t2, p[16]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t6*t7; /* Theta*D */
    const double t9 = t2*t8; /* s^2*Theta*D */
    const double t10 = 1.0/t9; /* 1/(s^2*Theta*D) */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    out[7] = t11;
    const double t12 = t8*t11; /* Theta*D*s */
    const double t13 = t10*t12; /* 1/(s^2*Theta*D)*Theta*D*s */
    const double t14 = t2*t10; /* 1/(D*Theta) = s^2*1/(s^2*Theta*D) */
    const double t15 = t6*t14; /* 1/D = Theta*1/(D*Theta) */
    const double t16 = t7*t14; /* 1/Theta = D*1/(D*Theta) */
    const double t17 = t4*t13; /* m*I3*b*1/(s^2*Theta*D)*Theta*D*s */
    const double t18 = x[2]*t11; /* omega_tau*s */
    out[0] = t18;
    const double t19 = x[3]*t13; /* omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t20 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t21 = x[0]*t15; /* gamma3*1/D */
    const double t22 = t11*t15; /* s*1/D */
    const double t23 = JLT_FMA(x[2], t20, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = t16*t23; /* 1/Theta*V */
    const double t25 = p[29]*t24; /* (-m*R*I1)*1/Theta*V */
    out[28] = t25;
    const double t26 = x[0]*t13; /* gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t27 = p[35]*t18; /* 2*m*a3^2*omega_tau*s */
    const double t28 = t21*t27; /* gamma3*1/D*2*m*a3^2*omega_tau*s */
    out[17] = t28;
    const double t29 = t13*t19; /* 1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t30 = x[4]*t15; /* omega3*1/D */
    const double t31 = t19*t21; /* omega_n*1/(s^2*Theta*D)*Theta*D*s*gamma3*1/D */
    const double t32 = x[4]*t16; /* omega3*1/Theta */
    const double t33 = x[2]*t26; /* omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t34 = JLT_FNMA(t17, t24, t33); /* omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s - m*I3*b*1/(s^2*Theta*D)*Theta*D*s*1/Theta*V */
    out[23] = t34;
    const double t35 = t28 - t33; /* gamma3*1/D*2*m*a3^2*omega_tau*s - omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t36 = -t33; /* -omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    out[5] = t36;
    const double t37 = JLT_FNMA(p[35], t22, t13); /* 1/(s^2*Theta*D)*Theta*D*s - 2*m*a3^2*s*1/D */
    const double t38 = p[31]*t37; /* m*g*a3*(1/(s^2*Theta*D)*Theta*D*s - 2*m*a3^2*s*1/D) */
    const double t39 = p[22]*t19; /* m*R*I3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t40 = t24*t39; /* 1/Theta*V*m*R*I3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t41 = t13*t29; /* 1/(s^2*Theta*D)*Theta*D*s*1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t42 = JLT_FMA(p[25], t32, t41); /* m*R*a3*I3*omega3*1/Theta + t41 */
    const double t43 = JLT_FMS(x[2], t42, t40); /* omega_tau*(m*R*a3*I3*omega3*1/Theta + t41) - 1/Theta*V*m*R*I3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t44 = t13*t26; /* 1/(s^2*Theta*D)*Theta*D*s*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t45 = t3*t19; /* b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t46 = x[2]*p[30]; /* omega_tau*m*a3^2 */
    const double t47 = JLT_FMA(t35, t46, t38); /* t35*omega_tau*m*a3^2 + m*g*a3*(1/(s^2*Theta*D)*Theta*D*s - 2*m*a3^2*s*1/D) */
    const double t48 = t18*t46; /* omega_tau*s*omega_tau*m*a3^2 */
    const double t49 = JLT_FMA(p[10], t30, t31); /* I3/I1*omega3*1/D + omega_n*1/(s^2*Theta*D)*Theta*D*s*gamma3*1/D */
    const double t50 = x[3]*t49; /* omega_n*t49 */
    const double t51 = JLT_FNMA(p[36], t50, t47); /* t47 - 2*m*a3^2*I1*omega_n*t49 */
    const double t52 = t21*t51; /* gamma3*1/D*(t47 - 2*m*a3^2*I1*omega_n*t49) */
    const double t53 = t21*t48; /* gamma3*1/D*omega_tau*s*omega_tau*m*a3^2 */
    const double t54 = JLT_FNMA(p[31], t22, t53); /* gamma3*1/D*omega_tau*s*omega_tau*m*a3^2 - m*g*a3*s*1/D */
    const double t55 = JLT_FNMA(p[4], t50, t54); /* gamma3*1/D*omega_tau*s*omega_tau*m*a3^2 - m*g*a3*s*1/D - I1*omega_n*t49 */
    out[2] = t55;
    const double t56 = p[37]*t30; /* (-I3)*omega3*1/D */
    const double t57 = JLT_FMA(p[38], t31, t56); /* (-2*I1)*omega_n*1/(s^2*Theta*D)*Theta*D*s*gamma3*1/D + (-I3)*omega3*1/D */
    out[18] = t57;
    const double t58 = p[32]*t32; /* m*R*omega3*1/Theta */
    const double t59 = JLT_FNMA(x[0], p[34], p[33]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t60 = t33*t59; /* omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t61 = JLT_FMA(p[34], t18, t60); /* R*(I1 - I3)*omega_tau*s + t60 */
    const double t62 = JLT_FMA(p[22], t20, p[26]); /* m*R*I3*e + I3^2 */
    const double t63 = t32*t62; /* omega3*1/Theta*(m*R*I3*e + I3^2) */
    const double t64 = p[18]*t45; /* m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t65 = x[3]*p[27]; /* omega_n*m*R*I1 */
    const double t66 = t58*t59; /* m*R*omega3*1/Theta*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t67 = t11*t66; /* s*m*R*omega3*1/Theta*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t68 = p[41]*t59; /* (-m*R)*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t69 = t18*t68; /* omega_tau*s*(-m*R)*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t70 = t16*t69; /* 1/Theta*omega_tau*s*(-m*R)*(a3*I3 - gamma3*R*(I1 - I3)) */
    out[29] = t70;
    const double t71 = x[2]*t16; /* omega_tau*1/Theta */
    const double t72 = t62*t71; /* (m*R*I3*e + I3^2)*omega_tau*1/Theta */
    out[24] = t72;
    const double t73 = p[39]*t45; /* m*a3*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t74 = JLT_FNMA(t71, t73, t43); /* t43 - omega_tau*1/Theta*m*a3*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t75 = x[0]*p[23]; /* gamma3*2*m*R^2*I1 */
    const double t76 = JLT_FMS(p[24], t3, t75); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t77 = t16*t76; /* 1/Theta*d(Theta)/d(gamma3) */
    const double t78 = x[3]*p[40]; /* omega_n*m*R*a3*I1 */
    const double t79 = t71*t78; /* omega_tau*1/Theta*omega_n*m*R*a3*I1 */
    const double t80 = JLT_FMS(t58, t61, t79); /* m*R*omega3*1/Theta*(R*(I1 - I3)*omega_tau*s + t60) - omega_tau*1/Theta*omega_n*m*R*a3*I1 */
    const double t81 = p[1]*x[3]; /* R*omega_n */
    out[14] = t81;
    const double t82 = JLT_FMA(t26, t45, t81); /* gamma3*1/(s^2*Theta*D)*Theta*D*s*b*omega_n*1/(s^2*Theta*D)*Theta*D*s + R*omega_n */
    const double t83 = t19*t82; /* omega_n*1/(s^2*Theta*D)*Theta*D*s*t82 */
    out[10] = t83;
    const double t84 = x[4]*t81; /* omega3*R*omega_n */
    const double t85 = JLT_FMA(x[3], t45, t84); /* omega_n*b*omega_n*1/(s^2*Theta*D)*Theta*D*s + omega3*R*omega_n */
    out[1] = t85;
    const double t86 = x[0]*t19; /* gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t87 = p[4]*t19; /* I1*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t88 = JLT_FNMA(t29, t87, t48); /* omega_tau*s*omega_tau*m*a3^2 - 1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s*I1*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t89 = JLT_FMA(t15, t88, t52); /* 1/D*t88 + gamma3*1/D*(t47 - 2*m*a3^2*I1*omega_n*t49) */
    out[15] = t89;
    const double t90 = t24*t64; /* 1/Theta*V*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t91 = JLT_FNMA(t44, t90, t74); /* t74 - 1/(s^2*Theta*D)*Theta*D*s*gamma3*1/(s^2*Theta*D)*Theta*D*s*1/Theta*V*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t92 = t24*t65; /* 1/Theta*V*omega_n*m*R*I1 */
    const double t93 = JLT_FMA(t18, t66, t92); /* omega_tau*s*m*R*omega3*1/Theta*(a3*I3 - gamma3*R*(I1 - I3)) + 1/Theta*V*omega_n*m*R*I1 */
    const double t94 = JLT_FMA(t77, t93, t80); /* 1/Theta*d(Theta)/d(gamma3)*t93 + t80 */
    out[25] = t94;
    const double t95 = -t93; /* -t93 */
    out[4] = t95;
    const double t96 = t16*t65; /* 1/Theta*omega_n*m*R*I1 */
    const double t97 = t16*t64; /* 1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t98 = JLT_FMS(x[2], t63, t90); /* omega_tau*omega3*1/Theta*(m*R*I3*e + I3^2) - 1/Theta*V*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t99 = JLT_FNMA(t77, t98, t91); /* t91 - 1/Theta*d(Theta)/d(gamma3)*t98 */
    out[20] = t99;
    const double t100 = JLT_FMA(x[2], t86, t98); /* omega_tau*gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s + t98 */
    out[3] = t100;
    const double t101 = t63 + t86; /* omega3*1/Theta*(m*R*I3*e + I3^2) + gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t102 = JLT_FNMA(t20, t97, t101); /* t101 - e*1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    out[22] = t102;
    const double t103 = JLT_FMA(t20, t96, t67); /* e*1/Theta*omega_n*m*R*I1 + s*m*R*omega3*1/Theta*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t104 = -t97; /* -1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    out[21] = t104;
    const double t105 = -t96; /* -1/Theta*omega_n*m*R*I1 */
    out[26] = t105;
    const double t106 = -t103; /* -t103 */
    out[27] = t106;
    const double t107 = x[4]*p[1]; /* omega3*R */
    const double t108 = JLT_FMA(2.0, t45, t107); /* 2*b*omega_n*1/(s^2*Theta*D)*Theta*D*s + omega3*R */
    out[13] = t108;
    const double t109 = x[3]*p[37]; /* omega_n*(-I3) */
    const double t110 = t15*t109; /* 1/D*omega_n*(-I3) */
    out[19] = t110;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[18]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[17], t2, p[16]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t6*t7; /* Theta*D */
    const double t9 = p[35]*t6; /* 2*m*a3^2*Theta */
    const double t10 = t2*t8; /* s^2*Theta*D */
    const double t11 = 1.0/t10; /* 1/(s^2*Theta*D) */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    const double t13 = t2*t11; /* s^2*1/(s^2*Theta*D) */
    const double t14 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t15 = JLT_FMA(x[2], t14, x[1]); /* V = omega_tau*e + v_nu */
    const double t16 = t4*t15; /* m*I3*b*V */
    const double t17 = t8*t16; /* Theta*D*m*I3*b*V */
    const double t18 = t12*t17; /* s*Theta*D*m*I3*b*V */
    const double t19 = x[2]*t12; /* omega_tau*s */
    const double t20 = x[0]*t19; /* gamma3*omega_tau*s */
    const double t21 = p[28]*t20; /* m*R^2*(I1 - I3)*gamma3*omega_tau*s */
    const double t22 = JLT_FNMA(p[25], t19, t21); /* m*R^2*(I1 - I3)*gamma3*omega_tau*s - m*R*a3*I3*omega_tau*s */
    const double t23 = JLT_FNMA(t11, t18, t22); /* m*R^2*(I1 - I3)*gamma3*omega_tau*s - m*R*a3*I3*omega_tau*s - 1/(s^2*Theta*D)*s*Theta*D*m*I3*b*V */
    const double t24 = t7*t23; /* D*t23 */
    const double t25 = JLT_FMA(t9, t20, t24); /* 2*m*a3^2*Theta*gamma3*omega_tau*s + D*t23 */
    const double t26 = t13*t25; /* s^2*1/(s^2*Theta*D)*(2*m*a3^2*Theta*gamma3*omega_tau*s + D*t23) */
    out[0] = t26;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = p[43]*x[0]; /* 2*g*a3*gamma3 */
    const double t4 = JLT_FMA(x[1], x[1], t3); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t5 = p[45]*x[3]; /* I1/m*omega_n */
    const double t6 = JLT_FMA(x[3], t5, t4); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t7 = p[44]*x[2]; /* 1/m*omega_tau */
    const double t8 = x[2]*t7; /* omega_tau*1/m*omega_tau */
    const double t9 = p[46]*x[4]; /* I3/m*omega3 */
    const double t10 = JLT_FMA(x[4], t9, t6); /* omega3*I3/m*omega3 + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t13 = JLT_FMA(t8, t12, t10); /* omega_tau*1/m*omega_tau*D + t10 */
    const double t14 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t15 = x[3]*t11; /* omega_n*b */
    const double t16 = x[4]*p[1]; /* omega3*R */
    const double t17 = JLT_FMA(t14, t16, t15); /* v_tau = s*omega3*R + omega_n*b */
    const double t18 = JLT_FMA(t17, t17, t13); /* energy/(1/2*m) = v_tau*v_tau + omega_tau*1/m*omega_tau*D + t10 */
    const double t19 = p[42]*t18; /* 1/2*m*energy/(1/2*m) */
    out[0] = t19;
    const double t20 = x[3]*p[47]; /* omega_n*R*I1 */
    const double t21 = t14*t20; /* s*omega_n*R*I1 */
    const double t22 = x[4]*p[5]; /* omega3*I3 */
    const double t23 = JLT_FNMA(t11, t22, t21); /* s*omega_n*R*I1 - b*omega3*I3 */
    out[1] = t23;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[7] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = p[37]*t4; /* (-I3)*b */
    out[9] = t5;
    const double t6 = sqrt(t3); /* s = sqrt(s^2) */
    const double t7 = p[47]*t6; /* R*I1*s */
    out[8] = t7;
    const double t8 = x[0]/t3; /* gamma3/s^2 */
    const double t9 = t6*t8; /* s*gamma3/s^2 */
    const double t10 = JLT_FMA(p[30], t3, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t11 = x[2]*t10; /* omega_tau*D */
    out[2] = t11;
    const double t12 = x[3]*t4; /* omega_n*b */
    const double t13 = p[0]*t4; /* m*b */
    const double t14 = x[4]*p[1]; /* omega3*R */
    const double t15 = JLT_FMA(t6, t14, t12); /* v_tau = s*omega3*R + omega_n*b */
    const double t16 = p[30]*x[0]; /* m*a3^2*gamma3 */
    const double t17 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t18 = JLT_FNMA(t16, t17, p[31]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t19 = x[3]*p[48]; /* omega_n*(-R*I1) */
    const double t20 = t9*t19; /* s*gamma3/s^2*omega_n*(-R*I1) */
    const double t21 = JLT_FMA(x[4], p[49], t20); /* omega3*(-R*I3) + s*gamma3/s^2*omega_n*(-R*I1) */
    out[5] = t21;
    const double t22 = JLT_FNMA(x[4], t9, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*s*gamma3/s^2 */
    const double t23 = p[32]*t15; /* m*R*v_tau */
    const double t24 = JLT_FMA(t22, t23, t18); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R*v_tau + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    out[0] = t24;
    const double t25 = x[3]*p[4]; /* omega_n*I1 */
    const double t26 = JLT_FMA(t13, t15, t25); /* d(energy)/d(omega_n) = m*b*v_tau + omega_n*I1 */
    out[3] = t26;
    const double t27 = x[4]*p[5]; /* omega3*I3 */
    const double t28 = JLT_FMA(t6, t23, t27); /* d(energy)/d(omega3) = s*m*R*v_tau + omega3*I3 */
    out[4] = t28;
}

static void observe_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t5 = p[10]*x[3]; /* I3/I1*omega_n */
    const double t6 = x[4]*t5; /* omega3*I3/I1*omega_n */
    const double t7 = t2*p[9]; /* (1 - gamma3)*(1 + gamma3)*m*g*a3/I1 */
    const double t8 = x[3]*x[3]; /* omega_n*omega_n */
    const double t9 = JLT_FMA(x[2], x[2], t8); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t10 = JLT_FMA(x[0], t9, t7); /* gamma3*(omega_tau*omega_tau + omega_n*omega_n) + (1 - gamma3)*(1 + gamma3)*m*g*a3/I1 */
    const double t11 = JLT_FMA(t4, t6, t10); /* s*omega3*I3/I1*omega_n + t10 */
    const double t12 = p[50]/t3; /* a3*I1/D */
    const double t13 = JLT_FNMA(t11, t12, p[2]); /* g - (s*omega3*I3/I1*omega_n + t10)*a3*I1/D */
    const double t14 = p[0]*t13; /* m*(g - (s*omega3*I3/I1*omega_n + t10)*a3*I1/D) */
    out[0] = t14;
}

static void valid_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t5 = p[10]*x[3]; /* I3/I1*omega_n */
    const double t6 = x[4]*t5; /* omega3*I3/I1*omega_n */
    const double t7 = t2*p[9]; /* (1 - gamma3)*(1 + gamma3)*m*g*a3/I1 */
    const double t8 = x[3]*x[3]; /* omega_n*omega_n */
    const double t9 = JLT_FMA(x[2], x[2], t8); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t10 = JLT_FMA(x[0], t9, t7); /* gamma3*(omega_tau*omega_tau + omega_n*omega_n) + (1 - gamma3)*(1 + gamma3)*m*g*a3/I1 */
    const double t11 = JLT_FMA(t4, t6, t10); /* s*omega3*I3/I1*omega_n + t10 */
    const double t12 = p[50]/t3; /* a3*I1/D */
    const double t13 = JLT_FNMA(t11, t12, p[2]); /* g - (s*omega3*I3/I1*omega_n + t10)*a3*I1/D */
    const double t14 = p[0]*t13; /* m*(g - (s*omega3*I3/I1*omega_n + t10)*a3*I1/D) */
    out[0] = t14;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    for (unsigned k = 0; k < order; k++) {
        t18[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t19[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = jlt_jet_root(t20[k], t21, k);
        t22[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t23[k] = p[8]*t22[k];
        t24[k] = (k == 0 ? p[7] : 0) + t20[k];
        t25[k] = jlt_jet_product(t22, t23, k) + t24[k];
        t26[k] = p[6]*t20[k] + (k == 0 ? 1.0 : 0);
        t27[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t25, t27, k);
        t28[k] = jlt_jet_product(x2, t21, k);
        t29[k] = jlt_jet_quotient(x3[k], t21, t29, k);
        t30[k] = jlt_jet_product(t22, t29, k);
        t31[k] = p[1]*x4[k] + t30[k];
        t32[k] = jlt_jet_product(x3, t31, k);
        t33[k] = jlt_jet_product(x0, t28, k);
        t34[k] = x2[k]*p[6];
        t35[k] = jlt_jet_product(t33, t34, k);
        t36[k] = t35[k] - p[9]*t21[k];
        t37[k] = p[14]*t33[k];
        t38[k] = t37[k] - p[15]*t28[k];
        t39[k] = jlt_jet_product(x0, t29, k);
        t40[k] = x4[k]*p[10] + t39[k];
        t41[k] = t36[k] - jlt_jet_product(x3, t40, k);
        t42[k] = jlt_jet_quotient(t41[k], t26, t42, k);
        t43[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t44[k] = (k == 0 ? p[12] : 0) + t43[k];
        t45[k] = p[11]*t44[k];
        t46[k] = jlt_jet_product(x2, t43, k) + x1[k];
        t47[k] = jlt_jet_product(t27, t46, k);
        t48[k] = jlt_jet_product(x4, t27, k);
        t49[k] = jlt_jet_product(t45, t48, k) + t39[k];
        t50[k] = jlt_jet_product(x2, t49, k);
        t51[k] = jlt_jet_product(t23, t47, k);
        t52[k] = t50[k] - jlt_jet_product(t29, t51, k);
        t53[k] = x3[k]*p[13];
        t54[k] = jlt_jet_product(t47, t53, k);
        t55[k] = jlt_jet_product(t38, t48, k) - t54[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t28[k]/(k + 1);
        next[1] = x1[k + 1] = t32[k]/(k + 1);
        next[2] = x2[k + 1] = t42[k]/(k + 1);
        next[3] = x3[k + 1] = t52[k]/(k + 1);
        next[4] = x4[k + 1] = t55[k]/(k + 1);
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
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t6 = t4*t5; /* (1 - gamma3)*(1 + gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
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
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = params[4]*t3; /* I1*s */
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
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
    out[0] = t18;
    const double t19 = params[0]*params[1]; /* m*R */
    const double t20 = params[4]*t19; /* I1*m*R */
    const double t21 = params[5]*t20; /* I3*I1*m*R */
    const double t22 = x[0]*t21; /* gamma3*I3*I1*m*R */
    const double t23 = t22*x[1]; /* gamma3*I3*I1*m*R*v_nu */
    out[1] = t23;
    const double t24 = params[5]*params[5]; /* I3*I3 */
    const double t25 = x[4]*x[4]; /* omega3*omega3 */
    const double t26 = t24*t25; /* I3*I3*omega3*omega3 */
    const double t27 = t3*t26; /* s*I3*I3*omega3*omega3 */
    const double t28 = params[5] + t7; /* I3 + m*R*R */
    const double t29 = t27*t28; /* s*I3*I3*omega3*omega3*(I3 + m*R*R) */
    out[2] = t29;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[24] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t3;
    const double t4 = params[1]*x[4]; /* R*omega3 */
    out[8] = t4;
    const double t5 = x[4]*params[5]; /* omega3*I3 */
    const double t6 = t5/params[4]; /* omega3*I3/I1 */
    const double t7 = -t6; /* -omega3*I3/I1 */
    out[13] = t7;
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
    out[17] = t23;
    const double t24 = params[1]*params[0]; /* R*m */
    const double t25 = params[5]*t24; /* I3*R*m */
    const double t26 = x[0]*t25; /* gamma3*I3*R*m */
    const double t27 = t26*x[1]; /* gamma3*I3*R*m*v_nu */
    const double t28 = t3*t20; /* s*Theta */
    const double t29 = t27/t28; /* gamma3*I3*R*m*v_nu/(s*Theta) */
    const double t30 = -t29; /* -gamma3*I3*R*m*v_nu/(s*Theta) */
    out[18] = t30;
    const double t31 = x[0]*t10; /* gamma3*m*R*R */
    const double t32 = x[4]*t31; /* omega3*gamma3*m*R*R */
    const double t33 = t3*t32; /* s*omega3*gamma3*m*R*R */
    const double t34 = params[4] - params[5]; /* I1 - I3 */
    const double t35 = t33*t34; /* s*omega3*gamma3*m*R*R*(I1 - I3) */
    const double t36 = t35/t20; /* s*omega3*gamma3*m*R*R*(I1 - I3)/Theta */
    out[22] = t36;
    const double t37 = params[4]*t24; /* I1*R*m */
    const double t38 = x[1]*t37; /* v_nu*I1*R*m */
    const double t39 = t38/t20; /* v_nu*I1*R*m/Theta */
    const double t40 = -t39; /* -v_nu*I1*R*m/Theta */
    out[23] = t40;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[2] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[13] = 0.0;
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = params[3]*t0; /* a3*m*g */
    const double t2 = x[0]*params[1]; /* gamma3*R */
    const double t3 = params[3] + t2; /* b = a3 + gamma3*R */
    const double t4 = params[1]*x[4]; /* R*omega3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t7 = t5*t6; /* (1 - gamma3)*(1 + gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t9 = t4*t8; /* v_tau = R*omega3*s */
    const double t10 = params[0]*t9; /* m*v_tau */
    const double t11 = t2*x[4]; /* gamma3*R*omega3 */
    const double t12 = t11/t8; /* gamma3*R*omega3/s */
    const double t13 = t10*t12; /* m*v_tau*gamma3*R*omega3/s */
    const double t14 = t1 - t13; /* d(energy)/d(gamma3) = a3*m*g - m*v_tau*gamma3*R*omega3/s */
    out[0] = t14;
    const double t15 = params[0]*x[1]; /* m*v_nu */
    out[1] = t15;
    const double t16 = t8*t8; /* s*s */
    const double t17 = params[0]*t3; /* m*b */
    const double t18 = t9*t17; /* d(energy)/d(omega_n) = v_tau*m*b */
    out[3] = t18;
    const double t19 = x[4]*params[5]; /* omega3*I3 */
    const double t20 = params[0]*params[1]; /* m*R */
    const double t21 = t8*t20; /* s*m*R */
    const double t22 = t9*t21; /* v_tau*s*m*R */
    const double t23 = t19 + t22; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    out[4] = t23;
    const double t24 = params[1]*params[4]; /* R*I1 */
    const double t25 = params[1]*params[5]; /* R*I3 */
    const double t26 = x[4]*t25; /* omega3*R*I3 */
    const double t27 = -t26; /* -omega3*R*I3 */
    out[5] = t27;
    const double t28 = t8*t24; /* s*R*I1 */
    out[8] = t28;
    const double t29 = t3*params[5]; /* b*I3 */
    const double t30 = -t29; /* -b*I3 */
    out[9] = t30;
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
    out[10] = t43;
    const double t44 = params[0]*2.0; /* m*2 */
    const double t45 = params[4]*params[4]; /* I1*I1 */
    const double t46 = t44*t45; /* m*2*I1*I1 */
    const double t47 = x[1]*t46; /* v_nu*m*2*I1*I1 */
    out[11] = t47;
    const double t48 = params[1]*t44; /* R*m*2 */
    const double t49 = t45*t48; /* I1*I1*R*m*2 */
    const double t50 = x[1]*t49; /* v_nu*I1*I1*R*m*2 */
    out[12] = t50;
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
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
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

static void family1_charpoly(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    const double t4 = params[3]*params[3]; /* a3*a3 */
    const double t5 = params[0]*t4; /* m*a3*a3 */
    const double t6 = t3*t3; /* s*s */
    const double t7 = t5*t6; /* m*a3*a3*s*s */
    const double t8 = params[4] + t7; /* D = I1 + m*a3*a3*s*s */
    const double t9 = t3*t8; /* s*D */
    const double t10 = params[4]*params[5]; /* I1*I3 */
    const double t11 = params[1]*params[1]; /* R*R */
    const double t12 = params[0]*t11; /* m*R*R */
    const double t13 = params[4]*t12; /* I1*m*R*R */
    const double t14 = t6*t13; /* s*s*I1*m*R*R */
    const double t15 = t10 + t14; /* I1*I3 + s*s*I1*m*R*R */
    const double t16 = params[0]*params[5]; /* m*I3 */
    const double t17 = x[0]*params[1]; /* gamma3*R */
    const double t18 = params[3] + t17; /* b = a3 + gamma3*R */
    const double t19 = t18*t18; /* b*b */
    const double t20 = t16*t19; /* m*I3*b*b */
    const double t21 = t15 + t20; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t22 = t9*t21; /* s*D*Theta */
    out[0] = t22;
    const double t23 = t16*x[1]; /* m*I3*v_nu */
    const double t24 = t18*t23; /* b*m*I3*v_nu */
    const double t25 = t8*t24; /* D*b*m*I3*v_nu */
    out[1] = t25;
    const double t26 = params[5]*params[5]; /* I3*I3 */
    const double t27 = x[4]*x[4]; /* omega3*omega3 */
    const double t28 = t26*t27; /* I3*I3*omega3*omega3 */
    const double t29 = t3*t28; /* s*I3*I3*omega3*omega3 */
    const double t30 = params[0]*params[1]; /* m*R */
    const double t31 = x[0]*params[3]; /* gamma3*a3 */
    const double t32 = params[1] + t31; /* e = R + gamma3*a3 */
    const double t33 = t30*t32; /* m*R*e */
    const double t34 = params[5] + t33; /* I3 + m*R*e */
    const double t35 = t29*t34; /* s*I3*I3*omega3*omega3*(I3 + m*R*e) */
    out[2] = t35;
}

static void family1_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[24] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t3;
    const double t4 = params[1]*x[4]; /* R*omega3 */
    out[8] = t4;
    const double t5 = x[4]*params[5]; /* omega3*I3 */
    const double t6 = params[3]*params[3]; /* a3*a3 */
    const double t7 = params[0]*t6; /* m*a3*a3 */
    const double t8 = t3*t3; /* s*s */
    const double t9 = t7*t8; /* m*a3*a3*s*s */
    const double t10 = params[4] + t9; /* D = I1 + m*a3*a3*s*s */
    const double t11 = t5/t10; /* omega3*I3/D */
    const double t12 = -t11; /* -omega3*I3/D */
    out[13] = t12;
    const double t13 = params[5]*params[4]; /* I3*I1 */
    const double t14 = params[1]*params[1]; /* R*R */
    const double t15 = params[0]*t14; /* m*R*R */
    const double t16 = params[4]*t15; /* I1*m*R*R */
    const double t17 = t8*t16; /* s*s*I1*m*R*R */
    const double t18 = t13 + t17; /* I3*I1 + s*s*I1*m*R*R */
    const double t19 = params[5]*params[0]; /* I3*m */
    const double t20 = x[0]*params[1]; /* gamma3*R */
    const double t21 = params[3] + t20; /* b = a3 + gamma3*R */
    const double t22 = t21*t21; /* b*b */
    const double t23 = t19*t22; /* I3*m*b*b */
    const double t24 = t18 + t23; /* Theta = I3*I1 + s*s*I1*m*R*R + I3*m*b*b */
    const double t25 = params[1]*params[0]; /* R*m */
    const double t26 = x[0]*params[3]; /* gamma3*a3 */
    const double t27 = params[1] + t26; /* e = R + gamma3*a3 */
    const double t28 = t25*t27; /* R*m*e */
    const double t29 = params[5] + t28; /* I3 + R*m*e */
    const double t30 = t5*t29; /* omega3*I3*(I3 + R*m*e) */
    const double t31 = t30/t24; /* omega3*I3*(I3 + R*m*e)/Theta */
    out[17] = t31;
    const double t32 = t19*x[1]; /* I3*m*v_nu */
    const double t33 = t21*t32; /* b*I3*m*v_nu */
    const double t34 = t3*t24; /* s*Theta */
    const double t35 = t33/t34; /* b*I3*m*v_nu/(s*Theta) */
    const double t36 = -t35; /* -b*I3*m*v_nu/(s*Theta) */
    out[18] = t36;
    const double t37 = x[4]*t25; /* omega3*R*m */
    const double t38 = t3*t37; /* s*omega3*R*m */
    const double t39 = params[4] - params[5]; /* I1 - I3 */
    const double t40 = t20*t39; /* gamma3*R*(I1 - I3) */
    const double t41 = params[5]*params[3]; /* I3*a3 */
    const double t42 = t40 - t41; /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t43 = t38*t42; /* s*omega3*R*m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t44 = t43/t24; /* s*omega3*R*m*(gamma3*R*(I1 - I3) - I3*a3)/Theta */
    out[22] = t44;
    const double t45 = params[4]*t25; /* I1*R*m */
    const double t46 = x[1]*t45; /* v_nu*I1*R*m */
    const double t47 = t46/t24; /* v_nu*I1*R*m/Theta */
    const double t48 = -t47; /* -v_nu*I1*R*m/Theta */
    out[23] = t48;
}

static void family1_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[2] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = params[3]*t0; /* a3*m*g */
    const double t2 = x[0]*params[1]; /* gamma3*R */
    const double t3 = params[3] + t2; /* b = a3 + gamma3*R */
    const double t4 = params[1]*x[4]; /* R*omega3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t7 = t5*t6; /* (1 - gamma3)*(1 + gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t9 = t4*t8; /* v_tau = R*omega3*s */
    const double t10 = params[0]*t9; /* m*v_tau */
    const double t11 = t2*x[4]; /* gamma3*R*omega3 */
    const double t12 = t11/t8; /* gamma3*R*omega3/s */
    const double t13 = t10*t12; /* m*v_tau*gamma3*R*omega3/s */
    const double t14 = t1 - t13; /* d(energy)/d(gamma3) = a3*m*g - m*v_tau*gamma3*R*omega3/s */
    out[0] = t14;
    const double t15 = params[0]*x[1]; /* m*v_nu */
    out[1] = t15;
    const double t16 = params[0]*t3; /* m*b */
    const double t17 = t9*t16; /* d(energy)/d(omega_n) = v_tau*m*b */
    out[3] = t17;
    const double t18 = x[4]*params[5]; /* omega3*I3 */
    const double t19 = params[0]*params[1]; /* m*R */
    const double t20 = t8*t19; /* s*m*R */
    const double t21 = t9*t20; /* v_tau*s*m*R */
    const double t22 = t18 + t21; /* d(energy)/d(omega3) = omega3*I3 + v_tau*s*m*R */
    out[4] = t22;
    const double t23 = params[1]*params[4]; /* R*I1 */
    const double t24 = params[1]*params[5]; /* R*I3 */
    const double t25 = x[4]*t24; /* omega3*R*I3 */
    const double t26 = -t25; /* -omega3*R*I3 */
    out[5] = t26;
    const double t27 = t8*t23; /* s*R*I1 */
    out[8] = t27;
    const double t28 = t3*params[5]; /* b*I3 */
    const double t29 = -t28; /* -b*I3 */
    out[9] = t29;
}

static const jlt_named family1_left_null[] = {
    { "E", "" },
    { "G", "" },
};

static const unsigned char family2_is_free[] = { 1, 0, 0, 1, 0 };

static void family2_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    const double t0 = params[0]*params[1]; /* m*R */
    out[3] = params[3];
    const double t1 = t0*params[3]; /* m*R*a3 */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = t3*t4; /* (1 - gamma3)*(1 + gamma3) */
    const double t6 = sqrt(t5); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = t6*t6; /* s*s */
    const double t8 = t1*t7; /* m*R*a3*s*s */
    out[5] = params[5];
    const double t9 = params[1]*x[0]; /* R*gamma3 */
    const double t10 = params[3] + t9; /* b = a3 + R*gamma3 */
    const double t11 = params[5]*t10; /* I3*b */
    out[4] = params[4];
    const double t12 = params[1]*params[4]; /* R*I1 */
    const double t13 = x[0]*t12; /* gamma3*R*I1 */
    const double t14 = t11 - t13; /* I3*b - gamma3*R*I1 */
    const double t15 = t2*t14; /* omega_n*omega_n*(I3*b - gamma3*R*I1) */
    const double t16 = t15/t8; /* g = omega_n*omega_n*(I3*b - gamma3*R*I1)/(m*R*a3*s*s) */
    out[2] = t16;
}

static void family2_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = x[3];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = params[1]*t3; /* R*s */
    const double t5 = x[0]*params[1]; /* gamma3*R */
    const double t6 = params[3] + t5; /* b = a3 + gamma3*R */
    const double t7 = x[3]*t6; /* omega_n*b */
    const double t8 = t7/t4; /* omega_n*b/(R*s) */
    const double t9 = -t8; /* omega3 = -omega_n*b/(R*s) */
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
    out[1] = 0.0;
    out[2] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = params[3]*t0; /* a3*m*g */
    const double t2 = x[0]*params[1]; /* gamma3*R */
    const double t3 = params[3] + t2; /* b = a3 + gamma3*R */
    const double t4 = x[3]*t3; /* omega_n*b */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t7 = t5*t6; /* (1 - gamma3)*(1 + gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
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
    out[0] = t20;
    const double t21 = x[3]*params[4]; /* omega_n*I1 */
    const double t22 = params[0]*t3; /* m*b */
    const double t23 = t13*t22; /* v_tau*m*b */
    const double t24 = t21 + t23; /* d(energy)/d(omega_n) = omega_n*I1 + v_tau*m*b */
    out[3] = t24;
    const double t25 = t10*params[5]; /* omega_n*b/(R*s)*I3 */
    const double t26 = params[0]*params[1]; /* m*R */
    const double t27 = t8*t26; /* s*m*R */
    const double t28 = t13*t27; /* v_tau*s*m*R */
    const double t29 = t28 - t25; /* d(energy)/d(omega3) = v_tau*s*m*R - omega_n*b/(R*s)*I3 */
    out[4] = t29;
    const double t30 = params[1]*params[4]; /* R*I1 */
    const double t31 = x[0]*t30; /* gamma3*R*I1 */
    const double t32 = x[3]*t31; /* omega_n*gamma3*R*I1 */
    const double t33 = t32/t8; /* omega_n*gamma3*R*I1/s */
    const double t34 = params[1]*params[5]; /* R*I3 */
    const double t35 = t10*t34; /* omega_n*b/(R*s)*R*I3 */
    const double t36 = t35 - t33; /* omega_n*b/(R*s)*R*I3 - omega_n*gamma3*R*I1/s */
    out[5] = t36;
    const double t37 = t8*t30; /* s*R*I1 */
    out[8] = t37;
    const double t38 = t3*params[5]; /* b*I3 */
    const double t39 = -t38; /* -b*I3 */
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
      .charpoly = family1_charpoly,
      .matrix = family1_matrix,
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

/* The reduction level, to the table spherical_top_level, SHA-256
 * 5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d. */
static void way0_coordinates(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = 1.0;
    out[3] = 1.0;
    out[5] = 1.0;
    out[7] = 1.0;
    out[2] = x[1];
    out[4] = x[2];
    const double t0 = x[0]*params[1]; /* gamma3*R */
    const double t1 = params[3] + t0; /* b = a3 + gamma3*R */
    const double t2 = x[3]*t1; /* omega_n*b */
    const double t3 = params[1]*x[4]; /* R*omega3 */
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = x[0] + 1.0; /* gamma3 + 1 */
    const double t6 = t4*t5; /* (1 - gamma3)*(gamma3 + 1) */
    const double t7 = sqrt(t6); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = t3*t7; /* R*omega3*s */
    const double t9 = t2 + t8; /* v_tau = omega_n*b + R*omega3*s */
    out[6] = t9;
}

static void way0_params(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[4];
    out[4] = params[5];
    out[5] = params[3];
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = t0*x[3]; /* R*I1*omega_n */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = t1*t5; /* R*I1*omega_n*s */
    const double t7 = params[5]*x[4]; /* I3*omega3 */
    const double t8 = params[1]*x[0]; /* R*gamma3 */
    const double t9 = params[3] + t8; /* b = a3 + R*gamma3 */
    const double t10 = t7*t9; /* I3*omega3*b */
    const double t11 = t6 - t10; /* R*I1*omega_n*s - I3*omega3*b */
    out[6] = t11;
}

static void way0_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = t5*t5; /* s*s */
    const double t7 = t1*t6; /* R*R*I1*s*s */
    const double t8 = x[0]*params[1]; /* gamma3*R */
    const double t9 = params[5] + t8; /* b = a3 + gamma3*R */
    const double t10 = t9*t9; /* b*b */
    const double t11 = params[4]*t10; /* I3*b*b */
    const double t12 = t7 + t11; /* K = R*R*I1*s*s + I3*b*b */
    const double t13 = params[1]*params[6]; /* R*G */
    const double t14 = t5*t13; /* s*R*G */
    const double t15 = params[4]*x[3]; /* I3*v_tau */
    const double t16 = t9*t15; /* b*I3*v_tau */
    const double t17 = t14 + t16; /* s*R*G + b*I3*v_tau */
    const double t18 = t17/t12; /* (s*R*G + b*I3*v_tau)/K */
    out[3] = t18;
    const double t19 = params[1]*params[3]; /* R*I1 */
    const double t20 = x[3]*t19; /* v_tau*R*I1 */
    const double t21 = t5*t20; /* s*v_tau*R*I1 */
    const double t22 = t9*params[6]; /* b*G */
    const double t23 = t21 - t22; /* s*v_tau*R*I1 - b*G */
    const double t24 = t23/t12; /* (s*v_tau*R*I1 - b*G)/K */
    out[4] = t24;
}

static const unsigned char way0_is_angle[] = { 0, 0, 0, 0 };

static const unsigned char way0_is_root[] = { 0, 0, 0, 0, 0, 0, 0 };

static const unsigned char way0_sources[] = { 0, 0, 0, 0, 0, 0, 2 };

/* The reduction momentum, to the table spherical_top_balanced, SHA-256
 * 24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33. */
static void way1_coordinates(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = 1.0;
    out[3] = 1.0;
    const double t0 = params[1]*x[2]; /* R*omega_tau */
    const double t1 = x[1] + t0; /* v_nu + R*omega_tau */
    out[2] = t1;
    const double t2 = params[1]*params[0]; /* R*m */
    const double t3 = x[1]*t2; /* v_nu*R*m */
    const double t4 = x[2]*params[4]; /* omega_tau*I1 */
    const double t5 = t3 - t4; /* v_nu*R*m - omega_tau*I1 */
    out[4] = t5;
    const double t6 = x[0]*x[3]; /* gamma3*omega_n */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = params[0]*t7; /* m*R*R */
    const double t9 = params[4] + t8; /* I1 + m*R*R */
    const double t10 = t6*t9; /* gamma3*omega_n*(I1 + m*R*R) */
    const double t11 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t12 = x[0] + 1.0; /* gamma3 + 1 */
    const double t13 = t11*t12; /* (1 - gamma3)*(gamma3 + 1) */
    const double t14 = sqrt(t13); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t15 = x[4]*t14; /* omega3*s */
    const double t16 = t8 + params[5]; /* m*R*R + I3 */
    const double t17 = t15*t16; /* omega3*s*(m*R*R + I3) */
    const double t18 = t10 + t17; /* gamma3*omega_n*(I1 + m*R*R) + omega3*s*(m*R*R + I3) */
    out[5] = t18;
}

static void way1_params(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[4];
    out[3] = params[5];
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = t0*x[3]; /* R*I1*omega_n */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = t1*t5; /* R*I1*omega_n*s */
    const double t7 = params[5]*x[4]; /* I3*omega3 */
    const double t8 = params[1]*x[0]; /* R*gamma3 */
    const double t9 = params[3] + t8; /* b = a3 + R*gamma3 */
    const double t10 = t7*t9; /* I3*omega3*b */
    const double t11 = t6 - t10; /* R*I1*omega_n*s - I3*omega3*b */
    out[4] = t11;
    const double t12 = params[0]*params[1]; /* m*R */
    const double t13 = t12*x[1]; /* m*R*v_nu */
    const double t14 = params[4]*x[2]; /* I1*omega_tau */
    const double t15 = t13 - t14; /* m*R*v_nu - I1*omega_tau */
    const double t16 = t15*t15; /* (m*R*v_nu - I1*omega_tau)*(m*R*v_nu - I1*omega_tau) */
    const double t17 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t18 = params[1]*params[1]; /* R*R */
    const double t19 = params[0]*t18; /* m*R*R */
    const double t20 = params[4] + t19; /* I1 + m*R*R */
    const double t21 = t17*t20; /* omega_n*gamma3*(I1 + m*R*R) */
    const double t22 = t5*x[4]; /* s*omega3 */
    const double t23 = params[5] + t19; /* I3 + m*R*R */
    const double t24 = t22*t23; /* s*omega3*(I3 + m*R*R) */
    const double t25 = t21 + t24; /* omega_n*gamma3*(I1 + m*R*R) + s*omega3*(I3 + m*R*R) */
    const double t26 = t25*t25; /* (omega_n*gamma3*(I1 + m*R*R) + s*omega3*(I3 + m*R*R))*(omega_n*gamma3*(I1 + m*R*R) + s*omega3*(I3 + m*R*R)) */
    const double t27 = t16 + t26; /* (m*R*v_nu - I1*omega_tau)*(m*R*v_nu - I1*omega_tau) + t26 */
    out[5] = t27;
}

static const jlt_way_condition way1_conditions[] = {
    { "a3 = 0", 1 },
    { "omega_n^2 + omega3^2 > 0", 0 },
    { "I3 + (I1*R*s*omega_n - I3*b*omega3)^2 > 0", 0 },
};

static void way1_condition_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[3];
    const double t0 = x[3]*x[3]; /* omega_n*omega_n */
    const double t1 = x[4]*x[4]; /* omega3*omega3 */
    const double t2 = t0 + t1; /* omega_n*omega_n + omega3*omega3 */
    out[1] = t2;
    const double t3 = params[1]*params[4]; /* R*I1 */
    const double t4 = x[3]*t3; /* omega_n*R*I1 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t7 = t5*t6; /* (1 - gamma3)*(1 + gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t9 = t4*t8; /* omega_n*R*I1*s */
    const double t10 = x[4]*params[5]; /* omega3*I3 */
    const double t11 = params[1]*x[0]; /* R*gamma3 */
    const double t12 = params[3] + t11; /* b = a3 + R*gamma3 */
    const double t13 = t10*t12; /* omega3*I3*b */
    const double t14 = t9 - t13; /* omega_n*R*I1*s - omega3*I3*b */
    const double t15 = t14*t14; /* (omega_n*R*I1*s - omega3*I3*b)*(omega_n*R*I1*s - omega3*I3*b) */
    const double t16 = params[5] + t15; /* I3 + t15 */
    out[2] = t16;
}

static void way1_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[2] + t1; /* J1 = I1 + m*R*R */
    const double t3 = params[2]*x[1]; /* I1*v_slip */
    const double t4 = params[1]*params[5]; /* R*M */
    const double t5 = sin(x[2]); /* S = sin(psi) */
    const double t6 = t4*t5; /* R*M*S */
    const double t7 = t3 + t6; /* I1*v_slip + R*M*S */
    const double t8 = t7/t2; /* (I1*v_slip + R*M*S)/J1 */
    out[1] = t8;
    const double t9 = params[0]*params[1]; /* m*R */
    const double t10 = x[1]*t9; /* v_slip*m*R */
    const double t11 = params[5]*t5; /* M*S */
    const double t12 = t10 - t11; /* v_slip*m*R - M*S */
    const double t13 = t12/t2; /* (v_slip*m*R - M*S)/J1 */
    out[2] = t13;
    const double t14 = params[2]*params[3]; /* I1*I3 */
    const double t15 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t16 = x[0] + 1.0; /* gamma3 + 1 */
    const double t17 = t15*t16; /* (1 - gamma3)*(gamma3 + 1) */
    const double t18 = sqrt(t17); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t19 = t18*t18; /* s*s */
    const double t20 = params[2]*t19; /* I1*s*s */
    const double t21 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t22 = params[3]*t21; /* I3*gamma3*gamma3 */
    const double t23 = t20 + t22; /* I1*s*s + I3*gamma3*gamma3 */
    const double t24 = t1*t23; /* m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t25 = t14 + t24; /* Theta = I1*I3 + m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t26 = t18*params[4]; /* s*G */
    const double t27 = t1 + params[3]; /* J3 = m*R*R + I3 */
    const double t28 = t26*t27; /* s*G*J3 */
    const double t29 = t28/params[1]; /* s*G*J3/R */
    const double t30 = params[5]*params[3]; /* M*I3 */
    const double t31 = x[0]*t30; /* gamma3*M*I3 */
    const double t32 = cos(x[2]); /* C = cos(psi) */
    const double t33 = t31*t32; /* gamma3*M*I3*C */
    const double t34 = t29 + t33; /* s*G*J3/R + gamma3*M*I3*C */
    const double t35 = t34/t25; /* (s*G*J3/R + gamma3*M*I3*C)/Theta */
    out[3] = t35;
    const double t36 = params[2]*params[5]; /* I1*M */
    const double t37 = t18*t36; /* s*I1*M */
    const double t38 = t32*t37; /* C*s*I1*M */
    const double t39 = x[0]*params[4]; /* gamma3*G */
    const double t40 = t2*t39; /* J1*gamma3*G */
    const double t41 = t40/params[1]; /* J1*gamma3*G/R */
    const double t42 = t38 - t41; /* C*s*I1*M - J1*gamma3*G/R */
    const double t43 = t42/t25; /* (C*s*I1*M - J1*gamma3*G/R)/Theta */
    out[4] = t43;
}

static const unsigned char way1_is_angle[] = { 0, 0, 1 };

static const unsigned char way1_is_root[] = { 0, 0, 0, 0, 0, 1 };

static const unsigned char way1_sources[] = { 0, 0, 0, 0, 2, 2 };

/* The lift track, to the table spherical_top_track, SHA-256
 * 625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735. */
static void way2_coordinates(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = 1.0;
    out[3] = 1.0;
    out[5] = 1.0;
    out[7] = 1.0;
    out[9] = 1.0;
    out[11] = 1.0;
    out[13] = 1.0;
    out[15] = 1.0;
    out[17] = 1.0;
    out[2] = x[1];
    out[4] = x[2];
    out[6] = x[3];
    out[8] = x[4];
    out[10] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = params[3]*t3; /* a3*s */
    out[14] = t4;
}

static void way2_params(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
}

static void way2_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    out[3] = x[3];
    out[4] = x[4];
}

static const unsigned char way2_is_angle[] = { 0, 0, 0, 0, 0, 0, 0, 0, 0 };

static const unsigned char way2_is_root[] = { 0, 0, 0, 0, 0, 0 };

static const unsigned char way2_sources[] = { 0, 0, 0, 0, 0, 0 };

/* The lift full, to the table spherical_top_full, SHA-256
 * 5de9745ff1945082f709f85b1765ec2e95addd9d5431b2def563648618d9e642. */
static void way3_coordinates(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = 0.0;
    out[18] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    out[32] = 0.0;
    out[1] = 1.0;
    out[3] = 1.0;
    out[5] = 1.0;
    out[7] = 1.0;
    out[9] = 1.0;
    out[11] = 1.0;
    out[13] = 1.0;
    out[15] = 1.0;
    out[17] = 1.0;
    out[19] = 1.0;
    out[21] = 1.0;
    out[23] = 1.0;
    out[25] = 1.0;
    out[27] = 1.0;
    out[29] = 1.0;
    out[31] = 1.0;
    out[33] = 1.0;
    out[24] = (-1.0);
    out[4] = x[0];
    out[20] = x[0];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    out[22] = t3;
    const double t4 = -t3; /* -s */
    out[2] = t4;
    out[14] = x[3];
    const double t5 = x[0]*params[1]; /* gamma3*R */
    const double t6 = params[3] + t5; /* b = a3 + gamma3*R */
    const double t7 = x[3]*t6; /* omega_n*b */
    out[16] = x[4];
    const double t8 = params[1]*x[4]; /* R*omega3 */
    const double t9 = t3*t8; /* s*R*omega3 */
    const double t10 = t7 + t9; /* v_tau = omega_n*b + s*R*omega3 */
    out[6] = t10;
    const double t11 = x[0]*x[1]; /* gamma3*v_nu */
    out[12] = x[2];
    const double t12 = params[3]*x[2]; /* a3*omega_tau */
    const double t13 = t3*t3; /* s*s */
    const double t14 = t12*t13; /* a3*omega_tau*s*s */
    const double t15 = t11 - t14; /* gamma3*v_nu - a3*omega_tau*s*s */
    out[8] = t15;
    const double t16 = t3*x[1]; /* s*v_nu */
    const double t17 = x[0]*params[3]; /* gamma3*a3 */
    const double t18 = x[2]*t17; /* omega_tau*gamma3*a3 */
    const double t19 = t3*t18; /* s*omega_tau*gamma3*a3 */
    const double t20 = t16 + t19; /* s*v_nu + s*omega_tau*gamma3*a3 */
    out[10] = t20;
    const double t21 = t3*params[3]; /* s*a3 */
    out[30] = t21;
}

static void way3_params(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
}

static const jlt_way_condition way3_conditions[] = {
    { "I3 > 0", 0 },
};

static void way3_condition_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[5];
}

static void way3_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[2];
    const double t0 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t1 = x[1]*x[1]; /* gamma2*gamma2 */
    const double t2 = t0 + t1; /* gamma1*gamma1 + gamma2*gamma2 */
    const double t3 = sqrt(t2); /* s = sqrt(gamma1*gamma1 + gamma2*gamma2) */
    const double t4 = x[0]*x[3]; /* gamma1*v1 */
    const double t5 = x[1]*x[4]; /* gamma2*v2 */
    const double t6 = t4 + t5; /* gamma1*v1 + gamma2*v2 */
    const double t7 = x[2]*x[5]; /* gamma3*v3 */
    const double t8 = t6 + t7; /* gamma1*v1 + gamma2*v2 + gamma3*v3 */
    const double t9 = x[2]*t8; /* gamma3*(gamma1*v1 + gamma2*v2 + gamma3*v3) */
    const double t10 = x[5] - t9; /* v3 - gamma3*(gamma1*v1 + gamma2*v2 + gamma3*v3) */
    const double t11 = t10/t3; /* (v3 - gamma3*(gamma1*v1 + gamma2*v2 + gamma3*v3))/s */
    out[1] = t11;
    const double t12 = x[0]*x[7]; /* gamma1*omega2 */
    const double t13 = x[1]*x[6]; /* gamma2*omega1 */
    const double t14 = t12 - t13; /* dgamma3 = gamma1*omega2 - gamma2*omega1 */
    const double t15 = t14/t3; /* dgamma3/s */
    out[2] = t15;
    const double t16 = x[0]*x[6]; /* gamma1*omega1 */
    const double t17 = x[1]*x[7]; /* gamma2*omega2 */
    const double t18 = t16 + t17; /* q = gamma1*omega1 + gamma2*omega2 */
    const double t19 = t18/t3; /* q/s */
    const double t20 = -t19; /* -q/s */
    out[3] = t20;
    out[4] = x[8];
}

static const unsigned char way3_is_angle[] = { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 };

static const unsigned char way3_is_root[] = { 0, 0, 0, 0, 0, 0 };

static const unsigned char way3_sources[] = { 0, 0, 0, 0, 0, 0 };

static const jlt_way ways[] = {
    { .name = "level", .kind = "reduction", .model = "spherical_top_level", .file = "spherical_top_level.tt",
      .sha256 = "5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d",
      .time = "", .claim = 25,
      .state_count = 4, .param_count = 7, .coordinate_count = 4,
      .is_angle = way0_is_angle,
      .coordinates = way0_coordinates,
      .back = way0_back,
      .is_root = way0_is_root, .sources = way0_sources,
      .params = way0_params,
    },
    { .name = "momentum", .kind = "reduction", .model = "spherical_top_balanced", .file = "spherical_top_balanced.tt",
      .sha256 = "24a45271f1bb41ba5e244e58a9d3bf86965e07f3e00bac5fa205b37831e8cb33",
      .time = "", .claim = 26,
      .state_count = 3, .param_count = 6, .coordinate_count = 3,
      .is_angle = way1_is_angle,
      .coordinates = way1_coordinates,
      .back = way1_back,
      .is_root = way1_is_root, .sources = way1_sources,
      .params = way1_params,
      .condition_count = 3, .conditions = way1_conditions,
      .condition_values = way1_condition_values,
    },
    { .name = "track", .kind = "lift", .model = "spherical_top_track", .file = "spherical_top_track.tt",
      .sha256 = "625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735",
      .time = "", .claim = 27,
      .state_count = 9, .param_count = 6, .coordinate_count = 9,
      .is_angle = way2_is_angle,
      .coordinates = way2_coordinates,
      .back = way2_back,
      .is_root = way2_is_root, .sources = way2_sources,
      .params = way2_params,
    },
    { .name = "full", .kind = "lift", .model = "spherical_top_full", .file = "spherical_top_full.tt",
      .sha256 = "5de9745ff1945082f709f85b1765ec2e95addd9d5431b2def563648618d9e642",
      .time = "", .claim = 28,
      .state_count = 17, .param_count = 6, .coordinate_count = 17,
      .is_angle = way3_is_angle,
      .coordinates = way3_coordinates,
      .back = way3_back,
      .is_root = way3_is_root, .sources = way3_sources,
      .params = way3_params,
      .condition_count = 1, .conditions = way3_conditions,
      .condition_values = way3_condition_values,
    },
};

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "G", "" },
};

static const jlt_quantity observes[] = {
    { "contact_force", "kg*m/s^2", "force of the plane on the sphere, upwards", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_validity valids[] = {
    { "contact", "kg*m/s^2", "the plane only pushes" },
};

static const signed char signs_7[] = { 1, -1, -1, 1, 1 };
static const jlt_reversor reversors[] = {
    { signs_7, 7 },
};

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_spherical_top_general = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .scales = 1,
    .state_count = 5, .param_count = 6, .prepared_count = 51,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 26, 13, 1, 1, 0, 12, 10 }, { 17, 69, 0, 12, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, a part of d(v_nu)/dt, e = gamma3*a3 + R, ((I1 - I3)/I1)*gamma3*omega_tau*s - (a3*I3/(R*I1))*omega_tau*s, I3/(m*R) + e, V = omega_tau*e + v_nu, a part of d(omega_n)/dt, a part of d(omega_tau)/dt, a part of d(omega_tau)/dt, d(omega_n)/dt, d(omega3)/dt" },
    .jacobian = { jacobian, 25, { 9, 53, 30, 1, 1, 0, 17, 19 }, { 52, 271, 0, 49, 1, 0, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, omega3*(I3/I1) + gamma3*omega_n*((1)/s^2*Theta*D/I1)*Theta*D/I1*s, e = gamma3*a3 + R, a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), (m*R*I3)*e + I3^2, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), omega_tau*a3 - 1/Theta*V*d(Theta)/d(gamma3), m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*((m*R*I3)*e + I3^2), d(d(omega_n)/dt)/d(omega_tau), omega3*(1/2*I3/I1) + gamma3*omega_n*((1)/s^2*Theta*D/I1)*Theta*D/I1*s, d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), a part of d(d(omega3)/dt)/d(omega_tau), d(d(v_nu)/dt)/d(omega_n)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 9, 65, 35, 1, 1, 0, 16, 24 }, { 62, 323, 0, 61, 1, 0, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(d(omega_n)/dt)/d(omega_n), a part of d(d(omega_tau)/dt)/d(gamma3), ((1)/s^2*Theta*D)*Theta*D*s - (2*m*a3^2)*s*1/D, a part of d(d(omega_n)/dt)/d(gamma3), (I3/I1)*omega3*1/D + omega_n*((1)/s^2*Theta*D)*Theta*D*s*gamma3*1/D, a part of d(d(omega_tau)/dt)/d(gamma3), d(omega_tau)/dt, d(d(omega_tau)/dt)/d(omega_n), a3*I3 - gamma3*(R*(I1 - I3)), a part of d(d(omega3)/dt)/d(gamma3), (m*R*I3)*e + I3^2, d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), a part of d(d(v_nu)/dt)/d(gamma3), d(v_nu)/dt, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(omega_n)/dt, d(d(omega_n)/dt)/d(omega_tau), a part of d(d(omega3)/dt)/d(omega_tau), d(d(v_nu)/dt)/d(omega_n)" },
    .divergence = { divergence, 1, { 2, 14, 9, 1, 1, 0, 11, 9 }, { 11, 38, 0, 4, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, V = omega_tau*e + v_nu, a part of the divergence, a part of the divergence" },
    .integral_values = { integral_values, 2, { 2, 12, 9, 0, 1, 0, 7, 6 }, { 10, 32, 0, 0, 1, 0, 12, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*omega3*R + omega_n*b, energy/(1/2*m), G" },
    .integral_gradients = { integral_gradients, 10, { 2, 16, 9, 1, 1, 0, 6, 7 }, { 12, 38, 0, 2, 1, 0, 8, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*omega3*R + omega_n*b, d(G)/d(gamma3), d(v_tau)/d(gamma3)/R = omega_n - omega3*s*(gamma3/s^2), d(E)/d(gamma3), d(E)/d(omega_n), d(E)/d(omega3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { observe_values, 1, { 2, 6, 5, 1, 1, 0, 7, 6 }, { 7, 26, 0, 4, 1, 0, 14, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of contact_force, a part of contact_force" },
    .valid_values = { valid_values, 1, { 2, 6, 5, 1, 1, 0, 7, 6 }, { 7, 26, 0, 4, 1, 0, 14, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of contact, a part of contact" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .observe_count = 1, .observes = observes,
    .valid_count = 1, .valids = valids,
    .reversor_count = 1, .reversors = reversors,
    .pole_count = 1, .poles = poles,
    .tier = "five", .tier_meaning = "the reduced system (3.2)",
    .way_count = 4, .ways = ways,
    .integral_count = 2, .measure_count = 0, .equilibria_count = 3,
    .integrals = integrals,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_general) },
#endif
};
