#include "integrate/invariant.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "integrate/step_control.h"

enum { COUNT = JLT_INVARIANTS_MAX };

void jlt_invariant_begin(jlt_invariant_watch *self, const jlt_invariants *of, const double *x)
{
    *self = (jlt_invariant_watch){ .drift = { 0 } };
    if (of->count > 0) of->values(x, of->p, self->level);
}

/* Solve the symmetric positive system in place by Gaussian elimination. Rows that depend on those before, to 1e-12, get zeros. */
static void solve(double a[COUNT][COUNT], double *b, unsigned n)
{
    double inverse[COUNT], whole[COUNT];

    for (unsigned k = 0; k < n; k++) whole[k] = a[k][k];
    for (unsigned k = 0; k < n; k++) {
        inverse[k] = a[k][k] > 1e-12 * whole[k] ? 1 / a[k][k] : 0;
        for (unsigned i = k + 1; i < n; i++) {
            const double factor = a[i][k] * inverse[k];
            for (unsigned j = k; j < n; j++) a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (unsigned k = n; k-- > 0;) {
        for (unsigned j = k + 1; j < n; j++) b[k] -= a[k][j] * b[j];
        b[k] *= inverse[k];
    }
}

/* Make one Gauss-Newton step on x. */
static void approach(double *x, const jlt_invariants *of, const double *level, const double *size, unsigned dim)
{
    const unsigned n = of->count;
    double gradient[COUNT * JLT_FIELD_DIM_MAX], gram[COUNT][COUNT], off[COUNT];

    of->gradients(x, of->p, gradient);
    of->values(x, of->p, off);
    for (unsigned i = 0; i < n; i++) {
        off[i] -= level[i];
        for (unsigned j = 0; j < n; j++) {
            gram[i][j] = 0;
            for (unsigned k = 0; k < dim; k++)
                gram[i][j] += gradient[i * dim + k] * size[k] * size[k] * gradient[j * dim + k];
        }
    }
    solve(gram, off, n);
    for (unsigned k = 0; k < dim; k++)
        for (unsigned i = 0; i < n; i++) x[k] -= size[k] * size[k] * gradient[i * dim + k] * off[i];
}

void jlt_invariant_restore(double *x, const jlt_invariants *of, const double *level, const double *size, unsigned dim)
{
    double near[JLT_FIELD_DIM_MAX], defect = 0;

    memcpy(near, x, dim * sizeof *x);
    for (unsigned round = 0; round < 2; round++) approach(near, of, level, size, dim);
    for (unsigned k = 0; k < dim; k++) defect += 0 * near[k];
    if (defect == 0) memcpy(x, near, dim * sizeof *x);
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
    for (unsigned k = 0; k < dim; k++) size[k] = isfinite(stepper->scale[k]) ? fmax(fabs(x[k]), stepper->scale[k]) : 0;
    jlt_invariant_restore(x, of, self->level, size, dim);
    return jlt_stepper_replace(stepper, x, NULL);
}
