/** A set of states carried along by a flow, with the flow's derivative over it.
 *
 *  The states are x + C r0 + Q r: x, C and Q are exact, r0 is the box of the start, and r collects the errors of all steps, in
 *  axes Q that are made orthogonal again at every step to avoid the wrapping effect (R. J. Lohner, Einschliessung der Loesung
 *  gewoehnlicher Anfangs- und Randwertaufgaben, 1988). The derivative is V + B R likewise (P. Zgliczynski, C1-Lohner algorithm,
 *  Found. Comput. Math. 2, 2002). */
#ifndef JLT_VALIDATED_SET_H
#define JLT_VALIDATED_SET_H

#include "ext/scoped.h"

typedef struct {
    unsigned dim;
    slong bits;
    arb_mat_t x, C, r0, Q, r; /* (dim, 1), (dim, dim), (dim, 1), (dim, dim), (dim, 1); r0 and r centred at 0 */
    arb_mat_t V, B, R;        /* (dim, dim) each */
} jlt_set;

/** Initialize to the box x, shape (dim,), with the identity as derivative. Release with jlt_set_clear. */
void jlt_set_init(jlt_set *self, arb_srcptr x, unsigned dim, slong bits);
void jlt_set_clear(jlt_set *self);

/** The least box x, shape (dim,), around the set. */
void jlt_set_hull(arb_ptr x, const jlt_set *self);

/** The derivative, slope, shape (dim, dim). */
void jlt_set_slope(arb_mat_t slope, const jlt_set *self);

/** Replace the set by its image under a map f: image, shape (dim, 1), encloses f(x); slope, shape (dim, dim), maps differences
 *  from x to differences of images by the mean value theorem; derivative, shape (dim, dim), encloses Df over the set. */
void jlt_set_move(jlt_set *self, const arb_mat_t image, const arb_mat_t slope, const arb_mat_t derivative);

#endif
