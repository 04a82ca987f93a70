/** Krawczyk's operator, and Newton's method for guesses.
 *
 *  With G the equations, y0 the midpoint of a box Y and M an approximation of DG(y0)^-1,
 *      K = y0 - M G(y0) + (1 - M DG(Y)) (Y - y0).
 *  If K lies in the interior of Y, then G has exactly one zero in Y, the zero lies in K, and DG is invertible all over Y
 *  (R. Krawczyk 1969; W. Tucker, Validated Numerics, 2011). */
#ifndef JLT_VALIDATED_KRAWCZYK_H
#define JLT_VALIDATED_KRAWCZYK_H

#include "core/status.h"
#include "ext/scoped.h"

#include <stdbool.h>

typedef struct {
    slong n, bits;
    /* Set G, shape (n, 1), and DG, shape (n, n), both zero before, to enclosures over the box y, shape (n,). */
    jlt_status (*equations)(void *context, arb_mat_t G, arb_mat_t DG, arb_srcptr y);
    void *context;
} jlt_krawczyk;

/** Compute an exact M close to the inverse of DG's midpoint, both of shape (n, n). Returns false if that may be singular. */
bool jlt_krawczyk_invert(arb_mat_t M, const arb_mat_t DG, slong bits);

/** Improve a guess by Newton's method at midpoints, until a correction is below 2^-accuracy; nothing is rigorous here. In/out: y,
 *  shape (n,), exact. Errors: those of the equations; NO_CONVERGENCE, also if a correction is 1 or more. */
JLT_CHECKED jlt_status jlt_krawczyk_refine(const jlt_krawczyk *self, arb_ptr y, double accuracy);

typedef enum {
    JLT_KRAWCZYK_PROVED,
    JLT_KRAWCZYK_UNSHOWN,      /* the operator leaves the box */
    JLT_KRAWCZYK_CONTRADICTED  /* enclosures of the same zero are disjoint: an error of this program */
} jlt_krawczyk_verdict;

/** Prove that `box`, shape (n,), contains exactly one zero, then contract the box, as long as each step shrinks it to an eighth.
 *  Out: verdict; solution, shape (n,), which contains the zero, and over which the equations were evaluated last; untouched if the
 *  verdict is UNSHOWN. Errors: those of the equations. */
JLT_CHECKED jlt_status jlt_krawczyk_prove(const jlt_krawczyk *self, jlt_krawczyk_verdict *verdict, arb_ptr solution,
                                          arb_srcptr box);

#endif
