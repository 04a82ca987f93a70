/** Terms of a sum put over one denominator, and their numerator multiplied out as far as a level says; all in a scratch
 *  graph. */
#ifndef TTC_NUMERATOR_H
#define TTC_NUMERATOR_H

#include "fields/scratch.h"

enum { TTC_TERMS_LIMIT = 64 }; /* of a sum whose terms are compared with each other */

/** The sign of a term, and what it has the sign of: symbols and sums of either sign that it holds to an odd power. Two terms
 *  with equal lists differ, if at all, by the sign `sign`. */
typedef struct {
    ttc_id odd[TTC_TERMS_LIMIT];
    size_t count;
    int sign; /* 1 or -1; 0: the term is zero, or has more factors than fit */
} ttc_signature;

void ttc_signature_of(ttc_signature *signature, ttc_scratch *scratch, ttc_id term);
bool ttc_signature_same(const ttc_signature *a, const ttc_signature *b); /* the lists alone */

/* True when no two terms of the expression can have opposite signs; true for whatever is not a sum. */
bool ttc_is_like_signed(ttc_scratch *scratch, ttc_id id);

/* Terms of a sum with their coefficients, its constant among them; shape (TTC_TERMS_LIMIT,). 0: it has too many. */
size_t ttc_terms_of(ttc_graph *graph, ttc_id *terms, ttc_id sum);

/* The product of all factors that every term has, with the least power; powers may be negative. TTC_NONE: too many. */
ttc_id ttc_common_factor(ttc_graph *graph, const ttc_id *terms, size_t count);

/** Powers of roots above the first replaced by radicands, and sums and units multiplied out that are higher than `height`, or
 *  are `chosen`, until nothing is left to do. TTC_NONE: more terms than the limit, or memory. */
ttc_id ttc_multiply_out(ttc_scratch *scratch, ttc_id id, unsigned height, ttc_id chosen);

/* The k-th sum or unit among the factors of an expression's terms; one that occurs several times is counted each time. TTC_NONE:
 * there are k or fewer. */
ttc_id ttc_compound_factor(ttc_scratch *scratch, ttc_id id, size_t k);

#endif
