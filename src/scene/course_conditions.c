#include "scene/course_conditions.h"

#include <math.h>

jlt_status jlt_course_conditions_open(jlt_course_conditions *out, const jlt_descriptor *model, const double *params,
                                      const jlt_units *units)
{
    *out = (jlt_course_conditions){ .least = INFINITY, .lost_at = NAN, .unknown_at = NAN };
    return jlt_observed_create(&out->observed, model, params, units);
}

void jlt_course_conditions_close(jlt_course_conditions *self)
{
    jlt_observed_destroy(self->observed);
    self->observed = NULL;
}

bool jlt_course_conditions_note(jlt_course_conditions *self, const char **unknown, double t, const double *x)
{
    unsigned condition = 0;
    const double value = jlt_observed_least(self->observed, &condition, x);

    *unknown = jlt_observed_condition(self->observed, condition);
    if (value < self->least) self->least = value;
    if (value <= 0 && isnan(self->lost_at)) {
        self->lost_at = t;
        self->lost = jlt_observed_condition(self->observed, condition);
    }
    return isnan(value);
}

typedef struct {
    const jlt_course_conditions *conditions;
    const jlt_leg *leg;
    unsigned index;
} watched;

static double value_of(void *context, const double *y)
{
    const watched *self = context;
    double x[JLT_WAY_VALUES_MAX];

    jlt_tier_extract(&self->leg->view, x, y);
    return jlt_observed_condition_value(self->conditions->observed, self->index, x);
}

void jlt_course_conditions_look_within(jlt_course_conditions *self, const jlt_leg *leg)
{
    const jlt_stepper *stepper = jlt_orbit_stepper(leg->orbit);
    const unsigned dim = stepper->field->dim;
    double y[JLT_WAY_VALUES_MAX + 1];

    for (unsigned i = 0; isnan(self->lost_at) && i < jlt_observed_conditions(self->observed); i++) {
        watched one = { self, leg, i };
        double theta, least;
        const jlt_event event = { .value = value_of, .context = &one };
        if (jlt_orbit_loss(leg->orbit, &theta, &least, &event) != JLT_OK || theta > 1) continue;
        jlt_stepper_values(stepper, theta, y);
        self->least = fmin(self->least, least);
        self->lost_at = jlt_leg_time(leg, stepper->columns > dim ? y[dim] : stepper->tau_start + theta * stepper->h);
        self->lost = jlt_observed_condition(self->observed, i);
    }
}
