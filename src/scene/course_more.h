/** What the table that is followed tells beyond the one asked about: its states and observed quantities of other names, such as
 *  attitude and track. A later leg begins at the asked table's states alone: what it would tell is no continuation. Used by
 *  course.c. */
#ifndef JLT_SCENE_COURSE_MORE_H
#define JLT_SCENE_COURSE_MORE_H

#include "kernel/observed.h"
#include "scene/leg.h"

typedef struct {
    jlt_observed *observed;   /* of the first leg's states; NULL: nothing is told; owned */
    const jlt_units *units;   /* those of the course; borrowed */
    unsigned states, count;   /* of the quantities; the first are states */
    jlt_quantity *quantities; /* (count,): owned */
    double *values;           /* (count,), in the table's units; owned */
    double *seen;             /* what its table observes; owned */
} jlt_course_more;

/** Whether a table observes what the asked one does not. NULL is legal. */
bool jlt_course_more_is_told(const jlt_descriptor *table, const jlt_descriptor *asked);

/** From now on of this leg, which must be open: the first is told of, at a later one telling ends. In and out: *self, zeros before
 *  the first. Errors: those of jlt_observed_create. */
JLT_CHECKED jlt_status jlt_course_more_follow(jlt_course_more *self, const jlt_leg *leg, const jlt_descriptor *asked,
                                              const jlt_units *units);
void jlt_course_more_close(jlt_course_more *self); /* legal on zeros */

/** Fill the values at the leg's states; NaN where nothing is told. */
void jlt_course_more_fill(jlt_course_more *self, const jlt_leg *leg);

#endif
