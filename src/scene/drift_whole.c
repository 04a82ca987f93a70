#include "scene/drift_whole.h"

#include <math.h>
#include <string.h>

#include "dynamics/section.h"
#include "dynamics/surface.h"
#include "integrate/orbit.h"
#include "integrate/rest.h"
#include "kernel/descriptor.h"

/* Read the asked table's parameters from the values of the section. Returns false if one is not among them. */
static bool read_params(double *params, const jlt_descriptor *asked, const jlt_system *system)
{
    for (unsigned i = 0; i < asked->param_count; i++) {
        const unsigned value = jlt_surface_value(system->surface, asked->params[i].name);
        if (value == system->surface->count) return false;
        params[i] = system->values[value];
    }
    return true;
}

/* The asked model's states at a point of the section, in the table's units. */
static jlt_status lift(double *x, const jlt_way *way, const jlt_system *system, const double *q)
{
    const jlt_surface *surface = system->surface;
    const jlt_chart_section *chart = jlt_surface_chart(system);
    double on_level[JLT_CHART_STATES_MAX], values[JLT_CHART_VALUES_MAX];

    JLT_PASS(chart->base.lift(&chart->base, on_level, NULL, q));
    jlt_surface_arrange(values, surface, system->values);
    way->back(on_level, values, x);
    return JLT_OK;
}

static bool find_integrals(jlt_drift_whole *out, const jlt_descriptor *field, const jlt_surface *surface)
{
    for (unsigned k = surface->params; k < surface->count; k++) {
        unsigned i = 0;
        while (i < field->integral_count && strcmp(field->integrals[i].name, surface->names[k]) != 0) i++;
        if (i == field->integral_count || k - surface->params == JLT_INVARIANTS_MAX) return false;
        out->watched[k - surface->params] = i;
    }
    return true;
}

jlt_status jlt_drift_whole_open(jlt_drift_whole *out, const jlt_system *system, const double *q)
{
    const jlt_surface *surface = system->surface;
    const jlt_descriptor *field = jlt_descriptor_sibling(surface->asked, NULL, surface->table->time, NULL);
    const jlt_way *way;
    const jlt_claim *broken;
    double told[JLT_WAY_VALUES_MAX];
    size_t column;
    jlt_status st = JLT_ERR_UNSUPPORTED;

    *out = (jlt_drift_whole){ .level = surface->section->level, .time = system->units.time };
    if (field == NULL || field->param_count > JLT_WAY_VALUES_MAX || field->state_count > JLT_WAY_VALUES_MAX) return st;
    if (!jlt_descriptor_state(field, surface->table->states[surface->section->column].name, &column)) return st;
    if (!find_integrals(out, field, surface) || !read_params(told, field, system)) return st;
    if ((way = jlt_way_to(&broken, field, surface->table, NULL, told)) == NULL) return st;
    out->column = (unsigned)column;
    JLT_TRY(lift(out->start, way, system, q));
    out->level = ldexp(out->level, -jlt_units_exponent(&system->units, field->states[column].unit));
    jlt_units_count(out->start, out->start, field->states, field->state_count, &system->units);
    JLT_TRY(jlt_instance_create_in(&out->instance, field, told, &system->units));
    JLT_TRY(jlt_field_of(&out->field, out->instance));
    JLT_TRY(jlt_conserved_of(&out->invariants, &out->conserved, out->instance));
done:
    if (st != JLT_OK) jlt_drift_whole_close(out);
    return st;
}

void jlt_drift_whole_close(jlt_drift_whole *self)
{
    jlt_instance_destroy(self->instance);
    self->instance = NULL;
}

/* Context of an observer that ends the orbit when it comes to rest, at `limit`. */
typedef struct {
    jlt_rest_watch rest;
    double limit[JLT_WAY_VALUES_MAX];
} rest_watch;

static int watch(void *context, jlt_orbit *orbit)
{
    rest_watch *self = context;
    return jlt_rest_watch_step(&self->rest, jlt_orbit_stepper(orbit), self->limit);
}

static void end_by(jlt_drift_end *end, const jlt_drift_whole *whole, const jlt_outcome *at, double t, size_t returns)
{
    const jlt_descriptor *field = whole->instance->descriptor;
    const unsigned pole = field->pole_count > 0 ? field->poles[0].state : 0;
    const jlt_quantity *q = &whole->instance->states[pole];
    const jlt_fate fate = at->end == JLT_END_OBSERVER                 ? JLT_FATE_EQUILIBRIUM
                          : at->x[pole] - q->low > q->high - at->x[pole] ? JLT_FATE_POLE_PLUS
                                                                      : JLT_FATE_POLE_MINUS;

    jlt_section_fate_text(end->name, NULL, fate, JLT_OBSERVED_ANY);
    end->t = t;
    end->returns = returns;
}

jlt_status jlt_drift_whole_follow(jlt_drift *self, jlt_drift_end *end, const jlt_method *method, const jlt_drift_whole *whole,
                                  bool project)
{
    const jlt_flow *flow = &self->system->flow;
    const jlt_event section = { .column = whole->column, .level = whole->level, .direction = flow->direction };
    const jlt_invariants none = { .count = 0 };
    const jlt_options to_orbit = { .tolerance = flow->tolerance, .interrupt = flow->interrupt,
                                   .max_steps = 100000, /* for each return, as on sections */
                                   .invariants = project ? whole->invariants : none, /* else they are evaluated at returns only */
                                   .project = project };
    rest_watch rest;
    double now[JLT_INVARIANTS_MAX];
    JLT_OWNED(jlt_orbit) *orbit = NULL;
    jlt_outcome at = { .t = 0 };

    jlt_drift_begin(self, end);
    whole->invariants.values(whole->start, whole->invariants.p, now);
    for (unsigned k = 0; k < self->count; k++) {
        self->first[k] = now[self->watched[k]];
        self->sizes[k] = self->first[k] != 0 ? fabs(self->first[k]) : 1;
    }
    JLT_PASS(jlt_orbit_create(&orbit, method, &whole->field, &to_orbit));
    jlt_orbit_observe(orbit, watch, &rest);
    JLT_PASS(jlt_orbit_start(orbit, 0, whole->start, 1));
    for (size_t i = 1; i <= self->returns && !self->stopped; i++) {
        rest.rest = (jlt_rest_watch){ 0 };
        JLT_PASS(jlt_orbit_next(orbit, INFINITY, &section, 1, &at));
        if (at.end == JLT_END_INTERRUPT) break;
        if (at.end != JLT_END_EVENT) {
            end_by(end, whole, &at, ldexp(at.t, whole->time), i - 1);
            break;
        }
        whole->invariants.values(at.x, whole->invariants.p, now);
        JLT_PASS(jlt_drift_note(self, i, ldexp(at.t, whole->time), jlt_orbit_stepper(orbit)->evaluations, now));
    }
    jlt_drift_finish(self, end);
    return JLT_OK;
}
