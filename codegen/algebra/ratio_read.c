/* Properties of a ratio: the variables it uses, its evident sign, its text. */
#include "algebra/ratio.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool ttc_ratio_uses(const ttc_ring *ring, const ttc_ratio *a, slong variable)
{
    return fmpz_mpoly_degree_si(a->numerator, variable, ring->context) > 0
           || fmpz_mpoly_degree_si(a->denominator, variable, ring->context) > 0;
}

static bool is_positive(const ttc_ring *ring, slong variable)
{
    bool positive = ring->positive[variable];
    for (size_t i = 0; i < ring->generator_count; i++)
        if (ring->generators[i].variable == variable) positive = ring->generators[i].positive;
    return positive;
}

/* The common sign of all terms if coefficients show it, and odd powers are of positive variables only; or that of a number; 0 if
 * neither is known. */
static int sign_of(const ttc_ring *ring, const fmpz_mpoly_t polynomial)
{
    int sign = 0;
    fmpz_t coefficient;
    fmpz_init(coefficient);
    for (slong i = 0; i < fmpz_mpoly_length(polynomial, ring->context); i++) {
        fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, i, ring->context);
        int term = fmpz_sgn(coefficient);
        for (size_t v = 0; v < ring->variable_count; v++)
            if (!is_positive(ring, (slong)v) && fmpz_mpoly_get_term_var_exp_ui(polynomial, i, (slong)v, ring->context) % 2 == 1)
                term = 0;
        if (term == 0 || sign == -term) {
            sign = 0;
            break;
        }
        sign = term;
    }
    fmpz_clear(coefficient);
    return sign != 0 ? sign : ttc_ring_sign_of_number(ring, polynomial);
}

int ttc_ratio_sign(const ttc_ring *ring, const ttc_ratio *a)
{
    return sign_of(ring, a->numerator) * sign_of(ring, a->denominator);
}

char *ttc_ratio_text(const ttc_ring *ring, const ttc_ratio *a)
{
    char *top = fmpz_mpoly_get_str_pretty(a->numerator, ring->names, ring->context);
    char *bottom = fmpz_mpoly_get_str_pretty(a->denominator, ring->names, ring->context);
    size_t size = strlen(top) + strlen(bottom) + 6;
    char *text = malloc(size);
    if (text != NULL) {
        if (fmpz_mpoly_is_one(a->denominator, ring->context)) snprintf(text, size, "%s", top);
        else snprintf(text, size, "(%s)/(%s)", top, bottom);
    }
    flint_free(bottom);
    flint_free(top);
    return text;
}
