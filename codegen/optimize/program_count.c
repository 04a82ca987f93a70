/* Counts operations and live temporaries; depth and latency. */
#include "optimize/program.h"

#include <limits.h>
#include <stdlib.h>

unsigned ttc_count_flops(ttc_count count)
{
    return count.add + count.multiply + 2 * count.fma + count.divide + count.root + count.elementary;
}

/* A temporary is alive until its last use as an operand; outputs are stored at once. */
ttc_count ttc_program_count(const ttc_program *program)
{
    ttc_count count = { 0 };
    size_t n = ttc_program_size(program);
    unsigned *depth = calloc(n + 1, sizeof *depth);
    size_t *last_use = calloc(n + 1, sizeof *last_use);
    unsigned *ending = calloc(n + 1, sizeof *ending);
    unsigned live = 0;

    if (depth == NULL || last_use == NULL || ending == NULL) goto done;
    for (size_t k = 0; k < n; k++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)k);
        unsigned arity = ttc_op_arity(i->op);
        last_use[k] = k;
        for (unsigned j = 0; j < arity; j++) {
            if (depth[i->operands[j]] > depth[k]) depth[k] = depth[i->operands[j]];
            last_use[i->operands[j]] = k;
        }
        if (arity > 0) {
            depth[k]++;
            ++*ttc_op_counter(&count, i->op);
        }
        if (depth[k] > count.depth) count.depth = depth[k];
    }
    for (size_t k = 0; k < n; k++)
        if (ttc_op_arity(ttc_program_at(program, (ttc_value)k)->op) > 0) ending[last_use[k]]++;
    for (size_t k = 0; k < n; k++) {
        if (ttc_op_arity(ttc_program_at(program, (ttc_value)k)->op) == 0) continue;
        live++;
        if (live > count.live) count.live = live;
        live -= ending[k];
    }
done:
    free(ending);
    free(last_use);
    free(depth);
    return count;
}

unsigned ttc_program_latency(const ttc_program *program)
{
    size_t n = ttc_program_size(program);
    unsigned *ready = calloc(n + 1, sizeof *ready), longest = 0;
    if (ready == NULL) return UINT_MAX;
    for (size_t k = 0; k < n; k++) {
        const ttc_instruction *i = ttc_program_at(program, (ttc_value)k);
        for (unsigned j = 0; j < ttc_op_arity(i->op); j++)
            if (ready[i->operands[j]] > ready[k]) ready[k] = ready[i->operands[j]];
        ready[k] += ttc_op_latency(i->op);
        if (ready[k] > longest) longest = ready[k];
    }
    free(ready);
    return longest;
}
