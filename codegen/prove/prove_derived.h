/** What a table says without making a claim of it (roots, logarithms, variants, times, eliminations, poles, what is looked at
 *  beside the equations): each becomes a claim of its own. */
#ifndef TTC_PROVE_DERIVED_H
#define TTC_PROVE_DERIVED_H

#include "prove/prove_task.h"

typedef struct {
    const char *kind, *name;
    ttc_claim claim;     /* `when` holds the substitution and is borrowed, or points to `substitution`; name, place borrowed */
    ttc_binding substitution;
    ttc_prover prove;    /* finds its subject at index claim.family */
    ttc_divisor_role role; /* of the record's own divisors; FIELD: it has none */
    ttc_id divisor;        /* one more that must not be zero, or TTC_NONE */
    uint32_t tested_root;  /* the root in question, or 0 */
    bool tests_conditions; /* `when` is what is in question: its values against the signs of parameters */
} ttc_derived_claim;

size_t ttc_derived_count(const ttc_model *model);
/* index < ttc_derived_count(model). The result must stay where it is while it is proved. */
void ttc_derived_claim_get(const ttc_model *model, size_t index, ttc_derived_claim *derived);

#endif
