#include "algebra/elimination.h"

#include <flint/fmpz_mpoly_factor.h>
#include <stdint.h>
#include <stdlib.h>

enum { DEPTH = 2, LOOKS = 1000, LONGEST = 64 };

static const size_t NONE = SIZE_MAX;

typedef struct {
    ttc_conditions known;
    int looks; /* polynomials that may still be examined */
} elimination;

static bool is_shown(elimination *e, const fmpz_mpoly_struct *f, bool strictly, int depth);

static const fmpz_mpoly_ctx_struct *context_of(const elimination *e) { return e->known.ring->context; }

static unsigned signs_of(const elimination *e, const fmpz_mpoly_struct *f)
{
    ttc_ratio value;
    ttc_ratio_init(e->known.ring, &value);
    fmpz_mpoly_set(value.numerator, f, context_of(e));
    const unsigned signs = ttc_conditions_signs_of_ratio(&e->known, &value);
    ttc_ratio_clear(e->known.ring, &value);
    return signs;
}

static void learn(elimination *e, const fmpz_mpoly_struct *f, ttc_relation relation)
{
    ttc_ratio value;
    ttc_ratio_init(e->known.ring, &value);
    fmpz_mpoly_set(value.numerator, f, context_of(e));
    ttc_conditions_add(&e->known, &value, relation);
    ttc_ratio_clear(e->known.ring, &value);
}

/* coefficient = that of variable^power in f. */
static void take_coefficient(const elimination *e, fmpz_mpoly_t coefficient, const fmpz_mpoly_struct *f, slong variable,
                             ulong power)
{
    fmpz_mpoly_get_coeff_vars_ui(coefficient, f, &variable, &power, 1, context_of(e));
}

/* Replace squares of those generators whose square is a polynomial. */
static void reduce(const elimination *e, fmpz_mpoly_t f)
{
    const ttc_ring *ring = e->known.ring;
    fmpz_mpoly_t square, quotient, rest;
    fmpz_mpoly_init(square, ring->context);
    fmpz_mpoly_init(quotient, ring->context);
    fmpz_mpoly_init(rest, ring->context);
    for (size_t i = ring->generator_count; i-- > 0;) {
        const ttc_generator *root = &ring->generators[i];
        if (!fmpz_mpoly_is_one(root->square.denominator, ring->context)) continue;
        fmpz_mpoly_gen(square, root->variable, ring->context);
        fmpz_mpoly_mul(square, square, square, ring->context);
        while (fmpz_mpoly_degree_si(f, root->variable, ring->context) > 1) {
            fmpz_mpoly_divrem(quotient, rest, f, square, ring->context);
            fmpz_mpoly_mul(quotient, quotient, root->square.numerator, ring->context);
            fmpz_mpoly_add(f, quotient, rest, ring->context);
        }
    }
    fmpz_mpoly_clear(rest, ring->context);
    fmpz_mpoly_clear(quotient, ring->context);
    fmpz_mpoly_clear(square, ring->context);
}

/* is_shown for f by its discriminant in a variable in which it is quadratic. */
static bool is_shown_by_discriminant(elimination *e, const fmpz_mpoly_struct *f, bool strictly, slong variable, int depth)
{
    const fmpz_mpoly_ctx_struct *context = context_of(e);
    const size_t mark = ttc_conditions_mark(&e->known);
    const bool contradictory = e->known.contradictory;
    bool shown = false;
    fmpz_mpoly_t a, b, c;
    fmpz_mpoly_init(a, context);
    fmpz_mpoly_init(b, context);
    fmpz_mpoly_init(c, context);
    take_coefficient(e, a, f, variable, 2);
    if (is_shown(e, a, true, depth)) {
        learn(e, a, TTC_IS_POSITIVE);
        take_coefficient(e, b, f, variable, 1);
        take_coefficient(e, c, f, variable, 0);
        fmpz_mpoly_mul(c, c, a, context);
        fmpz_mpoly_scalar_mul_si(c, c, 4, context);
        fmpz_mpoly_mul(b, b, b, context);
        fmpz_mpoly_sub(c, c, b, context);
        reduce(e, c);
        shown = is_shown(e, c, strictly, depth);
        ttc_conditions_rewind(&e->known, mark, contradictory);
    }
    fmpz_mpoly_clear(c, context);
    fmpz_mpoly_clear(b, context);
    fmpz_mpoly_clear(a, context);
    return shown;
}

/* rest = m f - k g, where m > 0 and the highest powers of a variable cancel. item: the condition on g; NONE: g is that power
 * itself, which is even. Returns the signs that k can have, 0 if the sign of m is not known. */
static unsigned cancel(const elimination *e, fmpz_mpoly_t rest, fmpz_mpoly_t k, const fmpz_mpoly_struct *f, slong variable,
                       size_t item)
{
    const fmpz_mpoly_ctx_struct *context = context_of(e);
    const ulong power = (ulong)fmpz_mpoly_degree_si(f, variable, context);
    fmpz_mpoly_t g, m;
    fmpz_mpoly_init(g, context);
    fmpz_mpoly_init(m, context);
    if (item == NONE) {
        fmpz_mpoly_gen(g, variable, context);
        fmpz_mpoly_pow_ui(g, g, power, context);
    } else {
        fmpz_mpoly_set(g, e->known.items[item].polynomial, context);
    }
    take_coefficient(e, m, g, variable, power);
    take_coefficient(e, k, f, variable, power);
    if (fmpz_mpoly_gcd(rest, m, k, context)) {
        fmpz_mpoly_divides(m, m, rest, context);
        fmpz_mpoly_divides(k, k, rest, context);
    }
    const unsigned of_m = signs_of(e, m);
    if (of_m == TTC_CAN_BE_NEGATIVE) {
        fmpz_mpoly_neg(m, m, context);
        fmpz_mpoly_neg(k, k, context);
    }
    const bool is_known = of_m == TTC_CAN_BE_NEGATIVE || of_m == TTC_CAN_BE_POSITIVE;
    if (is_known) {
        fmpz_mpoly_mul(g, g, k, context);
        fmpz_mpoly_mul(m, m, f, context);
        fmpz_mpoly_sub(rest, m, g, context);
        reduce(e, rest);
    }
    fmpz_mpoly_clear(m, context);
    fmpz_mpoly_clear(g, context);
    return is_known ? signs_of(e, k) : 0;
}

/* is_shown for f by a condition on g, in which a variable has the same highest power as in f. */
static bool is_shown_by_condition(elimination *e, const fmpz_mpoly_struct *f, bool strictly, slong variable, size_t item, int depth)
{
    const ttc_relation relation = item == NONE ? TTC_IS_NONNEGATIVE : e->known.items[item].relation;
    fmpz_mpoly_t rest, k;
    if (e->looks-- <= 0) return false;
    fmpz_mpoly_init(rest, context_of(e));
    fmpz_mpoly_init(k, context_of(e));
    const unsigned signs = cancel(e, rest, k, f, variable, item);
    const bool applies = signs != 0 && (relation == TTC_IS_ZERO || !(signs & TTC_CAN_BE_NEGATIVE));
    const bool gains = relation == TTC_IS_POSITIVE && signs == TTC_CAN_BE_POSITIVE;
    const bool shown = applies && is_shown(e, rest, strictly && !gains, depth - 1);
    fmpz_mpoly_clear(k, context_of(e));
    fmpz_mpoly_clear(rest, context_of(e));
    return shown;
}

static bool has_power(const elimination *e, size_t item, slong variable, slong power)
{
    return e->known.items[item].relation != TTC_IS_NONZERO && power > 0 &&
           power == fmpz_mpoly_degree_si(e->known.items[item].polynomial, variable, context_of(e));
}

/* is_shown for f by any condition, where the coefficient of the highest power of a variable is >= 0 or, if `negative`, <= 0. */
static bool is_shown_if(elimination *e, const fmpz_mpoly_struct *f, bool strictly, slong variable, slong power, bool negative,
                        int depth)
{
    const fmpz_mpoly_ctx_struct *context = context_of(e);
    const size_t mark = ttc_conditions_mark(&e->known);
    const bool contradictory = e->known.contradictory;
    bool shown = false;
    fmpz_mpoly_t k;
    fmpz_mpoly_init(k, context);
    take_coefficient(e, k, f, variable, (ulong)power);
    if (negative) fmpz_mpoly_neg(k, k, context);
    learn(e, k, TTC_IS_NONNEGATIVE);
    if (power % 2 == 0) shown = is_shown_by_condition(e, f, strictly, variable, NONE, depth);
    for (size_t i = 0; !shown && e->looks > 0 && i < mark; i++)
        if (has_power(e, i, variable, power)) shown = is_shown_by_condition(e, f, strictly, variable, i, depth);
    ttc_conditions_rewind(&e->known, mark, contradictory);
    fmpz_mpoly_clear(k, context);
    return shown;
}

/* is_shown for an irreducible f. */
static bool is_shown_by_elimination(elimination *e, const fmpz_mpoly_struct *f, bool strictly, int depth)
{
    const fmpz_mpoly_ctx_struct *context = context_of(e);
    const slong variables = (slong)e->known.ring->variable_count;
    bool shown = false;
    for (slong v = 0; !shown && e->looks > 0 && v < variables; v++)
        if (fmpz_mpoly_degree_si(f, v, context) == 2) shown = is_shown_by_discriminant(e, f, strictly, v, depth);
    for (size_t i = ttc_conditions_mark(&e->known); !shown && depth > 0 && i-- > 0;)
        for (slong v = 0; !shown && e->looks > 0 && v < variables; v++)
            if (has_power(e, i, v, fmpz_mpoly_degree_si(f, v, context)))
                shown = is_shown_by_condition(e, f, strictly, v, i, depth);
    for (slong v = 0; !shown && depth > 0 && e->looks > 0 && v < variables; v++) {
        const slong power = fmpz_mpoly_degree_si(f, v, context);
        shown = power > 0 && is_shown_if(e, f, strictly, v, power, true, depth) &&
                is_shown_if(e, f, strictly, v, power, false, depth);
    }
    return shown;
}

/* The variables that must be zero where a sum of terms of one sign is zero, because a term has no other factor that can be zero.
 * Returns flags, by variable, for free(). */
static bool *vanishing_with(const elimination *e, const fmpz_mpoly_struct *f)
{
    const fmpz_mpoly_ctx_struct *context = context_of(e);
    const slong variables = (slong)e->known.ring->variable_count;
    bool *vanishes = calloc((size_t)variables + 1, sizeof *vanishes);
    fmpz_mpoly_t variable;
    fmpz_mpoly_init(variable, context);
    for (slong i = 0; vanishes != NULL && i < fmpz_mpoly_length(f, context); i++) {
        slong zero = 0, count = 0;
        for (slong v = 0; v < variables; v++) {
            if (fmpz_mpoly_get_term_var_exp_ui(f, i, v, context) == 0) continue;
            fmpz_mpoly_gen(variable, v, context);
            if (!(ttc_conditions_signs(&e->known, variable) & TTC_CAN_BE_ZERO)) continue;
            zero = v;
            count++;
        }
        if (count == 1) vanishes[zero] = true;
    }
    fmpz_mpoly_clear(variable, context);
    return vanishes;
}

/* Returns true if f is a sum of terms of one sign, and a condition excludes that all its terms are zero. */
static bool is_never_zero(const elimination *e, const fmpz_mpoly_struct *f)
{
    const fmpz_mpoly_ctx_struct *context = context_of(e);
    bool contradicts = false;
    if (ttc_conditions_signs(&e->known, f) == TTC_CAN_BE_ANY) return false;
    bool *vanishes = vanishing_with(e, f);
    fmpz_mpoly_t there;
    fmpz_t zero;
    fmpz_mpoly_init(there, context);
    fmpz_init(zero);
    for (size_t i = 0; vanishes != NULL && !contradicts && i < e->known.count; i++) {
        fmpz_mpoly_set(there, e->known.items[i].polynomial, context);
        for (slong v = 0; v < (slong)e->known.ring->variable_count; v++)
            if (vanishes[v]) fmpz_mpoly_evaluate_one_fmpz(there, there, v, zero, context);
        contradicts = !(ttc_conditions_signs(&e->known, there) & ttc_conditions_signs_in(e->known.items[i].relation));
    }
    fmpz_clear(zero);
    fmpz_mpoly_clear(there, context);
    free(vanishes);
    return contradicts;
}

/* is_shown for a product by the signs of its factors; one factor whose sign is not known is left to the rules of elimination. */
static bool is_shown_by_factors(elimination *e, const fmpz_mpoly_factor_struct *factors, bool strictly, int depth)
{
    const fmpz_mpoly_ctx_struct *context = context_of(e);
    bool shown = true, negative = fmpz_sgn(factors->constant) < 0;
    slong unknown = -1;
    fmpz_mpoly_t opposite;
    for (slong i = 0; shown && i < factors->num; i++) {
        const unsigned signs = signs_of(e, factors->poly + i);
        const bool is_even = fmpz_is_even(factors->exp + i);
        if (strictly && (is_even || signs != TTC_CAN_BE_ANY))
            shown = !(signs & TTC_CAN_BE_ZERO) || is_never_zero(e, factors->poly + i);
        if (is_even) continue;
        if (!(signs & TTC_CAN_BE_POSITIVE)) {
            negative = !negative;
        } else if (signs & TTC_CAN_BE_NEGATIVE) {
            shown = shown && unknown < 0;
            unknown = i;
        }
    }
    if (!shown || unknown < 0) return shown && !negative;
    fmpz_mpoly_init(opposite, context);
    if (negative) fmpz_mpoly_neg(opposite, factors->poly + unknown, context);
    else fmpz_mpoly_set(opposite, factors->poly + unknown, context);
    shown = is_shown_by_elimination(e, opposite, strictly, depth);
    fmpz_mpoly_clear(opposite, context);
    return shown;
}

/* Returns true if f is shown to be positive, or if not `strictly` not negative, where the conditions hold. depth: number of
 * conditions that may still be used, one after the other. */
static bool is_shown(elimination *e, const fmpz_mpoly_struct *f, bool strictly, int depth)
{
    const fmpz_mpoly_ctx_struct *context = context_of(e);
    fmpz_mpoly_factor_t factors;
    bool shown = false;
    if (fmpz_mpoly_is_zero(f, context)) return !strictly;
    if (e->looks-- <= 0 || fmpz_mpoly_length(f, context) > LONGEST) return false;
    fmpz_mpoly_factor_init(factors, context);
    if (fmpz_mpoly_factor(factors, f, context)) shown = is_shown_by_factors(e, factors, strictly, depth);
    fmpz_mpoly_factor_clear(factors, context);
    return shown;
}

bool ttc_elimination_excludes(const ttc_conditions *conditions)
{
    elimination e;
    size_t last = conditions->count;
    bool shown = false;
    fmpz_mpoly_t f;
    while (last > 0 && conditions->items[last - 1].relation == TTC_IS_NONZERO) last--;
    if (last-- == 0) return false;
    ttc_conditions_init(&e.known, conditions->valuation);
    for (size_t i = 0; i < conditions->count; i++)
        if (i != last) learn(&e, conditions->items[i].polynomial, conditions->items[i].relation);
    fmpz_mpoly_init(f, context_of(&e));
    fmpz_mpoly_neg(f, conditions->items[last].polynomial, context_of(&e));
    const ttc_relation relation = conditions->items[last].relation;
    for (int depth = 0; !shown && !e.known.failed && depth <= DEPTH; depth++) {
        e.looks = LOOKS;
        shown = is_shown(&e, f, relation != TTC_IS_POSITIVE, depth);
        if (!shown && relation == TTC_IS_ZERO) shown = is_shown(&e, conditions->items[last].polynomial, true, depth);
    }
    shown = shown && e.known.ring->status == TTC_RING_OK && !e.known.failed;
    fmpz_mpoly_clear(f, context_of(&e));
    ttc_conditions_clear(&e.known);
    return shown;
}
