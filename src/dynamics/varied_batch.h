/** The products of the variational equations on vectors of lanes, one instance for each instruction set. */
#ifndef JLT_DYNAMICS_VARIED_BATCH_H
#define JLT_DYNAMICS_VARIED_BATCH_H

#include "kernel_abi.h"

typedef struct jlt_varied_batch {
    unsigned lanes;
    /* Compute the products for one vector of lanes; all rows are `stride` apart. x: n states, then the tangent vectors; both: the
     * field (n,), then its Jacobian (n, n). out: the field, the Jacobian times each tangent vector, and its trace. */
    void (*product)(const double *x, const double *both, double *out, size_t stride, unsigned n, unsigned tangents);
} jlt_varied_batch;

/** The instance for the instruction set of these kernels. */
const jlt_varied_batch *jlt_varied_batch_find(const jlt_kernel_batch *kernels);

extern const jlt_varied_batch jlt_varied_batch_baseline;
#if defined(JLT_HAVE_X86)
extern const jlt_varied_batch jlt_varied_batch_avx2, jlt_varied_batch_avx512;
#endif

#endif
