#define _GNU_SOURCE /* qsort_r */
#include "dynamics/orbits.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "core/memory.h"

static const double same_point = 1e-7;
static const double same_degenerate = 1e-4; /* a residual of 1e-13 determines a fold to its square root, a cusp to its cube root */

void jlt_orbits_clear(jlt_orbits *self)
{
    free(self->orbits);
    *self = (jlt_orbits){ .count = 0 };
}

bool jlt_orbits_has(const jlt_orbits *self, const jlt_chart *chart, const jlt_periodic *orbit)
{
    for (size_t i = 0; i < self->count; i++) {
        const bool both = self->orbits[i].type == JLT_ORBIT_DEGENERATE && orbit->type == JLT_ORBIT_DEGENERATE;
        if (jlt_periodic_same(chart, &self->orbits[i], orbit, both ? same_degenerate : same_point)) return true;
    }
    return false;
}

jlt_status jlt_orbits_add(jlt_orbits *self, const jlt_chart *chart, const jlt_periodic *orbit)
{
    if (jlt_orbits_has(self, chart, orbit)) return JLT_OK;
    if (!JLT_MEMORY_GROW(self->orbits, self->count)) return JLT_ERR_NOMEM;
    self->orbits[self->count++] = *orbit;
    return JLT_OK;
}

/* Compares orbits for sorting; what differs by rounding alone counts as equal. */
static int compare(const void *left, const void *right, void *context)
{
    const jlt_periodic *a = left, *b = right;
    const jlt_chart *chart = context;

    if (a->period != b->period) return a->period < b->period ? -1 : 1;
    if (fabs(a->T - b->T) > 1e-9 * fmax(fabs(a->T), fabs(b->T))) return a->T < b->T ? -1 : 1;
    for (unsigned k = 0; k < chart->dim; k++)
        if (fabs(ldexp(a->points[k] - b->points[k], -chart->scale[k])) > same_point) return a->points[k] < b->points[k] ? -1 : 1;
    return 0;
}

void jlt_orbits_sort(jlt_orbits *self, const jlt_chart *chart)
{
    if (self->count > 1) qsort_r(self->orbits, self->count, sizeof *self->orbits, compare, (void *)(uintptr_t)chart);
}

size_t jlt_orbits_mirror(const jlt_orbits *self, const jlt_chart *chart, size_t index)
{
    jlt_periodic image;

    if (!chart->reversible) return self->count;
    jlt_periodic_mirror(chart, &image, &self->orbits[index]);
    for (size_t i = 0; i < self->count; i++)
        if (jlt_periodic_same(chart, &self->orbits[i], &image, same_point)) return i;
    return self->count;
}

bool jlt_orbits_is_miss(jlt_status st)
{
    return st != JLT_OK && st != JLT_ERR_NOMEM && st != JLT_ERR_ARG && st != JLT_ERR_UNSUPPORTED;
}
