/* Searches for periodic orbits along lines and on a grid, and adds the mirror images of those found. */
#include "dynamics/orbits_grid.h"

static jlt_status add_mirrors(jlt_orbits *self, jlt_map *map)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    const size_t count = self->count;
    jlt_periodic image;

    for (size_t i = 0; i < count; i++) {
        if (self->orbits[i].symmetric || jlt_orbits_mirror(self, chart, i) < self->count) continue;
        jlt_periodic_mirror(chart, &image, &self->orbits[i]);
        const jlt_status st = jlt_periodic_find(map, &image, image.points, image.period, NULL);
        if (jlt_orbits_is_miss(st)) continue;
        JLT_PASS(st);
        JLT_PASS(jlt_orbits_add(self, chart, &image));
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

    if (options->period_max == 0 || options->period_max > JLT_PERIODIC_MAX) return JLT_ERR_ARG;
    for (size_t i = 0; i < options->line_count; i++)
        JLT_TRY(jlt_symmetric_search(map, &options->lines[i], options->period_max, collect, &into));
    if (options->counts[0] > 0) JLT_TRY(jlt_orbits_grid(self, map, options));
    if (chart->reversible) JLT_TRY(add_mirrors(self, map));
done:
    jlt_orbits_sort(self, chart);
    return st;
}
