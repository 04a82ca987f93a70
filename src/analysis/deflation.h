/** Eigenvalues at an equilibrium of a system with integrals: the zero eigenvalues that integrals force are split off exactly.
 *
 *  Gradients w of integrals at an equilibrium satisfy w A = 0. Let W hold k independent gradients, choose k coordinates p
 *  ("pivots") with W_p invertible, and let f be the others. On the subspace W x = 0 the pivots depend on the others, x_p =
 *  -W_p^(-1) W_f x_f, so the other n - k eigenvalues are those of
 *
 *      B = A_ff - A_fp W_p^(-1) W_f,
 *
 *  and k eigenvalues are zero, attributed to the integrals. If A, permuted to block triangular form, has k exact zeros on its
 *  diagonal, they are split off without any elimination, and B is the rest of A, unrounded. Otherwise the pivots p are chosen to
 *  add the least rounding error to B. */
#ifndef JLT_ANALYSIS_DEFLATION_H
#define JLT_ANALYSIS_DEFLATION_H

#include "core/status.h"

#include <stddef.h>

enum { JLT_DEFLATION_SIZE_MAX = 32 };

typedef struct {
    double re, im;
    double condition; /* |x| |y| / |y^H x| of the whole matrix; INFINITY if defective, NaN for the eigenvalue zero,
                         or with several eigenvectors */
    double error;     /* first-order bound on the absolute error, from the errors of the entries and of the arithmetic */
    int source;       /* row of the gradient that this exactly zero eigenvalue is attributed to; else -1 */
} jlt_eigenvalue;

typedef struct {
    size_t n, /* size of A */
        kept; /* n less the number of zeros attributed to integrals */
    double defect;      /* largest |W A| / (|W| |A|), entry by entry; about 2^-53 for exact integrals */
    double lapack_difference; /* largest distance from an eigenvalue of B to LAPACK's nearest for B, over A's Frobenius norm */
    double plain_difference;  /* the same between all eigenvalues and LAPACK's for A without deflation, in both directions */
    double arpack_difference; /* the same from ARPACK's largest eigenvalues of A to these; NaN if ARPACK cannot be used */
    const char *arpack_note;  /* why ARPACK cannot be used; "" if it was */
    int defective_zero; /* the eigenvalue zero, beyond the attributed ones, is defective: linear growth */
    int doubtful_zero;  /* errors leave open whether zero is such an eigenvalue, or how many eigenvectors it has */
    jlt_eigenvalue values[JLT_DEFLATION_SIZE_MAX]; /* shape (n,): first the attributed zeros, then the rest, ascending */
} jlt_deflation;

/** Compute the eigenvalues of a, and their differences from eigenvalues by other routes.
 *  Out: *result, untouched on failure.
 *  In:  a, shape (n, n), row-major; error, shape (n, n), bound on |error of a|, or NULL: 4 units roundoff of each entry;
 *       gradients, shape (count, n), of which those that depend on earlier ones are ignored; gradient_error, shape (count, n),
 *       bound on their errors, or NULL: 8 units roundoff of each entry. 1 <= n and count <= JLT_DEFLATION_SIZE_MAX.
 *  Errors: ARG, n or count; NONFINITE, an entry, or one that over- or underflows when it is scaled; NO_CONVERGENCE, rounding
 *  errors spoil every choice of pivots, or LAPACK's iteration fails; NOMEM.
 *  Eigenvalues on the diagonal of a triangular part of B are taken as they are; a coupled block of two rows is solved in closed
 *  form, a larger one by LAPACK.
 *  Cost: choose(n, k) eliminations of k rows. Not reentrant: it calls ARPACK. */
JLT_CHECKED jlt_status jlt_deflation_compute(jlt_deflation *result, const double *a, const double *error, size_t n,
                                             const double *gradients, const double *gradient_error, size_t count);

/** As jlt_deflation_compute, without the other routes: the three differences are NaN. Reentrant. */
JLT_CHECKED jlt_status jlt_deflation_solve(jlt_deflation *result, const double *a, const double *error, size_t n,
                                           const double *gradients, const double *gradient_error, size_t count);

#endif
