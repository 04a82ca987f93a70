#include "cli/lyapunov_losses.h"

#include <math.h>

#include "kernel/batch_isa.h"

int jlt_lyapunov_loss(double least, unsigned condition)
{
    return least <= 0 ? (int)condition : isnan(least) ? JLT_LYAPUNOV_UNKNOWN : JLT_LYAPUNOV_HELD;
}

jlt_status jlt_lyapunov_losses(int *lost, const jlt_system *const *systems, size_t system_count, const double *q,
                               const size_t *system_of, size_t count, size_t returns, bool in_lanes, size_t threads)
{
    const jlt_section_batch_options options = { .threads = (unsigned)threads, .watches = true, .last_only = true };
    const jlt_kernel_batch *kernels = in_lanes ? jlt_batch_isa_best(systems[0]->instance->descriptor, 0) : NULL;
    JLT_OWNED(jlt_section_batch) *batch = NULL;
    jlt_return last;

    for (size_t i = 0; i < count; i++) lost[i] = JLT_LYAPUNOV_NO_ORBIT;
    if (jlt_observed_conditions(systems[0]->flow.observed) == 0) return JLT_OK;
    JLT_PASS(jlt_section_batch_create(&batch, &systems[0]->flow, kernels, &options));
    for (size_t i = 1; i < system_count; i++) JLT_PASS(jlt_section_batch_add(batch, NULL, &systems[i]->flow, NULL));
    JLT_PASS(jlt_section_batch_run_each(batch, q, system_of, NULL, count, returns));
    for (size_t i = 0; i < jlt_section_batch_begun(batch); i++)
        if (jlt_section_batch_last(batch, &last, i) == JLT_OK) lost[i] = jlt_lyapunov_loss(last.least, last.lost);
    return JLT_OK;
}
