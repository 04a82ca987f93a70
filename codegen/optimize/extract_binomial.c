#include "optimize/extract_binomial.h"

#include <stdlib.h>
#include <string.h>

/* Beyond so many nodes scales are not divided by each other: the graph is bounded, and sums still need room in it. */
enum { RATIO_NODES = TTC_NODE_LIMIT / 2 };

/* scale_a = outer * inner_a, scale_b = outer * inner_b; where one scale is never zero, its inner part is 1. */
typedef struct ttc_scale_ratio {
    ttc_id scale_a, scale_b, outer, inner_a, inner_b;
} ratio;

static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * UINT64_C(0x9E3779B97F4A7C15);
    return hash ^ (hash >> 29);
}

static bool grow(ttc_scale_ratios *ratios)
{
    size_t capacity = ratios->capacity == 0 ? 256 : 4 * ratios->capacity;
    ratio *items = calloc(capacity, sizeof *items);
    if (items == NULL) return false;
    for (size_t i = 0; i < ratios->capacity; i++) {
        if (ratios->items[i].scale_a == TTC_NONE) continue;
        size_t at = (size_t)mix(mix(0, ratios->items[i].scale_a), ratios->items[i].scale_b) & (capacity - 1);
        while (items[at].scale_a != TTC_NONE) at = (at + 1) & (capacity - 1);
        items[at] = ratios->items[i];
    }
    free(ratios->items);
    ratios->items = items;
    ratios->capacity = capacity;
    return true;
}

void ttc_scale_ratios_clear(ttc_scale_ratios *ratios)
{
    free(ratios->items);
    *ratios = (ttc_scale_ratios){ 0 };
}

/* The common factor of two scales: common bases to the smaller power. */
static ttc_id common_scale(ttc_graph *graph, ttc_id a, ttc_id b)
{
    ttc_id common = ttc_integer(graph, 1);
    bool a_is_product = ttc_kind_of(graph, a) == TTC_PRODUCT, b_is_product = ttc_kind_of(graph, b) == TTC_PRODUCT;
    for (size_t i = 0; i < (a_is_product ? ttc_part_count(graph, a) : 1); i++)
        for (size_t j = 0; j < (b_is_product ? ttc_part_count(graph, b) : 1); j++) {
            ttc_part p = { a, 1, NULL }, q = { b, 1, NULL };
            if (a_is_product) p = ttc_part_at(graph, a, i);
            if (b_is_product) q = ttc_part_at(graph, b, j);
            if (p.id != q.id || ttc_kind_of(graph, p.id) == TTC_NUMBER || p.exponent < 0 || q.exponent < 0) continue;
            common = ttc_multiply(graph, common, ttc_power(graph, p.id, p.exponent < q.exponent ? p.exponent : q.exponent));
        }
    return common;
}

static const ratio *ratio_of(ttc_workspace *workspace, ttc_scale_ratios *ratios, ttc_id a, ttc_id b)
{
    ttc_graph *graph = workspace->field->graph;
    if (2 * ratios->count >= ratios->capacity && !grow(ratios)) {
        workspace->failed = true;
        return NULL;
    }
    size_t at = (size_t)mix(mix(0, a), b) & (ratios->capacity - 1);
    while (ratios->items[at].scale_a != TTC_NONE) {
        if (ratios->items[at].scale_a == a && ratios->items[at].scale_b == b) return ratios->items + at;
        at = (at + 1) & (ratios->capacity - 1);
    }
    ratio r = { a, b, a, workspace->one, workspace->one };
    if (a != b && ttc_graph_size(graph) > RATIO_NODES) {
        r.outer = workspace->one;
        r.inner_a = a;
        r.inner_b = b;
    } else if (a != b && ttc_scale_is_safe(workspace->field, a)) {
        r.inner_b = ttc_divide(graph, b, a);
    } else if (a != b && ttc_scale_is_safe(workspace->field, b)) {
        r.outer = b;
        r.inner_a = ttc_divide(graph, a, b);
    } else if (a != b) {
        r.outer = common_scale(graph, a, b);
        r.inner_a = ttc_divide(graph, a, r.outer);
        r.inner_b = ttc_divide(graph, b, r.outer);
    }
    if (r.outer == TTC_NONE || r.inner_a == TTC_NONE || r.inner_b == TTC_NONE) {
        workspace->failed = true;
        return NULL;
    }
    ratios->items[at] = r;
    ratios->count++;
    return ratios->items + at;
}

/* Split the factors into those of both cubes and those of one alone. */
static void split(const ttc_workspace *workspace, ttc_binomial *s, const ttc_cube *a, const ttc_cube *b)
{
    s->common = s->rest_a = s->rest_b = ttc_cube_one(workspace);
    unsigned i = 0, j = 0;
    while (i < a->count || j < b->count) {
        if (j == b->count || (i < a->count && a->factors[i] < b->factors[j]))
            s->rest_a.factors[s->rest_a.count++] = a->factors[i++];
        else if (i == a->count || a->factors[i] > b->factors[j]) s->rest_b.factors[s->rest_b.count++] = b->factors[j++];
        else {
            s->common.factors[s->common.count++] = a->factors[i++];
            j++;
        }
    }
}

static int compare_rests(const ttc_cube *a, const ttc_cube *b)
{
    for (unsigned i = 0; i < a->count && i < b->count; i++)
        if (a->factors[i] != b->factors[i]) return a->factors[i] < b->factors[i] ? -1 : 1;
    return (int)a->count - (int)b->count;
}

bool ttc_binomial_of(ttc_workspace *workspace, ttc_scale_ratios *ratios, ttc_binomial *out, const ttc_cube *a, const ttc_cube *b)
{
    split(workspace, out, a, b);
    if (compare_rests(&out->rest_a, &out->rest_b) > 0) {
        ttc_cube rest = out->rest_a;
        out->rest_a = out->rest_b;
        out->rest_b = rest;
        const ttc_cube *swap = a;
        a = b;
        b = swap;
    }
    const ratio *r = ratio_of(workspace, ratios, a->scale, b->scale);
    if (r == NULL) return false;
    out->common.scale = r->outer;
    out->common.sign = a->sign;
    out->rest_a.scale = r->inner_a;
    out->rest_b.scale = r->inner_b;
    out->rest_b.sign = (int8_t)(a->sign * b->sign);
    return true;
}

static uint64_t hash_cube(uint64_t hash, const ttc_cube *cube)
{
    hash = mix(hash, cube->count);
    for (unsigned i = 0; i < cube->count; i++) hash = mix(hash, cube->factors[i]);
    return hash;
}

uint64_t ttc_binomial_key(const ttc_binomial *binomial)
{
    uint64_t key = hash_cube(hash_cube((uint64_t)(binomial->rest_b.sign + 2), &binomial->rest_a), &binomial->rest_b);
    key = mix(mix(key, binomial->rest_a.scale), binomial->rest_b.scale);
    /* Sign and count are combined by XOR above and may cancel: 1 - b could get the key of x - b. */
    return key ^ binomial->rest_a.count;
}

bool ttc_binomial_same(const ttc_binomial *a, const ttc_binomial *b)
{
    return ttc_cube_same_factors(&a->rest_a, &b->rest_a) && ttc_cube_same_factors(&a->rest_b, &b->rest_b)
           && a->rest_a.scale == b->rest_a.scale && a->rest_b.scale == b->rest_b.scale && a->rest_b.sign == b->rest_b.sign;
}
