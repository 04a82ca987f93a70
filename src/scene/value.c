#include "scene/value.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/digits.h"
#include "ext/number.h"
#include "integrate/method.h"
#include "scene/scene.h"
#include "dynamics/surface.h"

jlt_status jlt_value_complain(const jlt_value_reader *r, int line, const char *format, ...)
{
    va_list arguments;
    int used = line > 0 ? snprintf(r->message, JLT_SCENE_MESSAGE_MAX, "%s:%d: error: ", r->file, line)
                        : snprintf(r->message, JLT_SCENE_MESSAGE_MAX, "%s: error: ", r->file);

    if (used < 0 || used >= JLT_SCENE_MESSAGE_MAX) return JLT_ERR_ARG;
    va_start(arguments, format);
    vsnprintf(r->message + used, JLT_SCENE_MESSAGE_MAX - (size_t)used, format, arguments);
    va_end(arguments);
    return JLT_ERR_ARG;
}

int jlt_value_line(const config_setting_t *setting)
{
    return (int)config_setting_source_line(setting);
}

/* ---- words that must be known ---- */

/* Collects the names that a key allows: looks for `word` among them, or lists them all. */
typedef struct {
    const char *word; /* NULL: list all names */
    char *list;
    size_t size;
    bool found;
} names;

static void meet(names *self, const char *name)
{
    if (self->word != NULL) self->found |= strcmp(self->word, name) == 0;
    else jlt_schema_add_name(self->list, self->size, name);
}

static void meet_quantities(names *self, const jlt_quantity *quantities, unsigned count)
{
    for (unsigned i = 0; i < count; i++) meet(self, quantities[i].name);
}

/* The states except the section's and those that are solved for. */
static void meet_free_states(names *self, const jlt_value_reader *r)
{
    for (unsigned i = 0; i < r->model->state_count; i++) {
        const char *name = r->model->states[i].name;
        const bool fixed = (r->section != NULL && config_setting_get_member(r->section, name) != NULL)
                           || (r->solve != NULL && config_setting_get_member(r->solve, name) != NULL);
        if (!fixed) meet(self, name);
    }
}

static void meet_integrals(names *self, const jlt_descriptor *model)
{
    for (const jlt_claim *claim = model->claims; claim->kind != NULL; claim++)
        if (strcmp(claim->kind, "integral") == 0) meet(self, claim->name);
}

/* Words separated by '|' or ','; a word ends at '='. */
static void meet_words(names *self, const char *words)
{
    char word[64];

    for (size_t length; *words != '\0'; words += length + (words[length] != '\0')) {
        length = strcspn(words, "|,");
        snprintf(word, sizeof word, "%.*s", (int)strcspn(words, "|,="), words);
        meet(self, word);
    }
}

static void meet_all(names *self, const jlt_value_reader *r, const jlt_key *key)
{
    const jlt_descriptor *model = r->model;
    const jlt_claim *broken;
    jlt_surface surface;
    const bool plane = r->section != NULL || jlt_surface_find(&surface, &broken, model, &r->others, r->named) != JLT_OK;
    const bool levels = (key->names & JLT_NAMES_LEVELS) != 0, coordinates = (key->names & JLT_NAMES_COORDINATES) != 0;
    const bool methods = (key->names & JLT_NAMES_METHODS) != 0;

    if (key->words != NULL) meet_words(self, key->words);
    for (size_t i = 0; methods && jlt_method_at(i) != NULL; i++) meet(self, jlt_method_at(i)->name);
    for (unsigned i = 0; coordinates && !plane && i < surface.section->coordinate_count; i++)
        meet(self, surface.section->coordinates[i].name);
    if (coordinates && plane) meet_free_states(self, r);
    if (key->names & JLT_NAMES_STATES) meet_quantities(self, model->states, model->state_count);
    if (key->names & JLT_NAMES_PARAMS) meet_quantities(self, model->params, model->param_count);
    for (unsigned i = plane ? 0 : surface.params; levels && !plane && i < surface.count; i++) meet(self, surface.names[i]);
    if (levels && plane) meet_integrals(self, model);
}

/* Whether the key takes coordinates of a section that no table describes: the command, which needs it, says why there is none. */
static bool lacks_section(const jlt_value_reader *r, const jlt_key *key)
{
    const jlt_claim *broken;
    jlt_surface surface;

    return (key->names & JLT_NAMES_COORDINATES) != 0 && r->section == NULL
           && jlt_surface_find(&surface, &broken, r->model, &r->others, r->named) != JLT_OK;
}

static jlt_status check_word(const jlt_value_reader *r, const config_setting_t *at, const jlt_key *key, const char *word)
{
    char text[256] = "";
    names sought = { .word = word }, known = { .list = text, .size = sizeof text };

    if ((key->names == JLT_NAMES_ANY && key->words == NULL) || lacks_section(r, key)) return JLT_OK;
    meet_all(&sought, r, key);
    if (sought.found) return JLT_OK;
    meet_all(&known, r, key);
    return jlt_value_complain(r, jlt_value_line(at), "'%s' does not know '%s' (it knows %s)", key->key, word,
                              text[0] != '\0' ? text : "none");
}

/* ---- values as a command line has them ---- */

static jlt_status append(const jlt_value_reader *r, const config_setting_t *at, jlt_value *v, const char *text)
{
    const size_t length = strlen(text);

    if (v->used + length >= sizeof v->text) return jlt_value_complain(r, jlt_value_line(at), "value is too long");
    memcpy(v->text + v->used, text, length + 1);
    v->used += length;
    return JLT_OK;
}

static jlt_status append_number(const jlt_value_reader *r, const config_setting_t *at, jlt_value *v, const char *name)
{
    char text[JLT_DIGITS_SIZE];
    const char *string = text;
    double ignored;

    switch (config_setting_type(at)) {
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64: snprintf(text, sizeof text, "%lld", config_setting_get_int64(at)); break;
    case CONFIG_TYPE_FLOAT: jlt_digits_shortest(text, config_setting_get_float(at)); break;
    case CONFIG_TYPE_STRING: string = config_setting_get_string(at); break;
    default: return jlt_value_complain(r, jlt_value_line(at), "'%s' takes a number (such as 0.51 or \"1/3\")", name);
    }
    switch (jlt_number_parse(&ignored, string, strlen(string))) {
    case JLT_OK: return append(r, at, v, string);
    case JLT_ERR_NONFINITE:
        return jlt_value_complain(r, jlt_value_line(at), "'%s' is beyond the range of numbers: %s", name, string);
    default:
        return jlt_value_complain(r, jlt_value_line(at), "'%s' is no number: \"%s\" (write 2, -0.51, 1e-3, 1/3, pi or 2*pi/3)",
                                  name, string);
    }
}

static jlt_status append_whole(const jlt_value_reader *r, const config_setting_t *at, jlt_value *v, const char *name,
                               long long least)
{
    char text[32];

    if (config_setting_type(at) != CONFIG_TYPE_INT && config_setting_type(at) != CONFIG_TYPE_INT64)
        return jlt_value_complain(r, jlt_value_line(at), "'%s' takes a whole number", name);
    if (config_setting_get_int64(at) < least)
        return jlt_value_complain(r, jlt_value_line(at), "'%s' must be at least %lld", name, least);
    snprintf(text, sizeof text, "%lld", config_setting_get_int64(at));
    return append(r, at, v, text);
}

static jlt_status append_list(const jlt_value_reader *r, const config_setting_t *at, jlt_value *v, const char *name)
{
    if (config_setting_is_array(at) == CONFIG_FALSE && config_setting_is_list(at) == CONFIG_FALSE)
        return jlt_value_complain(r, jlt_value_line(at), "'%s' takes numbers in parentheses, (0, 0.5, 1)", name);
    if (config_setting_length(at) == 0) return jlt_value_complain(r, jlt_value_line(at), "'%s' is empty", name);
    for (int i = 0; i < config_setting_length(at); i++) {
        if (i > 0) JLT_PASS(append(r, at, v, ","));
        JLT_PASS(append_number(r, config_setting_get_elem(at, (unsigned)i), v, name));
    }
    return JLT_OK;
}

/* (first, last, count) */
static jlt_status append_range(const jlt_value_reader *r, const config_setting_t *at, jlt_value *v, const char *name)
{
    char count[160];

    if (config_setting_length(at) != 3)
        return jlt_value_complain(r, jlt_value_line(at), "'%s' takes one number or (first, last, how many)", name);
    JLT_PASS(append_number(r, config_setting_get_elem(at, 0), v, name));
    JLT_PASS(append(r, at, v, ":"));
    JLT_PASS(append_number(r, config_setting_get_elem(at, 1), v, name));
    JLT_PASS(append(r, at, v, ":"));
    snprintf(count, sizeof count, "how many of %s", name);
    return append_whole(r, config_setting_get_elem(at, 2), v, count, 1);
}

/* (low, high) */
static jlt_status append_interval(const jlt_value_reader *r, const config_setting_t *at, jlt_value *v, const char *name)
{
    if (config_setting_length(at) != 2) return jlt_value_complain(r, jlt_value_line(at), "'%s' takes (low, high)", name);
    JLT_PASS(append_number(r, config_setting_get_elem(at, 0), v, name));
    JLT_PASS(append(r, at, v, ":"));
    return append_number(r, config_setting_get_elem(at, 1), v, name);
}

static jlt_status append_group(const jlt_value_reader *r, const config_setting_t *at, jlt_value *v, const jlt_key *key)
{
    const char *name = key->key;

    if (r->named != NULL && strcmp(name, "section") == 0) return append(r, at, v, r->named);
    if (config_setting_is_group(at) == CONFIG_FALSE)
        return jlt_value_complain(r, jlt_value_line(at), "'%s' takes names and numbers in braces, %s", name,
                                  key->kind == JLT_KEY_INTERVAL ? "{ a = (0, 1); }"
                                  : key->kind == JLT_KEY_RANGES ? "{ a = (-1, 1, 21); b = 2; }" : "{ a = 1; b = 2; }");
    if (key->kind == JLT_KEY_RANGES && config_setting_length(at) == 0)
        return jlt_value_complain(r, jlt_value_line(at), "'%s' is empty", name);
    for (int i = 0; i < config_setting_length(at); i++) {
        const config_setting_t *member = config_setting_get_elem(at, (unsigned)i);
        const bool several = config_setting_is_array(member) == CONFIG_TRUE || config_setting_is_list(member) == CONFIG_TRUE;
        JLT_PASS(check_word(r, member, key, config_setting_name(member)));
        if (i > 0) JLT_PASS(append(r, member, v, ","));
        JLT_PASS(append(r, member, v, config_setting_name(member)));
        JLT_PASS(append(r, member, v, "="));
        if (key->kind == JLT_KEY_INTERVAL) JLT_PASS(append_interval(r, member, v, config_setting_name(member)));
        else if (key->kind == JLT_KEY_RANGES && several) JLT_PASS(append_range(r, member, v, config_setting_name(member)));
        else JLT_PASS(append_number(r, member, v, config_setting_name(member)));
    }
    return JLT_OK;
}

/* The name of a start. A command that finds no section says why. */
static jlt_status append_start(const jlt_value_reader *r, const config_setting_t *at, jlt_value *v, const jlt_key *key)
{
    const char *const word = config_setting_get_string(at);
    char text[256] = "";
    names sought = { .word = word }, known = { .list = text, .size = sizeof text };
    const jlt_claim *broken;
    jlt_surface surface;

    if (lacks_section(r, key)) return append(r, at, v, word);
    if (r->section != NULL || jlt_surface_find(&surface, &broken, r->model, &r->others, r->named) != JLT_OK)
        return append_group(r, at, v, key);
    for (unsigned i = 0; i < surface.section->start_count; i++) {
        meet(&sought, surface.section->starts[i].name);
        meet(&known, surface.section->starts[i].name);
    }
    if (sought.found) return append(r, at, v, word);
    return jlt_value_complain(r, jlt_value_line(at), "the section has no start '%s' (write { NAME = VALUE; ... }%s%s)", word,
                              text[0] != '\0' ? ", or one of " : "", text);
}

jlt_status jlt_value_read(const jlt_value_reader *r, const config_setting_t *at, jlt_value *v, const jlt_key *key)
{
    switch (key->kind) {
    case JLT_KEY_NUMBER: return append_number(r, at, v, key->key);
    case JLT_KEY_COUNT: return append_whole(r, at, v, key->key, 1);
    case JLT_KEY_WHOLE: return append_whole(r, at, v, key->key, 0);
    case JLT_KEY_NUMBERS: return append_list(r, at, v, key->key);
    case JLT_KEY_POINT:
        if ((key->names & JLT_NAMES_COORDINATES) != 0 && config_setting_type(at) == CONFIG_TYPE_STRING)
            return append_start(r, at, v, key);
        return append_group(r, at, v, key);
    case JLT_KEY_GROUP:
    case JLT_KEY_INTERVAL: return append_group(r, at, v, key);
    case JLT_KEY_RANGES:
        if (config_setting_type(at) == CONFIG_TYPE_STRING) return append(r, at, v, config_setting_get_string(at));
        return append_group(r, at, v, key);
    case JLT_KEY_FLAG:
        if (config_setting_type(at) == CONFIG_TYPE_BOOL) return JLT_OK;
        return jlt_value_complain(r, jlt_value_line(at), "'%s' takes true or false", key->key);
    case JLT_KEY_TEXT:
    case JLT_KEY_FILE:
        if (config_setting_type(at) != CONFIG_TYPE_STRING)
            return jlt_value_complain(r, jlt_value_line(at), "'%s' takes a text in quotation marks", key->key);
        if (check_word(r, at, key, config_setting_get_string(at)) != JLT_OK) return JLT_ERR_ARG;
        return append(r, at, v, config_setting_get_string(at));
    }
    return JLT_ERR_ARG;
}
