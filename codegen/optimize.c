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

enum { SEEDS = 16, ROUNDS = 300 };
#define WORK_LIMIT UINT64_C(4000000000)

static ttc_program *finish(const ttc_system *system, ttc_block *block)
{
    ttc_program *fused = NULL;
    ttc_system *copy = ttc_system_clone(system);
    if (copy == NULL) return NULL;
    ttc_system_share_reciprocals(copy);
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
static unsigned try(const ttc_system *system)
{
    ttc_block scratch = { .field = system->field };
    ttc_program *program = finish(system, &scratch);
    unsigned cost = program == NULL ? (unsigned)-1 : cost_of(program);
    ttc_program_destroy(program);
    ttc_block_clear(&scratch);
    return cost;
}

/* A system on trial takes the place of the best one when it is cheaper. */
typedef struct {
    ttc_system *best;
    unsigned cost;
    uint64_t work;
} contest;

static void enter(contest *c, ttc_system *system)
{
    unsigned cost = system == NULL || system->failed ? (unsigned)-1 : try(system);
    if (cost <= c->cost && system != NULL) {
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

/* Undo some of what was extracted, and extract again. */
static void ruin_and_recreate(contest *c, uint64_t round)
{
    ttc_system *system = ttc_system_clone(c->best);
    if (system == NULL) return;
    uint64_t random = round * UINT64_C(0x9E3779B97F4A7C15) + 12345;
    for (uint32_t v = 0; v < system->count && !system->failed; v++) {
        random = random * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        if (system->variables[v].is_extracted && (random >> 33) % 100 < 10 + 10 * (round % 4)) ttc_system_inline(system, v);
    }
    ttc_system_tidy(system);
    if (!system->failed) c->work += ttc_system_extract(system, round);
    ttc_system_rescale(system);
    ttc_system_tidy(system);
    enter(c, system);
}

ttc_program *ttc_optimize(ttc_field *field, const ttc_id *outputs, size_t count, ttc_block *block)
{
    ttc_system *start = ttc_system_create(field, outputs, count);
    contest c = { NULL, (unsigned)-1, 0 };
    if (start == NULL) return NULL;
    for (uint64_t seed = 0; seed < SEEDS && c.work < WORK_LIMIT; seed++) extract_from(&c, start, seed);
    for (uint64_t round = 1; round <= ROUNDS && c.work < WORK_LIMIT && c.best != NULL; round++) ruin_and_recreate(&c, round);
    ttc_program *program = c.best == NULL ? NULL : finish(c.best, block);
    ttc_system_destroy(c.best);
    ttc_system_destroy(start);
    return program;
}
