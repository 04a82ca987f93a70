#include "dynamics/system.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "kernel/descriptor.h"

static const char *const names[] = { "m", "R", "g", "I1", "I3", "a3", "E", "G" };

jlt_top_values jlt_system_defaults(void)
{
    return (jlt_top_values){ .m = 1, .R = 1, .g = 1, .I1 = 1. / 3, .I3 = 1. / 3, .a3 = 0.51, .E = 2.15, .G = -0.56 };
}

double *jlt_system_value(jlt_top_values *values, const char *name)
{
    double *const entries[] = { &values->m,  &values->R,  &values->g, &values->I1,
                                &values->I3, &values->a3, &values->E, &values->G };
    size_t i;

    for (i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(names[i], name) == 0) return entries[i];
    return NULL;
}

static jlt_status bind(jlt_system *self, const jlt_descriptor *descriptor, const double *params, const jlt_units *units,
                       const jlt_flow *options)
{
    jlt_status st = JLT_OK;

    if (descriptor == NULL || descriptor->jacobian.call == NULL) return JLT_ERR_UNSUPPORTED;
    JLT_TRY(jlt_instance_create_in(&self->instance, descriptor, params, units));
    JLT_TRY(jlt_field_of(&self->field, descriptor, self->instance->block));
    if (options != NULL) self->flow = *options;
    else self->flow.direction = JLT_RISING;
    self->flow.field = &self->field;
    self->flow.rhs_jacobian = descriptor->rhs_jacobian.call;
    for (unsigned i = 0; i < descriptor->state_count; i++)
        self->flow.units.state[i] = jlt_units_exponent(units, descriptor->states[i].unit);
    self->flow.units.time = units->time;
    JLT_TRY(jlt_observed_create(&self->observed, descriptor, params, units));
    self->flow.observed = self->observed;
done:
    return st;
}

static jlt_status top_params(double *params, const jlt_descriptor *descriptor, const jlt_top_values *values)
{
    jlt_top_values copy = *values;
    unsigned i;

    for (i = 0; i < descriptor->param_count; i++) {
        const double *value = jlt_system_value(&copy, descriptor->params[i].name);
        if (value == NULL) return JLT_ERR_UNSUPPORTED;
        params[i] = *value;
    }
    return JLT_OK;
}

jlt_status jlt_system_top(jlt_system **out, const jlt_top_values *values, const jlt_flow *options)
{
    static const char model[] = "spherical_top_level";
    const jlt_descriptor *descriptor = jlt_descriptor_find(model, NULL, "regular", NULL);
    double params[JLT_SYSTEM_PARAMS_MAX], low, high;
    jlt_system *self = NULL;
    jlt_status st = JLT_OK;

    *out = NULL;
    if (descriptor == NULL || descriptor->param_count > JLT_SYSTEM_PARAMS_MAX) return JLT_ERR_UNSUPPORTED;
    if (!isfinite(values->E) || !isfinite(values->G)) return JLT_ERR_NONFINITE;
    JLT_TRY(top_params(params, descriptor, values));
    descriptor = jlt_descriptor_choose(descriptor, "regular", NULL, params);
    self = calloc(1, sizeof *self);
    st = JLT_ERR_NOMEM;
    if (self == NULL) goto done;
    self->values = *values;
    self->is_top = true;
    jlt_chart_top_init(&self->chart.top, values->m, values->R, values->g, values->I1, values->I3, values->a3, values->E,
                       values->G);
    jlt_units units = jlt_chart_top_units(&self->chart.top);
    bool scales;
    JLT_TRY(jlt_instance_scales(&scales, descriptor, params, &units));
    if (!scales) units = (jlt_units){ 0 };
    JLT_TRY(bind(self, descriptor, params, &units, options));
    jlt_chart_top_init_in(&self->flow_chart, &self->chart.top, &units);
    self->flow.chart = &self->flow_chart.base;
    st = JLT_ERR_EMPTY;
    if (!jlt_system_interval(&self->chart.top, &low, &high)) goto done;
    st = JLT_OK;
    *out = self;
    self = NULL; /* ownership moved to the caller */
done:
    jlt_system_destroy(self);
    return st;
}

jlt_status jlt_system_plane(jlt_system **out, const jlt_descriptor *descriptor, const double *params, unsigned column,
                            double level, const int *signs, const jlt_flow *options)
{
    const char *state_names[JLT_CHART_STATES_MAX];
    jlt_system *self = NULL;
    jlt_status st = JLT_OK;
    unsigned i;

    *out = NULL;
    if (descriptor->state_count > JLT_CHART_STATES_MAX) return JLT_ERR_ARG;
    self = calloc(1, sizeof *self);
    if (self == NULL) return JLT_ERR_NOMEM;
    for (i = 0; i < descriptor->state_count; i++) state_names[i] = descriptor->states[i].name;
    JLT_TRY(bind(self, descriptor, params, &(jlt_units){ 0 }, options));
    JLT_TRY(jlt_chart_plane(&self->chart.plane, descriptor->state_count, column, level, state_names, signs));
    self->flow.chart = &self->chart.plane;
    *out = self;
    self = NULL;
done:
    jlt_system_destroy(self);
    return st;
}

/* The field at x; false: it is not finite. */
static bool field_at(const jlt_system *self, const double *x, double *f)
{
    bool finite = true;

    self->field.call(x, self->field.p, f);
    for (unsigned i = 0; i < self->field.dim; i++) finite &= isfinite(f[i]);
    return finite;
}

/* Whether the field is the same a period on, to rounding, in every component. */
static bool is_period(const jlt_system *self, double *x, unsigned state, double period)
{
    static const double same = 1e-9; /* rounding of a period, times slopes of the field */
    const unsigned n = self->field.dim;
    const double at = x[state];
    double f[JLT_CHART_STATES_MAX], there[JLT_CHART_STATES_MAX];
    bool repeats = field_at(self, x, f);

    x[state] = at + period;
    repeats = repeats && x[state] != at && field_at(self, x, there);
    x[state] = at;
    for (unsigned i = 0; repeats && i < n; i++) repeats = fabs(there[i] - f[i]) <= same * fmax(fabs(f[i]), fabs(there[i]));
    return repeats;
}

jlt_status jlt_system_angles(jlt_system *self, const double *periods, unsigned *state)
{
    enum { POINTS = 5 };
    const jlt_quantity *quantities = self->instance->descriptor->states;
    const unsigned n = self->field.dim;
    double x[JLT_CHART_STATES_MAX] = { 0 };

    for (int k = 0; k < POINTS; k++) {
        for (unsigned i = 0; i < n; i++) {
            const double share = 0.5 + 0.4 * sin(i + 1. + 1.7 * k), low = quantities[i].low, high = quantities[i].high;
            x[i] = isfinite(low) && isfinite(high) ? low + share * (high - low)
                   : isfinite(low)                 ? low + share
                   : isfinite(high)                ? high - share
                                                   : 2 * share - 0.6;
        }
        for (*state = 0; *state < n; ++*state)
            if (periods[*state] != 0 && !is_period(self, x, *state, periods[*state])) return JLT_ERR_DOMAIN;
    }
    jlt_chart_set_periods(&self->chart.plane, periods);
    return JLT_OK;
}

jlt_status jlt_system_levels(jlt_system *self, const jlt_level *levels, unsigned count)
{
    const jlt_descriptor *d = self->instance->descriptor;
    const jlt_invariants integrals = { d->integral_count, d->integral_values.call, d->integral_gradients.call, self->field.p };
    const jlt_chart plane = self->chart.plane;
    const jlt_status st = jlt_chart_level_init(&self->chart.level, &plane, &integrals, levels, count);

    if (st != JLT_OK) self->chart.plane = plane;
    return st;
}

void jlt_system_destroy(jlt_system *self)
{
    if (self == NULL) return;
    jlt_instance_destroy(self->instance);
    jlt_observed_destroy(self->observed);
    free(self);
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

bool jlt_system_interval(const jlt_chart_top *chart, double *low, double *high)
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

jlt_status jlt_system_map_at(void *context, jlt_map **map, double value)
{
    jlt_system_family *self = context;
    jlt_system *system = NULL;
    jlt_status st = JLT_OK;

    if (self->map == NULL || self->value != value) {
        JLT_TRY(self->make(self->context, &system, value));
        jlt_system_family_clear(self);
        self->system = system;
        self->value = value;
        JLT_TRY(jlt_map_create(&self->map, &self->system->flow));
    }
    *map = self->map;
done:
    if (st != JLT_OK) jlt_system_family_clear(self);
    return st;
}

jlt_status jlt_system_top_at(void *context, jlt_system **out, double value)
{
    jlt_top_family *self = context;
    double *entry = jlt_system_value(&self->values, self->name);

    *out = NULL;
    if (entry == NULL) return JLT_ERR_ARG;
    *entry = value;
    return jlt_system_top(out, &self->values, &self->options);
}

void jlt_system_family_clear(jlt_system_family *self)
{
    jlt_map_destroy(self->map);
    jlt_system_destroy(self->system);
    self->map = NULL;
    self->system = NULL;
}
