#include "top/conserved.h"

static void values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const jlt_conserved *self = (const jlt_conserved *)(const void *)p;
    const unsigned count = self->descriptor->integral_count;

    if (count > 0) self->descriptor->integral_values.call(x, self->block, out);
    if (self->root >= 0) out[count] = x[0] * x[0] + x[self->root] * x[self->root];
}

static void gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const jlt_conserved *self = (const jlt_conserved *)(const void *)p;
    const unsigned count = self->descriptor->integral_count;

    if (count > 0) self->descriptor->integral_gradients.call(x, self->block, out);
    if (self->root < 0) return;
    for (unsigned k = 0; k < self->dim; k++) out[count * self->dim + k] = 0;
    out[count * self->dim] = 2 * x[0];
    out[count * self->dim + (unsigned)self->root] = 2 * x[self->root];
}

jlt_status jlt_conserved_of(jlt_invariants *out, jlt_conserved *keep, const jlt_descriptor *descriptor,
                            const jlt_field *field)
{
    const unsigned count = descriptor->integral_count + (field->root >= 0);

    if (count > JLT_INVARIANTS_MAX) return JLT_ERR_UNSUPPORTED;
    *keep = (jlt_conserved){ .descriptor = descriptor, .block = field->p, .dim = field->dim, .root = field->root };
    *out = (jlt_invariants){ .count = count, .values = values, .gradients = gradients,
                             .p = (const double *)(const void *)keep };
    return JLT_OK;
}
