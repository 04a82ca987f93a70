#include "dynamics/chart_crossing.h"

#include <string.h>

#include "dynamics/varied.h"

static size_t steps_of(const jlt_orbit *orbit)
{
    return jlt_orbit_stepper(orbit)->steps + jlt_orbit_stepper(orbit)->rejected;
}

jlt_status jlt_chart_crossing_find(const jlt_crossing_search *self, jlt_orbit *orbit, double t_end, int time_direction,
                                   jlt_outcome *out)
{
    const size_t spent = steps_of(orbit);
    double x[JLT_VARIED_DIM_MAX];

    for (;;) {
        JLT_PASS(jlt_orbit_next(orbit, t_end, self->events, self->count, out));
        if (out->end != JLT_END_EVENT || out->crossing.event >= self->crossings) return JLT_OK;
        if (jlt_chart_counts(self->chart, &out->crossing, self->direction)) return JLT_OK;
        if (steps_of(orbit) - spent >= self->max_steps) return JLT_ERR_BUDGET;
        memcpy(x, out->x, self->dim * sizeof *x);
        jlt_chart_turn_back(self->chart, x);
        JLT_PASS(jlt_orbit_start(orbit, out->t, x, time_direction));
    }
}
