#include "fields/block.h"

#include <stdlib.h>

void ttc_block_clear(ttc_block *block)
{
    free(block->entries);
    *block = (ttc_block){ .field = block->field };
}

size_t ttc_block_size(const ttc_block *block) { return block->field->param_count + block->count; }

ttc_id ttc_block_at(const ttc_block *block, uint32_t index)
{
    const ttc_field *field = block->field;
    if (index < field->param_count) return field->model->symbols[field->params[index]].node;
    return block->entries[index - field->param_count];
}

uint32_t ttc_block_find(const ttc_block *block, ttc_id expression)
{
    const ttc_field *field = block->field;
    if (ttc_kind_of(field->graph, expression) == TTC_SYMBOL) {
        const ttc_field_symbol *s = field->symbols + ttc_symbol_of(field->graph, expression);
        if (s->role == TTC_ROLE_PARAM) return s->position;
    }
    for (size_t k = 0; k < block->count; k++)
        if (block->entries[k] == expression) return (uint32_t)(field->param_count + k);
    return UINT32_MAX;
}

uint32_t ttc_block_index(ttc_block *block, ttc_id expression)
{
    uint32_t index = ttc_block_find(block, expression);
    if (index != UINT32_MAX) return index;
    if (block->count == block->capacity) {
        size_t capacity = block->capacity == 0 ? 16 : 2 * block->capacity;
        ttc_id *entries = realloc(block->entries, capacity * sizeof *entries);
        if (entries == NULL) {
            block->failed = true;
            return 0;
        }
        block->entries = entries;
        block->capacity = capacity;
    }
    block->entries[block->count++] = expression;
    return (uint32_t)(block->field->param_count + block->count - 1);
}
