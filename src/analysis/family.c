#include "analysis/family.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "analysis/linearization.h"
#include "kernel/descriptor.h"
#include "kernel/kernel.h"

static bool near(double a, double b)
{
    return fabs(a - b) <= JLT_LINEARIZATION_TOLERANCE * fmax(fabs(a), fabs(b));
}

/* The proved period of a state; 0: none is proved. */
static double period_of(const jlt_descriptor *d, unsigned i)
{
    const jlt_claim *claim = d->states[i].period > 0 ? jlt_descriptor_claim(d, "periodic", d->states[i].name) : NULL;
    return claim != NULL && claim->verdict == JLT_PROVED ? d->states[i].period : 0.0;
}

/* The multiple of the state's period that is next to x - value; 0 if x is near `value`. */
static double turns_between(const jlt_descriptor *d, unsigned i, double x, double value)
{
    const double period = period_of(d, i), turns = period > 0 ? round((x - value) / period) : 0;
    return near(x, value) || !isfinite(turns) ? 0.0 : turns * period;
}

/* Whether a state has this value up to periods; false if x is so large that its rounding error is a notable part of a period. */
static bool meets(const jlt_descriptor *d, unsigned i, double x, double value)
{
    static const double part = 1e-6; /* of a period */
    const double on = value + turns_between(d, i, x, value);

    return near(x, value) || (near(x, on) && fabs(x - on) + DBL_EPSILON * fabs(x) <= part * period_of(d, i));
}

bool jlt_family_point(double *point, const jlt_equilibria *family, const jlt_descriptor *d, const double *params, const double *x)
{
    double imposed[JLT_DESCRIPTOR_VALUES_MAX];

    if (jlt_kernel_eval_function(imposed, family->impose, d->param_count, x, d->state_count, params, d->param_count) != JLT_OK)
        return false;
    for (unsigned i = 0; i < d->param_count; i++)
        if (!near(imposed[i], params[i])) return false;
    return jlt_kernel_eval_function(point, family->point, d->state_count, x, d->state_count, params, d->param_count) == JLT_OK;
}

const jlt_equilibria *jlt_family_of(const jlt_descriptor *d, const double *params, const double *x)
{
    const jlt_equilibria *best = NULL;
    int most = -1;

    for (unsigned k = 0; k < d->equilibria_count; k++) {
        const jlt_equilibria *family = &d->equilibria[k];
        const int says = (family->trace != NULL) + (family->charpoly != NULL) + (family->matrix != NULL);
        double point[JLT_LINEARIZATION_SIZE_MAX];
        bool on = jlt_family_point(point, family, d, params, x);
        for (unsigned i = 0; on && i < d->state_count; i++) on = meets(d, i, x[i], point[i]);
        if (on && says > most) {
            best = family;
            most = says;
        }
    }
    return best;
}

void jlt_family_turn_back(double *out, const jlt_equilibria *family, const jlt_descriptor *d, const double *params, const double *x)
{
    double point[JLT_LINEARIZATION_SIZE_MAX];
    const bool on = jlt_family_point(point, family, d, params, x);

    for (unsigned i = 0; i < d->state_count; i++) out[i] = on ? x[i] - turns_between(d, i, x[i], point[i]) : x[i];
}

static bool is_refuted(const jlt_descriptor *d, const jlt_equilibria *family)
{
    const jlt_claim *claim = jlt_descriptor_claim(d, "equilibria", family->name);
    return claim != NULL && claim->verdict == JLT_REFUTED;
}

const jlt_equilibria *jlt_family_refuted(const jlt_descriptor *d)
{
    for (unsigned k = 0; k < d->equilibria_count; k++)
        if (is_refuted(d, &d->equilibria[k])) return &d->equilibria[k];
    return NULL;
}

/* How badly the given states fit a family with this point, shape (state_count,): the number of given states that it fixes; n + 1,
 * the worst, if one of them differs from the point's. */
static unsigned misfit(const jlt_equilibria *family, const jlt_descriptor *d, const double *point, const double *x,
                       const unsigned char *given)
{
    const unsigned n = d->state_count;
    unsigned fixed = 0;

    for (unsigned i = 0; i < n; i++) {
        if (!given[i] || family->is_free[i]) continue;
        if (!meets(d, i, x[i], point[i])) return n + 1;
        fixed++;
    }
    return fixed;
}

void jlt_family_complete(double *x, const unsigned char *given, const jlt_descriptor *d, const double *params)
{
    const unsigned n = d->state_count;
    double point[JLT_LINEARIZATION_SIZE_MAX], best[JLT_LINEARIZATION_SIZE_MAX];
    unsigned least = n + 2;

    if (n > JLT_LINEARIZATION_SIZE_MAX) return;
    for (unsigned i = 0; i < n; i++)
        if (!given[i]) x[i] = 0.0;
    for (unsigned k = 0; k < d->equilibria_count && least > 0; k++) {
        const jlt_equilibria *family = &d->equilibria[k];
        if (is_refuted(d, family) || !jlt_family_point(point, family, d, params, x)) continue;
        const unsigned fit = misfit(family, d, point, x, given);
        if (fit < least) memcpy(best, point, n * sizeof *best);
        least = fit < least ? fit : least;
    }
    for (unsigned i = 0; least < n + 2 && i < n; i++)
        if (!given[i]) x[i] = best[i];
}
