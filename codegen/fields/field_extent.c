/* Signs and bounds of expressions on the domain of a field. */
#include "fields/field.h"

#include <stdlib.h>

static ttc_extent extent_of(ttc_field *field, ttc_id id);

/* Extent of a state, which lies strictly between the ends of its interval, or of a lifted root. */
static ttc_extent extent_of_state(ttc_field *field, const ttc_symbol_entry *entry)
{
    ttc_extent result = ttc_extent_any;
    if (entry->kind == TTC_ROOT) return ttc_extent_of_signs(TTC_SIGN_POSITIVE);
    if (entry->low != TTC_NONE) {
        ttc_extent low = extent_of(field, entry->low);
        result.low = low.low;
        if (ttc_extent_is_nonnegative(low)) result.signs = TTC_SIGN_POSITIVE;
    }
    if (entry->high != TTC_NONE) {
        ttc_extent high = extent_of(field, entry->high);
        result.high = high.high;
        if (ttc_extent_is_nonpositive(high)) result.signs = TTC_SIGN_NEGATIVE;
    }
    return ttc_extent_meet(result, ttc_extent_any);
}

static ttc_extent extent_of_symbol(ttc_field *field, uint32_t symbol)
{
    static const unsigned char signs[] = { [TTC_ANY_SIGN] = TTC_SIGN_ANY, [TTC_POSITIVE] = TTC_SIGN_POSITIVE,
                                           [TTC_NONNEGATIVE] = TTC_SIGN_ZERO | TTC_SIGN_POSITIVE,
                                           [TTC_NONZERO] = TTC_SIGN_NEGATIVE | TTC_SIGN_POSITIVE };
    const ttc_field_symbol *s = field->symbols + symbol;
    bool is_replaced = s->node != TTC_NONE
                       && (ttc_kind_of(field->graph, s->node) != TTC_SYMBOL || ttc_symbol_of(field->graph, s->node) != symbol);
    if (is_replaced) return extent_of(field, s->node);
    switch (s->role) {
    case TTC_ROLE_PARAM: return ttc_extent_of_signs(signs[s->sign]);
    case TTC_ROLE_STATE: return extent_of_state(field, field->model->symbols + symbol);
    case TTC_ROLE_UNIT: return extent_of(field, s->definition);
    case TTC_ROLE_ROOT:
        return ttc_extent_meet(ttc_extent_root(extent_of(field, s->definition)), ttc_extent_of_signs(TTC_SIGN_POSITIVE));
    case TTC_ROLE_EXP:
    case TTC_ROLE_PI: return ttc_extent_of_signs(TTC_SIGN_POSITIVE);
    case TTC_ROLE_COSINE:
    case TTC_ROLE_SINE: return (ttc_extent){ TTC_SIGN_ANY, -1, 1 };
    default: return ttc_extent_any;
    }
}

static ttc_extent compute(ttc_field *field, ttc_id id)
{
    const ttc_graph *graph = field->graph;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) return extent_of_symbol(field, ttc_symbol_of(graph, id));
    ttc_extent result = ttc_extent_of_number(ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id); i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        ttc_extent extent = extent_of(field, part.id);
        if (ttc_kind_of(graph, id) == TTC_PRODUCT)
            result = ttc_extent_multiply(result, ttc_extent_power(extent, part.exponent));
        else result = ttc_extent_add(result, ttc_extent_multiply(extent, ttc_extent_of_number(part.coefficient)));
    }
    return result;
}

static ttc_extent extent_of(ttc_field *field, ttc_id id)
{
    if (field->extents[id].signs == 0) field->extents[id] = compute(field, id);
    return field->extents[id];
}

ttc_extent ttc_field_extent(ttc_field *field, ttc_id expression)
{
    size_t size = ttc_graph_size(field->graph) + 1;
    if (expression == TTC_NONE) return ttc_extent_any;
    if (size > field->extent_capacity) {
        size_t capacity = 2 * size;
        ttc_extent *extents = realloc(field->extents, capacity * sizeof *extents);
        if (extents == NULL) {
            field->failed = true;
            return ttc_extent_any;
        }
        for (size_t i = field->extent_capacity; i < capacity; i++) extents[i].signs = 0;
        field->extents = extents;
        field->extent_capacity = capacity;
    }
    return extent_of(field, expression);
}
