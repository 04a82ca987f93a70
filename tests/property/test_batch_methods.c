/* The methods of the batched section map have the orders they claim.
 *
 * Oracle: the plane Kepler problem, whose ellipse is known in closed form. Steps are taken in extended precision from the tables
 * themselves. A local error C h^q + O(h^(q+1)) falls by 2^q when h is halved; near the apocentre, at h = 1/2 and 1/4, where the
 * next term is a few tenths of the first, the measured exponent is within 0.7 of q. Errors are above 1e-14 there; weights rounded
 * to double move the end by less than 1e-15. */
#include "unit/check.h"

#include <stdbool.h>

#include "integrate/batch.h"
#include "integrate/batch_method.h"

enum { DIM = 4, TREE_MAX = 11 };

static const long double eccentricity = 0.3L;

/* Position and velocity at time t since the pericentre, semi-major axis and attraction 1. */
static void ellipse(long double t, long double *x)
{
    const long double e = eccentricity, b = sqrtl(1 - e * e);
    long double u = t;
    for (int i = 0; i < 60; i++) u -= (u - e * sinl(u) - t) / (1 - e * cosl(u));
    const long double rate = 1 / (1 - e * cosl(u));
    x[0] = cosl(u) - e;
    x[1] = b * sinl(u);
    x[2] = -sinl(u) * rate;
    x[3] = b * cosl(u) * rate;
}

static void attraction(const long double *x, long double *f)
{
    const long double r = sqrtl(x[0] * x[0] + x[1] * x[1]), factor = -1 / (r * r * r);
    f[0] = x[2];
    f[1] = x[3];
    f[2] = factor * x[0];
    f[3] = factor * x[1];
}

static void add(const jlt_stage_sum *sum, long double k[][DIM], long double h, long double *out)
{
    for (unsigned l = 0; l < sum->count; l++)
        for (int i = 0; i < DIM; i++) out[i] += h * (long double)sum->weight[l] * k[sum->slope[l]][i];
}

/* Sizes of the error of one step, and of the estimate, from shortly before the apocentre. */
static void one_step(const jlt_batch_method *m, long double h, long double *error, long double *estimate)
{
    long double k[JLT_BATCH_STAGES_MAX + 1][DIM], start[DIM], end[DIM], z[DIM], guess[DIM] = { 0 };

    ellipse(3, start);
    ellipse(3 + h, end);
    attraction(start, k[0]);
    for (unsigned s = 0; s < m->stages; s++) {
        for (int i = 0; i < DIM; i++) z[i] = start[i];
        add(&m->sum[s], k, h, z);
        attraction(z, k[s + 1]);
    }
    *error = 0;
    for (int i = 0; i < DIM; i++) *error += (z[i] - end[i]) * (z[i] - end[i]);
    *error = sqrtl(*error);
    add(&m->error, k, h, guess);
    *estimate = 0;
    for (int i = 0; i < DIM; i++) *estimate += guess[i] * guess[i];
    *estimate = sqrtl(*estimate);
}

static void methods_have_their_orders(void **unused)
{
    const jlt_batch_method *m;

    (void)unused;
    for (size_t i = 0; (m = jlt_batch_method_at(i)) != NULL; i++) {
        const long double h = 0.5L;
        long double coarse, fine, coarse_estimate, fine_estimate;
        one_step(m, h, &coarse, &coarse_estimate);
        one_step(m, h / 2, &fine, &fine_estimate);
        const double order = (double)log2l(coarse / fine), estimated = (double)log2l(coarse_estimate / fine_estimate);
        print_message("%s: error h^%.2f (%.1Le), estimate h^%.2f\n", m->name, order, fine, estimated);
        assert_true(fabs(order - (m->order + 1)) < 0.7);
        assert_true(fabs(estimated - m->error_order) < 0.7);
    }
}

static void no_stage_needs_a_later_one(void **unused)
{
    const jlt_batch_method *m;

    (void)unused;
    for (size_t i = 0; (m = jlt_batch_method_at(i)) != NULL; i++)
        for (unsigned s = 0; s < m->stages; s++)
            for (unsigned l = 0; l < m->sum[s].count; l++) assert_true(m->sum[s].slope[l] <= s);
}

/* An elementary weight at the slopes, and the same of absolute values of all weights. */
typedef struct {
    long double value[JLT_BATCH_STAGES_MAX + 1], size[JLT_BATCH_STAGES_MAX + 1];
} elementary;

static long double weigh(const jlt_stage_sum *sum, const elementary *e, long double *size)
{
    long double value = 0;

    *size = 0;
    for (unsigned l = 0; l < sum->count; l++) {
        value += (long double)sum->weight[l] * e->value[sum->slope[l]];
        *size += fabsl((long double)sum->weight[l]) * e->size[sum->slope[l]];
    }
    return value;
}

/* Rooted trees of `order` vertices as levels in preorder, one after another (T. Beyer, S. M. Hedetniemi, SIAM J. Comput. 9 (1980),
 * 706-712). False after the last. */
static bool next_tree(unsigned *level, unsigned order)
{
    unsigned last = order, parent;

    while (last > 0 && level[last - 1] <= 1) last--;
    if (last == 0) return false;
    parent = last - 1;
    while (level[parent - 1] != level[last - 1] - 1) parent--;
    for (unsigned v = last - 1; v < order; v++) level[v] = level[v - (last - parent)];
    return true;
}

/* The elementary weight of a tree at all slopes, and its density gamma. */
static elementary elementary_weight(const jlt_batch_method *m, const unsigned *level, unsigned order, long double *density)
{
    elementary e[TREE_MAX];
    unsigned vertices[TREE_MAX];

    *density = 1;
    for (unsigned v = 0; v < order; v++) {
        vertices[v] = 1;
        for (unsigned s = 0; s <= m->stages; s++) e[v].value[s] = e[v].size[s] = 1;
    }
    for (unsigned v = order; v-- > 0;) {
        unsigned parent = v;
        *density *= vertices[v];
        if (v == 0) break;
        while (level[parent] != level[v] - 1) parent--;
        vertices[parent] += vertices[v];
        e[parent].value[0] = e[parent].size[0] = 0;
        for (unsigned s = 1; s <= m->stages; s++) {
            long double size;
            e[parent].value[s] *= weigh(&m->sum[s - 1], &e[v], &size);
            e[parent].size[s] *= size;
        }
    }
    return e[0];
}

/* How far the conditions of all trees of one order are missed, at worst, by the solution and by the estimate, in units of the bound
 * that rounding weights to double sets: 2^-53 for each of a tree's weights, and half as much for arithmetic of 64 bits. */
static void miss(const jlt_batch_method *m, unsigned order, long double *solution, long double *estimate)
{
    static const unsigned rooted_trees[TREE_MAX] = { 1, 1, 2, 4, 9, 20, 48, 115, 286, 719, 1842 };
    unsigned level[TREE_MAX], trees = 0;

    *solution = *estimate = 0;
    for (unsigned v = 0; v < order; v++) level[v] = v;
    do {
        long double density, size, unit = 0x1p-53L * (order + 0.5L);
        const elementary e = elementary_weight(m, level, order, &density);
        long double value = weigh(&m->sum[m->stages - 1], &e, &size);
        *solution = fmaxl(*solution, fabsl(value - 1 / density) / (unit * size));
        value = weigh(&m->error, &e, &size);
        if (size > 0) *estimate = fmaxl(*estimate, fabsl(value) / (unit * size));
        trees++;
    } while (next_tree(level, order));
    assert_int_equal(trees, rooted_trees[order - 1]);
}

/* J. C. Butcher's conditions, one a rooted tree: 200 to order 8, 1205 to order 10. */
static void weights_meet_the_order_conditions_and_no_more(void **unused)
{
    const jlt_batch_method *m;

    (void)unused;
    for (size_t i = 0; (m = jlt_batch_method_at(i)) != NULL; i++)
        for (unsigned order = 1; order <= m->order + 1; order++) {
            long double solution, estimate;
            miss(m, order, &solution, &estimate);
            print_message("%s, order %u: %.2Lg, %.2Lg\n", m->name, order, solution, estimate);
            assert_true(order <= m->order ? solution < 1 : solution > 1000);
            if (order <= m->error_order) assert_true(order < m->error_order ? estimate < 1 : estimate > 1000);
        }
}

/* Errors are estimated by the weights that the table has. */
static void methods_are_those_of_the_table(void **unused)
{
    (void)unused;
    const jlt_batch_method copy = *jlt_batch_method_at(0);
    const jlt_kernel_batch kernels = { .lanes = 3 };
    const jlt_batch_case of = { .level = 0 };
    jlt_batch_map map = { .kernels = &kernels, .cases = &of, .dim = 2, .root = -1, .tolerance = 1e-9, .method = &copy };

    assert_int_equal(jlt_batch_section(&map, NULL, 0, 1, NULL, NULL, NULL, NULL), JLT_ERR_ARG);
    map.method = jlt_batch_method_at(0);
    assert_int_equal(jlt_batch_section(&map, NULL, 0, 1, NULL, NULL, NULL, NULL), JLT_ERR_UNSUPPORTED);
}

/* A map in range has no code for kernels of three lanes; one out of range is refused before. */
static void maps_out_of_range_are_refused(void **unused)
{
    const jlt_kernel_batch kernels = { .lanes = 3 };
    const jlt_batch_case of = { .level = 0 };
    const jlt_domain domain = { .states = 2, .conditions = JLT_BATCH_CONDITIONS_MAX + 1 };
    const jlt_batch_map map = { .kernels = &kernels, .cases = &of, .dim = 2, .root = -1, .tolerance = 1e-9 };
    jlt_batch_map maps[8];

    (void)unused;
    for (unsigned i = 0; i < 8; i++) maps[i] = map;
    maps[0].direction = 2;
    maps[1].direction = -2;
    maps[2].root = 2;
    maps[3].turn = -1;
    maps[4].turn = NAN;
    maps[5].turn = INFINITY;
    maps[6].domain = &domain;
    maps[7].returns_of = (const size_t[]){ 1, 0 };
    for (unsigned i = 0; i < 8; i++)
        assert_int_equal(jlt_batch_section(&maps[i], NULL, 2, 1, NULL, NULL, NULL, NULL), JLT_ERR_ARG);
    assert_int_equal(jlt_batch_section(&map, NULL, 2, 0, NULL, NULL, NULL, NULL), JLT_ERR_ARG);
    assert_int_equal(jlt_batch_section(&map, NULL, 2, 1, NULL, NULL, NULL, NULL), JLT_ERR_UNSUPPORTED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(methods_have_their_orders),
        cmocka_unit_test(weights_meet_the_order_conditions_and_no_more),
        cmocka_unit_test(no_stage_needs_a_later_one),
        cmocka_unit_test(methods_are_those_of_the_table),
        cmocka_unit_test(maps_out_of_range_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
