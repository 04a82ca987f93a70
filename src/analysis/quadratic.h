/** Eigenvalues of a real 2 x 2 matrix in closed form, each accurate relative to itself as far as the entries allow. */
#ifndef JLT_ANALYSIS_QUADRATIC_H
#define JLT_ANALYSIS_QUADRATIC_H

#include "core/status.h"

/** Eigenvalues of b. Out: re, im, shape (2,), ascending in (re, im); error, shape (2,), bounds on the absolute errors from |error
 *       of b| and from this arithmetic; all untouched on failure.
 *  In:  b, shape (2, 2); b_error, shape (2, 2), >= 0.
 *  The discriminant ((b11 - b22)/2)^2 + b12 b21 and the determinant are formed with fused multiply-adds; of two real
 *  roots the smaller comes from the product. Near a double root the bound passes to the square-root law.
 *  Errors: NONFINITE, also when an intermediate over- or underflows after scaling.
 *  Source: W. Kahan, On the cost of floating-point computation without extra-precise arithmetic, 2004. */
JLT_CHECKED jlt_status jlt_quadratic_eigenvalues(double re[2], double im[2], double error[2], const double b[4],
                                                 const double b_error[4]);

#endif
