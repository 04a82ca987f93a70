#include "analysis/family.h"

#include <math.h>

#include "analysis/linearization.h"
#include "kernel/descriptor.h"
#include "kernel/kernel.h"

static bool near(double a, double b)
{
    return fabs(a - b) <= JLT_LINEARIZATION_TOLERANCE * fmax(fabs(a), fabs(b));
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
        for (unsigned i = 0; on && i < d->state_count; i++) on = near(point[i], x[i]);
        if (on && says > most) {
            best = family;
            most = says;
        }
    }
    return best;
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

void jlt_family_complete(double *x, const unsigned char *given, const jlt_descriptor *d, const double *params)
{
    const unsigned n = d->state_count;
    double point[JLT_LINEARIZATION_SIZE_MAX];

    if (n > JLT_LINEARIZATION_SIZE_MAX) return;
    for (unsigned i = 0; i < n; i++)
        if (!given[i]) x[i] = 0.0;
    for (int belongs = 1; belongs >= 0; belongs--)
        for (unsigned k = 0; k < d->equilibria_count; k++) {
            if (is_refuted(d, &d->equilibria[k]) || !jlt_family_point(point, &d->equilibria[k], d, params, x)) continue;
            bool fits = true;
            for (unsigned i = 0; belongs && fits && i < n; i++) fits = !given[i] || near(point[i], x[i]);
            if (!fits) continue;
            for (unsigned i = 0; i < n; i++)
                if (!given[i]) x[i] = point[i];
            return;
        }
}
