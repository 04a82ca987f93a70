/** Reads and makes the input of a certificate: a question about a cycle, with the boxes and instants of the proof, all in exact
 *  numbers written as text.
 *
 *      "given": {
 *        "table": {"name": NAME, "sha256": DIGEST},
 *        "parameters": {NAME: NUMBER or {"middle": NUMBER, "radius": NUMBER}, ...},      all parameters of the table
 *        "section": {"state": NAME, "value": NUMBER, "direction": 1 or -1},
 *        "levels": {INTEGRAL: NUMBER or a ball likewise, ...},
 *        "coordinates": [NAME, ...],                                                     coordinates on the levels
 *        "legs": [{"box": {NAME: {"middle": NUMBER, "radius": NUMBER}, ...},             all states but the section's
 *                  "instant": NUMBER,                                                    time to near the next crossing
 *                  "turns": {NAME: N, ...}}, ...],                                       proved periods that states have grown
 *                                                                                        by at its end, not 0; absent: none
 *        "digits": N }
 *
 *  NUMBER is a string, a fraction or a decimal as in numerals.h, and means its exact value. Boxes are taken as they are written,
 *  and contain the orbit; legs take positive times. The N of "digits", 5 to JLT_GIVEN_DIGITS_MAX, is the number of decimals to
 *  compute with. There are no other members. */
#ifndef JLT_VALIDATED_GIVEN_H
#define JLT_VALIDATED_GIVEN_H

#include "validated/given_legs.h"

typedef struct {
    jlt_cycle_question question; /* points into this object, which must not be moved */
    arb_ptr params, level_values;
    arb_t section;
    jlt_given_legs legs;
    const char *levels[JLT_FORMULAS_LEVELS_MAX]; /* borrowed from the descriptor */
    unsigned kept[JLT_CYCLE_STATES_MAX], kept_count;
    bool replays; /* set by the caller: what is proved is only compared with a certificate (jlt_shown_ball) */
} jlt_given;

enum { JLT_GIVEN_DIGITS_MAX = 1000 };

/** The general field, in its own time, of the table that `given` names: of `own` if it has this name, else of a built-in table.
 *  Returns NULL if there is no such table, or it has another digest, and describes that in problem. */
const jlt_descriptor *jlt_given_table(const json_t *given, const jlt_descriptor *own, char problem[JLT_GIVEN_PROBLEM_MAX]);

/** Read a NUMBER or a ball. Returns false if the value is neither. */
bool jlt_given_read_value(arb_t out, const json_t *value, slong bits);

/** Read "parameters" into params, shape (param_count,). Returns false if they are not those of the table, or have values that it
 *  does not allow, and describes why in problem. */
bool jlt_given_read_params(arb_ptr params, const json_t *given, const jlt_descriptor *descriptor, slong bits,
                           char problem[JLT_GIVEN_PROBLEM_MAX]);

/** Read the question without coordinates and legs. watch, borrowed, may be NULL, is called after the steps of proofs. In any case
 *  the caller must call jlt_given_clear. Returns false if the JSON is not of this form, or outside what the table allows, and
 *  describes why in problem. */
bool jlt_given_read(jlt_given *self, const json_t *given, const jlt_descriptor *descriptor, jlt_step_watch *watch,
                    char problem[JLT_GIVEN_PROBLEM_MAX]);
void jlt_given_clear(jlt_given *self);

/** Read coordinates and legs, after jlt_given_read. Returns false as jlt_given_read does. */
bool jlt_given_read_legs(jlt_given *self, const json_t *given, char problem[JLT_GIVEN_PROBLEM_MAX]);

/** Instead of jlt_given_read_legs, make coordinates and legs from guesses: x, shape (legs, states), points on the section; T,
 *  shape (legs,), the times from each to the next; and turns, shape (legs, states), the numbers of periods by which states have
 *  grown there. The points are refined by Newton's method, and become the midpoints of boxes of this radius, in the units of the
 *  states; radius 0: 1e-10 times 2^units[i] for state i, also times its size there if that is above 64, or times the largest size
 *  if all are below 1/64; or, if parameters or levels are intervals, the extent to which these spread the orbits. Sets
 *  "coordinates" and "legs" of `given`.
 *  Errors: as jlt_cycle_create, jlt_cycle_choose, jlt_cycle_refine, jlt_cycle_reach; ARG, the number of legs is not 1 to
 *  JLT_CYCLE_LEGS_MAX; UNSUPPORTED, turns that the table does not prove, described in problem; NOMEM. */
JLT_CHECKED jlt_status jlt_given_make_legs(jlt_given *self, json_t *given, unsigned legs, const double *x, const double *T,
                                           const int *turns, double radius, const int *units,
                                           char problem[JLT_GIVEN_PROBLEM_MAX]);

#endif
