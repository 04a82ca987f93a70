/** The field at all nodes of a step by Gauss collocation. */
#ifndef JLT_INTEGRATE_GAUSS_NODES_H
#define JLT_INTEGRATE_GAUSS_NODES_H

#include "integrate/field.h"
#include "integrate/gauss_batch.h"

/** Evaluate nodes->f at nodes->x. p: the field's prepared values, in every lane for batched kernels; scratch: work for a field
 *  without them, shape (2, JLT_GAUSS_BATCH_NODES, dim). */
void jlt_gauss_nodes_evaluate(const jlt_gauss_batch *batch, const jlt_field *field, const double *p, double *scratch,
                              const jlt_gauss_nodes *nodes);

#endif
