/** Reads and writes the numbers of periods by which states have grown at the end of a leg: "turns": {STATE: N, ...} of a leg in a
 *  certificate, with integers other than 0; states that are not named have not grown. See given.h. */
#ifndef JLT_VALIDATED_GIVEN_TURNS_H
#define JLT_VALIDATED_GIVEN_TURNS_H

#include "validated/given_legs.h"

/** Set the numbers of periods, shape (count, states), for the legs of self, and the corresponding growth of states as balls; if
 *  all are 0, there are no turns. Returns false, and describes why in problem, if the table does not prove these periods, or a
 *  level is not proved to be periodic with them. Cost: parsing the table, and these proofs. */
bool jlt_given_turns_set(jlt_given_legs *self, const jlt_cycle_question *question, const int *counts,
                         char problem[JLT_GIVEN_PROBLEM_MAX]);

/** The same, read from the array of legs, as many as self has. */
bool jlt_given_turns_read(jlt_given_legs *self, const jlt_cycle_question *question, const json_t *legs,
                          char problem[JLT_GIVEN_PROBLEM_MAX]);

/** The turns of one leg; a new reference, NULL if it has none. */
json_t *jlt_given_turns_write(const jlt_given_legs *self, const jlt_cycle_question *question, unsigned leg);

#endif
