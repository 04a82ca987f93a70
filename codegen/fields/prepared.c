#include "fields/prepared.h"

#include "base/array.h"

#include <stdlib.h>

void ttc_prepared_clear(ttc_prepared *prepared)
{
    free(prepared->entries);
    *prepared = (ttc_prepared){ .field = prepared->field };
}

size_t ttc_prepared_size(const ttc_prepared *prepared) { return prepared->field->param_count + prepared->count; }

ttc_id ttc_prepared_at(const ttc_prepared *prepared, uint32_t index)
{
    const ttc_field *field = prepared->field;
    if (index < field->param_count) return field->model->symbols[field->params[index]].node;
    return prepared->entries[index - field->param_count];
}

/* Index of an expression that was added before, or of a parameter; UINT32_MAX for any other. */
static uint32_t find(const ttc_prepared *prepared, ttc_id expression)
{
    const ttc_field *field = prepared->field;
    if (ttc_kind_of(field->graph, expression) == TTC_SYMBOL) {
        const ttc_field_symbol *s = field->symbols + ttc_symbol_of(field->graph, expression);
        if (s->role == TTC_ROLE_PARAM) return s->position;
    }
    for (size_t k = 0; k < prepared->count; k++)
        if (prepared->entries[k] == expression) return (uint32_t)(field->param_count + k);
    return UINT32_MAX;
}

uint32_t ttc_prepared_index(ttc_prepared *prepared, ttc_id expression)
{
    uint32_t index = find(prepared, expression);
    if (index != UINT32_MAX) return index;
    prepared->failed |= !TTC_ARRAY_GROW(prepared->entries, prepared->count);
    if (prepared->failed) return 0;
    prepared->entries[prepared->count++] = expression;
    return (uint32_t)(prepared->field->param_count + prepared->count - 1);
}
