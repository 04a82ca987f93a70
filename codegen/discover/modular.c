#include "discover/modular.h"

#include "base/random.h"

#include <flint/fmpz.h>
#include <flint/ulong_extras.h>

static void set_polynomial(ttc_modular_polynomial *out, const ttc_ring *ring, const fmpz_mpoly_t a, nmod_t mod)
{
    const size_t count = (size_t)fmpz_mpoly_length(a, ring->context);
    size_t end = 0;
    ulong *exponents = flint_calloc(ring->variable_count, sizeof *exponents);
    fmpz_t coefficient;
    fmpz_init(coefficient);
    out->count = count;
    out->coefficients = flint_calloc(count + 1, sizeof *out->coefficients);
    out->ends = flint_calloc(count + 1, sizeof *out->ends);
    out->variables = flint_calloc(count * ring->variable_count + 1, sizeof *out->variables);
    out->exponents = flint_calloc(count * ring->variable_count + 1, sizeof *out->exponents);
    for (size_t i = 0; i < count; i++) {
        fmpz_mpoly_get_term_coeff_fmpz(coefficient, a, (slong)i, ring->context);
        out->coefficients[i] = fmpz_fdiv_ui(coefficient, mod.n);
        fmpz_mpoly_get_term_exp_ui(exponents, a, (slong)i, ring->context);
        for (size_t v = 0; v < ring->variable_count; v++) {
            if (exponents[v] == 0) continue;
            out->variables[end] = (uint32_t)v;
            out->exponents[end++] = (uint32_t)exponents[v];
        }
        out->ends[i] = end;
    }
    fmpz_clear(coefficient);
    flint_free(exponents);
}

static void clear_polynomial(ttc_modular_polynomial *a)
{
    flint_free(a->exponents);
    flint_free(a->variables);
    flint_free(a->ends);
    flint_free(a->coefficients);
}

static ulong value_of(const ttc_modular_polynomial *a, const ulong *values, nmod_t mod)
{
    ulong sum = 0;
    size_t at = 0;
    for (size_t i = 0; i < a->count; i++) {
        ulong term = a->coefficients[i];
        for (; at < a->ends[i]; at++)
            for (uint32_t k = 0; k < a->exponents[at]; k++) term = nmod_mul(term, values[a->variables[at]], mod);
        sum = nmod_add(sum, term, mod);
    }
    return sum;
}

void ttc_modular_ratio_set(ttc_modular_ratio *out, const ttc_ring *ring, const ttc_ratio *a, nmod_t mod)
{
    ttc_modular_ratio_clear(out);
    set_polynomial(&out->numerator, ring, a->numerator, mod);
    set_polynomial(&out->denominator, ring, a->denominator, mod);
}

void ttc_modular_ratio_clear(ttc_modular_ratio *a)
{
    clear_polynomial(&a->numerator);
    clear_polynomial(&a->denominator);
    *a = (ttc_modular_ratio){ .numerator = { .count = 0 } };
}

bool ttc_modular_ratio_value(ulong *out, const ttc_modular_ratio *a, const ulong *values, nmod_t mod)
{
    const ulong below = value_of(&a->denominator, values, mod);
    if (below == 0) return false;
    *out = nmod_mul(value_of(&a->numerator, values, mod), nmod_inv(below, mod), mod);
    return true;
}

ulong ttc_modular_draw(uint64_t *source, nmod_t mod)
{
    ulong drawn = 0;
    while (drawn == 0) drawn = (ulong)ttc_random_bits(source) % mod.n;
    return drawn;
}

bool ttc_modular_rational(fmpq_t out, ulong residue, nmod_t mod)
{
    fmpz_t a, n;
    fmpz_init_set_ui(a, residue);
    fmpz_init_set_ui(n, mod.n);
    const bool found = fmpq_reconstruct_fmpz(out, a,
                                             n) != 0 && fmpz_bits(fmpq_numref(out)) <= 30 && fmpz_bits(fmpq_denref(out)) <= 30;
    fmpz_clear(n);
    fmpz_clear(a);
    return found;
}
