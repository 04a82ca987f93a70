/** Crossings of an unstable and a stable branch: homoclinic (or heteroclinic) points, their angles, and the lobes between them. */
#ifndef JLT_DYNAMICS_HOMOCLINIC_H
#define JLT_DYNAMICS_HOMOCLINIC_H

#include "dynamics/branch_area.h"

/* Candidates are refined in blocks of this many, in order along the unstable branch, up to the first block without a crossing. */
#define JLT_HOMOCLINIC_ROW 64

typedef struct {
    double q[2];
    double sigma_unstable, sigma_stable; /* parameters on the two branches */
    double angle;       /* from the unstable to the stable tangent as lines, in (-pi/2, pi/2], in section coordinates */
    double angle_error; /* twice the largest change of angle by a tolerance ten times larger, also on bent branches, or by branches
                           that begin nearer to the saddle; at least the tolerance, or the residual, times `turn` */
    double turn;        /* of the angle, for a unit of error across both tangents in scaled coordinates */
    double residual;    /* distance of the two branches' points after refinement */
    struct {
        double q[2], sigma[2];
    } again; /* the point and its parameters at ten times the tolerance, on bent branches */
    jlt_branch_area area[2]; /* along the unstable and along the stable branch, at this point; 0 until the caller sets them */
    double lobe;        /* area in section coordinates that the branches enclose between this crossing and the next one along the
                           unstable branch, > 0 where it lies to the left of the unstable branch; NaN until it is measured, for the
                           last crossing, where the two branches wind around an angle a different number of times, and where a
                           branch has no points in between */
    double lobe_error;  /* by interpolation and tolerance (jlt_branch_area); jlt_separatrices_cross adds twice the change of the
                           lobe for the points `again` */
} jlt_homoclinic;

/** Find all crossings of two polygons and refine each by Newton's method on the branches, with tangents from the variational
 *  equations. Out: *points, shape (*count,), sorted along the unstable branch, for the caller to free(); NULL and 0 when there are
 *  none. *touching, unless NULL: the number of crossings left out. At some the branches may only touch: the angle is 0 within its
 *  error, the saddle is nearer than JLT_BRANCH_SEED_LEAST, or the angle is so small that the point's position is not known to
 *  JLT_MANIFOLD_FINEST. At others, of the polygons, Newton's method does not come to a residual of 1e-8 plus that of rounding in
 *  one return, or they follow a block of JLT_HOMOCLINIC_ROW without a crossing. In: mirrored, the stable branch and its polygon are
 *  the images of the unstable ones under the chart's reversor, so that crossings come in pairs, of which one is refined; fine, maps
 *  of the branches' section; coarse, the same maps at ten times the tolerance, from which angle_error is found. Errors:
 *  NO_CONVERGENCE, interrupted (flow.interrupt of fine); NOMEM; as jlt_map_batch_apply. Cost: count_u*count_s comparisons, and
 *  about 24 branch points a crossing that is refined, all crossings of a block at once. */
JLT_CHECKED jlt_status jlt_homoclinic_find(jlt_homoclinic **points, size_t *count, size_t *touching, const jlt_manifold *unstable,
                                           const jlt_branch *unstable_branch, const jlt_manifold *stable,
                                           const jlt_branch *stable_branch, bool mirrored, jlt_map_batch *fine,
                                           jlt_map_batch *coarse);

/** Reflect the crossings of two branches, shape (count,), under their chart's reversor: they become those of the branches' images,
 *  as near to either as their residuals say. Out: *out, shape (count,), as by jlt_homoclinic_find. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_homoclinic_reflect(jlt_homoclinic **out, const jlt_homoclinic *points, size_t count,
                                              const jlt_chart *chart);

/** Set `lobe`, and the part of lobe_error that their areas have, of crossings in order, shape (count,), from their areas. */
void jlt_homoclinic_measure_lobes(jlt_homoclinic *points, size_t count, const jlt_chart *chart);

#endif
