/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    balanced: a3 = 0
 *  Table:      spherical_top_track, SHA-256 625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 6   22    9    1    1    2     11    8   (90)
 *  jacobian            11   51   17    1    1    2     14   13   (284)
 *  rhs_jacobian        18   56   17    1    1    2     13   19   (349)
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
 *      V/R = (1/R)*v_nu + omega_tau, omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, d(omega3)/dt,
 *      d(d(omega3)/dt)/d(omega_tau), v_tau = gamma3*omega_n*R + omega3*R*s, d(d(v_nu)/dt)/d(omega_n),
 *      d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*omega3*R, d(omega_n)/dt,
 *      gamma3*omega_n*1/s^2*s + omega3*(I3/I1), (2)*gamma3*omega_n*1/s^2*s + omega3*(I3/I1),
 *      gamma3*1/s^2*s*gamma3*((I1 - I3)/I1) - ((I1 - I3)/I1)*s, d(d(omega3)/dt)/d(gamma3), d(spin)/dt,
 *      d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt,
 *      d(d(x)/dt)/d(chi)
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
    out[30] = t1;
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
    const double t17 = params[4]*params[4]; /* I1*I1 */
    const double t18 = t1*t17; /* m*R*R*I1*I1 */
    const double t19 = params[5]/t18; /* I3/(m*R*R*I1*I1) */
    out[14] = t19;
    const double t20 = params[0]*params[0]; /* m*m */
    const double t21 = t0*t0; /* R*R*R*R */
    const double t22 = t20*t21; /* m*m*R*R*R*R */
    const double t23 = t17*t22; /* I1*I1*m*m*R*R*R*R */
    const double t24 = t7/t23; /* (I3*I3 + m*R*R*I3)/(I1*I1*m*m*R*R*R*R) */
    out[15] = t24;
    const double t25 = params[1]*params[4]; /* R*I1 */
    out[28] = t25;
    const double t26 = params[5]/t25; /* I3/(R*I1) */
    out[23] = t26;
    const double t27 = -t26; /* -I3/(R*I1) */
    out[16] = t27;
    const double t28 = (-1.0)/t4; /* (-1)/(m*R*R*I1) */
    out[17] = t28;
    const double t29 = params[5] - params[4]; /* I3 - I1 */
    const double t30 = t29/params[4]; /* (I3 - I1)/I1 */
    out[18] = t30;
    const double t31 = (-1.0)/params[1]; /* (-1)/R */
    out[19] = t31;
    const double t32 = params[5]*2.0; /* I3*2 */
    const double t33 = t4 - t6; /* m*R*R*I1 - m*R*R*I3 */
    const double t34 = t32*t33; /* I3*2*(m*R*R*I1 - m*R*R*I3) */
    const double t35 = t34/t18; /* I3*2*(m*R*R*I1 - m*R*R*I3)/(m*R*R*I1*I1) */
    out[20] = t35;
    const double t36 = t7*2.0; /* (I3*I3 + m*R*R*I3)*2 */
    const double t37 = t33*t36; /* (m*R*R*I1 - m*R*R*I3)*(I3*I3 + m*R*R*I3)*2 */
    const double t38 = t37/t23; /* (m*R*R*I1 - m*R*R*I3)*(I3*I3 + m*R*R*I3)*2/(I1*I1*m*m*R*R*R*R) */
    out[21] = t38;
    const double t39 = 2.0*t33; /* 2*(m*R*R*I1 - m*R*R*I3) */
    const double t40 = t39/t4; /* 2*(m*R*R*I1 - m*R*R*I3)/(m*R*R*I1) */
    out[22] = t40;
    const double t41 = params[0]/2.0; /* m/2 */
    out[24] = t41;
    const double t42 = params[4]/2.0; /* I1/2 */
    out[25] = t42;
    const double t43 = params[5]/2.0; /* I3/2 */
    out[26] = t43;
    const double t44 = t1/2.0; /* m*R*R/2 */
    out[27] = t44;
    const double t45 = params[1]*params[5]; /* R*I3 */
    out[29] = t45;
    const double t46 = params[0]*params[1]; /* m*R */
    out[31] = t46;
    const double t47 = -t25; /* -R*I1 */
    out[32] = t47;
    const double t48 = -t45; /* -R*I3 */
    out[33] = t48;
    const double t49 = -t46; /* -m*R */
    out[34] = t49;
    const double t50 = t1 + params[4]; /* m*R*R + I1 */
    out[35] = t50;
    const double t51 = t1 + params[5]; /* m*R*R + I3 */
    out[36] = t51;
    const double t52 = -params[4]; /* -I1 */
    out[37] = t52;
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
    const double t14 = p[1]*x[3]; /* R*omega_n */
    const double t15 = t13*t14; /* t13*R*omega_n */
    out[1] = t15;
    const double t16 = JLT_FMA(x[4], p[7], t12); /* omega3*I3/I1 + gamma3*1/(s*Theta/(m*R^2*I1))*omega_n*Theta/(m*R^2*I1) */
    const double t17 = x[3]*t16; /* omega_n*t16 */
    const double t18 = -t17; /* -omega_n*t16 */
    out[2] = t18;
    const double t19 = t3*t9; /* 1/(Theta/(m*R^2*I1)) = s*1/(s*Theta/(m*R^2*I1)) */
    const double t20 = x[2]*t19; /* omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t21 = x[4]*p[8]; /* omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t22 = t20*t21; /* omega_tau*1/(Theta/(m*R^2*I1))*omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t23 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t24 = t19*t23; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t25 = JLT_FNMA(p[7], t24, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t26 = JLT_FMA(t12, t25, t22); /* gamma3*1/(s*Theta/(m*R^2*I1))*omega_n*Theta/(m*R^2*I1)*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) + t22 */
    out[3] = t26;
    const double t27 = x[3]*t24; /* omega_n*1/(Theta/(m*R^2*I1))*V/R */
    const double t28 = t3*x[4]; /* s*omega3 */
    const double t29 = x[0]*p[10]; /* gamma3*(I1 - I3)/I1 */
    const double t30 = t28*t29; /* s*omega3*gamma3*(I1 - I3)/I1 */
    const double t31 = JLT_FMS(t20, t30, t27); /* omega_tau*1/(Theta/(m*R^2*I1))*s*omega3*gamma3*(I1 - I3)/I1 - omega_n*1/(Theta/(m*R^2*I1))*V/R */
    out[4] = t31;
    const double t32 = -t11; /* -1/(s*Theta/(m*R^2*I1))*omega_n*Theta/(m*R^2*I1) */
    out[5] = t32;
    const double t33 = cos(x[5]); /* C = cos(chi) */
    const double t34 = x[1]*t33; /* v_nu*C */
    const double t35 = sin(x[5]); /* S = sin(chi) */
    const double t36 = JLT_FMA(x[0], x[3], t28); /* gamma3*omega_n + s*omega3 */
    const double t37 = p[1]*t36; /* v_tau = R*(gamma3*omega_n + s*omega3) */
    const double t38 = JLT_FMA(t35, t37, t34); /* S*v_tau + v_nu*C */
    out[7] = t38;
    const double t39 = x[1]*t35; /* v_nu*S */
    const double t40 = JLT_FNMA(t33, t37, t39); /* v_nu*S - C*v_tau */
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
    const double t14 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t15 = t10*t14; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t16 = -t15; /* -1/(Theta/(m*R^2*I1))*V/R */
    out[39] = t16;
    const double t17 = x[0]*t12; /* gamma3*1/s^2*s */
    out[57] = t17;
    const double t18 = x[3]*t10; /* omega_n*1/(Theta/(m*R^2*I1)) */
    const double t19 = p[19]*t18; /* (-1/R)*omega_n*1/(Theta/(m*R^2*I1)) */
    out[37] = t19;
    const double t20 = t17*t18; /* gamma3*1/s^2*s*omega_n*1/(Theta/(m*R^2*I1)) */
    const double t21 = p[16]*t20; /* (-I3/(R*I1))*gamma3*1/s^2*s*omega_n*1/(Theta/(m*R^2*I1)) */
    out[28] = t21;
    const double t22 = p[14]*t15; /* I3/(m*R^2*I1^2)*1/(Theta/(m*R^2*I1))*V/R */
    const double t23 = t20*t22; /* gamma3*1/s^2*s*omega_n*1/(Theta/(m*R^2*I1))*I3/(m*R^2*I1^2)*1/(Theta/(m*R^2*I1))*V/R */
    const double t24 = x[4]*t10; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t25 = x[2]*t10; /* omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t26 = p[8]*t25; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[31] = t26;
    const double t27 = x[0]*p[10]; /* gamma3*(I1 - I3)/I1 */
    const double t28 = t11*t27; /* s*gamma3*(I1 - I3)/I1 */
    const double t29 = JLT_FMS(t24, t28, t18); /* omega3*1/(Theta/(m*R^2*I1))*s*gamma3*(I1 - I3)/I1 - omega_n*1/(Theta/(m*R^2*I1)) */
    out[38] = t29;
    const double t30 = t15*t18; /* 1/(Theta/(m*R^2*I1))*V/R*omega_n*1/(Theta/(m*R^2*I1)) */
    const double t31 = JLT_FNMA(p[7], t15, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t32 = t17*t31; /* gamma3*1/s^2*s*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    out[30] = t32;
    const double t33 = t25*t28; /* omega_tau*1/(Theta/(m*R^2*I1))*s*gamma3*(I1 - I3)/I1 */
    out[40] = t33;
    const double t34 = t24*t25; /* omega3*1/(Theta/(m*R^2*I1))*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t35 = JLT_FNMA(t28, t34, t30); /* 1/(Theta/(m*R^2*I1))*V/R*omega_n*1/(Theta/(m*R^2*I1)) - s*gamma3*(I1 - I3)/I1*omega3*1/(Theta/(m*R^2*I1))*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t36 = JLT_FNMA(p[15], t34, t23); /* t23 - (I3^2 + m*R^2*I3)/(m^2*R^4*I1^2)*omega3*1/(Theta/(m*R^2*I1))*omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t37 = x[3]*t9; /* omega_n*1/s^2 */
    const double t38 = t12*t37; /* 1/s^2*s*omega_n*1/s^2 */
    out[54] = t38;
    const double t39 = x[3]*p[1]; /* omega_n*R */
    out[13] = t39;
    const double t40 = t38*t39; /* 1/s^2*s*omega_n*1/s^2*omega_n*R */
    out[9] = t40;
    const double t41 = p[1]*x[4]; /* R*omega3 */
    const double t42 = x[0]*p[13]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t43 = t36*t42; /* t36*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t44 = JLT_FMS(t31, t38, t43); /* (omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R)*1/s^2*s*omega_n*1/s^2 - t36*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    out[27] = t44;
    const double t45 = p[17]*t42; /* (-1/(m*R^2*I1))*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t46 = t35*t45; /* t35*(-1/(m*R^2*I1))*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t47 = x[3]*t38; /* omega_n*1/s^2*s*omega_n*1/s^2 */
    const double t48 = -t47; /* -omega_n*1/s^2*s*omega_n*1/s^2 */
    out[18] = t48;
    const double t49 = p[1]*t11; /* R*s */
    const double t50 = JLT_FMS(x[0], t17, t11); /* gamma3*gamma3*1/s^2*s - s */
    const double t51 = x[3]*t17; /* omega_n*gamma3*1/s^2*s */
    const double t52 = t9*t51; /* 1/s^2*omega_n*gamma3*1/s^2*s */
    const double t53 = -t52; /* -1/s^2*omega_n*gamma3*1/s^2*s */
    out[45] = t53;
    const double t54 = JLT_FMA(p[11], t51, t41); /* 2*R*omega_n*gamma3*1/s^2*s + R*omega3 */
    out[12] = t54;
    const double t55 = JLT_FNMA(t17, t41, t39); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*R*omega3 */
    const double t56 = x[2]*t17; /* omega_tau*gamma3*1/s^2*s */
    const double t57 = -t56; /* -omega_tau*gamma3*1/s^2*s */
    out[0] = t57;
    const double t58 = x[2]*p[18]; /* omega_tau*(-(I1 - I3)/I1) */
    const double t59 = t24*t58; /* omega3*1/(Theta/(m*R^2*I1))*omega_tau*(-(I1 - I3)/I1) */
    const double t60 = JLT_FMA(t50, t59, t46); /* (gamma3*gamma3*1/s^2*s - s)*omega3*1/(Theta/(m*R^2*I1))*omega_tau*(-(I1 - I3)/I1) + t35*(-1/(m*R^2*I1))*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    out[36] = t60;
    const double t61 = JLT_FMA(p[8], t24, t51); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega3*1/(Theta/(m*R^2*I1)) + omega_n*gamma3*1/s^2*s */
    const double t62 = JLT_FNMA(p[7], t20, t61); /* t61 - I3/I1*gamma3*1/s^2*s*omega_n*1/(Theta/(m*R^2*I1)) */
    out[29] = t62;
    const double t63 = (-2.0)*t51; /* (-2)*omega_n*gamma3*1/s^2*s */
    const double t64 = JLT_FMA(x[4], p[12], t63); /* omega3*(-I3/I1) + (-2)*omega_n*gamma3*1/s^2*s */
    out[21] = t64;
    const double t65 = sin(x[5]); /* S = sin(chi) */
    out[73] = t65;
    const double t66 = t55*t65; /* d(v_tau)/d(gamma3)*S */
    out[63] = t66;
    const double t67 = t49*t65; /* R*s*S */
    out[67] = t67;
    const double t68 = cos(x[5]); /* C = cos(chi) */
    out[64] = t68;
    const double t69 = t55*t68; /* d(v_tau)/d(gamma3)*C */
    const double t70 = -t69; /* -d(v_tau)/d(gamma3)*C */
    out[72] = t70;
    const double t71 = x[0]*p[1]; /* gamma3*R */
    const double t72 = t65*t71; /* S*gamma3*R */
    out[66] = t72;
    const double t73 = t68*t71; /* C*gamma3*R */
    const double t74 = -t73; /* -C*gamma3*R */
    out[75] = t74;
    const double t75 = x[4]*t49; /* omega3*R*s */
    const double t76 = JLT_FMA(x[0], t39, t75); /* v_tau = gamma3*omega_n*R + omega3*R*s */
    const double t77 = t49*t68; /* R*s*C */
    const double t78 = -t77; /* -R*s*C */
    out[76] = t78;
    const double t79 = x[1]*t65; /* v_nu*S */
    const double t80 = JLT_FMS(t68, t76, t79); /* C*v_tau - v_nu*S */
    out[68] = t80;
    const double t81 = x[1]*t68; /* v_nu*C */
    const double t82 = JLT_FMA(t65, t76, t81); /* S*v_tau + v_nu*C */
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
    const double t13 = t9*t11; /* 1/s^2*s */
    const double t14 = -t13; /* -1/s^2*s */
    out[57] = t14;
    const double t15 = x[4]*t10; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t16 = p[10]*t11; /* (I1 - I3)/I1*s */
    const double t17 = p[1]*t11; /* R*s */
    const double t18 = x[3]*t13; /* omega_n*1/s^2*s */
    const double t19 = x[0]*t13; /* gamma3*1/s^2*s */
    out[66] = t19;
    const double t20 = -t18; /* -omega_n*1/s^2*s */
    out[5] = t20;
    const double t21 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t22 = x[2]*t15; /* omega_tau*omega3*1/(Theta/(m*R^2*I1)) */
    const double t23 = x[0]*t16; /* gamma3*(I1 - I3)/I1*s */
    const double t24 = x[0]*t10; /* gamma3*1/(Theta/(m*R^2*I1)) */
    const double t25 = x[0]*t18; /* gamma3*omega_n*1/s^2*s */
    const double t26 = t9*t18; /* 1/s^2*omega_n*1/s^2*s */
    out[63] = t26;
    const double t27 = t9*t25; /* 1/s^2*gamma3*omega_n*1/s^2*s */
    const double t28 = -t27; /* -1/s^2*gamma3*omega_n*1/s^2*s */
    out[54] = t28;
    const double t29 = x[3]*p[1]; /* omega_n*R */
    out[22] = t29;
    const double t30 = t26*t29; /* 1/s^2*omega_n*1/s^2*s*omega_n*R */
    out[18] = t30;
    const double t31 = x[4]*p[7]; /* omega3*I3/I1 */
    const double t32 = t10*t21; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t33 = -t32; /* -1/(Theta/(m*R^2*I1))*V/R */
    out[48] = t33;
    const double t34 = JLT_FNMA(p[7], t32, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t35 = t19*t34; /* gamma3*1/s^2*s*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    out[39] = t35;
    const double t36 = t22*t23; /* omega_tau*omega3*1/(Theta/(m*R^2*I1))*gamma3*(I1 - I3)/I1*s */
    const double t37 = x[3]*t10; /* omega_n*1/(Theta/(m*R^2*I1)) */
    const double t38 = JLT_FNMA(t21, t37, t36); /* omega_tau*omega3*1/(Theta/(m*R^2*I1))*gamma3*(I1 - I3)/I1*s - V/R*omega_n*1/(Theta/(m*R^2*I1)) */
    out[4] = t38;
    const double t39 = p[20]*t21; /* 2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2)*V/R */
    const double t40 = t24*t39; /* gamma3*1/(Theta/(m*R^2*I1))*2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2)*V/R */
    const double t41 = p[19]*t37; /* (-1/R)*omega_n*1/(Theta/(m*R^2*I1)) */
    out[46] = t41;
    const double t42 = JLT_FMS(t15, t23, t37); /* omega3*1/(Theta/(m*R^2*I1))*gamma3*(I1 - I3)/I1*s - omega_n*1/(Theta/(m*R^2*I1)) */
    out[47] = t42;
    const double t43 = JLT_FMA(p[8], t15, t25); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega3*1/(Theta/(m*R^2*I1)) + gamma3*omega_n*1/s^2*s */
    const double t44 = x[4]*t17; /* omega3*R*s */
    const double t45 = JLT_FMA(x[0], t29, t44); /* v_tau = gamma3*omega_n*R + omega3*R*s */
    const double t46 = x[4]*p[1]; /* omega3*R */
    const double t47 = JLT_FMA(p[11], t25, t46); /* 2*R*gamma3*omega_n*1/s^2*s + omega3*R */
    out[21] = t47;
    const double t48 = JLT_FNMA(t19, t46, t29); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*omega3*R */
    const double t49 = p[21]*t24; /* 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t50 = t22*t49; /* omega_tau*omega3*1/(Theta/(m*R^2*I1))*t49 */
    const double t51 = p[22]*t24; /* 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1)*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t52 = t38*t51; /* t38*t51 */
    const double t53 = JLT_FMA(t26, t34, t50); /* 1/s^2*omega_n*1/s^2*s*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) + omega_tau*omega3*1/(Theta/(m*R^2*I1))*t49 */
    const double t54 = t25*t34; /* gamma3*omega_n*1/s^2*s*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    const double t55 = JLT_FMA(p[8], t22, t54); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*omega3*1/(Theta/(m*R^2*I1)) + t54 */
    out[3] = t55;
    const double t56 = x[3]*t26; /* omega_n*1/s^2*omega_n*1/s^2*s */
    const double t57 = -t56; /* -omega_n*1/s^2*omega_n*1/s^2*s */
    out[27] = t57;
    const double t58 = t25 + t31; /* gamma3*omega_n*1/s^2*s + omega3*I3/I1 */
    const double t59 = x[3]*t58; /* omega_n*(gamma3*omega_n*1/s^2*s + omega3*I3/I1) */
    const double t60 = -t59; /* -omega_n*(gamma3*omega_n*1/s^2*s + omega3*I3/I1) */
    out[2] = t60;
    const double t61 = JLT_FMA(2.0, t25, t31); /* 2*gamma3*omega_n*1/s^2*s + omega3*I3/I1 */
    const double t62 = -t61; /* -(2*gamma3*omega_n*1/s^2*s + omega3*I3/I1) */
    out[30] = t62;
    const double t63 = cos(x[5]); /* C = cos(chi) */
    out[73] = t63;
    const double t64 = sin(x[5]); /* S = sin(chi) */
    out[82] = t64;
    const double t65 = t48*t64; /* d(v_tau)/d(gamma3)*S */
    out[72] = t65;
    const double t66 = t48*t63; /* d(v_tau)/d(gamma3)*C */
    const double t67 = -t66; /* -d(v_tau)/d(gamma3)*C */
    out[81] = t67;
    const double t68 = t17*t64; /* R*s*S */
    out[76] = t68;
    const double t69 = t17*t63; /* R*s*C */
    const double t70 = -t69; /* -R*s*C */
    out[85] = t70;
    const double t71 = x[0]*p[10]; /* gamma3*(I1 - I3)/I1 */
    const double t72 = JLT_FMS(t19, t71, t16); /* gamma3*1/s^2*s*gamma3*(I1 - I3)/I1 - (I1 - I3)/I1*s */
    const double t73 = JLT_FNMA(t22, t72, t52); /* t38*t51 - omega_tau*omega3*1/(Theta/(m*R^2*I1))*(gamma3*1/s^2*s*gamma3*(I1 - I3)/I1 - (I1 - I3)/I1*s) */
    out[45] = t73;
    const double t74 = x[2]*t19; /* omega_tau*gamma3*1/s^2*s */
    const double t75 = -t74; /* -omega_tau*gamma3*1/s^2*s */
    out[9] = t75;
    const double t76 = x[0]*p[1]; /* gamma3*R */
    const double t77 = t64*t76; /* S*gamma3*R */
    out[75] = t77;
    const double t78 = t63*t76; /* C*gamma3*R */
    const double t79 = -t78; /* -C*gamma3*R */
    out[84] = t79;
    const double t80 = x[4] + t25; /* omega3 + gamma3*omega_n*1/s^2*s */
    out[6] = t80;
    const double t81 = t29*t80; /* omega_n*R*(omega3 + gamma3*omega_n*1/s^2*s) */
    out[1] = t81;
    const double t82 = t10*t25; /* 1/(Theta/(m*R^2*I1))*gamma3*omega_n*1/s^2*s */
    const double t83 = JLT_FNMA(t40, t82, t53); /* t53 - t40*1/(Theta/(m*R^2*I1))*gamma3*omega_n*1/s^2*s */
    out[36] = t83;
    const double t84 = JLT_FNMA(p[7], t82, t43); /* t43 - I3/I1*1/(Theta/(m*R^2*I1))*gamma3*omega_n*1/s^2*s */
    out[38] = t84;
    const double t85 = p[16]*t82; /* (-I3/(R*I1))*1/(Theta/(m*R^2*I1))*gamma3*omega_n*1/s^2*s */
    out[37] = t85;
    const double t86 = x[2]*t10; /* omega_tau*1/(Theta/(m*R^2*I1)) */
    const double t87 = t23*t86; /* gamma3*(I1 - I3)/I1*s*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[49] = t87;
    const double t88 = p[8]*t86; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*1/(Theta/(m*R^2*I1)) */
    out[40] = t88;
    const double t89 = x[1]*t63; /* v_nu*C */
    const double t90 = JLT_FMA(t45, t64, t89); /* v_tau*S + v_nu*C */
    out[7] = t90;
    out[86] = t90;
    const double t91 = t45*t63; /* v_tau*C */
    const double t92 = x[1]*t64; /* v_nu*S */
    const double t93 = t92 - t91; /* v_nu*S - v_tau*C */
    out[8] = t93;
    const double t94 = t91 - t92; /* v_tau*C - v_nu*S */
    out[77] = t94;
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
    const double t9 = p[23]*t8; /* I3/(R*I1)*V */
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
    const double t0 = p[24]*x[1]; /* 1/2*m*v_nu */
    const double t1 = x[1]*t0; /* v_nu*1/2*m*v_nu */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = JLT_FMA(x[2], x[2], t2); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t4 = p[26]*x[4]; /* 1/2*I3*omega3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t7 = t5*t6; /* (1 - gamma3)*(1 + gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t9 = x[4]*t8; /* omega3*s */
    const double t10 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t11 = t9 + t10; /* v_tau/R = omega3*s + omega_n*gamma3 */
    const double t12 = p[27]*t11; /* 1/2*m*R^2*v_tau/R */
    const double t13 = JLT_FMA(x[4], t4, t1); /* omega3*1/2*I3*omega3 + v_nu*1/2*m*v_nu */
    const double t14 = JLT_FMA(p[25], t3, t13); /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) + omega3*1/2*I3*omega3 + v_nu*1/2*m*v_nu */
    const double t15 = JLT_FMA(t11, t12, t14); /* v_tau/R*1/2*m*R^2*v_tau/R + t14 */
    out[0] = t15;
    const double t16 = x[3]*p[28]; /* omega_n*R*I1 */
    const double t17 = t8*t16; /* s*omega_n*R*I1 */
    const double t18 = x[4]*p[29]; /* omega3*R*I3 */
    const double t19 = JLT_FNMA(x[0], t18, t17); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    out[1] = t19;
    const double t20 = cos(x[5]); /* C = cos(chi) */
    const double t21 = t10*p[4]; /* omega_n*gamma3*I1 */
    const double t22 = JLT_FMA(t9, p[5], t21); /* omega3*s*I3 + omega_n*gamma3*I1 */
    const double t23 = JLT_FMA(t11, p[30], t22); /* M_nu = v_tau/R*m*R^2 + omega3*s*I3 + omega_n*gamma3*I1 */
    const double t24 = t20*t23; /* C*M_nu */
    const double t25 = sin(x[5]); /* S = sin(chi) */
    const double t26 = x[2]*p[4]; /* omega_tau*I1 */
    const double t27 = JLT_FNMA(x[1], p[31], t26); /* M_tau = omega_tau*I1 - v_nu*m*R */
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
    const double t1 = x[0]*p[33]; /* gamma3*(-R*I3) */
    out[13] = t1;
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = p[28]*t5; /* R*I1*s */
    out[12] = t6;
    const double t7 = x[4]*t5; /* omega3*s */
    const double t8 = JLT_FMA(x[3], x[0], t7); /* v_tau/R = omega_n*gamma3 + omega3*s */
    const double t9 = p[30]*t8; /* m*R^2*v_tau/R */
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
    const double t18 = p[36]*t5; /* d(M_nu)/d(omega3) = (I3 + m*R^2)*s */
    const double t19 = JLT_FNMA(x[4], t12, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*gamma3/s */
    const double t20 = t9*t19; /* m*R^2*v_tau/R*d(v_tau)/d(gamma3)/R */
    out[0] = t20;
    const double t21 = JLT_FMA(p[30], t19, t16); /* d(M_nu)/d(gamma3) = m*R^2*d(v_tau)/d(gamma3)/R + omega_n*I1 - gamma3/s*omega3*I3 */
    const double t22 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t22;
    const double t23 = JLT_FNMA(x[1], p[31], t22); /* M_tau = I1*omega_tau - v_nu*m*R */
    const double t24 = x[3]*p[32]; /* omega_n*(-R*I1) */
    const double t25 = t12*t24; /* gamma3/s*omega_n*(-R*I1) */
    const double t26 = JLT_FMA(x[4], p[33], t25); /* omega3*(-R*I3) + gamma3/s*omega_n*(-R*I1) */
    out[9] = t26;
    const double t27 = cos(x[5]); /* C = cos(chi) */
    const double t28 = t21*t27; /* d(M_nu)/d(gamma3)*C */
    out[18] = t28;
    const double t29 = t18*t27; /* d(M_nu)/d(omega3)*C */
    out[22] = t29;
    const double t30 = p[31]*t27; /* m*R*C */
    out[28] = t30;
    const double t31 = p[37]*t27; /* (-I1)*C */
    out[29] = t31;
    const double t32 = sin(x[5]); /* S = sin(chi) */
    const double t33 = t21*t32; /* d(M_nu)/d(gamma3)*S */
    out[27] = t33;
    const double t34 = t18*t32; /* d(M_nu)/d(omega3)*S */
    out[31] = t34;
    const double t35 = p[34]*t32; /* (-m*R)*S */
    out[19] = t35;
    const double t36 = p[4]*t32; /* I1*S */
    out[20] = t36;
    const double t37 = x[0]*p[35]; /* d(M_nu)/d(omega_n) = gamma3*(I1 + m*R^2) */
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
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double u43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double u45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
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
        t11[k] = jlt_jet_quotient(x3[k], t6, t11, k);
        t12[k] = jlt_jet_product(x0, t11, k);
        t13[k] = x4[k] + t12[k];
        t14[k] = p[1]*x3[k];
        t15[k] = jlt_jet_product(t13, t14, k);
        t17[k] = x4[k]*p[7] + t12[k];
        t18[k] = jlt_jet_product(x3, t17, k);
        t19[k] = -t18[k];
        t22[k] = x0[k]*p[7];
        t23[k] = t5[k] + (k == 0 ? p[6] : 0);
        t24[k] = jlt_jet_product(x0, t22, k) + t23[k];
        t25[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t24, t25, k);
        t26[k] = jlt_jet_product(x2, t25, k);
        t27[k] = x4[k]*p[8];
        t28[k] = jlt_jet_product(t26, t27, k);
        t31[k] = p[9]*x1[k] + x2[k];
        t32[k] = jlt_jet_product(t25, t31, k);
        t33[k] = x2[k] - p[7]*t32[k];
        t34[k] = jlt_jet_product(t12, t33, k) + t28[k];
        t35[k] = jlt_jet_product(x3, t32, k);
        t37[k] = jlt_jet_product(t6, x4, k);
        t38[k] = x0[k]*p[10];
        t39[k] = jlt_jet_product(t37, t38, k);
        t40[k] = jlt_jet_product(t26, t39, k) - t35[k];
        t41[k] = -t11[k];
        t43[k] = jlt_jet_cosine(x5, t43, u43, k);
        t44[k] = jlt_jet_product(x1, t43, k);
        t45[k] = jlt_jet_sine(x5, t45, u45, k);
        t46[k] = jlt_jet_product(x0, x3, k) + t37[k];
        t47[k] = p[1]*t46[k];
        t48[k] = jlt_jet_product(t45, t47, k) + t44[k];
        t49[k] = jlt_jet_product(x1, t45, k);
        t50[k] = t49[k] - jlt_jet_product(t43, t47, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t15[k]/(k + 1);
        next[2] = x2[k + 1] = t19[k]/(k + 1);
        next[3] = x3[k + 1] = t34[k]/(k + 1);
        next[4] = x4[k + 1] = t40[k]/(k + 1);
        next[5] = x5[k + 1] = t41[k]/(k + 1);
        next[6] = x6[k + 1] = t13[k]/(k + 1);
        next[7] = x7[k + 1] = t48[k]/(k + 1);
        next[8] = x8[k + 1] = t50[k]/(k + 1);
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "chi", "rad", "direction of nu in the plane: precession", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 2.0*0x1.921fb54442d18p+1 },
    { "spin", "rad", "proper rotation about the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 2.0*0x1.921fb54442d18p+1 },
    { "x", "m", "centre of mass, along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y", "m", "centre of mass, along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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
    { "M_x", "a3 = 0" },
    { "M_y", "a3 = 0" },
};

static const signed char signs_9[] = { 1, -1, -1, 1, 1, -1, -1, 1, -1 };
static const jlt_reversor reversors[] = {
    { signs_9, 9 },
};

const jlt_descriptor jlt_kernels_spherical_top_track_balanced = {
    .model = "spherical_top_track",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .scales = 1,
    .state_count = 9, .param_count = 6, .prepared_count = 38,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 9, { 6, 22, 9, 1, 1, 2, 11, 8 }, { 17, 59, 0, 11, 1, 2, 11, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in d(spin)/dt, a part of d(omega_tau)/dt, V/R = (1/R)*v_nu + omega_tau, omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, d(omega_n)/dt, d(omega3)/dt, gamma3*omega_n + s*omega3, d(x)/dt, d(y)/dt" },
    .jacobian = { jacobian, 81, { 11, 51, 17, 1, 1, 2, 14, 13 }, { 45, 196, 0, 40, 1, 2, 14, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*m*R^2*I1 - 2*m*R^2*I3, V/R = (1/R)*v_nu + omega_tau, d(d(omega3)/dt)/d(omega_tau), omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), gamma3*gamma3*1/s^2*s - s, d(d(v_nu)/dt)/d(omega_n), d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*R*omega3, d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), d(d(omega_tau)/dt)/d(omega_n), v_tau = gamma3*omega_n*R + omega3*R*s, d(d(x)/dt)/d(chi), d(d(y)/dt)/d(chi)" },
    .rhs_jacobian = { rhs_jacobian, 90, { 18, 56, 17, 1, 1, 2, 13, 19 }, { 57, 238, 0, 51, 1, 2, 14, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in 2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2), 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2), 2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1), V/R = (1/R)*v_nu + omega_tau, omega_tau - (I3/I1)*1/(Theta/(m*R^2*I1))*V/R, d(omega3)/dt, d(d(omega3)/dt)/d(omega_tau), v_tau = gamma3*omega_n*R + omega3*R*s, d(d(v_nu)/dt)/d(omega_n), d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*omega3*R, d(omega_n)/dt, gamma3*omega_n*1/s^2*s + omega3*(I3/I1), (2)*gamma3*omega_n*1/s^2*s + omega3*(I3/I1), gamma3*1/s^2*s*gamma3*((I1 - I3)/I1) - ((I1 - I3)/I1)*s, d(d(omega3)/dt)/d(gamma3), d(spin)/dt, d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi)" },
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
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_track_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_track_balanced) },
#endif
};
