/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3   23   12    1    0    0     10   11   (85)
 *  jacobian            9   51   24    1    0    0     12   19   (397)
 *  rhs_jacobian        9   57   30    1    0    0     14   21   (454)
 *  divergence          2   13    7    1    0    0      8    8   (53)
 *  integral_values     0    9    9    1    0    0      7    7   (40)
 *  integral_gradients  0   16   13    1    0    0      7    9   (82)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  eliminated          1    1    1    1    0    0      3    3   (8)
 *
 *  Accuracy
 *    divides by b: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    digits are lost where terms nearly cancel in b/R = a3/R + gamma3, G_level/(R*I1) - s*omega_n,
 *      1/(b/R)*s*omega_n - 1/(b/R)*(G_level/(R*I1) - s*omega_n), e/R = (a3/R)*gamma3 + 1, V = e/R*omega_tau*R + v_nu,
 *      I3/(m*R^2) + e/R, s*omega_tau*(m*a3^2/I1)*s*omega_tau - omega_n*omega_n, a3/R - 1/(b/R)*(I3/(m*R^2) + e/R),
 *      a part of d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), a part of d(d(omega_n)/dtau)/d(gamma3),
 *      a part of d(omega_n)/dtau and of d(d(omega_n)/dtau)/d(s), d(omega_n)/dtau,
 *      a part of d(d(omega_tau)/dtau)/d(omega_n), a part of d(d(omega_tau)/dtau)/d(s),
 *      omega_n - (a3*I3/(R*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1)), d(d(omega_n)/dtau)/d(gamma3),
 *      d(d(omega_tau)/dtau)/d(s), d(v_nu)/dtau, d(d(v_nu)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(gamma3),
 *      d(d(v_nu)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(s), d(omega_tau)/dtau
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
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G_omega3;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_in_regular_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx512;

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
    out[27] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[9] = t7;
    const double t8 = t0*params[0]; /* R*R*m */
    const double t9 = params[5]/t8; /* I3/(R*R*m) */
    out[10] = t9;
    const double t10 = params[5]/t1; /* I3/(R*R*I1) */
    out[11] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[3]*t11; /* a3*m*g */
    out[34] = t12;
    const double t13 = t12/params[4]; /* a3*m*g/I1 */
    out[12] = t13;
    const double t14 = params[1]*params[0]; /* R*m */
    out[35] = t14;
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
    out[28] = t22;
    const double t23 = t22/params[4]; /* a3*a3*m*2/I1 */
    out[19] = t23;
    const double t24 = params[2]*t21; /* g*m*2 */
    const double t25 = params[3]*t24; /* a3*g*m*2 */
    const double t26 = t25/params[4]; /* a3*g*m*2/I1 */
    out[20] = t26;
    const double t27 = params[5]/t3; /* I3/(R*I1) */
    out[21] = t27;
    const double t28 = params[5]*params[3]; /* I3*a3 */
    const double t29 = t28/t3; /* I3*a3/(R*I1) */
    out[22] = t29;
    const double t30 = params[5]*2.0; /* I3*2 */
    const double t31 = t30/params[4]; /* I3*2/I1 */
    out[23] = t31;
    const double t32 = params[4]*params[4]; /* I1*I1 */
    const double t33 = params[1]*t32; /* R*I1*I1 */
    const double t34 = params[5]*params[5]; /* I3*I3 */
    const double t35 = 2.0*t34; /* 2*I3*I3 */
    const double t36 = t35/t33; /* 2*I3*I3/(R*I1*I1) */
    out[24] = t36;
    const double t37 = -t27; /* -I3/(R*I1) */
    out[25] = t37;
    const double t38 = t30/t3; /* I3*2/(R*I1) */
    out[26] = t38;
    const double t39 = params[0]/2.0; /* m/2 */
    out[29] = t39;
    const double t40 = params[2]*2.0; /* g*2 */
    const double t41 = params[3]*t40; /* a3*g*2 */
    out[30] = t41;
    const double t42 = 1.0/params[0]; /* 1/m */
    out[31] = t42;
    const double t43 = params[4]/params[0]; /* I1/m */
    out[32] = t43;
    const double t44 = t0*t32; /* R*R*I1*I1 */
    const double t45 = params[5]*params[0]; /* I3*m */
    const double t46 = t44/t45; /* R*R*I1*I1/(I3*m) */
    out[33] = t46;
    const double t47 = params[1]*t0; /* R*R*R */
    const double t48 = t32*t47; /* I1*I1*R*R*R */
    const double t49 = t48/params[5]; /* I1*I1*R*R*R/I3 */
    out[36] = t49;
    const double t50 = t44/params[5]; /* R*R*I1*I1/I3 */
    out[37] = t50;
    const double t51 = params[4]/params[5]; /* I1/I3 */
    const double t52 = -t51; /* -I1/I3 */
    out[38] = t52;
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
    const double t18 = x[3]*t6; /* omega_n*(G_level/(R*I1) - s*omega_n) */
    const double t19 = t17*t18; /* s*1/(b/R)*omega_n*(G_level/(R*I1) - s*omega_n) */
    const double t20 = t16*t19; /* 1/(b/R)*s*1/(b/R)*omega_n*(G_level/(R*I1) - s*omega_n) */
    const double t21 = JLT_FMA(p[14], t20, t4); /* R*I1/I3*1/(b/R)*s*1/(b/R)*omega_n*(G_level/(R*I1) - s*omega_n) + R*omega_n*omega_n */
    out[5] = t21;
    const double t22 = x[3]*t8; /* omega_n*b/R */
    const double t23 = p[17]*t22; /* 2*R*omega_n*b/R */
    const double t24 = t6 - t5; /* G_level/(R*I1) - s*omega_n - s*omega_n */
    const double t25 = t17*t24; /* s*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t26 = JLT_FNMA(p[14], t25, t23); /* 2*R*omega_n*b/R - R*I1/I3*s*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[8] = t26;
    const double t27 = t16*t24; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t28 = x[3]*t27; /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t29 = p[18]*t28; /* (-R*I1/I3)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    out[9] = t29;
    const double t30 = t1*p[9]; /* s*omega_tau*m*a3^2/I1 */
    const double t31 = JLT_FMS(t1, t30, t3); /* s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n */
    const double t32 = t31 - t20; /* s*omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*omega_n - 1/(b/R)*s*1/(b/R)*omega_n*(G_level/(R*I1) - s*omega_n) */
    const double t33 = t8*t15; /* 1/(D/I1) = b/R*1/((b/R)*(D/I1)) */
    const double t34 = t32*t33; /* t32*1/(D/I1) */
    out[10] = t34;
    const double t35 = x[4]*t33; /* s*1/(D/I1) */
    const double t36 = p[19]*t35; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t37 = t1*x[0]; /* s*omega_tau*gamma3 */
    const double t38 = t36*t37; /* 2*m*a3^2/I1*s*1/(D/I1)*s*omega_tau*gamma3 */
    out[12] = t38;
    const double t39 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t40 = JLT_FNMA(2.0, t39, t25); /* s*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) - 2*omega_n*gamma3 */
    const double t41 = t33*t40; /* 1/(D/I1)*t40 */
    out[13] = t41;
    const double t42 = JLT_FMA(x[2], x[2], t3); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t43 = JLT_FMS(x[0], t42, t19); /* gamma3*(omega_tau*omega_tau + omega_n*omega_n) - s*1/(b/R)*omega_n*(G_level/(R*I1) - s*omega_n) */
    const double t44 = JLT_FNMA(t35, p[20], t28); /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) - s*1/(D/I1)*2*m*g*a3/I1 */
    const double t45 = JLT_FMA(t36, t43, t44); /* 2*m*a3^2/I1*s*1/(D/I1)*t43 + t44 */
    const double t46 = t33*t45; /* 1/(D/I1)*(2*m*a3^2/I1*s*1/(D/I1)*t43 + t44) */
    out[14] = t46;
    const double t47 = JLT_FMA(p[16], x[0], 1.0); /* e/R = a3/R*gamma3 + 1 */
    const double t48 = x[2]*p[1]; /* omega_tau*R */
    const double t49 = JLT_FMA(t47, t48, x[1]); /* V = e/R*omega_tau*R + v_nu */
    const double t50 = t12*t14; /* 1/(Theta/(m*R^2*I1)) = D/I1*b/R*1/(Theta/(m*R^2*I1)*D/I1*b/R) */
    const double t51 = t49*t50; /* V*1/(Theta/(m*R^2*I1)) */
    const double t52 = p[21]*t51; /* I3/(R*I1)*V*1/(Theta/(m*R^2*I1)) */
    const double t53 = x[3]*t52; /* omega_n*I3/(R*I1)*V*1/(Theta/(m*R^2*I1)) */
    const double t54 = t22*t50; /* omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t55 = p[10] + t47; /* I3/(m*R^2) + e/R */
    const double t56 = JLT_FNMA(t16, t55, p[16]); /* a3/R - 1/(b/R)*(I3/(m*R^2) + e/R) */
    const double t57 = t6*t50; /* (G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1)) */
    const double t58 = t17*t57; /* s*1/(b/R)*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1)) */
    const double t59 = JLT_FMS(p[22], t54, x[3]); /* a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1)) - omega_n */
    const double t60 = JLT_FMA(t56, t58, t59); /* (a3/R - 1/(b/R)*(I3/(m*R^2) + e/R))*s*1/(b/R)*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1)) + a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1)) - omega_n */
    const double t61 = t50*t55; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t62 = t1*t61; /* s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t63 = t57*p[23]; /* (G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1))*2*I3/I1 */
    const double t64 = t51*t54; /* V*1/(Theta/(m*R^2*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t65 = t8*p[24]; /* b/R*2*I3^2/(R*I1^2) */
    const double t66 = JLT_FMS(t62, t63, t53); /* s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R)*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1))*2*I3/I1 - omega_n*I3/(R*I1)*V*1/(Theta/(m*R^2*I1)) */
    const double t67 = JLT_FMA(t64, t65, t66); /* V*1/(Theta/(m*R^2*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1))*b/R*2*I3^2/(R*I1^2) + t66 */
    const double t68 = JLT_FNMA(x[2], t60, t67); /* t67 - omega_tau*t60 */
    out[15] = t68;
    const double t69 = t54*p[25]; /* omega_n*b/R*1/(Theta/(m*R^2*I1))*(-I3/(R*I1)) */
    out[16] = t69;
    const double t70 = p[15]*t47; /* I3/I1*e/R */
    const double t71 = JLT_FNMA(t54, t70, t39); /* omega_n*gamma3 - omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/I1*e/R */
    const double t72 = JLT_FNMA(t55, t58, t71); /* omega_n*gamma3 - omega_n*b/R*1/(Theta/(m*R^2*I1))*I3/I1*e/R - (I3/(m*R^2) + e/R)*s*1/(b/R)*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1)) */
    out[17] = t72;
    const double t73 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t74 = JLT_FNMA(t8, t52, t73); /* omega_tau*gamma3 - b/R*I3/(R*I1)*V*1/(Theta/(m*R^2*I1)) */
    const double t75 = JLT_FMA(t17, t62, t74); /* s*1/(b/R)*s*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) + omega_tau*gamma3 - b/R*I3/(R*I1)*V*1/(Theta/(m*R^2*I1)) */
    out[18] = t75;
    const double t76 = x[4]*p[26]; /* s*2*I3/(R*I1) */
    const double t77 = t64*t76; /* V*1/(Theta/(m*R^2*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1))*s*2*I3/(R*I1) */
    const double t78 = x[2]*t27; /* omega_tau*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) */
    const double t79 = JLT_FNMA(t2, t58, t78); /* omega_tau*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) - 2*s*omega_tau*s*1/(b/R)*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1)) */
    const double t80 = JLT_FNMA(t61, t79, t77); /* t77 - 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R)*t79 */
    out[19] = t80;
    const double t81 = -t1; /* -s*omega_tau */
    out[20] = t81;
    const double t82 = x[4]*x[0]; /* s*gamma3 */
    const double t83 = -t82; /* -s*gamma3 */
    out[22] = t83;
    const double t84 = -t73; /* -omega_tau*gamma3 */
    out[24] = t84;
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
    const double t15 = t11*t14; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t16 = JLT_FMS(t11, t13, t15); /* 1/(b/R)*s*omega_n - 1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t17 = p[23]*t14; /* 2*I3/I1*(G_level/(R*I1) - s*omega_n) */
    const double t18 = JLT_FMA(p[16], x[0], 1.0); /* e/R = a3/R*gamma3 + 1 */
    const double t19 = x[4]*x[2]; /* s*omega_tau */
    const double t20 = 2.0*t19; /* 2*s*omega_tau */
    out[9] = t20;
    const double t21 = -t19; /* -s*omega_tau */
    out[25] = t21;
    const double t22 = x[4]*t12; /* s*1/(D/I1) */
    const double t23 = x[2]*p[1]; /* omega_tau*R */
    const double t24 = JLT_FMA(t18, t23, x[1]); /* V = e/R*omega_tau*R + v_nu */
    const double t25 = t0*t10; /* b/R*1/(Theta/(m*R^2*I1)) */
    const double t26 = p[10] + t18; /* I3/(m*R^2) + e/R */
    const double t27 = p[15]*t18; /* I3/I1*e/R */
    const double t28 = x[3]*x[3]; /* omega_n*omega_n */
    const double t29 = p[9]*t19; /* m*a3^2/I1*s*omega_tau */
    const double t30 = JLT_FMS(t19, t29, t28); /* s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n */
    const double t31 = t12*t30; /* 1/(D/I1)*(s*omega_tau*m*a3^2/I1*s*omega_tau - omega_n*omega_n) */
    const double t32 = x[0]*x[3]; /* gamma3*omega_n */
    const double t33 = t10*t26; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t34 = t17*t33; /* 2*I3/I1*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t35 = JLT_FNMA(t11, t26, p[16]); /* a3/R - 1/(b/R)*(I3/(m*R^2) + e/R) */
    const double t36 = JLT_FNMA(t15, t35, t34); /* t34 - 1/(b/R)*(G_level/(R*I1) - s*omega_n)*(a3/R - 1/(b/R)*(I3/(m*R^2) + e/R)) */
    const double t37 = x[3]*t16; /* omega_n*(1/(b/R)*s*omega_n - 1/(b/R)*(G_level/(R*I1) - s*omega_n)) */
    const double t38 = p[14]*t37; /* R*I1/I3*t37 */
    out[14] = t38;
    const double t39 = JLT_FMA(p[20], t22, t37); /* 2*m*g*a3/I1*s*1/(D/I1) + t37 */
    const double t40 = p[19]*t22; /* 2*m*a3^2/I1*s*1/(D/I1) */
    const double t41 = x[3]*t25; /* omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t42 = t24*t25; /* V*b/R*1/(Theta/(m*R^2*I1)) */
    const double t43 = JLT_FNMA(t27, t41, t32); /* gamma3*omega_n - I3/I1*e/R*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t44 = p[25]*t41; /* (-I3/(R*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    out[21] = t44;
    const double t45 = x[3]*t15; /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t46 = t15*t33; /* 1/(b/R)*(G_level/(R*I1) - s*omega_n)*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t47 = JLT_FNMA(x[4], t46, t43); /* gamma3*omega_n - I3/I1*e/R*omega_n*b/R*1/(Theta/(m*R^2*I1)) - s*t46 */
    out[22] = t47;
    const double t48 = x[3]*p[21]; /* omega_n*I3/(R*I1) */
    const double t49 = t24*t48; /* V*omega_n*I3/(R*I1) */
    const double t50 = JLT_FNMA(t19, t36, t49); /* V*omega_n*I3/(R*I1) - s*omega_tau*t36 */
    const double t51 = t42*t48; /* V*b/R*1/(Theta/(m*R^2*I1))*omega_n*I3/(R*I1) */
    const double t52 = JLT_FMA(t19, t46, t51); /* s*omega_tau*t46 + V*b/R*1/(Theta/(m*R^2*I1))*omega_n*I3/(R*I1) */
    const double t53 = JLT_FMS(x[2], t32, t52); /* omega_tau*gamma3*omega_n - t52 */
    out[3] = t53;
    const double t54 = 2.0*t32; /* 2*gamma3*omega_n */
    const double t55 = t12*t54; /* 1/(D/I1)*2*gamma3*omega_n */
    const double t56 = JLT_FMA(t16, t22, t55); /* (1/(b/R)*s*omega_n - 1/(b/R)*(G_level/(R*I1) - s*omega_n))*s*1/(D/I1) + 1/(D/I1)*2*gamma3*omega_n */
    const double t57 = -t56; /* -t56 */
    out[18] = t57;
    const double t58 = x[0]*t40; /* gamma3*2*m*a3^2/I1*s*1/(D/I1) */
    const double t59 = t19*t58; /* s*omega_tau*gamma3*2*m*a3^2/I1*s*1/(D/I1) */
    out[17] = t59;
    const double t60 = JLT_FMA(x[2], x[2], t28); /* omega_tau*omega_tau + omega_n*omega_n */
    const double t61 = JLT_FMS(t58, t60, t39); /* gamma3*2*m*a3^2/I1*s*1/(D/I1)*(omega_tau*omega_tau + omega_n*omega_n) - (2*m*g*a3/I1*s*1/(D/I1) + t37) */
    const double t62 = t12*t61; /* 1/(D/I1)*t61 */
    const double t63 = p[1]*t28; /* R*omega_n*omega_n */
    const double t64 = JLT_FNMA(p[22], t41, x[3]); /* omega_n - a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t65 = x[2]*t64; /* omega_tau*(omega_n - a3*I3/(R*I1)*omega_n*b/R*1/(Theta/(m*R^2*I1))) */
    const double t66 = p[24]*t41; /* 2*I3^2/(R*I1^2)*omega_n*b/R*1/(Theta/(m*R^2*I1)) */
    const double t67 = JLT_FMA(t42, t66, t65); /* V*b/R*1/(Theta/(m*R^2*I1))*2*I3^2/(R*I1^2)*omega_n*b/R*1/(Theta/(m*R^2*I1)) + t65 */
    const double t68 = JLT_FNMA(t10, t50, t67); /* t67 - 1/(Theta/(m*R^2*I1))*(V*omega_n*I3/(R*I1) - s*omega_tau*t36) */
    out[20] = t68;
    const double t69 = x[4]*t19; /* s*s*omega_tau */
    out[0] = t69;
    const double t70 = x[0]*t19; /* gamma3*s*omega_tau */
    const double t71 = -t70; /* -gamma3*s*omega_tau */
    out[4] = t71;
    const double t72 = t33*t69; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R)*s*s*omega_tau */
    const double t73 = x[2]*t33; /* omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t74 = t16*t73; /* (1/(b/R)*s*omega_n - 1/(b/R)*(G_level/(R*I1) - s*omega_n))*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R) */
    const double t75 = x[4]*p[14]; /* s*R*I1/I3 */
    const double t76 = t22*t45; /* s*1/(D/I1)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t77 = JLT_FNMA(t40, t76, t62); /* 1/(D/I1)*t61 - 2*m*a3^2/I1*s*1/(D/I1)*s*1/(D/I1)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    out[19] = t77;
    const double t78 = t45*t75; /* omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*R*I1/I3 */
    const double t79 = JLT_FMS(t0, t63, t78); /* b/R*R*omega_n*omega_n - omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*R*I1/I3 */
    out[1] = t79;
    const double t80 = JLT_FMA(t11, t78, t63); /* 1/(b/R)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n)*s*R*I1/I3 + R*omega_n*omega_n */
    out[10] = t80;
    const double t81 = JLT_FNMA(t11, t76, t31); /* t31 - 1/(b/R)*s*1/(D/I1)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    out[15] = t81;
    const double t82 = JLT_FMA(x[0], t31, t76); /* gamma3*t31 + s*1/(D/I1)*omega_n*1/(b/R)*(G_level/(R*I1) - s*omega_n) */
    const double t83 = x[3]*p[17]; /* omega_n*2*R */
    const double t84 = t0*t83; /* b/R*omega_n*2*R */
    const double t85 = JLT_FMA(t16, t75, t84); /* (1/(b/R)*s*omega_n - 1/(b/R)*(G_level/(R*I1) - s*omega_n))*s*R*I1/I3 + b/R*omega_n*2*R */
    out[13] = t85;
    const double t86 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t87 = JLT_FNMA(p[21], t42, t86); /* omega_tau*gamma3 - I3/(R*I1)*V*b/R*1/(Theta/(m*R^2*I1)) */
    const double t88 = JLT_FMA(t11, t72, t87); /* 1/(b/R)*1/(Theta/(m*R^2*I1))*(I3/(m*R^2) + e/R)*s*s*omega_tau + omega_tau*gamma3 - I3/(R*I1)*V*b/R*1/(Theta/(m*R^2*I1)) */
    out[23] = t88;
    const double t89 = -t86; /* -omega_tau*gamma3 */
    out[29] = t89;
    const double t90 = x[4]*2.0; /* s*2 */
    const double t91 = t10*t90; /* 1/(Theta/(m*R^2*I1))*s*2 */
    const double t92 = JLT_FMA(t52, t91, t74); /* t52*1/(Theta/(m*R^2*I1))*s*2 + t74 */
    out[24] = t92;
    const double t93 = x[4]*p[12]; /* s*m*g*a3/I1 */
    const double t94 = JLT_FNMA(t22, t93, t82); /* t82 - s*1/(D/I1)*s*m*g*a3/I1 */
    out[2] = t94;
    const double t95 = x[4]*x[0]; /* s*gamma3 */
    const double t96 = -t95; /* -s*gamma3 */
    out[27] = t96;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = JLT_FMA(p[27], t1, p[4]); /* D = m*a3^2*s*s + I1 */
    const double t3 = p[11]*t0; /* I3/(R^2*I1)*b */
    const double t4 = p[10] + t1; /* I3/(m*R^2) + s*s */
    const double t5 = JLT_FMA(t0, t3, t4); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s*s */
    const double t6 = x[2]*t1; /* omega_tau*s*s */
    const double t7 = t5*t6; /* Theta/(m*R^2*I1)*omega_tau*s*s */
    const double t8 = t0*t2; /* b*D */
    const double t9 = t5*t8; /* Theta/(m*R^2*I1)*b*D */
    const double t10 = 1.0/t9; /* 1/(Theta/(m*R^2*I1)*b*D) */
    const double t11 = t0*t10; /* b*1/(Theta/(m*R^2*I1)*b*D) */
    const double t12 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t13 = p[13] + t12; /* I3/(m*R) + e */
    const double t14 = JLT_FMA(x[2], t12, x[1]); /* V = omega_tau*e + v_nu */
    const double t15 = t3*t14; /* I3/(R^2*I1)*b*V */
    const double t16 = t2*t13; /* D*(I3/(m*R) + e) */
    const double t17 = t7*t16; /* Theta/(m*R^2*I1)*omega_tau*s*s*D*(I3/(m*R) + e) */
    const double t18 = JLT_FNMA(t10, t17, t15); /* I3/(R^2*I1)*b*V - 1/(Theta/(m*R^2*I1)*b*D)*Theta/(m*R^2*I1)*omega_tau*s*s*D*(I3/(m*R) + e) */
    const double t19 = x[0]*p[28]; /* gamma3*2*m*a3^2 */
    const double t20 = t7*t19; /* Theta/(m*R^2*I1)*omega_tau*s*s*gamma3*2*m*a3^2 */
    const double t21 = JLT_FNMA(t2, t18, t20); /* Theta/(m*R^2*I1)*omega_tau*s*s*gamma3*2*m*a3^2 - D*t18 */
    const double t22 = t11*t21; /* b*1/(Theta/(m*R^2*I1)*b*D)*(Theta/(m*R^2*I1)*omega_tau*s*s*gamma3*2*m*a3^2 - D*t18) */
    out[0] = t22;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t1 = JLT_FNMA(x[4], x[3], p[8]); /* G_level/(R*I1) - s*omega_n */
    const double t2 = t1/t0; /* (G_level/(R*I1) - s*omega_n)/b */
    const double t3 = x[3]*t0; /* omega_n*b */
    const double t4 = p[30]*x[0]; /* 2*g*a3*gamma3 */
    const double t5 = JLT_FMA(x[1], x[1], t4); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t6 = p[27]*x[4]; /* m*a3^2*s */
    const double t7 = JLT_FMA(x[4], t6, p[4]); /* D = s*m*a3^2*s + I1 */
    const double t8 = p[31]*x[2]; /* 1/m*omega_tau */
    const double t9 = x[2]*t8; /* omega_tau*1/m*omega_tau */
    const double t10 = p[32]*x[3]; /* I1/m*omega_n */
    const double t11 = JLT_FMA(x[3], t10, t5); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(t7, t9, t11); /* D*omega_tau*1/m*omega_tau + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[33]*t2; /* R^2*I1^2/(m*I3)*(G_level/(R*I1) - s*omega_n)/b */
    const double t14 = JLT_FMA(t2, t13, t12); /* (G_level/(R*I1) - s*omega_n)/b*R^2*I1^2/(m*I3)*(G_level/(R*I1) - s*omega_n)/b + t12 */
    const double t15 = x[4]*p[7]; /* s*R^2*I1/I3 */
    const double t16 = JLT_FNMA(t2, t15, t3); /* v_tau = omega_n*b - (G_level/(R*I1) - s*omega_n)/b*s*R^2*I1/I3 */
    const double t17 = JLT_FMA(t16, t16, t14); /* energy/(1/2*m) = v_tau*v_tau + t14 */
    const double t18 = p[29]*t17; /* 1/2*m*energy/(1/2*m) */
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
    const double t12 = x[4]*p[27]; /* s*m*a3^2 */
    const double t13 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t14 = t12*t13; /* s*m*a3^2*omega_tau*omega_tau */
    const double t15 = JLT_FMA(x[4], t12, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t16 = x[2]*t15; /* omega_tau*D */
    out[2] = t16;
    const double t17 = p[36]*t4; /* R^3*I1^2/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t18 = p[7]*t4; /* R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t19 = JLT_FMS(x[3], t9, t18); /* d(v_tau)/d(s) = omega_n*1/b*R^2*I1/I3*s - R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t20 = JLT_FNMA(t8, t17, p[34]); /* m*g*a3 - 1/b*1/b*(G_level/(R*I1) - omega_n*s)*R^3*I1^2/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t21 = p[37]*t8; /* R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t22 = JLT_FNMA(x[3], t21, t14); /* s*m*a3^2*omega_tau*omega_tau - omega_n*R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t23 = x[3]*p[4]; /* omega_n*I1 */
    const double t24 = JLT_FNMA(x[4], t21, t23); /* omega_n*I1 - s*R^2*I1^2/I3*1/b*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t25 = p[35]*t7; /* m*R*v_tau */
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
    const double t2 = p[38]*t1; /* (-I1/I3)*(G_level/(R*I1) - omega_n*s) */
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
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
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
    double t53[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t15[k] = jlt_jet_product(x4, x4, k);
        t16[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t17[k] = p[9]*t15[k] + (k == 0 ? 1.0 : 0);
        t18[k] = p[11]*t16[k];
        t19[k] = (k == 0 ? p[10] : 0) + t15[k];
        t20[k] = jlt_jet_product(t16, t18, k) + t19[k];
        t21[k] = jlt_jet_product(x3, t18, k);
        t22[k] = jlt_jet_product(t16, t17, k);
        t23[k] = jlt_jet_product(t20, t22, k);
        t24[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t23, t24, k);
        t25[k] = jlt_jet_product(t20, t24, k);
        t26[k] = jlt_jet_product(t22, t24, k);
        t27[k] = (k == 0 ? p[8] : 0) - jlt_jet_product(x4, x3, k);
        t28[k] = jlt_jet_product(x4, t27, k);
        t29[k] = jlt_jet_product(t17, t28, k);
        t30[k] = jlt_jet_product(t25, t29, k);
        t31[k] = jlt_jet_product(t16, t25, k);
        t32[k] = jlt_jet_product(x2, x0, k);
        t33[k] = jlt_jet_product(x2, t15, k);
        t34[k] = p[9]*t32[k];
        t35[k] = jlt_jet_product(t33, t34, k);
        t36[k] = t35[k] - p[12]*t15[k];
        t37[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t38[k] = (k == 0 ? p[13] : 0) + t37[k];
        t39[k] = jlt_jet_product(x2, t38, k);
        t40[k] = jlt_jet_product(t30, t39, k);
        t41[k] = jlt_jet_product(x3, t30, k);
        t42[k] = jlt_jet_product(x2, t37, k) + x1[k];
        t43[k] = jlt_jet_product(t21, t42, k) + t40[k];
        t44[k] = jlt_jet_product(x3, x3, k);
        t45[k] = t36[k] - jlt_jet_product(x0, t44, k);
        t46[k] = jlt_jet_product(t16, t44, k);
        t47[k] = t46[k] - p[7]*t41[k];
        t48[k] = p[1]*t41[k] + t45[k];
        t49[k] = jlt_jet_product(t31, t48, k);
        t50[k] = jlt_jet_product(x3, t32, k);
        t51[k] = t50[k] - jlt_jet_product(t26, t43, k);
        t52[k] = jlt_jet_product(x4, t32, k);
        t53[k] = -t52[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t33[k]/(k + 1);
        next[1] = x1[k + 1] = t47[k]/(k + 1);
        next[2] = x2[k + 1] = t49[k]/(k + 1);
        next[3] = x3[k + 1] = t51[k]/(k + 1);
        next[4] = x4[k + 1] = t53[k]/(k + 1);
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

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 5, .param_count = 7, .block_count = 39,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 3, 23, 12, 1, 0, 0, 10, 11 }, { 15, 62, 0, 8, 0, 0, 10, 8 },
        "divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, G_level/(R*I1) - s*omega_n, e = a3*gamma3 + R, I3/(m*R) + e, d(v_nu)/dtau, a part of d(omega_tau)/dtau, V = omega_tau*e + v_nu, a part of d(omega_n)/dtau, d(omega_n)/dtau" },
    .jacobian = { jacobian, 25, { 9, 51, 24, 1, 0, 0, 12, 19 }, { 51, 305, 0, 41, 0, 0, 16, 10 },
        "divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in G_level/(R*I1) - s*omega_n, b/R = a3/R + gamma3, d(d(v_nu)/dtau)/d(gamma3), G_level/(R*I1) - s*omega_n - s*omega_n, d(d(v_nu)/dtau)/d(omega_n), a part of d(d(omega_tau)/dtau)/d(gamma3), s*1/(b/R)*(G_level/(R*I1) - s*omega_n - s*omega_n) - (2)*omega_n*gamma3, a part of d(d(omega_tau)/dtau)/d(s), a part of d(d(omega_tau)/dtau)/d(s), e/R = (a3/R)*gamma3 + 1, V = e/R*omega_tau*R + v_nu, I3/(m*R^2) + e/R, a3/R - 1/(b/R)*(I3/(m*R^2) + e/R), a part of d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), d(d(omega_n)/dtau)/d(omega_n), a part of d(d(omega_n)/dtau)/d(s), d(d(omega_n)/dtau)/d(s)" },
    .rhs_jacobian = { rhs_jacobian, 30, { 9, 57, 30, 1, 0, 0, 14, 21 }, { 59, 347, 0, 48, 0, 0, 16, 11 },
        "divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b/R = a3/R + gamma3, G_level/(R*I1) - s*omega_n, 1/(b/R)*s*omega_n - 1/(b/R)*(G_level/(R*I1) - s*omega_n), e/R = (a3/R)*gamma3 + 1, V = e/R*omega_tau*R + v_nu, I3/(m*R^2) + e/R, s*omega_tau*(m*a3^2/I1)*s*omega_tau - omega_n*omega_n, a3/R - 1/(b/R)*(I3/(m*R^2) + e/R), a part of d(d(omega_n)/dtau)/d(gamma3), d(d(omega_n)/dtau)/d(omega_tau), a part of d(d(omega_n)/dtau)/d(gamma3), a part of d(omega_n)/dtau and of d(d(omega_n)/dtau)/d(s), d(omega_n)/dtau, a part of d(d(omega_tau)/dtau)/d(omega_n), a part of d(d(omega_tau)/dtau)/d(s), omega_n - (a3*I3/(R*I1))*omega_n*b/R*1/(Theta/(m*R^2*I1)), d(d(omega_n)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(s), d(v_nu)/dtau, d(d(v_nu)/dtau)/d(gamma3), d(d(omega_tau)/dtau)/d(gamma3), d(d(v_nu)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(omega_n), d(d(omega_n)/dtau)/d(s), d(omega_tau)/dtau" },
    .divergence = { divergence, 1, { 2, 13, 7, 1, 0, 0, 8, 8 }, { 9, 40, 0, 4, 0, 0, 10, 7 },
        "divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; digits are lost where terms nearly cancel in b = R*gamma3 + a3, e = a3*gamma3 + R, I3/(m*R) + e, V = omega_tau*e + v_nu, a part of the divergence, a part of the divergence" },
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
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_in_regular_on_level_G_omega3,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_general_in_regular_on_level_G_omega3_avx512,
    },
#endif
};
