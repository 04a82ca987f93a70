/** Commands that follow many orbits: in lanes of vectors and on threads. */
#ifndef JLT_CLI_MOTION_MANY_H
#define JLT_CLI_MOTION_MANY_H

#include "cli/motion.h"
#include "dynamics/section_batch.h"

/* Child parser of --threads, with a jlt_motion_options for input. */
extern const struct argp jlt_motion_many_argp;

/** Before argp_parse, after jlt_motion_begin: all processors, and no method named. */
void jlt_motion_many_begin(jlt_motion_options *options);

/** After argp_parse, before jlt_motion_system: whether many orbits are followed, and put back onto their integrals. They go in lanes, unless
 *  --method names a method, which follows each alone. */
void jlt_motion_many_choose(jlt_motion_options *options, bool many, bool project);

/** Whether lanes serve for the system, of jlt_motion_system. */
void jlt_motion_many_settle(jlt_motion_options *options, const jlt_system *system);

/** What follows the orbits of `system`; what `batch_options` says of threads and projection is set here. Says what stands against it. */
jlt_exit jlt_motion_many_open(jlt_section_batch **batch, jlt_section_batch_options *batch_options, const jlt_motion_options *options,
                              jlt_system *system);

/** A line for headers and plans, `before` in front: method, instruction set and lanes, and what follows orbits near a pole; or why orbits
 *  go one at a time. Nothing for one orbit, and where the method was named. */
void jlt_motion_many_line(FILE *file, const char *before, const jlt_motion_options *options, const jlt_system *system);

#endif
