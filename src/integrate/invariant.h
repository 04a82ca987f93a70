/** Functions that stay constant along the flow: watched, and restored on request. */
#ifndef JLT_INTEGRATE_INVARIANT_H
#define JLT_INTEGRATE_INVARIANT_H

#include "integrate/method.h"

enum { JLT_INVARIANTS_MAX = 8 };

/** All in one kernel: values (count,), gradients (count, dim). */
typedef struct {
    unsigned count; /* at most JLT_INVARIANTS_MAX */
    jlt_kernel_function values, gradients; /* gradients may be NULL where nothing is projected */
    const double *p;
} jlt_invariants;

typedef struct {
    double level[JLT_INVARIANTS_MAX]; /* at the start */
    double drift[JLT_INVARIANTS_MAX]; /* largest |F_i - level_i| / max(1, |level_i|) since */
} jlt_invariant_watch;

void jlt_invariant_begin(jlt_invariant_watch *self, const jlt_invariants *of, const double *x);

/** Put x (dim,) back onto the levels (count,) by two Gauss-Newton steps x <- x - W A^T (A W A^T)^-1 (F - level) with A the
 *  gradients and W the squares of the sizes of the states (dim,). false, x as it was: the gradients depend on each other there.
 *  dim <= JLT_FIELD_DIM_MAX. Cost: two evaluations of F and of the gradients. */
bool jlt_invariant_restore(double *x, const jlt_invariants *of, const double *level, const double *size, unsigned dim);

/** After an accepted step: note the drift, then, when asked, restore the levels. A drift at the rounding level is left
 *  alone, and so is a point that cannot be restored.
 *  Errors: NONFINITE. Cost: one evaluation of F; projected: a restoration and an evaluation of the field. */
JLT_CHECKED jlt_status jlt_invariant_watch_step(jlt_invariant_watch *self, const jlt_invariants *of, jlt_stepper *stepper,
                                                bool project);

#endif
