#include "scene/drift_whole.h"

#include <math.h>
#include <stdlib.h>

#include "core/memory.h"
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

/* Find the state of the asked table, a field with states x, that the way hands on as state `section` of the smaller table: the one
 * to which that state is equal at x and at other points nearby, all of whose states differ. Returns false if no state is. */
static bool find_column(unsigned *column, const jlt_way *way, unsigned section, unsigned states, const double *x,
                        const double *params)
{
    static const double shifts[] = { 0, 0x1p-10, -0x1p-9 };
    double moved[JLT_WAY_VALUES_MAX], pairs[2 * JLT_WAY_VALUES_MAX];

    for (*column = 0; *column < states && !way->is_angle[section]; ++*column) {
        bool equal = true;
        for (size_t k = 0; k < sizeof shifts / sizeof *shifts && equal; k++) {
            for (unsigned i = 0; i < states; i++) moved[i] = x[i] + shifts[k] * (1 + i) * fmax(1, fabs(x[i])) / states;
            way->coordinates(moved, params, pairs);
            equal = pairs[2 * section] == moved[*column];
        }
        if (equal) return true;
    }
    return false;
}

jlt_status jlt_drift_whole_open(jlt_drift_whole *out, const jlt_system *system, const double *q)
{
    const jlt_surface *surface = system->surface;
    const jlt_descriptor *field = jlt_descriptor_sibling(surface->asked, NULL, surface->table->time, NULL);
    const jlt_way *way;
    const jlt_claim *broken;
    double params[JLT_WAY_VALUES_MAX];
    jlt_status st = JLT_ERR_UNSUPPORTED;

    *out = (jlt_drift_whole){ .level = surface->section->level, .units = system->units };
    if (field == NULL || field->param_count > JLT_WAY_VALUES_MAX || field->state_count > JLT_WAY_VALUES_MAX) return st;
    if (surface->table->states[surface->section->column].period != 0 || !read_params(params, field, system)) return st;
    if ((way = jlt_way_to(&broken, field, surface->table, NULL, params)) == NULL) return st;
    JLT_PASS(lift(out->start, way, system, q));
    if (!find_column(&out->column, way, surface->section->column, field->state_count, out->start, params)) return st;
    out->level = ldexp(out->level, -jlt_units_exponent(&system->units, field->states[out->column].unit));
    jlt_units_count(out->start, out->start, field->states, field->state_count, &system->units);
    field = jlt_descriptor_choose(field, field->time, NULL, params);
    if (!field->scales && !jlt_units_is_table(&system->units)) return JLT_ERR_UNSUPPORTED;
    JLT_TRY(jlt_instance_create(&out->told, field, params));
    JLT_TRY(jlt_instance_create_in(&out->instance, field, params, &system->units));
    JLT_TRY(jlt_field_of(&out->field, out->instance));
done:
    if (st != JLT_OK) jlt_drift_whole_close(out);
    return st;
}

jlt_status jlt_drift_whole_project(jlt_drift_whole *self)
{
    return jlt_conserved_of(&self->kept, &self->conserved, self->instance);
}

void jlt_drift_whole_close(jlt_drift_whole *self)
{
    jlt_instance_destroy(self->instance);
    jlt_instance_destroy(self->told);
    self->instance = self->told = NULL;
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

/* The state in the table's units. */
static void restore(double *x, const jlt_drift_whole *whole, const double *counted)
{
    const jlt_descriptor *field = whole->told->descriptor;

    jlt_units_restore(x, counted, field->states, field->state_count, &whole->units);
}

/* The fate of an orbit that ends with this outcome, other than a crossing of the section. */
static jlt_fate fate_of(const jlt_drift_whole *whole, const jlt_outcome *at)
{
    double x[JLT_WAY_VALUES_MAX];
    unsigned state;

    if (at->end == JLT_END_OBSERVER) return JLT_FATE_EQUILIBRIUM;
    restore(x, whole, at->x);
    return jlt_section_fate_at_pole(jlt_descriptor_pole_side(&state, whole->told->descriptor, x));
}

static void end_by(jlt_drift_end *end, const jlt_drift_whole *whole, jlt_fate fate, double t, size_t returns)
{
    jlt_section_fate_text(end->name, NULL, fate, JLT_OBSERVED_ANY);
    end->t = ldexp(t, whole->units.time);
    end->returns = returns;
}

jlt_status jlt_drift_whole_follow(jlt_drift *self, jlt_drift_end *end, const jlt_method *method, const jlt_drift_whole *whole)
{
    const jlt_flow *flow = &self->system->flow;
    const jlt_descriptor *field = whole->told->descriptor;
    const jlt_event section = { .column = whole->column, .level = whole->level, .direction = flow->direction };
    const jlt_options to_orbit = { .tolerance = flow->tolerance, .interrupt = flow->interrupt,
                                   .max_steps = flow->max_steps != 0 ? flow->max_steps : 100000, /* as on sections */
                                   .invariants = whole->kept, .project = whole->kept.count > 0 };
    rest_watch rest;
    double x[JLT_WAY_VALUES_MAX];
    JLT_FREED double *now = malloc(field->integral_count * sizeof *now);
    JLT_OWNED(jlt_orbit) *orbit = NULL;
    jlt_outcome at = { .t = 0 };
    jlt_fate fate = JLT_FATE_ALIVE;

    if (now == NULL) return JLT_ERR_NOMEM;
    jlt_drift_begin(self, end);
    restore(x, whole, whole->start);
    JLT_PASS(jlt_drift_first(self, whole->told, x));
    JLT_PASS(jlt_orbit_create(&orbit, method, &whole->field, &to_orbit));
    jlt_orbit_observe(orbit, watch, &rest);
    JLT_PASS(jlt_orbit_start(orbit, 0, whole->start, 1));
    for (size_t i = 1; i <= self->returns && !self->stopped; i++) {
        rest.rest = (jlt_rest_watch){ 0 };
        const jlt_status st = jlt_orbit_next(orbit, INFINITY, &section, 1, &at);
        if (st != JLT_OK && (!jlt_section_fate_of(&fate, st) || jlt_section_failed(fate))) return st;
        if (st == JLT_OK && at.end == JLT_END_INTERRUPT) break;
        if (st != JLT_OK || at.end != JLT_END_EVENT) {
            end_by(end, whole, st != JLT_OK ? fate : fate_of(whole, &at), at.t, i - 1);
            break;
        }
        restore(x, whole, at.x);
        field->integral_values.call(x, whole->told->prepared, now);
        JLT_PASS(jlt_drift_note(self, i, ldexp(at.t, whole->units.time), jlt_orbit_stepper(orbit)->evaluations, now));
    }
    jlt_drift_finish(self, end);
    return JLT_OK;
}
