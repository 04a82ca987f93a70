/** The prepared values of a field: values used by kernels that depend on parameters alone and are computed once for given
 *  parameters. The parameters themselves come first, then expressions in the order in which kernels first used them. */
#ifndef TTC_PREPARED_H
#define TTC_PREPARED_H

#include "fields/field.h"

typedef struct {
    ttc_field *field;
    ttc_id *entries; /* entry k has index param_count + k among the prepared values */
    size_t count;
    bool failed;
} ttc_prepared;

void ttc_prepared_clear(ttc_prepared *prepared); /* legal on a zeroed object */

/* Index of an expression that depends on parameters alone; it is added if it is new. A parameter has its own index. When memory is
 * out `failed` is set, and the index is 0. */
uint32_t ttc_prepared_index(ttc_prepared *prepared, ttc_id expression);

/* The expression with this index. */
ttc_id ttc_prepared_at(const ttc_prepared *prepared, uint32_t index);

/* Number of entries, parameters included. */
size_t ttc_prepared_size(const ttc_prepared *prepared);

#endif
