/** Tests whether a claim divides by zero on a whole part of the domain: it says nothing there, but kernels and other claims use
 *  it with everything cancelled. Families of equilibria are exempt: they may exist on a part of the domain alone. */
#ifndef TTC_DIVIDED_H
#define TTC_DIVIDED_H

#include "prove/subcase.h"

/** For a leaf on which the claim has no value: returns true if the claim has divisors of its own, and it is not shown that the leaf
 *  has no points when these are disregarded. *at then receives such a point, for free(), or NULL if none was found. */
bool ttc_divided_by_zero(ttc_task *task, const ttc_subcase *leaf, char **at);

/* For a leaf without a known point: returns true if the claim has a divisor that may be zero by unknown relations of functions. */
bool ttc_divided_perhaps(ttc_task *task, const ttc_subcase *leaf);

#endif
