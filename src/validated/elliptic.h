/** Elliptic symmetric cycles that are stable by a twist.
 *
 *  Where lambda^k != 1 for k = 1 .. 4, that is |trace| < 2 and trace is not -1 or 0, the return map on the levels has the normal
 *  form of normal_form.h, with growth 0, as it is reversible: with y_k the image of the first point (symmetry.h), P^-k R is an
 *  involution S near that point that takes the map M of all legs to its inverse. Its fixed points are a curve there: with DS = +-1
 *  the derivative of S M S = M^-1 would make lambda^2 = 1, so that DS has the eigenvalues 1 and -1. Where the twist is not 0, the
 *  theorem on invariant curves of reversible analytic maps applies: every neighbourhood of the point on the section contains
 *  invariant closed curves around it with quasi-periodic motion, and what they leave over is a part of its area that goes to 0 with
 *  its size. Between them orbits are caught: the cycle is stable on its levels.
 *
 *  Source: J. Moser, Stable and Random Motions, 1973; V. I. Arnold, Reversible systems, 1984; M. B. Sevryuk, Reversible Systems,
 *  Lecture Notes in Mathematics 1211, 1986. */
#ifndef JLT_VALIDATED_ELLIPTIC_H
#define JLT_VALIDATED_ELLIPTIC_H

#include "validated/normal_form.h"
#include "validated/symmetry.h"

typedef enum {
    JLT_ELLIPTIC_PROVED,
    JLT_ELLIPTIC_OTHER,       /* it is not shown to be elliptic */
    JLT_ELLIPTIC_RESONANT,    /* lambda^3 or lambda^4 may be 1 */
    JLT_ELLIPTIC_UNTWISTED,   /* the twist may be 0 */
    JLT_ELLIPTIC_CONTRADICTED /* traces, determinant or growth exclude what they have to be: an error of this program */
} jlt_elliptic_verdict;

typedef struct {
    jlt_elliptic_verdict verdict;
    jlt_normal_form form; /* in the first of the kept states */
} jlt_elliptic_result;

void jlt_elliptic_result_init(jlt_elliptic_result *result); /* ends with jlt_elliptic_result_clear */
void jlt_elliptic_result_clear(jlt_elliptic_result *result);

/** The proof. In: cycle, PROVED from these instants, with two multipliers and this type of symmetry; kept, shape (2,). Errors: as
 *  jlt_taylor_map_compute. */
JLT_CHECKED jlt_status jlt_elliptic_prove(jlt_cycle *of, jlt_elliptic_result *result, const jlt_cycle_result *cycle,
                                          jlt_symmetry_type type, arb_srcptr instants, const unsigned *kept);

#endif
