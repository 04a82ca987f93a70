/** A list of distinct irreducible polynomials that change along the motion. */
#ifndef TTC_FACTOR_LIST_H
#define TTC_FACTOR_LIST_H

#include "discover/flow.h"

enum { TTC_FACTORS_MAX = 128 };

typedef struct {
    const ttc_flow *flow;
    fmpz_mpoly_struct items[TTC_FACTORS_MAX];
    size_t count;
    bool is_full; /* some were left out because the list is full */
} ttc_factors;

void ttc_factors_init(ttc_factors *factors, const ttc_flow *flow);
void ttc_factors_clear(ttc_factors *factors);

/* Add a polynomial, or with _all its irreducible factors. Those without quantities, integrals, and those in the list are
 * skipped. */
void ttc_factors_add(ttc_factors *factors, const fmpz_mpoly_t polynomial);
void ttc_factors_add_all(ttc_factors *factors, const fmpz_mpoly_t polynomial);

/* The square of a root is the product of the factors of its radicand. `drop` removes the longest of these factors, which depends on
 * the root and the others; `join` replaces those that are in the list by the radicand. */
void ttc_factors_drop_radicands(ttc_factors *factors);
void ttc_factors_join_radicands(ttc_factors *factors);

#endif
