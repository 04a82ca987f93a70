/** Steps across jumps of rates, for methods. */
#ifndef JLT_INTEGRATE_LEAP_H
#define JLT_INTEGRATE_LEAP_H

#include "integrate/step_control.h"
#include "integrate/stepper.h"

enum { JLT_LEAPS = 4 };

/** Whether a step h to `end`, shape (columns,), is taken whatever its error estimate: time hardly resolves a shorter one, and this
 *  one moves no state by more than a billionth of its size. A rate, or its slope, then jumps in it, and the error is at most that
 *  of rounding time. After JLT_LEAPS such steps one must become longer, which fails where an orbit slides along a jump. */
static inline bool jlt_leap_is_taken(jlt_stepper *self, double h, const double *end)
{
    if (!jlt_step_is_short(self->tau, h) || self->leaps >= JLT_LEAPS) return false;
    for (unsigned i = 0; i < self->columns; i++)
        if (!(fabs(end[i] - self->x[i]) <= 1e-9 * jlt_larger(fabs(self->x[i]), self->scale[i]))) return false;
    self->leaps++;
    return true;
}

#endif
