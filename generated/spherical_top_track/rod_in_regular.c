/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   22   10    1    0    2      7    9   (69)
 *  jacobian            10   49   14    1    0    2     12   15   (181)
 *  rhs_jacobian        12   52   18    1    0    2     11   24   (233)
 *  divergence          1    4    1    1    0    0      5    4   (15)
 *  integral_values     0   12    9    0    0    2      5    7   (41)
 *  integral_gradients  4   25    8    0    0    2      5    8   (65)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_track[];
extern const jlt_descriptor jlt_kernels_spherical_top_track_rod_in_regular;
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
    const double t0 = params[3]*params[3]; /* a3*a3 */
    const double t1 = params[0]*t0; /* m*a3*a3 */
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[3]*t3; /* a3*m*g */
    const double t5 = t4/params[4]; /* a3*m*g/I1 */
    const double t6 = 1.0/params[1]; /* 1/R */
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t0*t7; /* a3*a3*m*2 */
    const double t9 = t8/params[4]; /* a3*a3*m*2/I1 */
    const double t10 = params[2]*t7; /* g*m*2 */
    const double t11 = params[3]*t10; /* a3*g*m*2 */
    const double t12 = t11/params[4]; /* a3*g*m*2/I1 */
    const double t13 = params[3]/params[1]; /* a3/R */
    const double t14 = (-1.0)/params[1]; /* (-1)/R */
    const double t15 = params[0]/2.0; /* m/2 */
    const double t16 = params[4]/2.0; /* I1/2 */
    const double t17 = params[4]*params[1]; /* I1*R */
    const double t18 = params[0]*params[1]; /* m*R */
    out[6] = t2;
    out[7] = t5;
    out[8] = t6;
    out[9] = t9;
    out[10] = t12;
    out[11] = t13;
    out[12] = t14;
    out[13] = t8;
    out[14] = t1;
    out[15] = t4;
    out[16] = t15;
    out[17] = t16;
    out[18] = t17;
    out[19] = t18;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[9]*x[4]; /* s*omega3 */
    const double t5 = JLT_FMA(p[1], t4, t3); /* R*s*omega3 + omega_n*b */
    const double t6 = x[3]*t5; /* omega_n*(R*s*omega3 + omega_n*b) */
    const double t7 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t8 = p[6]*t7; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t9 = t1*t8; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t10 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t11 = JLT_FNMA(x[3], t10, t9); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - omega_n*omega_n*gamma3 */
    const double t12 = JLT_FNMA(t0, p[7], t11); /* t11 - s*s*m*g*a3/I1 */
    const double t13 = JLT_FMA(t0, p[6], 1.0); /* D scaled = s*s*m*a3^2/I1 + 1 */
    const double t14 = x[9]*t13; /* s*D scaled */
    const double t15 = 1.0/t14; /* 1/(s*D scaled) */
    const double t16 = x[9]*t12; /* s*(t11 - s*s*m*g*a3/I1) */
    const double t17 = t15*t16; /* 1/(s*D scaled)*s*(t11 - s*s*m*g*a3/I1) */
    const double t18 = x[3]*t7; /* omega_n*omega_tau*gamma3 */
    const double t19 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t20 = JLT_FMA(x[2], t19, x[1]); /* V = omega_tau*e + v_nu */
    const double t21 = x[3]*p[8]; /* omega_n*1/R */
    const double t22 = t13*t21; /* D scaled*omega_n*1/R */
    const double t23 = t20*t22; /* V*D scaled*omega_n*1/R */
    const double t24 = t15*t23; /* 1/(s*D scaled)*V*D scaled*omega_n*1/R */
    const double t25 = JLT_FMS(x[4], t7, t24); /* omega3*omega_tau*gamma3 - 1/(s*D scaled)*V*D scaled*omega_n*1/R */
    const double t26 = -x[3]; /* -omega_n */
    const double t27 = t4 + t10; /* s*omega3 + omega_n*gamma3 */
    const double t28 = cos(x[5]); /* C = cos(chi) */
    const double t29 = x[9]*t28; /* s*C */
    const double t30 = x[1]*t29; /* v_nu*s*C */
    const double t31 = sin(x[5]); /* S = sin(chi) */
    const double t32 = x[9]*t31; /* s*S */
    const double t33 = JLT_FMA(t5, t32, t30); /* (R*s*omega3 + omega_n*b)*s*S + v_nu*s*C */
    const double t34 = x[1]*t32; /* v_nu*s*S */
    const double t35 = JLT_FNMA(t5, t29, t34); /* v_nu*s*S - (R*s*omega3 + omega_n*b)*s*C */
    const double t36 = x[9]*t7; /* s*omega_tau*gamma3 */
    const double t37 = -t36; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t6;
    out[2] = t17;
    out[3] = t18;
    out[4] = t25;
    out[5] = t26;
    out[6] = t27;
    out[7] = t33;
    out[8] = t35;
    out[9] = t37;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[9]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*p[1]; /* omega_n*R */
    const double t4 = x[3]*t3; /* omega_n*omega_n*R */
    const double t5 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t6 = x[3]*t5; /* omega_n*b */
    const double t7 = x[9]*p[1]; /* s*R */
    const double t8 = x[4]*t7; /* omega3*s*R */
    const double t9 = JLT_FMA(2.0, t6, t8); /* 2*omega_n*b + omega3*s*R */
    const double t10 = x[3]*t7; /* omega_n*s*R */
    const double t11 = t3*x[4]; /* omega_n*R*omega3 */
    const double t12 = t0*p[6]; /* s*s*m*a3^2/I1 */
    const double t13 = t12 + 1.0; /* D scaled = s*s*m*a3^2/I1 + 1 */
    const double t14 = x[9]*t13; /* s*D scaled */
    const double t15 = 1.0/t14; /* 1/(s*D scaled) */
    const double t16 = x[9]*t15; /* s*1/(s*D scaled) */
    const double t17 = t12*t16; /* s*s*m*a3^2/I1*s*1/(s*D scaled) */
    const double t18 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t19 = t17*t18; /* s*s*m*a3^2/I1*s*1/(s*D scaled)*omega_tau*omega_tau */
    const double t20 = x[3]*t16; /* omega_n*s*1/(s*D scaled) */
    const double t21 = JLT_FNMA(x[3], t20, t19); /* s*s*m*a3^2/I1*s*1/(s*D scaled)*omega_tau*omega_tau - omega_n*omega_n*s*1/(s*D scaled) */
    const double t22 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t23 = p[9]*t22; /* 2*m*a3^2/I1*omega_tau*gamma3 */
    const double t24 = t16*t23; /* s*1/(s*D scaled)*2*m*a3^2/I1*omega_tau*gamma3 */
    const double t25 = t0*t24; /* s*s*s*1/(s*D scaled)*2*m*a3^2/I1*omega_tau*gamma3 */
    const double t26 = x[0]*t20; /* gamma3*omega_n*s*1/(s*D scaled) */
    const double t27 = (-2.0)*t26; /* (-2)*gamma3*omega_n*s*1/(s*D scaled) */
    const double t28 = x[2]*t24; /* omega_tau*s*1/(s*D scaled)*2*m*a3^2/I1*omega_tau*gamma3 */
    const double t29 = JLT_FNMA(t16, p[10], t28); /* omega_tau*s*1/(s*D scaled)*2*m*a3^2/I1*omega_tau*gamma3 - s*1/(s*D scaled)*2*m*g*a3/I1 */
    const double t30 = t20*p[9]; /* omega_n*s*1/(s*D scaled)*2*m*a3^2/I1 */
    const double t31 = JLT_FMA(t26, t30, t29); /* gamma3*omega_n*s*1/(s*D scaled)*omega_n*s*1/(s*D scaled)*2*m*a3^2/I1 + t29 */
    const double t32 = JLT_FNMA(t17, t29, t31); /* t31 - s*s*m*a3^2/I1*s*1/(s*D scaled)*t29 */
    const double t33 = x[9]*t32; /* s*(t31 - s*s*m*a3^2/I1*s*1/(s*D scaled)*t29) */
    const double t34 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t35 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t36 = t13*t15; /* D scaled*1/(s*D scaled) */
    const double t37 = x[3]*t36; /* omega_n*D scaled*1/(s*D scaled) */
    const double t38 = JLT_FNMA(p[11], t37, x[4]); /* omega3 - a3/R*omega_n*D scaled*1/(s*D scaled) */
    const double t39 = x[2]*t38; /* omega_tau*(omega3 - a3/R*omega_n*D scaled*1/(s*D scaled)) */
    const double t40 = t37*p[8]; /* omega_n*D scaled*1/(s*D scaled)*1/R */
    const double t41 = -t40; /* -omega_n*D scaled*1/(s*D scaled)*1/R */
    const double t42 = x[0]*x[4]; /* gamma3*omega3 */
    const double t43 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t44 = JLT_FNMA(t40, t43, t42); /* gamma3*omega3 - omega_n*D scaled*1/(s*D scaled)*1/R*e */
    const double t45 = JLT_FMA(x[2], t43, x[1]); /* V = omega_tau*e + v_nu */
    const double t46 = t36*t45; /* D scaled*1/(s*D scaled)*V */
    const double t47 = p[12]*t46; /* (-1/R)*D scaled*1/(s*D scaled)*V */
    const double t48 = t40*t46; /* omega_n*D scaled*1/(s*D scaled)*1/R*D scaled*1/(s*D scaled)*V */
    const double t49 = sin(x[5]); /* S = sin(chi) */
    const double t50 = t10*t49; /* omega_n*s*R*S */
    const double t51 = cos(x[5]); /* C = cos(chi) */
    const double t52 = x[9]*t51; /* s*C */
    const double t53 = x[9]*t49; /* s*S */
    const double t54 = t5*t53; /* b*s*S */
    const double t55 = t7*t53; /* s*R*s*S */
    const double t56 = x[1]*t53; /* v_nu*s*S */
    const double t57 = t6 + t8; /* v_tau = omega_n*b + omega3*s*R */
    const double t58 = JLT_FMS(t52, t57, t56); /* s*C*v_tau - v_nu*s*S */
    const double t59 = x[1]*t51; /* v_nu*C */
    const double t60 = t8 + t57; /* omega3*s*R + v_tau */
    const double t61 = JLT_FMA(t49, t60, t59); /* S*(omega3*s*R + v_tau) + v_nu*C */
    const double t62 = t10*t51; /* omega_n*s*R*C */
    const double t63 = -t62; /* -omega_n*s*R*C */
    const double t64 = t5*t52; /* b*s*C */
    const double t65 = -t64; /* -b*s*C */
    const double t66 = t7*t52; /* s*R*s*C */
    const double t67 = -t66; /* -s*R*s*C */
    const double t68 = x[1]*t52; /* v_nu*s*C */
    const double t69 = JLT_FMA(t53, t57, t68); /* s*S*v_tau + v_nu*s*C */
    const double t70 = x[1]*t49; /* v_nu*S */
    const double t71 = JLT_FNMA(t51, t60, t70); /* v_nu*S - C*(omega3*s*R + v_tau) */
    const double t72 = -t1; /* -s*omega_tau */
    const double t73 = x[9]*x[0]; /* s*gamma3 */
    const double t74 = -t73; /* -s*gamma3 */
    const double t75 = -t22; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t2;
    out[10] = t4;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t9;
    out[14] = t10;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t11;
    out[20] = t21;
    out[21] = 0.0;
    out[22] = t25;
    out[23] = t27;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t33;
    out[30] = t34;
    out[31] = 0.0;
    out[32] = t35;
    out[33] = t22;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = 0.0;
    out[40] = t39;
    out[41] = t41;
    out[42] = t44;
    out[43] = t47;
    out[44] = t22;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t48;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = (-1.0);
    out[54] = 0.0;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = 0.0;
    out[60] = x[3];
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = x[0];
    out[64] = x[9];
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[68] = 0.0;
    out[69] = x[4];
    out[70] = t50;
    out[71] = t52;
    out[72] = 0.0;
    out[73] = t54;
    out[74] = t55;
    out[75] = t58;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = t61;
    out[80] = t63;
    out[81] = t53;
    out[82] = 0.0;
    out[83] = t65;
    out[84] = t67;
    out[85] = t69;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t71;
    out[90] = t72;
    out[91] = 0.0;
    out[92] = t74;
    out[93] = 0.0;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t75;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = t2*t3; /* b*omega_n*omega_n */
    const double t5 = x[9]*p[1]; /* s*R */
    const double t6 = x[3]*t5; /* omega_n*s*R */
    const double t7 = JLT_FMA(x[4], t6, t4); /* omega3*omega_n*s*R + b*omega_n*omega_n */
    const double t8 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t9 = JLT_FMS(t1, t8, t3); /* omega_tau*s*s*omega_tau*m*a3^2/I1 - omega_n*omega_n */
    const double t10 = JLT_FMA(t0, p[6], 1.0); /* D scaled = s*s*m*a3^2/I1 + 1 */
    const double t11 = x[9]*t10; /* s*D scaled */
    const double t12 = 1.0/t11; /* 1/(s*D scaled) */
    const double t13 = x[9]*t12; /* s*1/(s*D scaled) */
    const double t14 = t9*t13; /* (omega_tau*s*s*omega_tau*m*a3^2/I1 - omega_n*omega_n)*s*1/(s*D scaled) */
    const double t15 = x[0]*t14; /* gamma3*t14 */
    const double t16 = t0*p[7]; /* s*s*m*g*a3/I1 */
    const double t17 = JLT_FNMA(t13, t16, t15); /* gamma3*t14 - s*1/(s*D scaled)*s*s*m*g*a3/I1 */
    const double t18 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t19 = x[3]*t18; /* omega_n*omega_tau*gamma3 */
    const double t20 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t21 = JLT_FMA(x[2], t20, x[1]); /* V = omega_tau*e + v_nu */
    const double t22 = t10*t12; /* D scaled*1/(s*D scaled) */
    const double t23 = p[8]*t22; /* 1/R*D scaled*1/(s*D scaled) */
    const double t24 = x[3]*t23; /* omega_n*1/R*D scaled*1/(s*D scaled) */
    const double t25 = t21*t24; /* V*omega_n*1/R*D scaled*1/(s*D scaled) */
    const double t26 = JLT_FMS(x[4], t18, t25); /* omega3*omega_tau*gamma3 - V*omega_n*1/R*D scaled*1/(s*D scaled) */
    const double t27 = -x[3]; /* -omega_n */
    const double t28 = x[0]*x[3]; /* gamma3*omega_n */
    const double t29 = JLT_FMA(x[9], x[4], t28); /* s*omega3 + gamma3*omega_n */
    const double t30 = cos(x[5]); /* C = cos(chi) */
    const double t31 = x[1]*t30; /* v_nu*C */
    const double t32 = sin(x[5]); /* S = sin(chi) */
    const double t33 = t2*x[3]; /* b*omega_n */
    const double t34 = x[4]*t5; /* omega3*s*R */
    const double t35 = t33 + t34; /* v_tau = b*omega_n + omega3*s*R */
    const double t36 = JLT_FMA(t32, t35, t31); /* S*v_tau + v_nu*C */
    const double t37 = x[9]*t36; /* s*(S*v_tau + v_nu*C) */
    const double t38 = x[1]*t32; /* v_nu*S */
    const double t39 = JLT_FNMA(t30, t35, t38); /* v_nu*S - C*v_tau */
    const double t40 = x[9]*t39; /* s*(v_nu*S - C*v_tau) */
    const double t41 = x[9]*t18; /* s*omega_tau*gamma3 */
    const double t42 = -t41; /* -s*omega_tau*gamma3 */
    const double t43 = x[2]*x[9]; /* omega_tau*s */
    const double t44 = 2.0*t43; /* 2*omega_tau*s */
    const double t45 = p[1]*t3; /* R*omega_n*omega_n */
    const double t46 = JLT_FMA(t33, 2.0, t34); /* b*omega_n*2 + omega3*s*R */
    const double t47 = p[1]*x[3]; /* R*omega_n */
    const double t48 = x[4]*t47; /* omega3*R*omega_n */
    const double t49 = x[9]*t13; /* s*s*1/(s*D scaled) */
    const double t50 = p[9]*t49; /* 2*m*a3^2/I1*s*s*1/(s*D scaled) */
    const double t51 = t41*t50; /* s*omega_tau*gamma3*2*m*a3^2/I1*s*s*1/(s*D scaled) */
    const double t52 = t28*(-2.0); /* gamma3*omega_n*(-2) */
    const double t53 = t13*t52; /* s*1/(s*D scaled)*gamma3*omega_n*(-2) */
    const double t54 = JLT_FMS(x[2], t18, t17); /* omega_tau*omega_tau*gamma3 - (gamma3*t14 - s*1/(s*D scaled)*s*s*m*g*a3/I1) */
    const double t55 = t50*t54; /* 2*m*a3^2/I1*s*s*1/(s*D scaled)*t54 */
    const double t56 = JLT_FNMA(t49, p[10], t55); /* 2*m*a3^2/I1*s*s*1/(s*D scaled)*t54 - s*s*1/(s*D scaled)*2*m*g*a3/I1 */
    const double t57 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t58 = t57*p[11]; /* omega_tau*omega_n*a3/R */
    const double t59 = t22*t58; /* D scaled*1/(s*D scaled)*omega_tau*omega_n*a3/R */
    const double t60 = JLT_FMS(x[2], x[4], t59); /* omega_tau*omega3 - D scaled*1/(s*D scaled)*omega_tau*omega_n*a3/R */
    const double t61 = -t24; /* -omega_n*1/R*D scaled*1/(s*D scaled) */
    const double t62 = x[0]*x[4]; /* gamma3*omega3 */
    const double t63 = JLT_FNMA(t20, t24, t62); /* gamma3*omega3 - e*omega_n*1/R*D scaled*1/(s*D scaled) */
    const double t64 = t21*t23; /* V*1/R*D scaled*1/(s*D scaled) */
    const double t65 = -t64; /* -V*1/R*D scaled*1/(s*D scaled) */
    const double t66 = t22*t25; /* D scaled*1/(s*D scaled)*V*omega_n*1/R*D scaled*1/(s*D scaled) */
    const double t67 = t6*t32; /* omega_n*s*R*S */
    const double t68 = x[9]*t30; /* s*C */
    const double t69 = x[9]*t32; /* s*S */
    const double t70 = t2*t69; /* b*s*S */
    const double t71 = t5*t69; /* s*R*s*S */
    const double t72 = -t40; /* -s*(v_nu*S - C*v_tau) */
    const double t73 = JLT_FMA(t32, t34, t36); /* S*omega3*s*R + S*v_tau + v_nu*C */
    const double t74 = t6*t30; /* omega_n*s*R*C */
    const double t75 = -t74; /* -omega_n*s*R*C */
    const double t76 = t2*t68; /* b*s*C */
    const double t77 = -t76; /* -b*s*C */
    const double t78 = t5*t68; /* s*R*s*C */
    const double t79 = -t78; /* -s*R*s*C */
    const double t80 = JLT_FNMA(t30, t34, t39); /* v_nu*S - C*v_tau - C*omega3*s*R */
    const double t81 = -t43; /* -omega_tau*s */
    const double t82 = x[9]*x[0]; /* s*gamma3 */
    const double t83 = -t82; /* -s*gamma3 */
    const double t84 = -t18; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t7;
    out[2] = t17;
    out[3] = t19;
    out[4] = t26;
    out[5] = t27;
    out[6] = t29;
    out[7] = t37;
    out[8] = t40;
    out[9] = t42;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t44;
    out[20] = t45;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = t46;
    out[24] = t6;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t48;
    out[30] = t14;
    out[31] = 0.0;
    out[32] = t51;
    out[33] = t53;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t56;
    out[40] = t57;
    out[41] = 0.0;
    out[42] = t28;
    out[43] = t18;
    out[44] = 0.0;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = 0.0;
    out[50] = t60;
    out[51] = t61;
    out[52] = t63;
    out[53] = t65;
    out[54] = t18;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = t66;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = (-1.0);
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = 0.0;
    out[67] = 0.0;
    out[68] = 0.0;
    out[69] = 0.0;
    out[70] = x[3];
    out[71] = 0.0;
    out[72] = 0.0;
    out[73] = x[0];
    out[74] = x[9];
    out[75] = 0.0;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = x[4];
    out[80] = t67;
    out[81] = t68;
    out[82] = 0.0;
    out[83] = t70;
    out[84] = t71;
    out[85] = t72;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t73;
    out[90] = t75;
    out[91] = t69;
    out[92] = 0.0;
    out[93] = t77;
    out[94] = t79;
    out[95] = t37;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t80;
    out[100] = t81;
    out[101] = 0.0;
    out[102] = t83;
    out[103] = 0.0;
    out[104] = 0.0;
    out[105] = 0.0;
    out[106] = 0.0;
    out[107] = 0.0;
    out[108] = 0.0;
    out[109] = t84;
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
    const double t0 = p[15]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = p[1]*x[9]; /* R*s */
    const double t5 = JLT_FMA(x[4], t4, t3); /* v_tau = omega3*R*s + omega_n*b */
    const double t6 = JLT_FMA(t5, t5, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t7 = x[9]*p[14]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t10 = x[2]*t9; /* omega_tau*1/2*omega_tau */
    const double t11 = x[3]*p[17]; /* omega_n*1/2*I1 */
    const double t12 = JLT_FMA(x[3], t11, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t8, t10, t12); /* D*omega_tau*1/2*omega_tau + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(p[16], t6, t13); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t13 */
    const double t15 = x[9]*p[18]; /* s*R*I1 */
    const double t16 = x[3]*t15; /* omega_n*s*R*I1 */
    const double t17 = cos(x[5]); /* C = cos(chi) */
    const double t18 = x[1]*t17; /* v_nu*C */
    const double t19 = sin(x[5]); /* S = sin(chi) */
    const double t20 = JLT_FMA(t5, t19, t18); /* v_tau*S + v_nu*C */
    const double t21 = x[1]*t19; /* v_nu*S */
    const double t22 = JLT_FNMA(t5, t17, t21); /* v_nu*S - v_tau*C */
    out[0] = t14;
    out[1] = t16;
    out[2] = t20;
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
    const double t6 = p[0]*x[1]; /* m*v_nu */
    const double t7 = x[9]*p[14]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = x[2]*t8; /* omega_tau*D */
    const double t10 = x[3]*p[4]; /* omega_n*I1 */
    const double t11 = t0*p[0]; /* b*m */
    const double t12 = JLT_FMA(t3, t11, t10); /* v_tau*b*m + omega_n*I1 */
    const double t13 = x[9]*t4; /* s*m*R*v_tau */
    const double t14 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t15 = t7*t14; /* s*m*a3^2*omega_tau*omega_tau */
    const double t16 = JLT_FMA(x[4], t4, t15); /* omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    const double t17 = x[9]*p[18]; /* s*R*I1 */
    const double t18 = x[3]*p[18]; /* omega_n*R*I1 */
    const double t19 = sin(x[5]); /* S = sin(chi) */
    const double t20 = p[1]*t19; /* R*S */
    const double t21 = x[3]*t20; /* omega_n*R*S */
    const double t22 = cos(x[5]); /* C = cos(chi) */
    const double t23 = t0*t19; /* b*S */
    const double t24 = x[9]*t20; /* s*R*S */
    const double t25 = x[1]*t19; /* v_nu*S */
    const double t26 = JLT_FMS(t3, t22, t25); /* v_tau*C - v_nu*S */
    const double t27 = t2*t19; /* R*omega3*S */
    const double t28 = p[1]*t22; /* R*C */
    const double t29 = x[3]*t28; /* omega_n*R*C */
    const double t30 = -t29; /* -omega_n*R*C */
    const double t31 = t0*t22; /* b*C */
    const double t32 = -t31; /* -b*C */
    const double t33 = x[9]*t28; /* s*R*C */
    const double t34 = -t33; /* -s*R*C */
    const double t35 = x[1]*t22; /* v_nu*C */
    const double t36 = JLT_FMA(t3, t19, t35); /* v_tau*S + v_nu*C */
    const double t37 = t2*t22; /* R*omega3*C */
    const double t38 = -t37; /* -R*omega3*C */
    out[0] = t5;
    out[1] = t6;
    out[2] = t9;
    out[3] = t12;
    out[4] = t13;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t16;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t17;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t18;
    out[20] = t21;
    out[21] = t22;
    out[22] = 0.0;
    out[23] = t23;
    out[24] = t24;
    out[25] = t26;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t27;
    out[30] = t30;
    out[31] = t19;
    out[32] = 0.0;
    out[33] = t32;
    out[34] = t34;
    out[35] = t36;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
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
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
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
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double u41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double u43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
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
    coefficients[9] = x9[0] = x[9];
    coefficients[10] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x9, x9, k);
        t3[k] = jlt_jet_product(x2, t2, k);
        t8[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t9[k] = jlt_jet_product(x3, t8, k);
        t11[k] = jlt_jet_product(x9, x4, k);
        t12[k] = p[1]*t11[k] + t9[k];
        t13[k] = jlt_jet_product(x3, t12, k);
        t15[k] = jlt_jet_product(x2, x0, k);
        t16[k] = p[6]*t15[k];
        t17[k] = jlt_jet_product(t3, t16, k);
        t18[k] = jlt_jet_product(x3, x0, k);
        t20[k] = t17[k] - jlt_jet_product(x3, t18, k);
        t21[k] = t20[k] - t2[k]*p[7];
        t23[k] = t2[k]*p[6] + (k == 0 ? 1.0 : 0);
        t24[k] = jlt_jet_product(x9, t23, k);
        t25[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t24, t25, k);
        t26[k] = jlt_jet_product(x9, t21, k);
        t27[k] = jlt_jet_product(t25, t26, k);
        t28[k] = jlt_jet_product(x3, t15, k);
        t31[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t32[k] = jlt_jet_product(x2, t31, k) + x1[k];
        t33[k] = x3[k]*p[8];
        t34[k] = jlt_jet_product(t23, t33, k);
        t35[k] = jlt_jet_product(t32, t34, k);
        t36[k] = jlt_jet_product(t25, t35, k);
        t37[k] = jlt_jet_product(x4, t15, k) - t36[k];
        t38[k] = -x3[k];
        t39[k] = t11[k] + t18[k];
        t41[k] = jlt_jet_cosine(x5, t41, u41, k);
        t42[k] = jlt_jet_product(x1, t41, k);
        t43[k] = jlt_jet_sine(x5, t43, u43, k);
        t44[k] = jlt_jet_product(t12, t43, k) + t42[k];
        t45[k] = jlt_jet_product(x9, t44, k);
        t46[k] = jlt_jet_product(x1, t43, k);
        t47[k] = t46[k] - jlt_jet_product(t12, t41, k);
        t48[k] = jlt_jet_product(x9, t47, k);
        t49[k] = jlt_jet_product(x9, t15, k);
        t50[k] = -t49[k];
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t13[k]/(k + 1);
        next[2] = x2[k + 1] = t27[k]/(k + 1);
        next[3] = x3[k + 1] = t28[k]/(k + 1);
        next[4] = x4[k + 1] = t37[k]/(k + 1);
        next[5] = x5[k + 1] = t38[k]/(k + 1);
        next[6] = x6[k + 1] = t39[k]/(k + 1);
        next[7] = x7[k + 1] = t45[k]/(k + 1);
        next[8] = x8[k + 1] = t48[k]/(k + 1);
        next[9] = x9[k + 1] = t50[k]/(k + 1);
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
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
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
    .sha256 = "c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_track,
    .state_count = 10, .param_count = 6, .block_count = 20,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 10, { 3, 22, 10, 1, 0, 2, 7, 9 }, { 14, 49, 0, 4, 0, 2, 8, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .jacobian = { jacobian, 100, { 10, 49, 14, 1, 0, 2, 12, 15 }, { 27, 138, 0, 14, 0, 2, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 110, { 12, 52, 18, 1, 0, 2, 11, 24 }, { 36, 177, 0, 18, 0, 2, 11, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .divergence = { divergence, 1, { 1, 4, 1, 1, 0, 0, 5, 4 }, { 2, 12, 0, 1, 0, 0, 8, 4 },
        "" },
    .integral_values = { integral_values, 4, { 0, 12, 9, 0, 0, 2, 5, 7 }, { 9, 30, 0, 0, 0, 2, 9, 6 },
        "" },
    .integral_gradients = { integral_gradients, 40, { 4, 25, 8, 0, 0, 2, 5, 8 }, { 12, 51, 0, 0, 0, 2, 6, 7 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_track_rod_in_regular_baseline,
        &jlt_batch_spherical_top_track_rod_in_regular_avx2,
        &jlt_batch_spherical_top_track_rod_in_regular_avx512,
    },
};
