#include "core/random.h"

#include <math.h>

static uint64_t rotate_left(uint64_t word, int by)
{
    return (word << by) | (word >> (64 - by));
}

void jlt_random_seed(jlt_random *random, uint64_t seed)
{
    for (int i = 0; i < 4; i++) {
        uint64_t word = (seed += 0x9e3779b97f4a7c15u);
        word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
        word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
        random->word[i] = word ^ (word >> 31);
    }
}

uint64_t jlt_random_bits(jlt_random *random)
{
    uint64_t *word = random->word;
    const uint64_t bits = rotate_left(word[0] + word[3], 23) + word[0];
    const uint64_t shifted = word[1] << 17;

    word[2] ^= word[0];
    word[3] ^= word[1];
    word[1] ^= word[2];
    word[0] ^= word[3];
    word[2] ^= shifted;
    word[3] = rotate_left(word[3], 45);
    return bits;
}

uint64_t jlt_random_below(jlt_random *random, uint64_t count)
{
    /* The smallest 2^64 mod count values of `bits` would favour small results. */
    const uint64_t rejected = (0 - count) % count;
    uint64_t bits;

    do bits = jlt_random_bits(random);
    while (bits < rejected);
    return bits % count;
}

double jlt_random_unit(jlt_random *random)
{
    return ((double)(jlt_random_bits(random) >> 12) + 0.5) * 0x1p-52;
}

double jlt_random_between(jlt_random *random, double low, double high)
{
    const double unit = jlt_random_unit(random);
    return low * (1.0 - unit) + high * unit;
}

double jlt_random_magnitude(jlt_random *random, double low, double high)
{
    /* C libraries may differ in the last bit of exp10(). So 2^x with x = whole + fraction is replaced by 2^whole (1 + fraction),
     * which is the same everywhere and exceeds 2^x by up to 6.2 %. */
    const double exponent = jlt_random_between(random, low, high) * 3.321928094887362;
    const double whole = floor(exponent);
    return ldexp(1.0 + (exponent - whole), (int)whole);
}
