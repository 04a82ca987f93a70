/** The tree of periodic orbits as a parameter or level varies: a branch, the branches that begin at its bifurcations, and so on. */
#ifndef JLT_DYNAMICS_TREE_H
#define JLT_DYNAMICS_TREE_H

#include "dynamics/continuation.h"

/* How a branch ended, or that none was found at a bifurcation. */
typedef struct {
    bool found;
    size_t branch;
    const jlt_continuation_point *origin; /* the bifurcation at which it begins; NULL: the first branch */
    int side;                             /* of the origin, where no branch was found */
    bool is_known;                        /* the branch reached a bifurcation of branch `known` and coincides with it from there */
    size_t known;
    jlt_status status;                    /* valid when !is_known */
    jlt_continuation_end end;             /* valid when found, !is_known and status is JLT_OK */
} jlt_tree_end;

/* Functions of the caller that are called as the tree grows. */
typedef struct {
    jlt_status (*point)(void *context, size_t branch, const jlt_continuation_point *point); /* if it returns NOMEM or IO, or any
                                                              error on the first branch, all ends; on others the branch ends */
    void (*end)(void *context, const jlt_tree_end *end);
    void *context;
} jlt_tree_sink;

/* Bifurcations whose branches were not followed: of the last generation, and period doublings of orbits too long. */
typedef struct {
    size_t last, longer;
} jlt_tree_left;

/** Follow the branch of the first orbit, then branches that begin on it, for that many generations: on both sides of a branch
 *  point, on one side of a period doubling. Sections of two coordinates only, where generations > 0. Errors: NOMEM; those of the
 *  sink; of the first branch those of jlt_continuation_run. */
JLT_CHECKED jlt_status jlt_tree_grow(jlt_tree_left *left, const jlt_chart *chart, const jlt_family *family,
                                     const jlt_continuation_point *first, int direction, size_t generations,
                                     const jlt_continuation_options *options, const jlt_tree_sink *sink);

#endif
