/** The conditions of the domain that kernels evaluate: the others are kept by whoever keeps parameters within their signs, lifted
 *  roots positive, and states within the ends of their intervals that are numbers. */
#ifndef TTC_WATCHED_H
#define TTC_WATCHED_H

#include "fields/field.h"

typedef struct {
    const char *name; /* of the record, or of the state whose interval ends */
    char *text;       /* what is positive */
    ttc_id expression;
} ttc_watched;

/** Records of `domain`, and ends of intervals that are no numbers, or of states that the field has not, or has beside lifted roots
 *  that do not vanish there. Out: *list, shape (*count,), for ttc_watched_destroy, also on failure. False: memory is out, or an
 *  expression too large. */
bool ttc_watched_find(ttc_watched **list, size_t *count, ttc_field *field);
void ttc_watched_destroy(ttc_watched *list, size_t count);

#endif
