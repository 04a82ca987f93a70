/** Counts of the orbits of a section on which a method failed, and of those among them in which a state grows without bound. */
#ifndef JLT_DYNAMICS_FAILURES_H
#define JLT_DYNAMICS_FAILURES_H

#include "dynamics/section.h"

/* Zeroed is none. */
typedef struct {
    size_t count, unbounded;
    unsigned state; /* that grows in the first of the unbounded, */
    double t;       /* [time] and towards which time */
} jlt_failures;

/** Count the orbit that ended so, if the method failed on it. unbounded: as of jlt_return. */
void jlt_failures_add(jlt_failures *sum, jlt_fate fate, unsigned unbounded, double t);

/* Count all of `more` too. */
void jlt_failures_join(jlt_failures *sum, const jlt_failures *more);

#endif
