/** A passage on which tangent vectors grow far beyond what is left of them at its end, as close to a singularity: what keeps their
 *  digits there.
 *
 *  - A tangent vector grows with the field along it, a part that the return map's projection along the field removes. It is taken
 *    out on the way.
 *  - States count as small by sizes in which the field's Jacobian is balanced: near a singularity at a distance r these are as r
 *    and as the speed there, while a state itself may be as large as anywhere. A tangent vector's components count by the same
 *    sizes, relative to its largest. */
#ifndef JLT_DYNAMICS_PASSAGE_H
#define JLT_DYNAMICS_PASSAGE_H

#include "dynamics/varied.h"
#include "integrate/orbit.h"

/** After a step, change an orbit of a varied field so. Errors: NONFINITE, NOMEM. Cost: an evaluation of the field and its Jacobian,
 *  and the next step begins anew. */
JLT_CHECKED jlt_status jlt_passage_keep(jlt_orbit *orbit, const jlt_varied *varied);

#endif
