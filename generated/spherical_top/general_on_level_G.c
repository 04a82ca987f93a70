/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   24   12    1    1    0     16    9   (83)
 *  jacobian            8   55   29    1    1    0     20   24   (327)
 *  rhs_jacobian        11   58   30    1    1    0     16   20   (379)
 *  divergence          2   14   10    1    1    0     15    7   (57)
 *  integral_values     3   12    8    1    1    0      8    8   (43)
 *  integral_gradients  3   17   12    1    1    0     10   10   (72)
 *  eliminated          3    3    1    1    1    0      4    4   (11)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*(R*I3)*omega3 + G_level,
 *      m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), e = gamma3*a3 + R, m*g*a3 - omega_tau*gamma3*omega_tau*(m*a3^2),
 *      a part of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(omega3)/dt)/d(omega_tau),
 *      d(numerator of d(omega_tau)/dt over D)/d(gamma3), numerator of d(omega_tau)/dt over D,
 *      a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(gamma3),
 *      a part of d(d(omega3)/dt)/d(omega3), a part of d(d(omega_tau)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3),
 *      d(d(v_nu)/dt)/d(omega3), d(Theta)/d(gamma3) = (2*m*R^2*I3)*b/R - gamma3*(2*m*R^2*I1),
 *      a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(v_nu)/dt,
 *      a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3)
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
    const double t0 = params[1]*params[4]; /* R*I1 */
    const double t1 = 1.0/t0; /* 1/(R*I1) */
    out[7] = t1;
    const double t2 = params[3]*params[3]; /* a3*a3 */
    const double t3 = params[0]*t2; /* m*a3*a3 */
    out[16] = t3;
    const double t4 = t3/params[4]; /* m*a3*a3/I1 */
    out[8] = t4;
    const double t5 = params[1]*params[1]; /* R*R */
    const double t6 = params[0]*t5; /* m*R*R */
    out[56] = t6;
    const double t7 = params[5]/t6; /* I3/(m*R*R) */
    out[9] = t7;
    const double t8 = params[4]*t5; /* I1*R*R */
    const double t9 = params[5]/t8; /* I3/(I1*R*R) */
    out[10] = t9;
    const double t10 = params[0]*params[2]; /* m*g */
    const double t11 = params[3]*t10; /* a3*m*g */
    out[26] = t11;
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
    const double t20 = params[4]*params[5]; /* I1*I3 */
    out[17] = t20;
    const double t21 = params[4]*t6; /* I1*m*R*R */
    out[18] = t21;
    const double t22 = params[0]*params[5]; /* m*I3 */
    out[19] = t22;
    const double t23 = params[4]*params[4]; /* I1*I1 */
    const double t24 = t5*t23; /* R*R*I1*I1 */
    const double t25 = 1.0/t24; /* 1/(R*R*I1*I1) */
    out[20] = t25;
    const double t26 = params[1]*2.0; /* R*2 */
    const double t27 = params[4]*t26; /* I1*R*2 */
    out[21] = t27;
    const double t28 = 1.0/params[4]; /* 1/I1 */
    out[22] = t28;
    const double t29 = params[5]*2.0; /* I3*2 */
    const double t30 = t29/t24; /* I3*2/(R*R*I1*I1) */
    out[23] = t30;
    const double t31 = params[0]*2.0; /* m*2 */
    const double t32 = t2*t31; /* a3*a3*m*2 */
    out[25] = t32;
    const double t33 = t32/t0; /* a3*a3*m*2/(R*I1) */
    out[24] = t33;
    const double t34 = 1.0/t8; /* 1/(I1*R*R) */
    out[27] = t34;
    const double t35 = params[5]/t0; /* I3/(R*I1) */
    out[44] = t35;
    const double t36 = -t35; /* -I3/(R*I1) */
    out[28] = t36;
    const double t37 = params[5]*(-2.0); /* I3*(-2) */
    const double t38 = t37/t8; /* I3*(-2)/(I1*R*R) */
    out[29] = t38;
    const double t39 = params[1]*params[0]; /* R*m */
    const double t40 = params[4]*t39; /* I1*R*m */
    out[30] = t40;
    const double t41 = t5*t31; /* R*R*m*2 */
    const double t42 = params[4]*t41; /* I1*R*R*m*2 */
    out[31] = t42;
    const double t43 = params[1]*t31; /* R*m*2 */
    const double t44 = params[5]*t43; /* I3*R*m*2 */
    out[32] = t44;
    const double t45 = t6*t17; /* m*R*R*(I1 - I3) */
    out[33] = t45;
    const double t46 = params[3]*t39; /* a3*R*m */
    const double t47 = params[5]*t46; /* I3*a3*R*m */
    out[34] = t47;
    const double t48 = params[3]/params[1]; /* a3/R */
    out[35] = t48;
    const double t49 = params[1]*params[5]; /* R*I3 */
    out[36] = t49;
    const double t50 = t6*params[5]; /* m*R*R*I3 */
    out[37] = t50;
    const double t51 = params[1]*t23; /* R*I1*I1 */
    const double t52 = 1.0/t51; /* 1/(R*I1*I1) */
    out[38] = t52;
    const double t53 = 2.0/t0; /* 2/(R*I1) */
    out[39] = t53;
    const double t54 = t29/t23; /* I3*2/(I1*I1) */
    out[40] = t54;
    const double t55 = t49/params[4]; /* R*I3/I1 */
    out[41] = t55;
    const double t56 = 2.0/t8; /* 2/(I1*R*R) */
    out[42] = t56;
    const double t57 = t49/2.0; /* R*I3/2 */
    out[43] = t57;
    const double t58 = t29/t0; /* I3*2/(R*I1) */
    out[45] = t58;
    const double t59 = params[5]*params[5]; /* I3*I3 */
    const double t60 = t59/params[4]; /* I3*I3/I1 */
    out[46] = t60;
    const double t61 = params[0]*params[3]; /* m*a3 */
    out[47] = t61;
    const double t62 = params[5]*t41; /* I3*R*R*m*2 */
    out[48] = t62;
    const double t63 = params[5]*t39; /* I3*R*m */
    out[49] = t63;
    const double t64 = params[0]/2.0; /* m/2 */
    out[50] = t64;
    const double t65 = params[2]*2.0; /* g*2 */
    const double t66 = params[3]*t65; /* a3*g*2 */
    out[51] = t66;
    const double t67 = 1.0/params[0]; /* 1/m */
    out[52] = t67;
    const double t68 = 1.0/t21; /* 1/(I1*m*R*R) */
    out[53] = t68;
    const double t69 = params[5]/params[0]; /* I3/m */
    out[54] = t69;
    const double t70 = 1.0/params[1]; /* 1/R */
    out[55] = t70;
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
    const double t30 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t31 = JLT_FMA(x[2], t30, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = t21*t31; /* omega_n*V */
    const double t33 = x[3]*t21; /* omega3*omega_n */
    const double t34 = JLT_FMA(p[1], t33, t24); /* R*omega3*omega_n + b*omega_n*t22 */
    out[1] = t34;
    const double t35 = JLT_FNMA(p[12], t33, t29); /* t29 - I3/I1*omega3*omega_n */
    const double t36 = t16*t35; /* Theta/(m*R^2*I1)*1/((D/I1)*(Theta/(m*R^2*I1)))*(t29 - I3/I1*omega3*omega_n) */
    out[2] = t36;
    const double t37 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/I1 - gamma3*R*(I1 - I3)/I1 */
    const double t38 = x[3]*t37; /* omega3*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) */
    const double t39 = JLT_FMA(t25, t38, t32); /* omega_tau*s*omega3*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) + omega_n*V */
    const double t40 = t17*t39; /* (-1/R)*D/I1*1/((D/I1)*(Theta/(m*R^2*I1)))*t39 */
    out[3] = t40;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt(s^2) */
    out[2] = t4;
    const double t5 = JLT_FMA(t3, p[16], p[4]); /* D = s^2*m*a3^2 + I1 */
    const double t6 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t7 = t6*p[19]; /* b*m*I3 */
    const double t8 = JLT_FMA(t3, p[18], p[17]); /* s^2*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(t6, t7, t8); /* Theta = b*b*m*I3 + s^2*m*R^2*I1 + I1*I3 */
    const double t10 = t5*t9; /* D*Theta */
    const double t11 = t3*t10; /* s^2*D*Theta */
    const double t12 = 1.0/t11; /* 1/(s^2*D*Theta) */
    const double t13 = t4*t10; /* s*D*Theta */
    const double t14 = t12*t13; /* 1/(s^2*D*Theta)*s*D*Theta */
    const double t15 = t0*t14; /* gamma3*omega_tau*1/(s^2*D*Theta)*s*D*Theta */
    const double t16 = -t15; /* -gamma3*omega_tau*1/(s^2*D*Theta)*s*D*Theta */
    out[0] = t16;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    const double t17 = x[3]*p[5]; /* omega3*I3 */
    const double t18 = t6*t17; /* b*omega3*I3 */
    const double t19 = p[6] + t18; /* G_level + b*omega3*I3 */
    const double t20 = t14*t19; /* 1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3) */
    const double t21 = t14*t20; /* 1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3) */
    const double t22 = t14*t21; /* 1/(s^2*D*Theta)*s*D*Theta*t21 */
    const double t23 = x[0]*t22; /* gamma3*1/(s^2*D*Theta)*s*D*Theta*t21 */
    const double t24 = p[7]*t23; /* 1/(R*I1)*gamma3*1/(s^2*D*Theta)*s*D*Theta*t21 */
    const double t25 = x[3]*p[12]; /* omega3*I3/I1 */
    const double t26 = JLT_FMA(t14, t25, t24); /* d(omega_n)/d(gamma3) = 1/(s^2*D*Theta)*s*D*Theta*omega3*I3/I1 + 1/(R*I1)*gamma3*1/(s^2*D*Theta)*s*D*Theta*t21 */
    const double t27 = p[1]*x[3]; /* R*omega3 */
    const double t28 = t26*t27; /* d(omega_n)/d(gamma3)*R*omega3 */
    const double t29 = t26*p[21]; /* d(omega_n)/d(gamma3)*2*R*I1 */
    const double t30 = t23 + t29; /* gamma3*1/(s^2*D*Theta)*s*D*Theta*t21 + d(omega_n)/d(gamma3)*2*R*I1 */
    const double t31 = t6*t30; /* b*t30 */
    const double t32 = JLT_FMA(p[1], t20, t31); /* R*1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3) + b*t30 */
    const double t33 = t21*p[20]; /* t21*1/(R^2*I1^2) */
    const double t34 = JLT_FMA(t32, t33, t28); /* (R*1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3) + b*t30)*t21*1/(R^2*I1^2) + d(omega_n)/d(gamma3)*R*omega3 */
    out[4] = t34;
    const double t35 = JLT_FMA(t14, t18, t20); /* 1/(s^2*D*Theta)*s*D*Theta*b*omega3*I3 + 1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3) */
    const double t36 = p[22]*t35; /* 1/I1*t35 */
    const double t37 = t6*t22; /* b*1/(s^2*D*Theta)*s*D*Theta*t21 */
    const double t38 = t6*p[23]; /* b*2*I3/(R^2*I1^2) */
    const double t39 = JLT_FMA(t37, t38, t36); /* b*1/(s^2*D*Theta)*s*D*Theta*t21*b*2*I3/(R^2*I1^2) + 1/I1*t35 */
    out[7] = t39;
    const double t40 = t3*t12; /* 1/(D*Theta) = s^2*1/(s^2*D*Theta) */
    const double t41 = t9*t40; /* 1/D = Theta*1/(D*Theta) */
    const double t42 = x[0]*t41; /* gamma3*1/D */
    const double t43 = t20*p[24]; /* 1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3)*2*m*a3^2/(R*I1) */
    const double t44 = JLT_FMA(t42, t43, t26); /* gamma3*1/D*t43 + d(omega_n)/d(gamma3) */
    const double t45 = x[2]*t4; /* omega_tau*s */
    const double t46 = x[2]*p[16]; /* omega_tau*m*a3^2 */
    const double t47 = t45*t46; /* omega_tau*s*omega_tau*m*a3^2 */
    const double t48 = t42*p[25]; /* gamma3*1/D*2*m*a3^2 */
    const double t49 = JLT_FNMA(t0, t46, p[26]); /* m*g*a3 - gamma3*omega_tau*omega_tau*m*a3^2 */
    const double t50 = t4*t49; /* s*(m*g*a3 - gamma3*omega_tau*omega_tau*m*a3^2) */
    const double t51 = JLT_FMA(t20, t48, t29); /* 1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3)*gamma3*1/D*2*m*a3^2 + d(omega_n)/d(gamma3)*2*R*I1 */
    const double t52 = JLT_FMA(x[0], t51, t22); /* gamma3*t51 + 1/(s^2*D*Theta)*s*D*Theta*t21 */
    const double t53 = t21*p[27]; /* t21*1/(R^2*I1) */
    const double t54 = JLT_FMS(t48, t50, t47); /* gamma3*1/D*2*m*a3^2*s*(m*g*a3 - gamma3*omega_tau*omega_tau*m*a3^2) - omega_tau*s*omega_tau*m*a3^2 */
    const double t55 = JLT_FMA(t17, t44, t54); /* omega3*I3*(gamma3*1/D*t43 + d(omega_n)/d(gamma3)) + t54 */
    const double t56 = JLT_FMA(t52, t53, t55); /* (gamma3*t51 + 1/(s^2*D*Theta)*s*D*Theta*t21)*t21*1/(R^2*I1) + omega3*I3*(gamma3*1/D*t43 + d(omega_n)/d(gamma3)) + t54 */
    const double t57 = t41*t56; /* 1/D*t56 */
    const double t58 = t14*t49; /* 1/(s^2*D*Theta)*s*D*Theta*(m*g*a3 - gamma3*omega_tau*omega_tau*m*a3^2) */
    const double t59 = JLT_FMS(t42, t58, t57); /* gamma3*1/D*t58 - 1/D*t56 */
    out[8] = t59;
    const double t60 = t45*t48; /* omega_tau*s*gamma3*1/D*2*m*a3^2 */
    out[10] = t60;
    const double t61 = t41*p[28]; /* 1/D*(-I3/(R*I1)) */
    const double t62 = t35*t61; /* t35*1/D*(-I3/(R*I1)) */
    const double t63 = t42*p[29]; /* gamma3*1/D*(-2*I3/(R^2*I1)) */
    const double t64 = JLT_FMA(t37, t63, t62); /* b*1/(s^2*D*Theta)*s*D*Theta*t21*gamma3*1/D*(-2*I3/(R^2*I1)) + t35*1/D*(-I3/(R*I1)) */
    out[11] = t64;
    const double t65 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t66 = JLT_FMA(x[2], t65, x[1]); /* V = omega_tau*e + v_nu */
    const double t67 = t5*t40; /* 1/Theta = D*1/(D*Theta) */
    const double t68 = t66*t67; /* V*1/Theta */
    const double t69 = p[30]*t68; /* m*R*I1*V*1/Theta */
    const double t70 = x[2]*p[3]; /* omega_tau*a3 */
    const double t71 = x[0]*p[31]; /* gamma3*2*m*R^2*I1 */
    const double t72 = JLT_FMS(t6, p[32], t71); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t73 = JLT_FNMA(t68, t72, t70); /* omega_tau*a3 - V*1/Theta*d(Theta)/d(gamma3) */
    const double t74 = t20*p[0]; /* 1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3)*m */
    const double t75 = t67*t74; /* 1/Theta*1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3)*m */
    const double t76 = t73*t75; /* (omega_tau*a3 - V*1/Theta*d(Theta)/d(gamma3))*1/Theta*1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3)*m */
    const double t77 = x[3]*t67; /* omega3*1/Theta */
    const double t78 = t45*p[33]; /* omega_tau*s*m*R^2*(I1 - I3) */
    const double t79 = JLT_FNMA(x[0], p[33], p[34]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t80 = t45*t79; /* omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t81 = t67*t80; /* 1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t82 = JLT_FMA(t15, t79, t78); /* gamma3*omega_tau*1/(s^2*D*Theta)*s*D*Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + omega_tau*s*m*R^2*(I1 - I3) */
    const double t83 = JLT_FMA(t72, t81, t82); /* d(Theta)/d(gamma3)*1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + t82 */
    const double t84 = JLT_FMS(t77, t83, t76); /* omega3*1/Theta*t83 - t76 */
    const double t85 = JLT_FNMA(t26, t69, t84); /* omega3*1/Theta*t83 - t76 - d(omega_n)/d(gamma3)*m*R*I1*V*1/Theta */
    out[12] = t85;
    const double t86 = -t75; /* -1/Theta*1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3)*m */
    out[13] = t86;
    const double t87 = t4*t79; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t88 = t77*t87; /* omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t89 = JLT_FMA(t65, t75, t88); /* e*1/Theta*1/(s^2*D*Theta)*s*D*Theta*(G_level + b*omega3*I3)*m + omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t90 = -t89; /* -t89 */
    out[14] = t90;
    const double t91 = t7*t14; /* b*m*I3*1/(s^2*D*Theta)*s*D*Theta */
    const double t92 = JLT_FMA(t68, t91, t81); /* V*1/Theta*b*m*I3*1/(s^2*D*Theta)*s*D*Theta + 1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t93 = -t92; /* -t92 */
    out[15] = t93;
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
    const double t3 = x[0] + p[35]; /* b/R = gamma3 + a3/R */
    const double t4 = p[37]*t3; /* m*R^2*I3*b/R */
    const double t5 = JLT_FMA(p[18], t2, p[17]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b/R*m*R^2*I3*b/R + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
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
    const double t17 = p[36]*x[3]; /* R*I3*omega3 */
    const double t18 = JLT_FMA(t3, t17, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t19 = t13*t18; /* 1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t20 = x[2]*p[16]; /* omega_tau*m*a3^2 */
    const double t21 = JLT_FNMA(x[0], p[33], p[34]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t22 = x[0]*t20; /* gamma3*omega_tau*m*a3^2 */
    const double t23 = x[3]*t21; /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t24 = x[0]*t13; /* gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t25 = x[2]*t11; /* omega_tau*s */
    out[0] = t25;
    const double t26 = t13*t19; /* 1/(s^2*Theta*D)*Theta*D*s*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t27 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t28 = JLT_FNMA(x[2], t22, p[26]); /* m*g*a3 - omega_tau*gamma3*omega_tau*m*a3^2 */
    const double t29 = t22*t25; /* gamma3*omega_tau*m*a3^2*omega_tau*s */
    const double t30 = t24*t28; /* gamma3*1/(s^2*Theta*D)*Theta*D*s*(m*g*a3 - omega_tau*gamma3*omega_tau*m*a3^2) */
    const double t31 = JLT_FMA(t20, t25, t30); /* omega_tau*m*a3^2*omega_tau*s + t30 */
    const double t32 = JLT_FNMA(p[26], t11, t29); /* gamma3*omega_tau*m*a3^2*omega_tau*s - m*g*a3*s */
    const double t33 = t23*t24; /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t34 = JLT_FNMA(p[47], t19, t33); /* t33 - m*a3*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t35 = x[2]*t34; /* omega_tau*t34 */
    const double t36 = x[0]*t26; /* gamma3*t26 */
    const double t37 = t17 + t36; /* R*I3*omega3 + gamma3*t26 */
    const double t38 = JLT_FMA(x[3], p[43], t36); /* omega3*1/2*R*I3 + gamma3*t26 */
    const double t39 = p[42]*t38; /* 2/(R^2*I1)*(omega3*1/2*R*I3 + gamma3*t26) */
    const double t40 = JLT_FMA(x[2], t27, x[1]); /* V = omega_tau*e + v_nu */
    const double t41 = p[0]*t19; /* m*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t42 = t27*t41; /* e*m*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t43 = JLT_FMA(t11, t23, t42); /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*m*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t44 = t16*t43; /* 1/Theta*t43 */
    const double t45 = -t44; /* -1/Theta*t43 */
    out[18] = t45;
    const double t46 = t3*t13; /* b/R*1/(s^2*Theta*D)*Theta*D*s */
    const double t47 = p[27]*t13; /* 1/(R^2*I1)*1/(s^2*Theta*D)*Theta*D*s */
    const double t48 = t26*t47; /* t26*1/(R^2*I1)*1/(s^2*Theta*D)*Theta*D*s */
    const double t49 = JLT_FNMA(t26, t48, t31); /* omega_tau*m*a3^2*omega_tau*s + t30 - t26*t26*1/(R^2*I1)*1/(s^2*Theta*D)*Theta*D*s */
    const double t50 = t13*t37; /* d(omega_n)/d(gamma3)/(1/(R*I1)) = 1/(s^2*Theta*D)*Theta*D*s*(R*I3*omega3 + gamma3*t26) */
    const double t51 = JLT_FNMA(t39, t50, t49); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t49 - 2/(R^2*I1)*(omega3*1/2*R*I3 + gamma3*t26)*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    const double t52 = t3*t26; /* b/R*t26 */
    const double t53 = p[38]*t26; /* 1/(R*I1^2)*t26 */
    const double t54 = p[27]*t19; /* 1/(R^2*I1)*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t55 = JLT_FNMA(t37, t54, t32); /* numerator of d(omega_tau)/dt over D = gamma3*omega_tau*m*a3^2*omega_tau*s - m*g*a3*s - (R*I3*omega3 + gamma3*t26)*t54 */
    const double t56 = t15*t55; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t56;
    const double t57 = t40*t41; /* V*m*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t58 = JLT_FMA(t23, t25, t57); /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*s + V*m*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t59 = t16*t58; /* 1/Theta*t58 */
    const double t60 = t16*t41; /* 1/Theta*m*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t61 = -t60; /* -t60 */
    out[17] = t61;
    const double t62 = -t59; /* -1/Theta*t58 */
    out[3] = t62;
    const double t63 = x[3]*t46; /* omega3*b/R*1/(s^2*Theta*D)*Theta*D*s */
    const double t64 = p[44]*t19; /* I3/(R*I1)*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t65 = JLT_FMA(p[46], t63, t64); /* I3^2/I1*omega3*b/R*1/(s^2*Theta*D)*Theta*D*s + t64 */
    const double t66 = x[3]*p[33]; /* omega3*m*R^2*(I1 - I3) */
    const double t67 = JLT_FMA(t25, t66, t35); /* omega_tau*s*omega3*m*R^2*(I1 - I3) + omega_tau*t34 */
    const double t68 = p[49]*t40; /* m*R*I3*V */
    const double t69 = p[0]*t40; /* m*V */
    const double t70 = JLT_FNMA(t50, t69, t67); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = omega_tau*s*omega3*m*R^2*(I1 - I3) + omega_tau*t34 - d(omega_n)/d(gamma3)/(1/(R*I1))*m*V */
    const double t71 = t46*t68; /* b/R*1/(s^2*Theta*D)*Theta*D*s*m*R*I3*V */
    const double t72 = JLT_FMA(t21, t25, t71); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*s + b/R*1/(s^2*Theta*D)*Theta*D*s*m*R*I3*V */
    const double t73 = p[22]*t50; /* 1/I1*d(omega_n)/d(gamma3)/(1/(R*I1)) */
    const double t74 = p[40]*t46; /* 2*I3/I1^2*b/R*1/(s^2*Theta*D)*Theta*D*s */
    const double t75 = t16*t72; /* 1/Theta*t72 */
    const double t76 = -t75; /* -1/Theta*t72 */
    out[19] = t76;
    const double t77 = t24*t52; /* gamma3*1/(s^2*Theta*D)*Theta*D*s*b/R*t26 */
    const double t78 = JLT_FMA(p[45], t77, t65); /* 2*I3/(R*I1)*gamma3*1/(s^2*Theta*D)*Theta*D*s*b/R*t26 + I3^2/I1*omega3*b/R*1/(s^2*Theta*D)*Theta*D*s + t64 */
    const double t79 = t19 + t77; /* 1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) + gamma3*1/(s^2*Theta*D)*Theta*D*s*b/R*t26 */
    const double t80 = t53*t79; /* 1/(R*I1^2)*t26*t79 */
    const double t81 = p[22]*t19; /* 1/I1*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t82 = x[2]*t24; /* omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t83 = -t82; /* -omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    out[4] = t83;
    const double t84 = JLT_FMA(p[41], t63, t81); /* R*I3/I1*omega3*b/R*1/(s^2*Theta*D)*Theta*D*s + 1/I1*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level) */
    const double t85 = JLT_FMA(t52, t74, t84); /* b/R*t26*2*I3/I1^2*b/R*1/(s^2*Theta*D)*Theta*D*s + t84 */
    out[11] = t85;
    const double t86 = t15*t78; /* 1/D*t78 */
    const double t87 = -t86; /* -1/D*t78 */
    out[15] = t87;
    const double t88 = x[0]*p[31]; /* gamma3*2*m*R^2*I1 */
    const double t89 = JLT_FMS(p[48], t3, t88); /* d(Theta)/d(gamma3) = 2*m*R^2*I3*b/R - gamma3*2*m*R^2*I1 */
    const double t90 = JLT_FMA(t59, t89, t70); /* 1/Theta*t58*d(Theta)/d(gamma3) + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t91 = t16*t90; /* 1/Theta*t90 */
    out[16] = t91;
    const double t92 = x[0]*p[25]; /* gamma3*2*m*a3^2 */
    const double t93 = JLT_FMA(t56, t92, t51); /* 1/D*numerator of d(omega_tau)/dt over D*gamma3*2*m*a3^2 + d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    const double t94 = t25*t92; /* omega_tau*s*gamma3*2*m*a3^2 */
    const double t95 = t15*t93; /* 1/D*t93 */
    out[12] = t95;
    const double t96 = t15*t94; /* 1/D*omega_tau*s*gamma3*2*m*a3^2 */
    out[14] = t96;
    const double t97 = JLT_FMA(p[7], t52, x[3]); /* 1/(R*I1)*b/R*t26 + omega3 */
    const double t98 = t81*t97; /* 1/I1*1/(s^2*Theta*D)*Theta*D*s*(b/R*R*I3*omega3 + G_level)*(1/(R*I1)*b/R*t26 + omega3) */
    out[1] = t98;
    const double t99 = JLT_FMA(p[39], t52, x[3]); /* 2/(R*I1)*b/R*t26 + omega3 */
    const double t100 = JLT_FMA(t73, t99, t80); /* 1/I1*d(omega_n)/d(gamma3)/(1/(R*I1))*(2/(R*I1)*b/R*t26 + omega3) + 1/(R*I1^2)*t26*t79 */
    out[8] = t100;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[19]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[18], t2, p[17]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t6*t7; /* Theta*D */
    const double t9 = p[25]*t6; /* 2*m*a3^2*Theta */
    const double t10 = t2*t8; /* s^2*Theta*D */
    const double t11 = 1.0/t10; /* 1/(s^2*Theta*D) */
    const double t12 = t8*t11; /* 1/s^2 = Theta*D*1/(s^2*Theta*D) */
    const double t13 = t2*t11; /* 1/(D*Theta) = s^2*1/(s^2*Theta*D) */
    const double t14 = sqrt(t2); /* s = sqrt(s^2) */
    const double t15 = JLT_FMS(t9, t13, t12); /* 2*m*a3^2*Theta*1/(D*Theta) - 1/s^2 */
    const double t16 = t7*t14; /* D*s */
    const double t17 = t14*t15; /* s*(2*m*a3^2*Theta*1/(D*Theta) - 1/s^2) */
    const double t18 = t13*t16; /* 1/(D*Theta)*D*s */
    const double t19 = JLT_FMA(p[33], t18, t17); /* m*R^2*(I1 - I3)*1/(D*Theta)*D*s + s*(2*m*a3^2*Theta*1/(D*Theta) - 1/s^2) */
    const double t20 = x[0]*t19; /* gamma3*t19 */
    const double t21 = JLT_FNMA(p[34], t18, t20); /* gamma3*t19 - m*R*a3*I3*1/(D*Theta)*D*s */
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
    const double t3 = x[0] + p[35]; /* b/R = gamma3 + a3/R */
    const double t4 = p[36]*x[3]; /* R*I3*omega3 */
    const double t5 = JLT_FMA(t3, t4, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t6 = t5/t2; /* (b/R*R*I3*omega3 + G_level)/s^2 */
    const double t7 = p[22]*t3; /* 1/I1*b/R */
    const double t8 = p[51]*x[0]; /* 2*g*a3*gamma3 */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t10 = p[52]*x[2]; /* 1/m*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/m*omega_tau */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    const double t13 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t14 = t6*t12; /* (b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t15 = t7*t14; /* 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t16 = x[3]*p[54]; /* omega3*I3/m */
    const double t17 = JLT_FMA(x[3], t16, t9); /* omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = JLT_FMA(t11, t13, t17); /* omega_tau*1/m*omega_tau*D + omega3*omega3*I3/m + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t19 = p[53]*t14; /* 1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t20 = JLT_FMA(t14, t19, t18); /* (b/R*R*I3*omega3 + G_level)/s^2*s*1/(m*R^2*I1)*(b/R*R*I3*omega3 + G_level)/s^2*s + t18 */
    const double t21 = x[3]*p[1]; /* omega3*R */
    const double t22 = JLT_FMA(t12, t21, t15); /* v_tau = s*omega3*R + 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t23 = JLT_FMA(t22, t22, t20); /* energy/(1/2*m) = v_tau*v_tau + t20 */
    const double t24 = p[50]*t23; /* 1/2*m*energy/(1/2*m) */
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
    const double t5 = JLT_FMA(p[16], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*t5; /* omega_tau*D */
    out[2] = t6;
    const double t7 = x[0] + p[35]; /* b/R = gamma3 + a3/R */
    const double t8 = x[3]*p[36]; /* omega3*R*I3 */
    const double t9 = JLT_FMA(t7, t8, p[6]); /* b/R*omega3*R*I3 + G_level */
    const double t10 = 1.0/t4; /* 1/s */
    const double t11 = t9*t10; /* (b/R*omega3*R*I3 + G_level)*1/s */
    const double t12 = p[12]*x[3]; /* I3/I1*omega3 */
    const double t13 = p[7]*t11; /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t14 = p[55]*t11; /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t15 = x[0]*t10; /* gamma3*1/s */
    const double t16 = JLT_FMA(t13, t15, t12); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*gamma3*1/s + I3/I1*omega3 */
    const double t17 = t10*t16; /* d(omega_n)/d(gamma3) = 1/s*t16 */
    const double t18 = t7*t10; /* b/R*1/s */
    const double t19 = JLT_FNMA(x[3], t15, t13); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t20 = JLT_FMA(t7, t17, t19); /* d(v_tau)/d(gamma3)/R = b/R*d(omega_n)/d(gamma3) + 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s - omega3*gamma3*1/s */
    const double t21 = p[16]*x[0]; /* m*a3^2*gamma3 */
    const double t22 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t23 = JLT_FNMA(t21, t22, p[26]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t24 = JLT_FMA(t14, t17, t23); /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s*d(omega_n)/d(gamma3) + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t25 = t7*t13; /* b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t26 = JLT_FMA(x[3], t4, t25); /* v_tau/R = omega3*s + b/R*1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t27 = JLT_FMA(t13, t18, x[3]); /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s*b/R*1/s + omega3 */
    const double t28 = p[12]*t7; /* I3/I1*b/R */
    const double t29 = JLT_FMA(t18, t28, t4); /* d(v_tau)/d(omega3)/R = b/R*1/s*I3/I1*b/R + s */
    const double t30 = p[56]*t26; /* m*R^2*v_tau/R */
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
    const double t4 = x[0] + p[35]; /* b/R = gamma3 + a3/R */
    const double t5 = p[36]*x[3]; /* R*I3*omega3 */
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
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t18[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t19[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t22[k] = jlt_jet_root(t20[k], t22, k);
        t23[k] = p[8]*t20[k] + (k == 0 ? 1.0 : 0);
        t24[k] = (k == 0 ? p[9] : 0) + t20[k];
        t25[k] = p[10]*t21[k];
        t26[k] = jlt_jet_product(t21, t25, k) + t24[k];
        t27[k] = jlt_jet_product(t22, t23, k);
        t28[k] = jlt_jet_product(t26, t27, k);
        t29[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t28, t29, k);
        t30[k] = jlt_jet_product(t26, t29, k);
        t31[k] = jlt_jet_product(t23, t30, k);
        t32[k] = p[13]*t27[k];
        t33[k] = jlt_jet_product(t29, t32, k);
        t34[k] = jlt_jet_product(t22, t30, k);
        t35[k] = p[5]*x3[k];
        t36[k] = jlt_jet_product(t21, t35, k) + (k == 0 ? p[6] : 0);
        t37[k] = p[7]*t36[k];
        t38[k] = jlt_jet_product(t31, t37, k);
        t39[k] = jlt_jet_product(t31, t38, k);
        t40[k] = jlt_jet_product(t38, t39, k);
        t41[k] = jlt_jet_product(t21, t40, k);
        t42[k] = jlt_jet_product(x2, t22, k);
        t43[k] = x2[k]*p[8];
        t44[k] = jlt_jet_product(t42, t43, k) - t40[k];
        t45[k] = jlt_jet_product(x0, t44, k);
        t46[k] = t45[k] - p[11]*t22[k];
        t47[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t48[k] = jlt_jet_product(x2, t47, k) + x1[k];
        t49[k] = jlt_jet_product(t38, t48, k);
        t50[k] = jlt_jet_product(x3, t38, k);
        t51[k] = p[1]*t50[k] + t41[k];
        t52[k] = t46[k] - p[12]*t50[k];
        t53[k] = jlt_jet_product(t34, t52, k);
        t54[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t55[k] = jlt_jet_product(x3, t54, k);
        t56[k] = jlt_jet_product(t42, t55, k) + t49[k];
        t57[k] = jlt_jet_product(t33, t56, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t42[k]/(k + 1);
        next[1] = x1[k + 1] = t51[k]/(k + 1);
        next[2] = x2[k + 1] = t53[k]/(k + 1);
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

const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "level_G",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 57,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 24, 12, 1, 1, 0, 16, 9 }, { 15, 58, 0, 9, 1, 0, 10, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, b*I3*omega3 + G_level, a part of d(omega_tau)/dt, e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(v_nu)/dt, a part of d(omega_tau)/dt, a3*I3/I1 - gamma3*(R*(I1 - I3)/I1), omega_tau*s*omega3*(a3*I3/I1 - gamma3*(R*(I1 - I3)/I1)) + omega_n*V" },
    .jacobian = { jacobian, 16, { 8, 55, 29, 1, 1, 0, 20, 24 }, { 47, 240, 0, 39, 1, 0, 18, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level + b*omega3*I3, d(omega_n)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3), d(d(v_nu)/dt)/d(omega3), a part of d(d(omega_tau)/dt)/d(gamma3), m*g*a3 - gamma3*omega_tau*omega_tau*(m*a3^2), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega3), e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(Theta)/d(gamma3) = b*(2*m*R*I3) - gamma3*(2*m*R^2*I1), omega_tau*a3 - V*1/Theta*d(Theta)/d(gamma3), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau), a part of d(d(omega3)/dt)/d(omega3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 11, 58, 30, 1, 1, 0, 16, 20 }, { 54, 277, 0, 47, 1, 0, 18, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*(R*I3)*omega3 + G_level, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), e = gamma3*a3 + R, m*g*a3 - omega_tau*gamma3*omega_tau*(m*a3^2), a part of d(d(omega3)/dt)/d(gamma3), a part of d(omega_tau)/dt and of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(omega3)/dt)/d(omega_tau), d(numerator of d(omega_tau)/dt over D)/d(gamma3), numerator of d(omega_tau)/dt over D, a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(gamma3), a part of d(d(omega3)/dt)/d(omega3), a part of d(d(omega_tau)/dt)/d(omega3), a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega3), d(Theta)/d(gamma3) = (2*m*R^2*I3)*b/R - gamma3*(2*m*R^2*I1), a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(v_nu)/dt, a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3)" },
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
