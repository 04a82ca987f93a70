/** Which variables may change on the levels of a leaf while parameters stay constant. */
#ifndef TTC_MOVEMENT_H
#define TTC_MOVEMENT_H

#include "prove/prove_task.h"

/** Flags the variables of the ring that change with the states while these expressions stay constant: those given for the target's
 *  parameters, and those of bound parameters, levels and angles. A variable that such an expression uses, directly or in
 *  definitions, may change as well, but is not flagged. Returns flags, shape (variable_count,), for free(); NULL if memory is out.
 *  */
bool *ttc_movement_flags(ttc_task *task, const ttc_model *target);

/** Returns true unless it is excluded that for some parameters the leaf is of lower dimension in the flagged variables near one of
 *  its points: x^2 + y^2 = a is a point for a = 0. It is excluded where of the squares whose roots solved the levels none is zero,
 *  or a single one whose derivatives by these variables are not all zero. */
bool ttc_movement_may_be_thin(ttc_task *task, const bool *moves);

#endif
