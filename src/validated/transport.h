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

/** Carry x, shape (dim, terms), in place for a time > 0, given as a ball; the free parameters after the states stay unchanged. The
 *  table's domain is not checked. In/out: *self, of the table's motion. Errors: NO_PROGRESS, no step can be validated. */
JLT_CHECKED jlt_status jlt_transport_carry(jlt_rough *self, arb_ptr x, const arb_t time);

#endif
