#include "dynamics/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "kernel/link.h"

/* The base comes first, so that jlt_system_destroy frees it all. */
typedef struct {
    jlt_system base;
    jlt_surface surface;
    double values[JLT_CHART_VALUES_MAX]; /* as the surface names them */
    jlt_chart_section rows, flow;        /* in the table's units, and in the flow's */
} surface_system;

static const surface_system *of(const jlt_system *system) { return (const surface_system *)(const void *)system; }

/* ---- which section ---- */

/* The general field of the model in the time that lifts most roots. */
static const jlt_descriptor *widest(const jlt_descriptor *general)
{
    const jlt_descriptor *best = general;

    for (const jlt_descriptor *const *d = general->family; *d != NULL; d++)
        if ((*d)->section_count > 0 && (*d)->state_count > best->state_count) best = *d;
    return best;
}

static const jlt_section_chart *named(const jlt_descriptor *table, const char *name)
{
    for (unsigned i = 0; i < table->section_count; i++)
        if (name == NULL || strcmp(table->sections[i].name, name) == 0) return &table->sections[i];
    return NULL;
}

static jlt_status add(jlt_surface *out, const jlt_quantity *quantity, double value, unsigned entry)
{
    if (out->count == JLT_CHART_VALUES_MAX) return JLT_ERR_UNSUPPORTED;
    out->names[out->count] = quantity->name;
    out->defaults[out->count] = value;
    out->entries[out->count++] = entry;
    return JLT_OK;
}

/* Parameters with the defaults of the asked table; then the record's levels, and the parameters that the asked table has not. */
static jlt_status list_values(jlt_surface *out, const jlt_descriptor *asked)
{
    const jlt_descriptor *table = out->table;
    jlt_status st = JLT_OK;
    size_t index;

    for (unsigned i = 0; i < table->param_count; i++)
        if (jlt_descriptor_param(asked, table->params[i].name, &index)) JLT_TRY(add(out, &table->params[i], asked->params[index].value, i));
    out->params = out->count;
    for (unsigned i = 0; i < out->section->level_count; i++)
        JLT_TRY(add(out, &out->section->levels[i], out->section->levels[i].value, table->param_count + i));
    for (unsigned i = 0; i < table->param_count; i++)
        if (!jlt_descriptor_param(asked, table->params[i].name, &index)) JLT_TRY(add(out, &table->params[i], table->params[i].value, i));
done:
    return st;
}

/* Whether the table has such a section that stands for the asked one; *claim: what is not proved of that. */
static bool serves(const jlt_claim **claim, const jlt_descriptor *asked, const jlt_descriptor *table, const jlt_section_chart *section)
{
    if (!jlt_link_holds(claim, asked, table)) return false;
    *claim = &table->claims[section->claim];
    if ((*claim)->verdict != JLT_PROVED) return false;
    *claim = NULL;
    return true;
}

jlt_status jlt_surface_find(jlt_surface *out, const jlt_claim **broken, const jlt_descriptor *asked, const char *name)
{
    const jlt_claim *claim = NULL;
    bool found = false;

    *out = (jlt_surface){ .table = NULL };
    *broken = NULL;
    for (size_t i = 0; i <= jlt_descriptor_count() && !found; i++) { /* the asked table itself, and those built in */
        const jlt_descriptor *table = widest((i == 0 ? asked : jlt_descriptor_at(i - 1))->family[0]);
        const jlt_section_chart *section = named(table, name);
        if (section == NULL) continue;
        found = serves(&claim, asked, table, section);
        if (!found && (claim == NULL || *broken != NULL)) continue;
        *broken = claim;
        out->table = table;
        out->section = section;
    }
    return out->table != NULL ? list_values(out, asked) : JLT_ERR_UNSUPPORTED;
}

unsigned jlt_surface_value(const jlt_surface *surface, const char *name)
{
    unsigned i = 0;

    while (i < surface->count && strcmp(surface->names[i], name) != 0) i++;
    return i;
}

/* ---- where it has points ---- */

enum { ANGLES = 4, HALVINGS = 60, CROSSINGS = 256 };

static const double margin = 5e-10; /* of a coordinate's interval, off its ends */

/* Whether there is a point. */
static bool has_point(const jlt_chart_section *chart)
{
    const size_t all = jlt_chart_section_points(chart, ANGLES);
    double q[JLT_CHART_COORDINATES_MAX];

    for (size_t i = 0; i < all; i++) {
        jlt_chart_section_point(chart, q, i * 2654435761u % all, ANGLES); /* spread out: one is met soon */
        if (jlt_chart_section_holds(chart, q)) return true;
    }
    return false;
}

/* The same with one coordinate given: points are counted over the others. */
static bool holds_at(const jlt_chart_section *chart, unsigned coordinate, double value)
{
    const size_t places = jlt_chart_section_places(chart, coordinate, ANGLES), others = jlt_chart_section_points(chart, ANGLES) / places;
    double q[JLT_CHART_COORDINATES_MAX];
    size_t stride = 1;

    for (unsigned k = 0; k < coordinate; k++) stride *= jlt_chart_section_places(chart, k, ANGLES);
    for (size_t i = 0; i < others; i++) {
        jlt_chart_section_point(chart, q, i / stride * stride * places + i % stride, ANGLES);
        q[coordinate] = value;
        if (jlt_chart_section_holds(chart, q)) return true;
    }
    return false;
}

/* The end of the interval from a value inside towards another: between the two, or there. */
static double edge(const jlt_chart_section *chart, unsigned coordinate, double inside, double outside)
{
    if (holds_at(chart, coordinate, outside)) return outside;
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = (inside + outside) / 2;
        if (holds_at(chart, coordinate, middle)) inside = middle;
        else outside = middle;
    }
    return inside;
}

bool jlt_surface_interval(const jlt_system *system, unsigned coordinate, double *low, double *high)
{
    const jlt_chart_section *chart = jlt_surface_chart(system);
    const jlt_quantity *bounds = &chart->section->coordinates[coordinate];
    const unsigned places = jlt_chart_section_places(chart, coordinate, ANGLES);
    const double width = bounds->high - bounds->low, off = margin * width;
    double start = 0, before = bounds->low;
    bool open = false, found = false;

    if (chart->base.period[coordinate] != 0 || !isfinite(width)) return false;
    for (unsigned i = 0; i <= places; i++) {
        const double at = bounds->low + width * (i + 0.5) / places;
        const bool inside = i < places && holds_at(chart, coordinate, at);
        if (inside && !open) start = edge(chart, coordinate, at, i == 0 ? bounds->low + off : before);
        if (!inside && open) {
            const double end = edge(chart, coordinate, before, i == places ? bounds->high - off : at);
            if (!found || end - start > *high - *low) *low = start, *high = end;
            found = true;
        }
        open = inside;
        before = at;
    }
    return found;
}

/* ---- the system ---- */

/* As kernels of the section take them. */
static void arrange(double *out, const jlt_surface *surface, const double *values)
{
    for (unsigned i = 0; i < surface->count; i++) out[surface->entries[i]] = values[i];
}

static int exponent_of(const jlt_descriptor *table, const double *params, const char *unit)
{
    for (unsigned i = 0; i < table->param_count; i++)
        if (table->params[i].sign == JLT_POSITIVE && strcmp(table->params[i].unit, unit) == 0 && params[i] > 0 && isfinite(params[i]))
            return ilogb(params[i]);
    return 0;
}

/* The largest rate of a state at points of the section, in units that have no time yet. */
static double fastest(const jlt_chart_section *chart, const jlt_units *units)
{
    static const jlt_units seconds = { .time = 1 };
    const size_t all = jlt_chart_section_points(chart, 8), some = all < 1024 ? all : 1024;
    double rate = 0;

    for (size_t i = 0; i < some; i++) {
        double q[JLT_CHART_COORDINATES_MAX], x[JLT_CHART_STATES_MAX];
        jlt_chart_section_point(chart, q, i * (all / some), 8);
        if (chart->base.lift(&chart->base, x, NULL, q) != JLT_OK) continue;
        for (unsigned k = 0; k < chart->base.states; k++) {
            const char *unit = chart->table->states[k].unit;
            const int power = jlt_units_exponent(&seconds, unit);
            const double size = ldexp(fabs(x[k]), -jlt_units_exponent(units, unit));
            if (power < 0 && isfinite(size)) rate = fmax(rate, pow(size, -1. / power));
        }
    }
    return rate;
}

/* Units in which the first positive mass and length are in [1, 2), and half the square of the largest rate in [1, 4); those of the
 * table where coordinates have units. */
static jlt_units units_of(const jlt_chart_section *chart)
{
    jlt_units units = { 0 };
    double rate;

    for (unsigned k = 0; k < chart->base.dim; k++)
        if (jlt_units_exponent(&(jlt_units){ 1, 1 << 8, 1 << 16 }, chart->section->coordinates[k].unit) != 0) return units;
    units.mass = exponent_of(chart->table, chart->values, "kg");
    units.length = exponent_of(chart->table, chart->values, "m");
    rate = fastest(chart, &units);
    if (rate > 0 && isfinite(rate * rate)) units.time = -(ilogb(rate * rate / 2) >> 1);
    return units;
}

/* Whether lifted points are crossed in the flow's direction: a lift may take one sign of a root, and the section is then its half alone. */
static bool is_crossed(const surface_system *self)
{
    const jlt_flow *flow = &self->base.flow;
    const size_t all = jlt_chart_section_points(&self->flow, ANGLES);
    unsigned seen = 0;
    bool up = false, down = false;

    for (size_t i = 0; i < all && seen < CROSSINGS; i++) {
        double q[JLT_CHART_COORDINATES_MAX], x[JLT_CHART_STATES_MAX], f[JLT_CHART_STATES_MAX];
        jlt_chart_section_point(&self->flow, q, i * 2654435761u % all, ANGLES);
        if (self->flow.base.lift(&self->flow.base, x, NULL, q) != JLT_OK) continue;
        flow->field->call(x, flow->field->p, f);
        up |= f[self->flow.base.column] > 0;
        down |= f[self->flow.base.column] < 0;
        seen++;
    }
    return up == down || flow->direction == (up ? JLT_RISING : JLT_FALLING);
}

static jlt_status open_system(surface_system *self, const jlt_flow *options)
{
    const jlt_section_chart *section = self->surface.section;
    const jlt_descriptor *descriptor;
    double values[JLT_CHART_VALUES_MAX];
    bool scales = false;
    size_t index;
    jlt_units units;
    jlt_status st = JLT_OK;

    arrange(values, &self->surface, self->values);
    JLT_TRY(jlt_descriptor_check_params(self->surface.table, values, &index));
    JLT_TRY(jlt_chart_section_init(&self->rows, self->surface.table, section, values));
    descriptor = jlt_descriptor_choose(self->surface.table, self->surface.table->time, NULL, values);
    units = units_of(&self->rows);
    JLT_TRY(jlt_instance_scales(&scales, descriptor, values, &units));
    if (!scales) units = (jlt_units){ 0 };
    JLT_TRY(jlt_system_bind(&self->base, descriptor, values, &units, options));
    jlt_units_count(values, values, self->surface.table->params, self->surface.table->param_count, &units);
    jlt_units_count(values + self->surface.table->param_count, values + self->surface.table->param_count, section->levels,
                    section->level_count, &units);
    self->flow = self->rows;
    memcpy(self->flow.values, values, sizeof values);
    self->base.flow.chart = &self->flow.base;
    st = !has_point(&self->rows) ? JLT_ERR_EMPTY : is_crossed(self) ? JLT_OK : JLT_ERR_ARG;
done:
    return st;
}

jlt_status jlt_surface_system(jlt_system **out, const jlt_surface *surface, const double *values, const jlt_flow *options)
{
    surface_system *self = calloc(1, sizeof *self);
    jlt_status st = JLT_ERR_NOMEM;

    *out = NULL;
    if (self == NULL) return st;
    self->surface = *surface;
    self->base.surface = &self->surface;
    self->base.values = self->values;
    memcpy(self->values, values, surface->count * sizeof *values);
    st = JLT_ERR_NONFINITE;
    for (unsigned i = 0; i < surface->count; i++)
        if (!isfinite(values[i])) goto done;
    JLT_TRY(open_system(self, options));
    *out = &self->base;
    self = NULL; /* ownership moved to the caller */
done:
    if (self != NULL) jlt_system_destroy(&self->base);
    return st;
}

jlt_status jlt_surface_family_init(jlt_surface_family *out, const jlt_descriptor *asked, const char *runs)
{
    const jlt_claim *broken;
    jlt_status st = JLT_OK;

    *out = (jlt_surface_family){ .options = { .direction = JLT_RISING } };
    JLT_TRY(jlt_surface_find(&out->surface, &broken, asked, NULL));
    if (broken != NULL) return JLT_ERR_UNSUPPORTED;
    memcpy(out->values, out->surface.defaults, sizeof out->values);
    out->runs = jlt_surface_value(&out->surface, runs);
    if (out->runs == out->surface.count) return JLT_ERR_ARG;
done:
    return st;
}

jlt_status jlt_surface_at(void *context, jlt_system **out, double value)
{
    jlt_surface_family *self = context;

    self->values[self->runs] = value;
    return jlt_surface_system(out, &self->surface, self->values, &self->options);
}

const jlt_chart_section *jlt_surface_chart(const jlt_system *system) { return &of(system)->rows; }

bool jlt_surface_nearest_level(const jlt_surface *surface, const double *values, double *level)
{
    const double given = values[surface->params];
    double arranged[JLT_CHART_VALUES_MAX], size = fmax(1e-3, fabs(given)), empty = given, full = NAN;
    jlt_chart_section chart;

    arrange(arranged, surface, values);
    if (surface->count == surface->params || jlt_chart_section_init(&chart, surface->table, surface->section, arranged) != JLT_OK) return false;
    double *entry = &chart.values[surface->entries[surface->params]];
    for (int i = 0; i < 64 && isnan(full); i++) {
        *entry = given + (i % 2 == 0 ? size : -size);
        if (has_point(&chart)) full = *entry;
        if (i % 2 == 1) size *= 2;
    }
    if (isnan(full)) return false;
    for (int i = 0; i < HALVINGS; i++) {
        *entry = empty + (full - empty) / 2;
        if (has_point(&chart)) full = *entry;
        else empty = *entry;
    }
    *level = full;
    return true;
}

/* ---- what is shown ---- */

static void show(double *out, unsigned count, const jlt_system *system, jlt_kernel_function values, const double *x)
{
    if (count > 0) values(x, of(system)->rows.values, out);
    for (unsigned i = 0; i < count; i++)
        if (!isfinite(out[i])) out[i] = NAN;
}

void jlt_surface_beside(double *out, const jlt_system *system, const double *x)
{
    show(out, system->surface->section->beside_count, system, system->surface->section->beside_values, x);
}

void jlt_surface_ending(double *out, const jlt_system *system, const double *x)
{
    show(out, system->surface->section->ending_count, system, system->surface->section->ending_values, x);
}

void jlt_surface_off_section(double *q, const jlt_system *system, const double *x)
{
    const jlt_chart_section *chart = jlt_surface_chart(system);

    chart->base.lower(&chart->base, q, NULL, x);
    for (unsigned k = 0; k < chart->base.dim; k++)
        if (chart->section->is_angle[k]) q[k] = NAN;
}

bool jlt_surface_is_low(const jlt_system *system, const double *q)
{
    const jlt_chart_section *chart = jlt_surface_chart(system);
    double turn = 0;

    if (chart->section->turn != NULL) chart->section->turn(q, chart->values, &turn);
    return turn < 0;
}

/* The pole at which what turns is positive. */
jlt_fate jlt_surface_turned_at(const jlt_system *system)
{
    const jlt_chart_section *chart = jlt_surface_chart(system);
    double q[JLT_CHART_COORDINATES_MAX] = { 0 };

    if (chart->section->turn == NULL || chart->table->pole_count == 0) return JLT_FATE_ALIVE;
    const jlt_quantity *state = &chart->table->states[chart->table->poles[0].state];
    for (unsigned k = 0; k < chart->base.dim; k++)
        if (strcmp(chart->base.names[k], state->name) == 0) q[k] = state->high;
    return jlt_surface_is_low(system, q) ? JLT_FATE_POLE_MINUS : JLT_FATE_POLE_PLUS;
}
