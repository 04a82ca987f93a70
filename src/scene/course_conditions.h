/** The conditions under which a model holds (`valid` in its table), as they are seen along a course. Used by course.c. */
#ifndef JLT_SCENE_COURSE_CONDITIONS_H
#define JLT_SCENE_COURSE_CONDITIONS_H

#include "kernel/observed.h"
#include "scene/leg.h"

typedef struct {
    jlt_observed *observed; /* of the asked model's states; owned */
    double least, lost_at;  /* as in course.h, in the course's units */
    const char *lost;       /* the condition, NULL: none */
    double unknown_at;
    const char *unknown;
} jlt_course_conditions;

/** Begin to watch the conditions of `model`. In: params, shape (param_count,), in the table's units; units, those of the states
 *  that will be looked at. Errors: those of jlt_observed_create. */
JLT_CHECKED jlt_status jlt_course_conditions_open(jlt_course_conditions *out, const jlt_descriptor *model, const double *params,
                                                  const jlt_units *units);
void jlt_course_conditions_close(jlt_course_conditions *self); /* legal on zeros */

/** Look at the conditions at time t in the state x, shape (states of the asked model,). Returns true where none is known to be
 *  broken but one has no value there; *unknown is its name then. */
bool jlt_course_conditions_note(jlt_course_conditions *self, const char **unknown, double t, const double *x);

/** Whether lost_at or unknown_at is a time at or before t, of a course that began at 0; NaN is none. */
bool jlt_course_conditions_by(double noted, double t);

/** Look within the last step of a leg for where a condition that holds at its start is broken first. Cost: for each condition 13
 *  values by methods with a polynomial of their own; by others two values and their slopes, and more where it comes near zero. */
void jlt_course_conditions_look_within(jlt_course_conditions *self, const jlt_leg *leg);

#endif
