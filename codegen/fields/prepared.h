/** The prepared values of a field: what kernels need that depends on parameters alone, computed once. The parameters
 *  themselves come first, then expressions in the order in which kernels first asked for them. */
#ifndef TTC_PREPARED_H
#define TTC_PREPARED_H

#include "fields/field.h"

typedef struct {
    ttc_field *field;
    ttc_id *entries; /* entry k stands at param_count + k */
    size_t count;
    bool failed;
} ttc_prepared;

void ttc_prepared_clear(ttc_prepared *prepared); /* legal on a zeroed object */

/* Position of an expression in parameters alone, which is added if it is new; a plain parameter stands at its own index. */
uint32_t ttc_prepared_index(ttc_prepared *prepared, ttc_id expression);

/* The expression at a position. */
ttc_id ttc_prepared_at(const ttc_prepared *prepared, uint32_t index);

/* Number of entries, parameters included. */
size_t ttc_prepared_size(const ttc_prepared *prepared);

#endif
