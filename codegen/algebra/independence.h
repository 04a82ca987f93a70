/** Which variables of a ring are known to be independent, and what may be concluded from it.
 *
 *  A polynomial that is not zero as a form is not zero as a function, or number, only where its variables are algebraically
 *  independent. Parameters and states are; cosines, exponentials and logarithms are over all complex numbers where their
 *  exponents and arguments are independent modulo constants (J. Ax, On Schanuel's conjectures, Ann. of Math. 93, 1971; the
 *  structure theorem of Risch). Where numbers come in, their own independence is asked for, and known in few cases only:
 *  exponentials of algebraic numbers that are linearly independent over the rationals (Lindemann and Weierstrass), one single
 *  transcendental number, pi or the logarithm of a rational one, and linear forms in several of these last (A. Baker, Linear
 *  forms in the logarithms of algebraic numbers, Mathematika 13, 1966). */
#ifndef TTC_INDEPENDENCE_H
#define TTC_INDEPENDENCE_H

#include "algebra/ratio.h"

typedef enum {
    TTC_TRUST_FREE,   /* independent of the other free ones over the complex numbers */
    TTC_TRUST_ALGEBRAIC, /* free ones, or 1, times the exponential of an algebraic number */
    TTC_TRUST_SINGLE, /* free ones, or 0, plus pi or the logarithm of a rational number */
    TTC_TRUST_NONE,   /* nothing is known */
    TTC_TRUST_MASK = 3,
    TTC_TRUST_CONSTANT = 4 /* with one of the above but the first: a number */
} ttc_trust;

/* Whether a polynomial that is not zero as a form is known not to be zero. */
bool ttc_ring_settles(const ttc_ring *ring, const fmpz_mpoly_t polynomial);

/** How an angle, or an exponent, that follows from no others exactly follows from them modulo constants, and what is known of
 *  its functions. basis, shape (count,): free angles, or free exponents and logarithms. parameter: a variable that stands in
 *  none. */
ttc_trust ttc_ring_trust(ttc_ring *ring, const ttc_ratio *angle, const ttc_ratio *basis, size_t count, slong parameter);

/* Whether the variables of some ratios, shape (count,), are known to be independent, numbers or free: the ratios are then
 * equal, or linearly or multiplicatively dependent, only where they are so in form. */
bool ttc_ring_settles_all(const ttc_ring *ring, const ttc_ratio *ratios, size_t count);

bool ttc_ring_is_constant(const ttc_ring *ring, const fmpz_mpoly_t polynomial); /* uses numbers alone */
bool ttc_ring_is_free(const ttc_ring *ring, const fmpz_mpoly_t polynomial); /* uses free variables alone */

#endif
