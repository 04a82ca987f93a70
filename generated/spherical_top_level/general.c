/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Table:      spherical_top_level, SHA-256 a03ac57982f08b300ad072746897d22dbcd0a4e4ebdedbf1bb5bf573f26d0de6
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   30   13    1    1    0     17   10   (110)
 *  jacobian            9   61   33    1    1    0     18   27   (567)
 *  rhs_jacobian        9   60   38    1    1    0     18   28   (653)
 *  divergence          3   20   10    1    1    0     12    9   (60)
 *  integral_values     4    6    6    1    0    0      8    5   (40)
 *  integral_gradients  6   11    5    1    0    0     10    5   (59)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are
 *    divides by Theta, small only where all of m*K and I1*I3 are
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, gamma3*(R*(I1 - I3)) - (I3*a3),
 *      b/R*v_tau*(R*I3) + (R*G)*s, v_tau*s - (G/I1)*b/R, d(K)/d(gamma3) = (2*R^2*I3)*b/R - gamma3*(2*R^2*I1),
 *      a part of d(d(v_tau)/dt)/d(gamma3), (R*G)*gamma3*Theta/m*K*((1)/K*Theta/m*s^2*D/I1)*D/I1*s - v_tau*(R*I3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(v_tau),
 *      a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), e = gamma3*a3 + R,
 *      v_tau*gamma3*Theta/m*K*((1)/K*Theta/m*s^2*D/I1)*D/I1*s + G/I1, a part of d(d(v_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(omega_tau), v_nu - (I1*I3/m)*1/(Theta/m)*V,
 *      a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(v_nu),
 *      a part of d(v_tau)/dt, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3),
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(v_tau),
 *      d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(v_tau), a part of d(d(omega_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(v_tau), d(omega_tau)/dt, d(d(omega_tau)/dt)/d(gamma3)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

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
    out[35] = t1;
    const double t2 = t1/params[3]; /* m*a3*a3/I1 */
    out[7] = t2;
    const double t3 = params[1]*params[6]; /* R*G */
    out[8] = t3;
    const double t4 = params[1]*params[1]; /* R*R */
    const double t5 = params[3]*t4; /* I1*R*R */
    out[9] = t5;
    const double t6 = params[3]*params[4]; /* I1*I3 */
    const double t7 = t6/params[0]; /* I1*I3/m */
    out[10] = t7;
    const double t8 = params[0]*params[2]; /* m*g */
    const double t9 = params[5]*t8; /* a3*m*g */
    out[37] = t9;
    const double t10 = t9/params[3]; /* a3*m*g/I1 */
    out[11] = t10;
    const double t11 = params[1]*params[4]; /* R*I3 */
    out[12] = t11;
    const double t12 = params[3]*params[1]; /* I1*R */
    const double t13 = params[6]/t12; /* G/(I1*R) */
    out[13] = t13;
    const double t14 = params[4]*t12; /* I3*I1*R */
    const double t15 = t14/params[0]; /* I3*I1*R/m */
    out[14] = t15;
    const double t16 = params[3] - params[4]; /* I1 - I3 */
    const double t17 = params[1]*t16; /* R*(I1 - I3) */
    out[15] = t17;
    const double t18 = params[5]*params[4]; /* a3*I3 */
    out[16] = t18;
    const double t19 = t4*params[4]; /* R*R*I3 */
    out[17] = t19;
    const double t20 = params[5]/params[1]; /* a3/R */
    out[18] = t20;
    const double t21 = t4*2.0; /* R*R*2 */
    const double t22 = params[3]*t21; /* I1*R*R*2 */
    out[19] = t22;
    const double t23 = params[4]*t21; /* I3*R*R*2 */
    out[20] = t23;
    const double t24 = params[0]*params[0]; /* m*m */
    const double t25 = 2.0*t24; /* 2*m*m */
    const double t26 = params[3]*params[3]; /* I1*I1 */
    const double t27 = t0*t0; /* a3*a3*a3*a3 */
    const double t28 = t25*t27; /* 2*m*m*a3*a3*a3*a3 */
    const double t29 = t28/t26; /* 2*m*m*a3*a3*a3*a3/(I1*I1) */
    out[21] = t29;
    const double t30 = params[2]*t25; /* g*2*m*m */
    const double t31 = params[5]*t0; /* a3*a3*a3 */
    const double t32 = t30*t31; /* g*2*m*m*a3*a3*a3 */
    const double t33 = t32/t26; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    out[22] = t33;
    const double t34 = params[6]/params[3]; /* G/I1 */
    out[23] = t34;
    const double t35 = params[0]*2.0; /* m*2 */
    const double t36 = t0*t35; /* a3*a3*m*2 */
    out[32] = t36;
    const double t37 = t36/params[3]; /* a3*a3*m*2/I1 */
    out[24] = t37;
    const double t38 = params[1]*(-2.0); /* R*(-2) */
    const double t39 = params[4]*t38; /* I3*R*(-2) */
    out[25] = t39;
    const double t40 = params[4]*params[4]; /* I3*I3 */
    const double t41 = t4*t40; /* R*R*I3*I3 */
    const double t42 = -t41; /* -R*R*I3*I3 */
    out[26] = t42;
    const double t43 = -t11; /* -R*I3 */
    out[27] = t43;
    const double t44 = t5*params[4]; /* I1*R*R*I3 */
    const double t45 = t16*t44; /* (I1 - I3)*I1*R*R*I3 */
    const double t46 = t45/params[0]; /* (I1 - I3)*I1*R*R*I3/m */
    out[28] = t46;
    const double t47 = params[5]*t6; /* a3*I1*I3 */
    const double t48 = t47/params[0]; /* a3*I1*I3/m */
    out[29] = t48;
    const double t49 = params[1]*t35; /* R*m*2 */
    const double t50 = params[4]*t49; /* I3*R*m*2 */
    const double t51 = t0*t50; /* a3*a3*I3*R*m*2 */
    const double t52 = t51/params[3]; /* a3*a3*I3*R*m*2/I1 */
    out[30] = t52;
    const double t53 = t11/2.0; /* R*I3/2 */
    out[31] = t53;
    const double t54 = params[4]/t5; /* I3/(I1*R*R) */
    out[33] = t54;
    const double t55 = params[0]*t4; /* m*R*R */
    const double t56 = params[4]/t55; /* I3/(m*R*R) */
    out[34] = t56;
    const double t57 = params[1]*t4; /* R*R*R */
    const double t58 = params[0]*t57; /* m*R*R*R */
    const double t59 = params[3]*t58; /* I1*m*R*R*R */
    const double t60 = params[4]/t59; /* I3/(I1*m*R*R*R) */
    out[36] = t60;
    const double t61 = params[0]/2.0; /* m/2 */
    out[38] = t61;
    const double t62 = params[4]/params[3]; /* I3/I1 */
    out[39] = t62;
    const double t63 = params[3]*t55; /* I1*m*R*R */
    const double t64 = params[6]*params[6]; /* G*G */
    const double t65 = t64/t63; /* G*G/(I1*m*R*R) */
    out[40] = t65;
    const double t66 = t64/t5; /* G*G/(I1*R*R) */
    out[41] = t66;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t4 = p[4]*t3; /* I3*b */
    const double t5 = p[9]*t2; /* R^2*I1*s^2 */
    const double t6 = JLT_FMA(t3, t4, t5); /* K = b*I3*b + R^2*I1*s^2 */
    const double t7 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = p[10] + t6; /* Theta/m = I1*I3/m + K */
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
    const double t22 = JLT_FMA(x[3], t4, t21); /* v_tau*I3*b + R*G*s */
    const double t23 = t14*t22; /* 1/K*(v_tau*I3*b + R*G*s) */
    const double t24 = t19*t23; /* Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*1/K*(v_tau*I3*b + R*G*s) */
    const double t25 = x[3]*t24; /* v_tau*t24 */
    out[1] = t25;
    const double t26 = x[2]*t17; /* omega_tau*s */
    out[0] = t26;
    const double t27 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t28 = t26*t27; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t29 = JLT_FNMA(t23, t24, t28); /* omega_tau*s*omega_tau*m*a3^2/I1 - 1/K*(v_tau*I3*b + R*G*s)*t24 */
    const double t30 = x[0]*t29; /* gamma3*t29 */
    const double t31 = p[12]*t23; /* R*I3*1/K*(v_tau*I3*b + R*G*s) */
    const double t32 = JLT_FNMA(p[11], t17, t30); /* gamma3*t29 - m*g*a3/I1*s */
    const double t33 = x[3]*t17; /* v_tau*s */
    const double t34 = JLT_FNMA(p[13], t3, t33); /* v_tau*s - G/(R*I1)*b */
    const double t35 = t14*t34; /* 1/K*(v_tau*s - G/(R*I1)*b) */
    const double t36 = JLT_FNMA(t31, t35, t32); /* gamma3*t29 - m*g*a3/I1*s - R*I3*1/K*(v_tau*I3*b + R*G*s)*1/K*(v_tau*s - G/(R*I1)*b) */
    const double t37 = t20*t36; /* s^2*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*t36 */
    out[2] = t37;
    const double t38 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t39 = JLT_FMA(x[2], t38, x[1]); /* V = omega_tau*e + v_nu */
    const double t40 = p[10]*t39; /* I1*I3/m*V */
    const double t41 = JLT_FNMA(t16, t40, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t42 = t24*t41; /* t24*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t43 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t44 = x[2]*p[14]; /* omega_tau*R*I1*I3/m */
    const double t45 = t43*t44; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t46 = t16*t45; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t47 = JLT_FMA(t35, t46, t42); /* 1/K*(v_tau*s - G/(R*I1)*b)*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m + t24*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t48 = -t47; /* -t47 */
    out[3] = t48;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t3;
    const double t4 = t2*p[9]; /* s^2*R^2*I1 */
    const double t5 = x[0] + p[18]; /* b/R = gamma3 + a3/R */
    const double t6 = p[17]*t5; /* R^2*I3*b/R */
    const double t7 = JLT_FMA(t5, t6, t4); /* K = b/R*R^2*I3*b/R + s^2*R^2*I1 */
    const double t8 = t7 + p[10]; /* Theta/m = K + I1*I3/m */
    const double t9 = t2*t8; /* s^2*Theta/m */
    const double t10 = JLT_FMA(t2, p[7], 1.0); /* D/I1 = s^2*m*a3^2/I1 + 1 */
    const double t11 = t7*t10; /* K*D/I1 */
    const double t12 = t9*t11; /* s^2*Theta/m*K*D/I1 */
    const double t13 = 1.0/t12; /* 1/(s^2*Theta/m*K*D/I1) */
    const double t14 = t11*t13; /* K*D/I1*1/(s^2*Theta/m*K*D/I1) */
    const double t15 = t3*t8; /* s*Theta/m */
    const double t16 = t14*t15; /* K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m */
    const double t17 = x[0]*t16; /* gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m */
    const double t18 = x[2]*t17; /* omega_tau*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m */
    const double t19 = -t18; /* -omega_tau*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m */
    out[0] = t19;
    out[1] = 0.0;
    out[3] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[9] = 0.0;
    const double t20 = t5*p[12]; /* b/R*R*I3 */
    const double t21 = x[3]*t20; /* v_tau*b/R*R*I3 */
    const double t22 = JLT_FMA(t3, p[8], t21); /* s*R*G + v_tau*b/R*R*I3 */
    const double t23 = t9*t13; /* s^2*Theta/m*1/(s^2*Theta/m*K*D/I1) */
    const double t24 = t10*t23; /* 1/K = D/I1*s^2*Theta/m*1/(s^2*Theta/m*K*D/I1) */
    const double t25 = t22*t24; /* (s*R*G + v_tau*b/R*R*I3)*1/K */
    const double t26 = t16*t25; /* K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*(s*R*G + v_tau*b/R*R*I3)*1/K */
    const double t27 = t16*t26; /* K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*t26 */
    const double t28 = t17*t27; /* gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*t26 */
    const double t29 = t17*p[8]; /* gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*R*G */
    const double t30 = JLT_FNMA(x[3], p[12], t29); /* gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*R*G - v_tau*R*I3 */
    const double t31 = x[0]*p[19]; /* gamma3*2*R^2*I1 */
    const double t32 = JLT_FMS(t5, p[20], t31); /* d(K)/d(gamma3) = b/R*2*R^2*I3 - gamma3*2*R^2*I1 */
    const double t33 = t25*t32; /* (s*R*G + v_tau*b/R*R*I3)*1/K*d(K)/d(gamma3) */
    const double t34 = t30 + t33; /* t30 + (s*R*G + v_tau*b/R*R*I3)*1/K*d(K)/d(gamma3) */
    const double t35 = t16*t24; /* K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*1/K */
    const double t36 = JLT_FNMA(t34, t35, t28); /* t28 - (t30 + (s*R*G + v_tau*b/R*R*I3)*1/K*d(K)/d(gamma3))*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*1/K */
    const double t37 = x[3]*t36; /* v_tau*t36 */
    out[4] = t37;
    const double t38 = JLT_FMA(t21, t35, t26); /* v_tau*b/R*R*I3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*1/K + t26 */
    out[7] = t38;
    const double t39 = t7*t23; /* 1/(D/I1) = K*s^2*Theta/m*1/(s^2*Theta/m*K*D/I1) */
    const double t40 = x[0]*t39; /* gamma3*1/(D/I1) */
    const double t41 = t16*p[11]; /* K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*m*g*a3/I1 */
    const double t42 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t43 = x[2]*t3; /* omega_tau*s */
    const double t44 = t40*t43; /* gamma3*1/(D/I1)*omega_tau*s */
    const double t45 = x[2]*p[21]; /* omega_tau*2*m^2*a3^4/I1^2 */
    const double t46 = t3*p[22]; /* s*2*m^2*g*a3^3/I1^2 */
    const double t47 = JLT_FNMA(t39, t46, t41); /* K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*m*g*a3/I1 - 1/(D/I1)*s*2*m^2*g*a3^3/I1^2 */
    const double t48 = JLT_FNMA(t18, t42, t47); /* t47 - omega_tau*gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*omega_tau*m*a3^2/I1 */
    const double t49 = JLT_FMA(t44, t45, t48); /* gamma3*1/(D/I1)*omega_tau*s*omega_tau*2*m^2*a3^4/I1^2 + t48 */
    const double t50 = t40*t49; /* gamma3*1/(D/I1)*(gamma3*1/(D/I1)*omega_tau*s*omega_tau*2*m^2*a3^4/I1^2 + t48) */
    const double t51 = t42*t43; /* omega_tau*m*a3^2/I1*omega_tau*s */
    const double t52 = JLT_FNMA(t26, t27, t51); /* omega_tau*m*a3^2/I1*omega_tau*s - t26*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*t26 */
    const double t53 = p[7]*t22; /* m*a3^2/I1*(s*R*G + v_tau*b/R*R*I3) */
    const double t54 = JLT_FMS(t40, t53, t33); /* gamma3*1/(D/I1)*m*a3^2/I1*(s*R*G + v_tau*b/R*R*I3) - (s*R*G + v_tau*b/R*R*I3)*1/K*d(K)/d(gamma3) */
    const double t55 = t30 - t54; /* t30 - t54 */
    const double t56 = t24*t40; /* 1/K*gamma3*1/(D/I1) */
    const double t57 = t26*t56; /* t26*1/K*gamma3*1/(D/I1) */
    const double t58 = 2.0*t57; /* 2*t26*1/K*gamma3*1/(D/I1) */
    const double t59 = JLT_FMA(t17, x[3], p[23]); /* gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*v_tau + G/I1 */
    const double t60 = t23*t25; /* s^2*Theta/m*1/(s^2*Theta/m*K*D/I1)*(s*R*G + v_tau*b/R*R*I3)*1/K */
    const double t61 = t59*t60; /* (gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*v_tau + G/I1)*t60 */
    const double t62 = t3*x[3]; /* s*v_tau */
    const double t63 = JLT_FNMA(t5, p[23], t62); /* s*v_tau - b/R*G/I1 */
    const double t64 = t24*t63; /* 1/K*(s*v_tau - b/R*G/I1) */
    const double t65 = t23*t64; /* s^2*Theta/m*1/(s^2*Theta/m*K*D/I1)*1/K*(s*v_tau - b/R*G/I1) */
    const double t66 = JLT_FNMA(2.0, t54, t30); /* t30 - 2*t54 */
    const double t67 = JLT_FMA(t65, t66, t61); /* s^2*Theta/m*1/(s^2*Theta/m*K*D/I1)*1/K*(s*v_tau - b/R*G/I1)*(t30 - 2*t54) + t61 */
    const double t68 = JLT_FMA(t55, t58, t50); /* (t30 - t54)*2*t26*1/K*gamma3*1/(D/I1) + t50 */
    const double t69 = JLT_FMA(t39, t52, t68); /* 1/(D/I1)*t52 + (t30 - t54)*2*t26*1/K*gamma3*1/(D/I1) + t50 */
    const double t70 = JLT_FMA(p[12], t67, t69); /* R*I3*t67 + 1/(D/I1)*t52 + (t30 - t54)*2*t26*1/K*gamma3*1/(D/I1) + t50 */
    out[8] = t70;
    const double t71 = t44*p[24]; /* gamma3*1/(D/I1)*omega_tau*s*2*m*a3^2/I1 */
    out[10] = t71;
    const double t72 = t5*p[25]; /* b/R*(-2*R*I3) */
    const double t73 = t5*p[26]; /* b/R*(-R^2*I3^2) */
    const double t74 = t65*t73; /* s^2*Theta/m*1/(s^2*Theta/m*K*D/I1)*1/K*(s*v_tau - b/R*G/I1)*b/R*(-R^2*I3^2) */
    const double t75 = t3*p[27]; /* s*(-R*I3) */
    const double t76 = JLT_FMA(t60, t75, t74); /* t60*s*(-R*I3) + t74 */
    const double t77 = JLT_FMA(t57, t72, t76); /* t26*1/K*gamma3*1/(D/I1)*b/R*(-2*R*I3) + t60*s*(-R*I3) + t74 */
    out[11] = t77;
    const double t78 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t79 = JLT_FMA(x[2], t78, x[1]); /* V = omega_tau*e + v_nu */
    const double t80 = t2*t14; /* 1/(Theta/m) = s^2*K*D/I1*1/(s^2*Theta/m*K*D/I1) */
    const double t81 = p[10]*t80; /* I1*I3/m*1/(Theta/m) */
    const double t82 = JLT_FNMA(t79, t81, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t83 = t36*t82; /* t36*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t84 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t85 = p[14]*t84; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t86 = t24*t85; /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t87 = JLT_FMA(t80, t85, t86); /* 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) + 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t88 = JLT_FNMA(t32, t87, p[28]); /* R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t87 */
    const double t89 = t26*p[29]; /* t26*I1*I3*a3/m */
    const double t90 = JLT_FMA(t59, t86, t89); /* (gamma3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*v_tau + G/I1)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) + t26*I1*I3*a3/m */
    const double t91 = JLT_FNMA(t64, t88, t90); /* t90 - 1/K*(s*v_tau - b/R*G/I1)*(R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t87) */
    const double t92 = x[2]*t91; /* omega_tau*t91 */
    const double t93 = t26*t81; /* t26*I1*I3/m*1/(Theta/m) */
    const double t94 = t32*t79; /* d(K)/d(gamma3)*V */
    const double t95 = JLT_FNMA(t93, t94, t92); /* omega_tau*t91 - t26*I1*I3/m*1/(Theta/m)*d(K)/d(gamma3)*V */
    const double t96 = JLT_FMS(t80, t95, t83); /* 1/(Theta/m)*(omega_tau*t91 - t26*I1*I3/m*1/(Theta/m)*d(K)/d(gamma3)*V) - t36*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    out[12] = t96;
    const double t97 = t93 - t26; /* t26*I1*I3/m*1/(Theta/m) - t26 */
    out[13] = t97;
    const double t98 = t78*t93; /* e*t26*I1*I3/m*1/(Theta/m) */
    const double t99 = t80*t86; /* 1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t100 = JLT_FNMA(t63, t99, t98); /* e*t26*I1*I3/m*1/(Theta/m) - (s*v_tau - b/R*G/I1)*1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    out[14] = t100;
    const double t101 = t20*t35; /* b/R*R*I3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*1/K */
    const double t102 = t82*t101; /* (v_nu - V*I1*I3/m*1/(Theta/m))*b/R*R*I3*K*D/I1*1/(s^2*Theta/m*K*D/I1)*s*Theta/m*1/K */
    const double t103 = JLT_FMA(t43, t99, t102); /* omega_tau*s*1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) + t102 */
    const double t104 = -t103; /* -t103 */
    out[15] = t104;
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
    const double t3 = x[0] + p[18]; /* b/R = gamma3 + a3/R */
    const double t4 = p[9]*t2; /* R^2*I1*s^2 */
    const double t5 = p[17]*t3; /* R^2*I3*b/R */
    const double t6 = JLT_FMA(t3, t5, t4); /* K = b/R*R^2*I3*b/R + R^2*I1*s^2 */
    const double t7 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = p[10] + t6; /* Theta/m = I1*I3/m + K */
    const double t9 = t2*t7; /* s^2*D/I1 */
    const double t10 = t8*t9; /* Theta/m*s^2*D/I1 */
    const double t11 = t6*t10; /* K*Theta/m*s^2*D/I1 */
    const double t12 = 1.0/t11; /* 1/(K*Theta/m*s^2*D/I1) */
    const double t13 = t10*t12; /* 1/K = Theta/m*s^2*D/I1*1/(K*Theta/m*s^2*D/I1) */
    const double t14 = t6*t12; /* K*1/(K*Theta/m*s^2*D/I1) */
    const double t15 = t8*t14; /* Theta/m*K*1/(K*Theta/m*s^2*D/I1) */
    const double t16 = t9*t14; /* 1/(Theta/m) = s^2*D/I1*K*1/(K*Theta/m*s^2*D/I1) */
    const double t17 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t17;
    const double t18 = t7*t17; /* D/I1*s */
    const double t19 = t15*t18; /* Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s */
    const double t20 = t2*t15; /* 1/(D/I1) = s^2*Theta/m*K*1/(K*Theta/m*s^2*D/I1) */
    const double t21 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t22 = p[14]*t21; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t23 = t13*t22; /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t24 = p[8]*t17; /* R*G*s */
    const double t25 = x[3]*p[12]; /* v_tau*R*I3 */
    const double t26 = JLT_FMA(t3, t25, t24); /* b/R*v_tau*R*I3 + R*G*s */
    const double t27 = t13*t26; /* 1/K*(b/R*v_tau*R*I3 + R*G*s) */
    const double t28 = x[3]*t17; /* v_tau*s */
    const double t29 = JLT_FNMA(p[23], t3, t28); /* v_tau*s - G/I1*b/R */
    const double t30 = x[0]*p[19]; /* gamma3*2*R^2*I1 */
    const double t31 = JLT_FMS(p[20], t3, t30); /* d(K)/d(gamma3) = 2*R^2*I3*b/R - gamma3*2*R^2*I1 */
    const double t32 = t13*t29; /* 1/K*(v_tau*s - G/I1*b/R) */
    const double t33 = JLT_FNMA(t23, t31, p[28]); /* R^2*I1*I3*(I1 - I3)/m - 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*d(K)/d(gamma3) */
    const double t34 = t32*t33; /* 1/K*(v_tau*s - G/I1*b/R)*t33 */
    const double t35 = t20*t32; /* 1/(D/I1)*1/K*(v_tau*s - G/I1*b/R) */
    const double t36 = x[2]*t17; /* omega_tau*s */
    out[0] = t36;
    const double t37 = t17*t20; /* s*1/(D/I1) */
    const double t38 = t19*t27; /* Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*1/K*(b/R*v_tau*R*I3 + R*G*s) */
    const double t39 = JLT_FMS(p[29], t38, t34); /* I1*I3*a3/m*t38 - 1/K*(v_tau*s - G/I1*b/R)*t33 */
    const double t40 = x[3]*t38; /* v_tau*t38 */
    out[1] = t40;
    const double t41 = x[0]*t20; /* gamma3*1/(D/I1) */
    const double t42 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t43 = t16*t23; /* 1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t44 = t29*t43; /* (v_tau*s - G/I1*b/R)*1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t45 = x[0]*t19; /* gamma3*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s */
    const double t46 = JLT_FMS(p[8], t45, t25); /* R*G*gamma3*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s - v_tau*R*I3 */
    const double t47 = p[11]*t19; /* m*g*a3/I1*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s */
    const double t48 = JLT_FMS(p[22], t37, t47); /* 2*m^2*g*a3^3/I1^2*s*1/(D/I1) - m*g*a3/I1*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s */
    const double t49 = t27*t35; /* 1/K*(b/R*v_tau*R*I3 + R*G*s)*1/(D/I1)*1/K*(v_tau*s - G/I1*b/R) */
    const double t50 = JLT_FMA(p[30], t49, t48); /* 2*m*R*I3*a3^2/I1*t49 + t48 */
    const double t51 = t38*t41; /* t38*gamma3*1/(D/I1) */
    const double t52 = JLT_FMA(p[31], t35, t51); /* 1/2*R*I3*1/(D/I1)*1/K*(v_tau*s - G/I1*b/R) + t38*gamma3*1/(D/I1) */
    const double t53 = t27*t51; /* 1/K*(b/R*v_tau*R*I3 + R*G*s)*t38*gamma3*1/(D/I1) */
    const double t54 = JLT_FMA(p[12], t49, t53); /* R*I3*t49 + 1/K*(b/R*v_tau*R*I3 + R*G*s)*t38*gamma3*1/(D/I1) */
    const double t55 = JLT_FMA(p[24], t53, t50); /* 2*m*a3^2/I1*1/K*(b/R*v_tau*R*I3 + R*G*s)*t38*gamma3*1/(D/I1) + 2*m*R*I3*a3^2/I1*t49 + t48 */
    const double t56 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t57 = p[10]*t16; /* I1*I3/m*1/(Theta/m) */
    const double t58 = t19*t38; /* Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*t38 */
    const double t59 = p[12]*t13; /* R*I3*1/K */
    const double t60 = t3*t59; /* b/R*R*I3*1/K */
    const double t61 = t27*t59; /* 1/K*(b/R*v_tau*R*I3 + R*G*s)*R*I3*1/K */
    const double t62 = t36*t42; /* omega_tau*s*omega_tau*m*a3^2/I1 */
    const double t63 = JLT_FNMA(t38, t58, t62); /* omega_tau*s*omega_tau*m*a3^2/I1 - t38*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*t38 */
    const double t64 = t45*t58; /* gamma3*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*t38 */
    const double t65 = JLT_FMA(x[3], t45, p[23]); /* v_tau*gamma3*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s + G/I1 */
    const double t66 = JLT_FMA(t23, t65, t39); /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*(v_tau*gamma3*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s + G/I1) + I1*I3*a3/m*t38 - 1/K*(v_tau*s - G/I1*b/R)*t33 */
    const double t67 = JLT_FMA(t61, t65, t63); /* 1/K*(b/R*v_tau*R*I3 + R*G*s)*R*I3*1/K*(v_tau*gamma3*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s + G/I1) + t63 */
    const double t68 = t20*t67; /* 1/(D/I1)*t67 */
    const double t69 = x[2]*t66; /* omega_tau*t66 */
    const double t70 = t36*t41; /* omega_tau*s*gamma3*1/(D/I1) */
    const double t71 = p[24]*t70; /* 2*m*a3^2/I1*omega_tau*s*gamma3*1/(D/I1) */
    out[14] = t71;
    const double t72 = x[2]*t44; /* omega_tau*t44 */
    const double t73 = JLT_FMA(x[2], t56, x[1]); /* V = omega_tau*e + v_nu */
    const double t74 = t42*t45; /* omega_tau*m*a3^2/I1*gamma3*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s */
    const double t75 = JLT_FNMA(p[21], t70, t74); /* t74 - 2*m^2*a3^4/I1^2*omega_tau*s*gamma3*1/(D/I1) */
    const double t76 = JLT_FMA(x[2], t75, t55); /* omega_tau*(t74 - 2*m^2*a3^4/I1^2*omega_tau*s*gamma3*1/(D/I1)) + t55 */
    const double t77 = JLT_FNMA(t41, t76, t68); /* 1/(D/I1)*t67 - gamma3*1/(D/I1)*t76 */
    const double t78 = x[2]*t45; /* omega_tau*gamma3*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s */
    const double t79 = -t78; /* -omega_tau*gamma3*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s */
    out[4] = t79;
    const double t80 = t38*t57; /* t38*I1*I3/m*1/(Theta/m) */
    const double t81 = JLT_FMS(t56, t80, t44); /* e*t38*I1*I3/m*1/(Theta/m) - t44 */
    out[18] = t81;
    const double t82 = JLT_FNMA(t57, t73, x[1]); /* v_nu - I1*I3/m*1/(Theta/m)*V */
    const double t83 = JLT_FMS(t73, t80, t72); /* V*t38*I1*I3/m*1/(Theta/m) - omega_tau*t44 */
    const double t84 = JLT_FNMA(t31, t83, t69); /* omega_tau*t66 - d(K)/d(gamma3)*(V*t38*I1*I3/m*1/(Theta/m) - omega_tau*t44) */
    const double t85 = t16*t84; /* 1/(Theta/m)*t84 */
    const double t86 = t80 - t38; /* t38*I1*I3/m*1/(Theta/m) - t38 */
    out[17] = t86;
    const double t87 = JLT_FMA(t38, t82, t72); /* t38*(v_nu - I1*I3/m*1/(Theta/m)*V) + omega_tau*t44 */
    const double t88 = -t87; /* -(t38*(v_nu - I1*I3/m*1/(Theta/m)*V) + omega_tau*t44) */
    out[3] = t88;
    const double t89 = t19*t46; /* Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*t46 */
    const double t90 = t19*t60; /* Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*b/R*R*I3*1/K */
    const double t91 = 2.0*t60; /* 2*b/R*R*I3*1/K */
    const double t92 = JLT_FMA(t31, t38, t89); /* d(K)/d(gamma3)*t38 + Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*t46 */
    const double t93 = JLT_FNMA(t13, t92, t64); /* t64 - 1/K*t92 */
    const double t94 = JLT_FMA(x[3], t90, t38); /* v_tau*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*b/R*R*I3*1/K + t38 */
    out[11] = t94;
    const double t95 = JLT_FNMA(t82, t93, t85); /* 1/(Theta/m)*t84 - (v_nu - I1*I3/m*1/(Theta/m)*V)*(t64 - 1/K*t92) */
    out[16] = t95;
    const double t96 = t82*t90; /* (v_nu - I1*I3/m*1/(Theta/m)*V)*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*D/I1*s*b/R*R*I3*1/K */
    const double t97 = JLT_FMA(t36, t43, t96); /* omega_tau*s*1/(Theta/m)*1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) + t96 */
    const double t98 = x[3]*t93; /* v_tau*(t64 - 1/K*t92) */
    out[8] = t98;
    const double t99 = -t97; /* -t97 */
    out[19] = t99;
    const double t100 = t31*t54; /* d(K)/d(gamma3)*(R*I3*t49 + 1/K*(b/R*v_tau*R*I3 + R*G*s)*t38*gamma3*1/(D/I1)) */
    const double t101 = JLT_FMA(t46, t52, t100); /* t46*t52 + t100 */
    const double t102 = t52*t91; /* t52*2*b/R*R*I3*1/K */
    const double t103 = JLT_FMA(t37, t61, t102); /* s*1/(D/I1)*1/K*(b/R*v_tau*R*I3 + R*G*s)*R*I3*1/K + t52*2*b/R*R*I3*1/K */
    const double t104 = JLT_FMA(p[11], t37, t54); /* m*g*a3/I1*s*1/(D/I1) + R*I3*t49 + 1/K*(b/R*v_tau*R*I3 + R*G*s)*t38*gamma3*1/(D/I1) */
    const double t105 = JLT_FMS(t42, t70, t104); /* omega_tau*m*a3^2/I1*omega_tau*s*gamma3*1/(D/I1) - t104 */
    out[2] = t105;
    const double t106 = -t103; /* -t103 */
    out[15] = t106;
    const double t107 = 2.0*t13; /* 2*1/K */
    const double t108 = JLT_FMA(t101, t107, t77); /* (t46*t52 + t100)*2*1/K + 1/(D/I1)*t67 - gamma3*1/(D/I1)*t76 */
    out[12] = t108;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t4 = p[33]*t3; /* I3/(R^2*I1)*b */
    const double t5 = JLT_FMA(t3, t4, t2); /* K/(R^2*I1) = b*I3/(R^2*I1)*b + s^2 */
    const double t6 = JLT_FMA(p[35], t2, p[3]); /* D = m*a3^2*s^2 + I1 */
    const double t7 = p[34] + t5; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t8 = t5*t6; /* K/(R^2*I1)*D */
    const double t9 = p[32]*t5; /* 2*m*a3^2*K/(R^2*I1) */
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
    const double t24 = p[34]*t23; /* I3/(m*R^2)*V */
    const double t25 = JLT_FNMA(t17, t24, x[1]); /* v_nu - 1/(Theta/(m*R^2*I1))*I3/(m*R^2)*V */
    const double t26 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t27 = x[2]*p[36]; /* omega_tau*I3/(m*R^3*I1) */
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
    const double t3 = x[0] + p[18]; /* b/R = gamma3 + a3/R */
    const double t4 = p[39]*t3; /* I3/I1*b/R */
    const double t5 = JLT_FMA(t3, t4, t2); /* K/(R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(gamma3 + 1) */
    const double t6 = JLT_FMA(p[35], t2, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t7 = p[34] + t5; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t8 = x[3]*x[3]; /* v_tau*v_tau */
    const double t9 = JLT_FMA(t7, t8, p[40]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t10 = t9/t5; /* (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t11 = JLT_FMA(x[1], x[1], t10); /* v_nu*v_nu + (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = p[37]*x[0]; /* m*g*a3*gamma3 */
    const double t15 = JLT_FMA(t6, t13, t14); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(p[38], t11, t15); /* 1/2*m*t11 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    out[0] = t16;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[1]; /* m*v_nu */
    out[1] = t0;
    const double t1 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t2 = x[0] + 1.0; /* gamma3 + 1 */
    const double t3 = t1*t2; /* (1 - gamma3)*(gamma3 + 1) */
    const double t4 = x[0] + p[18]; /* b/R = gamma3 + a3/R */
    const double t5 = p[39]*t4; /* I3/I1*b/R */
    const double t6 = JLT_FMA(t4, t5, t3); /* K/(R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(gamma3 + 1) */
    const double t7 = t5 - x[0]; /* d(K)/d(gamma3)/(2*R^2*I1) = I3/I1*b/R - gamma3 */
    const double t8 = JLT_FMA(p[35], t3, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t9 = x[2]*t8; /* omega_tau*D */
    out[2] = t9;
    const double t10 = x[3]*p[0]; /* v_tau*m */
    const double t11 = p[34] + t6; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t12 = 1.0/t6; /* 1/(K/(R^2*I1)) */
    const double t13 = t10*t11; /* v_tau*m*Theta/(m*R^2*I1) */
    const double t14 = t12*t13; /* 1/(K/(R^2*I1))*v_tau*m*Theta/(m*R^2*I1) */
    out[3] = t14;
    const double t15 = t10 - t14; /* v_tau*m - 1/(K/(R^2*I1))*v_tau*m*Theta/(m*R^2*I1) */
    const double t16 = x[3]*t15; /* v_tau*(v_tau*m - 1/(K/(R^2*I1))*v_tau*m*Theta/(m*R^2*I1)) */
    const double t17 = JLT_FNMA(p[41], t12, t16); /* v_tau*(v_tau*m - 1/(K/(R^2*I1))*v_tau*m*Theta/(m*R^2*I1)) - G^2/(R^2*I1)*1/(K/(R^2*I1)) */
    const double t18 = t7*t12; /* d(K)/d(gamma3)/(2*R^2*I1)*1/(K/(R^2*I1)) */
    const double t19 = p[35]*x[0]; /* m*a3^2*gamma3 */
    const double t20 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t21 = JLT_FNMA(t19, t20, p[37]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    const double t22 = JLT_FMA(t17, t18, t21); /* t17*d(K)/d(gamma3)/(2*R^2*I1)*1/(K/(R^2*I1)) + m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
    out[0] = t22;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
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
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t18[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t19[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t20[k] = jlt_jet_product(t18, t19, k);
        t21[k] = x0[k]*p[1] + (k == 0 ? p[5] : 0);
        t22[k] = p[9]*t20[k];
        t23[k] = p[4]*t21[k];
        t24[k] = jlt_jet_product(t21, t23, k) + t22[k];
        t25[k] = jlt_jet_root(t20[k], t25, k);
        t26[k] = p[7]*t20[k] + (k == 0 ? 1.0 : 0);
        t27[k] = jlt_jet_product(t24, t25, k);
        t28[k] = (k == 0 ? p[10] : 0) + t24[k];
        t29[k] = jlt_jet_product(t26, t27, k);
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t30, t31, k);
        t32[k] = jlt_jet_product(t28, t31, k);
        t33[k] = jlt_jet_product(t29, t31, k);
        t34[k] = jlt_jet_product(t26, t32, k);
        t35[k] = jlt_jet_product(t27, t32, k);
        t36[k] = jlt_jet_product(t24, t34, k);
        t37[k] = jlt_jet_product(t25, t34, k);
        t38[k] = p[8]*t25[k];
        t39[k] = jlt_jet_product(x3, t23, k) + t38[k];
        t40[k] = jlt_jet_product(t37, t39, k);
        t41[k] = jlt_jet_product(t36, t40, k);
        t42[k] = jlt_jet_product(x3, t41, k);
        t43[k] = jlt_jet_product(x2, t25, k);
        t44[k] = x2[k]*p[7];
        t45[k] = jlt_jet_product(t43, t44, k);
        t46[k] = t45[k] - jlt_jet_product(t40, t41, k);
        t47[k] = jlt_jet_product(x0, t46, k);
        t48[k] = p[12]*t40[k];
        t49[k] = t47[k] - p[11]*t25[k];
        t50[k] = jlt_jet_product(x3, t25, k);
        t51[k] = t50[k] - p[13]*t21[k];
        t52[k] = jlt_jet_product(t37, t51, k);
        t53[k] = t49[k] - jlt_jet_product(t48, t52, k);
        t54[k] = jlt_jet_product(t35, t53, k);
        t55[k] = x0[k]*p[5] + (k == 0 ? p[1] : 0);
        t56[k] = jlt_jet_product(x2, t55, k) + x1[k];
        t57[k] = p[10]*t56[k];
        t58[k] = x1[k] - jlt_jet_product(t33, t57, k);
        t59[k] = jlt_jet_product(t41, t58, k);
        t60[k] = x0[k]*p[15] - (k == 0 ? p[16] : 0);
        t61[k] = x2[k]*p[14];
        t62[k] = jlt_jet_product(t60, t61, k);
        t63[k] = jlt_jet_product(t33, t62, k);
        t64[k] = jlt_jet_product(t52, t63, k) + t59[k];
        t65[k] = -t64[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t43[k]/(k + 1);
        next[1] = x1[k + 1] = t42[k]/(k + 1);
        next[2] = x2[k + 1] = t54[k]/(k + 1);
        next[3] = x3[k + 1] = t65[k]/(k + 1);
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

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0) },
};

static const jlt_named integrals[] = {
    { "E", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_general = {
    .model = "spherical_top_level",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "a03ac57982f08b300ad072746897d22dbcd0a4e4ebdedbf1bb5bf573f26d0de6",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .state_count = 4, .param_count = 7, .block_count = 42,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 30, 13, 1, 1, 0, 17, 10 }, { 21, 80, 0, 8, 1, 0, 12, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau*I3*b + (R*G)*s, a part of d(omega_tau)/dt, v_tau*s - (G/(R*I1))*b, a part of d(omega_tau)/dt, e = gamma3*a3 + R, V = omega_tau*e + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(v_tau)/dt" },
    .jacobian = { jacobian, 16, { 9, 61, 33, 1, 1, 0, 18, 27 }, { 91, 425, 0, 50, 1, 0, 21, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, s*(R*G) + v_tau*b/R*(R*I3), gamma3*K*D/I1*((1)/s^2*Theta/m*K*D/I1)*s*Theta/m*(R*G) - v_tau*(R*I3), d(K)/d(gamma3) = b/R*(2*R^2*I3) - gamma3*(2*R^2*I1), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(v_tau), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), gamma3*K*D/I1*((1)/s^2*Theta/m*K*D/I1)*s*Theta/m*v_tau + G/I1, s*v_tau - b/R*(G/I1), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(v_tau), e = gamma3*a3 + R, V = omega_tau*e + v_nu, v_nu - V*(I1*I3/m)*1/(Theta/m), gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(v_nu), d(d(v_tau)/dt)/d(omega_tau), a part of d(d(v_tau)/dt)/d(v_tau)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 9, 60, 38, 1, 1, 0, 18, 28 }, { 105, 489, 0, 58, 1, 0, 21, 14 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, gamma3*(R*(I1 - I3)) - (I3*a3), b/R*v_tau*(R*I3) + (R*G)*s, v_tau*s - (G/I1)*b/R, d(K)/d(gamma3) = (2*R^2*I3)*b/R - gamma3*(2*R^2*I1), a part of d(d(v_tau)/dt)/d(gamma3), (R*G)*gamma3*Theta/m*K*((1)/K*Theta/m*s^2*D/I1)*D/I1*s - v_tau*(R*I3), a part of d(d(omega_tau)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(v_tau), a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), e = gamma3*a3 + R, v_tau*gamma3*Theta/m*K*((1)/K*Theta/m*s^2*D/I1)*D/I1*s + G/I1, a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), V = omega_tau*e + v_nu, a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(omega_tau), v_nu - (I1*I3/m)*1/(Theta/m)*V, a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(v_nu), a part of d(v_tau)/dt, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(v_tau), d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(v_tau), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(v_tau), d(omega_tau)/dt, d(d(omega_tau)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 3, 20, 10, 1, 1, 0, 12, 9 }, { 13, 41, 0, 5, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, (2*m*a3^2)*K/(R^2*I1)*1/(D*(K/(R^2*I1))) - 1/s^2, e = gamma3*a3 + R, V = omega_tau*e + v_nu, v_nu - 1/(Theta/(m*R^2*I1))*(I3/(m*R^2))*V, gamma3*(R*(I1 - I3)) - (I3*a3), a part of the divergence, the divergence" },
    .integral_values = { integral_values, 1, { 4, 6, 6, 1, 0, 0, 8, 5 }, { 9, 28, 0, 2, 1, 0, 13, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, E" },
    .integral_gradients = { integral_gradients, 4, { 6, 11, 5, 1, 0, 0, 10, 5 }, { 10, 44, 0, 4, 1, 0, 15, 10 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, d(K)/d(gamma3)/(2*R^2*I1) = (I3/I1)*b/R - gamma3, v_tau*m - ((1)/K/(R^2*I1))*v_tau*m*Theta/(m*R^2*I1), a part of d(E)/d(gamma3), d(E)/d(gamma3)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 1,
    .integrals = integrals,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_level_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = {
        &jlt_batch_spherical_top_level_general_baseline,
        &jlt_batch_spherical_top_level_general_avx2,
        &jlt_batch_spherical_top_level_general_avx512,
    },
#endif
};
