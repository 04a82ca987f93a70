/* Searches for periodic orbits along lines and on a grid, and adds the mirror images of those found. */
#include "core/memory.h"
#include "dynamics/map_batch.h"
#include "dynamics/newton.h"
#include "dynamics/orbits.h"
#include "dynamics/section_batch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Number of starts whose orbits are followed together; most bytes of Newton searches that run together. */
enum { BLOCK = 1024, BYTES = 1 << 26 };

/* Newton's method must reach residuals of 1e-10; the digits beyond are left to the polish. */
static const double tolerance_least = 1e-11;

typedef struct {
    jlt_orbits *list;
    jlt_map *map;
    const jlt_orbits_options *options;
    const jlt_chart *chart;
    jlt_flow flow;                /* of the search */
    jlt_map_batch **maps;         /* one for each thread */
    unsigned threads;
    jlt_section_batch *together;
    jlt_newton *newton;           /* (count,) */
    size_t count, points, bytes;  /* points and bytes: of all of these searches */
} grid_search;

static bool raised(const grid_search *self)
{
    return self->flow.interrupt != NULL && *self->flow.interrupt;
}

static void clear_newton(grid_search *self)
{
    for (size_t i = 0; i < self->count; i++) jlt_newton_clear(&self->newton[i]);
    self->count = self->points = self->bytes = 0;
}

/* Unless an orbit that Newton found is known, polish it by the map itself, and add it. The points are rounded first, as their last
 * digits depend on the instruction set. */
static jlt_status keep(grid_search *self, const jlt_newton *newton)
{
    const size_t size = newton->period * self->chart->dim;
    jlt_periodic orbit = { .period = jlt_periodic_primitive(self->chart, newton->points, newton->period) };
    double points[JLT_PERIODIC_MAX * JLT_CHART_DIM_MAX];
    jlt_status st;

    memcpy(orbit.points, newton->points, orbit.period * self->chart->dim * sizeof *orbit.points);
    for (size_t i = 0; i < size; i++) {
        const int last = self->chart->scale[i % self->chart->dim] - 30;
        points[i] = ldexp(nearbyint(ldexp(newton->points[i], -last)), last);
    }
    orbit.T = newton->now.T * (double)orbit.period / (double)newton->period;
    if (!jlt_periodic_moves(&self->flow, &orbit) || jlt_orbits_has(self->list, self->chart, &orbit)) return JLT_OK;
    st = jlt_periodic_polish(self->map, &orbit, points, newton->period, NULL);
    if (jlt_orbits_is_miss(st)) return JLT_OK;
    return st != JLT_OK ? st : jlt_orbits_add(self->list, self->chart, &orbit);
}

/* Fill newton->then with the images of its trial, those from `first` on. Returns the status of the first that failed. */
static jlt_status look(jlt_newton *newton, const jlt_map_images *images, size_t first)
{
    const unsigned d = newton->chart->dim;

    jlt_shooting_reset(&newton->then);
    for (size_t k = 0; k < newton->period; k++) {
        const size_t at = first + k;
        const double measured[4] = { images->T[at], images->expansion[at], images->determinant[at], images->defect[at] };
        if (images->status[at] != JLT_OK) return images->status[at];
        jlt_shooting_add(&newton->then, newton->chart, newton->trial, newton->period, k, images->q + at * d,
                         images->slope + at * d * d, measured);
    }
    return JLT_OK;
}

/* Make one trial of each search in `going`; those that end leave the list. */
static jlt_status one_trial(jlt_map_batch *maps, jlt_newton **going, size_t *count, const jlt_map_images *images)
{
    const unsigned d = going[0]->chart->dim;
    size_t points = 0, at = 0, left = 0;

    for (size_t i = 0; i < *count; points += going[i++]->period)
        memcpy(images->q + points * d, going[i]->trial, going[i]->period * d * sizeof *images->q);
    JLT_PASS(jlt_map_batch_apply(maps, images, images->q, points, 1, 1));
    for (size_t i = 0; i < *count; i++) {
        const size_t first = at;
        at += going[i]->period;
        if (jlt_newton_next(going[i], look(going[i], images, first))) going[left++] = going[i];
    }
    *count = left;
    return JLT_OK;
}

/* Run these searches to their end, or to an interrupt. */
static jlt_status run(const grid_search *self, jlt_map_batch *maps, jlt_newton *newton, size_t count)
{
    JLT_FREED jlt_newton **going = malloc((count + 1) * sizeof *going);
    JLT_CLEARED(jlt_map_batch_images_clear) jlt_map_images images = { 0 };
    size_t points = 0;

    if (going == NULL) return JLT_ERR_NOMEM;
    for (size_t i = 0; i < count; points += newton[i++].period) going[i] = &newton[i];
    JLT_PASS(jlt_map_batch_images(&images, self->chart->dim, points + 1));
    while (count > 0 && !raised(self)) JLT_PASS(one_trial(maps, going, &count, &images));
    return count == 0 ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
}

/* Run all searches that have begun, a share on each thread, and keep what they find, in their order. */
static jlt_status solve(grid_search *self)
{
    const size_t share = (self->count + self->threads - 1) / self->threads;
    int failure = JLT_OK;
    jlt_status st = JLT_OK;

    if (self->newton == NULL) return JLT_OK; /* none has begun */
#if defined(_OPENMP)
#pragma omp parallel for num_threads((int)self->threads) schedule(static, 1) reduction(max : failure)
#endif
    for (unsigned thread = 0; thread < self->threads; thread++) {
        const size_t first = thread * share < self->count ? thread * share : self->count;
        const size_t count = self->count - first < share ? self->count - first : share;
        const int failed = (int)run(self, self->maps[thread], self->newton + first, count);
        if (failed > failure) failure = failed;
    }
    JLT_TRY((jlt_status)failure);
    for (size_t i = 0; i < self->count; i++) {
        if (self->newton[i].status == JLT_OK) JLT_TRY(keep(self, &self->newton[i]));
        else if (!jlt_orbits_is_miss(self->newton[i].status)) JLT_TRY(self->newton[i].status);
    }
done:
    clear_newton(self);
    return st;
}

/* Begin a search from the first point of the window q_0 .. q_(period_max) for every period after which the orbit nearly closes. */
static jlt_status begin_window(grid_search *self, const double *window, size_t filled)
{
    const unsigned d = self->chart->dim;
    const double near = self->options->near > 0 ? self->options->near : 0.6;

    for (size_t p = 1; p < filled; p++) {
        if (jlt_chart_distance(self->chart, window, window + p * d) > near) continue;
        if (!JLT_MEMORY_GROW(self->newton, self->count)) return JLT_ERR_NOMEM;
        JLT_PASS(jlt_newton_create(&self->newton[self->count], &self->flow, window, p, NULL));
        self->count++;
        self->points += p;
        self->bytes += p * d * (6 + 3 * d) * sizeof *window;
        if (self->bytes > BYTES) JLT_PASS(solve(self));
    }
    return JLT_OK;
}

/* Begin searches from start `index` of a block, and from the point its orbit reaches after `settle` returns. */
static jlt_status follow(grid_search *self, size_t index)
{
    const unsigned d = self->chart->dim;
    const size_t wanted = self->options->period_max + 1, settle = self->options->settle;
    double windows[2][(JLT_PERIODIC_MAX + 1) * JLT_CHART_DIM_MAX];
    size_t filled[2] = { 0, 0 };
    jlt_return row;
    jlt_status st = jlt_section_batch_start(self->together, &row, index);

    for (size_t i = 0; st == JLT_OK && row.fate == JLT_FATE_ALIVE && !row.interrupted; i++) {
        if (filled[0] < wanted) memcpy(windows[0] + filled[0]++ * d, row.q, d * sizeof *row.q);
        if (settle > 0 && i >= settle) memcpy(windows[1] + filled[1]++ * d, row.q, d * sizeof *row.q);
        if (filled[settle > 0 ? 1 : 0] == wanted) break;
        st = jlt_section_batch_next(self->together, &row);
    }
    if (st != JLT_OK && !jlt_orbits_is_miss(st)) return st;
    for (unsigned pass = 0; pass < 2; pass++) JLT_PASS(begin_window(self, windows[pass], filled[pass]));
    return JLT_OK;
}

static void grid_point(double *q, const jlt_orbits_options *options, const jlt_chart *chart, size_t index)
{
    for (unsigned k = 0; k < chart->dim; k++) {
        const size_t count = options->counts[k], i = index % count;
        const double parts = chart->period[k] != 0 ? (double)count : (double)(count > 1 ? count - 1 : 1);
        q[k] = options->low[k] + (options->high[k] - options->low[k]) * (double)i / parts;
        index /= count;
    }
}

static jlt_status search_block(grid_search *self, double *q, size_t first, size_t count)
{
    const unsigned d = self->chart->dim;

    for (size_t i = 0; i < count; i++) grid_point(q + i * d, self->options, self->chart, first + i);
    JLT_PASS(jlt_section_batch_run(self->together, q, count, self->options->settle + self->options->period_max));
    for (size_t i = 0; i < count && !raised(self); i++) JLT_PASS(follow(self, i));
    return raised(self) ? JLT_ERR_NO_CONVERGENCE : solve(self);
}

static jlt_status open_search(grid_search *self)
{
    const jlt_section_batch_options together = { .threads = self->options->threads };
    jlt_status st = jlt_section_batch_create(&self->together, &self->flow, self->options->kernels, &together);

    if (st != JLT_OK) return st;
    self->threads = self->options->threads > 1 ? self->options->threads : 1;
    self->maps = calloc(self->threads, sizeof(jlt_map_batch *));
    st = self->maps == NULL ? JLT_ERR_NOMEM : JLT_OK;
    for (unsigned i = 0; st == JLT_OK && i < self->threads; i++)
        st = jlt_map_batch_create(&self->maps[i], &self->flow, self->options->kernels, NULL, 1);
    return st;
}

/* Search from every start of the grid: where an orbit nearly closes, a Newton search begins, and all of these run side by side on
 * batches of maps; each orbit found is then polished and measured by the map itself, and added to the list. The result does not
 * depend on the number of threads. Errors: as jlt_orbits_search. */
static jlt_status search_grid(jlt_orbits *list, jlt_map *map, const jlt_orbits_options *options)
{
    grid_search self = {
        .list = list, .map = map, .options = options, .flow = *jlt_map_flow(map), .chart = jlt_map_flow(map)->chart
    };
    const unsigned d = self.chart->dim;
    JLT_FREED double *q = malloc(BLOCK * d * sizeof *q);
    size_t all = 1;
    jlt_status st = JLT_ERR_NOMEM;

    if (q == NULL) goto done;
    self.flow.tolerance = fmax(self.flow.tolerance, tolerance_least);
    for (unsigned k = 0; k < d; k++) all *= options->counts[k];
    JLT_TRY(open_search(&self));
    for (size_t first = 0; first < all; first += BLOCK) {
        const size_t count = all - first < BLOCK ? all - first : BLOCK;
        JLT_TRY(search_block(&self, q, first, count));
        if (options->progress != NULL) options->progress(options->context, "starts", first + count, all);
    }
done:
    clear_newton(&self);
    free(self.newton);
    for (unsigned i = 0; self.maps != NULL && i < self.threads; i++) jlt_map_batch_destroy(self.maps[i]);
    free(self.maps);
    jlt_section_batch_destroy(self.together);
    return st;
}

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
    const jlt_orbits_options *options;
} collector;

static jlt_status collect(void *context, const jlt_periodic *orbit)
{
    const collector *self = context;

    return jlt_orbits_add(self->list, self->chart, orbit);
}

static void collect_progress(void *context, const char *what, size_t done, size_t all)
{
    const jlt_orbits_options *options = ((const collector *)context)->options;

    if (options->progress != NULL) options->progress(options->context, what, done, all);
}

static bool allows(const jlt_orbits_options *options, unsigned dim)
{
    size_t all = 1;

    if (options == NULL || options->period_max == 0 || options->period_max > JLT_PERIODIC_MAX) return false;
    if (!(options->near >= 0) || options->settle > SIZE_MAX - options->period_max) return false;
    for (unsigned k = 0; options->counts[0] > 0 && k < dim; k++) {
        if (options->counts[k] == 0 || !isfinite(options->low[k]) || !isfinite(options->high[k])) return false;
        if (options->counts[k] > SIZE_MAX / all) return false;
        all *= options->counts[k];
    }
    return true;
}

jlt_status jlt_orbits_search(jlt_orbits *self, jlt_map *map, const jlt_orbits_options *options)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    collector into = { self, chart, options };
    const jlt_symmetric_sink sink = { collect, collect_progress, &into };
    jlt_status st = JLT_OK;

    if (!allows(options, chart->dim)) return JLT_ERR_ARG;
    for (size_t i = 0; i < options->line_count; i++)
        JLT_TRY(jlt_symmetric_search(map, &options->lines[i], options->period_max, options->kernels, options->threads,
                                     &sink));
    if (options->counts[0] > 0) JLT_TRY(search_grid(self, map, options));
    if (chart->reversible) JLT_TRY(add_mirrors(self, map));
done:
    jlt_orbits_sort(self, chart);
    return st;
}
