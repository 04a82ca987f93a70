#include "algebra/independence.h"

#include <stdlib.h>

static void swap(ttc_ring *ring, ttc_ratio *a, ttc_ratio *b)
{
    fmpz_mpoly_swap(a->numerator, b->numerator, ring->context);
    fmpz_mpoly_swap(a->denominator, b->denominator, ring->context);
}

void ttc_ratio_set(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a)
{
    fmpz_mpoly_set(out->numerator, a->numerator, ring->context);
    fmpz_mpoly_set(out->denominator, a->denominator, ring->context);
}

void ttc_ratio_set_rational(ttc_ring *ring, ttc_ratio *out, const fmpq_t value)
{
    fmpz_mpoly_set_fmpz(out->numerator, fmpq_numref(value), ring->context);
    fmpz_mpoly_set_fmpz(out->denominator, fmpq_denref(value), ring->context);
}

void ttc_ratio_set_integer(ttc_ring *ring, ttc_ratio *out, slong value)
{
    fmpz_mpoly_set_si(out->numerator, value, ring->context);
    fmpz_mpoly_one(out->denominator, ring->context);
}

void ttc_ratio_set_variable(ttc_ring *ring, ttc_ratio *out, slong variable)
{
    fmpz_mpoly_gen(out->numerator, variable, ring->context);
    fmpz_mpoly_one(out->denominator, ring->context);
}

static slong bits_of(const fmpz_mpoly_t a) { return labs(fmpz_mpoly_max_bits(a)); }

/* Returns true if the product of two polynomials, which is not computed, is within the limits; else the ring fails. */
static bool fits(ttc_ring *ring, const fmpz_mpoly_t a, const fmpz_mpoly_t b)
{
    slong limit = TTC_PRODUCT_LIMIT;
    slong length = fmpz_mpoly_length(b, ring->context);
    if (ring->status != TTC_RING_OK || length == 0 || fmpz_mpoly_is_zero(a, ring->context)) return ring->status == TTC_RING_OK;
    if (fmpz_mpoly_length(a, ring->context) > limit / length
        || fmpz_mpoly_total_degree_si(a, ring->context) + fmpz_mpoly_total_degree_si(b, ring->context) > TTC_DEGREE_LIMIT
        || bits_of(a) + bits_of(b) > TTC_BITS_LIMIT)
        ttc_ring_fail(ring, TTC_RING_TOO_LARGE);
    return ring->status == TTC_RING_OK;
}

/* The same for a power. The k-th power of a polynomial of n terms has at most binomial(n + k - 1, k) terms. */
static bool power_fits(ttc_ring *ring, const fmpz_mpoly_t a, ulong exponent)
{
    double terms = 1, length = (double)fmpz_mpoly_length(a, ring->context);
    if (ring->status != TTC_RING_OK || length == 0) return ring->status == TTC_RING_OK;
    for (double k = 1; k < length && terms <= TTC_PRODUCT_LIMIT; k++) terms *= ((double)exponent + k) / k;
    if (terms > TTC_PRODUCT_LIMIT || (double)exponent * (double)fmpz_mpoly_total_degree_si(a, ring->context) > TTC_DEGREE_LIMIT
        || (double)exponent * (double)(bits_of(a) + 4) > TTC_BITS_LIMIT)
        ttc_ring_fail(ring, TTC_RING_TOO_LARGE);
    return ring->status == TTC_RING_OK;
}

/* Reduce the degree in a generator r, r^2 = p/q, below 2: sum c_k r^k becomes (even + odd r) / q^half, half = degree/2. */
static void reduce_generator(ttc_ring *ring, fmpz_mpoly_t numerator, fmpz_mpoly_t denominator,
                             const ttc_generator *generator)
{
    slong degree = fmpz_mpoly_degree_si(numerator, generator->variable, ring->context);
    if (degree < 2) return;
    ulong half = (ulong)degree / 2;
    if (!power_fits(ring, generator->square.numerator, half) || !power_fits(ring, generator->square.denominator, half)) return;
    fmpz_mpoly_univar_t parts;
    fmpz_mpoly_t coefficient, power, halves[2];
    fmpz_mpoly_univar_init(parts, ring->context);
    fmpz_mpoly_init(coefficient, ring->context);
    fmpz_mpoly_init(power, ring->context);
    fmpz_mpoly_init(halves[0], ring->context);
    fmpz_mpoly_init(halves[1], ring->context);
    fmpz_mpoly_to_univar(parts, numerator, generator->variable, ring->context);
    for (slong i = 0; i < fmpz_mpoly_univar_length(parts, ring->context); i++) {
        ulong k = (ulong)fmpz_mpoly_univar_get_term_exp_si(parts, i, ring->context);
        fmpz_mpoly_univar_get_term_coeff(coefficient, parts, i, ring->context);
        fmpz_mpoly_pow_ui(power, generator->square.numerator, k / 2, ring->context);
        if (fits(ring, coefficient, power)) fmpz_mpoly_mul(coefficient, coefficient, power, ring->context);
        fmpz_mpoly_pow_ui(power, generator->square.denominator, half - k / 2, ring->context);
        if (fits(ring, coefficient, power)) fmpz_mpoly_mul(coefficient, coefficient, power, ring->context);
        fmpz_mpoly_add(halves[k % 2], halves[k % 2], coefficient, ring->context);
    }
    fmpz_mpoly_gen(power, generator->variable, ring->context);
    fmpz_mpoly_mul(numerator, halves[1], power, ring->context);
    fmpz_mpoly_add(numerator, numerator, halves[0], ring->context);
    fmpz_mpoly_pow_ui(power, generator->square.denominator, half, ring->context);
    if (fits(ring, denominator, power)) fmpz_mpoly_mul(denominator, denominator, power, ring->context);
    fmpz_mpoly_clear(halves[1], ring->context);
    fmpz_mpoly_clear(halves[0], ring->context);
    fmpz_mpoly_clear(power, ring->context);
    fmpz_mpoly_clear(coefficient, ring->context);
    fmpz_mpoly_univar_clear(parts, ring->context);
}

/* Squares may contain earlier generators, so that the last generator is reduced first. */
static void reduce(ttc_ring *ring, fmpz_mpoly_t numerator, fmpz_mpoly_t denominator)
{
    for (size_t i = ring->generator_count; i-- > 0;)
        reduce_generator(ring, numerator, denominator, &ring->generators[i]);
}

static void cancel(ttc_ring *ring, fmpz_mpoly_t a, fmpz_mpoly_t b)
{
    fmpz_mpoly_t common;
    fmpz_mpoly_init(common, ring->context);
    if (!fmpz_mpoly_is_one(a, ring->context) && !fmpz_mpoly_is_one(b, ring->context)) {
        if (!fmpz_mpoly_gcd(common, a, b, ring->context)) {
            ttc_ring_fail(ring, TTC_RING_TOO_LARGE);
        } else if (!fmpz_mpoly_is_one(common, ring->context)) {
            fmpz_mpoly_divexact(a, a, common, ring->context);
            fmpz_mpoly_divexact(b, b, common, ring->context);
        }
    }
    fmpz_mpoly_clear(common, ring->context);
}

static void normalize(ttc_ring *ring, ttc_ratio *a)
{
    reduce(ring, a->numerator, a->denominator);
    if (fmpz_mpoly_is_zero(a->numerator, ring->context)) {
        fmpz_mpoly_one(a->denominator, ring->context);
        return;
    }
    cancel(ring, a->numerator, a->denominator);
    fmpz_t leading;
    fmpz_init(leading);
    fmpz_mpoly_get_term_coeff_fmpz(leading, a->denominator, 0, ring->context);
    if (fmpz_sgn(leading) < 0) {
        fmpz_mpoly_neg(a->numerator, a->numerator, ring->context);
        fmpz_mpoly_neg(a->denominator, a->denominator, ring->context);
    }
    fmpz_clear(leading);
}

void ttc_ratio_set_polynomial(ttc_ring *ring, ttc_ratio *out, const fmpz_mpoly_t polynomial)
{
    fmpz_mpoly_set(out->numerator, polynomial, ring->context);
    fmpz_mpoly_one(out->denominator, ring->context);
    normalize(ring, out);
}

/* a/b + c/d = (a d' + c b') / (b d') with b = g b', d = g d'. */
static void combine(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *b, bool subtract)
{
    if (!fits(ring, a->numerator, b->denominator) || !fits(ring, b->numerator, a->denominator)) return;
    ttc_ratio result;
    fmpz_mpoly_t left, right;
    ttc_ratio_init(ring, &result);
    fmpz_mpoly_init(left, ring->context);
    fmpz_mpoly_init(right, ring->context);
    fmpz_mpoly_set(left, a->denominator, ring->context);
    fmpz_mpoly_set(right, b->denominator, ring->context);
    cancel(ring, left, right);
    fmpz_mpoly_mul(result.denominator, a->denominator, right, ring->context);
    fmpz_mpoly_mul(right, a->numerator, right, ring->context);
    fmpz_mpoly_mul(left, b->numerator, left, ring->context);
    if (subtract) fmpz_mpoly_sub(result.numerator, right, left, ring->context);
    else fmpz_mpoly_add(result.numerator, right, left, ring->context);
    normalize(ring, &result);
    swap(ring, out, &result);
    fmpz_mpoly_clear(right, ring->context);
    fmpz_mpoly_clear(left, ring->context);
    ttc_ratio_clear(ring, &result);
}

void ttc_ratio_add(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *b)
{
    combine(ring, out, a, b, false);
}

void ttc_ratio_subtract(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *b)
{
    combine(ring, out, a, b, true);
}

void ttc_ratio_multiply(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *b)
{
    if (!fits(ring, a->numerator, b->numerator) || !fits(ring, a->denominator, b->denominator)) return;
    ttc_ratio left, right;
    ttc_ratio_init(ring, &left);
    ttc_ratio_init(ring, &right);
    ttc_ratio_set(ring, &left, a);
    ttc_ratio_set(ring, &right, b);
    cancel(ring, left.numerator, right.denominator);
    cancel(ring, right.numerator, left.denominator);
    fmpz_mpoly_mul(left.numerator, left.numerator, right.numerator, ring->context);
    fmpz_mpoly_mul(left.denominator, left.denominator, right.denominator, ring->context);
    normalize(ring, &left);
    swap(ring, out, &left);
    ttc_ratio_clear(ring, &right);
    ttc_ratio_clear(ring, &left);
}

/* Multiply top and bottom of top/bottom by the conjugate of the bottom in one generator: for bottom = p + q r,
 * r^2 = u/v, the new bottom is p^2 v - q^2 u. Returns false when the bottom is free of r. */
static bool rationalize(ttc_ring *ring, fmpz_mpoly_t top, fmpz_mpoly_t bottom, const ttc_generator *generator)
{
    if (fmpz_mpoly_degree_si(bottom, generator->variable, ring->context) < 1) return false;
    fmpz_mpoly_t p, q, r;
    ulong exponent = 1;
    fmpz_mpoly_init(p, ring->context);
    fmpz_mpoly_init(q, ring->context);
    fmpz_mpoly_init(r, ring->context);
    fmpz_mpoly_get_coeff_vars_ui(q, bottom, &generator->variable, &exponent, 1, ring->context);
    fmpz_mpoly_gen(r, generator->variable, ring->context);
    fmpz_mpoly_mul(r, q, r, ring->context);
    fmpz_mpoly_sub(p, bottom, r, ring->context);
    fmpz_mpoly_sub(r, p, r, ring->context);
    fmpz_mpoly_mul(r, r, generator->square.denominator, ring->context);
    if (fits(ring, top, r)) fmpz_mpoly_mul(top, top, r, ring->context);
    if (fits(ring, p, p)) fmpz_mpoly_mul(p, p, p, ring->context);
    fmpz_mpoly_mul(p, p, generator->square.denominator, ring->context);
    if (fits(ring, q, q)) fmpz_mpoly_mul(q, q, q, ring->context);
    fmpz_mpoly_mul(q, q, generator->square.numerator, ring->context);
    fmpz_mpoly_sub(bottom, p, q, ring->context);
    fmpz_mpoly_clear(r, ring->context);
    fmpz_mpoly_clear(q, ring->context);
    fmpz_mpoly_clear(p, ring->context);
    return true;
}

/* top / bottom, both reduced, as a ratio. Generators are removed from the bottom, beginning with the last. */
static void quotient(ttc_ring *ring, ttc_ratio *out, fmpz_mpoly_t top, fmpz_mpoly_t bottom)
{
    fmpz_mpoly_t extra;
    fmpz_mpoly_init(extra, ring->context);
    fmpz_mpoly_one(extra, ring->context);
    for (size_t i = ring->generator_count; i-- > 0;)
        if (rationalize(ring, top, bottom, &ring->generators[i])) {
            fmpz_mpoly_t scale;
            fmpz_mpoly_init(scale, ring->context);
            fmpz_mpoly_one(scale, ring->context);
            reduce(ring, bottom, scale);
            fmpz_mpoly_mul(top, top, scale, ring->context);
            reduce(ring, top, extra);
            fmpz_mpoly_clear(scale, ring->context);
        }
    if (fmpz_mpoly_is_zero(bottom, ring->context)) {
        ttc_ring_fail(ring, TTC_RING_DIVISION_BY_ZERO);
    } else {
        fmpz_mpoly_swap(out->numerator, top, ring->context);
        fmpz_mpoly_mul(out->denominator, bottom, extra, ring->context);
        normalize(ring, out);
    }
    fmpz_mpoly_clear(extra, ring->context);
}

void ttc_ratio_divide(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *b)
{
    if (ttc_ratio_is_zero(ring, b)) ttc_ring_fail(ring, TTC_RING_DIVISION_BY_ZERO);
    if (ring->status != TTC_RING_OK) return;
    ttc_ratio inverse;
    fmpz_mpoly_t top, bottom;
    ttc_ratio_init(ring, &inverse);
    fmpz_mpoly_init(top, ring->context);
    fmpz_mpoly_init(bottom, ring->context);
    fmpz_mpoly_set(top, b->denominator, ring->context);
    fmpz_mpoly_set(bottom, b->numerator, ring->context);
    quotient(ring, &inverse, top, bottom);
    ttc_ratio_multiply(ring, out, a, &inverse);
    fmpz_mpoly_clear(bottom, ring->context);
    fmpz_mpoly_clear(top, ring->context);
    ttc_ratio_clear(ring, &inverse);
}

void ttc_ratio_power(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, long exponent)
{
    ttc_ratio base, result;
    ttc_ratio_init(ring, &base);
    ttc_ratio_init(ring, &result);
    ttc_ratio_set_integer(ring, &result, 1);
    if (exponent < 0) ttc_ratio_divide(ring, &base, &result, a);
    else ttc_ratio_set(ring, &base, a);
    for (unsigned long k = (unsigned long)labs(exponent); k > 0 && ring->status == TTC_RING_OK; k /= 2) {
        if (k % 2 == 1) ttc_ratio_multiply(ring, &result, &result, &base);
        if (k > 1) ttc_ratio_multiply(ring, &base, &base, &base);
    }
    swap(ring, out, &result);
    ttc_ratio_clear(ring, &result);
    ttc_ratio_clear(ring, &base);
}

void ttc_ratio_scale(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const fmpq_t factor)
{
    ttc_ratio number;
    ttc_ratio_init(ring, &number);
    ttc_ratio_set_rational(ring, &number, factor);
    ttc_ratio_multiply(ring, out, a, &number);
    ttc_ratio_clear(ring, &number);
}

void ttc_ratio_add_product(ttc_ring *ring, ttc_ratio *sum, const ttc_ratio *a, const ttc_ratio *b)
{
    ttc_ratio product;
    ttc_ratio_init(ring, &product);
    ttc_ratio_multiply(ring, &product, a, b);
    ttc_ratio_add(ring, sum, sum, &product);
    ttc_ratio_clear(ring, &product);
}

bool ttc_ratio_is_zero(ttc_ring *ring, const ttc_ratio *a)
{
    if (fmpz_mpoly_is_zero(a->numerator, ring->context)) return true;
    if (ring->status != TTC_RING_OK || ttc_ring_settles(ring, a->numerator)) return false;
    ttc_ring_fail(ring, TTC_RING_NOT_SETTLED);
    return true;
}

bool ttc_ratio_equal(const ttc_ring *ring, const ttc_ratio *a, const ttc_ratio *b)
{
    return fmpz_mpoly_equal(a->numerator, b->numerator, ring->context)
           && fmpz_mpoly_equal(a->denominator, b->denominator, ring->context);
}

void ttc_ratio_norm(ttc_ring *ring, fmpz_mpoly_t norm, const ttc_ratio *a)
{
    fmpz_mpoly_t ignored;
    fmpz_mpoly_init(ignored, ring->context);
    fmpz_mpoly_set(norm, a->numerator, ring->context);
    for (size_t i = ring->generator_count; i-- > 0;) {
        fmpz_mpoly_one(ignored, ring->context);
        if (rationalize(ring, ignored, norm, &ring->generators[i])) reduce(ring, norm, ignored);
    }
    fmpz_mpoly_clear(ignored, ring->context);
}
