#include "dynamics/surface.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "dynamics/chart_counted.h"
#include "dynamics/section_points.h"
#include "dynamics/surface_crossing.h"
#include "dynamics/surface_units.h"
#include "kernel/descriptor.h"

/* The base comes first, so that jlt_system_destroy frees it all. */
typedef struct {
    jlt_system base;
    jlt_surface surface;
    double values[JLT_CHART_VALUES_MAX]; /* in the surface's order */
    jlt_chart_section rows;              /* the chart in the table's units, */
    jlt_chart_counted flow;              /* and in the flow's */
} surface_system;

static const surface_system *of(const jlt_system *system) { return (const surface_system *)(const void *)system; }

/* ---- which section ---- */

/* The general field of the model in the proved time that lifts most roots. */
static const jlt_descriptor *widest(const jlt_descriptor *general)
{
    const jlt_descriptor *best = general;

    for (const jlt_descriptor *const *d = general->family; *d != NULL; d++)
        if ((*d)->section_count > 0 && (*d)->state_count > best->state_count && jlt_descriptor_doubted_field(*d) == NULL) best = *d;
    return best;
}

static jlt_status add(jlt_surface *out, const jlt_quantity *quantity, double value, unsigned entry)
{
    if (out->count == JLT_CHART_VALUES_MAX || jlt_surface_value(out, quantity->name) < out->count) return JLT_ERR_UNSUPPORTED;
    out->names[out->count] = quantity->name;
    out->defaults[out->count] = value;
    out->entries[out->count++] = entry;
    return JLT_OK;
}

/* Where a parameter of the section's table comes from; without a proved link, as its name suggests. */
static jlt_source source_of(const jlt_surface *surface, const char *name)
{
    size_t index;

    if (surface->link.count > 0) return jlt_link_source(&surface->link, name);
    return jlt_descriptor_param(surface->asked, name, &index) ? JLT_SOURCE_OWN : JLT_SOURCE_LEVEL;
}

/* Add the table's parameters that have this source, with defaults of the asked table for OWN, else its own. */
static jlt_status add_params(jlt_surface *out, jlt_source source)
{
    const jlt_descriptor *table = out->table;
    size_t index;

    for (unsigned i = 0; i < table->param_count; i++) {
        const jlt_quantity *q = &table->params[i];
        if (source_of(out, q->name) != source) continue;
        const bool own = source == JLT_SOURCE_OWN && jlt_descriptor_param(out->asked, q->name, &index);
        JLT_PASS(add(out, q, own ? out->asked->params[index].value : q->value, i));
    }
    return JLT_OK;
}

static jlt_status list_values(jlt_surface *out)
{
    const jlt_descriptor *asked = out->asked, *table = out->table;
    size_t index;

    if (table->param_count + out->section->level_count > JLT_CHART_VALUES_MAX) return JLT_ERR_UNSUPPORTED;
    JLT_PASS(add_params(out, JLT_SOURCE_OWN));
    for (unsigned i = 0; i < asked->param_count; i++) {
        const jlt_quantity *q = &asked->params[i];
        const bool is_other = !jlt_descriptor_param(table, q->name, &index) || source_of(out, q->name) == JLT_SOURCE_PARAMS;
        if (is_other) JLT_PASS(add(out, q, q->value, JLT_SURFACE_COMPUTED));
    }
    out->params = out->count;
    for (unsigned i = 0; i < out->section->level_count; i++)
        JLT_PASS(add(out, &out->section->levels[i], out->section->levels[i].value, table->param_count + i));
    JLT_PASS(add_params(out, JLT_SOURCE_LEVEL));
    for (unsigned i = out->params; i < out->count; i++)
        if (jlt_surface_taken(out, out->names[i]) != NULL) return JLT_ERR_UNSUPPORTED;
    return JLT_OK;
}

const char *jlt_surface_taken(const jlt_surface *surface, const char *level)
{
    static const char other[] = "an integral that no proof compares with it,";
    const jlt_section_chart *section = surface->section;
    size_t index;
    const bool is_param = jlt_descriptor_param(surface->table, level, &index);
    bool passed_on = false; /* from parameter to parameter */

    if (is_param && source_of(surface, level) != JLT_SOURCE_LEVEL) return NULL;
    if (jlt_descriptor_param(surface->asked, level, &index)) return "a parameter";
    if (jlt_descriptor_claim(surface->asked, "integral", level) == NULL) return NULL;
    if (!jlt_descriptor_lists(surface->asked->family[0], level)) return "a conditional integral";
    for (unsigned i = 1; i < surface->link.count; i++) { /* reductions compare integrals of equal names, one after the other */
        const jlt_descriptor *from = surface->link.steps[i].from;
        const bool has_param = jlt_descriptor_param(from, level, &index);
        passed_on |= is_param && has_param;
        if (passed_on ? !has_param : !jlt_descriptor_lists(from, level)) return other;
    }
    for (unsigned i = 0; i < section->level_count; i++) /* and the section may give its level by an integral of another name */
        if (strcmp(section->levels[i].name, level) == 0 &&
            strcmp(surface->table->family[0]->integrals[section->integrals[i]].name, level) != 0)
            return other;
    return NULL;
}

/* Whether proved claims lead from the asked table to this section of `table`; if not, *claim is one that is not proved, or NULL. */
static bool serves(jlt_link *link, const jlt_claim **claim, const jlt_descriptor *asked, const jlt_way_tables *others,
                   const jlt_descriptor *table, const jlt_section_chart *section)
{
    if (!jlt_link_find(link, claim, asked, table, others)) return false;
    *claim = &table->claims[section->claim];
    if ((*claim)->verdict != JLT_PROVED) return false;
    *claim = NULL;
    return true;
}

/* Table `number` of the search: the asked one, tables beside it, then built-in ones; NULL for a built-in one that came before. */
static const jlt_descriptor *candidate(size_t number, const jlt_descriptor *asked, const jlt_way_tables *others)
{
    const size_t beside = others != NULL ? others->count : 0;

    if (number == 0) return asked->family[0];
    if (number <= beside) return others->tables[number - 1]->family[0];
    const jlt_descriptor *built_in = jlt_descriptor_at(number - 1 - beside)->family[0];
    if (strcmp(built_in->sha256, asked->sha256) == 0 || jlt_way_among(others, built_in->sha256) != NULL) return NULL;
    return built_in;
}

jlt_status jlt_surface_find(jlt_surface *out, const jlt_claim **broken, const jlt_descriptor *asked, const jlt_way_tables *others,
                            const char *name)
{
    const size_t count = 1 + (others != NULL ? others->count : 0) + jlt_descriptor_count();
    const jlt_claim *claim = NULL;
    jlt_link link = { .count = 0 };
    bool found = false;

    *out = (jlt_surface){ .asked = asked };
    *broken = NULL;
    if (asked == NULL) return JLT_ERR_ARG;
    for (size_t i = 0; i < count && !found; i++) {
        const jlt_descriptor *general = candidate(i, asked, others), *table = general != NULL ? widest(general) : NULL;
        for (unsigned k = 0; table != NULL && k < table->section_count && !found; k++) {
            const jlt_section_chart *section = &table->sections[k];
            if (name != NULL && strcmp(section->name, name) != 0) continue;
            found = serves(&link, &claim, asked, others, table, section);
            if (!found && (claim == NULL || *broken != NULL)) continue;
            *broken = claim;
            out->table = table;
            out->section = section;
            out->link = link;
        }
    }
    return out->table != NULL ? list_values(out) : JLT_ERR_UNSUPPORTED;
}

unsigned jlt_surface_value(const jlt_surface *surface, const char *name)
{
    unsigned i = 0;

    while (i < surface->count && strcmp(surface->names[i], name) != 0) i++;
    return i;
}

/* ---- the system ---- */

/* Fill in the asked table's parameters, with its defaults where the surface has no value. */
static void ask(double *out, const jlt_surface *surface, const double *values)
{
    for (unsigned i = 0; i < surface->asked->param_count; i++) {
        const unsigned value = jlt_surface_value(surface, surface->asked->params[i].name);
        out[i] = value < surface->params ? values[value] : surface->asked->params[i].value;
    }
}

void jlt_surface_arrange(double *out, const jlt_surface *surface, const double *values)
{
    double params[JLT_WAY_VALUES_MAX];

    if (jlt_link_computes(&surface->link)) {
        ask(params, surface, values);
        jlt_link_params(&surface->link, out, params);
    }
    for (unsigned i = 0; i < surface->count; i++)
        if (surface->entries[i] != JLT_SURFACE_COMPUTED) out[surface->entries[i]] = values[i];
}

/* Check the parameters of the asked table, and of the section's. */
static jlt_status check_params(const jlt_surface *surface, const double *values, const double *arranged)
{
    double params[JLT_WAY_VALUES_MAX];
    size_t index;

    ask(params, surface, values);
    JLT_PASS(jlt_descriptor_check_params(surface->asked, params, &index));
    return jlt_descriptor_check_params(surface->table, arranged, &index);
}

/* The asked table's state number `state`, in its units, at the end of an orbit in the state x of the section's table. Where no
 * single way leads back it is the state of the same name. */
static bool asked_state(double *value, unsigned state, const surface_system *self, const double *x)
{
    const jlt_surface *surface = &self->surface;
    const jlt_way *way = surface->link.count == 1 ? surface->link.steps[0].way : NULL;
    const char *name = surface->asked->states[state].name;
    double all[JLT_WAY_VALUES_MAX];
    size_t same;

    if (way != NULL && surface->asked->state_count <= JLT_WAY_VALUES_MAX) {
        way->back(x, self->rows.values, all);
        *value = all[state];
        return true;
    }
    if (!jlt_descriptor_state(surface->table, name, &same)) return false;
    *value = x[same];
    return true;
}

/* The side of the pole of the asked table; 0: that table does not call it a pole. */
static int side_of_asked(const jlt_chart *base, double *x)
{
    static const double near = 1e-6; /* of the interval */
    const surface_system *self = (const void *)((const char *)base - offsetof(surface_system, rows));
    const jlt_descriptor *asked = self->surface.asked->family[0];
    double at;

    (void)jlt_chart_pole_side(base, self->surface.table, self->rows.plain, x);
    for (unsigned i = 0; i < asked->pole_count; i++) {
        const jlt_quantity *q = &asked->states[asked->poles[i].state];
        if (!asked_state(&at, asked->poles[i].state, self, x)) continue;
        if (fabs(at - q->high) <= near * (q->high - q->low)) return 1;
        if (fabs(at - q->low) <= near * (q->high - q->low)) return -1;
    }
    return 0;
}

/* Make the flow's chart, in the flow's units, from the one in the table's. */
static void set_chart(surface_system *self)
{
    const jlt_section_chart *section = self->surface.section;
    const jlt_units *units = &self->base.units;
    jlt_chart_section *rows = &self->rows;

    memcpy(rows->unit, self->base.flow.units.state, sizeof rows->unit);
    for (unsigned k = 0; k < rows->base.dim; k++) rows->per[k] = jlt_units_exponent(units, section->coordinates[k].unit);
    for (unsigned k = 0; k < section->level_count; k++)
        rows->per[rows->base.dim + k] = jlt_units_exponent(units, section->levels[k].unit);
    if (rows->base.side != NULL && self->surface.link.count > 0) rows->base.side = side_of_asked;
    jlt_chart_counted_init(&self->flow, &rows->base, rows->unit, rows->per);
    self->base.flow.chart = self->base.chart_base = &self->flow.base;
    if (self->surface.asked->family[0]->valid_count == 0) self->base.flow.observed = NULL; /* whatever the section's table says */
}

static jlt_status open_system(surface_system *self, const jlt_system *near, const jlt_flow *options)
{
    const jlt_section_chart *section = self->surface.section;
    const jlt_descriptor *descriptor;
    double values[JLT_CHART_VALUES_MAX] = { 0 };

    jlt_surface_arrange(values, &self->surface, self->values);
    JLT_PASS(check_params(&self->surface, self->values, values));
    JLT_PASS(jlt_chart_section_init(&self->rows, self->surface.table, section, values));
    descriptor = jlt_descriptor_choose(self->surface.table, self->surface.table->time, NULL, values);
    JLT_PASS(jlt_system_bind(&self->base, descriptor, values, &(jlt_units){ 0 }, options));
    if (near != NULL || !jlt_surface_units_named(section)) {
        const jlt_units units = near != NULL ? near->units : jlt_surface_units_of(&self->rows);
        JLT_PASS(jlt_system_count_in(&self->base, &units));
    }
    set_chart(self);
    if (near != NULL) return JLT_OK;
    if (jlt_section_points_none(&self->rows)) return JLT_ERR_EMPTY;
    return jlt_surface_crossing_met(&self->base, &self->rows);
}

/* Make the system, for jlt_surface_system_near if `near` is not NULL. */
static jlt_status make(jlt_system **out, const jlt_surface *surface, const jlt_system *near, const double *values,
                       const jlt_flow *options)
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
    JLT_TRY(open_system(self, near, options));
    if (near == NULL && !jlt_surface_crossing_ends_at_poles(&self->base, &self->rows)) {
        jlt_surface plain = *surface; /* in the model's own time, in which orbits stop before the poles */
        plain.table = surface->table->family[0];
        plain.section = &plain.table->sections[surface->section - surface->table->sections];
        st = make(out, &plain, NULL, values, options);
        goto done;
    }
    *out = &self->base;
    self = NULL; /* ownership moved to the caller */
done:
    if (self != NULL) jlt_system_destroy(&self->base);
    return st;
}

jlt_status jlt_surface_system(jlt_system **out, const jlt_surface *surface, const double *values, const jlt_flow *options)
{
    return make(out, surface, NULL, values, options);
}

jlt_status jlt_surface_system_near(jlt_system **out, const jlt_system *near, const double *values, const jlt_flow *options)
{
    return make(out, near->surface, near, values, options);
}

jlt_status jlt_surface_count_in(jlt_system *system, const jlt_units *units)
{
    const jlt_status st = jlt_system_count_in(system, units);

    if (st == JLT_OK) set_chart((surface_system *)(void *)system);
    return st;
}

jlt_status jlt_surface_family_init(jlt_surface_family *out, const jlt_descriptor *asked, const char *runs)
{
    const jlt_claim *broken;

    *out = (jlt_surface_family){ .options = { .direction = JLT_RISING } };
    JLT_PASS(jlt_surface_find(&out->surface, &broken, asked, NULL, NULL));
    if (broken != NULL) return JLT_ERR_UNSUPPORTED;
    memcpy(out->values, out->surface.defaults, sizeof out->values);
    out->runs = runs != NULL ? jlt_surface_value(&out->surface, runs) : out->surface.count;
    if (out->runs == out->surface.count) return JLT_ERR_ARG;
    return JLT_OK;
}

jlt_status jlt_surface_at(void *context, jlt_system **out, double value, const jlt_system *near)
{
    jlt_surface_family *self = context;

    self->values[self->runs] = value;
    return make(out, near != NULL ? near->surface : &self->surface, near, self->values, &self->options);
}

bool jlt_surface_interval(const jlt_system *system, unsigned coordinate, double *low, double *high)
{
    return jlt_section_points_interval(jlt_surface_chart(system), coordinate, low, high);
}

const jlt_chart_section *jlt_surface_chart(const jlt_system *system) { return &of(system)->rows; }

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
