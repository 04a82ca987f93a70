/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    balanced: a3 = 0
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 6   22    9    1    1    2     11    9   (90)
 *  jacobian            11   51   17    1    1    2     14   16   (284)
 *  rhs_jacobian        18   56   17    1    1    2     13   18   (349)
 *  divergence          3   10    3    1    1    0      8    5   (33)
 *  integral_values     3   15   10    0    1    2      8    9   (54)
 *  integral_gradients  2   26   12    1    1    2     10    7   (92)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in 2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2),
 *      2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2), 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1),
 *      V/R = (1/R)*v_nu + omega_tau, gamma3*gamma3*1/s^2*s - s, d(omega3)/dt,
 *      omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, v_tau = gamma3*R*omega_n + omega3*R*s, d(d(v_nu)/dt)/d(omega_n),
 *      d(v_tau)/d(gamma3) = R*omega_n - gamma3*1/s^2*s*R*omega3, omega_n*gamma3*1/s^2*s + omega3*(I3/I1),
 *      (2)*omega_n*gamma3*1/s^2*s + omega3*(I3/I1), d(d(omega_n)/dt)/d(gamma3), d(omega_n)/dt,
 *      d(d(omega3)/dt)/d(gamma3), d(spin)/dt, d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi),
 *      d(d(omega_n)/dt)/d(omega_tau), d(d(omega3)/dt)/d(omega_tau)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_track[];
extern const jlt_claim jlt_claims_spherical_top_track[];
extern const jlt_descriptor *const jlt_family_spherical_top_track[];
extern const jlt_descriptor jlt_kernels_spherical_top_track_balanced;
extern const struct jlt_ball_table jlt_balls_spherical_top_track_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_balanced_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_balanced_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_balanced_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = 0.0;
    out[4] = params[4];
    out[5] = params[5];
}

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
    out[29] = t1;
    const double t2 = params[5]/t1; /* I3/(m*R*R) */
    out[6] = t2;
    const double t3 = params[5]/params[4]; /* I3/I1 */
    out[7] = t3;
    const double t4 = t1*params[4]; /* m*R*R*I1 */
    const double t5 = params[5]*params[5]; /* I3*I3 */
    const double t6 = t1*params[5]; /* m*R*R*I3 */
    const double t7 = t5 + t6; /* I3*I3 + m*R*R*I3 */
    const double t8 = t7/t4; /* (I3*I3 + m*R*R*I3)/(m*R*R*I1) */
    out[8] = t8;
    const double t9 = 1.0/params[1]; /* 1/R */
    out[9] = t9;
    const double t10 = params[4] - params[5]; /* I1 - I3 */
    const double t11 = t10/params[4]; /* (I1 - I3)/I1 */
    out[10] = t11;
    const double t12 = params[1]*2.0; /* R*2 */
    out[11] = t12;
    const double t13 = -t3; /* -I3/I1 */
    out[12] = t13;
    const double t14 = t4*2.0; /* m*R*R*I1*2 */
    const double t15 = t6*2.0; /* m*R*R*I3*2 */
    const double t16 = t14 - t15; /* m*R*R*I1*2 - m*R*R*I3*2 */
    out[13] = t16;
    const double t17 = params[0]*params[0]; /* m*m */
    const double t18 = t0*t0; /* R*R*R*R */
    const double t19 = t17*t18; /* m*m*R*R*R*R */
    const double t20 = params[4]*params[4]; /* I1*I1 */
    const double t21 = t19*t20; /* m*m*R*R*R*R*I1*I1 */
    const double t22 = t7/t21; /* (I3*I3 + m*R*R*I3)/(m*m*R*R*R*R*I1*I1) */
    out[14] = t22;
    const double t23 = t1*t20; /* m*R*R*I1*I1 */
    const double t24 = params[5]/t23; /* I3/(m*R*R*I1*I1) */
    out[15] = t24;
    const double t25 = params[1]*params[4]; /* R*I1 */
    out[27] = t25;
    const double t26 = params[5]/t25; /* I3/(R*I1) */
    out[22] = t26;
    const double t27 = -t26; /* -I3/(R*I1) */
    out[16] = t27;
    const double t28 = 1.0/t4; /* 1/(m*R*R*I1) */
    out[17] = t28;
    const double t29 = (-1.0)/params[1]; /* (-1)/R */
    out[18] = t29;
    const double t30 = params[5]*2.0; /* I3*2 */
    const double t31 = t4 - t6; /* m*R*R*I1 - m*R*R*I3 */
    const double t32 = t30*t31; /* I3*2*(m*R*R*I1 - m*R*R*I3) */
    const double t33 = t32/t23; /* I3*2*(m*R*R*I1 - m*R*R*I3)/(m*R*R*I1*I1) */
    out[19] = t33;
    const double t34 = t7*2.0; /* (I3*I3 + m*R*R*I3)*2 */
    const double t35 = t31*t34; /* (m*R*R*I1 - m*R*R*I3)*(I3*I3 + m*R*R*I3)*2 */
    const double t36 = t35/t21; /* (m*R*R*I1 - m*R*R*I3)*(I3*I3 + m*R*R*I3)*2/(m*m*R*R*R*R*I1*I1) */
    out[20] = t36;
    const double t37 = 2.0*t31; /* 2*(m*R*R*I1 - m*R*R*I3) */
    const double t38 = t37/t4; /* 2*(m*R*R*I1 - m*R*R*I3)/(m*R*R*I1) */
    out[21] = t38;
    const double t39 = params[0]/2.0; /* m/2 */
    out[23] = t39;
    const double t40 = params[4]/2.0; /* I1/2 */
    out[24] = t40;
    const double t41 = params[5]/2.0; /* I3/2 */
    out[25] = t41;
    const double t42 = t1/2.0; /* m*R*R/2 */
    out[26] = t42;
    const double t43 = params[1]*params[5]; /* R*I3 */
    out[28] = t43;
    const double t44 = params[0]*params[1]; /* m*R */
    out[30] = t44;
    const double t45 = -t25; /* -R*I1 */
    out[31] = t45;
    const double t46 = -t43; /* -R*I3 */
    out[32] = t46;
    const double t47 = -t44; /* -m*R */
    out[33] = t47;
    const double t48 = t1 + params[4]; /* m*R*R + I1 */
    out[34] = t48;
    const double t49 = t1 + params[5]; /* m*R*R + I3 */
    out[35] = t49;
    const double t50 = -params[4]; /* -I1 */
    out[36] = t50;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    out[0] = t4;
    const double t5 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t6 = t2 + p[6]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t8 = t3*t7; /* s*Theta/(m*R^2*I1) */
    const double t9 = 1.0/t8; /* 1/(s*Theta/(m*R^2*I1)) */
    const double t10 = x[3]*t7; /* omega_n*Theta/(m*R^2*I1) */
    const double t11 = t9*t10; /* 1/(s*Theta/(m*R^2*I1))*omega_n*Theta/(m*R^2*I1) */
    const double t12 = x[0]*t11; /* gamma3*1/(s*Theta/(m*R^2*I1))*omega_n*Theta/(m*R^2*I1) */
    const double t13 = x[4] + t12; /* omega3 + gamma3*1/(s*Theta/(m*R^2*I1))*omega_n*Theta/(m*R^2*I1) */
    out[6] = t13;
    const double t14 = x[3]*p[1]; /* omega_n*R */
    const double t15 = t13*t14; /* t13*omega_n*R */
    out[1] = t15;
    const double t16 = JLT_FMA(x[4], p[7], t12); /* omega3*I3/I1 + gamma3*1/(s*Theta/(m*R^2*I1))*omega_n*Theta/(m*R^2*I1) */
    const double t17 = x[3]*t16; /* omega_n*t16 */
    const double t18 = -t17; /* -omega_n*t16 */
    out[2] = t18;
    const double t19 = t3*t9; /* 1/(Theta/(m*R^2*I1)) = s*1/(s*Theta/(m*R^2*I1)) */
    const double t20 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t21 = t19*t20; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t22 = p[8]*t21; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t23 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t24 = t19*t23; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t25 = JLT_FNMA(p[7], t24, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t26 = JLT_FMA(t12, t25, t22); /* gamma3*1/(s*Theta/(m*R^2*I1))*omega_n*Theta/(m*R^2*I1)*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) + t22 */
    out[3] = t26;
    const double t27 = x[3]*t24; /* omega_n*1/(Theta/(m*R^2*I1))*V/R */
    const double t28 = x[0]*p[10]; /* gamma3*(I1 - I3)/I1 */
    const double t29 = t3*t28; /* s*gamma3*(I1 - I3)/I1 */
    const double t30 = JLT_FMS(t21, t29, t27); /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*s*gamma3*(I1 - I3)/I1 - omega_n*1/(Theta/(m*R^2*I1))*V/R */
    out[4] = t30;
    const double t31 = -t11; /* -1/(s*Theta/(m*R^2*I1))*omega_n*Theta/(m*R^2*I1) */
    out[5] = t31;
    const double t32 = cos(x[5]); /* C = cos(chi) */
    const double t33 = x[1]*t32; /* v_nu*C */
    const double t34 = sin(x[5]); /* S = sin(chi) */
    const double t35 = x[4]*p[1]; /* omega3*R */
    const double t36 = t3*t35; /* s*omega3*R */
    const double t37 = JLT_FMA(x[0], t14, t36); /* v_tau = gamma3*omega_n*R + s*omega3*R */
    const double t38 = JLT_FMA(t34, t37, t33); /* S*v_tau + v_nu*C */
    out[7] = t38;
    const double t39 = x[1]*t34; /* v_nu*S */
    const double t40 = JLT_FNMA(t32, t37, t39); /* v_nu*S - C*v_tau */
    out[8] = t40;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[58] = 1.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[19] = 0.0;
    out[20] = 0.0;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[49] = 0.0;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[55] = 0.0;
    out[56] = 0.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[65] = 0.0;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[74] = 0.0;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    const double t0 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    out[22] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t5 = p[6] + t3; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(x[0], t4, t5); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t7 = t3*t6; /* s^2*Theta/(m*R^2*I1) */
    const double t8 = 1.0/t7; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t9 = t6*t8; /* 1/s^2 = Theta/(m*R^2*I1)*1/(s^2*Theta/(m*R^2*I1)) */
    const double t10 = t3*t8; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t11 = sqrt(t3); /* s = sqrt(s^2) */
    out[2] = t11;
    const double t12 = t9*t11; /* 1/s^2*s */
    const double t13 = -t12; /* -1/s^2*s */
    out[48] = t13;
    const double t14 = x[0]*t12; /* gamma3*1/s^2*s */
    out[57] = t14;
    const double t15 = x[2]*t10; /* omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t16 = p[8]*t15; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[31] = t16;
    const double t17 = x[4]*t10; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t18 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t19 = t10*t18; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t20 = -t19; /* -1/(Theta/(m*R^2*I1))*V/R */
    out[39] = t20;
    const double t21 = x[0]*t11; /* gamma3*s */
    const double t22 = x[3]*t14; /* omega_n*gamma3*1/s^2*s */
    const double t23 = p[14]*t15; /* (I3^2 + m*R^2*I3)/(m^2*R^4*I1^2)*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t24 = t15*t21; /* omega_tau*1/(Theta/(m*R^2*I1))*gamma3*s */
    const double t25 = t17*t23; /* omega3*1/(Theta/(m*R^2*I1))*t23 */
    const double t26 = p[10]*t24; /* (I1 - I3)/I1*omega_tau*1/(Theta/(m*R^2*I1))*gamma3*s */
    out[40] = t26;
    const double t27 = p[10]*t17; /* (I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) */
    const double t28 = t24*t27; /* omega_tau*1/(Theta/(m*R^2*I1))*gamma3*s*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) */
    const double t29 = JLT_FMA(p[8], t17, t22); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega3*1/(Theta/(m*R^2*I1)) + omega_n*gamma3*1/s^2*s */
    const double t30 = x[3]*t9; /* omega_n*1/s^2 */
    const double t31 = t12*t30; /* 1/s^2*s*omega_n*1/s^2 */
    out[54] = t31;
    const double t32 = t9*t22; /* 1/s^2*omega_n*gamma3*1/s^2*s */
    const double t33 = -t32; /* -1/s^2*omega_n*gamma3*1/s^2*s */
    out[45] = t33;
    const double t34 = x[3]*p[1]; /* omega_n*R */
    out[13] = t34;
    const double t35 = t31*t34; /* 1/s^2*s*omega_n*1/s^2*omega_n*R */
    out[9] = t35;
    const double t36 = p[1]*x[4]; /* R*omega3 */
    const double t37 = JLT_FMA(p[11], t22, t36); /* 2*R*omega_n*gamma3*1/s^2*s + R*omega3 */
    out[12] = t37;
    const double t38 = x[0]*p[13]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t39 = t10*t22; /* 1/(Theta/(m*R^2*I1))*omega_n*gamma3*1/s^2*s */
    const double t40 = JLT_FNMA(p[7], t39, t29); /* t29 - I3/I1*1/(Theta/(m*R^2*I1))*omega_n*gamma3*1/s^2*s */
    out[29] = t40;
    const double t41 = x[3]*t10; /* omega_n*1/(Theta/(m*R^2*I1)) */
    const double t42 = JLT_FMS(t21, t27, t41); /* gamma3*s*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) - omega_n*1/(Theta/(m*R^2*I1)) */
    out[38] = t42;
    const double t43 = JLT_FNMA(t19, t41, t28); /* t28 - 1/(Theta/(m*R^2*I1))*V/R*omega_n*1/(Theta/(m*R^2*I1)) */
    const double t44 = p[18]*t41; /* (-1/R)*omega_n*1/(Theta/(m*R^2*I1)) */
    out[37] = t44;
    const double t45 = (-2.0)*t22; /* (-2)*omega_n*gamma3*1/s^2*s */
    const double t46 = JLT_FMA(x[4], p[12], t45); /* omega3*(-I3/I1) + (-2)*omega_n*gamma3*1/s^2*s */
    out[21] = t46;
    const double t47 = x[2]*t27; /* omega_tau*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1)) */
    const double t48 = p[16]*t39; /* (-I3/(R*I1))*1/(Theta/(m*R^2*I1))*omega_n*gamma3*1/s^2*s */
    out[28] = t48;
    const double t49 = p[15]*t19; /* I3/(m*R^2*I1^2)*1/(Theta/(m*R^2*I1))*V/R */
    const double t50 = JLT_FNMA(t39, t49, t25); /* omega3*1/(Theta/(m*R^2*I1))*t23 - 1/(Theta/(m*R^2*I1))*omega_n*gamma3*1/s^2*s*I3/(m*R^2*I1^2)*1/(Theta/(m*R^2*I1))*V/R */
    const double t51 = t38*t50; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*t50 */
    const double t52 = p[17]*t38; /* 1/(m*R^2*I1)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t53 = t43*t52; /* (t28 - 1/(Theta/(m*R^2*I1))*V/R*omega_n*1/(Theta/(m*R^2*I1)))*1/(m*R^2*I1)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t54 = JLT_FNMA(p[7], t19, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t55 = JLT_FMA(t31, t54, t51); /* 1/s^2*s*omega_n*1/s^2*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) + gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*t50 */
    out[27] = t55;
    const double t56 = t14*t54; /* gamma3*1/s^2*s*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    out[30] = t56;
    const double t57 = x[3]*t31; /* omega_n*1/s^2*s*omega_n*1/s^2 */
    const double t58 = -t57; /* -omega_n*1/s^2*s*omega_n*1/s^2 */
    out[18] = t58;
    const double t59 = sin(x[5]); /* S = sin(chi) */
    out[73] = t59;
    const double t60 = JLT_FNMA(t14, t36, t34); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*R*omega3 */
    const double t61 = t11*t36; /* s*R*omega3 */
    const double t62 = JLT_FMA(x[0], t34, t61); /* v_tau = gamma3*omega_n*R + s*R*omega3 */
    const double t63 = t59*t60; /* S*d(v_tau)/d(gamma3) */
    out[63] = t63;
    const double t64 = cos(x[5]); /* C = cos(chi) */
    out[64] = t64;
    const double t65 = t60*t64; /* d(v_tau)/d(gamma3)*C */
    const double t66 = -t65; /* -d(v_tau)/d(gamma3)*C */
    out[72] = t66;
    const double t67 = x[0]*p[1]; /* gamma3*R */
    const double t68 = t59*t67; /* S*gamma3*R */
    out[66] = t68;
    const double t69 = t64*t67; /* C*gamma3*R */
    const double t70 = -t69; /* -C*gamma3*R */
    out[75] = t70;
    const double t71 = p[1]*t11; /* R*s */
    const double t72 = JLT_FMS(x[0], t14, t11); /* gamma3*gamma3*1/s^2*s - s */
    const double t73 = JLT_FNMA(t47, t72, t53); /* t53 - omega_tau*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1))*(gamma3*gamma3*1/s^2*s - s) */
    out[36] = t73;
    const double t74 = x[2]*t14; /* omega_tau*gamma3*1/s^2*s */
    const double t75 = -t74; /* -omega_tau*gamma3*1/s^2*s */
    out[0] = t75;
    const double t76 = t59*t71; /* S*R*s */
    out[67] = t76;
    const double t77 = t64*t71; /* C*R*s */
    const double t78 = -t77; /* -C*R*s */
    out[76] = t78;
    const double t79 = x[1]*t59; /* v_nu*S */
    const double t80 = JLT_FMS(t62, t64, t79); /* v_tau*C - v_nu*S */
    out[68] = t80;
    const double t81 = x[1]*t64; /* v_nu*C */
    const double t82 = JLT_FMA(t59, t62, t81); /* S*v_tau + v_nu*C */
    out[77] = t82;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[67] = 1.0;
    out[10] = 0.0;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[19] = 0.0;
    out[20] = 0.0;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    out[29] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[55] = 0.0;
    out[56] = 0.0;
    out[58] = 0.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[64] = 0.0;
    out[65] = 0.0;
    out[68] = 0.0;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[74] = 0.0;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[83] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = 0.0;
    const double t0 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    out[31] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t4 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t5 = p[6] + t3; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(x[0], t4, t5); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t7 = t3*t6; /* s^2*Theta/(m*R^2*I1) */
    const double t8 = 1.0/t7; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t9 = t6*t8; /* 1/s^2 = Theta/(m*R^2*I1)*1/(s^2*Theta/(m*R^2*I1)) */
    const double t10 = t3*t8; /* 1/(Theta/(m*R^2*I1)) = s^2*1/(s^2*Theta/(m*R^2*I1)) */
    const double t11 = sqrt(t3); /* s = sqrt(s^2) */
    out[11] = t11;
    const double t12 = x[2]*t11; /* omega_tau*s */
    out[0] = t12;
    const double t13 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t14 = t10*t13; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t15 = -t14; /* -1/(Theta/(m*R^2*I1))*V/R */
    out[48] = t15;
    const double t16 = t9*t11; /* 1/s^2*s */
    const double t17 = -t16; /* -1/s^2*s */
    out[57] = t17;
    const double t18 = x[4]*t10; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t19 = x[0]*p[10]; /* gamma3*(I1 - I3)/I1 */
    const double t20 = t11*t19; /* s*gamma3*(I1 - I3)/I1 */
    const double t21 = x[0]*t16; /* gamma3*1/s^2*s */
    out[66] = t21;
    const double t22 = x[3]*t16; /* omega_n*1/s^2*s */
    const double t23 = -t22; /* -omega_n*1/s^2*s */
    out[5] = t23;
    const double t24 = t9*t22; /* 1/s^2*omega_n*1/s^2*s */
    out[63] = t24;
    const double t25 = x[2]*t18; /* omega_tau*omega3*1/(Theta/(m*R^2*I1)) */
    const double t26 = p[1]*t11; /* R*s */
    const double t27 = JLT_FMS(x[0], t21, t11); /* gamma3*gamma3*1/s^2*s - s */
    const double t28 = x[0]*t10; /* gamma3*1/(Theta/(m*R^2*I1)) */
    const double t29 = p[19]*t14; /* 2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2)*1/(Theta/(m*R^2*I1))*V/R */
    const double t30 = t28*t29; /* gamma3*1/(Theta/(m*R^2*I1))*t29 */
    const double t31 = p[1]*x[3]; /* R*omega_n */
    out[22] = t31;
    const double t32 = t24*t31; /* 1/s^2*omega_n*1/s^2*s*R*omega_n */
    out[18] = t32;
    const double t33 = x[3]*t21; /* omega_n*gamma3*1/s^2*s */
    const double t34 = t30*t33; /* gamma3*1/(Theta/(m*R^2*I1))*t29*omega_n*gamma3*1/s^2*s */
    const double t35 = t9*t33; /* 1/s^2*omega_n*gamma3*1/s^2*s */
    const double t36 = -t35; /* -1/s^2*omega_n*gamma3*1/s^2*s */
    out[54] = t36;
    const double t37 = x[4]*p[7]; /* omega3*I3/I1 */
    const double t38 = t20*t25; /* s*gamma3*(I1 - I3)/I1*omega_tau*omega3*1/(Theta/(m*R^2*I1)) */
    const double t39 = JLT_FNMA(x[3], t14, t38); /* s*gamma3*(I1 - I3)/I1*omega_tau*omega3*1/(Theta/(m*R^2*I1)) - omega_n*1/(Theta/(m*R^2*I1))*V/R */
    out[4] = t39;
    const double t40 = JLT_FNMA(p[7], t14, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t41 = t21*t40; /* gamma3*1/s^2*s*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    out[39] = t41;
    const double t42 = x[4]*t26; /* omega3*R*s */
    const double t43 = JLT_FMA(x[0], t31, t42); /* v_tau = gamma3*R*omega_n + omega3*R*s */
    const double t44 = p[1]*x[4]; /* R*omega3 */
    const double t45 = JLT_FMA(p[11], t33, t44); /* 2*R*omega_n*gamma3*1/s^2*s + R*omega3 */
    out[21] = t45;
    const double t46 = JLT_FNMA(t21, t44, t31); /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*1/s^2*s*R*omega3 */
    const double t47 = x[2]*t21; /* omega_tau*gamma3*1/s^2*s */
    const double t48 = -t47; /* -omega_tau*gamma3*1/s^2*s */
    out[9] = t48;
    const double t49 = t33 + t37; /* omega_n*gamma3*1/s^2*s + omega3*I3/I1 */
    const double t50 = x[3]*t49; /* omega_n*(omega_n*gamma3*1/s^2*s + omega3*I3/I1) */
    const double t51 = -t50; /* -omega_n*(omega_n*gamma3*1/s^2*s + omega3*I3/I1) */
    out[2] = t51;
    const double t52 = JLT_FMA(2.0, t33, t37); /* 2*omega_n*gamma3*1/s^2*s + omega3*I3/I1 */
    const double t53 = -t52; /* -(2*omega_n*gamma3*1/s^2*s + omega3*I3/I1) */
    out[30] = t53;
    const double t54 = cos(x[5]); /* C = cos(chi) */
    out[73] = t54;
    const double t55 = sin(x[5]); /* S = sin(chi) */
    out[82] = t55;
    const double t56 = t46*t55; /* d(v_tau)/d(gamma3)*S */
    out[72] = t56;
    const double t57 = t46*t54; /* d(v_tau)/d(gamma3)*C */
    const double t58 = -t57; /* -d(v_tau)/d(gamma3)*C */
    out[81] = t58;
    const double t59 = t26*t55; /* R*s*S */
    out[76] = t59;
    const double t60 = t26*t54; /* R*s*C */
    const double t61 = -t60; /* -R*s*C */
    out[85] = t61;
    const double t62 = p[20]*t28; /* 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t63 = JLT_FMS(t25, t62, t34); /* omega_tau*omega3*1/(Theta/(m*R^2*I1))*t62 - gamma3*1/(Theta/(m*R^2*I1))*t29*omega_n*gamma3*1/s^2*s */
    const double t64 = JLT_FMA(t24, t40, t63); /* 1/s^2*omega_n*1/s^2*s*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) + t63 */
    out[36] = t64;
    const double t65 = p[21]*t28; /* 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t66 = t39*t65; /* t39*t65 */
    const double t67 = t33*t40; /* omega_n*gamma3*1/s^2*s*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    const double t68 = JLT_FMA(p[8], t25, t67); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*omega3*1/(Theta/(m*R^2*I1)) + t67 */
    out[3] = t68;
    const double t69 = x[3]*t24; /* omega_n*1/s^2*omega_n*1/s^2*s */
    const double t70 = -t69; /* -omega_n*1/s^2*omega_n*1/s^2*s */
    out[27] = t70;
    const double t71 = p[10]*t25; /* (I1 - I3)/I1*omega_tau*omega3*1/(Theta/(m*R^2*I1)) */
    const double t72 = JLT_FNMA(t27, t71, t66); /* t39*t65 - (gamma3*gamma3*1/s^2*s - s)*(I1 - I3)/I1*omega_tau*omega3*1/(Theta/(m*R^2*I1)) */
    out[45] = t72;
    const double t73 = x[0]*p[1]; /* gamma3*R */
    const double t74 = t55*t73; /* S*gamma3*R */
    out[75] = t74;
    const double t75 = t54*t73; /* C*gamma3*R */
    const double t76 = -t75; /* -C*gamma3*R */
    out[84] = t76;
    const double t77 = x[4] + t33; /* omega3 + omega_n*gamma3*1/s^2*s */
    out[6] = t77;
    const double t78 = t31*t77; /* R*omega_n*(omega3 + omega_n*gamma3*1/s^2*s) */
    out[1] = t78;
    const double t79 = x[1]*t54; /* v_nu*C */
    const double t80 = JLT_FMA(t43, t55, t79); /* v_tau*S + v_nu*C */
    out[7] = t80;
    out[86] = t80;
    const double t81 = t43*t54; /* v_tau*C */
    const double t82 = x[1]*t55; /* v_nu*S */
    const double t83 = t82 - t81; /* v_nu*S - v_tau*C */
    out[8] = t83;
    const double t84 = t81 - t82; /* v_tau*C - v_nu*S */
    out[77] = t84;
    const double t85 = t10*t33; /* 1/(Theta/(m*R^2*I1))*omega_n*gamma3*1/s^2*s */
    const double t86 = JLT_FMA(p[8], t18, t33); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega3*1/(Theta/(m*R^2*I1)) + omega_n*gamma3*1/s^2*s */
    const double t87 = JLT_FNMA(p[7], t85, t86); /* t86 - I3/I1*1/(Theta/(m*R^2*I1))*omega_n*gamma3*1/s^2*s */
    out[38] = t87;
    const double t88 = p[16]*t85; /* (-I3/(R*I1))*1/(Theta/(m*R^2*I1))*omega_n*gamma3*1/s^2*s */
    out[37] = t88;
    const double t89 = x[2]*t10; /* omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t90 = x[3]*t10; /* omega_n*1/(Theta/(m*R^2*I1)) */
    const double t91 = JLT_FMS(t18, t20, t90); /* omega3*1/(Theta/(m*R^2*I1))*s*gamma3*(I1 - I3)/I1 - omega_n*1/(Theta/(m*R^2*I1)) */
    out[47] = t91;
    const double t92 = p[18]*t90; /* (-1/R)*omega_n*1/(Theta/(m*R^2*I1)) */
    out[46] = t92;
    const double t93 = t20*t89; /* s*gamma3*(I1 - I3)/I1*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[49] = t93;
    const double t94 = p[8]*t89; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[40] = t94;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t4 = p[6] + t2; /* I3/(m*R^2) + s^2 */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s^2 */
    const double t6 = t2*t5; /* s^2*Theta/(m*R^2*I1) */
    const double t7 = 1.0/t6; /* 1/(s^2*Theta/(m*R^2*I1)) */
    const double t8 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t9 = p[22]*t8; /* I3/(R*I1)*V */
    const double t10 = t5*t9; /* Theta/(m*R^2*I1)*I3/(R*I1)*V */
    const double t11 = sqrt(t2); /* s = sqrt(s^2) */
    const double t12 = x[0]*t2; /* gamma3*s^2 */
    const double t13 = t11*t12; /* s*gamma3*s^2 */
    const double t14 = t7*t13; /* 1/(s^2*Theta/(m*R^2*I1))*s*gamma3*s^2 */
    const double t15 = p[10]*x[2]; /* (I1 - I3)/I1*omega_tau */
    const double t16 = JLT_FNMA(t7, t10, t15); /* (I1 - I3)/I1*omega_tau - 1/(s^2*Theta/(m*R^2*I1))*Theta/(m*R^2*I1)*I3/(R*I1)*V */
    const double t17 = t14*t16; /* 1/(s^2*Theta/(m*R^2*I1))*s*gamma3*s^2*t16 */
    out[0] = t17;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[23]*x[1]; /* 1/2*m*v_nu */
    const double t1 = x[1]*t0; /* v_nu*1/2*m*v_nu */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = JLT_FMA(x[2], x[2], t2); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t4 = p[25]*x[4]; /* 1/2*I3*omega3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t7 = t5*t6; /* (1 - gamma3)*(1 + gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t9 = x[4]*t8; /* omega3*s */
    const double t10 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t11 = t9 + t10; /* v_tau/R = omega3*s + omega_n*gamma3 */
    const double t12 = p[26]*t11; /* 1/2*m*R^2*v_tau/R */
    const double t13 = JLT_FMA(x[4], t4, t1); /* omega3*1/2*I3*omega3 + v_nu*1/2*m*v_nu */
    const double t14 = JLT_FMA(p[24], t3, t13); /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) + omega3*1/2*I3*omega3 + v_nu*1/2*m*v_nu */
    const double t15 = JLT_FMA(t11, t12, t14); /* v_tau/R*1/2*m*R^2*v_tau/R + t14 */
    out[0] = t15;
    const double t16 = x[3]*p[27]; /* omega_n*R*I1 */
    const double t17 = t8*t16; /* s*omega_n*R*I1 */
    const double t18 = x[4]*p[28]; /* omega3*R*I3 */
    const double t19 = JLT_FNMA(x[0], t18, t17); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    out[1] = t19;
    const double t20 = cos(x[5]); /* C = cos(chi) */
    const double t21 = t10*p[4]; /* omega_n*gamma3*I1 */
    const double t22 = JLT_FMA(t9, p[5], t21); /* omega3*s*I3 + omega_n*gamma3*I1 */
    const double t23 = JLT_FMA(t11, p[29], t22); /* M_nu = v_tau/R*m*R^2 + omega3*s*I3 + omega_n*gamma3*I1 */
    const double t24 = t20*t23; /* C*M_nu */
    const double t25 = sin(x[5]); /* S = sin(chi) */
    const double t26 = x[2]*p[4]; /* omega_tau*I1 */
    const double t27 = JLT_FNMA(x[1], p[30], t26); /* M_tau = omega_tau*I1 - v_nu*m*R */
    const double t28 = JLT_FMA(t25, t27, t24); /* S*M_tau + C*M_nu */
    out[2] = t28;
    const double t29 = t23*t25; /* M_nu*S */
    const double t30 = JLT_FNMA(t20, t27, t29); /* M_nu*S - C*M_tau */
    out[3] = t30;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = x[0]*p[32]; /* gamma3*(-R*I3) */
    out[13] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = p[27]*t5; /* R*I1*s */
    out[12] = t6;
    const double t7 = x[4]*t5; /* omega3*s */
    const double t8 = JLT_FMA(x[3], x[0], t7); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t9 = p[29]*t8; /* m*R^2*v_tau/R */
    const double t10 = x[3]*p[4]; /* omega_n*I1 */
    const double t11 = JLT_FMA(x[0], t9, t10); /* gamma3*m*R^2*v_tau/R + omega_n*I1 */
    out[3] = t11;
    const double t12 = x[0]/t5; /* gamma3/s */
    const double t13 = x[4]*p[5]; /* omega3*I3 */
    const double t14 = JLT_FMA(t5, t9, t13); /* s*m*R^2*v_tau/R + omega3*I3 */
    out[4] = t14;
    const double t15 = JLT_FMA(x[0], t10, t9); /* gamma3*omega_n*I1 + m*R^2*v_tau/R */
    const double t16 = JLT_FNMA(t12, t13, t10); /* omega_n*I1 - gamma3/s*omega3*I3 */
    const double t17 = JLT_FMA(t5, t13, t15); /* M_nu = s*omega3*I3 + gamma3*omega_n*I1 + m*R^2*v_tau/R */
    const double t18 = p[35]*t5; /* d(M_nu)/d(omega3) = (I3 + m*R^2)*s */
    const double t19 = JLT_FNMA(x[4], t12, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*gamma3/s */
    const double t20 = t9*t19; /* m*R^2*v_tau/R*d(v_tau)/d(gamma3)/R */
    out[0] = t20;
    const double t21 = JLT_FMA(p[29], t19, t16); /* d(M_nu)/d(gamma3) = m*R^2*d(v_tau)/d(gamma3)/R + omega_n*I1 - gamma3/s*omega3*I3 */
    const double t22 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t22;
    const double t23 = JLT_FNMA(x[1], p[30], t22); /* M_tau = I1*omega_tau - v_nu*m*R */
    const double t24 = x[3]*p[31]; /* omega_n*(-R*I1) */
    const double t25 = t12*t24; /* gamma3/s*omega_n*(-R*I1) */
    const double t26 = JLT_FMA(x[4], p[32], t25); /* omega3*(-R*I3) + gamma3/s*omega_n*(-R*I1) */
    out[9] = t26;
    const double t27 = cos(x[5]); /* C = cos(chi) */
    const double t28 = t21*t27; /* d(M_nu)/d(gamma3)*C */
    out[18] = t28;
    const double t29 = t18*t27; /* d(M_nu)/d(omega3)*C */
    out[22] = t29;
    const double t30 = p[30]*t27; /* m*R*C */
    out[28] = t30;
    const double t31 = p[36]*t27; /* (-I1)*C */
    out[29] = t31;
    const double t32 = sin(x[5]); /* S = sin(chi) */
    const double t33 = t21*t32; /* d(M_nu)/d(gamma3)*S */
    out[27] = t33;
    const double t34 = t18*t32; /* d(M_nu)/d(omega3)*S */
    out[31] = t34;
    const double t35 = p[33]*t32; /* (-m*R)*S */
    out[19] = t35;
    const double t36 = p[4]*t32; /* I1*S */
    out[20] = t36;
    const double t37 = x[0]*p[34]; /* d(M_nu)/d(omega_n) = gamma3*(I1 + m*R^2) */
    const double t38 = t27*t37; /* C*d(M_nu)/d(omega_n) */
    out[21] = t38;
    const double t39 = t32*t37; /* S*d(M_nu)/d(omega_n) */
    out[30] = t39;
    const double t40 = t17*t32; /* M_nu*S */
    const double t41 = JLT_FMS(t23, t27, t40); /* M_tau*C - M_nu*S */
    out[23] = t41;
    const double t42 = t17*t27; /* M_nu*C */
    const double t43 = JLT_FMA(t23, t32, t42); /* M_tau*S + M_nu*C */
    out[32] = t43;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double x5[JLT_JET_ORDER_MAX + 1];
    double x6[JLT_JET_ORDER_MAX + 1];
    double x7[JLT_JET_ORDER_MAX + 1];
    double x8[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double u45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double u47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = x6[0] = x[6];
    coefficients[7] = x7[0] = x[7];
    coefficients[8] = x8[0] = x[8];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t12[k] = x0[k]*p[7];
        t13[k] = t5[k] + (k == 0 ? p[6] : 0);
        t14[k] = jlt_jet_product(x0, t12, k) + t13[k];
        t15[k] = jlt_jet_product(t6, t14, k);
        t16[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t15, t16, k);
        t17[k] = jlt_jet_product(x3, t14, k);
        t18[k] = jlt_jet_product(t16, t17, k);
        t19[k] = jlt_jet_product(x0, t18, k);
        t20[k] = x4[k] + t19[k];
        t22[k] = x3[k]*p[1];
        t23[k] = jlt_jet_product(t20, t22, k);
        t24[k] = x4[k]*p[7] + t19[k];
        t25[k] = jlt_jet_product(x3, t24, k);
        t26[k] = -t25[k];
        t28[k] = jlt_jet_product(t6, t16, k);
        t29[k] = jlt_jet_product(x2, x4, k);
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = p[8]*t30[k];
        t34[k] = p[9]*x1[k] + x2[k];
        t35[k] = jlt_jet_product(t28, t34, k);
        t36[k] = x2[k] - p[7]*t35[k];
        t37[k] = jlt_jet_product(t19, t36, k) + t31[k];
        t38[k] = jlt_jet_product(x3, t35, k);
        t40[k] = x0[k]*p[10];
        t41[k] = jlt_jet_product(t6, t40, k);
        t42[k] = jlt_jet_product(t30, t41, k) - t38[k];
        t43[k] = -t18[k];
        t45[k] = jlt_jet_cosine(x5, t45, u45, k);
        t46[k] = jlt_jet_product(x1, t45, k);
        t47[k] = jlt_jet_sine(x5, t47, u47, k);
        t48[k] = x4[k]*p[1];
        t49[k] = jlt_jet_product(t6, t48, k);
        t50[k] = jlt_jet_product(x0, t22, k) + t49[k];
        t51[k] = jlt_jet_product(t47, t50, k) + t46[k];
        t52[k] = jlt_jet_product(x1, t47, k);
        t53[k] = t52[k] - jlt_jet_product(t45, t50, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t23[k]/(k + 1);
        next[2] = x2[k + 1] = t26[k]/(k + 1);
        next[3] = x3[k + 1] = t37[k]/(k + 1);
        next[4] = x4[k + 1] = t42[k]/(k + 1);
        next[5] = x5[k + 1] = t43[k]/(k + 1);
        next[6] = x6[k + 1] = t20[k]/(k + 1);
        next[7] = x7[k + 1] = t51[k]/(k + 1);
        next[8] = x8[k + 1] = t53[k]/(k + 1);
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
    const double v_a3 = (0.0);
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
    out[5] = (-v_omega_n/v_s);
    out[6] = (v_omega3)
        + (v_gamma3*v_omega_n/v_s);
    const double complex v_chi = x[5];
    const double complex v_C = ccos(v_chi);
    const double complex v_S = csin(v_chi);
    const double complex v_v_tau = (v_omega_n*v_b + v_R*v_omega3*v_s);
    out[7] = (v_v_nu*v_C)
        + (v_S*v_v_tau);
    out[8] = (v_v_nu*v_S)
        + (-v_C*v_v_tau);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "chi", "rad", "direction of nu in the plane: precession", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "spin", "rad", "proper rotation about the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "x", "m", "centre of mass, along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "y", "m", "centre of mass, along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    { "M_x", "a3 = 0" },
    { "M_y", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_track_balanced = {
    .model = "spherical_top_track",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .state_count = 9, .param_count = 6, .block_count = 37,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 9, { 6, 22, 9, 1, 1, 2, 11, 9 }, { 17, 59, 0, 11, 1, 2, 11, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in d(spin)/dt, a part of d(omega_tau)/dt, V/R = (1/R)*v_nu + omega_tau, omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, d(omega_n)/dt, d(omega3)/dt, v_tau = gamma3*omega_n*R + s*omega3*R, d(x)/dt, d(y)/dt" },
    .jacobian = { jacobian, 81, { 11, 51, 17, 1, 1, 2, 14, 16 }, { 45, 196, 0, 40, 1, 2, 14, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*m*R^2*I1 - 2*m*R^2*I3, V/R = (1/R)*v_nu + omega_tau, d(d(v_nu)/dt)/d(omega_n), d(d(omega_n)/dt)/d(omega_tau), d(d(omega3)/dt)/d(omega_tau), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega_n), a part of d(d(omega_n)/dt)/d(gamma3), omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, d(d(omega_n)/dt)/d(gamma3), d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*R*omega3, v_tau = gamma3*omega_n*R + s*R*omega3, gamma3*gamma3*1/s^2*s - s, d(d(omega3)/dt)/d(gamma3), d(d(x)/dt)/d(chi), d(d(y)/dt)/d(chi)" },
    .rhs_jacobian = { rhs_jacobian, 90, { 18, 56, 17, 1, 1, 2, 13, 18 }, { 57, 238, 0, 51, 1, 2, 14, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2), 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2), 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), V/R = (1/R)*v_nu + omega_tau, gamma3*gamma3*1/s^2*s - s, d(omega3)/dt, omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, v_tau = gamma3*R*omega_n + omega3*R*s, d(d(v_nu)/dt)/d(omega_n), d(v_tau)/d(gamma3) = R*omega_n - gamma3*1/s^2*s*R*omega3, omega_n*gamma3*1/s^2*s + omega3*(I3/I1), (2)*omega_n*gamma3*1/s^2*s + omega3*(I3/I1), d(d(omega_n)/dt)/d(gamma3), d(omega_n)/dt, d(d(omega3)/dt)/d(gamma3), d(spin)/dt, d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi), d(d(omega_n)/dt)/d(omega_tau), d(d(omega3)/dt)/d(omega_tau)" },
    .divergence = { divergence, 1, { 3, 10, 3, 1, 1, 0, 8, 5 }, { 6, 24, 0, 2, 1, 0, 10, 6 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, a part of the divergence" },
    .integral_values = { integral_values, 4, { 3, 15, 10, 0, 1, 2, 8, 9 }, { 12, 39, 0, 0, 1, 2, 10, 7 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_tau/R = omega3*s + omega_n*gamma3, G, M_nu = v_tau/R*(m*R^2) + omega3*s*I3 + omega_n*gamma3*I1, M_tau = omega_tau*I1 - v_nu*(m*R), M_x, M_y" },
    .integral_gradients = { integral_gradients, 36, { 2, 26, 12, 1, 1, 2, 10, 7 }, { 19, 67, 0, 3, 1, 2, 9, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in v_tau/R = omega_n*gamma3 + omega3*s, d(E)/d(omega_n), d(E)/d(omega3), M_nu = s*omega3*I3 + gamma3*omega_n*I1 + (m*R^2)*v_tau/R, d(v_tau)/d(gamma3)/R = omega_n - omega3*(gamma3/s), d(M_nu)/d(gamma3) = (m*R^2)*d(v_tau)/d(gamma3)/R + omega_n*I1 - (gamma3/s)*omega3*I3, M_tau = I1*omega_tau - v_nu*(m*R), d(G)/d(gamma3), d(M_x)/d(chi), d(M_y)/d(chi)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_track_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_track_balanced_baseline,
        &jlt_batch_spherical_top_track_balanced_avx2,
        &jlt_batch_spherical_top_track_balanced_avx512,
    },
#endif
};
