/** The error of a step by Gauss collocation, seen between its nodes.
 *
 *  Where a small part of the field turns between two nodes, as smoothed friction does, coefficients show of it no more than they
 *  leave of the motion, n_8, which is some 10^5 tolerances. But at the end the polynomial errs by the integral of what it misses of
 *  the field, in which n_8 cancels, because the nodes are those of Gauss. That integral is taken by a quadrature of higher degree,
 *  with one more node between each two. */
#ifndef JLT_INTEGRATE_GAUSS_BETWEEN_H
#define JLT_INTEGRATE_GAUSS_BETWEEN_H

#include "integrate/gauss_batch.h"
#include "integrate/gauss_error.h"

/** Let what the polynomial misses between the nodes correct the error. In: nodes, as solved. p: as jlt_gauss_nodes_evaluate
 *  takes. Out: between: x, f. Returns the number of evaluations: 8, and 1 more where a miss would limit steps. */
unsigned jlt_gauss_between_see(jlt_gauss_error *io, const jlt_gauss_nodes *between, const jlt_gauss_step *step,
                               const jlt_gauss_batch *batch, const double *p, const jlt_gauss_nodes *nodes);

#endif
