/** Leading eigenvalues and eigenvectors of a transfer operator: stationary density, escape rate, almost invariant sets. */
#ifndef JLT_ANALYSIS_TRANSFER_SPECTRUM_H
#define JLT_ANALYSIS_TRANSFER_SPECTRUM_H

#include "analysis/transfer.h"

/** Plain data, owned; clear with jlt_transfer_spectrum_clear. Eigenvectors are left ones: masses v of boxes with v P = lambda v,
 *  scaled to sum |v| = 1. */
typedef struct {
    size_t count;     /* of eigenvalues, a pair counting twice; by descending magnitude, re, im */
    double *re, *im;  /* (count,) */
    double *residual; /* (count,): sum of |v P - lambda v|, computed from the matrix */
    double *spread;   /* (count,): distance to the nearest eigenvalue of a second computation from another start vector. It detects
                       * what the residual does not: a Jordan block of size k of the eigenvalue 0 is computed as k values on a
                       * circle whose radius is the k-th root of a rounding error, with small residuals */
    size_t told;      /* the first `told` eigenvalues agree to three digits in both computations; the others are not resolved */
    double *leading;  /* (transfer->count,): eigenvector of the largest real eigenvalue, the stationary masses, >= 0 */
    size_t leading_index;
    double negative;  /* share of the mass to which ARPACK gives the opposite sign: roundoff, unless the eigenvalue is multiple */
    double *second;   /* (transfer->count,): eigenvector of the next positive eigenvalue if among the first `told`; or NULL */
    size_t second_index;
} jlt_transfer_spectrum;

/** Compute `wanted` >= 1 eigenvalues to the relative accuracy `tolerance`, by ARPACK, twice. If the matrix has fewer than wanted +
 *  2 rows, fewer eigenvalues are computed. If they do not converge, as for mixing maps, whose other eigenvalues fill a disc, the
 *  leading one alone is computed. interrupt: a flag that stops the computation, or NULL.
 *  Errors: ARG, the matrix has less than 3 rows; EMPTY, no box leads back to itself, so all eigenvalues are 0; NO_CONVERGENCE, not
 *  even the leading one converges, none found is real, or the computation is interrupted; NONFINITE; NOMEM.
 *  Memory: 8 rows (3 wanted + 36) bytes. */
JLT_CHECKED jlt_status jlt_transfer_spectrum_compute(jlt_transfer_spectrum *out, const jlt_transfer *transfer, size_t wanted,
                                                     double tolerance, const volatile sig_atomic_t *interrupt);
void jlt_transfer_spectrum_clear(jlt_transfer_spectrum *self); /* legal when zeroed */

/** The number of eigenvalues within `distance` of the leading one, itself included. If it is more than 1, the stationary masses
 *  are not unique. */
size_t jlt_transfer_spectrum_multiplicity(const jlt_transfer_spectrum *self, double distance);

/** The shares of the mass v, shape (transfer->count,), lost at each step, by kind: lost, shape (losses,). Returns their sum. */
double jlt_transfer_spectrum_losses(double *lost, const jlt_transfer *transfer, const double *v);

/** Mean time of a step, over the mass v that is not lost. */
double jlt_transfer_spectrum_time(const jlt_transfer *transfer, const double *v);

/** The set of boxes where `second` has the sign `sign`, +1 or -1. Out: *mass, its share of the mass v; *kept, the share of that
 *  mass that is in the set after a step too, NaN if it is empty. */
void jlt_transfer_spectrum_set(double *mass, double *kept, const jlt_transfer *transfer, const double *v, const double *second,
                               int sign);

#endif
