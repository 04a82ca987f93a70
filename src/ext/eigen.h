/** Eigenvalues, by LAPACK, norms and least squares, by GSL, of small dense real matrices, row-major, which remain unchanged. */
#ifndef JLT_EXT_EIGEN_H
#define JLT_EXT_EIGEN_H

#include "core/status.h"

#include <stddef.h>

/** Eigenvalues of a real n x n matrix, balanced, by the Francis QR algorithm. Reentrant.
 *  Out: re, im, shape (n,), in ascending order of (re, im). In: a, shape (n, n), finite.
 *  Errors: ARG, n; NONFINITE, NO_CONVERGENCE, NOMEM; re and im are then undefined. Accuracy: normwise backward stable; an
 *  eigenvalue with a Jordan block of size k keeps 1/k of the digits. Cost: 10 n^3. Source: Golub, Van Loan, Matrix
 *  Computations, 7.5. */
JLT_CHECKED jlt_status jlt_eigen_values(double *re, double *im, const double *a, size_t n);

/** Roots of a polynomial of degree n, by the QR algorithm on its balanced companion matrix.
 *  Out: re, im, shape (n,), in ascending order of (re, im). In: coefficients, shape (n + 1,), highest power first, the first not
 *  0. Errors: NONFINITE, NO_CONVERGENCE, NOMEM. Accuracy: a k-fold root keeps 1/k of the digits. */
JLT_CHECKED jlt_status jlt_eigen_polynomial_roots(double *re, double *im, const double *coefficients, size_t n);

/** Sizes of the states, powers of two, in which a real n x n matrix, dx/dt = a x, has entries of like size: it is balanced.
 *  Out: size, shape (n,). Errors: NONFINITE, NOMEM. Source: Golub, Van Loan, Matrix Computations, 7.5.7. */
JLT_CHECKED jlt_status jlt_eigen_balance(double *size, const double *a, size_t n);

/** Sort eigenvalues by (re, im), ascending. In/out: re, im, and error unless NULL, shape (n,). Cost: n^2. */
void jlt_eigen_sort(double *re, double *im, double *error, size_t n);

/** The shortest z that minimizes |a z - b|; singular values not above cutoff * largest count as zero.
 *  Out: z, shape (columns,). In: a, shape (rows, columns); b, shape (rows,). Errors: NONFINITE, also if products of entries
 *  overflow, so that the decomposition does not converge; NOMEM. */
JLT_CHECKED jlt_status jlt_eigen_least_squares(double *z, const double *a, const double *b, size_t rows, size_t columns,
                                               double cutoff);

/** The 2-norm, the largest singular value, of a real n x n matrix, n > 0. Errors: as jlt_eigen_least_squares. Accuracy: 1e-16 n^2,
 *  also where singular values are all but equal. */
JLT_CHECKED jlt_status jlt_eigen_norm(double *norm, const double *a, size_t n);

#endif
