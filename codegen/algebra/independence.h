/** Algebraic independence of the variables of a ring, as far as theorems assure it.
 *
 *  A nonzero polynomial is a nonzero function, or number, if its variables are algebraically independent. Parameters and states
 *  are; cosines, exponentials and logarithms are independent over the complex numbers if their exponents are linearly, and their
 *  arguments multiplicatively, independent modulo constants (J. Ax, On Schanuel's conjectures, Ann. of Math. 93, 1971; the
 *  structure theorem of Risch). The independence of transcendental numbers is known in few cases: exponentials of algebraic numbers
 *  that are linearly independent over the rationals (Lindemann and Weierstrass); a single one of pi and logarithms of rationals;
 *  linear forms in several of these (A. Baker, Linear forms in the logarithms of algebraic numbers, Mathematika 13, 1966). */
#ifndef TTC_INDEPENDENCE_H
#define TTC_INDEPENDENCE_H

#include "algebra/ratio.h"

/* What is known of a variable of the ring. */
typedef enum {
    TTC_TRUST_FREE,   /* algebraically independent of the other free variables over the complex numbers */
    TTC_TRUST_ALGEBRAIC, /* a product of powers of free ones, or 1, times the exponential of an algebraic number */
    TTC_TRUST_SINGLE, /* a linear combination of free ones, or 0, plus pi or the logarithm of a rational number */
    TTC_TRUST_NONE,   /* nothing is known */
    TTC_TRUST_MASK = 3,
    TTC_TRUST_CONSTANT = 4 /* added to any of the above but FREE: the variable is a number */
} ttc_trust;

/* Returns true if a nonzero polynomial is known to be a nonzero function or number. */
bool ttc_ring_settles(const ttc_ring *ring, const fmpz_mpoly_t polynomial);

/** Classify the functions of an angle, or an exponent, that is no rational combination of the basis: FREE if it is none modulo
 *  constants either, ALGEBRAIC if it is one plus an algebraic number, otherwise NONE; with CONSTANT if it is a number. basis, shape
 *  (count,): angles of free functions, or exponents and logarithms. parameter: a variable of the ring that none of these uses. */
ttc_trust ttc_ring_trust(ttc_ring *ring, const ttc_ratio *angle, const ttc_ratio *basis, size_t count, slong parameter);

/* Returns true if all variables that the ratios, shape (count,), use are free or numbers, and known to be independent. The ratios
 * are then equal, or linearly or multiplicatively dependent, only if they are so as rational functions of these variables. */
bool ttc_ring_settles_all(const ttc_ring *ring, const ttc_ratio *ratios, size_t count);

/* Return true if a polynomial, squares of generators included, uses numbers alone; free variables alone. */
bool ttc_ring_is_constant(const ttc_ring *ring, const fmpz_mpoly_t polynomial);
bool ttc_ring_is_free(const ttc_ring *ring, const fmpz_mpoly_t polynomial);

#endif
