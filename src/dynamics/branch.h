/** A branch of the stable or unstable manifold of a saddle of a two-dimensional map, as a parametrised curve.
 *
 *  With F = P^(period), squared where the multiplier is negative, lambda > 1 the multiplier of F (of its inverse for the stable
 *  manifold) and v its unit eigenvector,
 *
 *      gamma(sigma) = F^n(q + side * seed * lambda^(sigma - n) v),   n = ceil(sigma),   sigma >= 0:
 *
 *  One unit of sigma is one fundamental domain. Whatever lambda is, F^n starts within `seed` of the saddle. There the start is off
 *  the manifold by O(seed^2), a distance that every F multiplies by the other multiplier, and off along the manifold, which only
 *  shifts sigma by O(seed), by different amounts on the two sides of a whole sigma. A bent branch starts on a parabola, which F
 *  maps to itself to second order: its difference from the other branch shows how large these errors are. */
#ifndef JLT_DYNAMICS_BRANCH_H
#define JLT_DYNAMICS_BRANCH_H

#include "dynamics/map_batch.h"
#include "dynamics/periodic.h"

#define JLT_BRANCH_SEED_LEAST 1e-6
#define JLT_BRANCH_SEED_MOST 1e-3

typedef struct {
    jlt_map *map;
    const jlt_kernel_batch *kernels; /* for points of a curve in lanes, see jlt_batch_isa_best; NULL: each goes alone */
    unsigned threads;   /* for points of a curve; 0 and 1 are the caller's alone */
    double q[2],        /* the saddle's point */
        v[2],           /* the unit eigenvector, times side */
        w[2],           /* the other unit eigenvector */
        bend[2];        /* of the parabola q + r v + r^2 (bend[0] v + bend[1] w); NaN where F does not lead back */
    bool bent;          /* start on the parabola, in place of the tangent line */
    bool near;          /* start nearer to the saddle, with more F, so that the error of the start, which falls as the square of the
                           distance or faster, is at most half as large */
    double lambda;      /* > 1: the factor by which F, or its inverse, multiplies the distance from the saddle */
    size_t returns;     /* of P in one F */
    int time_direction; /* +1 unstable, -1 stable */
    double seed;        /* distance of gamma(0) from the saddle's point, scaled (jlt_chart_scaled) */
} jlt_branch;

/** Take the stable or the unstable branch at the orbit's first point (jlt_periodic_rotate makes another point the first). In: side,
 *  +1 along the eigenvector whose larger component is positive, -1 against it; seed, the distance of the branch's first point, in
 *  [JLT_BRANCH_SEED_LEAST, JLT_BRANCH_SEED_MOST]. Out: a branch that is not bent, without kernels. Errors: ARG, the orbit is no
 *  saddle of a two-dimensional map; side or seed out of range. Cost: one F. */
JLT_CHECKED jlt_status jlt_branch_init(jlt_branch *out, jlt_map *map, const jlt_periodic *saddle, bool stable, int side,
                                       double seed);

/** Compute the point q = gamma(sigma), sigma >= 0.
 *  Errors: ARG, sigma < 0 or not finite; as jlt_map_apply; DOMAIN where the branch ends at a pole, or is on another branch of a
 *  chart that solves for states.
 *  Cost: ceil(sigma)*returns returns. */
JLT_CHECKED jlt_status jlt_branch_point(const jlt_branch *self, double q[2], double sigma);

/** Compute many points at once, q, shape (count, 2): point i at sigma[i] on branches[i], which have map, kernels, threads and time
 *  direction in common. Out: status, shape (count,), what jlt_branch_point would return; where that is not OK q is undefined.
 *  Errors: as jlt_section_batch_run. */
JLT_CHECKED jlt_status jlt_branch_curve(const jlt_branch *const *branches, jlt_status *status, double *q, const double *sigma,
                                        size_t count);

/** The change of sigma that an error of the size of `tolerance` in one F causes. On a piece of the branch that is shorter than that
 *  only the errors of its points show. */
double jlt_branch_blur(const jlt_branch *self, double tolerance);

/** The approximate parameter at which the bent branch comes through the point gamma(sigma) of the branch that is not bent; NaN if
 *  `bend` is NaN. */
double jlt_branch_bent_sigma(const jlt_branch *self, double sigma);

/** Compute many points and tangents at once, point i at sigma[i] on branches[i]; maps: a batch for the branches' section. Out:
 *  status, shape (count,), what jlt_branch_point would return; q, and tangent, its derivative by sigma from the variational
 *  equations, shape (count, 2), untouched where that is not OK. Errors: as jlt_map_batch_apply. */
JLT_CHECKED jlt_status jlt_branch_points(const jlt_branch *const *branches, jlt_map_batch *maps, jlt_status *status, double *q,
                                         double *tangent, const double *sigma, size_t count);

#endif
