/** Finds products of powers of known factors that are integrals or densities. */
#ifndef TTC_RELATIONS_H
#define TTC_RELATIONS_H

#include "discover/discover.h"
#include "discover/factor_list.h"

/** Factors P_i are those found with a cofactor, `invariant`, states, roots, divisors of the equations, and `given`. The product of
 *  P_i^a_i is an integral if the sum of a_i P_i'/P_i is zero, a density if it is minus the divergence: linear algebra in a_i.
 *  Reported, if proved, are integrals independent of known ones, and a density if none is known. */
void ttc_relations_find(ttc_discovery *d, const ttc_factors *invariant, const ttc_id *given, size_t given_count);

#endif
