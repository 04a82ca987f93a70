/** Encloses the Taylor polynomial of degree 3 of a cycle's return map on the levels, in two coordinates.
 *
 *  At the cycle's first point y_0 on the section the kept states are q = y_q + (u, v); the others follow from the levels as
 *  polynomials, degree by degree. The flow carries these polynomials for the time that the cycle takes to its next point: their
 *  coefficients solve a differential equation of their own (rough.h), and are carried as a box whose axes do not turn with the
 *  flow: its edges grow at the rate of that equation's norm. This suffices, as the cycle is known to many more digits than the
 *  result needs (E. M. Alessi, A. Farres, A. Jorba, C. Simo, A. Vieiro, jet transport, 2008; D. Wilczak, P. Zgliczynski,
 *  C^r-Lohner algorithm, Schedae Informaticae 20, 2011). From there, with c_k the Taylor coefficients in time, a start crosses
 *  after a further time s(u, v) that vanishes at 0 and solves
 *      sum over k of c_k(u, v) s^k = level
 *  for the section's state, again degree by degree. Constant coefficients are taken from the cycle at every leg, so that their
 *  errors are not passed on. */
#ifndef JLT_VALIDATED_TAYLOR_MAP_H
#define JLT_VALIDATED_TAYLOR_MAP_H

#include "validated/cycle.h"

enum { JLT_TAYLOR_MAP_DEGREE = 3, JLT_TAYLOR_MAP_TERMS = 10 };

/** Out: map, shape (2, terms), of the kept states, in the order of jets.h. In: cycle, PROVED from these instants, with two
 *  multipliers; kept, shape (2,). Errors: as jlt_arrival_compute; NO_PROGRESS, no step can be validated;
 *  DOMAIN, levels do not give the others. */
JLT_CHECKED jlt_status jlt_taylor_map_compute(jlt_cycle *of, arb_ptr map, const jlt_cycle_result *cycle, arb_srcptr instants,
                                              const unsigned *kept);

#endif
