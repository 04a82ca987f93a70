#include "expression/graph_node.h"

#include <stdlib.h>

ttc_graph *ttc_graph_create(void)
{
    ttc_graph *graph = calloc(1, sizeof *graph);
    if (graph == NULL) return NULL;
    graph->capacity = 256;
    graph->bucket_count = 1024;
    graph->nodes = calloc(graph->capacity, sizeof *graph->nodes);
    graph->buckets = calloc(graph->bucket_count, sizeof *graph->buckets);
    graph->count = 1;
    fmpq_init(graph->one);
    fmpq_one(graph->one);
    if (graph->nodes == NULL || graph->buckets == NULL) {
        graph->count = 0;
        ttc_graph_destroy(graph);
        return NULL;
    }
    return graph;
}

void ttc_node_clear(ttc_node *n)
{
    if (n->coefficients != NULL)
        for (uint32_t i = 0; i < n->count; i++) fmpq_clear(n->coefficients + i);
    free(n->coefficients);
    free(n->exponents);
    free(n->ids);
    fmpq_clear(n->coefficient);
}

void ttc_graph_destroy(ttc_graph *graph)
{
    if (graph == NULL) return;
    for (size_t i = 1; i < graph->count; i++) {
        ttc_node_clear(graph->nodes[i]);
        free(graph->nodes[i]);
    }
    free(graph->nodes);
    free(graph->buckets);
    fmpq_clear(graph->one);
    free(graph);
}

ttc_graph_status ttc_graph_error(const ttc_graph *graph) { return graph->error; }
void ttc_graph_clear_error(ttc_graph *graph) { graph->error = TTC_GRAPH_OK; }
size_t ttc_graph_size(const ttc_graph *graph) { return graph->count - 1; }

ttc_id ttc_graph_fail(ttc_graph *graph, ttc_graph_status error)
{
    if (graph->error == TTC_GRAPH_OK) graph->error = error;
    return TTC_NONE;
}

const char *ttc_graph_status_text(ttc_graph_status status)
{
    switch (status) {
    case TTC_GRAPH_OK: return "no error";
    case TTC_GRAPH_DIVISION_BY_ZERO: return "division by zero";
    case TTC_GRAPH_EXPONENT: return "a power passes 256";
    case TTC_GRAPH_COEFFICIENT: return "a number passes 4096 bits";
    case TTC_GRAPH_DEPTH: return "expressions nest deeper than 1024 levels";
    case TTC_GRAPH_TOO_LARGE: return "the expression is too large";
    case TTC_GRAPH_NO_MEMORY: return "out of memory";
    }
    return "unknown status";
}

static uint32_t mix(uint32_t hash, uint64_t value)
{
    uint64_t h = (hash ^ value) * UINT64_C(0x9E3779B97F4A7C15);
    return (uint32_t)(h >> 32) ^ (uint32_t)h;
}

static uint32_t hash_rational(uint32_t hash, const fmpq *q)
{
    hash = mix(hash, (uint64_t)fmpz_fdiv_ui(fmpq_numref(q), 4294967291u) + (fmpz_sgn(fmpq_numref(q)) < 0));
    return mix(hash, (uint64_t)fmpz_fdiv_ui(fmpq_denref(q), 4294967291u));
}

static uint32_t hash_node(const ttc_node *n)
{
    uint32_t hash = mix(mix(17, (uint64_t)n->kind), n->symbol);
    hash = hash_rational(hash, n->coefficient);
    for (uint32_t i = 0; i < n->count; i++) {
        hash = mix(hash, n->ids[i]);
        if (n->kind == TTC_PRODUCT) hash = mix(hash, (uint64_t)(n->exponents[i] + TTC_POWER_LIMIT));
        else hash = hash_rational(hash, n->coefficients + i);
    }
    return hash;
}

static bool same_node(const ttc_node *a, const ttc_node *b)
{
    if (a->kind != b->kind || a->symbol != b->symbol || a->count != b->count || a->hash != b->hash) return false;
    if (!fmpq_equal(a->coefficient, b->coefficient)) return false;
    for (uint32_t i = 0; i < a->count; i++) {
        if (a->ids[i] != b->ids[i]) return false;
        if (a->kind == TTC_PRODUCT && a->exponents[i] != b->exponents[i]) return false;
        if (a->kind == TTC_SUM && !fmpq_equal(a->coefficients + i, b->coefficients + i)) return false;
    }
    return true;
}

static bool grow(ttc_graph *graph)
{
    if (graph->count == graph->capacity) {
        size_t capacity = 2 * graph->capacity;
        ttc_node **nodes = realloc(graph->nodes, capacity * sizeof *nodes);
        if (nodes == NULL) return false;
        graph->nodes = nodes;
        graph->capacity = capacity;
    }
    if (graph->count > graph->bucket_count) {
        size_t bucket_count = 4 * graph->bucket_count;
        ttc_id *buckets = calloc(bucket_count, sizeof *buckets);
        if (buckets == NULL) return false;
        for (size_t i = 1; i < graph->count; i++) {
            ttc_id *bucket = &buckets[graph->nodes[i]->hash & (bucket_count - 1)];
            graph->nodes[i]->next = *bucket;
            *bucket = (ttc_id)i;
        }
        free(graph->buckets);
        graph->buckets = buckets;
        graph->bucket_count = bucket_count;
    }
    return true;
}

static size_t rational_bytes(const fmpq *q)
{
    return 2 * sizeof(fmpz) + sizeof(mp_limb_t) * ((size_t)fmpz_size(fmpq_numref(q)) + (size_t)fmpz_size(fmpq_denref(q)));
}

static size_t node_bytes(const ttc_node *n)
{
    size_t bytes = sizeof *n + sizeof n + rational_bytes(n->coefficient);
    for (uint32_t i = 0; i < n->count; i++)
        bytes += n->kind == TTC_SUM ? sizeof *n->ids + rational_bytes(n->coefficients + i)
                                    : sizeof *n->ids + sizeof *n->exponents;
    return bytes;
}

ttc_id ttc_graph_intern(ttc_graph *graph, ttc_node *n)
{
    n->hash = hash_node(n);
    for (ttc_id i = graph->buckets[n->hash & (graph->bucket_count - 1)]; i != TTC_NONE; i = graph->nodes[i]->next)
        if (same_node(graph->nodes[i], n)) {
            ttc_node_clear(n);
            return i;
        }
    size_t bytes = node_bytes(n);
    n->depth = 1;
    for (uint32_t i = 0; i < n->count; i++)
        if (graph->nodes[n->ids[i]]->depth >= n->depth) n->depth = graph->nodes[n->ids[i]]->depth + 1;
    ttc_graph_status status = TTC_GRAPH_OK;
    ttc_node *kept = NULL;
    if (n->depth > TTC_DEPTH_LIMIT) status = TTC_GRAPH_DEPTH;
    else if (graph->count > TTC_NODE_LIMIT || bytes > TTC_MEMORY_LIMIT - graph->bytes) status = TTC_GRAPH_TOO_LARGE;
    else if (!grow(graph) || (kept = malloc(sizeof *kept)) == NULL) status = TTC_GRAPH_NO_MEMORY;
    if (status != TTC_GRAPH_OK) {
        ttc_node_clear(n);
        return ttc_graph_fail(graph, status);
    }
    graph->bytes += bytes;
    ttc_id *bucket = &graph->buckets[n->hash & (graph->bucket_count - 1)];
    n->next = *bucket;
    *kept = *n;
    graph->nodes[graph->count] = kept;
    *bucket = (ttc_id)graph->count;
    return (ttc_id)graph->count++;
}

ttc_id ttc_number(ttc_graph *graph, const fmpq_t value)
{
    if (fmpq_height_bits(value) > TTC_COEFFICIENT_BITS) return ttc_graph_fail(graph, TTC_GRAPH_COEFFICIENT);
    ttc_node n = { .kind = TTC_NUMBER };
    fmpq_init(n.coefficient);
    fmpq_set(n.coefficient, value);
    return ttc_graph_intern(graph, &n);
}

ttc_id ttc_integer(ttc_graph *graph, long value)
{
    fmpq_t q;
    fmpq_init(q);
    fmpq_set_si(q, value, 1);
    ttc_id id = ttc_number(graph, q);
    fmpq_clear(q);
    return id;
}

ttc_id ttc_symbol(ttc_graph *graph, uint32_t symbol)
{
    ttc_node n = { .kind = TTC_SYMBOL, .symbol = symbol };
    fmpq_init(n.coefficient);
    return ttc_graph_intern(graph, &n);
}

ttc_kind ttc_kind_of(const ttc_graph *graph, ttc_id id) { return graph->nodes[id]->kind; }
const fmpq *ttc_coefficient(const ttc_graph *graph, ttc_id id) { return graph->nodes[id]->coefficient; }
uint32_t ttc_symbol_of(const ttc_graph *graph, ttc_id id) { return graph->nodes[id]->symbol; }
size_t ttc_part_count(const ttc_graph *graph, ttc_id id) { return graph->nodes[id]->count; }

ttc_part ttc_part_at(const ttc_graph *graph, ttc_id id, size_t index)
{
    const ttc_node *n = graph->nodes[id];
    ttc_part part = { n->ids[index], 1, graph->one };
    if (n->kind == TTC_PRODUCT) part.exponent = n->exponents[index];
    else part.coefficient = n->coefficients + index;
    return part;
}

const fmpq *ttc_number_value(const ttc_graph *graph, ttc_id id)
{
    return id != TTC_NONE && graph->nodes[id]->kind == TTC_NUMBER ? graph->nodes[id]->coefficient : NULL;
}

bool ttc_is_number(const ttc_graph *graph, ttc_id id, long value)
{
    if (graph->nodes[id]->kind != TTC_NUMBER) return false;
    fmpq_t q;
    fmpq_init(q);
    fmpq_set_si(q, value, 1);
    bool equal = fmpq_equal(graph->nodes[id]->coefficient, q) != 0;
    fmpq_clear(q);
    return equal;
}
