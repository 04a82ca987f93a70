#include "integrate/edge.h"

#include <math.h>

#include "integrate/step_control.h"

enum { SAMPLES = 16, BISECTIONS = 60 };

static double distance(double x, double end, double side, double scale)
{
    const double size = jlt_larger(fabs(end), scale > 0 ? scale : 1);
    return (side * (x - end) - JLT_FIELD_NEAREST * fabs(end)) / size;
}

/* Of the point where theta is 1, else of the polynomial. NaN counts as outside. */
static double distance_at(const jlt_stepper *stepper, double theta)
{
    const jlt_field *field = stepper->field;
    double least = INFINITY;

    for (unsigned i = 0; field->domain != NULL && i < field->dim; i++) {
        const double low = field->domain[i].low, high = field->domain[i].high, scale = field->scale != NULL ? field->scale[i] : 1;
        if (!isfinite(low) && !isfinite(high)) continue;
        const double x = theta == 1 ? stepper->x[i] : jlt_stepper_value(stepper, i, theta);
        const double above = isfinite(low) ? distance(x, low, 1, scale) : INFINITY;
        const double below = isfinite(high) ? distance(x, high, -1, scale) : INFINITY;
        if (!(above >= least)) least = above;
        if (!(below >= least)) least = below;
    }
    return least;
}

double jlt_edge_distance(const jlt_stepper *stepper)
{
    return distance_at(stepper, 1);
}

double jlt_edge_near(const jlt_stepper *stepper)
{
    return jlt_larger(stepper->asked, 0x1p-46); /* a distance from an end has no more digits */
}

jlt_status jlt_edge_find(double *theta, jlt_stepper *stepper)
{
    const double wanted = jlt_edge_near(stepper) / 2;
    double inside = 0, outside = 1;
    const jlt_status st = jlt_stepper_dense(stepper);

    if (st != JLT_OK) return st;
    for (int k = 1; k < SAMPLES; k++) {
        const double at = (double)k / SAMPLES;
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
