/** Lists of polynomial conditions on the real points of a ring, which describe a domain and questions about it.
 *
 *  Beside the listed conditions, a point obeys the relations of the ring: a root is positive, its square is its radicand, and
 *  cosines and sines are those of their angle. A condition that follows from the signs of its terms is not stored; one that
 *  contradicts them marks the whole list as contradictory. */
#ifndef TTC_CONDITIONS_H
#define TTC_CONDITIONS_H

#include "algebra/valuation.h"

typedef enum { TTC_IS_POSITIVE, TTC_IS_NONNEGATIVE, TTC_IS_NONZERO, TTC_IS_ZERO } ttc_relation;

typedef struct {
    fmpz_mpoly_t polynomial;
    ttc_relation relation;
    bool of_quotient;    /* comes from a ratio, and says nothing where the ratio's denominator vanishes */
    bool is_denominator; /* NONZERO of such a denominator, added only because the ratio is written as a quotient */
} ttc_condition;

typedef struct {
    ttc_valuation *valuation; /* borrowed */
    ttc_ring *ring;
    ttc_condition *items;
    size_t count;
    bool contradictory; /* the signs of terms show that no point meets the conditions */
    bool at_denominator; /* made by ttc_conditions_at_denominator; the solver is then not told the square of a root if this has a
                            denominator that may be zero, only the root's sign */
    bool failed;        /* memory is out; the list is incomplete */
} ttc_conditions;

void ttc_conditions_init(ttc_conditions *conditions, ttc_valuation *valuation);
void ttc_conditions_clear(ttc_conditions *conditions);

/* Require that ratio > 0, >= 0, != 0 or = 0, and that its denominator is not zero. The expression may have a value where the
 * denominator of its normal form vanishes: finding no point does not exclude points there, see ttc_conditions_at_denominator. */
void ttc_conditions_add(ttc_conditions *conditions, const ttc_ratio *ratio, ttc_relation relation);

/* ttc_conditions_add for -ratio. */
void ttc_conditions_add_negative(ttc_conditions *conditions, const ttc_ratio *ratio, ttc_relation relation);

/** Make the list of conditions for points at which denominator number `index` vanishes: that it is zero; those conditions that do
 *  not come from quotients; and A B >= 0 for each condition A/B > 0 or A/B >= 0. Denominators are those of conditions, then those
 *  of squares of roots that are used. Returns the denominator, borrowed, or NULL if there is none of this number: the list then has
 *  the other conditions alone. out is to be cleared in either case. */
const fmpz_mpoly_struct *ttc_conditions_at_denominator(ttc_conditions *out, const ttc_conditions *conditions, size_t index);

/* Copy all conditions but those of relation NONZERO; of these only denominators (is_denominator) are copied. out: to be cleared. */
void ttc_conditions_of_signs(ttc_conditions *out, const ttc_conditions *conditions);

/* The length of the list; and removal of the conditions after that length, which were added to ask a question. */
size_t ttc_conditions_mark(const ttc_conditions *conditions);
void ttc_conditions_rewind(ttc_conditions *conditions, size_t mark, bool contradictory);

/** A set of signs. The functions below return sets: the signs that a relation allows, that of a number, those of products, sums and
 *  powers of values with signs in given sets, and those that a polynomial can have by the signs of its variables alone. */
typedef enum { TTC_CAN_BE_NEGATIVE = 1, TTC_CAN_BE_ZERO = 2, TTC_CAN_BE_POSITIVE = 4, TTC_CAN_BE_ANY = 7 } ttc_sign_set;
unsigned ttc_conditions_signs_in(ttc_relation relation);
unsigned ttc_conditions_sign_of(const fmpq_t value);
unsigned ttc_conditions_signs_of_product(unsigned a, unsigned b);
unsigned ttc_conditions_signs_of_sum(unsigned a, unsigned b);
unsigned ttc_conditions_signs_of_power(unsigned signs, unsigned long exponent);
unsigned ttc_conditions_signs(const ttc_conditions *conditions, const fmpz_mpoly_t polynomial);

/* Returns true if no point meets the conditions, by the signs of terms, or because two of them contradict each other about one
 * polynomial. */
bool ttc_conditions_clash(const ttc_conditions *conditions);

/* The signs that a ratio can have where the conditions hold, as far as they tell signs of its factors: 1 - z^2 = (1 - z) (1 + z) is
 * positive where both ends of an interval say so. */
unsigned ttc_conditions_signs_of_ratio(const ttc_conditions *conditions, const ttc_ratio *ratio);

#endif
