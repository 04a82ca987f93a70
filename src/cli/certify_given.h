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

/** The default of a parameter in a table's text, exactly; NULL: it has none. For the caller to free(). */
char *jlt_certify_default(const char *table, const char *name);

/** Put the value `text`, which is freed, into `object` at `key`: a number, or a ball where `spread` has a radius for `name`. */
jlt_exit jlt_certify_put(json_t *object, const char *key, const char *name, char *text, const jlt_assign_list *spread);

/** Refuse a radius that is not > 0, or of a name in neither object. what: of the second one, for the message. */
jlt_exit jlt_certify_check_spread(const jlt_assign_list *spread, const json_t *params, const json_t *others, const char *what);

#endif
