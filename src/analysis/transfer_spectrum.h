/** Leading eigenvalues of a transfer operator, and what they tell: the density that stays, how fast mass is lost, which sets mix
 *  slowly. */
#ifndef JLT_ANALYSIS_TRANSFER_SPECTRUM_H
#define JLT_ANALYSIS_TRANSFER_SPECTRUM_H

#include "analysis/transfer.h"

/** Plain data, owned; clear with jlt_transfer_spectrum_clear. Eigenvectors are masses v of boxes, v P = lambda v, of sum
 *  |v| = 1. */
typedef struct {
    size_t count;     /* of eigenvalues, by descending magnitude, real ones and im > 0 first where that is equal; a pair counts as
                         two */
    double *re, *im;  /* (count,) */
    double *residual; /* (count,): sum of |v P - lambda v|, computed from the matrix */
    double *spread;   /* (count,): distance to the nearest eigenvalue of a second computation, from another start vector. It tells
                         what the residual does not: a Jordan block of size k for the eigenvalue 0 is computed as k values on a
                         circle whose radius is the k-th root of a rounding error, with small residuals */
    size_t told;      /* the first so many agree to three digits in both; the rest is not told from 0, or from others */
    double *leading;  /* (transfer->count,): of the largest real eigenvalue, the masses that stay, >= 0 */
    size_t leading_index;
    double negative;  /* the part of its mass that ARPACK gives the other sign: 0 but for rounding, unless the eigenvalue is not
                         simple */
    double *second;   /* (transfer->count,): of the next positive one; NULL: there is none among those told */
    size_t second_index;
} jlt_transfer_spectrum;

/** Compute `wanted` eigenvalues, 1 <= wanted, up to `tolerance`, by ARPACK. Where the matrix has fewer than wanted + 2 rows, as
 *  many as it allows; where those do not converge, as of mixing maps, whose others lie together on a disc, the leading one alone.
 *  They are computed twice. interrupt: NULL, or what asks to stop.
 *  Errors: ARG, the matrix has less than 3 rows; EMPTY, no box leads back to itself, so that nothing stays; NO_CONVERGENCE, of the
 *  leading one too, also where it is interrupted, or where no eigenvalue found is real; NONFINITE; NOMEM.
 *  Memory: 8 rows (3 wanted + 36) bytes. */
JLT_CHECKED jlt_status jlt_transfer_spectrum_compute(jlt_transfer_spectrum *out, const jlt_transfer *transfer, size_t wanted,
                                                     double tolerance, const volatile sig_atomic_t *interrupt);
void jlt_transfer_spectrum_clear(jlt_transfer_spectrum *self); /* legal when zeroed */

/** How many eigenvalues lie within `distance` of the leading one, which is counted: more than one, and masses that stay are not
 *  unique. */
size_t jlt_transfer_spectrum_multiplicity(const jlt_transfer_spectrum *self, double distance);

/** Shares of the mass v, shape (transfer->count,), that are lost at each step. Out: lost, shape (losses,), by kind. Returns their
 *  sum. */
double jlt_transfer_spectrum_losses(double *lost, const jlt_transfer *transfer, const double *v);

/** Mean time of a step that returns, over mass v. */
double jlt_transfer_spectrum_time(const jlt_transfer *transfer, const double *v);

/** Judge the set of boxes on which `second` has the sign `sign`, +1 or -1. Out: *mass, its part of the mass v; *kept, the part of
 *  that which is in the set after a step too, NaN where it has no mass. */
void jlt_transfer_spectrum_set(double *mass, double *kept, const jlt_transfer *transfer, const double *v, const double *second,
                               int sign);

#endif
