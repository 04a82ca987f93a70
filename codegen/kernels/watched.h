/** The conditions of the domain that kernels evaluate. The others hold where callers keep the signs of parameters, lifted roots
 *  positive, and states within ends of intervals that are numbers. */
#ifndef TTC_WATCHED_H
#define TTC_WATCHED_H

#include "fields/field.h"

typedef struct {
    const char *name; /* of the record `domain`, or of the state whose interval ends */
    char *text;       /* as the table writes it, or "EXPRESSION > 0" */
    ttc_id expression; /* positive where the condition holds */
} ttc_watched;

/** Find the conditions: records `domain` that do not follow from others, and ends of intervals that are no numbers, belong to the
 *  eliminated state or, beside lifted roots, are zeros of none. Out: *list, shape (*count,), for ttc_watched_destroy, also on
 *  failure. Returns false when memory is out or an expression is too large. */
bool ttc_watched_find(ttc_watched **list, size_t *count, ttc_field *field);
/** Whether some root that the field lifts is zero at this end of the state's interval. A radicand that divides by zero there is
 *  not. */
bool ttc_watched_is_lifted(const ttc_field *field, uint32_t state, ttc_id end);
void ttc_watched_destroy(ttc_watched *list, size_t count);

#endif
