#include "integrate/rest.h"

#include <math.h>

double jlt_rest_slow(double tolerance)
{
    return fmax(JLT_REST_STILL, fmin(1e3 * tolerance, 1e-6));
}

static bool slower(const double *f, const double *x, unsigned count, double speed)
{
    for (unsigned i = 0; i < count; i++)
        if (!(fabs(f[i]) < speed * (fabs(x[i]) > 1 ? fabs(x[i]) : 1))) return false;
    return true;
}

bool jlt_rest_is_slower(const jlt_field *field, const double *x, double speed)
{
    double f[JLT_FIELD_DIM_MAX], pace = 1;

    field->call(x, field->p, f);
    if (field->time_rate != NULL) field->time_rate(x, field->p, &pace);
    return slower(f, x, field->dim, speed * pace);
}

static bool stepper_slower(const jlt_stepper *stepper, double speed)
{
    const unsigned dim = stepper->field->dim;
    const double pace = stepper->columns > dim ? stepper->f[dim] : 1;

    return slower(stepper->f, stepper->x, dim, speed * pace);
}

bool jlt_rest_is_slow(const jlt_stepper *stepper)
{
    return stepper_slower(stepper, jlt_rest_slow(stepper->asked));
}

bool jlt_rest_ends(const jlt_stepper *stepper, double *limit)
{
    static const double weakest = 1e-5; /* of the fastest rate: a weaker one may be none */
    jlt_approach approach;
    const bool decays = jlt_approach_judge(&approach, stepper) == JLT_OK && jlt_approach_is_known(&approach, stepper)
                        && approach.slowest > weakest * approach.fastest;

    if (!decays && !stepper_slower(stepper, JLT_REST_STILL)) return false;
    for (unsigned i = 0; i < stepper->field->dim; i++) limit[i] = stepper->x[i] - (decays ? approach.left[i] : 0);
    return true;
}
