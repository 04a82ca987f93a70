#include "kernel/kernel.h"

#include "core/guard.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

jlt_status jlt_kernel_eval_function(double *out, jlt_kernel_function function, size_t outputs, const double *x,
                                    size_t count, const double *params, size_t param_count)
{
    double result[JLT_KERNEL_OUTPUTS_MAX];
    jlt_guard guard;

    if (function == NULL || outputs > JLT_KERNEL_OUTPUTS_MAX) return JLT_ERR_UNSUPPORTED;
    if ((x != NULL && !jlt_guard_finite(x, count)) || !jlt_guard_finite(params, param_count)) return JLT_ERR_NONFINITE;
    jlt_guard_enter(&guard);
    function(x, params, result);
    JLT_PASS(jlt_guard_leave(&guard));
    if (!jlt_guard_finite(result, outputs)) return JLT_ERR_NONFINITE;
    memcpy(out, result, outputs * sizeof *out);
    return JLT_OK;
}

jlt_status jlt_kernel_eval(double *out, const jlt_kernel *kernel, const double *x, size_t count, const double *prepared)
{
    /* The prepared values were checked when they were computed, so none is checked here. */
    return jlt_kernel_eval_function(out, kernel->call, kernel->outputs, x, count, prepared, 0);
}

jlt_status jlt_kernel_prepare_params(double *prepared, const jlt_descriptor *descriptor, const double *params)
{
    double result[JLT_KERNEL_OUTPUTS_MAX];
    jlt_guard guard;

    if (descriptor == NULL) return JLT_ERR_ARG;
    if (descriptor->prepare == NULL || descriptor->prepared_count > JLT_KERNEL_OUTPUTS_MAX) return JLT_ERR_UNSUPPORTED;
    if (!jlt_guard_finite(params, descriptor->param_count)) return JLT_ERR_NONFINITE;
    jlt_guard_enter(&guard);
    descriptor->prepare(params, result);
    JLT_PASS(jlt_guard_leave(&guard));
    if (!jlt_guard_finite(result, descriptor->prepared_count)) return JLT_ERR_NONFINITE;
    memcpy(prepared, result, descriptor->prepared_count * sizeof *prepared);
    return JLT_OK;
}
