/** The sentences of certificates of kind `pole`. */
#ifndef JLT_VALIDATED_THEOREM_POLE_H
#define JLT_VALIDATED_THEOREM_POLE_H

#include "kernel_abi.h"

#include <jansson.h>
#include <stdio.h>

void jlt_theorem_pole_setting(FILE *out, const jlt_descriptor *descriptor, const json_t *given);
void jlt_theorem_pole_end(FILE *out, const jlt_descriptor *descriptor, const json_t *given, const json_t *shown);
void jlt_theorem_pole_limits(FILE *out, const json_t *shown);

#endif
