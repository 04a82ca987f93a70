/** How far a course's integrals have moved from their values at its start. Used by course.c. */
#ifndef JLT_SCENE_COURSE_DRIFT_H
#define JLT_SCENE_COURSE_DRIFT_H

#include "kernel/instance.h"

#define JLT_COURSE_DRIFT_MAX 8

typedef struct {
    const jlt_instance *watch; /* whose integrals these are; borrowed */
    unsigned count;            /* the leading ones, at most JLT_COURSE_DRIFT_MAX; 0: the table has no kernel of them */
    double first[JLT_COURSE_DRIFT_MAX], size[JLT_COURSE_DRIFT_MAX];
    double value[JLT_COURSE_DRIFT_MAX]; /* |F - F(start)|/size, at the state last noted */
} jlt_course_drift;

/** Begin at x, shape (states of the instance,), in its units. The size of an integral is max(|F(x)|, min(1, s)): s is what F
 *  changes by where every state changes by the largest |x_j|, so that what a small motion loses is not told against 1.
 *  Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_course_drift_begin(jlt_course_drift *out, const jlt_instance *watch, const double *x);

/** Note the integrals at x. */
void jlt_course_drift_note(jlt_course_drift *self, const double *x);

#endif
