/* Walks over the graph: substitution, derivative, dependence. Parts have smaller ids than their node, so that one sweep
 * down marks all nodes reachable from a node, and one sweep up visits parts before what contains them, without recursion. */
#include "expression/graph_node.h"

#include <stdlib.h>

typedef struct {
    ttc_graph *graph;
    ttc_symbol_map map;               /* in a plain walk */
    ttc_symbol_definition definition; /* in a walk through definitions, with value; else NULL */
    ttc_symbol_value value;
    void *context;
    ttc_id *memo; /* result for each node that was visited, by its id */
    ttc_id *ids;  /* parts of the node under construction */
    long *exponents;
    fmpq *weights; /* borrowed from nodes, not to be cleared */
} walk;

static unsigned char *mark_reachable(const ttc_graph *graph, ttc_id id, ttc_symbol_definition definition, void *context)
{
    unsigned char *seen = calloc((size_t)id + 1, 1);
    if (seen == NULL) return NULL;
    seen[id] = 1;
    for (ttc_id at = id; at > 0; at--) {
        if (!seen[at]) continue;
        for (size_t i = 0; i < ttc_part_count(graph, at); i++) seen[ttc_part_at(graph, at, i).id] = 1;
        if (definition != NULL && ttc_kind_of(graph, at) == TTC_SYMBOL)
            seen[definition(context, ttc_symbol_of(graph, at))] = 1; /* TTC_NONE marks the unused entry 0 */
    }
    return seen;
}

static ttc_id symbol_value(walk *w, ttc_id id)
{
    uint32_t symbol = ttc_symbol_of(w->graph, id);
    if (w->definition == NULL) return w->map(w->context, symbol);
    ttc_id definition = w->definition(w->context, symbol);
    return w->value(w->context, symbol, definition == TTC_NONE ? TTC_NONE : w->memo[definition]);
}

static ttc_id substitute(walk *w, ttc_id id)
{
    ttc_kind kind = ttc_kind_of(w->graph, id);
    if (kind == TTC_NUMBER) return id;
    if (kind == TTC_SYMBOL) {
        ttc_id result = symbol_value(w, id);
        return result == TTC_NONE ? id : result;
    }
    size_t count = ttc_part_count(w->graph, id);
    bool changed = false;
    for (size_t i = 0; i < count; i++) {
        ttc_part part = ttc_part_at(w->graph, id, i);
        w->ids[i] = w->memo[part.id];
        w->exponents[i] = part.exponent;
        w->weights[i] = *part.coefficient;
        changed |= w->ids[i] != part.id;
    }
    if (!changed) return id;
    w->ids[count] = ttc_number(w->graph, ttc_coefficient(w->graph, id));
    w->exponents[count] = 1;
    w->weights[count] = (fmpq){ 1, 1 };
    return kind == TTC_SUM ? ttc_sum(w->graph, w->ids, w->weights, count + 1)
                           : ttc_product(w->graph, w->ids, w->exponents, count + 1);
}

/* (prod b_i^e_i)' = sum_i e_i b_i' b_i^(e_i - 1) prod_{j != i} b_j^e_j */
static ttc_id derivative(walk *w, ttc_id id)
{
    ttc_kind kind = ttc_kind_of(w->graph, id);
    ttc_id zero = ttc_integer(w->graph, 0);
    if (kind == TTC_SYMBOL) {
        ttc_id result = symbol_value(w, id);
        return result == TTC_NONE ? zero : result;
    }
    size_t count = 0;
    for (size_t i = 0; i < ttc_part_count(w->graph, id); i++) {
        ttc_part part = ttc_part_at(w->graph, id, i);
        ttc_id slope = w->memo[part.id];
        if (slope == zero) continue;
        w->weights[count] = kind == TTC_SUM ? *part.coefficient : (fmpq){ part.exponent, 1 };
        if (kind == TTC_PRODUCT) slope = ttc_multiply(w->graph, slope, ttc_divide(w->graph, id, part.id));
        w->ids[count++] = slope;
    }
    return ttc_sum(w->graph, w->ids, w->weights, count);
}

static ttc_id run(walk w, ttc_id (*visit)(walk *, ttc_id), ttc_id id)
{
    if (id == TTC_NONE) return TTC_NONE;
    ttc_graph *graph = w.graph;
    unsigned char *seen = mark_reachable(graph, id, w.definition, w.context);
    w.memo = calloc((size_t)id + 1, sizeof *w.memo);
    ttc_id result = TTC_NONE;
    size_t most = 1;
    for (ttc_id at = 1; seen != NULL && at <= id; at++)
        if (seen[at] && ttc_part_count(graph, at) >= most) most = ttc_part_count(graph, at) + 1;
    w.ids = malloc(most * sizeof *w.ids);
    w.exponents = malloc(most * sizeof *w.exponents);
    w.weights = malloc(most * sizeof *w.weights);
    if (seen == NULL || w.memo == NULL || w.ids == NULL || w.exponents == NULL || w.weights == NULL) {
        ttc_graph_fail(graph, TTC_GRAPH_NO_MEMORY);
        goto done;
    }
    for (ttc_id at = 1; at <= id; at++)
        if (seen[at] && (w.memo[at] = visit(&w, at)) == TTC_NONE) goto done;
    result = w.memo[id];
done:
    free(w.weights);
    free(w.exponents);
    free(w.ids);
    free(w.memo);
    free(seen);
    return result;
}

ttc_id ttc_substitute(ttc_graph *graph, ttc_id id, ttc_symbol_map map, void *context)
{
    return run((walk){ .graph = graph, .map = map, .context = context }, substitute, id);
}

ttc_id ttc_derivative(ttc_graph *graph, ttc_id id, ttc_symbol_map slope, void *context)
{
    return run((walk){ .graph = graph, .map = slope, .context = context }, derivative, id);
}

ttc_id ttc_substitute_through(ttc_graph *graph, ttc_id id, ttc_symbol_definition definition, ttc_symbol_value value,
                              void *context)
{
    return run((walk){ .graph = graph, .definition = definition, .value = value, .context = context }, substitute, id);
}

ttc_id ttc_derivative_through(ttc_graph *graph, ttc_id id, ttc_symbol_definition definition, ttc_symbol_value slope,
                              void *context)
{
    return run((walk){ .graph = graph, .definition = definition, .value = slope, .context = context }, derivative, id);
}

bool ttc_depends(const ttc_graph *graph, ttc_id id, uint32_t symbol)
{
    if (id == TTC_NONE) return false;
    unsigned char *seen = mark_reachable(graph, id, NULL, NULL);
    bool result = seen == NULL;
    for (ttc_id at = 1; !result && at <= id; at++)
        result = seen[at] && ttc_kind_of(graph, at) == TTC_SYMBOL && ttc_symbol_of(graph, at) == symbol;
    free(seen);
    return result;
}
