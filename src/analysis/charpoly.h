/** Characteristic polynomials of small dense matrices. */
#ifndef JLT_ANALYSIS_CHARPOLY_H
#define JLT_ANALYSIS_CHARPOLY_H

#include "core/status.h"

#include <stddef.h>

enum { JLT_CHARPOLY_SIZE_MAX = 32 };

/** det(lambda E - A) by the method of Faddeev and LeVerrier, with its rounding scale.
 *  Out: coefficients, shape (n + 1,), monic, highest power first; scale, shape (n + 1,), or NULL: scale[k] is what the
 *       k-th coefficient would be if every entry were `majorant` and nothing cancelled, so that
 *       |error of coefficient k| <= k (n + 3) u scale[k], where u = 2^-53 and each |error of a_ij| <= u majorant_ij;
 *       both untouched on failure.
 *  In:  a, shape (n, n), row-major; majorant, shape (n, n), >= |a|, or NULL: |a| itself. n <= JLT_CHARPOLY_SIZE_MAX.
 *  Errors: ARG, NONFINITE (a coefficient overflows or underflows; the work itself is scaled by powers of two, exactly).
 *  Cost: 2 n^4.
 *  Source: U. LeVerrier 1840, D. K. Faddeev 1949; F. R. Gantmacher, The Theory of Matrices I, IV.5. */
JLT_CHECKED jlt_status jlt_charpoly_faddeev_leverrier(double *coefficients, double *scale, const double *a,
                                                      const double *majorant, size_t n);

/** The monic polynomial with these roots (pairs must be conjugate to rounding; imaginary parts are dropped).
 *  Out: coefficients, shape (n + 1,), highest power first; scale likewise, of the roots' magnitudes, or NULL. */
JLT_CHECKED jlt_status jlt_charpoly_from_roots(double *coefficients, double *scale, const double *re, const double *im,
                                               size_t n);

/** |adj(z E - A)|, the Frobenius norm of the adjugate at z = re + i im: divided by the product of the distances from z
 *  to the other eigenvalues it is the condition number of a simple eigenvalue z. Also, when not NULL, the adjugate itself:
 *  re and im parts, shape (2, n, n). No scaling: the caller keeps |a| near one. */
double jlt_charpoly_adjugate(double *adjugate, const double *a, size_t n, double re, double im);

/** The power of two k with 2^(k-1) <= the largest |entry| < 2^k; 0 for a zero matrix. */
int jlt_charpoly_exponent(const double *a, size_t count);

#endif
