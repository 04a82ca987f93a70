/** An orbit that comes to rest: it decays onto an equilibrium, or is on one as far as its accuracy goes.
 *
 *  Time never ends there, but the rest of the motion is less than the errors of the method. Speeds are changes in a unit of
 *  physical time, relative to the state or the size of the orbit's start (jlt_field_size): near a pole everything slows down in
 *  tau, and that is no rest. An orbit is not at rest while a kept state (jlt_field) grows, as an epidemic does from 1e-20: the
 *  speed of such a state is relative to the state alone. Nor is it while states that are 0 only together grow, relative to the
 *  largest of them. `direction` is that of time, +1 or -1. */
#ifndef JLT_INTEGRATE_REST_H
#define JLT_INTEGRATE_REST_H

#include "integrate/approach.h"

/** The speed below which an orbit counts as come to rest where an equilibrium is as near (jlt_approach_is_near). */
#define JLT_REST_STILL 1e-12

/** The speed below which an orbit that decays counts as come to rest: a thousand tolerances, but JLT_REST_STILL at least, and 1e-6
 *  at most, since a thousand loose tolerances would be the speed of ordinary motion. */
double jlt_rest_slow(double tolerance);

/** Whether the field at x, shape (dim,), is slower than `speed` on an orbit of this size. Cost: 1 evaluation. */
bool jlt_rest_is_slower(const jlt_field *field, const double *x, double size, double speed, double direction);

/** Whether an orbit that starts at x is at rest: it is slower than JLT_REST_STILL, and as near to an equilibrium. Cost: 1
 *  evaluation; a Jacobian and its eigenvalues where it is slow. */
bool jlt_rest_is_still(const jlt_field *field, const double *x, double direction);

/** Whether state `column` is a kept one that still moves towards this level, however small both are: it will cross the level, and
 *  the orbit is not at rest before. */
bool jlt_rest_is_ahead(const jlt_stepper *stepper, unsigned column, double level);

/** Counts of an orbit's steps. The caller zeroes it at the start, and at every crossing of a section, since an orbit that comes to
 *  rest makes no more of them. */
typedef struct {
    unsigned steps, slow_steps;
} jlt_rest_watch;

/** Call after an accepted step. Returns true if the orbit has been slow for 64 steps and jlt_rest_ends holds, or if it
 *  decays and is nearer to its equilibrium than jlt_locate_noise (a method at its stability limit may never become slow), tested
 *  every 1024 steps. limit as below. Cost: at most a Jacobian and its eigenvalues every 1024 steps until the orbit is slow. */
bool jlt_rest_watch_step(jlt_rest_watch *self, const jlt_stepper *stepper, double *limit);

/** Whether a slow orbit is at its end at the stepper's current point; limit, shape (dim,), then gets the equilibrium. Cost: a
 *  Jacobian and its eigenvalues. */
bool jlt_rest_ends(const jlt_stepper *stepper, double *limit);

#endif
