#include "integrate/invariant.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "integrate/step_control.h"

#define JLT_LANES 1
#include "integrate/invariant_step.inc"

enum { COUNT = JLT_INVARIANTS_MAX };

void jlt_invariant_begin(jlt_invariant_watch *self, const jlt_invariants *of, const double *x)
{
    *self = (jlt_invariant_watch){ .drift = { 0 } };
    if (of->count > 0) of->values(x, of->p, self->level);
}

/* Make one Gauss-Newton step on x. */
static void approach(double *x, const jlt_invariants *of, const double *level, const double *size, unsigned dim)
{
    double gradient[COUNT * JLT_FIELD_DIM_MAX], values[COUNT];
    jlt_lanes off[COUNT], weight[JLT_FIELD_DIM_MAX];

    of->gradients(x, of->p, gradient);
    of->values(x, of->p, values);
    for (unsigned i = 0; i < of->count; i++) off[i] = jlt_lanes_of(values[i] - level[i]);
    for (unsigned k = 0; k < dim; k++) weight[k] = jlt_lanes_of(size[k] * size[k]);
    step_to_levels(x, gradient, off, weight, dim, of->count);
}

void jlt_invariant_restore(double *x, const jlt_invariants *of, const double *level, const double *size, unsigned dim)
{
    double near[JLT_FIELD_DIM_MAX], defect = 0;

    memcpy(near, x, dim * sizeof *x);
    for (unsigned round = 0; round < 2; round++) approach(near, of, level, size, dim);
    for (unsigned k = 0; k < dim; k++) defect += 0 * near[k];
    if (defect == 0) memcpy(x, near, dim * sizeof *x);
}

/* The size in which a change of state k is measured: 0 where it stays 0, by itself or with a group, lest it grow from there. */
static double size_of(const jlt_stepper *stepper, unsigned k)
{
    const jlt_field *field = stepper->field;
    const double value = fabs(stepper->x[k]);

    if (jlt_field_keeps(field, k)) return value;
    if (!isfinite(stepper->scale[k]) || !(jlt_field_group_size(field, stepper->x, k) > 0)) return 0;
    return fmax(value, stepper->scale[k]);
}

jlt_status jlt_invariant_watch_step(jlt_invariant_watch *self, const jlt_invariants *of, jlt_stepper *stepper, bool project)
{
    const unsigned dim = stepper->field->dim;
    double now[COUNT], x[JLT_FIELD_DIM_MAX], size[JLT_FIELD_DIM_MAX];
    bool off = false;

    of->values(stepper->x, of->p, now);
    for (unsigned i = 0; i < of->count; i++) {
        const double level = fabs(self->level[i]), drift = fabs(now[i] - self->level[i]);
        self->drift[i] = jlt_larger(drift / jlt_larger(level, 1), self->drift[i]);
        off = off || drift > 4 * DBL_EPSILON * (stepper->size < 1 ? level : jlt_larger(level, 1));
    }
    if (!project || !off) return JLT_OK;
    memcpy(x, stepper->x, dim * sizeof *x);
    for (unsigned k = 0; k < dim; k++) size[k] = size_of(stepper, k);
    jlt_invariant_restore(x, of, self->level, size, dim);
    return jlt_stepper_replace(stepper, x, NULL);
}
