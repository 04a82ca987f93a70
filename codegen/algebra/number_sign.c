/* The sign of a number that is made of square roots, by balls. */
#include "algebra/ratio.h"

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif
#include <stdlib.h>

enum { FIRST_PRECISION = 64, LAST_PRECISION = 4096 }; /* bits */

typedef struct {
    const ttc_ring *ring;
    arb_struct balls[TTC_GENERATOR_LIMIT];
    bool is_number[TTC_GENERATOR_LIMIT]; /* by generator: the positive root of a number */
} number_roots;

static bool is_of_numbers(const number_roots *roots, const fmpz_mpoly_t polynomial)
{
    const ttc_ring *ring = roots->ring;
    int *used = calloc(ring->variable_count + 1, sizeof *used);
    bool result = used != NULL;
    if (used != NULL) fmpz_mpoly_used_vars(used, polynomial, ring->context);
    for (size_t v = 0; result && v < ring->variable_count; v++) {
        const ttc_generator *root = ttc_ring_generator(ring, (slong)v);
        result = !used[v] || (root != NULL && roots->is_number[root - ring->generators]);
    }
    free(used);
    return result;
}

static void enclose(arb_t out, const number_roots *roots, const fmpz_mpoly_t polynomial, slong precision)
{
    const ttc_ring *ring = roots->ring;
    fmpz_t coefficient;
    arb_t term, power;
    fmpz_init(coefficient);
    arb_init(term);
    arb_init(power);
    arb_zero(out);
    for (slong i = 0; i < fmpz_mpoly_length(polynomial, ring->context); i++) {
        fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, i, ring->context);
        arb_set_fmpz(term, coefficient);
        for (size_t k = 0; k < ring->generator_count; k++) {
            if (!roots->is_number[k]) continue;
            arb_pow_ui(power, roots->balls + k,
                       fmpz_mpoly_get_term_var_exp_ui(polynomial, i, ring->generators[k].variable, ring->context), precision);
            arb_mul(term, term, power, precision);
        }
        arb_add(out, out, term, precision);
    }
    arb_clear(power);
    arb_clear(term);
    fmpz_clear(coefficient);
}

static void enclose_roots(number_roots *roots, slong precision)
{
    arb_t divisor;
    arb_init(divisor);
    for (size_t i = 0; i < roots->ring->generator_count; i++) {
        if (!roots->is_number[i]) continue;
        const ttc_ratio *square = &roots->ring->generators[i].square;
        enclose(roots->balls + i, roots, square->numerator, precision);
        enclose(divisor, roots, square->denominator, precision);
        arb_div(roots->balls + i, roots->balls + i, divisor, precision);
        arb_sqrt(roots->balls + i, roots->balls + i, precision);
    }
    arb_clear(divisor);
}

int ttc_ring_sign_of_number(const ttc_ring *ring, const fmpz_mpoly_t polynomial)
{
    number_roots roots = { .ring = ring };
    int sign = 0;
    arb_t value;
    for (size_t i = 0; i < ring->generator_count; i++)
        roots.is_number[i] = ring->generators[i].positive && is_of_numbers(&roots, ring->generators[i].square.numerator) &&
                             is_of_numbers(&roots, ring->generators[i].square.denominator);
    if (!is_of_numbers(&roots, polynomial)) return 0;
    arb_init(value);
    for (size_t i = 0; i < ring->generator_count; i++) arb_init(roots.balls + i);
    for (slong precision = FIRST_PRECISION; sign == 0 && precision <= LAST_PRECISION; precision *= 4) {
        enclose_roots(&roots, precision);
        enclose(value, &roots, polynomial, precision);
        sign = arb_is_positive(value) ? 1 : arb_is_negative(value) ? -1 : 0;
    }
    for (size_t i = 0; i < ring->generator_count; i++) arb_clear(roots.balls + i);
    arb_clear(value);
    return sign;
}
