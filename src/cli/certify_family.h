/** Makes the question of a certificate about a family of equilibria from a command line. */
#ifndef JLT_CLI_CERTIFY_FAMILY_H
#define JLT_CLI_CERTIFY_FAMILY_H

#include "cli/common.h"

#include <jansson.h>

typedef struct {
    const char *family; /* NULL: the table's only one */
    const char *box;    /* NAME=LOW:HIGH or NAME=VALUE, separated by commas; NULL: none */
    size_t limit, digits;
} jlt_certify_family_options;

/** Make the question, `given` in validated/given_family.h. Parameters and states have the exact values of --box and --set, else
 *  the table's defaults. Out: *given, a new reference, NULL on failure. */
jlt_exit jlt_certify_family(json_t **given, const jlt_certify_family_options *options, const jlt_assign_list *set,
                            const jlt_descriptor *descriptor);

#endif
