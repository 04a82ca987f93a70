/** Counts of the orbits of a section on which a method failed, of those among them in which a state grows without bound,
 *  and of those that spent their steps or time on one return. */
#ifndef JLT_DYNAMICS_FAILURES_H
#define JLT_DYNAMICS_FAILURES_H

#include "dynamics/section.h"

/* All zero: no failures. */
typedef struct {
    size_t count,   /* orbits on which a method failed */
        unbounded,  /* of these, orbits on which a state grows without bound */
        spent;      /* orbits that ended as JLT_FATE_BUDGET, which is not a failure */
    unsigned state; /* state that grew in the first unbounded orbit */
    double t;       /* [time] it grew towards */
} jlt_failures;

/** Count an orbit by its fate. unbounded: as in jlt_return. */
void jlt_failures_add(jlt_failures *sum, jlt_fate fate, unsigned unbounded, double t);

/* Count all of `more` too. */
void jlt_failures_join(jlt_failures *sum, const jlt_failures *more);

#endif
