/* Sphere with displaced centre of mass rolling without slipping, reduced system
 *
 *  Source:     E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      routh_sphere, SHA-256 7ea5d7e192247bbb71a43cf42803dc35e835526f39f8f2b9ef8220743e084b9e
 *  Command:    ttc generate --out DIR routh_sphere.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4   21   11    1    0    0      8   10   (90)
 *  jacobian            8   51   24    1    0    0     13   16   (345)
 *  rhs_jacobian        10   57   26    1    0    0     11   17   (407)
 *  divergence          2    7    4    1    0    0      6    6   (41)
 *  integral_values     0   13   12    0    1    0      6    7   (54)
 *  integral_gradients  0   24   12    1    1    0      6    8   (77)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes.
 *  One division serves all denominators: their product may leave the range of double precision where none of them
 *  does, which raises the overflow or underflow exception, or gives an infinity or NaN.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_routh_sphere[];
extern const jlt_descriptor jlt_kernels_routh_sphere_general_in_regular;
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
    const double t6 = params[5]/params[0]; /* I3/m */
    out[9] = t6;
    const double t7 = params[4]/params[0]; /* I1/m */
    out[10] = t7;
    const double t8 = params[3]*params[2]; /* a3*g */
    out[11] = t8;
    const double t9 = params[3]*params[3]; /* a3*a3 */
    out[57] = t9;
    const double t10 = t0 + t9; /* R*R + a3*a3 */
    out[40] = t10;
    const double t11 = t7 + t10; /* I1/m + R*R + a3*a3 */
    out[12] = t11;
    const double t12 = params[1]*2.0; /* R*2 */
    const double t13 = params[3]*t12; /* a3*R*2 */
    out[13] = t13;
    const double t14 = params[1]*params[4]; /* R*I1 */
    out[60] = t14;
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
    const double t22 = params[3]/params[1]; /* a3/R */
    out[19] = t22;
    const double t23 = params[3]*2.0; /* a3*2 */
    out[20] = t23;
    const double t24 = params[4]*t23; /* I1*a3*2 */
    const double t25 = t24/params[0]; /* I1*a3*2/m */
    out[21] = t25;
    const double t26 = params[4]/t16; /* I1/(m*R) */
    out[22] = t26;
    const double t27 = params[5]*t13; /* I3*a3*R*2 */
    const double t28 = t27/params[4]; /* I3*a3*R*2/I1 */
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
    out[45] = t34;
    const double t35 = t34/params[0]; /* I1*2/m */
    out[27] = t35;
    const double t36 = t21/t14; /* I3*a3/(R*I1) */
    out[28] = t36;
    const double t37 = params[4]*params[4]; /* I1*I1 */
    const double t38 = t0*t37; /* R*R*I1*I1 */
    const double t39 = params[5]*params[5]; /* I3*I3 */
    const double t40 = 2.0*t39; /* 2*I3*I3 */
    const double t41 = t40/t38; /* 2*I3*I3/(R*R*I1*I1) */
    out[29] = t41;
    const double t42 = params[5]*2.0; /* I3*2 */
    const double t43 = t42/t14; /* I3*2/(R*I1) */
    out[30] = t43;
    const double t44 = t1*params[4]; /* m*R*R*I1 */
    out[38] = t44;
    const double t45 = t40/t44; /* 2*I3*I3/(m*R*R*I1) */
    out[31] = t45;
    const double t46 = t19/params[4]; /* (I1 - I3)/I1 */
    out[32] = t46;
    const double t47 = t42/t38; /* I3*2/(R*R*I1*I1) */
    out[33] = t47;
    const double t48 = (-2.0)/t14; /* (-2)/(R*I1) */
    out[34] = t48;
    const double t49 = params[3]*t16; /* a3*m*R */
    out[35] = t49;
    const double t50 = params[0]*params[2]; /* m*g */
    const double t51 = params[3]*t50; /* a3*m*g */
    out[36] = t51;
    const double t52 = params[5]*params[4]; /* I3*I1 */
    out[37] = t52;
    const double t53 = params[0]*params[5]; /* m*I3 */
    out[39] = t53;
    const double t54 = params[5]*t16; /* I3*m*R */
    out[41] = t54;
    const double t55 = params[0]*2.0; /* m*2 */
    const double t56 = params[1]*t55; /* R*m*2 */
    out[53] = t56;
    const double t57 = params[3]*t56; /* a3*R*m*2 */
    out[43] = t57;
    const double t58 = params[0]*params[3]; /* m*a3 */
    const double t59 = t58/params[4]; /* m*a3/I1 */
    out[44] = t59;
    const double t60 = params[2]*t55; /* g*m*2 */
    const double t61 = params[3]*t60; /* a3*g*m*2 */
    out[46] = t61;
    const double t62 = params[5]*t49; /* I3*a3*m*R */
    out[47] = t62;
    const double t63 = params[0]*params[0]; /* m*m */
    const double t64 = 2.0*t63; /* 2*m*m */
    const double t65 = t0*t64; /* R*R*2*m*m */
    const double t66 = t39*t65; /* I3*I3*R*R*2*m*m */
    out[48] = t66;
    const double t67 = t0*t55; /* R*R*m*2 */
    const double t68 = params[4]*t67; /* I1*R*R*m*2 */
    out[49] = t68;
    const double t69 = t1*t19; /* m*R*R*(I1 - I3) */
    out[50] = t69;
    const double t70 = params[5]*t65; /* I3*R*R*2*m*m */
    out[51] = t70;
    const double t71 = params[1]*t0; /* R*R*R */
    const double t72 = t64*t71; /* 2*m*m*R*R*R */
    const double t73 = params[4]*t72; /* I1*2*m*m*R*R*R */
    out[52] = t73;
    const double t74 = params[5]/params[4]; /* I3/I1 */
    out[54] = t74;
    const double t75 = params[3]*t29; /* a3*R*R*2 */
    const double t76 = params[4]*t75; /* I1*a3*R*R*2 */
    out[55] = t76;
    const double t77 = params[0]/2.0; /* m/2 */
    out[56] = t77;
    const double t78 = params[4]/2.0; /* I1/2 */
    out[58] = t78;
    const double t79 = params[5]/2.0; /* I3/2 */
    out[59] = t79;
    const double t80 = params[1]*params[5]; /* R*I3 */
    const double t81 = -t80; /* -R*I3 */
    out[61] = t81;
    const double t82 = -params[5]; /* -I3 */
    out[62] = t82;
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
    const double t13 = t11*p[9]; /* s*omega3*I3/m */
    const double t14 = x[0]*x[2]; /* gamma3*omega_n */
    const double t15 = JLT_FMA(p[10], t14, t13); /* I1/m*gamma3*omega_n + s*omega3*I3/m */
    const double t16 = JLT_FMA(t9, t12, t15); /* e*v_tau + I1/m*gamma3*omega_n + s*omega3*I3/m */
    const double t17 = JLT_FMA(t2, p[11], t8); /* s*s*g*a3 + s*omega_tau*s*omega_tau*R*a3 */
    const double t18 = JLT_FMA(x[2], t16, t17); /* omega_n*(e*v_tau + I1/m*gamma3*omega_n + s*omega3*I3/m) + s*s*g*a3 + s*omega_tau*s*omega_tau*R*a3 */
    const double t19 = JLT_FMA(x[0], p[13], p[12]); /* K/m = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t20 = t6*t19; /* Theta/(m*R^2*I1)*K/m */
    const double t21 = 1.0/t20; /* 1/(Theta/(m*R^2*I1)*K/m) */
    const double t22 = t6*t18; /* Theta/(m*R^2*I1)*t18 */
    const double t23 = t21*t22; /* 1/(Theta/(m*R^2*I1)*K/m)*Theta/(m*R^2*I1)*t18 */
    const double t24 = -t23; /* -1/(Theta/(m*R^2*I1)*K/m)*Theta/(m*R^2*I1)*t18 */
    out[1] = t24;
    const double t25 = t9 + p[15]; /* e + I3/(m*R) */
    const double t26 = t11*t19; /* s*omega3*K/m */
    const double t27 = t21*t26; /* 1/(Theta/(m*R^2*I1)*K/m)*s*omega3*K/m */
    const double t28 = p[14]*t25; /* I3/(R*I1)*(e + I3/(m*R)) */
    const double t29 = JLT_FMA(t27, t28, t14); /* 1/(Theta/(m*R^2*I1)*K/m)*s*omega3*K/m*I3/(R*I1)*(e + I3/(m*R)) + gamma3*omega_n */
    const double t30 = x[1]*t29; /* omega_tau*t29 */
    out[2] = t30;
    const double t31 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t32 = t0*p[16]; /* s*omega_tau*1/(R*I1) */
    const double t33 = t31*t32; /* (gamma3*R*(I1 - I3) - a3*I3)*s*omega_tau*1/(R*I1) */
    const double t34 = t27*t33; /* 1/(Theta/(m*R^2*I1)*K/m)*s*omega3*K/m*(gamma3*R*(I1 - I3) - a3*I3)*s*omega_tau*1/(R*I1) */
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
    const double t1 = x[4]*x[1]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    out[4] = t2;
    const double t3 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t4 = p[7]*t3; /* I3/(R^2*I1)*b */
    const double t5 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t6 = JLT_FMA(t3, t4, t5); /* Theta/(m*R^2*I1) = b*I3/(R^2*I1)*b + s*s + I3/(m*R^2) */
    const double t7 = JLT_FMA(x[0], p[13], p[12]); /* K/m = gamma3*2*R*a3 + R^2 + a3^2 + I1/m */
    const double t8 = t6*t7; /* Theta/(m*R^2*I1)*K/m */
    const double t9 = 1.0/t8; /* 1/(Theta/(m*R^2*I1)*K/m) */
    const double t10 = t6*t9; /* 1/(K/m) = Theta/(m*R^2*I1)*1/(Theta/(m*R^2*I1)*K/m) */
    const double t11 = x[2]*t10; /* omega_n*1/(K/m) */
    const double t12 = p[1]*t11; /* R*omega_n*1/(K/m) */
    const double t13 = x[2]*t3; /* omega_n*b */
    const double t14 = x[4]*x[3]; /* s*omega3 */
    const double t15 = JLT_FMA(p[1], t14, t13); /* v_tau = R*s*omega3 + omega_n*b */
    const double t16 = p[19]*t15; /* a3/R*v_tau */
    const double t17 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t18 = t10*t15; /* 1/(K/m)*v_tau */
    const double t19 = JLT_FNMA(p[20], t18, x[2]); /* omega_n - 2*a3*1/(K/m)*v_tau */
    const double t20 = x[0]*t11; /* gamma3*omega_n*1/(K/m) */
    const double t21 = t10*t14; /* 1/(K/m)*s*omega3 */
    const double t22 = JLT_FNMA(p[23], t21, x[2]); /* omega_n - 2*R*a3*I3/I1*1/(K/m)*s*omega3 */
    const double t23 = JLT_FNMA(p[21], t20, t16); /* a3/R*v_tau - 2*a3*I1/m*gamma3*omega_n*1/(K/m) */
    const double t24 = JLT_FMA(t17, t19, t23); /* e*(omega_n - 2*a3*1/(K/m)*v_tau) + a3/R*v_tau - 2*a3*I1/m*gamma3*omega_n*1/(K/m) */
    const double t25 = JLT_FMA(p[22], t22, t24); /* I1/(m*R)*(omega_n - 2*R*a3*I3/I1*1/(K/m)*s*omega3) + t24 */
    const double t26 = t12*t25; /* R*omega_n*1/(K/m)*(I1/(m*R)*(omega_n - 2*R*a3*I3/I1*1/(K/m)*s*omega3) + t24) */
    const double t27 = JLT_FMA(x[1], x[1], p[25]); /* omega_tau*omega_tau + g/R */
    const double t28 = x[4]*t10; /* s*1/(K/m) */
    const double t29 = t27*t28; /* (omega_tau*omega_tau + g/R)*s*1/(K/m) */
    const double t30 = p[24]*t28; /* 2*R^2*a3^2*s*1/(K/m) */
    const double t31 = JLT_FMS(t29, t30, t26); /* (omega_tau*omega_tau + g/R)*s*1/(K/m)*2*R^2*a3^2*s*1/(K/m) - t26 */
    out[5] = t31;
    const double t32 = t1*p[26]; /* s*omega_tau*(-2*R*a3) */
    const double t33 = t28*t32; /* s*1/(K/m)*s*omega_tau*(-2*R*a3) */
    out[6] = t33;
    const double t34 = t20*p[27]; /* gamma3*omega_n*1/(K/m)*2*I1/m */
    const double t35 = JLT_FMA(t3, t11, t18); /* b*omega_n*1/(K/m) + 1/(K/m)*v_tau */
    const double t36 = JLT_FMA(t21, p[9], t34); /* 1/(K/m)*s*omega3*I3/m + gamma3*omega_n*1/(K/m)*2*I1/m */
    const double t37 = JLT_FMA(t17, t35, t36); /* e*(b*omega_n*1/(K/m) + 1/(K/m)*v_tau) + 1/(K/m)*s*omega3*I3/m + gamma3*omega_n*1/(K/m)*2*I1/m */
    const double t38 = -t37; /* -t37 */
    out[7] = t38;
    const double t39 = t17 + p[15]; /* e + I3/(m*R) */
    const double t40 = t12*t39; /* R*omega_n*1/(K/m)*(e + I3/(m*R)) */
    const double t41 = x[4]*t40; /* s*R*omega_n*1/(K/m)*(e + I3/(m*R)) */
    const double t42 = -t41; /* -s*R*omega_n*1/(K/m)*(e + I3/(m*R)) */
    out[8] = t42;
    const double t43 = x[3]*t40; /* omega3*R*omega_n*1/(K/m)*(e + I3/(m*R)) */
    const double t44 = JLT_FMA(p[13], t29, t43); /* 2*R*a3*(omega_tau*omega_tau + g/R)*s*1/(K/m) + omega3*R*omega_n*1/(K/m)*(e + I3/(m*R)) */
    const double t45 = -t44; /* -t44 */
    out[9] = t45;
    const double t46 = x[1]*x[2]; /* omega_tau*omega_n */
    const double t47 = t7*t9; /* 1/(Theta/(m*R^2*I1)) = K/m*1/(Theta/(m*R^2*I1)*K/m) */
    const double t48 = x[1]*t14; /* omega_tau*s*omega3 */
    const double t49 = t47*t48; /* 1/(Theta/(m*R^2*I1))*omega_tau*s*omega3 */
    const double t50 = t39*t47; /* (e + I3/(m*R))*1/(Theta/(m*R^2*I1)) */
    const double t51 = t3*p[29]; /* b*2*I3^2/(R^2*I1^2) */
    const double t52 = t49*t51; /* 1/(Theta/(m*R^2*I1))*omega_tau*s*omega3*b*2*I3^2/(R^2*I1^2) */
    const double t53 = JLT_FMA(p[28], t49, t46); /* a3*I3/(R*I1)*1/(Theta/(m*R^2*I1))*omega_tau*s*omega3 + omega_tau*omega_n */
    const double t54 = JLT_FNMA(t50, t52, t53); /* t53 - (e + I3/(m*R))*1/(Theta/(m*R^2*I1))*1/(Theta/(m*R^2*I1))*omega_tau*s*omega3*b*2*I3^2/(R^2*I1^2) */
    out[10] = t54;
    const double t55 = x[2]*x[0]; /* omega_n*gamma3 */
    const double t56 = t50*p[14]; /* (e + I3/(m*R))*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    const double t57 = JLT_FMA(t14, t56, t55); /* s*omega3*(e + I3/(m*R))*1/(Theta/(m*R^2*I1))*I3/(R*I1) + omega_n*gamma3 */
    out[11] = t57;
    const double t58 = x[1]*x[0]; /* omega_tau*gamma3 */
    out[12] = t58;
    const double t59 = t1*t56; /* s*omega_tau*(e + I3/(m*R))*1/(Theta/(m*R^2*I1))*I3/(R*I1) */
    out[13] = t59;
    const double t60 = x[1]*x[3]; /* omega_tau*omega3 */
    const double t61 = t56*t60; /* (e + I3/(m*R))*1/(Theta/(m*R^2*I1))*I3/(R*I1)*omega_tau*omega3 */
    const double t62 = x[4]*t49; /* s*1/(Theta/(m*R^2*I1))*omega_tau*s*omega3 */
    const double t63 = t47*t62; /* 1/(Theta/(m*R^2*I1))*s*1/(Theta/(m*R^2*I1))*omega_tau*s*omega3 */
    const double t64 = t17*p[30]; /* e*2*I3/(R*I1) */
    const double t65 = JLT_FNMA(t63, t64, t61); /* t61 - t63*e*2*I3/(R*I1) */
    const double t66 = JLT_FNMA(t63, p[31], t65); /* t61 - t63*e*2*I3/(R*I1) - t63*2*I3^2/(m*R^2*I1) */
    out[14] = t66;
    const double t67 = t62*p[32]; /* s*1/(Theta/(m*R^2*I1))*omega_tau*s*omega3*(I1 - I3)/I1 */
    const double t68 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t69 = t3*p[33]; /* b*2*I3/(R^2*I1^2) */
    const double t70 = t68*t69; /* (gamma3*R*(I1 - I3) - a3*I3)*b*2*I3/(R^2*I1^2) */
    const double t71 = JLT_FNMA(t63, t70, t67); /* s*1/(Theta/(m*R^2*I1))*omega_tau*s*omega3*(I1 - I3)/I1 - t63*(gamma3*R*(I1 - I3) - a3*I3)*b*2*I3/(R^2*I1^2) */
    out[15] = t71;
    const double t72 = x[4]*p[16]; /* s*1/(R*I1) */
    const double t73 = t68*t72; /* (gamma3*R*(I1 - I3) - a3*I3)*s*1/(R*I1) */
    const double t74 = t47*t73; /* 1/(Theta/(m*R^2*I1))*(gamma3*R*(I1 - I3) - a3*I3)*s*1/(R*I1) */
    const double t75 = t14*t74; /* s*omega3*1/(Theta/(m*R^2*I1))*(gamma3*R*(I1 - I3) - a3*I3)*s*1/(R*I1) */
    out[16] = t75;
    const double t76 = t1*t74; /* s*omega_tau*1/(Theta/(m*R^2*I1))*(gamma3*R*(I1 - I3) - a3*I3)*s*1/(R*I1) */
    out[18] = t76;
    const double t77 = JLT_FMS(x[4], t63, t49); /* s*t63 - 1/(Theta/(m*R^2*I1))*omega_tau*s*omega3 */
    const double t78 = t68*p[34]; /* (gamma3*R*(I1 - I3) - a3*I3)*(-2/(R*I1)) */
    const double t79 = t77*t78; /* (s*t63 - 1/(Theta/(m*R^2*I1))*omega_tau*s*omega3)*(gamma3*R*(I1 - I3) - a3*I3)*(-2/(R*I1)) */
    out[19] = t79;
    const double t80 = -t1; /* -s*omega_tau */
    out[20] = t80;
    const double t81 = x[4]*x[0]; /* s*gamma3 */
    const double t82 = -t81; /* -s*gamma3 */
    out[21] = t82;
    const double t83 = -t58; /* -omega_tau*gamma3 */
    out[24] = t83;
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
    const double t2 = p[39]*t0; /* m*I3*b */
    const double t3 = JLT_FMA(p[38], t1, p[37]); /* m*R^2*I1*s*s + I1*I3 */
    const double t4 = JLT_FMA(t0, t2, t3); /* Theta = b*m*I3*b + m*R^2*I1*s*s + I1*I3 */
    const double t5 = JLT_FMA(x[0], p[13], p[40]); /* gamma3*2*R*a3 + R^2 + a3^2 */
    const double t6 = JLT_FMA(p[0], t5, p[4]); /* K = m*(gamma3*2*R*a3 + R^2 + a3^2) + I1 */
    const double t7 = t4*t6; /* Theta*K */
    const double t8 = 1.0/t7; /* 1/(Theta*K) */
    const double t9 = t6*t8; /* 1/Theta = K*1/(Theta*K) */
    const double t10 = t4*t8; /* 1/K = Theta*1/(Theta*K) */
    const double t11 = x[2]*t0; /* omega_n*b */
    const double t12 = x[4]*x[3]; /* s*omega3 */
    const double t13 = x[4]*x[1]; /* s*omega_tau */
    const double t14 = x[4]*t13; /* s*s*omega_tau */
    out[0] = t14;
    const double t15 = 2.0*t13; /* 2*s*omega_tau */
    out[9] = t15;
    const double t16 = -t13; /* -s*omega_tau */
    out[25] = t16;
    const double t17 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t18 = JLT_FMA(p[1], t12, t11); /* v_tau = R*s*omega3 + omega_n*b */
    const double t19 = t17*t18; /* e*v_tau */
    const double t20 = JLT_FMA(p[9], t12, t19); /* I3/m*s*omega3 + e*v_tau */
    const double t21 = JLT_FMA(p[44], t18, x[2]); /* m*a3/I1*v_tau + omega_n */
    const double t22 = JLT_FMA(t11, t17, t20); /* omega_n*b*e + I3/m*s*omega3 + e*v_tau */
    const double t23 = p[35]*t13; /* m*R*a3*s*omega_tau */
    const double t24 = t13*t23; /* s*omega_tau*m*R*a3*s*omega_tau */
    const double t25 = JLT_FMA(p[36], t1, t24); /* m*g*a3*s*s + s*omega_tau*m*R*a3*s*omega_tau */
    const double t26 = x[2]*x[0]; /* omega_n*gamma3 */
    const double t27 = JLT_FMA(p[10], t26, t20); /* I1/m*omega_n*gamma3 + I3/m*s*omega3 + e*v_tau */
    const double t28 = p[0]*x[2]; /* m*omega_n */
    const double t29 = JLT_FMA(t27, t28, t25); /* (I1/m*omega_n*gamma3 + I3/m*s*omega3 + e*v_tau)*m*omega_n + m*g*a3*s*s + s*omega_tau*m*R*a3*s*omega_tau */
    const double t30 = t10*t29; /* 1/K*t29 */
    const double t31 = -t30; /* -1/K*t29 */
    out[1] = t31;
    const double t32 = p[43]*t30; /* 2*m*R*a3*1/K*t29 */
    const double t33 = x[3]*t13; /* omega3*s*omega_tau */
    const double t34 = p[43]*t13; /* 2*m*R*a3*s*omega_tau */
    const double t35 = p[15] + t17; /* I3/(m*R) + e */
    const double t36 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t37 = t9*t33; /* 1/Theta*omega3*s*omega_tau */
    const double t38 = x[2]*p[42]; /* omega_n*m*R */
    const double t39 = t17*t38; /* e*omega_n*m*R */
    const double t40 = JLT_FMA(p[4], t21, t39); /* I1*(m*a3/I1*v_tau + omega_n) + e*omega_n*m*R */
    const double t41 = JLT_FNMA(x[2], t40, t32); /* 2*m*R*a3*1/K*t29 - omega_n*(I1*(m*a3/I1*v_tau + omega_n) + e*omega_n*m*R) */
    const double t42 = t10*t41; /* 1/K*t41 */
    out[10] = t42;
    const double t43 = t35*t38; /* (I3/(m*R) + e)*omega_n*m*R */
    const double t44 = t9*t35; /* 1/Theta*(I3/(m*R) + e) */
    const double t45 = t9*t36; /* 1/Theta*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t46 = x[1]*t34; /* omega_tau*2*m*R*a3*s*omega_tau */
    const double t47 = JLT_FMA(x[4], p[46], t46); /* s*2*m*g*a3 + omega_tau*2*m*R*a3*s*omega_tau */
    const double t48 = JLT_FMA(x[3], t43, t47); /* omega3*(I3/(m*R) + e)*omega_n*m*R + s*2*m*g*a3 + omega_tau*2*m*R*a3*s*omega_tau */
    const double t49 = t10*t48; /* 1/K*t48 */
    const double t50 = -t49; /* -1/K*t48 */
    out[14] = t50;
    const double t51 = x[4]*t37; /* s*1/Theta*omega3*s*omega_tau */
    const double t52 = p[45]*t26; /* 2*I1*omega_n*gamma3 */
    const double t53 = JLT_FMA(p[0], t22, t52); /* m*(omega_n*b*e + I3/m*s*omega3 + e*v_tau) + 2*I1*omega_n*gamma3 */
    const double t54 = t10*t53; /* 1/K*t53 */
    const double t55 = -t54; /* -1/K*t53 */
    out[12] = t55;
    const double t56 = x[4]*t10; /* s*1/K */
    const double t57 = t34*t56; /* 2*m*R*a3*s*omega_tau*s*1/K */
    const double t58 = t43*t56; /* (I3/(m*R) + e)*omega_n*m*R*s*1/K */
    const double t59 = -t57; /* -2*m*R*a3*s*omega_tau*s*1/K */
    out[11] = t59;
    const double t60 = -t58; /* -(I3/(m*R) + e)*omega_n*m*R*s*1/K */
    out[13] = t60;
    const double t61 = x[1]*x[2]; /* omega_tau*omega_n */
    const double t62 = JLT_FMA(p[47], t37, t61); /* m*R*a3*I3*1/Theta*omega3*s*omega_tau + omega_tau*omega_n */
    const double t63 = p[48]*t0; /* 2*m^2*R^2*I3^2*b */
    const double t64 = p[51]*t0; /* 2*m^2*R^2*I3*b */
    const double t65 = t37*t63; /* 1/Theta*omega3*s*omega_tau*2*m^2*R^2*I3^2*b */
    const double t66 = JLT_FNMA(t44, t65, t62); /* m*R*a3*I3*1/Theta*omega3*s*omega_tau + omega_tau*omega_n - 1/Theta*(I3/(m*R) + e)*1/Theta*omega3*s*omega_tau*2*m^2*R^2*I3^2*b */
    out[15] = t66;
    const double t67 = p[41]*t44; /* m*R*I3*1/Theta*(I3/(m*R) + e) */
    const double t68 = t45*t64; /* 1/Theta*(gamma3*R*(I1 - I3) - a3*I3)*2*m^2*R^2*I3*b */
    const double t69 = x[4]*t45; /* s*1/Theta*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t70 = JLT_FMA(t12, t67, t26); /* s*omega3*m*R*I3*1/Theta*(I3/(m*R) + e) + omega_n*gamma3 */
    out[16] = t70;
    const double t71 = x[1]*t26; /* omega_tau*omega_n*gamma3 */
    const double t72 = JLT_FMA(t33, t67, t71); /* omega3*s*omega_tau*m*R*I3*1/Theta*(I3/(m*R) + e) + omega_tau*omega_n*gamma3 */
    out[2] = t72;
    const double t73 = t13*t67; /* s*omega_tau*m*R*I3*1/Theta*(I3/(m*R) + e) */
    out[18] = t73;
    const double t74 = x[1]*x[3]; /* omega_tau*omega3 */
    const double t75 = JLT_FNMA(p[49], t51, t74); /* omega_tau*omega3 - 2*m*R^2*I1*s*1/Theta*omega3*s*omega_tau */
    const double t76 = t67*t75; /* m*R*I3*1/Theta*(I3/(m*R) + e)*(omega_tau*omega3 - 2*m*R^2*I1*s*1/Theta*omega3*s*omega_tau) */
    out[19] = t76;
    const double t77 = p[52]*t51; /* 2*m^2*R^3*I1*s*1/Theta*omega3*s*omega_tau */
    const double t78 = t69*t77; /* s*1/Theta*(gamma3*R*(I1 - I3) - a3*I3)*2*m^2*R^3*I1*s*1/Theta*omega3*s*omega_tau */
    const double t79 = p[42]*t69; /* m*R*s*1/Theta*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t80 = t12*t79; /* s*omega3*m*R*s*1/Theta*(gamma3*R*(I1 - I3) - a3*I3) */
    out[21] = t80;
    const double t81 = t13*t79; /* s*omega_tau*m*R*s*1/Theta*(gamma3*R*(I1 - I3) - a3*I3) */
    out[23] = t81;
    const double t82 = x[0]*t13; /* gamma3*s*omega_tau */
    const double t83 = -t82; /* -gamma3*s*omega_tau */
    out[4] = t83;
    const double t84 = p[42]*t36; /* m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t85 = t51*t84; /* s*1/Theta*omega3*s*omega_tau*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    out[3] = t85;
    const double t86 = p[53]*t36; /* 2*m*R*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t87 = JLT_FMS(t37, t86, t78); /* 1/Theta*omega3*s*omega_tau*2*m*R*(gamma3*R*(I1 - I3) - a3*I3) - t78 */
    out[24] = t87;
    const double t88 = x[1]*x[0]; /* omega_tau*gamma3 */
    out[17] = t88;
    const double t89 = -t88; /* -omega_tau*gamma3 */
    out[29] = t89;
    const double t90 = p[50]*t51; /* m*R^2*(I1 - I3)*s*1/Theta*omega3*s*omega_tau */
    const double t91 = JLT_FNMA(t51, t68, t90); /* m*R^2*(I1 - I3)*s*1/Theta*omega3*s*omega_tau - s*1/Theta*omega3*s*omega_tau*1/Theta*(gamma3*R*(I1 - I3) - a3*I3)*2*m^2*R^2*I3*b */
    out[20] = t91;
    const double t92 = x[4]*x[0]; /* s*gamma3 */
    const double t93 = -t92; /* -s*gamma3 */
    out[26] = t93;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = JLT_FMA(p[13], x[0], p[12]); /* K/m = 2*R*a3*gamma3 + R^2 + a3^2 + I1/m */
    const double t2 = x[0] + p[19]; /* b/R = gamma3 + a3/R */
    const double t3 = p[54]*t2; /* I3/I1*b/R */
    const double t4 = t0 + p[6]; /* s*s + I3/(m*R^2) */
    const double t5 = JLT_FMA(t2, t3, t4); /* Theta/(m*R^2*I1) = b/R*I3/I1*b/R + s*s + I3/(m*R^2) */
    const double t6 = t1*t5; /* K/m*Theta/(m*R^2*I1) */
    const double t7 = JLT_FMS(x[0], p[17], p[18]); /* gamma3*R*(I1 - I3) - a3*I3 */
    const double t8 = t1*t7; /* K/m*(gamma3*R*(I1 - I3) - a3*I3) */
    const double t9 = JLT_FNMA(t5, p[55], t8); /* K/m*(gamma3*R*(I1 - I3) - a3*I3) - Theta/(m*R^2*I1)*2*R^2*a3*I1 */
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
    const double t9 = JLT_FMA(p[57], t0, t8); /* a3^2*s*s + e*e */
    const double t10 = p[36]*x[0]; /* m*g*a3*gamma3 */
    const double t11 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t12 = t9*t11; /* (a3^2*s*s + e*e)*omega_tau*omega_tau */
    const double t13 = JLT_FMA(x[2], x[2], t11); /* omega_n*omega_n + omega_tau*omega_tau */
    const double t14 = x[2]*t1; /* omega_n*b */
    const double t15 = p[1]*x[3]; /* R*omega3 */
    const double t16 = JLT_FMA(x[4], t15, t14); /* v_tau = s*R*omega3 + omega_n*b */
    const double t17 = JLT_FMA(t16, t16, t12); /* v_tau*v_tau + (a3^2*s*s + e*e)*omega_tau*omega_tau */
    const double t18 = x[3]*p[59]; /* omega3*1/2*I3 */
    const double t19 = JLT_FMA(x[3], t18, t10); /* omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t20 = JLT_FMA(p[58], t13, t19); /* 1/2*I1*(omega_n*omega_n + omega_tau*omega_tau) + omega3*omega3*1/2*I3 + m*g*a3*gamma3 */
    const double t21 = JLT_FMA(p[56], t17, t20); /* 1/2*m*(v_tau*v_tau + (a3^2*s*s + e*e)*omega_tau*omega_tau) + t20 */
    out[0] = t21;
    const double t22 = x[2]*p[60]; /* omega_n*R*I1 */
    const double t23 = x[4]*t22; /* s*omega_n*R*I1 */
    const double t24 = x[3]*p[5]; /* omega3*I3 */
    const double t25 = JLT_FNMA(t1, t24, t23); /* s*omega_n*R*I1 - b*omega3*I3 */
    out[1] = t25;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t1 = x[1]*x[1]; /* omega_tau*omega_tau */
    const double t2 = p[19]*t1; /* a3/R*omega_tau*omega_tau */
    const double t3 = t0*t2; /* e*a3/R*omega_tau*omega_tau */
    const double t4 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t5 = x[2]*t4; /* omega_n*b */
    const double t6 = p[1]*x[3]; /* R*omega3 */
    const double t7 = JLT_FMA(x[4], t6, t5); /* v_tau = s*R*omega3 + omega_n*b */
    const double t8 = JLT_FMA(x[2], t7, t3); /* omega_n*v_tau + e*a3/R*omega_tau*omega_tau */
    const double t9 = JLT_FMA(p[42], t8, p[36]); /* m*R*(omega_n*v_tau + e*a3/R*omega_tau*omega_tau) + m*g*a3 */
    out[0] = t9;
    const double t10 = t0*t0; /* e*e */
    const double t11 = x[4]*p[57]; /* s*a3^2 */
    const double t12 = JLT_FMA(x[4], t11, t10); /* s*s*a3^2 + e*e */
    const double t13 = x[1]*p[0]; /* omega_tau*m */
    const double t14 = t12*t13; /* (s*s*a3^2 + e*e)*omega_tau*m */
    const double t15 = JLT_FMA(x[1], p[4], t14); /* omega_tau*I1 + (s*s*a3^2 + e*e)*omega_tau*m */
    out[1] = t15;
    const double t16 = t4*p[0]; /* b*m */
    const double t17 = t7*t16; /* v_tau*b*m */
    const double t18 = JLT_FMA(x[2], p[4], t17); /* omega_n*I1 + v_tau*b*m */
    out[2] = t18;
    const double t19 = x[3]*p[5]; /* omega3*I3 */
    const double t20 = p[42]*x[4]; /* m*R*s */
    const double t21 = JLT_FMA(t7, t20, t19); /* v_tau*m*R*s + omega3*I3 */
    out[3] = t21;
    const double t22 = t1*t11; /* omega_tau*omega_tau*s*a3^2 */
    const double t23 = JLT_FMA(t6, t7, t22); /* R*omega3*v_tau + omega_tau*omega_tau*s*a3^2 */
    const double t24 = p[0]*t23; /* m*(R*omega3*v_tau + omega_tau*omega_tau*s*a3^2) */
    out[4] = t24;
    const double t25 = x[3]*p[61]; /* omega3*(-R*I3) */
    out[5] = t25;
    out[6] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    const double t26 = x[4]*p[60]; /* s*R*I1 */
    out[7] = t26;
    const double t27 = t4*p[62]; /* b*(-I3) */
    out[8] = t27;
    const double t28 = x[2]*p[60]; /* omega_n*R*I1 */
    out[9] = t28;
    const double t29 = x[4]*p[38]; /* s*m*R^2*I1 */
    const double t30 = t4*p[39]; /* b*m*I3 */
    const double t31 = JLT_FMA(x[4], t29, p[37]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t32 = JLT_FMA(t4, t30, t31); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t33 = sqrt(t32); /* h = sqrt(Theta) */
    out[13] = t33;
    const double t34 = x[3]/t33; /* omega3/h */
    const double t35 = t4*p[41]; /* b*m*R*I3 */
    const double t36 = t34*t35; /* omega3/h*b*m*R*I3 */
    out[10] = t36;
    const double t37 = t29*t34; /* s*m*R^2*I1*omega3/h */
    out[14] = t37;
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
    double t5[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t46[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x4, x1, k);
        t3[k] = jlt_jet_product(x4, t2, k);
        t5[k] = jlt_jet_product(x4, x4, k);
        t10[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t11[k] = p[7]*t10[k];
        t12[k] = (k == 0 ? p[6] : 0) + t5[k];
        t13[k] = jlt_jet_product(t10, t11, k) + t12[k];
        t15[k] = t2[k]*p[8];
        t16[k] = jlt_jet_product(t2, t15, k);
        t20[k] = jlt_jet_product(x4, x3, k);
        t21[k] = p[9]*t20[k];
        t22[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t23[k] = jlt_jet_product(t10, x2, k);
        t24[k] = p[1]*t20[k] + t23[k];
        t26[k] = jlt_jet_product(x0, x2, k);
        t27[k] = p[10]*t26[k] + t21[k];
        t28[k] = jlt_jet_product(t22, t24, k) + t27[k];
        t30[k] = t5[k]*p[11] + t16[k];
        t31[k] = jlt_jet_product(x2, t28, k) + t30[k];
        t34[k] = x0[k]*p[13] + (k == 0 ? p[12] : 0);
        t35[k] = jlt_jet_product(t13, t34, k);
        t37[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t35, t37, k);
        t38[k] = jlt_jet_product(t13, t31, k);
        t39[k] = jlt_jet_product(t37, t38, k);
        t40[k] = -t39[k];
        t41[k] = jlt_jet_product(x1, t26, k);
        t43[k] = jlt_jet_product(t2, t34, k);
        t44[k] = jlt_jet_product(t37, t43, k);
        t46[k] = t22[k] + (k == 0 ? p[15] : 0);
        t47[k] = x3[k]*p[14];
        t48[k] = jlt_jet_product(t46, t47, k);
        t49[k] = jlt_jet_product(t44, t48, k) + t41[k];
        t53[k] = x0[k]*p[17] - (k == 0 ? p[18] : 0);
        t54[k] = t20[k]*p[16];
        t55[k] = jlt_jet_product(t53, t54, k);
        t56[k] = jlt_jet_product(t44, t55, k);
        t57[k] = jlt_jet_product(t2, x0, k);
        t58[k] = -t57[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t40[k]/(k + 1);
        next[2] = x2[k + 1] = t49[k]/(k + 1);
        next[3] = x3[k + 1] = t56[k]/(k + 1);
        next[4] = x4[k + 1] = t58[k]/(k + 1);
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

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "omega_tau", "rad/s", "angular velocity along tau, the rate of tilting", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega_n", "rad/s", "angular velocity along n", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "omega3", "rad/s", "angular velocity along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "R", "m", "radius of the sphere", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "g", "m/s^2", "acceleration of gravity", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0 },
    { "a3", "m", "displacement of the centre of mass along the symmetry axis", -INFINITY, INFINITY, JLT_ANY_SIGN, (51.0 / 100.0) },
    { "I1", "kg*m^2", "equatorial moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, (1.0 / 3.0) },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 3.0) },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "Jellett", "" },
    { "Routh", "" },
};

const jlt_descriptor jlt_kernels_routh_sphere_general_in_regular = {
    .model = "routh_sphere",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Sphere with displaced centre of mass rolling without slipping, reduced system",
    .source = "E. J. Routh, The Advanced Part of a Treatise on the Dynamics of a System of Rigid Bodies, 6th ed., 1905, sec. 243",
    .sha256 = "7ea5d7e192247bbb71a43cf42803dc35e835526f39f8f2b9ef8220743e084b9e",
    .generator = "ttc 0.1.0",
    .table = jlt_table_routh_sphere,
    .state_count = 5, .param_count = 6, .block_count = 63,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 4, 21, 11, 1, 0, 0, 8, 10 }, { 18, 64, 0, 8, 0, 0, 12, 8 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes" },
    .jacobian = { jacobian, 25, { 8, 51, 24, 1, 0, 0, 13, 16 }, { 50, 259, 0, 36, 0, 0, 16, 8 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 57, 26, 1, 0, 0, 11, 17 }, { 60, 303, 0, 44, 0, 0, 16, 10 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes" },
    .divergence = { divergence, 1, { 2, 7, 4, 1, 0, 0, 6, 6 }, { 9, 30, 0, 2, 0, 0, 9, 6 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are; divides by K: grows without bound, and so do rounding errors, where it vanishes" },
    .integral_values = { integral_values, 3, { 0, 13, 12, 0, 1, 0, 6, 7 }, { 12, 41, 0, 0, 1, 0, 12, 6 },
        "takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .integral_gradients = { integral_gradients, 15, { 0, 24, 12, 1, 1, 0, 6, 8 }, { 14, 60, 0, 2, 1, 0, 8, 8 },
        "divides by h: grows without bound, and so do rounding errors, where it vanishes; takes h = sqrt(Theta): a rounding error of the states counts without bound where that vanishes" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 3, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_routh_sphere_general_in_regular_baseline,
        &jlt_batch_routh_sphere_general_in_regular_avx2,
        &jlt_batch_routh_sphere_general_in_regular_avx512,
    },
};
