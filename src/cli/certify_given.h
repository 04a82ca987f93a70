/** A section's system of a command line as the beginning of a certificate: exact values of what was typed, and of the tables'
 *  defaults. */
#ifndef JLT_CLI_CERTIFY_GIVEN_H
#define JLT_CLI_CERTIFY_GIVEN_H

#include "cli/motion.h"

#include <jansson.h>

/** The question of `given` (validated/given.h) about this system's table; *of, that table's general field in its own time. spread:
 *  parameters and levels with the radius of the interval that they are to run over, or empty. Out: *given, a
 *  new reference, NULL on failure. */
jlt_exit jlt_certify_given(json_t **given, const jlt_descriptor **of, const jlt_motion_options *options, const jlt_system *system,
                           const jlt_assign_list *spread, unsigned digits);

#endif
