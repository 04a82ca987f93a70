/** The sum of two terms, factored: a common part times a sum of two rests. */
#ifndef TTC_EXTRACT_BINOMIAL_H
#define TTC_EXTRACT_BINOMIAL_H

#include "optimize/workspace.h"

/** Two terms whose sum is common * (rest_a + rest_b). Scales are split, and rests ordered, so that pairs of terms that differ by a
 *  common factor have equal rests. */
typedef struct {
    ttc_cube common, rest_a, rest_b;
} ttc_binomial;

/* A cache of quotients of scales. Zeroed before first use, and after clearing. */
typedef struct ttc_scale_ratios {
    struct ttc_scale_ratio *items; /* open addressing by the two scales */
    size_t count, capacity;
} ttc_scale_ratios;

void ttc_scale_ratios_clear(ttc_scale_ratios *ratios);

/* Factor a + b. Returns false, and the workspace fails, when memory is out or the graph is at its limits. */
bool ttc_binomial_of(ttc_workspace *workspace, ttc_scale_ratios *ratios, ttc_binomial *out, const ttc_cube *a, const ttc_cube *b);

/* A hash of the rests; and whether two binomials have equal rests. */
uint64_t ttc_binomial_key(const ttc_binomial *binomial);
bool ttc_binomial_same(const ttc_binomial *a, const ttc_binomial *b);

#endif
