/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Table:      spherical_top_track, SHA-256 6846e2a6e2e89b5e5aa4c7b67fe5e7f138d28ea2677fe5f4b40745ae5674af39
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 6   29   16    1    1    2     13   12   (116)
 *  jacobian            13   67   34    1    1    2     15   23   (415)
 *  rhs_jacobian        21   77   35    1    1    2     16   29   (500)
 *  divergence          2   14    9    1    1    0     11    9   (54)
 *  integral_values     2   12    9    0    1    0      6    8   (43)
 *  integral_gradients  2   16    9    1    1    0      6    7   (53)
 *  observe_values      4    9    6    0    1    4      5    8   (37)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, d(d(v_nu)/dt)/d(omega_n),
 *      m*g*a3 - omega_tau*(m*a3^2)*omega_tau*gamma3, e = gamma3*a3 + R, V = omega_tau*e + v_nu,
 *      m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), R*omega3 - b*omega_n*((1)/s^2*Theta*D)*Theta*D*s, d(spin)/dt,
 *      (m*R)*e + I3, a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3),
 *      d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1),
 *      I1*omega_n*gamma3*((1)/s^2*Theta*D)*Theta*D*s + omega3*I3,
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), numerator of d(omega_n)/dt over Theta,
 *      (2*I1)*omega_n*gamma3*((1)/s^2*Theta*D)*Theta*D*s + omega3*I3,
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau), d(d(omega_n)/dt)/d(omega_tau),
 *      s*omega3*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))) + e*omega_n*(m*R*I1), v_tau = s*R*omega3 + omega_n*b,
 *      d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(gamma3),
 *      d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), d(d(omega_n)/dt)/d(gamma3), d(omega_n)/dt,
 *      d(d(omega_tau)/dt)/d(gamma3), d(v_tau)/d(gamma3) = omega_n*R - R*omega3*gamma3*((1)/s^2*Theta*D)*Theta*D*s,
 *      a part of d(d(v_nu)/dt)/d(gamma3), R*omega3 + b*omega_n*((1)/s^2*Theta*D)*Theta*D*s, d(x)/dt, d(d(y)/dt)/d(chi),
 *      d(y)/dt, d(d(x)/dt)/d(chi)
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
    const double t9 = params[3]*t8; /* a3*m*g */
    out[35] = t9;
    const double t10 = t9/params[4]; /* a3*m*g/I1 */
    out[9] = t10;
    const double t11 = params[5]/params[4]; /* I3/I1 */
    out[10] = t11;
    const double t12 = params[4]*params[1]; /* I1*R */
    out[42] = t12;
    const double t13 = params[5]/t12; /* I3/(I1*R) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[36] = t14;
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[12] = t15;
    const double t16 = (-1.0)/params[1]; /* (-1)/R */
    out[13] = t16;
    const double t17 = params[3]*params[5]; /* a3*I3 */
    const double t18 = t17/params[4]; /* a3*I3/I1 */
    out[14] = t18;
    const double t19 = params[4] - params[5]; /* I1 - I3 */
    const double t20 = params[1]*t19; /* R*(I1 - I3) */
    const double t21 = t20/params[4]; /* R*(I1 - I3)/I1 */
    out[15] = t21;
    const double t22 = params[4]*params[5]; /* I1*I3 */
    out[17] = t22;
    const double t23 = params[4]*t4; /* I1*m*R*R */
    out[18] = t23;
    const double t24 = params[0]*params[5]; /* m*I3 */
    out[19] = t24;
    const double t25 = -params[4]; /* -I1 */
    out[20] = t25;
    const double t26 = params[0]*2.0; /* m*2 */
    const double t27 = t0*t26; /* a3*a3*m*2 */
    out[21] = t27;
    const double t28 = params[5]*2.0; /* I3*2 */
    out[22] = t28;
    const double t29 = params[4]*2.0; /* I1*2 */
    out[23] = t29;
    const double t30 = params[4]*(-2.0); /* I1*(-2) */
    out[24] = t30;
    const double t31 = params[5]/t29; /* I3/(I1*2) */
    out[25] = t31;
    const double t32 = -params[5]; /* -I3 */
    out[26] = t32;
    const double t33 = params[5]*t14; /* I3*m*R */
    out[27] = t33;
    const double t34 = t3*t26; /* R*R*m*2 */
    const double t35 = params[4]*t34; /* I1*R*R*m*2 */
    out[28] = t35;
    const double t36 = params[1]*t26; /* R*m*2 */
    const double t37 = params[5]*t36; /* I3*R*m*2 */
    out[29] = t37;
    const double t38 = params[3]*t14; /* a3*m*R */
    const double t39 = params[5]*t38; /* I3*a3*m*R */
    out[30] = t39;
    const double t40 = params[5]*params[5]; /* I3*I3 */
    out[31] = t40;
    const double t41 = params[4]*t14; /* I1*m*R */
    out[32] = t41;
    const double t42 = t4*t19; /* m*R*R*(I1 - I3) */
    out[33] = t42;
    const double t43 = -t41; /* -I1*m*R */
    out[34] = t43;
    const double t44 = params[0]*params[3]; /* m*a3 */
    const double t45 = params[5]*t44; /* I3*m*a3 */
    out[37] = t45;
    const double t46 = params[4]*t38; /* I1*a3*m*R */
    out[38] = t46;
    const double t47 = params[0]/2.0; /* m/2 */
    out[39] = t47;
    const double t48 = params[4]/2.0; /* I1/2 */
    out[40] = t48;
    const double t49 = params[5]/2.0; /* I3/2 */
    out[41] = t49;
    const double t50 = -t12; /* -I1*R */
    out[43] = t50;
    const double t51 = params[1]*params[5]; /* R*I3 */
    const double t52 = -t51; /* -R*I3 */
    out[44] = t52;
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
    const double t18 = -t15; /* -t15 */
    out[5] = t18;
    const double t19 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t20 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t21 = x[2]*t12; /* omega_tau*s */
    out[0] = t21;
    const double t22 = p[6]*t19; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t23 = t21*t22; /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t24 = JLT_FNMA(p[9], t12, t23); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s */
    const double t25 = JLT_FMA(x[2], t20, x[1]); /* V = omega_tau*e + v_nu */
    const double t26 = t16*t25; /* 1/(Theta/(m*R^2*I1))*V */
    const double t27 = JLT_FMS(t4, t26, t19); /* I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V - omega_tau*gamma3 */
    const double t28 = x[4]*t16; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t29 = p[12] + t20; /* I3/(m*R) + e */
    const double t30 = t15*t27; /* t15*(I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V - omega_tau*gamma3) */
    const double t31 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/I1 - gamma3*R*(I1 - I3)/I1 */
    const double t32 = t21*t31; /* omega_tau*s*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) */
    const double t33 = t28*t32; /* omega3*1/(Theta/(m*R^2*I1))*omega_tau*s*(a3*I3/I1 - gamma3*R*(I1 - I3)/I1) */
    const double t34 = JLT_FMA(x[3], t26, t33); /* omega_n*1/(Theta/(m*R^2*I1))*V + t33 */
    const double t35 = p[13]*t34; /* (-1/R)*(omega_n*1/(Theta/(m*R^2*I1))*V + t33) */
    out[4] = t35;
    const double t36 = x[0]*t15; /* gamma3*t15 */
    const double t37 = x[4] + t36; /* omega3 + gamma3*t15 */
    out[6] = t37;
    const double t38 = JLT_FMA(x[4], p[10], t36); /* omega3*I3/I1 + gamma3*t15 */
    const double t39 = JLT_FNMA(x[3], t38, t24); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s - omega_n*(omega3*I3/I1 + gamma3*t15) */
    const double t40 = t17*t39; /* Theta/(m*R^2*I1)*1/((D/I1)*(Theta/(m*R^2*I1)))*t39 */
    out[2] = t40;
    const double t41 = p[1]*x[4]; /* R*omega3 */
    const double t42 = JLT_FMA(t3, t15, t41); /* b*t15 + R*omega3 */
    const double t43 = x[3]*t42; /* omega_n*(b*t15 + R*omega3) */
    out[1] = t43;
    const double t44 = x[3]*t3; /* omega_n*b */
    const double t45 = JLT_FMA(t12, t41, t44); /* v_tau = s*R*omega3 + omega_n*b */
    const double t46 = x[2]*p[11]; /* omega_tau*I3/(R*I1) */
    const double t47 = t29*t46; /* (I3/(m*R) + e)*omega_tau*I3/(R*I1) */
    const double t48 = JLT_FMS(t28, t47, t30); /* omega3*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e)*omega_tau*I3/(R*I1) - t30 */
    out[3] = t48;
    const double t49 = cos(x[5]); /* C = cos(chi) */
    const double t50 = sin(x[5]); /* S = sin(chi) */
    const double t51 = x[1]*t49; /* v_nu*C */
    const double t52 = JLT_FMA(t45, t50, t51); /* v_tau*S + v_nu*C */
    out[7] = t52;
    const double t53 = x[1]*t50; /* v_nu*S */
    const double t54 = JLT_FNMA(t45, t49, t53); /* v_nu*S - v_tau*C */
    out[8] = t54;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[58] = 1.0;
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
    const double t9 = t4*t8; /* D*Theta */
    const double t10 = t2*t9; /* s^2*D*Theta */
    const double t11 = 1.0/t10; /* 1/(s^2*D*Theta) */
    const double t12 = t3*t9; /* s*D*Theta */
    const double t13 = t11*t12; /* 1/(s^2*D*Theta)*s*D*Theta */
    const double t14 = x[0]*t13; /* gamma3*1/(s^2*D*Theta)*s*D*Theta */
    out[57] = t14;
    const double t15 = x[2]*t14; /* omega_tau*gamma3*1/(s^2*D*Theta)*s*D*Theta */
    const double t16 = -t15; /* -omega_tau*gamma3*1/(s^2*D*Theta)*s*D*Theta */
    out[0] = t16;
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
    const double t17 = t13*x[3]; /* 1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t18 = t5*t17; /* b*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t19 = p[1]*x[3]; /* R*omega_n */
    out[13] = t19;
    const double t20 = JLT_FMA(t14, t18, t19); /* gamma3*1/(s^2*D*Theta)*s*D*Theta*b*1/(s^2*D*Theta)*s*D*Theta*omega_n + R*omega_n */
    const double t21 = t17*t20; /* 1/(s^2*D*Theta)*s*D*Theta*omega_n*t20 */
    out[9] = t21;
    const double t22 = p[1]*x[4]; /* R*omega3 */
    const double t23 = JLT_FMA(t18, 2.0, t22); /* b*1/(s^2*D*Theta)*s*D*Theta*omega_n*2 + R*omega3 */
    out[12] = t23;
    const double t24 = t2*t11; /* 1/(D*Theta) = s^2*1/(s^2*D*Theta) */
    const double t25 = t8*t24; /* 1/D = Theta*1/(D*Theta) */
    const double t26 = x[0]*p[21]; /* gamma3*2*m*a3^2 */
    const double t27 = t3*t26; /* s*gamma3*2*m*a3^2 */
    const double t28 = t25*t27; /* 1/D*s*gamma3*2*m*a3^2 */
    const double t29 = t28 - t14; /* 1/D*s*gamma3*2*m*a3^2 - gamma3*1/(s^2*D*Theta)*s*D*Theta */
    const double t30 = p[9]*t29; /* m*g*a3/I1*(1/D*s*gamma3*2*m*a3^2 - gamma3*1/(s^2*D*Theta)*s*D*Theta) */
    const double t31 = t13*t17; /* 1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t32 = x[4]*p[22]; /* omega3*2*I3 */
    const double t33 = t14*x[3]; /* gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t34 = JLT_FMA(p[23], t33, t32); /* 2*I1*gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n + omega3*2*I3 */
    const double t35 = x[3]*t25; /* omega_n*1/D */
    const double t36 = x[0]*t35; /* gamma3*omega_n*1/D */
    const double t37 = t34*t36; /* (2*I1*gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n + omega3*2*I3)*gamma3*omega_n*1/D */
    const double t38 = JLT_FMA(x[0], t29, t3); /* gamma3*(1/D*s*gamma3*2*m*a3^2 - gamma3*1/(s^2*D*Theta)*s*D*Theta) + s */
    const double t39 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t40 = JLT_FNMA(t38, t39, t37); /* t37 - t38*omega_tau*omega_tau */
    const double t41 = JLT_FMA(t17, t31, t30); /* 1/(s^2*D*Theta)*s*D*Theta*omega_n*1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n + t30 */
    const double t42 = JLT_FMA(p[6], t40, t41); /* m*a3^2/I1*(t37 - t38*omega_tau*omega_tau) + t41 */
    const double t43 = p[20]*t25; /* (-I1)*1/D */
    const double t44 = t42*t43; /* (m*a3^2/I1*(t37 - t38*omega_tau*omega_tau) + t41)*(-I1)*1/D */
    out[18] = t44;
    const double t45 = x[2]*t28; /* omega_tau*1/D*s*gamma3*2*m*a3^2 */
    out[20] = t45;
    const double t46 = JLT_FMA(x[4], p[25], t33); /* omega3*1/2*I3/I1 + gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t47 = t25*p[24]; /* 1/D*(-2*I1) */
    const double t48 = t46*t47; /* (omega3*1/2*I3/I1 + gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n)*1/D*(-2*I1) */
    out[21] = t48;
    const double t49 = t35*p[26]; /* omega_n*1/D*(-I3) */
    out[22] = t49;
    const double t50 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t51 = JLT_FMA(x[2], t50, x[1]); /* V = omega_tau*e + v_nu */
    const double t52 = t4*t24; /* 1/Theta = D*1/(D*Theta) */
    const double t53 = t51*t52; /* V*1/Theta */
    const double t54 = t17*p[27]; /* 1/(s^2*D*Theta)*s*D*Theta*omega_n*m*R*I3 */
    const double t55 = t53*t54; /* V*1/Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n*m*R*I3 */
    const double t56 = t6*t17; /* b*m*I3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t57 = t52*t56; /* 1/Theta*b*m*I3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t58 = t13*t51; /* 1/(s^2*D*Theta)*s*D*Theta*V */
    const double t59 = x[2]*p[3]; /* omega_tau*a3 */
    const double t60 = x[0]*p[28]; /* gamma3*2*m*R^2*I1 */
    const double t61 = JLT_FMS(t5, p[29], t60); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t62 = JLT_FNMA(t53, t61, t59); /* omega_tau*a3 - V*1/Theta*d(Theta)/d(gamma3) */
    const double t63 = JLT_FMA(t14, t58, t62); /* gamma3*1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*V + omega_tau*a3 - V*1/Theta*d(Theta)/d(gamma3) */
    const double t64 = t13*t31; /* 1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    out[54] = t64;
    const double t65 = JLT_FMA(p[27], t50, p[31]); /* m*R*I3*e + I3^2 */
    const double t66 = t52*t65; /* 1/Theta*(m*R*I3*e + I3^2) */
    const double t67 = JLT_FNMA(t61, t66, p[30]); /* m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(m*R*I3*e + I3^2) */
    const double t68 = x[4]*t52; /* omega3*1/Theta */
    const double t69 = JLT_FMA(t67, t68, t64); /* (m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*(m*R*I3*e + I3^2))*omega3*1/Theta + t64 */
    const double t70 = JLT_FMS(x[2], t69, t55); /* omega_tau*t69 - V*1/Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n*m*R*I3 */
    const double t71 = JLT_FNMA(t57, t63, t70); /* t70 - 1/Theta*b*m*I3*1/(s^2*D*Theta)*s*D*Theta*omega_n*t63 */
    out[27] = t71;
    const double t72 = -t57; /* -1/Theta*b*m*I3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    out[28] = t72;
    const double t73 = JLT_FMA(x[4], t66, t33); /* omega3*1/Theta*(m*R*I3*e + I3^2) + gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t74 = JLT_FNMA(t50, t57, t73); /* t73 - e*1/Theta*b*m*I3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    out[29] = t74;
    const double t75 = t6*t13; /* b*m*I3*1/(s^2*D*Theta)*s*D*Theta */
    const double t76 = JLT_FNMA(t53, t75, t15); /* omega_tau*gamma3*1/(s^2*D*Theta)*s*D*Theta - V*1/Theta*b*m*I3*1/(s^2*D*Theta)*s*D*Theta */
    out[30] = t76;
    const double t77 = x[2]*t66; /* omega_tau*1/Theta*(m*R*I3*e + I3^2) */
    out[31] = t77;
    const double t78 = x[3]*p[32]; /* omega_n*m*R*I1 */
    const double t79 = t52*t78; /* 1/Theta*omega_n*m*R*I1 */
    const double t80 = t62*t79; /* (omega_tau*a3 - V*1/Theta*d(Theta)/d(gamma3))*1/Theta*omega_n*m*R*I1 */
    const double t81 = JLT_FNMA(x[0], p[33], p[30]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t82 = t3*t81; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t83 = t52*t82; /* 1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t84 = t3*p[33]; /* s*m*R^2*(I1 - I3) */
    const double t85 = JLT_FMA(t14, t81, t84); /* gamma3*1/(s^2*D*Theta)*s*D*Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + s*m*R^2*(I1 - I3) */
    const double t86 = JLT_FMA(t61, t83, t85); /* d(Theta)/d(gamma3)*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + t85 */
    const double t87 = x[2]*t68; /* omega_tau*omega3*1/Theta */
    const double t88 = JLT_FMS(t86, t87, t80); /* t86*omega_tau*omega3*1/Theta - t80 */
    out[36] = t88;
    const double t89 = -t79; /* -1/Theta*omega_n*m*R*I1 */
    out[37] = t89;
    const double t90 = t50*t79; /* e*1/Theta*omega_n*m*R*I1 */
    const double t91 = JLT_FMA(x[4], t83, t90); /* omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*1/Theta*omega_n*m*R*I1 */
    const double t92 = -t91; /* -t91 */
    out[38] = t92;
    const double t93 = t53*p[34]; /* V*1/Theta*(-m*R*I1) */
    out[39] = t93;
    const double t94 = x[2]*t83; /* omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t95 = -t94; /* -omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[40] = t95;
    const double t96 = t14*t31; /* gamma3*1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t97 = -t96; /* -t96 */
    out[45] = t97;
    const double t98 = -t13; /* -1/(s^2*D*Theta)*s*D*Theta */
    out[48] = t98;
    const double t99 = sin(x[5]); /* S = sin(chi) */
    out[73] = t99;
    const double t100 = JLT_FNMA(t14, t22, t19); /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*1/(s^2*D*Theta)*s*D*Theta*R*omega3 */
    const double t101 = t99*t100; /* S*d(v_tau)/d(gamma3) */
    out[63] = t101;
    const double t102 = cos(x[5]); /* C = cos(chi) */
    out[64] = t102;
    const double t103 = t5*t99; /* b*S */
    out[66] = t103;
    const double t104 = t3*p[1]; /* s*R */
    const double t105 = t99*t104; /* S*s*R */
    out[67] = t105;
    const double t106 = x[1]*t99; /* v_nu*S */
    const double t107 = t5*x[3]; /* b*omega_n */
    const double t108 = JLT_FMA(x[4], t104, t107); /* v_tau = omega3*s*R + b*omega_n */
    const double t109 = JLT_FMS(t102, t108, t106); /* C*v_tau - v_nu*S */
    out[68] = t109;
    const double t110 = t100*t102; /* d(v_tau)/d(gamma3)*C */
    const double t111 = -t110; /* -d(v_tau)/d(gamma3)*C */
    out[72] = t111;
    const double t112 = t5*t102; /* b*C */
    const double t113 = -t112; /* -b*C */
    out[75] = t113;
    const double t114 = t102*t104; /* C*s*R */
    const double t115 = -t114; /* -C*s*R */
    out[76] = t115;
    const double t116 = x[1]*t102; /* v_nu*C */
    const double t117 = JLT_FMA(t99, t108, t116); /* S*v_tau + v_nu*C */
    out[77] = t117;
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
    const double t4 = p[19]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[18], t2, p[17]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
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
    const double t17 = -t13; /* -1/(s^2*Theta*D)*Theta*D*s */
    out[57] = t17;
    const double t18 = x[3]*t13; /* omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t19 = -t18; /* -omega_n*1/(s^2*Theta*D)*Theta*D*s */
    out[5] = t19;
    const double t20 = p[1]*x[4]; /* R*omega3 */
    const double t21 = t3*t18; /* b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t22 = JLT_FMA(2.0, t21, t20); /* 2*b*omega_n*1/(s^2*Theta*D)*Theta*D*s + R*omega3 */
    out[21] = t22;
    const double t23 = x[2]*p[16]; /* omega_tau*m*a3^2 */
    const double t24 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t25 = JLT_FNMA(t23, t24, p[35]); /* m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t26 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t27 = x[2]*t15; /* omega_tau*1/Theta */
    const double t28 = x[0]*t13; /* gamma3*1/(s^2*Theta*D)*Theta*D*s */
    out[66] = t28;
    const double t29 = JLT_FMA(x[2], t26, x[1]); /* V = omega_tau*e + v_nu */
    const double t30 = x[3]*p[32]; /* omega_n*m*R*I1 */
    const double t31 = JLT_FNMA(x[0], p[33], p[30]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t32 = t20 - t21; /* R*omega3 - b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t33 = p[37]*t27; /* m*a3*I3*omega_tau*1/Theta */
    const double t34 = t32*t33; /* (R*omega3 - b*omega_n*1/(s^2*Theta*D)*Theta*D*s)*m*a3*I3*omega_tau*1/Theta */
    const double t35 = x[2]*t11; /* omega_tau*s */
    out[0] = t35;
    const double t36 = x[4]*p[5]; /* omega3*I3 */
    const double t37 = x[3]*t28; /* omega_n*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t38 = x[4] + t37; /* omega3 + omega_n*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    out[6] = t38;
    const double t39 = p[19]*t21; /* m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t40 = JLT_FMA(p[36], t26, p[5]); /* m*R*e + I3 */
    const double t41 = t29*t30; /* V*omega_n*m*R*I1 */
    const double t42 = x[4]*t31; /* omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t43 = JLT_FMA(t35, t42, t41); /* omega_tau*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*omega_n*m*R*I1 */
    const double t44 = t15*t43; /* 1/Theta*t43 */
    const double t45 = t31*t35; /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*s */
    const double t46 = t15*t45; /* 1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*s */
    const double t47 = -t46; /* -1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*s */
    out[49] = t47;
    const double t48 = -t44; /* -1/Theta*t43 */
    out[4] = t48;
    const double t49 = t25*t28; /* (m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3)*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t50 = JLT_FMA(t23, t35, t49); /* omega_tau*m*a3^2*omega_tau*s + t49 */
    const double t51 = t11*t25; /* s*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t52 = t13*t18; /* 1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t53 = x[0]*p[28]; /* gamma3*2*m*R^2*I1 */
    const double t54 = JLT_FMS(p[29], t3, t53); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t55 = t15*t54; /* 1/Theta*d(Theta)/d(gamma3) */
    const double t56 = t44*t55; /* 1/Theta*t43*1/Theta*d(Theta)/d(gamma3) */
    const double t57 = t15*t29; /* 1/Theta*V */
    const double t58 = t29*t39; /* V*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t59 = p[34]*t57; /* (-m*R*I1)*1/Theta*V */
    out[48] = t59;
    const double t60 = p[27]*t18; /* m*R*I3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t61 = JLT_FNMA(t57, t60, t34); /* t34 - 1/Theta*V*m*R*I3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t62 = t13*t57; /* 1/(s^2*Theta*D)*Theta*D*s*1/Theta*V */
    const double t63 = t13*t52; /* 1/(s^2*Theta*D)*Theta*D*s*1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    out[63] = t63;
    const double t64 = JLT_FMA(x[2], t63, t61); /* omega_tau*t63 + t34 - 1/Theta*V*m*R*I3*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t65 = x[2]*p[38]; /* omega_tau*m*R*a3*I1 */
    const double t66 = x[3]*t65; /* omega_n*omega_tau*m*R*a3*I1 */
    const double t67 = JLT_FMA(p[4], t37, t36); /* I1*omega_n*gamma3*1/(s^2*Theta*D)*Theta*D*s + omega3*I3 */
    const double t68 = JLT_FMA(x[3], t67, t51); /* omega_n*(I1*omega_n*gamma3*1/(s^2*Theta*D)*Theta*D*s + omega3*I3) + s*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t69 = t16*t68; /* 1/D*t68 */
    const double t70 = -t69; /* -1/D*t68 */
    out[2] = t70;
    const double t71 = t36*t40; /* omega3*I3*(m*R*e + I3) */
    const double t72 = JLT_FMS(x[2], t71, t58); /* numerator of d(omega_n)/dt over Theta = omega_tau*omega3*I3*(m*R*e + I3) - V*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t73 = JLT_FMA(p[23], t37, t36); /* 2*I1*omega_n*gamma3*1/(s^2*Theta*D)*Theta*D*s + omega3*I3 */
    const double t74 = t15*t72; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t75 = t16*t73; /* 1/D*(2*I1*omega_n*gamma3*1/(s^2*Theta*D)*Theta*D*s + omega3*I3) */
    const double t76 = -t75; /* -t75 */
    out[30] = t76;
    const double t77 = JLT_FNMA(t26, t39, t71); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = omega3*I3*(m*R*e + I3) - e*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t78 = JLT_FMA(t15, t77, t37); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    out[38] = t78;
    const double t79 = t26*t30; /* e*omega_n*m*R*I1 */
    const double t80 = JLT_FMA(t11, t42, t79); /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*omega_n*m*R*I1 */
    const double t81 = p[5]*t40; /* I3*(m*R*e + I3) */
    const double t82 = t27*t81; /* omega_tau*1/Theta*I3*(m*R*e + I3) */
    out[40] = t82;
    const double t83 = t15*t30; /* 1/Theta*omega_n*m*R*I1 */
    const double t84 = -t83; /* -1/Theta*omega_n*m*R*I1 */
    out[46] = t84;
    const double t85 = t15*t80; /* 1/Theta*t80 */
    const double t86 = -t85; /* -1/Theta*t80 */
    out[47] = t86;
    const double t87 = x[3]*t3; /* omega_n*b */
    const double t88 = JLT_FMA(t11, t20, t87); /* v_tau = s*R*omega3 + omega_n*b */
    const double t89 = p[1]*t11; /* R*s */
    const double t90 = x[3]*p[1]; /* omega_n*R */
    out[22] = t90;
    const double t91 = p[4]*t18; /* I1*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t92 = JLT_FNMA(t52, t91, t50); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = omega_tau*m*a3^2*omega_tau*s + t49 - 1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s*I1*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t93 = t16*t92; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) */
    const double t94 = t28*t52; /* gamma3*1/(s^2*Theta*D)*Theta*D*s*1/(s^2*Theta*D)*Theta*D*s*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t95 = -t94; /* -t94 */
    out[54] = t95;
    const double t96 = x[4]*p[33]; /* omega3*m*R^2*(I1 - I3) */
    const double t97 = JLT_FMS(t35, t96, t66); /* omega_tau*s*omega3*m*R^2*(I1 - I3) - omega_n*omega_tau*m*R*a3*I1 */
    const double t98 = x[2]*t28; /* omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t99 = JLT_FMA(t42, t98, t97); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s + t97 */
    const double t100 = JLT_FMA(t15, t99, t56); /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(gamma3) + 1/Theta*t43*1/Theta*d(Theta)/d(gamma3) */
    out[45] = t100;
    const double t101 = JLT_FNMA(t4, t62, t98); /* omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s - m*I3*b*1/(s^2*Theta*D)*Theta*D*s*1/Theta*V */
    out[39] = t101;
    const double t102 = t28*t62; /* gamma3*1/(s^2*Theta*D)*Theta*D*s*1/(s^2*Theta*D)*Theta*D*s*1/Theta*V */
    const double t103 = JLT_FNMA(t39, t102, t64); /* t64 - m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s*t102 */
    const double t104 = JLT_FNMA(t55, t74, t103); /* t64 - m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s*t102 - 1/Theta*d(Theta)/d(gamma3)*1/Theta*numerator of d(omega_n)/dt over Theta */
    out[36] = t104;
    const double t105 = t15*t39; /* 1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t106 = JLT_FMA(x[3], t98, t74); /* omega_n*omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t106;
    const double t107 = -t98; /* -omega_tau*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    out[9] = t107;
    const double t108 = -t105; /* -1/Theta*m*I3*b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    out[37] = t108;
    const double t109 = cos(x[5]); /* C = cos(chi) */
    out[73] = t109;
    const double t110 = sin(x[5]); /* S = sin(chi) */
    out[82] = t110;
    const double t111 = t3*t110; /* b*S */
    out[75] = t111;
    const double t112 = t3*t109; /* b*C */
    const double t113 = -t112; /* -b*C */
    out[84] = t113;
    const double t114 = t89*t110; /* R*s*S */
    out[76] = t114;
    const double t115 = t89*t109; /* R*s*C */
    const double t116 = -t115; /* -R*s*C */
    out[85] = t116;
    const double t117 = x[0]*p[21]; /* gamma3*2*m*a3^2 */
    const double t118 = t16*t117; /* 1/D*gamma3*2*m*a3^2 */
    const double t119 = JLT_FNMA(t69, t118, t93); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(gamma3) - 1/D*t68*1/D*gamma3*2*m*a3^2 */
    out[27] = t119;
    const double t120 = t35*t118; /* omega_tau*s*1/D*gamma3*2*m*a3^2 */
    out[29] = t120;
    const double t121 = JLT_FNMA(t20, t28, t90); /* d(v_tau)/d(gamma3) = omega_n*R - R*omega3*gamma3*1/(s^2*Theta*D)*Theta*D*s */
    const double t122 = JLT_FMA(t21, t28, t90); /* b*omega_n*1/(s^2*Theta*D)*Theta*D*s*gamma3*1/(s^2*Theta*D)*Theta*D*s + omega_n*R */
    const double t123 = t18*t122; /* omega_n*1/(s^2*Theta*D)*Theta*D*s*t122 */
    out[18] = t123;
    const double t124 = t20 + t21; /* R*omega3 + b*omega_n*1/(s^2*Theta*D)*Theta*D*s */
    const double t125 = x[3]*t124; /* omega_n*(R*omega3 + b*omega_n*1/(s^2*Theta*D)*Theta*D*s) */
    out[1] = t125;
    const double t126 = t110*t121; /* S*d(v_tau)/d(gamma3) */
    out[72] = t126;
    const double t127 = t109*t121; /* C*d(v_tau)/d(gamma3) */
    const double t128 = -t127; /* -C*d(v_tau)/d(gamma3) */
    out[81] = t128;
    const double t129 = x[1]*t109; /* v_nu*C */
    const double t130 = JLT_FMA(t88, t110, t129); /* v_tau*S + v_nu*C */
    out[7] = t130;
    out[86] = t130;
    const double t131 = t88*t109; /* v_tau*C */
    const double t132 = x[1]*t110; /* v_nu*S */
    const double t133 = t132 - t131; /* v_nu*S - v_tau*C */
    out[8] = t133;
    const double t134 = t131 - t132; /* v_tau*C - v_nu*S */
    out[77] = t134;
    const double t135 = x[3]*p[26]; /* omega_n*(-I3) */
    const double t136 = t16*t135; /* 1/D*omega_n*(-I3) */
    out[31] = t136;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[19]*t3; /* m*I3*b */
    const double t5 = JLT_FMA(p[18], t2, p[17]); /* m*R^2*I1*s^2 + I1*I3 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s^2 + I1*I3 */
    const double t7 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = t6*t7; /* Theta*D */
    const double t9 = p[21]*t6; /* 2*m*a3^2*Theta */
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
    const double t21 = p[33]*t20; /* m*R^2*(I1 - I3)*gamma3*omega_tau*s */
    const double t22 = JLT_FNMA(p[30], t19, t21); /* m*R^2*(I1 - I3)*gamma3*omega_tau*s - m*R*a3*I3*omega_tau*s */
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
    const double t3 = p[35]*x[0]; /* m*g*a3*gamma3 */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = x[3]*p[40]; /* omega_n*1/2*I1 */
    const double t6 = JLT_FMA(x[3], t5, t3); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t7 = x[3]*t4; /* omega_n*b */
    const double t8 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t10 = p[1]*x[4]; /* R*omega3 */
    const double t11 = JLT_FMA(t8, t10, t7); /* v_tau = s*R*omega3 + omega_n*b */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = x[4]*p[41]; /* omega3*1/2*I3 */
    const double t15 = JLT_FMA(x[4], t14, t6); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(t9, t13, t15); /* D*omega_tau*1/2*omega_tau + t15 */
    const double t17 = x[1]*x[1]; /* v_nu*v_nu */
    const double t18 = JLT_FMA(t11, t11, t17); /* v_tau*v_tau + v_nu*v_nu */
    const double t19 = JLT_FMA(p[39], t18, t16); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t15 */
    out[0] = t19;
    const double t20 = x[3]*p[42]; /* omega_n*R*I1 */
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
    const double t5 = p[26]*t4; /* (-I3)*b */
    out[13] = t5;
    const double t6 = sqrt(t3); /* s = sqrt(s^2) */
    const double t7 = p[42]*t6; /* R*I1*s */
    out[12] = t7;
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
    const double t18 = JLT_FNMA(t16, t17, p[35]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t19 = x[3]*p[43]; /* omega_n*(-R*I1) */
    const double t20 = t9*t19; /* s*gamma3/s^2*omega_n*(-R*I1) */
    const double t21 = JLT_FMA(x[4], p[44], t20); /* omega3*(-R*I3) + s*gamma3/s^2*omega_n*(-R*I1) */
    out[9] = t21;
    const double t22 = JLT_FNMA(x[4], t9, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*s*gamma3/s^2 */
    const double t23 = p[36]*t15; /* m*R*v_tau */
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
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
    double u67[JLT_JET_ORDER_MAX + 1];
    double t68[JLT_JET_ORDER_MAX + 1];
    double u68[JLT_JET_ORDER_MAX + 1];
    double t69[JLT_JET_ORDER_MAX + 1];
    double t70[JLT_JET_ORDER_MAX + 1];
    double t71[JLT_JET_ORDER_MAX + 1];
    double t72[JLT_JET_ORDER_MAX + 1];
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
        t22[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t23[k] = jlt_jet_root(t21[k], t23, k);
        t24[k] = p[6]*t21[k] + (k == 0 ? 1.0 : 0);
        t25[k] = (k == 0 ? p[7] : 0) + t21[k];
        t26[k] = p[8]*t22[k];
        t27[k] = jlt_jet_product(t22, t26, k) + t25[k];
        t28[k] = jlt_jet_product(t23, t24, k);
        t29[k] = jlt_jet_product(x3, t24, k);
        t30[k] = jlt_jet_product(t27, t28, k);
        t31[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t30, t31, k);
        t32[k] = jlt_jet_product(t27, t31, k);
        t33[k] = jlt_jet_product(t28, t31, k);
        t34[k] = jlt_jet_product(t29, t32, k);
        t35[k] = jlt_jet_product(t23, t32, k);
        t36[k] = -t34[k];
        t37[k] = jlt_jet_product(x2, x0, k);
        t38[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t39[k] = jlt_jet_product(x2, t23, k);
        t40[k] = p[6]*t37[k];
        t41[k] = jlt_jet_product(t39, t40, k);
        t42[k] = t41[k] - p[9]*t23[k];
        t43[k] = jlt_jet_product(x2, t38, k) + x1[k];
        t44[k] = jlt_jet_product(t33, t43, k);
        t45[k] = jlt_jet_product(t26, t44, k) - t37[k];
        t46[k] = jlt_jet_product(x4, t33, k);
        t47[k] = (k == 0 ? p[12] : 0) + t38[k];
        t48[k] = jlt_jet_product(t34, t45, k);
        t49[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t50[k] = jlt_jet_product(t39, t49, k);
        t51[k] = jlt_jet_product(t46, t50, k);
        t52[k] = jlt_jet_product(x3, t44, k) + t51[k];
        t53[k] = p[13]*t52[k];
        t54[k] = jlt_jet_product(x0, t34, k);
        t55[k] = x4[k] + t54[k];
        t56[k] = x4[k]*p[10] + t54[k];
        t57[k] = t42[k] - jlt_jet_product(x3, t56, k);
        t58[k] = jlt_jet_product(t35, t57, k);
        t59[k] = p[1]*x4[k];
        t60[k] = jlt_jet_product(t22, t34, k) + t59[k];
        t61[k] = jlt_jet_product(x3, t60, k);
        t62[k] = jlt_jet_product(x3, t22, k);
        t63[k] = jlt_jet_product(t23, t59, k) + t62[k];
        t64[k] = x2[k]*p[11];
        t65[k] = jlt_jet_product(t47, t64, k);
        t66[k] = jlt_jet_product(t46, t65, k) - t48[k];
        t67[k] = jlt_jet_cosine(x5, t67, u67, k);
        t68[k] = jlt_jet_sine(x5, t68, u68, k);
        t69[k] = jlt_jet_product(x1, t67, k);
        t70[k] = jlt_jet_product(t63, t68, k) + t69[k];
        t71[k] = jlt_jet_product(x1, t68, k);
        t72[k] = t71[k] - jlt_jet_product(t63, t67, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t39[k]/(k + 1);
        next[1] = x1[k + 1] = t61[k]/(k + 1);
        next[2] = x2[k + 1] = t58[k]/(k + 1);
        next[3] = x3[k + 1] = t66[k]/(k + 1);
        next[4] = x4[k + 1] = t53[k]/(k + 1);
        next[5] = x5[k + 1] = t36[k]/(k + 1);
        next[6] = x6[k + 1] = t55[k]/(k + 1);
        next[7] = x7[k + 1] = t70[k]/(k + 1);
        next[8] = x8[k + 1] = t72[k]/(k + 1);
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
    .sha256 = "6846e2a6e2e89b5e5aa4c7b67fe5e7f138d28ea2677fe5f4b40745ae5674af39",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .state_count = 9, .param_count = 6, .prepared_count = 45,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 9, { 6, 29, 16, 1, 1, 2, 13, 12 }, { 22, 77, 0, 14, 1, 2, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, V = omega_tau*e + v_nu, (I3/(R^2*I1))*b*1/(Theta/(m*R^2*I1))*V - omega_tau*gamma3, I3/(m*R) + e, a3*I3/I1 - gamma3*(R*(I1 - I3)/I1), a part of d(omega3)/dt, d(spin)/dt, a part of d(omega_tau)/dt, a part of d(omega_tau)/dt, a part of d(v_nu)/dt, v_tau = s*R*omega3 + omega_n*b, d(omega_n)/dt, d(x)/dt, d(y)/dt" },
    .jacobian = { jacobian, 81, { 13, 67, 34, 1, 1, 2, 15, 23 }, { 61, 296, 0, 55, 1, 2, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega_n), 1/D*s*gamma3*(2*m*a3^2) - gamma3*((1)/s^2*D*Theta)*s*D*Theta, (2*I1)*gamma3*((1)/s^2*D*Theta)*s*D*Theta*omega_n + omega3*(2*I3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), omega3*(1/2*I3/I1) + gamma3*((1)/s^2*D*Theta)*s*D*Theta*omega_n, e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(Theta)/d(gamma3) = b*(2*m*R*I3) - gamma3*(2*m*R^2*I1), omega_tau*a3 - V*1/Theta*d(Theta)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), (m*R*I3)*e + I3^2, m*R*a3*I3 - d(Theta)/d(gamma3)*1/Theta*((m*R*I3)*e + I3^2), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), d(d(omega_n)/dt)/d(omega_n), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau), d(v_tau)/d(gamma3) = R*omega_n - gamma3*((1)/s^2*D*Theta)*s*D*Theta*R*omega3, v_tau = omega3*s*R + b*omega_n, d(d(x)/dt)/d(chi), d(d(y)/dt)/d(chi)" },
    .rhs_jacobian = { rhs_jacobian, 90, { 21, 77, 35, 1, 1, 2, 16, 29 }, { 75, 353, 0, 69, 1, 2, 16, 14 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, d(d(v_nu)/dt)/d(omega_n), m*g*a3 - omega_tau*(m*a3^2)*omega_tau*gamma3, e = gamma3*a3 + R, V = omega_tau*e + v_nu, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), R*omega3 - b*omega_n*((1)/s^2*Theta*D)*Theta*D*s, d(spin)/dt, (m*R)*e + I3, a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), I1*omega_n*gamma3*((1)/s^2*Theta*D)*Theta*D*s + omega3*I3, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), numerator of d(omega_n)/dt over Theta, (2*I1)*omega_n*gamma3*((1)/s^2*Theta*D)*Theta*D*s + omega3*I3, d(numerator of d(omega_n)/dt over Theta)/d(omega_tau), d(d(omega_n)/dt)/d(omega_tau), s*omega3*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))) + e*omega_n*(m*R*I1), v_tau = s*R*omega3 + omega_n*b, d(numerator of d(omega_tau)/dt over D)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(gamma3), d(d(omega3)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), d(d(omega_n)/dt)/d(gamma3), d(omega_n)/dt, d(d(omega_tau)/dt)/d(gamma3), d(v_tau)/d(gamma3) = omega_n*R - R*omega3*gamma3*((1)/s^2*Theta*D)*Theta*D*s, a part of d(d(v_nu)/dt)/d(gamma3), R*omega3 + b*omega_n*((1)/s^2*Theta*D)*Theta*D*s, d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi)" },
    .divergence = { divergence, 1, { 2, 14, 9, 1, 1, 0, 11, 9 }, { 11, 38, 0, 4, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, V = omega_tau*e + v_nu, a part of the divergence, a part of the divergence" },
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
