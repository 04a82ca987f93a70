/* Spherical top with one nonholonomic constraint: reduced system, attitude and track
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_track, SHA-256 625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735
 *  Command:    ttc generate --effort full --out DIR spherical_top_track.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   19    9    1    0    2      7    8   (96)
 *  jacobian            13   59   21    1    0    2     10   19   (375)
 *  rhs_jacobian        15   69   21    1    0    2      7   19   (449)
 *  divergence          1    5    3    1    0    0      5    4   (30)
 *  integral_values     1   14   10    0    0    2      6    8   (51)
 *  integral_gradients  0   31    7    0    0    2      5    8   (89)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are
 *    digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, d(spin)/dtau,
 *      numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*(m*R*I3)*V,
 *      omega_tau - ((1)/Theta)*(m*R*I3)*V, d(omega_n)/dtau,
 *      numerator of d(omega3)/dt over Theta = omega_tau*s*gamma3*(m*R^2*(I1 - I3))*s*omega3 - s*omega_n*(m*R*I1)*V,
 *      v_nu*S - (s*omega3 + omega_n*gamma3)*R*C, (s*omega3 + omega_n*gamma3)*R*S + v_nu*C, d(d(x)/dtau)/d(s),
 *      d(d(y)/dtau)/d(s),
 *      d(numerator of d(omega3)/dt over Theta)/d(s) = omega_tau*gamma3*(2*m*R^2*(I1 - I3))*s*omega3 - omega_n*(m*R*I1)*V,
 *      omega_n*gamma3 + (I3/I1)*s*omega3, (2)*omega_n*gamma3 + (I3/I1)*s*omega3, d(d(omega_n)/dtau)/d(gamma3),
 *      d(d(v_nu)/dtau)/d(omega_n),
 *      d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = (I3^2 + m*R^2*I3)*s*omega3 - (m*R^2*I3)*omega_n*gamma3,
 *      d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(s), d(d(omega3)/dtau)/d(gamma3),
 *      d(numerator of d(omega3)/dt over Theta)/d(omega_tau) = s*gamma3*(m*R^2*(I1 - I3))*s*omega3 - (m*R^2*I1)*s*omega_n
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
extern const jlt_descriptor jlt_kernels_spherical_top_track_balanced_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_track_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_balanced_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_balanced_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_track_balanced_in_regular_avx512;

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
    const double t0 = params[5]/params[4]; /* I3/I1 */
    out[6] = t0;
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    out[40] = t2;
    const double t3 = params[4]*t2; /* I1*m*R*R */
    out[22] = t3;
    const double t4 = params[5]*params[5]; /* I3*I3 */
    const double t5 = params[5]*t2; /* I3*m*R*R */
    out[23] = t5;
    const double t6 = t4 + t5; /* I3*I3 + I3*m*R*R */
    out[24] = t6;
    const double t7 = t6/t3; /* (I3*I3 + I3*m*R*R)/(I1*m*R*R) */
    out[7] = t7;
    const double t8 = params[5]/t2; /* I3/(m*R*R) */
    out[8] = t8;
    const double t9 = 1.0/params[1]; /* 1/R */
    out[9] = t9;
    const double t10 = params[4] - params[5]; /* I1 - I3 */
    const double t11 = t10/params[4]; /* (I1 - I3)/I1 */
    out[10] = t11;
    const double t12 = params[1]*2.0; /* R*2 */
    out[11] = t12;
    const double t13 = -t0; /* -I3/I1 */
    out[12] = t13;
    const double t14 = params[4]*params[4]; /* I1*I1 */
    const double t15 = t4*2.0; /* I3*I3*2 */
    const double t16 = t15/t14; /* I3*I3*2/(I1*I1) */
    out[13] = t16;
    const double t17 = params[0]*params[0]; /* m*m */
    const double t18 = t1*t1; /* R*R*R*R */
    const double t19 = t17*t18; /* m*m*R*R*R*R */
    const double t20 = t14*t19; /* I1*I1*m*m*R*R*R*R */
    const double t21 = params[5]*t4; /* I3*I3*I3 */
    const double t22 = t2*t21; /* m*R*R*I3*I3*I3 */
    const double t23 = t4*t19; /* I3*I3*m*m*R*R*R*R */
    const double t24 = t22 + t23; /* m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R */
    const double t25 = 2.0*t24; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R) */
    const double t26 = t25/t20; /* 2*(m*R*R*I3*I3*I3 + I3*I3*m*m*R*R*R*R)/(I1*I1*m*m*R*R*R*R) */
    out[14] = t26;
    const double t27 = params[4]*params[1]; /* I1*R */
    out[38] = t27;
    const double t28 = params[5]/t27; /* I3/(I1*R) */
    out[33] = t28;
    const double t29 = -t28; /* -I3/(I1*R) */
    out[15] = t29;
    const double t30 = t3*t4; /* I1*m*R*R*I3*I3 */
    const double t31 = params[4]*t19; /* I1*m*m*R*R*R*R */
    const double t32 = params[5]*t31; /* I3*I1*m*m*R*R*R*R */
    const double t33 = t30 + t32; /* I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R */
    const double t34 = 2.0*t33; /* 2*(I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R) */
    const double t35 = t34/t20; /* 2*(I1*m*R*R*I3*I3 + I3*I1*m*m*R*R*R*R)/(I1*I1*m*m*R*R*R*R) */
    out[16] = t35;
    const double t36 = params[5]*2.0; /* I3*2 */
    const double t37 = t36/params[4]; /* I3*2/I1 */
    out[17] = t37;
    const double t38 = t10*t36; /* (I1 - I3)*I3*2 */
    const double t39 = t38/t14; /* (I1 - I3)*I3*2/(I1*I1) */
    out[18] = t39;
    const double t40 = (-1.0)/params[1]; /* (-1)/R */
    out[19] = t40;
    const double t41 = params[4]/t2; /* I1/(m*R*R) */
    out[20] = t41;
    const double t42 = params[4]*params[5]; /* I1*I3 */
    out[21] = t42;
    const double t43 = params[0]*params[1]; /* m*R */
    out[41] = t43;
    const double t44 = params[5]*t43; /* I3*m*R */
    out[25] = t44;
    const double t45 = params[4]*t43; /* I1*m*R */
    out[26] = t45;
    const double t46 = t2*t10; /* m*R*R*(I1 - I3) */
    out[27] = t46;
    const double t47 = params[0]*2.0; /* m*2 */
    const double t48 = t1*t47; /* R*R*m*2 */
    const double t49 = params[5]*t48; /* I3*R*R*m*2 */
    out[28] = t49;
    const double t50 = -t43; /* -m*R */
    out[44] = t50;
    const double t51 = -t44; /* -I3*m*R */
    out[29] = t51;
    const double t52 = params[4]*t48; /* I1*R*R*m*2 */
    out[30] = t52;
    const double t53 = -t45; /* -I1*m*R */
    out[31] = t53;
    const double t54 = t10*t48; /* (I1 - I3)*R*R*m*2 */
    out[32] = t54;
    const double t55 = params[0]/2.0; /* m/2 */
    out[34] = t55;
    const double t56 = params[4]/2.0; /* I1/2 */
    out[35] = t56;
    const double t57 = params[5]/2.0; /* I3/2 */
    out[36] = t57;
    const double t58 = t2/2.0; /* m*R*R/2 */
    out[37] = t58;
    const double t59 = params[5]*params[1]; /* I3*R */
    out[39] = t59;
    const double t60 = -t59; /* -I3*R */
    out[42] = t60;
    const double t61 = params[4] + t2; /* I1 + m*R*R */
    out[43] = t61;
    const double t62 = params[5] + t2; /* I3 + m*R*R */
    out[45] = t62;
    const double t63 = -params[4]; /* -I1 */
    out[46] = t63;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[2]; /* s*omega_tau */
    const double t1 = x[9]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t3 = x[9]*x[4]; /* s*omega3 */
    const double t4 = t2 + t3; /* omega_n*gamma3 + s*omega3 */
    out[6] = t4;
    const double t5 = p[1]*t4; /* R*(omega_n*gamma3 + s*omega3) */
    const double t6 = x[3]*t5; /* omega_n*R*(omega_n*gamma3 + s*omega3) */
    out[1] = t6;
    const double t7 = JLT_FMA(t3, p[6], t2); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t8 = x[3]*t7; /* omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    const double t9 = -t8; /* -omega_n*(s*omega3*I3/I1 + omega_n*gamma3) */
    out[2] = t9;
    const double t10 = x[0]*p[6]; /* gamma3*I3/I1 */
    const double t11 = JLT_FMA(x[9], x[9], p[8]); /* s*s + I3/(m*R^2) */
    const double t12 = JLT_FMA(x[0], t10, t11); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + s*s + I3/(m*R^2) */
    const double t13 = 1.0/t12; /* 1/(Theta/(m*R^2*I1)) */
    const double t14 = t3*t13; /* s*omega3*1/(Theta/(m*R^2*I1)) */
    const double t15 = JLT_FMA(p[7], t14, t2); /* (I3^2 + m*R^2*I3)/(m*R^2*I1)*s*omega3*1/(Theta/(m*R^2*I1)) + omega_n*gamma3 */
    const double t16 = x[2]*t15; /* omega_tau*t15 */
    const double t17 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t18 = x[3]*t17; /* omega_n*V/R */
    const double t19 = t13*t18; /* 1/(Theta/(m*R^2*I1))*omega_n*V/R */
    const double t20 = JLT_FNMA(t10, t19, t16); /* omega_tau*t15 - gamma3*I3/I1*1/(Theta/(m*R^2*I1))*omega_n*V/R */
    out[3] = t20;
    const double t21 = x[9]*t19; /* s*1/(Theta/(m*R^2*I1))*omega_n*V/R */
    const double t22 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t23 = p[10]*t22; /* (I1 - I3)/I1*s*omega_tau*gamma3 */
    const double t24 = JLT_FMS(t14, t23, t21); /* s*omega3*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*s*omega_tau*gamma3 - s*1/(Theta/(m*R^2*I1))*omega_n*V/R */
    out[4] = t24;
    const double t25 = -x[3]; /* -omega_n */
    out[5] = t25;
    const double t26 = cos(x[5]); /* C = cos(chi) */
    const double t27 = x[9]*x[1]; /* s*v_nu */
    const double t28 = t26*t27; /* C*s*v_nu */
    const double t29 = sin(x[5]); /* S = sin(chi) */
    const double t30 = x[9]*t5; /* s*R*(omega_n*gamma3 + s*omega3) */
    const double t31 = JLT_FMA(t29, t30, t28); /* S*s*R*(omega_n*gamma3 + s*omega3) + C*s*v_nu */
    out[7] = t31;
    const double t32 = t27*t29; /* s*v_nu*S */
    const double t33 = JLT_FNMA(t26, t30, t32); /* s*v_nu*S - C*s*R*(omega_n*gamma3 + s*omega3) */
    out[8] = t33;
    const double t34 = -t22; /* -s*omega_tau*gamma3 */
    out[9] = t34;
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
    out[22] = 0.0;
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
    out[69] = x[4];
    const double t5 = x[9]*p[1]; /* s*R */
    const double t6 = x[4]*t5; /* omega3*s*R */
    out[63] = x[0];
    const double t7 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t8 = JLT_FMA(p[11], t7, t6); /* 2*R*omega_n*gamma3 + omega3*s*R */
    out[13] = t8;
    const double t9 = x[3]*t5; /* omega_n*s*R */
    out[14] = t9;
    const double t10 = x[3]*x[4]; /* omega_n*omega3 */
    const double t11 = p[1]*t10; /* R*omega_n*omega3 */
    out[19] = t11;
    const double t12 = -t3; /* -omega_n*omega_n */
    out[20] = t12;
    const double t13 = 2.0*t7; /* 2*omega_n*gamma3 */
    const double t14 = x[9]*p[6]; /* s*I3/I1 */
    const double t15 = JLT_FMA(x[4], t14, t13); /* omega3*s*I3/I1 + 2*omega_n*gamma3 */
    const double t16 = -t15; /* -(omega3*s*I3/I1 + 2*omega_n*gamma3) */
    out[23] = t16;
    const double t17 = x[3]*t14; /* omega_n*s*I3/I1 */
    const double t18 = -t17; /* -omega_n*s*I3/I1 */
    out[24] = t18;
    const double t19 = t10*p[12]; /* omega_n*omega3*(-I3/I1) */
    out[29] = t19;
    const double t20 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t21 = t0 + p[8]; /* s*s + I3/(m*R^2) */
    const double t22 = JLT_FMA(p[6], t20, t21); /* Theta/(m*R^2*I1) = I3/I1*gamma3*gamma3 + s*s + I3/(m*R^2) */
    const double t23 = 1.0/t22; /* 1/(Theta/(m*R^2*I1)) */
    const double t24 = JLT_FMA(p[9], x[1], x[2]); /* V/R = 1/R*v_nu + omega_tau */
    const double t25 = t23*t24; /* 1/(Theta/(m*R^2*I1))*V/R */
    const double t26 = JLT_FNMA(p[6], t25, x[2]); /* omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R */
    const double t27 = x[3]*t26; /* omega_n*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    const double t28 = t7*t23; /* omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t29 = t24*t28; /* V/R*omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t30 = p[13]*t29; /* 2*I3^2/I1^2*V/R*omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    const double t31 = x[9]*t23; /* s*1/(Theta/(m*R^2*I1)) */
    const double t32 = x[2]*t31; /* omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t33 = x[4]*t32; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t34 = JLT_FNMA(p[14], t33, t30); /* 2*I3^2/I1^2*V/R*omega_n*gamma3*1/(Theta/(m*R^2*I1)) - 2*(m*R^2*I3^3 + m^2*R^4*I3^2)/(m^2*R^4*I1^2)*omega3*omega_tau*s*1/(Theta/(m*R^2*I1)) */
    const double t35 = x[0]*t23; /* gamma3*1/(Theta/(m*R^2*I1)) */
    const double t36 = JLT_FMA(t34, t35, t27); /* t34*gamma3*1/(Theta/(m*R^2*I1)) + omega_n*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    out[30] = t36;
    const double t37 = t28*p[15]; /* omega_n*gamma3*1/(Theta/(m*R^2*I1))*(-I3/(R*I1)) */
    out[31] = t37;
    const double t38 = x[4]*p[7]; /* omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t39 = JLT_FMA(t31, t38, t7); /* s*1/(Theta/(m*R^2*I1))*omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) + omega_n*gamma3 */
    const double t40 = JLT_FNMA(p[6], t28, t39); /* t39 - I3/I1*omega_n*gamma3*1/(Theta/(m*R^2*I1)) */
    out[32] = t40;
    const double t41 = x[0]*t26; /* gamma3*(omega_tau - I3/I1*1/(Theta/(m*R^2*I1))*V/R) */
    out[33] = t41;
    const double t42 = t32*p[7]; /* omega_tau*s*1/(Theta/(m*R^2*I1))*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    out[34] = t42;
    const double t43 = x[2]*t38; /* omega_tau*omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t44 = t23*t43; /* 1/(Theta/(m*R^2*I1))*omega_tau*omega3*(I3^2 + m*R^2*I3)/(m*R^2*I1) */
    const double t45 = t29*p[17]; /* V/R*omega_n*gamma3*1/(Theta/(m*R^2*I1))*2*I3/I1 */
    const double t46 = JLT_FMS(t33, p[16], t45); /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*2*(m*R^2*I1*I3^2 + m^2*R^4*I1*I3)/(m^2*R^4*I1^2) - V/R*omega_n*gamma3*1/(Theta/(m*R^2*I1))*2*I3/I1 */
    const double t47 = JLT_FNMA(t31, t46, t44); /* t44 - s*1/(Theta/(m*R^2*I1))*t46 */
    out[39] = t47;
    const double t48 = x[9]*p[10]; /* s*(I1 - I3)/I1 */
    const double t49 = t33*t48; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    const double t50 = t33*p[18]; /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*2*I3*(I1 - I3)/I1^2 */
    const double t51 = JLT_FNMA(t20, t50, t45); /* V/R*omega_n*gamma3*1/(Theta/(m*R^2*I1))*2*I3/I1 - gamma3*gamma3*omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*2*I3*(I1 - I3)/I1^2 */
    const double t52 = JLT_FMA(t31, t51, t49); /* s*1/(Theta/(m*R^2*I1))*t51 + omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*s*(I1 - I3)/I1 */
    out[40] = t52;
    const double t53 = x[3]*t31; /* omega_n*s*1/(Theta/(m*R^2*I1)) */
    const double t54 = p[19]*t53; /* (-1/R)*omega_n*s*1/(Theta/(m*R^2*I1)) */
    out[41] = t54;
    const double t55 = x[9]*x[0]; /* s*gamma3 */
    const double t56 = p[10]*t55; /* (I1 - I3)/I1*s*gamma3 */
    const double t57 = x[4]*t56; /* omega3*(I1 - I3)/I1*s*gamma3 */
    const double t58 = JLT_FMS(t31, t57, t53); /* s*1/(Theta/(m*R^2*I1))*omega3*(I1 - I3)/I1*s*gamma3 - omega_n*s*1/(Theta/(m*R^2*I1)) */
    out[42] = t58;
    const double t59 = t24*t31; /* V/R*s*1/(Theta/(m*R^2*I1)) */
    const double t60 = -t59; /* -V/R*s*1/(Theta/(m*R^2*I1)) */
    out[43] = t60;
    const double t61 = t32*t56; /* omega_tau*s*1/(Theta/(m*R^2*I1))*(I1 - I3)/I1*s*gamma3 */
    out[44] = t61;
    const double t62 = x[3]*t25; /* omega_n*1/(Theta/(m*R^2*I1))*V/R */
    const double t63 = 2.0*t59; /* 2*V/R*s*1/(Theta/(m*R^2*I1)) */
    const double t64 = t20 + p[20]; /* gamma3*gamma3 + I1/(m*R^2) */
    const double t65 = t35*t64; /* gamma3*1/(Theta/(m*R^2*I1))*(gamma3*gamma3 + I1/(m*R^2)) */
    const double t66 = JLT_FMS(t53, t63, t62); /* omega_n*s*1/(Theta/(m*R^2*I1))*2*V/R*s*1/(Theta/(m*R^2*I1)) - omega_n*1/(Theta/(m*R^2*I1))*V/R */
    const double t67 = JLT_FMA(t50, t65, t66); /* omega3*omega_tau*s*1/(Theta/(m*R^2*I1))*2*I3*(I1 - I3)/I1^2*gamma3*1/(Theta/(m*R^2*I1))*(gamma3*gamma3 + I1/(m*R^2)) + t66 */
    out[49] = t67;
    out[53] = (-1.0);
    const double t68 = sin(x[5]); /* S = sin(chi) */
    const double t69 = t9*t68; /* omega_n*s*R*S */
    out[70] = t69;
    const double t70 = cos(x[5]); /* C = cos(chi) */
    const double t71 = x[9]*t70; /* s*C */
    out[71] = t71;
    const double t72 = t5*x[0]; /* s*R*gamma3 */
    const double t73 = t68*t72; /* S*s*R*gamma3 */
    out[73] = t73;
    const double t74 = x[9]*t68; /* s*S */
    out[81] = t74;
    const double t75 = t5*t74; /* s*R*s*S */
    out[74] = t75;
    const double t76 = x[1]*t74; /* v_nu*s*S */
    const double t77 = JLT_FMA(p[1], t7, t6); /* v_tau = R*omega_n*gamma3 + omega3*s*R */
    const double t78 = JLT_FMS(t71, t77, t76); /* s*C*v_tau - v_nu*s*S */
    out[75] = t78;
    const double t79 = x[1]*t70; /* v_nu*C */
    const double t80 = t6 + t77; /* omega3*s*R + v_tau */
    const double t81 = JLT_FMA(t68, t80, t79); /* S*(omega3*s*R + v_tau) + v_nu*C */
    out[79] = t81;
    const double t82 = t9*t70; /* omega_n*s*R*C */
    const double t83 = -t82; /* -omega_n*s*R*C */
    out[80] = t83;
    const double t84 = t70*t72; /* C*s*R*gamma3 */
    const double t85 = -t84; /* -C*s*R*gamma3 */
    out[83] = t85;
    const double t86 = t5*t71; /* s*R*s*C */
    const double t87 = -t86; /* -s*R*s*C */
    out[84] = t87;
    const double t88 = x[1]*t71; /* v_nu*s*C */
    const double t89 = JLT_FMA(t74, t77, t88); /* s*S*v_tau + v_nu*s*C */
    out[85] = t89;
    const double t90 = x[1]*t68; /* v_nu*S */
    const double t91 = JLT_FNMA(t70, t80, t90); /* v_nu*S - C*(omega3*s*R + v_tau) */
    out[89] = t91;
    const double t92 = -t1; /* -s*omega_tau */
    out[90] = t92;
    const double t93 = -t55; /* -s*gamma3 */
    out[92] = t93;
    const double t94 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t95 = -t94; /* -omega_tau*gamma3 */
    out[99] = t95;
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
    out[32] = 0.0;
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
    const double t1 = x[9]*x[9]; /* s*s */
    out[12] = t1;
    const double t2 = x[2]*t1; /* omega_tau*s*s */
    out[0] = t2;
    const double t3 = x[0]*p[23]; /* gamma3*m*R^2*I3 */
    const double t4 = JLT_FMA(p[22], t1, p[21]); /* m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta = gamma3*gamma3*m*R^2*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t6 = 1.0/t5; /* 1/Theta */
    const double t7 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t8 = x[9]*x[4]; /* s*omega3 */
    const double t9 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t10 = x[2]*p[24]; /* omega_tau*(I3^2 + m*R^2*I3) */
    const double t11 = x[9]*x[3]; /* s*omega_n */
    const double t12 = p[1]*t11; /* R*s*omega_n */
    out[24] = t12;
    const double t13 = p[12]*t11; /* (-I3/I1)*s*omega_n */
    out[34] = t13;
    const double t14 = p[26]*t7; /* m*R*I1*V */
    const double t15 = p[25]*t7; /* m*R*I3*V */
    const double t16 = x[9]*x[0]; /* s*gamma3 */
    const double t17 = -t16; /* -s*gamma3 */
    out[102] = t17;
    const double t18 = cos(x[5]); /* C = cos(chi) */
    const double t19 = x[9]*t18; /* s*C */
    out[81] = t19;
    const double t20 = sin(x[5]); /* S = sin(chi) */
    const double t21 = x[9]*t20; /* s*S */
    out[91] = t21;
    const double t22 = t8 + t9; /* s*omega3 + omega_n*gamma3 */
    out[6] = t22;
    const double t23 = p[6]*t8; /* I3/I1*s*omega3 */
    const double t24 = t8*t10; /* s*omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t25 = JLT_FNMA(t9, t15, t24); /* numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*m*R*I3*V */
    const double t26 = JLT_FNMA(t6, t15, x[2]); /* omega_tau - 1/Theta*m*R*I3*V */
    const double t27 = x[4]*t10; /* omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t28 = t6*t25; /* 1/Theta*numerator of d(omega_n)/dt over Theta */
    const double t29 = t6*t27; /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) */
    const double t30 = JLT_FMA(x[2], t9, t28); /* omega_tau*omega_n*gamma3 + 1/Theta*numerator of d(omega_n)/dt over Theta */
    out[3] = t30;
    const double t31 = x[0]*t26; /* gamma3*(omega_tau - 1/Theta*m*R*I3*V) */
    out[43] = t31;
    const double t32 = x[3]*t26; /* omega_n*(omega_tau - 1/Theta*m*R*I3*V) */
    const double t33 = t11*t14; /* s*omega_n*m*R*I1*V */
    const double t34 = x[2]*t16; /* omega_tau*s*gamma3 */
    const double t35 = -t34; /* -omega_tau*s*gamma3 */
    out[9] = t35;
    const double t36 = p[27]*t8; /* m*R^2*(I1 - I3)*s*omega3 */
    const double t37 = JLT_FMS(t34, t36, t33); /* numerator of d(omega3)/dt over Theta = omega_tau*s*gamma3*m*R^2*(I1 - I3)*s*omega3 - s*omega_n*m*R*I1*V */
    const double t38 = t6*t37; /* 1/Theta*numerator of d(omega3)/dt over Theta */
    out[4] = t38;
    const double t39 = x[1]*t20; /* v_nu*S */
    const double t40 = p[1]*t20; /* R*S */
    const double t41 = t11*t40; /* s*omega_n*R*S */
    out[80] = t41;
    const double t42 = t16*t40; /* s*gamma3*R*S */
    out[83] = t42;
    const double t43 = t1*t40; /* s*s*R*S */
    out[84] = t43;
    const double t44 = p[1]*t18; /* R*C */
    const double t45 = x[1]*t18; /* v_nu*C */
    const double t46 = JLT_FNMA(t22, t44, t39); /* v_nu*S - (s*omega3 + omega_n*gamma3)*R*C */
    const double t47 = JLT_FMA(t22, t40, t45); /* (s*omega3 + omega_n*gamma3)*R*S + v_nu*C */
    const double t48 = JLT_FMA(t8, t40, t47); /* s*omega3*R*S + (s*omega3 + omega_n*gamma3)*R*S + v_nu*C */
    out[89] = t48;
    const double t49 = x[9]*t47; /* s*((s*omega3 + omega_n*gamma3)*R*S + v_nu*C) */
    out[7] = t49;
    out[95] = t49;
    const double t50 = t1*t44; /* s*s*R*C */
    const double t51 = -t50; /* -s*s*R*C */
    out[94] = t51;
    const double t52 = JLT_FNMA(t8, t44, t46); /* v_nu*S - (s*omega3 + omega_n*gamma3)*R*C - s*omega3*R*C */
    out[99] = t52;
    const double t53 = x[9]*t46; /* s*(v_nu*S - (s*omega3 + omega_n*gamma3)*R*C) */
    out[8] = t53;
    const double t54 = -t53; /* -s*(v_nu*S - (s*omega3 + omega_n*gamma3)*R*C) */
    out[85] = t54;
    const double t55 = x[2]*x[9]; /* omega_tau*s */
    const double t56 = 2.0*t55; /* 2*omega_tau*s */
    out[19] = t56;
    const double t57 = -t55; /* -omega_tau*s */
    out[100] = t57;
    const double t58 = t6*t55; /* 1/Theta*omega_tau*s */
    const double t59 = p[24]*t58; /* (I3^2 + m*R^2*I3)*1/Theta*omega_tau*s */
    out[44] = t59;
    const double t60 = x[3]*t14; /* omega_n*m*R*I1*V */
    const double t61 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t62 = -t61; /* -omega_tau*gamma3 */
    out[109] = t62;
    const double t63 = p[32]*t8; /* 2*m*R^2*(I1 - I3)*s*omega3 */
    const double t64 = JLT_FMS(t61, t63, t60); /* d(numerator of d(omega3)/dt over Theta)/d(s) = omega_tau*gamma3*2*m*R^2*(I1 - I3)*s*omega3 - omega_n*m*R*I1*V */
    const double t65 = t6*t64; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) */
    const double t66 = t9 + t23; /* omega_n*gamma3 + I3/I1*s*omega3 */
    const double t67 = x[3]*t66; /* omega_n*(omega_n*gamma3 + I3/I1*s*omega3) */
    const double t68 = -t67; /* -omega_n*(omega_n*gamma3 + I3/I1*s*omega3) */
    out[2] = t68;
    const double t69 = JLT_FMA(2.0, t9, t23); /* 2*omega_n*gamma3 + I3/I1*s*omega3 */
    const double t70 = -t69; /* -(2*omega_n*gamma3 + I3/I1*s*omega3) */
    out[33] = t70;
    const double t71 = x[0]*p[28]; /* gamma3*2*m*R^2*I3 */
    const double t72 = t6*t71; /* 1/Theta*gamma3*2*m*R^2*I3 */
    const double t73 = JLT_FNMA(t28, t72, t32); /* omega_n*(omega_tau - 1/Theta*m*R*I3*V) - 1/Theta*numerator of d(omega_n)/dt over Theta*1/Theta*gamma3*2*m*R^2*I3 */
    out[40] = t73;
    const double t74 = p[24]*t8; /* (I3^2 + m*R^2*I3)*s*omega3 */
    const double t75 = p[1]*t8; /* R*s*omega3 */
    const double t76 = JLT_FMA(p[11], t9, t75); /* 2*R*omega_n*gamma3 + R*s*omega3 */
    out[23] = t76;
    const double t77 = JLT_FNMA(p[23], t9, t74); /* d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = (I3^2 + m*R^2*I3)*s*omega3 - m*R^2*I3*omega_n*gamma3 */
    const double t78 = JLT_FMA(t6, t77, t9); /* 1/Theta*d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) + omega_n*gamma3 */
    out[42] = t78;
    const double t79 = p[29]*t9; /* (-m*R*I3)*omega_n*gamma3 */
    const double t80 = t6*t79; /* 1/Theta*(-m*R*I3)*omega_n*gamma3 */
    out[41] = t80;
    const double t81 = x[9]*t6; /* s*1/Theta */
    const double t82 = t14*t81; /* m*R*I1*V*s*1/Theta */
    const double t83 = -t82; /* -m*R*I1*V*s*1/Theta */
    out[53] = t83;
    const double t84 = p[30]*t81; /* 2*m*R^2*I1*s*1/Theta */
    const double t85 = JLT_FNMA(t28, t84, t29); /* 1/Theta*omega3*omega_tau*(I3^2 + m*R^2*I3) - 1/Theta*numerator of d(omega_n)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    out[49] = t85;
    const double t86 = JLT_FNMA(t38, t84, t65); /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(s) - 1/Theta*numerator of d(omega3)/dt over Theta*2*m*R^2*I1*s*1/Theta */
    out[59] = t86;
    const double t87 = t16*t36; /* s*gamma3*m*R^2*(I1 - I3)*s*omega3 */
    const double t88 = t36*t58; /* m*R^2*(I1 - I3)*s*omega3*1/Theta*omega_tau*s */
    const double t89 = JLT_FNMA(t38, t72, t88); /* m*R^2*(I1 - I3)*s*omega3*1/Theta*omega_tau*s - 1/Theta*numerator of d(omega3)/dt over Theta*1/Theta*gamma3*2*m*R^2*I3 */
    out[50] = t89;
    const double t90 = JLT_FNMA(p[22], t11, t87); /* d(numerator of d(omega3)/dt over Theta)/d(omega_tau) = s*gamma3*m*R^2*(I1 - I3)*s*omega3 - m*R^2*I1*s*omega_n */
    const double t91 = t6*t90; /* 1/Theta*d(numerator of d(omega3)/dt over Theta)/d(omega_tau) */
    out[52] = t91;
    const double t92 = p[1]*x[3]; /* R*omega_n */
    const double t93 = t22*t92; /* (s*omega3 + omega_n*gamma3)*R*omega_n */
    out[1] = t93;
    const double t94 = x[3]*t92; /* omega_n*R*omega_n */
    out[20] = t94;
    const double t95 = x[4]*t92; /* omega3*R*omega_n */
    out[29] = t95;
    const double t96 = x[3]*x[3]; /* omega_n*omega_n */
    const double t97 = -t96; /* -omega_n*omega_n */
    out[30] = t97;
    const double t98 = x[3]*p[12]; /* omega_n*(-I3/I1) */
    const double t99 = x[4]*t98; /* omega3*omega_n*(-I3/I1) */
    out[39] = t99;
    const double t100 = p[31]*t11; /* (-m*R*I1)*s*omega_n */
    const double t101 = t6*t100; /* 1/Theta*(-m*R*I1)*s*omega_n */
    out[51] = t101;
    const double t102 = t11*t44; /* s*omega_n*R*C */
    const double t103 = -t102; /* -s*omega_n*R*C */
    out[90] = t103;
    const double t104 = t16*t44; /* s*gamma3*R*C */
    const double t105 = -t104; /* -s*gamma3*R*C */
    out[93] = t105;
    const double t106 = p[27]*t16; /* m*R^2*(I1 - I3)*s*gamma3 */
    const double t107 = t58*t106; /* 1/Theta*omega_tau*s*m*R^2*(I1 - I3)*s*gamma3 */
    out[54] = t107;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[9]*x[9]; /* s*s */
    const double t1 = x[0]*p[6]; /* gamma3*I3/I1 */
    const double t2 = p[8] + t0; /* I3/(m*R^2) + s*s */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + s*s */
    const double t4 = p[10]*x[2]; /* (I1 - I3)/I1*omega_tau */
    const double t5 = t0*t4; /* s*s*(I1 - I3)/I1*omega_tau */
    const double t6 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t7 = JLT_FNMA(p[33], t6, t5); /* s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V */
    const double t8 = x[0]*t7; /* gamma3*(s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V) */
    const double t9 = t8/t3; /* gamma3*(s*s*(I1 - I3)/I1*omega_tau - I3/(R*I1)*V)/(Theta/(m*R^2*I1)) */
    out[0] = t9;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[34]*x[1]; /* 1/2*m*v_nu */
    const double t1 = x[1]*t0; /* v_nu*1/2*m*v_nu */
    const double t2 = x[3]*x[3]; /* omega_n*omega_n */
    const double t3 = JLT_FMA(x[2], x[2], t2); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t4 = p[36]*x[4]; /* 1/2*I3*omega3 */
    const double t5 = x[4]*x[9]; /* omega3*s */
    const double t6 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t7 = t5 + t6; /* v_tau/R = omega3*s + omega_n*gamma3 */
    const double t8 = p[37]*t7; /* 1/2*m*R^2*v_tau/R */
    const double t9 = JLT_FMA(x[4], t4, t1); /* omega3*1/2*I3*omega3 + v_nu*1/2*m*v_nu */
    const double t10 = JLT_FMA(p[35], t3, t9); /* 1/2*I1*(omega_tau*omega_tau + omega_n*omega_n) + omega3*1/2*I3*omega3 + v_nu*1/2*m*v_nu */
    const double t11 = JLT_FMA(t7, t8, t10); /* v_tau/R*1/2*m*R^2*v_tau/R + t10 */
    out[0] = t11;
    const double t12 = x[3]*p[38]; /* omega_n*R*I1 */
    const double t13 = x[9]*t12; /* s*omega_n*R*I1 */
    const double t14 = x[4]*p[39]; /* omega3*R*I3 */
    const double t15 = JLT_FNMA(x[0], t14, t13); /* s*omega_n*R*I1 - gamma3*omega3*R*I3 */
    out[1] = t15;
    const double t16 = cos(x[5]); /* C = cos(chi) */
    const double t17 = t6*p[4]; /* omega_n*gamma3*I1 */
    const double t18 = JLT_FMA(t5, p[5], t17); /* omega3*s*I3 + omega_n*gamma3*I1 */
    const double t19 = JLT_FMA(t7, p[40], t18); /* M_nu = v_tau/R*m*R^2 + omega3*s*I3 + omega_n*gamma3*I1 */
    const double t20 = t16*t19; /* C*M_nu */
    const double t21 = sin(x[5]); /* S = sin(chi) */
    const double t22 = x[2]*p[4]; /* omega_tau*I1 */
    const double t23 = JLT_FNMA(x[1], p[41], t22); /* M_tau = omega_tau*I1 - v_nu*m*R */
    const double t24 = JLT_FMA(t21, t23, t20); /* S*M_tau + C*M_nu */
    out[2] = t24;
    const double t25 = t19*t21; /* M_nu*S */
    const double t26 = JLT_FNMA(t16, t23, t25); /* M_nu*S - C*M_tau */
    out[3] = t26;
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
    out[26] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[36] = 0.0;
    out[37] = 0.0;
    out[38] = 0.0;
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = x[4]*p[42]; /* omega3*(-R*I3) */
    out[10] = t1;
    const double t2 = x[9]*p[38]; /* s*R*I1 */
    out[13] = t2;
    const double t3 = x[0]*p[42]; /* gamma3*(-R*I3) */
    out[14] = t3;
    const double t4 = x[3]*p[38]; /* omega_n*R*I1 */
    out[19] = t4;
    const double t5 = x[0]*p[43]; /* gamma3*(I1 + m*R^2) */
    const double t6 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t7 = JLT_FMA(x[4], x[9], t6); /* omega3*s + omega_n*gamma3 */
    const double t8 = p[40]*t7; /* m*R^2*(omega3*s + omega_n*gamma3) */
    const double t9 = x[3]*t8; /* omega_n*m*R^2*(omega3*s + omega_n*gamma3) */
    out[0] = t9;
    const double t10 = x[4]*t8; /* omega3*m*R^2*(omega3*s + omega_n*gamma3) */
    out[9] = t10;
    const double t11 = x[3]*t5; /* omega_n*gamma3*(I1 + m*R^2) */
    const double t12 = x[4]*p[45]; /* omega3*(I3 + m*R^2) */
    const double t13 = JLT_FMA(x[9], t12, t11); /* M_nu = s*omega3*(I3 + m*R^2) + omega_n*gamma3*(I1 + m*R^2) */
    const double t14 = p[4]*x[2]; /* I1*omega_tau */
    out[2] = t14;
    const double t15 = JLT_FNMA(x[1], p[41], t14); /* M_tau = I1*omega_tau - v_nu*m*R */
    const double t16 = cos(x[5]); /* C = cos(chi) */
    const double t17 = t5*t16; /* gamma3*(I1 + m*R^2)*C */
    out[23] = t17;
    const double t18 = t12*t16; /* omega3*(I3 + m*R^2)*C */
    out[29] = t18;
    const double t19 = p[41]*t16; /* m*R*C */
    out[31] = t19;
    const double t20 = p[46]*t16; /* (-I1)*C */
    out[32] = t20;
    const double t21 = sin(x[5]); /* S = sin(chi) */
    const double t22 = t5*t21; /* gamma3*(I1 + m*R^2)*S */
    out[33] = t22;
    const double t23 = t12*t21; /* omega3*(I3 + m*R^2)*S */
    out[39] = t23;
    const double t24 = p[44]*t21; /* (-m*R)*S */
    out[21] = t24;
    const double t25 = p[4]*t21; /* I1*S */
    out[22] = t25;
    const double t26 = x[3]*p[4]; /* omega_n*I1 */
    const double t27 = JLT_FMA(x[0], t8, t26); /* gamma3*m*R^2*(omega3*s + omega_n*gamma3) + omega_n*I1 */
    out[3] = t27;
    const double t28 = x[4]*p[5]; /* omega3*I3 */
    const double t29 = JLT_FMA(x[9], t8, t28); /* s*m*R^2*(omega3*s + omega_n*gamma3) + omega3*I3 */
    out[4] = t29;
    const double t30 = x[3]*p[43]; /* d(M_nu)/d(gamma3) = omega_n*(I1 + m*R^2) */
    const double t31 = t16*t30; /* C*d(M_nu)/d(gamma3) */
    out[20] = t31;
    const double t32 = t21*t30; /* S*d(M_nu)/d(gamma3) */
    out[30] = t32;
    const double t33 = x[9]*p[45]; /* s*(I3 + m*R^2) */
    const double t34 = t16*t33; /* C*s*(I3 + m*R^2) */
    out[24] = t34;
    const double t35 = t21*t33; /* S*s*(I3 + m*R^2) */
    out[34] = t35;
    const double t36 = t13*t21; /* M_nu*S */
    const double t37 = JLT_FMS(t15, t16, t36); /* M_tau*C - M_nu*S */
    out[25] = t37;
    const double t38 = t13*t16; /* M_nu*C */
    const double t39 = JLT_FMA(t15, t21, t38); /* M_tau*S + M_nu*C */
    out[35] = t39;
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
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double u41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double u43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
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
        t7[k] = jlt_jet_product(x9, x4, k);
        t9[k] = jlt_jet_product(x3, x0, k);
        t10[k] = t7[k] + t9[k];
        t11[k] = p[1]*t10[k];
        t12[k] = jlt_jet_product(x3, t11, k);
        t14[k] = t7[k]*p[6] + t9[k];
        t15[k] = jlt_jet_product(x3, t14, k);
        t16[k] = -t15[k];
        t19[k] = x0[k]*p[6];
        t20[k] = jlt_jet_product(x9, x9, k) + (k == 0 ? p[8] : 0);
        t21[k] = jlt_jet_product(x0, t19, k) + t20[k];
        t23[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t21, t23, k);
        t24[k] = jlt_jet_product(t7, t23, k);
        t25[k] = x2[k]*p[7];
        t26[k] = jlt_jet_product(t24, t25, k);
        t29[k] = p[9]*x1[k] + x2[k];
        t30[k] = jlt_jet_product(t23, t29, k);
        t31[k] = x2[k] - p[6]*t30[k];
        t32[k] = jlt_jet_product(t9, t31, k) + t26[k];
        t34[k] = jlt_jet_product(t2, x0, k);
        t35[k] = p[10]*t34[k];
        t36[k] = jlt_jet_product(t24, t35, k);
        t37[k] = jlt_jet_product(x9, x3, k);
        t38[k] = t36[k] - jlt_jet_product(t30, t37, k);
        t39[k] = -x3[k];
        t41[k] = jlt_jet_cosine(x5, t41, u41, k);
        t42[k] = jlt_jet_product(x1, t41, k);
        t43[k] = jlt_jet_sine(x5, t43, u43, k);
        t44[k] = jlt_jet_product(t11, t43, k) + t42[k];
        t45[k] = jlt_jet_product(x9, t44, k);
        t46[k] = jlt_jet_product(x1, t43, k);
        t47[k] = t46[k] - jlt_jet_product(t11, t41, k);
        t48[k] = jlt_jet_product(x9, t47, k);
        t49[k] = -t34[k];
        double *restrict next = coefficients + (k + 1)*11;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t12[k]/(k + 1);
        next[2] = x2[k + 1] = t16[k]/(k + 1);
        next[3] = x3[k + 1] = t32[k]/(k + 1);
        next[4] = x4[k + 1] = t38[k]/(k + 1);
        next[5] = x5[k + 1] = t39[k]/(k + 1);
        next[6] = x6[k + 1] = t10[k]/(k + 1);
        next[7] = x7[k + 1] = t45[k]/(k + 1);
        next[8] = x8[k + 1] = t48[k]/(k + 1);
        next[9] = x9[k + 1] = t49[k]/(k + 1);
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
    const double v_a3 = (0.0);
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
    { "M_x", "a3 = 0" },
    { "M_y", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_track_balanced_in_regular = {
    .model = "spherical_top_track",
    .variant = "balanced",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint: reduced system, attitude and track",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, systems (3.2) and (2.1)",
    .sha256 = "625d85d15c100ca2dae29fad59d2270d223eeee8eb0edf5e58d4ac2c69c80735",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_track, .family = jlt_family_spherical_top_track, .claims = jlt_claims_spherical_top_track,
    .scales = 1,
    .state_count = 10, .param_count = 6, .prepared_count = 47,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 10, { 4, 19, 9, 1, 0, 2, 7, 8 }, { 17, 71, 0, 6, 0, 2, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in d(spin)/dtau, s*omega3*(I3/I1) + omega_n*gamma3, a part of d(omega_n)/dtau, V/R = (1/R)*v_nu + omega_tau, d(omega_n)/dtau, d(omega3)/dtau, d(x)/dtau, d(y)/dtau" },
    .jacobian = { jacobian, 100, { 13, 59, 21, 1, 0, 2, 10, 19 }, { 50, 292, 0, 31, 0, 2, 13, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in d(d(v_nu)/dtau)/d(omega_n), omega3*s*(I3/I1) + (2)*omega_n*gamma3, V/R = (1/R)*v_nu + omega_tau, omega_tau - (I3/I1)*((1)/Theta/(m*R^2*I1))*V/R, a part of d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), a part of d(d(omega_n)/dtau)/d(s), d(d(omega_n)/dtau)/d(s), a part of d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(omega_tau), d(d(omega3)/dtau)/d(s), v_tau = R*omega_n*gamma3 + omega3*s*R, d(d(x)/dtau)/d(chi), omega3*s*R + v_tau, d(d(x)/dtau)/d(s), d(d(y)/dtau)/d(chi), d(d(y)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 110, { 15, 69, 21, 1, 0, 2, 7, 19 }, { 63, 347, 0, 37, 0, 2, 13, 10 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, d(spin)/dtau, numerator of d(omega_n)/dt over Theta = s*omega3*omega_tau*(I3^2 + m*R^2*I3) - omega_n*gamma3*(m*R*I3)*V, omega_tau - ((1)/Theta)*(m*R*I3)*V, d(omega_n)/dtau, numerator of d(omega3)/dt over Theta = omega_tau*s*gamma3*(m*R^2*(I1 - I3))*s*omega3 - s*omega_n*(m*R*I1)*V, v_nu*S - (s*omega3 + omega_n*gamma3)*R*C, (s*omega3 + omega_n*gamma3)*R*S + v_nu*C, d(d(x)/dtau)/d(s), d(d(y)/dtau)/d(s), d(numerator of d(omega3)/dt over Theta)/d(s) = omega_tau*gamma3*(2*m*R^2*(I1 - I3))*s*omega3 - omega_n*(m*R*I1)*V, omega_n*gamma3 + (I3/I1)*s*omega3, (2)*omega_n*gamma3 + (I3/I1)*s*omega3, d(d(omega_n)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(omega_n), d(numerator of d(omega_n)/dt over Theta)/d(omega_tau) = (I3^2 + m*R^2*I3)*s*omega3 - (m*R^2*I3)*omega_n*gamma3, d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(s), d(d(omega3)/dtau)/d(gamma3), d(numerator of d(omega3)/dt over Theta)/d(omega_tau) = s*gamma3*(m*R^2*(I1 - I3))*s*omega3 - (m*R^2*I1)*s*omega_n" },
    .divergence = { divergence, 1, { 1, 5, 3, 1, 0, 0, 5, 4 }, { 5, 23, 0, 2, 0, 0, 8, 5 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*R^2*I3*gamma3^2 are; digits are lost where terms nearly cancel in V = omega_tau*R + v_nu, s*s*((I1 - I3)/I1)*omega_tau - (I3/(R*I1))*V" },
    .integral_values = { integral_values, 4, { 1, 14, 10, 0, 0, 2, 6, 8 }, { 11, 38, 0, 0, 0, 2, 8, 7 },
        "digits are lost where terms nearly cancel in v_tau/R = omega3*s + omega_n*gamma3, G, M_nu = v_tau/R*(m*R^2) + omega3*s*I3 + omega_n*gamma3*I1, M_tau = omega_tau*I1 - v_nu*(m*R), M_x, M_y" },
    .integral_gradients = { integral_gradients, 40, { 0, 31, 7, 0, 0, 2, 5, 8 }, { 16, 71, 0, 0, 0, 2, 7, 10 },
        "digits are lost where terms nearly cancel in omega3*s + omega_n*gamma3, M_nu = s*omega3*(I3 + m*R^2) + omega_n*gamma3*(I1 + m*R^2), M_tau = I1*omega_tau - v_nu*(m*R), d(E)/d(omega_n), d(E)/d(omega3), d(M_x)/d(chi), d(M_y)/d(chi)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 4, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_track_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_track_balanced_in_regular) },
#endif
};
