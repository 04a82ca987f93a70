#include "scene/course_drift.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/memory.h"

static void integrals(const jlt_course_drift *self, double *values, const double *x)
{
    if (self->count > 0) self->watch->descriptor->integral_values.call(x, self->watch->prepared, values);
}

static double largest(const double *x, unsigned count)
{
    double size = 0;

    for (unsigned j = 0; j < count; j++) size = fmax(size, fabs(x[j]));
    return size;
}

jlt_status jlt_course_drift_begin(jlt_course_drift *out, const jlt_instance *watch, const double *x)
{
    const jlt_descriptor *d = watch->descriptor;
    const unsigned count = d->integral_values.call == NULL ? 0 : (unsigned)d->integral_count, states = (unsigned)d->state_count;
    JLT_FREED double *slopes = jlt_memory_array(count + 1, states * sizeof *slopes);

    if (slopes == NULL) return JLT_ERR_NOMEM;
    *out = (jlt_course_drift){ .watch = watch, .count = count };
    integrals(out, out->first, x);
    const bool known = d->integral_gradients.call != NULL && jlt_instance_gradients(watch, slopes, x) == JLT_OK;
    for (unsigned i = 0; i < out->count; i++) {
        double change = 0;
        for (unsigned j = 0; known && j < states; j++) change += fabs(slopes[i * states + j]);
        change *= largest(x, states);
        out->size[i] = fmax(fabs(out->first[i]), change > 0 ? fmin(1, change) : 1);
    }
    return JLT_OK;
}

void jlt_course_drift_note(jlt_course_drift *self, const double *x)
{
    double now[JLT_PLAN_STATES_MAX];

    integrals(self, now, x);
    for (unsigned i = 0; i < self->count; i++) self->value[i] = fabs(now[i] - self->first[i]) / self->size[i];
}

bool jlt_course_drift_tells(char *text, const jlt_course_drift *self, const char *tier, const jlt_orbit *orbit, double tolerance)
{
    const double one = tolerance > 0 ? tolerance : JLT_ORBIT_TOLERANCE;
    const double most = (100 + sqrt((double)jlt_orbit_stepper(orbit)->steps)) * one;
    unsigned i = 0;

    while (i < self->count && !(self->value[i] > most)) i++;
    if (i == self->count) return false;
    snprintf(text, JLT_TIER_TEXT_MAX, "%s, which stays the same, changes by %.2g of its size in the tier %s",
             self->watch->descriptor->integrals[i].name, self->value[i], tier);
    return true;
}

bool jlt_course_drift_is_less(const jlt_course_drift *self, jlt_leg *leg, double t)
{
    jlt_course_drift other = *self;
    double x[JLT_PLAN_STATES_MAX];
    jlt_outcome outcome;
    unsigned edge;

    if (jlt_leg_to(leg, t, &outcome, &edge) != JLT_OK || outcome.end != JLT_END_TIME) return false;
    jlt_tier_extract(&leg->view, x, leg->y);
    jlt_course_drift_note(&other, x);
    return largest(other.value, other.count) < largest(self->value, self->count) / 10;
}
