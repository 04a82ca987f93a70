/** The conserved quantities of a generated field, for watching and projecting: its integrals; and, where roots are lifted to
 *  states, the relations root^2 = radicand, which a projection onto the integrals alone would spoil. */
#ifndef JLT_INTEGRATE_CONSERVED_H
#define JLT_INTEGRATE_CONSERVED_H

#include "integrate/field.h"
#include "integrate/invariant.h"

/** Plain data that must outlive the invariants made from it and is passed to them as their prepared values, hence the alignment. */
typedef struct {
    _Alignas(double) const jlt_instance *instance;
} jlt_conserved;

/** The invariants of the field of `instance`, which must live as long. keep: storage to which *out points. Errors: UNSUPPORTED,
 *  there are more than JLT_INVARIANTS_MAX. */
JLT_CHECKED jlt_status jlt_conserved_of(jlt_invariants *out, jlt_conserved *keep, const jlt_instance *instance);

#endif
