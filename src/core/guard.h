/** Looks for numbers that are not finite, and turns floating-point exceptions into a status: an overflow, an underflow that loses
 *  digits, or an undefined operation.
 *
 *      jlt_guard guard;
 *      jlt_guard_enter(&guard);
 *      ... calls through pointers or into other files (the compiler may move arithmetic of the same function) ...
 *      st = jlt_guard_leave(&guard);
 *
 *  Inside, traps are off and the rounding mode is to nearest. Leaving restores the caller's environment, raised flags included:
 *  guards nest, and flags of guarded work never reach the caller. */
#ifndef JLT_CORE_GUARD_H
#define JLT_CORE_GUARD_H

#include "core/status.h"

#include <fenv.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/** Whether all of these numbers, shape (count,), are finite. */
static inline bool jlt_guard_finite(const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(values[i])) return false;
    return true;
}

typedef struct {
    fenv_t saved;
} jlt_guard;

/** Save the caller's floating-point environment and clear the exception flags. */
void jlt_guard_enter(jlt_guard *guard);

/** Restore the caller's environment; call it exactly once for every enter. Returns JLT_OK; DOMAIN if there was a division by zero
 *  or an invalid operation; else NONFINITE if a result overflowed, or underflowed and lost digits. */
JLT_CHECKED jlt_status jlt_guard_leave(jlt_guard *guard);

/** As jlt_guard_leave, for results that the caller tests for finiteness itself: NONFINITE if there was an overflow on the way,
 *  which a quotient can hide; else JLT_OK. */
JLT_CHECKED jlt_status jlt_guard_leave_finite(jlt_guard *guard);

#endif
