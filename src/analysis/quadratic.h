/** Eigenvalues of a real 2 x 2 matrix in closed form, with small relative errors as far as those of the entries allow. */
#ifndef JLT_ANALYSIS_QUADRATIC_H
#define JLT_ANALYSIS_QUADRATIC_H

#include "core/status.h"

/** Eigenvalues of b. Out: re, im, shape (2,), ascending in (re, im); error, shape (2,), bounds on the absolute errors due to
 *  errors of b and to this arithmetic; all untouched on failure.
 *  In:  b, shape (2, 2); b_error, shape (2, 2), >= 0.
 *  The discriminant ((b11 - b22)/2)^2 + b12 b21 and the determinant are computed with fused multiply-adds; of two real roots, the
 *  smaller is the determinant divided by the larger. Near a double root the bound is about the square root of the errors.
 *  Errors: NONFINITE, also if an intermediate result over- or underflows after scaling.
 *  Source: W. Kahan, On the cost of floating-point computation without extra-precise arithmetic, 2004. */
JLT_CHECKED jlt_status jlt_quadratic_eigenvalues(double re[2], double im[2], double error[2], const double b[4],
                                                 const double b_error[4]);

#endif
