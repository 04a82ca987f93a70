/* The methods of the batched section map have the orders they claim.
 *
 * Oracle: the plane Kepler problem, whose ellipse is known in closed form. Steps are taken in extended precision from the tables
 * themselves. A local error C h^q + O(h^(q+1)) falls by 2^q when h is halved, or faster where C is so small that the next term shows,
 * as in methods that were made for a small C; at h = 1/4 and 1/8, where the next term is otherwise a few h of the first, the measured
 * exponent is between q - 0.7 and q + 1.7. Errors are above 1e-15 there; weights rounded to double move the end by some 1e-17. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "integrate/batch_method.h"

enum { DIM = 4 };

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

/* Sizes of the error of one step, and of the estimate, from time 1. */
static void one_step(const jlt_batch_method *m, long double h, long double *error, long double *estimate)
{
    long double k[JLT_BATCH_STAGES_MAX + 1][DIM], start[DIM], end[DIM], z[DIM], guess[DIM] = { 0 };

    ellipse(1, start);
    ellipse(1 + h, end);
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
        const long double h = 0.25L;
        long double coarse, fine, coarse_estimate, fine_estimate;
        one_step(m, h, &coarse, &coarse_estimate);
        one_step(m, h / 2, &fine, &fine_estimate);
        const double order = (double)log2l(coarse / fine), estimated = (double)log2l(coarse_estimate / fine_estimate);
        print_message("%s: error h^%.2f (%.1Le), estimate h^%.2f\n", m->name, order, fine, estimated);
        assert_true(order > m->order + 0.3 && order < m->order + 2.7);
        assert_true(fabs(estimated - m->error_order) < 0.7);
    }
}

static void weights_are_consistent_and_no_stage_needs_a_later_one(void **unused)
{
    const jlt_batch_method *m;

    (void)unused;
    for (size_t i = 0; (m = jlt_batch_method_at(i)) != NULL; i++) {
        double all = 0, error = 0;
        for (unsigned l = 0; l < m->sum[m->stages - 1].count; l++) all += m->sum[m->stages - 1].weight[l];
        for (unsigned l = 0; l < m->error.count; l++) error += m->error.weight[l];
        assert_true(fabs(all - 1) < 4e-15 && fabs(error) < 4e-15);
        for (unsigned s = 0; s < m->stages; s++)
            for (unsigned l = 0; l < m->sum[s].count; l++) assert_true(m->sum[s].slope[l] <= s);
    }
}

/* A stage at node c, the sum of its weights, is of order 2 at least from the third on: sum of weight * node = c^2/2. With 12
 * weights and nodes rounded to double it holds to 16 units of 2^-53 of the largest weight. */
static void stages_are_of_order_two(void **unused)
{
    const jlt_batch_method *m;

    (void)unused;
    for (size_t i = 0; (m = jlt_batch_method_at(i)) != NULL; i++) {
        long double node[JLT_BATCH_STAGES_MAX + 1] = { 0 };
        for (unsigned s = 0; s < m->stages; s++) {
            long double moment = 0, largest = 1;
            for (unsigned l = 0; l < m->sum[s].count; l++) {
                const long double weight = m->sum[s].weight[l];
                node[s + 1] += weight;
                moment += weight * node[m->sum[s].slope[l]];
                largest = fmaxl(largest, fabsl(weight));
            }
            if (s > 0) assert_true(fabsl(moment - node[s + 1] * node[s + 1] / 2) < 16 * 0x1p-53L * largest);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(methods_have_their_orders),
        cmocka_unit_test(stages_are_of_order_two),
        cmocka_unit_test(weights_are_consistent_and_no_stage_needs_a_later_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
