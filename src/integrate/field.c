#include "integrate/field.h"

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
