/** Tools for rewriting sums in a scratch graph: signs of terms, common factors, and multiplying out above a given height. */
#ifndef TTC_NUMERATOR_H
#define TTC_NUMERATOR_H

#include "fields/scratch.h"

enum { TTC_TERMS_LIMIT = 64 }; /* terms of a sum that can be rewritten */

/** The sign of a term is `sign` times the signs of the factors `odd`: those of odd power whose sign is not known. Terms with
 *  equal lists `odd` have either always the same sign or always opposite ones. */
typedef struct {
    ttc_id odd[TTC_TERMS_LIMIT];
    size_t count;
    int sign; /* 1 or -1; 0: the term is zero, or has more factors than fit */
} ttc_signature;

void ttc_signature_of(ttc_signature *signature, ttc_scratch *scratch, ttc_id term);
bool ttc_signature_same(const ttc_signature *a, const ttc_signature *b); /* compares the lists `odd` alone */

/* Returns true if all terms of a sum have the same sign at every state; true for an expression that is not a sum. */
bool ttc_is_like_signed(ttc_scratch *scratch, ttc_id id);

/* Write the terms of a sum, its constant among them, to terms, shape (TTC_TERMS_LIMIT,). Returns their number; 0: too many. */
size_t ttc_terms_of(ttc_graph *graph, ttc_id *terms, ttc_id sum);

/* The product of the common factors of all terms, each with its least exponent, and of all denominators, each with its greatest
 * power. Returns TTC_NONE if there are too many factors. */
ttc_id ttc_common_factor(ttc_graph *graph, const ttc_id *terms, size_t count);

/** Replace squares of roots by radicands, and multiply out sums and units that are higher than `height` or are `chosen`, until
 *  none is left. Returns TTC_NONE if there are too many terms or passes, or if the graph fails. */
ttc_id ttc_multiply_out(ttc_scratch *scratch, ttc_id id, unsigned height, ttc_id chosen);

/* The sum or unit number k, from 0, among the factors of an expression's terms; one that occurs in several terms counts several
 * times. Returns TTC_NONE if there are k or fewer. */
ttc_id ttc_compound_factor(ttc_scratch *scratch, ttc_id id, size_t k);

#endif
