#include "cli/certify_family.h"

#include "ball/ball.h"
#include "core/memory.h"
#include "ext/number.h"
#include "validated/given_family.h"

#include <stdlib.h>
#include <string.h>

/* The exact value of a text as a string "p/q", a new reference; NULL: it is not a number. */
static json_t *fraction_of(const char *text, size_t length)
{
    JLT_FREED char *fraction = NULL;

    return jlt_number_fraction(&fraction, text, length) == JLT_OK ? json_string(fraction) : NULL;
}

/* Add one NAME=LOW:HIGH or NAME=VALUE to the box. */
static jlt_exit put_side(json_t *box, const char *text, size_t length)
{
    const char *equals = memchr(text, '=', length);
    const char *value = equals == NULL ? text : equals + 1;
    const size_t rest = length - (size_t)(value - text);
    const char *colon = memchr(value, ':', rest);
    const size_t first = colon == NULL ? rest : (size_t)(colon - value);

    if (equals == NULL || equals == text)
        return jlt_command_fail(JLT_EXIT_USAGE, "--box: '%.*s' is no range (write NAME=LOW:HIGH or NAME=VALUE)", (int)length, text);
    json_auto_t *low = fraction_of(value, first);
    json_auto_t *high = colon == NULL ? NULL : fraction_of(colon + 1, rest - first - 1);
    JLT_FREED char *name = strndup(text, (size_t)(equals - text));
    if (low == NULL || (colon != NULL && high == NULL))
        return jlt_command_fail(JLT_EXIT_INPUT, "--box: '%.*s' has no finite number (write 2, -0.51, 1e-3, 1/3 or pi)", (int)length,
                                text);
    if (name != NULL && json_object_get(box, name) != NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "--box: '%s' is given twice", name);
    json_auto_t *side = colon == NULL ? json_incref(low) : json_pack("{s:O,s:O}", "low", low, "high", high);
    return name != NULL && json_object_set(box, name, side) == 0 ? JLT_EXIT_DONE : jlt_command_no_memory();
}

static jlt_exit put_sides(json_t *box, const char *text)
{
    jlt_exit code = JLT_EXIT_DONE;

    while (code == JLT_EXIT_DONE && text != NULL && *text != '\0') {
        const size_t length = strcspn(text, ",");
        code = put_side(box, text, length);
        text += length + (text[length] == ',');
    }
    return code;
}

static jlt_exit put_set(json_t *box, const jlt_assign_list *set)
{
    for (size_t i = 0; i < set->count; i++) {
        if (json_object_get(box, set->items[i].name) != NULL)
            return jlt_command_fail(JLT_EXIT_INPUT, "'%s' is given by --set and by --box", set->items[i].name);
        if (json_object_set_new(box, set->items[i].name, json_string(set->items[i].fraction)) != 0) return jlt_command_no_memory();
    }
    return JLT_EXIT_DONE;
}

static bool gives(const ttc_bindings *bindings, uint32_t symbol)
{
    for (size_t i = 0; i < bindings->count; i++)
        if (bindings->items[i].symbol == symbol) return true;
    return false;
}

/* Add the table's defaults of parameters that have no value yet and whose value the family does not fix. */
static jlt_exit put_defaults(json_t *box, const ttc_model *model, const ttc_claim *family)
{
    ttc_ball *ball = ttc_ball_create(model);
    jlt_exit code = ball == NULL ? jlt_command_no_memory() : JLT_EXIT_DONE;

    for (size_t i = 0; code == JLT_EXIT_DONE && i < model->param_count; i++) {
        const ttc_symbol_entry *param = &model->symbols[model->params[i]];
        char *text;
        if (json_object_get(box, param->name) != NULL || param->value == TTC_NONE || gives(&family->when, model->params[i]))
            continue;
        text = ttc_ball_exact_text(ball, param->value);
        if (text == NULL || json_object_set_new(box, param->name, json_string(text)) != 0) code = jlt_command_no_memory();
        free(text);
    }
    ttc_ball_destroy(ball);
    return code;
}

/* Find the family of this name, or the only one if name is NULL. If there is none, prints which families there are. */
static jlt_exit find_family(const ttc_claim **family, const ttc_model *model, const char *name)
{
    char names[256] = "";
    size_t count = 0;

    *family = NULL;
    for (size_t i = 0; i < model->claim_count; i++) {
        const ttc_claim *claim = &model->claims[i];
        const size_t length = strlen(names);
        if (claim->kind != TTC_CLAIM_EQUILIBRIA) continue;
        snprintf(names + length, sizeof names - length, "%s%s", count == 0 ? "" : ", ", claim->name);
        count++;
        if (name == NULL || strcmp(claim->name, name) == 0) *family = claim;
    }
    if (*family != NULL && (name != NULL || count == 1)) return JLT_EXIT_DONE;
    if (count == 0) return jlt_command_fail(JLT_EXIT_INPUT, "%s has no family of equilibria", model->name);
    if (name == NULL) return jlt_command_fail(JLT_EXIT_INPUT, "say which family of %s: --family, one of %s", model->name, names);
    return jlt_command_fail(JLT_EXIT_INPUT, "%s has no family of equilibria '%s'; it has %s", model->name, name, names);
}

/* Refuse what the proof would refuse to begin with, such as a family that is not proved to consist of equilibria. */
static jlt_exit check(const json_t *given, const jlt_descriptor *d)
{
    jlt_given_family read;
    char problem[JLT_GIVEN_PROBLEM_MAX] = "";
    const bool serves = jlt_given_family_read(&read, given, d, problem);

    jlt_given_family_clear(&read);
    return serves ? JLT_EXIT_DONE : jlt_command_fail(JLT_EXIT_INPUT, "%s", problem);
}

jlt_exit jlt_certify_family(json_t **given, const jlt_certify_family_options *o, const jlt_assign_list *set,
                            const jlt_descriptor *d)
{
    ttc_model *model = ttc_model_again(d->table, d->model);
    const ttc_claim *family;
    json_auto_t *box = json_object();
    jlt_exit code = model == NULL ? jlt_command_no_memory() : find_family(&family, model, o->family);

    *given = NULL;
    if (code == JLT_EXIT_DONE) code = put_sides(box, o->box);
    if (code == JLT_EXIT_DONE) code = put_set(box, set);
    if (code == JLT_EXIT_DONE) code = put_defaults(box, model, family);
    if (code == JLT_EXIT_DONE)
        *given = json_pack("{s:{s:s,s:s},s:s,s:O,s:i,s:i}", "table", "name", d->model, "sha256", d->sha256, "family", family->name,
                           "box", box, "limit", (int)o->limit, "digits", (int)o->digits);
    if (code == JLT_EXIT_DONE) code = *given != NULL ? check(*given, d) : jlt_command_no_memory();
    ttc_model_destroy(model);
    return code;
}
