/** Finds a periodic orbit in doubles, and cuts it into the legs from which a certificate is made. */
#ifndef JLT_CLI_CERTIFY_CYCLE_H
#define JLT_CLI_CERTIFY_CYCLE_H

#include "cli/motion.h"

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

#endif
