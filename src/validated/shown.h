/** Writes what was proved for certificates: balls {"middle": DECIMAL, "radius": DECIMAL} that contain the enclosures. */
#ifndef JLT_VALIDATED_SHOWN_H
#define JLT_VALIDATED_SHOWN_H

#include "validated/elliptic.h"
#include "validated/given.h"
#include "validated/homoclinic.h"

/** The object `shown` of a cycle; a new reference, NULL if memory is out. with_reversor: the theorem uses the reversor. */
json_t *jlt_shown_cycle(const jlt_cycle_result *result, const jlt_given *given, bool with_reversor);

/** {"reversor": STATES, "type": TEXT, "rotation": BALL}, "rotation" only if the cycle is elliptic; STATES are the names of the
 *  states that the reversor flips. A new reference, NULL if memory is out. */
json_t *jlt_shown_symmetry(const jlt_symmetry_result *result, const jlt_given *given);

/** {"coordinate": STATE, "coefficient": BALL, "growth": BALL}. A new reference, NULL if memory is out. */
json_t *jlt_shown_twist(const jlt_elliptic_result *result, const jlt_given *given);

/** The object `shown` of the saddle, with "homoclinic": "start", the distance along the frame's first direction at which the orbit
 *  begins; "first", its point there; "point", the symmetric one; "tangent" of the unstable manifold there; "conditions". */
json_t *jlt_shown_homoclinic(const jlt_homoclinic_result *result, const jlt_given *given);

/** {"middle": DECIMAL, "radius": DECIMAL}, a new reference. It has `digits` digits and twice the ball's radius, since a replay may
 *  take steps of other lengths and find another radius. With `replays` it is the ball itself, with ten digits more. */
json_t *jlt_shown_ball(const arb_t ball, unsigned digits, bool replays);

/** A decimal of five digits that is at most the lower bound `bound`, "-inf" for NaN; and one that is at least the upper bound. A
 *  new reference. */
json_t *jlt_shown_lower_bound(const arf_t bound);
json_t *jlt_shown_upper_bound(const arf_t bound);

/** Lower bounds of the model's conditions, shape (valid_count,), as an object by their names. */
json_t *jlt_shown_conditions(const arf_struct *least, const jlt_descriptor *descriptor);

#endif
