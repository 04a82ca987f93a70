/** Ends of the intervals in which a field's states must stay. Used by stepper.c. */
#ifndef JLT_INTEGRATE_EDGE_H
#define JLT_INTEGRATE_EDGE_H

#include "integrate/method.h"

/** The least distance of the stepper's point from such an end, less JLT_FIELD_NEAREST of it, in units of the end or of what
 *  counts as small: it has left where this is not > 0. INFINITY where no interval is watched. */
double jlt_edge_distance(const jlt_stepper *stepper);

/** An orbit that is to leave is at its end where that distance is below this: the tolerance, or rounding. */
double jlt_edge_near(const jlt_stepper *stepper);

/** Out: *theta, 0 <= theta < 1: where the polynomial of the last step, which led out, comes to half of jlt_edge_near before it leaves.
 *  Cost: that of jlt_stepper_dense. Errors: its own. */
JLT_CHECKED jlt_status jlt_edge_find(double *theta, jlt_stepper *stepper);

#endif
