/** How orbits of a section end, counted: all of them, and those that begin low, of sections whose tables say which those are. */
#ifndef JLT_DYNAMICS_SHARES_H
#define JLT_DYNAMICS_SHARES_H

#include "dynamics/fates.h"
#include "dynamics/surface.h"

/* Zeroed is empty. */
typedef struct {
    jlt_fates_count all, low;
    jlt_fate turned; /* what has become of low ones that turned over */
    size_t empty;    /* points of a grid without a state */
} jlt_shares;

/** Whether the section says which orbits turn over. */
bool jlt_shares_turn(const jlt_system *system);

void jlt_shares_add(jlt_shares *sum, const jlt_system *system, const double *q, const jlt_fates_end *end);

/** Those that the method failed on. */
size_t jlt_shares_failed(const jlt_shares *sum);

/** Those on which the model's conditions held throughout. */
size_t jlt_shares_held(const jlt_shares *sum);

#endif
