/* Balanced sphere with one nonholonomic constraint, on a level of all three integrals
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Time:       regular: dt = (s) dtau; states of their own: s
 *  Table:      spherical_top_plane, SHA-256 ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6
 *  Command:    ttc generate --effort full --out DIR spherical_top_plane.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1   14    6    1    1    2     13    5   (57)
 *  jacobian            3   39   13    2    1    2     14   11   (295)
 *  rhs_jacobian        4   41   13    2    1    2     14   13   (318)
 *  divergence          0   18   10    2    1    2     13    7   (120)
 *  time_factor         0    0    0    0    0    0      0    0   (0)
 *  domain_values       0    4    4    1    0    1      5    4   (26)
 *  domain_gradients    0   12    5    1    0    2      7    5   (96)
 *
 *  Accuracy
 *    divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are
 *    divides by v_slip: values and rounding errors grow without bound where it vanishes
 *    takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in C*s*(I1*M) - (G*J1/R)*gamma3,
 *      a part of d(gamma3)/dtau and of d(s)/dtau and of d(d(gamma3)/dtau)/d(gamma3) and of d(d(gamma3)/dtau)/d(psi) and of d(d(gamma3)/dtau)/d(s) and of d(d(s)/dtau)/d(gamma3) and of d(d(s)/dtau)/d(psi) and of d(d(s)/dtau)/d(s),
 *      v_slip - (M/(m*R))*S, a part of d(d(gamma3)/dtau)/d(psi) and of d(d(s)/dtau)/d(psi),
 *      a part of d(d(gamma3)/dtau)/d(gamma3) and of d(d(s)/dtau)/d(gamma3), gamma3*(I3*M)*C + s*(G*J3/R),
 *      a part of d(d(gamma3)/dtau)/d(s) and of d(d(s)/dtau)/d(s), a part of d(d(gamma3)/dtau)/d(s),
 *      a part of d(d(s)/dtau)/d(s), a part of d(d(s)/dtau)/d(gamma3), d(d(psi)/dtau)/d(gamma3),
 *      1/2*G*J3/(m*R^3*I1) - s*((1)/Theta)*(gamma3*(I3*M)*C + s*(G*J3/R))
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_spherical_top_plane[];
extern const jlt_claim jlt_claims_spherical_top_plane[];
extern const jlt_descriptor *const jlt_family_spherical_top_plane[];
extern const jlt_descriptor jlt_kernels_spherical_top_plane_general_in_regular;
extern const struct jlt_ball_table jlt_balls_spherical_top_plane_general_in_regular;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_in_regular_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_in_regular_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_in_regular_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    out[4] = params[4];
    out[5] = params[5];
    out[6] = params[6];
    const double t0 = params[0]*params[1]; /* m*R */
    const double t1 = params[1]*params[1]; /* R*R */
    const double t2 = params[0]*t1; /* m*R*R */
    const double t3 = params[2] + t2; /* J1 = I1 + m*R*R */
    const double t4 = t0/t3; /* m*R/J1 */
    out[7] = t4;
    const double t5 = params[2]*params[2]; /* I1*I1 */
    const double t6 = params[0]*t5; /* m*I1*I1 */
    const double t7 = 1.0/t6; /* 1/(m*I1*I1) */
    out[8] = t7;
    const double t8 = params[2] - params[3]; /* I1 - I3 */
    out[9] = t8;
    const double t9 = params[2]*params[3]; /* I1*I3 */
    out[10] = t9;
    const double t10 = params[2]*t2; /* I1*m*R*R */
    out[11] = t10;
    const double t11 = params[3]/params[2]; /* I3/I1 */
    out[12] = t11;
    const double t12 = params[2]*params[5]; /* I1*M */
    out[13] = t12;
    const double t13 = t3*params[4]; /* J1*G */
    const double t14 = t13/params[1]; /* J1*G/R */
    out[14] = t14;
    const double t15 = params[5]/t0; /* M/(m*R) */
    out[15] = t15;
    const double t16 = t2 + params[3]; /* J3 = m*R*R + I3 */
    const double t17 = params[4]*t16; /* G*J3 */
    const double t18 = t17/params[1]; /* G*J3/R */
    out[16] = t18;
    const double t19 = params[3]*params[5]; /* I3*M */
    out[17] = t19;
    const double t20 = t2*params[3]; /* m*R*R*I3 */
    const double t21 = t8*t20; /* (I1 - I3)*m*R*R*I3 */
    out[18] = t21;
    const double t22 = t8*t13; /* (I1 - I3)*J1*G */
    const double t23 = t22/params[1]; /* (I1 - I3)*J1*G/R */
    out[19] = t23;
    const double t24 = t3*t5; /* J1*I1*I1 */
    const double t25 = params[1]/t24; /* R/(J1*I1*I1) */
    out[20] = t25;
    const double t26 = 1.0/t3; /* 1/J1 */
    out[21] = t26;
    const double t27 = params[1]*params[5]; /* R*M */
    const double t28 = t8*t27; /* (I1 - I3)*R*M */
    const double t29 = t28/params[2]; /* (I1 - I3)*R*M/I1 */
    out[22] = t29;
    const double t30 = params[0]*2.0; /* m*2 */
    const double t31 = params[1]*t30; /* R*m*2 */
    const double t32 = t31/t3; /* R*m*2/J1 */
    out[23] = t32;
    const double t33 = t8*t12; /* (I1 - I3)*I1*M */
    out[24] = t33;
    const double t34 = t8*t10; /* (I1 - I3)*I1*m*R*R */
    out[25] = t34;
    const double t35 = t1*t30; /* R*R*m*2 */
    const double t36 = params[3]*t35; /* I3*R*R*m*2 */
    out[26] = t36;
    const double t37 = -t19; /* -I3*M */
    out[27] = t37;
    const double t38 = params[2]*t35; /* I1*R*R*m*2 */
    out[28] = t38;
    const double t39 = params[1]*t1; /* R*R*R */
    const double t40 = t30*t39; /* m*2*R*R*R */
    const double t41 = params[2]*t40; /* I1*m*2*R*R*R */
    const double t42 = t17/t41; /* G*J3/(I1*m*2*R*R*R) */
    out[29] = t42;
    const double t43 = t8/t2; /* (I1 - I3)/(m*R*R) */
    out[30] = t43;
    const double t44 = t9/t2; /* I1*I3/(m*R*R) */
    out[31] = t44;
    const double t45 = params[3]*t8; /* I3*(I1 - I3) */
    const double t46 = t45/t2; /* I3*(I1 - I3)/(m*R*R) */
    out[32] = t46;
    const double t47 = params[0]*t39; /* m*R*R*R */
    const double t48 = t22/t47; /* (I1 - I3)*J1*G/(m*R*R*R) */
    out[33] = t48;
    const double t49 = t33/t2; /* (I1 - I3)*I1*M/(m*R*R) */
    out[34] = t49;
    const double t50 = params[2]*t8; /* I1*(I1 - I3) */
    const double t51 = t50/t2; /* I1*(I1 - I3)/(m*R*R) */
    out[35] = t51;
    const double t52 = t19/t2; /* I3*M/(m*R*R) */
    out[36] = t52;
    const double t53 = t8/t10; /* (I1 - I3)/(I1*m*R*R) */
    out[37] = t53;
    const double t54 = params[3]/t2; /* I3/(m*R*R) */
    out[38] = t54;
    const double t55 = params[3]*2.0; /* I3*2 */
    const double t56 = t8*t55; /* (I1 - I3)*I3*2 */
    const double t57 = t56/t2; /* (I1 - I3)*I3*2/(m*R*R) */
    out[39] = t57;
    const double t58 = params[4]*2.0; /* G*2 */
    const double t59 = t3*t58; /* J1*G*2 */
    const double t60 = t8*t59; /* (I1 - I3)*J1*G*2 */
    const double t61 = t60/t47; /* (I1 - I3)*J1*G*2/(m*R*R*R) */
    out[40] = t61;
    const double t62 = params[2]*2.0; /* I1*2 */
    const double t63 = params[5]*t62; /* M*I1*2 */
    const double t64 = t8*t63; /* (I1 - I3)*M*I1*2 */
    const double t65 = t64/t2; /* (I1 - I3)*M*I1*2/(m*R*R) */
    out[41] = t65;
    const double t66 = t8*t62; /* (I1 - I3)*I1*2 */
    const double t67 = t66/t2; /* (I1 - I3)*I1*2/(m*R*R) */
    out[42] = t67;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[2]*x[2]; /* s*s */
    const double t1 = p[12]*x[0]; /* I3/I1*gamma3 */
    const double t2 = JLT_FMA(x[0], t1, t0); /* gamma3*I3/I1*gamma3 + s*s */
    const double t3 = JLT_FMA(p[11], t2, p[10]); /* Theta = m*R^2*I1*(gamma3*I3/I1*gamma3 + s*s) + I1*I3 */
    const double t4 = 1.0/t3; /* 1/Theta */
    const double t5 = cos(x[1]); /* C = cos(psi) */
    const double t6 = x[2]*p[13]; /* s*I1*M */
    const double t7 = t5*t6; /* C*s*I1*M */
    const double t8 = JLT_FNMA(x[0], p[14], t7); /* C*s*I1*M - gamma3*G*J1/R */
    const double t9 = p[9]*t4; /* (I1 - I3)*1/Theta */
    const double t10 = t8*t9; /* (C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*1/Theta */
    const double t11 = JLT_FNMA(t8, t10, p[6]); /* F0 - (C*s*I1*M - gamma3*G*J1/R)*(C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*1/Theta */
    const double t12 = p[8]*t11; /* 1/(m*I1^2)*t11 */
    const double t13 = sqrt(t12); /* v_slip = sqrt(1/(m*I1^2)*t11) */
    const double t14 = sin(x[1]); /* S = sin(psi) */
    const double t15 = JLT_FNMA(p[15], t14, t13); /* v_slip - M/(m*R)*S */
    const double t16 = x[2]*p[7]; /* s*m*R/J1 */
    const double t17 = t15*t16; /* (v_slip - M/(m*R)*S)*s*m*R/J1 */
    const double t18 = x[2]*t17; /* s*(v_slip - M/(m*R)*S)*s*m*R/J1 */
    out[0] = t18;
    const double t19 = x[0]*t17; /* gamma3*(v_slip - M/(m*R)*S)*s*m*R/J1 */
    const double t20 = -t19; /* -gamma3*(v_slip - M/(m*R)*S)*s*m*R/J1 */
    out[2] = t20;
    const double t21 = x[2]*p[16]; /* s*G*J3/R */
    const double t22 = x[0]*p[17]; /* gamma3*I3*M */
    const double t23 = JLT_FMA(t5, t22, t21); /* C*gamma3*I3*M + s*G*J3/R */
    const double t24 = t4*t23; /* 1/Theta*(C*gamma3*I3*M + s*G*J3/R) */
    out[1] = t24;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[2]*x[2]; /* s*s */
    const double t1 = x[0]*p[12]; /* gamma3*I3/I1 */
    const double t2 = JLT_FMA(x[0], t1, t0); /* gamma3*gamma3*I3/I1 + s*s */
    const double t3 = JLT_FMA(p[11], t2, p[10]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + s*s) + I1*I3 */
    const double t4 = 1.0/t3; /* 1/Theta */
    const double t5 = cos(x[1]); /* C = cos(psi) */
    const double t6 = x[2]*p[13]; /* s*I1*M */
    const double t7 = t5*t6; /* C*s*I1*M */
    const double t8 = JLT_FNMA(x[0], p[14], t7); /* C*s*I1*M - gamma3*G*J1/R */
    const double t9 = t4*t8; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R) */
    const double t10 = p[9]*t8; /* (I1 - I3)*(C*s*I1*M - gamma3*G*J1/R) */
    const double t11 = JLT_FNMA(t9, t10, p[6]); /* F0 - 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)*(C*s*I1*M - gamma3*G*J1/R) */
    const double t12 = p[8]*t11; /* v_slip^2 = 1/(m*I1^2)*t11 */
    const double t13 = sin(x[1]); /* S = sin(psi) */
    const double t14 = sqrt(t12); /* v_slip = sqrt(v_slip^2) */
    const double t15 = x[2]/t12; /* s/v_slip^2 */
    const double t16 = t14*t15; /* v_slip*s/v_slip^2 */
    const double t17 = JLT_FNMA(p[15], t13, t14); /* v_slip - M/(m*R)*S */
    const double t18 = p[22]*t13; /* R*M*(I1 - I3)/I1*S */
    const double t19 = t9*t18; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*R*M*(I1 - I3)/I1*S */
    const double t20 = t16*t19; /* v_slip*s/v_slip^2*1/Theta*(C*s*I1*M - gamma3*G*J1/R)*R*M*(I1 - I3)/I1*S */
    const double t21 = p[20]*t16; /* R/(I1^2*J1)*v_slip*s/v_slip^2 */
    const double t22 = JLT_FNMA(p[5], t5, t20); /* t20 - M*C */
    const double t23 = p[21]*t22; /* 1/J1*(t20 - M*C) */
    const double t24 = t0*t23; /* s*s*1/J1*(t20 - M*C) */
    out[1] = t24;
    const double t25 = t9*t9; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*1/Theta*(C*s*I1*M - gamma3*G*J1/R) */
    const double t26 = p[18]*x[0]; /* m*R^2*I3*(I1 - I3)*gamma3 */
    const double t27 = t25*t26; /* t25*m*R^2*I3*(I1 - I3)*gamma3 */
    const double t28 = JLT_FMA(p[19], t9, t27); /* G*J1*(I1 - I3)/R*1/Theta*(C*s*I1*M - gamma3*G*J1/R) + t25*m*R^2*I3*(I1 - I3)*gamma3 */
    const double t29 = t21*t28; /* R/(I1^2*J1)*v_slip*s/v_slip^2*t28 */
    const double t30 = x[2]*t29; /* s*R/(I1^2*J1)*v_slip*s/v_slip^2*t28 */
    out[0] = t30;
    const double t31 = p[24]*t5; /* I1*M*(I1 - I3)*C */
    const double t32 = t9*t31; /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*I1*M*(I1 - I3)*C */
    const double t33 = p[17]*t5; /* I3*M*C */
    const double t34 = x[2]*p[25]; /* s*m*R^2*I1*(I1 - I3) */
    const double t35 = JLT_FNMA(t25, t34, t32); /* 1/Theta*(C*s*I1*M - gamma3*G*J1/R)*I1*M*(I1 - I3)*C - t25*s*m*R^2*I1*(I1 - I3) */
    const double t36 = t21*t35; /* R/(I1^2*J1)*v_slip*s/v_slip^2*t35 */
    const double t37 = x[2]*p[16]; /* s*G*J3/R */
    const double t38 = JLT_FMA(x[0], t33, t37); /* gamma3*I3*M*C + s*G*J3/R */
    const double t39 = t4*t38; /* 1/Theta*(gamma3*I3*M*C + s*G*J3/R) */
    const double t40 = x[0]*t4; /* gamma3*1/Theta */
    const double t41 = p[7]*t17; /* m*R/J1*(v_slip - M/(m*R)*S) */
    const double t42 = JLT_FMS(p[23], t17, t36); /* 2*m*R/J1*(v_slip - M/(m*R)*S) - R/(I1^2*J1)*v_slip*s/v_slip^2*t35 */
    const double t43 = x[2]*t42; /* s*t42 */
    out[2] = t43;
    const double t44 = t36 - t41; /* R/(I1^2*J1)*v_slip*s/v_slip^2*t35 - m*R/J1*(v_slip - M/(m*R)*S) */
    const double t45 = x[0]*t44; /* gamma3*t44 */
    out[8] = t45;
    const double t46 = x[2]*t41; /* s*m*R/J1*(v_slip - M/(m*R)*S) */
    const double t47 = JLT_FMA(x[0], t29, t46); /* gamma3*R/(I1^2*J1)*v_slip*s/v_slip^2*t28 + s*m*R/J1*(v_slip - M/(m*R)*S) */
    const double t48 = -t47; /* -t47 */
    out[6] = t48;
    const double t49 = p[26]*t40; /* 2*m*R^2*I3*gamma3*1/Theta */
    const double t50 = t39*t49; /* 1/Theta*(gamma3*I3*M*C + s*G*J3/R)*2*m*R^2*I3*gamma3*1/Theta */
    const double t51 = JLT_FMS(t4, t33, t50); /* 1/Theta*I3*M*C - 1/Theta*(gamma3*I3*M*C + s*G*J3/R)*2*m*R^2*I3*gamma3*1/Theta */
    out[3] = t51;
    const double t52 = p[27]*t40; /* (-I3*M)*gamma3*1/Theta */
    const double t53 = t13*t52; /* S*(-I3*M)*gamma3*1/Theta */
    out[4] = t53;
    const double t54 = JLT_FNMA(x[2], t39, p[29]); /* 1/2*G*J3/(m*R^3*I1) - s*1/Theta*(gamma3*I3*M*C + s*G*J3/R) */
    const double t55 = p[28]*t4; /* 2*m*R^2*I1*1/Theta */
    const double t56 = t54*t55; /* (1/2*G*J3/(m*R^3*I1) - s*1/Theta*(gamma3*I3*M*C + s*G*J3/R))*2*m*R^2*I1*1/Theta */
    out[5] = t56;
    const double t57 = x[2]*x[0]; /* s*gamma3 */
    const double t58 = t23*t57; /* 1/J1*(t20 - M*C)*s*gamma3 */
    const double t59 = -t58; /* -1/J1*(t20 - M*C)*s*gamma3 */
    out[7] = t59;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[2]*x[2]; /* s*s */
    const double t1 = x[0]*p[12]; /* gamma3*I3/I1 */
    const double t2 = JLT_FMA(x[0], t1, t0); /* gamma3*gamma3*I3/I1 + s*s */
    const double t3 = JLT_FMA(p[11], t2, p[10]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + s*s) + I1*I3 */
    const double t4 = 1.0/t3; /* 1/Theta */
    const double t5 = cos(x[1]); /* C = cos(psi) */
    const double t6 = x[2]*p[13]; /* s*I1*M */
    const double t7 = t5*t6; /* C*s*I1*M */
    const double t8 = JLT_FNMA(p[14], x[0], t7); /* C*s*I1*M - G*J1/R*gamma3 */
    const double t9 = t4*t8; /* 1/Theta*(C*s*I1*M - G*J1/R*gamma3) */
    const double t10 = p[9]*t8; /* (I1 - I3)*(C*s*I1*M - G*J1/R*gamma3) */
    const double t11 = JLT_FNMA(t9, t10, p[6]); /* F0 - 1/Theta*(C*s*I1*M - G*J1/R*gamma3)*(I1 - I3)*(C*s*I1*M - G*J1/R*gamma3) */
    const double t12 = p[8]*t11; /* v_slip^2 = 1/(m*I1^2)*t11 */
    const double t13 = sin(x[1]); /* S = sin(psi) */
    const double t14 = sqrt(t12); /* v_slip = sqrt(v_slip^2) */
    const double t15 = x[2]/t12; /* s/v_slip^2 */
    const double t16 = t14*t15; /* v_slip*s/v_slip^2 */
    const double t17 = JLT_FNMA(p[15], t13, t14); /* v_slip - M/(m*R)*S */
    const double t18 = p[22]*t13; /* R*M*(I1 - I3)/I1*S */
    const double t19 = t9*t18; /* 1/Theta*(C*s*I1*M - G*J1/R*gamma3)*R*M*(I1 - I3)/I1*S */
    const double t20 = t16*t19; /* v_slip*s/v_slip^2*1/Theta*(C*s*I1*M - G*J1/R*gamma3)*R*M*(I1 - I3)/I1*S */
    const double t21 = p[20]*t16; /* R/(I1^2*J1)*v_slip*s/v_slip^2 */
    const double t22 = JLT_FNMA(p[5], t5, t20); /* t20 - M*C */
    const double t23 = p[21]*t22; /* 1/J1*(t20 - M*C) */
    const double t24 = t0*t23; /* s*s*1/J1*(t20 - M*C) */
    out[4] = t24;
    const double t25 = t9*t9; /* 1/Theta*(C*s*I1*M - G*J1/R*gamma3)*1/Theta*(C*s*I1*M - G*J1/R*gamma3) */
    const double t26 = x[0]*p[18]; /* gamma3*m*R^2*I3*(I1 - I3) */
    const double t27 = t25*t26; /* t25*gamma3*m*R^2*I3*(I1 - I3) */
    const double t28 = JLT_FMA(p[19], t9, t27); /* G*J1*(I1 - I3)/R*1/Theta*(C*s*I1*M - G*J1/R*gamma3) + t25*gamma3*m*R^2*I3*(I1 - I3) */
    const double t29 = t21*t28; /* R/(I1^2*J1)*v_slip*s/v_slip^2*t28 */
    const double t30 = x[2]*t29; /* s*R/(I1^2*J1)*v_slip*s/v_slip^2*t28 */
    out[3] = t30;
    const double t31 = p[24]*t5; /* I1*M*(I1 - I3)*C */
    const double t32 = t9*t31; /* 1/Theta*(C*s*I1*M - G*J1/R*gamma3)*I1*M*(I1 - I3)*C */
    const double t33 = p[17]*t5; /* I3*M*C */
    const double t34 = x[2]*p[16]; /* s*G*J3/R */
    const double t35 = JLT_FMA(x[0], t33, t34); /* gamma3*I3*M*C + s*G*J3/R */
    const double t36 = t4*t35; /* 1/Theta*(gamma3*I3*M*C + s*G*J3/R) */
    out[1] = t36;
    const double t37 = x[2]*p[25]; /* s*m*R^2*I1*(I1 - I3) */
    const double t38 = JLT_FNMA(t25, t37, t32); /* 1/Theta*(C*s*I1*M - G*J1/R*gamma3)*I1*M*(I1 - I3)*C - t25*s*m*R^2*I1*(I1 - I3) */
    const double t39 = t21*t38; /* R/(I1^2*J1)*v_slip*s/v_slip^2*t38 */
    const double t40 = p[7]*t17; /* m*R/J1*(v_slip - M/(m*R)*S) */
    const double t41 = t0*t40; /* s*s*m*R/J1*(v_slip - M/(m*R)*S) */
    out[0] = t41;
    const double t42 = JLT_FMS(p[23], t17, t39); /* 2*m*R/J1*(v_slip - M/(m*R)*S) - R/(I1^2*J1)*v_slip*s/v_slip^2*t38 */
    const double t43 = x[2]*t42; /* s*t42 */
    out[5] = t43;
    const double t44 = t39 - t40; /* R/(I1^2*J1)*v_slip*s/v_slip^2*t38 - m*R/J1*(v_slip - M/(m*R)*S) */
    const double t45 = x[0]*t44; /* gamma3*t44 */
    out[11] = t45;
    const double t46 = x[0]*t4; /* gamma3*1/Theta */
    const double t47 = x[2]*x[0]; /* s*gamma3 */
    const double t48 = t23*t47; /* 1/J1*(t20 - M*C)*s*gamma3 */
    const double t49 = -t48; /* -1/J1*(t20 - M*C)*s*gamma3 */
    out[10] = t49;
    const double t50 = t40*t47; /* m*R/J1*(v_slip - M/(m*R)*S)*s*gamma3 */
    const double t51 = -t50; /* -m*R/J1*(v_slip - M/(m*R)*S)*s*gamma3 */
    out[2] = t51;
    const double t52 = x[2]*t40; /* s*m*R/J1*(v_slip - M/(m*R)*S) */
    const double t53 = JLT_FMA(x[0], t29, t52); /* gamma3*R/(I1^2*J1)*v_slip*s/v_slip^2*t28 + s*m*R/J1*(v_slip - M/(m*R)*S) */
    const double t54 = -t53; /* -t53 */
    out[9] = t54;
    const double t55 = p[26]*t46; /* 2*m*R^2*I3*gamma3*1/Theta */
    const double t56 = t36*t55; /* 1/Theta*(gamma3*I3*M*C + s*G*J3/R)*2*m*R^2*I3*gamma3*1/Theta */
    const double t57 = JLT_FMS(t4, t33, t56); /* 1/Theta*I3*M*C - 1/Theta*(gamma3*I3*M*C + s*G*J3/R)*2*m*R^2*I3*gamma3*1/Theta */
    out[6] = t57;
    const double t58 = p[27]*t46; /* (-I3*M)*gamma3*1/Theta */
    const double t59 = t13*t58; /* S*(-I3*M)*gamma3*1/Theta */
    out[7] = t59;
    const double t60 = JLT_FNMA(x[2], t36, p[29]); /* 1/2*G*J3/(m*R^3*I1) - s*1/Theta*(gamma3*I3*M*C + s*G*J3/R) */
    const double t61 = p[28]*t4; /* 2*m*R^2*I1*1/Theta */
    const double t62 = t60*t61; /* (1/2*G*J3/(m*R^3*I1) - s*1/Theta*(gamma3*I3*M*C + s*G*J3/R))*2*m*R^2*I1*1/Theta */
    out[8] = t62;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = cos(x[1]); /* C = cos(psi) */
    const double t1 = x[2]*p[13]; /* s*I1*M */
    const double t2 = t0*t1; /* C*s*I1*M */
    const double t3 = JLT_FNMA(p[14], x[0], t2); /* C*s*I1*M - G*J1/R*gamma3 */
    const double t4 = x[2]*p[2]; /* s*I1 */
    const double t5 = x[0]*p[3]; /* gamma3*I3 */
    const double t6 = JLT_FMA(x[2], t4, p[31]); /* s*s*I1 + I1*I3/(m*R^2) */
    const double t7 = JLT_FMA(x[0], t5, t6); /* Theta/(m*R^2) = gamma3*gamma3*I3 + s*s*I1 + I1*I3/(m*R^2) */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2)) */
    const double t9 = t3*t8; /* (C*s*I1*M - G*J1/R*gamma3)*1/(Theta/(m*R^2)) */
    const double t10 = p[30]*t3; /* (I1 - I3)/(m*R^2)*(C*s*I1*M - G*J1/R*gamma3) */
    const double t11 = JLT_FNMA(t9, t10, p[6]); /* F0 - (C*s*I1*M - G*J1/R*gamma3)*1/(Theta/(m*R^2))*(I1 - I3)/(m*R^2)*(C*s*I1*M - G*J1/R*gamma3) */
    const double t12 = p[8]*t11; /* 1/(m*I1^2)*t11 */
    const double t13 = sqrt(t12); /* v_slip = sqrt(1/(m*I1^2)*t11) */
    const double t14 = t9*t9; /* (C*s*I1*M - G*J1/R*gamma3)*1/(Theta/(m*R^2))*(C*s*I1*M - G*J1/R*gamma3)*1/(Theta/(m*R^2)) */
    const double t15 = x[0]*p[32]; /* gamma3*I3*(I1 - I3)/(m*R^2) */
    const double t16 = t14*t15; /* t14*gamma3*I3*(I1 - I3)/(m*R^2) */
    const double t17 = JLT_FMA(t9, p[33], t16); /* (C*s*I1*M - G*J1/R*gamma3)*1/(Theta/(m*R^2))*G*J1*(I1 - I3)/(m*R^3) + t14*gamma3*I3*(I1 - I3)/(m*R^2) */
    const double t18 = x[2]*t17; /* s*t17 */
    const double t19 = t0*p[34]; /* C*I1*M*(I1 - I3)/(m*R^2) */
    const double t20 = t9*t19; /* (C*s*I1*M - G*J1/R*gamma3)*1/(Theta/(m*R^2))*C*I1*M*(I1 - I3)/(m*R^2) */
    const double t21 = x[2]*p[35]; /* s*I1*(I1 - I3)/(m*R^2) */
    const double t22 = JLT_FNMA(t14, t21, t20); /* t20 - t14*s*I1*(I1 - I3)/(m*R^2) */
    const double t23 = JLT_FMA(x[0], t22, t18); /* gamma3*(t20 - t14*s*I1*(I1 - I3)/(m*R^2)) + s*t17 */
    const double t24 = p[20]*x[2]; /* R/(I1^2*J1)*s */
    const double t25 = t23*t24; /* (gamma3*(t20 - t14*s*I1*(I1 - I3)/(m*R^2)) + s*t17)*R/(I1^2*J1)*s */
    const double t26 = t25/t13; /* t25/v_slip */
    const double t27 = sin(x[1]); /* S = sin(psi) */
    const double t28 = t8*p[36]; /* 1/(Theta/(m*R^2))*I3*M/(m*R^2) */
    const double t29 = t27*t28; /* S*1/(Theta/(m*R^2))*I3*M/(m*R^2) */
    const double t30 = JLT_FNMA(t27, p[15], t13); /* v_slip - S*M/(m*R) */
    const double t31 = JLT_FMA(p[7], t30, t29); /* m*R/J1*(v_slip - S*M/(m*R)) + S*1/(Theta/(m*R^2))*I3*M/(m*R^2) */
    const double t32 = JLT_FNMA(x[0], t31, t26); /* t25/v_slip - gamma3*t31 */
    out[0] = t32;
}

static void time_factor(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    out[0] = x[2];
}

static void domain_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[12]*x[0]; /* I3/I1*gamma3 */
    const double t1 = JLT_FMA(x[2], x[2], p[38]); /* s*s + I3/(m*R^2) */
    const double t2 = JLT_FMA(x[0], t0, t1); /* Theta/(m*R^2*I1) = gamma3*I3/I1*gamma3 + s*s + I3/(m*R^2) */
    const double t3 = cos(x[1]); /* C = cos(psi) */
    const double t4 = x[2]*p[13]; /* s*I1*M */
    const double t5 = t3*t4; /* C*s*I1*M */
    const double t6 = JLT_FNMA(x[0], p[14], t5); /* C*s*I1*M - gamma3*G*J1/R */
    const double t7 = p[37]/t2; /* (I1 - I3)/(m*R^2*I1)/(Theta/(m*R^2*I1)) */
    const double t8 = t6*t7; /* (C*s*I1*M - gamma3*G*J1/R)*(I1 - I3)/(m*R^2*I1)/(Theta/(m*R^2*I1)) */
    const double t9 = JLT_FNMA(t6, t8, p[6]); /* F0 - (C*s*I1*M - gamma3*G*J1/R)*t8 */
    out[0] = t9;
}

static void domain_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[2]*x[2]; /* I1*s */
    const double t1 = x[0]*p[3]; /* gamma3*I3 */
    const double t2 = JLT_FMA(x[2], t0, p[31]); /* s*I1*s + I1*I3/(m*R^2) */
    const double t3 = JLT_FMA(x[0], t1, t2); /* Theta/(m*R^2) = gamma3*gamma3*I3 + s*I1*s + I1*I3/(m*R^2) */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = x[2]*p[13]; /* s*I1*M */
    const double t6 = t4*t5; /* C*s*I1*M */
    const double t7 = JLT_FNMA(x[0], p[14], t6); /* C*s*I1*M - gamma3*G*J1/R */
    const double t8 = t7/t3; /* (C*s*I1*M - gamma3*G*J1/R)/(Theta/(m*R^2)) */
    const double t9 = t8*t8; /* (C*s*I1*M - gamma3*G*J1/R)/(Theta/(m*R^2))*(C*s*I1*M - gamma3*G*J1/R)/(Theta/(m*R^2)) */
    const double t10 = p[39]*x[0]; /* 2*I3*(I1 - I3)/(m*R^2)*gamma3 */
    const double t11 = t9*t10; /* t9*2*I3*(I1 - I3)/(m*R^2)*gamma3 */
    const double t12 = JLT_FMA(t8, p[40], t11); /* (C*s*I1*M - gamma3*G*J1/R)/(Theta/(m*R^2))*2*G*J1*(I1 - I3)/(m*R^3) + t9*2*I3*(I1 - I3)/(m*R^2)*gamma3 */
    out[0] = t12;
    const double t13 = sin(x[1]); /* S = sin(psi) */
    const double t14 = t8*p[41]; /* (C*s*I1*M - gamma3*G*J1/R)/(Theta/(m*R^2))*2*I1*M*(I1 - I3)/(m*R^2) */
    const double t15 = x[2]*t13; /* s*S */
    const double t16 = t14*t15; /* t14*s*S */
    out[1] = t16;
    const double t17 = t4*t14; /* C*t14 */
    const double t18 = x[2]*p[42]; /* s*2*I1*(I1 - I3)/(m*R^2) */
    const double t19 = JLT_FMS(t9, t18, t17); /* t9*s*2*I1*(I1 - I3)/(m*R^2) - C*t14 */
    out[2] = t19;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double t1[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double u17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double u28[JLT_JET_ORDER_MAX + 1];
    double t29[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t36[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = 0;
    for (unsigned k = 0; k < order; k++) {
        t1[k] = jlt_jet_product(x2, x2, k);
        t10[k] = p[12]*x0[k];
        t11[k] = jlt_jet_product(x0, t10, k) + t1[k];
        t12[k] = p[11]*t11[k] + (k == 0 ? p[10] : 0);
        t14[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t12, t14, k);
        t17[k] = jlt_jet_cosine(x1, t17, u17, k);
        t18[k] = x2[k]*p[13];
        t19[k] = jlt_jet_product(t17, t18, k);
        t21[k] = t19[k] - x0[k]*p[14];
        t22[k] = p[9]*t14[k];
        t23[k] = jlt_jet_product(t21, t22, k);
        t24[k] = (k == 0 ? p[6] : 0) - jlt_jet_product(t21, t23, k);
        t25[k] = p[8]*t24[k];
        t26[k] = jlt_jet_root(t25[k], t26, k);
        t28[k] = jlt_jet_sine(x1, t28, u28, k);
        t29[k] = t26[k] - p[15]*t28[k];
        t30[k] = p[7]*t29[k];
        t31[k] = jlt_jet_product(t1, t30, k);
        t33[k] = x2[k]*p[16];
        t35[k] = x0[k]*p[17];
        t36[k] = jlt_jet_product(t17, t35, k) + t33[k];
        t37[k] = jlt_jet_product(t14, t36, k);
        t38[k] = jlt_jet_product(x2, x0, k);
        t39[k] = jlt_jet_product(t30, t38, k);
        t40[k] = -t39[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = t31[k]/(k + 1);
        next[1] = x1[k + 1] = t37[k]/(k + 1);
        next[2] = x2[k + 1] = t40[k]/(k + 1);
        next[3] = x2[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_s = x[2];
    const double v_I1 = params[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double complex v_J1 = (v_I1 + v_m*v_R*v_R);
    const double v_F0 = params[6];
    const double v_I3 = params[3];
    const double complex v_gamma3 = x[0];
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*(v_I1*v_s*v_s + v_I3*v_gamma3*v_gamma3));
    const double v_M = params[5];
    const double complex v_psi = x[1];
    const double complex v_C = ccos(v_psi);
    const double v_G = params[4];
    const double complex v_omega3 = ((v_I1*v_M*v_s*v_C - v_G*v_gamma3*v_J1/v_R)/v_Theta);
    const double complex v_v_slip = csqrt((v_F0 - v_Theta*v_omega3*v_omega3*(v_I1 - v_I3))/(v_m*v_I1*v_I1));
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s)*((v_s*v_omega_tau));
    const double complex v_J3 = (v_I3 + v_m*v_R*v_R);
    const double complex v_omega_n = ((v_G*v_s*v_J3/v_R + v_I3*v_M*v_gamma3*v_C)/v_Theta);
    out[1] = (v_s)*((v_omega_n/v_s));
    out[2] = ((-2.0*v_gamma3)*out[0])/(2.0*v_s);
}

static void lifted(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = x[1];
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt((1 - gamma3)*(gamma3 + 1)) */
    out[2] = t3;
}

static void root_relations(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t1 = (-1.0) + t0; /* -1 + gamma3*gamma3 */
    const double t2 = x[2]*x[2]; /* s*s */
    const double t3 = t1 + t2; /* -1 + gamma3*gamma3 + s*s */
    out[0] = t3;
}

static void root_relation_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    const double t0 = 2.0*x[0]; /* 2*gamma3 */
    out[0] = t0;
    out[1] = 0.0;
    const double t1 = 2.0*x[2]; /* 2*s */
    out[2] = t1;
}

static void tier_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[2]*params[2]; /* I1*I1 */
    const double t1 = params[0]*t0; /* m*I1*I1 */
    const double t2 = params[2]*params[3]; /* I1*I3 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = x[2]*x[2]; /* s*s */
    const double t6 = params[2]*t5; /* I1*s*s */
    const double t7 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t8 = params[3]*t7; /* I3*gamma3*gamma3 */
    const double t9 = t6 + t8; /* I1*s*s + I3*gamma3*gamma3 */
    const double t10 = t4*t9; /* m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t11 = t2 + t10; /* Theta = I1*I3 + m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t12 = params[2]*params[5]; /* I1*M */
    const double t13 = x[2]*t12; /* s*I1*M */
    const double t14 = cos(x[1]); /* C = cos(psi) */
    const double t15 = t13*t14; /* s*I1*M*C */
    const double t16 = x[0]*params[4]; /* gamma3*G */
    const double t17 = params[2] + t4; /* J1 = I1 + m*R*R */
    const double t18 = t16*t17; /* gamma3*G*J1 */
    const double t19 = t18/params[1]; /* gamma3*G*J1/R */
    const double t20 = t15 - t19; /* s*I1*M*C - gamma3*G*J1/R */
    const double t21 = t20*t20; /* (s*I1*M*C - gamma3*G*J1/R)*(s*I1*M*C - gamma3*G*J1/R) */
    const double t22 = params[2] - params[3]; /* I1 - I3 */
    const double t23 = t21*t22; /* (s*I1*M*C - gamma3*G*J1/R)*(s*I1*M*C - gamma3*G*J1/R)*(I1 - I3) */
    const double t24 = t23/t11; /* t23/Theta */
    const double t25 = params[6] - t24; /* F0 - t23/Theta */
    const double t26 = t25/t1; /* (F0 - t23/Theta)/(m*I1*I1) */
    const double t27 = sqrt(t26); /* v_slip = sqrt((F0 - t23/Theta)/(m*I1*I1)) */
    const double t28 = t27*t27; /* v_slip*v_slip */
    const double t29 = t1*t28; /* m*I1*I1*v_slip*v_slip */
    const double t30 = t29*50.0; /* m*I1*I1*v_slip*v_slip*50 */
    const double t31 = t30 - params[6]; /* m*I1*I1*v_slip*v_slip*50 - F0 */
    out[0] = t31;
    const double t32 = params[6] + t30; /* F0 + m*I1*I1*v_slip*v_slip*50 */
    out[1] = t32;
}

static const jlt_way_condition tier_conditions[] = {
    { "50*m*I1^2*v_slip^2 - F0 > 0", 0 },
    { "50*m*I1^2*v_slip^2 + F0 > 0", 0 },
};

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "psi", "rad", "angle of the horizontal momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 2.0*0x1.921fb54442d18p+1 },
    { "s", "", "", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "R", "m", "radius", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "I1", "kg*m^2", "equatorial moment of inertia", -INFINITY, INFINITY, JLT_POSITIVE, (2.0 / 5.0), 0.0 },
    { "I3", "kg*m^2", "axial moment of inertia", -INFINITY, INFINITY, JLT_NONNEGATIVE, (1.0 / 4.0), 0.0 },
    { "G", "kg*m^3/s", "value of Jellett's integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (-3.0 / 10.0), 0.0 },
    { "M", "kg*m^2/s", "horizontal angular momentum about the contact point", -INFINITY, INFINITY, JLT_NONNEGATIVE, 1.0, 0.0 },
    { "F0", "kg^3*m^6/s^2", "value of the third integral", -INFINITY, INFINITY, JLT_ANY_SIGN, (1.0 / 2.0), 0.0 },
};

static const jlt_region domains[] = {
    { "motion", "F0 - (I1 - I3)*Theta*omega3^2 > 0", 0 },
};

static const jlt_pole poles[] = {
    { 0, "the symmetry axis is vertical" },
};

const jlt_descriptor jlt_kernels_spherical_top_plane_general_in_regular = {
    .model = "spherical_top_plane",
    .variant = "",
    .time = "regular",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on a level of all three integrals",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_plane, .family = jlt_family_spherical_top_plane, .claims = jlt_claims_spherical_top_plane,
    .scales = 1,
    .state_count = 3, .param_count = 7, .prepared_count = 43,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 3, { 1, 14, 6, 1, 1, 2, 13, 5 }, { 11, 36, 0, 7, 1, 2, 17, 9 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*s*(I1*M) - gamma3*(G*J1/R), a part of d(gamma3)/dtau and of d(s)/dtau, v_slip - (M/(m*R))*S, C*gamma3*(I3*M) + s*(G*J3/R)" },
    .jacobian = { jacobian, 9, { 3, 39, 13, 2, 1, 2, 14, 11 }, { 46, 207, 0, 39, 1, 2, 18, 14 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: values and rounding errors grow without bound where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*s*(I1*M) - gamma3*(G*J1/R), a part of d(d(gamma3)/dtau)/d(gamma3) and of d(d(gamma3)/dtau)/d(psi) and of d(d(gamma3)/dtau)/d(s) and of d(d(s)/dtau)/d(gamma3) and of d(d(s)/dtau)/d(psi) and of d(d(s)/dtau)/d(s), v_slip - (M/(m*R))*S, a part of d(d(gamma3)/dtau)/d(psi) and of d(d(s)/dtau)/d(psi), a part of d(d(gamma3)/dtau)/d(gamma3) and of d(d(s)/dtau)/d(gamma3), a part of d(d(gamma3)/dtau)/d(s) and of d(d(s)/dtau)/d(s), gamma3*(I3*M)*C + s*(G*J3/R), a part of d(d(gamma3)/dtau)/d(s), a part of d(d(s)/dtau)/d(s), a part of d(d(s)/dtau)/d(gamma3), d(d(psi)/dtau)/d(gamma3), 1/2*G*J3/(m*R^3*I1) - s*((1)/Theta)*(gamma3*(I3*M)*C + s*(G*J3/R))" },
    .rhs_jacobian = { rhs_jacobian, 12, { 4, 41, 13, 2, 1, 2, 14, 13 }, { 50, 222, 0, 43, 1, 2, 18, 15 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: values and rounding errors grow without bound where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*s*(I1*M) - (G*J1/R)*gamma3, a part of d(gamma3)/dtau and of d(s)/dtau and of d(d(gamma3)/dtau)/d(gamma3) and of d(d(gamma3)/dtau)/d(psi) and of d(d(gamma3)/dtau)/d(s) and of d(d(s)/dtau)/d(gamma3) and of d(d(s)/dtau)/d(psi) and of d(d(s)/dtau)/d(s), v_slip - (M/(m*R))*S, a part of d(d(gamma3)/dtau)/d(psi) and of d(d(s)/dtau)/d(psi), a part of d(d(gamma3)/dtau)/d(gamma3) and of d(d(s)/dtau)/d(gamma3), gamma3*(I3*M)*C + s*(G*J3/R), a part of d(d(gamma3)/dtau)/d(s) and of d(d(s)/dtau)/d(s), a part of d(d(gamma3)/dtau)/d(s), a part of d(d(s)/dtau)/d(s), a part of d(d(s)/dtau)/d(gamma3), d(d(psi)/dtau)/d(gamma3), 1/2*G*J3/(m*R^3*I1) - s*((1)/Theta)*(gamma3*(I3*M)*C + s*(G*J3/R))" },
    .divergence = { divergence, 1, { 0, 18, 10, 2, 1, 2, 13, 7 }, { 20, 82, 0, 15, 1, 2, 17, 12 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: values and rounding errors grow without bound where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*s*(I1*M) - (G*J1/R)*gamma3, a part of the divergence, a part of the divergence, a part of the divergence, a part of the divergence, v_slip - S*(M/(m*R)), (m*R/J1)*(v_slip - S*(M/(m*R))) + S*((1)/Theta/(m*R^2))*(I3*M/(m*R^2)), the divergence" },
    .integral_values = { .loses_digits = "" },
    .integral_gradients = { .loses_digits = "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { time_factor, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { domain_values, 1, { 0, 4, 4, 1, 0, 1, 5, 4 }, { 6, 17, 0, 2, 0, 1, 10, 5 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; digits are lost where terms nearly cancel in C*s*(I1*M) - gamma3*(G*J1/R), motion" },
    .domain_gradients = { domain_gradients, 3, { 0, 12, 5, 1, 0, 2, 7, 5 }, { 15, 69, 0, 10, 0, 2, 12, 9 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; digits are lost where terms nearly cancel in C*s*(I1*M) - gamma3*(G*J1/R), d(motion)/d(gamma3), d(motion)/d(s)" },
    .domain_count = 1, .domains = domains,
    .pole_count = 1, .poles = poles,
    .lifted = lifted,
    .tier = "plane", .tier_meaning = "a3 = 0: the flow on a half of M^2, levels of E, G and F0 fixed",
    .tier_condition_count = 2, .tier_conditions = tier_conditions,
    .tier_values = tier_values,
    .lifted_count = 1, .root_relations = root_relations, .root_relation_gradients = root_relation_gradients,
    .integral_count = 0, .measure_count = 0, .equilibria_count = 0,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_plane_general_in_regular,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_plane_general_in_regular) },
#endif
};
