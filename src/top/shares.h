/** How orbits of a section end, counted: all of them, and those that begin low, of sections that know such. */
#ifndef JLT_TOP_SHARES_H
#define JLT_TOP_SHARES_H

#include "dynamics/fates.h"
#include "top/known.h"

/* Zeroed is empty. */
typedef struct {
    jlt_fates_count all, low;
    jlt_fate turned; /* what has become of low ones that turned over */
    size_t empty;    /* points of a grid without a state */
} jlt_shares;

void jlt_shares_add(jlt_shares *sum, const jlt_system *system, const double *q, const jlt_fates_end *end);

/** Those that the method failed on. */
size_t jlt_shares_failed(const jlt_shares *sum);

/** Those on which the model's conditions held throughout. */
size_t jlt_shares_held(const jlt_shares *sum);

#endif
