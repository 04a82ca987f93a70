#include "scene/leg.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "integrate/edge.h"
#include "kernel/descriptor.h"

/* The sign between the orbit's time and the asked model's: the image by a reversor runs backwards. */
static int sense(const jlt_leg *self) { return self->view.mirror != NULL ? -1 : 1; }

double jlt_leg_time(const jlt_leg *self, double t) { return sense(self) * t; }

jlt_status jlt_leg_open(jlt_leg *out, char *refusal, const jlt_tier *tier, const double *params, const double *x, double t,
                        int direction, const jlt_method *method, const jlt_options *to_orbit)
{
    jlt_options options = *to_orbit;
    jlt_status st = JLT_OK;

    *out = (jlt_leg){ .t = t, .direction = direction };
    JLT_TRY(jlt_tier_open(&out->view, out->y, refusal, tier, params, x));
    JLT_TRY(jlt_tier_edges_open(&out->edges, &out->view));
    JLT_TRY(jlt_field_of(&out->field, out->view.instance));
    options.t_last *= sense(out);
    if (options.project) JLT_TRY(jlt_conserved_of(&options.invariants, &out->conserved, out->view.instance));
    JLT_TRY(jlt_orbit_create(&out->orbit, method, &out->field, &options));
done:
    if (st != JLT_OK) jlt_leg_close(out);
    return st;
}

void jlt_leg_close(jlt_leg *self)
{
    jlt_orbit_destroy(self->orbit);
    jlt_tier_edges_close(&self->edges);
    jlt_tier_close(&self->view);
    *self = (jlt_leg){ .t = 0 };
}

static double end_of(const jlt_quantity *intervals, const jlt_edge_part *end)
{
    return end->is_lost ? 0 : end->is_upper ? intervals[end->index].high : intervals[end->index].low;
}

/* Whether the rate of a state is 0 at this end of its interval, the other states as they are. */
static bool rests_at(const jlt_leg *self, const jlt_edge_part *end)
{
    double x[JLT_WAY_VALUES_MAX], f[JLT_WAY_VALUES_MAX];

    memcpy(x, jlt_orbit_stepper(self->orbit)->x, self->field.dim * sizeof *x);
    x[end->index] = end_of(self->field.domain.intervals, end);
    self->field.call(x, self->field.p, f);
    return f[end->index] == 0;
}

/* Whether a state of the asked model is within 1e-4 of its interval's length from a proved pole. */
static bool is_near_pole(const jlt_leg *self)
{
    const jlt_tier *tier = &self->view.tier;
    const jlt_descriptor *model = tier->asked;
    double states[JLT_WAY_VALUES_MAX];

    jlt_tier_extract(&self->view, states, self->y);
    for (unsigned i = 0; i < model->pole_count; i++) {
        const jlt_quantity *q = &model->states[model->poles[i].state];
        if (!jlt_descriptor_proves(model, "pole", q->name)) continue;
        const double x = ldexp(states[model->poles[i].state], jlt_units_exponent(&tier->units, q->unit));
        if (fmin(x - q->low, q->high - x) < 1e-4 * (q->high - q->low)) return true;
    }
    return false;
}

void jlt_leg_end_text(char *text, const jlt_leg *self, unsigned edge)
{
    const jlt_descriptor *kernel = self->view.instance->descriptor;
    jlt_edge_part part;

    if (self->field.time_rate == NULL && is_near_pole(self)) {
        snprintf(text, JLT_TIER_TEXT_MAX, "the orbit is so near a pole that in plain time nothing is left of its digits");
        return;
    }
    if (edge < self->edges.count) {
        jlt_tier_edge_text(text, &self->edges, edge);
        return;
    }
    const int used = snprintf(text, JLT_TIER_TEXT_MAX, "the orbit comes to the edge of the domain of %s", kernel->model);
    if (used < 0 || used >= JLT_TIER_TEXT_MAX || !jlt_edge_ahead(&part, jlt_orbit_stepper(self->orbit))) return;
    const size_t left = JLT_TIER_TEXT_MAX - (size_t)used;
    if (part.is_condition) {
        snprintf(text + used, left, ": %s needs %s", kernel->domains[part.index].name, kernel->domains[part.index].text);
        return;
    }
    const char *name = kernel->states[part.index].name;
    if (part.is_lost && !jlt_field_keeps(&self->field, part.index)) {
        snprintf(text + used, left, ": %s and what is 0 with it were so near 0 that nothing is left of their digits; to go on, "
                 "take the logarithm of their size, and their ratios, as states", name);
        return;
    }
    const double end = end_of(kernel->states, &part);
    const int told = snprintf(text + used, left, ": %s is at the end %.10g of its interval", name, end);
    if (rests_at(self, &part) && told >= 0 && (size_t)told < left)
        snprintf(text + used + told, left - (size_t)told, ", as near as digits tell: it may never come there, as its rate is 0 at "
                 "that end; to go on, take %s as the state", end == 0 ? "the logarithm of its size" : "the distance from it");
}

const char *jlt_leg_unbounded(const jlt_leg *self, double t)
{
    const unsigned state = jlt_field_unbounded(&self->field, self->y, t);

    return state < self->field.dim ? self->view.instance->descriptor->states[state].name : NULL;
}

jlt_status jlt_leg_to(jlt_leg *self, double t, jlt_outcome *outcome, unsigned *edge)
{
    jlt_tier_edges *edges = &self->edges;

    *outcome = (jlt_outcome){ .end = JLT_END_TIME };
    *edge = edges->count;
    if (!self->started) {
        self->started = true;
        if (self->direction == 0) self->direction = t < self->t ? -1 : 1;
        for (unsigned i = 0; i < edges->count; i++)
            if (!(edges->events[i].value(edges->events[i].context, self->y) > 0)) {
                *outcome = (jlt_outcome){ .end = JLT_END_TIME, .t = sense(self) * self->t, .x = self->y };
                *edge = i;
                return JLT_ERR_DOMAIN;
            }
        JLT_PASS(jlt_orbit_start(self->orbit, sense(self) * self->t, self->y, self->direction * sense(self)));
    }
    const jlt_status st = jlt_orbit_next(self->orbit, sense(self) * t, edges->events, edges->count, outcome);
    if (outcome->x != NULL) memcpy(self->y, outcome->x, self->field.dim * sizeof *self->y);
    if (st != JLT_OK || outcome->end != JLT_END_EVENT) return st;
    *edge = outcome->crossing.event;
    outcome->end = JLT_END_TIME;
    return JLT_ERR_DOMAIN;
}
