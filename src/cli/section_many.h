/** Many orbits at once, of `jellett section --batch`. */
#ifndef JLT_CLI_SECTION_MANY_H
#define JLT_CLI_SECTION_MANY_H

#include "cli/motion.h"
#include "dynamics/section_batch.h"

/** The batch that follows them; project: back onto their integrals, which becomes a part of the options. Says what stands against it,
 *  and what to do instead. */
jlt_exit jlt_section_many_open(jlt_section_batch **batch, jlt_section_batch_options *options, const jlt_system *system, bool project);

/** A line for headers and plans: `before`, the batch's method, instruction set and lanes, and what follows orbits near a pole. */
void jlt_section_many_line(FILE *file, const char *before, const jlt_motion_options *options, const jlt_system *system, bool project);

#endif
