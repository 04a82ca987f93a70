/** Random rational numbers of widely varying size, from a seeded generator (base/random.h): the same on every machine. */
#ifndef TTC_SAMPLE_H
#define TTC_SAMPLE_H

#include <stdint.h>

#include <flint/fmpq.h>

typedef struct {
    uint64_t state;
} ttc_random;

uint64_t ttc_random_below(ttc_random *random, uint64_t bound); /* bound > 0 */

/* How far numbers may lie from 1. Moderate numbers are for domains in which wide ones hardly ever lie. Special ones are 1/2, 1 and
 * 2, or zero where that is allowed, which is drawn 9 times in 16. */
typedef enum { TTC_SAMPLE_WIDE, TTC_SAMPLE_MODERATE, TTC_SAMPLE_SPECIAL } ttc_sample_range;

/* Positive. Wide ones reach beyond 2^-40 and 2^40; half of them are small fractions. */
void ttc_sample_positive(fmpq_t out, ttc_random *random, ttc_sample_range range);

/* A number of either sign, or zero: one time in 16, of special ones 9 times in 16. */
void ttc_sample_any(fmpq_t out, ttc_random *random, ttc_sample_range range);

/* Strictly between 0 and 1; wide ones come nearer than 2^-40 to either end, special ones are quarters. */
void ttc_sample_unit(fmpq_t out, ttc_random *random, ttc_sample_range range);

#endif
