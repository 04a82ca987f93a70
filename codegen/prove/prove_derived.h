/** Derived claims: what roots, logarithms, variants, times, eliminations, poles and the records of observed.h state; and that the
 *  domain of a table that claims nothing else has a point. */
#ifndef TTC_PROVE_DERIVED_H
#define TTC_PROVE_DERIVED_H

#include "prove/prove_task.h"

typedef struct {
    const char *kind, *name;
    ttc_claim claim;     /* `when` is borrowed from the model, or points to `substitution`; all else in it is borrowed too */
    ttc_binding substitution;
    ttc_prover prove;    /* its subject has index claim.family among records of its kind */
    ttc_divisor_role role; /* of the record's own divisors; FIELD: it has none */
    ttc_id divisor;        /* a further divisor, or TTC_NONE */
    uint32_t tested_root;  /* the root or logarithm under test, or 0 */
    bool tests_conditions; /* `when` is under test: its values must obey the signs of parameters */
} ttc_derived_claim;

size_t ttc_derived_count(const ttc_model *model);
/* index < ttc_derived_count(model). *derived must not be moved while it is in use, as it may point into itself. */
void ttc_derived_claim_get(const ttc_model *model, size_t index, ttc_derived_claim *derived);

#endif
