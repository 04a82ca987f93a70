/* Periodic Toda lattice of three particles
 *
 *  Source:     M. Henon, Integrals of the Toda lattice, Phys. Rev. B 9 (1974) 1921-1923
 *  Table:      toda, SHA-256 79463385d67ae1dc70b05259d1ce33196f59471c740553d39ca06f4200dd41de
 *  Command:    ttc generate --effort full --out DIR toda.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 4    2    2    0    0    3      4    4   (15)
 *  jacobian            9    3    0    0    0    3      5    4   (24)
 *  rhs_jacobian        12    3    0    0    0    3      5    5   (33)
 *  divergence          0    0    0    0    0    0      0    0   (0)
 *  integral_values     7    5    6    0    0    3      6    6   (29)
 *  integral_gradients  9   12    3    0    0    3      5    7   (36)
 *  measure_values      0    0    0    0    0    0      0    0   (0)
 *  measure_divergences 0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    digits are lost where terms nearly cancel in d(p1)/dt, d(p2)/dt, d(p3)/dt
 *    takes exp(q1 - q2), exp(q3 - q1), exp(q2 - q3) of a rounded argument: digits are lost near its zeros,
 *      or where an exponent is large
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_toda[];
extern const jlt_claim jlt_claims_toda[];
extern const jlt_descriptor *const jlt_family_toda[];
extern const jlt_descriptor jlt_kernels_toda_general;
extern const struct jlt_ball_table jlt_balls_toda_general;
extern const jlt_kernel_batch jlt_batch_toda_general_baseline;
extern const jlt_kernel_batch jlt_batch_toda_general_avx2;
extern const jlt_kernel_batch jlt_batch_toda_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    const double t0 = -params[0]; /* -k */
    out[1] = t0;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = x[3];
    out[1] = x[4];
    out[2] = x[5];
    const double t0 = x[0] - x[1]; /* q1 - q2 */
    const double t1 = exp(t0); /* s1 = exp(q1 - q2) */
    const double t2 = x[2] - x[0]; /* q3 - q1 */
    const double t3 = exp(t2); /* s3 = exp(q3 - q1) */
    const double t4 = t1 - t3; /* s1 - s3 */
    const double t5 = p[1]*t4; /* (-k)*(s1 - s3) */
    out[3] = t5;
    const double t6 = x[1] - x[2]; /* q2 - q3 */
    const double t7 = exp(t6); /* s2 = exp(q2 - q3) */
    const double t8 = p[0]*t7; /* k*s2 */
    const double t9 = JLT_FMS(t1, p[0], t8); /* s1*k - k*s2 */
    out[4] = t9;
    const double t10 = JLT_FNMA(t3, p[0], t8); /* k*s2 - s3*k */
    out[5] = t10;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[9] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[16] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[23] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[3] = 1.0;
    out[10] = 1.0;
    out[17] = 1.0;
    const double t0 = x[0] - x[1]; /* q1 - q2 */
    const double t1 = exp(t0); /* s1 = exp(q1 - q2) */
    const double t2 = p[0]*t1; /* k*s1 */
    out[19] = t2;
    out[24] = t2;
    const double t3 = x[2] - x[0]; /* q3 - q1 */
    const double t4 = exp(t3); /* s3 = exp(q3 - q1) */
    const double t5 = p[0]*t4; /* k*s3 */
    out[20] = t5;
    out[30] = t5;
    const double t6 = t2 + t5; /* k*s1 + k*s3 */
    const double t7 = -t6; /* -(k*s1 + k*s3) */
    out[18] = t7;
    const double t8 = x[1] - x[2]; /* q2 - q3 */
    const double t9 = exp(t8); /* s2 = exp(q2 - q3) */
    const double t10 = p[0]*t9; /* k*s2 */
    out[26] = t10;
    out[31] = t10;
    const double t11 = t2 + t10; /* k*s1 + k*s2 */
    const double t12 = -t11; /* -(k*s1 + k*s2) */
    out[25] = t12;
    const double t13 = t5 + t10; /* k*s3 + k*s2 */
    const double t14 = -t13; /* -(k*s3 + k*s2) */
    out[32] = t14;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = x[3];
    out[1] = x[4];
    out[2] = x[5];
    const double t0 = x[0] - x[1]; /* q1 - q2 */
    const double t1 = exp(t0); /* s1 = exp(q1 - q2) */
    const double t2 = p[0]*t1; /* k*s1 */
    out[25] = t2;
    out[30] = t2;
    const double t3 = x[2] - x[0]; /* q3 - q1 */
    const double t4 = exp(t3); /* s3 = exp(q3 - q1) */
    const double t5 = p[0]*t4; /* k*s3 */
    out[26] = t5;
    out[36] = t5;
    const double t6 = t5 - t2; /* k*s3 - k*s1 */
    out[3] = t6;
    const double t7 = x[1] - x[2]; /* q2 - q3 */
    const double t8 = exp(t7); /* s2 = exp(q2 - q3) */
    const double t9 = p[0]*t8; /* k*s2 */
    out[32] = t9;
    out[37] = t9;
    const double t10 = t2 - t9; /* k*s1 - k*s2 */
    out[4] = t10;
    const double t11 = t9 - t5; /* k*s2 - k*s3 */
    out[5] = t11;
    out[6] = 0.0;
    out[7] = 0.0;
    out[8] = 0.0;
    out[10] = 0.0;
    out[11] = 0.0;
    out[12] = 0.0;
    out[13] = 0.0;
    out[14] = 0.0;
    out[15] = 0.0;
    out[17] = 0.0;
    out[18] = 0.0;
    out[19] = 0.0;
    out[20] = 0.0;
    out[21] = 0.0;
    out[22] = 0.0;
    out[27] = 0.0;
    out[28] = 0.0;
    out[29] = 0.0;
    out[33] = 0.0;
    out[34] = 0.0;
    out[35] = 0.0;
    out[39] = 0.0;
    out[40] = 0.0;
    out[41] = 0.0;
    out[9] = 1.0;
    out[16] = 1.0;
    out[23] = 1.0;
    const double t12 = t2 + t5; /* k*s1 + k*s3 */
    const double t13 = -t12; /* -(k*s1 + k*s3) */
    out[24] = t13;
    const double t14 = t2 + t9; /* k*s1 + k*s2 */
    const double t15 = -t14; /* -(k*s1 + k*s2) */
    out[31] = t15;
    const double t16 = t5 + t9; /* k*s3 + k*s2 */
    const double t17 = -t16; /* -(k*s3 + k*s2) */
    out[38] = t17;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[3] + x[4]; /* p1 + p2 */
    const double t1 = x[5] + t0; /* p3 + p1 + p2 */
    out[0] = t1;
    const double t2 = x[4]*x[4]; /* p2*p2 */
    const double t3 = JLT_FMA(x[3], x[3], t2); /* p1*p1 + p2*p2 */
    const double t4 = JLT_FMA(x[5], x[5], t3); /* p3*p3 + p1*p1 + p2*p2 */
    const double t5 = (1.0 / 2.0)*t4; /* 1/2*(p3*p3 + p1*p1 + p2*p2) */
    const double t6 = x[0] - x[1]; /* q1 - q2 */
    const double t7 = exp(t6); /* s1 = exp(q1 - q2) */
    const double t8 = x[1] - x[2]; /* q2 - q3 */
    const double t9 = exp(t8); /* s2 = exp(q2 - q3) */
    const double t10 = x[2] - x[0]; /* q3 - q1 */
    const double t11 = exp(t10); /* s3 = exp(q3 - q1) */
    const double t12 = t7 + t9; /* s1 + s2 */
    const double t13 = t11 + t12; /* s3 + s1 + s2 */
    const double t14 = JLT_FMA(p[0], t13, t5); /* k*(s3 + s1 + s2) + 1/2*(p3*p3 + p1*p1 + p2*p2) */
    out[1] = t14;
    const double t15 = x[3]*x[4]; /* p1*p2 */
    const double t16 = x[5]*t15; /* p3*p1*p2 */
    const double t17 = x[3]*t9; /* p1*s2 */
    const double t18 = JLT_FMA(x[4], t11, t17); /* p2*s3 + p1*s2 */
    const double t19 = JLT_FMA(x[5], t7, t18); /* p3*s1 + p2*s3 + p1*s2 */
    const double t20 = JLT_FNMA(p[0], t19, t16); /* p3*p1*p2 - k*(p3*s1 + p2*s3 + p1*s2) */
    out[2] = t20;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 1.0;
    out[4] = 1.0;
    out[5] = 1.0;
    const double t0 = x[0] - x[1]; /* q1 - q2 */
    const double t1 = exp(t0); /* s1 = exp(q1 - q2) */
    const double t2 = x[2] - x[0]; /* q3 - q1 */
    const double t3 = exp(t2); /* s3 = exp(q3 - q1) */
    const double t4 = t1 - t3; /* s1 - s3 */
    const double t5 = p[0]*t4; /* k*(s1 - s3) */
    out[6] = t5;
    const double t6 = x[1] - x[2]; /* q2 - q3 */
    const double t7 = exp(t6); /* s2 = exp(q2 - q3) */
    const double t8 = t1 - t7; /* s1 - s2 */
    const double t9 = p[1]*t8; /* (-k)*(s1 - s2) */
    out[7] = t9;
    const double t10 = t7 - t3; /* s2 - s3 */
    const double t11 = p[1]*t10; /* (-k)*(s2 - s3) */
    out[8] = t11;
    out[9] = x[3];
    out[10] = x[4];
    out[11] = x[5];
    const double t12 = t3*x[4]; /* s3*p2 */
    const double t13 = t1*x[5]; /* s1*p3 */
    const double t14 = t12 - t13; /* s3*p2 - s1*p3 */
    const double t15 = p[0]*t14; /* k*(s3*p2 - s1*p3) */
    out[12] = t15;
    const double t16 = t7*x[3]; /* s2*p1 */
    const double t17 = t16 - t13; /* s2*p1 - s1*p3 */
    const double t18 = p[1]*t17; /* (-k)*(s2*p1 - s1*p3) */
    out[13] = t18;
    const double t19 = t16 - t12; /* s2*p1 - s3*p2 */
    const double t20 = p[0]*t19; /* k*(s2*p1 - s3*p2) */
    out[14] = t20;
    const double t21 = p[0]*t7; /* k*s2 */
    const double t22 = JLT_FMS(x[4], x[5], t21); /* p2*p3 - k*s2 */
    out[15] = t22;
    const double t23 = p[0]*t3; /* k*s3 */
    const double t24 = JLT_FMS(x[3], x[5], t23); /* p1*p3 - k*s3 */
    out[16] = t24;
    const double t25 = p[0]*t1; /* k*s1 */
    const double t26 = JLT_FMS(x[3], x[4], t25); /* p1*p2 - k*s1 */
    out[17] = t26;
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
    double x4[JLT_JET_ORDER_MAX + 1];
    double x5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    double t12[JLT_JET_ORDER_MAX + 1];
    double t14[JLT_JET_ORDER_MAX + 1];
    double t15[JLT_JET_ORDER_MAX + 1];
    double t16[JLT_JET_ORDER_MAX + 1];
    double t17[JLT_JET_ORDER_MAX + 1];
    double t18[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    coefficients[3] = x3[0] = x[3];
    coefficients[4] = x4[0] = x[4];
    coefficients[5] = x5[0] = x[5];
    for (unsigned k = 0; k < order; k++) {
        t6[k] = x0[k] - x1[k];
        t7[k] = jlt_jet_exp(t6, t7, k);
        t9[k] = x2[k] - x0[k];
        t10[k] = jlt_jet_exp(t9, t10, k);
        t11[k] = t7[k] - t10[k];
        t12[k] = p[1]*t11[k];
        t14[k] = x1[k] - x2[k];
        t15[k] = jlt_jet_exp(t14, t15, k);
        t16[k] = p[0]*t15[k];
        t17[k] = t7[k]*p[0] - t16[k];
        t18[k] = t16[k] - t10[k]*p[0];
        double *restrict next = coefficients + (k + 1)*6;
        next[0] = x0[k + 1] = x3[k]/(k + 1);
        next[1] = x1[k + 1] = x4[k]/(k + 1);
        next[2] = x2[k + 1] = x5[k]/(k + 1);
        next[3] = x3[k + 1] = t12[k]/(k + 1);
        next[4] = x4[k + 1] = t17[k]/(k + 1);
        next[5] = x5[k + 1] = t18[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_p1 = x[3];
    out[0] = (v_p1);
    const double complex v_p2 = x[4];
    out[1] = (v_p2);
    const double complex v_p3 = x[5];
    out[2] = (v_p3);
    const double v_k = params[0];
    const double complex v_q1 = x[0];
    const double complex v_q2 = x[1];
    const double complex v_s1 = cexp(v_q1 - v_q2);
    const double complex v_q3 = x[2];
    const double complex v_s3 = cexp(-v_q1 + v_q3);
    out[3] = (-v_k*v_s1)
        + (v_k*v_s3);
    const double complex v_s2 = cexp(v_q2 - v_q3);
    out[4] = (-v_k*v_s2)
        + (v_k*v_s1);
    out[5] = (-v_k*v_s3)
        + (v_k*v_s2);
}

static const jlt_quantity states[] = {
    { "q1", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "q2", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "q3", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "p1", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "p2", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "p3", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "k", "", "stiffness of the springs", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
};

static const jlt_named integrals[] = {
    { "P", "" },
    { "H", "" },
    { "J", "" },
};

static const jlt_named measures[] = {
    { "volume", "" },
};

static const signed char signs_5[] = { 1, 1, 1, -1, -1, -1 };
static const jlt_reversor reversors[] = {
    { signs_5, 5 },
};

const jlt_descriptor jlt_kernels_toda_general = {
    .model = "toda",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Periodic Toda lattice of three particles",
    .source = "M. Henon, Integrals of the Toda lattice, Phys. Rev. B 9 (1974) 1921-1923",
    .sha256 = "79463385d67ae1dc70b05259d1ce33196f59471c740553d39ca06f4200dd41de",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_toda, .family = jlt_family_toda, .claims = jlt_claims_toda,
    .state_count = 6, .param_count = 1, .prepared_count = 2,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 6, { 4, 2, 2, 0, 0, 3, 4, 4 }, { 6, 6, 0, 0, 0, 3, 4, 5 },
        "digits are lost where terms nearly cancel in s1 - s3, d(p2)/dt, d(p3)/dt; takes exp(q1 - q2), exp(q3 - q1), exp(q2 - q3) of a rounded argument: digits are lost near its zeros, or where an exponent is large" },
    .jacobian = { jacobian, 36, { 9, 3, 0, 0, 0, 3, 5, 4 }, { 9, 12, 0, 0, 0, 3, 5, 5 },
        "takes exp(q1 - q2), exp(q3 - q1), exp(q2 - q3) of a rounded argument: digits are lost near its zeros, or where an exponent is large" },
    .rhs_jacobian = { rhs_jacobian, 42, { 12, 3, 0, 0, 0, 3, 5, 5 }, { 12, 18, 0, 0, 0, 3, 5, 6 },
        "digits are lost where terms nearly cancel in d(p1)/dt, d(p2)/dt, d(p3)/dt; takes exp(q1 - q2), exp(q3 - q1), exp(q2 - q3) of a rounded argument: digits are lost near its zeros, or where an exponent is large" },
    .divergence = { divergence, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .integral_values = { integral_values, 3, { 7, 5, 6, 0, 0, 3, 6, 6 }, { 13, 13, 0, 0, 0, 3, 7, 6 },
        "digits are lost where terms nearly cancel in P, p3*s1 + p2*s3 + p1*s2, J; takes exp(q1 - q2), exp(q2 - q3), exp(q3 - q1) of a rounded argument: digits are lost near its zeros, or where an exponent is large" },
    .integral_gradients = { integral_gradients, 18, { 9, 12, 3, 0, 0, 3, 5, 7 }, { 15, 18, 0, 0, 0, 3, 6, 6 },
        "digits are lost where terms nearly cancel in s1 - s3, s1 - s2, s2 - s3, s3*p2 - s1*p3, s2*p1 - s1*p3, s2*p1 - s3*p2, d(J)/d(p1), d(J)/d(p2), d(J)/d(p3); takes exp(q1 - q2), exp(q3 - q1), exp(q2 - q3) of a rounded argument: digits are lost near its zeros, or where an exponent is large" },
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
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 3, .measure_count = 1, .equilibria_count = 0,
    .integrals = integrals,
    .measures = measures,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_toda_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_toda_general) },
#endif
};
