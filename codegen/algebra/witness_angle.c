/* Angles at a point: the turns that intervals add to them, and signs of sines that are plus or minus an earlier root, by
 * ring->choices: proofs cover both, at a point only one is right. */
#include "algebra/witness.h"

enum { PRECISION = 128 };

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

ttc_truth ttc_witness_angles_have_signs(ttc_witness *point, const ttc_conditions *conditions)
{
    ttc_truth truth = TTC_HOLDS;
    ttc_ratio angle;
    arb_t ball;
    ttc_ratio_init(point->ring, &angle);
    arb_init(ball);
    for (slong v = 0; truth != TTC_FAILS && v < (slong)point->ring->variable_count; v++) {
        if (ttc_witness_angle_of(point, v) == 0) continue;
        ttc_ratio_set_variable(point->ring, &angle, v);
        const unsigned signs = ttc_conditions_signs(conditions, angle.numerator);
        ttc_witness_enclose(ball, point, &angle, PRECISION);
        const bool may_be_zero = arb_contains_zero(ball) && !arb_is_zero(ball);
        const unsigned sign = arb_is_zero(ball) ? TTC_CAN_BE_ZERO : arb_is_positive(ball) ? TTC_CAN_BE_POSITIVE : TTC_CAN_BE_NEGATIVE;
        if (signs != TTC_CAN_BE_ANY && may_be_zero) truth = TTC_UNCLEAR;
        else if (!may_be_zero && !(signs & sign)) truth = TTC_FAILS;
    }
    arb_clear(ball);
    ttc_ratio_clear(point->ring, &angle);
    return truth;
}

/* Compare the chosen value `sine`, which is overwritten, with the sine of the angle, the expression `angle`. */
static ttc_truth compare(ttc_witness *point, ttc_ratio *sine, ttc_id angle)
{
    ttc_truth truth = TTC_HOLDS;
    arb_t chosen, actual;
    arb_init(chosen);
    arb_init(actual);
    ttc_witness_enclose(chosen, point, sine, PRECISION);
    ttc_evaluate(point->valuation, sine, angle);
    ttc_witness_enclose(actual, point, sine, PRECISION);
    arb_sin(actual, actual, PRECISION);
    if (!arb_overlaps(chosen, actual)) truth = TTC_FAILS;
    else if (arb_contains_zero(chosen)) truth = TTC_UNCLEAR;
    arb_clear(actual);
    arb_clear(chosen);
    return truth;
}

ttc_truth ttc_witness_sines(ttc_witness *point)
{
    ttc_valuation *v = point->valuation;
    const ttc_model *model = ttc_valuation_model(v);
    ttc_truth truth = TTC_HOLDS;
    ttc_ratio value;
    ttc_ratio_init(point->ring, &value);
    for (uint32_t i = 1; truth == TTC_HOLDS && i < model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &model->symbols[i];
        if (entry->kind != TTC_SINE || !ttc_valuation_has_value(v, i) || ttc_valuation_is_bound(v, entry->partner) ||
            ttc_ring_is_generator(point->ring, ttc_valuation_variable(v, i)))
            continue;
        ttc_evaluate(v, &value, model->symbols[entry->partner].node);
        const slong cosine = ttc_valuation_variable(v, entry->partner);
        if (!fmpz_mpoly_is_gen(value.numerator, cosine, point->ring->context)) continue; /* both follow from other angles */
        ttc_evaluate(v, &value, entry->node);
        truth = compare(point, &value, entry->definition);
    }
    ttc_ratio_clear(point->ring, &value);
    return truth;
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
    }
    fmpz_clear(turns);
    arb_clear(rest);
    arb_clear(turn);
}
