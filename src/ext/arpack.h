/** Eigenvalues of largest magnitude by ARPACK's implicitly restarted Arnoldi iteration. */
#ifndef JLT_EXT_ARPACK_H
#define JLT_EXT_ARPACK_H

#include "core/status.h"

#include <stddef.h>

/** Up to `wanted` eigenvalues of largest magnitude of a real n x n matrix.
 *  Out: re, im, shape (wanted + 1,): one more place, since a conjugate pair is not split; *found.
 *  In:  a, shape (n, n), row-major, finite. 1 <= wanted <= n - 2 and n >= 3 are what ARPACK serves: a Krylov space of
 *       dimension ncv <= n must hold wanted + 2 vectors. Here ncv = n, so that one factorization spans the whole space.
 *  Errors: ARG outside that range, NONFINITE, NO_CONVERGENCE, NOMEM.
 *  Not reentrant: ARPACK keeps its state between calls; call it from one thread at a time.
 *  Source: Lehoucq, Sorensen, Yang, ARPACK Users' Guide, SIAM 1998, routines DNAUPD and DNEUPD. */
JLT_CHECKED jlt_status jlt_arpack_largest(double *re, double *im, size_t *found, const double *a, size_t n,
                                          size_t wanted);

#endif
