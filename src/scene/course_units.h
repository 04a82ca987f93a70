/** Units in which one motion is followed. */
#ifndef JLT_SCENE_COURSE_UNITS_H
#define JLT_SCENE_COURSE_UNITS_H

#include "scene/plan.h"

/** Units in which the parameters of the question and the rates of its motion are of the order of 1: the rates that the start tells, and
 *  those of the field where nothing moves. Those of the table, all zero, where terms of its equations, or what the chosen tier makes of
 *  its parameters, do not have the dimensions that are written beside them. question->start is not NULL.
 *  Errors: those of jlt_instance_create, jlt_tier_open. */
JLT_CHECKED jlt_status jlt_course_units(jlt_units *out, const jlt_plan *plan, const jlt_question *question);

#endif
