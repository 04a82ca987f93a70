/** Periods by which states have grown where a leg of an orbit ends: "turns": {STATE: N, ...} of a leg of a certificate, whole
 *  numbers other than 0; states that are not named have not grown. See given.h. */
#ifndef JLT_VALIDATED_GIVEN_TURNS_H
#define JLT_VALIDATED_GIVEN_TURNS_H

#include "validated/given_legs.h"

/** Take counts of periods, shape (count, states), for the legs of self, and what states grow by, in balls. All 0: there are none.
 *  False: the table does not prove that these are periods, or a level or a condition of the model is not proved to be the same a
 *  period on; problem says why. Cost: the table is read, and a proof for each of those. */
bool jlt_given_turns_set(jlt_given_legs *self, const jlt_cycle_question *question, const int *counts,
                         char problem[JLT_GIVEN_PROBLEM_MAX]);

/** The same from the array of legs, as many as self has. */
bool jlt_given_turns_read(jlt_given_legs *self, const jlt_cycle_question *question, const json_t *legs,
                          char problem[JLT_GIVEN_PROBLEM_MAX]);

/** Of one leg; a new reference, NULL where it has none. */
json_t *jlt_given_turns_write(const jlt_given_legs *self, const jlt_cycle_question *question, unsigned leg);

#endif
