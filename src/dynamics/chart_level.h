/** A plane section restricted to levels of a table's integrals.
 *
 *  Newton's method, always from the same guess, solves for as many states as there are levels; the section's coordinates
 *  are the other states, in order. On the section and its levels the solved states y are functions of the coordinates, with
 *  the derivative -(dF/dy)^-1 dF/dq. The chart covers one branch of them, which ends where dF/dy is singular;
 *  jlt_chart_follows recognizes a return on another branch. */
#ifndef JLT_DYNAMICS_CHART_LEVEL_H
#define JLT_DYNAMICS_CHART_LEVEL_H

#include "dynamics/chart.h"

enum { JLT_CHART_INTEGRALS_MAX = 64 };

/** One level: the value of one of the table's integrals, which determines a state, and a guess of that. */
typedef struct {
    unsigned integral, state;
    double value, guess;
} jlt_level;

typedef struct {
    jlt_chart base; /* solved[i] is the state of levels[i]; the lifted roots follow, beyond solved_count */
    const jlt_descriptor *descriptor; /* of the field, used where it has lifted roots, */
    const double *params;             /* as its parameters are, in the table's order */
    jlt_invariants integrals; /* all of the table's, at most JLT_CHART_INTEGRALS_MAX; then relations of lifted roots */
    jlt_level levels[JLT_INVARIANTS_MAX];
    unsigned free[JLT_CHART_DIM_MAX]; /* the state of each coordinate */
    double turns[JLT_INVARIANTS_MAX]; /* of each solved state, its period; 0: none, as it is unless set */
} jlt_chart_level;

/** Make the chart from a plane section, whose angles are declared before, and levels, shape (count,). What `integrals`, the
 *  kernels of all integrals, points to must live as long. On a plane with lifted roots, the field of `descriptor` computes these
 *  with params, in the table's order, and `integrals` ends with their relations (integrate/conserved.h): each relation is one more
 *  level, of value 0, and its root one more unknown, for which Newton's method starts from the root at the guess. The chart has
 *  the plane's reversor if that changes the sign of no solved state. Its lift returns EMPTY where Newton's method finds no state,
 *  DOMAIN outside bounds and conditions, and NONFINITE.
 *  Errors: ARG, no levels and no roots, too many of them, one integral or state twice, or the section's own state. */
JLT_CHECKED jlt_status jlt_chart_level_init(jlt_chart_level *out, const jlt_chart *plane, const jlt_invariants *integrals,
                                            const jlt_level *levels, unsigned count, const jlt_descriptor *descriptor,
                                            const double *params);

/** Whether at x, an array of all states, the levels determine the unknowns to first order: their gradients by the unknowns are
 *  independent. Sets *known to true, unless one of these gradients is not finite: then *known stays as it is. */
bool jlt_chart_level_determines(const jlt_chart_level *self, bool *known, const double *x);

#endif
