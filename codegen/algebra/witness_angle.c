/* Angles of cosines that zero levels have bound, which follow from these. */
#include "algebra/witness.h"

uint32_t ttc_witness_angle_of(const ttc_witness *point, slong variable)
{
    const ttc_model *model = ttc_valuation_model(point->valuation);
    size_t symbol = ttc_valuation_symbol(point->valuation, variable);
    for (uint32_t i = 1; symbol < model->symbol_count && i < model->symbol_count; i++) {
        bool is_given = model->symbols[i].kind == TTC_COSINE && ttc_valuation_is_bound(point->valuation, i);
        if (is_given && model->symbols[i].definition == model->symbols[symbol].node) return i;
    }
    return 0;
}

bool ttc_witness_has_obscure_angle(const ttc_witness *point)
{
    const ttc_model *model = ttc_valuation_model(point->valuation);
    for (uint32_t i = 1; i < model->symbol_count; i++) {
        if (model->symbols[i].kind != TTC_COSINE || !ttc_valuation_is_bound(point->valuation, i)) continue;
        if (ttc_kind_of(model->graph, model->symbols[i].definition) != TTC_SYMBOL) return true;
        uint32_t angle = ttc_symbol_of(model->graph, model->symbols[i].definition);
        const ttc_symbol_kind kind = model->symbols[angle].kind;
        if (kind != TTC_STATE && kind != TTC_PARAM && kind != TTC_LEVEL) return true;
        if (ttc_valuation_is_bound(point->valuation, angle)) return true;
    }
    return false;
}

/* A number that the symbol's value exceeds, or that it stays below; NULL if none is known. */
static const fmpq *end_of(const ttc_model *model, ttc_id end)
{
    return end != TTC_NONE && ttc_kind_of(model->graph, end) == TTC_NUMBER ? ttc_coefficient(model->graph, end) : NULL;
}

void ttc_witness_add_turns(arb_t angle, const ttc_model *model, size_t symbol, slong precision)
{
    const ttc_symbol_entry *entry = &model->symbols[symbol];
    const bool is_positive = entry->kind == TTC_PARAM && (entry->sign == TTC_POSITIVE || entry->sign == TTC_NONNEGATIVE);
    const fmpq *low = end_of(model, entry->low), *high = end_of(model, entry->high);
    arb_t turn, rest;
    fmpz_t turns;
    if (low == NULL && high == NULL && !is_positive) return;
    arb_init(turn);
    arb_init(rest);
    fmpz_init(turns);
    if (low != NULL || high != NULL) arb_set_fmpq(rest, low != NULL ? low : high, precision);
    arb_const_pi(turn, precision);
    arb_mul_2exp_si(turn, turn, 1);
    arb_sub(rest, rest, angle, precision);
    arb_div(rest, rest, turn, precision);
    if (low != NULL || is_positive) arb_floor(rest, rest, precision);
    else arb_ceil(rest, rest, precision);
    if (arb_get_unique_fmpz(turns, rest)) {
        fmpz_add_si(turns, turns, low != NULL || is_positive ? 1 : -1);
        arb_addmul_fmpz(angle, turn, turns, precision);
    } else {
        arb_indeterminate(angle); /* with more digits it might get other turns, and conditions would speak of two points */
    }
    fmpz_clear(turns);
    arb_clear(rest);
    arb_clear(turn);
}
