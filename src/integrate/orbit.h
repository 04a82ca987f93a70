/** Follows one orbit to given times, to crossings of a surface, or into a pole, and watches invariants on the way.
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

/** The default tolerance. */
#define JLT_ORBIT_TOLERANCE 1e-12

/** Zero means the default, in all fields. */
typedef struct {
    double tolerance;         /* see method.h; default JLT_ORBIT_TOLERANCE */
    double first_step;        /* |dtau|; default: the method chooses */
    double max_step;          /* |dtau|; default: no limit */
    size_t max_steps;         /* budget of accepted and rejected steps of one call; default 10^7; of a stiff motion that would not
                                 come to t_end, or to t_last, with them fewer are taken */
    double t_last;            /* the last t_end that will be asked for; default: that of each call */
    const volatile sig_atomic_t *interrupt; /* nonzero ends the call with JLT_END_INTERRUPT; NULL: none */
    jlt_invariants invariants;
    bool project;             /* after each step put the state back onto the start's levels of the invariants, along their
                                 gradients, when it is off by more than rounding; crossings and times asked for lie within steps,
                                 whose states are off by a step's error */
    bool ignore_pole;         /* do not end at a pole, but go on towards it in regularised time without end */
} jlt_options;

typedef enum {
    JLT_END_TIME,      /* t_end is reached */
    JLT_END_EVENT,     /* a crossing */
    JLT_END_POLE,      /* the orbit ends here: t is when, x the limit, with the root 0 */
    JLT_END_OBSERVER,  /* the observer returned nonzero */
    JLT_END_INTERRUPT  /* options.interrupt became nonzero */
} jlt_end;

/** Where a call ended. x and t belong to the crossing or to t_end; the last step may reach beyond. */
typedef struct {
    jlt_end end;
    double t, tau;         /* tau is INFINITY at a pole, -INFINITY backwards in time */
    const double *x;       /* (dim,), the orbit's own, valid until its next call */
    jlt_crossing crossing; /* JLT_END_EVENT */
    double pole_rates[2];  /* JLT_END_POLE: decay rates in tau, > 0: of the root, and the slowest of all */
} jlt_outcome;

typedef struct jlt_orbit jlt_orbit;

/** Called after every accepted step; nonzero ends the run. */
typedef int (*jlt_observer)(void *context, jlt_orbit *orbit);

/** Create an orbit; call jlt_orbit_start before the rest. Out: *out, NULL on failure. In: method and options, NULL for the
 *  defaults. `field` must live as long as the orbit.
 *  Errors: as jlt_stepper_create; ARG, a tolerance or step below 0, an infinite first_step, an option that is NaN, more than
 *  JLT_INVARIANTS_MAX invariants, or project without their gradients; UNSUPPORTED, project with a multistep method. */
JLT_CHECKED jlt_status jlt_orbit_create(jlt_orbit **out, const jlt_method *method, const jlt_field *field,
                                        const jlt_options *options);
void jlt_orbit_destroy(jlt_orbit *self); /* NULL is legal */
JLT_OWNED_TYPE(jlt_orbit)

/** Start at x, shape (dim,), at time t, forwards (direction +1) or backwards (-1) in time. The invariants' levels, and the side
 *  of each event that the orbit is on, are those of x. Steps are rounded as t is: 1e-10 s at t = 1e6 s.
 *  Errors: ARG, another direction; NONFINITE, t, x or the field there; NO_CONVERGENCE, as jlt_pole_judge. */
JLT_CHECKED jlt_status jlt_orbit_start(jlt_orbit *self, double t, const double *x, int direction);

/** From now on call `observer` with `context` after every accepted step; NULL: no more. */
void jlt_orbit_observe(jlt_orbit *self, jlt_observer observer, void *context);

/** For an observer: replace the point and the scales, as jlt_stepper_replace. No event may depend on what is changed. */
JLT_CHECKED jlt_status jlt_orbit_replace(jlt_orbit *self, const double *x, const double *scale);

enum { JLT_ORBIT_EVENTS_MAX = 16 };

/** Go on to the next crossing of one of the events, shape (count,), to physical time t_end (+-INFINITY: no end), or into the
 *  pole, whichever comes first; *out says which. Call again to go on from there: with the same events no crossing is lost or
 *  found twice; with others the search begins behind the current point.
 *  Errors: ARG, no orbit was started, count > JLT_ORBIT_EVENTS_MAX, a column that the field has not, a level that is not finite,
 *  another direction, or t_end is NaN or lies before the point handed out last; NONFINITE, NO_PROGRESS, BUDGET; NO_CONVERGENCE, of
 *  a crossing (locate.h), a partial step or the eigenvalues near a pole; DOMAIN, the orbit came to the edge of its field's domain.
 *  On all but ARG *out holds the last accepted point, with end JLT_END_TIME. */
JLT_CHECKED jlt_status jlt_orbit_next(jlt_orbit *self, double t_end, const jlt_event *events, unsigned count,
                                      jlt_outcome *out);

/** Follow the orbit to t_end exactly. Out: x, shape (dim,). An interrupt, or an observer that ends the run, returns OK: x
 *  then holds the last accepted point, and jlt_stepper_time of jlt_orbit_stepper its time.
 *  Errors: as jlt_orbit_next, x then holds the last accepted point (on ARG what it held); DOMAIN also when the orbit ends at a pole
 *  before t_end, x then holds the limit. */
JLT_CHECKED jlt_status jlt_orbit_propagate(jlt_orbit *self, double t_end, double *x);

/** The states at `times`, shape (count,), in the order in which the orbit comes to them: ARG where one turns back.
 *  Out: states, shape (count, dim); *done, how many rows are filled. An interrupt, or an observer that ends the run, returns
 *  OK with *done < count.
 *  Errors: as jlt_orbit_propagate. */
JLT_CHECKED jlt_status jlt_orbit_sample(jlt_orbit *self, double *states, size_t *done, const double *times, size_t count);

const jlt_stepper *jlt_orbit_stepper(const jlt_orbit *self); /* the point now, the last step, counters */

/** Find where in the last step the function of an event, positive at its start, first comes to zero. Out: *theta, in [0, 1],
 *  or INFINITY: nowhere; else *least, its least value from there on until it rises again, and jlt_stepper_values may be called.
 *  Errors and cost: those of jlt_loss_first, jlt_loss_least (loss.h). */
JLT_CHECKED jlt_status jlt_orbit_loss(jlt_orbit *self, double *theta, jlt_event_least *least, const jlt_event *event);

/** The least value of an event's function in the last step, from its start on until it rises again, and at its end. The step's
 *  polynomial costs as in jlt_stepper_dense; if that fails, only the ends count. */
jlt_event_least jlt_orbit_least(jlt_orbit *self, const jlt_event *event);

/** The value of an event's function at the fraction theta of the last step, by a partial step: without the polynomial's error.
 *  Errors: the step's. */
JLT_CHECKED jlt_status jlt_orbit_value(jlt_orbit *self, double *value, const jlt_event *event, double theta);

/** Largest |F_i - F_i(start)| / max(1, |F_i(start)|) over accepted points since the start. drift: (invariants.count,). */
void jlt_orbit_drift(const jlt_orbit *self, double *drift);

#endif
