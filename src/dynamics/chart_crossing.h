/** Follows an orbit to its next crossing of a section that counts. */
#ifndef JLT_DYNAMICS_CHART_CROSSING_H
#define JLT_DYNAMICS_CHART_CROSSING_H

#include "dynamics/chart.h"
#include "integrate/orbit.h"

typedef struct {
    const jlt_chart *chart;
    jlt_direction direction;  /* of the crossings that count, for growing time */
    const jlt_event *events;  /* (count,): the `crossings` events of jlt_chart_events, then events that end the orbit */
    unsigned crossings, count;
    unsigned dim;             /* of the orbit, at most JLT_VARIED_DIM_MAX */
    size_t max_steps;         /* accepted and rejected ones */
} jlt_crossing_search;

/** Follow an orbit that was started in this direction of time to the next crossing that counts, to t_end, or to another end; *out
 *  as of jlt_orbit_next. Where the section's state is an angle the orbit is turned back by whole turns on the way, so that no
 *  crossing is missed however far it turns. Errors: as jlt_orbit_next and jlt_orbit_start; BUDGET, max_steps is spent. */
JLT_CHECKED jlt_status jlt_chart_crossing_find(const jlt_crossing_search *self, jlt_orbit *orbit, double t_end, int time_direction,
                                               jlt_outcome *out);

#endif
