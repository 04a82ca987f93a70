#include "discover/factor_list.h"

#include <flint/fmpz_mpoly_factor.h>

void ttc_factors_init(ttc_factors *factors, const ttc_flow *flow)
{
    factors->flow = flow;
    factors->count = 0;
    factors->is_full = false;
}

void ttc_factors_clear(ttc_factors *factors)
{
    for (size_t i = 0; i < factors->count; i++) fmpz_mpoly_clear(&factors->items[i], factors->flow->ring->context);
    factors->count = 0;
}

void ttc_factors_add(ttc_factors *f, const fmpz_mpoly_t polynomial)
{
    const ttc_flow *flow = f->flow;
    bool is_new = true;
    ttc_ratio value, rate;
    ttc_ratio_init(flow->ring, &value);
    ttc_ratio_init(flow->ring, &rate);
    ttc_ratio_set_polynomial(flow->ring, &value, polynomial);
    for (size_t i = 0; i < f->count; i++) is_new &= fmpz_mpoly_equal(&f->items[i], polynomial, flow->ring->context) == 0;
    if (is_new && ttc_flow_moves(flow, &value)) {
        ttc_flow_logarithmic_rate(flow, &rate, &value);
        const bool is_integral = fmpz_mpoly_is_zero(rate.numerator, flow->ring->context) != 0;
        f->is_full |= !is_integral && f->count == TTC_FACTORS_MAX;
        if (!is_integral && f->count < TTC_FACTORS_MAX) {
            fmpz_mpoly_init(&f->items[f->count], flow->ring->context);
            fmpz_mpoly_set(&f->items[f->count++], polynomial, flow->ring->context);
        }
    }
    ttc_ratio_clear(flow->ring, &rate);
    ttc_ratio_clear(flow->ring, &value);
}

void ttc_factors_add_all(ttc_factors *f, const fmpz_mpoly_t polynomial)
{
    const fmpz_mpoly_ctx_struct *context = f->flow->ring->context;
    fmpz_mpoly_factor_t parts;
    fmpz_mpoly_t base;
    fmpz_mpoly_factor_init(parts, context);
    fmpz_mpoly_init(base, context);
    if (fmpz_mpoly_factor(parts, polynomial, context) != 0)
        for (slong i = 0; i < fmpz_mpoly_factor_length(parts, context); i++) {
            fmpz_mpoly_factor_get_base(base, parts, i, context);
            ttc_factors_add(f, base);
        }
    fmpz_mpoly_clear(base, context);
    fmpz_mpoly_factor_clear(parts, context);
}

static bool remove_equal(ttc_factors *f, const fmpz_mpoly_t polynomial)
{
    const fmpz_mpoly_ctx_struct *context = f->flow->ring->context;
    size_t kept = 0;
    for (size_t i = 0; i < f->count; i++) {
        if (fmpz_mpoly_equal(&f->items[i], polynomial, context) != 0) continue;
        if (kept < i) fmpz_mpoly_swap(&f->items[kept], &f->items[i], context);
        kept++;
    }
    const bool removed = kept < f->count;
    for (size_t i = kept; i < f->count; i++) fmpz_mpoly_clear(&f->items[i], context);
    f->count = kept;
    return removed;
}

void ttc_factors_drop_radicands(ttc_factors *f)
{
    const ttc_flow *flow = f->flow;
    for (size_t g = 0; g < flow->ring->generator_count; g++) {
        ttc_factors own;
        size_t longest = 0;
        ttc_factors_init(&own, flow);
        ttc_factors_add_all(&own, flow->ring->generators[g].square.numerator);
        for (size_t i = 1; i < own.count; i++)
            if (fmpz_mpoly_length(&own.items[i], flow->ring->context) > fmpz_mpoly_length(&own.items[longest], flow->ring->context))
                longest = i;
        if (own.count > 0) remove_equal(f, &own.items[longest]);
        ttc_factors_clear(&own);
    }
}

void ttc_factors_join_radicands(ttc_factors *f)
{
    for (size_t g = 0; g < f->flow->ring->generator_count; g++) {
        const ttc_generator *generator = &f->flow->ring->generators[g];
        ttc_factors own;
        bool removed = false;
        ttc_factors_init(&own, f->flow);
        ttc_factors_add_all(&own, generator->square.numerator);
        for (size_t i = 0; i < own.count; i++) removed |= remove_equal(f, &own.items[i]);
        if (removed) ttc_factors_add(f, generator->square.numerator);
        ttc_factors_clear(&own);
    }
}
