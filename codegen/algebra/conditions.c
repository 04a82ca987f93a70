#include "algebra/conditions.h"

#include "base/array.h"

#include <flint/fmpz_mpoly_factor.h>
#include <stdlib.h>

void ttc_conditions_init(ttc_conditions *c, ttc_valuation *valuation)
{
    *c = (ttc_conditions){ .valuation = valuation, .ring = ttc_valuation_ring(valuation) };
}

void ttc_conditions_clear(ttc_conditions *c)
{
    for (size_t i = 0; i < c->count; i++) fmpz_mpoly_clear(c->items[i].polynomial, c->ring->context);
    free(c->items);
    c->items = NULL;
    c->count = 0;
}

static unsigned signs_above(const ttc_graph *graph, ttc_id low)
{
    const fmpq *end = ttc_number_value(graph, low);
    return end != NULL && fmpq_sgn(end) >= 0 ? TTC_CAN_BE_POSITIVE : TTC_CAN_BE_ANY;
}

static unsigned signs_below(const ttc_graph *graph, ttc_id high)
{
    const fmpq *end = ttc_number_value(graph, high);
    return end != NULL && fmpq_sgn(end) <= 0 ? TTC_CAN_BE_NEGATIVE : TTC_CAN_BE_ANY;
}

static unsigned signs_of_variable(const ttc_conditions *c, slong variable)
{
    const ttc_generator *generator = ttc_ring_generator(c->ring, variable);
    if (generator != NULL) return generator->positive ? TTC_CAN_BE_POSITIVE : TTC_CAN_BE_ANY;
    const ttc_model *model = ttc_valuation_model(c->valuation);
    size_t symbol = ttc_valuation_symbol(c->valuation, variable);
    if (symbol >= model->symbol_count) return TTC_CAN_BE_ANY;
    const ttc_symbol_entry *entry = &model->symbols[symbol];
    if (entry->kind == TTC_ROOT || entry->kind == TTC_EXP || entry->kind == TTC_PI) return TTC_CAN_BE_POSITIVE;
    if (entry->kind == TTC_STATE) return signs_above(model->graph, entry->low) & signs_below(model->graph, entry->high);
    if (entry->kind != TTC_PARAM) return TTC_CAN_BE_ANY;
    switch (entry->sign) {
    case TTC_POSITIVE: return TTC_CAN_BE_POSITIVE;
    case TTC_NONNEGATIVE: return TTC_CAN_BE_POSITIVE | TTC_CAN_BE_ZERO;
    case TTC_NONZERO: return TTC_CAN_BE_POSITIVE | TTC_CAN_BE_NEGATIVE;
    default: return TTC_CAN_BE_ANY;
    }
}

static unsigned opposite(unsigned signs)
{
    return (signs & TTC_CAN_BE_ZERO) | (signs & TTC_CAN_BE_POSITIVE ? (unsigned)TTC_CAN_BE_NEGATIVE : 0u)
           | (signs & TTC_CAN_BE_NEGATIVE ? (unsigned)TTC_CAN_BE_POSITIVE : 0u);
}

unsigned ttc_conditions_sign_of(const fmpq_t value)
{
    const int sign = fmpq_sgn(value);
    return sign > 0 ? TTC_CAN_BE_POSITIVE : sign < 0 ? TTC_CAN_BE_NEGATIVE : TTC_CAN_BE_ZERO;
}

unsigned ttc_conditions_signs_of_product(unsigned a, unsigned b)
{
    unsigned signs = (a | b) & TTC_CAN_BE_ZERO;
    if (b & TTC_CAN_BE_POSITIVE) signs |= a & ~(unsigned)TTC_CAN_BE_ZERO;
    if (b & TTC_CAN_BE_NEGATIVE) signs |= opposite(a) & ~(unsigned)TTC_CAN_BE_ZERO;
    return signs;
}

/* A sum of two terms that are not negative is not negative, and it is positive if one of them is. */
unsigned ttc_conditions_signs_of_sum(unsigned a, unsigned b)
{
    if (a == TTC_CAN_BE_ZERO) return b;
    if (b == TTC_CAN_BE_ZERO) return a;
    const unsigned both = a | b, positive = TTC_CAN_BE_POSITIVE, negative = TTC_CAN_BE_NEGATIVE;
    if (!(both & negative)) return a == positive || b == positive ? positive : both;
    if (!(both & positive)) return a == negative || b == negative ? negative : both;
    return TTC_CAN_BE_ANY;
}

unsigned ttc_conditions_signs_of_power(unsigned signs, unsigned long exponent)
{
    if (exponent % 2 == 1) return signs;
    return (signs & TTC_CAN_BE_ZERO) | (signs & ~(unsigned)TTC_CAN_BE_ZERO ? (unsigned)TTC_CAN_BE_POSITIVE : 0u);
}

unsigned ttc_conditions_signs(const ttc_conditions *c, const fmpz_mpoly_t polynomial)
{
    unsigned signs = TTC_CAN_BE_ZERO;
    fmpz_t coefficient;
    fmpz_init(coefficient);
    for (slong i = 0; i < fmpz_mpoly_length(polynomial, c->ring->context) && signs != TTC_CAN_BE_ANY; i++) {
        fmpz_mpoly_get_term_coeff_fmpz(coefficient, polynomial, i, c->ring->context);
        unsigned term = fmpz_sgn(coefficient) > 0 ? TTC_CAN_BE_POSITIVE : TTC_CAN_BE_NEGATIVE;
        for (slong v = 0; v < (slong)c->ring->variable_count; v++) {
            ulong exponent = fmpz_mpoly_get_term_var_exp_ui(polynomial, i, v, c->ring->context);
            const unsigned factor = ttc_conditions_signs_of_power(signs_of_variable(c, v), exponent);
            if (exponent > 0) term = ttc_conditions_signs_of_product(term, factor);
        }
        signs = ttc_conditions_signs_of_sum(signs, term);
    }
    fmpz_clear(coefficient);
    const int of_number = signs == TTC_CAN_BE_ANY ? ttc_ring_sign_of_number(c->ring, polynomial) : 0;
    return of_number > 0 ? TTC_CAN_BE_POSITIVE : of_number < 0 ? TTC_CAN_BE_NEGATIVE : signs;
}

/* Returns true if a condition of the list implies this one. None is strengthened, as the list may be rewound to any mark. */
static bool has(const ttc_conditions *c, const fmpz_mpoly_t polynomial, ttc_relation relation, bool of_quotient,
                bool is_denominator)
{
    for (size_t i = 0; i < c->count; i++) {
        const ttc_condition *item = &c->items[i];
        if (item->relation == relation && item->of_quotient <= of_quotient && item->is_denominator <= is_denominator &&
            fmpz_mpoly_equal(item->polynomial, polynomial, c->ring->context))
            return true;
    }
    return false;
}

static void append(ttc_conditions *c, const fmpz_mpoly_t polynomial, ttc_relation relation, bool of_quotient,
                   bool is_denominator)
{
    if (has(c, polynomial, relation, of_quotient, is_denominator)) return;
    c->failed |= !TTC_ARRAY_GROW(c->items, c->count);
    if (c->failed) return;
    ttc_condition *item = &c->items[c->count++];
    item->relation = relation;
    item->of_quotient = of_quotient;
    item->is_denominator = is_denominator;
    fmpz_mpoly_init(item->polynomial, c->ring->context);
    fmpz_mpoly_set(item->polynomial, polynomial, c->ring->context);
}

unsigned ttc_conditions_signs_in(ttc_relation relation)
{
    switch (relation) {
    case TTC_IS_POSITIVE: return TTC_CAN_BE_POSITIVE;
    case TTC_IS_NONNEGATIVE: return TTC_CAN_BE_POSITIVE | TTC_CAN_BE_ZERO;
    case TTC_IS_NONZERO: return TTC_CAN_BE_POSITIVE | TTC_CAN_BE_NEGATIVE;
    case TTC_IS_ZERO: break;
    }
    return TTC_CAN_BE_ZERO;
}

/* The signs that a polynomial can have by the signs of its variables, and by conditions on the polynomial or its opposite. */
static unsigned told_signs(const ttc_conditions *c, const fmpz_mpoly_struct *polynomial)
{
    unsigned signs = ttc_conditions_signs(c, polynomial);
    fmpz_mpoly_t negative;
    fmpz_mpoly_init(negative, c->ring->context);
    fmpz_mpoly_neg(negative, polynomial, c->ring->context);
    for (size_t i = 0; i < c->count; i++) {
        const ttc_condition *item = &c->items[i];
        const unsigned of_item = ttc_conditions_signs_in(item->relation);
        if (item->of_quotient) continue;
        if (fmpz_mpoly_equal(item->polynomial, polynomial, c->ring->context)) signs &= of_item;
        else if (fmpz_mpoly_equal(item->polynomial, negative, c->ring->context)) signs &= opposite(of_item);
    }
    fmpz_mpoly_clear(negative, c->ring->context);
    return signs;
}

bool ttc_conditions_clash(const ttc_conditions *c)
{
    const fmpz_mpoly_ctx_struct *context = c->ring->context;
    bool clash = c->contradictory;
    fmpz_mpoly_t sum;
    fmpz_mpoly_init(sum, context);
    for (size_t i = 0; i < c->count; i++)
        for (size_t k = 0; k < i && !clash; k++) {
            const unsigned a = ttc_conditions_signs_in(c->items[i].relation), b = ttc_conditions_signs_in(c->items[k].relation);
            if ((a & b) == 0) clash = fmpz_mpoly_equal(c->items[i].polynomial, c->items[k].polynomial, context);
            if ((a & opposite(b)) != 0 || clash) continue;
            fmpz_mpoly_add(sum, c->items[i].polynomial, c->items[k].polynomial, context);
            clash = fmpz_mpoly_is_zero(sum, context);
        }
    fmpz_mpoly_clear(sum, context);
    return clash;
}

static unsigned signs_of_factors(const ttc_conditions *c, const fmpz_mpoly_struct *polynomial)
{
    enum { LONGEST = 64 };
    unsigned signs = told_signs(c, polynomial);
    fmpz_mpoly_factor_t factors;
    if (signs != TTC_CAN_BE_ANY || fmpz_mpoly_length(polynomial, c->ring->context) > LONGEST) return signs;
    fmpz_mpoly_factor_init(factors, c->ring->context);
    if (fmpz_mpoly_factor(factors, polynomial, c->ring->context)) {
        signs = fmpz_sgn(factors->constant) > 0 ? TTC_CAN_BE_POSITIVE : TTC_CAN_BE_NEGATIVE;
        for (slong i = 0; i < factors->num; i++) {
            const unsigned of_factor = told_signs(c, factors->poly + i);
            const unsigned of_power = ttc_conditions_signs_of_power(of_factor, fmpz_get_ui(factors->exp + i));
            signs = ttc_conditions_signs_of_product(signs, of_power);
        }
    }
    fmpz_mpoly_factor_clear(factors, c->ring->context);
    return signs;
}

unsigned ttc_conditions_signs_of_ratio(const ttc_conditions *c, const ttc_ratio *ratio)
{
    const unsigned below = signs_of_factors(c, ratio->denominator);
    if (c->ring->status != TTC_RING_OK || below & TTC_CAN_BE_ZERO) return TTC_CAN_BE_ANY;
    return ttc_conditions_signs_of_product(signs_of_factors(c, ratio->numerator), below);
}

/* Divide by the number that divides all coefficients, and by variables that divide all terms and have one sign. */
static void divide_by_signed_content(const ttc_conditions *c, fmpz_mpoly_t polynomial)
{
    const fmpz_mpoly_ctx_struct *context = c->ring->context;
    fmpz_mpoly_t content;
    if (fmpz_mpoly_is_zero(polynomial, context)) return;
    fmpz_mpoly_init(content, context);
    fmpz_mpoly_term_content(content, polynomial, context);
    ulong *exponents = flint_calloc(c->ring->variable_count + 1, sizeof *exponents);
    bool negative = false;
    fmpz_mpoly_get_term_exp_ui(exponents, content, 0, context);
    for (slong v = 0; v < (slong)c->ring->variable_count; v++) {
        const unsigned signs = signs_of_variable(c, v);
        if (signs == TTC_CAN_BE_NEGATIVE) negative ^= exponents[v] % 2 == 1;
        else if (signs != TTC_CAN_BE_POSITIVE) exponents[v] = 0;
    }
    fmpz_mpoly_set_term_exp_ui(content, 0, exponents, context);
    fmpz_mpoly_divides(polynomial, polynomial, content, context);
    if (negative) fmpz_mpoly_neg(polynomial, polynomial, context);
    flint_free(exponents);
    fmpz_mpoly_clear(content, context);
}

static void require(ttc_conditions *c, fmpz_mpoly_t polynomial, ttc_relation relation, bool of_quotient)
{
    divide_by_signed_content(c, polynomial);
    unsigned possible = ttc_conditions_signs(c, polynomial);
    if ((possible & ttc_conditions_signs_in(relation)) == 0 && !of_quotient) c->contradictory = true;
    if ((possible & ~ttc_conditions_signs_in(relation)) != 0) append(c, polynomial, relation, of_quotient, false);
}

static void add(ttc_conditions *c, const ttc_ratio *ratio, ttc_relation relation, bool negative)
{
    fmpz_mpoly_t polynomial;
    if (c->ring->status != TTC_RING_OK) return;
    fmpz_mpoly_init(polynomial, c->ring->context);
    fmpz_mpoly_set(polynomial, ratio->numerator, c->ring->context);
    unsigned below = ttc_conditions_signs(c, ratio->denominator);
    if (relation == TTC_IS_POSITIVE || relation == TTC_IS_NONNEGATIVE) {
        /* Multiplying by the denominator is avoided where its sign is evident, to keep the degree low. */
        if (below == TTC_CAN_BE_NEGATIVE) negative = !negative;
        else if (below != TTC_CAN_BE_POSITIVE)
            fmpz_mpoly_mul(polynomial, polynomial, ratio->denominator, c->ring->context);
    }
    if (negative) fmpz_mpoly_neg(polynomial, polynomial, c->ring->context);
    require(c, polynomial, relation, (below & TTC_CAN_BE_ZERO) != 0);
    if (below & TTC_CAN_BE_ZERO) append(c, ratio->denominator, TTC_IS_NONZERO, true, true);
    fmpz_mpoly_clear(polynomial, c->ring->context);
}

void ttc_conditions_add(ttc_conditions *c, const ttc_ratio *ratio, ttc_relation relation) { add(c, ratio, relation, false); }

void ttc_conditions_add_negative(ttc_conditions *c, const ttc_ratio *ratio, ttc_relation relation)
{
    add(c, ratio, relation, true);
}

static bool depends(const ttc_ring *ring, const fmpz_mpoly_struct *polynomial, slong variable)
{
    return fmpz_mpoly_degree_si(polynomial, variable, ring->context) > 0;
}

/* Find the generators that occur in a condition, or in the square of one that is used. */
static void find_used(bool used[TTC_GENERATOR_LIMIT], const ttc_conditions *c)
{
    const ttc_ring *ring = c->ring;
    bool again = true;
    for (size_t i = 0; i < ring->generator_count; i++) {
        used[i] = false;
        for (size_t k = 0; !used[i] && k < c->count; k++)
            used[i] = depends(ring, c->items[k].polynomial, ring->generators[i].variable);
    }
    while (again) {
        again = false;
        for (size_t i = 0; i < ring->generator_count; i++)
            for (size_t k = 0; !used[i] && k < ring->generator_count; k++) {
                const ttc_ratio *square = &ring->generators[k].square;
                used[i] = used[k] && (depends(ring, square->numerator, ring->generators[i].variable) ||
                                      depends(ring, square->denominator, ring->generators[i].variable));
                again |= used[i];
            }
    }
}

const fmpz_mpoly_struct *ttc_conditions_at_denominator(ttc_conditions *out, const ttc_conditions *c, size_t index)
{
    const ttc_ring *ring = c->ring;
    const fmpz_mpoly_struct *zero = NULL;
    bool used[TTC_GENERATOR_LIMIT];
    size_t found = 0;
    find_used(used, c);
    ttc_conditions_init(out, c->valuation);
    out->at_denominator = true;
    for (size_t i = 0; i < c->count; i++) {
        const ttc_condition *item = &c->items[i];
        if (item->is_denominator && found++ == index) zero = item->polynomial;
        else if (!item->of_quotient) append(out, item->polynomial, item->relation, false, false);
        else if (item->relation == TTC_IS_POSITIVE || item->relation == TTC_IS_NONNEGATIVE) /* A/B = v: A B = v B^2 everywhere */
            append(out, item->polynomial, TTC_IS_NONNEGATIVE, false, false);
    }
    for (size_t i = 0; i < ring->generator_count && found <= index; i++) {
        const fmpz_mpoly_struct *denominator = ring->generators[i].square.denominator;
        if (used[i] && (ttc_conditions_signs(c, denominator) & TTC_CAN_BE_ZERO) && found++ == index) zero = denominator;
    }
    if (zero != NULL) append(out, zero, TTC_IS_ZERO, false, false);
    out->contradictory = c->contradictory;
    return zero;
}

void ttc_conditions_of_signs(ttc_conditions *out, const ttc_conditions *c)
{
    ttc_conditions_init(out, c->valuation);
    for (size_t i = 0; i < c->count; i++) {
        const ttc_condition *item = &c->items[i];
        if (item->relation != TTC_IS_NONZERO || item->is_denominator)
            append(out, item->polynomial, item->relation, item->of_quotient, item->is_denominator);
    }
    out->contradictory = c->contradictory;
    out->failed |= c->failed;
}

size_t ttc_conditions_mark(const ttc_conditions *c) { return c->count; }

void ttc_conditions_rewind(ttc_conditions *c, size_t mark, bool contradictory)
{
    while (c->count > mark) fmpz_mpoly_clear(c->items[--c->count].polynomial, c->ring->context);
    c->contradictory = contradictory;
}
