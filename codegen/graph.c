#include "graph.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    ttc_kind kind;
    uint32_t symbol;
    uint32_t count;
    uint32_t hash;
    ttc_id next; /* chain of equal hash bucket */
    fmpq_t coefficient;
    ttc_id *ids;
    int32_t *exponents;  /* PRODUCT */
    fmpq *coefficients;  /* SUM */
} node;

struct ttc_graph {
    node **nodes; /* each its own allocation, so that coefficients keep their address; nodes[0] is unused */
    size_t count, capacity;
    ttc_id *buckets;
    size_t bucket_count; /* a power of two */
    ttc_graph_status error;
    fmpq_t one;
};

/* A sum or product under construction: parts not yet sorted or merged. */
typedef struct {
    ttc_id *ids;
    long *exponents;
    fmpq *coefficients;
    size_t count, capacity;
} parts;

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

static void node_clear(node *n)
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
        node_clear(graph->nodes[i]);
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

static ttc_id fail(ttc_graph *graph, ttc_graph_status error)
{
    if (graph->error == TTC_GRAPH_OK) graph->error = error;
    return TTC_NONE;
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

static uint32_t hash_node(const node *n)
{
    uint32_t hash = mix(mix(17, (uint64_t)n->kind), n->symbol);
    hash = hash_rational(hash, n->coefficient);
    for (uint32_t i = 0; i < n->count; i++) {
        hash = mix(hash, n->ids[i]);
        if (n->kind == TTC_PRODUCT) hash = mix(hash, (uint64_t)(n->exponents[i] + TTC_EXPONENT_LIMIT));
        else hash = hash_rational(hash, n->coefficients + i);
    }
    return hash;
}

static bool same_node(const node *a, const node *b)
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
        node **nodes = realloc(graph->nodes, capacity * sizeof *nodes);
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

/* Takes ownership of what `n` holds. */
static ttc_id intern(ttc_graph *graph, node *n)
{
    n->hash = hash_node(n);
    for (ttc_id i = graph->buckets[n->hash & (graph->bucket_count - 1)]; i != TTC_NONE; i = graph->nodes[i]->next)
        if (same_node(graph->nodes[i], n)) {
            node_clear(n);
            return i;
        }
    bool full = graph->count > TTC_NODE_LIMIT;
    node *kept = full || !grow(graph) ? NULL : malloc(sizeof *kept);
    if (kept == NULL) {
        node_clear(n);
        return fail(graph, full ? TTC_GRAPH_TOO_LARGE : TTC_GRAPH_NO_MEMORY);
    }
    ttc_id *bucket = &graph->buckets[n->hash & (graph->bucket_count - 1)];
    n->next = *bucket;
    *kept = *n;
    graph->nodes[graph->count] = kept;
    *bucket = (ttc_id)graph->count;
    return (ttc_id)graph->count++;
}

ttc_id ttc_number(ttc_graph *graph, const fmpq_t value)
{
    node n = { .kind = TTC_NUMBER };
    fmpq_init(n.coefficient);
    fmpq_set(n.coefficient, value);
    return intern(graph, &n);
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
    node n = { .kind = TTC_SYMBOL, .symbol = symbol };
    fmpq_init(n.coefficient);
    return intern(graph, &n);
}

static bool parts_reserve(parts *p, size_t capacity)
{
    if (capacity <= p->capacity) return true;
    capacity = capacity < 2 * p->capacity ? 2 * p->capacity : capacity;
    ttc_id *ids = realloc(p->ids, capacity * sizeof *ids);
    if (ids != NULL) p->ids = ids;
    long *exponents = realloc(p->exponents, capacity * sizeof *exponents);
    if (exponents != NULL) p->exponents = exponents;
    fmpq *coefficients = realloc(p->coefficients, capacity * sizeof *coefficients);
    if (coefficients != NULL) p->coefficients = coefficients;
    if (ids == NULL || exponents == NULL || coefficients == NULL) return false;
    for (size_t i = p->capacity; i < capacity; i++) fmpq_init(p->coefficients + i);
    p->capacity = capacity;
    return true;
}

static void parts_clear(parts *p)
{
    for (size_t i = 0; i < p->capacity; i++) fmpq_clear(p->coefficients + i);
    free(p->coefficients);
    free(p->exponents);
    free(p->ids);
}

/* Position of id in the ascending list, or where it belongs. */
static size_t find(const parts *p, ttc_id id)
{
    size_t low = 0, high = p->count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (p->ids[middle] < id) low = middle + 1;
        else high = middle;
    }
    return low;
}

static bool insert_at(parts *p, size_t at, ttc_id id)
{
    if (!parts_reserve(p, p->count + 1)) return false;
    for (size_t i = p->count; i > at; i--) {
        p->ids[i] = p->ids[i - 1];
        p->exponents[i] = p->exponents[i - 1];
        fmpq_swap(p->coefficients + i, p->coefficients + i - 1);
    }
    p->ids[at] = id;
    p->exponents[at] = 0;
    fmpq_zero(p->coefficients + at);
    p->count++;
    return true;
}

static void remove_at(parts *p, size_t at)
{
    p->count--;
    for (size_t i = at; i < p->count; i++) {
        p->ids[i] = p->ids[i + 1];
        p->exponents[i] = p->exponents[i + 1];
        fmpq_swap(p->coefficients + i, p->coefficients + i + 1);
    }
}

static bool add_term(parts *p, ttc_id id, const fmpq *coefficient)
{
    size_t at = find(p, id);
    if ((at == p->count || p->ids[at] != id) && !insert_at(p, at, id)) return false;
    fmpq_add(p->coefficients + at, p->coefficients + at, coefficient);
    if (fmpq_is_zero(p->coefficients + at)) remove_at(p, at);
    return true;
}

static bool add_factor(parts *p, ttc_id id, long exponent)
{
    size_t at = find(p, id);
    if ((at == p->count || p->ids[at] != id) && !insert_at(p, at, id)) return false;
    p->exponents[at] += exponent;
    if (p->exponents[at] == 0) remove_at(p, at);
    return true;
}

static ttc_id build_product(ttc_graph *graph, const parts *p, const fmpq_t coefficient)
{
    if (fmpq_is_zero(coefficient)) return ttc_integer(graph, 0);
    if (p->count == 0) return ttc_number(graph, coefficient);
    for (size_t i = 0; i < p->count; i++)
        if (p->exponents[i] > TTC_EXPONENT_LIMIT || p->exponents[i] < -TTC_EXPONENT_LIMIT)
            return fail(graph, TTC_GRAPH_EXPONENT);
    if (p->count == 1 && p->exponents[0] == 1 && fmpq_is_one(coefficient)) return p->ids[0];
    if (p->count == 1 && p->exponents[0] == 1 && graph->nodes[p->ids[0]]->kind == TTC_SUM)
        return ttc_scale(graph, p->ids[0], coefficient);
    node n = { .kind = TTC_PRODUCT, .count = (uint32_t)p->count };
    fmpq_init(n.coefficient);
    fmpq_set(n.coefficient, coefficient);
    n.ids = malloc(p->count * sizeof *n.ids);
    n.exponents = malloc(p->count * sizeof *n.exponents);
    if (n.ids == NULL || n.exponents == NULL) {
        n.count = 0;
        node_clear(&n);
        return fail(graph, TTC_GRAPH_NO_MEMORY);
    }
    for (size_t i = 0; i < p->count; i++) {
        n.ids[i] = p->ids[i];
        n.exponents[i] = (int32_t)p->exponents[i];
    }
    return intern(graph, &n);
}

static ttc_id build_sum(ttc_graph *graph, const parts *p, const fmpq_t constant)
{
    if (p->count == 0) return ttc_number(graph, constant);
    if (p->count == 1 && fmpq_is_zero(constant)) {
        fmpq_t coefficient;
        fmpq_init(coefficient);
        fmpq_set(coefficient, p->coefficients);
        ttc_id id = p->ids[0];
        if (!fmpq_is_one(coefficient)) id = ttc_scale(graph, id, coefficient);
        fmpq_clear(coefficient);
        return id;
    }
    node n = { .kind = TTC_SUM, .count = 0 };
    fmpq_init(n.coefficient);
    fmpq_set(n.coefficient, constant);
    n.ids = malloc(p->count * sizeof *n.ids);
    n.coefficients = malloc(p->count * sizeof *n.coefficients);
    if (n.ids == NULL || n.coefficients == NULL) {
        node_clear(&n);
        return fail(graph, TTC_GRAPH_NO_MEMORY);
    }
    for (; n.count < p->count; n.count++) {
        n.ids[n.count] = p->ids[n.count];
        fmpq_init(n.coefficients + n.count);
        fmpq_set(n.coefficients + n.count, p->coefficients + n.count);
    }
    return intern(graph, &n);
}

/* The coefficient-free part of a PRODUCT. */
static ttc_id strip(ttc_graph *graph, ttc_id id)
{
    const node *n = graph->nodes[id];
    parts p = { 0 };
    ttc_id stripped = TTC_NONE;
    if (parts_reserve(&p, n->count)) {
        for (; p.count < n->count; p.count++) {
            p.ids[p.count] = n->ids[p.count];
            p.exponents[p.count] = n->exponents[p.count];
        }
        stripped = build_product(graph, &p, graph->one);
    } else {
        fail(graph, TTC_GRAPH_NO_MEMORY);
    }
    parts_clear(&p);
    return stripped;
}

/* Add weight * id to a sum under construction. */
static bool accumulate(ttc_graph *graph, parts *p, fmpq_t constant, ttc_id id, const fmpq *weight)
{
    bool ok = true;
    fmpq_t c;
    fmpq_init(c);
    switch (graph->nodes[id]->kind) {
    case TTC_NUMBER:
        fmpq_addmul(constant, weight, graph->nodes[id]->coefficient);
        break;
    case TTC_SYMBOL:
        ok = add_term(p, id, weight);
        break;
    case TTC_PRODUCT:
        fmpq_mul(c, weight, graph->nodes[id]->coefficient);
        if (!fmpq_is_one(graph->nodes[id]->coefficient)) id = strip(graph, id);
        ok = id != TTC_NONE && add_term(p, id, c);
        break;
    case TTC_SUM:
        fmpq_addmul(constant, weight, graph->nodes[id]->coefficient);
        for (uint32_t i = 0; ok && i < graph->nodes[id]->count; i++) {
            fmpq_mul(c, weight, graph->nodes[id]->coefficients + i);
            ok = add_term(p, graph->nodes[id]->ids[i], c);
        }
        break;
    }
    fmpq_clear(c);
    return ok;
}

static ttc_id combine(ttc_graph *graph, ttc_id a, const fmpq *weight_a, ttc_id b, const fmpq *weight_b)
{
    if (a == TTC_NONE || b == TTC_NONE) return TTC_NONE;
    parts p = { 0 };
    fmpq_t constant;
    fmpq_init(constant);
    ttc_id id = TTC_NONE;
    if (accumulate(graph, &p, constant, a, weight_a) && accumulate(graph, &p, constant, b, weight_b))
        id = build_sum(graph, &p, constant);
    else
        fail(graph, TTC_GRAPH_NO_MEMORY);
    fmpq_clear(constant);
    parts_clear(&p);
    return id;
}

ttc_id ttc_add(ttc_graph *graph, ttc_id a, ttc_id b) { return combine(graph, a, graph->one, b, graph->one); }

ttc_id ttc_subtract(ttc_graph *graph, ttc_id a, ttc_id b)
{
    fmpq_t minus;
    fmpq_init(minus);
    fmpq_set_si(minus, -1, 1);
    ttc_id id = combine(graph, a, graph->one, b, minus);
    fmpq_clear(minus);
    return id;
}

/* A sum is split into its content (with the sign of its leading term) and a primitive sum, so that 2*a + 2*b and
 * a + b share the base a + b in a product. */
static void content(const node *n, fmpq_t c)
{
    fmpq_set(c, n->coefficients);
    for (uint32_t i = 1; i < n->count; i++) fmpq_gcd(c, c, n->coefficients + i);
    if (!fmpq_is_zero(n->coefficient)) fmpq_gcd(c, c, n->coefficient);
    fmpq_abs(c, c);
    if (fmpq_sgn(n->coefficients) < 0) fmpq_neg(c, c);
}

/* Multiply a product under construction by id^exponent. */
static bool raise_base(ttc_graph *graph, parts *p, fmpq_t coefficient, ttc_id id, long exponent)
{
    bool ok = true;
    fmpq_t c;
    fmpq_init(c);
    switch (graph->nodes[id]->kind) {
    case TTC_SYMBOL:
        ok = add_factor(p, id, exponent);
        break;
    case TTC_SUM:
        content(graph->nodes[id], c);
        if (!fmpq_is_one(c)) {
            fmpq_t inverse;
            fmpq_init(inverse);
            fmpq_inv(inverse, c);
            id = ttc_scale(graph, id, inverse);
            fmpq_clear(inverse);
            fmpq_pow_si(c, c, exponent);
            fmpq_mul(coefficient, coefficient, c);
        }
        ok = id != TTC_NONE && add_factor(p, id, exponent);
        break;
    case TTC_NUMBER:
    case TTC_PRODUCT:
        fmpq_pow_si(c, graph->nodes[id]->coefficient, exponent);
        fmpq_mul(coefficient, coefficient, c);
        for (uint32_t i = 0; ok && i < graph->nodes[id]->count; i++)
            ok = add_factor(p, graph->nodes[id]->ids[i], graph->nodes[id]->exponents[i] * exponent);
        break;
    }
    fmpq_clear(c);
    return ok;
}

static ttc_id multiply_powers(ttc_graph *graph, ttc_id a, long exponent_a, ttc_id b, long exponent_b)
{
    if (a == TTC_NONE || b == TTC_NONE) return TTC_NONE;
    if (labs(exponent_a) > TTC_EXPONENT_LIMIT || labs(exponent_b) > TTC_EXPONENT_LIMIT)
        return fail(graph, TTC_GRAPH_EXPONENT);
    if ((ttc_is_number(graph, a, 0) && exponent_a < 0) || (ttc_is_number(graph, b, 0) && exponent_b < 0))
        return fail(graph, TTC_GRAPH_DIVISION_BY_ZERO);
    parts p = { 0 };
    fmpq_t coefficient;
    fmpq_init(coefficient);
    fmpq_one(coefficient);
    ttc_id id = TTC_NONE;
    if (raise_base(graph, &p, coefficient, a, exponent_a) && raise_base(graph, &p, coefficient, b, exponent_b))
        id = build_product(graph, &p, coefficient);
    else
        fail(graph, TTC_GRAPH_NO_MEMORY);
    fmpq_clear(coefficient);
    parts_clear(&p);
    return id;
}

ttc_id ttc_multiply(ttc_graph *graph, ttc_id a, ttc_id b) { return multiply_powers(graph, a, 1, b, 1); }
ttc_id ttc_divide(ttc_graph *graph, ttc_id a, ttc_id b) { return multiply_powers(graph, a, 1, b, -1); }

ttc_id ttc_power(ttc_graph *graph, ttc_id a, long exponent)
{
    return multiply_powers(graph, a, exponent, ttc_integer(graph, 1), 1);
}

ttc_id ttc_scale(ttc_graph *graph, ttc_id a, const fmpq_t factor)
{
    if (a == TTC_NONE) return TTC_NONE;
    if (graph->nodes[a]->kind != TTC_SUM) {
        ttc_id number = ttc_number(graph, factor);
        return multiply_powers(graph, a, 1, number, 1);
    }
    fmpq_t zero;
    fmpq_init(zero);
    ttc_id id = combine(graph, a, factor, ttc_integer(graph, 0), zero);
    fmpq_clear(zero);
    return id;
}

ttc_kind ttc_kind_of(const ttc_graph *graph, ttc_id id) { return graph->nodes[id]->kind; }
const fmpq *ttc_coefficient(const ttc_graph *graph, ttc_id id) { return graph->nodes[id]->coefficient; }
uint32_t ttc_symbol_of(const ttc_graph *graph, ttc_id id) { return graph->nodes[id]->symbol; }
size_t ttc_part_count(const ttc_graph *graph, ttc_id id) { return graph->nodes[id]->count; }

ttc_part ttc_part_at(const ttc_graph *graph, ttc_id id, size_t index)
{
    const node *n = graph->nodes[id];
    ttc_part part = { n->ids[index], 1, graph->one };
    if (n->kind == TTC_PRODUCT) part.exponent = n->exponents[index];
    else part.coefficient = n->coefficients + index;
    return part;
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
