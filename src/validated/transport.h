/** Jet transport: the flow carries a polynomial of starts, coefficients enclosed.
 *
 *  Coefficients solve an equation of their own (rough.h), and are carried as a box, without axes that turn with it: its edges
 *  grow by what the equation's own norm makes of them. So it serves starts near which the orbit is known to many more digits
 *  than are wanted.
 *
 *  Source: E. M. Alessi, A. Farres, A. Jorba, C. Simo, A. Vieiro, jet transport, 2008; D. Wilczak, P. Zgliczynski, C^r-Lohner
 *  algorithm, Schedae Informaticae 20, 2011. */
#ifndef JLT_VALIDATED_TRANSPORT_H
#define JLT_VALIDATED_TRANSPORT_H

#include "validated/rough.h"

typedef struct jlt_transport jlt_transport;

/** Out: *transport, NULL on failure; destroy with jlt_transport_destroy. In: params, shape (of->params,), borrowed. Errors: as
 *  jlt_jets_create. */
JLT_CHECKED jlt_status jlt_transport_create(jlt_transport **transport, const jlt_formulas *of, arb_srcptr params,
                                            jlt_rough_accuracy accuracy, unsigned degree);
void jlt_transport_destroy(jlt_transport *transport); /* legal on NULL */

/** Carry x, shape (dim, terms), free parameters behind the states and left as they are, for a time in a ball, > 0, in place. The
 *  table's domain is not looked at: it is shown where the orbit is proved. Errors: NO_PROGRESS, no step that was tried can be
 *  validated. */
JLT_CHECKED jlt_status jlt_transport_carry(jlt_transport *self, arb_ptr x, const arb_t time);

/** Taylor coefficients of the solution through x, to order 3 at least: of coefficient `term` of state i, order by order, lowest
 *  first. */
void jlt_transport_expand(jlt_transport *self, arb_srcptr x);
arb_srcptr jlt_transport_series(const jlt_transport *self, unsigned state, unsigned term);

#endif
