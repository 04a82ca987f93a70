/** A set of states that is carried along by a flow, with what the flow's derivative is over it.
 *
 *  The states are x + C r0 + Q r: x, C and Q are exact, r0 is the start's box, r collects what every step leaves over, in axes that
 *  are made orthogonal anew at every step, so that boxes are not wrapped in boxes (R. J. Lohner, Einschliessung der Loesung
 *  gewoehnlicher Anfangs- und Randwertaufgaben, 1988). The derivative is V + B R likewise (P. Zgliczynski, C1-Lohner algorithm,
 *  Found. Comput. Math. 2, 2002). */
#ifndef JLT_VALIDATED_SET_H
#define JLT_VALIDATED_SET_H

#include "validated/balls.h"

typedef struct {
    unsigned dim;
    slong bits;
    arb_mat_t x, C, r0, Q, r; /* (dim, 1), (dim, dim), (dim, 1), (dim, dim), (dim, 1); r0 and r centred at 0 */
    arb_mat_t V, B, R;        /* (dim, dim) each */
} jlt_set;

/** The box x, shape (dim,), with the derivative 1. Ends with jlt_set_clear. */
void jlt_set_init(jlt_set *self, arb_srcptr x, unsigned dim, slong bits);
void jlt_set_clear(jlt_set *self);

/** The least box around it. Out: x, shape (dim,). */
void jlt_set_hull(arb_ptr x, const jlt_set *self);

/** The derivative. Out: (dim, dim). */
void jlt_set_slope(arb_mat_t slope, const jlt_set *self);

/** The set's image under a map f: image, shape (dim, 1), encloses f(x); slope, shape (dim, dim), encloses what takes differences
 *  from x to differences of images (mean value); derivative, shape (dim, dim), encloses Df over the set. */
void jlt_set_move(jlt_set *self, const arb_mat_t image, const arb_mat_t slope, const arb_mat_t derivative);

#endif
