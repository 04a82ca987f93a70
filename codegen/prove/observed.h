/** What is looked at beside the equations, by kernels that share what is prepared with theirs: `observe`, `valid`, `tier`. */
#ifndef TTC_OBSERVED_H
#define TTC_OBSERVED_H

#include "read/model.h"

typedef struct ttc_task ttc_task; /* see prove/prove_task.h */

typedef struct {
    const char *kind, *name;
    ttc_place place;
    ttc_divisor_role role; /* with owner: of what the record divides by and names, as it is written */
    uint32_t owner;
} ttc_observed;

/* Those that divide by something which the equations do not use. */
size_t ttc_observed_count(const ttc_model *model);
void ttc_observed_get(const ttc_model *model, size_t index, ttc_observed *record); /* index < ttc_observed_count(model) */

/* Which divisors of the table the record alone brings in, by their number, for free(); NULL when memory is out. */
unsigned char *ttc_observed_divisors(const ttc_model *model, const ttc_observed *record);

/** It divides by nothing that parameters alone make zero, nor by what is zero on a whole part of the domain. */
void ttc_prove_observed(ttc_task *task);

#endif
