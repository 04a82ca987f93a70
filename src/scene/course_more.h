/** The quantities that the integrated table adds to the one asked for: those of its states and observed quantities that the asked
 *  table does not have, such as attitude and track. They are known on the first leg of a course only: a later leg begins at the
 *  asked table's states, which do not determine them. Used by course.c. */
#ifndef JLT_SCENE_COURSE_MORE_H
#define JLT_SCENE_COURSE_MORE_H

#include "kernel/observed.h"
#include "scene/leg.h"

typedef struct {
    jlt_observed *observed;   /* what the first leg's table observes; NULL: there is no first leg, or it has ended; owned */
    const jlt_units *units;   /* those of the course; borrowed */
    unsigned states, count;   /* the number of quantities, `count`, of which the first `states` are states */
    jlt_quantity *quantities; /* (count,): owned */
    double *values;           /* (count,), in the table's units; owned */
    double *seen;             /* room for everything that its table observes; owned */
} jlt_course_more;

/** Whether a table has more states than the asked one, or observes a quantity that that one does not. False if table is NULL. */
bool jlt_course_more_is_told(const jlt_descriptor *table, const jlt_descriptor *asked);

/** Go on to this leg, which must be open: at the first leg choose the quantities; at a later leg their values become NaN. In/out:
 *  *self, all zeros before the first call. Errors: those of jlt_observed_create. */
JLT_CHECKED jlt_status jlt_course_more_follow(jlt_course_more *self, const jlt_leg *leg, const jlt_descriptor *asked,
                                              const jlt_units *units);
void jlt_course_more_close(jlt_course_more *self); /* legal on zeros */

/** Fill the values from the leg's states; NaN after the first leg. */
void jlt_course_more_fill(jlt_course_more *self, const jlt_leg *leg);

#endif
