/* Balanced sphere with one nonholonomic constraint, on a level of all three integrals
 *
 *  Source:     A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1
 *  Table:      spherical_top_plane, SHA-256 ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6
 *  Command:    ttc generate --effort full --out DIR spherical_top_plane.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2   16    6    1    2    2     14    6   (52)
 *  jacobian            2   32   13    2    2    2     15   12   (157)
 *  rhs_jacobian        2   33   13    2    2    2     18   12   (172)
 *  divergence          2   17    9    2    2    2     15    8   (93)
 *  domain_values       3    5    3    1    1    1      8    4   (29)
 *  domain_gradients    2    9    5    2    1    2     10    5   (73)
 *
 *  Accuracy
 *    divides by s: values and rounding errors grow without bound where it vanishes
 *    divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are
 *    divides by v_slip: values and rounding errors grow without bound where it vanishes
 *    takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes
 *    takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in C*(I1*M)*s - gamma3*(G*J1/R),
 *      a part of d(gamma3)/dt and of d(d(gamma3)/dt)/d(gamma3) and of d(d(gamma3)/dt)/d(psi), v_slip - (M/(m*R))*S,
 *      gamma3*(I3*M)*C + (G*J3/R)*s, a part of d(d(gamma3)/dt)/d(gamma3), a part of d(d(gamma3)/dt)/d(gamma3),
 *      d(d(gamma3)/dt)/d(gamma3), G*J3/R - ((1)/s^2*Theta)*Theta*s*(gamma3*(I3*M)*C + (G*J3/R)*s),
 *      a part of d(d(psi)/dt)/d(gamma3), a part of d(d(psi)/dt)/d(gamma3), a part of d(d(gamma3)/dt)/d(psi)
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
extern const jlt_descriptor jlt_kernels_spherical_top_plane_general;
extern const struct jlt_ball_table jlt_balls_spherical_top_plane_general;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_baseline;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_avx2;
extern const jlt_kernel_batch jlt_batch_spherical_top_plane_general_avx512;

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
    const double t9 = params[2]*params[5]; /* I1*M */
    out[10] = t9;
    const double t10 = t3*params[4]; /* J1*G */
    const double t11 = t10/params[1]; /* J1*G/R */
    out[11] = t11;
    const double t12 = params[2]*params[3]; /* I1*I3 */
    out[12] = t12;
    const double t13 = params[2]*t2; /* I1*m*R*R */
    out[13] = t13;
    const double t14 = params[3]/params[2]; /* I3/I1 */
    out[14] = t14;
    const double t15 = params[5]/t0; /* M/(m*R) */
    out[15] = t15;
    const double t16 = t2 + params[3]; /* J3 = m*R*R + I3 */
    const double t17 = params[4]*t16; /* G*J3 */
    const double t18 = t17/params[1]; /* G*J3/R */
    out[16] = t18;
    const double t19 = params[3]*params[5]; /* I3*M */
    out[17] = t19;
    const double t20 = params[1]*params[5]; /* R*M */
    const double t21 = params[2]*t3; /* I1*J1 */
    const double t22 = t20/t21; /* R*M/(I1*J1) */
    out[18] = t22;
    const double t23 = params[4]/t5; /* G/(I1*I1) */
    out[19] = t23;
    const double t24 = params[1]*t1; /* R*R*R */
    const double t25 = params[0]*t24; /* m*R*R*R */
    const double t26 = t3*t5; /* J1*I1*I1 */
    const double t27 = t8*t25; /* (I1 - I3)*m*R*R*R */
    const double t28 = t27/t26; /* (I1 - I3)*m*R*R*R/(J1*I1*I1) */
    out[20] = t28;
    const double t29 = 1.0/t3; /* 1/J1 */
    out[21] = t29;
    const double t30 = t8*t20; /* (I1 - I3)*R*M */
    const double t31 = t30/params[2]; /* (I1 - I3)*R*M/I1 */
    out[22] = t31;
    const double t32 = params[0]*2.0; /* m*2 */
    const double t33 = t1*t32; /* R*R*m*2 */
    const double t34 = t8*t33; /* (I1 - I3)*R*R*m*2 */
    out[23] = t34;
    const double t35 = -t19; /* -I3*M */
    out[24] = t35;
    const double t36 = t30/t21; /* (I1 - I3)*R*M/(I1*J1) */
    out[25] = t36;
    const double t37 = t8*t8; /* (I1 - I3)*(I1 - I3) */
    const double t38 = t25*t37; /* m*R*R*R*(I1 - I3)*(I1 - I3) */
    const double t39 = t38/t26; /* m*R*R*R*(I1 - I3)*(I1 - I3)/(J1*I1*I1) */
    out[26] = t39;
    const double t40 = t8*params[4]; /* (I1 - I3)*G */
    const double t41 = t40/t5; /* (I1 - I3)*G/(I1*I1) */
    out[27] = t41;
    const double t42 = t8/t2; /* (I1 - I3)/(m*R*R) */
    out[28] = t42;
    const double t43 = t12/t2; /* I1*I3/(m*R*R) */
    out[29] = t43;
    const double t44 = t19/t2; /* I3*M/(m*R*R) */
    out[30] = t44;
    const double t45 = params[1]*t8; /* R*(I1 - I3) */
    const double t46 = t45/t26; /* R*(I1 - I3)/(J1*I1*I1) */
    out[31] = t46;
    const double t47 = t8/t13; /* (I1 - I3)/(I1*m*R*R) */
    out[32] = t47;
    const double t48 = params[3]/t2; /* I3/(m*R*R) */
    out[33] = t48;
    const double t49 = t8*2.0; /* (I1 - I3)*2 */
    const double t50 = t49/t2; /* (I1 - I3)*2/(m*R*R) */
    out[34] = t50;
    const double t51 = params[2]*2.0; /* I1*2 */
    const double t52 = params[5]*t51; /* M*I1*2 */
    const double t53 = t8*t52; /* (I1 - I3)*M*I1*2 */
    const double t54 = t53/t2; /* (I1 - I3)*M*I1*2/(m*R*R) */
    out[35] = t54;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[14]; /* gamma3*I3/I1 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3) */
    const double t5 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t6 = JLT_FMA(p[13], t4, p[12]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + (1 - gamma3)*(1 + gamma3)) + I1*I3 */
    const double t7 = t5*t6; /* s*Theta */
    const double t8 = 1.0/t7; /* 1/(s*Theta) */
    const double t9 = t6*t8; /* Theta*1/(s*Theta) */
    const double t10 = t5*t8; /* 1/Theta = s*1/(s*Theta) */
    const double t11 = t9*t10; /* Theta*1/(s*Theta)*1/Theta */
    const double t12 = p[9]*t10; /* (I1 - I3)*1/Theta */
    const double t13 = cos(x[1]); /* C = cos(psi) */
    const double t14 = p[10]*t5; /* I1*M*s */
    const double t15 = t13*t14; /* C*I1*M*s */
    const double t16 = JLT_FNMA(x[0], p[11], t15); /* C*I1*M*s - gamma3*G*J1/R */
    const double t17 = t12*t16; /* (I1 - I3)*1/Theta*(C*I1*M*s - gamma3*G*J1/R) */
    const double t18 = JLT_FNMA(t16, t17, p[6]); /* F0 - (C*I1*M*s - gamma3*G*J1/R)*(I1 - I3)*1/Theta*(C*I1*M*s - gamma3*G*J1/R) */
    const double t19 = p[8]*t18; /* 1/(m*I1^2)*t18 */
    const double t20 = sqrt(t19); /* v_slip = sqrt(1/(m*I1^2)*t18) */
    const double t21 = sin(x[1]); /* S = sin(psi) */
    const double t22 = JLT_FNMA(p[15], t21, t20); /* v_slip - M/(m*R)*S */
    const double t23 = p[16]*t5; /* G*J3/R*s */
    const double t24 = p[7]*t5; /* m*R/J1*s */
    const double t25 = t22*t24; /* (v_slip - M/(m*R)*S)*m*R/J1*s */
    out[0] = t25;
    const double t26 = x[0]*p[17]; /* gamma3*I3*M */
    const double t27 = JLT_FMA(t13, t26, t23); /* C*gamma3*I3*M + G*J3/R*s */
    const double t28 = t11*t27; /* Theta*1/(s*Theta)*1/Theta*(C*gamma3*I3*M + G*J3/R*s) */
    out[1] = t28;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = p[10]*t3; /* I1*M*s */
    const double t6 = t4*t5; /* C*I1*M*s */
    const double t7 = JLT_FNMA(x[0], p[11], t6); /* C*I1*M*s - gamma3*G*J1/R */
    const double t8 = x[0]*p[14]; /* gamma3*I3/I1 */
    const double t9 = JLT_FMA(x[0], t8, t2); /* gamma3*gamma3*I3/I1 + s^2 */
    const double t10 = JLT_FMA(p[13], t9, p[12]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + s^2) + I1*I3 */
    const double t11 = t2*t10; /* s^2*Theta */
    const double t12 = 1.0/t11; /* 1/(s^2*Theta) */
    const double t13 = t2*t12; /* 1/Theta = s^2*1/(s^2*Theta) */
    const double t14 = t7*t13; /* (C*I1*M*s - gamma3*G*J1/R)*1/Theta */
    const double t15 = p[9]*t7; /* (I1 - I3)*(C*I1*M*s - gamma3*G*J1/R) */
    const double t16 = JLT_FNMA(t14, t15, p[6]); /* F0 - (C*I1*M*s - gamma3*G*J1/R)*1/Theta*(I1 - I3)*(C*I1*M*s - gamma3*G*J1/R) */
    const double t17 = p[8]*t16; /* v_slip^2 = 1/(m*I1^2)*t16 */
    const double t18 = sqrt(t17); /* v_slip = sqrt(v_slip^2) */
    const double t19 = sin(x[1]); /* S = sin(psi) */
    const double t20 = JLT_FNMA(p[15], t19, t18); /* v_slip - M/(m*R)*S */
    const double t21 = t3*t10; /* s*Theta */
    const double t22 = t12*t21; /* 1/(s^2*Theta)*s*Theta */
    const double t23 = x[0]*t22; /* gamma3*1/(s^2*Theta)*s*Theta */
    const double t24 = p[7]*t23; /* m*R/J1*gamma3*1/(s^2*Theta)*s*Theta */
    const double t25 = t20*t24; /* (v_slip - M/(m*R)*S)*m*R/J1*gamma3*1/(s^2*Theta)*s*Theta */
    const double t26 = t23*p[18]; /* gamma3*1/(s^2*Theta)*s*Theta*R*M/(I1*J1) */
    const double t27 = x[0]*p[20]; /* gamma3*m*R^3*(I1 - I3)/(I1^2*J1) */
    const double t28 = JLT_FMA(t4, t26, p[19]); /* C*gamma3*1/(s^2*Theta)*s*Theta*R*M/(I1*J1) + G/I1^2 */
    const double t29 = JLT_FNMA(t14, t27, t28); /* C*gamma3*1/(s^2*Theta)*s*Theta*R*M/(I1*J1) + G/I1^2 - (C*I1*M*s - gamma3*G*J1/R)*1/Theta*gamma3*m*R^3*(I1 - I3)/(I1^2*J1) */
    const double t30 = t3*t14; /* s*(C*I1*M*s - gamma3*G*J1/R)*1/Theta */
    const double t31 = t30/t17; /* s*(C*I1*M*s - gamma3*G*J1/R)*1/Theta/v_slip^2 */
    const double t32 = t18*t31; /* v_slip*s*(C*I1*M*s - gamma3*G*J1/R)*1/Theta/v_slip^2 */
    const double t33 = p[9]*t29; /* (I1 - I3)*t29 */
    const double t34 = JLT_FMS(t32, t33, t25); /* v_slip*s*(C*I1*M*s - gamma3*G*J1/R)*1/Theta/v_slip^2*(I1 - I3)*t29 - (v_slip - M/(m*R)*S)*m*R/J1*gamma3*1/(s^2*Theta)*s*Theta */
    out[0] = t34;
    const double t35 = t19*p[22]; /* S*R*M*(I1 - I3)/I1 */
    const double t36 = t32*t35; /* v_slip*s*(C*I1*M*s - gamma3*G*J1/R)*1/Theta/v_slip^2*S*R*M*(I1 - I3)/I1 */
    const double t37 = JLT_FNMA(t4, p[5], t36); /* t36 - C*M */
    const double t38 = t3*p[21]; /* s*1/J1 */
    const double t39 = t37*t38; /* (t36 - C*M)*s*1/J1 */
    out[1] = t39;
    const double t40 = t13*t22; /* 1/Theta*1/(s^2*Theta)*s*Theta */
    const double t41 = x[0]*t40; /* gamma3*1/Theta*1/(s^2*Theta)*s*Theta */
    const double t42 = t3*p[16]; /* s*G*J3/R */
    const double t43 = t4*p[17]; /* C*I3*M */
    const double t44 = JLT_FMA(x[0], t43, t42); /* gamma3*C*I3*M + s*G*J3/R */
    const double t45 = JLT_FNMA(t22, t44, p[16]); /* G*J3/R - 1/(s^2*Theta)*s*Theta*(gamma3*C*I3*M + s*G*J3/R) */
    const double t46 = t22*t45; /* 1/(s^2*Theta)*s*Theta*(G*J3/R - 1/(s^2*Theta)*s*Theta*(gamma3*C*I3*M + s*G*J3/R)) */
    const double t47 = t13*p[23]; /* 1/Theta*2*m*R^2*(I1 - I3) */
    const double t48 = JLT_FNMA(t44, t47, t46); /* t46 - (gamma3*C*I3*M + s*G*J3/R)*1/Theta*2*m*R^2*(I1 - I3) */
    const double t49 = t41*t48; /* gamma3*1/Theta*1/(s^2*Theta)*s*Theta*(t46 - (gamma3*C*I3*M + s*G*J3/R)*1/Theta*2*m*R^2*(I1 - I3)) */
    const double t50 = JLT_FMS(t40, t43, t49); /* 1/Theta*1/(s^2*Theta)*s*Theta*C*I3*M - t49 */
    out[2] = t50;
    const double t51 = t41*p[24]; /* gamma3*1/Theta*1/(s^2*Theta)*s*Theta*(-I3*M) */
    const double t52 = t19*t51; /* S*gamma3*1/Theta*1/(s^2*Theta)*s*Theta*(-I3*M) */
    out[3] = t52;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[14]; /* gamma3*I3/I1 */
    const double t4 = JLT_FMA(x[0], t3, t2); /* gamma3*gamma3*I3/I1 + s^2 */
    const double t5 = JLT_FMA(p[13], t4, p[12]); /* Theta = m*R^2*I1*(gamma3*gamma3*I3/I1 + s^2) + I1*I3 */
    const double t6 = t2*t5; /* s^2*Theta */
    const double t7 = 1.0/t6; /* 1/(s^2*Theta) */
    const double t8 = sqrt(t2); /* s = sqrt(s^2) */
    const double t9 = t2*t7; /* 1/Theta = s^2*1/(s^2*Theta) */
    const double t10 = t5*t8; /* Theta*s */
    const double t11 = t7*t10; /* 1/(s^2*Theta)*Theta*s */
    const double t12 = cos(x[1]); /* C = cos(psi) */
    const double t13 = p[10]*t8; /* I1*M*s */
    const double t14 = t12*t13; /* C*I1*M*s */
    const double t15 = JLT_FNMA(x[0], p[11], t14); /* C*I1*M*s - gamma3*G*J1/R */
    const double t16 = t9*t15; /* 1/Theta*(C*I1*M*s - gamma3*G*J1/R) */
    const double t17 = p[9]*t15; /* (I1 - I3)*(C*I1*M*s - gamma3*G*J1/R) */
    const double t18 = JLT_FNMA(t16, t17, p[6]); /* F0 - 1/Theta*(C*I1*M*s - gamma3*G*J1/R)*(I1 - I3)*(C*I1*M*s - gamma3*G*J1/R) */
    const double t19 = p[8]*t18; /* v_slip^2 = 1/(m*I1^2)*t18 */
    const double t20 = t8*t16; /* s*1/Theta*(C*I1*M*s - gamma3*G*J1/R) */
    const double t21 = t20/t19; /* s*1/Theta*(C*I1*M*s - gamma3*G*J1/R)/v_slip^2 */
    const double t22 = sqrt(t19); /* v_slip = sqrt(v_slip^2) */
    const double t23 = t21*t22; /* s*1/Theta*(C*I1*M*s - gamma3*G*J1/R)/v_slip^2*v_slip */
    const double t24 = p[26]*t16; /* m*R^3*(I1 - I3)^2/(I1^2*J1)*1/Theta*(C*I1*M*s - gamma3*G*J1/R) */
    const double t25 = sin(x[1]); /* S = sin(psi) */
    const double t26 = JLT_FNMA(p[15], t25, t22); /* v_slip - M/(m*R)*S */
    const double t27 = p[7]*t26; /* m*R/J1*(v_slip - M/(m*R)*S) */
    const double t28 = t8*t27; /* s*m*R/J1*(v_slip - M/(m*R)*S) */
    out[0] = t28;
    const double t29 = p[16]*t8; /* G*J3/R*s */
    const double t30 = p[21]*t8; /* 1/J1*s */
    const double t31 = p[17]*t12; /* I3*M*C */
    const double t32 = JLT_FMA(x[0], t31, t29); /* gamma3*I3*M*C + G*J3/R*s */
    const double t33 = p[25]*t12; /* R*M*(I1 - I3)/(I1*J1)*C */
    const double t34 = JLT_FMS(t23, t33, t27); /* s*1/Theta*(C*I1*M*s - gamma3*G*J1/R)/v_slip^2*v_slip*R*M*(I1 - I3)/(I1*J1)*C - m*R/J1*(v_slip - M/(m*R)*S) */
    const double t35 = t11*t34; /* 1/(s^2*Theta)*Theta*s*t34 */
    const double t36 = JLT_FNMA(t23, t24, t35); /* 1/(s^2*Theta)*Theta*s*t34 - s*1/Theta*(C*I1*M*s - gamma3*G*J1/R)/v_slip^2*v_slip*t24 */
    const double t37 = x[0]*t36; /* gamma3*t36 */
    const double t38 = JLT_FMA(p[27], t23, t37); /* G*(I1 - I3)/I1^2*s*1/Theta*(C*I1*M*s - gamma3*G*J1/R)/v_slip^2*v_slip + gamma3*t36 */
    out[2] = t38;
    const double t39 = p[23]*t9; /* 2*m*R^2*(I1 - I3)*1/Theta */
    const double t40 = t32*t39; /* (gamma3*I3*M*C + G*J3/R*s)*2*m*R^2*(I1 - I3)*1/Theta */
    const double t41 = t9*t11; /* 1/Theta*1/(s^2*Theta)*Theta*s */
    const double t42 = t32*t41; /* (gamma3*I3*M*C + G*J3/R*s)*1/Theta*1/(s^2*Theta)*Theta*s */
    out[1] = t42;
    const double t43 = JLT_FNMA(t11, t32, p[16]); /* G*J3/R - 1/(s^2*Theta)*Theta*s*(gamma3*I3*M*C + G*J3/R*s) */
    const double t44 = JLT_FNMA(t11, t43, t40); /* (gamma3*I3*M*C + G*J3/R*s)*2*m*R^2*(I1 - I3)*1/Theta - 1/(s^2*Theta)*Theta*s*(G*J3/R - 1/(s^2*Theta)*Theta*s*(gamma3*I3*M*C + G*J3/R*s)) */
    const double t45 = JLT_FMA(x[0], t44, t31); /* gamma3*t44 + I3*M*C */
    const double t46 = t41*t45; /* 1/Theta*1/(s^2*Theta)*Theta*s*(gamma3*t44 + I3*M*C) */
    out[4] = t46;
    const double t47 = p[22]*t25; /* R*M*(I1 - I3)/I1*S */
    const double t48 = t23*t47; /* s*1/Theta*(C*I1*M*s - gamma3*G*J1/R)/v_slip^2*v_slip*R*M*(I1 - I3)/I1*S */
    const double t49 = JLT_FNMA(p[5], t12, t48); /* t48 - M*C */
    const double t50 = t30*t49; /* 1/J1*s*(t48 - M*C) */
    out[3] = t50;
    const double t51 = x[0]*p[24]; /* gamma3*(-I3*M) */
    const double t52 = t41*t51; /* 1/Theta*1/(s^2*Theta)*Theta*s*gamma3*(-I3*M) */
    const double t53 = t25*t52; /* S*1/Theta*1/(s^2*Theta)*Theta*s*gamma3*(-I3*M) */
    out[5] = t53;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[3]; /* gamma3*I3 */
    const double t4 = JLT_FMA(x[0], t3, p[29]); /* gamma3*gamma3*I3 + I1*I3/(m*R^2) */
    const double t5 = JLT_FMA(p[2], t2, t4); /* Theta/(m*R^2) = I1*(1 - gamma3)*(1 + gamma3) + gamma3*gamma3*I3 + I1*I3/(m*R^2) */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = t5*t6; /* Theta/(m*R^2)*s */
    const double t8 = 1.0/t7; /* 1/(Theta/(m*R^2)*s) */
    const double t9 = x[0]*t5; /* gamma3*Theta/(m*R^2) */
    const double t10 = t8*t9; /* 1/(Theta/(m*R^2)*s)*gamma3*Theta/(m*R^2) */
    const double t11 = t6*t8; /* 1/(Theta/(m*R^2)) = s*1/(Theta/(m*R^2)*s) */
    const double t12 = cos(x[1]); /* C = cos(psi) */
    const double t13 = p[10]*t6; /* I1*M*s */
    const double t14 = t12*t13; /* C*I1*M*s */
    const double t15 = JLT_FNMA(x[0], p[11], t14); /* C*I1*M*s - gamma3*G*J1/R */
    const double t16 = t11*t15; /* 1/(Theta/(m*R^2))*(C*I1*M*s - gamma3*G*J1/R) */
    const double t17 = p[30]*t11; /* I3*M/(m*R^2)*1/(Theta/(m*R^2)) */
    const double t18 = p[28]*t16; /* (I1 - I3)/(m*R^2)*1/(Theta/(m*R^2))*(C*I1*M*s - gamma3*G*J1/R) */
    const double t19 = JLT_FNMA(t15, t18, p[6]); /* F0 - (C*I1*M*s - gamma3*G*J1/R)*t18 */
    const double t20 = t6*t18; /* s*t18 */
    const double t21 = p[8]*t19; /* 1/(m*I1^2)*(F0 - (C*I1*M*s - gamma3*G*J1/R)*t18) */
    const double t22 = sqrt(t21); /* v_slip = sqrt(1/(m*I1^2)*(F0 - (C*I1*M*s - gamma3*G*J1/R)*t18)) */
    const double t23 = p[18]*t10; /* R*M/(I1*J1)*1/(Theta/(m*R^2)*s)*gamma3*Theta/(m*R^2) */
    const double t24 = JLT_FMA(t12, t23, p[19]); /* C*R*M/(I1*J1)*1/(Theta/(m*R^2)*s)*gamma3*Theta/(m*R^2) + G/I1^2 */
    const double t25 = x[0]*p[31]; /* gamma3*R*(I1 - I3)/(I1^2*J1) */
    const double t26 = JLT_FNMA(t16, t25, t24); /* t24 - 1/(Theta/(m*R^2))*(C*I1*M*s - gamma3*G*J1/R)*gamma3*R*(I1 - I3)/(I1^2*J1) */
    const double t27 = t20*t26; /* s*t18*t26 */
    const double t28 = t27/t22; /* s*t18*t26/v_slip */
    const double t29 = sin(x[1]); /* S = sin(psi) */
    const double t30 = JLT_FNMA(p[15], t29, t22); /* v_slip - M/(m*R)*S */
    const double t31 = p[7]*t30; /* m*R/J1*(v_slip - M/(m*R)*S) */
    const double t32 = JLT_FMA(t17, t29, t31); /* I3*M/(m*R^2)*1/(Theta/(m*R^2))*S + m*R/J1*(v_slip - M/(m*R)*S) */
    const double t33 = JLT_FNMA(t10, t32, t28); /* s*t18*t26/v_slip - 1/(Theta/(m*R^2)*s)*gamma3*Theta/(m*R^2)*t32 */
    out[0] = t33;
}

static void domain_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t2 = t0*t1; /* (1 - gamma3)*(1 + gamma3) */
    const double t3 = x[0]*p[14]; /* gamma3*I3/I1 */
    const double t4 = p[33] + t2; /* I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t5 = JLT_FMA(x[0], t3, t4); /* Theta/(m*R^2*I1) = gamma3*gamma3*I3/I1 + I3/(m*R^2) + (1 - gamma3)*(1 + gamma3) */
    const double t6 = sqrt(t2); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t7 = cos(x[1]); /* C = cos(psi) */
    const double t8 = p[10]*t6; /* I1*M*s */
    const double t9 = t7*t8; /* C*I1*M*s */
    const double t10 = JLT_FNMA(x[0], p[11], t9); /* C*I1*M*s - gamma3*G*J1/R */
    const double t11 = p[32]/t5; /* (I1 - I3)/(m*R^2*I1)/(Theta/(m*R^2*I1)) */
    const double t12 = t10*t11; /* (C*I1*M*s - gamma3*G*J1/R)*(I1 - I3)/(m*R^2*I1)/(Theta/(m*R^2*I1)) */
    const double t13 = JLT_FNMA(t10, t12, p[6]); /* F0 - (C*I1*M*s - gamma3*G*J1/R)*t12 */
    out[0] = t13;
}

static void domain_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t1 = x[0] + 1.0; /* gamma3 + 1 */
    const double t2 = t0*t1; /* s^2 = (1 - gamma3)*(gamma3 + 1) */
    const double t3 = sqrt(t2); /* s = sqrt(s^2) */
    const double t4 = cos(x[1]); /* C = cos(psi) */
    const double t5 = p[10]*t3; /* I1*M*s */
    const double t6 = t4*t5; /* C*I1*M*s */
    const double t7 = p[35]*t3; /* 2*I1*M*(I1 - I3)/(m*R^2)*s */
    const double t8 = x[0]*p[3]; /* gamma3*I3 */
    const double t9 = JLT_FMA(x[0], t8, p[29]); /* gamma3*gamma3*I3 + I1*I3/(m*R^2) */
    const double t10 = JLT_FMA(p[2], t2, t9); /* Theta/(m*R^2) = I1*s^2 + gamma3*gamma3*I3 + I1*I3/(m*R^2) */
    const double t11 = t6/t2; /* C*I1*M*s/s^2 */
    const double t12 = JLT_FNMA(x[0], p[11], t6); /* C*I1*M*s - gamma3*G*J1/R */
    const double t13 = t12/t10; /* (C*I1*M*s - gamma3*G*J1/R)/(Theta/(m*R^2)) */
    const double t14 = JLT_FNMA(p[9], t13, t11); /* C*I1*M*s/s^2 - (I1 - I3)*(C*I1*M*s - gamma3*G*J1/R)/(Theta/(m*R^2)) */
    const double t15 = JLT_FMA(x[0], t14, p[11]); /* gamma3*t14 + G*J1/R */
    const double t16 = sin(x[1]); /* S = sin(psi) */
    const double t17 = t7*t16; /* 2*I1*M*(I1 - I3)/(m*R^2)*s*S */
    const double t18 = t13*t17; /* (C*I1*M*s - gamma3*G*J1/R)/(Theta/(m*R^2))*2*I1*M*(I1 - I3)/(m*R^2)*s*S */
    out[1] = t18;
    const double t19 = p[34]*t13; /* 2*(I1 - I3)/(m*R^2)*(C*I1*M*s - gamma3*G*J1/R)/(Theta/(m*R^2)) */
    const double t20 = t15*t19; /* (gamma3*t14 + G*J1/R)*t19 */
    out[0] = t20;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double u19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    double t24[JLT_JET_ORDER_MAX + 1];
    double t25[JLT_JET_ORDER_MAX + 1];
    double t26[JLT_JET_ORDER_MAX + 1];
    double t27[JLT_JET_ORDER_MAX + 1];
    double t28[JLT_JET_ORDER_MAX + 1];
    double t30[JLT_JET_ORDER_MAX + 1];
    double u30[JLT_JET_ORDER_MAX + 1];
    double t31[JLT_JET_ORDER_MAX + 1];
    double t32[JLT_JET_ORDER_MAX + 1];
    double t33[JLT_JET_ORDER_MAX + 1];
    double t35[JLT_JET_ORDER_MAX + 1];
    double t37[JLT_JET_ORDER_MAX + 1];
    double t38[JLT_JET_ORDER_MAX + 1];
    double t39[JLT_JET_ORDER_MAX + 1];
    double t40[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = (k == 0 ? 1.0 : 0) - x0[k];
        t4[k] = (k == 0 ? 1.0 : 0) + x0[k];
        t5[k] = jlt_jet_product(t3, t4, k);
        t6[k] = jlt_jet_root(t5[k], t6, k);
        t13[k] = x0[k]*p[14];
        t14[k] = jlt_jet_product(x0, t13, k) + t5[k];
        t15[k] = p[13]*t14[k] + (k == 0 ? p[12] : 0);
        t16[k] = jlt_jet_quotient((k == 0 ? 1.0 : 0), t15, t16, k);
        t19[k] = jlt_jet_cosine(x1, t19, u19, k);
        t20[k] = t6[k]*p[10];
        t21[k] = jlt_jet_product(t19, t20, k);
        t23[k] = t21[k] - x0[k]*p[11];
        t24[k] = p[9]*t16[k];
        t25[k] = jlt_jet_product(t23, t24, k);
        t26[k] = (k == 0 ? p[6] : 0) - jlt_jet_product(t23, t25, k);
        t27[k] = p[8]*t26[k];
        t28[k] = jlt_jet_root(t27[k], t28, k);
        t30[k] = jlt_jet_sine(x1, t30, u30, k);
        t31[k] = t28[k] - p[15]*t30[k];
        t32[k] = p[7]*t6[k];
        t33[k] = jlt_jet_product(t31, t32, k);
        t35[k] = t6[k]*p[16];
        t37[k] = x0[k]*p[17];
        t38[k] = jlt_jet_product(t19, t37, k) + t35[k];
        t39[k] = jlt_jet_quotient(t16[k], t6, t39, k);
        t40[k] = jlt_jet_product(t38, t39, k);
        double *restrict next = coefficients + (k + 1)*2;
        next[0] = x0[k + 1] = t33[k]/(k + 1);
        next[1] = x1[k + 1] = t40[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_gamma3 = x[0];
    const double complex v_s = csqrt(1.0 - v_gamma3*v_gamma3);
    const double v_I1 = params[2];
    const double v_m = params[0];
    const double v_R = params[1];
    const double complex v_J1 = (v_I1 + v_m*v_R*v_R);
    const double v_F0 = params[6];
    const double v_I3 = params[3];
    const double complex v_Theta = (v_I1*v_I3 + v_m*v_R*v_R*(v_I1*v_s*v_s + v_I3*v_gamma3*v_gamma3));
    const double v_M = params[5];
    const double complex v_psi = x[1];
    const double complex v_C = ccos(v_psi);
    const double v_G = params[4];
    const double complex v_omega3 = ((v_I1*v_M*v_s*v_C - v_G*v_gamma3*v_J1/v_R)/v_Theta);
    const double complex v_v_slip = csqrt((v_F0 - v_Theta*v_omega3*v_omega3*(v_I1 - v_I3))/(v_m*v_I1*v_I1));
    const double complex v_S = csin(v_psi);
    const double complex v_omega_tau = ((v_m*v_R*v_v_slip - v_M*v_S)/v_J1);
    out[0] = (v_s*v_omega_tau);
    const double complex v_J3 = (v_I3 + v_m*v_R*v_R);
    const double complex v_omega_n = ((v_G*v_s*v_J3/v_R + v_I3*v_M*v_gamma3*v_C)/v_Theta);
    out[1] = (v_omega_n/v_s);
}

static void tier_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[2]*params[2]; /* I1*I1 */
    const double t1 = params[0]*t0; /* m*I1*I1 */
    const double t2 = params[2]*params[3]; /* I1*I3 */
    const double t3 = params[1]*params[1]; /* R*R */
    const double t4 = params[0]*t3; /* m*R*R */
    const double t5 = 1.0 - x[0]; /* 1 - gamma3 */
    const double t6 = 1.0 + x[0]; /* 1 + gamma3 */
    const double t7 = t5*t6; /* (1 - gamma3)*(1 + gamma3) */
    const double t8 = sqrt(t7); /* s = sqrt((1 - gamma3)*(1 + gamma3)) */
    const double t9 = t8*t8; /* s*s */
    const double t10 = params[2]*t9; /* I1*s*s */
    const double t11 = x[0]*x[0]; /* gamma3*gamma3 */
    const double t12 = params[3]*t11; /* I3*gamma3*gamma3 */
    const double t13 = t10 + t12; /* I1*s*s + I3*gamma3*gamma3 */
    const double t14 = t4*t13; /* m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t15 = t2 + t14; /* Theta = I1*I3 + m*R*R*(I1*s*s + I3*gamma3*gamma3) */
    const double t16 = params[2]*params[5]; /* I1*M */
    const double t17 = t8*t16; /* s*I1*M */
    const double t18 = cos(x[1]); /* C = cos(psi) */
    const double t19 = t17*t18; /* s*I1*M*C */
    const double t20 = x[0]*params[4]; /* gamma3*G */
    const double t21 = params[2] + t4; /* J1 = I1 + m*R*R */
    const double t22 = t20*t21; /* gamma3*G*J1 */
    const double t23 = t22/params[1]; /* gamma3*G*J1/R */
    const double t24 = t19 - t23; /* s*I1*M*C - gamma3*G*J1/R */
    const double t25 = t24*t24; /* (s*I1*M*C - gamma3*G*J1/R)*(s*I1*M*C - gamma3*G*J1/R) */
    const double t26 = params[2] - params[3]; /* I1 - I3 */
    const double t27 = t25*t26; /* (s*I1*M*C - gamma3*G*J1/R)*(s*I1*M*C - gamma3*G*J1/R)*(I1 - I3) */
    const double t28 = t27/t15; /* t27/Theta */
    const double t29 = params[6] - t28; /* F0 - t27/Theta */
    const double t30 = t29/t1; /* (F0 - t27/Theta)/(m*I1*I1) */
    const double t31 = sqrt(t30); /* v_slip = sqrt((F0 - t27/Theta)/(m*I1*I1)) */
    const double t32 = t31*t31; /* v_slip*v_slip */
    const double t33 = t1*t32; /* m*I1*I1*v_slip*v_slip */
    const double t34 = t33*50.0; /* m*I1*I1*v_slip*v_slip*50 */
    const double t35 = t34 - params[6]; /* m*I1*I1*v_slip*v_slip*50 - F0 */
    out[0] = t35;
    const double t36 = params[6] + t34; /* F0 + m*I1*I1*v_slip*v_slip*50 */
    out[1] = t36;
}

static const jlt_way_condition tier_conditions[] = {
    { "50*m*I1^2*v_slip^2 - F0 > 0", 0 },
    { "50*m*I1^2*v_slip^2 + F0 > 0", 0 },
};

static const jlt_quantity states[] = {
    { "gamma3", "", "cosine of the tilt of the symmetry axis", (-1.0), 1.0, JLT_ANY_SIGN, NAN, 0.0 },
    { "psi", "rad", "angle of the horizontal momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 2.0*0x1.921fb54442d18p+1 },
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

const jlt_descriptor jlt_kernels_spherical_top_plane_general = {
    .model = "spherical_top_plane",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Balanced sphere with one nonholonomic constraint, on a level of all three integrals",
    .source = "A. A. Kilin, T. B. Ivanova, Rus. J. Nonlin. Dyn. 19(4), 2023, 533-543, section 4.1",
    .sha256 = "ca43e6402d257c70e6eccfa27f5263e94f71e8470105f669a4f962a6db2fa7f6",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_spherical_top_plane, .family = jlt_family_spherical_top_plane, .claims = jlt_claims_spherical_top_plane,
    .scales = 1,
    .state_count = 2, .param_count = 7, .prepared_count = 36,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 2, { 2, 16, 6, 1, 2, 2, 14, 6 }, { 10, 32, 0, 6, 2, 2, 16, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*(I1*M)*s - gamma3*(G*J1/R), a part of d(gamma3)/dt, v_slip - (M/(m*R))*S, C*gamma3*(I3*M) + (G*J3/R)*s" },
    .jacobian = { jacobian, 4, { 2, 32, 13, 2, 2, 2, 15, 12 }, { 28, 104, 0, 21, 2, 2, 18, 14 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*(I1*M)*s - gamma3*(G*J1/R), a part of d(d(gamma3)/dt)/d(gamma3) and of d(d(gamma3)/dt)/d(psi), v_slip - (M/(m*R))*S, a part of d(d(gamma3)/dt)/d(gamma3), d(d(gamma3)/dt)/d(gamma3), a part of d(d(gamma3)/dt)/d(psi), gamma3*C*(I3*M) + s*(G*J3/R), G*J3/R - ((1)/s^2*Theta)*s*Theta*(gamma3*C*(I3*M) + s*(G*J3/R)), a part of d(d(psi)/dt)/d(gamma3), d(d(psi)/dt)/d(gamma3)" },
    .rhs_jacobian = { rhs_jacobian, 6, { 2, 33, 13, 2, 2, 2, 18, 12 }, { 30, 114, 0, 24, 2, 2, 18, 15 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*(I1*M)*s - gamma3*(G*J1/R), a part of d(gamma3)/dt and of d(d(gamma3)/dt)/d(gamma3) and of d(d(gamma3)/dt)/d(psi), v_slip - (M/(m*R))*S, gamma3*(I3*M)*C + (G*J3/R)*s, a part of d(d(gamma3)/dt)/d(gamma3), a part of d(d(gamma3)/dt)/d(gamma3), d(d(gamma3)/dt)/d(gamma3), G*J3/R - ((1)/s^2*Theta)*Theta*s*(gamma3*(I3*M)*C + (G*J3/R)*s), a part of d(d(psi)/dt)/d(gamma3), a part of d(d(psi)/dt)/d(gamma3), a part of d(d(gamma3)/dt)/d(psi)" },
    .divergence = { divergence, 1, { 2, 17, 9, 2, 2, 2, 15, 8 }, { 18, 59, 0, 12, 2, 2, 19, 13 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; divides by v_slip: values and rounding errors grow without bound where it vanishes; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; takes v_slip = sqrt((F0 - (I1*M*s*C - G*gamma3*J1/R)^2*(I1 - I3)/Theta)/(m*I1^2)): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*(I1*M)*s - gamma3*(G*J1/R), a part of the divergence, a part of the divergence, v_slip - (M/(m*R))*S, (I3*M/(m*R^2))*1/(Theta/(m*R^2))*S + (m*R/J1)*(v_slip - (M/(m*R))*S), the divergence" },
    .integral_values = { .loses_digits = "" },
    .integral_gradients = { .loses_digits = "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { domain_values, 1, { 3, 5, 3, 1, 1, 1, 8, 4 }, { 7, 18, 0, 2, 1, 1, 10, 6 },
        "divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*(I1*M)*s - gamma3*(G*J1/R), motion" },
    .domain_gradients = { domain_gradients, 2, { 2, 9, 5, 2, 1, 2, 10, 5 }, { 13, 49, 0, 8, 1, 2, 13, 9 },
        "divides by s: values and rounding errors grow without bound where it vanishes; divides by Theta, small only where all of I1*I3 and m*R^2*(I1*s^2 + I3*gamma3^2) are; takes s = sqrt(1 - gamma3^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in C*(I1*M)*s - gamma3*(G*J1/R), a part of d(motion)/d(gamma3), a part of d(motion)/d(gamma3)" },
    .domain_count = 1, .domains = domains,
    .pole_count = 1, .poles = poles,
    .tier = "plane", .tier_meaning = "a3 = 0: the flow on a half of M^2, levels of E, G and F0 fixed",
    .tier_condition_count = 2, .tier_conditions = tier_conditions,
    .tier_values = tier_values,
    .integral_count = 0, .measure_count = 0, .equilibria_count = 0,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_spherical_top_plane_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_spherical_top_plane_general) },
#endif
};
