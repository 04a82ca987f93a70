#include "top/system_top.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "top/known.h"

enum { PARAMS_MAX = 16 };

/* The base comes first, so that jlt_system_destroy frees it all. */
typedef struct {
    jlt_system base;
    jlt_top_values values;
    jlt_chart_top rows, flow; /* in the table's units, and in the flow's */
} top_system;

jlt_top_values jlt_system_top_defaults(void)
{
    jlt_top_values values;
    memcpy(&values, jlt_known_top.defaults, sizeof values);
    return values;
}

double *jlt_system_top_value(jlt_top_values *values, const char *name)
{
    const unsigned index = jlt_known_value(&jlt_known_top, name);
    return index < jlt_known_top.count ? &values->m + index : NULL; /* they are in the order of their names, see known.c */
}

static jlt_status top_params(double *params, const jlt_descriptor *descriptor, const jlt_top_values *values)
{
    jlt_top_values copy = *values;
    unsigned i;

    for (i = 0; i < descriptor->param_count; i++) {
        const double *value = jlt_system_top_value(&copy, descriptor->params[i].name);
        if (value == NULL) return JLT_ERR_UNSUPPORTED;
        params[i] = *value;
    }
    return JLT_OK;
}

jlt_status jlt_system_top(jlt_system **out, const jlt_top_values *values, const jlt_flow *options)
{
    const jlt_descriptor *descriptor = jlt_descriptor_find("spherical_top_level", NULL, "regular", NULL);
    double params[PARAMS_MAX], low, high;
    top_system *self = NULL;
    jlt_status st = JLT_OK;

    *out = NULL;
    if (descriptor == NULL || descriptor->param_count > PARAMS_MAX) return JLT_ERR_UNSUPPORTED;
    if (!isfinite(values->E) || !isfinite(values->G)) return JLT_ERR_NONFINITE;
    JLT_TRY(top_params(params, descriptor, values));
    descriptor = jlt_descriptor_choose(descriptor, "regular", NULL, params);
    self = calloc(1, sizeof *self);
    st = JLT_ERR_NOMEM;
    if (self == NULL) goto done;
    self->values = *values;
    self->base.known = &jlt_known_top;
    self->base.values = &self->values.m;
    jlt_chart_top_init(&self->rows, values->m, values->R, values->g, values->I1, values->I3, values->a3, values->E, values->G);
    jlt_units units = jlt_chart_top_units(&self->rows);
    bool scales;
    JLT_TRY(jlt_instance_scales(&scales, descriptor, params, &units));
    if (!scales) units = (jlt_units){ 0 };
    JLT_TRY(jlt_system_bind(&self->base, descriptor, params, &units, options));
    jlt_chart_top_init_in(&self->flow, &self->rows, &units);
    self->base.flow.chart = &self->flow.base;
    st = JLT_ERR_EMPTY;
    if (!jlt_system_top_interval(&self->rows, &low, &high)) goto done;
    st = JLT_OK;
    *out = &self->base;
    self = NULL; /* ownership moved to the caller */
done:
    if (self != NULL) jlt_system_destroy(&self->base);
    return st;
}

jlt_top_values jlt_system_top_values(const jlt_system *self)
{
    return ((const top_system *)(const void *)self)->values;
}

const jlt_chart_top *jlt_system_top_chart(const jlt_system *self)
{
    return &((const top_system *)(const void *)self)->rows;
}

/* The end of the interval from a point inside towards another: between the two, or there. */
static double edge(const jlt_chart_top *chart, double inside, double outside)
{
    int i;

    if (jlt_chart_top_speed2(chart, outside) > 0) return outside;
    for (i = 0; i < 60; i++) {
        const double middle = (inside + outside) / 2;
        if (jlt_chart_top_speed2(chart, middle) > 0) inside = middle;
        else outside = middle;
    }
    return inside;
}

bool jlt_system_top_interval(const jlt_chart_top *chart, double *low, double *high)
{
    enum { POINTS = 4096 };
    double start = 0, before = -1;
    bool open = false, found = false;
    int i;

    for (i = 0; i <= POINTS; i++) {
        const double at = -1 + 2 * (i + 0.5) / POINTS;
        const bool inside = i < POINTS && jlt_chart_top_speed2(chart, at) > 0;
        if (inside && !open) start = edge(chart, at, i == 0 ? -1 + 1e-9 : before);
        if (!inside && open) {
            const double end = edge(chart, before, i == POINTS ? 1 - 1e-9 : at);
            if (!found || end - start > *high - *low) *low = start, *high = end;
            found = true;
        }
        open = inside;
        before = at;
    }
    return found;
}
