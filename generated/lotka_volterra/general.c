/* Lotka-Volterra equations
 *
 *  Source:     V. Volterra, Variazioni e fluttuazioni del numero d'individui in specie animali conviventi, Mem. Acad. Lincei Roma 2 (1926) 31-113
 *  Table:      lotka_volterra, SHA-256 1439e966c000a70de17afc97b982f97d90de01742555fdfb815a616ed4b93851
 *  Command:    ttc generate --effort full --out DIR lotka_volterra.tt (ttc 0.1.0); do not edit
 *
 *  Operations        add  mul  fma  div sqrt elem  depth live   (as the terms stand: flops)
 *  rhs                 0    3    2    0    0    0      2    3   (8)
 *  jacobian            0    2    2    0    0    0      1    1   (7)
 *  rhs_jacobian        0    4    3    0    0    0      2    3   (15)
 *  divergence          0    0    2    0    0    0      2    2   (5)
 *  integral_values     0    1    3    0    0    2      4    3   (9)
 *  integral_gradients  2    0    0    2    0    0      2    2   (4)
 *  measure_values      0    1    0    1    0    0      2    2   (2)
 *  measure_divergences 0    6    6    1    0    0      7    4   (23)
 *
 *  Accuracy
 *    digits are lost where terms nearly cancel in d(d(x)/dt)/d(x), d(y)/dt, d(d(y)/dt)/d(y)
 */
#include "kernel_abi.h"
#include "kernel_arithmetic.h"
#include "kernel_jet.h"

#include <math.h>

extern const char jlt_table_lotka_volterra[];
extern const jlt_descriptor jlt_kernels_lotka_volterra_general;
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
    const double t1 = params[0] - params[2]; /* a - c */
    out[5] = t1;
    const double t2 = params[1]/params[3]; /* b/d */
    out[6] = t2;
}

static void rhs(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[0]*x[0]; /* a*x */
    const double t1 = x[0]*x[1]; /* x*y */
    const double t2 = JLT_FNMA(p[1], t1, t0); /* a*x - b*x*y */
    out[0] = t2;
    const double t3 = x[1]*p[2]; /* y*c */
    const double t4 = JLT_FMS(t1, p[3], t3); /* x*y*d - y*c */
    out[1] = t4;
}

static void jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FNMA(p[1], x[1], p[0]); /* a - b*y */
    out[0] = t0;
    const double t1 = p[4]*x[0]; /* (-b)*x */
    out[1] = t1;
    const double t2 = x[1]*p[3]; /* y*d */
    out[2] = t2;
    const double t3 = JLT_FMS(x[0], p[3], p[2]); /* x*d - c */
    out[3] = t3;
}

static void rhs_jacobian(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FNMA(p[1], x[1], p[0]); /* a - b*y */
    out[2] = t0;
    const double t1 = x[0]*t0; /* x*(a - b*y) */
    out[0] = t1;
    const double t2 = x[1]*p[2]; /* y*c */
    const double t3 = x[1]*p[3]; /* y*d */
    out[4] = t3;
    const double t4 = JLT_FMS(x[0], t3, t2); /* x*y*d - y*c */
    out[1] = t4;
    const double t5 = x[0]*p[4]; /* x*(-b) */
    out[3] = t5;
    const double t6 = JLT_FMS(x[0], p[3], p[2]); /* x*d - c */
    out[5] = t6;
}

static void divergence(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = JLT_FMA(p[3], x[0], p[5]); /* d*x + a - c */
    const double t1 = JLT_FNMA(p[1], x[1], t0); /* d*x + a - c - b*y */
    out[0] = t1;
}

static void integral_values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const double t0 = p[3]*x[0]; /* d*x */
    const double t1 = JLT_FMA(p[1], x[1], t0); /* b*y + d*x */
    const double t2 = log(x[0]); /* u = log(x) */
    const double t3 = JLT_FNMA(p[2], t2, t1); /* b*y + d*x - c*u */
    const double t4 = log(x[1]); /* v = log(y) */
    const double t5 = JLT_FNMA(p[0], t4, t3); /* b*y + d*x - c*u - a*v */
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
    const double t0 = x[0]*x[1]; /* x*y */
    const double t1 = x[1]*p[2]; /* y*c */
    const double t2 = JLT_FNMA(p[3], t0, t1); /* y*c - d*x*y */
    const double t3 = x[0]*t2; /* x*(y*c - d*x*y) */
    const double t4 = x[0]*p[0]; /* x*a */
    const double t5 = JLT_FNMA(p[1], t0, t4); /* x*a - b*x*y */
    const double t6 = JLT_FNMA(x[1], t5, t3); /* x*(y*c - d*x*y) - y*(x*a - b*x*y) */
    const double t7 = 1.0/t0; /* 1/(x*y) */
    const double t8 = JLT_FMA(t6, t7, p[5]); /* (x*(y*c - d*x*y) - y*(x*a - b*x*y))*1/(x*y) + a - c */
    const double t9 = t7*t8; /* 1/(x*y)*((x*(y*c - d*x*y) - y*(x*a - b*x*y))*1/(x*y) + a - c) */
    const double t10 = JLT_FNMA(x[1], p[6], x[0]); /* x - y*b/d */
    const double t11 = p[3]*t10; /* d*(x - y*b/d) */
    const double t12 = JLT_FMA(t7, t11, t9); /* 1/(x*y)*d*(x - y*b/d) + t9 */
    out[0] = t12;
}

static void jet(const double *restrict x, const double *restrict p, unsigned order,
                double *restrict coefficients)
{
    double x0[JLT_JET_ORDER_MAX + 1];
    double x1[JLT_JET_ORDER_MAX + 1];
    double t2[JLT_JET_ORDER_MAX + 1];
    double t5[JLT_JET_ORDER_MAX + 1];
    double t6[JLT_JET_ORDER_MAX + 1];
    double t8[JLT_JET_ORDER_MAX + 1];
    double t10[JLT_JET_ORDER_MAX + 1];
    coefficients[0] = x0[0] = x[0];
    coefficients[1] = x1[0] = x[1];
    for (unsigned k = 0; k < order; k++) {
        t2[k] = p[0]*x0[k];
        t5[k] = jlt_jet_product(x0, x1, k);
        t6[k] = t2[k] - p[1]*t5[k];
        t8[k] = x1[k]*p[2];
        t10[k] = t5[k]*p[3] - t8[k];
        double *restrict next = coefficients + (k + 1)*2;
        next[0] = x0[k + 1] = t6[k]/(k + 1);
        next[1] = x1[k + 1] = t10[k]/(k + 1);
    }
}

static void rhs_complex(const double complex *restrict x, const double *restrict params,
                        double complex *restrict out)
{
    const double v_a = params[0];
    const double complex v_x = x[0];
    const double v_b = params[1];
    const double complex v_y = x[1];
    out[0] = (v_a*v_x)
        + (-v_b*v_x*v_y);
    const double v_c = params[2];
    const double v_d = params[3];
    out[1] = (-v_c*v_y)
        + (v_d*v_x*v_y);
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
    { "x", "", "prey", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
    { "y", "", "predators", 0.0, INFINITY, JLT_ANY_SIGN, NAN },
};

static const jlt_quantity params[] = {
    { "a", "", "growth of the prey", -INFINITY, INFINITY, JLT_POSITIVE, (2.0 / 3.0) },
    { "b", "", "prey lost to each predator", -INFINITY, INFINITY, JLT_POSITIVE, (4.0 / 3.0) },
    { "c", "", "death of predators", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
    { "d", "", "predators gained by each prey", -INFINITY, INFINITY, JLT_POSITIVE, 1.0 },
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
    .sha256 = "1439e966c000a70de17afc97b982f97d90de01742555fdfb815a616ed4b93851",
    .generator = "ttc 0.1.0 --effort full",
    .table = jlt_table_lotka_volterra,
    .state_count = 2, .param_count = 4, .block_count = 7,
    .states = states,
    .params = params,
    .prepare = prepare,
    .rhs = { rhs, 2, { 0, 3, 2, 0, 0, 0, 2, 3 }, { 2, 6, 0, 0, 0, 0, 3, 3 },
        "digits are lost where terms nearly cancel in d(x)/dt, d(y)/dt" },
    .jacobian = { jacobian, 4, { 0, 2, 2, 0, 0, 0, 1, 1 }, { 3, 4, 0, 0, 0, 0, 2, 2 },
        "digits are lost where terms nearly cancel in d(d(x)/dt)/d(x), d(d(y)/dt)/d(y)" },
    .rhs_jacobian = { rhs_jacobian, 6, { 0, 4, 3, 0, 0, 0, 2, 3 }, { 5, 10, 0, 0, 0, 0, 3, 3 },
        "digits are lost where terms nearly cancel in d(d(x)/dt)/d(x), d(y)/dt, d(d(y)/dt)/d(y)" },
    .divergence = { divergence, 1, { 0, 0, 2, 0, 0, 0, 2, 2 }, { 3, 2, 0, 0, 0, 0, 3, 3 },
        "digits are lost where terms nearly cancel in the divergence" },
    .integral_values = { integral_values, 1, { 0, 1, 3, 0, 0, 2, 4, 3 }, { 3, 4, 0, 0, 0, 2, 5, 3 },
        "digits are lost where terms nearly cancel in H" },
    .integral_gradients = { integral_gradients, 2, { 2, 0, 0, 2, 0, 0, 2, 2 }, { 2, 0, 0, 2, 0, 0, 2, 2 },
        "divides by x: values and rounding errors grow without bound where it vanishes; divides by y: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in d(H)/d(x), d(H)/d(y)" },
    .measure_values = { measure_values, 1, { 0, 1, 0, 1, 0, 0, 2, 2 }, { 0, 1, 0, 1, 0, 0, 2, 2 },
        "divides by x: values and rounding errors grow without bound where it vanishes; divides by y: values and rounding errors grow without bound where it vanishes" },
    .measure_divergences = { measure_divergences, 1, { 0, 6, 6, 1, 0, 0, 7, 4 }, { 7, 13, 0, 3, 0, 0, 6, 5 },
        "divides by x: values and rounding errors grow without bound where it vanishes; divides by y: values and rounding errors grow without bound where it vanishes; digits are lost where terms nearly cancel in y*c - d*x*y, x*a - b*x*y, x*(y*c - d*x*y) - y*(x*a - b*x*y), (x*(y*c - d*x*y) - y*(x*a - b*x*y))*((1)/x*y) + a - c, x - y*(b/d), div(rho f)" },
    .time_factor = { .loses_digits = "" },
    .eliminated = { .loses_digits = "" },
    .integral_count = 1, .measure_count = 1, .equilibria_count = 1,
    .integrals = integrals,
    .measures = measures,
    .equilibria = equilibria,
    .jet = jet,
    .rhs_complex = rhs_complex,
    .batches = {
        &jlt_batch_lotka_volterra_general_baseline,
        &jlt_batch_lotka_volterra_general_avx2,
        &jlt_batch_lotka_volterra_general_avx512,
    },
};
