/* The ring of a ratio: its variables, and its generators, which stay independent modulo squares. */
#include "ratio.h"

#include <stdlib.h>

ttc_ring *ttc_ring_create(size_t variable_count, size_t first_spare, const char **names, const bool *positive)
{
    ttc_ring *ring = calloc(1, sizeof *ring);
    if (ring == NULL) return NULL;
    fmpz_mpoly_ctx_init(ring->context, (slong)variable_count, ORD_DEGLEX);
    ring->variable_count = variable_count;
    ring->next_spare = first_spare;
    ring->names = names;
    ring->positive = positive;
    return ring;
}

void ttc_ring_destroy(ttc_ring *ring)
{
    if (ring == NULL) return;
    for (size_t i = 0; i < ring->generator_count; i++) ttc_ratio_clear(ring, &ring->generators[i].square);
    fmpz_mpoly_ctx_clear(ring->context);
    free(ring);
}

void ttc_ring_fail(ttc_ring *ring, ttc_ring_status status)
{
    if (ring->status == TTC_RING_OK) ring->status = status;
}

const char *ttc_ring_status_text(ttc_ring_status status)
{
    switch (status) {
    case TTC_RING_OK: return "no error";
    case TTC_RING_DIVISION_BY_ZERO: return "a denominator vanishes identically under the conditions of this claim";
    case TTC_RING_ROOT_OF_ZERO: return "a root, positive by declaration, vanishes under the conditions of this claim";
    case TTC_RING_ROOT_OF_NEGATIVE: return "a radicand is negative under the conditions of this claim";
    case TTC_RING_ROOT_UNDECIDED: return "a nested root may depend on the others; write it without nesting";
    case TTC_RING_CIRCULAR: return "the conditions of this claim define a name by itself";
    case TTC_RING_ANGLE: return "an angle is mapped to one that the model does not name";
    case TTC_RING_TOO_LARGE: return "an expression grows beyond what is allowed";
    case TTC_RING_NO_MEMORY: return "out of memory";
    }
    return "unknown error";
}

/* root = sqrt(a) in Q(variables); false when a is no square there. */
static bool rational_root(ttc_ring *ring, ttc_ratio *root, const ttc_ratio *a)
{
    fmpz_mpoly_t product;
    ttc_ratio top, bottom;
    fmpz_mpoly_init(product, ring->context);
    ttc_ratio_init(ring, &top);
    ttc_ratio_init(ring, &bottom);
    fmpz_mpoly_mul(product, a->numerator, a->denominator, ring->context);
    bool square = fmpz_mpoly_sqrt(top.numerator, product, ring->context) != 0;
    if (square) {
        fmpz_mpoly_set(bottom.numerator, a->denominator, ring->context);
        ttc_ratio_divide(ring, root, &top, &bottom);
    }
    ttc_ratio_clear(ring, &bottom);
    ttc_ratio_clear(ring, &top);
    fmpz_mpoly_clear(product, ring->context);
    return square;
}

static bool uses_generators(const ttc_ring *ring, const ttc_ratio *a)
{
    for (size_t i = 0; i < ring->generator_count; i++)
        if (ttc_ratio_uses(ring, a, ring->generators[i].variable)) return true;
    return false;
}

/* Whether a contains generator i, or one whose radicand does. */
static bool depends(const ttc_ring *ring, const ttc_ratio *a, size_t i)
{
    if (ttc_ratio_uses(ring, a, ring->generators[i].variable)) return true;
    for (size_t k = i + 1; k < ring->generator_count; k++)
        if (ttc_ratio_uses(ring, &ring->generators[k].square, ring->generators[i].variable) && depends(ring, a, k)) return true;
    return false;
}

/* A square in the whole field has a norm that is a square in Q(variables). */
static bool norm_is_square(ttc_ring *ring, const ttc_ratio *a)
{
    ttc_ratio norm;
    fmpz_mpoly_t product, polynomial;
    ttc_ratio_init(ring, &norm);
    fmpz_mpoly_init(product, ring->context);
    fmpz_mpoly_init(polynomial, ring->context);
    fmpz_mpoly_mul(product, a->numerator, a->denominator, ring->context);
    ttc_ratio_set_polynomial(ring, &norm, product);
    /* numerator of the norm of a * (denominator squared times squares of denominators of radicands) */
    ttc_ratio_norm(ring, polynomial, &norm);
    bool square = fmpz_mpoly_is_square(polynomial, ring->context) != 0;
    for (size_t i = 0; i < ring->generator_count; i++)
        if (depends(ring, a, i) && !fmpz_mpoly_is_fmpz(ring->generators[i].square.denominator, ring->context)) square = true;
    fmpz_mpoly_clear(polynomial, ring->context);
    fmpz_mpoly_clear(product, ring->context);
    ttc_ratio_clear(ring, &norm);
    return square;
}

/* root = root / (product of the generators in `subset`); tells whether all of them are positive. */
static bool divide_out(ttc_ring *ring, ttc_ratio *root, unsigned subset)
{
    bool positive = true;
    ttc_ratio generator;
    ttc_ratio_init(ring, &generator);
    for (size_t i = 0; i < ring->generator_count; i++)
        if (subset >> i & 1) {
            ttc_ratio_set_variable(ring, &generator, ring->generators[i].variable);
            ttc_ratio_divide(ring, root, root, &generator);
            positive = positive && ring->generators[i].positive;
        }
    ttc_ratio_clear(ring, &generator);
    return positive;
}

/* root holds q with q^2 = radicand * (product of the generators in `subset`)^2: divide, and settle the sign, which is
 * that of q, and that of q over the product of the radicands. */
static void finish_root(ttc_ring *ring, ttc_ratio *root, unsigned subset, bool positive)
{
    int sign = ttc_ratio_sign(ring, root);
    ttc_ratio relative;
    ttc_ratio_init(ring, &relative);
    bool evident = divide_out(ring, root, subset) && positive;
    ttc_ratio_set(ring, &relative, root);
    divide_out(ring, &relative, subset);
    if (sign == 0) sign = ttc_ratio_sign(ring, &relative);
    if (!evident) sign = 0;
    if (sign == 0 && ring->choice_count < 16) sign = ring->choices >> ring->choice_count++ & 1 ? -1 : 1;
    if (sign == 0) ttc_ring_fail(ring, TTC_RING_TOO_LARGE);
    ttc_ratio_set_integer(ring, &relative, sign);
    ttc_ratio_multiply(ring, root, root, &relative);
    ttc_ratio_clear(ring, &relative);
}

static bool known_root(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *radicand, bool positive)
{
    bool found = false;
    ttc_ratio product, root;
    ttc_ratio_init(ring, &product);
    ttc_ratio_init(ring, &root);
    for (unsigned subset = 0; !found && subset < 1u << ring->generator_count && ring->status == TTC_RING_OK; subset++) {
        ttc_ratio_set(ring, &product, radicand);
        for (size_t i = 0; i < ring->generator_count; i++)
            if (subset >> i & 1) ttc_ratio_multiply(ring, &product, &product, &ring->generators[i].square);
        if (uses_generators(ring, &product)) {
            /* nested: the same radicand twice is one root; beyond that only independence can be established */
            if (subset != 0 && (subset & (subset - 1)) == 0) {
                size_t i = 0;
                while (subset >> i != 1) i++;
                ttc_ratio_divide(ring, &root, radicand, &ring->generators[i].square);
                if (!uses_generators(ring, &root) && rational_root(ring, &root, &root)) {
                    ttc_ratio_multiply(ring, &root, &root, &ring->generators[i].square);
                    finish_root(ring, &root, subset, positive);
                    found = true;
                    break;
                }
            }
            if (norm_is_square(ring, &product)) ttc_ring_fail(ring, TTC_RING_ROOT_UNDECIDED);
        } else if (rational_root(ring, &root, &product)) {
            finish_root(ring, &root, subset, positive);
            found = true;
        }
    }
    if (found) ttc_ratio_set(ring, out, &root);
    ttc_ratio_clear(ring, &root);
    ttc_ratio_clear(ring, &product);
    return found;
}

static void check_radicand(ttc_ring *ring, const ttc_ratio *radicand)
{
    ttc_ratio negative, root;
    ttc_ratio_init(ring, &negative);
    ttc_ratio_init(ring, &root);
    ttc_ratio_set_integer(ring, &negative, -1);
    ttc_ratio_multiply(ring, &negative, &negative, radicand);
    if (ttc_ratio_is_zero(ring, radicand)) ttc_ring_fail(ring, TTC_RING_ROOT_OF_ZERO);
    else if (ttc_ratio_sign(ring, radicand) < 0) ttc_ring_fail(ring, TTC_RING_ROOT_OF_NEGATIVE);
    else if (!uses_generators(ring, radicand) && rational_root(ring, &root, &negative))
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
        ttc_ring_fail(ring, TTC_RING_TOO_LARGE);
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
