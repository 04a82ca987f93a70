/** The prepared block of a field: values that depend on parameters alone, computed once. Its first entries are the
 *  parameters themselves, then come expressions in the order in which kernels first asked for them. */
#ifndef TTC_BLOCK_H
#define TTC_BLOCK_H

#include "fields/field.h"

typedef struct {
    ttc_field *field;
    ttc_id *entries; /* entry k stands at param_count + k */
    size_t count, capacity;
    bool failed;
} ttc_block;

void ttc_block_clear(ttc_block *block); /* legal on a zeroed block */

/* Position in the block of an expression in parameters alone; a plain parameter is its own entry. */
uint32_t ttc_block_index(ttc_block *block, ttc_id expression);

/* The same, if it is there already; UINT32_MAX otherwise. */
uint32_t ttc_block_find(const ttc_block *block, ttc_id expression);

/* The expression at a position. */
ttc_id ttc_block_at(const ttc_block *block, uint32_t index);

/* Number of entries, parameters included. */
size_t ttc_block_size(const ttc_block *block);

#endif
