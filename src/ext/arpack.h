/** Eigenvalues of largest magnitude by ARPACK's implicitly restarted Arnoldi iteration.
 *
 *  Not reentrant: ARPACK keeps its state between calls; call these from one thread at a time.
 *  Source: Lehoucq, Sorensen, Yang, ARPACK Users' Guide, SIAM 1998, routines DNAUPD and DNEUPD. */
#ifndef JLT_EXT_ARPACK_H
#define JLT_EXT_ARPACK_H

#include "core/status.h"

#include <stddef.h>

/** A real n x n matrix, known by what it does to a vector. */
typedef struct {
    size_t n;
    /* out = A x, shape (n,) both. Anything but 0 ends the iteration. */
    int (*apply)(void *context, double *out, const double *x);
    void *context;
} jlt_arpack_matrix;

typedef struct {
    size_t wanted;       /* eigenvalues: 1 <= wanted <= n - 2, n >= 3 */
    size_t space;        /* vectors of the Krylov space: wanted + 2 <= space <= n, and <= 4096 */
    size_t restarts;     /* at most so many */
    double tolerance;    /* relative, of the eigenvalues; 0: rounding */
    const double *start; /* (n,) */
} jlt_arpack_options;

/** Up to `wanted` eigenvalues of largest magnitude, in ARPACK's order.
 *  Out: re, im, shape (wanted + 1,): one more place, since a conjugate pair is not split; *found; vectors, shape (wanted + 1, n),
 *       of Euclidean length 1, or NULL: of a pair, whose first has im > 0, the real part and then the imaginary part of the
 *       first's.
 *  Errors: ARG outside those ranges; NONFINITE; NO_CONVERGENCE, also where apply has ended it; NOMEM.
 *  Memory: 8 n (space + 4) bytes. */
JLT_CHECKED jlt_status jlt_arpack_leading(double *re, double *im, size_t *found, double *vectors, const jlt_arpack_matrix *matrix,
                                          const jlt_arpack_options *options);

/** The same of a matrix that is written out, without vectors, n <= 4096.
 *  In:  a, shape (n, n), row-major, finite. The Krylov space is the whole one, so that one factorization spans it.
 *  Errors: as above. */
JLT_CHECKED jlt_status jlt_arpack_largest(double *re, double *im, size_t *found, const double *a, size_t n,
                                          size_t wanted);

#endif
