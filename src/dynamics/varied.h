/** The variational equations of a field along an orbit, as a field of its own: states, tangent vectors one after another, and the
 *  integral of the divergence. */
#ifndef JLT_DYNAMICS_VARIED_H
#define JLT_DYNAMICS_VARIED_H

#include "dynamics/chart.h"
#include "dynamics/varied_batch.h"

enum { JLT_VARIED_DIM_MAX = JLT_CHART_STATES_MAX * (1 + JLT_CHART_DIM_MAX) + 1 };

typedef struct {
    const jlt_field *plain;
    jlt_kernel_function rhs_jacobian; /* f, then df/dx, on the plain field's prepared values; NULL: two calls */
    unsigned tangents;                /* tangent vectors */
    jlt_field field;                  /* the varied field: f, J Y and the trace of J; its `p` is this structure */
    jlt_kernel_batch batch;           /* the varied field on vectors, for the method gauss */
    double *spread;                   /* the plain field's prepared values in every lane; owned; NULL: there is no `batch` */
    jlt_varied_batch *products;  /* computes J Y and the trace on vectors */
    double scale[JLT_VARIED_DIM_MAX]; /* scale of `field`: that of the plain field for its states, 1 for all else but what
                                       * jlt_varied_begin says */
} jlt_varied;

/** Make the field in place, for jlt_varied_clear: it points into *self, which must stay where it is, as must `plain`. It has a
 *  `batch` where the plain field has kernels on vectors and at most JLT_BATCH_STATES_MAX states. Errors: UNSUPPORTED, no Jacobian
 *  is known; NOMEM. */
JLT_CHECKED jlt_status jlt_varied_make(jlt_varied *self, const jlt_field *plain, jlt_kernel_function rhs_jacobian,
                                       unsigned tangents);
void jlt_varied_clear(jlt_varied *self); /* legal on a zeroed one */

/** Whether a kept state (jlt_field) of x, shape (n,), is 0, or all states of a group are. Components of tangent vectors along these
 *  states may fall below what the tolerance resolves, and grow again. */
bool jlt_varied_is_kept(const jlt_field *plain, const double *x);

/** Set the scales before an orbit begins in x, shape (n,): 0, for relative errors, for tangents' components along kept states that
 *  stay 0, and 1 for all others. */
void jlt_varied_begin(jlt_varied *self, const double *x);

/** Compute the plain field, then its Jacobian, at x: both, shape (n + n*n,). */
void jlt_varied_linear(const jlt_varied *self, const double *x, double *both);

#endif
