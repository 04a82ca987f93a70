/** What a field's rates say of signs: which states never change theirs, and which pairs of states are 0 only together.
 *
 *  Where a state's rate is 0 whenever the state is, as in I' = (b S - g) I, no orbit takes the state to 0. Where two states have
 *  this together, as in x' = a x - y and y' = a y + x, they turn about 0, and only both together may be small. However small such
 *  states are, they may grow again, so that their errors must be small beside them. */
#ifndef JLT_INTEGRATE_SIGNS_H
#define JLT_INTEGRATE_SIGNS_H

#include "integrate/field.h"

/** Find field->kept and field->pairs, judging by rates at 32 places in the intervals of states, shape (dim,). The root is none
 *  of them. A pair is of two states that are not kept, of three or more; a state is in one pair at most. Cost: some dim^2/2
 *  evaluations of the field. */
void jlt_signs_find(jlt_field *field, const jlt_quantity *states);

#endif
