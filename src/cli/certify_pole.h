/** Turns the command line of `jellett certify pole` into the question of a certificate. */
#ifndef JLT_CLI_CERTIFY_POLE_H
#define JLT_CLI_CERTIFY_POLE_H

#include "cli/common.h"
#include "validated/step.h"

#include <jansson.h>

typedef struct {
    const char *start;             /* STATE=VALUE,..., all states */
    const jlt_assign_list *spread; /* radii of states and parameters; those without one are numbers */
    size_t digits;
    jlt_step_watch *watch; /* is called after the steps of the proof */
} jlt_certify_pole_options;

/** Make `given` of validated/given_pole.h: exact values as typed, the pole at which the motions end, and an instant from which they
 *  are shown to settle. Out: *given, a new reference, NULL on failure. Prints what is wrong. */
jlt_exit jlt_certify_pole(json_t **given, const jlt_certify_pole_options *options, const jlt_assign_list *set,
                          const jlt_descriptor *descriptor);

#endif
