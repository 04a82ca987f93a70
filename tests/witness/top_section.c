#include "witness/top_section.h"

#include <stddef.h>
#include <string.h>

#include "kernel/descriptor.h"

jlt_top_values jlt_system_top_defaults(void)
{
    return (jlt_top_values){ .m = 1, .R = 1, .g = 1, .I1 = 1.0 / 3, .I3 = 1.0 / 3, .a3 = 0.51, .E = 2.15, .G = -0.56 };
}

double *jlt_system_top_value(jlt_top_values *values, const char *name)
{
    static const char *const names[] = { "m", "R", "g", "I1", "I3", "a3", "E", "G" };

    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(names[i], name) == 0) return &values->m + i;
    return NULL;
}

jlt_status jlt_system_top(jlt_system **out, const jlt_top_values *values, const jlt_flow *options)
{
    jlt_top_values copy = *values;
    double arranged[JLT_CHART_VALUES_MAX];
    const jlt_claim *broken;
    jlt_surface surface;
    jlt_status st = JLT_OK;

    *out = NULL;
    JLT_TRY(jlt_surface_find(&surface, &broken, jlt_descriptor_find("spherical_top", NULL, NULL, NULL), NULL, NULL));
    if (broken != NULL) return JLT_ERR_UNSUPPORTED;
    for (unsigned i = 0; i < surface.count; i++) arranged[i] = *jlt_system_top_value(&copy, surface.names[i]);
    st = jlt_surface_system(out, &surface, arranged, options);
done:
    return st;
}

jlt_top_values jlt_system_top_values(const jlt_system *self)
{
    jlt_top_values values;

    for (unsigned i = 0; i < self->surface->count; i++) *jlt_system_top_value(&values, self->surface->names[i]) = self->values[i];
    return values;
}

const jlt_chart_top *jlt_system_top_chart(const jlt_system *self)
{
    static _Thread_local jlt_chart_top chart;
    const jlt_top_values v = jlt_system_top_values(self);

    jlt_chart_top_init(&chart, v.m, v.R, v.g, v.I1, v.I3, v.a3, v.E, v.G);
    return &chart;
}

jlt_status jlt_system_top_at(void *context, jlt_system **out, double value, const jlt_system *near)
{
    jlt_top_family *self = context;
    double *entry = jlt_system_top_value(&self->values, self->name);

    (void)near;
    *out = NULL;
    if (entry == NULL) return JLT_ERR_ARG;
    *entry = value;
    return jlt_system_top(out, &self->values, &self->options);
}
