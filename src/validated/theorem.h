/** Writes the theorem of a certificate in words. */
#ifndef JLT_VALIDATED_THEOREM_H
#define JLT_VALIDATED_THEOREM_H

#include "validated/given.h"

/** The sentences of the theorem, an array of strings; a new reference, NULL if memory is out. In: kind, one of certificate.h;
 *  given and shown, as in certificates. */
json_t *jlt_theorem_words(const char *kind, const jlt_descriptor *descriptor, const json_t *given, const json_t *shown);

/** Whether certificates of this kind are known. */
bool jlt_theorem_is_kind(const char *kind);

/** The first reversor that is proved without a condition, and that changes signs of states and nothing else; it maps attracting
 *  orbits to repelling ones. NULL if the table has none. */
const jlt_reversor *jlt_theorem_reversor(const jlt_descriptor *descriptor);

/** Whether a reversor of the table is proved without a condition. */
bool jlt_theorem_is_proved(const jlt_descriptor *descriptor, const jlt_reversor *reversor);

/** The proved reversor that flips exactly these states, an array of names in the table's order; NULL if the table has none. */
const jlt_reversor *jlt_theorem_reversor_of(const jlt_descriptor *descriptor, const json_t *flipped);

/** The names of the states that a reversor flips; a new reference, NULL if memory is out. */
json_t *jlt_theorem_flipped(const jlt_descriptor *descriptor, const jlt_reversor *reversor);

#endif
