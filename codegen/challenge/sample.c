#include "challenge/sample.h"

#include "base/random.h"

enum { FAR = 40 };

uint64_t ttc_random_below(ttc_random *random, uint64_t bound) { return ttc_random_bits(&random->state) % bound; }

/* p/q with 1 <= p, q <= size */
static void fraction(fmpq_t out, ttc_random *random, uint64_t size)
{
    fmpq_set_si(out, (slong)(1 + ttc_random_below(random, size)), 1 + ttc_random_below(random, size));
}

static void scale_by_power_of_two(fmpq_t value, long exponent)
{
    if (exponent >= 0) fmpq_mul_2exp(value, value, (flint_bitcnt_t)exponent);
    else fmpq_div_2exp(value, value, (flint_bitcnt_t)-exponent);
}

void ttc_sample_positive(fmpq_t out, ttc_random *random, ttc_sample_range range)
{
    if (range == TTC_SAMPLE_SPECIAL) {
        fmpq_one(out);
        scale_by_power_of_two(out, (long)ttc_random_below(random, 3) - 1);
        return;
    }
    switch (ttc_random_below(random, range == TTC_SAMPLE_MODERATE ? 4 : 8)) {
    case 0: fmpq_set_si(out, (slong)(1 + ttc_random_below(random, 4)), 1); break;
    case 1:
    case 2: fraction(out, random, 9); break;
    case 3: fraction(out, random, 1000); break;
    case 4:
    case 5: fraction(out, random, 1000000); break;
    default:
        fraction(out, random, 1000);
        scale_by_power_of_two(out, (long)ttc_random_below(random, 2 * FAR + 1) - FAR);
    }
}

void ttc_sample_any(fmpq_t out, ttc_random *random, ttc_sample_range range)
{
    uint64_t chance = ttc_random_below(random, 16);
    ttc_sample_positive(out, random, range);
    if (chance == 0 || (range == TTC_SAMPLE_SPECIAL && chance < 9)) fmpq_zero(out);
    else if (chance % 2 == 0) fmpq_neg(out, out);
}

void ttc_sample_unit(fmpq_t out, ttc_random *random, ttc_sample_range range)
{
    uint64_t kind = range == TTC_SAMPLE_WIDE ? ttc_random_below(random, 4) : 0;
    uint64_t denominator = range == TTC_SAMPLE_SPECIAL ? 4 : 2 + ttc_random_below(random, kind == 0 ? 12 : 1000000);
    fmpq_set_si(out, (slong)(1 + ttc_random_below(random, denominator - 1)), denominator);
    if (kind < 2) return;
    scale_by_power_of_two(out, -(long)ttc_random_below(random, FAR));
    if (kind == 3) {
        fmpq_sub_si(out, out, 1);
        fmpq_neg(out, out);
    }
}
