/* Sphere with displaced centre of mass rolling without slipping, reduced system
 *
 *  Source:     E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      routh_sphere, SHA-256 3411ed6d53d99c328220ac4c0d992bf489a81f74d3bcee4f47f68fdd4a704bc2
 *  Command:    ttc generate --effort full --out DIR routh_sphere.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   21   11    1    0    0      9   10   (90)
 *  jacobian            8   48   23    1    0    0     12   15   (345)
 *  rhs_jacobian        10   58   25    1    0    0     10   17   (407)
 *  divergence          2    7    4    1    0    0      6    6   (41)
 *  integral_values     0   13   12    0    1    0      6    7   (54)
 *  integral_gradients  0   25   12    1    1    0      6    7   (77)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    divides by K: values and rounding errors grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = R*gamma3 + a3, gamma3*(2*R*a3) + R^2 + a3^2,
 *      K = m*(gamma3*(2*R*a3) + R^2 + a3^2) + I1, v_tau = R*s*omega3 + omega_n*b, e = a3*gamma3 + R,
 *      (I3/m)*s*omega3 + v_tau*e, I3/(m*R) + e, (I1/m)*omega_n*gamma3 + (I3/m)*s*omega3 + v_tau*e,
 *      b*omega_n*e + (2*I1/m)*omega_n*gamma3 + (I3/m)*s*omega3 + v_tau*e,
 *      (a3/R)*v_tau + omega_n*(I1/(m*R)) + omega_n*e,
 *      a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3),
 *      gamma3*(R*(I1 - I3)) - (a3*I3), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_n)/dtau)/d(omega_tau),
 *      a3 - 1/Theta*(I3/(m*R) + e)*(2*m*R*I3)*b, omega_tau*omega3 - (2*m*R^2*I1)*s*omega3*1/Theta*s*omega_tau,
 *      d(omega_n)/dtau, d(d(omega_n)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(gamma3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_routh_sphere[];
extern const jlt_claim jlt_claims_routh_sphere[];
extern const jlt_descriptor *const jlt_family_routh_sphere[];
extern const jlt_descriptor jlt_kernels_routh_sphere_general_in_regular;
extern const struct jlt_ball_table jlt_balls_routh_sphere_general_in_regular;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_routh_sphere_general_in_regular_avx512;

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
    const double t5 = params[1]*params[3]; /* R*a3 */
    out[8] = t5;
    const double t6 = params[3]*params[2]; /* a3*g */
    out[9] = t6;
    const double t7 = params[4]/params[0]; /* I1/m */
    out[10] = t7;
    const double t8 = params[5]/params[4]; /* I3/I1 */
    out[11] = t8;
    const double t9 = params[3]*params[3]; /* a3*a3 */
    out[54] = t9;
    const double t10 = t0 + t9; /* R*R + a3*a3 */
    out[40] = t10;
    const double t11 = t7 + t10; /* I1/m + R*R + a3*a3 */
    out[12] = t11;
    const double t12 = params[1]*2.0; /* R*2 */
    const double t13 = params[3]*t12; /* a3*R*2 */
    out[13] = t13;
    const double t14 = params[1]*params[4]; /* R*I1 */
    out[57] = t14;
    const double t15 = params[5]/t14; /* I3/(R*I1) */
    out[14] = t15;
    const double t16 = params[0]*params[1]; /* m*R */
    out[42] = t16;
    const double t17 = params[5]/t16; /* I3/(m*R) */
    out[15] = t17;
    const double t18 = 1.0/t14; /* 1/(R*I1) */
    out[16] = t18;
    const double t19 = params[4] - params[5]; /* I1 - I3 */
    const double t20 = params[1]*t19; /* R*(I1 - I3) */
    out[17] = t20;
    const double t21 = params[5]*params[3]; /* I3*a3 */
    out[18] = t21;
    const double t22 = params[3]*2.0; /* a3*2 */
    out[19] = t22;
    const double t23 = params[5]*t22; /* I3*a3*2 */
    const double t24 = t23/params[0]; /* I3*a3*2/m */
    out[20] = t24;
    const double t25 = params[4]*t22; /* I1*a3*2 */
    const double t26 = t25/params[0]; /* I1*a3*2/m */
    out[21] = t26;
    const double t27 = params[4]/t16; /* I1/(m*R) */
    out[22] = t27;
    const double t28 = params[3]/params[1]; /* a3/R */
    out[23] = t28;
    const double t29 = t0*2.0; /* R*R*2 */
    const double t30 = t9*t29; /* a3*a3*R*R*2 */
    out[24] = t30;
    const double t31 = params[2]/params[1]; /* g/R */
    out[25] = t31;
    const double t32 = params[1]*(-2.0); /* R*(-2) */
    const double t33 = params[3]*t32; /* a3*R*(-2) */
    out[26] = t33;
    const double t34 = params[4]*2.0; /* I1*2 */
    const double t35 = t34/params[0]; /* I1*2/m */
    out[27] = t35;
    const double t36 = params[5]/params[0]; /* I3/m */
    out[28] = t36;
    const double t37 = t21/t14; /* I3*a3/(R*I1) */
    out[29] = t37;
    const double t38 = params[4]*params[4]; /* I1*I1 */
    const double t39 = t0*t38; /* R*R*I1*I1 */
    const double t40 = params[5]*params[5]; /* I3*I3 */
    const double t41 = 2.0*t40; /* 2*I3*I3 */
    const double t42 = t41/t39; /* 2*I3*I3/(R*R*I1*I1) */
    out[30] = t42;
    const double t43 = params[5]*2.0; /* I3*2 */
    const double t44 = t43/t14; /* I3*2/(R*I1) */
    out[31] = t44;
    const double t45 = t19/params[4]; /* (I1 - I3)/I1 */
    out[32] = t45;
    const double t46 = t43/t39; /* I3*2/(R*R*I1*I1) */
    out[33] = t46;
    const double t47 = 2.0/t14; /* 2/(R*I1) */
    out[34] = t47;
    const double t48 = params[3]*t16; /* a3*m*R */
    out[35] = t48;
    const double t49 = params[0]*params[2]; /* m*g */
    const double t50 = params[3]*t49; /* a3*m*g */
    out[36] = t50;
    const double t51 = params[5]*params[4]; /* I3*I1 */
    out[37] = t51;
    const double t52 = t1*params[4]; /* m*R*R*I1 */
    out[38] = t52;
    const double t53 = params[0]*params[5]; /* m*I3 */
    out[39] = t53;
    const double t54 = params[5]*t16; /* I3*m*R */
    out[41] = t54;
    const double t55 = -params[0]; /* -m */
    out[45] = t55;
    const double t56 = -t16; /* -m*R */
    out[43] = t56;
    const double t57 = params[0]*2.0; /* m*2 */
    const double t58 = params[1]*t57; /* R*m*2 */
    const double t59 = params[3]*t58; /* a3*R*m*2 */
    out[44] = t59;
    const double t60 = params[2]*t57; /* g*m*2 */
    const double t61 = params[3]*t60; /* a3*g*m*2 */
    out[46] = t61;
    const double t62 = params[5]*t58; /* I3*R*m*2 */
    out[47] = t62;
    const double t63 = t0*t57; /* R*R*m*2 */
    const double t64 = params[4]*t63; /* I1*R*R*m*2 */
    out[48] = t64;
    const double t65 = t1*t19; /* m*R*R*(I1 - I3) */
    out[49] = t65;
    const double t66 = params[0]*params[0]; /* m*m */
    const double t67 = 2.0*t66; /* 2*m*m */
    const double t68 = t0*t67; /* R*R*2*m*m */
    const double t69 = params[5]*t68; /* I3*R*R*2*m*m */
    out[50] = t69;
    const double t70 = params[1]*t67; /* R*2*m*m */
    const double t71 = params[5]*t70; /* I3*R*2*m*m */
    out[51] = t71;
    const double t72 = params[3]*t29; /* a3*R*R*2 */
    const double t73 = params[4]*t72; /* I1*a3*R*R*2 */
    out[52] = t73;
    const double t74 = params[0]/2.0; /* m/2 */
    out[53] = t74;
    const double t75 = params[4]/2.0; /* I1/2 */
    out[55] = t75;
    const double t76 = params[5]/2.0; /* I3/2 */
    out[56] = t76;
    const double t77 = params[0]*t9; /* m*a3*a3 */
    out[58] = t77;
    const double t78 = t9/params[1]; /* a3*a3/R */
    out[59] = t78;
    const double t79 = params[1]*params[5]; /* R*I3 */
    const double t80 = -t79; /* -R*I3 */
    out[60] = t80;
    const double t81 = -params[5]; /* -I3 */
    out[61] = t81;
    const double t82 = -t7; /* -I1/m */
    out[62] = t82;
    const double t83 = t48/params[4]; /* a3*m*R/I1 */
    out[63] = t83;
    const double t84 = params[0]/params[4]; /* m/I1 */
    out[64] = t84;
    const double t85 = t50/params[4]; /* a3*m*g/I1 */
    out[65] = t85;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[1]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = p[7]*t3; /* I3/(R^2*I1)*b */
    const double t5 = p[6] + t2; /* I3/(m*R^2) + s*s */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s*s */
    const double t7 = t0*p[8]; /* s*omega_tau*R*a3 */
    const double t8 = t0*t7; /* s*omega_tau*s*omega_tau*R*a3 */
    const double t9 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t10 = t3*x[2]; /* b*omega_n */
    const double t11 = x[4]*x[3]; /* s*omega3 */
    const double t12 = JLT_FMA(p[1], t11, t10); /* v_tau = R*s*omega3 + b*omega_n */
    const double t13 = t9*t12; /* e*v_tau */
    const double t14 = x[0]*x[2]; /* gamma3*omega_n */
    const double t15 = JLT_FMA(t11, p[11], t14); /* s*omega3*I3/I1 + gamma3*omega_n */
    const double t16 = JLT_FMA(p[10], t15, t13); /* I1/m*(s*omega3*I3/I1 + gamma3*omega_n) + e*v_tau */
    const double t17 = JLT_FMA(t2, p[9], t8); /* s*s*g*a3 + s*omega_tau*s*omega_tau*R*a3 */
    const double t18 = JLT_FMA(x[2], t16, t17); /* omega_n*(I1/m*(s*omega3*I3/I1 + gamma3*omega_n) + e*v_tau) + s*s*g*a3 + s*omega_tau*s*omega_tau*R*a3 */
    const double t19 = JLT_FMA(x[0], p[13], p[12]); /* K/m = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t20 = t6*t19; /* Theta/(m*R^2*I1)*K/m */
    const double t21 = 1.0/t20; /* 1/(Theta/(m*R^2*I1)*K/m) */
    const double t22 = t6*t18; /* Theta/(m*R^2*I1)*t18 */
    const double t23 = t21*t22; /* 1/(Theta/(m*R^2*I1)*K/m)*Theta/(m*R^2*I1)*t18 */
    const double t24 = -t23; /* -1/(Theta/(m*R^2*I1)*K/m)*Theta/(m*R^2*I1)*t18 */
    out[1] = t24;
    const double t25 = t11*t19; /* s*omega3*K/m */
    const double t26 = t21*t25; /* 1/(Theta/(m*R^2*I1)*K/m)*s*omega3*K/m */
    const double t27 = t9 + p[15]; /* e + I3/(m*R) */
    const double t28 = p[14]*t27; /* I3/(R*I1)*(e + I3/(m*R)) */
    const double t29 = JLT_FMA(t26, t28, t14); /* 1/(Theta/(m*R^2*I1)*K/m)*s*omega3*K/m*I3/(R*I1)*(e + I3/(m*R)) + gamma3*omega_n */
    const double t30 = x[1]*t29; /* omega_tau*t29 */
    out[2] = t30;
    const double t31 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t32 = t0*p[16]; /* s*omega_tau*1/(R*I1) */
    const double t33 = t31*t32; /* (gamma3*R*(I1 - I3) - a3*I3)*s*omega_tau*1/(R*I1) */
    const double t34 = t26*t33; /* 1/(Theta/(m*R^2*I1)*K/m)*s*omega3*K/m*(gamma3*R*(I1 - I3) - a3*I3)*s*omega_tau*1/(R*I1) */
    out[3] = t34;
    const double t35 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t36 = -t35; /* -s*omega_tau*gamma3 */
    out[4] = t36;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
    out[17] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[1] = t0;
    const double t1 = p[6] + t0; /* I3/(m*R^2) + s*s */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = p[7]*t2; /* I3/(R^2*I1)*b */
    const double t4 = JLT_FMA(t2, t3, t1); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s*s */
    const double t5 = JLT_FMA(x[0], p[13], p[12]); /* K/m = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t6 = t4*t5; /* Theta/(m*R^2*I1)*K/m */
    const double t7 = 1.0/t6; /* 1/(Theta/(m*R^2*I1)*K/m) */
    const double t8 = t4*t7; /* 1/(K/m) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*K/m) */
    const double t9 = t5*t7; /* 1/(Theta/(m*R^2*I1)) = K/m*1/(Theta/(m*R^2*I1)*K/m) */
    const double t10 = x[2]*t2; /* omega_n*b */
    const double t11 = x[4]*x[3]; /* s*omega3 */
    const double t12 = JLT_FMA(p[1], t11, t10); /* v_tau = R*s*omega3 + omega_n*b */
    const double t13 = x[0]*x[2]; /* gamma3*omega_n */
    const double t14 = x[2]*p[22]; /* omega_n*I1/(m*R) */
    const double t15 = JLT_FMA(p[23], t12, t14); /* a3/R*v_tau + omega_n*I1/(m*R) */
    const double t16 = t8*t12; /* 1/(K/m)*v_tau */
    const double t17 = JLT_FMA(t8, t10, t16); /* 1/(K/m)*omega_n*b + 1/(K/m)*v_tau */
    const double t18 = JLT_FNMA(p[19], t16, x[2]); /* omega_n - 2*a3*1/(K/m)*v_tau */
    const double t19 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t20 = x[4]*t8; /* s*1/(K/m) */
    const double t21 = t8*t13; /* 1/(K/m)*gamma3*omega_n */
    const double t22 = JLT_FNMA(p[21], t21, t15); /* a3/R*v_tau + omega_n*I1/(m*R) - 2*a3*I1/m*1/(K/m)*gamma3*omega_n */
    const double t23 = p[27]*t21; /* 2*I1/m*1/(K/m)*gamma3*omega_n */
    const double t24 = p[1]*x[2]; /* R*omega_n */
    const double t25 = t8*t24; /* 1/(K/m)*R*omega_n */
    const double t26 = x[3]*t20; /* omega3*s*1/(K/m) */
    const double t27 = JLT_FNMA(p[20], t26, t22); /* t22 - 2*a3*I3/m*omega3*s*1/(K/m) */
    const double t28 = JLT_FMA(t18, t19, t27); /* (omega_n - 2*a3*1/(K/m)*v_tau)*e + t22 - 2*a3*I3/m*omega3*s*1/(K/m) */
    const double t29 = JLT_FMA(p[28], t26, t23); /* I3/m*omega3*s*1/(K/m) + 2*I1/m*1/(K/m)*gamma3*omega_n */
    const double t30 = JLT_FMA(t17, t19, t29); /* (1/(K/m)*omega_n*b + 1/(K/m)*v_tau)*e + I3/m*omega3*s*1/(K/m) + 2*I1/m*1/(K/m)*gamma3*omega_n */
    const double t31 = -t30; /* -t30 */
    out[7] = t31;
    const double t32 = p[15] + t19; /* I3/(m*R) + e */
    const double t33 = t25*t28; /* 1/(K/m)*R*omega_n*t28 */
    const double t34 = t25*t32; /* 1/(K/m)*R*omega_n*(I3/(m*R) + e) */
    const double t35 = t9*t32; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t36 = x[4]*t9; /* s*1/(Theta/(m*R^2*I1)) */
    const double t37 = x[1]*x[3]; /* omega_tau*omega3 */
    const double t38 = JLT_FMA(x[1], x[1], p[25]); /* omega_tau*omega_tau + g/R */
    const double t39 = t20*t38; /* s*1/(K/m)*(omega_tau*omega_tau + g/R) */
    const double t40 = t36*t37; /* s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t41 = t2*t40; /* b*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t42 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t43 = t36*t42; /* s*1/(Theta/(m*R^2*I1))*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t44 = t40*t42; /* s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t45 = x[4]*x[1]; /* s*omega_tau */
    const double t46 = 2.0*t45; /* 2*s*omega_tau */
    out[4] = t46;
    const double t47 = -t45; /* -s*omega_tau */
    out[20] = t47;
    const double t48 = x[3]*t34; /* omega3*1/(K/m)*R*omega_n*(I3/(m*R) + e) */
    const double t49 = x[4]*t34; /* s*1/(K/m)*R*omega_n*(I3/(m*R) + e) */
    const double t50 = -t49; /* -s*1/(K/m)*R*omega_n*(I3/(m*R) + e) */
    out[8] = t50;
    const double t51 = JLT_FMA(p[13], t39, t48); /* 2*R*a3*s*1/(K/m)*(omega_tau*omega_tau + g/R) + omega3*1/(K/m)*R*omega_n*(I3/(m*R) + e) */
    const double t52 = -t51; /* -t51 */
    out[9] = t52;
    const double t53 = x[1]*x[2]; /* omega_tau*omega_n */
    const double t54 = JLT_FMA(p[29], t40, t53); /* a3*I3/(R*I1)*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 + omega_tau*omega_n */
    const double t55 = x[4]*t40; /* s*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t56 = JLT_FNMA(t43, t55, t44); /* t44 - s*1/(Theta/(m*R^2*I1))*(gamma3*R*(I1 - I3) - a3*I3)*s*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t57 = p[34]*t56; /* 2/(R*I1)*t56 */
    out[19] = t57;
    const double t58 = p[14]*t35; /* I3/(R*I1)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t59 = JLT_FMA(t11, t58, t13); /* s*omega3*I3/(R*I1)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) + gamma3*omega_n */
    out[11] = t59;
    const double t60 = t37*t58; /* omega_tau*omega3*I3/(R*I1)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t61 = t45*t58; /* s*omega_tau*I3/(R*I1)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    out[13] = t61;
    const double t62 = p[24]*t20; /* 2*R^2*a3^2*s*1/(K/m) */
    const double t63 = JLT_FMS(t39, t62, t33); /* s*1/(K/m)*(omega_tau*omega_tau + g/R)*2*R^2*a3^2*s*1/(K/m) - 1/(K/m)*R*omega_n*t28 */
    out[5] = t63;
    const double t64 = p[26]*t45; /* (-2*R*a3)*s*omega_tau */
    const double t65 = t20*t64; /* s*1/(K/m)*(-2*R*a3)*s*omega_tau */
    out[6] = t65;
    const double t66 = p[30]*t35; /* 2*I3^2/(R^2*I1^2)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t67 = JLT_FNMA(t41, t66, t54); /* t54 - b*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*2*I3^2/(R^2*I1^2)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    out[10] = t67;
    const double t68 = p[31]*t35; /* 2*I3/(R*I1)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t69 = JLT_FNMA(t55, t68, t60); /* t60 - s*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*2*I3/(R*I1)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    out[14] = t69;
    const double t70 = p[32]*t55; /* (I1 - I3)/I1*s*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 */
    const double t71 = x[1]*x[0]; /* omega_tau*gamma3 */
    out[12] = t71;
    const double t72 = -t71; /* -omega_tau*gamma3 */
    out[24] = t72;
    const double t73 = p[33]*t43; /* 2*I3/(R^2*I1^2)*s*1/(Theta/(m*R^2*I1))*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t74 = JLT_FNMA(t41, t73, t70); /* (I1 - I3)/I1*s*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3 - b*s*1/(Theta/(m*R^2*I1))*omega_tau*omega3*t73 */
    out[15] = t74;
    const double t75 = p[16]*t43; /* 1/(R*I1)*s*1/(Theta/(m*R^2*I1))*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t76 = t11*t75; /* s*omega3*1/(R*I1)*s*1/(Theta/(m*R^2*I1))*(gamma3*R*(I1 - I3) - a3*I3) */
    out[16] = t76;
    const double t77 = t45*t75; /* s*omega_tau*1/(R*I1)*s*1/(Theta/(m*R^2*I1))*(gamma3*R*(I1 - I3) - a3*I3) */
    out[18] = t77;
    const double t78 = x[4]*x[0]; /* s*gamma3 */
    const double t79 = -t78; /* -s*gamma3 */
    out[21] = t79;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[22] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = x[4]*x[4]; /* s*s */
    out[6] = t1;
    const double t2 = t0*t0; /* b*b */
    const double t3 = JLT_FMA(p[38], t1, p[37]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(p[39], t2, t3); /* Theta = m*I3*b*b + m*R^2*I1*s*s + I1*I3 */
    const double t5 = p[10] + t2; /* I1/m + b*b */
    const double t6 = p[51]*t5; /* 2*m^2*R*I3*(I1/m + b*b) */
    const double t7 = JLT_FMA(x[0], p[13], p[40]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t8 = JLT_FMA(p[0], t7, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t9 = t4*t8; /* Theta*K */
    const double t10 = 1.0/t9; /* 1/(Theta*K) */
    const double t11 = t8*t10; /* 1/Theta = K*1/(Theta*K) */
    const double t12 = t4*t10; /* 1/K = Theta*1/(Theta*K) */
    const double t13 = x[2]*t0; /* omega_n*b */
    const double t14 = x[4]*x[3]; /* s*omega3 */
    const double t15 = JLT_FMA(p[1], t14, t13); /* v_tau = R*s*omega3 + omega_n*b */
    const double t16 = x[4]*x[1]; /* s*omega_tau */
    const double t17 = x[4]*t16; /* s*s*omega_tau */
    out[0] = t17;
    const double t18 = 2.0*t16; /* 2*s*omega_tau */
    out[9] = t18;
    const double t19 = -t16; /* -s*omega_tau */
    out[25] = t19;
    const double t20 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t21 = t15*t20; /* v_tau*e */
    const double t22 = JLT_FMA(p[28], t14, t21); /* I3/m*s*omega3 + v_tau*e */
    const double t23 = p[35]*t16; /* m*R*a3*s*omega_tau */
    const double t24 = t16*t23; /* s*omega_tau*m*R*a3*s*omega_tau */
    const double t25 = JLT_FMA(p[36], t1, t24); /* m*g*a3*s*s + s*omega_tau*m*R*a3*s*omega_tau */
    const double t26 = x[2]*x[0]; /* omega_n*gamma3 */
    const double t27 = x[2]*t20; /* omega_n*e */
    const double t28 = p[15] + t20; /* I3/(m*R) + e */
    const double t29 = p[44]*t16; /* 2*m*R*a3*s*omega_tau */
    const double t30 = JLT_FMA(p[10], t26, t22); /* I1/m*omega_n*gamma3 + I3/m*s*omega3 + v_tau*e */
    const double t31 = JLT_FMA(p[27], t26, t22); /* 2*I1/m*omega_n*gamma3 + I3/m*s*omega3 + v_tau*e */
    const double t32 = JLT_FMA(t0, t27, t31); /* b*omega_n*e + 2*I1/m*omega_n*gamma3 + I3/m*s*omega3 + v_tau*e */
    const double t33 = JLT_FMA(x[2], p[22], t27); /* omega_n*I1/(m*R) + omega_n*e */
    const double t34 = JLT_FMA(p[23], t15, t33); /* a3/R*v_tau + omega_n*I1/(m*R) + omega_n*e */
    const double t35 = x[2]*t34; /* omega_n*(a3/R*v_tau + omega_n*I1/(m*R) + omega_n*e) */
    const double t36 = p[45]*t32; /* (-m)*t32 */
    const double t37 = t12*t36; /* 1/K*(-m)*t32 */
    out[12] = t37;
    const double t38 = p[0]*x[2]; /* m*omega_n */
    const double t39 = JLT_FMA(t30, t38, t25); /* (I1/m*omega_n*gamma3 + I3/m*s*omega3 + v_tau*e)*m*omega_n + m*g*a3*s*s + s*omega_tau*m*R*a3*s*omega_tau */
    const double t40 = t12*t39; /* 1/K*t39 */
    const double t41 = JLT_FNMA(p[19], t40, t35); /* omega_n*(a3/R*v_tau + omega_n*I1/(m*R) + omega_n*e) - 2*a3*1/K*t39 */
    const double t42 = -t40; /* -1/K*t39 */
    out[1] = t42;
    const double t43 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t44 = x[2]*p[42]; /* omega_n*m*R */
    const double t45 = t28*t44; /* (I3/(m*R) + e)*omega_n*m*R */
    const double t46 = t11*t28; /* 1/Theta*(I3/(m*R) + e) */
    const double t47 = x[1]*t29; /* omega_tau*2*m*R*a3*s*omega_tau */
    const double t48 = JLT_FMA(x[4], p[46], t47); /* s*2*m*g*a3 + omega_tau*2*m*R*a3*s*omega_tau */
    const double t49 = JLT_FMA(x[3], t45, t48); /* omega3*(I3/(m*R) + e)*omega_n*m*R + s*2*m*g*a3 + omega_tau*2*m*R*a3*s*omega_tau */
    const double t50 = t12*t49; /* 1/K*t49 */
    const double t51 = -t50; /* -1/K*t49 */
    out[14] = t51;
    const double t52 = p[42]*t43; /* m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t53 = t11*t43; /* 1/Theta*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t54 = t6*t53; /* 2*m^2*R*I3*(I1/m + b*b)*1/Theta*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t55 = t11*t16; /* 1/Theta*s*omega_tau */
    const double t56 = p[41]*t46; /* m*R*I3*1/Theta*(I3/(m*R) + e) */
    const double t57 = JLT_FMA(t14, t56, t26); /* s*omega3*m*R*I3*1/Theta*(I3/(m*R) + e) + omega_n*gamma3 */
    out[16] = t57;
    const double t58 = x[1]*t26; /* omega_tau*omega_n*gamma3 */
    const double t59 = t14*t55; /* s*omega3*1/Theta*s*omega_tau */
    const double t60 = t52*t59; /* m*R*(gamma3*R*(I1 - I3) - a3*I3)*s*omega3*1/Theta*s*omega_tau */
    out[3] = t60;
    const double t61 = x[4]*t52; /* s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t62 = t14*t61; /* s*omega3*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t63 = t11*t62; /* 1/Theta*s*omega3*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[21] = t63;
    const double t64 = t55*t61; /* 1/Theta*s*omega_tau*s*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[23] = t64;
    const double t65 = x[3]*t55; /* omega3*1/Theta*s*omega_tau */
    const double t66 = t54*t65; /* 2*m^2*R*I3*(I1/m + b*b)*1/Theta*(gamma3*R*(I1 - I3) - a3*I3)*omega3*1/Theta*s*omega_tau */
    out[24] = t66;
    const double t67 = p[41]*t65; /* m*R*I3*omega3*1/Theta*s*omega_tau */
    const double t68 = x[4]*t12; /* s*1/K */
    const double t69 = p[43]*t12; /* (-m*R)*1/K */
    const double t70 = t41*t69; /* t41*(-m*R)*1/K */
    out[10] = t70;
    const double t71 = t29*t68; /* 2*m*R*a3*s*omega_tau*s*1/K */
    const double t72 = t45*t68; /* (I3/(m*R) + e)*omega_n*m*R*s*1/K */
    const double t73 = -t71; /* -2*m*R*a3*s*omega_tau*s*1/K */
    out[11] = t73;
    const double t74 = -t72; /* -(I3/(m*R) + e)*omega_n*m*R*s*1/K */
    out[13] = t74;
    const double t75 = p[47]*t0; /* 2*m*R*I3*b */
    const double t76 = JLT_FNMA(t46, t75, p[3]); /* a3 - 1/Theta*(I3/(m*R) + e)*2*m*R*I3*b */
    const double t77 = p[50]*t0; /* 2*m^2*R^2*I3*b */
    const double t78 = t53*t77; /* 1/Theta*(gamma3*R*(I1 - I3) - a3*I3)*2*m^2*R^2*I3*b */
    const double t79 = x[1]*x[3]; /* omega_tau*omega3 */
    const double t80 = JLT_FNMA(p[48], t59, t79); /* omega_tau*omega3 - 2*m*R^2*I1*s*omega3*1/Theta*s*omega_tau */
    const double t81 = t56*t80; /* m*R*I3*1/Theta*(I3/(m*R) + e)*(omega_tau*omega3 - 2*m*R^2*I1*s*omega3*1/Theta*s*omega_tau) */
    out[19] = t81;
    const double t82 = t16*t56; /* s*omega_tau*m*R*I3*1/Theta*(I3/(m*R) + e) */
    out[18] = t82;
    const double t83 = JLT_FMA(x[3], t82, t58); /* omega3*s*omega_tau*m*R*I3*1/Theta*(I3/(m*R) + e) + omega_tau*omega_n*gamma3 */
    out[2] = t83;
    const double t84 = x[0]*t16; /* gamma3*s*omega_tau */
    const double t85 = -t84; /* -gamma3*s*omega_tau */
    out[4] = t85;
    const double t86 = x[1]*x[2]; /* omega_tau*omega_n */
    const double t87 = JLT_FMA(t67, t76, t86); /* m*R*I3*omega3*1/Theta*s*omega_tau*(a3 - 1/Theta*(I3/(m*R) + e)*2*m*R*I3*b) + omega_tau*omega_n */
    out[15] = t87;
    const double t88 = x[1]*x[0]; /* omega_tau*gamma3 */
    out[17] = t88;
    const double t89 = -t88; /* -omega_tau*gamma3 */
    out[29] = t89;
    const double t90 = p[49]*t59; /* m*R^2*(I1 - I3)*s*omega3*1/Theta*s*omega_tau */
    const double t91 = JLT_FNMA(t59, t78, t90); /* m*R^2*(I1 - I3)*s*omega3*1/Theta*s*omega_tau - s*omega3*1/Theta*s*omega_tau*1/Theta*(gamma3*R*(I1 - I3) - a3*I3)*2*m^2*R^2*I3*b */
    out[20] = t91;
    const double t92 = x[4]*x[0]; /* s*gamma3 */
    const double t93 = -t92; /* -s*gamma3 */
    out[26] = t93;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[13], x[0], p[12]); /* K/m = 2*R*a3*gamma3 + R^2 + a3^2 + I1/m */
    const double t2 = x[0] + p[23]; /* b/R = gamma3 + a3/R */
    const double t3 = p[11]*t2; /* I3/I1*b/R */
    const double t4 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t5 = JLT_FMA(t2, t3, t4); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + s*s + I3/(m*R^2) */
    const double t6 = t1*t5; /* K/m*Theta/(m*R^2*I1) */
    const double t7 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t8 = t1*t7; /* K/m*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t9 = JLT_FNMA(t5, p[52], t8); /* K/m*(gamma3*R*(I1 - I3) - a3*I3) - Theta/(m*R^2*I1)*2*R^2*a3*I1 */
    const double t10 = p[16]*x[1]; /* 1/(R*I1)*omega_tau */
    const double t11 = t0*t10; /* s*s*1/(R*I1)*omega_tau */
    const double t12 = t9*t11; /* t9*s*s*1/(R*I1)*omega_tau */
    const double t13 = t12/t6; /* t9*s*s*1/(R*I1)*omega_tau/(K/m*Theta/(m*R^2*I1)) */
    out[0] = t13;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t2 = p[39]*t1; /* m*I3*b */
    const double t3 = JLT_FMA(p[38], t0, p[37]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t1, t2, t3); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t5 = sqrt(t4); /* h = sqrt(Theta) */
    const double t6 = x[3]*t5; /* omega3*h */
    out[2] = t6;
    const double t7 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t8 = t7*t7; /* e*e */
    const double t9 = JLT_FMA(p[54], t0, t8); /* a3^2*s*s + e*e */
    const double t10 = p[36]*x[0]; /* m*g*a3*gamma3 */
    const double t11 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t12 = t9*t11; /* (a3^2*s*s + e*e)*omega_tau*omega_tau */
    const double t13 = JLT_FMA(x[2], x[2], t11); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t14 = x[2]*t1; /* omega_n*b */
    const double t15 = p[1]*x[3]; /* R*omega3 */
    const double t16 = JLT_FMA(x[4], t15, t14); /* v_tau = s*R*omega3 + omega_n*b */
    const double t17 = JLT_FMA(t16, t16, t12); /* v_tau*v_tau + (a3^2*s*s + e*e)*omega_tau*omega_tau */
    const double t18 = x[3]*p[56]; /* omega3*1/2*I3 */
    const double t19 = JLT_FMA(x[3], t18, t10); /* omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t20 = JLT_FMA(p[55], t13, t19); /* 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) + omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t21 = JLT_FMA(p[53], t17, t20); /* 1/2*m*(v_tau*v_tau + (a3^2*s*s + e*e)*omega_tau*omega_tau) + t20 */
    out[0] = t21;
    const double t22 = x[2]*p[57]; /* omega_n*R*I1 */
    const double t23 = x[4]*t22; /* s*omega_n*R*I1 */
    const double t24 = x[3]*p[5]; /* omega3*I3 */
    const double t25 = JLT_FNMA(t1, t24, t23); /* s*omega_n*R*I1 - b*omega3*I3 */
    out[1] = t25;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t1 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t2 = p[23]*t1; /* a3/R*omega_tau*omega_tau */
    const double t3 = t0*t2; /* e*a3/R*omega_tau*omega_tau */
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = x[2]*t4; /* omega_n*b */
    const double t6 = p[1]*x[3]; /* R*omega3 */
    const double t7 = JLT_FMA(x[4], t6, t5); /* v_tau = s*R*omega3 + omega_n*b */
    const double t8 = JLT_FMA(x[2], t7, t3); /* omega_n*v_tau + e*a3/R*omega_tau*omega_tau */
    const double t9 = JLT_FMA(p[42], t8, p[36]); /* m*R*(omega_n*v_tau + e*a3/R*omega_tau*omega_tau) + m*g*a3 */
    out[0] = t9;
    const double t10 = t0*p[0]; /* e*m */
    const double t11 = x[4]*p[58]; /* s*m*a3^2 */
    const double t12 = JLT_FMA(x[4], t11, p[4]); /* s*s*m*a3^2 + I1 */
    const double t13 = JLT_FMA(t0, t10, t12); /* e*e*m + s*s*m*a3^2 + I1 */
    const double t14 = x[1]*t13; /* omega_tau*(e*e*m + s*s*m*a3^2 + I1) */
    out[1] = t14;
    const double t15 = t4*p[0]; /* b*m */
    const double t16 = t7*t15; /* v_tau*b*m */
    const double t17 = JLT_FMA(x[2], p[4], t16); /* omega_n*I1 + v_tau*b*m */
    out[2] = t17;
    const double t18 = x[3]*p[5]; /* omega3*I3 */
    const double t19 = p[42]*x[4]; /* m*R*s */
    const double t20 = JLT_FMA(t7, t19, t18); /* v_tau*m*R*s + omega3*I3 */
    out[3] = t20;
    const double t21 = x[4]*p[59]; /* s*a3^2/R */
    const double t22 = t1*t21; /* omega_tau*omega_tau*s*a3^2/R */
    const double t23 = JLT_FMA(x[3], t7, t22); /* omega3*v_tau + omega_tau*omega_tau*s*a3^2/R */
    const double t24 = p[42]*t23; /* m*R*(omega3*v_tau + omega_tau*omega_tau*s*a3^2/R) */
    out[4] = t24;
    const double t25 = x[3]*p[60]; /* omega3*(-R*I3) */
    out[5] = t25;
    out[6] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    const double t26 = x[4]*p[57]; /* s*R*I1 */
    out[7] = t26;
    const double t27 = t4*p[61]; /* b*(-I3) */
    out[8] = t27;
    const double t28 = x[2]*p[57]; /* omega_n*R*I1 */
    out[9] = t28;
    const double t29 = x[4]*p[38]; /* s*m*R^2*I1 */
    const double t30 = t4*p[39]; /* b*m*I3 */
    const double t31 = JLT_FMA(x[4], t29, p[37]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t32 = JLT_FMA(t4, t30, t31); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t33 = sqrt(t32); /* h = sqrt(Theta) */
    out[13] = t33;
    const double t34 = x[3]/t32; /* omega3/Theta */
    const double t35 = t33*t34; /* h*omega3/Theta */
    const double t36 = t4*p[41]; /* b*m*R*I3 */
    const double t37 = t35*t36; /* h*omega3/Theta*b*m*R*I3 */
    out[10] = t37;
    const double t38 = t29*t35; /* s*m*R^2*I1*h*omega3/Theta */
    out[14] = t38;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
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
    double t53[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t21[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t22[k] = jlt_jet_product(x4, x4, k);
        t23[k] = p[7]*t21[k];
        t24[k] = (k == 0 ? p[6] : 0) + t22[k];
        t25[k] = jlt_jet_product(t21, t23, k) + t24[k];
        t26[k] = jlt_jet_product(x2, t21, k);
        t27[k] = jlt_jet_product(x4, x3, k);
        t28[k] = p[1]*t27[k] + t26[k];
        t29[k] = jlt_jet_quotient(t27[k], t25, t29, k);
        t30[k] = jlt_jet_product(x4, x1, k);
        t31[k] = jlt_jet_product(x4, t30, k);
        t32[k] = p[13]*x0[k] + (k == 0 ? p[12] : 0);
        t33[k] = jlt_jet_quotient((k == 0 ? p[62] : 0), t32, t33, k);
        t34[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t35[k] = jlt_jet_product(t28, t34, k);
        t36[k] = p[28]*t27[k] + t35[k];
        t37[k] = (k == 0 ? p[15] : 0) + t34[k];
        t38[k] = p[14]*t37[k];
        t39[k] = p[63]*t30[k];
        t40[k] = jlt_jet_product(t30, t39, k);
        t41[k] = p[65]*t22[k] + t40[k];
        t42[k] = jlt_jet_product(x0, x2, k);
        t43[k] = p[64]*t36[k] + t42[k];
        t44[k] = jlt_jet_product(x2, t43, k) + t41[k];
        t45[k] = jlt_jet_product(t33, t44, k);
        t46[k] = jlt_jet_product(t29, t38, k) + t42[k];
        t47[k] = jlt_jet_product(x1, t46, k);
        t48[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t49[k] = p[16]*t30[k];
        t50[k] = jlt_jet_product(t48, t49, k);
        t51[k] = jlt_jet_product(t29, t50, k);
        t52[k] = jlt_jet_product(x0, t30, k);
        t53[k] = -t52[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t31[k]/(k + 1);
        next[1] = x1[k + 1] = t45[k]/(k + 1);
        next[2] = x2[k + 1] = t47[k]/(k + 1);
        next[3] = x3[k + 1] = t51[k]/(k + 1);
        next[4] = x4[k + 1] = t53[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[1];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double v_I1 = params[4];
    const double complex v_gamma3 = x[0];
    const double complex v_omega_n = x[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double v_a3 = params[3];
    const double complex v_K = (v_I1 + v_m*(v_R*v_R + v_a3*v_a3 + 2.0*v_R*v_a3*v_gamma3));
    const double v_I3 = params[5];
    const double complex v_omega3 = x[3];
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_v_tau = (v_omega_n*v_b + v_R*v_omega3*v_s);
    const double v_g = params[2];
    out[1] = (v_s)*((-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_K))
        + (-v_I3*v_omega_n*v_omega3/v_K)
        + (-v_m*v_omega_n*v_e*v_v_tau/(v_s*v_K))
        + (-v_m*v_R*v_a3*v_omega_tau*v_omega_tau*v_s/v_K)
        + (-v_m*v_g*v_a3*v_s/v_K));
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    out[2] = (v_s)*((v_gamma3*v_omega_tau*v_omega_n/v_s)
        + (v_m*v_R*v_I3*v_omega_tau*v_omega3*v_e/v_Theta)
        + (v_I3*v_I3*v_omega_tau*v_omega3/v_Theta));
    out[3] = (v_s)*((v_m*v_R*v_omega_tau*v_omega3*v_s*(v_R*v_gamma3*(v_I1 - v_I3) - v_a3*v_I3)/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    out[2] = x[2];
    out[3] = x[3];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[4] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[4]*x[4]; /* s*s */
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
    const double t1 = 2.0*x[4]; /* 2*s */
    out[4] = t1;
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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
    { "Jellett", "" },
    { "Routh", "" },
};

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_routh_sphere_general_in_regular = {
    .model = "routh_sphere",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Sphere with displaced centre of mass rolling without slipping, reduced system",
    .source = "E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243",
    .sha256 = "3411ed6d53d99c328220ac4c0d992bf489a81f74d3bcee4f47f68fdd4a704bc2",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_routh_sphere, .family = jlt_family_routh_sphere, .claims = jlt_claims_routh_sphere,
    .scales = 1,
    .state_count = 5, .param_count = 6, .prepared_count = 66,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 21, 11, 1, 0, 0, 9, 10 }, { 18, 64, 0, 8, 0, 0, 12, 8 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, v_tau = R*s*omega3 + b*omega_n, s*omega3*(I3/I1) + gamma3*omega_n, (I1/m)*(s*omega3*(I3/I1) + gamma3*omega_n) + e*v_tau, a part of d(omega_tau)/dtau, K/m = gamma3*(2*R*a3) + R^2 + a3^2 + I1/m, e + I3/(m*R), a part of d(omega_n)/dtau, gamma3*(R*(I1 - I3)) - (a3*I3)" },
    .jacobian = { jacobian, 25, { 8, 48, 23, 1, 0, 0, 12, 15 }, { 50, 259, 0, 36, 0, 0, 16, 8 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, K/m = gamma3*(2*R*a3) + R^2 + a3^2 + I1/m, v_tau = R*s*omega3 + omega_n*b, 1/(K/m)*omega_n*b + 1/(K/m)*v_tau, omega_n - (2*a3)*1/(K/m)*v_tau, e = a3*gamma3 + R, a part of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(omega_n), I3/(m*R) + e, gamma3*(R*(I1 - I3)) - (a3*I3), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega3)/dtau)/d(s), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(s), d(d(omega3)/dtau)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 58, 25, 1, 0, 0, 10, 17 }, { 60, 303, 0, 44, 0, 0, 16, 10 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, gamma3*(2*R*a3) + R^2 + a3^2, K = m*(gamma3*(2*R*a3) + R^2 + a3^2) + I1, v_tau = R*s*omega3 + omega_n*b, e = a3*gamma3 + R, (I3/m)*s*omega3 + v_tau*e, I3/(m*R) + e, (I1/m)*omega_n*gamma3 + (I3/m)*s*omega3 + v_tau*e, b*omega_n*e + (2*I1/m)*omega_n*gamma3 + (I3/m)*s*omega3 + v_tau*e, (a3/R)*v_tau + omega_n*(I1/(m*R)) + omega_n*e, a part of d(omega_tau)/dtau and of d(d(omega_tau)/dtau)/d(gamma3), a part of d(d(omega_tau)/dtau)/d(gamma3), gamma3*(R*(I1 - I3)) - (a3*I3), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_n)/dtau)/d(omega_tau), a3 - 1/Theta*(I3/(m*R) + e)*(2*m*R*I3)*b, omega_tau*omega3 - (2*m*R^2*I1)*s*omega3*1/Theta*s*omega_tau, d(omega_n)/dtau, d(d(omega_n)/dtau)/d(gamma3), d(d(omega3)/dtau)/d(gamma3)" },
    .divergence = { divergence, 1, { 2, 7, 4, 1, 0, 0, 6, 6 }, { 9, 30, 0, 2, 0, 0, 9, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in K/m = (2*R*a3)*gamma3 + R^2 + a3^2 + I1/m, b/R = gamma3 + a3/R, gamma3*(R*(I1 - I3)) - (a3*I3), K/m*(gamma3*(R*(I1 - I3)) - (a3*I3)) - Theta/(m*R^2*I1)*(2*R^2*a3*I1)" },
    .integral_values = { integral_values, 3, { 0, 13, 12, 0, 1, 0, 6, 7 }, { 12, 41, 0, 0, 1, 0, 12, 6 },
        "takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, v_tau = s*R*omega3 + omega_n*b, E, Jellett" },
    .integral_gradients = { integral_gradients, 15, { 0, 25, 12, 1, 1, 0, 6, 7 }, { 14, 60, 0, 2, 1, 0, 8, 8 },
        "divides by h: values and rounding errors grow without bound where it vanishes; takes h = sqrt(Theta): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in e = a3*gamma3 + R, b = R*gamma3 + a3, v_tau = s*R*omega3 + omega_n*b, omega_n*v_tau + e*(a3/R)*omega_tau*omega_tau, d(E)/d(gamma3), d(E)/d(omega_n), d(E)/d(omega3), omega3*v_tau + omega_tau*omega_tau*s*(a3^2/R)" },
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
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_routh_sphere_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_routh_sphere_general_in_regular) },
#endif
};
