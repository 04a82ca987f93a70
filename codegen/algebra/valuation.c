#include "algebra/valuation_state.h"

#include <stdlib.h>

ttc_ring *ttc_valuation_ring(ttc_valuation *v) { return v->ring; }
const ttc_model *ttc_valuation_model(const ttc_valuation *v) { return v->model; }
void ttc_valuation_bind(ttc_valuation *v, uint32_t symbol, ttc_id expression) { v->bound[symbol] = expression; }
void ttc_valuation_bind_square(ttc_valuation *v, uint32_t symbol, ttc_id square) { v->square[symbol] = square; }
void ttc_valuation_bind_root(ttc_valuation *v, uint32_t symbol, ttc_id radicand)
{
    v->square[symbol] = radicand;
    v->rooted[symbol] = true;
}

void ttc_valuation_name(ttc_valuation *v, uint32_t symbol, const char *name) { v->names[v->variable[symbol]] = name; }

/* The next spare variable, which is free from now on; -1 if there is none. */
static slong free_spare(ttc_valuation *v)
{
    if (v->ring->next_spare == v->ring->variable_count) return -1;
    v->freed[v->ring->next_spare] = true;
    return (slong)v->ring->next_spare++;
}

bool ttc_valuation_free(ttc_valuation *v, uint32_t symbol)
{
    if (v->variable[symbol] < 0) {
        v->variable[symbol] = free_spare(v);
        if (v->variable[symbol] < 0) return false;
        v->names[v->variable[symbol]] = v->model->symbols[symbol].name;
    }
    return v->freed[v->variable[symbol]] = true;
}

slong ttc_valuation_variable(const ttc_valuation *v, uint32_t symbol) { return v->variable[symbol]; }

bool ttc_valuation_is_free(const ttc_valuation *v, slong variable) { return v->freed[variable]; }

bool ttc_valuation_has_value(const ttc_valuation *v, uint32_t symbol) { return v->known[symbol] == TTC_VALUE_KNOWN; }

bool ttc_valuation_has_met(const ttc_valuation *v, ttc_id id) { return id < v->memo_size && v->seen[id]; }

bool ttc_valuation_is_bound(const ttc_valuation *v, uint32_t symbol)
{
    return v->bound[symbol] != TTC_NONE || v->square[symbol] != TTC_NONE;
}

size_t ttc_valuation_symbol(const ttc_valuation *v, slong variable)
{
    for (size_t i = 0; i < v->symbol_count; i++)
        if (v->variable[i] == variable) return i;
    return SIZE_MAX;
}

ttc_valuation *ttc_valuation_plain(ttc_valuation *v)
{
    while (v->base != NULL) v = v->base;
    return v;
}

static void defined_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol)
{
    bool spare = symbol >= v->model->symbol_count;
    const ttc_symbol_entry *entry = spare ? NULL : &v->model->symbols[symbol];
    if (v->bound[symbol] != TTC_NONE) {
        ttc_evaluate(v->base != NULL ? v->base : v, out, v->bound[symbol]);
        if (!spare && entry->kind == TTC_ROOT && ttc_ratio_is_zero(v->ring, out))
            ttc_ring_fail(v->ring, TTC_RING_ROOT_OF_ZERO);
    } else if (v->square[symbol] != TTC_NONE) {
        ttc_evaluate(v, out, v->square[symbol]);
        ttc_ring_root(v->ring, out, out, v->variable[symbol], v->rooted[symbol]);
    } else if (v->variable[symbol] >= 0 && v->freed[v->variable[symbol]]) {
        ttc_ratio_set_variable(v->ring, out, v->variable[symbol]);
    } else if (!spare && entry->kind == TTC_LET) {
        ttc_evaluate(v, out, entry->definition);
    } else if (!spare && entry->kind == TTC_ROOT) {
        ttc_evaluate(v, out, entry->definition);
        ttc_ring_root(v->ring, out, out, v->variable[symbol], true);
    } else if (!spare && v->functions[entry->kind] != NULL) {
        v->functions[entry->kind](v, out, symbol);
    } else if (v->variable[symbol] >= 0) {
        ttc_ratio_set_variable(v->ring, out, v->variable[symbol]);
    } else {
        ttc_ring_fail(v->ring, TTC_RING_ANGLE_ALONE);
    }
}

void ttc_valuation_value(ttc_valuation *v, ttc_ratio *out, uint32_t symbol)
{
    if (v->known[symbol] == TTC_VALUE_BUSY) ttc_ring_fail(v->ring, TTC_RING_CIRCULAR);
    if (v->ring->status != TTC_RING_OK) return;
    if (v->known[symbol] == TTC_VALUE_UNKNOWN) {
        ttc_ratio value;
        ttc_ratio_init(v->ring, &value);
        v->known[symbol] = TTC_VALUE_BUSY;
        defined_value(v, &value, symbol);
        ttc_ratio_set(v->ring, &v->values[symbol], &value);
        v->known[symbol] = v->ring->status == TTC_RING_OK ? TTC_VALUE_KNOWN : TTC_VALUE_UNKNOWN;
        ttc_ratio_clear(v->ring, &value);
    }
    ttc_ratio_set(v->ring, out, &v->values[symbol]);
}

bool ttc_valuation_meet(ttc_valuation *v)
{
    if (v->met || v->ring->status != TTC_RING_OK) return false;
    ttc_ratio value;
    v->met = true;
    ttc_ratio_init(v->ring, &value);
    for (uint32_t i = 0; i < v->model->symbol_count; i++) {
        ttc_symbol_kind kind = v->model->symbols[i].kind;
        bool joins = kind == TTC_COSINE || kind == TTC_EXP || kind == TTC_LOG;
        if (!joins || v->withheld[i] || v->known[i] == TTC_VALUE_BUSY) continue;
        ttc_valuation_value(v, &value, i);
        if (ttc_ring_has_no_value(v->ring->status)) v->ring->status = TTC_RING_OK;
    }
    ttc_ratio_clear(v->ring, &value);
    return v->ring->status == TTC_RING_OK;
}

bool ttc_valuation_may_join(ttc_valuation *v, uint32_t symbol)
{
    if (v->withheld[symbol] || v->ring->status != TTC_RING_OK) return false;
    ttc_ratio value;
    ttc_ratio_init(v->ring, &value);
    ttc_evaluate(v, &value, v->model->symbols[symbol].definition);
    const bool has_value = !ttc_ring_has_no_value(v->ring->status);
    if (!has_value) v->ring->status = TTC_RING_OK;
    ttc_ratio_clear(v->ring, &value);
    return has_value;
}

void ttc_valuation_withhold(ttc_valuation *v, uint32_t symbol) { v->withheld[symbol] = true; }

static bool reserve_memo(ttc_valuation *v)
{
    size_t size = ttc_graph_size(v->model->graph) + 1;
    if (size <= v->memo_size) return true;
    ttc_ratio *memo = realloc(v->memo, size * sizeof *memo);
    if (memo != NULL) v->memo = memo;
    bool *seen = realloc(v->seen, size * sizeof *seen);
    if (seen != NULL) v->seen = seen;
    if (memo == NULL || seen == NULL) {
        ttc_ring_fail(v->ring, TTC_RING_NO_MEMORY);
        return false;
    }
    for (size_t i = v->memo_size; i < size; i++) seen[i] = false;
    v->memo_size = size;
    return true;
}

bool ttc_valuation_free_expression(ttc_valuation *v, ttc_id id)
{
    if (!reserve_memo(v) || v->seen[id]) return false;
    const slong variable = free_spare(v);
    if (variable < 0) return false;
    ttc_ratio_init(v->ring, &v->memo[id]);
    ttc_ratio_set_variable(v->ring, &v->memo[id], variable);
    return v->seen[id] = true;
}

/* out += the parts of a sum from `first` to `end`. Long sums are added in halves, as gcds cost more for ratios of many terms. */
static void add_parts(ttc_valuation *v, ttc_ratio *out, ttc_id id, size_t first, size_t end)
{
    ttc_ratio value;
    ttc_ratio_init(v->ring, &value);
    if (end - first > 16) {
        const size_t middle = first + (end - first) / 2;
        add_parts(v, out, id, first, middle);
        add_parts(v, &value, id, middle, end);
        if (v->ring->status == TTC_RING_OK) ttc_ratio_add(v->ring, out, out, &value);
        first = end;
    }
    for (size_t i = first; i < end && v->ring->status == TTC_RING_OK; i++) {
        ttc_part part = ttc_part_at(v->model->graph, id, i);
        ttc_evaluate(v, &value, part.id);
        ttc_ratio_scale(v->ring, &value, &value, part.coefficient);
        ttc_ratio_add(v->ring, out, out, &value);
    }
    ttc_ratio_clear(v->ring, &value);
}

static void multiply_parts(ttc_valuation *v, ttc_ratio *out, ttc_id id)
{
    ttc_ratio value;
    ttc_ratio_init(v->ring, &value);
    for (size_t i = 0; i < ttc_part_count(v->model->graph, id) && v->ring->status == TTC_RING_OK; i++) {
        ttc_part part = ttc_part_at(v->model->graph, id, i);
        ttc_evaluate(v, &value, part.id);
        ttc_ratio_power(v->ring, &value, &value, part.exponent);
        ttc_ratio_multiply(v->ring, out, out, &value);
    }
    ttc_ratio_clear(v->ring, &value);
}

void ttc_evaluate(ttc_valuation *v, ttc_ratio *out, ttc_id id)
{
    const ttc_graph *graph = v->model->graph;
    if (id == TTC_NONE) ttc_ring_fail(v->ring, TTC_RING_LARGE_EXPRESSION);
    if (v->ring->status != TTC_RING_OK || !reserve_memo(v)) return;
    if (!v->seen[id]) {
        ttc_kind kind = ttc_kind_of(graph, id);
        ttc_ratio value;
        ttc_ratio_init(v->ring, &value);
        if (kind == TTC_SYMBOL) ttc_valuation_value(v, &value, ttc_symbol_of(graph, id));
        else ttc_ratio_set_rational(v->ring, &value, ttc_coefficient(graph, id));
        if (kind == TTC_SUM) add_parts(v, &value, id, 0, ttc_part_count(graph, id));
        else if (kind != TTC_SYMBOL) multiply_parts(v, &value, id);
        /* A failed value is not stored, since callers may reset the status and go on with other expressions. */
        if (v->ring->status != TTC_RING_OK) {
            ttc_ratio_clear(v->ring, &value);
            return;
        }
        v->memo[id] = value;
        v->seen[id] = true;
    }
    ttc_ratio_set(v->ring, out, &v->memo[id]);
}
