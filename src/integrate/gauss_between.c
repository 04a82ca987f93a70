#include "integrate/gauss_between.h"

#include "integrate/gauss_nodes.h"
#include "integrate/step_control.h"

unsigned jlt_gauss_between_see(jlt_gauss_error *io, const jlt_gauss_nodes *between, const jlt_gauss_step *step,
                               const jlt_gauss_batch *batch, const double *p, const jlt_gauss_nodes *nodes)
{
    batch->enter(between, nodes, step->h);
    jlt_gauss_nodes_evaluate(batch, step->field, p, step->work, between);
    const double miss = jlt_rough_log2(batch->missed(between, nodes, step->before, step->after));
    return JLT_GAUSS_BATCH_NODES + jlt_gauss_error_raise(io, step, miss);
}
