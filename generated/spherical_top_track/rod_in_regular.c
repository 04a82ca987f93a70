/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    rod: I3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23   10    1    0    2      7   10   (69)
 *  jacobian            9   52   15    1    0    2      9   16   (181)
 *  rhs_jacobian        11   59   18    1    0    2      9   26   (233)
 *  divergence          0    4    2    1    0    0      5    3   (15)
 *  integral_values     0   12    9    0    0    2      5    7   (41)
 *  integral_gradients  4   25    8    0    0    2      5    9   (65)
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
    const double t0 = 1.0/params[1]; /* 1/R */
    const double t1 = params[3]*params[3]; /* a3*a3 */
    const double t2 = params[0]*t1; /* m*a3*a3 */
    const double t3 = t2/params[4]; /* m*a3*a3/I1 */
    const double t4 = params[0]*params[2]; /* m*g */
    const double t5 = params[3]*t4; /* a3*m*g */
    const double t6 = t5/params[4]; /* a3*m*g/I1 */
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t1*t7; /* a3*a3*m*2 */
    const double t9 = params[4]*(-2.0); /* I1*(-2) */
    const double t10 = params[0]*params[3]; /* m*a3 */
    const double t11 = params[2]*2.0; /* g*2 */
    const double t12 = params[3]*2.0; /* a3*2 */
    const double t13 = params[4]*t12; /* I1*a3*2 */
    const double t14 = params[3]/params[1]; /* a3/R */
    const double t15 = (-1.0)/params[1]; /* (-1)/R */
    const double t16 = params[2]*t7; /* g*m*2 */
    const double t17 = params[3]*t16; /* a3*g*m*2 */
    const double t18 = params[4]*2.0; /* I1*2 */
    const double t19 = params[0]/2.0; /* m/2 */
    const double t20 = params[4]/2.0; /* I1/2 */
    const double t21 = params[1]*params[4]; /* R*I1 */
    const double t22 = params[1]*params[0]; /* R*m */
    const double t23 = -params[4]; /* -I1 */
    out[6] = t0;
    out[7] = t3;
    out[8] = t6;
    out[9] = t2;
    out[10] = t8;
    out[11] = t9;
    out[12] = t10;
    out[13] = t11;
    out[14] = t12;
    out[15] = t13;
    out[16] = t14;
    out[17] = t15;
    out[18] = t5;
    out[19] = t17;
    out[20] = t18;
    out[21] = t19;
    out[22] = t20;
    out[23] = t21;
    out[24] = t22;
    out[25] = t23;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[9]*x[4]; /* s*omega3 */
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = x[3]*p[6]; /* omega_n*1/R */
    const double t5 = JLT_FMA(t3, t4, t2); /* b*omega_n*1/R + s*omega3 */
    const double t6 = p[1]*t5; /* R*(b*omega_n*1/R + s*omega3) */
    const double t7 = x[3]*t6; /* omega_n*R*(b*omega_n*1/R + s*omega3) */
    const double t8 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t9 = p[7]*t8; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t10 = t1*t9; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t11 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t12 = JLT_FNMA(x[3], t11, t10); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - omega_n*omega_n*gamma3 */
    const double t13 = JLT_FNMA(t0, p[8], t12); /* t12 - s*s*m*g*a3/I1 */
    const double t14 = JLT_FMA(t0, p[9], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t15 = x[9]*t14; /* s*D */
    const double t16 = 1.0/t15; /* 1/(s*D) */
    const double t17 = x[9]*p[4]; /* s*I1 */
    const double t18 = t13*t17; /* (t12 - s*s*m*g*a3/I1)*s*I1 */
    const double t19 = t16*t18; /* 1/(s*D)*(t12 - s*s*m*g*a3/I1)*s*I1 */
    const double t20 = x[3]*t8; /* omega_n*omega_tau*gamma3 */
    const double t21 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t22 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t23 = t4*t14; /* omega_n*1/R*D */
    const double t24 = t22*t23; /* V*omega_n*1/R*D */
    const double t25 = t16*t24; /* 1/(s*D)*V*omega_n*1/R*D */
    const double t26 = JLT_FMS(x[4], t8, t25); /* omega3*omega_tau*gamma3 - 1/(s*D)*V*omega_n*1/R*D */
    const double t27 = -x[3]; /* -omega_n */
    const double t28 = t2 + t11; /* s*omega3 + omega_n*gamma3 */
    const double t29 = cos(x[5]); /* C = cos(chi) */
    const double t30 = x[9]*x[1]; /* s*v_nu */
    const double t31 = t29*t30; /* C*s*v_nu */
    const double t32 = sin(x[5]); /* S = sin(chi) */
    const double t33 = x[9]*t6; /* s*R*(b*omega_n*1/R + s*omega3) */
    const double t34 = JLT_FMA(t32, t33, t31); /* S*s*R*(b*omega_n*1/R + s*omega3) + C*s*v_nu */
    const double t35 = t30*t32; /* s*v_nu*S */
    const double t36 = JLT_FNMA(t29, t33, t35); /* s*v_nu*S - C*s*R*(b*omega_n*1/R + s*omega3) */
    const double t37 = x[9]*t8; /* s*omega_tau*gamma3 */
    const double t38 = -t37; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t7;
    out[2] = t19;
    out[3] = t20;
    out[4] = t26;
    out[5] = t27;
    out[6] = t28;
    out[7] = t34;
    out[8] = t36;
    out[9] = t38;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[9]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t6 = x[3]*t5; /* omega_n*b */
    const double t7 = x[9]*p[1]; /* s*R */
    const double t8 = x[4]*t7; /* omega3*s*R */
    const double t9 = JLT_FMA(2.0, t6, t8); /* 2*omega_n*b + omega3*s*R */
    const double t10 = x[3]*t7; /* omega_n*s*R */
    const double t11 = p[1]*x[3]; /* R*omega_n */
    const double t12 = x[4]*t11; /* omega3*R*omega_n */
    const double t13 = JLT_FMA(t0, p[9], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = x[9]*t13; /* s*D */
    const double t15 = 1.0/t14; /* 1/(s*D) */
    const double t16 = x[9]*t15; /* s*1/(s*D) */
    const double t17 = x[9]*t16; /* s*s*1/(s*D) */
    const double t18 = x[2]*p[9]; /* omega_tau*m*a3^2 */
    const double t19 = t1*t18; /* s*omega_tau*omega_tau*m*a3^2 */
    const double t20 = t17*t19; /* s*s*1/(s*D)*s*omega_tau*omega_tau*m*a3^2 */
    const double t21 = t3*p[4]; /* omega_n*omega_n*I1 */
    const double t22 = JLT_FNMA(t16, t21, t20); /* s*s*1/(s*D)*s*omega_tau*omega_tau*m*a3^2 - s*1/(s*D)*omega_n*omega_n*I1 */
    const double t23 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t24 = x[9]*t17; /* s*s*s*1/(s*D) */
    const double t25 = p[10]*t23; /* 2*m*a3^2*omega_tau*gamma3 */
    const double t26 = t24*t25; /* s*s*s*1/(s*D)*2*m*a3^2*omega_tau*gamma3 */
    const double t27 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t28 = t16*t27; /* s*1/(s*D)*omega_n*gamma3 */
    const double t29 = p[11]*t28; /* (-2*I1)*s*1/(s*D)*omega_n*gamma3 */
    const double t30 = x[2]*p[14]; /* omega_tau*2*a3 */
    const double t31 = JLT_FNMA(t23, t30, p[13]); /* 2*g - omega_tau*gamma3*omega_tau*2*a3 */
    const double t32 = p[9]*t31; /* m*a3^2*(2*g - omega_tau*gamma3*omega_tau*2*a3) */
    const double t33 = x[3]*p[15]; /* omega_n*2*a3*I1 */
    const double t34 = JLT_FMS(t28, t33, t31); /* s*1/(s*D)*omega_n*gamma3*omega_n*2*a3*I1 - (2*g - omega_tau*gamma3*omega_tau*2*a3) */
    const double t35 = JLT_FMA(t24, t32, t34); /* s*s*s*1/(s*D)*m*a3^2*(2*g - omega_tau*gamma3*omega_tau*2*a3) + t34 */
    const double t36 = t17*p[12]; /* s*s*1/(s*D)*m*a3 */
    const double t37 = t35*t36; /* t35*s*s*1/(s*D)*m*a3 */
    const double t38 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t39 = t13*t15; /* D*1/(s*D) */
    const double t40 = x[3]*t39; /* omega_n*D*1/(s*D) */
    const double t41 = JLT_FNMA(p[16], t40, x[4]); /* omega3 - a3/R*omega_n*D*1/(s*D) */
    const double t42 = x[2]*t41; /* omega_tau*(omega3 - a3/R*omega_n*D*1/(s*D)) */
    const double t43 = t40*p[6]; /* omega_n*D*1/(s*D)*1/R */
    const double t44 = -t43; /* -omega_n*D*1/(s*D)*1/R */
    const double t45 = x[0]*x[4]; /* gamma3*omega3 */
    const double t46 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t47 = JLT_FNMA(t43, t46, t45); /* gamma3*omega3 - omega_n*D*1/(s*D)*1/R*e */
    const double t48 = JLT_FMA(x[2], t46, x[1]); /* V = omega_tau*e + v_nu */
    const double t49 = t39*t48; /* D*1/(s*D)*V */
    const double t50 = p[17]*t49; /* (-1/R)*D*1/(s*D)*V */
    const double t51 = t43*t49; /* omega_n*D*1/(s*D)*1/R*D*1/(s*D)*V */
    const double t52 = sin(x[5]); /* S = sin(chi) */
    const double t53 = t10*t52; /* omega_n*s*R*S */
    const double t54 = cos(x[5]); /* C = cos(chi) */
    const double t55 = x[9]*t54; /* s*C */
    const double t56 = x[9]*t52; /* s*S */
    const double t57 = t5*t56; /* b*s*S */
    const double t58 = t7*t56; /* s*R*s*S */
    const double t59 = x[1]*t56; /* v_nu*s*S */
    const double t60 = t6 + t8; /* v_tau = omega_n*b + omega3*s*R */
    const double t61 = JLT_FMS(t55, t60, t59); /* s*C*v_tau - v_nu*s*S */
    const double t62 = x[1]*t54; /* v_nu*C */
    const double t63 = t8 + t60; /* omega3*s*R + v_tau */
    const double t64 = JLT_FMA(t52, t63, t62); /* S*(omega3*s*R + v_tau) + v_nu*C */
    const double t65 = t10*t54; /* omega_n*s*R*C */
    const double t66 = -t65; /* -omega_n*s*R*C */
    const double t67 = t5*t55; /* b*s*C */
    const double t68 = -t67; /* -b*s*C */
    const double t69 = t7*t55; /* s*R*s*C */
    const double t70 = -t69; /* -s*R*s*C */
    const double t71 = x[1]*t55; /* v_nu*s*C */
    const double t72 = JLT_FMA(t56, t60, t71); /* s*S*v_tau + v_nu*s*C */
    const double t73 = x[1]*t52; /* v_nu*S */
    const double t74 = JLT_FNMA(t54, t63, t73); /* v_nu*S - C*(omega3*s*R + v_tau) */
    const double t75 = -t1; /* -s*omega_tau */
    const double t76 = x[9]*x[0]; /* s*gamma3 */
    const double t77 = -t76; /* -s*gamma3 */
    const double t78 = -t23; /* -omega_tau*gamma3 */
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
    out[19] = t12;
    out[20] = t22;
    out[21] = 0.0;
    out[22] = t26;
    out[23] = t29;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t37;
    out[30] = t38;
    out[31] = 0.0;
    out[32] = t27;
    out[33] = t23;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = 0.0;
    out[40] = t42;
    out[41] = t44;
    out[42] = t47;
    out[43] = t50;
    out[44] = t23;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t51;
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
    out[70] = t53;
    out[71] = t55;
    out[72] = 0.0;
    out[73] = t57;
    out[74] = t58;
    out[75] = t61;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = t64;
    out[80] = t66;
    out[81] = t56;
    out[82] = 0.0;
    out[83] = t68;
    out[84] = t70;
    out[85] = t72;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t74;
    out[90] = t75;
    out[91] = 0.0;
    out[92] = t77;
    out[93] = 0.0;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t78;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[2]; /* s*omega_tau */
    const double t1 = x[9]*t0; /* s*s*omega_tau */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[9]*p[1]; /* s*R */
    const double t5 = x[4]*t4; /* omega3*s*R */
    const double t6 = t3 + t5; /* omega_n*b + omega3*s*R */
    const double t7 = x[3]*t6; /* omega_n*(omega_n*b + omega3*s*R) */
    const double t8 = x[9]*x[9]; /* s*s */
    const double t9 = JLT_FMA(p[9], t8, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t10 = x[9]*t9; /* s*D */
    const double t11 = 1.0/t10; /* 1/(s*D) */
    const double t12 = x[9]*t11; /* s*1/(s*D) */
    const double t13 = x[0]*t12; /* gamma3*s*1/(s*D) */
    const double t14 = t0*p[7]; /* s*omega_tau*m*a3^2/I1 */
    const double t15 = x[3]*x[3]; /* omega_n*omega_n */
    const double t16 = JLT_FMS(t0, t14, t15); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n */
    const double t17 = p[4]*t16; /* I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t18 = t13*t17; /* gamma3*s*1/(s*D)*I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t19 = x[9]*t12; /* s*s*1/(s*D) */
    const double t20 = x[9]*t19; /* s*s*s*1/(s*D) */
    const double t21 = JLT_FNMA(p[18], t20, t18); /* t18 - m*g*a3*s*s*s*1/(s*D) */
    const double t22 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t23 = x[3]*t22; /* omega_n*omega_tau*gamma3 */
    const double t24 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t25 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t26 = t9*t11; /* D*1/(s*D) */
    const double t27 = x[3]*t26; /* omega_n*D*1/(s*D) */
    const double t28 = p[6]*t27; /* 1/R*omega_n*D*1/(s*D) */
    const double t29 = t25*t28; /* V*1/R*omega_n*D*1/(s*D) */
    const double t30 = JLT_FMS(x[4], t22, t29); /* omega3*omega_tau*gamma3 - V*1/R*omega_n*D*1/(s*D) */
    const double t31 = -x[3]; /* -omega_n */
    const double t32 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t33 = JLT_FMA(x[9], x[4], t32); /* s*omega3 + omega_n*gamma3 */
    const double t34 = cos(x[5]); /* C = cos(chi) */
    const double t35 = x[1]*t34; /* v_nu*C */
    const double t36 = sin(x[5]); /* S = sin(chi) */
    const double t37 = JLT_FMA(t6, t36, t35); /* (omega_n*b + omega3*s*R)*S + v_nu*C */
    const double t38 = x[9]*t37; /* s*((omega_n*b + omega3*s*R)*S + v_nu*C) */
    const double t39 = x[1]*t36; /* v_nu*S */
    const double t40 = JLT_FNMA(t6, t34, t39); /* v_nu*S - (omega_n*b + omega3*s*R)*C */
    const double t41 = x[9]*t40; /* s*(v_nu*S - (omega_n*b + omega3*s*R)*C) */
    const double t42 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t43 = -t42; /* -s*omega_tau*gamma3 */
    const double t44 = t0*2.0; /* s*omega_tau*2 */
    const double t45 = p[1]*t15; /* R*omega_n*omega_n */
    const double t46 = JLT_FMA(t3, 2.0, t5); /* omega_n*b*2 + omega3*s*R */
    const double t47 = x[3]*t4; /* omega_n*s*R */
    const double t48 = x[3]*p[1]; /* omega_n*R */
    const double t49 = x[4]*t48; /* omega3*omega_n*R */
    const double t50 = t12*t17; /* s*1/(s*D)*I1*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n) */
    const double t51 = t42*p[10]; /* s*omega_tau*gamma3*2*m*a3^2 */
    const double t52 = t19*t51; /* s*s*1/(s*D)*s*omega_tau*gamma3*2*m*a3^2 */
    const double t53 = x[3]*p[11]; /* omega_n*(-2*I1) */
    const double t54 = t13*t53; /* gamma3*s*1/(s*D)*omega_n*(-2*I1) */
    const double t55 = t0*p[10]; /* s*omega_tau*2*m*a3^2 */
    const double t56 = t22*t55; /* omega_tau*gamma3*s*omega_tau*2*m*a3^2 */
    const double t57 = t12*t56; /* s*1/(s*D)*omega_tau*gamma3*s*omega_tau*2*m*a3^2 */
    const double t58 = t16*p[20]; /* (s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n)*2*I1 */
    const double t59 = t13*t58; /* gamma3*s*1/(s*D)*(s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n)*2*I1 */
    const double t60 = JLT_FNMA(t20, p[19], t59); /* t59 - s*s*s*1/(s*D)*2*m*g*a3 */
    const double t61 = p[9]*t19; /* m*a3^2*s*s*1/(s*D) */
    const double t62 = JLT_FNMA(t19, p[19], t57); /* s*1/(s*D)*omega_tau*gamma3*s*omega_tau*2*m*a3^2 - s*s*1/(s*D)*2*m*g*a3 */
    const double t63 = JLT_FNMA(t60, t61, t62); /* t62 - (t59 - s*s*s*1/(s*D)*2*m*g*a3)*m*a3^2*s*s*1/(s*D) */
    const double t64 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t65 = JLT_FNMA(t27, p[16], x[4]); /* omega3 - omega_n*D*1/(s*D)*a3/R */
    const double t66 = x[2]*t65; /* omega_tau*(omega3 - omega_n*D*1/(s*D)*a3/R) */
    const double t67 = -t28; /* -1/R*omega_n*D*1/(s*D) */
    const double t68 = x[0]*x[4]; /* gamma3*omega3 */
    const double t69 = JLT_FNMA(t24, t28, t68); /* gamma3*omega3 - e*1/R*omega_n*D*1/(s*D) */
    const double t70 = t25*p[17]; /* V*(-1/R) */
    const double t71 = t26*t70; /* D*1/(s*D)*V*(-1/R) */
    const double t72 = t26*t29; /* D*1/(s*D)*V*1/R*omega_n*D*1/(s*D) */
    const double t73 = t36*t47; /* S*omega_n*s*R */
    const double t74 = x[9]*t34; /* s*C */
    const double t75 = x[9]*t36; /* s*S */
    const double t76 = t2*t75; /* b*s*S */
    const double t77 = t4*t75; /* s*R*s*S */
    const double t78 = -t41; /* -s*(v_nu*S - (omega_n*b + omega3*s*R)*C) */
    const double t79 = JLT_FMA(t5, t36, t37); /* omega3*s*R*S + (omega_n*b + omega3*s*R)*S + v_nu*C */
    const double t80 = t34*t47; /* C*omega_n*s*R */
    const double t81 = -t80; /* -C*omega_n*s*R */
    const double t82 = t2*t74; /* b*s*C */
    const double t83 = -t82; /* -b*s*C */
    const double t84 = t4*t74; /* s*R*s*C */
    const double t85 = -t84; /* -s*R*s*C */
    const double t86 = JLT_FNMA(t5, t34, t40); /* v_nu*S - (omega_n*b + omega3*s*R)*C - omega3*s*R*C */
    const double t87 = -t0; /* -s*omega_tau */
    const double t88 = x[9]*x[0]; /* s*gamma3 */
    const double t89 = -t88; /* -s*gamma3 */
    const double t90 = -t22; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t7;
    out[2] = t21;
    out[3] = t23;
    out[4] = t30;
    out[5] = t31;
    out[6] = t33;
    out[7] = t38;
    out[8] = t41;
    out[9] = t43;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t8;
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
    out[24] = t47;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t49;
    out[30] = t50;
    out[31] = 0.0;
    out[32] = t52;
    out[33] = t54;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t63;
    out[40] = t64;
    out[41] = 0.0;
    out[42] = t32;
    out[43] = t22;
    out[44] = 0.0;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = 0.0;
    out[50] = t66;
    out[51] = t67;
    out[52] = t69;
    out[53] = t71;
    out[54] = t22;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = t72;
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
    out[80] = t73;
    out[81] = t74;
    out[82] = 0.0;
    out[83] = t76;
    out[84] = t77;
    out[85] = t78;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t79;
    out[90] = t81;
    out[91] = t75;
    out[92] = 0.0;
    out[93] = t83;
    out[94] = t85;
    out[95] = t38;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t86;
    out[100] = t87;
    out[101] = 0.0;
    out[102] = t89;
    out[103] = 0.0;
    out[104] = 0.0;
    out[105] = 0.0;
    out[106] = 0.0;
    out[107] = 0.0;
    out[108] = 0.0;
    out[109] = t90;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = JLT_FMA(p[9], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t2 = 1.0/t1; /* 1/D */
    const double t3 = p[10]*t0; /* 2*m*a3^2*s*s */
    const double t4 = JLT_FMA(t2, t3, 1.0); /* 1/D*2*m*a3^2*s*s + 1 */
    const double t5 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t6 = t4*t5; /* (1/D*2*m*a3^2*s*s + 1)*gamma3*omega_tau */
    out[0] = t6;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[18]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = p[1]*x[9]; /* R*s */
    const double t5 = JLT_FMA(x[4], t4, t3); /* v_tau = omega3*R*s + omega_n*b */
    const double t6 = JLT_FMA(t5, t5, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t7 = x[9]*p[9]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t10 = x[2]*t9; /* omega_tau*1/2*omega_tau */
    const double t11 = x[3]*p[22]; /* omega_n*1/2*I1 */
    const double t12 = JLT_FMA(x[3], t11, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t8, t10, t12); /* D*omega_tau*1/2*omega_tau + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(p[21], t6, t13); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t13 */
    const double t15 = x[9]*p[23]; /* s*R*I1 */
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
    const double t4 = p[24]*t3; /* m*R*v_tau */
    const double t5 = JLT_FMA(x[3], t4, p[18]); /* omega_n*m*R*v_tau + m*g*a3 */
    const double t6 = p[0]*x[1]; /* m*v_nu */
    const double t7 = x[9]*p[9]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = x[2]*t8; /* omega_tau*D */
    const double t10 = x[3]*p[4]; /* omega_n*I1 */
    const double t11 = t0*p[0]; /* b*m */
    const double t12 = JLT_FMA(t3, t11, t10); /* v_tau*b*m + omega_n*I1 */
    const double t13 = x[9]*t4; /* s*m*R*v_tau */
    const double t14 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t15 = t7*t14; /* s*m*a3^2*omega_tau*omega_tau */
    const double t16 = JLT_FMA(x[4], t4, t15); /* omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    const double t17 = x[9]*p[23]; /* s*R*I1 */
    const double t18 = x[3]*p[23]; /* omega_n*R*I1 */
    const double t19 = sin(x[5]); /* S = sin(chi) */
    const double t20 = x[3]*p[1]; /* omega_n*R */
    const double t21 = t19*t20; /* S*omega_n*R */
    const double t22 = cos(x[5]); /* C = cos(chi) */
    const double t23 = t0*t19; /* b*S */
    const double t24 = p[1]*x[9]; /* R*s */
    const double t25 = t19*t24; /* S*R*s */
    const double t26 = x[1]*t19; /* v_nu*S */
    const double t27 = JLT_FMS(t3, t22, t26); /* v_tau*C - v_nu*S */
    const double t28 = t2*t19; /* R*omega3*S */
    const double t29 = t20*t22; /* omega_n*R*C */
    const double t30 = -t29; /* -omega_n*R*C */
    const double t31 = t0*t22; /* b*C */
    const double t32 = -t31; /* -b*C */
    const double t33 = t22*t24; /* C*R*s */
    const double t34 = -t33; /* -C*R*s */
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
    out[24] = t25;
    out[25] = t27;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t28;
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
    double t7[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
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
    double t54[JLT_JET_ORDER_MAX + 1];
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
        t7[k] = jlt_jet_product(x9, x4, k);
        t10[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t12[k] = x3[k]*p[6];
        t13[k] = jlt_jet_product(t10, t12, k) + t7[k];
        t14[k] = p[1]*t13[k];
        t15[k] = jlt_jet_product(x3, t14, k);
        t18[k] = t2[k]*p[8];
        t20[k] = jlt_jet_product(x2, x0, k);
        t21[k] = p[7]*t20[k];
        t22[k] = jlt_jet_product(x3, x0, k);
        t23[k] = jlt_jet_product(x3, t22, k) + t18[k];
        t24[k] = t23[k] - jlt_jet_product(t3, t21, k);
        t27[k] = t2[k]*p[9] + (k == 0 ? p[4] : 0);
        t28[k] = jlt_jet_product(x9, t27, k);
        t30[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t28, t30, k);
        t31[k] = x9[k]*p[25];
        t32[k] = jlt_jet_product(t24, t31, k);
        t33[k] = jlt_jet_product(t30, t32, k);
        t34[k] = jlt_jet_product(x3, t20, k);
        t36[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t37[k] = jlt_jet_product(x2, t36, k) + x1[k];
        t38[k] = jlt_jet_product(t12, t27, k);
        t39[k] = jlt_jet_product(t37, t38, k);
        t40[k] = jlt_jet_product(t30, t39, k);
        t41[k] = jlt_jet_product(x4, t20, k) - t40[k];
        t42[k] = -x3[k];
        t43[k] = t7[k] + t22[k];
        t45[k] = jlt_jet_cosine(x5, t45, u45, k);
        t46[k] = jlt_jet_product(x1, t45, k);
        t47[k] = jlt_jet_sine(x5, t47, u47, k);
        t48[k] = jlt_jet_product(t14, t47, k) + t46[k];
        t49[k] = jlt_jet_product(x9, t48, k);
        t50[k] = jlt_jet_product(x1, t47, k);
        t51[k] = t50[k] - jlt_jet_product(t14, t45, k);
        t52[k] = jlt_jet_product(x9, t51, k);
        t53[k] = jlt_jet_product(x9, t20, k);
        t54[k] = -t53[k];
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t15[k]/(k + 1);
        next[2] = x2[k + 1] = t33[k]/(k + 1);
        next[3] = x3[k + 1] = t34[k]/(k + 1);
        next[4] = x4[k + 1] = t41[k]/(k + 1);
        next[5] = x5[k + 1] = t42[k]/(k + 1);
        next[6] = x6[k + 1] = t43[k]/(k + 1);
        next[7] = x7[k + 1] = t49[k]/(k + 1);
        next[8] = x8[k + 1] = t52[k]/(k + 1);
        next[9] = x9[k + 1] = t54[k]/(k + 1);
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
    .state_count = 10, .param_count = 6, .block_count = 26,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 10, { 3, 23, 10, 1, 0, 2, 7, 10 }, { 14, 49, 0, 4, 0, 2, 8, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .jacobian = { jacobian, 100, { 9, 52, 15, 1, 0, 2, 9, 16 }, { 27, 138, 0, 14, 0, 2, 11, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 110, { 11, 59, 18, 1, 0, 2, 9, 26 }, { 36, 177, 0, 18, 0, 2, 11, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes" },
    .divergence = { divergence, 1, { 0, 4, 2, 1, 0, 0, 5, 3 }, { 2, 12, 0, 1, 0, 0, 8, 4 },
        "" },
    .integral_values = { integral_values, 4, { 0, 12, 9, 0, 0, 2, 5, 7 }, { 9, 30, 0, 0, 0, 2, 9, 6 },
        "" },
    .integral_gradients = { integral_gradients, 40, { 4, 25, 8, 0, 0, 2, 5, 9 }, { 12, 51, 0, 0, 0, 2, 6, 7 },
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
