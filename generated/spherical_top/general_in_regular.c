/* Spherical top rolling on a plane with one nonholonomic constraint, reduced system
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top, SHA-256 f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd
 *  Command:    ttc generate --out DIR spherical_top.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   25   15    1    0    0     10   10   (105)
 *  jacobian            9   76   33    1    0    0     13   19   (480)
 *  rhs_jacobian        11   82   40    1    0    0     14   27   (563)
 *  divergence          0   11    9    1    0    0      9    7   (53)
 *  integral_values     0   12    9    0    0    0      5    8   (40)
 *  integral_gradients  0   15    7    0    0    0      5    7   (46)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top[];
extern const jlt_descriptor jlt_kernels_spherical_top_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_general_in_regular_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    const double t0 = -params[4]; /* -I1 */
    const double t1 = params[4]*params[5]; /* I1*I3 */
    const double t2 = params[1]*params[1]; /* R*R */
    const double t3 = params[0]*t2; /* m*R*R */
    const double t4 = params[4]*t3; /* I1*m*R*R */
    const double t5 = params[5]*params[0]; /* I3*m */
    const double t6 = params[0]*params[2]; /* m*g */
    const double t7 = t6*params[3]; /* m*g*a3 */
    const double t8 = t7/params[4]; /* m*g*a3/I1 */
    const double t9 = params[5]/params[4]; /* I3/I1 */
    const double t10 = params[3]*params[3]; /* a3*a3 */
    const double t11 = params[0]*t10; /* m*a3*a3 */
    const double t12 = t11/params[4]; /* m*a3*a3/I1 */
    const double t13 = params[5]*params[5]; /* I3*I3 */
    const double t14 = params[0]*params[1]; /* m*R */
    const double t15 = params[5]*t14; /* I3*m*R */
    const double t16 = params[4]*t14; /* I1*m*R */
    const double t17 = -t16; /* -I1*m*R */
    const double t18 = 1.0/params[4]; /* 1/I1 */
    const double t19 = params[5]*params[3]; /* I3*a3 */
    const double t20 = params[4] - params[5]; /* I1 - I3 */
    const double t21 = params[1]*t20; /* R*(I1 - I3) */
    const double t22 = params[0]*2.0; /* m*2 */
    const double t23 = t10*t22; /* a3*a3*m*2 */
    const double t24 = params[4]*2.0; /* I1*2 */
    const double t25 = -params[5]; /* -I3 */
    const double t26 = params[4]*t23; /* I1*a3*a3*m*2 */
    const double t27 = params[5]*t23; /* I3*a3*a3*m*2 */
    const double t28 = params[3]*t14; /* a3*m*R */
    const double t29 = params[5]*t28; /* I3*a3*m*R */
    const double t30 = params[0]*params[3]; /* m*a3 */
    const double t31 = params[5]*t30; /* I3*m*a3 */
    const double t32 = t13*t14; /* I3*I3*m*R */
    const double t33 = params[1]*t22; /* R*m*2 */
    const double t34 = params[5]*2.0; /* I3*2 */
    const double t35 = params[5]*t4; /* I3*I1*m*R*R */
    const double t36 = params[0]*params[0]; /* m*m */
    const double t37 = 2.0*t36; /* 2*m*m */
    const double t38 = t2*t37; /* R*R*2*m*m */
    const double t39 = params[4]*t38; /* I1*R*R*2*m*m */
    const double t40 = params[5]*t39; /* I3*I1*R*R*2*m*m */
    const double t41 = params[4]*t28; /* I1*a3*m*R */
    const double t42 = t3*t20; /* m*R*R*(I1 - I3) */
    const double t43 = t2*t36; /* R*R*m*m */
    const double t44 = params[5]*t43; /* I3*R*R*m*m */
    const double t45 = params[3]*2.0; /* a3*2 */
    const double t46 = params[5]*t45; /* I3*a3*2 */
    const double t47 = params[1]*2.0; /* R*2 */
    const double t48 = t20*t47; /* (I1 - I3)*R*2 */
    const double t49 = params[1]*t2; /* R*R*R */
    const double t50 = t37*t49; /* 2*m*m*R*R*R */
    const double t51 = params[4]*params[4]; /* I1*I1 */
    const double t52 = t50*t51; /* 2*m*m*R*R*R*I1*I1 */
    const double t53 = t36*t49; /* m*m*R*R*R */
    const double t54 = params[4]*t53; /* I1*m*m*R*R*R */
    const double t55 = t10*2.0; /* a3*a3*2 */
    const double t56 = t55/params[1]; /* a3*a3*2/R */
    const double t57 = params[0]/2.0; /* m/2 */
    const double t58 = params[4]/2.0; /* I1/2 */
    const double t59 = params[5]/2.0; /* I3/2 */
    const double t60 = params[4]*params[1]; /* I1*R */
    const double t61 = params[5]*params[1]; /* I3*R */
    const double t62 = -t61; /* -I3*R */
    out[6] = t0;
    out[7] = t1;
    out[8] = t4;
    out[9] = t5;
    out[10] = t8;
    out[11] = t9;
    out[12] = t12;
    out[13] = t11;
    out[14] = t13;
    out[15] = t15;
    out[16] = t17;
    out[17] = t18;
    out[18] = t19;
    out[19] = t21;
    out[20] = t23;
    out[21] = t24;
    out[22] = t25;
    out[23] = t7;
    out[24] = t26;
    out[25] = t27;
    out[26] = t29;
    out[27] = t31;
    out[28] = t32;
    out[29] = t33;
    out[30] = t22;
    out[31] = t34;
    out[32] = t14;
    out[33] = t35;
    out[34] = t40;
    out[35] = t41;
    out[36] = t42;
    out[37] = t44;
    out[38] = t46;
    out[39] = t48;
    out[40] = t16;
    out[41] = t52;
    out[42] = t54;
    out[43] = t30;
    out[44] = t47;
    out[45] = t56;
    out[46] = t57;
    out[47] = t58;
    out[48] = t59;
    out[49] = t60;
    out[50] = t62;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[2]; /* s*omega_tau */
    const double t1 = x[5]*t0; /* s*s*omega_tau */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[5]*x[4]; /* s*omega3 */
    const double t5 = JLT_FMA(p[1], t4, t3); /* R*s*omega3 + omega_n*b */
    const double t6 = x[3]*t5; /* omega_n*(R*s*omega3 + omega_n*b) */
    const double t7 = x[5]*x[5]; /* s*s */
    const double t8 = t2*p[9]; /* b*m*I3 */
    const double t9 = JLT_FMA(p[8], t7, p[7]); /* m*R^2*I1*s*s + I1*I3 */
    const double t10 = JLT_FMA(t2, t8, t9); /* Theta = b*b*m*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t11 = t7*p[10]; /* s*s*m*g*a3/I1 */
    const double t12 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t13 = JLT_FMA(t4, p[11], t12); /* s*omega3*I3/I1 + omega_n*gamma3 */
    const double t14 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t15 = t0*p[12]; /* s*omega_tau*m*a3^2/I1 */
    const double t16 = JLT_FNMA(t14, t15, t11); /* s*s*m*g*a3/I1 - s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 */
    const double t17 = JLT_FMA(x[3], t13, t16); /* omega_n*(s*omega3*I3/I1 + omega_n*gamma3) + s*s*m*g*a3/I1 - s*omega_tau*gamma3*s*omega_tau*m*a3^2/I1 */
    const double t18 = JLT_FMA(t7, p[13], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t19 = t10*t18; /* Theta*D */
    const double t20 = 1.0/t19; /* 1/(Theta*D) */
    const double t21 = p[6]*t10; /* (-I1)*Theta */
    const double t22 = t17*t21; /* t17*(-I1)*Theta */
    const double t23 = t20*t22; /* 1/(Theta*D)*t17*(-I1)*Theta */
    const double t24 = x[2]*t12; /* omega_tau*omega_n*gamma3 */
    const double t25 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t26 = JLT_FMA(x[2], t25, x[1]); /* V = omega_tau*e + v_nu */
    const double t27 = t18*t20; /* D*1/(Theta*D) */
    const double t28 = x[3]*t26; /* omega_n*V */
    const double t29 = t27*t28; /* D*1/(Theta*D)*omega_n*V */
    const double t30 = t0*x[4]; /* s*omega_tau*omega3 */
    const double t31 = t27*t30; /* D*1/(Theta*D)*s*omega_tau*omega3 */
    const double t32 = t25*p[15]; /* e*m*R*I3 */
    const double t33 = JLT_FNMA(t8, t29, t24); /* omega_tau*omega_n*gamma3 - b*m*I3*D*1/(Theta*D)*omega_n*V */
    const double t34 = JLT_FMA(p[14], t31, t33); /* I3^2*D*1/(Theta*D)*s*omega_tau*omega3 + omega_tau*omega_n*gamma3 - b*m*I3*D*1/(Theta*D)*omega_n*V */
    const double t35 = JLT_FMA(t31, t32, t34); /* D*1/(Theta*D)*s*omega_tau*omega3*e*m*R*I3 + t34 */
    const double t36 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t37 = p[17]*t36; /* 1/I1*(a3*I3 - gamma3*R*(I1 - I3)) */
    const double t38 = JLT_FMA(t31, t37, t29); /* D*1/(Theta*D)*s*omega_tau*omega3*1/I1*(a3*I3 - gamma3*R*(I1 - I3)) + D*1/(Theta*D)*omega_n*V */
    const double t39 = x[5]*p[16]; /* s*(-m*R*I1) */
    const double t40 = t38*t39; /* t38*s*(-m*R*I1) */
    const double t41 = -t14; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t6;
    out[2] = t23;
    out[3] = t35;
    out[4] = t40;
    out[5] = t41;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = x[5]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[3]*p[1]; /* omega_n*R */
    const double t4 = x[3]*t3; /* omega_n*omega_n*R */
    const double t5 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t6 = 2.0*x[3]; /* 2*omega_n */
    const double t7 = t5*t6; /* b*2*omega_n */
    const double t8 = x[5]*p[1]; /* s*R */
    const double t9 = JLT_FMA(x[4], t8, t7); /* omega3*s*R + b*2*omega_n */
    const double t10 = x[5]*t3; /* s*omega_n*R */
    const double t11 = t3*x[4]; /* omega_n*R*omega3 */
    const double t12 = t5*p[9]; /* b*m*I3 */
    const double t13 = JLT_FMA(t0, p[8], p[7]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t14 = JLT_FMA(t5, t12, t13); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t15 = JLT_FMA(t0, p[13], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t16 = t14*t15; /* Theta*D */
    const double t17 = 1.0/t16; /* 1/(Theta*D) */
    const double t18 = t14*t17; /* Theta*1/(Theta*D) */
    const double t19 = x[5]*t18; /* s*Theta*1/(Theta*D) */
    const double t20 = x[2]*p[13]; /* omega_tau*m*a3^2 */
    const double t21 = t19*t20; /* s*Theta*1/(Theta*D)*omega_tau*m*a3^2 */
    const double t22 = t1*t21; /* s*omega_tau*s*Theta*1/(Theta*D)*omega_tau*m*a3^2 */
    const double t23 = x[3]*t18; /* omega_n*Theta*1/(Theta*D) */
    const double t24 = x[3]*p[4]; /* omega_n*I1 */
    const double t25 = JLT_FNMA(t23, t24, t22); /* s*omega_tau*s*Theta*1/(Theta*D)*omega_tau*m*a3^2 - omega_n*Theta*1/(Theta*D)*omega_n*I1 */
    const double t26 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t27 = x[5]*p[20]; /* s*2*m*a3^2 */
    const double t28 = t19*t27; /* s*Theta*1/(Theta*D)*s*2*m*a3^2 */
    const double t29 = t26*t28; /* omega_tau*gamma3*s*Theta*1/(Theta*D)*s*2*m*a3^2 */
    const double t30 = x[0]*p[21]; /* gamma3*2*I1 */
    const double t31 = t23*t30; /* omega_n*Theta*1/(Theta*D)*gamma3*2*I1 */
    const double t32 = x[4]*p[5]; /* omega3*I3 */
    const double t33 = JLT_FMA(t19, t32, t31); /* s*Theta*1/(Theta*D)*omega3*I3 + omega_n*Theta*1/(Theta*D)*gamma3*2*I1 */
    const double t34 = -t33; /* -t33 */
    const double t35 = x[3]*t19; /* omega_n*s*Theta*1/(Theta*D) */
    const double t36 = p[22]*t35; /* (-I3)*omega_n*s*Theta*1/(Theta*D) */
    const double t37 = 2.0 - t28; /* 2 - s*Theta*1/(Theta*D)*s*2*m*a3^2 */
    const double t38 = t19*p[23]; /* s*Theta*1/(Theta*D)*m*g*a3 */
    const double t39 = JLT_FNMA(t21, t26, t38); /* s*Theta*1/(Theta*D)*m*g*a3 - s*Theta*1/(Theta*D)*omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t40 = t37*t39; /* (2 - s*Theta*1/(Theta*D)*s*2*m*a3^2)*t39 */
    const double t41 = x[0]*p[24]; /* gamma3*2*m*a3^2*I1 */
    const double t42 = JLT_FMS(t35, t41, t32); /* omega_n*s*Theta*1/(Theta*D)*gamma3*2*m*a3^2*I1 - omega3*I3 */
    const double t43 = x[4]*p[25]; /* omega3*2*m*a3^2*I3 */
    const double t44 = t19*t43; /* s*Theta*1/(Theta*D)*omega3*2*m*a3^2*I3 */
    const double t45 = JLT_FMS(t35, t44, t40); /* omega_n*s*Theta*1/(Theta*D)*s*Theta*1/(Theta*D)*omega3*2*m*a3^2*I3 - (2 - s*Theta*1/(Theta*D)*s*2*m*a3^2)*t39 */
    const double t46 = JLT_FMA(t23, t42, t45); /* omega_n*Theta*1/(Theta*D)*(omega_n*s*Theta*1/(Theta*D)*gamma3*2*m*a3^2*I1 - omega3*I3) + t45 */
    const double t47 = t15*t17; /* D*1/(Theta*D) */
    const double t48 = x[5]*t47; /* s*D*1/(Theta*D) */
    const double t49 = x[2]*t48; /* omega_tau*s*D*1/(Theta*D) */
    const double t50 = x[4]*t49; /* omega3*omega_tau*s*D*1/(Theta*D) */
    const double t51 = p[26]*t50; /* m*R*a3*I3*omega3*omega_tau*s*D*1/(Theta*D) */
    const double t52 = t5*t47; /* b*D*1/(Theta*D) */
    const double t53 = x[3]*t52; /* omega_n*b*D*1/(Theta*D) */
    const double t54 = JLT_FNMA(p[27], t53, x[3]); /* omega_n - m*a3*I3*omega_n*b*D*1/(Theta*D) */
    const double t55 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t56 = JLT_FMA(x[2], t55, x[1]); /* V = omega_tau*e + v_nu */
    const double t57 = t47*t56; /* D*1/(Theta*D)*V */
    const double t58 = x[3]*p[15]; /* omega_n*m*R*I3 */
    const double t59 = t55*p[29]; /* e*2*m*R */
    const double t60 = t50*t59; /* omega3*omega_tau*s*D*1/(Theta*D)*e*2*m*R */
    const double t61 = t56*p[30]; /* V*2*m */
    const double t62 = JLT_FNMA(t53, t61, t60); /* omega3*omega_tau*s*D*1/(Theta*D)*e*2*m*R - omega_n*b*D*1/(Theta*D)*V*2*m */
    const double t63 = JLT_FMA(t50, p[31], t62); /* omega3*omega_tau*s*D*1/(Theta*D)*2*I3 + t62 */
    const double t64 = t52*p[28]; /* b*D*1/(Theta*D)*m*R*I3^2 */
    const double t65 = JLT_FNMA(t57, t58, t51); /* m*R*a3*I3*omega3*omega_tau*s*D*1/(Theta*D) - D*1/(Theta*D)*V*omega_n*m*R*I3 */
    const double t66 = JLT_FMA(x[2], t54, t65); /* omega_tau*(omega_n - m*a3*I3*omega_n*b*D*1/(Theta*D)) + t65 */
    const double t67 = JLT_FNMA(t63, t64, t66); /* omega_tau*(omega_n - m*a3*I3*omega_n*b*D*1/(Theta*D)) + t65 - (omega3*omega_tau*s*D*1/(Theta*D)*2*I3 + t62)*b*D*1/(Theta*D)*m*R*I3^2 */
    const double t68 = p[9]*t53; /* m*I3*omega_n*b*D*1/(Theta*D) */
    const double t69 = -t68; /* -m*I3*omega_n*b*D*1/(Theta*D) */
    const double t70 = x[3]*x[0]; /* omega_n*gamma3 */
    const double t71 = JLT_FMA(t55, p[32], p[5]); /* e*m*R + I3 */
    const double t72 = t32*t71; /* omega3*I3*(e*m*R + I3) */
    const double t73 = JLT_FMA(t48, t72, t70); /* s*D*1/(Theta*D)*omega3*I3*(e*m*R + I3) + omega_n*gamma3 */
    const double t74 = JLT_FNMA(t55, t68, t73); /* s*D*1/(Theta*D)*omega3*I3*(e*m*R + I3) + omega_n*gamma3 - e*m*I3*omega_n*b*D*1/(Theta*D) */
    const double t75 = p[9]*t56; /* m*I3*V */
    const double t76 = JLT_FNMA(t52, t75, t26); /* omega_tau*gamma3 - b*D*1/(Theta*D)*m*I3*V */
    const double t77 = p[5]*t71; /* I3*(e*m*R + I3) */
    const double t78 = t49*t77; /* omega_tau*s*D*1/(Theta*D)*I3*(e*m*R + I3) */
    const double t79 = x[2]*t72; /* omega_tau*omega3*I3*(e*m*R + I3) */
    const double t80 = t47*t79; /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) */
    const double t81 = t48*p[33]; /* s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t82 = JLT_FNMA(t63, t81, t80); /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) - (omega3*omega_tau*s*D*1/(Theta*D)*2*I3 + t62)*s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t83 = t48*t56; /* s*D*1/(Theta*D)*V */
    const double t84 = t53*p[34]; /* omega_n*b*D*1/(Theta*D)*2*m^2*R^2*I1*I3 */
    const double t85 = t83*t84; /* s*D*1/(Theta*D)*V*omega_n*b*D*1/(Theta*D)*2*m^2*R^2*I1*I3 */
    const double t86 = x[3]*p[35]; /* omega_n*m*R*a3*I1 */
    const double t87 = x[5]*p[36]; /* s*m*R^2*(I1 - I3) */
    const double t88 = JLT_FNMA(x[0], p[39], p[38]); /* 2*a3*I3 - gamma3*2*R*(I1 - I3) */
    const double t89 = t50*t88; /* omega3*omega_tau*s*D*1/(Theta*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t90 = t48*t89; /* s*D*1/(Theta*D)*t89 */
    const double t91 = t5*p[37]; /* b*m^2*R^2*I3 */
    const double t92 = JLT_FNMA(t49, t86, t85); /* s*D*1/(Theta*D)*V*omega_n*b*D*1/(Theta*D)*2*m^2*R^2*I1*I3 - omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t93 = JLT_FMA(t50, t87, t92); /* omega3*omega_tau*s*D*1/(Theta*D)*s*m*R^2*(I1 - I3) + t92 */
    const double t94 = JLT_FMA(t90, t91, t93); /* s*D*1/(Theta*D)*t89*b*m^2*R^2*I3 + omega3*omega_tau*s*D*1/(Theta*D)*s*m*R^2*(I1 - I3) + t92 */
    const double t95 = x[3]*p[40]; /* omega_n*m*R*I1 */
    const double t96 = t48*t95; /* s*D*1/(Theta*D)*omega_n*m*R*I1 */
    const double t97 = -t96; /* -s*D*1/(Theta*D)*omega_n*m*R*I1 */
    const double t98 = t55*t96; /* e*s*D*1/(Theta*D)*omega_n*m*R*I1 */
    const double t99 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t100 = x[5]*p[32]; /* s*m*R */
    const double t101 = t99*t100; /* (a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t102 = x[4]*t101; /* omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t103 = JLT_FMA(t48, t102, t98); /* s*D*1/(Theta*D)*omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R + e*s*D*1/(Theta*D)*omega_n*m*R*I1 */
    const double t104 = -t103; /* -t103 */
    const double t105 = t83*p[16]; /* s*D*1/(Theta*D)*V*(-m*R*I1) */
    const double t106 = t49*t101; /* omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t107 = -t106; /* -omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t108 = t57*t95; /* D*1/(Theta*D)*V*omega_n*m*R*I1 */
    const double t109 = x[3]*p[41]; /* omega_n*2*m^2*R^3*I1^2 */
    const double t110 = t48*t109; /* s*D*1/(Theta*D)*omega_n*2*m^2*R^3*I1^2 */
    const double t111 = x[5]*p[42]; /* s*m^2*R^3*I1 */
    const double t112 = JLT_FMS(t83, t110, t108); /* s*D*1/(Theta*D)*V*s*D*1/(Theta*D)*omega_n*2*m^2*R^3*I1^2 - D*1/(Theta*D)*V*omega_n*m*R*I1 */
    const double t113 = JLT_FNMA(p[32], t89, t112); /* t112 - m*R*t89 */
    const double t114 = JLT_FMA(t90, t111, t113); /* s*D*1/(Theta*D)*t89*s*m^2*R^3*I1 + t112 - m*R*t89 */
    const double t115 = -t1; /* -s*omega_tau */
    const double t116 = x[5]*x[0]; /* s*gamma3 */
    const double t117 = -t116; /* -s*gamma3 */
    const double t118 = -t26; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = t2;
    out[6] = t4;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t9;
    out[10] = t10;
    out[11] = t11;
    out[12] = t25;
    out[13] = 0.0;
    out[14] = t29;
    out[15] = t34;
    out[16] = t36;
    out[17] = t46;
    out[18] = t67;
    out[19] = t69;
    out[20] = t74;
    out[21] = t76;
    out[22] = t78;
    out[23] = t82;
    out[24] = t94;
    out[25] = t97;
    out[26] = t104;
    out[27] = t105;
    out[28] = t107;
    out[29] = t114;
    out[30] = t115;
    out[31] = 0.0;
    out[32] = t117;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = t118;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[2]; /* s*omega_tau */
    const double t1 = x[5]*t0; /* s*s*omega_tau */
    const double t2 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = x[3]*t3; /* omega_n*omega_n*b */
    const double t5 = x[3]*p[1]; /* omega_n*R */
    const double t6 = x[5]*t5; /* s*omega_n*R */
    const double t7 = JLT_FMA(x[4], t6, t4); /* omega3*s*omega_n*R + omega_n*omega_n*b */
    const double t8 = x[5]*x[5]; /* s*s */
    const double t9 = t2*p[9]; /* b*m*I3 */
    const double t10 = JLT_FMA(p[8], t8, p[7]); /* m*R^2*I1*s*s + I1*I3 */
    const double t11 = JLT_FMA(t2, t9, t10); /* Theta = b*b*m*I3 + m*R^2*I1*s*s + I1*I3 */
    const double t12 = JLT_FMA(t8, p[13], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t13 = t11*t12; /* Theta*D */
    const double t14 = 1.0/t13; /* 1/(Theta*D) */
    const double t15 = t11*t14; /* Theta*1/(Theta*D) */
    const double t16 = x[5]*t15; /* s*Theta*1/(Theta*D) */
    const double t17 = t0*t16; /* s*omega_tau*s*Theta*1/(Theta*D) */
    const double t18 = x[2]*p[12]; /* omega_tau*m*a3^2/I1 */
    const double t19 = t17*t18; /* s*omega_tau*s*Theta*1/(Theta*D)*omega_tau*m*a3^2/I1 */
    const double t20 = x[3]*t15; /* omega_n*Theta*1/(Theta*D) */
    const double t21 = JLT_FNMA(x[3], t20, t19); /* s*omega_tau*s*Theta*1/(Theta*D)*omega_tau*m*a3^2/I1 - omega_n*omega_n*Theta*1/(Theta*D) */
    const double t22 = p[4]*t21; /* I1*t21 */
    const double t23 = x[0]*t22; /* gamma3*I1*t21 */
    const double t24 = x[5]*t16; /* s*s*Theta*1/(Theta*D) */
    const double t25 = x[4]*p[5]; /* omega3*I3 */
    const double t26 = x[3]*t16; /* omega_n*s*Theta*1/(Theta*D) */
    const double t27 = JLT_FNMA(p[23], t24, t23); /* gamma3*I1*t21 - m*g*a3*s*s*Theta*1/(Theta*D) */
    const double t28 = JLT_FNMA(t25, t26, t27); /* gamma3*I1*t21 - m*g*a3*s*s*Theta*1/(Theta*D) - omega3*I3*omega_n*s*Theta*1/(Theta*D) */
    const double t29 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t30 = x[3]*t29; /* omega_n*omega_tau*gamma3 */
    const double t31 = JLT_FMA(p[3], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t32 = JLT_FMA(x[2], t31, x[1]); /* V = omega_tau*e + v_nu */
    const double t33 = x[3]*t32; /* omega_n*V */
    const double t34 = t12*t14; /* D*1/(Theta*D) */
    const double t35 = t2*t34; /* b*D*1/(Theta*D) */
    const double t36 = p[9]*t35; /* m*I3*b*D*1/(Theta*D) */
    const double t37 = x[5]*t34; /* s*D*1/(Theta*D) */
    const double t38 = x[2]*t37; /* omega_tau*s*D*1/(Theta*D) */
    const double t39 = x[4]*t38; /* omega3*omega_tau*s*D*1/(Theta*D) */
    const double t40 = JLT_FMA(t31, p[32], p[5]); /* e*m*R + I3 */
    const double t41 = p[5]*t40; /* I3*(e*m*R + I3) */
    const double t42 = JLT_FNMA(t33, t36, t30); /* omega_n*omega_tau*gamma3 - omega_n*V*m*I3*b*D*1/(Theta*D) */
    const double t43 = JLT_FMA(t39, t41, t42); /* omega3*omega_tau*s*D*1/(Theta*D)*I3*(e*m*R + I3) + omega_n*omega_tau*gamma3 - omega_n*V*m*I3*b*D*1/(Theta*D) */
    const double t44 = t37*p[40]; /* s*D*1/(Theta*D)*m*R*I1 */
    const double t45 = t33*t44; /* omega_n*V*s*D*1/(Theta*D)*m*R*I1 */
    const double t46 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t47 = x[5]*p[32]; /* s*m*R */
    const double t48 = t46*t47; /* (a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t49 = JLT_FMA(t39, t48, t45); /* omega3*omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R + omega_n*V*s*D*1/(Theta*D)*m*R*I1 */
    const double t50 = -t49; /* -t49 */
    const double t51 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t52 = -t51; /* -s*omega_tau*gamma3 */
    const double t53 = t0*2.0; /* s*omega_tau*2 */
    const double t54 = x[3]*t5; /* omega_n*omega_n*R */
    const double t55 = t3*2.0; /* omega_n*b*2 */
    const double t56 = x[5]*p[1]; /* s*R */
    const double t57 = JLT_FMA(x[4], t56, t55); /* omega3*s*R + omega_n*b*2 */
    const double t58 = x[4]*t5; /* omega3*omega_n*R */
    const double t59 = x[0]*p[20]; /* gamma3*2*m*a3^2 */
    const double t60 = t17*t59; /* s*omega_tau*s*Theta*1/(Theta*D)*gamma3*2*m*a3^2 */
    const double t61 = x[0]*p[21]; /* gamma3*2*I1 */
    const double t62 = t20*t61; /* omega_n*Theta*1/(Theta*D)*gamma3*2*I1 */
    const double t63 = JLT_FMA(t16, t25, t62); /* s*Theta*1/(Theta*D)*omega3*I3 + omega_n*Theta*1/(Theta*D)*gamma3*2*I1 */
    const double t64 = -t63; /* -t63 */
    const double t65 = t26*p[22]; /* omega_n*s*Theta*1/(Theta*D)*(-I3) */
    const double t66 = x[4]*p[38]; /* omega3*2*a3*I3 */
    const double t67 = t26*t66; /* omega_n*s*Theta*1/(Theta*D)*omega3*2*a3*I3 */
    const double t68 = JLT_FNMA(t24, p[20], 2.0); /* 2 - s*s*Theta*1/(Theta*D)*2*m*a3^2 */
    const double t69 = x[2]*p[3]; /* omega_tau*a3 */
    const double t70 = JLT_FNMA(t29, t69, p[2]); /* g - omega_tau*gamma3*omega_tau*a3 */
    const double t71 = JLT_FNMA(t68, t70, t67); /* omega_n*s*Theta*1/(Theta*D)*omega3*2*a3*I3 - (2 - s*s*Theta*1/(Theta*D)*2*m*a3^2)*(g - omega_tau*gamma3*omega_tau*a3) */
    const double t72 = t16*p[43]; /* s*Theta*1/(Theta*D)*m*a3 */
    const double t73 = t71*t72; /* t71*s*Theta*1/(Theta*D)*m*a3 */
    const double t74 = x[0]*p[24]; /* gamma3*2*m*a3^2*I1 */
    const double t75 = JLT_FMS(t26, t74, t25); /* omega_n*s*Theta*1/(Theta*D)*gamma3*2*m*a3^2*I1 - omega3*I3 */
    const double t76 = JLT_FMA(t20, t75, t73); /* omega_n*Theta*1/(Theta*D)*(omega_n*s*Theta*1/(Theta*D)*gamma3*2*m*a3^2*I1 - omega3*I3) + t71*s*Theta*1/(Theta*D)*m*a3 */
    const double t77 = t39*p[26]; /* omega3*omega_tau*s*D*1/(Theta*D)*m*R*a3*I3 */
    const double t78 = JLT_FNMA(t35, p[27], 1.0); /* 1 - b*D*1/(Theta*D)*m*a3*I3 */
    const double t79 = x[2]*x[3]; /* omega_tau*omega_n */
    const double t80 = t33*t34; /* omega_n*V*D*1/(Theta*D) */
    const double t81 = t39*p[31]; /* omega3*omega_tau*s*D*1/(Theta*D)*2*I3 */
    const double t82 = t31*p[44]; /* e*2*R */
    const double t83 = t39*t82; /* omega3*omega_tau*s*D*1/(Theta*D)*e*2*R */
    const double t84 = t33*t35; /* omega_n*V*b*D*1/(Theta*D) */
    const double t85 = JLT_FNMA(2.0, t84, t83); /* omega3*omega_tau*s*D*1/(Theta*D)*e*2*R - 2*omega_n*V*b*D*1/(Theta*D) */
    const double t86 = JLT_FMA(p[0], t85, t81); /* m*t85 + omega3*omega_tau*s*D*1/(Theta*D)*2*I3 */
    const double t87 = t35*p[28]; /* b*D*1/(Theta*D)*m*R*I3^2 */
    const double t88 = JLT_FNMA(p[15], t80, t77); /* omega3*omega_tau*s*D*1/(Theta*D)*m*R*a3*I3 - m*R*I3*omega_n*V*D*1/(Theta*D) */
    const double t89 = JLT_FMA(t78, t79, t88); /* (1 - b*D*1/(Theta*D)*m*a3*I3)*omega_tau*omega_n + t88 */
    const double t90 = JLT_FNMA(t86, t87, t89); /* (1 - b*D*1/(Theta*D)*m*a3*I3)*omega_tau*omega_n + t88 - (m*t85 + omega3*omega_tau*s*D*1/(Theta*D)*2*I3)*b*D*1/(Theta*D)*m*R*I3^2 */
    const double t91 = x[3]*t36; /* omega_n*m*I3*b*D*1/(Theta*D) */
    const double t92 = -t91; /* -omega_n*m*I3*b*D*1/(Theta*D) */
    const double t93 = JLT_FNMA(t31, t36, x[0]); /* gamma3 - e*m*I3*b*D*1/(Theta*D) */
    const double t94 = x[3]*t93; /* omega_n*(gamma3 - e*m*I3*b*D*1/(Theta*D)) */
    const double t95 = t25*t40; /* omega3*I3*(e*m*R + I3) */
    const double t96 = JLT_FMA(t37, t95, t94); /* s*D*1/(Theta*D)*omega3*I3*(e*m*R + I3) + omega_n*(gamma3 - e*m*I3*b*D*1/(Theta*D)) */
    const double t97 = JLT_FNMA(t32, t36, t29); /* omega_tau*gamma3 - V*m*I3*b*D*1/(Theta*D) */
    const double t98 = t38*t41; /* omega_tau*s*D*1/(Theta*D)*I3*(e*m*R + I3) */
    const double t99 = x[2]*t95; /* omega_tau*omega3*I3*(e*m*R + I3) */
    const double t100 = t34*t99; /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) */
    const double t101 = t37*p[33]; /* s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t102 = JLT_FNMA(t86, t101, t100); /* D*1/(Theta*D)*omega_tau*omega3*I3*(e*m*R + I3) - (m*t85 + omega3*omega_tau*s*D*1/(Theta*D)*2*I3)*s*D*1/(Theta*D)*m*R^2*I1*I3 */
    const double t103 = JLT_FNMA(x[0], p[39], p[38]); /* 2*a3*I3 - gamma3*2*R*(I1 - I3) */
    const double t104 = t39*t103; /* omega3*omega_tau*s*D*1/(Theta*D)*(2*a3*I3 - gamma3*2*R*(I1 - I3)) */
    const double t105 = t2*t104; /* b*t104 */
    const double t106 = JLT_FMA(p[21], t84, t105); /* 2*I1*omega_n*V*b*D*1/(Theta*D) + b*t104 */
    const double t107 = t37*p[37]; /* s*D*1/(Theta*D)*m^2*R^2*I3 */
    const double t108 = x[3]*p[35]; /* omega_n*m*R*a3*I1 */
    const double t109 = t38*t108; /* omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t110 = x[5]*p[36]; /* s*m*R^2*(I1 - I3) */
    const double t111 = JLT_FMS(t39, t110, t109); /* omega3*omega_tau*s*D*1/(Theta*D)*s*m*R^2*(I1 - I3) - omega_tau*s*D*1/(Theta*D)*omega_n*m*R*a3*I1 */
    const double t112 = JLT_FMA(t106, t107, t111); /* (2*I1*omega_n*V*b*D*1/(Theta*D) + b*t104)*s*D*1/(Theta*D)*m^2*R^2*I3 + t111 */
    const double t113 = x[3]*t44; /* omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t114 = -t113; /* -omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t115 = t31*t113; /* e*omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t116 = x[4]*t48; /* omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t117 = JLT_FMA(t37, t116, t115); /* s*D*1/(Theta*D)*omega3*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R + e*omega_n*s*D*1/(Theta*D)*m*R*I1 */
    const double t118 = -t117; /* -t117 */
    const double t119 = t32*t44; /* V*s*D*1/(Theta*D)*m*R*I1 */
    const double t120 = -t119; /* -V*s*D*1/(Theta*D)*m*R*I1 */
    const double t121 = t38*t48; /* omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t122 = -t121; /* -omega_tau*s*D*1/(Theta*D)*(a3*I3 - gamma3*R*(I1 - I3))*s*m*R */
    const double t123 = p[40]*t80; /* m*R*I1*omega_n*V*D*1/(Theta*D) */
    const double t124 = x[5]*t104; /* s*t104 */
    const double t125 = t33*p[21]; /* omega_n*V*2*I1 */
    const double t126 = JLT_FMA(t37, t125, t124); /* s*D*1/(Theta*D)*omega_n*V*2*I1 + s*t104 */
    const double t127 = t37*p[42]; /* s*D*1/(Theta*D)*m^2*R^3*I1 */
    const double t128 = JLT_FMS(t126, t127, t123); /* (s*D*1/(Theta*D)*omega_n*V*2*I1 + s*t104)*s*D*1/(Theta*D)*m^2*R^3*I1 - m*R*I1*omega_n*V*D*1/(Theta*D) */
    const double t129 = JLT_FNMA(p[32], t104, t128); /* t128 - m*R*t104 */
    const double t130 = -t0; /* -s*omega_tau */
    const double t131 = x[5]*x[0]; /* s*gamma3 */
    const double t132 = -t131; /* -s*gamma3 */
    const double t133 = -t29; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t7;
    out[2] = t28;
    out[3] = t43;
    out[4] = t50;
    out[5] = t52;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t8;
    out[9] = 0.0;
    out[10] = 0.0;
    out[11] = t53;
    out[12] = t54;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = t57;
    out[16] = t6;
    out[17] = t58;
    out[18] = t22;
    out[19] = 0.0;
    out[20] = t60;
    out[21] = t64;
    out[22] = t65;
    out[23] = t76;
    out[24] = t90;
    out[25] = t92;
    out[26] = t96;
    out[27] = t97;
    out[28] = t98;
    out[29] = t102;
    out[30] = t112;
    out[31] = t114;
    out[32] = t118;
    out[33] = t120;
    out[34] = t122;
    out[35] = t129;
    out[36] = t130;
    out[37] = 0.0;
    out[38] = t132;
    out[39] = 0.0;
    out[40] = 0.0;
    out[41] = t133;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[5]*x[5]; /* s*s */
    const double t1 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t2 = t1*p[9]; /* b*m*I3 */
    const double t3 = JLT_FMA(t0, p[8], p[7]); /* s*s*m*R^2*I1 + I1*I3 */
    const double t4 = JLT_FMA(t1, t2, t3); /* Theta = b*b*m*I3 + s*s*m*R^2*I1 + I1*I3 */
    const double t5 = JLT_FMA(t0, p[13], p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t6 = t4*t5; /* Theta*D */
    const double t7 = 1.0/t6; /* 1/(Theta*D) */
    const double t8 = p[45]*x[0]; /* 2*a3^2/R*gamma3 */
    const double t9 = t4*t8; /* Theta*2*a3^2/R*gamma3 */
    const double t10 = t7*t9; /* 1/(Theta*D)*Theta*2*a3^2/R*gamma3 */
    const double t11 = JLT_FNMA(x[0], p[19], p[18]); /* a3*I3 - gamma3*R*(I1 - I3) */
    const double t12 = t5*t7; /* D*1/(Theta*D) */
    const double t13 = JLT_FNMA(t11, t12, t10); /* 1/(Theta*D)*Theta*2*a3^2/R*gamma3 - (a3*I3 - gamma3*R*(I1 - I3))*D*1/(Theta*D) */
    const double t14 = p[32]*x[2]; /* m*R*omega_tau */
    const double t15 = t0*t14; /* s*s*m*R*omega_tau */
    const double t16 = t13*t15; /* t13*s*s*m*R*omega_tau */
    const double t17 = JLT_FMA(x[0], p[3], p[1]); /* e = gamma3*a3 + R */
    const double t18 = JLT_FMA(x[2], t17, x[1]); /* V = omega_tau*e + v_nu */
    const double t19 = t2*t18; /* b*m*I3*V */
    const double t20 = JLT_FNMA(t12, t19, t16); /* t13*s*s*m*R*omega_tau - D*1/(Theta*D)*b*m*I3*V */
    out[0] = t20;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[23]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = x[1]*x[1]; /* v_nu*v_nu */
    const double t2 = JLT_FMA(x[0], p[1], p[3]); /* b = gamma3*R + a3 */
    const double t3 = x[3]*t2; /* omega_n*b */
    const double t4 = p[1]*x[5]; /* R*s */
    const double t5 = JLT_FMA(x[4], t4, t3); /* v_tau = omega3*R*s + omega_n*b */
    const double t6 = JLT_FMA(t5, t5, t1); /* v_tau*v_tau + v_nu*v_nu */
    const double t7 = x[5]*p[13]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[5], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = (1.0 / 2.0)*x[2]; /* 1/2*omega_tau */
    const double t10 = x[2]*t9; /* omega_tau*1/2*omega_tau */
    const double t11 = x[3]*p[47]; /* omega_n*1/2*I1 */
    const double t12 = x[4]*p[48]; /* omega3*1/2*I3 */
    const double t13 = JLT_FMA(x[3], t11, t0); /* omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t14 = JLT_FMA(x[4], t12, t13); /* omega3*omega3*1/2*I3 + omega_n*omega_n*1/2*I1 + m*g*a3*gamma3 */
    const double t15 = JLT_FMA(t8, t10, t14); /* D*omega_tau*1/2*omega_tau + t14 */
    const double t16 = JLT_FMA(p[46], t6, t15); /* energy = 1/2*m*(v_tau*v_tau + v_nu*v_nu) + D*omega_tau*1/2*omega_tau + t14 */
    const double t17 = x[5]*p[49]; /* s*R*I1 */
    const double t18 = x[3]*t17; /* omega_n*s*R*I1 */
    const double t19 = x[4]*p[5]; /* omega3*I3 */
    const double t20 = JLT_FNMA(t2, t19, t18); /* omega_n*s*R*I1 - b*omega3*I3 */
    out[0] = t16;
    out[1] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[3]); /* b = R*gamma3 + a3 */
    const double t1 = x[3]*t0; /* omega_n*b */
    const double t2 = p[1]*x[4]; /* R*omega3 */
    const double t3 = JLT_FMA(x[5], t2, t1); /* v_tau = s*R*omega3 + omega_n*b */
    const double t4 = p[32]*t3; /* m*R*v_tau */
    const double t5 = JLT_FMA(x[3], t4, p[23]); /* d(energy)/d(gamma3) = omega_n*m*R*v_tau + m*g*a3 */
    const double t6 = p[0]*x[1]; /* m*v_nu */
    const double t7 = x[5]*p[13]; /* s*m*a3^2 */
    const double t8 = JLT_FMA(x[5], t7, p[4]); /* D = s*s*m*a3^2 + I1 */
    const double t9 = x[2]*t8; /* omega_tau*D */
    const double t10 = x[3]*p[4]; /* omega_n*I1 */
    const double t11 = t0*p[0]; /* b*m */
    const double t12 = JLT_FMA(t3, t11, t10); /* d(energy)/d(omega_n) = v_tau*b*m + omega_n*I1 */
    const double t13 = x[4]*p[5]; /* omega3*I3 */
    const double t14 = JLT_FMA(x[5], t4, t13); /* d(energy)/d(omega3) = s*m*R*v_tau + omega3*I3 */
    const double t15 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t16 = t7*t15; /* s*m*a3^2*omega_tau*omega_tau */
    const double t17 = JLT_FMA(x[4], t4, t16); /* d(energy)/d(s) = omega3*m*R*v_tau + s*m*a3^2*omega_tau*omega_tau */
    const double t18 = x[4]*p[50]; /* omega3*(-R*I3) */
    const double t19 = x[5]*p[49]; /* s*R*I1 */
    const double t20 = t0*p[22]; /* b*(-I3) */
    const double t21 = x[3]*p[49]; /* omega_n*R*I1 */
    out[0] = t5;
    out[1] = t6;
    out[2] = t9;
    out[3] = t12;
    out[4] = t14;
    out[5] = t17;
    out[6] = t18;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = t19;
    out[10] = t20;
    out[11] = t21;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[5];
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
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
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
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t52[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t59[JLT_JET_ORDER_MAX + 1];
    double t60[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    coefficients[6] = 0;
    for (unsigned k = 0; k < order; k++) {
        t2[k] = jlt_jet_product(x5, x2, k);
        t3[k] = jlt_jet_product(x5, t2, k);
        t7[k] = p[1]*x0[k] + (k == 0 ? p[3] : 0);
        t9[k] = jlt_jet_product(x3, x3, k);
        t10[k] = jlt_jet_product(t7, t9, k);
        t12[k] = jlt_jet_product(x5, x3, k);
        t13[k] = jlt_jet_product(x4, t12, k);
        t14[k] = p[1]*t13[k] + t10[k];
        t18[k] = jlt_jet_product(x5, x5, k);
        t20[k] = t7[k]*p[9];
        t21[k] = p[8]*t18[k] + (k == 0 ? p[7] : 0);
        t22[k] = jlt_jet_product(t7, t20, k) + t21[k];
        t24[k] = t18[k]*p[10];
        t26[k] = t2[k]*p[12];
        t27[k] = t9[k] - jlt_jet_product(t2, t26, k);
        t29[k] = t13[k]*p[11] + t24[k];
        t30[k] = jlt_jet_product(x0, t27, k) + t29[k];
        t33[k] = t18[k]*p[13] + (k == 0 ? p[4] : 0);
        t34[k] = jlt_jet_product(t22, t33, k);
        t36[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t34, t36, k);
        t37[k] = p[6]*t22[k];
        t38[k] = jlt_jet_product(t30, t37, k);
        t39[k] = jlt_jet_product(t36, t38, k);
        t40[k] = jlt_jet_product(x2, x0, k);
        t42[k] = p[3]*x0[k] + (k == 0 ? p[1] : 0);
        t43[k] = jlt_jet_product(x2, t42, k) + x1[k];
        t44[k] = jlt_jet_product(t33, t36, k);
        t45[k] = jlt_jet_product(t43, t44, k);
        t46[k] = t40[k] - jlt_jet_product(t20, t45, k);
        t48[k] = jlt_jet_product(t2, x4, k);
        t49[k] = jlt_jet_product(t44, t48, k);
        t50[k] = p[14]*t49[k];
        t52[k] = t42[k]*p[15];
        t53[k] = jlt_jet_product(t49, t52, k) + t50[k];
        t54[k] = jlt_jet_product(x3, t46, k) + t53[k];
        t56[k] = t12[k]*p[40];
        t57[k] = jlt_jet_product(t45, t56, k);
        t59[k] = jlt_jet_product(x5, t49, k);
        t60[k] = x0[k]*p[36];
        t62[k] = jlt_jet_product(t59, t60, k) - t57[k];
        t63[k] = t62[k] - t59[k]*p[26];
        t64[k] = jlt_jet_product(t2, x0, k);
        t65[k] = -t64[k];
        double *restrict next = coefficients + (k + 1)*7;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t14[k]/(k + 1);
        next[2] = x2[k + 1] = t39[k]/(k + 1);
        next[3] = x3[k + 1] = t54[k]/(k + 1);
        next[4] = x4[k + 1] = t63[k]/(k + 1);
        next[5] = x5[k + 1] = t65[k]/(k + 1);
        next[6] = x5[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[5];
    const double complex v_omega_tau = x[2];
    out[0] = (v_s)*((v_omega_tau*v_s));
    const double complex v_omega_n = x[3];
    const double v_a3 = params[3];
    const double v_R = params[1];
    const double complex v_gamma3 = x[0];
    const double complex v_b = (v_a3 + v_R*v_gamma3);
    const double complex v_omega3 = x[4];
    out[1] = (v_s)*((v_omega_n*v_omega_n*v_b/v_s)
        + (v_R*v_omega_n*v_omega3));
    const double v_m = params[0];
    const double v_I1 = params[4];
    const double complex v_D = (v_I1 + v_m*v_a3*v_a3*v_s*v_s);
    const double v_g = params[2];
    const double v_I3 = params[5];
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
    out[4] = (v_s)*((-v_m*v_R*v_I1*v_omega_n*v_V/v_Theta)
        + (v_m*v_R*v_R*v_gamma3*v_omega_tau*v_omega3*v_s*(v_I1 - v_I3)/v_Theta)
        + (-v_m*v_R*v_a3*v_I3*v_omega_tau*v_omega3*v_s/v_Theta));
    out[5] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static const jlt_quantity states[] = {
    { "gamma3", "1", "cosine of the tilt of the symmetry axis, (gamma, e3)", (-1.0), 1.0, JLT_ANY_SIGN, NAN },
    { "v_nu", "m/s", "velocity of the centre of mass along nu, the direction of free slipping", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN },
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
    { "G", "" },
};

const jlt_descriptor jlt_kernels_spherical_top_general_in_regular = {
    .model = "spherical_top",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top rolling on a plane with one nonholonomic constraint, reduced system",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, doi:10.20537/nd231201, system (3.2)",
    .sha256 = "f235475cc9bd793cf139eaa42e6fbc171d82d0b88e9697d68dbc128bc28e14fd",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top,
    .state_count = 6, .param_count = 6, .block_count = 51,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 6, { 1, 25, 15, 1, 0, 0, 10, 10 }, { 17, 78, 0, 10, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .jacobian = { jacobian, 36, { 9, 76, 33, 1, 0, 0, 13, 19 }, { 56, 375, 0, 49, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .rhs_jacobian = { rhs_jacobian, 42, { 11, 82, 40, 1, 0, 0, 14, 27 }, { 67, 437, 0, 59, 0, 0, 14, 9 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .divergence = { divergence, 1, { 0, 11, 9, 1, 0, 0, 9, 7 }, { 10, 39, 0, 4, 0, 0, 10, 7 },
        "divides by Theta, small only where all of I1*I3, m*R^2*I1*s^2 and m*I3*b^2 are" },
    .integral_values = { integral_values, 2, { 0, 12, 9, 0, 0, 0, 5, 8 }, { 9, 31, 0, 0, 0, 0, 10, 5 },
        "" },
    .integral_gradients = { integral_gradients, 12, { 0, 15, 7, 0, 0, 0, 5, 7 }, { 9, 37, 0, 0, 0, 0, 6, 6 },
        "" },
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
        &jlt_batch_spherical_top_general_in_regular_baseline,
        &jlt_batch_spherical_top_general_in_regular_avx2,
        &jlt_batch_spherical_top_general_in_regular_avx512,
    },
};
