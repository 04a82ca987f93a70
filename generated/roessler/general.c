/* Roessler's system
 *
 *  Source:     O. E. Roessler, An equation for continuous chaos, Phys. Lett. A 57 (1976) 397-398
 *  Table:      roessler, SHA-256 7d2f97bb2c6d3f82c3ce5d0578ec3d5df1852a1298f7e68780337a2d6518941e
 *  Command:    ttc generate --effort full --out DIR roessler.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 3    0    2    0    0    0      2    2   (8)
 *  jacobian            1    0    0    0    0    0      1    1   (1)
 *  rhs_jacobian        4    0    2    0    0    0      2    2   (9)
 *  divergence          1    0    0    0    0    0      1    1   (2)
 *
 *  Accuracy
 *    digits are lost where terms nearly cancel in d(y)/dt, d(z)/dt
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_roessler[];
extern const jlt_claim jlt_claims_roessler[];
extern const jlt_descriptor *const jlt_family_roessler[];
extern const jlt_descriptor jlt_kernels_roessler_general;
extern const struct jlt_ball_table jlt_balls_roessler_general;
extern const jlt_kernel_batch jlt_batch_roessler_general_baseline;
extern const jlt_kernel_batch jlt_batch_roessler_general_avx2;
extern const jlt_kernel_batch jlt_batch_roessler_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    const double t0 = params[0] - params[2]; /* a - c */
    out[3] = t0;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[1] + x[2]; /* y + z */
    const double t1 = -t0; /* -(y + z) */
    out[0] = t1;
    const double t2 = JLT_FMA(x[1], p[0], x[0]); /* y*a + x */
    out[1] = t2;
    const double t3 = p[2] - x[0]; /* c - x */
    const double t4 = JLT_FNMA(x[2], t3, p[1]); /* b - z*(c - x) */
    out[2] = t4;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = 0.0;
    out[5] = 0.0;
    out[7] = 0.0;
    out[3] = 1.0;
    out[1] = (-1.0);
    out[2] = (-1.0);
    out[4] = p[0];
    out[6] = x[2];
    const double t0 = x[0] - p[2]; /* x - c */
    out[8] = t0;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[9] = x[2];
    const double t0 = x[1] + x[2]; /* y + z */
    const double t1 = -t0; /* -(y + z) */
    out[0] = t1;
    out[7] = p[0];
    const double t2 = JLT_FMA(x[1], p[0], x[0]); /* y*a + x */
    out[1] = t2;
    const double t3 = p[2] - x[0]; /* c - x */
    const double t4 = JLT_FNMA(x[2], t3, p[1]); /* b - z*(c - x) */
    out[2] = t4;
    out[3] = 0.0;
    out[8] = 0.0;
    out[10] = 0.0;
    out[6] = 1.0;
    out[4] = (-1.0);
    out[5] = (-1.0);
    const double t5 = x[0] - p[2]; /* x - c */
    out[11] = t5;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3] + x[0]; /* a - c + x */
    out[0] = t0;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double x2[JLT_JET_ORDER_MAX + 1];
    double t2[JLT_JET_ORDER_MAX + 1];
    double t3[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    for (unsigned k = 0; k < order; k++) {
        t2[k] = x1[k] + x2[k];
        t3[k] = -t2[k];
        t6[k] = x1[k]*p[0] + x0[k];
        t9[k] = (k == 0 ? p[2] : 0) - x0[k];
        t10[k] = (k == 0 ? p[1] : 0) - jlt_jet_product(x2, t9, k);
        double *restrict next = coefficients + (k + 1)*3;
        next[0] = x0[k + 1] = t3[k]/(k + 1);
        next[1] = x1[k + 1] = t6[k]/(k + 1);
        next[2] = x2[k + 1] = t10[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_y = x[1];
    const double complex v_z = x[2];
    out[0] = (-v_y)
        + (-v_z);
    const double complex v_x = x[0];
    const double v_a = params[0];
    out[1] = (v_x)
        + (v_a*v_y);
    const double v_b = params[1];
    const double v_c = params[2];
    out[2] = (v_b)
        + (v_x*v_z)
        + (-v_c*v_z);
}

static const unsigned char family0_is_free[] = { 1, 0, 0 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[2] = params[2];
    const double t0 = params[2] - x[0]; /* c - x */
    const double t1 = x[0]*t0; /* x*(c - x) */
    const double t2 = t1/params[0]; /* b = x*(c - x)/a */
    out[1] = t2;
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    const double t0 = x[0]/params[0]; /* z = x/a */
    out[2] = t0;
    const double t1 = -t0; /* y = -z */
    out[1] = t1;
}

static void family0_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0] - params[2]; /* a - c */
    const double t1 = t0 + x[0]; /* a - c + x */
    out[0] = t1;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = 0.0;
    out[5] = 0.0;
    out[7] = 0.0;
    out[1] = (-1.0);
    out[2] = (-1.0);
    out[3] = 1.0;
    out[4] = params[0];
    const double t0 = x[0]/params[0]; /* x/a */
    out[6] = t0;
    const double t1 = x[0] - params[2]; /* x - c */
    out[8] = t1;
}

static const jlt_equilibria equilibria[] = {
    { .name = "foci", .condition = "b = x*(c - x)/a",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .matrix = family0_matrix,
      .left_null_count = 0, .obstructs = 0 },
};

static const jlt_quantity states[] = {
    { "x", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "z", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "a", "", "", -INFINITY, INFINITY, JLT_NONZERO, (1.0 / 5.0), 0.0 },
    { "b", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, (1.0 / 5.0), 0.0 },
    { "c", "", "", -INFINITY, INFINITY, JLT_ANY_SIGN, (57.0 / 10.0), 0.0 },
};

const jlt_descriptor jlt_kernels_roessler_general = {
    .model = "roessler",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Roessler's system",
    .source = "O. E. Roessler, An equation for continuous chaos, Phys. Lett. A 57 (1976) 397-398",
    .sha256 = "7d2f97bb2c6d3f82c3ce5d0578ec3d5df1852a1298f7e68780337a2d6518941e",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_roessler, .family = jlt_family_roessler, .claims = jlt_claims_roessler,
    .state_count = 3, .param_count = 3, .prepared_count = 4,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 3, { 3, 0, 2, 0, 0, 0, 2, 2 }, { 5, 3, 0, 0, 0, 0, 3, 3 },
        "digits are lost where terms nearly cancel in d(y)/dt, d(z)/dt" },
    .jacobian = { jacobian, 9, { 1, 0, 0, 0, 0, 0, 1, 1 }, { 1, 0, 0, 0, 0, 0, 1, 1 },
        "" },
    .rhs_jacobian = { rhs_jacobian, 12, { 4, 0, 2, 0, 0, 0, 2, 2 }, { 6, 3, 0, 0, 0, 0, 3, 3 },
        "digits are lost where terms nearly cancel in d(y)/dt, d(z)/dt" },
    .divergence = { divergence, 1, { 1, 0, 0, 0, 0, 0, 1, 1 }, { 2, 0, 0, 0, 0, 0, 2, 2 },
        "digits are lost where terms nearly cancel in the divergence" },
    .integral_values = { .loses_digits = "" },
    .integral_gradients = { .loses_digits = "" },
    .measure_values = { .loses_digits = "" },
    .measure_divergences = { .loses_digits = "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .integral_count = 0, .measure_count = 0, .equilibria_count = 1,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_roessler_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_roessler_general) },
#endif
};
