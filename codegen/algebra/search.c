/* Search for a real point that meets conditions: small rational numbers first, then the solver. */
#include "algebra/search.h"

#include "algebra/elimination.h"
#include "algebra/solver.h"
#include "base/random.h"

enum { EARLY_ATTEMPTS = 48, LATE_ATTEMPTS = 600 };

/* A positive rational number: simple ones in early attempts, any in later ones. */
static void magnitude(fmpq_t out, unsigned attempt, uint64_t random)
{
    static const unsigned char top[] = { 1, 2, 1, 3, 1, 3, 2, 5, 1, 7, 4, 11, 1, 10, 1, 100 };
    static const unsigned char bottom[] = { 1, 1, 2, 1, 3, 2, 3, 1, 5, 2, 3, 4, 10, 1, 100, 1 };
    size_t pool = attempt < 4 ? 1 : attempt < 16 ? 6 : sizeof top;
    size_t i = (size_t)(random % pool);
    fmpq_set_si(out, top[i], bottom[i]);
    if (attempt >= EARLY_ATTEMPTS) { /* any fraction, to get away from the zeros of small polynomials */
        fmpq_t other;
        fmpq_init(other);
        fmpq_set_si(other, (slong)(random >> 8 & 255) + 1, (ulong)(random >> 16 & 63) + 1);
        fmpq_mul(out, out, other);
        fmpq_clear(other);
    }
}

static void choose_state(fmpq_t out, const ttc_graph *graph, const ttc_symbol_entry *entry, unsigned attempt, uint64_t random)
{
    const fmpq *low = ttc_number_value(graph, entry->low), *high = ttc_number_value(graph, entry->high);
    magnitude(out, attempt, random);
    if (low != NULL && high != NULL) {
        fmpq_t width;
        fmpq_init(width);
        fmpq_sub(width, high, low);
        fmpq_set_si(out, attempt == 0 ? 1 : (slong)(random % 15) + 1, attempt == 0 ? 2 : 16);
        /* In every other attempt near an end: in all, one of many states would always be near its end. */
        const bool may_be_near = attempt >= EARLY_ATTEMPTS && attempt % 2 != 0;
        if (may_be_near && random >> 8 & 1) fmpq_div_2exp(out, out, random >> 9 & 31);
        if (may_be_near && random >> 16 & 1) { /* near the upper end as well */
            fmpq_sub_si(out, out, 1);
            fmpq_neg(out, out);
        }
        fmpq_mul(out, out, width);
        fmpq_add(out, out, low);
        fmpq_clear(width);
    } else if (low != NULL) {
        fmpq_add(out, out, low);
    } else if (high != NULL) {
        fmpq_sub(out, high, out);
    } else if (random >> 32 & 1) {
        if (attempt > 8 && (random >> 33) % 8 == 0) fmpq_zero(out);
        else fmpq_neg(out, out);
    }
}

static void choose_param(fmpq_t out, const ttc_graph *graph, const ttc_symbol_entry *entry, unsigned attempt, uint64_t random)
{
    const fmpq *value = ttc_number_value(graph, entry->value);
    magnitude(out, attempt, random);
    if (value != NULL && (attempt == 0 || attempt % 3 == 1)) fmpq_set(out, value);
    else if (entry->sign == TTC_ANY_SIGN && random >> 32 & 1 && attempt > 8 && (random >> 33) % 4 == 0) fmpq_zero(out);
    else if (entry->sign == TTC_NONNEGATIVE && (random >> 32) % 8 == 0) fmpq_zero(out);
    else if ((entry->sign == TTC_ANY_SIGN || entry->sign == TTC_NONZERO) && random >> 32 & 1) fmpq_neg(out, out);
}

static void choose(ttc_witness *point, unsigned attempt)
{
    const ttc_model *model = ttc_valuation_model(point->valuation);
    for (slong v = 0; v < (slong)point->ring->variable_count; v++) {
        if (!ttc_witness_is_free(point, v)) continue;
        size_t symbol = ttc_valuation_symbol(point->valuation, v);
        uint64_t random = ttc_random_bits(&(uint64_t){ ((uint64_t)attempt << 20) + (uint64_t)v });
        const ttc_symbol_entry *entry = symbol < model->symbol_count ? &model->symbols[symbol] : NULL;
        if (entry != NULL && entry->kind == TTC_STATE)
            choose_state(point->values + v, model->graph, entry, attempt, random);
        else if (entry != NULL && entry->kind == TTC_PARAM)
            choose_param(point->values + v, model->graph, entry, attempt, random);
        else {
            magnitude(point->values + v, attempt, random);
            if (random >> 32 & 1) fmpq_neg(point->values + v, point->values + v);
        }
    }
    point->negative = (unsigned)(ttc_random_bits(&(uint64_t){ attempt }) >> 40) & (attempt == 0 ? 0 : ~0u);
    ttc_witness_changed(point);
}

bool ttc_search_meets(ttc_witness *point, const ttc_conditions *conditions)
{
    return ttc_witness_meets_all(point, conditions) == TTC_HOLDS && ttc_witness_sines(point) == TTC_HOLDS;
}

bool ttc_search_attempt(ttc_witness *point, const ttc_conditions *conditions, unsigned attempt)
{
    choose(point, attempt);
    return ttc_search_meets(point, conditions);
}

static bool try_numbers(ttc_witness *point, const ttc_conditions *conditions, unsigned *attempt, unsigned end)
{
    while (*attempt < end)
        if (ttc_search_attempt(point, conditions, (*attempt)++)) return true;
    return false;
}

bool ttc_search_next(ttc_witness *point, const ttc_conditions *conditions, unsigned *attempt)
{
    return try_numbers(point, conditions, attempt, LATE_ATTEMPTS);
}

bool ttc_search_with(ttc_witness *point, const ttc_conditions *conditions, slong variable, const fmpq_t value)
{
    for (unsigned attempt = 0; attempt < EARLY_ATTEMPTS; attempt++) {
        choose(point, attempt);
        fmpq_set(point->values + variable, value);
        if (ttc_search_meets(point, conditions)) return true;
    }
    return false;
}

/* Whether a variable can be zero, and at most one condition of another relation than NONZERO contains it. */
static bool is_at_large(const ttc_conditions *conditions, slong variable)
{
    size_t count = 0;
    fmpz_mpoly_t itself;
    fmpz_mpoly_init(itself, conditions->ring->context);
    fmpz_mpoly_gen(itself, variable, conditions->ring->context);
    const bool can_be_zero = ttc_conditions_signs(conditions, itself) & TTC_CAN_BE_ZERO;
    fmpz_mpoly_clear(itself, conditions->ring->context);
    for (size_t i = 0; i < conditions->count; i++)
        count += conditions->items[i].relation != TTC_IS_NONZERO &&
                 fmpz_mpoly_degree_si(conditions->items[i].polynomial, variable, conditions->ring->context) > 0;
    return can_be_zero && count <= 1;
}

/* Try points at which all variables at large are zero, as velocities are at rest, where an energy may be. */
static bool try_rest(ttc_witness *point, const ttc_conditions *conditions)
{
    for (unsigned attempt = 0; attempt < EARLY_ATTEMPTS; attempt++) {
        choose(point, attempt);
        for (slong v = 0; v < (slong)point->ring->variable_count; v++)
            if (ttc_witness_is_free(point, v) && is_at_large(conditions, v)) fmpq_zero(point->values + v);
        ttc_witness_changed(point);
        if (ttc_search_meets(point, conditions)) return true;
    }
    return false;
}

ttc_search_result ttc_search_point(ttc_witness *point, const ttc_conditions *conditions)
{
    if (ttc_conditions_clash(conditions)) return TTC_POINT_IMPOSSIBLE;
    if (conditions->failed) return TTC_POINT_NOT_DECIDED;
    unsigned attempt = 0;
    if (try_numbers(point, conditions, &attempt, EARLY_ATTEMPTS) || try_rest(point, conditions)) return TTC_POINT_FOUND;
    if (ttc_solver_has_excluded(point, conditions)) return TTC_POINT_EXCLUDED; /* elimination did not decide it then */
    if (ttc_elimination_excludes(conditions)) return TTC_POINT_IMPOSSIBLE;
    choose(point, 0); /* simple values for variables that no condition uses, which the solver leaves as they are */
    ttc_solver_answer answer = ttc_solver_ask(point, conditions, false);
    if (answer == TTC_SOLVER_NO_POINT) return TTC_POINT_EXCLUDED;
    if (answer == TTC_SOLVER_POINT && ttc_search_meets(point, conditions)) return TTC_POINT_FOUND;
    if (ttc_search_next(point, conditions, &attempt)) return TTC_POINT_FOUND;
    if (answer == TTC_SOLVER_SILENT) return TTC_POINT_NOT_DECIDED;
    choose(point, 0);
    answer = ttc_solver_ask(point, conditions, true); /* its first answer was wrong in the values of functions */
    if (answer == TTC_SOLVER_NO_POINT) return TTC_POINT_EXCLUDED;
    return answer == TTC_SOLVER_POINT && ttc_search_meets(point, conditions) ? TTC_POINT_FOUND : TTC_POINT_NOT_DECIDED;
}
