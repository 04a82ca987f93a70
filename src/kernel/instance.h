/** An instance: a descriptor bound to parameter values. Kernel calls need nothing else but the state. */
#ifndef JLT_KERNEL_INSTANCE_H
#define JLT_KERNEL_INSTANCE_H

#include "core/status.h"
#include "kernel/units.h"

typedef struct {
    const jlt_descriptor *descriptor;
    double *params;   /* shape (param_count,), owned, in the table's units */
    double *counted;  /* shape (param_count,), owned: parameters in the units of the states, for root kernels */
    double *prepared; /* shape (prepared_count,), owned, made from `counted` */
    jlt_quantity *states; /* shape (state_count,), owned: the descriptor's, but with intervals and periods in the units used here */
} jlt_instance;

/** Bind a descriptor to parameters, which are checked against the table's conditions. Expressions of parameters alone are
 *  evaluated here, once, into the prepared values.
 *  Out: *instance, NULL on failure; destroy it with jlt_instance_destroy. In: descriptor, which must outlive the instance; params,
 *  shape (param_count,), in the order of descriptor->params, copied.
 *  Errors: ARG, descriptor or params is NULL; NONFINITE, a parameter or a prepared value; DOMAIN, the parameters break a condition
 *  of the table, such as m > 0 (jlt_descriptor_check_params and jlt_region_check tell which); NOMEM. */
JLT_CHECKED jlt_status jlt_instance_create(jlt_instance **instance, const jlt_descriptor *descriptor,
                                           const double *params);

/** The same for callers who count states in other units than the table's (kernel/units.h): the prepared values are computed from
 *  the parameters in these units, so kernels called with this instance take states and give results in them. `params`, here and in
 *  the instance, is in the table's units. */
JLT_CHECKED jlt_status jlt_instance_create_in(jlt_instance **instance, const jlt_descriptor *descriptor, const double *params,
                                              const jlt_units *units);

/** Choose units for a motion of the model in which its numbers are of the order of 1: units of mass and length from parameters and
 *  states; the unit of time from the rates that the sizes of the states suggest, and from those that the field gives at x with all
 *  states whose unit contains time set to zero. In: params, shape (param_count,), and x, shape (state_count,), the initial state
 *  or typical sizes of the states, in the table's units. Errors: as jlt_instance_create. */
JLT_CHECKED jlt_status jlt_instance_units(jlt_units *out, const jlt_descriptor *model, const double *params, const double *x);
void jlt_instance_destroy(jlt_instance *instance); /* legal on NULL */
JLT_OWNED_TYPE(jlt_instance)

/** Evaluate the field, or what derives from it, at one state. The state must be in the domain; the evaluation is checked as
 *  jlt_kernel_eval does. In: x, shape (state_count,), in the order of descriptor->states and the units of the instance.
 *  Out: f, shape (state_count,); jacobian, shape (state_count, state_count), df_i/dx_j in row i; *divergence; gradients of the
 *       integrals, shape (integral_count, state_count), dF_i/dx_j in row i; untouched on failure.
 *  Errors: NONFINITE, x or a result; DOMAIN, x outside the domain, a division by zero or a root of a negative number; UNSUPPORTED,
 *       no such kernel. */
JLT_CHECKED jlt_status jlt_instance_rhs(const jlt_instance *instance, double *f, const double *x);
JLT_CHECKED jlt_status jlt_instance_jacobian(const jlt_instance *instance, double *jacobian, const double *x);
JLT_CHECKED jlt_status jlt_instance_divergence(const jlt_instance *instance, double *divergence, const double *x);
JLT_CHECKED jlt_status jlt_instance_gradients(const jlt_instance *instance, double *gradients, const double *x);

#endif
