/* Spherical top on a plane with one nonholonomic constraint, full system with multipliers
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (2.5)-(2.7)
 *  Table:      spherical_top_full, SHA-256 5de9745ff1945082f709f85b1765ec2e95addd9d5431b2def563648618d9e642
 *  Command:    ttc generate --effort full --out DIR spherical_top_full.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   42   39    1    0    0     13   13   (227)
 *  jacobian            28   97   84    1    0    0     16   38   (1510)
 *  rhs_jacobian        31  114  110    1    0    0     16   41   (1686)
 *  divergence          1   21   22    1    0    0     13    9   (136)
 *  integral_values     1   11   25    0    0    0      5    6   (70)
 *  integral_gradients  2   25    8    0    0    0      3    4   (64)
 *  observe_values      0    0    2    0    0    0      1    1   (4)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by D, small only where all of I1*one and m*a3^2*s^2 are
 *    digits are lost where terms nearly cancel in d(gamma1)/dt, d(gamma2)/dt, gamma2*omega1 - omega2*gamma1,
 *      d(gamma3)/dt, q = gamma2*omega2 + omega1*gamma1, gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*(I3/I1),
 *      a part of d(v1)/dt and of d(v2)/dt and of d(v3)/dt and of d(omega1)/dt and of d(omega2)/dt and of d(d(v1)/dt)/d(gamma1) and of d(d(v1)/dt)/d(gamma2) and of d(d(v1)/dt)/d(gamma3) and of d(d(v2)/dt)/d(gamma1) and of d(d(v2)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma3) and of d(d(v3)/dt)/d(gamma1) and of d(d(v3)/dt)/d(gamma2) and of d(d(v3)/dt)/d(gamma3) and of d(d(omega1)/dt)/d(gamma1) and of d(d(omega1)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma1) and of d(d(omega2)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma3),
 *      b = gamma3*R + a3,
 *      a part of d(v1)/dt and of d(v2)/dt and of d(v3)/dt and of d(d(v1)/dt)/d(gamma1) and of d(d(v1)/dt)/d(gamma3) and of d(d(v2)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma3) and of d(d(v3)/dt)/d(gamma3) and of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma3),
 *      omega1*v1 + omega2*v2, gamma3*(2*R) - (I3/I1)*b, q*R + omega3*(gamma3*(2*R) - (I3/I1)*b), gyroscopic, d(v1)/dt,
 *      d(v2)/dt, d(v3)/dt, d(omega1)/dt, a part of d(omega2)/dt, d(alpha1)/dt, d(alpha2)/dt, d(alpha3)/dt, d(beta1)/dt,
 *      d(beta2)/dt, d(beta3)/dt, d(x)/dt, d(y)/dt,
 *      a part of d(d(v1)/dt)/d(gamma1) and of d(d(v1)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma1) and of d(d(v2)/dt)/d(gamma2) and of d(d(v3)/dt)/d(gamma1) and of d(d(v3)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma1) and of d(d(omega1)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma1) and of d(d(omega2)/dt)/d(gamma2),
 *      a part of d(d(v1)/dt)/d(gamma1) and of d(d(v2)/dt)/d(gamma1) and of d(d(v3)/dt)/d(gamma1) and of d(d(omega1)/dt)/d(gamma1) and of d(d(omega2)/dt)/d(gamma1),
 *      v3 - (gamma2*omega1 - omega2*gamma1)*R, d(gyroscopic)/d(gamma1), d(d(v1)/dt)/d(gamma1),
 *      a part of d(d(v1)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma2) and of d(d(v3)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma2),
 *      d(gyroscopic)/d(gamma2), d(d(v1)/dt)/d(gamma2),
 *      a part of d(d(v1)/dt)/d(gamma3) and of d(d(v2)/dt)/d(gamma3) and of d(d(v3)/dt)/d(gamma3) and of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma3),
 *      2*R - R*I3/I1,
 *      a part of d(d(v1)/dt)/d(gamma3) and of d(d(v2)/dt)/d(gamma3) and of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3),
 *      d(d(v1)/dt)/d(gamma3), d(d(v1)/dt)/d(v2), d(d(v1)/dt)/d(v3), gamma3*omega1 - gamma1*omega3*(1/2*I3/I1),
 *      d(gyroscopic)/d(omega1), d(d(v1)/dt)/d(omega1), gamma3*omega2 - gamma2*omega3*(1/2*I3/I1),
 *      d(gyroscopic)/d(omega2), d(d(v1)/dt)/d(omega2), d(d(v1)/dt)/d(omega3), d(d(v2)/dt)/d(gamma1),
 *      d(d(v2)/dt)/d(gamma2), d(d(v2)/dt)/d(gamma3), d(d(v2)/dt)/d(v1), d(d(v2)/dt)/d(v3), d(d(v2)/dt)/d(omega1),
 *      a part of d(d(v2)/dt)/d(omega2), d(d(v2)/dt)/d(omega3), d(d(v3)/dt)/d(gamma3),
 *      (2*a3*I1)*(gamma3*omega1 - gamma1*omega3*(1/2*I3/I1))*gamma3*1/D + v2, d(d(v3)/dt)/d(omega2),
 *      a part of d(d(omega1)/dt)/d(gamma1), d(d(omega1)/dt)/d(gamma1),
 *      a part of d(d(omega1)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma2), d(d(omega1)/dt)/d(gamma2),
 *      a part of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3),
 *      d(d(omega1)/dt)/d(gamma3), a part of d(d(omega1)/dt)/d(omega1), d(d(omega1)/dt)/d(omega2),
 *      d(d(omega1)/dt)/d(omega3), d(d(omega2)/dt)/d(gamma1), d(d(omega2)/dt)/d(gamma2), d(d(omega2)/dt)/d(gamma3),
 *      d(d(omega2)/dt)/d(omega1), d(d(omega2)/dt)/d(omega2), d(d(omega2)/dt)/d(omega3), d(d(omega3)/dt)/d(gamma1),
 *      d(d(omega3)/dt)/d(gamma2)
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_full[];
extern const jlt_claim jlt_claims_spherical_top_full[];
extern const jlt_descriptor *const jlt_family_spherical_top_full[];
extern const jlt_descriptor jlt_kernels_spherical_top_full_general;
extern const struct jlt_ball_table jlt_balls_spherical_top_full_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_full_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_full_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_full_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = params[2]*params[4]; /* g*I1 */
    out[6] = t0;
    const double t1 = params[4]*params[3]; /* I1*a3 */
    out[7] = t1;
    const double t2 = params[5]/params[4]; /* I3/I1 */
    out[8] = t2;
    const double t3 = params[3]*params[3]; /* a3*a3 */
    const double t4 = params[0]*t3; /* m*a3*a3 */
    out[9] = t4;
    const double t5 = params[4]/params[0]; /* I1/m */
    out[10] = t5;
    const double t6 = params[1]*params[1]; /* R*R */
    const double t7 = params[4]*t6; /* I1*R*R */
    const double t8 = t7/params[5]; /* I1*R*R/I3 */
    out[11] = t8;
    const double t9 = params[1]*2.0; /* R*2 */
    out[12] = t9;
    const double t10 = params[4] - params[5]; /* I1 - I3 */
    const double t11 = t10/params[4]; /* (I1 - I3)/I1 */
    out[13] = t11;
    const double t12 = params[3]*params[0]; /* a3*m */
    const double t13 = t12/params[4]; /* a3*m/I1 */
    out[14] = t13;
    const double t14 = params[4]*params[1]; /* I1*R */
    const double t15 = t14/params[5]; /* I1*R/I3 */
    out[15] = t15;
    const double t16 = params[3]*params[5]; /* a3*I3 */
    out[16] = t16;
    const double t17 = params[2]*2.0; /* g*2 */
    const double t18 = params[4]*t17; /* I1*g*2 */
    out[17] = t18;
    const double t19 = params[4]*2.0; /* I1*2 */
    out[22] = t19;
    const double t20 = t4*2.0; /* m*a3*a3*2 */
    const double t21 = t19 + t20; /* I1*2 + m*a3*a3*2 */
    out[18] = t21;
    const double t22 = t6*2.0; /* R*R*2 */
    const double t23 = params[4]*params[4]; /* I1*I1 */
    const double t24 = t22*t23; /* R*R*2*I1*I1 */
    const double t25 = params[5]*params[0]; /* I3*m */
    const double t26 = t24/t25; /* R*R*2*I1*I1/(I3*m) */
    out[19] = t26;
    const double t27 = params[5]/t7; /* I3/(I1*R*R) */
    out[20] = t27;
    const double t28 = params[4]*t22; /* I1*R*R*2 */
    const double t29 = t28/params[5]; /* I1*R*R*2/I3 */
    out[21] = t29;
    const double t30 = params[5]*params[1]; /* I3*R */
    const double t31 = t30/params[4]; /* I3*R/I1 */
    const double t32 = t9 - t31; /* R*2 - I3*R/I1 */
    out[23] = t32;
    const double t33 = params[3]*2.0; /* a3*2 */
    const double t34 = params[4]*t33; /* I1*a3*2 */
    out[24] = t34;
    const double t35 = params[5]/t19; /* I3/(I1*2) */
    out[25] = t35;
    const double t36 = params[0]*2.0; /* m*2 */
    const double t37 = t3*t36; /* a3*a3*m*2 */
    out[26] = t37;
    const double t38 = params[5]*t4; /* I3*m*a3*a3 */
    const double t39 = t38/params[4]; /* I3*m*a3*a3/I1 */
    out[27] = t39;
    const double t40 = params[1]*t6; /* R*R*R */
    const double t41 = 2.0*t40; /* 2*R*R*R */
    const double t42 = t23*t41; /* I1*I1*2*R*R*R */
    const double t43 = params[5]*params[5]; /* I3*I3 */
    const double t44 = t42/t43; /* I1*I1*2*R*R*R/(I3*I3) */
    out[28] = t44;
    const double t45 = params[4]*t9; /* I1*R*2 */
    const double t46 = t45/params[0]; /* I1*R*2/m */
    out[29] = t46;
    const double t47 = t4/params[4]; /* m*a3*a3/I1 */
    out[30] = t47;
    const double t48 = params[0]*params[1]; /* m*R */
    const double t49 = t48/params[5]; /* m*R/I3 */
    out[31] = t49;
    const double t50 = t37/params[4]; /* a3*a3*m*2/I1 */
    out[32] = t50;
    const double t51 = -params[1]; /* -R */
    out[37] = t51;
    const double t52 = -t14; /* -I1*R */
    out[33] = t52;
    const double t53 = -params[3]; /* -a3 */
    out[35] = t53;
    const double t54 = -t16; /* -a3*I3 */
    out[34] = t54;
    const double t55 = params[3]/params[1]; /* a3/R */
    out[36] = t55;
    const double t56 = -t30; /* -I3*R */
    out[38] = t56;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[8]; /* gamma2*omega3 */
    const double t1 = JLT_FNMA(x[2], x[7], t0); /* gamma2*omega3 - gamma3*omega2 */
    out[0] = t1;
    const double t2 = x[2]*x[6]; /* gamma3*omega1 */
    const double t3 = JLT_FNMA(x[8], x[0], t2); /* gamma3*omega1 - omega3*gamma1 */
    out[1] = t3;
    const double t4 = x[1]*x[6]; /* gamma2*omega1 */
    const double t5 = x[7]*x[0]; /* omega2*gamma1 */
    const double t6 = t4 - t5; /* gamma2*omega1 - omega2*gamma1 */
    const double t7 = t5 - t4; /* omega2*gamma1 - gamma2*omega1 */
    out[2] = t7;
    const double t8 = x[8]*x[4]; /* omega3*v2 */
    const double t9 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t10 = JLT_FMA(x[1], x[1], t9); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t11 = JLT_FMA(x[2], x[2], t10); /* one = gamma3*gamma3 + gamma2*gamma2 + gamma1*gamma1 */
    const double t12 = p[6]*t11; /* g*I1*one */
    const double t13 = x[6]*x[6]; /* omega1*omega1 */
    const double t14 = JLT_FMA(x[7], x[7], t13); /* omega2*omega2 + omega1*omega1 */
    const double t15 = x[2]*t14; /* gamma3*(omega2*omega2 + omega1*omega1) */
    const double t16 = x[6]*x[0]; /* omega1*gamma1 */
    const double t17 = JLT_FMA(x[1], x[7], t16); /* q = gamma2*omega2 + omega1*gamma1 */
    const double t18 = x[8]*p[8]; /* omega3*I3/I1 */
    const double t19 = JLT_FNMA(t17, t18, t15); /* gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*I3/I1 */
    const double t20 = JLT_FNMA(p[7], t19, t12); /* g*I1*one - a3*I1*(gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*I3/I1) */
    const double t21 = t11*p[4]; /* one*I1 */
    const double t22 = JLT_FMA(t10, p[9], t21); /* D = (gamma2*gamma2 + gamma1*gamma1)*m*a3^2 + one*I1 */
    const double t23 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t24 = JLT_FMA(t10, p[11], p[10]); /* (gamma2*gamma2 + gamma1*gamma1)*R^2*I1/I3 + I1/m */
    const double t25 = JLT_FMA(t23, t23, t24); /* Theta/(m*I3) = b*b + (gamma2*gamma2 + gamma1*gamma1)*R^2*I1/I3 + I1/m */
    const double t26 = t10*t25; /* (gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3) */
    const double t27 = t22*t26; /* D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3) */
    const double t28 = 1.0/t27; /* 1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t29 = t20*t26; /* t20*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3) */
    const double t30 = t28*t29; /* 1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3))*t20*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3) */
    const double t31 = p[2] - t30; /* g - t30 */
    const double t32 = x[5]*t17; /* v3*q */
    const double t33 = x[2]*p[12]; /* gamma3*2*R */
    const double t34 = JLT_FNMA(p[8], t23, t33); /* gamma3*2*R - I3/I1*b */
    const double t35 = x[8]*t34; /* omega3*(gamma3*2*R - I3/I1*b) */
    const double t36 = JLT_FMA(t17, p[1], t35); /* q*R + omega3*(gamma3*2*R - I3/I1*b) */
    const double t37 = x[6]*x[3]; /* omega1*v1 */
    const double t38 = JLT_FMA(x[7], x[4], t37); /* omega2*v2 + omega1*v1 */
    const double t39 = JLT_FNMA(x[2], t38, t32); /* v3*q - gamma3*(omega2*v2 + omega1*v1) */
    const double t40 = JLT_FNMA(t6, t36, t39); /* gyroscopic = v3*q - gamma3*(omega2*v2 + omega1*v1) - (gamma2*omega1 - omega2*gamma1)*(q*R + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t41 = t22*t28; /* D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t42 = t10*t40; /* (gamma2*gamma2 + gamma1*gamma1)*gyroscopic */
    const double t43 = t41*t42; /* D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3))*(gamma2*gamma2 + gamma1*gamma1)*gyroscopic */
    const double t44 = t25*t41; /* Theta/(m*I3)*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t45 = t43*t44; /* t43*t44 */
    const double t46 = x[1]*t45; /* gamma2*t43*t44 */
    const double t47 = JLT_FNMA(x[7], x[5], t8); /* omega3*v2 - omega2*v3 */
    const double t48 = JLT_FNMA(x[0], t31, t47); /* omega3*v2 - omega2*v3 - gamma1*(g - t30) */
    const double t49 = JLT_FMA(p[10], t46, t48); /* I1/m*gamma2*t43*t44 + omega3*v2 - omega2*v3 - gamma1*(g - t30) */
    out[3] = t49;
    const double t50 = x[6]*x[5]; /* omega1*v3 */
    const double t51 = x[0]*t45; /* gamma1*t43*t44 */
    const double t52 = JLT_FNMA(x[8], x[3], t50); /* omega1*v3 - omega3*v1 */
    const double t53 = JLT_FNMA(x[1], t31, t52); /* omega1*v3 - omega3*v1 - gamma2*(g - t30) */
    const double t54 = JLT_FNMA(p[10], t51, t53); /* omega1*v3 - omega3*v1 - gamma2*(g - t30) - I1/m*gamma1*t43*t44 */
    out[4] = t54;
    const double t55 = x[7]*x[3]; /* omega2*v1 */
    const double t56 = JLT_FNMA(x[6], x[4], t55); /* omega2*v1 - omega1*v2 */
    const double t57 = JLT_FNMA(x[2], t31, t56); /* omega2*v1 - omega1*v2 - gamma3*(g - t30) */
    out[5] = t57;
    const double t58 = x[8]*p[13]; /* omega3*(I1 - I3)/I1 */
    const double t59 = x[7]*t58; /* omega2*omega3*(I1 - I3)/I1 */
    const double t60 = t30*p[14]; /* t30*m*a3/I1 */
    const double t61 = JLT_FMA(x[1], t60, t59); /* gamma2*t30*m*a3/I1 + omega2*omega3*(I1 - I3)/I1 */
    const double t62 = JLT_FNMA(t23, t51, t61); /* gamma2*t30*m*a3/I1 + omega2*omega3*(I1 - I3)/I1 - b*gamma1*t43*t44 */
    out[6] = t62;
    const double t63 = x[6]*t58; /* omega1*omega3*(I1 - I3)/I1 */
    const double t64 = JLT_FMA(x[0], t60, t63); /* gamma1*t30*m*a3/I1 + omega1*omega3*(I1 - I3)/I1 */
    const double t65 = JLT_FMA(t23, t46, t64); /* b*gamma2*t43*t44 + gamma1*t30*m*a3/I1 + omega1*omega3*(I1 - I3)/I1 */
    const double t66 = -t65; /* -t65 */
    out[7] = t66;
    const double t67 = t43*p[15]; /* t43*R*I1/I3 */
    out[8] = t67;
    const double t68 = x[8]*x[10]; /* omega3*alpha2 */
    const double t69 = JLT_FNMA(x[7], x[11], t68); /* omega3*alpha2 - omega2*alpha3 */
    out[9] = t69;
    const double t70 = x[6]*x[11]; /* omega1*alpha3 */
    const double t71 = JLT_FNMA(x[8], x[9], t70); /* omega1*alpha3 - omega3*alpha1 */
    out[10] = t71;
    const double t72 = x[7]*x[9]; /* omega2*alpha1 */
    const double t73 = JLT_FNMA(x[6], x[10], t72); /* omega2*alpha1 - omega1*alpha2 */
    out[11] = t73;
    const double t74 = x[8]*x[13]; /* omega3*beta2 */
    const double t75 = JLT_FNMA(x[7], x[14], t74); /* omega3*beta2 - omega2*beta3 */
    out[12] = t75;
    const double t76 = x[6]*x[14]; /* omega1*beta3 */
    const double t77 = JLT_FNMA(x[8], x[12], t76); /* omega1*beta3 - omega3*beta1 */
    out[13] = t77;
    const double t78 = x[7]*x[12]; /* omega2*beta1 */
    const double t79 = JLT_FNMA(x[6], x[13], t78); /* omega2*beta1 - omega1*beta2 */
    out[14] = t79;
    const double t80 = x[3]*x[9]; /* v1*alpha1 */
    const double t81 = JLT_FMA(x[4], x[10], t80); /* v2*alpha2 + v1*alpha1 */
    const double t82 = JLT_FMA(x[5], x[11], t81); /* v3*alpha3 + v2*alpha2 + v1*alpha1 */
    out[15] = t82;
    const double t83 = x[3]*x[12]; /* v1*beta1 */
    const double t84 = JLT_FMA(x[4], x[13], t83); /* v2*beta2 + v1*beta1 */
    const double t85 = JLT_FMA(x[5], x[14], t84); /* v3*beta3 + v2*beta2 + v1*beta1 */
    out[16] = t85;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    for (size_t i = 0; i < 289; i++) out[i] = 0.0;
    out[1] = x[8];
    out[163] = x[8];
    out[217] = x[8];
    out[34] = x[7];
    out[88] = x[7];
    out[196] = x[7];
    out[250] = x[7];
    out[23] = x[2];
    out[8] = x[1];
    out[19] = x[6];
    out[181] = x[6];
    out[235] = x[6];
    out[41] = x[0];
    out[266] = x[5];
    out[286] = x[5];
    out[265] = x[4];
    out[285] = x[4];
    out[264] = x[3];
    out[284] = x[3];
    out[176] = x[11];
    out[260] = x[11];
    out[161] = x[10];
    out[259] = x[10];
    out[194] = x[9];
    out[258] = x[9];
    out[227] = x[14];
    out[277] = x[14];
    out[212] = x[13];
    out[276] = x[13];
    out[245] = x[12];
    out[275] = x[12];
    const double t0 = -x[7]; /* -omega2 */
    out[2] = t0;
    out[164] = t0;
    out[218] = t0;
    const double t1 = -x[2]; /* -gamma3 */
    out[7] = t1;
    const double t2 = -x[8]; /* -omega3 */
    out[17] = t2;
    out[179] = t2;
    out[233] = t2;
    const double t3 = -x[0]; /* -gamma1 */
    out[25] = t3;
    const double t4 = -x[6]; /* -omega1 */
    out[35] = t4;
    out[89] = t4;
    out[197] = t4;
    out[251] = t4;
    const double t5 = -x[1]; /* -gamma2 */
    out[40] = t5;
    const double t6 = -x[11]; /* -alpha3 */
    out[160] = t6;
    const double t7 = -x[9]; /* -alpha1 */
    out[178] = t7;
    const double t8 = -x[10]; /* -alpha2 */
    out[193] = t8;
    const double t9 = -x[14]; /* -beta3 */
    out[211] = t9;
    const double t10 = -x[12]; /* -beta1 */
    out[229] = t10;
    const double t11 = -x[13]; /* -beta2 */
    out[244] = t11;
    const double t12 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t13 = JLT_FMA(x[1], x[1], t12); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t14 = JLT_FMA(x[2], x[2], t13); /* one = gamma3*gamma3 + gamma2*gamma2 + gamma1*gamma1 */
    const double t15 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t16 = JLT_FMA(p[11], t13, p[10]); /* R^2*I1/I3*(gamma2*gamma2 + gamma1*gamma1) + I1/m */
    const double t17 = JLT_FMA(t15, t15, t16); /* Theta/(m*I3) = b*b + R^2*I1/I3*(gamma2*gamma2 + gamma1*gamma1) + I1/m */
    const double t18 = p[4]*t14; /* I1*one */
    const double t19 = JLT_FMA(p[9], t13, t18); /* D = m*a3^2*(gamma2*gamma2 + gamma1*gamma1) + I1*one */
    const double t20 = p[6]*t14; /* g*I1*one */
    const double t21 = t13*t17; /* (gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3) */
    const double t22 = t19*t21; /* D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3) */
    const double t23 = 1.0/t22; /* 1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t24 = t19*t23; /* D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t25 = t21*t23; /* 1/D = (gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t26 = t13*t24; /* 1/(Theta/(m*I3)) = (gamma2*gamma2 + gamma1*gamma1)*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t27 = t17*t24; /* Theta/(m*I3)*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t28 = x[6]*x[6]; /* omega1*omega1 */
    const double t29 = JLT_FMA(x[7], x[7], t28); /* omega2*omega2 + omega1*omega1 */
    const double t30 = x[6]*x[0]; /* omega1*gamma1 */
    const double t31 = JLT_FMA(x[7], x[1], t30); /* q = omega2*gamma2 + omega1*gamma1 */
    const double t32 = x[2]*p[12]; /* gamma3*2*R */
    const double t33 = JLT_FNMA(p[8], t15, t32); /* gamma3*2*R - I3/I1*b */
    const double t34 = x[7]*x[4]; /* omega2*v2 */
    const double t35 = JLT_FMA(x[6], x[3], t34); /* omega1*v1 + omega2*v2 */
    const double t36 = x[2]*t29; /* gamma3*(omega2*omega2 + omega1*omega1) */
    const double t37 = x[8]*p[8]; /* omega3*I3/I1 */
    const double t38 = JLT_FNMA(t31, t37, t36); /* gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*I3/I1 */
    const double t39 = JLT_FNMA(p[7], t38, t20); /* g*I1*one - a3*I1*(gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*I3/I1) */
    const double t40 = x[5]*t31; /* v3*q */
    const double t41 = JLT_FNMA(x[2], t35, t40); /* v3*q - gamma3*(omega1*v1 + omega2*v2) */
    const double t42 = x[7]*x[0]; /* omega2*gamma1 */
    const double t43 = JLT_FNMA(x[1], x[6], t42); /* dgamma3 = omega2*gamma1 - gamma2*omega1 */
    const double t44 = x[8]*t33; /* omega3*(gamma3*2*R - I3/I1*b) */
    const double t45 = JLT_FMA(p[1], t31, t44); /* R*q + omega3*(gamma3*2*R - I3/I1*b) */
    const double t46 = JLT_FMA(t43, t45, t41); /* gyroscopic = dgamma3*(R*q + omega3*(gamma3*2*R - I3/I1*b)) + v3*q - gamma3*(omega1*v1 + omega2*v2) */
    const double t47 = t33*t43; /* (gamma3*2*R - I3/I1*b)*dgamma3 */
    const double t48 = x[2]*p[17]; /* gamma3*2*g*I1 */
    const double t49 = JLT_FNMA(p[7], t29, t48); /* gamma3*2*g*I1 - a3*I1*(omega2*omega2 + omega1*omega1) */
    const double t50 = x[8]*p[16]; /* omega3*a3*I3 */
    const double t51 = t25*t39; /* 1/D*t39 */
    const double t52 = p[22]*t39; /* 2*I1*t39 */
    const double t53 = t26*t46; /* 1/(Theta/(m*I3))*gyroscopic */
    const double t54 = p[20]*t46; /* I3/(R^2*I1)*gyroscopic */
    const double t55 = JLT_FMA(t27, t54, t53); /* t27*I3/(R^2*I1)*gyroscopic + 1/(Theta/(m*I3))*gyroscopic */
    const double t56 = x[2]*t25; /* gamma3*1/D */
    const double t57 = JLT_FNMA(t52, t56, t49); /* gamma3*2*g*I1 - a3*I1*(omega2*omega2 + omega1*omega1) - 2*I1*t39*gamma3*1/D */
    const double t58 = x[0]*t25; /* gamma1*1/D */
    const double t59 = x[1]*t25; /* gamma2*1/D */
    const double t60 = x[6]*t50; /* omega1*omega3*a3*I3 */
    const double t61 = x[7]*t50; /* omega2*omega3*a3*I3 */
    const double t62 = JLT_FNMA(p[18], t51, p[17]); /* 2*g*I1 - (2*I1 + 2*m*a3^2)*1/D*t39 */
    const double t63 = JLT_FMA(x[0], t62, t60); /* gamma1*(2*g*I1 - (2*I1 + 2*m*a3^2)*1/D*t39) + omega1*omega3*a3*I3 */
    const double t64 = JLT_FMA(x[1], t62, t61); /* gamma2*(2*g*I1 - (2*I1 + 2*m*a3^2)*1/D*t39) + omega2*omega3*a3*I3 */
    const double t65 = t56*t63; /* gamma3*1/D*t63 */
    out[85] = t65;
    const double t66 = t56*t64; /* gamma3*1/D*t64 */
    out[86] = t66;
    const double t67 = JLT_FMA(p[1], t43, x[5]); /* R*dgamma3 + v3 */
    const double t68 = x[7]*x[2]; /* omega2*gamma3 */
    const double t69 = x[8]*p[25]; /* omega3*1/2*I3/I1 */
    const double t70 = x[0]*t24; /* gamma1*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t71 = p[10]*t46; /* I1/m*gyroscopic */
    const double t72 = t24*t71; /* D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3))*I1/m*gyroscopic */
    const double t73 = x[1]*t24; /* gamma2*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t74 = p[1]*t46; /* R*gyroscopic */
    const double t75 = p[21]*t55; /* 2*R^2*I1/I3*(t27*I3/(R^2*I1)*gyroscopic + 1/(Theta/(m*I3))*gyroscopic) */
    const double t76 = t57*t58; /* t57*gamma1*1/D */
    const double t77 = x[8]*p[23]; /* omega3*(2*R - R*I3/I1) */
    const double t78 = JLT_FMS(t43, t77, t35); /* d(gyroscopic)/d(gamma3) = dgamma3*omega3*(2*R - R*I3/I1) - (omega1*v1 + omega2*v2) */
    const double t79 = x[2]*x[6]; /* gamma3*omega1 */
    const double t80 = x[0]*t67; /* gamma1*(R*dgamma3 + v3) */
    const double t81 = JLT_FNMA(x[2], x[3], t80); /* gamma1*(R*dgamma3 + v3) - gamma3*v1 */
    const double t82 = JLT_FNMA(x[1], t45, t81); /* d(gyroscopic)/d(omega1) = gamma1*(R*dgamma3 + v3) - gamma3*v1 - gamma2*(R*q + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t83 = JLT_FNMA(x[1], t69, t68); /* omega2*gamma3 - gamma2*omega3*1/2*I3/I1 */
    const double t84 = JLT_FNMA(x[0], t69, t79); /* gamma3*omega1 - gamma1*omega3*1/2*I3/I1 */
    const double t85 = x[1]*t67; /* gamma2*(R*dgamma3 + v3) */
    const double t86 = JLT_FNMA(x[2], x[4], t85); /* gamma2*(R*dgamma3 + v3) - gamma3*v2 */
    const double t87 = JLT_FMA(x[0], t45, t86); /* d(gyroscopic)/d(omega2) = gamma1*(R*q + omega3*(gamma3*2*R - I3/I1*b)) + gamma2*(R*dgamma3 + v3) - gamma3*v2 */
    const double t88 = JLT_FMA(t58, t63, t51); /* gamma1*1/D*t63 + 1/D*t39 */
    const double t89 = t59*t63; /* gamma2*1/D*t63 */
    const double t90 = x[6]*t67; /* omega1*(R*dgamma3 + v3) */
    const double t91 = x[7]*t67; /* omega2*(R*dgamma3 + v3) */
    const double t92 = JLT_FMA(x[7], t45, t90); /* d(gyroscopic)/d(gamma1) = omega2*(R*q + omega3*(gamma3*2*R - I3/I1*b)) + omega1*(R*dgamma3 + v3) */
    const double t93 = JLT_FNMA(x[6], t45, t91); /* d(gyroscopic)/d(gamma2) = omega2*(R*dgamma3 + v3) - omega1*(R*q + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t94 = x[1]*t75; /* gamma2*t75 */
    const double t95 = JLT_FMS(x[0], t75, t92); /* gamma1*t75 - d(gyroscopic)/d(gamma1) */
    const double t96 = t15*t53; /* b*1/(Theta/(m*I3))*gyroscopic */
    const double t97 = JLT_FNMA(p[12], t96, t78); /* d(gyroscopic)/d(gamma3) - 2*R*b*1/(Theta/(m*I3))*gyroscopic */
    const double t98 = t27*t96; /* t27*b*1/(Theta/(m*I3))*gyroscopic */
    const double t99 = p[24]*t83; /* 2*a3*I1*(omega2*gamma3 - gamma2*omega3*1/2*I3/I1) */
    const double t100 = JLT_FNMA(t56, t99, x[3]); /* v1 - gamma3*1/D*2*a3*I1*(omega2*gamma3 - gamma2*omega3*1/2*I3/I1) */
    out[92] = t100;
    const double t101 = t57*t59; /* t57*gamma2*1/D */
    const double t102 = t15*t70; /* b*gamma1*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t103 = t15*t73; /* b*gamma2*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t104 = t79*t102; /* gamma3*omega1*t102 */
    out[105] = t104;
    const double t105 = t68*t102; /* omega2*gamma3*t102 */
    out[106] = t105;
    const double t106 = t79*t103; /* gamma3*omega1*t103 */
    out[122] = t106;
    const double t107 = t68*t103; /* omega2*gamma3*t103 */
    out[123] = t107;
    const double t108 = p[26]*t59; /* 2*m*a3^2*gamma2*1/D */
    const double t109 = p[27]*t31; /* m*a3^2*I3/I1*q */
    const double t110 = p[14]*t76; /* m*a3/I1*t57*gamma1*1/D */
    const double t111 = JLT_FMA(t73, t74, t110); /* gamma2*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3))*R*gyroscopic + m*a3/I1*t57*gamma1*1/D */
    const double t112 = p[10]*t73; /* I1/m*gamma2*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t113 = JLT_FMA(t97, t112, t76); /* (d(gyroscopic)/d(gamma3) - 2*R*b*1/(Theta/(m*I3))*gyroscopic)*t112 + t57*gamma1*1/D */
    out[53] = t113;
    const double t114 = JLT_FMA(t97, t103, t111); /* (d(gyroscopic)/d(gamma3) - 2*R*b*1/(Theta/(m*I3))*gyroscopic)*t103 + t111 */
    const double t115 = -t114; /* -t114 */
    out[121] = t115;
    const double t116 = JLT_FNMA(t68, t112, x[8]); /* omega3 - omega2*gamma3*t112 */
    out[55] = t116;
    const double t117 = JLT_FMS(t31, t112, x[7]); /* q*t112 - omega2 */
    out[56] = t117;
    const double t118 = x[6]*p[13]; /* omega1*(I1 - I3)/I1 */
    const double t119 = JLT_FMA(t58, t109, t118); /* gamma1*1/D*m*a3^2*I3/I1*q + omega1*(I1 - I3)/I1 */
    const double t120 = JLT_FMA(t47, t103, t119); /* (gamma3*2*R - I3/I1*b)*dgamma3*t103 + gamma1*1/D*m*a3^2*I3/I1*q + omega1*(I1 - I3)/I1 */
    const double t121 = -t120; /* -t120 */
    out[127] = t121;
    const double t122 = p[19]*t70; /* 2*R^2*I1^2/(m*I3)*gamma1*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t123 = t55*t122; /* (t27*I3/(R^2*I1)*gyroscopic + 1/(Theta/(m*I3))*gyroscopic)*t122 */
    const double t124 = t88 - p[2]; /* gamma1*1/D*t63 + 1/D*t39 - g */
    const double t125 = JLT_FMA(t92, t112, t124); /* d(gyroscopic)/d(gamma1)*t112 + gamma1*1/D*t63 + 1/D*t39 - g */
    const double t126 = JLT_FNMA(x[1], t123, t125); /* d(gyroscopic)/d(gamma1)*t112 + gamma1*1/D*t63 + 1/D*t39 - g - gamma2*t123 */
    out[51] = t126;
    const double t127 = t58*t64; /* gamma1*1/D*t64 */
    const double t128 = JLT_FMA(t59, t64, t51); /* gamma2*1/D*t64 + 1/D*t39 */
    const double t129 = t51 - p[2]; /* 1/D*t39 - g */
    const double t130 = JLT_FMA(t56, t57, t129); /* gamma3*1/D*t57 + 1/D*t39 - g */
    out[87] = t130;
    const double t131 = p[24]*t84; /* 2*a3*I1*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1) */
    const double t132 = p[16]*t31; /* a3*I3*q */
    const double t133 = t56*t132; /* gamma3*1/D*a3*I3*q */
    out[93] = t133;
    const double t134 = JLT_FMA(t56, t131, x[4]); /* gamma3*1/D*2*a3*I1*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1) + v2 */
    const double t135 = -t134; /* -t134 */
    out[91] = t135;
    const double t136 = p[10]*t70; /* I1/m*gamma1*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)) */
    const double t137 = JLT_FNMA(t97, t136, t101); /* t57*gamma2*1/D - (d(gyroscopic)/d(gamma3) - 2*R*b*1/(Theta/(m*I3))*gyroscopic)*t136 */
    out[70] = t137;
    const double t138 = p[14]*t101; /* m*a3/I1*t57*gamma2*1/D */
    const double t139 = JLT_FNMA(t70, t74, t138); /* m*a3/I1*t57*gamma2*1/D - gamma1*D*1/(D*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3))*R*gyroscopic */
    const double t140 = JLT_FNMA(t97, t102, t139); /* t139 - (d(gyroscopic)/d(gamma3) - 2*R*b*1/(Theta/(m*I3))*gyroscopic)*t102 */
    out[104] = t140;
    const double t141 = JLT_FMS(t79, t136, x[8]); /* gamma3*omega1*t136 - omega3 */
    out[71] = t141;
    const double t142 = t68*t136; /* omega2*gamma3*t136 */
    out[72] = t142;
    const double t143 = JLT_FNMA(t31, t136, x[6]); /* omega1 - q*t136 */
    out[73] = t143;
    const double t144 = t89 - t72; /* gamma2*1/D*t63 - t72 */
    const double t145 = t72 + t127; /* t72 + gamma1*1/D*t64 */
    const double t146 = JLT_FNMA(t92, t136, t144); /* gamma2*1/D*t63 - t72 - d(gyroscopic)/d(gamma1)*t136 */
    const double t147 = JLT_FMA(x[0], t123, t146); /* gamma1*t123 + gamma2*1/D*t63 - t72 - d(gyroscopic)/d(gamma1)*t136 */
    out[68] = t147;
    const double t148 = JLT_FMS(p[14], t89, t98); /* m*a3/I1*gamma2*1/D*t63 - t27*b*1/(Theta/(m*I3))*gyroscopic */
    const double t149 = JLT_FMA(t95, t102, t148); /* (gamma1*t75 - d(gyroscopic)/d(gamma1))*t102 + m*a3/I1*gamma2*1/D*t63 - t27*b*1/(Theta/(m*I3))*gyroscopic */
    out[102] = t149;
    const double t150 = JLT_FMA(p[14], t127, t98); /* m*a3/I1*gamma1*1/D*t64 + t27*b*1/(Theta/(m*I3))*gyroscopic */
    const double t151 = t59*t99; /* gamma2*1/D*2*a3*I1*(omega2*gamma3 - gamma2*omega3*1/2*I3/I1) */
    const double t152 = JLT_FMA(t58, t99, x[5]); /* gamma1*1/D*2*a3*I1*(omega2*gamma3 - gamma2*omega3*1/2*I3/I1) + v3 */
    const double t153 = JLT_FMS(t87, t112, t152); /* d(gyroscopic)/d(omega2)*t112 - t152 */
    out[58] = t153;
    const double t154 = JLT_FMA(t87, t136, t151); /* d(gyroscopic)/d(omega2)*t136 + gamma2*1/D*2*a3*I1*(omega2*gamma3 - gamma2*omega3*1/2*I3/I1) */
    const double t155 = -t154; /* -t154 */
    out[75] = t155;
    const double t156 = t84*t108; /* (gamma3*omega1 - gamma1*omega3*1/2*I3/I1)*2*m*a3^2*gamma2*1/D */
    const double t157 = JLT_FMA(t82, t102, t156); /* d(gyroscopic)/d(omega1)*t102 + t156 */
    const double t158 = -t157; /* -(d(gyroscopic)/d(omega1)*t102 + t156) */
    out[108] = t158;
    const double t159 = x[8]*p[13]; /* omega3*(I1 - I3)/I1 */
    const double t160 = JLT_FNMA(t83, t108, t159); /* omega3*(I1 - I3)/I1 - (omega2*gamma3 - gamma2*omega3*1/2*I3/I1)*2*m*a3^2*gamma2*1/D */
    const double t161 = JLT_FNMA(t87, t102, t160); /* t160 - d(gyroscopic)/d(omega2)*t102 */
    out[109] = t161;
    const double t162 = x[7]*p[13]; /* omega2*(I1 - I3)/I1 */
    const double t163 = JLT_FMA(t59, t109, t162); /* gamma2*1/D*m*a3^2*I3/I1*q + omega2*(I1 - I3)/I1 */
    const double t164 = JLT_FNMA(t47, t102, t163); /* gamma2*1/D*m*a3^2*I3/I1*q + omega2*(I1 - I3)/I1 - (gamma3*2*R - I3/I1*b)*dgamma3*t102 */
    out[110] = t164;
    const double t165 = t94*t102; /* gamma2*t75*t102 */
    const double t166 = t94 - t93; /* gamma2*t75 - d(gyroscopic)/d(gamma2) */
    const double t167 = JLT_FNMA(t112, t166, t145); /* t72 + gamma1*1/D*t64 - t112*(gamma2*t75 - d(gyroscopic)/d(gamma2)) */
    out[52] = t167;
    const double t168 = JLT_FMS(t103, t166, t150); /* t103*(gamma2*t75 - d(gyroscopic)/d(gamma2)) - (m*a3/I1*gamma1*1/D*t64 + t27*b*1/(Theta/(m*I3))*gyroscopic) */
    out[120] = t168;
    const double t169 = JLT_FNMA(t92, t103, t165); /* gamma2*t75*t102 - d(gyroscopic)/d(gamma1)*t103 */
    const double t170 = JLT_FNMA(p[14], t88, t169); /* gamma2*t75*t102 - d(gyroscopic)/d(gamma1)*t103 - m*a3/I1*(gamma1*1/D*t63 + 1/D*t39) */
    out[119] = t170;
    const double t171 = p[26]*t58; /* 2*m*a3^2*gamma1*1/D */
    const double t172 = JLT_FMS(t84, t171, t159); /* (gamma3*omega1 - gamma1*omega3*1/2*I3/I1)*2*m*a3^2*gamma1*1/D - omega3*(I1 - I3)/I1 */
    const double t173 = t83*t171; /* (omega2*gamma3 - gamma2*omega3*1/2*I3/I1)*2*m*a3^2*gamma1*1/D */
    const double t174 = JLT_FNMA(t82, t103, t172); /* t172 - d(gyroscopic)/d(omega1)*t103 */
    out[125] = t174;
    const double t175 = JLT_FNMA(t87, t103, t173); /* t173 - d(gyroscopic)/d(omega2)*t103 */
    out[126] = t175;
    const double t176 = t31*t103; /* q*t103 */
    const double t177 = -t176; /* -q*t103 */
    out[124] = t177;
    const double t178 = p[15]*t26; /* R*I1/I3*1/(Theta/(m*I3)) */
    const double t179 = t97*t178; /* (d(gyroscopic)/d(gamma3) - 2*R*b*1/(Theta/(m*I3))*gyroscopic)*R*I1/I3*1/(Theta/(m*I3)) */
    out[138] = t179;
    const double t180 = t87*t178; /* d(gyroscopic)/d(omega2)*R*I1/I3*1/(Theta/(m*I3)) */
    out[143] = t180;
    const double t181 = p[28]*t26; /* 2*R^3*I1^2/I3^2*1/(Theta/(m*I3)) */
    const double t182 = t53*t181; /* 1/(Theta/(m*I3))*gyroscopic*2*R^3*I1^2/I3^2*1/(Theta/(m*I3)) */
    const double t183 = t92*t178; /* d(gyroscopic)/d(gamma1)*R*I1/I3*1/(Theta/(m*I3)) */
    const double t184 = JLT_FNMA(x[0], t182, t183); /* d(gyroscopic)/d(gamma1)*R*I1/I3*1/(Theta/(m*I3)) - gamma1*1/(Theta/(m*I3))*gyroscopic*2*R^3*I1^2/I3^2*1/(Theta/(m*I3)) */
    out[136] = t184;
    const double t185 = t93*t178; /* d(gyroscopic)/d(gamma2)*R*I1/I3*1/(Theta/(m*I3)) */
    const double t186 = JLT_FNMA(x[1], t182, t185); /* d(gyroscopic)/d(gamma2)*R*I1/I3*1/(Theta/(m*I3)) - gamma2*1/(Theta/(m*I3))*gyroscopic*2*R^3*I1^2/I3^2*1/(Theta/(m*I3)) */
    out[137] = t186;
    const double t187 = t68*t178; /* omega2*gamma3*R*I1/I3*1/(Theta/(m*I3)) */
    const double t188 = -t187; /* -omega2*gamma3*R*I1/I3*1/(Theta/(m*I3)) */
    out[140] = t188;
    const double t189 = t31*t178; /* q*R*I1/I3*1/(Theta/(m*I3)) */
    out[141] = t189;
    const double t190 = t31*t102; /* q*t102 */
    const double t191 = -t190; /* -q*t102 */
    out[107] = t191;
    const double t192 = t82*t178; /* d(gyroscopic)/d(omega1)*R*I1/I3*1/(Theta/(m*I3)) */
    out[142] = t192;
    const double t193 = t47*t178; /* (gamma3*2*R - I3/I1*b)*dgamma3*R*I1/I3*1/(Theta/(m*I3)) */
    out[144] = t193;
    const double t194 = t79*t178; /* gamma3*omega1*R*I1/I3*1/(Theta/(m*I3)) */
    const double t195 = -t194; /* -gamma3*omega1*R*I1/I3*1/(Theta/(m*I3)) */
    out[139] = t195;
    const double t196 = t79*t112; /* gamma3*omega1*t112 */
    const double t197 = -t196; /* -gamma3*omega1*t112 */
    out[54] = t197;
    const double t198 = t58*t131; /* gamma1*1/D*2*a3*I1*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1) */
    const double t199 = JLT_FMS(t82, t112, t198); /* d(gyroscopic)/d(omega1)*t112 - gamma1*1/D*2*a3*I1*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1) */
    out[57] = t199;
    const double t200 = JLT_FMA(t58, t132, x[4]); /* gamma1*1/D*a3*I3*q + v2 */
    const double t201 = JLT_FMA(t47, t112, t200); /* (gamma3*2*R - I3/I1*b)*dgamma3*t112 + gamma1*1/D*a3*I3*q + v2 */
    out[59] = t201;
    const double t202 = JLT_FNMA(t59, t131, x[5]); /* v3 - gamma2*1/D*2*a3*I1*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1) */
    const double t203 = JLT_FNMA(t82, t136, t202); /* t202 - d(gyroscopic)/d(omega1)*t136 */
    out[74] = t203;
    const double t204 = JLT_FMS(t59, t132, x[3]); /* gamma2*1/D*a3*I3*q - v1 */
    const double t205 = JLT_FNMA(t47, t136, t204); /* gamma2*1/D*a3*I3*q - v1 - (gamma3*2*R - I3/I1*b)*dgamma3*t136 */
    out[76] = t205;
    const double t206 = t128 - p[2]; /* gamma2*1/D*t64 + 1/D*t39 - g */
    const double t207 = JLT_FMA(t136, t166, t206); /* t136*(gamma2*t75 - d(gyroscopic)/d(gamma2)) + gamma2*1/D*t64 + 1/D*t39 - g */
    out[69] = t207;
    const double t208 = p[14]*t128; /* m*a3/I1*(gamma2*1/D*t64 + 1/D*t39) */
    const double t209 = JLT_FMA(t102, t166, t208); /* t102*(gamma2*t75 - d(gyroscopic)/d(gamma2)) + m*a3/I1*(gamma2*1/D*t64 + 1/D*t39) */
    out[103] = t209;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    for (size_t i = 0; i < 306; i++) out[i] = 0.0;
    out[25] = x[1];
    out[18] = x[8];
    out[180] = x[8];
    out[234] = x[8];
    out[40] = x[2];
    out[51] = x[7];
    out[105] = x[7];
    out[213] = x[7];
    out[267] = x[7];
    const double t0 = x[2]*x[7]; /* gamma3*omega2 */
    const double t1 = JLT_FMS(x[1], x[8], t0); /* gamma2*omega3 - gamma3*omega2 */
    out[0] = t1;
    out[36] = x[6];
    out[198] = x[6];
    out[252] = x[6];
    const double t2 = x[2]*x[6]; /* gamma3*omega1 */
    out[58] = x[0];
    const double t3 = JLT_FNMA(x[8], x[0], t2); /* gamma3*omega1 - omega3*gamma1 */
    out[1] = t3;
    const double t4 = x[1]*x[6]; /* gamma2*omega1 */
    const double t5 = x[7]*x[0]; /* omega2*gamma1 */
    const double t6 = t4 - t5; /* gamma2*omega1 - omega2*gamma1 */
    const double t7 = t5 - t4; /* omega2*gamma1 - gamma2*omega1 */
    out[2] = t7;
    out[282] = x[4];
    out[302] = x[4];
    const double t8 = x[8]*x[4]; /* omega3*v2 */
    out[283] = x[5];
    out[303] = x[5];
    const double t9 = x[1]*x[1]; /* gamma2*gamma2 */
    const double t10 = JLT_FMA(x[0], x[0], t9); /* gamma1*gamma1 + gamma2*gamma2 */
    const double t11 = JLT_FMA(x[2], x[2], t10); /* one = gamma3*gamma3 + gamma1*gamma1 + gamma2*gamma2 */
    const double t12 = p[6]*t11; /* g*I1*one */
    const double t13 = x[6]*x[6]; /* omega1*omega1 */
    const double t14 = JLT_FMA(x[7], x[7], t13); /* omega2*omega2 + omega1*omega1 */
    const double t15 = x[2]*t14; /* gamma3*(omega2*omega2 + omega1*omega1) */
    const double t16 = x[6]*x[0]; /* omega1*gamma1 */
    const double t17 = JLT_FMA(x[1], x[7], t16); /* q = gamma2*omega2 + omega1*gamma1 */
    const double t18 = x[8]*p[8]; /* omega3*I3/I1 */
    const double t19 = JLT_FNMA(t17, t18, t15); /* gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*I3/I1 */
    const double t20 = JLT_FNMA(p[7], t19, t12); /* g*I1*one - a3*I1*(gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*I3/I1) */
    const double t21 = t11*p[4]; /* one*I1 */
    const double t22 = JLT_FMA(t10, p[9], t21); /* D = (gamma1*gamma1 + gamma2*gamma2)*m*a3^2 + one*I1 */
    const double t23 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t24 = JLT_FMA(t10, p[11], p[10]); /* (gamma1*gamma1 + gamma2*gamma2)*R^2*I1/I3 + I1/m */
    const double t25 = JLT_FMA(t23, t23, t24); /* Theta/(m*I3) = b*b + (gamma1*gamma1 + gamma2*gamma2)*R^2*I1/I3 + I1/m */
    const double t26 = t10*t25; /* (gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3) */
    const double t27 = t22*t26; /* D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3) */
    const double t28 = 1.0/t27; /* 1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t29 = t26*t28; /* 1/D = (gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)*1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t30 = t20*t29; /* t20*1/D */
    const double t31 = p[2] - t30; /* g - t20*1/D */
    const double t32 = x[5]*t17; /* v3*q */
    const double t33 = x[7]*x[4]; /* omega2*v2 */
    out[281] = x[3];
    out[301] = x[3];
    const double t34 = JLT_FMA(x[6], x[3], t33); /* omega1*v1 + omega2*v2 */
    const double t35 = x[2]*p[12]; /* gamma3*2*R */
    const double t36 = JLT_FNMA(p[8], t23, t35); /* gamma3*2*R - I3/I1*b */
    const double t37 = x[8]*t36; /* omega3*(gamma3*2*R - I3/I1*b) */
    const double t38 = JLT_FMA(t17, p[1], t37); /* q*R + omega3*(gamma3*2*R - I3/I1*b) */
    const double t39 = JLT_FNMA(x[2], t34, t32); /* v3*q - gamma3*(omega1*v1 + omega2*v2) */
    const double t40 = JLT_FNMA(t6, t38, t39); /* gyroscopic = v3*q - gamma3*(omega1*v1 + omega2*v2) - (gamma2*omega1 - omega2*gamma1)*(q*R + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t41 = t22*t28; /* D*1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t42 = x[1]*t41; /* gamma2*D*1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t43 = p[10]*t42; /* I1/m*gamma2*D*1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t44 = JLT_FNMA(x[7], x[5], t8); /* omega3*v2 - omega2*v3 */
    const double t45 = JLT_FNMA(x[0], t31, t44); /* omega3*v2 - omega2*v3 - gamma1*(g - t20*1/D) */
    const double t46 = JLT_FMA(t40, t43, t45); /* gyroscopic*t43 + omega3*v2 - omega2*v3 - gamma1*(g - t20*1/D) */
    out[3] = t46;
    const double t47 = x[6]*x[5]; /* omega1*v3 */
    const double t48 = x[0]*t41; /* gamma1*D*1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t49 = p[10]*t48; /* I1/m*gamma1*D*1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t50 = JLT_FNMA(x[8], x[3], t47); /* omega1*v3 - omega3*v1 */
    const double t51 = JLT_FNMA(x[1], t31, t50); /* omega1*v3 - omega3*v1 - gamma2*(g - t20*1/D) */
    const double t52 = JLT_FNMA(t40, t49, t51); /* omega1*v3 - omega3*v1 - gamma2*(g - t20*1/D) - gyroscopic*t49 */
    out[4] = t52;
    const double t53 = x[2]*t31; /* gamma3*(g - t20*1/D) */
    const double t54 = JLT_FMS(x[7], x[3], t53); /* omega2*v1 - gamma3*(g - t20*1/D) */
    const double t55 = JLT_FNMA(x[6], x[4], t54); /* omega2*v1 - gamma3*(g - t20*1/D) - omega1*v2 */
    out[5] = t55;
    const double t56 = x[8]*p[13]; /* omega3*(I1 - I3)/I1 */
    const double t57 = x[7]*t56; /* omega2*omega3*(I1 - I3)/I1 */
    const double t58 = t30*p[14]; /* t20*1/D*m*a3/I1 */
    const double t59 = t23*t48; /* b*gamma1*D*1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t60 = JLT_FMA(x[1], t58, t57); /* gamma2*t20*1/D*m*a3/I1 + omega2*omega3*(I1 - I3)/I1 */
    const double t61 = JLT_FNMA(t40, t59, t60); /* gamma2*t20*1/D*m*a3/I1 + omega2*omega3*(I1 - I3)/I1 - gyroscopic*t59 */
    out[6] = t61;
    const double t62 = x[6]*t56; /* omega1*omega3*(I1 - I3)/I1 */
    const double t63 = t23*t42; /* b*gamma2*D*1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t64 = JLT_FMA(x[0], t58, t62); /* gamma1*t20*1/D*m*a3/I1 + omega1*omega3*(I1 - I3)/I1 */
    const double t65 = JLT_FMA(t40, t63, t64); /* gyroscopic*t63 + gamma1*t20*1/D*m*a3/I1 + omega1*omega3*(I1 - I3)/I1 */
    const double t66 = -t65; /* -t65 */
    out[7] = t66;
    const double t67 = t10*t41; /* 1/(Theta/(m*I3)) = (gamma1*gamma1 + gamma2*gamma2)*D*1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t68 = p[15]*t67; /* R*I1/I3*1/(Theta/(m*I3)) */
    const double t69 = t40*t68; /* gyroscopic*R*I1/I3*1/(Theta/(m*I3)) */
    out[8] = t69;
    out[178] = x[10];
    out[276] = x[10];
    const double t70 = x[8]*x[10]; /* omega3*alpha2 */
    out[193] = x[11];
    out[277] = x[11];
    const double t71 = JLT_FNMA(x[7], x[11], t70); /* omega3*alpha2 - omega2*alpha3 */
    out[9] = t71;
    const double t72 = x[6]*x[11]; /* omega1*alpha3 */
    out[211] = x[9];
    out[275] = x[9];
    const double t73 = JLT_FNMA(x[8], x[9], t72); /* omega1*alpha3 - omega3*alpha1 */
    out[10] = t73;
    const double t74 = x[7]*x[9]; /* omega2*alpha1 */
    const double t75 = JLT_FNMA(x[6], x[10], t74); /* omega2*alpha1 - omega1*alpha2 */
    out[11] = t75;
    out[229] = x[13];
    out[293] = x[13];
    const double t76 = x[8]*x[13]; /* omega3*beta2 */
    out[244] = x[14];
    out[294] = x[14];
    const double t77 = JLT_FNMA(x[7], x[14], t76); /* omega3*beta2 - omega2*beta3 */
    out[12] = t77;
    const double t78 = x[6]*x[14]; /* omega1*beta3 */
    out[262] = x[12];
    out[292] = x[12];
    const double t79 = JLT_FNMA(x[8], x[12], t78); /* omega1*beta3 - omega3*beta1 */
    out[13] = t79;
    const double t80 = x[7]*x[12]; /* omega2*beta1 */
    const double t81 = JLT_FNMA(x[6], x[13], t80); /* omega2*beta1 - omega1*beta2 */
    out[14] = t81;
    const double t82 = x[3]*x[9]; /* v1*alpha1 */
    const double t83 = JLT_FMA(x[4], x[10], t82); /* v2*alpha2 + v1*alpha1 */
    const double t84 = JLT_FMA(x[5], x[11], t83); /* v3*alpha3 + v2*alpha2 + v1*alpha1 */
    out[15] = t84;
    const double t85 = x[3]*x[12]; /* v1*beta1 */
    const double t86 = JLT_FMA(x[4], x[13], t85); /* v2*beta2 + v1*beta1 */
    const double t87 = JLT_FMA(x[5], x[14], t86); /* v3*beta3 + v2*beta2 + v1*beta1 */
    out[16] = t87;
    const double t88 = -x[7]; /* -omega2 */
    out[19] = t88;
    out[181] = t88;
    out[235] = t88;
    const double t89 = -x[2]; /* -gamma3 */
    out[24] = t89;
    const double t90 = -x[8]; /* -omega3 */
    out[34] = t90;
    out[196] = t90;
    out[250] = t90;
    const double t91 = -x[0]; /* -gamma1 */
    out[42] = t91;
    const double t92 = -x[6]; /* -omega1 */
    out[52] = t92;
    out[106] = t92;
    out[214] = t92;
    out[268] = t92;
    const double t93 = -x[1]; /* -gamma2 */
    out[57] = t93;
    const double t94 = x[8]*p[16]; /* omega3*a3*I3 */
    const double t95 = x[6]*t94; /* omega1*omega3*a3*I3 */
    const double t96 = JLT_FNMA(t30, p[18], p[17]); /* 2*g*I1 - t20*1/D*(2*I1 + 2*m*a3^2) */
    const double t97 = JLT_FMA(x[0], t96, t95); /* gamma1*(2*g*I1 - t20*1/D*(2*I1 + 2*m*a3^2)) + omega1*omega3*a3*I3 */
    const double t98 = x[0]*t29; /* gamma1*1/D */
    const double t99 = t25*t41; /* Theta/(m*I3)*D*1/(D*(gamma1*gamma1 + gamma2*gamma2)*Theta/(m*I3)) */
    const double t100 = JLT_FMA(p[20], t99, t67); /* I3/(R^2*I1)*t99 + 1/(Theta/(m*I3)) */
    const double t101 = t40*t67; /* gyroscopic*1/(Theta/(m*I3)) */
    const double t102 = t99*t101; /* t99*gyroscopic*1/(Theta/(m*I3)) */
    const double t103 = p[19]*t100; /* 2*R^2*I1^2/(m*I3)*(I3/(R^2*I1)*t99 + 1/(Theta/(m*I3))) */
    const double t104 = t102*t103; /* t99*gyroscopic*1/(Theta/(m*I3))*2*R^2*I1^2/(m*I3)*(I3/(R^2*I1)*t99 + 1/(Theta/(m*I3))) */
    const double t105 = x[0]*t104; /* gamma1*t104 */
    const double t106 = x[1]*t105; /* gamma2*gamma1*t104 */
    const double t107 = JLT_FNMA(t6, p[1], x[5]); /* v3 - (gamma2*omega1 - omega2*gamma1)*R */
    const double t108 = x[6]*t107; /* omega1*(v3 - (gamma2*omega1 - omega2*gamma1)*R) */
    const double t109 = JLT_FMA(x[7], t38, t108); /* d(gyroscopic)/d(gamma1) = omega2*(q*R + omega3*(gamma3*2*R - I3/I1*b)) + omega1*(v3 - (gamma2*omega1 - omega2*gamma1)*R) */
    const double t110 = JLT_FMS(t43, t109, t31); /* t43*d(gyroscopic)/d(gamma1) - (g - t20*1/D) */
    const double t111 = JLT_FMA(t97, t98, t110); /* t97*gamma1*1/D + t43*d(gyroscopic)/d(gamma1) - (g - t20*1/D) */
    const double t112 = t111 - t106; /* t97*gamma1*1/D + t43*d(gyroscopic)/d(gamma1) - (g - t20*1/D) - gamma2*gamma1*t104 */
    out[68] = t112;
    const double t113 = p[10]*t102; /* I1/m*t99*gyroscopic*1/(Theta/(m*I3)) */
    const double t114 = x[1]*t96; /* gamma2*(2*g*I1 - t20*1/D*(2*I1 + 2*m*a3^2)) */
    const double t115 = JLT_FMA(x[7], t94, t114); /* omega2*omega3*a3*I3 + gamma2*(2*g*I1 - t20*1/D*(2*I1 + 2*m*a3^2)) */
    const double t116 = x[7]*t107; /* omega2*(v3 - (gamma2*omega1 - omega2*gamma1)*R) */
    const double t117 = JLT_FNMA(x[6], t38, t116); /* d(gyroscopic)/d(gamma2) = omega2*(v3 - (gamma2*omega1 - omega2*gamma1)*R) - omega1*(q*R + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t118 = JLT_FMA(t43, t117, t113); /* t43*d(gyroscopic)/d(gamma2) + I1/m*t99*gyroscopic*1/(Theta/(m*I3)) */
    const double t119 = JLT_FMA(t98, t115, t118); /* gamma1*1/D*t115 + t118 */
    const double t120 = JLT_FNMA(t9, t104, t119); /* gamma1*1/D*t115 + t118 - gamma2*gamma2*t104 */
    out[69] = t120;
    const double t121 = t53*p[22]; /* gamma3*(g - t20*1/D)*2*I1 */
    const double t122 = JLT_FNMA(p[7], t14, t121); /* gamma3*(g - t20*1/D)*2*I1 - a3*I1*(omega2*omega2 + omega1*omega1) */
    const double t123 = t98*t122; /* gamma1*1/D*t122 */
    const double t124 = x[8]*p[23]; /* omega3*(2*R - R*I3/I1) */
    const double t125 = JLT_FMA(t6, t124, t34); /* (gamma2*omega1 - omega2*gamma1)*omega3*(2*R - R*I3/I1) + omega1*v1 + omega2*v2 */
    const double t126 = t101*p[29]; /* gyroscopic*1/(Theta/(m*I3))*2*R*I1/m */
    const double t127 = JLT_FNMA(t43, t125, t123); /* gamma1*1/D*t122 - t43*t125 */
    const double t128 = JLT_FNMA(t63, t126, t127); /* gamma1*1/D*t122 - t43*t125 - t63*gyroscopic*1/(Theta/(m*I3))*2*R*I1/m */
    out[70] = t128;
    const double t129 = t2*t43; /* gamma3*omega1*t43 */
    const double t130 = -t129; /* -gamma3*omega1*t43 */
    out[71] = t130;
    const double t131 = JLT_FNMA(t0, t43, x[8]); /* omega3 - gamma3*omega2*t43 */
    out[72] = t131;
    const double t132 = JLT_FMS(t17, t43, x[7]); /* q*t43 - omega2 */
    out[73] = t132;
    const double t133 = x[8]*p[25]; /* omega3*1/2*I3/I1 */
    const double t134 = JLT_FNMA(x[0], t133, t2); /* gamma3*omega1 - gamma1*omega3*1/2*I3/I1 */
    const double t135 = p[24]*t134; /* 2*a3*I1*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1) */
    const double t136 = t98*t135; /* gamma1*1/D*2*a3*I1*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1) */
    const double t137 = x[0]*t107; /* gamma1*(v3 - (gamma2*omega1 - omega2*gamma1)*R) */
    const double t138 = JLT_FNMA(x[2], x[3], t137); /* gamma1*(v3 - (gamma2*omega1 - omega2*gamma1)*R) - gamma3*v1 */
    const double t139 = JLT_FNMA(x[1], t38, t138); /* d(gyroscopic)/d(omega1) = gamma1*(v3 - (gamma2*omega1 - omega2*gamma1)*R) - gamma3*v1 - gamma2*(q*R + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t140 = JLT_FMS(t43, t139, t136); /* t43*d(gyroscopic)/d(omega1) - gamma1*1/D*2*a3*I1*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1) */
    out[74] = t140;
    const double t141 = JLT_FNMA(x[1], t133, t0); /* gamma3*omega2 - gamma2*omega3*1/2*I3/I1 */
    const double t142 = p[24]*t141; /* 2*a3*I1*(gamma3*omega2 - gamma2*omega3*1/2*I3/I1) */
    const double t143 = x[1]*t107; /* gamma2*(v3 - (gamma2*omega1 - omega2*gamma1)*R) */
    const double t144 = JLT_FNMA(x[2], x[4], t143); /* gamma2*(v3 - (gamma2*omega1 - omega2*gamma1)*R) - gamma3*v2 */
    const double t145 = JLT_FMA(x[0], t38, t144); /* d(gyroscopic)/d(omega2) = gamma1*(q*R + omega3*(gamma3*2*R - I3/I1*b)) + gamma2*(v3 - (gamma2*omega1 - omega2*gamma1)*R) - gamma3*v2 */
    const double t146 = JLT_FMA(t98, t142, x[5]); /* gamma1*1/D*2*a3*I1*(gamma3*omega2 - gamma2*omega3*1/2*I3/I1) + v3 */
    const double t147 = JLT_FMS(t43, t145, t146); /* t43*d(gyroscopic)/d(omega2) - t146 */
    out[75] = t147;
    const double t148 = t17*p[16]; /* q*a3*I3 */
    const double t149 = t6*t36; /* (gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - I3/I1*b) */
    const double t150 = JLT_FMA(t98, t148, x[4]); /* gamma1*1/D*q*a3*I3 + v2 */
    const double t151 = JLT_FNMA(t43, t149, t150); /* gamma1*1/D*q*a3*I3 + v2 - t43*(gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - I3/I1*b) */
    out[76] = t151;
    const double t152 = x[1]*t29; /* gamma2*1/D */
    const double t153 = t97*t152; /* t97*gamma2*1/D */
    const double t154 = JLT_FNMA(t49, t109, t153); /* t97*gamma2*1/D - t49*d(gyroscopic)/d(gamma1) */
    const double t155 = t154 - t113; /* t97*gamma2*1/D - t49*d(gyroscopic)/d(gamma1) - I1/m*t99*gyroscopic*1/(Theta/(m*I3)) */
    const double t156 = JLT_FMA(x[0], t105, t155); /* gamma1*gamma1*t104 + t155 */
    out[85] = t156;
    const double t157 = t115*t152; /* t115*gamma2*1/D */
    const double t158 = t157 - t31; /* t115*gamma2*1/D - (g - t20*1/D) */
    const double t159 = JLT_FNMA(t49, t117, t158); /* t115*gamma2*1/D - (g - t20*1/D) - t49*d(gyroscopic)/d(gamma2) */
    const double t160 = t106 + t159; /* gamma2*gamma1*t104 + t159 */
    out[86] = t160;
    const double t161 = t122*t152; /* t122*gamma2*1/D */
    const double t162 = JLT_FMA(t49, t125, t161); /* t49*t125 + t122*gamma2*1/D */
    const double t163 = JLT_FMA(t59, t126, t162); /* t59*gyroscopic*1/(Theta/(m*I3))*2*R*I1/m + t49*t125 + t122*gamma2*1/D */
    out[87] = t163;
    const double t164 = JLT_FMS(t2, t49, x[8]); /* gamma3*omega1*t49 - omega3 */
    out[88] = t164;
    const double t165 = t0*t49; /* gamma3*omega2*t49 */
    out[89] = t165;
    const double t166 = JLT_FNMA(t17, t49, x[6]); /* omega1 - q*t49 */
    out[90] = t166;
    const double t167 = JLT_FNMA(t135, t152, x[5]); /* v3 - 2*a3*I1*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1)*gamma2*1/D */
    const double t168 = JLT_FNMA(t49, t139, t167); /* t167 - t49*d(gyroscopic)/d(omega1) */
    out[91] = t168;
    const double t169 = t142*t152; /* 2*a3*I1*(gamma3*omega2 - gamma2*omega3*1/2*I3/I1)*gamma2*1/D */
    const double t170 = JLT_FMA(t49, t145, t169); /* t49*d(gyroscopic)/d(omega2) + 2*a3*I1*(gamma3*omega2 - gamma2*omega3*1/2*I3/I1)*gamma2*1/D */
    const double t171 = -t170; /* -t170 */
    out[92] = t171;
    const double t172 = JLT_FMS(t148, t152, x[3]); /* q*a3*I3*gamma2*1/D - v1 */
    const double t173 = JLT_FMA(t49, t149, t172); /* t49*(gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - I3/I1*b) + q*a3*I3*gamma2*1/D - v1 */
    out[93] = t173;
    const double t174 = x[2]*t29; /* gamma3*1/D */
    const double t175 = t97*t174; /* t97*gamma3*1/D */
    out[102] = t175;
    const double t176 = t115*t174; /* t115*gamma3*1/D */
    out[103] = t176;
    const double t177 = JLT_FMS(t122, t174, t31); /* t122*gamma3*1/D - (g - t20*1/D) */
    out[104] = t177;
    const double t178 = JLT_FMA(t135, t174, x[4]); /* 2*a3*I1*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1)*gamma3*1/D + v2 */
    const double t179 = -t178; /* -t178 */
    out[108] = t179;
    const double t180 = JLT_FNMA(t142, t174, x[3]); /* v1 - 2*a3*I1*(gamma3*omega2 - gamma2*omega3*1/2*I3/I1)*gamma3*1/D */
    out[109] = t180;
    const double t181 = t148*t174; /* q*a3*I3*gamma3*1/D */
    out[110] = t181;
    const double t182 = t23*t101; /* b*gyroscopic*1/(Theta/(m*I3)) */
    const double t183 = t99*t182; /* t99*b*gyroscopic*1/(Theta/(m*I3)) */
    const double t184 = t40*p[21]; /* gyroscopic*2*R^2*I1/I3 */
    const double t185 = t100*t184; /* (I3/(R^2*I1)*t99 + 1/(Theta/(m*I3)))*gyroscopic*2*R^2*I1/I3 */
    const double t186 = JLT_FMS(x[0], t185, t109); /* gamma1*(I3/(R^2*I1)*t99 + 1/(Theta/(m*I3)))*gyroscopic*2*R^2*I1/I3 - d(gyroscopic)/d(gamma1) */
    const double t187 = JLT_FMS(p[14], t153, t183); /* m*a3/I1*t97*gamma2*1/D - t99*b*gyroscopic*1/(Theta/(m*I3)) */
    const double t188 = JLT_FMA(t59, t186, t187); /* t59*t186 + m*a3/I1*t97*gamma2*1/D - t99*b*gyroscopic*1/(Theta/(m*I3)) */
    out[119] = t188;
    const double t189 = x[1]*t185; /* gamma2*(I3/(R^2*I1)*t99 + 1/(Theta/(m*I3)))*gyroscopic*2*R^2*I1/I3 */
    const double t190 = t189 - t117; /* t189 - d(gyroscopic)/d(gamma2) */
    const double t191 = JLT_FMA(p[14], t157, t58); /* m*a3/I1*t115*gamma2*1/D + t20*1/D*m*a3/I1 */
    const double t192 = JLT_FMA(t59, t190, t191); /* t59*(t189 - d(gyroscopic)/d(gamma2)) + m*a3/I1*t115*gamma2*1/D + t20*1/D*m*a3/I1 */
    out[120] = t192;
    const double t193 = p[1]*t102; /* R*t99*gyroscopic*1/(Theta/(m*I3)) */
    const double t194 = x[0]*t193; /* gamma1*R*t99*gyroscopic*1/(Theta/(m*I3)) */
    const double t195 = JLT_FMA(p[12], t182, t125); /* 2*R*b*gyroscopic*1/(Theta/(m*I3)) + t125 */
    const double t196 = JLT_FMS(t59, t195, t194); /* t59*(2*R*b*gyroscopic*1/(Theta/(m*I3)) + t125) - gamma1*R*t99*gyroscopic*1/(Theta/(m*I3)) */
    const double t197 = JLT_FMA(p[14], t161, t196); /* m*a3/I1*t122*gamma2*1/D + t196 */
    out[121] = t197;
    const double t198 = t2*t59; /* gamma3*omega1*t59 */
    out[122] = t198;
    const double t199 = t0*t59; /* gamma3*omega2*t59 */
    out[123] = t199;
    const double t200 = t17*t59; /* q*t59 */
    const double t201 = -t200; /* -q*t59 */
    out[124] = t201;
    const double t202 = t134*p[26]; /* (gamma3*omega1 - gamma1*omega3*1/2*I3/I1)*2*m*a3^2 */
    const double t203 = t152*t202; /* gamma2*1/D*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1)*2*m*a3^2 */
    const double t204 = JLT_FMA(t59, t139, t203); /* t59*d(gyroscopic)/d(omega1) + t203 */
    const double t205 = -t204; /* -(t59*d(gyroscopic)/d(omega1) + t203) */
    out[125] = t205;
    const double t206 = t141*p[26]; /* (gamma3*omega2 - gamma2*omega3*1/2*I3/I1)*2*m*a3^2 */
    const double t207 = JLT_FNMA(t152, t206, t56); /* omega3*(I1 - I3)/I1 - gamma2*1/D*(gamma3*omega2 - gamma2*omega3*1/2*I3/I1)*2*m*a3^2 */
    const double t208 = JLT_FNMA(t59, t145, t207); /* t207 - t59*d(gyroscopic)/d(omega2) */
    out[126] = t208;
    const double t209 = x[7]*p[13]; /* omega2*(I1 - I3)/I1 */
    const double t210 = t17*p[27]; /* q*m*a3^2*I3/I1 */
    const double t211 = JLT_FMA(t152, t210, t209); /* gamma2*1/D*q*m*a3^2*I3/I1 + omega2*(I1 - I3)/I1 */
    const double t212 = JLT_FMA(t59, t149, t211); /* t59*(gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - I3/I1*b) + gamma2*1/D*q*m*a3^2*I3/I1 + omega2*(I1 - I3)/I1 */
    out[127] = t212;
    const double t213 = p[14]*t98; /* m*a3/I1*gamma1*1/D */
    const double t214 = JLT_FMA(t63, t109, t58); /* t63*d(gyroscopic)/d(gamma1) + t20*1/D*m*a3/I1 */
    const double t215 = JLT_FMS(t59, t189, t214); /* t59*t189 - (t63*d(gyroscopic)/d(gamma1) + t20*1/D*m*a3/I1) */
    const double t216 = JLT_FNMA(t97, t213, t215); /* t59*t189 - (t63*d(gyroscopic)/d(gamma1) + t20*1/D*m*a3/I1) - t97*m*a3/I1*gamma1*1/D */
    out[136] = t216;
    const double t217 = JLT_FMA(t115, t213, t183); /* t115*m*a3/I1*gamma1*1/D + t99*b*gyroscopic*1/(Theta/(m*I3)) */
    const double t218 = JLT_FMS(t63, t190, t217); /* t63*(t189 - d(gyroscopic)/d(gamma2)) - (t115*m*a3/I1*gamma1*1/D + t99*b*gyroscopic*1/(Theta/(m*I3))) */
    out[137] = t218;
    const double t219 = x[1]*t193; /* gamma2*R*t99*gyroscopic*1/(Theta/(m*I3)) */
    const double t220 = JLT_FMS(t63, t195, t219); /* t63*(2*R*b*gyroscopic*1/(Theta/(m*I3)) + t125) - gamma2*R*t99*gyroscopic*1/(Theta/(m*I3)) */
    const double t221 = JLT_FNMA(t122, t213, t220); /* t220 - t122*m*a3/I1*gamma1*1/D */
    out[138] = t221;
    const double t222 = t2*t63; /* gamma3*omega1*t63 */
    out[139] = t222;
    const double t223 = t0*t63; /* gamma3*omega2*t63 */
    out[140] = t223;
    const double t224 = t17*t63; /* q*t63 */
    const double t225 = -t224; /* -q*t63 */
    out[141] = t225;
    const double t226 = JLT_FMS(t98, t202, t56); /* gamma1*1/D*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1)*2*m*a3^2 - omega3*(I1 - I3)/I1 */
    const double t227 = JLT_FNMA(t63, t139, t226); /* t226 - t63*d(gyroscopic)/d(omega1) */
    out[142] = t227;
    const double t228 = t98*t206; /* gamma1*1/D*(gamma3*omega2 - gamma2*omega3*1/2*I3/I1)*2*m*a3^2 */
    const double t229 = JLT_FNMA(t63, t145, t228); /* t228 - t63*d(gyroscopic)/d(omega2) */
    out[143] = t229;
    const double t230 = x[6]*p[13]; /* omega1*(I1 - I3)/I1 */
    const double t231 = JLT_FMS(t63, t149, t230); /* t63*(gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - I3/I1*b) - omega1*(I1 - I3)/I1 */
    const double t232 = JLT_FNMA(t98, t210, t231); /* t231 - gamma1*1/D*q*m*a3^2*I3/I1 */
    out[144] = t232;
    const double t233 = t68*t109; /* R*I1/I3*1/(Theta/(m*I3))*d(gyroscopic)/d(gamma1) */
    const double t234 = t67*p[28]; /* 1/(Theta/(m*I3))*2*R^3*I1^2/I3^2 */
    const double t235 = t101*t234; /* gyroscopic*1/(Theta/(m*I3))*1/(Theta/(m*I3))*2*R^3*I1^2/I3^2 */
    const double t236 = JLT_FNMA(x[0], t235, t233); /* R*I1/I3*1/(Theta/(m*I3))*d(gyroscopic)/d(gamma1) - gamma1*gyroscopic*1/(Theta/(m*I3))*1/(Theta/(m*I3))*2*R^3*I1^2/I3^2 */
    out[153] = t236;
    const double t237 = t68*t117; /* R*I1/I3*1/(Theta/(m*I3))*d(gyroscopic)/d(gamma2) */
    const double t238 = JLT_FNMA(x[1], t235, t237); /* R*I1/I3*1/(Theta/(m*I3))*d(gyroscopic)/d(gamma2) - gamma2*gyroscopic*1/(Theta/(m*I3))*1/(Theta/(m*I3))*2*R^3*I1^2/I3^2 */
    out[154] = t238;
    const double t239 = t68*t195; /* R*I1/I3*1/(Theta/(m*I3))*(2*R*b*gyroscopic*1/(Theta/(m*I3)) + t125) */
    const double t240 = -t239; /* -t239 */
    out[155] = t240;
    const double t241 = t2*t68; /* gamma3*omega1*R*I1/I3*1/(Theta/(m*I3)) */
    const double t242 = -t241; /* -gamma3*omega1*R*I1/I3*1/(Theta/(m*I3)) */
    out[156] = t242;
    const double t243 = t0*t68; /* gamma3*omega2*R*I1/I3*1/(Theta/(m*I3)) */
    const double t244 = -t243; /* -gamma3*omega2*R*I1/I3*1/(Theta/(m*I3)) */
    out[157] = t244;
    const double t245 = t17*t68; /* q*R*I1/I3*1/(Theta/(m*I3)) */
    out[158] = t245;
    const double t246 = t68*t139; /* R*I1/I3*1/(Theta/(m*I3))*d(gyroscopic)/d(omega1) */
    out[159] = t246;
    const double t247 = t68*t145; /* R*I1/I3*1/(Theta/(m*I3))*d(gyroscopic)/d(omega2) */
    out[160] = t247;
    const double t248 = t68*t149; /* R*I1/I3*1/(Theta/(m*I3))*(gamma2*omega1 - omega2*gamma1)*(gamma3*2*R - I3/I1*b) */
    const double t249 = -t248; /* -t248 */
    out[161] = t249;
    const double t250 = -x[11]; /* -alpha3 */
    out[177] = t250;
    const double t251 = -x[9]; /* -alpha1 */
    out[195] = t251;
    const double t252 = -x[10]; /* -alpha2 */
    out[210] = t252;
    const double t253 = -x[14]; /* -beta3 */
    out[228] = t253;
    const double t254 = -x[12]; /* -beta1 */
    out[246] = t254;
    const double t255 = -x[13]; /* -beta2 */
    out[261] = t255;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t1 = JLT_FMA(x[1], x[1], t0); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t2 = x[1]*x[6]; /* gamma2*omega1 */
    const double t3 = JLT_FNMA(x[0], x[7], t2); /* gamma2*omega1 - gamma1*omega2 */
    const double t4 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t5 = JLT_FMA(p[11], t1, p[10]); /* R^2*I1/I3*(gamma2*gamma2 + gamma1*gamma1) + I1/m */
    const double t6 = JLT_FMA(t4, t4, t5); /* Theta/(m*I3) = b*b + R^2*I1/I3*(gamma2*gamma2 + gamma1*gamma1) + I1/m */
    const double t7 = t1*t6; /* (gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3) */
    const double t8 = x[2]*p[12]; /* gamma3*2*R */
    const double t9 = JLT_FNMA(p[8], t4, t8); /* gamma3*2*R - I3/I1*b */
    const double t10 = JLT_FMA(x[2], x[2], t1); /* one = gamma3*gamma3 + gamma2*gamma2 + gamma1*gamma1 */
    const double t11 = JLT_FMA(p[30], t1, t10); /* D/I1 = m*a3^2/I1*(gamma2*gamma2 + gamma1*gamma1) + one */
    const double t12 = p[31]*t1; /* m*R/I3*(gamma2*gamma2 + gamma1*gamma1) */
    const double t13 = JLT_FMA(t9, t12, x[2]); /* (gamma3*2*R - I3/I1*b)*m*R/I3*(gamma2*gamma2 + gamma1*gamma1) + gamma3 */
    const double t14 = x[8]*t9; /* omega3*(gamma3*2*R - I3/I1*b) */
    const double t15 = JLT_FNMA(p[1], t3, x[5]); /* v3 - R*(gamma2*omega1 - gamma1*omega2) */
    const double t16 = p[10]*t3; /* I1/m*(gamma2*omega1 - gamma1*omega2) */
    const double t17 = x[0]*x[6]; /* gamma1*omega1 */
    const double t18 = JLT_FMA(x[1], x[7], t17); /* q = gamma2*omega2 + gamma1*omega1 */
    const double t19 = JLT_FMA(p[1], t18, t14); /* R*q + omega3*(gamma3*2*R - I3/I1*b) */
    const double t20 = x[1]*t15; /* gamma2*(v3 - R*(gamma2*omega1 - gamma1*omega2)) */
    const double t21 = JLT_FNMA(x[2], x[4], t20); /* gamma2*(v3 - R*(gamma2*omega1 - gamma1*omega2)) - gamma3*v2 */
    const double t22 = x[0]*t15; /* gamma1*(v3 - R*(gamma2*omega1 - gamma1*omega2)) */
    const double t23 = JLT_FMA(x[0], t19, t21); /* d(gyroscopic)/d(omega2) = gamma1*(R*q + omega3*(gamma3*2*R - I3/I1*b)) + gamma2*(v3 - R*(gamma2*omega1 - gamma1*omega2)) - gamma3*v2 */
    const double t24 = JLT_FNMA(x[2], x[3], t22); /* gamma1*(v3 - R*(gamma2*omega1 - gamma1*omega2)) - gamma3*v1 */
    const double t25 = JLT_FNMA(x[1], t19, t24); /* d(gyroscopic)/d(omega1) = gamma1*(v3 - R*(gamma2*omega1 - gamma1*omega2)) - gamma3*v1 - gamma2*(R*q + omega3*(gamma3*2*R - I3/I1*b)) */
    const double t26 = x[1]*t23; /* gamma2*d(gyroscopic)/d(omega2) */
    const double t27 = JLT_FMA(x[0], t25, t26); /* gamma1*d(gyroscopic)/d(omega1) + gamma2*d(gyroscopic)/d(omega2) */
    const double t28 = t4*t27; /* b*t27 */
    const double t29 = JLT_FMA(t13, t16, t28); /* t13*I1/m*(gamma2*omega1 - gamma1*omega2) + b*t27 */
    const double t30 = t7*t11; /* (gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)*D/I1 */
    const double t31 = 1.0/t30; /* 1/((gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)*D/I1) */
    const double t32 = t11*t31; /* D/I1*1/((gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)*D/I1) */
    const double t33 = t29*t32; /* (t13*I1/m*(gamma2*omega1 - gamma1*omega2) + b*t27)*D/I1*1/((gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)*D/I1) */
    const double t34 = x[2]*x[6]; /* gamma3*omega1 */
    const double t35 = x[8]*p[25]; /* omega3*1/2*I3/I1 */
    const double t36 = JLT_FNMA(x[0], t35, t34); /* gamma3*omega1 - gamma1*omega3*1/2*I3/I1 */
    const double t37 = x[1]*t36; /* gamma2*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1) */
    const double t38 = x[2]*x[7]; /* gamma3*omega2 */
    const double t39 = JLT_FNMA(x[1], t35, t38); /* gamma3*omega2 - gamma2*omega3*1/2*I3/I1 */
    const double t40 = JLT_FNMA(x[0], t39, t37); /* gamma2*(gamma3*omega1 - gamma1*omega3*1/2*I3/I1) - gamma1*(gamma3*omega2 - gamma2*omega3*1/2*I3/I1) */
    const double t41 = p[32]*t40; /* 2*m*a3^2/I1*t40 */
    const double t42 = t7*t41; /* (gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)*2*m*a3^2/I1*t40 */
    const double t43 = JLT_FMA(t31, t42, t33); /* 1/((gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)*D/I1)*(gamma2*gamma2 + gamma1*gamma1)*Theta/(m*I3)*2*m*a3^2/I1*t40 + t33 */
    const double t44 = -t43; /* -t43 */
    out[0] = t44;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t1 = JLT_FMA(x[1], x[1], t0); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t2 = t1 - 1.0; /* gamma2*gamma2 + gamma1*gamma1 - 1 */
    const double t3 = JLT_FMA(x[2], x[2], t2); /* gamma3*gamma3 + gamma2*gamma2 + gamma1*gamma1 - 1 */
    out[0] = t3;
    const double t4 = JLT_FMS(x[9], x[9], 1.0); /* alpha1*alpha1 - 1 */
    const double t5 = JLT_FMA(x[10], x[10], t4); /* alpha2*alpha2 + alpha1*alpha1 - 1 */
    const double t6 = JLT_FMA(x[11], x[11], t5); /* alpha3*alpha3 + alpha2*alpha2 + alpha1*alpha1 - 1 */
    out[1] = t6;
    const double t7 = JLT_FMS(x[12], x[12], 1.0); /* beta1*beta1 - 1 */
    const double t8 = JLT_FMA(x[13], x[13], t7); /* beta2*beta2 + beta1*beta1 - 1 */
    const double t9 = JLT_FMA(x[14], x[14], t8); /* beta3*beta3 + beta2*beta2 + beta1*beta1 - 1 */
    out[2] = t9;
    const double t10 = x[0]*x[9]; /* gamma1*alpha1 */
    const double t11 = JLT_FMA(x[1], x[10], t10); /* gamma2*alpha2 + gamma1*alpha1 */
    const double t12 = JLT_FMA(x[2], x[11], t11); /* gamma3*alpha3 + gamma2*alpha2 + gamma1*alpha1 */
    out[3] = t12;
    const double t13 = x[0]*x[12]; /* gamma1*beta1 */
    const double t14 = JLT_FMA(x[1], x[13], t13); /* gamma2*beta2 + gamma1*beta1 */
    const double t15 = JLT_FMA(x[2], x[14], t14); /* gamma3*beta3 + gamma2*beta2 + gamma1*beta1 */
    out[4] = t15;
    const double t16 = x[9]*x[12]; /* alpha1*beta1 */
    const double t17 = JLT_FMA(x[10], x[13], t16); /* alpha2*beta2 + alpha1*beta1 */
    const double t18 = JLT_FMA(x[11], x[14], t17); /* alpha3*beta3 + alpha2*beta2 + alpha1*beta1 */
    out[5] = t18;
    const double t19 = x[0]*x[3]; /* gamma1*v1 */
    const double t20 = x[0]*x[7]; /* gamma1*omega2 */
    const double t21 = JLT_FNMA(x[1], x[6], t20); /* dgamma3 = gamma1*omega2 - gamma2*omega1 */
    const double t22 = JLT_FMA(x[1], x[4], t19); /* gamma2*v2 + gamma1*v1 */
    const double t23 = JLT_FMA(x[2], x[5], t22); /* gamma3*v3 + gamma2*v2 + gamma1*v1 */
    const double t24 = JLT_FNMA(p[3], t21, t23); /* gamma3*v3 + gamma2*v2 + gamma1*v1 - a3*dgamma3 */
    out[6] = t24;
    const double t25 = x[0]*x[4]; /* gamma1*v2 */
    const double t26 = JLT_FMA(x[2], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t27 = x[0]*x[6]; /* gamma1*omega1 */
    const double t28 = JLT_FMA(x[1], x[7], t27); /* q = gamma2*omega2 + gamma1*omega1 */
    const double t29 = p[1]*x[8]; /* R*omega3 */
    const double t30 = JLT_FNMA(x[1], x[3], t25); /* gamma1*v2 - gamma2*v1 */
    const double t31 = JLT_FMA(t26, t28, t30); /* b*q + gamma1*v2 - gamma2*v1 */
    const double t32 = JLT_FNMA(t1, t29, t31); /* b*q + gamma1*v2 - gamma2*v1 - (gamma2*gamma2 + gamma1*gamma1)*R*omega3 */
    out[7] = t32;
    const double t33 = x[2]*p[8]; /* gamma3*I3/I1 */
    const double t34 = JLT_FMA(x[8], t33, t28); /* omega3*gamma3*I3/I1 + q */
    const double t35 = p[33]*t34; /* (-R*I1)*(omega3*gamma3*I3/I1 + q) */
    const double t36 = JLT_FMA(x[8], p[34], t35); /* omega3*(-a3*I3) + (-R*I1)*(omega3*gamma3*I3/I1 + q) */
    out[8] = t36;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    for (size_t i = 0; i < 153; i++) out[i] = 0.0;
    out[60] = x[0];
    out[80] = x[0];
    out[105] = x[0];
    out[123] = x[0];
    out[61] = x[1];
    out[81] = x[1];
    out[106] = x[1];
    out[62] = x[2];
    out[82] = x[2];
    out[107] = x[2];
    out[51] = x[9];
    out[97] = x[9];
    out[52] = x[10];
    out[98] = x[10];
    out[53] = x[11];
    out[99] = x[11];
    out[68] = x[12];
    out[94] = x[12];
    out[69] = x[13];
    out[95] = x[13];
    out[70] = x[14];
    out[96] = x[14];
    out[104] = x[5];
    const double t0 = 2.0*x[0]; /* 2*gamma1 */
    out[0] = t0;
    const double t1 = 2.0*x[1]; /* 2*gamma2 */
    out[1] = t1;
    const double t2 = 2.0*x[2]; /* 2*gamma3 */
    out[2] = t2;
    const double t3 = 2.0*x[9]; /* 2*alpha1 */
    out[26] = t3;
    const double t4 = 2.0*x[10]; /* 2*alpha2 */
    out[27] = t4;
    const double t5 = 2.0*x[11]; /* 2*alpha3 */
    out[28] = t5;
    const double t6 = 2.0*x[12]; /* 2*beta1 */
    out[46] = t6;
    const double t7 = 2.0*x[13]; /* 2*beta2 */
    out[47] = t7;
    const double t8 = 2.0*x[14]; /* 2*beta3 */
    out[48] = t8;
    const double t9 = JLT_FNMA(p[3], x[7], x[3]); /* v1 - a3*omega2 */
    out[102] = t9;
    const double t10 = JLT_FMA(p[3], x[6], x[4]); /* a3*omega1 + v2 */
    out[103] = t10;
    const double t11 = x[1]*p[3]; /* gamma2*a3 */
    out[108] = t11;
    const double t12 = x[0]*p[35]; /* gamma1*(-a3) */
    out[109] = t12;
    const double t13 = -x[1]; /* -gamma2 */
    out[122] = t13;
    const double t14 = x[6]*p[33]; /* omega1*(-R*I1) */
    out[136] = t14;
    const double t15 = x[7]*p[33]; /* omega2*(-R*I1) */
    out[137] = t15;
    const double t16 = x[8]*p[38]; /* omega3*(-R*I3) */
    out[138] = t16;
    const double t17 = x[0]*p[33]; /* gamma1*(-R*I1) */
    out[142] = t17;
    const double t18 = x[1]*p[33]; /* gamma2*(-R*I1) */
    out[143] = t18;
    const double t19 = x[2] + p[36]; /* gamma3 + a3/R */
    const double t20 = p[38]*t19; /* (-R*I3)*(gamma3 + a3/R) */
    out[144] = t20;
    const double t21 = p[1]*t19; /* b = R*(gamma3 + a3/R) */
    const double t22 = x[0]*t21; /* gamma1*b */
    out[125] = t22;
    const double t23 = x[1]*t21; /* gamma2*b */
    out[126] = t23;
    const double t24 = p[12]*x[8]; /* 2*R*omega3 */
    const double t25 = x[0]*x[6]; /* gamma1*omega1 */
    const double t26 = JLT_FMA(x[1], x[7], t25); /* q = gamma2*omega2 + gamma1*omega1 */
    const double t27 = p[1]*t26; /* R*q */
    out[121] = t27;
    const double t28 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t29 = JLT_FMA(x[1], x[1], t28); /* gamma2*gamma2 + gamma1*gamma1 */
    const double t30 = p[37]*t29; /* (-R)*(gamma2*gamma2 + gamma1*gamma1) */
    out[127] = t30;
    const double t31 = JLT_FNMA(x[0], t24, x[4]); /* v2 - gamma1*2*R*omega3 */
    const double t32 = JLT_FMA(x[6], t21, t31); /* omega1*b + v2 - gamma1*2*R*omega3 */
    out[119] = t32;
    const double t33 = JLT_FMA(x[1], t24, x[3]); /* gamma2*2*R*omega3 + v1 */
    const double t34 = JLT_FMS(x[7], t21, t33); /* omega2*b - (gamma2*2*R*omega3 + v1) */
    out[120] = t34;
}

static void observe_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[2] = x[11];
    const double t0 = JLT_FNMA(p[3], x[11], x[15]); /* x_contact = x - a3*alpha3 */
    out[0] = t0;
    out[3] = x[14];
    const double t1 = JLT_FNMA(p[3], x[14], x[16]); /* y_contact = y - a3*beta3 */
    out[1] = t1;
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
    double x10[JLT_JET_ORDER_MAX + 1];
    double x11[JLT_JET_ORDER_MAX + 1];
    double x12[JLT_JET_ORDER_MAX + 1];
    double x13[JLT_JET_ORDER_MAX + 1];
    double x14[JLT_JET_ORDER_MAX + 1];
    double x15[JLT_JET_ORDER_MAX + 1];
    double x16[JLT_JET_ORDER_MAX + 1];
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
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
    double t68[JLT_JET_ORDER_MAX + 1];
    double t69[JLT_JET_ORDER_MAX + 1];
    double t70[JLT_JET_ORDER_MAX + 1];
    double t71[JLT_JET_ORDER_MAX + 1];
    double t72[JLT_JET_ORDER_MAX + 1];
    double t73[JLT_JET_ORDER_MAX + 1];
    double t74[JLT_JET_ORDER_MAX + 1];
    double t75[JLT_JET_ORDER_MAX + 1];
    double t76[JLT_JET_ORDER_MAX + 1];
    double t77[JLT_JET_ORDER_MAX + 1];
    double t78[JLT_JET_ORDER_MAX + 1];
    double t79[JLT_JET_ORDER_MAX + 1];
    double t80[JLT_JET_ORDER_MAX + 1];
    double t81[JLT_JET_ORDER_MAX + 1];
    double t82[JLT_JET_ORDER_MAX + 1];
    double t83[JLT_JET_ORDER_MAX + 1];
    double t84[JLT_JET_ORDER_MAX + 1];
    double t85[JLT_JET_ORDER_MAX + 1];
    double t86[JLT_JET_ORDER_MAX + 1];
    double t87[JLT_JET_ORDER_MAX + 1];
    double t88[JLT_JET_ORDER_MAX + 1];
    double t89[JLT_JET_ORDER_MAX + 1];
    double t90[JLT_JET_ORDER_MAX + 1];
    double t91[JLT_JET_ORDER_MAX + 1];
    double t92[JLT_JET_ORDER_MAX + 1];
    double t93[JLT_JET_ORDER_MAX + 1];
    double t94[JLT_JET_ORDER_MAX + 1];
    double t95[JLT_JET_ORDER_MAX + 1];
    double t96[JLT_JET_ORDER_MAX + 1];
    double t97[JLT_JET_ORDER_MAX + 1];
    double t98[JLT_JET_ORDER_MAX + 1];
    double t99[JLT_JET_ORDER_MAX + 1];
    double t100[JLT_JET_ORDER_MAX + 1];
    double t101[JLT_JET_ORDER_MAX + 1];
    double t102[JLT_JET_ORDER_MAX + 1];
    double t103[JLT_JET_ORDER_MAX + 1];
    double t104[JLT_JET_ORDER_MAX + 1];
    double t105[JLT_JET_ORDER_MAX + 1];
    double t106[JLT_JET_ORDER_MAX + 1];
    double t107[JLT_JET_ORDER_MAX + 1];
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
    coefficients[10] = x10[0] = x[10];
    coefficients[11] = x11[0] = x[11];
    coefficients[12] = x12[0] = x[12];
    coefficients[13] = x13[0] = x[13];
    coefficients[14] = x14[0] = x[14];
    coefficients[15] = x15[0] = x[15];
    coefficients[16] = x16[0] = x[16];
    for (unsigned k = 0; k < order; k++) {
        t29[k] = jlt_jet_product(x6, x0, k);
        t30[k] = jlt_jet_product(x1, x7, k) + t29[k];
        t31[k] = x2[k]*p[1] + (k == 0 ? p[3] : 0);
        t32[k] = x2[k]*p[12];
        t33[k] = t32[k] - p[8]*t31[k];
        t34[k] = jlt_jet_product(x8, t33, k);
        t35[k] = p[1]*t30[k] + t34[k];
        t36[k] = jlt_jet_product(x0, x0, k);
        t37[k] = jlt_jet_product(x1, x1, k) + t36[k];
        t38[k] = jlt_jet_product(x6, x3, k);
        t39[k] = jlt_jet_product(x7, x4, k) + t38[k];
        t40[k] = jlt_jet_product(x1, x6, k);
        t41[k] = jlt_jet_product(x7, x0, k);
        t42[k] = t41[k] - t40[k];
        t43[k] = t40[k] - t41[k];
        t44[k] = jlt_jet_product(x5, t30, k);
        t45[k] = t44[k] - jlt_jet_product(x2, t39, k);
        t46[k] = t45[k] - jlt_jet_product(t35, t43, k);
        t47[k] = jlt_jet_product(x6, x6, k);
        t48[k] = jlt_jet_product(x7, x7, k) + t47[k];
        t49[k] = jlt_jet_product(x2, t48, k);
        t50[k] = p[11]*t37[k] + (k == 0 ? p[10] : 0);
        t51[k] = jlt_jet_product(t31, t31, k) + t50[k];
        t52[k] = jlt_jet_quotient(t46[k], t51, t52, k);
        t53[k] = p[15]*t52[k];
        t54[k] = jlt_jet_quotient(t52[k], t37, t54, k);
        t55[k] = jlt_jet_product(x2, x2, k) + t37[k];
        t56[k] = x8[k]*p[8];
        t57[k] = t49[k] - jlt_jet_product(t30, t56, k);
        t58[k] = p[4]*t55[k];
        t59[k] = p[9]*t37[k] + t58[k];
        t60[k] = p[6]*t55[k];
        t61[k] = t60[k] - p[7]*t57[k];
        t62[k] = jlt_jet_quotient(t61[k], t59, t62, k);
        t63[k] = x8[k]*p[13];
        t64[k] = jlt_jet_product(x8, x4, k);
        t65[k] = t64[k] - jlt_jet_product(x7, x5, k);
        t66[k] = jlt_jet_product(x6, x5, k);
        t67[k] = t66[k] - jlt_jet_product(x8, x3, k);
        t68[k] = p[14]*t62[k];
        t69[k] = (k == 0 ? p[2] : 0) - t62[k];
        t70[k] = t65[k] - jlt_jet_product(x0, t69, k);
        t71[k] = t67[k] - jlt_jet_product(x1, t69, k);
        t72[k] = jlt_jet_product(x6, t63, k);
        t73[k] = jlt_jet_product(x7, t63, k);
        t74[k] = jlt_jet_product(x0, t68, k) + t72[k];
        t75[k] = jlt_jet_product(x1, t68, k) + t73[k];
        t76[k] = jlt_jet_product(x1, t54, k);
        t77[k] = p[10]*t76[k] + t70[k];
        t78[k] = jlt_jet_product(t31, t76, k) + t74[k];
        t79[k] = -t78[k];
        t80[k] = jlt_jet_product(x0, t54, k);
        t81[k] = t75[k] - jlt_jet_product(t31, t80, k);
        t82[k] = t71[k] - p[10]*t80[k];
        t83[k] = jlt_jet_product(x7, x3, k);
        t84[k] = t83[k] - jlt_jet_product(x6, x4, k);
        t85[k] = t84[k] - jlt_jet_product(x2, t69, k);
        t86[k] = jlt_jet_product(x3, x9, k);
        t87[k] = jlt_jet_product(x4, x10, k) + t86[k];
        t88[k] = jlt_jet_product(x5, x11, k) + t87[k];
        t89[k] = jlt_jet_product(x3, x12, k);
        t90[k] = jlt_jet_product(x4, x13, k) + t89[k];
        t91[k] = jlt_jet_product(x5, x14, k) + t90[k];
        t92[k] = jlt_jet_product(x1, x8, k);
        t93[k] = t92[k] - jlt_jet_product(x2, x7, k);
        t94[k] = jlt_jet_product(x2, x6, k);
        t95[k] = t94[k] - jlt_jet_product(x8, x0, k);
        t96[k] = jlt_jet_product(x8, x10, k);
        t97[k] = t96[k] - jlt_jet_product(x7, x11, k);
        t98[k] = jlt_jet_product(x6, x11, k);
        t99[k] = t98[k] - jlt_jet_product(x8, x9, k);
        t100[k] = jlt_jet_product(x7, x9, k);
        t101[k] = t100[k] - jlt_jet_product(x6, x10, k);
        t102[k] = jlt_jet_product(x8, x13, k);
        t103[k] = t102[k] - jlt_jet_product(x7, x14, k);
        t104[k] = jlt_jet_product(x6, x14, k);
        t105[k] = t104[k] - jlt_jet_product(x8, x12, k);
        t106[k] = jlt_jet_product(x7, x12, k);
        t107[k] = t106[k] - jlt_jet_product(x6, x13, k);
        double *restrict next = coefficients + (k + 1)*17;
        next[0] = x0[k + 1] = t93[k]/(k + 1);
        next[1] = x1[k + 1] = t95[k]/(k + 1);
        next[2] = x2[k + 1] = t42[k]/(k + 1);
        next[3] = x3[k + 1] = t77[k]/(k + 1);
        next[4] = x4[k + 1] = t82[k]/(k + 1);
        next[5] = x5[k + 1] = t85[k]/(k + 1);
        next[6] = x6[k + 1] = t81[k]/(k + 1);
        next[7] = x7[k + 1] = t79[k]/(k + 1);
        next[8] = x8[k + 1] = t53[k]/(k + 1);
        next[9] = x9[k + 1] = t97[k]/(k + 1);
        next[10] = x10[k + 1] = t99[k]/(k + 1);
        next[11] = x11[k + 1] = t101[k]/(k + 1);
        next[12] = x12[k + 1] = t103[k]/(k + 1);
        next[13] = x13[k + 1] = t105[k]/(k + 1);
        next[14] = x14[k + 1] = t107[k]/(k + 1);
        next[15] = x15[k + 1] = t88[k]/(k + 1);
        next[16] = x16[k + 1] = t91[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_gamma2 = x[1];
    const double complex v_omega3 = x[8];
    const double complex v_gamma3 = x[2];
    const double complex v_omega2 = x[7];
    out[0] = (v_gamma2*v_omega3)
        + (-v_gamma3*v_omega2);
    const double complex v_omega1 = x[6];
    const double complex v_gamma1 = x[0];
    out[1] = (v_gamma3*v_omega1)
        + (-v_gamma1*v_omega3);
    out[2] = (v_gamma1*v_omega2)
        + (-v_gamma2*v_omega1);
    const double complex v_v2 = x[4];
    const double complex v_v3 = x[5];
    const double v_g = params[2];
    const double v_I1 = params[4];
    const double complex v_one = (v_gamma1*v_gamma1 + v_gamma2*v_gamma2 + v_gamma3*v_gamma3);
    const double v_m = params[0];
    const double v_a3 = params[3];
    const double complex v_s = csqrt(v_gamma1*v_gamma1 + v_gamma2*v_gamma2);
    const double complex v_D = (v_I1*v_one + v_m*v_a3*v_a3*v_s*v_s);
    const double v_I3 = params[5];
    const double complex v_q = (v_gamma1*v_omega1 + v_gamma2*v_omega2);
    const double complex v_N_m = ((v_g*v_I1*v_one - v_a3*(v_I1*v_gamma3*(v_omega1*v_omega1 + v_omega2*v_omega2) - v_I3*v_omega3*v_q))/v_D);
    const double v_R = params[1];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*v_I1*v_s*v_s + v_m*v_I3*v_b*v_b);
    const double complex v_v1 = x[3];
    const double complex v_dgamma3 = (v_gamma1*v_omega2 - v_gamma2*v_omega1);
    const double complex v_gyroscopic = (v_v3*v_q - v_gamma3*(v_v1*v_omega1 + v_v2*v_omega2) + v_R*v_dgamma3*v_q + v_omega3*v_dgamma3*(2.0*v_R*v_gamma3 - v_I3*v_b/v_I1));
    const double complex v_L_ms = (-v_I1*v_I3*v_gyroscopic/(v_s*v_s*v_Theta));
    out[3] = (v_v2*v_omega3)
        + (-v_v3*v_omega2)
        + (-v_g*v_gamma1)
        + (v_gamma1*v_N_m)
        + (-v_gamma2*v_L_ms);
    out[4] = (v_v3*v_omega1)
        + (-v_v1*v_omega3)
        + (-v_g*v_gamma2)
        + (v_gamma2*v_N_m)
        + (v_gamma1*v_L_ms);
    out[5] = (v_v1*v_omega2)
        + (-v_v2*v_omega1)
        + (-v_g*v_gamma3)
        + (v_gamma3*v_N_m);
    out[6] = (v_omega2*v_omega3*(v_I1 - v_I3)/v_I1)
        + (v_m*v_a3*v_gamma2*v_N_m/v_I1)
        + (v_m*v_gamma1*v_b*v_L_ms/v_I1);
    out[7] = (-v_omega1*v_omega3*(v_I1 - v_I3)/v_I1)
        + (-v_m*v_a3*v_gamma1*v_N_m/v_I1)
        + (v_m*v_gamma2*v_b*v_L_ms/v_I1);
    out[8] = (-v_m*v_R*v_s*v_s*v_L_ms/v_I3);
    const double complex v_alpha2 = x[10];
    const double complex v_alpha3 = x[11];
    out[9] = (v_omega3*v_alpha2)
        + (-v_omega2*v_alpha3);
    const double complex v_alpha1 = x[9];
    out[10] = (v_omega1*v_alpha3)
        + (-v_omega3*v_alpha1);
    out[11] = (v_omega2*v_alpha1)
        + (-v_omega1*v_alpha2);
    const double complex v_beta2 = x[13];
    const double complex v_beta3 = x[14];
    out[12] = (v_omega3*v_beta2)
        + (-v_omega2*v_beta3);
    const double complex v_beta1 = x[12];
    out[13] = (v_omega1*v_beta3)
        + (-v_omega3*v_beta1);
    out[14] = (v_omega2*v_beta1)
        + (-v_omega1*v_beta2);
    out[15] = (v_v1*v_alpha1)
        + (v_v2*v_alpha2)
        + (v_v3*v_alpha3);
    out[16] = (v_v1*v_beta1)
        + (v_v2*v_beta2)
        + (v_v3*v_beta3);
}

static void tier_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t1 = (-1.0 / 68719476736.0) + t0; /* -1/68719476736 + gamma1*gamma1 */
    const double t2 = x[1]*x[1]; /* gamma2*gamma2 */
    const double t3 = t1 + t2; /* -1/68719476736 + gamma1*gamma1 + gamma2*gamma2 */
    out[0] = t3;
}

static const jlt_way_condition tier_conditions[] = {
    { "gamma1^2 + gamma2^2 - 1/2^36 > 0", 0 },
};

static void divisor_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* gamma1*gamma1 */
    const double t1 = x[1]*x[1]; /* gamma2*gamma2 */
    const double t2 = t0 + t1; /* gamma1*gamma1 + gamma2*gamma2 */
    out[2] = t2;
    const double t3 = x[2]*x[2]; /* gamma3*gamma3 */
    const double t4 = t2 + t3; /* one = gamma1*gamma1 + gamma2*gamma2 + gamma3*gamma3 */
    const double t5 = params[4]*t4; /* I1*one */
    const double t6 = params[3]*params[3]; /* a3*a3 */
    const double t7 = params[0]*t6; /* m*a3*a3 */
    const double t8 = sqrt(t2); /* s = sqrt(gamma1*gamma1 + gamma2*gamma2) */
    const double t9 = t8*t8; /* s*s */
    const double t10 = t7*t9; /* m*a3*a3*s*s */
    const double t11 = t5 + t10; /* D = I1*one + m*a3*a3*s*s */
    out[0] = t11;
    const double t12 = t11*t11; /* D*D */
    out[1] = t12;
    const double t13 = t2*t2; /* (gamma1*gamma1 + gamma2*gamma2)*(gamma1*gamma1 + gamma2*gamma2) */
    out[3] = t13;
}

static const jlt_region divisors[] = {
    { "a division", "D != 0", 0 },
    { "a division", "gamma1^2 + gamma2^2 != 0", 0 },
};

static const jlt_quantity states[] = {
    { "gamma1", "1", "vertical unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "gamma2", "1", "vertical unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "gamma3", "1", "vertical unit vector in the body frame: cosine of the tilt", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "v1", "m/s", "velocity of the centre of mass", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "v2", "m/s", "velocity of the centre of mass", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "v3", "m/s", "velocity of the centre of mass", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega1", "rad/s", "angular velocity", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega2", "rad/s", "angular velocity", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "alpha1", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "alpha2", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "alpha3", "1", "first horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "beta1", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "beta2", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "beta3", "1", "second horizontal unit vector in the body frame", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "x", "m", "horizontal coordinate of the centre of mass along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y", "m", "horizontal coordinate of the centre of mass along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0), 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0), 0.0 },
};

static const jlt_named integrals[] = {
    { "gamma_norm", "" },
    { "alpha_norm", "" },
    { "beta_norm", "" },
    { "alpha_gamma", "" },
    { "beta_gamma", "" },
    { "alpha_beta", "" },
    { "f1", "" },
    { "f2", "" },
    { "G", "" },
};

static const jlt_quantity observes[] = {
    { "x_contact", "m", "contact point, along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y_contact", "m", "contact point, along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "x_axis", "1", "symmetry axis, along alpha", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y_axis", "1", "symmetry axis, along beta", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

const jlt_descriptor jlt_kernels_spherical_top_full_general = {
    .model = "spherical_top_full",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Spherical top on a plane with one nonholonomic constraint, full system with multipliers",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (2.5)-(2.7)",
    .sha256 = "5de9745ff1945082f709f85b1765ec2e95addd9d5431b2def563648618d9e642",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_full, .family = jlt_family_spherical_top_full, .claims = jlt_claims_spherical_top_full,
    .scales = 1,
    .state_count = 17, .param_count = 6, .prepared_count = 39,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 17, { 4, 42, 39, 1, 0, 0, 13, 13 }, { 60, 153, 0, 13, 1, 0, 10, 15 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; digits are lost where terms nearly cancel in d(gamma1)/dt, d(gamma2)/dt, gamma2*omega1 - omega2*gamma1, d(gamma3)/dt, q = gamma2*omega2 + omega1*gamma1, gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*(I3/I1), a part of d(v1)/dt and of d(v2)/dt and of d(v3)/dt and of d(omega1)/dt and of d(omega2)/dt, b = gamma3*R + a3, a part of d(v1)/dt and of d(v2)/dt and of d(v3)/dt, gamma3*(2*R) - (I3/I1)*b, q*R + omega3*(gamma3*(2*R) - (I3/I1)*b), omega2*v2 + omega1*v1, gyroscopic, d(v1)/dt, d(v2)/dt, d(v3)/dt, d(omega1)/dt, a part of d(omega2)/dt, d(alpha1)/dt, d(alpha2)/dt, d(alpha3)/dt, d(beta1)/dt, d(beta2)/dt, d(beta3)/dt, d(x)/dt, d(y)/dt" },
    .jacobian = { jacobian, 289, { 28, 97, 84, 1, 0, 0, 16, 38 }, { 257, 1113, 0, 139, 1, 0, 15, 23 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; digits are lost where terms nearly cancel in 2*R - R*I3/I1, b = gamma3*R + a3, q = omega2*gamma2 + omega1*gamma1, gamma3*(2*R) - (I3/I1)*b, omega1*v1 + omega2*v2, gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*(I3/I1), a part of d(d(v1)/dt)/d(gamma1) and of d(d(v1)/dt)/d(gamma2) and of d(d(v1)/dt)/d(gamma3) and of d(d(v2)/dt)/d(gamma1) and of d(d(v2)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma3) and of d(d(v3)/dt)/d(gamma1) and of d(d(v3)/dt)/d(gamma2) and of d(d(v3)/dt)/d(gamma3) and of d(d(omega1)/dt)/d(gamma1) and of d(d(omega1)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma1) and of d(d(omega2)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma3), dgamma3 = omega2*gamma1 - gamma2*omega1, R*q + omega3*(gamma3*(2*R) - (I3/I1)*b), gyroscopic, a part of d(d(v1)/dt)/d(gamma3) and of d(d(v2)/dt)/d(gamma3) and of d(d(v3)/dt)/d(gamma3) and of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma3), a part of d(d(v1)/dt)/d(gamma1) and of d(d(v1)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma1) and of d(d(v2)/dt)/d(gamma2) and of d(d(v3)/dt)/d(gamma1) and of d(d(v3)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma1) and of d(d(omega1)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma1) and of d(d(omega2)/dt)/d(gamma2), a part of d(d(v1)/dt)/d(gamma1) and of d(d(v2)/dt)/d(gamma1) and of d(d(v3)/dt)/d(gamma1) and of d(d(omega1)/dt)/d(gamma1) and of d(d(omega2)/dt)/d(gamma1), a part of d(d(v1)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma2) and of d(d(v3)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma2), R*dgamma3 + v3, d(gyroscopic)/d(gamma3) = dgamma3*omega3*(2*R - R*I3/I1) - (omega1*v1 + omega2*v2), d(gyroscopic)/d(omega1), omega2*gamma3 - gamma2*omega3*(1/2*I3/I1), gamma3*omega1 - gamma1*omega3*(1/2*I3/I1), d(gyroscopic)/d(omega2), a part of d(d(v1)/dt)/d(gamma1) and of d(d(omega2)/dt)/d(gamma1), d(gyroscopic)/d(gamma1), d(gyroscopic)/d(gamma2), a part of d(d(omega1)/dt)/d(gamma1), d(gyroscopic)/d(gamma3) - (2*R)*b*1/(Theta/(m*I3))*gyroscopic, d(d(v3)/dt)/d(omega2), d(d(v1)/dt)/d(gamma3), a part of d(d(omega2)/dt)/d(gamma3), d(d(v1)/dt)/d(v2), d(d(v1)/dt)/d(v3), a part of d(d(omega2)/dt)/d(omega3), d(d(v1)/dt)/d(gamma1), a part of d(d(v2)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma2), d(d(v3)/dt)/d(gamma3), gamma3*1/D*(2*a3*I1)*(gamma3*omega1 - gamma1*omega3*(1/2*I3/I1)) + v2, d(d(v2)/dt)/d(gamma3), d(d(omega1)/dt)/d(gamma3), d(d(v2)/dt)/d(v1), d(d(v2)/dt)/d(v3), d(d(v2)/dt)/d(gamma1), d(d(omega1)/dt)/d(gamma1), d(d(v1)/dt)/d(omega2), a part of d(d(v2)/dt)/d(omega2), a part of d(d(omega1)/dt)/d(omega1), d(d(omega1)/dt)/d(omega2), d(d(omega1)/dt)/d(omega3), a part of d(d(v1)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma2), d(d(v1)/dt)/d(gamma2), d(d(omega2)/dt)/d(gamma2), d(d(omega2)/dt)/d(gamma1), d(d(omega2)/dt)/d(omega1), d(d(omega2)/dt)/d(omega2), d(d(omega3)/dt)/d(gamma1), d(d(omega3)/dt)/d(gamma2), d(d(v1)/dt)/d(omega1), d(d(v1)/dt)/d(omega3), d(d(v2)/dt)/d(omega1), d(d(v2)/dt)/d(omega3), d(d(v2)/dt)/d(gamma2), d(d(omega1)/dt)/d(gamma2)" },
    .rhs_jacobian = { rhs_jacobian, 306, { 31, 114, 110, 1, 0, 0, 16, 41 }, { 303, 1231, 0, 151, 1, 0, 15, 23 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; digits are lost where terms nearly cancel in d(gamma1)/dt, d(gamma2)/dt, gamma2*omega1 - omega2*gamma1, d(gamma3)/dt, q = gamma2*omega2 + omega1*gamma1, gamma3*(omega2*omega2 + omega1*omega1) - q*omega3*(I3/I1), a part of d(v1)/dt and of d(v2)/dt and of d(v3)/dt and of d(omega1)/dt and of d(omega2)/dt and of d(d(v1)/dt)/d(gamma1) and of d(d(v1)/dt)/d(gamma2) and of d(d(v1)/dt)/d(gamma3) and of d(d(v2)/dt)/d(gamma1) and of d(d(v2)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma3) and of d(d(v3)/dt)/d(gamma1) and of d(d(v3)/dt)/d(gamma2) and of d(d(v3)/dt)/d(gamma3) and of d(d(omega1)/dt)/d(gamma1) and of d(d(omega1)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma1) and of d(d(omega2)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma3), b = gamma3*R + a3, a part of d(v1)/dt and of d(v2)/dt and of d(v3)/dt and of d(d(v1)/dt)/d(gamma1) and of d(d(v1)/dt)/d(gamma3) and of d(d(v2)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma3) and of d(d(v3)/dt)/d(gamma3) and of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma3), omega1*v1 + omega2*v2, gamma3*(2*R) - (I3/I1)*b, q*R + omega3*(gamma3*(2*R) - (I3/I1)*b), gyroscopic, d(v1)/dt, d(v2)/dt, d(v3)/dt, d(omega1)/dt, a part of d(omega2)/dt, d(alpha1)/dt, d(alpha2)/dt, d(alpha3)/dt, d(beta1)/dt, d(beta2)/dt, d(beta3)/dt, d(x)/dt, d(y)/dt, a part of d(d(v1)/dt)/d(gamma1) and of d(d(v1)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma1) and of d(d(v2)/dt)/d(gamma2) and of d(d(v3)/dt)/d(gamma1) and of d(d(v3)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma1) and of d(d(omega1)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma1) and of d(d(omega2)/dt)/d(gamma2), a part of d(d(v1)/dt)/d(gamma1) and of d(d(v2)/dt)/d(gamma1) and of d(d(v3)/dt)/d(gamma1) and of d(d(omega1)/dt)/d(gamma1) and of d(d(omega2)/dt)/d(gamma1), v3 - (gamma2*omega1 - omega2*gamma1)*R, d(gyroscopic)/d(gamma1), d(d(v1)/dt)/d(gamma1), a part of d(d(v1)/dt)/d(gamma2) and of d(d(v2)/dt)/d(gamma2) and of d(d(v3)/dt)/d(gamma2) and of d(d(omega1)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma2), d(gyroscopic)/d(gamma2), d(d(v1)/dt)/d(gamma2), a part of d(d(v1)/dt)/d(gamma3) and of d(d(v2)/dt)/d(gamma3) and of d(d(v3)/dt)/d(gamma3) and of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma3), 2*R - R*I3/I1, a part of d(d(v1)/dt)/d(gamma3) and of d(d(v2)/dt)/d(gamma3) and of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), d(d(v1)/dt)/d(gamma3), d(d(v1)/dt)/d(v2), d(d(v1)/dt)/d(v3), gamma3*omega1 - gamma1*omega3*(1/2*I3/I1), d(gyroscopic)/d(omega1), d(d(v1)/dt)/d(omega1), gamma3*omega2 - gamma2*omega3*(1/2*I3/I1), d(gyroscopic)/d(omega2), d(d(v1)/dt)/d(omega2), d(d(v1)/dt)/d(omega3), d(d(v2)/dt)/d(gamma1), d(d(v2)/dt)/d(gamma2), d(d(v2)/dt)/d(gamma3), d(d(v2)/dt)/d(v1), d(d(v2)/dt)/d(v3), d(d(v2)/dt)/d(omega1), a part of d(d(v2)/dt)/d(omega2), d(d(v2)/dt)/d(omega3), d(d(v3)/dt)/d(gamma3), (2*a3*I1)*(gamma3*omega1 - gamma1*omega3*(1/2*I3/I1))*gamma3*1/D + v2, d(d(v3)/dt)/d(omega2), a part of d(d(omega1)/dt)/d(gamma1), d(d(omega1)/dt)/d(gamma1), a part of d(d(omega1)/dt)/d(gamma2) and of d(d(omega2)/dt)/d(gamma2), d(d(omega1)/dt)/d(gamma2), a part of d(d(omega1)/dt)/d(gamma3) and of d(d(omega2)/dt)/d(gamma3) and of d(d(omega3)/dt)/d(gamma3), d(d(omega1)/dt)/d(gamma3), a part of d(d(omega1)/dt)/d(omega1), d(d(omega1)/dt)/d(omega2), d(d(omega1)/dt)/d(omega3), d(d(omega2)/dt)/d(gamma1), d(d(omega2)/dt)/d(gamma2), d(d(omega2)/dt)/d(gamma3), d(d(omega2)/dt)/d(omega1), d(d(omega2)/dt)/d(omega2), d(d(omega2)/dt)/d(omega3), d(d(omega3)/dt)/d(gamma1), d(d(omega3)/dt)/d(gamma2)" },
    .divergence = { divergence, 1, { 1, 21, 22, 1, 0, 0, 13, 9 }, { 28, 97, 0, 10, 1, 0, 15, 14 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by D, small only where all of I1*one and m*a3^2*s^2 are; digits are lost where terms nearly cancel in gamma2*omega1 - gamma1*omega2, b = gamma3*R + a3, gamma3*(2*R) - (I3/I1)*b, a part of the divergence, v3 - R*(gamma2*omega1 - gamma1*omega2), q = gamma2*omega2 + gamma1*omega1, R*q + omega3*(gamma3*(2*R) - (I3/I1)*b), d(gyroscopic)/d(omega2), d(gyroscopic)/d(omega1), gamma1*d(gyroscopic)/d(omega1) + gamma2*d(gyroscopic)/d(omega2), a part of the divergence, gamma3*omega1 - gamma1*omega3*(1/2*I3/I1), gamma3*omega2 - gamma2*omega3*(1/2*I3/I1), a part of the divergence, a part of the divergence" },
    .integral_values = { integral_values, 9, { 1, 11, 25, 0, 0, 0, 5, 6 }, { 28, 41, 0, 0, 1, 0, 7, 6 },
        "digits are lost where terms nearly cancel in gamma_norm, alpha_norm, beta_norm, alpha_gamma, beta_gamma, alpha_beta, dgamma3 = gamma1*omega2 - gamma2*omega1, f1, b = gamma3*R + a3, q = gamma2*omega2 + gamma1*omega1, f2, omega3*gamma3*(I3/I1) + q, G" },
    .integral_gradients = { integral_gradients, 153, { 2, 25, 8, 0, 0, 0, 3, 4 }, { 19, 44, 0, 0, 1, 0, 6, 4 },
        "digits are lost where terms nearly cancel in d(f1)/d(gamma1), d(f1)/d(gamma2), gamma3 + a3/R, q = gamma2*omega2 + gamma1*omega1, d(f2)/d(gamma1), d(f2)/d(gamma2)" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { observe_values, 4, { 0, 0, 2, 0, 0, 0, 1, 1 }, { 2, 2, 0, 0, 0, 0, 2, 2 },
        "digits are lost where terms nearly cancel in x_contact, y_contact" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .observe_count = 4, .observes = observes,
    .divisor_count = 2, .divisors = divisors, .divisor_values = divisor_values,
    .tier = "full", .tier_meaning = "the full system (2.7) with (2.1): every vector by its components",
    .tier_condition_count = 1, .tier_conditions = tier_conditions,
    .tier_values = tier_values,
    .integral_count = 9, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_full_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_full_general) },
#endif
};
