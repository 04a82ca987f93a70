/* Relations of angles are found by comparing numerators over a common denominator, coefficient by coefficient. */
#include "algebra/angle.h"

#include <flint/fmpq_mat.h>
#include <flint/fmpq_vec.h>
#include <stdlib.h>

/* denominator = least common multiple of itself and the denominator of a */
static void include_denominator(ttc_ring *ring, fmpz_mpoly_t denominator, const ttc_ratio *a)
{
    fmpz_mpoly_t common, rest;
    fmpz_mpoly_init(common, ring->context);
    fmpz_mpoly_init(rest, ring->context);
    if (fmpz_mpoly_gcd(common, denominator, a->denominator, ring->context)
        && fmpz_mpoly_divides(rest, a->denominator, common, ring->context))
        fmpz_mpoly_mul(denominator, denominator, rest, ring->context);
    else
        ttc_ring_fail(ring, TTC_RING_TOO_LARGE);
    fmpz_mpoly_clear(rest, ring->context);
    fmpz_mpoly_clear(common, ring->context);
}

/* One equation for each term of each column: the weighted sum of its coefficients in the other columns is that in the last one.
 * Terms that occur in several columns repeat an equation. */
static void fill_equations(ttc_ring *ring, fmpq_mat_t equations, fmpz_mpoly_t *columns, size_t count, ulong *exponents)
{
    slong row = 0;
    fmpz_t coefficient, one;
    fmpz_init(coefficient);
    fmpz_init_set_ui(one, 1);
    for (size_t from = 0; from < count; from++)
        for (slong term = 0; term < fmpz_mpoly_length(columns[from], ring->context); term++, row++) {
            fmpz_mpoly_get_term_exp_ui(exponents, columns[from], term, ring->context);
            for (size_t j = 0; j < count; j++) {
                fmpz_mpoly_get_coeff_fmpz_ui(coefficient, columns[j], exponents, ring->context);
                fmpq_set_fmpz_frac(fmpq_mat_entry(equations, row, (slong)j), coefficient, one);
            }
        }
    fmpz_clear(one);
    fmpz_clear(coefficient);
}

/* Solve equations whose columns, except the last, are independent. Returns false if there is no solution. */
static bool solve(fmpq *weights, fmpq_mat_t equations, size_t count)
{
    if (fmpq_mat_rref(equations, equations) > (slong)count) return false;
    for (size_t i = 0; i < count; i++) fmpq_set(weights + i, fmpq_mat_entry(equations, (slong)i, (slong)count));
    return true;
}

bool ttc_angle_weigh(ttc_ring *ring, fmpq *weights, const ttc_ratio *angle, const ttc_ratio *basis, size_t count)
{
    bool related = false;
    fmpz_mpoly_t denominator, factor;
    fmpz_mpoly_t *columns = calloc(count + 1, sizeof *columns);
    ulong *exponents = calloc(ring->variable_count + 1, sizeof *exponents);
    slong terms = 0;

    if (columns == NULL || exponents == NULL) {
        free(columns);
        free(exponents);
        ttc_ring_fail(ring, TTC_RING_NO_MEMORY);
        return false;
    }
    fmpz_mpoly_init(denominator, ring->context);
    fmpz_mpoly_init(factor, ring->context);
    fmpz_mpoly_one(denominator, ring->context);
    for (size_t j = 0; j <= count; j++) include_denominator(ring, denominator, j < count ? basis + j : angle);
    for (size_t j = 0; j <= count; j++) {
        const ttc_ratio *a = j < count ? basis + j : angle;
        fmpz_mpoly_init(columns[j], ring->context);
        if (fmpz_mpoly_divides(factor, denominator, a->denominator, ring->context))
            fmpz_mpoly_mul(columns[j], a->numerator, factor, ring->context);
        terms += fmpz_mpoly_length(columns[j], ring->context);
    }
    if (ring->status == TTC_RING_OK) {
        fmpq_mat_t equations;
        fmpq_mat_init(equations, terms, (slong)count + 1);
        fill_equations(ring, equations, columns, count + 1, exponents);
        related = solve(weights, equations, count);
        fmpq_mat_clear(equations);
    }
    for (size_t j = 0; j <= count; j++) fmpz_mpoly_clear(columns[j], ring->context);
    fmpz_mpoly_clear(factor, ring->context);
    fmpz_mpoly_clear(denominator, ring->context);
    free(exponents);
    free(columns);
    return related;
}

ttc_angle_relation ttc_angle_relate(ttc_ring *ring, long *multiples, fmpq *quarters, const ttc_ratio *angle, const ttc_ratio *basis,
                                    size_t count)
{
    fmpq *weights = _fmpq_vec_init((slong)count + 1);
    ttc_angle_relation relation = ttc_angle_weigh(ring, weights, angle, basis, count) ? TTC_ANGLE_WHOLE : TTC_ANGLE_FREE;
    if (relation == TTC_ANGLE_WHOLE && quarters != NULL && ttc_angle_has_roots(weights)) {
        fmpq_set(quarters, weights);
        fmpq_zero(weights);
    }
    for (size_t i = 0; i < count && relation == TTC_ANGLE_WHOLE; i++)
        if (!fmpz_is_one(fmpq_denref(weights + i))) relation = TTC_ANGLE_FRACTION;
    for (size_t i = 0; i < count && relation == TTC_ANGLE_WHOLE; i++) {
        const fmpz *multiple = fmpq_numref(weights + i);
        if (fmpz_cmp_si(multiple, TTC_ANGLE_MULTIPLE_LIMIT) > 0 || fmpz_cmp_si(multiple, -TTC_ANGLE_MULTIPLE_LIMIT) < 0)
            ttc_ring_fail(ring, TTC_RING_LARGE_MULTIPLE);
        else multiples[i] = fmpz_get_si(multiple);
    }
    _fmpq_vec_clear(weights, (slong)count + 1);
    return relation;
}

/* One pass in the order given. *fraction is the position, in this order, of the first angle that is a fraction of chosen ones and
 * was not tried as the first; count if there is none. */
static size_t choose_in_order(ttc_ring *ring, size_t *chosen, const ttc_ratio *angles, const size_t *order, size_t count,
                              bool has_turn, const bool *tried, size_t *fraction)
{
    ttc_ratio basis[TTC_ANGLE_LIMIT]; /* borrowed */
    long multiples[TTC_ANGLE_LIMIT];
    size_t found = 0;
    fmpq_t quarters;
    fmpq_init(quarters);
    *fraction = count;
    for (size_t i = 0; i < count && ring->status == TTC_RING_OK; i++) {
        fmpq *turn = has_turn && found > 0 ? quarters : NULL;
        ttc_angle_relation relation = ttc_angle_relate(ring, multiples, turn, angles + order[i], basis, found);
        if (relation == TTC_ANGLE_FREE) {
            basis[found] = angles[order[i]];
            chosen[found++] = order[i];
        } else if (relation == TTC_ANGLE_FRACTION && !tried[order[i]] && *fraction == count) {
            *fraction = i;
        }
    }
    fmpq_clear(quarters);
    return found;
}

size_t ttc_angle_choose(ttc_ring *ring, size_t *chosen, const ttc_ratio *angles, size_t count, size_t fixed, bool has_turn)
{
    size_t order[TTC_ANGLE_LIMIT], fraction = count, found;
    bool tried[TTC_ANGLE_LIMIT];
    for (size_t i = 0; i < count; i++) {
        order[i] = i;
        tried[i] = i < fixed;
    }
    for (;;) {
        found = choose_in_order(ring, chosen, angles, order, count, has_turn, tried, &fraction);
        if (fraction == count) return found;
        size_t first = order[fraction];
        for (size_t i = fraction; i > fixed; i--) order[i] = order[i - 1];
        order[fixed] = first;
        tried[first] = true;
    }
}
