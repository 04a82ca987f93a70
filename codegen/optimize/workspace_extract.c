/* Greedy extraction of common subexpressions, after the algebraic methods of logic synthesis (Brayton, Rudell,
 * Sangiovanni-Vincentelli, Wang 1987) carried over to polynomials (Hosangadi, Fallah, Kastner 2006): pairs of factors that occur
 * in several cubes, and pairs of terms that occur, up to a common factor, in one or several sums. Larger ones grow out of pairs.
 * Each step takes the pair that saves most. */
#include "optimize/extract_candidates.h"

#include "base/random.h"

#include <stdlib.h>

typedef struct {
    ttc_workspace *workspace;
    ttc_candidates candidates;
    uint64_t random, work;
    unsigned noise;
    uint64_t pair_limit;
    bool is_large;
} extractor;

static int compare_cubes(const void *left, const void *right)
{
    const ttc_cube *a = left, *b = right;
    for (unsigned i = 0; i < a->count && i < b->count; i++)
        if (a->factors[i] != b->factors[i]) return a->factors[i] < b->factors[i] ? -1 : 1;
    if (a->count != b->count) return a->count < b->count ? -1 : 1;
    return a->scale < b->scale ? -1 : a->scale > b->scale;
}

/* Register all sums. If they have more pairs of terms than the limit, terms are sorted by factors, and compared with the next ones
 * only. */
static void begin(extractor *e)
{
    ttc_workspace *workspace = e->workspace;
    ttc_candidates *c = &e->candidates;
    uint64_t pairs = 0, terms = 1;
    for (uint32_t v = 0; v < workspace->count; v++) {
        uint64_t n = ttc_candidates_definition(c, v)->count;
        pairs += n * (n - 1) / 2;
        terms += n;
    }
    e->is_large = pairs > e->pair_limit;
    uint32_t window = e->is_large ? (uint32_t)(e->pair_limit / terms) + 1 : UINT32_MAX;
    for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++) {
        ttc_polynomial *p = ttc_candidates_definition(c, v);
        if (p->count > window) qsort(p->cubes, p->count, sizeof *p->cubes, compare_cubes);
        ttc_candidates_enroll(c, v, window);
    }
    for (uint32_t v = 0; v < workspace->count && !workspace->failed; v++) ttc_candidates_note_factors(c, v);
}

static void take_factor(ttc_workspace *workspace, ttc_cube *cube, uint32_t factor)
{
    if ((factor & TTC_SCALE_FACTOR) != 0) cube->scale = workspace->one;
    else ttc_cube_remove(cube, factor);
}

static bool has_factors(const ttc_cube *cube, uint32_t a, uint32_t b)
{
    if (a == b) return ttc_cube_power(cube, a) >= 2;
    bool has_b = (b & TTC_SCALE_FACTOR) != 0 ? cube->scale == (b & ~TTC_SCALE_FACTOR) : ttc_cube_power(cube, b) > 0;
    return has_b && ttc_cube_power(cube, a) > 0;
}

static uint32_t add_unit(extractor *e)
{
    uint32_t unit = ttc_workspace_add_variable(e->workspace, TTC_VARIABLE_UNIT, 0);
    if (e->workspace->failed) return unit;
    e->workspace->variables[unit].is_extracted = true;
    ttc_candidates_enroll(&e->candidates, unit, UINT32_MAX);
    return unit;
}

static void define_unit(extractor *e, uint32_t unit, const ttc_cube *cubes, uint32_t count)
{
    ttc_candidates *c = &e->candidates;
    for (uint32_t i = 0; i < count; i++) ttc_polynomial_add(e->workspace, ttc_candidates_definition(c, unit), cubes + i);
    if (e->workspace->failed) return;
    ttc_candidates_enroll(c, unit, UINT32_MAX);
    ttc_candidates_note_factors(c, unit);
}

/* Make a, a variable, times b, a variable or a scale, a unit. */
static void extract_factors(extractor *e, uint32_t a, uint32_t b)
{
    ttc_workspace *workspace = e->workspace;
    ttc_candidates *c = &e->candidates;
    uint32_t unit = add_unit(e);
    for (uint32_t o = workspace->failed ? 0 : c->first_occurrence[a]; o != 0 && !workspace->failed;) {
        ttc_occurrence at = c->occurrences[o - 1];
        ttc_cube *cube = ttc_candidates_definition(c, at.variable)->cubes + at.position;
        o = at.next;
        if (cube->sign == 0 || !has_factors(cube, a, b)) continue;
        ttc_candidates_retract(c, at.variable, at.position);
        while (has_factors(cube, a, b)) {
            take_factor(workspace, cube, a);
            take_factor(workspace, cube, b);
            ttc_cube_multiply(cube, unit);
        }
        if (!workspace->failed) ttc_candidates_note_factor(c, unit, at.variable, at.position);
    }
    ttc_cube product = ttc_cube_one(workspace);
    ttc_cube_multiply(&product, a);
    if ((b & TTC_SCALE_FACTOR) != 0) product.scale = b & ~TTC_SCALE_FACTOR;
    else ttc_cube_multiply(&product, b);
    if (!workspace->failed) define_unit(e, unit, &product, 1);
}

/* Whether one term is left; removed ones have sign 0. */
static bool is_single(const ttc_polynomial *p)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < p->count; i++) count += p->cubes[i].sign != 0;
    return count == 1;
}

/* Make the sum of two terms a unit at all places of the group. */
static void extract_terms(extractor *e, uint32_t group)
{
    ttc_workspace *workspace = e->workspace;
    ttc_candidates *c = &e->candidates;
    uint32_t count = c->binomials.groups[group].size;
    ttc_term_pair *places = malloc((count + 1) * sizeof *places);
    ttc_binomial wanted, found;
    bool is_grouping = false;
    workspace->failed |= places == NULL;
    uint32_t unit = workspace->failed ? 0 : add_unit(e);
    if (!workspace->failed) ttc_extract_index_places(&c->binomials, group, places);
    for (uint32_t i = 0; i < count && !workspace->failed; i++) {
        const ttc_term_pair *at = places + i;
        ttc_polynomial *p = ttc_candidates_definition(c, at->variable);
        if (ttc_candidates_is_changed(c, at->variable, at->first)) continue;
        if (ttc_candidates_is_changed(c, at->variable, at->second)) continue;
        if (!ttc_candidates_binomial(c, i == 0 ? &wanted : &found, p->cubes + at->first, p->cubes + at->second)) break;
        if (i == 0) found = wanted;
        if (!ttc_binomial_same(&wanted, &found) || !ttc_cube_multiply(&found.common, unit)) continue;
        ttc_candidates_retract(c, at->variable, at->first);
        ttc_candidates_retract(c, at->variable, at->second);
        p->cubes[at->first] = found.common;
        p->cubes[at->second].sign = 0;
        const ttc_variable *changed = workspace->variables + at->variable;
        is_grouping |= is_single(p) && !changed->is_extracted && !changed->is_output;
        if (!workspace->failed) ttc_candidates_note_factor(c, unit, at->variable, at->first);
    }
    free(places);
    const ttc_cube rests[] = { wanted.rest_a, wanted.rest_b };
    /* A sum of the table's, or a factor of a difference of squares, must not be multiplied out later. */
    if (!workspace->failed && is_grouping && workspace->field->keeps_digits) workspace->variables[unit].is_extracted = false;
    if (!workspace->failed) define_unit(e, unit, rests, 2);
}

/* The group with the highest score, if that is above *best_score; else NULL. */
static const ttc_ranked *best_of(extractor *e, const ttc_extract_index *index, unsigned bonus, uint64_t *best_score)
{
    const ttc_ranked *best = NULL;
    for (size_t i = 0; i < index->ranked_count; i++) {
        uint64_t score = (uint64_t)index->ranked[i].gain * 64 + bonus;
        if (e->noise > 0) score += ttc_random_bits(&e->random) % e->noise;
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

/* Extract `chosen`, and later groups of equal gain that no extraction has changed meanwhile. */
static void extract_all(extractor *e, bool are_terms, const ttc_ranked *chosen)
{
    const ttc_extract_index *index = are_terms ? &e->candidates.binomials : &e->candidates.pairs;
    int32_t gain = chosen->gain;
    for (size_t i = (size_t)(chosen - index->ranked); i < index->ranked_count && !e->workspace->failed; i++)
        if (index->ranked[i].gain == gain && !index->groups[index->ranked[i].group].is_changed)
            extract_ranked(e, are_terms, index->ranked + i);
}

static bool extract_best(extractor *e)
{
    uint64_t score = 0;
    ttc_candidates_renew(&e->candidates);
    e->work += e->candidates.pairs.members + e->candidates.binomials.members;
    if (e->workspace->failed) return false;
    const ttc_ranked *pair = best_of(e, &e->candidates.pairs, 0, &score);
    const ttc_ranked *terms = best_of(e, &e->candidates.binomials, 8, &score);
    const ttc_ranked *chosen = terms != NULL ? terms : pair;
    if (chosen == NULL) return false;
    if (e->is_large) extract_all(e, terms != NULL, chosen);
    else extract_ranked(e, terms != NULL, chosen);
    return !e->workspace->failed;
}

uint64_t ttc_workspace_extract(ttc_workspace *workspace, uint64_t seed, uint64_t pair_limit)
{
    extractor e = { .workspace = workspace, .candidates.workspace = workspace, .random = seed, .pair_limit = pair_limit };
    static const unsigned noises[] = { 32, 64, 96, 160 };
    e.noise = seed == 0 ? 0 : noises[seed % 4];
    begin(&e);
    while (extract_best(&e)) continue;
    for (uint32_t v = 0; v < workspace->count; v++) ttc_polynomial_close_gaps(&workspace->variables[v].definition);
    ttc_candidates_clear(&e.candidates);
    return e.work;
}
