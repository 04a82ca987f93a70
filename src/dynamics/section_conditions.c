#include "dynamics/section_conditions.h"

#include <math.h>

static double condition_value(void *context, const double *x)
{
    const jlt_section_conditions *self = context;
    return jlt_observed_condition_value(self->observed, self->dip.condition, x);
}

void jlt_section_conditions_turn(jlt_section_conditions *self)
{
    self->end.value = INFINITY;
    self->dip_theta = INFINITY;
}

void jlt_section_conditions_begin(jlt_section_conditions *self)
{
    self->so_far = (jlt_section_least){ INFINITY, 0 };
    jlt_section_conditions_turn(self);
}

void jlt_section_conditions_note(jlt_section_conditions *self, jlt_section_least value)
{
    const double least = self->so_far.value;

    if (isnan(value.value) ? !(least > 0) : !(value.value < least || (isnan(least) && value.value <= 0))) return;
    self->so_far = value;
}

static jlt_section_least least_at(const jlt_section_conditions *self, const double *x)
{
    jlt_section_least out = { INFINITY, 0 };

    if (self->observed != NULL) out.value = jlt_observed_least(self->observed, &out.condition, x);
    return out;
}

/* Set the dip to the first condition that is lost within the step; not if one is lost already. */
static void look_within(jlt_section_conditions *self, jlt_orbit *orbit)
{
    const unsigned count = self->observed != NULL && self->looks_within ? jlt_observed_conditions(self->observed) : 0;
    const jlt_event event = { .value = condition_value, .context = self };

    for (unsigned i = 0; !(self->so_far.value <= 0) && i < count; i++) {
        double theta;
        self->dip.condition = i;
        if (jlt_orbit_loss(orbit, &theta, &self->dip.value, &event) != JLT_OK || theta > 1) continue;
        self->dip_theta = theta;
        return;
    }
}

void jlt_section_conditions_end(jlt_section_conditions *self)
{
    if (self->dip_theta <= 1) jlt_section_conditions_note(self, self->dip);
    jlt_section_conditions_note(self, self->end);
    jlt_section_conditions_turn(self);
}

void jlt_section_conditions_step(jlt_section_conditions *self, jlt_orbit *orbit)
{
    jlt_section_conditions_end(self);
    look_within(self, orbit);
    self->end = least_at(self, jlt_orbit_stepper(orbit)->x);
}

void jlt_section_conditions_arrive(jlt_section_conditions *self, double theta, const double *x)
{
    if (self->dip_theta <= theta) jlt_section_conditions_note(self, self->dip);
    jlt_section_conditions_note(self, least_at(self, x));
}
