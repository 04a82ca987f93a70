/** Translates expressions into a short straight-line program on the prepared values. */
#ifndef TTC_OPTIMIZE_H
#define TTC_OPTIMIZE_H

#include "fields/prepared.h"
#include "optimize/program.h"

/* What a program is for. */
typedef enum {
    TTC_FOR_STEPS, /* one orbit, or many side by side: one division for all denominators that do not depend on each other, and
                      none that waits for a root if that takes at most a thirtieth more work */
    TTC_FOR_POINTS, /* one state: the same, but separate divisions if each saves at least four operations */
    TTC_FOR_VALUES, /* one state: separate divisions, so that where one divides by zero the other outputs keep their values */
    TTC_FOR_JETS    /* Taylor recurrences: the fewest operations, and separate divisions, which cost as much as products there; a
                      reciprocal recovered from a common one would have the rounding errors of its fastest growing coefficients */
} ttc_purpose;

/* How long the search for a short program may take. QUICK tries a few of the ways that FULL tries. */
typedef enum { TTC_EFFORT_QUICK, TTC_EFFORT_FULL } ttc_effort;

/** Make a program that computes outputs, in the field's symbols, from states and prepared values, which it adds to `prepared`.
 *  other: the same functions in another form, a second start; may be NULL.
 *  Returns NULL when memory is out. Cost: a fixed amount of search, see the table of efforts in optimize.c. */
ttc_program *ttc_optimize(ttc_field *field, const ttc_id *outputs, const ttc_id *other, size_t count, ttc_purpose purpose,
                          ttc_effort effort, ttc_prepared *prepared);

#endif
