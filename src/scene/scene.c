#include "scene/scene.h"

#include <stdlib.h>
#include <string.h>

#include "core/memory.h"
#include "kernel/descriptor.h"
#include "scene/source.h"
#include "top/top.h"

enum { NAMES_MAX = 512 };

static jlt_status add_option(jlt_scene_job *job, const jlt_key *key, const char *text, int line)
{
    if (!JLT_MEMORY_GROW(job->options, job->count)) return JLT_ERR_NOMEM;
    jlt_scene_option *option = &job->options[job->count++];
    *option = (jlt_scene_option){ .name = strdup(key->option), .value = text != NULL ? strdup(text) : NULL,
                                  .line = (unsigned)line, .is_file = key->kind == JLT_KEY_FILE };
    return option->name == NULL || (text != NULL && option->value == NULL) ? JLT_ERR_NOMEM : JLT_OK;
}

static jlt_status take(const jlt_value_reader *r, jlt_scene_job *job, const jlt_key *key, const config_setting_t *setting)
{
    jlt_value v = { .used = 0 };

    JLT_PASS(jlt_value_read(r, setting, &v, key));
    if (key->kind != JLT_KEY_FLAG) JLT_PASS(add_option(job, key, v.text, jlt_value_line(setting)));
    else if (config_setting_get_bool(setting) == CONFIG_TRUE)
        JLT_PASS(add_option(job, key, NULL, jlt_value_line(setting)));
    return JLT_OK;
}

/* Take a setting of the whole scene, if it is given and the command has such an option. */
static jlt_status take_shared(const jlt_value_reader *r, jlt_scene_job *job, const char *name, const config_setting_t *setting)
{
    jlt_key key;

    return setting != NULL && jlt_schema_key(&key, job->known, name) ? take(r, job, &key, setting) : JLT_OK;
}

/* Take the settings of the whole scene into a job. Its levels are not taken for a plane section without `solve`, nor for a job with
 * levels of its own. */
static jlt_status share(const jlt_value_reader *r, jlt_scene_job *job, const config_setting_t *entry,
                        const config_setting_t *root)
{
    const config_setting_t *accuracy = config_setting_get_member(root, "accuracy");
    const bool on_levels = (r->section == NULL || r->solve != NULL) && config_setting_get_member(entry, "levels") == NULL;

    JLT_PASS(take_shared(r, job, "parameters", config_setting_get_member(root, "parameters")));
    if (on_levels) JLT_PASS(take_shared(r, job, "levels", config_setting_get_member(root, "levels")));
    for (int i = 0; accuracy != NULL && i < config_setting_length(accuracy); i++) {
        const config_setting_t *member = config_setting_get_elem(accuracy, (unsigned)i);
        JLT_PASS(take_shared(r, job, config_setting_name(member), member));
    }
    return JLT_OK;
}

static jlt_status read_what(const jlt_value_reader *r, jlt_scene_job *job, const config_setting_t *entry)
{
    const config_setting_t *what = config_setting_get_member(entry, "what");
    const char *sought = what != NULL ? config_setting_get_string(what) : NULL, *command;
    char names[NAMES_MAX] = "";

    if (sought == NULL) return jlt_value_complain(r, jlt_value_line(entry), "an entry of 'compute' needs what = \"COMMAND\"");
    for (size_t i = 0; (command = r->program->command(&job->known, i)) != NULL; i++) {
        if (strcmp(command, sought) == 0) return (job->what = strdup(sought)) != NULL ? JLT_OK : JLT_ERR_NOMEM;
        jlt_schema_add_name(names, sizeof names, command);
    }
    return jlt_value_complain(r, jlt_value_line(what), "unknown command \"%s\" (expected one of %s)", sought, names);
}

static jlt_status read_job(jlt_value_reader *r, jlt_scene_job *job, const config_setting_t *entry,
                           const config_setting_t *root)
{
    const char *model = NULL;
    char names[NAMES_MAX] = "what";
    jlt_key key;

    job->line = (unsigned)jlt_value_line(entry);
    if (config_setting_is_group(entry) == CONFIG_FALSE)
        return jlt_value_complain(r, jlt_value_line(entry), "an entry of 'compute' is a group in braces");
    JLT_PASS(read_what(r, job, entry));
    if (config_setting_lookup_string(root, "model", &model) == CONFIG_TRUE && (job->model = strdup(model)) == NULL)
        return JLT_ERR_NOMEM;
    r->section = config_setting_get_member(entry, "section");
    r->named = r->section != NULL ? config_setting_get_string(r->section) : NULL;
    if (r->named != NULL) r->section = NULL;
    r->solve = config_setting_get_member(entry, "solve");
    if (r->section != NULL && jlt_schema_key(&key, job->known, "section")
        && (config_setting_is_group(r->section) == CONFIG_FALSE || config_setting_length(r->section) != 1))
        return jlt_value_complain(r, jlt_value_line(r->section),
                                  "'section' takes one state and its value, { z = 27; }, or a name in quotation marks");
    JLT_PASS(share(r, job, entry, root));
    for (int i = 0; i < config_setting_length(entry); i++) {
        const config_setting_t *member = config_setting_get_elem(entry, (unsigned)i);
        const char *name = config_setting_name(member);
        if (strcmp(name, "what") == 0) continue;
        if (!jlt_schema_key(&key, job->known, name)) {
            jlt_schema_key_names(names, sizeof names, job->known);
            return jlt_value_complain(r, jlt_value_line(member), "unknown key '%s' for %s (it knows %s)", name, job->what, names);
        }
        if (jlt_scene_value(job, key.option) != NULL)
            return jlt_value_complain(r, jlt_value_line(member), "'%s' is already given for the whole scene", name);
        JLT_PASS(take(r, job, &key, member));
    }
    return JLT_OK;
}

static jlt_status check_root(const jlt_value_reader *r, const config_setting_t *root)
{
    static const char *const known[] = { "title", "model", "parameters", "levels", "accuracy", "compute", "over", "piece" };
    const config_setting_t *accuracy = config_setting_get_member(root, "accuracy");

    for (int i = 0; i < config_setting_length(root); i++) {
        const config_setting_t *member = config_setting_get_elem(root, (unsigned)i);
        const char *name = config_setting_name(member);
        size_t k = 0;
        while (k < sizeof known / sizeof *known && strcmp(known[k], name) != 0) k++;
        if (k == sizeof known / sizeof *known)
            return jlt_value_complain(r, jlt_value_line(member),
                            "unknown key '%s' (a scene knows title, model, parameters, levels, accuracy, compute, over, "
                            "piece)", name);
        if (k < 2 && config_setting_type(member) != CONFIG_TYPE_STRING)
            return jlt_value_complain(r, jlt_value_line(member), "'%s' takes a text in quotation marks", name);
        if (((k >= 2 && k < 5) || k == 6) && config_setting_is_group(member) == CONFIG_FALSE)
            return jlt_value_complain(r, jlt_value_line(member), "'%s' takes a group in braces", name);
        if (k == 5 && config_setting_is_list(member) == CONFIG_FALSE)
            return jlt_value_complain(r, jlt_value_line(member), "'compute' takes a list in parentheses, ( { what = ...; }, ... )");
    }
    for (int i = 0; accuracy != NULL && i < config_setting_length(accuracy); i++) {
        const config_setting_t *member = config_setting_get_elem(accuracy, (unsigned)i);
        const char *name = config_setting_name(member);
        if (strcmp(name, "tolerance") != 0 && strcmp(name, "method") != 0 && strcmp(name, "tier") != 0)
            return jlt_value_complain(r, jlt_value_line(member),
                                      "unknown key '%s' in 'accuracy' (it knows tolerance, method, tier)", name);
    }
    if (config_setting_get_member(root, "compute") == NULL) return jlt_value_complain(r, 0, "nothing to do: no 'compute'");
    return JLT_OK;
}

static jlt_status read_study(const jlt_value_reader *r, jlt_scene *scene, const config_setting_t *root)
{
    static const jlt_key ranges = { "over", "over", JLT_KEY_RANGES, JLT_NAMES_PARAMS | JLT_NAMES_LEVELS, NULL };
    static const jlt_key count = { "piece", "piece", JLT_KEY_COUNT, JLT_NAMES_ANY, NULL };
    const config_setting_t *over = config_setting_get_member(root, ranges.key), *piece = config_setting_get_member(root, count.key);
    jlt_value v = { .used = 0 };

    if (piece != NULL) {
        JLT_PASS(jlt_value_read(r, piece, &v, &count));
        scene->piece = (size_t)config_setting_get_int64(piece);
    }
    if (over == NULL) return JLT_OK;
    v.used = 0;
    JLT_PASS(jlt_value_read(r, over, &v, &ranges));
    scene->over_line = (unsigned)jlt_value_line(over);
    scene->over = strdup(v.text);
    return scene->over != NULL ? JLT_OK : JLT_ERR_NOMEM;
}

static jlt_status read_all(jlt_value_reader *r, jlt_scene *scene, const config_setting_t *root)
{
    const config_setting_t *compute;
    const char *title = "", *model = JLT_DEFAULT_MODEL;
    int count;

    JLT_PASS(check_root(r, root));
    compute = config_setting_get_member(root, "compute");
    count = config_setting_length(compute);
    if (count == 0) return jlt_value_complain(r, jlt_value_line(compute), "'compute' is empty");
    (void)config_setting_lookup_string(root, "title", &title);
    (void)config_setting_lookup_string(root, "model", &model);
    const jlt_status st = r->program->open(&r->model, &r->others, model);
    if (st == JLT_ERR_EMPTY)
        return jlt_value_complain(r, jlt_value_line(config_setting_get_member(root, "model")),
                        "there is no model '%s' ('jellett models' lists those that are built in)", model);
    JLT_PASS(st);
    scene->model = r->model;
    scene->file = strdup(r->file);
    scene->title = strdup(title);
    JLT_PASS(read_study(r, scene, root));
    scene->jobs = calloc((size_t)count, sizeof *scene->jobs);
    if (scene->file == NULL || scene->title == NULL || scene->jobs == NULL) return JLT_ERR_NOMEM;
    for (int i = 0; i < count; i++) {
        scene->count++;
        JLT_PASS(read_job(r, &scene->jobs[i], config_setting_get_elem(compute, (unsigned)i), root));
    }
    return JLT_OK;
}

jlt_status jlt_scene_read(jlt_scene **out, char *message, const char *path, const jlt_scene_program *program)
{
    jlt_status st = JLT_OK;
    jlt_value_reader r = { .file = path, .message = message, .program = program };
    jlt_scene *scene = NULL;
    config_t config;
    JLT_FREED char *text = NULL;

    *out = NULL;
    *message = '\0';
    config_init(&config);
    JLT_TRY(jlt_source_read(&text, &r));
    if (config_read_string(&config, text) == CONFIG_FALSE) {
        st = jlt_value_complain(&r, config_error_line(&config), "%s (expected NAME = VALUE; each name once, texts in quotation "
                                "marks, every bracket closed)", config_error_text(&config));
        goto done;
    }
    scene = calloc(1, sizeof *scene);
    if (scene == NULL) st = JLT_ERR_NOMEM;
    else st = read_all(&r, scene, config_root_setting(&config));
    if (st != JLT_OK) goto done;
    *out = scene;
    scene = NULL;
done:
    if (st == JLT_ERR_NOMEM) (void)jlt_value_complain(&r, 0, "out of memory");
    jlt_scene_destroy(scene);
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
    free(scene->over);
    free(scene);
}

/* NAME=VALUE,... with this name's item replaced, or added at the end; for the caller to free(). */
static char *replaced(const char *list, const char *name, const char *value)
{
    const size_t length = strlen(name);
    char *text = malloc(strlen(list) + length + strlen(value) + 3);
    size_t used = 0;

    if (text == NULL) return NULL;
    while (*list != '\0') {
        const size_t item = strcspn(list, ",");
        if (strncmp(list, name, length) != 0 || list[length] != '=') {
            memcpy(text + used, list, item);
            text[used + item] = ',';
            used += item + 1;
        }
        list += item + (list[item] == ',');
    }
    sprintf(text + used, "%s=%s", name, value);
    return text;
}

jlt_status jlt_scene_set(jlt_scene *scene, const char *name, const char *value)
{
    jlt_status st = JLT_ERR_ARG;
    size_t index;
    jlt_key key;

    if (!jlt_descriptor_param(scene->model, name, &index)) return JLT_ERR_ARG;
    for (size_t j = 0; j < scene->count; j++) {
        jlt_scene_job *job = &scene->jobs[j];
        size_t i = 0;
        if (!jlt_schema_key(&key, job->known, "parameters")) continue;
        while (i < job->count && strcmp(job->options[i].name, key.option) != 0) i++;
        if (i == job->count) JLT_PASS(add_option(job, &key, "", (int)job->line));
        char *text = replaced(job->options[i].value, name, value);
        if (text == NULL) return JLT_ERR_NOMEM;
        free(job->options[i].value);
        job->options[i].value = text;
        st = JLT_OK;
    }
    return st;
}

const char *jlt_scene_value(const jlt_scene_job *job, const char *name)
{
    for (size_t i = 0; i < job->count; i++)
        if (strcmp(job->options[i].name, name) == 0) return job->options[i].value;
    return NULL;
}
