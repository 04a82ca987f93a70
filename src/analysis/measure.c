#include "analysis/measure.h"

#include "analysis/family.h"
#include "core/memory.h"
#include "kernel/descriptor.h"
#include "kernel/kernel.h"
#include "kernel/region.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { STATES_MAX = JLT_MEASURE_STATES_MAX, TRIES = 20, DRAWS = 4096, PARTS = 256, PROBES = 8, POINTS_TRIED = 64 };

/* The part of a bounded interval over which the density is tabulated. A state without bounds is tabulated from -2 to 2. */
static const double covered = 0.98;

static void range_of(double *low, double *high, const jlt_instance *instance, size_t along)
{
    double lows[JLT_REGION_STATES_MAX], highs[JLT_REGION_STATES_MAX];

    jlt_region_intervals(lows, highs, instance->descriptor, instance->prepared);
    const double from = lows[along], to = highs[along];
    if (isfinite(from) && isfinite(to)) {
        const double middle = from / 2 + to / 2, half = to / 2 - from / 2;
        *low = middle - covered * half;
        *high = middle + covered * half;
        return;
    }
    *low = isfinite(from) ? from + 0.05 : -2.0;
    *high = isfinite(to) ? to - 0.05 : *low + 4.0;
    if (isfinite(to)) *low = *high - 4.0;
}

static bool holds(const jlt_instance *instance, const double *x)
{
    return jlt_region_holds(instance->descriptor->domain_count, instance->descriptor->domain_values.call, instance->prepared, x);
}

/* Cut the range of state `along` to the part around x[along] that lies within the table's domain, with the other states fixed. */
static void cut_range(double *low, double *high, const jlt_instance *instance, size_t along, const double *x)
{
    double y[STATES_MAX];

    memcpy(y, x, instance->descriptor->state_count * sizeof *y);
    for (double *end = low; end != NULL; end = end == low ? high : NULL) {
        const double part = (*end - x[along]) / PARTS;
        int k = 0;
        do y[along] = x[along] + (k + 1) * part;
        while (holds(instance, y) && ++k < PARTS);
        if (k < PARTS) *end = x[along] + k * part;
    }
}

static jlt_status density_at(double *density, const jlt_instance *instance, unsigned which, const double *x)
{
    const jlt_descriptor *d = instance->descriptor;
    double values[STATES_MAX];
    jlt_status st;

    if (d->measure_count > STATES_MAX) return JLT_ERR_UNSUPPORTED;
    st = jlt_kernel_eval(values, &d->measure_values, x, d->state_count, instance->prepared);
    if (st == JLT_OK) *density = values[which];
    return st;
}

/* Whether the closed form depends on state `along` alone: random other states do not change it. */
static bool depends_on_one(const jlt_instance *instance, unsigned which, const double *x, size_t along,
                           jlt_random *random)
{
    double value, other, y[STATES_MAX];

    if (density_at(&value, instance, which, x) != JLT_OK) return false;
    for (int probe = 0; probe < PROBES; probe++) {
        jlt_density_draw_state(y, instance->descriptor, instance->prepared, random);
        y[along] = x[along];
        if (density_at(&other, instance, which, y) != JLT_OK || fabs(other - value) > 1e-12 * fabs(value)) return false;
    }
    return true;
}

static jlt_status compare(jlt_measure_attempt *a, const jlt_instance *instance, unsigned which, const double *x)
{
    double y[STATES_MAX], middle = 1.0;

    a->closed = jlt_memory_array(a->count, sizeof *a->closed);
    if (a->closed == NULL) return JLT_ERR_NOMEM;
    memcpy(y, x, instance->descriptor->state_count * sizeof *y);
    y[a->along] = a->points[a->count / 2].at;
    JLT_PASS(density_at(&middle, instance, which, y));
    a->difference_bound = 1e-12;
    for (size_t i = 0; i < a->count; i++) {
        y[a->along] = a->points[i].at;
        JLT_PASS(density_at(&a->closed[i], instance, which, y));
        a->closed[i] /= middle;
        a->difference = fmax(a->difference, fabs(a->points[i].density / a->closed[i] - 1.0));
        a->difference_bound = fmax(a->difference_bound, a->points[i].error + 1e-12);
    }
    a->closed_form = instance->descriptor->measures[which].name;
    return JLT_OK;
}

/* The factor by which the density changes over its state's proved period, 1 within the quadrature's error; 1 without a period. */
static jlt_status turn_of(double *turn, const jlt_instance *instance, size_t along, double low, const double *x)
{
    const jlt_quantity *q = &instance->descriptor->states[along];
    jlt_density_point ends[2];

    *turn = 1.0;
    if (q->period == 0.0 || !jlt_descriptor_proves(instance->descriptor, "periodic", q->name)) return JLT_OK;
    JLT_PASS(jlt_density_tabulate(ends, 2, instance, along, low, low + q->period, x));
    if (fabs(ends[0].density - 1.0) > JLT_DENSITY_TOLERANCE + ends[0].error) *turn = 1.0 / ends[0].density;
    return JLT_OK;
}

/* Tabulate the density on the part of the range within the domain, with random other states x; the first tries accept only an x
 * for which this is the whole range. Errors: NO_PROGRESS, no state within the domain was drawn; the last error, if every
 * tabulation failed. */
static jlt_status tabulate(jlt_measure_attempt *a, const jlt_instance *instance, jlt_random *random, double *x)
{
    const jlt_descriptor *d = instance->descriptor;
    jlt_status st = JLT_ERR_NO_PROGRESS;
    double low, high;

    range_of(&low, &high, instance, a->along);
    for (int draws = 0, tries = 0; draws < DRAWS && tries < TRIES && st != JLT_OK && st != JLT_ERR_NOMEM; draws++) {
        double from = low, to = high;
        jlt_density_draw_state(x, d, instance->prepared, random);
        const double drawn = x[a->along];
        x[a->along] = low / 2 + high / 2;
        if (!holds(instance, x)) x[a->along] = drawn;
        if (!(x[a->along] > low && x[a->along] < high) || !holds(instance, x)) continue;
        cut_range(&from, &to, instance, a->along, x);
        const bool is_whole = from == low && to == high;
        if (++tries <= TRIES / 2 && !is_whole) continue;
        st = jlt_density_tabulate(a->points, a->count, instance, a->along, from, to, x);
        if (st == JLT_OK && is_whole) st = turn_of(&a->turn, instance, a->along, low, x);
    }
    return st;
}

/* f_q at q = at, with the other states of x; NaN if the field cannot be evaluated. */
static double rate_at(const jlt_instance *instance, size_t along, double *x, double at)
{
    double f[STATES_MAX];

    x[along] = at;
    return jlt_instance_rhs(instance, f, x) == JLT_OK ? f[along] : NAN;
}

/* The least |f_q| between two values of q, by ternary search: the third next to the larger value is dropped. */
static double least_rate(const jlt_instance *instance, size_t along, double *x, double low, double high)
{
    enum { THIRDS = 80 };
    double least = INFINITY;

    for (int k = 0; k < THIRDS; k++) {
        const double third = (high - low) / 3;
        const double left = fabs(rate_at(instance, along, x, low + third)), right = fabs(rate_at(instance, along, x, high - third));
        least = fmin(least, fmin(left, right));
        if (left > right) low += third;
        else high -= third;
    }
    return least;
}

/* Whether -div f/f_q has a pole in the table's range: f_q changes sign, or touches zero as far as doubles tell. */
static bool rate_vanishes(const jlt_measure_attempt *a, const jlt_instance *instance, const double *x)
{
    enum { CELLS = 1024 };
    const double from = a->points[0].at, cell = (a->points[a->count - 1].at - from) / CELLS;
    double y[STATES_MAX], before = NAN, most = 0, least = INFINITY, nearest = from;

    memcpy(y, x, instance->descriptor->state_count * sizeof *y);
    for (int k = 0; k <= CELLS; k++) {
        const double at = from + k * cell, rate = rate_at(instance, a->along, y, at);
        if (rate == 0 || (before < 0 && rate > 0) || (before > 0 && rate < 0)) return true;
        before = rate;
        most = fmax(most, fabs(rate));
        if (!(fabs(rate) < least)) continue;
        least = fabs(rate);
        nearest = at;
    }
    return least_rate(instance, a->along, y, nearest - cell, nearest + cell) <= 1e-12 * most;
}

/* Whether q is constant along the motion: the product of an invariant density and any function of q is then one too. */
static bool rests(const jlt_measure_attempt *a, const jlt_instance *instance, const double *x)
{
    double y[STATES_MAX];

    memcpy(y, x, instance->descriptor->state_count * sizeof *y);
    for (size_t i = 0; i < a->count; i++)
        if (rate_at(instance, a->along, y, a->points[i].at) != 0) return false;
    return true;
}

/* Tabulate the density along attempt->along, and compare it with the table's. Without an error, attempt->points stays NULL where
 * it is no smooth positive density. */
static jlt_status try_along(jlt_measure_attempt *attempt, const jlt_instance *instance, jlt_random *random)
{
    const jlt_descriptor *d = instance->descriptor;
    double x[STATES_MAX];

    attempt->points = jlt_memory_array(attempt->count, sizeof *attempt->points);
    if (attempt->points == NULL) return JLT_ERR_NOMEM;
    jlt_status st = tabulate(attempt, instance, random, x);
    if (st == JLT_ERR_NO_PROGRESS) return JLT_ERR_NO_CONVERGENCE;
    if (st == JLT_ERR_NOMEM) return st;
    attempt->singular = st != JLT_OK && rate_vanishes(attempt, instance, x);
    if (st == JLT_ERR_NONFINITE && !attempt->singular) return st;
    if (st != JLT_OK || attempt->turn != 1.0) {
        free(attempt->points);
        attempt->points = NULL;
        return JLT_OK;
    }
    for (unsigned i = 0; st == JLT_OK && attempt->closed_form == NULL && i < d->measure_count; i++)
        if (depends_on_one(instance, i, x, attempt->along, random)) st = compare(attempt, instance, i, x);
    if (st == JLT_OK && attempt->difference > attempt->difference_bound && rests(attempt, instance, x)) {
        free(attempt->closed);
        attempt->closed = NULL;
        attempt->closed_form = NULL;
    }
    return st;
}

/* The state of least defect at rounding level that is not yet tried; `count` if there is none. */
static size_t next_state(const double *defects, const bool *tried, size_t count)
{
    size_t least = count;

    for (size_t i = 0; i < count; i++)
        if (!tried[i] && defects[i] <= JLT_DENSITY_TOLERANCE && (least == count || defects[i] < defects[least])) least = i;
    return least;
}

static jlt_status measure_defects(jlt_measure_attempt *attempt, const jlt_instance *instance, jlt_random *random)
{
    for (size_t i = 0; i < instance->descriptor->state_count; i++) {
        double defect;
        const jlt_status st = jlt_density_defect(&defect, instance, i, random);
        if (st != JLT_OK && st != JLT_ERR_NO_CONVERGENCE) return st;
        attempt->defects[i] = st == JLT_OK ? defect : NAN;
        if (st == JLT_OK && defect < attempt->defect) {
            attempt->along = i;
            attempt->defect = defect;
        }
    }
    return isfinite(attempt->defect) ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
}

jlt_status jlt_measure_try(jlt_measure_attempt *attempt, const jlt_instance *instance, size_t count, jlt_random *random)
{
    const size_t states = instance->descriptor->state_count;
    bool tried[STATES_MAX] = { false };

    *attempt = (jlt_measure_attempt){ .defect = INFINITY, .turn = 1.0, .count = count };
    if (states > STATES_MAX) return JLT_ERR_UNSUPPORTED;
    JLT_PASS(measure_defects(attempt, instance, random));
    attempt->found = attempt->defect <= JLT_DENSITY_TOLERANCE;
    if (!attempt->found) return JLT_OK;
    const jlt_measure_attempt blank = *attempt;
    const jlt_status st = try_along(attempt, instance, random);
    for (size_t along = attempt->along; st != JLT_ERR_NOMEM && (st != JLT_OK || attempt->points == NULL);) {
        jlt_measure_attempt other = blank;
        tried[along] = true;
        along = other.along = next_state(blank.defects, tried, states);
        if (along == states) break;
        other.defect = blank.defects[along];
        const jlt_status told = try_along(&other, instance, random);
        if (told == JLT_ERR_NOMEM || (told == JLT_OK && other.points != NULL)) {
            jlt_measure_clear(attempt);
            *attempt = other;
            return told;
        }
        jlt_measure_clear(&other);
    }
    return st;
}

void jlt_measure_clear(jlt_measure_attempt *attempt)
{
    free(attempt->points);
    free(attempt->closed);
    *attempt = (jlt_measure_attempt){ 0 };
}

/* Prove in balls, at the exact parameters, that the equilibrium near f->x exists and that its trace is not zero. In doubles, if
 * the exact states or parameters are no doubles, rounding alone makes a zero trace differ from zero. */
static jlt_status confirm(jlt_measure_finding *f, const jlt_descriptor *d, const double *params, const char *const *exact)
{
    JLT_FREED jlt_ball_value *values = jlt_memory_array(d->param_count + 1, sizeof *values);
    jlt_ball_value x[JLT_LINEARIZATION_SIZE_MAX];
    jlt_status st;

    if (values == NULL) return JLT_ERR_NOMEM;
    for (unsigned i = 0; i < d->param_count; i++) values[i] = (jlt_ball_value){ params[i], exact == NULL ? NULL : exact[i] };
    for (unsigned i = 0; i < d->state_count; i++) x[i] = (jlt_ball_value){ f->x[i], NULL };
    st = jlt_linearization_enclose(&f->obstruction, d, values, x, NULL, 0);
    f->obstructed = st == JLT_OK && f->obstruction.exists && f->obstruction.obstructs;
    return st == JLT_ERR_NOMEM ? st : JLT_OK;
}

jlt_status jlt_measure_obstruct(jlt_measure_finding *f, const jlt_descriptor *d, const double *params,
                                const char *const *exact, jlt_random *random)
{
    double point[JLT_LINEARIZATION_SIZE_MAX];

    if (d->state_count > JLT_LINEARIZATION_SIZE_MAX) return JLT_OK;
    for (unsigned k = 0; k < d->equilibria_count; k++) {
        for (int attempt = 0; attempt < POINTS_TRIED && d->equilibria[k].obstructs; attempt++) {
            jlt_density_draw_state(f->x, f->instance->descriptor, f->instance->prepared, random);
            if (!jlt_family_point(point, &d->equilibria[k], d, params, f->x)) continue;
            memcpy(f->x, point, d->state_count * sizeof *point);
            jlt_status st = jlt_linearization_compute(&f->obstruction, d, params, f->x, NULL, NULL, NULL);
            if (st == JLT_OK && f->obstruction.obstructs) st = confirm(f, d, params, exact);
            if (st == JLT_ERR_NOMEM || f->obstructed) return st;
        }
    }
    return JLT_OK;
}

jlt_status jlt_measure_find(jlt_measure_finding *finding, const jlt_descriptor *general, const double *params,
                            const char *const *exact, size_t count, jlt_random *random)
{
    const jlt_descriptor *special = jlt_descriptor_choose(general, NULL, NULL, params);

    if (special == NULL || special->measure_count > JLT_MEASURE_CLAIMS_MAX) return JLT_ERR_UNSUPPORTED;
    JLT_PASS(jlt_instance_create(&finding->instance, special, params));
    JLT_PASS(jlt_measure_try(&finding->attempt, finding->instance, count, random));
    JLT_PASS(jlt_density_residual(finding->residual, finding->instance, JLT_MEASURE_SAMPLES, random));
    return jlt_measure_obstruct(finding, general, params, exact, random);
}

void jlt_measure_forget(jlt_measure_finding *finding)
{
    jlt_measure_clear(&finding->attempt);
    jlt_instance_destroy(finding->instance);
    *finding = (jlt_measure_finding){ 0 };
}
