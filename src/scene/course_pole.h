/** Questions of a course about states at poles. Used by course.c. */
#ifndef JLT_SCENE_COURSE_POLE_H
#define JLT_SCENE_COURSE_POLE_H

#include "scene/course.h"
#include "scene/leg.h"

/** Whether x, in `units`, lies inside the intervals of the asked model. At a pole, or within rounding of one, conditions may have
 *  no value, which says nothing about the motion. */
bool jlt_course_pole_is_off(const double *x, const jlt_descriptor *model, const jlt_units *units);

/** Clamp states that have poles, of those of the asked model, into their intervals. If the orbit `ends` at a pole, put the state
 *  nearest to its pole exactly there, and set fate and pole of the row. In/out: states, in `units`. */
void jlt_course_pole_settle(jlt_course_row *row, double *states, const jlt_descriptor *model, const jlt_units *units, bool ends);

/** Whether an orbit, in a leg at its start, comes to the pole of a row at time t and goes away from it. Two tiers reach a true pole
 *  at times that differ, relative to t, by less than 1000 tolerances, or 1e-6 if that is more. In: t, in `units`; tolerance, 0: the
 *  default. */
bool jlt_course_pole_is_passed(jlt_leg *leg, const jlt_course_row *row, double t, const jlt_descriptor *model,
                               const jlt_units *units, double tolerance);

#endif
