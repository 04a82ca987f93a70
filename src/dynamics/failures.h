/** Counts of the orbits of a section on which a method failed, and of those among them in which a state grows without bound. */
#ifndef JLT_DYNAMICS_FAILURES_H
#define JLT_DYNAMICS_FAILURES_H

#include "dynamics/section.h"

/* All zero: no failures. */
typedef struct {
    size_t count,   /* orbits on which a method failed */
        unbounded;  /* of these, orbits on which a state grows without bound */
    unsigned state; /* state that grew in the first unbounded orbit */
    double t;       /* [time] it grew towards */
} jlt_failures;

/** Count an orbit if its fate is a failure of the method. unbounded: as in jlt_return. */
void jlt_failures_add(jlt_failures *sum, jlt_fate fate, unsigned unbounded, double t);

/* Count all of `more` too. */
void jlt_failures_join(jlt_failures *sum, const jlt_failures *more);

#endif
