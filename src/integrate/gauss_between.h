/** The error of a step by Gauss collocation, seen between its nodes.
 *
 *  A small part of the field may change fast between two nodes, as smoothed friction does. The Legendre coefficients then show it
 *  only if it is larger than n_8, the part of the motion that they leave out, some 10^5 tolerances. The error at the end of the
 *  step, however, is the integral of what the polynomial misses of the field, in which n_8 cancels, because the nodes are those of
 *  Gauss. That integral is computed by a quadrature of higher degree, with one more node between each two. */
#ifndef JLT_INTEGRATE_GAUSS_BETWEEN_H
#define JLT_INTEGRATE_GAUSS_BETWEEN_H

#include "integrate/gauss_batch.h"
#include "integrate/gauss_error.h"

/** Raise the error at the end where the polynomial misses more than that between the nodes. In: nodes, as solved. p: as
 *  jlt_gauss_nodes_evaluate takes. Out: between: x, f. Returns the number of evaluations: 8, and 1 more where a miss would limit
 *  steps. */
unsigned jlt_gauss_between_see(jlt_gauss_error *io, const jlt_gauss_nodes *between, const jlt_gauss_step *step,
                               const jlt_gauss_batch *batch, const double *p, const jlt_gauss_nodes *nodes);

#endif
