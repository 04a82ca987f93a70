/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Table:      spherical_top, SHA-256 ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   26   13    1    1    0     12   10   (99)
 *  jacobian            9   56   30    1    1    0     16   21   (373)
 *  rhs_jacobian        10   64   34    1    1    0     17   26   (447)
 *  divergence          3   14    8    1    1    0     14    7   (54)
 *  integral_values     2   12    9    0    1    0      7    6   (43)
 *  integral_gradients  2   16    9    1    1    0      6    7   (53)
 *  observe_values      2    6    5    1    1    0      7    5   (38)
 *  valid_values        2    6    5    1    1    0      7    5   (38)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, V = omega_tau*e + v_nu,
 *      (m*R)*e + I3, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), omega_tau*1/s^2 - (m*R*I3)*1/Theta*V,
 *      I1*gamma3*omega_n*1/s^2*s + omega3*I3, numerator of d(omega_tau)/dt over D,
 *      numerator of d(omega_n)/dt over Theta = omega3*I3*omega_tau*((m*R)*e + I3) - V*(m*I3)*b*omega_n*1/s^2*s,
 *      d(omega_n)/dt, a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n),
 *      d(d(v_nu)/dt)/d(omega_n), R*omega3 - b*omega_n*1/s^2*s, d(numerator of d(omega3)/dt over Theta)/d(gamma3),
 *      gamma3*omega_tau*gamma3*1/s^2*s - omega_tau*s, d(numerator of d(omega_tau)/dt over D)/d(gamma3),
 *      d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), a part of d(d(omega_n)/dt)/d(gamma3),
 *      a part of d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3),
 *      s*omega3*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))) + e*omega_n*(m*R*I1),
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = omega3*I3*((m*R)*e + I3) - e*(m*I3)*b*omega_n*1/s^2*s,
 *      d(d(omega_n)/dt)/d(omega_tau), (2*I1)*gamma3*omega_n*1/s^2*s + omega3*I3,
 *      b*omega_n*1/s^2*s*gamma3*1/s^2*s + omega_n*R, d(v_nu)/dt, a part of d(d(omega_tau)/dt)/d(gamma3)
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
    out[19] = t1;
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    out[6] = t2;
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    out[7] = t5;
    const double t6 = params[4]*t3; /* I1*R*R */
    const double t7 = params[5]/t6; /* I3/(I1*R*R) */
    out[8] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[9] = t8;
    const double t9 = params[0]*params[2]; /* m*g */
    const double t10 = params[3]*t9; /* a3*m*g */
    out[32] = t10;
    const double t11 = t10/params[4]; /* a3*m*g/I1 */
    out[10] = t11;
    const double t12 = params[4]*params[1]; /* I1*R */
    out[41] = t12;
    const double t13 = params[5]/t12; /* I3/(I1*R) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[33] = t14;
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[12] = t15;
    const double t16 = 1.0/params[1]; /* 1/R */
    out[13] = t16;
    const double t17 = params[3]*params[5]; /* a3*I3 */
    const double t18 = t17/t12; /* a3*I3/(I1*R) */
    out[14] = t18;
    const double t19 = params[4] - params[5]; /* I1 - I3 */
    const double t20 = t19/params[4]; /* (I1 - I3)/I1 */
    out[15] = t20;
    const double t21 = params[4]*params[5]; /* I1*I3 */
    out[16] = t21;
    const double t22 = params[4]*t4; /* I1*m*R*R */
    out[17] = t22;
    const double t23 = params[0]*params[5]; /* m*I3 */
    out[18] = t23;
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t0*t24; /* a3*a3*m*2 */
    out[20] = t25;
    const double t26 = params[5]*2.0; /* I3*2 */
    out[21] = t26;
    const double t27 = params[4]*2.0; /* I1*2 */
    out[22] = t27;
    const double t28 = -params[5]; /* -I3 */
    out[23] = t28;
    const double t29 = t3*t24; /* R*R*m*2 */
    const double t30 = params[4]*t29; /* I1*R*R*m*2 */
    out[24] = t30;
    const double t31 = params[1]*t24; /* R*m*2 */
    const double t32 = params[5]*t31; /* I3*R*m*2 */
    out[25] = t32;
    const double t33 = params[5]*t14; /* I3*m*R */
    out[26] = t33;
    const double t34 = params[3]*t14; /* a3*m*R */
    const double t35 = params[5]*t34; /* I3*a3*m*R */
    out[27] = t35;
    const double t36 = params[5]*params[5]; /* I3*I3 */
    out[28] = t36;
    const double t37 = params[4]*t14; /* I1*m*R */
    out[29] = t37;
    const double t38 = t4*t19; /* m*R*R*(I1 - I3) */
    out[30] = t38;
    const double t39 = -t37; /* -I1*m*R */
    out[31] = t39;
    const double t40 = params[0]*params[3]; /* m*a3 */
    const double t41 = params[5]*t40; /* I3*m*a3 */
    out[34] = t41;
    const double t42 = params[4]*t34; /* I1*a3*m*R */
    out[35] = t42;
    const double t43 = params[0]/2.0; /* m/2 */
    out[36] = t43;
    const double t44 = params[2]*2.0; /* g*2 */
    const double t45 = params[3]*t44; /* a3*g*2 */
    out[37] = t45;
    const double t46 = 1.0/params[0]; /* 1/m */
    out[38] = t46;
    const double t47 = params[4]/params[0]; /* I1/m */
    out[39] = t47;
    const double t48 = params[5]/params[0]; /* I3/m */
    out[40] = t48;
    const double t49 = -t12; /* -I1*R */
    out[42] = t49;
    const double t50 = params[1]*params[5]; /* R*I3 */
    const double t51 = -t50; /* -R*I3 */
    out[43] = t51;
    const double t52 = params[3]*params[4]; /* a3*I1 */
    out[44] = t52;
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
    const double t21 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t22 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t23 = x[2]*t14; /* omega_tau*s */
    out[0] = t23;
    const double t24 = p[6]*t21; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t25 = t23*t24; /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t26 = JLT_FNMA(p[10], t14, t25); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s */
    const double t27 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = t13*t27; /* 1/(Theta/(m*R^2*I1))*V */
    const double t29 = JLT_FNMA(t5, t28, t21); /* omega_tau*gamma3 - I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V */
    const double t30 = p[12] + t22; /* I3/(m*R) + e */
    const double t31 = x[4]*t13; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t32 = t16*t29; /* t16*(omega_tau*gamma3 - I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V) */
    const double t33 = x[0]*t16; /* gamma3*t16 */
    const double t34 = JLT_FMA(x[4], p[9], t33); /* omega3*I3/I1 + gamma3*t16 */
    const double t35 = JLT_FNMA(x[3], t34, t26); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s - omega_n*(omega3*I3/I1 + gamma3*t16) */
    const double t36 = t17*t35; /* s^2*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D/I1)*t35 */
    out[2] = t36;
    const double t37 = x[3]*p[13]; /* omega_n*1/R */
    const double t38 = t28*t37; /* 1/(Theta/(m*R^2*I1))*V*omega_n*1/R */
    const double t39 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t40 = t23*t39; /* omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t41 = JLT_FMA(t31, t40, t38); /* omega3*1/(Theta/(m*R^2*I1))*omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + 1/(Theta/(m*R^2*I1))*V*omega_n*1/R */
    const double t42 = -t41; /* -t41 */
    out[4] = t42;
    const double t43 = x[2]*p[11]; /* omega_tau*I3/(R*I1) */
    const double t44 = t30*t43; /* (I3/(m*R) + e)*omega_tau*I3/(R*I1) */
    const double t45 = JLT_FMA(t31, t44, t32); /* omega3*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e)*omega_tau*I3/(R*I1) + t32 */
    out[3] = t45;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = t4*p[18]; /* b*m*I3 */
    const double t6 = JLT_FMA(t2, p[17], p[16]); /* s^2*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*b*m*I3 + s^2*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t2, p[19], p[4]); /* D = s^2*m*a3^2 + I1 */
    const double t9 = t2*t7; /* s^2*Theta */
    const double t10 = t8*t9; /* D*s^2*Theta */
    const double t11 = 1.0/t10; /* 1/(D*s^2*Theta) */
    const double t12 = t8*t11; /* D*1/(D*s^2*Theta) */
    const double t13 = t3*t7; /* s*Theta */
    const double t14 = t12*t13; /* D*1/(D*s^2*Theta)*s*Theta */
    const double t15 = x[0]*t14; /* gamma3*D*1/(D*s^2*Theta)*s*Theta */
    const double t16 = x[2]*t15; /* omega_tau*gamma3*D*1/(D*s^2*Theta)*s*Theta */
    const double t17 = -t16; /* -omega_tau*gamma3*D*1/(D*s^2*Theta)*s*Theta */
    out[0] = t17;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    const double t18 = p[1]*x[3]; /* R*omega_n */
    out[9] = t18;
    const double t19 = t14*x[3]; /* D*1/(D*s^2*Theta)*s*Theta*omega_n */
    const double t20 = t4*t19; /* b*D*1/(D*s^2*Theta)*s*Theta*omega_n */
    const double t21 = JLT_FMA(t15, t20, t18); /* gamma3*D*1/(D*s^2*Theta)*s*Theta*b*D*1/(D*s^2*Theta)*s*Theta*omega_n + R*omega_n */
    const double t22 = t19*t21; /* D*1/(D*s^2*Theta)*s*Theta*omega_n*t21 */
    out[5] = t22;
    const double t23 = p[1]*x[4]; /* R*omega3 */
    const double t24 = JLT_FMA(t20, 2.0, t23); /* b*D*1/(D*s^2*Theta)*s*Theta*omega_n*2 + R*omega3 */
    out[8] = t24;
    const double t25 = t9*t11; /* 1/D = s^2*Theta*1/(D*s^2*Theta) */
    const double t26 = t3*t25; /* s*1/D */
    const double t27 = x[0]*t25; /* gamma3*1/D */
    const double t28 = t3*p[20]; /* s*2*m*a3^2 */
    const double t29 = t27*t28; /* gamma3*1/D*s*2*m*a3^2 */
    const double t30 = t29 - t15; /* gamma3*1/D*s*2*m*a3^2 - gamma3*D*1/(D*s^2*Theta)*s*Theta */
    const double t31 = JLT_FMA(t27, t30, t26); /* gamma3*1/D*(gamma3*1/D*s*2*m*a3^2 - gamma3*D*1/(D*s^2*Theta)*s*Theta) + s*1/D */
    const double t32 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t33 = t31*t32; /* t31*omega_tau*omega_tau */
    const double t34 = x[4]*t25; /* omega3*1/D */
    const double t35 = t27*p[22]; /* gamma3*1/D*2*I1 */
    const double t36 = t19*t35; /* D*1/(D*s^2*Theta)*s*Theta*omega_n*gamma3*1/D*2*I1 */
    const double t37 = JLT_FMA(p[21], t34, t36); /* 2*I3*omega3*1/D + D*1/(D*s^2*Theta)*s*Theta*omega_n*gamma3*1/D*2*I1 */
    const double t38 = x[3]*t27; /* omega_n*gamma3*1/D */
    const double t39 = JLT_FNMA(t37, t38, t33); /* t31*omega_tau*omega_tau - t37*omega_n*gamma3*1/D */
    const double t40 = p[19]*t39; /* m*a3^2*(t31*omega_tau*omega_tau - t37*omega_n*gamma3*1/D) */
    const double t41 = t14*t19; /* D*1/(D*s^2*Theta)*s*Theta*D*1/(D*s^2*Theta)*s*Theta*omega_n */
    const double t42 = t19*t41; /* D*1/(D*s^2*Theta)*s*Theta*omega_n*D*1/(D*s^2*Theta)*s*Theta*D*1/(D*s^2*Theta)*s*Theta*omega_n */
    const double t43 = JLT_FMA(t30, p[10], t42); /* (gamma3*1/D*s*2*m*a3^2 - gamma3*D*1/(D*s^2*Theta)*s*Theta)*m*g*a3/I1 + t42 */
    const double t44 = p[4]*t25; /* I1*1/D */
    const double t45 = JLT_FNMA(t43, t44, t40); /* m*a3^2*(t31*omega_tau*omega_tau - t37*omega_n*gamma3*1/D) - t43*I1*1/D */
    out[10] = t45;
    const double t46 = x[2]*t29; /* omega_tau*gamma3*1/D*s*2*m*a3^2 */
    out[12] = t46;
    const double t47 = JLT_FMA(t34, p[5], t36); /* omega3*1/D*I3 + D*1/(D*s^2*Theta)*s*Theta*omega_n*gamma3*1/D*2*I1 */
    const double t48 = -t47; /* -t47 */
    out[13] = t48;
    const double t49 = x[3]*p[23]; /* omega_n*(-I3) */
    const double t50 = t25*t49; /* 1/D*omega_n*(-I3) */
    out[14] = t50;
    const double t51 = t2*t12; /* 1/Theta = s^2*D*1/(D*s^2*Theta) */
    const double t52 = t5*t51; /* b*m*I3*1/Theta */
    const double t53 = t19*t52; /* D*1/(D*s^2*Theta)*s*Theta*omega_n*b*m*I3*1/Theta */
    const double t54 = x[2]*p[3]; /* omega_tau*a3 */
    const double t55 = x[0]*p[24]; /* gamma3*2*m*R^2*I1 */
    const double t56 = JLT_FMS(t4, p[25], t55); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t57 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t58 = JLT_FMA(x[2], t57, x[1]); /* V = omega_tau*e + v_nu */
    const double t59 = t51*t58; /* 1/Theta*V */
    const double t60 = JLT_FNMA(t56, t59, t54); /* omega_tau*a3 - d(Theta)/d(gamma3)*1/Theta*V */
    const double t61 = t53*t60; /* D*1/(D*s^2*Theta)*s*Theta*omega_n*b*m*I3*1/Theta*(omega_tau*a3 - d(Theta)/d(gamma3)*1/Theta*V) */
    const double t62 = x[2]*t14; /* omega_tau*D*1/(D*s^2*Theta)*s*Theta */
    const double t63 = t5*t14; /* b*m*I3*D*1/(D*s^2*Theta)*s*Theta */
    const double t64 = JLT_FMA(t15, t63, p[26]); /* gamma3*D*1/(D*s^2*Theta)*s*Theta*b*m*I3*D*1/(D*s^2*Theta)*s*Theta + m*R*I3 */
    const double t65 = t19*t59; /* D*1/(D*s^2*Theta)*s*Theta*omega_n*1/Theta*V */
    const double t66 = x[2]*t51; /* omega_tau*1/Theta */
    const double t67 = x[4]*t66; /* omega3*omega_tau*1/Theta */
    const double t68 = JLT_FMA(t57, p[26], p[28]); /* e*m*R*I3 + I3^2 */
    const double t69 = t51*t68; /* 1/Theta*(e*m*R*I3 + I3^2) */
    const double t70 = JLT_FNMA(t56, t69, p[27]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(e*m*R*I3 + I3^2) */
    const double t71 = JLT_FMS(t41, t62, t61); /* D*1/(D*s^2*Theta)*s*Theta*D*1/(D*s^2*Theta)*s*Theta*omega_n*omega_tau*D*1/(D*s^2*Theta)*s*Theta - t61 */
    const double t72 = JLT_FNMA(t64, t65, t71); /* t71 - t64*D*1/(D*s^2*Theta)*s*Theta*omega_n*1/Theta*V */
    const double t73 = JLT_FMA(t67, t70, t72); /* omega3*omega_tau*1/Theta*(m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(e*m*R*I3 + I3^2)) + t71 - t64*D*1/(D*s^2*Theta)*s*Theta*omega_n*1/Theta*V */
    out[15] = t73;
    const double t74 = -t53; /* -D*1/(D*s^2*Theta)*s*Theta*omega_n*b*m*I3*1/Theta */
    out[16] = t74;
    const double t75 = x[0]*t19; /* gamma3*D*1/(D*s^2*Theta)*s*Theta*omega_n */
    const double t76 = JLT_FMA(x[4], t69, t75); /* omega3*1/Theta*(e*m*R*I3 + I3^2) + gamma3*D*1/(D*s^2*Theta)*s*Theta*omega_n */
    const double t77 = JLT_FNMA(t53, t57, t76); /* t76 - D*1/(D*s^2*Theta)*s*Theta*omega_n*b*m*I3*1/Theta*e */
    out[17] = t77;
    const double t78 = JLT_FNMA(t59, t63, t16); /* omega_tau*gamma3*D*1/(D*s^2*Theta)*s*Theta - 1/Theta*V*b*m*I3*D*1/(D*s^2*Theta)*s*Theta */
    out[18] = t78;
    const double t79 = x[2]*t69; /* omega_tau*1/Theta*(e*m*R*I3 + I3^2) */
    out[19] = t79;
    const double t80 = x[3]*p[29]; /* omega_n*m*R*I1 */
    const double t81 = t51*t80; /* 1/Theta*omega_n*m*R*I1 */
    const double t82 = t60*t81; /* (omega_tau*a3 - d(Theta)/d(gamma3)*1/Theta*V)*1/Theta*omega_n*m*R*I1 */
    const double t83 = t3*p[30]; /* s*m*R^2*(I1 - I3) */
    const double t84 = JLT_FNMA(x[0], p[30], p[27]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t85 = t3*t84; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t86 = t51*t85; /* 1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t87 = JLT_FMA(t56, t86, t83); /* d(Theta)/d(gamma3)*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + s*m*R^2*(I1 - I3) */
    const double t88 = JLT_FMA(t15, t84, t87); /* gamma3*D*1/(D*s^2*Theta)*s*Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + t87 */
    const double t89 = JLT_FMS(t67, t88, t82); /* omega3*omega_tau*1/Theta*t88 - t82 */
    out[20] = t89;
    const double t90 = -t81; /* -1/Theta*omega_n*m*R*I1 */
    out[21] = t90;
    const double t91 = x[4]*t86; /* omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t92 = JLT_FMA(t57, t81, t91); /* e*1/Theta*omega_n*m*R*I1 + omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t93 = -t92; /* -t92 */
    out[22] = t93;
    const double t94 = t59*p[31]; /* 1/Theta*V*(-m*R*I1) */
    out[23] = t94;
    const double t95 = t66*t85; /* omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t96 = -t95; /* -omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[24] = t96;
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
    const double t7 = JLT_FMA(p[19], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t6*t7; /* Theta*D */
    const double t9 = t2*t8; /* s^2*Theta*D */
    const double t10 = 1.0/t9; /* 1/(s^2*Theta*D) */
    const double t11 = t8*t10; /* 1/s^2 = Theta*D*1/(s^2*Theta*D) */
    const double t12 = t2*t10; /* 1/(D*Theta) = s^2*1/(s^2*Theta*D) */
    const double t13 = sqrt(t2); /* s = sqrt(s^2) */
    out[7] = t13;
    const double t14 = t7*t12; /* 1/Theta = D*1/(D*Theta) */
    const double t15 = t6*t12; /* 1/D = Theta*1/(D*Theta) */
    const double t16 = t11*t13; /* 1/s^2*s */
    const double t17 = x[2]*t11; /* omega_tau*1/s^2 */
    const double t18 = x[3]*t16; /* omega_n*1/s^2*s */
    const double t19 = x[2]*p[19]; /* omega_tau*m*a3^2 */
    const double t20 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t21 = x[2]*t13; /* omega_tau*s */
    out[0] = t21;
    const double t22 = t3*t18; /* b*omega_n*1/s^2*s */
    const double t23 = x[0]*t19; /* gamma3*omega_tau*m*a3^2 */
    const double t24 = t21*t23; /* omega_tau*s*gamma3*omega_tau*m*a3^2 */
    const double t25 = JLT_FNMA(p[32], t13, t24); /* omega_tau*s*gamma3*omega_tau*m*a3^2 - m*g*a3*s */
    const double t26 = JLT_FMA(x[2], t20, x[1]); /* V = omega_tau*e + v_nu */
    const double t27 = x[4]*p[5]; /* omega3*I3 */
    const double t28 = x[0]*t18; /* gamma3*omega_n*1/s^2*s */
    const double t29 = p[18]*t22; /* m*I3*b*omega_n*1/s^2*s */
    const double t30 = JLT_FMA(p[33], t20, p[5]); /* m*R*e + I3 */
    const double t31 = x[3]*p[29]; /* omega_n*m*R*I1 */
    const double t32 = JLT_FNMA(x[0], p[30], p[27]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t33 = x[0]*t16; /* gamma3*1/s^2*s */
    const double t34 = p[4]*t16; /* I1*1/s^2*s */
    const double t35 = t18*t34; /* omega_n*1/s^2*s*I1*1/s^2*s */
    const double t36 = t14*t26; /* 1/Theta*V */
    const double t37 = t16*t36; /* 1/s^2*s*1/Theta*V */
    const double t38 = JLT_FNMA(p[26], t36, t17); /* omega_tau*1/s^2 - m*R*I3*1/Theta*V */
    const double t39 = p[31]*t36; /* (-m*R*I1)*1/Theta*V */
    out[28] = t39;
    const double t40 = x[2]*p[35]; /* omega_tau*m*R*a3*I1 */
    const double t41 = x[3]*t40; /* omega_n*omega_tau*m*R*a3*I1 */
    const double t42 = JLT_FMA(p[4], t28, t27); /* I1*gamma3*omega_n*1/s^2*s + omega3*I3 */
    const double t43 = JLT_FNMA(x[3], t42, t25); /* numerator of d(omega_tau)/dt over D = omega_tau*s*gamma3*omega_tau*m*a3^2 - m*g*a3*s - omega_n*(I1*gamma3*omega_n*1/s^2*s + omega3*I3) */
    const double t44 = t15*t43; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t44;
    const double t45 = t26*t29; /* V*m*I3*b*omega_n*1/s^2*s */
    const double t46 = t26*t31; /* V*omega_n*m*R*I1 */
    const double t47 = x[2]*t30; /* omega_tau*(m*R*e + I3) */
    const double t48 = JLT_FMS(t27, t47, t45); /* numerator of d(omega_n)/dt over Theta = omega3*I3*omega_tau*(m*R*e + I3) - V*m*I3*b*omega_n*1/s^2*s */
    const double t49 = t14*t48; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t50 = p[5]*t47; /* I3*omega_tau*(m*R*e + I3) */
    const double t51 = t14*t50; /* 1/Theta*I3*omega_tau*(m*R*e + I3) */
    out[24] = t51;
    const double t52 = JLT_FMA(x[2], t28, t49); /* omega_tau*gamma3*omega_n*1/s^2*s + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t52;
    const double t53 = x[4]*t32; /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t54 = JLT_FMA(t21, t53, t46); /* omega_tau*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*omega_n*m*R*I1 */
    const double t55 = t14*t54; /* 1/Theta*t54 */
    const double t56 = t21*t32; /* omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t57 = t14*t56; /* 1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t58 = -t57; /* -1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[29] = t58;
    const double t59 = -t55; /* -1/Theta*t54 */
    out[4] = t59;
    const double t60 = x[2]*t33; /* omega_tau*gamma3*1/s^2*s */
    const double t61 = JLT_FNMA(t4, t37, t60); /* omega_tau*gamma3*1/s^2*s - m*I3*b*1/s^2*s*1/Theta*V */
    out[23] = t61;
    const double t62 = t33*t37; /* gamma3*1/s^2*s*1/s^2*s*1/Theta*V */
    const double t63 = t29*t62; /* m*I3*b*omega_n*1/s^2*s*gamma3*1/s^2*s*1/s^2*s*1/Theta*V */
    const double t64 = JLT_FMS(t18, t38, t63); /* omega_n*1/s^2*s*(omega_tau*1/s^2 - m*R*I3*1/Theta*V) - m*I3*b*omega_n*1/s^2*s*gamma3*1/s^2*s*1/s^2*s*1/Theta*V */
    const double t65 = -t60; /* -omega_tau*gamma3*1/s^2*s */
    out[5] = t65;
    const double t66 = p[1]*x[4]; /* R*omega3 */
    const double t67 = JLT_FMA(2.0, t22, t66); /* 2*b*omega_n*1/s^2*s + R*omega3 */
    out[13] = t67;
    const double t68 = t66 - t22; /* R*omega3 - b*omega_n*1/s^2*s */
    const double t69 = p[32]*t33; /* m*g*a3*gamma3*1/s^2*s */
    const double t70 = JLT_FNMA(t18, t35, t69); /* m*g*a3*gamma3*1/s^2*s - omega_n*1/s^2*s*omega_n*1/s^2*s*I1*1/s^2*s */
    const double t71 = x[4]*p[30]; /* omega3*m*R^2*(I1 - I3) */
    const double t72 = JLT_FMS(t21, t71, t41); /* omega_tau*s*omega3*m*R^2*(I1 - I3) - omega_n*omega_tau*m*R*a3*I1 */
    const double t73 = JLT_FMA(t53, t60, t72); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*gamma3*1/s^2*s + t72 */
    const double t74 = JLT_FMS(x[0], t60, t21); /* gamma3*omega_tau*gamma3*1/s^2*s - omega_tau*s */
    const double t75 = JLT_FNMA(t19, t74, t70); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t70 - omega_tau*m*a3^2*(gamma3*omega_tau*gamma3*1/s^2*s - omega_tau*s) */
    const double t76 = x[2]*p[34]; /* omega_tau*m*a3*I3 */
    const double t77 = t68*t76; /* (R*omega3 - b*omega_n*1/s^2*s)*omega_tau*m*a3*I3 */
    const double t78 = x[0]*p[24]; /* gamma3*2*m*R^2*I1 */
    const double t79 = JLT_FMS(p[25], t3, t78); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t80 = JLT_FNMA(t49, t79, t77); /* (R*omega3 - b*omega_n*1/s^2*s)*omega_tau*m*a3*I3 - 1/Theta*numerator of d(omega_n)/dt over Theta*d(Theta)/d(gamma3) */
    const double t81 = JLT_FMA(t55, t79, t73); /* 1/Theta*t54*d(Theta)/d(gamma3) + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t82 = JLT_FMA(t14, t80, t64); /* 1/Theta*t80 + t64 */
    out[20] = t82;
    const double t83 = t14*t81; /* 1/Theta*t81 */
    out[25] = t83;
    const double t84 = t20*t31; /* e*omega_n*m*R*I1 */
    const double t85 = JLT_FMA(t13, t53, t84); /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*omega_n*m*R*I1 */
    const double t86 = t20*t29; /* e*m*I3*b*omega_n*1/s^2*s */
    const double t87 = JLT_FMS(t27, t30, t86); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = omega3*I3*(m*R*e + I3) - e*m*I3*b*omega_n*1/s^2*s */
    const double t88 = JLT_FMA(t14, t87, t28); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + gamma3*omega_n*1/s^2*s */
    out[22] = t88;
    const double t89 = JLT_FMA(p[22], t28, t27); /* 2*I1*gamma3*omega_n*1/s^2*s + omega3*I3 */
    const double t90 = t15*t89; /* 1/D*(2*I1*gamma3*omega_n*1/s^2*s + omega3*I3) */
    const double t91 = -t90; /* -1/D*(2*I1*gamma3*omega_n*1/s^2*s + omega3*I3) */
    out[18] = t91;
    const double t92 = t14*t29; /* 1/Theta*m*I3*b*omega_n*1/s^2*s */
    const double t93 = -t92; /* -1/Theta*m*I3*b*omega_n*1/s^2*s */
    out[21] = t93;
    const double t94 = t14*t31; /* 1/Theta*omega_n*m*R*I1 */
    const double t95 = t14*t85; /* 1/Theta*t85 */
    const double t96 = -t94; /* -1/Theta*omega_n*m*R*I1 */
    out[26] = t96;
    const double t97 = -t95; /* -1/Theta*t85 */
    out[27] = t97;
    const double t98 = x[3]*p[1]; /* omega_n*R */
    out[14] = t98;
    const double t99 = JLT_FMA(t22, t33, t98); /* b*omega_n*1/s^2*s*gamma3*1/s^2*s + omega_n*R */
    const double t100 = t18*t99; /* omega_n*1/s^2*s*(b*omega_n*1/s^2*s*gamma3*1/s^2*s + omega_n*R) */
    out[10] = t100;
    const double t101 = x[3]*t22; /* omega_n*b*omega_n*1/s^2*s */
    const double t102 = JLT_FMA(x[4], t98, t101); /* omega3*omega_n*R + omega_n*b*omega_n*1/s^2*s */
    out[1] = t102;
    const double t103 = x[0]*p[20]; /* gamma3*2*m*a3^2 */
    const double t104 = JLT_FMA(t44, t103, t75); /* 1/D*numerator of d(omega_tau)/dt over D*gamma3*2*m*a3^2 + d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    const double t105 = t21*t103; /* omega_tau*s*gamma3*2*m*a3^2 */
    const double t106 = t15*t104; /* 1/D*t104 */
    out[15] = t106;
    const double t107 = t15*t105; /* 1/D*omega_tau*s*gamma3*2*m*a3^2 */
    out[17] = t107;
    const double t108 = x[3]*p[23]; /* omega_n*(-I3) */
    const double t109 = t15*t108; /* 1/D*omega_n*(-I3) */
    out[19] = t109;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[8]*t3; /* I3/(R^2*I1)*b */
    const double t5 = p[7] + t2; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s^2 */
    const double t7 = JLT_FMA(p[19], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t4*t7; /* I3/(R^2*I1)*b*D */
    const double t9 = t2*t7; /* s^2*D */
    const double t10 = t6*t9; /* Theta/(m*R^2*I1)*s^2*D */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t12 = t6*t11; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t13 = t9*t11; /* 1/(Theta/(m*R^2*I1)) = s^2*D*1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t14 = p[20]*t2; /* 2*m*a3^2*s^2 */
    const double t15 = t12*t14; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*2*m*a3^2*s^2 */
    const double t16 = JLT_FMA(p[15], t13, t15); /* (I1 - I3)/I1*1/(Theta/(m*R^2*I1)) + Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*2*m*a3^2*s^2 */
    const double t17 = x[0]*t16; /* gamma3*t16 */
    const double t18 = JLT_FNMA(p[14], t13, t17); /* gamma3*t16 - a3*I3/(R*I1)*1/(Theta/(m*R^2*I1)) */
    const double t19 = x[2]*t18; /* omega_tau*(gamma3*t16 - a3*I3/(R*I1)*1/(Theta/(m*R^2*I1))) */
    const double t20 = sqrt(t2); /* s = sqrt(s^2) */
    const double t21 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t22 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t23 = t8*t22; /* I3/(R^2*I1)*b*D*V */
    const double t24 = t12*t23; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*I3/(R^2*I1)*b*D*V */
    const double t25 = JLT_FNMA(t13, t24, t19); /* omega_tau*(gamma3*t16 - a3*I3/(R*I1)*1/(Theta/(m*R^2*I1))) - 1/(Theta/(m*R^2*I1))*t24 */
    const double t26 = t20*t25; /* s*t25 */
    out[0] = t26;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = p[37]*x[0]; /* 2*g*a3*gamma3 */
    const double t4 = JLT_FMA(x[1], x[1], t3); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t5 = p[39]*x[3]; /* I1/m*omega_n */
    const double t6 = JLT_FMA(x[3], t5, t4); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t7 = p[38]*x[2]; /* 1/m*omega_tau */
    const double t8 = x[2]*t7; /* omega_tau*1/m*omega_tau */
    const double t9 = p[40]*x[4]; /* I3/m*omega3 */
    const double t10 = JLT_FMA(x[4], t9, t6); /* omega3*I3/m*omega3 + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = JLT_FMA(p[19], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t13 = JLT_FMA(t8, t12, t10); /* omega_tau*1/m*omega_tau*D + t10 */
    const double t14 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t15 = x[3]*t11; /* omega_n*b */
    const double t16 = x[4]*p[1]; /* omega3*R */
    const double t17 = JLT_FMA(t14, t16, t15); /* v_tau = s*omega3*R + omega_n*b */
    const double t18 = JLT_FMA(t17, t17, t13); /* energy/(1/2*m) = v_tau*v_tau + omega_tau*1/m*omega_tau*D + t10 */
    const double t19 = p[36]*t18; /* 1/2*m*energy/(1/2*m) */
    out[0] = t19;
    const double t20 = x[3]*p[41]; /* omega_n*R*I1 */
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
    const double t5 = p[23]*t4; /* (-I3)*b */
    out[9] = t5;
    const double t6 = sqrt(t3); /* s = sqrt(s^2) */
    const double t7 = p[41]*t6; /* R*I1*s */
    out[8] = t7;
    const double t8 = x[0]/t3; /* gamma3/s^2 */
    const double t9 = t6*t8; /* s*gamma3/s^2 */
    const double t10 = JLT_FMA(p[19], t3, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t11 = x[2]*t10; /* omega_tau*D */
    out[2] = t11;
    const double t12 = x[3]*t4; /* omega_n*b */
    const double t13 = p[0]*t4; /* m*b */
    const double t14 = x[4]*p[1]; /* omega3*R */
    const double t15 = JLT_FMA(t6, t14, t12); /* v_tau = s*omega3*R + omega_n*b */
    const double t16 = p[19]*x[0]; /* m*a3^2*gamma3 */
    const double t17 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t18 = JLT_FNMA(t16, t17, p[32]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t19 = x[3]*p[42]; /* omega_n*(-R*I1) */
    const double t20 = t9*t19; /* s*gamma3/s^2*omega_n*(-R*I1) */
    const double t21 = JLT_FMA(x[4], p[43], t20); /* omega3*(-R*I3) + s*gamma3/s^2*omega_n*(-R*I1) */
    out[5] = t21;
    const double t22 = JLT_FNMA(x[4], t9, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*s*gamma3/s^2 */
    const double t23 = p[33]*t15; /* m*R*v_tau */
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
    const double t3 = JLT_FMA(p[19], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t4 = p[44]/t3; /* a3*I1/D */
    const double t5 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t6 = JLT_FMA(x[3], x[3], t5); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t7 = x[0]*t6; /* gamma3*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t8 = JLT_FMA(p[10], t2, t7); /* m*g*a3/I1*(1 - gamma3)*(1 + gamma3) + gamma3*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t9 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t10 = x[3]*p[9]; /* omega_n*I3/I1 */
    const double t11 = x[4]*t10; /* omega3*omega_n*I3/I1 */
    const double t12 = JLT_FMA(t9, t11, t8); /* s*omega3*omega_n*I3/I1 + t8 */
    const double t13 = JLT_FNMA(t4, t12, p[2]); /* g - a3*I1/D*(s*omega3*omega_n*I3/I1 + t8) */
    const double t14 = p[0]*t13; /* m*(g - a3*I1/D*(s*omega3*omega_n*I3/I1 + t8)) */
    out[0] = t14;
}

static void valid_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[19], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t4 = p[44]/t3; /* a3*I1/D */
    const double t5 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t6 = JLT_FMA(x[3], x[3], t5); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t7 = x[0]*t6; /* gamma3*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t8 = JLT_FMA(p[10], t2, t7); /* m*g*a3/I1*(1 - gamma3)*(1 + gamma3) + gamma3*(omega_n*omega_n + omega_tau*omega_tau) */
    const double t9 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t10 = x[3]*p[9]; /* omega_n*I3/I1 */
    const double t11 = x[4]*t10; /* omega3*omega_n*I3/I1 */
    const double t12 = JLT_FMA(t9, t11, t8); /* s*omega3*omega_n*I3/I1 + t8 */
    const double t13 = JLT_FNMA(t4, t12, p[2]); /* g - a3*I1/D*(s*omega3*omega_n*I3/I1 + t8) */
    const double t14 = p[0]*t13; /* m*(g - a3*I1/D*(s*omega3*omega_n*I3/I1 + t8)) */
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
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    for (unsigned k = 0; k < order; k++) {
        t18[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t19[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t22[k] = jlt_jet_root(t20[k], t22, k);
        t23[k] = p[6]*t20[k] + (k == 0 ? 1.0 : 0);
        t24[k] = (k == 0 ? p[7] : 0) + t20[k];
        t25[k] = p[8]*t21[k];
        t26[k] = jlt_jet_product(t21, t25, k) + t24[k];
        t27[k] = jlt_jet_product(t22, t23, k);
        t28[k] = jlt_jet_product(x3, t23, k);
        t29[k] = jlt_jet_product(t26, t27, k);
        t30[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t29, t30, k);
        t31[k] = jlt_jet_product(t26, t30, k);
        t32[k] = jlt_jet_product(t27, t30, k);
        t33[k] = jlt_jet_product(t28, t31, k);
        t34[k] = jlt_jet_product(t21, t33, k);
        t35[k] = p[1]*x4[k] + t34[k];
        t36[k] = jlt_jet_product(x3, t35, k);
        t37[k] = jlt_jet_product(t22, t31, k);
        t38[k] = jlt_jet_product(x2, x0, k);
        t39[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t40[k] = jlt_jet_product(x2, t22, k);
        t41[k] = p[6]*t38[k];
        t42[k] = jlt_jet_product(t40, t41, k);
        t43[k] = t42[k] - p[10]*t22[k];
        t44[k] = jlt_jet_product(x2, t39, k) + x1[k];
        t45[k] = jlt_jet_product(t32, t44, k);
        t46[k] = t38[k] - jlt_jet_product(t25, t45, k);
        t47[k] = (k == 0 ? p[12] : 0) + t39[k];
        t48[k] = jlt_jet_product(x4, t32, k);
        t49[k] = jlt_jet_product(t33, t46, k);
        t50[k] = jlt_jet_product(x0, t33, k);
        t51[k] = x4[k]*p[9] + t50[k];
        t52[k] = t43[k] - jlt_jet_product(x3, t51, k);
        t53[k] = jlt_jet_product(t37, t52, k);
        t54[k] = x3[k]*p[13];
        t55[k] = jlt_jet_product(t45, t54, k);
        t56[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t57[k] = jlt_jet_product(t40, t56, k);
        t58[k] = jlt_jet_product(t48, t57, k) + t55[k];
        t59[k] = -t58[k];
        t60[k] = x2[k]*p[11];
        t61[k] = jlt_jet_product(t47, t60, k);
        t62[k] = jlt_jet_product(t48, t61, k) + t49[k];
        double *restrict next = coefficients + (k + 1)*5;
        next[0] = x0[k + 1] = t40[k]/(k + 1);
        next[1] = x1[k + 1] = t36[k]/(k + 1);
        next[2] = x2[k + 1] = t53[k]/(k + 1);
        next[3] = x3[k + 1] = t62[k]/(k + 1);
        next[4] = x4[k + 1] = t59[k]/(k + 1);
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

static const signed char signs_8[] = { 1, -1, -1, 1, 1 };
static const jlt_reversor reversors[] = {
    { signs_8, 8 },
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
    .sha256 = "ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 6, .block_count = 45,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 5, 26, 13, 1, 1, 0, 12, 10 }, { 17, 69, 0, 12, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, a part of d(v_nu)/dt, e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega_tau*gamma3 - (I3/(R^2*I1))*b*1/(Theta/(m*R^2*I1))*V, I3/(m*R) + e, a part of d(omega_tau)/dt, a part of d(omega_tau)/dt, a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(omega3)/dt, d(omega_n)/dt" },
    .jacobian = { jacobian, 25, { 9, 56, 30, 1, 1, 0, 16, 21 }, { 52, 271, 0, 49, 1, 0, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega_n), gamma3*1/D*s*(2*m*a3^2) - gamma3*D*((1)/D*s^2*Theta)*s*Theta, a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), omega3*1/D*I3 + D*((1)/D*s^2*Theta)*s*Theta*omega_n*gamma3*1/D*(2*I1), d(Theta)/d(gamma3) = b*(2*m*R*I3) - gamma3*(2*m*R^2*I1), e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega_tau*a3 - d(Theta)/d(gamma3)*1/Theta*V, a part of d(d(omega_n)/dt)/d(gamma3), e*(m*R*I3) + I3^2, m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(e*(m*R*I3) + I3^2), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), d(d(omega_n)/dt)/d(omega_n), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 64, 34, 1, 1, 0, 17, 26 }, { 62, 323, 0, 61, 1, 0, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, V = omega_tau*e + v_nu, (m*R)*e + I3, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), omega_tau*1/s^2 - (m*R*I3)*1/Theta*V, I1*gamma3*omega_n*1/s^2*s + omega3*I3, numerator of d(omega_tau)/dt over D, numerator of d(omega_n)/dt over Theta = omega3*I3*omega_tau*((m*R)*e + I3) - V*(m*I3)*b*omega_n*1/s^2*s, d(omega_n)/dt, a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), d(d(v_nu)/dt)/d(omega_n), R*omega3 - b*omega_n*1/s^2*s, d(numerator of d(omega3)/dt over Theta)/d(gamma3), gamma3*omega_tau*gamma3*1/s^2*s - omega_tau*s, d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), s*omega3*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))) + e*omega_n*(m*R*I1), d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = omega3*I3*((m*R)*e + I3) - e*(m*I3)*b*omega_n*1/s^2*s, d(d(omega_n)/dt)/d(omega_tau), (2*I1)*gamma3*omega_n*1/s^2*s + omega3*I3, b*omega_n*1/s^2*s*gamma3*1/s^2*s + omega_n*R, d(v_nu)/dt, a part of d(d(omega_tau)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 3, 14, 8, 1, 1, 0, 14, 7 }, { 11, 38, 0, 4, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, a part of the divergence, a part of the divergence, e = gamma3*a3 + R, V = omega_tau*e + v_nu, a part of the divergence" },
    .integral_values = { integral_values, 2, { 2, 12, 9, 0, 1, 0, 7, 6 }, { 10, 32, 0, 0, 1, 0, 12, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*omega3*R + omega_n*b, energy/(1/2*m), G" },
    .integral_gradients = { integral_gradients, 10, { 2, 16, 9, 1, 1, 0, 6, 7 }, { 12, 38, 0, 2, 1, 0, 8, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*omega3*R + omega_n*b, d(G)/d(gamma3), d(v_tau)/d(gamma3)/R = omega_n - omega3*s*(gamma3/s^2), d(E)/d(gamma3), d(E)/d(omega_n), d(E)/d(omega3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { observe_values, 1, { 2, 6, 5, 1, 1, 0, 7, 5 }, { 7, 26, 0, 4, 1, 0, 14, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of contact_force, a part of contact_force" },
    .valid_values = { valid_values, 1, { 2, 6, 5, 1, 1, 0, 7, 5 }, { 7, 26, 0, 4, 1, 0, 14, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of contact, a part of contact" },
    .observe_count = 1, .observes = observes,
    .valid_count = 1, .valids = valids,
    .reversor_count = 1, .reversors = reversors,
    .pole_count = 1, .poles = poles,
    .integral_count = 2, .measure_count = 0, .equilibria_count = 3,
    .integrals = integrals,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_general_baseline,
        &jlt_batch_spherical_top_general_avx2,
        &jlt_batch_spherical_top_general_avx512,
    },
#endif
};
