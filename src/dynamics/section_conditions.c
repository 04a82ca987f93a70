#include "dynamics/section_conditions.h"

#include <math.h>

#include "integrate/locate.h"

static const double told = 0x1p-20; /* part of a condition by which it must fall within a step: errors within it are less */

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

typedef struct {
    jlt_observed_one one;
    double bound;
} above;

/* How far a condition, an `above`, is above its bound. */
static double above_value(void *context, const double *x)
{
    above *self = context;

    return jlt_observed_condition_value(&self->one, x) - self->bound;
}

static void above_values(void *context, double *out, const double *x)
{
    above *self = context;

    jlt_observed_condition_values(&self->one, out, x);
    for (unsigned k = 0; k < JLT_STEPPER_NODES; k++) out[k] -= self->bound;
}

/* Whether a condition falls below the bound within the last step and rises again before its end; *least: where it is least. hold:
 * all conditions are above the bound at both ends of the step; if false, this one is examined there. */
static bool dips(jlt_event_least *least, jlt_orbit *orbit, const jlt_event *event, bool hold)
{
    const jlt_stepper *stepper = jlt_orbit_stepper(orbit);
    double theta;

    if (hold || (jlt_locate_value(event, stepper->x_start) > 0 && jlt_locate_value(event, stepper->x) > 0))
        return jlt_orbit_loss(orbit, &theta, least, event) == JLT_OK && theta <= 1;
    if (!(stepper->h * jlt_locate_slope(event, stepper, stepper->x_start, stepper->f_start) < 0)
        || !(stepper->h * jlt_locate_slope(event, stepper, stepper->x, stepper->f) > 0))
        return false;
    *least = jlt_orbit_least(orbit, event);
    return least->value <= 0;
}

/* Set the dip to the least value of a condition that goes below the bound within the step, if that is less than was met before. */
static void look_within(jlt_section_conditions *self, jlt_orbit *orbit, double bound, bool hold)
{
    const unsigned count = self->looks_within ? jlt_observed_conditions(self->observed) : 0;
    above of = { .one = { self->observed, 0 }, .bound = bound };
    const jlt_event event = { .value = above_value, .values = above_values, .context = &of };
    double before = self->so_far.value;

    for (; of.one.index < count; of.one.index++) {
        jlt_event_least least;
        double value = NAN;
        if (!dips(&least, orbit, &event, hold)) continue;
        if (self->seeks_least && jlt_orbit_value(orbit, &value, &event, least.theta) != JLT_OK) continue;
        /* Without the polynomial's error the state may be on the other side of a pole. */
        if (value < jlt_locate_value(&event, jlt_orbit_stepper(orbit)->x)) least.value = value;
        if (least.value + bound >= before) continue;
        before = least.value + bound;
        self->dip = (jlt_section_least){ before, of.one.index };
        self->dip_theta = least.theta;
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
    const jlt_section_least end = least_at(self, jlt_orbit_stepper(orbit)->x);
    const jlt_section_least start = self->end;

    jlt_section_conditions_end(self);
    const double least = self->so_far.value, bound = self->seeks_least && least > 0 && isfinite(least) ? least - told * least : 0;
    look_within(self, orbit, bound, isfinite(start.value) && start.value > bound && end.value > bound);
    self->end = end;
}

void jlt_section_conditions_arrive(jlt_section_conditions *self, double theta, const double *x)
{
    if (self->dip_theta <= theta) jlt_section_conditions_note(self, self->dip);
    jlt_section_conditions_note(self, least_at(self, x));
}
