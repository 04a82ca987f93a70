/** Prints a plan: the models that could answer, from the smallest up, which one does, and why. */
#ifndef JLT_CLI_PLANNED_H
#define JLT_CLI_PLANNED_H

#include "cli/motion.h"
#include "scene/plan.h"

/** A line for each candidate: the chosen one marked, its kernel with the operations of one call of its right-hand side, and the
 *  reason. */
/* why: the chosen one is taken; NULL: as the plan has it. */
void jlt_planned_show(const jlt_plan *plan, const char *why);

/** The line of the chosen one alone. */
void jlt_planned_chosen(const jlt_plan *plan);

/** For a command on a section of `asked`: the candidates, the section with its levels, and what is proved of these; where orbits
 *  begin, and by what they are followed. Returns JLT_EXIT_PLANNED, or what is wrong. */
jlt_exit jlt_planned_motion(const jlt_system *system, const jlt_motion_options *options, const jlt_descriptor *asked);

#endif
