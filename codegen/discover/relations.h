/** Products of powers of known factors that are integrals, or densities. */
#ifndef TTC_RELATIONS_H
#define TTC_RELATIONS_H

#include "discover/discover.h"
#include "discover/factor_list.h"

/** Factors are what was found with a cofactor, `invariant`, states, roots, what equations divide by, and `given`. A product of
 *  powers a_i of P_i is an integral where the sum of a_i P_i'/P_i is zero, and a density where it is minus the divergence: linear
 *  algebra in a_i. Those of each kind that depend on no others known are said, if they are proved. */
void ttc_relations_find(ttc_discovery *d, const ttc_factors *invariant, const ttc_id *given, size_t given_count);

#endif
