/** The sentences of theorems that stand in files of their own: theorem_family.c, theorem_pole.c and theorem_symmetry.c. */
#ifndef JLT_VALIDATED_THEOREM_SENTENCE_H
#define JLT_VALIDATED_THEOREM_SENTENCE_H

#include "kernel_abi.h"

#include <jansson.h>
#include <stdio.h>

/** What a theorem is about; given and shown, as in certificates. */
typedef struct {
    const jlt_descriptor *descriptor;
    const json_t *given, *shown;
} jlt_theorem_subject;

/** A function that writes one sentence; it may write none. */
typedef void jlt_theorem_sentence(FILE *out, const jlt_theorem_subject *subject);

jlt_theorem_sentence jlt_theorem_family_setting, jlt_theorem_family_trace, jlt_theorem_family_measure, jlt_theorem_pole_setting,
    jlt_theorem_pole_end, jlt_theorem_pole_limits, jlt_theorem_symmetry_write, jlt_theorem_symmetry_write_twist;

#endif
