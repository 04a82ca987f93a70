/** The members `given` and `shown` of certificates of kind `pole`: all motions from a box of states end at a pole.
 *
 *      "given": {
 *        "table": {"name": NAME, "sha256": DIGEST},
 *        "parameters": {NAME: NUMBER or {"middle": NUMBER, "radius": NUMBER}, ...},      all of the table
 *        "pole": NAME, "time": NAME,                             of records `pole` and `time`
 *        "box": {NAME: NUMBER or a ball likewise, ...},          all states: where the motions begin
 *        "instant": NUMBER,                                      the value of that time from which they settle
 *        "digits": N }
 *      "shown": {
 *        "end": FRACTION,                                        of the pole's state
 *        "vanish": [NAME, ...], "limit": {NAME: BALL, ...},      other states there: those that are 0, and all the rest
 *        "time": BALL,                                           that the motions take, in the table's own time
 *        "conditions": {NAME: DECIMAL, ...}, "claims": ["pole NAME"] }
 *
 *  NUMBER and BALL are those of given.h and shown.h. */
#ifndef JLT_VALIDATED_GIVEN_POLE_H
#define JLT_VALIDATED_GIVEN_POLE_H

#include "validated/given.h"
#include "validated/pole.h"

typedef struct {
    jlt_pole_question question; /* points into this object, which must not move */
    arb_ptr params, box;
    arf_t instant;              /* 0 if absent */
    bool replays;               /* set by the caller, as of jlt_given */
} jlt_given_pole;

/** Read `given`. In any case the caller must call jlt_given_pole_clear. If `asks`, the instant may be absent. Returns false if the
 *  JSON is not of this form, or outside what the table allows, or the pole is not proved, and describes why in problem. */
bool jlt_given_pole_read(jlt_given_pole *self, const json_t *given, const jlt_descriptor *descriptor, bool asks,
                         char problem[JLT_GIVEN_PROBLEM_MAX]);
void jlt_given_pole_clear(jlt_given_pole *self);

/** Make `shown`, a new reference; NULL if memory is out. */
json_t *jlt_given_pole_shown(const jlt_given_pole *self, const jlt_pole_result *result);

/** Why nothing was proved, in words. In: result, whose verdict is not PROVED. */
const char *jlt_given_pole_problem(const jlt_pole_result *result);

#endif
