/** What moves on the levels of a leaf while parameters rest. */
#ifndef TTC_MOVEMENT_H
#define TTC_MOVEMENT_H

#include "prove/prove_task.h"

/** Flags the variables of the ring that move with the states while these expressions rest: those given for the target's
 *  parameters, and those of bound parameters, levels and angles. A variable that such an expression uses, directly or in
 *  definitions, may move as well, but is not flagged. Returns flags, shape (variable_count,), for free(); NULL if memory is out. */
bool *ttc_movement_flags(ttc_task *task, const ttc_model *target);

/** Returns true if, for all that is known, there are parameters for which what moves cannot leave a point of the leaf in all
 *  directions together: x^2 + y^2 = a is a point for a = 0. Where no square is zero, or only one that has a derivative, it can. */
bool ttc_movement_may_be_thin(ttc_task *task, const bool *moves);

#endif
