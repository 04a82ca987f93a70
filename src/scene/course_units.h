/** Units in which one motion is followed. */
#ifndef JLT_SCENE_COURSE_UNITS_H
#define JLT_SCENE_COURSE_UNITS_H

#include "scene/plan.h"

/** Units in which the parameters of the question and the rates of its motion are of the order of 1: the rates that the start tells, and
 *  those of the field where nothing moves. Those of the table, all zero, where terms of its equations, or of those
 *  of the chosen tier, or what leads to it and back, do not have the dimensions that are written beside them. question->start is not NULL.
 *  Errors: those of jlt_instance_create, jlt_tier_open. */
JLT_CHECKED jlt_status jlt_course_units(jlt_units *out, const jlt_plan *plan, const jlt_question *question);

/** Whether a tier is the same in these units: from x, shape (states of the asked model,), with params, both in the table's units, it serves
 *  with the parameters and coordinates that it has in the table's, they lead back to the same, and its field scales
 *  (jlt_instance_scales). Errors: those of jlt_tier_open, other than UNSUPPORTED in these units. */
JLT_CHECKED jlt_status jlt_course_units_serve(bool *serves, const jlt_tier *tier, const double *params, const double *x,
                                              const jlt_units *units);

#endif
