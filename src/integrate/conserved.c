#include "integrate/conserved.h"

static void values(const double *restrict x, const double *restrict p, double *restrict out)
{
    const jlt_instance *self = ((const jlt_conserved *)(const void *)p)->instance;
    const jlt_descriptor *d = self->descriptor;

    if (d->integral_count > 0) d->integral_values.call(x, self->prepared, out);
    if (d->lifted_count > 0) d->root_relations(x, self->counted, out + d->integral_count);
}

static void gradients(const double *restrict x, const double *restrict p, double *restrict out)
{
    const jlt_instance *self = ((const jlt_conserved *)(const void *)p)->instance;
    const jlt_descriptor *d = self->descriptor;

    if (d->integral_count > 0) d->integral_gradients.call(x, self->prepared, out);
    if (d->lifted_count > 0) d->root_relation_gradients(x, self->counted, out + (size_t)d->integral_count * d->state_count);
}

jlt_status jlt_conserved_of(jlt_invariants *out, jlt_conserved *keep, const jlt_instance *instance)
{
    const unsigned count = instance->descriptor->integral_count + instance->descriptor->lifted_count;

    if (count > JLT_INVARIANTS_MAX) return JLT_ERR_UNSUPPORTED;
    *keep = (jlt_conserved){ .instance = instance };
    *out = (jlt_invariants){ .count = count, .values = values, .gradients = gradients, .p = (const double *)(const void *)keep };
    return JLT_OK;
}
