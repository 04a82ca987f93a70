/** Characteristic polynomials of small dense matrices. */
#ifndef JLT_ANALYSIS_CHARPOLY_H
#define JLT_ANALYSIS_CHARPOLY_H

#include "core/status.h"

#include <stddef.h>

enum { JLT_CHARPOLY_SIZE_MAX = 32 };

/** det(lambda E - A) by the method of Faddeev and LeVerrier, with a scale for its rounding errors.
 *  Out: coefficients, shape (n + 1,), monic, highest power first; scale, shape (n + 1,), or NULL: scale[k] is the k-th coefficient
 *       computed from the majorant with all terms added in modulus, so that
 *       |error of coefficient k| <= k (n + 3) u scale[k], where u = 2^-53 and each |error of a_ij| <= u majorant_ij;
 *       both untouched on failure.
 *  In:  a, shape (n, n), row-major; majorant, shape (n, n), >= |a|, or NULL: |a| itself. n <= JLT_CHARPOLY_SIZE_MAX.
 *  Errors: ARG, n; NONFINITE, an entry, or a coefficient that overflows or underflows (the work itself is scaled by powers of two,
 *          exactly).
 *  Cost: 2 n^4.
 *  Source: U. LeVerrier 1840, D. K. Faddeev 1949; F. R. Gantmacher, The Theory of Matrices I, IV.5. */
JLT_CHECKED jlt_status jlt_charpoly_faddeev_leverrier(double *coefficients, double *scale, const double *a,
                                                      const double *majorant, size_t n);

/** The monic polynomial with the roots re[i] + i im[i], shape (n,) each. Roots that are not real must come in conjugate pairs, up
 *  to rounding: the imaginary parts of the coefficients are dropped.
 *  Out: coefficients, shape (n + 1,), highest power first; scale, shape (n + 1,), or NULL: the same with all terms added in
 *  modulus, which are the coefficients of the polynomial with roots -|re + i im|.
 *  Errors: ARG, n > JLT_CHARPOLY_SIZE_MAX; NONFINITE, a root, or a coefficient or its scale overflows. */
JLT_CHECKED jlt_status jlt_charpoly_from_roots(double *coefficients, double *scale, const double *re, const double *im,
                                               size_t n);

/** Returns |adj(z E - A)|, the Frobenius norm of the adjugate at z = re + i im. For a simple eigenvalue z, this divided by the
 *  product of the distances from z to the other eigenvalues is its condition number.
 *  Out: adjugate, shape (2, n, n), or NULL: its real parts, then its imaginary parts. In: a, shape (n, n), row-major; n <=
 *  JLT_CHARPOLY_SIZE_MAX, which is not checked. Nothing is scaled, so entries of sizes far from 1 may overflow. */
double jlt_charpoly_adjugate(double *adjugate, const double *a, size_t n, double re, double im);

/** The k with 2^(k-1) <= largest |entry| of a, shape (count,), < 2^k; 0 if all entries are zero. */
int jlt_charpoly_exponent(const double *a, size_t count);

#endif
