/** An orbit that comes to rest: it decays onto an equilibrium, or is on one as far as its accuracy goes.
 *
 *  Time never ends there, but what is left of the motion drowns in the errors of the method. Speeds are changes in a unit of
 *  physical time, relative to the state or 1: near a pole everything slows down in tau, and that is no rest. */
#ifndef JLT_INTEGRATE_REST_H
#define JLT_INTEGRATE_REST_H

#include "integrate/approach.h"

/** Slower than this, a thousand tolerances, an orbit that decays counts as come to rest; the bound keeps out others at loose
 *  tolerances, whose speeds are of the order of 1. Slower than JLT_REST_STILL any orbit does. */
#define JLT_REST_STILL 1e-12
double jlt_rest_slow(double tolerance);

/** Whether the field at x, shape (dim,), is slower than `speed`. Cost: 1 evaluation. */
bool jlt_rest_is_slower(const jlt_field *field, const double *x, double speed);

/** An orbit under watch; zeroed where it begins, and at crossings of a section: an orbit that creeps makes none. */
typedef struct {
    unsigned steps, slow_steps;
} jlt_rest_watch;

/** After an accepted step: whether the orbit is at its end, slow for some turns of a spiral, or nearer to its equilibrium than
 *  crossings of a section are deep (see jlt_locate_noise), where a method at its limit of stability holds speeds of the fastest
 *  rate times its errors for ever. limit as below. Cost: at most a Jacobian and its eigenvalues every 1024 steps until the orbit is
 *  slow. */
bool jlt_rest_watch_step(jlt_rest_watch *self, const jlt_stepper *stepper, double *limit);

/** Whether a slow orbit is at its end at the stepper's current point; limit, shape (dim,), then gets the equilibrium. Cost: a
 *  Jacobian and its eigenvalues. */
bool jlt_rest_ends(const jlt_stepper *stepper, double *limit);

#endif
