/** What a certificate starts from: a question about a cycle, with the boxes and the instants of the proof, all in exact numbers
 *  written as text.
 *
 *      "given": {
 *        "table": {"name": NAME, "sha256": DIGEST},
 *        "parameters": {NAME: NUMBER or {"middle": NUMBER, "radius": NUMBER}, ...},      all of the table
 *        "section": {"state": NAME, "value": NUMBER, "direction": 1 or -1},
 *        "levels": {INTEGRAL: NUMBER or a ball likewise, ...},
 *        "coordinates": [NAME, ...],                                                     on the levels
 *        "legs": [{"box": {NAME: {"middle": NUMBER, "radius": NUMBER}, ...},             states but the section's
 *                  "instant": NUMBER,                                                    from its start, near the next crossing
 *                  "turns": {NAME: N, ...}}, ...],                                       periods that states have grown by there,
 *                                                                                        not 0, as the table proves; absent: none
 *        "digits": N }
 *
 *  NUMBER is a string, a fraction or a decimal as numerals.h has them: its exact value is meant. Boxes are those that are written,
 *  with the orbit in them; legs take times > 0. N is 5 to JLT_GIVEN_DIGITS_MAX decimals to compute with. There are no other
 *  members. */
#ifndef JLT_VALIDATED_GIVEN_H
#define JLT_VALIDATED_GIVEN_H

#include "validated/given_legs.h"

typedef struct {
    jlt_cycle_question question; /* points into this object, which must not move */
    arb_ptr params, level_values;
    arb_t section;
    jlt_given_legs legs;
    const char *levels[JLT_FORMULAS_LEVELS_MAX]; /* of the descriptor */
    unsigned kept[JLT_CYCLE_STATES_MAX], kept_count;
} jlt_given;

enum { JLT_GIVEN_DIGITS_MAX = 1000 };

/** The general field, in its own time, of the table that is named: `own`, NULL for none, or one of those built in. NULL: there is
 *  none of this name and digest, and problem says so. */
const jlt_descriptor *jlt_given_table(const json_t *given, const jlt_descriptor *own, char problem[JLT_GIVEN_PROBLEM_MAX]);

/** Read a NUMBER, or a ball of two; false: it is neither. */
bool jlt_given_read_value(arb_t out, const json_t *value, slong bits);

/** Read "parameters": params, shape (param_count,). False: they are not those of the table, or not what it allows. */
bool jlt_given_read_params(arb_ptr params, const json_t *given, const jlt_descriptor *descriptor, slong bits,
                           char problem[JLT_GIVEN_PROBLEM_MAX]);

/** Read the question, all but coordinates and legs. Ends with jlt_given_clear in any case. False: it is not of this form,
 *  or outside what the table allows; problem says why. */
bool jlt_given_read(jlt_given *self, const json_t *given, const jlt_descriptor *descriptor, char problem[JLT_GIVEN_PROBLEM_MAX]);
void jlt_given_clear(jlt_given *self);

/** Read coordinates and legs as well, after jlt_given_read. False: as there. */
bool jlt_given_read_legs(jlt_given *self, const json_t *given, char problem[JLT_GIVEN_PROBLEM_MAX]);

/** Make coordinates and legs where there are none yet, in place of jlt_given_read_legs, from guesses: x, shape (legs, states),
 *  points on the section, T, shape (legs,), the times from each to the next, and turns, shape (legs, states), the periods by which
 *  states have grown there. They are refined by Newton's method, and boxes of this radius, in the units of the states, are put
 *  around them; radius 0: 1e-10, or, where parameters or levels are intervals, as far as orbits spread by these. Sets
 *  "coordinates" and "legs" of `given`.
 *  Errors: as jlt_cycle_create, jlt_cycle_choose, jlt_cycle_refine, jlt_cycle_reach; ARG, not 1 to JLT_CYCLE_LEGS_MAX legs;
 *  UNSUPPORTED, turns that the table does not prove, and problem says why; NOMEM. */
JLT_CHECKED jlt_status jlt_given_make_legs(jlt_given *self, json_t *given, unsigned legs, const double *x, const double *T,
                                           const int *turns, double radius, char problem[JLT_GIVEN_PROBLEM_MAX]);

#endif
