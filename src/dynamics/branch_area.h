/** Areas between pieces of a branch and their chords, of which those of lobes are made. */
#ifndef JLT_DYNAMICS_BRANCH_AREA_H
#define JLT_DYNAMICS_BRANCH_AREA_H

#include "dynamics/manifold.h"

/** At one point of a branch, counted from the first point that was asked for; all in section coordinates, not scaled. */
typedef struct {
    double at[2]; /* where the point is, along the branch: where coordinates are angles this may be turns away */
    double area;  /* integral of (x dy - y dx)/2 along the branch, in these coordinates */
    double error; /* of the area by interpolation: what fewer corners change it by, summed over pieces */
} jlt_branch_area;

/** Integrate along a branch to some of its points: a lobe may be far thinner than the sides of the branch's polygon lie beside the
 *  branch. Between two corners polynomials of degree 7 and 5 through neighbours are taken for the branch, if they lie apart by no
 *  more than 1e-11 over the length between the corners, in the coordinates' sizes; where they do not, more corners are found.
 *  Where sixteen halvings do not help, as at noise, Gauss's five nodes with tangents serve, until halves are no better. Out: areas,
 *  shape (count,), NaN beyond where the branch has no points.
 *  In: curve, the branch's polygon; sigma, q, shape (count,) and (count, 2), the points; maps of the branch's section.
 *  Errors: NOMEM; as jlt_map_batch_apply. Cost: about two branch points without tangents for each corner between the points. */
JLT_CHECKED jlt_status jlt_branch_area_to(jlt_branch_area *areas, const jlt_branch *branch, const jlt_manifold *curve,
                                          const double *sigma, const double *q, size_t count, jlt_map_batch *maps);

/** The area between the branch from one point to another and the chord back, > 0 where it lies to the left of the branch. */
double jlt_branch_area_between(const jlt_branch_area *from, const jlt_branch_area *to);

/** That of the mirror image at the image of the point, from where the image of the first point is. */
jlt_branch_area jlt_branch_area_mirrored(const jlt_branch_area *area, const jlt_chart *chart);

#endif
