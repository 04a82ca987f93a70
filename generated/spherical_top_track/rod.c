/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   20   11    1    1    2     10   10   (67)
 *  jacobian            9   48   18    1    1    2     12   17   (212)
 *  rhs_jacobian        14   54   19    1    1    2     12   23   (259)
 *  divergence          2    4    2    1    1    0      6    4   (18)
 *  integral_values     2   12    9    0    1    2      6    8   (44)
 *  integral_gradients  5   23    9    1    1    2      8   11   (65)
 *
 *  Accuracy: divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_track[];
extern const jlt_descriptor jlt_kernels_spherical_top_track_rod;
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
    const double t2 = t1/params[4]; /* m*a3*a3/I1 */
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[3]*t3; /* a3*m*g */
    const double t5 = t4/params[4]; /* a3*m*g/I1 */
    const double t6 = 1.0/params[1]; /* 1/R */
    const double t7 = params[0]*2.0; /* m*2 */
    const double t8 = t0*t7; /* a3*a3*m*2 */
    const double t9 = params[4]*(-2.0); /* I1*(-2) */
    const double t10 = params[3]/params[1]; /* a3/R */
    const double t11 = 2.0/params[1]; /* 2/R */
    const double t12 = (-1.0)/params[1]; /* (-1)/R */
    const double t13 = params[0]/2.0; /* m/2 */
    const double t14 = params[4]/2.0; /* I1/2 */
    const double t15 = params[4]*params[1]; /* I1*R */
    const double t16 = params[0]*params[1]; /* m*R */
    const double t17 = -t15; /* -I1*R */
    out[6] = t2;
    out[7] = t5;
    out[8] = t6;
    out[9] = t1;
    out[10] = t4;
    out[11] = t8;
    out[12] = t9;
    out[13] = t10;
    out[14] = t11;
    out[15] = t12;
    out[16] = t13;
    out[17] = t14;
    out[18] = t15;
    out[19] = t16;
    out[20] = t17;
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
    const double t7 = t3*t6; /* s*D scaled */
    const double t8 = 1.0/t7; /* 1/(s*D scaled) */
    const double t9 = t6*t8; /* D scaled*1/(s*D scaled) */
    const double t10 = x[3]*t9; /* omega_n*D scaled*1/(s*D scaled) */
    const double t11 = p[1]*x[4]; /* R*omega3 */
    const double t12 = JLT_FMA(t5, t10, t11); /* b*omega_n*D scaled*1/(s*D scaled) + R*omega3 */
    const double t13 = x[3]*t12; /* omega_n*(b*omega_n*D scaled*1/(s*D scaled) + R*omega3) */
    const double t14 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t15 = p[6]*t14; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t16 = t4*t15; /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t17 = x[0]*t10; /* gamma3*omega_n*D scaled*1/(s*D scaled) */
    const double t18 = JLT_FNMA(t3, p[7], t16); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - s*m*g*a3/I1 */
    const double t19 = JLT_FNMA(x[3], t17, t18); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - s*m*g*a3/I1 - omega_n*gamma3*omega_n*D scaled*1/(s*D scaled) */
    const double t20 = t3*t8; /* s*1/(s*D scaled) */
    const double t21 = t19*t20; /* t19*s*1/(s*D scaled) */
    const double t22 = x[2]*t17; /* omega_tau*gamma3*omega_n*D scaled*1/(s*D scaled) */
    const double t23 = x[4]*t14; /* omega3*omega_tau*gamma3 */
    const double t24 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t25 = JLT_FMA(x[2], t24, x[1]); /* V = omega_tau*e + v_nu */
    const double t26 = p[8]*t25; /* 1/R*V */
    const double t27 = JLT_FNMA(t10, t26, t23); /* omega3*omega_tau*gamma3 - omega_n*D scaled*1/(s*D scaled)*1/R*V */
    const double t28 = t9*t27; /* D scaled*1/(s*D scaled)*t27 */
    const double t29 = -t10; /* -omega_n*D scaled*1/(s*D scaled) */
    const double t30 = x[4] + t17; /* omega3 + gamma3*omega_n*D scaled*1/(s*D scaled) */
    const double t31 = cos(x[5]); /* C = cos(chi) */
    const double t32 = x[1]*t31; /* v_nu*C */
    const double t33 = sin(x[5]); /* S = sin(chi) */
    const double t34 = x[3]*t5; /* omega_n*b */
    const double t35 = JLT_FMA(t3, t11, t34); /* v_tau = s*R*omega3 + omega_n*b */
    const double t36 = JLT_FMA(t33, t35, t32); /* S*v_tau + v_nu*C */
    const double t37 = x[1]*t33; /* v_nu*S */
    const double t38 = JLT_FNMA(t31, t35, t37); /* v_nu*S - C*v_tau */
    out[0] = t4;
    out[1] = t13;
    out[2] = t21;
    out[3] = t22;
    out[4] = t28;
    out[5] = t29;
    out[6] = t30;
    out[7] = t36;
    out[8] = t38;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[9], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = t3*t4; /* D*s */
    const double t6 = 1.0/t5; /* 1/(D*s) */
    const double t7 = t3*t6; /* D*1/(D*s) */
    const double t8 = x[0]*t7; /* gamma3*D*1/(D*s) */
    const double t9 = x[2]*t8; /* omega_tau*gamma3*D*1/(D*s) */
    const double t10 = -t9; /* -omega_tau*gamma3*D*1/(D*s) */
    const double t11 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t12 = t7*x[3]; /* D*1/(D*s)*omega_n */
    const double t13 = t11*t12; /* b*D*1/(D*s)*omega_n */
    const double t14 = p[1]*x[3]; /* R*omega_n */
    const double t15 = JLT_FMA(t8, t13, t14); /* gamma3*D*1/(D*s)*b*D*1/(D*s)*omega_n + R*omega_n */
    const double t16 = t12*t15; /* D*1/(D*s)*omega_n*(gamma3*D*1/(D*s)*b*D*1/(D*s)*omega_n + R*omega_n) */
    const double t17 = p[1]*x[4]; /* R*omega3 */
    const double t18 = JLT_FMA(t13, 2.0, t17); /* b*D*1/(D*s)*omega_n*2 + R*omega3 */
    const double t19 = x[2]*t4; /* omega_tau*s */
    const double t20 = x[2]*p[9]; /* omega_tau*m*a3^2 */
    const double t21 = t19*t20; /* omega_tau*s*omega_tau*m*a3^2 */
    const double t22 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t23 = JLT_FNMA(t20, t22, p[10]); /* m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t24 = p[4]*x[3]; /* I1*omega_n */
    const double t25 = t7*t7; /* D*1/(D*s)*D*1/(D*s) */
    const double t26 = x[3]*t25; /* omega_n*D*1/(D*s)*D*1/(D*s) */
    const double t27 = t7*t26; /* D*1/(D*s)*omega_n*D*1/(D*s)*D*1/(D*s) */
    const double t28 = JLT_FMA(t8, t23, t21); /* gamma3*D*1/(D*s)*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) + omega_tau*s*omega_tau*m*a3^2 */
    const double t29 = JLT_FNMA(t24, t27, t28); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = t28 - I1*omega_n*D*1/(D*s)*omega_n*D*1/(D*s)*D*1/(D*s) */
    const double t30 = t4*t23; /* s*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t31 = t8*x[3]; /* gamma3*D*1/(D*s)*omega_n */
    const double t32 = JLT_FMA(t24, t31, t30); /* I1*omega_n*gamma3*D*1/(D*s)*omega_n + s*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t33 = t4*t6; /* s*1/(D*s) */
    const double t34 = x[0]*p[11]; /* gamma3*2*m*a3^2 */
    const double t35 = t33*t34; /* s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t36 = JLT_FNMA(t32, t35, t29); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) - t32*s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t37 = t33*t36; /* s*1/(D*s)*t36 */
    const double t38 = t19*t35; /* omega_tau*s*s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t39 = t33*p[12]; /* s*1/(D*s)*(-2*I1) */
    const double t40 = t31*t39; /* gamma3*D*1/(D*s)*omega_n*s*1/(D*s)*(-2*I1) */
    const double t41 = x[2]*t27; /* omega_tau*D*1/(D*s)*omega_n*D*1/(D*s)*D*1/(D*s) */
    const double t42 = x[4]*t25; /* omega3*D*1/(D*s)*D*1/(D*s) */
    const double t43 = JLT_FNMA(t12, p[13], t42); /* omega3*D*1/(D*s)*D*1/(D*s) - D*1/(D*s)*omega_n*a3/R */
    const double t44 = x[2]*t7; /* omega_tau*D*1/(D*s) */
    const double t45 = t43*t44; /* (omega3*D*1/(D*s)*D*1/(D*s) - D*1/(D*s)*omega_n*a3/R)*omega_tau*D*1/(D*s) */
    const double t46 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t47 = JLT_FMA(x[2], t46, x[1]); /* V = omega_tau*e + v_nu */
    const double t48 = p[14]*t47; /* 2/R*V */
    const double t49 = t8*t48; /* gamma3*D*1/(D*s)*2/R*V */
    const double t50 = JLT_FNMA(t27, t49, t45); /* t45 - D*1/(D*s)*omega_n*D*1/(D*s)*D*1/(D*s)*gamma3*D*1/(D*s)*2/R*V */
    const double t51 = t26*p[8]; /* omega_n*D*1/(D*s)*D*1/(D*s)*1/R */
    const double t52 = -t51; /* -omega_n*D*1/(D*s)*D*1/(D*s)*1/R */
    const double t53 = t46*t51; /* e*omega_n*D*1/(D*s)*D*1/(D*s)*1/R */
    const double t54 = JLT_FMS(t8, x[4], t53); /* gamma3*D*1/(D*s)*omega3 - e*omega_n*D*1/(D*s)*D*1/(D*s)*1/R */
    const double t55 = t47*p[15]; /* V*(-1/R) */
    const double t56 = t25*t55; /* D*1/(D*s)*D*1/(D*s)*V*(-1/R) */
    const double t57 = t8*t26; /* gamma3*D*1/(D*s)*omega_n*D*1/(D*s)*D*1/(D*s) */
    const double t58 = -t57; /* -gamma3*D*1/(D*s)*omega_n*D*1/(D*s)*D*1/(D*s) */
    const double t59 = -t7; /* -D*1/(D*s) */
    const double t60 = sin(x[5]); /* S = sin(chi) */
    const double t61 = JLT_FNMA(t8, t17, t14); /* d(v_tau)/d(gamma3) = R*omega_n - gamma3*D*1/(D*s)*R*omega3 */
    const double t62 = t60*t61; /* S*d(v_tau)/d(gamma3) */
    const double t63 = cos(x[5]); /* C = cos(chi) */
    const double t64 = t11*t60; /* b*S */
    const double t65 = t4*p[1]; /* s*R */
    const double t66 = t60*t65; /* S*s*R */
    const double t67 = x[1]*t60; /* v_nu*S */
    const double t68 = t11*x[3]; /* b*omega_n */
    const double t69 = JLT_FMA(x[4], t65, t68); /* v_tau = omega3*s*R + b*omega_n */
    const double t70 = JLT_FMS(t63, t69, t67); /* C*v_tau - v_nu*S */
    const double t71 = t61*t63; /* d(v_tau)/d(gamma3)*C */
    const double t72 = -t71; /* -d(v_tau)/d(gamma3)*C */
    const double t73 = t11*t63; /* b*C */
    const double t74 = -t73; /* -b*C */
    const double t75 = t63*t65; /* C*s*R */
    const double t76 = -t75; /* -C*s*R */
    const double t77 = x[1]*t63; /* v_nu*C */
    const double t78 = JLT_FMA(t60, t69, t77); /* S*v_tau + v_nu*C */
    out[0] = t10;
    out[1] = 0.0;
    out[2] = t4;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t16;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t18;
    out[13] = t14;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t37;
    out[19] = 0.0;
    out[20] = t38;
    out[21] = t40;
    out[22] = 0.0;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t41;
    out[28] = 0.0;
    out[29] = t31;
    out[30] = t9;
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t50;
    out[37] = t52;
    out[38] = t54;
    out[39] = t56;
    out[40] = t9;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t58;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = t59;
    out[49] = 0.0;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[54] = t27;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t8;
    out[58] = 1.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = t62;
    out[64] = t63;
    out[65] = 0.0;
    out[66] = t64;
    out[67] = t66;
    out[68] = t70;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t72;
    out[73] = t60;
    out[74] = 0.0;
    out[75] = t74;
    out[76] = t76;
    out[77] = t78;
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
    const double t6 = JLT_FMA(t2, p[9], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t7 = t3*t6; /* s*D */
    const double t8 = 1.0/t7; /* 1/(s*D) */
    const double t9 = t6*t8; /* D*1/(s*D) */
    const double t10 = x[3]*t9; /* omega_n*D*1/(s*D) */
    const double t11 = t5*t10; /* b*omega_n*D*1/(s*D) */
    const double t12 = x[3]*t11; /* omega_n*b*omega_n*D*1/(s*D) */
    const double t13 = x[3]*p[1]; /* omega_n*R */
    const double t14 = JLT_FMA(x[4], t13, t12); /* omega3*omega_n*R + omega_n*b*omega_n*D*1/(s*D) */
    const double t15 = x[2]*p[9]; /* omega_tau*m*a3^2 */
    const double t16 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t17 = JLT_FNMA(t15, t16, p[10]); /* m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t18 = t3*t17; /* s*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t19 = x[0]*t9; /* gamma3*D*1/(s*D) */
    const double t20 = x[3]*t19; /* omega_n*gamma3*D*1/(s*D) */
    const double t21 = x[3]*p[4]; /* omega_n*I1 */
    const double t22 = JLT_FMA(t20, t21, t18); /* omega_n*gamma3*D*1/(s*D)*omega_n*I1 + s*(m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3) */
    const double t23 = t3*t8; /* s*1/(s*D) */
    const double t24 = t22*t23; /* t22*s*1/(s*D) */
    const double t25 = -t24; /* -t22*s*1/(s*D) */
    const double t26 = x[2]*t20; /* omega_tau*omega_n*gamma3*D*1/(s*D) */
    const double t27 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t28 = JLT_FMA(x[2], t27, x[1]); /* V = omega_tau*e + v_nu */
    const double t29 = t9*t10; /* D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t30 = p[8]*t29; /* 1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t31 = t28*t30; /* V*1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t32 = x[2]*t19; /* omega_tau*gamma3*D*1/(s*D) */
    const double t33 = JLT_FMS(x[4], t32, t31); /* omega3*omega_tau*gamma3*D*1/(s*D) - V*1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t34 = -t10; /* -omega_n*D*1/(s*D) */
    const double t35 = x[4] + t20; /* omega3 + omega_n*gamma3*D*1/(s*D) */
    const double t36 = cos(x[5]); /* C = cos(chi) */
    const double t37 = x[1]*t36; /* v_nu*C */
    const double t38 = sin(x[5]); /* S = sin(chi) */
    const double t39 = x[3]*t5; /* omega_n*b */
    const double t40 = t3*p[1]; /* s*R */
    const double t41 = JLT_FMA(x[4], t40, t39); /* v_tau = omega3*s*R + omega_n*b */
    const double t42 = JLT_FMA(t38, t41, t37); /* S*v_tau + v_nu*C */
    const double t43 = x[1]*t38; /* v_nu*S */
    const double t44 = t36*t41; /* C*v_tau */
    const double t45 = t43 - t44; /* v_nu*S - C*v_tau */
    const double t46 = -t32; /* -omega_tau*gamma3*D*1/(s*D) */
    const double t47 = JLT_FMA(t11, t19, t13); /* b*omega_n*D*1/(s*D)*gamma3*D*1/(s*D) + omega_n*R */
    const double t48 = t10*t47; /* omega_n*D*1/(s*D)*(b*omega_n*D*1/(s*D)*gamma3*D*1/(s*D) + omega_n*R) */
    const double t49 = t11*2.0; /* b*omega_n*D*1/(s*D)*2 */
    const double t50 = JLT_FMA(p[1], x[4], t49); /* R*omega3 + b*omega_n*D*1/(s*D)*2 */
    const double t51 = x[0]*p[11]; /* gamma3*2*m*a3^2 */
    const double t52 = t23*t51; /* s*1/(s*D)*gamma3*2*m*a3^2 */
    const double t53 = t24*t52; /* t22*s*1/(s*D)*s*1/(s*D)*gamma3*2*m*a3^2 */
    const double t54 = t17*t19; /* (m*g*a3 - omega_tau*m*a3^2*omega_tau*gamma3)*gamma3*D*1/(s*D) */
    const double t55 = p[4]*t10; /* I1*omega_n*D*1/(s*D) */
    const double t56 = JLT_FMA(t4, t15, t54); /* omega_tau*s*omega_tau*m*a3^2 + t54 */
    const double t57 = JLT_FNMA(t29, t55, t56); /* d(numerator of d(omega_tau)/dt over D)/d(gamma3) = omega_tau*s*omega_tau*m*a3^2 + t54 - D*1/(s*D)*omega_n*D*1/(s*D)*I1*omega_n*D*1/(s*D) */
    const double t58 = JLT_FMS(t23, t57, t53); /* s*1/(s*D)*d(numerator of d(omega_tau)/dt over D)/d(gamma3) - t22*s*1/(s*D)*s*1/(s*D)*gamma3*2*m*a3^2 */
    const double t59 = t4*t52; /* omega_tau*s*s*1/(s*D)*gamma3*2*m*a3^2 */
    const double t60 = t23*p[12]; /* s*1/(s*D)*(-2*I1) */
    const double t61 = t20*t60; /* omega_n*gamma3*D*1/(s*D)*s*1/(s*D)*(-2*I1) */
    const double t62 = t9*t29; /* D*1/(s*D)*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t63 = x[2]*t62; /* omega_tau*D*1/(s*D)*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t64 = t9*t9; /* D*1/(s*D)*D*1/(s*D) */
    const double t65 = t9*x[4]; /* D*1/(s*D)*omega3 */
    const double t66 = t64*t65; /* D*1/(s*D)*D*1/(s*D)*D*1/(s*D)*omega3 */
    const double t67 = JLT_FNMA(t29, p[13], t66); /* D*1/(s*D)*D*1/(s*D)*D*1/(s*D)*omega3 - D*1/(s*D)*omega_n*D*1/(s*D)*a3/R */
    const double t68 = x[2]*t67; /* omega_tau*t67 */
    const double t69 = t28*p[14]; /* V*2/R */
    const double t70 = t19*t69; /* gamma3*D*1/(s*D)*V*2/R */
    const double t71 = JLT_FNMA(t62, t70, t68); /* omega_tau*t67 - D*1/(s*D)*D*1/(s*D)*omega_n*D*1/(s*D)*gamma3*D*1/(s*D)*V*2/R */
    const double t72 = -t30; /* -1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t73 = x[4]*t19; /* omega3*gamma3*D*1/(s*D) */
    const double t74 = JLT_FNMA(t27, t30, t73); /* omega3*gamma3*D*1/(s*D) - e*1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t75 = t28*p[15]; /* V*(-1/R) */
    const double t76 = t64*t75; /* D*1/(s*D)*D*1/(s*D)*V*(-1/R) */
    const double t77 = t19*t29; /* gamma3*D*1/(s*D)*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t78 = -t77; /* -gamma3*D*1/(s*D)*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t79 = -t9; /* -D*1/(s*D) */
    const double t80 = JLT_FNMA(p[1], t73, t13); /* d(v_tau)/d(gamma3) = omega_n*R - R*omega3*gamma3*D*1/(s*D) */
    const double t81 = t38*t80; /* S*d(v_tau)/d(gamma3) */
    const double t82 = t5*t38; /* b*S */
    const double t83 = t38*t40; /* S*s*R */
    const double t84 = t44 - t43; /* C*v_tau - v_nu*S */
    const double t85 = t36*t80; /* C*d(v_tau)/d(gamma3) */
    const double t86 = -t85; /* -C*d(v_tau)/d(gamma3) */
    const double t87 = t5*t36; /* b*C */
    const double t88 = -t87; /* -b*C */
    const double t89 = t36*t40; /* C*s*R */
    const double t90 = -t89; /* -C*s*R */
    out[0] = t4;
    out[1] = t14;
    out[2] = t25;
    out[3] = t26;
    out[4] = t33;
    out[5] = t34;
    out[6] = t35;
    out[7] = t42;
    out[8] = t45;
    out[9] = t46;
    out[10] = 0.0;
    out[11] = t3;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t48;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = t50;
    out[22] = t13;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t58;
    out[28] = 0.0;
    out[29] = t59;
    out[30] = t61;
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t63;
    out[37] = 0.0;
    out[38] = t20;
    out[39] = t32;
    out[40] = 0.0;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t71;
    out[46] = t72;
    out[47] = t74;
    out[48] = t76;
    out[49] = t32;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[54] = t78;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t79;
    out[58] = 0.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = t62;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = t19;
    out[67] = 1.0;
    out[68] = 0.0;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t81;
    out[73] = t36;
    out[74] = 0.0;
    out[75] = t82;
    out[76] = t83;
    out[77] = t84;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[81] = t86;
    out[82] = t38;
    out[83] = 0.0;
    out[84] = t88;
    out[85] = t90;
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
    const double t4 = JLT_FMA(t2, p[9], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*D */
    const double t6 = JLT_FMA(t2, p[11], t4); /* (1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D */
    const double t7 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t8 = t6*t7; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D)*gamma3*omega_tau */
    const double t9 = t8/t5; /* ((1 - gamma3)*(gamma3 + 1)*2*m*a3^2 + D)*gamma3*omega_tau/(s*D) */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[10]*x[0]; /* m*g*a3*gamma3 */
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
    const double t11 = JLT_FMA(t6, p[9], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = x[3]*p[17]; /* omega_n*1/2*I1 */
    const double t15 = JLT_FMA(x[3], t14, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(t11, t13, t15); /* D*omega_tau*1/2*omega_tau + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t17 = JLT_FMA(p[16], t10, t16); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t16 */
    const double t18 = x[3]*p[18]; /* omega_n*R*I1 */
    const double t19 = t7*t18; /* s*omega_n*R*I1 */
    const double t20 = cos(x[5]); /* C = cos(chi) */
    const double t21 = x[1]*t20; /* v_nu*C */
    const double t22 = sin(x[5]); /* S = sin(chi) */
    const double t23 = JLT_FMA(t9, t22, t21); /* v_tau*S + v_nu*C */
    const double t24 = x[1]*t22; /* v_nu*S */
    const double t25 = JLT_FNMA(t9, t20, t24); /* v_nu*S - v_tau*C */
    out[0] = t17;
    out[1] = t19;
    out[2] = t23;
    out[3] = t25;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[9]*x[0]; /* m*a3^2*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = x[0]/t5; /* gamma3/s */
    const double t7 = JLT_FMS(x[4], t6, x[3]); /* omega3*gamma3/s - omega_n */
    const double t8 = p[1]*t7; /* R*(omega3*gamma3/s - omega_n) */
    const double t9 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t10 = x[3]*t9; /* omega_n*b */
    const double t11 = p[1]*t5; /* R*s */
    const double t12 = JLT_FMA(x[4], t11, t10); /* v_tau = omega3*R*s + omega_n*b */
    const double t13 = p[0]*t12; /* m*v_tau */
    const double t14 = JLT_FNMA(t0, t1, p[10]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t15 = JLT_FNMA(t8, t13, t14); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau - R*(omega3*gamma3/s - omega_n)*m*v_tau */
    const double t16 = p[0]*x[1]; /* m*v_nu */
    const double t17 = JLT_FMA(p[9], t4, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t18 = x[2]*t17; /* omega_tau*D */
    const double t19 = x[3]*p[4]; /* omega_n*I1 */
    const double t20 = JLT_FMA(t9, t13, t19); /* b*m*v_tau + omega_n*I1 */
    const double t21 = t5*p[19]; /* s*m*R */
    const double t22 = t12*t21; /* v_tau*s*m*R */
    const double t23 = x[3]*p[20]; /* omega_n*(-R*I1) */
    const double t24 = t6*t23; /* gamma3/s*omega_n*(-R*I1) */
    const double t25 = t5*p[18]; /* s*R*I1 */
    const double t26 = sin(x[5]); /* S = sin(chi) */
    const double t27 = t8*t26; /* R*(omega3*gamma3/s - omega_n)*S */
    const double t28 = -t27; /* -R*(omega3*gamma3/s - omega_n)*S */
    const double t29 = cos(x[5]); /* C = cos(chi) */
    const double t30 = t9*t26; /* b*S */
    const double t31 = t11*t26; /* R*s*S */
    const double t32 = x[1]*t26; /* v_nu*S */
    const double t33 = JLT_FMS(t12, t29, t32); /* v_tau*C - v_nu*S */
    const double t34 = t8*t29; /* R*(omega3*gamma3/s - omega_n)*C */
    const double t35 = t9*t29; /* b*C */
    const double t36 = -t35; /* -b*C */
    const double t37 = t11*t29; /* R*s*C */
    const double t38 = -t37; /* -R*s*C */
    const double t39 = x[1]*t29; /* v_nu*C */
    const double t40 = JLT_FMA(t12, t26, t39); /* v_tau*S + v_nu*C */
    out[0] = t15;
    out[1] = t16;
    out[2] = t18;
    out[3] = t20;
    out[4] = t22;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t24;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t25;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t28;
    out[19] = t29;
    out[20] = 0.0;
    out[21] = t30;
    out[22] = t31;
    out[23] = t33;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t34;
    out[28] = t26;
    out[29] = 0.0;
    out[30] = t36;
    out[31] = t38;
    out[32] = t40;
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
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
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
    double t32[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double u43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double u45[JLT_JET_ORDER_MAX + 1];
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
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t11[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t13[k] = t5[k]*p[6] + (k == 0 ? 1.0 : 0);
        t14[k] = jlt_jet_product(t6, t13, k);
        t15[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t14, t15, k);
        t16[k] = jlt_jet_product(t13, t15, k);
        t17[k] = jlt_jet_product(x3, t16, k);
        t19[k] = p[1]*x4[k];
        t20[k] = jlt_jet_product(t11, t17, k) + t19[k];
        t21[k] = jlt_jet_product(x3, t20, k);
        t22[k] = jlt_jet_product(x2, x0, k);
        t23[k] = p[6]*t22[k];
        t24[k] = jlt_jet_product(t7, t23, k);
        t26[k] = jlt_jet_product(x0, t17, k);
        t27[k] = t24[k] - t6[k]*p[7];
        t28[k] = t27[k] - jlt_jet_product(x3, t26, k);
        t29[k] = jlt_jet_product(t6, t15, k);
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = jlt_jet_product(x2, t26, k);
        t32[k] = jlt_jet_product(x4, t22, k);
        t35[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t36[k] = jlt_jet_product(x2, t35, k) + x1[k];
        t37[k] = p[8]*t36[k];
        t38[k] = t32[k] - jlt_jet_product(t17, t37, k);
        t39[k] = jlt_jet_product(t16, t38, k);
        t40[k] = -t17[k];
        t41[k] = x4[k] + t26[k];
        t43[k] = jlt_jet_cosine(x5, t43, u43, k);
        t44[k] = jlt_jet_product(x1, t43, k);
        t45[k] = jlt_jet_sine(x5, t45, u45, k);
        t46[k] = jlt_jet_product(x3, t11, k);
        t47[k] = jlt_jet_product(t6, t19, k) + t46[k];
        t48[k] = jlt_jet_product(t45, t47, k) + t44[k];
        t49[k] = jlt_jet_product(x1, t45, k);
        t50[k] = t49[k] - jlt_jet_product(t43, t47, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t21[k]/(k + 1);
        next[2] = x2[k + 1] = t30[k]/(k + 1);
        next[3] = x3[k + 1] = t31[k]/(k + 1);
        next[4] = x4[k + 1] = t39[k]/(k + 1);
        next[5] = x5[k + 1] = t40[k]/(k + 1);
        next[6] = x6[k + 1] = t41[k]/(k + 1);
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
    { "v_x", "I3 = 0" },
    { "v_y", "I3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_track_rod = {
    .model = "spherical_top_track",
    .variant = "rod",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_track,
    .state_count = 9, .param_count = 6, .block_count = 21,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 9, { 4, 20, 11, 1, 1, 2, 10, 10 }, { 14, 41, 0, 9, 1, 2, 9, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 81, { 9, 48, 18, 1, 1, 2, 12, 17 }, { 32, 144, 0, 33, 1, 2, 15, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 90, { 14, 54, 19, 1, 1, 2, 12, 23 }, { 40, 174, 0, 42, 1, 2, 15, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 4, 2, 1, 1, 0, 6, 4 }, { 3, 12, 0, 2, 1, 0, 9, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 4, { 2, 12, 9, 0, 1, 2, 6, 8 }, { 10, 31, 0, 0, 1, 2, 11, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 36, { 5, 23, 9, 1, 1, 2, 8, 11 }, { 14, 46, 0, 2, 1, 2, 8, 9 },
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
        &jlt_batch_spherical_top_track_rod_baseline,
        &jlt_batch_spherical_top_track_rod_avx2,
        &jlt_batch_spherical_top_track_rod_avx512,
    },
};
