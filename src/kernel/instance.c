#include "kernel/instance.h"

#include "core/memory.h"
#include "kernel/descriptor.h"
#include "kernel/kernel.h"

#include <stdlib.h>
#include <string.h>

jlt_status jlt_instance_create(jlt_instance **instance, const jlt_descriptor *descriptor, const double *params)
{
    return jlt_instance_create_in(instance, descriptor, params, &(jlt_units){ 0 });
}

jlt_status jlt_instance_create_in(jlt_instance **instance, const jlt_descriptor *descriptor, const double *params,
                                  const jlt_units *units)
{
    jlt_status st = JLT_OK;
    jlt_instance *self = NULL;
    size_t index;

    *instance = NULL;
    if (descriptor == NULL || params == NULL) return JLT_ERR_ARG;
    JLT_TRY(jlt_descriptor_check_params(descriptor, params, &index));
    st = JLT_ERR_NOMEM;
    self = calloc(1, sizeof *self);
    if (self == NULL) goto done;
    self->descriptor = descriptor;
    self->params = jlt_memory_array(descriptor->param_count, sizeof *self->params);
    self->block = jlt_memory_array(descriptor->block_count, sizeof *self->block);
    if (self->params == NULL || self->block == NULL) goto done;
    jlt_units_count(self->params, params, descriptor->params, descriptor->param_count, units);
    JLT_TRY(jlt_kernel_prepare_block(self->block, descriptor, self->params));
    memcpy(self->params, params, descriptor->param_count * sizeof *params);
    *instance = self;
    self = NULL; /* ownership moved to the caller */
done:
    jlt_instance_destroy(self);
    return st;
}

void jlt_instance_destroy(jlt_instance *instance)
{
    if (instance == NULL) return;
    free(instance->params);
    free(instance->block);
    free(instance);
}

static jlt_status evaluate(const jlt_instance *instance, const jlt_kernel *kernel, double *out, const double *x)
{
    size_t index;
    const jlt_status st = jlt_descriptor_check_state(instance->descriptor, x, &index);

    if (st != JLT_OK) return st;
    return jlt_kernel_eval(out, kernel, x, instance->descriptor->state_count, instance->block);
}

jlt_status jlt_instance_rhs(const jlt_instance *instance, double *f, const double *x)
{
    return evaluate(instance, &instance->descriptor->rhs, f, x);
}

jlt_status jlt_instance_jacobian(const jlt_instance *instance, double *jacobian, const double *x)
{
    return evaluate(instance, &instance->descriptor->jacobian, jacobian, x);
}

jlt_status jlt_instance_divergence(const jlt_instance *instance, double *divergence, const double *x)
{
    return evaluate(instance, &instance->descriptor->divergence, divergence, x);
}

jlt_status jlt_instance_gradients(const jlt_instance *instance, double *gradients, const double *x)
{
    return evaluate(instance, &instance->descriptor->integral_gradients, gradients, x);
}
