/** Measures how far a course's integrals have drifted from their values at its start. Used by course.c. */
#ifndef JLT_SCENE_COURSE_DRIFT_H
#define JLT_SCENE_COURSE_DRIFT_H

#include "integrate/orbit.h"
#include "kernel/instance.h"
#include "scene/leg.h"
#include "scene/plan.h"

typedef struct {
    const jlt_instance *watch; /* the kernel whose integrals are watched; borrowed */
    unsigned count;            /* its integrals; 0: it has no kernel for them */
    double first[JLT_PLAN_STATES_MAX], size[JLT_PLAN_STATES_MAX]; /* F(start) and the size of F */
    double value[JLT_PLAN_STATES_MAX]; /* |F - F(start)|/size at the last noted state */
} jlt_course_drift;

/** Begin at x, shape (states of the instance,), in its units; it has at most JLT_PLAN_STATES_MAX integrals. The size of an integral
 *  is max(|F(x)|, min(1, s)), where s = (sum_j |dF/dx_j|) max_j |x_j|, so that the drift of a small motion is not measured against
 *  1. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_course_drift_begin(jlt_course_drift *out, const jlt_instance *watch, const double *x);

/** Set `value` from the integrals at x. */
void jlt_course_drift_note(jlt_course_drift *self, const double *x);

/** Whether an integral has drifted by more than a hundred errors of one tolerance, and random errors at all steps, explain: as
 *  where a tier divides by a quantity that is 0 up to rounding. In: tier, its name; tolerance, 0: the default. Out: text, shape
 *  (JLT_TIER_TEXT_MAX,): what has drifted. */
bool jlt_course_drift_tells(char *text, const jlt_course_drift *self, const char *tier, const jlt_orbit *orbit, double tolerance);

/** Whether a leg, at its start, comes to time t with at most a tenth of the largest drift. */
bool jlt_course_drift_is_less(const jlt_course_drift *self, jlt_leg *leg, double t);

#endif
