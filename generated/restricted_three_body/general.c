/* Planar circular restricted three-body problem
 *
 *  Source:     V. Szebehely, Theory of Orbits, Academic Press, 1967; R. F. Arenstorf, Amer. J. Math. 85 (1963) 27-35
 *  Table:      restricted_three_body, SHA-256 be92c80fa5ae653bcafd1a9f9b49cfb47d443deafac9921503338276e0a9706f
 *  Command:    ttc generate --effort full --out DIR restricted_three_body.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3    8    7    1    2    0      9    6   (40)
 *  jacobian            4   15    7    1    2    0     12    9   (104)
 *  rhs_jacobian        4   17   11    1    2    0     12   11   (133)
 *  divergence          0    0    0    0    0    0      0    0   (0)
 *  integral_values     2    3    7    1    2    0      7    5   (27)
 *  integral_gradients  3    3    5    2    2    0      7    6   (36)
 *  measure_values      0    0    0    0    0    0      0    0   (0)
 *  measure_divergences 0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    divides by r1: values and rounding errors grow without bound where it vanishes
 *    divides by r2: values and rounding errors grow without bound where it vanishes
 *    takes r1 = sqrt((mu + x)^2 + y^2): rounding errors of the states grow without bound where it vanishes
 *    takes r2 = sqrt(y^2 + (-1 + mu + x)^2): rounding errors of the states grow without bound where it vanishes
 *    digits are lost where terms nearly cancel in -3 + 3*mu, x + -1 + mu,
 *      (-1 + mu)*1/r1^2*1/r1^2*r1 + 1 - mu*1/r2^2*r2*1/r2^2,
 *      1/r1^2*1/r1^2*r1*(-3 + 3*mu)*1/r1^2 - 1/r2^2*r2*1/r2^2*(3*mu)*1/r2^2, d(d(vy)/dt)/d(y), d(d(vx)/dt)/d(x),
 *      a part of d(d(vx)/dt)/d(y) and of d(d(vy)/dt)/d(x), d(vy)/dt, d(vx)/dt
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_restricted_three_body[];
extern const jlt_claim jlt_claims_restricted_three_body[];
extern const jlt_descriptor *const jlt_family_restricted_three_body[];
extern const jlt_descriptor jlt_kernels_restricted_three_body_general;
extern const struct jlt_ball_table jlt_balls_restricted_three_body_general;
extern const jlt_kernel_batch jlt_batch_restricted_three_body_general_baseline;
extern const jlt_kernel_batch jlt_batch_restricted_three_body_general_avx2;
extern const jlt_kernel_batch jlt_batch_restricted_three_body_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    const double t0 = (-1.0) + params[0]; /* -1 + mu */
    out[1] = t0;
    const double t1 = t0/params[0]; /* (-1 + mu)/mu */
    out[2] = t1;
    const double t2 = params[0]*3.0; /* mu*3 */
    out[3] = t2;
    const double t3 = t2 + (-3.0); /* mu*3 + -3 */
    out[4] = t3;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = x[2];
    out[1] = x[3];
    const double t0 = x[0] + p[1]; /* x + -1 + mu */
    const double t1 = x[0] + p[0]; /* x + mu */
    const double t2 = x[1]*x[1]; /* y*y */
    const double t3 = JLT_FMA(t1, t1, t2); /* (x + mu)*(x + mu) + y*y */
    const double t4 = sqrt(t3); /* r1 = sqrt((x + mu)*(x + mu) + y*y) */
    const double t5 = t3*t4; /* ((x + mu)*(x + mu) + y*y)*r1 */
    const double t6 = JLT_FMA(t0, t0, t2); /* (x + -1 + mu)*(x + -1 + mu) + y*y */
    const double t7 = sqrt(t6); /* r2 = sqrt((x + -1 + mu)*(x + -1 + mu) + y*y) */
    const double t8 = t6*t7; /* ((x + -1 + mu)*(x + -1 + mu) + y*y)*r2 */
    const double t9 = t5*t8; /* ((x + mu)*(x + mu) + y*y)*r1*((x + -1 + mu)*(x + -1 + mu) + y*y)*r2 */
    const double t10 = 1.0/t9; /* 1/t9 */
    const double t11 = p[0]*t5; /* mu*((x + mu)*(x + mu) + y*y)*r1 */
    const double t12 = t10*t11; /* 1/t9*mu*((x + mu)*(x + mu) + y*y)*r1 */
    const double t13 = p[1]*t8; /* (-1 + mu)*((x + -1 + mu)*(x + -1 + mu) + y*y)*r2 */
    const double t14 = t10*t13; /* 1/t9*(-1 + mu)*((x + -1 + mu)*(x + -1 + mu) + y*y)*r2 */
    const double t15 = JLT_FMA(x[3], 2.0, x[0]); /* vy*2 + x */
    const double t16 = JLT_FNMA(t0, t12, t15); /* vy*2 + x - (x + -1 + mu)*1/t9*mu*((x + mu)*(x + mu) + y*y)*r1 */
    const double t17 = JLT_FMA(t1, t14, t16); /* (x + mu)*1/t9*(-1 + mu)*((x + -1 + mu)*(x + -1 + mu) + y*y)*r2 + t16 */
    out[2] = t17;
    const double t18 = t14 - t12; /* 1/t9*(-1 + mu)*((x + -1 + mu)*(x + -1 + mu) + y*y)*r2 - 1/t9*mu*((x + mu)*(x + mu) + y*y)*r1 */
    const double t19 = JLT_FNMA(x[2], 2.0, x[1]); /* y - vx*2 */
    const double t20 = JLT_FMA(x[1], t18, t19); /* y*t18 + y - vx*2 */
    out[3] = t20;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[10] = 0.0;
    out[15] = 0.0;
    out[2] = 1.0;
    out[7] = 1.0;
    out[11] = 2.0;
    out[14] = (-2.0);
    const double t0 = x[0] + p[1]; /* x + -1 + mu */
    const double t1 = p[0] + x[0]; /* mu + x */
    const double t2 = x[1]*x[1]; /* y*y */
    const double t3 = t0*t0; /* (x + -1 + mu)*(x + -1 + mu) */
    const double t4 = JLT_FMA(t1, t1, t2); /* r1^2 = (mu + x)*(mu + x) + y*y */
    const double t5 = t2 + t3; /* r2^2 = y*y + (x + -1 + mu)*(x + -1 + mu) */
    const double t6 = t4*t5; /* r1^2*r2^2 */
    const double t7 = 1.0/t6; /* 1/(r1^2*r2^2) */
    const double t8 = sqrt(t4); /* r1 = sqrt(r1^2) */
    const double t9 = t4*t7; /* 1/r2^2 = r1^2*1/(r1^2*r2^2) */
    const double t10 = t5*t7; /* 1/r1^2 = r2^2*1/(r1^2*r2^2) */
    const double t11 = sqrt(t5); /* r2 = sqrt(r2^2) */
    const double t12 = t8*t10; /* r1*1/r1^2 */
    const double t13 = t9*t11; /* 1/r2^2*r2 */
    const double t14 = t10*t12; /* 1/r1^2*r1*1/r1^2 */
    const double t15 = t9*t13; /* 1/r2^2*1/r2^2*r2 */
    const double t16 = p[4]*t10; /* (-3 + 3*mu)*1/r1^2 */
    const double t17 = p[3]*t9; /* 3*mu*1/r2^2 */
    const double t18 = t14*t16; /* 1/r1^2*r1*1/r1^2*(-3 + 3*mu)*1/r1^2 */
    const double t19 = JLT_FMS(p[2], t14, t15); /* (-1 + mu)/mu*1/r1^2*r1*1/r1^2 - 1/r2^2*1/r2^2*r2 */
    const double t20 = t15*t17; /* 1/r2^2*1/r2^2*r2*3*mu*1/r2^2 */
    const double t21 = JLT_FMA(p[0], t19, 1.0); /* mu*((-1 + mu)/mu*1/r1^2*r1*1/r1^2 - 1/r2^2*1/r2^2*r2) + 1 */
    const double t22 = JLT_FMA(t3, t20, t21); /* (x + -1 + mu)*(x + -1 + mu)*1/r2^2*1/r2^2*r2*3*mu*1/r2^2 + mu*((-1 + mu)/mu*1/r1^2*r1*1/r1^2 - 1/r2^2*1/r2^2*r2) + 1 */
    const double t23 = t1*t18; /* (mu + x)*1/r1^2*r1*1/r1^2*(-3 + 3*mu)*1/r1^2 */
    const double t24 = JLT_FNMA(t1, t23, t22); /* t22 - (mu + x)*(mu + x)*1/r1^2*r1*1/r1^2*(-3 + 3*mu)*1/r1^2 */
    out[8] = t24;
    const double t25 = JLT_FMS(t0, t20, t23); /* (x + -1 + mu)*1/r2^2*1/r2^2*r2*3*mu*1/r2^2 - (mu + x)*1/r1^2*r1*1/r1^2*(-3 + 3*mu)*1/r1^2 */
    const double t26 = t20 - t18; /* 1/r2^2*1/r2^2*r2*3*mu*1/r2^2 - 1/r1^2*r1*1/r1^2*(-3 + 3*mu)*1/r1^2 */
    const double t27 = JLT_FMA(t2, t26, t21); /* y*y*t26 + mu*((-1 + mu)/mu*1/r1^2*r1*1/r1^2 - 1/r2^2*1/r2^2*r2) + 1 */
    out[13] = t27;
    const double t28 = x[1]*t25; /* y*t25 */
    out[9] = t28;
    out[12] = t28;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = x[2];
    out[1] = x[3];
    out[15] = 2.0;
    out[6] = 1.0;
    out[11] = 1.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[10] = 0.0;
    out[14] = 0.0;
    out[19] = 0.0;
    out[18] = (-2.0);
    const double t0 = x[0] + p[1]; /* x + -1 + mu */
    const double t1 = x[1]*x[1]; /* y*y */
    const double t2 = t0*t0; /* (x + -1 + mu)*(x + -1 + mu) */
    const double t3 = x[0] + p[0]; /* x + mu */
    const double t4 = t1 + t2; /* r2^2 = y*y + (x + -1 + mu)*(x + -1 + mu) */
    const double t5 = JLT_FMA(t3, t3, t1); /* r1^2 = (x + mu)*(x + mu) + y*y */
    const double t6 = t4*t5; /* r2^2*r1^2 */
    const double t7 = 1.0/t6; /* 1/(r2^2*r1^2) */
    const double t8 = sqrt(t4); /* r2 = sqrt(r2^2) */
    const double t9 = t4*t7; /* 1/r1^2 = r2^2*1/(r2^2*r1^2) */
    const double t10 = t5*t7; /* 1/r2^2 = r1^2*1/(r2^2*r1^2) */
    const double t11 = sqrt(t5); /* r1 = sqrt(r1^2) */
    const double t12 = t8*t10; /* r2*1/r2^2 */
    const double t13 = t9*t11; /* 1/r1^2*r1 */
    const double t14 = t10*t12; /* 1/r2^2*r2*1/r2^2 */
    const double t15 = t9*t13; /* 1/r1^2*1/r1^2*r1 */
    const double t16 = p[3]*t10; /* 3*mu*1/r2^2 */
    const double t17 = p[4]*t9; /* (-3 + 3*mu)*1/r1^2 */
    const double t18 = t14*t16; /* 1/r2^2*r2*1/r2^2*3*mu*1/r2^2 */
    const double t19 = p[0]*t14; /* mu*1/r2^2*r2*1/r2^2 */
    const double t20 = t3*t15; /* (x + mu)*1/r1^2*1/r1^2*r1 */
    const double t21 = JLT_FMA(p[1], t15, 1.0); /* (-1 + mu)*1/r1^2*1/r1^2*r1 + 1 */
    const double t22 = t21 - t19; /* (-1 + mu)*1/r1^2*1/r1^2*r1 + 1 - mu*1/r2^2*r2*1/r2^2 */
    const double t23 = JLT_FMA(t2, t18, t22); /* (x + -1 + mu)*(x + -1 + mu)*1/r2^2*r2*1/r2^2*3*mu*1/r2^2 + (-1 + mu)*1/r1^2*1/r1^2*r1 + 1 - mu*1/r2^2*r2*1/r2^2 */
    const double t24 = JLT_FMS(t15, t17, t18); /* 1/r1^2*1/r1^2*r1*(-3 + 3*mu)*1/r1^2 - 1/r2^2*r2*1/r2^2*3*mu*1/r2^2 */
    const double t25 = JLT_FNMA(t1, t24, t22); /* (-1 + mu)*1/r1^2*1/r1^2*r1 + 1 - mu*1/r2^2*r2*1/r2^2 - y*y*t24 */
    out[17] = t25;
    const double t26 = t17*t20; /* (-3 + 3*mu)*1/r1^2*(x + mu)*1/r1^2*1/r1^2*r1 */
    const double t27 = JLT_FNMA(t3, t26, t23); /* t23 - (x + mu)*(-3 + 3*mu)*1/r1^2*(x + mu)*1/r1^2*1/r1^2*r1 */
    out[12] = t27;
    const double t28 = JLT_FMS(t0, t18, t26); /* (x + -1 + mu)*1/r2^2*r2*1/r2^2*3*mu*1/r2^2 - (-3 + 3*mu)*1/r1^2*(x + mu)*1/r1^2*1/r1^2*r1 */
    const double t29 = x[1]*t28; /* y*t28 */
    out[13] = t29;
    out[16] = t29;
    const double t30 = x[1]*t22; /* y*((-1 + mu)*1/r1^2*1/r1^2*r1 + 1 - mu*1/r2^2*r2*1/r2^2) */
    const double t31 = JLT_FNMA(x[2], 2.0, t30); /* y*((-1 + mu)*1/r1^2*1/r1^2*r1 + 1 - mu*1/r2^2*r2*1/r2^2) - vx*2 */
    out[3] = t31;
    const double t32 = JLT_FMA(x[3], 2.0, x[0]); /* vy*2 + x */
    const double t33 = JLT_FNMA(t0, t19, t32); /* vy*2 + x - (x + -1 + mu)*mu*1/r2^2*r2*1/r2^2 */
    const double t34 = JLT_FMA(p[1], t20, t33); /* (-1 + mu)*(x + mu)*1/r1^2*1/r1^2*r1 + vy*2 + x - (x + -1 + mu)*mu*1/r2^2*r2*1/r2^2 */
    out[2] = t34;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1]*x[1]; /* y*y */
    const double t1 = JLT_FNMA(x[2], x[2], t0); /* y*y - vx*vx */
    const double t2 = JLT_FNMA(x[3], x[3], t1); /* y*y - vx*vx - vy*vy */
    const double t3 = JLT_FMA(x[0], x[0], t2); /* x*x + y*y - vx*vx - vy*vy */
    const double t4 = x[0] + p[1]; /* x + -1 + mu */
    const double t5 = JLT_FMA(t4, t4, t0); /* (x + -1 + mu)*(x + -1 + mu) + y*y */
    const double t6 = sqrt(t5); /* r2 = sqrt((x + -1 + mu)*(x + -1 + mu) + y*y) */
    const double t7 = x[0] + p[0]; /* x + mu */
    const double t8 = JLT_FMA(t7, t7, t0); /* (x + mu)*(x + mu) + y*y */
    const double t9 = sqrt(t8); /* r1 = sqrt((x + mu)*(x + mu) + y*y) */
    const double t10 = t6*t9; /* r2*r1 */
    const double t11 = JLT_FMS(t6, p[2], t9); /* r2*(-1 + mu)/mu - r1 */
    const double t12 = p[0]*t11; /* mu*(r2*(-1 + mu)/mu - r1) */
    const double t13 = t12/t10; /* mu*(r2*(-1 + mu)/mu - r1)/(r2*r1) */
    const double t14 = JLT_FNMA((1.0 / 2.0), t3, t13); /* mu*(r2*(-1 + mu)/mu - r1)/(r2*r1) - 1/2*(x*x + y*y - vx*vx - vy*vy) */
    out[0] = t14;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0] + p[1]; /* x + -1 + mu */
    const double t1 = x[1]*x[1]; /* y*y */
    const double t2 = JLT_FMA(t0, t0, t1); /* (x + -1 + mu)*(x + -1 + mu) + y*y */
    const double t3 = sqrt(t2); /* r2 = sqrt((x + -1 + mu)*(x + -1 + mu) + y*y) */
    const double t4 = t2*t3; /* ((x + -1 + mu)*(x + -1 + mu) + y*y)*r2 */
    const double t5 = p[0]/t4; /* mu/(((x + -1 + mu)*(x + -1 + mu) + y*y)*r2) */
    const double t6 = x[0] + p[0]; /* x + mu */
    const double t7 = JLT_FMA(t6, t6, t1); /* (x + mu)*(x + mu) + y*y */
    const double t8 = sqrt(t7); /* r1 = sqrt((x + mu)*(x + mu) + y*y) */
    const double t9 = t7*t8; /* ((x + mu)*(x + mu) + y*y)*r1 */
    const double t10 = p[1]/t9; /* (-1 + mu)/(((x + mu)*(x + mu) + y*y)*r1) */
    const double t11 = JLT_FMS(t0, t5, x[0]); /* (x + -1 + mu)*mu/(((x + -1 + mu)*(x + -1 + mu) + y*y)*r2) - x */
    const double t12 = JLT_FNMA(t6, t10, t11); /* t11 - (x + mu)*(-1 + mu)/(((x + mu)*(x + mu) + y*y)*r1) */
    out[0] = t12;
    const double t13 = t5 - t10; /* mu/(((x + -1 + mu)*(x + -1 + mu) + y*y)*r2) - (-1 + mu)/(((x + mu)*(x + mu) + y*y)*r1) */
    const double t14 = JLT_FMS(x[1], t13, x[1]); /* y*t13 - y */
    out[1] = t14;
    out[2] = x[2];
    out[3] = x[3];
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 1.0;
}

static void measure_divergences(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double x3[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t13[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    double t19[JLT_JET_ORDER_MAX + 1];
    double t20[JLT_JET_ORDER_MAX + 1];
    double t21[JLT_JET_ORDER_MAX + 1];
    double t22[JLT_JET_ORDER_MAX + 1];
    double t23[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    for (unsigned k = 0; k < order; k++) {
        t5[k] = x0[k] + (k == 0 ? p[1] : 0);
        t8[k] = jlt_jet_product(x1, x1, k);
        t9[k] = jlt_jet_product(t5, t5, k) + t8[k];
        t10[k] = jlt_jet_root(t9[k], t10, k);
        t11[k] = jlt_jet_product(t9, t10, k);
        t12[k] = jlt_jet_quotient((k == 0 ? p[0] : 0), t11, t12, k);
        t13[k] = x0[k] + (k == 0 ? p[0] : 0);
        t14[k] = jlt_jet_product(t13, t13, k) + t8[k];
        t15[k] = jlt_jet_root(t14[k], t15, k);
        t16[k] = jlt_jet_product(t14, t15, k);
        t17[k] = jlt_jet_quotient((k == 0 ? p[1] : 0), t16, t17, k);
        t18[k] = x3[k]*2.0 + x0[k];
        t19[k] = t18[k] - jlt_jet_product(t5, t12, k);
        t20[k] = jlt_jet_product(t13, t17, k) + t19[k];
        t21[k] = t17[k] - t12[k];
        t22[k] = x1[k] - x2[k]*2.0;
        t23[k] = jlt_jet_product(x1, t21, k) + t22[k];
        double *restrict next = coefficients + (k + 1)*4;
        next[0] = x0[k + 1] = x2[k]/(k + 1);
        next[1] = x1[k + 1] = x3[k]/(k + 1);
        next[2] = x2[k + 1] = t20[k]/(k + 1);
        next[3] = x3[k + 1] = t23[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_vx = x[2];
    out[0] = (v_vx);
    const double complex v_vy = x[3];
    out[1] = (v_vy);
    const double complex v_x = x[0];
    const double v_mu = params[0];
    const double complex v_y = x[1];
    const double complex v_r1 = csqrt((v_mu + v_x)*(v_mu + v_x) + v_y*v_y);
    const double complex v_r2 = csqrt(v_y*v_y + (-1.0 + v_mu + v_x)*(-1.0 + v_mu + v_x));
    out[2] = (v_x)
        + (2.0*v_vy)
        + ((v_mu + v_x)*(-1.0 + v_mu)/(v_r1*v_r1*v_r1))
        + (-v_mu*(-1.0 + v_mu + v_x)/(v_r2*v_r2*v_r2));
    out[3] = (v_y)
        + (-2.0*v_vx)
        + (v_y*(-1.0 + v_mu)/(v_r1*v_r1*v_r1))
        + (-v_mu*v_y/(v_r2*v_r2*v_r2));
}

static const unsigned char family0_is_free[] = { 0, 0, 0, 0 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    const double t0 = (1.0 / 2.0) - params[0]; /* x = 1/2 - mu */
    out[0] = t0;
    const double t1 = sqrt((3.0 / 4.0)); /* h = sqrt(3/4) */
    out[1] = t1;
    out[2] = 0.0;
    out[3] = 0.0;
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
}

static void family0_charpoly(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = 1.0;
    out[2] = 1.0;
    out[1] = 0.0;
    out[3] = 0.0;
    const double t0 = (-27.0)*params[0]; /* (-27)*mu */
    const double t1 = params[0] + (-1.0); /* mu + -1 */
    const double t2 = t0*t1; /* (-27)*mu*(mu + -1) */
    const double t3 = t2/4.0; /* (-27)*mu*(mu + -1)/4 */
    out[4] = t3;
}

static const jlt_equilibria equilibria[] = {
    { .name = "triangular", .condition = "",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .charpoly = family0_charpoly,
      .left_null_count = 0, .obstructs = 0 },
};

static void divisor_values(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0] + x[0]; /* mu + x */
    const double t1 = t0*t0; /* (mu + x)*(mu + x) */
    const double t2 = x[1]*x[1]; /* y*y */
    const double t3 = t1 + t2; /* (mu + x)*(mu + x) + y*y */
    out[0] = t3;
    const double t4 = x[0]*x[0]; /* x*x */
    const double t5 = t2 + t4; /* y*y + x*x */
    const double t6 = params[0]*params[0]; /* mu*mu */
    const double t7 = t5 + t6; /* y*y + x*x + mu*mu */
    const double t8 = t3*t7; /* ((mu + x)*(mu + x) + y*y)*(y*y + x*x + mu*mu) */
    out[1] = t8;
    const double t9 = params[0] + (-1.0); /* mu + -1 */
    const double t10 = x[0] + t9; /* x + mu + -1 */
    const double t11 = t10*t10; /* (x + mu + -1)*(x + mu + -1) */
    const double t12 = t2 + t11; /* y*y + (x + mu + -1)*(x + mu + -1) */
    out[2] = t12;
    const double t13 = 1.0 + t2; /* 1 + y*y */
    const double t14 = t4 + t13; /* x*x + 1 + y*y */
    const double t15 = t6 + t14; /* mu*mu + x*x + 1 + y*y */
    const double t16 = t12*t15; /* (y*y + (x + mu + -1)*(x + mu + -1))*(mu*mu + x*x + 1 + y*y) */
    out[3] = t16;
}

static const jlt_region divisors[] = {
    { "a division", "(mu + x)^2 + y^2 != 0", 0 },
    { "a division", "y^2 + (mu + x - 1)^2 != 0", 0 },
};

static const jlt_quantity states[] = {
    { "x", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "vx", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "vy", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "mu", "", "mass of the smaller body over the whole mass", -INFINITY, INFINITY, JLT_POSITIVE, (12277471.0 / 1000000000.0), 0.0 },
};

static const jlt_named integrals[] = {
    { "jacobi", "" },
};

static const jlt_named measures[] = {
    { "volume", "" },
};

static const signed char signs_2[] = { 1, -1, -1, 1 };
static const jlt_reversor reversors[] = {
    { signs_2, 2 },
};

const jlt_descriptor jlt_kernels_restricted_three_body_general = {
    .model = "restricted_three_body",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Planar circular restricted three-body problem",
    .source = "V. Szebehely, Theory of Orbits, Academic Press, 1967; R. F. Arenstorf, Amer. J. Math. 85 (1963) 27-35",
    .sha256 = "be92c80fa5ae653bcafd1a9f9b49cfb47d443deafac9921503338276e0a9706f",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_restricted_three_body, .family = jlt_family_restricted_three_body, .claims = jlt_claims_restricted_three_body,
    .state_count = 4, .param_count = 1, .prepared_count = 5,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 4, { 3, 8, 7, 1, 2, 0, 9, 6 }, { 16, 18, 0, 4, 2, 0, 10, 7 },
        "divides by r1: values and rounding errors grow without bound where it vanishes; divides by r2: values and rounding errors grow without bound where it vanishes; takes r1 = sqrt((mu + x)^2 + y^2): rounding errors of the states grow without bound where it vanishes; takes r2 = sqrt(y^2 + (-1 + mu + x)^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in x + -1 + mu, d(vx)/dt, a part of d(vy)/dt, d(vy)/dt" },
    .jacobian = { jacobian, 16, { 4, 15, 7, 1, 2, 0, 12, 9 }, { 30, 60, 0, 12, 2, 0, 13, 7 },
        "divides by r1: values and rounding errors grow without bound where it vanishes; divides by r2: values and rounding errors grow without bound where it vanishes; takes r1 = sqrt((mu + x)^2 + y^2): rounding errors of the states grow without bound where it vanishes; takes r2 = sqrt(y^2 + (-1 + mu + x)^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in -3 + 3*mu, x + -1 + mu, ((-1 + mu)/mu)*1/r1^2*r1*1/r1^2 - 1/r2^2*1/r2^2*r2, mu*(((-1 + mu)/mu)*1/r1^2*r1*1/r1^2 - 1/r2^2*1/r2^2*r2) + 1, d(d(vx)/dt)/d(x), a part of d(d(vx)/dt)/d(y) and of d(d(vy)/dt)/d(x), 1/r2^2*1/r2^2*r2*(3*mu)*1/r2^2 - 1/r1^2*r1*1/r1^2*(-3 + 3*mu)*1/r1^2, d(d(vy)/dt)/d(y)" },
    .rhs_jacobian = { rhs_jacobian, 20, { 4, 17, 11, 1, 2, 0, 12, 11 }, { 41, 74, 0, 16, 2, 0, 13, 7 },
        "divides by r1: values and rounding errors grow without bound where it vanishes; divides by r2: values and rounding errors grow without bound where it vanishes; takes r1 = sqrt((mu + x)^2 + y^2): rounding errors of the states grow without bound where it vanishes; takes r2 = sqrt(y^2 + (-1 + mu + x)^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in -3 + 3*mu, x + -1 + mu, (-1 + mu)*1/r1^2*1/r1^2*r1 + 1 - mu*1/r2^2*r2*1/r2^2, 1/r1^2*1/r1^2*r1*(-3 + 3*mu)*1/r1^2 - 1/r2^2*r2*1/r2^2*(3*mu)*1/r2^2, d(d(vy)/dt)/d(y), d(d(vx)/dt)/d(x), a part of d(d(vx)/dt)/d(y) and of d(d(vy)/dt)/d(x), d(vy)/dt, d(vx)/dt" },
    .divergence = { divergence, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .integral_values = { integral_values, 1, { 2, 3, 7, 1, 2, 0, 7, 5 }, { 11, 12, 0, 2, 2, 0, 8, 4 },
        "divides by r1: values and rounding errors grow without bound where it vanishes; divides by r2: values and rounding errors grow without bound where it vanishes; takes r1 = sqrt((mu + x)^2 + y^2): rounding errors of the states grow without bound where it vanishes; takes r2 = sqrt(y^2 + (-1 + mu + x)^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in x*x + y*y - vx*vx - vy*vy, x + -1 + mu, r2*((-1 + mu)/mu) - r1, jacobi" },
    .integral_gradients = { integral_gradients, 4, { 3, 3, 5, 2, 2, 0, 7, 6 }, { 14, 16, 0, 4, 2, 0, 10, 7 },
        "divides by r1: values and rounding errors grow without bound where it vanishes; divides by r2: values and rounding errors grow without bound where it vanishes; takes r1 = sqrt((mu + x)^2 + y^2): rounding errors of the states grow without bound where it vanishes; takes r2 = sqrt(y^2 + (-1 + mu + x)^2): rounding errors of the states grow without bound where it vanishes; digits are lost where terms nearly cancel in x + -1 + mu, d(jacobi)/d(x), a part of d(jacobi)/d(y), d(jacobi)/d(y)" },
    .measure_values = { measure_values, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .measure_divergences = { measure_divergences, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .divisor_count = 2, .divisors = divisors, .divisor_values = divisor_values,
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 1, .measure_count = 1, .equilibria_count = 1,
    .integrals = integrals,
    .measures = measures,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_restricted_three_body_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_restricted_three_body_general) },
#endif
};
