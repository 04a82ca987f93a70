/** Pseudo-random bits from a seed, the same on every machine. Not for secrets.
 *  Source: G. Steele, D. Lea, C. Flood, Fast splittable pseudorandom number generators, OOPSLA 2014 (splitmix64). */
#ifndef TTC_RANDOM_H
#define TTC_RANDOM_H

#include <stdint.h>

#define TTC_RANDOM_STEP UINT64_C(0x9e3779b97f4a7c15)

/* A hash of 64 bits, invertible: the generator's finalizer. */
static inline uint64_t ttc_random_mixed(uint64_t z)
{
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* The next 64 bits; *state is the seed at first. */
static inline uint64_t ttc_random_bits(uint64_t *state)
{
    return ttc_random_mixed(*state += TTC_RANDOM_STEP);
}

#endif
