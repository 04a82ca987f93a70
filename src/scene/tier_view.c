/* Binds a tier to an orbit: follows the ways to its table, binds its kernel, and maps its states back. */
#include "scene/tier.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "kernel/descriptor.h"
#include "kernel/region.h"

JLT_PRINTF(2, 3) static jlt_status refuse(char *refusal, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(refusal, JLT_TIER_TEXT_MAX, format, arguments);
    va_end(arguments);
    return JLT_ERR_UNSUPPORTED;
}

static jlt_status refuse_param(char *refusal, const jlt_quantity *param)
{
    return refuse(refusal, "its table asks for %s%s", param->name, jlt_descriptor_condition(param));
}

static jlt_status refuse_size(char *refusal, const jlt_descriptor *table)
{
    return refuse(refusal, "%s has %u states and %u parameters; a tier serves at most %d of each", table->model, table->state_count,
                  table->param_count, JLT_WAY_VALUES_MAX);
}

static jlt_status refuse_eliminated(char *refusal, const jlt_descriptor *table, const jlt_descriptor *kernel)
{
    return refuse(refusal, "%s does not depend on %s there, so that it cannot be eliminated",
                  table->integrals[kernel->level_integral].name, table->states[kernel->eliminated_state].name);
}

static bool is_counted(const jlt_tier *tier) { return tier->units.mass != 0 || tier->units.length != 0 || tier->units.time != 0; }

/* The condition of a way that does not hold, evaluated in the table's units; NULL: all hold. at: a state of the table where the way
 * begins; NULL: only conditions on parameters count. */
static const jlt_way_condition *find_broken(const jlt_tier_view *view, unsigned number, const double *at)
{
    const jlt_tier *tier = &view->tier;
    const jlt_descriptor *from = tier->from[number];
    double x[JLT_WAY_VALUES_MAX], params[JLT_WAY_VALUES_MAX];

    if (!is_counted(tier)) return jlt_way_broken(tier->ways[number], at, view->params[number]);
    jlt_units_restore(params, view->params[number], from->params, from->param_count, &tier->units);
    if (at != NULL) jlt_units_restore(x, at, from->states, from->state_count, &tier->units);
    return jlt_way_broken(tier->ways[number], at != NULL ? x : NULL, params);
}

void jlt_tier_conditions(double *values, const jlt_tier_view *view, const jlt_descriptor *general, const double *y)
{
    const double *params = view->params[view->tier.way_count];
    double table_y[JLT_WAY_VALUES_MAX], table_params[JLT_WAY_VALUES_MAX];

    if (is_counted(&view->tier)) {
        jlt_units_restore(table_y, y, general->states, general->state_count, &view->tier.units);
        jlt_units_restore(table_params, params, general->params, general->param_count, &view->tier.units);
        y = table_y;
        params = table_params;
    }
    general->tier_values(y, params, values);
}

/* Follow the ways from table to table. In/out: at, the state, in the end that of the tier's table; NULL: only parameters. */
static jlt_status follow_ways(jlt_tier_view *view, double *at, char *refusal)
{
    const jlt_tier *tier = &view->tier;
    jlt_status st = JLT_OK;

    for (unsigned i = 0; i < tier->way_count; i++) {
        const jlt_way *way = tier->ways[i];
        const jlt_descriptor *target = i + 1 < tier->way_count ? tier->from[i + 1] : tier->table;
        const jlt_way_condition *broken = find_broken(view, i, at);
        double next[JLT_WAY_VALUES_MAX], told[JLT_WAY_VALUES_MAX], told_params[JLT_WAY_VALUES_MAX];
        const jlt_region *region;
        double value;
        size_t index;

        if (way->param_count > JLT_WAY_VALUES_MAX || way->state_count > JLT_WAY_VALUES_MAX)
            return refuse_size(refusal, target);
        if (broken != NULL) return refuse(refusal, "the %s %s serves only where %s", way->kind, way->name, broken->text);
        if (at == NULL) {
            double *params = view->params[i + 1];
            jlt_way_params(way, params, NULL, view->params[i]);
            /* Without a state levels are arbitrary: replace one whose sign is not allowed by the table's default. */
            while (jlt_descriptor_check_params(target, params, &index) != JLT_OK && isfinite(target->params[index].value) &&
                   params[index] != target->params[index].value)
                params[index] = target->params[index].value;
            continue;
        }
        st = jlt_way_follow(way, next, view->params[i + 1], at, view->params[i]);
        if (st == JLT_ERR_DOMAIN) return refuse(refusal, "an angle of the %s %s has no value at the start", way->kind, way->name);
        if (st != JLT_OK) return refuse(refusal, "the %s %s has no finite value at the start", way->kind, way->name);
        if (jlt_descriptor_check_params(target, view->params[i + 1], &index) != JLT_OK)
            return refuse_param(refusal, &target->params[index]);
        jlt_units_restore(told, next, target->states, target->state_count, &tier->units);
        jlt_units_restore(told_params, view->params[i + 1], target->params, target->param_count, &tier->units);
        if (jlt_descriptor_check_state(target, told, &index) != JLT_OK)
            return refuse(refusal, "%s would lie outside its interval", target->states[index].name);
        if (jlt_region_check(&region, &value, target, told_params, told) != JLT_OK)
            return refuse(refusal, "it would lie outside the domain of %s", target->model);
        memcpy(at, next, target->state_count * sizeof *at);
    }
    return st;
}

static bool is_eliminated(const jlt_tier *tier) { return tier->elimination[0] != '\0'; }

/* The value at x of the integral by which a state is eliminated; x NULL: 0. */
static jlt_status find_level(double *level, const jlt_tier_view *view, const jlt_descriptor *kernel, const double *x)
{
    double values[JLT_WAY_VALUES_MAX];
    JLT_OWNED(jlt_instance) *full = NULL;

    *level = 0;
    if (x == NULL) return JLT_OK;
    if (view->tier.asked->integral_count > JLT_WAY_VALUES_MAX) return JLT_ERR_UNSUPPORTED;
    JLT_PASS(jlt_instance_create(&full, view->tier.asked, view->params[0]));
    full->descriptor->integral_values.call(x, full->prepared, values);
    *level = values[kernel->level_integral];
    return JLT_OK;
}

/* Bind the kernel to the parameters of the tier's table and, if a state is eliminated, to the level of the asked model's state
 * x. */
static jlt_status bind_kernel(jlt_tier_view *view, char *refusal, const double *x)
{
    const jlt_tier *tier = &view->tier;
    const jlt_descriptor *general = jlt_descriptor_sibling(tier->table, NULL, tier->time, tier->elimination), *kernel;
    const double *of_table = view->params[tier->way_count];
    double params[JLT_WAY_VALUES_MAX], level = 0;
    jlt_status st = JLT_OK;
    size_t index;

    if (general == NULL) return refuse(refusal, "its kernel is not built in");
    if (general->param_count > JLT_WAY_VALUES_MAX || general->state_count > JLT_WAY_VALUES_MAX)
        return refuse_size(refusal, general);
    if (general->tier_condition_count > JLT_TIER_EDGES_MAX)
        return refuse(refusal, "its coordinates end at more than %d edges", JLT_TIER_EDGES_MAX);
    if (is_eliminated(tier)) st = find_level(&level, view, general, x);
    if (st == JLT_ERR_UNSUPPORTED) return refuse(refusal, "more than %d integrals", JLT_WAY_VALUES_MAX);
    if (st != JLT_OK) return st;
    for (unsigned i = 0; i < general->param_count; i++)
        params[i] = jlt_descriptor_param(tier->table, general->params[i].name, &index) ? of_table[index] : level;
    kernel = jlt_descriptor_choose(tier->table, tier->time, tier->elimination, params);
    if (kernel == NULL || kernel->rhs.call == NULL) return refuse(refusal, "its kernel is not built in");
    jlt_units_restore(params, params, kernel->params, kernel->param_count, &tier->units);
    st = jlt_instance_create_in(&view->instance, kernel, params, &tier->units);
    if (st == JLT_ERR_DOMAIN && jlt_descriptor_check_params(kernel, params, &index) != JLT_OK)
        return refuse_param(refusal, &kernel->params[index]);
    if ((st == JLT_ERR_NONFINITE || st == JLT_ERR_DOMAIN) && is_eliminated(tier))
        return refuse_eliminated(refusal, tier->table, kernel);
    return st;
}

/* Compute the kernel's states y from the table's states `at`, and refuse if the tier's coordinates are not good there. */
static jlt_status place(const jlt_tier_view *view, double *y, char *refusal, const double *at)
{
    const jlt_tier *tier = &view->tier;
    const jlt_descriptor *general = jlt_descriptor_sibling(tier->table, NULL, tier->time, NULL);
    const double *params = view->params[tier->way_count];
    double values[JLT_WAY_VALUES_MAX];
    unsigned used = 0;

    if (is_eliminated(tier)) {
        for (unsigned i = 0; i < tier->table->state_count; i++)
            if (i != view->instance->descriptor->eliminated_state) y[used++] = at[i];
        view->instance->descriptor->eliminated.call(y, view->instance->prepared, values);
        return isfinite(*values) ? JLT_OK : refuse_eliminated(refusal, tier->table, view->instance->descriptor);
    }
    if (general->lifted != NULL) general->lifted(at, params, y);
    else memcpy(y, at, general->state_count * sizeof *y);
    if (general->tier_values == NULL) return JLT_OK;
    jlt_tier_conditions(values, view, general, y);
    for (unsigned k = 0; k < general->tier_condition_count; k++)
        if (!(values[k] > 0)) return refuse(refusal, "its coordinates are good where %s", general->tier_conditions[k].text);
    return JLT_OK;
}

/* Choose the ways in the tier's time, where tables have it. */
static jlt_status choose_backs(jlt_tier_view *view, char *refusal)
{
    const jlt_tier *tier = &view->tier;

    for (unsigned i = 0; i < tier->way_count; i++) {
        const jlt_descriptor *timed = jlt_descriptor_sibling(tier->from[i], NULL, tier->time, NULL);
        const size_t index = (size_t)(tier->ways[i] - tier->from[i]->ways);
        view->back[i] = timed != NULL && index < timed->way_count ? &timed->ways[index] : tier->ways[i];
        if (timed != NULL && timed->state_count > JLT_WAY_VALUES_MAX) return refuse_size(refusal, timed);
    }
    return JLT_OK;
}

static jlt_status open_from(jlt_tier_view *view, double *y, char *refusal, const jlt_tier *tier, const double *params,
                            const double *x, const signed char *mirror)
{
    double start[JLT_WAY_VALUES_MAX], at[JLT_WAY_VALUES_MAX];
    jlt_status st = JLT_OK;

    *view = (jlt_tier_view){ .tier = *tier, .mirror = mirror };
    memcpy(view->params[0], params, tier->asked->param_count * sizeof *params);
    for (unsigned i = 0; x != NULL && i < tier->asked->state_count; i++)
        at[i] = start[i] = mirror != NULL ? mirror[i] * x[i] : x[i];
    JLT_TRY(follow_ways(view, x != NULL ? at : NULL, refusal));
    JLT_TRY(bind_kernel(view, refusal, x != NULL ? start : NULL));
    if (x != NULL) JLT_TRY(place(view, y, refusal, at));
    st = choose_backs(view, refusal);
done:
    if (st != JLT_OK) jlt_tier_close(view);
    return st;
}

static const signed char *reversor_of(const jlt_descriptor *asked)
{
    for (unsigned i = 0; i < asked->reversor_count; i++)
        if (asked->claims[asked->reversors[i].claim].verdict == JLT_PROVED) return asked->reversors[i].signs;
    return NULL;
}

jlt_status jlt_tier_open(jlt_tier_view *out, double *y, char *refusal, const jlt_tier *tier, const double *params, const double *x)
{
    const signed char *mirror = reversor_of(tier->asked);
    char second[JLT_TIER_TEXT_MAX];
    jlt_status st;

    if (tier->table == NULL) return JLT_ERR_ARG;
    if (tier->asked->state_count > JLT_WAY_VALUES_MAX || tier->asked->param_count > JLT_WAY_VALUES_MAX)
        return refuse_size(refusal, tier->asked);
    st = open_from(out, y, refusal, tier, params, x, NULL);
    if (st != JLT_ERR_UNSUPPORTED || x == NULL || mirror == NULL || tier->way_count == 0 || tier->is_larger) return st;
    st = open_from(out, y, second, tier, params, x, mirror);
    if (st == JLT_OK) refusal[0] = '\0';
    return st;
}

void jlt_tier_close(jlt_tier_view *self)
{
    jlt_instance_destroy(self->instance);
    self->instance = NULL;
}

void jlt_tier_extract(const jlt_tier_view *view, double *x, const double *y)
{
    const jlt_tier *tier = &view->tier;
    const jlt_descriptor *kernel = view->instance->descriptor;
    double rooms[2][JLT_WAY_VALUES_MAX];

    if (is_eliminated(tier)) {
        const unsigned at = kernel->eliminated_state;
        memcpy(x, y, at * sizeof *x);
        memcpy(x + at + 1, y + at, (tier->asked->state_count - at - 1) * sizeof *x);
        kernel->eliminated.call(y, view->instance->prepared, &x[at]);
        return;
    }
    for (unsigned i = tier->way_count; i > 0; i--) {
        view->back[i - 1]->back(y, view->params[i], rooms[i % 2]);
        y = rooms[i % 2];
    }
    for (unsigned i = 0; i < tier->asked->state_count; i++) x[i] = view->mirror != NULL ? view->mirror[i] * y[i] : y[i];
}
