/* Walks over the graph: substitution, derivative, dependence. Ids of parts are smaller than the id of their node, so a
 * memo array indexed by id serves, and recursion is as deep as the expression. */
#include "graph.h"

#include <stdlib.h>

typedef struct {
    ttc_graph *graph;
    ttc_symbol_map map;
    void *context;
    ttc_id *memo; /* by id of the source node; TTC_NONE: not yet visited */
    bool failed;
} walk;

static ttc_id part_value(walk *w, ttc_part part, ttc_kind kind, ttc_id value)
{
    if (kind == TTC_SUM) return ttc_scale(w->graph, value, part.coefficient);
    return ttc_power(w->graph, value, part.exponent);
}

static ttc_id substitute(walk *w, ttc_id id)
{
    if (id == TTC_NONE || w->failed) return TTC_NONE;
    if (w->memo[id] != TTC_NONE) return w->memo[id];
    ttc_kind kind = ttc_kind_of(w->graph, id);
    ttc_id result = id;
    if (kind == TTC_SYMBOL) {
        result = w->map(w->context, ttc_symbol_of(w->graph, id));
        if (result == TTC_NONE) result = id;
    } else if (kind == TTC_SUM || kind == TTC_PRODUCT) {
        result = ttc_number(w->graph, ttc_coefficient(w->graph, id));
        for (size_t i = 0; i < ttc_part_count(w->graph, id); i++) {
            ttc_part part = ttc_part_at(w->graph, id, i);
            ttc_id value = part_value(w, part, kind, substitute(w, part.id));
            result = kind == TTC_SUM ? ttc_add(w->graph, result, value) : ttc_multiply(w->graph, result, value);
        }
    }
    w->failed |= result == TTC_NONE;
    w->memo[id] = result;
    return result;
}

/* (prod b_i^e_i)' = sum_i e_i b_i' b_i^(e_i - 1) prod_{j != i} b_j^e_j */
static ttc_id derivative(walk *w, ttc_id id)
{
    if (id == TTC_NONE || w->failed) return TTC_NONE;
    if (w->memo[id] != TTC_NONE) return w->memo[id];
    ttc_kind kind = ttc_kind_of(w->graph, id);
    ttc_id zero = ttc_integer(w->graph, 0), result = zero;
    if (kind == TTC_SYMBOL) {
        result = w->map(w->context, ttc_symbol_of(w->graph, id));
        if (result == TTC_NONE) result = zero;
    }
    for (size_t i = 0; i < ttc_part_count(w->graph, id); i++) {
        ttc_part part = ttc_part_at(w->graph, id, i);
        ttc_id slope = derivative(w, part.id);
        if (slope == zero) continue;
        if (kind == TTC_PRODUCT) {
            ttc_id rest = ttc_divide(w->graph, id, part.id);
            slope = ttc_multiply(w->graph, slope, rest);
            slope = ttc_multiply(w->graph, ttc_integer(w->graph, part.exponent), slope);
        } else {
            slope = ttc_scale(w->graph, slope, part.coefficient);
        }
        result = ttc_add(w->graph, result, slope);
    }
    w->failed |= result == TTC_NONE;
    w->memo[id] = result;
    return result;
}

static ttc_id run(ttc_id (*visit)(walk *, ttc_id), ttc_graph *graph, ttc_id id, ttc_symbol_map map, void *context)
{
    walk w = { graph, map, context, calloc(ttc_graph_size(graph) + 1, sizeof(ttc_id)), false };
    if (w.memo == NULL) return TTC_NONE;
    ttc_id result = visit(&w, id);
    free(w.memo);
    return result;
}

ttc_id ttc_substitute(ttc_graph *graph, ttc_id id, ttc_symbol_map map, void *context)
{
    return run(substitute, graph, id, map, context);
}

ttc_id ttc_derivative(ttc_graph *graph, ttc_id id, ttc_symbol_map slope, void *context)
{
    return run(derivative, graph, id, slope, context);
}

static bool depends(const ttc_graph *graph, ttc_id id, uint32_t symbol, unsigned char *seen)
{
    if (seen[id]) return false;
    seen[id] = 1;
    if (ttc_kind_of(graph, id) == TTC_SYMBOL) return ttc_symbol_of(graph, id) == symbol;
    for (size_t i = 0; i < ttc_part_count(graph, id); i++)
        if (depends(graph, ttc_part_at(graph, id, i).id, symbol, seen)) return true;
    return false;
}

bool ttc_depends(const ttc_graph *graph, ttc_id id, uint32_t symbol)
{
    unsigned char *seen = calloc(ttc_graph_size(graph) + 1, 1);
    bool result = seen == NULL || depends(graph, id, symbol, seen);
    free(seen);
    return result;
}
