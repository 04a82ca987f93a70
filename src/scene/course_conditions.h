/** Watches the conditions under which a model holds (`valid` in its table) along a course. Used by course.c. */
#ifndef JLT_SCENE_COURSE_CONDITIONS_H
#define JLT_SCENE_COURSE_CONDITIONS_H

#include "kernel/observed.h"
#include "scene/leg.h"

typedef struct {
    jlt_observed *observed; /* of the asked model's states; owned */
    double least, lost_at;  /* as in course.h, in the course's units */
    const char *lost;       /* the condition that broke; NULL: none */
    double unknown_at;
    const char *unknown;
    bool unwatched;
} jlt_course_conditions;

/** Begin to watch the conditions of `model`. In: params, shape (param_count,), in the table's units; units, those in which states
 *  will be given. In/out: *out, all zeros before. Errors: those of jlt_observed_create. */
JLT_CHECKED jlt_status jlt_course_conditions_open(jlt_course_conditions *out, const jlt_descriptor *model, const double *params,
                                                  const jlt_units *units);

/** Forget what was noted: the course begins again. */
void jlt_course_conditions_again(jlt_course_conditions *self);
void jlt_course_conditions_close(jlt_course_conditions *self); /* legal on zeros */

/** Evaluate the conditions at time t in the state x, shape (states of the asked model,). Returns true if none is known to be broken
 *  there but one has no value; *unknown is then its name. */
bool jlt_course_conditions_note(jlt_course_conditions *self, const char **unknown, double t, const double *x);

/** Watch no longer than to time t, beyond which the motion besides quadratures cannot be followed: if all conditions hold up to
 *  there, it is not known whether they hold from there on. */
void jlt_course_conditions_stop(jlt_course_conditions *self, double t);

/** Whether `noted`, which is lost_at or unknown_at, is at or before time t of a course that began at 0. Returns false for NaN. */
bool jlt_course_conditions_by(double noted, double t);

/** Find, within the last step of a leg, where a condition that holds at its start breaks first; updates least, lost_at and lost.
 *  Cost: for each condition two values and those of jlt_loss_first (integrate/loss.h); where it is broken and falls, 150 values. */
void jlt_course_conditions_look_within(jlt_course_conditions *self, const jlt_leg *leg);

#endif
