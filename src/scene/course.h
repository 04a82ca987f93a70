/** A course: one motion, computed in the tier that a plan has chosen, and given as states of the model asked for. Where the orbit
 *  leaves the region that the tier covers, the next larger tier that serves continues it, unless the tier was asked for by name;
 *  it begins at the orbit's start, if it serves there, for at the edge of such a region digits are lost. Where a smaller tier ends
 *  at a pole that the larger one passes, or an integral drifts in the smaller one alone, the larger one computes the orbit again.
 *
 *      JLT_TRY(jlt_course_create(&course, &plan, &question, &options));
 *      for (...) JLT_TRY(jlt_course_to(course, t, &row));          // times in one direction, row.end == JLT_END_TIME
 *
 *  Rows are the same in every tier, so that tiers can be compared: states at given times, drift of integrals, observed
 *  quantities. */
#ifndef JLT_SCENE_COURSE_H
#define JLT_SCENE_COURSE_H

#include "dynamics/section.h"
#include "integrate/orbit.h"
#include "kernel/instance.h"
#include "scene/plan.h"

typedef struct {
    const jlt_method *method;               /* NULL: the default */
    double tolerance;                       /* of the local error, relative to scale; 0: 1e-12 */
    size_t max_steps;                       /* of one call; 0: 10^7 */
    double t_last;                          /* the last time that will be asked for, in the table's unit; 0: unknown */
    bool project;                           /* after every step put the state back onto the start's levels of all integrals */
    const volatile sig_atomic_t *interrupt; /* may be NULL */
} jlt_course_options;

typedef struct {
    jlt_end end;              /* TIME; POLE: the orbit ends here; INTERRUPT: t was not reached */
    double t;                 /* in the table's unit, the start is at 0 */
    const double *x;          /* shape (states of the asked model,), the course's own, valid until the next call */
    const double *drift;      /* shape (integrals,): |F - F(start)|, relative as in course_drift.h */
    const double *observed;   /* shape (jlt_course_observes,): what the asked model's table observes; the course's own */
    double least;             /* least value since the start of the model's conditions (`valid` in its table), at ends of steps and,
                                 where one is broken, within steps; INFINITY: the model has no conditions */
    double lost_at;           /* time, up to t, at which a condition first broke; NaN: never */
    const char *lost;         /* the condition that broke then; NULL: none */
    double unknown_at;        /* first time, up to t, at which a condition had no value and none was broken; NaN: never */
    const char *unknown;      /* that condition; NULL: none */
    bool unwatched;           /* the motion besides quadratures could not be followed further */
    const double *more;       /* shape (jlt_course_tells_more,): with question.more, what a larger table adds, such as attitude and
                                 track; NULL: nothing; the course's own */
    jlt_fate fate;            /* POLE: at which end of an interval; LEFT_DOMAIN: the asked model has no poles, as the tier's has */
    unsigned pole;            /* POLE: the state that has reached an end of its interval, of a model that has poles */
    const char *unbounded;    /* after an error: the tier's state that grows without bound; NULL: none is known */
    double step;              /* BUDGET: the time that the last step took */
    bool stiff;               /* BUDGET: jlt_stepper_is_held, of that step */
    const char *edge;         /* DOMAIN: why the tier's coordinates end, for a message; the course's own */
} jlt_course_row;

typedef struct jlt_course jlt_course;

/** Create the course of the tier plan->chosen. Copies *question and *plan, with params and start; the descriptors they point to
 *  must outlive the course. Out: *out, NULL on failure. In: options, NULL: all defaults. Errors: ARG, the question has no start,
 *  or a tolerance outside [0, 1); UNSUPPORTED (no kernel, too many states, parameters or integrals), those of jlt_orbit_create and
 *  jlt_rod_open, NONFINITE, NOMEM. */
JLT_CHECKED jlt_status jlt_course_create(jlt_course **out, const jlt_plan *plan, const jlt_question *question,
                                         const jlt_course_options *options);
void jlt_course_destroy(jlt_course *self); /* NULL is legal */
JLT_OWNED_TYPE(jlt_course)

/** Advance to time t, in the table's unit; the start is at 0, and times must go in one direction. *row is filled whenever JLT_OK is
 *  returned. Errors: those of jlt_orbit_next; DOMAIN, the tier's coordinates end before t and no other tier serves: the row then
 *  holds the last point reached, or, if there is none, x is NULL, and lost_at and unknown_at are NaN; ARG, t turns back. */
JLT_CHECKED jlt_status jlt_course_to(jlt_course *self, double t, jlt_course_row *row);

/** The kernel that is integrated, bound to its parameters and levels; for quadratures, which integrate nothing, the asked
 *  model's. */
const jlt_instance *jlt_course_kernel(const jlt_course *self);

/** The number and the names of the integrals whose drifts rows have. */
unsigned jlt_course_integrals(const jlt_course *self);
const char *jlt_course_integral(const jlt_course *self, unsigned index);

/** How many quantities the asked model's table observes. Out: *quantities, shape (count,): their names, units and meanings. */
unsigned jlt_course_observes(const jlt_course *self, const jlt_quantity **quantities);

/** How many quantities row.more has: with question.more, the states and observed quantities of the first tier's table that the
 *  asked table does not have. Out: *quantities, unless NULL: shape (count,); *states, unless NULL: how many of them are states,
 *  which come first. After a change of tier they are NaN: the new tier begins at the asked model's states, which do not determine
 *  them. */
unsigned jlt_course_tells_more(const jlt_course *self, const jlt_quantity **quantities, unsigned *states);

/** The number of changes of tier; and of change number `index` its time, the names of the tiers before and after, and why the first
 *  one ended. */
unsigned jlt_course_changes(const jlt_course *self);
void jlt_course_change(const jlt_course *self, unsigned index, double *t, const char **from, const char **to, const char **why);

/** Steps and evaluations of the field from which states came so far; both 0 for quadratures, whose conditions alone are watched
 *  along an integrated motion. */
void jlt_course_cost(const jlt_course *self, size_t *steps, size_t *evaluations);

#endif
