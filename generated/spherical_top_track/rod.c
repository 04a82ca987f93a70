/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top_track, SHA-256 6846e2a6e2e89b5e5aa4c7b67fe5e7f138d28ea2677fe5f4b40745ae5674af39
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   20   11    1    1    2     10    8   (67)
 *  jacobian            11   45   17    1    1    2     13   14   (212)
 *  rhs_jacobian        14   52   20    1    1    2     13   17   (259)
 *  divergence          2    4    2    1    1    0      6    4   (18)
 *  integral_values     2   12    9    0    1    2      6    7   (44)
 *  integral_gradients  5   23    9    1    1    2      8    9   (65)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3,
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), d(omega_tau)/dt,
 *      a part of d(d(omega_tau)/dt)/d(gamma3), e = gamma3*a3 + R, V = omega_tau*e + v_nu,
 *      1/s^2*s*omega3*1/s^2 - (a3/R)*1/s^2*s*omega_n*1/s^2*s, a part of d(d(omega_tau)/dt)/d(gamma3),
 *      d(d(omega_tau)/dt)/d(gamma3), v_tau = s*R*omega3 + omega_n*b, d(d(v_nu)/dt)/d(omega_n),
 *      d(d(omega3)/dt)/d(omega_tau), d(omega3)/dt, d(d(omega3)/dt)/d(gamma3),
 *      d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*R*omega3, R*omega3 + omega_n*1/s^2*s*b,
 *      gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R, d(spin)/dt, d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi)
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
extern const jlt_descriptor jlt_kernels_spherical_top_track_rod;
extern const struct jlt_ball_table jlt_balls_spherical_top_track_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_rod_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_rod_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_rod_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
}

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
    out[14] = t1;
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    out[6] = t2;
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[3]*t3; /* a3*m*g */
    out[16] = t4;
    const double t5 = t4/params[4]; /* a3*m*g/I1 */
    out[7] = t5;
    const double t6 = 1.0/params[1]; /* 1/R */
    out[8] = t6;
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t0*t7; /* a3*a3*m*2 */
    out[15] = t8;
    const double t9 = t8/params[4]; /* a3*a3*m*2/I1 */
    out[9] = t9;
    const double t10 = params[3]/params[1]; /* a3/R */
    out[10] = t10;
    const double t11 = 2.0/params[1]; /* 2/R */
    out[11] = t11;
    const double t12 = params[0]*params[0]; /* m*m */
    const double t13 = 2.0*t12; /* 2*m*m */
    const double t14 = params[2]*t13; /* g*2*m*m */
    const double t15 = params[3]*t0; /* a3*a3*a3 */
    const double t16 = t14*t15; /* g*2*m*m*a3*a3*a3 */
    const double t17 = params[4]*params[4]; /* I1*I1 */
    const double t18 = t16/t17; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    out[12] = t18;
    const double t19 = (-1.0)/params[1]; /* (-1)/R */
    out[13] = t19;
    const double t20 = params[0]/2.0; /* m/2 */
    out[17] = t20;
    const double t21 = params[4]/2.0; /* I1/2 */
    out[18] = t21;
    const double t22 = params[4]*params[1]; /* I1*R */
    out[19] = t22;
    const double t23 = params[0]*params[1]; /* m*R */
    out[20] = t23;
    const double t24 = -t22; /* -I1*R */
    out[21] = t24;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*(1 - gamma3)*(1 + gamma3) + 1 */
    const double t5 = t3*t4; /* s*D/I1 */
    const double t6 = 1.0/t5; /* 1/(s*D/I1) */
    const double t7 = t4*t6; /* 1/s = D/I1*1/(s*D/I1) */
    const double t8 = t3*t6; /* s*1/(s*D/I1) */
    const double t9 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t10 = x[2]*t3; /* omega_tau*s */
    out[0] = t10;
    const double t11 = p[6]*t9; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t12 = t10*t11; /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t13 = JLT_FNMA(p[7], t3, t12); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s */
    const double t14 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t15 = JLT_FMA(x[2], t14, x[1]); /* V = omega_tau*e + v_nu */
    const double t16 = p[8]*t15; /* 1/R*V */
    const double t17 = x[3]*t7; /* omega_n*1/s */
    const double t18 = t9*t17; /* omega_tau*gamma3*omega_n*1/s */
    out[3] = t18;
    const double t19 = x[4]*t9; /* omega3*omega_tau*gamma3 */
    const double t20 = JLT_FNMA(t16, t17, t19); /* omega3*omega_tau*gamma3 - 1/R*V*omega_n*1/s */
    const double t21 = t7*t20; /* 1/s*(omega3*omega_tau*gamma3 - 1/R*V*omega_n*1/s) */
    out[4] = t21;
    const double t22 = -t17; /* -omega_n*1/s */
    out[5] = t22;
    const double t23 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t24 = x[3]*t23; /* omega_n*b */
    const double t25 = p[1]*x[4]; /* R*omega3 */
    const double t26 = JLT_FMA(t3, t25, t24); /* v_tau = s*R*omega3 + omega_n*b */
    const double t27 = t17*t24; /* omega_n*1/s*omega_n*b */
    const double t28 = JLT_FMA(x[3], t25, t27); /* omega_n*R*omega3 + omega_n*1/s*omega_n*b */
    out[1] = t28;
    const double t29 = x[0]*t17; /* gamma3*omega_n*1/s */
    const double t30 = JLT_FNMA(x[3], t29, t13); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s - omega_n*gamma3*omega_n*1/s */
    const double t31 = t8*t30; /* s*1/(s*D/I1)*t30 */
    out[2] = t31;
    const double t32 = x[4] + t29; /* omega3 + gamma3*omega_n*1/s */
    out[6] = t32;
    const double t33 = cos(x[5]); /* C = cos(chi) */
    const double t34 = sin(x[5]); /* S = sin(chi) */
    const double t35 = x[1]*t33; /* v_nu*C */
    const double t36 = JLT_FMA(t26, t34, t35); /* v_tau*S + v_nu*C */
    out[7] = t36;
    const double t37 = x[1]*t34; /* v_nu*S */
    const double t38 = JLT_FNMA(t26, t33, t37); /* v_nu*S - v_tau*C */
    out[8] = t38;
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
    out[22] = 0.0;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    out[31] = 0.0;
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
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t4 = t2*t3; /* s^2*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s^2*D/I1) */
    const double t6 = t3*t5; /* 1/s^2 = D/I1*1/(s^2*D/I1) */
    const double t7 = t2*t5; /* 1/(D/I1) = s^2*1/(s^2*D/I1) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t8;
    const double t9 = x[0]*p[9]; /* gamma3*2*m*a3^2/I1 */
    const double t10 = t7*t9; /* 1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t11 = t6*t8; /* 1/s^2*s */
    const double t12 = -t11; /* -1/s^2*s */
    out[48] = t12;
    const double t13 = x[0]*t11; /* gamma3*1/s^2*s */
    out[57] = t13;
    const double t14 = t8*t10; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t15 = x[2]*t14; /* omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[20] = t15;
    const double t16 = t13 - t14; /* gamma3*1/s^2*s - s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t17 = x[3]*t11; /* omega_n*1/s^2*s */
    const double t18 = x[4]*t11; /* omega3*1/s^2*s */
    const double t19 = JLT_FNMA(x[3], p[10], t18); /* omega3*1/s^2*s - omega_n*a3/R */
    const double t20 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t21 = x[2]*t20; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t22 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t23 = x[3]*p[1]; /* omega_n*R */
    out[13] = t23;
    const double t24 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t25 = p[7]*t16; /* m*g*a3/I1*(gamma3*1/s^2*s - s*1/(D/I1)*gamma3*2*m*a3^2/I1) */
    const double t26 = JLT_FMS(x[0], t16, t8); /* gamma3*(gamma3*1/s^2*s - s*1/(D/I1)*gamma3*2*m*a3^2/I1) - s */
    const double t27 = JLT_FNMA(t21, t26, t25); /* m*g*a3/I1*(gamma3*1/s^2*s - s*1/(D/I1)*gamma3*2*m*a3^2/I1) - omega_tau*omega_tau*m*a3^2/I1*(gamma3*(gamma3*1/s^2*s - s*1/(D/I1)*gamma3*2*m*a3^2/I1) - s) */
    const double t28 = p[1]*t8; /* R*s */
    const double t29 = t6*t17; /* 1/s^2*omega_n*1/s^2*s */
    out[54] = t29;
    const double t30 = x[2]*t29; /* omega_tau*1/s^2*omega_n*1/s^2*s */
    out[27] = t30;
    const double t31 = x[3]*t13; /* omega_n*gamma3*1/s^2*s */
    out[29] = t31;
    const double t32 = JLT_FMA(t10, t31, t29); /* 1/(D/I1)*gamma3*2*m*a3^2/I1*omega_n*gamma3*1/s^2*s + 1/s^2*omega_n*1/s^2*s */
    const double t33 = JLT_FNMA(x[3], t32, t27); /* t27 - omega_n*t32 */
    const double t34 = t7*t33; /* 1/(D/I1)*(t27 - omega_n*t32) */
    out[18] = t34;
    const double t35 = (-2.0)*t7; /* (-2)*1/(D/I1) */
    const double t36 = t31*t35; /* omega_n*gamma3*1/s^2*s*(-2)*1/(D/I1) */
    out[21] = t36;
    const double t37 = t6*t31; /* 1/s^2*omega_n*gamma3*1/s^2*s */
    const double t38 = -t37; /* -1/s^2*omega_n*gamma3*1/s^2*s */
    out[45] = t38;
    const double t39 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t40 = x[4]*t13; /* omega3*gamma3*1/s^2*s */
    const double t41 = t17*t24; /* omega_n*1/s^2*s*b */
    const double t42 = x[2]*t6; /* omega_tau*1/s^2 */
    const double t43 = t19*t42; /* (omega3*1/s^2*s - omega_n*a3/R)*omega_tau*1/s^2 */
    const double t44 = p[8]*t6; /* 1/R*1/s^2 */
    const double t45 = p[11]*t39; /* 2/R*V */
    const double t46 = t13*t45; /* gamma3*1/s^2*s*2/R*V */
    const double t47 = JLT_FNMA(t29, t46, t43); /* (omega3*1/s^2*s - omega_n*a3/R)*omega_tau*1/s^2 - 1/s^2*omega_n*1/s^2*s*gamma3*1/s^2*s*2/R*V */
    out[36] = t47;
    const double t48 = t39*t44; /* V*1/R*1/s^2 */
    const double t49 = -t48; /* -V*1/R*1/s^2 */
    out[39] = t49;
    const double t50 = x[3]*t44; /* omega_n*1/R*1/s^2 */
    const double t51 = JLT_FNMA(t22, t50, t40); /* omega3*gamma3*1/s^2*s - e*omega_n*1/R*1/s^2 */
    out[38] = t51;
    const double t52 = -t50; /* -omega_n*1/R*1/s^2 */
    out[37] = t52;
    const double t53 = JLT_FNMA(p[1], t40, t23); /* d(v_tau)/d(gamma3) = omega_n*R - R*omega3*gamma3*1/s^2*s */
    const double t54 = JLT_FMA(t13, t41, t23); /* gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R */
    const double t55 = t17*t54; /* omega_n*1/s^2*s*(gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R) */
    out[9] = t55;
    const double t56 = x[2]*t13; /* omega_tau*gamma3*1/s^2*s */
    out[30] = t56;
    out[40] = t56;
    const double t57 = -t56; /* -omega_tau*gamma3*1/s^2*s */
    out[0] = t57;
    const double t58 = 2.0*t41; /* 2*omega_n*1/s^2*s*b */
    const double t59 = JLT_FMA(p[1], x[4], t58); /* R*omega3 + 2*omega_n*1/s^2*s*b */
    out[12] = t59;
    const double t60 = sin(x[5]); /* S = sin(chi) */
    out[73] = t60;
    const double t61 = t53*t60; /* d(v_tau)/d(gamma3)*S */
    out[63] = t61;
    const double t62 = t24*t60; /* b*S */
    out[66] = t62;
    const double t63 = t28*t60; /* R*s*S */
    out[67] = t63;
    const double t64 = cos(x[5]); /* C = cos(chi) */
    out[64] = t64;
    const double t65 = t53*t64; /* d(v_tau)/d(gamma3)*C */
    const double t66 = -t65; /* -d(v_tau)/d(gamma3)*C */
    out[72] = t66;
    const double t67 = x[3]*t24; /* omega_n*b */
    const double t68 = JLT_FMA(x[4], t28, t67); /* v_tau = omega3*R*s + omega_n*b */
    const double t69 = t24*t64; /* b*C */
    const double t70 = -t69; /* -b*C */
    out[75] = t70;
    const double t71 = t28*t64; /* R*s*C */
    const double t72 = -t71; /* -R*s*C */
    out[76] = t72;
    const double t73 = x[1]*t60; /* v_nu*S */
    const double t74 = JLT_FMS(t64, t68, t73); /* C*v_tau - v_nu*S */
    out[68] = t74;
    const double t75 = x[1]*t64; /* v_nu*C */
    const double t76 = JLT_FMA(t60, t68, t75); /* S*v_tau + v_nu*C */
    out[77] = t76;
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
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[37] = 0.0;
    out[40] = 0.0;
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
    const double t3 = JLT_FMA(p[6], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t4 = t2*t3; /* s^2*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s^2*D/I1) */
    const double t6 = t3*t5; /* 1/s^2 = D/I1*1/(s^2*D/I1) */
    const double t7 = t2*t5; /* 1/(D/I1) = s^2*1/(s^2*D/I1) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    out[11] = t8;
    const double t9 = x[2]*t8; /* omega_tau*s */
    out[0] = t9;
    const double t10 = t6*t8; /* 1/s^2*s */
    const double t11 = -t10; /* -1/s^2*s */
    out[57] = t11;
    const double t12 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t13 = x[3]*t10; /* omega_n*1/s^2*s */
    const double t14 = -t13; /* -omega_n*1/s^2*s */
    out[5] = t14;
    const double t15 = t9*t12; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t16 = p[9]*t9; /* 2*m*a3^2/I1*omega_tau*s */
    const double t17 = x[0]*t7; /* gamma3*1/(D/I1) */
    const double t18 = t16*t17; /* 2*m*a3^2/I1*omega_tau*s*gamma3*1/(D/I1) */
    out[29] = t18;
    const double t19 = t7*t8; /* 1/(D/I1)*s */
    const double t20 = x[0]*t10; /* gamma3*1/s^2*s */
    out[66] = t20;
    const double t21 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t22 = t15*t17; /* omega_tau*s*omega_tau*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t23 = JLT_FMA(p[7], t20, t15); /* m*g*a3/I1*gamma3*1/s^2*s + omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t24 = t13*t17; /* omega_n*1/s^2*s*gamma3*1/(D/I1) */
    const double t25 = JLT_FNMA(x[3], t24, t22); /* omega_tau*s*omega_tau*m*a3^2/I1*gamma3*1/(D/I1) - omega_n*omega_n*1/s^2*s*gamma3*1/(D/I1) */
    const double t26 = (-2.0)*t24; /* (-2)*omega_n*1/s^2*s*gamma3*1/(D/I1) */
    out[30] = t26;
    const double t27 = JLT_FNMA(p[7], t19, t25); /* t25 - m*g*a3/I1*1/(D/I1)*s */
    out[2] = t27;
    const double t28 = p[12]*t19; /* 2*m^2*g*a3^3/I1^2*1/(D/I1)*s */
    const double t29 = x[2]*t20; /* omega_tau*gamma3*1/s^2*s */
    out[39] = t29;
    out[49] = t29;
    const double t30 = JLT_FMA(t12, t29, t28); /* omega_tau*m*a3^2/I1*omega_tau*gamma3*1/s^2*s + 2*m^2*g*a3^3/I1^2*1/(D/I1)*s */
    const double t31 = JLT_FNMA(p[9], t25, t30); /* t30 - 2*m*a3^2/I1*t25 */
    const double t32 = t17*t31; /* gamma3*1/(D/I1)*(t30 - 2*m*a3^2/I1*t25) */
    const double t33 = x[3]*t29; /* omega_n*omega_tau*gamma3*1/s^2*s */
    out[3] = t33;
    const double t34 = -t29; /* -omega_tau*gamma3*1/s^2*s */
    out[9] = t34;
    const double t35 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t36 = x[4]*t6; /* omega3*1/s^2 */
    const double t37 = t10*t36; /* 1/s^2*s*omega3*1/s^2 */
    const double t38 = p[1]*x[4]; /* R*omega3 */
    const double t39 = JLT_FMA(x[2], t35, x[1]); /* V = omega_tau*e + v_nu */
    const double t40 = t10*t13; /* 1/s^2*s*omega_n*1/s^2*s */
    const double t41 = JLT_FNMA(p[10], t40, t37); /* 1/s^2*s*omega3*1/s^2 - a3/R*1/s^2*s*omega_n*1/s^2*s */
    const double t42 = JLT_FNMA(t13, t40, t23); /* m*g*a3/I1*gamma3*1/s^2*s + omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    const double t43 = JLT_FMS(t7, t42, t32); /* 1/(D/I1)*t42 - gamma3*1/(D/I1)*(t30 - 2*m*a3^2/I1*t25) */
    out[27] = t43;
    const double t44 = t10*t40; /* 1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    out[63] = t44;
    const double t45 = x[2]*t41; /* omega_tau*(1/s^2*s*omega3*1/s^2 - a3/R*1/s^2*s*omega_n*1/s^2*s) */
    const double t46 = x[2]*t44; /* omega_tau*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    out[36] = t46;
    const double t47 = x[3]*t21; /* omega_n*b */
    const double t48 = JLT_FMA(t8, t38, t47); /* v_tau = s*R*omega3 + omega_n*b */
    const double t49 = p[1]*t8; /* R*s */
    const double t50 = x[3]*p[1]; /* omega_n*R */
    out[22] = t50;
    const double t51 = t13*t21; /* omega_n*1/s^2*s*b */
    const double t52 = JLT_FMA(2.0, t51, t38); /* 2*omega_n*1/s^2*s*b + R*omega3 */
    out[21] = t52;
    const double t53 = p[8]*t40; /* 1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t54 = t35*t53; /* e*1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t55 = JLT_FMS(x[4], t20, t54); /* omega3*gamma3*1/s^2*s - e*1/R*1/s^2*s*omega_n*1/s^2*s */
    out[47] = t55;
    const double t56 = t20*t40; /* gamma3*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    const double t57 = -t56; /* -gamma3*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    out[54] = t57;
    const double t58 = -t53; /* -1/R*1/s^2*s*omega_n*1/s^2*s */
    out[46] = t58;
    const double t59 = t39*t53; /* V*1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t60 = JLT_FMS(x[4], t29, t59); /* omega3*omega_tau*gamma3*1/s^2*s - V*1/R*1/s^2*s*omega_n*1/s^2*s */
    out[4] = t60;
    const double t61 = cos(x[5]); /* C = cos(chi) */
    out[73] = t61;
    const double t62 = sin(x[5]); /* S = sin(chi) */
    out[82] = t62;
    const double t63 = t21*t62; /* b*S */
    out[75] = t63;
    const double t64 = t21*t61; /* b*C */
    const double t65 = -t64; /* -b*C */
    out[84] = t65;
    const double t66 = t49*t62; /* R*s*S */
    out[76] = t66;
    const double t67 = t49*t61; /* R*s*C */
    const double t68 = -t67; /* -R*s*C */
    out[85] = t68;
    const double t69 = p[11]*t39; /* 2/R*V */
    const double t70 = t20*t69; /* gamma3*1/s^2*s*2/R*V */
    const double t71 = JLT_FNMA(t44, t70, t45); /* t45 - 1/s^2*s*1/s^2*s*omega_n*1/s^2*s*gamma3*1/s^2*s*2/R*V */
    out[45] = t71;
    const double t72 = p[13]*t39; /* (-1/R)*V */
    const double t73 = t6*t72; /* 1/s^2*(-1/R)*V */
    out[48] = t73;
    const double t74 = JLT_FNMA(t20, t38, t50); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*R*omega3 */
    const double t75 = t38 + t51; /* R*omega3 + omega_n*1/s^2*s*b */
    const double t76 = JLT_FMA(t20, t51, t50); /* gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R */
    const double t77 = t13*t76; /* omega_n*1/s^2*s*(gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R) */
    out[18] = t77;
    const double t78 = x[3]*t75; /* omega_n*(R*omega3 + omega_n*1/s^2*s*b) */
    out[1] = t78;
    const double t79 = x[3]*t20; /* omega_n*gamma3*1/s^2*s */
    out[38] = t79;
    const double t80 = x[4] + t79; /* omega3 + omega_n*gamma3*1/s^2*s */
    out[6] = t80;
    const double t81 = t62*t74; /* S*d(v_tau)/d(gamma3) */
    out[72] = t81;
    const double t82 = t61*t74; /* C*d(v_tau)/d(gamma3) */
    const double t83 = -t82; /* -C*d(v_tau)/d(gamma3) */
    out[81] = t83;
    const double t84 = x[1]*t61; /* v_nu*C */
    const double t85 = JLT_FMA(t48, t62, t84); /* v_tau*S + v_nu*C */
    out[7] = t85;
    out[86] = t85;
    const double t86 = t48*t61; /* v_tau*C */
    const double t87 = x[1]*t62; /* v_nu*S */
    const double t88 = t87 - t86; /* v_nu*S - v_tau*C */
    out[8] = t88;
    const double t89 = t86 - t87; /* v_tau*C - v_nu*S */
    out[77] = t89;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[14], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*D */
    const double t6 = JLT_FMA(t2, p[15], t4); /* (1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D */
    const double t7 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t8 = t6*t7; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D)*gamma3*omega_tau */
    const double t9 = t8/t5; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D)*gamma3*omega_tau/(s*D) */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = x[3]*t3; /* omega_n*b */
    const double t5 = p[16]*x[0]; /* m*g*a3*gamma3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = JLT_FMA(p[14], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(t6, t8, t4); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/2*omega_tau */
    const double t12 = x[3]*p[18]; /* omega_n*1/2*I1 */
    const double t13 = JLT_FMA(x[3], t12, t5); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(t7, t11, t13); /* D*omega_tau*1/2*omega_tau + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t15 = x[1]*x[1]; /* v_nu*v_nu */
    const double t16 = JLT_FMA(t9, t9, t15); /* v_tau*v_tau + v_nu*v_nu */
    const double t17 = JLT_FMA(p[17], t16, t14); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t14 */
    out[0] = t17;
    const double t18 = cos(x[5]); /* C = cos(chi) */
    const double t19 = sin(x[5]); /* S = sin(chi) */
    const double t20 = x[3]*p[19]; /* omega_n*R*I1 */
    const double t21 = t6*t20; /* s*omega_n*R*I1 */
    out[1] = t21;
    const double t22 = x[1]*t18; /* v_nu*C */
    const double t23 = JLT_FMA(t9, t19, t22); /* v_tau*S + v_nu*C */
    out[2] = t23;
    const double t24 = x[1]*t19; /* v_nu*S */
    const double t25 = JLT_FNMA(t9, t18, t24); /* v_nu*S - v_tau*C */
    out[3] = t25;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[20] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[29] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = JLT_FMA(p[14], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*t5; /* omega_tau*D */
    out[2] = t6;
    const double t7 = p[19]*t4; /* R*I1*s */
    out[12] = t7;
    const double t8 = x[0]/t4; /* gamma3/s */
    const double t9 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = JLT_FMS(x[4], t8, x[3]); /* omega3*gamma3/s - omega_n */
    const double t11 = p[1]*t10; /* R*(omega3*gamma3/s - omega_n) */
    const double t12 = x[3]*t9; /* omega_n*b */
    const double t13 = p[1]*t4; /* R*s */
    const double t14 = JLT_FMA(x[4], t13, t12); /* v_tau = omega3*R*s + omega_n*b */
    const double t15 = p[20]*t4; /* m*R*s */
    const double t16 = t14*t15; /* v_tau*m*R*s */
    out[4] = t16;
    const double t17 = p[14]*x[0]; /* m*a3^2*gamma3 */
    const double t18 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t19 = JLT_FNMA(t17, t18, p[16]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t20 = sin(x[5]); /* S = sin(chi) */
    out[28] = t20;
    const double t21 = t9*t20; /* b*S */
    out[21] = t21;
    const double t22 = t13*t20; /* R*s*S */
    out[22] = t22;
    const double t23 = cos(x[5]); /* C = cos(chi) */
    out[19] = t23;
    const double t24 = t13*t23; /* R*s*C */
    const double t25 = -t24; /* -R*s*C */
    out[31] = t25;
    const double t26 = t11*t23; /* R*(omega3*gamma3/s - omega_n)*C */
    out[27] = t26;
    const double t27 = p[0]*t14; /* m*v_tau */
    const double t28 = JLT_FNMA(t11, t27, t19); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau - R*(omega3*gamma3/s - omega_n)*m*v_tau */
    out[0] = t28;
    const double t29 = t11*t20; /* R*(omega3*gamma3/s - omega_n)*S */
    const double t30 = -t29; /* -R*(omega3*gamma3/s - omega_n)*S */
    out[18] = t30;
    const double t31 = x[3]*p[4]; /* omega_n*I1 */
    const double t32 = JLT_FMA(t9, t27, t31); /* b*m*v_tau + omega_n*I1 */
    out[3] = t32;
    const double t33 = t9*t23; /* b*C */
    const double t34 = -t33; /* -b*C */
    out[30] = t34;
    const double t35 = x[3]*p[21]; /* omega_n*(-R*I1) */
    const double t36 = t8*t35; /* gamma3/s*omega_n*(-R*I1) */
    out[9] = t36;
    const double t37 = x[1]*t20; /* v_nu*S */
    const double t38 = JLT_FMS(t14, t23, t37); /* v_tau*C - v_nu*S */
    out[23] = t38;
    const double t39 = x[1]*t23; /* v_nu*C */
    const double t40 = JLT_FMA(t14, t20, t39); /* v_tau*S + v_nu*C */
    out[32] = t40;
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
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
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
    double u45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double u46[JLT_JET_ORDER_MAX + 1];
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
        t12[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t13[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t14[k] = jlt_jet_product(t12, t13, k);
        t15[k] = jlt_jet_root(t14[k], t15, k);
        t16[k] = p[6]*t14[k] + (k == 0 ? 1.0 : 0);
        t17[k] = jlt_jet_product(t15, t16, k);
        t18[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t17, t18, k);
        t19[k] = jlt_jet_product(t16, t18, k);
        t20[k] = jlt_jet_product(t15, t18, k);
        t21[k] = jlt_jet_product(x2, x0, k);
        t22[k] = jlt_jet_product(x2, t15, k);
        t23[k] = p[6]*t21[k];
        t24[k] = jlt_jet_product(t22, t23, k);
        t25[k] = t24[k] - p[7]*t15[k];
        t26[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t27[k] = jlt_jet_product(x2, t26, k) + x1[k];
        t28[k] = p[8]*t27[k];
        t29[k] = jlt_jet_product(x3, t19, k);
        t30[k] = jlt_jet_product(t21, t29, k);
        t31[k] = jlt_jet_product(x4, t21, k);
        t32[k] = t31[k] - jlt_jet_product(t28, t29, k);
        t33[k] = jlt_jet_product(t19, t32, k);
        t34[k] = -t29[k];
        t35[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t36[k] = jlt_jet_product(x3, t35, k);
        t37[k] = p[1]*x4[k];
        t38[k] = jlt_jet_product(t15, t37, k) + t36[k];
        t39[k] = jlt_jet_product(t29, t36, k);
        t40[k] = jlt_jet_product(x3, t37, k) + t39[k];
        t41[k] = jlt_jet_product(x0, t29, k);
        t42[k] = t25[k] - jlt_jet_product(x3, t41, k);
        t43[k] = jlt_jet_product(t20, t42, k);
        t44[k] = x4[k] + t41[k];
        t45[k] = jlt_jet_cosine(x5, t45, u45, k);
        t46[k] = jlt_jet_sine(x5, t46, u46, k);
        t47[k] = jlt_jet_product(x1, t45, k);
        t48[k] = jlt_jet_product(t38, t46, k) + t47[k];
        t49[k] = jlt_jet_product(x1, t46, k);
        t50[k] = t49[k] - jlt_jet_product(t38, t45, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t22[k]/(k + 1);
        next[1] = x1[k + 1] = t40[k]/(k + 1);
        next[2] = x2[k + 1] = t43[k]/(k + 1);
        next[3] = x3[k + 1] = t30[k]/(k + 1);
        next[4] = x4[k + 1] = t33[k]/(k + 1);
        next[5] = x5[k + 1] = t34[k]/(k + 1);
        next[6] = x6[k + 1] = t44[k]/(k + 1);
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
    const double v_I3 = (0.0);
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
    { "v_x", "I3 = 0" },
    { "v_y", "I3 = 0" },
};

static const signed char signs_9[] = { 1, -1, -1, 1, 1, -1, -1, 1, -1 };
static const jlt_reversor reversors[] = {
    { signs_9, 9 },
};

const jlt_descriptor jlt_kernels_spherical_top_track_rod = {
    .model = "spherical_top_track",
    .variant = "rod",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "6846e2a6e2e89b5e5aa4c7b67fe5e7f138d28ea2677fe5f4b40745ae5674af39",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .state_count = 9, .param_count = 6, .prepared_count = 22,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 9, { 4, 20, 11, 1, 1, 2, 10, 8 }, { 14, 41, 0, 9, 1, 2, 9, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega3*omega_tau*gamma3 - (1/R)*V*omega_n*1/s, b = gamma3*R + a3, v_tau = s*R*omega3 + omega_n*b, d(v_nu)/dt, a part of d(omega_tau)/dt, d(spin)/dt, d(x)/dt, d(y)/dt" },
    .jacobian = { jacobian, 81, { 11, 45, 17, 1, 1, 2, 13, 14 }, { 32, 144, 0, 33, 1, 2, 15, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in gamma3*1/s^2*s - s*1/(D/I1)*gamma3*(2*m*a3^2/I1), omega3*1/s^2*s - omega_n*(a3/R), e = gamma3*a3 + R, b = gamma3*R + a3, gamma3*(gamma3*1/s^2*s - s*1/(D/I1)*gamma3*(2*m*a3^2/I1)) - s, a part of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(omega_tau), d(v_tau)/d(gamma3) = omega_n*R - R*omega3*gamma3*1/s^2*s, gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R, d(d(v_nu)/dt)/d(omega_n), v_tau = omega3*R*s + omega_n*b, d(d(x)/dt)/d(chi), d(d(y)/dt)/d(chi)" },
    .rhs_jacobian = { rhs_jacobian, 90, { 14, 52, 20, 1, 1, 2, 13, 17 }, { 40, 174, 0, 42, 1, 2, 15, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), d(omega_tau)/dt, a part of d(d(omega_tau)/dt)/d(gamma3), e = gamma3*a3 + R, V = omega_tau*e + v_nu, 1/s^2*s*omega3*1/s^2 - (a3/R)*1/s^2*s*omega_n*1/s^2*s, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), v_tau = s*R*omega3 + omega_n*b, d(d(v_nu)/dt)/d(omega_n), d(d(omega3)/dt)/d(omega_tau), d(omega3)/dt, d(d(omega3)/dt)/d(gamma3), d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*R*omega3, R*omega3 + omega_n*1/s^2*s*b, gamma3*1/s^2*s*omega_n*1/s^2*s*b + omega_n*R, d(spin)/dt, d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi)" },
    .divergence = { divergence, 1, { 2, 4, 2, 1, 1, 0, 6, 4 }, { 3, 12, 0, 2, 1, 0, 9, 5 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes" },
    .integral_values = { integral_values, 4, { 2, 12, 9, 0, 1, 2, 6, 7 }, { 10, 31, 0, 0, 1, 2, 11, 6 },
        "takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = s*R*omega3 + omega_n*b, E, v_x, v_y" },
    .integral_gradients = { integral_gradients, 36, { 5, 23, 9, 1, 1, 2, 8, 9 }, { 14, 46, 0, 2, 1, 2, 8, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, omega3*(gamma3/s) - omega_n, v_tau = omega3*R*s + omega_n*b, d(E)/d(gamma3), d(E)/d(omega_n), d(v_x)/d(chi), d(v_y)/d(chi)" },
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
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_track_rod) },
#endif
};
