#include "scene/scene.h"

#include <errno.h>
#include <libconfig.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ext/number.h"
#include "scene/schema.h"

enum { VALUE_MAX = 4096, NAMES_MAX = 256 };

typedef struct {
    const char *file;
    char *message;
} reader;

static jlt_status complain(const reader *r, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static jlt_status complain(const reader *r, int line, const char *format, ...)
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

static int line_of(const config_setting_t *setting)
{
    return (int)config_setting_source_line(setting);
}

/* ---- values as a command line has them ---- */

typedef struct {
    char text[VALUE_MAX];
    size_t used;
} value;

static jlt_status append(const reader *r, const config_setting_t *at, value *v, const char *text)
{
    const size_t length = strlen(text);

    if (v->used + length >= sizeof v->text) return complain(r, line_of(at), "value is too long");
    memcpy(v->text + v->used, text, length + 1);
    v->used += length;
    return JLT_OK;
}

/* A double in the fewest digits that give it back. */
static void print_double(char *out, size_t size, double number)
{
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(out, size, "%.*g", digits, number);
        if (strtod(out, NULL) == number) return;
    }
}

static jlt_status append_number(const reader *r, const config_setting_t *at, value *v, const char *name)
{
    char text[64];
    const char *string = text;
    double ignored;

    switch (config_setting_type(at)) {
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64:
        snprintf(text, sizeof text, "%lld", config_setting_get_int64(at));
        break;
    case CONFIG_TYPE_FLOAT:
        print_double(text, sizeof text, config_setting_get_float(at));
        break;
    case CONFIG_TYPE_STRING:
        string = config_setting_get_string(at);
        break;
    default:
        return complain(r, line_of(at), "'%s' takes a number (such as 0.51 or \"1/3\")", name);
    }
    switch (jlt_number_parse(&ignored, string, strlen(string))) {
    case JLT_OK:
        return append(r, at, v, string);
    case JLT_ERR_NONFINITE:
        return complain(r, line_of(at), "'%s' is beyond the range of numbers: %s", name, string);
    default:
        return complain(r, line_of(at), "'%s' is no number: \"%s\"", name, string);
    }
}

static jlt_status append_whole(const reader *r, const config_setting_t *at, value *v, const char *name, long long least)
{
    char text[32];

    if (config_setting_type(at) != CONFIG_TYPE_INT && config_setting_type(at) != CONFIG_TYPE_INT64)
        return complain(r, line_of(at), "'%s' takes a whole number", name);
    if (config_setting_get_int64(at) < least)
        return complain(r, line_of(at), "'%s' must be at least %lld", name, least);
    snprintf(text, sizeof text, "%lld", config_setting_get_int64(at));
    return append(r, at, v, text);
}

static jlt_status append_list(const reader *r, const config_setting_t *at, value *v, const char *name)
{
    jlt_status st = JLT_OK;

    if (config_setting_is_array(at) == CONFIG_FALSE && config_setting_is_list(at) == CONFIG_FALSE)
        return complain(r, line_of(at), "'%s' takes numbers in brackets, [0, 0.5, 1]", name);
    if (config_setting_length(at) == 0) return complain(r, line_of(at), "'%s' is empty", name);
    for (int i = 0; i < config_setting_length(at); i++) {
        if (i > 0) JLT_TRY(append(r, at, v, ","));
        JLT_TRY(append_number(r, config_setting_get_elem(at, (unsigned)i), v, name));
    }
done:
    return st;
}

/* An end of a range: a number, or pi. */
static jlt_status append_end(const reader *r, const config_setting_t *at, value *v, const char *name)
{
    const char *string = config_setting_type(at) == CONFIG_TYPE_STRING ? config_setting_get_string(at) : "";

    if (strcmp(string, "pi") == 0 || strcmp(string, "-pi") == 0) return append(r, at, v, string);
    return append_number(r, at, v, name);
}

/* [first, last, how many] */
static jlt_status append_range(const reader *r, const config_setting_t *at, value *v, const char *name)
{
    jlt_status st = JLT_OK;

    if (config_setting_length(at) != 3)
        return complain(r, line_of(at), "'%s' takes one number or [first, last, how many]", name);
    JLT_TRY(append_end(r, config_setting_get_elem(at, 0), v, name));
    JLT_TRY(append(r, at, v, ":"));
    JLT_TRY(append_end(r, config_setting_get_elem(at, 1), v, name));
    JLT_TRY(append(r, at, v, ":"));
    JLT_TRY(append_whole(r, config_setting_get_elem(at, 2), v, name, 1));
done:
    return st;
}

static jlt_status append_group(const reader *r, const config_setting_t *at, value *v, const char *name, bool ranges)
{
    jlt_status st = JLT_OK;

    if (config_setting_is_group(at) == CONFIG_FALSE)
        return complain(r, line_of(at), "'%s' takes names and numbers in braces, { a = 1; b = 2; }", name);
    for (int i = 0; i < config_setting_length(at); i++) {
        const config_setting_t *member = config_setting_get_elem(at, (unsigned)i);
        const bool several = config_setting_is_array(member) == CONFIG_TRUE || config_setting_is_list(member) == CONFIG_TRUE;
        if (i > 0) JLT_TRY(append(r, member, v, ","));
        JLT_TRY(append(r, member, v, config_setting_name(member)));
        JLT_TRY(append(r, member, v, "="));
        if (ranges && several) JLT_TRY(append_range(r, member, v, config_setting_name(member)));
        else JLT_TRY(append_number(r, member, v, config_setting_name(member)));
    }
done:
    return st;
}

static jlt_status append_kind(const reader *r, const config_setting_t *at, value *v, const jlt_key *key)
{
    switch (key->kind) {
    case JLT_KEY_NUMBER: return append_number(r, at, v, key->key);
    case JLT_KEY_COUNT: return append_whole(r, at, v, key->key, 1);
    case JLT_KEY_SEED: return append_whole(r, at, v, key->key, 0);
    case JLT_KEY_NUMBERS: return append_list(r, at, v, key->key);
    case JLT_KEY_GROUP: return append_group(r, at, v, key->key, false);
    case JLT_KEY_RANGES:
        if (config_setting_type(at) == CONFIG_TYPE_STRING) return append(r, at, v, config_setting_get_string(at));
        return append_group(r, at, v, key->key, true);
    case JLT_KEY_FLAG:
        if (config_setting_type(at) == CONFIG_TYPE_BOOL) return JLT_OK;
        return complain(r, line_of(at), "'%s' takes true or false", key->key);
    case JLT_KEY_TEXT:
        if (config_setting_type(at) == CONFIG_TYPE_STRING) return append(r, at, v, config_setting_get_string(at));
        return complain(r, line_of(at), "'%s' takes a text in quotation marks", key->key);
    }
    return JLT_ERR_ARG;
}

/* ---- jobs ---- */

static jlt_status add_option(jlt_scene_job *job, const char *name, const char *text, int line)
{
    jlt_scene_option *grown = realloc(job->options, (job->count + 1) * sizeof *grown);
    jlt_scene_option *option;

    if (grown == NULL) return JLT_ERR_NOMEM;
    job->options = grown;
    option = &job->options[job->count++];
    *option = (jlt_scene_option){ .name = strdup(name), .value = text != NULL ? strdup(text) : NULL,
                                  .line = (unsigned)line };
    return option->name == NULL || (text != NULL && option->value == NULL) ? JLT_ERR_NOMEM : JLT_OK;
}

static jlt_status take(const reader *r, jlt_scene_job *job, const jlt_key *key, const config_setting_t *setting)
{
    jlt_status st = JLT_OK;
    value v = { .used = 0 };

    JLT_TRY(append_kind(r, setting, &v, key));
    if (key->kind != JLT_KEY_FLAG) JLT_TRY(add_option(job, key->option, v.text, line_of(setting)));
    else if (config_setting_get_bool(setting) == CONFIG_TRUE)
        JLT_TRY(add_option(job, key->option, NULL, line_of(setting)));
done:
    return st;
}

static bool applies(const jlt_schema *schema, const char *accuracy)
{
    for (size_t i = 0; i < sizeof schema->accuracy / sizeof *schema->accuracy && schema->accuracy[i] != NULL; i++)
        if (strcmp(schema->accuracy[i], accuracy) == 0) return true;
    return false;
}

static jlt_status share(const reader *r, jlt_scene_job *job, const jlt_schema *schema, const config_setting_t *root)
{
    static const jlt_key set = { "parameters", "set", JLT_KEY_GROUP }, level = { "levels", "level", JLT_KEY_GROUP };
    jlt_status st = JLT_OK;
    const config_setting_t *parameters = config_setting_get_member(root, "parameters");
    const config_setting_t *levels = config_setting_get_member(root, "levels");
    const config_setting_t *accuracy = config_setting_get_member(root, "accuracy");

    if (schema->parameters && parameters != NULL) JLT_TRY(take(r, job, &set, parameters));
    if (schema->levels && levels != NULL) JLT_TRY(take(r, job, &level, levels));
    for (int i = 0; accuracy != NULL && i < config_setting_length(accuracy); i++) {
        const config_setting_t *member = config_setting_get_elem(accuracy, (unsigned)i);
        const char *name = config_setting_name(member);
        if (applies(schema, name)) JLT_TRY(take(r, job, jlt_schema_accuracy(name), member));
    }
done:
    return st;
}

static jlt_status read_job(const reader *r, jlt_scene_job *job, const config_setting_t *entry,
                           const config_setting_t *root)
{
    jlt_status st = JLT_OK;
    const char *what = NULL, *model = NULL;
    const jlt_schema *schema;
    char names[NAMES_MAX];

    job->line = (unsigned)line_of(entry);
    if (config_setting_is_group(entry) == CONFIG_FALSE)
        return complain(r, line_of(entry), "an entry of 'compute' is a group in braces");
    if (config_setting_lookup_string(entry, "what", &what) == CONFIG_FALSE)
        return complain(r, line_of(entry), "an entry of 'compute' needs what = \"COMMAND\"");
    schema = jlt_schema_find(what);
    if (schema == NULL) {
        jlt_schema_names(names, sizeof names);
        return complain(r, line_of(config_setting_get_member(entry, "what")), "unknown command \"%s\" (expected one of %s)",
                        what, names);
    }
    job->what = strdup(what);
    if (job->what == NULL) return JLT_ERR_NOMEM;
    if (schema->model && config_setting_lookup_string(root, "model", &model) == CONFIG_TRUE) {
        job->model = strdup(model);
        if (job->model == NULL) return JLT_ERR_NOMEM;
    }
    JLT_TRY(share(r, job, schema, root));
    for (int i = 0; i < config_setting_length(entry); i++) {
        const config_setting_t *member = config_setting_get_elem(entry, (unsigned)i);
        const char *name = config_setting_name(member);
        const jlt_key *key = jlt_schema_key(schema, name);
        if (strcmp(name, "what") == 0) continue;
        if (key == NULL) {
            jlt_schema_key_names(names, sizeof names, schema);
            return complain(r, line_of(member), "unknown key '%s' for %s (it knows %s)", name, what, names);
        }
        if (jlt_scene_value(job, key->option) != NULL)
            return complain(r, line_of(member), "'%s' is already given for the whole scene", name);
        JLT_TRY(take(r, job, key, member));
    }
done:
    return st;
}

/* The keys of the whole file, before its jobs. */
static jlt_status check_root(const reader *r, const config_setting_t *root)
{
    static const char *const known[] = { "title", "model", "parameters", "levels", "accuracy", "compute" };
    const config_setting_t *accuracy = config_setting_get_member(root, "accuracy");

    for (int i = 0; i < config_setting_length(root); i++) {
        const config_setting_t *member = config_setting_get_elem(root, (unsigned)i);
        const char *name = config_setting_name(member);
        size_t k = 0;
        while (k < sizeof known / sizeof *known && strcmp(known[k], name) != 0) k++;
        if (k == sizeof known / sizeof *known)
            return complain(r, line_of(member),
                            "unknown key '%s' (a scene knows title, model, parameters, levels, accuracy, compute)", name);
        if (k < 2 && config_setting_type(member) != CONFIG_TYPE_STRING)
            return complain(r, line_of(member), "'%s' takes a text in quotation marks", name);
        if (k >= 2 && k < 5 && config_setting_is_group(member) == CONFIG_FALSE)
            return complain(r, line_of(member), "'%s' takes a group in braces", name);
        if (k == 5 && config_setting_is_list(member) == CONFIG_FALSE)
            return complain(r, line_of(member), "'compute' takes a list in parentheses, ( { what = ...; }, ... )");
    }
    for (int i = 0; accuracy != NULL && i < config_setting_length(accuracy); i++) {
        const config_setting_t *member = config_setting_get_elem(accuracy, (unsigned)i);
        if (jlt_schema_accuracy(config_setting_name(member)) == NULL)
            return complain(r, line_of(member), "unknown key '%s' in 'accuracy' (it knows tolerance, method, tier)",
                            config_setting_name(member));
    }
    if (config_setting_get_member(root, "compute") == NULL) return complain(r, 0, "nothing to do: no 'compute'");
    return JLT_OK;
}

static jlt_status read_all(const reader *r, jlt_scene *scene, const config_setting_t *root)
{
    jlt_status st = JLT_OK;
    const config_setting_t *compute;
    const char *title = "";
    int count;

    JLT_TRY(check_root(r, root));
    compute = config_setting_get_member(root, "compute");
    count = config_setting_length(compute);
    if (count == 0) return complain(r, line_of(compute), "'compute' is empty");
    (void)config_setting_lookup_string(root, "title", &title);
    scene->file = strdup(r->file);
    scene->title = strdup(title);
    scene->jobs = calloc((size_t)count, sizeof *scene->jobs);
    if (scene->file == NULL || scene->title == NULL || scene->jobs == NULL) return JLT_ERR_NOMEM;
    for (int i = 0; i < count; i++) {
        scene->count++;
        JLT_TRY(read_job(r, &scene->jobs[i], config_setting_get_elem(compute, (unsigned)i), root));
    }
done:
    return st;
}

jlt_status jlt_scene_read(jlt_scene **out, char *message, const char *path)
{
    jlt_status st = JLT_OK;
    const reader r = { path, message };
    jlt_scene *scene = NULL;
    config_t config;
    FILE *file = NULL;

    *out = NULL;
    *message = '\0';
    config_init(&config);
    file = fopen(path, "r");
    if (file == NULL) {
        (void)complain(&r, 0, "%s", strerror(errno));
        st = JLT_ERR_IO;
        goto done;
    }
    if (config_read(&config, file) == CONFIG_FALSE) {
        st = complain(&r, config_error_line(&config), "%s", config_error_text(&config));
        goto done;
    }
    scene = calloc(1, sizeof *scene);
    if (scene == NULL) st = JLT_ERR_NOMEM;
    else st = read_all(&r, scene, config_root_setting(&config));
    if (st == JLT_ERR_NOMEM) (void)complain(&r, 0, "out of memory");
    if (st != JLT_OK) goto done;
    *out = scene;
    scene = NULL;
done:
    jlt_scene_destroy(scene);
    if (file != NULL) fclose(file);
    config_destroy(&config);
    return st;
}

void jlt_scene_destroy(jlt_scene *scene)
{
    if (scene == NULL) return;
    for (size_t j = 0; j < scene->count; j++) {
        jlt_scene_job *job = &scene->jobs[j];
        for (size_t i = 0; i < job->count; i++) {
            free(job->options[i].name);
            free(job->options[i].value);
        }
        free(job->options);
        free(job->what);
        free(job->model);
    }
    free(scene->jobs);
    free(scene->file);
    free(scene->title);
    free(scene);
}

const char *jlt_scene_value(const jlt_scene_job *job, const char *name)
{
    for (size_t i = 0; i < job->count; i++)
        if (strcmp(job->options[i].name, name) == 0) return job->options[i].value;
    return NULL;
}
