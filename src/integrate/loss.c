#include "integrate/loss.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "integrate/gauss_coefficients.h"
#include "integrate/locate.h"
#include "integrate/step_control.h"
#include "integrate/watch.h"

enum { SAMPLES = 16, BISECTIONS = 60, NODES = JLT_STEPPER_NODES };
static const double rounding = 1e-9; /* a function is this far from 0 at its zeros at most, in units of it elsewhere */
static const double small_part = 0x1p-10; /* of a function's least value: by so much more it varies within a narrow dip's reach */
static const double finest = 0x1p-14; /* part of a step within which no dips are looked for */

static double value_at(const jlt_stepper *stepper, const jlt_event *event, double theta)
{
    double x[JLT_FIELD_DIM_MAX + 1];

    jlt_stepper_values(stepper, jlt_smaller(theta, 1), x);
    return jlt_locate_value(event, x);
}

/* Bisect for the place from which on an event's function has the sign `side` no longer, which it has at `low`. */
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

/* Whether five equidistant values are those of a parabola, up to a small part of the least of them and to rounding. */
static bool is_parabola(const double v[5], double size)
{
    const double least = fmin(fmin(fmin(v[0], v[1]), fmin(v[2], v[3])), v[4]);
    const double left = 0.375 * v[0] + 0.75 * v[2] - 0.125 * v[4], right = 0.375 * v[4] + 0.75 * v[2] - 0.125 * v[0];
    return fmax(fabs(v[1] - left), fabs(v[3] - right)) <= fmax(small_part * least, rounding * size);
}

/* The first place in the step where a function is beyond zero by more than rounding; INFINITY: none. Near a zero of high order the
 * polynomial of the function may have none, or one far from it, and it does not show a dip between its values. Four values more at
 * a time are compared with a parabola: what is near a dip shows, and is looked at more closely. */
static double first_beyond(const jlt_stepper *stepper, const jlt_event *event, int side)
{
    double v[5] = { side * value_at(stepper, event, 0) }, size = fabs(v[0]);

    for (double low = 0, length = 0.25; low < 1;) {
        for (int k = 1; k < 5; k++) {
            v[k] = side * value_at(stepper, event, low + 0.25 * k * length);
            size = fmax(size, fabs(v[k]));
        }
        for (int k = 1; k < 5; k++)
            if (v[k] < -16 * DBL_EPSILON * size)
                return change_between(stepper, event, side, low + 0.25 * (k - 1) * length, low + 0.25 * k * length);
        if (length > finest && !is_parabola(v, size)) {
            length *= 0.5;
            continue;
        }
        v[0] = v[4];
        low += length;
        length = fmin(2 * length, 1 - low);
    }
    return INFINITY;
}

/* The place where the function itself changes sign near a zero of its polynomial, which is less accurate at a zero of higher order,
 * where the function may also have other zeros; INFINITY: there is none. */
static double sharpened(const jlt_stepper *stepper, const jlt_event *event, int side, double theta)
{
    for (double about = 0x1p-40; about < 0.1; about *= 16) {
        const double low = jlt_larger(theta - about, 0), high = jlt_smaller(theta + about, 1);
        if (side * value_at(stepper, event, low) > 0 && !(side * value_at(stepper, event, high) > 0))
            return change_between(stepper, event, side, low, high);
    }
    return INFINITY;
}

/* Near a pole the polynomial of a function is far from it, and has zeros at which the function is small neither relative to its
 * value at the step's start nor to that in the middle: then the function itself is searched for a change of sign. */
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

/* Whether the cubic polynomial through values and slopes, in Bernstein form, is far above zero, measured by its terms of second and
 * third order. Its error is w""h^4/384 at most, 1/192 of the former where w"" = w"/h^2; a narrow dip, or a pole, shows less. */
static bool stays_above(const jlt_stepper *stepper, const jlt_event *event, double w0, double w1)
{
    double rate[2];

    rates(rate, stepper, event);
    const double bend = fabs(3 * (w1 - w0) - 2 * rate[0] - rate[1]) + fabs(rate[0] + rate[1] - 2 * (w1 - w0));
    const double least = jlt_smaller(jlt_smaller(w0, w1), jlt_smaller(w0 + rate[0] / 3, w1 - rate[1] / 3));
    return least > 16 * bend;
}

static bool stands_still(const jlt_stepper *stepper, const jlt_event *event, double w0, double w1)
{
    double rate[2];

    if (w0 < w1 || w0 > w1) return false;
    rates(rate, stepper, event);
    return rate[0] == 0 && rate[1] == 0;
}

/* The error of the polynomials through all values but the last, and all but the first: about their last coefficient in Chebyshev's
 * polynomials, a divided difference. weight: shape (count - 1,). */
static double left_out(const double *w, const double *weight, unsigned count)
{
    double from_start = 0, from_end = 0;

    for (unsigned k = 0; k < count - 1; k++) {
        from_start += weight[k] * w[k];
        from_end += weight[k] * w[count - 1 - k];
    }
    return jlt_larger(fabs(from_start), fabs(from_end));
}

/* Whether a function with the values w at these places, from one end of the step to the other, is above zero between them as well.
 * It goes below the line through two of them by gap^2/8 of its second derivative at most, taken to be up to twice the largest that
 * three neighbours show. What is left out, such as a narrow dip, may be anywhere between: at most this part of the least value is
 * allowed. */
static bool stays_above_values(const double *w, const double *place, const double *weight, unsigned count, double part)
{
    double least = w[0], sum = w[0], bend = 0, widest = 0, slope = 0, gap = 0; /* bend: half a second derivative */

    for (unsigned k = 1; k < count; k++) {
        const double next = (w[k] - w[k - 1]) / (place[k] - place[k - 1]);
        if (k > 1) bend = jlt_larger(bend, fabs(next - slope) / (place[k] - place[k - 1] + gap));
        slope = next;
        gap = place[k] - place[k - 1];
        widest = jlt_larger(widest, gap);
        least = jlt_smaller(least, w[k]);
        sum += w[k];
    }
    return isfinite(sum) && least > widest * widest / 2 * bend && left_out(w, weight, count) <= part * least;
}

/* The values of an event's function at JLT_STEPPER_NODES states, x (dim, NODES). */
static void values_of(double out[NODES], const jlt_event *event, const double *x, unsigned dim)
{
    double one[JLT_FIELD_DIM_MAX + 1];

    if (event->values != NULL) {
        event->values(event->context, out, x);
        return;
    }
    for (unsigned k = 0; k < NODES; k++) {
        for (unsigned i = 0; i < dim; i++) one[i] = x[i * NODES + k];
        out[k] = jlt_locate_value(event, one);
    }
}

/* Its values at the nodes of the step. Returns false if that takes evaluations of the field: steps of such methods are so short
 * that values and slopes at their ends tell what lies between. */
static bool values_at_nodes(double out[NODES], jlt_stepper *stepper, const jlt_event *event)
{
    const double *nodes = jlt_stepper_nodes(stepper);

    if (nodes != NULL) {
        values_of(out, event, nodes, stepper->field->dim);
        return true;
    }
    if (!stepper->method->needs_jet || jlt_stepper_dense(stepper) != JLT_OK) return false;
    for (unsigned k = 0; k < NODES; k++) out[k] = value_at(stepper, event, jlt_gauss_node[k]);
    return true;
}

/* Whether a function that is positive at both ends of the step is so between. Steps of methods with nodes may be so long that
 * values and slopes at the ends tell nothing. */
static bool holds_between(jlt_stepper *stepper, const jlt_event *event, double w0, double w1)
{
    static const double of_nodes[NODES + 1] = { 0.39276123046875, -0.62083259586207265, 0.38930656486425137, -0.27892209406686126,
        0.20135125753856239, -0.13893159426971149, 0.08674970976214992, -0.044058859112127087, 0.012576380677058808 };
    static const double of_all[2 * NODES] = {
        -0.0290480414096730148, 0.0932786193074020334, -0.224747181780023154, 0.341432793672587564,
        -0.316714320358269473, 0.277513008182125963, -0.299749225730917932, 0.293890857787409694,
        -0.248609049613042546, 0.202783562977639035, -0.143843536003278328, 0.0863114591031633008,
        -0.0584270796424606436, 0.0386408571299739974, -0.014602294874628166, 0.00188957125199167082
    };
    double w[NODES + 2] = { w0 }, beside[NODES], all[2 * NODES + 1] = { w0 }, place[2 * NODES + 1] = { 0 };
    const double *between;

    if (!values_at_nodes(w + 1, stepper, event)) return stays_above(stepper, event, w0, w1);
    w[NODES + 1] = w1;
    memcpy(place + 1, jlt_gauss_node, sizeof jlt_gauss_node);
    place[NODES + 1] = 1;
    if (stays_above_values(w, place, of_nodes, NODES + 2, 0.1 * small_part) || stands_still(stepper, event, w0, w1)) return true;
    between = jlt_stepper_between(stepper);
    if (between == NULL) return false;
    values_of(beside, event, between, stepper->field->dim);
    for (unsigned k = 0; k < NODES; k++) {
        all[2 * k + 1] = w[k + 1];
        place[2 * k + 1] = jlt_gauss_node[k];
        all[2 * k + 2] = k < NODES - 1 ? beside[k] : w1;
        place[2 * k + 2] = k < NODES - 1 ? jlt_gauss_place_between[k] : 1;
    }
    return stays_above_values(all, place, of_all, 2 * NODES + 1, 0.01 * small_part); /* weights at outer nodes are smaller here */
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
    } else if (first <= 1 && !(value_at(stepper, event, first) <= 0)) { /* of the polynomial alone, maybe, or NaN */
        const double before = jlt_larger(first - 0.5 / SAMPLES, 0);
        if (!(jlt_loss_least(stepper, event, before).value <= 0)) return JLT_OK;
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
