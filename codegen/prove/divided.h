/** Whether a claim divides by zero on a whole part of the domain: it says nothing there, but what uses it takes it with
 *  everything cancelled. A family may exist on a part alone. */
#ifndef TTC_DIVIDED_H
#define TTC_DIVIDED_H

#include "prove/subcase.h"

/** Of a leaf on which the claim has no value: whether it has points without the claim, or that was not excluded. at: such a
 *  point, for free(), or NULL. */
bool ttc_divided_by_zero(ttc_task *task, const ttc_subcase *leaf, char **at);

/* Of a leaf of which no point is known: whether the claim divides by what is zero if functions depend on each other. */
bool ttc_divided_perhaps(ttc_task *task, const ttc_subcase *leaf);

#endif
