/** Eigenvalues of largest magnitude by ARPACK's implicitly restarted Arnoldi iteration.
 *
 *  Not reentrant: ARPACK keeps its state between calls; call these from one thread at a time.
 *  Source: Lehoucq, Sorensen, Yang, ARPACK Users' Guide, SIAM 1998, routines DNAUPD and DNEUPD. */
#ifndef JLT_EXT_ARPACK_H
#define JLT_EXT_ARPACK_H

#include "core/status.h"

#include <stddef.h>

/** A real n x n matrix, given by its product with a vector. */
typedef struct {
    size_t n;
    /* out = A x, both of shape (n,). A nonzero return value ends the iteration. */
    int (*apply)(void *context, double *out, const double *x);
    void *context;
} jlt_arpack_matrix;

typedef struct {
    size_t wanted;       /* number of eigenvalues: 1 <= wanted <= n - 2, n >= 3 */
    size_t space;        /* dimension of the Krylov space: wanted + 2 <= space <= n, and <= 4096 */
    size_t restarts;     /* the most restarts */
    double tolerance;    /* relative, of the eigenvalues; 0: roundoff */
    const double *start; /* initial vector, (n,) */
} jlt_arpack_options;

/** Up to `wanted` eigenvalues of largest magnitude, in ARPACK's order.
 *  Out: re, im, shape (wanted + 1,): one more than wanted, since a conjugate pair is not split; *found, their number; vectors,
 *  shape (wanted + 1, n), eigenvectors of Euclidean length 1, or NULL for none: the two rows of a conjugate pair, whose first has
 *  im > 0, are the real and the imaginary part of the first's eigenvector.
 *  Errors: ARG outside the ranges above; NONFINITE; NO_CONVERGENCE, also if apply ended the iteration; NOMEM.
 *  Memory: 8 n (space + 4) bytes. */
JLT_CHECKED jlt_status jlt_arpack_leading(double *re, double *im, size_t *found, double *vectors, const jlt_arpack_matrix *matrix,
                                          const jlt_arpack_options *options);

/** The same for a dense matrix, without eigenvectors, n <= 4096.
 *  In:  a, shape (n, n), row-major, finite. The Krylov space has dimension n, so a single Arnoldi factorization spans it.
 *  Errors: as above. */
JLT_CHECKED jlt_status jlt_arpack_largest(double *re, double *im, size_t *found, const double *a, size_t n,
                                          size_t wanted);

#endif
