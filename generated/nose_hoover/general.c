/* Nose-Hoover oscillator
 *
 *  Source:     W. G. Hoover, Canonical dynamics: equilibrium phase-space distributions, Phys. Rev. A 31 (1985) 1695-1697
 *  Table:      nose_hoover, SHA-256 0e94aea4c9b2928c9741d0c1ca85c73ce0d4c8f4262b18320c66e53d04de6370
 *  Command:    ttc generate --effort full --out DIR nose_hoover.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 1    1    2    0    0    0      2    2   (6)
 *  jacobian            2    1    0    0    0    0      1    1   (4)
 *  rhs_jacobian        3    2    2    0    0    0      2    2   (10)
 *  divergence          1    0    0    0    0    0      1    1   (1)
 *  measure_values      0    4    2    0    0    1      6    3   (20)
 *  measure_divergences 0    0    0    0    0    0      0    0   (50)
 *
 *  Accuracy
 *    digits are lost where terms nearly cancel in p*z + q, T - p*p
 *    one division serves all denominators: their product may leave the range of double precision where none of
 *    them does, which raises the overflow or underflow exception, or gives an infinity or NaN
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_nose_hoover[];
extern const jlt_claim jlt_claims_nose_hoover[];
extern const jlt_descriptor *const jlt_family_nose_hoover[];
extern const jlt_descriptor jlt_kernels_nose_hoover_general;
extern const struct jlt_ball_table jlt_balls_nose_hoover_general;
extern const jlt_kernel_batch jlt_batch_nose_hoover_general_baseline;
extern const jlt_kernel_batch jlt_batch_nose_hoover_general_avx2;
extern const jlt_kernel_batch jlt_batch_nose_hoover_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    const double t0 = (-1.0)/params[1]; /* (-1)/Q */
    out[2] = t0;
    const double t1 = 2.0/params[1]; /* 2/Q */
    out[3] = t1;
    const double t2 = 2.0*params[0]; /* 2*T */
    const double t3 = t2*0x1.921fb54442d18p+1; /* 2*T*pi */
    const double t4 = sqrt(t3); /* n = sqrt(2*T*pi) */
    const double t5 = t4*t4; /* n*n */
    const double t6 = t4*t5; /* n*n*n */
    const double t7 = sqrt(params[1]); /* m = sqrt(Q) */
    const double t8 = t7/t6; /* m/(n*n*n) */
    out[4] = t8;
    const double t9 = (-1.0)/t2; /* (-1)/(2*T) */
    out[5] = t9;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = x[1];
    const double t0 = JLT_FMA(x[1], x[2], x[0]); /* p*z + q */
    const double t1 = -t0; /* -(p*z + q) */
    out[1] = t1;
    const double t2 = JLT_FNMA(x[1], x[1], p[0]); /* T - p*p */
    const double t3 = p[2]*t2; /* (-1/Q)*(T - p*p) */
    out[2] = t3;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[2] = 0.0;
    out[6] = 0.0;
    out[8] = 0.0;
    out[1] = 1.0;
    out[3] = (-1.0);
    const double t0 = -x[2]; /* -z */
    out[4] = t0;
    const double t1 = -x[1]; /* -p */
    out[5] = t1;
    const double t2 = x[1]*p[3]; /* p*2/Q */
    out[7] = t2;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = x[1];
    const double t0 = JLT_FMA(x[1], x[2], x[0]); /* p*z + q */
    const double t1 = -t0; /* -(p*z + q) */
    out[1] = t1;
    const double t2 = JLT_FNMA(x[1], x[1], p[0]); /* T - p*p */
    const double t3 = p[2]*t2; /* (-1/Q)*(T - p*p) */
    out[2] = t3;
    out[3] = 0.0;
    out[5] = 0.0;
    out[9] = 0.0;
    out[11] = 0.0;
    out[4] = 1.0;
    out[6] = (-1.0);
    const double t4 = -x[2]; /* -z */
    out[7] = t4;
    const double t5 = -x[1]; /* -p */
    out[8] = t5;
    const double t6 = x[1]*p[3]; /* p*2/Q */
    out[10] = t6;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    const double t0 = -x[2]; /* -z */
    out[0] = t0;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0]*x[0]; /* q*q */
    const double t1 = p[1]*x[2]; /* Q*z */
    const double t2 = JLT_FMA(x[1], x[1], t0); /* p*p + q*q */
    const double t3 = JLT_FMA(x[2], t1, t2); /* H/(1/2) = z*Q*z + p*p + q*q */
    const double t4 = p[5]*t3; /* (-1/2/T)*H/(1/2) */
    const double t5 = exp(t4); /* w = exp((-1/2/T)*H/(1/2)) */
    const double t6 = p[4]*t5; /* m/n^3*w */
    out[0] = t6;
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
    double t3[JLT_JET_ORDER_MAX + 1];
    double t4[JLT_JET_ORDER_MAX + 1];
    double t7[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = jlt_jet_product(x1, x2, k) + x0[k];
        t4[k] = -t3[k];
        t7[k] = (k == 0 ? p[0] : 0) - jlt_jet_product(x1, x1, k);
        t8[k] = p[2]*t7[k];
        double *restrict next = coefficients + (k + 1)*3;
        next[0] = x0[k + 1] = x1[k]/(k + 1);
        next[1] = x1[k + 1] = t4[k]/(k + 1);
        next[2] = x2[k + 1] = t8[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_p = x[1];
    out[0] = (v_p);
    const double complex v_q = x[0];
    const double complex v_z = x[2];
    out[1] = (-v_q)
        + (-v_p*v_z);
    const double v_Q = params[1];
    const double v_T = params[0];
    out[2] = (-(v_T - v_p*v_p)/v_Q);
}

static const jlt_quantity states[] = {
    { "q", "", "position", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "p", "", "momentum", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "z", "", "friction", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "T", "", "temperature", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "Q", "", "inertia of the thermostat", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
};

static const jlt_named measures[] = {
    { "canonical", "" },
};

static const signed char signs_3[] = { 1, -1, -1 };
static const jlt_reversor reversors[] = {
    { signs_3, 3 },
};

const jlt_descriptor jlt_kernels_nose_hoover_general = {
    .model = "nose_hoover",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Nose-Hoover oscillator",
    .source = "W. G. Hoover, Canonical dynamics: equilibrium phase-space distributions, Phys. Rev. A 31 (1985) 1695-1697",
    .sha256 = "0e94aea4c9b2928c9741d0c1ca85c73ce0d4c8f4262b18320c66e53d04de6370",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_nose_hoover, .family = jlt_family_nose_hoover, .claims = jlt_claims_nose_hoover,
    .state_count = 3, .param_count = 2, .prepared_count = 6,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 3, { 1, 1, 2, 0, 0, 0, 2, 2 }, { 3, 2, 0, 1, 0, 0, 3, 3 },
        "digits are lost where terms nearly cancel in p*z + q, T - p*p" },
    .jacobian = { jacobian, 9, { 2, 1, 0, 0, 0, 0, 1, 1 }, { 2, 1, 0, 1, 0, 0, 2, 2 },
        "" },
    .rhs_jacobian = { rhs_jacobian, 12, { 3, 2, 2, 0, 0, 0, 2, 2 }, { 5, 3, 0, 2, 0, 0, 3, 3 },
        "digits are lost where terms nearly cancel in p*z + q, T - p*p" },
    .divergence = { divergence, 1, { 1, 0, 0, 0, 0, 0, 1, 1 }, { 1, 0, 0, 0, 0, 0, 1, 1 },
        "" },
    .integral_values = { .loses_digits = "" },
    .integral_gradients = { .loses_digits = "" },
    .measure_values = { measure_values, 1, { 0, 4, 2, 0, 0, 1, 6, 3 }, { 3, 12, 0, 2, 2, 1, 9, 5 },
        "takes exp((-1/2/T)*H/(1/2)) of a rounded argument: digits are lost near its zeros, or where an exponent is large" },
    .measure_divergences = { measure_divergences, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 9, 33, 0, 5, 2, 1, 13, 8 },
        "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .reversor_count = 1, .reversors = reversors,
    .integral_count = 0, .measure_count = 1, .equilibria_count = 0,
    .measures = measures,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_nose_hoover_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_nose_hoover_general) },
#endif
};
