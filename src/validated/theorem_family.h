/** Writes the sentences of a certificate about a family of equilibria, one per function. */
#ifndef JLT_VALIDATED_THEOREM_FAMILY_H
#define JLT_VALIDATED_THEOREM_FAMILY_H

#include "kernel_abi.h"

#include <jansson.h>
#include <stdio.h>

void jlt_theorem_family_setting(FILE *out, const jlt_descriptor *descriptor, const json_t *given, const json_t *shown);
void jlt_theorem_family_trace(FILE *out, const json_t *shown);
void jlt_theorem_family_measure(FILE *out);

#endif
