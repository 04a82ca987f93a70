/** What was proved, as certificates say it: balls as {"middle": DECIMAL, "radius": DECIMAL} that contain what was enclosed. */
#ifndef JLT_VALIDATED_SHOWN_H
#define JLT_VALIDATED_SHOWN_H

#include "validated/elliptic.h"
#include "validated/given.h"
#include "validated/homoclinic.h"

/** A new reference, NULL when memory is out. with_reversor: the theorem rests on the table's reversor too. */
json_t *jlt_shown_cycle(const jlt_cycle_result *result, const jlt_given *given, bool with_reversor);

/** {"reversor": STATES, "type": TEXT, "rotation": BALL}, the last where it is elliptic; STATES are the names of those that the
 *  reversor flips. A new reference, NULL when memory is out. */
json_t *jlt_shown_symmetry(const jlt_symmetry_result *result, const jlt_given *given);

/** {"coordinate": STATE, "coefficient": BALL, "growth": BALL}. A new reference, NULL when memory is out. */
json_t *jlt_shown_twist(const jlt_elliptic_result *result, const jlt_given *given);

/** The same of the saddle, with "homoclinic": "start", the distance along the frame's first direction at which the orbit begins,
 *  "first", its point there, "point", the symmetric one, "tangent" of the unstable manifold there, "conditions" on the way. */
json_t *jlt_shown_homoclinic(const jlt_homoclinic_result *result, const jlt_given *given);

/** {"middle": DECIMAL, "radius": DECIMAL} around a ball of twice the radius, so that a replay need not give the same last bits; a
 *  new reference. */
json_t *jlt_shown_ball(const arb_t ball, unsigned digits);

/** A decimal of five digits below a bound, or at it, "-inf" for NaN; and above a bound likewise. A new reference. */
json_t *jlt_shown_lower_bound(const arf_t bound);
json_t *jlt_shown_upper_bound(const arf_t bound);

/** Lower bounds of the model's conditions by names, shape (valid_count,). */
json_t *jlt_shown_conditions(const arf_struct *least, const jlt_descriptor *descriptor);

#endif
