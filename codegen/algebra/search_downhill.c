/* Search for a point at which a ratio is not positive, downhill: from points of the domain, one variable at a time, by steps that
 * become shorter where none leads down. */
#include "algebra/search.h"

#include <math.h>

enum { STARTS = 6, STEPS = 2000, FIRST_STEP = 2, LAST_STEP = -24, PRECISION = 128, LONGEST = 256 };

static double value_at(ttc_witness *point, const ttc_ratio *ratio)
{
    arb_t ball;
    arb_init(ball);
    ttc_witness_enclose(ball, point, ratio, PRECISION);
    const double value = arb_is_finite(ball) ? arf_get_d(arb_midref(ball), ARF_RND_NEAR) : INFINITY;
    arb_clear(ball);
    return value;
}

/* Change a variable by a step if this leads down, and not out of the domain. */
static bool step_down(ttc_witness *point, const ttc_conditions *domain, const ttc_ratio *ratio, slong variable, const fmpq_t step,
                      double *value)
{
    fmpq_t before;
    fmpq_init(before);
    fmpq_set(before, point->values + variable);
    fmpq_add(point->values + variable, before, step);
    ttc_witness_changed(point);
    const double there = value_at(point, ratio);
    const bool is_lower = there < *value && ttc_search_meets(point, domain);
    if (is_lower) *value = there;
    else fmpq_set(point->values + variable, before);
    ttc_witness_changed(point);
    fmpq_clear(before);
    return is_lower;
}

static bool go_down(ttc_witness *point, const ttc_conditions *domain, const ttc_conditions *conditions, const ttc_ratio *ratio,
                    int *steps)
{
    double value = value_at(point, ratio);
    slong power = FIRST_STEP;
    fmpq_t step;
    fmpq_init(step);
    while (value > 0 && *steps > 0 && power >= LAST_STEP) {
        bool moves = false;
        for (slong v = 0; value > 0 && v < (slong)point->ring->variable_count; v++) {
            if (!ttc_witness_is_free(point, v)) continue;
            *steps -= 2;
            fmpq_one(step);
            if (power >= 0) fmpq_mul_2exp(step, step, (ulong)power);
            else fmpq_div_2exp(step, step, (ulong)-power);
            bool moved = step_down(point, domain, ratio, v, step, &value);
            fmpq_neg(step, step);
            moved = moved || step_down(point, domain, ratio, v, step, &value);
            moves |= moved;
        }
        if (!moves) power--;
    }
    fmpq_clear(step);
    return value <= 0 && ttc_search_meets(point, conditions);
}

bool ttc_search_downhill(ttc_witness *point, const ttc_conditions *conditions, size_t domain_count, const ttc_ratio *ratio)
{
    ttc_conditions domain = *conditions; /* a shallow copy */
    unsigned attempt = 0;
    int steps = STEPS;
    if (fmpz_mpoly_length(ratio->numerator, point->ring->context) > LONGEST) return false;
    domain.count = domain_count;
    for (int i = 0; i < STARTS && steps > 0 && ttc_search_next(point, &domain, &attempt); i++)
        if (go_down(point, &domain, conditions, ratio, &steps)) return true;
    return false;
}
