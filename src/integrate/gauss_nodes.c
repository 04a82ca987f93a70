#include "integrate/gauss_nodes.h"

enum { N = JLT_GAUSS_BATCH_NODES };

/* All nodes are copied at once: one at a time would run through a large field's arrays N times. */
static __attribute__((noinline)) void evaluate_by_one(const jlt_field *field, double *scratch, const jlt_gauss_nodes *nodes)
{
    const size_t dim = field->dim;
    double *x = scratch, *f = scratch + N * dim;

    for (size_t c = 0; c < dim; c++)
        for (size_t i = 0; i < N; i++) x[i * dim + c] = nodes->x[c * N + i];
    for (size_t i = 0; i < N; i++) field->call(x + i * dim, field->p, f + i * dim);
    for (size_t c = 0; c < dim; c++)
        for (size_t i = 0; i < N; i++) nodes->f[c * N + i] = f[i * dim + c];
}

void jlt_gauss_nodes_evaluate(const jlt_gauss_batch *batch, const jlt_field *field, const double *p, double *scratch,
                              const jlt_gauss_nodes *nodes)
{
    if (field->batch == NULL) {
        evaluate_by_one(field, scratch, nodes);
        return;
    }
    for (unsigned i = 0; i < N; i += batch->lanes) field->batch->rhs(nodes->x + i, p, nodes->f + i, N);
}
