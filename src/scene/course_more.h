/** What the table that is integrated tells beyond the one asked about: those of its states and observed quantities that the asked
 *  table has not, such as attitude and track. Only the first leg of a course tells them, since a later one begins at the asked
 *  table's states alone, which do not continue them. Used by course.c. */
#ifndef JLT_SCENE_COURSE_MORE_H
#define JLT_SCENE_COURSE_MORE_H

#include "kernel/observed.h"
#include "scene/leg.h"

typedef struct {
    jlt_observed *observed;   /* computed from the first leg's states; NULL: nothing is told; owned */
    const jlt_units *units;   /* those of the course; borrowed */
    unsigned states, count;   /* how many quantities there are, and how many of them are states, which come first */
    jlt_quantity *quantities; /* (count,): owned */
    double *values;           /* (count,), in the table's units; owned */
    double *seen;             /* room for all that its table observes; owned */
} jlt_course_more;

/** Whether a table observes what the asked one does not. NULL is legal. */
bool jlt_course_more_is_told(const jlt_descriptor *table, const jlt_descriptor *asked);

/** Go over to this leg, which must be open: the first leg's quantities are told, at a later one they become NaN. In/out: *self, all
 *  zeros before the first. Errors: those of jlt_observed_create. */
JLT_CHECKED jlt_status jlt_course_more_follow(jlt_course_more *self, const jlt_leg *leg, const jlt_descriptor *asked,
                                              const jlt_units *units);
void jlt_course_more_close(jlt_course_more *self); /* legal on zeros */

/** Fill the values at the leg's states; NaN where nothing is told. */
void jlt_course_more_fill(jlt_course_more *self, const jlt_leg *leg);

#endif
