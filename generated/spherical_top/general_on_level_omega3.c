/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   26   11    1    1    0     14   12   (82)
 *  jacobian            7   54   31    1    1    0     16   24   (318)
 *  rhs_jacobian        7   57   34    1    1    0     18   24   (369)
 *  divergence          4   17    7    1    1    0     12   10   (54)
 *  integral_values     2    9    9    1    1    0      9    7   (43)
 *  integral_gradients  2   22   13    1    1    0     13   11   (75)
 *  eliminated          3    2    1    1    1    0      5    3   (11)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by b: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level - (R*I1)*omega_n*s, e = gamma3*a3 + R,
 *      I3/(m*R) + e, V = omega_tau*e + v_nu, d(numerator of d(omega_n)/dt over Theta)/d(omega_n),
 *      a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(omega_tau),
 *      d(d(omega_n)/dt)/d(omega_tau), d(omega_n)/dt, d(d(omega_n)/dt)/d(omega_n),
 *      gamma3*omega_tau*gamma3*((1)/s^2*Theta*b*D)*Theta*b*D*s - omega_tau*s,
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_n)/dt)/d(gamma3),
 *      a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3),
 *      d(numerator of d(omega_tau)/dt over D)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3),
 *      d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), a part of d(d(omega_n)/dt)/d(gamma3),
 *      d(d(omega_n)/dt)/d(gamma3), a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3),
 *      numerator of d(omega_tau)/dt over D, d(numerator of d(omega_tau)/dt over D)/d(omega_n),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), a part of d(v_nu)/dt, d(d(v_nu)/dt)/d(omega_n)
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
extern const jlt_descriptor jlt_kernels_spherical_top_general_on_level_omega3;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_on_level_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_omega3_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[5]/t1; /* I3/(m*R*R) */
    out[7] = t2;
    const double t3 = t0*params[4]; /* R*R*I1 */
    const double t4 = params[5]/t3; /* I3/(R*R*I1) */
    out[8] = t4;
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[30] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[9] = t7;
    const double t8 = t3/params[5]; /* R*R*I1/I3 */
    out[10] = t8;
    const double t9 = params[1]*params[4]; /* R*I1 */
    out[18] = t9;
    const double t10 = params[6]/t9; /* G_level/(R*I1) */
    out[11] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[3]*t11; /* a3*m*g */
    out[31] = t12;
    const double t13 = t12/t9; /* a3*m*g/(R*I1) */
    out[12] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[32] = t14;
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[13] = t15;
    const double t16 = params[5]*params[4]; /* I3*I1 */
    out[14] = t16;
    const double t17 = t1*params[4]; /* m*R*R*I1 */
    out[15] = t17;
    const double t18 = params[0]*params[5]; /* m*I3 */
    out[16] = t18;
    const double t19 = params[1]/params[5]; /* R/I3 */
    out[17] = t19;
    const double t20 = t9/params[5]; /* R*I1/I3 */
    out[19] = t20;
    const double t21 = 1.0/params[5]; /* 1/I3 */
    out[20] = t21;
    const double t22 = params[0]*2.0; /* m*2 */
    const double t23 = t5*t22; /* a3*a3*m*2 */
    out[33] = t23;
    const double t24 = t23/params[4]; /* a3*a3*m*2/I1 */
    out[21] = t24;
    const double t25 = params[5]/params[4]; /* I3/I1 */
    out[22] = t25;
    const double t26 = t12/params[4]; /* a3*m*g/I1 */
    out[23] = t26;
    const double t27 = params[1]/2.0; /* R/2 */
    out[24] = t27;
    const double t28 = params[5]*t14; /* I3*m*R */
    out[25] = t28;
    const double t29 = t0*t22; /* R*R*m*2 */
    const double t30 = params[4]*t29; /* I1*R*R*m*2 */
    out[26] = t30;
    const double t31 = params[1]*t22; /* R*m*2 */
    const double t32 = params[5]*t31; /* I3*R*m*2 */
    out[27] = t32;
    const double t33 = params[3]*t14; /* a3*m*R */
    out[35] = t33;
    const double t34 = params[5]*t33; /* I3*a3*m*R */
    out[28] = t34;
    const double t35 = params[0]*params[3]; /* m*a3 */
    const double t36 = params[5]*t35; /* I3*m*a3 */
    out[29] = t36;
    const double t37 = params[4]*2.0; /* I1*2 */
    out[34] = t37;
    const double t38 = params[0]/2.0; /* m/2 */
    out[36] = t38;
    const double t39 = params[2]*2.0; /* g*2 */
    const double t40 = params[3]*t39; /* a3*g*2 */
    out[37] = t40;
    const double t41 = 1.0/params[0]; /* 1/m */
    out[38] = t41;
    const double t42 = params[4]/params[0]; /* I1/m */
    out[39] = t42;
    const double t43 = params[4]*params[4]; /* I1*I1 */
    const double t44 = t0*t43; /* R*R*I1*I1 */
    const double t45 = t44/t18; /* R*R*I1*I1/(m*I3) */
    out[40] = t45;
    const double t46 = params[4]/params[5]; /* I1/I3 */
    const double t47 = -t46; /* -I1/I3 */
    out[41] = t47;
    const double t48 = params[3]/params[1]; /* a3/R */
    out[42] = t48;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[8]*t3; /* I3/(R^2*I1)*b */
    const double t5 = p[7] + t2; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s^2 */
    const double t7 = JLT_FMA(p[9], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = t3*t7; /* b*D/I1 */
    const double t9 = t6*t8; /* Theta/(m*R^2*I1)*b*D/I1 */
    const double t10 = t2*t9; /* s^2*Theta/(m*R^2*I1)*b*D/I1 */
    const double t11 = 1.0/t10; /* 1/(s^2*Theta/(m*R^2*I1)*b*D/I1) */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    const double t13 = t2*t11; /* 1/(b*(D/I1)*(Theta/(m*R^2*I1))) = s^2*1/(s^2*Theta/(m*R^2*I1)*b*D/I1) */
    const double t14 = t6*t13; /* 1/(b*(D/I1)) = Theta/(m*R^2*I1)*1/(b*(D/I1)*(Theta/(m*R^2*I1))) */
    const double t15 = t8*t13; /* 1/(Theta/(m*R^2*I1)) = b*D/I1*1/(b*(D/I1)*(Theta/(m*R^2*I1))) */
    const double t16 = x[3]*t12; /* omega_n*s */
    const double t17 = t9*t16; /* Theta/(m*R^2*I1)*b*D/I1*omega_n*s */
    const double t18 = t11*t17; /* 1/(s^2*Theta/(m*R^2*I1)*b*D/I1)*Theta/(m*R^2*I1)*b*D/I1*omega_n*s */
    const double t19 = p[11] - t16; /* G_level/(R*I1) - omega_n*s */
    const double t20 = t7*t19; /* D/I1*(G_level/(R*I1) - omega_n*s) */
    const double t21 = t14*t20; /* 1/(b*(D/I1))*D/I1*(G_level/(R*I1) - omega_n*s) */
    const double t22 = t3*t14; /* b*1/(b*(D/I1)) */
    const double t23 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t24 = x[2]*t12; /* omega_tau*s */
    out[0] = t24;
    const double t25 = x[3]*t18; /* omega_n*t18 */
    const double t26 = t3*t25; /* b*omega_n*t18 */
    const double t27 = x[2]*p[9]; /* omega_tau*m*a3^2/I1 */
    const double t28 = JLT_FMS(t24, t27, t25); /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*t18 */
    const double t29 = x[0]*t28; /* gamma3*(omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*t18) */
    const double t30 = p[13] + t23; /* I3/(m*R) + e */
    const double t31 = t15*t30; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t32 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t33 = t4*t32; /* I3/(R^2*I1)*b*V */
    const double t34 = t18*t33; /* t18*I3/(R^2*I1)*b*V */
    const double t35 = x[0]*t18; /* gamma3*t18 */
    const double t36 = JLT_FNMA(t21, t31, t35); /* gamma3*t18 - 1/(b*(D/I1))*D/I1*(G_level/(R*I1) - omega_n*s)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t37 = x[3]*t21; /* omega_n*1/(b*(D/I1))*D/I1*(G_level/(R*I1) - omega_n*s) */
    const double t38 = JLT_FNMA(p[10], t37, t26); /* b*omega_n*t18 - R^2*I1/I3*omega_n*1/(b*(D/I1))*D/I1*(G_level/(R*I1) - omega_n*s) */
    out[1] = t38;
    const double t39 = JLT_FMS(p[12], t12, t37); /* m*g*a3/(R*I1)*s - omega_n*1/(b*(D/I1))*D/I1*(G_level/(R*I1) - omega_n*s) */
    const double t40 = JLT_FNMA(p[1], t39, t29); /* gamma3*(omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*t18) - R*t39 */
    const double t41 = t22*t40; /* b*1/(b*(D/I1))*t40 */
    out[2] = t41;
    const double t42 = x[2]*t36; /* omega_tau*t36 */
    const double t43 = JLT_FNMA(t15, t34, t42); /* omega_tau*t36 - 1/(Theta/(m*R^2*I1))*t18*I3/(R^2*I1)*b*V */
    out[3] = t43;
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
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[16]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[15], t2, p[14]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[9], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = t2*t3; /* s^2*b */
    const double t9 = t6*t7; /* Theta*D/I1 */
    const double t10 = t8*t9; /* s^2*b*Theta*D/I1 */
    const double t11 = 1.0/t10; /* 1/(s^2*b*Theta*D/I1) */
    const double t12 = t9*t11; /* Theta*D/I1*1/(s^2*b*Theta*D/I1) */
    const double t13 = t8*t11; /* s^2*b*1/(s^2*b*Theta*D/I1) */
    const double t14 = t7*t13; /* 1/Theta = D/I1*s^2*b*1/(s^2*b*Theta*D/I1) */
    const double t15 = t6*t13; /* 1/(D/I1) = Theta*s^2*b*1/(s^2*b*Theta*D/I1) */
    const double t16 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t16;
    const double t17 = t2*t12; /* 1/b = s^2*Theta*D/I1*1/(s^2*b*Theta*D/I1) */
    const double t18 = t3*t16; /* b*s */
    const double t19 = t12*t18; /* Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    const double t20 = x[3]*t16; /* omega_n*s */
    const double t21 = JLT_FNMA(p[18], t20, p[6]); /* G_level - R*I1*omega_n*s */
    const double t22 = t17*t21; /* 1/b*(G_level - R*I1*omega_n*s) */
    const double t23 = t17*t20; /* 1/b*omega_n*s */
    const double t24 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t25 = p[17]*t17; /* R/I3*1/b */
    const double t26 = t22*t25; /* 1/b*(G_level - R*I1*omega_n*s)*R/I3*1/b */
    const double t27 = p[20]*t22; /* 1/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t28 = x[3]*t19; /* omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    const double t29 = x[0]*p[21]; /* gamma3*2*m*a3^2/I1 */
    const double t30 = t15*t29; /* 1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t31 = p[25]*t14; /* m*R*I3*1/Theta */
    const double t32 = x[0]*p[26]; /* gamma3*2*m*R^2*I1 */
    const double t33 = JLT_FMS(p[27], t3, t32); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t34 = t3*t28; /* b*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    const double t35 = p[13] + t24; /* I3/(m*R) + e */
    const double t36 = x[0]*t19; /* gamma3*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    const double t37 = x[0]*t28; /* gamma3*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    const double t38 = p[19]*t17; /* R*I1/I3*1/b */
    const double t39 = JLT_FNMA(t37, t38, t26); /* d(omega3)/d(gamma3) = 1/b*(G_level - R*I1*omega_n*s)*R/I3*1/b - gamma3*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*R*I1/I3*1/b */
    const double t40 = t19*t28; /* Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    const double t41 = t31*t35; /* m*R*I3*1/Theta*(I3/(m*R) + e) */
    const double t42 = t28*t31; /* omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*m*R*I3*1/Theta */
    const double t43 = p[15]*t35; /* m*R^2*I1*(I3/(m*R) + e) */
    const double t44 = JLT_FNMA(t16, t30, t36); /* gamma3*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s - s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t45 = x[2]*p[9]; /* omega_tau*m*a3^2/I1 */
    const double t46 = x[2]*t45; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t47 = t28*t40; /* omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*t40 */
    const double t48 = JLT_FMS(p[23], t44, t47); /* m*g*a3/I1*t44 - omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*t40 */
    const double t49 = JLT_FMS(x[0], t44, t16); /* gamma3*t44 - s */
    const double t50 = JLT_FNMA(t46, t49, t48); /* t48 - omega_tau*omega_tau*m*a3^2/I1*(gamma3*t44 - s) */
    const double t51 = x[2]*t16; /* omega_tau*s */
    const double t52 = t19*t40; /* Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*t40 */
    const double t53 = t28 + t39; /* omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s + d(omega3)/d(gamma3) */
    const double t54 = JLT_FMA(t39, t41, t52); /* d(omega3)/d(gamma3)*m*R*I3*1/Theta*(I3/(m*R) + e) + Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*t40 */
    const double t55 = p[22]*t39; /* I3/I1*d(omega3)/d(gamma3) */
    const double t56 = t43*t51; /* m*R^2*I1*(I3/(m*R) + e)*omega_tau*s */
    const double t57 = t30*t51; /* 1/(D/I1)*gamma3*2*m*a3^2/I1*omega_tau*s */
    out[10] = t57;
    const double t58 = p[22]*t27; /* I3/I1*1/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t59 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t60 = t4*t59; /* m*I3*b*V */
    const double t61 = t19*t60; /* Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*m*I3*b*V */
    const double t62 = JLT_FNMA(t17, t56, t61); /* Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*m*I3*b*V - 1/b*m*R^2*I1*(I3/(m*R) + e)*omega_tau*s */
    const double t63 = t19*t36; /* Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*gamma3*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    const double t64 = JLT_FNMA(t14, t33, t63); /* t63 - 1/Theta*d(Theta)/d(gamma3) */
    const double t65 = JLT_FNMA(t33, t41, p[28]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*m*R*I3*1/Theta*(I3/(m*R) + e) */
    const double t66 = t27*t65; /* 1/I3*1/b*(G_level - R*I1*omega_n*s)*(m*R*a3*I3 - d(Theta)/d(gamma3)*m*R*I3*1/Theta*(I3/(m*R) + e)) */
    const double t67 = JLT_FMA(p[29], t34, t66); /* m*a3*I3*b*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s + t66 */
    const double t68 = JLT_FNMA(t14, t67, t54); /* t54 - 1/Theta*(m*a3*I3*b*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s + t66) */
    const double t69 = x[2]*t36; /* omega_tau*gamma3*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    const double t70 = JLT_FNMA(t14, t62, t69); /* omega_tau*gamma3*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s - 1/Theta*t62 */
    out[15] = t70;
    const double t71 = -t69; /* -omega_tau*gamma3*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    out[0] = t71;
    const double t72 = p[16]*t14; /* m*I3*1/Theta */
    const double t73 = t34*t72; /* b*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*m*I3*1/Theta */
    const double t74 = JLT_FMA(t64, t73, t42); /* (t63 - 1/Theta*d(Theta)/d(gamma3))*b*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*m*I3*1/Theta + omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*m*R*I3*1/Theta */
    const double t75 = t59*t74; /* V*t74 */
    const double t76 = JLT_FMS(x[2], t68, t75); /* omega_tau*t68 - V*t74 */
    out[12] = t76;
    const double t77 = t19*t37; /* Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*gamma3*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    const double t78 = JLT_FNMA(t27, t41, t37); /* gamma3*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s - 1/I3*1/b*(G_level - R*I1*omega_n*s)*m*R*I3*1/Theta*(I3/(m*R) + e) */
    const double t79 = JLT_FNMA(t24, t73, t78); /* t78 - e*b*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*m*I3*1/Theta */
    out[14] = t79;
    const double t80 = -t73; /* -b*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*m*I3*1/Theta */
    out[13] = t80;
    const double t81 = p[1]*t27; /* R*1/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t82 = JLT_FMS(p[10], t23, t81); /* R^2*I1/I3*1/b*omega_n*s - R*1/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t83 = JLT_FMA(2.0, t34, t82); /* 2*b*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s + t82 */
    out[7] = t83;
    const double t84 = JLT_FMA(p[24], t23, t37); /* 1/2*R*1/b*omega_n*s + gamma3*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s */
    const double t85 = t37 - t58; /* gamma3*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s - I3/I1*1/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t86 = JLT_FMA(t30, t85, t55); /* 1/(D/I1)*gamma3*2*m*a3^2/I1*t85 + I3/I1*d(omega3)/d(gamma3) */
    const double t87 = JLT_FNMA(x[3], t86, t50); /* t48 - omega_tau*omega_tau*m*a3^2/I1*(gamma3*t44 - s) - omega_n*(1/(D/I1)*gamma3*2*m*a3^2/I1*t85 + I3/I1*d(omega3)/d(gamma3)) */
    const double t88 = JLT_FNMA(2.0, t84, t58); /* I3/I1*1/I3*1/b*(G_level - R*I1*omega_n*s) - 2*t84 */
    const double t89 = t15*t87; /* 1/(D/I1)*t87 */
    out[8] = t89;
    const double t90 = t15*t88; /* 1/(D/I1)*(I3/I1*1/I3*1/b*(G_level - R*I1*omega_n*s) - 2*t84) */
    out[11] = t90;
    const double t91 = p[1]*x[3]; /* R*omega_n */
    const double t92 = t53*t91; /* t53*R*omega_n */
    const double t93 = JLT_FMA(t34, t77, t92); /* b*omega_n*Theta*D/I1*1/(s^2*b*Theta*D/I1)*b*s*t77 + t53*R*omega_n */
    out[4] = t93;
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
    const double t4 = p[16]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[15], t2, p[14]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t3*t7; /* b*D */
    const double t9 = t6*t8; /* Theta*b*D */
    const double t10 = t2*t9; /* s^2*Theta*b*D */
    const double t11 = 1.0/t10; /* 1/(s^2*Theta*b*D) */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t12;
    const double t13 = t9*t12; /* Theta*b*D*s */
    const double t14 = t2*t11; /* 1/(b*D*Theta) = s^2*1/(s^2*Theta*b*D) */
    const double t15 = t11*t13; /* 1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t16 = t6*t14; /* 1/(b*D) = Theta*1/(b*D*Theta) */
    const double t17 = t8*t14; /* 1/Theta = b*D*1/(b*D*Theta) */
    const double t18 = t7*t16; /* 1/b = D*1/(b*D) */
    const double t19 = t3*t16; /* 1/D = b*1/(b*D) */
    const double t20 = x[3]*t12; /* omega_n*s */
    const double t21 = x[3]*t15; /* omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t22 = JLT_FNMA(p[18], t20, p[6]); /* G_level - R*I1*omega_n*s */
    const double t23 = t18*t22; /* 1/b*(G_level - R*I1*omega_n*s) */
    const double t24 = t18*t20; /* 1/b*omega_n*s */
    const double t25 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t26 = t3*t21; /* b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t27 = x[0]*t15; /* gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t28 = p[13] + t25; /* I3/(m*R) + e */
    const double t29 = p[17]*t23; /* R/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t30 = x[2]*p[30]; /* omega_tau*m*a3^2 */
    const double t31 = x[3]*t27; /* omega_n*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t32 = JLT_FMA(x[2], t25, x[1]); /* V = omega_tau*e + v_nu */
    const double t33 = t4*t32; /* m*I3*b*V */
    const double t34 = t15*t33; /* 1/(s^2*Theta*b*D)*Theta*b*D*s*m*I3*b*V */
    const double t35 = p[16]*t26; /* m*I3*b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t36 = p[32]*t28; /* m*R*(I3/(m*R) + e) */
    const double t37 = p[15]*t28; /* m*R^2*I1*(I3/(m*R) + e) */
    const double t38 = x[2]*t12; /* omega_tau*s */
    out[0] = t38;
    const double t39 = t37*t38; /* m*R^2*I1*(I3/(m*R) + e)*omega_tau*s */
    const double t40 = JLT_FMS(t18, t39, t34); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_n) = 1/b*m*R^2*I1*(I3/(m*R) + e)*omega_tau*s - 1/(s^2*Theta*b*D)*Theta*b*D*s*m*I3*b*V */
    const double t41 = x[0]*t30; /* gamma3*omega_tau*m*a3^2 */
    const double t42 = t38*t41; /* omega_tau*s*gamma3*omega_tau*m*a3^2 */
    const double t43 = JLT_FNMA(p[31], t12, t42); /* omega_tau*s*gamma3*omega_tau*m*a3^2 - m*g*a3*s */
    const double t44 = t32*t35; /* V*m*I3*b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t45 = t23*t36; /* 1/b*(G_level - R*I1*omega_n*s)*m*R*(I3/(m*R) + e) */
    const double t46 = JLT_FMA(x[2], t45, t44); /* omega_tau*1/b*(G_level - R*I1*omega_n*s)*m*R*(I3/(m*R) + e) + V*m*I3*b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t47 = JLT_FMA(t25, t35, t45); /* e*m*I3*b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s + 1/b*(G_level - R*I1*omega_n*s)*m*R*(I3/(m*R) + e) */
    const double t48 = JLT_FNMA(t17, t47, t31); /* omega_n*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s - 1/Theta*t47 */
    out[18] = t48;
    const double t49 = t17*t46; /* 1/Theta*t46 */
    const double t50 = t17*t35; /* 1/Theta*m*I3*b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t51 = JLT_FMS(x[2], t31, t49); /* omega_tau*omega_n*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s - 1/Theta*t46 */
    out[3] = t51;
    const double t52 = -t50; /* -1/Theta*m*I3*b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    out[17] = t52;
    const double t53 = x[2]*t27; /* omega_tau*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t54 = JLT_FMA(t17, t40, t53); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_n) + omega_tau*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s */
    out[19] = t54;
    const double t55 = -t53; /* -omega_tau*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s */
    out[4] = t55;
    const double t56 = JLT_FMS(x[0], t53, t38); /* gamma3*omega_tau*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s - omega_tau*s */
    const double t57 = JLT_FMS(p[19], t31, t29); /* R*I1/I3*omega_n*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s - R/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t58 = t18*t57; /* 1/b*t57 */
    const double t59 = p[31]*t27; /* m*g*a3*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t60 = t27*t32; /* gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s*V */
    const double t61 = p[25]*t32; /* m*R*I3*V */
    const double t62 = t21*t61; /* omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s*m*R*I3*V */
    const double t63 = t15*t21; /* 1/(s^2*Theta*b*D)*Theta*b*D*s*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t64 = p[4]*t21; /* I1*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t65 = JLT_FNMA(t63, t64, t59); /* m*g*a3*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s - t63*I1*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t66 = JLT_FNMA(t30, t56, t65); /* t65 - omega_tau*m*a3^2*t56 */
    const double t67 = x[2]*t63; /* omega_tau*t63 */
    const double t68 = JLT_FNMA(t50, t60, t67); /* omega_tau*t63 - 1/Theta*m*I3*b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s*V */
    const double t69 = t58 - t21; /* 1/b*t57 - omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t70 = p[5]*t58; /* I3*1/b*t57 */
    const double t71 = JLT_FMA(x[3], t70, t66); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = omega_n*I3*1/b*t57 + t65 - omega_tau*m*a3^2*t56 */
    const double t72 = t15*t68; /* 1/(s^2*Theta*b*D)*Theta*b*D*s*t68 */
    const double t73 = t15*t26; /* 1/(s^2*Theta*b*D)*Theta*b*D*s*b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t74 = p[35]*t23; /* m*R*a3*1/b*(G_level - R*I1*omega_n*s) */
    const double t75 = JLT_FMA(p[29], t26, t74); /* m*a3*I3*b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s + m*R*a3*1/b*(G_level - R*I1*omega_n*s) */
    const double t76 = JLT_FMA(t36, t70, t75); /* m*R*(I3/(m*R) + e)*I3*1/b*t57 + t75 */
    const double t77 = x[0]*p[26]; /* gamma3*2*m*R^2*I1 */
    const double t78 = JLT_FMS(p[27], t3, t77); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t79 = JLT_FNMA(t49, t78, t62); /* omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s*m*R*I3*V - 1/Theta*t46*d(Theta)/d(gamma3) */
    const double t80 = JLT_FMA(x[2], t76, t79); /* omega_tau*(m*R*(I3/(m*R) + e)*I3*1/b*t57 + t75) + t79 */
    const double t81 = JLT_FNMA(t17, t80, t72); /* 1/(s^2*Theta*b*D)*Theta*b*D*s*t68 - 1/Theta*(omega_tau*(m*R*(I3/(m*R) + e)*I3*1/b*t57 + t75) + t79) */
    out[16] = t81;
    const double t82 = JLT_FNMA(p[4], t31, t23); /* 1/b*(G_level - R*I1*omega_n*s) - I1*omega_n*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t83 = JLT_FMA(x[3], t82, t43); /* numerator of d(omega_tau)/dt over D = omega_n*t82 + omega_tau*s*gamma3*omega_tau*m*a3^2 - m*g*a3*s */
    const double t84 = JLT_FNMA(p[34], t31, t23); /* 1/b*(G_level - R*I1*omega_n*s) - 2*I1*omega_n*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s */
    const double t85 = JLT_FNMA(p[18], t24, t84); /* d(numerator of d(omega_tau)/dt over D)/d(omega_n) = t84 - R*I1*1/b*omega_n*s */
    const double t86 = t19*t85; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(omega_n) */
    out[15] = t86;
    const double t87 = t19*t83; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t87;
    const double t88 = x[0]*p[33]; /* gamma3*2*m*a3^2 */
    const double t89 = t19*t88; /* 1/D*gamma3*2*m*a3^2 */
    const double t90 = JLT_FMA(t83, t89, t71); /* numerator of d(omega_tau)/dt over D*1/D*gamma3*2*m*a3^2 + d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    const double t91 = t19*t90; /* 1/D*t90 */
    out[12] = t91;
    const double t92 = t38*t89; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[14] = t92;
    const double t93 = x[3]*p[1]; /* omega_n*R */
    const double t94 = t69*t93; /* (1/b*t57 - omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s)*omega_n*R */
    const double t95 = JLT_FMS(t31, t73, t94); /* omega_n*gamma3*1/(s^2*Theta*b*D)*Theta*b*D*s*t73 - (1/b*t57 - omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s)*omega_n*R */
    out[8] = t95;
    const double t96 = t26 - t29; /* b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s - R/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t97 = JLT_FMS(2.0, t26, t29); /* 2*b*omega_n*1/(s^2*Theta*b*D)*Theta*b*D*s - R/I3*1/b*(G_level - R*I1*omega_n*s) */
    const double t98 = JLT_FMA(p[10], t24, t97); /* R^2*I1/I3*1/b*omega_n*s + t97 */
    out[11] = t98;
    const double t99 = x[3]*t96; /* omega_n*t96 */
    out[1] = t99;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t5 = p[8]*t3; /* I3/(R^2*I1)*b */
    const double t6 = p[7] + t2; /* I3/(m*R^2) + s^2 */
    const double t7 = JLT_FMA(t3, t5, t6); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s^2 */
    const double t8 = t3*t4; /* b*D */
    const double t9 = t2*t8; /* s^2*b*D */
    const double t10 = t7*t9; /* Theta/(m*R^2*I1)*s^2*b*D */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s^2*b*D) */
    const double t12 = t9*t11; /* 1/(Theta/(m*R^2*I1)) = s^2*b*D*1/(Theta/(m*R^2*I1)*s^2*b*D) */
    const double t13 = t7*t11; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*b*D) */
    const double t14 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t15 = x[0]*p[33]; /* gamma3*2*m*a3^2 */
    const double t16 = t3*t15; /* b*gamma3*2*m*a3^2 */
    const double t17 = p[13] + t14; /* I3/(m*R) + e */
    const double t18 = t4*t17; /* D*(I3/(m*R) + e) */
    const double t19 = JLT_FMA(t12, t18, t16); /* 1/(Theta/(m*R^2*I1))*D*(I3/(m*R) + e) + b*gamma3*2*m*a3^2 */
    const double t20 = JLT_FMA(x[2], t14, x[1]); /* V = omega_tau*e + v_nu */
    const double t21 = t5*t20; /* I3/(R^2*I1)*b*V */
    const double t22 = t8*t21; /* b*D*I3/(R^2*I1)*b*V */
    const double t23 = t13*t22; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*b*D)*b*D*I3/(R^2*I1)*b*V */
    const double t24 = x[2]*t2; /* omega_tau*s^2 */
    const double t25 = t13*t24; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*b*D)*omega_tau*s^2 */
    const double t26 = t19*t25; /* (1/(Theta/(m*R^2*I1))*D*(I3/(m*R) + e) + b*gamma3*2*m*a3^2)*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*b*D)*omega_tau*s^2 */
    const double t27 = JLT_FNMA(t12, t23, t26); /* t26 - 1/(Theta/(m*R^2*I1))*t23 */
    const double t28 = sqrt(t2); /* s = sqrt(s^2) */
    const double t29 = t27*t28; /* (t26 - 1/(Theta/(m*R^2*I1))*t23)*s */
    out[0] = t29;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FNMA(x[3], t3, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t7 = t6/t5; /* (G_level/(R*I1) - omega_n*s)/b */
    const double t8 = x[3]*t5; /* omega_n*b */
    const double t9 = p[10]*t3; /* R^2*I1/I3*s */
    const double t10 = JLT_FNMA(t7, t9, t8); /* v_tau = omega_n*b - (G_level/(R*I1) - omega_n*s)/b*R^2*I1/I3*s */
    const double t11 = p[37]*x[0]; /* 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(x[1], x[1], t11); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[38]*x[2]; /* 1/m*omega_tau */
    const double t14 = x[2]*t13; /* omega_tau*1/m*omega_tau */
    const double t15 = p[39]*x[3]; /* I1/m*omega_n */
    const double t16 = JLT_FMA(x[3], t15, t12); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t17 = JLT_FMA(t4, t14, t16); /* D*omega_tau*1/m*omega_tau + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = p[40]*t7; /* R^2*I1^2/(m*I3)*(G_level/(R*I1) - omega_n*s)/b */
    const double t19 = JLT_FMA(t7, t18, t17); /* (G_level/(R*I1) - omega_n*s)/b*R^2*I1^2/(m*I3)*(G_level/(R*I1) - omega_n*s)/b + t17 */
    const double t20 = JLT_FMA(t10, t10, t19); /* energy/(1/2*m) = v_tau*v_tau + t19 */
    const double t21 = p[36]*t20; /* 1/2*m*energy/(1/2*m) */
    out[0] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = t3*t4; /* s^2*b */
    const double t6 = 1.0/t5; /* 1/(s^2*b) */
    const double t7 = sqrt(t3); /* s = sqrt(s^2) */
    const double t8 = x[3]*p[18]; /* omega_n*R*I1 */
    const double t9 = JLT_FNMA(t7, t8, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t10 = x[0]*t4; /* gamma3*b */
    const double t11 = t6*t10; /* 1/(s^2*b)*gamma3*b */
    const double t12 = t3*t6; /* 1/b = s^2*1/(s^2*b) */
    const double t13 = t9*t12; /* (G_level - s*omega_n*R*I1)*1/b */
    const double t14 = t7*t11; /* s*1/(s^2*b)*gamma3*b */
    const double t15 = p[19]*x[3]; /* R*I1/I3*omega_n */
    const double t16 = p[17]*t13; /* R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t17 = JLT_FMS(t14, t15, t16); /* s*1/(s^2*b)*gamma3*b*R*I1/I3*omega_n - R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t18 = t12*t17; /* 1/b*t17 */
    const double t19 = p[30]*x[0]; /* m*a3^2*gamma3 */
    const double t20 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t21 = JLT_FNMA(t19, t20, p[31]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t22 = JLT_FMA(t13, t18, t21); /* (G_level - s*omega_n*R*I1)*1/b*1/b*t17 + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t23 = JLT_FNMA(t7, t18, x[3]); /* omega_n - s*1/b*t17 */
    const double t24 = p[1]*t23; /* R*(omega_n - s*1/b*t17) */
    const double t25 = JLT_FMA(t14, t16, t24); /* d(v_tau)/d(gamma3) = s*1/(s^2*b)*gamma3*b*R/I3*(G_level - s*omega_n*R*I1)*1/b + R*(omega_n - s*1/b*t17) */
    const double t26 = x[3]*t4; /* omega_n*b */
    const double t27 = JLT_FNMA(t7, t16, t26); /* v_tau = omega_n*b - s*R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t28 = p[19]*t7; /* R*I1/I3*s */
    const double t29 = t12*t28; /* 1/b*R*I1/I3*s */
    const double t30 = p[0]*t27; /* m*v_tau */
    const double t31 = JLT_FMA(t25, t30, t22); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau + t22 */
    out[0] = t31;
    const double t32 = x[3]*p[4]; /* omega_n*I1 */
    const double t33 = JLT_FNMA(t13, t29, t32); /* omega_n*I1 - (G_level - s*omega_n*R*I1)*1/b*1/b*R*I1/I3*s */
    const double t34 = p[10]*t3; /* R^2*I1/I3*s^2 */
    const double t35 = JLT_FMA(t12, t34, t4); /* d(v_tau)/d(omega_n) = 1/b*R^2*I1/I3*s^2 + b */
    const double t36 = JLT_FMA(t30, t35, t33); /* d(energy)/d(omega_n) = m*v_tau*d(v_tau)/d(omega_n) + omega_n*I1 - (G_level - s*omega_n*R*I1)*1/b*1/b*R*I1/I3*s */
    out[3] = t36;
    const double t37 = JLT_FMA(p[30], t3, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t38 = x[2]*t37; /* omega_tau*D */
    out[2] = t38;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FNMA(x[3], t3, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t5 = p[42] + x[0]; /* b/R = a3/R + gamma3 */
    const double t6 = p[41]/t5; /* (-I1/I3)/(b/R) */
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
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
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
        t10[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t12[k] = jlt_jet_quotient(x3[k], t6, t12, k);
        t13[k] = jlt_jet_product(x3, t12, k);
        t14[k] = jlt_jet_product(t10, t13, k);
        t17[k] = (k == 0 ? p[11] : 0) - jlt_jet_product(t6, x3, k);
        t18[k] = jlt_jet_quotient(t17[k], t10, t18, k);
        t19[k] = jlt_jet_product(x3, t18, k);
        t20[k] = t14[k] - p[10]*t19[k];
        t22[k] = t5[k]*p[9] + (k == 0 ? 1.0 : 0);
        t23[k] = x2[k]*p[9];
        t24[k] = jlt_jet_product(t7, t23, k) - t13[k];
        t25[k] = jlt_jet_product(x0, t24, k);
        t27[k] = t6[k]*p[12] - t19[k];
        t28[k] = t25[k] - p[1]*t27[k];
        t29[k] = jlt_jet_quotient(t28[k], t22, t29, k);
        t30[k] = jlt_jet_product(x0, t12, k);
        t33[k] = t10[k]*p[8];
        t34[k] = t5[k] + (k == 0 ? p[7] : 0);
        t35[k] = jlt_jet_product(t10, t33, k) + t34[k];
        t36[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t35, t36, k);
        t38[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t39[k] = (k == 0 ? p[13] : 0) + t38[k];
        t40[k] = jlt_jet_product(t36, t39, k);
        t41[k] = t30[k] - jlt_jet_product(t18, t40, k);
        t42[k] = jlt_jet_product(x2, t41, k);
        t44[k] = jlt_jet_product(x2, t38, k) + x1[k];
        t45[k] = jlt_jet_product(t33, t44, k);
        t46[k] = jlt_jet_product(t36, t45, k);
        t47[k] = t42[k] - jlt_jet_product(t12, t46, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t20[k]/(k + 1);
        next[2] = x2[k + 1] = t29[k]/(k + 1);
        next[3] = x3[k + 1] = t47[k]/(k + 1);
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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

const jlt_descriptor jlt_kernels_spherical_top_general_on_level_omega3 = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "level_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .prepared_count = 43,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 26, 11, 1, 1, 0, 14, 12 }, { 15, 56, 0, 10, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level/(R*I1) - omega_n*s, e = gamma3*a3 + R, a part of d(omega_tau)/dt, I3/(m*R) + e, V = omega_tau*e + v_nu, a part of d(omega_n)/dt, d(v_nu)/dt, a part of d(omega_tau)/dt, a part of d(omega_tau)/dt, d(omega_n)/dt" },
    .jacobian = { jacobian, 16, { 7, 54, 31, 1, 1, 0, 16, 24 }, { 45, 230, 0, 42, 1, 0, 18, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level - (R*I1)*omega_n*s, e = gamma3*a3 + R, d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), I3/(m*R) + e, d(omega3)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), omega_n*Theta*D/I1*((1)/s^2*b*Theta*D/I1)*b*s + d(omega3)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(omega_n)/dt)/d(omega_n), a part of d(d(omega_n)/dt)/d(gamma3), m*R*a3*I3 - d(Theta)/d(gamma3)*(m*R*I3)*1/Theta*(I3/(m*R) + e), a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), d(d(v_nu)/dt)/d(omega_n), a part of d(d(omega_tau)/dt)/d(omega_n), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(omega_n), d(d(v_nu)/dt)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 7, 57, 34, 1, 1, 0, 18, 24 }, { 52, 265, 0, 51, 1, 0, 18, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level - (R*I1)*omega_n*s, e = gamma3*a3 + R, I3/(m*R) + e, V = omega_tau*e + v_nu, d(numerator of d(omega_n)/dt over Theta)/d(omega_n), a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(omega_tau), d(d(omega_n)/dt)/d(omega_tau), d(omega_n)/dt, d(d(omega_n)/dt)/d(omega_n), gamma3*omega_tau*gamma3*((1)/s^2*Theta*b*D)*Theta*b*D*s - omega_tau*s, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), d(numerator of d(omega_tau)/dt over D)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), numerator of d(omega_tau)/dt over D, d(numerator of d(omega_tau)/dt over D)/d(omega_n), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), a part of d(v_nu)/dt, d(d(v_nu)/dt)/d(omega_n)" },
    .divergence = { divergence, 1, { 4, 17, 7, 1, 1, 0, 12, 10 }, { 10, 39, 0, 4, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, I3/(m*R) + e, 1/(Theta/(m*R^2*I1))*D*(I3/(m*R) + e) + b*gamma3*(2*m*a3^2), V = omega_tau*e + v_nu, a part of the divergence" },
    .integral_values = { integral_values, 1, { 2, 9, 9, 1, 1, 0, 9, 7 }, { 10, 31, 0, 1, 1, 0, 13, 6 },
        "divides by b: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level/(R*I1) - omega_n*s, v_tau = omega_n*b - ((G_level/(R*I1) - omega_n*s)/b)*(R^2*I1/I3)*s, energy/(1/2*m)" },
    .integral_gradients = { integral_gradients, 4, { 2, 22, 13, 1, 1, 0, 13, 11 }, { 15, 53, 0, 6, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level - s*omega_n*(R*I1), a part of d(E)/d(gamma3), a part of d(E)/d(gamma3), d(v_tau)/d(gamma3), v_tau = omega_n*b - s*(R/I3)*(G_level - s*omega_n*(R*I1))*1/b, d(E)/d(gamma3), d(E)/d(omega_n)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 2, 1, 1, 1, 0, 5, 3 }, { 3, 6, 0, 1, 1, 0, 6, 4 },
        "divides by b: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, b/R = a3/R + gamma3" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .eliminated_state = 4, .level_integral = 1,
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_on_level_omega3,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_general_on_level_omega3) },
#endif
};
