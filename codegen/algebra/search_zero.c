/* Search for a point at which a polynomial is zero, between two of its signs: on a line along which one variable changes. What is
 * found is a variable within an interval. Wherever it is there, the conditions hold; and at the ends the polynomial has both signs,
 * so that it is zero in between. A point from which a line would begin may be a zero itself. */
#include "algebra/search.h"

#include <flint/fmpz_mpoly_factor.h>

enum { STARTS = 4, SCALES = 6, HALVINGS = 160, PRECISION = 512, LONGEST = 256, ENCLOSURES = 24 };

/* 1 or -1, or 0 if the sign is not known. is_zero: NULL, or gets whether the value is known to be zero. */
static int sign_at(ttc_witness *point, const ttc_ratio *value, bool *is_zero)
{
    arb_t ball;
    arb_init(ball);
    ttc_witness_enclose(ball, point, value, PRECISION);
    const int sign = arb_is_positive(ball) ? 1 : arb_is_negative(ball) ? -1 : 0;
    if (is_zero != NULL) *is_zero = arb_is_zero(ball);
    arb_clear(ball);
    return sign;
}

static int sign_with(ttc_witness *point, const ttc_ratio *value, slong variable, const fmpq_t number)
{
    fmpq_set(point->values + variable, number);
    ttc_witness_changed(point);
    return sign_at(point, value, NULL);
}

/* Bisect the interval from the variable's value to `other`, where the sign is opposite, until it is shorter than
 * 2^TTC_WITNESS_WIDTH; then let `wide` cover it, and test the conditions on all of it. */
static bool enclose_zero(ttc_witness *point, const ttc_conditions *conditions, const ttc_ratio *value, slong variable, int sign,
                         const fmpq_t other)
{
    fmpq_t same, opposite, between, width;
    int there = sign;
    fmpq_init(same);
    fmpq_init(opposite);
    fmpq_init(between);
    fmpq_init(width);
    fmpq_set(same, point->values + variable);
    fmpq_set(opposite, other);
    for (int i = 0; there != 0 && i < HALVINGS; i++) {
        fmpq_add(between, same, opposite);
        fmpq_div_2exp(between, between, 1);
        if ((there = sign_with(point, value, variable, between)) == 0) { /* the zero itself, perhaps */
            fmpq_add(between, between, same);
            fmpq_div_2exp(between, between, 1);
            there = sign_with(point, value, variable, between);
        }
        fmpq_set(there == sign ? same : opposite, between);
    }
    fmpq_sub(width, same, opposite);
    fmpq_abs(width, width);
    fmpq_mul_2exp(width, width, -TTC_WITNESS_WIDTH);
    fmpq_set(point->values + variable, same);
    point->wide = variable;
    ttc_witness_changed(point);
    const bool found = there != 0 && fmpq_cmp_si(width, 1) < 0 && ttc_search_meets(point, conditions);
    if (!found) point->wide = -1;
    fmpq_clear(width);
    fmpq_clear(between);
    fmpq_clear(opposite);
    fmpq_clear(same);
    return found;
}

/* Look for the opposite sign at distances 2^-6 to 2^5 on both sides of a point of the domain. */
static bool look_along(ttc_witness *point, const ttc_conditions *conditions, const ttc_ratio *value, slong variable, int sign,
                       int *enclosures)
{
    bool found = false;
    fmpq_t start, other, step;
    fmpq_init(start);
    fmpq_init(other);
    fmpq_init(step);
    fmpq_set(start, point->values + variable);
    for (int k = 0; !found && k < 4 * SCALES && *enclosures > 0; k++) {
        fmpq_one(step);
        if (k / 2 < SCALES) fmpq_div_2exp(step, step, (ulong)(SCALES - k / 2));
        else fmpq_mul_2exp(step, step, (ulong)(k / 2 - SCALES));
        if (k % 2 == 0) fmpq_add(other, start, step);
        else fmpq_sub(other, start, step);
        if (sign_with(point, value, variable, other) != -sign) continue;
        fmpq_set(point->values + variable, start);
        --*enclosures;
        found = enclose_zero(point, conditions, value, variable, sign, other);
    }
    if (!found) sign_with(point, value, variable, start);
    fmpq_clear(step);
    fmpq_clear(other);
    fmpq_clear(start);
    return found;
}

static bool find_zero(ttc_witness *point, const ttc_conditions *conditions, const ttc_ratio *value)
{
    unsigned attempt = 0;
    int enclosures = ENCLOSURES;
    for (int i = 0; i < STARTS && ttc_search_next(point, conditions, &attempt); i++) {
        bool is_zero;
        const int sign = sign_at(point, value, &is_zero);
        if (is_zero) return true;
        for (slong v = 0; sign != 0 && v < (slong)point->ring->variable_count; v++)
            if (ttc_witness_is_free(point, v) && look_along(point, conditions, value, v, sign, &enclosures)) return true;
    }
    return false;
}

bool ttc_search_zero(ttc_witness *point, const ttc_conditions *conditions, const fmpz_mpoly_t polynomial, bool of_squares)
{
    ttc_ring *ring = point->ring;
    ttc_ratio value;
    fmpz_mpoly_factor_t factors;
    bool found = false;
    /* A variable that an angle tells may jump by whole turns as another variable changes. */
    for (slong v = 0; v < (slong)ring->variable_count; v++)
        if (point->angles[v] != 0) return false;
    if (point->has_obscure_angle || fmpz_mpoly_length(polynomial, ring->context) > LONGEST) return false;
    ttc_ratio_init(ring, &value);
    fmpz_mpoly_factor_init(factors, ring->context);
    if (!fmpz_mpoly_factor(factors, polynomial, ring->context)) factors->num = 0;
    for (slong i = 0; !found && i < factors->num; i++) {
        if (of_squares && fmpz_is_odd(factors->exp + i)) continue;
        ttc_ratio_set_polynomial(ring, &value, factors->poly + i);
        found = find_zero(point, conditions, &value);
    }
    fmpz_mpoly_factor_clear(factors, ring->context);
    ttc_ratio_clear(ring, &value);
    return found;
}
