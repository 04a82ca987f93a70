/** Coprime bases: rational functions as products of powers of pairwise coprime polynomials. The functions are multiplicatively
 *  independent, up to their signs, exactly if their vectors of exponents are linearly independent. Found by gcds alone. */
#ifndef TTC_COPRIME_H
#define TTC_COPRIME_H

#include "algebra/ratio.h"

#include <flint/fmpq_mat.h>

enum { TTC_COPRIME_LIMIT = 256 };

typedef struct {
    ttc_ring *ring;
    fmpz_mpoly_t elements[TTC_COPRIME_LIMIT]; /* with positive leading coefficients; some may be integers, none is 1 */
    size_t count;
} ttc_coprime;

ttc_coprime *ttc_coprime_create(ttc_ring *ring); /* NULL, and the ring failed, when memory is out */
void ttc_coprime_destroy(ttc_coprime *base); /* legal on NULL */

/* Refine the base until the ratio, not zero and without generators, is a product of powers of its elements, up to sign. */
void ttc_coprime_include(ttc_coprime *base, const ttc_ratio *a);

/* Write the exponents of a ratio that was included, divided by `divisor`, to a column of a matrix with a row for each element. */
void ttc_coprime_exponents(ttc_coprime *base, fmpq_mat_t matrix, slong column, const ttc_ratio *a, ulong divisor);

#endif
