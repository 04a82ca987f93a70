/* What the angles of cosines that zero levels have bound tell of states, parameters and levels. */
#include "algebra/witness.h"

/* Returns true if the angle is linear in the variable with a number as its slope. */
static bool has_slope(fmpq_t slope, const ttc_ring *ring, const ttc_ratio *angle, slong variable)
{
    fmpz_mpoly_t derivative;
    fmpz_mpoly_init(derivative, ring->context);
    fmpz_mpoly_derivative(derivative, angle->numerator, variable, ring->context);
    const bool has = !fmpz_mpoly_is_zero(derivative, ring->context) && fmpz_mpoly_is_fmpz(derivative, ring->context) &&
                     fmpz_mpoly_is_fmpz(angle->denominator, ring->context);
    if (has) {
        fmpz_mpoly_get_fmpz(fmpq_numref(slope), derivative, ring->context);
        fmpz_mpoly_get_fmpz(fmpq_denref(slope), angle->denominator, ring->context);
        fmpq_canonicalise(slope);
    }
    fmpz_mpoly_clear(derivative, ring->context);
    return has;
}

/* The first variable that the angle tells, and that no other angle does; -1 if there is none. */
static slong told_by(const ttc_witness *point, const ttc_ratio *angle)
{
    const ttc_model *model = ttc_valuation_model(point->valuation);
    slong told = -1;
    fmpq_t slope;
    fmpq_init(slope);
    for (slong v = 0; told < 0 && v < (slong)point->ring->variable_count; v++) {
        const size_t symbol = ttc_valuation_symbol(point->valuation, v);
        const ttc_symbol_kind kind = symbol < model->symbol_count ? model->symbols[symbol].kind : TTC_COSINE;
        if ((kind == TTC_STATE || kind == TTC_PARAM || kind == TTC_LEVEL) && ttc_ring_generator(point->ring, v) == NULL &&
            point->angles[v] == 0 && has_slope(slope, point->ring, angle, v))
            told = v;
    }
    fmpq_clear(slope);
    return told;
}

void ttc_witness_find_angles(ttc_witness *point)
{
    const ttc_model *model = ttc_valuation_model(point->valuation);
    ttc_ratio angle;
    ttc_ratio_init(point->ring, &angle);
    for (uint32_t i = 1; i < model->symbol_count; i++) {
        if (model->symbols[i].kind != TTC_COSINE || !ttc_valuation_is_bound(point->valuation, i)) continue;
        ttc_evaluate(point->valuation, &angle, model->symbols[i].definition);
        const slong told = told_by(point, &angle);
        if (told >= 0) point->angles[told] = i;
        else point->has_obscure_angle = true;
    }
    ttc_ratio_clear(point->ring, &angle);
}

/* The interval's ends count if they are numbers; a parameter that is not negative has the lower end 0. */
void ttc_witness_add_turns(arb_t value, const fmpq_t slope, const ttc_model *model, size_t symbol, slong precision)
{
    const ttc_symbol_entry *entry = &model->symbols[symbol];
    const bool is_positive = entry->kind == TTC_PARAM && (entry->sign == TTC_POSITIVE || entry->sign == TTC_NONNEGATIVE);
    const fmpq *low = ttc_number_value(model->graph, entry->low), *high = ttc_number_value(model->graph, entry->high);
    arb_t turn, rest;
    fmpz_t turns;
    if (low == NULL && high == NULL && !is_positive) return;
    arb_init(turn);
    arb_init(rest);
    fmpz_init(turns);
    if (low != NULL || high != NULL) arb_set_fmpq(rest, low != NULL ? low : high, precision);
    arb_const_pi(turn, precision);
    arb_mul_2exp_si(turn, turn, 1);
    arb_div_fmpz(turn, turn, fmpq_numref(slope), precision);
    arb_mul_fmpz(turn, turn, fmpq_denref(slope), precision);
    arb_abs(turn, turn);
    arb_sub(rest, rest, value, precision);
    arb_div(rest, rest, turn, precision);
    if (low != NULL || is_positive) arb_floor(rest, rest, precision);
    else arb_ceil(rest, rest, precision);
    if (arb_get_unique_fmpz(turns, rest)) {
        fmpz_add_si(turns, turns, low != NULL || is_positive ? 1 : -1);
        arb_addmul_fmpz(value, turn, turns, precision);
    } else {
        arb_indeterminate(value); /* with more digits it might get other turns, and conditions would speak of two points */
    }
    fmpz_clear(turns);
    arb_clear(rest);
    arb_clear(turn);
}

void ttc_witness_split_angle(fmpq_t slope, ttc_ratio *rest, const ttc_witness *point, slong variable)
{
    const ttc_model *model = ttc_valuation_model(point->valuation);
    fmpz_t zero;
    fmpz_init(zero);
    ttc_evaluate(point->valuation, rest, model->symbols[point->angles[variable]].definition);
    has_slope(slope, point->ring, rest, variable);
    fmpz_mpoly_evaluate_one_fmpz(rest->numerator, rest->numerator, variable, zero, point->ring->context);
    fmpz_clear(zero);
}
