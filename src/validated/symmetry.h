/** Proofs that a periodic orbit is its own mirror image.
 *
 *  A reversor R changes signs of states, and maps solutions to solutions run backwards. If it flips the section's state, whose
 *  value there is 0, it maps the section to itself and preserves the rate of that state: upward crossings are mapped to upward
 *  crossings. If an integral is even, or is odd and has the level 0, R maps its level set to itself. Parities are determined from
 *  the program of the integrals, operation by operation.
 *
 *  A cycle through y_0, ..., y_(L-1) that takes the time T_i from y_i to y_(i+1) has the image z_j = R y_(k-j), a cycle on the
 *  same levels that takes the time T_(k-j-1) from z_j to z_(j+1). If for some k each z_j lies in the box of y_j, and that time
 *  within the window in which starts in this box cross the section exactly once, then the z_j solve the equations of cycle.h in
 *  these boxes, whose solution is unique: z_j = y_j.
 *
 *  With P the map of all legs, R P R is the inverse of P on the section. So R DP(y_0) R = DP(y_k)^-1, and DP(y_k) is conjugate to
 *  DP(y_0) along the orbit: DP on the levels is conjugate to its inverse. With mu, 1/mu is a multiplier of equal multiplicity; det
 *  DP is its own inverse, and positive, hence 1. Two multipliers are the roots of mu^2 - trace mu + 1.
 *
 *  Source: R. L. Devaney, Trans. AMS 218, 1976; J. S. W. Lamb, J. A. G. Roberts, Physica D 112, 1998. */
#ifndef JLT_VALIDATED_SYMMETRY_H
#define JLT_VALIDATED_SYMMETRY_H

#include "validated/cycle.h"

typedef enum {
    JLT_SYMMETRY_UNSETTLED,         /* |trace| may be 2 */
    JLT_SYMMETRY_ELLIPTIC,          /* |trace| < 2 */
    JLT_SYMMETRY_HYPERBOLIC,        /* trace > 2 */
    JLT_SYMMETRY_INVERSE_HYPERBOLIC /* trace < -2 */
} jlt_symmetry_type;

typedef enum {
    JLT_SYMMETRY_PROVED,
    JLT_SYMMETRY_NO_REVERSOR, /* no reversor that is proved without a condition maps section and levels to themselves */
    JLT_SYMMETRY_ASYMMETRIC   /* the cycle is not proved to be its own image */
} jlt_symmetry_verdict;

typedef struct {
    jlt_symmetry_verdict verdict;
    const jlt_reversor *reversor;
    jlt_symmetry_type type; /* of a cycle with two multipliers, from its trace */
    arb_t rotation;         /* arccos(trace/2)/(2 pi), if the type is ELLIPTIC */
} jlt_symmetry_result;

void jlt_symmetry_result_init(jlt_symmetry_result *result); /* release with jlt_symmetry_result_clear */
void jlt_symmetry_result_clear(jlt_symmetry_result *result);

/** Prove the symmetry, by the first of the table's reversors for which it succeeds. In: cycle, PROVED from this box and these
 *  instants. Errors: as jlt_arrival_compute; ARG, not two multipliers. */
JLT_CHECKED jlt_status jlt_symmetry_prove(jlt_cycle *of, jlt_symmetry_result *result, const jlt_cycle_result *cycle, arb_srcptr box,
                                          arb_srcptr instants);

/** See from the orbit's points in doubles, x, shape (legs, states), whether a symmetry may be proved. Out: *miss, by how much the
 *  points miss their images, relative to the largest of their numbers, under that proved reversor for which it is least; INFINITY:
 *  none maps the section and the levels to themselves. Errors: as jlt_cycle_create. */
JLT_CHECKED jlt_status jlt_symmetry_foresee(double *miss, const jlt_cycle_question *question, const double *x, unsigned legs);

/** Whether the reversor with these signs, shape (states,), maps the section and the levels to themselves. */
bool jlt_symmetry_keeps(const jlt_cycle *of, const signed char *signs);

/** Whether the cycle is proved to be its own image under this reversor, which must map section and levels to themselves
 *  (jlt_symmetry_keeps). Inputs and errors: as jlt_symmetry_prove. */
JLT_CHECKED jlt_status jlt_symmetry_maps(jlt_cycle *of, bool *symmetric, const jlt_cycle_result *cycle, arb_srcptr box,
                                         arb_srcptr instants, const signed char *signs);

#endif
