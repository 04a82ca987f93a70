/* Construction of sums and products in normal form. */
#include "expression/graph_node.h"

#include <stdlib.h>

/* A sum or product under construction: parts in ascending order of id. */
typedef struct {
    ttc_id *ids;
    long *exponents;
    fmpq *coefficients;
    size_t count, capacity;
} parts;

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

/* Position of id in the ascending list, or the position at which it would be inserted. */
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

static bool insert_at(ttc_graph *graph, parts *p, size_t at, ttc_id id)
{
    if (p->count >= TTC_PART_LIMIT) {
        ttc_graph_fail(graph, TTC_GRAPH_TOO_LARGE);
        return false;
    }
    if (!parts_reserve(p, p->count + 1)) {
        ttc_graph_fail(graph, TTC_GRAPH_NO_MEMORY);
        return false;
    }
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

static bool fits(ttc_graph *graph, const fmpq *q)
{
    if (fmpq_height_bits(q) <= TTC_COEFFICIENT_BITS) return true;
    ttc_graph_fail(graph, TTC_GRAPH_COEFFICIENT);
    return false;
}

static bool add_term(ttc_graph *graph, parts *p, ttc_id id, const fmpq *coefficient)
{
    size_t at = find(p, id);
    if ((at == p->count || p->ids[at] != id) && !insert_at(graph, p, at, id)) return false;
    fmpq_add(p->coefficients + at, p->coefficients + at, coefficient);
    if (!fits(graph, p->coefficients + at)) return false;
    if (fmpq_is_zero(p->coefficients + at)) remove_at(p, at);
    return true;
}

static bool add_factor(ttc_graph *graph, parts *p, ttc_id id, long exponent)
{
    if (exponent == 0) return true;
    size_t at = find(p, id);
    if ((at == p->count || p->ids[at] != id) && !insert_at(graph, p, at, id)) return false;
    p->exponents[at] += exponent;
    if (p->exponents[at] == 0) remove_at(p, at);
    return true;
}

/* coefficient *= base^exponent. Refused before it is computed if the power would be far beyond TTC_COEFFICIENT_BITS. */
static bool multiply_power(ttc_graph *graph, fmpq_t coefficient, const fmpq *base, long exponent)
{
    if (fmpq_is_one(base)) return true;
    if (fmpq_height_bits(base) > 1 && (long)fmpq_height_bits(base) * labs(exponent) > 2 * TTC_COEFFICIENT_BITS) {
        ttc_graph_fail(graph, TTC_GRAPH_COEFFICIENT);
        return false;
    }
    fmpq_t power;
    fmpq_init(power);
    fmpq_pow_si(power, base, exponent);
    fmpq_mul(coefficient, coefficient, power);
    fmpq_clear(power);
    return fits(graph, coefficient);
}

static ttc_id build_product(ttc_graph *graph, const parts *p, const fmpq_t coefficient)
{
    if (fmpq_is_zero(coefficient)) return ttc_integer(graph, 0);
    if (p->count == 0) return ttc_number(graph, coefficient);
    for (size_t i = 0; i < p->count; i++)
        if (p->exponents[i] > TTC_POWER_LIMIT || p->exponents[i] < -TTC_POWER_LIMIT)
            return ttc_graph_fail(graph, TTC_GRAPH_EXPONENT);
    if (p->count == 1 && p->exponents[0] == 1 && fmpq_is_one(coefficient)) return p->ids[0];
    if (p->count == 1 && p->exponents[0] == 1 && graph->nodes[p->ids[0]]->kind == TTC_SUM)
        return ttc_scale(graph, p->ids[0], coefficient);
    ttc_node n = { .kind = TTC_PRODUCT, .count = (uint32_t)p->count };
    fmpq_init(n.coefficient);
    fmpq_set(n.coefficient, coefficient);
    n.ids = malloc(p->count * sizeof *n.ids);
    n.exponents = malloc(p->count * sizeof *n.exponents);
    if (n.ids == NULL || n.exponents == NULL) {
        n.count = 0;
        ttc_node_clear(&n);
        return ttc_graph_fail(graph, TTC_GRAPH_NO_MEMORY);
    }
    for (size_t i = 0; i < p->count; i++) {
        n.ids[i] = p->ids[i];
        n.exponents[i] = (int32_t)p->exponents[i];
    }
    return ttc_graph_intern(graph, &n);
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
    ttc_node n = { .kind = TTC_SUM, .count = 0 };
    fmpq_init(n.coefficient);
    fmpq_set(n.coefficient, constant);
    n.ids = malloc(p->count * sizeof *n.ids);
    n.coefficients = malloc(p->count * sizeof *n.coefficients);
    if (n.ids == NULL || n.coefficients == NULL) {
        ttc_node_clear(&n);
        return ttc_graph_fail(graph, TTC_GRAPH_NO_MEMORY);
    }
    for (; n.count < p->count; n.count++) {
        n.ids[n.count] = p->ids[n.count];
        fmpq_init(n.coefficients + n.count);
        fmpq_set(n.coefficients + n.count, p->coefficients + n.count);
    }
    return ttc_graph_intern(graph, &n);
}

/* A PRODUCT with its coefficient replaced by 1. */
static ttc_id strip(ttc_graph *graph, ttc_id id)
{
    const ttc_node *n = graph->nodes[id];
    parts p = { 0 };
    ttc_id stripped = TTC_NONE;
    if (parts_reserve(&p, n->count)) {
        for (; p.count < n->count; p.count++) {
            p.ids[p.count] = n->ids[p.count];
            p.exponents[p.count] = n->exponents[p.count];
        }
        stripped = build_product(graph, &p, graph->one);
    } else {
        ttc_graph_fail(graph, TTC_GRAPH_NO_MEMORY);
    }
    parts_clear(&p);
    return stripped;
}

/* Add weight * id to a sum under construction. */
static bool accumulate(ttc_graph *graph, parts *p, fmpq_t constant, ttc_id id, const fmpq *weight)
{
    if (fmpq_is_zero(weight)) return true;
    const ttc_node *n = graph->nodes[id];
    bool ok = true;
    fmpq_t c;
    fmpq_init(c);
    switch (n->kind) {
    case TTC_NUMBER: fmpq_addmul(constant, weight, n->coefficient); break;
    case TTC_SYMBOL: ok = add_term(graph, p, id, weight); break;
    case TTC_PRODUCT:
        fmpq_mul(c, weight, n->coefficient);
        if (!fmpq_is_one(n->coefficient)) id = strip(graph, id);
        ok = id != TTC_NONE && add_term(graph, p, id, c);
        break;
    case TTC_SUM:
        fmpq_addmul(constant, weight, n->coefficient);
        for (uint32_t i = 0; ok && i < n->count; i++) {
            fmpq_mul(c, weight, n->coefficients + i);
            ok = add_term(graph, p, n->ids[i], c);
        }
        break;
    }
    fmpq_clear(c);
    return ok && fits(graph, constant);
}

ttc_id ttc_sum(ttc_graph *graph, const ttc_id *terms, const fmpq *weights, size_t count)
{
    parts p = { 0 };
    fmpq_t constant;
    fmpq_init(constant);
    ttc_id id = TTC_NONE;
    bool ok = true;
    for (size_t i = 0; ok && i < count; i++)
        ok = terms[i] != TTC_NONE && accumulate(graph, &p, constant, terms[i], weights == NULL ? graph->one : weights + i);
    if (ok) id = build_sum(graph, &p, constant);
    fmpq_clear(constant);
    parts_clear(&p);
    return id;
}

ttc_id ttc_add(ttc_graph *graph, ttc_id a, ttc_id b)
{
    const ttc_id terms[2] = { a, b };
    return ttc_sum(graph, terms, NULL, 2);
}

ttc_id ttc_subtract(ttc_graph *graph, ttc_id a, ttc_id b)
{
    const ttc_id terms[2] = { a, b };
    const fmpq weights[2] = { { 1, 1 }, { -1, 1 } }; /* a small fmpz is its own value */
    return ttc_sum(graph, terms, weights, 2);
}

/* Content of a sum, with the sign of its first term. Products divide it out, so that 2*a + 2*b and a + b have one base there. */
static bool content(ttc_graph *graph, const ttc_node *n, fmpq_t c)
{
    fmpq_set(c, n->coefficients);
    for (uint32_t i = 1; i < n->count && fits(graph, c); i++) fmpq_gcd(c, c, n->coefficients + i);
    if (!fmpq_is_zero(n->coefficient)) fmpq_gcd(c, c, n->coefficient);
    fmpq_abs(c, c);
    if (fmpq_sgn(n->coefficients) < 0) fmpq_neg(c, c);
    return fits(graph, c);
}

/* Multiply a product under construction by id^exponent. */
static bool raise_base(ttc_graph *graph, parts *p, fmpq_t coefficient, ttc_id id, long exponent)
{
    const ttc_node *n = graph->nodes[id];
    if (n->kind == TTC_SYMBOL) return add_factor(graph, p, id, exponent);
    if (n->kind != TTC_SUM) {
        bool ok = multiply_power(graph, coefficient, n->coefficient, exponent);
        for (uint32_t i = 0; ok && i < n->count; i++)
            ok = add_factor(graph, p, n->ids[i], n->exponents[i] * exponent);
        return ok;
    }
    fmpq_t c;
    fmpq_init(c);
    bool ok = content(graph, n, c) && multiply_power(graph, coefficient, c, exponent);
    if (ok && !fmpq_is_one(c)) {
        fmpq_inv(c, c);
        id = ttc_scale(graph, id, c);
    }
    fmpq_clear(c);
    return ok && id != TTC_NONE && add_factor(graph, p, id, exponent);
}

ttc_id ttc_product(ttc_graph *graph, const ttc_id *bases, const long *exponents, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (bases[i] == TTC_NONE) return TTC_NONE;
        if (labs(exponents[i]) > TTC_POWER_LIMIT) return ttc_graph_fail(graph, TTC_GRAPH_EXPONENT);
        if (exponents[i] < 0 && ttc_is_number(graph, bases[i], 0)) return ttc_graph_fail(graph, TTC_GRAPH_DIVISION_BY_ZERO);
    }
    parts p = { 0 };
    fmpq_t coefficient;
    fmpq_init(coefficient);
    fmpq_one(coefficient);
    ttc_id id = TTC_NONE;
    bool ok = true;
    for (size_t i = 0; ok && i < count; i++) ok = raise_base(graph, &p, coefficient, bases[i], exponents[i]);
    if (ok) id = build_product(graph, &p, coefficient);
    fmpq_clear(coefficient);
    parts_clear(&p);
    return id;
}

ttc_id ttc_multiply(ttc_graph *graph, ttc_id a, ttc_id b)
{
    const ttc_id bases[2] = { a, b };
    const long exponents[2] = { 1, 1 };
    return ttc_product(graph, bases, exponents, 2);
}

ttc_id ttc_divide(ttc_graph *graph, ttc_id a, ttc_id b)
{
    const ttc_id bases[2] = { a, b };
    const long exponents[2] = { 1, -1 };
    return ttc_product(graph, bases, exponents, 2);
}

ttc_id ttc_power(ttc_graph *graph, ttc_id a, long exponent) { return ttc_product(graph, &a, &exponent, 1); }

ttc_id ttc_scale(ttc_graph *graph, ttc_id a, const fmpq_t factor)
{
    if (a == TTC_NONE) return TTC_NONE;
    if (graph->nodes[a]->kind == TTC_SUM) return ttc_sum(graph, &a, factor, 1);
    return ttc_multiply(graph, a, ttc_number(graph, factor));
}
