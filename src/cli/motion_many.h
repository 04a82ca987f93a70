/** For commands that follow many orbits at once, several in the lanes of one vector and on several threads. The calls, in order:
 *  jlt_motion_many_begin, ttc_options_parse, jlt_motion_many_choose, jlt_motion_system, jlt_motion_many_settle,
 *  jlt_motion_many_open. */
#ifndef JLT_CLI_MOTION_MANY_H
#define JLT_CLI_MOTION_MANY_H

#include "cli/motion.h"
#include "dynamics/section_batch.h"

/* The parser of --threads, to be named as a child; its input is a jlt_motion_options. */
extern const struct argp jlt_motion_many_argp;

/** Set defaults, after jlt_motion_begin: all processors, and no method named. */
void jlt_motion_many_begin(jlt_motion_options *options);

/** Tell whether the command follows many orbits, and whether it puts them back onto the levels of their integrals. Many orbits are
 *  followed in lanes unless --method was given, which follows them one at a time. */
void jlt_motion_many_choose(jlt_motion_options *options, bool many, bool project);

/** Decide whether lanes follow the orbits of this system. Sets options->in_lanes, and options->alone to the reason why they cannot,
 *  or to NULL. */
void jlt_motion_many_settle(jlt_motion_options *options, const jlt_system *system);

/** Create the batch that follows orbits of `system`. In/out: batch_options, in which threads and projection are set here. Out:
 *  *batch, for jlt_section_batch_destroy. */
jlt_exit jlt_motion_many_open(jlt_section_batch **batch, jlt_section_batch_options *batch_options,
                              const jlt_motion_options *options, jlt_system *system);

/** Write a line for headers and plans, with `before` in front: which method follows the orbits, with which instruction set and how
 *  many lanes, and which method takes over near a pole; or why orbits are followed one at a time. Writes nothing for a single
 *  orbit, or if --method was given. */
void jlt_motion_many_line(FILE *file, const char *before, const jlt_motion_options *options, const jlt_system *system);

#endif
