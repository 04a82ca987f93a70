/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G: omega_n from G = G_level
 *  Table:      spherical_top, SHA-256 1b6d453374f697d58e1412b96ff746b2599a2a450f7166c0e5909287ba92fdcb
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   24   12    1    1    0     16    9   (83)
 *  jacobian            6   58   30    1    1    0     18   22   (327)
 *  rhs_jacobian        6   59   32    1    1    0     18   24   (379)
 *  divergence          2   14   10    1    1    0     14    8   (57)
 *  integral_values     3   12    8    1    1    0      8    8   (43)
 *  integral_gradients  3   17   12    1    1    0     10   11   (72)
 *  eliminated          3    3    1    1    1    0      4    4   (11)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level + b*I3*omega3,
 *      a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3),
 *      1/Theta*gamma3*(m*R^2*(I1 - I3)) - (m*R*a3*I3)*1/Theta,
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), e = gamma3*a3 + R,
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu,
 *      d(d(omega3)/dt)/d(omega3), d(omega3)/dt, d(d(omega3)/dt)/d(omega_tau),
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3),
 *      d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), a part of d(d(omega3)/dt)/d(gamma3),
 *      d(d(omega3)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(v_nu)/dt)/d(gamma3), d(v_nu)/dt, a part of d(d(omega_tau)/dt)/d(gamma3), d(omega_tau)/dt,
 *      a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega3),
 *      d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega3)
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
    out[53] = t6;
    const double t7 = params[5]/t6; /* I3/(m*R*R) */
    out[9] = t7;
    const double t8 = params[4]*t5; /* I1*R*R */
    const double t9 = params[5]/t8; /* I3/(I1*R*R) */
    out[10] = t9;
    const double t10 = params[0]*params[2]; /* m*g */
    const double t11 = params[3]*t10; /* a3*m*g */
    out[25] = t11;
    const double t12 = t11/params[4]; /* a3*m*g/I1 */
    out[11] = t12;
    const double t13 = params[5]/params[4]; /* I3/I1 */
    out[12] = t13;
    const double t14 = (-1.0)/params[1]; /* (-1)/R */
    out[13] = t14;
    const double t15 = params[3]*params[5]; /* a3*I3 */
    out[34] = t15;
    const double t16 = t15/params[4]; /* a3*I3/I1 */
    out[14] = t16;
    const double t17 = params[4] - params[5]; /* I1 - I3 */
    const double t18 = params[1]*t17; /* R*(I1 - I3) */
    out[31] = t18;
    const double t19 = t18/params[4]; /* R*(I1 - I3)/I1 */
    out[15] = t19;
    const double t20 = params[4]*params[5]; /* I1*I3 */
    out[17] = t20;
    const double t21 = params[4]*t6; /* I1*m*R*R */
    out[18] = t21;
    const double t22 = params[0]*params[5]; /* m*I3 */
    out[19] = t22;
    const double t23 = 1.0/params[4]; /* 1/I1 */
    out[20] = t23;
    const double t24 = 2.0/t8; /* 2/(I1*R*R) */
    out[21] = t24;
    const double t25 = params[5]*2.0; /* I3*2 */
    const double t26 = t25/t0; /* I3*2/(R*I1) */
    out[22] = t26;
    const double t27 = params[0]*2.0; /* m*2 */
    const double t28 = t2*t27; /* a3*a3*m*2 */
    out[23] = t28;
    const double t29 = t28/t0; /* a3*a3*m*2/(R*I1) */
    out[24] = t29;
    const double t30 = 1.0/t8; /* 1/(I1*R*R) */
    out[26] = t30;
    const double t31 = params[1]*2.0; /* R*2 */
    const double t32 = params[4]*t31; /* I1*R*2 */
    out[27] = t32;
    const double t33 = params[5]/t0; /* I3/(R*I1) */
    const double t34 = -t33; /* -I3/(R*I1) */
    out[28] = t34;
    const double t35 = params[5]*(-2.0); /* I3*(-2) */
    const double t36 = t35/params[1]; /* I3*(-2)/R */
    out[29] = t36;
    const double t37 = params[1]*params[0]; /* R*m */
    out[30] = t37;
    const double t38 = t5*t27; /* R*R*m*2 */
    const double t39 = params[4]*t38; /* I1*R*R*m*2 */
    out[32] = t39;
    const double t40 = params[1]*t27; /* R*m*2 */
    const double t41 = params[5]*t40; /* I3*R*m*2 */
    out[33] = t41;
    const double t42 = params[0]*params[3]; /* m*a3 */
    out[35] = t42;
    const double t43 = params[4]*t37; /* I1*R*m */
    out[36] = t43;
    const double t44 = -t22; /* -m*I3 */
    out[37] = t44;
    const double t45 = -t37; /* -R*m */
    out[38] = t45;
    const double t46 = params[4]*params[4]; /* I1*I1 */
    const double t47 = params[1]*t46; /* R*I1*I1 */
    const double t48 = params[5]/t47; /* I3/(R*I1*I1) */
    out[39] = t48;
    const double t49 = t6*t17; /* m*R*R*(I1 - I3) */
    out[40] = t49;
    const double t50 = params[3]*t37; /* a3*R*m */
    const double t51 = params[5]*t50; /* I3*a3*R*m */
    out[41] = t51;
    const double t52 = params[4]*t28; /* I1*a3*a3*m*2 */
    out[42] = t52;
    const double t53 = params[4]*2.0; /* I1*2 */
    out[43] = t53;
    const double t54 = t11/t53; /* a3*m*g/(I1*2) */
    out[44] = t54;
    const double t55 = params[0]/2.0; /* m/2 */
    out[45] = t55;
    const double t56 = params[2]*2.0; /* g*2 */
    const double t57 = params[3]*t56; /* a3*g*2 */
    out[46] = t57;
    const double t58 = 1.0/params[0]; /* 1/m */
    out[47] = t58;
    const double t59 = 1.0/t21; /* 1/(I1*m*R*R) */
    out[48] = t59;
    const double t60 = params[1]*params[5]; /* R*I3 */
    out[49] = t60;
    const double t61 = params[3]/params[1]; /* a3/R */
    out[50] = t61;
    const double t62 = params[5]/params[0]; /* I3/m */
    out[51] = t62;
    const double t63 = 1.0/params[1]; /* 1/R */
    out[52] = t63;
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
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = JLT_FMA(t2, p[16], p[4]); /* D = s^2*m*a3^2 + I1 */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = p[19]*t5; /* m*I3*b */
    const double t7 = JLT_FMA(t2, p[18], p[17]); /* s^2*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta = b*m*I3*b + s^2*m*R^2*I1 + I1*I3 */
    const double t9 = t4*t8; /* D*Theta */
    const double t10 = t2*t9; /* s^2*D*Theta */
    const double t11 = 1.0/t10; /* 1/(s^2*D*Theta) */
    const double t12 = t3*t9; /* s*D*Theta */
    const double t13 = t11*t12; /* 1/(s^2*D*Theta)*s*D*Theta */
    const double t14 = x[0]*t13; /* gamma3*1/(s^2*D*Theta)*s*D*Theta */
    const double t15 = x[2]*t14; /* omega_tau*gamma3*1/(s^2*D*Theta)*s*D*Theta */
    const double t16 = -t15; /* -omega_tau*gamma3*1/(s^2*D*Theta)*s*D*Theta */
    out[0] = t16;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    const double t17 = p[5]*x[3]; /* I3*omega3 */
    const double t18 = JLT_FMA(t5, t17, p[6]); /* b*I3*omega3 + G_level */
    const double t19 = t13*t18; /* 1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level) */
    const double t20 = t13*t19; /* 1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level) */
    const double t21 = p[7]*t20; /* 1/(R*I1)*t20 */
    const double t22 = t5*t13; /* b*1/(s^2*D*Theta)*s*D*Theta */
    const double t23 = t21*t22; /* 1/(R*I1)*t20*b*1/(s^2*D*Theta)*s*D*Theta */
    const double t24 = x[0]*t23; /* gamma3*1/(R*I1)*t20*b*1/(s^2*D*Theta)*s*D*Theta */
    const double t25 = JLT_FMA(t19, p[20], t24); /* 1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level)*1/I1 + gamma3*1/(R*I1)*t20*b*1/(s^2*D*Theta)*s*D*Theta */
    const double t26 = t21*t25; /* 1/(R*I1)*t20*t25 */
    const double t27 = x[3]*p[12]; /* omega3*I3/I1 */
    const double t28 = t13*t27; /* 1/(s^2*D*Theta)*s*D*Theta*omega3*I3/I1 */
    const double t29 = JLT_FMA(t14, t21, t28); /* d(omega_n)/d(gamma3) = gamma3*1/(s^2*D*Theta)*s*D*Theta*1/(R*I1)*t20 + 1/(s^2*D*Theta)*s*D*Theta*omega3*I3/I1 */
    const double t30 = t5*p[21]; /* b*2/(R^2*I1) */
    const double t31 = JLT_FMA(t20, t30, x[3]); /* t20*b*2/(R^2*I1) + omega3 */
    const double t32 = p[1]*t31; /* R*(t20*b*2/(R^2*I1) + omega3) */
    const double t33 = JLT_FMA(t29, t32, t26); /* d(omega_n)/d(gamma3)*R*(t20*b*2/(R^2*I1) + omega3) + 1/(R*I1)*t20*t25 */
    out[4] = t33;
    const double t34 = JLT_FMA(t17, t22, t19); /* I3*omega3*b*1/(s^2*D*Theta)*s*D*Theta + 1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level) */
    const double t35 = p[20]*t34; /* 1/I1*t34 */
    const double t36 = t5*p[22]; /* b*2*I3/(R*I1) */
    const double t37 = JLT_FMA(t23, t36, t35); /* 1/(R*I1)*t20*b*1/(s^2*D*Theta)*s*D*Theta*b*2*I3/(R*I1) + 1/I1*t34 */
    out[7] = t37;
    const double t38 = t2*t11; /* 1/(D*Theta) = s^2*1/(s^2*D*Theta) */
    const double t39 = t8*t38; /* 1/D = Theta*1/(D*Theta) */
    const double t40 = x[0]*t39; /* gamma3*1/D */
    const double t41 = p[23]*t40; /* 2*m*a3^2*gamma3*1/D */
    const double t42 = t3*t41; /* s*2*m*a3^2*gamma3*1/D */
    const double t43 = t14 - t42; /* gamma3*1/(s^2*D*Theta)*s*D*Theta - s*2*m*a3^2*gamma3*1/D */
    const double t44 = JLT_FMS(x[0], t43, t3); /* gamma3*(gamma3*1/(s^2*D*Theta)*s*D*Theta - s*2*m*a3^2*gamma3*1/D) - s */
    const double t45 = x[2]*p[16]; /* omega_tau*m*a3^2 */
    const double t46 = x[2]*t45; /* omega_tau*omega_tau*m*a3^2 */
    const double t47 = t19*p[24]; /* 1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level)*2*m*a3^2/(R*I1) */
    const double t48 = JLT_FMA(t40, t47, t29); /* gamma3*1/D*t47 + d(omega_n)/d(gamma3) */
    const double t49 = t17*t48; /* I3*omega3*(gamma3*1/D*t47 + d(omega_n)/d(gamma3)) */
    const double t50 = JLT_FMS(t43, p[25], t49); /* (gamma3*1/(s^2*D*Theta)*s*D*Theta - s*2*m*a3^2*gamma3*1/D)*m*g*a3 - I3*omega3*(gamma3*1/D*t47 + d(omega_n)/d(gamma3)) */
    const double t51 = JLT_FNMA(t44, t46, t50); /* t50 - t44*omega_tau*omega_tau*m*a3^2 */
    const double t52 = t39*t51; /* 1/D*(t50 - t44*omega_tau*omega_tau*m*a3^2) */
    const double t53 = t13*t39; /* 1/(s^2*D*Theta)*s*D*Theta*1/D */
    const double t54 = t20*t53; /* t20*1/(s^2*D*Theta)*s*D*Theta*1/D */
    const double t55 = t29*p[27]; /* d(omega_n)/d(gamma3)*2*R*I1 */
    const double t56 = JLT_FMA(t19, t41, t55); /* 1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level)*2*m*a3^2*gamma3*1/D + d(omega_n)/d(gamma3)*2*R*I1 */
    const double t57 = JLT_FMA(t40, t56, t54); /* gamma3*1/D*t56 + t20*1/(s^2*D*Theta)*s*D*Theta*1/D */
    const double t58 = t20*p[26]; /* t20*1/(R^2*I1) */
    const double t59 = JLT_FNMA(t57, t58, t52); /* 1/D*(t50 - t44*omega_tau*omega_tau*m*a3^2) - (gamma3*1/D*t56 + t20*1/(s^2*D*Theta)*s*D*Theta*1/D)*t20*1/(R^2*I1) */
    out[8] = t59;
    const double t60 = x[2]*t42; /* omega_tau*s*2*m*a3^2*gamma3*1/D */
    out[10] = t60;
    const double t61 = t39*p[28]; /* 1/D*(-I3/(R*I1)) */
    const double t62 = t34*t61; /* t34*1/D*(-I3/(R*I1)) */
    const double t63 = t40*p[29]; /* gamma3*1/D*(-2*I3/R) */
    const double t64 = JLT_FMA(t23, t63, t62); /* 1/(R*I1)*t20*b*1/(s^2*D*Theta)*s*D*Theta*gamma3*1/D*(-2*I3/R) + t34*1/D*(-I3/(R*I1)) */
    out[11] = t64;
    const double t65 = x[3]*p[30]; /* omega3*m*R */
    const double t66 = t3*p[31]; /* s*R*(I1 - I3) */
    const double t67 = x[0]*p[32]; /* gamma3*2*m*R^2*I1 */
    const double t68 = JLT_FMS(t5, p[33], t67); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t69 = JLT_FNMA(x[0], p[31], p[34]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t70 = t4*t38; /* 1/Theta = D*1/(D*Theta) */
    const double t71 = t3*t69; /* s*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t72 = t70*t71; /* 1/Theta*s*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t73 = JLT_FMA(t14, t69, t66); /* gamma3*1/(s^2*D*Theta)*s*D*Theta*(a3*I3 - gamma3*R*(I1 - I3)) + s*R*(I1 - I3) */
    const double t74 = JLT_FMA(t68, t72, t73); /* d(Theta)/d(gamma3)*1/Theta*s*(a3*I3 - gamma3*R*(I1 - I3)) + t73 */
    const double t75 = t65*t74; /* omega3*m*R*t74 */
    const double t76 = JLT_FNMA(t19, p[35], t75); /* omega3*m*R*t74 - 1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level)*m*a3 */
    const double t77 = x[2]*t70; /* omega_tau*1/Theta */
    const double t78 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t79 = JLT_FMA(x[2], t78, x[1]); /* V = omega_tau*e + v_nu */
    const double t80 = t70*t79; /* 1/Theta*V */
    const double t81 = t19*p[0]; /* 1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level)*m */
    const double t82 = t70*t81; /* 1/Theta*1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level)*m */
    const double t83 = t68*t80; /* d(Theta)/d(gamma3)*1/Theta*V */
    const double t84 = t82*t83; /* 1/Theta*1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level)*m*d(Theta)/d(gamma3)*1/Theta*V */
    const double t85 = t80*p[36]; /* 1/Theta*V*m*R*I1 */
    const double t86 = JLT_FNMA(t29, t85, t84); /* t84 - d(omega_n)/d(gamma3)*1/Theta*V*m*R*I1 */
    const double t87 = JLT_FMA(t76, t77, t86); /* t76*omega_tau*1/Theta + t84 - d(omega_n)/d(gamma3)*1/Theta*V*m*R*I1 */
    out[12] = t87;
    const double t88 = -t82; /* -1/Theta*1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level)*m */
    out[13] = t88;
    const double t89 = t65*t72; /* omega3*m*R*1/Theta*s*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t90 = JLT_FMA(t78, t82, t89); /* e*1/Theta*1/(s^2*D*Theta)*s*D*Theta*(b*I3*omega3 + G_level)*m + omega3*m*R*1/Theta*s*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t91 = -t90; /* -t90 */
    out[14] = t91;
    const double t92 = t22*p[37]; /* b*1/(s^2*D*Theta)*s*D*Theta*(-m*I3) */
    const double t93 = t80*t92; /* 1/Theta*V*b*1/(s^2*D*Theta)*s*D*Theta*(-m*I3) */
    const double t94 = x[2]*p[38]; /* omega_tau*(-m*R) */
    const double t95 = JLT_FMA(t72, t94, t93); /* 1/Theta*s*(a3*I3 - gamma3*R*(I1 - I3))*omega_tau*(-m*R) + 1/Theta*V*b*1/(s^2*D*Theta)*s*D*Theta*(-m*I3) */
    out[15] = t95;
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
    const double t4 = p[19]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[18], t2, p[17]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t6*t7; /* Theta*D */
    const double t9 = t2*t8; /* s^2*Theta*D */
    const double t10 = 1.0/t9; /* 1/(s^2*Theta*D) */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t11;
    const double t12 = t8*t11; /* Theta*D*s */
    const double t13 = t10*t12; /* 1/(s^2*Theta*D)*Theta*D*s */
    const double t14 = t2*t10; /* 1/(D*Theta) = s^2*1/(s^2*Theta*D) */
    const double t15 = t7*t14; /* 1/Theta = D*1/(D*Theta) */
    const double t16 = t6*t14; /* 1/D = Theta*1/(D*Theta) */
    const double t17 = t4*t13; /* m*I3*b*1/(s^2*Theta*D)*Theta*D*s */
    const double t18 = p[5]*x[3]; /* I3*omega3 */
    const double t19 = t3*t18; /* b*I3*omega3 */
    const double t20 = p[6] + t19; /* G_level + b*I3*omega3 */
    const double t21 = t13*t20; /* 1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) */
    const double t22 = JLT_FMA(t13, t19, t21); /* 1/(s^2*Theta*D)*Theta*D*s*b*I3*omega3 + 1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) */
    const double t23 = x[0]*p[40]; /* gamma3*m*R^2*(I1 - I3) */
    const double t24 = t15*t23; /* 1/Theta*gamma3*m*R^2*(I1 - I3) */
    const double t25 = JLT_FNMA(p[41], t15, t24); /* 1/Theta*gamma3*m*R^2*(I1 - I3) - m*R*a3*I3*1/Theta */
    const double t26 = p[7]*t21; /* 1/(R*I1)*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) */
    const double t27 = t13*t26; /* 1/(s^2*Theta*D)*Theta*D*s*1/(R*I1)*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) */
    const double t28 = t26*t27; /* 1/(R*I1)*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3)*t27 */
    const double t29 = x[3]*t21; /* omega3*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) */
    const double t30 = p[11]*t11; /* m*g*a3/I1*s */
    const double t31 = JLT_FMA(p[39], t29, t30); /* I3/(R*I1^2)*omega3*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) + m*g*a3/I1*s */
    const double t32 = t16*t31; /* 1/D*t31 */
    const double t33 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t34 = x[2]*t11; /* omega_tau*s */
    out[0] = t34;
    const double t35 = x[0]*t16; /* gamma3*1/D */
    const double t36 = JLT_FMA(t28, t35, t32); /* t28*gamma3*1/D + 1/D*t31 */
    const double t37 = x[3]*t25; /* omega3*(1/Theta*gamma3*m*R^2*(I1 - I3) - m*R*a3*I3*1/Theta) */
    const double t38 = t11*t37; /* s*omega3*(1/Theta*gamma3*m*R^2*(I1 - I3) - m*R*a3*I3*1/Theta) */
    const double t39 = JLT_FMA(x[2], t33, x[1]); /* V = omega_tau*e + v_nu */
    const double t40 = t15*t39; /* 1/Theta*V */
    const double t41 = t17*t40; /* m*I3*b*1/(s^2*Theta*D)*Theta*D*s*1/Theta*V */
    const double t42 = JLT_FMS(t25, t34, t41); /* (1/Theta*gamma3*m*R^2*(I1 - I3) - m*R*a3*I3*1/Theta)*omega_tau*s - m*I3*b*1/(s^2*Theta*D)*Theta*D*s*1/Theta*V */
    out[19] = t42;
    const double t43 = x[0]*t27; /* gamma3*t27 */
    const double t44 = x[3]*p[40]; /* omega3*m*R^2*(I1 - I3) */
    const double t45 = t34*t44; /* omega_tau*s*omega3*m*R^2*(I1 - I3) */
    const double t46 = x[2]*p[16]; /* omega_tau*m*a3^2 */
    const double t47 = t34*t35; /* omega_tau*s*gamma3*1/D */
    const double t48 = t34*t37; /* omega_tau*s*omega3*(1/Theta*gamma3*m*R^2*(I1 - I3) - m*R*a3*I3*1/Theta) */
    const double t49 = t34*t46; /* omega_tau*s*omega_tau*m*a3^2 */
    const double t50 = p[0]*t21; /* m*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) */
    const double t51 = JLT_FNMA(t40, t50, t48); /* t48 - 1/Theta*V*m*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) */
    out[3] = t51;
    const double t52 = p[36]*t40; /* m*R*I1*1/Theta*V */
    const double t53 = t15*t50; /* 1/Theta*m*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) */
    const double t54 = JLT_FNMA(t33, t53, t38); /* t38 - e*1/Theta*m*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) */
    out[18] = t54;
    const double t55 = -t53; /* -1/Theta*m*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) */
    out[17] = t55;
    const double t56 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t57 = t13*t56; /* 1/(s^2*Theta*D)*Theta*D*s*omega_tau*gamma3 */
    const double t58 = -t57; /* -1/(s^2*Theta*D)*Theta*D*s*omega_tau*gamma3 */
    out[4] = t58;
    const double t59 = JLT_FMA(x[3], p[12], t43); /* omega3*I3/I1 + gamma3*t27 */
    const double t60 = t13*t59; /* d(omega_n)/d(gamma3) = 1/(s^2*Theta*D)*Theta*D*s*(omega3*I3/I1 + gamma3*t27) */
    const double t61 = x[2]*p[35]; /* omega_tau*m*a3 */
    const double t62 = JLT_FNMA(t21, t61, t45); /* omega_tau*s*omega3*m*R^2*(I1 - I3) - 1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3)*omega_tau*m*a3 */
    const double t63 = x[0]*p[32]; /* gamma3*2*m*R^2*I1 */
    const double t64 = JLT_FMS(p[33], t3, t63); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t65 = JLT_FNMA(t51, t64, t62); /* t62 - t51*d(Theta)/d(gamma3) */
    const double t66 = t15*t65; /* 1/Theta*(t62 - t51*d(Theta)/d(gamma3)) */
    const double t67 = JLT_FNMA(t37, t57, t66); /* 1/Theta*(t62 - t51*d(Theta)/d(gamma3)) - omega3*(1/Theta*gamma3*m*R^2*(I1 - I3) - m*R*a3*I3*1/Theta)*1/(s^2*Theta*D)*Theta*D*s*omega_tau*gamma3 */
    const double t68 = JLT_FNMA(t52, t60, t67); /* t67 - m*R*I1*1/Theta*V*d(omega_n)/d(gamma3) */
    out[16] = t68;
    const double t69 = t13*t27; /* 1/(s^2*Theta*D)*Theta*D*s*t27 */
    const double t70 = p[4]*t27; /* I1*t27 */
    const double t71 = JLT_FNMA(t69, t70, t49); /* omega_tau*s*omega_tau*m*a3^2 - 1/(s^2*Theta*D)*Theta*D*s*t27*I1*t27 */
    const double t72 = JLT_FNMA(t18, t60, t71); /* t71 - I3*omega3*d(omega_n)/d(gamma3) */
    const double t73 = t3*t69; /* b*1/(s^2*Theta*D)*Theta*D*s*t27 */
    const double t74 = t27*t60; /* t27*d(omega_n)/d(gamma3) */
    const double t75 = t43*t73; /* gamma3*t27*b*1/(s^2*Theta*D)*Theta*D*s*t27 */
    const double t76 = JLT_FMS(p[44], t13, t74); /* 1/2*m*g*a3/I1*1/(s^2*Theta*D)*Theta*D*s - t27*d(omega_n)/d(gamma3) */
    const double t77 = JLT_FMA(x[3], t60, t28); /* omega3*d(omega_n)/d(gamma3) + t28 */
    const double t78 = t3*t28; /* b*t28 */
    const double t79 = JLT_FMA(p[20], t29, t78); /* 1/I1*omega3*1/(s^2*Theta*D)*Theta*D*s*(G_level + b*I3*omega3) + b*t28 */
    out[1] = t79;
    const double t80 = t16*t72; /* 1/D*(t71 - I3*omega3*d(omega_n)/d(gamma3)) */
    const double t81 = p[28]*t16; /* (-I3/(R*I1))*1/D */
    const double t82 = t22*t81; /* t22*(-I3/(R*I1))*1/D */
    const double t83 = p[20]*t22; /* 1/I1*t22 */
    const double t84 = p[23]*t47; /* 2*m*a3^2*omega_tau*s*gamma3*1/D */
    out[14] = t84;
    const double t85 = t57 - t84; /* 1/(s^2*Theta*D)*Theta*D*s*omega_tau*gamma3 - 2*m*a3^2*omega_tau*s*gamma3*1/D */
    const double t86 = t46*t47; /* omega_tau*m*a3^2*omega_tau*s*gamma3*1/D */
    const double t87 = JLT_FNMA(p[4], t36, t86); /* omega_tau*m*a3^2*omega_tau*s*gamma3*1/D - I1*(t28*gamma3*1/D + 1/D*t31) */
    out[2] = t87;
    const double t88 = p[42]*t36; /* 2*m*a3^2*I1*(t28*gamma3*1/D + 1/D*t31) */
    const double t89 = JLT_FMA(t46, t85, t88); /* omega_tau*m*a3^2*t85 + 2*m*a3^2*I1*(t28*gamma3*1/D + 1/D*t31) */
    const double t90 = JLT_FNMA(p[43], t76, t89); /* t89 - 2*I1*t76 */
    const double t91 = JLT_FNMA(t35, t90, t80); /* 1/D*(t71 - I3*omega3*d(omega_n)/d(gamma3)) - gamma3*1/D*(t89 - 2*I1*t76) */
    out[12] = t91;
    const double t92 = p[29]*t35; /* (-2*I3/R)*gamma3*1/D */
    const double t93 = JLT_FMA(t73, t92, t82); /* b*1/(s^2*Theta*D)*Theta*D*s*t27*(-2*I3/R)*gamma3*1/D + t22*(-I3/(R*I1))*1/D */
    out[15] = t93;
    const double t94 = 2.0*t3; /* 2*b */
    const double t95 = JLT_FMA(t74, t94, t75); /* t27*d(omega_n)/d(gamma3)*2*b + gamma3*t27*b*1/(s^2*Theta*D)*Theta*D*s*t27 */
    const double t96 = JLT_FMA(p[1], t77, t95); /* R*(omega3*d(omega_n)/d(gamma3) + t28) + t95 */
    out[8] = t96;
    const double t97 = p[22]*t3; /* 2*I3/(R*I1)*b */
    const double t98 = JLT_FMA(t73, t97, t83); /* b*1/(s^2*Theta*D)*Theta*D*s*t27*2*I3/(R*I1)*b + 1/I1*t22 */
    out[11] = t98;
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
    const double t8 = t2*t7; /* s^2*D */
    const double t9 = t6*t8; /* Theta*s^2*D */
    const double t10 = 1.0/t9; /* 1/(Theta*s^2*D) */
    const double t11 = t6*t10; /* Theta*1/(Theta*s^2*D) */
    const double t12 = t7*t11; /* 1/s^2 = D*Theta*1/(Theta*s^2*D) */
    const double t13 = sqrt(t2); /* s = sqrt(s^2) */
    const double t14 = t8*t13; /* s^2*D*s */
    const double t15 = t10*t14; /* 1/(Theta*s^2*D)*s^2*D*s */
    const double t16 = p[23]*t2; /* 2*m*a3^2*s^2 */
    const double t17 = JLT_FMS(t11, t16, t12); /* Theta*1/(Theta*s^2*D)*2*m*a3^2*s^2 - 1/s^2 */
    const double t18 = p[40]*t15; /* m*R^2*(I1 - I3)*1/(Theta*s^2*D)*s^2*D*s */
    const double t19 = JLT_FMA(t13, t17, t18); /* s*(Theta*1/(Theta*s^2*D)*2*m*a3^2*s^2 - 1/s^2) + m*R^2*(I1 - I3)*1/(Theta*s^2*D)*s^2*D*s */
    const double t20 = x[0]*t19; /* gamma3*t19 */
    const double t21 = JLT_FNMA(p[41], t15, t20); /* gamma3*t19 - m*R*a3*I3*1/(Theta*s^2*D)*s^2*D*s */
    const double t22 = x[2]*t21; /* omega_tau*(gamma3*t19 - m*R*a3*I3*1/(Theta*s^2*D)*s^2*D*s) */
    const double t23 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t24 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t25 = t4*t24; /* m*I3*b*V */
    const double t26 = t15*t25; /* 1/(Theta*s^2*D)*s^2*D*s*m*I3*b*V */
    const double t27 = JLT_FNMA(t12, t26, t22); /* omega_tau*(gamma3*t19 - m*R*a3*I3*1/(Theta*s^2*D)*s^2*D*s) - 1/s^2*1/(Theta*s^2*D)*s^2*D*s*m*I3*b*V */
    out[0] = t27;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[50]; /* b/R = gamma3 + a3/R */
    const double t4 = p[49]*x[3]; /* R*I3*omega3 */
    const double t5 = JLT_FMA(t3, t4, p[6]); /* b/R*R*I3*omega3 + G_level */
    const double t6 = t5/t2; /* (b/R*R*I3*omega3 + G_level)/s^2 */
    const double t7 = p[20]*t3; /* 1/I1*b/R */
    const double t8 = p[46]*x[0]; /* 2*g*a3*gamma3 */
    const double t9 = JLT_FMA(x[1], x[1], t8); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t10 = p[47]*x[2]; /* 1/m*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/m*omega_tau */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    const double t13 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t14 = t6*t12; /* (b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t15 = t7*t14; /* 1/I1*b/R*(b/R*R*I3*omega3 + G_level)/s^2*s */
    const double t16 = x[3]*p[51]; /* omega3*I3/m */
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
    const double t5 = JLT_FMA(p[16], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*t5; /* omega_tau*D */
    out[2] = t6;
    const double t7 = x[0] + p[50]; /* b/R = gamma3 + a3/R */
    const double t8 = x[3]*p[49]; /* omega3*R*I3 */
    const double t9 = JLT_FMA(t7, t8, p[6]); /* b/R*omega3*R*I3 + G_level */
    const double t10 = 1.0/t4; /* 1/s */
    const double t11 = t9*t10; /* (b/R*omega3*R*I3 + G_level)*1/s */
    const double t12 = p[12]*t10; /* I3/I1*1/s */
    const double t13 = p[7]*t11; /* 1/(R*I1)*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t14 = p[52]*t11; /* 1/R*(b/R*omega3*R*I3 + G_level)*1/s */
    const double t15 = x[0]*t10; /* gamma3*1/s */
    const double t16 = p[16]*x[0]; /* m*a3^2*gamma3 */
    const double t17 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t18 = JLT_FNMA(t16, t17, p[25]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
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
    const double t30 = p[53]*t27; /* m*R^2*v_tau/R */
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
    const double t4 = x[0] + p[50]; /* b/R = gamma3 + a3/R */
    const double t5 = p[49]*x[3]; /* R*I3*omega3 */
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
    .sha256 = "1b6d453374f697d58e1412b96ff746b2599a2a450f7166c0e5909287ba92fdcb",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 54,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 24, 12, 1, 1, 0, 16, 9 }, { 15, 58, 0, 9, 1, 0, 10, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, b*I3*omega3 + G_level, a part of d(omega_tau)/dt, e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(v_nu)/dt, a part of d(omega_tau)/dt, a3*I3/I1 - gamma3*(R*(I1 - I3)/I1), omega_tau*s*omega3*(a3*I3/I1 - gamma3*(R*(I1 - I3)/I1)) + omega_n*V" },
    .jacobian = { jacobian, 16, { 6, 58, 30, 1, 1, 0, 18, 22 }, { 47, 240, 0, 39, 1, 0, 18, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, b*I3*omega3 + G_level, a part of d(d(v_nu)/dt)/d(gamma3), d(omega_n)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3), d(d(v_nu)/dt)/d(omega3), gamma3*((1)/s^2*D*Theta)*s*D*Theta - s*(2*m*a3^2)*gamma3*1/D, a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega3), d(Theta)/d(gamma3) = b*(2*m*R*I3) - gamma3*(2*m*R^2*I1), a3*I3 - gamma3*(R*(I1 - I3)), a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau), d(d(omega3)/dt)/d(omega3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 6, 59, 32, 1, 1, 0, 18, 24 }, { 54, 277, 0, 47, 1, 0, 18, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level + b*I3*omega3, a part of d(d(v_nu)/dt)/d(omega3) and of d(d(omega_tau)/dt)/d(omega3), 1/Theta*gamma3*(m*R^2*(I1 - I3)) - (m*R*a3*I3)*1/Theta, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), e = gamma3*a3 + R, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, d(d(omega3)/dt)/d(omega3), d(omega3)/dt, d(d(omega3)/dt)/d(omega_tau), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), d(v_nu)/dt, a part of d(d(omega_tau)/dt)/d(gamma3), d(omega_tau)/dt, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega3), d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega3)" },
    .divergence = { divergence, 1, { 2, 14, 10, 1, 1, 0, 14, 8 }, { 12, 39, 0, 5, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, Theta*((1)/Theta*s^2*D)*(2*m*a3^2)*s^2 - 1/s^2, a part of the divergence, a part of the divergence, e = gamma3*a3 + R, V = omega_tau*e + v_nu, the divergence" },
    .integral_values = { integral_values, 1, { 3, 12, 8, 1, 1, 0, 8, 8 }, { 10, 31, 0, 1, 1, 0, 12, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*(R*I3)*omega3 + G_level, v_tau = s*omega3*R + (1/I1)*b/R*((b/R*(R*I3)*omega3 + G_level)/s^2)*s, energy/(1/2*m)" },
    .integral_gradients = { integral_gradients, 4, { 3, 17, 12, 1, 1, 0, 10, 11 }, { 15, 50, 0, 6, 1, 0, 12, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*omega3*(R*I3) + G_level, d(omega_n)/d(gamma3), d(v_tau)/d(gamma3)/R, ((1)/s)*b/R*(1/(R*I1))*(b/R*omega3*(R*I3) + G_level)*((1)/s) + omega3, v_tau/R = omega3*s + b/R*(1/(R*I1))*(b/R*omega3*(R*I3) + G_level)*((1)/s), d(E)/d(gamma3), d(E)/d(omega3)" },
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
