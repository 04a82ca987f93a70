/** A family of equilibria of a command line as the beginning of a certificate. */
#ifndef JLT_CLI_CERTIFY_FAMILY_H
#define JLT_CLI_CERTIFY_FAMILY_H

#include "cli/common.h"

#include <jansson.h>

typedef struct {
    const char *family; /* NULL: the table's only one */
    const char *box;    /* NAME=LOW:HIGH or NAME=VALUE, separated by commas; NULL: none */
    size_t limit, digits;
} jlt_certify_family_options;

/** The question of validated/given_family.h: values of the box, then those of --set, then the table's defaults, exactly. Out:
 *  *given, a new reference, NULL on failure. */
jlt_exit jlt_certify_family(json_t **given, const jlt_certify_family_options *options, const jlt_assign_list *set,
                            const jlt_descriptor *descriptor);

#endif
