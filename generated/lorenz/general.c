/* Lorenz's system
 *
 *  Source:     E. N. Lorenz, Deterministic nonperiodic flow, J. Atmos. Sci. 20 (1963) 130-141
 *  Table:      lorenz, SHA-256 2bab2d4fa634a7604b4f84d1f7fa912ed0fa8a5e4b51edfb0e1f1ce7cb60d449
 *  Command:    ttc generate --effort full --out DIR lorenz.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 2    2    2    0    0    0      2    2   (10)
 *  jacobian            2    0    0    0    0    0      1    1   (4)
 *  rhs_jacobian        3    2    2    0    0    0      2    2   (14)
 *  divergence          0    0    0    0    0    0      0    0   (2)
 *
 *  Accuracy
 *    digits are lost where terms nearly cancel in d(y)/dt, d(z)/dt
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_lorenz[];
extern const jlt_claim jlt_claims_lorenz[];
extern const jlt_descriptor *const jlt_family_lorenz[];
extern const jlt_descriptor jlt_kernels_lorenz_general;
extern const struct jlt_ball_table jlt_balls_lorenz_general;
extern const jlt_kernel_batch jlt_batch_lorenz_general_baseline;
extern const jlt_kernel_batch jlt_batch_lorenz_general_avx2;
extern const jlt_kernel_batch jlt_batch_lorenz_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    const double t0 = -params[0]; /* -sigma */
    out[3] = t0;
    const double t1 = -params[2]; /* -beta */
    out[4] = t1;
    const double t2 = (-1.0) - params[0]; /* -1 - sigma */
    const double t3 = t2 - params[2]; /* -1 - sigma - beta */
    out[5] = t3;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = x[0] - x[1]; /* x - y */
    const double t1 = p[3]*t0; /* (-sigma)*(x - y) */
    out[0] = t1;
    const double t2 = p[1] - x[2]; /* rho - z */
    const double t3 = JLT_FMS(x[0], t2, x[1]); /* x*(rho - z) - y */
    out[1] = t3;
    const double t4 = x[0]*x[1]; /* x*y */
    const double t5 = JLT_FNMA(x[2], p[2], t4); /* x*y - z*beta */
    out[2] = t5;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[0] = p[3];
    out[1] = p[0];
    out[2] = 0.0;
    const double t0 = p[1] - x[2]; /* rho - z */
    out[3] = t0;
    out[4] = (-1.0);
    out[7] = x[0];
    const double t1 = -x[0]; /* -x */
    out[5] = t1;
    out[6] = x[1];
    out[8] = p[4];
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[3] = p[3];
    out[10] = x[0];
    out[9] = x[1];
    const double t0 = x[0] - x[1]; /* x - y */
    const double t1 = p[3]*t0; /* (-sigma)*(x - y) */
    out[0] = t1;
    const double t2 = p[1] - x[2]; /* rho - z */
    out[6] = t2;
    const double t3 = JLT_FMS(x[0], t2, x[1]); /* x*(rho - z) - y */
    out[1] = t3;
    const double t4 = x[0]*x[1]; /* x*y */
    const double t5 = JLT_FNMA(x[2], p[2], t4); /* x*y - z*beta */
    out[2] = t5;
    out[4] = p[0];
    out[5] = 0.0;
    out[7] = (-1.0);
    const double t6 = -x[0]; /* -x */
    out[8] = t6;
    out[11] = p[4];
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    out[0] = p[5];
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
    double t9[JLT_JET_ORDER_MAX + 1];
    double t11[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    coefficients[2] = x2[0] = x[2];
    for (unsigned k = 0; k < order; k++) {
        t3[k] = x0[k] - x1[k];
        t4[k] = p[3]*t3[k];
        t7[k] = (k == 0 ? p[1] : 0) - x2[k];
        t8[k] = jlt_jet_product(x0, t7, k) - x1[k];
        t9[k] = jlt_jet_product(x0, x1, k);
        t11[k] = t9[k] - x2[k]*p[2];
        double *restrict next = coefficients + (k + 1)*3;
        next[0] = x0[k + 1] = t4[k]/(k + 1);
        next[1] = x1[k + 1] = t8[k]/(k + 1);
        next[2] = x2[k + 1] = t11[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double v_sigma = params[0];
    const double complex v_x = x[0];
    const double complex v_y = x[1];
    out[0] = (-v_sigma*v_x)
        + (v_sigma*v_y);
    const double v_rho = params[1];
    const double complex v_z = x[2];
    out[1] = (v_rho*v_x)
        + (-v_y)
        + (-v_x*v_z);
    const double v_beta = params[2];
    out[2] = (v_x*v_y)
        + (-v_beta*v_z);
}

static const unsigned char family0_is_free[] = { 0, 0, 0 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[4] = (-1.0);
    out[1] = params[0];
    const double t0 = -params[0]; /* -sigma */
    out[0] = t0;
    out[2] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
    out[3] = params[1];
    const double t1 = -params[2]; /* -beta */
    out[8] = t1;
}

static const unsigned char family1_is_free[] = { 1, 0, 0 };

static void family1_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[2] = params[2];
    const double t0 = x[0]*x[0]; /* x*x */
    const double t1 = t0/params[2]; /* x*x/beta */
    const double t2 = 1.0 + t1; /* rho = 1 + x*x/beta */
    out[1] = t2;
}

static void family1_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[0] = x[0];
    out[1] = x[0];
    const double t0 = x[0]*x[0]; /* x*x */
    const double t1 = t0/params[2]; /* z = x*x/beta */
    out[2] = t1;
}

static void family1_trace(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    const double t0 = (-1.0) - params[0]; /* -1 - sigma */
    const double t1 = t0 - params[2]; /* -1 - sigma - beta */
    out[0] = t1;
}

static void family1_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    out[4] = (-1.0);
    out[3] = 1.0;
    out[1] = params[0];
    const double t0 = -params[0]; /* -sigma */
    out[0] = t0;
    out[2] = 0.0;
    out[6] = x[0];
    out[7] = x[0];
    const double t1 = -x[0]; /* -x */
    out[5] = t1;
    const double t2 = -params[2]; /* -beta */
    out[8] = t2;
}

static const jlt_equilibria equilibria[] = {
    { .name = "conduction", .condition = "",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .matrix = family0_matrix,
      .left_null_count = 0, .obstructs = 0 },
    { .name = "convection", .condition = "rho = 1 + x^2/beta",
      .is_free = family1_is_free,
      .impose = family1_impose,
      .point = family1_point,
      .trace = family1_trace,
      .matrix = family1_matrix,
      .left_null_count = 0, .obstructs = 1 },
};

static const jlt_quantity states[] = {
    { "x", "", "intensity of convection", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y", "", "temperature difference of rising and falling currents", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "z", "", "distortion of the vertical profile of temperature", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "sigma", "", "Prandtl number", -INFINITY, INFINITY, JLT_ANY_SIGN, 10.0, 0.0 },
    { "rho", "", "Rayleigh number over its critical value", -INFINITY, INFINITY, JLT_ANY_SIGN, 28.0, 0.0 },
    { "beta", "", "geometric factor", -INFINITY, INFINITY, JLT_NONZERO, (8.0 / 3.0), 0.0 },
};

const jlt_descriptor jlt_kernels_lorenz_general = {
    .model = "lorenz",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Lorenz's system",
    .source = "E. N. Lorenz, Deterministic nonperiodic flow, J. Atmos. Sci. 20 (1963) 130-141",
    .sha256 = "2bab2d4fa634a7604b4f84d1f7fa912ed0fa8a5e4b51edfb0e1f1ce7cb60d449",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_lorenz, .family = jlt_family_lorenz, .claims = jlt_claims_lorenz,
    .state_count = 3, .param_count = 3, .prepared_count = 6,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 3, { 2, 2, 2, 0, 0, 0, 2, 2 }, { 4, 6, 0, 0, 0, 0, 3, 3 },
        "digits are lost where terms nearly cancel in d(y)/dt, d(z)/dt" },
    .jacobian = { jacobian, 9, { 2, 0, 0, 0, 0, 0, 1, 1 }, { 4, 0, 0, 0, 0, 0, 1, 1 },
        "" },
    .rhs_jacobian = { rhs_jacobian, 12, { 3, 2, 2, 0, 0, 0, 2, 2 }, { 8, 6, 0, 0, 0, 0, 3, 3 },
        "digits are lost where terms nearly cancel in d(y)/dt, d(z)/dt" },
    .divergence = { divergence, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 2, 0, 0, 0, 0, 0, 2, 2 },
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
    .integral_count = 0, .measure_count = 0, .equilibria_count = 2,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_lorenz_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_lorenz_general) },
#endif
};
