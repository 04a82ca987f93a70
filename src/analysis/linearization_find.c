/* Newton's method from a guess to a nearby equilibrium within the domain, with given states held. */
#include "analysis/linearization.h"
#include "core/random.h"
#include "ext/eigen.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { SIZE = JLT_LINEARIZATION_SIZE_MAX, NEWTON_STEPS = 60, HALVINGS = 30, STARTS = 24 };

/* Relative to the largest state: below this, a state may be an exact zero. */
static const double snapped = 1e-8;
static const double ordinary = 64; /* sizes that differ by no more than this factor count as 1 */

typedef struct {
    const jlt_descriptor *descriptor;
    const double *params;
    const unsigned char *fixed; /* shape (states,) */
    double *x;
    double size[SIZE]; /* units of states and their rates, so that no state is small because of its unit */
    jlt_linearization at; /* x */
} search;

static bool bounded(const jlt_quantity *state)
{
    return isfinite(state->low) && isfinite(state->high);
}

/* A smooth measure of the distance to the ends of bounded states: 1 in the middle of the domain, 0 at its ends. Newton's method is
 * applied to f/room, which does not vanish where f vanishes only because an end is reached, so that the iteration stays inside. */
static double room(const jlt_descriptor *d, const double *x)
{
    double product = 1.0;

    for (unsigned j = 0; j < d->state_count; j++)
        if (bounded(&d->states[j])) {
            const double half = (d->states[j].high - d->states[j].low) / 2;
            product *= (x[j] - d->states[j].low) / half * ((d->states[j].high - x[j]) / half);
        }
    return product;
}

static double merit(const search *s, const double *f, const double *x)
{
    double sum = 0.0;

    for (unsigned i = 0; i < s->descriptor->state_count; i++) sum = hypot(sum, f[i] / s->size[i]);
    return sum == 0.0 ? 0.0 : sum / room(s->descriptor, x);
}

/* Evaluate at x, and find the sizes there. */
static jlt_status measure(search *s)
{
    double low = INFINITY, high = 0.0;

    JLT_PASS(jlt_linearization_residual(&s->at, s->descriptor, s->params, s->x));
    JLT_PASS(jlt_eigen_balance(s->size, s->at.jacobian, s->at.n));
    for (size_t j = 0; j < s->at.n; j++) low = fmin(low, s->size[j]), high = fmax(high, s->size[j]);
    for (size_t j = 0; high <= ordinary * low && j < s->at.n; j++) s->size[j] = 1.0;
    return JLT_OK;
}

/* One Newton step for f/room, halved until |f|/room decreases; singular values not above cutoff * largest count as 0.
 * *settled: it is zero, or cannot be decreased. */
static jlt_status advance(search *s, bool *settled, double cutoff)
{
    const size_t n = s->at.n;
    double a[SIZE * SIZE], right[SIZE], step[SIZE], trial[SIZE];
    size_t moving = 0, columns[SIZE];
    const double before = merit(s, s->at.f, s->x);
    jlt_linearization next;

    for (size_t j = 0; j < n; j++)
        if (!s->fixed[j]) columns[moving++] = j;
    for (size_t k = 0; k < moving; k++) {
        const size_t j = columns[k];
        const jlt_quantity *state = &s->descriptor->states[j];
        const double rate = bounded(state) ? 1 / (s->x[j] - state->low) - 1 / (state->high - s->x[j]) : 0.0;
        for (size_t i = 0; i < n; i++)
            a[i * moving + k] = (s->at.jacobian[i * n + j] - s->at.f[i] * rate) / s->size[i] * s->size[j];
    }
    for (size_t i = 0; i < n; i++) right[i] = s->at.f[i] / s->size[i];
    *settled = moving == 0 || before == 0.0;
    if (*settled) return JLT_OK;
    JLT_PASS(jlt_eigen_least_squares(step, a, right, n, moving, cutoff));
    for (int halving = 0; halving < HALVINGS; halving++) {
        memcpy(trial, s->x, n * sizeof *trial);
        for (size_t j = 0; j < moving; j++) trial[columns[j]] -= ldexp(step[j] * s->size[columns[j]], -halving);
        const jlt_status st = jlt_linearization_residual(&next, s->descriptor, s->params, trial);
        if (st == JLT_ERR_NOMEM) return st;
        if (st == JLT_OK && merit(s, next.f, trial) < before) {
            s->at = next;
            memcpy(s->x, trial, n * sizeof *trial);
            return JLT_OK;
        }
    }
    *settled = true;
    return JLT_OK;
}

static bool is_found(const search *s) { return s->at.residual_ratio <= JLT_LINEARIZATION_TOLERANCE; }

/* Newton steps until they settle: first without directions along which the field changes by 1e-10 of its fastest change or less,
 * since these lie along a family of equilibria and are rounding; then, if none is found yet, also with those down to 1e-14, for
 * stiff motions. */
static jlt_status iterate(search *s)
{
    static const double cutoffs[] = { 1e-10, 1e-14 };

    for (unsigned k = 0; k < 2 && !(k > 0 && is_found(s)); k++) {
        bool settled = false;
        for (int i = 0; i < NEWTON_STEPS && !settled; i++) JLT_PASS(advance(s, &settled, cutoffs[k]));
    }
    return JLT_OK;
}

static double largest_of(const search *s)
{
    double largest = 0.0;

    for (size_t j = 0; j < s->descriptor->state_count; j++) largest = fmax(largest, fabs(s->x[j]) / s->size[j]);
    return largest;
}

/* Set all free states at rounding level to exact zeros, if the result is as good an equilibrium. A component of the field that is
 * proportional to such states is never small relative to its terms, so its residual ratio stays large. All are set at once, since
 * setting one alone may not help. */
static void snap(search *s)
{
    const double largest = largest_of(s);
    double trial[SIZE];
    jlt_linearization next;

    for (size_t j = 0; j < s->at.n; j++)
        trial[j] = !s->fixed[j] && fabs(s->x[j]) <= snapped * largest * s->size[j] ? 0.0 : s->x[j];
    if (jlt_linearization_residual(&next, s->descriptor, s->params, trial) != JLT_OK ||
        next.residual_ratio > s->at.residual_ratio)
        return;
    s->at = next;
    memcpy(s->x, trial, s->at.n * sizeof *trial);
}

/* Move to the origin if it is an equilibrium, and Newton's method has reduced the largest state to a thousandth: near it every
 * term vanishes with the states, and the residual is never small relative to its terms. */
static void snap_to_origin(search *s, double began)
{
    double trial[SIZE];
    jlt_linearization next;

    if (largest_of(s) > 1e-3 * began) return;
    for (size_t j = 0; j < s->at.n; j++) trial[j] = s->fixed[j] ? s->x[j] : 0.0;
    if (jlt_linearization_residual(&next, s->descriptor, s->params, trial) != JLT_OK || next.residual > 0.0) return;
    s->at = next;
    memcpy(s->x, trial, s->at.n * sizeof *trial);
}

static jlt_status newton(search *s)
{
    JLT_PASS(measure(s));
    const double began = largest_of(s);
    JLT_PASS(iterate(s));
    if (!is_found(s)) {
        snap(s);
        JLT_PASS(iterate(s));
    }
    if (!is_found(s)) snap_to_origin(s, began);
    return is_found(s) ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
}

/* Starting point number k: the guess itself for k = 0, then random points farther and farther from it, so that a zero state of the
 * guess does not stay zero merely by symmetry. */
static void scatter(double *x, const search *s, const double *guess, jlt_random *random, int k)
{
    const double width = k / (double)STARTS;

    for (unsigned j = 0; j < s->descriptor->state_count; j++) {
        const jlt_quantity *state = &s->descriptor->states[j];
        const double unit = jlt_random_between(random, -1.0, 1.0);
        x[j] = guess[j];
        if (s->fixed[j]) continue;
        if (bounded(state)) x[j] += width * unit * (unit < 0 ? x[j] - state->low : state->high - x[j]);
        else x[j] += 2 * width * unit * fmax(1.0, fabs(x[j]));
    }
}

jlt_status jlt_linearization_find(double *x, const jlt_descriptor *descriptor, const double *params, const size_t *order,
                                  size_t held)
{
    jlt_status st = JLT_ERR_NO_CONVERGENCE;
    jlt_random random;

    if (descriptor == NULL) return JLT_ERR_ARG;
    if (descriptor->state_count > SIZE) return JLT_ERR_UNSUPPORTED;
    jlt_random_seed(&random, 1);
    for (size_t keep = held + 1; keep-- > 0;) {
        unsigned char fixed[SIZE] = { 0 };
        double trial[SIZE];
        search s = { .descriptor = descriptor, .params = params, .fixed = fixed, .x = trial };
        for (size_t i = 0; i < keep; i++) fixed[order[i]] = 1;
        for (int k = 0; k < STARTS; k++) {
            scatter(trial, &s, x, &random, k);
            st = newton(&s);
            if (st == JLT_OK) memcpy(x, trial, descriptor->state_count * sizeof *x);
            if (st == JLT_OK || st == JLT_ERR_NOMEM) return st;
        }
    }
    return st;
}
