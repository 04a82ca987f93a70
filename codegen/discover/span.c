#include "discover/span.h"

#include <stdlib.h>
#include <string.h>

void ttc_knowns_add(ttc_knowns *knowns, const ttc_flow *flow, const char *name, const ttc_ratio *value, const ttc_ratio *cofactor,
                    int degree)
{
    knowns->items = flint_realloc(knowns->items, (knowns->count + 1) * sizeof *knowns->items);
    ttc_known *known = &knowns->items[knowns->count++];
    *known = (ttc_known){ .degree = degree };
    known->name = flint_malloc(strlen(name) + 1);
    strcpy(known->name, name);
    ttc_ratio_init(flow->ring, &known->value);
    ttc_ratio_set(flow->ring, &known->value, value);
    ttc_modular_ratio_set(&known->modular, flow->ring, value, flow->mod);
    if (cofactor != NULL) ttc_modular_ratio_set(&known->cofactor, flow->ring, cofactor, flow->mod);
}

void ttc_knowns_clear(ttc_knowns *knowns, const ttc_flow *flow)
{
    for (size_t i = 0; i < knowns->count; i++) {
        ttc_modular_ratio_clear(&knowns->items[i].cofactor);
        ttc_modular_ratio_clear(&knowns->items[i].modular);
        ttc_ratio_clear(flow->ring, &knowns->items[i].value);
        flint_free(knowns->items[i].name);
    }
    flint_free(knowns->items);
    *knowns = (ttc_knowns){ .count = 0 };
}

void ttc_knowns_reduce(ttc_knowns *knowns, const ttc_flow *flow)
{
    ttc_ratio rate;
    ttc_ratio_init(flow->ring, &rate);
    for (size_t i = 0; i < knowns->count; i++) {
        ttc_known *known = &knowns->items[i];
        ttc_modular_ratio_set(&known->modular, flow->ring, &known->value, flow->mod);
        if (known->cofactor.denominator.count == 0) continue;
        ttc_flow_logarithmic_rate(flow, &rate, &known->value);
        ttc_modular_ratio_set(&known->cofactor, flow->ring, &rate, flow->mod);
    }
    ttc_ratio_clear(flow->ring, &rate);
}

void ttc_span_init(ttc_span *span, size_t width, nmod_t mod) { *span = (ttc_span){ .mod = mod, .width = width }; }

void ttc_span_clear(ttc_span *span)
{
    flint_free(span->pivots);
    flint_free(span->rows);
    *span = (ttc_span){ .width = 0 };
}

bool ttc_span_add(ttc_span *span, const ulong *vector)
{
    const nmod_t mod = span->mod;
    if (span->count == span->capacity) {
        span->capacity = 2 * span->capacity + 8;
        span->rows = flint_realloc(span->rows, span->capacity * span->width * sizeof *span->rows);
        span->pivots = flint_realloc(span->pivots, span->capacity * sizeof *span->pivots);
    }
    ulong *row = span->rows + span->count * span->width;
    memcpy(row, vector, span->width * sizeof *row);
    for (size_t i = 0; i < span->count; i++) {
        const ulong factor = nmod_neg(row[span->pivots[i]], mod);
        if (factor != 0) _nmod_vec_scalar_addmul_nmod(row, span->rows + i * span->width, (slong)span->width, factor, mod);
    }
    size_t pivot = 0;
    while (pivot < span->width && row[pivot] == 0) pivot++;
    if (pivot == span->width) return false;
    _nmod_vec_scalar_mul_nmod(row, row, (slong)span->width, nmod_inv(row[pivot], mod), mod);
    span->pivots[span->count++] = pivot;
    return true;
}

void ttc_span_drop_last(ttc_span *span) { span->count--; }

bool ttc_points_draw(ttc_points *points, size_t count, const ttc_flow *flow, ulong *parameters, uint64_t *source)
{
    bool good = true;
    ulong *logarithmic = flint_calloc(flow->count + 1, sizeof *logarithmic);
    *points = (ttc_points){ .count = count, .width = flow->ring->variable_count };
    points->values = flint_calloc(count * points->width + 1, sizeof *points->values);
    for (size_t i = 0; good && i < count; i++) {
        good = ttc_flow_draw(flow, parameters, logarithmic, source);
        memcpy(points->values + i * points->width, parameters, points->width * sizeof *parameters);
    }
    flint_free(logarithmic);
    return good;
}

void ttc_points_clear(ttc_points *points)
{
    flint_free(points->values);
    *points = (ttc_points){ .count = 0 };
}

typedef struct {
    ttc_span *span;
    const ttc_knowns *knowns;
    const ttc_products *which;
    size_t count;        /* points */
    const ulong *values; /* of the knowns, shape (knowns, points) */
    const bool *usable;
    const ulong *cofactors;
    ulong wanted;
} products;

static void multiply(const products *p, ulong *product, size_t known)
{
    for (size_t i = 0; i < p->count; i++) product[i] = nmod_mul(product[i], p->values[known * p->count + i], p->span->mod);
}

static void extend(const products *p, size_t at, const ulong *vector, ulong cofactor, int left)
{
    if (at == p->knowns->count) {
        if (cofactor == p->wanted) ttc_span_add(p->span, vector);
        return;
    }
    extend(p, at + 1, vector, cofactor, left);
    const int degree = p->which->degrees[at];
    if (!p->usable[at] || p->which->single[at] || degree < 1 || degree > left) return;
    ulong *product = flint_malloc((p->count + 1) * sizeof *product);
    memcpy(product, vector, p->count * sizeof *product);
    for (; degree <= left; left -= degree) {
        multiply(p, product, at);
        cofactor = nmod_add(cofactor, p->cofactors[at], p->span->mod);
        extend(p, at + 1, product, cofactor, left - degree);
    }
    flint_free(product);
}

void ttc_span_add_products(ttc_span *span, const ttc_knowns *knowns, const ttc_points *points, const ttc_products *which,
                           ulong cofactor)
{
    const size_t count = points->count;
    ulong *values = flint_calloc(knowns->count * count + 1, sizeof *values), *begin = flint_calloc(count + 1, sizeof *begin);
    ulong *cofactors = flint_calloc(knowns->count + 1, sizeof *cofactors);
    bool *usable = flint_calloc(knowns->count + 1, sizeof *usable);
    for (size_t k = 0; k < knowns->count; k++) {
        const ttc_known *known = &knowns->items[k];
        usable[k] = true;
        for (size_t i = 0; i < count; i++)
            usable[k] &= ttc_modular_ratio_value(&values[k * count + i], &known->modular, points->values + i * points->width,
                                                 span->mod);
        if (known->cofactor.denominator.count > 0 && count > 0)
            usable[k] &= ttc_modular_ratio_value(&cofactors[k], &known->cofactor, points->values, span->mod);
    }
    const products p = { span, knowns, which, count, values, usable, cofactors, cofactor };
    for (size_t k = 0; k <= knowns->count; k++) { /* k: the single function, or none */
        const bool has_single = k < knowns->count;
        if (has_single && (!usable[k] || !which->single[k])) continue;
        const int left = which->budget - (has_single ? which->degrees[k] : 0);
        for (size_t i = 0; i < count; i++) begin[i] = 1;
        if (has_single) multiply(&p, begin, k);
        if (left >= 0) extend(&p, 0, begin, has_single ? cofactors[k] : 0, left);
    }
    flint_free(usable);
    flint_free(cofactors);
    flint_free(begin);
    flint_free(values);
}
