/** Lists of periodic orbits, and the search that fills them: symmetric ones along lines, all others by Newton on a grid. */
#ifndef JLT_DYNAMICS_ORBITS_H
#define JLT_DYNAMICS_ORBITS_H

#include "dynamics/symmetric.h"

/** A list of orbits without duplicates, which it owns. All zero, it is empty. */
typedef struct {
    jlt_periodic *orbits; /* shape (count,) */
    size_t count, capacity;
} jlt_orbits;

void jlt_orbits_clear(jlt_orbits *self); /* frees; legal on a zeroed list */

/** Add unless it is there: an orbit found twice is kept once. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_orbits_add(jlt_orbits *self, const jlt_chart *chart, const jlt_periodic *orbit);

/** Sort by period, then by T, then by the first point. */
void jlt_orbits_sort(jlt_orbits *self);

/** Index of the mirror image of orbit `index`; itself when symmetric; count when it is not in the list. */
size_t jlt_orbits_mirror(const jlt_orbits *self, const jlt_chart *chart, size_t index);

typedef struct {
    size_t period_max;                                     /* 1 .. JLT_PERIODIC_MAX */
    double low[JLT_CHART_DIM_MAX], high[JLT_CHART_DIM_MAX]; /* of the grid of starts, ends included (angles: high left out) */
    size_t counts[JLT_CHART_DIM_MAX];                      /* of the grid; 0: no grid */
    double near;   /* Newton is tried for period p from q where |P^p(q) - q| < near; default 0.3 */
    size_t settle; /* try again from where q is after this many returns, which finds attracting orbits; 0: do not */
    const jlt_symmetric_line *lines;
    size_t line_count;
    void (*progress)(void *context, size_t done, size_t all, size_t found); /* NULL: nobody */
    void *context;
} jlt_orbits_options;

/** Search, and add what is found to the list; mirror images of asymmetric orbits are added too, each measured by itself. On an
 *  error the list holds what was found until then.
 *  Errors: ARG; NOMEM; NO_CONVERGENCE when interrupted. */
JLT_CHECKED jlt_status jlt_orbits_search(jlt_orbits *self, jlt_map *map, const jlt_orbits_options *options);

#endif
