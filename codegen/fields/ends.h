/** Ends of intervals: which of them a kernel evaluates as conditions. Callers compare states with the others themselves. */
#ifndef TTC_ENDS_H
#define TTC_ENDS_H

#include "fields/field.h"

/** Returns true if fields in this time (NULL: t) and with this elimination (NULL: none) have a condition for an end of the state's
 *  interval; TTC_NONE: it has no such end. An end of the eliminated state is a condition. Any other is one, in a time that lifts
 *  roots, unless a lifted root is zero there (a radicand that divides by zero there is not); without lifted roots, if it is no
 *  number. */
bool ttc_end_is_condition(const ttc_model *model, const ttc_time *time, const ttc_elimination *elimination, uint32_t state,
                          ttc_id end);

#endif
