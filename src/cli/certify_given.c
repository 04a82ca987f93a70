#include "cli/certify_given.h"

#include "ball/ball.h"
#include "core/memory.h"
#include "ext/number.h"
#include "kernel/descriptor.h"

#include <string.h>

static void show(void *progress, size_t steps)
{
    jlt_progress_show(progress, steps, 0);
}

jlt_step_watch jlt_certify_watch(jlt_progress *progress)
{
    jlt_progress_start(progress, "validated steps");
    return (jlt_step_watch){ .told = show, .context = progress };
}

/* Finds the expression of a value in a parsed table; TTC_NONE: there is none. */
typedef ttc_id value_finder(const ttc_model *model, const char *name);

static ttc_id find_default(const ttc_model *model, const char *name)
{
    uint32_t symbol;

    return ttc_model_find_symbol(model, name, &symbol) ? model->symbols[symbol].value : TTC_NONE;
}

/* The value of the state that the section of this name fixes. */
static ttc_id find_section(const ttc_model *model, const char *name)
{
    for (size_t i = 0; i < model->section_count; i++) {
        const ttc_claim *claim = &model->claims[model->sections[i].claim];
        if (strcmp(claim->name, name) == 0) return claim->when.items[0].expression;
    }
    return TTC_NONE;
}

/* The exact value "p/q" of an expression in a table's text; for free(). NULL: none. */
static char *text_of(value_finder *find, const char *table, const char *name)
{
    ttc_model *model = ttc_model_again(table, "table");
    const ttc_id value = model == NULL ? TTC_NONE : find(model, name);
    ttc_ball *ball = value == TTC_NONE ? NULL : ttc_ball_create(model);
    char *text = ball == NULL ? NULL : ttc_ball_exact_text(ball, value);

    ttc_ball_destroy(ball);
    ttc_model_destroy(model);
    return text;
}

char *jlt_certify_default(const char *table, const char *name) { return text_of(find_default, table, name); }

/* The exact value of a level or parameter: as typed, else the first default in these tables; for free(). NULL: none. */
static char *value_of(const char *name, const jlt_motion_options *options, const char *const *tables, unsigned count)
{
    const char *typed = jlt_assign_fraction(&options->level, name);
    char *text = NULL;

    if (typed == NULL) typed = jlt_assign_fraction(&options->common.set, name);
    if (typed != NULL) return strdup(typed);
    for (unsigned i = 0; text == NULL && i < count; i++) text = jlt_certify_default(tables[i], name);
    return text;
}

jlt_exit jlt_certify_put(json_t *object, const char *key, const char *name, char *text, const jlt_assign_list *spread)
{
    const char *radius = jlt_assign_fraction(spread, name);
    int failed;

    if (text == NULL) return jlt_command_fail(JLT_EXIT_INPUT, "%s has no exact value: give one", name);
    failed = radius == NULL ? json_object_set_new(object, key, json_string(text))
                            : json_object_set_new(object, key, json_pack("{s:s,s:s}", "middle", text, "radius", radius));
    free(text);
    return failed == 0 ? JLT_EXIT_DONE : jlt_command_no_memory();
}

/* The expression that the record `claim`, a reduction or lift, gives for the target's parameter `name`; TTC_NONE: none, or a
 * root. */
static ttc_id expression_of(const ttc_model *model, const char *claim, const char *name)
{
    for (size_t i = 0; i < model->way_count; i++) {
        const ttc_way *way = &model->ways[i];
        if (strcmp(model->claims[way->claim].name, claim) != 0) continue;
        for (size_t k = 0; k < way->image.count; k++)
            if (strcmp(way->image.names[k], name) == 0 && way->image.forms[k] == TTC_GIVEN_PLAIN)
                return model->claims[way->claim].entries[2 * k];
    }
    return TTC_NONE;
}

/* The exact value of parameter `name` after a step, computed from the exact parameters before it (name: "p/q"). For the caller to
 * free(); NULL: it is not rational, or not given by an expression. */
static char *compute(const jlt_link_step *step, const char *name, const json_t *params)
{
    ttc_model *model = ttc_model_again(step->from->table, "table");
    const ttc_id value = model == NULL ? TTC_NONE : expression_of(model, step->claim->name, name);
    ttc_ball *ball = value == TTC_NONE ? NULL : ttc_ball_create(model);
    const char *param;
    char *text = NULL;
    uint32_t symbol;
    json_t *given;

    if (ball != NULL) {
        json_object_foreach((json_t *)(uintptr_t)params, param, given)
            if (ttc_model_find_symbol(model, param, &symbol)) ttc_ball_set_fraction(ball, symbol, json_string_value(given));
        text = ttc_ball_exact_text(ball, value);
    }
    ttc_ball_destroy(ball);
    ttc_model_destroy(model);
    return text;
}

/* The parameters after a step that have exact values (name: "p/q"); a new reference. */
static json_t *follow_step(const jlt_link_step *step, const json_t *params)
{
    json_t *next = json_object();

    for (unsigned i = 0; i < step->to->param_count; i++) {
        const char *name = step->to->params[i].name, *same = json_string_value(json_object_get(params, name));
        const bool is_computed = step->way != NULL && step->way->sources[i] == JLT_SOURCE_PARAMS;
        char *text = is_computed ? compute(step, name, params) : same == NULL ? NULL : strdup(same);
        if (text != NULL) json_object_set_new(next, name, json_string(text));
        free(text);
    }
    return next;
}

/* Add the parameters of the section's table that are computed from those of the table asked for. */
static jlt_exit of_link(json_t *params, const jlt_descriptor *d, const jlt_motion_options *options, const jlt_surface *surface,
                        const jlt_assign_list *spread)
{
    const jlt_descriptor *asked = surface->asked;
    json_t *values = json_object();
    jlt_exit code = JLT_EXIT_DONE;

    for (unsigned i = 0; jlt_link_computes(&surface->link) && i < asked->param_count; i++) {
        char *text = value_of(asked->params[i].name, options, &asked->table, 1);
        if (text != NULL) json_object_set_new(values, asked->params[i].name, json_string(text));
        free(text);
    }
    for (unsigned i = 0; i < surface->link.count; i++) {
        json_t *next = follow_step(&surface->link.steps[i], values);
        json_decref(values);
        values = next;
    }
    for (unsigned i = 0; code == JLT_EXIT_DONE && i < d->param_count; i++) {
        const char *name = d->params[i].name, *text = json_string_value(json_object_get(values, name));
        if (surface->link.count == 0 || jlt_link_source(&surface->link, name) != JLT_SOURCE_PARAMS) continue;
        code = text != NULL ? jlt_certify_put(params, name, name, strdup(text), spread)
                            : jlt_command_fail(JLT_EXIT_INPUT,
                                               "a theorem is one of %s, whose parameter %s is computed here from parameters of "
                                               "%s, and is no fraction: ask %s itself, with --set %s=VALUE",
                                               d->model, name, asked->model, d->model, name);
    }
    json_decref(values);
    return code;
}

static jlt_exit of_surface(json_t *params, json_t *levels, const jlt_descriptor *d, const jlt_motion_options *options,
                           const jlt_surface *surface, const jlt_assign_list *spread)
{
    const char *const tables[] = { surface->asked->table, d->table, surface->section->table };
    jlt_exit code = JLT_EXIT_DONE;

    for (unsigned i = 0; code == JLT_EXIT_DONE && i < surface->count; i++) {
        const unsigned entry = surface->entries[i];
        if (entry == JLT_SURFACE_COMPUTED) continue;
        char *text = value_of(surface->names[i], options, tables, 3);
        code = entry < d->param_count
                   ? jlt_certify_put(params, d->params[entry].name, surface->names[i], text, spread)
                   : jlt_certify_put(levels, d->integrals[surface->section->integrals[entry - d->param_count]].name,
                         surface->names[i], text, spread);
    }
    return code == JLT_EXIT_DONE ? of_link(params, d, options, surface, spread) : code;
}

static jlt_exit of_plane(json_t *params, json_t *levels, const jlt_descriptor *d, const jlt_motion_options *options,
                         const jlt_assign_list *spread)
{
    jlt_exit code = JLT_EXIT_DONE;

    for (unsigned i = 0; code == JLT_EXIT_DONE && i < d->param_count; i++) {
        const char *name = d->params[i].name;
        code = jlt_certify_put(params, name, name, value_of(name, options, &d->table, 1), spread);
    }
    for (size_t i = 0; code == JLT_EXIT_DONE && i < options->level.count; i++) {
        const jlt_assignment *level = &options->level.items[i];
        code = jlt_certify_put(levels, level->name, level->name, strdup(level->fraction), spread);
    }
    return code;
}

/* Add the section's state with its exact value: from the table that describes the section, else as typed in --section. */
static jlt_exit put_section(json_t *given, const jlt_descriptor *d, const jlt_motion_options *options, const jlt_system *system)
{
    const jlt_chart *chart = system->flow.chart;
    const char *typed = system->surface == NULL && options->section != NULL ? strchr(options->section, '=') : NULL;
    JLT_FREED char *text = NULL;
    json_t *section;

    if (system->surface != NULL) text = text_of(find_section, d->table, system->surface->section->name);
    else if (typed != NULL && jlt_number_fraction(&text, typed + 1, strlen(typed + 1)) != JLT_OK) text = NULL;
    if (text == NULL) return jlt_command_fail(JLT_EXIT_INPUT, "--section: '%s' has no exact value",
                                              options->section != NULL ? options->section : d->states[chart->column].name);
    section = json_pack("{s:s,s:s,s:i}", "state", d->states[chart->column].name, "value", text, "direction",
                        options->flow.direction == JLT_FALLING ? -1 : 1);
    return json_object_set_new(given, "section", section) == 0 ? JLT_EXIT_DONE : jlt_command_no_memory();
}

jlt_exit jlt_certify_check_spread(const jlt_assign_list *spread, const json_t *params, const json_t *others, const char *what)
{
    for (size_t i = 0; i < spread->count; i++) {
        const char *name = spread->items[i].name;
        if (json_object_get(params, name) == NULL && json_object_get(others, name) == NULL)
            return jlt_command_fail(JLT_EXIT_INPUT, "--spread: there is neither a parameter nor %s '%s' here", what, name);
        if (!(spread->items[i].value > 0))
            return jlt_command_fail(JLT_EXIT_INPUT, "--spread: the radius of %s is a number > 0", name);
    }
    return JLT_EXIT_DONE;
}

jlt_exit jlt_certify_given(json_t **given, const jlt_descriptor **of, const jlt_motion_options *options, const jlt_system *system,
                           const jlt_assign_list *spread, unsigned digits)
{
    const jlt_descriptor *d = jlt_descriptor_sibling(system->instance->descriptor, NULL, NULL, NULL);
    json_t *params = json_object(), *levels = json_object();
    jlt_exit code;

    *of = d;
    *given = json_pack("{s:{s:s,s:s},s:o,s:o,s:i}", "table", "name", d->model, "sha256", d->sha256, "parameters",
                       params, "levels", levels, "digits", (int)digits);
    if (*given == NULL) return jlt_command_no_memory();
    code = system->surface != NULL ? of_surface(params, levels, d, options, system->surface, spread)
                                   : of_plane(params, levels, d, options, spread);
    if (code == JLT_EXIT_DONE) code = jlt_certify_check_spread(spread, params, levels, "a level");
    if (code == JLT_EXIT_DONE) code = put_section(*given, d, options, system);
    if (code != JLT_EXIT_DONE) {
        json_decref(*given);
        *given = NULL;
    }
    return code;
}
