/* Rounding errors of all generated kernels, against their ball-arithmetic forms in 256 bits, over the whole domain and at
 * its edges.
 *
 * Bound: the ball form evaluated in 53 bits has a radius that contains every rounding of the expression as it is written,
 * amplified as the expression amplifies it; the optimizer rearranges and shares, which may cost a few times that. Where a
 * kernel loses digits, near zeros of roots and denominators, the radius grows with the loss, and the worst error printed says
 * how large it is. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <math.h>

#include "kernel_ball.h"
#include "registry.h"

enum { INPUTS_MAX = 64, OUTPUTS_MAX = 512, ROUNDS = 60, PRECISION = 256 };

static const double rearranged = 8; /* as many times the running error of the expression as written */

typedef struct {
    double worst; /* in units of 2^-53 of the output's own size */
    double of_bound;
} accuracy;

/* xorshift64*, Vigna 2016. */
static double uniform(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (double)((*state * UINT64_C(2685821657736338717)) >> 11) * 0x1p-53;
}

/* A state: anywhere in its interval, or within 1e-1 to 1e-12 of one of its ends; of any size where it is unbounded. */
static double sample_state(const jlt_quantity *q, uint64_t *state)
{
    const bool bounded = isfinite(q->low) && isfinite(q->high);
    const double edge = pow(10, -1 - 11 * uniform(state)), where = uniform(state);

    if (!bounded && isfinite(q->low)) return q->low + (where < 0.5 ? edge : uniform(state)); /* a lifted root */
    if (!bounded) return (where < 0.1 ? 0 : 4 * uniform(state) - 2);
    if (where < 0.25) return q->low + (q->high - q->low) * edge;
    if (where < 0.5) return q->high - (q->high - q->low) * edge;
    return q->low + (q->high - q->low) * uniform(state);
}

static double sample_param(const jlt_quantity *q, uint64_t *state)
{
    const double size = pow(10, 2 * uniform(state) - 1);

    if (q->sign == JLT_POSITIVE || q->sign == JLT_NONNEGATIVE) return size;
    return uniform(state) < 0.5 ? size : -size;
}

static void compare(accuracy *out, const jlt_kernel *kernel, jlt_ball_function ball, const double *x, const double *p,
                    arb_srcptr xb, arb_srcptr pb)
{
    double computed[OUTPUTS_MAX];
    arb_ptr exact = _arb_vec_init(kernel->outputs), rounded = _arb_vec_init(kernel->outputs);
    arf_t distance;

    arf_init(distance);
    kernel->call(x, p, computed);
    ball(exact, xb, pb, PRECISION);
    ball(rounded, xb, pb, 53);
    /* A point where one output is not finite, a root at zero, is no point of the domain. */
    bool inside = true;
    for (unsigned i = 0; i < kernel->outputs; i++) inside &= arb_is_finite(exact + i) && arb_is_finite(rounded + i);
    for (unsigned i = 0; inside && i < kernel->outputs; i++) {
        const double value = arf_get_d(arb_midref(exact + i), ARF_RND_NEAR), radius = mag_get_d(arb_radref(rounded + i));
        arf_set_d(distance, computed[i]);
        arf_sub(distance, distance, arb_midref(exact + i), 53, ARF_RND_NEAR);
        const double error = fabs(arf_get_d(distance, ARF_RND_NEAR)), bound = rearranged * radius + 0x1p-52 * fabs(value);
        if (error > 0 && error / bound > out->of_bound) out->of_bound = error / bound;
        if (value != 0) out->worst = fmax(out->worst, error / (0x1p-53 * fabs(value)));
        if (!(error <= bound)) print_message("output %u: %.17g, exactly %.17g, bound %.2g\n", i, computed[i], value, bound);
        assert_true(error <= bound);
    }
    arf_clear(distance);
    _arb_vec_clear(exact, kernel->outputs);
    _arb_vec_clear(rounded, kernel->outputs);
}

/* Integrals stand in the ball table whatever their condition; the kernels of the general field have them all only when none
 * has a condition. */
static bool same_integrals(const jlt_descriptor *d, const jlt_ball_table *b)
{
    if (d->integral_count != b->integral_count) return false;
    for (unsigned i = 0; i < d->integral_count; i++)
        if (strcmp(d->integrals[i].name, b->integral[i]) != 0) return false;
    return true;
}

static void check_descriptor(const jlt_descriptor *d, const jlt_ball_table *b, uint64_t *state)
{
    const struct {
        const char *name;
        const jlt_kernel *kernel;
        jlt_ball_function ball;
    } pairs[] = { { "rhs", &d->rhs, b->rhs },
                  { "jacobian", &d->jacobian, b->jacobian },
                  { "divergence", &d->divergence, b->divergence },
                  { "integrals", &d->integral_values, same_integrals(d, b) ? b->integral_values : NULL },
                  { "gradients", &d->integral_gradients, same_integrals(d, b) ? b->integral_gradients : NULL } };
    enum { PAIRS = sizeof pairs / sizeof *pairs };
    accuracy found[PAIRS] = { { 0, 0 } };
    double params[INPUTS_MAX], imposed[INPUTS_MAX], x[INPUTS_MAX], *p = malloc((d->block_count + 1) * sizeof *p);
    arb_ptr xb = _arb_vec_init(d->state_count), pb = _arb_vec_init(d->param_count);

    assert_non_null(p);
    for (int round = 0; round < ROUNDS; round++) {
        for (unsigned i = 0; i < d->param_count; i++) params[i] = sample_param(&d->params[i], state);
        if (d->impose != NULL) {
            d->impose(NULL, params, imposed);
            memcpy(params, imposed, d->param_count * sizeof *params);
        }
        d->prepare(params, p);
        for (unsigned i = 0; i < d->state_count; i++) arb_set_d(xb + i, x[i] = sample_state(&d->states[i], state));
        for (unsigned i = 0; i < d->param_count; i++) arb_set_d(pb + i, params[i]);
        for (unsigned k = 0; k < PAIRS; k++)
            if (pairs[k].kernel->call != NULL && pairs[k].ball != NULL)
                compare(&found[k], pairs[k].kernel, pairs[k].ball, x, p, xb, pb);
    }
    print_message("%s %s %s %s:", d->model, *d->variant ? d->variant : "-", *d->time ? d->time : "-",
                  *d->elimination ? d->elimination : "-");
    for (unsigned k = 0; k < PAIRS; k++)
        if (pairs[k].kernel->call != NULL && pairs[k].ball != NULL)
            print_message(" %s %.3g ulp (%.2g of bound)", pairs[k].name, found[k].worst, found[k].of_bound);
    print_message("\n");
    _arb_vec_clear(xb, d->state_count);
    _arb_vec_clear(pb, d->param_count);
    free(p);
}

static void errors_stay_within_the_conditioning_of_the_expressions(void **unused)
{
    uint64_t state = 53;

    (void)unused;
    for (unsigned i = 0; i < jlt_registry_count; i++)
        for (unsigned j = 0; j < jlt_ball_registry_count; j++) {
            const jlt_descriptor *d = jlt_registry[i];
            const jlt_ball_table *b = jlt_ball_registry[j];
            if (strcmp(d->model, b->model) == 0 && strcmp(d->time, b->time) == 0 && strcmp(d->elimination, b->elimination) == 0)
                check_descriptor(d, b, &state);
        }
    flint_cleanup();
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(errors_stay_within_the_conditioning_of_the_expressions) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
