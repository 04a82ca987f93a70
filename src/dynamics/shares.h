/** Counts of how orbits of a section end. A section's table may say which starts are low and which ends are turned over (its clause
 *  `turns`); orbits that begin low are then counted separately too. */
#ifndef JLT_DYNAMICS_SHARES_H
#define JLT_DYNAMICS_SHARES_H

#include "dynamics/fates.h"
#include "dynamics/surface.h"

/* All zero: empty. */
typedef struct {
    jlt_fates_count all, low, turned; /* all orbits; those that begin low; of these, those that turn over */
    size_t empty;                     /* points of a grid without a state */
} jlt_shares;

/** Whether the section's table says which orbits turn over. */
bool jlt_shares_turn(const jlt_system *system);

/** Count an orbit that started at q, shape (dim,), by its end. */
void jlt_shares_add(jlt_shares *sum, const jlt_system *system, const double *q, const jlt_fates_end *end);

#endif
