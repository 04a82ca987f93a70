/** Where a test function of a branch of periodic orbits is zero, between two of its places. */
#ifndef JLT_DYNAMICS_CONTINUATION_LOCATE_H
#define JLT_DYNAMICS_CONTINUATION_LOCATE_H

#include "dynamics/continuation_step.h"

#define JLT_CONTINUATION_TURN 0.3 /* most radians by which the tangent turns in a step */

bool jlt_continuation_locate_interrupted(const jlt_continuation_runner *self);

/** A bifurcation between two places of the branch, located so far. Keep it off the stack: its places have room for the largest
 *  sections, a megabyte in all. */
typedef struct {
    jlt_continuation_place at, before, after; /* the place itself, and those on both sides */
    jlt_continuation_place trial;             /* private */
    bool joined; /* steps did not converge at the place, but it is an orbit, up to noise, on the line between the sides */
} jlt_continuation_bracket;

/** Locate the zero of test k between two places, to which steps from `from` lead. Where steps do not converge, or leave the branch,
 *  as may happen at a branch point, the bracket stays as wide as it is, and the place is the secant's zero if an orbit is there. */
void jlt_continuation_locate(jlt_continuation_bracket *out, const jlt_continuation_runner *self, const jlt_continuation_place *from,
                             const jlt_continuation_place *before, const jlt_continuation_place *after, unsigned k);

#endif
