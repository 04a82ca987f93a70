/** Finds in doubles the orbits from which certificates are made: periodic ones, cut into legs, and symmetric homoclinic ones. */
#ifndef JLT_CLI_CERTIFY_ORBIT_H
#define JLT_CLI_CERTIFY_ORBIT_H

#include "cli/motion.h"
#include "dynamics/map.h"

/** Check that --modulo gives no other periods than the table, in which certificates count turns. States without a period in the
 *  table pass: the certificate refuses their turns. */
jlt_exit jlt_certify_cycle_check(const jlt_system *system);

/** Find the orbit that closes after `period` returns near q, shape (dim,). Out: *legs, its least number of returns; for each leg
 *  its start, x, shape (*legs, states), without lifted roots; its duration, T, shape (*legs,); and turns, shape (*legs, states),
 *  the numbers of periods that each angle has gained at its end and that are taken off at the start of the next leg. All have room
 *  for `period` legs. *near_one, the distance from 1 of the multiplier that is nearest to it. Errors: as jlt_periodic_find; as
 *  jlt_orbit_propagate. */
JLT_CHECKED jlt_status jlt_certify_cycle_find(double *x, double *T, int *turns, unsigned *legs, double *near_one,
                                              const jlt_system *system, const double *q, size_t period);

enum { JLT_CERTIFY_RETURNS_MAX = 128 };

typedef struct {
    unsigned states;       /* columns of x */
    const signed char *signs; /* of the reversor, (states,) */
    const double *saddle;  /* (2,), coordinates of a fixed point of the map */
    unsigned which;        /* which of the orbits found to take, counted from 1 */
    double distance;       /* least distance of the orbit's first point from the saddle, in units of the coordinates' sizes */
} jlt_certify_search;

/** Follow starts along the unstable direction, over a fundamental domain of the squared map, until s, the state that the reversor
 *  flips besides the section's, has different signs at neighbouring starts, at the crossing (in either direction) after a return;
 *  then bisect for s = 0. Orbits are numbered by returns, then by distance. Out: x, shape (*legs, states), the points of the
 *  section, and T, shape (*legs,), the times from each to the next, and from the last to s = 0; room for JLT_CERTIFY_RETURNS_MAX
 *  rows. Errors: as jlt_map_apply; NO_CONVERGENCE, there is no such orbit, or no saddle; UNSUPPORTED, the section does not have two
 *  coordinates, or the reversor does not flip the section's state and exactly one other. */
JLT_CHECKED jlt_status jlt_certify_homoclinic_find(double *x, double *T, unsigned *legs, const jlt_flow *flow,
                                                   const jlt_certify_search *search);

#endif
