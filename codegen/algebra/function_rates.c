/* Rates of change of cosines, exponentials and logarithms, from the rates of their arguments. */
#include "algebra/valuation_state.h"

/* d cos(a) = -sin(a) da, d exp(a) = exp(a) da, d log(a) = da/a. Sines, roots of 1 - cos^2, are left to ttc_ratio_derive. */
static void function_rate(ttc_valuation *valuation, ttc_ratio *out, uint32_t symbol, const ttc_ratio *rates)
{
    const ttc_model *model = ttc_valuation_model(valuation);
    const ttc_symbol_entry *entry = &model->symbols[symbol];
    ttc_ring *ring = ttc_valuation_ring(valuation);
    ttc_ratio of;
    ttc_ratio_init(ring, &of);
    ttc_evaluate(valuation, &of, entry->definition);
    ttc_ratio_derive(ring, out, &of, rates);
    if (entry->kind == TTC_LOG) {
        ttc_ratio_divide(ring, out, out, &of);
    } else {
        ttc_evaluate(valuation, &of, entry->kind == TTC_EXP ? entry->node : model->symbols[entry->partner].node);
        ttc_ratio_multiply(ring, out, out, &of);
        if (entry->kind == TTC_COSINE) ttc_ratio_scale(ring, out, out, ring->minus_one);
    }
    ttc_ratio_clear(ring, &of);
}

/* Evaluate all bound symbols, as their expressions may use functions that have no value yet. */
static void evaluate_bound(ttc_valuation *valuation)
{
    ttc_ratio value;
    ttc_ratio_init(valuation->ring, &value);
    for (uint32_t i = 0; i < valuation->symbol_count; i++)
        if (ttc_valuation_is_bound(valuation, i)) ttc_valuation_value(valuation, &value, i);
    ttc_ratio_clear(valuation->ring, &value);
}

void ttc_valuation_add_function_rates(ttc_valuation *valuation, ttc_ratio *rates)
{
    const ttc_model *model = ttc_valuation_model(valuation);
    ttc_ring *ring = ttc_valuation_ring(valuation);
    bool changed = true;
    ttc_ratio rate;
    evaluate_bound(valuation);
    ttc_ratio_init(ring, &rate);
    for (size_t sweep = 0; changed && sweep <= model->symbol_count; sweep++) {
        changed = false;
        for (uint32_t i = 0; i < model->symbol_count && ring->status == TTC_RING_OK; i++) {
            ttc_symbol_kind kind = model->symbols[i].kind;
            if (kind != TTC_COSINE && kind != TTC_EXP && kind != TTC_LOG) continue;
            if (!ttc_valuation_has_value(valuation, i)) continue;
            ttc_ratio *known = &rates[ttc_valuation_variable(valuation, i)];
            function_rate(valuation, &rate, i, rates);
            changed |= !ttc_ratio_equal(ring, known, &rate);
            ttc_ratio_set(ring, known, &rate);
        }
    }
    ttc_ratio_clear(ring, &rate);
}
