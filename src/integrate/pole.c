#include "integrate/pole.h"

#include <math.h>

/* A point is judged only if the root and all rates, relative to scale, are this small, or rates below ten tolerances: a method at
 * its limit of stability keeps decayed states at some tolerances. */
static const double near_root = 1e-8, near_rest = 1e-6;
enum { JUDGED_STEPS = 8 }; /* of so many steps one is judged: eigenvalues cost more than a step */

jlt_status jlt_pole_judge(jlt_pole_verdict *out, const jlt_stepper *stepper)
{
    const jlt_field *field = stepper->field;

    out->ends = false;
    if (field->root < 0) return JLT_OK;

    const double s = stepper->x[field->root], rate = stepper->f[field->root];
    if (!(s < near_root)) return JLT_OK;
    const double slow = fmax(near_rest, 10 * stepper->asked);
    for (unsigned i = 0; i < field->dim; i++)
        if (!(fabs(stepper->f[i]) < slow * jlt_approach_size(stepper, i))) return JLT_OK;
    out->mu = s > 0 ? -rate / s * stepper->direction : INFINITY;
    if (!(out->mu > 0) || out->near++ % JUDGED_STEPS != 0) return JLT_OK;

    JLT_PASS(jlt_approach_judge(&out->approach, stepper));
    out->ends = jlt_approach_is_known(&out->approach, stepper);
    /* A field with a root has a time of its own. */
    const double time_rate = stepper->columns > field->dim ? stepper->f[field->dim] : 1;
    out->t_end = jlt_stepper_time(stepper) + (s > 0 ? stepper->direction * time_rate / out->mu : 0);
    return JLT_OK;
}
