/** The products of the variational equations on vectors of lanes, one instance for each instruction set. */
#ifndef JLT_DYNAMICS_VARIED_BATCH_H
#define JLT_DYNAMICS_VARIED_BATCH_H

#include <stddef.h>

/** Computes the products for one vector of lanes; all rows are `stride` apart. x: n states, then the tangent vectors; both: the
 *  field (n,), then its Jacobian (n, n). out: the field, the Jacobian times each tangent vector, and its trace. */
typedef void jlt_varied_batch(const double *x, const double *both, double *out, size_t stride, unsigned n, unsigned tangents);

jlt_varied_batch jlt_varied_batch_baseline;
#if defined(JLT_HAVE_X86)
jlt_varied_batch jlt_varied_batch_avx2, jlt_varied_batch_avx512;
#endif

#endif
