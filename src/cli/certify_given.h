/** Makes the question of a certificate about an orbit on a section from a command line, with the exact values of what was typed and
 *  of the tables' defaults. */
#ifndef JLT_CLI_CERTIFY_GIVEN_H
#define JLT_CLI_CERTIFY_GIVEN_H

#include "cli/motion.h"

#include <jansson.h>

/** Make the question, `given` in validated/given.h without coordinates and legs, about this system's table. spread: radii, > 0, of
 *  the intervals that parameters and levels are to run over; may be empty. Out: *given, a new reference, NULL on failure; *of, that
 *  table's general field in its own time. */
jlt_exit jlt_certify_given(json_t **given, const jlt_descriptor **of, const jlt_motion_options *options, const jlt_system *system,
                           const jlt_assign_list *spread, unsigned digits);

#endif
