/** The records `observe`, `valid` and `tier`, whose kernels share the values prepared from parameters with those of the equations:
 *  a proof that what they divide by leaves nothing out of the domain. */
#ifndef TTC_OBSERVED_H
#define TTC_OBSERVED_H

#include "read/model.h"

typedef struct ttc_task ttc_task; /* see prove/prove_task.h */

typedef struct {
    const char *kind, *name;
    ttc_place place;
    ttc_divisor_role role; /* with owner: as of the record's divisors and uses, see ttc_divisor */
    uint32_t owner;
} ttc_observed;

/* The number of these records that divide by something which the equations do not divide by; and such a record. */
size_t ttc_observed_count(const ttc_model *model);
void ttc_observed_get(const ttc_model *model, size_t index, ttc_observed *record); /* index < ttc_observed_count(model) */

/* Flags, by divisor of the table, of those that the record has and the equations have not, for free(); NULL when memory is out. */
unsigned char *ttc_observed_divisors(const ttc_model *model, const ttc_observed *record);

/** The prover of record claim.family: no divisor is zero on a whole part of the domain, nor at all states for some parameters. */
void ttc_prove_observed(ttc_task *task);

#endif
