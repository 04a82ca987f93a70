/** The return map and its derivative at many points at once: one in each lane of a vector, by the variational equations on batched
 *  kernels. The result for a point depends neither on the others, nor on their order, nor on the number of threads.
 *
 *  A lane ends early near a pole, when its orbit has all but come to rest, or when steps prove to err by more than the tolerance.
 *  The flow's own method then follows that orbit alone, so that its fate is the one that a jlt_map finds; it follows all orbits
 *  where lanes do not serve: if flow.t_max is set, or with many states. Points of several flows, such as those of one model under
 *  different parameters, go side by side: jlt_map_batch_add. */
#ifndef JLT_DYNAMICS_MAP_BATCH_H
#define JLT_DYNAMICS_MAP_BATCH_H

#include "dynamics/map.h"

struct jlt_batch_method;

typedef struct jlt_map_batch jlt_map_batch;

/** Create a batch. kernels: those of the flow's field, see jlt_batch_isa_best, NULL where there are none; method: NULL for the
 *  usual one for the tolerance; threads: 0 and 1 are the caller's alone. What the flow points to must live as long. Errors: as
 *  jlt_map_create; ARG, kernels of another field. */
JLT_CHECKED jlt_status jlt_map_batch_create(jlt_map_batch **out, const jlt_flow *flow, const jlt_kernel_batch *kernels,
                                            const struct jlt_batch_method *method, unsigned threads);
void jlt_map_batch_destroy(jlt_map_batch *self); /* NULL is legal */

/** Add a flow, whose points jlt_map_batch_apply_flows takes beside those of the others. It may differ from the first in parameters,
 *  levels and units alone, else ARG. What it points to must live as long. Out: *index: 1, 2, ...; that of creation is 0. Errors:
 *  ARG; NOMEM. */
JLT_CHECKED jlt_status jlt_map_batch_add(jlt_map_batch *self, size_t *index, const jlt_flow *flow);

/** Whether points are followed in lanes, by a batched method; if not, each is followed alone, by the flow's method. */
bool jlt_map_batch_in_lanes(const jlt_map_batch *self);

/** Images of points, with the members of jlt_image: arrays of the caller, with an entry for each point. */
typedef struct {
    jlt_status *status;        /* what jlt_map_apply would return; where not OK the other entries are undefined */
    double *q, *slope;         /* (count, dim), (count, dim, dim) */
    double *T;                 /* [time] that all returns took, negative backwards */
    double *determinant;       /* of slope: product over the returns */
    double *expansion;         /* integral of the divergence on the levels */
    double *defect;            /* of det DP against flux and divergence, relative to the product of DP's row lengths; of the return
                                  where it is largest */
    double *bound;             /* on |defect|, of that return; NULL: not wanted. Returns that exceed the least bound possible are
                                  followed alone, which bounds them as jlt_map_apply does */
} jlt_map_images;

/** Allocate the arrays for the images of count points of a section with d coordinates; bound is NULL. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_map_batch_images(jlt_map_images *out, unsigned d, size_t count);
void jlt_map_batch_images_clear(jlt_map_images *self); /* legal on zeroed ones */

/** Compute P^returns and its derivative, returns >= 1, at points q, shape (count, dim); time_direction +1 or -1. out->q may be q.
 *  An interrupt leaves NO_CONVERGENCE in the status of unfinished points. Errors: ARG; NOMEM; as jlt_batch_section. */
JLT_CHECKED jlt_status jlt_map_batch_apply(jlt_map_batch *self, const jlt_map_images *out, const double *q, size_t count,
                                           size_t returns, int time_direction);

/** The same with a number of returns, 0 or more, and a direction of time for each point, shape (count,). Points share vectors that
 *  are near each other in the array and go in the same direction. */
JLT_CHECKED jlt_status jlt_map_batch_apply_each(jlt_map_batch *self, const jlt_map_images *out, const double *q, size_t count,
                                                const size_t *returns, const int *time_direction);

/** One return of a point: the image, shape (dim,), DP, shape (dim, dim), |det DP| by flux and divergence, the time, and the
 *  integral of the divergence. */
typedef struct {
    const double *q, *slope;
    double flux_determinant, T, expansion;
} jlt_map_batch_return;

/** Called for every return of each point, in order; several threads call it at once, for different points. */
typedef void (*jlt_map_batch_observer)(void *context, size_t point, const jlt_map_batch_return *made);

/** As jlt_map_batch_apply forwards, with point i under the flow of index flow_of[i], shape (count,). observer may be NULL.
 *  Errors: as above; ARG, there is no such flow. */
JLT_CHECKED jlt_status jlt_map_batch_apply_flows(jlt_map_batch *self, const jlt_map_images *out, const double *q,
                                                 const size_t *flow_of, size_t count, size_t returns,
                                                 jlt_map_batch_observer observer, void *context);

/** The flows by index: the first, then those added. */
const jlt_flow *jlt_map_batch_flow(const jlt_map_batch *self);

/** The tolerance of all of them, the default where the flow has none. */
double jlt_map_batch_tolerance(const jlt_map_batch *self);

#endif
