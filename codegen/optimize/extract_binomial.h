/** Two terms of a sum as what they share times what is left of them. */
#ifndef TTC_EXTRACT_BINOMIAL_H
#define TTC_EXTRACT_BINOMIAL_H

#include "optimize/workspace.h"

/** terms a and b = common * (rest_a + rest_b); the scales are split so that pairs of terms that differ by a factor have equal
 *  rests. */
typedef struct {
    ttc_cube common, rest_a, rest_b;
} ttc_binomial;

/* Quotients of scales, each made once. Zeroed before first use, as is a cleared one. */
typedef struct ttc_scale_ratios {
    struct ttc_scale_ratio *items; /* open addressing by the two scales */
    size_t count, capacity;
} ttc_scale_ratios;

void ttc_scale_ratios_clear(ttc_scale_ratios *ratios);

/* The normal form of two terms. False: memory is out, or the graph refused; the workspace is then failed. */
bool ttc_binomial_of(ttc_workspace *workspace, ttc_scale_ratios *ratios, ttc_binomial *out, const ttc_cube *a, const ttc_cube *b);

/* Equal rests have equal keys. */
uint64_t ttc_binomial_key(const ttc_binomial *binomial);
bool ttc_binomial_same(const ttc_binomial *a, const ttc_binomial *b);

#endif
