/* Chaplygin sleigh, reduced
 *
 *  Source:     S. A. Chaplygin, On the theory of motion of nonholonomic systems. The reducing-multiplier theorem, Mat. Sb. 28 (1911) 303-314; English translation: Regul. Chaotic Dyn. 13 (2008) 369-376
 *  Variant:    balanced: a = 0
 *  Table:      chaplygin_sleigh, SHA-256 ec3ac26ab8d11f99820039e71c75f8fa4e5baadbfc9e16c62e3265d72db16166
 *  Command:    ttc generate --effort full --out DIR chaplygin_sleigh.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 0    0    0    0    0    0      0    0   (0)
 *  jacobian            0    0    0    0    0    0      0    0   (0)
 *  rhs_jacobian        0    0    0    0    0    0      0    0   (0)
 *  divergence          0    0    0    0    0    0      0    0   (0)
 *  integral_values     0    3    1    0    0    0      3    3   (7)
 *  integral_gradients  0    2    0    0    0    0      1    1   (2)
 *  measure_values      0    0    0    0    0    0      0    0   (0)
 *  measure_divergences 0    0    0    0    0    0      0    0   (0)
 *
 *  Accuracy
 *    no denominator or radicand of the field vanishes in the domain, and no terms cancel
 *    
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_chaplygin_sleigh[];
extern const jlt_claim jlt_claims_chaplygin_sleigh[];
extern const jlt_descriptor *const jlt_family_chaplygin_sleigh[];
extern const jlt_descriptor jlt_kernels_chaplygin_sleigh_balanced;
extern const struct jlt_ball_table jlt_balls_chaplygin_sleigh_general;
extern const jlt_kernel_batch jlt_batch_chaplygin_sleigh_balanced_baseline;
extern const jlt_kernel_batch jlt_batch_chaplygin_sleigh_balanced_avx2;
extern const jlt_kernel_batch jlt_batch_chaplygin_sleigh_balanced_avx512;

static void impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = 0.0;
}

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    const double t0 = params[0]/2.0; /* m/2 */
    out[3] = t0;
    const double t1 = params[1]/2.0; /* I/2 */
    out[4] = t1;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
    out[1] = 0.0;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
    out[4] = 0.0;
    out[5] = 0.0;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)x;
    (void)p;
    out[0] = 0.0;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    out[1] = x[0];
    const double t0 = p[3]*x[0]; /* 1/2*m*v */
    const double t1 = x[0]*t0; /* v*1/2*m*v */
    out[2] = x[1];
    const double t2 = p[4]*x[1]; /* 1/2*I*w */
    const double t3 = JLT_FMA(x[1], t2, t1); /* w*1/2*I*w + v*1/2*m*v */
    out[0] = t3;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[0]; /* m*v */
    out[0] = t0;
    const double t1 = p[1]*x[1]; /* I*w */
    out[1] = t1;
    out[2] = 1.0;
    out[5] = 1.0;
    out[3] = 0.0;
    out[4] = 0.0;
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
    (void)p;
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    for (unsigned k = 0; k < order; k++) {
        double *restrict next = coefficients + (k + 1)*2;
        next[0] = x0[k + 1] = (k == 0 ? 0.0 : 0)/(k + 1);
        next[1] = x1[k + 1] = (k == 0 ? 0.0 : 0)/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double v_a = (0.0);
    const double complex v_w = x[1];
    out[0] = (v_a*v_w*v_w);
    const double v_m = params[0];
    const double complex v_v = x[0];
    const double v_I = params[1];
    out[1] = (-v_m*v_a*v_v*v_w/(v_I + v_m*v_a*v_a));
}

static const unsigned char family0_is_free[] = { 1, 0 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)params;
    out[0] = x[0];
    out[1] = 0.0;
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
    out[0] = params[1];
    out[1] = 0.0;
    out[2] = 0.0;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    (void)params;
    out[0] = 0.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 0.0;
}

static void family0_left_null_gradients(const double *restrict x, const double *restrict params, double *restrict out)
{
    const double t0 = params[0]*x[0]; /* m*v */
    out[0] = t0;
    out[1] = 0.0;
}

static const jlt_named family0_left_null[] = {
    { "E", "" },
};

static const jlt_equilibria equilibria[] = {
    { .name = "straight", .condition = "",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .trace = family0_trace,
      .charpoly = family0_charpoly,
      .matrix = family0_matrix,
      .left_null = family0_left_null,
      .left_null_gradients = family0_left_null_gradients,
      .left_null_count = 1, .obstructs = 1 },
};

static const jlt_quantity states[] = {
    { "v", "m/s", "speed along the blade", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "w", "1/s", "angular velocity", -INFINITY, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "m", "kg", "mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "I", "kg m^2", "moment of inertia about the centre of mass", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "a", "m", "distance of the centre of mass from the blade", -INFINITY, INFINITY, JLT_ANY_SIGN, 1.0, 0.0 },
};

static const jlt_named integrals[] = {
    { "E", "" },
    { "speed", "a = 0" },
    { "turning", "a = 0" },
};

static const jlt_named measures[] = {
    { "uniform", "a = 0" },
};

static const signed char signs_1[] = { -1, -1 };
static const jlt_reversor reversors[] = {
    { signs_1, 1 },
};

const jlt_descriptor jlt_kernels_chaplygin_sleigh_balanced = {
    .model = "chaplygin_sleigh",
    .variant = "balanced",
    .time = "",
    .elimination = "",
    .title = "Chaplygin sleigh, reduced",
    .source = "S. A. Chaplygin, On the theory of motion of nonholonomic systems. The reducing-multiplier theorem, Mat. Sb. 28 (1911) 303-314; English translation: Regul. Chaotic Dyn. 13 (2008) 369-376",
    .sha256 = "ec3ac26ab8d11f99820039e71c75f8fa4e5baadbfc9e16c62e3265d72db16166",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_chaplygin_sleigh, .family = jlt_family_chaplygin_sleigh, .claims = jlt_claims_chaplygin_sleigh,
    .scales = 1,
    .state_count = 2, .param_count = 3, .prepared_count = 5,
    .states = states,
    .params = params,
    .impose = impose,
    .prepare = prepare,
    .rhs = { rhs, 2, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .jacobian = { jacobian, 4, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .rhs_jacobian = { rhs_jacobian, 6, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .divergence = { divergence, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0, 0, 0 },
        "" },
    .integral_values = { integral_values, 3, { 0, 3, 1, 0, 0, 0, 3, 3 }, { 1, 6, 0, 0, 0, 0, 4, 3 },
        "" },
    .integral_gradients = { integral_gradients, 6, { 0, 2, 0, 0, 0, 0, 1, 1 }, { 0, 2, 0, 0, 0, 0, 1, 1 },
        "" },
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
    .integral_count = 3, .measure_count = 1, .equilibria_count = 1,
    .integrals = integrals,
    .measures = measures,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_chaplygin_sleigh_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_chaplygin_sleigh_balanced) },
#endif
};
