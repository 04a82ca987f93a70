/** Ends of intervals, which callers watch by themselves, or a kernel evaluates as conditions. */
#ifndef TTC_ENDS_H
#define TTC_ENDS_H

#include "fields/field.h"

/** Returns true if fields in this time (NULL: t) and with this elimination (NULL: none) have a condition for an end of the state's
 *  interval, TTC_NONE for none: one that is no number, of the eliminated state, or, beside lifted roots, a zero of none of them. A
 *  radicand that divides by zero there is not zero. */
bool ttc_end_is_condition(const ttc_model *model, const ttc_time *time, const ttc_elimination *elimination, uint32_t state,
                          ttc_id end);

#endif
