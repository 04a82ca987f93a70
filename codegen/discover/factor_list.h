/** Irreducible polynomials that move, each once. */
#ifndef TTC_FACTOR_LIST_H
#define TTC_FACTOR_LIST_H

#include "discover/flow.h"

enum { TTC_FACTORS_MAX = 128 };

typedef struct {
    const ttc_flow *flow;
    fmpz_mpoly_struct items[TTC_FACTORS_MAX];
    size_t count;
    bool is_full; /* some were left out, for want of room */
} ttc_factors;

void ttc_factors_init(ttc_factors *factors, const ttc_flow *flow);
void ttc_factors_clear(ttc_factors *factors);

/* A polynomial, or its irreducible factors: what does not move, or is an integral, or there already, is passed over. */
void ttc_factors_add(ttc_factors *factors, const fmpz_mpoly_t polynomial);
void ttc_factors_add_all(ttc_factors *factors, const fmpz_mpoly_t polynomial);

/* The square of a root is the product of the factors of its radicand. Either takes out the longest of them, which says nothing
 * beside the root and the others; or puts the radicand in place of those that are there. */
void ttc_factors_drop_radicands(ttc_factors *factors);
void ttc_factors_join_radicands(ttc_factors *factors);

#endif
