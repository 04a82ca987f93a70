/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Table:      spherical_top_level, SHA-256 a0362d7aafe4ac095061c9e2c7f9417b05b6c21c51ed0a0e3c3f227f5c7cacca
 *  Command:    ttc generate --effort full --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   30   13    1    1    0     17   10   (110)
 *  jacobian            11   58   31    1    1    0     19   23   (567)
 *  rhs_jacobian        11   66   35    1    1    0     20   27   (653)
 *  divergence          4   21    9    1    1    0     14    9   (60)
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
 *    digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, (R*G)*s + v_tau*(R*I3)*b/R,
 *      gamma3*(R*(I1 - I3)) - (I3*a3), omega_tau*(m*a3^2/I1)*omega_tau*gamma3*1/(D/I1) - (m*g*a3/I1)*1/(D/I1),
 *      v_tau*s - (G/I1)*b/R, d(K)/d(gamma3) = (2*R^2*I3)*b/R - gamma3*(2*R^2*I1), e = gamma3*a3 + R,
 *      a part of d(d(v_tau)/dt)/d(gamma3), (R*G)*gamma3*D/I1*Theta/m*((1)/Theta/m*D/I1*s^2*K)*K*s - v_tau*(R*I3),
 *      V = omega_tau*e + v_nu, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), d(omega_tau)/dt,
 *      v_nu - V*(I1*I3/m)*1/(Theta/m), d(d(v_nu)/dt)/d(v_tau), d(d(v_tau)/dt)/d(omega_tau),
 *      v_tau*gamma3*D/I1*Theta/m*((1)/Theta/m*D/I1*s^2*K)*K*s + G/I1,
 *      a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3),
 *      a part of d(d(omega_tau)/dt)/d(v_tau), a part of d(d(omega_tau)/dt)/d(v_tau),
 *      a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(v_tau),
 *      a part of d(v_tau)/dt, a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3),
 *      d(d(v_tau)/dt)/d(gamma3)
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
    out[30] = t1;
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
    out[37] = t8;
    const double t9 = params[5]*t8; /* a3*m*g */
    out[33] = t9;
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
    const double t24 = params[0]*2.0; /* m*2 */
    const double t25 = t0*t24; /* a3*a3*m*2 */
    out[27] = t25;
    const double t26 = t25/params[3]; /* a3*a3*m*2/I1 */
    out[21] = t26;
    const double t27 = params[6]/params[3]; /* G/I1 */
    out[22] = t27;
    const double t28 = params[5]*t6; /* a3*I1*I3 */
    const double t29 = t28/params[0]; /* a3*I1*I3/m */
    out[23] = t29;
    const double t30 = t5*params[4]; /* I1*R*R*I3 */
    const double t31 = t16*t30; /* (I1 - I3)*I1*R*R*I3 */
    const double t32 = t31/params[0]; /* (I1 - I3)*I1*R*R*I3/m */
    out[24] = t32;
    const double t33 = params[0]*params[0]; /* m*m */
    const double t34 = 2.0*t33; /* 2*m*m */
    const double t35 = params[3]*params[3]; /* I1*I1 */
    const double t36 = t0*t0; /* a3*a3*a3*a3 */
    const double t37 = t34*t36; /* 2*m*m*a3*a3*a3*a3 */
    const double t38 = t37/t35; /* 2*m*m*a3*a3*a3*a3/(I1*I1) */
    out[25] = t38;
    const double t39 = params[2]*t34; /* g*2*m*m */
    const double t40 = params[5]*t0; /* a3*a3*a3 */
    const double t41 = t39*t40; /* g*2*m*m*a3*a3*a3 */
    const double t42 = t41/t35; /* g*2*m*m*a3*a3*a3/(I1*I1) */
    out[26] = t42;
    const double t43 = params[4]/params[3]; /* I3/I1 */
    out[28] = t43;
    const double t44 = params[0]*t4; /* m*R*R */
    const double t45 = params[4]/t44; /* I3/(m*R*R) */
    out[29] = t45;
    const double t46 = params[1]*t4; /* R*R*R */
    const double t47 = params[0]*t46; /* m*R*R*R */
    const double t48 = params[3]*t47; /* I1*m*R*R*R */
    const double t49 = params[4]/t48; /* I3/(I1*m*R*R*R) */
    out[31] = t49;
    const double t50 = 1.0/t12; /* 1/(I1*R) */
    out[32] = t50;
    const double t51 = params[0]/2.0; /* m/2 */
    out[34] = t51;
    const double t52 = params[3]*t44; /* I1*m*R*R */
    const double t53 = params[6]*params[6]; /* G*G */
    const double t54 = t53/t52; /* G*G/(I1*m*R*R) */
    out[35] = t54;
    const double t55 = t53/t5; /* G*G/(I1*R*R) */
    out[36] = t55;
    const double t56 = params[0]*params[5]; /* m*a3 */
    out[38] = t56;
    const double t57 = params[2]/params[3]; /* g/I1 */
    out[39] = t57;
    const double t58 = params[5]/params[3]; /* a3/I1 */
    out[40] = t58;
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
    const double t31 = JLT_FNMA(p[11], t17, t30); /* gamma3*t29 - m*g*a3/I1*s */
    const double t32 = x[3]*t17; /* v_tau*s */
    const double t33 = JLT_FNMA(p[13], t3, t32); /* v_tau*s - G/(R*I1)*b */
    const double t34 = t14*t33; /* 1/K*(v_tau*s - G/(R*I1)*b) */
    const double t35 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t36 = JLT_FMA(x[2], t35, x[1]); /* V = omega_tau*e + v_nu */
    const double t37 = p[10]*t36; /* I1*I3/m*V */
    const double t38 = JLT_FNMA(t16, t37, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t39 = t24*t38; /* t24*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t40 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t41 = x[2]*p[14]; /* omega_tau*R*I1*I3/m */
    const double t42 = t40*t41; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t43 = t16*t42; /* 1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m */
    const double t44 = JLT_FMA(t34, t43, t39); /* 1/K*(v_tau*s - G/(R*I1)*b)*1/(Theta/m)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*R*I1*I3/m + t24*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t45 = -t44; /* -t44 */
    out[3] = t45;
    const double t46 = p[12]*t34; /* R*I3*1/K*(v_tau*s - G/(R*I1)*b) */
    const double t47 = JLT_FNMA(t23, t46, t31); /* gamma3*t29 - m*g*a3/I1*s - 1/K*(v_tau*I3*b + R*G*s)*R*I3*1/K*(v_tau*s - G/(R*I1)*b) */
    const double t48 = t20*t47; /* s^2*Theta/m*K*1/(K*Theta/m*s^2*D/I1)*t47 */
    out[2] = t48;
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
    const double t3 = x[0] + p[18]; /* b/R = gamma3 + a3/R */
    const double t4 = p[9]*t2; /* R^2*I1*s^2 */
    const double t5 = p[17]*t3; /* R^2*I3*b/R */
    const double t6 = JLT_FMA(t3, t5, t4); /* K = b/R*R^2*I3*b/R + R^2*I1*s^2 */
    const double t7 = JLT_FMA(p[7], t2, 1.0); /* D/I1 = m*a3^2/I1*s^2 + 1 */
    const double t8 = p[10] + t6; /* Theta/m = I1*I3/m + K */
    const double t9 = t6*t7; /* K*D/I1 */
    const double t10 = t8*t9; /* Theta/m*K*D/I1 */
    const double t11 = t2*t10; /* s^2*Theta/m*K*D/I1 */
    const double t12 = 1.0/t11; /* 1/(s^2*Theta/m*K*D/I1) */
    const double t13 = sqrt(t2); /* s = sqrt(s^2) */
    out[2] = t13;
    const double t14 = t10*t13; /* Theta/m*K*D/I1*s */
    const double t15 = t2*t12; /* 1/(K*(D/I1)*(Theta/m)) = s^2*1/(s^2*Theta/m*K*D/I1) */
    const double t16 = t12*t14; /* 1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s */
    const double t17 = t8*t15; /* 1/(K*(D/I1)) = Theta/m*1/(K*(D/I1)*(Theta/m)) */
    const double t18 = t9*t15; /* 1/(Theta/m) = K*D/I1*1/(K*(D/I1)*(Theta/m)) */
    const double t19 = t7*t17; /* 1/K = D/I1*1/(K*(D/I1)) */
    const double t20 = t6*t17; /* 1/(D/I1) = K*1/(K*(D/I1)) */
    const double t21 = p[8]*t13; /* R*G*s */
    const double t22 = p[12]*t3; /* R*I3*b/R */
    const double t23 = JLT_FMA(x[3], t22, t21); /* v_tau*R*I3*b/R + R*G*s */
    const double t24 = t19*t23; /* 1/K*(v_tau*R*I3*b/R + R*G*s) */
    const double t25 = t19*t22; /* 1/K*R*I3*b/R */
    const double t26 = x[0]*t16; /* gamma3*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s */
    const double t27 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t28 = p[14]*t27; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t29 = p[8]*t26; /* R*G*gamma3*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s */
    const double t30 = JLT_FNMA(x[3], p[12], t29); /* R*G*gamma3*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s - v_tau*R*I3 */
    const double t31 = t19*t30; /* 1/K*t30 */
    const double t32 = x[0]*p[19]; /* gamma3*2*R^2*I1 */
    const double t33 = JLT_FMS(p[20], t3, t32); /* d(K)/d(gamma3) = 2*R^2*I3*b/R - gamma3*2*R^2*I1 */
    const double t34 = x[0]*t20; /* gamma3*1/(D/I1) */
    const double t35 = x[3]*t13; /* v_tau*s */
    const double t36 = JLT_FNMA(p[22], t3, t35); /* v_tau*s - G/I1*b/R */
    const double t37 = t19*t36; /* 1/K*(v_tau*s - G/I1*b/R) */
    const double t38 = t16*t24; /* 1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s*1/K*(v_tau*R*I3*b/R + R*G*s) */
    const double t39 = t19*t24; /* 1/K*1/K*(v_tau*R*I3*b/R + R*G*s) */
    const double t40 = t19*t28; /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t41 = t18*t28; /* 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t42 = p[21]*t34; /* 2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t43 = t24*t42; /* 1/K*(v_tau*R*I3*b/R + R*G*s)*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t44 = t33*t39; /* d(K)/d(gamma3)*1/K*1/K*(v_tau*R*I3*b/R + R*G*s) */
    const double t45 = p[12]*t39; /* R*I3*1/K*1/K*(v_tau*R*I3*b/R + R*G*s) */
    const double t46 = JLT_FMA(x[3], t26, p[22]); /* v_tau*gamma3*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s + G/I1 */
    const double t47 = 2.0*t34; /* 2*gamma3*1/(D/I1) */
    const double t48 = t38*t47; /* t38*2*gamma3*1/(D/I1) */
    const double t49 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t50 = p[23]*t38; /* I1*I3*a3/m*t38 */
    const double t51 = JLT_FMA(t40, t46, t50); /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*(v_tau*gamma3*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s + G/I1) + I1*I3*a3/m*t38 */
    const double t52 = t45*t46; /* R*I3*1/K*1/K*(v_tau*R*I3*b/R + R*G*s)*(v_tau*gamma3*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s + G/I1) */
    const double t53 = t40 + t41; /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) + 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t54 = JLT_FNMA(t33, t53, p[24]); /* R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t53 */
    const double t55 = JLT_FNMA(t37, t54, t51); /* t51 - 1/K*(v_tau*s - G/I1*b/R)*(R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t53) */
    const double t56 = x[2]*t55; /* omega_tau*t55 */
    const double t57 = t31 + t44; /* 1/K*t30 + d(K)/d(gamma3)*1/K*1/K*(v_tau*R*I3*b/R + R*G*s) */
    const double t58 = t31 - t43; /* 1/K*t30 - 1/K*(v_tau*R*I3*b/R + R*G*s)*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t59 = JLT_FMA(2.0, t44, t58); /* 2*d(K)/d(gamma3)*1/K*1/K*(v_tau*R*I3*b/R + R*G*s) + t58 */
    const double t60 = x[0]*t43; /* gamma3*1/K*(v_tau*R*I3*b/R + R*G*s)*2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t61 = JLT_FMA(t16, t38, t60); /* 1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s*t38 + t60 */
    const double t62 = JLT_FMS(t13, t42, t26); /* s*2*m*a3^2/I1*gamma3*1/(D/I1) - gamma3*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s */
    const double t63 = JLT_FMS(p[11], t62, t52); /* m*g*a3/I1*t62 - t52 */
    const double t64 = JLT_FMA(t38, t61, t63); /* t38*(1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s*t38 + t60) + m*g*a3/I1*t62 - t52 */
    const double t65 = t13*t20; /* s*1/(D/I1) */
    const double t66 = JLT_FMA(t34, t62, t65); /* gamma3*1/(D/I1)*t62 + s*1/(D/I1) */
    const double t67 = x[2]*t13; /* omega_tau*s */
    const double t68 = t42*t67; /* 2*m*a3^2/I1*gamma3*1/(D/I1)*omega_tau*s */
    out[10] = t68;
    const double t69 = t18*t67; /* 1/(Theta/m)*omega_tau*s */
    const double t70 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t71 = x[2]*t70; /* omega_tau*omega_tau*m*a3^2/I1 */
    const double t72 = t66*t71; /* (gamma3*1/(D/I1)*t62 + s*1/(D/I1))*omega_tau*omega_tau*m*a3^2/I1 */
    const double t73 = JLT_FMA(t48, t57, t72); /* t38*2*gamma3*1/(D/I1)*(1/K*t30 + d(K)/d(gamma3)*1/K*1/K*(v_tau*R*I3*b/R + R*G*s)) + t72 */
    const double t74 = JLT_FMS(t26, t38, t57); /* gamma3*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s*t38 - (1/K*t30 + d(K)/d(gamma3)*1/K*1/K*(v_tau*R*I3*b/R + R*G*s)) */
    const double t75 = t16*t74; /* 1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s*t74 */
    const double t76 = t16*t25; /* 1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s*1/K*R*I3*b/R */
    const double t77 = x[2]*t26; /* omega_tau*gamma3*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s */
    const double t78 = -t77; /* -omega_tau*gamma3*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s */
    out[0] = t78;
    const double t79 = x[3]*t75; /* v_tau*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s*t74 */
    out[4] = t79;
    const double t80 = JLT_FMA(x[3], t76, t38); /* v_tau*1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s*1/K*R*I3*b/R + t38 */
    out[7] = t80;
    const double t81 = p[12]*t37; /* R*I3*1/K*(v_tau*s - G/I1*b/R) */
    const double t82 = JLT_FNMA(t59, t81, t64); /* t64 - (2*d(K)/d(gamma3)*1/K*1/K*(v_tau*R*I3*b/R + R*G*s) + t58)*R*I3*1/K*(v_tau*s - G/I1*b/R) */
    const double t83 = JLT_FNMA(t20, t82, t73); /* t73 - 1/(D/I1)*t82 */
    out[8] = t83;
    const double t84 = JLT_FMA(t20, t81, t48); /* 1/(D/I1)*R*I3*1/K*(v_tau*s - G/I1*b/R) + t38*2*gamma3*1/(D/I1) */
    const double t85 = t25*t84; /* 1/K*R*I3*b/R*t84 */
    const double t86 = JLT_FMA(t45, t65, t85); /* R*I3*1/K*1/K*(v_tau*R*I3*b/R + R*G*s)*s*1/(D/I1) + 1/K*R*I3*b/R*t84 */
    const double t87 = -t86; /* -t86 */
    out[11] = t87;
    const double t88 = JLT_FMA(x[2], t49, x[1]); /* V = omega_tau*e + v_nu */
    const double t89 = t33*t88; /* d(K)/d(gamma3)*V */
    const double t90 = p[10]*t18; /* I1*I3/m*1/(Theta/m) */
    const double t91 = JLT_FNMA(t88, t90, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t92 = t38*t90; /* t38*I1*I3/m*1/(Theta/m) */
    const double t93 = JLT_FNMA(t89, t92, t56); /* omega_tau*t55 - d(K)/d(gamma3)*V*t38*I1*I3/m*1/(Theta/m) */
    const double t94 = t92 - t38; /* t38*I1*I3/m*1/(Theta/m) - t38 */
    out[13] = t94;
    const double t95 = t49*t92; /* e*t38*I1*I3/m*1/(Theta/m) */
    const double t96 = JLT_FNMA(t37, t41, t95); /* e*t38*I1*I3/m*1/(Theta/m) - 1/K*(v_tau*s - G/I1*b/R)*1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    out[14] = t96;
    const double t97 = t76*t91; /* 1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s*1/K*R*I3*b/R*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t98 = JLT_FMA(t40, t69, t97); /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*1/(Theta/m)*omega_tau*s + t97 */
    const double t99 = t75*t91; /* 1/(s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s*t74*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t100 = JLT_FMS(t18, t93, t99); /* 1/(Theta/m)*(omega_tau*t55 - d(K)/d(gamma3)*V*t38*I1*I3/m*1/(Theta/m)) - t99 */
    out[12] = t100;
    const double t101 = -t98; /* -t98 */
    out[15] = t101;
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
    const double t8 = t2*t6; /* s^2*K */
    const double t9 = p[10] + t6; /* Theta/m = I1*I3/m + K */
    const double t10 = t7*t8; /* D/I1*s^2*K */
    const double t11 = t9*t10; /* Theta/m*D/I1*s^2*K */
    const double t12 = 1.0/t11; /* 1/(Theta/m*D/I1*s^2*K) */
    const double t13 = t9*t12; /* Theta/m*1/(Theta/m*D/I1*s^2*K) */
    const double t14 = t10*t12; /* 1/(Theta/m) = D/I1*s^2*K*1/(Theta/m*D/I1*s^2*K) */
    const double t15 = t8*t13; /* 1/(D/I1) = s^2*K*Theta/m*1/(Theta/m*D/I1*s^2*K) */
    const double t16 = t7*t13; /* D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K) */
    const double t17 = sqrt(t2); /* s = sqrt(s^2) */
    out[6] = t17;
    const double t18 = t6*t17; /* K*s */
    const double t19 = t2*t16; /* 1/K = s^2*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K) */
    const double t20 = t16*t18; /* D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s */
    const double t21 = p[12]*t3; /* R*I3*b/R */
    const double t22 = x[3]*t21; /* v_tau*R*I3*b/R */
    const double t23 = x[2]*p[7]; /* omega_tau*m*a3^2/I1 */
    const double t24 = x[0]*t15; /* gamma3*1/(D/I1) */
    const double t25 = JLT_FMA(p[8], t17, t22); /* R*G*s + v_tau*R*I3*b/R */
    const double t26 = x[2]*t24; /* omega_tau*gamma3*1/(D/I1) */
    const double t27 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t28 = p[14]*t27; /* R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t29 = t15*t23; /* 1/(D/I1)*omega_tau*m*a3^2/I1 */
    const double t30 = t23*t26; /* omega_tau*m*a3^2/I1*omega_tau*gamma3*1/(D/I1) */
    const double t31 = JLT_FNMA(p[11], t15, t30); /* omega_tau*m*a3^2/I1*omega_tau*gamma3*1/(D/I1) - m*g*a3/I1*1/(D/I1) */
    const double t32 = p[25]*t24; /* 2*m^2*a3^4/I1^2*gamma3*1/(D/I1) */
    const double t33 = JLT_FMA(t26, t32, t29); /* omega_tau*gamma3*1/(D/I1)*2*m^2*a3^4/I1^2*gamma3*1/(D/I1) + 1/(D/I1)*omega_tau*m*a3^2/I1 */
    const double t34 = x[2]*t17; /* omega_tau*s */
    out[0] = t34;
    const double t35 = t33*t34; /* t33*omega_tau*s */
    const double t36 = t19*t25; /* 1/K*(R*G*s + v_tau*R*I3*b/R) */
    const double t37 = t14*t25; /* 1/(Theta/m)*(R*G*s + v_tau*R*I3*b/R) */
    const double t38 = t20*t37; /* D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s*1/(Theta/m)*(R*G*s + v_tau*R*I3*b/R) */
    const double t39 = -t38; /* -t38 */
    out[17] = t39;
    const double t40 = x[3]*t17; /* v_tau*s */
    const double t41 = JLT_FNMA(p[22], t3, t40); /* v_tau*s - G/I1*b/R */
    const double t42 = p[12]*t15; /* R*I3*1/(D/I1) */
    const double t43 = t19*t42; /* 1/K*R*I3*1/(D/I1) */
    const double t44 = x[0]*t20; /* gamma3*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s */
    const double t45 = JLT_FNMA(t31, t44, t35); /* t33*omega_tau*s - t31*gamma3*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s */
    const double t46 = x[0]*p[19]; /* gamma3*2*R^2*I1 */
    const double t47 = JLT_FMS(p[20], t3, t46); /* d(K)/d(gamma3) = 2*R^2*I3*b/R - gamma3*2*R^2*I1 */
    const double t48 = t20*t36; /* D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s*1/K*(R*G*s + v_tau*R*I3*b/R) */
    const double t49 = x[3]*t48; /* v_tau*t48 */
    out[1] = t49;
    const double t50 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t51 = t14*t28; /* 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t52 = JLT_FMA(t19, t28, t51); /* 1/K*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) + 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t53 = JLT_FNMA(t47, t52, p[24]); /* R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t52 */
    const double t54 = p[8]*t44; /* R*G*gamma3*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s */
    const double t55 = JLT_FNMA(x[3], p[12], t54); /* R*G*gamma3*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s - v_tau*R*I3 */
    const double t56 = t36*t43; /* 1/K*(R*G*s + v_tau*R*I3*b/R)*1/K*R*I3*1/(D/I1) */
    const double t57 = t24*t48; /* gamma3*1/(D/I1)*t48 */
    const double t58 = JLT_FMA(x[2], t50, x[1]); /* V = omega_tau*e + v_nu */
    const double t59 = p[10]*t14; /* I1*I3/m*1/(Theta/m) */
    const double t60 = t19*t41; /* 1/K*(v_tau*s - G/I1*b/R) */
    const double t61 = t43*t60; /* 1/K*R*I3*1/(D/I1)*1/K*(v_tau*s - G/I1*b/R) */
    const double t62 = t41*t56; /* (v_tau*s - G/I1*b/R)*1/K*(R*G*s + v_tau*R*I3*b/R)*1/K*R*I3*1/(D/I1) */
    const double t63 = JLT_FMA(t36, t57, t62); /* 1/K*(R*G*s + v_tau*R*I3*b/R)*gamma3*1/(D/I1)*t48 + t62 */
    const double t64 = JLT_FMS(t17, t31, t63); /* s*t31 - (1/K*(R*G*s + v_tau*R*I3*b/R)*gamma3*1/(D/I1)*t48 + t62) */
    out[2] = t64;
    const double t65 = t36*t47; /* 1/K*(R*G*s + v_tau*R*I3*b/R)*d(K)/d(gamma3) */
    const double t66 = t47*t58; /* d(K)/d(gamma3)*V */
    const double t67 = JLT_FNMA(t58, t59, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t68 = t48*t59; /* t48*I1*I3/m*1/(Theta/m) */
    const double t69 = t20*t48; /* D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s*t48 */
    const double t70 = t19*t20; /* 1/K*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s */
    const double t71 = JLT_FMA(t22, t70, t48); /* v_tau*R*I3*b/R*1/K*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s + t48 */
    out[11] = t71;
    const double t72 = 2.0*t19; /* 2*1/K */
    const double t73 = t57*t72; /* gamma3*1/(D/I1)*t48*2*1/K */
    const double t74 = t19*t51; /* 1/K*1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t75 = t51*t60; /* 1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3)*1/K*(v_tau*s - G/I1*b/R) */
    const double t76 = JLT_FMS(t50, t68, t75); /* e*t48*I1*I3/m*1/(Theta/m) - t75 */
    out[18] = t76;
    const double t77 = JLT_FMA(x[3], t44, p[22]); /* v_tau*gamma3*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s + G/I1 */
    const double t78 = JLT_FMA(t56, t77, t45); /* 1/K*(R*G*s + v_tau*R*I3*b/R)*1/K*R*I3*1/(D/I1)*(v_tau*gamma3*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s + G/I1) + t45 */
    const double t79 = t44*t69; /* gamma3*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s*t48 */
    const double t80 = x[2]*t44; /* omega_tau*gamma3*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s */
    const double t81 = -t80; /* -omega_tau*gamma3*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s */
    out[4] = t81;
    const double t82 = t55 + t65; /* t55 + 1/K*(R*G*s + v_tau*R*I3*b/R)*d(K)/d(gamma3) */
    const double t83 = JLT_FMA(2.0, t65, t55); /* 2*1/K*(R*G*s + v_tau*R*I3*b/R)*d(K)/d(gamma3) + t55 */
    const double t84 = JLT_FNMA(t70, t82, t79); /* t79 - 1/K*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s*(t55 + 1/K*(R*G*s + v_tau*R*I3*b/R)*d(K)/d(gamma3)) */
    const double t85 = JLT_FMA(t73, t82, t78); /* gamma3*1/(D/I1)*t48*2*1/K*(t55 + 1/K*(R*G*s + v_tau*R*I3*b/R)*d(K)/d(gamma3)) + t78 */
    const double t86 = JLT_FMA(t61, t83, t85); /* 1/K*R*I3*1/(D/I1)*1/K*(v_tau*s - G/I1*b/R)*(2*1/K*(R*G*s + v_tau*R*I3*b/R)*d(K)/d(gamma3) + t55) + t85 */
    const double t87 = t61 + t73; /* 1/K*R*I3*1/(D/I1)*1/K*(v_tau*s - G/I1*b/R) + gamma3*1/(D/I1)*t48*2*1/K */
    const double t88 = t21*t87; /* R*I3*b/R*t87 */
    const double t89 = JLT_FMA(t17, t56, t88); /* s*1/K*(R*G*s + v_tau*R*I3*b/R)*1/K*R*I3*1/(D/I1) + R*I3*b/R*t87 */
    const double t90 = -t89; /* -t89 */
    out[15] = t90;
    const double t91 = p[26]*t17; /* 2*m^2*g*a3^3/I1^2*s */
    const double t92 = t24*t91; /* gamma3*1/(D/I1)*2*m^2*g*a3^3/I1^2*s */
    const double t93 = JLT_FMA(t48, t69, t92); /* t48*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s*t48 + gamma3*1/(D/I1)*2*m^2*g*a3^3/I1^2*s */
    const double t94 = JLT_FNMA(t15, t93, t86); /* t86 - 1/(D/I1)*t93 */
    const double t95 = t21*t67; /* R*I3*b/R*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t96 = t70*t95; /* 1/K*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s*R*I3*b/R*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t97 = p[21]*t24; /* 2*m*a3^2/I1*gamma3*1/(D/I1) */
    const double t98 = JLT_FNMA(t63, t97, t94); /* t86 - 1/(D/I1)*t93 - (1/K*(R*G*s + v_tau*R*I3*b/R)*gamma3*1/(D/I1)*t48 + t62)*2*m*a3^2/I1*gamma3*1/(D/I1) */
    out[12] = t98;
    const double t99 = t34*t97; /* omega_tau*s*2*m*a3^2/I1*gamma3*1/(D/I1) */
    out[14] = t99;
    const double t100 = JLT_FMA(t34, t74, t96); /* omega_tau*s*1/K*1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) + t96 */
    const double t101 = -t100; /* -t100 */
    out[19] = t101;
    const double t102 = x[2]*t74; /* omega_tau*1/K*1/(Theta/m)*R*I1*I3/m*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t103 = x[3]*t84; /* v_tau*t84 */
    out[8] = t103;
    const double t104 = t67*t84; /* (v_nu - V*I1*I3/m*1/(Theta/m))*t84 */
    const double t105 = JLT_FMS(t77, t102, t104); /* (v_tau*gamma3*D/I1*Theta/m*1/(Theta/m*D/I1*s^2*K)*K*s + G/I1)*t102 - (v_nu - V*I1*I3/m*1/(Theta/m))*t84 */
    const double t106 = t48*t67; /* t48*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t107 = JLT_FMA(x[2], t75, t106); /* omega_tau*t75 + t48*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t108 = -t107; /* -(omega_tau*t75 + t48*(v_nu - V*I1*I3/m*1/(Theta/m))) */
    out[3] = t108;
    const double t109 = p[23]*t48; /* I1*I3*a3/m*t48 */
    const double t110 = JLT_FNMA(t53, t60, t109); /* I1*I3*a3/m*t48 - (R^2*I1*I3*(I1 - I3)/m - d(K)/d(gamma3)*t52)*1/K*(v_tau*s - G/I1*b/R) */
    const double t111 = x[2]*t110; /* omega_tau*t110 */
    const double t112 = JLT_FMS(t66, t68, t111); /* d(K)/d(gamma3)*V*t48*I1*I3/m*1/(Theta/m) - omega_tau*t110 */
    const double t113 = JLT_FNMA(t14, t112, t105); /* t105 - 1/(Theta/m)*(d(K)/d(gamma3)*V*t48*I1*I3/m*1/(Theta/m) - omega_tau*t110) */
    out[16] = t113;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[18]; /* b/R = gamma3 + a3/R */
    const double t4 = p[28]*t3; /* I3/I1*b/R */
    const double t5 = JLT_FMA(t3, t4, t2); /* K/(R^2*I1) = b/R*I3/I1*b/R + s^2 */
    const double t6 = p[4]*t3; /* I3*b/R */
    const double t7 = JLT_FMA(p[30], t2, p[3]); /* D = m*a3^2*s^2 + I1 */
    const double t8 = p[29] + t5; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t9 = t5*t7; /* K/(R^2*I1)*D */
    const double t10 = p[27]*t5; /* 2*m*a3^2*K/(R^2*I1) */
    const double t11 = t8*t9; /* Theta/(m*R^2*I1)*K/(R^2*I1)*D */
    const double t12 = p[31]*t9; /* I3/(m*R^3*I1)*K/(R^2*I1)*D */
    const double t13 = t2*t11; /* s^2*Theta/(m*R^2*I1)*K/(R^2*I1)*D */
    const double t14 = 1.0/t13; /* 1/(s^2*Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t15 = t11*t14; /* 1/s^2 = Theta/(m*R^2*I1)*K/(R^2*I1)*D*1/(s^2*Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t16 = t2*t14; /* 1/(D*(K/(R^2*I1))*(Theta/(m*R^2*I1))) = s^2*1/(s^2*Theta/(m*R^2*I1)*K/(R^2*I1)*D) */
    const double t17 = sqrt(t2); /* s = sqrt(s^2) */
    const double t18 = t8*t16; /* 1/(D*(K/(R^2*I1))) = Theta/(m*R^2*I1)*1/(D*(K/(R^2*I1))*(Theta/(m*R^2*I1))) */
    const double t19 = t12*t16; /* I3/(m*R^3*I1)*K/(R^2*I1)*D*1/(D*(K/(R^2*I1))*(Theta/(m*R^2*I1))) */
    const double t20 = JLT_FMS(t10, t18, t15); /* 2*m*a3^2*K/(R^2*I1)*1/(D*(K/(R^2*I1))) - 1/s^2 */
    const double t21 = t6*t15; /* I3*b/R*1/s^2 */
    const double t22 = t7*t17; /* D*s */
    const double t23 = t18*t22; /* 1/(D*(K/(R^2*I1)))*D*s */
    const double t24 = x[0]*t17; /* gamma3*s */
    const double t25 = t20*t24; /* (2*m*a3^2*K/(R^2*I1)*1/(D*(K/(R^2*I1))) - 1/s^2)*gamma3*s */
    const double t26 = t21*t23; /* I3*b/R*1/s^2*1/(D*(K/(R^2*I1)))*D*s */
    const double t27 = JLT_FMS(x[0], p[15], p[16]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t28 = t19*t27; /* t19*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t29 = JLT_FNMA(t23, t28, t25); /* (2*m*a3^2*K/(R^2*I1)*1/(D*(K/(R^2*I1))) - 1/s^2)*gamma3*s - 1/(D*(K/(R^2*I1)))*D*s*t19*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t30 = x[2]*t29; /* omega_tau*t29 */
    const double t31 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t32 = JLT_FMA(x[2], t31, x[1]); /* V = omega_tau*e + v_nu */
    const double t33 = p[32]*x[1]; /* 1/(R*I1)*v_nu */
    const double t34 = JLT_FNMA(t19, t32, t33); /* 1/(R*I1)*v_nu - t19*V */
    const double t35 = JLT_FNMA(t26, t34, t30); /* omega_tau*t29 - I3*b/R*1/s^2*1/(D*(K/(R^2*I1)))*D*s*(1/(R*I1)*v_nu - t19*V) */
    out[0] = t35;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = x[0] + p[18]; /* b/R = gamma3 + a3/R */
    const double t4 = p[28]*t3; /* I3/I1*b/R */
    const double t5 = JLT_FMA(t3, t4, t2); /* K/(R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(gamma3 + 1) */
    const double t6 = JLT_FMA(p[30], t2, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t7 = p[29] + t5; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t8 = x[3]*x[3]; /* v_tau*v_tau */
    const double t9 = JLT_FMA(t7, t8, p[35]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t10 = t9/t5; /* (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t11 = JLT_FMA(x[1], x[1], t10); /* v_nu*v_nu + (Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1))/(K/(R^2*I1)) */
    const double t12 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t13 = x[2]*t12; /* omega_tau*1/2*omega_tau */
    const double t14 = p[33]*x[0]; /* m*g*a3*gamma3 */
    const double t15 = JLT_FMA(t6, t13, t14); /* D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
    const double t16 = JLT_FMA(p[34], t11, t15); /* 1/2*m*t11 + D*omega_tau*1/2*omega_tau + m*g*a3*gamma3 */
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
    const double t5 = p[28]*t4; /* I3/I1*b/R */
    const double t6 = JLT_FMA(t4, t5, t3); /* K/(R^2*I1) = b/R*I3/I1*b/R + (1 - gamma3)*(gamma3 + 1) */
    const double t7 = t5 - x[0]; /* d(K)/d(gamma3)/(2*R^2*I1) = I3/I1*b/R - gamma3 */
    const double t8 = JLT_FMA(p[30], t3, p[3]); /* D = m*a3^2*(1 - gamma3)*(gamma3 + 1) + I1 */
    const double t9 = x[2]*t8; /* omega_tau*D */
    out[2] = t9;
    const double t10 = p[29] + t6; /* Theta/(m*R^2*I1) = I3/(m*R^2) + K/(R^2*I1) */
    const double t11 = 1.0/t6; /* 1/(K/(R^2*I1)) */
    const double t12 = t7*t11; /* d(K)/d(gamma3)/(2*R^2*I1)*1/(K/(R^2*I1)) */
    const double t13 = x[3]*p[0]; /* v_tau*m */
    const double t14 = t10*t13; /* Theta/(m*R^2*I1)*v_tau*m */
    const double t15 = t11*t14; /* 1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m */
    out[3] = t15;
    const double t16 = t15 - t13; /* 1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m - v_tau*m */
    const double t17 = x[3]*t16; /* v_tau*(1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m - v_tau*m) */
    const double t18 = JLT_FMA(p[36], t11, t17); /* G^2/(R^2*I1)*1/(K/(R^2*I1)) + v_tau*(1/(K/(R^2*I1))*Theta/(m*R^2*I1)*v_tau*m - v_tau*m) */
    const double t19 = p[30]*x[0]; /* m*a3^2*gamma3 */
    const double t20 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t21 = JLT_FNMA(t19, t20, p[33]); /* m*g*a3 - m*a3^2*gamma3*omega_tau*omega_tau */
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
    const double t6 = p[9]*t2; /* R^2*I1*s^2 */
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
    const double t25 = JLT_FNMA(p[40], t18, p[39]); /* g/I1 - a3/I1*omega_tau*gamma3*omega_tau */
    const double t26 = p[38]*t25; /* m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t27 = t13*t26; /* s*m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t28 = x[3]*t13; /* v_tau*s */
    const double t29 = JLT_FNMA(p[13], t3, t28); /* v_tau*s - G/(R*I1)*b */
    const double t30 = JLT_FMA(p[12], t29, t22); /* R*I3*(v_tau*s - G/(R*I1)*b) + 1/(K*s^2*D/I1)*K*s*gamma3*D/I1*(v_tau*I3*b + R*G*s) */
    const double t31 = JLT_FMA(t24, t30, t27); /* 1/K*1/K*(v_tau*I3*b + R*G*s)*t30 + s*m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t32 = JLT_FMA(t16, t31, t18); /* s^2*1/(K*s^2*D/I1)*K*s*t31 + omega_tau*gamma3*omega_tau */
    const double t33 = JLT_FNMA(p[38], t32, p[37]); /* contact_force = m*g - m*a3*(s^2*1/(K*s^2*D/I1)*K*s*t31 + omega_tau*gamma3*omega_tau) */
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
    const double t6 = p[9]*t2; /* R^2*I1*s^2 */
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
    const double t25 = JLT_FNMA(p[40], t18, p[39]); /* g/I1 - a3/I1*omega_tau*gamma3*omega_tau */
    const double t26 = p[38]*t25; /* m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t27 = t13*t26; /* s*m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t28 = x[3]*t13; /* v_tau*s */
    const double t29 = JLT_FNMA(p[13], t3, t28); /* v_tau*s - G/(R*I1)*b */
    const double t30 = JLT_FMA(p[12], t29, t22); /* R*I3*(v_tau*s - G/(R*I1)*b) + 1/(K*s^2*D/I1)*K*s*gamma3*D/I1*(v_tau*I3*b + R*G*s) */
    const double t31 = JLT_FMA(t24, t30, t27); /* 1/K*1/K*(v_tau*I3*b + R*G*s)*t30 + s*m*a3*(g/I1 - a3/I1*omega_tau*gamma3*omega_tau) */
    const double t32 = JLT_FMA(t16, t31, t18); /* s^2*1/(K*s^2*D/I1)*K*s*t31 + omega_tau*gamma3*omega_tau */
    const double t33 = JLT_FNMA(p[38], t32, p[37]); /* contact_force = m*g - m*a3*(s^2*1/(K*s^2*D/I1)*K*s*t31 + omega_tau*gamma3*omega_tau) */
    out[0] = t33;
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
        t48[k] = t47[k] - p[11]*t25[k];
        t49[k] = jlt_jet_product(x3, t25, k);
        t50[k] = t49[k] - p[13]*t21[k];
        t51[k] = jlt_jet_product(t37, t50, k);
        t52[k] = x0[k]*p[5] + (k == 0 ? p[1] : 0);
        t53[k] = jlt_jet_product(x2, t52, k) + x1[k];
        t54[k] = p[10]*t53[k];
        t55[k] = x1[k] - jlt_jet_product(t33, t54, k);
        t56[k] = jlt_jet_product(t41, t55, k);
        t57[k] = x0[k]*p[15] - (k == 0 ? p[16] : 0);
        t58[k] = x2[k]*p[14];
        t59[k] = jlt_jet_product(t57, t58, k);
        t60[k] = jlt_jet_product(t33, t59, k);
        t61[k] = jlt_jet_product(t51, t60, k) + t56[k];
        t62[k] = -t61[k];
        t63[k] = p[12]*t51[k];
        t64[k] = t48[k] - jlt_jet_product(t40, t63, k);
        t65[k] = jlt_jet_product(t35, t64, k);
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t43[k]/(k + 1);
        next[1] = x1[k + 1] = t42[k]/(k + 1);
        next[2] = x2[k + 1] = t65[k]/(k + 1);
        next[3] = x3[k + 1] = t62[k]/(k + 1);
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

const jlt_descriptor jlt_kernels_spherical_top_level_general = {
    .model = "spherical_top_level",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "a0362d7aafe4ac095061c9e2c7f9417b05b6c21c51ed0a0e3c3f227f5c7cacca",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_level, .family = jlt_family_spherical_top_level, .claims = jlt_claims_spherical_top_level,
    .state_count = 4, .param_count = 7, .block_count = 41,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 4, 30, 13, 1, 1, 0, 17, 10 }, { 21, 80, 0, 8, 1, 0, 12, 10 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b = gamma3*R + a3, v_tau*I3*b + (R*G)*s, a part of d(omega_tau)/dt, v_tau*s - (G/(R*I1))*b, e = gamma3*a3 + R, V = omega_tau*e + v_nu, v_nu - 1/(Theta/m)*(I1*I3/m)*V, gamma3*(R*(I1 - I3)) - (I3*a3), a part of d(v_tau)/dt, a part of d(omega_tau)/dt" },
    .jacobian = { jacobian, 16, { 11, 58, 31, 1, 1, 0, 19, 23 }, { 91, 425, 0, 50, 1, 0, 21, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, v_tau*(R*I3)*b/R + (R*G)*s, gamma3*(R*(I1 - I3)) - (I3*a3), (R*G)*gamma3*((1)/s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s - v_tau*(R*I3), d(K)/d(gamma3) = (2*R^2*I3)*b/R - gamma3*(2*R^2*I1), v_tau*s - (G/I1)*b/R, v_tau*gamma3*((1)/s^2*Theta/m*K*D/I1)*Theta/m*K*D/I1*s + G/I1, e = gamma3*a3 + R, a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), d(d(v_nu)/dt)/d(v_tau), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(v_tau), a part of d(d(omega_tau)/dt)/d(v_tau), V = omega_tau*e + v_nu, v_nu - V*(I1*I3/m)*1/(Theta/m), a part of d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(v_nu), d(d(v_tau)/dt)/d(omega_tau), a part of d(d(v_tau)/dt)/d(v_tau), d(d(v_tau)/dt)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 11, 66, 35, 1, 1, 0, 20, 27 }, { 105, 489, 0, 58, 1, 0, 21, 14 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, (R*G)*s + v_tau*(R*I3)*b/R, gamma3*(R*(I1 - I3)) - (I3*a3), omega_tau*(m*a3^2/I1)*omega_tau*gamma3*1/(D/I1) - (m*g*a3/I1)*1/(D/I1), v_tau*s - (G/I1)*b/R, d(K)/d(gamma3) = (2*R^2*I3)*b/R - gamma3*(2*R^2*I1), e = gamma3*a3 + R, a part of d(d(v_tau)/dt)/d(gamma3), (R*G)*gamma3*D/I1*Theta/m*((1)/Theta/m*D/I1*s^2*K)*K*s - v_tau*(R*I3), V = omega_tau*e + v_nu, a part of d(omega_tau)/dt and of d(d(omega_tau)/dt)/d(gamma3), d(omega_tau)/dt, v_nu - V*(I1*I3/m)*1/(Theta/m), d(d(v_nu)/dt)/d(v_tau), d(d(v_tau)/dt)/d(omega_tau), v_tau*gamma3*D/I1*Theta/m*((1)/Theta/m*D/I1*s^2*K)*K*s + G/I1, a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(omega_tau)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_nu)/dt)/d(gamma3) and of d(d(v_tau)/dt)/d(gamma3), a part of d(d(omega_tau)/dt)/d(v_tau), a part of d(d(omega_tau)/dt)/d(v_tau), a part of d(d(omega_tau)/dt)/d(gamma3), d(d(omega_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(v_tau), a part of d(v_tau)/dt, a part of d(d(v_tau)/dt)/d(gamma3), a part of d(d(v_tau)/dt)/d(gamma3), d(d(v_tau)/dt)/d(gamma3)" },
    .divergence = { divergence, 1, { 4, 21, 9, 1, 1, 0, 14, 9 }, { 13, 41, 0, 5, 1, 0, 12, 8 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in b/R = gamma3 + a3/R, (2*m*a3^2)*K/(R^2*I1)*1/(D*(K/(R^2*I1))) - 1/s^2, gamma3*(R*(I1 - I3)) - (I3*a3), a part of the divergence, e = gamma3*a3 + R, V = omega_tau*e + v_nu, a part of the divergence, the divergence" },
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
    .observe_count = 1, .observes = observes,
    .valid_count = 1, .valids = valids,
    .reversor_count = 1, .reversors = reversors,
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
