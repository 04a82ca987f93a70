/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Eliminated: level_G_omega3: omega3 from G = G_level
 *  Table:      spherical_top, SHA-256 ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a
 *  Command:    ttc generate --effort full --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   26   11    1    1    0     13   11   (82)
 *  jacobian            8   53   29    1    1    0     17   21   (318)
 *  rhs_jacobian        10   55   30    1    1    0     17   27   (369)
 *  divergence          4   17    7    1    1    0     12   10   (54)
 *  integral_values     2    9    9    1    1    0      9    7   (43)
 *  integral_gradients  2   22   13    1    1    0     13   11   (75)
 *  eliminated          3    2    1    1    1    0      5    3   (11)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by b: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level/(R*I1) - omega_n*s,
 *      1/b*omega_n*s - 1/b*(G_level/(R*I1) - omega_n*s), (m*g*a3/(R*I1))*s - omega_n*1/b*(G_level/(R*I1) - omega_n*s),
 *      e = gamma3*a3 + R, d(Theta)/d(gamma3)/(2*m*R^2*I1) = (I3/(R*I1))*b - gamma3, I3/(m*R) + e,
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu,
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_n)/dt)/d(gamma3),
 *      a part of d(v_nu)/dt, d(omega_tau)/dt, a part of d(d(omega_n)/dt)/d(gamma3),
 *      a part of d(d(omega_n)/dt)/d(gamma3), a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(gamma3), d(omega_n)/dt,
 *      a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n),
 *      d(d(omega_n)/dt)/d(omega_tau), a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(omega_n), d(d(v_nu)/dt)/d(omega_n)
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
extern const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G_omega3;
extern const struct jlt_ball_table jlt_balls_spherical_top_general_on_level_G_omega3;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_omega3_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_omega3_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_on_level_G_omega3_avx512;

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
    const double t1 = params[0]*t0; /* m*R*R */
    const double t2 = params[5]/t1; /* I3/(m*R*R) */
    out[7] = t2;
    const double t3 = t0*params[4]; /* R*R*I1 */
    const double t4 = params[5]/t3; /* I3/(R*R*I1) */
    out[8] = t4;
    const double t5 = params[3]*params[3]; /* a3*a3 */
    const double t6 = params[0]*t5; /* m*a3*a3 */
    out[25] = t6;
    const double t7 = t6/params[4]; /* m*a3*a3/I1 */
    out[9] = t7;
    const double t8 = t3/params[5]; /* R*R*I1/I3 */
    out[10] = t8;
    const double t9 = params[1]*params[4]; /* R*I1 */
    out[33] = t9;
    const double t10 = params[6]/t9; /* G_level/(R*I1) */
    out[11] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    const double t12 = params[3]*t11; /* a3*m*g */
    out[31] = t12;
    const double t13 = t12/params[4]; /* a3*m*g/I1 */
    out[12] = t13;
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = params[5]/t14; /* I3/(m*R) */
    out[13] = t15;
    const double t16 = t9/params[5]; /* R*I1/I3 */
    out[14] = t16;
    const double t17 = params[0]*2.0; /* m*2 */
    const double t18 = t5*t17; /* a3*a3*m*2 */
    out[24] = t18;
    const double t19 = t18/params[4]; /* a3*a3*m*2/I1 */
    out[15] = t19;
    const double t20 = params[5]/params[4]; /* I3/I1 */
    out[16] = t20;
    const double t21 = params[1]*t17; /* R*m*2 */
    const double t22 = t5*t21; /* a3*a3*R*m*2 */
    const double t23 = t22/params[4]; /* a3*a3*R*m*2/I1 */
    out[17] = t23;
    const double t24 = params[1]/2.0; /* R/2 */
    out[18] = t24;
    const double t25 = params[5]*2.0; /* I3*2 */
    const double t26 = t25/t3; /* I3*2/(R*R*I1) */
    out[19] = t26;
    const double t27 = params[5]/t9; /* I3/(R*I1) */
    out[20] = t27;
    const double t28 = params[5]*params[3]; /* I3*a3 */
    const double t29 = t28/t3; /* I3*a3/(R*R*I1) */
    out[21] = t29;
    const double t30 = params[3]/2.0; /* a3/2 */
    out[22] = t30;
    const double t31 = t12/t9; /* a3*m*g/(R*I1) */
    out[23] = t31;
    const double t32 = params[0]/2.0; /* m/2 */
    out[26] = t32;
    const double t33 = params[2]*2.0; /* g*2 */
    const double t34 = params[3]*t33; /* a3*g*2 */
    out[27] = t34;
    const double t35 = 1.0/params[0]; /* 1/m */
    out[28] = t35;
    const double t36 = params[4]/params[0]; /* I1/m */
    out[29] = t36;
    const double t37 = params[4]*params[4]; /* I1*I1 */
    const double t38 = t0*t37; /* R*R*I1*I1 */
    const double t39 = params[0]*params[5]; /* m*I3 */
    const double t40 = t38/t39; /* R*R*I1*I1/(m*I3) */
    out[30] = t40;
    const double t41 = params[1]/params[5]; /* R/I3 */
    out[32] = t41;
    const double t42 = params[4]/params[5]; /* I1/I3 */
    const double t43 = -t42; /* -I1/I3 */
    out[34] = t43;
    const double t44 = params[3]/params[1]; /* a3/R */
    out[35] = t44;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[8]*t3; /* I3/(R^2*I1)*b */
    const double t5 = p[7] + t2; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s^2 */
    const double t7 = JLT_FMA(p[9], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = t3*t7; /* b*D/I1 */
    const double t9 = t6*t8; /* Theta/(m*R^2*I1)*b*D/I1 */
    const double t10 = t2*t9; /* s^2*Theta/(m*R^2*I1)*b*D/I1 */
    const double t11 = 1.0/t10; /* 1/(s^2*Theta/(m*R^2*I1)*b*D/I1) */
    const double t12 = sqrt(t2); /* s = sqrt(s^2) */
    const double t13 = t2*t11; /* 1/(b*(D/I1)*(Theta/(m*R^2*I1))) = s^2*1/(s^2*Theta/(m*R^2*I1)*b*D/I1) */
    const double t14 = t6*t13; /* 1/(b*(D/I1)) = Theta/(m*R^2*I1)*1/(b*(D/I1)*(Theta/(m*R^2*I1))) */
    const double t15 = t8*t13; /* 1/(Theta/(m*R^2*I1)) = b*D/I1*1/(b*(D/I1)*(Theta/(m*R^2*I1))) */
    const double t16 = x[3]*t12; /* omega_n*s */
    const double t17 = t9*t16; /* Theta/(m*R^2*I1)*b*D/I1*omega_n*s */
    const double t18 = t11*t17; /* 1/(s^2*Theta/(m*R^2*I1)*b*D/I1)*Theta/(m*R^2*I1)*b*D/I1*omega_n*s */
    const double t19 = p[11] - t16; /* G_level/(R*I1) - omega_n*s */
    const double t20 = t7*t19; /* D/I1*(G_level/(R*I1) - omega_n*s) */
    const double t21 = t14*t20; /* 1/(b*(D/I1))*D/I1*(G_level/(R*I1) - omega_n*s) */
    const double t22 = t3*t14; /* b*1/(b*(D/I1)) */
    const double t23 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t24 = x[2]*t12; /* omega_tau*s */
    out[0] = t24;
    const double t25 = p[9]*t23; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t26 = t24*t25; /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t27 = JLT_FNMA(p[12], t12, t26); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s */
    const double t28 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t29 = JLT_FMA(x[2], t28, x[1]); /* V = omega_tau*e + v_nu */
    const double t30 = t4*t29; /* I3/(R^2*I1)*b*V */
    const double t31 = JLT_FNMA(t15, t30, t23); /* omega_tau*gamma3 - 1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*V */
    const double t32 = p[13] + t28; /* I3/(m*R) + e */
    const double t33 = x[2]*t32; /* omega_tau*(I3/(m*R) + e) */
    const double t34 = t15*t33; /* 1/(Theta/(m*R^2*I1))*omega_tau*(I3/(m*R) + e) */
    const double t35 = t18*t31; /* t18*(omega_tau*gamma3 - 1/(Theta/(m*R^2*I1))*I3/(R^2*I1)*b*V) */
    const double t36 = JLT_FNMA(t21, t34, t35); /* t35 - 1/(b*(D/I1))*D/I1*(G_level/(R*I1) - omega_n*s)*1/(Theta/(m*R^2*I1))*omega_tau*(I3/(m*R) + e) */
    out[3] = t36;
    const double t37 = x[3]*t18; /* omega_n*t18 */
    const double t38 = x[3]*t21; /* omega_n*1/(b*(D/I1))*D/I1*(G_level/(R*I1) - omega_n*s) */
    const double t39 = JLT_FNMA(x[0], t37, t27); /* omega_tau*s*m*a3^2/I1*omega_tau*gamma3 - m*g*a3/I1*s - gamma3*omega_n*t18 */
    const double t40 = t3*t37; /* b*omega_n*t18 */
    const double t41 = JLT_FNMA(p[10], t38, t40); /* b*omega_n*t18 - R^2*I1/I3*omega_n*1/(b*(D/I1))*D/I1*(G_level/(R*I1) - omega_n*s) */
    out[1] = t41;
    const double t42 = JLT_FMA(p[1], t38, t39); /* R*omega_n*1/(b*(D/I1))*D/I1*(G_level/(R*I1) - omega_n*s) + t39 */
    const double t43 = t22*t42; /* b*1/(b*(D/I1))*t42 */
    out[2] = t43;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = JLT_FMA(t2, p[9], 1.0); /* D/I1 = s^2*m*a3^2/I1 + 1 */
    const double t6 = t4*p[8]; /* b*I3/(R^2*I1) */
    const double t7 = t2 + p[7]; /* s^2 + I3/(m*R^2) */
    const double t8 = JLT_FMA(t4, t6, t7); /* Theta/(m*R^2*I1) = b*b*I3/(R^2*I1) + s^2 + I3/(m*R^2) */
    const double t9 = t2*t4; /* s^2*b */
    const double t10 = t5*t9; /* D/I1*s^2*b */
    const double t11 = t8*t10; /* Theta/(m*R^2*I1)*D/I1*s^2*b */
    const double t12 = 1.0/t11; /* 1/(Theta/(m*R^2*I1)*D/I1*s^2*b) */
    const double t13 = t8*t12; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s^2*b) */
    const double t14 = t5*t13; /* D/I1*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s^2*b) */
    const double t15 = t3*t4; /* s*b */
    const double t16 = t14*t15; /* D/I1*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s^2*b)*s*b */
    const double t17 = x[0]*t16; /* gamma3*D/I1*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s^2*b)*s*b */
    const double t18 = x[2]*t17; /* omega_tau*t17 */
    const double t19 = -t18; /* -omega_tau*t17 */
    out[0] = t19;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    const double t20 = JLT_FNMA(t3, x[3], p[11]); /* G_level/(R*I1) - s*omega_n */
    const double t21 = t2*t14; /* 1/b = s^2*D/I1*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s^2*b) */
    const double t22 = t20*t21; /* (G_level/(R*I1) - s*omega_n)*1/b */
    const double t23 = p[10]*t21; /* R^2*I1/I3*1/b */
    const double t24 = t22*t23; /* (G_level/(R*I1) - s*omega_n)*1/b*R^2*I1/I3*1/b */
    const double t25 = t16*x[3]; /* D/I1*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s^2*b)*s*b*omega_n */
    const double t26 = x[0]*t25; /* gamma3*t25 */
    const double t27 = t21*p[14]; /* 1/b*R*I1/I3 */
    const double t28 = JLT_FNMA(t26, t27, t24); /* d(omega3)/d(gamma3) = (G_level/(R*I1) - s*omega_n)*1/b*R^2*I1/I3*1/b - gamma3*t25*1/b*R*I1/I3 */
    const double t29 = t25 + t28; /* t25 + d(omega3)/d(gamma3) */
    const double t30 = p[1]*x[3]; /* R*omega_n */
    const double t31 = t29*t30; /* (t25 + d(omega3)/d(gamma3))*R*omega_n */
    const double t32 = t4*t25; /* b*t25 */
    const double t33 = t17*t32; /* t17*b*t25 */
    const double t34 = JLT_FMA(t25, t33, t31); /* t25*t17*b*t25 + (t25 + d(omega3)/d(gamma3))*R*omega_n */
    out[4] = t34;
    const double t35 = t3*t21; /* s*1/b */
    const double t36 = JLT_FMS(x[3], t35, t22); /* omega_n*s*1/b - (G_level/(R*I1) - s*omega_n)*1/b */
    const double t37 = p[10]*t36; /* R^2*I1/I3*(omega_n*s*1/b - (G_level/(R*I1) - s*omega_n)*1/b) */
    const double t38 = JLT_FMA(t32, 2.0, t37); /* b*t25*2 + R^2*I1/I3*(omega_n*s*1/b - (G_level/(R*I1) - s*omega_n)*1/b) */
    out[7] = t38;
    const double t39 = t9*t13; /* 1/(D/I1) = s^2*b*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s^2*b) */
    const double t40 = x[0]*t39; /* gamma3*1/(D/I1) */
    const double t41 = p[15]*t40; /* 2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t42 = t3*t41; /* s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t43 = t17 - t42; /* t17 - s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t44 = JLT_FMS(x[0], t43, t3); /* gamma3*(t17 - s*2*m*a3^2/I1*gamma3*1/(D/I1)) - s */
    const double t45 = x[2]*p[9]; /* omega_tau*m*a3^2/I1 */
    const double t46 = x[2]*t45; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t47 = t43*p[12]; /* (t17 - s*2*m*a3^2/I1*gamma3*1/(D/I1))*m*g*a3/I1 */
    const double t48 = t40*p[17]; /* gamma3*1/(D/I1)*2*m*R*a3^2/I1 */
    const double t49 = t22*t48; /* (G_level/(R*I1) - s*omega_n)*1/b*gamma3*1/(D/I1)*2*m*R*a3^2/I1 */
    const double t50 = JLT_FMS(t26, t41, t49); /* gamma3*t25*2*m*a3^2/I1*gamma3*1/(D/I1) - t49 */
    const double t51 = JLT_FMA(t28, p[16], t50); /* d(omega3)/d(gamma3)*I3/I1 + gamma3*t25*2*m*a3^2/I1*gamma3*1/(D/I1) - t49 */
    const double t52 = t16*t25; /* D/I1*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s^2*b)*s*b*t25 */
    const double t53 = JLT_FNMA(t25, t52, t47); /* (t17 - s*2*m*a3^2/I1*gamma3*1/(D/I1))*m*g*a3/I1 - t25*t52 */
    const double t54 = JLT_FNMA(t44, t46, t53); /* (t17 - s*2*m*a3^2/I1*gamma3*1/(D/I1))*m*g*a3/I1 - t25*t52 - (gamma3*(t17 - s*2*m*a3^2/I1*gamma3*1/(D/I1)) - s)*omega_tau*omega_tau*m*a3^2/I1 */
    const double t55 = JLT_FNMA(x[3], t51, t54); /* t54 - omega_n*t51 */
    const double t56 = t39*t55; /* 1/(D/I1)*(t54 - omega_n*t51) */
    out[8] = t56;
    const double t57 = x[2]*t42; /* omega_tau*s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    out[10] = t57;
    const double t58 = JLT_FMA(t36, p[18], t26); /* (omega_n*s*1/b - (G_level/(R*I1) - s*omega_n)*1/b)*1/2*R + gamma3*t25 */
    const double t59 = t39*(-2.0); /* 1/(D/I1)*(-2) */
    const double t60 = t58*t59; /* t58*1/(D/I1)*(-2) */
    out[11] = t60;
    const double t61 = JLT_FMS(t4, p[20], x[0]); /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = b*I3/(R*I1) - gamma3 */
    const double t62 = t10*t12; /* 1/(Theta/(m*R^2*I1)) = D/I1*s^2*b*1/(Theta/(m*R^2*I1)*D/I1*s^2*b) */
    const double t63 = t32*t62; /* b*t25*1/(Theta/(m*R^2*I1)) */
    const double t64 = p[19]*t61; /* 2*I3/(R^2*I1)*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t65 = t63*t64; /* b*t25*1/(Theta/(m*R^2*I1))*2*I3/(R^2*I1)*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t66 = p[8]*t16; /* I3/(R^2*I1)*D/I1*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s^2*b)*s*b */
    const double t67 = JLT_FNMA(t25, p[20], t65); /* t65 - t25*I3/(R*I1) */
    const double t68 = JLT_FNMA(t33, t66, t67); /* t65 - t25*I3/(R*I1) - t17*b*t25*t66 */
    const double t69 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t70 = JLT_FMA(x[2], t69, x[1]); /* V = omega_tau*e + v_nu */
    const double t71 = t62*t70; /* 1/(Theta/(m*R^2*I1))*V */
    const double t72 = t68*t71; /* (t65 - t25*I3/(R*I1) - t17*b*t25*t66)*1/(Theta/(m*R^2*I1))*V */
    const double t73 = t69 + p[13]; /* e + I3/(m*R) */
    const double t74 = t62*t73; /* 1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t75 = p[20]*t74; /* I3/(R*I1)*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t76 = t16*t52; /* D/I1*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*D/I1*s^2*b)*s*b*t52 */
    const double t77 = JLT_FNMA(t61, t74, p[22]); /* 1/2*a3 - d(Theta)/d(gamma3)/(2*m*R^2*I1)*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t78 = 2.0*t62; /* 2*1/(Theta/(m*R^2*I1)) */
    const double t79 = t22*t78; /* (G_level/(R*I1) - s*omega_n)*1/b*2*1/(Theta/(m*R^2*I1)) */
    const double t80 = JLT_FNMA(t77, t79, t76); /* t76 - t77*(G_level/(R*I1) - s*omega_n)*1/b*2*1/(Theta/(m*R^2*I1)) */
    const double t81 = JLT_FNMA(t63, p[21], t80); /* t80 - b*t25*1/(Theta/(m*R^2*I1))*a3*I3/(R^2*I1) */
    const double t82 = JLT_FMA(t28, t75, t81); /* d(omega3)/d(gamma3)*I3/(R*I1)*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) + t80 - b*t25*1/(Theta/(m*R^2*I1))*a3*I3/(R^2*I1) */
    const double t83 = JLT_FMA(x[2], t82, t72); /* omega_tau*t82 + (t65 - t25*I3/(R*I1) - t17*b*t25*t66)*1/(Theta/(m*R^2*I1))*V */
    out[12] = t83;
    const double t84 = p[8]*t63; /* I3/(R^2*I1)*b*t25*1/(Theta/(m*R^2*I1)) */
    const double t85 = -t84; /* -I3/(R^2*I1)*b*t25*1/(Theta/(m*R^2*I1)) */
    out[13] = t85;
    const double t86 = JLT_FNMA(t22, t74, t26); /* gamma3*t25 - (G_level/(R*I1) - s*omega_n)*1/b*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t87 = JLT_FNMA(t69, t84, t86); /* t86 - e*I3/(R^2*I1)*b*t25*1/(Theta/(m*R^2*I1)) */
    out[14] = t87;
    const double t88 = x[2]*t74; /* omega_tau*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) */
    const double t89 = t4*t71; /* b*1/(Theta/(m*R^2*I1))*V */
    const double t90 = JLT_FMA(t35, t88, t18); /* s*1/b*omega_tau*1/(Theta/(m*R^2*I1))*(e + I3/(m*R)) + omega_tau*t17 */
    const double t91 = JLT_FNMA(t66, t89, t90); /* t90 - t66*b*1/(Theta/(m*R^2*I1))*V */
    out[15] = t91;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[7] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[13] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = p[8]*t3; /* I3/(R^2*I1)*b */
    const double t5 = p[7] + t2; /* I3/(m*R^2) + s^2 */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s^2 */
    const double t7 = JLT_FMA(p[9], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = t2*t3; /* s^2*b */
    const double t9 = t6*t7; /* Theta/(m*R^2*I1)*D/I1 */
    const double t10 = t8*t9; /* s^2*b*Theta/(m*R^2*I1)*D/I1 */
    const double t11 = 1.0/t10; /* 1/(s^2*b*Theta/(m*R^2*I1)*D/I1) */
    const double t12 = t9*t11; /* Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1) */
    const double t13 = t8*t11; /* s^2*b*1/(s^2*b*Theta/(m*R^2*I1)*D/I1) */
    const double t14 = t7*t13; /* 1/(Theta/(m*R^2*I1)) = D/I1*s^2*b*1/(s^2*b*Theta/(m*R^2*I1)*D/I1) */
    const double t15 = t6*t13; /* 1/(D/I1) = Theta/(m*R^2*I1)*s^2*b*1/(s^2*b*Theta/(m*R^2*I1)*D/I1) */
    const double t16 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t16;
    const double t17 = t2*t12; /* 1/b = s^2*Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1) */
    const double t18 = t3*t16; /* b*s */
    const double t19 = t12*t18; /* Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1)*b*s */
    const double t20 = t4*t19; /* I3/(R^2*I1)*b*Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1)*b*s */
    const double t21 = x[3]*t16; /* omega_n*s */
    const double t22 = p[11] - t21; /* G_level/(R*I1) - omega_n*s */
    const double t23 = t17*t22; /* 1/b*(G_level/(R*I1) - omega_n*s) */
    const double t24 = JLT_FMS(t17, t21, t23); /* 1/b*omega_n*s - 1/b*(G_level/(R*I1) - omega_n*s) */
    const double t25 = x[2]*t16; /* omega_tau*s */
    out[0] = t25;
    const double t26 = p[23]*t16; /* m*g*a3/(R*I1)*s */
    const double t27 = JLT_FNMA(x[3], t23, t26); /* m*g*a3/(R*I1)*s - omega_n*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t28 = x[3]*t19; /* omega_n*Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1)*b*s */
    const double t29 = x[2]*p[9]; /* omega_tau*m*a3^2/I1 */
    const double t30 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t31 = t3*t28; /* b*t28 */
    const double t32 = JLT_FMS(p[20], t3, x[0]); /* d(Theta)/d(gamma3)/(2*m*R^2*I1) = I3/(R*I1)*b - gamma3 */
    const double t33 = 2.0*t32; /* 2*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t34 = t14*t33; /* 1/(Theta/(m*R^2*I1))*2*d(Theta)/d(gamma3)/(2*m*R^2*I1) */
    const double t35 = p[10]*t23; /* R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t36 = t25*t29; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t37 = x[3]*t28; /* omega_n*t28 */
    const double t38 = x[0]*t28; /* gamma3*t28 */
    const double t39 = p[13] + t30; /* I3/(m*R) + e */
    const double t40 = t14*t39; /* 1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t41 = p[8]*t14; /* I3/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t42 = t31*t41; /* b*t28*I3/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t43 = -t42; /* -b*t28*I3/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    out[17] = t43;
    const double t44 = t36 - t37; /* omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*t28 */
    const double t45 = x[0]*t15; /* gamma3*1/(D/I1) */
    const double t46 = t44*t45; /* (omega_tau*s*omega_tau*m*a3^2/I1 - omega_n*t28)*gamma3*1/(D/I1) */
    const double t47 = JLT_FMA(x[2], t30, x[1]); /* V = omega_tau*e + v_nu */
    const double t48 = x[0]*t19; /* gamma3*Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1)*b*s */
    const double t49 = JLT_FNMA(p[14], t38, t35); /* R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) - R*I1/I3*gamma3*t28 */
    const double t50 = t17*t49; /* 1/b*t49 */
    const double t51 = t31 - t35; /* b*t28 - R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s) */
    const double t52 = x[3]*t51; /* omega_n*(b*t28 - R^2*I1/I3*1/b*(G_level/(R*I1) - omega_n*s)) */
    out[1] = t52;
    const double t53 = t17*t25; /* 1/b*omega_tau*s */
    const double t54 = p[1]*t15; /* R*1/(D/I1) */
    const double t55 = JLT_FNMA(t27, t54, t46); /* t46 - (m*g*a3/(R*I1)*s - omega_n*1/b*(G_level/(R*I1) - omega_n*s))*R*1/(D/I1) */
    out[2] = t55;
    const double t56 = x[2]*t40; /* omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t57 = t42*t47; /* b*t28*I3/(R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t58 = t14*t47; /* 1/(Theta/(m*R^2*I1))*V */
    const double t59 = JLT_FMA(t14, t23, t42); /* 1/(Theta/(m*R^2*I1))*1/b*(G_level/(R*I1) - omega_n*s) + b*t28*I3/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    const double t60 = t19*t28; /* Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1)*b*s*t28 */
    const double t61 = JLT_FNMA(t28, t60, t36); /* omega_tau*s*omega_tau*m*a3^2/I1 - t28*t60 */
    const double t62 = t19*t60; /* Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1)*b*s*t60 */
    const double t63 = JLT_FNMA(p[3], t59, t62); /* t62 - a3*t59 */
    const double t64 = t19*t48; /* Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1)*b*s*t48 */
    const double t65 = x[2]*t48; /* omega_tau*t48 */
    const double t66 = t57*t64; /* b*t28*I3/(R^2*I1)*1/(Theta/(m*R^2*I1))*V*t64 */
    const double t67 = JLT_FMA(t23, t56, t57); /* 1/b*(G_level/(R*I1) - omega_n*s)*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) + b*t28*I3/(R^2*I1)*1/(Theta/(m*R^2*I1))*V */
    const double t68 = JLT_FMS(t34, t67, t66); /* 1/(Theta/(m*R^2*I1))*2*d(Theta)/d(gamma3)/(2*m*R^2*I1)*t67 - b*t28*I3/(R^2*I1)*1/(Theta/(m*R^2*I1))*V*t64 */
    const double t69 = JLT_FMA(x[2], t63, t68); /* omega_tau*(t62 - a3*t59) + t68 */
    const double t70 = JLT_FMS(x[2], t38, t67); /* omega_tau*gamma3*t28 - t67 */
    out[3] = t70;
    const double t71 = t50*t56; /* 1/b*t49*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t72 = JLT_FMS(t28, t58, t71); /* t28*1/(Theta/(m*R^2*I1))*V - 1/b*t49*omega_tau*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t73 = JLT_FNMA(p[20], t72, t69); /* omega_tau*(t62 - a3*t59) + t68 - I3/(R*I1)*t72 */
    out[16] = t73;
    const double t74 = JLT_FNMA(t20, t58, t65); /* omega_tau*t48 - t20*1/(Theta/(m*R^2*I1))*V */
    const double t75 = JLT_FMA(t40, t53, t74); /* 1/(Theta/(m*R^2*I1))*(I3/(m*R) + e)*1/b*omega_tau*s + omega_tau*t48 - t20*1/(Theta/(m*R^2*I1))*V */
    out[19] = t75;
    const double t76 = JLT_FNMA(t23, t40, t38); /* gamma3*t28 - 1/b*(G_level/(R*I1) - omega_n*s)*1/(Theta/(m*R^2*I1))*(I3/(m*R) + e) */
    const double t77 = JLT_FNMA(t30, t42, t76); /* t76 - e*b*t28*I3/(R^2*I1)*1/(Theta/(m*R^2*I1)) */
    out[18] = t77;
    const double t78 = x[3]*t50; /* omega_n*1/b*t49 */
    const double t79 = t37 + t78; /* omega_n*t28 + omega_n*1/b*t49 */
    const double t80 = JLT_FNMA(p[16], t78, t61); /* omega_tau*s*omega_tau*m*a3^2/I1 - t28*t60 - I3/I1*omega_n*1/b*t49 */
    const double t81 = p[1]*t79; /* R*(omega_n*t28 + omega_n*1/b*t49) */
    const double t82 = -t65; /* -omega_tau*t48 */
    out[4] = t82;
    const double t83 = p[15]*t45; /* 2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t84 = t25*t83; /* omega_tau*s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    out[14] = t84;
    const double t85 = t55*t83; /* t55*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t86 = p[12]*t19; /* m*g*a3/I1*Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1)*b*s */
    const double t87 = JLT_FNMA(t29, t65, t86); /* t86 - omega_tau*m*a3^2/I1*omega_tau*t48 */
    const double t88 = JLT_FMA(t45, t87, t85); /* gamma3*1/(D/I1)*(t86 - omega_tau*m*a3^2/I1*omega_tau*t48) + t55*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t89 = JLT_FMA(t15, t80, t88); /* 1/(D/I1)*t80 + t88 */
    out[12] = t89;
    const double t90 = t19*t31; /* Theta/(m*R^2*I1)*D/I1*1/(s^2*b*Theta/(m*R^2*I1)*D/I1)*b*s*b*t28 */
    const double t91 = JLT_FMA(t38, t90, t81); /* gamma3*t28*t90 + R*(omega_n*t28 + omega_n*1/b*t49) */
    out[8] = t91;
    const double t92 = JLT_FMA(p[18], t24, t38); /* 1/2*R*(1/b*omega_n*s - 1/b*(G_level/(R*I1) - omega_n*s)) + gamma3*t28 */
    const double t93 = p[10]*t24; /* R^2*I1/I3*(1/b*omega_n*s - 1/b*(G_level/(R*I1) - omega_n*s)) */
    const double t94 = JLT_FMA(2.0, t31, t93); /* 2*b*t28 + R^2*I1/I3*(1/b*omega_n*s - 1/b*(G_level/(R*I1) - omega_n*s)) */
    out[11] = t94;
    const double t95 = (-2.0)*t15; /* (-2)*1/(D/I1) */
    const double t96 = t92*t95; /* t92*(-2)*1/(D/I1) */
    out[15] = t96;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t4 = JLT_FMA(p[25], t2, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t5 = p[8]*t3; /* I3/(R^2*I1)*b */
    const double t6 = p[7] + t2; /* I3/(m*R^2) + s^2 */
    const double t7 = JLT_FMA(t3, t5, t6); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + I3/(m*R^2) + s^2 */
    const double t8 = t3*t4; /* b*D */
    const double t9 = t2*t8; /* s^2*b*D */
    const double t10 = t7*t9; /* Theta/(m*R^2*I1)*s^2*b*D */
    const double t11 = 1.0/t10; /* 1/(Theta/(m*R^2*I1)*s^2*b*D) */
    const double t12 = t9*t11; /* 1/(Theta/(m*R^2*I1)) = s^2*b*D*1/(Theta/(m*R^2*I1)*s^2*b*D) */
    const double t13 = t7*t11; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*b*D) */
    const double t14 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t15 = x[0]*p[24]; /* gamma3*2*m*a3^2 */
    const double t16 = t3*t15; /* b*gamma3*2*m*a3^2 */
    const double t17 = p[13] + t14; /* I3/(m*R) + e */
    const double t18 = t4*t17; /* D*(I3/(m*R) + e) */
    const double t19 = JLT_FMA(t12, t18, t16); /* 1/(Theta/(m*R^2*I1))*D*(I3/(m*R) + e) + b*gamma3*2*m*a3^2 */
    const double t20 = JLT_FMA(x[2], t14, x[1]); /* V = omega_tau*e + v_nu */
    const double t21 = t5*t20; /* I3/(R^2*I1)*b*V */
    const double t22 = t8*t21; /* b*D*I3/(R^2*I1)*b*V */
    const double t23 = t13*t22; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*b*D)*b*D*I3/(R^2*I1)*b*V */
    const double t24 = x[2]*t2; /* omega_tau*s^2 */
    const double t25 = t13*t24; /* Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*b*D)*omega_tau*s^2 */
    const double t26 = t19*t25; /* (1/(Theta/(m*R^2*I1))*D*(I3/(m*R) + e) + b*gamma3*2*m*a3^2)*Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*s^2*b*D)*omega_tau*s^2 */
    const double t27 = JLT_FNMA(t12, t23, t26); /* t26 - 1/(Theta/(m*R^2*I1))*t23 */
    const double t28 = sqrt(t2); /* s = sqrt(s^2) */
    const double t29 = t27*t28; /* (t26 - 1/(Theta/(m*R^2*I1))*t23)*s */
    out[0] = t29;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FMA(p[25], t2, p[4]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t5 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t6 = JLT_FNMA(x[3], t3, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t7 = t6/t5; /* (G_level/(R*I1) - omega_n*s)/b */
    const double t8 = x[3]*t5; /* omega_n*b */
    const double t9 = p[10]*t3; /* R^2*I1/I3*s */
    const double t10 = JLT_FNMA(t7, t9, t8); /* v_tau = omega_n*b - (G_level/(R*I1) - omega_n*s)/b*R^2*I1/I3*s */
    const double t11 = p[27]*x[0]; /* 2*g*a3*gamma3 */
    const double t12 = JLT_FMA(x[1], x[1], t11); /* v_nu*v_nu + 2*g*a3*gamma3 */
    const double t13 = p[28]*x[2]; /* 1/m*omega_tau */
    const double t14 = x[2]*t13; /* omega_tau*1/m*omega_tau */
    const double t15 = p[29]*x[3]; /* I1/m*omega_n */
    const double t16 = JLT_FMA(x[3], t15, t12); /* omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t17 = JLT_FMA(t4, t14, t16); /* D*omega_tau*1/m*omega_tau + omega_n*I1/m*omega_n + v_nu*v_nu + 2*g*a3*gamma3 */
    const double t18 = p[30]*t7; /* R^2*I1^2/(m*I3)*(G_level/(R*I1) - omega_n*s)/b */
    const double t19 = JLT_FMA(t7, t18, t17); /* (G_level/(R*I1) - omega_n*s)/b*R^2*I1^2/(m*I3)*(G_level/(R*I1) - omega_n*s)/b + t17 */
    const double t20 = JLT_FMA(t10, t10, t19); /* energy/(1/2*m) = v_tau*v_tau + t19 */
    const double t21 = p[26]*t20; /* 1/2*m*energy/(1/2*m) */
    out[0] = t21;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t4 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = t3*t4; /* s^2*b */
    const double t6 = 1.0/t5; /* 1/(s^2*b) */
    const double t7 = sqrt(t3); /* s = sqrt(s^2) */
    const double t8 = x[3]*p[33]; /* omega_n*R*I1 */
    const double t9 = JLT_FNMA(t7, t8, p[6]); /* G_level - s*omega_n*R*I1 */
    const double t10 = x[0]*t4; /* gamma3*b */
    const double t11 = t6*t10; /* 1/(s^2*b)*gamma3*b */
    const double t12 = t3*t6; /* 1/b = s^2*1/(s^2*b) */
    const double t13 = t9*t12; /* (G_level - s*omega_n*R*I1)*1/b */
    const double t14 = t7*t11; /* s*1/(s^2*b)*gamma3*b */
    const double t15 = p[14]*x[3]; /* R*I1/I3*omega_n */
    const double t16 = p[32]*t13; /* R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t17 = JLT_FMS(t14, t15, t16); /* s*1/(s^2*b)*gamma3*b*R*I1/I3*omega_n - R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t18 = t12*t17; /* 1/b*t17 */
    const double t19 = p[25]*x[0]; /* m*a3^2*gamma3 */
    const double t20 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t21 = JLT_FNMA(t19, t20, p[31]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t22 = JLT_FMA(t13, t18, t21); /* (G_level - s*omega_n*R*I1)*1/b*1/b*t17 + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t23 = JLT_FNMA(t7, t18, x[3]); /* omega_n - s*1/b*t17 */
    const double t24 = p[1]*t23; /* R*(omega_n - s*1/b*t17) */
    const double t25 = JLT_FMA(t14, t16, t24); /* d(v_tau)/d(gamma3) = s*1/(s^2*b)*gamma3*b*R/I3*(G_level - s*omega_n*R*I1)*1/b + R*(omega_n - s*1/b*t17) */
    const double t26 = x[3]*t4; /* omega_n*b */
    const double t27 = JLT_FNMA(t7, t16, t26); /* v_tau = omega_n*b - s*R/I3*(G_level - s*omega_n*R*I1)*1/b */
    const double t28 = p[14]*t7; /* R*I1/I3*s */
    const double t29 = t12*t28; /* 1/b*R*I1/I3*s */
    const double t30 = p[0]*t27; /* m*v_tau */
    const double t31 = JLT_FMA(t25, t30, t22); /* d(energy)/d(gamma3) = d(v_tau)/d(gamma3)*m*v_tau + t22 */
    out[0] = t31;
    const double t32 = x[3]*p[4]; /* omega_n*I1 */
    const double t33 = JLT_FNMA(t13, t29, t32); /* omega_n*I1 - (G_level - s*omega_n*R*I1)*1/b*1/b*R*I1/I3*s */
    const double t34 = p[10]*t3; /* R^2*I1/I3*s^2 */
    const double t35 = JLT_FMA(t12, t34, t4); /* d(v_tau)/d(omega_n) = 1/b*R^2*I1/I3*s^2 + b */
    const double t36 = JLT_FMA(t30, t35, t33); /* d(energy)/d(omega_n) = m*v_tau*d(v_tau)/d(omega_n) + omega_n*I1 - (G_level - s*omega_n*R*I1)*1/b*1/b*R*I1/I3*s */
    out[3] = t36;
    const double t37 = JLT_FMA(p[25], t3, p[4]); /* D = m*a3^2*s^2 + I1 */
    const double t38 = x[2]*t37; /* omega_tau*D */
    out[2] = t38;
}

static void eliminated(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t4 = JLT_FNMA(x[3], t3, p[11]); /* G_level/(R*I1) - omega_n*s */
    const double t5 = p[35] + x[0]; /* b/R = a3/R + gamma3 */
    const double t6 = p[34]/t5; /* (-I1/I3)/(b/R) */
    const double t7 = t4*t6; /* (G_level/(R*I1) - omega_n*s)*(-I1/I3)/(b/R) */
    out[0] = t7;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
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
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t14[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t15[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t16[k] = jlt_jet_product(t14, t15, k);
        t17[k] = jlt_jet_root(t16[k], t17, k);
        t18[k] = x0[k]*p[1] + (k == 0 ? p[3] : 0);
        t19[k] = p[9]*t16[k] + (k == 0 ? 1.0 : 0);
        t20[k] = (k == 0 ? p[7] : 0) + t16[k];
        t21[k] = p[8]*t18[k];
        t22[k] = jlt_jet_product(t18, t21, k) + t20[k];
        t23[k] = jlt_jet_product(t17, t18, k);
        t24[k] = jlt_jet_product(t19, t23, k);
        t25[k] = jlt_jet_product(t22, t24, k);
        t26[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t25, t26, k);
        t27[k] = jlt_jet_product(t22, t26, k);
        t28[k] = jlt_jet_product(t24, t26, k);
        t29[k] = jlt_jet_product(t19, t27, k);
        t30[k] = jlt_jet_product(t23, t27, k);
        t31[k] = jlt_jet_product(x2, x0, k);
        t32[k] = jlt_jet_product(x2, t17, k);
        t33[k] = jlt_jet_product(x3, t18, k);
        t34[k] = jlt_jet_product(t29, t33, k);
        t35[k] = (k == 0 ? p[11] : 0) - jlt_jet_product(x3, t17, k);
        t36[k] = jlt_jet_product(t17, t35, k);
        t37[k] = jlt_jet_product(t29, t36, k);
        t38[k] = p[9]*t31[k];
        t39[k] = jlt_jet_product(t32, t38, k);
        t40[k] = t39[k] - p[12]*t17[k];
        t41[k] = x0[k]*p[3] + (k == 0 ? p[1] : 0);
        t42[k] = jlt_jet_product(x2, t41, k) + x1[k];
        t43[k] = jlt_jet_product(t21, t42, k);
        t44[k] = t31[k] - jlt_jet_product(t28, t43, k);
        t45[k] = (k == 0 ? p[13] : 0) + t41[k];
        t46[k] = jlt_jet_product(x2, t45, k);
        t47[k] = jlt_jet_product(t28, t46, k);
        t48[k] = jlt_jet_product(t34, t44, k);
        t49[k] = t48[k] - jlt_jet_product(t37, t47, k);
        t50[k] = jlt_jet_product(x3, t34, k);
        t51[k] = jlt_jet_product(x3, t37, k);
        t52[k] = t40[k] - jlt_jet_product(x0, t50, k);
        t53[k] = jlt_jet_product(t18, t50, k);
        t54[k] = t53[k] - p[10]*t51[k];
        t55[k] = p[1]*t51[k] + t52[k];
        t56[k] = jlt_jet_product(t30, t55, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t32[k]/(k + 1);
        next[1] = x1[k + 1] = t54[k]/(k + 1);
        next[2] = x2[k + 1] = t56[k]/(k + 1);
        next[3] = x3[k + 1] = t49[k]/(k + 1);
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
    const double v_I3 = params[5];
    const double v_G_level = params[6];
    const double v_I1 = params[4];
    const double complex v_omega3 = (-(v_G_level - v_R*v_I1*v_omega_n*v_s)/(v_I3*v_b));
    out[1] = (v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3);
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
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
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
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

const jlt_descriptor jlt_kernels_spherical_top_general_on_level_G_omega3 = {
    .model = "spherical_top",
    .variant = "",
    .time = "",
    .elimination = "level_G_omega3",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "ac3caf3baf66336ef897cff1a23d6027f177d09e6646ad1a9a7f776485e5d28a",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top, .family = jlt_family_spherical_top, .claims = jlt_claims_spherical_top,
    .state_count = 4, .param_count = 7, .block_count = 36,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 26, 11, 1, 1, 0, 13, 11 }, { 15, 56, 0, 10, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level/(R*I1) - omega_n*s, e = gamma3*a3 + R, V = omega_tau*e + v_nu, omega_tau*gamma3 - 1/(Theta/(m*R^2*I1))*(I3/(R^2*I1))*b*V, I3/(m*R) + e, d(omega_n)/dt, d(v_nu)/dt, a part of d(omega_tau)/dt" },
    .jacobian = { jacobian, 16, { 8, 53, 29, 1, 1, 0, 17, 21 }, { 45, 230, 0, 42, 1, 0, 18, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level/(R*I1) - s*omega_n, d(omega3)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), omega_n*s*1/b - (G_level/(R*I1) - s*omega_n)*1/b, d(d(v_nu)/dt)/d(omega_n), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(omega_n), d(Theta)/d(gamma3)/(2*m*R^2*I1) = b*(I3/(R*I1)) - gamma3, a part of d(d(omega_n)/dt)/d(gamma3), e = gamma3*a3 + R, V = omega_tau*e + v_nu, e + I3/(m*R), a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_tau), d(d(omega_n)/dt)/d(omega_n)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 10, 55, 30, 1, 1, 0, 17, 27 }, { 52, 265, 0, 51, 1, 0, 18, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level/(R*I1) - omega_n*s, 1/b*omega_n*s - 1/b*(G_level/(R*I1) - omega_n*s), (m*g*a3/(R*I1))*s - omega_n*1/b*(G_level/(R*I1) - omega_n*s), e = gamma3*a3 + R, d(Theta)/d(gamma3)/(2*m*R^2*I1) = (I3/(R*I1))*b - gamma3, I3/(m*R) + e, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_n)/dt)/d(gamma3), a part of d(v_nu)/dt, d(omega_tau)/dt, a part of d(d(omega_n)/dt)/d(gamma3), a part of d(d(omega_n)/dt)/d(gamma3), a part of d(omega_n)/dt and of d(d(omega_n)/dt)/d(gamma3), d(omega_n)/dt, a part of d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(gamma3), d(d(omega_n)/dt)/d(omega_n), d(d(omega_n)/dt)/d(omega_tau), a part of d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(omega_n), d(d(v_nu)/dt)/d(omega_n)" },
    .divergence = { divergence, 1, { 4, 17, 7, 1, 1, 0, 12, 10 }, { 10, 39, 0, 4, 1, 0, 12, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, e = gamma3*a3 + R, I3/(m*R) + e, 1/(Theta/(m*R^2*I1))*D*(I3/(m*R) + e) + b*gamma3*(2*m*a3^2), V = omega_tau*e + v_nu, a part of the divergence" },
    .integral_values = { integral_values, 1, { 2, 9, 9, 1, 1, 0, 9, 7 }, { 10, 31, 0, 1, 1, 0, 13, 6 },
        "divides by b: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level/(R*I1) - omega_n*s, v_tau = omega_n*b - ((G_level/(R*I1) - omega_n*s)/b)*(R^2*I1/I3)*s, energy/(1/2*m)" },
    .integral_gradients = { integral_gradients, 4, { 2, 22, 13, 1, 1, 0, 13, 11 }, { 15, 53, 0, 6, 1, 0, 13, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by b: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, G_level - s*omega_n*(R*I1), a part of d(E)/d(gamma3), a part of d(E)/d(gamma3), d(v_tau)/d(gamma3), v_tau = omega_n*b - s*(R/I3)*(G_level - s*omega_n*(R*I1))*1/b, d(E)/d(gamma3), d(E)/d(omega_n)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { eliminated, 1, { 3, 2, 1, 1, 1, 0, 5, 3 }, { 3, 6, 0, 1, 1, 0, 6, 4 },
        "divides by b: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in G_level/(R*I1) - omega_n*s, b/R = a3/R + gamma3" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_general_on_level_G_omega3,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_general_on_level_G_omega3_baseline,
        &jlt_batch_spherical_top_general_on_level_G_omega3_avx2,
        &jlt_batch_spherical_top_general_on_level_G_omega3_avx512,
    },
#endif
};
