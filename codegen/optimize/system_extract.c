/* Greedy extraction of what is common, after the algebraic methods of logic synthesis (Brayton, Rudell, Sangiovanni-
 * Vincentelli, Wang 1987) carried over to polynomials (Hosangadi, Fallah, Kastner 2006): pairs of factors that occur in
 * several cubes, and pairs of terms that occur, up to a common factor, in one or several sums. Longer ones grow out of
 * pairs. Each step takes what saves most. */
#include "optimize/system.h"

#include <stdlib.h>

#define SCALE_FACTOR UINT32_C(0x80000000) /* marks a scale among factors; the rest is its graph id */

/* Two factors side by side in a cube, or two terms in a sum. */
typedef struct {
    uint64_t key;
    uint32_t variable;
    uint32_t first, second; /* factors, or positions of cubes */
    int32_t gain;           /* operations saved at this place */
    int32_t cost;           /* operations of the new unit */
} place;

typedef struct {
    place *items;
    size_t count, capacity;
} places;

/* scale_a, scale_b = outer * (inner_a, inner_b), one of the inner ones 1 where division is safe */
typedef struct {
    ttc_id scale_a, scale_b, outer, inner_a, inner_b;
} ratio;

typedef struct {
    ttc_system *system;
    places pairs, binomials;
    ratio *ratios; /* open addressing by (scale_a, scale_b) */
    size_t ratio_count, ratio_capacity;
    uint64_t random, work;
    unsigned noise;
} extractor;

/* terms a and b of a sum = common * outer * (inner_a * rest_a + relative sign * inner_b * rest_b) */
typedef struct {
    ttc_cube common, rest_a, rest_b;
} binomial;

static uint64_t next_random(extractor *e)
{
    uint64_t z = e->random += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

static uint64_t mix(uint64_t hash, uint64_t word)
{
    hash = (hash ^ word) * UINT64_C(0x9E3779B97F4A7C15);
    return hash ^ (hash >> 29);
}

static void add_place(extractor *e, places *list, place item)
{
    if (list->count == list->capacity) {
        size_t capacity = list->capacity == 0 ? 256 : 2 * list->capacity;
        place *items = realloc(list->items, capacity * sizeof *items);
        if (items == NULL) {
            e->system->failed = true;
            return;
        }
        list->items = items;
        list->capacity = capacity;
    }
    list->items[list->count++] = item;
    e->work++;
}

static int compare_places(const void *left, const void *right)
{
    const place *a = left, *b = right;
    if (a->key != b->key) return a->key < b->key ? -1 : 1;
    if (a->variable != b->variable) return a->variable < b->variable ? -1 : 1;
    if (a->first != b->first) return a->first < b->first ? -1 : 1;
    return a->second < b->second ? -1 : a->second > b->second;
}

static bool grow_ratios(extractor *e)
{
    size_t capacity = e->ratio_capacity == 0 ? 256 : 4 * e->ratio_capacity;
    ratio *ratios = calloc(capacity, sizeof *ratios);
    if (ratios == NULL) return false;
    for (size_t i = 0; i < e->ratio_capacity; i++) {
        if (e->ratios[i].scale_a == TTC_NONE) continue;
        size_t at = (size_t)mix(mix(0, e->ratios[i].scale_a), e->ratios[i].scale_b) & (capacity - 1);
        while (ratios[at].scale_a != TTC_NONE) at = (at + 1) & (capacity - 1);
        ratios[at] = e->ratios[i];
    }
    free(e->ratios);
    e->ratios = ratios;
    e->ratio_capacity = capacity;
    return true;
}

/* The part of a product that two scales share: equal bases, with the smaller power. */
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

static const ratio *ratio_of(extractor *e, ttc_id a, ttc_id b)
{
    ttc_graph *graph = e->system->field->graph;
    if (2 * e->ratio_count >= e->ratio_capacity && !grow_ratios(e)) {
        e->system->failed = true;
        return NULL;
    }
    size_t at = (size_t)mix(mix(0, a), b) & (e->ratio_capacity - 1);
    while (e->ratios[at].scale_a != TTC_NONE) {
        if (e->ratios[at].scale_a == a && e->ratios[at].scale_b == b) return e->ratios + at;
        at = (at + 1) & (e->ratio_capacity - 1);
    }
    ratio r = { a, b, a, e->system->one, e->system->one };
    if (a != b && ttc_scale_is_safe(e->system->field, a)) {
        r.inner_b = ttc_divide(graph, b, a);
    } else if (a != b && ttc_scale_is_safe(e->system->field, b)) {
        r.outer = b;
        r.inner_a = ttc_divide(graph, a, b);
    } else if (a != b) {
        r.outer = common_scale(graph, a, b);
        r.inner_a = ttc_divide(graph, a, r.outer);
        r.inner_b = ttc_divide(graph, b, r.outer);
    }
    if (r.outer == TTC_NONE || r.inner_a == TTC_NONE || r.inner_b == TTC_NONE) {
        e->system->failed = true;
        return NULL;
    }
    e->ratios[at] = r;
    e->ratio_count++;
    return e->ratios + at;
}

static void factor_pairs(extractor *e, uint32_t variable, const ttc_cube *cube)
{
    uint32_t factors[TTC_CUBE_LIMIT + 1];
    unsigned count = 0;
    for (; count < cube->count; count++) factors[count] = cube->factors[count];
    if (cube->scale != e->system->one) factors[count++] = SCALE_FACTOR | cube->scale;
    for (unsigned i = 0; i < count; i++) {
        if (i > 0 && factors[i] == factors[i - 1]) continue;
        unsigned power = 1;
        while (i + power < count && factors[i + power] == factors[i]) power++;
        for (unsigned k = 0; k < power / 2; k++)
            add_place(e, &e->pairs, (place){ (uint64_t)factors[i] << 32 | factors[i], variable, factors[i], factors[i], 1, 1 });
        for (unsigned j = i + power; j < count; j++) {
            if (j > i + power && factors[j] == factors[j - 1]) continue;
            unsigned other = 1;
            while (j + other < count && factors[j + other] == factors[j]) other++;
            for (unsigned k = 0; k < (power < other ? power : other); k++)
                add_place(e, &e->pairs, (place){ (uint64_t)factors[i] << 32 | factors[j], variable, factors[i], factors[j], 1, 1 });
        }
    }
}

static binomial split(const ttc_system *system, const ttc_cube *a, const ttc_cube *b)
{
    binomial s = { ttc_cube_one(system), ttc_cube_one(system), ttc_cube_one(system) };
    unsigned i = 0, j = 0;
    while (i < a->count || j < b->count) {
        if (j == b->count || (i < a->count && a->factors[i] < b->factors[j]))
            s.rest_a.factors[s.rest_a.count++] = a->factors[i++];
        else if (i == a->count || a->factors[i] > b->factors[j]) s.rest_b.factors[s.rest_b.count++] = b->factors[j++];
        else {
            s.common.factors[s.common.count++] = a->factors[i++];
            j++;
        }
    }
    return s;
}

static int compare_rests(const ttc_cube *a, const ttc_cube *b)
{
    for (unsigned i = 0; i < a->count && i < b->count; i++)
        if (a->factors[i] != b->factors[i]) return a->factors[i] < b->factors[i] ? -1 : 1;
    return (int)a->count - (int)b->count;
}

static uint64_t hash_cube(uint64_t hash, const ttc_cube *cube)
{
    hash = mix(hash, cube->count);
    for (unsigned i = 0; i < cube->count; i++) hash = mix(hash, cube->factors[i]);
    return hash;
}

/* The binomial of two terms in its normal form; false when there is nothing to gain from it. */
static bool normal_binomial(extractor *e, binomial *s, int *sign, const ttc_cube *a, const ttc_cube *b)
{
    *s = split(e->system, a, b);
    if (compare_rests(&s->rest_a, &s->rest_b) > 0) {
        ttc_cube rest = s->rest_a;
        s->rest_a = s->rest_b;
        s->rest_b = rest;
        const ttc_cube *swap = a;
        a = b;
        b = swap;
    }
    const ratio *r = ratio_of(e, a->scale, b->scale);
    if (r == NULL) return false;
    s->common.scale = r->outer;
    s->common.sign = a->sign;
    s->rest_a.scale = r->inner_a;
    s->rest_b.scale = r->inner_b;
    *sign = a->sign * b->sign;
    s->rest_b.sign = (int8_t)*sign;
    return true;
}

static void term_pairs(extractor *e, uint32_t variable, const ttc_polynomial *p)
{
    for (uint32_t i = 0; i < p->count; i++)
        for (uint32_t j = i + 1; j < p->count; j++) {
            binomial s;
            int sign = 1;
            if (!normal_binomial(e, &s, &sign, p->cubes + i, p->cubes + j)) return;
            uint64_t key = hash_cube(hash_cube((uint64_t)(sign + 2), &s.rest_a), &s.rest_b);
            key = mix(mix(key, s.rest_a.scale), s.rest_b.scale);
            int before = (int)ttc_cube_cost(e->system, p->cubes + i) + (int)ttc_cube_cost(e->system, p->cubes + j) + 1;
            ttc_cube after = s.common;
            ttc_cube_multiply(&after, 0);
            int cost = (int)ttc_cube_cost(e->system, &s.rest_a) + (int)ttc_cube_cost(e->system, &s.rest_b) + 1;
            add_place(e, &e->binomials, (place){ key, variable, i, j, before - (int)ttc_cube_cost(e->system, &after), cost });
        }
}

/* Gain of the places with one key; terms already spoken for in a sum do not count twice. */
static int gain_of(const place *items, size_t count)
{
    int gain = -items->cost;
    for (size_t i = 0; i < count; i++) {
        bool free_terms = true;
        for (size_t j = 0; j < i && free_terms; j++)
            free_terms = items[j].variable != items[i].variable
                         || (items[j].first != items[i].first && items[j].first != items[i].second
                             && items[j].second != items[i].first && items[j].second != items[i].second);
        if (free_terms) gain += items[i].gain;
    }
    return gain;
}

/* The first of the places worth most; count 0 when none is worth anything. */
static place *best_of(extractor *e, places *list, bool are_terms, uint64_t *best_score)
{
    place *best = NULL;
    if (list->count > 1) qsort(list->items, list->count, sizeof *list->items, compare_places);
    for (size_t i = 0, n = 0; i < list->count; i += n) {
        n = 1;
        while (i + n < list->count && list->items[i + n].key == list->items[i].key) n++;
        int gain = are_terms ? gain_of(list->items + i, n) : (int)n - 1;
        if (gain <= 0) continue;
        uint64_t score = (uint64_t)gain * 64 + (are_terms ? 8 : 0);
        if (e->noise > 0) score += next_random(e) % e->noise;
        if (score > *best_score) {
            *best_score = score;
            best = list->items + i;
        }
    }
    return best;
}

static void take_factor(ttc_system *system, ttc_cube *cube, uint32_t factor)
{
    if ((factor & SCALE_FACTOR) != 0) cube->scale = system->one;
    else ttc_cube_remove(cube, factor);
}

static bool has_factors(const ttc_cube *cube, uint32_t a, uint32_t b)
{
    if (a == b) return ttc_cube_power(cube, a) >= 2;
    bool has_a = (a & SCALE_FACTOR) != 0 ? cube->scale == (a & ~SCALE_FACTOR) : ttc_cube_power(cube, a) > 0;
    bool has_b = (b & SCALE_FACTOR) != 0 ? cube->scale == (b & ~SCALE_FACTOR) : ttc_cube_power(cube, b) > 0;
    return has_a && has_b;
}

static void extract_factors(extractor *e, uint32_t a, uint32_t b)
{
    ttc_system *system = e->system;
    uint32_t unit = ttc_system_add_variable(system, TTC_VARIABLE_UNIT, 0);
    if (system->failed) return;
    for (uint32_t v = 0; v < unit; v++)
        for (uint32_t i = 0; i < system->variables[v].definition.count; i++) {
            ttc_cube *cube = system->variables[v].definition.cubes + i;
            while (has_factors(cube, a, b)) {
                take_factor(system, cube, a);
                take_factor(system, cube, b);
                ttc_cube_multiply(cube, unit);
            }
        }
    ttc_cube product = ttc_cube_one(system);
    for (int k = 0; k < 2; k++) {
        uint32_t factor = k == 0 ? a : b;
        if ((factor & SCALE_FACTOR) != 0) product.scale = factor & ~SCALE_FACTOR;
        else ttc_cube_multiply(&product, factor);
    }
    system->variables[unit].is_extracted = true;
    ttc_polynomial_add(system, &system->variables[unit].definition, &product);
}

static bool same_binomial(const binomial *a, const binomial *b)
{
    return ttc_cube_same_factors(&a->rest_a, &b->rest_a) && ttc_cube_same_factors(&a->rest_b, &b->rest_b)
           && a->rest_a.scale == b->rest_a.scale && a->rest_b.scale == b->rest_b.scale && a->rest_b.sign == b->rest_b.sign;
}

static void extract_terms(extractor *e, const place *where)
{
    ttc_system *system = e->system;
    const ttc_polynomial *p = &system->variables[where->variable].definition;
    binomial wanted, found;
    int sign = 1;
    bool is_grouping = false;
    if (!normal_binomial(e, &wanted, &sign, p->cubes + where->first, p->cubes + where->second)) return;
    uint32_t unit = ttc_system_add_variable(system, TTC_VARIABLE_UNIT, 0);
    for (uint32_t v = 0; v < unit && !system->failed; v++) {
        ttc_polynomial *sum = &system->variables[v].definition;
        for (uint32_t i = 0; i < sum->count; i++)
            for (uint32_t j = i + 1; j < sum->count; j++) {
                if (!normal_binomial(e, &found, &sign, sum->cubes + i, sum->cubes + j)) return;
                if (!same_binomial(&wanted, &found) || !ttc_cube_multiply(&found.common, unit)) continue;
                sum->cubes[i] = found.common;
                ttc_polynomial_remove(sum, j);
                is_grouping |= sum->count == 1 && !system->variables[v].is_extracted && !system->variables[v].is_output;
                break;
            }
    }
    if (system->failed) return;
    /* What was a sum of the table's, or one side of a difference of squares, may not be multiplied out later. */
    system->variables[unit].is_extracted = !(is_grouping && system->field->keeps_digits);
    ttc_polynomial_add(system, &system->variables[unit].definition, &wanted.rest_a);
    ttc_polynomial_add(system, &system->variables[unit].definition, &wanted.rest_b);
}

static bool extract_best(extractor *e)
{
    ttc_system *system = e->system;
    uint64_t score = 0;
    e->pairs.count = e->binomials.count = 0;
    for (uint32_t v = 0; v < system->count && !system->failed; v++) {
        const ttc_polynomial *p = &system->variables[v].definition;
        for (uint32_t i = 0; i < p->count; i++) factor_pairs(e, v, p->cubes + i);
        term_pairs(e, v, p);
    }
    if (system->failed) return false;
    const place *pair = best_of(e, &e->pairs, false, &score);
    const place *terms = best_of(e, &e->binomials, true, &score);
    if (terms != NULL) {
        place chosen = *terms;
        extract_terms(e, &chosen);
    } else if (pair != NULL) {
        extract_factors(e, pair->first, pair->second);
    }
    return (terms != NULL || pair != NULL) && !system->failed;
}

uint64_t ttc_system_extract(ttc_system *system, uint64_t seed)
{
    extractor e = { .system = system, .random = seed };
    static const unsigned noises[] = { 32, 64, 96, 160 };
    e.noise = seed == 0 ? 0 : noises[seed % 4];
    while (extract_best(&e)) continue;
    free(e.pairs.items);
    free(e.binomials.items);
    free(e.ratios);
    return e.work;
}
