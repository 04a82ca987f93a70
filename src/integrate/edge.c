#include "integrate/edge.h"

#include <math.h>

#include "integrate/gauss_coefficients.h"
#include "integrate/locate.h"
#include "integrate/step_control.h"
#include "integrate/watch.h"

enum { SAMPLES = 16, BISECTIONS = 60, NODES = JLT_STEPPER_NODES };
static const double ahead = 1e-8; /* part of |tau|: half of its digits */
static const double rounding = 1e-9; /* a function is this far from 0 at its zeros at most, in units of it elsewhere */

/* How far x is from where it counts as being at an end of its interval, which may be infinite. */
static double margin(double x, double end, double side)
{
    return isfinite(end) ? side * (x - end) - JLT_FIELD_NEAREST * fabs(end) : INFINITY;
}

static bool is_kept_from(const jlt_field *field, unsigned state, double end)
{
    return end == 0 && jlt_field_keeps(field, state);
}

/* Where an interval's end counts as such: below the least scale nothing is left of a kept state but errors, which may change its
 * sign. */
static double end_of(const jlt_field *field, unsigned state, double end, double side)
{
    return is_kept_from(field, state, end) ? -side * JLT_STEPPER_SCALE_LEAST : end;
}

/* How far x is from an end of this state's interval. A kept state may be as near to 0 as it likes: its distance is in units of what
 * it is at the step's start. */
static double distance(const jlt_stepper *stepper, unsigned state, double x, double end, double side)
{
    const jlt_field *field = stepper->field;

    if (!isfinite(end)) return INFINITY;
    const double unit = is_kept_from(field, state, end) ? fabs(stepper->x_start[state]) : jlt_stepper_unit(stepper, state);
    return margin(x, end_of(field, state, end, side), side) / jlt_larger(fabs(end), unit);
}

/* The least distance of x (states,) from an interval's end. NaN counts as outside. */
static double least_of_intervals(const jlt_stepper *stepper, const double *x)
{
    const jlt_domain *domain = &stepper->field->domain;
    double least = INFINITY;

    for (unsigned i = 0; domain->intervals != NULL && i < domain->states; i++) {
        const double above = distance(stepper, i, x[i], domain->intervals[i].low, 1);
        const double below = distance(stepper, i, x[i], domain->intervals[i].high, -1);
        if (!(above >= least)) least = above;
        if (!(below >= least)) least = below;
    }
    return least;
}

/* The least value of a condition, in units of what it is at the step's start. At its pole the domain ends as well: what has grown
 * counts by its inverse. */
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

bool jlt_edge_is_ahead(const jlt_stepper *stepper)
{
    const double move = stepper->direction * ahead * fabs(stepper->tau);
    double x[JLT_DOMAIN_STATES_MAX];

    if (!stepper->watches) return false;
    for (unsigned i = 0; i < stepper->field->domain.states; i++) x[i] = stepper->x[i] + move * stepper->f[i];
    return !(distance_of(stepper, x) > 0);
}

static double along(const double *gradient, const double *f, unsigned count)
{
    double sum = 0;
    for (unsigned i = 0; i < count; i++) sum += gradient[i] * f[i];
    return sum;
}

/* The time in which a quantity with this value and rate comes to zero: 0 if it is beyond, INFINITY if it does not approach zero. */
static double time_to_zero(double value, double rate)
{
    if (!(value > 0)) return 0;
    return rate < 0 ? -value / rate : INFINITY;
}

/* Whether a condition is as near to its zero, or its pole, in time as in value: one of higher order is small long before. */
static bool is_soon(const jlt_stepper *stepper)
{
    const jlt_domain *domain = &stepper->field->domain;
    double values[JLT_REGION_CONDITIONS_MAX], first = INFINITY;

    domain->values(stepper->x, domain->p, values);
    domain->gradients(stepper->x, domain->p, stepper->gradients);
    for (unsigned k = 0; k < domain->conditions; k++)
        first = fmin(first, fabs(values[k] / along(stepper->gradients + k * domain->states, stepper->f, domain->states)));
    return first <= near(stepper) * fabs(stepper->h);
}

bool jlt_edge_reached(const jlt_stepper *stepper)
{
    if (least_of_intervals(stepper, stepper->x) <= near(stepper)) return true;
    return least_of_conditions(stepper, stepper->x) <= near(stepper) && is_soon(stepper);
}

bool jlt_edge_ahead(jlt_edge_part *out, const jlt_stepper *stepper)
{
    const jlt_domain *domain = &stepper->field->domain;
    const double *x = stepper->x, *f = stepper->f, ahead_of = stepper->direction;
    double values[JLT_REGION_CONDITIONS_MAX], first = INFINITY;

    for (unsigned i = 0; domain->intervals != NULL && i < domain->states; i++) {
        const double low = domain->intervals[i].low, high = domain->intervals[i].high;
        const double below = time_to_zero(margin(x[i], low, 1), ahead_of * f[i]);
        const double above = time_to_zero(margin(x[i], high, -1), -ahead_of * f[i]);
        if (!(fmin(below, above) < first)) continue;
        first = fmin(below, above);
        *out = (jlt_edge_part){ .index = i, .is_upper = above < below };
    }
    if (domain->conditions > 0) {
        domain->values(x, domain->p, values);
        domain->gradients(x, domain->p, stepper->gradients);
    }
    for (unsigned k = 0; k < domain->conditions; k++) {
        const double time = time_to_zero(values[k], ahead_of * along(stepper->gradients + k * domain->states, f, domain->states));
        if (!(time < first)) continue;
        first = time;
        *out = (jlt_edge_part){ .is_condition = true, .index = k };
    }
    return first < INFINITY;
}

static double value_at(const jlt_stepper *stepper, const jlt_event *event, double theta)
{
    double x[JLT_FIELD_DIM_MAX + 1];

    jlt_stepper_values(stepper, jlt_smaller(theta, 1), x);
    return jlt_locate_value(event, x);
}

/* Where between these places, at the first of which an event's function has the sign `side`, it has it no more. */
static double change_between(const jlt_stepper *stepper, const jlt_event *event, int side, double low, double high)
{
    for (int k = 0; k < BISECTIONS; k++) {
        const double middle = low + (high - low) / 2;
        *(side * value_at(stepper, event, middle) > 0 ? &low : &high) = middle;
    }
    return high;
}

/* The first place in the step where the sign of an event's function is not `side`, as far as samples tell; INFINITY: none. */
static double first_change(const jlt_stepper *stepper, const jlt_event *event, int side)
{
    double low = 0, high = INFINITY;

    for (int k = 1; k <= SAMPLES && high > 1; k++) {
        const double at = (double)k / SAMPLES;
        *(side * value_at(stepper, event, at) > 0 ? &low : &high) = at;
    }
    return high <= 1 ? change_between(stepper, event, side, low, high) : high;
}

/* Where a function itself changes sign near a zero of its polynomial, which at a zero of higher order is not as sharp, and may have
 * others beside it; INFINITY: nowhere. */
static double sharpened(const jlt_stepper *stepper, const jlt_event *event, int side, double theta)
{
    for (double about = 0x1p-40; about < 0.1; about *= 16) {
        const double low = jlt_larger(theta - about, 0), high = jlt_smaller(theta + about, 1);
        if (side * value_at(stepper, event, low) > 0 && !(side * value_at(stepper, event, high) > 0))
            return change_between(stepper, event, side, low, high);
    }
    return INFINITY;
}

/* Beside a pole the polynomial of a function is far from it, and has zeros where the function has none, neither relative to the
 * step's start nor to the step. */
jlt_status jlt_edge_first_zero(double *theta, jlt_stepper *stepper, const jlt_event *event, int side)
{
    jlt_crossing list[JLT_CROSSINGS_MAX];
    jlt_watch watch = { .event = *event, .side = side };
    unsigned count;
    double first = INFINITY;

    JLT_PASS(jlt_watch_step(&watch, stepper, list, &count));
    for (unsigned i = 0; event->value != NULL && i < count && first > 1; i++)
        first = sharpened(stepper, event, side, list[i].theta);
    if (count > 0 && first > 1) first = list[0].theta;
    if (event->value != NULL && count > 0) {
        const double before = fabs(jlt_locate_value(event, stepper->x_start)), within = fabs(value_at(stepper, event, 0.5));
        const bool has_pole = fabs(value_at(stepper, event, first)) > jlt_larger(before / 2, rounding * within);
        if (has_pole) first = first_change(stepper, event, side);
    }
    *theta = jlt_smaller(first, *theta);
    return JLT_OK;
}

static jlt_status leave_interval(double *theta, jlt_stepper *stepper, unsigned state, double end, int side)
{
    const jlt_event event = { .column = state, .level = end_of(stepper->field, state, end, side) };

    return isfinite(end) ? jlt_edge_first_zero(theta, stepper, &event, side) : JLT_OK;
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
    return along(self->stepper->gradients + self->index * domain->states, f, domain->states);
}

/* The rates of an event's function, in units of the step, at its start and at its end. */
static void rates(double rate[2], const jlt_stepper *stepper, const jlt_event *event)
{
    rate[0] = stepper->h * jlt_locate_slope(event, stepper, stepper->x_start, stepper->f_start);
    rate[1] = stepper->h * jlt_locate_slope(event, stepper, stepper->x, stepper->f);
}

/* Whether the cubic polynomial through values and slopes, in Bernstein form, is above zero by more than its error, estimated as
 * 1/32 of its terms of second and third order: it is w""h^4/384 at most, 1/192 of the former where w"" = w"/h^2. */
static bool stays_above(const jlt_stepper *stepper, const jlt_event *event, double w0, double w1)
{
    double rate[2];

    rates(rate, stepper, event);
    const double bend = fabs(3 * (w1 - w0) - 2 * rate[0] - rate[1]) + fabs(rate[0] + rate[1] - 2 * (w1 - w0));
    const double least = jlt_smaller(jlt_smaller(w0, w1), jlt_smaller(w0 + rate[0] / 3, w1 - rate[1] / 3));
    return least > bend / 32;
}

static bool stands_still(const jlt_stepper *stepper, const jlt_event *event, double w0, double w1)
{
    double rate[2];

    if (w0 < w1 || w0 > w1) return false;
    rates(rate, stepper, event);
    return rate[0] == 0 && rate[1] == 0;
}

/* Whether a function is above zero by more than it varies, as seen at both ends and at two nodes between: a cubic polynomial
 * through four such values goes below the least of them by two fifths of that at most. */
static bool stays_far(double w0, double left, double right, double w1)
{
    const double least = fmin(fmin(w0, w1), fmin(left, right)), most = fmax(fmax(w0, w1), fmax(left, right));
    return least > most - least;
}

/* Whether a function with the values w at both ends and all nodes is above zero between them as well. It goes below the line
 * through two of them by gap^2/8 of its second derivative at most, taken to be up to twice the largest that three neighbours
 * show. */
static bool stays_above_nodes(const double w[NODES + 2])
{
    double least = w[0], sum = w[0], bend = 0, widest = 0, slope = 0, gap = 0; /* bend: half a second derivative */

    for (unsigned k = 1; k < NODES + 2; k++) {
        const double from = k == 1 ? 0 : jlt_gauss_node[k - 2], to = k <= NODES ? jlt_gauss_node[k - 1] : 1;
        const double next = (w[k] - w[k - 1]) / (to - from);
        if (k > 1) bend = jlt_larger(bend, fabs(next - slope) / (to - from + gap));
        slope = next;
        gap = to - from;
        widest = jlt_larger(widest, gap);
        least = jlt_smaller(least, w[k]);
        sum += w[k];
    }
    return isfinite(sum) && least > widest * widest / 2 * bend;
}

/* Whether a function that is positive at both ends of the step is so between. Steps of methods with nodes may be so long that
 * values and slopes at the ends tell nothing. */
static bool holds_between(jlt_stepper *stepper, const jlt_event *event, double w0, double w1)
{
    static const unsigned char order[NODES] = { 2, 5, 0, 1, 3, 4, 6, 7 };
    double x[JLT_FIELD_DIM_MAX + 1], w[NODES + 2] = { w0 };

    w[NODES + 1] = w1;
    for (unsigned i = 0; i < NODES; i++) {
        if (!jlt_stepper_node(stepper, order[i], x)) return stays_above(stepper, event, w0, w1);
        w[order[i] + 1] = jlt_locate_value(event, x);
        if (i == 1 && stays_far(w0, w[3], w[6], w1)) return true;
    }
    return stays_above_nodes(w) || stands_still(stepper, event, w0, w1);
}

jlt_status jlt_edge_first_loss(double *theta, jlt_stepper *stepper, const jlt_event *event)
{
    const double w0 = jlt_locate_value(event, stepper->x_start), w1 = jlt_locate_value(event, stepper->x);

    if (!(w0 > 0) || !(w1 > 0) || holds_between(stepper, event, w0, w1)) return JLT_OK;
    return jlt_edge_first_zero(theta, stepper, event, 1);
}

/* By ternary search, after an interval that holds the minimum is found by doubling. */
jlt_event_least jlt_edge_least_after(const jlt_stepper *stepper, const jlt_event *event, double theta)
{
    double low = theta, width = 0x1p-12;

    while (theta + width < 1 && value_at(stepper, event, theta + 2 * width) < value_at(stepper, event, theta + width)) width *= 2;
    width *= 2;
    for (int k = 0; k < BISECTIONS; k++) {
        const double left = value_at(stepper, event, low + width / 3), right = value_at(stepper, event, low + 2 * width / 3);
        if (left > right) low += width / 3;
        width *= 2.0 / 3;
    }
    return (jlt_event_least){ value_at(stepper, event, low), jlt_smaller(low, 1) };
}

static jlt_status leave_conditions(double *theta, jlt_stepper *stepper)
{
    jlt_status st = JLT_OK;

    for (unsigned k = 0; st == JLT_OK && k < stepper->field->domain.conditions; k++) {
        condition one = { stepper, k };
        st = jlt_edge_first_loss(theta, stepper, &(jlt_event){ .value = condition_value, .rate = condition_rate, .context = &one });
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
