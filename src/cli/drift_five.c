#include "cli/drift.h"

#include <math.h>
#include <string.h>

#include "integrate/rest.h"
#include "kernel/descriptor.h"
#include "scene/tier.h"

/* The start on the section as the tier five has it, in the flow's units. */
static jlt_status lift(double *x, const jlt_system *system, const double *q)
{
    double level[JLT_CHART_STATES_MAX];
    const jlt_status st = system->flow.chart->lift(system->flow.chart, level, NULL, q);

    if (st != JLT_OK) return st;
    memcpy(x, level, 3 * sizeof *x);
    jlt_chart_top_rotation(&system->flow_chart, &x[JLT_TOP_OMEGA_N], &x[JLT_TOP_OMEGA3], level);
    x[JLT_TOP_STATES] = level[JLT_CHART_TOP_S];
    return JLT_OK;
}

/* Whether the orbit comes to rest, and where. */
typedef struct {
    jlt_rest_watch rest;
    double limit[JLT_DRIFT_STATES];
} rest_watch;

static int watch(void *context, jlt_orbit *orbit)
{
    rest_watch *self = context;
    return jlt_rest_watch_step(&self->rest, jlt_orbit_stepper(orbit), self->limit);
}

static void end_by(jlt_drift_end *end, const jlt_outcome *at, double t, size_t returns)
{
    const jlt_fate fate = at->end == JLT_END_OBSERVER ? JLT_FATE_EQUILIBRIUM : at->x[JLT_TOP_GAMMA3] > 0 ? JLT_FATE_POLE_PLUS : JLT_FATE_POLE_MINUS;

    jlt_section_fate_text(end->name, NULL, fate, JLT_OBSERVED_ANY);
    end->t = t;
    end->returns = returns;
}

jlt_status jlt_drift_five(jlt_drift *self, jlt_drift_row *rows, size_t *count, jlt_drift_end *end, const jlt_method *method)
{
    const jlt_flow *flow = &self->system->flow;
    const jlt_event section = { .column = JLT_TOP_OMEGA_TAU, .direction = flow->direction };
    const jlt_options to_orbit = { .tolerance = flow->tolerance, .interrupt = flow->interrupt,
                                   .max_steps = 100000, /* of one return, as on sections */
                                   .invariants = self->invariants, .project = self->project };
    rest_watch rest;
    double first[JLT_INVARIANTS_MAX], now[JLT_INVARIANTS_MAX], sizes[JLT_INVARIANTS_MAX];
    jlt_orbit *orbit = NULL;
    jlt_outcome at = { .t = 0 };
    jlt_drift_row row = { .returns = 0 };
    jlt_status st = JLT_OK;

    *count = 0;
    *end = (jlt_drift_end){ .t = 0 };
    self->invariants.values(self->start, self->invariants.p, first);
    for (unsigned i = 0; i < self->count; i++) sizes[i] = first[i] != 0 ? fabs(first[i]) : 1;
    JLT_TRY(jlt_orbit_create(&orbit, method, &self->field, &to_orbit));
    jlt_orbit_observe(orbit, watch, &rest);
    JLT_TRY(jlt_orbit_start(orbit, 0, self->start, 1));
    for (size_t i = 1; i <= self->returns && !ferror(self->file); i++) {
        rest.rest = (jlt_rest_watch){ 0 };
        JLT_TRY(jlt_orbit_next(orbit, INFINITY, &section, 1, &at));
        if (at.end == JLT_END_INTERRUPT) break;
        if (at.end != JLT_END_EVENT) {
            end_by(end, &at, ldexp(at.t, self->time), i - 1);
            break;
        }
        self->invariants.values(at.x, self->invariants.p, now);
        row.returns = i;
        row.t = ldexp(at.t, self->time);
        row.evaluations = jlt_orbit_stepper(orbit)->evaluations;
        JLT_TRY(jlt_drift_note(self, method, &row, rows, count, first, sizes, now));
    }
    jlt_drift_end_row(self, method, &row, rows, count, end);
done:
    jlt_orbit_destroy(orbit);
    return st;
}

jlt_status jlt_drift_five_open(jlt_drift *self, jlt_instance **instance)
{
    const jlt_tier *five = jlt_tier_find("five");
    const jlt_top_values *v = &self->system->values;
    const double params[] = { v->m, v->R, v->g, v->a3, v->I1, v->I3 };
    const jlt_units units = jlt_chart_top_units(&self->system->chart.top);
    const jlt_descriptor *general = jlt_descriptor_find(five->model, NULL, five->time, five->elimination);
    jlt_status st = JLT_OK;

    if (general == NULL || general->param_count != sizeof params / sizeof *params) return JLT_ERR_UNSUPPORTED;
    self->time = units.time;
    JLT_TRY(lift(self->start, self->system, self->q));
    JLT_TRY(jlt_instance_create_in(instance, general, params, &units));
    JLT_TRY(jlt_field_of(&self->field, general, (*instance)->block));
    JLT_TRY(jlt_conserved_of(&self->invariants, &self->conserved, general, &self->field));
done:
    return st;
}
