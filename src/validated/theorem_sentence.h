/** The sentences of theorems that stand in files of their own, theorem_family.c, theorem_pole.c and theorem_symmetry.c, and what
 *  writes their parts: theorem_text.c and theorem_turns.c. */
#ifndef JLT_VALIDATED_THEOREM_SENTENCE_H
#define JLT_VALIDATED_THEOREM_SENTENCE_H

#include "kernel_abi.h"

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

/** What a theorem is about; given and shown, as in certificates. */
typedef struct {
    const jlt_descriptor *descriptor;
    const json_t *given, *shown;
    const char *where; /* in words, where the model's conditions hold */
} jlt_theorem_subject;

/** A function that writes one sentence; it may write none. */
typedef void jlt_theorem_sentence(FILE *out, const jlt_theorem_subject *subject);

jlt_theorem_sentence jlt_theorem_family_setting, jlt_theorem_family_trace, jlt_theorem_family_measure, jlt_theorem_pole_setting,
    jlt_theorem_pole_end, jlt_theorem_pole_limits, jlt_theorem_symmetry_write, jlt_theorem_symmetry_write_twist;

/* Members of a certificate as they appear in its theorem; a member that is missing or not a text is written as "?". */

/** The text of a member; never NULL. */
const char *jlt_theorem_text(const json_t *value);
const char *jlt_theorem_text_of(const json_t *object, const char *key);

/** "MIDDLE +- RADIUS" of a ball; a text is written unchanged. */
void jlt_theorem_text_ball(FILE *out, const json_t *ball);

/** "NAME = BALL, ..." of an object of balls. */
void jlt_theorem_text_named(FILE *out, const json_t *values);

/** "STATE -> -STATE, ..." of an array of states that a reversor flips. */
void jlt_theorem_text_flips(FILE *out, const json_t *flipped);

/** These words, which are about levels; "" if no integral has its level given. */
const char *jlt_theorem_text_levels(const jlt_theorem_subject *subject, const char *words);

/* Phrases about the periods by which states have grown at the end of legs ("turns", see given.h). Uniqueness is claimed for these
 * numbers of each leg only. Nothing is written if no leg has turns. */

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
