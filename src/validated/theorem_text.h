/** Writes members of a certificate as they appear in its theorem; a member that is missing or no text is written as "?". */
#ifndef JLT_VALIDATED_THEOREM_TEXT_H
#define JLT_VALIDATED_THEOREM_TEXT_H

#include <jansson.h>
#include <stdio.h>

/** The text of a member; never NULL. */
const char *jlt_theorem_text(const json_t *value);
const char *jlt_theorem_text_of(const json_t *object, const char *key);

/** "MIDDLE +- RADIUS" of a ball; a text is written unchanged. */
void jlt_theorem_text_ball(FILE *out, const json_t *ball);

/** "NAME = BALL, ..." of an object of balls. */
void jlt_theorem_text_named(FILE *out, const json_t *values);

/** "STATE -> -STATE, ..." of an array of states that a reversor flips. */
void jlt_theorem_text_flips(FILE *out, const json_t *flipped);

#endif
