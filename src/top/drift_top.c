#include "top/drift_top.h"

#include <math.h>
#include <string.h>

#include "dynamics/surface.h"
#include "integrate/rest.h"
#include "kernel/descriptor.h"
#include "top/level.h"
#include "top/tier.h"

_Static_assert((int)JLT_DRIFT_TOP_STATES == JLT_TOP_STATES + 1, "the five states and s");

/* The start on the section as the tier five has it, in the table's units. */
static jlt_status lift(double *x, const jlt_top *top, double G, const jlt_chart *chart, const double *q)
{
    double level[JLT_LEVEL_STATES];
    const jlt_status st = chart->states == JLT_LEVEL_STATES ? chart->lift(chart, level, NULL, q) : JLT_ERR_UNSUPPORTED;

    if (st != JLT_OK) return st;
    memcpy(x, level, 3 * sizeof *x);
    jlt_level_rotation(top, G, &x[JLT_TOP_OMEGA_N], &x[JLT_TOP_OMEGA3], level);
    x[JLT_TOP_STATES] = level[JLT_LEVEL_S];
    return JLT_OK;
}

jlt_status jlt_drift_top_open(jlt_drift_top *out, const jlt_system *system, const double *q)
{
    const jlt_tier *five = jlt_tier_find("five");
    const jlt_descriptor *general = jlt_descriptor_find(five->model, NULL, five->time, five->elimination);
    const unsigned level = jlt_surface_value(system->surface, "G");
    double params[JLT_CHART_VALUES_MAX];
    jlt_top top;
    jlt_status st = JLT_ERR_UNSUPPORTED;

    *out = (jlt_drift_top){ .column = JLT_TOP_OMEGA_TAU, .time = system->units.time };
    if (general == NULL || general->param_count > JLT_CHART_VALUES_MAX || level == system->surface->count) return st;
    for (unsigned i = 0; i < general->param_count; i++) {
        const unsigned value = jlt_surface_value(system->surface, general->params[i].name);
        if (value == system->surface->count) return st;
        params[i] = system->values[value];
    }
    JLT_TRY(jlt_top_read(&top, general, params));
    JLT_TRY(lift(out->start, &top, system->values[level], &jlt_surface_chart(system)->base, q));
    jlt_units_count(out->start, out->start, general->states, general->state_count, &system->units);
    JLT_TRY(jlt_instance_create_in(&out->instance, general, params, &system->units));
    JLT_TRY(jlt_field_of(&out->field, general, out->instance->block));
    JLT_TRY(jlt_conserved_of(&out->invariants, &out->conserved, general, &out->field));
done:
    return st;
}

void jlt_drift_top_close(jlt_drift_top *self)
{
    jlt_instance_destroy(self->instance);
    self->instance = NULL;
}

/* Whether the orbit comes to rest, and where. */
typedef struct {
    jlt_rest_watch rest;
    double limit[JLT_DRIFT_TOP_STATES];
} rest_watch;

static int watch(void *context, jlt_orbit *orbit)
{
    rest_watch *self = context;
    return jlt_rest_watch_step(&self->rest, jlt_orbit_stepper(orbit), self->limit);
}

static void end_by(jlt_drift_end *end, const jlt_outcome *at, double t, size_t returns)
{
    const jlt_fate fate = at->end == JLT_END_OBSERVER ? JLT_FATE_EQUILIBRIUM
                          : at->x[JLT_TOP_GAMMA3] > 0 ? JLT_FATE_POLE_PLUS
                                                      : JLT_FATE_POLE_MINUS;

    jlt_section_fate_text(end->name, NULL, fate, JLT_OBSERVED_ANY);
    end->t = t;
    end->returns = returns;
}

jlt_status jlt_drift_top_follow(jlt_drift *self, jlt_drift_end *end, const jlt_method *method, const jlt_drift_top *five,
                                bool project)
{
    const jlt_flow *flow = &self->system->flow;
    const jlt_event section = { .column = five->column, .direction = flow->direction };
    const jlt_options to_orbit = { .tolerance = flow->tolerance, .interrupt = flow->interrupt,
                                   .max_steps = 100000, /* of one return, as on sections */
                                   .invariants = five->invariants, .project = project };
    rest_watch rest;
    double now[JLT_INVARIANTS_MAX];
    jlt_orbit *orbit = NULL;
    jlt_outcome at = { .t = 0 };
    jlt_status st = JLT_OK;

    jlt_drift_begin(self, end);
    five->invariants.values(five->start, five->invariants.p, now);
    for (unsigned k = 0; k < self->count; k++) {
        self->first[k] = now[self->watched[k]];
        self->sizes[k] = self->first[k] != 0 ? fabs(self->first[k]) : 1;
    }
    JLT_TRY(jlt_orbit_create(&orbit, method, &five->field, &to_orbit));
    jlt_orbit_observe(orbit, watch, &rest);
    JLT_TRY(jlt_orbit_start(orbit, 0, five->start, 1));
    for (size_t i = 1; i <= self->returns && !self->stopped; i++) {
        rest.rest = (jlt_rest_watch){ 0 };
        JLT_TRY(jlt_orbit_next(orbit, INFINITY, &section, 1, &at));
        if (at.end == JLT_END_INTERRUPT) break;
        if (at.end != JLT_END_EVENT) {
            end_by(end, &at, ldexp(at.t, five->time), i - 1);
            break;
        }
        five->invariants.values(at.x, five->invariants.p, now);
        JLT_TRY(jlt_drift_note(self, i, ldexp(at.t, five->time), jlt_orbit_stepper(orbit)->evaluations, now));
    }
    jlt_drift_finish(self, end);
done:
    jlt_orbit_destroy(orbit);
    return st;
}
