/** The part of `ttc prove` that challenges verdicts. */
#ifndef TTC_COMMAND_CHALLENGE_H
#define TTC_COMMAND_CHALLENGE_H

#include "command/command.h"
#include "prove/prove.h"

#include <jansson.h>

/** Challenge the verdicts; results go to stdout or, if that is not NULL, into the JSON object `shown`, contradictions to stderr as
 *  well. Returns TTC_EXIT_DONE, TTC_EXIT_INTERNAL, or TTC_EXIT_MEMORY. */
int ttc_command_challenge(const ttc_model *model, const ttc_proof_report *proofs, const ttc_options *options, json_t *shown);

#endif
