/** What a branch sweeps: areas between pieces of it and their chords, of which those of lobes are made. */
#ifndef JLT_DYNAMICS_SWEEP_H
#define JLT_DYNAMICS_SWEEP_H

#include "dynamics/manifold.h"

/** At one point of a branch, counted from the first point that was asked for; all in section coordinates, not scaled. */
typedef struct {
    double at[2]; /* where the point is, along the branch: where coordinates are angles this may be turns away */
    double area;  /* integral of (x dy - y dx)/2 along the branch, in these coordinates */
} jlt_sweep;

/** Integrate along a branch to some of its points: a lobe may be far thinner than the sides of the branch's polygon lie beside the
 *  branch. Four sides at once are integrated by Gauss's five nodes, and halved until the gap between their end and where tangents
 *  lead, times their length, is below 1e-11 squares of the coordinates' sizes, or is that of the points. Out: sweeps, shape
 *  (count,); areas are NaN beyond where the branch has no points.
 *  In: curve, the branch's polygon; sigma, q, shape (count,) and (count, 2), the points; maps of the branch's section.
 *  Errors: NOMEM; as jlt_map_batch_apply. Cost: between the points about a branch point with its tangent a side, and more at folds
 *  and at the points; many at once. */
JLT_CHECKED jlt_status jlt_sweep_to(jlt_sweep *sweeps, const jlt_branch *branch, const jlt_manifold *curve, const double *sigma,
                                    const double *q, size_t count, jlt_map_batch *maps);

/** The area between the branch from one point to another and the chord back, > 0 where it lies to the left of the branch. */
double jlt_sweep_between(const jlt_sweep *from, const jlt_sweep *to);

/** The sweep of the mirror image at the image of the point, from where the image of the first point is. */
jlt_sweep jlt_sweep_mirrored(const jlt_sweep *sweep, const jlt_chart *chart);

#endif
