/* Newton's method on partial steps, between bounds; its last moves follow the flow. */
#include "integrate/locate.h"

#include <float.h>
#include <math.h>

#include "integrate/step_control.h"

double jlt_locate_value(const jlt_event *event, const double *x)
{
    return event->value != NULL ? event->value(event->context, x) : x[event->column] - event->level;
}

/* Central difference along the flow: enough for Newton's method, whose residual is exact. */
static double difference_along(const jlt_event *event, const jlt_stepper *stepper, const double *x, const double *f)
{
    const double step = 1e-5 * fabs(stepper->h);
    double shifted[JLT_FIELD_DIM_MAX + 1];

    for (unsigned i = 0; i < stepper->columns; i++) shifted[i] = x[i] + step * f[i];
    const double ahead = event->value(event->context, shifted);
    for (unsigned i = 0; i < stepper->columns; i++) shifted[i] = x[i] - step * f[i];
    return (ahead - event->value(event->context, shifted)) / (2 * step);
}

double jlt_locate_slope(const jlt_event *event, const jlt_stepper *stepper, const double *x, const double *f)
{
    if (event->value == NULL) return f[event->column];
    return event->rate != NULL ? event->rate(event->context, x, f) : difference_along(event, stepper, x, f);
}

double jlt_locate_unit(const jlt_event *event, const jlt_stepper *stepper)
{
    const double level = fabs(event->level);

    if (level > 0 && jlt_field_keeps(stepper->field, event->column)) return level;
    return jlt_larger(level, jlt_stepper_unit(stepper, event->column));
}

jlt_status jlt_locate_state(const jlt_event *event, jlt_stepper *stepper, double theta, double *x, double *f, double *value,
                            double *slope)
{
    JLT_PASS(stepper->method->partial(stepper, theta, x));
    jlt_field_rates(stepper->field, f, x);
    stepper->evaluations++;
    *value = jlt_locate_value(event, x);
    *slope = jlt_locate_slope(event, stepper, x, f);
    return JLT_OK;
}

/* Follow the flow to the zero of g, a short time `move` away by the slope here, in place: the midpoint rule with the slope of g
 * in the middle, whose error is of third order. Returns the time it took. */
static double nudge(jlt_stepper *stepper, const jlt_event *event, double *x, double *f, double g, double move)
{
    double middle[JLT_FIELD_DIM_MAX + 8], slope[JLT_FIELD_DIM_MAX + 8];

    for (unsigned i = 0; i < stepper->columns; i++) middle[i] = x[i] + 0.5 * move * f[i];
    jlt_field_rates(stepper->field, slope, middle);
    move = -g / jlt_locate_slope(event, stepper, middle, slope);
    for (unsigned i = 0; i < stepper->columns; i++) x[i] += move * slope[i];
    jlt_field_rates(stepper->field, f, x);
    stepper->evaluations += 2;
    return move;
}

jlt_status jlt_locate_refine(jlt_crossing *crossing, double *x, double *slope_work, const jlt_event *event,
                               jlt_stepper *stepper)
{
    double *f = slope_work, *theta = &crossing->theta;
    const double reach = event->loss ? 0x1p-10 : 0.5; /* near a pole there may be other zeros, and slopes do not lead to them */
    double lo = fmax(*theta - reach, -0.01), hi = fmin(*theta + reach, 1.01); /* shrinks about the sign change */
    const double span = fabs(stepper->h), turn = crossing->direction * stepper->direction;
    if (*theta == 0) lo = -jlt_larger(1, stepper->h_next / span), hi = 1; /* found as the orbit left the noise */
    double best = *theta, least = INFINITY;
    unsigned nudged = 0;
    bool has_low = false, has_high = false; /* g has been seen to have its signs there */

    JLT_PASS(jlt_locate_state(event, stepper, *theta, x, f, &crossing->residual, &crossing->slope));
    if (crossing->direction == 0) return JLT_OK;
    for (unsigned i = 0; i < 64; i++) {
        if (fabs(crossing->residual) < least) {
            least = fabs(crossing->residual);
            best = *theta;
        }
        const double g = crossing->residual, move = -g / crossing->slope, near = fabs(move) / span;
        const bool downhill = !event->loss && crossing->slope * stepper->direction * turn > 0;
        if (g == 0 || (downhill && fabs(move) <= DBL_EPSILON * span)) return JLT_OK;
        if (nudged == 3) return JLT_OK; /* at the rounding level of g */
        /* On steps that gauss takes, nudge errs by less than a third of the cube of its move. */
        if (downhill && near * near * near <= jlt_larger(1e-3 * stepper->tolerance, 1e-18)) {
            *theta += nudge(stepper, event, x, f, g, move) / stepper->h;
            crossing->residual = jlt_locate_value(event, x);
            crossing->slope = jlt_locate_slope(event, stepper, x, f);
            nudged++;
            continue;
        }
        const bool is_low = g * turn < 0;
        *(is_low ? &lo : &hi) = *theta;
        *(is_low ? &has_low : &has_high) = true;
        const double newton = *theta + move / stepper->h;
        *theta = downhill && newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
        /* A rounding-level tangency has no sign change; keep the point of smallest residual. A pole has one. */
        const bool closed = hi - lo <= DBL_EPSILON;
        if (closed && !(has_low && has_high)) *theta = best;
        JLT_PASS(jlt_locate_state(event, stepper, *theta, x, f, &crossing->residual, &crossing->slope));
        if (closed) return JLT_OK;
    }
    /* Where errors of partial steps are larger than the orbit's motion, any point within them is as good as the zero. */
    if (event->value == NULL && least <= jlt_locate_noise(stepper->asked) * jlt_locate_unit(event, stepper)) {
        *theta = best;
        return jlt_locate_state(event, stepper, best, x, f, &crossing->residual, &crossing->slope);
    }
    return JLT_ERR_NO_CONVERGENCE;
}
