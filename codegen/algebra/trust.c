/* Classification of the functions of an angle or exponent by its linear relation to others modulo constants. */
#include "algebra/angle.h"
#include "algebra/independence.h"

#include <flint/fmpq_vec.h>
#include <stdlib.h>

/* slopes, shape (variable_count,): a different power of the parameter for each free variable, and 0 for the others, so that a
 * derivative along them is zero only if all partial derivatives by free variables are. */
static void set_slopes(ttc_ring *ring, ttc_ratio *slopes, slong parameter)
{
    for (slong v = 0; v < (slong)ring->variable_count; v++) {
        ttc_ratio_init(ring, &slopes[v]);
        if (v == parameter || ring->trust[v] != TTC_TRUST_FREE) continue;
        ttc_ratio_set_variable(ring, &slopes[v], parameter);
        fmpz_mpoly_pow_ui(slopes[v].numerator, slopes[v].numerator, (ulong)v + 1, ring->context);
    }
}

static ttc_trust trust_along(ttc_ring *ring, const ttc_ratio *slopes, ttc_ratio *rates, fmpq *weights, const ttc_ratio *angle,
                             const ttc_ratio *basis, size_t count)
{
    ttc_trust trust = TTC_TRUST_FREE;
    ttc_ratio rest, term;
    ttc_ratio_init(ring, &rest);
    ttc_ratio_init(ring, &term);
    for (size_t i = 0; i <= count; i++) {
        ttc_ratio_init(ring, &rates[i]);
        ttc_ratio_derive(ring, &rates[i], i < count ? basis + i : angle, slopes);
    }
    if (ttc_angle_weigh(ring, weights, &rates[count], rates, count)) {
        ttc_ratio_set(ring, &rest, angle);
        for (size_t i = 0; i < count; i++) {
            ttc_ratio_scale(ring, &term, basis + i, weights + i);
            ttc_ratio_subtract(ring, &rest, &rest, &term);
        }
        const bool is_free = ttc_ring_is_free(ring, rest.numerator) && ttc_ring_is_free(ring, rest.denominator);
        trust = is_free ? TTC_TRUST_ALGEBRAIC : TTC_TRUST_NONE;
        if (fmpz_mpoly_is_zero(rates[count].numerator, ring->context)) trust |= TTC_TRUST_CONSTANT;
    }
    for (size_t i = 0; i <= count; i++) ttc_ratio_clear(ring, &rates[i]);
    ttc_ratio_clear(ring, &term);
    ttc_ratio_clear(ring, &rest);
    return trust;
}

ttc_trust ttc_ring_trust(ttc_ring *ring, const ttc_ratio *angle, const ttc_ratio *basis, size_t count, slong parameter)
{
    ttc_trust trust = TTC_TRUST_NONE;
    ttc_ratio *all = malloc((count + 1) * sizeof *all); /* borrowed */
    bool settled = all != NULL;
    for (size_t i = 0; settled && i <= count; i++) all[i] = i < count ? basis[i] : *angle;
    settled = settled && ttc_ring_settles_all(ring, all, count + 1);
    free(all);
    if (!settled) return trust;
    ttc_ratio *slopes = malloc((ring->variable_count + 1) * sizeof *slopes), *rates = malloc((count + 1) * sizeof *rates);
    fmpq *weights = _fmpq_vec_init((slong)count + 1);
    if (slopes == NULL || rates == NULL) {
        ttc_ring_fail(ring, TTC_RING_NO_MEMORY);
    } else {
        set_slopes(ring, slopes, parameter);
        trust = trust_along(ring, slopes, rates, weights, angle, basis, count);
        for (size_t v = 0; v < ring->variable_count; v++) ttc_ratio_clear(ring, &slopes[v]);
    }
    _fmpq_vec_clear(weights, (slong)count + 1);
    free(rates);
    free(slopes);
    return trust;
}
