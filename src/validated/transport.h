/** Jet transport: carries a polynomial of starts by the flow, with enclosed coefficients.
 *
 *  The coefficients solve a differential equation of their own (rough.h), and are carried as a box whose axes do not turn with the
 *  flow: its edges grow at the rate of that equation's norm. This suffices if the orbit through the starts is known to many more
 *  digits than the result needs.
 *
 *  Source: E. M. Alessi, A. Farres, A. Jorba, C. Simo, A. Vieiro, jet transport, 2008; D. Wilczak, P. Zgliczynski, C^r-Lohner
 *  algorithm, Schedae Informaticae 20, 2011. */
#ifndef JLT_VALIDATED_TRANSPORT_H
#define JLT_VALIDATED_TRANSPORT_H

#include "validated/rough.h"

typedef struct jlt_transport jlt_transport;

/** Out: *transport, NULL on failure; destroy it with jlt_transport_destroy. In: params, shape (of->params,), borrowed. Errors: as
 *  jlt_jets_create. */
JLT_CHECKED jlt_status jlt_transport_create(jlt_transport **transport, const jlt_formulas *of, arb_srcptr params,
                                            jlt_rough_accuracy accuracy, unsigned degree);
void jlt_transport_destroy(jlt_transport *transport); /* legal on NULL */

/** Carry x, shape (dim, terms), in place for a time > 0, given as a ball; the free parameters after the states stay unchanged. The
 *  table's domain is not checked. Errors: NO_PROGRESS, no step can be validated. */
JLT_CHECKED jlt_status jlt_transport_carry(jlt_transport *self, arb_ptr x, const arb_t time);

/** jlt_transport_expand computes the Taylor coefficients of the solution through x, to order 3 at least; jlt_transport_series is
 *  the series of coefficient `term` of state i, lowest order first. */
void jlt_transport_expand(jlt_transport *self, arb_srcptr x);
arb_srcptr jlt_transport_series(const jlt_transport *self, unsigned state, unsigned term);

#endif
