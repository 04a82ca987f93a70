/** Extents: the signs that a value can have on the whole domain, and bounds on it.
 *
 *  Every operation is conservative: its result contains the results for all values within its operands, as bounds are rounded
 *  outwards. */
#ifndef TTC_EXTENT_H
#define TTC_EXTENT_H

#include <stdbool.h>

#include <flint/fmpq.h>

/* Bits of a set of signs. */
enum { TTC_SIGN_NEGATIVE = 1, TTC_SIGN_ZERO = 2, TTC_SIGN_POSITIVE = 4, TTC_SIGN_ANY = 7 };

typedef struct {
    unsigned char signs; /* the possible signs; 0 only in tables of extents, for one that is not computed yet */
    double low, high;    /* lower and upper bound, infinite if none is known */
} ttc_extent;

extern const ttc_extent ttc_extent_any;

ttc_extent ttc_extent_of_number(const fmpq_t value);
ttc_extent ttc_extent_of_signs(unsigned char signs);
ttc_extent ttc_extent_negate(ttc_extent a);
ttc_extent ttc_extent_add(ttc_extent a, ttc_extent b);
ttc_extent ttc_extent_multiply(ttc_extent a, ttc_extent b);
/* a^exponent, tighter than a product: even powers are not negative. For exponent < 0 the value is taken to be nonzero. */
ttc_extent ttc_extent_power(ttc_extent a, long exponent);
ttc_extent ttc_extent_root(ttc_extent radicand);
/* The intersection; a if the two have no sign in common. */
ttc_extent ttc_extent_meet(ttc_extent a, ttc_extent b);

bool ttc_extent_is_nonnegative(ttc_extent a);
bool ttc_extent_is_nonpositive(ttc_extent a);
bool ttc_extent_is_positive(ttc_extent a);

#endif
