/** Krawczyk's operator, and Newton's method for guesses.
 *
 *  With G the equations, y0 the middle of a box Y and M near DG(y0)^-1,
 *      K = y0 - M G(y0) + (1 - M DG(Y)) (Y - y0)
 *  within the interior of Y shows that G has exactly one zero in Y, that it lies in K, and that DG is regular all over Y (R.
 *  Krawczyk 1969; W. Tucker, Validated Numerics, 2011). */
#ifndef JLT_VALIDATED_KRAWCZYK_H
#define JLT_VALIDATED_KRAWCZYK_H

#include "core/status.h"
#include "validated/balls.h"

#include <stdbool.h>

typedef struct {
    slong n, bits;
    /* G, shape (n, 1), and DG, shape (n, n), both zero before, over the box y, shape (n,). */
    jlt_status (*equations)(void *context, arb_mat_t G, arb_mat_t DG, arb_srcptr y);
    void *context;
} jlt_krawczyk;

/** Compute exact numbers M near the inverse of DG's middle; false where none is found. Both of shape (n, n). */
bool jlt_krawczyk_invert(arb_mat_t M, const arb_mat_t DG, slong bits);

/** Newton's method, at middles: a guess, in which nothing is rigorous, made better until a correction is below 2^-accuracy. In and
 *  out: y, shape (n,), exact. Errors: those of the equations; NO_CONVERGENCE, also where a correction is 1 or more. */
JLT_CHECKED jlt_status jlt_krawczyk_refine(const jlt_krawczyk *self, arb_ptr y, double accuracy);

typedef enum {
    JLT_KRAWCZYK_PROVED,
    JLT_KRAWCZYK_UNSHOWN,      /* the operator leaves the box */
    JLT_KRAWCZYK_CONTRADICTED  /* enclosures of one zero exclude each other: an error of this program */
} jlt_krawczyk_verdict;

/** The proof in `box`, shape (n,), then in smaller and smaller ones around the zero, as long as they shrink to an eighth. Out:
 *  verdict; solution, shape (n,), which holds the zero, and over which the equations were evaluated last: untouched where the
 *  verdict is UNSHOWN. Errors: those of the equations. */
JLT_CHECKED jlt_status jlt_krawczyk_prove(const jlt_krawczyk *self, jlt_krawczyk_verdict *verdict, arb_ptr solution,
                                          arb_srcptr box);

#endif
