/** Proves that symmetric elliptic cycles are stable, by a twist.
 *
 *  If lambda^k != 1 for k = 1 .. 4, that is |trace| < 2 and trace is not -1 or 0, the return map on the levels has the normal form
 *  of normal_form.h, with growth 0, since it is reversible: with y_k the image of the first point (symmetry.h), S = P^-k R is an
 *  involution near that point that takes the map M of all legs to its inverse. Its fixed points form a curve there: if DS were 1
 *  or -1, the derivative of S M S = M^-1 would give lambda^2 = 1, so DS has the eigenvalues 1 and -1. If the twist is not 0, the
 *  theorem on invariant curves of reversible analytic maps applies: every neighbourhood of the point on the section contains
 *  invariant closed curves around it with quasi-periodic motion, and the share of its area outside such curves tends to 0 with its
 *  size. Orbits between two curves stay there: the cycle is stable on its levels.
 *
 *  Source: J. Moser, Stable and Random Motions, 1973; V. I. Arnold, Reversible systems, 1984; M. B. Sevryuk, Reversible Systems,
 *  Lecture Notes in Mathematics 1211, 1986. */
#ifndef JLT_VALIDATED_ELLIPTIC_H
#define JLT_VALIDATED_ELLIPTIC_H

#include "validated/normal_form.h"
#include "validated/symmetry.h"

typedef enum {
    JLT_ELLIPTIC_PROVED,
    JLT_ELLIPTIC_OTHER,       /* the cycle is not proved to be elliptic */
    JLT_ELLIPTIC_RESONANT,    /* lambda^3 or lambda^4 may be 1 */
    JLT_ELLIPTIC_UNTWISTED,   /* the twist may be 0 */
    JLT_ELLIPTIC_CONTRADICTED /* traces, determinant or growth exclude the values that they must have: an error of this program */
} jlt_elliptic_verdict;

typedef struct {
    jlt_elliptic_verdict verdict;
    jlt_normal_form form; /* in the first of the kept states as coordinate */
} jlt_elliptic_result;

void jlt_elliptic_result_init(jlt_elliptic_result *result); /* release with jlt_elliptic_result_clear */
void jlt_elliptic_result_clear(jlt_elliptic_result *result);

/** Prove stability. In: cycle, PROVED from these instants, with two multipliers and this type of symmetry; kept, shape (2,).
 *  Errors: as jlt_taylor_map_compute. */
JLT_CHECKED jlt_status jlt_elliptic_prove(jlt_cycle *of, jlt_elliptic_result *result, const jlt_cycle_result *cycle,
                                          jlt_symmetry_type type, arb_srcptr instants, const unsigned *kept);

#endif
