/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 e5eebb5567edc15e7cc6fede26c131ca64344936d08ff51ea4e1a4b893121228
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   27   15    1    0    2     10   11   (125)
 *  jacobian            17   81   35    1    0    2     13   24   (531)
 *  rhs_jacobian        19   82   38    1    0    2     12   27   (628)
 *  divergence          0    8    9    1    0    0      8    7   (53)
 *  integral_values     0   12    9    0    0    0      5    7   (40)
 *  integral_gradients  0   15    7    0    0    0      5    5   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, V = omega_tau*e + v_nu,
 *      s*omega_tau*(m*a3^2)*s*omega_tau - I1*omega_n*omega_n,
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(omega_n),
 *      omega_n*b + R*s*omega3, (m*R*I3)*e + I3^2,
 *      numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*((m*R*I3)*e + I3^2) - V*(m*I3)*omega_n*b,
 *      m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)),
 *      a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s),
 *      d(numerator of d(omega_n)/dt over Theta)/d(gamma3), (2*R)*s*omega3 + omega_n*b,
 *      d(numerator of d(omega3)/dt over Theta)/d(gamma3) = (m*R^2*(I1 - I3))*s*omega_tau*s*omega3 - s*omega_tau*omega_n*(m*R*a3*I1),
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*((m*R*I3)*e + I3^2) - e*(m*I3)*omega_n*b,
 *      a part of d(d(omega3)/dtau)/d(omega_tau), d(numerator of d(omega3)/dt over Theta)/d(s), d(d(omega3)/dtau)/d(s),
 *      d(spin)/dtau, d(d(omega_n)/dtau)/d(omega_tau), (2*I1)*omega_n*gamma3 + I3*s*omega3, d(omega_n)/dtau,
 *      d(d(y)/dtau)/d(s), (omega_n*b + R*s*omega3)*C - v_nu*S, d(d(x)/dtau)/d(s), (omega_n*b + R*s*omega3)*S + v_nu*C,
 *      a part of d(d(omega3)/dtau)/d(gamma3), a part of d(d(omega_n)/dtau)/d(gamma3),
 *      d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s), d(d(omega_n)/dtau)/d(s),
 *      d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n)
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
    out[32] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[8] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[9] = t8;
    const double t9 = params[0]*params[2]; /* m*g */
    const double t10 = params[3]*t9; /* a3*m*g */
    out[33] = t10;
    const double t11 = t10/params[4]; /* a3*m*g/I1 */
    out[10] = t11;
    const double t12 = params[1]*params[4]; /* R*I1 */
    out[56] = t12;
    const double t13 = params[5]/t12; /* I3/(R*I1) */
    out[11] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    out[57] = t14;
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
    out[42] = t22;
    const double t23 = t22/params[4]; /* a3*a3*m*2/I1 */
    out[16] = t23;
    const double t24 = params[2]*t21; /* g*m*2 */
    const double t25 = params[3]*t24; /* a3*g*m*2 */
    out[45] = t25;
    const double t26 = t25/params[4]; /* a3*g*m*2/I1 */
    out[17] = t26;
    const double t27 = params[4]*params[4]; /* I1*I1 */
    const double t28 = params[5]*t22; /* I3*a3*a3*m*2 */
    const double t29 = t28/t27; /* I3*a3*a3*m*2/(I1*I1) */
    out[18] = t29;
    const double t30 = t19/t3; /* I3*a3/(R*R*I1) */
    out[19] = t30;
    const double t31 = params[1]*t0; /* R*R*R */
    const double t32 = t27*t31; /* I1*I1*R*R*R */
    const double t33 = params[5]*params[5]; /* I3*I3 */
    out[37] = t33;
    const double t34 = 2.0*t33; /* 2*I3*I3 */
    const double t35 = t34/t32; /* 2*I3*I3/(I1*I1*R*R*R) */
    out[20] = t35;
    const double t36 = t0*t27; /* R*R*I1*I1 */
    const double t37 = t34/t36; /* 2*I3*I3/(R*R*I1*I1) */
    out[21] = t37;
    const double t38 = params[5]*2.0; /* I3*2 */
    const double t39 = t38/t3; /* I3*2/(R*R*I1) */
    out[22] = t39;
    const double t40 = t38/t12; /* I3*2/(R*I1) */
    out[23] = t40;
    const double t41 = params[3]/params[1]; /* a3/R */
    out[24] = t41;
    const double t42 = params[3]*2.0; /* a3*2 */
    const double t43 = params[5]*t42; /* I3*a3*2 */
    const double t44 = t43/t36; /* I3*a3*2/(R*R*I1*I1) */
    out[25] = t44;
    const double t45 = params[1]*t27; /* R*I1*I1 */
    const double t46 = t17*2.0; /* (I1 - I3)*2 */
    const double t47 = t46/t45; /* (I1 - I3)*2/(R*I1*I1) */
    out[26] = t47;
    const double t48 = (-1.0)/params[1]; /* (-1)/R */
    out[27] = t48;
    const double t49 = 2.0/params[1]; /* 2/R */
    out[28] = t49;
    const double t50 = t33*t42; /* I3*I3*a3*2 */
    const double t51 = t50/t32; /* I3*I3*a3*2/(I1*I1*R*R*R) */
    out[29] = t51;
    const double t52 = params[4]/params[0]; /* I1/m */
    out[30] = t52;
    const double t53 = t17*t38; /* (I1 - I3)*I3*2 */
    const double t54 = t53/t36; /* (I1 - I3)*I3*2/(R*R*I1*I1) */
    out[31] = t54;
    const double t55 = params[5]*params[4]; /* I3*I1 */
    out[34] = t55;
    const double t56 = t1*params[4]; /* m*R*R*I1 */
    out[35] = t56;
    const double t57 = params[0]*params[5]; /* m*I3 */
    out[36] = t57;
    const double t58 = params[5]*t14; /* I3*m*R */
    out[38] = t58;
    const double t59 = params[4]*t14; /* I1*m*R */
    out[39] = t59;
    const double t60 = params[3]*t14; /* a3*m*R */
    const double t61 = params[5]*t60; /* I3*a3*m*R */
    out[40] = t61;
    const double t62 = t1*t17; /* m*R*R*(I1 - I3) */
    out[41] = t62;
    const double t63 = params[4]*2.0; /* I1*2 */
    out[43] = t63;
    const double t64 = -params[5]; /* -I3 */
    out[44] = t64;
    const double t65 = params[0]*params[3]; /* m*a3 */
    const double t66 = params[5]*t65; /* I3*m*a3 */
    out[46] = t66;
    const double t67 = params[1]*t21; /* R*m*2 */
    const double t68 = params[5]*t67; /* I3*R*m*2 */
    out[47] = t68;
    const double t69 = t0*t21; /* R*R*m*2 */
    const double t70 = params[4]*t69; /* I1*R*R*m*2 */
    out[48] = t70;
    const double t71 = params[4]*t60; /* I1*a3*m*R */
    out[49] = t71;
    const double t72 = t17*t69; /* (I1 - I3)*R*R*m*2 */
    out[50] = t72;
    const double t73 = params[3]*t67; /* a3*R*m*2 */
    const double t74 = params[5]*t73; /* I3*a3*R*m*2 */
    out[51] = t74;
    const double t75 = params[1]*2.0; /* R*2 */
    out[52] = t75;
    const double t76 = params[0]/2.0; /* m/2 */
    out[53] = t76;
    const double t77 = params[4]/2.0; /* I1/2 */
    out[54] = t77;
    const double t78 = params[5]/2.0; /* I3/2 */
    out[55] = t78;
    const double t79 = params[1]*params[5]; /* R*I3 */
    const double t80 = -t79; /* -R*I3 */
    out[58] = t80;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[2]; /* s*omega_tau */
    const double t1 = x[9]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[9]*x[4]; /* s*omega3 */
    const double t5 = JLT_FMA(p[1], t4, t3); /* R*s*omega3 + omega_n*b */
    const double t6 = x[3]*t5; /* omega_n*(R*s*omega3 + omega_n*b) */
    out[1] = t6;
    const double t7 = x[9]*x[9]; /* s*s */
    const double t8 = t2*p[7]; /* b*I3/(R^2*I1) */
    const double t9 = p[6] + t7; /* I3/(m*R^2) + s*s */
    const double t10 = JLT_FMA(t2, t8, t9); /* Theta/(m*R^2*I1) = b*b*I3/(R^2*I1) + I3/(m*R^2) + s*s */
    const double t11 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t12 = t0*p[8]; /* s*omega_tau*m*a3^2/I1 */
    const double t13 = t11*t12; /* s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 */
    const double t14 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t15 = JLT_FMA(t4, p[9], t14); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t16 = JLT_FNMA(t7, p[10], t13); /* s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 - s*s*m*g*a3/I1 */
    const double t17 = JLT_FNMA(x[3], t15, t16); /* s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 - s*s*m*g*a3/I1 - omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t18 = JLT_FMA(t7, p[8], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t19 = t10*t18; /* Theta/(m*R^2*I1)*D/I1 */
    const double t20 = 1.0/t19; /* 1/(Theta/(m*R^2*I1)*D/I1) */
    const double t21 = t10*t17; /* Theta/(m*R^2*I1)*t17 */
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
    const double t33 = JLT_FNMA(t8, t32, t29); /* omega_tau*t28 - b*I3/(R^2*I1)*1/(Theta/(m*R^2*I1))*omega_n*V */
    out[3] = t33;
    const double t34 = x[9]*p[13]; /* s*1/R */
    const double t35 = t32*t34; /* 1/(Theta/(m*R^2*I1))*omega_n*V*s*1/R */
    const double t36 = t11*p[14]; /* s*omega_tau*gamma3*(I1 - I3)/I1 */
    const double t37 = JLT_FNMA(t0, p[15], t36); /* s*omega_tau*gamma3*(I1 - I3)/I1 - s*omega_tau*a3*I3/(R*I1) */
    const double t38 = JLT_FMS(t26, t37, t35); /* s*omega3*1/(Theta/(m*R^2*I1))*(s*omega_tau*gamma3*(I1 - I3)/I1 - s*omega_tau*a3*I3/(R*I1)) - 1/(Theta/(m*R^2*I1))*omega_n*V*s*1/R */
    out[4] = t38;
    const double t39 = -x[3]; /* -omega_n */
    out[5] = t39;
    const double t40 = t4 + t14; /* s*omega3 + omega_n*gamma3 */
    out[6] = t40;
    const double t41 = cos(x[5]); /* C = cos(chi) */
    const double t42 = x[9]*x[1]; /* s*v_nu */
    const double t43 = t41*t42; /* C*s*v_nu */
    const double t44 = sin(x[5]); /* S = sin(chi) */
    const double t45 = x[9]*t5; /* s*(R*s*omega3 + omega_n*b) */
    const double t46 = JLT_FMA(t44, t45, t43); /* S*s*(R*s*omega3 + omega_n*b) + C*s*v_nu */
    out[7] = t46;
    const double t47 = t42*t44; /* s*v_nu*S */
    const double t48 = JLT_FNMA(t41, t45, t47); /* s*v_nu*S - C*s*(R*s*omega3 + omega_n*b) */
    out[8] = t48;
    const double t49 = -t11; /* -s*omega_tau*gamma3 */
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
    const double t28 = 2.0*t27; /* 2*omega_n*gamma3 */
    const double t29 = t19*t28; /* 1/(D/I1)*2*omega_n*gamma3 */
    const double t30 = t20*p[9]; /* s*1/(D/I1)*I3/I1 */
    const double t31 = JLT_FMA(x[4], t30, t29); /* omega3*s*1/(D/I1)*I3/I1 + 1/(D/I1)*2*omega_n*gamma3 */
    const double t32 = -t31; /* -(omega3*s*1/(D/I1)*I3/I1 + 1/(D/I1)*2*omega_n*gamma3) */
    out[23] = t32;
    const double t33 = x[3]*t30; /* omega_n*s*1/(D/I1)*I3/I1 */
    const double t34 = -t33; /* -omega_n*s*1/(D/I1)*I3/I1 */
    out[24] = t34;
    const double t35 = JLT_FMA(x[2], x[2], t3); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t36 = JLT_FNMA(t25, t35, p[17]); /* 2*m*g*a3/I1 - gamma3*2*m*a3^2/I1*(omega_tau*omega_tau + omega_n*omega_n) */
    const double t37 = t20*t36; /* s*1/(D/I1)*t36 */
    const double t38 = JLT_FMA(t11, p[9], t37); /* omega_n*omega3*I3/I1 + s*1/(D/I1)*t36 */
    const double t39 = t19*t38; /* 1/(D/I1)*(omega_n*omega3*I3/I1 + s*1/(D/I1)*t36) */
    const double t40 = t11*p[18]; /* omega_n*omega3*2*m*a3^2*I3/I1^2 */
    const double t41 = t20*t40; /* s*1/(D/I1)*omega_n*omega3*2*m*a3^2*I3/I1^2 */
    const double t42 = JLT_FMS(t20, t41, t39); /* s*1/(D/I1)*s*1/(D/I1)*omega_n*omega3*2*m*a3^2*I3/I1^2 - 1/(D/I1)*(omega_n*omega3*I3/I1 + s*1/(D/I1)*t36) */
    out[29] = t42;
    const double t43 = t16*t18; /* 1/(Theta/(m*R^2*I1)) = D/I1*1/(Theta/(m*R^2*I1)*D/I1) */
    const double t44 = x[9]*t43; /* s*1/(Theta/(m*R^2*I1)) */
    const double t45 = x[2]*t44; /* omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t46 = x[4]*t45; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t47 = t6*t43; /* omega_n*b*1/(Theta/(m*R^2*I1)) */
    const double t48 = JLT_FNMA(p[19], t47, x[3]); /* omega_n - a3*I3/(R^2*I1)*omega_n*b*1/(Theta/(m*R^2*I1)) */
    const double t49 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t50 = JLT_FMA(x[2], t49, x[1]); /* V = omega_tau*e + v_nu */
    const double t51 = t43*t50; /* 1/(Theta/(m*R^2*I1))*V */
    const double t52 = x[3]*t51; /* omega_n*1/(Theta/(m*R^2*I1))*V */
    const double t53 = p[11]*t52; /* I3/(R*I1)*omega_n*1/(Theta/(m*R^2*I1))*V */
    const double t54 = t5*t51; /* b*1/(Theta/(m*R^2*I1))*V */
    const double t55 = t47*p[20]; /* omega_n*b*1/(Theta/(m*R^2*I1))*2*I3^2/(R^3*I1^2) */
    const double t56 = t49 + p[12]; /* e + I3/(m*R) */
    const double t57 = t43*t46; /* 1/(Theta/(m*R^2*I1))*omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t58 = t5*p[21]; /* b*2*I3^2/(R^2*I1^2) */
    const double t59 = t56*t58; /* (e + I3/(m*R))*b*2*I3^2/(R^2*I1^2) */
    const double t60 = JLT_FMS(t54, t55, t53); /* b*1/(Theta/(m*R^2*I1))*V*omega_n*b*1/(Theta/(m*R^2*I1))*2*I3^2/(R^3*I1^2) - I3/(R*I1)*omega_n*1/(Theta/(m*R^2*I1))*V */
    const double t61 = JLT_FMA(p[15], t46, t60); /* a3*I3/(R*I1)*omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) + t60 */
    const double t62 = JLT_FMA(x[2], t48, t61); /* omega_tau*(omega_n - a3*I3/(R^2*I1)*omega_n*b*1/(Theta/(m*R^2*I1))) + a3*I3/(R*I1)*omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) + t60 */
    const double t63 = JLT_FNMA(t57, t59, t62); /* t62 - 1/(Theta/(m*R^2*I1))*omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*(e + I3/(m*R))*b*2*I3^2/(R^2*I1^2) */
    out[30] = t63;
    const double t64 = p[7]*t47; /* I3/(R^2*I1)*omega_n*b*1/(Theta/(m*R^2*I1)) */
    const double t65 = -t64; /* -I3/(R^2*I1)*omega_n*b*1/(Theta/(m*R^2*I1)) */
    out[31] = t65;
    const double t66 = p[11]*t56; /* I3/(R*I1)*(e + I3/(m*R)) */
    const double t67 = x[4]*t66; /* omega3*I3/(R*I1)*(e + I3/(m*R)) */
    const double t68 = JLT_FMA(t44, t67, t27); /* s*1/(Theta/(m*R^2*I1))*omega3*I3/(R*I1)*(e + I3/(m*R)) + omega_n*gamma3 */
    const double t69 = JLT_FNMA(t49, t64, t68); /* t68 - e*I3/(R^2*I1)*omega_n*b*1/(Theta/(m*R^2*I1)) */
    out[32] = t69;
    const double t70 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t71 = JLT_FNMA(p[7], t54, t70); /* omega_tau*gamma3 - I3/(R^2*I1)*b*1/(Theta/(m*R^2*I1))*V */
    out[33] = t71;
    const double t72 = t45*t66; /* omega_tau*s*1/(Theta/(m*R^2*I1))*I3/(R*I1)*(e + I3/(m*R)) */
    out[34] = t72;
    const double t73 = x[2]*t67; /* omega_tau*omega3*I3/(R*I1)*(e + I3/(m*R)) */
    const double t74 = t44*t50; /* s*1/(Theta/(m*R^2*I1))*V */
    const double t75 = t47*p[22]; /* omega_n*b*1/(Theta/(m*R^2*I1))*2*I3/(R^2*I1) */
    const double t76 = t74*t75; /* s*1/(Theta/(m*R^2*I1))*V*omega_n*b*1/(Theta/(m*R^2*I1))*2*I3/(R^2*I1) */
    const double t77 = t44*t46; /* s*1/(Theta/(m*R^2*I1))*omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t78 = t56*p[23]; /* (e + I3/(m*R))*2*I3/(R*I1) */
    const double t79 = JLT_FMA(t43, t73, t76); /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*I3/(R*I1)*(e + I3/(m*R)) + t76 */
    const double t80 = JLT_FNMA(t77, t78, t79); /* t79 - t77*(e + I3/(m*R))*2*I3/(R*I1) */
    out[39] = t80;
    const double t81 = x[3]*p[24]; /* omega_n*a3/R */
    const double t82 = JLT_FNMA(x[0], p[26], p[25]); /* 2*a3*I3/(R^2*I1^2) - gamma3*2*(I1 - I3)/(R*I1^2) */
    const double t83 = t5*p[5]; /* b*I3 */
    const double t84 = t82*t83; /* (2*a3*I3/(R^2*I1^2) - gamma3*2*(I1 - I3)/(R*I1^2))*b*I3 */
    const double t85 = x[9]*p[14]; /* s*(I1 - I3)/I1 */
    const double t86 = JLT_FNMA(t45, t81, t76); /* t76 - omega_tau*s*1/(Theta/(m*R^2*I1))*omega_n*a3/R */
    const double t87 = JLT_FMA(t46, t85, t86); /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 + t76 - omega_tau*s*1/(Theta/(m*R^2*I1))*omega_n*a3/R */
    const double t88 = JLT_FMA(t77, t84, t87); /* t77*(2*a3*I3/(R^2*I1^2) - gamma3*2*(I1 - I3)/(R*I1^2))*b*I3 + t87 */
    out[40] = t88;
    const double t89 = x[3]*t44; /* omega_n*s*1/(Theta/(m*R^2*I1)) */
    const double t90 = p[13]*t89; /* 1/R*omega_n*s*1/(Theta/(m*R^2*I1)) */
    const double t91 = -t90; /* -1/R*omega_n*s*1/(Theta/(m*R^2*I1)) */
    out[41] = t91;
    const double t92 = JLT_FNMA(x[0], p[14], p[15]); /* a3*I3/(R*I1) - gamma3*(I1 - I3)/I1 */
    const double t93 = x[9]*t92; /* s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t94 = x[4]*t93; /* omega3*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t95 = t44*t94; /* s*1/(Theta/(m*R^2*I1))*omega3*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t96 = JLT_FMA(t49, t90, t95); /* e*1/R*omega_n*s*1/(Theta/(m*R^2*I1)) + t95 */
    const double t97 = -t96; /* -(e*1/R*omega_n*s*1/(Theta/(m*R^2*I1)) + t95) */
    out[42] = t97;
    const double t98 = t74*p[27]; /* s*1/(Theta/(m*R^2*I1))*V*(-1/R) */
    out[43] = t98;
    const double t99 = t45*t93; /* omega_tau*s*1/(Theta/(m*R^2*I1))*s*(a3*I3/(R*I1) - gamma3*(I1 - I3)/I1) */
    const double t100 = -t99; /* -t99 */
    out[44] = t100;
    const double t101 = t52*p[13]; /* omega_n*1/(Theta/(m*R^2*I1))*V*1/R */
    const double t102 = t89*p[28]; /* omega_n*s*1/(Theta/(m*R^2*I1))*2/R */
    const double t103 = t13 + p[30]; /* b*b + I1/m */
    const double t104 = t57*t103; /* 1/(Theta/(m*R^2*I1))*omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*(b*b + I1/m) */
    const double t105 = x[0]*p[31]; /* gamma3*2*I3*(I1 - I3)/(R^2*I1^2) */
    const double t106 = JLT_FMS(t74, t102, t101); /* s*1/(Theta/(m*R^2*I1))*V*omega_n*s*1/(Theta/(m*R^2*I1))*2/R - omega_n*1/(Theta/(m*R^2*I1))*V*1/R */
    const double t107 = JLT_FNMA(p[29], t104, t106); /* t106 - 2*a3*I3^2/(R^3*I1^2)*t104 */
    const double t108 = JLT_FMA(t104, t105, t107); /* t104*gamma3*2*I3*(I1 - I3)/(R^2*I1^2) + t106 - 2*a3*I3^2/(R^3*I1^2)*t104 */
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
    const double t133 = x[9]*x[0]; /* s*gamma3 */
    const double t134 = -t133; /* -s*gamma3 */
    out[92] = t134;
    const double t135 = -t70; /* -omega_tau*gamma3 */
    out[99] = t135;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[74] = x[9];
    out[70] = x[3];
    out[73] = x[0];
    out[79] = x[4];
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
    const double t3 = p[36]*t1; /* m*I3*b */
    const double t4 = JLT_FMA(p[35], t2, p[34]); /* m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(t1, t3, t4); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t6 = JLT_FMA(p[32], t2, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t7 = p[33]*t2; /* m*g*a3*s*s */
    const double t8 = t5*t6; /* Theta*D */
    const double t9 = 1.0/t8; /* 1/(Theta*D) */
    const double t10 = t6*t9; /* 1/Theta = D*1/(Theta*D) */
    const double t11 = t5*t9; /* 1/D = Theta*1/(Theta*D) */
    const double t12 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t13 = x[9]*x[2]; /* s*omega_tau */
    const double t14 = x[9]*t13; /* s*s*omega_tau */
    out[0] = t14;
    const double t15 = 2.0*t13; /* 2*s*omega_tau */
    out[19] = t15;
    const double t16 = -t13; /* -s*omega_tau */
    out[100] = t16;
    const double t17 = JLT_FMA(x[2], t12, x[1]); /* V = omega_tau*e + v_nu */
    const double t18 = t3*t17; /* m*I3*b*V */
    const double t19 = x[3]*t1; /* omega_n*b */
    const double t20 = x[9]*x[4]; /* s*omega3 */
    const double t21 = p[32]*t13; /* m*a3^2*s*omega_tau */
    const double t22 = t13*t21; /* s*omega_tau*m*a3^2*s*omega_tau */
    const double t23 = x[3]*t17; /* omega_n*V */
    const double t24 = x[3]*x[3]; /* omega_n*omega_n */
    const double t25 = JLT_FNMA(p[4], t24, t22); /* s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n */
    const double t26 = p[1]*t24; /* R*omega_n*omega_n */
    out[20] = t26;
    const double t27 = t11*t25; /* 1/D*(s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n) */
    out[30] = t27;
    const double t28 = p[5]*t20; /* I3*s*omega3 */
    const double t29 = JLT_FMA(x[3], t28, t7); /* omega_n*I3*s*omega3 + m*g*a3*s*s */
    const double t30 = JLT_FNMA(x[0], t25, t29); /* omega_n*I3*s*omega3 + m*g*a3*s*s - gamma3*(s*omega_tau*m*a3^2*s*omega_tau - I1*omega_n*omega_n) */
    const double t31 = t11*t30; /* 1/D*t30 */
    const double t32 = -t31; /* -1/D*t30 */
    out[2] = t32;
    const double t33 = p[36]*t19; /* m*I3*omega_n*b */
    const double t34 = x[4]*t13; /* omega3*s*omega_tau */
    const double t35 = p[39]*t23; /* m*R*I1*omega_n*V */
    const double t36 = x[0]*t13; /* gamma3*s*omega_tau */
    const double t37 = -t36; /* -gamma3*s*omega_tau */
    out[9] = t37;
    const double t38 = p[42]*t36; /* 2*m*a3^2*gamma3*s*omega_tau */
    const double t39 = x[9]*t10; /* s*1/Theta */
    const double t40 = p[1]*t20; /* R*s*omega3 */
    const double t41 = JLT_FMA(2.0, t19, t40); /* 2*omega_n*b + R*s*omega3 */
    out[23] = t41;
    const double t42 = t19 + t40; /* omega_n*b + R*s*omega3 */
    const double t43 = x[3]*t42; /* omega_n*(omega_n*b + R*s*omega3) */
    out[1] = t43;
    const double t44 = t17*t33; /* V*m*I3*omega_n*b */
    const double t45 = JLT_FMA(p[38], t12, p[37]); /* m*R*I3*e + I3^2 */
    const double t46 = JLT_FMS(t34, t45, t44); /* numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*(m*R*I3*e + I3^2) - V*m*I3*omega_n*b */
    const double t47 = t10*t46; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t48 = x[9]*t35; /* s*m*R*I1*omega_n*V */
    const double t49 = JLT_FNMA(x[0], p[41], p[40]); /* m*R*a3*I3 - gamma3*m*R^2*(I1 - I3) */
    const double t50 = t13*t20; /* s*omega_tau*s*omega3 */
    const double t51 = JLT_FMA(t49, t50, t48); /* (m*R*a3*I3 - gamma3*m*R^2*(I1 - I3))*s*omega_tau*s*omega3 + s*m*R*I1*omega_n*V */
    const double t52 = t10*t51; /* 1/Theta*t51 */
    const double t53 = t39*t49; /* s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t54 = -t52; /* -1/Theta*t51 */
    out[4] = t54;
    const double t55 = sin(x[5]); /* S = sin(chi) */
    const double t56 = p[40]*t34; /* m*R*a3*I3*omega3*s*omega_tau */
    const double t57 = x[2]*p[46]; /* omega_tau*m*a3*I3 */
    const double t58 = JLT_FNMA(t19, t57, t56); /* m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 */
    const double t59 = JLT_FNMA(p[38], t23, t58); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) = m*R*a3*I3*omega3*s*omega_tau - omega_n*b*omega_tau*m*a3*I3 - m*R*I3*omega_n*V */
    const double t60 = JLT_FMA(p[52], t20, t19); /* 2*R*s*omega3 + omega_n*b */
    const double t61 = x[3]*p[49]; /* omega_n*m*R*a3*I1 */
    const double t62 = t13*t61; /* s*omega_tau*omega_n*m*R*a3*I1 */
    const double t63 = JLT_FMS(p[41], t50, t62); /* d(numerator of d(omega3)/dt over Theta)/d(gamma3) = m*R^2*(I1 - I3)*s*omega_tau*s*omega3 - s*omega_tau*omega_n*m*R*a3*I1 */
    const double t64 = p[39]*t39; /* m*R*I1*s*1/Theta */
    const double t65 = p[48]*t39; /* 2*m*R^2*I1*s*1/Theta */
    const double t66 = t17*t64; /* V*m*R*I1*s*1/Theta */
    const double t67 = -t66; /* -V*m*R*I1*s*1/Theta */
    out[53] = t67;
    const double t68 = x[3]*t64; /* omega_n*m*R*I1*s*1/Theta */
    const double t69 = -t68; /* -omega_n*m*R*I1*s*1/Theta */
    out[51] = t69;
    const double t70 = t12*t68; /* e*omega_n*m*R*I1*s*1/Theta */
    const double t71 = t12*t33; /* e*m*I3*omega_n*b */
    const double t72 = t10*t33; /* 1/Theta*m*I3*omega_n*b */
    const double t73 = -t72; /* -1/Theta*m*I3*omega_n*b */
    out[41] = t73;
    const double t74 = JLT_FMS(t20, t45, t71); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*(m*R*I3*e + I3^2) - e*m*I3*omega_n*b */
    const double t75 = t10*t45; /* 1/Theta*(m*R*I3*e + I3^2) */
    const double t76 = JLT_FMA(t20, t53, t70); /* s*omega3*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) + e*omega_n*m*R*I1*s*1/Theta */
    const double t77 = -t76; /* -t76 */
    out[52] = t77;
    const double t78 = t13*t53; /* s*omega_tau*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    const double t79 = t13*t75; /* s*omega_tau*1/Theta*(m*R*I3*e + I3^2) */
    out[44] = t79;
    const double t80 = -t78; /* -s*omega_tau*s*1/Theta*(m*R*a3*I3 - gamma3*m*R^2*(I1 - I3)) */
    out[54] = t80;
    const double t81 = x[0]*p[50]; /* gamma3*2*m*R^2*(I1 - I3) */
    const double t82 = JLT_FMS(t34, t81, t35); /* omega3*s*omega_tau*gamma3*2*m*R^2*(I1 - I3) - m*R*I1*omega_n*V */
    const double t83 = JLT_FNMA(p[51], t34, t82); /* d(numerator of d(omega3)/dt over Theta)/d(s) = t82 - 2*m*R*a3*I3*omega3*s*omega_tau */
    const double t84 = t10*t83; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t85 = JLT_FMA(t52, t65, t84); /* 1/Theta*t51*2*m*R^2*I1*s*1/Theta + 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    out[59] = t85;
    const double t86 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t87 = t20 + t86; /* s*omega3 + omega_n*gamma3 */
    out[6] = t87;
    const double t88 = JLT_FMA(t10, t74, t86); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[42] = t88;
    const double t89 = JLT_FMA(p[43], t86, t28); /* 2*I1*omega_n*gamma3 + I3*s*omega3 */
    const double t90 = JLT_FMA(x[2], t86, t47); /* omega_tau*omega_n*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t90;
    const double t91 = t11*t89; /* 1/D*(2*I1*omega_n*gamma3 + I3*s*omega3) */
    const double t92 = -t91; /* -1/D*(2*I1*omega_n*gamma3 + I3*s*omega3) */
    out[33] = t92;
    const double t93 = cos(x[5]); /* C = cos(chi) */
    const double t94 = x[1]*t55; /* v_nu*S */
    const double t95 = JLT_FNMA(t60, t93, t94); /* v_nu*S - (2*R*s*omega3 + omega_n*b)*C */
    out[99] = t95;
    const double t96 = JLT_FMS(t42, t93, t94); /* (omega_n*b + R*s*omega3)*C - v_nu*S */
    const double t97 = x[9]*t96; /* s*((omega_n*b + R*s*omega3)*C - v_nu*S) */
    out[85] = t97;
    const double t98 = -t97; /* -s*((omega_n*b + R*s*omega3)*C - v_nu*S) */
    out[8] = t98;
    const double t99 = x[9]*p[1]; /* s*R */
    const double t100 = x[9]*t11; /* s*1/D */
    const double t101 = t38*t100; /* 2*m*a3^2*gamma3*s*omega_tau*s*1/D */
    out[32] = t101;
    const double t102 = x[2]*t38; /* omega_tau*2*m*a3^2*gamma3*s*omega_tau */
    const double t103 = JLT_FNMA(x[9], p[45], t102); /* omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 */
    const double t104 = x[1]*t93; /* v_nu*C */
    const double t105 = JLT_FMA(t55, t60, t104); /* S*(2*R*s*omega3 + omega_n*b) + v_nu*C */
    out[89] = t105;
    const double t106 = JLT_FMA(t42, t55, t104); /* (omega_n*b + R*s*omega3)*S + v_nu*C */
    const double t107 = x[9]*t106; /* s*((omega_n*b + R*s*omega3)*S + v_nu*C) */
    out[7] = t107;
    out[95] = t107;
    const double t108 = x[3]*t99; /* omega_n*s*R */
    out[24] = t108;
    const double t109 = t55*t108; /* S*omega_n*s*R */
    out[80] = t109;
    const double t110 = x[9]*t55; /* s*S */
    out[91] = t110;
    const double t111 = t93*t108; /* C*omega_n*s*R */
    const double t112 = -t111; /* -C*omega_n*s*R */
    out[90] = t112;
    const double t113 = x[9]*t93; /* s*C */
    out[81] = t113;
    const double t114 = t1*t110; /* b*s*S */
    out[83] = t114;
    const double t115 = t99*t110; /* s*R*s*S */
    out[84] = t115;
    const double t116 = t99*t113; /* s*R*s*C */
    const double t117 = -t116; /* -s*R*s*C */
    out[94] = t117;
    const double t118 = t1*t113; /* b*s*C */
    const double t119 = -t118; /* -b*s*C */
    out[93] = t119;
    const double t120 = p[47]*t1; /* 2*m*R*I3*b */
    const double t121 = JLT_FMA(t52, t120, t63); /* 1/Theta*t51*2*m*R*I3*b + d(numerator of d(omega3)/dt over Theta)/d(gamma3) */
    const double t122 = JLT_FNMA(t47, t120, t59); /* d(numerator of d(omega_n)/dt over Theta)/d(gamma3) - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R*I3*b */
    const double t123 = t10*t121; /* 1/Theta*t121 */
    out[50] = t123;
    const double t124 = x[3]*x[4]; /* omega_n*omega3 */
    const double t125 = JLT_FNMA(p[5], t124, t103); /* d(numerator of d(omega_tau)/dt over D)/d(s) = omega_tau*2*m*a3^2*gamma3*s*omega_tau - s*2*m*g*a3 - I3*omega_n*omega3 */
    const double t126 = p[1]*t124; /* R*omega_n*omega3 */
    out[29] = t126;
    const double t127 = p[42]*t100; /* 2*m*a3^2*s*1/D */
    const double t128 = t31*t127; /* 1/D*t30*2*m*a3^2*s*1/D */
    const double t129 = JLT_FMA(t11, t125, t128); /* 1/D*d(numerator of d(omega_tau)/dt over D)/d(s) + 1/D*t30*2*m*a3^2*s*1/D */
    out[39] = t129;
    const double t130 = x[2]*x[4]; /* omega_tau*omega3 */
    const double t131 = t75*t130; /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 */
    const double t132 = JLT_FNMA(t47, t65, t131); /* 1/Theta*(m*R*I3*e + I3^2)*omega_tau*omega3 - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    out[49] = t132;
    const double t133 = x[3]*p[44]; /* omega_n*(-I3) */
    const double t134 = t100*t133; /* s*1/D*omega_n*(-I3) */
    out[34] = t134;
    const double t135 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t136 = JLT_FMA(t10, t122, t135); /* 1/Theta*t122 + omega_tau*omega_n */
    out[40] = t136;
    const double t137 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t138 = JLT_FNMA(t10, t18, t137); /* omega_tau*gamma3 - 1/Theta*m*I3*b*V */
    out[43] = t138;
    const double t139 = -t137; /* -omega_tau*gamma3 */
    out[109] = t139;
    const double t140 = x[9]*x[0]; /* s*gamma3 */
    const double t141 = -t140; /* -s*gamma3 */
    out[102] = t141;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[0]*t1; /* gamma3*omega_tau*s*s */
    const double t4 = p[36]*t2; /* m*I3*b */
    const double t5 = JLT_FMA(p[35], t0, p[34]); /* m*R^2*I1*s*s + I1*I3 */
    const double t6 = JLT_FMA(t2, t4, t5); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t7 = JLT_FMA(p[32], t0, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t8 = p[41]*t3; /* m*R^2*(I1 - I3)*gamma3*omega_tau*s*s */
    const double t9 = JLT_FNMA(p[40], t1, t8); /* d(numerator of d(omega3)/dt over Theta)/d(omega3) = m*R^2*(I1 - I3)*gamma3*omega_tau*s*s - m*R*a3*I3*omega_tau*s*s */
    const double t10 = p[42]*t3; /* 2*m*a3^2*gamma3*omega_tau*s*s */
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
    const double t0 = p[33]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t2 = x[3]*p[54]; /* omega_n*1/2*I1 */
    const double t3 = JLT_FMA(x[3], t2, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t4 = x[3]*t1; /* omega_n*b */
    const double t5 = p[1]*x[9]; /* R*s */
    const double t6 = JLT_FMA(x[4], t5, t4); /* v_tau = omega3*R*s + omega_n*b */
    const double t7 = x[9]*p[32]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[9], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t10 = x[2]*t9; /* omega_tau*1/2*omega_tau */
    const double t11 = x[4]*p[55]; /* omega3*1/2*I3 */
    const double t12 = JLT_FMA(x[4], t11, t3); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t13 = JLT_FMA(t8, t10, t12); /* D*omega_tau*1/2*omega_tau + t12 */
    const double t14 = x[1]*x[1]; /* v_nu*v_nu */
    const double t15 = JLT_FMA(t6, t6, t14); /* v_tau*v_tau + v_nu*v_nu */
    const double t16 = JLT_FMA(p[53], t15, t13); /* 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t12 */
    out[0] = t16;
    const double t17 = x[9]*p[56]; /* s*R*I1 */
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
    const double t1 = x[4]*p[58]; /* omega3*(-R*I3) */
    out[10] = t1;
    const double t2 = x[9]*p[56]; /* s*R*I1 */
    out[13] = t2;
    const double t3 = x[3]*p[56]; /* omega_n*R*I1 */
    out[19] = t3;
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = p[44]*t4; /* (-I3)*b */
    out[14] = t5;
    const double t6 = x[3]*t4; /* omega_n*b */
    const double t7 = p[0]*t4; /* m*b */
    const double t8 = p[1]*x[4]; /* R*omega3 */
    const double t9 = JLT_FMA(x[9], t8, t6); /* v_tau = s*R*omega3 + omega_n*b */
    const double t10 = x[9]*p[32]; /* s*m*a3^2 */
    const double t11 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t12 = t10*t11; /* s*m*a3^2*omega_tau*omega_tau */
    const double t13 = JLT_FMA(x[9], t10, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t14 = x[2]*t13; /* omega_tau*D */
    out[2] = t14;
    const double t15 = p[57]*t9; /* m*R*v_tau */
    const double t16 = JLT_FMA(x[4], t15, t12); /* omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    out[9] = t16;
    const double t17 = JLT_FMA(x[3], t15, p[33]); /* omega_n*m*R*v_tau + m*g*a3 */
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
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double u61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double u63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
    double t68[JLT_JET_ORDER_MAX + 1];
    double t69[JLT_JET_ORDER_MAX + 1];
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
        t16[k] = t8[k]*p[7];
        t17[k] = t2[k] + (k == 0 ? p[6] : 0);
        t18[k] = jlt_jet_product(t8, t16, k) + t17[k];
        t20[k] = jlt_jet_product(x2, x9, k);
        t21[k] = jlt_jet_product(x0, t20, k);
        t22[k] = p[8]*t20[k];
        t23[k] = jlt_jet_product(t21, t22, k);
        t25[k] = jlt_jet_product(x3, x0, k);
        t26[k] = t11[k]*p[9] + t25[k];
        t28[k] = t23[k] - t2[k]*p[10];
        t29[k] = t28[k] - jlt_jet_product(x3, t26, k);
        t31[k] = t2[k]*p[8] + (k == 0 ? 1.0 : 0);
        t32[k] = jlt_jet_product(t18, t31, k);
        t33[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t32, t33, k);
        t34[k] = jlt_jet_product(t18, t29, k);
        t35[k] = jlt_jet_product(t33, t34, k);
        t37[k] = jlt_jet_product(t31, t33, k);
        t38[k] = jlt_jet_product(t11, t37, k);
        t40[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t41[k] = (k == 0 ? p[12] : 0) + t40[k];
        t42[k] = p[11]*t41[k];
        t43[k] = jlt_jet_product(t38, t42, k) + t25[k];
        t44[k] = jlt_jet_product(x2, t43, k);
        t46[k] = jlt_jet_product(x2, t40, k) + x1[k];
        t47[k] = jlt_jet_product(x3, t46, k);
        t48[k] = jlt_jet_product(t37, t47, k);
        t49[k] = t44[k] - jlt_jet_product(t16, t48, k);
        t51[k] = x9[k]*p[13];
        t52[k] = jlt_jet_product(t48, t51, k);
        t54[k] = t21[k]*p[14];
        t56[k] = t54[k] - t20[k]*p[15];
        t57[k] = jlt_jet_product(t38, t56, k) - t52[k];
        t58[k] = -x3[k];
        t59[k] = t11[k] + t25[k];
        t61[k] = jlt_jet_cosine(x5, t61, u61, k);
        t62[k] = jlt_jet_product(x1, t61, k);
        t63[k] = jlt_jet_sine(x5, t63, u63, k);
        t64[k] = jlt_jet_product(t12, t63, k) + t62[k];
        t65[k] = jlt_jet_product(x9, t64, k);
        t66[k] = jlt_jet_product(x1, t63, k);
        t67[k] = t66[k] - jlt_jet_product(t12, t61, k);
        t68[k] = jlt_jet_product(x9, t67, k);
        t69[k] = -t21[k];
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t13[k]/(k + 1);
        next[2] = x2[k + 1] = t35[k]/(k + 1);
        next[3] = x3[k + 1] = t49[k]/(k + 1);
        next[4] = x4[k + 1] = t57[k]/(k + 1);
        next[5] = x5[k + 1] = t58[k]/(k + 1);
        next[6] = x6[k + 1] = t59[k]/(k + 1);
        next[7] = x7[k + 1] = t65[k]/(k + 1);
        next[8] = x8[k + 1] = t68[k]/(k + 1);
        next[9] = x9[k + 1] = t69[k]/(k + 1);
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
    .sha256 = "e5eebb5567edc15e7cc6fede26c131ca64344936d08ff51ea4e1a4b893121228",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .state_count = 10, .param_count = 6, .prepared_count = 59,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 10, { 5, 27, 15, 1, 0, 2, 10, 11 }, { 22, 91, 0, 10, 0, 2, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, R*s*omega3 + omega_n*b, s*omega3*(I3/I1) + omega_n*gamma3, a part of d(omega_tau)/dtau, e = a3*gamma3 + R, I3/(m*R) + e, a part of d(omega_n)/dtau, V = omega_tau*e + v_nu, d(omega_n)/dtau, s*omega_tau*gamma3*((I1 - I3)/I1) - s*omega_tau*(a3*I3/(R*I1)), d(omega3)/dtau, d(spin)/dtau, d(x)/dtau, d(y)/dtau" },
    .jacobian = { jacobian, 100, { 17, 81, 35, 1, 0, 2, 13, 24 }, { 66, 414, 0, 49, 0, 2, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, d(d(v_nu)/dtau)/d(omega_n), d(d(omega_tau)/dtau)/d(gamma3), omega3*s*1/(D/I1)*(I3/I1) + 1/(D/I1)*(2)*omega_n*gamma3, a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), omega_n - (a3*I3/(R^2*I1))*omega_n*b*1/(Theta/(m*R^2*I1)), e = a3*gamma3 + R, V = omega_tau*e + v_nu, e + I3/(m*R), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(s), 2*a3*I3/(R^2*I1^2) - gamma3*(2*(I1 - I3)/(R*I1^2)), d(d(omega3)/dtau)/d(gamma3), a3*I3/(R*I1) - gamma3*((I1 - I3)/I1), a part of d(d(omega3)/dtau)/d(omega_tau), d(d(omega3)/dtau)/d(s), v_tau = omega_n*b + omega3*s*R, d(d(x)/dtau)/d(chi), omega3*s*R + v_tau, d(d(x)/dtau)/d(s), d(d(y)/dtau)/d(chi), d(d(y)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 110, { 19, 82, 38, 1, 0, 2, 12, 27 }, { 81, 486, 0, 59, 0, 2, 14, 12 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, V = omega_tau*e + v_nu, s*omega_tau*(m*a3^2)*s*omega_tau - I1*omega_n*omega_n, a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(s), d(d(v_nu)/dtau)/d(omega_n), omega_n*b + R*s*omega3, (m*R*I3)*e + I3^2, numerator of d(omega_n)/dt over Theta = omega3*s*omega_tau*((m*R*I3)*e + I3^2) - V*(m*I3)*omega_n*b, m*R*a3*I3 - gamma3*(m*R^2*(I1 - I3)), a part of d(omega3)/dtau and of d(d(omega3)/dtau)/d(gamma3) and of d(d(omega3)/dtau)/d(s), d(numerator of d(omega_n)/dt over Theta)/d(gamma3), (2*R)*s*omega3 + omega_n*b, d(numerator of d(omega3)/dt over Theta)/d(gamma3) = (m*R^2*(I1 - I3))*s*omega_tau*s*omega3 - s*omega_tau*omega_n*(m*R*a3*I1), d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = s*omega3*((m*R*I3)*e + I3^2) - e*(m*I3)*omega_n*b, a part of d(d(omega3)/dtau)/d(omega_tau), d(numerator of d(omega3)/dt over Theta)/d(s), d(d(omega3)/dtau)/d(s), d(spin)/dtau, d(d(omega_n)/dtau)/d(omega_tau), (2*I1)*omega_n*gamma3 + I3*s*omega3, d(omega_n)/dtau, d(d(y)/dtau)/d(s), (omega_n*b + R*s*omega3)*C - v_nu*S, d(d(x)/dtau)/d(s), (omega_n*b + R*s*omega3)*S + v_nu*C, a part of d(d(omega3)/dtau)/d(gamma3), a part of d(d(omega_n)/dtau)/d(gamma3), d(numerator of d(omega_tau)/dt over D)/d(s), d(d(omega_tau)/dtau)/d(s), d(d(omega_n)/dtau)/d(s), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n)" },
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
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
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
