/** Prints a plan: the models that could answer, from the smallest up, which one does, and why. */
#ifndef JLT_CLI_PLANNED_H
#define JLT_CLI_PLANNED_H

#include "cli/motion.h"
#include "scene/plan.h"

/** Print a line for each candidate: a mark on the chosen one, its kernel with the operation count of its right-hand side, and why
 *  it is taken or not. why: the reason to print for the chosen one; NULL: the plan's own. */
void jlt_planned_show(const jlt_plan *plan, const char *why);

/** Print the line of the chosen candidate alone. */
void jlt_planned_chosen(const jlt_plan *plan);

/** Print the plan of a command on a section: the candidates, the section with its levels and which of these
 *  are proved integrals, where orbits begin, and which method follows them. Returns JLT_EXIT_PLANNED on success. */
jlt_exit jlt_planned_motion(const jlt_system *system, const jlt_motion_options *options);

/** Print why no tier can answer the question, after jlt_plan_make returned this status: ARG, there is no tier of the name asked
 *  for; UNSUPPORTED, no tier serves, or not the one asked for. show: print the candidates first. */
jlt_exit jlt_planned_refuse(const jlt_plan *plan, const jlt_question *question, jlt_status status, bool show);

#endif
