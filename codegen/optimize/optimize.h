/** From expressions to a short straight-line program on the prepared values. */
#ifndef TTC_OPTIMIZE_H
#define TTC_OPTIMIZE_H

#include "fields/prepared.h"
#include "optimize/program.h"

/* What a program is for. */
typedef enum {
    TTC_FOR_STEPS, /* one orbit, or many side by side: one division for all denominators that do not need each other, and none
                      that waits for a root, where this takes at most a thirtieth more work */
    TTC_FOR_POINTS, /* one state: the same, but several divisions where they save at least four operations each */
    TTC_FOR_JETS    /* Taylor recurrences: one division, and the fewest operations */
} ttc_purpose;

/* How long the search for a short program may take. QUICK: a few of the ways that FULL tries. */
typedef enum { TTC_EFFORT_QUICK, TTC_EFFORT_FULL } ttc_effort;

/** The outputs, in the field's symbols, as a program on states and the prepared values, to which entries are added.
 *  other: the same functions written differently, a second place to start from; may be NULL.
 *  Returns NULL when memory is out. Cost: a fixed amount of search, see the table of efforts in optimize.c. */
ttc_program *ttc_optimize(ttc_field *field, const ttc_id *outputs, const ttc_id *other, size_t count, ttc_purpose purpose,
                          ttc_effort effort, ttc_prepared *prepared);

#endif
