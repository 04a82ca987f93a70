/* Lotka-Volterra equations
 *
 *  Source:     V. Volterra, Variazioni e fluttuazioni del numero d'individui in specie animali conviventi, Mem. Acad. Lincei Roma 2 (1926) 31-113
 *  Table:      lotka_volterra, SHA-256 74bd0797ba37376d0028cd3ec35e564e70e4bcb97d50e051e73f40b6925219f8
 *  Command:    ttc generate --effort full --out DIR lotka_volterra.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 0    2    2    0    0    0      2    2   (6)
 *  jacobian            0    2    2    0    0    0      1    1   (7)
 *  rhs_jacobian        0    4    2    0    0    0      2    2   (9)
 *  divergence          1    0    2    0    0    0      2    3   (5)
 *  integral_values     0    1    3    0    0    2      4    3   (9)
 *  integral_gradients  2    0    0    2    0    0      2    2   (4)
 *  measure_values      0    1    0    1    0    0      2    2   (2)
 *  measure_divergences 0    0    0    0    0    0      0    0   (13)
 *
 *  Accuracy
 *    digits are lost where terms nearly cancel in d(d(x)/dt)/d(x), d(d(y)/dt)/d(y)
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_lotka_volterra[];
extern const jlt_claim jlt_claims_lotka_volterra[];
extern const jlt_descriptor *const jlt_family_lotka_volterra[];
extern const jlt_descriptor jlt_kernels_lotka_volterra_general;
extern const struct jlt_ball_table jlt_balls_lotka_volterra_general;
extern const jlt_kernel_batch jlt_batch_lotka_volterra_general_baseline;
extern const jlt_kernel_batch jlt_batch_lotka_volterra_general_avx2;
extern const jlt_kernel_batch jlt_batch_lotka_volterra_general_avx512;

static void prepare(const double *restrict params, double *restrict out)
{
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
    const double t0 = -params[1]; /* -b */
    out[4] = t0;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FNMA(p[1], x[1], p[0]); /* g = a - b*y */
    const double t1 = x[0]*t0; /* x*g */
    out[0] = t1;
    const double t2 = JLT_FMS(x[0], p[3], p[2]); /* h = x*d - c */
    const double t3 = x[1]*t2; /* y*h */
    out[1] = t3;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FNMA(p[1], x[1], p[0]); /* g = a - b*y */
    out[0] = t0;
    const double t1 = p[4]*x[0]; /* (-b)*x */
    out[1] = t1;
    const double t2 = x[1]*p[3]; /* y*d */
    out[2] = t2;
    const double t3 = JLT_FMS(x[0], p[3], p[2]); /* h = x*d - c */
    out[3] = t3;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FNMA(p[1], x[1], p[0]); /* g = a - b*y */
    out[2] = t0;
    const double t1 = x[0]*t0; /* x*g */
    out[0] = t1;
    const double t2 = JLT_FMS(x[0], p[3], p[2]); /* h = x*d - c */
    out[5] = t2;
    const double t3 = x[1]*t2; /* y*h */
    out[1] = t3;
    const double t4 = x[0]*p[4]; /* x*(-b) */
    out[3] = t4;
    const double t5 = x[1]*p[3]; /* y*d */
    out[4] = t5;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FNMA(p[1], x[1], p[0]); /* g = a - b*y */
    const double t1 = JLT_FMS(p[3], x[0], p[2]); /* h = d*x - c */
    const double t2 = t0 + t1; /* g + h */
    out[0] = t2;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[1]*x[1]; /* b*y */
    const double t1 = JLT_FMA(p[3], x[0], t0); /* d*x + b*y */
    const double t2 = log(x[0]); /* u = log(x) */
    const double t3 = JLT_FNMA(p[2], t2, t1); /* d*x + b*y - c*u */
    const double t4 = log(x[1]); /* v = log(y) */
    const double t5 = JLT_FNMA(p[0], t4, t3); /* d*x + b*y - c*u - a*v */
    out[0] = t5;
}

static void integral_gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[2]/x[0]; /* c/x */
    const double t1 = p[3] - t0; /* d - c/x */
    out[0] = t1;
    const double t2 = p[0]/x[1]; /* a/y */
    const double t3 = p[1] - t2; /* b - a/y */
    out[1] = t3;
}

static void measure_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    (void)p;
    const double t0 = x[0]*x[1]; /* x*y */
    const double t1 = 1.0/t0; /* 1/(x*y) */
    out[0] = t1;
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
    double t4[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t9[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    for (unsigned k = 0; k < order; k++) {
        t4[k] = (k == 0 ? p[0] : 0) - p[1]*x1[k];
        t5[k] = jlt_jet_product(x0, t4, k);
        t8[k] = x0[k]*p[3] - (k == 0 ? p[2] : 0);
        t9[k] = jlt_jet_product(x1, t8, k);
        double *restrict next = coefficients + (k + 1)*2;
        next[0] = x0[k + 1] = t5[k]/(k + 1);
        next[1] = x1[k + 1] = t9[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double complex v_x = x[0];
    const double v_a = params[0];
    const double v_b = params[1];
    const double complex v_y = x[1];
    const double complex v_g = (v_a - v_b*v_y);
    out[0] = (v_x*v_g);
    const double v_c = params[2];
    const double v_d = params[3];
    const double complex v_h = (-v_c + v_d*v_x);
    out[1] = (v_y*v_h);
}

static const unsigned char family0_is_free[] = { 0, 0 };

static void family0_impose(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = params[0];
    out[1] = params[1];
    out[2] = params[2];
    out[3] = params[3];
}

static void family0_point(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    const double t0 = params[2]/params[3]; /* x = c/d */
    out[0] = t0;
    const double t1 = params[0]/params[1]; /* y = a/b */
    out[1] = t1;
}

static void family0_charpoly(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = 1.0;
    out[1] = 0.0;
    const double t0 = params[0]*params[2]; /* a*c */
    out[2] = t0;
}

static void family0_matrix(const double *restrict x, const double *restrict params, double *restrict out)
{
    (void)x;
    out[0] = 0.0;
    out[3] = 0.0;
    const double t0 = params[1]*params[2]; /* b*c */
    const double t1 = t0/params[3]; /* b*c/d */
    const double t2 = -t1; /* -b*c/d */
    out[1] = t2;
    const double t3 = params[3]*params[0]; /* d*a */
    const double t4 = t3/params[1]; /* d*a/b */
    out[2] = t4;
}

static const jlt_equilibria equilibria[] = {
    { .name = "coexistence", .condition = "",
      .is_free = family0_is_free,
      .impose = family0_impose,
      .point = family0_point,
      .charpoly = family0_charpoly,
      .matrix = family0_matrix,
      .left_null_count = 0, .obstructs = 0 },
};

static const jlt_quantity states[] = {
    { "x", "", "prey", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
    { "y", "", "predators", 0.0, INFINITY, JLT_ANY_SIGN, NAN, 0.0 },
};

static const jlt_quantity params[] = {
    { "a", "", "growth of the prey", -INFINITY, INFINITY, JLT_POSITIVE, (2.0 / 3.0), 0.0 },
    { "b", "", "prey lost to each predator", -INFINITY, INFINITY, JLT_POSITIVE, (4.0 / 3.0), 0.0 },
    { "c", "", "death of predators", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
    { "d", "", "predators gained by each prey", -INFINITY, INFINITY, JLT_POSITIVE, 1.0, 0.0 },
};

static const jlt_named integrals[] = {
    { "H", "" },
};

static const jlt_named measures[] = {
    { "rho", "" },
};

const jlt_descriptor jlt_kernels_lotka_volterra_general = {
    .model = "lotka_volterra",
    .variant = "",
    .time = "",
    .elimination = "",
    .title = "Lotka-Volterra equations",
    .source = "V. Volterra, Variazioni e fluttuazioni del numero d'individui in specie animali conviventi, Mem. Acad. Lincei Roma 2 (1926) 31-113",
    .sha256 = "74bd0797ba37376d0028cd3ec35e564e70e4bcb97d50e051e73f40b6925219f8",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_lotka_volterra, .family = jlt_family_lotka_volterra, .claims = jlt_claims_lotka_volterra,
    .state_count = 2, .param_count = 4, .prepared_count = 5,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 2, { 0, 2, 2, 0, 0, 0, 2, 2 }, { 2, 4, 0, 0, 0, 0, 3, 2 },
        "digits are lost where terms nearly cancel in g = a - b*y, h = x*d - c" },
    .jacobian = { jacobian, 4, { 0, 2, 2, 0, 0, 0, 1, 1 }, { 3, 4, 0, 0, 0, 0, 2, 2 },
        "digits are lost where terms nearly cancel in d(d(x)/dt)/d(x), d(d(y)/dt)/d(y)" },
    .rhs_jacobian = { rhs_jacobian, 6, { 0, 4, 2, 0, 0, 0, 2, 2 }, { 3, 6, 0, 0, 0, 0, 3, 2 },
        "digits are lost where terms nearly cancel in d(d(x)/dt)/d(x), d(d(y)/dt)/d(y)" },
    .divergence = { divergence, 1, { 1, 0, 2, 0, 0, 0, 2, 3 }, { 3, 2, 0, 0, 0, 0, 3, 3 },
        "digits are lost where terms nearly cancel in g = a - b*y, h = d*x - c, the divergence" },
    .integral_values = { integral_values, 1, { 0, 1, 3, 0, 0, 2, 4, 3 }, { 3, 4, 0, 0, 0, 2, 4, 3 },
        "digits are lost where terms nearly cancel in H" },
    .integral_gradients = { integral_gradients, 2, { 2, 0, 0, 2, 0, 0, 2, 2 }, { 2, 0, 0, 2, 0, 0, 2, 2 },
        "divides by x: values and rounding errors grow without bound where it vanishes; divides by y: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in d(H)/d(x), d(H)/d(y)" },
    .measure_values = { measure_values, 1, { 0, 1, 0, 1, 0, 0, 2, 2 }, { 0, 1, 0, 1, 0, 0, 2, 2 },
        "divides by x: values and rounding errors grow without bound where it vanishes; divides by y: values and rounding errors grow without bound where it vanishes" },
    .measure_divergences = { measure_divergences, 1, { 0, 0, 0, 0, 0, 0, 0, 0 }, { 5, 5, 0, 3, 0, 0, 6, 5 },
        "" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .observe_values = { .loses_digits = "" },
    .valid_values = { .loses_digits = "" },
    .domain_values = { .loses_digits = "" },
    .domain_gradients = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 1, .equilibria_count = 1,
    .integrals = integrals,
    .measures = measures,
    .equilibria = equilibria,
#ifndef JLT_WITHOUT_BALLS
    .balls = &jlt_balls_lotka_volterra_general,
#endif
    .jet = jet,
    .rhs_complex = rhs_complex,
#ifndef JLT_WITHOUT_LANES
    .batches = { JLT_BATCHES(jlt_batch_lotka_volterra_general) },
#endif
};
