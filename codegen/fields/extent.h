/** What is known of a value on the whole domain: the signs it can have, and bounds.
 *
 *  Everything here errs on the side of knowing less: the true values are always among those described. */
#ifndef TTC_EXTENT_H
#define TTC_EXTENT_H

#include <stdbool.h>
#include <stddef.h>

#include <flint/fmpq.h>

/* Signs, to be combined. */
enum { TTC_SIGN_NEGATIVE = 1, TTC_SIGN_ZERO = 2, TTC_SIGN_POSITIVE = 4, TTC_SIGN_ANY = 7 };

typedef struct {
    unsigned char signs; /* those it can have; 0 only for what is not yet known at all */
    double low, high;    /* bounds, infinite where there is none */
} ttc_extent;

extern const ttc_extent ttc_extent_any;

ttc_extent ttc_extent_of_number(const fmpq_t value);
ttc_extent ttc_extent_of_signs(unsigned char signs);
ttc_extent ttc_extent_negate(ttc_extent a);
ttc_extent ttc_extent_add(ttc_extent a, ttc_extent b);
ttc_extent ttc_extent_multiply(ttc_extent a, ttc_extent b);
/* Powers of one value: tighter than products, for even ones are never negative. The value is not zero if exponent < 0. */
ttc_extent ttc_extent_power(ttc_extent a, long exponent);
ttc_extent ttc_extent_root(ttc_extent radicand);
/* The values that lie in both. */
ttc_extent ttc_extent_meet(ttc_extent a, ttc_extent b);

bool ttc_extent_is_nonnegative(ttc_extent a);
bool ttc_extent_is_nonpositive(ttc_extent a);
bool ttc_extent_is_positive(ttc_extent a);

#endif
