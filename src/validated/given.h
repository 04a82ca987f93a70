/** What a certificate starts from: a question about a cycle, with the box and the instant of the proof, all in exact numbers
 *  written as text.
 *
 *      "given": {
 *        "table": {"name": NAME, "sha256": DIGEST},
 *        "parameters": {NAME: NUMBER or {"middle": NUMBER, "radius": NUMBER}, ...},      all of the table
 *        "section": {"state": NAME, "value": NUMBER, "direction": 1 or -1},
 *        "levels": {INTEGRAL: NUMBER or a ball likewise, ...},
 *        "coordinates": [NAME, ...],                                                     on the levels
 *        "box": {NAME: {"middle": NUMBER, "radius": NUMBER}, ...},                       states but the section's
 *        "instant": NUMBER, "digits": N }
 *
 *  NUMBER is a string, "p/q" or a decimal: its exact value is meant. */
#ifndef JLT_VALIDATED_GIVEN_H
#define JLT_VALIDATED_GIVEN_H

#include "validated/cycle.h"

#include <jansson.h>

typedef struct {
    jlt_cycle_question question; /* points into this object, which must not move */
    arb_ptr params, box, level_values;
    arb_t section;
    arf_t instant;
    const char *levels[JLT_FORMULAS_LEVELS_MAX]; /* of the descriptor */
    unsigned kept[JLT_CYCLE_STATES_MAX], kept_count;
} jlt_given;

enum { JLT_GIVEN_PROBLEM_MAX = 256, JLT_GIVEN_DIGITS_MAX = 1000 };

/** The general field, in its own time, of the table that is named, among `own`, NULL for none, and those built in; NULL: there is
 *  none of this digest, and problem says so. */
const jlt_descriptor *jlt_given_table(const json_t *given, const jlt_descriptor *own, char problem[JLT_GIVEN_PROBLEM_MAX]);

/** Read the question, all but coordinates, box and instant. Ends with jlt_given_clear in any case. False: it is not of this form,
 *  or outside what the table allows; problem says why. */
bool jlt_given_read(jlt_given *self, const json_t *given, const jlt_descriptor *descriptor, char problem[JLT_GIVEN_PROBLEM_MAX]);
void jlt_given_clear(jlt_given *self);

/** Then the rest. */
bool jlt_given_read_box(jlt_given *self, const json_t *given, char problem[JLT_GIVEN_PROBLEM_MAX]);

/** Where there is no rest yet, make it, from a guess x, shape (states,), of a point on the section, and of the time T after which
 *  the orbit is back there: refined by Newton's method, with a box of this radius around. Sets "coordinates", "box" and "instant"
 *  of `given`. Errors: as jlt_cycle_create, jlt_cycle_choose, jlt_cycle_refine. */
JLT_CHECKED jlt_status jlt_given_make_box(jlt_given *self, json_t *given, const double *x, double T, double radius);

/** One NUMBER, rounded outwards to so many bits; false: it is none. */
bool jlt_given_number(arb_t out, const char *text, slong bits);

/** {"middle": NUMBER, "radius": NUMBER}, as the least ball that surely holds it. */
bool jlt_given_ball(arb_t out, const json_t *ball, slong bits);

#endif
