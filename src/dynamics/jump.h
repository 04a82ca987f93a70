/** Detects jumps of a rate on an orbit, as by dry friction where the velocity changes its sign. States are integrated across a
 *  jump, in steps as short as the tolerance asks; but tangent vectors jump there too, which the Jacobian does not show. */
#ifndef JLT_DYNAMICS_JUMP_H
#define JLT_DYNAMICS_JUMP_H

#include "dynamics/varied.h"
#include "integrate/stepper.h"

/** What detection keeps of the orbit's earlier steps. Zeroed at first. */
typedef struct {
    size_t rejected; /* of the stepper, as it was at the last step */
    double length;   /* of that step; 0: there is none */
    unsigned calm;   /* steps since one became less than half as long, after it was rejected */
} jlt_jump_watch;

/** Whether a rate has jumped within the last step of an orbit of the varied field: it has changed by far more than the Jacobian
 *  predicts, also within a small part of the step. Called after every step. Cost: two evaluations of field and Jacobian, and up to
 *  four more for each rate that changed so, only after a step that is short for its motion, or soon after steps became much
 *  shorter, as they do at a jump. */
bool jlt_jump_is_behind(jlt_jump_watch *self, const jlt_stepper *stepper, const jlt_varied *varied);

#endif
