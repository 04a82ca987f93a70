/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top_track, SHA-256 625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   20   11    1    1    2     10    9   (67)
 *  jacobian            10   47   17    1    1    2     14   16   (212)
 *  rhs_jacobian        15   52   18    1    1    2     13   21   (259)
 *  divergence          2    4    2    1    1    0      6    4   (18)
 *  integral_values     2   12    9    0    1    2      6    7   (44)
 *  integral_gradients  5   23    9    1    1    2      8    9   (65)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in m*g*a3/I1 - omega_tau*(m*a3^2/I1)*omega_tau*gamma3,
 *      b = gamma3*R + a3, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), d(spin)/dt, e = gamma3*a3 + R,
 *      V = omega_tau*e + v_nu, 1/s^2*s*omega3*1/s^2 - (a3/R)*1/s^2*s*omega_n*1/s^2*s, v_tau = s*R*omega3 + omega_n*b,
 *      d(d(v_nu)/dt)/d(omega_n), d(d(omega3)/dt)/d(omega_tau), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      d(d(omega3)/dt)/d(gamma3), d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*R*omega3,
 *      R*omega3 + b*omega_n*1/s^2*s, gamma3*1/s^2*s*b*omega_n*1/s^2*s + omega_n*R, d(omega3)/dt, d(x)/dt,
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
    out[13] = t1;
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    out[6] = t2;
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[3]*t3; /* a3*m*g */
    out[15] = t4;
    const double t5 = t4/params[4]; /* a3*m*g/I1 */
    out[7] = t5;
    const double t6 = 1.0/params[1]; /* 1/R */
    out[8] = t6;
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t0*t7; /* a3*a3*m*2 */
    out[14] = t8;
    const double t9 = t8/params[4]; /* a3*a3*m*2/I1 */
    out[9] = t9;
    const double t10 = params[3]/params[1]; /* a3/R */
    out[10] = t10;
    const double t11 = 2.0/params[1]; /* 2/R */
    out[11] = t11;
    const double t12 = (-1.0)/params[1]; /* (-1)/R */
    out[12] = t12;
    const double t13 = params[0]/2.0; /* m/2 */
    out[16] = t13;
    const double t14 = params[4]/2.0; /* I1/2 */
    out[17] = t14;
    const double t15 = params[4]*params[1]; /* I1*R */
    out[18] = t15;
    const double t16 = params[0]*params[1]; /* m*R */
    out[19] = t16;
    const double t17 = -t15; /* -I1*R */
    out[20] = t17;
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
    const double t17 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t18 = x[3]*t7; /* omega_n*1/s */
    const double t19 = t9*t18; /* omega_tau*gamma3*omega_n*1/s */
    out[3] = t19;
    const double t20 = x[4]*t9; /* omega3*omega_tau*gamma3 */
    const double t21 = JLT_FNMA(t16, t18, t20); /* omega3*omega_tau*gamma3 - 1/R*V*omega_n*1/s */
    const double t22 = t7*t21; /* 1/s*(omega3*omega_tau*gamma3 - 1/R*V*omega_n*1/s) */
    out[4] = t22;
    const double t23 = -t18; /* -omega_n*1/s */
    out[5] = t23;
    const double t24 = p[1]*x[4]; /* R*omega3 */
    const double t25 = x[0]*t18; /* gamma3*omega_n*1/s */
    const double t26 = JLT_FMA(t17, t18, t24); /* b*omega_n*1/s + R*omega3 */
    const double t27 = x[3]*t26; /* omega_n*(b*omega_n*1/s + R*omega3) */
    out[1] = t27;
    const double t28 = x[3]*t17; /* omega_n*b */
    const double t29 = JLT_FMA(t3, t24, t28); /* v_tau = s*R*omega3 + omega_n*b */
    const double t30 = JLT_FNMA(x[3], t25, t13); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s - omega_n*gamma3*omega_n*1/s */
    const double t31 = t8*t30; /* s*1/(s*D/I1)*t30 */
    out[2] = t31;
    const double t32 = x[4] + t25; /* omega3 + gamma3*omega_n*1/s */
    out[6] = t32;
    const double t33 = cos(x[5]); /* C = cos(chi) */
    const double t34 = sin(x[5]); /* S = sin(chi) */
    const double t35 = x[1]*t33; /* v_nu*C */
    const double t36 = JLT_FMA(t29, t34, t35); /* v_tau*S + v_nu*C */
    out[7] = t36;
    const double t37 = x[1]*t34; /* v_nu*S */
    const double t38 = JLT_FNMA(t29, t33, t37); /* v_nu*S - v_tau*C */
    out[8] = t38;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[58] = 1.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = JLT_FMA(t2, p[6], 1.0); /* D/I1 = s^2*m*a3^2/I1 + 1 */
    const double t5 = t2*t4; /* s^2*D/I1 */
    const double t6 = 1.0/t5; /* 1/(s^2*D/I1) */
    const double t7 = t4*t6; /* 1/s^2 = D/I1*1/(s^2*D/I1) */
    const double t8 = t3*t7; /* s*1/s^2 */
    const double t9 = x[0]*t8; /* gamma3*s*1/s^2 */
    out[57] = t9;
    const double t10 = x[2]*t9; /* omega_tau*gamma3*s*1/s^2 */
    out[30] = t10;
    out[40] = t10;
    const double t11 = -t10; /* -omega_tau*gamma3*s*1/s^2 */
    out[0] = t11;
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
    const double t12 = t8*x[3]; /* s*1/s^2*omega_n */
    const double t13 = x[3]*p[1]; /* omega_n*R */
    out[13] = t13;
    const double t14 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t15 = t12*t14; /* s*1/s^2*omega_n*b */
    const double t16 = JLT_FMA(t9, t15, t13); /* gamma3*s*1/s^2*s*1/s^2*omega_n*b + omega_n*R */
    const double t17 = t12*t16; /* s*1/s^2*omega_n*(gamma3*s*1/s^2*s*1/s^2*omega_n*b + omega_n*R) */
    out[9] = t17;
    const double t18 = p[1]*x[4]; /* R*omega3 */
    const double t19 = JLT_FMA(t15, 2.0, t18); /* s*1/s^2*omega_n*b*2 + R*omega3 */
    out[12] = t19;
    const double t20 = t2*t6; /* 1/(D/I1) = s^2*1/(s^2*D/I1) */
    const double t21 = x[0]*p[9]; /* gamma3*2*m*a3^2/I1 */
    const double t22 = t20*t21; /* 1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t23 = t3*t22; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t24 = t9 - t23; /* gamma3*s*1/s^2 - s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t25 = p[7]*t24; /* m*g*a3/I1*(gamma3*s*1/s^2 - s*1/(D/I1)*gamma3*2*m*a3^2/I1) */
    const double t26 = JLT_FMS(x[0], t24, t3); /* gamma3*(gamma3*s*1/s^2 - s*1/(D/I1)*gamma3*2*m*a3^2/I1) - s */
    const double t27 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t28 = x[2]*t27; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t29 = t8*t12; /* s*1/s^2*s*1/s^2*omega_n */
    const double t30 = JLT_FNMA(t12, t29, t25); /* m*g*a3/I1*(gamma3*s*1/s^2 - s*1/(D/I1)*gamma3*2*m*a3^2/I1) - s*1/s^2*omega_n*s*1/s^2*s*1/s^2*omega_n */
    const double t31 = JLT_FNMA(t26, t28, t30); /* t30 - (gamma3*(gamma3*s*1/s^2 - s*1/(D/I1)*gamma3*2*m*a3^2/I1) - s)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t32 = t20*t31; /* 1/(D/I1)*t31 */
    const double t33 = t9*x[3]; /* gamma3*s*1/s^2*omega_n */
    out[29] = t33;
    const double t34 = t20*t33; /* 1/(D/I1)*gamma3*s*1/s^2*omega_n */
    const double t35 = x[3]*t22; /* omega_n*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t36 = JLT_FNMA(t34, t35, t32); /* 1/(D/I1)*t31 - 1/(D/I1)*gamma3*s*1/s^2*omega_n*omega_n*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[18] = t36;
    const double t37 = x[2]*t23; /* omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[20] = t37;
    const double t38 = t34*(-2.0); /* 1/(D/I1)*gamma3*s*1/s^2*omega_n*(-2) */
    out[21] = t38;
    const double t39 = t8*t29; /* s*1/s^2*s*1/s^2*s*1/s^2*omega_n */
    out[54] = t39;
    const double t40 = x[2]*t39; /* omega_tau*s*1/s^2*s*1/s^2*s*1/s^2*omega_n */
    out[27] = t40;
    const double t41 = t7*x[4]; /* 1/s^2*omega3 */
    const double t42 = t8*t41; /* s*1/s^2*1/s^2*omega3 */
    const double t43 = JLT_FNMA(t29, p[10], t42); /* s*1/s^2*1/s^2*omega3 - s*1/s^2*s*1/s^2*omega_n*a3/R */
    const double t44 = x[2]*t43; /* omega_tau*(s*1/s^2*1/s^2*omega3 - s*1/s^2*s*1/s^2*omega_n*a3/R) */
    const double t45 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t46 = JLT_FMA(x[2], t45, x[1]); /* V = omega_tau*e + v_nu */
    const double t47 = p[11]*t46; /* 2/R*V */
    const double t48 = t9*t47; /* gamma3*s*1/s^2*2/R*V */
    const double t49 = JLT_FNMA(t39, t48, t44); /* t44 - s*1/s^2*s*1/s^2*s*1/s^2*omega_n*gamma3*s*1/s^2*2/R*V */
    out[36] = t49;
    const double t50 = t29*p[8]; /* s*1/s^2*s*1/s^2*omega_n*1/R */
    const double t51 = -t50; /* -s*1/s^2*s*1/s^2*omega_n*1/R */
    out[37] = t51;
    const double t52 = t45*t50; /* e*s*1/s^2*s*1/s^2*omega_n*1/R */
    const double t53 = JLT_FMS(t9, x[4], t52); /* gamma3*s*1/s^2*omega3 - e*s*1/s^2*s*1/s^2*omega_n*1/R */
    out[38] = t53;
    const double t54 = t46*p[12]; /* V*(-1/R) */
    const double t55 = t7*t54; /* 1/s^2*V*(-1/R) */
    out[39] = t55;
    const double t56 = t9*t29; /* gamma3*s*1/s^2*s*1/s^2*s*1/s^2*omega_n */
    const double t57 = -t56; /* -gamma3*s*1/s^2*s*1/s^2*s*1/s^2*omega_n */
    out[45] = t57;
    const double t58 = -t8; /* -s*1/s^2 */
    out[48] = t58;
    const double t59 = sin(x[5]); /* S = sin(chi) */
    out[73] = t59;
    const double t60 = JLT_FNMA(t9, t18, t13); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*s*1/s^2*R*omega3 */
    const double t61 = t59*t60; /* S*d(v_tau)/d(gamma3) */
    out[63] = t61;
    const double t62 = cos(x[5]); /* C = cos(chi) */
    out[64] = t62;
    const double t63 = t14*t59; /* b*S */
    out[66] = t63;
    const double t64 = t3*p[1]; /* s*R */
    const double t65 = t59*t64; /* S*s*R */
    out[67] = t65;
    const double t66 = x[1]*t59; /* v_nu*S */
    const double t67 = x[3]*t14; /* omega_n*b */
    const double t68 = JLT_FMA(t3, t18, t67); /* v_tau = s*R*omega3 + omega_n*b */
    const double t69 = JLT_FMS(t62, t68, t66); /* C*v_tau - v_nu*S */
    out[68] = t69;
    const double t70 = t60*t62; /* d(v_tau)/d(gamma3)*C */
    const double t71 = -t70; /* -d(v_tau)/d(gamma3)*C */
    out[72] = t71;
    const double t72 = t14*t62; /* b*C */
    const double t73 = -t72; /* -b*C */
    out[75] = t73;
    const double t74 = t62*t64; /* C*s*R */
    const double t75 = -t74; /* -C*s*R */
    out[76] = t75;
    const double t76 = x[1]*t62; /* v_nu*C */
    const double t77 = JLT_FMA(t59, t68, t76); /* S*v_tau + v_nu*C */
    out[77] = t77;
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
    const double t9 = t6*t8; /* 1/s^2*s */
    const double t10 = -t9; /* -1/s^2*s */
    out[57] = t10;
    const double t11 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t12 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t13 = JLT_FNMA(t11, t12, p[7]); /* m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3 */
    const double t14 = x[2]*t8; /* omega_tau*s */
    out[0] = t14;
    const double t15 = t11*t14; /* omega_tau*m*a3^2/I1*omega_tau*s */
    const double t16 = x[0]*t9; /* gamma3*1/s^2*s */
    out[66] = t16;
    const double t17 = JLT_FMA(t13, t16, t15); /* (m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3)*gamma3*1/s^2*s + omega_tau*m*a3^2/I1*omega_tau*s */
    const double t18 = t8*t13; /* s*(m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3) */
    const double t19 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t20 = x[3]*t9; /* omega_n*1/s^2*s */
    const double t21 = -t20; /* -omega_n*1/s^2*s */
    out[5] = t21;
    const double t22 = x[3]*t16; /* omega_n*gamma3*1/s^2*s */
    out[38] = t22;
    const double t23 = JLT_FMA(x[3], t22, t18); /* omega_n*omega_n*gamma3*1/s^2*s + s*(m*g*a3/I1 - omega_tau*m*a3^2/I1*omega_tau*gamma3) */
    const double t24 = t7*t23; /* 1/(D/I1)*t23 */
    const double t25 = -t24; /* -1/(D/I1)*t23 */
    out[2] = t25;
    const double t26 = x[4] + t22; /* omega3 + omega_n*gamma3*1/s^2*s */
    out[6] = t26;
    const double t27 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t28 = x[4]*t6; /* omega3*1/s^2 */
    const double t29 = t9*t28; /* 1/s^2*s*omega3*1/s^2 */
    const double t30 = p[1]*x[4]; /* R*omega3 */
    const double t31 = JLT_FMA(x[2], t27, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = t9*t20; /* 1/s^2*s*omega_n*1/s^2*s */
    const double t33 = JLT_FNMA(t20, t32, t17); /* t17 - omega_n*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    const double t34 = JLT_FNMA(p[10], t32, t29); /* 1/s^2*s*omega3*1/s^2 - a3/R*1/s^2*s*omega_n*1/s^2*s */
    const double t35 = t9*t32; /* 1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    out[63] = t35;
    const double t36 = x[2]*t34; /* omega_tau*(1/s^2*s*omega3*1/s^2 - a3/R*1/s^2*s*omega_n*1/s^2*s) */
    const double t37 = x[2]*t35; /* omega_tau*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    out[36] = t37;
    const double t38 = x[3]*t19; /* omega_n*b */
    const double t39 = JLT_FMA(t8, t30, t38); /* v_tau = s*R*omega3 + omega_n*b */
    const double t40 = p[1]*t8; /* R*s */
    const double t41 = x[3]*p[1]; /* omega_n*R */
    out[22] = t41;
    const double t42 = t19*t20; /* b*omega_n*1/s^2*s */
    const double t43 = JLT_FMA(2.0, t42, t30); /* 2*b*omega_n*1/s^2*s + R*omega3 */
    out[21] = t43;
    const double t44 = p[8]*t32; /* 1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t45 = t27*t44; /* e*1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t46 = JLT_FMS(x[4], t16, t45); /* omega3*gamma3*1/s^2*s - e*1/R*1/s^2*s*omega_n*1/s^2*s */
    out[47] = t46;
    const double t47 = t16*t32; /* gamma3*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    const double t48 = -t47; /* -gamma3*1/s^2*s*1/s^2*s*omega_n*1/s^2*s */
    out[54] = t48;
    const double t49 = -t44; /* -1/R*1/s^2*s*omega_n*1/s^2*s */
    out[46] = t49;
    const double t50 = t31*t44; /* V*1/R*1/s^2*s*omega_n*1/s^2*s */
    const double t51 = cos(x[5]); /* C = cos(chi) */
    out[73] = t51;
    const double t52 = sin(x[5]); /* S = sin(chi) */
    out[82] = t52;
    const double t53 = t19*t52; /* b*S */
    out[75] = t53;
    const double t54 = t19*t51; /* b*C */
    const double t55 = -t54; /* -b*C */
    out[84] = t55;
    const double t56 = t40*t52; /* R*s*S */
    out[76] = t56;
    const double t57 = t40*t51; /* R*s*C */
    const double t58 = -t57; /* -R*s*C */
    out[85] = t58;
    const double t59 = x[0]*p[9]; /* gamma3*2*m*a3^2/I1 */
    const double t60 = JLT_FNMA(t24, t59, t33); /* t17 - omega_n*1/s^2*s*1/s^2*s*omega_n*1/s^2*s - 1/(D/I1)*t23*gamma3*2*m*a3^2/I1 */
    const double t61 = t14*t59; /* omega_tau*s*gamma3*2*m*a3^2/I1 */
    const double t62 = t7*t60; /* 1/(D/I1)*t60 */
    out[27] = t62;
    const double t63 = t7*t61; /* 1/(D/I1)*omega_tau*s*gamma3*2*m*a3^2/I1 */
    out[29] = t63;
    const double t64 = (-2.0)*t7; /* (-2)*1/(D/I1) */
    const double t65 = t22*t64; /* omega_n*gamma3*1/s^2*s*(-2)*1/(D/I1) */
    out[30] = t65;
    const double t66 = p[11]*t31; /* 2/R*V */
    const double t67 = t16*t66; /* gamma3*1/s^2*s*2/R*V */
    const double t68 = JLT_FNMA(t35, t67, t36); /* t36 - 1/s^2*s*1/s^2*s*omega_n*1/s^2*s*gamma3*1/s^2*s*2/R*V */
    out[45] = t68;
    const double t69 = p[12]*t31; /* (-1/R)*V */
    const double t70 = t6*t69; /* 1/s^2*(-1/R)*V */
    out[48] = t70;
    const double t71 = JLT_FNMA(t16, t30, t41); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*R*omega3 */
    const double t72 = t30 + t42; /* R*omega3 + b*omega_n*1/s^2*s */
    const double t73 = JLT_FMA(t16, t42, t41); /* gamma3*1/s^2*s*b*omega_n*1/s^2*s + omega_n*R */
    const double t74 = t20*t73; /* omega_n*1/s^2*s*(gamma3*1/s^2*s*b*omega_n*1/s^2*s + omega_n*R) */
    out[18] = t74;
    const double t75 = x[3]*t72; /* omega_n*(R*omega3 + b*omega_n*1/s^2*s) */
    out[1] = t75;
    const double t76 = x[2]*t16; /* omega_tau*gamma3*1/s^2*s */
    out[39] = t76;
    out[49] = t76;
    const double t77 = JLT_FMS(x[4], t76, t50); /* omega3*omega_tau*gamma3*1/s^2*s - V*1/R*1/s^2*s*omega_n*1/s^2*s */
    out[4] = t77;
    const double t78 = x[3]*t76; /* omega_n*omega_tau*gamma3*1/s^2*s */
    out[3] = t78;
    const double t79 = -t76; /* -omega_tau*gamma3*1/s^2*s */
    out[9] = t79;
    const double t80 = t52*t71; /* S*d(v_tau)/d(gamma3) */
    out[72] = t80;
    const double t81 = t51*t71; /* C*d(v_tau)/d(gamma3) */
    const double t82 = -t81; /* -C*d(v_tau)/d(gamma3) */
    out[81] = t82;
    const double t83 = x[1]*t51; /* v_nu*C */
    const double t84 = JLT_FMA(t39, t52, t83); /* v_tau*S + v_nu*C */
    out[7] = t84;
    out[86] = t84;
    const double t85 = t39*t51; /* v_tau*C */
    const double t86 = x[1]*t52; /* v_nu*S */
    const double t87 = t86 - t85; /* v_nu*S - v_tau*C */
    out[8] = t87;
    const double t88 = t85 - t86; /* v_tau*C - v_nu*S */
    out[77] = t88;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(t2, p[13], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*D */
    const double t6 = JLT_FMA(t2, p[14], t4); /* (1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D */
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
    const double t5 = p[15]*x[0]; /* m*g*a3*gamma3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = JLT_FMA(p[13], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(t6, t8, t4); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t11 = x[2]*t10; /* omega_tau*1/2*omega_tau */
    const double t12 = x[3]*p[17]; /* omega_n*1/2*I1 */
    const double t13 = JLT_FMA(x[3], t12, t5); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(t7, t11, t13); /* D*omega_tau*1/2*omega_tau + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t15 = x[1]*x[1]; /* v_nu*v_nu */
    const double t16 = JLT_FMA(t9, t9, t15); /* v_tau*v_tau + v_nu*v_nu */
    const double t17 = JLT_FMA(p[16], t16, t14); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t14 */
    out[0] = t17;
    const double t18 = cos(x[5]); /* C = cos(chi) */
    const double t19 = sin(x[5]); /* S = sin(chi) */
    const double t20 = x[3]*p[18]; /* omega_n*R*I1 */
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
    const double t5 = JLT_FMA(p[13], t3, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t6 = x[2]*t5; /* omega_tau*D */
    out[2] = t6;
    const double t7 = p[18]*t4; /* R*I1*s */
    out[12] = t7;
    const double t8 = x[0]/t4; /* gamma3/s */
    const double t9 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = JLT_FMS(x[4], t8, x[3]); /* omega3*gamma3/s - omega_n */
    const double t11 = p[1]*t10; /* R*(omega3*gamma3/s - omega_n) */
    const double t12 = x[3]*t9; /* omega_n*b */
    const double t13 = p[1]*t4; /* R*s */
    const double t14 = JLT_FMA(x[4], t13, t12); /* v_tau = omega3*R*s + omega_n*b */
    const double t15 = p[19]*t4; /* m*R*s */
    const double t16 = t14*t15; /* v_tau*m*R*s */
    out[4] = t16;
    const double t17 = p[13]*x[0]; /* m*a3^2*gamma3 */
    const double t18 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t19 = JLT_FNMA(t17, t18, p[15]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
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
    const double t35 = x[3]*p[20]; /* omega_n*(-R*I1) */
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
    double u42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double u43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
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
        t17[k] = jlt_jet_product(x2, x0, k);
        t18[k] = jlt_jet_product(x2, t15, k);
        t19[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t15, t19, k);
        t20[k] = p[6]*t17[k];
        t21[k] = jlt_jet_product(t18, t20, k);
        t22[k] = t21[k] - p[7]*t15[k];
        t23[k] = jlt_jet_product(x3, t19, k);
        t24[k] = jlt_jet_product(t17, t23, k);
        t25[k] = jlt_jet_product(x4, t17, k);
        t26[k] = -t23[k];
        t27[k] = jlt_jet_product(x0, t23, k);
        t28[k] = t22[k] - jlt_jet_product(x3, t27, k);
        t29[k] = jlt_jet_quotient(t28[k], t16, t29, k);
        t30[k] = x4[k] + t27[k];
        t31[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t32[k] = jlt_jet_product(x2, t31, k) + x1[k];
        t33[k] = p[8]*t32[k];
        t34[k] = t25[k] - jlt_jet_product(t23, t33, k);
        t35[k] = jlt_jet_product(t19, t34, k);
        t36[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t37[k] = p[1]*x4[k];
        t38[k] = jlt_jet_product(t23, t36, k) + t37[k];
        t39[k] = jlt_jet_product(x3, t38, k);
        t40[k] = jlt_jet_product(x3, t36, k);
        t41[k] = jlt_jet_product(t15, t37, k) + t40[k];
        t42[k] = jlt_jet_cosine(x5, t42, u42, k);
        t43[k] = jlt_jet_sine(x5, t43, u43, k);
        t44[k] = jlt_jet_product(x1, t42, k);
        t45[k] = jlt_jet_product(t41, t43, k) + t44[k];
        t46[k] = jlt_jet_product(x1, t43, k);
        t47[k] = t46[k] - jlt_jet_product(t41, t42, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t18[k]/(k + 1);
        next[1] = x1[k + 1] = t39[k]/(k + 1);
        next[2] = x2[k + 1] = t29[k]/(k + 1);
        next[3] = x3[k + 1] = t24[k]/(k + 1);
        next[4] = x4[k + 1] = t35[k]/(k + 1);
        next[5] = x5[k + 1] = t26[k]/(k + 1);
        next[6] = x6[k + 1] = t30[k]/(k + 1);
        next[7] = x7[k + 1] = t45[k]/(k + 1);
        next[8] = x8[k + 1] = t47[k]/(k + 1);
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
    .sha256 = "625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .scales = 1,
    .state_count = 9, .param_count = 6, .prepared_count = 21,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 9, { 4, 20, 11, 1, 1, 2, 10, 9 }, { 14, 41, 0, 9, 1, 2, 9, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in e = gamma3*a3 + R, V = omega_tau*e + v_nu, b = gamma3*R + a3, omega3*omega_tau*gamma3 - (1/R)*V*omega_n*1/s, b*omega_n*1/s + R*omega3, v_tau = s*R*omega3 + omega_n*b, a part of d(omega_tau)/dt, d(spin)/dt, d(x)/dt, d(y)/dt" },
    .jacobian = { jacobian, 81, { 10, 47, 17, 1, 1, 2, 14, 16 }, { 32, 144, 0, 33, 1, 2, 15, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, gamma3*s*1/s^2*s*1/s^2*omega_n*b + omega_n*R, d(d(v_nu)/dt)/d(omega_n), gamma3*s*1/s^2 - s*1/(D/I1)*gamma3*(2*m*a3^2/I1), gamma3*(gamma3*s*1/s^2 - s*1/(D/I1)*gamma3*(2*m*a3^2/I1)) - s, a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), s*1/s^2*1/s^2*omega3 - s*1/s^2*s*1/s^2*omega_n*(a3/R), e = gamma3*a3 + R, V = omega_tau*e + v_nu, d(d(omega3)/dt)/d(gamma3), d(d(omega3)/dt)/d(omega_tau), d(v_tau)/d(gamma3) = omega_n*R - gamma3*s*1/s^2*R*omega3, v_tau = s*R*omega3 + omega_n*b, d(d(x)/dt)/d(chi), d(d(y)/dt)/d(chi)" },
    .rhs_jacobian = { rhs_jacobian, 90, { 15, 52, 18, 1, 1, 2, 13, 21 }, { 40, 174, 0, 42, 1, 2, 15, 12 },
        "divides by s: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in m*g*a3/I1 - omega_tau*(m*a3^2/I1)*omega_tau*gamma3, b = gamma3*R + a3, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), d(spin)/dt, e = gamma3*a3 + R, V = omega_tau*e + v_nu, 1/s^2*s*omega3*1/s^2 - (a3/R)*1/s^2*s*omega_n*1/s^2*s, v_tau = s*R*omega3 + omega_n*b, d(d(v_nu)/dt)/d(omega_n), d(d(omega3)/dt)/d(omega_tau), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega3)/dt)/d(gamma3), d(v_tau)/d(gamma3) = omega_n*R - gamma3*1/s^2*s*R*omega3, R*omega3 + b*omega_n*1/s^2*s, gamma3*1/s^2*s*b*omega_n*1/s^2*s + omega_n*R, d(omega3)/dt, d(x)/dt, d(d(y)/dt)/d(chi), d(y)/dt, d(d(x)/dt)/d(chi)" },
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
