/** Irreducible polynomials that change along the motion, each once. */
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

/* Add a polynomial, or all its irreducible factors, but those without quantities, integrals, and known ones. */
void ttc_factors_add(ttc_factors *factors, const fmpz_mpoly_t polynomial);
void ttc_factors_add_all(ttc_factors *factors, const fmpz_mpoly_t polynomial);

/* The square of a root is the product of the factors of its radicand, so that one of these factors depends on the root and the
 * other factors. The first function drops the longest one; the second puts the radicand in place of those of its factors that are
 * listed. */
void ttc_factors_drop_radicands(ttc_factors *factors);
void ttc_factors_join_radicands(ttc_factors *factors);

#endif
