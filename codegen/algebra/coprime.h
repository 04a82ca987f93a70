/** Coprime bases: rational functions written as products of powers of elements of which no two have a common factor. The functions
 *  are then multiplicatively independent exactly where their exponents are linearly independent. No element is factored. */
#ifndef TTC_COPRIME_H
#define TTC_COPRIME_H

#include "algebra/ratio.h"

#include <flint/fmpq_mat.h>

enum { TTC_COPRIME_LIMIT = 256 };

typedef struct {
    ttc_ring *ring;
    fmpz_mpoly_t elements[TTC_COPRIME_LIMIT]; /* positive leading coefficients, integers among them, none is 1 */
    size_t count;
} ttc_coprime;

ttc_coprime *ttc_coprime_create(ttc_ring *ring); /* NULL, and the ring failed, when memory is out */
void ttc_coprime_destroy(ttc_coprime *base); /* legal on NULL */

/* Refine the base until the ratio is, up to its sign, a product of powers of its elements. The ratio is not zero and has no
 * generators. */
void ttc_coprime_include(ttc_coprime *base, const ttc_ratio *a);

/* The exponents of a ratio that was included, over a divisor, in a column of a matrix with one row an element. */
void ttc_coprime_exponents(ttc_coprime *base, fmpq_mat_t matrix, slong column, const ttc_ratio *a, ulong divisor);

#endif
