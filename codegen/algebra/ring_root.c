/* Square roots of ratios. A root outside the field becomes a generator, so that generators are independent modulo squares. */
#include "algebra/ratio.h"

#include <flint/fmpz_vec.h>
#include <flint/ulong_extras.h>
#include <stdint.h>
#include <stdlib.h>

enum { DEEPEST = 16 }; /* generators over which a search takes time exponential in their number */

/* root = sqrt(a). Returns false if a is no square. The result is checked, because FLINT 2.9 reports a root of x y where the packed
 * exponents of both variables begin a word. */
static bool polynomial_root(ttc_ring *ring, fmpz_mpoly_t root, const fmpz_mpoly_t a)
{
    fmpz_mpoly_t square;
    if (!fmpz_mpoly_sqrt(root, a, ring->context)) return false;
    fmpz_mpoly_init(square, ring->context);
    fmpz_mpoly_mul(square, root, root, ring->context);
    const bool equal = fmpz_mpoly_equal(square, a, ring->context) != 0;
    fmpz_mpoly_clear(square, ring->context);
    return equal;
}

/* root = sqrt(a) in Q(variables). Returns false if a is no square there. */
static bool rational_root(ttc_ring *ring, ttc_ratio *root, const ttc_ratio *a)
{
    fmpz_mpoly_t product;
    ttc_ratio top, bottom;
    fmpz_mpoly_init(product, ring->context);
    ttc_ratio_init(ring, &top);
    ttc_ratio_init(ring, &bottom);
    fmpz_mpoly_mul(product, a->numerator, a->denominator, ring->context);
    bool square = polynomial_root(ring, top.numerator, product);
    if (square) {
        fmpz_mpoly_set(bottom.numerator, a->denominator, ring->context);
        ttc_ratio_divide(ring, root, &top, &bottom);
    }
    ttc_ratio_clear(ring, &bottom);
    ttc_ratio_clear(ring, &top);
    fmpz_mpoly_clear(product, ring->context);
    return square;
}

/* a = p + q r for generator number index, p and q free of it. */
static void split(ttc_ring *ring, ttc_ratio *p, ttc_ratio *q, const ttc_ratio *a, size_t index)
{
    ulong exponent = 1;
    slong variable = ring->generators[index].variable;
    ttc_ratio part;
    ttc_ratio_init(ring, &part);
    ttc_ratio_set_polynomial(ring, q, a->denominator);
    fmpz_mpoly_get_coeff_vars_ui(part.numerator, a->numerator, &variable, &exponent, 1, ring->context);
    ttc_ratio_divide(ring, q, &part, q);
    ttc_ratio_set_variable(ring, &part, variable);
    ttc_ratio_multiply(ring, &part, &part, q);
    ttc_ratio_subtract(ring, p, a, &part);
    ttc_ratio_clear(ring, &part);
}

/* Evaluate a in Q(variables) at 64 points, each modulo a prime of its own: bit i is set if the value at point i is no square, which
 * shows that a is none. Returns false if a value is zero or undefined, or if a uses one of the first `level` generators. */
static bool square_class(ttc_ring *ring, size_t level, uint64_t *bits, const ttc_ratio *a)
{
    for (size_t i = 0; i < level; i++)
        if (ttc_ratio_uses(ring, a, ring->generators[i].variable)) return false;
    const size_t count = ring->variable_count;
    fmpz *point = _fmpz_vec_init((slong)count + 1), **place = calloc(count + 1, sizeof *place);
    bool known = place != NULL;
    ulong prime = 1ul << 31, random = 1;
    fmpz_t value, modulus;
    fmpz_init(value);
    fmpz_init(modulus);
    *bits = 0;
    for (size_t v = 0; known && v < count; v++) place[v] = point + v;
    for (unsigned i = 0; known && i < 64; i++) {
        for (size_t v = 0; v < count; v++) fmpz_set_ui(point + v, random = random * 48271 % 2147483647);
        fmpz_set_ui(modulus, prime = n_nextprime(prime, 1));
        int sign = fmpz_mpoly_evaluate_all_fmpz(value, a->numerator, place, ring->context) ? fmpz_jacobi(value, modulus) : 0;
        sign *= fmpz_mpoly_evaluate_all_fmpz(value, a->denominator, place, ring->context) ? fmpz_jacobi(value, modulus) : 0;
        known = sign != 0;
        *bits |= (uint64_t)(sign < 0) << i;
    }
    fmpz_clear(modulus);
    fmpz_clear(value);
    free(place);
    _fmpz_vec_clear(point, (slong)count + 1);
    return known;
}

/* field_root if a and the squares of the generators are in Q(variables): a is a square if its product with some of these squares is
 * one in Q(variables), and linear algebra over the bits of square_class shows which ones these can be. *found is the result of
 * field_root. Returns false if the bits do not decide. */
static bool root_by_classes(ttc_ring *ring, size_t level, bool *found, ttc_ratio *root, const ttc_ratio *a)
{
    uint64_t classes[TTC_GENERATOR_LIMIT + 1];
    uint64_t products[TTC_GENERATOR_LIMIT + 1];
    *found = false;
    for (size_t i = 0; i <= level; i++) {
        if (!square_class(ring, level, classes + i, i < level ? &ring->generators[i].square : a)) return false;
        products[i] = UINT64_C(1) << i;
        for (size_t k = 0; k < i; k++) {
            if (!(classes[i] & classes[k] & -classes[k])) continue; /* the lowest bit of row k is its pivot */
            classes[i] ^= classes[k];
            products[i] ^= products[k];
        }
        if (i < level && classes[i] == 0) return false;
    }
    if (classes[level] != 0) return true;
    ttc_ratio product, generator;
    ttc_ratio_init(ring, &product);
    ttc_ratio_init(ring, &generator);
    ttc_ratio_set(ring, &product, a);
    for (size_t i = 0; i < level; i++)
        if (products[level] >> i & 1) ttc_ratio_multiply(ring, &product, &product, &ring->generators[i].square);
    *found = rational_root(ring, root, &product);
    for (size_t i = 0; *found && i < level; i++) {
        if (!(products[level] >> i & 1)) continue;
        ttc_ratio_set_variable(ring, &generator, ring->generators[i].variable);
        ttc_ratio_divide(ring, root, root, &generator);
    }
    ttc_ratio_clear(ring, &generator);
    ttc_ratio_clear(ring, &product);
    return true;
}

static bool field_root(ttc_ring *ring, size_t level, ttc_ratio *root, const ttc_ratio *a);

/* root = x + q/(2x) r if x^2 = (p + sign n)/2 is a square in the field of the generators before r. */
static bool mixed_root(ttc_ring *ring, size_t level, ttc_ratio *root, const ttc_ratio *p, const ttc_ratio *q,
                       const ttc_ratio *n, int sign)
{
    fmpq_t factor;
    ttc_ratio x, y;
    ttc_ratio_init(ring, &x);
    ttc_ratio_init(ring, &y);
    fmpq_init(factor);
    fmpq_set_si(factor, sign, 1);
    ttc_ratio_scale(ring, &x, n, factor);
    ttc_ratio_add(ring, &x, &x, p);
    fmpq_set_si(factor, 1, 2);
    ttc_ratio_scale(ring, &x, &x, factor);
    bool found = !ttc_ratio_is_zero(ring, &x) && field_root(ring, level - 1, &x, &x);
    if (found) {
        ttc_ratio_divide(ring, &y, q, &x);
        ttc_ratio_scale(ring, &y, &y, factor);
        ttc_ratio_set_variable(ring, root, ring->generators[level - 1].variable);
        ttc_ratio_multiply(ring, root, root, &y);
        ttc_ratio_add(ring, root, root, &x);
    }
    fmpq_clear(factor);
    ttc_ratio_clear(ring, &y);
    ttc_ratio_clear(ring, &x);
    return found;
}

/** A square root of a, of either sign, in the field of the first `level` generators. Returns false if a is no square there.
 *  With r^2 = d for the last generator, p + q r = (x + y r)^2 means p^2 - q^2 d = n^2 and x^2 = (p + n)/2 or (p - n)/2; for
 *  q = 0, p or p/d is a square in the field of the generators before it. root may be a. */
static bool field_root(ttc_ring *ring, size_t level, ttc_ratio *root, const ttc_ratio *a)
{
    if (ring->status != TTC_RING_OK) return false;
    if (level == 0) return rational_root(ring, root, a);
    const ttc_ratio *square = &ring->generators[level - 1].square;
    bool found = false;
    if (root_by_classes(ring, level, &found, root, a)) return found;
    if (level > DEEPEST) {
        ttc_ring_fail(ring, TTC_RING_MANY_ROOTS);
        return false;
    }
    ttc_ratio p, q, n;
    ttc_ratio_init(ring, &p);
    ttc_ratio_init(ring, &q);
    ttc_ratio_init(ring, &n);
    split(ring, &p, &q, a, level - 1);
    if (ttc_ratio_is_zero(ring, &q)) {
        found = field_root(ring, level - 1, root, &p);
        if (!found) {
            ttc_ratio_divide(ring, &n, &p, square);
            found = field_root(ring, level - 1, &n, &n);
            ttc_ratio_set_variable(ring, &p, ring->generators[level - 1].variable);
            if (found) ttc_ratio_multiply(ring, root, &n, &p);
        }
    } else {
        ttc_ratio_multiply(ring, &n, &q, &q);
        ttc_ratio_multiply(ring, &n, &n, square);
        ttc_ratio_scale(ring, &n, &n, ring->minus_one);
        ttc_ratio_add_product(ring, &n, &p, &p);
        found = field_root(ring, level - 1, &n, &n)
                && (mixed_root(ring, level, root, &p, &q, &n, 1) || mixed_root(ring, level, root, &p, &q, &n, -1));
    }
    ttc_ratio_clear(ring, &n);
    ttc_ratio_clear(ring, &q);
    ttc_ratio_clear(ring, &p);
    return found;
}

/* The sign of a, if it is evident for a or for its product with some positive generators; otherwise 0. */
static int evident_sign(ttc_ring *ring, const ttc_ratio *a)
{
    slong used[DEEPEST];
    size_t count = 0;
    int sign = 0;
    ttc_ratio product, generator;
    ttc_ratio_init(ring, &product);
    ttc_ratio_init(ring, &generator);
    for (size_t i = 0; i < ring->generator_count && count < DEEPEST; i++)
        if (ring->generators[i].positive && ttc_ratio_uses(ring, a, ring->generators[i].variable))
            used[count++] = ring->generators[i].variable;
    for (unsigned subset = 0; sign == 0 && subset < 1u << count; subset++) {
        ttc_ratio_set(ring, &product, a);
        for (size_t i = 0; i < count; i++)
            if (subset >> i & 1) {
                ttc_ratio_set_variable(ring, &generator, used[i]);
                ttc_ratio_multiply(ring, &product, &product, &generator);
            }
        sign = ttc_ratio_sign(ring, &product);
        ring->has_sign_of_quotient |= sign != 0 && !fmpz_mpoly_is_fmpz(product.denominator, ring->context);
    }
    ttc_ratio_clear(ring, &generator);
    ttc_ratio_clear(ring, &product);
    return sign;
}

/* A root that is an element of the field: the positive one, or, if signs are not evident, the one that ring->choices selects.
 * Returns false if the radicand is no square. */
static bool known_root(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *radicand, bool positive)
{
    ttc_ratio root;
    ttc_ratio_init(ring, &root);
    bool found = field_root(ring, ring->generator_count, &root, radicand);
    if (found) {
        int sign = positive ? evident_sign(ring, &root) : 0;
        if (sign == 0 && ring->choice_count < 16) sign = ring->choices >> ring->choice_count++ & 1 ? -1 : 1;
        if (sign == 0) ttc_ring_fail(ring, TTC_RING_MANY_ROOTS);
        if (sign < 0) ttc_ratio_scale(ring, &root, &root, ring->minus_one);
        ttc_ratio_set(ring, out, &root);
    }
    ttc_ratio_clear(ring, &root);
    return found;
}

/* Fail for a radicand that is zero, evidently negative, or the opposite of a square. */
static void check_radicand(ttc_ring *ring, const ttc_ratio *radicand)
{
    ttc_ratio negative, root;
    ttc_ratio_init(ring, &negative);
    ttc_ratio_init(ring, &root);
    ttc_ratio_scale(ring, &negative, radicand, ring->minus_one);
    /* The root of the opposite must not be a quotient, which says nothing where its denominator vanishes. */
    if (ttc_ratio_is_zero(ring, radicand)) ttc_ring_fail(ring, TTC_RING_ROOT_OF_ZERO);
    else if (ttc_ratio_sign(ring, radicand) < 0
             || (field_root(ring, ring->generator_count, &root, &negative)
                 && fmpz_mpoly_is_fmpz(root.denominator, ring->context)))
        ttc_ring_fail(ring, TTC_RING_ROOT_OF_NEGATIVE);
    ttc_ratio_clear(ring, &root);
    ttc_ratio_clear(ring, &negative);
}

void ttc_ring_root(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *radicand, slong variable, bool positive)
{
    if (ring->status != TTC_RING_OK) return;
    if (positive) check_radicand(ring, radicand);
    if (!positive && ttc_ratio_is_zero(ring, radicand)) {
        ttc_ratio_set_integer(ring, out, 0);
        return;
    }
    if (ring->status != TTC_RING_OK || known_root(ring, out, radicand, positive) || ring->status != TTC_RING_OK) return;
    if (variable < 0 && ring->next_spare < ring->variable_count) variable = (slong)ring->next_spare++;
    if (variable < 0 || ring->generator_count == TTC_GENERATOR_LIMIT) {
        ttc_ring_fail(ring, TTC_RING_MANY_ROOTS);
        return;
    }
    ttc_generator *generator = &ring->generators[ring->generator_count];
    generator->variable = variable;
    generator->positive = positive;
    ttc_ratio_init(ring, &generator->square);
    ttc_ratio_set(ring, &generator->square, radicand);
    ring->generator_count++;
    ttc_ratio_set_variable(ring, out, variable);
}
