/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124
 *  Command:    ttc generate --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 6   27   15    1    0    2     10   11   (125)
 *  jacobian            15   82   35    1    0    2     14   25   (531)
 *  rhs_jacobian        18   87   37    1    0    2      9   28   (628)
 *  divergence          0    8    9    1    0    0      8    7   (53)
 *  integral_values     0   12    9    0    0    0      5    7   (40)
 *  integral_gradients  0   15    7    0    0    0      5    5   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_track[];
extern const jlt_descriptor jlt_kernels_spherical_top_track_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_general_in_regular_avx512;

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
    out[6] = t2;
    const double t3 = t0*params[4]; /* R*R*I1 */
    const double t4 = params[5]/t3; /* I3/(R*R*I1) */
    out[7] = t4;
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[16] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[8] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[9] = t8;
    const double t9 = params[0]*params[2]; /* m*g */
    const double t10 = params[3]*t9; /* a3*m*g */
    out[23] = t10;
    const double t11 = t10/params[4]; /* a3*m*g/I1 */
    out[10] = t11;
    const double t12 = params[1]*params[4]; /* R*I1 */
    out[49] = t12;
    const double t13 = params[5]/t12; /* I3/(R*I1) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[39] = t14;
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[12] = t15;
    const double t16 = params[5]*params[3]; /* I3*a3 */
    const double t17 = t16/t12; /* I3*a3/(R*I1) */
    out[13] = t17;
    const double t18 = params[4] - params[5]; /* I1 - I3 */
    const double t19 = t18/params[4]; /* (I1 - I3)/I1 */
    out[14] = t19;
    const double t20 = 1.0/params[1]; /* 1/R */
    out[15] = t20;
    const double t21 = params[5]*params[4]; /* I3*I1 */
    out[17] = t21;
    const double t22 = t1*params[4]; /* m*R*R*I1 */
    out[18] = t22;
    const double t23 = params[0]*params[5]; /* m*I3 */
    out[19] = t23;
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t5*t24; /* a3*a3*m*2 */
    out[20] = t25;
    const double t26 = params[4]*2.0; /* I1*2 */
    out[21] = t26;
    const double t27 = -params[5]; /* -I3 */
    out[22] = t27;
    const double t28 = params[4]*t25; /* I1*a3*a3*m*2 */
    out[24] = t28;
    const double t29 = params[3]*t14; /* a3*m*R */
    const double t30 = params[5]*t29; /* I3*a3*m*R */
    out[25] = t30;
    const double t31 = params[0]*params[3]; /* m*a3 */
    const double t32 = params[5]*t31; /* I3*m*a3 */
    out[26] = t32;
    const double t33 = params[5]*t14; /* I3*m*R */
    out[27] = t33;
    const double t34 = params[1]*2.0; /* R*2 */
    out[28] = t34;
    const double t35 = params[0]*params[0]; /* m*m */
    const double t36 = t0*t35; /* R*R*m*m */
    const double t37 = params[4]*t36; /* I1*R*R*m*m */
    const double t38 = params[5]*t37; /* I3*I1*R*R*m*m */
    out[29] = t38;
    const double t39 = params[5]*t36; /* I3*R*R*m*m */
    out[30] = t39;
    const double t40 = params[3]*2.0; /* a3*2 */
    const double t41 = params[5]*t40; /* I3*a3*2 */
    out[31] = t41;
    const double t42 = t18*t34; /* (I1 - I3)*R*2 */
    out[32] = t42;
    const double t43 = params[4]*t29; /* I1*a3*m*R */
    out[33] = t43;
    const double t44 = t1*t18; /* m*R*R*(I1 - I3) */
    out[34] = t44;
    const double t45 = params[4]*t14; /* I1*m*R */
    out[35] = t45;
    const double t46 = -t45; /* -I1*m*R */
    out[36] = t46;
    const double t47 = 2.0*t35; /* 2*m*m */
    const double t48 = params[1]*t0; /* R*R*R */
    const double t49 = t47*t48; /* 2*m*m*R*R*R */
    const double t50 = params[4]*params[4]; /* I1*I1 */
    const double t51 = t49*t50; /* 2*m*m*R*R*R*I1*I1 */
    out[37] = t51;
    const double t52 = 1.0/t26; /* 1/(I1*2) */
    out[38] = t52;
    const double t53 = params[5]*params[5]; /* I3*I3 */
    out[40] = t53;
    const double t54 = params[2]*t24; /* g*m*2 */
    const double t55 = params[3]*t54; /* a3*g*m*2 */
    out[41] = t55;
    const double t56 = params[1]*t24; /* R*m*2 */
    const double t57 = params[5]*t56; /* I3*R*m*2 */
    out[42] = t57;
    const double t58 = t0*t24; /* R*R*m*2 */
    const double t59 = params[4]*t58; /* I1*R*R*m*2 */
    out[43] = t59;
    const double t60 = t18*t58; /* (I1 - I3)*R*R*m*2 */
    out[44] = t60;
    const double t61 = params[3]*t56; /* a3*R*m*2 */
    const double t62 = params[5]*t61; /* I3*a3*R*m*2 */
    out[45] = t62;
    const double t63 = params[0]/2.0; /* m/2 */
    out[46] = t63;
    const double t64 = params[4]/2.0; /* I1/2 */
    out[47] = t64;
    const double t65 = params[5]/2.0; /* I3/2 */
    out[48] = t65;
    const double t66 = params[1]*params[5]; /* R*I3 */
    const double t67 = -t66; /* -R*I3 */
    out[50] = t67;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t1;
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[9]*x[4]; /* s*omega3 */
    const double t5 = JLT_FMA(p[1], t4, t3); /* R*s*omega3 + omega_n*b */
    const double t6 = x[3]*t5; /* omega_n*(R*s*omega3 + omega_n*b) */
    out[1] = t6;
    const double t7 = t2*p[7]; /* b*I3/(R^2*I1) */
    const double t8 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t9 = JLT_FMA(t2, t7, t8); /* Theta/(m*R^2*I1) = b*b*I3/(R^2*I1) + s*s + I3/(m*R^2) */
    const double t10 = x[2]*x[9]; /* omega_tau*s */
    const double t11 = x[0]*t10; /* gamma3*omega_tau*s */
    const double t12 = p[8]*t10; /* m*a3^2/I1*omega_tau*s */
    const double t13 = t11*t12; /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s */
    const double t14 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t15 = JLT_FMA(t4, p[9], t14); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t16 = JLT_FNMA(t0, p[10], t13); /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s - s*s*m*g*a3/I1 */
    const double t17 = JLT_FNMA(x[3], t15, t16); /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s - s*s*m*g*a3/I1 - omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t18 = JLT_FMA(t0, p[8], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t19 = t9*t18; /* Theta/(m*R^2*I1)*D/I1 */
    const double t20 = 1.0/t19; /* 1/(Theta/(m*R^2*I1)*D/I1) */
    const double t21 = t9*t17; /* Theta/(m*R^2*I1)*t17 */
    const double t22 = t20*t21; /* 1/(Theta/(m*R^2*I1)*D/I1)*Theta/(m*R^2*I1)*t17 */
    out[2] = t22;
    const double t23 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t24 = p[12] + t23; /* I3/(m*R) + e */
    const double t25 = t18*t20; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t26 = t4*t25; /* s*omega3*1/(Theta/(m*R^2*I1)) */
    const double t27 = p[11]*t24; /* I3/(R*I1)*(I3/(m*R) + e) */
    const double t28 = JLT_FMA(t26, t27, t14); /* s*omega3*1/(Theta/(m*R^2*I1))*I3/(R*I1)*(I3/(m*R) + e) + omega_n*gamma3 */
    const double t29 = x[2]*t28; /* omega_tau*t28 */
    const double t30 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t31 = x[3]*t30; /* omega_n*V */
    const double t32 = t25*t31; /* 1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t33 = JLT_FNMA(t7, t32, t29); /* omega_tau*t28 - b*I3/(R^2*I1)*1/(Theta/(m*R^2*I1))*omega_n*V */
    out[3] = t33;
    const double t34 = JLT_FNMA(x[0], p[14], p[13]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t35 = t10*t34; /* omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t36 = t26*t35; /* s*omega3*1/(Theta/(m*R^2*I1))*omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t37 = x[9]*p[15]; /* s*1/R */
    const double t38 = JLT_FMA(t32, t37, t36); /* 1/(Theta/(m*R^2*I1))*omega_n*V*s*1/R + t36 */
    const double t39 = -t38; /* -(1/(Theta/(m*R^2*I1))*omega_n*V*s*1/R + t36) */
    out[4] = t39;
    const double t40 = -x[3]; /* -omega_n */
    out[5] = t40;
    const double t41 = t4 + t14; /* s*omega3 + omega_n*gamma3 */
    out[6] = t41;
    const double t42 = cos(x[5]); /* C = cos(chi) */
    const double t43 = x[1]*t42; /* v_nu*C */
    const double t44 = sin(x[5]); /* S = sin(chi) */
    const double t45 = JLT_FMA(t5, t44, t43); /* (R*s*omega3 + omega_n*b)*S + v_nu*C */
    const double t46 = x[9]*t45; /* s*((R*s*omega3 + omega_n*b)*S + v_nu*C) */
    out[7] = t46;
    const double t47 = x[1]*t44; /* v_nu*S */
    const double t48 = JLT_FNMA(t5, t42, t47); /* v_nu*S - (R*s*omega3 + omega_n*b)*C */
    const double t49 = x[9]*t48; /* s*(v_nu*S - (R*s*omega3 + omega_n*b)*C) */
    out[8] = t49;
    const double t50 = -t11; /* -gamma3*omega_tau*s */
    out[9] = t50;
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
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
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
    const double t0 = x[9]*x[9]; /* s*s */
    out[2] = t0;
    const double t1 = x[9]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[9] = t2;
    out[60] = x[3];
    const double t3 = x[3]*p[1]; /* omega_n*R */
    const double t4 = x[3]*t3; /* omega_n*omega_n*R */
    out[10] = t4;
    out[63] = x[0];
    const double t5 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t6 = x[3]*t5; /* omega_n*b */
    out[69] = x[4];
    const double t7 = x[9]*p[1]; /* s*R */
    const double t8 = x[4]*t7; /* omega3*s*R */
    const double t9 = JLT_FMA(2.0, t6, t8); /* 2*omega_n*b + omega3*s*R */
    out[13] = t9;
    const double t10 = x[3]*t7; /* omega_n*s*R */
    out[14] = t10;
    const double t11 = t3*x[4]; /* omega_n*R*omega3 */
    out[19] = t11;
    const double t12 = t5*p[19]; /* b*m*I3 */
    const double t13 = JLT_FMA(t0, p[18], p[17]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t14 = JLT_FMA(t5, t12, t13); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t15 = JLT_FMA(t0, p[16], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t16 = t14*t15; /* Theta*D */
    const double t17 = 1.0/t16; /* 1/(Theta*D) */
    const double t18 = t14*t17; /* 1/D = Theta*1/(Theta*D) */
    const double t19 = t1*p[16]; /* s*omega_tau*m*a3^2 */
    const double t20 = t18*t19; /* 1/D*s*omega_tau*m*a3^2 */
    const double t21 = t1*t20; /* s*omega_tau*1/D*s*omega_tau*m*a3^2 */
    const double t22 = x[3]*t18; /* omega_n*1/D */
    const double t23 = x[3]*p[4]; /* omega_n*I1 */
    const double t24 = JLT_FNMA(t22, t23, t21); /* s*omega_tau*1/D*s*omega_tau*m*a3^2 - omega_n*1/D*omega_n*I1 */
    out[20] = t24;
    const double t25 = x[9]*t18; /* s*1/D */
    const double t26 = x[9]*p[20]; /* s*2*m*a3^2 */
    const double t27 = t25*t26; /* s*1/D*s*2*m*a3^2 */
    const double t28 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t29 = t27*t28; /* s*1/D*s*2*m*a3^2*omega_tau*gamma3 */
    out[22] = t29;
    const double t30 = x[0]*p[21]; /* gamma3*2*I1 */
    const double t31 = t22*t30; /* omega_n*1/D*gamma3*2*I1 */
    const double t32 = x[4]*p[5]; /* omega3*I3 */
    const double t33 = JLT_FMA(t25, t32, t31); /* s*1/D*omega3*I3 + omega_n*1/D*gamma3*2*I1 */
    const double t34 = -t33; /* -(s*1/D*omega3*I3 + omega_n*1/D*gamma3*2*I1) */
    out[23] = t34;
    const double t35 = x[9]*p[22]; /* s*(-I3) */
    const double t36 = t22*t35; /* omega_n*1/D*s*(-I3) */
    out[24] = t36;
    const double t37 = 2.0 - t27; /* 2 - s*1/D*s*2*m*a3^2 */
    const double t38 = t20*t28; /* 1/D*s*omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t39 = JLT_FNMA(t25, p[23], t38); /* 1/D*s*omega_tau*m*a3^2*omega_tau*gamma3 - s*1/D*m*g*a3 */
    const double t40 = t37*t39; /* (2 - s*1/D*s*2*m*a3^2)*(1/D*s*omega_tau*m*a3^2*omega_tau*gamma3 - s*1/D*m*g*a3) */
    const double t41 = x[9]*x[0]; /* s*gamma3 */
    const double t42 = p[24]*t41; /* 2*m*a3^2*I1*s*gamma3 */
    const double t43 = JLT_FMS(t22, t42, t32); /* omega_n*1/D*2*m*a3^2*I1*s*gamma3 - omega3*I3 */
    const double t44 = JLT_FMA(t27, t32, t43); /* s*1/D*s*2*m*a3^2*omega3*I3 + omega_n*1/D*2*m*a3^2*I1*s*gamma3 - omega3*I3 */
    const double t45 = JLT_FMA(t22, t44, t40); /* omega_n*1/D*t44 + t40 */
    out[29] = t45;
    const double t46 = t15*t17; /* 1/Theta = D*1/(Theta*D) */
    const double t47 = x[9]*t46; /* s*1/Theta */
    const double t48 = x[2]*t47; /* omega_tau*s*1/Theta */
    const double t49 = x[4]*t48; /* omega3*omega_tau*s*1/Theta */
    const double t50 = p[25]*t49; /* m*R*a3*I3*omega3*omega_tau*s*1/Theta */
    const double t51 = t6*t46; /* omega_n*b*1/Theta */
    const double t52 = JLT_FNMA(p[26], t51, x[3]); /* omega_n - m*a3*I3*omega_n*b*1/Theta */
    const double t53 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t54 = p[12] + t53; /* I3/(m*R) + e */
    const double t55 = p[28]*t54; /* 2*R*(I3/(m*R) + e) */
    const double t56 = t49*t55; /* omega3*omega_tau*s*1/Theta*2*R*(I3/(m*R) + e) */
    const double t57 = JLT_FMA(x[2], t53, x[1]); /* V = omega_tau*e + v_nu */
    const double t58 = t46*t57; /* 1/Theta*V */
    const double t59 = t6*t58; /* omega_n*b*1/Theta*V */
    const double t60 = JLT_FNMA(2.0, t59, t56); /* omega3*omega_tau*s*1/Theta*2*R*(I3/(m*R) + e) - 2*omega_n*b*1/Theta*V */
    const double t61 = t12*t60; /* b*m*I3*t60 */
    const double t62 = JLT_FMA(x[3], t57, t61); /* omega_n*V + b*m*I3*t60 */
    const double t63 = t46*p[27]; /* 1/Theta*m*R*I3 */
    const double t64 = JLT_FMA(x[2], t52, t50); /* omega_tau*(omega_n - m*a3*I3*omega_n*b*1/Theta) + m*R*a3*I3*omega3*omega_tau*s*1/Theta */
    const double t65 = JLT_FNMA(t62, t63, t64); /* t64 - (omega_n*V + b*m*I3*t60)*1/Theta*m*R*I3 */
    out[30] = t65;
    const double t66 = p[19]*t51; /* m*I3*omega_n*b*1/Theta */
    const double t67 = -t66; /* -m*I3*omega_n*b*1/Theta */
    out[31] = t67;
    const double t68 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t69 = p[27]*t54; /* m*R*I3*(I3/(m*R) + e) */
    const double t70 = x[4]*t47; /* omega3*s*1/Theta */
    const double t71 = JLT_FNMA(t53, t66, t68); /* omega_n*gamma3 - e*m*I3*omega_n*b*1/Theta */
    const double t72 = JLT_FMA(t69, t70, t71); /* m*R*I3*(I3/(m*R) + e)*omega3*s*1/Theta + omega_n*gamma3 - e*m*I3*omega_n*b*1/Theta */
    out[32] = t72;
    const double t73 = JLT_FNMA(t12, t58, t28); /* omega_tau*gamma3 - b*m*I3*1/Theta*V */
    out[33] = t73;
    const double t74 = t48*t69; /* omega_tau*s*1/Theta*m*R*I3*(I3/(m*R) + e) */
    out[34] = t74;
    const double t75 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t76 = t69*t75; /* m*R*I3*(I3/(m*R) + e)*omega_tau*omega3 */
    const double t77 = t46*t76; /* 1/Theta*m*R*I3*(I3/(m*R) + e)*omega_tau*omega3 */
    const double t78 = t47*p[29]; /* s*1/Theta*m^2*R^2*I1*I3 */
    const double t79 = JLT_FNMA(t60, t78, t77); /* 1/Theta*m*R*I3*(I3/(m*R) + e)*omega_tau*omega3 - t60*s*1/Theta*m^2*R^2*I1*I3 */
    out[39] = t79;
    const double t80 = JLT_FNMA(x[0], p[32], p[31]); /* 2*a3*I3 - gamma3*2*R*(I1 - I3) */
    const double t81 = t49*t80; /* omega3*omega_tau*s*1/Theta*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t82 = t5*t81; /* b*omega3*omega_tau*s*1/Theta*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t83 = JLT_FMA(p[21], t59, t82); /* 2*I1*omega_n*b*1/Theta*V + t82 */
    const double t84 = t47*p[30]; /* s*1/Theta*m^2*R^2*I3 */
    const double t85 = x[3]*p[33]; /* omega_n*m*R*a3*I1 */
    const double t86 = t48*t85; /* omega_tau*s*1/Theta*omega_n*m*R*a3*I1 */
    const double t87 = x[9]*t49; /* s*omega3*omega_tau*s*1/Theta */
    const double t88 = JLT_FMS(p[34], t87, t86); /* m*R^2*(I1 - I3)*s*omega3*omega_tau*s*1/Theta - omega_tau*s*1/Theta*omega_n*m*R*a3*I1 */
    const double t89 = JLT_FMA(t83, t84, t88); /* (2*I1*omega_n*b*1/Theta*V + t82)*s*1/Theta*m^2*R^2*I3 + t88 */
    out[40] = t89;
    const double t90 = x[3]*p[35]; /* omega_n*m*R*I1 */
    const double t91 = t47*t90; /* s*1/Theta*omega_n*m*R*I1 */
    const double t92 = -t91; /* -s*1/Theta*omega_n*m*R*I1 */
    out[41] = t92;
    const double t93 = x[9]*p[25]; /* s*m*R*a3*I3 */
    const double t94 = JLT_FNMA(t41, p[34], t93); /* s*m*R*a3*I3 - s*gamma3*m*R^2*(I1 - I3) */
    const double t95 = t70*t94; /* omega3*s*1/Theta*(s*m*R*a3*I3 - s*gamma3*m*R^2*(I1 - I3)) */
    const double t96 = JLT_FMA(t53, t91, t95); /* e*s*1/Theta*omega_n*m*R*I1 + omega3*s*1/Theta*(s*m*R*a3*I3 - s*gamma3*m*R^2*(I1 - I3)) */
    const double t97 = -t96; /* -t96 */
    out[42] = t97;
    const double t98 = t47*t57; /* s*1/Theta*V */
    const double t99 = p[36]*t98; /* (-m*R*I1)*s*1/Theta*V */
    out[43] = t99;
    const double t100 = t48*t94; /* omega_tau*s*1/Theta*(s*m*R*a3*I3 - s*gamma3*m*R^2*(I1 - I3)) */
    const double t101 = -t100; /* -omega_tau*s*1/Theta*(s*m*R*a3*I3 - s*gamma3*m*R^2*(I1 - I3)) */
    out[44] = t101;
    const double t102 = t58*t90; /* 1/Theta*V*omega_n*m*R*I1 */
    const double t103 = x[3]*t98; /* omega_n*s*1/Theta*V */
    const double t104 = t80*p[38]; /* (2*a3*I3 - gamma3*2*R*(I1 - I3))*1/2/I1 */
    const double t105 = JLT_FMA(t87, t104, t103); /* s*omega3*omega_tau*s*1/Theta*(2*a3*I3 - gamma3*2*R*(I1 - I3))*1/2/I1 + omega_n*s*1/Theta*V */
    const double t106 = t47*p[37]; /* s*1/Theta*2*m^2*R^3*I1^2 */
    const double t107 = JLT_FMS(t105, t106, t102); /* t105*s*1/Theta*2*m^2*R^3*I1^2 - 1/Theta*V*omega_n*m*R*I1 */
    const double t108 = JLT_FNMA(t81, p[39], t107); /* t105*s*1/Theta*2*m^2*R^3*I1^2 - 1/Theta*V*omega_n*m*R*I1 - omega3*omega_tau*s*1/Theta*(2*a3*I3 - gamma3*2*R*(I1 - I3))*m*R */
    out[49] = t108;
    out[53] = (-1.0);
    const double t109 = sin(x[5]); /* S = sin(chi) */
    const double t110 = t10*t109; /* omega_n*s*R*S */
    out[70] = t110;
    const double t111 = cos(x[5]); /* C = cos(chi) */
    const double t112 = x[9]*t111; /* s*C */
    out[71] = t112;
    const double t113 = x[9]*t109; /* s*S */
    out[81] = t113;
    const double t114 = t5*t113; /* b*s*S */
    out[73] = t114;
    const double t115 = t7*t113; /* s*R*s*S */
    out[74] = t115;
    const double t116 = x[1]*t113; /* v_nu*s*S */
    const double t117 = t6 + t8; /* v_tau = omega_n*b + omega3*s*R */
    const double t118 = JLT_FMS(t112, t117, t116); /* s*C*v_tau - v_nu*s*S */
    out[75] = t118;
    const double t119 = x[1]*t111; /* v_nu*C */
    const double t120 = t8 + t117; /* omega3*s*R + v_tau */
    const double t121 = JLT_FMA(t109, t120, t119); /* S*(omega3*s*R + v_tau) + v_nu*C */
    out[79] = t121;
    const double t122 = t10*t111; /* omega_n*s*R*C */
    const double t123 = -t122; /* -omega_n*s*R*C */
    out[80] = t123;
    const double t124 = t5*t112; /* b*s*C */
    const double t125 = -t124; /* -b*s*C */
    out[83] = t125;
    const double t126 = t7*t112; /* s*R*s*C */
    const double t127 = -t126; /* -s*R*s*C */
    out[84] = t127;
    const double t128 = x[1]*t112; /* v_nu*s*C */
    const double t129 = JLT_FMA(t113, t117, t128); /* s*S*v_tau + v_nu*s*C */
    out[85] = t129;
    const double t130 = x[1]*t109; /* v_nu*S */
    const double t131 = JLT_FNMA(t111, t120, t130); /* v_nu*S - C*(omega3*s*R + v_tau) */
    out[89] = t131;
    const double t132 = -t1; /* -s*omega_tau */
    out[90] = t132;
    const double t133 = -t41; /* -s*gamma3 */
    out[92] = t133;
    const double t134 = -t28; /* -omega_tau*gamma3 */
    out[99] = t134;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[74] = x[9];
    out[70] = x[3];
    out[79] = x[4];
    out[73] = x[0];
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
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
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
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = x[9]*x[9]; /* s*s */
    out[12] = t2;
    const double t3 = p[19]*t1; /* m*I3*b */
    const double t4 = JLT_FMA(p[18], t2, p[17]); /* m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(t1, t3, t4); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t6 = JLT_FMA(p[16], t2, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t7 = t5*t6; /* Theta*D */
    const double t8 = 1.0/t7; /* 1/(Theta*D) */
    const double t9 = t5*t8; /* 1/D = Theta*1/(Theta*D) */
    const double t10 = t6*t8; /* 1/Theta = D*1/(Theta*D) */
    const double t11 = x[9]*x[2]; /* s*omega_tau */
    const double t12 = 2.0*t11; /* 2*s*omega_tau */
    out[19] = t12;
    const double t13 = -t11; /* -s*omega_tau */
    out[100] = t13;
    const double t14 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t15 = x[9]*x[4]; /* s*omega3 */
    const double t16 = p[16]*t11; /* m*a3^2*s*omega_tau */
    const double t17 = t11*t16; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t18 = JLT_FMA(x[2], t14, x[1]); /* V = omega_tau*e + v_nu */
    const double t19 = x[4]*t11; /* omega3*s*omega_tau */
    const double t20 = x[9]*x[3]; /* s*omega_n */
    const double t21 = x[0]*t11; /* gamma3*s*omega_tau */
    const double t22 = -t21; /* -gamma3*s*omega_tau */
    out[9] = t22;
    const double t23 = x[2]*p[20]; /* omega_tau*2*m*a3^2 */
    const double t24 = t21*t23; /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 */
    const double t25 = JLT_FNMA(x[9], p[41], t24); /* gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t26 = x[4]*p[44]; /* omega3*2*m*R^2*(I1 - I3) */
    const double t27 = t21*t26; /* gamma3*s*omega_tau*omega3*2*m*R^2*(I1 - I3) */
    const double t28 = JLT_FNMA(p[45], t19, t27); /* gamma3*s*omega_tau*omega3*2*m*R^2*(I1 - I3) - 2*m*R*a3*I3*omega3*s*omega_tau */
    const double t29 = p[1]*t15; /* R*s*omega3 */
    const double t30 = x[3]*t1; /* omega_n*b */
    const double t31 = JLT_FMA(2.0, t30, t29); /* 2*omega_n*b + R*s*omega3 */
    out[23] = t31;
    const double t32 = x[3]*x[3]; /* omega_n*omega_n */
    const double t33 = JLT_FNMA(p[4], t32, t17); /* s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n */
    const double t34 = p[1]*t32; /* R*omega_n*omega_n */
    out[20] = t34;
    const double t35 = t9*t33; /* 1/D*(s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n) */
    out[30] = t35;
    const double t36 = p[23]*t2; /* m*g*a3*s*s */
    const double t37 = p[1]*t2; /* R*s*s */
    const double t38 = p[5]*t15; /* I3*s*omega3 */
    const double t39 = JLT_FMA(x[3], t38, t36); /* omega_n*I3*s*omega3 + m*g*a3*s*s */
    const double t40 = JLT_FNMA(x[0], t33, t39); /* omega_n*I3*s*omega3 + m*g*a3*s*s - gamma3*(s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n) */
    const double t41 = p[19]*t18; /* m*I3*V */
    const double t42 = p[35]*t20; /* m*R*I1*s*omega_n */
    const double t43 = JLT_FNMA(x[0], p[34], p[25]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t44 = sin(x[5]); /* S = sin(chi) */
    const double t45 = t37*t44; /* R*s*s*S */
    out[84] = t45;
    const double t46 = p[25]*t19; /* m*R*a3*I3*omega3*s*omega_tau */
    const double t47 = x[2]*p[26]; /* omega_tau*m*a3*I3 */
    const double t48 = JLT_FNMA(t30, t47, t46); /* m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 */
    const double t49 = x[3]*p[33]; /* omega_n*m*R*a3*I1 */
    const double t50 = t11*t49; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t51 = x[9]*t11; /* s*s*omega_tau */
    out[0] = t51;
    const double t52 = t43*t51; /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*s*omega_tau */
    const double t53 = t15*t43; /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t54 = t10*t52; /* 1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*s*omega_tau */
    const double t55 = -t54; /* -1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*s*omega_tau */
    out[54] = t55;
    const double t56 = t29 + t30; /* R*s*omega3 + omega_n*b */
    const double t57 = x[3]*t56; /* omega_n*(R*s*omega3 + omega_n*b) */
    out[1] = t57;
    const double t58 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t59 = JLT_FMA(p[21], t58, t38); /* 2*I1*omega_n*gamma3 + I3*s*omega3 */
    const double t60 = t9*t59; /* 1/D*(2*I1*omega_n*gamma3 + I3*s*omega3) */
    const double t61 = -t60; /* -1/D*(2*I1*omega_n*gamma3 + I3*s*omega3) */
    out[33] = t61;
    const double t62 = t15 + t58; /* s*omega3 + omega_n*gamma3 */
    out[6] = t62;
    const double t63 = t30*t41; /* omega_n*b*m*I3*V */
    const double t64 = p[19]*t30; /* m*I3*omega_n*b */
    const double t65 = JLT_FMA(p[27], t14, p[40]); /* m*R*I3*e + I3^2 */
    const double t66 = JLT_FMS(t19, t65, t63); /* numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*(m*R*I3*e + I3^2) - omega_n*b*m*I3*V */
    const double t67 = t10*t66; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t68 = JLT_FMA(x[2], t58, t67); /* omega_tau*omega_n*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t68;
    const double t69 = t18*t42; /* V*m*R*I1*s*omega_n */
    const double t70 = JLT_FMA(t11, t53, t69); /* s*omega_tau*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*m*R*I1*s*omega_n */
    const double t71 = t10*t70; /* 1/Theta*t70 */
    const double t72 = -t71; /* -1/Theta*t70 */
    out[4] = t72;
    const double t73 = cos(x[5]); /* C = cos(chi) */
    const double t74 = t37*t73; /* R*s*s*C */
    const double t75 = -t74; /* -R*s*s*C */
    out[94] = t75;
    const double t76 = x[1]*t44; /* v_nu*S */
    const double t77 = JLT_FNMA(t56, t73, t76); /* v_nu*S - (R*s*omega3 + omega_n*b)*C */
    const double t78 = JLT_FNMA(t29, t73, t77); /* v_nu*S - (R*s*omega3 + omega_n*b)*C - R*s*omega3*C */
    out[99] = t78;
    const double t79 = x[9]*t77; /* s*(v_nu*S - (R*s*omega3 + omega_n*b)*C) */
    out[8] = t79;
    const double t80 = -t79; /* -s*(v_nu*S - (R*s*omega3 + omega_n*b)*C) */
    out[85] = t80;
    const double t81 = x[3]*x[4]; /* omega_n*omega3 */
    const double t82 = JLT_FNMA(p[5], t81, t25); /* d(numerator of d(omega_tau)/dt over D)/d(s) = gamma3*s*omega_tau*omega_tau*2*m*a3^2 - s*2*m*g*a3 - I3*omega_n*omega3 */
    const double t83 = p[1]*t81; /* R*omega_n*omega3 */
    out[29] = t83;
    const double t84 = x[9]*p[20]; /* s*2*m*a3^2 */
    const double t85 = t9*t84; /* 1/D*s*2*m*a3^2 */
    const double t86 = t21*t85; /* gamma3*s*omega_tau*1/D*s*2*m*a3^2 */
    out[32] = t86;
    const double t87 = JLT_FMA(t40, t85, t82); /* t40*1/D*s*2*m*a3^2 + d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t88 = t9*t87; /* 1/D*t87 */
    out[39] = t88;
    const double t89 = t9*t40; /* 1/D*t40 */
    const double t90 = -t89; /* -1/D*t40 */
    out[2] = t90;
    const double t91 = x[3]*t18; /* omega_n*V */
    const double t92 = JLT_FNMA(p[27], t91, t48); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 - m*R*I3*omega_n*V */
    const double t93 = JLT_FNMA(p[35], t91, t28); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t28 - m*R*I1*omega_n*V */
    const double t94 = p[36]*t18; /* (-m*R*I1)*V */
    const double t95 = t10*t93; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t96 = p[34]*t15; /* m*R^2*(I1 - I3)*s*omega3 */
    const double t97 = JLT_FMS(t11, t96, t50); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = s*omega_tau*m*R^2*(I1 - I3)*s*omega3 - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t98 = t10*t97; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t99 = t14*t42; /* e*m*R*I1*s*omega_n */
    const double t100 = JLT_FMA(x[9], t53, t99); /* s*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*m*R*I1*s*omega_n */
    const double t101 = t14*t64; /* e*m*I3*omega_n*b */
    const double t102 = JLT_FMS(t15, t65, t101); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(m*R*I3*e + I3^2) - e*m*I3*omega_n*b */
    const double t103 = JLT_FMA(t10, t102, t58); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[42] = t103;
    const double t104 = t10*t65; /* 1/Theta*(m*R*I3*e + I3^2) */
    const double t105 = t11*t104; /* s*omega_tau*1/Theta*(m*R*I3*e + I3^2) */
    out[44] = t105;
    const double t106 = t10*t64; /* 1/Theta*m*I3*omega_n*b */
    const double t107 = -t106; /* -1/Theta*m*I3*omega_n*b */
    out[41] = t107;
    const double t108 = t10*t42; /* 1/Theta*m*R*I1*s*omega_n */
    const double t109 = -t108; /* -1/Theta*m*R*I1*s*omega_n */
    out[51] = t109;
    const double t110 = t10*t100; /* 1/Theta*t100 */
    const double t111 = -t110; /* -1/Theta*t100 */
    out[52] = t111;
    const double t112 = x[1]*t73; /* v_nu*C */
    const double t113 = JLT_FMA(t44, t56, t112); /* S*(R*s*omega3 + omega_n*b) + v_nu*C */
    const double t114 = JLT_FMA(t29, t44, t113); /* R*s*omega3*S + S*(R*s*omega3 + omega_n*b) + v_nu*C */
    out[89] = t114;
    const double t115 = x[9]*t113; /* s*(S*(R*s*omega3 + omega_n*b) + v_nu*C) */
    out[7] = t115;
    out[95] = t115;
    const double t116 = p[1]*t20; /* R*s*omega_n */
    out[24] = t116;
    const double t117 = p[22]*t20; /* (-I3)*s*omega_n */
    const double t118 = t9*t117; /* 1/D*(-I3)*s*omega_n */
    out[34] = t118;
    const double t119 = t44*t116; /* S*R*s*omega_n */
    out[80] = t119;
    const double t120 = x[9]*t44; /* s*S */
    out[91] = t120;
    const double t121 = t1*t120; /* b*s*S */
    out[83] = t121;
    const double t122 = t73*t116; /* C*R*s*omega_n */
    const double t123 = -t122; /* -C*R*s*omega_n */
    out[90] = t123;
    const double t124 = x[9]*t73; /* s*C */
    out[81] = t124;
    const double t125 = t1*t124; /* b*s*C */
    const double t126 = -t125; /* -b*s*C */
    out[93] = t126;
    const double t127 = t1*t10; /* b*1/Theta */
    const double t128 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t129 = JLT_FMA(t10, t92, t128); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(gamma3) + omega_tau*omega_n */
    const double t130 = x[9]*t10; /* s*1/Theta */
    const double t131 = t94*t130; /* (-m*R*I1)*V*s*1/Theta */
    out[53] = t131;
    const double t132 = p[43]*t130; /* 2*m*R^2*I1*s*1/Theta */
    const double t133 = JLT_FMA(t71, t132, t95); /* 1/Theta*t70*2*m*R^2*I1*s*1/Theta + 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    out[59] = t133;
    const double t134 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t135 = t104*t134; /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 */
    const double t136 = JLT_FNMA(t67, t132, t135); /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    out[49] = t136;
    const double t137 = p[42]*t127; /* 2*m*R*I3*b*1/Theta */
    const double t138 = JLT_FNMA(t67, t137, t129); /* t129 - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R*I3*b*1/Theta */
    out[40] = t138;
    const double t139 = JLT_FMA(t71, t137, t98); /* 1/Theta*t70*2*m*R*I3*b*1/Theta + 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    out[50] = t139;
    const double t140 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t141 = JLT_FNMA(t41, t127, t140); /* omega_tau*gamma3 - m*I3*V*b*1/Theta */
    out[43] = t141;
    const double t142 = -t140; /* -omega_tau*gamma3 */
    out[109] = t142;
    const double t143 = x[9]*x[0]; /* s*gamma3 */
    const double t144 = -t143; /* -s*gamma3 */
    out[102] = t144;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[0]*t1; /* gamma3*omega_tau*s*s */
    const double t4 = p[19]*t2; /* m*I3*b */
    const double t5 = JLT_FMA(p[18], t0, p[17]); /* m*R^2*I1*s*s + I1*I3 */
    const double t6 = JLT_FMA(t2, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t7 = JLT_FMA(p[16], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t8 = p[34]*t3; /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s */
    const double t9 = JLT_FNMA(p[25], t1, t8); /* d(numerator of d(omega3)/dt over Theta)/d(omega3) = m*R^2*(I1 - I3)*gamma3*omega_tau*s*s - m*R*a3*I3*omega_tau*s*s */
    const double t10 = p[20]*t3; /* 2*m*a3^2*gamma3*omega_tau*s*s */
    const double t11 = t6*t10; /* Theta*2*m*a3^2*gamma3*omega_tau*s*s */
    const double t12 = t6*t7; /* Theta*D */
    const double t13 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t14 = JLT_FMA(x[2], t13, x[1]); /* V = omega_tau*e + v_nu */
    const double t15 = JLT_FNMA(t4, t14, t9); /* d(numerator of d(omega3)/dt over Theta)/d(omega3) - m*I3*b*V */
    const double t16 = JLT_FMA(t7, t15, t11); /* D*(d(numerator of d(omega3)/dt over Theta)/d(omega3) - m*I3*b*V) + Theta*2*m*a3^2*gamma3*omega_tau*s*s */
    const double t17 = t16/t12; /* t16/(Theta*D) */
    out[0] = t17;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[23]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t2 = x[3]*p[47]; /* omega_n*1/2*I1 */
    const double t3 = JLT_FMA(x[3], t2, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t4 = x[3]*t1; /* omega_n*b */
    const double t5 = p[1]*x[9]; /* R*s */
    const double t6 = JLT_FMA(x[4], t5, t4); /* v_tau = omega3*R*s + omega_n*b */
    const double t7 = x[9]*p[16]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t10 = x[2]*t9; /* omega_tau*1/2*omega_tau */
    const double t11 = x[4]*p[48]; /* omega3*1/2*I3 */
    const double t12 = JLT_FMA(x[4], t11, t3); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t8, t10, t12); /* D*omega_tau*1/2*omega_tau + t12 */
    const double t14 = x[1]*x[1]; /* v_nu*v_nu */
    const double t15 = JLT_FMA(t6, t6, t14); /* v_tau*v_tau + v_nu*v_nu */
    const double t16 = JLT_FMA(p[46], t15, t13); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t12 */
    out[0] = t16;
    const double t17 = x[9]*p[49]; /* s*R*I1 */
    const double t18 = x[3]*t17; /* omega_n*s*R*I1 */
    const double t19 = x[4]*p[5]; /* omega3*I3 */
    const double t20 = JLT_FNMA(t1, t19, t18); /* omega_n*s*R*I1 - b*omega3*I3 */
    out[1] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
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
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = x[4]*p[50]; /* omega3*(-R*I3) */
    out[10] = t1;
    const double t2 = x[9]*p[49]; /* s*R*I1 */
    out[13] = t2;
    const double t3 = x[3]*p[49]; /* omega_n*R*I1 */
    out[19] = t3;
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = p[22]*t4; /* (-I3)*b */
    out[14] = t5;
    const double t6 = x[3]*t4; /* omega_n*b */
    const double t7 = p[0]*t4; /* m*b */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(x[9], t8, t6); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = x[9]*p[16]; /* s*m*a3^2 */
    const double t11 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t12 = t10*t11; /* s*m*a3^2*omega_tau*omega_tau */
    const double t13 = JLT_FMA(x[9], t10, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = x[2]*t13; /* omega_tau*D */
    out[2] = t14;
    const double t15 = p[39]*t9; /* m*R*v_tau */
    const double t16 = JLT_FMA(x[4], t15, t12); /* omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    out[9] = t16;
    const double t17 = JLT_FMA(x[3], t15, p[23]); /* omega_n*m*R*v_tau + m*g*a3 */
    out[0] = t17;
    const double t18 = x[3]*p[4]; /* omega_n*I1 */
    const double t19 = JLT_FMA(t7, t9, t18); /* m*b*v_tau + omega_n*I1 */
    out[3] = t19;
    const double t20 = x[4]*p[5]; /* omega3*I3 */
    const double t21 = JLT_FMA(x[9], t15, t20); /* s*m*R*v_tau + omega3*I3 */
    out[4] = t21;
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
    double t16[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
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
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double u63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double u65[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
    double t68[JLT_JET_ORDER_MAX + 1];
    double t69[JLT_JET_ORDER_MAX + 1];
    double t70[JLT_JET_ORDER_MAX + 1];
    double t71[JLT_JET_ORDER_MAX + 1];
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
        t2[k] = jlt_jet_product(x9, x2, k);
        t3[k] = jlt_jet_product(x9, t2, k);
        t8[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t9[k] = jlt_jet_product(x3, t8, k);
        t11[k] = jlt_jet_product(x9, x4, k);
        t12[k] = p[1]*t11[k] + t9[k];
        t13[k] = jlt_jet_product(x3, t12, k);
        t16[k] = jlt_jet_product(x9, x9, k);
        t18[k] = t8[k]*p[19];
        t19[k] = p[18]*t16[k] + (k == 0 ? p[17] : 0);
        t20[k] = jlt_jet_product(t8, t18, k) + t19[k];
        t22[k] = jlt_jet_product(t2, x0, k);
        t23[k] = t2[k]*p[8];
        t24[k] = jlt_jet_product(t22, t23, k);
        t26[k] = jlt_jet_product(x3, x0, k);
        t27[k] = t11[k]*p[9] + t26[k];
        t29[k] = t24[k] - t16[k]*p[10];
        t30[k] = t29[k] - jlt_jet_product(x3, t27, k);
        t32[k] = t16[k]*p[8] + (k == 0 ? 1.0 : 0);
        t33[k] = jlt_jet_product(t20, t32, k);
        t34[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t33, t34, k);
        t35[k] = jlt_jet_product(t20, t30, k);
        t36[k] = jlt_jet_product(t34, t35, k);
        t39[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t40[k] = (k == 0 ? p[12] : 0) + t39[k];
        t41[k] = jlt_jet_product(t32, t34, k);
        t42[k] = jlt_jet_product(t11, t41, k);
        t43[k] = p[27]*t40[k];
        t44[k] = jlt_jet_product(t42, t43, k) + t26[k];
        t45[k] = jlt_jet_product(x2, t44, k);
        t47[k] = jlt_jet_product(x2, t39, k) + x1[k];
        t48[k] = jlt_jet_product(x3, t47, k);
        t49[k] = jlt_jet_product(t41, t48, k);
        t50[k] = t45[k] - jlt_jet_product(t18, t49, k);
        t52[k] = x9[k]*p[35];
        t53[k] = jlt_jet_product(t49, t52, k);
        t55[k] = t2[k]*p[25];
        t57[k] = t22[k]*p[34];
        t58[k] = jlt_jet_product(t42, t57, k) - t53[k];
        t59[k] = t58[k] - jlt_jet_product(t42, t55, k);
        t60[k] = -x3[k];
        t61[k] = t11[k] + t26[k];
        t63[k] = jlt_jet_cosine(x5, t63, u63, k);
        t64[k] = jlt_jet_product(x1, t63, k);
        t65[k] = jlt_jet_sine(x5, t65, u65, k);
        t66[k] = jlt_jet_product(t12, t65, k) + t64[k];
        t67[k] = jlt_jet_product(x9, t66, k);
        t68[k] = jlt_jet_product(x1, t65, k);
        t69[k] = t68[k] - jlt_jet_product(t12, t63, k);
        t70[k] = jlt_jet_product(x9, t69, k);
        t71[k] = -t22[k];
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t13[k]/(k + 1);
        next[2] = x2[k + 1] = t36[k]/(k + 1);
        next[3] = x3[k + 1] = t50[k]/(k + 1);
        next[4] = x4[k + 1] = t59[k]/(k + 1);
        next[5] = x5[k + 1] = t60[k]/(k + 1);
        next[6] = x6[k + 1] = t61[k]/(k + 1);
        next[7] = x7[k + 1] = t67[k]/(k + 1);
        next[8] = x8[k + 1] = t70[k]/(k + 1);
        next[9] = x9[k + 1] = t71[k]/(k + 1);
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
    const double v_I3 = params[5];
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
};

const jlt_descriptor jlt_kernels_spherical_top_track_general_in_regular = {
    .model = "spherical_top_track",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "c7bdf9b18905a1f818d5260ad87232eb89daed48e07bb866d4cc6758fadd9124",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_track,
    .state_count = 10, .param_count = 6, .block_count = 51,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 10, { 6, 27, 15, 1, 0, 2, 10, 11 }, { 22, 91, 0, 10, 0, 2, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 100, { 15, 82, 35, 1, 0, 2, 14, 25 }, { 66, 414, 0, 49, 0, 2, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 110, { 18, 87, 37, 1, 0, 2, 9, 28 }, { 81, 486, 0, 59, 0, 2, 14, 12 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 0, 8, 9, 1, 0, 0, 8, 7 }, { 10, 39, 0, 4, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 2, { 0, 12, 9, 0, 0, 0, 5, 7 }, { 9, 31, 0, 0, 0, 0, 10, 5 },
        "" },
    .integral_gradients = { integral_gradients, 20, { 0, 15, 7, 0, 0, 0, 5, 5 }, { 9, 37, 0, 0, 0, 0, 6, 6 },
        "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_track_general_in_regular_baseline,
        &jlt_batch_spherical_top_track_general_in_regular_avx2,
        &jlt_batch_spherical_top_track_general_in_regular_avx512,
    },
};
