#include "fields/extent.h"

#include <math.h>

#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif

const ttc_extent ttc_extent_any = { TTC_SIGN_ANY, -INFINITY, INFINITY };

/* Tighten signs by bounds, and bounds by signs. */
static ttc_extent settle(ttc_extent a)
{
    unsigned signs = a.signs;
    if (a.low >= 0) signs &= ~(unsigned)TTC_SIGN_NEGATIVE;
    if (a.high <= 0) signs &= ~(unsigned)TTC_SIGN_POSITIVE;
    if (a.low > 0 || a.high < 0) signs &= ~(unsigned)TTC_SIGN_ZERO;
    if (signs == 0) return ttc_extent_any; /* an empty domain: nothing is claimed */
    if ((signs & TTC_SIGN_NEGATIVE) == 0 && a.low < 0) a.low = 0;
    if ((signs & TTC_SIGN_POSITIVE) == 0 && a.high > 0) a.high = 0;
    a.signs = (unsigned char)signs;
    return a;
}

ttc_extent ttc_extent_of_number(const fmpq_t value)
{
    ttc_extent result = { fmpq_sgn(value) < 0 ? TTC_SIGN_NEGATIVE : fmpq_sgn(value) > 0 ? TTC_SIGN_POSITIVE : TTC_SIGN_ZERO, 0, 0 };
    arb_t ball;
    arf_t bound;
    arb_init(ball);
    arf_init(bound);
    arb_set_fmpq(ball, value, 128);
    arb_get_lbound_arf(bound, ball, 128);
    result.low = arf_get_d(bound, ARF_RND_FLOOR);
    arb_get_ubound_arf(bound, ball, 128);
    result.high = arf_get_d(bound, ARF_RND_CEIL);
    arf_clear(bound);
    arb_clear(ball);
    return settle(result);
}

ttc_extent ttc_extent_of_signs(unsigned char signs)
{
    ttc_extent result = ttc_extent_any;
    result.signs = signs;
    return settle(result);
}

ttc_extent ttc_extent_negate(ttc_extent a)
{
    unsigned signs = a.signs & TTC_SIGN_ZERO;
    if ((a.signs & TTC_SIGN_NEGATIVE) != 0) signs |= TTC_SIGN_POSITIVE;
    if ((a.signs & TTC_SIGN_POSITIVE) != 0) signs |= TTC_SIGN_NEGATIVE;
    return (ttc_extent){ (unsigned char)signs, -a.high, -a.low };
}

/* A bound on the exact sum: the rounded sum moved outwards by one ulp, unless it is exact (Knuth's two-sum). */
static double add_bound(double a, double b, double outwards)
{
    if (isinf(a) || isinf(b)) return outwards;
    double sum = a + b, of_b = sum - a, error = (a - (sum - of_b)) + (b - of_b);
    return error == 0 ? sum : nextafter(sum, outwards);
}

ttc_extent ttc_extent_add(ttc_extent a, ttc_extent b)
{
    ttc_extent result = { 0, add_bound(a.low, b.low, -INFINITY), add_bound(a.high, b.high, INFINITY) };
    unsigned signs = (a.signs | b.signs) & (TTC_SIGN_NEGATIVE | TTC_SIGN_POSITIVE);
    if ((a.signs & b.signs & TTC_SIGN_ZERO) != 0 || signs == (TTC_SIGN_NEGATIVE | TTC_SIGN_POSITIVE)) signs |= TTC_SIGN_ZERO;
    result.signs = (unsigned char)signs;
    return settle(result);
}

/* A bound on the least (outwards = -infinity) or greatest product of an end of a and an end of b; zero times infinity is zero. */
static double multiply_bound(ttc_extent a, ttc_extent b, double outwards)
{
    const double left[] = { a.low, a.high }, right[] = { b.low, b.high };
    double best = -outwards;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            double product = left[i] == 0 || right[j] == 0 ? 0 : left[i] * right[j];
            bool is_exact = left[i] == 0 || right[j] == 0 || isinf(left[i]) || isinf(right[j])
                            || (fabs(product) > 0x1p-900 && !isinf(product) && fma(left[i], right[j], -product) == 0);
            if (!is_exact) product = nextafter(product, outwards);
            best = outwards > 0 ? fmax(best, product) : fmin(best, product);
        }
    return best;
}

ttc_extent ttc_extent_multiply(ttc_extent a, ttc_extent b)
{
    ttc_extent result = { 0, multiply_bound(a, b, -INFINITY), multiply_bound(a, b, INFINITY) };
    unsigned signs = (a.signs | b.signs) & TTC_SIGN_ZERO;
    for (unsigned s = TTC_SIGN_NEGATIVE; s <= TTC_SIGN_POSITIVE; s += 3)
        for (unsigned t = TTC_SIGN_NEGATIVE; t <= TTC_SIGN_POSITIVE; t += 3)
            if ((a.signs & s) != 0 && (b.signs & t) != 0) signs |= s == t ? TTC_SIGN_POSITIVE : TTC_SIGN_NEGATIVE;
    result.signs = (unsigned char)signs;
    return settle(result);
}

static ttc_extent square(ttc_extent a)
{
    double size = fmax(fabs(a.low), fabs(a.high)), least = a.low > 0 ? a.low : a.high < 0 ? -a.high : 0;
    ttc_extent ends = { TTC_SIGN_ANY, least, size }, result = ttc_extent_multiply(ends, ends);
    result.signs = (a.signs & TTC_SIGN_ZERO) | ((a.signs & ~(unsigned)TTC_SIGN_ZERO) != 0 ? TTC_SIGN_POSITIVE : 0);
    return settle(result);
}

/* 1/a, by signs alone: bounds are dropped. */
static ttc_extent invert(ttc_extent a)
{
    unsigned signs = a.signs & ~(unsigned)TTC_SIGN_ZERO;
    return ttc_extent_of_signs(signs == 0 ? TTC_SIGN_ANY : (unsigned char)signs);
}

ttc_extent ttc_extent_power(ttc_extent a, long exponent)
{
    if (exponent < 0) return ttc_extent_power(invert(a), -exponent);
    ttc_extent result = { TTC_SIGN_POSITIVE, 1, 1 }, even = square(a);
    for (long k = 0; k < exponent / 2; k++) result = ttc_extent_multiply(result, even);
    return exponent % 2 == 1 ? ttc_extent_multiply(result, a) : result;
}

ttc_extent ttc_extent_root(ttc_extent radicand)
{
    unsigned signs = radicand.signs & ~(unsigned)TTC_SIGN_NEGATIVE;
    ttc_extent result = { signs == 0 ? TTC_SIGN_ANY : (unsigned char)signs, 0, INFINITY };
    if (radicand.low > 0) result.low = nextafter(sqrt(radicand.low), 0);
    if (radicand.high < INFINITY && radicand.high > 0) result.high = nextafter(sqrt(radicand.high), INFINITY);
    return settle(result);
}

ttc_extent ttc_extent_meet(ttc_extent a, ttc_extent b)
{
    unsigned signs = a.signs & b.signs;
    if (signs == 0) return a;
    return settle((ttc_extent){ (unsigned char)signs, fmax(a.low, b.low), fmin(a.high, b.high) });
}

bool ttc_extent_is_nonnegative(ttc_extent a) { return (a.signs & TTC_SIGN_NEGATIVE) == 0; }

bool ttc_extent_is_nonpositive(ttc_extent a) { return (a.signs & TTC_SIGN_POSITIVE) == 0; }

bool ttc_extent_is_positive(ttc_extent a) { return a.signs == TTC_SIGN_POSITIVE; }
