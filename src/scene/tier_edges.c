/* Edges of a tier's coordinates: where its table's record `tier` says so, and where an integral hardly depends on the state that is
 * eliminated by it. */
#include "scene/tier.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "kernel/descriptor.h"

static double table_room(void *context, const double *y)
{
    const jlt_tier_edge *edge = context;
    double values[JLT_TIER_EDGES_MAX];

    jlt_tier_conditions(values, edge->edges->view, edge->edges->general, y);
    return ldexp(values[edge->index], edge->exponent);
}

/* The power of two by which a condition's value changes from the table's to the tier's units, in which event search works with
 * numbers of the order of 1. Returns 0 if terms of different dimensions make it no power of two. */
static int exponent_of(const jlt_tier_edges *edges, unsigned index)
{
    const jlt_tier_view *view = edges->view;
    double y[JLT_WAY_VALUES_MAX], plain[JLT_TIER_EDGES_MAX], counted[JLT_TIER_EDGES_MAX];
    int of_plain, of_counted;

    for (unsigned i = 0; i < edges->general->state_count; i++) y[i] = 0.83 / (i + 1.7); /* an arbitrary state */
    jlt_tier_conditions(plain, view, edges->general, y);
    edges->general->tier_values(y, view->params[view->tier.way_count], counted);
    if (!isfinite(plain[index]) || !isfinite(counted[index])) return 0;
    return frexp(plain[index], &of_plain) == frexp(counted[index], &of_counted) ? of_counted - of_plain : 0;
}

/* The integral is slope*w + rest in the eliminated state w; `others` is the squared norm of its gradient in the other states. */
typedef struct {
    double slope, w, rest, others;
} linear;

static linear split(const jlt_tier_edges *edges, const double *y)
{
    const jlt_descriptor *kernel = edges->view->instance->descriptor, *full = edges->full->descriptor;
    double x[JLT_WAY_VALUES_MAX], values[JLT_WAY_VALUES_MAX], gradients[JLT_WAY_VALUES_MAX * JLT_TIER_EDGES_MAX];
    linear out = { 0 };

    jlt_tier_extract(edges->view, x, y);
    full->integral_values.call(x, edges->full->prepared, values);
    full->integral_gradients.call(x, edges->full->prepared, gradients);
    const double *gradient = gradients + (size_t)kernel->level_integral * full->state_count;
    for (unsigned i = 0; i < full->state_count; i++)
        if (i != kernel->eliminated_state) out.others += gradient[i] * gradient[i];
    out.w = x[kernel->eliminated_state];
    out.slope = gradient[kernel->eliminated_state];
    out.rest = values[kernel->level_integral] - out.slope * out.w;
    return out;
}

/* w = (level - rest)/slope has a rounding error of about u (|level| + |rest|)/|slope|. The value is negative where that exceeds
 * about 1000 u max(1, |w|), so that more than three digits are lost. Where level and rest are 0 along the orbit, w is 0 up to
 * slope = 0, where it is 0/0: the value is negative where the slope is less than 1e-12 of the others. */
static double slope_room(void *context, const double *y)
{
    const linear l = split(((const jlt_tier_edge *)context)->edges, y);
    const double level = l.slope * l.w + l.rest;

    return l.slope * l.slope * (1 + l.w * l.w) - 1e-6 * (level * level + l.rest * l.rest) - 1e-24 * l.others;
}

/* The longest step: three tenths of the time to slope = 0 by linear extrapolation, since the slope may fall faster later. */
static double slope_step(void *context, const double *y, const double *f, double direction)
{
    const jlt_tier_edges *edges = ((const jlt_tier_edge *)context)->edges;
    const unsigned n = edges->view->instance->descriptor->state_count;
    const double here = split(edges, y).slope;
    double size = 0, ahead[JLT_WAY_VALUES_MAX], h, approach;

    for (unsigned i = 0; i < n; i++) size = fmax(size, fabs(f[i]) / fmax(1, fabs(y[i])));
    if (!(size > 0)) return INFINITY;
    h = 1e-7 / size; /* the difference keeps about half of the digits */
    for (unsigned i = 0; i < n; i++) ahead[i] = y[i] + direction * h * f[i];
    approach = -(split(edges, ahead).slope - here) / h * (here < 0 ? -1 : 1);
    return approach > 0 ? 0.3 * fabs(here) / approach : INFINITY;
}

static void add(jlt_tier_edges *self, double (*value)(void *, const double *))
{
    self->contexts[self->count] = (jlt_tier_edge){ self, self->count, self->full == NULL ? exponent_of(self, self->count) : 0 };
    self->events[self->count] = (jlt_event){ .value = value, .context = &self->contexts[self->count] };
    self->count++;
}

jlt_status jlt_tier_edges_open(jlt_tier_edges *out, const jlt_tier_view *view)
{
    const jlt_tier *tier = &view->tier;

    *out = (jlt_tier_edges){ .view = view, .general = jlt_descriptor_sibling(tier->table, NULL, tier->time, NULL) };
    if (tier->elimination[0] != '\0') {
        const jlt_descriptor *asked = tier->asked;
        if (asked->integral_gradients.call == NULL || asked->integral_count > JLT_TIER_EDGES_MAX) return JLT_ERR_UNSUPPORTED;
        JLT_PASS(jlt_instance_create(&out->full, asked, view->params[0]));
        add(out, slope_room);
        out->events[0].longest_step = slope_step;
    } else if (out->general->tier_values != NULL) {
        if (out->general->tier_condition_count > JLT_TIER_EDGES_MAX) return JLT_ERR_UNSUPPORTED;
        while (out->count < out->general->tier_condition_count) add(out, table_room);
    }
    return JLT_OK;
}

void jlt_tier_edges_close(jlt_tier_edges *self)
{
    jlt_instance_destroy(self->full);
    self->full = NULL;
}

void jlt_tier_edge_text(char *text, const jlt_tier_edges *edges, unsigned index)
{
    const jlt_descriptor *kernel = edges->view->instance->descriptor, *table = edges->view->tier.table;

    if (edges->full != NULL)
        snprintf(text, JLT_TIER_TEXT_MAX, "%s hardly contains %s, and does not tell it",
                 table->integrals[kernel->level_integral].name, table->states[kernel->eliminated_state].name);
    else
        snprintf(text, JLT_TIER_TEXT_MAX, "%s does not hold, where the coordinates of the tier %s are good",
                 edges->general->tier_conditions[index].text, edges->view->tier.name);
}
