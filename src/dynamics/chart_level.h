/** A plane section restricted to levels of a table's integrals.
 *
 *  As many states as there are levels are solved for by Newton's method, always from one guess; the section's coordinates
 *  are the other states, in order. On the section and its levels the solved states are functions of the coordinates, with
 *  the derivative -(dF/dy)^-1 dF/dq, y the solved states: a branch of them, which ends where that matrix is singular. A
 *  return on another branch is told apart by jlt_chart_follows. */
#ifndef JLT_DYNAMICS_CHART_LEVEL_H
#define JLT_DYNAMICS_CHART_LEVEL_H

#include "dynamics/chart.h"

enum { JLT_CHART_INTEGRALS_MAX = 64 };

/** One level: which of the table's integrals has which value, and which state it determines, from which guess. */
typedef struct {
    unsigned integral, state;
    double value, guess;
} jlt_level;

typedef struct {
    jlt_chart base; /* solved[i] is the state of levels[i], and after them are the roots */
    const jlt_descriptor *descriptor; /* of the field, */
    const double *params;             /* and its parameters, where it has lifted roots */
    jlt_invariants integrals; /* all of the table's, at most JLT_CHART_INTEGRALS_MAX; then relations of lifted roots */
    jlt_level levels[JLT_INVARIANTS_MAX];
    unsigned free[JLT_CHART_DIM_MAX]; /* the state of each coordinate */
} jlt_chart_level;

/** Make the chart from a plane section, with its angles if they are set before, and levels, shape (count,). The kernels
 *  `integrals` of all integrals are kept by reference. Where the plane has lifted roots, the field of `descriptor` lifts them, with
 *  params, in the table's order, and `integrals` has their relations last (integrate/conserved.h): each is the level 0 of its
 *  relation, and its root is solved for with the others, from what it is at the guess. The chart has the plane's reversor when
 *  that changes the sign of no solved state. Its lift returns EMPTY where Newton's method finds no state, DOMAIN outside bounds and
 *  conditions, and NONFINITE.
 *  Errors: ARG, no levels and no roots, too many of them, one integral or state twice, or the section's own state. */
JLT_CHECKED jlt_status jlt_chart_level_init(jlt_chart_level *out, const jlt_chart *plane, const jlt_invariants *integrals,
                                            const jlt_level *levels, unsigned count, const jlt_descriptor *descriptor,
                                            const double *params);

#endif
