/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   22   10    1    0    2      7    9   (69)
 *  jacobian            9   47   14    1    0    2     10   13   (181)
 *  rhs_jacobian        11   54   17    1    0    2     10   15   (233)
 *  divergence          1    4    1    1    0    0      5    4   (15)
 *  integral_values     0   12    9    0    0    2      5    6   (41)
 *  integral_gradients  4   25    8    0    0    2      5    8   (65)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = R*gamma3 + a3, d(d(v_nu)/dtau)/d(omega_n),
 *      omega_n*b + omega3*s*R, s*omega_tau*(m*a3^2/I1)*s*omega_tau - omega_n*omega_n,
 *      a part of d(d(omega_tau)/dtau)/d(s), e = a3*gamma3 + R, v_nu*S - (omega_n*b + omega3*s*R)*C, d(d(y)/dtau)/d(s),
 *      V = omega_tau*e + v_nu, omega3 - (a3/R)*omega_n*1/s, d(spin)/dtau, (omega_n*b + omega3*s*R)*S + v_nu*C,
 *      d(d(x)/dtau)/d(s), d(omega_tau)/dtau, d(omega3)/dtau, d(d(omega3)/dtau)/d(omega_tau)
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
extern const jlt_descriptor jlt_kernels_spherical_top_track_rod_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_track_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_rod_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_rod_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_rod_in_regular_avx512;

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
    const double t0 = 1.0/params[1]; /* 1/R */
    out[6] = t0;
    const double t1 = params[3]*params[3]; /* a3*a3 */
    const double t2 = params[0]*t1; /* m*a3*a3 */
    out[14] = t2;
    const double t3 = t2/params[4]; /* m*a3*a3/I1 */
    out[7] = t3;
    const double t4 = params[0]*params[2]; /* m*g */
    const double t5 = params[3]*t4; /* a3*m*g */
    out[15] = t5;
    const double t6 = t5/params[4]; /* a3*m*g/I1 */
    out[8] = t6;
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t1*t7; /* a3*a3*m*2 */
    out[13] = t8;
    const double t9 = t8/params[4]; /* a3*a3*m*2/I1 */
    out[9] = t9;
    const double t10 = params[2]*t7; /* g*m*2 */
    const double t11 = params[3]*t10; /* a3*g*m*2 */
    const double t12 = t11/params[4]; /* a3*g*m*2/I1 */
    out[10] = t12;
    const double t13 = params[3]/params[1]; /* a3/R */
    out[11] = t13;
    const double t14 = (-1.0)/params[1]; /* (-1)/R */
    out[12] = t14;
    const double t15 = params[0]/2.0; /* m/2 */
    out[16] = t15;
    const double t16 = params[4]/2.0; /* I1/2 */
    out[17] = t16;
    const double t17 = params[1]*params[4]; /* R*I1 */
    out[18] = t17;
    const double t18 = params[1]*params[0]; /* R*m */
    out[19] = t18;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t1;
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*p[6]; /* omega_n*1/R */
    const double t4 = x[9]*x[4]; /* s*omega3 */
    const double t5 = JLT_FMA(t2, t3, t4); /* b*omega_n*1/R + s*omega3 */
    const double t6 = p[1]*t5; /* R*(b*omega_n*1/R + s*omega3) */
    const double t7 = x[3]*t6; /* omega_n*R*(b*omega_n*1/R + s*omega3) */
    out[1] = t7;
    const double t8 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t9 = p[7]*t8; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t10 = t1*t9; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t11 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t12 = JLT_FNMA(x[3], t11, t10); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - omega_n*omega_n*gamma3 */
    const double t13 = JLT_FNMA(t0, p[8], t12); /* t12 - s*s*m*g*a3/I1 */
    const double t14 = JLT_FMA(t0, p[7], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t15 = x[9]*t14; /* s*D/I1 */
    const double t16 = 1.0/t15; /* 1/(s*D/I1) */
    const double t17 = x[9]*t13; /* s*(t12 - s*s*m*g*a3/I1) */
    const double t18 = t16*t17; /* 1/(s*D/I1)*s*(t12 - s*s*m*g*a3/I1) */
    out[2] = t18;
    const double t19 = x[3]*t8; /* omega_n*omega_tau*gamma3 */
    out[3] = t19;
    const double t20 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t21 = JLT_FMA(x[2], t20, x[1]); /* V = omega_tau*e + v_nu */
    const double t22 = t3*t14; /* omega_n*1/R*D/I1 */
    const double t23 = t21*t22; /* V*omega_n*1/R*D/I1 */
    const double t24 = t16*t23; /* 1/(s*D/I1)*V*omega_n*1/R*D/I1 */
    const double t25 = JLT_FMS(x[4], t8, t24); /* omega3*omega_tau*gamma3 - 1/(s*D/I1)*V*omega_n*1/R*D/I1 */
    out[4] = t25;
    const double t26 = -x[3]; /* -omega_n */
    out[5] = t26;
    const double t27 = t4 + t11; /* s*omega3 + omega_n*gamma3 */
    out[6] = t27;
    const double t28 = cos(x[5]); /* C = cos(chi) */
    const double t29 = x[1]*t28; /* v_nu*C */
    const double t30 = sin(x[5]); /* S = sin(chi) */
    const double t31 = JLT_FMA(t6, t30, t29); /* R*(b*omega_n*1/R + s*omega3)*S + v_nu*C */
    const double t32 = x[9]*t31; /* s*(R*(b*omega_n*1/R + s*omega3)*S + v_nu*C) */
    out[7] = t32;
    const double t33 = x[1]*t30; /* v_nu*S */
    const double t34 = JLT_FNMA(t6, t28, t33); /* v_nu*S - R*(b*omega_n*1/R + s*omega3)*C */
    const double t35 = x[9]*t34; /* s*(v_nu*S - R*(b*omega_n*1/R + s*omega3)*C) */
    out[8] = t35;
    const double t36 = x[9]*t8; /* s*omega_tau*gamma3 */
    const double t37 = -t36; /* -s*omega_tau*gamma3 */
    out[9] = t37;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[21] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[31] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = 0.0;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[54] = 0.0;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[68] = 0.0;
    out[72] = 0.0;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[82] = 0.0;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[91] = 0.0;
    out[93] = 0.0;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[64] = x[9];
    out[60] = x[3];
    out[63] = x[0];
    out[69] = x[4];
    out[53] = (-1.0);
    const double t0 = x[2]*x[3]; /* omega_tau*omega_n */
    out[30] = t0;
    const double t1 = x[9]*x[9]; /* s*s */
    out[2] = t1;
    const double t2 = JLT_FMA(p[7], t1, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t3 = x[9]*t2; /* s*D/I1 */
    const double t4 = 1.0/t3; /* 1/(s*D/I1) */
    const double t5 = t2*t4; /* 1/s = D/I1*1/(s*D/I1) */
    const double t6 = x[9]*t4; /* 1/(D/I1) = s*1/(s*D/I1) */
    const double t7 = x[3]*x[3]; /* omega_n*omega_n */
    const double t8 = p[1]*t7; /* R*omega_n*omega_n */
    out[10] = t8;
    const double t9 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t10 = x[9]*p[1]; /* s*R */
    const double t11 = x[9]*t6; /* s*1/(D/I1) */
    const double t12 = x[0]*p[9]; /* gamma3*2*m*a3^2/I1 */
    const double t13 = t11*t12; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t14 = x[9]*x[2]; /* s*omega_tau */
    const double t15 = 2.0*t14; /* 2*s*omega_tau */
    out[9] = t15;
    const double t16 = t13*t14; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1*s*omega_tau */
    out[22] = t16;
    const double t17 = -t14; /* -s*omega_tau */
    out[90] = t17;
    const double t18 = x[3]*t9; /* omega_n*b */
    const double t19 = x[4]*t10; /* omega3*s*R */
    const double t20 = JLT_FMA(2.0, t18, t19); /* 2*omega_n*b + omega3*s*R */
    out[13] = t20;
    const double t21 = t18 + t19; /* v_tau = omega_n*b + omega3*s*R */
    const double t22 = t19 + t21; /* omega3*s*R + v_tau */
    const double t23 = JLT_FMA(x[2], x[2], t7); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t24 = t13*t23; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t25 = JLT_FNMA(p[10], t11, t24); /* t24 - 2*m*g*a3/I1*s*1/(D/I1) */
    const double t26 = t6*t25; /* 1/(D/I1)*(t24 - 2*m*g*a3/I1*s*1/(D/I1)) */
    out[29] = t26;
    const double t27 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t28 = sin(x[5]); /* S = sin(chi) */
    const double t29 = cos(x[5]); /* C = cos(chi) */
    const double t30 = x[3]*t10; /* omega_n*s*R */
    out[14] = t30;
    const double t31 = t29*t30; /* C*omega_n*s*R */
    const double t32 = -t31; /* -C*omega_n*s*R */
    out[80] = t32;
    const double t33 = p[7]*t14; /* m*a3^2/I1*s*omega_tau */
    const double t34 = JLT_FMS(t14, t33, t7); /* s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n */
    const double t35 = t6*t34; /* 1/(D/I1)*(s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n) */
    out[20] = t35;
    const double t36 = x[3]*x[0]; /* omega_n*gamma3 */
    out[32] = t36;
    const double t37 = (-2.0)*t36; /* (-2)*omega_n*gamma3 */
    const double t38 = t6*t37; /* 1/(D/I1)*(-2)*omega_n*gamma3 */
    out[23] = t38;
    const double t39 = x[3]*t5; /* omega_n*1/s */
    const double t40 = JLT_FMA(x[2], t27, x[1]); /* V = omega_tau*e + v_nu */
    const double t41 = t5*t40; /* 1/s*V */
    const double t42 = p[12]*t41; /* (-1/R)*1/s*V */
    out[43] = t42;
    const double t43 = x[9]*t28; /* s*S */
    out[81] = t43;
    const double t44 = t9*t43; /* b*s*S */
    out[73] = t44;
    const double t45 = t10*t43; /* s*R*s*S */
    out[74] = t45;
    const double t46 = x[9]*t29; /* s*C */
    out[71] = t46;
    const double t47 = t9*t46; /* b*s*C */
    const double t48 = -t47; /* -b*s*C */
    out[83] = t48;
    const double t49 = t10*t46; /* s*R*s*C */
    const double t50 = -t49; /* -s*R*s*C */
    out[84] = t50;
    const double t51 = p[1]*x[3]; /* R*omega_n */
    const double t52 = x[4]*t51; /* omega3*R*omega_n */
    out[19] = t52;
    const double t53 = t43*t51; /* s*S*R*omega_n */
    out[70] = t53;
    const double t54 = x[2]*x[0]; /* omega_tau*gamma3 */
    out[33] = t54;
    out[44] = t54;
    const double t55 = -t54; /* -omega_tau*gamma3 */
    out[99] = t55;
    const double t56 = JLT_FNMA(p[11], t39, x[4]); /* omega3 - a3/R*omega_n*1/s */
    const double t57 = x[2]*t56; /* omega_tau*(omega3 - a3/R*omega_n*1/s) */
    out[40] = t57;
    const double t58 = p[6]*t39; /* 1/R*omega_n*1/s */
    const double t59 = t41*t58; /* 1/s*V*1/R*omega_n*1/s */
    out[49] = t59;
    const double t60 = -t58; /* -1/R*omega_n*1/s */
    out[41] = t60;
    const double t61 = x[0]*x[4]; /* gamma3*omega3 */
    const double t62 = JLT_FNMA(t27, t58, t61); /* gamma3*omega3 - e*1/R*omega_n*1/s */
    out[42] = t62;
    const double t63 = x[1]*t43; /* v_nu*s*S */
    const double t64 = JLT_FMS(t21, t46, t63); /* v_tau*s*C - v_nu*s*S */
    out[75] = t64;
    const double t65 = x[1]*t46; /* v_nu*s*C */
    const double t66 = JLT_FMA(t21, t43, t65); /* v_tau*s*S + v_nu*s*C */
    out[85] = t66;
    const double t67 = x[1]*t29; /* v_nu*C */
    const double t68 = JLT_FMA(t22, t28, t67); /* (omega3*s*R + v_tau)*S + v_nu*C */
    out[79] = t68;
    const double t69 = x[1]*t28; /* v_nu*S */
    const double t70 = JLT_FNMA(t22, t29, t69); /* v_nu*S - (omega3*s*R + v_tau)*C */
    out[89] = t70;
    const double t71 = x[9]*x[0]; /* s*gamma3 */
    const double t72 = -t71; /* -s*gamma3 */
    out[92] = t72;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[74] = x[9];
    out[70] = x[3];
    out[73] = x[0];
    out[79] = x[4];
    out[10] = 0.0;
    out[11] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[31] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[41] = 0.0;
    out[44] = 0.0;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = 0.0;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[68] = 0.0;
    out[69] = 0.0;
    out[71] = 0.0;
    out[72] = 0.0;
    out[75] = 0.0;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[82] = 0.0;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[92] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[101] = 0.0;
    out[103] = 0.0;
    out[104] = 0.0;
    out[105] = 0.0;
    out[106] = 0.0;
    out[107] = 0.0;
    out[108] = 0.0;
    out[63] = (-1.0);
    const double t0 = -x[3]; /* -omega_n */
    out[5] = t0;
    const double t1 = x[2]*x[3]; /* omega_tau*omega_n */
    out[40] = t1;
    const double t2 = x[9]*x[9]; /* s*s */
    out[12] = t2;
    const double t3 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t4 = x[9]*t3; /* s*D/I1 */
    const double t5 = 1.0/t4; /* 1/(s*D/I1) */
    const double t6 = t3*t5; /* 1/s = D/I1*1/(s*D/I1) */
    const double t7 = x[9]*t5; /* 1/(D/I1) = s*1/(s*D/I1) */
    const double t8 = x[9]*x[2]; /* s*omega_tau */
    const double t9 = x[9]*t8; /* s*s*omega_tau */
    out[0] = t9;
    const double t10 = 2.0*t8; /* 2*s*omega_tau */
    out[19] = t10;
    const double t11 = -t8; /* -s*omega_tau */
    out[100] = t11;
    const double t12 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t13 = x[9]*p[1]; /* s*R */
    const double t14 = x[3]*t12; /* omega_n*b */
    const double t15 = x[4]*t13; /* omega3*s*R */
    const double t16 = JLT_FMA(2.0, t14, t15); /* 2*omega_n*b + omega3*s*R */
    out[23] = t16;
    const double t17 = t14 + t15; /* omega_n*b + omega3*s*R */
    const double t18 = x[3]*t17; /* omega_n*(omega_n*b + omega3*s*R) */
    out[1] = t18;
    const double t19 = p[7]*t8; /* m*a3^2/I1*s*omega_tau */
    const double t20 = x[3]*x[3]; /* omega_n*omega_n */
    const double t21 = JLT_FMS(t8, t19, t20); /* s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n */
    const double t22 = t7*t21; /* 1/(D/I1)*(s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n) */
    out[30] = t22;
    const double t23 = x[0]*t22; /* gamma3*t22 */
    const double t24 = p[1]*t20; /* R*omega_n*omega_n */
    out[20] = t24;
    const double t25 = JLT_FMA(x[2], x[2], t20); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t26 = x[9]*t7; /* s*1/(D/I1) */
    const double t27 = sin(x[5]); /* S = sin(chi) */
    const double t28 = x[0]*p[9]; /* gamma3*2*m*a3^2/I1 */
    const double t29 = t26*t28; /* s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t30 = t25*t29; /* (omega_tau*omega_tau + omega_n*omega_n)*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    const double t31 = t8*t29; /* s*omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[32] = t31;
    const double t32 = x[0]*t8; /* gamma3*s*omega_tau */
    const double t33 = -t32; /* -gamma3*s*omega_tau */
    out[9] = t33;
    const double t34 = JLT_FNMA(p[10], t26, t30); /* t30 - 2*m*g*a3/I1*s*1/(D/I1) */
    const double t35 = t7*t34; /* 1/(D/I1)*(t30 - 2*m*g*a3/I1*s*1/(D/I1)) */
    out[39] = t35;
    const double t36 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t37 = x[3]*t6; /* omega_n*1/s */
    const double t38 = cos(x[5]); /* C = cos(chi) */
    const double t39 = x[1]*t27; /* v_nu*S */
    const double t40 = JLT_FNMA(t17, t38, t39); /* v_nu*S - (omega_n*b + omega3*s*R)*C */
    const double t41 = JLT_FNMA(t15, t38, t40); /* v_nu*S - (omega_n*b + omega3*s*R)*C - omega3*s*R*C */
    out[99] = t41;
    const double t42 = x[9]*t40; /* s*(v_nu*S - (omega_n*b + omega3*s*R)*C) */
    out[8] = t42;
    const double t43 = -t42; /* -s*(v_nu*S - (omega_n*b + omega3*s*R)*C) */
    out[85] = t43;
    const double t44 = JLT_FMA(x[2], t36, x[1]); /* V = omega_tau*e + v_nu */
    const double t45 = p[6]*t37; /* 1/R*omega_n*1/s */
    const double t46 = JLT_FNMA(p[11], t37, x[4]); /* omega3 - a3/R*omega_n*1/s */
    const double t47 = x[2]*t46; /* omega_tau*(omega3 - a3/R*omega_n*1/s) */
    out[50] = t47;
    const double t48 = -t45; /* -1/R*omega_n*1/s */
    out[51] = t48;
    const double t49 = x[3]*x[0]; /* omega_n*gamma3 */
    out[42] = t49;
    const double t50 = JLT_FMA(x[9], x[4], t49); /* s*omega3 + omega_n*gamma3 */
    out[6] = t50;
    const double t51 = (-2.0)*t49; /* (-2)*omega_n*gamma3 */
    const double t52 = t7*t51; /* 1/(D/I1)*(-2)*omega_n*gamma3 */
    out[33] = t52;
    const double t53 = x[1]*t38; /* v_nu*C */
    const double t54 = JLT_FMA(t17, t27, t53); /* (omega_n*b + omega3*s*R)*S + v_nu*C */
    const double t55 = JLT_FMA(t15, t27, t54); /* omega3*s*R*S + (omega_n*b + omega3*s*R)*S + v_nu*C */
    out[89] = t55;
    const double t56 = x[9]*t54; /* s*((omega_n*b + omega3*s*R)*S + v_nu*C) */
    out[7] = t56;
    out[95] = t56;
    const double t57 = x[3]*t13; /* omega_n*s*R */
    out[24] = t57;
    const double t58 = t27*t57; /* S*omega_n*s*R */
    out[80] = t58;
    const double t59 = x[9]*t27; /* s*S */
    out[91] = t59;
    const double t60 = t38*t57; /* C*omega_n*s*R */
    const double t61 = -t60; /* -C*omega_n*s*R */
    out[90] = t61;
    const double t62 = x[9]*t38; /* s*C */
    out[81] = t62;
    const double t63 = t12*t59; /* b*s*S */
    out[83] = t63;
    const double t64 = t13*t59; /* s*R*s*S */
    out[84] = t64;
    const double t65 = t12*t62; /* b*s*C */
    const double t66 = t13*t62; /* s*R*s*C */
    const double t67 = -t65; /* -b*s*C */
    out[93] = t67;
    const double t68 = -t66; /* -s*R*s*C */
    out[94] = t68;
    const double t69 = x[9]*p[8]; /* s*m*g*a3/I1 */
    const double t70 = JLT_FNMA(t26, t69, t23); /* gamma3*t22 - s*1/(D/I1)*s*m*g*a3/I1 */
    out[2] = t70;
    const double t71 = x[2]*x[0]; /* omega_tau*gamma3 */
    out[43] = t71;
    out[54] = t71;
    const double t72 = x[3]*t71; /* omega_n*omega_tau*gamma3 */
    out[3] = t72;
    const double t73 = -t71; /* -omega_tau*gamma3 */
    out[109] = t73;
    const double t74 = t44*t45; /* V*1/R*omega_n*1/s */
    const double t75 = JLT_FMS(x[4], t71, t74); /* omega3*omega_tau*gamma3 - V*1/R*omega_n*1/s */
    out[4] = t75;
    const double t76 = t6*t74; /* 1/s*V*1/R*omega_n*1/s */
    out[59] = t76;
    const double t77 = p[12]*t44; /* (-1/R)*V */
    const double t78 = t6*t77; /* 1/s*(-1/R)*V */
    out[53] = t78;
    const double t79 = x[3]*p[1]; /* omega_n*R */
    const double t80 = x[4]*t79; /* omega3*omega_n*R */
    out[29] = t80;
    const double t81 = x[0]*x[4]; /* gamma3*omega3 */
    const double t82 = JLT_FNMA(t36, t45, t81); /* gamma3*omega3 - e*1/R*omega_n*1/s */
    out[52] = t82;
    const double t83 = x[9]*x[0]; /* s*gamma3 */
    const double t84 = -t83; /* -s*gamma3 */
    out[102] = t84;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t1 = x[9]*x[9]; /* s*s */
    const double t2 = JLT_FMA(p[14], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t3 = p[13]*t1; /* 2*m*a3^2*s*s */
    const double t4 = t0*t3; /* gamma3*omega_tau*2*m*a3^2*s*s */
    const double t5 = t4/t2; /* gamma3*omega_tau*2*m*a3^2*s*s/D */
    const double t6 = t0 + t5; /* gamma3*omega_tau + gamma3*omega_tau*2*m*a3^2*s*s/D */
    out[0] = t6;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t1 = x[3]*t0; /* omega_n*b */
    const double t2 = p[15]*x[0]; /* m*g*a3*gamma3 */
    const double t3 = p[1]*x[9]; /* R*s */
    const double t4 = JLT_FMA(x[4], t3, t1); /* v_tau = omega3*R*s + omega_n*b */
    const double t5 = x[9]*p[14]; /* s*m*a3^2 */
    const double t6 = JLT_FMA(x[9], t5, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t7 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t8 = x[2]*t7; /* omega_tau*1/2*omega_tau */
    const double t9 = x[3]*p[17]; /* omega_n*1/2*I1 */
    const double t10 = JLT_FMA(x[3], t9, t2); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t11 = JLT_FMA(t6, t8, t10); /* D*omega_tau*1/2*omega_tau + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t12 = x[1]*x[1]; /* v_nu*v_nu */
    const double t13 = JLT_FMA(t4, t4, t12); /* v_tau*v_tau + v_nu*v_nu */
    const double t14 = JLT_FMA(p[16], t13, t11); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t11 */
    out[0] = t14;
    const double t15 = cos(x[5]); /* C = cos(chi) */
    const double t16 = sin(x[5]); /* S = sin(chi) */
    const double t17 = x[9]*p[18]; /* s*R*I1 */
    const double t18 = x[3]*t17; /* omega_n*s*R*I1 */
    out[1] = t18;
    const double t19 = x[1]*t15; /* v_nu*C */
    const double t20 = JLT_FMA(t4, t16, t19); /* v_tau*S + v_nu*C */
    out[2] = t20;
    const double t21 = x[1]*t16; /* v_nu*S */
    const double t22 = JLT_FNMA(t4, t15, t21); /* v_nu*S - v_tau*C */
    out[3] = t22;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = x[3]*t0; /* omega_n*b */
    const double t2 = p[1]*x[4]; /* R*omega3 */
    const double t3 = JLT_FMA(x[9], t2, t1); /* v_tau = s*R*omega3 + omega_n*b */
    const double t4 = p[19]*t3; /* m*R*v_tau */
    const double t5 = JLT_FMA(x[3], t4, p[15]); /* omega_n*m*R*v_tau + m*g*a3 */
    out[0] = t5;
    const double t6 = p[0]*x[1]; /* m*v_nu */
    out[1] = t6;
    const double t7 = x[9]*p[14]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = x[2]*t8; /* omega_tau*D */
    out[2] = t9;
    const double t10 = x[3]*p[4]; /* omega_n*I1 */
    const double t11 = t0*p[0]; /* b*m */
    const double t12 = JLT_FMA(t3, t11, t10); /* v_tau*b*m + omega_n*I1 */
    out[3] = t12;
    const double t13 = x[9]*t4; /* s*m*R*v_tau */
    out[4] = t13;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[22] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[32] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    const double t14 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t15 = t7*t14; /* s*m*a3^2*omega_tau*omega_tau */
    const double t16 = JLT_FMA(x[4], t4, t15); /* omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    out[9] = t16;
    const double t17 = x[9]*p[18]; /* s*R*I1 */
    out[13] = t17;
    const double t18 = x[3]*p[18]; /* omega_n*R*I1 */
    out[19] = t18;
    const double t19 = sin(x[5]); /* S = sin(chi) */
    out[31] = t19;
    const double t20 = p[1]*t19; /* R*S */
    const double t21 = x[3]*t20; /* omega_n*R*S */
    out[20] = t21;
    const double t22 = cos(x[5]); /* C = cos(chi) */
    out[21] = t22;
    const double t23 = t0*t19; /* b*S */
    out[23] = t23;
    const double t24 = x[9]*t20; /* s*R*S */
    out[24] = t24;
    const double t25 = x[1]*t19; /* v_nu*S */
    const double t26 = JLT_FMS(t3, t22, t25); /* v_tau*C - v_nu*S */
    out[25] = t26;
    const double t27 = t2*t19; /* R*omega3*S */
    out[29] = t27;
    const double t28 = p[1]*t22; /* R*C */
    const double t29 = x[3]*t28; /* omega_n*R*C */
    const double t30 = -t29; /* -omega_n*R*C */
    out[30] = t30;
    const double t31 = t0*t22; /* b*C */
    const double t32 = -t31; /* -b*C */
    out[33] = t32;
    const double t33 = x[9]*t28; /* s*R*C */
    const double t34 = -t33; /* -s*R*C */
    out[34] = t34;
    const double t35 = x[1]*t22; /* v_nu*C */
    const double t36 = JLT_FMA(t3, t19, t35); /* v_tau*S + v_nu*C */
    out[35] = t36;
    const double t37 = t2*t22; /* R*omega3*C */
    const double t38 = -t37; /* -R*omega3*C */
    out[39] = t38;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[9];
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
    double x9[JLT_JET_ORDER_MAX + 1];
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
    double u40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double u42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = x6[0] = x[6];
    coefficients[7] = x7[0] = x[7];
    coefficients[8] = x8[0] = x[8];
    coefficients[9] = x9[0] = x[9];
    coefficients[10] = 0;
    for (unsigned k = 0; k < order; k++) {
        t13[k] = -x3[k];
        t14[k] = jlt_jet_product(x9, x9, k);
        t15[k] = jlt_jet_product(x2, x0, k);
        t16[k] = jlt_jet_product(x3, t15, k);
        t17[k] = jlt_jet_product(x2, t14, k);
        t18[k] = p[7]*t15[k];
        t19[k] = jlt_jet_product(t17, t18, k);
        t20[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t21[k] = jlt_jet_product(x2, t20, k) + x1[k];
        t22[k] = jlt_jet_product(x3, x0, k);
        t23[k] = t19[k] - jlt_jet_product(x3, t22, k);
        t24[k] = t23[k] - p[8]*t14[k];
        t25[k] = p[7]*t14[k] + (k == 0 ? 1.0 : 0);
        t26[k] = jlt_jet_quotient(t24[k], t25, t26, k);
        t27[k] = x3[k]*p[6];
        t28[k] = jlt_jet_product(t21, t27, k);
        t29[k] = jlt_jet_quotient(t28[k], x9, t29, k);
        t30[k] = jlt_jet_product(x4, t15, k) - t29[k];
        t31[k] = jlt_jet_product(x9, t15, k);
        t32[k] = -t31[k];
        t33[k] = jlt_jet_product(x9, x4, k);
        t34[k] = t22[k] + t33[k];
        t35[k] = p[1]*t33[k];
        t36[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t37[k] = jlt_jet_product(x3, t36, k) + t35[k];
        t38[k] = jlt_jet_product(x3, t37, k);
        t39[k] = jlt_jet_product(x9, t37, k);
        t40[k] = jlt_jet_cosine(x5, t40, u40, k);
        t41[k] = jlt_jet_product(x9, x1, k);
        t42[k] = jlt_jet_sine(x5, t42, u42, k);
        t43[k] = jlt_jet_product(t40, t41, k);
        t44[k] = jlt_jet_product(t39, t42, k) + t43[k];
        t45[k] = jlt_jet_product(t41, t42, k);
        t46[k] = t45[k] - jlt_jet_product(t39, t40, k);
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t17[k]/(k + 1);
        next[1] = x1[k + 1] = t38[k]/(k + 1);
        next[2] = x2[k + 1] = t26[k]/(k + 1);
        next[3] = x3[k + 1] = t16[k]/(k + 1);
        next[4] = x4[k + 1] = t30[k]/(k + 1);
        next[5] = x5[k + 1] = t13[k]/(k + 1);
        next[6] = x6[k + 1] = t34[k]/(k + 1);
        next[7] = x7[k + 1] = t44[k]/(k + 1);
        next[8] = x8[k + 1] = t46[k]/(k + 1);
        next[9] = x9[k + 1] = t32[k]/(k + 1);
        next[10] = x9[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[9];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega3 = x[4];
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = (0.0);
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v_nu = x[1];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (-v_m*v_I3*v_omega_n*v_b*v_V/(v_s*v_Theta))
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta));
    out[4] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[5] = (v_s)*((-v_omega_n/v_s));
    out[6] = (v_s)*((v_omega3)
        + (v_gamma3*v_omega_n/v_s));
    const double complex v_chi = x[5];
    const double complex v_C = ccos(v_chi);
    const double complex v_S = csin(v_chi);
    const double complex v_v_tau = (v_omega_n*v_b + v_R*v_omega3*v_s);
    out[7] = (v_s)*((v_v_nu*v_C)
        + (v_S*v_v_tau));
    out[8] = (v_s)*((v_v_nu*v_S)
        + (-v_C*v_v_tau));
    out[9] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    out[3] = x[3];
    out[4] = x[4];
    out[5] = x[5];
    out[6] = x[6];
    out[7] = x[7];
    out[8] = x[8];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[9] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[9]*x[9]; /* s*s */
    const double t3 = t1 + t2; /* -1 + gamma3*gamma3 + s*s */
    out[0] = t3;
}

static void root_relation_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = 2.0*x[0]; /* 2*gamma3 */
    out[0] = t0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    const double t1 = 2.0*x[9]; /* 2*s */
    out[9] = t1;
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
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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

const jlt_descriptor jlt_kernels_spherical_top_track_rod_in_regular = {
    .model = "spherical_top_track",
    .variant = "rod",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .scales = 1,
    .state_count = 10, .param_count = 6, .prepared_count = 20,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 10, { 3, 22, 10, 1, 0, 2, 7, 9 }, { 14, 49, 0, 4, 0, 2, 8, 7 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, b*omega_n*(1/R) + s*omega3, a part of d(omega_tau)/dtau, e = a3*gamma3 + R, V = omega_tau*e + v_nu, d(omega3)/dtau, d(spin)/dtau, R*(b*omega_n*(1/R) + s*omega3)*S + v_nu*C, v_nu*S - R*(b*omega_n*(1/R) + s*omega3)*C" },
    .jacobian = { jacobian, 100, { 9, 47, 14, 1, 0, 2, 10, 13 }, { 27, 138, 0, 14, 0, 2, 11, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, d(d(v_nu)/dtau)/d(omega_n), v_tau = omega_n*b + omega3*s*R, omega3*s*R + v_tau, a part of d(d(omega_tau)/dtau)/d(s), e = a3*gamma3 + R, s*omega_tau*(m*a3^2/I1)*s*omega_tau - omega_n*omega_n, V = omega_tau*e + v_nu, omega3 - (a3/R)*omega_n*1/s, d(d(omega3)/dtau)/d(omega_tau), d(d(x)/dtau)/d(chi), d(d(y)/dtau)/d(chi), d(d(x)/dtau)/d(s), d(d(y)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 110, { 11, 54, 17, 1, 0, 2, 10, 15 }, { 36, 177, 0, 18, 0, 2, 11, 11 },
        "divides by s: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, d(d(v_nu)/dtau)/d(omega_n), omega_n*b + omega3*s*R, s*omega_tau*(m*a3^2/I1)*s*omega_tau - omega_n*omega_n, a part of d(d(omega_tau)/dtau)/d(s), e = a3*gamma3 + R, v_nu*S - (omega_n*b + omega3*s*R)*C, d(d(y)/dtau)/d(s), V = omega_tau*e + v_nu, omega3 - (a3/R)*omega_n*1/s, d(spin)/dtau, (omega_n*b + omega3*s*R)*S + v_nu*C, d(d(x)/dtau)/d(s), d(omega_tau)/dtau, d(omega3)/dtau, d(d(omega3)/dtau)/d(omega_tau)" },
    .divergence = { divergence, 1, { 1, 4, 1, 1, 0, 0, 5, 4 }, { 2, 12, 0, 1, 0, 0, 8, 4 },
        "" },
    .integral_values = { integral_values, 4, { 0, 12, 9, 0, 0, 2, 5, 6 }, { 9, 30, 0, 0, 0, 2, 9, 6 },
        "digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = omega3*R*s + omega_n*b, E, v_x, v_y" },
    .integral_gradients = { integral_gradients, 40, { 4, 25, 8, 0, 0, 2, 5, 8 }, { 12, 51, 0, 0, 0, 2, 6, 7 },
        "digits are lost where terms nearly cancel in b = R*gamma3 + a3, v_tau = s*R*omega3 + omega_n*b, d(E)/d(gamma3), d(E)/d(omega_n), d(E)/d(s), d(v_x)/d(chi), d(v_y)/d(chi)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_track_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_track_rod_in_regular) },
#endif
};
