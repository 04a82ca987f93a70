#include "integrate/gauss_nodes.h"

enum { N = JLT_GAUSS_BATCH_NODES };

static __attribute__((noinline)) void evaluate_by_one(const jlt_field *field, double *scratch, const jlt_gauss_nodes *nodes)
{
    double *x = scratch, *f = scratch + field->dim;

    for (unsigned i = 0; i < N; i++) {
        for (unsigned c = 0; c < field->dim; c++) x[c] = nodes->x[c * N + i];
        field->call(x, field->p, f);
        for (unsigned c = 0; c < field->dim; c++) nodes->f[c * N + i] = f[c];
    }
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
