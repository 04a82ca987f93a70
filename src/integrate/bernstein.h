/** Finds all zeros of a polynomial on [0, 1], by its Bernstein form. */
#ifndef JLT_INTEGRATE_BERNSTEIN_H
#define JLT_INTEGRATE_BERNSTEIN_H

#include <stddef.h>

enum { JLT_BERNSTEIN_DEGREE_MAX = 40 };

/** Compute the Bernstein coefficients b (degree + 1,) from the coefficients c[k*stride] of theta^k: b_j = sum over k <= j of
 *  C(j,k)/C(degree,k) c_k. Here and below degree <= JLT_BERNSTEIN_DEGREE_MAX, which is not checked. */
void jlt_bernstein_of(double *b, const double *c, size_t stride, unsigned degree);

/** Divide by theta a polynomial with p(0) = 0, in place: b (degree + 1,) becomes (degree,). b[0] is not read. */
void jlt_bernstein_deflate(double *b, unsigned degree);

/** Compute the coefficients d (degree,) of the derivative. */
void jlt_bernstein_derive(double *d, const double *b, unsigned degree);

/** The value at theta, by de Casteljau's algorithm. */
double jlt_bernstein_value(const double *b, unsigned degree, double theta);

/** Count the sign changes among the coefficients: there are as many zeros on (0, 1), or fewer by an even number. */
unsigned jlt_bernstein_variations(const double *b, unsigned degree);

/** Find the points of (0, 1) where the sign changes: roots (degree,), ascending; returns their number. Zeros of even multiplicity
 *  and zeros at the ends are left out. Between the returned points the sign alternates, beginning with that right of 0. Zeros
 *  nearer to each other than about 1e-12 may be missed, always in pairs.
 *  Method: an interval whose coefficients have no sign change holds no zero; with one, it holds one zero (found by Halley's method
 *  in a bracket); with more, it is halved. Cost: O(degree^2) a halving.
 *  Source: J. M. Lane, R. F. Riesenfeld, Bounds on a polynomial, BIT 21 (1981). */
unsigned jlt_bernstein_sign_changes(double *roots, const double *b, unsigned degree);

/** Find the extrema on (0, 1) where |p| <= bound: at (degree - 1,), ascending; returns their number. Method: as for sign changes,
 *  on the derivative, in those intervals alone where the coefficients let p come so near to zero. */
unsigned jlt_bernstein_touches(double *at, const double *b, unsigned degree, double bound);

#endif
