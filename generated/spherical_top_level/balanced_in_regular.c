/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Variant:    balanced: a3 = 0
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   22    7    1    0    0     12    7   (93)
 *  jacobian            8   55   30    1    0    0     13   20   (644)
 *  rhs_jacobian        13   60   26    1    0    0     14   22   (723)
 *  divergence          3    8    4    1    0    0     10    4   (41)
 *  integral_values     1   12    7    1    0    0      7    5   (47)
 *  integral_gradients  0   25    9    1    0    0     11    5   (195)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_balanced_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_balanced_in_regular_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
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

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[1]*params[6]; /* R*G */
    out[7] = t0;
    const double t1 = params[1]*params[4]; /* R*I3 */
    out[8] = t1;
    const double t2 = params[1]*params[1]; /* R*R */
    const double t3 = t2*params[3]; /* R*R*I1 */
    out[9] = t3;
    const double t4 = params[4]*t2; /* I3*R*R */
    out[10] = t4;
    const double t5 = params[4]*params[3]; /* I3*I1 */
    out[41] = t5;
    const double t6 = t5/params[0]; /* I3*I1/m */
    out[11] = t6;
    const double t7 = params[6]/params[3]; /* G/I1 */
    out[12] = t7;
    const double t8 = params[4]*t3; /* I3*R*R*I1 */
    const double t9 = params[3] - params[4]; /* I1 - I3 */
    const double t10 = t8*t9; /* I3*R*R*I1*(I1 - I3) */
    const double t11 = t10/params[0]; /* I3*R*R*I1*(I1 - I3)/m */
    out[13] = t11;
    const double t12 = t2*2.0; /* R*R*2 */
    const double t13 = params[4]*t12; /* I3*R*R*2 */
    out[14] = t13;
    const double t14 = params[3]*t12; /* I1*R*R*2 */
    out[15] = t14;
    const double t15 = t2*4.0; /* R*R*4 */
    const double t16 = params[4]*t15; /* I3*R*R*4 */
    out[16] = t16;
    const double t17 = params[1]*2.0; /* R*2 */
    const double t18 = params[4]*t17; /* I3*R*2 */
    out[17] = t18;
    const double t19 = params[6]*t1; /* G*R*I3 */
    const double t20 = t19/params[3]; /* G*R*I3/I1 */
    out[18] = t20;
    const double t21 = params[1]*(-2.0); /* R*(-2) */
    const double t22 = params[4]*t21; /* I3*R*(-2) */
    out[19] = t22;
    const double t23 = params[4]*params[4]; /* I3*I3 */
    const double t24 = t2*t23; /* R*R*I3*I3 */
    const double t25 = -t24; /* -R*R*I3*I3 */
    out[20] = t25;
    const double t26 = -t1; /* -R*I3 */
    out[21] = t26;
    const double t27 = params[3]*t15; /* I1*R*R*4 */
    out[22] = t27;
    const double t28 = params[3]*t17; /* I1*R*2 */
    const double t29 = params[6]/t28; /* G/(I1*R*2) */
    out[23] = t29;
    const double t30 = params[1]*t2; /* R*R*R */
    const double t31 = 4.0*t30; /* 4*R*R*R */
    const double t32 = params[3]*t31; /* I1*4*R*R*R */
    const double t33 = params[4]*t32; /* I3*I1*4*R*R*R */
    out[24] = t33;
    const double t34 = t14*t23; /* I1*R*R*2*I3*I3 */
    const double t35 = t34/params[0]; /* I1*R*R*2*I3*I3/m */
    out[25] = t35;
    const double t36 = t2*t9; /* R*R*(I1 - I3) */
    out[26] = t36;
    const double t37 = params[1]*params[3]; /* R*I1 */
    const double t38 = params[4]*t37; /* I3*R*I1 */
    const double t39 = t38/params[0]; /* I3*R*I1/m */
    out[27] = t39;
    const double t40 = params[3]*params[3]; /* I1*I1 */
    const double t41 = t12*t40; /* R*R*2*I1*I1 */
    const double t42 = params[4]*t41; /* I3*R*R*2*I1*I1 */
    const double t43 = t42/params[0]; /* I3*R*R*2*I1*I1/m */
    out[28] = t43;
    const double t44 = t23*t31; /* I3*I3*4*R*R*R */
    out[29] = t44;
    const double t45 = params[6]*t4; /* G*I3*R*R */
    const double t46 = t9*t45; /* (I1 - I3)*G*I3*R*R */
    const double t47 = t46/params[0]; /* (I1 - I3)*G*I3*R*R/m */
    out[30] = t47;
    const double t48 = t9*t37; /* (I1 - I3)*R*I1 */
    const double t49 = t48/params[0]; /* (I1 - I3)*R*I1/m */
    out[31] = t49;
    const double t50 = params[0]/2.0; /* m/2 */
    out[32] = t50;
    const double t51 = params[4]/params[3]; /* I3/I1 */
    out[33] = t51;
    const double t52 = t2*params[0]; /* R*R*m */
    const double t53 = params[3]*t52; /* I1*R*R*m */
    out[43] = t53;
    const double t54 = params[6]*params[6]; /* G*G */
    const double t55 = t54/t53; /* G*G/(I1*R*R*m) */
    out[34] = t55;
    const double t56 = params[4]/t52; /* I3/(R*R*m) */
    out[35] = t56;
    const double t57 = params[3]/2.0; /* I1/2 */
    out[36] = t57;
    const double t58 = params[0]*t40; /* m*I1*I1 */
    out[37] = t58;
    const double t59 = params[3]*params[0]; /* I1*m */
    const double t60 = t9*t59; /* (I1 - I3)*I1*m */
    out[38] = t60;
    const double t61 = params[4]*t52; /* I3*R*R*m */
    out[39] = t61;
    const double t62 = 1.0/params[0]; /* 1/m */
    out[40] = t62;
    const double t63 = t54/params[0]; /* G*G/m */
    out[42] = t63;
    const double t64 = params[0]*2.0; /* m*2 */
    const double t65 = t2*t2; /* R*R*R*R */
    const double t66 = t64*t65; /* m*2*R*R*R*R */
    const double t67 = t40*t66; /* I1*I1*m*2*R*R*R*R */
    const double t68 = params[4]*t67; /* I3*I1*I1*m*2*R*R*R*R */
    const double t69 = t9*t68; /* (I1 - I3)*I3*I1*I1*m*2*R*R*R*R */
    out[44] = t69;
    const double t70 = 2.0/params[0]; /* 2/m */
    out[45] = t70;
    const double t71 = params[6]*t14; /* G*I1*R*R*2 */
    const double t72 = t9*t71; /* (I1 - I3)*G*I1*R*R*2 */
    out[46] = t72;
    const double t73 = t40*t64; /* I1*I1*m*2 */
    out[47] = t73;
    const double t74 = params[1]*t64; /* R*m*2 */
    const double t75 = t40*t74; /* I1*I1*R*m*2 */
    out[48] = t75;
    const double t76 = t9*t41; /* (I1 - I3)*R*R*2*I1*I1 */
    out[49] = t76;
    const double t77 = params[3]*t40; /* I1*I1*I1 */
    const double t78 = t66*t77; /* m*2*R*R*R*R*I1*I1*I1 */
    const double t79 = t9*t78; /* (I1 - I3)*m*2*R*R*R*R*I1*I1*I1 */
    out[50] = t79;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    out[0] = t1;
    const double t2 = x[4]*p[7]; /* s*R*G */
    const double t3 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t5 = x[4]*p[9]; /* s*R^2*I1 */
    const double t6 = x[4]*t5; /* s*s*R^2*I1 */
    const double t7 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t8 = JLT_FMA(x[0], t7, t6); /* K = gamma3*gamma3*R^2*I3 + s*s*R^2*I1 */
    const double t9 = t8 + p[11]; /* Theta/m = K + I1*I3/m */
    const double t10 = t8*t9; /* K*Theta/m */
    const double t11 = 1.0/t10; /* 1/(K*Theta/m) */
    const double t12 = t9*t11; /* 1/K = Theta/m*1/(K*Theta/m) */
    const double t13 = t4*t12; /* (gamma3*v_tau*R*I3 + s*R*G)*1/K */
    const double t14 = x[3]*t13; /* v_tau*(gamma3*v_tau*R*I3 + s*R*G)*1/K */
    out[1] = t14;
    const double t15 = x[4]*x[3]; /* s*v_tau */
    const double t16 = JLT_FNMA(x[0], p[12], t15); /* s*v_tau - gamma3*G/I1 */
    const double t17 = t12*t16; /* 1/K*(s*v_tau - gamma3*G/I1) */
    const double t18 = x[4]*p[8]; /* s*R*I3 */
    const double t19 = t17*t18; /* 1/K*(s*v_tau - gamma3*G/I1)*s*R*I3 */
    const double t20 = JLT_FMA(x[0], t13, t19); /* gamma3*(gamma3*v_tau*R*I3 + s*R*G)*1/K + 1/K*(s*v_tau - gamma3*G/I1)*s*R*I3 */
    const double t21 = t13*t20; /* (gamma3*v_tau*R*I3 + s*R*G)*1/K*t20 */
    const double t22 = -t21; /* -(gamma3*v_tau*R*I3 + s*R*G)*1/K*t20 */
    out[2] = t22;
    const double t23 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t24 = t8*t11; /* 1/(Theta/m) = K*1/(K*Theta/m) */
    const double t25 = p[11]*t23; /* I1*I3/m*V */
    const double t26 = JLT_FNMA(t24, t25, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t27 = t13*t26; /* (gamma3*v_tau*R*I3 + s*R*G)*1/K*(v_nu - 1/(Theta/m)*I1*I3/m*V) */
    const double t28 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t29 = p[13]*t28; /* R^2*I1*I3*(I1 - I3)/m*s*omega_tau*gamma3 */
    const double t30 = t24*t29; /* 1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*s*omega_tau*gamma3 */
    const double t31 = JLT_FMA(t17, t30, t27); /* 1/K*(s*v_tau - gamma3*G/I1)*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*s*omega_tau*gamma3 + t27 */
    const double t32 = -t31; /* -t31 */
    out[3] = t32;
    const double t33 = -t28; /* -s*omega_tau*gamma3 */
    out[4] = t33;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[21] = 0.0;
    out[23] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[2] = t0;
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = p[10]*x[0]; /* R^2*I3*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*R^2*I3*gamma3 + R^2*I1*s*s */
    const double t4 = p[11] + t3; /* Theta/m = I1*I3/m + K */
    const double t5 = t3*t4; /* K*Theta/m */
    const double t6 = 1.0/t5; /* 1/(K*Theta/m) */
    const double t7 = t4*t6; /* 1/K = Theta/m*1/(K*Theta/m) */
    const double t8 = t3*t6; /* 1/(Theta/m) = K*1/(K*Theta/m) */
    const double t9 = x[4]*x[2]; /* s*omega_tau */
    const double t10 = 2.0*t9; /* 2*s*omega_tau */
    out[4] = t10;
    const double t11 = -t9; /* -s*omega_tau */
    out[20] = t11;
    const double t12 = x[4]*x[3]; /* s*v_tau */
    const double t13 = JLT_FNMA(x[0], p[12], t12); /* s*v_tau - gamma3*G/I1 */
    const double t14 = x[0]*p[26]; /* gamma3*R^2*(I1 - I3) */
    const double t15 = t9*t14; /* s*omega_tau*gamma3*R^2*(I1 - I3) */
    const double t16 = t13*t15; /* (s*v_tau - gamma3*G/I1)*s*omega_tau*gamma3*R^2*(I1 - I3) */
    const double t17 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t18 = x[4]*p[7]; /* s*R*G */
    const double t19 = JLT_FMA(x[0], t17, t18); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t20 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t21 = JLT_FNMA(t19, t20, t16); /* (s*v_tau - gamma3*G/I1)*s*omega_tau*gamma3*R^2*(I1 - I3) - (gamma3*v_tau*R*I3 + s*R*G)*V */
    const double t22 = p[11]*t20; /* I1*I3/m*V */
    const double t23 = t7*t19; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t24 = JLT_FNMA(t8, t22, x[1]); /* v_nu - 1/(Theta/m)*I1*I3/m*V */
    const double t25 = t8*t21; /* 1/(Theta/m)*t21 */
    const double t26 = t7*t17; /* 1/K*v_tau*R*I3 */
    const double t27 = x[0]*t7; /* gamma3*1/K */
    const double t28 = JLT_FMA(t17, t27, t23); /* v_tau*R*I3*gamma3*1/K + 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[8] = t28;
    const double t29 = p[7]*t7; /* R*G*1/K */
    const double t30 = x[4]*t7; /* s*1/K */
    const double t31 = t7 + t8; /* 1/K + 1/(Theta/m) */
    const double t32 = t25*t31; /* 1/(Theta/m)*t21*(1/K + 1/(Theta/m)) */
    const double t33 = t7*t13; /* 1/K*(s*v_tau - gamma3*G/I1) */
    const double t34 = p[13]*t8; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t35 = t8*t23; /* 1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t36 = JLT_FMS(p[11], t35, t23); /* I1*I3/m*1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) - 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[16] = t36;
    const double t37 = p[27]*t35; /* R*I1*I3/m*1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t38 = t23*t27; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t39 = x[3]*p[17]; /* v_tau*2*R*I3 */
    const double t40 = t38*t39; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K*v_tau*2*R*I3 */
    const double t41 = t24*t26; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*v_tau*R*I3 */
    const double t42 = p[25]*t27; /* 2*R^2*I1*I3^2/m*gamma3*1/K */
    const double t43 = JLT_FMS(t32, t42, t41); /* 1/(Theta/m)*t21*(1/K + 1/(Theta/m))*2*R^2*I1*I3^2/m*gamma3*1/K - (v_nu - 1/(Theta/m)*I1*I3/m*V)*1/K*v_tau*R*I3 */
    const double t44 = t27*t34; /* gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t45 = t24*t29; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t46 = p[28]*t30; /* 2*R^2*I1^2*I3/m*s*1/K */
    const double t47 = JLT_FMS(t32, t46, t45); /* 1/(Theta/m)*t21*(1/K + 1/(Theta/m))*2*R^2*I1^2*I3/m*s*1/K - (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*G*1/K */
    const double t48 = t23*t30; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t49 = JLT_FMS(p[18], t48, t40); /* R*I3*G/I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - 1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K*v_tau*2*R*I3 */
    const double t50 = t13*t30; /* (s*v_tau - gamma3*G/I1)*s*1/K */
    const double t51 = t13*t44; /* (s*v_tau - gamma3*G/I1)*gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t52 = JLT_FNMA(x[4], t51, t37); /* R*I1*I3/m*1/(Theta/m)*1/K*(gamma3*v_tau*R*I3 + s*R*G) - s*t51 */
    out[17] = t52;
    const double t53 = JLT_FNMA(x[2], t51, t47); /* t47 - omega_tau*t51 */
    const double t54 = JLT_FMS(p[24], t50, t17); /* 4*R^3*I1*I3*(s*v_tau - gamma3*G/I1)*s*1/K - v_tau*R*I3 */
    const double t55 = t9*t44; /* s*omega_tau*gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t56 = t9*t33; /* s*omega_tau*1/K*(s*v_tau - gamma3*G/I1) */
    const double t57 = JLT_FNMA(t34, t56, t43); /* t43 - R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*s*omega_tau*1/K*(s*v_tau - gamma3*G/I1) */
    const double t58 = JLT_FMA(p[7], t30, t23); /* R*G*s*1/K + 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t59 = p[8]*t33; /* R*I3*1/K*(s*v_tau - gamma3*G/I1) */
    const double t60 = JLT_FNMA(x[3], t55, t53); /* t47 - omega_tau*t51 - v_tau*s*omega_tau*gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) */
    const double t61 = p[20]*t27; /* (-R^2*I3^2)*gamma3*1/K */
    const double t62 = p[8]*t27; /* R*I3*gamma3*1/K */
    const double t63 = t24*t62; /* (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t64 = t50*t61; /* (s*v_tau - gamma3*G/I1)*s*1/K*(-R^2*I3^2)*gamma3*1/K */
    const double t65 = p[8]*t50; /* R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t66 = JLT_FMA(x[4], t55, t63); /* s*s*omega_tau*gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) + (v_nu - 1/(Theta/m)*I1*I3/m*V)*R*I3*gamma3*1/K */
    const double t67 = -t66; /* -t66 */
    out[18] = t67;
    const double t68 = JLT_FNMA(x[4], t23, p[23]); /* 1/2*G/(R*I1) - s*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t69 = p[22]*t38; /* 4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t70 = t68*t69; /* (1/2*G/(R*I1) - s*1/K*(gamma3*v_tau*R*I3 + s*R*G))*4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t71 = JLT_FMS(t48, t54, t70); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K*(4*R^3*I1*I3*(s*v_tau - gamma3*G/I1)*s*1/K - v_tau*R*I3) - t70 */
    const double t72 = JLT_FNMA(t58, t59, t71); /* t71 - (R*G*s*1/K + 1/K*(gamma3*v_tau*R*I3 + s*R*G))*R*I3*1/K*(s*v_tau - gamma3*G/I1) */
    out[14] = t72;
    const double t73 = p[14]*t38; /* 2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t74 = JLT_FMA(x[1], t73, t57); /* v_nu*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K + t57 */
    const double t75 = JLT_FMA(p[12], t55, t74); /* G/I1*s*omega_tau*gamma3*1/K*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m) + t74 */
    out[15] = t75;
    const double t76 = t26 - t73; /* 1/K*v_tau*R*I3 - 2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t77 = x[3]*t76; /* v_tau*t76 */
    out[5] = t77;
    const double t78 = JLT_FNMA(p[16], t38, t26); /* 1/K*v_tau*R*I3 - 4*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t79 = JLT_FNMA(t65, t78, t49); /* t49 - R*I3*(s*v_tau - gamma3*G/I1)*s*1/K*t78 */
    const double t80 = x[0]*t38; /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t81 = p[15]*t48; /* 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t82 = JLT_FMA(x[1], t81, t60); /* v_nu*2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K + t60 */
    out[19] = t82;
    const double t83 = t29 - t81; /* R*G*1/K - 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t84 = x[3]*t83; /* v_tau*(R*G*1/K - 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[9] = t84;
    const double t85 = x[4]*p[21]; /* s*(-R*I3) */
    const double t86 = JLT_FMA(t48, t85, t64); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K*s*(-R*I3) + (s*v_tau - gamma3*G/I1)*s*1/K*(-R^2*I3^2)*gamma3*1/K */
    const double t87 = JLT_FMA(p[19], t80, t86); /* (-2*R*I3)*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K + t86 */
    out[13] = t87;
    const double t88 = JLT_FMS(p[16], t80, t23); /* 4*R^2*I3*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K - 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t89 = JLT_FMA(t23, t88, t79); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*t88 + t49 - R*I3*(s*v_tau - gamma3*G/I1)*s*1/K*t78 */
    out[10] = t89;
    const double t90 = x[4]*x[0]; /* s*gamma3 */
    const double t91 = -t90; /* -s*gamma3 */
    out[22] = t91;
    const double t92 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t93 = -t92; /* -omega_tau*gamma3 */
    out[24] = t93;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[5] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[16] = 0.0;
    out[17] = 0.0;
    out[26] = 0.0;
    out[28] = 0.0;
    const double t0 = x[4]*x[4]; /* s*s */
    out[7] = t0;
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s*s */
    const double t4 = p[11] + t3; /* Theta/m = I1*I3/m + K */
    const double t5 = t3*t4; /* K*Theta/m */
    const double t6 = 1.0/t5; /* 1/(K*Theta/m) */
    const double t7 = t4*t6; /* 1/K = Theta/m*1/(K*Theta/m) */
    const double t8 = t3*t6; /* 1/(Theta/m) = K*1/(K*Theta/m) */
    const double t9 = x[4]*p[7]; /* s*R*G */
    const double t10 = x[3]*p[8]; /* v_tau*R*I3 */
    const double t11 = JLT_FMA(x[0], t10, t9); /* gamma3*v_tau*R*I3 + s*R*G */
    const double t12 = x[4]*x[3]; /* s*v_tau */
    const double t13 = JLT_FNMA(x[0], p[12], t12); /* s*v_tau - gamma3*G/I1 */
    const double t14 = t12 + t13; /* s*v_tau + s*v_tau - gamma3*G/I1 */
    const double t15 = t7*t14; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t16 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t17 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t18 = -t17; /* -omega_tau*gamma3 */
    out[29] = t18;
    const double t19 = x[4]*t17; /* s*omega_tau*gamma3 */
    const double t20 = -t19; /* -s*omega_tau*gamma3 */
    out[4] = t20;
    const double t21 = t11*t16; /* (gamma3*v_tau*R*I3 + s*R*G)*V */
    const double t22 = t7*t11; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t23 = x[3]*t22; /* v_tau*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[1] = t23;
    const double t24 = p[26]*t13; /* R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t25 = JLT_FNMA(t19, t24, t21); /* (gamma3*v_tau*R*I3 + s*R*G)*V - s*omega_tau*gamma3*R^2*(I1 - I3)*(s*v_tau - gamma3*G/I1) */
    const double t26 = t8*t25; /* 1/(Theta/m)*t25 */
    const double t27 = x[0]*t7; /* gamma3*1/K */
    const double t28 = JLT_FMA(t10, t27, t22); /* v_tau*R*I3*gamma3*1/K + 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[13] = t28;
    const double t29 = t7*t10; /* 1/K*v_tau*R*I3 */
    const double t30 = t7 + t8; /* 1/K + 1/(Theta/m) */
    const double t31 = t26*t30; /* 1/(Theta/m)*t25*(1/K + 1/(Theta/m)) */
    const double t32 = x[4]*t7; /* s*1/K */
    const double t33 = p[7]*t7; /* R*G*1/K */
    const double t34 = x[0]*t22; /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t35 = p[25]*t27; /* 2*R^2*I1*I3^2/m*gamma3*1/K */
    const double t36 = t31*t35; /* 1/(Theta/m)*t25*(1/K + 1/(Theta/m))*2*R^2*I1*I3^2/m*gamma3*1/K */
    const double t37 = p[13]*t17; /* R^2*I1*I3*(I1 - I3)/m*omega_tau*gamma3 */
    const double t38 = t8*t37; /* 1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*omega_tau*gamma3 */
    const double t39 = t15*t38; /* 1/K*(s*v_tau + s*v_tau - gamma3*G/I1)*1/(Theta/m)*R^2*I1*I3*(I1 - I3)/m*omega_tau*gamma3 */
    const double t40 = p[8]*t15; /* R*I3*1/K*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t41 = t22*t40; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I3*1/K*(s*v_tau + s*v_tau - gamma3*G/I1) */
    const double t42 = t13*t32; /* (s*v_tau - gamma3*G/I1)*s*1/K */
    const double t43 = p[11]*t8; /* I1*I3/m*1/(Theta/m) */
    const double t44 = JLT_FNMA(t16, t43, x[1]); /* v_nu - V*I1*I3/m*1/(Theta/m) */
    const double t45 = JLT_FMS(t22, t43, t22); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*I1*I3/m*1/(Theta/m) - 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    out[21] = t45;
    const double t46 = t8*t32; /* 1/(Theta/m)*s*1/K */
    const double t47 = p[27]*t8; /* R*I1*I3/m*1/(Theta/m) */
    const double t48 = t22*t47; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I1*I3/m*1/(Theta/m) */
    const double t49 = t22*t27; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t50 = t22*t32; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t51 = p[28]*t32; /* 2*R^2*I1^2*I3/m*s*1/K */
    const double t52 = p[16]*t34; /* 4*R^2*I3*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t53 = t49*t52; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K*4*R^2*I3*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t54 = p[14]*t49; /* 2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t55 = JLT_FMA(p[18], t50, t53); /* R*I3*G/I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K + t53 */
    const double t56 = p[30]*t17; /* R^2*I3*G*(I1 - I3)/m*omega_tau*gamma3 */
    const double t57 = JLT_FMS(t46, t56, t36); /* 1/(Theta/m)*s*1/K*R^2*I3*G*(I1 - I3)/m*omega_tau*gamma3 - t36 */
    const double t58 = p[13]*t46; /* R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*s*1/K */
    const double t59 = t13*t58; /* (s*v_tau - gamma3*G/I1)*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*s*1/K */
    const double t60 = JLT_FNMA(x[0], t59, t48); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*R*I1*I3/m*1/(Theta/m) - gamma3*t59 */
    out[22] = t60;
    const double t61 = JLT_FNMA(t29, t44, t57); /* t57 - 1/K*v_tau*R*I3*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t62 = JLT_FMA(x[1], t54, t61); /* v_nu*2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K + t57 - 1/K*v_tau*R*I3*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t63 = JLT_FNMA(x[2], t59, t62); /* t62 - omega_tau*t59 */
    out[20] = t63;
    const double t64 = t29 - t54; /* 1/K*v_tau*R*I3 - 2*R^2*I3*1/K*(gamma3*v_tau*R*I3 + s*R*G)*gamma3*1/K */
    const double t65 = x[3]*t64; /* v_tau*t64 */
    out[10] = t65;
    const double t66 = p[8]*t42; /* R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t67 = p[15]*t50; /* 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t68 = JLT_FMS(x[1], t67, t39); /* v_nu*2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t39 */
    const double t69 = JLT_FNMA(t31, t51, t68); /* v_nu*2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t39 - 1/(Theta/m)*t25*(1/K + 1/(Theta/m))*2*R^2*I1^2*I3/m*s*1/K */
    const double t70 = JLT_FNMA(t33, t44, t69); /* t69 - R*G*1/K*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    out[24] = t70;
    const double t71 = t33 - t67; /* R*G*1/K - 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t72 = x[3]*t71; /* v_tau*(R*G*1/K - 2*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[14] = t72;
    const double t73 = p[29]*t27; /* 4*R^3*I3^2*gamma3*1/K */
    const double t74 = JLT_FMS(t42, t73, t22); /* (s*v_tau - gamma3*G/I1)*s*1/K*4*R^3*I3^2*gamma3*1/K - 1/K*(gamma3*v_tau*R*I3 + s*R*G) */
    const double t75 = JLT_FMA(t22, t74, t55); /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*t74 + R*I3*G/I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K + t53 */
    const double t76 = p[8]*t27; /* R*I3*gamma3*1/K */
    const double t77 = t44*t76; /* (v_nu - V*I1*I3/m*1/(Theta/m))*R*I3*gamma3*1/K */
    const double t78 = JLT_FMA(t19, t58, t77); /* s*omega_tau*gamma3*R^2*I1*I3*(I1 - I3)/m*1/(Theta/m)*s*1/K + (v_nu - V*I1*I3/m*1/(Theta/m))*R*I3*gamma3*1/K */
    const double t79 = -t78; /* -t78 */
    out[23] = t79;
    const double t80 = t22*t44; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*(v_nu - V*I1*I3/m*1/(Theta/m)) */
    const double t81 = JLT_FMA(t17, t59, t80); /* omega_tau*gamma3*t59 + t80 */
    const double t82 = -t81; /* -(omega_tau*gamma3*t59 + t80) */
    out[3] = t82;
    const double t83 = t34 + t66; /* gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t84 = JLT_FMA(2.0, t34, t66); /* 2*gamma3*1/K*(gamma3*v_tau*R*I3 + s*R*G) + R*I3*(s*v_tau - gamma3*G/I1)*s*1/K */
    const double t85 = JLT_FNMA(t29, t84, t75); /* t75 - 1/K*v_tau*R*I3*t84 */
    out[15] = t85;
    const double t86 = t22*t83; /* 1/K*(gamma3*v_tau*R*I3 + s*R*G)*t83 */
    const double t87 = -t86; /* -1/K*(gamma3*v_tau*R*I3 + s*R*G)*t83 */
    out[2] = t87;
    const double t88 = x[4]*t50; /* s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t89 = JLT_FMA(t27, t84, t88); /* gamma3*1/K*t84 + s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t90 = p[21]*t89; /* (-R*I3)*(gamma3*1/K*t84 + s*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K) */
    out[18] = t90;
    const double t91 = p[22]*t50; /* 4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K */
    const double t92 = JLT_FMS(t83, t91, t41); /* t83*4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t41 */
    const double t93 = JLT_FNMA(t33, t84, t92); /* t83*4*R^2*I1*1/K*(gamma3*v_tau*R*I3 + s*R*G)*s*1/K - t41 - R*G*1/K*t84 */
    out[19] = t93;
    const double t94 = x[4]*x[2]; /* s*omega_tau */
    const double t95 = x[4]*t94; /* s*s*omega_tau */
    out[0] = t95;
    const double t96 = 2.0*t94; /* 2*s*omega_tau */
    out[9] = t96;
    const double t97 = -t94; /* -s*omega_tau */
    out[25] = t97;
    const double t98 = x[4]*x[0]; /* s*gamma3 */
    const double t99 = -t98; /* -s*gamma3 */
    out[27] = t99;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + R^2*I1*s*s */
    const double t4 = x[2]*p[31]; /* omega_tau*R*I1*(I1 - I3)/m */
    const double t5 = t0*t4; /* s*s*omega_tau*R*I1*(I1 - I3)/m */
    const double t6 = JLT_FMA(x[2], p[1], x[1]); /* V = omega_tau*R + v_nu */
    const double t7 = JLT_FNMA(p[11], t6, t5); /* s*s*omega_tau*R*I1*(I1 - I3)/m - I1*I3/m*V */
    const double t8 = p[11] + t3; /* Theta/m = I1*I3/m + K */
    const double t9 = JLT_FMA(x[1], t8, t7); /* v_nu*Theta/m + s*s*omega_tau*R*I1*(I1 - I3)/m - I1*I3/m*V */
    const double t10 = t3*t8; /* K*Theta/m */
    const double t11 = p[8]*t9; /* R*I3*(v_nu*Theta/m + s*s*omega_tau*R*I1*(I1 - I3)/m - I1*I3/m*V) */
    const double t12 = t11/t10; /* t11/(K*Theta/m) */
    const double t13 = x[2] + t12; /* omega_tau + t11/(K*Theta/m) */
    const double t14 = x[0]*t13; /* gamma3*(omega_tau + t11/(K*Theta/m)) */
    const double t15 = -t14; /* -gamma3*(omega_tau + t11/(K*Theta/m)) */
    out[0] = t15;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* v_nu*v_nu */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[33]*x[0]; /* I3/I1*gamma3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K/(R^2*I1) = gamma3*I3/I1*gamma3 + s*s */
    const double t4 = 1.0/t3; /* 1/(K/(R^2*I1)) */
    const double t5 = t3 + p[35]; /* Theta/(m*R^2*I1) = K/(R^2*I1) + I3/(m*R^2) */
    const double t6 = x[3]*x[3]; /* v_tau*v_tau */
    const double t7 = JLT_FMA(t5, t6, p[34]); /* Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1) */
    const double t8 = JLT_FMA(t4, t7, t0); /* 1/(K/(R^2*I1))*(Theta/(m*R^2*I1)*v_tau*v_tau + G^2/(m*R^2*I1)) + v_nu*v_nu */
    const double t9 = p[32]*t8; /* 1/2*m*t8 */
    const double t10 = p[36]*x[2]; /* 1/2*I1*omega_tau */
    const double t11 = JLT_FMA(x[2], t10, t9); /* omega_tau*1/2*I1*omega_tau + 1/2*m*t8 */
    out[0] = t11;
    const double t12 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t13 = p[37]*t12; /* m*I1^2*(omega_tau*R + v_nu) */
    const double t14 = t12*t13; /* (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    const double t15 = x[4]*x[3]; /* s*v_tau */
    const double t16 = JLT_FNMA(x[0], p[12], t15); /* s*v_tau - gamma3*G/I1 */
    const double t17 = t4*t16; /* 1/(K/(R^2*I1))*(s*v_tau - gamma3*G/I1) */
    const double t18 = t5*p[38]; /* Theta/(m*R^2*I1)*m*I1*(I1 - I3) */
    const double t19 = t17*t18; /* 1/(K/(R^2*I1))*(s*v_tau - gamma3*G/I1)*Theta/(m*R^2*I1)*m*I1*(I1 - I3) */
    const double t20 = JLT_FMA(t17, t19, t14); /* 1/(K/(R^2*I1))*(s*v_tau - gamma3*G/I1)*t19 + (omega_tau*R + v_nu)*m*I1^2*(omega_tau*R + v_nu) */
    out[1] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[9]*x[4]; /* R^2*I1*s */
    const double t1 = x[4]*t0; /* s*R^2*I1*s */
    const double t2 = x[0]*p[10]; /* gamma3*R^2*I3 */
    const double t3 = JLT_FMA(x[0], t2, t1); /* K = gamma3*gamma3*R^2*I3 + s*R^2*I1*s */
    const double t4 = 1.0/t3; /* 1/K */
    const double t5 = JLT_FMA(t3, p[0], p[41]); /* Theta = K*m + I1*I3 */
    const double t6 = t4*t5; /* 1/K*Theta */
    const double t7 = x[3]*t6; /* v_tau*1/K*Theta */
    out[3] = t7;
    const double t8 = JLT_FNMA(p[40], t7, x[3]); /* v_tau - 1/m*v_tau*1/K*Theta */
    const double t9 = x[3]*t8; /* v_tau*(v_tau - 1/m*v_tau*1/K*Theta) */
    const double t10 = JLT_FNMA(t4, p[42], t9); /* v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m */
    const double t11 = t4*t10; /* 1/K*(v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m) */
    const double t12 = p[39]*x[0]; /* m*R^2*I3*gamma3 */
    const double t13 = t11*t12; /* 1/K*(v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m)*m*R^2*I3*gamma3 */
    out[0] = t13;
    const double t14 = p[0]*x[1]; /* m*v_nu */
    out[1] = t14;
    const double t15 = p[3]*x[2]; /* I1*omega_tau */
    out[2] = t15;
    const double t16 = x[4]*p[43]; /* s*m*R^2*I1 */
    const double t17 = t11*t16; /* 1/K*(v_tau*(v_tau - 1/m*v_tau*1/K*Theta) - 1/K*G^2/m)*s*m*R^2*I1 */
    out[4] = t17;
    const double t18 = x[4]*x[3]; /* s*v_tau */
    const double t19 = JLT_FNMA(x[0], p[12], t18); /* s*v_tau - gamma3*G/I1 */
    const double t20 = t4*t19; /* 1/K*(s*v_tau - gamma3*G/I1) */
    const double t21 = t6*t20; /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) */
    const double t22 = JLT_FNMA(p[45], t21, t20); /* 1/K*(s*v_tau - gamma3*G/I1) - 2/m*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1) */
    const double t23 = t20*t22; /* 1/K*(s*v_tau - gamma3*G/I1)*t22 */
    const double t24 = x[0]*p[44]; /* gamma3*2*m*R^4*I1^2*I3*(I1 - I3) */
    const double t25 = t23*t24; /* 1/K*(s*v_tau - gamma3*G/I1)*t22*gamma3*2*m*R^4*I1^2*I3*(I1 - I3) */
    const double t26 = JLT_FNMA(t21, p[46], t25); /* t25 - 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1*G*(I1 - I3) */
    out[5] = t26;
    const double t27 = JLT_FMA(x[2], p[1], x[1]); /* omega_tau*R + v_nu */
    const double t28 = p[47]*t27; /* 2*m*I1^2*(omega_tau*R + v_nu) */
    out[6] = t28;
    const double t29 = t27*p[48]; /* (omega_tau*R + v_nu)*2*m*R*I1^2 */
    out[7] = t29;
    const double t30 = t21*p[49]; /* 1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t31 = x[4]*t30; /* s*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    out[8] = t31;
    const double t32 = x[3]*t30; /* v_tau*1/K*Theta*1/K*(s*v_tau - gamma3*G/I1)*2*R^2*I1^2*(I1 - I3) */
    const double t33 = x[4]*p[50]; /* s*2*m*R^4*I1^3*(I1 - I3) */
    const double t34 = JLT_FMA(t23, t33, t32); /* 1/K*(s*v_tau - gamma3*G/I1)*t22*s*2*m*R^4*I1^3*(I1 - I3) + t32 */
    out[9] = t34;
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
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x2, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t6[k] = x4[k]*p[7];
        t9[k] = x3[k]*p[8];
        t10[k] = jlt_jet_product(x0, t9, k) + t6[k];
        t12[k] = x4[k]*p[9];
        t13[k] = jlt_jet_product(x4, t12, k);
        t15[k] = x0[k]*p[10];
        t16[k] = jlt_jet_product(x0, t15, k) + t13[k];
        t18[k] = t16[k] + (k == 0 ? p[11] : 0);
        t19[k] = jlt_jet_product(t16, t18, k);
        t21[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t19, t21, k);
        t22[k] = jlt_jet_product(t18, t21, k);
        t23[k] = jlt_jet_product(t10, t22, k);
        t24[k] = jlt_jet_product(x3, t23, k);
        t25[k] = jlt_jet_product(x4, x3, k);
        t27[k] = t25[k] - x0[k]*p[12];
        t28[k] = jlt_jet_product(t22, t27, k);
        t29[k] = x4[k]*p[8];
        t30[k] = jlt_jet_product(t28, t29, k);
        t31[k] = jlt_jet_product(x0, t23, k) + t30[k];
        t32[k] = jlt_jet_product(t23, t31, k);
        t33[k] = -t32[k];
        t36[k] = x2[k]*p[1] + x1[k];
        t37[k] = jlt_jet_product(t16, t21, k);
        t38[k] = p[11]*t36[k];
        t39[k] = x1[k] - jlt_jet_product(t37, t38, k);
        t40[k] = jlt_jet_product(t23, t39, k);
        t42[k] = jlt_jet_product(t2, x0, k);
        t43[k] = p[13]*t42[k];
        t44[k] = jlt_jet_product(t37, t43, k);
        t45[k] = jlt_jet_product(t28, t44, k) + t40[k];
        t46[k] = -t45[k];
        t47[k] = -t42[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t24[k]/(k + 1);
        next[2] = x2[k + 1] = t33[k]/(k + 1);
        next[3] = x3[k + 1] = t46[k]/(k + 1);
        next[4] = x4[k + 1] = t47[k]/(k + 1);
        next[5] = x4[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[4];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_v_tau = x[3];
    const double v_R = params[1];
    const double v_I1 = params[3];
    const double v_I3 = params[4];
    const double v_a3 = (0.0);
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_K = (v_R*v_R*v_I1*v_s*v_s + v_I3*v_b*v_b);
    const double v_G = params[6];
    const double complex v_omega_n = ((v_R*v_G*v_s + v_I3*v_v_tau*v_b)/v_K);
    out[1] = (v_s)*((v_v_tau*v_omega_n/v_s));
    const double v_m = params[0];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double complex v_omega3 = ((v_R*v_I1*v_v_tau*v_s - v_G*v_b)/v_K);
    out[2] = (v_s)*((v_m*v_a3*v_a3*v_gamma3*v_omega_tau*v_omega_tau*v_s/v_D)
        + (-v_m*v_g*v_a3*v_s/v_D)
        + (-v_I1*v_gamma3*v_omega_n*v_omega_n/(v_s*v_D))
        + (-v_I3*v_omega_n*v_omega3/v_D));
    const double complex v_v_nu = x[1];
    const double complex v_Theta = (v_m*v_K + v_I1*v_I3);
    const double complex v_e = (v_R + v_a3*v_gamma3);
    const double complex v_V = (v_v_nu + v_omega_tau*v_e);
    out[3] = (v_s)*((-v_v_nu*v_omega_n/v_s)
        + (v_I1*v_I3*v_V*v_omega_n/(v_s*v_Theta))
        + (-v_I3*v_omega_tau*v_omega3*(v_R*v_gamma3*(v_I1 - v_I3) - v_I3*v_a3)/v_Theta));
    out[4] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the angle between the symmetry axis and the vertical", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_tau", "1/s", "angular velocity about tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "v_tau", "m/s", "velocity of the centre of mass along tau", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "free-fall acceleration", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "I1", "kg m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "G", "kg m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-14.0 / 25.0) },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "F0", "a3 = 0" },
};

const jlt_descriptor jlt_kernels_spherical_top_level_balanced_in_regular = {
    .model = "spherical_top_level",
    .variant = "balanced",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 51,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 22, 7, 1, 0, 0, 12, 7 }, { 16, 71, 0, 6, 0, 0, 10, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .jacobian = { jacobian, 25, { 8, 55, 30, 1, 0, 0, 13, 20 }, { 91, 507, 0, 46, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 13, 60, 26, 1, 0, 0, 14, 22 }, { 104, 567, 0, 52, 0, 0, 16, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .divergence = { divergence, 1, { 3, 8, 4, 1, 0, 0, 10, 4 }, { 8, 30, 0, 3, 0, 0, 10, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .integral_values = { integral_values, 2, { 1, 12, 7, 1, 0, 0, 7, 5 }, { 9, 35, 0, 3, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are" },
    .integral_gradients = { integral_gradients, 10, { 0, 25, 9, 1, 0, 0, 11, 5 }, { 26, 155, 0, 14, 0, 0, 13, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and R^2*I3*gamma3^2 are" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 2, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_balanced_in_regular_baseline,
        &jlt_batch_spherical_top_level_balanced_in_regular_avx2,
        &jlt_batch_spherical_top_level_balanced_in_regular_avx512,
    },
};
