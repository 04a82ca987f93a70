/** Keeps the digits of tangent vectors along a passage on which they grow far above their size at its end, such as one close to a
 *  singularity.
 *
 *  - The part of a tangent vector along the field grows with the field's length. The return map's projection along the field
 *    removes that part in the end; here it is removed after every step.
 *  - The error of a step counts relative to sizes of the states in which the field's Jacobian is balanced. At a distance r from a
 *    singularity some of these sizes are as small as r, others as large as the speed there, whatever the states themselves are. The
 *    components of a tangent vector count relative to the same sizes, times the vector's largest component in them. */
#ifndef JLT_DYNAMICS_PASSAGE_H
#define JLT_DYNAMICS_PASSAGE_H

#include "dynamics/varied.h"
#include "integrate/orbit.h"

/** Do both after a step of an orbit of the varied field. Errors: NONFINITE, NOMEM. Cost: an evaluation of the field and its
 *  Jacobian, and the next step begins anew. */
JLT_CHECKED jlt_status jlt_passage_keep(jlt_orbit *orbit, const jlt_varied *varied);

#endif
