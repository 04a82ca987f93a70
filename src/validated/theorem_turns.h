/** Writes the phrases of a theorem about the periods by which states have grown at the end of legs ("turns", see given.h).
 *  Uniqueness is claimed for these numbers of each leg only. Nothing is written if no leg has turns. */
#ifndef JLT_VALIDATED_THEOREM_TURNS_H
#define JLT_VALIDATED_THEOREM_TURNS_H

#include "kernel_abi.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

bool jlt_theorem_turns_any(const json_t *legs, const jlt_descriptor *descriptor);

/** ", but for STATE having grown by N periods of P," over all legs. */
void jlt_theorem_turns_write_all(FILE *out, const json_t *legs, const jlt_descriptor *descriptor);

/** " but for these periods: STATE N and STATE N at the end of leg I, ...", for each leg that has turns. */
void jlt_theorem_turns_write_legs(FILE *out, const json_t *legs, const jlt_descriptor *descriptor);

/** Says that orbits with other numbers of periods are not excluded, and that points which differ by periods are identified. */
void jlt_theorem_turns_write_sense(FILE *out, const json_t *legs, const jlt_descriptor *descriptor);

/** "FIRSTwith the period P in STATELAST", for densities. */
void jlt_theorem_turns_write_density(FILE *out, const char *first, const json_t *legs, const jlt_descriptor *descriptor,
                                     const char *last);

#endif
