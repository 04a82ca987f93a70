#include "discover/claim_text.h"

#include <flint/fmpz_mpoly_factor.h>

#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 100 };

/* The terms with the same powers of quantities. */
typedef struct {
    ulong *exponents; /* by quantity */
    size_t width, degree;
} group;

static int by_degree(const void *left, const void *right)
{
    const group *a = left, *b = right;
    if (a->degree != b->degree) return a->degree > b->degree ? -1 : 1;
    for (size_t i = 0; i < a->width; i++)
        if (a->exponents[i] != b->exponents[i]) return a->exponents[i] > b->exponents[i] ? -1 : 1;
    return 0;
}

static void add_power(ttc_text *text, const char *base, bool is_sum, ulong exponent, bool *has_factor)
{
    if (*has_factor) ttc_text_add(text, "*");
    *has_factor = true;
    ttc_text_format(text, is_sum ? "(%s)" : "%s", base);
    if (exponent > 1) ttc_text_format(text, "^%lu", (unsigned long)exponent);
}

/* The absolute value of a coefficient, as a product. Returns false, and appends nothing, if it is 1. */
static bool add_coefficient(ttc_text *text, const ttc_flow *flow, const fmpz_mpoly_t coefficient, bool *is_negative)
{
    bool has_factor = false;
    const fmpz_mpoly_ctx_struct *context = flow->ring->context;
    fmpz_mpoly_factor_t factors;
    fmpz_t constant;
    fmpz_mpoly_factor_init(factors, context);
    fmpz_init(constant);
    if (fmpz_mpoly_factor(factors, coefficient, context) == 0) { /* not factored: append it as it stands */
        char *whole = fmpz_mpoly_get_str_pretty(coefficient, (const char **)flow->ring->names, context);
        *is_negative = false;
        add_power(text, whole, true, 1, &has_factor);
        flint_free(whole);
    } else {
        fmpz_mpoly_factor_get_constant_fmpz(constant, factors, context);
        *is_negative = fmpz_sgn(constant) < 0;
        fmpz_abs(constant, constant);
        if (!fmpz_is_one(constant)) {
            char *number = fmpz_get_str(NULL, 10, constant);
            add_power(text, number, false, 1, &has_factor);
            flint_free(number);
        }
        for (slong i = 0; i < fmpz_mpoly_factor_length(factors, context); i++) {
            fmpz_mpoly_t base;
            fmpz_mpoly_init(base, context);
            fmpz_mpoly_factor_get_base(base, factors, i, context);
            char *name = fmpz_mpoly_get_str_pretty(base, (const char **)flow->ring->names, context);
            add_power(text, name, fmpz_mpoly_length(base, context) > 1, (ulong)fmpz_mpoly_factor_get_exp_si(factors, i, context),
                      &has_factor);
            flint_free(name);
            fmpz_mpoly_clear(base, context);
        }
    }
    fmpz_clear(constant);
    fmpz_mpoly_factor_clear(factors, context);
    return has_factor;
}

static void add_group(ttc_text *text, const ttc_flow *flow, const fmpz_mpoly_t polynomial, const group *g, bool is_first)
{
    ttc_text product = { 0 };
    bool is_negative = false;
    fmpz_mpoly_t coefficient;
    fmpz_mpoly_init(coefficient, flow->ring->context);
    fmpz_mpoly_get_coeff_vars_ui(coefficient, polynomial, flow->variables, g->exponents, (slong)flow->count, flow->ring->context);
    bool has_factor = add_coefficient(&product, flow, coefficient, &is_negative);
    for (size_t i = 0; i < flow->count; i++)
        if (g->exponents[i] > 0) add_power(&product, flow->ring->names[flow->variables[i]], false, g->exponents[i], &has_factor);
    if (!has_factor) ttc_text_add(&product, "1");
    if (!is_first) ttc_text_add(text, is_negative ? " - " : " + ");
    else if (is_negative) ttc_text_add(text, "-");
    ttc_text_add(text, ttc_text_string(&product));
    text->failed |= product.failed;
    fmpz_mpoly_clear(coefficient, flow->ring->context);
    ttc_text_clear(&product);
}

void ttc_claim_text_add(ttc_text *text, const ttc_flow *flow, const fmpz_mpoly_t polynomial)
{
    const size_t count = (size_t)fmpz_mpoly_length(polynomial, flow->ring->context);
    ulong *all = flint_calloc(flow->ring->variable_count, sizeof *all);
    ulong *exponents = flint_calloc(count * flow->count + 1, sizeof *exponents);
    group *groups = flint_calloc(count + 1, sizeof *groups);
    for (size_t t = 0; t < count; t++) {
        fmpz_mpoly_get_term_exp_ui(all, polynomial, (slong)t, flow->ring->context);
        groups[t] = (group){ exponents + t * flow->count, flow->count, 0 };
        for (size_t i = 0; i < flow->count; i++) groups[t].degree += groups[t].exponents[i] = all[flow->variables[i]];
    }
    qsort(groups, count, sizeof *groups, by_degree);
    for (size_t t = 0; t < count; t++)
        if (t == 0 || by_degree(&groups[t - 1], &groups[t]) != 0) add_group(text, flow, polynomial, &groups[t], t == 0);
    if (count == 0) ttc_text_add(text, "0");
    flint_free(groups);
    flint_free(exponents);
    flint_free(all);
}

static void add_part(ttc_text *text, const ttc_flow *flow, const fmpz_mpoly_t part, bool is_sum)
{
    if (is_sum) ttc_text_add(text, "(");
    ttc_claim_text_add(text, flow, part);
    if (is_sum) ttc_text_add(text, ")");
}

void ttc_claim_text_add_ratio(ttc_text *text, const ttc_flow *flow, const ttc_ratio *ratio)
{
    const bool is_whole = fmpz_mpoly_is_one(ratio->denominator, flow->ring->context);
    add_part(text, flow, ratio->numerator, !is_whole && fmpz_mpoly_length(ratio->numerator, flow->ring->context) > 1);
    if (is_whole) return;
    ttc_text_add(text, "/");
    add_part(text, flow, ratio->denominator, !fmpz_mpoly_is_fmpz(ratio->denominator, flow->ring->context));
}

void ttc_claim_text_wrap(ttc_text *out, const char *text)
{
    size_t column = 0;
    for (const char *c = text; *c != '\0'; c++) {
        const bool may_break = *c == ' ' && (c[1] == '+' || c[1] == '-') && c[2] == ' ';
        const size_t next = may_break ? strcspn(c + 3, " \n") + 3 : 0;
        if (may_break && column + next > COLUMNS) {
            ttc_text_add(out, "\n   ");
            column = 3;
        }
        ttc_text_add_bytes(out, c, 1);
        column = *c == '\n' ? 0 : column + 1;
    }
}
