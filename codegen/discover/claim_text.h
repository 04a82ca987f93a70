/** Writes polynomials of a flow's ring in the language of tables. */
#ifndef TTC_CLAIM_TEXT_H
#define TTC_CLAIM_TEXT_H

#include "base/text.h"
#include "discover/flow.h"

/* The terms by falling degree in the quantities, each coefficient as a product of irreducible factors. */
void ttc_claim_text_add(ttc_text *text, const ttc_flow *flow, const fmpz_mpoly_t polynomial);

/* A ratio, both parts as above, in parentheses where needed. */
void ttc_claim_text_add_ratio(ttc_text *text, const ttc_flow *flow, const ttc_ratio *ratio);

/* text with long lines broken before signs between terms, where the language allows it; continued lines are indented. */
void ttc_claim_text_wrap(ttc_text *out, const char *text);

#endif
