#include "integrate/field.h"

#include <string.h>

#include "kernel/batch_isa.h"

jlt_status jlt_field_of(jlt_field *out, const jlt_descriptor *descriptor, const double *p)
{
    if (out == NULL || descriptor == NULL) return JLT_ERR_ARG;
    if (descriptor->rhs.call == NULL) return JLT_ERR_UNSUPPORTED;
    if (descriptor->state_count == 0 || descriptor->state_count > JLT_FIELD_DIM_MAX) return JLT_ERR_UNSUPPORTED;

    const unsigned last = descriptor->state_count - 1;
    const int has_root = descriptor->time_factor.call != NULL && descriptor->states[last].low == 0;
    *out = (jlt_field){
        .dim = descriptor->state_count,
        .call = descriptor->rhs.call,
        .p = p,
        .time_rate = descriptor->time_factor.call,
        .jacobian = descriptor->jacobian.call,
        .jet = descriptor->jet,
        .batch = jlt_batch_isa_best(descriptor, 0),
        .domain = descriptor->time_factor.call == NULL ? descriptor->states : NULL,
        .root = has_root ? (int)last : -1,
    };
    return JLT_OK;
}

/* p is the jlt_variation itself. The Jacobian stands after the right-hand side in a buffer on the stack. */
static void vary(const double *restrict x, const double *restrict p, double *restrict out)
{
    const jlt_variation *v = (const jlt_variation *)(const void *)p;
    const unsigned n = v->dim;
    double buffer[JLT_VARIATION_DIM_MAX * (JLT_VARIATION_DIM_MAX + 1)];
    const double *a = buffer + n;

    if (v->rhs_jacobian != NULL) {
        v->rhs_jacobian(x, v->p, buffer);
    } else {
        v->rhs(x, v->p, buffer);
        v->jacobian(x, v->p, buffer + n);
    }
    memcpy(out, buffer, n * sizeof *out);
    for (unsigned j = 0; j < v->columns; j++) {
        const double *y = x + n + j * n;
        double *dy = out + n + j * n;
        for (unsigned i = 0; i < n; i++) {
            double sum = 0;
            for (unsigned k = 0; k < n; k++) sum += a[i * n + k] * y[k];
            dy[i] = sum;
        }
    }
}

static void vary_time(const double *restrict x, const double *restrict p, double *restrict out)
{
    const jlt_variation *v = (const jlt_variation *)(const void *)p;
    v->time_rate(x, v->p, out);
}

jlt_status jlt_field_vary(jlt_field *out, jlt_variation *keep, const jlt_field *field,
                          jlt_kernel_function rhs_jacobian, unsigned columns)
{
    if (out == NULL || keep == NULL || field == NULL || columns == 0) return JLT_ERR_ARG;
    if (field->dim > JLT_VARIATION_DIM_MAX || field->dim * (1 + columns) > JLT_FIELD_DIM_MAX) return JLT_ERR_ARG;
    if (rhs_jacobian == NULL && field->jacobian == NULL) return JLT_ERR_UNSUPPORTED;

    *keep = (jlt_variation){
        .rhs_jacobian = rhs_jacobian,
        .rhs = field->call,
        .jacobian = field->jacobian,
        .time_rate = field->time_rate,
        .p = field->p,
        .dim = field->dim,
        .columns = columns,
    };
    *out = (jlt_field){
        .dim = field->dim * (1 + columns),
        .call = vary,
        .p = (const double *)(const void *)keep,
        .time_rate = field->time_rate != NULL ? vary_time : NULL,
        .root = field->root,
    };
    return JLT_OK;
}
