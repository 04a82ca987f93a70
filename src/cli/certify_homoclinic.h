/** Finds a symmetric homoclinic orbit in doubles, from which `jellett certify homoclinic` starts. */
#ifndef JLT_CLI_CERTIFY_HOMOCLINIC_H
#define JLT_CLI_CERTIFY_HOMOCLINIC_H

#include "dynamics/map.h"

enum { JLT_CERTIFY_RETURNS_MAX = 128 };

typedef struct {
    unsigned states;       /* columns of x */
    const signed char *signs; /* of the reversor, (states,) */
    const double *saddle;  /* (2,), coordinates of a fixed point of the map */
    unsigned which;        /* which of the orbits found to take, counted from 1 */
    double distance;       /* least distance of the orbit's first point from the saddle, in these coordinates */
} jlt_certify_search;

/** Follow starts along the unstable direction, over a fundamental domain of the squared map, until s, the state that the reversor
 *  flips beside the section's, has different signs at neighbouring starts, at the crossing (in either direction) after a return;
 *  then bisect for s = 0. Orbits are numbered by returns, then by distance. Out: x, shape (*legs, states), the points of the
 *  section, and T, shape (*legs,), the times from each to the next, and from the last to s = 0; room for JLT_CERTIFY_RETURNS_MAX
 *  rows. Errors: as jlt_map_apply; NO_CONVERGENCE, there is no such orbit, or no saddle; UNSUPPORTED, the section does not have two
 *  coordinates, or the reversor does not flip the section's state and exactly one other. */
JLT_CHECKED jlt_status jlt_certify_homoclinic_find(double *x, double *T, unsigned *legs, const jlt_flow *flow,
                                                   const jlt_certify_search *search);

#endif
