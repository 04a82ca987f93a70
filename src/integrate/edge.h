/** Where an orbit leaves the domain of its field: an end of a state's interval, or a condition that comes to zero.
 *
 *  Both are functions that are positive inside. They are evaluated at the ends of steps. Within a step they are examined as in
 *  loss.h: an orbit which leaves and comes back within one step is detected if it is outside by more than jlt_locate_noise, or if a
 *  condition is negative by more than rounding. A kept state (jlt_field), or a group, that has been below JLT_STEPPER_SCALE_LEAST
 *  is lost, as only errors are left of it: the orbit counts as outside where such a state rises above twice this scale. */
#ifndef JLT_INTEGRATE_EDGE_H
#define JLT_INTEGRATE_EDGE_H

#include "integrate/event.h"

/** Find where in the last step the orbit is outside for the first time, as far as the polynomial tells. Out: *theta, 1 where only
 *  the end of the step is known to be outside, INFINITY when the orbit stays inside.
 *  Errors: those of jlt_stepper_dense and of partial steps. Cost: that of jlt_stepper_dense where the step comes so near to an end
 *  that its variation does not exclude it; of conditions, that of jlt_loss_first. */
JLT_CHECKED jlt_status jlt_edge_left(double *theta, jlt_stepper *stepper);

/** Whether the stepper's point is outside the domain. */
bool jlt_edge_is_outside(const jlt_stepper *stepper);

/** Whether the point counts as being at the domain's end. It does if its distance from an interval's end, relative to the larger of
 *  |end| and the state's scale, is at most d, the larger of the tolerance and 2^-46; or if the ratio of a condition's value to that
 *  at the start of the step, or the inverse of that ratio near a pole, is at most d, and a condition comes to 0 at its present
 *  rate, or came from there, in a time of at most d steps. */
bool jlt_edge_reached(const jlt_stepper *stepper);

/** Whether the orbit would be outside, or have passed the zero of a condition, after going straight on for 1e-8 |tau|: where the
 *  field is unbounded at the edge, or has no values outside, it may be that no step comes nearer. */
bool jlt_edge_is_ahead(const jlt_stepper *stepper);

/** One end of the domain: a condition of its field's table, or an end of a state's interval. */
typedef struct {
    bool is_condition;
    unsigned index; /* of the condition, or of the state */
    bool is_upper;  /* of the interval's ends */
    bool is_lost;   /* the state, kept or in a group, is lost, as above: its end is 0 */
} jlt_edge_part;

/** Find the end that the stepper's point is beyond, or comes to first if it goes straight on. Returns false if it comes to none.
 *  Cost: the values of all conditions, and their gradients. */
bool jlt_edge_ahead(jlt_edge_part *out, const jlt_stepper *stepper);

/** Find where the polynomial of the last step, before it leaves, is half as far from the domain's end as jlt_edge_reached allows.
 *  In/out: *theta, from jlt_edge_left; then that place, 0 <= theta < 1. Errors: as jlt_stepper_dense. Cost: that of
 *  jlt_stepper_dense, and some 75 values of the conditions, twice each. */
JLT_CHECKED jlt_status jlt_edge_find(double *theta, jlt_stepper *stepper);

#endif
