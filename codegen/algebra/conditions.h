/** Polynomial conditions on the real points of a ring: what a domain is, and what is asked of it.
 *
 *  Beside the conditions that are listed, a point obeys the ring: a root is positive, its square is its radicand, and cosines
 *  and sines are those of their angle. A condition that follows from the signs of its terms is not kept; one that contradicts
 *  them makes the whole list contradictory, without any search. */
#ifndef TTC_CONDITIONS_H
#define TTC_CONDITIONS_H

#include "algebra/valuation.h"

typedef enum { TTC_IS_POSITIVE, TTC_IS_NONNEGATIVE, TTC_IS_NONZERO, TTC_IS_ZERO } ttc_relation;

typedef struct {
    fmpz_mpoly_t polynomial;
    ttc_relation relation;
    bool of_quotient;    /* says nothing where the denominator of the ratio that it came from vanishes */
    bool is_denominator; /* not zero, for no other reason than that a ratio was written so */
} ttc_condition;

typedef struct {
    ttc_valuation *valuation; /* borrowed */
    ttc_ring *ring;
    ttc_condition *items;
    size_t count;
    bool contradictory; /* no point, evidently */
    bool at_denominator; /* where a denominator vanishes: of roots whose square may be divided by zero only the sign is known */
    bool failed;        /* memory is out; the list is of no use */
} ttc_conditions;

void ttc_conditions_init(ttc_conditions *conditions, ttc_valuation *valuation);
void ttc_conditions_clear(ttc_conditions *conditions);

/* Add that a ratio stands in a relation to zero, and that its denominator is not zero. A value may exist where the denominator
 * of its normal form vanishes: that no point was found then says nothing of those, see ttc_conditions_at_denominator. */
void ttc_conditions_add(ttc_conditions *conditions, const ttc_ratio *ratio, ttc_relation relation);

/* The same for the opposite of a ratio. */
void ttc_conditions_add_negative(ttc_conditions *conditions, const ttc_ratio *ratio, ttc_relation relation);

/** The conditions that hold where denominator number `index` vanishes, of a condition or of the square of a root, as far as they
 *  are known there. False: there is no such denominator. out: to be cleared. */
bool ttc_conditions_at_denominator(ttc_conditions *out, const ttc_conditions *conditions, size_t index);

/* Those that say more than that something is not zero. out: to be cleared. */
void ttc_conditions_of_signs(ttc_conditions *out, const ttc_conditions *conditions);

/* The present length of the list, and back to it: conditions that were added to ask a question are removed again. */
size_t ttc_conditions_mark(const ttc_conditions *conditions);
void ttc_conditions_rewind(ttc_conditions *conditions, size_t mark, bool contradictory);

/** The signs that a polynomial may have as far as the signs of its variables tell: bits of ttc_sign_set. */
typedef enum { TTC_CAN_BE_NEGATIVE = 1, TTC_CAN_BE_ZERO = 2, TTC_CAN_BE_POSITIVE = 4, TTC_CAN_BE_ANY = 7 } ttc_sign_set;
unsigned ttc_conditions_signs_in(ttc_relation relation);
unsigned ttc_conditions_signs_of_product(unsigned a, unsigned b);
unsigned ttc_conditions_signs_of_sum(unsigned a, unsigned b);
unsigned ttc_conditions_signs_of_power(unsigned signs, unsigned long exponent);
unsigned ttc_conditions_signs(const ttc_conditions *conditions, const fmpz_mpoly_t polynomial);

#endif
