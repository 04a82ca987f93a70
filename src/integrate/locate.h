/** Evaluates an event's function g at a state, and refines its zeros on the flow itself. States and rates have shape (stride,), as
 *  the arrays of a stepper; theta is where in its last step, 0 at the start and 1 at the end. */
#ifndef JLT_INTEGRATE_LOCATE_H
#define JLT_INTEGRATE_LOCATE_H

#include "integrate/event.h"

/** g at x. */
double jlt_locate_value(const jlt_event *event, const double *x);

/** dg/dtau at x, where f is the field at x: by central differences along f where the event has no `rate`. */
double jlt_locate_slope(const jlt_event *event, const jlt_stepper *stepper, const double *x, const double *f);

/** The size relative to which x[column] - level is measured: |level|, or jlt_stepper_unit of the column if that is larger; |level|
 *  alone for a kept state (jlt_field) and a level other than 0, since such a state is known as well at small levels. */
double jlt_locate_unit(const jlt_event *event, const jlt_stepper *stepper);

/** Compute the state x at theta by a partial step, the field f there, and g with its rate dg/dtau. Errors: the partial step's. */
JLT_CHECKED jlt_status jlt_locate_state(const jlt_event *event, jlt_stepper *stepper, double theta, double *x, double *f,
                                        double *value, double *slope);

/** How far off the section, in units of jlt_locate_unit, an orbit must go on both sides of a crossing: ten tolerances, because a
 *  method at its stability limit keeps decayed components at a few tolerances; 1e-12 at least, and 1e-4 at most. */
static inline double jlt_locate_noise(double tolerance)
{
    const double noise = 10 * tolerance;
    return noise > 1e-4 ? 1e-4 : noise < 1e-12 ? 1e-12 : noise;
}

/** Refine crossing->theta on the flow, and give the state there, x. A grazing is left where it is.
 *  slope_work: work. Errors: NO_CONVERGENCE, a sign change without a zero (g is not continuous); those of partial
 *  steps. */
JLT_CHECKED jlt_status jlt_locate_refine(jlt_crossing *crossing, double *x, double *slope_work, const jlt_event *event,
                                           jlt_stepper *stepper);

#endif
