/** Detects passages of an orbit so near to a saddle of the return map that errors decide on which side of the separatrices it goes
 *  on. Only maps that nearly preserve volume count: on a thin attractor orbits come as near by chance. */
#ifndef JLT_DYNAMICS_SADDLE_H
#define JLT_DYNAMICS_SADDLE_H

#include "dynamics/map.h"
#include "dynamics/map_batch.h"

/** What is known of an orbit. Zeroed at its start. */
typedef struct {
    size_t at;     /* number of the first return from a point nearer to a saddle than max(1, reach) times the square root of the
                      tolerance; 0: there is none */
    double reach;  /* the longest move of a return, in units of the coordinates' sizes */
    bool has_left; /* it has gone from there */
} jlt_saddle_watch;

/** Note return `number`, from `before`, shape (dim,), to made->q, with its derivative. */
void jlt_saddle_note(jlt_saddle_watch *self, const jlt_flow *flow, const double *before, const jlt_map_batch_return *made,
                     size_t number);

/** The same for an orbit whose derivatives are not computed. One derivative is computed, at the point nearest to a fixed point,
 *  once the orbit has gone from there. Zeroed at its start. */
typedef struct {
    jlt_saddle_watch watch;
    double nearest; /* the least move since the orbit last went away, in return `number`, 0: none yet, from `point` to `next` */
    size_t number, rests_until; /* no passage is looked at before the return rests_until */
    double point[JLT_CHART_DIM_MAX], next[JLT_CHART_DIM_MAX]; /* (dim,) */
} jlt_saddle_search;

/** Note return `number`, from `before` to `after`, shape (dim,), in time_direction; *map is created where it is needed and NULL,
 *  and is the caller's. A saddle where DP cannot be computed is not seen. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_saddle_search_note(jlt_saddle_search *self, jlt_map **map, const jlt_flow *flow, const double *before,
                                              const double *after, size_t number, int time_direction);

#endif
