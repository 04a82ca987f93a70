#include "algebra/valuation_state.h"

#include <stdlib.h>

static const char *const spare_names[TTC_SPARE_VARIABLES] = { "root1", "root2", "root3",  "root4",  "root5",  "root6",
                                                              "root7", "root8", "root9", "root10", "root11", "root12" };

static ttc_valuation *allocate(const ttc_model *model)
{
    ttc_valuation *v = calloc(1, sizeof *v);
    if (v == NULL) return NULL;
    v->model = model;
    v->symbol_count = model->symbol_count + TTC_SPARE_SYMBOLS;
    v->values = calloc(v->symbol_count, sizeof *v->values);
    v->known = calloc(v->symbol_count, sizeof *v->known);
    v->bound = calloc(v->symbol_count, sizeof *v->bound);
    v->square = calloc(v->symbol_count, sizeof *v->square);
    v->variable = calloc(v->symbol_count, sizeof *v->variable);
    v->freed = calloc(v->symbol_count, sizeof *v->freed);
    v->rooted = calloc(v->symbol_count, sizeof *v->rooted);
    v->names = calloc(v->symbol_count + TTC_SPARE_VARIABLES, sizeof *v->names);
    v->positive = calloc(v->symbol_count + TTC_SPARE_VARIABLES, sizeof *v->positive);
    v->basis = calloc(v->symbol_count, sizeof *v->basis);
    v->exponentials = calloc(v->symbol_count, sizeof *v->exponentials);
    v->logarithms = calloc(v->symbol_count, sizeof *v->logarithms);
    if (v->values == NULL || v->known == NULL || v->bound == NULL || v->square == NULL || v->variable == NULL
        || v->freed == NULL || v->rooted == NULL || v->names == NULL || v->positive == NULL || v->basis == NULL
        || v->exponentials == NULL || v->logarithms == NULL) {
        v->symbol_count = 0;
        ttc_valuation_destroy(v);
        return NULL;
    }
    for (size_t i = 0; i < v->symbol_count; i++) v->variable[i] = -1;
    return v;
}

static bool is_positive(const ttc_model *model, const ttc_symbol_entry *entry)
{
    switch (entry->kind) {
    case TTC_ROOT:
    case TTC_EXP:
    case TTC_PI: return true;
    case TTC_PARAM: return entry->sign == TTC_POSITIVE || entry->sign == TTC_NONNEGATIVE;
    case TTC_STATE:
        return entry->low != TTC_NONE && ttc_kind_of(model->graph, entry->low) == TTC_NUMBER
               && fmpq_sgn(ttc_coefficient(model->graph, entry->low)) >= 0;
    default: return false;
    }
}

/* Variables in the order of symbols, spare symbols and spare roots last. */
static void name_variables(ttc_valuation *v, size_t *used)
{
    for (size_t i = 0; i < v->model->symbol_count; i++) {
        const ttc_symbol_entry *entry = &v->model->symbols[i];
        if (entry->kind == TTC_LET) continue;
        v->variable[i] = (slong)*used;
        v->names[*used] = entry->name;
        v->positive[*used] = is_positive(v->model, entry);
        ++*used;
    }
}

ttc_valuation *ttc_valuation_create(const ttc_model *model, unsigned choices)
{
    size_t used = 0;
    ttc_valuation *v = allocate(model);
    if (v == NULL) return NULL;
    name_variables(v, &used);
    size_t total = used + TTC_SPARE_VARIABLES;
    for (size_t i = 0; i < TTC_SPARE_VARIABLES; i++) v->names[used + i] = spare_names[i];
    for (size_t i = 0; i < TTC_SPARE_SYMBOLS; i++) v->variable[model->symbol_count + i] = (slong)(used + i);
    v->ring = ttc_ring_create(total, used + TTC_SPARE_SYMBOLS, v->names, v->positive);
    if (v->ring == NULL) {
        v->symbol_count = 0;
        ttc_valuation_destroy(v);
        return NULL;
    }
    v->ring->choices = choices;
    for (size_t i = 0; i < model->symbol_count; i++)
        if (model->symbols[i].kind == TTC_PI) v->ring->trust[v->variable[i]] = TTC_TRUST_SINGLE | TTC_TRUST_CONSTANT;
    for (size_t i = 0; i < v->symbol_count; i++) ttc_ratio_init(v->ring, &v->values[i]);
    return v;
}

ttc_valuation *ttc_valuation_map(const ttc_model *model, ttc_valuation *base)
{
    ttc_valuation *v = allocate(model);
    if (v == NULL) return NULL;
    v->base = base;
    v->ring = base->ring;
    for (size_t i = 0; i < v->symbol_count; i++) ttc_ratio_init(v->ring, &v->values[i]);
    return v;
}

void ttc_valuation_destroy(ttc_valuation *v)
{
    if (v == NULL) return;
    for (size_t i = 0; i < v->symbol_count; i++) ttc_ratio_clear(v->ring, &v->values[i]);
    for (size_t i = 0; i < v->memo_size; i++)
        if (v->seen[i]) ttc_ratio_clear(v->ring, &v->memo[i]);
    if (v->base == NULL) ttc_ring_destroy(v->ring);
    free(v->seen);
    free(v->memo);
    free(v->logarithms);
    free(v->exponentials);
    free(v->basis);
    free(v->positive);
    free(v->names);
    free(v->rooted);
    free(v->freed);
    free(v->variable);
    free(v->square);
    free(v->bound);
    free(v->known);
    free(v->values);
    free(v);
}

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

const char *ttc_valuation_name_of(const ttc_valuation *v, uint32_t symbol)
{
    const char *name = v->names[v->variable[symbol]];
    for (size_t i = 0; i < TTC_SPARE_VARIABLES; i++)
        if (name == spare_names[i]) return NULL;
    return name;
}

void ttc_valuation_free_root(ttc_valuation *v, uint32_t symbol) { v->freed[symbol] = true; }
slong ttc_valuation_variable(const ttc_valuation *v, uint32_t symbol) { return v->variable[symbol]; }

bool ttc_valuation_has_value(const ttc_valuation *v, uint32_t symbol) { return v->known[symbol] == TTC_VALUE_KNOWN; }

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
    } else if (!spare && entry->kind == TTC_LET) {
        ttc_evaluate(v, out, entry->definition);
    } else if (!spare && entry->kind == TTC_ROOT && !v->freed[symbol]) {
        ttc_evaluate(v, out, entry->definition);
        ttc_ring_root(v->ring, out, out, v->variable[symbol], true);
    } else if (!spare && (entry->kind == TTC_COSINE || entry->kind == TTC_SINE)) {
        ttc_valuation_angle_value(v, out, symbol);
    } else if (!spare && entry->kind == TTC_EXP) {
        ttc_valuation_exp_value(v, out, symbol);
    } else if (!spare && entry->kind == TTC_LOG) {
        ttc_valuation_log_value(v, out, symbol);
    } else if (!spare && entry->kind == TTC_PI) {
        ttc_valuation_pi_value(v, out);
    } else if (v->variable[symbol] >= 0) {
        ttc_ratio_set_variable(v->ring, out, v->variable[symbol]);
    } else {
        ttc_ring_fail(v->ring, TTC_RING_CIRCULAR);
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
        v->known[symbol] = TTC_VALUE_KNOWN;
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
        if (joins && v->known[i] != TTC_VALUE_BUSY) ttc_valuation_value(v, &value, i);
    }
    ttc_ratio_clear(v->ring, &value);
    return v->ring->status == TTC_RING_OK;
}

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

static void compound_value(ttc_valuation *v, ttc_ratio *out, ttc_id id, ttc_kind kind)
{
    const ttc_graph *graph = v->model->graph;
    ttc_ratio part_value;
    ttc_ratio_init(v->ring, &part_value);
    ttc_ratio_set_rational(v->ring, out, ttc_coefficient(graph, id));
    for (size_t i = 0; i < ttc_part_count(graph, id) && v->ring->status == TTC_RING_OK; i++) {
        ttc_part part = ttc_part_at(graph, id, i);
        ttc_evaluate(v, &part_value, part.id);
        if (kind == TTC_SUM) {
            ttc_ratio_scale(v->ring, &part_value, &part_value, part.coefficient);
            ttc_ratio_add(v->ring, out, out, &part_value);
        } else {
            ttc_ratio_power(v->ring, &part_value, &part_value, part.exponent);
            ttc_ratio_multiply(v->ring, out, out, &part_value);
        }
    }
    ttc_ratio_clear(v->ring, &part_value);
}

void ttc_evaluate(ttc_valuation *v, ttc_ratio *out, ttc_id id)
{
    const ttc_graph *graph = v->model->graph;
    if (id == TTC_NONE) ttc_ring_fail(v->ring, TTC_RING_TOO_LARGE);
    if (v->ring->status != TTC_RING_OK || !reserve_memo(v)) return;
    if (!v->seen[id]) {
        ttc_kind kind = ttc_kind_of(graph, id);
        ttc_ratio value;
        ttc_ratio_init(v->ring, &value);
        if (kind == TTC_SYMBOL) ttc_valuation_value(v, &value, ttc_symbol_of(graph, id));
        else compound_value(v, &value, id, kind);
        v->memo[id] = value;
        v->seen[id] = true;
    }
    ttc_ratio_set(v->ring, out, &v->memo[id]);
}
