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
 *  rhs_jacobian        18   87   37    1    0    2      9   33   (628)
 *  divergence          0    8    9    1    0    0      8    8   (53)
 *  integral_values     0   12    9    0    0    0      5    8   (40)
 *  integral_gradients  0   15    7    0    0    0      5    7   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
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
    const double t3 = t0*params[4]; /* R*R*I1 */
    const double t4 = params[5]/t3; /* I3/(R*R*I1) */
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    const double t8 = params[5]/params[4]; /* I3/I1 */
    const double t9 = params[0]*params[2]; /* m*g */
    const double t10 = params[3]*t9; /* a3*m*g */
    const double t11 = t10/params[4]; /* a3*m*g/I1 */
    const double t12 = params[1]*params[4]; /* R*I1 */
    const double t13 = params[5]/t12; /* I3/(R*I1) */
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = params[5]/t14; /* I3/(m*R) */
    const double t16 = params[5]*params[3]; /* I3*a3 */
    const double t17 = t16/t12; /* I3*a3/(R*I1) */
    const double t18 = params[4] - params[5]; /* I1 - I3 */
    const double t19 = t18/params[4]; /* (I1 - I3)/I1 */
    const double t20 = 1.0/params[1]; /* 1/R */
    const double t21 = params[5]*params[4]; /* I3*I1 */
    const double t22 = t1*params[4]; /* m*R*R*I1 */
    const double t23 = params[0]*params[5]; /* m*I3 */
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t5*t24; /* a3*a3*m*2 */
    const double t26 = params[4]*2.0; /* I1*2 */
    const double t27 = -params[5]; /* -I3 */
    const double t28 = params[4]*t25; /* I1*a3*a3*m*2 */
    const double t29 = params[3]*t14; /* a3*m*R */
    const double t30 = params[5]*t29; /* I3*a3*m*R */
    const double t31 = params[0]*params[3]; /* m*a3 */
    const double t32 = params[5]*t31; /* I3*m*a3 */
    const double t33 = params[5]*t14; /* I3*m*R */
    const double t34 = params[1]*2.0; /* R*2 */
    const double t35 = params[0]*params[0]; /* m*m */
    const double t36 = t0*t35; /* R*R*m*m */
    const double t37 = params[4]*t36; /* I1*R*R*m*m */
    const double t38 = params[5]*t37; /* I3*I1*R*R*m*m */
    const double t39 = params[5]*t36; /* I3*R*R*m*m */
    const double t40 = params[3]*2.0; /* a3*2 */
    const double t41 = params[5]*t40; /* I3*a3*2 */
    const double t42 = t18*t34; /* (I1 - I3)*R*2 */
    const double t43 = params[4]*t29; /* I1*a3*m*R */
    const double t44 = t1*t18; /* m*R*R*(I1 - I3) */
    const double t45 = params[4]*t14; /* I1*m*R */
    const double t46 = -t45; /* -I1*m*R */
    const double t47 = 2.0*t35; /* 2*m*m */
    const double t48 = params[1]*t0; /* R*R*R */
    const double t49 = t47*t48; /* 2*m*m*R*R*R */
    const double t50 = params[4]*params[4]; /* I1*I1 */
    const double t51 = t49*t50; /* 2*m*m*R*R*R*I1*I1 */
    const double t52 = 1.0/t26; /* 1/(I1*2) */
    const double t53 = params[5]*params[5]; /* I3*I3 */
    const double t54 = params[2]*t24; /* g*m*2 */
    const double t55 = params[3]*t54; /* a3*g*m*2 */
    const double t56 = params[1]*t24; /* R*m*2 */
    const double t57 = params[5]*t56; /* I3*R*m*2 */
    const double t58 = t0*t24; /* R*R*m*2 */
    const double t59 = params[4]*t58; /* I1*R*R*m*2 */
    const double t60 = t18*t58; /* (I1 - I3)*R*R*m*2 */
    const double t61 = params[3]*t56; /* a3*R*m*2 */
    const double t62 = params[5]*t61; /* I3*a3*R*m*2 */
    const double t63 = params[0]/2.0; /* m/2 */
    const double t64 = params[4]/2.0; /* I1/2 */
    const double t65 = params[5]/2.0; /* I3/2 */
    const double t66 = params[1]*params[5]; /* R*I3 */
    const double t67 = -t66; /* -R*I3 */
    out[6] = t2;
    out[7] = t4;
    out[8] = t7;
    out[9] = t8;
    out[10] = t11;
    out[11] = t13;
    out[12] = t15;
    out[13] = t17;
    out[14] = t19;
    out[15] = t20;
    out[16] = t6;
    out[17] = t21;
    out[18] = t22;
    out[19] = t23;
    out[20] = t25;
    out[21] = t26;
    out[22] = t27;
    out[23] = t10;
    out[24] = t28;
    out[25] = t30;
    out[26] = t32;
    out[27] = t33;
    out[28] = t34;
    out[29] = t38;
    out[30] = t39;
    out[31] = t41;
    out[32] = t42;
    out[33] = t43;
    out[34] = t44;
    out[35] = t45;
    out[36] = t46;
    out[37] = t51;
    out[38] = t52;
    out[39] = t14;
    out[40] = t53;
    out[41] = t55;
    out[42] = t57;
    out[43] = t59;
    out[44] = t60;
    out[45] = t62;
    out[46] = t63;
    out[47] = t64;
    out[48] = t65;
    out[49] = t12;
    out[50] = t67;
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
    const double t7 = t2*p[7]; /* b*I3/(R^2*I1) */
    const double t8 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t9 = JLT_FMA(t2, t7, t8); /* Theta scaled = b*b*I3/(R^2*I1) + s*s + I3/(m*R^2) */
    const double t10 = x[2]*x[9]; /* omega_tau*s */
    const double t11 = x[0]*t10; /* gamma3*omega_tau*s */
    const double t12 = p[8]*t10; /* m*a3^2/I1*omega_tau*s */
    const double t13 = t11*t12; /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s */
    const double t14 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t15 = JLT_FMA(t4, p[9], t14); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t16 = JLT_FNMA(t0, p[10], t13); /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s - s*s*m*g*a3/I1 */
    const double t17 = JLT_FNMA(x[3], t15, t16); /* gamma3*omega_tau*s*m*a3^2/I1*omega_tau*s - s*s*m*g*a3/I1 - omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t18 = JLT_FMA(t0, p[8], 1.0); /* D scaled = s*s*m*a3^2/I1 + 1 */
    const double t19 = t9*t18; /* Theta scaled*D scaled */
    const double t20 = 1.0/t19; /* 1/(Theta scaled*D scaled) */
    const double t21 = t9*t17; /* Theta scaled*t17 */
    const double t22 = t20*t21; /* 1/(Theta scaled*D scaled)*Theta scaled*t17 */
    const double t23 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t24 = p[12] + t23; /* I3/(m*R) + e */
    const double t25 = t18*t20; /* D scaled*1/(Theta scaled*D scaled) */
    const double t26 = t4*t25; /* s*omega3*D scaled*1/(Theta scaled*D scaled) */
    const double t27 = p[11]*t24; /* I3/(R*I1)*(I3/(m*R) + e) */
    const double t28 = JLT_FMA(t26, t27, t14); /* s*omega3*D scaled*1/(Theta scaled*D scaled)*I3/(R*I1)*(I3/(m*R) + e) + omega_n*gamma3 */
    const double t29 = x[2]*t28; /* omega_tau*t28 */
    const double t30 = JLT_FMA(x[2], t23, x[1]); /* V = omega_tau*e + v_nu */
    const double t31 = x[3]*t30; /* omega_n*V */
    const double t32 = t25*t31; /* D scaled*1/(Theta scaled*D scaled)*omega_n*V */
    const double t33 = JLT_FNMA(t7, t32, t29); /* omega_tau*t28 - b*I3/(R^2*I1)*D scaled*1/(Theta scaled*D scaled)*omega_n*V */
    const double t34 = JLT_FNMA(x[0], p[14], p[13]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t35 = t10*t34; /* omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t36 = t26*t35; /* s*omega3*D scaled*1/(Theta scaled*D scaled)*omega_tau*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t37 = x[9]*p[15]; /* s*1/R */
    const double t38 = JLT_FMA(t32, t37, t36); /* D scaled*1/(Theta scaled*D scaled)*omega_n*V*s*1/R + t36 */
    const double t39 = -t38; /* -(D scaled*1/(Theta scaled*D scaled)*omega_n*V*s*1/R + t36) */
    const double t40 = -x[3]; /* -omega_n */
    const double t41 = t4 + t14; /* s*omega3 + omega_n*gamma3 */
    const double t42 = cos(x[5]); /* C = cos(chi) */
    const double t43 = x[1]*t42; /* v_nu*C */
    const double t44 = sin(x[5]); /* S = sin(chi) */
    const double t45 = JLT_FMA(t5, t44, t43); /* (R*s*omega3 + omega_n*b)*S + v_nu*C */
    const double t46 = x[9]*t45; /* s*((R*s*omega3 + omega_n*b)*S + v_nu*C) */
    const double t47 = x[1]*t44; /* v_nu*S */
    const double t48 = JLT_FNMA(t5, t42, t47); /* v_nu*S - (R*s*omega3 + omega_n*b)*C */
    const double t49 = x[9]*t48; /* s*(v_nu*S - (R*s*omega3 + omega_n*b)*C) */
    const double t50 = -t11; /* -gamma3*omega_tau*s */
    out[0] = t1;
    out[1] = t6;
    out[2] = t22;
    out[3] = t33;
    out[4] = t39;
    out[5] = t40;
    out[6] = t41;
    out[7] = t46;
    out[8] = t49;
    out[9] = t50;
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
    const double t12 = t5*p[19]; /* b*m*I3 */
    const double t13 = JLT_FMA(t0, p[18], p[17]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t14 = JLT_FMA(t5, t12, t13); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t15 = JLT_FMA(t0, p[16], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t16 = t14*t15; /* Theta*D */
    const double t17 = 1.0/t16; /* 1/(Theta*D) */
    const double t18 = t14*t17; /* Theta*1/(Theta*D) */
    const double t19 = t1*p[16]; /* s*omega_tau*m*a3^2 */
    const double t20 = t18*t19; /* Theta*1/(Theta*D)*s*omega_tau*m*a3^2 */
    const double t21 = t1*t20; /* s*omega_tau*Theta*1/(Theta*D)*s*omega_tau*m*a3^2 */
    const double t22 = x[3]*t18; /* omega_n*Theta*1/(Theta*D) */
    const double t23 = x[3]*p[4]; /* omega_n*I1 */
    const double t24 = JLT_FNMA(t22, t23, t21); /* s*omega_tau*Theta*1/(Theta*D)*s*omega_tau*m*a3^2 - omega_n*Theta*1/(Theta*D)*omega_n*I1 */
    const double t25 = x[9]*t18; /* s*Theta*1/(Theta*D) */
    const double t26 = x[9]*p[20]; /* s*2*m*a3^2 */
    const double t27 = t25*t26; /* s*Theta*1/(Theta*D)*s*2*m*a3^2 */
    const double t28 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t29 = t27*t28; /* s*Theta*1/(Theta*D)*s*2*m*a3^2*omega_tau*gamma3 */
    const double t30 = x[0]*p[21]; /* gamma3*2*I1 */
    const double t31 = t22*t30; /* omega_n*Theta*1/(Theta*D)*gamma3*2*I1 */
    const double t32 = x[4]*p[5]; /* omega3*I3 */
    const double t33 = JLT_FMA(t25, t32, t31); /* s*Theta*1/(Theta*D)*omega3*I3 + omega_n*Theta*1/(Theta*D)*gamma3*2*I1 */
    const double t34 = -t33; /* -t33 */
    const double t35 = x[9]*p[22]; /* s*(-I3) */
    const double t36 = t22*t35; /* omega_n*Theta*1/(Theta*D)*s*(-I3) */
    const double t37 = 2.0 - t27; /* 2 - s*Theta*1/(Theta*D)*s*2*m*a3^2 */
    const double t38 = t20*t28; /* Theta*1/(Theta*D)*s*omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t39 = JLT_FNMA(t25, p[23], t38); /* Theta*1/(Theta*D)*s*omega_tau*m*a3^2*omega_tau*gamma3 - s*Theta*1/(Theta*D)*m*g*a3 */
    const double t40 = t37*t39; /* (2 - s*Theta*1/(Theta*D)*s*2*m*a3^2)*t39 */
    const double t41 = x[9]*x[0]; /* s*gamma3 */
    const double t42 = p[24]*t41; /* 2*m*a3^2*I1*s*gamma3 */
    const double t43 = JLT_FMS(t22, t42, t32); /* omega_n*Theta*1/(Theta*D)*2*m*a3^2*I1*s*gamma3 - omega3*I3 */
    const double t44 = JLT_FMA(t27, t32, t43); /* s*Theta*1/(Theta*D)*s*2*m*a3^2*omega3*I3 + omega_n*Theta*1/(Theta*D)*2*m*a3^2*I1*s*gamma3 - omega3*I3 */
    const double t45 = JLT_FMA(t22, t44, t40); /* omega_n*Theta*1/(Theta*D)*t44 + (2 - s*Theta*1/(Theta*D)*s*2*m*a3^2)*t39 */
    const double t46 = t15*t17; /* D*1/(Theta*D) */
    const double t47 = x[9]*t46; /* s*D*1/(Theta*D) */
    const double t48 = x[2]*t47; /* omega_tau*s*D*1/(Theta*D) */
    const double t49 = x[4]*t48; /* omega3*omega_tau*s*D*1/(Theta*D) */
    const double t50 = p[25]*t49; /* m*R*a3*I3*omega3*omega_tau*s*D*1/(Theta*D) */
    const double t51 = t6*t46; /* omega_n*b*D*1/(Theta*D) */
    const double t52 = JLT_FNMA(p[26], t51, x[3]); /* omega_n - m*a3*I3*omega_n*b*D*1/(Theta*D) */
    const double t53 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t54 = p[12] + t53; /* I3/(m*R) + e */
    const double t55 = p[28]*t54; /* 2*R*(I3/(m*R) + e) */
    const double t56 = t49*t55; /* omega3*omega_tau*s*D*1/(Theta*D)*2*R*(I3/(m*R) + e) */
    const double t57 = JLT_FMA(x[2], t53, x[1]); /* V = omega_tau*e + v_nu */
    const double t58 = t46*t57; /* D*1/(Theta*D)*V */
    const double t59 = t6*t58; /* omega_n*b*D*1/(Theta*D)*V */
    const double t60 = JLT_FNMA(2.0, t59, t56); /* omega3*omega_tau*s*D*1/(Theta*D)*2*R*(I3/(m*R) + e) - 2*omega_n*b*D*1/(Theta*D)*V */
    const double t61 = t12*t60; /* b*m*I3*t60 */
    const double t62 = JLT_FMA(x[3], t57, t61); /* omega_n*V + b*m*I3*t60 */
    const double t63 = t46*p[27]; /* D*1/(Theta*D)*m*R*I3 */
    const double t64 = JLT_FMA(x[2], t52, t50); /* omega_tau*(omega_n - m*a3*I3*omega_n*b*D*1/(Theta*D)) + m*R*a3*I3*omega3*omega_tau*s*D*1/(Theta*D) */
    const double t65 = JLT_FNMA(t62, t63, t64); /* t64 - (omega_n*V + b*m*I3*t60)*D*1/(Theta*D)*m*R*I3 */
    const double t66 = p[19]*t51; /* m*I3*omega_n*b*D*1/(Theta*D) */
    const double t67 = -t66; /* -m*I3*omega_n*b*D*1/(Theta*D) */
    const double t68 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t69 = p[27]*t54; /* m*R*I3*(I3/(m*R) + e) */
    const double t70 = x[4]*t47; /* omega3*s*D*1/(Theta*D) */
    const double t71 = JLT_FNMA(t53, t66, t68); /* omega_n*gamma3 - e*m*I3*omega_n*b*D*1/(Theta*D) */
    const double t72 = JLT_FMA(t69, t70, t71); /* m*R*I3*(I3/(m*R) + e)*omega3*s*D*1/(Theta*D) + omega_n*gamma3 - e*m*I3*omega_n*b*D*1/(Theta*D) */
    const double t73 = JLT_FNMA(t12, t58, t28); /* omega_tau*gamma3 - b*m*I3*D*1/(Theta*D)*V */
    const double t74 = t48*t69; /* omega_tau*s*D*1/(Theta*D)*m*R*I3*(I3/(m*R) + e) */
    const double t75 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t76 = t69*t75; /* m*R*I3*(I3/(m*R) + e)*omega_tau*omega3 */
    const double t77 = t46*t76; /* D*1/(Theta*D)*m*R*I3*(I3/(m*R) + e)*omega_tau*omega3 */
    const double t78 = t47*p[29]; /* s*D*1/(Theta*D)*m^2*R^2*I1*I3 */
    const double t79 = JLT_FNMA(t60, t78, t77); /* D*1/(Theta*D)*m*R*I3*(I3/(m*R) + e)*omega_tau*omega3 - t60*s*D*1/(Theta*D)*m^2*R^2*I1*I3 */
    const double t80 = JLT_FNMA(x[0], p[32], p[31]); /* 2*a3*I3 - gamma3*2*R*(I1 - I3) */
    const double t81 = t49*t80; /* omega3*omega_tau*s*D*1/(Theta*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t82 = t5*t81; /* b*t81 */
    const double t83 = JLT_FMA(p[21], t59, t82); /* 2*I1*omega_n*b*D*1/(Theta*D)*V + b*t81 */
    const double t84 = t47*p[30]; /* s*D*1/(Theta*D)*m^2*R^2*I3 */
    const double t85 = x[3]*p[33]; /* omega_n*m*R*a3*I1 */
    const double t86 = t48*t85; /* omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t87 = x[9]*t49; /* s*omega3*omega_tau*s*D*1/(Theta*D) */
    const double t88 = JLT_FMS(p[34], t87, t86); /* m*R^2*(I1 - I3)*s*omega3*omega_tau*s*D*1/(Theta*D) - omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t89 = JLT_FMA(t83, t84, t88); /* (2*I1*omega_n*b*D*1/(Theta*D)*V + b*t81)*s*D*1/(Theta*D)*m^2*R^2*I3 + t88 */
    const double t90 = x[3]*p[35]; /* omega_n*m*R*I1 */
    const double t91 = t47*t90; /* s*D*1/(Theta*D)*omega_n*m*R*I1 */
    const double t92 = -t91; /* -s*D*1/(Theta*D)*omega_n*m*R*I1 */
    const double t93 = x[9]*p[25]; /* s*m*R*a3*I3 */
    const double t94 = JLT_FNMA(t41, p[34], t93); /* s*m*R*a3*I3 - s*gamma3*m*R^2*(I1 - I3) */
    const double t95 = t70*t94; /* omega3*s*D*1/(Theta*D)*(s*m*R*a3*I3 - s*gamma3*m*R^2*(I1 - I3)) */
    const double t96 = JLT_FMA(t53, t91, t95); /* e*s*D*1/(Theta*D)*omega_n*m*R*I1 + t95 */
    const double t97 = -t96; /* -(e*s*D*1/(Theta*D)*omega_n*m*R*I1 + t95) */
    const double t98 = t47*t57; /* s*D*1/(Theta*D)*V */
    const double t99 = p[36]*t98; /* (-m*R*I1)*s*D*1/(Theta*D)*V */
    const double t100 = t48*t94; /* omega_tau*s*D*1/(Theta*D)*(s*m*R*a3*I3 - s*gamma3*m*R^2*(I1 - I3)) */
    const double t101 = -t100; /* -t100 */
    const double t102 = t58*t90; /* D*1/(Theta*D)*V*omega_n*m*R*I1 */
    const double t103 = x[3]*t98; /* omega_n*s*D*1/(Theta*D)*V */
    const double t104 = t80*p[38]; /* (2*a3*I3 - gamma3*2*R*(I1 - I3))*1/2/I1 */
    const double t105 = JLT_FMA(t87, t104, t103); /* s*omega3*omega_tau*s*D*1/(Theta*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3))*1/2/I1 + omega_n*s*D*1/(Theta*D)*V */
    const double t106 = t47*p[37]; /* s*D*1/(Theta*D)*2*m^2*R^3*I1^2 */
    const double t107 = JLT_FMS(t105, t106, t102); /* t105*s*D*1/(Theta*D)*2*m^2*R^3*I1^2 - D*1/(Theta*D)*V*omega_n*m*R*I1 */
    const double t108 = JLT_FNMA(t81, p[39], t107); /* t107 - t81*m*R */
    const double t109 = sin(x[5]); /* S = sin(chi) */
    const double t110 = t10*t109; /* omega_n*s*R*S */
    const double t111 = cos(x[5]); /* C = cos(chi) */
    const double t112 = x[9]*t111; /* s*C */
    const double t113 = x[9]*t109; /* s*S */
    const double t114 = t5*t113; /* b*s*S */
    const double t115 = t7*t113; /* s*R*s*S */
    const double t116 = x[1]*t113; /* v_nu*s*S */
    const double t117 = t6 + t8; /* v_tau = omega_n*b + omega3*s*R */
    const double t118 = JLT_FMS(t112, t117, t116); /* s*C*v_tau - v_nu*s*S */
    const double t119 = x[1]*t111; /* v_nu*C */
    const double t120 = t8 + t117; /* omega3*s*R + v_tau */
    const double t121 = JLT_FMA(t109, t120, t119); /* S*(omega3*s*R + v_tau) + v_nu*C */
    const double t122 = t10*t111; /* omega_n*s*R*C */
    const double t123 = -t122; /* -omega_n*s*R*C */
    const double t124 = t5*t112; /* b*s*C */
    const double t125 = -t124; /* -b*s*C */
    const double t126 = t7*t112; /* s*R*s*C */
    const double t127 = -t126; /* -s*R*s*C */
    const double t128 = x[1]*t112; /* v_nu*s*C */
    const double t129 = JLT_FMA(t113, t117, t128); /* s*S*v_tau + v_nu*s*C */
    const double t130 = x[1]*t109; /* v_nu*S */
    const double t131 = JLT_FNMA(t111, t120, t130); /* v_nu*S - C*(omega3*s*R + v_tau) */
    const double t132 = -t1; /* -s*omega_tau */
    const double t133 = -t41; /* -s*gamma3 */
    const double t134 = -t28; /* -omega_tau*gamma3 */
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
    out[20] = t24;
    out[21] = 0.0;
    out[22] = t29;
    out[23] = t34;
    out[24] = t36;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t45;
    out[30] = t65;
    out[31] = t67;
    out[32] = t72;
    out[33] = t73;
    out[34] = t74;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t79;
    out[40] = t89;
    out[41] = t92;
    out[42] = t97;
    out[43] = t99;
    out[44] = t101;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t108;
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
    out[70] = t110;
    out[71] = t112;
    out[72] = 0.0;
    out[73] = t114;
    out[74] = t115;
    out[75] = t118;
    out[76] = 0.0;
    out[77] = 0.0;
    out[78] = 0.0;
    out[79] = t121;
    out[80] = t123;
    out[81] = t113;
    out[82] = 0.0;
    out[83] = t125;
    out[84] = t127;
    out[85] = t129;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t131;
    out[90] = t132;
    out[91] = 0.0;
    out[92] = t133;
    out[93] = 0.0;
    out[94] = 0.0;
    out[95] = 0.0;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t134;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[2]; /* s*omega_tau */
    const double t1 = x[9]*t0; /* s*s*omega_tau */
    const double t2 = x[9]*x[4]; /* s*omega3 */
    const double t3 = p[1]*t2; /* R*s*omega3 */
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = x[3]*t4; /* omega_n*b */
    const double t6 = t3 + t5; /* R*s*omega3 + omega_n*b */
    const double t7 = x[3]*t6; /* omega_n*(R*s*omega3 + omega_n*b) */
    const double t8 = t0*p[16]; /* s*omega_tau*m*a3^2 */
    const double t9 = t0*t8; /* s*omega_tau*s*omega_tau*m*a3^2 */
    const double t10 = x[3]*x[3]; /* omega_n*omega_n */
    const double t11 = JLT_FNMA(p[4], t10, t9); /* s*omega_tau*s*omega_tau*m*a3^2 - I1*omega_n*omega_n */
    const double t12 = x[9]*x[9]; /* s*s */
    const double t13 = p[23]*t12; /* m*g*a3*s*s */
    const double t14 = t2*p[5]; /* s*omega3*I3 */
    const double t15 = JLT_FMA(x[3], t14, t13); /* omega_n*s*omega3*I3 + m*g*a3*s*s */
    const double t16 = JLT_FNMA(x[0], t11, t15); /* omega_n*s*omega3*I3 + m*g*a3*s*s - gamma3*(s*omega_tau*s*omega_tau*m*a3^2 - I1*omega_n*omega_n) */
    const double t17 = t4*p[19]; /* b*m*I3 */
    const double t18 = JLT_FMA(t12, p[18], p[17]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t19 = JLT_FMA(t4, t17, t18); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t20 = JLT_FMA(p[16], t12, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t21 = t19*t20; /* Theta*D */
    const double t22 = 1.0/t21; /* 1/(Theta*D) */
    const double t23 = t19*t22; /* Theta*1/(Theta*D) */
    const double t24 = t16*t23; /* t16*Theta*1/(Theta*D) */
    const double t25 = -t24; /* -t16*Theta*1/(Theta*D) */
    const double t26 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t27 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t28 = JLT_FMA(x[2], t27, x[1]); /* V = omega_tau*e + v_nu */
    const double t29 = p[19]*t28; /* m*I3*V */
    const double t30 = t5*t29; /* omega_n*b*m*I3*V */
    const double t31 = JLT_FMA(t27, p[27], p[40]); /* e*m*R*I3 + I3^2 */
    const double t32 = t0*x[4]; /* s*omega_tau*omega3 */
    const double t33 = JLT_FMS(t31, t32, t30); /* numerator of d(omega_n)/dt over Theta = (e*m*R*I3 + I3^2)*s*omega_tau*omega3 - omega_n*b*m*I3*V */
    const double t34 = t20*t22; /* D*1/(Theta*D) */
    const double t35 = t33*t34; /* numerator of d(omega_n)/dt over Theta*D*1/(Theta*D) */
    const double t36 = JLT_FMA(x[2], t26, t35); /* omega_tau*omega_n*gamma3 + numerator of d(omega_n)/dt over Theta*D*1/(Theta*D) */
    const double t37 = x[9]*x[3]; /* s*omega_n */
    const double t38 = p[35]*t37; /* m*R*I1*s*omega_n */
    const double t39 = t28*t38; /* V*m*R*I1*s*omega_n */
    const double t40 = JLT_FNMA(x[0], p[34], p[25]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t41 = t2*t40; /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t42 = JLT_FMA(t0, t41, t39); /* s*omega_tau*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*m*R*I1*s*omega_n */
    const double t43 = t34*t42; /* D*1/(Theta*D)*t42 */
    const double t44 = -t43; /* -D*1/(Theta*D)*t42 */
    const double t45 = -x[3]; /* -omega_n */
    const double t46 = t2 + t26; /* s*omega3 + omega_n*gamma3 */
    const double t47 = cos(x[5]); /* C = cos(chi) */
    const double t48 = x[1]*t47; /* v_nu*C */
    const double t49 = sin(x[5]); /* S = sin(chi) */
    const double t50 = JLT_FMA(t6, t49, t48); /* (R*s*omega3 + omega_n*b)*S + v_nu*C */
    const double t51 = x[9]*t50; /* s*((R*s*omega3 + omega_n*b)*S + v_nu*C) */
    const double t52 = x[1]*t49; /* v_nu*S */
    const double t53 = JLT_FNMA(t6, t47, t52); /* v_nu*S - (R*s*omega3 + omega_n*b)*C */
    const double t54 = x[9]*t53; /* s*(v_nu*S - (R*s*omega3 + omega_n*b)*C) */
    const double t55 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t56 = -t55; /* -s*omega_tau*gamma3 */
    const double t57 = t0*2.0; /* s*omega_tau*2 */
    const double t58 = p[1]*t10; /* R*omega_n*omega_n */
    const double t59 = JLT_FMA(t5, 2.0, t3); /* omega_n*b*2 + R*s*omega3 */
    const double t60 = p[1]*t37; /* R*s*omega_n */
    const double t61 = x[3]*x[4]; /* omega_n*omega3 */
    const double t62 = p[1]*t61; /* R*omega_n*omega3 */
    const double t63 = t11*t23; /* (s*omega_tau*s*omega_tau*m*a3^2 - I1*omega_n*omega_n)*Theta*1/(Theta*D) */
    const double t64 = x[9]*p[20]; /* s*2*m*a3^2 */
    const double t65 = t23*t64; /* Theta*1/(Theta*D)*s*2*m*a3^2 */
    const double t66 = t55*t65; /* s*omega_tau*gamma3*Theta*1/(Theta*D)*s*2*m*a3^2 */
    const double t67 = JLT_FMA(t26, p[21], t14); /* omega_n*gamma3*2*I1 + s*omega3*I3 */
    const double t68 = t23*t67; /* Theta*1/(Theta*D)*(omega_n*gamma3*2*I1 + s*omega3*I3) */
    const double t69 = -t68; /* -Theta*1/(Theta*D)*(omega_n*gamma3*2*I1 + s*omega3*I3) */
    const double t70 = t37*p[22]; /* s*omega_n*(-I3) */
    const double t71 = t23*t70; /* Theta*1/(Theta*D)*s*omega_n*(-I3) */
    const double t72 = x[2]*p[20]; /* omega_tau*2*m*a3^2 */
    const double t73 = t55*t72; /* s*omega_tau*gamma3*omega_tau*2*m*a3^2 */
    const double t74 = JLT_FNMA(x[9], p[41], t73); /* s*omega_tau*gamma3*omega_tau*2*m*a3^2 - s*2*m*g*a3 */
    const double t75 = JLT_FNMA(p[5], t61, t74); /* d(numerator of d(omega_tau)/dt over D)/d(s) = s*omega_tau*gamma3*omega_tau*2*m*a3^2 - s*2*m*g*a3 - I3*omega_n*omega3 */
    const double t76 = JLT_FMA(t16, t65, t75); /* t16*Theta*1/(Theta*D)*s*2*m*a3^2 + d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t77 = t23*t76; /* Theta*1/(Theta*D)*t76 */
    const double t78 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t79 = t32*p[25]; /* s*omega_tau*omega3*m*R*a3*I3 */
    const double t80 = x[3]*t28; /* omega_n*V */
    const double t81 = x[2]*p[26]; /* omega_tau*m*a3*I3 */
    const double t82 = JLT_FNMA(t5, t81, t79); /* s*omega_tau*omega3*m*R*a3*I3 - omega_n*b*omega_tau*m*a3*I3 */
    const double t83 = JLT_FNMA(p[27], t80, t82); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = s*omega_tau*omega3*m*R*a3*I3 - omega_n*b*omega_tau*m*a3*I3 - m*R*I3*omega_n*V */
    const double t84 = t4*t34; /* b*D*1/(Theta*D) */
    const double t85 = p[42]*t84; /* 2*m*R*I3*b*D*1/(Theta*D) */
    const double t86 = JLT_FMA(t34, t83, t78); /* D*1/(Theta*D)*d(numerator of d(omega_n)/dt over Theta)/d(gamma3) + omega_tau*omega_n */
    const double t87 = JLT_FNMA(t35, t85, t86); /* t86 - numerator of d(omega_n)/dt over Theta*D*1/(Theta*D)*2*m*R*I3*b*D*1/(Theta*D) */
    const double t88 = t5*p[19]; /* omega_n*b*m*I3 */
    const double t89 = t34*t88; /* D*1/(Theta*D)*omega_n*b*m*I3 */
    const double t90 = -t89; /* -D*1/(Theta*D)*omega_n*b*m*I3 */
    const double t91 = t27*t88; /* e*omega_n*b*m*I3 */
    const double t92 = JLT_FMS(t2, t31, t91); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(e*m*R*I3 + I3^2) - e*omega_n*b*m*I3 */
    const double t93 = JLT_FMA(t34, t92, t26); /* D*1/(Theta*D)*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    const double t94 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t95 = JLT_FNMA(t29, t84, t94); /* omega_tau*gamma3 - m*I3*V*b*D*1/(Theta*D) */
    const double t96 = t31*t34; /* (e*m*R*I3 + I3^2)*D*1/(Theta*D) */
    const double t97 = t0*t96; /* s*omega_tau*(e*m*R*I3 + I3^2)*D*1/(Theta*D) */
    const double t98 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t99 = t96*t98; /* (e*m*R*I3 + I3^2)*D*1/(Theta*D)*omega_tau*omega3 */
    const double t100 = x[9]*t34; /* s*D*1/(Theta*D) */
    const double t101 = p[43]*t100; /* 2*m*R^2*I1*s*D*1/(Theta*D) */
    const double t102 = JLT_FNMA(t35, t101, t99); /* (e*m*R*I3 + I3^2)*D*1/(Theta*D)*omega_tau*omega3 - numerator of d(omega_n)/dt over Theta*D*1/(Theta*D)*2*m*R^2*I1*s*D*1/(Theta*D) */
    const double t103 = x[3]*p[33]; /* omega_n*m*R*a3*I1 */
    const double t104 = t0*t103; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t105 = t2*p[34]; /* s*omega3*m*R^2*(I1 - I3) */
    const double t106 = JLT_FMS(t0, t105, t104); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = s*omega_tau*s*omega3*m*R^2*(I1 - I3) - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t107 = t34*t106; /* D*1/(Theta*D)*d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t108 = JLT_FMA(t43, t85, t107); /* D*1/(Theta*D)*t42*2*m*R*I3*b*D*1/(Theta*D) + t107 */
    const double t109 = t34*t38; /* D*1/(Theta*D)*m*R*I1*s*omega_n */
    const double t110 = -t109; /* -D*1/(Theta*D)*m*R*I1*s*omega_n */
    const double t111 = t27*t38; /* e*m*R*I1*s*omega_n */
    const double t112 = JLT_FMA(x[9], t41, t111); /* s*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*m*R*I1*s*omega_n */
    const double t113 = t34*t112; /* D*1/(Theta*D)*t112 */
    const double t114 = -t113; /* -D*1/(Theta*D)*t112 */
    const double t115 = t28*p[36]; /* V*(-m*R*I1) */
    const double t116 = t100*t115; /* s*D*1/(Theta*D)*V*(-m*R*I1) */
    const double t117 = t1*t40; /* s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t118 = t34*t117; /* D*1/(Theta*D)*s*s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t119 = -t118; /* -t118 */
    const double t120 = x[4]*p[44]; /* omega3*2*m*R^2*(I1 - I3) */
    const double t121 = t55*t120; /* s*omega_tau*gamma3*omega3*2*m*R^2*(I1 - I3) */
    const double t122 = JLT_FNMA(t32, p[45], t121); /* s*omega_tau*gamma3*omega3*2*m*R^2*(I1 - I3) - s*omega_tau*omega3*2*m*R*a3*I3 */
    const double t123 = JLT_FNMA(p[35], t80, t122); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t122 - m*R*I1*omega_n*V */
    const double t124 = t34*t123; /* D*1/(Theta*D)*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t125 = JLT_FMA(t43, t101, t124); /* D*1/(Theta*D)*t42*2*m*R^2*I1*s*D*1/(Theta*D) + D*1/(Theta*D)*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t126 = t49*t60; /* S*R*s*omega_n */
    const double t127 = x[9]*t47; /* s*C */
    const double t128 = x[9]*t49; /* s*S */
    const double t129 = t4*t128; /* b*s*S */
    const double t130 = p[1]*t12; /* R*s*s */
    const double t131 = t49*t130; /* S*R*s*s */
    const double t132 = -t54; /* -s*(v_nu*S - (R*s*omega3 + omega_n*b)*C) */
    const double t133 = JLT_FMA(t3, t49, t50); /* R*s*omega3*S + (R*s*omega3 + omega_n*b)*S + v_nu*C */
    const double t134 = t47*t60; /* C*R*s*omega_n */
    const double t135 = -t134; /* -C*R*s*omega_n */
    const double t136 = t4*t127; /* b*s*C */
    const double t137 = -t136; /* -b*s*C */
    const double t138 = t47*t130; /* C*R*s*s */
    const double t139 = -t138; /* -C*R*s*s */
    const double t140 = JLT_FNMA(t3, t47, t53); /* v_nu*S - (R*s*omega3 + omega_n*b)*C - R*s*omega3*C */
    const double t141 = -t0; /* -s*omega_tau */
    const double t142 = x[9]*x[0]; /* s*gamma3 */
    const double t143 = -t142; /* -s*gamma3 */
    const double t144 = -t94; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t7;
    out[2] = t25;
    out[3] = t36;
    out[4] = t44;
    out[5] = t45;
    out[6] = t46;
    out[7] = t51;
    out[8] = t54;
    out[9] = t56;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = t12;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t57;
    out[20] = t58;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = t59;
    out[24] = t60;
    out[25] = 0.0;
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = t62;
    out[30] = t63;
    out[31] = 0.0;
    out[32] = t66;
    out[33] = t69;
    out[34] = t71;
    out[35] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    out[39] = t77;
    out[40] = t87;
    out[41] = t90;
    out[42] = t93;
    out[43] = t95;
    out[44] = t97;
    out[45] = 0.0;
    out[46] = 0.0;
    out[47] = 0.0;
    out[48] = 0.0;
    out[49] = t102;
    out[50] = t108;
    out[51] = t110;
    out[52] = t114;
    out[53] = t116;
    out[54] = t119;
    out[55] = 0.0;
    out[56] = 0.0;
    out[57] = 0.0;
    out[58] = 0.0;
    out[59] = t125;
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
    out[80] = t126;
    out[81] = t127;
    out[82] = 0.0;
    out[83] = t129;
    out[84] = t131;
    out[85] = t132;
    out[86] = 0.0;
    out[87] = 0.0;
    out[88] = 0.0;
    out[89] = t133;
    out[90] = t135;
    out[91] = t128;
    out[92] = 0.0;
    out[93] = t137;
    out[94] = t139;
    out[95] = t51;
    out[96] = 0.0;
    out[97] = 0.0;
    out[98] = 0.0;
    out[99] = t140;
    out[100] = t141;
    out[101] = 0.0;
    out[102] = t143;
    out[103] = 0.0;
    out[104] = 0.0;
    out[105] = 0.0;
    out[106] = 0.0;
    out[107] = 0.0;
    out[108] = 0.0;
    out[109] = t144;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = t1*p[19]; /* b*m*I3 */
    const double t3 = JLT_FMA(p[18], t0, p[17]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t1, t2, t3); /* Theta = b*b*m*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(t0, p[16], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t4*t5; /* Theta*D */
    const double t7 = t0*x[2]; /* s*s*omega_tau */
    const double t8 = x[0]*t7; /* gamma3*s*s*omega_tau */
    const double t9 = p[20]*t8; /* 2*m*a3^2*gamma3*s*s*omega_tau */
    const double t10 = t4*t9; /* Theta*2*m*a3^2*gamma3*s*s*omega_tau */
    const double t11 = t8*p[34]; /* gamma3*s*s*omega_tau*m*R^2*(I1 - I3) */
    const double t12 = JLT_FNMA(t7, p[25], t11); /* d(numerator of d(omega3)/dt over Theta)/d(omega3) = gamma3*s*s*omega_tau*m*R^2*(I1 - I3) - s*s*omega_tau*m*R*a3*I3 */
    const double t13 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t14 = JLT_FMA(x[2], t13, x[1]); /* V = omega_tau*e + v_nu */
    const double t15 = JLT_FNMA(t2, t14, t12); /* d(numerator of d(omega3)/dt over Theta)/d(omega3) - b*m*I3*V */
    const double t16 = JLT_FMA(t5, t15, t10); /* D*(d(numerator of d(omega3)/dt over Theta)/d(omega3) - b*m*I3*V) + Theta*2*m*a3^2*gamma3*s*s*omega_tau */
    const double t17 = t16/t6; /* t16/(Theta*D) */
    out[0] = t17;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[23]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = p[1]*x[9]; /* R*s */
    const double t5 = JLT_FMA(x[4], t4, t3); /* v_tau = omega3*R*s + omega_n*b */
    const double t6 = JLT_FMA(t5, t5, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t7 = x[9]*p[16]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t10 = x[2]*t9; /* omega_tau*1/2*omega_tau */
    const double t11 = x[3]*p[47]; /* omega_n*1/2*I1 */
    const double t12 = x[4]*p[48]; /* omega3*1/2*I3 */
    const double t13 = JLT_FMA(x[3], t11, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(x[4], t12, t13); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t15 = JLT_FMA(t8, t10, t14); /* D*omega_tau*1/2*omega_tau + t14 */
    const double t16 = JLT_FMA(p[46], t6, t15); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t14 */
    const double t17 = x[9]*p[49]; /* s*R*I1 */
    const double t18 = x[3]*t17; /* omega_n*s*R*I1 */
    const double t19 = x[4]*p[5]; /* omega3*I3 */
    const double t20 = JLT_FNMA(t2, t19, t18); /* omega_n*s*R*I1 - b*omega3*I3 */
    out[0] = t16;
    out[1] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = x[3]*t0; /* omega_n*b */
    const double t2 = p[1]*x[4]; /* R*omega3 */
    const double t3 = JLT_FMA(x[9], t2, t1); /* v_tau = s*R*omega3 + omega_n*b */
    const double t4 = p[39]*t3; /* m*R*v_tau */
    const double t5 = JLT_FMA(x[3], t4, p[23]); /* omega_n*m*R*v_tau + m*g*a3 */
    const double t6 = p[0]*x[1]; /* m*v_nu */
    const double t7 = x[9]*p[16]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = x[2]*t8; /* omega_tau*D */
    const double t10 = x[3]*p[4]; /* omega_n*I1 */
    const double t11 = t0*p[0]; /* b*m */
    const double t12 = JLT_FMA(t3, t11, t10); /* v_tau*b*m + omega_n*I1 */
    const double t13 = x[4]*p[5]; /* omega3*I3 */
    const double t14 = JLT_FMA(x[9], t4, t13); /* s*m*R*v_tau + omega3*I3 */
    const double t15 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t16 = t7*t15; /* s*m*a3^2*omega_tau*omega_tau */
    const double t17 = JLT_FMA(x[4], t4, t16); /* omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    const double t18 = x[4]*p[50]; /* omega3*(-R*I3) */
    const double t19 = x[9]*p[49]; /* s*R*I1 */
    const double t20 = t0*p[22]; /* b*(-I3) */
    const double t21 = x[3]*p[49]; /* omega_n*R*I1 */
    out[0] = t5;
    out[1] = t6;
    out[2] = t9;
    out[3] = t12;
    out[4] = t14;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t17;
    out[10] = t18;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t19;
    out[14] = t20;
    out[15] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = t21;
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
    .rhs_jacobian = { rhs_jacobian, 110, { 18, 87, 37, 1, 0, 2, 9, 33 }, { 81, 486, 0, 59, 0, 2, 14, 12 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 0, 8, 9, 1, 0, 0, 8, 8 }, { 10, 39, 0, 4, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 2, { 0, 12, 9, 0, 0, 0, 5, 8 }, { 9, 31, 0, 0, 0, 0, 10, 5 },
        "" },
    .integral_gradients = { integral_gradients, 20, { 0, 15, 7, 0, 0, 0, 5, 7 }, { 9, 37, 0, 0, 0, 0, 6, 6 },
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
