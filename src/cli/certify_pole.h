/** Motions of a command line that end at a pole, as the beginning of a certificate. */
#ifndef JLT_CLI_CERTIFY_POLE_H
#define JLT_CLI_CERTIFY_POLE_H

#include "cli/common.h"

#include <jansson.h>

typedef struct {
    const char *start;             /* STATE=VALUE,..., all states */
    const jlt_assign_list *spread; /* radii of states and parameters; the others are numbers */
    size_t digits;
} jlt_certify_pole_options;

/** The question of validated/given_pole.h, with the pole and the instant at which the motions are found to settle. Out: *given, a
 *  new reference, NULL on failure. */
jlt_exit jlt_certify_pole(json_t **given, const jlt_certify_pole_options *options, const jlt_assign_list *set,
                          const jlt_descriptor *descriptor);

#endif
