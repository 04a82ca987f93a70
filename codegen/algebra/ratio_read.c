/* Properties of a ratio: the variables it uses, its evident sign, its text. */
#include "algebra/ratio.h"

#include "base/text.h"

#include <string.h>

bool ttc_ratio_uses(const ttc_ring *ring, const ttc_ratio *a, slong variable)
{
    return fmpz_mpoly_degree_si(a->numerator, variable, ring->context) > 0
           || fmpz_mpoly_degree_si(a->denominator, variable, ring->context) > 0;
}

static bool is_positive(const ttc_ring *ring, slong variable)
{
    const ttc_generator *root = ttc_ring_generator(ring, variable);
    return root != NULL ? root->positive : ring->positive[variable];
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

static void add_ratio(ttc_text *text, const ttc_ring *ring, const ttc_ratio *a)
{
    char *top = fmpz_mpoly_get_str_pretty(a->numerator, ring->names, ring->context);
    char *bottom = fmpz_mpoly_get_str_pretty(a->denominator, ring->names, ring->context);
    if (fmpz_mpoly_is_one(a->denominator, ring->context)) ttc_text_add(text, top);
    else ttc_text_format(text, "(%s)/(%s)", top, bottom);
    flint_free(bottom);
    flint_free(top);
}

char *ttc_ratio_text(const ttc_ring *ring, const ttc_ratio *a)
{
    bool uses[TTC_GENERATOR_LIMIT];
    ttc_text text = { 0 };
    add_ratio(&text, ring, a);
    for (size_t i = 0; i < ring->generator_count; i++) uses[i] = ttc_ratio_uses(ring, a, ring->generators[i].variable);
    for (size_t i = ring->generator_count; i-- > 0;) { /* a root is made of those before it */
        const ttc_generator *root = &ring->generators[i];
        const char *name = ring->names[root->variable];
        if (!uses[i] || strchr(name, '[') == NULL) continue;
        ttc_text_format(&text, root->positive ? ", %s = sqrt(" : ", %s^2 = ", name);
        add_ratio(&text, ring, &root->square);
        if (root->positive) ttc_text_add(&text, ")");
        for (size_t k = 0; k < i; k++) uses[k] |= ttc_ratio_uses(ring, &root->square, ring->generators[k].variable);
    }
    if (text.failed) ttc_text_clear(&text);
    return text.bytes;
}
