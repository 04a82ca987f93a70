/** A guard around floating-point work: an overflow, a lost underflow or an undefined operation inside it becomes a status.
 *
 *      jlt_guard guard;
 *      jlt_guard_enter(&guard);
 *      ... calls through pointers or into other files (the compiler may move arithmetic of the same function) ...
 *      st = jlt_guard_leave(&guard);
 *
 *  Inside, traps are off and the rounding mode is to nearest. The caller's environment, raised flags included, is
 *  restored on leaving, so guards nest, and the flags of guarded work never reach the caller. */
#ifndef JLT_CORE_GUARD_H
#define JLT_CORE_GUARD_H

#include "core/status.h"

#include <fenv.h>

typedef struct {
    fenv_t saved;
} jlt_guard;

void jlt_guard_enter(jlt_guard *guard);

/** Returns JLT_OK; DOMAIN when there was a division by zero or an invalid operation; NONFINITE when a result overflowed, or
 *  underflowed and lost digits. Must be called once for every enter. */
JLT_CHECKED jlt_status jlt_guard_leave(jlt_guard *guard);

#endif
