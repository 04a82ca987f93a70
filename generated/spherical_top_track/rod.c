/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    rod: I3 = 0
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   21   11    1    1    2     10   12   (67)
 *  jacobian            10   47   18    1    1    2     13   17   (212)
 *  rhs_jacobian        16   55   19    1    1    2     12   23   (259)
 *  divergence          2    7    2    1    1    0      8    5   (18)
 *  integral_values     2   12    9    0    1    2      6    8   (44)
 *  integral_gradients  5   24    9    1    1    2      9   11   (65)
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
    const double t2 = -params[4]; /* -I1 */
    const double t3 = params[0]*params[2]; /* m*g */
    const double t4 = params[3]*t3; /* a3*m*g */
    const double t5 = t4/params[4]; /* a3*m*g/I1 */
    const double t6 = t1/params[4]; /* m*a3*a3/I1 */
    const double t7 = 1.0/params[1]; /* 1/R */
    const double t8 = params[0]*2.0; /* m*2 */
    const double t9 = t0*t8; /* a3*a3*m*2 */
    const double t10 = params[4]*(-2.0); /* I1*(-2) */
    const double t11 = params[3]/params[1]; /* a3/R */
    const double t12 = 2.0/params[1]; /* 2/R */
    const double t13 = (-1.0)/params[1]; /* (-1)/R */
    const double t14 = params[0]*params[3]; /* m*a3 */
    const double t15 = params[3]/2.0; /* a3/2 */
    const double t16 = params[0]/2.0; /* m/2 */
    const double t17 = params[4]/2.0; /* I1/2 */
    const double t18 = params[4]*params[1]; /* I1*R */
    const double t19 = params[0]*params[1]; /* m*R */
    const double t20 = -t18; /* -I1*R */
    out[6] = t1;
    out[7] = t2;
    out[8] = t5;
    out[9] = t6;
    out[10] = t7;
    out[11] = t9;
    out[12] = t10;
    out[13] = t11;
    out[14] = t12;
    out[15] = t13;
    out[16] = t14;
    out[17] = t15;
    out[18] = t4;
    out[19] = t16;
    out[20] = t17;
    out[21] = t18;
    out[22] = t19;
    out[23] = t20;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t4 = x[2]*t3; /* omega_tau*s */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FMA(t2, p[6], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t7 = t3*t6; /* s*D */
    const double t8 = 1.0/t7; /* 1/(s*D) */
    const double t9 = t6*t8; /* D*1/(s*D) */
    const double t10 = x[3]*t9; /* omega_n*D*1/(s*D) */
    const double t11 = p[1]*x[4]; /* R*omega3 */
    const double t12 = JLT_FMA(t5, t10, t11); /* b*omega_n*D*1/(s*D) + R*omega3 */
    const double t13 = x[3]*t12; /* omega_n*(b*omega_n*D*1/(s*D) + R*omega3) */
    const double t14 = x[0]*t10; /* gamma3*omega_n*D*1/(s*D) */
    const double t15 = t3*p[8]; /* s*m*g*a3/I1 */
    const double t16 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t17 = p[9]*t16; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t18 = JLT_FNMA(t4, t17, t15); /* s*m*g*a3/I1 - omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t19 = JLT_FMA(x[3], t14, t18); /* omega_n*gamma3*omega_n*D*1/(s*D) + s*m*g*a3/I1 - omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t20 = t3*p[7]; /* s*(-I1) */
    const double t21 = t8*t20; /* 1/(s*D)*s*(-I1) */
    const double t22 = t19*t21; /* t19*1/(s*D)*s*(-I1) */
    const double t23 = x[2]*t14; /* omega_tau*gamma3*omega_n*D*1/(s*D) */
    const double t24 = x[4]*t16; /* omega3*omega_tau*gamma3 */
    const double t25 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t26 = JLT_FMA(x[2], t25, x[1]); /* V = omega_tau*e + v_nu */
    const double t27 = p[10]*t26; /* 1/R*V */
    const double t28 = JLT_FNMA(t10, t27, t24); /* omega3*omega_tau*gamma3 - omega_n*D*1/(s*D)*1/R*V */
    const double t29 = t9*t28; /* D*1/(s*D)*(omega3*omega_tau*gamma3 - omega_n*D*1/(s*D)*1/R*V) */
    const double t30 = -t10; /* -omega_n*D*1/(s*D) */
    const double t31 = x[4] + t14; /* omega3 + gamma3*omega_n*D*1/(s*D) */
    const double t32 = cos(x[5]); /* C = cos(chi) */
    const double t33 = x[1]*t32; /* v_nu*C */
    const double t34 = sin(x[5]); /* S = sin(chi) */
    const double t35 = x[3]*t5; /* omega_n*b */
    const double t36 = JLT_FMA(t3, t11, t35); /* v_tau = s*R*omega3 + omega_n*b */
    const double t37 = JLT_FMA(t34, t36, t33); /* S*v_tau + v_nu*C */
    const double t38 = x[1]*t34; /* v_nu*S */
    const double t39 = JLT_FNMA(t32, t36, t38); /* v_nu*S - C*v_tau */
    out[0] = t4;
    out[1] = t13;
    out[2] = t22;
    out[3] = t23;
    out[4] = t29;
    out[5] = t30;
    out[6] = t31;
    out[7] = t37;
    out[8] = t39;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(p[6], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t4 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = t3*t4; /* D*s */
    const double t6 = 1.0/t5; /* 1/(D*s) */
    const double t7 = t3*t6; /* D*1/(D*s) */
    const double t8 = x[0]*t7; /* gamma3*D*1/(D*s) */
    const double t9 = x[2]*t8; /* omega_tau*gamma3*D*1/(D*s) */
    const double t10 = -t9; /* -omega_tau*gamma3*D*1/(D*s) */
    const double t11 = t7*x[3]; /* D*1/(D*s)*omega_n */
    const double t12 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t13 = t11*t12; /* D*1/(D*s)*omega_n*b */
    const double t14 = x[3]*p[1]; /* omega_n*R */
    const double t15 = JLT_FMA(t8, t13, t14); /* gamma3*D*1/(D*s)*D*1/(D*s)*omega_n*b + omega_n*R */
    const double t16 = t11*t15; /* D*1/(D*s)*omega_n*(gamma3*D*1/(D*s)*D*1/(D*s)*omega_n*b + omega_n*R) */
    const double t17 = p[1]*x[4]; /* R*omega3 */
    const double t18 = JLT_FMA(t13, 2.0, t17); /* D*1/(D*s)*omega_n*b*2 + R*omega3 */
    const double t19 = t4*t6; /* s*1/(D*s) */
    const double t20 = x[0]*p[11]; /* gamma3*2*m*a3^2 */
    const double t21 = t19*t20; /* s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t22 = t4*t21; /* s*s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t23 = t22 - t8; /* s*s*1/(D*s)*gamma3*2*m*a3^2 - gamma3*D*1/(D*s) */
    const double t24 = p[8]*t23; /* m*g*a3/I1*(s*s*1/(D*s)*gamma3*2*m*a3^2 - gamma3*D*1/(D*s)) */
    const double t25 = JLT_FMA(x[0], t23, t4); /* gamma3*(s*s*1/(D*s)*gamma3*2*m*a3^2 - gamma3*D*1/(D*s)) + s */
    const double t26 = x[2]*p[9]; /* omega_tau*m*a3^2/I1 */
    const double t27 = x[2]*t26; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t28 = t8*x[3]; /* gamma3*D*1/(D*s)*omega_n */
    const double t29 = JLT_FMA(t8, t8, 1.0); /* gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1 */
    const double t30 = t11*t29; /* D*1/(D*s)*omega_n*(gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1) */
    const double t31 = JLT_FMA(t21, t28, t30); /* s*1/(D*s)*gamma3*2*m*a3^2*gamma3*D*1/(D*s)*omega_n + D*1/(D*s)*omega_n*(gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1) */
    const double t32 = JLT_FNMA(t25, t27, t24); /* m*g*a3/I1*(s*s*1/(D*s)*gamma3*2*m*a3^2 - gamma3*D*1/(D*s)) - (gamma3*(s*s*1/(D*s)*gamma3*2*m*a3^2 - gamma3*D*1/(D*s)) + s)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t33 = JLT_FMA(x[3], t31, t32); /* omega_n*t31 + t32 */
    const double t34 = p[7]*t19; /* (-I1)*s*1/(D*s) */
    const double t35 = t33*t34; /* (omega_n*t31 + t32)*(-I1)*s*1/(D*s) */
    const double t36 = x[2]*t22; /* omega_tau*s*s*1/(D*s)*gamma3*2*m*a3^2 */
    const double t37 = t19*p[12]; /* s*1/(D*s)*(-2*I1) */
    const double t38 = t28*t37; /* gamma3*D*1/(D*s)*omega_n*s*1/(D*s)*(-2*I1) */
    const double t39 = x[2]*t30; /* omega_tau*D*1/(D*s)*omega_n*(gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1) */
    const double t40 = t7*t11; /* D*1/(D*s)*D*1/(D*s)*omega_n */
    const double t41 = x[2]*p[13]; /* omega_tau*a3/R */
    const double t42 = t40*t41; /* D*1/(D*s)*D*1/(D*s)*omega_n*omega_tau*a3/R */
    const double t43 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t44 = t29*t43; /* (gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1)*omega_tau*omega3 */
    const double t45 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t46 = JLT_FMA(x[2], t45, x[1]); /* V = omega_tau*e + v_nu */
    const double t47 = t8*t40; /* gamma3*D*1/(D*s)*D*1/(D*s)*D*1/(D*s)*omega_n */
    const double t48 = p[14]*t46; /* 2/R*V */
    const double t49 = JLT_FNMA(t47, t48, t44); /* (gamma3*D*1/(D*s)*gamma3*D*1/(D*s) + 1)*omega_tau*omega3 - gamma3*D*1/(D*s)*D*1/(D*s)*D*1/(D*s)*omega_n*2/R*V */
    const double t50 = JLT_FMS(t7, t49, t42); /* D*1/(D*s)*t49 - D*1/(D*s)*D*1/(D*s)*omega_n*omega_tau*a3/R */
    const double t51 = t40*p[10]; /* D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t52 = -t51; /* -D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t53 = t45*t51; /* e*D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t54 = JLT_FMS(t8, x[4], t53); /* gamma3*D*1/(D*s)*omega3 - e*D*1/(D*s)*D*1/(D*s)*omega_n*1/R */
    const double t55 = t46*p[15]; /* V*(-1/R) */
    const double t56 = t7*t55; /* D*1/(D*s)*V*(-1/R) */
    const double t57 = t7*t56; /* D*1/(D*s)*D*1/(D*s)*V*(-1/R) */
    const double t58 = -t47; /* -gamma3*D*1/(D*s)*D*1/(D*s)*D*1/(D*s)*omega_n */
    const double t59 = -t7; /* -D*1/(D*s) */
    const double t60 = sin(x[5]); /* S = sin(chi) */
    const double t61 = JLT_FNMA(t8, t17, t14); /* d(v_tau)/d(gamma3) = omega_n*R - gamma3*D*1/(D*s)*R*omega3 */
    const double t62 = t60*t61; /* S*d(v_tau)/d(gamma3) */
    const double t63 = cos(x[5]); /* C = cos(chi) */
    const double t64 = t12*t60; /* b*S */
    const double t65 = t4*p[1]; /* s*R */
    const double t66 = t60*t65; /* S*s*R */
    const double t67 = x[1]*t60; /* v_nu*S */
    const double t68 = x[3]*t12; /* omega_n*b */
    const double t69 = JLT_FMA(t4, t17, t68); /* v_tau = s*R*omega3 + omega_n*b */
    const double t70 = JLT_FMS(t63, t69, t67); /* C*v_tau - v_nu*S */
    const double t71 = t61*t63; /* d(v_tau)/d(gamma3)*C */
    const double t72 = -t71; /* -d(v_tau)/d(gamma3)*C */
    const double t73 = t12*t63; /* b*C */
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
    out[18] = t35;
    out[19] = 0.0;
    out[20] = t36;
    out[21] = t38;
    out[22] = 0.0;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t39;
    out[28] = 0.0;
    out[29] = t28;
    out[30] = t9;
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t50;
    out[37] = t52;
    out[38] = t54;
    out[39] = t57;
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
    out[54] = t30;
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
    const double t6 = JLT_FMA(t2, p[6], p[4]); /* D = (1 - gamma3)*(1 + gamma3)*m*a3^2 + I1 */
    const double t7 = t3*t6; /* s*D */
    const double t8 = 1.0/t7; /* 1/(s*D) */
    const double t9 = t6*t8; /* D*1/(s*D) */
    const double t10 = x[3]*t9; /* omega_n*D*1/(s*D) */
    const double t11 = t5*t10; /* b*omega_n*D*1/(s*D) */
    const double t12 = x[3]*t11; /* omega_n*b*omega_n*D*1/(s*D) */
    const double t13 = x[3]*p[1]; /* omega_n*R */
    const double t14 = JLT_FMA(x[4], t13, t12); /* omega3*omega_n*R + omega_n*b*omega_n*D*1/(s*D) */
    const double t15 = t3*t8; /* s*1/(s*D) */
    const double t16 = t3*t15; /* s*s*1/(s*D) */
    const double t17 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t18 = x[0]*p[3]; /* gamma3*a3 */
    const double t19 = JLT_FNMA(t17, t18, p[2]); /* g - omega_tau*omega_tau*gamma3*a3 */
    const double t20 = p[16]*t19; /* m*a3*(g - omega_tau*omega_tau*gamma3*a3) */
    const double t21 = t16*t20; /* s*s*1/(s*D)*m*a3*(g - omega_tau*omega_tau*gamma3*a3) */
    const double t22 = x[0]*t9; /* gamma3*D*1/(s*D) */
    const double t23 = x[3]*t22; /* omega_n*gamma3*D*1/(s*D) */
    const double t24 = t15*t23; /* s*1/(s*D)*omega_n*gamma3*D*1/(s*D) */
    const double t25 = x[3]*p[4]; /* omega_n*I1 */
    const double t26 = JLT_FMA(t24, t25, t21); /* s*1/(s*D)*omega_n*gamma3*D*1/(s*D)*omega_n*I1 + s*s*1/(s*D)*m*a3*(g - omega_tau*omega_tau*gamma3*a3) */
    const double t27 = -t26; /* -t26 */
    const double t28 = x[2]*t22; /* omega_tau*gamma3*D*1/(s*D) */
    const double t29 = x[3]*t28; /* omega_n*omega_tau*gamma3*D*1/(s*D) */
    const double t30 = p[1] + t18; /* e = R + gamma3*a3 */
    const double t31 = JLT_FMA(x[2], t30, x[1]); /* V = omega_tau*e + v_nu */
    const double t32 = t9*t10; /* D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t33 = p[10]*t32; /* 1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t34 = t31*t33; /* V*1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t35 = JLT_FMS(x[4], t28, t34); /* omega3*omega_tau*gamma3*D*1/(s*D) - V*1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t36 = -t10; /* -omega_n*D*1/(s*D) */
    const double t37 = x[4] + t23; /* omega3 + omega_n*gamma3*D*1/(s*D) */
    const double t38 = cos(x[5]); /* C = cos(chi) */
    const double t39 = x[1]*t38; /* v_nu*C */
    const double t40 = sin(x[5]); /* S = sin(chi) */
    const double t41 = x[3]*t5; /* omega_n*b */
    const double t42 = t3*p[1]; /* s*R */
    const double t43 = JLT_FMA(x[4], t42, t41); /* v_tau = omega3*s*R + omega_n*b */
    const double t44 = JLT_FMA(t40, t43, t39); /* S*v_tau + v_nu*C */
    const double t45 = x[1]*t40; /* v_nu*S */
    const double t46 = t38*t43; /* C*v_tau */
    const double t47 = t45 - t46; /* v_nu*S - C*v_tau */
    const double t48 = -t28; /* -omega_tau*gamma3*D*1/(s*D) */
    const double t49 = JLT_FMA(t11, t22, t13); /* b*omega_n*D*1/(s*D)*gamma3*D*1/(s*D) + omega_n*R */
    const double t50 = t10*t49; /* omega_n*D*1/(s*D)*(b*omega_n*D*1/(s*D)*gamma3*D*1/(s*D) + omega_n*R) */
    const double t51 = t11*2.0; /* b*omega_n*D*1/(s*D)*2 */
    const double t52 = JLT_FMA(p[1], x[4], t51); /* R*omega3 + b*omega_n*D*1/(s*D)*2 */
    const double t53 = p[6]*t17; /* m*a3^2*omega_tau*omega_tau */
    const double t54 = t16*t53; /* s*s*1/(s*D)*m*a3^2*omega_tau*omega_tau */
    const double t55 = x[0]*p[11]; /* gamma3*2*m*a3^2 */
    const double t56 = t16*t55; /* s*s*1/(s*D)*gamma3*2*m*a3^2 */
    const double t57 = t56 - t22; /* s*s*1/(s*D)*gamma3*2*m*a3^2 - gamma3*D*1/(s*D) */
    const double t58 = t20*t57; /* m*a3*(g - omega_tau*omega_tau*gamma3*a3)*(s*s*1/(s*D)*gamma3*2*m*a3^2 - gamma3*D*1/(s*D)) */
    const double t59 = JLT_FMA(t22, t22, 1.0); /* gamma3*D*1/(s*D)*gamma3*D*1/(s*D) + 1 */
    const double t60 = t10*t59; /* omega_n*D*1/(s*D)*(gamma3*D*1/(s*D)*gamma3*D*1/(s*D) + 1) */
    const double t61 = JLT_FMA(t24, t55, t60); /* s*1/(s*D)*omega_n*gamma3*D*1/(s*D)*gamma3*2*m*a3^2 + omega_n*D*1/(s*D)*(gamma3*D*1/(s*D)*gamma3*D*1/(s*D) + 1) */
    const double t62 = JLT_FMA(t25, t61, t58); /* omega_n*I1*t61 + t58 */
    const double t63 = JLT_FNMA(t15, t62, t54); /* s*s*1/(s*D)*m*a3^2*omega_tau*omega_tau - s*1/(s*D)*(omega_n*I1*t61 + t58) */
    const double t64 = x[2]*t56; /* omega_tau*s*s*1/(s*D)*gamma3*2*m*a3^2 */
    const double t65 = t24*p[12]; /* s*1/(s*D)*omega_n*gamma3*D*1/(s*D)*(-2*I1) */
    const double t66 = x[2]*t60; /* omega_tau*omega_n*D*1/(s*D)*(gamma3*D*1/(s*D)*gamma3*D*1/(s*D) + 1) */
    const double t67 = x[2]*p[17]; /* omega_tau*1/2*a3 */
    const double t68 = t9*t31; /* D*1/(s*D)*V */
    const double t69 = JLT_FMA(t22, t68, t67); /* gamma3*D*1/(s*D)*D*1/(s*D)*V + omega_tau*1/2*a3 */
    const double t70 = t32*p[14]; /* D*1/(s*D)*omega_n*D*1/(s*D)*2/R */
    const double t71 = t69*t70; /* (gamma3*D*1/(s*D)*D*1/(s*D)*V + omega_tau*1/2*a3)*D*1/(s*D)*omega_n*D*1/(s*D)*2/R */
    const double t72 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t73 = t9*t72; /* D*1/(s*D)*omega_tau*omega3 */
    const double t74 = JLT_FMS(t59, t73, t71); /* (gamma3*D*1/(s*D)*gamma3*D*1/(s*D) + 1)*D*1/(s*D)*omega_tau*omega3 - t71 */
    const double t75 = -t33; /* -1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t76 = x[4]*t22; /* omega3*gamma3*D*1/(s*D) */
    const double t77 = JLT_FNMA(t30, t33, t76); /* omega3*gamma3*D*1/(s*D) - e*1/R*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t78 = t9*p[15]; /* D*1/(s*D)*(-1/R) */
    const double t79 = t68*t78; /* D*1/(s*D)*V*D*1/(s*D)*(-1/R) */
    const double t80 = t22*t32; /* gamma3*D*1/(s*D)*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t81 = -t80; /* -gamma3*D*1/(s*D)*D*1/(s*D)*omega_n*D*1/(s*D) */
    const double t82 = -t9; /* -D*1/(s*D) */
    const double t83 = JLT_FNMA(p[1], t76, t13); /* d(v_tau)/d(gamma3) = omega_n*R - R*omega3*gamma3*D*1/(s*D) */
    const double t84 = t40*t83; /* S*d(v_tau)/d(gamma3) */
    const double t85 = t5*t40; /* b*S */
    const double t86 = t40*t42; /* S*s*R */
    const double t87 = t46 - t45; /* C*v_tau - v_nu*S */
    const double t88 = t38*t83; /* C*d(v_tau)/d(gamma3) */
    const double t89 = -t88; /* -C*d(v_tau)/d(gamma3) */
    const double t90 = t5*t38; /* b*C */
    const double t91 = -t90; /* -b*C */
    const double t92 = t38*t42; /* C*s*R */
    const double t93 = -t92; /* -C*s*R */
    out[0] = t4;
    out[1] = t14;
    out[2] = t27;
    out[3] = t29;
    out[4] = t35;
    out[5] = t36;
    out[6] = t37;
    out[7] = t44;
    out[8] = t47;
    out[9] = t48;
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
    out[21] = t52;
    out[22] = t13;
    out[23] = 0.0;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t63;
    out[28] = 0.0;
    out[29] = t64;
    out[30] = t65;
    out[31] = 0.0;
    out[32] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[36] = t66;
    out[37] = 0.0;
    out[38] = t23;
    out[39] = t28;
    out[40] = 0.0;
    out[41] = 0.0;
    out[42] = 0.0;
    out[43] = 0.0;
    out[44] = 0.0;
    out[45] = t74;
    out[46] = t75;
    out[47] = t77;
    out[48] = t79;
    out[49] = t28;
    out[50] = 0.0;
    out[51] = 0.0;
    out[52] = 0.0;
    out[53] = 0.0;
    out[54] = t81;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = t82;
    out[58] = 0.0;
    out[59] = 0.0;
    out[60] = 0.0;
    out[61] = 0.0;
    out[62] = 0.0;
    out[63] = t60;
    out[64] = 0.0;
    out[65] = 0.0;
    out[66] = t22;
    out[67] = 1.0;
    out[68] = 0.0;
    out[69] = 0.0;
    out[70] = 0.0;
    out[71] = 0.0;
    out[72] = t84;
    out[73] = t38;
    out[74] = 0.0;
    out[75] = t85;
    out[76] = t86;
    out[77] = t87;
    out[78] = 0.0;
    out[79] = 0.0;
    out[80] = 0.0;
    out[81] = t89;
    out[82] = t40;
    out[83] = 0.0;
    out[84] = t91;
    out[85] = t93;
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
    const double t4 = JLT_FMA(t2, p[6], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t5 = t3*t4; /* s*D */
    const double t6 = 1.0/t5; /* 1/(s*D) */
    const double t7 = p[11]*t3; /* 2*m*a3^2*s */
    const double t8 = t3*t7; /* s*2*m*a3^2*s */
    const double t9 = t6*t8; /* 1/(s*D)*s*2*m*a3^2*s */
    const double t10 = JLT_FMA(t4, t6, t9); /* D*1/(s*D) + 1/(s*D)*s*2*m*a3^2*s */
    const double t11 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t12 = t10*t11; /* (D*1/(s*D) + 1/(s*D)*s*2*m*a3^2*s)*gamma3*omega_tau */
    out[0] = t12;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[18]*x[0]; /* m*g*a3*gamma3 */
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
    const double t11 = JLT_FMA(t6, p[6], p[4]); /* D = (1 - gamma3)*(gamma3 + 1)*m*a3^2 + I1 */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = x[3]*p[20]; /* omega_n*1/2*I1 */
    const double t15 = JLT_FMA(x[3], t14, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(t11, t13, t15); /* D*omega_tau*1/2*omega_tau + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t17 = JLT_FMA(p[19], t10, t16); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + t16 */
    const double t18 = x[3]*p[21]; /* omega_n*R*I1 */
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
    const double t0 = p[6]*x[0]; /* m*a3^2*gamma3 */
    const double t1 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = x[0] + 1.0; /* gamma3 + 1 */
    const double t4 = t2*t3; /* (1 - gamma3)*(gamma3 + 1) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t6 = 1.0/t5; /* 1/s */
    const double t7 = x[0]*t6; /* gamma3*1/s */
    const double t8 = JLT_FMS(x[4], t7, x[3]); /* omega3*gamma3*1/s - omega_n */
    const double t9 = p[1]*t8; /* R*(omega3*gamma3*1/s - omega_n) */
    const double t10 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t11 = x[3]*t10; /* omega_n*b */
    const double t12 = p[1]*t5; /* R*s */
    const double t13 = JLT_FMA(x[4], t12, t11); /* v_tau = omega3*R*s + omega_n*b */
    const double t14 = p[0]*t13; /* m*v_tau */
    const double t15 = JLT_FNMA(t0, t1, p[18]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t16 = JLT_FNMA(t9, t14, t15); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau - R*(omega3*gamma3*1/s - omega_n)*m*v_tau */
    const double t17 = p[0]*x[1]; /* m*v_nu */
    const double t18 = JLT_FMA(p[6], t4, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t19 = x[2]*t18; /* omega_tau*D */
    const double t20 = x[3]*p[4]; /* omega_n*I1 */
    const double t21 = JLT_FMA(t10, t14, t20); /* b*m*v_tau + omega_n*I1 */
    const double t22 = t5*p[22]; /* s*m*R */
    const double t23 = t13*t22; /* v_tau*s*m*R */
    const double t24 = x[3]*p[23]; /* omega_n*(-R*I1) */
    const double t25 = t7*t24; /* gamma3*1/s*omega_n*(-R*I1) */
    const double t26 = t5*p[21]; /* s*R*I1 */
    const double t27 = sin(x[5]); /* S = sin(chi) */
    const double t28 = t9*t27; /* R*(omega3*gamma3*1/s - omega_n)*S */
    const double t29 = -t28; /* -R*(omega3*gamma3*1/s - omega_n)*S */
    const double t30 = cos(x[5]); /* C = cos(chi) */
    const double t31 = t10*t27; /* b*S */
    const double t32 = t12*t27; /* R*s*S */
    const double t33 = x[1]*t27; /* v_nu*S */
    const double t34 = JLT_FMS(t13, t30, t33); /* v_tau*C - v_nu*S */
    const double t35 = t9*t30; /* R*(omega3*gamma3*1/s - omega_n)*C */
    const double t36 = t10*t30; /* b*C */
    const double t37 = -t36; /* -b*C */
    const double t38 = t12*t30; /* R*s*C */
    const double t39 = -t38; /* -R*s*C */
    const double t40 = x[1]*t30; /* v_nu*C */
    const double t41 = JLT_FMA(t13, t27, t40); /* v_tau*S + v_nu*C */
    out[0] = t16;
    out[1] = t17;
    out[2] = t19;
    out[3] = t21;
    out[4] = t23;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t25;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t26;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = t29;
    out[19] = t30;
    out[20] = 0.0;
    out[21] = t31;
    out[22] = t32;
    out[23] = t34;
    out[24] = 0.0;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = t35;
    out[28] = t27;
    out[29] = 0.0;
    out[30] = t37;
    out[31] = t39;
    out[32] = t41;
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
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double u47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double u49[JLT_JET_ORDER_MAX + 1];
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
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t7[k] = jlt_jet_product(x2, t6, k);
        t11[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t14[k] = t5[k]*p[6] + (k == 0 ? p[4] : 0);
        t15[k] = jlt_jet_product(t6, t14, k);
        t16[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t15, t16, k);
        t17[k] = jlt_jet_product(t14, t16, k);
        t18[k] = jlt_jet_product(x3, t17, k);
        t20[k] = p[1]*x4[k];
        t21[k] = jlt_jet_product(t11, t18, k) + t20[k];
        t22[k] = jlt_jet_product(x3, t21, k);
        t24[k] = jlt_jet_product(x0, t18, k);
        t26[k] = t6[k]*p[8];
        t28[k] = jlt_jet_product(x2, x0, k);
        t29[k] = p[9]*t28[k];
        t30[k] = t26[k] - jlt_jet_product(t7, t29, k);
        t31[k] = jlt_jet_product(x3, t24, k) + t30[k];
        t32[k] = t6[k]*p[7];
        t33[k] = jlt_jet_product(t16, t32, k);
        t34[k] = jlt_jet_product(t31, t33, k);
        t35[k] = jlt_jet_product(x2, t24, k);
        t36[k] = jlt_jet_product(x4, t28, k);
        t39[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t40[k] = jlt_jet_product(x2, t39, k) + x1[k];
        t41[k] = p[10]*t40[k];
        t42[k] = t36[k] - jlt_jet_product(t18, t41, k);
        t43[k] = jlt_jet_product(t17, t42, k);
        t44[k] = -t18[k];
        t45[k] = x4[k] + t24[k];
        t47[k] = jlt_jet_cosine(x5, t47, u47, k);
        t48[k] = jlt_jet_product(x1, t47, k);
        t49[k] = jlt_jet_sine(x5, t49, u49, k);
        t50[k] = jlt_jet_product(x3, t11, k);
        t51[k] = jlt_jet_product(t6, t20, k) + t50[k];
        t52[k] = jlt_jet_product(t49, t51, k) + t48[k];
        t53[k] = jlt_jet_product(x1, t49, k);
        t54[k] = t53[k] - jlt_jet_product(t47, t51, k);
        double *restrict next = coefficients + (k + 1)*9;
        next[0] = x0[k + 1] = t7[k]/(k + 1);
        next[1] = x1[k + 1] = t22[k]/(k + 1);
        next[2] = x2[k + 1] = t34[k]/(k + 1);
        next[3] = x3[k + 1] = t35[k]/(k + 1);
        next[4] = x4[k + 1] = t43[k]/(k + 1);
        next[5] = x5[k + 1] = t44[k]/(k + 1);
        next[6] = x6[k + 1] = t45[k]/(k + 1);
        next[7] = x7[k + 1] = t52[k]/(k + 1);
        next[8] = x8[k + 1] = t54[k]/(k + 1);
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
    .state_count = 9, .param_count = 6, .block_count = 24,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 9, { 4, 21, 11, 1, 1, 2, 10, 12 }, { 14, 41, 0, 9, 1, 2, 9, 7 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .jacobian = { jacobian, 81, { 10, 47, 18, 1, 1, 2, 13, 17 }, { 32, 144, 0, 33, 1, 2, 15, 9 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .rhs_jacobian = { rhs_jacobian, 90, { 16, 55, 19, 1, 1, 2, 12, 23 }, { 40, 174, 0, 42, 1, 2, 15, 12 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .divergence = { divergence, 1, { 2, 7, 2, 1, 1, 0, 8, 5 }, { 3, 12, 0, 2, 1, 0, 9, 5 },
        "divides by s: grows without bound, and so do rounding errors, where it vanishes; takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_values = { integral_values, 4, { 2, 12, 9, 0, 1, 2, 6, 8 }, { 10, 31, 0, 0, 1, 2, 11, 6 },
        "takes s = sqrt(1 - gamma3^2): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 36, { 5, 24, 9, 1, 1, 2, 9, 11 }, { 14, 46, 0, 2, 1, 2, 8, 9 },
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
