/* The ring of ratios: creation of the ring and of its elements, and its failures. */
#include "algebra/ratio.h"

#include <stdlib.h>

ttc_ring *ttc_ring_create(size_t variable_count, size_t first_spare, const char **names, const bool *positive)
{
    ttc_ring *ring = calloc(1, sizeof *ring);
    if (ring == NULL) return NULL;
    ring->trust = calloc(variable_count + 1, sizeof *ring->trust);
    if (ring->trust == NULL) {
        free(ring);
        return NULL;
    }
    fmpz_mpoly_ctx_init(ring->context, (slong)variable_count, ORD_DEGLEX);
    ring->variable_count = variable_count;
    ring->next_spare = first_spare;
    ring->names = names;
    ring->positive = positive;
    fmpq_init(ring->minus_one);
    fmpq_set_si(ring->minus_one, -1, 1);
    return ring;
}

void ttc_ring_destroy(ttc_ring *ring)
{
    if (ring == NULL) return;
    for (size_t i = 0; i < ring->generator_count; i++) ttc_ratio_clear(ring, &ring->generators[i].square);
    if (ring->solver != NULL) ring->release(ring->solver);
    fmpq_clear(ring->minus_one);
    fmpz_mpoly_ctx_clear(ring->context);
    free(ring->trust);
    free(ring);
}

void ttc_ratio_init(ttc_ring *ring, ttc_ratio *a)
{
    fmpz_mpoly_init(a->numerator, ring->context);
    fmpz_mpoly_init(a->denominator, ring->context);
    fmpz_mpoly_one(a->denominator, ring->context);
}

void ttc_ratio_clear(ttc_ring *ring, ttc_ratio *a)
{
    fmpz_mpoly_clear(a->numerator, ring->context);
    fmpz_mpoly_clear(a->denominator, ring->context);
}

const ttc_generator *ttc_ring_generator(const ttc_ring *ring, slong variable)
{
    for (size_t i = 0; i < ring->generator_count; i++)
        if (ring->generators[i].variable == variable) return &ring->generators[i];
    return NULL;
}

void ttc_ring_fail(ttc_ring *ring, ttc_ring_status status)
{
    if (ring->status == TTC_RING_OK) ring->status = status;
}

bool ttc_ring_has_no_value(ttc_ring_status status)
{
    return status == TTC_RING_DIVISION_BY_ZERO || status == TTC_RING_ROOT_OF_ZERO || status == TTC_RING_ROOT_OF_NEGATIVE
           || status == TTC_RING_LOG_OF_ZERO || status == TTC_RING_LOG_OF_NEGATIVE;
}

bool ttc_ring_is_too_large(ttc_ring_status status)
{
    return status >= TTC_RING_LARGE_EXPRESSION && status <= TTC_RING_MANY_FACTORS;
}

const char *ttc_ring_status_text(ttc_ring_status status)
{
    switch (status) {
    case TTC_RING_OK: return "no error";
    case TTC_RING_DIVISION_BY_ZERO: return "a denominator vanishes identically under the conditions of this claim";
    case TTC_RING_ROOT_OF_ZERO: return "a root, positive by declaration, vanishes under the conditions of this claim";
    case TTC_RING_ROOT_OF_NEGATIVE: return "a radicand is negative under the conditions of this claim";
    case TTC_RING_CIRCULAR: return "the conditions of this claim define a name by itself";
    case TTC_RING_ANGLE_ALONE:
        return "a state that is given by an atan2 is used by itself (expected its cosine and sine alone; where it is a state of "
               "this table, that state in place of the atan2)";
    case TTC_RING_ANGLE:
        return "an angle is mapped to one that is no sum of those in the table it is mapped into (expected a record 'angle C S = "
               "cos(...) sin(...)' for it there)";
    case TTC_RING_ANGLE_FRACTION:
        return "an angle is a fraction of others, or of pi (expected an angle record for their common part, of which all are "
               "multiples; of pi, a multiple of pi/n, where n divides 240)";
    case TTC_RING_EXPONENT: return "an exponential is mapped to one that is no product of those that the model names";
    case TTC_RING_EXPONENT_FRACTION:
        return "an exponent is a fraction of others (expected an exp record for their common part, of which all are multiples)";
    case TTC_RING_LOGARITHM: return "a logarithm is mapped to one that is no sum of those that the model names";
    case TTC_RING_LOG_OF_ZERO: return "the argument of a logarithm vanishes under the conditions of this claim";
    case TTC_RING_LOG_OF_NEGATIVE: return "the argument of a logarithm is not positive under the conditions of this claim";
    case TTC_RING_PI: return "the number pi stands in one of the two tables, and another quantity has the name pi in the other";
    case TTC_RING_NOT_SETTLED: return "it rests on the independence of exponentials, logarithms or pi, which is not known";
    case TTC_RING_LARGE_EXPRESSION: return "a derivative or image passes a limit of expressions (exponents, terms, operands)";
    case TTC_RING_TOO_LARGE:
        return "a polynomial passes the limit of degree 4096, of 2^26 products of terms a multiplication, or of 131072 bits a "
               "coefficient";
    case TTC_RING_MANY_ROOTS:
        return "it passes the limit of 32 roots, and angles whose sines stand beside each other, in a claim, or of 16 with nested "
               "roots";
    case TTC_RING_MANY_ANGLES: return "it passes the limit of 128 angles";
    case TTC_RING_MANY_FUNCTIONS: return "it passes the limit of 128 exponentials and logarithms";
    case TTC_RING_LARGE_MULTIPLE: return "it passes the limit of 64 multiples of one angle or exponent in another";
    case TTC_RING_MANY_FACTORS:
        return "it passes the limit of 256 factors without common part of all arguments of logarithms";
    case TTC_RING_NO_MEMORY: return "out of memory";
    }
    return "unknown error";
}
