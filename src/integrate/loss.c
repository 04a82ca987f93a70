#include "integrate/loss.h"

#include <float.h>
#include <math.h>

#include "integrate/gauss_coefficients.h"
#include "integrate/locate.h"
#include "integrate/step_control.h"
#include "integrate/watch.h"

enum { SAMPLES = 16, BISECTIONS = 60, NODES = JLT_STEPPER_NODES };
static const double rounding = 1e-9; /* a function is this far from 0 at its zeros at most, in units of it elsewhere */

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

/* The first place in the step where a function is beyond zero by more than rounding, as far as samples tell; INFINITY: none. Near a
 * zero of high order the polynomial of the function may have none, or one far from it. */
static double first_beyond(const jlt_stepper *stepper, const jlt_event *event, int side)
{
    double value[SAMPLES + 1], size = 0;

    for (int k = 0; k <= SAMPLES; k++) {
        value[k] = side * value_at(stepper, event, (double)k / SAMPLES);
        size = fmax(size, fabs(value[k]));
    }
    for (int k = 1; k <= SAMPLES; k++)
        if (value[k] < -16 * DBL_EPSILON * size)
            return change_between(stepper, event, side, (k - 1.0) / SAMPLES, (double)k / SAMPLES);
    return INFINITY;
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
jlt_status jlt_loss_zero(double *theta, jlt_stepper *stepper, const jlt_event *event, int side)
{
    jlt_crossing list[JLT_CROSSINGS_MAX];
    jlt_watch watch = { .event = *event, .side = side };
    unsigned count;
    double first = INFINITY;

    JLT_PASS(jlt_watch_step(&watch, stepper, list, &count));
    for (unsigned i = 0; event->value != NULL && i < count && first > 1; i++)
        first = sharpened(stepper, event, side, list[i].theta);
    if (event->value != NULL) {
        JLT_PASS(jlt_stepper_dense(stepper));
        first = jlt_smaller(first_beyond(stepper, event, side), first);
    }
    if (count > 0 && first > 1) first = list[0].theta;
    if (event->value != NULL && count > 0) {
        const double before = fabs(jlt_locate_value(event, stepper->x_start)), within = fabs(value_at(stepper, event, 0.5));
        const bool has_pole = fabs(value_at(stepper, event, first)) > jlt_larger(before / 2, rounding * within);
        if (has_pole) first = first_change(stepper, event, side);
    }
    *theta = jlt_smaller(first, *theta);
    return JLT_OK;
}

/* The rates of an event's function, in units of the step, at its start and at its end. */
static void rates(double rate[2], const jlt_stepper *stepper, const jlt_event *event)
{
    rate[0] = stepper->h * jlt_locate_slope(event, stepper, stepper->x_start, stepper->f_start);
    rate[1] = stepper->h * jlt_locate_slope(event, stepper, stepper->x, stepper->f);
}

/* Whether the cubic polynomial through values and slopes, in Bernstein form, is above zero by more than its terms of second and
 * third order. Its error is w""h^4/384 at most, 1/192 of the former where w"" = w"/h^2; one with a pole varies more. */
static bool stays_above(const jlt_stepper *stepper, const jlt_event *event, double w0, double w1)
{
    double rate[2];

    rates(rate, stepper, event);
    const double bend = fabs(3 * (w1 - w0) - 2 * rate[0] - rate[1]) + fabs(rate[0] + rate[1] - 2 * (w1 - w0));
    const double least = jlt_smaller(jlt_smaller(w0, w1), jlt_smaller(w0 + rate[0] / 3, w1 - rate[1] / 3));
    return least > bend;
}

static bool stands_still(const jlt_stepper *stepper, const jlt_event *event, double w0, double w1)
{
    double rate[2];

    if (w0 < w1 || w0 > w1) return false;
    rates(rate, stepper, event);
    return rate[0] == 0 && rate[1] == 0;
}

/* Whether a function is above zero by four times as much as it varies, as seen at both ends and at two nodes between: a cubic
 * polynomial through four such values goes below the least of them by two fifths of that at most, and one with a pole by more. */
static bool stays_far(double w0, double left, double right, double w1)
{
    const double least = fmin(fmin(w0, w1), fmin(left, right)), most = fmax(fmax(w0, w1), fmax(left, right));
    return least > 4 * (most - least);
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

/* By ternary search, after an interval that holds the minimum is found by doubling. */
jlt_event_least jlt_loss_least(const jlt_stepper *stepper, const jlt_event *event, double theta)
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

jlt_status jlt_loss_first(double *theta, jlt_stepper *stepper, const jlt_event *event)
{
    const double w0 = jlt_locate_value(event, stepper->x_start), w1 = jlt_locate_value(event, stepper->x);
    double first = INFINITY;

    if (!(w0 > 0) || isnan(w1) || (w1 > 0 && holds_between(stepper, event, w0, w1))) return JLT_OK;
    JLT_PASS(jlt_loss_zero(&first, stepper, event, 1));
    if (!(w1 > 0)) {
        first = jlt_smaller(first, 1);
    } else if (first <= 1 && value_at(stepper, event, first) > 0) { /* of the polynomial alone, maybe */
        const double before = jlt_larger(first - 0.5 / SAMPLES, 0);
        if (jlt_loss_least(stepper, event, before).value > 0) return JLT_OK;
    }
    *theta = jlt_smaller(first, *theta);
    return JLT_OK;
}

jlt_status jlt_loss_step(const jlt_event *event, jlt_stepper *stepper, jlt_crossing *list, unsigned *count)
{
    *list = (jlt_crossing){ .theta = INFINITY, .direction = stepper->direction > 0 ? JLT_FALLING : JLT_RISING };
    JLT_PASS(jlt_loss_first(&list->theta, stepper, event));
    *count = list->theta <= 1;
    return JLT_OK;
}
