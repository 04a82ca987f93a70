/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Table:      spherical_top, SHA-256 1b6d453374f697d58e1412b96ff746b2599a2a450f7166c0e5909287ba92fdcb
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   26   13    1    1    0     12   10   (99)
 *  jacobian            8   56   31    1    1    0     17   19   (373)
 *  rhs_jacobian        9   64   34    1    1    0     15   23   (447)
 *  divergence          3   14    8    1    1    0     12    7   (54)
 *  integral_values     2   12    9    0    1    0      7    6   (43)
 *  integral_gradients  2   16    9    1    1    0      6    7   (53)
 *  observe_values      2    5    5    1    1    0      6    5   (39)
 *  valid_values        2    5    5    1    1    0      6    5   (39)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R,
 *      d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), (m*R*I3)*e + I3^2,
 *      a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(omega_tau), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      (I3/I1)*omega3*1/D + omega_n*Theta*((1)/Theta*s^2*D)*D*s*gamma3*1/D,
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega_n),
 *      a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)),
 *      V = omega_tau*e + v_nu, d(omega_n)/dt, a part of d(d(omega3)/dt)/d(omega_tau),
 *      a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3),
 *      a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(v_nu)/dt,
 *      d(d(v_nu)/dt)/d(omega_n)
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
    out[16] = t1;
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
    out[46] = t8;
    const double t9 = params[3]*t8; /* a3*m*g */
    out[23] = t9;
    const double t10 = t9/params[4]; /* a3*m*g/I1 */
    out[9] = t10;
    const double t11 = params[5]/params[4]; /* I3/I1 */
    out[10] = t11;
    const double t12 = params[4]*params[1]; /* I1*R */
    out[42] = t12;
    const double t13 = params[5]/t12; /* I3/(I1*R) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[43] = t14;
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
    out[17] = t21;
    const double t22 = params[4]*t4; /* I1*m*R*R */
    out[18] = t22;
    const double t23 = params[0]*params[5]; /* m*I3 */
    out[19] = t23;
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t0*t24; /* a3*a3*m*2 */
    out[20] = t25;
    const double t26 = params[5]*2.0; /* I3*2 */
    out[21] = t26;
    const double t27 = params[4]*2.0; /* I1*2 */
    out[22] = t27;
    const double t28 = -params[5]; /* -I3 */
    out[24] = t28;
    const double t29 = t3*t24; /* R*R*m*2 */
    const double t30 = params[4]*t29; /* I1*R*R*m*2 */
    out[25] = t30;
    const double t31 = params[1]*t24; /* R*m*2 */
    const double t32 = params[5]*t31; /* I3*R*m*2 */
    out[26] = t32;
    const double t33 = params[5]*t14; /* I3*m*R */
    out[27] = t33;
    const double t34 = params[3]*t14; /* a3*m*R */
    const double t35 = params[5]*t34; /* I3*a3*m*R */
    out[28] = t35;
    const double t36 = params[5]*params[5]; /* I3*I3 */
    out[29] = t36;
    const double t37 = params[4]*t14; /* I1*m*R */
    out[30] = t37;
    const double t38 = t4*t19; /* m*R*R*(I1 - I3) */
    out[31] = t38;
    const double t39 = -t37; /* -I1*m*R */
    out[32] = t39;
    const double t40 = -params[4]; /* -I1 */
    out[33] = t40;
    const double t41 = params[4]*(-2.0); /* I1*(-2) */
    out[34] = t41;
    const double t42 = params[0]*params[3]; /* m*a3 */
    const double t43 = params[5]*t42; /* I3*m*a3 */
    out[35] = t43;
    const double t44 = params[4]*t34; /* I1*a3*m*R */
    out[36] = t44;
    const double t45 = params[0]/2.0; /* m/2 */
    out[37] = t45;
    const double t46 = params[2]*2.0; /* g*2 */
    const double t47 = params[3]*t46; /* a3*g*2 */
    out[38] = t47;
    const double t48 = 1.0/params[0]; /* 1/m */
    out[39] = t48;
    const double t49 = params[4]/params[0]; /* I1/m */
    out[40] = t49;
    const double t50 = params[5]/params[0]; /* I3/m */
    out[41] = t50;
    const double t51 = -t12; /* -I1*R */
    out[44] = t51;
    const double t52 = params[1]*params[5]; /* R*I3 */
    const double t53 = -t52; /* -R*I3 */
    out[45] = t53;
    const double t54 = params[4]*t42; /* I1*m*a3 */
    out[47] = t54;
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
    const double t26 = JLT_FNMA(p[9], t14, t25); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s */
    const double t27 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = t13*t27; /* 1/(Theta/(m*R^2*I1))*V */
    const double t29 = JLT_FMS(t5, t28, t21); /* I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V - omega_tau*gamma3 */
    const double t30 = p[12] + t22; /* I3/(m*R) + e */
    const double t31 = x[4]*t13; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t32 = t16*t29; /* t16*(I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V - omega_tau*gamma3) */
    const double t33 = x[0]*t16; /* gamma3*t16 */
    const double t34 = JLT_FMA(x[4], p[10], t33); /* omega3*I3/I1 + gamma3*t16 */
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
    const double t45 = JLT_FMS(t31, t44, t32); /* omega3*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e)*omega_tau*I3/(R*I1) - t32 */
    out[3] = t45;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = JLT_FMA(t2, p[16], p[4]); /* D = s^2*m*a3^2 + I1 */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = t5*p[19]; /* b*m*I3 */
    const double t7 = JLT_FMA(t2, p[18], p[17]); /* s^2*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta = b*b*m*I3 + s^2*m*R^2*I1 + I1*I3 */
    const double t9 = t2*t4; /* s^2*D */
    const double t10 = t8*t9; /* Theta*s^2*D */
    const double t11 = 1.0/t10; /* 1/(Theta*s^2*D) */
    const double t12 = t8*t11; /* Theta*1/(Theta*s^2*D) */
    const double t13 = t4*t12; /* 1/s^2 = D*Theta*1/(Theta*s^2*D) */
    const double t14 = t3*t13; /* s*1/s^2 */
    const double t15 = x[0]*t14; /* gamma3*s*1/s^2 */
    const double t16 = x[2]*t15; /* omega_tau*gamma3*s*1/s^2 */
    const double t17 = -t16; /* -omega_tau*gamma3*s*1/s^2 */
    out[0] = t17;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    const double t18 = t14*x[3]; /* s*1/s^2*omega_n */
    const double t19 = t5*t18; /* b*s*1/s^2*omega_n */
    const double t20 = p[1]*x[3]; /* R*omega_n */
    out[9] = t20;
    const double t21 = JLT_FMA(t15, t19, t20); /* gamma3*s*1/s^2*b*s*1/s^2*omega_n + R*omega_n */
    const double t22 = t18*t21; /* s*1/s^2*omega_n*(gamma3*s*1/s^2*b*s*1/s^2*omega_n + R*omega_n) */
    out[5] = t22;
    const double t23 = p[1]*x[4]; /* R*omega3 */
    const double t24 = JLT_FMA(t19, 2.0, t23); /* b*s*1/s^2*omega_n*2 + R*omega3 */
    out[8] = t24;
    const double t25 = t2*t12; /* 1/D = s^2*Theta*1/(Theta*s^2*D) */
    const double t26 = t3*t25; /* s*1/D */
    const double t27 = JLT_FMS(p[20], t26, t14); /* 2*m*a3^2*s*1/D - s*1/s^2 */
    const double t28 = x[0]*t25; /* gamma3*1/D */
    const double t29 = t27*t28; /* (2*m*a3^2*s*1/D - s*1/s^2)*gamma3*1/D */
    const double t30 = JLT_FMA(x[0], t29, t26); /* gamma3*(2*m*a3^2*s*1/D - s*1/s^2)*gamma3*1/D + s*1/D */
    const double t31 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t32 = t30*t31; /* (gamma3*(2*m*a3^2*s*1/D - s*1/s^2)*gamma3*1/D + s*1/D)*omega_tau*omega_tau */
    const double t33 = x[4]*t25; /* omega3*1/D */
    const double t34 = t28*p[22]; /* gamma3*1/D*2*I1 */
    const double t35 = t18*t34; /* s*1/s^2*omega_n*gamma3*1/D*2*I1 */
    const double t36 = JLT_FMA(p[21], t33, t35); /* 2*I3*omega3*1/D + s*1/s^2*omega_n*gamma3*1/D*2*I1 */
    const double t37 = x[3]*t28; /* omega_n*gamma3*1/D */
    const double t38 = JLT_FNMA(t36, t37, t32); /* t32 - (2*I3*omega3*1/D + s*1/s^2*omega_n*gamma3*1/D*2*I1)*omega_n*gamma3*1/D */
    const double t39 = p[16]*t38; /* m*a3^2*t38 */
    const double t40 = p[4]*t25; /* I1*1/D */
    const double t41 = t14*t40; /* s*1/s^2*I1*1/D */
    const double t42 = t18*t41; /* s*1/s^2*omega_n*s*1/s^2*I1*1/D */
    const double t43 = JLT_FNMA(t18, t42, t39); /* m*a3^2*t38 - s*1/s^2*omega_n*s*1/s^2*omega_n*s*1/s^2*I1*1/D */
    const double t44 = JLT_FNMA(t29, p[23], t43); /* m*a3^2*t38 - s*1/s^2*omega_n*s*1/s^2*omega_n*s*1/s^2*I1*1/D - (2*m*a3^2*s*1/D - s*1/s^2)*gamma3*1/D*m*g*a3 */
    out[10] = t44;
    const double t45 = x[2]*p[20]; /* omega_tau*2*m*a3^2 */
    const double t46 = t3*t45; /* s*omega_tau*2*m*a3^2 */
    const double t47 = t28*t46; /* gamma3*1/D*s*omega_tau*2*m*a3^2 */
    out[12] = t47;
    const double t48 = JLT_FMA(t33, p[5], t35); /* omega3*1/D*I3 + s*1/s^2*omega_n*gamma3*1/D*2*I1 */
    const double t49 = -t48; /* -(omega3*1/D*I3 + s*1/s^2*omega_n*gamma3*1/D*2*I1) */
    out[13] = t49;
    const double t50 = x[3]*p[24]; /* omega_n*(-I3) */
    const double t51 = t25*t50; /* 1/D*omega_n*(-I3) */
    out[14] = t51;
    const double t52 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t53 = JLT_FMA(x[2], t52, x[1]); /* V = omega_tau*e + v_nu */
    const double t54 = t9*t11; /* 1/Theta = s^2*D*1/(Theta*s^2*D) */
    const double t55 = t53*t54; /* V*1/Theta */
    const double t56 = t14*t55; /* s*1/s^2*V*1/Theta */
    const double t57 = x[0]*p[25]; /* gamma3*2*m*R^2*I1 */
    const double t58 = JLT_FMS(t5, p[26], t57); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t59 = t54*t58; /* 1/Theta*d(Theta)/d(gamma3) */
    const double t60 = t55*t59; /* V*1/Theta*1/Theta*d(Theta)/d(gamma3) */
    const double t61 = x[2]*t54; /* omega_tau*1/Theta */
    const double t62 = JLT_FNMA(p[3], t61, t60); /* V*1/Theta*1/Theta*d(Theta)/d(gamma3) - a3*omega_tau*1/Theta */
    const double t63 = JLT_FMS(t15, t56, t62); /* gamma3*s*1/s^2*s*1/s^2*V*1/Theta - (V*1/Theta*1/Theta*d(Theta)/d(gamma3) - a3*omega_tau*1/Theta) */
    const double t64 = x[2]*t13; /* omega_tau*1/s^2 */
    const double t65 = JLT_FMS(t55, p[27], t64); /* V*1/Theta*m*R*I3 - omega_tau*1/s^2 */
    const double t66 = JLT_FMA(t6, t63, t65); /* b*m*I3*t63 + V*1/Theta*m*R*I3 - omega_tau*1/s^2 */
    const double t67 = t18*t66; /* s*1/s^2*omega_n*(b*m*I3*t63 + V*1/Theta*m*R*I3 - omega_tau*1/s^2) */
    const double t68 = x[4]*t61; /* omega3*omega_tau*1/Theta */
    const double t69 = JLT_FMA(t52, p[27], p[29]); /* e*m*R*I3 + I3^2 */
    const double t70 = JLT_FNMA(t59, t69, p[28]); /* m*R*a3*I3 - 1/Theta*d(Theta)/d(gamma3)*(e*m*R*I3 + I3^2) */
    const double t71 = JLT_FMS(t68, t70, t67); /* omega3*omega_tau*1/Theta*(m*R*a3*I3 - 1/Theta*d(Theta)/d(gamma3)*(e*m*R*I3 + I3^2)) - t67 */
    out[15] = t71;
    const double t72 = t6*t54; /* b*m*I3*1/Theta */
    const double t73 = t18*t72; /* s*1/s^2*omega_n*b*m*I3*1/Theta */
    const double t74 = -t73; /* -s*1/s^2*omega_n*b*m*I3*1/Theta */
    out[16] = t74;
    const double t75 = x[0]*t18; /* gamma3*s*1/s^2*omega_n */
    const double t76 = x[4]*t54; /* omega3*1/Theta */
    const double t77 = JLT_FMA(t69, t76, t75); /* (e*m*R*I3 + I3^2)*omega3*1/Theta + gamma3*s*1/s^2*omega_n */
    const double t78 = JLT_FNMA(t52, t73, t77); /* (e*m*R*I3 + I3^2)*omega3*1/Theta + gamma3*s*1/s^2*omega_n - e*s*1/s^2*omega_n*b*m*I3*1/Theta */
    out[17] = t78;
    const double t79 = JLT_FNMA(t6, t56, t16); /* omega_tau*gamma3*s*1/s^2 - b*m*I3*s*1/s^2*V*1/Theta */
    out[18] = t79;
    const double t80 = t61*t69; /* omega_tau*1/Theta*(e*m*R*I3 + I3^2) */
    out[19] = t80;
    const double t81 = x[3]*p[30]; /* omega_n*m*R*I1 */
    const double t82 = t62*t81; /* (V*1/Theta*1/Theta*d(Theta)/d(gamma3) - a3*omega_tau*1/Theta)*omega_n*m*R*I1 */
    const double t83 = t3*p[31]; /* s*m*R^2*(I1 - I3) */
    const double t84 = JLT_FNMA(x[0], p[31], p[28]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t85 = JLT_FMA(t3, t59, t15); /* s*1/Theta*d(Theta)/d(gamma3) + gamma3*s*1/s^2 */
    const double t86 = JLT_FMA(t84, t85, t83); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*(s*1/Theta*d(Theta)/d(gamma3) + gamma3*s*1/s^2) + s*m*R^2*(I1 - I3) */
    const double t87 = JLT_FMA(t68, t86, t82); /* omega3*omega_tau*1/Theta*t86 + t82 */
    out[20] = t87;
    const double t88 = t54*t81; /* 1/Theta*omega_n*m*R*I1 */
    const double t89 = -t88; /* -1/Theta*omega_n*m*R*I1 */
    out[21] = t89;
    const double t90 = t3*t84; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t91 = t76*t90; /* omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t92 = JLT_FMA(t52, t88, t91); /* e*1/Theta*omega_n*m*R*I1 + omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t93 = -t92; /* -t92 */
    out[22] = t93;
    const double t94 = t55*p[32]; /* V*1/Theta*(-m*R*I1) */
    out[23] = t94;
    const double t95 = t61*t90; /* omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
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
    const double t4 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t5 = p[19]*t3; /* m*I3*b */
    const double t6 = JLT_FMA(p[18], t2, p[17]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(t3, t5, t6); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t8 = t2*t4; /* s^2*D */
    const double t9 = t7*t8; /* Theta*s^2*D */
    const double t10 = 1.0/t9; /* 1/(Theta*s^2*D) */
    const double t11 = t7*t10; /* Theta*1/(Theta*s^2*D) */
    const double t12 = t8*t10; /* 1/Theta = s^2*D*1/(Theta*s^2*D) */
    const double t13 = sqrt(t2); /* s = sqrt(s^2) */
    out[7] = t13;
    const double t14 = t4*t13; /* D*s */
    const double t15 = t11*t14; /* Theta*1/(Theta*s^2*D)*D*s */
    const double t16 = t2*t11; /* 1/D = s^2*Theta*1/(Theta*s^2*D) */
    const double t17 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t18 = x[0]*p[25]; /* gamma3*2*m*R^2*I1 */
    const double t19 = JLT_FMS(p[26], t3, t18); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t20 = t12*t19; /* 1/Theta*d(Theta)/d(gamma3) */
    const double t21 = x[2]*t13; /* omega_tau*s */
    out[0] = t21;
    const double t22 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t23 = t21*t22; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t24 = JLT_FMA(p[27], t17, p[29]); /* m*R*I3*e + I3^2 */
    const double t25 = x[4]*t12; /* omega3*1/Theta */
    const double t26 = x[3]*t15; /* omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t27 = x[0]*t16; /* gamma3*1/D */
    const double t28 = t24*t25; /* (m*R*I3*e + I3^2)*omega3*1/Theta */
    const double t29 = p[28]*t25; /* m*R*a3*I3*omega3*1/Theta */
    const double t30 = JLT_FMS(t20, t28, t29); /* 1/Theta*d(Theta)/d(gamma3)*(m*R*I3*e + I3^2)*omega3*1/Theta - m*R*a3*I3*omega3*1/Theta */
    const double t31 = JLT_FMA(x[0], t26, t28); /* gamma3*omega_n*Theta*1/(Theta*s^2*D)*D*s + (m*R*I3*e + I3^2)*omega3*1/Theta */
    const double t32 = t3*t26; /* b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t33 = t3*t15; /* b*Theta*1/(Theta*s^2*D)*D*s */
    const double t34 = t26*t27; /* omega_n*Theta*1/(Theta*s^2*D)*D*s*gamma3*1/D */
    const double t35 = x[4]*t16; /* omega3*1/D */
    const double t36 = t23*t27; /* omega_tau*s*omega_tau*m*a3^2/I1*gamma3*1/D */
    const double t37 = p[9]*t13; /* m*g*a3/I1*s */
    const double t38 = JLT_FMS(t16, t37, t36); /* 1/D*m*g*a3/I1*s - omega_tau*s*omega_tau*m*a3^2/I1*gamma3*1/D */
    const double t39 = t15*t26; /* Theta*1/(Theta*s^2*D)*D*s*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t40 = JLT_FNMA(t15, t39, t30); /* t30 - Theta*1/(Theta*s^2*D)*D*s*Theta*1/(Theta*s^2*D)*D*s*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t41 = JLT_FMS(t26, t39, t23); /* omega_n*Theta*1/(Theta*s^2*D)*D*s*Theta*1/(Theta*s^2*D)*D*s*omega_n*Theta*1/(Theta*s^2*D)*D*s - omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t42 = JLT_FMA(p[10], t35, t34); /* I3/I1*omega3*1/D + omega_n*Theta*1/(Theta*s^2*D)*D*s*gamma3*1/D */
    const double t43 = JLT_FMA(x[3], t42, t38); /* omega_n*t42 + 1/D*m*g*a3/I1*s - omega_tau*s*omega_tau*m*a3^2/I1*gamma3*1/D */
    const double t44 = p[24]*t35; /* (-I3)*omega3*1/D */
    const double t45 = JLT_FMA(p[34], t34, t44); /* (-2*I1)*omega_n*Theta*1/(Theta*s^2*D)*D*s*gamma3*1/D + (-I3)*omega3*1/D */
    out[18] = t45;
    const double t46 = p[33]*t43; /* (-I1)*t43 */
    out[2] = t46;
    const double t47 = p[22]*t43; /* 2*I1*t43 */
    const double t48 = t12*t32; /* 1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t49 = JLT_FMA(p[35], t48, t40); /* m*a3*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s + t40 */
    const double t50 = p[19]*t48; /* m*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t51 = x[2]*t49; /* omega_tau*(m*a3*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s + t40) */
    const double t52 = -t50; /* -m*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    out[21] = t52;
    const double t53 = JLT_FNMA(t17, t50, t31); /* t31 - e*m*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    out[22] = t53;
    const double t54 = x[3]*p[30]; /* omega_n*m*R*I1 */
    const double t55 = t12*t54; /* 1/Theta*omega_n*m*R*I1 */
    const double t56 = -t55; /* -1/Theta*omega_n*m*R*I1 */
    out[26] = t56;
    const double t57 = JLT_FNMA(x[0], p[31], p[28]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t58 = x[0]*t15; /* gamma3*Theta*1/(Theta*s^2*D)*D*s */
    const double t59 = x[2]*t12; /* omega_tau*1/Theta */
    const double t60 = t24*t59; /* (m*R*I3*e + I3^2)*omega_tau*1/Theta */
    out[24] = t60;
    const double t61 = x[3]*p[36]; /* omega_n*m*R*a3*I1 */
    const double t62 = t59*t61; /* omega_tau*1/Theta*omega_n*m*R*a3*I1 */
    const double t63 = JLT_FMA(x[2], t17, x[1]); /* V = omega_tau*e + v_nu */
    const double t64 = t50*t63; /* m*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s*V */
    const double t65 = JLT_FMS(x[2], t31, t64); /* omega_tau*t31 - m*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s*V */
    out[3] = t65;
    const double t66 = JLT_FMS(t20, t64, t51); /* 1/Theta*d(Theta)/d(gamma3)*m*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s*V - t51 */
    const double t67 = t25*t57; /* omega3*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t68 = t13*t67; /* s*omega3*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t69 = JLT_FMA(t17, t55, t68); /* e*1/Theta*omega_n*m*R*I1 + s*omega3*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t70 = -t69; /* -t69 */
    out[27] = t70;
    const double t71 = t55*t63; /* 1/Theta*omega_n*m*R*I1*V */
    const double t72 = t12*t63; /* 1/Theta*V */
    const double t73 = t21*t57; /* omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t74 = t12*t73; /* 1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t75 = -t74; /* -1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[29] = t75;
    const double t76 = JLT_FMA(t21, t67, t71); /* omega_tau*s*omega3*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + 1/Theta*omega_n*m*R*I1*V */
    const double t77 = -t76; /* -t76 */
    out[4] = t77;
    const double t78 = p[32]*t72; /* (-m*R*I1)*1/Theta*V */
    out[28] = t78;
    const double t79 = p[19]*t72; /* m*I3*1/Theta*V */
    const double t80 = t32*t58; /* b*omega_n*Theta*1/(Theta*s^2*D)*D*s*gamma3*Theta*1/(Theta*s^2*D)*D*s */
    const double t81 = x[2]*t58; /* omega_tau*gamma3*Theta*1/(Theta*s^2*D)*D*s */
    const double t82 = JLT_FNMA(t33, t79, t81); /* omega_tau*gamma3*Theta*1/(Theta*s^2*D)*D*s - b*Theta*1/(Theta*s^2*D)*D*s*m*I3*1/Theta*V */
    out[23] = t82;
    const double t83 = JLT_FMA(x[2], t81, t47); /* omega_tau*omega_tau*gamma3*Theta*1/(Theta*s^2*D)*D*s + 2*I1*t43 */
    const double t84 = -t81; /* -omega_tau*gamma3*Theta*1/(Theta*s^2*D)*D*s */
    out[5] = t84;
    const double t85 = p[4]*t16; /* I1*1/D */
    const double t86 = t41*t85; /* t41*I1*1/D */
    const double t87 = p[31]*t21; /* m*R^2*(I1 - I3)*omega_tau*s */
    const double t88 = JLT_FMS(t25, t87, t62); /* omega3*1/Theta*m*R^2*(I1 - I3)*omega_tau*s - omega_tau*1/Theta*omega_n*m*R*a3*I1 */
    const double t89 = JLT_FMA(t67, t81, t88); /* omega3*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*gamma3*Theta*1/(Theta*s^2*D)*D*s + t88 */
    const double t90 = JLT_FMA(t20, t76, t89); /* 1/Theta*d(Theta)/d(gamma3)*t76 + t89 */
    out[25] = t90;
    const double t91 = p[20]*t21; /* 2*m*a3^2*omega_tau*s */
    const double t92 = t27*t91; /* gamma3*1/D*2*m*a3^2*omega_tau*s */
    out[17] = t92;
    const double t93 = x[3]*p[1]; /* omega_n*R */
    out[14] = t93;
    const double t94 = p[23]*t15; /* m*g*a3*Theta*1/(Theta*s^2*D)*D*s */
    const double t95 = JLT_FMS(t27, t94, t86); /* gamma3*1/D*m*g*a3*Theta*1/(Theta*s^2*D)*D*s - t41*I1*1/D */
    const double t96 = t15*t80; /* Theta*1/(Theta*s^2*D)*D*s*t80 */
    const double t97 = t80 + t93; /* t80 + omega_n*R */
    const double t98 = t26*t97; /* omega_n*Theta*1/(Theta*s^2*D)*D*s*(t80 + omega_n*R) */
    out[10] = t98;
    const double t99 = JLT_FMA(p[1], t26, t96); /* R*omega_n*Theta*1/(Theta*s^2*D)*D*s + Theta*1/(Theta*s^2*D)*D*s*t80 */
    const double t100 = JLT_FNMA(t79, t99, t66); /* t66 - m*I3*1/Theta*V*t99 */
    out[20] = t100;
    const double t101 = p[16]*t27; /* m*a3^2*gamma3*1/D */
    const double t102 = JLT_FNMA(t83, t101, t95); /* gamma3*1/D*m*g*a3*Theta*1/(Theta*s^2*D)*D*s - t41*I1*1/D - t83*m*a3^2*gamma3*1/D */
    out[15] = t102;
    const double t103 = x[3]*t32; /* omega_n*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t104 = JLT_FMA(x[4], t93, t103); /* omega3*omega_n*R + omega_n*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    out[1] = t104;
    const double t105 = p[1]*x[4]; /* R*omega3 */
    const double t106 = JLT_FMA(2.0, t32, t105); /* 2*b*omega_n*Theta*1/(Theta*s^2*D)*D*s + R*omega3 */
    out[13] = t106;
    const double t107 = x[3]*p[24]; /* omega_n*(-I3) */
    const double t108 = t16*t107; /* 1/D*omega_n*(-I3) */
    out[19] = t108;
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
    const double t7 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t4*t7; /* I3/(R^2*I1)*b*D */
    const double t9 = t2*t7; /* s^2*D */
    const double t10 = t6*t9; /* Theta/(m*R^2*I1)*s^2*D */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t12 = t6*t11; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t13 = t9*t11; /* 1/(Theta/(m*R^2*I1)) = s^2*D*1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t14 = x[0]*p[20]; /* gamma3*2*m*a3^2 */
    const double t15 = t2*t14; /* s^2*gamma3*2*m*a3^2 */
    const double t16 = t12*t15; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*s^2*gamma3*2*m*a3^2 */
    const double t17 = sqrt(t2); /* s = sqrt(s^2) */
    const double t18 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t19 = JLT_FMA(x[2], t18, x[1]); /* V = omega_tau*e + v_nu */
    const double t20 = t8*t19; /* I3/(R^2*I1)*b*D*V */
    const double t21 = t12*t20; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D)*I3/(R^2*I1)*b*D*V */
    const double t22 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t23 = JLT_FNMA(t13, t22, t16); /* t16 - 1/(Theta/(m*R^2*I1))*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t24 = x[2]*t23; /* omega_tau*t23 */
    const double t25 = JLT_FNMA(t13, t21, t24); /* omega_tau*t23 - 1/(Theta/(m*R^2*I1))*t21 */
    const double t26 = t17*t25; /* s*(omega_tau*t23 - 1/(Theta/(m*R^2*I1))*t21) */
    out[0] = t26;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = p[38]*x[0]; /* 2*g*a3*gamma3 */
    const double t4 = JLT_FMA(x[1], x[1], t3); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t5 = p[40]*x[3]; /* I1/m*omega_n */
    const double t6 = JLT_FMA(x[3], t5, t4); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t7 = p[39]*x[2]; /* 1/m*omega_tau */
    const double t8 = x[2]*t7; /* omega_tau*1/m*omega_tau */
    const double t9 = p[41]*x[4]; /* I3/m*omega3 */
    const double t10 = JLT_FMA(x[4], t9, t6); /* omega3*I3/m*omega3 + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t13 = JLT_FMA(t8, t12, t10); /* omega_tau*1/m*omega_tau*D + t10 */
    const double t14 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t15 = x[3]*t11; /* omega_n*b */
    const double t16 = x[4]*p[1]; /* omega3*R */
    const double t17 = JLT_FMA(t14, t16, t15); /* v_tau = s*omega3*R + omega_n*b */
    const double t18 = JLT_FMA(t17, t17, t13); /* energy/(1/2*m) = v_tau*v_tau + omega_tau*1/m*omega_tau*D + t10 */
    const double t19 = p[37]*t18; /* 1/2*m*energy/(1/2*m) */
    out[0] = t19;
    const double t20 = x[3]*p[42]; /* omega_n*R*I1 */
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
    const double t5 = p[24]*t4; /* (-I3)*b */
    out[9] = t5;
    const double t6 = sqrt(t3); /* s = sqrt(s^2) */
    const double t7 = p[42]*t6; /* R*I1*s */
    out[8] = t7;
    const double t8 = x[0]/t3; /* gamma3/s^2 */
    const double t9 = t6*t8; /* s*gamma3/s^2 */
    const double t10 = JLT_FMA(p[16], t3, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t11 = x[2]*t10; /* omega_tau*D */
    out[2] = t11;
    const double t12 = x[3]*t4; /* omega_n*b */
    const double t13 = p[0]*t4; /* m*b */
    const double t14 = x[4]*p[1]; /* omega3*R */
    const double t15 = JLT_FMA(t6, t14, t12); /* v_tau = s*omega3*R + omega_n*b */
    const double t16 = p[16]*x[0]; /* m*a3^2*gamma3 */
    const double t17 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t18 = JLT_FNMA(t16, t17, p[23]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t19 = x[3]*p[44]; /* omega_n*(-R*I1) */
    const double t20 = t9*t19; /* s*gamma3/s^2*omega_n*(-R*I1) */
    const double t21 = JLT_FMA(x[4], p[45], t20); /* omega3*(-R*I3) + s*gamma3/s^2*omega_n*(-R*I1) */
    out[5] = t21;
    const double t22 = JLT_FNMA(x[4], t9, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*s*gamma3/s^2 */
    const double t23 = p[43]*t15; /* m*R*v_tau */
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
    const double t3 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t4 = p[47]/t3; /* m*a3*I1/D */
    const double t5 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t6 = JLT_FMA(x[3], x[3], t5); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t7 = p[9]*t2; /* m*g*a3/I1*(1 - gamma3)*(1 + gamma3) */
    const double t8 = JLT_FMA(x[0], t6, t7); /* gamma3*(omega_n*omega_n + omega_tau*omega_tau) + m*g*a3/I1*(1 - gamma3)*(1 + gamma3) */
    const double t9 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t10 = x[3]*p[10]; /* omega_n*I3/I1 */
    const double t11 = x[4]*t10; /* omega3*omega_n*I3/I1 */
    const double t12 = JLT_FMA(t9, t11, t8); /* s*omega3*omega_n*I3/I1 + t8 */
    const double t13 = JLT_FNMA(t4, t12, p[46]); /* contact_force = m*g - m*a3*I1/D*(s*omega3*omega_n*I3/I1 + t8) */
    out[0] = t13;
}

static void valid_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(1 + gamma3) + I1 */
    const double t4 = p[47]/t3; /* m*a3*I1/D */
    const double t5 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t6 = JLT_FMA(x[3], x[3], t5); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t7 = p[9]*t2; /* m*g*a3/I1*(1 - gamma3)*(1 + gamma3) */
    const double t8 = JLT_FMA(x[0], t6, t7); /* gamma3*(omega_n*omega_n + omega_tau*omega_tau) + m*g*a3/I1*(1 - gamma3)*(1 + gamma3) */
    const double t9 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t10 = x[3]*p[10]; /* omega_n*I3/I1 */
    const double t11 = x[4]*t10; /* omega3*omega_n*I3/I1 */
    const double t12 = JLT_FMA(t9, t11, t8); /* s*omega3*omega_n*I3/I1 + t8 */
    const double t13 = JLT_FNMA(t4, t12, p[46]); /* contact_force = m*g - m*a3*I1/D*(s*omega3*omega_n*I3/I1 + t8) */
    out[0] = t13;
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
        t43[k] = t42[k] - p[9]*t22[k];
        t44[k] = jlt_jet_product(x2, t39, k) + x1[k];
        t45[k] = jlt_jet_product(t32, t44, k);
        t46[k] = jlt_jet_product(t25, t45, k) - t38[k];
        t47[k] = (k == 0 ? p[12] : 0) + t39[k];
        t48[k] = jlt_jet_product(x4, t32, k);
        t49[k] = jlt_jet_product(t33, t46, k);
        t50[k] = jlt_jet_product(x0, t33, k);
        t51[k] = x4[k]*p[10] + t50[k];
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
        t62[k] = jlt_jet_product(t48, t61, k) - t49[k];
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

static const jlt_quantity observes[] = {
    { "contact_force", "kg*m/s^2", "force of the plane on the sphere, upwards", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_validity valids[] = {
    { "contact", "kg*m/s^2", "the plane only pushes" },
};

const jlt_descriptor jlt_kernels_spherical_top_general = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "1b6d453374f697d58e1412b96ff746b2599a2a450f7166c0e5909287ba92fdcb",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 6, .block_count = 48,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 5, 26, 13, 1, 1, 0, 12, 10 }, { 17, 69, 0, 12, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, a part of d(v_nu)/dt, e = gamma3*a3 + R, V = omega_tau*e + v_nu, (I3/(R^2*I1))*b*1/(Theta/(m*R^2*I1))*V - omega_tau*gamma3, I3/(m*R) + e, a part of d(omega_tau)/dt, a part of d(omega_tau)/dt, a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(omega3)/dt, d(omega_n)/dt" },
    .jacobian = { jacobian, 25, { 8, 56, 31, 1, 1, 0, 17, 19 }, { 52, 271, 0, 49, 1, 0, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, gamma3*s*1/s^2*b*s*1/s^2*omega_n + R*omega_n, d(d(v_nu)/dt)/d(omega_n), (2*m*a3^2)*s*1/D - s*1/s^2, gamma3*((2*m*a3^2)*s*1/D - s*1/s^2)*gamma3*1/D + s*1/D, (2*I3)*omega3*1/D + s*1/s^2*omega_n*gamma3*1/D*(2*I1), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), omega3*1/D*I3 + s*1/s^2*omega_n*gamma3*1/D*(2*I1), e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(Theta)/d(gamma3) = b*(2*m*R*I3) - gamma3*(2*m*R^2*I1), V*1/Theta*1/Theta*d(Theta)/d(gamma3) - a3*omega_tau*1/Theta, a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), e*(m*R*I3) + I3^2, m*R*a3*I3 - 1/Theta*d(Theta)/d(gamma3)*(e*(m*R*I3) + I3^2), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), d(d(omega_n)/dt)/d(omega_n), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), s*1/Theta*d(Theta)/d(gamma3) + gamma3*s*1/s^2, a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 9, 64, 34, 1, 1, 0, 15, 23 }, { 62, 323, 0, 61, 1, 0, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), (m*R*I3)*e + I3^2, a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(omega_tau), a part of d(d(omega_tau)/dt)/d(gamma3), (I3/I1)*omega3*1/D + omega_n*Theta*((1)/Theta*s^2*D)*D*s*gamma3*1/D, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega_n), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), V = omega_tau*e + v_nu, d(omega_n)/dt, a part of d(d(omega3)/dt)/d(omega_tau), a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(v_nu)/dt, d(d(v_nu)/dt)/d(omega_n)" },
    .divergence = { divergence, 1, { 3, 14, 8, 1, 1, 0, 12, 7 }, { 11, 38, 0, 4, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, V = omega_tau*e + v_nu, a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of the divergence, a part of the divergence" },
    .integral_values = { integral_values, 2, { 2, 12, 9, 0, 1, 0, 7, 6 }, { 10, 32, 0, 0, 1, 0, 12, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*omega3*R + omega_n*b, energy/(1/2*m), G" },
    .integral_gradients = { integral_gradients, 10, { 2, 16, 9, 1, 1, 0, 6, 7 }, { 12, 38, 0, 2, 1, 0, 8, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*omega3*R + omega_n*b, d(G)/d(gamma3), d(v_tau)/d(gamma3)/R = omega_n - omega3*s*(gamma3/s^2), d(E)/d(gamma3), d(E)/d(omega_n), d(E)/d(omega3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { observe_values, 1, { 2, 5, 5, 1, 1, 0, 6, 5 }, { 7, 27, 0, 4, 1, 0, 13, 8 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of contact_force, contact_force" },
    .valid_values = { valid_values, 1, { 2, 5, 5, 1, 1, 0, 6, 5 }, { 7, 27, 0, 4, 1, 0, 13, 8 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in a part of contact, contact" },
    .observe_count = 1, .observes = observes,
    .valid_count = 1, .valids = valids,
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
