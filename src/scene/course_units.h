/** Chooses the units in which a motion is integrated, so that its numbers are of the order of 1. */
#ifndef JLT_SCENE_COURSE_UNITS_H
#define JLT_SCENE_COURSE_UNITS_H

#include "scene/plan.h"

/** Choose units in which the parameters of the question, its start and the rates there (at rest, the rates that states take on) are
 *  of the order of 1, as jlt_instance_units does. In: question->start, not NULL. Out: *out; all zeros, the table's own units, if no
 *  others serve, because a term in the asked table, the variant of it that serves, the chosen tier's table or a way between them
 *  does not have the dimension that the table's units give it, as where a variant sets a length to 1. Errors: those of
 *  jlt_instance_create, jlt_tier_open. */
JLT_CHECKED jlt_status jlt_course_units(jlt_units *out, const jlt_plan *plan, const jlt_question *question);

/** Whether a tier computes the same motion in these units as in the table's. Out: *serves is true if its parameters, its
 *  coordinates of x, and the states to which these lead back are the same, bit for bit after conversion, and its field scales
 *  (`scales` in its descriptor); and for the asked table itself. In: x, shape (states of the asked model,), and params, in the
 *  table's units. Errors: those of jlt_tier_open, except UNSUPPORTED in these units. */
JLT_CHECKED jlt_status jlt_course_units_serve(bool *serves, const jlt_tier *tier, const double *params, const double *x,
                                              const jlt_units *units);

#endif
