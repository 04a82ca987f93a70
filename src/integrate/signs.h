/** What a field's rates say of signs: states that never change theirs, and pairs of states that are 0 only together.
 *
 *  Where a state's rate is 0 whenever the state is, as in I' = (b S - g) I, it comes to 0 on no orbit. Where this holds of two states
 *  together, as of x' = a x - y and y' = a y + x, they turn about 0, and only both of them together may be small. However small
 *  such states are, they may grow again, so that errors have to be small beside them. */
#ifndef JLT_INTEGRATE_SIGNS_H
#define JLT_INTEGRATE_SIGNS_H

#include "integrate/field.h"

/** Find field->kept and field->pairs, judging by rates at eight places in the intervals of its states. A field without intervals
 *  has none of either. A pair is of two states that are not kept, of three or more; a state is in one pair at most. Cost: some
 *  dim^2/2 evaluations of the field. */
void jlt_signs_find(jlt_field *field);

#endif
