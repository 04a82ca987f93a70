/** Reads the input of a certificate about a family of equilibria, and writes what it shows.
 *
 *      "given": {
 *        "table": {"name": NAME, "sha256": DIGEST},
 *        "family": NAME,                                         a record `equilibria` of the table
 *        "box": {NAME: FRACTION or {"low": FRACTION, "high": FRACTION}, ...},
 *                                                                all parameters and states except those that the family gives
 *        "limit": N, "digits": N }                               most boxes to examine; decimals to compute with
 *      "shown": {
 *        "trace": {"low": DECIMAL, "high": DECIMAL}, "conditions": {NAME: DECIMAL, ...}, "boxes": N,
 *        "point": {NAME: FRACTION, ...},                         a point of the box in the table's domain
 *        "claims": ["equilibria NAME", "trace NAME"] }           the latter if the table claims it and it is proved
 *
 *  FRACTION is a string, "p" or "p/q". */
#ifndef JLT_VALIDATED_GIVEN_FAMILY_H
#define JLT_VALIDATED_GIVEN_FAMILY_H

#include "validated/family.h"
#include "validated/given.h"

enum { JLT_GIVEN_FAMILY_LIMIT_MAX = 10000000 };

typedef struct {
    jlt_family_question question; /* points into this object, which must not be moved */
    const jlt_descriptor *descriptor;
    ttc_model *model;
    unsigned char *is_given;      /* by symbol: 1 if the family gives it */
    uint32_t *symbols;
    fmpq *low, *high;
} jlt_given_family;

/** Read the input. In any case the caller must call jlt_given_family_clear. Returns false if the JSON is not of this form, or
 *  outside what the table allows, or the family is not proved to consist of equilibria, and describes why in problem. */
bool jlt_given_family_read(jlt_given_family *self, const json_t *given, const jlt_descriptor *descriptor,
                           char problem[JLT_GIVEN_PROBLEM_MAX]);
void jlt_given_family_clear(jlt_given_family *self);

/** The object `shown` of a proved result; a new reference, NULL if memory is out. */
json_t *jlt_given_family_shown(const jlt_given_family *self, const jlt_family_result *result);

/** Describe why nothing was proved, with points and boxes by names. In: result, with a verdict other than PROVED. */
void jlt_given_family_problem(char problem[JLT_GIVEN_PROBLEM_MAX], const jlt_given_family *self, const jlt_family_result *result);

#endif
