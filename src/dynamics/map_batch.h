/** The return map and its derivative at many points at once: one in each lane of a vector, by the variational equations on batched
 *  kernels. What comes out for a point depends neither on the others, nor on their order, nor on the number of threads.
 *
 *  A lane ends early near a pole, or when its orbit has all but come to rest. Such an orbit is followed on from there by the
 *  flow's own method, alone, so that its fate is the one that a jlt_map finds. So are all orbits where lanes do not serve: on
 *  sections of a state with turns, with an end in time, or of many states. Points of several flows, such as those of one model
 *  under different parameters, go side by side: jlt_map_batch_add. */
#ifndef JLT_DYNAMICS_MAP_BATCH_H
#define JLT_DYNAMICS_MAP_BATCH_H

#include "dynamics/map.h"

struct jlt_batch_method;

typedef struct jlt_map_batch jlt_map_batch;

/** Create it. kernels: those of the flow's field, see jlt_batch_isa_best, NULL where there are none; method: NULL for the cheaper
 *  one for the tolerance; threads: 0 and 1 are the caller's alone. What the flow points to must live as long. Errors: as
 *  jlt_map_create. */
JLT_CHECKED jlt_status jlt_map_batch_create(jlt_map_batch **out, const jlt_flow *flow, const jlt_kernel_batch *kernels,
                                            const struct jlt_batch_method *method, unsigned threads);
void jlt_map_batch_destroy(jlt_map_batch *self); /* NULL is legal */

/** One more flow, whose points jlt_map_batch_apply_flows takes beside those of the others: in parameters, levels and units alone it
 *  may differ from the first. What it points to must live as long. Out: *index: 1, 2, ...; the flow of creation is 0. Errors: ARG,
 *  it differs in more; NOMEM. */
JLT_CHECKED jlt_status jlt_map_batch_add(jlt_map_batch *self, size_t *index, const jlt_flow *flow);

/** Whether points go in lanes, by a batch's method; if not, all go alone, by the flow's. */
bool jlt_map_batch_in_lanes(const jlt_map_batch *self);

/** Images of points, as of jlt_image: arrays of the caller, with an entry for each point. */
typedef struct {
    jlt_status *status;        /* what jlt_map_apply would return; where not OK the other entries are undefined */
    double *q, *slope;         /* (count, dim), (count, dim, dim) */
    double *T;                 /* [time] that all returns took, negative backwards */
    double *determinant;       /* of slope: product over the returns */
    double *expansion;         /* integral of the divergence on the levels */
    double *defect;            /* of det DP against flux and divergence, relative to the product of DP's row lengths; of the return
                                  where it is largest */
} jlt_map_images;

/** Allocate the arrays for the images of count points of a section with d coordinates. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_map_batch_images(jlt_map_images *out, unsigned d, size_t count);
void jlt_map_batch_images_clear(jlt_map_images *self); /* legal on zeroed ones */

/** P^returns and its derivative, returns >= 1, at points q, shape (count, dim); time_direction +1 or -1. out->q may be q. An
 *  interrupt leaves NO_CONVERGENCE in the status of points that are not done. Errors: ARG; NOMEM; as jlt_batch_section. */
JLT_CHECKED jlt_status jlt_map_batch_apply(jlt_map_batch *self, const jlt_map_images *out, const double *q, size_t count,
                                           size_t returns, int time_direction);

/** The same with a number of returns, 0 or more, and a direction of time for each point: shape (count,). Lanes are filled with
 *  those that go on in the same direction, of points that stand near each other. */
JLT_CHECKED jlt_status jlt_map_batch_apply_each(jlt_map_batch *self, const jlt_map_images *out, const double *q, size_t count,
                                                const size_t *returns, const int *time_direction);

/** One return of a point: the image, shape (dim,), DP there, shape (dim, dim), |det DP| as flux and divergence tell it, the time,
 *  and the integral of the divergence. */
typedef struct {
    const double *q, *slope;
    double flux_determinant, T, expansion;
} jlt_map_batch_return;

/** Told of every return of each point in order; of several points by several threads at once. */
typedef void (*jlt_map_batch_observer)(void *context, size_t point, const jlt_map_batch_return *made);

/** As jlt_map_batch_apply forwards, at points each of which has its own flow, by index; flow_of, shape (count,). observer may be
 *  NULL. */
JLT_CHECKED jlt_status jlt_map_batch_apply_flows(jlt_map_batch *self, const jlt_map_images *out, const double *q,
                                                 const size_t *flow_of, size_t count, size_t returns,
                                                 jlt_map_batch_observer observer, void *context);

/** The flows as given, the first and those added, by index. */
const jlt_flow *jlt_map_batch_flow(const jlt_map_batch *self);

#endif
