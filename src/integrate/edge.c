#include "integrate/edge.h"

#include <math.h>

#include "integrate/loss.h"
#include "integrate/step_control.h"

enum { SAMPLES = 16, BISECTIONS = 60 };
static const double ahead = 1e-8; /* part of |tau|: half of its digits */

/* The distance of x from the place where it counts as being at an end of its interval, which may be infinite: just inside that end.
 * side: +1 for the lower end, -1 for the upper one. */
static double margin(double x, double end, double side)
{
    return isfinite(end) ? side * (x - end) - JLT_FIELD_NEAREST * fabs(end) : INFINITY;
}

static bool is_kept_from(const jlt_field *field, unsigned state, double end)
{
    return end == 0 && jlt_field_keeps(field, state);
}

/* The level that counts as this end of the interval. A kept state may come as near to 0 as it likes, but below the least scale it
 * is only errors, which may change its sign: there the level is beyond 0 by that scale. */
static double end_of(const jlt_field *field, unsigned state, double end, double side)
{
    return is_kept_from(field, state, end) ? -side * JLT_STEPPER_SCALE_LEAST : end;
}

/* This state's interval; the whole line where intervals are not watched. */
static const jlt_quantity *interval_of(const jlt_domain *domain, unsigned state)
{
    static const jlt_quantity whole = { .low = -INFINITY, .high = INFINITY };

    return domain->intervals != NULL ? &domain->intervals[state] : &whole;
}

/* Whether this state is lost (edge.h), and `end` is the 0 that it was kept from, or either end of an interval with 0 inside. */
static bool is_lost_at(const jlt_stepper *stepper, unsigned state, double end)
{
    if (!jlt_state_set_has(&stepper->lost, state)) return false;
    const jlt_quantity *interval = interval_of(&stepper->field->domain, state);
    return end == 0 || (interval->low < 0 && interval->high > 0);
}

/* The distance of a lost state from twice the least scale, where the domain ends for it: beyond, it would be errors that have
 * grown. */
static double below_return(double x)
{
    return 2 * JLT_STEPPER_SCALE_LEAST - fabs(x);
}

/* The distance of x from an end of this state's interval, relative to the larger of |end| and the state's unit. The unit of a kept
 * state, at the end 0, is its value at the start of the step. */
static double distance(const jlt_stepper *stepper, unsigned state, double x, double end, double side)
{
    const jlt_field *field = stepper->field;

    if (is_lost_at(stepper, state, end)) return below_return(x) / JLT_STEPPER_SCALE_LEAST;
    if (!isfinite(end)) return INFINITY;
    const double unit = is_kept_from(field, state, end) ? fabs(stepper->x_start[state]) : jlt_stepper_unit(stepper, state);
    return margin(x, end_of(field, state, end, side), side) / jlt_larger(fabs(end), unit);
}

/* The least distance of x (states,) from an interval's end. NaN counts as outside. */
static double least_of_intervals(const jlt_stepper *stepper, const double *x)
{
    const jlt_domain *domain = &stepper->field->domain;
    double least = INFINITY;

    for (unsigned i = 0; i < domain->states; i++) {
        const jlt_quantity *interval = interval_of(domain, i);
        const double above = distance(stepper, i, x[i], interval->low, 1), below = distance(stepper, i, x[i], interval->high, -1);
        if (!(above >= least)) least = above;
        if (!(below >= least)) least = below;
    }
    return least;
}

/* The least value of a condition relative to that at the step's start. The domain ends at a pole of a condition as well, so that a
 * condition that has grown counts by the inverse of this ratio. */
static double least_of_conditions(const jlt_stepper *stepper, const double *x)
{
    const jlt_domain *domain = &stepper->field->domain;
    double before[JLT_REGION_CONDITIONS_MAX], here[JLT_REGION_CONDITIONS_MAX], least = INFINITY;

    if (domain->conditions == 0) return least;
    domain->values(stepper->x_start, domain->p, before);
    domain->values(x, domain->p, here);
    for (unsigned k = 0; k < domain->conditions; k++) {
        const double grown = before[k] > 0 ? here[k] / before[k] : here[k], value = grown > 1 ? 1 / grown : grown;
        if (!(value >= least)) least = value;
    }
    return least;
}

static double distance_of(const jlt_stepper *stepper, const double *x)
{
    const double a = least_of_intervals(stepper, x), b = least_of_conditions(stepper, x);
    return !(a >= b) ? a : b;
}

/* The least distance on the last step's polynomial. */
static double distance_at(const jlt_stepper *stepper, double theta)
{
    double x[JLT_DOMAIN_STATES_MAX];

    for (unsigned i = 0; i < stepper->field->domain.states; i++) x[i] = jlt_stepper_value(stepper, i, theta);
    return distance_of(stepper, x);
}

static double near(const jlt_stepper *stepper)
{
    return jlt_larger(stepper->asked, 0x1p-46); /* a distance from an end has no more digits */
}

bool jlt_edge_is_outside(const jlt_stepper *stepper)
{
    return stepper->watches && !(distance_of(stepper, stepper->x) > 0);
}

/* The time in which a quantity with this value and rate comes to zero: 0 if it is beyond, INFINITY if it does not approach zero. */
static double time_to_zero(double value, double rate)
{
    if (!(value > 0)) return 0;
    return rate < 0 ? -value / rate : INFINITY;
}

/* Whether a condition is as near to its zero, or its pole, in time as in value. A zero of higher order is not, at small values. */
static bool is_soon(const jlt_stepper *stepper)
{
    const jlt_domain *domain = &stepper->field->domain;
    double values[JLT_REGION_CONDITIONS_MAX], first = INFINITY;

    domain->values(stepper->x, domain->p, values);
    domain->gradients(stepper->x, domain->p, stepper->gradients);
    for (unsigned k = 0; k < domain->conditions; k++)
        first = fmin(first, fabs(values[k] / jlt_along(stepper->gradients + k * domain->states, stepper->f, domain->states)));
    return first <= near(stepper) * fabs(stepper->h);
}

bool jlt_edge_reached(const jlt_stepper *stepper)
{
    if (least_of_intervals(stepper, stepper->x) <= near(stepper)) return true;
    return least_of_conditions(stepper, stepper->x) <= near(stepper) && is_soon(stepper);
}

/* The time in which state i comes to this end of its interval. */
static double time_to_end(const jlt_stepper *stepper, unsigned i, double end, double side)
{
    const double x = stepper->x[i], rate = stepper->direction * stepper->f[i];

    if (is_lost_at(stepper, i, end)) return time_to_zero(below_return(x), x < 0 ? rate : -rate);
    return time_to_zero(margin(x, end, side), side * rate);
}

/* The time in which the orbit comes to the end *out, the first one, if it goes straight on; INFINITY if it comes to none. */
static double time_ahead(jlt_edge_part *out, const jlt_stepper *stepper)
{
    const jlt_domain *domain = &stepper->field->domain;
    const double *x = stepper->x, *f = stepper->f, ahead_of = stepper->direction;
    double values[JLT_REGION_CONDITIONS_MAX], first = INFINITY;

    for (unsigned i = 0; i < domain->states; i++) {
        const jlt_quantity *interval = interval_of(domain, i);
        const double below = time_to_end(stepper, i, interval->low, 1), above = time_to_end(stepper, i, interval->high, -1);
        if (!(fmin(below, above) < first)) continue;
        first = fmin(below, above);
        *out = (jlt_edge_part){ .index = i, .is_upper = above < below, .is_lost = jlt_state_set_has(&stepper->lost, i) };
    }
    if (domain->conditions > 0) {
        domain->values(x, domain->p, values);
        domain->gradients(x, domain->p, stepper->gradients);
    }
    for (unsigned k = 0; k < domain->conditions; k++) {
        const double rate = jlt_along(stepper->gradients + k * domain->states, f, domain->states);
        const double time = time_to_zero(values[k], ahead_of * rate);
        if (!(time < first)) continue;
        first = time;
        *out = (jlt_edge_part){ .is_condition = true, .index = k };
    }
    return first;
}

bool jlt_edge_ahead(jlt_edge_part *out, const jlt_stepper *stepper) { return time_ahead(out, stepper) < INFINITY; }

bool jlt_edge_is_ahead(const jlt_stepper *stepper)
{
    const double move = stepper->direction * ahead * fabs(stepper->tau);
    double x[JLT_DOMAIN_STATES_MAX];
    jlt_edge_part end;

    if (!stepper->watches) return false;
    for (unsigned i = 0; i < stepper->field->domain.states; i++) x[i] = stepper->x[i] + move * stepper->f[i];
    return !(distance_of(stepper, x) > 0) || time_ahead(&end, stepper) <= fabs(move); /* a square is positive beyond its zero */
}

static jlt_status leave_interval(double *theta, jlt_stepper *stepper, unsigned state, double end, int side)
{
    const jlt_event event = { .column = state, .level = end_of(stepper->field, state, end, side) };

    if (!isfinite(end) || is_lost_at(stepper, state, end)) return JLT_OK;
    return jlt_loss_zero(theta, stepper, &event, side);
}

typedef struct {
    const jlt_stepper *stepper;
    unsigned index;
} condition;

static double condition_value(void *context, const double *x)
{
    const condition *self = context;
    const jlt_domain *domain = &self->stepper->field->domain;
    double values[JLT_REGION_CONDITIONS_MAX];

    domain->values(x, domain->p, values);
    return values[self->index];
}

static double condition_rate(void *context, const double *x, const double *f)
{
    const condition *self = context;
    const jlt_domain *domain = &self->stepper->field->domain;

    domain->gradients(x, domain->p, self->stepper->gradients);
    return jlt_along(self->stepper->gradients + self->index * domain->states, f, domain->states);
}

static jlt_status leave_conditions(double *theta, jlt_stepper *stepper)
{
    jlt_status st = JLT_OK;

    for (unsigned k = 0; st == JLT_OK && k < stepper->field->domain.conditions; k++) {
        condition one = { stepper, k };
        st = jlt_loss_first(theta, stepper, &(jlt_event){ .value = condition_value, .rate = condition_rate, .context = &one });
    }
    return st;
}

jlt_status jlt_edge_left(double *theta, jlt_stepper *stepper)
{
    const jlt_domain *domain = &stepper->field->domain;

    *theta = INFINITY;
    if (!stepper->watches) return JLT_OK;
    if (jlt_edge_is_outside(stepper)) {
        *theta = 1;
        return JLT_OK;
    }
    for (unsigned i = 0; domain->intervals != NULL && i < domain->states; i++) {
        JLT_PASS(leave_interval(theta, stepper, i, domain->intervals[i].low, 1));
        JLT_PASS(leave_interval(theta, stepper, i, domain->intervals[i].high, -1));
    }
    return leave_conditions(theta, stepper);
}

jlt_status jlt_edge_find(double *theta, jlt_stepper *stepper)
{
    const double wanted = near(stepper) / 2, last = *theta;
    double inside = 0, outside = last;

    JLT_PASS(jlt_stepper_dense(stepper));
    for (int k = 1; k < SAMPLES; k++) {
        const double at = last * k / SAMPLES;
        if (!(distance_at(stepper, at) > 0)) {
            outside = at;
            break;
        }
        inside = at;
    }
    for (int k = 0; k < BISECTIONS; k++) {
        const double middle = inside + (outside - inside) / 2;
        if (distance_at(stepper, middle) > wanted) inside = middle;
        else outside = middle;
    }
    *theta = inside;
    return JLT_OK;
}
