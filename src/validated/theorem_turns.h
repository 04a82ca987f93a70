/** What the theorem of an orbit says of periods by which states have grown where its legs end ("turns", see given.h). What is
 *  unique is unique for these numbers of each leg: other ones are other equations. Nothing is written where no leg has any. */
#ifndef JLT_VALIDATED_THEOREM_TURNS_H
#define JLT_VALIDATED_THEOREM_TURNS_H

#include "kernel_abi.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

bool jlt_theorem_turns_any(const json_t *legs, const jlt_descriptor *descriptor);

/** ", but for STATE having grown by N periods of P," over all legs. */
void jlt_theorem_turns_write_all(FILE *out, const json_t *legs, const jlt_descriptor *descriptor);

/** " but for these periods: STATE N and STATE N at the end of leg I, ...", of each leg that has some. */
void jlt_theorem_turns_write_legs(FILE *out, const json_t *legs, const jlt_descriptor *descriptor);

/** What else there may be, and in which sense points are one. */
void jlt_theorem_turns_write_sense(FILE *out, const json_t *legs, const jlt_descriptor *descriptor);

/** "FIRSTwith the period P in STATELAST", of densities. */
void jlt_theorem_turns_write_density(FILE *out, const char *first, const json_t *legs, const jlt_descriptor *descriptor,
                                     const char *last);

#endif
