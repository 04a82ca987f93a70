/** What the table that is followed tells beyond the one asked about: its states and observed quantities of other names, such as attitude
 *  and track. Used by course.c. */
#ifndef JLT_SCENE_COURSE_MORE_H
#define JLT_SCENE_COURSE_MORE_H

#include "kernel/observed.h"
#include "scene/leg.h"

typedef struct {
    jlt_observed *observed;   /* of the leg's states; owned */
    const jlt_units *units;   /* those of the course; borrowed */
    unsigned states, count;   /* of the quantities; the first are states */
    jlt_quantity *quantities; /* (count,): those of the first leg; owned */
    double *values;           /* (count,), in the table's units; owned */
    double *seen;             /* what the leg's table observes; owned */
} jlt_course_more;

/** Whether a table observes what the asked one does not. NULL is legal. */
bool jlt_course_more_is_told(const jlt_descriptor *table, const jlt_descriptor *asked);

/** From now on of this leg, which must be open. In and out: *self, zeros before the first. Errors: those of jlt_observed_create. */
JLT_CHECKED jlt_status jlt_course_more_follow(jlt_course_more *self, const jlt_leg *leg, const jlt_descriptor *asked, const jlt_units *units);
void jlt_course_more_close(jlt_course_more *self); /* legal on zeros */

/** Fill the values at the leg's states; NaN for what its table does not tell. */
void jlt_course_more_fill(jlt_course_more *self, const jlt_leg *leg);

#endif
