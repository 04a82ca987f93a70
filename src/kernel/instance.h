/** An instance: a descriptor bound to values of its parameters, which is all that a kernel call needs beside the state. */
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

/** The same for callers who count states in these units: the block is prepared from the parameters converted to them, so that
 *  kernels called with it take and give numbers in them. `params` stays in the table's units. */
JLT_CHECKED jlt_status jlt_instance_create_in(jlt_instance **instance, const jlt_descriptor *descriptor, const double *params,
                                              const jlt_units *units);
void jlt_instance_destroy(jlt_instance *instance); /* legal on NULL */

/** Whether the field may be evaluated in these units: whether every term of an equation has the dimension of that equation, by
 *  the units that the table writes beside its states and parameters. Out: *scales. It is tested, not derived: the field is
 *  evaluated in both units at generic states of several sizes, and the results must agree to the bit. Errors: as
 *  jlt_instance_create. */
JLT_CHECKED jlt_status jlt_instance_scales(bool *scales, const jlt_descriptor *descriptor, const double *params,
                                           const jlt_units *units);

/** Kernels called with all checks of jlt_kernel_eval. In: x, shape (state_count,), in the units of the instance.
 *  Out: f, shape (state_count,); jacobian, shape (state_count, state_count), df_i/dx_j in row i; *divergence; gradients of the
 *  integrals, shape (integral_count, state_count). Errors: DOMAIN, x lies outside the table's domain; as jlt_kernel_eval. */
JLT_CHECKED jlt_status jlt_instance_rhs(const jlt_instance *instance, double *f, const double *x);
JLT_CHECKED jlt_status jlt_instance_jacobian(const jlt_instance *instance, double *jacobian, const double *x);
JLT_CHECKED jlt_status jlt_instance_divergence(const jlt_instance *instance, double *divergence, const double *x);
JLT_CHECKED jlt_status jlt_instance_gradients(const jlt_instance *instance, double *gradients, const double *x);

#endif
