/* The derivative of a ratio along a direction in the variables, with the generators of the field by the chain rule. */
#include "algebra/ratio.h"

/* sum += d(polynomial)/d(variable) * slope */
static void add_term(ttc_ring *ring, ttc_ratio *sum, const fmpz_mpoly_t polynomial, slong variable, const ttc_ratio *slope)
{
    if (fmpz_mpoly_is_zero(slope->numerator, ring->context)) return;
    if (fmpz_mpoly_degree_si(polynomial, variable, ring->context) < 1) return;
    fmpz_mpoly_t derivative;
    ttc_ratio partial;
    fmpz_mpoly_init(derivative, ring->context);
    ttc_ratio_init(ring, &partial);
    fmpz_mpoly_derivative(derivative, polynomial, variable, ring->context);
    ttc_ratio_set_polynomial(ring, &partial, derivative);
    ttc_ratio_add_product(ring, sum, &partial, slope);
    ttc_ratio_clear(ring, &partial);
    fmpz_mpoly_clear(derivative, ring->context);
}

/* The rate of a polynomial in the variables and the first `level` generators. */
static void polynomial_rate(ttc_ring *ring, ttc_ratio *out, const fmpz_mpoly_t polynomial, const ttc_ratio *slopes,
                            const ttc_ratio *generator_slopes, size_t level)
{
    ttc_ratio_set_integer(ring, out, 0);
    for (slong v = 0; v < (slong)ring->variable_count; v++) {
        const ttc_generator *root = ttc_ring_generator(ring, v);
        const size_t i = root == NULL ? 0 : (size_t)(root - ring->generators);
        if (root == NULL || i < level) add_term(ring, out, polynomial, v, root == NULL ? &slopes[v] : &generator_slopes[i]);
    }
}

/* (n/d)' = (n' - (n/d) d')/d */
static void derive(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *slopes,
                   const ttc_ratio *generator_slopes, size_t level)
{
    ttc_ratio top, bottom;
    ttc_ratio_init(ring, &top);
    ttc_ratio_init(ring, &bottom);
    polynomial_rate(ring, &top, a->numerator, slopes, generator_slopes, level);
    polynomial_rate(ring, &bottom, a->denominator, slopes, generator_slopes, level);
    ttc_ratio_multiply(ring, &bottom, &bottom, a);
    ttc_ratio_subtract(ring, &top, &top, &bottom);
    ttc_ratio_set_polynomial(ring, &bottom, a->denominator);
    ttc_ratio_divide(ring, out, &top, &bottom);
    ttc_ratio_clear(ring, &bottom);
    ttc_ratio_clear(ring, &top);
}

void ttc_ratio_derive(ttc_ring *ring, ttc_ratio *out, const ttc_ratio *a, const ttc_ratio *slopes)
{
    ttc_ratio generator_slopes[TTC_GENERATOR_LIMIT], twice;
    fmpq_t half;
    size_t count = ring->generator_count;
    fmpq_init(half);
    fmpq_set_si(half, 1, 2);
    ttc_ratio_init(ring, &twice);
    for (size_t i = 0; i < count; i++) {
        ttc_ratio_init(ring, &generator_slopes[i]);
        derive(ring, &generator_slopes[i], &ring->generators[i].square, slopes, generator_slopes, i);
        if (fmpz_mpoly_is_zero(generator_slopes[i].numerator, ring->context)) continue;
        ttc_ratio_set_variable(ring, &twice, ring->generators[i].variable);
        ttc_ratio_divide(ring, &generator_slopes[i], &generator_slopes[i], &twice);
        ttc_ratio_scale(ring, &generator_slopes[i], &generator_slopes[i], half);
    }
    derive(ring, out, a, slopes, generator_slopes, count);
    for (size_t i = 0; i < count; i++) ttc_ratio_clear(ring, &generator_slopes[i]);
    ttc_ratio_clear(ring, &twice);
    fmpq_clear(half);
}
