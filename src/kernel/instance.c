#include "kernel/instance.h"

#include "core/guard.h"
#include "core/memory.h"
#include "kernel/descriptor.h"
#include "kernel/kernel.h"
#include "kernel/region.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

jlt_status jlt_instance_create(jlt_instance **instance, const jlt_descriptor *descriptor, const double *params)
{
    return jlt_instance_create_in(instance, descriptor, params, &(jlt_units){ 0 });
}

static void count_states(jlt_quantity *states, const jlt_descriptor *descriptor, const jlt_units *units)
{
    for (unsigned i = 0; i < descriptor->state_count; i++) {
        const int exponent = -jlt_units_exponent(units, descriptor->states[i].unit);
        states[i] = descriptor->states[i];
        states[i].low = ldexp(states[i].low, exponent);
        states[i].high = ldexp(states[i].high, exponent);
        states[i].period = ldexp(states[i].period, exponent);
    }
}

jlt_status jlt_instance_create_in(jlt_instance **instance, const jlt_descriptor *descriptor, const double *params,
                                  const jlt_units *units)
{
    JLT_OWNED(jlt_instance) *self = NULL;
    const jlt_region *region;
    double value;
    size_t index;

    *instance = NULL;
    if (descriptor == NULL || params == NULL) return JLT_ERR_ARG;
    JLT_PASS(jlt_descriptor_check_params(descriptor, params, &index));
    JLT_PASS(jlt_region_check(&region, &value, descriptor, params, NULL));
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    self->descriptor = descriptor;
    self->params = jlt_memory_array(descriptor->param_count, sizeof *self->params);
    self->counted = jlt_memory_array(descriptor->param_count, sizeof *self->counted);
    self->prepared = jlt_memory_array(descriptor->prepared_count, sizeof *self->prepared);
    self->states = jlt_memory_array(descriptor->state_count, sizeof *self->states);
    if (self->params == NULL || self->counted == NULL || self->prepared == NULL || self->states == NULL) return JLT_ERR_NOMEM;
    memcpy(self->params, params, descriptor->param_count * sizeof *params);
    jlt_units_count(self->counted, params, descriptor->params, descriptor->param_count, units);
    JLT_PASS(jlt_kernel_prepare_params(self->prepared, descriptor, self->counted));
    count_states(self->states, descriptor, units);
    *instance = self;
    self = NULL; /* ownership moved to the caller */
    return JLT_OK;
}

jlt_status jlt_instance_units(jlt_units *out, const jlt_descriptor *model, const double *params, const double *x)
{
    if (model == NULL) return JLT_ERR_ARG;
    const unsigned n = model->state_count;
    JLT_FREED double *still = jlt_memory_array(2 * n, sizeof *still);
    JLT_OWNED(jlt_instance) *instance = NULL;
    jlt_units units = { 0 };

    if (still == NULL) return JLT_ERR_NOMEM;
    JLT_PASS(jlt_instance_create(&instance, model, params));
    jlt_units_of_sizes(&units, params, model->params, model->param_count, x, model->states, n);
    for (unsigned i = 0; i < n; i++)
        if (jlt_units_exponent(&(jlt_units){ .time = 1 }, model->states[i].unit) == 0) still[i] = x[i];
    double *const f = still + n;
    model->rhs.call(still, instance->prepared, f);
    jlt_units_of_rate(&units,
                      fmax(jlt_units_rate(&units, x, model->states, n, 0), jlt_units_rate(&units, f, model->states, n, 1)));
    *out = units;
    return JLT_OK;
}

void jlt_instance_destroy(jlt_instance *instance)
{
    if (instance == NULL) return;
    free(instance->params);
    free(instance->counted);
    free(instance->prepared);
    free(instance->states);
    free(instance);
}

static jlt_status evaluate(const jlt_instance *instance, const jlt_kernel *kernel, double *out, const double *x)
{
    const jlt_descriptor *d = instance->descriptor;

    if (!jlt_guard_finite(x, d->state_count)) return JLT_ERR_NONFINITE;
    for (unsigned i = 0; i < d->state_count; i++)
        if (x[i] <= instance->states[i].low || x[i] >= instance->states[i].high) return JLT_ERR_DOMAIN;
    if (!jlt_region_holds(d->domain_count, d->domain_values.call, instance->prepared, x)) return JLT_ERR_DOMAIN;
    return jlt_kernel_eval(out, kernel, x, d->state_count, instance->prepared);
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
