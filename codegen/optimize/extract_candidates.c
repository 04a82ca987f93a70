#include "optimize/extract_candidates.h"

#include <stdlib.h>

/* `items` with room for `wanted`; when memory is out the workspace fails, and the array stays. */
static void *grown(ttc_candidates *c, void *items, size_t size, size_t wanted, size_t *capacity)
{
    if (wanted <= *capacity) return items;
    size_t larger = 2 * wanted + 64;
    void *fresh = realloc(items, larger * size);
    c->workspace->failed |= fresh == NULL;
    if (fresh == NULL) return items;
    *capacity = larger;
    return fresh;
}

ttc_polynomial *ttc_candidates_definition(const ttc_candidates *c, uint32_t variable)
{
    return &c->workspace->variables[variable].definition;
}

static ttc_candidate_cube *state_of(const ttc_candidates *c, uint32_t variable, uint32_t position)
{
    return c->cubes + c->sums[variable].base + position;
}

static uint32_t *head_of(void *context, uint32_t variable, uint32_t position)
{
    return &state_of(context, variable, position)->places;
}

void ttc_candidates_note_factor(ttc_candidates *c, uint32_t factor, uint32_t variable, uint32_t position)
{
    c->occurrences = grown(c, c->occurrences, sizeof *c->occurrences, c->occurrence_count + 1, &c->occurrence_capacity);
    if (c->workspace->failed) return;
    c->occurrences[c->occurrence_count] = (ttc_occurrence){ variable, position, c->first_occurrence[factor] };
    c->first_occurrence[factor] = (uint32_t)++c->occurrence_count;
}

/* Add `by`, 1 or -1, to the count of each pair of factors of a cube. */
static void count_pairs(ttc_candidates *c, const ttc_cube *cube, int by)
{
    uint32_t factors[TTC_CUBE_LIMIT + 1];
    unsigned count = 0;
    for (; count < cube->count; count++) factors[count] = cube->factors[count];
    if (cube->scale != c->workspace->one) factors[count++] = TTC_SCALE_FACTOR | cube->scale;
    for (unsigned i = 0; i < count; i++) {
        if (i > 0 && factors[i] == factors[i - 1]) continue;
        unsigned power = 1;
        while (i + power < count && factors[i + power] == factors[i]) power++;
        for (unsigned k = 0; k < power / 2; k++)
            ttc_extract_index_count(&c->pairs, (uint64_t)factors[i] << 32 | factors[i], by);
        for (unsigned j = i + power; j < count; j++) {
            if (j > i + power && factors[j] == factors[j - 1]) continue;
            unsigned other = 1;
            while (j + other < count && factors[j + other] == factors[j]) other++;
            for (unsigned k = 0; k < (power < other ? power : other); k++)
                ttc_extract_index_count(&c->pairs, (uint64_t)factors[i] << 32 | factors[j], by);
        }
    }
}

void ttc_candidates_retract(ttc_candidates *c, uint32_t variable, uint32_t position)
{
    ttc_candidate_cube *state = state_of(c, variable, position);
    if (state->is_changed) return;
    c->changed = grown(c, c->changed, sizeof *c->changed, c->changed_count + 1, &c->changed_capacity);
    if (c->workspace->failed) return;
    state->is_changed = true;
    c->changed[c->changed_count++] = (ttc_cube_name){ variable, position };
    count_pairs(c, ttc_candidates_definition(c, variable)->cubes + position, -1);
    ttc_extract_index_remove(&c->binomials, &state->places, head_of, c);
}

bool ttc_candidates_binomial(ttc_candidates *c, ttc_binomial *out, const ttc_cube *a, const ttc_cube *b)
{
    return ttc_binomial_of(c->workspace, c->workspace->ratios != NULL ? c->workspace->ratios : &c->own_ratios, out, a, b);
}

static void add_binomial(ttc_candidates *c, uint32_t variable, uint32_t first, uint32_t second)
{
    ttc_workspace *workspace = c->workspace;
    const ttc_cube *cubes = ttc_candidates_definition(c, variable)->cubes, *a = cubes + first, *b = cubes + second;
    ttc_binomial s;
    if (!ttc_candidates_binomial(c, &s, a, b)) return;
    int before = (int)ttc_cube_cost(workspace, a) + (int)ttc_cube_cost(workspace, b) + 1;
    ttc_cube after = s.common;
    ttc_cube_multiply(&after, 0);
    int cost = (int)ttc_cube_cost(workspace, &s.rest_a) + (int)ttc_cube_cost(workspace, &s.rest_b) + 1;
    uint32_t group = ttc_extract_index_group(&c->binomials, ttc_binomial_key(&s), cost);
    if (group == TTC_NO_GROUP) return;
    ttc_term_pair place = { .variable = variable, .first = first, .second = second,
                        .gain = before - (int)ttc_cube_cost(workspace, &after) };
    ttc_extract_index_add(&c->binomials, group, place, &state_of(c, variable, first)->places,
                          &state_of(c, variable, second)->places);
}

static int compare_names(const void *left, const void *right)
{
    const ttc_cube_name *a = left, *b = right;
    if (a->variable != b->variable) return a->variable < b->variable ? -1 : 1;
    return a->position < b->position ? -1 : a->position > b->position;
}

/* Add the pairs of terms of one sum in which a term changed, in the order of the sum. changed: its `count` changed terms. */
static void add_binomials(ttc_candidates *c, const ttc_cube_name *changed, size_t count)
{
    uint32_t variable = changed[0].variable, window = c->sums[variable].window;
    const ttc_polynomial *p = ttc_candidates_definition(c, variable);
    for (uint32_t i = 0; i < p->count && !c->workspace->failed; i++) {
        uint32_t end = window < p->count - i ? i + window + 1 : p->count;
        if (p->cubes[i].sign == 0) continue;
        if (state_of(c, variable, i)->is_changed) {
            for (uint32_t j = i + 1; j < end && !c->workspace->failed; j++)
                if (p->cubes[j].sign != 0) add_binomial(c, variable, i, j);
        } else {
            for (size_t k = 0; k < count && !c->workspace->failed; k++)
                if (changed[k].position > i && changed[k].position < end && p->cubes[changed[k].position].sign != 0)
                    add_binomial(c, variable, i, changed[k].position);
        }
    }
}

void ttc_candidates_renew(ttc_candidates *c)
{
    if (c->changed_count > 1) qsort(c->changed, c->changed_count, sizeof *c->changed, compare_names);
    for (size_t i = 0, n = 0; i < c->changed_count && !c->workspace->failed; i += n) {
        n = 1;
        while (i + n < c->changed_count && c->changed[i + n].variable == c->changed[i].variable) n++;
        for (size_t k = i; k < i + n; k++) {
            const ttc_cube *cube = ttc_candidates_definition(c, c->changed[k].variable)->cubes + c->changed[k].position;
            if (cube->sign != 0) count_pairs(c, cube, 1);
        }
        add_binomials(c, c->changed + i, n);
    }
    for (size_t i = 0; i < c->changed_count; i++)
        state_of(c, c->changed[i].variable, c->changed[i].position)->is_changed = false;
    c->changed_count = 0;
    ttc_extract_index_rank(&c->pairs);
    ttc_extract_index_rank(&c->binomials);
    c->workspace->failed |= c->pairs.failed || c->binomials.failed;
}

void ttc_candidates_enroll(ttc_candidates *c, uint32_t variable, uint32_t window)
{
    uint32_t count = ttc_candidates_definition(c, variable)->count;
    c->sums = grown(c, c->sums, sizeof *c->sums, (size_t)variable + 1, &c->sum_capacity);
    c->cubes = grown(c, c->cubes, sizeof *c->cubes, c->cube_count + count, &c->cube_capacity);
    c->first_occurrence
        = grown(c, c->first_occurrence, sizeof *c->first_occurrence, (size_t)variable + 1, &c->factor_capacity);
    c->changed = grown(c, c->changed, sizeof *c->changed, c->changed_count + count, &c->changed_capacity);
    if (c->workspace->failed) return;
    c->sums[variable] = (ttc_candidate_sum){ c->cube_count, window };
    for (; c->sum_count <= variable; c->sum_count++) c->first_occurrence[c->sum_count] = 0;
    for (uint32_t i = 0; i < count; i++) {
        c->cubes[c->cube_count++] = (ttc_candidate_cube){ 0, true };
        c->changed[c->changed_count++] = (ttc_cube_name){ variable, i };
    }
}

void ttc_candidates_note_factors(ttc_candidates *c, uint32_t variable)
{
    for (uint32_t i = 0; i < ttc_candidates_definition(c, variable)->count; i++) {
        const ttc_cube *cube = ttc_candidates_definition(c, variable)->cubes + i;
        for (unsigned j = 0; j < cube->count && !c->workspace->failed; j++) {
            if (j > 0 && cube->factors[j] == cube->factors[j - 1]) continue;
            ttc_candidates_note_factor(c, cube->factors[j], variable, i);
        }
    }
}

bool ttc_candidates_is_changed(const ttc_candidates *c, uint32_t variable, uint32_t position)
{
    return state_of(c, variable, position)->is_changed;
}

void ttc_candidates_clear(ttc_candidates *c)
{
    ttc_scale_ratios_clear(&c->own_ratios);
    ttc_extract_index_clear(&c->pairs);
    ttc_extract_index_clear(&c->binomials);
    free(c->sums);
    free(c->cubes);
    free(c->first_occurrence);
    free(c->occurrences);
    free(c->changed);
}
