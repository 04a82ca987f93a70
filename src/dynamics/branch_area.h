/** Areas between pieces of a branch and their chords, from which the areas of lobes follow. */
#ifndef JLT_DYNAMICS_BRANCH_AREA_H
#define JLT_DYNAMICS_BRANCH_AREA_H

#include "dynamics/manifold.h"

/** Area along a branch from its first requested point, the origin, to another one, in section coordinates, not scaled. */
typedef struct {
    double at[2]; /* displacement of the point, added up along the branch: angles are not wrapped */
    double area;  /* integral of (x dy - y dx)/2 along the branch */
    double error; /* of the area: by interpolation, estimates (see jlt_branch_area_to) summed over pieces; and by points that are
                     off by one tolerance across the branch: the tolerance times its length */
} jlt_branch_area;

/** Integrate along a branch from the first of some of its points to each of them. The branch's polygon is too coarse for that: a
 *  lobe may be far thinner than the gap between polygon and branch. Between two corners the branch is interpolated by polynomials
 *  of degrees 7 and 5 through neighbouring corners. Where these differ by more than 1e-11/(length between the corners), scaled,
 *  the piece is halved; their areas' difference is the error estimate. Pieces that sixteen halvings leave, as where errors of
 *  points dominate, are integrated by five Gauss nodes with tangents, and halved while that gains accuracy.
 *  Out: areas, shape (count,), NaN from where the branch has no points.
 *  In: curve, the branch's polygon; sigma, q, shape (count,) and (count, 2), the points; maps of the branch's section.
 *  Errors: NOMEM; as jlt_map_batch_apply. Cost: about two branch points without tangents for each corner between the points. */
JLT_CHECKED jlt_status jlt_branch_area_to(jlt_branch_area *areas, const jlt_branch *branch, const jlt_manifold *curve,
                                          const double *sigma, const double *q, size_t count, jlt_map_batch *maps);

/** The area enclosed by the branch from one point to another and the chord back, > 0 where it lies to the left of the branch. */
double jlt_branch_area_between(const jlt_branch_area *from, const jlt_branch_area *to);

/** The same quantities of the branch's mirror image at the image of the point. */
jlt_branch_area jlt_branch_area_mirrored(const jlt_branch_area *area, const jlt_chart *chart);

#endif
