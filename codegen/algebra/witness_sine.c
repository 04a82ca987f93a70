/* Signs of sines that are plus or minus an earlier root, by ring->choices: proofs cover both, at a point only one is right. */
#include "algebra/witness.h"

enum { PRECISION = 128 };

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
            ttc_ring_generator(point->ring, ttc_valuation_variable(v, i)) != NULL)
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
