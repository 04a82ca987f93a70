/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23   12    1    0    0     10   11   (85)
 *  jacobian            9   54   24    1    0    0     14   18   (397)
 *  rhs_jacobian        8   57   30    1    0    0     13   25   (454)
 *  divergence          2   13    7    1    0    0      9    9   (53)
 *  integral_values     0    9    9    1    0    0      7    7   (40)
 *  integral_gradients  0   16   13    1    0    0      7    9   (82)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          1    1    1    1    0    0      3    3   (8)
 *
 *  Accuracy
 *    divides by b: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    digits are lost where terms nearly cancel in b/R = a3/R + gamma3, G_level/(R*I1) - s*omega_n,
 *      e/R = (a3/R)*gamma3 + 1, V = e/R*omega_tau*R + v_nu, 1/(b/R)*(G_level/(R*I1) - s*omega_n) - 1/(b/R)*s*omega_n,
 *      I3/(m*R^2) + e/R, a3/R - 1/(b/R)*(I3/(m*R^2) + e/R), a part of d(d(omega_n)/dtau)/d(gamma3),
 *      s*omega_tau*(m*a3^2/I1)*s*omega_tau - omega_n*omega_n, a part of d(d(omega_tau)/dtau)/d(s), d(v_nu)/dtau,
 *      d(d(v_nu)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n), a part of d(d(omega_n)/dtau)/d(gamma3),
 *      a part of d(omega_n)/dtau and of d(d(omega_n)/dtau)/d(s), d(omega_n)/dtau, d(d(v_nu)/dtau)/d(omega_n),
 *      a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(gamma3),
 *      d(d(omega_tau)/dtau)/d(omega_n), omega_n - (a3*I3/(R*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1)),
 *      d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(s), d(omega_tau)/dtau
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_claim jlt_claims_spherical_top[];
extern const jlt_descriptor *const jlt_family_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_omega3;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_omega3_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[4]; /* R*R*I1 */
    const double t2 = t1/params[5]; /* R*R*I1/I3 */
    out[7] = t2;
    const double t3 = params[1]*params[4]; /* R*I1 */
    const double t4 = params[6]/t3; /* G_level/(R*I1) */
    out[8] = t4;
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[30] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[9] = t7;
    const double t8 = t0*params[0]; /* R*R*m */
    const double t9 = params[5]/t8; /* I3/(R*R*m) */
    out[10] = t9;
    const double t10 = params[5]/t1; /* I3/(R*R*I1) */
    out[11] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[3]*t11; /* a3*m*g */
    out[36] = t12;
    const double t13 = t12/params[4]; /* a3*m*g/I1 */
    out[12] = t13;
    const double t14 = params[1]*params[0]; /* R*m */
    out[37] = t14;
    const double t15 = params[5]/t14; /* I3/(R*m) */
    out[13] = t15;
    const double t16 = t3/params[5]; /* R*I1/I3 */
    out[14] = t16;
    const double t17 = params[5]/params[4]; /* I3/I1 */
    out[15] = t17;
    const double t18 = params[3]/params[1]; /* a3/R */
    out[16] = t18;
    const double t19 = params[1]*2.0; /* R*2 */
    out[17] = t19;
    const double t20 = -t16; /* -R*I1/I3 */
    out[18] = t20;
    const double t21 = params[0]*2.0; /* m*2 */
    const double t22 = t5*t21; /* a3*a3*m*2 */
    out[29] = t22;
    const double t23 = t22/params[4]; /* a3*a3*m*2/I1 */
    out[19] = t23;
    const double t24 = params[0]*params[3]; /* m*a3 */
    out[20] = t24;
    const double t25 = params[2]*2.0; /* g*2 */
    const double t26 = t25/params[4]; /* g*2/I1 */
    out[21] = t26;
    const double t27 = params[3]*2.0; /* a3*2 */
    const double t28 = t27/params[4]; /* a3*2/I1 */
    out[22] = t28;
    const double t29 = params[5]/t3; /* I3/(R*I1) */
    out[23] = t29;
    const double t30 = params[5]*2.0; /* I3*2 */
    const double t31 = t30/params[4]; /* I3*2/I1 */
    out[24] = t31;
    const double t32 = params[5]*params[3]; /* I3*a3 */
    const double t33 = t32/t3; /* I3*a3/(R*I1) */
    out[25] = t33;
    const double t34 = params[4]*params[4]; /* I1*I1 */
    const double t35 = params[1]*t34; /* R*I1*I1 */
    const double t36 = params[5]*params[5]; /* I3*I3 */
    const double t37 = 2.0*t36; /* 2*I3*I3 */
    const double t38 = t37/t35; /* 2*I3*I3/(R*I1*I1) */
    out[26] = t38;
    const double t39 = -t29; /* -I3/(R*I1) */
    out[27] = t39;
    const double t40 = params[2]*t21; /* g*m*2 */
    const double t41 = params[3]*t40; /* a3*g*m*2 */
    const double t42 = t41/params[4]; /* a3*g*m*2/I1 */
    out[28] = t42;
    const double t43 = params[0]/2.0; /* m/2 */
    out[31] = t43;
    const double t44 = params[3]*t25; /* a3*g*2 */
    out[32] = t44;
    const double t45 = 1.0/params[0]; /* 1/m */
    out[33] = t45;
    const double t46 = params[4]/params[0]; /* I1/m */
    out[34] = t46;
    const double t47 = t0*t34; /* R*R*I1*I1 */
    const double t48 = params[5]*params[0]; /* I3*m */
    const double t49 = t47/t48; /* R*R*I1*I1/(I3*m) */
    out[35] = t49;
    const double t50 = params[1]*t0; /* R*R*R */
    const double t51 = t34*t50; /* I1*I1*R*R*R */
    const double t52 = t51/params[5]; /* I1*I1*R*R*R/I3 */
    out[38] = t52;
    const double t53 = t47/params[5]; /* R*R*I1*I1/I3 */
    out[39] = t53;
    const double t54 = params[4]/params[5]; /* I1/I3 */
    const double t55 = -t54; /* -I1/I3 */
    out[40] = t55;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = JLT_FMA(p[9], t0, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t3 = p[11]*t1; /* I3/(R^2*I1)*b */
    const double t4 = p[10] + t0; /* I3/(m*R^2) + s*s */
    const double t5 = JLT_FMA(t1, t3, t4); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s*s */
    const double t6 = x[3]*t3; /* omega_n*I3/(R^2*I1)*b */
    const double t7 = t1*t2; /* b*D/I1 */
    const double t8 = t5*t7; /* Theta/(m*R^2*I1)*b*D/I1 */
    const double t9 = 1.0/t8; /* 1/(Theta/(m*R^2*I1)*b*D/I1) */
    const double t10 = t5*t9; /* 1/(b*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*b*D/I1) */
    const double t11 = t7*t9; /* b*D/I1*1/(Theta/(m*R^2*I1)*b*D/I1) */
    const double t12 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t13 = x[4]*t12; /* s*(G_level/(R*I1) - s*omega_n) */
    const double t14 = t2*t13; /* D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t15 = t10*t14; /* 1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t16 = t1*t10; /* b*1/(b*(D/I1)) */
    const double t17 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t18 = x[2]*t0; /* omega_tau*s*s */
    out[0] = t18;
    const double t19 = p[9]*t17; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t20 = t18*t19; /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t21 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t22 = x[3]*x[3]; /* omega_n*omega_n */
    const double t23 = JLT_FNMA(x[0], t22, t20); /* omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 - gamma3*omega_n*omega_n */
    const double t24 = JLT_FNMA(p[12], t0, t23); /* t23 - m*g*a3/I1*s*s */
    const double t25 = t1*t22; /* b*omega_n*omega_n */
    const double t26 = p[13] + t21; /* I3/(m*R) + e */
    const double t27 = x[2]*t26; /* omega_tau*(I3/(m*R) + e) */
    const double t28 = t15*t27; /* 1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n)*omega_tau*(I3/(m*R) + e) */
    const double t29 = x[3]*t15; /* omega_n*1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n) */
    const double t30 = JLT_FNMA(p[7], t29, t25); /* b*omega_n*omega_n - R^2*I1/I3*omega_n*1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n) */
    out[1] = t30;
    const double t31 = JLT_FMA(p[1], t29, t24); /* R*omega_n*1/(b*(D/I1))*D/I1*s*(G_level/(R*I1) - s*omega_n) + t23 - m*g*a3/I1*s*s */
    const double t32 = t16*t31; /* b*1/(b*(D/I1))*t31 */
    out[2] = t32;
    const double t33 = JLT_FMA(x[2], t21, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = JLT_FMA(t6, t33, t28); /* omega_n*I3/(R^2*I1)*b*V + t28 */
    const double t35 = x[3]*t17; /* omega_n*omega_tau*gamma3 */
    const double t36 = JLT_FNMA(t11, t34, t35); /* omega_n*omega_tau*gamma3 - b*D/I1*1/(Theta/(m*R^2*I1)*b*D/I1)*(omega_n*I3/(R^2*I1)*b*V + t28) */
    out[3] = t36;
    const double t37 = x[4]*t17; /* s*omega_tau*gamma3 */
    const double t38 = -t37; /* -s*omega_tau*gamma3 */
    out[4] = t38;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[21] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[2] = t0;
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[4] = t2;
    const double t3 = x[3]*x[3]; /* omega_n*omega_n */
    const double t4 = p[1]*t3; /* R*omega_n*omega_n */
    const double t5 = x[4]*x[3]; /* s*omega_n */
    const double t6 = p[8] - t5; /* G_level/(R*I1) - s*omega_n */
    const double t7 = JLT_FMA(t0, p[9], 1.0); /* D/I1 = s*s*m*a3^2/I1 + 1 */
    const double t8 = p[16] + x[0]; /* b/R = a3/R + gamma3 */
    const double t9 = p[15]*t8; /* I3/I1*b/R */
    const double t10 = t0 + p[10]; /* s*s + I3/(m*R^2) */
    const double t11 = JLT_FMA(t8, t9, t10); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + s*s + I3/(m*R^2) */
    const double t12 = t7*t8; /* D/I1*b/R */
    const double t13 = t11*t12; /* Theta/(m*R^2*I1)*D/I1*b/R */
    const double t14 = 1.0/t13; /* 1/(Theta/(m*R^2*I1)*D/I1*b/R) */
    const double t15 = t11*t14; /* 1/((b/R)*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*b/R) */
    const double t16 = t7*t15; /* 1/(b/R) = D/I1*1/((b/R)*(D/I1)) */
    const double t17 = x[4]*t16; /* s*1/(b/R) */
    const double t18 = t6*t17; /* (G_level/(R*I1) - s*omega_n)*s*1/(b/R) */
    const double t19 = x[3]*t18; /* omega_n*(G_level/(R*I1) - s*omega_n)*s*1/(b/R) */
    const double t20 = t16*t19; /* 1/(b/R)*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/(b/R) */
    const double t21 = JLT_FMA(p[14], t20, t4); /* R*I1/I3*1/(b/R)*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/(b/R) + R*omega_n*omega_n */
    out[5] = t21;
    const double t22 = x[3]*p[17]; /* omega_n*2*R */
    const double t23 = t8*t22; /* b/R*omega_n*2*R */
    const double t24 = t6 - t5; /* G_level/(R*I1) - s*omega_n - s*omega_n */
    const double t25 = t17*t24; /* s*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t26 = JLT_FNMA(p[14], t25, t23); /* b/R*omega_n*2*R - R*I1/I3*s*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[8] = t26;
    const double t27 = t16*t24; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t28 = x[3]*t27; /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t29 = p[18]*t28; /* (-R*I1/I3)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[9] = t29;
    const double t30 = t8*t15; /* 1/(D/I1) = b/R*1/((b/R)*(D/I1)) */
    const double t31 = t1*t30; /* s*omega_tau*1/(D/I1) */
    const double t32 = t1*p[9]; /* s*omega_tau*m*a3^2/I1 */
    const double t33 = t31*t32; /* s*omega_tau*1/(D/I1)*s*omega_tau*m*a3^2/I1 */
    const double t34 = t3 + t20; /* omega_n*omega_n + 1/(b/R)*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/(b/R) */
    const double t35 = JLT_FNMA(t30, t34, t33); /* s*omega_tau*1/(D/I1)*s*omega_tau*m*a3^2/I1 - 1/(D/I1)*t34 */
    out[10] = t35;
    const double t36 = x[4]*x[0]; /* s*gamma3 */
    const double t37 = p[19]*t36; /* 2*m*a3^2/I1*s*gamma3 */
    const double t38 = t31*t37; /* s*omega_tau*1/(D/I1)*2*m*a3^2/I1*s*gamma3 */
    out[12] = t38;
    const double t39 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t40 = JLT_FNMA(2.0, t39, t25); /* s*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) - 2*omega_n*gamma3 */
    const double t41 = t30*t40; /* 1/(D/I1)*t40 */
    out[13] = t41;
    const double t42 = JLT_FMA(x[2], x[2], t3); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t43 = JLT_FMS(x[0], t42, t19); /* gamma3*(omega_tau*omega_tau + omega_n*omega_n) - omega_n*(G_level/(R*I1) - s*omega_n)*s*1/(b/R) */
    const double t44 = JLT_FNMA(p[22], t43, p[21]); /* 2*g/I1 - 2*a3/I1*t43 */
    const double t45 = x[4]*p[20]; /* s*m*a3 */
    const double t46 = t30*t45; /* 1/(D/I1)*s*m*a3 */
    const double t47 = JLT_FNMA(t44, t46, t28); /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) - (2*g/I1 - 2*a3/I1*t43)*1/(D/I1)*s*m*a3 */
    const double t48 = t30*t47; /* 1/(D/I1)*t47 */
    out[14] = t48;
    const double t49 = JLT_FMA(p[16], x[0], 1.0); /* e/R = a3/R*gamma3 + 1 */
    const double t50 = x[2]*p[1]; /* omega_tau*R */
    const double t51 = JLT_FMA(t49, t50, x[1]); /* V = e/R*omega_tau*R + v_nu */
    const double t52 = p[23]*t51; /* I3/(R*I1)*V */
    const double t53 = x[3]*t52; /* omega_n*I3/(R*I1)*V */
    const double t54 = t1*t6; /* s*omega_tau*(G_level/(R*I1) - s*omega_n) */
    const double t55 = p[10] + t49; /* I3/(m*R^2) + e/R */
    const double t56 = JLT_FNMA(t16, t55, p[16]); /* a3/R - 1/(b/R)*(I3/(m*R^2) + e/R) */
    const double t57 = t16*t56; /* 1/(b/R)*(a3/R - 1/(b/R)*(I3/(m*R^2) + e/R)) */
    const double t58 = t12*t14; /* 1/(Theta/(m*R^2*I1)) = D/I1*b/R*1/(Theta/(m*R^2*I1)*D/I1*b/R) */
    const double t59 = t55*t58; /* (I3/(m*R^2) + e/R)*1/(Theta/(m*R^2*I1)) */
    const double t60 = JLT_FNMA(p[24], t59, t57); /* 1/(b/R)*(a3/R - 1/(b/R)*(I3/(m*R^2) + e/R)) - 2*I3/I1*(I3/(m*R^2) + e/R)*1/(Theta/(m*R^2*I1)) */
    const double t61 = JLT_FMA(t54, t60, t53); /* s*omega_tau*(G_level/(R*I1) - s*omega_n)*t60 + omega_n*I3/(R*I1)*V */
    const double t62 = t8*t58; /* b/R*1/(Theta/(m*R^2*I1)) */
    const double t63 = x[3]*t62; /* omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t64 = JLT_FNMA(p[25], t63, x[3]); /* omega_n - a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t65 = x[2]*t64; /* omega_tau*(omega_n - a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1))) */
    const double t66 = t51*p[26]; /* V*2*I3^2/(R*I1^2) */
    const double t67 = t62*t66; /* b/R*1/(Theta/(m*R^2*I1))*V*2*I3^2/(R*I1^2) */
    const double t68 = JLT_FMA(t63, t67, t65); /* omega_n*b/R*1/(Theta/(m*R^2*I1))*b/R*1/(Theta/(m*R^2*I1))*V*2*I3^2/(R*I1^2) + t65 */
    const double t69 = JLT_FNMA(t58, t61, t68); /* t68 - 1/(Theta/(m*R^2*I1))*t61 */
    out[15] = t69;
    const double t70 = t63*p[27]; /* omega_n*b/R*1/(Theta/(m*R^2*I1))*(-I3/(R*I1)) */
    out[16] = t70;
    const double t71 = p[15]*t49; /* I3/I1*e/R */
    const double t72 = JLT_FNMA(t63, t71, t39); /* omega_n*gamma3 - omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/I1*e/R */
    const double t73 = JLT_FNMA(t18, t59, t72); /* omega_n*gamma3 - omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/I1*e/R - (G_level/(R*I1) - s*omega_n)*s*1/(b/R)*(I3/(m*R^2) + e/R)*1/(Theta/(m*R^2*I1)) */
    out[17] = t73;
    const double t74 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t75 = t17*t59; /* s*1/(b/R)*(I3/(m*R^2) + e/R)*1/(Theta/(m*R^2*I1)) */
    const double t76 = JLT_FNMA(t52, t62, t74); /* omega_tau*gamma3 - I3/(R*I1)*V*b/R*1/(Theta/(m*R^2*I1)) */
    const double t77 = JLT_FMA(t1, t75, t76); /* s*omega_tau*s*1/(b/R)*(I3/(m*R^2) + e/R)*1/(Theta/(m*R^2*I1)) + omega_tau*gamma3 - I3/(R*I1)*V*b/R*1/(Theta/(m*R^2*I1)) */
    out[18] = t77;
    const double t78 = x[2]*t59; /* omega_tau*(I3/(m*R^2) + e/R)*1/(Theta/(m*R^2*I1)) */
    const double t79 = t27*t78; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n)*omega_tau*(I3/(m*R^2) + e/R)*1/(Theta/(m*R^2*I1)) */
    const double t80 = x[4]*t52; /* s*I3/(R*I1)*V */
    const double t81 = t63*t80; /* omega_n*b/R*1/(Theta/(m*R^2*I1))*s*I3/(R*I1)*V */
    const double t82 = JLT_FMA(t54, t75, t81); /* s*omega_tau*(G_level/(R*I1) - s*omega_n)*s*1/(b/R)*(I3/(m*R^2) + e/R)*1/(Theta/(m*R^2*I1)) + omega_n*b/R*1/(Theta/(m*R^2*I1))*s*I3/(R*I1)*V */
    const double t83 = 2.0*t58; /* 2*1/(Theta/(m*R^2*I1)) */
    const double t84 = JLT_FMS(t82, t83, t79); /* t82*2*1/(Theta/(m*R^2*I1)) - t79 */
    out[19] = t84;
    const double t85 = -t1; /* -s*omega_tau */
    out[20] = t85;
    const double t86 = -t36; /* -s*gamma3 */
    out[22] = t86;
    const double t87 = -t74; /* -omega_tau*gamma3 */
    out[24] = t87;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t0 = p[16] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = x[4]*x[4]; /* s*s */
    out[7] = t1;
    const double t2 = JLT_FMA(p[9], t1, 1.0); /* D/I1 = m*a3^2/I1*s*s + 1 */
    const double t3 = p[10] + t1; /* I3/(m*R^2) + s*s */
    const double t4 = p[15]*t0; /* I3/I1*b/R */
    const double t5 = JLT_FMA(t0, t4, t3); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + I3/(m*R^2) + s*s */
    const double t6 = t0*t2; /* b/R*D/I1 */
    const double t7 = t5*t6; /* Theta/(m*R^2*I1)*b/R*D/I1 */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*b/R*D/I1) */
    const double t9 = t5*t8; /* 1/((b/R)*(D/I1)) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*b/R*D/I1) */
    const double t10 = t6*t8; /* 1/(Theta/(m*R^2*I1)) = b/R*D/I1*1/(Theta/(m*R^2*I1)*b/R*D/I1) */
    const double t11 = t2*t9; /* 1/(b/R) = D/I1*1/((b/R)*(D/I1)) */
    const double t12 = t0*t9; /* 1/(D/I1) = b/R*1/((b/R)*(D/I1)) */
    const double t13 = x[4]*x[3]; /* s*omega_n */
    const double t14 = p[8] - t13; /* G_level/(R*I1) - s*omega_n */
    const double t15 = JLT_FMA(p[16], x[0], 1.0); /* e/R = a3/R*gamma3 + 1 */
    const double t16 = x[2]*p[1]; /* omega_tau*R */
    const double t17 = JLT_FMA(t15, t16, x[1]); /* V = e/R*omega_tau*R + v_nu */
    const double t18 = t11*t14; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t19 = JLT_FNMA(t11, t13, t18); /* 1/(b/R)*(G_level/(R*I1) - s*omega_n) - 1/(b/R)*s*omega_n */
    const double t20 = p[10] + t15; /* I3/(m*R^2) + e/R */
    const double t21 = p[15]*t15; /* I3/I1*e/R */
    const double t22 = x[4]*x[2]; /* s*omega_tau */
    const double t23 = t14*t22; /* (G_level/(R*I1) - s*omega_n)*s*omega_tau */
    const double t24 = 2.0*t22; /* 2*s*omega_tau */
    out[9] = t24;
    const double t25 = -t22; /* -s*omega_tau */
    out[25] = t25;
    const double t26 = x[3]*x[3]; /* omega_n*omega_n */
    const double t27 = x[3]*t18; /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t28 = x[4]*t12; /* s*1/(D/I1) */
    const double t29 = t0*t10; /* b/R*1/(Theta/(m*R^2*I1)) */
    const double t30 = p[26]*t17; /* 2*I3^2/(R*I1^2)*V */
    const double t31 = p[23]*t17; /* I3/(R*I1)*V */
    const double t32 = t29*t30; /* b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2)*V */
    const double t33 = JLT_FNMA(t11, t20, p[16]); /* a3/R - 1/(b/R)*(I3/(m*R^2) + e/R) */
    const double t34 = t10*t20; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t35 = t11*t33; /* 1/(b/R)*(a3/R - 1/(b/R)*(I3/(m*R^2) + e/R)) */
    const double t36 = t18*t34; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t37 = JLT_FNMA(p[24], t34, t35); /* 1/(b/R)*(a3/R - 1/(b/R)*(I3/(m*R^2) + e/R)) - 2*I3/I1*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t38 = p[9]*t22; /* m*a3^2/I1*s*omega_tau */
    const double t39 = JLT_FMS(t22, t38, t26); /* s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n */
    const double t40 = x[0]*t12; /* gamma3*1/(D/I1) */
    const double t41 = t27*t28; /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(D/I1) */
    const double t42 = x[3]*t29; /* omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t43 = t32*t42; /* b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2)*V*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t44 = p[27]*t42; /* (-I3/(R*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    out[21] = t44;
    const double t45 = JLT_FMA(x[2], x[2], t26); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t46 = JLT_FMS(t40, t45, t41); /* gamma3*1/(D/I1)*(omega_tau*omega_tau + omega_n*omega_n) - omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(D/I1) */
    const double t47 = p[1]*t26; /* R*omega_n*omega_n */
    const double t48 = x[4]*t22; /* s*s*omega_tau */
    out[0] = t48;
    const double t49 = t34*t48; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R)*s*s*omega_tau */
    const double t50 = x[2]*t34; /* omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t51 = t19*t50; /* (1/(b/R)*(G_level/(R*I1) - s*omega_n) - 1/(b/R)*s*omega_n)*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t52 = x[4]*p[14]; /* s*R*I1/I3 */
    const double t53 = t27*t52; /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*R*I1/I3 */
    const double t54 = JLT_FMS(t0, t47, t53); /* b/R*R*omega_n*omega_n - omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*R*I1/I3 */
    out[1] = t54;
    const double t55 = JLT_FMA(t11, t53, t47); /* 1/(b/R)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*R*I1/I3 + R*omega_n*omega_n */
    out[10] = t55;
    const double t56 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t57 = JLT_FNMA(t29, t31, t56); /* omega_tau*gamma3 - b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    const double t58 = JLT_FMA(t11, t49, t57); /* 1/(b/R)*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R)*s*s*omega_tau + omega_tau*gamma3 - b/R*1/(Theta/(m*R^2*I1))*I3/(R*I1)*V */
    out[23] = t58;
    const double t59 = -t56; /* -omega_tau*gamma3 */
    out[29] = t59;
    const double t60 = t31*t42; /* I3/(R*I1)*V*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t61 = x[3]*t31; /* omega_n*I3/(R*I1)*V */
    const double t62 = JLT_FMA(t23, t37, t61); /* (G_level/(R*I1) - s*omega_n)*s*omega_tau*t37 + omega_n*I3/(R*I1)*V */
    const double t63 = JLT_FMA(t22, t36, t60); /* s*omega_tau*t36 + I3/(R*I1)*V*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t64 = JLT_FMS(x[3], t56, t63); /* omega_n*omega_tau*gamma3 - t63 */
    out[3] = t64;
    const double t65 = x[0]*t22; /* gamma3*s*omega_tau */
    const double t66 = -t65; /* -gamma3*s*omega_tau */
    out[4] = t66;
    const double t67 = x[3]*p[17]; /* omega_n*2*R */
    const double t68 = t0*t67; /* b/R*omega_n*2*R */
    const double t69 = JLT_FNMA(t19, t52, t68); /* b/R*omega_n*2*R - (1/(b/R)*(G_level/(R*I1) - s*omega_n) - 1/(b/R)*s*omega_n)*s*R*I1/I3 */
    out[13] = t69;
    const double t70 = x[3]*t19; /* omega_n*(1/(b/R)*(G_level/(R*I1) - s*omega_n) - 1/(b/R)*s*omega_n) */
    const double t71 = p[18]*t70; /* (-R*I1/I3)*t70 */
    out[14] = t71;
    const double t72 = JLT_FMS(p[28], t28, t70); /* 2*m*g*a3/I1*s*1/(D/I1) - t70 */
    const double t73 = p[19]*t28; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t74 = t65*t73; /* gamma3*s*omega_tau*2*m*a3^2/I1*s*1/(D/I1) */
    out[17] = t74;
    const double t75 = t46*t73; /* t46*2*m*a3^2/I1*s*1/(D/I1) */
    const double t76 = JLT_FNMA(t12, t72, t75); /* t46*2*m*a3^2/I1*s*1/(D/I1) - 1/(D/I1)*(2*m*g*a3/I1*s*1/(D/I1) - t70) */
    out[19] = t76;
    const double t77 = t12*t39; /* 1/(D/I1)*(s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n) */
    const double t78 = JLT_FNMA(t11, t41, t77); /* t77 - 1/(b/R)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(D/I1) */
    out[15] = t78;
    const double t79 = JLT_FMA(t39, t40, t41); /* (s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n)*gamma3*1/(D/I1) + omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*1/(D/I1) */
    const double t80 = x[3]*2.0; /* omega_n*2 */
    const double t81 = t40*t80; /* gamma3*1/(D/I1)*omega_n*2 */
    const double t82 = JLT_FMS(t19, t28, t81); /* (1/(b/R)*(G_level/(R*I1) - s*omega_n) - 1/(b/R)*s*omega_n)*s*1/(D/I1) - gamma3*1/(D/I1)*omega_n*2 */
    out[18] = t82;
    const double t83 = JLT_FNMA(p[25], t42, x[3]); /* omega_n - a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t84 = JLT_FMA(x[2], t83, t43); /* omega_tau*(omega_n - a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1))) + t43 */
    const double t85 = JLT_FNMA(t10, t62, t84); /* t84 - 1/(Theta/(m*R^2*I1))*t62 */
    out[20] = t85;
    const double t86 = x[0]*x[3]; /* gamma3*omega_n */
    const double t87 = JLT_FNMA(t21, t42, t86); /* gamma3*omega_n - I3/I1*e/R*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t88 = JLT_FNMA(x[4], t36, t87); /* gamma3*omega_n - I3/I1*e/R*omega_n*b/R*1/(Theta/(m*R^2*I1)) - s*t36 */
    out[22] = t88;
    const double t89 = x[4]*2.0; /* s*2 */
    const double t90 = t10*t89; /* 1/(Theta/(m*R^2*I1))*s*2 */
    const double t91 = JLT_FMS(t63, t90, t51); /* t63*1/(Theta/(m*R^2*I1))*s*2 - t51 */
    out[24] = t91;
    const double t92 = x[4]*p[12]; /* s*m*g*a3/I1 */
    const double t93 = JLT_FNMA(t28, t92, t79); /* t79 - s*1/(D/I1)*s*m*g*a3/I1 */
    out[2] = t93;
    const double t94 = x[4]*x[0]; /* s*gamma3 */
    const double t95 = -t94; /* -s*gamma3 */
    out[27] = t95;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t2 = t1*p[11]; /* b*I3/(R^2*I1) */
    const double t3 = t0 + p[10]; /* s*s + I3/(m*R^2) */
    const double t4 = JLT_FMA(t1, t2, t3); /* Theta/(m*R^2*I1) = b*b*I3/(R^2*I1) + s*s + I3/(m*R^2) */
    const double t5 = JLT_FMA(t0, p[30], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t1*t5; /* b*D */
    const double t7 = t4*t6; /* Theta/(m*R^2*I1)*b*D */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2*I1)*b*D) */
    const double t9 = p[29]*x[0]; /* 2*m*a3^2*gamma3 */
    const double t10 = t1*t9; /* b*2*m*a3^2*gamma3 */
    const double t11 = t4*t10; /* Theta/(m*R^2*I1)*b*2*m*a3^2*gamma3 */
    const double t12 = t8*t11; /* 1/(Theta/(m*R^2*I1)*b*D)*Theta/(m*R^2*I1)*b*2*m*a3^2*gamma3 */
    const double t13 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t14 = p[13] + t13; /* I3/(m*R) + e */
    const double t15 = t5*t14; /* D*(I3/(m*R) + e) */
    const double t16 = JLT_FMA(t8, t15, t12); /* 1/(Theta/(m*R^2*I1)*b*D)*D*(I3/(m*R) + e) + 1/(Theta/(m*R^2*I1)*b*D)*Theta/(m*R^2*I1)*b*2*m*a3^2*gamma3 */
    const double t17 = x[2]*t0; /* omega_tau*s*s */
    const double t18 = t16*t17; /* t16*omega_tau*s*s */
    const double t19 = JLT_FMA(x[2], t13, x[1]); /* V = omega_tau*e + v_nu */
    const double t20 = t2*t19; /* b*I3/(R^2*I1)*V */
    const double t21 = t6*t20; /* b*D*b*I3/(R^2*I1)*V */
    const double t22 = JLT_FNMA(t8, t21, t18); /* t16*omega_tau*s*s - 1/(Theta/(m*R^2*I1)*b*D)*b*D*b*I3/(R^2*I1)*V */
    out[0] = t22;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t1 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t2 = t1/t0; /* (G_level/(R*I1) - s*omega_n)/b */
    const double t3 = x[3]*t0; /* omega_n*b */
    const double t4 = p[32]*x[0]; /* 2*g*a3*gamma3 */
    const double t5 = JLT_FMA(x[1], x[1], t4); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t6 = p[30]*x[4]; /* m*a3^2*s */
    const double t7 = JLT_FMA(x[4], t6, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t8 = p[33]*x[2]; /* 1/m*omega_tau */
    const double t9 = x[2]*t8; /* omega_tau*1/m*omega_tau */
    const double t10 = p[34]*x[3]; /* I1/m*omega_n */
    const double t11 = JLT_FMA(x[3], t10, t5); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(t7, t9, t11); /* D*omega_tau*1/m*omega_tau + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[35]*t2; /* R^2*I1^2/(m*I3)*(G_level/(R*I1) - s*omega_n)/b */
    const double t14 = JLT_FMA(t2, t13, t12); /* (G_level/(R*I1) - s*omega_n)/b*R^2*I1^2/(m*I3)*(G_level/(R*I1) - s*omega_n)/b + t12 */
    const double t15 = x[4]*p[7]; /* s*R^2*I1/I3 */
    const double t16 = JLT_FNMA(t2, t15, t3); /* v_tau = omega_n*b - (G_level/(R*I1) - s*omega_n)/b*s*R^2*I1/I3 */
    const double t17 = JLT_FMA(t16, t16, t14); /* energy/(1/2*m) = v_tau*v_tau + t14 */
    const double t18 = p[31]*t17; /* 1/2*m*energy/(1/2*m) */
    out[0] = t18;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t2 = 1.0/t1; /* 1/b */
    const double t3 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t4 = t2*t3; /* 1/b*(G_level/(R*I1) - omega_n*s) */
    const double t5 = x[3]*t1; /* omega_n*b */
    const double t6 = p[7]*x[4]; /* R^2*I1/I3*s */
    const double t7 = JLT_FNMA(t4, t6, t5); /* v_tau = omega_n*b - 1/b*(G_level/(R*I1) - omega_n*s)*R^2*I1/I3*s */
    const double t8 = t2*t4; /* 1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t9 = t2*t6; /* 1/b*R^2*I1/I3*s */
    const double t10 = JLT_FMA(t6, t8, x[3]); /* d(v_tau)/d(gamma3)/R = R^2*I1/I3*s*1/b*1/b*(G_level/(R*I1) - omega_n*s) + omega_n */
    const double t11 = JLT_FMA(x[4], t9, t1); /* d(v_tau)/d(omega_n) = s*1/b*R^2*I1/I3*s + b */
    const double t12 = x[4]*p[30]; /* s*m*a3^2 */
    const double t13 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t14 = t12*t13; /* s*m*a3^2*omega_tau*omega_tau */
    const double t15 = JLT_FMA(x[4], t12, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t16 = x[2]*t15; /* omega_tau*D */
    out[2] = t16;
    const double t17 = p[38]*t4; /* R^3*I1^2/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t18 = p[7]*t4; /* R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t19 = JLT_FMS(x[3], t9, t18); /* d(v_tau)/d(s) = omega_n*1/b*R^2*I1/I3*s - R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t20 = JLT_FNMA(t8, t17, p[36]); /* m*g*a3 - 1/b*1/b*(G_level/(R*I1) - omega_n*s)*R^3*I1^2/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t21 = p[39]*t8; /* R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t22 = JLT_FNMA(x[3], t21, t14); /* s*m*a3^2*omega_tau*omega_tau - omega_n*R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t23 = x[3]*p[4]; /* omega_n*I1 */
    const double t24 = JLT_FNMA(x[4], t21, t23); /* omega_n*I1 - s*R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t25 = p[37]*t7; /* m*R*v_tau */
    const double t26 = JLT_FMA(t10, t25, t20); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)/R*m*R*v_tau + t20 */
    out[0] = t26;
    const double t27 = p[0]*t7; /* m*v_tau */
    const double t28 = JLT_FMA(t11, t27, t24); /* d(energy)/d(omega_n) = d(v_tau)/d(omega_n)*m*v_tau + t24 */
    out[3] = t28;
    const double t29 = JLT_FMA(t19, t27, t22); /* d(energy)/d(s) = d(v_tau)/d(s)*m*v_tau + t22 */
    out[4] = t29;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[4];
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[16] + x[0]; /* b/R = a3/R + gamma3 */
    const double t1 = JLT_FNMA(x[3], x[4], p[8]); /* G_level/(R*I1) - omega_n*s */
    const double t2 = p[40]*t1; /* (-I1/I3)*(G_level/(R*I1) - omega_n*s) */
    const double t3 = t2/t0; /* (-I1/I3)*(G_level/(R*I1) - omega_n*s)/(b/R) */
    out[0] = t3;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double x4[JLT_JET_ORDER_MAX + 1];
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
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
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x4, k);
        t3[k] = jlt_jet_product(x2, t2, k);
        t8[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t9[k] = jlt_jet_product(x3, t8, k);
        t13[k] = (k == 0 ? p[8] : 0) - jlt_jet_product(x4, x3, k);
        t14[k] = jlt_jet_product(x4, t13, k);
        t15[k] = jlt_jet_quotient(t14[k], t8, t15, k);
        t16[k] = t9[k] - p[7]*t15[k];
        t17[k] = jlt_jet_product(x3, t16, k);
        t19[k] = t2[k]*p[9] + (k == 0 ? 1.0 : 0);
        t20[k] = jlt_jet_product(x2, x0, k);
        t21[k] = p[9]*t20[k];
        t22[k] = jlt_jet_product(t3, t21, k);
        t23[k] = jlt_jet_product(x3, x0, k);
        t24[k] = t23[k] - p[1]*t15[k];
        t26[k] = t22[k] - t2[k]*p[12];
        t27[k] = t26[k] - jlt_jet_product(x3, t24, k);
        t28[k] = jlt_jet_quotient(t27[k], t19, t28, k);
        t31[k] = t8[k]*p[11];
        t32[k] = t2[k] + (k == 0 ? p[10] : 0);
        t33[k] = jlt_jet_product(t8, t31, k) + t32[k];
        t35[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t36[k] = (k == 0 ? p[13] : 0) + t35[k];
        t37[k] = jlt_jet_product(x2, t36, k);
        t38[k] = jlt_jet_product(t15, t37, k);
        t40[k] = jlt_jet_product(x2, t35, k) + x1[k];
        t41[k] = jlt_jet_product(x3, t31, k);
        t42[k] = jlt_jet_product(t40, t41, k) + t38[k];
        t43[k] = jlt_jet_quotient(t42[k], t33, t43, k);
        t44[k] = jlt_jet_product(x3, t20, k) - t43[k];
        t45[k] = jlt_jet_product(x4, t20, k);
        t46[k] = -t45[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t17[k]/(k + 1);
        next[2] = x2[k + 1] = t28[k]/(k + 1);
        next[3] = x3[k + 1] = t44[k]/(k + 1);
        next[4] = x4[k + 1] = t46[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double v_I3 = params[5];
    const double v_G_level = params[6];
    const double v_I1 = params[4];
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
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
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
    { "G_level", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_omega3 = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "level_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "87c26890eb25fc124a005e91d321d4c0fe2271d369b79011e6214acd6bfaa501",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 7, .prepared_count = 41,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 23, 12, 1, 0, 0, 10, 11 }, { 15, 62, 0, 8, 0, 0, 10, 8 },
        "divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, G_level/(R*I1) - s*omega_n, e = a3*gamma3 + R, I3/(m*R) + e, d(v_nu)/dtau, a part of d(omega_tau)/dtau, V = omega_tau*e + v_nu, a part of d(omega_n)/dtau, d(omega_n)/dtau" },
    .jacobian = { jacobian, 25, { 9, 54, 24, 1, 0, 0, 14, 18 }, { 51, 305, 0, 41, 0, 0, 16, 10 },
        "divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n, b/R = a3/R + gamma3, d(d(v_nu)/dtau)/d(gamma3), G_level/(R*I1) - s*omega_n - s*omega_n, d(d(v_nu)/dtau)/d(omega_n), omega_n*omega_n + 1/(b/R)*omega_n*(G_level/(R*I1) - s*omega_n)*s*1/(b/R), d(d(omega_tau)/dtau)/d(gamma3), s*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) - (2)*omega_n*gamma3, a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), e/R = (a3/R)*gamma3 + 1, V = e/R*omega_tau*R + v_nu, I3/(m*R^2) + e/R, a3/R - 1/(b/R)*(I3/(m*R^2) + e/R), a part of d(d(omega_n)/dtau)/d(gamma3), a part of d(d(omega_n)/dtau)/d(gamma3), omega_n - (a3*I3/(R*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1)), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_n), a part of d(d(omega_n)/dtau)/d(s), d(d(omega_n)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 8, 57, 30, 1, 0, 0, 13, 25 }, { 59, 347, 0, 48, 0, 0, 16, 11 },
        "divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, G_level/(R*I1) - s*omega_n, e/R = (a3/R)*gamma3 + 1, V = e/R*omega_tau*R + v_nu, 1/(b/R)*(G_level/(R*I1) - s*omega_n) - 1/(b/R)*s*omega_n, I3/(m*R^2) + e/R, a3/R - 1/(b/R)*(I3/(m*R^2) + e/R), a part of d(d(omega_n)/dtau)/d(gamma3), s*omega_tau*(m*a3^2/I1)*s*omega_tau - omega_n*omega_n, a part of d(d(omega_tau)/dtau)/d(s), d(v_nu)/dtau, d(d(v_nu)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_n), a part of d(d(omega_n)/dtau)/d(gamma3), a part of d(omega_n)/dtau and of d(d(omega_n)/dtau)/d(s), d(omega_n)/dtau, d(d(v_nu)/dtau)/d(omega_n), a part of d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(s), d(d(omega_tau)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(omega_n), omega_n - (a3*I3/(R*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1)), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(s), d(omega_tau)/dtau" },
    .divergence = { divergence, 1, { 2, 13, 7, 1, 0, 0, 9, 9 }, { 9, 40, 0, 4, 0, 0, 10, 7 },
        "divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, I3/(m*R) + e, a part of the divergence, V = omega_tau*e + v_nu, the divergence" },
    .integral_values = { integral_values, 1, { 0, 9, 9, 1, 0, 0, 7, 7 }, { 9, 30, 0, 1, 0, 0, 12, 5 },
        "divides by b: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level/(R*I1) - s*omega_n, v_tau = omega_n*b - ((G_level/(R*I1) - s*omega_n)/b)*s*(R^2*I1/I3), energy/(1/2*m)" },
    .integral_gradients = { integral_gradients, 5, { 0, 16, 13, 1, 0, 0, 7, 9 }, { 15, 60, 0, 7, 0, 0, 12, 10 },
        "divides by b: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b = R*gamma3 + a3, G_level/(R*I1) - omega_n*s, v_tau = omega_n*b - ((1)/b)*(G_level/(R*I1) - omega_n*s)*(R^2*I1/I3)*s, d(v_tau)/d(gamma3)/R = (R^2*I1/I3)*s*((1)/b)*((1)/b)*(G_level/(R*I1) - omega_n*s) + omega_n, d(v_tau)/d(s), d(E)/d(gamma3), d(E)/d(omega_n), d(E)/d(s)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { eliminated, 1, { 1, 1, 1, 1, 0, 0, 3, 3 }, { 2, 5, 0, 1, 0, 0, 5, 3 },
        "divides by b: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, G_level/(R*I1) - omega_n*s" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .lifted = lifted,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .eliminated_state = 4, .level_integral = 1,
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular_on_level_omega3,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_general_in_regular_on_level_omega3) },
#endif
};
