/** The choice of units in which a motion is integrated, so that its numbers are of the order of 1. */
#ifndef JLT_SCENE_COURSE_UNITS_H
#define JLT_SCENE_COURSE_UNITS_H

#include "scene/plan.h"

/** Choose units in which the parameters of the question and the rates of its motion are of the order of 1; rates are those at the
 *  start, and those of the field where nothing moves. In: question->start, not NULL. Out: *out, all zeros for the table's own units
 *  where no others serve: a term of the equations, of the asked table, of the chosen tier or of the ways between them, does not
 *  have the dimension that the units in the table give it.
 *  Errors: those of jlt_instance_create, jlt_tier_open. */
JLT_CHECKED jlt_status jlt_course_units(jlt_units *out, const jlt_plan *plan, const jlt_question *question);

/** Whether a tier computes the same motion in these units as in the table's: its parameters and its coordinates of x come out the
 *  same, they lead back to x, and its field scales (`scales` of its descriptor). In: x, shape (states of the asked model,), and
 *  params, both in the table's units. Errors: those of jlt_tier_open, other than UNSUPPORTED in these units. */
JLT_CHECKED jlt_status jlt_course_units_serve(bool *serves, const jlt_tier *tier, const double *params, const double *x,
                                              const jlt_units *units);

#endif
