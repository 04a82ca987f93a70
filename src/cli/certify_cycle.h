/** A periodic orbit in doubles, as the legs from which a certificate of it is made. */
#ifndef JLT_CLI_CERTIFY_CYCLE_H
#define JLT_CLI_CERTIFY_CYCLE_H

#include "cli/motion.h"

/** Whether turns are counted in periods that the table has, and no others were typed; a state that the table has none of is left to
 *  the certificate, which refuses its turns. */
jlt_exit jlt_certify_cycle_check(const jlt_system *system);

/** The orbit of so many returns near the start q, shape (dim,) of the section. Out: starts of its legs, x, shape (period, states),
 *  the states of the model alone; their times, T, shape (period,); by how many of their periods states have grown at the end of
 *  each, turns, shape (period, states), which the next start has not; *legs, how many there are; *near_one, the multiplier that
 *  is nearest to 1, by its distance from it. Errors: as jlt_periodic_find; as jlt_orbit_propagate. */
JLT_CHECKED jlt_status jlt_certify_cycle_find(double *x, double *T, int *turns, unsigned *legs, double *near_one,
                                              const jlt_system *system, const double *q, size_t period);

#endif
