/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    balanced: a3 = 0
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   23   10    1    1    2     10   10   (90)
 *  jacobian            12   52   18    1    1    2     11   16   (284)
 *  rhs_jacobian        20   58   18    1    1    2     11   27   (349)
 *  divergence          2   11    4    1    1    0      7    6   (33)
 *  integral_values     3   15   10    0    1    2      9    8   (54)
 *  integral_gradients  2   30   12    1    1    2     10   11   (92)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_track[];
extern const jlt_descriptor jlt_kernels_spherical_top_track_balanced;
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
    const double t0 = params[4]*params[5]; /* I1*I3 */
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    const double t3 = params[4]*t2; /* I1*m*R*R */
    const double t4 = params[5]*t2; /* I3*m*R*R */
    const double t5 = params[5]/params[4]; /* I3/I1 */
    const double t6 = params[5]*params[5]; /* I3*I3 */
    const double t7 = t4 + t6; /* I3*m*R*R + I3*I3 */
    const double t8 = params[0]*params[1]; /* m*R */
    const double t9 = params[5]*t8; /* I3*m*R */
    const double t10 = params[4]*t8; /* I1*m*R */
    const double t11 = params[4] - params[5]; /* I1 - I3 */
    const double t12 = t2*t11; /* m*R*R*(I1 - I3) */
    const double t13 = params[1]*2.0; /* R*2 */
    const double t14 = -t5; /* -I3/I1 */
    const double t15 = t3*2.0; /* I1*m*R*R*2 */
    const double t16 = t4*2.0; /* I3*m*R*R*2 */
    const double t17 = t15 - t16; /* I1*m*R*R*2 - I3*m*R*R*2 */
    const double t18 = -params[0]; /* -m */
    const double t19 = -t8; /* -m*R */
    const double t20 = -t9; /* -I3*m*R */
    const double t21 = -t10; /* -I1*m*R */
    const double t22 = params[1]*t11; /* R*(I1 - I3) */
    const double t23 = t22/params[4]; /* R*(I1 - I3)/I1 */
    const double t24 = -t3; /* -I1*m*R*R */
    const double t25 = t11/params[4]; /* (I1 - I3)/I1 */
    const double t26 = params[0]/2.0; /* m/2 */
    const double t27 = params[4]/2.0; /* I1/2 */
    const double t28 = params[5]/2.0; /* I3/2 */
    const double t29 = params[4]*params[1]; /* I1*R */
    const double t30 = params[5]*params[1]; /* I3*R */
    const double t31 = -t29; /* -I1*R */
    const double t32 = -t30; /* -I3*R */
    const double t33 = params[4] + t2; /* I1 + m*R*R */
    const double t34 = params[5] + t2; /* I3 + m*R*R */
    const double t35 = -params[4]; /* -I1 */
    out[6] = t0;
    out[7] = t3;
    out[8] = t4;
    out[9] = t5;
    out[10] = t7;
    out[11] = t9;
    out[12] = t10;
    out[13] = t12;
    out[14] = t13;
    out[15] = t14;
    out[16] = t17;
    out[17] = t20;
    out[18] = t21;
    out[19] = t23;
    out[20] = t24;
    out[21] = t25;
    out[22] = t8;
    out[23] = t22;
    out[24] = t26;
    out[25] = t27;
    out[26] = t28;
    out[27] = t29;
    out[28] = t30;
    out[29] = t18;
    out[30] = t31;
    out[31] = t32;
    out[32] = t19;
    out[33] = t33;
    out[34] = t34;
    out[35] = t35;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = x[0]*x[3]; /* gamma3*omega_n */
    const double t6 = x[0]*p[8]; /* gamma3*m*R^2*I3 */
    const double t7 = JLT_FMA(x[0], t6, p[6]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t8 = JLT_FMA(t2, p[7], t7); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t9 = t3*t8; /* s*Theta */
    const double t10 = 1.0/t9; /* 1/(s*Theta) */
    const double t11 = t8*t10; /* Theta*1/(s*Theta) */
    const double t12 = t5*t11; /* gamma3*omega_n*Theta*1/(s*Theta) */
    const double t13 = x[4] + t12; /* omega3 + gamma3*omega_n*Theta*1/(s*Theta) */
    const double t14 = p[1]*x[3]; /* R*omega_n */
    const double t15 = t13*t14; /* (omega3 + gamma3*omega_n*Theta*1/(s*Theta))*R*omega_n */
    const double t16 = JLT_FMA(x[4], p[9], t12); /* omega3*I3/I1 + gamma3*omega_n*Theta*1/(s*Theta) */
    const double t17 = x[3]*t16; /* omega_n*(omega3*I3/I1 + gamma3*omega_n*Theta*1/(s*Theta)) */
    const double t18 = -t17; /* -omega_n*(omega3*I3/I1 + gamma3*omega_n*Theta*1/(s*Theta)) */
    const double t19 = t3*t10; /* s*1/(s*Theta) */
    const double t20 = x[4]*t19; /* omega3*s*1/(s*Theta) */
    const double t21 = JLT_FMA(p[10], t20, t12); /* (I3^2 + m*R^2*I3)*omega3*s*1/(s*Theta) + gamma3*omega_n*Theta*1/(s*Theta) */
    const double t22 = x[2]*t21; /* omega_tau*t21 */
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t24 = t19*t23; /* s*1/(s*Theta)*V */
    const double t25 = t12*p[11]; /* gamma3*omega_n*Theta*1/(s*Theta)*m*R*I3 */
    const double t26 = JLT_FNMA(t24, t25, t22); /* omega_tau*t21 - s*1/(s*Theta)*V*gamma3*omega_n*Theta*1/(s*Theta)*m*R*I3 */
    const double t27 = x[3]*p[12]; /* omega_n*m*R*I1 */
    const double t28 = t24*t27; /* s*1/(s*Theta)*V*omega_n*m*R*I1 */
    const double t29 = x[0]*p[13]; /* gamma3*m*R^2*(I1 - I3) */
    const double t30 = t4*t29; /* omega_tau*s*gamma3*m*R^2*(I1 - I3) */
    const double t31 = JLT_FMS(t20, t30, t28); /* omega3*s*1/(s*Theta)*omega_tau*s*gamma3*m*R^2*(I1 - I3) - s*1/(s*Theta)*V*omega_n*m*R*I1 */
    const double t32 = x[3]*t11; /* omega_n*Theta*1/(s*Theta) */
    const double t33 = -t32; /* -omega_n*Theta*1/(s*Theta) */
    const double t34 = cos(x[5]); /* C = cos(chi) */
    const double t35 = x[1]*t34; /* v_nu*C */
    const double t36 = sin(x[5]); /* S = sin(chi) */
    const double t37 = JLT_FMA(t3, x[4], t5); /* s*omega3 + gamma3*omega_n */
    const double t38 = p[1]*t37; /* v_tau = R*(s*omega3 + gamma3*omega_n) */
    const double t39 = JLT_FMA(t36, t38, t35); /* S*v_tau + v_nu*C */
    const double t40 = x[1]*t36; /* v_nu*S */
    const double t41 = JLT_FNMA(t34, t38, t40); /* v_nu*S - C*v_tau */
    out[0] = t4;
    out[1] = t15;
    out[2] = t18;
    out[3] = t26;
    out[4] = t31;
    out[5] = t33;
    out[6] = t13;
    out[7] = t39;
    out[8] = t41;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[8]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[6]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t5 = JLT_FMA(p[7], t2, t4); /* Theta = m*R^2*I1*(1 - gamma3)*(gamma3 + 1) + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = t5*t6; /* Theta*s */
    const double t8 = 1.0/t7; /* 1/(Theta*s) */
    const double t9 = t5*t8; /* Theta*1/(Theta*s) */
    const double t10 = x[0]*t9; /* gamma3*Theta*1/(Theta*s) */
    const double t11 = x[2]*t10; /* omega_tau*gamma3*Theta*1/(Theta*s) */
    const double t12 = -t11; /* -omega_tau*gamma3*Theta*1/(Theta*s) */
    const double t13 = p[1]*x[3]; /* R*omega_n */
    const double t14 = JLT_FMA(t10, t10, 1.0); /* gamma3*Theta*1/(Theta*s)*gamma3*Theta*1/(Theta*s) + 1 */
    const double t15 = t9*x[3]; /* Theta*1/(Theta*s)*omega_n */
    const double t16 = t14*t15; /* (gamma3*Theta*1/(Theta*s)*gamma3*Theta*1/(Theta*s) + 1)*Theta*1/(Theta*s)*omega_n */
    const double t17 = t13*t16; /* R*omega_n*t16 */
    const double t18 = p[1]*x[4]; /* R*omega3 */
    const double t19 = t10*x[3]; /* gamma3*Theta*1/(Theta*s)*omega_n */
    const double t20 = JLT_FMA(p[14], t19, t18); /* 2*R*gamma3*Theta*1/(Theta*s)*omega_n + R*omega3 */
    const double t21 = x[3]*t16; /* omega_n*t16 */
    const double t22 = -t21; /* -omega_n*t16 */
    const double t23 = t19*(-2.0); /* gamma3*Theta*1/(Theta*s)*omega_n*(-2) */
    const double t24 = JLT_FMA(x[4], p[15], t23); /* omega3*(-I3/I1) + gamma3*Theta*1/(Theta*s)*omega_n*(-2) */
    const double t25 = x[3]*p[15]; /* omega_n*(-I3/I1) */
    const double t26 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t27 = t6*t8; /* s*1/(Theta*s) */
    const double t28 = t26*t27; /* V*s*1/(Theta*s) */
    const double t29 = p[11]*t28; /* m*R*I3*V*s*1/(Theta*s) */
    const double t30 = x[2] - t29; /* omega_tau - m*R*I3*V*s*1/(Theta*s) */
    const double t31 = t16*t30; /* t16*(omega_tau - m*R*I3*V*s*1/(Theta*s)) */
    const double t32 = x[0]*p[16]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t33 = t27*t32; /* s*1/(Theta*s)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t34 = t19*t29; /* gamma3*Theta*1/(Theta*s)*omega_n*m*R*I3*V*s*1/(Theta*s) */
    const double t35 = x[2]*t27; /* omega_tau*s*1/(Theta*s) */
    const double t36 = x[4]*t35; /* omega3*omega_tau*s*1/(Theta*s) */
    const double t37 = JLT_FNMA(p[10], t36, t34); /* gamma3*Theta*1/(Theta*s)*omega_n*m*R*I3*V*s*1/(Theta*s) - (I3^2 + m*R^2*I3)*omega3*omega_tau*s*1/(Theta*s) */
    const double t38 = JLT_FNMA(t33, t37, t31); /* t16*(omega_tau - m*R*I3*V*s*1/(Theta*s)) - s*1/(Theta*s)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*t37 */
    const double t39 = t19*t27; /* gamma3*Theta*1/(Theta*s)*omega_n*s*1/(Theta*s) */
    const double t40 = p[17]*t39; /* (-m*R*I3)*gamma3*Theta*1/(Theta*s)*omega_n*s*1/(Theta*s) */
    const double t41 = x[4]*t27; /* omega3*s*1/(Theta*s) */
    const double t42 = JLT_FMA(p[10], t41, t19); /* (I3^2 + m*R^2*I3)*omega3*s*1/(Theta*s) + gamma3*Theta*1/(Theta*s)*omega_n */
    const double t43 = JLT_FNMA(p[8], t39, t42); /* t42 - m*R^2*I3*gamma3*Theta*1/(Theta*s)*omega_n*s*1/(Theta*s) */
    const double t44 = t10*t30; /* gamma3*Theta*1/(Theta*s)*(omega_tau - m*R*I3*V*s*1/(Theta*s)) */
    const double t45 = p[10]*t35; /* (I3^2 + m*R^2*I3)*omega_tau*s*1/(Theta*s) */
    const double t46 = t28*p[12]; /* V*s*1/(Theta*s)*m*R*I1 */
    const double t47 = x[3]*t33; /* omega_n*s*1/(Theta*s)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t48 = t46*t47; /* V*s*1/(Theta*s)*m*R*I1*omega_n*s*1/(Theta*s)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t49 = JLT_FNMA(t6, t33, t10); /* gamma3*Theta*1/(Theta*s) - s*s*1/(Theta*s)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t50 = JLT_FMS(x[0], t49, t6); /* gamma3*t49 - s */
    const double t51 = t36*p[13]; /* omega3*omega_tau*s*1/(Theta*s)*m*R^2*(I1 - I3) */
    const double t52 = JLT_FMA(t50, t51, t48); /* (gamma3*t49 - s)*omega3*omega_tau*s*1/(Theta*s)*m*R^2*(I1 - I3) + t48 */
    const double t53 = -t52; /* -t52 */
    const double t54 = x[3]*t27; /* omega_n*s*1/(Theta*s) */
    const double t55 = p[18]*t54; /* (-m*R*I1)*omega_n*s*1/(Theta*s) */
    const double t56 = x[0]*p[13]; /* gamma3*m*R^2*(I1 - I3) */
    const double t57 = t6*t56; /* s*gamma3*m*R^2*(I1 - I3) */
    const double t58 = t41*t57; /* omega3*s*1/(Theta*s)*s*gamma3*m*R^2*(I1 - I3) */
    const double t59 = JLT_FNMA(p[7], t54, t58); /* omega3*s*1/(Theta*s)*s*gamma3*m*R^2*(I1 - I3) - m*R^2*I1*omega_n*s*1/(Theta*s) */
    const double t60 = -t46; /* -V*s*1/(Theta*s)*m*R*I1 */
    const double t61 = t35*t57; /* omega_tau*s*1/(Theta*s)*s*gamma3*m*R^2*(I1 - I3) */
    const double t62 = t9*t9; /* Theta*1/(Theta*s)*Theta*1/(Theta*s) */
    const double t63 = t19*t62; /* gamma3*Theta*1/(Theta*s)*omega_n*Theta*1/(Theta*s)*Theta*1/(Theta*s) */
    const double t64 = -t63; /* -t63 */
    const double t65 = -t9; /* -Theta*1/(Theta*s) */
    const double t66 = sin(x[5]); /* S = sin(chi) */
    const double t67 = JLT_FNMA(t10, t18, t13); /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*Theta*1/(Theta*s)*R*omega3 */
    const double t68 = t66*t67; /* S*d(v_tau)/d(gamma3) */
    const double t69 = cos(x[5]); /* C = cos(chi) */
    const double t70 = x[0]*p[1]; /* gamma3*R */
    const double t71 = t66*t70; /* S*gamma3*R */
    const double t72 = t6*p[1]; /* s*R */
    const double t73 = t66*t72; /* S*s*R */
    const double t74 = x[1]*t66; /* v_nu*S */
    const double t75 = t6*t18; /* s*R*omega3 */
    const double t76 = JLT_FMA(x[0], t13, t75); /* v_tau = gamma3*R*omega_n + s*R*omega3 */
    const double t77 = JLT_FMS(t69, t76, t74); /* C*v_tau - v_nu*S */
    const double t78 = t67*t69; /* d(v_tau)/d(gamma3)*C */
    const double t79 = -t78; /* -d(v_tau)/d(gamma3)*C */
    const double t80 = t69*t70; /* C*gamma3*R */
    const double t81 = -t80; /* -C*gamma3*R */
    const double t82 = t69*t72; /* C*s*R */
    const double t83 = -t82; /* -C*s*R */
    const double t84 = x[1]*t69; /* v_nu*C */
    const double t85 = JLT_FMA(t66, t76, t84); /* S*v_tau + v_nu*C */
    out[0] = t12;
    out[1] = 0.0;
    out[2] = t6;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t17;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t20;
    out[13] = t13;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t22;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = t24;
    out[22] = t25;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t38;
    out[28] = t40;
    out[29] = t43;
    out[30] = t44;
    out[31] = t45;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t53;
    out[37] = t55;
    out[38] = t59;
    out[39] = t60;
    out[40] = t61;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t64;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = t65;
    out[49] = 0.0;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[54] = t16;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t10;
    out[58] = 1.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = t68;
    out[64] = t69;
    out[65] = 0.0;
    out[66] = t71;
    out[67] = t73;
    out[68] = t77;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t79;
    out[73] = t66;
    out[74] = 0.0;
    out[75] = t81;
    out[76] = t83;
    out[77] = t85;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = p[1]*x[3]; /* R*omega_n */
    const double t6 = x[0]*p[8]; /* gamma3*m*R^2*I3 */
    const double t7 = JLT_FMA(x[0], t6, p[6]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t8 = JLT_FMA(t2, p[7], t7); /* Theta = (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t9 = t3*t8; /* s*Theta */
    const double t10 = 1.0/t9; /* 1/(s*Theta) */
    const double t11 = t8*t10; /* Theta*1/(s*Theta) */
    const double t12 = x[0]*t11; /* gamma3*Theta*1/(s*Theta) */
    const double t13 = x[3]*t12; /* omega_n*gamma3*Theta*1/(s*Theta) */
    const double t14 = x[4] + t13; /* omega3 + omega_n*gamma3*Theta*1/(s*Theta) */
    const double t15 = t5*t14; /* R*omega_n*(omega3 + omega_n*gamma3*Theta*1/(s*Theta)) */
    const double t16 = x[4]*p[9]; /* omega3*I3/I1 */
    const double t17 = t13 + t16; /* omega_n*gamma3*Theta*1/(s*Theta) + omega3*I3/I1 */
    const double t18 = x[3]*t17; /* omega_n*(omega_n*gamma3*Theta*1/(s*Theta) + omega3*I3/I1) */
    const double t19 = -t18; /* -omega_n*(omega_n*gamma3*Theta*1/(s*Theta) + omega3*I3/I1) */
    const double t20 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t21 = t3*t10; /* s*1/(s*Theta) */
    const double t22 = p[11]*t21; /* m*R*I3*s*1/(s*Theta) */
    const double t23 = t20*t22; /* V*m*R*I3*s*1/(s*Theta) */
    const double t24 = x[2] - t23; /* omega_tau - V*m*R*I3*s*1/(s*Theta) */
    const double t25 = x[2]*t21; /* omega_tau*s*1/(s*Theta) */
    const double t26 = x[4]*p[10]; /* omega3*(I3^2 + m*R^2*I3) */
    const double t27 = t25*t26; /* omega_tau*s*1/(s*Theta)*omega3*(I3^2 + m*R^2*I3) */
    const double t28 = JLT_FMA(t13, t24, t27); /* omega_n*gamma3*Theta*1/(s*Theta)*(omega_tau - V*m*R*I3*s*1/(s*Theta)) + omega_tau*s*1/(s*Theta)*omega3*(I3^2 + m*R^2*I3) */
    const double t29 = x[0]*t3; /* gamma3*s */
    const double t30 = x[4]*t29; /* omega3*gamma3*s */
    const double t31 = x[2]*p[19]; /* omega_tau*R*(I1 - I3)/I1 */
    const double t32 = t30*t31; /* omega3*gamma3*s*omega_tau*R*(I1 - I3)/I1 */
    const double t33 = JLT_FNMA(x[3], t20, t32); /* omega3*gamma3*s*omega_tau*R*(I1 - I3)/I1 - omega_n*V */
    const double t34 = t21*p[12]; /* s*1/(s*Theta)*m*R*I1 */
    const double t35 = t33*t34; /* (omega3*gamma3*s*omega_tau*R*(I1 - I3)/I1 - omega_n*V)*s*1/(s*Theta)*m*R*I1 */
    const double t36 = x[3]*t11; /* omega_n*Theta*1/(s*Theta) */
    const double t37 = -t36; /* -omega_n*Theta*1/(s*Theta) */
    const double t38 = cos(x[5]); /* C = cos(chi) */
    const double t39 = x[1]*t38; /* v_nu*C */
    const double t40 = sin(x[5]); /* S = sin(chi) */
    const double t41 = t3*p[1]; /* s*R */
    const double t42 = x[4]*t41; /* omega3*s*R */
    const double t43 = JLT_FMA(x[0], t5, t42); /* v_tau = gamma3*R*omega_n + omega3*s*R */
    const double t44 = JLT_FMA(t40, t43, t39); /* S*v_tau + v_nu*C */
    const double t45 = x[1]*t40; /* v_nu*S */
    const double t46 = t38*t43; /* C*v_tau */
    const double t47 = t45 - t46; /* v_nu*S - C*v_tau */
    const double t48 = x[2]*t12; /* omega_tau*gamma3*Theta*1/(s*Theta) */
    const double t49 = -t48; /* -omega_tau*gamma3*Theta*1/(s*Theta) */
    const double t50 = JLT_FMA(t12, t12, 1.0); /* gamma3*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) + 1 */
    const double t51 = t36*t50; /* omega_n*Theta*1/(s*Theta)*(gamma3*Theta*1/(s*Theta)*gamma3*Theta*1/(s*Theta) + 1) */
    const double t52 = t5*t51; /* R*omega_n*t51 */
    const double t53 = p[1]*x[4]; /* R*omega3 */
    const double t54 = JLT_FMA(t13, p[14], t53); /* omega_n*gamma3*Theta*1/(s*Theta)*2*R + R*omega3 */
    const double t55 = x[3]*t51; /* omega_n*t51 */
    const double t56 = -t55; /* -omega_n*t51 */
    const double t57 = JLT_FMA(t13, 2.0, t16); /* omega_n*gamma3*Theta*1/(s*Theta)*2 + omega3*I3/I1 */
    const double t58 = -t57; /* -(omega_n*gamma3*Theta*1/(s*Theta)*2 + omega3*I3/I1) */
    const double t59 = x[3]*p[15]; /* omega_n*(-I3/I1) */
    const double t60 = t24*t51; /* (omega_tau - V*m*R*I3*s*1/(s*Theta))*t51 */
    const double t61 = JLT_FNMA(t13, t23, t27); /* omega_tau*s*1/(s*Theta)*omega3*(I3^2 + m*R^2*I3) - omega_n*gamma3*Theta*1/(s*Theta)*V*m*R*I3*s*1/(s*Theta) */
    const double t62 = x[0]*p[16]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t63 = t21*t62; /* s*1/(s*Theta)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t64 = JLT_FMA(t61, t63, t60); /* t61*s*1/(s*Theta)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) + (omega_tau - V*m*R*I3*s*1/(s*Theta))*t51 */
    const double t65 = t13*t22; /* omega_n*gamma3*Theta*1/(s*Theta)*m*R*I3*s*1/(s*Theta) */
    const double t66 = -t65; /* -omega_n*gamma3*Theta*1/(s*Theta)*m*R*I3*s*1/(s*Theta) */
    const double t67 = JLT_FMS(p[8], t13, t26); /* m*R^2*I3*omega_n*gamma3*Theta*1/(s*Theta) - omega3*(I3^2 + m*R^2*I3) */
    const double t68 = JLT_FNMA(t21, t67, t13); /* omega_n*gamma3*Theta*1/(s*Theta) - s*1/(s*Theta)*t67 */
    const double t69 = t12*t24; /* gamma3*Theta*1/(s*Theta)*(omega_tau - V*m*R*I3*s*1/(s*Theta)) */
    const double t70 = t25*p[10]; /* omega_tau*s*1/(s*Theta)*(I3^2 + m*R^2*I3) */
    const double t71 = t35*t63; /* t35*s*1/(s*Theta)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t72 = JLT_FMS(x[0], t12, t3); /* gamma3*gamma3*Theta*1/(s*Theta) - s */
    const double t73 = t25*p[13]; /* omega_tau*s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t74 = x[4]*t73; /* omega3*omega_tau*s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t75 = JLT_FNMA(t72, t74, t71); /* t35*s*1/(s*Theta)*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) - (gamma3*gamma3*Theta*1/(s*Theta) - s)*omega3*omega_tau*s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t76 = x[3]*t34; /* omega_n*s*1/(s*Theta)*m*R*I1 */
    const double t77 = -t76; /* -omega_n*s*1/(s*Theta)*m*R*I1 */
    const double t78 = JLT_FNMA(t30, p[21], x[3]); /* omega_n - omega3*gamma3*s*(I1 - I3)/I1 */
    const double t79 = p[20]*t78; /* (-m*R^2*I1)*(omega_n - omega3*gamma3*s*(I1 - I3)/I1) */
    const double t80 = t21*t79; /* s*1/(s*Theta)*(-m*R^2*I1)*(omega_n - omega3*gamma3*s*(I1 - I3)/I1) */
    const double t81 = t20*t34; /* V*s*1/(s*Theta)*m*R*I1 */
    const double t82 = -t81; /* -V*s*1/(s*Theta)*m*R*I1 */
    const double t83 = t29*t73; /* gamma3*s*omega_tau*s*1/(s*Theta)*m*R^2*(I1 - I3) */
    const double t84 = t11*t11; /* Theta*1/(s*Theta)*Theta*1/(s*Theta) */
    const double t85 = t13*t84; /* omega_n*gamma3*Theta*1/(s*Theta)*Theta*1/(s*Theta)*Theta*1/(s*Theta) */
    const double t86 = -t85; /* -t85 */
    const double t87 = -t11; /* -Theta*1/(s*Theta) */
    const double t88 = JLT_FNMA(t12, t53, t5); /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*Theta*1/(s*Theta)*R*omega3 */
    const double t89 = t40*t88; /* S*d(v_tau)/d(gamma3) */
    const double t90 = x[0]*p[1]; /* gamma3*R */
    const double t91 = t40*t90; /* S*gamma3*R */
    const double t92 = t40*t41; /* S*s*R */
    const double t93 = t46 - t45; /* C*v_tau - v_nu*S */
    const double t94 = t38*t88; /* C*d(v_tau)/d(gamma3) */
    const double t95 = -t94; /* -C*d(v_tau)/d(gamma3) */
    const double t96 = t38*t90; /* C*gamma3*R */
    const double t97 = -t96; /* -C*gamma3*R */
    const double t98 = t38*t41; /* C*s*R */
    const double t99 = -t98; /* -C*s*R */
    out[0] = t4;
    out[1] = t15;
    out[2] = t19;
    out[3] = t28;
    out[4] = t35;
    out[5] = t37;
    out[6] = t14;
    out[7] = t44;
    out[8] = t47;
    out[9] = t49;
    out[10] = 0.0;
    out[11] = t3;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t52;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = t54;
    out[22] = t5;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t56;
    out[28] = 0.0;
    out[29] = 0.0;
    out[30] = t58;
    out[31] = t59;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t64;
    out[37] = t66;
    out[38] = t68;
    out[39] = t69;
    out[40] = t70;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t75;
    out[46] = t77;
    out[47] = t80;
    out[48] = t82;
    out[49] = t83;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[54] = t86;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t87;
    out[58] = 0.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = t51;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = t12;
    out[67] = 1.0;
    out[68] = 0.0;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t89;
    out[73] = t38;
    out[74] = 0.0;
    out[75] = t91;
    out[76] = t92;
    out[77] = t93;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[81] = t95;
    out[82] = t40;
    out[83] = 0.0;
    out[84] = t97;
    out[85] = t99;
    out[86] = t44;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = 0.0;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = p[23]*x[2]; /* R*(I1 - I3)*omega_tau */
    const double t5 = t3*t4; /* s*R*(I1 - I3)*omega_tau */
    const double t6 = x[0]*p[8]; /* gamma3*m*R^2*I3 */
    const double t7 = JLT_FMA(x[0], t6, p[6]); /* gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t8 = JLT_FMA(t2, p[7], t7); /* Theta = (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + gamma3*gamma3*m*R^2*I3 + I1*I3 */
    const double t9 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t10 = t3*t8; /* s*Theta */
    const double t11 = 1.0/t10; /* 1/(s*Theta) */
    const double t12 = p[5]*t9; /* I3*V */
    const double t13 = t8*t12; /* Theta*I3*V */
    const double t14 = JLT_FNMA(t11, t13, t5); /* s*R*(I1 - I3)*omega_tau - 1/(s*Theta)*Theta*I3*V */
    const double t15 = p[22]*x[0]; /* m*R*gamma3 */
    const double t16 = t3*t15; /* s*m*R*gamma3 */
    const double t17 = t11*t16; /* 1/(s*Theta)*s*m*R*gamma3 */
    const double t18 = t14*t17; /* (s*R*(I1 - I3)*omega_tau - 1/(s*Theta)*Theta*I3*V)*1/(s*Theta)*s*m*R*gamma3 */
    out[0] = t18;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = x[4]*t5; /* omega3*s */
    const double t7 = t1 + t6; /* omega_n*gamma3 + omega3*s */
    const double t8 = p[1]*t7; /* v_tau = R*(omega_n*gamma3 + omega3*s) */
    const double t9 = JLT_FMA(t8, t8, t0); /* v_tau*v_tau + v_nu*v_nu */
    const double t10 = x[3]*x[3]; /* omega_n*omega_n */
    const double t11 = JLT_FMA(x[2], x[2], t10); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t12 = p[25]*t11; /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t13 = x[4]*p[26]; /* omega3*1/2*I3 */
    const double t14 = JLT_FMA(x[4], t13, t12); /* omega3*omega3*1/2*I3 + 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t15 = JLT_FMA(p[24], t9, t14); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t14 */
    const double t16 = x[3]*p[27]; /* omega_n*R*I1 */
    const double t17 = t5*t16; /* s*omega_n*R*I1 */
    const double t18 = x[4]*p[28]; /* omega3*R*I3 */
    const double t19 = JLT_FNMA(x[0], t18, t17); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    const double t20 = cos(x[5]); /* C = cos(chi) */
    const double t21 = t1*p[4]; /* omega_n*gamma3*I1 */
    const double t22 = JLT_FMA(t6, p[5], t21); /* omega3*s*I3 + omega_n*gamma3*I1 */
    const double t23 = JLT_FMA(t8, p[22], t22); /* M_nu = v_tau*m*R + omega3*s*I3 + omega_n*gamma3*I1 */
    const double t24 = t20*t23; /* C*M_nu */
    const double t25 = sin(x[5]); /* S = sin(chi) */
    const double t26 = x[2]*p[4]; /* omega_tau*I1 */
    const double t27 = JLT_FNMA(x[1], p[22], t26); /* M_tau = omega_tau*I1 - v_nu*m*R */
    const double t28 = JLT_FMA(t25, t27, t24); /* S*M_tau + C*M_nu */
    const double t29 = t23*t25; /* M_nu*S */
    const double t30 = JLT_FNMA(t20, t27, t29); /* M_nu*S - C*M_tau */
    out[0] = t15;
    out[1] = t19;
    out[2] = t28;
    out[3] = t30;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[0]*x[3]; /* gamma3*omega_n */
    const double t5 = JLT_FMA(x[4], t3, t4); /* omega3*s + gamma3*omega_n */
    const double t6 = p[1]*t5; /* v_tau = R*(omega3*s + gamma3*omega_n) */
    const double t7 = 1.0/t3; /* 1/s */
    const double t8 = x[0]*t7; /* gamma3*1/s */
    const double t9 = JLT_FMS(x[4], t8, x[3]); /* omega3*gamma3*1/s - omega_n */
    const double t10 = p[1]*t9; /* R*(omega3*gamma3*1/s - omega_n) */
    const double t11 = p[29]*t6; /* (-m)*v_tau */
    const double t12 = t10*t11; /* R*(omega3*gamma3*1/s - omega_n)*(-m)*v_tau */
    const double t13 = p[0]*x[1]; /* m*v_nu */
    const double t14 = p[4]*x[2]; /* I1*omega_tau */
    const double t15 = x[3]*p[4]; /* omega_n*I1 */
    const double t16 = t6*p[22]; /* v_tau*m*R */
    const double t17 = JLT_FMA(x[0], t16, t15); /* gamma3*v_tau*m*R + omega_n*I1 */
    const double t18 = x[4]*p[5]; /* omega3*I3 */
    const double t19 = JLT_FMA(t3, t16, t18); /* s*v_tau*m*R + omega3*I3 */
    const double t20 = t4*p[30]; /* gamma3*omega_n*(-R*I1) */
    const double t21 = t7*t20; /* 1/s*gamma3*omega_n*(-R*I1) */
    const double t22 = JLT_FMA(x[4], p[31], t21); /* omega3*(-R*I3) + 1/s*gamma3*omega_n*(-R*I1) */
    const double t23 = t3*p[27]; /* s*R*I1 */
    const double t24 = x[0]*p[31]; /* gamma3*(-R*I3) */
    const double t25 = cos(x[5]); /* C = cos(chi) */
    const double t26 = JLT_FNMA(t8, t18, t15); /* omega_n*I1 - gamma3*1/s*omega3*I3 */
    const double t27 = JLT_FNMA(t10, p[22], t26); /* d(M_nu)/d(gamma3) = omega_n*I1 - gamma3*1/s*omega3*I3 - R*(omega3*gamma3*1/s - omega_n)*m*R */
    const double t28 = t25*t27; /* C*d(M_nu)/d(gamma3) */
    const double t29 = sin(x[5]); /* S = sin(chi) */
    const double t30 = p[32]*t29; /* (-m*R)*S */
    const double t31 = p[4]*t29; /* I1*S */
    const double t32 = x[0]*p[33]; /* d(M_nu)/d(omega_n) = gamma3*(I1 + m*R^2) */
    const double t33 = t25*t32; /* C*d(M_nu)/d(omega_n) */
    const double t34 = t3*p[34]; /* d(M_nu)/d(omega3) = s*(I3 + m*R^2) */
    const double t35 = t25*t34; /* C*d(M_nu)/d(omega3) */
    const double t36 = JLT_FMA(t4, p[4], t16); /* gamma3*omega_n*I1 + v_tau*m*R */
    const double t37 = JLT_FMA(t3, t18, t36); /* M_nu = s*omega3*I3 + gamma3*omega_n*I1 + v_tau*m*R */
    const double t38 = t29*t37; /* S*M_nu */
    const double t39 = JLT_FNMA(x[1], p[22], t14); /* M_tau = I1*omega_tau - v_nu*m*R */
    const double t40 = JLT_FMS(t25, t39, t38); /* C*M_tau - S*M_nu */
    const double t41 = t27*t29; /* d(M_nu)/d(gamma3)*S */
    const double t42 = p[22]*t25; /* m*R*C */
    const double t43 = t25*p[35]; /* C*(-I1) */
    const double t44 = t29*t32; /* S*d(M_nu)/d(omega_n) */
    const double t45 = t29*t34; /* S*d(M_nu)/d(omega3) */
    const double t46 = t25*t37; /* C*M_nu */
    const double t47 = JLT_FMA(t29, t39, t46); /* S*M_tau + C*M_nu */
    out[0] = t12;
    out[1] = t13;
    out[2] = t14;
    out[3] = t17;
    out[4] = t19;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t22;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t23;
    out[13] = t24;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t28;
    out[19] = t30;
    out[20] = t31;
    out[21] = t33;
    out[22] = t35;
    out[23] = t40;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t41;
    out[28] = t42;
    out[29] = t43;
    out[30] = t44;
    out[31] = t45;
    out[32] = t47;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
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
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double u50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double u52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
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
        t11[k] = jlt_jet_product(x0, x3, k);
        t15[k] = x0[k]*p[8];
        t16[k] = jlt_jet_product(x0, t15, k) + (k == 0 ? p[6] : 0);
        t17[k] = t5[k]*p[7] + t16[k];
        t18[k] = jlt_jet_product(t6, t17, k);
        t19[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t18, t19, k);
        t20[k] = jlt_jet_product(t17, t19, k);
        t21[k] = jlt_jet_product(t11, t20, k);
        t22[k] = x4[k] + t21[k];
        t23[k] = p[1]*x3[k];
        t24[k] = jlt_jet_product(t22, t23, k);
        t26[k] = x4[k]*p[9] + t21[k];
        t27[k] = jlt_jet_product(x3, t26, k);
        t28[k] = -t27[k];
        t30[k] = jlt_jet_product(t6, t19, k);
        t31[k] = jlt_jet_product(x4, t30, k);
        t32[k] = p[10]*t31[k] + t21[k];
        t33[k] = jlt_jet_product(x2, t32, k);
        t36[k] = x2[k]*p[1] + x1[k];
        t37[k] = jlt_jet_product(t30, t36, k);
        t38[k] = t21[k]*p[11];
        t39[k] = t33[k] - jlt_jet_product(t37, t38, k);
        t41[k] = x3[k]*p[12];
        t42[k] = jlt_jet_product(t37, t41, k);
        t44[k] = x0[k]*p[13];
        t45[k] = jlt_jet_product(t7, t44, k);
        t46[k] = jlt_jet_product(t31, t45, k) - t42[k];
        t47[k] = jlt_jet_product(x3, t20, k);
        t48[k] = -t47[k];
        t50[k] = jlt_jet_cosine(x5, t50, u50, k);
        t51[k] = jlt_jet_product(x1, t50, k);
        t52[k] = jlt_jet_sine(x5, t52, u52, k);
        t53[k] = jlt_jet_product(t6, x4, k) + t11[k];
        t54[k] = p[1]*t53[k];
        t55[k] = jlt_jet_product(t52, t54, k) + t51[k];
        t56[k] = jlt_jet_product(x1, t52, k);
        t57[k] = t56[k] - jlt_jet_product(t50, t54, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t24[k]/(k + 1);
        next[2] = x2[k + 1] = t28[k]/(k + 1);
        next[3] = x3[k + 1] = t39[k]/(k + 1);
        next[4] = x4[k + 1] = t46[k]/(k + 1);
        next[5] = x5[k + 1] = t48[k]/(k + 1);
        next[6] = x6[k + 1] = t22[k]/(k + 1);
        next[7] = x7[k + 1] = t55[k]/(k + 1);
        next[8] = x8[k + 1] = t57[k]/(k + 1);
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
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_track,
    .state_count = 9, .param_count = 6, .block_count = 36,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 9, { 5, 23, 10, 1, 1, 2, 10, 10 }, { 17, 59, 0, 11, 1, 2, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 81, { 12, 52, 18, 1, 1, 2, 11, 16 }, { 45, 196, 0, 40, 1, 2, 14, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 90, { 20, 58, 18, 1, 1, 2, 11, 27 }, { 57, 238, 0, 51, 1, 2, 14, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 11, 4, 1, 1, 0, 7, 6 }, { 6, 24, 0, 2, 1, 0, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 4, { 3, 15, 10, 0, 1, 2, 9, 8 }, { 12, 39, 0, 0, 1, 2, 10, 7 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 36, { 2, 30, 12, 1, 1, 2, 10, 11 }, { 19, 67, 0, 3, 1, 2, 9, 10 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_track_balanced_baseline,
        &jlt_batch_spherical_top_track_balanced_avx2,
        &jlt_batch_spherical_top_track_balanced_avx512,
    },
};
