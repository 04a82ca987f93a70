/** Invariants, functions that stay constant along the flow: their drift is watched, and states are put back onto their
 *  levels. */
#ifndef JLT_INTEGRATE_INVARIANT_H
#define JLT_INTEGRATE_INVARIANT_H

#include "integrate/method.h"

enum { JLT_INVARIANTS_MAX = 8 };

/** One kernel gives all values, shape (count,), and one all gradients, shape (count, dim). */
typedef struct {
    unsigned count; /* at most JLT_INVARIANTS_MAX */
    jlt_kernel_function values, gradients; /* gradients may be NULL where nothing is projected */
    const double *p;
} jlt_invariants;

typedef struct {
    double level[JLT_INVARIANTS_MAX]; /* at the start */
    double drift[JLT_INVARIANTS_MAX]; /* largest |F_i - level_i| / max(1, |level_i|) since */
} jlt_invariant_watch;

/** Take the levels at x, shape (dim,), and begin to watch. */
void jlt_invariant_begin(jlt_invariant_watch *self, const jlt_invariants *of, const double *x);

/** Put x, shape (dim,), back onto the levels, shape (count,), by two Gauss-Newton steps x <- x - W A^T (A W A^T)^-1 (F -
 *  level), where A holds the gradients and W the squares of the sizes of the states, `size`, shape (dim,). dim <=
 *  JLT_FIELD_DIM_MAX. An invariant whose gradient depends linearly on those of the invariants before it is skipped. x is unchanged
 *  where the result is not finite.
 *  Cost: two evaluations of F and of the gradients. */
void jlt_invariant_restore(double *x, const jlt_invariants *of, const double *level, const double *size, unsigned dim);

/** Call after an accepted step: it records the drift and, with `project`, puts the stepper's point back onto the levels. A
 *  drift at the rounding level, of 1 or, for an orbit far below 1 (jlt_field_size), of the level, is left alone.
 *  Errors: NONFINITE. Cost: one evaluation of F; with `project` those of jlt_invariant_restore and one of the field as well. */
JLT_CHECKED jlt_status jlt_invariant_watch_step(jlt_invariant_watch *self, const jlt_invariants *of, jlt_stepper *stepper,
                                                bool project);

#endif
