#include "scene/course_conditions.h"

#include <math.h>

jlt_status jlt_course_conditions_open(jlt_course_conditions *out, const jlt_descriptor *model, const double *params,
                                      const jlt_units *units)
{
    jlt_course_conditions_again(out);
    return jlt_observed_create(&out->observed, model, params, units);
}

void jlt_course_conditions_again(jlt_course_conditions *self)
{
    *self = (jlt_course_conditions){ .observed = self->observed, .least = INFINITY, .lost_at = NAN, .unknown_at = NAN };
}

void jlt_course_conditions_close(jlt_course_conditions *self)
{
    jlt_observed_destroy(self->observed);
    self->observed = NULL;
}

/* Steps may end beyond the time of a row, so what was noted at their ends may lie after the row. */
bool jlt_course_conditions_by(double noted, double t) { return fabs(noted) <= fabs(t); }

bool jlt_course_conditions_note(jlt_course_conditions *self, const char **unknown, double t, const double *x)
{
    unsigned condition = 0;
    const double value = jlt_observed_least(self->observed, &condition, x);

    *unknown = jlt_observed_condition(self->observed, condition);
    if (value < self->least) self->least = value;
    if (value <= 0 && !jlt_course_conditions_by(self->lost_at, t)) {
        self->lost_at = t;
        self->lost = jlt_observed_condition(self->observed, condition);
    }
    return isnan(value);
}

void jlt_course_conditions_stop(jlt_course_conditions *self, double t)
{
    if (!isnan(self->lost_at) || !isnan(self->unknown_at)) return;
    self->unwatched = true;
    self->unknown_at = t;
    self->unknown = jlt_observed_condition(self->observed, JLT_OBSERVED_ANY);
}

typedef struct {
    jlt_observed_one condition;
    const jlt_leg *leg;
} watched;

static double value_of(void *context, const double *y)
{
    watched *self = context;
    double x[JLT_WAY_VALUES_MAX];

    jlt_tier_extract(&self->leg->view, x, y);
    return jlt_observed_condition_value(&self->condition, x);
}

/* Where in the last step, as a fraction of it, a condition breaks first; INFINITY: nowhere, or it was broken at the start. *least:
 * its least value in a step in which it is broken. */
static double break_within(jlt_event_least *least, watched *one, const jlt_stepper *stepper)
{
    const jlt_event event = { .value = value_of, .context = one };
    const bool ends_broken = value_of(one, stepper->x) <= 0, starts_broken = !(value_of(one, stepper->x_start) > 0);
    double theta;

    if (!ends_broken && !starts_broken)
        return jlt_orbit_loss(one->leg->orbit, &theta, least, &event) == JLT_OK ? theta : INFINITY;
    *least = jlt_orbit_least(one->leg->orbit, &event);
    if (starts_broken) return INFINITY;
    jlt_event_least from_there;
    return jlt_orbit_loss(one->leg->orbit, &theta, &from_there, &event) == JLT_OK && theta < 1 ? theta : 1;
}

static double on_polynomial(watched *one, const jlt_stepper *stepper, double theta)
{
    double y[JLT_WAY_VALUES_MAX + 1];

    jlt_stepper_values(stepper, theta, y);
    return value_of(one, y);
}

/* The polynomial of a long step errs by more than the step: Newton's method on states of partial steps, with its slopes. */
static double refined(watched *one, const jlt_stepper *stepper, double theta)
{
    const jlt_event event = { .value = value_of, .context = one };
    const double low = fmax(theta - 0x1p-12, 0), high = fmin(theta + 0x1p-12, 1);
    const double slope = (on_polynomial(one, stepper, high) - on_polynomial(one, stepper, low)) / (high - low);
    double value;

    for (int k = 0; k < 2; k++) {
        if (jlt_orbit_value(one->leg->orbit, &value, &event, theta) != JLT_OK) break;
        if (!(fabs(value) <= 0x1p-12 * fabs(slope))) break; /* near a pole, or at a turning point */
        theta = fmin(fmax(theta - value / slope, 0), 1);
    }
    return theta;
}

void jlt_course_conditions_look_within(jlt_course_conditions *self, const jlt_leg *leg)
{
    const jlt_stepper *stepper = jlt_orbit_stepper(leg->orbit);
    const unsigned dim = stepper->field->dim;
    double y[JLT_WAY_VALUES_MAX + 1], first = INFINITY;

    for (unsigned i = 0; i < jlt_observed_conditions(self->observed); i++) {
        watched one = { { self->observed, i }, leg };
        jlt_event_least least = { .value = INFINITY };
        const double theta = break_within(&least, &one, stepper);
        self->least = fmin(self->least, least.value);
        if (theta >= first || theta >= 1 || !isnan(self->lost_at)) continue;
        first = refined(&one, stepper, theta);
        self->lost = jlt_observed_condition(self->observed, i);
    }
    if (first >= 1) return;
    jlt_stepper_values(stepper, first, y);
    self->lost_at = jlt_leg_time(leg, stepper->columns > dim ? y[dim] : stepper->tau_start + first * stepper->h);
}
