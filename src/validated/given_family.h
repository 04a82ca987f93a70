/** What a certificate about a family of equilibria starts from, and what it shows.
 *
 *      "given": {
 *        "table": {"name": NAME, "sha256": DIGEST},
 *        "family": NAME,                                         of the table's record `equilibria`
 *        "box": {NAME: FRACTION or {"low": FRACTION, "high": FRACTION}, ...},
 *                                                                all parameters and states but those that the family gives
 *        "limit": N, "digits": N }                               boxes to look at, at most; to compute with
 *      "shown": {
 *        "trace": {"low": DECIMAL, "high": DECIMAL}, "conditions": {NAME: DECIMAL, ...}, "boxes": N,
 *        "point": {NAME: FRACTION, ...},                         one of the box and of the table's domain
 *        "claims": ["equilibria NAME", "trace NAME"] }           the latter where the table has it, and it is proved
 *
 *  FRACTION is a string, "p" or "p/q". */
#ifndef JLT_VALIDATED_GIVEN_FAMILY_H
#define JLT_VALIDATED_GIVEN_FAMILY_H

#include "validated/family.h"
#include "validated/given.h"

enum { JLT_GIVEN_FAMILY_LIMIT_MAX = 10000000 };

typedef struct {
    jlt_family_question question; /* points into this object, which must not move */
    const jlt_descriptor *descriptor;
    ttc_model *model;
    unsigned char *is_given;      /* by symbol: by the family */
    uint32_t *symbols;
    fmpq *low, *high;
} jlt_given_family;

/** Read it. Ends with jlt_given_family_clear in any case. False: it is not of this form, or outside what the table allows, or the
 *  family is not proved to consist of equilibria; problem says why. */
bool jlt_given_family_read(jlt_given_family *self, const json_t *given, const jlt_descriptor *descriptor,
                           char problem[JLT_GIVEN_PROBLEM_MAX]);
void jlt_given_family_clear(jlt_given_family *self);

/** What was proved; a new reference, NULL when memory is out. */
json_t *jlt_given_family_shown(const jlt_given_family *self, const jlt_family_result *result);

/** Why nothing was proved, in words with points and boxes by names. In: result, with another verdict than PROVED. */
void jlt_given_family_problem(char problem[JLT_GIVEN_PROBLEM_MAX], const jlt_given_family *self, const jlt_family_result *result);

#endif
