/** A symmetric homoclinic orbit in doubles, for `jellett certify homoclinic` to begin with. */
#ifndef JLT_CLI_CERTIFY_HOMOCLINIC_H
#define JLT_CLI_CERTIFY_HOMOCLINIC_H

#include "dynamics/map.h"

enum { JLT_CERTIFY_RETURNS_MAX = 128 };

typedef struct {
    unsigned states;       /* of a row of x */
    const signed char *signs; /* of the reversor, (states,) */
    const double *saddle;  /* (2,), coordinates of a fixed point of the map */
    unsigned which;        /* of the orbits found, from 1 */
    double distance;       /* at which the orbit is to begin, in these coordinates */
} jlt_certify_search;

/** Starts along the unstable direction, over one fundamental domain, are followed until the sign of the state that the reversor
 *  flips differs between neighbours at a crossing of the section in either direction. Such pairs are counted by returns, then by
 *  their distance. Out: x, shape (returns + 1, states), and T, shape (returns + 1,), room for JLT_CERTIFY_RETURNS_MAX rows; *legs,
 *  how many there are. Errors: those of jlt_map_apply; NO_CONVERGENCE, none is found, or the map has no saddle there;
 *  UNSUPPORTED, other than two coordinates, or the reversor does not flip the section's state and one other. */
JLT_CHECKED jlt_status jlt_certify_homoclinic_find(double *x, double *T, unsigned *legs, const jlt_flow *flow,
                                                   const jlt_certify_search *search);

#endif
