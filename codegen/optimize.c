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

enum { SEEDS = 16 };
#define WORK_LIMIT UINT64_C(20000000)

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

ttc_program *ttc_optimize(ttc_field *field, const ttc_id *outputs, size_t count, ttc_block *block)
{
    ttc_system *start = ttc_system_create(field, outputs, count), *best = NULL;
    ttc_program *program = NULL;
    unsigned best_cost = (unsigned)-1;
    uint64_t work = 0;
    if (start == NULL) return NULL;
    for (uint64_t seed = 0; seed < SEEDS && work < WORK_LIMIT; seed++) {
        ttc_system *system = ttc_system_clone(start);
        if (system == NULL) break;
        work += ttc_system_extract(system, seed);
        ttc_system_tidy(system);
        unsigned cost = system->failed ? (unsigned)-1 : try(system);
        if (cost < best_cost) {
            ttc_system *swap = best;
            best = system;
            system = swap;
            best_cost = cost;
        }
        ttc_system_destroy(system);
    }
    if (best != NULL) program = finish(best, block);
    ttc_system_destroy(best);
    ttc_system_destroy(start);
    return program;
}
