#include "dynamics/system.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/chart_counted.h"
#include "integrate/conserved.h"
#include "kernel/descriptor.h"
#include "kernel/region.h"

static void set_units(jlt_system *self, const jlt_units *units)
{
    const jlt_descriptor *d = self->instance->descriptor;

    for (unsigned i = 0; i < d->state_count; i++) self->flow.units.state[i] = jlt_units_exponent(units, d->states[i].unit);
    self->flow.units.time = units->time;
    self->units = *units;
}

jlt_status jlt_system_bind(jlt_system *self, const jlt_descriptor *descriptor, const double *params, const jlt_units *units,
                           const jlt_flow *options)
{
    if (descriptor == NULL || descriptor->jacobian.call == NULL) return JLT_ERR_UNSUPPORTED;
    JLT_PASS(jlt_instance_create_in(&self->instance, descriptor, params, units));
    self->told = self->instance;
    JLT_PASS(jlt_field_of(&self->field, self->instance));
    if (options != NULL) self->flow = *options;
    else self->flow.direction = JLT_RISING;
    self->flow.field = &self->field;
    self->flow.rhs_jacobian = descriptor->rhs_jacobian.call;
    set_units(self, units);
    JLT_PASS(jlt_observed_create(&self->observed, descriptor, params, units));
    self->flow.observed = self->observed;
    return JLT_OK;
}

const jlt_descriptor *jlt_system_regular(const jlt_descriptor *descriptor)
{
    if (descriptor->time[0] != '\0' || descriptor->elimination[0] != '\0') return descriptor;
    if (!jlt_descriptor_has_poles(descriptor)) return descriptor;
    for (const jlt_descriptor *const *d = descriptor->family; *d != NULL; d++)
        if ((*d)->lifted_count == 1 && strcmp((*d)->variant, descriptor->variant) == 0 && (*d)->elimination[0] == '\0'
            && (*d)->integral_count + 1 <= JLT_INVARIANTS_MAX && (*d)->state_count <= JLT_CHART_STATES_MAX
            && jlt_descriptor_doubted_field(*d) == NULL)
            return *d;
    return descriptor;
}

/* The base comes first, so that jlt_system_destroy frees it all. */
typedef struct {
    jlt_system base;
    jlt_field told; /* the field in the table's units, as the chart's coordinates */
    jlt_conserved conserved, told_conserved; /* with lifted roots */
    jlt_chart_counted counted; /* the flow's chart, where it counts in other units */
} plane_system;

static plane_system *plane_of(jlt_system *system) { return (plane_system *)(void *)system; }

static jlt_status invariants_of(jlt_invariants *out, jlt_conserved *keep, const jlt_instance *instance)
{
    const jlt_descriptor *d = instance->descriptor;

    *out = (jlt_invariants){ d->integral_count, d->integral_values.call, d->integral_gradients.call, instance->prepared };
    return d->lifted_count == 0 ? JLT_OK : jlt_conserved_of(out, keep, instance);
}

jlt_status jlt_system_invariants(jlt_invariants *out, jlt_system *self)
{
    const jlt_descriptor *d = self->instance->descriptor;

    if (self->surface == NULL) return invariants_of(out, &plane_of(self)->conserved, self->instance);
    *out = (jlt_invariants){ d->integral_count, d->integral_values.call, d->integral_gradients.call, self->field.p };
    return JLT_OK;
}

/* Set the flow's chart: the one in the table's units, or where the flow counts in others, one over it. */
static void set_chart(jlt_system *self)
{
    plane_system *plane = plane_of(self);

    self->chart_base = &self->chart.plane;
    if (self->told != self->instance) {
        const int *const unit = self->flow.units.state;
        int coordinate[JLT_CHART_DIM_MAX];
        for (unsigned i = 0, k = 0; i < self->chart.plane.states; i++)
            if (jlt_chart_is_coordinate(&self->chart.plane, i)) coordinate[k++] = unit[i];
        jlt_chart_counted_init(&plane->counted, &self->chart.plane, unit, coordinate);
        self->chart_base = &plane->counted.base;
    }
    self->flow.chart = self->chart_base;
}

/* Turn the chart of a plane of all states into one whose coordinates leave out the lifted roots. */
static jlt_status add_roots(jlt_system *self)
{
    const jlt_instance *told = self->told;
    jlt_chart plane = self->chart.plane;
    jlt_invariants invariants;

    plane.roots = told->descriptor->lifted_count;
    JLT_PASS(invariants_of(&invariants, &plane_of(self)->told_conserved, told));
    return jlt_chart_level_init(&self->chart.level, &plane, &invariants, NULL, 0, told->descriptor, told->params);
}

jlt_status jlt_system_plane(jlt_system **out, const jlt_descriptor *descriptor, const double *params, unsigned column,
                            double level, const int *signs, const jlt_flow *options)
{
    const char *state_names[JLT_CHART_STATES_MAX];
    int all_signs[JLT_CHART_STATES_MAX];
    JLT_OWNED(jlt_system) *self = NULL;

    *out = NULL;
    if (descriptor == NULL || descriptor->state_count > JLT_CHART_STATES_MAX) return JLT_ERR_ARG;
    self = calloc(1, sizeof(plane_system));
    if (self == NULL) return JLT_ERR_NOMEM;
    for (unsigned i = 0; i < descriptor->state_count; i++) {
        state_names[i] = descriptor->states[i].name;
        all_signs[i] = signs != NULL && i < descriptor->state_count - descriptor->lifted_count ? signs[i] : 1;
    }
    JLT_PASS(jlt_system_bind(self, descriptor, params, &(jlt_units){ 0 }, options));
    JLT_PASS(jlt_field_of(&plane_of(self)->told, self->told));
    JLT_PASS(jlt_chart_plane(&self->chart.plane, descriptor->state_count, column, level, state_names,
                             signs != NULL ? all_signs : NULL));
    self->chart.plane.bounds = descriptor->states;
    self->chart.plane.domain = &plane_of(self)->told.domain;
    if (descriptor->lifted_count > 0) JLT_PASS(add_roots(self));
    set_chart(self);
    *out = self;
    self = NULL;
    return JLT_OK;
}

enum { POINTS = 5, PARTS = 16, VALUES_MAX = JLT_CHART_STATES_MAX + JLT_REGION_CONDITIONS_MAX + JLT_OBSERVED_CONDITIONS_MAX };

/* Compute the field at x, in the table's units. Returns false if it is not finite. */
static bool field_at(const jlt_system *self, const double *x, double *f)
{
    bool finite = true;

    self->field.call(x, self->told->prepared, f);
    for (unsigned i = 0; i < self->field.dim; i++) finite &= isfinite(f[i]);
    return finite;
}

/* Compute the field at x, then the conditions of `domain` and `valid`. Returns how many values these are; 0: no field is there. */
static unsigned model_at(const jlt_system *self, const double *x, double *values)
{
    const unsigned n = self->field.dim, valid = jlt_observed_conditions(self->observed);
    unsigned count = n + self->field.domain.conditions;

    if (!field_at(self, x, values)) return 0;
    if (count > n) self->field.domain.values(x, self->told->prepared, values + n);
    for (unsigned i = 0; i < valid; i++)
        values[count++] = jlt_observed_condition_value(&(jlt_observed_one){ self->observed, i }, x);
    return count;
}

/* Whether the model at x repeats after a period of the state, to rounding, in every component and condition. */
static bool is_period(const jlt_system *self, double *x, unsigned state, double period)
{
    static const double same = 1e-9;      /* relative to the change over a period: rounding of the period, times slopes */
    static const double rounding = 1e-13; /* relative to a component, whose terms may be larger */
    const jlt_quantity *of = &self->told->descriptor->states[state];
    const double at = x[state];
    double f[VALUES_MAX], there[VALUES_MAX], changes[VALUES_MAX] = { 0 };
    const unsigned count = model_at(self, x, f);
    bool repeats = count > 0 && isinf(of->low) && isinf(of->high), known = false;

    for (int k = 1; repeats && k <= PARTS; k++) {
        x[state] = at + period * k / PARTS;
        known = model_at(self, x, there) > 0;
        for (unsigned i = 0; known && i < count; i++) changes[i] = fmax(changes[i], fabs(there[i] - f[i]));
    }
    repeats = repeats && known && x[state] != at;
    x[state] = at;
    for (unsigned i = 0; repeats && i < count; i++)
        repeats = fabs(there[i] - f[i]) <= same * changes[i] + rounding * fmax(fabs(f[i]), fabs(there[i]));
    return repeats;
}

/* Test point k: arbitrary, within the states' bounds. */
static void point_number(const jlt_system *self, double *x, int k)
{
    const jlt_quantity *quantities = self->instance->descriptor->states;

    for (unsigned i = 0; i < self->field.dim; i++) {
        const double share = 0.5 + 0.4 * sin(i + 1. + 1.7 * k), low = quantities[i].low, high = quantities[i].high;
        x[i] = isfinite(low) && isfinite(high) ? low + share * (high - low)
               : isfinite(low)                 ? low + share
               : isfinite(high)                ? high - share
                                               : 2 * share - 0.6;
    }
}

static bool is_proved(const jlt_descriptor *d, unsigned state, double period)
{
    return period == d->states[state].period && jlt_descriptor_proves(d, "periodic", d->states[state].name);
}

jlt_status jlt_system_angles(jlt_system *self, const double *periods, unsigned *state)
{
    const unsigned n = self->field.dim;
    double x[JLT_CHART_STATES_MAX] = { 0 };

    for (int k = 0; k < POINTS; k++) {
        point_number(self, x, k);
        for (*state = 0; *state < n; ++*state)
            if (periods[*state] != 0 && !is_proved(self->instance->descriptor, *state, periods[*state]) &&
                !is_period(self, x, *state, periods[*state]))
                return JLT_ERR_DOMAIN;
    }
    jlt_chart_set_periods(&self->chart.plane, periods);
    for (unsigned i = 0; i < n; i++)
        if (periods[i] != 0) jlt_state_set_add(&self->field.angles, i);
    return JLT_OK;
}

bool jlt_system_is_reversed(const jlt_system *self, const int *signs)
{
    static const double same = 1e-10; /* of the largest value of a component at any of the points */
    double x[JLT_CHART_STATES_MAX], f[JLT_CHART_STATES_MAX], image[JLT_CHART_STATES_MAX];
    double off[JLT_CHART_STATES_MAX] = { 0 }, largest[JLT_CHART_STATES_MAX] = { 0 };
    const unsigned n = self->field.dim - self->told->descriptor->lifted_count;

    for (int k = 0; k < POINTS; k++) {
        point_number(self, x, k);
        if (!field_at(self, x, f)) continue;
        for (unsigned i = 0; i < n; i++) x[i] *= signs[i];
        if (!field_at(self, x, image)) continue;
        for (unsigned i = 0; i < n; i++) {
            off[i] = fmax(off[i], fabs(image[i] + signs[i] * f[i]));
            largest[i] = fmax(largest[i], fabs(f[i]));
        }
    }
    for (unsigned i = 0; i < n; i++)
        if (off[i] > same * largest[i]) return false;
    return true;
}

/* Whether the reversor of a plane section, which mirrors its state at the section, keeps these integrals at all test points, to
 * rounding, and so leads to the same level. */
static bool keeps_levels(const jlt_system *self, const jlt_chart *plane, const jlt_invariants *integrals, const jlt_level *levels,
                         unsigned count)
{
    static const double same = 1e-10; /* of the largest value at any of the points */
    double x[JLT_CHART_STATES_MAX], here[JLT_CHART_INTEGRALS_MAX], there[JLT_CHART_INTEGRALS_MAX];
    double off[JLT_INVARIANTS_MAX] = { 0 }, largest[JLT_INVARIANTS_MAX] = { 0 };

    for (int k = 0; k < POINTS; k++) {
        point_number(self, x, k);
        integrals->values(x, integrals->p, here);
        for (unsigned i = 0, c = 0; i < plane->states; i++)
            x[i] = i == plane->column ? 2 * plane->level - x[i] : plane->mirror[c++] * x[i];
        integrals->values(x, integrals->p, there);
        for (unsigned i = 0; i < count; i++) {
            const double a = here[levels[i].integral], b = there[levels[i].integral];
            if (!isfinite(a) || !isfinite(b)) return false;
            off[i] = fmax(off[i], fabs(a - b));
            largest[i] = fmax(largest[i], fmax(fabs(a), fabs(b)));
        }
    }
    for (unsigned i = 0; i < count; i++)
        if (off[i] > same * largest[i]) return false;
    return true;
}

/* Whether the levels determine the states solved for at some test point, if their gradients are known at any. */
static bool determines(const jlt_system *self)
{
    double x[JLT_CHART_STATES_MAX];
    bool known = false;

    for (int k = 0; k < POINTS; k++) {
        point_number(self, x, k);
        if (jlt_chart_level_determines(&self->chart.level, &known, x)) return true;
    }
    return !known;
}

jlt_status jlt_system_levels(jlt_system *self, const jlt_level *levels, unsigned count)
{
    const jlt_instance *told = self->told;
    const jlt_chart before = self->chart.plane;
    jlt_chart plane = before;
    jlt_invariants integrals;
    jlt_status st = JLT_OK;

    plane.dim += plane.roots; /* as before add_roots */
    JLT_TRY(invariants_of(&integrals, &plane_of(self)->told_conserved, told));
    JLT_TRY(jlt_chart_level_init(&self->chart.level, &plane, &integrals, levels, count, told->descriptor, told->params));
    for (unsigned i = 0; i < count; i++) {
        const double period = told->descriptor->states[levels[i].state].period;
        if (is_proved(told->descriptor, levels[i].state, period)) self->chart.level.turns[i] = period;
    }
    if (!determines(self)) st = JLT_ERR_EMPTY;
    if (plane.reversible) self->chart.level.base.reversible &= keeps_levels(self, &plane, &integrals, levels, count);
done:
    if (st != JLT_OK) self->chart.plane = before;
    return st;
}

/* Whether the flow may count in other units: the table's are the dimensions of its terms, and angles have none. */
static bool scales(const jlt_system *self)
{
    static const jlt_units each = { 1, 1 << 8, 1 << 16 };
    const jlt_descriptor *d = self->told->descriptor;
    const jlt_chart *chart = &self->chart.plane;
    bool scales = d->scales;

    for (unsigned i = 0, k = 0; i < d->state_count; i++) {
        const double period = i == chart->column ? chart->turn : jlt_chart_is_coordinate(chart, i) ? chart->period[k++] : 0;
        scales = scales && (period == 0 || jlt_units_exponent(&each, d->states[i].unit) == 0);
    }
    return scales;
}

jlt_status jlt_system_count_in(jlt_system *self, const jlt_units *units)
{
    const jlt_descriptor *d = self->told->descriptor;
    const double *params = self->told->params;
    JLT_OWNED(jlt_instance) *instance = NULL;
    jlt_observed *observed = NULL;

    if (!d->scales) return JLT_OK;
    JLT_PASS(jlt_instance_create_in(&instance, d, params, units));
    JLT_PASS(jlt_observed_create(&observed, d, params, units));
    if (self->instance != self->told) jlt_instance_destroy(self->instance);
    jlt_observed_destroy(self->observed);
    self->instance = instance;
    self->flow.observed = self->observed = observed;
    instance = NULL; /* ownership moved to the system */
    set_units(self, units);
    const jlt_state_set angles = self->field.angles; /* also those that jlt_system_angles has declared */
    JLT_PASS(jlt_field_of(&self->field, self->instance));
    self->field.angles = angles;
    return JLT_OK;
}

jlt_status jlt_system_count(jlt_system *self, const double *sizes)
{
    jlt_units units;

    if (!scales(self)) return JLT_OK;
    JLT_PASS(jlt_instance_units(&units, self->told->descriptor->family[0], self->told->params, sizes));
    JLT_PASS(jlt_system_count_in(self, &units));
    set_chart(self);
    return JLT_OK;
}

void jlt_system_destroy(jlt_system *self)
{
    if (self == NULL) return;
    if (self->told != self->instance) jlt_instance_destroy(self->told);
    jlt_instance_destroy(self->instance);
    jlt_observed_destroy(self->observed);
    free(self);
}
