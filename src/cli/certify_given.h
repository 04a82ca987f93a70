/** Makes the question of a certificate about an orbit on a section from a command line, with the exact values of what was typed and
 *  of the tables' defaults. */
#ifndef JLT_CLI_CERTIFY_GIVEN_H
#define JLT_CLI_CERTIFY_GIVEN_H

#include "cli/motion.h"
#include "cli/progress.h"
#include "validated/step.h"

#include <jansson.h>

/** Make the question, `given` in validated/given.h without coordinates and legs, about this system's table. spread: radii, > 0, of
 *  the intervals that parameters and levels are to run over; may be empty. Out: *given, a new reference, NULL on failure; *of, that
 *  table's general field in its own time. */
jlt_exit jlt_certify_given(json_t **given, const jlt_descriptor **of, const jlt_motion_options *options, const jlt_system *system,
                           const jlt_assign_list *spread, unsigned digits);

/** Begin to show the steps of proofs on standard error; end with jlt_progress_end. */
jlt_step_watch jlt_certify_watch(jlt_progress *progress);

/** The exact default of a parameter in a table's text; NULL if it has none. The caller must free() it. */
char *jlt_certify_default(const char *table, const char *name);

/** Put the value `text`, which is freed, into `object` at `key`: as a ball if `spread` has a radius for `name`, else as a
 *  number. */
jlt_exit jlt_certify_put(json_t *object, const char *key, const char *name, char *text, const jlt_assign_list *spread);

/** Refuse radii that are not positive, or whose name is in neither object. what: what `others` has, for the message. */
jlt_exit jlt_certify_check_spread(const jlt_assign_list *spread, const json_t *params, const json_t *others, const char *what);

#endif
