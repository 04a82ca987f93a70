#include "algebra/coprime.h"

#include <stdint.h>
#include <stdlib.h>

ttc_coprime *ttc_coprime_create(ttc_ring *ring)
{
    ttc_coprime *base = calloc(1, sizeof *base);
    if (base == NULL) ttc_ring_fail(ring, TTC_RING_NO_MEMORY);
    else base->ring = ring;
    return base;
}

void ttc_coprime_destroy(ttc_coprime *base)
{
    if (base == NULL) return;
    for (size_t i = 0; i < base->count; i++) fmpz_mpoly_clear(base->elements[i], base->ring->context);
    free(base);
}

static void make_positive(ttc_ring *ring, fmpz_mpoly_t a)
{
    fmpz_t leading;
    fmpz_init(leading);
    fmpz_mpoly_get_term_coeff_fmpz(leading, a, 0, ring->context);
    if (fmpz_sgn(leading) < 0) fmpz_mpoly_neg(a, a, ring->context);
    fmpz_clear(leading);
}

/* Insert a polynomial. If a and an element b have a common factor c, they are replaced by a/c, b/c and c, inserted in turn. Each
 * level of the recursion removes a factor, which bounds its depth. */
static void insert(ttc_coprime *base, const fmpz_mpoly_t element)
{
    ttc_ring *ring = base->ring;
    fmpz_mpoly_t a, common;
    if (ring->status != TTC_RING_OK) return;
    fmpz_mpoly_init(a, ring->context);
    fmpz_mpoly_init(common, ring->context);
    fmpz_mpoly_set(a, element, ring->context);
    make_positive(ring, a);
    for (size_t i = 0; i < base->count && ring->status == TTC_RING_OK && !fmpz_mpoly_is_one(a, ring->context); i++) {
        if (!fmpz_mpoly_gcd(common, a, base->elements[i], ring->context)) {
            ttc_ring_fail(ring, TTC_RING_TOO_LARGE);
            break;
        }
        if (fmpz_mpoly_is_one(common, ring->context)) continue;
        fmpz_mpoly_t other;
        fmpz_mpoly_init(other, ring->context);
        fmpz_mpoly_divexact(other, base->elements[i], common, ring->context);
        fmpz_mpoly_divexact(a, a, common, ring->context);
        base->count--;
        fmpz_mpoly_swap(base->elements[i], base->elements[base->count], ring->context);
        fmpz_mpoly_clear(base->elements[base->count], ring->context);
        insert(base, other);
        insert(base, common);
        fmpz_mpoly_clear(other, ring->context);
        i = SIZE_MAX; /* the base has changed, so start again with element 0 */
    }
    if (ring->status == TTC_RING_OK && !fmpz_mpoly_is_one(a, ring->context)) {
        if (base->count == TTC_COPRIME_LIMIT) {
            ttc_ring_fail(ring, TTC_RING_MANY_FACTORS);
        } else {
            fmpz_mpoly_init(base->elements[base->count], ring->context);
            fmpz_mpoly_set(base->elements[base->count++], a, ring->context);
        }
    }
    fmpz_mpoly_clear(common, ring->context);
    fmpz_mpoly_clear(a, ring->context);
}

void ttc_coprime_include(ttc_coprime *base, const ttc_ratio *a)
{
    insert(base, a->numerator);
    insert(base, a->denominator);
}

static slong multiplicity(ttc_coprime *base, const fmpz_mpoly_t element, const fmpz_mpoly_t a)
{
    ttc_ring *ring = base->ring;
    slong count = 0;
    fmpz_mpoly_t rest;
    fmpz_mpoly_init(rest, ring->context);
    fmpz_mpoly_set(rest, a, ring->context);
    while (fmpz_mpoly_divides(rest, rest, element, ring->context)) count++;
    fmpz_mpoly_clear(rest, ring->context);
    return count;
}

void ttc_coprime_exponents(ttc_coprime *base, fmpq_mat_t matrix, slong column, const ttc_ratio *a, ulong divisor)
{
    for (size_t i = 0; i < base->count && base->ring->status == TTC_RING_OK; i++) {
        const fmpz_mpoly_struct *element = base->elements[i];
        slong count = multiplicity(base, element, a->numerator) - multiplicity(base, element, a->denominator);
        fmpq_set_si(fmpq_mat_entry(matrix, (slong)i, column), count, divisor);
    }
}
