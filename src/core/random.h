/** Pseudo-random numbers with a seed: the same seed gives the same numbers on every machine.
 *
 *  Generator: xoshiro256++, period 2^256 - 1, seeded through splitmix64. Not for secrets.
 *  Source: D. Blackman, S. Vigna, Scrambled linear pseudorandom number generators, ACM TOMS 47(4), 2021. */
#ifndef JLT_CORE_RANDOM_H
#define JLT_CORE_RANDOM_H

#include <stdint.h>

typedef struct {
    uint64_t word[4];
} jlt_random;

/* Start the sequence of this seed; call it before anything else. */
void jlt_random_seed(jlt_random *random, uint64_t seed);

/* 64 random bits. */
uint64_t jlt_random_bits(jlt_random *random);

/* A whole number, each of [0, count) with the same probability; count > 0. */
uint64_t jlt_random_below(jlt_random *random, uint64_t count);

/* Uniform in the open interval (0, 1), with 53 bits. */
double jlt_random_unit(jlt_random *random);

/* Uniform between low and high, both finite, in either order; rounding may give an end itself. */
double jlt_random_between(jlt_random *random, double low, double high);

/* A positive number between 10^low and 1.062 * 10^high whose logarithm is roughly uniform: between two powers of two the number
 * itself is uniform, so the density of its logarithm is off by up to 39 %. It needs no exp(): all machines agree. */
double jlt_random_magnitude(jlt_random *random, double low, double high);

#endif
