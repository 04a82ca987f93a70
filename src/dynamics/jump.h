/** Tells where a rate jumps on an orbit, as dry friction does where the velocity changes its sign. States pass there, in steps as
 *  short as the tolerance asks; but tangent vectors jump too, by what the Jacobian does not have. */
#ifndef JLT_DYNAMICS_JUMP_H
#define JLT_DYNAMICS_JUMP_H

#include "dynamics/varied.h"
#include "integrate/stepper.h"

/** Whether a rate has jumped within the last step of an orbit of the varied field: it has changed by far more than the Jacobian
 *  tells at the step's ends. Cost: two evaluations of field and Jacobian, only after a step that is short for its motion. */
bool jlt_jump_is_behind(const jlt_stepper *stepper, const jlt_varied *varied);

#endif
