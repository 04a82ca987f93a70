/** One orbit: propagated to times, to crossings, or into a pole, with invariants watched.
 *
 *      jlt_orbit *orbit = NULL;
 *      JLT_TRY(jlt_orbit_create(&orbit, jlt_method_find("dop853"), &field, &(jlt_options){ .tolerance = 1e-13 }));
 *      JLT_TRY(jlt_orbit_start(orbit, 0, x, +1));
 *      for (int i = 0; i < 10; i++) JLT_TRY(jlt_orbit_next(orbit, INFINITY, &upward, 1, &at));   // at.x, at.t
 *
 *  An orbit is used by one thread at a time; different orbits are independent. */
#ifndef JLT_INTEGRATE_ORBIT_H
#define JLT_INTEGRATE_ORBIT_H

#include <signal.h>

#include "integrate/event.h"
#include "integrate/invariant.h"

/** Zero means the default, in all fields. */
typedef struct {
    double tolerance;         /* see method.h; default 1e-12 */
    double first_step;        /* in tau */
    double max_step;          /* in tau */
    size_t max_steps;         /* budget of accepted and rejected steps of one call; default 10^7 */
    const volatile sig_atomic_t *interrupt; /* nonzero ends the call with JLT_END_INTERRUPT; NULL: none */
    jlt_invariants invariants;
    bool project;             /* after each step back onto the levels of the start, along the gradients, when off by more
                                 than rounding */
    bool ignore_pole;         /* go on in regularised time, for ever */
} jlt_options;

typedef enum {
    JLT_END_TIME,      /* t_end is reached */
    JLT_END_EVENT,     /* a crossing */
    JLT_END_POLE,      /* the orbit ends here: t is when, x the limit, with the root 0 */
    JLT_END_OBSERVER,  /* the observer said so */
    JLT_END_INTERRUPT  /* the flag was raised */
} jlt_end;

/** Where a call ended. x and t are those of the crossing or of t_end, and not of the step's end. */
typedef struct {
    jlt_end end;
    double t, tau;         /* tau is INFINITY at a pole */
    const double *x;       /* (dim,), the orbit's own, valid until its next call */
    jlt_crossing crossing; /* JLT_END_EVENT */
    double pole_rates[2];  /* JLT_END_POLE: decay rates in tau, > 0: of the root, and the slowest of all */
} jlt_outcome;

typedef struct jlt_orbit jlt_orbit;

/** Called after every accepted step; nonzero ends the run. */
typedef int (*jlt_observer)(void *context, jlt_orbit *orbit);

/** Errors: as jlt_stepper_create; UNSUPPORTED, project with a multistep method. `field` must live on. */
JLT_CHECKED jlt_status jlt_orbit_create(jlt_orbit **out, const jlt_method *method, const jlt_field *field,
                                        const jlt_options *options);
void jlt_orbit_destroy(jlt_orbit *self); /* NULL is legal */

/** Put it at x (dim,) at time t; direction +1 or -1. Levels of the invariants and event sides are taken anew.
 *  Errors: ARG, another direction; NONFINITE, t, x or the field there; NOMEM. */
JLT_CHECKED jlt_status jlt_orbit_start(jlt_orbit *self, double t, const double *x, int direction);
void jlt_orbit_observe(jlt_orbit *self, jlt_observer observer, void *context); /* NULL: nobody */

enum { JLT_ORBIT_EVENTS_MAX = 16 };

/** Go on to the next crossing of one of the events, to physical time t_end (+-INFINITY: no end), or into the pole,
 *  whichever comes first. Call again to go on: the same event list continues the same count of crossings; a changed list
 *  starts from the current point. count <= 8; levels are finite, else ARG. At JLT_END_TIME the next call starts from there
 *  with nothing lost.
 *  Errors: NONFINITE, NO_PROGRESS, BUDGET; DOMAIN, a field in the model's own time came to the edge of its domain; out then
 *  holds the last accepted point with end JLT_END_TIME. */
JLT_CHECKED jlt_status jlt_orbit_next(jlt_orbit *self, double t_end, const jlt_event *events, unsigned count,
                                      jlt_outcome *out);

/** To t_end exactly. x: shape (dim,). Errors: as above, x then holds the last accepted point; DOMAIN also where a pole was
 *  reached before, x then holds the limit. */
JLT_CHECKED jlt_status jlt_orbit_propagate(jlt_orbit *self, double t_end, double *x);

/** To each of `times` (count,), monotone in the orbit's direction; states: (count, dim). *done: rows filled.
 *  Errors: as jlt_orbit_propagate; INTERRUPT leaves OK with *done < count. */
JLT_CHECKED jlt_status jlt_orbit_sample(jlt_orbit *self, double *states, size_t *done, const double *times, size_t count);

const jlt_stepper *jlt_orbit_stepper(const jlt_orbit *self); /* the point now, the last step, counters */

/** Largest |F_i - F_i(start)| / max(1, |F_i(start)|) over accepted points since the start. drift: (invariants.count,). */
void jlt_orbit_drift(const jlt_orbit *self, double *drift);

#endif
