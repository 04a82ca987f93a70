/** A course: one motion, computed in the tier that a plan has chosen, and given as states of the model that was asked about. Where
 *  the orbit leaves what the tier covers, the next larger one that serves goes on, unless the tier was asked for by name.
 *
 *      JLT_TRY(jlt_course_create(&course, &plan, &question, &options));
 *      for (...) JLT_TRY(jlt_course_to(course, t, &row));          // times in one direction, row.end == JLT_END_TIME
 *
 *  Rows are the same in every tier, so that tiers can be compared: states at given times, drift of integrals, observed
 *  quantities. */
#ifndef JLT_SCENE_COURSE_H
#define JLT_SCENE_COURSE_H

#include "integrate/orbit.h"
#include "kernel/instance.h"
#include "scene/plan.h"

typedef struct {
    const jlt_method *method;               /* NULL: the default */
    double tolerance;                       /* of the local error, relative to scale; 0: 1e-12 */
    size_t max_steps;                       /* of one call; 0: 10^7 */
    bool project;                           /* after every step put the state back onto the start's levels of all integrals */
    const volatile sig_atomic_t *interrupt; /* may be NULL */
} jlt_course_options;

typedef struct {
    jlt_end end;              /* TIME; POLE: the orbit ends here; INTERRUPT: t was not reached */
    double t;                 /* in the table's unit, the start is at 0 */
    const double *x;          /* shape (states of the asked model,), the course's own, valid until the next call */
    const double *drift;      /* shape (integrals,): |F - F(start)|, relative as in course_drift.h */
    const double *observed;   /* shape (jlt_course_observes,): what the asked model's table observes; the course's own */
    double least;             /* least value since the start of the model's conditions (`valid` in its table), looked at where
                                 steps end and, where all hold there, within the step; INFINITY: the model has none */
    double lost_at;           /* time, up to t, at which a condition was first broken; NaN: never */
    const char *lost;         /* the condition that was broken then; NULL: none */
    double unknown_at;        /* time, up to t, at which one was first seen to have no value, and none to be broken; NaN: never */
    const char *unknown;      /* that condition; NULL: none */
    const double *more;       /* shape (jlt_course_tells_more,): what the question wants beside this, as attitude and track; NULL:
                                 nothing; the course's own */
    int side;                 /* POLE: which one, +1 or -1; 0: the model names none */
    unsigned pole;            /* POLE: the state that has come to an end of its interval */
    const char *unbounded;    /* NO_PROGRESS, NONFINITE: the tier's state that grows without bound; NULL: none is known */
    const char *edge;         /* DOMAIN: where the tier's coordinates end, for a message; the course's own */
} jlt_course_row;

typedef struct jlt_course jlt_course;

/** Create the course of the tier that plan->chosen names. *question and *plan are copied, with params and start; descriptors they
 *  point to must live as long as the course. Out: *out, NULL on failure. Errors: UNSUPPORTED (no kernel; project with more
 *  integrals than are served), those of jlt_orbit_create and jlt_rod_open, NONFINITE, NOMEM. */
JLT_CHECKED jlt_status jlt_course_create(jlt_course **out, const jlt_plan *plan, const jlt_question *question,
                                         const jlt_course_options *options);
void jlt_course_destroy(jlt_course *self); /* NULL is legal */

/** Go on to time t, in the table's unit; the start is at 0, and times go in one direction. *row is filled whenever JLT_OK is
 *  returned.
 *  Errors: those of jlt_orbit_next, and DOMAIN, the tier's coordinates end before t: the row then holds the last point reached,
 *  or has x NULL, lost_at and unknown_at NaN when there is none; ARG (t turns back). */
JLT_CHECKED jlt_status jlt_course_to(jlt_course *self, double t, jlt_course_row *row);

/** The kernel that is integrated, bound to its parameters and levels; with quadratures, which integrate nothing, the asked
 *  model's. */
const jlt_instance *jlt_course_kernel(const jlt_course *self);

/** Number and names of the integrals watched. */
unsigned jlt_course_integrals(const jlt_course *self);
const char *jlt_course_integral(const jlt_course *self, unsigned index);

/** How many quantities the asked model's table observes. Out: *quantities, shape (count,): their names, units and meanings. */
unsigned jlt_course_observes(const jlt_course *self, const jlt_quantity **quantities);

/** How many quantities a row has beyond, where the question wants more: states of the first tier's own, then what its table
 *  observes. Out: *quantities, unless NULL: shape (count,); *states, unless NULL: how many are states. A later tier begins at the
 *  asked model's states alone, which is no continuation of these: from there on they are NaN. */
unsigned jlt_course_tells_more(const jlt_course *self, const jlt_quantity **quantities, unsigned *states);

/** How often one tier has given over to the next; and of change number `index` its time, the names of both, and why the first one
 *  ended. */
unsigned jlt_course_changes(const jlt_course *self);
void jlt_course_change(const jlt_course *self, unsigned index, double *t, const char **from, const char **to, const char **why);

/** Steps and evaluations of the field so far; both 0 for quadratures. */
void jlt_course_cost(const jlt_course *self, size_t *steps, size_t *evaluations);

#endif
