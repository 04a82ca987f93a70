/** What a kernel of the spherical top keeps, for watching and projecting: its integrals, and in regular time the relation
 *  gamma3^2 + s^2 = 1 of the lifted root, which a projection onto the integrals alone would spoil. */
#ifndef JLT_TOP_CONSERVED_H
#define JLT_TOP_CONSERVED_H

#include "integrate/field.h"
#include "integrate/invariant.h"

/** Plain data that must outlive the invariants made from it and serves as their block, hence the alignment. */
typedef struct {
    _Alignas(double) const jlt_descriptor *descriptor;
    const double *block;
    unsigned dim;
    int root; /* -1: none */
} jlt_conserved;

/** The invariants of a field made by jlt_field_of; gamma3 is the first state.
 *  Errors: UNSUPPORTED, they are more than JLT_INVARIANTS_MAX. */
JLT_CHECKED jlt_status jlt_conserved_of(jlt_invariants *out, jlt_conserved *keep, const jlt_descriptor *descriptor,
                                        const jlt_field *field);

#endif
