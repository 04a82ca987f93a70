/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   27   15    1    0    2     10   11   (125)
 *  jacobian            16   79   34    1    0    2     13   25   (531)
 *  rhs_jacobian        18   86   37    1    0    2      9   29   (628)
 *  divergence          0    8    9    1    0    0      8    7   (53)
 *  integral_values     0   12    9    0    0    0      5    7   (40)
 *  integral_gradients  0   15    7    0    0    0      5    5   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  observe_values      2    8    6    0    0    4      3    7   (34)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, V = omega_tau*e + v_nu,
 *      m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), d(d(v_nu)/dtau)/d(omega_n),
 *      s*omega_tau*(m*a3^2)*s*omega_tau - I1*omega_n*omega_n,
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), (m*R*I3)*e + I3^2,
 *      numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*((m*R*I3)*e + I3^2) - V*(m*I3)*omega_n*b,
 *      d(omega_n)/dtau, a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s),
 *      omega_n*b + R*s*omega3, (2*I1)*omega_n*gamma3 + I3*s*omega3, d(spin)/dtau, v_nu*S - (omega_n*b + R*s*omega3)*C,
 *      d(d(y)/dtau)/d(s), d(numerator of d(omega_tau)/dt over D)/d(s),
 *      d(numerator of d(omega_n)/dt over Theta)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(s),
 *      d(d(omega_n)/dtau)/d(omega_n),
 *      d(numerator of d(omega3)/dt over Theta)/d(gamma3) = s*omega3*(m*R^2*(I1 - I3))*s*omega_tau - s*omega_tau*omega_n*(m*R*a3*I1),
 *      s*s*omega3*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))) + e*(m*R*I1)*s*omega_n,
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*((m*R*I3)*e + I3^2) - e*(m*I3)*omega_n*b,
 *      d(d(omega_n)/dtau)/d(omega_tau), S*(omega_n*b + R*s*omega3) + v_nu*C, d(d(x)/dtau)/d(s),
 *      a part of d(d(omega_n)/dtau)/d(gamma3), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(s),
 *      d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(s), d(d(omega_n)/dtau)/d(gamma3)
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
extern const jlt_descriptor jlt_kernels_spherical_top_track_general_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_track_general_in_regular;
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
    out[30] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[8] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[9] = t8;
    const double t9 = params[0]*params[2]; /* m*g */
    const double t10 = params[3]*t9; /* a3*m*g */
    out[31] = t10;
    const double t11 = t10/params[4]; /* a3*m*g/I1 */
    out[10] = t11;
    const double t12 = params[1]*params[4]; /* R*I1 */
    out[54] = t12;
    const double t13 = params[5]/t12; /* I3/(R*I1) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[55] = t14;
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[12] = t15;
    const double t16 = 1.0/params[1]; /* 1/R */
    out[13] = t16;
    const double t17 = params[4] - params[5]; /* I1 - I3 */
    const double t18 = t17/params[4]; /* (I1 - I3)/I1 */
    out[14] = t18;
    const double t19 = params[5]*params[3]; /* I3*a3 */
    const double t20 = t19/t12; /* I3*a3/(R*I1) */
    out[15] = t20;
    const double t21 = params[0]*2.0; /* m*2 */
    const double t22 = t5*t21; /* a3*a3*m*2 */
    out[40] = t22;
    const double t23 = t22/params[4]; /* a3*a3*m*2/I1 */
    out[16] = t23;
    const double t24 = -params[5]; /* -I3 */
    out[42] = t24;
    const double t25 = -t8; /* -I3/I1 */
    out[17] = t25;
    const double t26 = params[2]*t21; /* g*m*2 */
    const double t27 = params[3]*t26; /* a3*g*m*2 */
    out[43] = t27;
    const double t28 = t27/params[4]; /* a3*g*m*2/I1 */
    out[18] = t28;
    const double t29 = params[4]*params[4]; /* I1*I1 */
    const double t30 = params[5]*t22; /* I3*a3*a3*m*2 */
    const double t31 = t30/t29; /* I3*a3*a3*m*2/(I1*I1) */
    out[19] = t31;
    const double t32 = t19/t3; /* I3*a3/(R*R*I1) */
    out[20] = t32;
    const double t33 = t0*t29; /* R*R*I1*I1 */
    const double t34 = params[5]*params[5]; /* I3*I3 */
    out[35] = t34;
    const double t35 = 2.0*t34; /* 2*I3*I3 */
    const double t36 = t35/t33; /* 2*I3*I3/(R*R*I1*I1) */
    out[21] = t36;
    const double t37 = params[1]*t0; /* R*R*R */
    const double t38 = t29*t37; /* I1*I1*R*R*R */
    const double t39 = t35/t38; /* 2*I3*I3/(I1*I1*R*R*R) */
    out[22] = t39;
    const double t40 = params[5]*2.0; /* I3*2 */
    const double t41 = t40/t12; /* I3*2/(R*I1) */
    out[23] = t41;
    const double t42 = t40/t3; /* I3*2/(R*R*I1) */
    out[24] = t42;
    const double t43 = params[3]*2.0; /* a3*2 */
    const double t44 = t34*t43; /* I3*I3*a3*2 */
    const double t45 = t44/t33; /* I3*I3*a3*2/(R*R*I1*I1) */
    out[25] = t45;
    const double t46 = params[1]*t29; /* R*I1*I1 */
    const double t47 = t17*t40; /* (I1 - I3)*I3*2 */
    const double t48 = t47/t46; /* (I1 - I3)*I3*2/(R*I1*I1) */
    out[26] = t48;
    const double t49 = params[3]/params[1]; /* a3/R */
    out[27] = t49;
    const double t50 = params[4]/params[0]; /* I1/m */
    out[28] = t50;
    const double t51 = 2.0/params[1]; /* 2/R */
    out[29] = t51;
    const double t52 = params[5]*params[4]; /* I3*I1 */
    out[32] = t52;
    const double t53 = t1*params[4]; /* m*R*R*I1 */
    out[33] = t53;
    const double t54 = params[0]*params[5]; /* m*I3 */
    out[34] = t54;
    const double t55 = params[5]*t14; /* I3*m*R */
    out[36] = t55;
    const double t56 = params[4]*t14; /* I1*m*R */
    out[37] = t56;
    const double t57 = params[3]*t14; /* a3*m*R */
    const double t58 = params[5]*t57; /* I3*a3*m*R */
    out[38] = t58;
    const double t59 = t1*t17; /* m*R*R*(I1 - I3) */
    out[39] = t59;
    const double t60 = params[4]*2.0; /* I1*2 */
    out[41] = t60;
    const double t61 = params[0]*params[3]; /* m*a3 */
    const double t62 = params[5]*t61; /* I3*m*a3 */
    out[44] = t62;
    const double t63 = params[1]*t21; /* R*m*2 */
    const double t64 = params[5]*t63; /* I3*R*m*2 */
    out[45] = t64;
    const double t65 = t0*t21; /* R*R*m*2 */
    const double t66 = params[4]*t65; /* I1*R*R*m*2 */
    out[46] = t66;
    const double t67 = params[4]*t57; /* I1*a3*m*R */
    out[47] = t67;
    const double t68 = -t56; /* -I1*m*R */
    out[48] = t68;
    const double t69 = t17*t65; /* (I1 - I3)*R*R*m*2 */
    out[49] = t69;
    const double t70 = params[3]*t63; /* a3*R*m*2 */
    const double t71 = params[5]*t70; /* I3*a3*R*m*2 */
    out[50] = t71;
    const double t72 = params[0]/2.0; /* m/2 */
    out[51] = t72;
    const double t73 = params[4]/2.0; /* I1/2 */
    out[52] = t73;
    const double t74 = params[5]/2.0; /* I3/2 */
    out[53] = t74;
    const double t75 = params[1]*params[5]; /* R*I3 */
    const double t76 = -t75; /* -R*I3 */
    out[56] = t76;
    const double t77 = (-1.0)/params[1]; /* (-1)/R */
    out[57] = t77;
    const double t78 = t19/params[4]; /* I3*a3/I1 */
    out[58] = t78;
    const double t79 = params[1]*t17; /* R*(I1 - I3) */
    const double t80 = t79/params[4]; /* R*(I1 - I3)/I1 */
    out[59] = t80;
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
    const double t34 = x[9]*p[13]; /* s*1/R */
    const double t35 = t32*t34; /* 1/(Theta/(m*R^2*I1))*omega_n*V*s*1/R */
    const double t36 = t11*p[14]; /* gamma3*omega_tau*s*(I1 - I3)/I1 */
    const double t37 = JLT_FNMA(t10, p[15], t36); /* gamma3*omega_tau*s*(I1 - I3)/I1 - omega_tau*s*a3*I3/(R*I1) */
    const double t38 = JLT_FMS(t26, t37, t35); /* s*omega3*1/(Theta/(m*R^2*I1))*(gamma3*omega_tau*s*(I1 - I3)/I1 - omega_tau*s*a3*I3/(R*I1)) - 1/(Theta/(m*R^2*I1))*omega_n*V*s*1/R */
    out[4] = t38;
    const double t39 = -x[3]; /* -omega_n */
    out[5] = t39;
    const double t40 = t4 + t14; /* s*omega3 + omega_n*gamma3 */
    out[6] = t40;
    const double t41 = cos(x[5]); /* C = cos(chi) */
    const double t42 = x[1]*t41; /* v_nu*C */
    const double t43 = sin(x[5]); /* S = sin(chi) */
    const double t44 = JLT_FMA(t5, t43, t42); /* (R*s*omega3 + omega_n*b)*S + v_nu*C */
    const double t45 = x[9]*t44; /* s*((R*s*omega3 + omega_n*b)*S + v_nu*C) */
    out[7] = t45;
    const double t46 = x[1]*t43; /* v_nu*S */
    const double t47 = JLT_FNMA(t5, t41, t46); /* v_nu*S - (R*s*omega3 + omega_n*b)*C */
    const double t48 = x[9]*t47; /* s*(v_nu*S - (R*s*omega3 + omega_n*b)*C) */
    out[8] = t48;
    const double t49 = -t11; /* -gamma3*omega_tau*s */
    out[9] = t49;
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
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
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
    const double t11 = x[3]*x[4]; /* omega_n*omega3 */
    const double t12 = p[1]*t11; /* R*omega_n*omega3 */
    out[19] = t12;
    const double t13 = t5*t5; /* b*b */
    const double t14 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t15 = JLT_FMA(p[7], t13, t14); /* Theta/(m*R^2*I1) = I3/(R^2*I1)*b*b + s*s + I3/(m*R^2) */
    const double t16 = JLT_FMA(t0, p[8], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t17 = t15*t16; /* Theta/(m*R^2*I1)*D/I1 */
    const double t18 = 1.0/t17; /* 1/(Theta/(m*R^2*I1)*D/I1) */
    const double t19 = t15*t18; /* 1/(D/I1) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t20 = x[9]*t19; /* s*1/(D/I1) */
    const double t21 = t1*t20; /* s*omega_tau*s*1/(D/I1) */
    const double t22 = x[2]*p[8]; /* omega_tau*m*a3^2/I1 */
    const double t23 = t21*t22; /* s*omega_tau*s*1/(D/I1)*omega_tau*m*a3^2/I1 */
    const double t24 = JLT_FNMA(t3, t19, t23); /* s*omega_tau*s*1/(D/I1)*omega_tau*m*a3^2/I1 - omega_n*omega_n*1/(D/I1) */
    out[20] = t24;
    const double t25 = x[0]*p[16]; /* gamma3*2*m*a3^2/I1 */
    const double t26 = t21*t25; /* s*omega_tau*s*1/(D/I1)*gamma3*2*m*a3^2/I1 */
    out[22] = t26;
    const double t27 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t28 = (-2.0)*t27; /* (-2)*omega_n*gamma3 */
    const double t29 = t19*t28; /* 1/(D/I1)*(-2)*omega_n*gamma3 */
    const double t30 = x[4]*t20; /* omega3*s*1/(D/I1) */
    const double t31 = JLT_FMA(p[17], t30, t29); /* (-I3/I1)*omega3*s*1/(D/I1) + 1/(D/I1)*(-2)*omega_n*gamma3 */
    out[23] = t31;
    const double t32 = x[3]*t20; /* omega_n*s*1/(D/I1) */
    const double t33 = p[17]*t32; /* (-I3/I1)*omega_n*s*1/(D/I1) */
    out[24] = t33;
    const double t34 = JLT_FMA(x[2], x[2], t3); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t35 = JLT_FNMA(t25, t34, p[18]); /* 2*m*g*a3/I1 - gamma3*2*m*a3^2/I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t36 = t20*t35; /* s*1/(D/I1)*t35 */
    const double t37 = JLT_FMA(t11, p[9], t36); /* omega_n*omega3*I3/I1 + s*1/(D/I1)*t35 */
    const double t38 = t19*t37; /* 1/(D/I1)*(omega_n*omega3*I3/I1 + s*1/(D/I1)*t35) */
    const double t39 = t32*p[19]; /* omega_n*s*1/(D/I1)*2*m*a3^2*I3/I1^2 */
    const double t40 = JLT_FMS(t30, t39, t38); /* omega3*s*1/(D/I1)*omega_n*s*1/(D/I1)*2*m*a3^2*I3/I1^2 - 1/(D/I1)*(omega_n*omega3*I3/I1 + s*1/(D/I1)*t35) */
    out[29] = t40;
    const double t41 = t16*t18; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t42 = x[9]*t41; /* s*1/(Theta/(m*R^2*I1)) */
    const double t43 = x[2]*t42; /* omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t44 = x[4]*t43; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t45 = t5*t41; /* b*1/(Theta/(m*R^2*I1)) */
    const double t46 = x[3]*p[20]; /* omega_n*a3*I3/(R^2*I1) */
    const double t47 = JLT_FNMA(t45, t46, x[3]); /* omega_n - b*1/(Theta/(m*R^2*I1))*omega_n*a3*I3/(R^2*I1) */
    const double t48 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t49 = JLT_FMA(x[2], t48, x[1]); /* V = omega_tau*e + v_nu */
    const double t50 = x[3]*t49; /* omega_n*V */
    const double t51 = t41*t50; /* 1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t52 = p[11]*t51; /* I3/(R*I1)*1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t53 = t48 + p[12]; /* e + I3/(m*R) */
    const double t54 = t44*t53; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t55 = t45*p[21]; /* b*1/(Theta/(m*R^2*I1))*2*I3^2/(R^2*I1^2) */
    const double t56 = t45*t50; /* b*1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t57 = t45*p[22]; /* b*1/(Theta/(m*R^2*I1))*2*I3^2/(R^3*I1^2) */
    const double t58 = JLT_FMS(t56, t57, t52); /* b*1/(Theta/(m*R^2*I1))*omega_n*V*b*1/(Theta/(m*R^2*I1))*2*I3^2/(R^3*I1^2) - I3/(R*I1)*1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t59 = JLT_FMA(p[15], t44, t58); /* a3*I3/(R*I1)*omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) + t58 */
    const double t60 = JLT_FMA(x[2], t47, t59); /* omega_tau*(omega_n - b*1/(Theta/(m*R^2*I1))*omega_n*a3*I3/(R^2*I1)) + a3*I3/(R*I1)*omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) + t58 */
    const double t61 = JLT_FNMA(t54, t55, t60); /* t60 - omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*(e + I3/(m*R))*b*1/(Theta/(m*R^2*I1))*2*I3^2/(R^2*I1^2) */
    out[30] = t61;
    const double t62 = p[7]*t45; /* I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    const double t63 = x[3]*t62; /* omega_n*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    const double t64 = -t63; /* -omega_n*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    out[31] = t64;
    const double t65 = x[4]*t42; /* omega3*s*1/(Theta/(m*R^2*I1)) */
    const double t66 = p[11]*t53; /* I3/(R*I1)*(e + I3/(m*R)) */
    const double t67 = JLT_FMA(t65, t66, t27); /* omega3*s*1/(Theta/(m*R^2*I1))*I3/(R*I1)*(e + I3/(m*R)) + omega_n*gamma3 */
    const double t68 = JLT_FNMA(t48, t63, t67); /* t67 - e*omega_n*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    out[32] = t68;
    const double t69 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t70 = JLT_FNMA(t49, t62, t69); /* omega_tau*gamma3 - V*I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1)) */
    out[33] = t70;
    const double t71 = t43*t66; /* omega_tau*s*1/(Theta/(m*R^2*I1))*I3/(R*I1)*(e + I3/(m*R)) */
    out[34] = t71;
    const double t72 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t73 = t66*t72; /* I3/(R*I1)*(e + I3/(m*R))*omega_tau*omega3 */
    const double t74 = t41*t73; /* 1/(Theta/(m*R^2*I1))*I3/(R*I1)*(e + I3/(m*R))*omega_tau*omega3 */
    const double t75 = t56*p[24]; /* b*1/(Theta/(m*R^2*I1))*omega_n*V*2*I3/(R^2*I1) */
    const double t76 = JLT_FMS(t54, p[23], t75); /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*(e + I3/(m*R))*2*I3/(R*I1) - b*1/(Theta/(m*R^2*I1))*omega_n*V*2*I3/(R^2*I1) */
    const double t77 = JLT_FNMA(t42, t76, t74); /* t74 - s*1/(Theta/(m*R^2*I1))*t76 */
    out[39] = t77;
    const double t78 = JLT_FNMA(x[0], p[26], p[25]); /* 2*a3*I3^2/(R^2*I1^2) - gamma3*2*I3*(I1 - I3)/(R*I1^2) */
    const double t79 = t44*t78; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*(2*a3*I3^2/(R^2*I1^2) - gamma3*2*I3*(I1 - I3)/(R*I1^2)) */
    const double t80 = JLT_FMA(t5, t79, t75); /* b*t79 + b*1/(Theta/(m*R^2*I1))*omega_n*V*2*I3/(R^2*I1) */
    const double t81 = x[3]*p[27]; /* omega_n*a3/R */
    const double t82 = t43*t81; /* omega_tau*s*1/(Theta/(m*R^2*I1))*omega_n*a3/R */
    const double t83 = x[9]*p[14]; /* s*(I1 - I3)/I1 */
    const double t84 = JLT_FMS(t44, t83, t82); /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 - omega_tau*s*1/(Theta/(m*R^2*I1))*omega_n*a3/R */
    const double t85 = JLT_FMA(t42, t80, t84); /* s*1/(Theta/(m*R^2*I1))*(b*t79 + b*1/(Theta/(m*R^2*I1))*omega_n*V*2*I3/(R^2*I1)) + t84 */
    out[40] = t85;
    const double t86 = t42*p[13]; /* s*1/(Theta/(m*R^2*I1))*1/R */
    const double t87 = x[3]*t86; /* omega_n*s*1/(Theta/(m*R^2*I1))*1/R */
    const double t88 = -t87; /* -omega_n*s*1/(Theta/(m*R^2*I1))*1/R */
    out[41] = t88;
    const double t89 = t48*t87; /* e*omega_n*s*1/(Theta/(m*R^2*I1))*1/R */
    const double t90 = x[9]*p[15]; /* s*a3*I3/(R*I1) */
    const double t91 = JLT_FNMA(x[0], t83, t90); /* s*a3*I3/(R*I1) - gamma3*s*(I1 - I3)/I1 */
    const double t92 = JLT_FMA(t65, t91, t89); /* omega3*s*1/(Theta/(m*R^2*I1))*(s*a3*I3/(R*I1) - gamma3*s*(I1 - I3)/I1) + e*omega_n*s*1/(Theta/(m*R^2*I1))*1/R */
    const double t93 = -t92; /* -t92 */
    out[42] = t93;
    const double t94 = t49*t86; /* V*s*1/(Theta/(m*R^2*I1))*1/R */
    const double t95 = -t94; /* -V*s*1/(Theta/(m*R^2*I1))*1/R */
    out[43] = t95;
    const double t96 = t43*t91; /* omega_tau*s*1/(Theta/(m*R^2*I1))*(s*a3*I3/(R*I1) - gamma3*s*(I1 - I3)/I1) */
    const double t97 = -t96; /* -t96 */
    out[44] = t97;
    const double t98 = t13 + p[28]; /* b*b + I1/m */
    const double t99 = t41*t98; /* 1/(Theta/(m*R^2*I1))*(b*b + I1/m) */
    const double t100 = JLT_FMA(t79, t99, t51); /* t79*1/(Theta/(m*R^2*I1))*(b*b + I1/m) + 1/(Theta/(m*R^2*I1))*omega_n*V */
    const double t101 = p[13]*t100; /* 1/R*t100 */
    const double t102 = t50*p[29]; /* omega_n*V*2/R */
    const double t103 = t42*t102; /* s*1/(Theta/(m*R^2*I1))*omega_n*V*2/R */
    const double t104 = JLT_FMS(t42, t103, t101); /* s*1/(Theta/(m*R^2*I1))*s*1/(Theta/(m*R^2*I1))*omega_n*V*2/R - 1/R*t100 */
    out[49] = t104;
    out[53] = (-1.0);
    const double t105 = sin(x[5]); /* S = sin(chi) */
    const double t106 = t10*t105; /* omega_n*s*R*S */
    out[70] = t106;
    const double t107 = cos(x[5]); /* C = cos(chi) */
    const double t108 = x[9]*t107; /* s*C */
    out[71] = t108;
    const double t109 = x[9]*t105; /* s*S */
    out[81] = t109;
    const double t110 = t5*t109; /* b*s*S */
    out[73] = t110;
    const double t111 = t7*t109; /* s*R*s*S */
    out[74] = t111;
    const double t112 = x[1]*t109; /* v_nu*s*S */
    const double t113 = t6 + t8; /* v_tau = omega_n*b + omega3*s*R */
    const double t114 = JLT_FMS(t108, t113, t112); /* s*C*v_tau - v_nu*s*S */
    out[75] = t114;
    const double t115 = x[1]*t107; /* v_nu*C */
    const double t116 = t8 + t113; /* omega3*s*R + v_tau */
    const double t117 = JLT_FMA(t105, t116, t115); /* S*(omega3*s*R + v_tau) + v_nu*C */
    out[79] = t117;
    const double t118 = t10*t107; /* omega_n*s*R*C */
    const double t119 = -t118; /* -omega_n*s*R*C */
    out[80] = t119;
    const double t120 = t5*t108; /* b*s*C */
    const double t121 = -t120; /* -b*s*C */
    out[83] = t121;
    const double t122 = t7*t108; /* s*R*s*C */
    const double t123 = -t122; /* -s*R*s*C */
    out[84] = t123;
    const double t124 = x[1]*t108; /* v_nu*s*C */
    const double t125 = JLT_FMA(t109, t113, t124); /* s*S*v_tau + v_nu*s*C */
    out[85] = t125;
    const double t126 = x[1]*t105; /* v_nu*S */
    const double t127 = JLT_FNMA(t107, t116, t126); /* v_nu*S - C*(omega3*s*R + v_tau) */
    out[89] = t127;
    const double t128 = -t1; /* -s*omega_tau */
    out[90] = t128;
    const double t129 = x[9]*x[0]; /* s*gamma3 */
    const double t130 = -t129; /* -s*gamma3 */
    out[92] = t130;
    const double t131 = -t69; /* -omega_tau*gamma3 */
    out[99] = t131;
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
    const double t3 = p[34]*t1; /* m*I3*b */
    const double t4 = JLT_FMA(p[33], t2, p[32]); /* m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(t1, t3, t4); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t6 = JLT_FMA(p[30], t2, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t7 = t5*t6; /* Theta*D */
    const double t8 = 1.0/t7; /* 1/(Theta*D) */
    const double t9 = t6*t8; /* 1/Theta = D*1/(Theta*D) */
    const double t10 = t5*t8; /* 1/D = Theta*1/(Theta*D) */
    const double t11 = x[9]*x[2]; /* s*omega_tau */
    const double t12 = x[9]*t11; /* s*s*omega_tau */
    out[0] = t12;
    const double t13 = 2.0*t11; /* 2*s*omega_tau */
    out[19] = t13;
    const double t14 = -t11; /* -s*omega_tau */
    out[100] = t14;
    const double t15 = x[3]*t1; /* omega_n*b */
    const double t16 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t17 = x[9]*x[3]; /* s*omega_n */
    const double t18 = x[9]*x[4]; /* s*omega3 */
    const double t19 = p[30]*t11; /* m*a3^2*s*omega_tau */
    const double t20 = t11*t19; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t21 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t22 = -t21; /* -omega_tau*gamma3 */
    out[109] = t22;
    const double t23 = JLT_FMA(x[2], t16, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = p[34]*t15; /* m*I3*omega_n*b */
    const double t25 = x[4]*t11; /* omega3*s*omega_tau */
    const double t26 = p[37]*t17; /* m*R*I1*s*omega_n */
    const double t27 = JLT_FNMA(x[0], p[39], p[38]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t28 = p[40]*t11; /* 2*m*a3^2*s*omega_tau */
    const double t29 = t21*t28; /* omega_tau*gamma3*2*m*a3^2*s*omega_tau */
    const double t30 = JLT_FNMA(x[9], p[43], t29); /* omega_tau*gamma3*2*m*a3^2*s*omega_tau - s*2*m*g*a3 */
    const double t31 = x[0]*p[49]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t32 = t25*t31; /* omega3*s*omega_tau*gamma3*2*m*R^2*(I1 - I3) */
    const double t33 = JLT_FNMA(p[50], t25, t32); /* omega3*s*omega_tau*gamma3*2*m*R^2*(I1 - I3) - 2*m*R*a3*I3*omega3*s*omega_tau */
    const double t34 = p[1]*t18; /* R*s*omega3 */
    const double t35 = JLT_FMA(2.0, t15, t34); /* 2*omega_n*b + R*s*omega3 */
    out[23] = t35;
    const double t36 = x[3]*x[3]; /* omega_n*omega_n */
    const double t37 = JLT_FNMA(p[4], t36, t20); /* s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n */
    const double t38 = p[1]*t36; /* R*omega_n*omega_n */
    out[20] = t38;
    const double t39 = t10*t37; /* 1/D*(s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n) */
    out[30] = t39;
    const double t40 = p[31]*t2; /* m*g*a3*s*s */
    const double t41 = p[1]*t2; /* R*s*s */
    const double t42 = p[5]*t18; /* I3*s*omega3 */
    const double t43 = JLT_FMA(x[3], t42, t40); /* omega_n*I3*s*omega3 + m*g*a3*s*s */
    const double t44 = JLT_FNMA(x[0], t37, t43); /* omega_n*I3*s*omega3 + m*g*a3*s*s - gamma3*(s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n) */
    const double t45 = t10*t44; /* 1/D*t44 */
    const double t46 = -t45; /* -1/D*t44 */
    out[2] = t46;
    const double t47 = t23*t24; /* V*m*I3*omega_n*b */
    const double t48 = JLT_FMA(p[36], t16, p[35]); /* m*R*I3*e + I3^2 */
    const double t49 = JLT_FMS(t25, t48, t47); /* numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*(m*R*I3*e + I3^2) - V*m*I3*omega_n*b */
    const double t50 = p[38]*t25; /* m*R*a3*I3*omega3*s*omega_tau */
    const double t51 = t9*t49; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t52 = JLT_FMA(x[3], t21, t51); /* omega_n*omega_tau*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t52;
    const double t53 = t23*t26; /* V*m*R*I1*s*omega_n */
    const double t54 = t18*t27; /* s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t55 = JLT_FMA(t11, t54, t53); /* s*omega_tau*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + V*m*R*I1*s*omega_n */
    const double t56 = t9*t55; /* 1/Theta*t55 */
    const double t57 = t11*t27; /* s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t58 = -t56; /* -1/Theta*t55 */
    out[4] = t58;
    const double t59 = sin(x[5]); /* S = sin(chi) */
    const double t60 = t41*t59; /* R*s*s*S */
    out[84] = t60;
    const double t61 = x[2]*p[44]; /* omega_tau*m*a3*I3 */
    const double t62 = JLT_FNMA(t15, t61, t50); /* m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 */
    const double t63 = t15 + t34; /* omega_n*b + R*s*omega3 */
    const double t64 = x[3]*t63; /* omega_n*(omega_n*b + R*s*omega3) */
    out[1] = t64;
    const double t65 = x[3]*p[47]; /* omega_n*m*R*a3*I1 */
    const double t66 = t11*t65; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t67 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t68 = JLT_FMA(p[41], t67, t42); /* 2*I1*omega_n*gamma3 + I3*s*omega3 */
    const double t69 = t10*t68; /* 1/D*(2*I1*omega_n*gamma3 + I3*s*omega3) */
    const double t70 = -t69; /* -1/D*(2*I1*omega_n*gamma3 + I3*s*omega3) */
    out[33] = t70;
    const double t71 = t18 + t67; /* s*omega3 + omega_n*gamma3 */
    out[6] = t71;
    const double t72 = cos(x[5]); /* C = cos(chi) */
    const double t73 = t41*t72; /* R*s*s*C */
    const double t74 = -t73; /* -R*s*s*C */
    out[94] = t74;
    const double t75 = x[1]*t59; /* v_nu*S */
    const double t76 = JLT_FNMA(t63, t72, t75); /* v_nu*S - (omega_n*b + R*s*omega3)*C */
    const double t77 = JLT_FNMA(t34, t72, t76); /* v_nu*S - (omega_n*b + R*s*omega3)*C - R*s*omega3*C */
    out[99] = t77;
    const double t78 = x[9]*t76; /* s*(v_nu*S - (omega_n*b + R*s*omega3)*C) */
    out[8] = t78;
    const double t79 = -t78; /* -s*(v_nu*S - (omega_n*b + R*s*omega3)*C) */
    out[85] = t79;
    const double t80 = x[3]*x[4]; /* omega_n*omega3 */
    const double t81 = JLT_FNMA(p[5], t80, t30); /* d(numerator of d(omega_tau)/dt over D)/d(s) = omega_tau*gamma3*2*m*a3^2*s*omega_tau - s*2*m*g*a3 - I3*omega_n*omega3 */
    const double t82 = p[1]*t80; /* R*omega_n*omega3 */
    out[29] = t82;
    const double t83 = t10*t81; /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) */
    const double t84 = x[3]*t23; /* omega_n*V */
    const double t85 = JLT_FNMA(p[36], t84, t62); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 - m*R*I3*omega_n*V */
    const double t86 = JLT_FNMA(p[37], t84, t33); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t33 - m*R*I1*omega_n*V */
    const double t87 = t9*t23; /* 1/Theta*V */
    const double t88 = JLT_FNMA(t3, t87, t21); /* omega_tau*gamma3 - m*I3*b*1/Theta*V */
    out[43] = t88;
    const double t89 = t9*t86; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t90 = p[39]*t11; /* m*R^2*(I1 - I3)*s*omega_tau */
    const double t91 = JLT_FMS(t18, t90, t66); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = s*omega3*m*R^2*(I1 - I3)*s*omega_tau - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t92 = t16*t26; /* e*m*R*I1*s*omega_n */
    const double t93 = JLT_FMA(x[9], t54, t92); /* s*s*omega3*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*m*R*I1*s*omega_n */
    const double t94 = t16*t24; /* e*m*I3*omega_n*b */
    const double t95 = JLT_FMS(t18, t48, t94); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(m*R*I3*e + I3^2) - e*m*I3*omega_n*b */
    const double t96 = JLT_FMA(t9, t95, t67); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[42] = t96;
    const double t97 = t9*t48; /* 1/Theta*(m*R*I3*e + I3^2) */
    const double t98 = t9*t24; /* 1/Theta*m*I3*omega_n*b */
    const double t99 = -t98; /* -1/Theta*m*I3*omega_n*b */
    out[41] = t99;
    const double t100 = t9*t26; /* 1/Theta*m*R*I1*s*omega_n */
    const double t101 = -t100; /* -1/Theta*m*R*I1*s*omega_n */
    out[51] = t101;
    const double t102 = t9*t93; /* 1/Theta*t93 */
    const double t103 = -t102; /* -1/Theta*t93 */
    out[52] = t103;
    const double t104 = t11*t97; /* s*omega_tau*1/Theta*(m*R*I3*e + I3^2) */
    out[44] = t104;
    const double t105 = x[0]*t11; /* gamma3*s*omega_tau */
    const double t106 = -t105; /* -gamma3*s*omega_tau */
    out[9] = t106;
    const double t107 = x[1]*t72; /* v_nu*C */
    const double t108 = JLT_FMA(t59, t63, t107); /* S*(omega_n*b + R*s*omega3) + v_nu*C */
    const double t109 = JLT_FMA(t34, t59, t108); /* R*s*omega3*S + S*(omega_n*b + R*s*omega3) + v_nu*C */
    out[89] = t109;
    const double t110 = x[9]*t108; /* s*(S*(omega_n*b + R*s*omega3) + v_nu*C) */
    out[7] = t110;
    out[95] = t110;
    const double t111 = p[1]*t17; /* R*s*omega_n */
    out[24] = t111;
    const double t112 = p[42]*t17; /* (-I3)*s*omega_n */
    const double t113 = t10*t112; /* 1/D*(-I3)*s*omega_n */
    out[34] = t113;
    const double t114 = t59*t111; /* S*R*s*omega_n */
    out[80] = t114;
    const double t115 = x[9]*t59; /* s*S */
    out[91] = t115;
    const double t116 = t1*t115; /* b*s*S */
    out[83] = t116;
    const double t117 = t72*t111; /* C*R*s*omega_n */
    const double t118 = -t117; /* -C*R*s*omega_n */
    out[90] = t118;
    const double t119 = x[9]*t72; /* s*C */
    out[81] = t119;
    const double t120 = t1*t119; /* b*s*C */
    const double t121 = -t120; /* -b*s*C */
    out[93] = t121;
    const double t122 = p[45]*t1; /* 2*m*R*I3*b */
    const double t123 = JLT_FNMA(t51, t122, t85); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R*I3*b */
    const double t124 = JLT_FMA(t56, t122, t91); /* 1/Theta*t55*2*m*R*I3*b + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t125 = t9*t124; /* 1/Theta*t124 */
    out[50] = t125;
    const double t126 = x[9]*p[40]; /* s*2*m*a3^2 */
    const double t127 = t10*t126; /* 1/D*s*2*m*a3^2 */
    const double t128 = JLT_FMA(t45, t127, t83); /* 1/D*t44*1/D*s*2*m*a3^2 + 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) */
    out[39] = t128;
    const double t129 = t105*t127; /* gamma3*s*omega_tau*1/D*s*2*m*a3^2 */
    out[32] = t129;
    const double t130 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t131 = t97*t130; /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 */
    const double t132 = x[9]*t9; /* s*1/Theta */
    const double t133 = t57*t132; /* s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*1/Theta */
    const double t134 = -t133; /* -s*omega_tau*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*1/Theta */
    out[54] = t134;
    const double t135 = p[46]*t132; /* 2*m*R^2*I1*s*1/Theta */
    const double t136 = JLT_FNMA(t51, t135, t131); /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    out[49] = t136;
    const double t137 = JLT_FMA(t56, t135, t89); /* 1/Theta*t55*2*m*R^2*I1*s*1/Theta + 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    out[59] = t137;
    const double t138 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t139 = JLT_FMA(t9, t123, t138); /* 1/Theta*t123 + omega_tau*omega_n */
    out[40] = t139;
    const double t140 = x[9]*p[48]; /* s*(-m*R*I1) */
    const double t141 = t87*t140; /* 1/Theta*V*s*(-m*R*I1) */
    out[53] = t141;
    const double t142 = x[9]*x[0]; /* s*gamma3 */
    const double t143 = -t142; /* -s*gamma3 */
    out[102] = t143;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[0]*t1; /* gamma3*omega_tau*s*s */
    const double t4 = p[34]*t2; /* m*I3*b */
    const double t5 = JLT_FMA(p[33], t0, p[32]); /* m*R^2*I1*s*s + I1*I3 */
    const double t6 = JLT_FMA(t2, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t7 = JLT_FMA(p[30], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t8 = p[39]*t3; /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s */
    const double t9 = JLT_FNMA(p[38], t1, t8); /* d(numerator of d(omega3)/dt over Theta)/d(omega3) = m*R^2*(I1 - I3)*gamma3*omega_tau*s*s - m*R*a3*I3*omega_tau*s*s */
    const double t10 = p[40]*t3; /* 2*m*a3^2*gamma3*omega_tau*s*s */
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
    const double t0 = p[31]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t2 = x[3]*p[52]; /* omega_n*1/2*I1 */
    const double t3 = JLT_FMA(x[3], t2, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t4 = x[3]*t1; /* omega_n*b */
    const double t5 = p[1]*x[9]; /* R*s */
    const double t6 = JLT_FMA(x[4], t5, t4); /* v_tau = omega3*R*s + omega_n*b */
    const double t7 = x[9]*p[30]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t10 = x[2]*t9; /* omega_tau*1/2*omega_tau */
    const double t11 = x[4]*p[53]; /* omega3*1/2*I3 */
    const double t12 = JLT_FMA(x[4], t11, t3); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t8, t10, t12); /* D*omega_tau*1/2*omega_tau + t12 */
    const double t14 = x[1]*x[1]; /* v_nu*v_nu */
    const double t15 = JLT_FMA(t6, t6, t14); /* v_tau*v_tau + v_nu*v_nu */
    const double t16 = JLT_FMA(p[51], t15, t13); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t12 */
    out[0] = t16;
    const double t17 = x[9]*p[54]; /* s*R*I1 */
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
    const double t1 = x[4]*p[56]; /* omega3*(-R*I3) */
    out[10] = t1;
    const double t2 = x[9]*p[54]; /* s*R*I1 */
    out[13] = t2;
    const double t3 = x[3]*p[54]; /* omega_n*R*I1 */
    out[19] = t3;
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = p[42]*t4; /* (-I3)*b */
    out[14] = t5;
    const double t6 = x[3]*t4; /* omega_n*b */
    const double t7 = p[0]*t4; /* m*b */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(x[9], t8, t6); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = x[9]*p[30]; /* s*m*a3^2 */
    const double t11 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t12 = t10*t11; /* s*m*a3^2*omega_tau*omega_tau */
    const double t13 = JLT_FMA(x[9], t10, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = x[2]*t13; /* omega_tau*D */
    out[2] = t14;
    const double t15 = p[55]*t9; /* m*R*v_tau */
    const double t16 = JLT_FMA(x[4], t15, t12); /* omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    out[9] = t16;
    const double t17 = JLT_FMA(x[3], t15, p[31]); /* omega_n*m*R*v_tau + m*g*a3 */
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

static void observe_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = cos(x[5]); /* C = cos(chi) */
    const double t1 = x[9]*t0; /* s*C */
    out[2] = t1;
    out[6] = t1;
    const double t2 = JLT_FNMA(p[3], t1, x[7]); /* x_contact = x - a3*s*C */
    out[0] = t2;
    const double t3 = sin(x[5]); /* S = sin(chi) */
    const double t4 = x[9]*t3; /* s*S */
    out[3] = t4;
    out[9] = t4;
    const double t5 = JLT_FNMA(p[3], t4, x[8]); /* y_contact = y - a3*s*S */
    out[1] = t5;
    const double t6 = sin(x[6]); /* Q = sin(spin) */
    const double t7 = t0*t6; /* C*Q */
    const double t8 = cos(x[6]); /* P = cos(spin) */
    const double t9 = t3*t8; /* S*P */
    const double t10 = JLT_FMA(x[0], t7, t9); /* alpha1 = gamma3*C*Q + S*P */
    out[4] = t10;
    const double t11 = t0*t8; /* C*P */
    const double t12 = t3*t6; /* S*Q */
    const double t13 = JLT_FMS(x[0], t11, t12); /* alpha2 = gamma3*C*P - S*Q */
    out[5] = t13;
    const double t14 = JLT_FMS(x[0], t12, t11); /* beta1 = gamma3*S*Q - C*P */
    out[7] = t14;
    const double t15 = JLT_FMA(x[0], t9, t7); /* beta2 = gamma3*S*P + C*Q */
    out[8] = t15;
    const double t16 = x[9]*t6; /* s*Q */
    const double t17 = -t16; /* -s*Q */
    out[10] = t17;
    const double t18 = x[9]*t8; /* s*P */
    const double t19 = -t18; /* -s*P */
    out[11] = t19;
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
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double u52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double u54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
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
        t20[k] = -x3[k];
        t21[k] = jlt_jet_product(x9, x9, k);
        t22[k] = jlt_jet_product(x2, x0, k);
        t23[k] = jlt_jet_product(x2, t21, k);
        t24[k] = (k == 0 ? p[27] : 0) + x0[k];
        t25[k] = p[8]*t22[k];
        t26[k] = jlt_jet_product(t23, t25, k);
        t27[k] = t26[k] - p[10]*t21[k];
        t28[k] = jlt_jet_product(x9, x4, k);
        t29[k] = jlt_jet_product(x3, x0, k);
        t30[k] = t28[k] + t29[k];
        t31[k] = p[9]*t28[k] + t29[k];
        t32[k] = t27[k] - jlt_jet_product(x3, t31, k);
        t33[k] = p[9]*t24[k];
        t34[k] = (k == 0 ? p[6] : 0) + t21[k];
        t35[k] = jlt_jet_product(t24, t33, k) + t34[k];
        t36[k] = p[8]*t21[k] + (k == 0 ? 1.0 : 0);
        t37[k] = jlt_jet_quotient(t32[k], t36, t37, k);
        t38[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t35, t38, k);
        t39[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t40[k] = jlt_jet_product(x2, t39, k) + x1[k];
        t41[k] = jlt_jet_product(x3, t40, k);
        t42[k] = (k == 0 ? p[12] : 0) + t39[k];
        t43[k] = jlt_jet_product(t24, t41, k);
        t44[k] = jlt_jet_product(x3, t24, k) + t28[k];
        t45[k] = jlt_jet_product(x2, t28, k);
        t46[k] = t43[k] - jlt_jet_product(t42, t45, k);
        t47[k] = p[1]*t44[k];
        t48[k] = p[11]*t46[k];
        t49[k] = jlt_jet_product(x3, t47, k);
        t50[k] = (k == 0 ? p[58] : 0) - x0[k]*p[59];
        t51[k] = jlt_jet_product(t45, t50, k) + t41[k];
        t52[k] = jlt_jet_cosine(x5, t52, u52, k);
        t53[k] = jlt_jet_product(x9, t52, k);
        t54[k] = jlt_jet_sine(x5, t54, u54, k);
        t55[k] = jlt_jet_product(x9, t54, k);
        t56[k] = x9[k]*p[57];
        t57[k] = jlt_jet_product(t51, t56, k);
        t58[k] = jlt_jet_product(t38, t57, k);
        t59[k] = jlt_jet_product(x3, t22, k);
        t60[k] = t59[k] - jlt_jet_product(t38, t48, k);
        t61[k] = jlt_jet_product(x9, t22, k);
        t62[k] = -t61[k];
        t63[k] = jlt_jet_product(x1, t53, k);
        t64[k] = jlt_jet_product(t47, t55, k) + t63[k];
        t65[k] = jlt_jet_product(x1, t55, k);
        t66[k] = t65[k] - jlt_jet_product(t47, t53, k);
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t23[k]/(k + 1);
        next[1] = x1[k + 1] = t49[k]/(k + 1);
        next[2] = x2[k + 1] = t37[k]/(k + 1);
        next[3] = x3[k + 1] = t60[k]/(k + 1);
        next[4] = x4[k + 1] = t58[k]/(k + 1);
        next[5] = x5[k + 1] = t20[k]/(k + 1);
        next[6] = x6[k + 1] = t30[k]/(k + 1);
        next[7] = x7[k + 1] = t64[k]/(k + 1);
        next[8] = x8[k + 1] = t66[k]/(k + 1);
        next[9] = x9[k + 1] = t62[k]/(k + 1);
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
};

static const jlt_quantity observes[] = {
    { "x_contact", "m", "contact point, along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y_contact", "m", "contact point, along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "x_axis", "1", "symmetry axis, along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y_axis", "1", "symmetry axis, along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "alpha1", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "alpha2", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "alpha3", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "beta1", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "beta2", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "beta3", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "gamma1", "1", "vertical unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "gamma2", "1", "vertical unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_spherical_top_track_general_in_regular = {
    .model = "spherical_top_track",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .scales = 1,
    .state_count = 10, .param_count = 6, .prepared_count = 60,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 10, { 5, 27, 15, 1, 0, 2, 10, 11 }, { 22, 91, 0, 10, 0, 2, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, R*s*omega3 + omega_n*b, s*omega3*(I3/I1) + omega_n*gamma3, a part of d(omega_tau)/dtau, e = a3*gamma3 + R, I3/(m*R) + e, a part of d(omega_n)/dtau, V = omega_tau*e + v_nu, d(omega_n)/dtau, gamma3*omega_tau*s*((I1 - I3)/I1) - omega_tau*s*(a3*I3/(R*I1)), d(omega3)/dtau, d(spin)/dtau, (R*s*omega3 + omega_n*b)*S + v_nu*C, v_nu*S - (R*s*omega3 + omega_n*b)*C" },
    .jacobian = { jacobian, 100, { 16, 79, 34, 1, 0, 2, 13, 25 }, { 66, 414, 0, 49, 0, 2, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, d(d(v_nu)/dtau)/d(omega_n), d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(omega_n), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), omega_n - b*1/(Theta/(m*R^2*I1))*omega_n*(a3*I3/(R^2*I1)), e = a3*gamma3 + R, V = omega_tau*e + v_nu, e + I3/(m*R), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_n), a part of d(d(omega_n)/dtau)/d(s), d(d(omega_n)/dtau)/d(s), 2*a3*I3^2/(R^2*I1^2) - gamma3*(2*I3*(I1 - I3)/(R*I1^2)), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(gamma3), s*(a3*I3/(R*I1)) - gamma3*s*((I1 - I3)/I1), a part of d(d(omega3)/dtau)/d(omega_tau), a part of d(d(omega3)/dtau)/d(s), d(d(omega3)/dtau)/d(s), v_tau = omega_n*b + omega3*s*R, d(d(x)/dtau)/d(chi), omega3*s*R + v_tau, d(d(x)/dtau)/d(s), d(d(y)/dtau)/d(chi), d(d(y)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 110, { 18, 86, 37, 1, 0, 2, 9, 29 }, { 81, 486, 0, 59, 0, 2, 14, 12 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, V = omega_tau*e + v_nu, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), d(d(v_nu)/dtau)/d(omega_n), s*omega_tau*(m*a3^2)*s*omega_tau - I1*omega_n*omega_n, a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), (m*R*I3)*e + I3^2, numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*((m*R*I3)*e + I3^2) - V*(m*I3)*omega_n*b, d(omega_n)/dtau, a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s), omega_n*b + R*s*omega3, (2*I1)*omega_n*gamma3 + I3*s*omega3, d(spin)/dtau, v_nu*S - (omega_n*b + R*s*omega3)*C, d(d(y)/dtau)/d(s), d(numerator of d(omega_tau)/dt over D)/d(s), d(numerator of d(omega_n)/dt over Theta)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(s), d(d(omega_n)/dtau)/d(omega_n), d(numerator of d(omega3)/dt over Theta)/d(gamma3) = s*omega3*(m*R^2*(I1 - I3))*s*omega_tau - s*omega_tau*omega_n*(m*R*a3*I1), s*s*omega3*(m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3))) + e*(m*R*I1)*s*omega_n, d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*((m*R*I3)*e + I3^2) - e*(m*I3)*omega_n*b, d(d(omega_n)/dtau)/d(omega_tau), S*(omega_n*b + R*s*omega3) + v_nu*C, d(d(x)/dtau)/d(s), a part of d(d(omega_n)/dtau)/d(gamma3), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(s), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(s), d(d(omega_n)/dtau)/d(gamma3)" },
    .divergence = { divergence, 1, { 0, 8, 9, 1, 0, 0, 8, 7 }, { 10, 39, 0, 4, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, d(numerator of d(omega3)/dt over Theta)/d(omega3) = (m*R^2*(I1 - I3))*gamma3*omega_tau*s*s - (m*R*a3*I3)*omega_tau*s*s, e = a3*gamma3 + R, V = omega_tau*e + v_nu, d(numerator of d(omega3)/dt over Theta)/d(omega3) - (m*I3)*b*V, a part of the divergence" },
    .integral_values = { integral_values, 2, { 0, 12, 9, 0, 0, 0, 5, 7 }, { 9, 31, 0, 0, 0, 0, 10, 5 },
        "digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau = omega3*R*s + omega_n*b, E, G" },
    .integral_gradients = { integral_gradients, 20, { 0, 15, 7, 0, 0, 0, 5, 5 }, { 9, 37, 0, 0, 0, 0, 6, 6 },
        "digits are lost where terms nearly cancel in b = R*gamma3 + a3, v_tau = s*R*omega3 + omega_n*b, d(E)/d(s), d(E)/d(gamma3), d(E)/d(omega_n), d(E)/d(omega3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { observe_values, 12, { 2, 8, 6, 0, 0, 4, 3, 7 }, { 8, 22, 0, 0, 0, 4, 4, 7 },
        "digits are lost where terms nearly cancel in x_contact, y_contact, alpha1, alpha2, beta1, beta2" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .observe_count = 12, .observes = observes,
    .pole_count = 1, .poles = poles,
    .lifted = lifted,
    .tier = "track", .tier_meaning = "the reduced system with attitude and track by quadratures",
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_track_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_track_general_in_regular) },
#endif
};
