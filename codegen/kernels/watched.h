/** The conditions of the domain that kernels evaluate. The others hold where callers keep the signs of parameters, lifted roots
 *  positive, and states within ends of intervals that are numbers. */
#ifndef TTC_WATCHED_H
#define TTC_WATCHED_H

#include "fields/ends.h"

typedef struct {
    const char *name; /* of the record `domain`, or of the state whose interval ends */
    char *text;       /* as the table writes it, or "EXPRESSION > 0" */
    ttc_id expression; /* positive where the condition holds */
} ttc_watched;

/** Find the conditions: records `domain` that do not follow from others, and ends of intervals (fields/ends.h). Out: *list, shape
 *  (*count,), for ttc_watched_destroy, also on failure. Returns false when memory is out or an expression is too large. */
bool ttc_watched_find(ttc_watched **list, size_t *count, ttc_field *field);
void ttc_watched_destroy(ttc_watched *list, size_t count);

#endif
