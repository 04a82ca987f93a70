/** Counts the periodic orbits on which a condition of the model breaks, and watches how well their derivative DP is known. */
#ifndef JLT_CLI_ORBIT_LOSSES_H
#define JLT_CLI_ORBIT_LOSSES_H

#include "dynamics/periodic.h"

/** Plain data; zeroed, it has counted nothing. */
typedef struct {
    size_t orbits, all, lost[JLT_OBSERVED_CONDITIONS_MAX]; /* orbits; those that lose a condition, and by condition */
    size_t unknown;                                        /* those on which none breaks, but one has no value somewhere */
    double first;                                          /* the value at the first of these */
    double defect, blurred_at; /* worst defect of det DP, if too large to know types of orbits; the value at the first */
} jlt_orbit_losses;

/** Count an orbit of this flow; value: what varies; NaN: nothing does. Cost: the orbit, once more. */
void jlt_orbit_losses_add(jlt_orbit_losses *self, const jlt_flow *flow, const jlt_periodic *orbit, double value);

/** Say on stderr which conditions break, if any do. where: the beginning of the line; observed: that of the flows. */
void jlt_orbit_losses_tell(const jlt_orbit_losses *self, const jlt_observed *observed, const char *where);

#endif
