/* Sphere with displaced centre of mass rolling without slipping, reduced system
 *
 *  Source:     E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243
 *  Table:      routh_sphere, SHA-256 3411ed6d53d99c328220ac4c0d992bf489a81f74d3bcee4f47f68fdd4a704bc2
 *  Command:    ttc generate --effort full --out DIR routh_sphere.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   25   11    1    1    0     13    8   (86)
 *  jacobian            5   48   27    1    1    0     17   17   (295)
 *  rhs_jacobian        6   48   26    1    1    0     19   18   (350)
 *  divergence          4    7    4    1    1    0      8    6   (42)
 *  integral_values     2   13   12    0    2    0      6    8   (57)
 *  integral_gradients  4   25   13    1    2    0     11   10   (86)
 *  measure_values      3    3    4    0    1    0      6    4   (27)
 *  measure_divergences 3   14    9    1    2    0     11    8   (66)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    divides by K: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, K/m = gamma3*(2*R*a3) + R^2 + a3^2 + I1/m,
 *      v_tau = R*omega3*s + omega_n*b, e = gamma3*a3 + R,
 *      (I1/m)*omega_n*gamma3*((1)/s^2*Theta*K/m)*Theta*K/m*s + (I3/m)*omega3,
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      I3/(m*R) + e, a part of d(d(omega_tau)/dt)/d(omega_n), gamma3*(R*(I1 - I3)) - (a3*I3),
 *      d(d(omega_n)/dt)/d(omega_tau), d(v_tau)/d(gamma3)/R = omega_n - omega3*gamma3*((1)/s^2*Theta*K/m)*Theta*K/m*s,
 *      a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1),
 *      m*R*a3*I3 - 1/Theta*(m*R*I3)*(I3/(m*R) + e)*d(Theta)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3),
 *      a part of d(d(omega3)/dt)/d(gamma3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_routh_sphere[];
extern const jlt_claim jlt_claims_routh_sphere[];
extern const jlt_descriptor *const jlt_family_routh_sphere[];
extern const jlt_descriptor jlt_kernels_routh_sphere_general;
extern const struct jlt_ball_table jlt_balls_routh_sphere_general;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_baseline;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_avx2;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[5]/t1; /* I3/(m*R*R) */
    out[6] = t2;
    const double t3 = t0*params[4]; /* R*R*I1 */
    const double t4 = params[5]/t3; /* I3/(R*R*I1) */
    out[7] = t4;
    const double t5 = params[2]*params[3]; /* g*a3 */
    out[8] = t5;
    const double t6 = params[1]*params[3]; /* R*a3 */
    out[9] = t6;
    const double t7 = params[3]*params[3]; /* a3*a3 */
    out[42] = t7;
    const double t8 = t0 + t7; /* R*R + a3*a3 */
    out[49] = t8;
    const double t9 = params[4]/params[0]; /* I1/m */
    out[12] = t9;
    const double t10 = t8 + t9; /* R*R + a3*a3 + I1/m */
    out[10] = t10;
    const double t11 = params[1]*2.0; /* R*2 */
    const double t12 = params[3]*t11; /* a3*R*2 */
    out[11] = t12;
    const double t13 = params[5]/params[4]; /* I3/I1 */
    out[13] = t13;
    const double t14 = params[1]*params[4]; /* R*I1 */
    out[45] = t14;
    const double t15 = params[5]/t14; /* I3/(R*I1) */
    out[14] = t15;
    const double t16 = params[0]*params[1]; /* m*R */
    out[36] = t16;
    const double t17 = params[5]/t16; /* I3/(m*R) */
    out[15] = t17;
    const double t18 = 1.0/t14; /* 1/(R*I1) */
    out[16] = t18;
    const double t19 = params[4] - params[5]; /* I1 - I3 */
    const double t20 = params[1]*t19; /* R*(I1 - I3) */
    out[17] = t20;
    const double t21 = params[5]*params[3]; /* I3*a3 */
    out[18] = t21;
    const double t22 = params[5]*params[4]; /* I3*I1 */
    out[19] = t22;
    const double t23 = t1*params[4]; /* m*R*R*I1 */
    out[20] = t23;
    const double t24 = params[0]*params[5]; /* m*I3 */
    out[21] = t24;
    const double t25 = params[4]*t12; /* I1*a3*R*2 */
    const double t26 = t25/params[0]; /* I1*a3*R*2/m */
    out[22] = t26;
    const double t27 = params[0]/params[4]; /* m/I1 */
    out[23] = t27;
    const double t28 = params[3]*t16; /* a3*m*R */
    const double t29 = t28/params[4]; /* a3*m*R/I1 */
    out[24] = t29;
    const double t30 = params[0]*params[2]; /* m*g */
    const double t31 = params[3]*t30; /* a3*m*g */
    out[40] = t31;
    const double t32 = t31/params[4]; /* a3*m*g/I1 */
    out[25] = t32;
    const double t33 = params[0]*params[3]; /* m*a3 */
    const double t34 = t33/params[4]; /* m*a3/I1 */
    out[26] = t34;
    const double t35 = params[1]*(-2.0); /* R*(-2) */
    const double t36 = params[3]*t35; /* a3*R*(-2) */
    out[27] = t36;
    const double t37 = params[4]*2.0; /* I1*2 */
    const double t38 = t37/params[0]; /* I1*2/m */
    out[28] = t38;
    const double t39 = params[5]/params[0]; /* I3/m */
    out[29] = t39;
    const double t40 = -params[1]; /* -R */
    out[30] = t40;
    const double t41 = params[5]*t28; /* I3*a3*m*R */
    out[31] = t41;
    const double t42 = params[0]*2.0; /* m*2 */
    const double t43 = t0*t42; /* R*R*m*2 */
    const double t44 = params[4]*t43; /* I1*R*R*m*2 */
    out[32] = t44;
    const double t45 = params[1]*t42; /* R*m*2 */
    const double t46 = params[5]*t45; /* I3*R*m*2 */
    out[33] = t46;
    const double t47 = params[5]*t16; /* I3*m*R */
    out[34] = t47;
    const double t48 = t1*t19; /* m*R*R*(I1 - I3) */
    out[35] = t48;
    const double t49 = params[2]/params[1]; /* g/R */
    out[37] = t49;
    const double t50 = params[3]/params[1]; /* a3/R */
    out[38] = t50;
    const double t51 = t0*2.0; /* R*R*2 */
    const double t52 = params[3]*t51; /* a3*R*R*2 */
    const double t53 = params[4]*t52; /* I1*a3*R*R*2 */
    out[39] = t53;
    const double t54 = params[0]/2.0; /* m/2 */
    out[41] = t54;
    const double t55 = params[4]/2.0; /* I1/2 */
    out[43] = t55;
    const double t56 = params[5]/2.0; /* I3/2 */
    out[44] = t56;
    const double t57 = -t14; /* -R*I1 */
    out[46] = t57;
    const double t58 = params[1]*params[5]; /* R*I3 */
    const double t59 = -t58; /* -R*I3 */
    out[47] = t59;
    const double t60 = -params[5]; /* -I3 */
    out[48] = t60;
    const double t61 = t1*params[5]; /* m*R*R*I3 */
    out[50] = t61;
    const double t62 = -t16; /* -m*R */
    out[51] = t62;
    const double t63 = params[3]*2.0; /* a3*2 */
    out[52] = t63;
    const double t64 = 1.0/t45; /* 1/(R*m*2) */
    out[53] = t64;
    const double t65 = params[0]*4.0; /* m*4 */
    const double t66 = params[1]*t65; /* R*m*4 */
    const double t67 = params[3]*t66; /* a3*R*m*4 */
    out[54] = t67;
    const double t68 = params[5]*t43; /* I3*R*R*m*2 */
    out[55] = t68;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[7]*t3; /* I3/(R^2*I1)*b */
    const double t5 = p[6] + t2; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s^2 */
    const double t7 = x[2]*t3; /* omega_n*b */
    const double t8 = JLT_FMA(x[0], p[11], p[10]); /* K/m = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t9 = t6*t8; /* Theta/(m*R^2*I1)*K/m */
    const double t10 = x[3]*t8; /* omega3*K/m */
    const double t11 = t2*t9; /* s^2*Theta/(m*R^2*I1)*K/m */
    const double t12 = x[2]*t9; /* omega_n*Theta/(m*R^2*I1)*K/m */
    const double t13 = 1.0/t11; /* 1/(s^2*Theta/(m*R^2*I1)*K/m) */
    const double t14 = sqrt(t2); /* s = sqrt(s^2) */
    const double t15 = t12*t14; /* omega_n*Theta/(m*R^2*I1)*K/m*s */
    const double t16 = t13*t15; /* 1/(s^2*Theta/(m*R^2*I1)*K/m)*omega_n*Theta/(m*R^2*I1)*K/m*s */
    const double t17 = t2*t13; /* 1/((K/m)*(Theta/(m*R^2*I1))) = s^2*1/(s^2*Theta/(m*R^2*I1)*K/m) */
    const double t18 = t6*t17; /* Theta/(m*R^2*I1)*1/((K/m)*(Theta/(m*R^2*I1))) */
    const double t19 = t10*t17; /* omega3*K/m*1/((K/m)*(Theta/(m*R^2*I1))) */
    const double t20 = p[1]*x[3]; /* R*omega3 */
    const double t21 = JLT_FMA(t14, t20, t7); /* v_tau = s*R*omega3 + omega_n*b */
    const double t22 = x[1]*t14; /* omega_tau*s */
    out[0] = t22;
    const double t23 = p[8]*t14; /* g*a3*s */
    const double t24 = x[1]*p[9]; /* omega_tau*R*a3 */
    const double t25 = JLT_FMA(t22, t24, t23); /* omega_tau*s*omega_tau*R*a3 + g*a3*s */
    const double t26 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t27 = t21*t26; /* v_tau*e */
    const double t28 = JLT_FMA(t16, t27, t25); /* 1/(s^2*Theta/(m*R^2*I1)*K/m)*omega_n*Theta/(m*R^2*I1)*K/m*s*v_tau*e + omega_tau*s*omega_tau*R*a3 + g*a3*s */
    const double t29 = x[0]*t16; /* gamma3*1/(s^2*Theta/(m*R^2*I1)*K/m)*omega_n*Theta/(m*R^2*I1)*K/m*s */
    const double t30 = p[15] + t26; /* I3/(m*R) + e */
    const double t31 = p[14]*t30; /* I3/(R*I1)*(I3/(m*R) + e) */
    const double t32 = JLT_FMA(t19, t31, t29); /* omega3*K/m*1/((K/m)*(Theta/(m*R^2*I1)))*I3/(R*I1)*(I3/(m*R) + e) + t29 */
    const double t33 = x[1]*t32; /* omega_tau*t32 */
    out[2] = t33;
    const double t34 = JLT_FMA(x[3], p[13], t29); /* omega3*I3/I1 + t29 */
    const double t35 = x[2]*p[12]; /* omega_n*I1/m */
    const double t36 = JLT_FMA(t34, t35, t28); /* (omega3*I3/I1 + t29)*omega_n*I1/m + t28 */
    const double t37 = t18*t36; /* Theta/(m*R^2*I1)*1/((K/m)*(Theta/(m*R^2*I1)))*((omega3*I3/I1 + t29)*omega_n*I1/m + t28) */
    const double t38 = -t37; /* -t37 */
    out[1] = t38;
    const double t39 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t40 = p[16]*t39; /* 1/(R*I1)*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t41 = t22*t40; /* omega_tau*s*1/(R*I1)*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t42 = t19*t41; /* omega3*K/m*1/((K/m)*(Theta/(m*R^2*I1)))*omega_tau*s*1/(R*I1)*(gamma3*R*(I1 - I3) - a3*I3) */
    out[3] = t42;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[2] = 0.0;
    out[3] = 0.0;
    out[14] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[21]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[20], t2, p[19]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(x[0], p[11], p[10]); /* K/m = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t8 = t6*t7; /* Theta*K/m */
    const double t9 = t2*t8; /* s^2*Theta*K/m */
    const double t10 = 1.0/t9; /* 1/(s^2*Theta*K/m) */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    out[1] = t11;
    const double t12 = t8*t11; /* Theta*K/m*s */
    const double t13 = t10*t12; /* 1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t14 = t2*t10; /* 1/((K/m)*Theta) = s^2*1/(s^2*Theta*K/m) */
    const double t15 = t7*t14; /* 1/Theta = K/m*1/((K/m)*Theta) */
    const double t16 = t6*t14; /* 1/(K/m) = Theta*1/((K/m)*Theta) */
    const double t17 = x[2]*t13; /* omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t18 = x[2]*t3; /* omega_n*b */
    const double t19 = x[3]*t11; /* omega3*s */
    const double t20 = JLT_FMA(p[1], t19, t18); /* v_tau = R*omega3*s + omega_n*b */
    const double t21 = t13*t17; /* 1/(s^2*Theta*K/m)*Theta*K/m*s*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t22 = x[0]*t13; /* gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t23 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t24 = x[1]*t11; /* omega_tau*s */
    const double t25 = x[1]*p[24]; /* omega_tau*m*R*a3/I1 */
    const double t26 = t24*t25; /* omega_tau*s*omega_tau*m*R*a3/I1 */
    const double t27 = JLT_FMA(p[25], t11, t26); /* m*g*a3/I1*s + omega_tau*s*omega_tau*m*R*a3/I1 */
    const double t28 = JLT_FMA(p[26], t20, t21); /* m*a3/I1*v_tau + t21 */
    const double t29 = t13*t21; /* 1/(s^2*Theta*K/m)*Theta*K/m*s*t21 */
    const double t30 = t13*t20; /* 1/(s^2*Theta*K/m)*Theta*K/m*s*v_tau */
    const double t31 = p[23]*t20; /* m/I1*v_tau */
    const double t32 = p[12]*t17; /* I1/m*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t33 = t28*t32; /* (m*a3/I1*v_tau + t21)*I1/m*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t34 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t35 = p[36]*t34; /* m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t36 = x[1]*t22; /* omega_tau*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    out[10] = t36;
    const double t37 = -t36; /* -omega_tau*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    out[0] = t37;
    const double t38 = t17*t23; /* omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s*e */
    const double t39 = JLT_FMA(t31, t38, t27); /* m/I1*v_tau*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s*e + m*g*a3/I1*s + omega_tau*s*omega_tau*m*R*a3/I1 */
    const double t40 = x[0]*t17; /* gamma3*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t41 = x[1]*p[9]; /* omega_tau*R*a3 */
    const double t42 = JLT_FMS(t36, t41, t33); /* omega_tau*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s*omega_tau*R*a3 - t33 */
    const double t43 = x[3]*p[29]; /* omega3*I3/m */
    const double t44 = JLT_FMA(t23, t30, t43); /* e*1/(s^2*Theta*K/m)*Theta*K/m*s*v_tau + omega3*I3/m */
    const double t45 = p[15] + t23; /* I3/(m*R) + e */
    const double t46 = JLT_FNMA(t30, t38, p[8]); /* g*a3 - 1/(s^2*Theta*K/m)*Theta*K/m*s*v_tau*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s*e */
    const double t47 = JLT_FMA(p[28], t40, t44); /* 2*I1/m*gamma3*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s + e*1/(s^2*Theta*K/m)*Theta*K/m*s*v_tau + omega3*I3/m */
    const double t48 = JLT_FMA(t3, t38, t47); /* b*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s*e + t47 */
    const double t49 = p[1]*t38; /* R*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s*e */
    const double t50 = t16*t48; /* 1/(K/m)*(b*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s*e + t47) */
    const double t51 = -t50; /* -1/(K/m)*(b*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s*e + t47) */
    out[6] = t51;
    const double t52 = x[0]*p[32]; /* gamma3*2*m*R^2*I1 */
    const double t53 = JLT_FMS(p[33], t3, t52); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t54 = JLT_FNMA(x[3], t22, x[2]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t55 = JLT_FNMA(t49, t54, t42); /* t42 - R*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s*e*d(v_tau)/d(gamma3)/R */
    const double t56 = JLT_FMA(t22, t46, t55); /* d(numerator of d(omega_tau)/dt over K)/d(gamma3)/m = gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s*t46 + t55 */
    const double t57 = p[34]*t45; /* m*R*I3*(I3/(m*R) + e) */
    const double t58 = t15*t35; /* 1/Theta*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t59 = t19*t58; /* omega3*s*1/Theta*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[13] = t59;
    const double t60 = t24*t58; /* omega_tau*s*1/Theta*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[15] = t60;
    const double t61 = JLT_FNMA(t53, t58, p[35]); /* m*R^2*(I1 - I3) - d(Theta)/d(gamma3)*1/Theta*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t62 = t24*t61; /* omega_tau*s*t61 */
    const double t63 = JLT_FNMA(t35, t36, t62); /* omega_tau*s*t61 - m*R*(gamma3*R*(I1 - I3) - a3*I3)*omega_tau*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t64 = p[27]*t24; /* (-2*R*a3)*omega_tau*s */
    const double t65 = t16*t64; /* 1/(K/m)*(-2*R*a3)*omega_tau*s */
    out[5] = t65;
    const double t66 = JLT_FMA(p[13], x[3], t40); /* I3/I1*omega3 + gamma3*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t67 = JLT_FMA(x[2], t66, t39); /* omega_n*(I3/I1*omega3 + gamma3*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s) + t39 */
    const double t68 = t15*t57; /* 1/Theta*m*R*I3*(I3/(m*R) + e) */
    const double t69 = x[3]*t15; /* omega3*1/Theta */
    const double t70 = JLT_FMA(t57, t69, t40); /* m*R*I3*(I3/(m*R) + e)*omega3*1/Theta + gamma3*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    out[9] = t70;
    const double t71 = t63*t69; /* t63*omega3*1/Theta */
    out[12] = t71;
    const double t72 = JLT_FNMA(t53, t68, p[31]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*m*R*I3*(I3/(m*R) + e) */
    const double t73 = JLT_FMA(t69, t72, t29); /* omega3*1/Theta*(m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*m*R*I3*(I3/(m*R) + e)) + 1/(s^2*Theta*K/m)*Theta*K/m*s*t21 */
    const double t74 = x[1]*t73; /* omega_tau*t73 */
    out[8] = t74;
    const double t75 = x[1]*t68; /* omega_tau*1/Theta*m*R*I3*(I3/(m*R) + e) */
    out[11] = t75;
    const double t76 = p[22]*t16; /* 2*R*a3*I1/m*1/(K/m) */
    const double t77 = JLT_FMA(t67, t76, t56); /* t67*2*R*a3*I1/m*1/(K/m) + d(numerator of d(omega_tau)/dt over K)/d(gamma3)/m */
    const double t78 = t16*t77; /* 1/(K/m)*t77 */
    out[4] = t78;
    const double t79 = x[2]*p[30]; /* omega_n*(-R) */
    const double t80 = t45*t79; /* (I3/(m*R) + e)*omega_n*(-R) */
    const double t81 = t16*t80; /* 1/(K/m)*(I3/(m*R) + e)*omega_n*(-R) */
    out[7] = t81;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[6] = 0.0;
    out[7] = 0.0;
    out[18] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[21]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[20], t2, p[19]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(x[0], p[11], p[10]); /* K/m = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t8 = t6*t7; /* Theta*K/m */
    const double t9 = t2*t8; /* s^2*Theta*K/m */
    const double t10 = 1.0/t9; /* 1/(s^2*Theta*K/m) */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    out[5] = t11;
    const double t12 = t8*t11; /* Theta*K/m*s */
    const double t13 = t10*t12; /* 1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t14 = t2*t10; /* 1/((K/m)*Theta) = s^2*1/(s^2*Theta*K/m) */
    const double t15 = t6*t14; /* 1/(K/m) = Theta*1/((K/m)*Theta) */
    const double t16 = t7*t14; /* 1/Theta = K/m*1/((K/m)*Theta) */
    const double t17 = x[2]*t3; /* omega_n*b */
    const double t18 = x[3]*t11; /* omega3*s */
    const double t19 = JLT_FMA(p[1], t18, t17); /* v_tau = R*omega3*s + omega_n*b */
    const double t20 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t21 = x[2]*t13; /* omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t22 = x[0]*t13; /* gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t23 = t20*t21; /* e*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t24 = JLT_FMA(x[1], x[1], p[37]); /* omega_tau*omega_tau + g/R */
    const double t25 = p[9]*t24; /* R*a3*(omega_tau*omega_tau + g/R) */
    const double t26 = p[29]*x[3]; /* I3/m*omega3 */
    const double t27 = x[2]*t22; /* omega_n*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t28 = t19*t23; /* v_tau*e*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t29 = JLT_FMA(p[12], t27, t26); /* I1/m*omega_n*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s + I3/m*omega3 */
    const double t30 = JLT_FMA(t11, t25, t28); /* s*R*a3*(omega_tau*omega_tau + g/R) + v_tau*e*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t31 = JLT_FMA(x[2], t29, t30); /* omega_n*t29 + t30 */
    const double t32 = JLT_FMS(t13, t28, t25); /* 1/(s^2*Theta*K/m)*Theta*K/m*s*v_tau*e*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s - R*a3*(omega_tau*omega_tau + g/R) */
    const double t33 = t15*t31; /* 1/(K/m)*(omega_n*t29 + t30) */
    const double t34 = x[1]*t11; /* omega_tau*s */
    out[0] = t34;
    const double t35 = -t33; /* -1/(K/m)*(omega_n*t29 + t30) */
    out[1] = t35;
    const double t36 = p[11]*t33; /* 2*R*a3*1/(K/m)*(omega_n*t29 + t30) */
    const double t37 = p[15] + t20; /* I3/(m*R) + e */
    const double t38 = t19*t20; /* v_tau*e */
    const double t39 = JLT_FMA(t13, t38, t26); /* 1/(s^2*Theta*K/m)*Theta*K/m*s*v_tau*e + I3/m*omega3 */
    const double t40 = JLT_FMA(p[28], t27, t39); /* 2*I1/m*omega_n*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s + 1/(s^2*Theta*K/m)*Theta*K/m*s*v_tau*e + I3/m*omega3 */
    const double t41 = JLT_FMA(t3, t23, t40); /* b*e*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s + t40 */
    const double t42 = p[1]*t23; /* R*e*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t43 = t15*t41; /* 1/(K/m)*(b*e*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s + t40) */
    const double t44 = -t43; /* -1/(K/m)*(b*e*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s + t40) */
    out[10] = t44;
    const double t45 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t46 = p[36]*t45; /* m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t47 = p[34]*t37; /* m*R*I3*(I3/(m*R) + e) */
    const double t48 = t16*t47; /* 1/Theta*m*R*I3*(I3/(m*R) + e) */
    const double t49 = JLT_FMA(x[3], t48, t27); /* omega3*1/Theta*m*R*I3*(I3/(m*R) + e) + omega_n*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    out[13] = t49;
    const double t50 = x[1]*t49; /* omega_tau*t49 */
    out[2] = t50;
    const double t51 = x[1]*t48; /* omega_tau*1/Theta*m*R*I3*(I3/(m*R) + e) */
    out[15] = t51;
    const double t52 = JLT_FNMA(x[3], t22, x[2]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t53 = JLT_FNMA(t42, t52, t36); /* 2*R*a3*1/(K/m)*(omega_n*t29 + t30) - R*e*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s*d(v_tau)/d(gamma3)/R */
    const double t54 = t13*t21; /* 1/(s^2*Theta*K/m)*Theta*K/m*s*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t55 = JLT_FMA(p[26], t19, t54); /* m*a3/I1*v_tau + t54 */
    const double t56 = t13*t54; /* 1/(s^2*Theta*K/m)*Theta*K/m*s*t54 */
    const double t57 = p[12]*t21; /* I1/m*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t58 = JLT_FNMA(t55, t57, t53); /* t53 - (m*a3/I1*v_tau + t54)*I1/m*omega_n*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t59 = JLT_FNMA(t22, t32, t58); /* t58 - gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s*t32 */
    const double t60 = t15*t59; /* 1/(K/m)*(t58 - gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s*t32) */
    out[8] = t60;
    const double t61 = x[1]*t22; /* omega_tau*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    out[14] = t61;
    const double t62 = -t61; /* -omega_tau*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    out[4] = t62;
    const double t63 = x[0]*p[32]; /* gamma3*2*m*R^2*I1 */
    const double t64 = JLT_FMS(p[33], t3, t63); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t65 = JLT_FNMA(t48, t64, p[31]); /* m*R*a3*I3 - 1/Theta*m*R*I3*(I3/(m*R) + e)*d(Theta)/d(gamma3) */
    const double t66 = t16*t46; /* 1/Theta*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t67 = t18*t66; /* omega3*s*1/Theta*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[17] = t67;
    const double t68 = t34*t66; /* omega_tau*s*1/Theta*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[19] = t68;
    const double t69 = x[3]*t16; /* omega3*1/Theta */
    const double t70 = JLT_FMA(t65, t69, t56); /* (m*R*a3*I3 - 1/Theta*m*R*I3*(I3/(m*R) + e)*d(Theta)/d(gamma3))*omega3*1/Theta + 1/(s^2*Theta*K/m)*Theta*K/m*s*t54 */
    const double t71 = x[1]*t70; /* omega_tau*t70 */
    out[12] = t71;
    const double t72 = x[3]*t68; /* omega3*omega_tau*s*1/Theta*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[3] = t72;
    const double t73 = p[35]*t34; /* m*R^2*(I1 - I3)*omega_tau*s */
    const double t74 = JLT_FNMA(t46, t61, t73); /* m*R^2*(I1 - I3)*omega_tau*s - m*R*(gamma3*R*(I1 - I3) - a3*I3)*omega_tau*gamma3*1/(s^2*Theta*K/m)*Theta*K/m*s */
    const double t75 = JLT_FNMA(t64, t68, t74); /* t74 - d(Theta)/d(gamma3)*omega_tau*s*1/Theta*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t76 = t69*t75; /* omega3*1/Theta*t75 */
    out[16] = t76;
    const double t77 = p[27]*t34; /* (-2*R*a3)*omega_tau*s */
    const double t78 = t15*t77; /* 1/(K/m)*(-2*R*a3)*omega_tau*s */
    out[9] = t78;
    const double t79 = x[2]*p[30]; /* omega_n*(-R) */
    const double t80 = t37*t79; /* (I3/(m*R) + e)*omega_n*(-R) */
    const double t81 = t15*t80; /* 1/(K/m)*(I3/(m*R) + e)*omega_n*(-R) */
    out[11] = t81;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], p[11], p[10]); /* K/m = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t5 = x[0] + p[38]; /* b/R = gamma3 + a3/R */
    const double t6 = p[13]*t5; /* I3/I1*b/R */
    const double t7 = t2 + p[6]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t8 = JLT_FMA(t5, t6, t7); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t9 = t4*t8; /* K/m*Theta/(m*R^2*I1) */
    const double t10 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t11 = t4*t10; /* K/m*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t12 = JLT_FNMA(t8, p[39], t11); /* K/m*(gamma3*R*(I1 - I3) - a3*I3) - Theta/(m*R^2*I1)*2*R^2*a3*I1 */
    const double t13 = p[16]*x[1]; /* 1/(R*I1)*omega_tau */
    const double t14 = t12*t13; /* t12*1/(R*I1)*omega_tau */
    const double t15 = t3*t14; /* s*t12*1/(R*I1)*omega_tau */
    const double t16 = t15/t9; /* s*t12*1/(R*I1)*omega_tau/(K/m*Theta/(m*R^2*I1)) */
    out[0] = t16;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[21]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[20], t2, p[19]); /* m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t7 = sqrt(t6); /* h = sqrt(Theta) */
    const double t8 = x[3]*t7; /* omega3*h */
    out[2] = t8;
    const double t9 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t10 = t9*t9; /* e*e */
    const double t11 = JLT_FMA(p[42], t2, t10); /* a3^2*(1 - gamma3)*(gamma3 + 1) + e*e */
    const double t12 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t13 = p[40]*x[0]; /* m*g*a3*gamma3 */
    const double t14 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t15 = t11*t14; /* (a3^2*(1 - gamma3)*(gamma3 + 1) + e*e)*omega_tau*omega_tau */
    const double t16 = JLT_FMA(x[2], x[2], t14); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t17 = x[2]*t3; /* omega_n*b */
    const double t18 = p[1]*x[3]; /* R*omega3 */
    const double t19 = JLT_FMA(t12, t18, t17); /* v_tau = s*R*omega3 + omega_n*b */
    const double t20 = JLT_FMA(t19, t19, t15); /* v_tau*v_tau + (a3^2*(1 - gamma3)*(gamma3 + 1) + e*e)*omega_tau*omega_tau */
    const double t21 = x[3]*p[44]; /* omega3*1/2*I3 */
    const double t22 = JLT_FMA(x[3], t21, t13); /* omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t23 = JLT_FMA(p[43], t16, t22); /* 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) + omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t24 = JLT_FMA(p[41], t20, t23); /* 1/2*m*t20 + t23 */
    out[0] = t24;
    const double t25 = x[2]*p[45]; /* omega_n*R*I1 */
    const double t26 = t12*t25; /* s*omega_n*R*I1 */
    const double t27 = x[3]*p[5]; /* omega3*I3 */
    const double t28 = JLT_FNMA(t3, t27, t26); /* s*omega_n*R*I1 - b*omega3*I3 */
    out[1] = t28;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = p[48]*t3; /* (-I3)*b */
    out[7] = t4;
    const double t5 = p[21]*t3; /* m*I3*b */
    const double t6 = JLT_FMA(p[20], t2, p[19]); /* m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t7 = JLT_FMA(t3, t5, t6); /* Theta = b*m*I3*b + m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t8 = sqrt(t7); /* h = sqrt(Theta) */
    out[11] = t8;
    const double t9 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t10 = p[45]*t9; /* R*I1*s */
    out[6] = t10;
    const double t11 = t8*t9; /* h*s */
    const double t12 = 1.0/t11; /* 1/(h*s) */
    const double t13 = x[0]*t8; /* gamma3*h */
    const double t14 = t12*t13; /* 1/(h*s)*gamma3*h */
    const double t15 = p[3]*x[0]; /* a3*gamma3 */
    const double t16 = p[1] + t15; /* e = R + a3*gamma3 */
    const double t17 = t16 - t15; /* e - a3*gamma3 */
    const double t18 = t16*t16; /* e*e */
    const double t19 = JLT_FMA(p[42], t2, t18); /* a3^2*(1 - gamma3)*(gamma3 + 1) + e*e */
    const double t20 = p[38]*x[1]; /* a3/R*omega_tau */
    const double t21 = x[1]*t20; /* omega_tau*a3/R*omega_tau */
    const double t22 = t17*t21; /* (e - a3*gamma3)*omega_tau*a3/R*omega_tau */
    const double t23 = x[2]*t3; /* omega_n*b */
    const double t24 = x[3]*t9; /* omega3*s */
    const double t25 = JLT_FMA(p[1], t24, t23); /* v_tau = R*omega3*s + omega_n*b */
    const double t26 = p[36]*t9; /* m*R*s */
    const double t27 = JLT_FMS(p[14], t3, x[0]); /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = I3/(R*I1)*b - gamma3 */
    const double t28 = p[0]*t3; /* m*b */
    const double t29 = p[20]*t27; /* m*R^2*I1*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t30 = t24*t29; /* omega3*s*m*R^2*I1*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t31 = t12*t30; /* 1/(h*s)*omega3*s*m*R^2*I1*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    out[8] = t31;
    const double t32 = t25*t28; /* v_tau*m*b */
    const double t33 = JLT_FMA(x[2], p[4], t32); /* omega_n*I1 + v_tau*m*b */
    out[2] = t33;
    const double t34 = JLT_FNMA(x[3], t14, x[2]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*1/(h*s)*gamma3*h */
    const double t35 = JLT_FMA(t25, t34, t22); /* v_tau*d(v_tau)/d(gamma3)/R + (e - a3*gamma3)*omega_tau*a3/R*omega_tau */
    const double t36 = JLT_FMA(p[36], t35, p[40]); /* m*R*t35 + m*g*a3 */
    out[0] = t36;
    const double t37 = x[1]*p[0]; /* omega_tau*m */
    const double t38 = t19*t37; /* (a3^2*(1 - gamma3)*(gamma3 + 1) + e*e)*omega_tau*m */
    const double t39 = JLT_FMA(x[1], p[4], t38); /* omega_tau*I1 + (a3^2*(1 - gamma3)*(gamma3 + 1) + e*e)*omega_tau*m */
    out[1] = t39;
    const double t40 = x[2]*p[46]; /* omega_n*(-R*I1) */
    const double t41 = t14*t40; /* 1/(h*s)*gamma3*h*omega_n*(-R*I1) */
    const double t42 = JLT_FMA(x[3], p[47], t41); /* omega3*(-R*I3) + 1/(h*s)*gamma3*h*omega_n*(-R*I1) */
    out[4] = t42;
    const double t43 = x[3]*p[5]; /* omega3*I3 */
    const double t44 = JLT_FMA(t25, t26, t43); /* v_tau*m*R*s + omega3*I3 */
    out[3] = t44;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = p[20]*t0; /* m*R^2*I1*(1 - gamma3) */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = JLT_FMA(t1, t2, p[19]); /* m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t4 = x[0] + p[38]; /* b/R = gamma3 + a3/R */
    const double t5 = p[50]*t4; /* m*R^2*I3*b/R */
    const double t6 = JLT_FMA(t4, t5, t3); /* Theta = b/R*m*R^2*I3*b/R + m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + I1*I3 */
    const double t7 = sqrt(t6); /* h = sqrt(Theta) */
    const double t8 = JLT_FMA(p[11], x[0], p[49]); /* 2*R*a3*gamma3 + R^2 + a3^2 */
    const double t9 = JLT_FMA(p[0], t8, p[4]); /* K = m*(2*R*a3*gamma3 + R^2 + a3^2) + I1 */
    const double t10 = t7*t9; /* h*K */
    out[0] = t10;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(x[0], p[11], p[49]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t5 = JLT_FMA(p[0], t4, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t6 = x[0] + p[38]; /* b/R = gamma3 + a3/R */
    const double t7 = p[50]*t6; /* m*R^2*I3*b/R */
    const double t8 = JLT_FMA(t2, p[20], p[19]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t9 = JLT_FMA(t6, t7, t8); /* Theta = b/R*m*R^2*I3*b/R + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t10 = sqrt(t9); /* h = sqrt(Theta) */
    const double t11 = t5*t9; /* K*Theta */
    const double t12 = 1.0/t11; /* 1/(K*Theta) */
    const double t13 = t9*p[52]; /* Theta*2*a3 */
    const double t14 = t12*t13; /* 1/(K*Theta)*Theta*2*a3 */
    const double t15 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t16 = t5*t12; /* 1/Theta = K*1/(K*Theta) */
    const double t17 = JLT_FNMA(t15, t16, t14); /* 1/(K*Theta)*Theta*2*a3 - (gamma3*R*(I1 - I3) - a3*I3)*1/Theta */
    const double t18 = t5*t10; /* K*h */
    const double t19 = t17*t18; /* t17*K*h */
    const double t20 = x[0]*p[32]; /* gamma3*2*m*R^2*I1 */
    const double t21 = JLT_FMS(t6, p[55], t20); /* d(Theta)/d(gamma3) = b/R*2*m*R^2*I3 - gamma3*2*m*R^2*I1 */
    const double t22 = t5*t21; /* K*d(Theta)/d(gamma3) */
    const double t23 = JLT_FMA(t16, t22, p[54]); /* 1/Theta*K*d(Theta)/d(gamma3) + 4*m*R*a3 */
    const double t24 = t10*p[53]; /* h*1/2/(m*R) */
    const double t25 = JLT_FNMA(t23, t24, t19); /* t17*K*h - (1/Theta*K*d(Theta)/d(gamma3) + 4*m*R*a3)*h*1/2/(m*R) */
    const double t26 = p[51]*x[1]; /* (-m*R)*omega_tau */
    const double t27 = t3*t26; /* s*(-m*R)*omega_tau */
    const double t28 = t25*t27; /* t25*s*(-m*R)*omega_tau */
    out[0] = t28;
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
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t20[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t21[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t22[k] = jlt_jet_product(t20, t21, k);
        t23[k] = jlt_jet_root(t22[k], t23, k);
        t24[k] = (k == 0 ? p[6] : 0) + t22[k];
        t25[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t26[k] = jlt_jet_product(x2, t25, k);
        t27[k] = p[1]*x3[k];
        t28[k] = jlt_jet_product(t23, t27, k) + t26[k];
        t29[k] = jlt_jet_product(x1, t23, k);
        t30[k] = p[8]*t23[k];
        t31[k] = jlt_jet_quotient(x2[k], t23, t31, k);
        t32[k] = x1[k]*p[9];
        t33[k] = jlt_jet_product(t29, t32, k) + t30[k];
        t34[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t35[k] = jlt_jet_product(t28, t34, k);
        t36[k] = jlt_jet_product(t31, t35, k) + t33[k];
        t37[k] = jlt_jet_product(x0, t31, k);
        t38[k] = (k == 0 ? p[15] : 0) + t34[k];
        t39[k] = p[14]*t38[k];
        t40[k] = p[7]*t25[k];
        t41[k] = jlt_jet_product(t25, t40, k) + t24[k];
        t42[k] = jlt_jet_quotient(x3[k], t41, t42, k);
        t43[k] = jlt_jet_product(t39, t42, k) + t37[k];
        t44[k] = jlt_jet_product(x1, t43, k);
        t45[k] = x3[k]*p[13] + t37[k];
        t46[k] = x2[k]*p[12];
        t47[k] = jlt_jet_product(t45, t46, k) + t36[k];
        t48[k] = x0[k]*p[11] + (k == 0 ? p[10] : 0);
        t49[k] = jlt_jet_quotient(t47[k], t48, t49, k);
        t50[k] = -t49[k];
        t51[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t52[k] = p[16]*t51[k];
        t53[k] = jlt_jet_product(t29, t52, k);
        t54[k] = jlt_jet_product(t42, t53, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t29[k]/(k + 1);
        next[1] = x1[k + 1] = t50[k]/(k + 1);
        next[2] = x2[k + 1] = t44[k]/(k + 1);
        next[3] = x3[k + 1] = t54[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[1];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double v_I1 = params[4];
    const double complex v_omega_n = x[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double v_a3 = params[3];
    const double complex v_K = (v_I1 + v_m*(v_R*v_R + v_a3*v_a3 + 2.0*v_R*v_a3*v_gamma3));
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_v_tau = (v_omega_n*v_b + v_R*v_omega3*v_s);
    const double v_g = params[2];
    out[1] = (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_K))
        + (-v_I3*v_omega_n*v_omega3/v_K)
        + (-v_m*v_omega_n*v_e*v_v_tau/(v_s*v_K))
        + (-v_m*v_R*v_a3*v_omega_tau*v_omega_tau*v_s/v_K)
        + (-v_m*v_g*v_a3*v_s/v_K);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    out[2] = (v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta)
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta);
    out[3] = (v_m*v_R*v_omega_tau*v_omega3*v_s*(v_R*v_gamma3*(v_I1 - v_I3) - v_a3*v_I3)/v_Theta);
}

static const unsigned char family0_is_free[] = { 1, 0, 1, 1 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[3] = params[3];
    const double t0 = params[0]*params[3]; /* m*a3 */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* (1 - gamma3)*(1 + gamma3) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t5 = t4*t4; /* s*s */
    const double t6 = t0*t5; /* m*a3*s*s */
    out[4] = params[4];
    const double t7 = x[0]*params[4]; /* gamma3*I1 */
    const double t8 = x[2]*t7; /* omega_n*gamma3*I1 */
    out[5] = params[5];
    const double t9 = params[5]*x[3]; /* I3*omega3 */
    const double t10 = t4*t9; /* s*I3*omega3 */
    const double t11 = t8 + t10; /* omega_n*gamma3*I1 + s*I3*omega3 */
    const double t12 = params[3]*x[0]; /* a3*gamma3 */
    const double t13 = params[1] + t12; /* e = R + a3*gamma3 */
    const double t14 = params[0]*t13; /* m*e */
    const double t15 = params[1]*x[0]; /* R*gamma3 */
    const double t16 = params[3] + t15; /* b = a3 + R*gamma3 */
    const double t17 = x[2]*t16; /* omega_n*b */
    const double t18 = params[1]*x[3]; /* R*omega3 */
    const double t19 = t4*t18; /* s*R*omega3 */
    const double t20 = t17 + t19; /* v_tau = omega_n*b + s*R*omega3 */
    const double t21 = t14*t20; /* m*e*v_tau */
    const double t22 = t11 + t21; /* omega_n*gamma3*I1 + s*I3*omega3 + m*e*v_tau */
    const double t23 = x[2]*t22; /* omega_n*(omega_n*gamma3*I1 + s*I3*omega3 + m*e*v_tau) */
    const double t24 = t23/t6; /* omega_n*(omega_n*gamma3*I1 + s*I3*omega3 + m*e*v_tau)/(m*a3*s*s) */
    const double t25 = -t24; /* g = -t24 */
    out[2] = t25;
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = 0.0;
    out[2] = x[2];
    out[3] = x[3];
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[1] = 0.0;
    out[5] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = t0*params[3]; /* m*g*a3 */
    const double t2 = params[1]*x[0]; /* R*gamma3 */
    const double t3 = params[3] + t2; /* b = a3 + R*gamma3 */
    const double t4 = x[2]*t3; /* omega_n*b */
    const double t5 = params[1]*x[3]; /* R*omega3 */
    const double t6 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t7 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t8 = t6*t7; /* (1 - gamma3)*(1 + gamma3) */
    const double t9 = sqrt(t8); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t10 = t5*t9; /* R*omega3*s */
    const double t11 = t4 + t10; /* v_tau = omega_n*b + R*omega3*s */
    const double t12 = params[1]*x[2]; /* R*omega_n */
    const double t13 = t2*x[3]; /* R*gamma3*omega3 */
    const double t14 = t13/t9; /* R*gamma3*omega3/s */
    const double t15 = t12 - t14; /* d(v_tau)/d(gamma3) = R*omega_n - R*gamma3*omega3/s */
    const double t16 = t11*t15; /* v_tau*d(v_tau)/d(gamma3) */
    const double t17 = params[0]*t16; /* m*v_tau*d(v_tau)/d(gamma3) */
    const double t18 = t1 + t17; /* m*g*a3 + m*v_tau*d(v_tau)/d(gamma3) */
    out[0] = t18;
    const double t19 = t9*t9; /* s*s */
    const double t20 = params[0]*t3; /* m*b */
    const double t21 = t11*t20; /* v_tau*m*b */
    const double t22 = x[2]*params[4]; /* omega_n*I1 */
    const double t23 = t21 + t22; /* v_tau*m*b + omega_n*I1 */
    out[2] = t23;
    const double t24 = x[3]*params[5]; /* omega3*I3 */
    const double t25 = params[0]*params[1]; /* m*R */
    const double t26 = t9*t25; /* s*m*R */
    const double t27 = t11*t26; /* v_tau*s*m*R */
    const double t28 = t24 + t27; /* omega3*I3 + v_tau*s*m*R */
    out[3] = t28;
    const double t29 = params[1]*params[4]; /* R*I1 */
    const double t30 = x[0]*t29; /* gamma3*R*I1 */
    const double t31 = x[2]*t30; /* omega_n*gamma3*R*I1 */
    const double t32 = t31/t9; /* omega_n*gamma3*R*I1/s */
    const double t33 = -t32; /* -omega_n*gamma3*R*I1/s */
    const double t34 = params[1]*params[5]; /* R*I3 */
    const double t35 = x[3]*t34; /* omega3*R*I3 */
    const double t36 = t33 - t35; /* -omega_n*gamma3*R*I1/s - omega3*R*I3 */
    out[4] = t36;
    const double t37 = t9*t29; /* s*R*I1 */
    out[6] = t37;
    const double t38 = t3*params[5]; /* b*I3 */
    const double t39 = -t38; /* -b*I3 */
    out[7] = t39;
    const double t40 = params[4]*params[5]; /* I1*I3 */
    const double t41 = params[1]*params[1]; /* R*R */
    const double t42 = params[0]*t41; /* m*R*R */
    const double t43 = params[4]*t42; /* I1*m*R*R */
    const double t44 = t19*t43; /* s*s*I1*m*R*R */
    const double t45 = t40 + t44; /* I1*I3 + s*s*I1*m*R*R */
    const double t46 = params[0]*params[5]; /* m*I3 */
    const double t47 = t3*t3; /* b*b */
    const double t48 = t46*t47; /* m*I3*b*b */
    const double t49 = t45 + t48; /* Theta = I1*I3 + s*s*I1*m*R*R + m*I3*b*b */
    const double t50 = sqrt(t49); /* h = sqrt(Theta) */
    out[11] = t50;
    const double t51 = 2.0*t50; /* 2*h */
    const double t52 = x[0]*t43; /* gamma3*I1*m*R*R */
    const double t53 = 2.0*t52; /* 2*gamma3*I1*m*R*R */
    const double t54 = params[5]*t25; /* I3*m*R */
    const double t55 = t3*t54; /* b*I3*m*R */
    const double t56 = 2.0*t55; /* 2*b*I3*m*R */
    const double t57 = t56 - t53; /* d(Theta)/d(gamma3) = 2*b*I3*m*R - 2*gamma3*I1*m*R*R */
    const double t58 = x[3]*t57; /* omega3*d(Theta)/d(gamma3) */
    const double t59 = t58/t51; /* omega3*d(Theta)/d(gamma3)/(2*h) */
    out[8] = t59;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "Jellett", "" },
    { "Routh", "" },
};

static const unsigned char family1_is_free[] = { 1, 0, 0, 1 };

static void family1_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
}

static void family1_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = x[3];
}

static void family1_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
}

static const jlt_equilibria equilibria[] = {
    { .name = "precession", .condition = "g = -omega_n*(I1*gamma3*omega_n + I3*omega3*s + m*e*v_tau)/(m*a3*s^2)",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 3, .obstructs = 0 },
    { .name = "rolling", .condition = "a3 = 0",
      .is_free = family1_is_free,
      .impose = family1_impose,
      .point = family1_point,
      .trace = family1_trace,
      .left_null_count = 0, .obstructs = 0 },
};

static void divisor_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[3]*params[3]; /* a3*a3 */
    const double t2 = t0 + t1; /* R*R + a3*a3 */
    const double t3 = params[1]*params[3]; /* R*a3 */
    const double t4 = t3*x[0]; /* R*a3*gamma3 */
    const double t5 = t4*2.0; /* R*a3*gamma3*2 */
    const double t6 = t2 + t5; /* R*R + a3*a3 + R*a3*gamma3*2 */
    const double t7 = params[0]*t6; /* m*(R*R + a3*a3 + R*a3*gamma3*2) */
    const double t8 = params[4] + t7; /* K = I1 + m*(R*R + a3*a3 + R*a3*gamma3*2) */
    out[0] = t8;
    const double t9 = t8*t8; /* K*K */
    out[1] = t9;
}

static const jlt_region divisors[] = {
    { "a division", "K != 0", 0 },
};

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
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
    { "Jellett", "" },
    { "Routh", "" },
};

static const jlt_named measures[] = {
    { "rho", "" },
};

static const signed char signs_5[] = { 1, -1, 1, 1 };
static const jlt_reversor reversors[] = {
    { signs_5, 5 },
};

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_routh_sphere_general = {
    .model = "routh_sphere",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Sphere with displaced centre of mass rolling without slipping, reduced system",
    .source = "E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243",
    .sha256 = "3411ed6d53d99c328220ac4c0d992bf489a81f74d3bcee4f47f68fdd4a704bc2",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_routh_sphere, .family = jlt_family_routh_sphere, .claims = jlt_claims_routh_sphere,
    .scales = 1,
    .state_count = 4, .param_count = 6, .prepared_count = 56,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 25, 11, 1, 1, 0, 13, 8 }, { 18, 58, 0, 9, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, K/m = gamma3*(2*R*a3) + R^2 + a3^2 + I1/m, v_tau = s*R*omega3 + omega_n*b, e = gamma3*a3 + R, I3/(m*R) + e, a part of d(omega_n)/dt, a part of d(omega_tau)/dt, a part of d(omega_tau)/dt, gamma3*(R*(I1 - I3)) - (a3*I3)" },
    .jacobian = { jacobian, 16, { 5, 48, 27, 1, 1, 0, 17, 17 }, { 48, 209, 0, 37, 1, 0, 20, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, K/m = gamma3*(2*R*a3) + R^2 + a3^2 + I1/m, v_tau = R*omega3*s + omega_n*b, e = gamma3*a3 + R, a part of d(d(omega_tau)/dt)/d(gamma3), gamma3*(R*(I1 - I3)) - (a3*I3), I3/(m*R) + e, a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(omega_n), d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), d(v_tau)/d(gamma3)/R = omega_n - omega3*gamma3*((1)/s^2*Theta*K/m)*Theta*K/m*s, d(numerator of d(omega_tau)/dt over K)/d(gamma3)/m, a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), (I3/I1)*omega3 + gamma3*omega_n*((1)/s^2*Theta*K/m)*Theta*K/m*s, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(m*R*I3)*(I3/(m*R) + e), a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 6, 48, 26, 1, 1, 0, 19, 18 }, { 57, 246, 0, 46, 1, 0, 20, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, K/m = gamma3*(2*R*a3) + R^2 + a3^2 + I1/m, v_tau = R*omega3*s + omega_n*b, e = gamma3*a3 + R, (I1/m)*omega_n*gamma3*((1)/s^2*Theta*K/m)*Theta*K/m*s + (I3/m)*omega3, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), I3/(m*R) + e, a part of d(d(omega_tau)/dt)/d(omega_n), gamma3*(R*(I1 - I3)) - (a3*I3), d(d(omega_n)/dt)/d(omega_tau), d(v_tau)/d(gamma3)/R = omega_n - omega3*gamma3*((1)/s^2*Theta*K/m)*Theta*K/m*s, a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), m*R*a3*I3 - 1/Theta*(m*R*I3)*(I3/(m*R) + e)*d(Theta)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 4, 7, 4, 1, 1, 0, 8, 6 }, { 10, 29, 0, 2, 1, 0, 9, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in K/m = gamma3*(2*R*a3) + R^2 + a3^2 + I1/m, b/R = gamma3 + a3/R, gamma3*(R*(I1 - I3)) - (a3*I3), K/m*(gamma3*(R*(I1 - I3)) - (a3*I3)) - Theta/(m*R^2*I1)*(2*R^2*a3*I1)" },
    .integral_values = { integral_values, 3, { 2, 13, 12, 0, 2, 0, 6, 8 }, { 13, 42, 0, 0, 2, 0, 13, 7 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, v_tau = s*R*omega3 + omega_n*b, E, Jellett" },
    .integral_gradients = { integral_gradients, 12, { 4, 25, 13, 1, 2, 0, 11, 10 }, { 18, 63, 0, 3, 2, 0, 10, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by h: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = R + a3*gamma3, e - a3*gamma3, v_tau = R*omega3*s + omega_n*b, d(Theta)/d(gamma3)/(2*m*R^2*I1) = (I3/(R*I1))*b - gamma3, d(E)/d(omega_n), d(v_tau)/d(gamma3)/R = omega_n - omega3*((1)/h*s)*gamma3*h, v_tau*d(v_tau)/d(gamma3)/R + (e - a3*gamma3)*omega_tau*(a3/R)*omega_tau, d(E)/d(gamma3), d(Jellett)/d(gamma3), d(E)/d(omega3)" },
    .measure_values = { measure_values, 1, { 3, 3, 4, 0, 1, 0, 6, 4 }, { 7, 18, 0, 0, 2, 0, 9, 5 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, (2*R*a3)*gamma3 + R^2 + a3^2, K = m*((2*R*a3)*gamma3 + R^2 + a3^2) + I1" },
    .measure_divergences = { measure_divergences, 1, { 3, 14, 9, 1, 2, 0, 11, 8 }, { 13, 48, 0, 3, 2, 0, 14, 11 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: values and rounding errors grow without bound where it vanishes; divides by h: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*(2*R*a3) + R^2 + a3^2, K = m*(gamma3*(2*R*a3) + R^2 + a3^2) + I1, b/R = gamma3 + a3/R, gamma3*(R*(I1 - I3)) - (a3*I3), ((1)/K*Theta)*Theta*(2*a3) - (gamma3*(R*(I1 - I3)) - (a3*I3))*1/Theta, d(Theta)/d(gamma3) = b/R*(2*m*R^2*I3) - gamma3*(2*m*R^2*I1), 1/Theta*K*d(Theta)/d(gamma3) + 4*m*R*a3, a part of div(rho f)" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .divisor_count = 1, .divisors = divisors, .divisor_values = divisor_values,
    .reversor_count = 1, .reversors = reversors,
    .pole_count = 1, .poles = poles,
    .integral_count = 3, .measure_count = 1, .equilibria_count = 2,
    .integrals = integrals,
    .measures = measures,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_routh_sphere_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_routh_sphere_general) },
#endif
};
