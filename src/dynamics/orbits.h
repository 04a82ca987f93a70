/** Lists of periodic orbits, and the search that fills them: symmetric ones along lines, all others by Newton on a grid. */
#ifndef JLT_DYNAMICS_ORBITS_H
#define JLT_DYNAMICS_ORBITS_H

#include "dynamics/symmetric.h"

/** A list of orbits without duplicates, which it owns. All zero, it is empty. */
typedef struct {
    jlt_periodic *orbits; /* shape (count,) */
    size_t count;
} jlt_orbits;

void jlt_orbits_clear(jlt_orbits *self); /* frees; legal on a zeroed list */

/** Whether an orbit, of which period and points are known, is in the list. */
bool jlt_orbits_has(const jlt_orbits *self, const jlt_chart *chart, const jlt_periodic *orbit);

/** Whether a status ends one attempt to find an orbit, and not the search. */
bool jlt_orbits_is_miss(jlt_status status);

/** Add a copy, unless the same orbit is there already, begun at any of its points. chart: of the section it was found on.
 *  Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_orbits_add(jlt_orbits *self, const jlt_chart *chart, const jlt_periodic *orbit);

/** Sort by period, then by T, the time that the whole orbit takes, then by the coordinates of its first point; what differs by
 *  rounding alone counts as equal. */
void jlt_orbits_sort(jlt_orbits *self, const jlt_chart *chart);

/** Index of the orbit that is the mirror image, under the chart's reversor, of orbit `index`: `index` itself when it is
 *  symmetric; self->count when the image is not in the list. */
size_t jlt_orbits_mirror(const jlt_orbits *self, const jlt_chart *chart, size_t index);

typedef struct {
    size_t period_max;                                     /* 1 .. JLT_PERIODIC_MAX */
    double low[JLT_CHART_DIM_MAX], high[JLT_CHART_DIM_MAX]; /* of the grid of starts, ends included (angles: high left out) */
    size_t counts[JLT_CHART_DIM_MAX];                      /* of the grid, along each coordinate; counts[0] = 0: no grid */
    double near;   /* Newton is tried for period p from q where |P^p(q) - q| < near; default 0.6 */
    size_t settle; /* try again from where q is after this many returns, which finds attracting orbits; 0: do not */
    const jlt_kernel_batch *kernels; /* of the flow's field, for many starts at once; NULL: one at a time */
    unsigned threads;                /* 0 and 1: the caller's alone */
    const jlt_symmetric_line *lines; /* shape (line_count,): symmetric orbits are looked for on these as well; borrowed */
    size_t line_count;
    /* Called now and then: `done` of `all` are done of `what`, "samples" and "zeros" as in jlt_symmetric_sink, or "starts" of the
     * grid. NULL: not called. */
    void (*progress)(void *context, const char *what, size_t done, size_t all);
    void *context;
} jlt_orbits_options;

/** Search, and add what is found to the list, which is then sorted; on a section with a reversor mirror images of asymmetric
 *  orbits are added too, each measured by itself. Starts from which nothing is found are passed over. On an error the list
 *  holds what was found until then.
 *  Errors: ARG, period_max is out of its range, near is negative, or the grid has no starts, more than can be counted, or no finite
 *  ends; NOMEM; NO_CONVERGENCE when interrupted (flow.interrupt); of the lines as jlt_symmetric_search, of the grid as
 *  jlt_section_batch_run. */
JLT_CHECKED jlt_status jlt_orbits_search(jlt_orbits *self, jlt_map *map, const jlt_orbits_options *options);

#endif
