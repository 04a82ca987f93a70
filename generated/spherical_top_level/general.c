/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Table:      spherical_top_level, SHA-256 5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 5   31   12    1    1    0     17   10   (110)
 *  jacobian            11   60   32    1    1    0     18   27   (567)
 *  rhs_jacobian        10   58   34    1    1    0     18   27   (653)
 *  divergence          3   20   10    1    1    0     12    9   (60)
 *  integral_values     4    6    6    1    0    0      8    5   (40)
 *  integral_gradients  6   11    5    1    0    0     10    5   (59)
 *  observe_values      2   20   10    1    1    0     12   10   (66)
 *  valid_values        2   20   10    1    1    0     12   10   (66)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*v_tau*(R*I3) + (R*G)*s,
 *      v_tau*s - (G/I1)*b/R, gamma3*(R*(I1 - I3)) - (I3*a3), e = gamma3*a3 + R,
 *      (R*G)*gamma3*K*Theta/m*((1)/Theta/m*K*s^2*D/I1)*D/I1*s - v_tau*(R*I3),
 *      d(K)/d(gamma3) = (2*R^2*I3)*b/R - gamma3*(2*R^2*I1),
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(v_tau), V = omega_tau*e + v_nu,
 *      d(d(v_nu)/dt)/d(v_tau), v_nu - V*(I1*I3/m)*1/(Theta/m), d(d(v_tau)/dt)/d(omega_tau),
 *      a part of d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(v_nu),
 *      a part of d(v_tau)/dt and of d(d(v_tau)/dt)/d(gamma3), d(omega_tau)/dt,
 *      gamma3*v_tau*K*Theta/m*((1)/Theta/m*K*s^2*D/I1)*D/I1*s + G/I1, a part of d(d(v_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(v_tau), d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(v_tau),
 *      d(d(v_nu)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_chart_spherical_top_level_5[];
extern const char jlt_table_spherical_top_level[];
extern const jlt_claim jlt_claims_spherical_top_level[];
extern const jlt_descriptor *const jlt_family_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_general;
extern const struct jlt_ball_table jlt_balls_spherical_top_level_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[5]*params[5]; /* a3*a3 */
    const double t1 = params[0]*t0; /* m*a3*a3 */
    out[28] = t1;
    const double t2 = t1/params[3]; /* m*a3*a3/I1 */
    out[7] = t2;
    const double t3 = params[1]*params[6]; /* R*G */
    out[8] = t3;
    const double t4 = params[1]*params[4]; /* R*I3 */
    out[9] = t4;
    const double t5 = params[5]/params[1]; /* a3/R */
    out[10] = t5;
    const double t6 = params[1]*params[1]; /* R*R */
    const double t7 = params[3]*t6; /* I1*R*R */
    out[11] = t7;
    const double t8 = params[4]*t6; /* I3*R*R */
    out[12] = t8;
    const double t9 = params[3]*params[4]; /* I1*I3 */
    const double t10 = t9/params[0]; /* I1*I3/m */
    out[13] = t10;
    const double t11 = params[0]*params[2]; /* m*g */
    out[35] = t11;
    const double t12 = params[5]*t11; /* a3*m*g */
    out[30] = t12;
    const double t13 = t12/params[3]; /* a3*m*g/I1 */
    out[14] = t13;
    const double t14 = params[6]/params[3]; /* G/I1 */
    out[15] = t14;
    const double t15 = params[3]*params[1]; /* I1*R */
    const double t16 = params[4]*t15; /* I3*I1*R */
    const double t17 = t16/params[0]; /* I3*I1*R/m */
    out[16] = t17;
    const double t18 = params[3] - params[4]; /* I1 - I3 */
    const double t19 = params[1]*t18; /* R*(I1 - I3) */
    out[17] = t19;
    const double t20 = params[5]*params[4]; /* a3*I3 */
    out[18] = t20;
    const double t21 = t6*2.0; /* R*R*2 */
    const double t22 = params[3]*t21; /* I1*R*R*2 */
    out[19] = t22;
    const double t23 = params[4]*t21; /* I3*R*R*2 */
    out[20] = t23;
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = params[2]*t24; /* g*m*2 */
    const double t26 = params[5]*t25; /* a3*g*m*2 */
    const double t27 = t26/params[3]; /* a3*g*m*2/I1 */
    out[21] = t27;
    const double t28 = t0*t24; /* a3*a3*m*2 */
    out[25] = t28;
    const double t29 = t28/params[3]; /* a3*a3*m*2/I1 */
    out[22] = t29;
    const double t30 = params[5]*t9; /* a3*I1*I3 */
    const double t31 = t30/params[0]; /* a3*I1*I3/m */
    out[23] = t31;
    const double t32 = params[4]*t7; /* I3*I1*R*R */
    const double t33 = t18*t32; /* (I1 - I3)*I3*I1*R*R */
    const double t34 = t33/params[0]; /* (I1 - I3)*I3*I1*R*R/m */
    out[24] = t34;
    const double t35 = params[4]/t7; /* I3/(I1*R*R) */
    out[26] = t35;
    const double t36 = params[0]*t6; /* m*R*R */
    const double t37 = params[4]/t36; /* I3/(m*R*R) */
    out[27] = t37;
    const double t38 = params[1]*t6; /* R*R*R */
    const double t39 = params[0]*t38; /* m*R*R*R */
    const double t40 = params[3]*t39; /* I1*m*R*R*R */
    const double t41 = params[4]/t40; /* I3/(I1*m*R*R*R) */
    out[29] = t41;
    const double t42 = params[0]/2.0; /* m/2 */
    out[31] = t42;
    const double t43 = params[4]/params[3]; /* I3/I1 */
    out[32] = t43;
    const double t44 = params[3]*t36; /* I1*m*R*R */
    const double t45 = params[6]*params[6]; /* G*G */
    const double t46 = t45/t44; /* G*G/(I1*m*R*R) */
    out[33] = t46;
    const double t47 = t45/t7; /* G*G/(I1*R*R) */
    out[34] = t47;
    const double t48 = params[0]*params[5]; /* m*a3 */
    out[36] = t48;
    const double t49 = params[2]/params[3]; /* g/I1 */
    out[37] = t49;
    const double t50 = params[5]/params[3]; /* a3/I1 */
    out[38] = t50;
    const double t51 = params[6]/t15; /* G/(I1*R) */
    out[39] = t51;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0] + p[10]; /* b/R = gamma3 + a3/R */
    const double t4 = p[11]*t2; /* R^2*I1*s^2 */
    const double t5 = p[12]*t3; /* R^2*I3*b/R */
    const double t6 = JLT_FMA(t3, t5, t4); /* K = b/R*R^2*I3*b/R + R^2*I1*s^2 */
    const double t7 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = p[13] + t6; /* Theta/m = I1*I3/m + K */
    const double t9 = t2*t7; /* s^2*D/I1 */
    const double t10 = t8*t9; /* Theta/m*s^2*D/I1 */
    const double t11 = t6*t10; /* K*Theta/m*s^2*D/I1 */
    const double t12 = 1.0/t11; /* 1/(K*Theta/m*s^2*D/I1) */
    const double t13 = t6*t12; /* K*1/(K*Theta/m*s^2*D/I1) */
    const double t14 = t10*t12; /* 1/K = Theta/m*s^2*D/I1*1/(K*Theta/m*s^2*D/I1) */
    const double t15 = t8*t13; /* Theta/m*K*1/(K*Theta/m*s^2*D/I1) */
    const double t16 = t9*t13; /* 1/(Theta/m) = s^2*D/I1*K*1/(K*Theta/m*s^2*D/I1) */
    const double t17 = sqrt(t2); /* s = sqrt(s^2) */
    const double t18 = t7*t17; /* D/I1*s */
    const double t19 = t15*t18; /* Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s */
    const double t20 = t2*t15; /* s^2*Theta/m*K*1/(K*Theta/m*s^2*D/I1) */
    const double t21 = p[8]*t17; /* R*G*s */
    const double t22 = x[3]*p[9]; /* v_tau*R*I3 */
    const double t23 = JLT_FMA(t3, t22, t21); /* b/R*v_tau*R*I3 + R*G*s */
    const double t24 = t14*t23; /* 1/K*(b/R*v_tau*R*I3 + R*G*s) */
    const double t25 = t19*t24; /* Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*1/K*(b/R*v_tau*R*I3 + R*G*s) */
    const double t26 = x[3]*t25; /* v_tau*t25 */
    out[1] = t26;
    const double t27 = x[2]*t17; /* omega_tau*s */
    out[0] = t27;
    const double t28 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t29 = t27*t28; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t30 = JLT_FNMA(t24, t25, t29); /* omega_tau*s*omega_tau*m*a3^2/I1 - 1/K*(b/R*v_tau*R*I3 + R*G*s)*t25 */
    const double t31 = x[0]*t30; /* gamma3*t30 */
    const double t32 = p[9]*t24; /* R*I3*1/K*(b/R*v_tau*R*I3 + R*G*s) */
    const double t33 = JLT_FNMA(p[14], t17, t31); /* gamma3*t30 - m*g*a3/I1*s */
    const double t34 = x[3]*t17; /* v_tau*s */
    const double t35 = JLT_FNMA(p[15], t3, t34); /* v_tau*s - G/I1*b/R */
    const double t36 = t14*t35; /* 1/K*(v_tau*s - G/I1*b/R) */
    const double t37 = JLT_FNMA(t32, t36, t33); /* gamma3*t30 - m*g*a3/I1*s - R*I3*1/K*(b/R*v_tau*R*I3 + R*G*s)*1/K*(v_tau*s - G/I1*b/R) */
    const double t38 = t20*t37; /* s^2*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*t37 */
    out[2] = t38;
    const double t39 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t40 = JLT_FMA(x[2], t39, x[1]); /* V = omega_tau*e + v_nu */
    const double t41 = p[13]*t40; /* I1*I3/m*V */
    const double t42 = JLT_FNMA(t16, t41, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t43 = t25*t42; /* t25*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t44 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t45 = x[2]*p[16]; /* omega_tau*R*I1*I3/m */
    const double t46 = t44*t45; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t47 = t16*t46; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t48 = JLT_FMA(t36, t47, t43); /* 1/K*(v_tau*s - G/I1*b/R)*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m + t25*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t49 = -t48; /* -t48 */
    out[3] = t49;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[10]; /* b/R = gamma3 + a3/R */
    const double t4 = p[11]*t2; /* R^2*I1*s^2 */
    const double t5 = p[12]*t3; /* R^2*I3*b/R */
    const double t6 = JLT_FMA(t3, t5, t4); /* K = b/R*R^2*I3*b/R + R^2*I1*s^2 */
    const double t7 = p[13] + t6; /* Theta/m = I1*I3/m + K */
    const double t8 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t9 = t2*t7; /* s^2*Theta/m */
    const double t10 = t6*t8; /* K*D/I1 */
    const double t11 = t9*t10; /* s^2*Theta/m*K*D/I1 */
    const double t12 = 1.0/t11; /* 1/(s^2*Theta/m*K*D/I1) */
    const double t13 = t10*t12; /* K*D/I1*1/(s^2*Theta/m*K*D/I1) */
    const double t14 = t9*t12; /* s^2*Theta/m*1/(s^2*Theta/m*K*D/I1) */
    const double t15 = t8*t14; /* 1/K = D/I1*s^2*Theta/m*1/(s^2*Theta/m*K*D/I1) */
    const double t16 = t6*t14; /* 1/(D/I1) = K*s^2*Theta/m*1/(s^2*Theta/m*K*D/I1) */
    const double t17 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t17;
    const double t18 = t7*t17; /* Theta/m*s */
    const double t19 = t13*t18; /* K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s */
    const double t20 = t2*t13; /* 1/(Theta/m) = s^2*K*D/I1*1/(s^2*Theta/m*K*D/I1) */
    const double t21 = p[8]*t17; /* R*G*s */
    const double t22 = p[9]*t3; /* R*I3*b/R */
    const double t23 = JLT_FMA(x[3], t22, t21); /* v_tau*R*I3*b/R + R*G*s */
    const double t24 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t25 = p[16]*t24; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t26 = x[0]*t19; /* gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s */
    const double t27 = t15*t19; /* 1/K*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s */
    const double t28 = x[2]*t17; /* omega_tau*s */
    const double t29 = x[3]*t17; /* v_tau*s */
    const double t30 = JLT_FNMA(p[15], t3, t29); /* v_tau*s - G/I1*b/R */
    const double t31 = x[0]*p[19]; /* gamma3*2*R^2*I1 */
    const double t32 = JLT_FMS(p[20], t3, t31); /* d(K)/d(gamma3) = 2*R^2*I3*b/R - gamma3*2*R^2*I1 */
    const double t33 = t15*t23; /* 1/K*(v_tau*R*I3*b/R + R*G*s) */
    const double t34 = p[8]*t26; /* R*G*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s */
    const double t35 = JLT_FNMA(x[3], p[9], t34); /* R*G*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s - v_tau*R*I3 */
    const double t36 = t23*t27; /* (v_tau*R*I3*b/R + R*G*s)*1/K*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s */
    const double t37 = t19*t23; /* K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s*(v_tau*R*I3*b/R + R*G*s) */
    const double t38 = x[0]*t16; /* gamma3*1/(D/I1) */
    const double t39 = p[22]*t28; /* 2*m*a3^2/I1*omega_tau*s */
    const double t40 = t38*t39; /* gamma3*1/(D/I1)*2*m*a3^2/I1*omega_tau*s */
    out[10] = t40;
    const double t41 = p[9]*t16; /* R*I3*1/(D/I1) */
    const double t42 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t43 = t15*t25; /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t44 = JLT_FMA(t20, t25, t43); /* 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) + 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t45 = JLT_FNMA(t32, t44, p[24]); /* R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t44 */
    const double t46 = x[2]*t26; /* omega_tau*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s */
    const double t47 = t40 - t46; /* gamma3*1/(D/I1)*2*m*a3^2/I1*omega_tau*s - omega_tau*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s */
    const double t48 = -t46; /* -omega_tau*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s */
    out[0] = t48;
    const double t49 = x[2]*t47; /* omega_tau*t47 */
    const double t50 = t15*t30; /* 1/K*(v_tau*s - G/I1*b/R) */
    const double t51 = t36*t38; /* t36*gamma3*1/(D/I1) */
    const double t52 = 2.0*t33; /* 2*1/K*(v_tau*R*I3*b/R + R*G*s) */
    const double t53 = t16*t36; /* 1/(D/I1)*t36 */
    const double t54 = t36*t53; /* t36*1/(D/I1)*t36 */
    const double t55 = t16*t17; /* 1/(D/I1)*s */
    const double t56 = JLT_FNMA(p[14], t38, t54); /* t36*1/(D/I1)*t36 - m*g*a3/I1*gamma3*1/(D/I1) */
    const double t57 = t19*t56; /* K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s*(t36*1/(D/I1)*t36 - m*g*a3/I1*gamma3*1/(D/I1)) */
    const double t58 = JLT_FMA(x[3], t26, p[15]); /* v_tau*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s + G/I1 */
    const double t59 = t33*t41; /* 1/K*(v_tau*R*I3*b/R + R*G*s)*R*I3*1/(D/I1) */
    const double t60 = t41*t50; /* R*I3*1/(D/I1)*1/K*(v_tau*s - G/I1*b/R) */
    const double t61 = JLT_FMA(t32, t33, t35); /* d(K)/d(gamma3)*1/K*(v_tau*R*I3*b/R + R*G*s) + t35 */
    const double t62 = JLT_FMA(t32, t52, t35); /* d(K)/d(gamma3)*2*1/K*(v_tau*R*I3*b/R + R*G*s) + t35 */
    const double t63 = t17*t59; /* s*1/K*(v_tau*R*I3*b/R + R*G*s)*R*I3*1/(D/I1) */
    const double t64 = t58*t59; /* (v_tau*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s + G/I1)*1/K*(v_tau*R*I3*b/R + R*G*s)*R*I3*1/(D/I1) */
    const double t65 = JLT_FMA(t60, t62, t64); /* R*I3*1/(D/I1)*1/K*(v_tau*s - G/I1*b/R)*(d(K)/d(gamma3)*2*1/K*(v_tau*R*I3*b/R + R*G*s) + t35) + t64 */
    const double t66 = JLT_FMS(t26, t37, t61); /* gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s*t37 - (d(K)/d(gamma3)*1/K*(v_tau*R*I3*b/R + R*G*s) + t35) */
    const double t67 = t20*t37; /* 1/(Theta/m)*t37 */
    const double t68 = -t67; /* -1/(Theta/m)*t37 */
    out[13] = t68;
    const double t69 = JLT_FMA(x[2], t42, x[1]); /* V = omega_tau*e + v_nu */
    const double t70 = t32*t69; /* d(K)/d(gamma3)*V */
    const double t71 = p[13]*t20; /* I1*I3/m*1/(Theta/m) */
    const double t72 = JLT_FNMA(t69, t71, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t73 = t27*t72; /* 1/K*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t74 = t36*t71; /* t36*I1*I3/m*1/(Theta/m) */
    const double t75 = x[3]*t27; /* v_tau*1/K*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s */
    const double t76 = t42*t74; /* e*t36*I1*I3/m*1/(Theta/m) */
    const double t77 = t66*t75; /* t66*v_tau*1/K*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s */
    out[4] = t77;
    const double t78 = JLT_FMA(t22, t75, t36); /* R*I3*b/R*v_tau*1/K*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s + t36 */
    out[7] = t78;
    const double t79 = p[23]*t36; /* I1*I3*a3/m*t36 */
    const double t80 = JLT_FMA(t43, t58, t79); /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*(v_tau*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*Theta/m*s + G/I1) + I1*I3*a3/m*t36 */
    const double t81 = JLT_FNMA(t45, t50, t80); /* t80 - (R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t44)*1/K*(v_tau*s - G/I1*b/R) */
    const double t82 = x[2]*t81; /* omega_tau*t81 */
    const double t83 = JLT_FNMA(t70, t74, t82); /* omega_tau*t81 - d(K)/d(gamma3)*V*t36*I1*I3/m*1/(Theta/m) */
    const double t84 = t20*t43; /* 1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t85 = JLT_FNMA(t30, t84, t76); /* e*t36*I1*I3/m*1/(Theta/m) - (v_tau*s - G/I1*b/R)*1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    out[14] = t85;
    const double t86 = t66*t73; /* t66*t73 */
    const double t87 = JLT_FMS(t20, t83, t86); /* 1/(Theta/m)*(omega_tau*t81 - d(K)/d(gamma3)*V*t36*I1*I3/m*1/(Theta/m)) - t66*t73 */
    out[12] = t87;
    const double t88 = t22*t73; /* R*I3*b/R*t73 */
    const double t89 = JLT_FMA(t28, t84, t88); /* omega_tau*s*1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) + R*I3*b/R*t73 */
    const double t90 = -t89; /* -t89 */
    out[15] = t90;
    const double t91 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t92 = JLT_FNMA(p[21], t38, t91); /* omega_tau*omega_tau - 2*m*g*a3/I1*gamma3*1/(D/I1) */
    const double t93 = t55*t92; /* 1/(D/I1)*s*(omega_tau*omega_tau - 2*m*g*a3/I1*gamma3*1/(D/I1)) */
    const double t94 = 2.0*t51; /* 2*t36*gamma3*1/(D/I1) */
    const double t95 = JLT_FMA(t61, t94, t65); /* (d(K)/d(gamma3)*1/K*(v_tau*R*I3*b/R + R*G*s) + t35)*2*t36*gamma3*1/(D/I1) + t65 */
    const double t96 = JLT_FMS(t15, t95, t57); /* 1/K*t95 - t57 */
    const double t97 = t51 + t60; /* t36*gamma3*1/(D/I1) + R*I3*1/(D/I1)*1/K*(v_tau*s - G/I1*b/R) */
    const double t98 = JLT_FNMA(t52, t97, t49); /* omega_tau*t47 - 2*1/K*(v_tau*R*I3*b/R + R*G*s)*(t36*gamma3*1/(D/I1) + R*I3*1/(D/I1)*1/K*(v_tau*s - G/I1*b/R)) */
    const double t99 = JLT_FMA(t38, t98, t93); /* gamma3*1/(D/I1)*t98 + t93 */
    const double t100 = JLT_FMA(p[7], t99, t96); /* m*a3^2/I1*(gamma3*1/(D/I1)*t98 + t93) + 1/K*t95 - t57 */
    out[8] = t100;
    const double t101 = t60 + t94; /* R*I3*1/(D/I1)*1/K*(v_tau*s - G/I1*b/R) + 2*t36*gamma3*1/(D/I1) */
    const double t102 = JLT_FMA(t22, t101, t63); /* R*I3*b/R*t101 + s*1/K*(v_tau*R*I3*b/R + R*G*s)*R*I3*1/(D/I1) */
    const double t103 = t15*t102; /* 1/K*(R*I3*b/R*t101 + s*1/K*(v_tau*R*I3*b/R + R*G*s)*R*I3*1/(D/I1)) */
    const double t104 = -t103; /* -t103 */
    out[11] = t104;
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
    const double t3 = x[0] + p[10]; /* b/R = gamma3 + a3/R */
    const double t4 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t5 = p[11]*t2; /* R^2*I1*s^2 */
    const double t6 = p[12]*t3; /* R^2*I3*b/R */
    const double t7 = JLT_FMA(t3, t6, t5); /* K = b/R*R^2*I3*b/R + R^2*I1*s^2 */
    const double t8 = t2*t4; /* s^2*D/I1 */
    const double t9 = p[13] + t7; /* Theta/m = I1*I3/m + K */
    const double t10 = t7*t8; /* K*s^2*D/I1 */
    const double t11 = t9*t10; /* Theta/m*K*s^2*D/I1 */
    const double t12 = 1.0/t11; /* 1/(Theta/m*K*s^2*D/I1) */
    const double t13 = t9*t12; /* Theta/m*1/(Theta/m*K*s^2*D/I1) */
    const double t14 = t10*t12; /* 1/(Theta/m) = K*s^2*D/I1*1/(Theta/m*K*s^2*D/I1) */
    const double t15 = t8*t13; /* 1/K = s^2*D/I1*Theta/m*1/(Theta/m*K*s^2*D/I1) */
    const double t16 = t7*t13; /* K*Theta/m*1/(Theta/m*K*s^2*D/I1) */
    const double t17 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t17;
    const double t18 = t4*t17; /* D/I1*s */
    const double t19 = t16*t18; /* K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s */
    const double t20 = t2*t16; /* 1/(D/I1) = s^2*K*Theta/m*1/(Theta/m*K*s^2*D/I1) */
    const double t21 = p[8]*t17; /* R*G*s */
    const double t22 = x[3]*p[9]; /* v_tau*R*I3 */
    const double t23 = JLT_FMA(t3, t22, t21); /* b/R*v_tau*R*I3 + R*G*s */
    const double t24 = t15*t23; /* 1/K*(b/R*v_tau*R*I3 + R*G*s) */
    const double t25 = x[3]*t17; /* v_tau*s */
    const double t26 = JLT_FNMA(p[15], t3, t25); /* v_tau*s - G/I1*b/R */
    const double t27 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t28 = p[16]*t27; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t29 = t15*t28; /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t30 = p[9]*t15; /* R*I3*1/K */
    const double t31 = t19*t24; /* K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s*1/K*(b/R*v_tau*R*I3 + R*G*s) */
    const double t32 = x[0]*t20; /* gamma3*1/(D/I1) */
    const double t33 = t26*t30; /* (v_tau*s - G/I1*b/R)*R*I3*1/K */
    const double t34 = t20*t33; /* 1/(D/I1)*(v_tau*s - G/I1*b/R)*R*I3*1/K */
    const double t35 = t31*t32; /* t31*gamma3*1/(D/I1) */
    const double t36 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t37 = t14*t29; /* 1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t38 = x[0]*t19; /* gamma3*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s */
    const double t39 = JLT_FMS(p[8], t38, t22); /* R*G*gamma3*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s - v_tau*R*I3 */
    const double t40 = t15*t39; /* 1/K*t39 */
    const double t41 = x[0]*p[19]; /* gamma3*2*R^2*I1 */
    const double t42 = JLT_FMS(p[20], t3, t41); /* d(K)/d(gamma3) = 2*R^2*I3*b/R - gamma3*2*R^2*I1 */
    const double t43 = t3*t30; /* b/R*R*I3*1/K */
    const double t44 = t24*t30; /* 1/K*(b/R*v_tau*R*I3 + R*G*s)*R*I3*1/K */
    const double t45 = x[2]*t17; /* omega_tau*s */
    out[0] = t45;
    const double t46 = t17*t20; /* s*1/(D/I1) */
    const double t47 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t48 = t34 + t35; /* 1/(D/I1)*(v_tau*s - G/I1*b/R)*R*I3*1/K + t31*gamma3*1/(D/I1) */
    const double t49 = t24*t48; /* 1/K*(b/R*v_tau*R*I3 + R*G*s)*(1/(D/I1)*(v_tau*s - G/I1*b/R)*R*I3*1/K + t31*gamma3*1/(D/I1)) */
    const double t50 = JLT_FMA(2.0, t35, t34); /* 2*t31*gamma3*1/(D/I1) + 1/(D/I1)*(v_tau*s - G/I1*b/R)*R*I3*1/K */
    const double t51 = JLT_FMA(x[2], t36, x[1]); /* V = omega_tau*e + v_nu */
    const double t52 = p[13]*t14; /* I1*I3/m*1/(Theta/m) */
    const double t53 = t26*t37; /* (v_tau*s - G/I1*b/R)*1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t54 = p[24]*t26; /* R^2*I1*I3*(I1 - I3)/m*(v_tau*s - G/I1*b/R) */
    const double t55 = x[3]*t19; /* v_tau*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s */
    const double t56 = JLT_FMA(t43, t55, t31); /* b/R*R*I3*1/K*v_tau*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s + t31 */
    out[11] = t56;
    const double t57 = p[23]*t31; /* I1*I3*a3/m*t31 */
    const double t58 = JLT_FNMA(t15, t54, t57); /* I1*I3*a3/m*t31 - 1/K*R^2*I1*I3*(I1 - I3)/m*(v_tau*s - G/I1*b/R) */
    const double t59 = t15*t42; /* 1/K*d(K)/d(gamma3) */
    const double t60 = t45*t47; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t61 = JLT_FNMA(t51, t52, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t62 = t31*t52; /* t31*I1*I3/m*1/(Theta/m) */
    const double t63 = JLT_FMS(t36, t62, t53); /* e*t31*I1*I3/m*1/(Theta/m) - t53 */
    out[18] = t63;
    const double t64 = x[2]*t53; /* omega_tau*t53 */
    const double t65 = JLT_FMS(t51, t62, t64); /* V*t31*I1*I3/m*1/(Theta/m) - omega_tau*t53 */
    const double t66 = t62 - t31; /* t31*I1*I3/m*1/(Theta/m) - t31 */
    out[17] = t66;
    const double t67 = JLT_FMA(t31, t61, t64); /* t31*(v_nu - V*I1*I3/m*1/(Theta/m)) + omega_tau*t53 */
    const double t68 = t19*t61; /* K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t69 = -t67; /* -(t31*(v_nu - V*I1*I3/m*1/(Theta/m)) + omega_tau*t53) */
    out[3] = t69;
    const double t70 = t59*t67; /* 1/K*d(K)/d(gamma3)*(t31*(v_nu - V*I1*I3/m*1/(Theta/m)) + omega_tau*t53) */
    const double t71 = t19*t31; /* K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s*t31 */
    const double t72 = JLT_FNMA(t31, t71, t60); /* omega_tau*s*omega_tau*m*a3^2/I1 - t31*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s*t31 */
    const double t73 = JLT_FMS(t32, t60, t49); /* gamma3*1/(D/I1)*omega_tau*s*omega_tau*m*a3^2/I1 - t49 */
    const double t74 = p[14]*t19; /* m*g*a3/I1*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s */
    const double t75 = JLT_FNMA(p[14], t46, t73); /* gamma3*1/(D/I1)*omega_tau*s*omega_tau*m*a3^2/I1 - t49 - m*g*a3/I1*s*1/(D/I1) */
    out[2] = t75;
    const double t76 = JLT_FMA(x[0], t55, p[15]); /* gamma3*v_tau*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s + G/I1 */
    const double t77 = JLT_FMA(t29, t76, t58); /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*(gamma3*v_tau*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s + G/I1) + t58 */
    const double t78 = JLT_FMA(t44, t76, t72); /* 1/K*(b/R*v_tau*R*I3 + R*G*s)*R*I3*1/K*(gamma3*v_tau*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s + G/I1) + t72 */
    const double t79 = x[2]*t77; /* omega_tau*t77 */
    const double t80 = JLT_FMS(t42, t65, t79); /* d(K)/d(gamma3)*(V*t31*I1*I3/m*1/(Theta/m) - omega_tau*t53) - omega_tau*t77 */
    const double t81 = x[2]*t38; /* omega_tau*gamma3*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s */
    const double t82 = JLT_FNMA(t47, t81, t74); /* m*g*a3/I1*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s - omega_tau*m*a3^2/I1*omega_tau*gamma3*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s */
    const double t83 = JLT_FMA(p[22], t75, t82); /* 2*m*a3^2/I1*t75 + t82 */
    const double t84 = -t81; /* -omega_tau*gamma3*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s */
    out[4] = t84;
    const double t85 = JLT_FMS(t31, t38, t40); /* t31*gamma3*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s - 1/K*t39 */
    const double t86 = t40*t50; /* 1/K*t39*t50 */
    const double t87 = x[3]*t31; /* v_tau*t31 */
    out[1] = t87;
    const double t88 = t43*t50; /* b/R*R*I3*1/K*t50 */
    const double t89 = JLT_FMA(t44, t46, t88); /* 1/K*(b/R*v_tau*R*I3 + R*G*s)*R*I3*1/K*s*1/(D/I1) + b/R*R*I3*1/K*t50 */
    const double t90 = -t89; /* -t89 */
    out[15] = t90;
    const double t91 = t43*t68; /* b/R*R*I3*1/K*t68 */
    const double t92 = JLT_FNMA(t68, t85, t70); /* t70 - t68*(t31*gamma3*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s - 1/K*t39) */
    const double t93 = JLT_FNMA(t14, t80, t92); /* t92 - 1/(Theta/m)*t80 */
    out[16] = t93;
    const double t94 = JLT_FMA(t37, t45, t91); /* 1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*s + b/R*R*I3*1/K*t68 */
    const double t95 = -t94; /* -t94 */
    out[19] = t95;
    const double t96 = t59*t87; /* 1/K*d(K)/d(gamma3)*v_tau*t31 */
    const double t97 = JLT_FMS(t55, t85, t96); /* v_tau*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s*(t31*gamma3*K*Theta/m*1/(Theta/m*K*s^2*D/I1)*D/I1*s - 1/K*t39) - 1/K*d(K)/d(gamma3)*v_tau*t31 */
    out[8] = t97;
    const double t98 = 2.0*t59; /* 2*1/K*d(K)/d(gamma3) */
    const double t99 = JLT_FMA(t49, t98, t86); /* t49*2*1/K*d(K)/d(gamma3) + 1/K*t39*t50 */
    const double t100 = JLT_FMA(t20, t78, t99); /* 1/(D/I1)*t78 + t49*2*1/K*d(K)/d(gamma3) + 1/K*t39*t50 */
    const double t101 = JLT_FMA(t32, t83, t100); /* gamma3*1/(D/I1)*(2*m*a3^2/I1*t75 + t82) + 1/(D/I1)*t78 + t49*2*1/K*d(K)/d(gamma3) + 1/K*t39*t50 */
    out[12] = t101;
    const double t102 = p[22]*t45; /* 2*m*a3^2/I1*omega_tau*s */
    const double t103 = t32*t102; /* gamma3*1/(D/I1)*2*m*a3^2/I1*omega_tau*s */
    out[14] = t103;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t4 = p[26]*t3; /* I3/(R^2*I1)*b */
    const double t5 = JLT_FMA(t3, t4, t2); /* K/(R^2*I1) = b*I3/(R^2*I1)*b + s^2 */
    const double t6 = JLT_FMA(p[28], t2, p[3]); /* D = m*a3^2*s^2 + I1 */
    const double t7 = p[27] + t5; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t8 = t5*t6; /* K/(R^2*I1)*D */
    const double t9 = p[25]*t5; /* 2*m*a3^2*K/(R^2*I1) */
    const double t10 = t7*t8; /* Theta/(m*R^2*I1)*K/(R^2*I1)*D */
    const double t11 = t2*t10; /* s^2*Theta/(m*R^2*I1)*K/(R^2*I1)*D */
    const double t12 = 1.0/t11; /* 1/(s^2*Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t13 = t10*t12; /* 1/s^2 = Theta/(m*R^2*I1)*K/(R^2*I1)*D*1/(s^2*Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t14 = t2*t12; /* 1/(D*(K/(R^2*I1))*(Theta/(m*R^2*I1))) = s^2*1/(s^2*Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t15 = sqrt(t2); /* s = sqrt(s^2) */
    const double t16 = t7*t14; /* 1/(D*(K/(R^2*I1))) = Theta/(m*R^2*I1)*1/(D*(K/(R^2*I1))*(Theta/(m*R^2*I1))) */
    const double t17 = t8*t14; /* 1/(Theta/(m*R^2*I1)) = K/(R^2*I1)*D*1/(D*(K/(R^2*I1))*(Theta/(m*R^2*I1))) */
    const double t18 = JLT_FMS(t9, t16, t13); /* 2*m*a3^2*K/(R^2*I1)*1/(D*(K/(R^2*I1))) - 1/s^2 */
    const double t19 = t4*t13; /* I3/(R^2*I1)*b*1/s^2 */
    const double t20 = t6*t15; /* D*s */
    const double t21 = t16*t20; /* 1/(D*(K/(R^2*I1)))*D*s */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = p[27]*t23; /* I3/(m*R^2)*V */
    const double t25 = JLT_FNMA(t17, t24, x[1]); /* v_nu - 1/(Theta/(m*R^2*I1))*I3/(m*R^2)*V */
    const double t26 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t27 = x[2]*p[29]; /* omega_tau*I3/(m*R^3*I1) */
    const double t28 = t26*t27; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3/(m*R^3*I1) */
    const double t29 = t17*t28; /* 1/(Theta/(m*R^2*I1))*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3/(m*R^3*I1) */
    const double t30 = JLT_FMA(t19, t25, t29); /* I3/(R^2*I1)*b*1/s^2*(v_nu - 1/(Theta/(m*R^2*I1))*I3/(m*R^2)*V) + t29 */
    const double t31 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t32 = t15*t31; /* s*gamma3*omega_tau */
    const double t33 = t18*t32; /* (2*m*a3^2*K/(R^2*I1)*1/(D*(K/(R^2*I1))) - 1/s^2)*s*gamma3*omega_tau */
    const double t34 = JLT_FNMA(t21, t30, t33); /* t33 - 1/(D*(K/(R^2*I1)))*D*s*t30 */
    out[0] = t34;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[10]; /* b/R = gamma3 + a3/R */
    const double t4 = p[32]*t3; /* I3/I1*b/R */
    const double t5 = JLT_FMA(t3, t4, t2); /* K/(R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(gamma3 + 1) */
    const double t6 = JLT_FMA(p[28], t2, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t7 = p[27] + t5; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t8 = x[3]*x[3]; /* v_tau*v_tau */
    const double t9 = JLT_FMA(t7, t8, p[33]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t10 = t9/t5; /* (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t11 = JLT_FMA(x[1], x[1], t10); /* v_nu*v_nu + (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = p[30]*x[0]; /* m*g*a3*gamma3 */
    const double t15 = JLT_FMA(t6, t13, t14); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(p[31], t11, t15); /* 1/2*m*t11 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    out[0] = t16;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = x[0] + p[10]; /* b/R = gamma3 + a3/R */
    const double t5 = p[32]*t4; /* I3/I1*b/R */
    const double t6 = JLT_FMA(t4, t5, t3); /* K/(R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(gamma3 + 1) */
    const double t7 = t5 - x[0]; /* d(K)/d(gamma3)/(2*R^2*I1) = I3/I1*b/R - gamma3 */
    const double t8 = JLT_FMA(p[28], t3, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t9 = x[2]*t8; /* omega_tau*D */
    out[2] = t9;
    const double t10 = p[27] + t6; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t11 = 1.0/t6; /* 1/(K/(R^2*I1)) */
    const double t12 = t7*t11; /* d(K)/d(gamma3)/(2*R^2*I1)*1/(K/(R^2*I1)) */
    const double t13 = x[3]*p[0]; /* v_tau*m */
    const double t14 = t10*t13; /* Theta/(m*R^2*I1)*v_tau*m */
    const double t15 = t11*t14; /* 1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m */
    out[3] = t15;
    const double t16 = t15 - t13; /* 1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m - v_tau*m */
    const double t17 = x[3]*t16; /* v_tau*(1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m - v_tau*m) */
    const double t18 = JLT_FMA(p[34], t11, t17); /* G^2/(R^2*I1)*1/(K/(R^2*I1)) + v_tau*(1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m - v_tau*m) */
    const double t19 = p[28]*x[0]; /* m*a3^2*gamma3 */
    const double t20 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t21 = JLT_FNMA(t19, t20, p[30]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t22 = JLT_FNMA(t12, t18, t21); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau - d(K)/d(gamma3)/(2*R^2*I1)*1/(K/(R^2*I1))*t18 */
    out[0] = t22;
}

static void observe_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t4 = p[4]*t3; /* I3*b */
    const double t5 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t6 = p[11]*t2; /* R^2*I1*s^2 */
    const double t7 = JLT_FMA(t3, t4, t6); /* K = b*I3*b + R^2*I1*s^2 */
    const double t8 = t2*t5; /* s^2*D/I1 */
    const double t9 = x[0]*t5; /* gamma3*D/I1 */
    const double t10 = t7*t8; /* K*s^2*D/I1 */
    const double t11 = 1.0/t10; /* 1/(K*s^2*D/I1) */
    const double t12 = t8*t11; /* 1/K = s^2*D/I1*1/(K*s^2*D/I1) */
    const double t13 = sqrt(t2); /* s = sqrt(s^2) */
    const double t14 = t7*t13; /* K*s */
    const double t15 = t11*t14; /* 1/(K*s^2*D/I1)*K*s */
    const double t16 = t2*t15; /* s^2*1/(K*s^2*D/I1)*K*s */
    const double t17 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t18 = x[2]*t17; /* omega_tau*gamma3*omega_tau */
    const double t19 = p[8]*t13; /* R*G*s */
    const double t20 = JLT_FMA(x[3], t4, t19); /* v_tau*I3*b + R*G*s */
    const double t21 = t9*t20; /* gamma3*D/I1*(v_tau*I3*b + R*G*s) */
    const double t22 = t15*t21; /* 1/(K*s^2*D/I1)*K*s*gamma3*D/I1*(v_tau*I3*b + R*G*s) */
    const double t23 = t12*t20; /* 1/K*(v_tau*I3*b + R*G*s) */
    const double t24 = t12*t23; /* 1/K*1/K*(v_tau*I3*b + R*G*s) */
    const double t25 = JLT_FNMA(p[38], t18, p[37]); /* g/I1 - a3/I1*omega_tau*gamma3*omega_tau */
    const double t26 = p[36]*t25; /* m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t27 = t13*t26; /* s*m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t28 = x[3]*t13; /* v_tau*s */
    const double t29 = JLT_FNMA(p[39], t3, t28); /* v_tau*s - G/(R*I1)*b */
    const double t30 = JLT_FMA(p[9], t29, t22); /* R*I3*(v_tau*s - G/(R*I1)*b) + 1/(K*s^2*D/I1)*K*s*gamma3*D/I1*(v_tau*I3*b + R*G*s) */
    const double t31 = JLT_FMA(t24, t30, t27); /* 1/K*1/K*(v_tau*I3*b + R*G*s)*t30 + s*m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t32 = JLT_FMA(t16, t31, t18); /* s^2*1/(K*s^2*D/I1)*K*s*t31 + omega_tau*gamma3*omega_tau */
    const double t33 = JLT_FNMA(p[36], t32, p[35]); /* contact_force = m*g - m*a3*(s^2*1/(K*s^2*D/I1)*K*s*t31 + omega_tau*gamma3*omega_tau) */
    out[0] = t33;
}

static void valid_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t4 = p[4]*t3; /* I3*b */
    const double t5 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t6 = p[11]*t2; /* R^2*I1*s^2 */
    const double t7 = JLT_FMA(t3, t4, t6); /* K = b*I3*b + R^2*I1*s^2 */
    const double t8 = t2*t5; /* s^2*D/I1 */
    const double t9 = x[0]*t5; /* gamma3*D/I1 */
    const double t10 = t7*t8; /* K*s^2*D/I1 */
    const double t11 = 1.0/t10; /* 1/(K*s^2*D/I1) */
    const double t12 = t8*t11; /* 1/K = s^2*D/I1*1/(K*s^2*D/I1) */
    const double t13 = sqrt(t2); /* s = sqrt(s^2) */
    const double t14 = t7*t13; /* K*s */
    const double t15 = t11*t14; /* 1/(K*s^2*D/I1)*K*s */
    const double t16 = t2*t15; /* s^2*1/(K*s^2*D/I1)*K*s */
    const double t17 = x[0]*x[2]; /* gamma3*omega_tau */
    const double t18 = x[2]*t17; /* omega_tau*gamma3*omega_tau */
    const double t19 = p[8]*t13; /* R*G*s */
    const double t20 = JLT_FMA(x[3], t4, t19); /* v_tau*I3*b + R*G*s */
    const double t21 = t9*t20; /* gamma3*D/I1*(v_tau*I3*b + R*G*s) */
    const double t22 = t15*t21; /* 1/(K*s^2*D/I1)*K*s*gamma3*D/I1*(v_tau*I3*b + R*G*s) */
    const double t23 = t12*t20; /* 1/K*(v_tau*I3*b + R*G*s) */
    const double t24 = t12*t23; /* 1/K*1/K*(v_tau*I3*b + R*G*s) */
    const double t25 = JLT_FNMA(p[38], t18, p[37]); /* g/I1 - a3/I1*omega_tau*gamma3*omega_tau */
    const double t26 = p[36]*t25; /* m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t27 = t13*t26; /* s*m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t28 = x[3]*t13; /* v_tau*s */
    const double t29 = JLT_FNMA(p[39], t3, t28); /* v_tau*s - G/(R*I1)*b */
    const double t30 = JLT_FMA(p[9], t29, t22); /* R*I3*(v_tau*s - G/(R*I1)*b) + 1/(K*s^2*D/I1)*K*s*gamma3*D/I1*(v_tau*I3*b + R*G*s) */
    const double t31 = JLT_FMA(t24, t30, t27); /* 1/K*1/K*(v_tau*I3*b + R*G*s)*t30 + s*m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t32 = JLT_FMA(t16, t31, t18); /* s^2*1/(K*s^2*D/I1)*K*s*t31 + omega_tau*gamma3*omega_tau */
    const double t33 = JLT_FNMA(p[36], t32, p[35]); /* contact_force = m*g - m*a3*(s^2*1/(K*s^2*D/I1)*K*s*t31 + omega_tau*gamma3*omega_tau) */
    out[0] = t33;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
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
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t19[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t20[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t21[k] = jlt_jet_product(t19, t20, k);
        t22[k] = x0[k] + (k == 0 ? p[10] : 0);
        t23[k] = p[11]*t21[k];
        t24[k] = p[12]*t22[k];
        t25[k] = jlt_jet_product(t22, t24, k) + t23[k];
        t26[k] = jlt_jet_root(t21[k], t26, k);
        t27[k] = p[7]*t21[k] + (k == 0 ? 1.0 : 0);
        t28[k] = p[8]*t26[k];
        t29[k] = x3[k]*p[9];
        t30[k] = jlt_jet_product(t22, t29, k) + t28[k];
        t31[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t25, t31, k);
        t32[k] = jlt_jet_product(t30, t31, k);
        t33[k] = (k == 0 ? p[13] : 0) + t25[k];
        t34[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t33, t34, k);
        t35[k] = jlt_jet_product(x2, t26, k);
        t36[k] = x2[k]*p[7];
        t37[k] = jlt_jet_product(t35, t36, k);
        t38[k] = jlt_jet_quotient(t32[k], t26, t38, k);
        t39[k] = t37[k] - jlt_jet_product(t32, t38, k);
        t40[k] = jlt_jet_product(x0, t39, k);
        t41[k] = p[9]*t32[k];
        t42[k] = t40[k] - p[14]*t26[k];
        t43[k] = jlt_jet_product(x3, t26, k);
        t44[k] = t43[k] - p[15]*t22[k];
        t45[k] = jlt_jet_product(t31, t44, k);
        t46[k] = t42[k] - jlt_jet_product(t41, t45, k);
        t47[k] = jlt_jet_quotient(t46[k], t27, t47, k);
        t48[k] = jlt_jet_product(x3, t38, k);
        t49[k] = x0[k]*p[5] + (k == 0 ? p[1] : 0);
        t50[k] = jlt_jet_product(x2, t49, k) + x1[k];
        t51[k] = p[13]*t50[k];
        t52[k] = x1[k] - jlt_jet_product(t34, t51, k);
        t53[k] = jlt_jet_product(t38, t52, k);
        t54[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t55[k] = x2[k]*p[16];
        t56[k] = jlt_jet_product(t54, t55, k);
        t57[k] = jlt_jet_product(t34, t56, k);
        t58[k] = jlt_jet_product(t45, t57, k) + t53[k];
        t59[k] = -t58[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t35[k]/(k + 1);
        next[1] = x1[k + 1] = t48[k]/(k + 1);
        next[2] = x2[k + 1] = t47[k]/(k + 1);
        next[3] = x3[k + 1] = t59[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_omega_tau = x[2];
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    out[0] = (v_omega_tau*v_s);
    const double complex v_v_tau = x[3];
    const double v_R = params[1];
    const double v_I1 = params[3];
    const double v_I3 = params[4];
    const double v_a3 = params[5];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_K = (v_R*v_R*v_I1*v_s*v_s + v_I3*v_b*v_b);
    const double v_G = params[6];
    const double complex v_omega_n = ((v_R*v_G*v_s + v_I3*v_v_tau*v_b)/v_K);
    out[1] = (v_v_tau*v_omega_n/v_s);
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double complex v_omega3 = ((v_R*v_I1*v_v_tau*v_s - v_G*v_b)/v_K);
    out[2] = (v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D);
    const double complex v_v_nu = x[1];
    const double complex v_Theta = (v_m*v_K + v_I1*v_I3);
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (-v_v_nu*v_omega_n/v_s)
        + (v_I1*v_I3*v_V*v_omega_n/(v_s*v_Theta))
        + (-v_I3*v_omega_tau*v_omega3*(v_R*v_gamma3*(v_I1 - v_I3) - v_I3*v_a3)/v_Theta);
}

static const unsigned char family0_is_free[] = { 1, 1, 0, 0 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = 0.0;
    out[6] = params[6];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = x[1];
    out[2] = 0.0;
    const double t0 = params[1]*params[6]; /* R*G */
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = sqrt(t3); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t5 = t0*t4; /* R*G*s */
    const double t6 = x[0]*params[1]; /* gamma3*R */
    const double t7 = params[5] + t6; /* b = a3 + gamma3*R */
    const double t8 = params[4]*t7; /* I3*b */
    const double t9 = t5/t8; /* R*G*s/(I3*b) */
    const double t10 = -t9; /* v_tau = -R*G*s/(I3*b) */
    out[3] = t10;
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = t0*params[4]; /* m*R*I3 */
    const double t2 = t1*x[0]; /* m*R*I3*gamma3 */
    const double t3 = t2*x[1]; /* m*R*I3*gamma3*v_nu */
    const double t4 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t5 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t6 = t4*t5; /* (1 - gamma3)*(1 + gamma3) */
    const double t7 = sqrt(t6); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t8 = params[1]*params[1]; /* R*R */
    const double t9 = t8*params[3]; /* R*R*I1 */
    const double t10 = t7*t7; /* s*s */
    const double t11 = t9*t10; /* R*R*I1*s*s */
    const double t12 = params[1]*x[0]; /* R*gamma3 */
    const double t13 = params[5] + t12; /* b = a3 + R*gamma3 */
    const double t14 = t13*t13; /* b*b */
    const double t15 = params[4]*t14; /* I3*b*b */
    const double t16 = t11 + t15; /* K = R*R*I1*s*s + I3*b*b */
    const double t17 = params[0]*t16; /* m*K */
    const double t18 = params[4]*params[3]; /* I3*I1 */
    const double t19 = t17 + t18; /* Theta = m*K + I3*I1 */
    const double t20 = t7*t19; /* s*Theta */
    const double t21 = t3/t20; /* m*R*I3*gamma3*v_nu/(s*Theta) */
    const double t22 = -t21; /* -m*R*I3*gamma3*v_nu/(s*Theta) */
    out[0] = t22;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[2] = 0.0;
    const double t0 = params[0]*params[2]; /* m*g */
    const double t1 = params[5]*t0; /* a3*m*g */
    const double t2 = params[1]*params[6]; /* R*G */
    const double t3 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t4 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t5 = t3*t4; /* (1 - gamma3)*(1 + gamma3) */
    const double t6 = sqrt(t5); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = t2*t6; /* R*G*s */
    const double t8 = x[0]*params[1]; /* gamma3*R */
    const double t9 = params[5] + t8; /* b = a3 + gamma3*R */
    const double t10 = params[4]*t9; /* I3*b */
    const double t11 = t7/t10; /* R*G*s/(I3*b) */
    const double t12 = t11*t11; /* R*G*s/(I3*b)*R*G*s/(I3*b) */
    const double t13 = params[1]*params[1]; /* R*R */
    const double t14 = t13*params[3]; /* R*R*I1 */
    const double t15 = t6*t6; /* s*s */
    const double t16 = t14*t15; /* R*R*I1*s*s */
    const double t17 = t9*t9; /* b*b */
    const double t18 = params[4]*t17; /* I3*b*b */
    const double t19 = t16 + t18; /* K = R*R*I1*s*s + I3*b*b */
    const double t20 = t19*t19; /* K*K */
    const double t21 = params[0]*t19; /* m*K */
    const double t22 = params[4]*params[3]; /* I3*I1 */
    const double t23 = t21 + t22; /* Theta = m*K + I3*I1 */
    const double t24 = t12*t23; /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta */
    const double t25 = x[0]*t14; /* gamma3*R*R*I1 */
    const double t26 = t25*2.0; /* gamma3*R*R*I1*2 */
    const double t27 = params[1]*params[4]; /* R*I3 */
    const double t28 = t9*t27; /* b*R*I3 */
    const double t29 = 2.0*t28; /* 2*b*R*I3 */
    const double t30 = t29 - t26; /* d(K)/d(gamma3) = 2*b*R*I3 - gamma3*R*R*I1*2 */
    const double t31 = t24*t30; /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3) */
    const double t32 = t31/t20; /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3)/(K*K) */
    const double t33 = t32*(1.0 / 2.0); /* R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t34 = t1 - t33; /* a3*m*g - R*G*s/(I3*b)*R*G*s/(I3*b)*Theta*d(K)/d(gamma3)/(K*K)*1/2 */
    const double t35 = params[0]*t12; /* m*R*G*s/(I3*b)*R*G*s/(I3*b) */
    const double t36 = t30*t35; /* d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b) */
    const double t37 = t36/t19; /* d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K */
    const double t38 = (1.0 / 2.0)*t37; /* 1/2*d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K */
    const double t39 = t34 + t38; /* t34 + 1/2*d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K */
    const double t40 = params[6]*params[6]; /* G*G */
    const double t41 = t30*t40; /* d(K)/d(gamma3)*G*G */
    const double t42 = t41/t20; /* d(K)/d(gamma3)*G*G/(K*K) */
    const double t43 = (1.0 / 2.0)*t42; /* 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    const double t44 = t39 - t43; /* t34 + 1/2*d(K)/d(gamma3)*m*R*G*s/(I3*b)*R*G*s/(I3*b)/K - 1/2*d(K)/d(gamma3)*G*G/(K*K) */
    out[0] = t44;
    const double t45 = params[0]*x[1]; /* m*v_nu */
    out[1] = t45;
    const double t46 = t11*t23; /* R*G*s/(I3*b)*Theta */
    const double t47 = t46/t19; /* R*G*s/(I3*b)*Theta/K */
    const double t48 = -t47; /* -R*G*s/(I3*b)*Theta/K */
    out[3] = t48;
    const double t49 = t19*t20; /* K*K*K */
    const double t50 = params[1]*params[3]; /* R*I1 */
    const double t51 = t11*t50; /* R*G*s/(I3*b)*R*I1 */
    const double t52 = t6*t51; /* s*R*G*s/(I3*b)*R*I1 */
    const double t53 = -t52; /* -s*R*G*s/(I3*b)*R*I1 */
    const double t54 = params[6]*t9; /* G*b */
    const double t55 = t53 - t54; /* -s*R*G*s/(I3*b)*R*I1 - G*b */
    const double t56 = t55*t55; /* (-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t57 = t23*t56; /* Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t58 = params[3] - params[4]; /* I1 - I3 */
    const double t59 = t57*t58; /* t57*(I1 - I3) */
    const double t60 = t30*t59; /* d(K)/d(gamma3)*t57*(I1 - I3) */
    const double t61 = t60/t49; /* d(K)/d(gamma3)*t57*(I1 - I3)/(K*K*K) */
    const double t62 = 2.0*t61; /* 2*d(K)/d(gamma3)*t57*(I1 - I3)/(K*K*K) */
    const double t63 = params[0]*t56; /* m*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t64 = t58*t63; /* (I1 - I3)*m*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t65 = t30*t64; /* d(K)/d(gamma3)*t64 */
    const double t66 = t65/t20; /* d(K)/d(gamma3)*t64/(K*K) */
    const double t67 = t66 - t62; /* d(K)/d(gamma3)*t64/(K*K) - 2*d(K)/d(gamma3)*t57*(I1 - I3)/(K*K*K) */
    const double t68 = t23*t55; /* Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t69 = t58*t68; /* (I1 - I3)*Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b) */
    const double t70 = x[0]*t50; /* gamma3*R*I1 */
    const double t71 = t11*t70; /* R*G*s/(I3*b)*gamma3*R*I1 */
    const double t72 = t71/t6; /* R*G*s/(I3*b)*gamma3*R*I1/s */
    const double t73 = t2 - t72; /* R*G - R*G*s/(I3*b)*gamma3*R*I1/s */
    const double t74 = t69*t73; /* (I1 - I3)*Theta*(-s*R*G*s/(I3*b)*R*I1 - G*b)*(R*G - R*G*s/(I3*b)*gamma3*R*I1/s) */
    const double t75 = t74/t20; /* t74/(K*K) */
    const double t76 = 2.0*t75; /* 2*t74/(K*K) */
    const double t77 = t67 - t76; /* t67 - 2*t74/(K*K) */
    out[4] = t77;
    const double t78 = params[0]*2.0; /* m*2 */
    const double t79 = params[3]*params[3]; /* I1*I1 */
    const double t80 = t78*t79; /* m*2*I1*I1 */
    const double t81 = x[1]*t80; /* v_nu*m*2*I1*I1 */
    out[5] = t81;
    const double t82 = params[1]*t78; /* R*m*2 */
    const double t83 = t79*t82; /* I1*I1*R*m*2 */
    const double t84 = x[1]*t83; /* v_nu*I1*I1*R*m*2 */
    out[6] = t84;
    const double t85 = params[1]*2.0; /* R*2 */
    const double t86 = params[3]*t85; /* I1*R*2 */
    const double t87 = t6*t86; /* s*I1*R*2 */
    const double t88 = t23*t87; /* Theta*s*I1*R*2 */
    const double t89 = t55*t88; /* (-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2 */
    const double t90 = t58*t89; /* (I1 - I3)*(-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2 */
    const double t91 = t90/t20; /* (I1 - I3)*(-s*R*G*s/(I3*b)*R*I1 - G*b)*Theta*s*I1*R*2/(K*K) */
    out[7] = t91;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

static const jlt_equilibria equilibria[] = {
    { .name = "spinning", .condition = "a3 = 0",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 2, .obstructs = 1 },
};

/* Section turning: omega_tau = 0, in coordinates of the table spherical_top_section, SHA-256
 * bf5c565b976fefec01b0b9870e38f40c17511a13ec5354ac25e436f814722bac. */
static void section0_lift(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[1];
    out[2] = 0.0;
    const double t0 = params[7]*2.0; /* E*2 */
    const double t1 = params[0]*params[2]; /* m*g */
    const double t2 = t1*params[5]; /* m*g*a3 */
    const double t3 = x[1]*t2; /* gamma3*m*g*a3 */
    const double t4 = 2.0*t3; /* 2*gamma3*m*g*a3 */
    const double t5 = t0 - t4; /* E*2 - 2*gamma3*m*g*a3 */
    const double t6 = params[6]*params[6]; /* G*G */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = t7*params[3]; /* R*R*I1 */
    const double t9 = 1.0 - x[1]; /* 1 - gamma3 */
    const double t10 = x[1] + 1.0; /* gamma3 + 1 */
    const double t11 = t9*t10; /* (1 - gamma3)*(gamma3 + 1) */
    const double t12 = sqrt(t11); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    const double t13 = t12*t12; /* s*s */
    const double t14 = t8*t13; /* R*R*I1*s*s */
    const double t15 = x[1]*params[1]; /* gamma3*R */
    const double t16 = params[5] + t15; /* b = a3 + gamma3*R */
    const double t17 = t16*t16; /* b*b */
    const double t18 = params[4]*t17; /* I3*b*b */
    const double t19 = t14 + t18; /* K = R*R*I1*s*s + I3*b*b */
    const double t20 = t6/t19; /* G*G/K */
    const double t21 = t5 - t20; /* E*2 - 2*gamma3*m*g*a3 - G*G/K */
    const double t22 = t21/params[0]; /* (E*2 - 2*gamma3*m*g*a3 - G*G/K)/m */
    const double t23 = sqrt(t22); /* W = sqrt((E*2 - 2*gamma3*m*g*a3 - G*G/K)/m) */
    const double t24 = sin(x[0]); /* sin_eta = sin(eta) */
    const double t25 = t23*t24; /* W*sin_eta */
    out[1] = t25;
    const double t26 = params[0]*t19; /* m*K */
    const double t27 = params[3]*params[4]; /* I1*I3 */
    const double t28 = t26 + t27; /* Theta = m*K + I1*I3 */
    const double t29 = t26/t28; /* m*K/Theta */
    const double t30 = sqrt(t29); /* stretch = sqrt(m*K/Theta) */
    const double t31 = t23*t30; /* W*stretch */
    const double t32 = cos(x[0]); /* cos_eta = cos(eta) */
    const double t33 = t31*t32; /* W*stretch*cos_eta */
    out[3] = t33;
}

static void section0_lift_slopes(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = 0.0;
    out[2] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[1] = 1.0;
    const double t0 = params[7]*2.0; /* E*2 */
    const double t1 = params[0]*params[2]; /* m*g */
    const double t2 = t1*params[5]; /* m*g*a3 */
    const double t3 = t2*x[1]; /* m*g*a3*gamma3 */
    const double t4 = 2.0*t3; /* 2*m*g*a3*gamma3 */
    const double t5 = t0 - t4; /* E*2 - 2*m*g*a3*gamma3 */
    const double t6 = params[6]*params[6]; /* G*G */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = t7*params[3]; /* R*R*I1 */
    const double t9 = 1.0 - x[1]; /* 1 - gamma3 */
    const double t10 = 1.0 + x[1]; /* 1 + gamma3 */
    const double t11 = t9*t10; /* (1 - gamma3)*(1 + gamma3) */
    const double t12 = sqrt(t11); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t13 = t12*t12; /* s*s */
    const double t14 = t8*t13; /* R*R*I1*s*s */
    const double t15 = x[1]*params[1]; /* gamma3*R */
    const double t16 = params[5] + t15; /* b = a3 + gamma3*R */
    const double t17 = t16*t16; /* b*b */
    const double t18 = params[4]*t17; /* I3*b*b */
    const double t19 = t14 + t18; /* K = R*R*I1*s*s + I3*b*b */
    const double t20 = t6/t19; /* G*G/K */
    const double t21 = t5 - t20; /* E*2 - 2*m*g*a3*gamma3 - G*G/K */
    const double t22 = t21/params[0]; /* (E*2 - 2*m*g*a3*gamma3 - G*G/K)/m */
    const double t23 = sqrt(t22); /* W = sqrt((E*2 - 2*m*g*a3*gamma3 - G*G/K)/m) */
    const double t24 = cos(x[0]); /* cos_eta = cos(eta) */
    const double t25 = t23*t24; /* W*cos_eta */
    out[3] = t25;
    const double t26 = params[0]*t23; /* m*W */
    const double t27 = sin(x[0]); /* sin_eta = sin(eta) */
    const double t28 = t19*t19; /* K*K */
    const double t29 = x[1]*t8; /* gamma3*R*R*I1 */
    const double t30 = params[1]*params[4]; /* R*I3 */
    const double t31 = t16*t30; /* b*R*I3 */
    const double t32 = t29 - t31; /* gamma3*R*R*I1 - b*R*I3 */
    const double t33 = t6*t32; /* G*G*(gamma3*R*R*I1 - b*R*I3) */
    const double t34 = t33/t28; /* G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K) */
    const double t35 = t2 + t34; /* m*g*a3 + G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K) */
    const double t36 = t27*t35; /* sin_eta*(m*g*a3 + G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K)) */
    const double t37 = t36/t26; /* sin_eta*(m*g*a3 + G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K))/(m*W) */
    const double t38 = -t37; /* -sin_eta*(m*g*a3 + G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K))/(m*W) */
    out[4] = t38;
    const double t39 = t27/t26; /* sin_eta/(m*W) */
    out[5] = t39;
    const double t40 = params[0]*t19; /* m*K */
    const double t41 = params[3]*params[4]; /* I1*I3 */
    const double t42 = t40 + t41; /* Theta = m*K + I1*I3 */
    const double t43 = t40/t42; /* m*K/Theta */
    const double t44 = sqrt(t43); /* stretch = sqrt(m*K/Theta) */
    const double t45 = t23*t44; /* W*stretch */
    const double t46 = t27*t45; /* sin_eta*W*stretch */
    const double t47 = -t46; /* -sin_eta*W*stretch */
    out[9] = t47;
    const double t48 = t24*t44; /* cos_eta*stretch */
    const double t49 = t35*t48; /* (m*g*a3 + G*G*(gamma3*R*R*I1 - b*R*I3)/(K*K))*cos_eta*stretch */
    const double t50 = t49/t26; /* t49/(m*W) */
    const double t51 = -t50; /* -t49/(m*W) */
    const double t52 = params[0]*t32; /* m*(gamma3*R*R*I1 - b*R*I3) */
    const double t53 = t52/t42; /* m*(gamma3*R*R*I1 - b*R*I3)/Theta */
    const double t54 = params[0]*params[0]; /* m*m */
    const double t55 = t19*t54; /* K*m*m */
    const double t56 = t42*t42; /* Theta*Theta */
    const double t57 = t32*t55; /* (gamma3*R*R*I1 - b*R*I3)*K*m*m */
    const double t58 = t57/t56; /* (gamma3*R*R*I1 - b*R*I3)*K*m*m/(Theta*Theta) */
    const double t59 = t53 - t58; /* m*(gamma3*R*R*I1 - b*R*I3)/Theta - (gamma3*R*R*I1 - b*R*I3)*K*m*m/(Theta*Theta) */
    const double t60 = t25*t59; /* W*cos_eta*t59 */
    const double t61 = t60/t44; /* W*cos_eta*t59/stretch */
    const double t62 = t51 - t61; /* -t49/(m*W) - W*cos_eta*t59/stretch */
    out[10] = t62;
    const double t63 = t48/t26; /* cos_eta*stretch/(m*W) */
    out[11] = t63;
}

static void section0_region(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[7]*2.0; /* E*2 */
    const double t1 = params[0]*params[2]; /* m*g */
    const double t2 = t1*params[5]; /* m*g*a3 */
    const double t3 = t2*x[1]; /* m*g*a3*gamma3 */
    const double t4 = 2.0*t3; /* 2*m*g*a3*gamma3 */
    const double t5 = t0 - t4; /* E*2 - 2*m*g*a3*gamma3 */
    const double t6 = params[6]*params[6]; /* G*G */
    const double t7 = params[1]*params[1]; /* R*R */
    const double t8 = t7*params[3]; /* R*R*I1 */
    const double t9 = 1.0 - x[1]; /* 1 - gamma3 */
    const double t10 = 1.0 + x[1]; /* 1 + gamma3 */
    const double t11 = t9*t10; /* (1 - gamma3)*(1 + gamma3) */
    const double t12 = sqrt(t11); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t13 = t12*t12; /* s*s */
    const double t14 = t8*t13; /* R*R*I1*s*s */
    const double t15 = x[1]*params[1]; /* gamma3*R */
    const double t16 = params[5] + t15; /* b = a3 + gamma3*R */
    const double t17 = t16*t16; /* b*b */
    const double t18 = params[4]*t17; /* I3*b*b */
    const double t19 = t14 + t18; /* K = R*R*I1*s*s + I3*b*b */
    const double t20 = t6/t19; /* G*G/K */
    const double t21 = t5 - t20; /* E*2 - 2*m*g*a3*gamma3 - G*G/K */
    const double t22 = t21/params[0]; /* (E*2 - 2*m*g*a3*gamma3 - G*G/K)/m */
    out[0] = t22;
}

static void section0_back(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[1];
    out[3] = 1.0;
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    out[2] = x[0];
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = t5*t5; /* s*s */
    const double t7 = t1*t6; /* R*R*I1*s*s */
    const double t8 = params[1]*x[0]; /* R*gamma3 */
    const double t9 = params[5] + t8; /* b = a3 + R*gamma3 */
    const double t10 = t9*t9; /* b*b */
    const double t11 = params[4]*t10; /* I3*b*b */
    const double t12 = t7 + t11; /* K = R*R*I1*s*s + I3*b*b */
    const double t13 = params[0]*t12; /* m*K */
    const double t14 = params[3]*params[4]; /* I1*I3 */
    const double t15 = t13 + t14; /* Theta = m*K + I1*I3 */
    const double t16 = t13/t15; /* m*K/Theta */
    const double t17 = sqrt(t16); /* stretch = sqrt(m*K/Theta) */
    const double t18 = x[3]/t17; /* v_tau/stretch */
    out[1] = t18;
}

static void section0_back_slopes(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[1] = 1.0;
    out[8] = 1.0;
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = t5*t5; /* s*s */
    const double t7 = t1*t6; /* R*R*I1*s*s */
    const double t8 = params[1]*x[0]; /* R*gamma3 */
    const double t9 = params[5] + t8; /* b = a3 + R*gamma3 */
    const double t10 = t9*t9; /* b*b */
    const double t11 = params[4]*t10; /* I3*b*b */
    const double t12 = t7 + t11; /* K = R*R*I1*s*s + I3*b*b */
    const double t13 = params[0]*t12; /* m*K */
    const double t14 = params[3]*params[4]; /* I1*I3 */
    const double t15 = t13 + t14; /* Theta = m*K + I1*I3 */
    const double t16 = t13/t15; /* m*K/Theta */
    const double t17 = sqrt(t16); /* stretch = sqrt(m*K/Theta) */
    const double t18 = t17*t17; /* stretch*stretch */
    const double t19 = t17*t18; /* stretch*stretch*stretch */
    const double t20 = 2.0*t19; /* 2*stretch*stretch*stretch */
    const double t21 = t1*x[0]; /* R*R*I1*gamma3 */
    const double t22 = 2.0*t21; /* 2*R*R*I1*gamma3 */
    const double t23 = params[1]*params[4]; /* R*I3 */
    const double t24 = t9*t23; /* b*R*I3 */
    const double t25 = 2.0*t24; /* 2*b*R*I3 */
    const double t26 = t25 - t22; /* d(K)/d(gamma3) = 2*b*R*I3 - 2*R*R*I1*gamma3 */
    const double t27 = params[0]*t26; /* m*d(K)/d(gamma3) */
    const double t28 = t27/t15; /* m*d(K)/d(gamma3)/Theta */
    const double t29 = params[0]*params[0]; /* m*m */
    const double t30 = t12*t29; /* K*m*m */
    const double t31 = t15*t15; /* Theta*Theta */
    const double t32 = t26*t30; /* d(K)/d(gamma3)*K*m*m */
    const double t33 = t32/t31; /* d(K)/d(gamma3)*K*m*m/(Theta*Theta) */
    const double t34 = t28 - t33; /* m*d(K)/d(gamma3)/Theta - d(K)/d(gamma3)*K*m*m/(Theta*Theta) */
    const double t35 = x[3]*t34; /* v_tau*(m*d(K)/d(gamma3)/Theta - d(K)/d(gamma3)*K*m*m/(Theta*Theta)) */
    const double t36 = t35/t20; /* t35/(2*stretch*stretch*stretch) */
    const double t37 = -t36; /* -t35/(2*stretch*stretch*stretch) */
    out[4] = t37;
    const double t38 = 1.0/t17; /* 1/stretch */
    out[7] = t38;
}

static void section0_beside_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[1];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = t5*t5; /* s*s */
    const double t7 = t1*t6; /* R*R*I1*s*s */
    const double t8 = params[1]*x[0]; /* R*gamma3 */
    const double t9 = params[5] + t8; /* b = a3 + R*gamma3 */
    const double t10 = t9*t9; /* b*b */
    const double t11 = params[4]*t10; /* I3*b*b */
    const double t12 = t7 + t11; /* K = R*R*I1*s*s + I3*b*b */
    const double t13 = params[1]*params[6]; /* R*G */
    const double t14 = t5*t13; /* s*R*G */
    const double t15 = params[4]*x[3]; /* I3*v_tau */
    const double t16 = t9*t15; /* b*I3*v_tau */
    const double t17 = t14 + t16; /* s*R*G + b*I3*v_tau */
    const double t18 = t17/t12; /* (s*R*G + b*I3*v_tau)/K */
    out[1] = t18;
    const double t19 = params[1]*params[3]; /* R*I1 */
    const double t20 = x[3]*t19; /* v_tau*R*I1 */
    const double t21 = t5*t20; /* s*v_tau*R*I1 */
    const double t22 = t9*params[6]; /* b*G */
    const double t23 = t21 - t22; /* s*v_tau*R*I1 - b*G */
    const double t24 = t23/t12; /* (s*v_tau*R*I1 - b*G)/K */
    out[2] = t24;
}

static const jlt_quantity section0_beside[] = {
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_n", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static void section0_ending_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[1];
    out[1] = x[2];
    const double t0 = params[1]*params[1]; /* R*R */
    const double t1 = t0*params[3]; /* R*R*I1 */
    const double t2 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t3 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t4 = t2*t3; /* (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t4); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = t5*t5; /* s*s */
    const double t7 = t1*t6; /* R*R*I1*s*s */
    const double t8 = params[1]*x[0]; /* R*gamma3 */
    const double t9 = params[5] + t8; /* b = a3 + R*gamma3 */
    const double t10 = t9*t9; /* b*b */
    const double t11 = params[4]*t10; /* I3*b*b */
    const double t12 = t7 + t11; /* K = R*R*I1*s*s + I3*b*b */
    const double t13 = params[1]*params[3]; /* R*I1 */
    const double t14 = t13*x[3]; /* R*I1*v_tau */
    const double t15 = t5*t14; /* s*R*I1*v_tau */
    const double t16 = t9*params[6]; /* b*G */
    const double t17 = t15 - t16; /* s*R*I1*v_tau - b*G */
    const double t18 = t17/t12; /* (s*R*I1*v_tau - b*G)/K */
    out[2] = t18;
}

static const jlt_quantity section0_ending[] = {
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static void section0_turn(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[5]*x[1]; /* a3*gamma3 */
    out[0] = t0;
}

static const jlt_quantity section0_coordinates[] = {
    { "eta", "rad", "angle on the ellipse of energy", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 2.0*0x1.921fb54442d18p+1 },
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
};

static const unsigned char section0_is_angle[] = { 1, 0 };

static const jlt_quantity section0_levels[] = {
    { "E", "kg m^2/s^2", "energy", -INFINITY, INFINITY, JLT_ANY_SIGN, (43.0 / 20.0), 0.0 },
};

static const unsigned section0_integrals[] = { 0 };

static const double section0_start0[] = { (11.0 / 25.0), (-31.0 / 50.0) };
static const double section0_start1[] = { (1.0 / 10.0), (-3.0 / 5.0) };
static const double section0_start2[] = { 0.0, (-61.0 / 100.0) };
static const jlt_section_point section0_starts[] = {
    { "regular", section0_start0 },
    { "chaotic", section0_start1 },
    { "saddle", section0_start2 },
};

static const jlt_section_chart sections[] = {
    { .name = "turning", .chart = "spherical_top_section", .file = "spherical_top_section.tt",
      .sha256 = "bf5c565b976fefec01b0b9870e38f40c17511a13ec5354ac25e436f814722bac",
      .table = jlt_chart_spherical_top_level_5,
      .claim = 5, .column = 2, .level = 0.0,
      .coordinate_count = 2, .coordinates = section0_coordinates, .is_angle = section0_is_angle,
      .level_count = 1, .levels = section0_levels, .integrals = section0_integrals,
      .lift = section0_lift, .lift_slopes = section0_lift_slopes,
      .region_count = 1, .region = section0_region,
      .back = section0_back, .back_slopes = section0_back_slopes,
      .beside_count = 3, .beside = section0_beside, .beside_values = section0_beside_values,
      .ending_count = 3, .ending = section0_ending, .ending_values = section0_ending_values,
      .start_count = 3, .starts = section0_starts,
      .turn = section0_turn,
      .turn_meaning = "with a low centre of mass" },
};

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0), 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0), 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
};

static const jlt_quantity observes[] = {
    { "contact_force", "kg*m/s^2", "force of the plane on the sphere, upwards", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_validity valids[] = {
    { "contact", "kg*m/s^2", "the plane only pushes" },
};

static const signed char signs_4[] = { 1, -1, -1, 1 };
static const jlt_reversor reversors[] = {
    { signs_4, 4 },
};

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_general = {
    .model = "spherical_top_level",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "5fa0f3f8159ed96ffaf422476001a79c5f28ef178108a7d5ffb7cd0a8be5e04d",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .scales = 1,
    .state_count = 4, .param_count = 7, .prepared_count = 40,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 5, 31, 12, 1, 1, 0, 17, 10 }, { 21, 80, 0, 8, 1, 0, 12, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*v_tau*(R*I3) + (R*G)*s, a part of d(omega_tau)/dt, v_tau*s - (G/I1)*b/R, a part of d(omega_tau)/dt, e = gamma3*a3 + R, V = omega_tau*e + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(v_tau)/dt" },
    .jacobian = { jacobian, 16, { 11, 60, 32, 1, 1, 0, 18, 27 }, { 91, 425, 0, 50, 1, 0, 21, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, v_tau*(R*I3)*b/R + (R*G)*s, gamma3*(R*(I1 - I3)) - (I3*a3), v_tau*s - (G/I1)*b/R, d(K)/d(gamma3) = (2*R^2*I3)*b/R - gamma3*(2*R^2*I1), (R*G)*gamma3*K*D/I1*((1)/s^2*Theta/m*K*D/I1)*Theta/m*s - v_tau*(R*I3), e = gamma3*a3 + R, a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), v_tau*gamma3*K*D/I1*((1)/s^2*Theta/m*K*D/I1)*Theta/m*s + G/I1, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, v_nu - V*(I1*I3/m)*1/(Theta/m), d(d(v_nu)/dt)/d(v_tau), a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(omega_tau), d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(v_tau), omega_tau*omega_tau - (2*m*g*a3/I1)*gamma3*1/(D/I1), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(v_tau), a part of d(d(omega_tau)/dt)/d(v_tau)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 10, 58, 34, 1, 1, 0, 18, 27 }, { 105, 489, 0, 58, 1, 0, 21, 14 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, b/R*v_tau*(R*I3) + (R*G)*s, v_tau*s - (G/I1)*b/R, gamma3*(R*(I1 - I3)) - (I3*a3), e = gamma3*a3 + R, (R*G)*gamma3*K*Theta/m*((1)/Theta/m*K*s^2*D/I1)*D/I1*s - v_tau*(R*I3), d(K)/d(gamma3) = (2*R^2*I3)*b/R - gamma3*(2*R^2*I1), a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(v_tau), V = omega_tau*e + v_nu, d(d(v_nu)/dt)/d(v_tau), v_nu - V*(I1*I3/m)*1/(Theta/m), d(d(v_tau)/dt)/d(omega_tau), a part of d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(v_nu), a part of d(v_tau)/dt and of d(d(v_tau)/dt)/d(gamma3), d(omega_tau)/dt, gamma3*v_tau*K*Theta/m*((1)/Theta/m*K*s^2*D/I1)*D/I1*s + G/I1, a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(v_tau), d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(v_tau), d(d(v_nu)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 3, 20, 10, 1, 1, 0, 12, 9 }, { 13, 41, 0, 5, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, (2*m*a3^2)*K/(R^2*I1)*1/(D*(K/(R^2*I1))) - 1/s^2, e = gamma3*a3 + R, V = omega_tau*e + v_nu, v_nu - 1/(Theta/(m*R^2*I1))*(I3/(m*R^2))*V, gamma3*(R*(I1 - I3)) - (I3*a3), a part of the divergence, the divergence" },
    .integral_values = { integral_values, 1, { 4, 6, 6, 1, 0, 0, 8, 5 }, { 9, 28, 0, 2, 1, 0, 13, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, E" },
    .integral_gradients = { integral_gradients, 4, { 6, 11, 5, 1, 0, 0, 10, 5 }, { 10, 44, 0, 4, 1, 0, 15, 10 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, d(K)/d(gamma3)/(2*R^2*I1) = (I3/I1)*b/R - gamma3, ((1)/K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m - v_tau*m, a part of d(E)/d(gamma3), d(E)/d(gamma3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { observe_values, 1, { 2, 20, 10, 1, 1, 0, 12, 10 }, { 12, 49, 0, 4, 1, 0, 16, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau*I3*b + (R*G)*s, g/I1 - (a3/I1)*omega_tau*gamma3*omega_tau, v_tau*s - (G/(R*I1))*b, a part of contact_force, a part of contact_force, a part of contact_force, contact_force" },
    .valid_values = { valid_values, 1, { 2, 20, 10, 1, 1, 0, 12, 10 }, { 12, 49, 0, 4, 1, 0, 16, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau*I3*b + (R*G)*s, g/I1 - (a3/I1)*omega_tau*gamma3*omega_tau, v_tau*s - (G/(R*I1))*b, a part of contact, a part of contact, a part of contact, contact" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .observe_count = 1, .observes = observes,
    .valid_count = 1, .valids = valids,
    .reversor_count = 1, .reversors = reversors,
    .pole_count = 1, .poles = poles,
    .section_count = 1, .sections = sections,
    .tier = "level", .tier_meaning = "four states on a level of G, in coordinates that divide by nothing small",
    .integral_count = 1, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_level_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_level_general) },
#endif
};
