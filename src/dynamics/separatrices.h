/** The separatrices of a saddle of a two-dimensional map: both branches of either manifold, and where they cross. */
#ifndef JLT_DYNAMICS_SEPARATRICES_H
#define JLT_DYNAMICS_SEPARATRICES_H

#include "dynamics/homoclinic.h"

enum { JLT_SEPARATRICES = 4 }; /* unstable on side +1, on side -1; stable on side +1, on side -1 */

typedef struct {
    const jlt_chart *chart;
    jlt_branch branch[JLT_SEPARATRICES];
    jlt_manifold curve[JLT_SEPARATRICES];
    int original[JLT_SEPARATRICES]; /* the unstable branch that a stable one is the mirror image of; JLT_SEPARATRICES: there is
                                       none */
    jlt_homoclinic *crossings[2][2]; /* owned; indices: sides of the unstable and of the stable branch, 0 for +1 and 1 for -1 */
    jlt_manifold_options growth;     /* by which the curves are grown */
    size_t count[2][2], touching[2][2]; /* as by jlt_homoclinic_find */
} jlt_separatrices;

/** Grow all four; a stable branch that is the mirror image of an unstable one is reflected. In/out: *self, zeroed before; the map
 *  must outlive it. kernels, threads: as for jlt_map_batch_create. Give *self to jlt_separatrices_clear whatever is returned.
 *  Errors: those of jlt_branch_init and jlt_manifold_grow. */
JLT_CHECKED jlt_status jlt_separatrices_grow(jlt_separatrices *self, jlt_map *map, const jlt_periodic *saddle, double seed,
                                             const jlt_manifold_options *options, const jlt_kernel_batch *kernels,
                                             unsigned threads);

/** Find where the grown branches cross, and the lobes: fills crossings, count and touching. Of crossings that are mirror images of
 *  each other one is refined. For the errors of lobes all branches are grown once more. Errors: those of jlt_homoclinic_find and
 *  jlt_manifold_grow. */
JLT_CHECKED jlt_status jlt_separatrices_cross(jlt_separatrices *self);
void jlt_separatrices_clear(jlt_separatrices *self); /* legal when zeroed */

#endif
