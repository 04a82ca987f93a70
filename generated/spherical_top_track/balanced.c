/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    balanced: a3 = 0
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 6   22    9    1    1    2     11    8   (90)
 *  jacobian            11   51   17    1    1    2     14   17   (284)
 *  rhs_jacobian        18   56   17    1    1    2     13   24   (349)
 *  divergence          3   10    3    1    1    0      8    6   (33)
 *  integral_values     3   15   10    0    1    2      8    9   (54)
 *  integral_gradients  2   26   12    1    1    2     10   11   (92)
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
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[5]/t1; /* I3/(m*R*R) */
    const double t3 = params[5]/params[4]; /* I3/I1 */
    const double t4 = 1.0/params[1]; /* 1/R */
    const double t5 = t1*params[4]; /* m*R*R*I1 */
    const double t6 = params[5]*params[5]; /* I3*I3 */
    const double t7 = t1*params[5]; /* m*R*R*I3 */
    const double t8 = t6 + t7; /* I3*I3 + m*R*R*I3 */
    const double t9 = t8/t5; /* (I3*I3 + m*R*R*I3)/(m*R*R*I1) */
    const double t10 = params[4] - params[5]; /* I1 - I3 */
    const double t11 = t10/params[4]; /* (I1 - I3)/I1 */
    const double t12 = params[1]*2.0; /* R*2 */
    const double t13 = -t3; /* -I3/I1 */
    const double t14 = t5*2.0; /* m*R*R*I1*2 */
    const double t15 = t7*2.0; /* m*R*R*I3*2 */
    const double t16 = t14 - t15; /* m*R*R*I1*2 - m*R*R*I3*2 */
    const double t17 = params[4]*params[4]; /* I1*I1 */
    const double t18 = t1*t17; /* m*R*R*I1*I1 */
    const double t19 = params[5]/t18; /* I3/(m*R*R*I1*I1) */
    const double t20 = params[0]*params[0]; /* m*m */
    const double t21 = t0*t0; /* R*R*R*R */
    const double t22 = t20*t21; /* m*m*R*R*R*R */
    const double t23 = t17*t22; /* I1*I1*m*m*R*R*R*R */
    const double t24 = t8/t23; /* (I3*I3 + m*R*R*I3)/(I1*I1*m*m*R*R*R*R) */
    const double t25 = params[1]*params[4]; /* R*I1 */
    const double t26 = params[5]/t25; /* I3/(R*I1) */
    const double t27 = -t26; /* -I3/(R*I1) */
    const double t28 = 1.0/t5; /* 1/(m*R*R*I1) */
    const double t29 = (-1.0)/params[1]; /* (-1)/R */
    const double t30 = t8*2.0; /* (I3*I3 + m*R*R*I3)*2 */
    const double t31 = t5 - t7; /* m*R*R*I1 - m*R*R*I3 */
    const double t32 = t30*t31; /* (I3*I3 + m*R*R*I3)*2*(m*R*R*I1 - m*R*R*I3) */
    const double t33 = t32/t23; /* (I3*I3 + m*R*R*I3)*2*(m*R*R*I1 - m*R*R*I3)/(I1*I1*m*m*R*R*R*R) */
    const double t34 = params[5]*2.0; /* I3*2 */
    const double t35 = t31*t34; /* (m*R*R*I1 - m*R*R*I3)*I3*2 */
    const double t36 = t35/t18; /* (m*R*R*I1 - m*R*R*I3)*I3*2/(m*R*R*I1*I1) */
    const double t37 = 2.0*t31; /* 2*(m*R*R*I1 - m*R*R*I3) */
    const double t38 = t37/t5; /* 2*(m*R*R*I1 - m*R*R*I3)/(m*R*R*I1) */
    const double t39 = params[0]/2.0; /* m/2 */
    const double t40 = params[4]/2.0; /* I1/2 */
    const double t41 = params[5]/2.0; /* I3/2 */
    const double t42 = t1/2.0; /* m*R*R/2 */
    const double t43 = params[1]*params[5]; /* R*I3 */
    const double t44 = params[0]*params[1]; /* m*R */
    const double t45 = -t25; /* -R*I1 */
    const double t46 = -t43; /* -R*I3 */
    const double t47 = -t44; /* -m*R */
    const double t48 = t1 + params[4]; /* m*R*R + I1 */
    const double t49 = t1 + params[5]; /* m*R*R + I3 */
    const double t50 = -params[4]; /* -I1 */
    out[6] = t2;
    out[7] = t3;
    out[8] = t4;
    out[9] = t9;
    out[10] = t11;
    out[11] = t12;
    out[12] = t13;
    out[13] = t16;
    out[14] = t19;
    out[15] = t24;
    out[16] = t27;
    out[17] = t28;
    out[18] = t29;
    out[19] = t33;
    out[20] = t36;
    out[21] = t38;
    out[22] = t26;
    out[23] = t39;
    out[24] = t40;
    out[25] = t41;
    out[26] = t42;
    out[27] = t25;
    out[28] = t43;
    out[29] = t1;
    out[30] = t44;
    out[31] = t45;
    out[32] = t46;
    out[33] = t47;
    out[34] = t48;
    out[35] = t49;
    out[36] = t50;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = p[1]*x[3]; /* R*omega_n */
    const double t6 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t7 = t2 + p[6]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t8 = JLT_FMA(x[0], t6, t7); /* Theta scaled = gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t9 = t3*t8; /* s*Theta scaled */
    const double t10 = 1.0/t9; /* 1/(s*Theta scaled) */
    const double t11 = x[3]*t8; /* omega_n*Theta scaled */
    const double t12 = t10*t11; /* 1/(s*Theta scaled)*omega_n*Theta scaled */
    const double t13 = x[0]*t12; /* gamma3*1/(s*Theta scaled)*omega_n*Theta scaled */
    const double t14 = x[4] + t13; /* omega3 + gamma3*1/(s*Theta scaled)*omega_n*Theta scaled */
    const double t15 = t5*t14; /* R*omega_n*(omega3 + gamma3*1/(s*Theta scaled)*omega_n*Theta scaled) */
    const double t16 = JLT_FMA(x[4], p[7], t13); /* omega3*I3/I1 + gamma3*1/(s*Theta scaled)*omega_n*Theta scaled */
    const double t17 = x[3]*t16; /* omega_n*t16 */
    const double t18 = -t17; /* -omega_n*t16 */
    const double t19 = JLT_FMA(p[8], x[1], x[2]); /* V scaled = 1/R*v_nu + omega_tau */
    const double t20 = t3*t10; /* s*1/(s*Theta scaled) */
    const double t21 = t19*t20; /* V scaled*s*1/(s*Theta scaled) */
    const double t22 = JLT_FNMA(p[7], t21, x[2]); /* omega_tau - I3/I1*V scaled*s*1/(s*Theta scaled) */
    const double t23 = t13*t22; /* gamma3*1/(s*Theta scaled)*omega_n*Theta scaled*(omega_tau - I3/I1*V scaled*s*1/(s*Theta scaled)) */
    const double t24 = x[2]*t20; /* omega_tau*s*1/(s*Theta scaled) */
    const double t25 = x[4]*p[9]; /* omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t26 = JLT_FMA(t24, t25, t23); /* omega_tau*s*1/(s*Theta scaled)*omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) + t23 */
    const double t27 = t3*x[4]; /* s*omega3 */
    const double t28 = x[0]*p[10]; /* gamma3*(I1 - I3)/I1 */
    const double t29 = t27*t28; /* s*omega3*gamma3*(I1 - I3)/I1 */
    const double t30 = t24*t29; /* omega_tau*s*1/(s*Theta scaled)*s*omega3*gamma3*(I1 - I3)/I1 */
    const double t31 = JLT_FNMA(x[3], t21, t30); /* omega_tau*s*1/(s*Theta scaled)*s*omega3*gamma3*(I1 - I3)/I1 - omega_n*V scaled*s*1/(s*Theta scaled) */
    const double t32 = -t12; /* -1/(s*Theta scaled)*omega_n*Theta scaled */
    const double t33 = cos(x[5]); /* C = cos(chi) */
    const double t34 = x[1]*t33; /* v_nu*C */
    const double t35 = sin(x[5]); /* S = sin(chi) */
    const double t36 = x[0]*t5; /* gamma3*R*omega_n */
    const double t37 = JLT_FMA(p[1], t27, t36); /* v_tau = R*s*omega3 + gamma3*R*omega_n */
    const double t38 = JLT_FMA(t35, t37, t34); /* S*v_tau + v_nu*C */
    const double t39 = x[1]*t35; /* v_nu*S */
    const double t40 = JLT_FNMA(t33, t37, t39); /* v_nu*S - C*v_tau */
    out[0] = t4;
    out[1] = t15;
    out[2] = t18;
    out[3] = t26;
    out[4] = t31;
    out[5] = t32;
    out[6] = t14;
    out[7] = t38;
    out[8] = t40;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t4 = p[6] + t2; /* I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta scaled = gamma3*gamma3*I3/I1 + I3/(m*R^2) + (1 - gamma3)*(gamma3 + 1) */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t7 = t5*t6; /* Theta scaled*s */
    const double t8 = 1.0/t7; /* 1/(Theta scaled*s) */
    const double t9 = t5*t8; /* Theta scaled*1/(Theta scaled*s) */
    const double t10 = x[0]*t9; /* gamma3*Theta scaled*1/(Theta scaled*s) */
    const double t11 = x[2]*t10; /* omega_tau*gamma3*Theta scaled*1/(Theta scaled*s) */
    const double t12 = -t11; /* -omega_tau*gamma3*Theta scaled*1/(Theta scaled*s) */
    const double t13 = p[1]*x[3]; /* R*omega_n */
    const double t14 = t9*t9; /* Theta scaled*1/(Theta scaled*s)*Theta scaled*1/(Theta scaled*s) */
    const double t15 = t9*x[3]; /* Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t16 = t14*t15; /* t14*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t17 = t13*t16; /* R*omega_n*t14*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t18 = p[1]*x[4]; /* R*omega3 */
    const double t19 = t10*x[3]; /* gamma3*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t20 = JLT_FMA(p[11], t19, t18); /* 2*R*gamma3*Theta scaled*1/(Theta scaled*s)*omega_n + R*omega3 */
    const double t21 = x[3]*t16; /* omega_n*t14*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t22 = -t21; /* -omega_n*t14*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t23 = t19*(-2.0); /* gamma3*Theta scaled*1/(Theta scaled*s)*omega_n*(-2) */
    const double t24 = JLT_FMA(x[4], p[12], t23); /* omega3*(-I3/I1) + gamma3*Theta scaled*1/(Theta scaled*s)*omega_n*(-2) */
    const double t25 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    const double t26 = x[0]*p[13]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3) */
    const double t27 = JLT_FMA(p[8], x[1], x[2]); /* V scaled = 1/R*v_nu + omega_tau */
    const double t28 = t6*t8; /* s*1/(Theta scaled*s) */
    const double t29 = t27*t28; /* V scaled*s*1/(Theta scaled*s) */
    const double t30 = t19*t28; /* gamma3*Theta scaled*1/(Theta scaled*s)*omega_n*s*1/(Theta scaled*s) */
    const double t31 = p[14]*t29; /* I3/(m*R^2*I1^2)*V scaled*s*1/(Theta scaled*s) */
    const double t32 = t30*t31; /* t30*I3/(m*R^2*I1^2)*V scaled*s*1/(Theta scaled*s) */
    const double t33 = x[4]*t28; /* omega3*s*1/(Theta scaled*s) */
    const double t34 = x[2]*t28; /* omega_tau*s*1/(Theta scaled*s) */
    const double t35 = p[15]*t33; /* (I3^2 + m*R^2*I3)/(m^2*R^4*I1^2)*omega3*s*1/(Theta scaled*s) */
    const double t36 = JLT_FNMA(t34, t35, t32); /* t30*I3/(m*R^2*I1^2)*V scaled*s*1/(Theta scaled*s) - omega_tau*s*1/(Theta scaled*s)*(I3^2 + m*R^2*I3)/(m^2*R^4*I1^2)*omega3*s*1/(Theta scaled*s) */
    const double t37 = t26*t36; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*t36 */
    const double t38 = JLT_FNMA(p[7], t29, x[2]); /* omega_tau - I3/I1*V scaled*s*1/(Theta scaled*s) */
    const double t39 = JLT_FMS(t16, t38, t37); /* t14*Theta scaled*1/(Theta scaled*s)*omega_n*(omega_tau - I3/I1*V scaled*s*1/(Theta scaled*s)) - gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*t36 */
    const double t40 = t30*p[16]; /* t30*(-I3/(R*I1)) */
    const double t41 = JLT_FMA(t33, p[9], t19); /* omega3*s*1/(Theta scaled*s)*(I3^2 + m*R^2*I3)/(m*R^2*I1) + gamma3*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t42 = JLT_FNMA(p[7], t30, t41); /* t41 - I3/I1*t30 */
    const double t43 = t10*t38; /* gamma3*Theta scaled*1/(Theta scaled*s)*(omega_tau - I3/I1*V scaled*s*1/(Theta scaled*s)) */
    const double t44 = t34*p[9]; /* omega_tau*s*1/(Theta scaled*s)*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t45 = x[0]*t6; /* gamma3*s */
    const double t46 = t34*t45; /* omega_tau*s*1/(Theta scaled*s)*gamma3*s */
    const double t47 = t33*p[10]; /* omega3*s*1/(Theta scaled*s)*(I1 - I3)/I1 */
    const double t48 = t46*t47; /* omega_tau*s*1/(Theta scaled*s)*gamma3*s*omega3*s*1/(Theta scaled*s)*(I1 - I3)/I1 */
    const double t49 = x[3]*t28; /* omega_n*s*1/(Theta scaled*s) */
    const double t50 = JLT_FNMA(t29, t49, t48); /* t48 - V scaled*s*1/(Theta scaled*s)*omega_n*s*1/(Theta scaled*s) */
    const double t51 = t26*p[17]; /* gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*1/(m*R^2*I1) */
    const double t52 = t50*t51; /* t50*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*1/(m*R^2*I1) */
    const double t53 = JLT_FMS(x[0], t10, t6); /* gamma3*gamma3*Theta scaled*1/(Theta scaled*s) - s */
    const double t54 = x[2]*t47; /* omega_tau*omega3*s*1/(Theta scaled*s)*(I1 - I3)/I1 */
    const double t55 = JLT_FNMA(t53, t54, t52); /* t50*gamma3*(2*m*R^2*I1 - 2*m*R^2*I3)*1/(m*R^2*I1) - (gamma3*gamma3*Theta scaled*1/(Theta scaled*s) - s)*omega_tau*omega3*s*1/(Theta scaled*s)*(I1 - I3)/I1 */
    const double t56 = t49*p[18]; /* omega_n*s*1/(Theta scaled*s)*(-1/R) */
    const double t57 = JLT_FMS(t45, t47, t49); /* gamma3*s*omega3*s*1/(Theta scaled*s)*(I1 - I3)/I1 - omega_n*s*1/(Theta scaled*s) */
    const double t58 = -t29; /* -V scaled*s*1/(Theta scaled*s) */
    const double t59 = t46*p[10]; /* omega_tau*s*1/(Theta scaled*s)*gamma3*s*(I1 - I3)/I1 */
    const double t60 = t14*t19; /* t14*gamma3*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t61 = -t60; /* -t14*gamma3*Theta scaled*1/(Theta scaled*s)*omega_n */
    const double t62 = -t9; /* -Theta scaled*1/(Theta scaled*s) */
    const double t63 = sin(x[5]); /* S = sin(chi) */
    const double t64 = JLT_FNMA(t10, t18, t13); /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*Theta scaled*1/(Theta scaled*s)*R*omega3 */
    const double t65 = t63*t64; /* S*d(v_tau)/d(gamma3) */
    const double t66 = cos(x[5]); /* C = cos(chi) */
    const double t67 = x[0]*p[1]; /* gamma3*R */
    const double t68 = t63*t67; /* S*gamma3*R */
    const double t69 = t6*p[1]; /* s*R */
    const double t70 = t63*t69; /* S*s*R */
    const double t71 = x[1]*t63; /* v_nu*S */
    const double t72 = x[4]*t69; /* omega3*s*R */
    const double t73 = JLT_FMA(x[0], t13, t72); /* v_tau = gamma3*R*omega_n + omega3*s*R */
    const double t74 = JLT_FMS(t66, t73, t71); /* C*v_tau - v_nu*S */
    const double t75 = t64*t66; /* d(v_tau)/d(gamma3)*C */
    const double t76 = -t75; /* -d(v_tau)/d(gamma3)*C */
    const double t77 = t66*t67; /* C*gamma3*R */
    const double t78 = -t77; /* -C*gamma3*R */
    const double t79 = t66*t69; /* C*s*R */
    const double t80 = -t79; /* -C*s*R */
    const double t81 = x[1]*t66; /* v_nu*C */
    const double t82 = JLT_FMA(t63, t73, t81); /* S*v_tau + v_nu*C */
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
    out[27] = t39;
    out[28] = t40;
    out[29] = t42;
    out[30] = t43;
    out[31] = t44;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t55;
    out[37] = t56;
    out[38] = t57;
    out[39] = t58;
    out[40] = t59;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t61;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = t62;
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
    out[63] = t65;
    out[64] = t66;
    out[65] = 0.0;
    out[66] = t68;
    out[67] = t70;
    out[68] = t74;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t76;
    out[73] = t63;
    out[74] = 0.0;
    out[75] = t78;
    out[76] = t80;
    out[77] = t82;
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
    const double t5 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t6 = t2 + p[6]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta scaled = gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t8 = t3*t7; /* s*Theta scaled */
    const double t9 = 1.0/t8; /* 1/(s*Theta scaled) */
    const double t10 = t7*t9; /* Theta scaled*1/(s*Theta scaled) */
    const double t11 = x[0]*t10; /* gamma3*Theta scaled*1/(s*Theta scaled) */
    const double t12 = x[3]*t11; /* omega_n*gamma3*Theta scaled*1/(s*Theta scaled) */
    const double t13 = x[4] + t12; /* omega3 + omega_n*gamma3*Theta scaled*1/(s*Theta scaled) */
    const double t14 = x[3]*p[1]; /* omega_n*R */
    const double t15 = t13*t14; /* (omega3 + omega_n*gamma3*Theta scaled*1/(s*Theta scaled))*omega_n*R */
    const double t16 = x[4]*p[7]; /* omega3*I3/I1 */
    const double t17 = t12 + t16; /* omega_n*gamma3*Theta scaled*1/(s*Theta scaled) + omega3*I3/I1 */
    const double t18 = x[3]*t17; /* omega_n*t17 */
    const double t19 = -t18; /* -omega_n*t17 */
    const double t20 = JLT_FMA(p[8], x[1], x[2]); /* V scaled = 1/R*v_nu + omega_tau */
    const double t21 = t3*t9; /* s*1/(s*Theta scaled) */
    const double t22 = t20*t21; /* V scaled*s*1/(s*Theta scaled) */
    const double t23 = JLT_FNMA(p[7], t22, x[2]); /* omega_tau - I3/I1*V scaled*s*1/(s*Theta scaled) */
    const double t24 = t12*t23; /* omega_n*gamma3*Theta scaled*1/(s*Theta scaled)*(omega_tau - I3/I1*V scaled*s*1/(s*Theta scaled)) */
    const double t25 = x[4]*t21; /* omega3*s*1/(s*Theta scaled) */
    const double t26 = x[2]*t25; /* omega_tau*omega3*s*1/(s*Theta scaled) */
    const double t27 = JLT_FMA(p[9], t26, t24); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*omega3*s*1/(s*Theta scaled) + t24 */
    const double t28 = x[0]*p[10]; /* gamma3*(I1 - I3)/I1 */
    const double t29 = t3*t28; /* s*gamma3*(I1 - I3)/I1 */
    const double t30 = x[2]*t21; /* omega_tau*s*1/(s*Theta scaled) */
    const double t31 = t29*t30; /* s*gamma3*(I1 - I3)/I1*omega_tau*s*1/(s*Theta scaled) */
    const double t32 = x[4]*t31; /* omega3*s*gamma3*(I1 - I3)/I1*omega_tau*s*1/(s*Theta scaled) */
    const double t33 = JLT_FNMA(x[3], t22, t32); /* omega3*s*gamma3*(I1 - I3)/I1*omega_tau*s*1/(s*Theta scaled) - omega_n*V scaled*s*1/(s*Theta scaled) */
    const double t34 = x[3]*t10; /* omega_n*Theta scaled*1/(s*Theta scaled) */
    const double t35 = -t34; /* -omega_n*Theta scaled*1/(s*Theta scaled) */
    const double t36 = cos(x[5]); /* C = cos(chi) */
    const double t37 = x[1]*t36; /* v_nu*C */
    const double t38 = sin(x[5]); /* S = sin(chi) */
    const double t39 = x[4]*p[1]; /* omega3*R */
    const double t40 = t3*t39; /* s*omega3*R */
    const double t41 = JLT_FMA(x[0], t14, t40); /* v_tau = gamma3*omega_n*R + s*omega3*R */
    const double t42 = JLT_FMA(t38, t41, t37); /* S*v_tau + v_nu*C */
    const double t43 = x[1]*t38; /* v_nu*S */
    const double t44 = t36*t41; /* C*v_tau */
    const double t45 = t43 - t44; /* v_nu*S - C*v_tau */
    const double t46 = x[2]*t11; /* omega_tau*gamma3*Theta scaled*1/(s*Theta scaled) */
    const double t47 = -t46; /* -omega_tau*gamma3*Theta scaled*1/(s*Theta scaled) */
    const double t48 = t10*t10; /* Theta scaled*1/(s*Theta scaled)*Theta scaled*1/(s*Theta scaled) */
    const double t49 = t34*t48; /* omega_n*Theta scaled*1/(s*Theta scaled)*t48 */
    const double t50 = t14*t49; /* omega_n*R*omega_n*Theta scaled*1/(s*Theta scaled)*t48 */
    const double t51 = JLT_FMA(t12, p[11], t39); /* omega_n*gamma3*Theta scaled*1/(s*Theta scaled)*2*R + omega3*R */
    const double t52 = x[3]*t49; /* omega_n*omega_n*Theta scaled*1/(s*Theta scaled)*t48 */
    const double t53 = -t52; /* -omega_n*omega_n*Theta scaled*1/(s*Theta scaled)*t48 */
    const double t54 = JLT_FMA(t12, 2.0, t16); /* omega_n*gamma3*Theta scaled*1/(s*Theta scaled)*2 + omega3*I3/I1 */
    const double t55 = -t54; /* -t54 */
    const double t56 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    const double t57 = x[0]*t21; /* gamma3*s*1/(s*Theta scaled) */
    const double t58 = p[19]*t57; /* 2*(I3^2 + m*R^2*I3)*(m*R^2*I1 - m*R^2*I3)/(m^2*R^4*I1^2)*gamma3*s*1/(s*Theta scaled) */
    const double t59 = t26*t58; /* omega_tau*omega3*s*1/(s*Theta scaled)*t58 */
    const double t60 = t57*p[20]; /* gamma3*s*1/(s*Theta scaled)*2*I3*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1^2) */
    const double t61 = t22*t60; /* V scaled*s*1/(s*Theta scaled)*t60 */
    const double t62 = JLT_FNMA(t12, t61, t59); /* omega_tau*omega3*s*1/(s*Theta scaled)*t58 - omega_n*gamma3*Theta scaled*1/(s*Theta scaled)*V scaled*s*1/(s*Theta scaled)*t60 */
    const double t63 = JLT_FMA(t23, t49, t62); /* (omega_tau - I3/I1*V scaled*s*1/(s*Theta scaled))*omega_n*Theta scaled*1/(s*Theta scaled)*t48 + t62 */
    const double t64 = t12*t21; /* omega_n*gamma3*Theta scaled*1/(s*Theta scaled)*s*1/(s*Theta scaled) */
    const double t65 = p[16]*t64; /* (-I3/(R*I1))*t64 */
    const double t66 = JLT_FMA(p[9], t25, t12); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega3*s*1/(s*Theta scaled) + omega_n*gamma3*Theta scaled*1/(s*Theta scaled) */
    const double t67 = JLT_FNMA(p[7], t64, t66); /* t66 - I3/I1*t64 */
    const double t68 = t11*t23; /* gamma3*Theta scaled*1/(s*Theta scaled)*(omega_tau - I3/I1*V scaled*s*1/(s*Theta scaled)) */
    const double t69 = p[9]*t30; /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*omega_tau*s*1/(s*Theta scaled) */
    const double t70 = t57*p[21]; /* gamma3*s*1/(s*Theta scaled)*2*(m*R^2*I1 - m*R^2*I3)/(m*R^2*I1) */
    const double t71 = t33*t70; /* t33*t70 */
    const double t72 = JLT_FMS(x[0], t11, t3); /* gamma3*gamma3*Theta scaled*1/(s*Theta scaled) - s */
    const double t73 = t26*p[10]; /* omega_tau*omega3*s*1/(s*Theta scaled)*(I1 - I3)/I1 */
    const double t74 = JLT_FNMA(t72, t73, t71); /* t33*t70 - (gamma3*gamma3*Theta scaled*1/(s*Theta scaled) - s)*omega_tau*omega3*s*1/(s*Theta scaled)*(I1 - I3)/I1 */
    const double t75 = x[3]*t21; /* omega_n*s*1/(s*Theta scaled) */
    const double t76 = p[18]*t75; /* (-1/R)*omega_n*s*1/(s*Theta scaled) */
    const double t77 = JLT_FMS(t25, t29, t75); /* omega3*s*1/(s*Theta scaled)*s*gamma3*(I1 - I3)/I1 - omega_n*s*1/(s*Theta scaled) */
    const double t78 = -t22; /* -V scaled*s*1/(s*Theta scaled) */
    const double t79 = t12*t48; /* omega_n*gamma3*Theta scaled*1/(s*Theta scaled)*t48 */
    const double t80 = -t79; /* -omega_n*gamma3*Theta scaled*1/(s*Theta scaled)*t48 */
    const double t81 = -t10; /* -Theta scaled*1/(s*Theta scaled) */
    const double t82 = JLT_FNMA(t11, t39, t14); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*Theta scaled*1/(s*Theta scaled)*omega3*R */
    const double t83 = t38*t82; /* S*d(v_tau)/d(gamma3) */
    const double t84 = p[1]*t38; /* R*S */
    const double t85 = x[0]*t84; /* gamma3*R*S */
    const double t86 = t3*t84; /* s*R*S */
    const double t87 = t44 - t43; /* C*v_tau - v_nu*S */
    const double t88 = t36*t82; /* C*d(v_tau)/d(gamma3) */
    const double t89 = -t88; /* -C*d(v_tau)/d(gamma3) */
    const double t90 = p[1]*t36; /* R*C */
    const double t91 = x[0]*t90; /* gamma3*R*C */
    const double t92 = -t91; /* -gamma3*R*C */
    const double t93 = t3*t90; /* s*R*C */
    const double t94 = -t93; /* -s*R*C */
    out[0] = t4;
    out[1] = t15;
    out[2] = t19;
    out[3] = t27;
    out[4] = t33;
    out[5] = t35;
    out[6] = t13;
    out[7] = t42;
    out[8] = t45;
    out[9] = t47;
    out[10] = 0.0;
    out[11] = t3;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t50;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = t51;
    out[22] = t14;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t53;
    out[28] = 0.0;
    out[29] = 0.0;
    out[30] = t55;
    out[31] = t56;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t63;
    out[37] = t65;
    out[38] = t67;
    out[39] = t68;
    out[40] = t69;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t74;
    out[46] = t76;
    out[47] = t77;
    out[48] = t78;
    out[49] = t31;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[54] = t80;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t81;
    out[58] = 0.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = t49;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = t11;
    out[67] = 1.0;
    out[68] = 0.0;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t83;
    out[73] = t36;
    out[74] = 0.0;
    out[75] = t85;
    out[76] = t86;
    out[77] = t87;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[81] = t89;
    out[82] = t38;
    out[83] = 0.0;
    out[84] = t92;
    out[85] = t94;
    out[86] = t42;
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
    const double t4 = p[10]*x[2]; /* (I1 - I3)/I1*omega_tau */
    const double t5 = t3*t4; /* s*(I1 - I3)/I1*omega_tau */
    const double t6 = x[0]*p[7]; /* gamma3*I3/I1 */
    const double t7 = t2 + p[6]; /* (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t8 = JLT_FMA(x[0], t6, t7); /* Theta scaled = gamma3*gamma3*I3/I1 + (1 - gamma3)*(gamma3 + 1) + I3/(m*R^2) */
    const double t9 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t10 = t3*t8; /* s*Theta scaled */
    const double t11 = 1.0/t10; /* 1/(s*Theta scaled) */
    const double t12 = p[22]*t9; /* I3/(R*I1)*V */
    const double t13 = t8*t12; /* Theta scaled*I3/(R*I1)*V */
    const double t14 = JLT_FNMA(t11, t13, t5); /* s*(I1 - I3)/I1*omega_tau - 1/(s*Theta scaled)*Theta scaled*I3/(R*I1)*V */
    const double t15 = x[0]*t3; /* gamma3*s */
    const double t16 = t11*t15; /* 1/(s*Theta scaled)*gamma3*s */
    const double t17 = t14*t16; /* t14*1/(s*Theta scaled)*gamma3*s */
    out[0] = t17;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[23]*x[1]; /* 1/2*m*v_nu */
    const double t1 = x[1]*t0; /* v_nu*1/2*m*v_nu */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = JLT_FMA(x[2], x[2], t2); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t4 = p[25]*x[4]; /* 1/2*I3*omega3 */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t7 = t5*t6; /* (1 - gamma3)*(1 + gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t9 = x[4]*t8; /* omega3*s */
    const double t10 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t11 = t9 + t10; /* v_tau scaled = omega3*s + omega_n*gamma3 */
    const double t12 = p[26]*t11; /* 1/2*m*R^2*v_tau scaled */
    const double t13 = JLT_FMA(x[4], t4, t1); /* omega3*1/2*I3*omega3 + v_nu*1/2*m*v_nu */
    const double t14 = JLT_FMA(p[24], t3, t13); /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) + omega3*1/2*I3*omega3 + v_nu*1/2*m*v_nu */
    const double t15 = JLT_FMA(t11, t12, t14); /* v_tau scaled*1/2*m*R^2*v_tau scaled + t14 */
    const double t16 = x[3]*p[27]; /* omega_n*R*I1 */
    const double t17 = t8*t16; /* s*omega_n*R*I1 */
    const double t18 = x[4]*p[28]; /* omega3*R*I3 */
    const double t19 = JLT_FNMA(x[0], t18, t17); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    const double t20 = cos(x[5]); /* C = cos(chi) */
    const double t21 = t10*p[4]; /* omega_n*gamma3*I1 */
    const double t22 = JLT_FMA(t9, p[5], t21); /* omega3*s*I3 + omega_n*gamma3*I1 */
    const double t23 = JLT_FMA(t11, p[29], t22); /* M_nu = v_tau scaled*m*R^2 + omega3*s*I3 + omega_n*gamma3*I1 */
    const double t24 = t20*t23; /* C*M_nu */
    const double t25 = sin(x[5]); /* S = sin(chi) */
    const double t26 = x[2]*p[4]; /* omega_tau*I1 */
    const double t27 = JLT_FNMA(x[1], p[30], t26); /* M_tau = omega_tau*I1 - v_nu*m*R */
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
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = x[0]/t3; /* gamma3/s */
    const double t5 = JLT_FNMA(x[4], t4, x[3]); /* d(v_tau)/d(gamma3) scaled = omega_n - omega3*gamma3/s */
    const double t6 = x[4]*t3; /* omega3*s */
    const double t7 = JLT_FMA(x[3], x[0], t6); /* v_tau scaled = omega_n*gamma3 + omega3*s */
    const double t8 = p[29]*t7; /* m*R^2*v_tau scaled */
    const double t9 = t5*t8; /* d(v_tau)/d(gamma3) scaled*m*R^2*v_tau scaled */
    const double t10 = p[0]*x[1]; /* m*v_nu */
    const double t11 = p[4]*x[2]; /* I1*omega_tau */
    const double t12 = x[3]*p[4]; /* omega_n*I1 */
    const double t13 = JLT_FMA(x[0], t8, t12); /* gamma3*m*R^2*v_tau scaled + omega_n*I1 */
    const double t14 = x[4]*p[5]; /* omega3*I3 */
    const double t15 = JLT_FMA(t3, t8, t14); /* s*m*R^2*v_tau scaled + omega3*I3 */
    const double t16 = x[3]*p[31]; /* omega_n*(-R*I1) */
    const double t17 = t4*t16; /* gamma3/s*omega_n*(-R*I1) */
    const double t18 = JLT_FMA(x[4], p[32], t17); /* omega3*(-R*I3) + gamma3/s*omega_n*(-R*I1) */
    const double t19 = t3*p[27]; /* s*R*I1 */
    const double t20 = x[0]*p[32]; /* gamma3*(-R*I3) */
    const double t21 = cos(x[5]); /* C = cos(chi) */
    const double t22 = JLT_FNMA(t4, t14, t12); /* omega_n*I1 - gamma3/s*omega3*I3 */
    const double t23 = JLT_FMA(t5, p[29], t22); /* d(M_nu)/d(gamma3) = d(v_tau)/d(gamma3) scaled*m*R^2 + omega_n*I1 - gamma3/s*omega3*I3 */
    const double t24 = t21*t23; /* C*d(M_nu)/d(gamma3) */
    const double t25 = sin(x[5]); /* S = sin(chi) */
    const double t26 = p[33]*t25; /* (-m*R)*S */
    const double t27 = p[4]*t25; /* I1*S */
    const double t28 = x[0]*p[34]; /* d(M_nu)/d(omega_n) = gamma3*(I1 + m*R^2) */
    const double t29 = t21*t28; /* C*d(M_nu)/d(omega_n) */
    const double t30 = t3*p[35]; /* d(M_nu)/d(omega3) = s*(I3 + m*R^2) */
    const double t31 = t21*t30; /* C*d(M_nu)/d(omega3) */
    const double t32 = JLT_FMA(x[0], t12, t8); /* gamma3*omega_n*I1 + m*R^2*v_tau scaled */
    const double t33 = JLT_FMA(t3, t14, t32); /* M_nu = s*omega3*I3 + gamma3*omega_n*I1 + m*R^2*v_tau scaled */
    const double t34 = t25*t33; /* S*M_nu */
    const double t35 = JLT_FNMA(x[1], p[30], t11); /* M_tau = I1*omega_tau - v_nu*m*R */
    const double t36 = JLT_FMS(t21, t35, t34); /* C*M_tau - S*M_nu */
    const double t37 = t23*t25; /* d(M_nu)/d(gamma3)*S */
    const double t38 = t21*p[30]; /* C*m*R */
    const double t39 = t21*p[36]; /* C*(-I1) */
    const double t40 = t25*t28; /* S*d(M_nu)/d(omega_n) */
    const double t41 = t25*t30; /* S*d(M_nu)/d(omega3) */
    const double t42 = t21*t33; /* C*M_nu */
    const double t43 = JLT_FMA(t25, t35, t42); /* S*M_tau + C*M_nu */
    out[0] = t9;
    out[1] = t10;
    out[2] = t11;
    out[3] = t13;
    out[4] = t15;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t18;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t19;
    out[13] = t20;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t24;
    out[19] = t26;
    out[20] = t27;
    out[21] = t29;
    out[22] = t31;
    out[23] = t36;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t37;
    out[28] = t38;
    out[29] = t39;
    out[30] = t40;
    out[31] = t41;
    out[32] = t43;
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
    double t10[JLT_JET_ORDER_MAX + 1];
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
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double u46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double u48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
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
        t10[k] = p[1]*x3[k];
        t14[k] = x0[k]*p[7];
        t15[k] = t5[k] + (k == 0 ? p[6] : 0);
        t16[k] = jlt_jet_product(x0, t14, k) + t15[k];
        t17[k] = jlt_jet_product(t6, t16, k);
        t18[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t17, t18, k);
        t19[k] = jlt_jet_product(x3, t16, k);
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = jlt_jet_product(x0, t20, k);
        t22[k] = x4[k] + t21[k];
        t23[k] = jlt_jet_product(t10, t22, k);
        t24[k] = x4[k]*p[7] + t21[k];
        t25[k] = jlt_jet_product(x3, t24, k);
        t26[k] = -t25[k];
        t29[k] = p[8]*x1[k] + x2[k];
        t30[k] = jlt_jet_product(t6, t18, k);
        t31[k] = jlt_jet_product(t29, t30, k);
        t32[k] = x2[k] - p[7]*t31[k];
        t33[k] = jlt_jet_product(t21, t32, k);
        t35[k] = jlt_jet_product(x2, t30, k);
        t36[k] = x4[k]*p[9];
        t37[k] = jlt_jet_product(t35, t36, k) + t33[k];
        t39[k] = jlt_jet_product(t6, x4, k);
        t40[k] = x0[k]*p[10];
        t41[k] = jlt_jet_product(t39, t40, k);
        t42[k] = jlt_jet_product(t35, t41, k);
        t43[k] = t42[k] - jlt_jet_product(x3, t31, k);
        t44[k] = -t20[k];
        t46[k] = jlt_jet_cosine(x5, t46, u46, k);
        t47[k] = jlt_jet_product(x1, t46, k);
        t48[k] = jlt_jet_sine(x5, t48, u48, k);
        t49[k] = jlt_jet_product(x0, t10, k);
        t50[k] = p[1]*t39[k] + t49[k];
        t51[k] = jlt_jet_product(t48, t50, k) + t47[k];
        t52[k] = jlt_jet_product(x1, t48, k);
        t53[k] = t52[k] - jlt_jet_product(t46, t50, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t23[k]/(k + 1);
        next[2] = x2[k + 1] = t26[k]/(k + 1);
        next[3] = x3[k + 1] = t37[k]/(k + 1);
        next[4] = x4[k + 1] = t43[k]/(k + 1);
        next[5] = x5[k + 1] = t44[k]/(k + 1);
        next[6] = x6[k + 1] = t22[k]/(k + 1);
        next[7] = x7[k + 1] = t51[k]/(k + 1);
        next[8] = x8[k + 1] = t53[k]/(k + 1);
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
    .state_count = 9, .param_count = 6, .block_count = 37,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 9, { 6, 22, 9, 1, 1, 2, 11, 8 }, { 17, 59, 0, 11, 1, 2, 11, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 81, { 11, 51, 17, 1, 1, 2, 14, 17 }, { 45, 196, 0, 40, 1, 2, 14, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 90, { 18, 56, 17, 1, 1, 2, 13, 24 }, { 57, 238, 0, 51, 1, 2, 14, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 3, 10, 3, 1, 1, 0, 8, 6 }, { 6, 24, 0, 2, 1, 0, 10, 6 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 4, { 3, 15, 10, 0, 1, 2, 8, 9 }, { 12, 39, 0, 0, 1, 2, 10, 7 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 36, { 2, 26, 12, 1, 1, 2, 10, 11 }, { 19, 67, 0, 3, 1, 2, 9, 10 },
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
