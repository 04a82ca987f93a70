#include "cli/drift.h"

#include <math.h>

#include "integrate/rest.h"

/* Whether the orbit comes to rest, and where. */
typedef struct {
    jlt_rest_watch rest;
    double limit[JLT_TOP_FIVE_STATES];
} rest_watch;

static int watch(void *context, jlt_orbit *orbit)
{
    rest_watch *self = context;
    return jlt_rest_watch_step(&self->rest, jlt_orbit_stepper(orbit), self->limit);
}

static void end_by(jlt_drift_end *end, const jlt_outcome *at, double t, size_t returns)
{
    const jlt_fate fate = at->end == JLT_END_OBSERVER        ? JLT_FATE_EQUILIBRIUM
                          : jlt_top_five_side(at->x) > 0 ? JLT_FATE_POLE_PLUS
                                                         : JLT_FATE_POLE_MINUS;

    jlt_section_fate_text(end->name, NULL, fate, JLT_OBSERVED_ANY);
    end->t = t;
    end->returns = returns;
}

jlt_status jlt_drift_top(jlt_drift *self, jlt_drift_row *rows, size_t *count, jlt_drift_end *end, const jlt_method *method)
{
    const jlt_flow *flow = &self->system->flow;
    const jlt_event section = { .column = self->five.column, .direction = flow->direction };
    const jlt_options to_orbit = { .tolerance = flow->tolerance, .interrupt = flow->interrupt,
                                   .max_steps = 100000, /* of one return, as on sections */
                                   .invariants = self->five.invariants, .project = self->project };
    rest_watch rest;
    double first[JLT_INVARIANTS_MAX], now[JLT_INVARIANTS_MAX], sizes[JLT_INVARIANTS_MAX];
    jlt_orbit *orbit = NULL;
    jlt_outcome at = { .t = 0 };
    jlt_drift_row row = { .returns = 0 };
    jlt_status st = JLT_OK;

    *count = 0;
    *end = (jlt_drift_end){ .t = 0 };
    self->five.invariants.values(self->five.start, self->five.invariants.p, first);
    for (unsigned i = 0; i < self->count; i++) sizes[i] = first[i] != 0 ? fabs(first[i]) : 1;
    JLT_TRY(jlt_orbit_create(&orbit, method, &self->five.field, &to_orbit));
    jlt_orbit_observe(orbit, watch, &rest);
    JLT_TRY(jlt_orbit_start(orbit, 0, self->five.start, 1));
    for (size_t i = 1; i <= self->returns && !ferror(self->file); i++) {
        rest.rest = (jlt_rest_watch){ 0 };
        JLT_TRY(jlt_orbit_next(orbit, INFINITY, &section, 1, &at));
        if (at.end == JLT_END_INTERRUPT) break;
        if (at.end != JLT_END_EVENT) {
            end_by(end, &at, ldexp(at.t, self->five.time), i - 1);
            break;
        }
        self->five.invariants.values(at.x, self->five.invariants.p, now);
        row.returns = i;
        row.t = ldexp(at.t, self->five.time);
        row.evaluations = jlt_orbit_stepper(orbit)->evaluations;
        JLT_TRY(jlt_drift_note(self, method, &row, rows, count, first, sizes, now));
    }
    jlt_drift_end_row(self, method, &row, rows, count, end);
done:
    jlt_orbit_destroy(orbit);
    return st;
}
