/** A descriptor with parameter values: everything a kernel call needs besides the state. */
#ifndef JLT_KERNEL_INSTANCE_H
#define JLT_KERNEL_INSTANCE_H

#include <stdbool.h>

#include "core/status.h"
#include "kernel/units.h"

typedef struct {
    const jlt_descriptor *descriptor;
    double *params; /* shape (param_count,), owned, in the table's units */
    double *block;  /* shape (block_count,), owned, prepared from params */
} jlt_instance;

/** Bind a descriptor to parameters, checked against the table's conditions and prepared.
 *  Out: *instance, NULL on failure; destroy with jlt_instance_destroy. In: params, shape (param_count,), copied.
 *  Errors: ARG, NONFINITE, DOMAIN, NOMEM. */
JLT_CHECKED jlt_status jlt_instance_create(jlt_instance **instance, const jlt_descriptor *descriptor,
                                           const double *params);

/** The same for states counted in units of their own: the block is prepared from the parameters in these. */
JLT_CHECKED jlt_status jlt_instance_create_in(jlt_instance **instance, const jlt_descriptor *descriptor, const double *params,
                                              const jlt_units *units);
void jlt_instance_destroy(jlt_instance *instance); /* legal on NULL */

/** Whether the field is the same in these units: so it is where each of its terms has the dimension that the units of states and
 *  parameters say, and there is no number with a dimension of its own. Found by evaluation at generic states of several sizes, where
 *  both must agree to the bit. Errors: as jlt_instance_create. */
JLT_CHECKED jlt_status jlt_instance_scales(bool *scales, const jlt_descriptor *descriptor, const double *params,
                                           const jlt_units *units);

/** Checked forms, as jlt_kernel_eval; x, shape (states,), must lie in the table's domain (else DOMAIN). */
JLT_CHECKED jlt_status jlt_instance_rhs(const jlt_instance *instance, double *f, const double *x);
JLT_CHECKED jlt_status jlt_instance_jacobian(const jlt_instance *instance, double *jacobian, const double *x);
JLT_CHECKED jlt_status jlt_instance_divergence(const jlt_instance *instance, double *divergence, const double *x);
JLT_CHECKED jlt_status jlt_instance_gradients(const jlt_instance *instance, double *gradients, const double *x);

#endif
