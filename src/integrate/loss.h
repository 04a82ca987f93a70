/** Where within the last step a function of the state comes to zero, or loses its sign and gets it back.
 *
 *  At the ends of the step, and at the method's nodes within it, its values are those of the function. Elsewhere it is a polynomial
 *  through 13 values, all of whose zeros are isolated as those of events are (event.h). The function's own values correct the
 *  polynomial where it is not accurate enough: at zeros of higher order, near poles and in narrow dips. A dip is found if what it
 *  adds to values some tenth of a step away is more than 1e-4 of the function's least value there; others may be stepped over. */
#ifndef JLT_INTEGRATE_LOSS_H
#define JLT_INTEGRATE_LOSS_H

#include "integrate/event.h"

/** Find the first zero within the last step of an event's function that has the sign `side` at its start. In/out: *theta, replaced
 *  by that of the zero if that is smaller. Errors and cost: as jlt_edge_left (edge.h). */
JLT_CHECKED jlt_status jlt_loss_zero(double *theta, jlt_stepper *stepper, const jlt_event *event, int side);

/** As jlt_loss_zero, for the function of an event that is positive at the start of the step. In/out: *theta, replaced by the first
 *  theta at which the function is not positive, if that is smaller; a function that is NaN at the end is not looked at. Errors: as
 *  jlt_stepper_dense. Cost, where it is positive at the end too: ten values of the function; by methods without nodes (method.h)
 *  two of values and slopes; and where that does not tell, jlt_stepper_dense and some 30 to 100 of values; or 150 more if the
 *  polynomial has a zero that the function has not. */
JLT_CHECKED jlt_status jlt_loss_first(double *theta, jlt_stepper *stepper, const jlt_event *event);

/** As jlt_watch_step (watch.h) for an event of such a function, of which the first loss on the last step is the only crossing. */
JLT_CHECKED jlt_status jlt_loss_step(const jlt_event *event, jlt_stepper *stepper, jlt_crossing *list, unsigned *count);

/** The least value of such a function from theta on, until it rises again, on the polynomial of the last step; call
 *  jlt_stepper_dense before. Cost: at most 145 values of the function. */
jlt_event_least jlt_loss_least(const jlt_stepper *stepper, const jlt_event *event, double theta);

#endif
