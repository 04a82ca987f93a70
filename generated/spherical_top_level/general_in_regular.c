/* Spherical top with one nonholonomic constraint, on a level of Jellett's integral
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_level, SHA-256 0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee
 *  Command:    ttc generate --out DIR spherical_top_level.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   29   14    1    0    0     13   13   (111)
 *  jacobian            8   76   40    1    0    0     17   30   (746)
 *  rhs_jacobian        10   84   45    1    0    0     17   32   (836)
 *  divergence          1   16   11    1    0    0     13    9   (56)
 *  integral_values     0    8    8    1    0    0      7    7   (37)
 *  integral_gradients  0   14    8    1    0    0     10    7   (75)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy: divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are.
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_level[];
extern const jlt_descriptor jlt_kernels_spherical_top_level_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_level_general_in_regular_avx512;

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
    const double t1 = params[5]*params[5]; /* a3*a3 */
    const double t2 = params[0]*t1; /* m*a3*a3 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = t3*params[3]; /* R*R*I1 */
    const double t5 = params[3]*params[4]; /* I1*I3 */
    const double t6 = -params[3]; /* -I1 */
    const double t7 = params[0]*params[2]; /* m*g */
    const double t8 = params[5]*t7; /* a3*m*g */
    const double t9 = t8/params[3]; /* a3*m*g/I1 */
    const double t10 = t2/params[3]; /* m*a3*a3/I1 */
    const double t11 = params[4]/params[3]; /* I3/I1 */
    const double t12 = params[1]*params[3]; /* R*I1 */
    const double t13 = params[3] - params[4]; /* I1 - I3 */
    const double t14 = params[1]*t13; /* R*(I1 - I3) */
    const double t15 = params[5]*params[4]; /* a3*I3 */
    const double t16 = params[1]*2.0; /* R*2 */
    const double t17 = params[4]*t16; /* I3*R*2 */
    const double t18 = params[1]*params[4]; /* R*I3 */
    const double t19 = t3*2.0; /* R*R*2 */
    const double t20 = params[3]*t19; /* I1*R*R*2 */
    const double t21 = params[3]*2.0; /* I1*2 */
    const double t22 = params[1]*4.0; /* R*4 */
    const double t23 = params[3]*t22; /* I1*R*4 */
    const double t24 = params[4]*t23; /* I3*I1*R*4 */
    const double t25 = params[4]*params[4]; /* I3*I3 */
    const double t26 = t22*t25; /* R*4*I3*I3 */
    const double t27 = params[6]*t18; /* G*R*I3 */
    const double t28 = params[0]*2.0; /* m*2 */
    const double t29 = t1*t28; /* a3*a3*m*2 */
    const double t30 = params[4]*t12; /* I3*R*I1 */
    const double t31 = t3*4.0; /* R*R*4 */
    const double t32 = params[3]*params[3]; /* I1*I1 */
    const double t33 = t31*t32; /* R*R*4*I1*I1 */
    const double t34 = t2/t20; /* m*a3*a3/(I1*R*R*2) */
    const double t35 = params[3]*t31; /* I1*R*R*4 */
    const double t36 = params[4]*t35; /* I3*I1*R*R*4 */
    const double t37 = params[4]*t28; /* I3*m*2 */
    const double t38 = t1*t37; /* a3*a3*I3*m*2 */
    const double t39 = params[5]*t5; /* a3*I1*I3 */
    const double t40 = params[1]*t25; /* R*I3*I3 */
    const double t41 = t13*t18; /* (I1 - I3)*R*I3 */
    const double t42 = t4*params[4]; /* R*R*I1*I3 */
    const double t43 = params[4]*2.0; /* I3*2 */
    const double t44 = params[2]*t28; /* g*m*2 */
    const double t45 = params[5]*t44; /* a3*g*m*2 */
    const double t46 = params[4]/t23; /* I3/(I1*R*4) */
    const double t47 = params[4]/2.0; /* I3/2 */
    const double t48 = params[0]/2.0; /* m/2 */
    const double t49 = params[6]*params[6]; /* G*G */
    const double t50 = -t4; /* -R*R*I1 */
    const double t51 = t2/t4; /* m*a3*a3/(R*R*I1) */
    out[7] = t0;
    out[8] = t2;
    out[9] = t4;
    out[10] = t5;
    out[11] = t6;
    out[12] = t9;
    out[13] = t10;
    out[14] = t11;
    out[15] = t12;
    out[16] = t14;
    out[17] = t15;
    out[18] = t17;
    out[19] = t18;
    out[20] = t20;
    out[21] = t21;
    out[22] = t24;
    out[23] = t26;
    out[24] = t27;
    out[25] = t29;
    out[26] = t30;
    out[27] = t8;
    out[28] = t33;
    out[29] = t34;
    out[30] = t36;
    out[31] = t38;
    out[32] = t39;
    out[33] = t40;
    out[34] = t41;
    out[35] = t42;
    out[36] = t43;
    out[37] = t45;
    out[38] = t46;
    out[39] = t22;
    out[40] = t47;
    out[41] = t48;
    out[42] = t49;
    out[43] = t50;
    out[44] = t51;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[2]*t0; /* omega_tau*s*s */
    const double t2 = x[4]*p[7]; /* s*R*G */
    const double t3 = JLT_FMA(p[1], x[0], p[5]); /* b = R*gamma3 + a3 */
    const double t4 = p[4]*t3; /* I3*b */
    const double t5 = JLT_FMA(x[3], t4, t2); /* v_tau*I3*b + s*R*G */
    const double t6 = JLT_FMA(t0, p[8], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t7 = t0*p[9]; /* s*s*R^2*I1 */
    const double t8 = JLT_FMA(t3, t4, t7); /* K = b*I3*b + s*s*R^2*I1 */
    const double t9 = JLT_FMA(p[0], t8, p[10]); /* Theta = m*K + I1*I3 */
    const double t10 = t6*t8; /* D*K */
    const double t11 = t9*t10; /* Theta*D*K */
    const double t12 = 1.0/t11; /* 1/(Theta*D*K) */
    const double t13 = t9*t12; /* Theta*1/(Theta*D*K) */
    const double t14 = t6*t13; /* D*Theta*1/(Theta*D*K) */
    const double t15 = t5*t14; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t16 = x[3]*t15; /* v_tau*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t17 = t0*p[12]; /* s*s*m*g*a3/I1 */
    const double t18 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t19 = p[13]*t18; /* m*a3^2/I1*omega_tau*gamma3 */
    const double t20 = x[4]*p[15]; /* s*R*I1 */
    const double t21 = x[3]*t20; /* v_tau*s*R*I1 */
    const double t22 = JLT_FNMA(t3, p[6], t21); /* v_tau*s*R*I1 - b*G */
    const double t23 = x[4]*t22; /* s*(v_tau*s*R*I1 - b*G) */
    const double t24 = t14*t23; /* D*Theta*1/(Theta*D*K)*s*(v_tau*s*R*I1 - b*G) */
    const double t25 = p[14]*t24; /* I3/I1*D*Theta*1/(Theta*D*K)*s*(v_tau*s*R*I1 - b*G) */
    const double t26 = JLT_FMA(x[0], t15, t25); /* gamma3*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) + I3/I1*D*Theta*1/(Theta*D*K)*s*(v_tau*s*R*I1 - b*G) */
    const double t27 = JLT_FNMA(t1, t19, t17); /* s*s*m*g*a3/I1 - omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t28 = JLT_FMA(t15, t26, t27); /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*t26 + s*s*m*g*a3/I1 - omega_tau*s*s*m*a3^2/I1*omega_tau*gamma3 */
    const double t29 = t8*p[11]; /* K*(-I1) */
    const double t30 = t13*t29; /* Theta*1/(Theta*D*K)*K*(-I1) */
    const double t31 = t28*t30; /* t28*Theta*1/(Theta*D*K)*K*(-I1) */
    const double t32 = JLT_FMA(p[5], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t33 = JLT_FMA(x[2], t32, x[1]); /* V = omega_tau*e + v_nu */
    const double t34 = t10*t12; /* D*K*1/(Theta*D*K) */
    const double t35 = p[10]*t33; /* I1*I3*V */
    const double t36 = JLT_FNMA(t34, t35, x[1]); /* v_nu - D*K*1/(Theta*D*K)*I1*I3*V */
    const double t37 = t15*t36; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*(v_nu - D*K*1/(Theta*D*K)*I1*I3*V) */
    const double t38 = JLT_FMS(x[0], p[16], p[17]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t39 = x[2]*p[4]; /* omega_tau*I3 */
    const double t40 = t38*t39; /* (gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3 */
    const double t41 = t34*t40; /* D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3 */
    const double t42 = JLT_FMA(t24, t41, t37); /* D*Theta*1/(Theta*D*K)*s*(v_tau*s*R*I1 - b*G)*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3)*omega_tau*I3 + t37 */
    const double t43 = -t42; /* -t42 */
    const double t44 = x[4]*t18; /* s*omega_tau*gamma3 */
    const double t45 = -t44; /* -s*omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t16;
    out[2] = t31;
    out[3] = t43;
    out[4] = t45;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = x[4]*x[2]; /* s*omega_tau */
    const double t2 = 2.0*t1; /* 2*s*omega_tau */
    const double t3 = x[4]*p[7]; /* s*R*G */
    const double t4 = JLT_FMA(p[1], x[0], p[5]); /* b = R*gamma3 + a3 */
    const double t5 = p[4]*t4; /* I3*b */
    const double t6 = JLT_FMA(x[3], t5, t3); /* v_tau*I3*b + s*R*G */
    const double t7 = JLT_FMA(t0, p[8], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t8 = t0*p[9]; /* s*s*R^2*I1 */
    const double t9 = JLT_FMA(t4, t5, t8); /* K = b*I3*b + s*s*R^2*I1 */
    const double t10 = JLT_FMA(p[0], t9, p[10]); /* Theta = m*K + I1*I3 */
    const double t11 = t7*t9; /* D*K */
    const double t12 = t10*t11; /* Theta*D*K */
    const double t13 = 1.0/t12; /* 1/(Theta*D*K) */
    const double t14 = t10*t13; /* Theta*1/(Theta*D*K) */
    const double t15 = t7*t14; /* D*Theta*1/(Theta*D*K) */
    const double t16 = t6*t15; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t17 = t4*t15; /* b*D*Theta*1/(Theta*D*K) */
    const double t18 = p[18]*t16; /* 2*R*I3*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t19 = t17*t18; /* b*D*Theta*1/(Theta*D*K)*2*R*I3*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t20 = x[3]*t15; /* v_tau*D*Theta*1/(Theta*D*K) */
    const double t21 = p[19]*t20; /* R*I3*v_tau*D*Theta*1/(Theta*D*K) */
    const double t22 = t19 - t21; /* t19 - R*I3*v_tau*D*Theta*1/(Theta*D*K) */
    const double t23 = x[3]*t22; /* v_tau*(t19 - R*I3*v_tau*D*Theta*1/(Theta*D*K)) */
    const double t24 = -t23; /* -v_tau*(t19 - R*I3*v_tau*D*Theta*1/(Theta*D*K)) */
    const double t25 = p[4]*t17; /* I3*b*D*Theta*1/(Theta*D*K) */
    const double t26 = JLT_FMA(x[3], t25, t16); /* v_tau*I3*b*D*Theta*1/(Theta*D*K) + (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t27 = p[7]*t20; /* R*G*v_tau*D*Theta*1/(Theta*D*K) */
    const double t28 = x[4]*t15; /* s*D*Theta*1/(Theta*D*K) */
    const double t29 = t16*t28; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*s*D*Theta*1/(Theta*D*K) */
    const double t30 = p[20]*t29; /* 2*R^2*I1*t29 */
    const double t31 = JLT_FNMA(x[3], t30, t27); /* R*G*v_tau*D*Theta*1/(Theta*D*K) - v_tau*2*R^2*I1*t29 */
    const double t32 = t9*t14; /* K*Theta*1/(Theta*D*K) */
    const double t33 = x[4]*t32; /* s*K*Theta*1/(Theta*D*K) */
    const double t34 = x[2]*p[8]; /* omega_tau*m*a3^2 */
    const double t35 = t33*t34; /* s*K*Theta*1/(Theta*D*K)*omega_tau*m*a3^2 */
    const double t36 = t1*t35; /* s*omega_tau*s*K*Theta*1/(Theta*D*K)*omega_tau*m*a3^2 */
    const double t37 = t16*t32; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*K*Theta*1/(Theta*D*K) */
    const double t38 = t16*t37; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*t37 */
    const double t39 = x[0]*p[21]; /* gamma3*2*I1 */
    const double t40 = x[3]*p[15]; /* v_tau*R*I1 */
    const double t41 = x[4]*t40; /* s*v_tau*R*I1 */
    const double t42 = JLT_FNMA(t4, p[6], t41); /* s*v_tau*R*I1 - b*G */
    const double t43 = t28*t42; /* s*D*Theta*1/(Theta*D*K)*(s*v_tau*R*I1 - b*G) */
    const double t44 = p[4]*t43; /* I3*s*D*Theta*1/(Theta*D*K)*(s*v_tau*R*I1 - b*G) */
    const double t45 = JLT_FMA(t16, t39, t44); /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*gamma3*2*I1 + I3*s*D*Theta*1/(Theta*D*K)*(s*v_tau*R*I1 - b*G) */
    const double t46 = t32*t45; /* K*Theta*1/(Theta*D*K)*t45 */
    const double t47 = x[0]*t38; /* gamma3*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*t37 */
    const double t48 = t17*p[22]; /* b*D*Theta*1/(Theta*D*K)*4*R*I1*I3 */
    const double t49 = t37*t43; /* t37*s*D*Theta*1/(Theta*D*K)*(s*v_tau*R*I1 - b*G) */
    const double t50 = t17*p[23]; /* b*D*Theta*1/(Theta*D*K)*4*R*I3^2 */
    const double t51 = t28*p[24]; /* s*D*Theta*1/(Theta*D*K)*R*I3*G */
    const double t52 = JLT_FMA(t37, t51, t36); /* t37*s*D*Theta*1/(Theta*D*K)*R*I3*G + s*omega_tau*s*K*Theta*1/(Theta*D*K)*omega_tau*m*a3^2 */
    const double t53 = JLT_FNMA(p[3], t38, t52); /* t52 - I1*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*t37 */
    const double t54 = JLT_FMA(t49, t50, t53); /* t37*s*D*Theta*1/(Theta*D*K)*(s*v_tau*R*I1 - b*G)*b*D*Theta*1/(Theta*D*K)*4*R*I3^2 + t52 - I1*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*t37 */
    const double t55 = JLT_FMA(t47, t48, t54); /* gamma3*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*t37*b*D*Theta*1/(Theta*D*K)*4*R*I1*I3 + t54 */
    const double t56 = JLT_FNMA(t21, t46, t55); /* t55 - R*I3*v_tau*D*Theta*1/(Theta*D*K)*K*Theta*1/(Theta*D*K)*t45 */
    const double t57 = t33*p[25]; /* s*K*Theta*1/(Theta*D*K)*2*m*a3^2 */
    const double t58 = t1*x[0]; /* s*omega_tau*gamma3 */
    const double t59 = t57*t58; /* s*K*Theta*1/(Theta*D*K)*2*m*a3^2*s*omega_tau*gamma3 */
    const double t60 = t25*t46; /* I3*b*D*Theta*1/(Theta*D*K)*K*Theta*1/(Theta*D*K)*t45 */
    const double t61 = t33*p[26]; /* s*K*Theta*1/(Theta*D*K)*R*I1*I3 */
    const double t62 = JLT_FMA(t29, t61, t60); /* t29*s*K*Theta*1/(Theta*D*K)*R*I1*I3 + I3*b*D*Theta*1/(Theta*D*K)*K*Theta*1/(Theta*D*K)*t45 */
    const double t63 = -t62; /* -t62 */
    const double t64 = JLT_FNMA(x[4], t57, 2.0); /* 2 - s*s*K*Theta*1/(Theta*D*K)*2*m*a3^2 */
    const double t65 = t33*p[27]; /* s*K*Theta*1/(Theta*D*K)*m*g*a3 */
    const double t66 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t67 = JLT_FNMA(t35, t66, t65); /* s*K*Theta*1/(Theta*D*K)*m*g*a3 - s*K*Theta*1/(Theta*D*K)*omega_tau*m*a3^2*omega_tau*gamma3 */
    const double t68 = t28*t40; /* s*D*Theta*1/(Theta*D*K)*v_tau*R*I1 */
    const double t69 = JLT_FMA(t15, t42, t68); /* D*Theta*1/(Theta*D*K)*(s*v_tau*R*I1 - b*G) + s*D*Theta*1/(Theta*D*K)*v_tau*R*I1 */
    const double t70 = p[4]*t69; /* I3*t69 */
    const double t71 = p[7]*t15; /* R*G*D*Theta*1/(Theta*D*K) */
    const double t72 = JLT_FMA(t33, p[29], t28); /* s*K*Theta*1/(Theta*D*K)*1/2*m*a3^2/(R^2*I1) + s*D*Theta*1/(Theta*D*K) */
    const double t73 = p[28]*t72; /* 4*R^2*I1^2*t72 */
    const double t74 = t28*p[30]; /* s*D*Theta*1/(Theta*D*K)*4*R^2*I1*I3 */
    const double t75 = t49*t74; /* t37*s*D*Theta*1/(Theta*D*K)*(s*v_tau*R*I1 - b*G)*s*D*Theta*1/(Theta*D*K)*4*R^2*I1*I3 */
    const double t76 = t33*p[31]; /* s*K*Theta*1/(Theta*D*K)*2*m*I3*a3^2 */
    const double t77 = JLT_FMA(t49, t76, t75); /* t37*s*D*Theta*1/(Theta*D*K)*(s*v_tau*R*I1 - b*G)*s*K*Theta*1/(Theta*D*K)*2*m*I3*a3^2 + t75 */
    const double t78 = JLT_FNMA(t64, t67, t77); /* t77 - (2 - s*s*K*Theta*1/(Theta*D*K)*2*m*a3^2)*t67 */
    const double t79 = JLT_FNMA(t37, t70, t78); /* t77 - (2 - s*s*K*Theta*1/(Theta*D*K)*2*m*a3^2)*t67 - t37*I3*t69 */
    const double t80 = JLT_FMA(t47, t73, t79); /* gamma3*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*t37*4*R^2*I1^2*t72 + t79 */
    const double t81 = JLT_FNMA(t46, t71, t80); /* t80 - K*Theta*1/(Theta*D*K)*t45*R*G*D*Theta*1/(Theta*D*K) */
    const double t82 = JLT_FMA(p[5], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t83 = JLT_FMA(x[2], t82, x[1]); /* V = omega_tau*e + v_nu */
    const double t84 = t11*t13; /* D*K*1/(Theta*D*K) */
    const double t85 = p[10]*t84; /* I1*I3*D*K*1/(Theta*D*K) */
    const double t86 = JLT_FNMA(t83, t85, x[1]); /* v_nu - V*I1*I3*D*K*1/(Theta*D*K) */
    const double t87 = t21*t86; /* R*I3*v_tau*D*Theta*1/(Theta*D*K)*(v_nu - V*I1*I3*D*K*1/(Theta*D*K)) */
    const double t88 = x[2]*t84; /* omega_tau*D*K*1/(Theta*D*K) */
    const double t89 = p[32]*t88; /* I1*I3*a3*omega_tau*D*K*1/(Theta*D*K) */
    const double t90 = JLT_FMS(x[0], p[16], p[17]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t91 = t2*t90; /* 2*s*omega_tau*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t92 = t42*t91; /* (s*v_tau*R*I1 - b*G)*2*s*omega_tau*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t93 = p[21]*t83; /* 2*I1*V */
    const double t94 = JLT_FNMA(t6, t93, t92); /* t92 - (v_tau*I3*b + s*R*G)*2*I1*V */
    const double t95 = JLT_FMA(p[0], t84, t15); /* m*D*K*1/(Theta*D*K) + D*Theta*1/(Theta*D*K) */
    const double t96 = t84*t94; /* D*K*1/(Theta*D*K)*(t92 - (v_tau*I3*b + s*R*G)*2*I1*V) */
    const double t97 = t95*t96; /* (m*D*K*1/(Theta*D*K) + D*Theta*1/(Theta*D*K))*D*K*1/(Theta*D*K)*(t92 - (v_tau*I3*b + s*R*G)*2*I1*V) */
    const double t98 = t17*p[33]; /* b*D*Theta*1/(Theta*D*K)*R*I3^2 */
    const double t99 = t88*p[34]; /* omega_tau*D*K*1/(Theta*D*K)*R*I3*(I1 - I3) */
    const double t100 = t88*t90; /* omega_tau*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t101 = JLT_FMS(t16, t89, t87); /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*I1*I3*a3*omega_tau*D*K*1/(Theta*D*K) - t87 */
    const double t102 = JLT_FMA(t97, t98, t101); /* t97*b*D*Theta*1/(Theta*D*K)*R*I3^2 + t101 */
    const double t103 = JLT_FNMA(t43, t99, t102); /* t97*b*D*Theta*1/(Theta*D*K)*R*I3^2 + t101 - s*D*Theta*1/(Theta*D*K)*(s*v_tau*R*I1 - b*G)*omega_tau*D*K*1/(Theta*D*K)*R*I3*(I1 - I3) */
    const double t104 = JLT_FMA(t51, t100, t103); /* s*D*Theta*1/(Theta*D*K)*R*I3*G*omega_tau*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3) + t103 */
    const double t105 = JLT_FMA(t19, x[1], t104); /* t19*v_nu + t104 */
    const double t106 = t16*t85; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*I1*I3*D*K*1/(Theta*D*K) */
    const double t107 = t106 - t16; /* t106 - (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t108 = t82*t106; /* e*t106 */
    const double t109 = t84*t90; /* D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t110 = JLT_FNMA(t44, t109, t108); /* e*t106 - I3*s*D*Theta*1/(Theta*D*K)*(s*v_tau*R*I1 - b*G)*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t111 = t25*t86; /* I3*b*D*Theta*1/(Theta*D*K)*(v_nu - V*I1*I3*D*K*1/(Theta*D*K)) */
    const double t112 = x[4]*p[26]; /* s*R*I1*I3 */
    const double t113 = t100*t112; /* omega_tau*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3)*s*R*I1*I3 */
    const double t114 = JLT_FMA(t28, t113, t111); /* s*D*Theta*1/(Theta*D*K)*t113 + t111 */
    const double t115 = -t114; /* -(s*D*Theta*1/(Theta*D*K)*t113 + t111) */
    const double t116 = t71*t86; /* R*G*D*Theta*1/(Theta*D*K)*(v_nu - V*I1*I3*D*K*1/(Theta*D*K)) */
    const double t117 = t28*p[35]; /* s*D*Theta*1/(Theta*D*K)*R^2*I1*I3 */
    const double t118 = JLT_FMS(t97, t117, t116); /* t97*s*D*Theta*1/(Theta*D*K)*R^2*I1*I3 - R*G*D*Theta*1/(Theta*D*K)*(v_nu - V*I1*I3*D*K*1/(Theta*D*K)) */
    const double t119 = JLT_FMA(t30, x[1], t118); /* 2*R^2*I1*t29*v_nu + t118 */
    const double t120 = JLT_FNMA(t70, t100, t119); /* 2*R^2*I1*t29*v_nu + t118 - I3*t69*omega_tau*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t121 = -t1; /* -s*omega_tau */
    const double t122 = x[4]*x[0]; /* s*gamma3 */
    const double t123 = -t122; /* -s*gamma3 */
    const double t124 = -t66; /* -omega_tau*gamma3 */
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = t0;
    out[3] = 0.0;
    out[4] = t2;
    out[5] = t24;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = t26;
    out[9] = t31;
    out[10] = t56;
    out[11] = 0.0;
    out[12] = t59;
    out[13] = t63;
    out[14] = t81;
    out[15] = t105;
    out[16] = t107;
    out[17] = t110;
    out[18] = t115;
    out[19] = t120;
    out[20] = t121;
    out[21] = 0.0;
    out[22] = t123;
    out[23] = 0.0;
    out[24] = t124;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[2]; /* s*omega_tau */
    const double t1 = x[4]*t0; /* s*s*omega_tau */
    const double t2 = x[4]*p[7]; /* s*R*G */
    const double t3 = JLT_FMA(p[1], x[0], p[5]); /* b = R*gamma3 + a3 */
    const double t4 = p[4]*t3; /* I3*b */
    const double t5 = JLT_FMA(x[3], t4, t2); /* v_tau*I3*b + s*R*G */
    const double t6 = x[4]*x[4]; /* s*s */
    const double t7 = JLT_FMA(p[8], t6, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t8 = t6*p[9]; /* s*s*R^2*I1 */
    const double t9 = JLT_FMA(t3, t4, t8); /* K = b*I3*b + s*s*R^2*I1 */
    const double t10 = JLT_FMA(p[0], t9, p[10]); /* Theta = m*K + I1*I3 */
    const double t11 = t7*t9; /* D*K */
    const double t12 = t10*t11; /* Theta*D*K */
    const double t13 = 1.0/t12; /* 1/(Theta*D*K) */
    const double t14 = t10*t13; /* Theta*1/(Theta*D*K) */
    const double t15 = t7*t14; /* D*Theta*1/(Theta*D*K) */
    const double t16 = t5*t15; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t17 = x[3]*t16; /* v_tau*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t18 = t9*t14; /* K*Theta*1/(Theta*D*K) */
    const double t19 = x[4]*t18; /* s*K*Theta*1/(Theta*D*K) */
    const double t20 = t0*t19; /* s*omega_tau*s*K*Theta*1/(Theta*D*K) */
    const double t21 = x[2]*p[13]; /* omega_tau*m*a3^2/I1 */
    const double t22 = t20*t21; /* s*omega_tau*s*K*Theta*1/(Theta*D*K)*omega_tau*m*a3^2/I1 */
    const double t23 = t16*t18; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*K*Theta*1/(Theta*D*K) */
    const double t24 = JLT_FNMA(t16, t23, t22); /* s*omega_tau*s*K*Theta*1/(Theta*D*K)*omega_tau*m*a3^2/I1 - (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*t23 */
    const double t25 = p[3]*t24; /* I1*t24 */
    const double t26 = x[0]*t25; /* gamma3*I1*t24 */
    const double t27 = x[4]*t19; /* s*s*K*Theta*1/(Theta*D*K) */
    const double t28 = x[4]*x[3]; /* s*v_tau */
    const double t29 = p[15]*t28; /* R*I1*s*v_tau */
    const double t30 = JLT_FNMA(t3, p[6], t29); /* R*I1*s*v_tau - b*G */
    const double t31 = t15*t16; /* D*Theta*1/(Theta*D*K)*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t32 = t19*t31; /* s*K*Theta*1/(Theta*D*K)*t31 */
    const double t33 = t30*t32; /* (R*I1*s*v_tau - b*G)*s*K*Theta*1/(Theta*D*K)*t31 */
    const double t34 = JLT_FNMA(p[27], t27, t26); /* gamma3*I1*t24 - m*g*a3*s*s*K*Theta*1/(Theta*D*K) */
    const double t35 = JLT_FNMA(p[4], t33, t34); /* gamma3*I1*t24 - m*g*a3*s*s*K*Theta*1/(Theta*D*K) - I3*(R*I1*s*v_tau - b*G)*s*K*Theta*1/(Theta*D*K)*t31 */
    const double t36 = JLT_FMA(p[5], x[0], p[1]); /* e = a3*gamma3 + R */
    const double t37 = JLT_FMA(x[2], t36, x[1]); /* V = omega_tau*e + v_nu */
    const double t38 = t11*t13; /* D*K*1/(Theta*D*K) */
    const double t39 = p[10]*t37; /* I1*I3*V */
    const double t40 = JLT_FNMA(t38, t39, x[1]); /* v_nu - D*K*1/(Theta*D*K)*I1*I3*V */
    const double t41 = t16*t40; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*(v_nu - D*K*1/(Theta*D*K)*I1*I3*V) */
    const double t42 = JLT_FMS(x[0], p[16], p[17]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t43 = t38*t42; /* D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t44 = t0*t43; /* s*omega_tau*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t45 = t15*t30; /* D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G) */
    const double t46 = p[4]*t45; /* I3*D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G) */
    const double t47 = JLT_FMA(t44, t46, t41); /* s*omega_tau*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3)*I3*D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G) + t41 */
    const double t48 = -t47; /* -t47 */
    const double t49 = t0*x[0]; /* s*omega_tau*gamma3 */
    const double t50 = -t49; /* -s*omega_tau*gamma3 */
    const double t51 = t0*2.0; /* s*omega_tau*2 */
    const double t52 = t3*t31; /* b*t31 */
    const double t53 = p[18]*t52; /* 2*R*I3*b*t31 */
    const double t54 = x[3]*t15; /* v_tau*D*Theta*1/(Theta*D*K) */
    const double t55 = p[19]*t54; /* R*I3*v_tau*D*Theta*1/(Theta*D*K) */
    const double t56 = t53 - t55; /* 2*R*I3*b*t31 - R*I3*v_tau*D*Theta*1/(Theta*D*K) */
    const double t57 = x[3]*t56; /* v_tau*(2*R*I3*b*t31 - R*I3*v_tau*D*Theta*1/(Theta*D*K)) */
    const double t58 = -t57; /* -v_tau*(2*R*I3*b*t31 - R*I3*v_tau*D*Theta*1/(Theta*D*K)) */
    const double t59 = JLT_FMA(t4, t54, t16); /* I3*b*v_tau*D*Theta*1/(Theta*D*K) + (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t60 = p[7]*t54; /* R*G*v_tau*D*Theta*1/(Theta*D*K) */
    const double t61 = t28*p[20]; /* s*v_tau*2*R^2*I1 */
    const double t62 = JLT_FNMA(t31, t61, t60); /* R*G*v_tau*D*Theta*1/(Theta*D*K) - t31*s*v_tau*2*R^2*I1 */
    const double t63 = x[0]*t16; /* gamma3*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t64 = t18*t63; /* K*Theta*1/(Theta*D*K)*gamma3*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t65 = p[21]*t64; /* 2*I1*t64 */
    const double t66 = JLT_FMA(t19, t46, t65); /* s*K*Theta*1/(Theta*D*K)*I3*D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G) + 2*I1*t64 */
    const double t67 = t52*p[22]; /* b*t31*4*R*I1*I3 */
    const double t68 = t3*p[23]; /* b*4*R*I3^2 */
    const double t69 = t45*t68; /* D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G)*b*4*R*I3^2 */
    const double t70 = JLT_FMA(t32, t69, t25); /* s*K*Theta*1/(Theta*D*K)*t31*D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G)*b*4*R*I3^2 + I1*t24 */
    const double t71 = JLT_FMA(t32, p[24], t70); /* s*K*Theta*1/(Theta*D*K)*t31*R*I3*G + t70 */
    const double t72 = JLT_FMA(t64, t67, t71); /* t64*b*t31*4*R*I1*I3 + s*K*Theta*1/(Theta*D*K)*t31*R*I3*G + t70 */
    const double t73 = JLT_FNMA(t55, t66, t72); /* t72 - R*I3*v_tau*D*Theta*1/(Theta*D*K)*t66 */
    const double t74 = t20*p[25]; /* s*omega_tau*s*K*Theta*1/(Theta*D*K)*2*m*a3^2 */
    const double t75 = x[0]*t74; /* gamma3*s*omega_tau*s*K*Theta*1/(Theta*D*K)*2*m*a3^2 */
    const double t76 = t15*t66; /* D*Theta*1/(Theta*D*K)*t66 */
    const double t77 = t4*t76; /* I3*b*D*Theta*1/(Theta*D*K)*t66 */
    const double t78 = x[4]*p[26]; /* s*R*I1*I3 */
    const double t79 = JLT_FMA(t32, t78, t77); /* s*K*Theta*1/(Theta*D*K)*t31*s*R*I1*I3 + I3*b*D*Theta*1/(Theta*D*K)*t66 */
    const double t80 = -t79; /* -t79 */
    const double t81 = t27*p[37]; /* s*s*K*Theta*1/(Theta*D*K)*2*m*g*a3 */
    const double t82 = JLT_FMS(x[2], 2.0, t74); /* omega_tau*2 - s*omega_tau*s*K*Theta*1/(Theta*D*K)*2*m*a3^2 */
    const double t83 = x[2]*x[0]; /* omega_tau*gamma3 */
    const double t84 = t16*p[21]; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*2*I1 */
    const double t85 = JLT_FMA(t64, t84, t81); /* t64*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*2*I1 + s*s*K*Theta*1/(Theta*D*K)*2*m*g*a3 */
    const double t86 = JLT_FMA(t33, p[36], t85); /* (R*I1*s*v_tau - b*G)*s*K*Theta*1/(Theta*D*K)*t31*2*I3 + t85 */
    const double t87 = JLT_FMA(t82, t83, t86); /* (omega_tau*2 - s*omega_tau*s*K*Theta*1/(Theta*D*K)*2*m*a3^2)*omega_tau*gamma3 + (R*I1*s*v_tau - b*G)*s*K*Theta*1/(Theta*D*K)*t31*2*I3 + t85 */
    const double t88 = p[8]*t19; /* m*a3^2*s*K*Theta*1/(Theta*D*K) */
    const double t89 = t19*p[37]; /* s*K*Theta*1/(Theta*D*K)*2*m*g*a3 */
    const double t90 = p[4]*t30; /* I3*(R*I1*s*v_tau - b*G) */
    const double t91 = t18*t90; /* K*Theta*1/(Theta*D*K)*I3*(R*I1*s*v_tau - b*G) */
    const double t92 = x[4]*p[39]; /* s*4*R */
    const double t93 = JLT_FMS(t45, t92, x[3]); /* D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G)*s*4*R - v_tau */
    const double t94 = JLT_FMA(p[38], t93, t63); /* 1/4*I3/(R*I1)*(D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G)*s*4*R - v_tau) + gamma3*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t95 = t32*p[28]; /* s*K*Theta*1/(Theta*D*K)*t31*4*R^2*I1^2 */
    const double t96 = JLT_FMS(t94, t95, t89); /* t94*s*K*Theta*1/(Theta*D*K)*t31*4*R^2*I1^2 - s*K*Theta*1/(Theta*D*K)*2*m*g*a3 */
    const double t97 = JLT_FNMA(t31, t91, t96); /* t96 - t31*K*Theta*1/(Theta*D*K)*I3*(R*I1*s*v_tau - b*G) */
    const double t98 = JLT_FNMA(p[7], t76, t97); /* t96 - t31*K*Theta*1/(Theta*D*K)*I3*(R*I1*s*v_tau - b*G) - R*G*D*Theta*1/(Theta*D*K)*t66 */
    const double t99 = JLT_FMA(t87, t88, t98); /* t87*m*a3^2*s*K*Theta*1/(Theta*D*K) + t98 */
    const double t100 = t40*t55; /* (v_nu - D*K*1/(Theta*D*K)*I1*I3*V)*R*I3*v_tau*D*Theta*1/(Theta*D*K) */
    const double t101 = t16*t38; /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*D*K*1/(Theta*D*K) */
    const double t102 = x[2]*p[32]; /* omega_tau*I1*I3*a3 */
    const double t103 = t0*t45; /* s*omega_tau*D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G) */
    const double t104 = t42*2.0; /* (gamma3*R*(I1 - I3) - I3*a3)*2 */
    const double t105 = t103*t104; /* s*omega_tau*D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G)*(gamma3*R*(I1 - I3) - I3*a3)*2 */
    const double t106 = JLT_FNMA(t37, t84, t105); /* t105 - V*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*2*I1 */
    const double t107 = JLT_FMA(p[0], t38, t15); /* m*D*K*1/(Theta*D*K) + D*Theta*1/(Theta*D*K) */
    const double t108 = t38*t107; /* D*K*1/(Theta*D*K)*(m*D*K*1/(Theta*D*K) + D*Theta*1/(Theta*D*K)) */
    const double t109 = t106*t108; /* (t105 - V*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*2*I1)*t108 */
    const double t110 = t3*p[33]; /* b*R*I3^2 */
    const double t111 = t38*p[34]; /* D*K*1/(Theta*D*K)*R*I3*(I1 - I3) */
    const double t112 = t15*p[24]; /* D*Theta*1/(Theta*D*K)*R*I3*G */
    const double t113 = JLT_FMS(t44, t112, t100); /* s*omega_tau*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3)*D*Theta*1/(Theta*D*K)*R*I3*G - t100 */
    const double t114 = JLT_FMA(t101, t102, t113); /* (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*D*K*1/(Theta*D*K)*omega_tau*I1*I3*a3 + t113 */
    const double t115 = JLT_FNMA(t103, t111, t114); /* t114 - s*omega_tau*D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G)*D*K*1/(Theta*D*K)*R*I3*(I1 - I3) */
    const double t116 = JLT_FMA(x[1], t53, t115); /* v_nu*2*R*I3*b*t31 + t115 */
    const double t117 = JLT_FMA(t109, t110, t116); /* t109*b*R*I3^2 + v_nu*2*R*I3*b*t31 + t115 */
    const double t118 = p[10]*t101; /* I1*I3*(v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K)*D*K*1/(Theta*D*K) */
    const double t119 = t118 - t16; /* t118 - (v_tau*I3*b + s*R*G)*D*Theta*1/(Theta*D*K) */
    const double t120 = t36*t118; /* e*t118 */
    const double t121 = t43*t46; /* D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3)*I3*D*Theta*1/(Theta*D*K)*(R*I1*s*v_tau - b*G) */
    const double t122 = JLT_FNMA(x[4], t121, t120); /* e*t118 - s*t121 */
    const double t123 = t44*t78; /* s*omega_tau*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3)*s*R*I1*I3 */
    const double t124 = JLT_FMA(t4, t40, t123); /* I3*b*(v_nu - D*K*1/(Theta*D*K)*I1*I3*V) + t123 */
    const double t125 = t15*t124; /* D*Theta*1/(Theta*D*K)*(I3*b*(v_nu - D*K*1/(Theta*D*K)*I1*I3*V) + t123) */
    const double t126 = -t125; /* -t125 */
    const double t127 = p[7]*t15; /* R*G*D*Theta*1/(Theta*D*K) */
    const double t128 = t40*t127; /* (v_nu - D*K*1/(Theta*D*K)*I1*I3*V)*R*G*D*Theta*1/(Theta*D*K) */
    const double t129 = t31*x[1]; /* t31*v_nu */
    const double t130 = JLT_FMA(t109, p[40], t129); /* t109*1/2*I3 + t31*v_nu */
    const double t131 = x[4]*p[20]; /* s*2*R^2*I1 */
    const double t132 = t54*p[26]; /* v_tau*D*Theta*1/(Theta*D*K)*R*I1*I3 */
    const double t133 = JLT_FMS(t130, t131, t128); /* (t109*1/2*I3 + t31*v_nu)*s*2*R^2*I1 - (v_nu - D*K*1/(Theta*D*K)*I1*I3*V)*R*G*D*Theta*1/(Theta*D*K) */
    const double t134 = JLT_FNMA(t44, t132, t133); /* t133 - s*omega_tau*D*K*1/(Theta*D*K)*(gamma3*R*(I1 - I3) - I3*a3)*v_tau*D*Theta*1/(Theta*D*K)*R*I1*I3 */
    const double t135 = JLT_FNMA(x[2], t121, t134); /* t134 - omega_tau*t121 */
    const double t136 = -t0; /* -s*omega_tau */
    const double t137 = x[4]*x[0]; /* s*gamma3 */
    const double t138 = -t137; /* -s*gamma3 */
    const double t139 = -t83; /* -omega_tau*gamma3 */
    out[0] = t1;
    out[1] = t17;
    out[2] = t35;
    out[3] = t48;
    out[4] = t50;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = t6;
    out[8] = 0.0;
    out[9] = t51;
    out[10] = t58;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = t59;
    out[14] = t62;
    out[15] = t73;
    out[16] = 0.0;
    out[17] = t75;
    out[18] = t80;
    out[19] = t99;
    out[20] = t117;
    out[21] = t119;
    out[22] = t122;
    out[23] = t126;
    out[24] = t135;
    out[25] = t136;
    out[26] = 0.0;
    out[27] = t138;
    out[28] = 0.0;
    out[29] = t139;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[4]*x[4]; /* s*s */
    const double t1 = p[9]*t0; /* R^2*I1*s*s */
    const double t2 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t3 = t2*p[4]; /* b*I3 */
    const double t4 = JLT_FMA(t2, t3, t1); /* K = b*b*I3 + R^2*I1*s*s */
    const double t5 = JLT_FMA(t4, p[0], p[10]); /* Theta = K*m + I1*I3 */
    const double t6 = JLT_FMA(t0, p[8], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t7 = t4*t6; /* K*D */
    const double t8 = t5*t7; /* Theta*K*D */
    const double t9 = 1.0/t8; /* 1/(Theta*K*D) */
    const double t10 = t5*t9; /* Theta*1/(Theta*K*D) */
    const double t11 = x[0]*p[25]; /* gamma3*2*m*a3^2 */
    const double t12 = t4*t11; /* K*gamma3*2*m*a3^2 */
    const double t13 = t10*t12; /* Theta*1/(Theta*K*D)*K*gamma3*2*m*a3^2 */
    const double t14 = JLT_FMS(x[0], p[16], p[17]); /* gamma3*R*(I1 - I3) - I3*a3 */
    const double t15 = t6*t10; /* D*Theta*1/(Theta*K*D) */
    const double t16 = t7*t9; /* K*D*1/(Theta*K*D) */
    const double t17 = p[26]*t14; /* R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t18 = t16*t17; /* K*D*1/(Theta*K*D)*R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t19 = JLT_FNMA(t15, t18, t13); /* Theta*1/(Theta*K*D)*K*gamma3*2*m*a3^2 - D*Theta*1/(Theta*K*D)*K*D*1/(Theta*K*D)*R*I1*I3*(gamma3*R*(I1 - I3) - I3*a3) */
    const double t20 = JLT_FNMA(t0, t19, x[0]); /* gamma3 - s*s*t19 */
    const double t21 = x[2]*t20; /* omega_tau*(gamma3 - s*s*t19) */
    const double t22 = JLT_FMA(x[0], p[5], p[1]); /* e = gamma3*a3 + R */
    const double t23 = JLT_FMA(x[2], t22, x[1]); /* V = omega_tau*e + v_nu */
    const double t24 = p[10]*t23; /* I1*I3*V */
    const double t25 = JLT_FNMA(t16, t24, x[1]); /* v_nu - K*D*1/(Theta*K*D)*I1*I3*V */
    const double t26 = t3*t15; /* b*I3*D*Theta*1/(Theta*K*D) */
    const double t27 = JLT_FMA(t25, t26, t21); /* (v_nu - K*D*1/(Theta*K*D)*I1*I3*V)*b*I3*D*Theta*1/(Theta*K*D) + omega_tau*(gamma3 - s*s*t19) */
    const double t28 = -t27; /* -t27 */
    out[0] = t28;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[27]*x[0]; /* m*g*a3*gamma3 */
    const double t1 = p[41]*x[1]; /* 1/2*m*v_nu */
    const double t2 = x[4]*x[4]; /* s*s */
    const double t3 = JLT_FMA(p[8], t2, p[3]); /* D = m*a3^2*s*s + I1 */
    const double t4 = x[2]*x[2]; /* omega_tau*omega_tau */
    const double t5 = t3*t4; /* D*omega_tau*omega_tau */
    const double t6 = t2*p[9]; /* s*s*R^2*I1 */
    const double t7 = JLT_FMA(x[0], p[1], p[5]); /* b = gamma3*R + a3 */
    const double t8 = p[4]*t7; /* I3*b */
    const double t9 = JLT_FMA(t7, t8, t6); /* K = b*I3*b + s*s*R^2*I1 */
    const double t10 = 1.0/t9; /* 1/K */
    const double t11 = JLT_FMA(t9, p[0], p[10]); /* Theta = K*m + I1*I3 */
    const double t12 = x[3]*x[3]; /* v_tau*v_tau */
    const double t13 = JLT_FMA(t11, t12, p[42]); /* Theta*v_tau*v_tau + G^2 */
    const double t14 = JLT_FMA(t10, t13, t5); /* 1/K*(Theta*v_tau*v_tau + G^2) + D*omega_tau*omega_tau */
    const double t15 = JLT_FMA(x[1], t1, t0); /* v_nu*1/2*m*v_nu + m*g*a3*gamma3 */
    const double t16 = JLT_FMA((1.0 / 2.0), t14, t15); /* 1/2*(1/K*(Theta*v_tau*v_tau + G^2) + D*omega_tau*omega_tau) + v_nu*1/2*m*v_nu + m*g*a3*gamma3 */
    out[0] = t16;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[1], x[0], p[5]); /* b = R*gamma3 + a3 */
    const double t1 = x[4]*x[4]; /* s*s */
    const double t2 = p[9]*t1; /* R^2*I1*s*s */
    const double t3 = t0*p[4]; /* b*I3 */
    const double t4 = JLT_FMA(t0, t3, t2); /* K = b*b*I3 + R^2*I1*s*s */
    const double t5 = 1.0/t4; /* 1/K */
    const double t6 = JLT_FMA(t4, p[0], p[10]); /* Theta = K*m + I1*I3 */
    const double t7 = x[3]*x[3]; /* v_tau*v_tau */
    const double t8 = JLT_FMA(t6, t7, p[42]); /* Theta*v_tau*v_tau + G^2 */
    const double t9 = t5*t8; /* 1/K*(Theta*v_tau*v_tau + G^2) */
    const double t10 = JLT_FNMA(p[0], t7, t9); /* 1/K*(Theta*v_tau*v_tau + G^2) - m*v_tau*v_tau */
    const double t11 = t5*t10; /* 1/K*(1/K*(Theta*v_tau*v_tau + G^2) - m*v_tau*v_tau) */
    const double t12 = p[19]*t0; /* R*I3*b */
    const double t13 = JLT_FNMA(t11, t12, p[27]); /* m*g*a3 - 1/K*(1/K*(Theta*v_tau*v_tau + G^2) - m*v_tau*v_tau)*R*I3*b */
    const double t14 = p[0]*x[1]; /* m*v_nu */
    const double t15 = JLT_FMA(t1, p[8], p[3]); /* D = s*s*m*a3^2 + I1 */
    const double t16 = x[2]*t15; /* omega_tau*D */
    const double t17 = t6*x[3]; /* Theta*v_tau */
    const double t18 = t5*t17; /* 1/K*Theta*v_tau */
    const double t19 = x[2]*p[44]; /* omega_tau*m*a3^2/(R^2*I1) */
    const double t20 = JLT_FNMA(x[2], t19, t11); /* 1/K*(1/K*(Theta*v_tau*v_tau + G^2) - m*v_tau*v_tau) - omega_tau*omega_tau*m*a3^2/(R^2*I1) */
    const double t21 = x[4]*p[43]; /* s*(-R^2*I1) */
    const double t22 = t20*t21; /* t20*s*(-R^2*I1) */
    out[0] = t13;
    out[1] = t14;
    out[2] = t16;
    out[3] = t18;
    out[4] = t22;
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
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t34[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t41[JLT_JET_ORDER_MAX + 1];
    double t42[JLT_JET_ORDER_MAX + 1];
    double t43[JLT_JET_ORDER_MAX + 1];
    double t44[JLT_JET_ORDER_MAX + 1];
    double t45[JLT_JET_ORDER_MAX + 1];
    double t47[JLT_JET_ORDER_MAX + 1];
    double t48[JLT_JET_ORDER_MAX + 1];
    double t49[JLT_JET_ORDER_MAX + 1];
    double t50[JLT_JET_ORDER_MAX + 1];
    double t51[JLT_JET_ORDER_MAX + 1];
    double t53[JLT_JET_ORDER_MAX + 1];
    double t54[JLT_JET_ORDER_MAX + 1];
    double t55[JLT_JET_ORDER_MAX + 1];
    double t56[JLT_JET_ORDER_MAX + 1];
    double t57[JLT_JET_ORDER_MAX + 1];
    double t58[JLT_JET_ORDER_MAX + 1];
    double t61[JLT_JET_ORDER_MAX + 1];
    double t62[JLT_JET_ORDER_MAX + 1];
    double t63[JLT_JET_ORDER_MAX + 1];
    double t64[JLT_JET_ORDER_MAX + 1];
    double t65[JLT_JET_ORDER_MAX + 1];
    double t66[JLT_JET_ORDER_MAX + 1];
    double t67[JLT_JET_ORDER_MAX + 1];
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
        t11[k] = p[1]*x0[k] + (k == 0 ? p[5] : 0);
        t12[k] = p[4]*t11[k];
        t13[k] = jlt_jet_product(x3, t12, k) + t6[k];
        t16[k] = jlt_jet_product(x4, x4, k);
        t17[k] = p[8]*t16[k] + (k == 0 ? p[3] : 0);
        t20[k] = t16[k]*p[9];
        t21[k] = jlt_jet_product(t11, t12, k) + t20[k];
        t23[k] = p[0]*t21[k] + (k == 0 ? p[10] : 0);
        t24[k] = jlt_jet_product(t17, t21, k);
        t25[k] = jlt_jet_product(t23, t24, k);
        t27[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t25, t27, k);
        t28[k] = jlt_jet_product(t23, t27, k);
        t29[k] = jlt_jet_product(t17, t28, k);
        t30[k] = jlt_jet_product(t13, t29, k);
        t31[k] = jlt_jet_product(x3, t30, k);
        t33[k] = jlt_jet_product(t2, x0, k);
        t34[k] = t2[k]*p[13];
        t35[k] = jlt_jet_product(t33, t34, k);
        t38[k] = x4[k]*p[15];
        t39[k] = jlt_jet_product(x3, t38, k);
        t41[k] = t39[k] - t11[k]*p[6];
        t42[k] = jlt_jet_product(t29, t41, k);
        t43[k] = x4[k]*p[14];
        t44[k] = jlt_jet_product(t42, t43, k);
        t45[k] = jlt_jet_product(x0, t30, k) + t44[k];
        t47[k] = t35[k] - t16[k]*p[12];
        t48[k] = t47[k] - jlt_jet_product(t30, t45, k);
        t49[k] = p[3]*t21[k];
        t50[k] = jlt_jet_product(t28, t49, k);
        t51[k] = jlt_jet_product(t48, t50, k);
        t53[k] = p[5]*x0[k] + (k == 0 ? p[1] : 0);
        t54[k] = jlt_jet_product(x2, t53, k) + x1[k];
        t55[k] = jlt_jet_product(t24, t27, k);
        t56[k] = p[10]*t54[k];
        t57[k] = x1[k] - jlt_jet_product(t55, t56, k);
        t58[k] = jlt_jet_product(t30, t57, k);
        t61[k] = x0[k]*p[16] - (k == 0 ? p[17] : 0);
        t62[k] = t2[k]*p[4];
        t63[k] = jlt_jet_product(t61, t62, k);
        t64[k] = jlt_jet_product(t55, t63, k);
        t65[k] = jlt_jet_product(t42, t64, k) + t58[k];
        t66[k] = -t65[k];
        t67[k] = -t33[k];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t31[k]/(k + 1);
        next[2] = x2[k + 1] = t51[k]/(k + 1);
        next[3] = x3[k + 1] = t66[k]/(k + 1);
        next[4] = x4[k + 1] = t67[k]/(k + 1);
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
    const double v_a3 = params[5];
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
};

const jlt_descriptor jlt_kernels_spherical_top_level_general_in_regular = {
    .model = "spherical_top_level",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Spherical top with one nonholonomic constraint, on a level of Jellett's integral",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, system (3.2) and integral (3.3)",
    .sha256 = "0e21006c5ed6b2b43f047938803c9f453803feabeb018bd596d20a035cf11dee",
    .generator = "ttc 0.1.0",
    .table = jlt_table_spherical_top_level,
    .state_count = 5, .param_count = 7, .block_count = 45,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 5, { 2, 29, 14, 1, 0, 0, 13, 13 }, { 21, 82, 0, 8, 0, 0, 11, 9 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .jacobian = { jacobian, 25, { 8, 76, 40, 1, 0, 0, 17, 30 }, { 114, 577, 0, 55, 0, 0, 18, 11 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .rhs_jacobian = { rhs_jacobian, 30, { 10, 84, 45, 1, 0, 0, 17, 32 }, { 129, 644, 0, 63, 0, 0, 18, 12 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .divergence = { divergence, 1, { 1, 16, 11, 1, 0, 0, 13, 9 }, { 12, 40, 0, 4, 0, 0, 12, 7 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are; divides by Theta, small only where all of m*K and I1*I3 are" },
    .integral_values = { integral_values, 1, { 0, 8, 8, 1, 0, 0, 7, 7 }, { 8, 27, 0, 2, 0, 0, 12, 6 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are" },
    .integral_gradients = { integral_gradients, 5, { 0, 14, 8, 1, 0, 0, 10, 7 }, { 10, 58, 0, 7, 0, 0, 12, 8 },
        "divides by K, small only where all of R^2*I1*s^2 and I3*b^2 are" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 0, .equilibria_count = 0,
    .integrals = integrals,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_spherical_top_level_general_in_regular_baseline,
        &jlt_batch_spherical_top_level_general_in_regular_avx2,
        &jlt_batch_spherical_top_level_general_in_regular_avx512,
    },
};
