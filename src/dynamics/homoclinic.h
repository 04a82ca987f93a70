/** Where an unstable and a stable branch cross: homoclinic (or heteroclinic) points, their angles, and the lobes between. */
#ifndef JLT_DYNAMICS_HOMOCLINIC_H
#define JLT_DYNAMICS_HOMOCLINIC_H

#include "dynamics/manifold.h"

typedef struct {
    double q[2];
    double sigma_unstable, sigma_stable; /* parameters on the two branches */
    double angle;       /* from the unstable to the stable tangent as lines, in (-pi/2, pi/2], in section coordinates */
    double angle_error; /* the most that a tolerance ten times larger, a seed twice as large, or both change, doubled */
    double residual;    /* distance of the two branches' points after refinement */
    double lobe;        /* area between this crossing and the next one along the unstable branch, signed; NaN at the last */
} jlt_homoclinic;

/** All crossings of two polygons, refined by Newton's method on the branches with tangents from the variational equations,
 *  sorted along the unstable branch. Out: *points, (count,), owned by the caller (free); none: NULL, 0.
 *  coarse: maps for the error bar, of ten times the tolerance.
 *  Errors: NOMEM, those of the integrator. Cost: count_u*count_s comparisons, and about 20 branch points a crossing. */
JLT_CHECKED jlt_status jlt_homoclinic_find(jlt_homoclinic **points, size_t *count, const jlt_manifold *unstable,
                                           const jlt_branch *unstable_branch, const jlt_manifold *stable,
                                           const jlt_branch *stable_branch, jlt_map *coarse);

#endif
