/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Table:      spherical_top_track, SHA-256 e5eebb5567edc15e7cc6fede26c131ca64344936d08ff51ea4e1a4b893121228
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 6   29   16    1    1    2     13   12   (116)
 *  jacobian            12   65   35    1    1    2     14   25   (415)
 *  rhs_jacobian        20   74   36    1    1    2     16   28   (500)
 *  divergence          2   14    9    1    1    0     11    9   (54)
 *  integral_values     2   12    9    0    1    0      6    8   (43)
 *  integral_gradients  2   16    9    1    1    0      6    7   (53)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, V = omega_tau*e + v_nu,
 *      m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), (I3/I1)*omega3*1/D + omega_n*Theta*((1)/Theta*s^2*D)*D*s*gamma3*1/D,
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega_n),
 *      d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), (m*R*I3)*e + I3^2,
 *      a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), a part of d(d(omega3)/dt)/d(gamma3),
 *      a part of d(d(omega_n)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega_n),
 *      a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(gamma3), v_tau = omega3*R*s + omega_n*b,
 *      a part of d(d(omega_tau)/dt)/d(gamma3), d(omega_tau)/dt, d(d(omega_n)/dt)/d(omega_tau), d(omega_n)/dt,
 *      d(spin)/dt, d(d(omega_n)/dt)/d(gamma3), b*omega_n*Theta*((1)/Theta*s^2*D)*D*s + R*omega3,
 *      d(v_tau)/d(gamma3) = omega_n*R - gamma3*Theta*((1)/Theta*s^2*D)*D*s*R*omega3, a part of d(d(v_nu)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), d(x)/dt,
 *      d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi)
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
    out[21] = t9;
    const double t10 = t9/params[4]; /* a3*m*g/I1 */
    out[9] = t10;
    const double t11 = params[5]/params[4]; /* I3/I1 */
    out[10] = t11;
    const double t12 = params[4]*params[1]; /* I1*R */
    out[38] = t12;
    const double t13 = params[5]/t12; /* I3/(I1*R) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[39] = t14;
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[12] = t15;
    const double t16 = 1.0/params[1]; /* 1/R */
    out[13] = t16;
    const double t17 = params[4] - params[5]; /* I1 - I3 */
    const double t18 = t17/params[4]; /* (I1 - I3)/I1 */
    out[14] = t18;
    const double t19 = params[3]*params[5]; /* a3*I3 */
    const double t20 = t19/t12; /* a3*I3/(I1*R) */
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
    const double t26 = params[4]*(-2.0); /* I1*(-2) */
    out[22] = t26;
    const double t27 = -params[5]; /* -I3 */
    out[23] = t27;
    const double t28 = t3*t24; /* R*R*m*2 */
    const double t29 = params[4]*t28; /* I1*R*R*m*2 */
    out[24] = t29;
    const double t30 = params[1]*t24; /* R*m*2 */
    const double t31 = params[5]*t30; /* I3*R*m*2 */
    out[25] = t31;
    const double t32 = params[5]*t14; /* I3*m*R */
    out[26] = t32;
    const double t33 = params[3]*t14; /* a3*m*R */
    const double t34 = params[5]*t33; /* I3*a3*m*R */
    out[27] = t34;
    const double t35 = params[5]*params[5]; /* I3*I3 */
    out[28] = t35;
    const double t36 = params[4]*t14; /* I1*m*R */
    out[29] = t36;
    const double t37 = t4*t17; /* m*R*R*(I1 - I3) */
    out[30] = t37;
    const double t38 = -t36; /* -I1*m*R */
    out[31] = t38;
    const double t39 = params[4]*t25; /* I1*a3*a3*m*2 */
    out[32] = t39;
    const double t40 = params[0]*params[3]; /* m*a3 */
    const double t41 = params[5]*t40; /* I3*m*a3 */
    out[33] = t41;
    const double t42 = params[4]*t33; /* I1*a3*m*R */
    out[34] = t42;
    const double t43 = params[0]/2.0; /* m/2 */
    out[35] = t43;
    const double t44 = params[4]/2.0; /* I1/2 */
    out[36] = t44;
    const double t45 = params[5]/2.0; /* I3/2 */
    out[37] = t45;
    const double t46 = -t12; /* -I1*R */
    out[40] = t46;
    const double t47 = params[1]*params[5]; /* R*I3 */
    const double t48 = -t47; /* -R*I3 */
    out[41] = t48;
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
    const double t7 = x[3]*t3; /* omega_n*b */
    const double t8 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t9 = t6*t8; /* Theta/(m*R^2*I1)*D/I1 */
    const double t10 = t2*t9; /* s^2*Theta/(m*R^2*I1)*D/I1 */
    const double t11 = 1.0/t10; /* 1/(s^2*Theta/(m*R^2*I1)*D/I1) */
    const double t12 = x[3]*t9; /* omega_n*Theta/(m*R^2*I1)*D/I1 */
    const double t13 = sqrt(t2); /* s = sqrt(s^2) */
    const double t14 = t12*t13; /* omega_n*Theta/(m*R^2*I1)*D/I1*s */
    const double t15 = t2*t11; /* 1/((D/I1)*(Theta/(m*R^2*I1))) = s^2*1/(s^2*Theta/(m*R^2*I1)*D/I1) */
    const double t16 = t11*t14; /* 1/(s^2*Theta/(m*R^2*I1)*D/I1)*omega_n*Theta/(m*R^2*I1)*D/I1*s */
    const double t17 = t8*t15; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/((D/I1)*(Theta/(m*R^2*I1))) */
    const double t18 = t6*t15; /* Theta/(m*R^2*I1)*1/((D/I1)*(Theta/(m*R^2*I1))) */
    const double t19 = t4*t16; /* I3/(R^2*I1)*b*t16 */
    const double t20 = -t16; /* -t16 */
    out[5] = t20;
    const double t21 = x[2]*t13; /* omega_tau*s */
    out[0] = t21;
    const double t22 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t23 = x[0]*t21; /* gamma3*omega_tau*s */
    const double t24 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t25 = t23*t24; /* gamma3*omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t26 = JLT_FNMA(p[9], t13, t25); /* gamma3*omega_tau*s*omega_tau*m*a3^2/I1 - m*g*a3/I1*s */
    const double t27 = p[14]*t23; /* (I1 - I3)/I1*gamma3*omega_tau*s */
    const double t28 = JLT_FNMA(p[15], t21, t27); /* (I1 - I3)/I1*gamma3*omega_tau*s - a3*I3/(R*I1)*omega_tau*s */
    const double t29 = p[12] + t22; /* I3/(m*R) + e */
    const double t30 = p[11]*t29; /* I3/(R*I1)*(I3/(m*R) + e) */
    const double t31 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = t17*t31; /* 1/(Theta/(m*R^2*I1))*V */
    const double t33 = x[4]*t17; /* omega3*1/(Theta/(m*R^2*I1)) */
    const double t34 = x[0]*t16; /* gamma3*t16 */
    const double t35 = JLT_FMA(t30, t33, t34); /* I3/(R*I1)*(I3/(m*R) + e)*omega3*1/(Theta/(m*R^2*I1)) + gamma3*t16 */
    const double t36 = t7*t16; /* omega_n*b*t16 */
    const double t37 = x[2]*t35; /* omega_tau*t35 */
    const double t38 = JLT_FNMA(t19, t32, t37); /* omega_tau*t35 - I3/(R^2*I1)*b*t16*1/(Theta/(m*R^2*I1))*V */
    out[3] = t38;
    const double t39 = x[4] + t34; /* omega3 + gamma3*t16 */
    out[6] = t39;
    const double t40 = JLT_FMA(x[4], p[10], t34); /* omega3*I3/I1 + gamma3*t16 */
    const double t41 = JLT_FNMA(x[3], t40, t26); /* gamma3*omega_tau*s*omega_tau*m*a3^2/I1 - m*g*a3/I1*s - omega_n*(omega3*I3/I1 + gamma3*t16) */
    const double t42 = t18*t41; /* Theta/(m*R^2*I1)*1/((D/I1)*(Theta/(m*R^2*I1)))*t41 */
    out[2] = t42;
    const double t43 = p[1]*x[4]; /* R*omega3 */
    const double t44 = JLT_FMA(t13, t43, t7); /* v_tau = s*R*omega3 + omega_n*b */
    const double t45 = JLT_FMA(x[3], t43, t36); /* omega_n*R*omega3 + omega_n*b*t16 */
    out[1] = t45;
    const double t46 = x[3]*p[13]; /* omega_n*1/R */
    const double t47 = t32*t46; /* 1/(Theta/(m*R^2*I1))*V*omega_n*1/R */
    const double t48 = JLT_FMS(t28, t33, t47); /* ((I1 - I3)/I1*gamma3*omega_tau*s - a3*I3/(R*I1)*omega_tau*s)*omega3*1/(Theta/(m*R^2*I1)) - 1/(Theta/(m*R^2*I1))*V*omega_n*1/R */
    out[4] = t48;
    const double t49 = cos(x[5]); /* C = cos(chi) */
    const double t50 = sin(x[5]); /* S = sin(chi) */
    const double t51 = x[1]*t49; /* v_nu*C */
    const double t52 = JLT_FMA(t44, t50, t51); /* v_tau*S + v_nu*C */
    out[7] = t52;
    const double t53 = x[1]*t50; /* v_nu*S */
    const double t54 = JLT_FNMA(t44, t49, t53); /* v_nu*S - v_tau*C */
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
    const double t26 = x[3]*t25; /* omega_n*1/D */
    const double t27 = x[0]*p[20]; /* gamma3*2*m*a3^2 */
    const double t28 = t14*t26; /* gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n*1/D */
    const double t29 = x[4]*t25; /* omega3*1/D */
    const double t30 = JLT_FMA(p[10], t29, t28); /* I3/I1*omega3*1/D + gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n*1/D */
    const double t31 = t13*t17; /* 1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t32 = t13*t31; /* 1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    out[54] = t32;
    const double t33 = JLT_FMA(t27, t30, t32); /* gamma3*2*m*a3^2*t30 + t32 */
    const double t34 = p[4]*t26; /* I1*omega_n*1/D */
    const double t35 = x[2]*t25; /* omega_tau*1/D */
    const double t36 = t3*t27; /* s*gamma3*2*m*a3^2 */
    const double t37 = JLT_FMS(t25, t36, t14); /* 1/D*s*gamma3*2*m*a3^2 - gamma3*1/(s^2*D*Theta)*s*D*Theta */
    const double t38 = JLT_FMA(x[0], t37, t3); /* gamma3*(1/D*s*gamma3*2*m*a3^2 - gamma3*1/(s^2*D*Theta)*s*D*Theta) + s */
    const double t39 = x[2]*p[16]; /* omega_tau*m*a3^2 */
    const double t40 = t35*t39; /* omega_tau*1/D*omega_tau*m*a3^2 */
    const double t41 = t38*t40; /* t38*omega_tau*1/D*omega_tau*m*a3^2 */
    const double t42 = t25*p[21]; /* 1/D*m*g*a3 */
    const double t43 = JLT_FNMA(t37, t42, t41); /* t38*omega_tau*1/D*omega_tau*m*a3^2 - (1/D*s*gamma3*2*m*a3^2 - gamma3*1/(s^2*D*Theta)*s*D*Theta)*1/D*m*g*a3 */
    const double t44 = JLT_FNMA(t33, t34, t43); /* t43 - (gamma3*2*m*a3^2*t30 + t32)*I1*omega_n*1/D */
    out[18] = t44;
    const double t45 = t35*t36; /* omega_tau*1/D*s*gamma3*2*m*a3^2 */
    out[20] = t45;
    const double t46 = t28*p[22]; /* gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n*1/D*(-2*I1) */
    const double t47 = JLT_FMA(t29, p[23], t46); /* omega3*1/D*(-I3) + gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n*1/D*(-2*I1) */
    out[21] = t47;
    const double t48 = t26*p[23]; /* omega_n*1/D*(-I3) */
    out[22] = t48;
    const double t49 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t50 = JLT_FMA(x[2], t49, x[1]); /* V = omega_tau*e + v_nu */
    const double t51 = t4*t24; /* 1/Theta = D*1/(D*Theta) */
    const double t52 = t50*t51; /* V*1/Theta */
    const double t53 = t13*t52; /* 1/(s^2*D*Theta)*s*D*Theta*V*1/Theta */
    const double t54 = x[0]*p[24]; /* gamma3*2*m*R^2*I1 */
    const double t55 = JLT_FMS(t5, p[25], t54); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t56 = t51*t55; /* 1/Theta*d(Theta)/d(gamma3) */
    const double t57 = t52*t56; /* V*1/Theta*1/Theta*d(Theta)/d(gamma3) */
    const double t58 = x[2]*t51; /* omega_tau*1/Theta */
    const double t59 = JLT_FNMA(p[3], t58, t57); /* V*1/Theta*1/Theta*d(Theta)/d(gamma3) - a3*omega_tau*1/Theta */
    const double t60 = JLT_FMS(t14, t53, t59); /* gamma3*1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*V*1/Theta - (V*1/Theta*1/Theta*d(Theta)/d(gamma3) - a3*omega_tau*1/Theta) */
    const double t61 = t6*t17; /* b*m*I3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t62 = t17*p[26]; /* 1/(s^2*D*Theta)*s*D*Theta*omega_n*m*R*I3 */
    const double t63 = t52*t62; /* V*1/Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n*m*R*I3 */
    const double t64 = JLT_FMA(t49, p[26], p[28]); /* e*m*R*I3 + I3^2 */
    const double t65 = JLT_FNMA(t56, t64, p[27]); /* m*R*a3*I3 - 1/Theta*d(Theta)/d(gamma3)*(e*m*R*I3 + I3^2) */
    const double t66 = x[4]*t58; /* omega3*omega_tau*1/Theta */
    const double t67 = JLT_FMS(x[2], t32, t63); /* omega_tau*t32 - V*1/Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n*m*R*I3 */
    const double t68 = JLT_FMA(t65, t66, t67); /* (m*R*a3*I3 - 1/Theta*d(Theta)/d(gamma3)*(e*m*R*I3 + I3^2))*omega3*omega_tau*1/Theta + t67 */
    const double t69 = JLT_FNMA(t60, t61, t68); /* t68 - t60*b*m*I3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    out[27] = t69;
    const double t70 = t51*t61; /* 1/Theta*b*m*I3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t71 = -t70; /* -1/Theta*b*m*I3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    out[28] = t71;
    const double t72 = t14*x[3]; /* gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t73 = x[4]*t51; /* omega3*1/Theta */
    const double t74 = JLT_FMA(t64, t73, t72); /* (e*m*R*I3 + I3^2)*omega3*1/Theta + gamma3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t75 = JLT_FNMA(t49, t70, t74); /* t74 - e*1/Theta*b*m*I3*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    out[29] = t75;
    const double t76 = JLT_FNMA(t6, t53, t15); /* omega_tau*gamma3*1/(s^2*D*Theta)*s*D*Theta - b*m*I3*1/(s^2*D*Theta)*s*D*Theta*V*1/Theta */
    out[30] = t76;
    const double t77 = t58*t64; /* omega_tau*1/Theta*(e*m*R*I3 + I3^2) */
    out[31] = t77;
    const double t78 = x[3]*p[29]; /* omega_n*m*R*I1 */
    const double t79 = t59*t78; /* (V*1/Theta*1/Theta*d(Theta)/d(gamma3) - a3*omega_tau*1/Theta)*omega_n*m*R*I1 */
    const double t80 = JLT_FNMA(x[0], p[30], p[27]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t81 = JLT_FMA(t56, t80, p[30]); /* 1/Theta*d(Theta)/d(gamma3)*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + m*R^2*(I1 - I3) */
    const double t82 = t3*t81; /* s*t81 */
    const double t83 = JLT_FMA(t14, t80, t82); /* gamma3*1/(s^2*D*Theta)*s*D*Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + s*t81 */
    const double t84 = JLT_FMA(t66, t83, t79); /* omega3*omega_tau*1/Theta*t83 + t79 */
    out[36] = t84;
    const double t85 = t51*t78; /* 1/Theta*omega_n*m*R*I1 */
    const double t86 = -t85; /* -1/Theta*omega_n*m*R*I1 */
    out[37] = t86;
    const double t87 = t49*t85; /* e*1/Theta*omega_n*m*R*I1 */
    const double t88 = t3*t80; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t89 = JLT_FMA(t73, t88, t87); /* omega3*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*1/Theta*omega_n*m*R*I1 */
    const double t90 = -t89; /* -t89 */
    out[38] = t90;
    const double t91 = t52*p[31]; /* V*1/Theta*(-m*R*I1) */
    out[39] = t91;
    const double t92 = t58*t88; /* omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t93 = -t92; /* -omega_tau*1/Theta*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[40] = t93;
    const double t94 = t14*t31; /* gamma3*1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*1/(s^2*D*Theta)*s*D*Theta*omega_n */
    const double t95 = -t94; /* -t94 */
    out[45] = t95;
    const double t96 = -t13; /* -1/(s^2*D*Theta)*s*D*Theta */
    out[48] = t96;
    const double t97 = sin(x[5]); /* S = sin(chi) */
    out[73] = t97;
    const double t98 = JLT_FNMA(t14, t22, t19); /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*1/(s^2*D*Theta)*s*D*Theta*R*omega3 */
    const double t99 = t97*t98; /* S*d(v_tau)/d(gamma3) */
    out[63] = t99;
    const double t100 = cos(x[5]); /* C = cos(chi) */
    out[64] = t100;
    const double t101 = t5*t97; /* b*S */
    out[66] = t101;
    const double t102 = t3*p[1]; /* s*R */
    const double t103 = t97*t102; /* S*s*R */
    out[67] = t103;
    const double t104 = x[1]*t97; /* v_nu*S */
    const double t105 = t5*x[3]; /* b*omega_n */
    const double t106 = JLT_FMA(t3, t22, t105); /* v_tau = s*R*omega3 + b*omega_n */
    const double t107 = JLT_FMS(t100, t106, t104); /* C*v_tau - v_nu*S */
    out[68] = t107;
    const double t108 = t98*t100; /* d(v_tau)/d(gamma3)*C */
    const double t109 = -t108; /* -d(v_tau)/d(gamma3)*C */
    out[72] = t109;
    const double t110 = t5*t100; /* b*C */
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
    out[11] = t13;
    const double t14 = t4*t13; /* D*s */
    const double t15 = t11*t14; /* Theta*1/(Theta*s^2*D)*D*s */
    const double t16 = t2*t11; /* 1/D = s^2*Theta*1/(Theta*s^2*D) */
    const double t17 = -t15; /* -Theta*1/(Theta*s^2*D)*D*s */
    out[57] = t17;
    const double t18 = x[3]*t15; /* omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t19 = -t18; /* -omega_n*Theta*1/(Theta*s^2*D)*D*s */
    out[5] = t19;
    const double t20 = x[0]*t16; /* gamma3*1/D */
    const double t21 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t22 = x[2]*t13; /* omega_tau*s */
    out[0] = t22;
    const double t23 = p[9]*t13; /* m*g*a3/I1*s */
    const double t24 = t16*t23; /* 1/D*m*g*a3/I1*s */
    const double t25 = t18*t20; /* omega_n*Theta*1/(Theta*s^2*D)*D*s*gamma3*1/D */
    const double t26 = x[4]*t16; /* omega3*1/D */
    const double t27 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t28 = t12*t27; /* 1/Theta*V */
    const double t29 = p[31]*t28; /* (-m*R*I1)*1/Theta*V */
    out[48] = t29;
    const double t30 = JLT_FNMA(x[0], p[30], p[27]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t31 = x[4]*t12; /* omega3*1/Theta */
    const double t32 = t15*t18; /* Theta*1/(Theta*s^2*D)*D*s*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t33 = t3*t18; /* b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t34 = JLT_FMA(p[10], t26, t25); /* I3/I1*omega3*1/D + omega_n*Theta*1/(Theta*s^2*D)*D*s*gamma3*1/D */
    const double t35 = JLT_FMA(x[3], t34, t24); /* omega_n*t34 + 1/D*m*g*a3/I1*s */
    const double t36 = p[22]*t25; /* (-2*I1)*omega_n*Theta*1/(Theta*s^2*D)*D*s*gamma3*1/D */
    const double t37 = JLT_FMA(p[23], t26, t36); /* (-I3)*omega3*1/D + (-2*I1)*omega_n*Theta*1/(Theta*s^2*D)*D*s*gamma3*1/D */
    out[30] = t37;
    const double t38 = t30*t31; /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega3*1/Theta */
    const double t39 = x[0]*t15; /* gamma3*Theta*1/(Theta*s^2*D)*D*s */
    out[66] = t39;
    const double t40 = p[20]*t22; /* 2*m*a3^2*omega_tau*s */
    const double t41 = t20*t40; /* gamma3*1/D*2*m*a3^2*omega_tau*s */
    out[29] = t41;
    const double t42 = x[0]*p[24]; /* gamma3*2*m*R^2*I1 */
    const double t43 = JLT_FMS(p[25], t3, t42); /* d(Theta)/d(gamma3) = 2*m*R*I3*b - gamma3*2*m*R^2*I1 */
    const double t44 = t12*t43; /* 1/Theta*d(Theta)/d(gamma3) */
    const double t45 = t15*t32; /* Theta*1/(Theta*s^2*D)*D*s*Theta*1/(Theta*s^2*D)*D*s*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    out[63] = t45;
    const double t46 = JLT_FMA(p[27], t31, t45); /* m*R*a3*I3*omega3*1/Theta + t45 */
    const double t47 = x[2]*p[16]; /* omega_tau*m*a3^2 */
    const double t48 = JLT_FMA(p[26], t21, p[28]); /* m*R*I3*e + I3^2 */
    const double t49 = x[2]*t12; /* omega_tau*1/Theta */
    const double t50 = t22*t38; /* omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega3*1/Theta */
    const double t51 = x[3]*p[29]; /* omega_n*m*R*I1 */
    const double t52 = JLT_FMA(t28, t51, t50); /* 1/Theta*V*omega_n*m*R*I1 + t50 */
    const double t53 = t12*t51; /* 1/Theta*omega_n*m*R*I1 */
    const double t54 = -t52; /* -(1/Theta*V*omega_n*m*R*I1 + t50) */
    out[4] = t54;
    const double t55 = t44*t52; /* 1/Theta*d(Theta)/d(gamma3)*(1/Theta*V*omega_n*m*R*I1 + t50) */
    const double t56 = -t53; /* -1/Theta*omega_n*m*R*I1 */
    out[46] = t56;
    const double t57 = t21*t53; /* e*1/Theta*omega_n*m*R*I1 */
    const double t58 = JLT_FMA(t13, t38, t57); /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega3*1/Theta + e*1/Theta*omega_n*m*R*I1 */
    const double t59 = -t58; /* -t58 */
    out[47] = t59;
    const double t60 = p[1]*t13; /* R*s */
    const double t61 = x[2]*t39; /* omega_tau*gamma3*Theta*1/(Theta*s^2*D)*D*s */
    const double t62 = t41 - t61; /* gamma3*1/D*2*m*a3^2*omega_tau*s - omega_tau*gamma3*Theta*1/(Theta*s^2*D)*D*s */
    const double t63 = -t61; /* -omega_tau*gamma3*Theta*1/(Theta*s^2*D)*D*s */
    out[9] = t63;
    const double t64 = p[26]*t28; /* m*R*I3*1/Theta*V */
    const double t65 = p[19]*t28; /* m*I3*1/Theta*V */
    const double t66 = t18*t64; /* omega_n*Theta*1/(Theta*s^2*D)*D*s*m*R*I3*1/Theta*V */
    const double t67 = t15*t65; /* Theta*1/(Theta*s^2*D)*D*s*m*I3*1/Theta*V */
    const double t68 = JLT_FNMA(t3, t67, t61); /* omega_tau*gamma3*Theta*1/(Theta*s^2*D)*D*s - b*Theta*1/(Theta*s^2*D)*D*s*m*I3*1/Theta*V */
    out[39] = t68;
    const double t69 = t30*t61; /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*omega_tau*gamma3*Theta*1/(Theta*s^2*D)*D*s */
    const double t70 = t22*t30; /* omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t71 = JLT_FMA(p[30], t22, t69); /* m*R^2*(I1 - I3)*omega_tau*s + t69 */
    const double t72 = t22*t47; /* omega_tau*s*omega_tau*m*a3^2 */
    const double t73 = t12*t70; /* 1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t74 = -t73; /* -1/Theta*omega_tau*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[49] = t74;
    const double t75 = t12*t33; /* 1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t76 = JLT_FNMA(p[33], t75, t46); /* m*R*a3*I3*omega3*1/Theta + t45 - m*a3*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t77 = JLT_FMS(x[2], t76, t66); /* omega_tau*t76 - omega_n*Theta*1/(Theta*s^2*D)*D*s*m*R*I3*1/Theta*V */
    const double t78 = p[19]*t75; /* m*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t79 = -t78; /* -m*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    out[37] = t79;
    const double t80 = p[1]*x[4]; /* R*omega3 */
    const double t81 = JLT_FMA(2.0, t33, t80); /* 2*b*omega_n*Theta*1/(Theta*s^2*D)*D*s + R*omega3 */
    out[21] = t81;
    const double t82 = t48*t49; /* (m*R*I3*e + I3^2)*omega_tau*1/Theta */
    out[40] = t82;
    const double t83 = x[4]*t82; /* omega3*(m*R*I3*e + I3^2)*omega_tau*1/Theta */
    const double t84 = JLT_FNMA(t33, t65, t83); /* omega3*(m*R*I3*e + I3^2)*omega_tau*1/Theta - b*omega_n*Theta*1/(Theta*s^2*D)*D*s*m*I3*1/Theta*V */
    const double t85 = x[3]*t3; /* omega_n*b */
    const double t86 = JLT_FMA(x[4], t60, t85); /* v_tau = omega3*R*s + omega_n*b */
    const double t87 = x[3]*p[1]; /* omega_n*R */
    out[22] = t87;
    const double t88 = p[32]*t35; /* 2*m*a3^2*I1*(omega_n*t34 + 1/D*m*g*a3/I1*s) */
    const double t89 = JLT_FNMA(t47, t62, t88); /* 2*m*a3^2*I1*(omega_n*t34 + 1/D*m*g*a3/I1*s) - omega_tau*m*a3^2*t62 */
    const double t90 = t20*t89; /* gamma3*1/D*t89 */
    const double t91 = t20*t72; /* gamma3*1/D*omega_tau*s*omega_tau*m*a3^2 */
    const double t92 = JLT_FNMA(p[4], t35, t91); /* gamma3*1/D*omega_tau*s*omega_tau*m*a3^2 - I1*(omega_n*t34 + 1/D*m*g*a3/I1*s) */
    out[2] = t92;
    const double t93 = JLT_FMA(p[21], t39, t72); /* m*g*a3*gamma3*Theta*1/(Theta*s^2*D)*D*s + omega_tau*s*omega_tau*m*a3^2 */
    const double t94 = x[0]*t18; /* gamma3*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t95 = JLT_FMA(t31, t48, t94); /* omega3*1/Theta*(m*R*I3*e + I3^2) + gamma3*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t96 = JLT_FNMA(t21, t78, t95); /* t95 - e*m*I3*1/Theta*b*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    out[38] = t96;
    const double t97 = JLT_FMA(x[2], t94, t84); /* omega_tau*gamma3*omega_n*Theta*1/(Theta*s^2*D)*D*s + t84 */
    out[3] = t97;
    const double t98 = x[4] + t94; /* omega3 + gamma3*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    out[6] = t98;
    const double t99 = cos(x[5]); /* C = cos(chi) */
    out[73] = t99;
    const double t100 = sin(x[5]); /* S = sin(chi) */
    out[82] = t100;
    const double t101 = t3*t100; /* b*S */
    out[75] = t101;
    const double t102 = t3*t99; /* b*C */
    const double t103 = -t102; /* -b*C */
    out[84] = t103;
    const double t104 = t60*t100; /* R*s*S */
    out[76] = t104;
    const double t105 = t60*t99; /* R*s*C */
    const double t106 = -t105; /* -R*s*C */
    out[85] = t106;
    const double t107 = t33*t39; /* b*omega_n*Theta*1/(Theta*s^2*D)*D*s*gamma3*Theta*1/(Theta*s^2*D)*D*s */
    const double t108 = JLT_FNMA(t67, t107, t77); /* t77 - Theta*1/(Theta*s^2*D)*D*s*m*I3*1/Theta*V*t107 */
    const double t109 = JLT_FNMA(t44, t84, t108); /* t77 - Theta*1/(Theta*s^2*D)*D*s*m*I3*1/Theta*V*t107 - 1/Theta*d(Theta)/d(gamma3)*t84 */
    out[36] = t109;
    const double t110 = t33 + t80; /* b*omega_n*Theta*1/(Theta*s^2*D)*D*s + R*omega3 */
    const double t111 = x[3]*t110; /* omega_n*(b*omega_n*Theta*1/(Theta*s^2*D)*D*s + R*omega3) */
    out[1] = t111;
    const double t112 = JLT_FNMA(t39, t80, t87); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*Theta*1/(Theta*s^2*D)*D*s*R*omega3 */
    const double t113 = t87 + t107; /* omega_n*R + t107 */
    const double t114 = t18*t113; /* omega_n*Theta*1/(Theta*s^2*D)*D*s*(omega_n*R + t107) */
    out[18] = t114;
    const double t115 = p[4]*t18; /* I1*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t116 = JLT_FNMA(t32, t115, t93); /* t93 - Theta*1/(Theta*s^2*D)*D*s*omega_n*Theta*1/(Theta*s^2*D)*D*s*I1*omega_n*Theta*1/(Theta*s^2*D)*D*s */
    const double t117 = JLT_FMS(t16, t116, t90); /* 1/D*t116 - gamma3*1/D*t89 */
    out[27] = t117;
    const double t118 = t32*t39; /* Theta*1/(Theta*s^2*D)*D*s*omega_n*Theta*1/(Theta*s^2*D)*D*s*gamma3*Theta*1/(Theta*s^2*D)*D*s */
    const double t119 = -t118; /* -t118 */
    out[54] = t119;
    const double t120 = t100*t112; /* S*d(v_tau)/d(gamma3) */
    out[72] = t120;
    const double t121 = t99*t112; /* C*d(v_tau)/d(gamma3) */
    const double t122 = -t121; /* -C*d(v_tau)/d(gamma3) */
    out[81] = t122;
    const double t123 = x[3]*p[34]; /* omega_n*m*R*a3*I1 */
    const double t124 = JLT_FNMA(t49, t123, t55); /* 1/Theta*d(Theta)/d(gamma3)*(1/Theta*V*omega_n*m*R*I1 + t50) - omega_tau*1/Theta*omega_n*m*R*a3*I1 */
    const double t125 = JLT_FMA(t31, t71, t124); /* omega3*1/Theta*(m*R^2*(I1 - I3)*omega_tau*s + t69) + t124 */
    out[45] = t125;
    const double t126 = x[1]*t99; /* v_nu*C */
    const double t127 = JLT_FMA(t86, t100, t126); /* v_tau*S + v_nu*C */
    out[7] = t127;
    out[86] = t127;
    const double t128 = t86*t99; /* v_tau*C */
    const double t129 = x[1]*t100; /* v_nu*S */
    const double t130 = t129 - t128; /* v_nu*S - v_tau*C */
    out[8] = t130;
    const double t131 = t128 - t129; /* v_tau*C - v_nu*S */
    out[77] = t131;
    const double t132 = x[3]*p[23]; /* omega_n*(-I3) */
    const double t133 = t16*t132; /* 1/D*omega_n*(-I3) */
    out[31] = t133;
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
    const double t9 = p[20]*t6; /* 2*m*a3^2*Theta */
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
    const double t21 = p[30]*t20; /* m*R^2*(I1 - I3)*gamma3*omega_tau*s */
    const double t22 = JLT_FNMA(p[27], t19, t21); /* m*R^2*(I1 - I3)*gamma3*omega_tau*s - m*R*a3*I3*omega_tau*s */
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
    const double t3 = p[21]*x[0]; /* m*g*a3*gamma3 */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = x[3]*p[36]; /* omega_n*1/2*I1 */
    const double t6 = JLT_FMA(x[3], t5, t3); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t7 = x[3]*t4; /* omega_n*b */
    const double t8 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t10 = p[1]*x[4]; /* R*omega3 */
    const double t11 = JLT_FMA(t8, t10, t7); /* v_tau = s*R*omega3 + omega_n*b */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = x[4]*p[37]; /* omega3*1/2*I3 */
    const double t15 = JLT_FMA(x[4], t14, t6); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(t9, t13, t15); /* D*omega_tau*1/2*omega_tau + t15 */
    const double t17 = x[1]*x[1]; /* v_nu*v_nu */
    const double t18 = JLT_FMA(t11, t11, t17); /* v_tau*v_tau + v_nu*v_nu */
    const double t19 = JLT_FMA(p[35], t18, t16); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t15 */
    out[0] = t19;
    const double t20 = x[3]*p[38]; /* omega_n*R*I1 */
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
    const double t5 = p[23]*t4; /* (-I3)*b */
    out[13] = t5;
    const double t6 = sqrt(t3); /* s = sqrt(s^2) */
    const double t7 = p[38]*t6; /* R*I1*s */
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
    const double t18 = JLT_FNMA(t16, t17, p[21]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t19 = x[3]*p[40]; /* omega_n*(-R*I1) */
    const double t20 = t9*t19; /* s*gamma3/s^2*omega_n*(-R*I1) */
    const double t21 = JLT_FMA(x[4], p[41], t20); /* omega3*(-R*I3) + s*gamma3/s^2*omega_n*(-R*I1) */
    out[9] = t21;
    const double t22 = JLT_FNMA(x[4], t9, x[3]); /* d(v_tau)/d(gamma3)/R = omega_n - omega3*s*gamma3/s^2 */
    const double t23 = p[39]*t15; /* m*R*v_tau */
    const double t24 = JLT_FMA(t22, t23, t18); /* d(v_tau)/d(gamma3)/R*m*R*v_tau + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    out[0] = t24;
    const double t25 = x[3]*p[4]; /* omega_n*I1 */
    const double t26 = JLT_FMA(t13, t15, t25); /* m*b*v_tau + omega_n*I1 */
    out[3] = t26;
    const double t27 = x[4]*p[5]; /* omega3*I3 */
    const double t28 = JLT_FMA(t6, t23, t27); /* s*m*R*v_tau + omega3*I3 */
    out[4] = t28;
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
        t28[k] = jlt_jet_product(x3, t22, k);
        t29[k] = jlt_jet_product(t23, t24, k);
        t30[k] = jlt_jet_product(x3, t24, k);
        t31[k] = jlt_jet_product(t27, t29, k);
        t32[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t31, t32, k);
        t33[k] = jlt_jet_product(t27, t32, k);
        t34[k] = jlt_jet_product(t29, t32, k);
        t35[k] = jlt_jet_product(t30, t33, k);
        t36[k] = jlt_jet_product(t23, t33, k);
        t37[k] = -t35[k];
        t38[k] = jlt_jet_product(x2, t23, k);
        t39[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t40[k] = jlt_jet_product(x0, t38, k);
        t41[k] = x2[k]*p[6];
        t42[k] = jlt_jet_product(t40, t41, k);
        t43[k] = t42[k] - p[9]*t23[k];
        t44[k] = p[14]*t40[k];
        t45[k] = t44[k] - p[15]*t38[k];
        t46[k] = (k == 0 ? p[12] : 0) + t39[k];
        t47[k] = p[11]*t46[k];
        t48[k] = jlt_jet_product(x2, t39, k) + x1[k];
        t49[k] = jlt_jet_product(t34, t48, k);
        t50[k] = jlt_jet_product(x4, t34, k);
        t51[k] = jlt_jet_product(t26, t49, k);
        t52[k] = jlt_jet_product(x0, t35, k);
        t53[k] = jlt_jet_product(t47, t50, k) + t52[k];
        t54[k] = jlt_jet_product(x2, t53, k);
        t55[k] = t54[k] - jlt_jet_product(t35, t51, k);
        t56[k] = jlt_jet_product(t28, t35, k);
        t57[k] = x4[k] + t52[k];
        t58[k] = x4[k]*p[10] + t52[k];
        t59[k] = t43[k] - jlt_jet_product(x3, t58, k);
        t60[k] = jlt_jet_product(t36, t59, k);
        t61[k] = p[1]*x4[k];
        t62[k] = jlt_jet_product(t23, t61, k) + t28[k];
        t63[k] = jlt_jet_product(x3, t61, k) + t56[k];
        t64[k] = x3[k]*p[13];
        t65[k] = jlt_jet_product(t49, t64, k);
        t66[k] = jlt_jet_product(t45, t50, k) - t65[k];
        t67[k] = jlt_jet_cosine(x5, t67, u67, k);
        t68[k] = jlt_jet_sine(x5, t68, u68, k);
        t69[k] = jlt_jet_product(x1, t67, k);
        t70[k] = jlt_jet_product(t62, t68, k) + t69[k];
        t71[k] = jlt_jet_product(x1, t68, k);
        t72[k] = t71[k] - jlt_jet_product(t62, t67, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t38[k]/(k + 1);
        next[1] = x1[k + 1] = t63[k]/(k + 1);
        next[2] = x2[k + 1] = t60[k]/(k + 1);
        next[3] = x3[k + 1] = t55[k]/(k + 1);
        next[4] = x4[k + 1] = t66[k]/(k + 1);
        next[5] = x5[k + 1] = t37[k]/(k + 1);
        next[6] = x6[k + 1] = t57[k]/(k + 1);
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
    .sha256 = "e5eebb5567edc15e7cc6fede26c131ca64344936d08ff51ea4e1a4b893121228",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .state_count = 9, .param_count = 6, .prepared_count = 42,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 9, { 6, 29, 16, 1, 1, 2, 13, 12 }, { 22, 77, 0, 14, 1, 2, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, ((I1 - I3)/I1)*gamma3*omega_tau*s - (a3*I3/(R*I1))*omega_tau*s, I3/(m*R) + e, V = omega_tau*e + v_nu, a part of d(omega_n)/dt, d(omega_n)/dt, d(spin)/dt, a part of d(omega_tau)/dt, a part of d(omega_tau)/dt, v_tau = s*R*omega3 + omega_n*b, d(v_nu)/dt, d(omega3)/dt, d(x)/dt, d(y)/dt" },
    .jacobian = { jacobian, 81, { 12, 65, 35, 1, 1, 2, 14, 25 }, { 61, 296, 0, 55, 1, 2, 16, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega_n), (I3/I1)*omega3*1/D + gamma3*((1)/s^2*D*Theta)*s*D*Theta*omega_n*1/D, a part of d(d(omega_tau)/dt)/d(gamma3), 1/D*s*gamma3*(2*m*a3^2) - gamma3*((1)/s^2*D*Theta)*s*D*Theta, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega_n), e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(Theta)/d(gamma3) = b*(2*m*R*I3) - gamma3*(2*m*R^2*I1), V*1/Theta*1/Theta*d(Theta)/d(gamma3) - a3*omega_tau*1/Theta, a part of d(d(omega_n)/dt)/d(gamma3), e*(m*R*I3) + I3^2, m*R*a3*I3 - 1/Theta*d(Theta)/d(gamma3)*(e*(m*R*I3) + I3^2), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), d(d(omega_n)/dt)/d(omega_n), m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau), d(v_tau)/d(gamma3) = R*omega_n - gamma3*((1)/s^2*D*Theta)*s*D*Theta*R*omega3, v_tau = s*R*omega3 + b*omega_n, d(d(x)/dt)/d(chi), d(d(y)/dt)/d(chi)" },
    .rhs_jacobian = { rhs_jacobian, 90, { 20, 74, 36, 1, 1, 2, 16, 28 }, { 75, 353, 0, 69, 1, 2, 16, 14 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, V = omega_tau*e + v_nu, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), (I3/I1)*omega3*1/D + omega_n*Theta*((1)/Theta*s^2*D)*D*s*gamma3*1/D, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(omega_n), d(Theta)/d(gamma3) = (2*m*R*I3)*b - gamma3*(2*m*R^2*I1), (m*R*I3)*e + I3^2, a part of d(omega3)/dt and of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega3)/dt)/d(omega_tau), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), a part of d(d(omega3)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), d(d(v_nu)/dt)/d(omega_n), a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(gamma3), v_tau = omega3*R*s + omega_n*b, a part of d(d(omega_tau)/dt)/d(gamma3), d(omega_tau)/dt, d(d(omega_n)/dt)/d(omega_tau), d(omega_n)/dt, d(spin)/dt, d(d(omega_n)/dt)/d(gamma3), b*omega_n*Theta*((1)/Theta*s^2*D)*D*s + R*omega3, d(v_tau)/d(gamma3) = omega_n*R - gamma3*Theta*((1)/Theta*s^2*D)*D*s*R*omega3, a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi)" },
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
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
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
