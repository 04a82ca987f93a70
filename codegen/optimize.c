/* Several deterministic ways to the same program; the cheapest is kept. */
#include "optimize.h"

#include "system.h"
#include "system_lower.h"

#include <stdlib.h>

/* An operation counts 2, and each of its flops 1 more: what a target with fused operations and one without pay, on the
 * mean. A division or root is worth six multiplications. */
static unsigned cost_of(const ttc_program *program)
{
    ttc_count c = ttc_program_count(program);
    return 3 * (c.add + c.multiply) + 4 * c.fma + 18 * (c.divide + c.root) + 60 * c.elementary;
}

/* Searches from each start, several where they are cheap; in each, first extractions, then rounds of undoing and redoing,
 * until so many in a row have brought nothing. Work is counted in comparisons and bounded, so that a search ends at the
 * same place on every machine: EFFORT is what a kernel may take before it is searched again, WORK_LIMIT ends one search. */
enum { REPEATS = 8, SEEDS = 8, PATIENCE = 80 };
#define EFFORT UINT64_C(500000)
#define WORK_LIMIT UINT64_C(60000000)

static ttc_program *finish(const ttc_system *system, ttc_block *block, bool one_division)
{
    ttc_program *fused = NULL;
    ttc_system *copy = ttc_system_clone(system);
    if (copy == NULL) return NULL;
    if (one_division) ttc_system_share_reciprocals(copy);
    /* The products that recover reciprocals meet other factors, so there may be more to take out. */
    ttc_system_tidy(copy);
    ttc_system_cancel(copy);
    ttc_system_extract(copy, 0);
    ttc_system_tidy(copy);
    if (!copy->failed) {
        ttc_program *program = ttc_system_lower(copy, block);
        if (program != NULL) fused = ttc_program_fuse(program);
        ttc_program_destroy(program);
    }
    ttc_system_destroy(copy);
    return fused;
}

/* Cost of a system's program; the block's entries are thrown away. UINT_MAX on failure. */
static unsigned cost_of_system(const ttc_system *system)
{
    ttc_block scratch = { .field = system->field };
    ttc_program *program = finish(system, &scratch, true);
    unsigned cost = program == NULL ? (unsigned)-1 : cost_of(program);
    ttc_program_destroy(program);
    ttc_block_clear(&scratch);
    return cost;
}

/* True when divisions of their own save at least four operations each: a quotient needs none of the products that make
 * one division of several and take it apart again, and such divisions do not wait for each other. */
static bool several_divisions_serve(const ttc_system *system)
{
    ttc_block scratch = { .field = system->field };
    ttc_program *one = finish(system, &scratch, true), *several = finish(system, &scratch, false);
    bool serve = false;
    if (one != NULL && several != NULL) {
        ttc_count a = ttc_program_count(one), b = ttc_program_count(several);
        serve = ttc_count_flops(b) + 4 * (b.divide - a.divide) <= ttc_count_flops(a) && b.divide > a.divide;
    }
    ttc_program_destroy(one);
    ttc_program_destroy(several);
    ttc_block_clear(&scratch);
    return serve;
}

/* The best system of a search; one on trial takes its place when it costs no more, so that a search drifts over ties. */
typedef struct {
    ttc_system *best;
    unsigned cost;
    uint64_t work;
} contest;

/* Takes ownership of the system. */
static void enter(contest *c, ttc_system *system)
{
    unsigned cost = system == NULL || system->failed ? (unsigned)-1 : cost_of_system(system);
    if (system != NULL && cost <= c->cost) {
        ttc_system_destroy(c->best);
        c->best = system;
        c->cost = cost;
    } else {
        ttc_system_destroy(system);
    }
}

static void extract_from(contest *c, const ttc_system *start, uint64_t seed)
{
    ttc_system *system = ttc_system_clone(start);
    if (system == NULL) return;
    if (seed % 2 == 1) ttc_system_rescale(system);
    c->work += ttc_system_extract(system, seed / 2);
    ttc_system_rescale(system);
    ttc_system_tidy(system);
    enter(c, system);
}

/* Undo some of what was extracted, and extract again (Schrimpf, Schneider, Stamm-Wilbrandt, Dueck 2000). */
static void ruin_and_recreate(contest *c, uint64_t round)
{
    ttc_system *system = ttc_system_clone(c->best);
    if (system == NULL) return;
    uint64_t random = round * UINT64_C(0x9E3779B97F4A7C15) + 12345;
    unsigned percent = 3u + 7u * (unsigned)(round % 5);
    for (uint32_t v = 0; v < system->count && !system->failed; v++) {
        random = random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        if (system->variables[v].is_extracted && (random >> 33) % 100 < percent) ttc_system_inline(system, v);
    }
    ttc_system_tidy(system);
    if (!system->failed) c->work += ttc_system_extract(system, round);
    ttc_system_rescale(system);
    ttc_system_tidy(system);
    enter(c, system);
}

/* One search from one start. */
static contest search(const ttc_system *start, uint64_t number)
{
    contest c = { NULL, (unsigned)-1, 0 };
    for (uint64_t seed = 0; seed < SEEDS && c.work < WORK_LIMIT; seed++)
        extract_from(&c, start, seed == 0 ? number % 2 : number * SEEDS + seed);
    unsigned before = c.cost;
    for (uint64_t round = 1, idle = 0; idle < PATIENCE && c.work < WORK_LIMIT && c.best != NULL; round++) {
        ruin_and_recreate(&c, (number << 32) + round);
        idle = c.cost < before ? 0 : idle + 1;
        before = c.cost;
    }
    return c;
}

enum { STARTS = 4 };

/* As given, and with products written out: a start that is no different from another is left out. */
static bool make_starts(ttc_system **starts, ttc_field *field, const ttc_id *outputs, const ttc_id *other, size_t count)
{
    for (int k = 0; k < STARTS; k++) starts[k] = NULL;
    for (int k = 0; k < 2; k++) {
        const ttc_id *ids = k == 0 ? outputs : other;
        if (ids == NULL) continue;
        starts[k] = ttc_system_create(field, ids, count);
        starts[k + 2] = starts[k] == NULL ? NULL : ttc_system_clone(starts[k]);
        if (starts[k + 2] == NULL) return false;
        bool differs = ttc_system_write_out(starts[k + 2]);
        ttc_system_raise_reciprocals(starts[k]);
        ttc_system_raise_reciprocals(starts[k + 2]);
        if (differs) continue;
        ttc_system_destroy(starts[k + 2]);
        starts[k + 2] = NULL;
    }
    return true;
}

ttc_program *ttc_optimize(ttc_field *field, const ttc_id *outputs, const ttc_id *other, size_t count, bool one_division,
                          ttc_block *block)
{
    ttc_system *starts[STARTS];
    contest best = { NULL, (unsigned)-1, 0 };
    bool ok = make_starts(starts, field, outputs, other, count);
    uint64_t work = 0;
    for (uint64_t k = 0; k < STARTS || (k < STARTS * REPEATS && work < EFFORT); k++) {
        if (!ok || starts[k % STARTS] == NULL) continue;
        contest c = search(starts[k % STARTS], k);
        work += c.work;
        if (c.best != NULL && c.cost < best.cost) {
            ttc_system_destroy(best.best);
            best = c;
        } else {
            ttc_system_destroy(c.best);
        }
    }
    one_division = one_division || best.best == NULL || !several_divisions_serve(best.best);
    ttc_program *program = best.best == NULL ? NULL : finish(best.best, block, one_division);
    ttc_program *scheduled = program == NULL ? NULL : ttc_program_schedule(program);
    ttc_program_destroy(program);
    ttc_system_destroy(best.best);
    for (int k = 0; k < STARTS; k++) ttc_system_destroy(starts[k]);
    return scheduled;
}
