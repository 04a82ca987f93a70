/** Eigenvalues at an equilibrium of a system with integrals: those that the integrals make zero are taken out exactly.
 *
 *  Gradients w of integrals at an equilibrium satisfy w A = 0. Let W hold k independent ones, choose k coordinates p
 *  ("pivots") with W_p invertible, and f the others. On the leaf W x = 0 the pivots follow the rest,
 *  x_p = -W_p^(-1) W_f x_f, so the other n - k eigenvalues are those of
 *
 *      B = A_ff - A_fp W_p^(-1) W_f,
 *
 *  and k eigenvalues are zero, attributed to the integrals. Where A, permuted to block triangular form, shows k exact zeros
 *  on its diagonal, B is what is left of A itself, unrounded. Else of all choices of p the one that adds the least rounding
 *  error to B is taken. */
#ifndef JLT_ANALYSIS_DEFLATION_H
#define JLT_ANALYSIS_DEFLATION_H

#include "core/status.h"

#include <stddef.h>

enum { JLT_DEFLATION_SIZE_MAX = 16 };

typedef struct {
    double re, im;
    double condition; /* |x| |y| / |y^H x|, of the whole matrix; INFINITY when defective, NaN when not defined: zero */
    double error;     /* first-order bound on the absolute error, from the errors of the entries and of the arithmetic */
    int source;       /* row of the gradient that it is attributed to, exactly zero; -1 otherwise */
} jlt_eigenvalue;

typedef struct {
    size_t n, /* size of A */
        kept; /* n less the zeros attributed to integrals */
    jlt_eigenvalue values[JLT_DEFLATION_SIZE_MAX]; /* shape (n,): first the zeros attributed, then the rest, ascending */
    double defect;      /* largest |W A| / (|W| |A|), entry by entry; about 2^-53 for true integrals */
    double gsl_difference;    /* largest distance from an eigenvalue of B to the nearest of GSL's for B, over A's Frobenius norm */
    double plain_difference;  /* the same between all eigenvalues and GSL's for A as it is, without deflation, both ways */
    double arpack_difference; /* the same from ARPACK's for A, of largest magnitude, to ours; NaN where ARPACK cannot serve */
    const char *arpack_note;  /* why not; "" when it did */
    int defective_zero; /* a zero eigenvalue beyond those of the integrals has too few eigenvectors: linear growth */
    int doubtful_zero;  /* errors leave open whether there is one, or how many eigenvectors it has */
} jlt_deflation;

/** Compute the eigenvalues of a, with the differences from other routes.
 *  Out: *result, untouched on failure.
 *  In:  a, shape (n, n), row-major; error, shape (n, n), bound on |error of a|, or NULL: 4 units roundoff of each entry;
 *       gradients, shape (count, n), dependent ones allowed (the later is left out); gradient_error, shape (count, n), bound on
 *       their errors, or NULL: 8 units roundoff of each entry. 1 <= n and count <= JLT_DEFLATION_SIZE_MAX.
 *  Errors: ARG, n or count; NONFINITE, an entry, or one that over- or underflows when it is scaled; NO_CONVERGENCE, rounding
 *  spoils every choice of pivots, or GSL's iteration fails; NOMEM.
 *  A triangular part of B gives its diagonal as it is; a coupled block of two rows is solved in closed form, a larger one
 *  by GSL.
 *  Cost: choose(n, k) eliminations of k rows. Not reentrant: it calls ARPACK. */
JLT_CHECKED jlt_status jlt_deflation_compute(jlt_deflation *result, const double *a, const double *error, size_t n,
                                             const double *gradients, const double *gradient_error, size_t count);

/** As jlt_deflation_compute, without other routes to compare with: the three differences are NaN. Reentrant. */
JLT_CHECKED jlt_status jlt_deflation_solve(jlt_deflation *result, const double *a, const double *error, size_t n,
                                           const double *gradients, const double *gradient_error, size_t count);

#endif
