/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Table:      spherical_top_track, SHA-256 625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 7   29   16    1    1    2     13   12   (116)
 *  jacobian            13   65   34    1    1    2     16   24   (415)
 *  rhs_jacobian        20   77   36    1    1    2     18   28   (500)
 *  divergence          3   14    8    1    1    0     14    7   (54)
 *  integral_values     2   12    9    0    1    0      6    8   (43)
 *  integral_gradients  2   16    9    1    1    0      6    7   (53)
 *  observe_values      4    9    6    0    1    4      5    8   (37)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R,
 *      a part of d(d(omega_n)/dt)/d(gamma3), V = omega_tau*e + v_nu, (m*R)*e + I3, d(d(v_nu)/dt)/d(omega_n),
 *      d(spin)/dt, numerator of d(omega_n)/dt over Theta, d(omega_n)/dt, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)),
 *      I1*gamma3*omega_n*((1)/s^2*Theta*D)*Theta*D*s + omega3*I3, numerator of d(omega_tau)/dt over D,
 *      a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n),
 *      b*omega_n*((1)/s^2*Theta*D)*Theta*D*s - R*omega3, d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1),
 *      a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3),
 *      gamma3*omega_tau*gamma3*((1)/s^2*Theta*D)*Theta*D*s - omega_tau*s,
 *      d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(gamma3),
 *      a part of d(d(omega3)/dt)/d(gamma3), v_tau = s*R*omega3 + omega_n*b,
 *      s*omega3*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))) + e*omega_n*(m*R*I1),
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau), d(d(omega_n)/dt)/d(omega_tau),
 *      (2*I1)*gamma3*omega_n*((1)/s^2*Theta*D)*Theta*D*s + omega3*I3, a part of d(d(omega_tau)/dt)/d(gamma3),
 *      d(v_tau)/d(gamma3) = omega_n*R - gamma3*((1)/s^2*Theta*D)*Theta*D*s*R*omega3, a part of d(d(v_nu)/dt)/d(gamma3),
 *      b*omega_n*((1)/s^2*Theta*D)*Theta*D*s + R*omega3, d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi)
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
extern const jlt_descriptor jlt_kernels_spherical_top_track_general;
extern const struct jlt_ball_table jlt_balls_spherical_top_track_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_avx512;

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
    out[41] = t12;
    const double t13 = params[5]/t12; /* I3/(I1*R) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[32] = t14;
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
    out[33] = t25;
    const double t26 = t25/params[4]; /* a3*a3*m*2/I1 */
    out[19] = t26;
    const double t27 = params[4]*2.0; /* I1*2 */
    out[34] = t27;
    const double t28 = params[5]/t27; /* I3/(I1*2) */
    out[20] = t28;
    const double t29 = -params[5]; /* -I3 */
    out[35] = t29;
    const double t30 = -t11; /* -I3/I1 */
    out[21] = t30;
    const double t31 = t3*t24; /* R*R*m*2 */
    const double t32 = params[4]*t31; /* I1*R*R*m*2 */
    out[22] = t32;
    const double t33 = params[1]*t24; /* R*m*2 */
    const double t34 = params[5]*t33; /* I3*R*m*2 */
    out[23] = t34;
    const double t35 = params[5]*t14; /* I3*m*R */
    out[24] = t35;
    const double t36 = params[3]*t14; /* a3*m*R */
    const double t37 = params[5]*t36; /* I3*a3*m*R */
    out[25] = t37;
    const double t38 = params[5]*params[5]; /* I3*I3 */
    out[26] = t38;
    const double t39 = params[4]*t14; /* I1*m*R */
    out[27] = t39;
    const double t40 = t4*t19; /* m*R*R*(I1 - I3) */
    out[28] = t40;
    const double t41 = -t39; /* -I1*m*R */
    out[29] = t41;
    const double t42 = params[0]*params[3]; /* m*a3 */
    const double t43 = params[5]*t42; /* I3*m*a3 */
    out[36] = t43;
    const double t44 = params[4]*t36; /* I1*a3*m*R */
    out[37] = t44;
    const double t45 = params[0]/2.0; /* m/2 */
    out[38] = t45;
    const double t46 = params[4]/2.0; /* I1/2 */
    out[39] = t46;
    const double t47 = params[5]/2.0; /* I3/2 */
    out[40] = t47;
    const double t48 = -t12; /* -I1*R */
    out[42] = t48;
    const double t49 = params[1]*params[5]; /* R*I3 */
    const double t50 = -t49; /* -R*I3 */
    out[43] = t50;
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
    const double t7 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = t6*t7; /* Theta/(m*R^2*I1)*D/I1 */
    const double t9 = t2*t8; /* s^2*Theta/(m*R^2*I1)*D/I1 */
    const double t10 = 1.0/t9; /* 1/(s^2*Theta/(m*R^2*I1)*D/I1) */
    const double t11 = x[3]*t8; /* omega_n*Theta/(m*R^2*I1)*D/I1 */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    const double t13 = t11*t12; /* omega_n*Theta/(m*R^2*I1)*D/I1*s */
    const double t14 = t2*t10; /* 1/((D/I1)*(Theta/(m*R^2*I1))) = s^2*1/(s^2*Theta/(m*R^2*I1)*D/I1) */
    const double t15 = t10*t13; /* 1/(s^2*Theta/(m*R^2*I1)*D/I1)*omega_n*Theta/(m*R^2*I1)*D/I1*s */
    const double t16 = t7*t14; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/((D/I1)*(Theta/(m*R^2*I1))) */
    const double t17 = t6*t14; /* Theta/(m*R^2*I1)*1/((D/I1)*(Theta/(m*R^2*I1))) */
    const double t18 = t4*t15; /* I3/(R^2*I1)*b*t15 */
    const double t19 = -t15; /* -t15 */
    out[5] = t19;
    const double t20 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t21 = x[0]*t20; /* gamma3*omega_tau*m*a3^2/I1 */
    const double t22 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t23 = x[2]*t12; /* omega_tau*s */
    out[0] = t23;
    const double t24 = t21*t23; /* gamma3*omega_tau*m*a3^2/I1*omega_tau*s */
    const double t25 = JLT_FNMA(p[9], t12, t24); /* gamma3*omega_tau*m*a3^2/I1*omega_tau*s - m*g*a3/I1*s */
    const double t26 = p[12] + t22; /* I3/(m*R) + e */
    const double t27 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = p[11]*t26; /* I3/(R*I1)*(I3/(m*R) + e) */
    const double t29 = t16*t27; /* 1/(Theta/(m*R^2*I1))*V */
    const double t30 = x[4]*t16; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t31 = x[0]*t15; /* gamma3*t15 */
    const double t32 = JLT_FMA(t28, t30, t31); /* I3/(R*I1)*(I3/(m*R) + e)*omega3*1/(Theta/(m*R^2*I1)) + gamma3*t15 */
    const double t33 = x[2]*t32; /* omega_tau*t32 */
    const double t34 = JLT_FNMA(t18, t29, t33); /* omega_tau*t32 - I3/(R^2*I1)*b*t15*1/(Theta/(m*R^2*I1))*V */
    out[3] = t34;
    const double t35 = x[4] + t31; /* omega3 + gamma3*t15 */
    out[6] = t35;
    const double t36 = JLT_FMA(x[4], p[10], t31); /* omega3*I3/I1 + gamma3*t15 */
    const double t37 = JLT_FNMA(x[3], t36, t25); /* gamma3*omega_tau*m*a3^2/I1*omega_tau*s - m*g*a3/I1*s - omega_n*(omega3*I3/I1 + gamma3*t15) */
    const double t38 = t17*t37; /* Theta/(m*R^2*I1)*1/((D/I1)*(Theta/(m*R^2*I1)))*t37 */
    out[2] = t38;
    const double t39 = x[3]*p[13]; /* omega_n*1/R */
    const double t40 = t29*t39; /* 1/(Theta/(m*R^2*I1))*V*omega_n*1/R */
    const double t41 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t42 = t23*t41; /* omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t43 = JLT_FMA(t30, t42, t40); /* omega3*1/(Theta/(m*R^2*I1))*omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + 1/(Theta/(m*R^2*I1))*V*omega_n*1/R */
    const double t44 = -t43; /* -t43 */
    out[4] = t44;
    const double t45 = p[1]*x[4]; /* R*omega3 */
    const double t46 = JLT_FMA(t3, t15, t45); /* b*t15 + R*omega3 */
    const double t47 = x[3]*t46; /* omega_n*(b*t15 + R*omega3) */
    out[1] = t47;
    const double t48 = x[3]*t3; /* omega_n*b */
    const double t49 = JLT_FMA(t12, t45, t48); /* v_tau = s*R*omega3 + omega_n*b */
    const double t50 = cos(x[5]); /* C = cos(chi) */
    const double t51 = sin(x[5]); /* S = sin(chi) */
    const double t52 = x[1]*t50; /* v_nu*C */
    const double t53 = JLT_FMA(t49, t51, t52); /* v_tau*S + v_nu*C */
    out[7] = t53;
    const double t54 = x[1]*t51; /* v_nu*S */
    const double t55 = JLT_FNMA(t49, t50, t54); /* v_nu*S - v_tau*C */
    out[8] = t55;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[58] = 1.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = t4*p[18]; /* b*m*I3 */
    const double t6 = JLT_FMA(t2, p[17], p[16]); /* s^2*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*b*m*I3 + s^2*m*R^2*I1 + I1*I3 */
    const double t8 = JLT_FMA(t2, p[6], 1.0); /* D/I1 = s^2*m*a3^2/I1 + 1 */
    const double t9 = t2*t7; /* s^2*Theta */
    const double t10 = t8*t9; /* D/I1*s^2*Theta */
    const double t11 = 1.0/t10; /* 1/(D/I1*s^2*Theta) */
    const double t12 = t8*t11; /* D/I1*1/(D/I1*s^2*Theta) */
    const double t13 = t3*t7; /* s*Theta */
    const double t14 = t12*t13; /* D/I1*1/(D/I1*s^2*Theta)*s*Theta */
    const double t15 = x[0]*t14; /* gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta */
    out[57] = t15;
    const double t16 = x[2]*t15; /* omega_tau*gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta */
    const double t17 = -t16; /* -omega_tau*gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta */
    out[0] = t17;
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
    const double t18 = t14*x[3]; /* D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n */
    const double t19 = p[1]*x[3]; /* R*omega_n */
    out[13] = t19;
    const double t20 = t4*t18; /* b*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n */
    const double t21 = JLT_FMA(t15, t20, t19); /* gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta*b*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n + R*omega_n */
    const double t22 = t18*t21; /* D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*t21 */
    out[9] = t22;
    const double t23 = p[1]*x[4]; /* R*omega3 */
    const double t24 = JLT_FMA(t20, 2.0, t23); /* b*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*2 + R*omega3 */
    out[12] = t24;
    const double t25 = t9*t11; /* 1/(D/I1) = s^2*Theta*1/(D/I1*s^2*Theta) */
    const double t26 = x[0]*p[19]; /* gamma3*2*m*a3^2/I1 */
    const double t27 = t25*t26; /* 1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t28 = t3*t27; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t29 = t28 - t15; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 - gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta */
    const double t30 = p[9]*t29; /* m*g*a3/I1*t29 */
    const double t31 = JLT_FMA(x[0], t29, t3); /* gamma3*t29 + s */
    const double t32 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t33 = x[2]*t32; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t34 = t14*t18; /* D/I1*1/(D/I1*s^2*Theta)*s*Theta*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n */
    const double t35 = JLT_FMS(t31, t33, t30); /* (gamma3*t29 + s)*omega_tau*omega_tau*m*a3^2/I1 - m*g*a3/I1*t29 */
    const double t36 = JLT_FNMA(t18, t34, t35); /* t35 - D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*t34 */
    const double t37 = t25*t36; /* 1/(D/I1)*(t35 - D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*t34) */
    const double t38 = x[3]*t25; /* omega_n*1/(D/I1) */
    const double t39 = x[0]*t18; /* gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n */
    const double t40 = JLT_FMA(x[4], p[10], t39); /* omega3*I3/I1 + gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n */
    const double t41 = t27*t38; /* 1/(D/I1)*gamma3*2*m*a3^2/I1*omega_n*1/(D/I1) */
    const double t42 = JLT_FNMA(t40, t41, t37); /* 1/(D/I1)*(t35 - D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*t34) - t40*1/(D/I1)*gamma3*2*m*a3^2/I1*omega_n*1/(D/I1) */
    out[18] = t42;
    const double t43 = x[2]*t28; /* omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[20] = t43;
    const double t44 = JLT_FMA(x[4], p[20], t39); /* omega3*1/2*I3/I1 + gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n */
    const double t45 = t25*(-2.0); /* 1/(D/I1)*(-2) */
    const double t46 = t44*t45; /* t44*1/(D/I1)*(-2) */
    out[21] = t46;
    const double t47 = t38*p[21]; /* omega_n*1/(D/I1)*(-I3/I1) */
    out[22] = t47;
    const double t48 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t49 = JLT_FMA(x[2], t48, x[1]); /* V = omega_tau*e + v_nu */
    const double t50 = t14*t49; /* D/I1*1/(D/I1*s^2*Theta)*s*Theta*V */
    const double t51 = x[2]*p[3]; /* omega_tau*a3 */
    const double t52 = x[0]*p[22]; /* gamma3*2*m*R^2*I1 */
    const double t53 = JLT_FMS(t4, p[23], t52); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t54 = t2*t12; /* 1/Theta = s^2*D/I1*1/(D/I1*s^2*Theta) */
    const double t55 = t49*t54; /* V*1/Theta */
    const double t56 = JLT_FNMA(t53, t55, t51); /* omega_tau*a3 - d(Theta)/d(gamma3)*V*1/Theta */
    const double t57 = JLT_FMA(t15, t50, t56); /* gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta*D/I1*1/(D/I1*s^2*Theta)*s*Theta*V + omega_tau*a3 - d(Theta)/d(gamma3)*V*1/Theta */
    const double t58 = t5*t54; /* b*m*I3*1/Theta */
    const double t59 = t18*t58; /* D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*b*m*I3*1/Theta */
    const double t60 = t18*p[24]; /* D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*m*R*I3 */
    const double t61 = t55*t60; /* V*1/Theta*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*m*R*I3 */
    const double t62 = t14*t34; /* D/I1*1/(D/I1*s^2*Theta)*s*Theta*t34 */
    out[54] = t62;
    const double t63 = x[4]*t54; /* omega3*1/Theta */
    const double t64 = JLT_FMA(t48, p[24], p[26]); /* e*m*R*I3 + I3^2 */
    const double t65 = t54*t64; /* 1/Theta*(e*m*R*I3 + I3^2) */
    const double t66 = JLT_FNMA(t53, t65, p[25]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(e*m*R*I3 + I3^2) */
    const double t67 = JLT_FMA(t63, t66, t62); /* omega3*1/Theta*(m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(e*m*R*I3 + I3^2)) + D/I1*1/(D/I1*s^2*Theta)*s*Theta*t34 */
    const double t68 = JLT_FMS(x[2], t67, t61); /* omega_tau*t67 - V*1/Theta*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*m*R*I3 */
    const double t69 = JLT_FNMA(t57, t59, t68); /* t68 - t57*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*b*m*I3*1/Theta */
    out[27] = t69;
    const double t70 = -t59; /* -D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*b*m*I3*1/Theta */
    out[28] = t70;
    const double t71 = JLT_FMA(t63, t64, t39); /* omega3*1/Theta*(e*m*R*I3 + I3^2) + gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n */
    const double t72 = JLT_FNMA(t48, t59, t71); /* t71 - e*D/I1*1/(D/I1*s^2*Theta)*s*Theta*omega_n*b*m*I3*1/Theta */
    out[29] = t72;
    const double t73 = t5*t14; /* b*m*I3*D/I1*1/(D/I1*s^2*Theta)*s*Theta */
    const double t74 = JLT_FNMA(t55, t73, t16); /* omega_tau*gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta - V*1/Theta*b*m*I3*D/I1*1/(D/I1*s^2*Theta)*s*Theta */
    out[30] = t74;
    const double t75 = x[2]*t65; /* omega_tau*1/Theta*(e*m*R*I3 + I3^2) */
    out[31] = t75;
    const double t76 = x[3]*p[27]; /* omega_n*m*R*I1 */
    const double t77 = t54*t76; /* 1/Theta*omega_n*m*R*I1 */
    const double t78 = t56*t77; /* (omega_tau*a3 - d(Theta)/d(gamma3)*V*1/Theta)*1/Theta*omega_n*m*R*I1 */
    const double t79 = JLT_FNMA(x[0], p[28], p[25]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t80 = t15*t79; /* gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t81 = t3*t79; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t82 = t54*t81; /* 1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t83 = JLT_FMA(t3, p[28], t80); /* s*m*R^2*(I1 - I3) + t80 */
    const double t84 = JLT_FMA(t53, t82, t83); /* d(Theta)/d(gamma3)*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + s*m*R^2*(I1 - I3) + t80 */
    const double t85 = x[2]*t63; /* omega_tau*omega3*1/Theta */
    const double t86 = JLT_FMS(t84, t85, t78); /* t84*omega_tau*omega3*1/Theta - t78 */
    out[36] = t86;
    const double t87 = -t77; /* -1/Theta*omega_n*m*R*I1 */
    out[37] = t87;
    const double t88 = t48*t77; /* e*1/Theta*omega_n*m*R*I1 */
    const double t89 = JLT_FMA(t63, t81, t88); /* omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*1/Theta*omega_n*m*R*I1 */
    const double t90 = -t89; /* -t89 */
    out[38] = t90;
    const double t91 = t55*p[29]; /* V*1/Theta*(-m*R*I1) */
    out[39] = t91;
    const double t92 = x[2]*t82; /* omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t93 = -t92; /* -omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[40] = t93;
    const double t94 = t15*t34; /* gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta*t34 */
    const double t95 = -t94; /* -gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta*t34 */
    out[45] = t95;
    const double t96 = -t14; /* -D/I1*1/(D/I1*s^2*Theta)*s*Theta */
    out[48] = t96;
    const double t97 = sin(x[5]); /* S = sin(chi) */
    out[73] = t97;
    const double t98 = JLT_FNMA(t15, t23, t19); /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*D/I1*1/(D/I1*s^2*Theta)*s*Theta*R*omega3 */
    const double t99 = t97*t98; /* S*d(v_tau)/d(gamma3) */
    out[63] = t99;
    const double t100 = cos(x[5]); /* C = cos(chi) */
    out[64] = t100;
    const double t101 = t4*t97; /* b*S */
    out[66] = t101;
    const double t102 = t3*p[1]; /* s*R */
    const double t103 = t97*t102; /* S*s*R */
    out[67] = t103;
    const double t104 = x[1]*t97; /* v_nu*S */
    const double t105 = t4*x[3]; /* b*omega_n */
    const double t106 = JLT_FMA(x[4], t102, t105); /* v_tau = omega3*s*R + b*omega_n */
    const double t107 = JLT_FMS(t100, t106, t104); /* C*v_tau - v_nu*S */
    out[68] = t107;
    const double t108 = t98*t100; /* d(v_tau)/d(gamma3)*C */
    const double t109 = -t108; /* -d(v_tau)/d(gamma3)*C */
    out[72] = t109;
    const double t110 = t4*t100; /* b*C */
    const double t111 = -t110; /* -b*C */
    out[75] = t111;
    const double t112 = t100*t102; /* C*s*R */
    const double t113 = -t112; /* -C*s*R */
    out[76] = t113;
    const double t114 = x[1]*t100; /* v_nu*C */
    const double t115 = JLT_FMA(t97, t106, t114); /* S*v_tau + v_nu*C */
    out[77] = t115;
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
    out[11] = t11;
    const double t12 = t8*t11; /* Theta*D*s */
    const double t13 = t10*t12; /* 1/(s^2*Theta*D)*Theta*D*s */
    const double t14 = t2*t10; /* 1/(D*Theta) = s^2*1/(s^2*Theta*D) */
    const double t15 = t7*t14; /* 1/Theta = D*1/(D*Theta) */
    const double t16 = t6*t14; /* 1/D = Theta*1/(D*Theta) */
    const double t17 = t4*t13; /* m*I3*b*1/(s^2*Theta*D)*Theta*D*s */
    const double t18 = -t13; /* -1/(s^2*Theta*D)*Theta*D*s */
    out[57] = t18;
    const double t19 = x[3]*t13; /* omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t20 = -t19; /* -omega_n*1/(s^2*Theta*D)*Theta*D*s */
    out[5] = t20;
    const double t21 = t3*t19; /* b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t22 = x[0]*t13; /* gamma3*1/(s^2*Theta*D)*Theta*D*s */
    out[66] = t22;
    const double t23 = x[2]*t11; /* omega_tau*s */
    out[0] = t23;
    const double t24 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t25 = p[18]*t21; /* m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t26 = t13*t22; /* 1/(s^2*Theta*D)*Theta*D*s*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t27 = t25*t26; /* m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s*1/(s^2*Theta*D)*Theta*D*s*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t28 = JLT_FMA(p[24], t19, t27); /* m*R*I3*omega_n*1/(s^2*Theta*D)*Theta*D*s + t27 */
    const double t29 = x[0]*t23; /* gamma3*omega_tau*s */
    const double t30 = x[2]*p[30]; /* omega_tau*m*a3^2 */
    const double t31 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = t28*t31; /* (m*R*I3*omega_n*1/(s^2*Theta*D)*Theta*D*s + t27)*V */
    const double t33 = JLT_FMA(p[32], t24, p[5]); /* m*R*e + I3 */
    const double t34 = p[1]*x[4]; /* R*omega3 */
    const double t35 = JLT_FMA(2.0, t21, t34); /* 2*b*omega_n*1/(s^2*Theta*D)*Theta*D*s + R*omega3 */
    out[21] = t35;
    const double t36 = t29*t30; /* gamma3*omega_tau*s*omega_tau*m*a3^2 */
    const double t37 = JLT_FNMA(p[31], t11, t36); /* gamma3*omega_tau*s*omega_tau*m*a3^2 - m*g*a3*s */
    const double t38 = p[33]*t29; /* 2*m*a3^2*gamma3*omega_tau*s */
    const double t39 = t16*t38; /* 1/D*2*m*a3^2*gamma3*omega_tau*s */
    out[29] = t39;
    const double t40 = x[4]*p[5]; /* omega3*I3 */
    const double t41 = x[0]*t19; /* gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t42 = x[4] + t41; /* omega3 + gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    out[6] = t42;
    const double t43 = t25*t31; /* m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s*V */
    const double t44 = x[2]*t33; /* omega_tau*(m*R*e + I3) */
    const double t45 = JLT_FMS(t40, t44, t43); /* numerator of d(omega_n)/dt over Theta = omega3*I3*omega_tau*(m*R*e + I3) - m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s*V */
    const double t46 = t15*t45; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t47 = p[5]*t44; /* I3*omega_tau*(m*R*e + I3) */
    const double t48 = t15*t47; /* 1/Theta*I3*omega_tau*(m*R*e + I3) */
    out[40] = t48;
    const double t49 = JLT_FMA(x[2], t41, t46); /* omega_tau*gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t49;
    const double t50 = x[3]*p[27]; /* omega_n*m*R*I1 */
    const double t51 = JLT_FNMA(x[0], p[28], p[25]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t52 = x[2]*p[37]; /* omega_tau*m*R*a3*I1 */
    const double t53 = x[3]*t52; /* omega_n*omega_tau*m*R*a3*I1 */
    const double t54 = JLT_FMA(p[4], t41, t40); /* I1*gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s + omega3*I3 */
    const double t55 = JLT_FNMA(x[3], t54, t37); /* numerator of d(omega_tau)/dt over D = gamma3*omega_tau*s*omega_tau*m*a3^2 - m*g*a3*s - omega_n*(I1*gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s + omega3*I3) */
    const double t56 = t16*t55; /* 1/D*numerator of d(omega_tau)/dt over D */
    out[2] = t56;
    const double t57 = t31*t50; /* V*omega_n*m*R*I1 */
    const double t58 = t15*t31; /* 1/Theta*V */
    const double t59 = p[29]*t58; /* (-m*R*I1)*1/Theta*V */
    out[48] = t59;
    const double t60 = x[4]*t51; /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t61 = JLT_FMA(t23, t60, t57); /* omega_tau*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*omega_n*m*R*I1 */
    const double t62 = t15*t61; /* 1/Theta*t61 */
    const double t63 = t23*t51; /* omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t64 = t15*t63; /* 1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t65 = -t64; /* -1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[49] = t65;
    const double t66 = -t62; /* -1/Theta*t61 */
    out[4] = t66;
    const double t67 = x[2]*t22; /* omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t68 = JLT_FNMA(t17, t58, t67); /* omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s - m*I3*b*1/(s^2*Theta*D)*Theta*D*s*1/Theta*V */
    out[39] = t68;
    const double t69 = -t67; /* -omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    out[9] = t69;
    const double t70 = p[31]*t22; /* m*g*a3*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t71 = t13*t19; /* 1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t72 = t13*t71; /* 1/(s^2*Theta*D)*Theta*D*s*1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    out[63] = t72;
    const double t73 = p[4]*t19; /* I1*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t74 = JLT_FNMA(t71, t73, t70); /* m*g*a3*gamma3*1/(s^2*Theta*D)*Theta*D*s - 1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s*I1*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t75 = t22*t71; /* gamma3*1/(s^2*Theta*D)*Theta*D*s*1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t76 = -t75; /* -t75 */
    out[54] = t76;
    const double t77 = t21 - t34; /* b*omega_n*1/(s^2*Theta*D)*Theta*D*s - R*omega3 */
    const double t78 = x[2]*p[36]; /* omega_tau*m*a3*I3 */
    const double t79 = JLT_FMA(t77, t78, t32); /* (b*omega_n*1/(s^2*Theta*D)*Theta*D*s - R*omega3)*omega_tau*m*a3*I3 + (m*R*I3*omega_n*1/(s^2*Theta*D)*Theta*D*s + t27)*V */
    const double t80 = x[0]*p[22]; /* gamma3*2*m*R^2*I1 */
    const double t81 = JLT_FMS(p[23], t3, t80); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t82 = JLT_FMA(t46, t81, t79); /* 1/Theta*numerator of d(omega_n)/dt over Theta*d(Theta)/d(gamma3) + t79 */
    const double t83 = t15*t82; /* 1/Theta*t82 */
    const double t84 = JLT_FMS(x[2], t72, t83); /* omega_tau*t72 - 1/Theta*t82 */
    out[36] = t84;
    const double t85 = x[4]*p[28]; /* omega3*m*R^2*(I1 - I3) */
    const double t86 = JLT_FMS(t23, t85, t53); /* omega_tau*s*omega3*m*R^2*(I1 - I3) - omega_n*omega_tau*m*R*a3*I1 */
    const double t87 = JLT_FMS(x[0], t67, t23); /* gamma3*omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s - omega_tau*s */
    const double t88 = JLT_FNMA(t30, t87, t74); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t74 - omega_tau*m*a3^2*t87 */
    const double t89 = JLT_FMA(t60, t67, t86); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s + t86 */
    const double t90 = JLT_FMA(t62, t81, t89); /* 1/Theta*t61*d(Theta)/d(gamma3) + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t91 = t15*t90; /* 1/Theta*t90 */
    out[45] = t91;
    const double t92 = x[3]*t3; /* omega_n*b */
    const double t93 = JLT_FMA(t11, t34, t92); /* v_tau = s*R*omega3 + omega_n*b */
    const double t94 = x[3]*p[1]; /* omega_n*R */
    out[22] = t94;
    const double t95 = t24*t50; /* e*omega_n*m*R*I1 */
    const double t96 = JLT_FMA(t11, t60, t95); /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*omega_n*m*R*I1 */
    const double t97 = t24*t25; /* e*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t98 = JLT_FMS(t33, t40, t97); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = (m*R*e + I3)*omega3*I3 - e*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t99 = JLT_FMA(t15, t98, t41); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    out[38] = t99;
    const double t100 = JLT_FMA(p[34], t41, t40); /* 2*I1*gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s + omega3*I3 */
    const double t101 = p[1]*t11; /* R*s */
    const double t102 = t16*t100; /* 1/D*(2*I1*gamma3*omega_n*1/(s^2*Theta*D)*Theta*D*s + omega3*I3) */
    const double t103 = -t102; /* -t102 */
    out[30] = t103;
    const double t104 = t15*t25; /* 1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t105 = -t104; /* -1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    out[37] = t105;
    const double t106 = t15*t50; /* 1/Theta*omega_n*m*R*I1 */
    const double t107 = t15*t96; /* 1/Theta*t96 */
    const double t108 = -t106; /* -1/Theta*omega_n*m*R*I1 */
    out[46] = t108;
    const double t109 = -t107; /* -1/Theta*t96 */
    out[47] = t109;
    const double t110 = cos(x[5]); /* C = cos(chi) */
    out[73] = t110;
    const double t111 = sin(x[5]); /* S = sin(chi) */
    out[82] = t111;
    const double t112 = t3*t111; /* b*S */
    out[75] = t112;
    const double t113 = t3*t110; /* b*C */
    const double t114 = -t113; /* -b*C */
    out[84] = t114;
    const double t115 = t101*t111; /* R*s*S */
    out[76] = t115;
    const double t116 = t101*t110; /* R*s*C */
    const double t117 = -t116; /* -R*s*C */
    out[85] = t117;
    const double t118 = x[0]*p[33]; /* gamma3*2*m*a3^2 */
    const double t119 = JLT_FMA(t56, t118, t88); /* 1/D*numerator of d(omega_tau)/dt over D*gamma3*2*m*a3^2 + d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    const double t120 = t16*t119; /* 1/D*t119 */
    out[27] = t120;
    const double t121 = JLT_FNMA(t22, t34, t94); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/(s^2*Theta*D)*Theta*D*s*R*omega3 */
    const double t122 = JLT_FMA(t21, t22, t94); /* b*omega_n*1/(s^2*Theta*D)*Theta*D*s*gamma3*1/(s^2*Theta*D)*Theta*D*s + omega_n*R */
    const double t123 = t19*t122; /* omega_n*1/(s^2*Theta*D)*Theta*D*s*t122 */
    out[18] = t123;
    const double t124 = t21 + t34; /* b*omega_n*1/(s^2*Theta*D)*Theta*D*s + R*omega3 */
    const double t125 = x[3]*t124; /* omega_n*(b*omega_n*1/(s^2*Theta*D)*Theta*D*s + R*omega3) */
    out[1] = t125;
    const double t126 = t111*t121; /* S*d(v_tau)/d(gamma3) */
    out[72] = t126;
    const double t127 = t110*t121; /* C*d(v_tau)/d(gamma3) */
    const double t128 = -t127; /* -C*d(v_tau)/d(gamma3) */
    out[81] = t128;
    const double t129 = x[1]*t110; /* v_nu*C */
    const double t130 = JLT_FMA(t93, t111, t129); /* v_tau*S + v_nu*C */
    out[7] = t130;
    out[86] = t130;
    const double t131 = t93*t110; /* v_tau*C */
    const double t132 = x[1]*t111; /* v_nu*S */
    const double t133 = t132 - t131; /* v_nu*S - v_tau*C */
    out[8] = t133;
    const double t134 = t131 - t132; /* v_tau*C - v_nu*S */
    out[77] = t134;
    const double t135 = x[3]*p[35]; /* omega_n*(-I3) */
    const double t136 = t16*t135; /* 1/D*omega_n*(-I3) */
    out[31] = t136;
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
    const double t7 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t4*t7; /* I3/(R^2*I1)*b*D */
    const double t9 = t2*t7; /* s^2*D */
    const double t10 = t6*t9; /* Theta/(m*R^2*I1)*s^2*D */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t12 = t6*t11; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t13 = t9*t11; /* 1/(Theta/(m*R^2*I1)) = s^2*D*1/(Theta/(m*R^2*I1)*s^2*D) */
    const double t14 = p[33]*t2; /* 2*m*a3^2*s^2 */
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
    const double t3 = p[31]*x[0]; /* m*g*a3*gamma3 */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = x[3]*p[39]; /* omega_n*1/2*I1 */
    const double t6 = JLT_FMA(x[3], t5, t3); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t7 = x[3]*t4; /* omega_n*b */
    const double t8 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t10 = p[1]*x[4]; /* R*omega3 */
    const double t11 = JLT_FMA(t8, t10, t7); /* v_tau = s*R*omega3 + omega_n*b */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = x[4]*p[40]; /* omega3*1/2*I3 */
    const double t15 = JLT_FMA(x[4], t14, t6); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(t9, t13, t15); /* D*omega_tau*1/2*omega_tau + t15 */
    const double t17 = x[1]*x[1]; /* v_nu*v_nu */
    const double t18 = JLT_FMA(t11, t11, t17); /* v_tau*v_tau + v_nu*v_nu */
    const double t19 = JLT_FMA(p[38], t18, t16); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t15 */
    out[0] = t19;
    const double t20 = x[3]*p[41]; /* omega_n*R*I1 */
    const double t21 = t8*t20; /* s*omega_n*R*I1 */
    const double t22 = x[4]*p[5]; /* omega3*I3 */
    const double t23 = JLT_FNMA(t4, t22, t21); /* s*omega_n*R*I1 - b*omega3*I3 */
    out[1] = t23;
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
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = p[35]*t4; /* (-I3)*b */
    out[13] = t5;
    const double t6 = sqrt(t3); /* s = sqrt(s^2) */
    const double t7 = p[41]*t6; /* R*I1*s */
    out[12] = t7;
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
    const double t19 = x[3]*p[42]; /* omega_n*(-R*I1) */
    const double t20 = t9*t19; /* s*gamma3/s^2*omega_n*(-R*I1) */
    const double t21 = JLT_FMA(x[4], p[43], t20); /* omega3*(-R*I3) + s*gamma3/s^2*omega_n*(-R*I1) */
    out[9] = t21;
    const double t22 = JLT_FNMA(x[4], t9, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*s*gamma3/s^2 */
    const double t23 = p[32]*t15; /* m*R*v_tau */
    const double t24 = JLT_FMA(t22, t23, t18); /* d(v_tau)/d(gamma3)/R*m*R*v_tau + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    out[0] = t24;
    const double t25 = x[3]*p[4]; /* omega_n*I1 */
    const double t26 = JLT_FMA(t13, t15, t25); /* m*b*v_tau + omega_n*I1 */
    out[3] = t26;
    const double t27 = x[4]*p[5]; /* omega3*I3 */
    const double t28 = JLT_FMA(t6, t23, t27); /* s*m*R*v_tau + omega3*I3 */
    out[4] = t28;
}

static void observe_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = cos(x[5]); /* C = cos(chi) */
    const double t5 = t3*t4; /* s*C */
    out[2] = t5;
    out[6] = t5;
    const double t6 = JLT_FNMA(p[3], t5, x[7]); /* x_contact = x - a3*s*C */
    out[0] = t6;
    const double t7 = sin(x[5]); /* S = sin(chi) */
    const double t8 = t3*t7; /* s*S */
    out[3] = t8;
    out[9] = t8;
    const double t9 = JLT_FNMA(p[3], t8, x[8]); /* y_contact = y - a3*s*S */
    out[1] = t9;
    const double t10 = sin(x[6]); /* Q = sin(spin) */
    const double t11 = t4*t10; /* C*Q */
    const double t12 = cos(x[6]); /* P = cos(spin) */
    const double t13 = t7*t12; /* S*P */
    const double t14 = JLT_FMA(x[0], t11, t13); /* alpha1 = gamma3*C*Q + S*P */
    out[4] = t14;
    const double t15 = t4*t12; /* C*P */
    const double t16 = t7*t10; /* S*Q */
    const double t17 = JLT_FMS(x[0], t15, t16); /* alpha2 = gamma3*C*P - S*Q */
    out[5] = t17;
    const double t18 = JLT_FMS(x[0], t16, t15); /* beta1 = gamma3*S*Q - C*P */
    out[7] = t18;
    const double t19 = JLT_FMA(x[0], t13, t11); /* beta2 = gamma3*S*P + C*Q */
    out[8] = t19;
    const double t20 = t3*t10; /* s*Q */
    const double t21 = -t20; /* -s*Q */
    out[10] = t21;
    const double t22 = t3*t12; /* s*P */
    const double t23 = -t22; /* -s*P */
    out[11] = t23;
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
    double u62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double u63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
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
        t19[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t20[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t21[k] = jlt_jet_product(t19, t20, k);
        t22[k] = jlt_jet_root(t21[k], t22, k);
        t23[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t24[k] = p[8]*t23[k];
        t25[k] = (k == 0 ? p[7] : 0) + t21[k];
        t26[k] = jlt_jet_product(t23, t24, k) + t25[k];
        t27[k] = p[6]*t21[k] + (k == 0 ? 1.0 : 0);
        t28[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t26, t28, k);
        t29[k] = x2[k]*p[6];
        t30[k] = jlt_jet_product(x0, t29, k);
        t31[k] = jlt_jet_product(x2, t22, k);
        t32[k] = jlt_jet_product(t30, t31, k);
        t33[k] = t32[k] - p[9]*t22[k];
        t34[k] = jlt_jet_quotient(x3[k], t22, t34, k);
        t35[k] = -t34[k];
        t36[k] = jlt_jet_product(x0, t34, k);
        t37[k] = x4[k] + t36[k];
        t38[k] = x4[k]*p[10] + t36[k];
        t39[k] = t33[k] - jlt_jet_product(x3, t38, k);
        t40[k] = jlt_jet_quotient(t39[k], t27, t40, k);
        t41[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t42[k] = (k == 0 ? p[12] : 0) + t41[k];
        t43[k] = jlt_jet_product(x2, t41, k) + x1[k];
        t44[k] = p[11]*t42[k];
        t45[k] = jlt_jet_product(t28, t43, k);
        t46[k] = jlt_jet_product(x4, t28, k);
        t47[k] = jlt_jet_product(t44, t46, k) + t36[k];
        t48[k] = jlt_jet_product(x2, t47, k);
        t49[k] = jlt_jet_product(t24, t45, k);
        t50[k] = t48[k] - jlt_jet_product(t34, t49, k);
        t51[k] = x3[k]*p[13];
        t52[k] = jlt_jet_product(t45, t51, k);
        t53[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t54[k] = jlt_jet_product(t31, t53, k);
        t55[k] = jlt_jet_product(t46, t54, k) + t52[k];
        t56[k] = -t55[k];
        t57[k] = p[1]*x4[k];
        t58[k] = jlt_jet_product(t23, t34, k) + t57[k];
        t59[k] = jlt_jet_product(x3, t58, k);
        t60[k] = jlt_jet_product(x3, t23, k);
        t61[k] = jlt_jet_product(t22, t57, k) + t60[k];
        t62[k] = jlt_jet_cosine(x5, t62, u62, k);
        t63[k] = jlt_jet_sine(x5, t63, u63, k);
        t64[k] = jlt_jet_product(x1, t62, k);
        t65[k] = jlt_jet_product(t61, t63, k) + t64[k];
        t66[k] = jlt_jet_product(x1, t63, k);
        t67[k] = t66[k] - jlt_jet_product(t61, t62, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t31[k]/(k + 1);
        next[1] = x1[k + 1] = t59[k]/(k + 1);
        next[2] = x2[k + 1] = t40[k]/(k + 1);
        next[3] = x3[k + 1] = t50[k]/(k + 1);
        next[4] = x4[k + 1] = t56[k]/(k + 1);
        next[5] = x5[k + 1] = t35[k]/(k + 1);
        next[6] = x6[k + 1] = t37[k]/(k + 1);
        next[7] = x7[k + 1] = t65[k]/(k + 1);
        next[8] = x8[k + 1] = t67[k]/(k + 1);
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
};

static const jlt_quantity observes[] = {
    { "x_contact", "m", "contact point, along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y_contact", "m", "contact point, along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "x_axis", "1", "symmetry axis, along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y_axis", "1", "symmetry axis, along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "alpha1", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "alpha2", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "alpha3", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "beta1", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "beta2", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "beta3", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "gamma1", "1", "vertical unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "gamma2", "1", "vertical unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const signed char signs_9[] = { 1, -1, -1, 1, 1, -1, -1, 1, -1 };
static const jlt_reversor reversors[] = {
    { signs_9, 9 },
};

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_spherical_top_track_general = {
    .model = "spherical_top_track",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .scales = 1,
    .state_count = 9, .param_count = 6, .prepared_count = 44,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 9, { 7, 29, 16, 1, 1, 2, 13, 12 }, { 22, 77, 0, 14, 1, 2, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, I3/(m*R) + e, V = omega_tau*e + v_nu, a part of d(omega_n)/dt, d(omega_n)/dt, d(spin)/dt, a part of d(omega_tau)/dt, a part of d(omega_tau)/dt, a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(omega3)/dt, a part of d(v_nu)/dt, v_tau = s*R*omega3 + omega_n*b, d(x)/dt, d(y)/dt" },
    .jacobian = { jacobian, 81, { 13, 65, 34, 1, 1, 2, 16, 24 }, { 61, 296, 0, 55, 1, 2, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega_n), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), omega3*(I3/I1) + gamma3*D/I1*((1)/D/I1*s^2*Theta)*s*Theta*omega_n, d(d(omega_tau)/dt)/d(gamma3), omega3*(1/2*I3/I1) + gamma3*D/I1*((1)/D/I1*s^2*Theta)*s*Theta*omega_n, e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(Theta)/d(gamma3) = b*(2*m*R*I3) - gamma3*(2*m*R^2*I1), omega_tau*a3 - d(Theta)/d(gamma3)*V*1/Theta, a part of d(d(omega_n)/dt)/d(gamma3), e*(m*R*I3) + I3^2, m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(e*(m*R*I3) + I3^2), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), d(d(omega_n)/dt)/d(omega_n), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau), d(v_tau)/d(gamma3) = R*omega_n - gamma3*D/I1*((1)/D/I1*s^2*Theta)*s*Theta*R*omega3, v_tau = omega3*s*R + b*omega_n, d(d(x)/dt)/d(chi), d(d(y)/dt)/d(chi)" },
    .rhs_jacobian = { rhs_jacobian, 90, { 20, 77, 36, 1, 1, 2, 18, 28 }, { 75, 353, 0, 69, 1, 2, 16, 14 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, a part of d(d(omega_n)/dt)/d(gamma3), V = omega_tau*e + v_nu, (m*R)*e + I3, d(d(v_nu)/dt)/d(omega_n), d(spin)/dt, numerator of d(omega_n)/dt over Theta, d(omega_n)/dt, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), I1*gamma3*omega_n*((1)/s^2*Theta*D)*Theta*D*s + omega3*I3, numerator of d(omega_tau)/dt over D, a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), b*omega_n*((1)/s^2*Theta*D)*Theta*D*s - R*omega3, d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), gamma3*omega_tau*gamma3*((1)/s^2*Theta*D)*Theta*D*s - omega_tau*s, d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), v_tau = s*R*omega3 + omega_n*b, s*omega3*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))) + e*omega_n*(m*R*I1), d(numerator of d(omega_n)/dt over Theta)/d(omega_tau), d(d(omega_n)/dt)/d(omega_tau), (2*I1)*gamma3*omega_n*((1)/s^2*Theta*D)*Theta*D*s + omega3*I3, a part of d(d(omega_tau)/dt)/d(gamma3), d(v_tau)/d(gamma3) = omega_n*R - gamma3*((1)/s^2*Theta*D)*Theta*D*s*R*omega3, a part of d(d(v_nu)/dt)/d(gamma3), b*omega_n*((1)/s^2*Theta*D)*Theta*D*s + R*omega3, d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi)" },
    .divergence = { divergence, 1, { 3, 14, 8, 1, 1, 0, 14, 7 }, { 11, 38, 0, 4, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, a part of the divergence, a part of the divergence, e = gamma3*a3 + R, V = omega_tau*e + v_nu, a part of the divergence" },
    .integral_values = { integral_values, 2, { 2, 12, 9, 0, 1, 0, 6, 8 }, { 10, 32, 0, 0, 1, 0, 12, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*R*omega3 + omega_n*b, E, G" },
    .integral_gradients = { integral_gradients, 18, { 2, 16, 9, 1, 1, 0, 6, 7 }, { 12, 38, 0, 2, 1, 0, 8, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*omega3*R + omega_n*b, d(G)/d(gamma3), d(v_tau)/d(gamma3)/R = omega_n - omega3*s*(gamma3/s^2), d(E)/d(gamma3), d(E)/d(omega_n), d(E)/d(omega3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { observe_values, 12, { 4, 9, 6, 0, 1, 4, 5, 8 }, { 9, 23, 0, 0, 1, 4, 6, 8 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in x_contact, y_contact, alpha1, alpha2, beta1, beta2" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .observe_count = 12, .observes = observes,
    .reversor_count = 1, .reversors = reversors,
    .pole_count = 1, .poles = poles,
    .tier = "track", .tier_meaning = "the reduced system with attitude and track by quadratures",
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_track_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_track_general) },
#endif
};
