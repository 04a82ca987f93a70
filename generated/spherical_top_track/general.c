/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 7   28   16    1    1    2     12   14   (116)
 *  jacobian            15   66   34    1    1    2     17   24   (415)
 *  rhs_jacobian        20   73   37    1    1    2     15   36   (500)
 *  divergence          2   14    9    1    1    0     12   10   (54)
 *  integral_values     2   12    9    0    1    0      6    9   (43)
 *  integral_gradients  2   15    9    1    1    0      6   10   (53)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_track[];
extern const jlt_descriptor jlt_kernels_spherical_top_track_general;
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
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = params[5]/t4; /* I3/(m*R*R) */
    const double t6 = params[4]*t3; /* I1*R*R */
    const double t7 = params[5]/t6; /* I3/(I1*R*R) */
    const double t8 = params[0]*params[2]; /* m*g */
    const double t9 = params[3]*t8; /* a3*m*g */
    const double t10 = t9/params[4]; /* a3*m*g/I1 */
    const double t11 = params[5]/params[4]; /* I3/I1 */
    const double t12 = params[4]*params[1]; /* I1*R */
    const double t13 = params[5]/t12; /* I3/(I1*R) */
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = params[5]/t14; /* I3/(m*R) */
    const double t16 = 1.0/params[1]; /* 1/R */
    const double t17 = params[3]*params[5]; /* a3*I3 */
    const double t18 = t17/t12; /* a3*I3/(I1*R) */
    const double t19 = params[4] - params[5]; /* I1 - I3 */
    const double t20 = t19/params[4]; /* (I1 - I3)/I1 */
    const double t21 = params[4]*params[5]; /* I1*I3 */
    const double t22 = params[4]*t4; /* I1*m*R*R */
    const double t23 = params[0]*params[5]; /* m*I3 */
    const double t24 = -params[4]; /* -I1 */
    const double t25 = params[0]*2.0; /* m*2 */
    const double t26 = t0*t25; /* a3*a3*m*2 */
    const double t27 = params[5]*2.0; /* I3*2 */
    const double t28 = params[0]*(-2.0); /* m*(-2) */
    const double t29 = t0*t28; /* a3*a3*m*(-2) */
    const double t30 = params[4]*t29; /* I1*a3*a3*m*(-2) */
    const double t31 = params[4]*2.0; /* I1*2 */
    const double t32 = t3*t25; /* R*R*m*2 */
    const double t33 = params[4]*t32; /* I1*R*R*m*2 */
    const double t34 = params[1]*t25; /* R*m*2 */
    const double t35 = params[5]*t34; /* I3*R*m*2 */
    const double t36 = params[5]*t14; /* I3*m*R */
    const double t37 = params[3]*t14; /* a3*m*R */
    const double t38 = params[5]*t37; /* I3*a3*m*R */
    const double t39 = params[5]*params[5]; /* I3*I3 */
    const double t40 = params[4]*t14; /* I1*m*R */
    const double t41 = t4*t19; /* m*R*R*(I1 - I3) */
    const double t42 = -t40; /* -I1*m*R */
    const double t43 = t26/params[4]; /* a3*a3*m*2/I1 */
    const double t44 = params[5]/t31; /* I3/(I1*2) */
    const double t45 = -params[5]; /* -I3 */
    const double t46 = -t11; /* -I3/I1 */
    const double t47 = t27/t6; /* I3*2/(I1*R*R) */
    const double t48 = t17/t6; /* a3*I3/(I1*R*R) */
    const double t49 = t27/t12; /* I3*2/(I1*R) */
    const double t50 = params[3]/2.0; /* a3/2 */
    const double t51 = 2.0/params[1]; /* 2/R */
    const double t52 = params[3]*2.0; /* a3*2 */
    const double t53 = params[5]*t52; /* I3*a3*2 */
    const double t54 = t53/t12; /* I3*a3*2/(I1*R) */
    const double t55 = t19*2.0; /* (I1 - I3)*2 */
    const double t56 = t55/params[4]; /* (I1 - I3)*2/I1 */
    const double t57 = (-1.0)/params[1]; /* (-1)/R */
    const double t58 = params[0]/2.0; /* m/2 */
    const double t59 = params[4]/2.0; /* I1/2 */
    const double t60 = params[5]/2.0; /* I3/2 */
    const double t61 = -t12; /* -I1*R */
    const double t62 = params[1]*params[5]; /* R*I3 */
    const double t63 = -t62; /* -R*I3 */
    out[6] = t2;
    out[7] = t5;
    out[8] = t7;
    out[9] = t10;
    out[10] = t11;
    out[11] = t13;
    out[12] = t15;
    out[13] = t16;
    out[14] = t18;
    out[15] = t20;
    out[16] = t1;
    out[17] = t21;
    out[18] = t22;
    out[19] = t23;
    out[20] = t24;
    out[21] = t26;
    out[22] = t27;
    out[23] = t30;
    out[24] = t31;
    out[25] = t33;
    out[26] = t35;
    out[27] = t36;
    out[28] = t38;
    out[29] = t39;
    out[30] = t40;
    out[31] = t41;
    out[32] = t42;
    out[33] = t43;
    out[34] = t44;
    out[35] = t46;
    out[36] = t47;
    out[37] = t48;
    out[38] = t49;
    out[39] = t50;
    out[40] = t51;
    out[41] = t54;
    out[42] = t56;
    out[43] = t57;
    out[44] = t9;
    out[45] = t58;
    out[46] = t59;
    out[47] = t60;
    out[48] = t12;
    out[49] = t14;
    out[50] = t61;
    out[51] = t63;
    out[52] = t45;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[6], 1.0); /* D scaled = (1 - gamma3)*(1 + gamma3)*m*a3^2/I1 + 1 */
    const double t7 = t5*p[8]; /* b*I3/(R^2*I1) */
    const double t8 = t2 + p[7]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t9 = JLT_FMA(t5, t7, t8); /* Theta scaled = b*b*I3/(R^2*I1) + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t10 = t3*t6; /* s*D scaled */
    const double t11 = t9*t10; /* Theta scaled*s*D scaled */
    const double t12 = 1.0/t11; /* 1/(Theta scaled*s*D scaled) */
    const double t13 = t9*t12; /* Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t14 = x[3]*t6; /* omega_n*D scaled */
    const double t15 = t13*t14; /* Theta scaled*1/(Theta scaled*s*D scaled)*omega_n*D scaled */
    const double t16 = p[1]*x[4]; /* R*omega3 */
    const double t17 = JLT_FMA(t5, t15, t16); /* b*Theta scaled*1/(Theta scaled*s*D scaled)*omega_n*D scaled + R*omega3 */
    const double t18 = x[3]*t17; /* omega_n*t17 */
    const double t19 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t20 = p[6]*t19; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t21 = t4*t20; /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t22 = x[0]*t15; /* gamma3*Theta scaled*1/(Theta scaled*s*D scaled)*omega_n*D scaled */
    const double t23 = JLT_FMA(x[4], p[10], t22); /* omega3*I3/I1 + t22 */
    const double t24 = JLT_FNMA(t3, p[9], t21); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - s*m*g*a3/I1 */
    const double t25 = JLT_FNMA(x[3], t23, t24); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - s*m*g*a3/I1 - omega_n*(omega3*I3/I1 + t22) */
    const double t26 = t3*t13; /* s*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t27 = t25*t26; /* t25*s*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t28 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t29 = p[12] + t28; /* I3/(m*R) + e */
    const double t30 = t10*t12; /* s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t31 = x[4]*t30; /* omega3*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t32 = x[2]*p[11]; /* omega_tau*I3/(R*I1) */
    const double t33 = t29*t32; /* (I3/(m*R) + e)*omega_tau*I3/(R*I1) */
    const double t34 = t31*t33; /* omega3*s*D scaled*1/(Theta scaled*s*D scaled)*(I3/(m*R) + e)*omega_tau*I3/(R*I1) */
    const double t35 = JLT_FMA(x[2], t28, x[1]); /* V = omega_tau*e + v_nu */
    const double t36 = t30*t35; /* s*D scaled*1/(Theta scaled*s*D scaled)*V */
    const double t37 = JLT_FMS(t7, t36, t19); /* b*I3/(R^2*I1)*s*D scaled*1/(Theta scaled*s*D scaled)*V - omega_tau*gamma3 */
    const double t38 = JLT_FNMA(t15, t37, t34); /* t34 - Theta scaled*1/(Theta scaled*s*D scaled)*omega_n*D scaled*t37 */
    const double t39 = x[3]*p[13]; /* omega_n*1/R */
    const double t40 = t36*t39; /* s*D scaled*1/(Theta scaled*s*D scaled)*V*omega_n*1/R */
    const double t41 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t42 = t4*t41; /* omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t43 = JLT_FMA(t31, t42, t40); /* omega3*s*D scaled*1/(Theta scaled*s*D scaled)*omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + s*D scaled*1/(Theta scaled*s*D scaled)*V*omega_n*1/R */
    const double t44 = -t43; /* -t43 */
    const double t45 = -t15; /* -Theta scaled*1/(Theta scaled*s*D scaled)*omega_n*D scaled */
    const double t46 = x[4] + t22; /* omega3 + t22 */
    const double t47 = cos(x[5]); /* C = cos(chi) */
    const double t48 = x[1]*t47; /* v_nu*C */
    const double t49 = sin(x[5]); /* S = sin(chi) */
    const double t50 = x[3]*t5; /* omega_n*b */
    const double t51 = JLT_FMA(t3, t16, t50); /* v_tau = s*R*omega3 + omega_n*b */
    const double t52 = JLT_FMA(t49, t51, t48); /* S*v_tau + v_nu*C */
    const double t53 = x[1]*t49; /* v_nu*S */
    const double t54 = JLT_FNMA(t47, t51, t53); /* v_nu*S - C*v_tau */
    out[0] = t4;
    out[1] = t18;
    out[2] = t27;
    out[3] = t38;
    out[4] = t44;
    out[5] = t45;
    out[6] = t46;
    out[7] = t52;
    out[8] = t54;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = t4*p[19]; /* b*m*I3 */
    const double t6 = JLT_FMA(t2, p[18], p[17]); /* (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t7 = JLT_FMA(t4, t5, t6); /* Theta = b*b*m*I3 + (1 - gamma3)*(gamma3 + 1)*m*R^2*I1 + I1*I3 */
    const double t8 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t9 = t3*t8; /* D*s */
    const double t10 = t7*t9; /* Theta*D*s */
    const double t11 = 1.0/t10; /* 1/(Theta*D*s) */
    const double t12 = t7*t11; /* Theta*1/(Theta*D*s) */
    const double t13 = t3*t12; /* D*Theta*1/(Theta*D*s) */
    const double t14 = x[0]*t13; /* gamma3*D*Theta*1/(Theta*D*s) */
    const double t15 = x[2]*t14; /* omega_tau*gamma3*D*Theta*1/(Theta*D*s) */
    const double t16 = -t15; /* -omega_tau*gamma3*D*Theta*1/(Theta*D*s) */
    const double t17 = t13*x[3]; /* D*Theta*1/(Theta*D*s)*omega_n */
    const double t18 = p[1]*x[3]; /* R*omega_n */
    const double t19 = t4*t17; /* b*D*Theta*1/(Theta*D*s)*omega_n */
    const double t20 = JLT_FMA(t14, t19, t18); /* gamma3*D*Theta*1/(Theta*D*s)*b*D*Theta*1/(Theta*D*s)*omega_n + R*omega_n */
    const double t21 = t17*t20; /* D*Theta*1/(Theta*D*s)*omega_n*t20 */
    const double t22 = p[1]*x[4]; /* R*omega3 */
    const double t23 = JLT_FMA(t19, 2.0, t22); /* b*D*Theta*1/(Theta*D*s)*omega_n*2 + R*omega3 */
    const double t24 = t8*t12; /* s*Theta*1/(Theta*D*s) */
    const double t25 = x[0]*t24; /* gamma3*s*Theta*1/(Theta*D*s) */
    const double t26 = t8*p[21]; /* s*2*m*a3^2 */
    const double t27 = t25*t26; /* gamma3*s*Theta*1/(Theta*D*s)*s*2*m*a3^2 */
    const double t28 = t27 - t14; /* gamma3*s*Theta*1/(Theta*D*s)*s*2*m*a3^2 - gamma3*D*Theta*1/(Theta*D*s) */
    const double t29 = p[9]*t28; /* m*g*a3/I1*t28 */
    const double t30 = t13*t17; /* D*Theta*1/(Theta*D*s)*D*Theta*1/(Theta*D*s)*omega_n */
    const double t31 = JLT_FMA(x[0], t28, t8); /* gamma3*t28 + s */
    const double t32 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t33 = t31*t32; /* (gamma3*t28 + s)*omega_tau*omega_tau */
    const double t34 = x[3]*t25; /* omega_n*gamma3*s*Theta*1/(Theta*D*s) */
    const double t35 = x[4]*p[22]; /* omega3*2*I3 */
    const double t36 = JLT_FNMA(t34, t35, t33); /* (gamma3*t28 + s)*omega_tau*omega_tau - omega_n*gamma3*s*Theta*1/(Theta*D*s)*omega3*2*I3 */
    const double t37 = JLT_FMA(t17, t30, t29); /* D*Theta*1/(Theta*D*s)*omega_n*D*Theta*1/(Theta*D*s)*D*Theta*1/(Theta*D*s)*omega_n + m*g*a3/I1*t28 */
    const double t38 = JLT_FNMA(p[6], t36, t37); /* t37 - m*a3^2/I1*t36 */
    const double t39 = p[20]*t24; /* (-I1)*s*Theta*1/(Theta*D*s) */
    const double t40 = t38*t39; /* (t37 - m*a3^2/I1*t36)*(-I1)*s*Theta*1/(Theta*D*s) */
    const double t41 = t17*t25; /* D*Theta*1/(Theta*D*s)*omega_n*gamma3*s*Theta*1/(Theta*D*s) */
    const double t42 = p[23]*t41; /* (-2*m*a3^2*I1)*D*Theta*1/(Theta*D*s)*omega_n*gamma3*s*Theta*1/(Theta*D*s) */
    const double t43 = JLT_FMA(t34, t42, t40); /* omega_n*gamma3*s*Theta*1/(Theta*D*s)*t42 + (t37 - m*a3^2/I1*t36)*(-I1)*s*Theta*1/(Theta*D*s) */
    const double t44 = x[2]*t27; /* omega_tau*gamma3*s*Theta*1/(Theta*D*s)*s*2*m*a3^2 */
    const double t45 = t41*p[24]; /* D*Theta*1/(Theta*D*s)*omega_n*gamma3*s*Theta*1/(Theta*D*s)*2*I1 */
    const double t46 = t24*p[5]; /* s*Theta*1/(Theta*D*s)*I3 */
    const double t47 = JLT_FMA(x[4], t46, t45); /* omega3*s*Theta*1/(Theta*D*s)*I3 + t45 */
    const double t48 = -t47; /* -(omega3*s*Theta*1/(Theta*D*s)*I3 + t45) */
    const double t49 = x[3]*t46; /* omega_n*s*Theta*1/(Theta*D*s)*I3 */
    const double t50 = -t49; /* -omega_n*s*Theta*1/(Theta*D*s)*I3 */
    const double t51 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t52 = JLT_FMA(x[2], t51, x[1]); /* V = omega_tau*e + v_nu */
    const double t53 = t9*t11; /* D*s*1/(Theta*D*s) */
    const double t54 = t52*t53; /* V*D*s*1/(Theta*D*s) */
    const double t55 = t5*t54; /* b*m*I3*V*D*s*1/(Theta*D*s) */
    const double t56 = t14*t30; /* gamma3*D*Theta*1/(Theta*D*s)*D*Theta*1/(Theta*D*s)*D*Theta*1/(Theta*D*s)*omega_n */
    const double t57 = t55*t56; /* b*m*I3*V*D*s*1/(Theta*D*s)*t56 */
    const double t58 = x[0]*p[25]; /* gamma3*2*m*R^2*I1 */
    const double t59 = JLT_FMS(t4, p[26], t58); /* d(Theta)/d(gamma3) = b*2*m*R*I3 - gamma3*2*m*R^2*I1 */
    const double t60 = t53*t59; /* D*s*1/(Theta*D*s)*d(Theta)/d(gamma3) */
    const double t61 = t54*t60; /* V*D*s*1/(Theta*D*s)*D*s*1/(Theta*D*s)*d(Theta)/d(gamma3) */
    const double t62 = x[2]*t53; /* omega_tau*D*s*1/(Theta*D*s) */
    const double t63 = JLT_FNMA(p[3], t62, t61); /* V*D*s*1/(Theta*D*s)*D*s*1/(Theta*D*s)*d(Theta)/d(gamma3) - a3*omega_tau*D*s*1/(Theta*D*s) */
    const double t64 = t5*t63; /* b*m*I3*t63 */
    const double t65 = JLT_FMS(t54, p[27], t64); /* V*D*s*1/(Theta*D*s)*m*R*I3 - b*m*I3*t63 */
    const double t66 = JLT_FMA(t51, p[27], p[29]); /* e*m*R*I3 + I3^2 */
    const double t67 = JLT_FNMA(t60, t66, p[28]); /* m*R*a3*I3 - D*s*1/(Theta*D*s)*d(Theta)/d(gamma3)*(e*m*R*I3 + I3^2) */
    const double t68 = x[4]*t62; /* omega3*omega_tau*D*s*1/(Theta*D*s) */
    const double t69 = t13*t30; /* D*Theta*1/(Theta*D*s)*D*Theta*1/(Theta*D*s)*D*Theta*1/(Theta*D*s)*omega_n */
    const double t70 = JLT_FMS(t67, t68, t57); /* t67*omega3*omega_tau*D*s*1/(Theta*D*s) - b*m*I3*V*D*s*1/(Theta*D*s)*t56 */
    const double t71 = JLT_FMA(x[2], t69, t70); /* omega_tau*t69 + t70 */
    const double t72 = JLT_FNMA(t17, t65, t71); /* omega_tau*t69 + t70 - D*Theta*1/(Theta*D*s)*omega_n*(V*D*s*1/(Theta*D*s)*m*R*I3 - b*m*I3*t63) */
    const double t73 = t5*t53; /* b*m*I3*D*s*1/(Theta*D*s) */
    const double t74 = t17*t73; /* D*Theta*1/(Theta*D*s)*omega_n*b*m*I3*D*s*1/(Theta*D*s) */
    const double t75 = -t74; /* -D*Theta*1/(Theta*D*s)*omega_n*b*m*I3*D*s*1/(Theta*D*s) */
    const double t76 = JLT_FNMA(t51, t73, x[0]); /* gamma3 - e*b*m*I3*D*s*1/(Theta*D*s) */
    const double t77 = t17*t76; /* D*Theta*1/(Theta*D*s)*omega_n*(gamma3 - e*b*m*I3*D*s*1/(Theta*D*s)) */
    const double t78 = x[4]*t53; /* omega3*D*s*1/(Theta*D*s) */
    const double t79 = JLT_FMA(t66, t78, t77); /* (e*m*R*I3 + I3^2)*omega3*D*s*1/(Theta*D*s) + t77 */
    const double t80 = JLT_FNMA(t13, t55, t15); /* omega_tau*gamma3*D*Theta*1/(Theta*D*s) - D*Theta*1/(Theta*D*s)*b*m*I3*V*D*s*1/(Theta*D*s) */
    const double t81 = t62*t66; /* omega_tau*D*s*1/(Theta*D*s)*(e*m*R*I3 + I3^2) */
    const double t82 = x[3]*p[30]; /* omega_n*m*R*I1 */
    const double t83 = t63*t82; /* t63*omega_n*m*R*I1 */
    const double t84 = t8*p[31]; /* s*m*R^2*(I1 - I3) */
    const double t85 = JLT_FNMA(x[0], p[31], p[28]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t86 = t8*t85; /* s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t87 = JLT_FMA(t60, t86, t84); /* D*s*1/(Theta*D*s)*d(Theta)/d(gamma3)*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + s*m*R^2*(I1 - I3) */
    const double t88 = JLT_FMA(t14, t85, t87); /* gamma3*D*Theta*1/(Theta*D*s)*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + t87 */
    const double t89 = JLT_FMA(t68, t88, t83); /* omega3*omega_tau*D*s*1/(Theta*D*s)*t88 + t63*omega_n*m*R*I1 */
    const double t90 = t53*t82; /* D*s*1/(Theta*D*s)*omega_n*m*R*I1 */
    const double t91 = -t90; /* -D*s*1/(Theta*D*s)*omega_n*m*R*I1 */
    const double t92 = t51*t90; /* e*D*s*1/(Theta*D*s)*omega_n*m*R*I1 */
    const double t93 = JLT_FMA(t78, t86, t92); /* omega3*D*s*1/(Theta*D*s)*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*D*s*1/(Theta*D*s)*omega_n*m*R*I1 */
    const double t94 = -t93; /* -t93 */
    const double t95 = t54*p[32]; /* V*D*s*1/(Theta*D*s)*(-m*R*I1) */
    const double t96 = t62*t86; /* omega_tau*D*s*1/(Theta*D*s)*s*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t97 = -t96; /* -t96 */
    const double t98 = -t56; /* -t56 */
    const double t99 = -t13; /* -D*Theta*1/(Theta*D*s) */
    const double t100 = sin(x[5]); /* S = sin(chi) */
    const double t101 = JLT_FNMA(t14, t22, t18); /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*D*Theta*1/(Theta*D*s)*R*omega3 */
    const double t102 = t100*t101; /* S*d(v_tau)/d(gamma3) */
    const double t103 = cos(x[5]); /* C = cos(chi) */
    const double t104 = t4*t100; /* b*S */
    const double t105 = p[1]*t8; /* R*s */
    const double t106 = t100*t105; /* S*R*s */
    const double t107 = x[1]*t100; /* v_nu*S */
    const double t108 = t4*x[3]; /* b*omega_n */
    const double t109 = JLT_FMA(t8, t22, t108); /* v_tau = s*R*omega3 + b*omega_n */
    const double t110 = JLT_FMS(t103, t109, t107); /* C*v_tau - v_nu*S */
    const double t111 = t101*t103; /* d(v_tau)/d(gamma3)*C */
    const double t112 = -t111; /* -d(v_tau)/d(gamma3)*C */
    const double t113 = t4*t103; /* b*C */
    const double t114 = -t113; /* -b*C */
    const double t115 = t103*t105; /* C*R*s */
    const double t116 = -t115; /* -C*R*s */
    const double t117 = x[1]*t103; /* v_nu*C */
    const double t118 = JLT_FMA(t100, t109, t117); /* S*v_tau + v_nu*C */
    out[0] = t16;
    out[1] = 0.0;
    out[2] = t8;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t21;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t23;
    out[13] = t18;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t43;
    out[19] = 0.0;
    out[20] = t44;
    out[21] = t48;
    out[22] = t50;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t72;
    out[28] = t75;
    out[29] = t79;
    out[30] = t80;
    out[31] = t81;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t89;
    out[37] = t91;
    out[38] = t94;
    out[39] = t95;
    out[40] = t97;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t98;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = t99;
    out[49] = 0.0;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[54] = t69;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t14;
    out[58] = 1.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = t102;
    out[64] = t103;
    out[65] = 0.0;
    out[66] = t104;
    out[67] = t106;
    out[68] = t110;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t112;
    out[73] = t100;
    out[74] = 0.0;
    out[75] = t114;
    out[76] = t116;
    out[77] = t118;
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
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[6], 1.0); /* D scaled = (1 - gamma3)*(1 + gamma3)*m*a3^2/I1 + 1 */
    const double t7 = t5*p[8]; /* b*I3/(R^2*I1) */
    const double t8 = t2 + p[7]; /* (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t9 = JLT_FMA(t5, t7, t8); /* Theta scaled = b*b*I3/(R^2*I1) + (1 - gamma3)*(1 + gamma3) + I3/(m*R^2) */
    const double t10 = t3*t6; /* s*D scaled */
    const double t11 = t9*t10; /* Theta scaled*s*D scaled */
    const double t12 = 1.0/t11; /* 1/(Theta scaled*s*D scaled) */
    const double t13 = t9*t12; /* Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t14 = t6*t13; /* D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t15 = x[3]*t14; /* omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t16 = t5*t15; /* b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t17 = p[1]*x[4]; /* R*omega3 */
    const double t18 = t16 + t17; /* b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) + R*omega3 */
    const double t19 = x[3]*t18; /* omega_n*t18 */
    const double t20 = t3*t13; /* s*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t21 = x[0]*t20; /* gamma3*s*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t22 = x[2]*p[6]; /* omega_tau*m*a3^2/I1 */
    const double t23 = x[2]*t22; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t24 = t21*t23; /* gamma3*s*Theta scaled*1/(Theta scaled*s*D scaled)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t25 = JLT_FNMA(t20, p[9], t24); /* t24 - s*Theta scaled*1/(Theta scaled*s*D scaled)*m*g*a3/I1 */
    const double t26 = t3*t25; /* s*(t24 - s*Theta scaled*1/(Theta scaled*s*D scaled)*m*g*a3/I1) */
    const double t27 = x[3]*t20; /* omega_n*s*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t28 = x[0]*t15; /* gamma3*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t29 = JLT_FMA(x[4], p[10], t28); /* omega3*I3/I1 + t28 */
    const double t30 = JLT_FNMA(t27, t29, t26); /* t26 - omega_n*s*Theta scaled*1/(Theta scaled*s*D scaled)*(omega3*I3/I1 + t28) */
    const double t31 = x[2]*t28; /* omega_tau*t28 */
    const double t32 = p[8]*t16; /* I3/(R^2*I1)*b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t33 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t34 = JLT_FMA(x[2], t33, x[1]); /* V = omega_tau*e + v_nu */
    const double t35 = t10*t12; /* s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t36 = t34*t35; /* V*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t37 = x[2]*t35; /* omega_tau*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t38 = x[4]*t37; /* omega3*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t39 = t33 + p[12]; /* e + I3/(m*R) */
    const double t40 = p[11]*t39; /* I3/(R*I1)*(e + I3/(m*R)) */
    const double t41 = JLT_FMA(t38, t40, t31); /* omega3*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*I3/(R*I1)*(e + I3/(m*R)) + omega_tau*t28 */
    const double t42 = JLT_FNMA(t32, t36, t41); /* t41 - t32*V*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t43 = x[3]*p[13]; /* omega_n*1/R */
    const double t44 = t36*t43; /* V*s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R */
    const double t45 = JLT_FNMA(x[0], p[15], p[14]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t46 = t3*t45; /* s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t47 = JLT_FMA(t38, t46, t44); /* omega3*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) + V*s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R */
    const double t48 = -t47; /* -t47 */
    const double t49 = -t15; /* -omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t50 = x[4] + t28; /* omega3 + t28 */
    const double t51 = cos(x[5]); /* C = cos(chi) */
    const double t52 = x[1]*t51; /* v_nu*C */
    const double t53 = sin(x[5]); /* S = sin(chi) */
    const double t54 = x[3]*t5; /* omega_n*b */
    const double t55 = JLT_FMA(t3, t17, t54); /* v_tau = s*R*omega3 + omega_n*b */
    const double t56 = JLT_FMA(t53, t55, t52); /* S*v_tau + v_nu*C */
    const double t57 = x[1]*t53; /* v_nu*S */
    const double t58 = t51*t55; /* C*v_tau */
    const double t59 = t57 - t58; /* v_nu*S - C*v_tau */
    const double t60 = x[0]*t14; /* gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t61 = x[2]*t60; /* omega_tau*gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t62 = -t61; /* -t61 */
    const double t63 = x[3]*p[1]; /* omega_n*R */
    const double t64 = JLT_FMA(t16, t60, t63); /* b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) + omega_n*R */
    const double t65 = t15*t64; /* omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t64 */
    const double t66 = JLT_FMA(t16, 2.0, t17); /* b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*2 + R*omega3 */
    const double t67 = t14*t15; /* D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t68 = t15*t67; /* omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t67 */
    const double t69 = JLT_FNMA(t4, t22, t68); /* t68 - omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t70 = t25*t60; /* (t24 - s*Theta scaled*1/(Theta scaled*s*D scaled)*m*g*a3/I1)*gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t71 = t21*p[33]; /* gamma3*s*Theta scaled*1/(Theta scaled*s*D scaled)*2*m*a3^2/I1 */
    const double t72 = JLT_FMS(t30, t71, t70); /* t30*t71 - t70 */
    const double t73 = JLT_FNMA(t20, t69, t72); /* t30*t71 - t70 - s*Theta scaled*1/(Theta scaled*s*D scaled)*(t68 - omega_tau*s*omega_tau*m*a3^2/I1) */
    const double t74 = t4*t71; /* omega_tau*s*t71 */
    const double t75 = JLT_FMA(x[4], p[34], t28); /* omega3*1/2*I3/I1 + t28 */
    const double t76 = t20*(-2.0); /* s*Theta scaled*1/(Theta scaled*s*D scaled)*(-2) */
    const double t77 = t75*t76; /* (omega3*1/2*I3/I1 + t28)*s*Theta scaled*1/(Theta scaled*s*D scaled)*(-2) */
    const double t78 = t27*p[35]; /* omega_n*s*Theta scaled*1/(Theta scaled*s*D scaled)*(-I3/I1) */
    const double t79 = t14*t67; /* D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t67 */
    const double t80 = t14*t36; /* D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*V*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t81 = t60*t80; /* gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t80 */
    const double t82 = t36*p[11]; /* V*s*D scaled*1/(Theta scaled*s*D scaled)*I3/(R*I1) */
    const double t83 = t15*t82; /* omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*V*s*D scaled*1/(Theta scaled*s*D scaled)*I3/(R*I1) */
    const double t84 = JLT_FMS(t5, p[11], x[0]); /* d(Theta)/d(gamma3) scaled = b*I3/(R*I1) - gamma3 */
    const double t85 = t35*t84; /* s*D scaled*1/(Theta scaled*s*D scaled)*d(Theta)/d(gamma3) scaled */
    const double t86 = t36*t85; /* V*s*D scaled*1/(Theta scaled*s*D scaled)*t85 */
    const double t87 = p[36]*t86; /* 2*I3/(R^2*I1)*V*s*D scaled*1/(Theta scaled*s*D scaled)*t85 */
    const double t88 = t37*p[37]; /* omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*a3*I3/(R^2*I1) */
    const double t89 = JLT_FNMA(t39, t85, p[39]); /* 1/2*a3 - (e + I3/(m*R))*t85 */
    const double t90 = t38*p[38]; /* omega3*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*2*I3/(R*I1) */
    const double t91 = JLT_FMS(t16, t87, t83); /* b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*2*I3/(R^2*I1)*V*s*D scaled*1/(Theta scaled*s*D scaled)*t85 - t83 */
    const double t92 = JLT_FNMA(t16, t88, t91); /* t91 - b*omega_n*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t88 */
    const double t93 = JLT_FMA(t89, t90, t92); /* (1/2*a3 - (e + I3/(m*R))*t85)*t90 + t92 */
    const double t94 = JLT_FMA(x[2], t79, t93); /* omega_tau*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t67 + (1/2*a3 - (e + I3/(m*R))*t85)*t90 + t92 */
    const double t95 = JLT_FNMA(t32, t81, t94); /* t94 - t32*gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t80 */
    const double t96 = t32*t35; /* t32*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t97 = -t96; /* -t32*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t98 = x[4]*t35; /* omega3*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t99 = JLT_FMA(t40, t98, t28); /* I3/(R*I1)*(e + I3/(m*R))*omega3*s*D scaled*1/(Theta scaled*s*D scaled) + t28 */
    const double t100 = JLT_FNMA(t33, t96, t99); /* t99 - e*t32*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t101 = JLT_FNMA(t7, t80, t61); /* t61 - b*I3/(R^2*I1)*t80 */
    const double t102 = t37*t40; /* omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*I3/(R*I1)*(e + I3/(m*R)) */
    const double t103 = JLT_FMS(t37, p[39], t86); /* omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*1/2*a3 - V*s*D scaled*1/(Theta scaled*s*D scaled)*t85 */
    const double t104 = x[3]*p[40]; /* omega_n*2/R */
    const double t105 = t103*t104; /* t103*omega_n*2/R */
    const double t106 = JLT_FNMA(x[0], p[42], p[41]); /* 2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1 */
    const double t107 = JLT_FMA(t85, t106, p[15]); /* t85*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) + (I1 - I3)/I1 */
    const double t108 = t3*t107; /* s*(t85*(2*a3*I3/(R*I1) - gamma3*2*(I1 - I3)/I1) + (I1 - I3)/I1) */
    const double t109 = JLT_FMA(t45, t60, t108); /* (a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) + t108 */
    const double t110 = JLT_FMS(t38, t109, t105); /* omega3*omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*t109 - t103*omega_n*2/R */
    const double t111 = t35*t43; /* s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R */
    const double t112 = -t111; /* -s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R */
    const double t113 = t46*t98; /* s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1)*omega3*s*D scaled*1/(Theta scaled*s*D scaled) */
    const double t114 = JLT_FMA(t33, t111, t113); /* e*s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R + t113 */
    const double t115 = -t114; /* -(e*s*D scaled*1/(Theta scaled*s*D scaled)*omega_n*1/R + t113) */
    const double t116 = t36*p[43]; /* V*s*D scaled*1/(Theta scaled*s*D scaled)*(-1/R) */
    const double t117 = t37*t46; /* omega_tau*s*D scaled*1/(Theta scaled*s*D scaled)*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t118 = -t117; /* -t117 */
    const double t119 = t60*t67; /* gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t67 */
    const double t120 = -t119; /* -gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled)*t67 */
    const double t121 = -t14; /* -D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t122 = JLT_FNMA(t17, t60, t63); /* d(v_tau)/d(gamma3) = omega_n*R - R*omega3*gamma3*D scaled*Theta scaled*1/(Theta scaled*s*D scaled) */
    const double t123 = t53*t122; /* S*d(v_tau)/d(gamma3) */
    const double t124 = t5*t53; /* b*S */
    const double t125 = t3*p[1]; /* s*R */
    const double t126 = t53*t125; /* S*s*R */
    const double t127 = t58 - t57; /* C*v_tau - v_nu*S */
    const double t128 = t51*t122; /* C*d(v_tau)/d(gamma3) */
    const double t129 = -t128; /* -C*d(v_tau)/d(gamma3) */
    const double t130 = t5*t51; /* b*C */
    const double t131 = -t130; /* -b*C */
    const double t132 = t51*t125; /* C*s*R */
    const double t133 = -t132; /* -C*s*R */
    out[0] = t4;
    out[1] = t19;
    out[2] = t30;
    out[3] = t42;
    out[4] = t48;
    out[5] = t49;
    out[6] = t50;
    out[7] = t56;
    out[8] = t59;
    out[9] = t62;
    out[10] = 0.0;
    out[11] = t3;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t65;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = t66;
    out[22] = t63;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t73;
    out[28] = 0.0;
    out[29] = t74;
    out[30] = t77;
    out[31] = t78;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t95;
    out[37] = t97;
    out[38] = t100;
    out[39] = t101;
    out[40] = t102;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t110;
    out[46] = t112;
    out[47] = t115;
    out[48] = t116;
    out[49] = t118;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[54] = t120;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t121;
    out[58] = 0.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = t79;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = t60;
    out[67] = 1.0;
    out[68] = 0.0;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t123;
    out[73] = t51;
    out[74] = 0.0;
    out[75] = t124;
    out[76] = t126;
    out[77] = t127;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[81] = t129;
    out[82] = t53;
    out[83] = 0.0;
    out[84] = t131;
    out[85] = t133;
    out[86] = t56;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = 0.0;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = JLT_FMA(t2, p[16], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t5 = t3*x[2]; /* s*omega_tau */
    const double t6 = x[0]*t5; /* gamma3*s*omega_tau */
    const double t7 = p[31]*t6; /* m*R^2*(I1 - I3)*gamma3*s*omega_tau */
    const double t8 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t9 = JLT_FMA(x[2], t8, x[1]); /* V = omega_tau*e + v_nu */
    const double t10 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t11 = p[19]*t10; /* m*I3*b */
    const double t12 = JLT_FMA(t2, p[18], p[17]); /* (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t13 = JLT_FMA(t10, t11, t12); /* Theta = b*m*I3*b + (1 - gamma3)*(1 + gamma3)*m*R^2*I1 + I1*I3 */
    const double t14 = t4*t13; /* D*Theta */
    const double t15 = t3*t14; /* s*D*Theta */
    const double t16 = 1.0/t15; /* 1/(s*D*Theta) */
    const double t17 = t13*t16; /* Theta*1/(s*D*Theta) */
    const double t18 = t4*t11; /* D*m*I3*b */
    const double t19 = t9*t18; /* V*D*m*I3*b */
    const double t20 = JLT_FNMA(t5, p[28], t7); /* m*R^2*(I1 - I3)*gamma3*s*omega_tau - s*omega_tau*m*R*a3*I3 */
    const double t21 = JLT_FNMA(t17, t19, t20); /* m*R^2*(I1 - I3)*gamma3*s*omega_tau - s*omega_tau*m*R*a3*I3 - Theta*1/(s*D*Theta)*V*D*m*I3*b */
    const double t22 = t4*t16; /* D*1/(s*D*Theta) */
    const double t23 = t21*t22; /* t21*D*1/(s*D*Theta) */
    const double t24 = t6*p[21]; /* gamma3*s*omega_tau*2*m*a3^2 */
    const double t25 = JLT_FMA(t17, t24, t23); /* Theta*1/(s*D*Theta)*gamma3*s*omega_tau*2*m*a3^2 + t21*D*1/(s*D*Theta) */
    const double t26 = t3*t25; /* s*t25 */
    out[0] = t26;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[44]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = x[0] + 1.0; /* gamma3 + 1 */
    const double t6 = t4*t5; /* (1 - gamma3)*(gamma3 + 1) */
    const double t7 = sqrt(t6); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(t7, t8, t3); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = JLT_FMA(t9, t9, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t11 = JLT_FMA(t6, p[16], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = x[3]*p[46]; /* omega_n*1/2*I1 */
    const double t15 = x[4]*p[47]; /* omega3*1/2*I3 */
    const double t16 = JLT_FMA(x[3], t14, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t17 = JLT_FMA(x[4], t15, t16); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t18 = JLT_FMA(t11, t13, t17); /* D*omega_tau*1/2*omega_tau + t17 */
    const double t19 = JLT_FMA(p[45], t10, t18); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t17 */
    const double t20 = x[3]*p[48]; /* omega_n*R*I1 */
    const double t21 = t7*t20; /* s*omega_n*R*I1 */
    const double t22 = x[4]*p[5]; /* omega3*I3 */
    const double t23 = JLT_FNMA(t2, t22, t21); /* s*omega_n*R*I1 - b*omega3*I3 */
    out[0] = t19;
    out[1] = t23;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[16]*x[0]; /* m*a3^2*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = x[0]/t5; /* gamma3/s */
    const double t7 = JLT_FNMA(x[4], t6, x[3]); /* d(v_tau)/d(gamma3) scaled = omega_n - omega3*gamma3/s */
    const double t8 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t9 = x[3]*t8; /* omega_n*b */
    const double t10 = x[4]*p[1]; /* omega3*R */
    const double t11 = JLT_FMA(t5, t10, t9); /* v_tau = s*omega3*R + omega_n*b */
    const double t12 = p[49]*t11; /* m*R*v_tau */
    const double t13 = JLT_FNMA(t0, t1, p[44]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t14 = JLT_FMA(t7, t12, t13); /* d(v_tau)/d(gamma3) scaled*m*R*v_tau + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t15 = p[0]*x[1]; /* m*v_nu */
    const double t16 = JLT_FMA(p[16], t4, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t17 = x[2]*t16; /* omega_tau*D */
    const double t18 = x[3]*p[4]; /* omega_n*I1 */
    const double t19 = t8*p[0]; /* b*m */
    const double t20 = JLT_FMA(t11, t19, t18); /* v_tau*b*m + omega_n*I1 */
    const double t21 = x[4]*p[5]; /* omega3*I3 */
    const double t22 = JLT_FMA(t5, t12, t21); /* s*m*R*v_tau + omega3*I3 */
    const double t23 = x[3]*p[50]; /* omega_n*(-R*I1) */
    const double t24 = t6*t23; /* gamma3/s*omega_n*(-R*I1) */
    const double t25 = JLT_FMA(x[4], p[51], t24); /* omega3*(-R*I3) + gamma3/s*omega_n*(-R*I1) */
    const double t26 = t5*p[48]; /* s*R*I1 */
    const double t27 = t8*p[52]; /* b*(-I3) */
    out[0] = t14;
    out[1] = t15;
    out[2] = t17;
    out[3] = t20;
    out[4] = t22;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t25;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t26;
    out[13] = t27;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
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
    double t13[JLT_JET_ORDER_MAX + 1];
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
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double u66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
    double t68[JLT_JET_ORDER_MAX + 1];
    double u68[JLT_JET_ORDER_MAX + 1];
    double t69[JLT_JET_ORDER_MAX + 1];
    double t70[JLT_JET_ORDER_MAX + 1];
    double t71[JLT_JET_ORDER_MAX + 1];
    double t72[JLT_JET_ORDER_MAX + 1];
    double t73[JLT_JET_ORDER_MAX + 1];
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
        t11[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t13[k] = t5[k]*p[6] + (k == 0 ? 1.0 : 0);
        t16[k] = t11[k]*p[8];
        t17[k] = t5[k] + (k == 0 ? p[7] : 0);
        t18[k] = jlt_jet_product(t11, t16, k) + t17[k];
        t19[k] = jlt_jet_product(t6, t13, k);
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t20, t21, k);
        t22[k] = jlt_jet_product(t18, t21, k);
        t23[k] = jlt_jet_product(x3, t13, k);
        t24[k] = jlt_jet_product(t22, t23, k);
        t26[k] = p[1]*x4[k];
        t27[k] = jlt_jet_product(t11, t24, k) + t26[k];
        t28[k] = jlt_jet_product(x3, t27, k);
        t29[k] = jlt_jet_product(x2, x0, k);
        t30[k] = p[6]*t29[k];
        t31[k] = jlt_jet_product(t7, t30, k);
        t34[k] = jlt_jet_product(x0, t24, k);
        t35[k] = x4[k]*p[10] + t34[k];
        t36[k] = t31[k] - t6[k]*p[9];
        t37[k] = t36[k] - jlt_jet_product(x3, t35, k);
        t38[k] = jlt_jet_product(t6, t22, k);
        t39[k] = jlt_jet_product(t37, t38, k);
        t42[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t43[k] = (k == 0 ? p[12] : 0) + t42[k];
        t44[k] = jlt_jet_product(t19, t21, k);
        t45[k] = jlt_jet_product(x4, t44, k);
        t46[k] = x2[k]*p[11];
        t47[k] = jlt_jet_product(t43, t46, k);
        t48[k] = jlt_jet_product(t45, t47, k);
        t50[k] = jlt_jet_product(x2, t42, k) + x1[k];
        t51[k] = jlt_jet_product(t44, t50, k);
        t52[k] = jlt_jet_product(t16, t51, k) - t29[k];
        t53[k] = t48[k] - jlt_jet_product(t24, t52, k);
        t55[k] = x3[k]*p[13];
        t56[k] = jlt_jet_product(t51, t55, k);
        t59[k] = (k == 0 ? p[14] : 0) - x0[k]*p[15];
        t60[k] = jlt_jet_product(t7, t59, k);
        t61[k] = jlt_jet_product(t45, t60, k) + t56[k];
        t62[k] = -t61[k];
        t63[k] = -t24[k];
        t64[k] = x4[k] + t34[k];
        t66[k] = jlt_jet_cosine(x5, t66, u66, k);
        t67[k] = jlt_jet_product(x1, t66, k);
        t68[k] = jlt_jet_sine(x5, t68, u68, k);
        t69[k] = jlt_jet_product(x3, t11, k);
        t70[k] = jlt_jet_product(t6, t26, k) + t69[k];
        t71[k] = jlt_jet_product(t68, t70, k) + t67[k];
        t72[k] = jlt_jet_product(x1, t68, k);
        t73[k] = t72[k] - jlt_jet_product(t66, t70, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t28[k]/(k + 1);
        next[2] = x2[k + 1] = t39[k]/(k + 1);
        next[3] = x3[k + 1] = t53[k]/(k + 1);
        next[4] = x4[k + 1] = t62[k]/(k + 1);
        next[5] = x5[k + 1] = t63[k]/(k + 1);
        next[6] = x6[k + 1] = t64[k]/(k + 1);
        next[7] = x7[k + 1] = t71[k]/(k + 1);
        next[8] = x8[k + 1] = t73[k]/(k + 1);
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
};

const jlt_descriptor jlt_kernels_spherical_top_track_general = {
    .model = "spherical_top_track",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_track,
    .state_count = 9, .param_count = 6, .block_count = 53,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 9, { 7, 28, 16, 1, 1, 2, 12, 14 }, { 22, 77, 0, 14, 1, 2, 12, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 81, { 15, 66, 34, 1, 1, 2, 17, 24 }, { 61, 296, 0, 55, 1, 2, 16, 11 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 90, { 20, 73, 37, 1, 1, 2, 15, 36 }, { 75, 353, 0, 69, 1, 2, 16, 14 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 14, 9, 1, 1, 0, 12, 10 }, { 11, 38, 0, 4, 1, 0, 12, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 2, { 2, 12, 9, 0, 1, 0, 6, 9 }, { 10, 32, 0, 0, 1, 0, 12, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 18, { 2, 15, 9, 1, 1, 0, 6, 10 }, { 12, 38, 0, 2, 1, 0, 8, 8 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_track_general_baseline,
        &jlt_batch_spherical_top_track_general_avx2,
        &jlt_batch_spherical_top_track_general_avx512,
    },
};
