/** Small dense linear algebra of maps: matrices (dim, dim) row-major, on the stack. */
#ifndef JLT_DYNAMICS_LINEAR_H
#define JLT_DYNAMICS_LINEAR_H

#include "core/status.h"

#include <stddef.h>

enum { JLT_LINEAR_DIM_MAX = 128 };

/** out = a b; out may be a or b. */
void jlt_linear_multiply(double *out, const double *a, const double *b, unsigned dim);

/** Euclidean length of v, shape (count,). */
double jlt_linear_length(const double *v, size_t count);

/** Determinant of a, shape (dim, dim), by elimination with partial pivoting; for dim = 2 by a compensated difference of products,
 *  good to 2 ulp. */
double jlt_linear_determinant(const double *a, unsigned dim);

/** Eigenvalues, shape (dim,) each: largest modulus first, and of equal ones, to 7 digits, the largest real part, then the largest
 *  imaginary part. dim = 2 in closed form, otherwise by LAPACK.
 *  Errors: as jlt_eigen_values. */
JLT_CHECKED jlt_status jlt_linear_eigenvalues(double *re, double *im, const double *a, unsigned dim);

/** Unit vector v with a v = value v, for dim = 2, up to sign. */
void jlt_linear_eigenvector(double v[2], const double a[4], double value);

#endif
