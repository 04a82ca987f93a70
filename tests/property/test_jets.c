/* Generated Taylor recurrences of every field, against its right-hand side and its Jacobian; on lanes, against the scalar ones. */
#include "unit/check.h"

#include <stdbool.h>
#include <stdlib.h>

#include "base/random.h"
#include "kernel/batch_isa.h"
#include "registry.h"

enum { STATES_MAX = 64, PARAMS_MAX = 64, ORDER = 16, ROUNDS = 10, LANES_MAX = 8, PREPARED_MAX = 512 };

static double uniform(uint64_t *state)
{
    return (double)(ttc_random_bits(state) >> 11) * 0x1p-53;
}

static double largest(const double *a, unsigned n)
{
    double size = 0;
    for (unsigned i = 0; i < n; i++) size = fmax(size, fabs(a[i]));
    return size;
}

/* A radicand may be negative at a point taken at random. */
static bool in_domain(const jlt_descriptor *d, const double *x, const double *p)
{
    double f[STATES_MAX];

    d->rhs.call(x, p, f);
    for (unsigned i = 0; i < d->state_count; i++)
        if (!isfinite(f[i])) return false;
    return true;
}

/* c_1 = f, c_2 = J f/2 on the model's states; row and column of t left out. Rounding: some hundred operations, and no
 * sum cancels more than 1e4 of its terms at these points. */
static void check_low_orders(const jlt_descriptor *d, const double *x, const double *p, const double *jet, unsigned columns)
{
    double f[STATES_MAX], jacobian[STATES_MAX * STATES_MAX];
    const unsigned n = d->state_count;

    d->rhs.call(x, p, f);
    d->jacobian.call(x, p, jacobian);
    const double size1 = largest(f, n), size2 = size1 * largest(jacobian, n * n) * n;
    for (unsigned i = 0; i < n; i++) {
        double slope = 0;
        for (unsigned k = 0; k < n; k++) slope += jacobian[i * n + k] * f[k];
        assert_true(fabs(jet[columns + i] - f[i]) <= 3e2 * 1e4 * 0x1p-53 * size1);
        assert_true(fabs(jet[2 * columns + i] - slope / 2) <= 3e2 * 1e4 * 0x1p-53 * size2);
    }
}

/* At a step where the last coefficient contributes 1e-9 of the first, the polynomial P misses the solution by at most a few
 * times that, its slope by ORDER/h times that, and the field on it by the Jacobian times that. */
static void check_high_orders(const jlt_descriptor *d, const double *p, const double *jet, unsigned columns)
{
    const unsigned n = d->state_count;
    double last = largest(jet + ORDER * columns, n), size = fmax(1, largest(jet, n));
    double x[STATES_MAX] = { 0 }, slope[STATES_MAX] = { 0 }, f[STATES_MAX];
    double jacobian[STATES_MAX * STATES_MAX];
    double h = fmin(0.1, pow(1e-9 * size / last, 1.0 / ORDER));

    for (unsigned i = 0; i < n; i++) {
        x[i] = slope[i] = 0;
        for (unsigned k = ORDER; k >= 1; k--) {
            x[i] = x[i] * h + jet[k * columns + i];
            slope[i] = slope[i] * h + k * jet[k * columns + i];
        }
        x[i] = x[i] * h + jet[i];
    }
    d->rhs.call(x, p, f);
    d->jacobian.call(x, p, jacobian);
    const double growth = ORDER / h + n * largest(jacobian, n * n);
    for (unsigned i = 0; i < n; i++) assert_true(fabs(slope[i] - f[i]) <= 10 * 1e-9 * size * growth);
}

/* Parameters and a point; false where the field is not finite. */
static bool choose_point(const jlt_descriptor *d, double *p, double *x, uint64_t *state)
{
    double params[PARAMS_MAX], imposed[PARAMS_MAX];

    for (unsigned i = 0; i < d->param_count; i++) params[i] = 0.2 + uniform(state);
    if (d->impose != NULL) {
        d->impose(NULL, params, imposed);
        memcpy(params, imposed, d->param_count * sizeof *params);
    }
    d->prepare(params, p);
    for (unsigned i = 0; i < d->state_count; i++) {
        double low = isfinite(d->states[i].low) ? d->states[i].low : -1;
        double high = isfinite(d->states[i].high) ? d->states[i].high : 1;
        x[i] = low + (high - low) * (0.05 + 0.9 * uniform(state));
    }
    return in_domain(d, x, p);
}

static void jets_solve_their_equations(void **unused)
{
    static double jet[(ORDER + 1) * (STATES_MAX + 1)];
    uint64_t state = 7;

    (void)unused;
    for (unsigned index = 0; index < jlt_registry_count; index++) {
        const jlt_descriptor *d = jlt_registry[index];
        const unsigned columns = d->state_count + (d->time_factor.call != NULL);
        double *p = malloc((d->prepared_count + 1) * sizeof *p), x[STATES_MAX];
        assert_non_null(p);
        for (int round = 0; round < ROUNDS; round++) {
            if (!choose_point(d, p, x, &state)) continue;
            d->jet(x, p, ORDER, jet);
            check_low_orders(d, x, p, jet, columns);
            check_high_orders(d, p, jet, columns);
            if (d->time_factor.call != NULL) {
                double rate;
                d->time_factor.call(x, p, &rate);
                assert_true(fabs(jet[columns + d->state_count] - rate) <= 1e2 * 0x1p-53 * fabs(rate));
            }
        }
        free(p);
    }
}

/* No multiply-add is fused in a recurrence, so that all instruction sets do the same operations. */
static void every_lane_has_the_scalar_coefficients_bit_for_bit(void **unused)
{
    static _Alignas(64) double many[STATES_MAX * LANES_MAX], jets[(ORDER + 1) * (STATES_MAX + 1) * LANES_MAX];
    static double jet[(ORDER + 1) * (STATES_MAX + 1)];
    static _Alignas(64) double spread[PREPARED_MAX * LANES_MAX];
    uint64_t state = 8;

    (void)unused;
    for (unsigned index = 0; index < jlt_registry_count; index++) {
        const jlt_descriptor *d = jlt_registry[index];
        const unsigned entries = (ORDER + 1) * (d->state_count + (d->time_factor.call != NULL));
        double *p = malloc((d->prepared_count + 1) * sizeof *p), x[STATES_MAX];
        assert_non_null(p);
        for (int round = 0; round < ROUNDS; round++) {
            const bool inside = choose_point(d, p, x, &state);
            for (int isa = 0; isa < JLT_ISA_COUNT && inside; isa++) {
                const jlt_kernel_batch *kernels = d->batches[isa];
                if (!jlt_batch_isa_runs(kernels)) continue;
                /* The point in one lane, in the others its scaled copies under scaled parameters. */
                const unsigned lane = (unsigned)round % kernels->lanes;
                assert_true(kernels->prepared <= PREPARED_MAX);
                for (unsigned i = 0; i < kernels->prepared; i++)
                    for (unsigned j = 0; j < kernels->lanes; j++) spread[i * kernels->lanes + j] = p[i] * (j == lane ? 1 : 0.8);
                for (unsigned i = 0; i < d->state_count; i++)
                    for (unsigned j = 0; j < kernels->lanes; j++) many[i * kernels->lanes + j] = x[i] * (j == lane ? 1 : 0.9);
                d->jet(x, p, ORDER, jet);
                kernels->jet(many, spread, ORDER, jets, kernels->lanes);
                for (unsigned i = 0; i < entries; i++) assert_memory_equal(&jets[i * kernels->lanes + lane], &jet[i], sizeof *jet);
            }
        }
        free(p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(jets_solve_their_equations),
        cmocka_unit_test(every_lane_has_the_scalar_coefficients_bit_for_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
