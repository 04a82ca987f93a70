/** Search for a real point that meets a list of conditions, or for a proof that there is none. */
#ifndef TTC_SEARCH_H
#define TTC_SEARCH_H

#include "algebra/witness.h"

typedef enum {
    TTC_POINT_FOUND,       /* and verified, exactly or in balls */
    TTC_POINT_IMPOSSIBLE,  /* there is none, by the signs of terms or factors */
    TTC_POINT_EXCLUDED,    /* there is none, according to the solvers for nonlinear real arithmetic */
    TTC_POINT_NOT_DECIDED
} ttc_search_result;

/** Try simple rational numbers, then elimination (elimination.h), then the solver, then more rational numbers.
 *  point: initialized for the valuation of the conditions; meaningful if FOUND.
 *  To the solver, functions are numbers within bounds: it may fail to exclude a point, but never excludes one that exists. */
ttc_search_result ttc_search_point(ttc_witness *point, const ttc_conditions *conditions);

/* Try the rational numbers of this attempt alone: 0, 1, ..., the simplest first. */
bool ttc_search_attempt(ttc_witness *point, const ttc_conditions *conditions, unsigned attempt);

/* Try rational numbers alone, from attempt number *attempt on, up to the first point that meets the conditions; *attempt becomes
 * the number of the attempt after it. Returns false if no attempt finds one; there are 600. */
bool ttc_search_next(ttc_witness *point, const ttc_conditions *conditions, unsigned *attempt);

/* Try the first 48 attempts, each with this value of a variable. */
bool ttc_search_with(ttc_witness *point, const ttc_conditions *conditions, slong variable, const fmpq_t value);

/* Returns true if a point is known to meet the conditions, and cosines and sines have the signs that were chosen. */
bool ttc_search_meets(ttc_witness *point, const ttc_conditions *conditions);

/** Search for a point that meets the conditions and at which a polynomial is zero: where one of its factors (of_squares: one of
 *  even exponent) changes its sign along one variable. Of that variable the point then has an interval that contains the zero (see
 *  `wide` in witness.h), unless a point that is tried first is a zero itself. */
bool ttc_search_zero(ttc_witness *point, const ttc_conditions *conditions, const fmpz_mpoly_t polynomial, bool of_squares);

/** Search for a point that meets the conditions, of which those from domain_count on say that a ratio is not positive. */
bool ttc_search_downhill(ttc_witness *point, const ttc_conditions *conditions, size_t domain_count, const ttc_ratio *ratio);

#endif
