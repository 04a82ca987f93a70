/** What a field's rates say of signs: which states never change theirs, and which states are 0 only together.
 *
 *  Where a state's rate is 0 whenever the state is, as in I' = (b S - g) I, no orbit takes the state to 0. Where several states
 *  have this together, as in x' = a x - y and y' = a y + x, only all of them together may be small. However small such states are,
 *  they may grow again, so that their errors must be small relative to them. */
#ifndef JLT_INTEGRATE_SIGNS_H
#define JLT_INTEGRATE_SIGNS_H

#include "integrate/field.h"

/** Find field->kept and field->groups, judging by rates at 32 places in the intervals of states, shape (dim,). A group is a least
 *  one that has one of its states that are not kept, of two states or more, but not of all; the root is in none. Of a rigid body,
 *  p' = q r, q' = -2 p r and r' = p q, any two are a group; of I' = - I and R' = I + R, I is kept, and both are a group where there
 *  are other states. Not all groups are found where they are more than JLT_STATE_GROUPS_MAX, or where products drive many states.
 *  Cost: some 100 dim evaluations of the field, mostly few, and dim^3/8; 1600 dim where products drive many states. */
void jlt_signs_find(jlt_field *field, const jlt_quantity *states);

#endif
