/* Greedy extraction of what is common, after the algebraic methods of logic synthesis (Brayton, Rudell, Sangiovanni-
 * Vincentelli, Wang 1987) carried over to polynomials (Hosangadi, Fallah, Kastner 2006): pairs of factors that occur in
 * several cubes, and pairs of terms that occur, up to a common factor, in one or several sums. Longer ones grow out of
 * pairs. Each step takes what saves most. What could be taken is kept in two indices, and a step renews only what concerns
 * the cubes that the step before it changed. */
#include "optimize/extract_binomial.h"
#include "optimize/extract_index.h"
#include "optimize/system.h"

#include <stdlib.h>

#define SCALE_FACTOR UINT32_C(0x80000000) /* marks a scale among factors; the rest is its graph id */

/* The sum of a variable. Positions of its cubes stay what they are: a cube that is gone has sign 0. */
typedef struct {
    size_t base;     /* of its cubes among `cubes` */
    uint32_t window; /* a term is compared with so many after it */
} sum;

typedef struct {
    uint32_t places;  /* head of the list of places, see ttc_extract_index_add */
    bool is_changed;  /* its places are removed, and come anew with the next step */
} cube_state;

/* A cube that holds a factor, or held it. */
typedef struct {
    uint32_t variable, position, next; /* next: 1 + index */
} occurrence;

typedef struct {
    uint32_t variable, position;
} cube_name;

typedef struct {
    ttc_system *system;
    ttc_scale_ratios own_ratios, *ratios;
    ttc_extract_index pairs, binomials;
    sum *sums; /* by variable */
    cube_state *cubes;
    uint32_t *first_occurrence; /* by variable: 1 + index */
    occurrence *occurrences;
    cube_name *changed;
    size_t sum_count, sum_capacity, cube_count, cube_capacity, factor_capacity, occurrence_count, occurrence_capacity;
    size_t changed_count, changed_capacity;
    uint64_t random, work;
    unsigned noise;
    uint64_t pair_limit;
    bool is_large;
} extractor;

static uint64_t next_random(extractor *e)
{
    uint64_t z = e->random += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

/* `items` with room for `wanted`; the old one, and the system failed, when memory is out. */
static void *grown(extractor *e, void *items, size_t size, size_t wanted, size_t *capacity)
{
    if (wanted <= *capacity) return items;
    size_t larger = 2 * wanted + 64;
    void *fresh = realloc(items, larger * size);
    e->system->failed |= fresh == NULL;
    if (fresh == NULL) return items;
    *capacity = larger;
    return fresh;
}

static ttc_polynomial *definition_of(const extractor *e, uint32_t variable)
{
    return &e->system->variables[variable].definition;
}

static cube_state *state_of(const extractor *e, uint32_t variable, uint32_t position)
{
    return e->cubes + e->sums[variable].base + position;
}

static uint32_t *head_of(void *context, uint32_t variable, uint32_t position)
{
    return &state_of(context, variable, position)->places;
}

static void note_occurrence(extractor *e, uint32_t factor, uint32_t variable, uint32_t position)
{
    e->occurrences = grown(e, e->occurrences, sizeof *e->occurrences, e->occurrence_count + 1, &e->occurrence_capacity);
    if (e->system->failed) return;
    e->occurrences[e->occurrence_count] = (occurrence){ variable, position, e->first_occurrence[factor] };
    e->first_occurrence[factor] = (uint32_t)++e->occurrence_count;
}

/* Count the pairs of factors of a cube, or take them off the count. */
static void count_pairs(extractor *e, const ttc_cube *cube, int by)
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
            ttc_extract_index_count(&e->pairs, (uint64_t)factors[i] << 32 | factors[i], by);
        for (unsigned j = i + power; j < count; j++) {
            if (j > i + power && factors[j] == factors[j - 1]) continue;
            unsigned other = 1;
            while (j + other < count && factors[j + other] == factors[j]) other++;
            for (unsigned k = 0; k < (power < other ? power : other); k++)
                ttc_extract_index_count(&e->pairs, (uint64_t)factors[i] << 32 | factors[j], by);
        }
    }
}

/* To be called before a cube is changed: what it takes part in is no longer there. */
static void retract(extractor *e, uint32_t variable, uint32_t position)
{
    cube_state *state = state_of(e, variable, position);
    if (state->is_changed) return;
    e->changed = grown(e, e->changed, sizeof *e->changed, e->changed_count + 1, &e->changed_capacity);
    if (e->system->failed) return;
    state->is_changed = true;
    e->changed[e->changed_count++] = (cube_name){ variable, position };
    count_pairs(e, definition_of(e, variable)->cubes + position, -1);
    ttc_extract_index_remove(&e->binomials, &state->places, head_of, e);
}

static void add_binomial(extractor *e, uint32_t variable, uint32_t first, uint32_t second)
{
    ttc_system *system = e->system;
    const ttc_cube *a = definition_of(e, variable)->cubes + first, *b = definition_of(e, variable)->cubes + second;
    ttc_binomial s;
    if (!ttc_binomial_of(system, e->ratios, &s, a, b)) return;
    int before = (int)ttc_cube_cost(system, a) + (int)ttc_cube_cost(system, b) + 1;
    ttc_cube after = s.common;
    ttc_cube_multiply(&after, 0);
    int cost = (int)ttc_cube_cost(system, &s.rest_a) + (int)ttc_cube_cost(system, &s.rest_b) + 1;
    uint32_t group = ttc_extract_index_group(&e->binomials, ttc_binomial_key(&s), cost);
    if (group == TTC_NO_GROUP) return;
    ttc_term_pair place = { .variable = variable, .first = first, .second = second,
                        .gain = before - (int)ttc_cube_cost(system, &after) };
    ttc_extract_index_add(&e->binomials, group, place, &state_of(e, variable, first)->places,
                          &state_of(e, variable, second)->places);
}

static int compare_names(const void *left, const void *right)
{
    const cube_name *a = left, *b = right;
    if (a->variable != b->variable) return a->variable < b->variable ? -1 : 1;
    return a->position < b->position ? -1 : a->position > b->position;
}

/* Pairs of terms of one sum of which one or both are changed, in the order of the sum; changed: `count` positions. */
static void add_binomials(extractor *e, const cube_name *changed, size_t count)
{
    uint32_t variable = changed[0].variable, window = e->sums[variable].window;
    const ttc_polynomial *p = definition_of(e, variable);
    for (uint32_t i = 0; i < p->count && !e->system->failed; i++) {
        uint32_t end = window < p->count - i ? i + window + 1 : p->count;
        if (p->cubes[i].sign == 0) continue;
        if (state_of(e, variable, i)->is_changed) {
            for (uint32_t j = i + 1; j < end && !e->system->failed; j++)
                if (p->cubes[j].sign != 0) add_binomial(e, variable, i, j);
        } else {
            for (size_t k = 0; k < count && !e->system->failed; k++)
                if (changed[k].position > i && changed[k].position < end && p->cubes[changed[k].position].sign != 0)
                    add_binomial(e, variable, i, changed[k].position);
        }
    }
}

/* What the cubes changed since the last step take part in now. */
static void renew(extractor *e)
{
    if (e->changed_count > 1) qsort(e->changed, e->changed_count, sizeof *e->changed, compare_names);
    for (size_t i = 0, n = 0; i < e->changed_count && !e->system->failed; i += n) {
        n = 1;
        while (i + n < e->changed_count && e->changed[i + n].variable == e->changed[i].variable) n++;
        for (size_t k = i; k < i + n; k++) {
            const ttc_cube *cube = definition_of(e, e->changed[k].variable)->cubes + e->changed[k].position;
            if (cube->sign != 0) count_pairs(e, cube, 1);
        }
        add_binomials(e, e->changed + i, n);
    }
    for (size_t i = 0; i < e->changed_count; i++)
        state_of(e, e->changed[i].variable, e->changed[i].position)->is_changed = false;
    e->changed_count = 0;
    ttc_extract_index_rank(&e->pairs);
    ttc_extract_index_rank(&e->binomials);
    e->system->failed |= e->pairs.failed || e->binomials.failed;
    e->work += e->pairs.members + e->binomials.members;
}

/* Take a variable's sum in: its cubes count as changed. */
static void enroll(extractor *e, uint32_t variable, uint32_t window)
{
    uint32_t count = definition_of(e, variable)->count;
    e->sums = grown(e, e->sums, sizeof *e->sums, (size_t)variable + 1, &e->sum_capacity);
    e->cubes = grown(e, e->cubes, sizeof *e->cubes, e->cube_count + count, &e->cube_capacity);
    e->first_occurrence = grown(e, e->first_occurrence, sizeof *e->first_occurrence, (size_t)variable + 1, &e->factor_capacity);
    e->changed = grown(e, e->changed, sizeof *e->changed, e->changed_count + count, &e->changed_capacity);
    if (e->system->failed) return;
    e->sums[variable] = (sum){ e->cube_count, window };
    for (; e->sum_count <= variable; e->sum_count++) e->first_occurrence[e->sum_count] = 0;
    for (uint32_t i = 0; i < count; i++) {
        e->cubes[e->cube_count++] = (cube_state){ 0, true };
        e->changed[e->changed_count++] = (cube_name){ variable, i };
    }
}

static void note_factors(extractor *e, uint32_t variable)
{
    for (uint32_t i = 0; i < definition_of(e, variable)->count; i++) {
        const ttc_cube *cube = definition_of(e, variable)->cubes + i;
        for (unsigned j = 0; j < cube->count && !e->system->failed; j++)
            if (j == 0 || cube->factors[j] != cube->factors[j - 1]) note_occurrence(e, cube->factors[j], variable, i);
    }
}

static int compare_cubes(const void *left, const void *right)
{
    const ttc_cube *a = left, *b = right;
    for (unsigned i = 0; i < a->count && i < b->count; i++)
        if (a->factors[i] != b->factors[i]) return a->factors[i] < b->factors[i] ? -1 : 1;
    if (a->count != b->count) return a->count < b->count ? -1 : 1;
    return a->scale < b->scale ? -1 : a->scale > b->scale;
}

/* All sums. Where they have more pairs of terms than the limit, terms with the same factors are put side by side, and each
 * is compared with the next ones alone. */
static void begin(extractor *e)
{
    ttc_system *system = e->system;
    uint64_t pairs = 0, terms = 1;
    for (uint32_t v = 0; v < system->count; v++) {
        uint64_t n = definition_of(e, v)->count;
        pairs += n * (n - 1) / 2;
        terms += n;
    }
    e->is_large = pairs > e->pair_limit;
    uint32_t window = e->is_large ? (uint32_t)(e->pair_limit / terms) + 1 : UINT32_MAX;
    for (uint32_t v = 0; v < system->count && !system->failed; v++) {
        ttc_polynomial *p = definition_of(e, v);
        if (p->count > window) qsort(p->cubes, p->count, sizeof *p->cubes, compare_cubes);
        enroll(e, v, window);
    }
    for (uint32_t v = 0; v < system->count && !system->failed; v++) note_factors(e, v);
}

static void take_factor(ttc_system *system, ttc_cube *cube, uint32_t factor)
{
    if ((factor & SCALE_FACTOR) != 0) cube->scale = system->one;
    else ttc_cube_remove(cube, factor);
}

static bool has_factors(const ttc_cube *cube, uint32_t a, uint32_t b)
{
    if (a == b) return ttc_cube_power(cube, a) >= 2;
    bool has_b = (b & SCALE_FACTOR) != 0 ? cube->scale == (b & ~SCALE_FACTOR) : ttc_cube_power(cube, b) > 0;
    return has_b && ttc_cube_power(cube, a) > 0;
}

static uint32_t add_unit(extractor *e)
{
    uint32_t unit = ttc_system_add_variable(e->system, TTC_VARIABLE_UNIT, 0);
    if (e->system->failed) return unit;
    e->system->variables[unit].is_extracted = true;
    enroll(e, unit, UINT32_MAX);
    return unit;
}

static void define_unit(extractor *e, uint32_t unit, const ttc_cube *cubes, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) ttc_polynomial_add(e->system, definition_of(e, unit), cubes + i);
    if (e->system->failed) return;
    enroll(e, unit, UINT32_MAX);
    note_factors(e, unit);
}

/* a, a variable, times b, a variable or a scale, becomes a unit. */
static void extract_factors(extractor *e, uint32_t a, uint32_t b)
{
    ttc_system *system = e->system;
    uint32_t unit = add_unit(e);
    for (uint32_t o = system->failed ? 0 : e->first_occurrence[a]; o != 0 && !system->failed;) {
        occurrence at = e->occurrences[o - 1];
        ttc_cube *cube = definition_of(e, at.variable)->cubes + at.position;
        o = at.next;
        if (cube->sign == 0 || !has_factors(cube, a, b)) continue;
        retract(e, at.variable, at.position);
        while (has_factors(cube, a, b)) {
            take_factor(system, cube, a);
            take_factor(system, cube, b);
            ttc_cube_multiply(cube, unit);
        }
        if (!system->failed) note_occurrence(e, unit, at.variable, at.position);
    }
    ttc_cube product = ttc_cube_one(system);
    ttc_cube_multiply(&product, a);
    if ((b & SCALE_FACTOR) != 0) product.scale = b & ~SCALE_FACTOR;
    else ttc_cube_multiply(&product, b);
    if (!system->failed) define_unit(e, unit, &product, 1);
}

/* One term is left; taken ones have no sign. */
static bool is_single(const ttc_polynomial *p)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < p->count; i++) count += p->cubes[i].sign != 0;
    return count == 1;
}

/* The sum of two terms becomes a unit wherever it stands. */
static void extract_terms(extractor *e, uint32_t group)
{
    ttc_system *system = e->system;
    uint32_t count = e->binomials.groups[group].size;
    ttc_term_pair *places = malloc((count + 1) * sizeof *places);
    ttc_binomial wanted, found;
    bool is_grouping = false;
    system->failed |= places == NULL;
    uint32_t unit = system->failed ? 0 : add_unit(e);
    if (!system->failed) ttc_extract_index_places(&e->binomials, group, places);
    for (uint32_t i = 0; i < count && !system->failed; i++) {
        const ttc_term_pair *at = places + i;
        ttc_polynomial *p = definition_of(e, at->variable);
        if (state_of(e, at->variable, at->first)->is_changed || state_of(e, at->variable, at->second)->is_changed) continue;
        if (!ttc_binomial_of(system, e->ratios, i == 0 ? &wanted : &found, p->cubes + at->first, p->cubes + at->second)) break;
        if (i == 0) found = wanted;
        if (!ttc_binomial_same(&wanted, &found) || !ttc_cube_multiply(&found.common, unit)) continue;
        retract(e, at->variable, at->first);
        retract(e, at->variable, at->second);
        p->cubes[at->first] = found.common;
        p->cubes[at->second].sign = 0;
        is_grouping |= is_single(p) && !system->variables[at->variable].is_extracted && !system->variables[at->variable].is_output;
        if (!system->failed) note_occurrence(e, unit, at->variable, at->first);
    }
    free(places);
    const ttc_cube rests[] = { wanted.rest_a, wanted.rest_b };
    /* What was a sum of the table's, or one side of a difference of squares, may not be multiplied out later. */
    if (!system->failed && is_grouping && system->field->keeps_digits) system->variables[unit].is_extracted = false;
    if (!system->failed) define_unit(e, unit, rests, 2);
}

/* The first of the groups worth most; NULL when none is worth anything. */
static const ttc_ranked *best_of(extractor *e, const ttc_extract_index *index, unsigned bonus, uint64_t *best_score)
{
    const ttc_ranked *best = NULL;
    for (size_t i = 0; i < index->ranked_count; i++) {
        uint64_t score = (uint64_t)index->ranked[i].gain * 64 + bonus;
        if (e->noise > 0) score += next_random(e) % e->noise;
        if (score <= *best_score) continue;
        *best_score = score;
        best = index->ranked + i;
    }
    return best;
}

static void extract_ranked(extractor *e, bool are_terms, const ttc_ranked *chosen)
{
    if (are_terms) extract_terms(e, chosen->group);
    else extract_factors(e, (uint32_t)(chosen->key >> 32), (uint32_t)chosen->key);
}

/* All groups that gain as much as `chosen`, the first of them, as long as nothing taken before touches them. */
static void extract_all(extractor *e, bool are_terms, const ttc_ranked *chosen)
{
    const ttc_extract_index *index = are_terms ? &e->binomials : &e->pairs;
    int32_t gain = chosen->gain;
    for (size_t i = (size_t)(chosen - index->ranked); i < index->ranked_count && !e->system->failed; i++)
        if (index->ranked[i].gain == gain && !index->groups[index->ranked[i].group].is_changed)
            extract_ranked(e, are_terms, index->ranked + i);
}

static bool extract_best(extractor *e)
{
    uint64_t score = 0;
    renew(e);
    if (e->system->failed) return false;
    const ttc_ranked *pair = best_of(e, &e->pairs, 0, &score);
    const ttc_ranked *terms = best_of(e, &e->binomials, 8, &score);
    const ttc_ranked *chosen = terms != NULL ? terms : pair;
    if (chosen == NULL) return false;
    if (e->is_large) extract_all(e, terms != NULL, chosen);
    else extract_ranked(e, terms != NULL, chosen);
    return !e->system->failed;
}

uint64_t ttc_system_extract(ttc_system *system, uint64_t seed, uint64_t pair_limit)
{
    extractor e = { .system = system, .random = seed, .pair_limit = pair_limit };
    static const unsigned noises[] = { 32, 64, 96, 160 };
    e.noise = seed == 0 ? 0 : noises[seed % 4];
    e.ratios = system->ratios != NULL ? system->ratios : &e.own_ratios;
    begin(&e);
    while (extract_best(&e)) continue;
    for (uint32_t v = 0; v < system->count; v++) ttc_polynomial_close_gaps(&system->variables[v].definition);
    ttc_scale_ratios_clear(&e.own_ratios);
    ttc_extract_index_clear(&e.pairs);
    ttc_extract_index_clear(&e.binomials);
    free(e.sums);
    free(e.cubes);
    free(e.first_occurrence);
    free(e.occurrences);
    free(e.changed);
    return e.work;
}
