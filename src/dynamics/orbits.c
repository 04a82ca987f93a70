#include "dynamics/orbits.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/orbits_grid.h"

static const double same_point = 1e-7;

void jlt_orbits_clear(jlt_orbits *self)
{
    free(self->orbits);
    *self = (jlt_orbits){ .count = 0 };
}

bool jlt_orbits_has(const jlt_orbits *self, const jlt_chart *chart, const jlt_periodic *orbit)
{
    for (size_t i = 0; i < self->count; i++)
        if (jlt_periodic_same(chart, &self->orbits[i], orbit, same_point)) return true;
    return false;
}

jlt_status jlt_orbits_add(jlt_orbits *self, const jlt_chart *chart, const jlt_periodic *orbit)
{
    jlt_periodic *grown;

    if (jlt_orbits_has(self, chart, orbit)) return JLT_OK;
    if (self->count == self->capacity) {
        const size_t capacity = self->capacity == 0 ? 16 : 2 * self->capacity;
        grown = realloc(self->orbits, capacity * sizeof *grown);
        if (grown == NULL) return JLT_ERR_NOMEM;
        self->orbits = grown;
        self->capacity = capacity;
    }
    self->orbits[self->count++] = *orbit;
    return JLT_OK;
}

static int compare(const void *left, const void *right)
{
    const jlt_periodic *a = left, *b = right;

    if (a->period != b->period) return a->period < b->period ? -1 : 1;
    if (fabs(a->T - b->T) > 1e-9 * fmax(fabs(a->T), fabs(b->T))) return a->T < b->T ? -1 : 1;
    return a->points[0] < b->points[0] ? -1 : a->points[0] > b->points[0];
}

void jlt_orbits_sort(jlt_orbits *self)
{
    if (self->count > 1) qsort(self->orbits, self->count, sizeof *self->orbits, compare);
}

/* The mirror image runs through the mirrored points backwards; it starts at the image of the first point. */
static void reflect(jlt_periodic *out, const jlt_periodic *orbit, const jlt_chart *chart)
{
    size_t k;

    *out = *orbit;
    for (k = 0; k < orbit->period; k++)
        jlt_chart_mirror(chart, out->points + k * chart->dim,
                         orbit->points + (orbit->period - k) % orbit->period * chart->dim);
}

size_t jlt_orbits_mirror(const jlt_orbits *self, const jlt_chart *chart, size_t index)
{
    jlt_periodic image;
    size_t i;

    if (!chart->reversible) return self->count;
    reflect(&image, &self->orbits[index], chart);
    for (i = 0; i < self->count; i++)
        if (jlt_periodic_same(chart, &self->orbits[i], &image, same_point)) return i;
    return self->count;
}

bool jlt_orbits_is_miss(jlt_status st)
{
    return st != JLT_OK && st != JLT_ERR_NOMEM && st != JLT_ERR_ARG && st != JLT_ERR_UNSUPPORTED;
}

static jlt_status add_mirrors(jlt_orbits *self, jlt_map *map)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    const size_t count = self->count;
    jlt_periodic image;
    jlt_status st;
    size_t i;

    for (i = 0; i < count; i++) {
        if (self->orbits[i].symmetric || jlt_orbits_mirror(self, chart, i) < self->count) continue;
        reflect(&image, &self->orbits[i], chart);
        st = jlt_periodic_find(map, &image, image.points, image.period, NULL);
        if (jlt_orbits_is_miss(st)) continue;
        if (st == JLT_OK) st = jlt_orbits_add(self, chart, &image);
        if (st != JLT_OK) return st;
    }
    return JLT_OK;
}

typedef struct {
    jlt_orbits *list;
    const jlt_chart *chart;
} collector;

static jlt_status collect(void *context, const jlt_periodic *orbit)
{
    const collector *self = context;

    return jlt_orbits_add(self->list, self->chart, orbit);
}

jlt_status jlt_orbits_search(jlt_orbits *self, jlt_map *map, const jlt_orbits_options *options)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    collector into = { self, chart };
    jlt_status st = JLT_OK;
    size_t i;

    if (options->period_max == 0 || options->period_max > JLT_PERIODIC_MAX) return JLT_ERR_ARG;
    for (i = 0; i < options->line_count; i++)
        JLT_TRY(jlt_symmetric_search(map, &options->lines[i], options->period_max, collect, &into));
    if (options->counts[0] > 0) JLT_TRY(jlt_orbits_grid(self, map, options));
    if (chart->reversible) JLT_TRY(add_mirrors(self, map));
done:
    jlt_orbits_sort(self);
    return st;
}
