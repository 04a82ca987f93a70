#include "cli/study.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/table.h"
#include "core/memory.h"
#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "report/json.h"
#include "scene/schema.h"

/* The commands of which a study can be made: what they write for a point does not depend on other points. `dealt` is the option
 * whose grid is cut into pieces; NULL: the command is run whole at each point of `over`. `least`: the default number of points in a
 * piece, to be worth a start of the command. The first entry applies whose option the scene gives. */
static const struct {
    const char *command, *dealt;
    size_t least;
} kinds[] = {
    { "section", "grid", 2048 },  { "fates", "sweep", 1 },   { "fates", "grid", 2048 },    { "fates", NULL, 1 },
    { "lyapunov", "grid", 2048 }, { "lyapunov", NULL, 1 },   { "eigen", "sweep", 256 },    { "rod", "sweep", 256 },
    { "orbits", NULL, 1 },        { "continue", NULL, 1 },   { "separation", NULL, 1 },    { "drift", NULL, 1 },
    { "manifolds", NULL, 1 },     { "simulate", NULL, 1 },
};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* The default number of pieces, if the grid is large enough: many more than ranks, so that points of uneven cost balance out. */
enum { PIECES_WANTED = 4096 };

__attribute__((format(printf, 3, 4)))
static jlt_exit refuse(const jlt_study *self, unsigned line, const char *format, ...)
{
    char text[JLT_SCENE_MESSAGE_MAX];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return jlt_command_fail(JLT_EXIT_INPUT, "%s:%u: error: %s", self->scene->file, line, text);
}

/* Find the option whose grid is cut into pieces, and how many of its points are worth a start of the command. */
static jlt_exit find_dealt(jlt_study *self, size_t *least)
{
    const jlt_scene_job *job = self->job;
    char names[256];
    size_t used = 0;
    bool is_known = false;

    self->dealt = job->count;
    for (size_t i = 0; i < KINDS; i++) {
        if (strcmp(kinds[i].command, job->what) != 0) continue;
        is_known = true;
        *least = kinds[i].least;
        if (kinds[i].dealt == NULL) return JLT_EXIT_DONE;
        for (size_t k = 0; k < job->count; k++)
            if (strcmp(job->options[k].name, kinds[i].dealt) == 0) self->dealt = k;
        if (self->dealt < job->count) return JLT_EXIT_DONE;
    }
    for (size_t i = 0; !is_known && i < KINDS; i++)
        if (i == 0 || strcmp(kinds[i].command, kinds[i - 1].command) != 0)
            used += (size_t)snprintf(names + used, sizeof names - used, "%s%s", i == 0 ? "" : ", ", kinds[i].command);
    if (!is_known) return refuse(self, job->line, "%s cannot be a study; these can: %s", job->what, names);
    for (size_t i = 0; i < KINDS; i++)
        if (strcmp(kinds[i].command, job->what) == 0)
            return refuse(self, job->line, "add '%s': a study of %s is cut into pieces along it", kinds[i].dealt, job->what);
    return JLT_EXIT_DONE;
}

/* Refuse options that make sense for one run of the command but not for its pieces. */
static jlt_exit check_options(const jlt_study *self)
{
    const jlt_scene_job *job = self->job;

    for (size_t k = 0; k < job->count; k++) {
        const jlt_scene_option *option = &job->options[k];
        if (option->is_file) return refuse(self, option->line, "a study's rows go to its folder: leave out '%s'", option->name);
        if (strcmp(option->name, "json") == 0) return refuse(self, option->line, "a study's rows are tables: leave out 'json'");
        if (strcmp(option->name, "start") == 0 && self->dealt < job->count && strcmp(job->options[self->dealt].name, "grid") == 0)
            return refuse(self, option->line, "every piece of the grid would begin with this 'start': leave it out");
        /* each piece of the grid would run over all of it, and its rows begin with other columns than those of the grid */
        if (strcmp(option->name, "sweep") == 0 && self->dealt < job->count && self->dealt != k)
            return refuse(self, option->line, "a study with a grid of starts runs over parameters and levels by 'over', not by "
                                              "'sweep': write them there");
    }
    return JLT_EXIT_DONE;
}

/* Check that the command has the parameters and levels that run, and that these have no value elsewhere: in the scene, or in --set
 * of the command line, `set`. */
static jlt_exit check_over(const jlt_study *self, const jlt_assign_list *set)
{
    const jlt_scene *scene = self->scene;
    const jlt_scene_job *job = self->job;
    jlt_key levels;

    for (size_t i = 0; i < set->count; i++)
        if (jlt_assign_names(scene->over, set->items[i].name)
            || (self->dealt < job->count && jlt_assign_names(job->options[self->dealt].value, set->items[i].name)))
            return jlt_command_fail(JLT_EXIT_USAGE, "--set: %s runs over %s by itself: leave it out, or take it from there",
                                    scene->file, set->items[i].name);
    for (size_t i = 0; i < self->over_count; i++) {
        if (!jlt_descriptor_param(scene->model, self->over[i].name, &(size_t){ 0 })
            && !jlt_schema_key(&levels, job->known, "levels"))
            return refuse(self, scene->over_line, "'over' runs over %s, and %s takes no levels, parameters alone",
                          self->over[i].name, job->what);
        for (size_t k = 0; k < job->count; k++) {
            const jlt_scene_option *option = &job->options[k];
            const bool gives = k == self->dealt || strcmp(option->name, "set") == 0 || strcmp(option->name, "level") == 0;
            if (gives && jlt_assign_names(option->value, self->over[i].name))
                return refuse(self, scene->over_line, "'over' runs over %s, which the scene also sets or sweeps elsewhere: remove "
                              "one of the two", self->over[i].name);
        }
    }
    return JLT_EXIT_DONE;
}

/* Count the points of the grid that is cut into pieces. */
static jlt_exit count_inner(jlt_study *self)
{
    jlt_grid_axis axes[JLT_STUDY_OVER_MAX] = { 0 };
    const jlt_scene_option *option = &self->job->options[self->dealt];
    size_t count;
    jlt_exit code;

    self->inner = 1;
    if (self->dealt == self->job->count) return JLT_EXIT_DONE;
    if (strchr(option->value, '@') != NULL)
        return refuse(self, option->line, "'%s' is a part of a grid, and a study is dealt out by itself: leave out '%s'",
                      option->name, strchr(option->value, '@'));
    code = jlt_grid_read(axes, &count, JLT_STUDY_OVER_MAX, option->value, option->name);
    return code == JLT_EXIT_DONE ? jlt_grid_size(&self->inner, axes, count, option->value, option->name) : code;
}

static jlt_exit count_pieces(jlt_study *self, size_t least)
{
    const jlt_scene *scene = self->scene;
    size_t all;

    if (scene->over != NULL) JLT_PASS(jlt_grid_parse(self->over, &self->over_count, JLT_STUDY_OVER_MAX, scene->over, "over"));
    JLT_PASS(jlt_grid_size(&self->outer, self->over, self->over_count, scene->over, "over"));
    JLT_PASS(count_inner(self));
    if (__builtin_mul_overflow(self->outer, self->inner, &all))
        return refuse(self, self->job->line, "there are more points than can be counted");
    self->piece = scene->piece > 0 ? scene->piece : (all - 1) / PIECES_WANTED + 1;
    if (scene->piece == 0 && self->piece < least) self->piece = least;
    if (self->piece > self->inner) self->piece = self->inner;
    self->pieces = self->outer * ((self->inner - 1) / self->piece + 1);
    return JLT_EXIT_DONE;
}

/* The tables that records lead to from the model, and from there, with the digests of which the records were proved and the
 * compiler that made their kernels; a table of coordinates has none. */
static json_t *kernels_of(const jlt_descriptor *model, const jlt_way_tables *others)
{
    const jlt_descriptor *reached[JLT_WAY_TABLES_MAX] = { model };
    json_t *kernels = json_object();
    unsigned count = 1;

    (void)json_object_set_new(kernels, model->model, json_sprintf("table %s, %s", model->sha256, model->generator));
    for (unsigned done = 0; done < count; done++)
        for (const jlt_claim *claim = reached[done]->claims; claim->kind != NULL; claim++) {
            const bool leads = claim->target != NULL && strcmp(claim->kind, "embedding") != 0;
            if (!leads || json_object_get(kernels, claim->file) != NULL) continue;
            const jlt_descriptor *next = jlt_way_target(&(jlt_way){ .sha256 = claim->target }, others);
            (void)json_object_set_new(kernels, claim->file,
                                      next == NULL ? json_sprintf("table %s", claim->target)
                                                   : json_sprintf("table %s, %s", claim->target, next->generator));
            if (next != NULL && count < JLT_WAY_TABLES_MAX) reached[count++] = next;
        }
    return kernels;
}

/* Kernels with four and with eight lanes do the same operations; those with two have no fused multiply-add. Those for one orbit
 * have it where the compiler was told to count on it. */
static const char *arithmetic(void)
{
#ifdef FP_FAST_FMA
    return jlt_batch_isa_lanes() > 2 ? "fused, single orbits too" : "plain, single orbits fused";
#else
    return jlt_batch_isa_lanes() > 2 ? "fused" : "plain";
#endif
}

static jlt_exit make_manifest(jlt_study *self)
{
    const jlt_scene_job *job = self->job;
    const jlt_descriptor *model = self->scene->model;
    const char *name = job->model != NULL ? job->model : model->model;
    jlt_way_tables others;
    JLT_FREED char *typed = jlt_command_line(2, (char *[]){ job->what, (char *)name }); /* a file's name may be no text */
    json_t *options, *whole;

    if (typed == NULL) return jlt_command_no_memory();
    JLT_PASS(jlt_table_others(&others, model, name, "reduction", false));
    options = json_object();
    for (size_t k = 0; k < job->count; k++)
        (void)json_object_set_new(options, job->options[k].name,
                                  job->options[k].value != NULL ? json_string(job->options[k].value) : json_true());
    whole = json_pack("{s:i, s:s, s:s, s:o, s:s?, s:I, s:I, s:I, s:s, s:o, s:s}", "format", 1, "command", job->what, "model",
                      typed + strlen(job->what) + 1, "options", options, "over", self->scene->over, "points",
                      (json_int_t)(self->outer * self->inner), "piece", (json_int_t)self->piece, "pieces",
                      (json_int_t)self->pieces, "version", JLT_VERSION, "kernels", kernels_of(model, &others), "arithmetic",
                      arithmetic());
    self->manifest = whole != NULL ? json_dumps(whole, JSON_COMPACT) : NULL;
    json_decref(whole);
    return self->manifest != NULL ? JLT_EXIT_DONE : jlt_command_no_memory();
}

jlt_exit jlt_study_open(jlt_study *out, const char *path, const jlt_assign_list *set)
{
    *out = (jlt_study){ .outer = 1 };
    JLT_PASS(jlt_job_open(&out->scene, path));
    return jlt_study_make(out, out->scene, set);
}

jlt_exit jlt_study_make(jlt_study *out, jlt_scene *scene, const jlt_assign_list *set)
{
    size_t least = 1;

    *out = (jlt_study){ .scene = scene, .outer = 1 };
    JLT_PASS(jlt_job_set(out->scene, set));
    out->job = &out->scene->jobs[0];
    out->command = jlt_command_find(out->job->what);
    if (out->scene->count != 1)
        return refuse(out, out->scene->jobs[1].line, "a study is of one command: this is a second entry of 'compute'");
    JLT_PASS(find_dealt(out, &least));
    JLT_PASS(check_options(out));
    JLT_PASS(count_pieces(out, least));
    JLT_PASS(check_over(out, set));
    return make_manifest(out);
}

void jlt_study_clear(jlt_study *self)
{
    jlt_scene_destroy(self->scene);
    free(self->manifest);
    *self = (jlt_study){ .scene = NULL };
}

/* The points of a piece: *outer, its point of `over`; *first and *count, its part of the command's grid. */
static void points_of(size_t *outer, size_t *first, size_t *count, const jlt_study *self, size_t piece)
{
    const size_t each = self->pieces / self->outer;

    *outer = piece / each;
    *first = piece % each * self->piece;
    *count = self->inner - *first < self->piece ? self->inner - *first : self->piece;
}

bool jlt_study_give(char ***argv, int *argc, const jlt_grid_axis *over, size_t count, size_t point, const jlt_descriptor *model)
{
    char **grown = realloc(*argv, ((size_t)*argc + 3) * sizeof *grown);

    if (grown == NULL) return false;
    *argv = grown;
    for (int params = 1; params >= 0; params--) {
        char *text = jlt_grid_assignments(params != 0 ? "--set" : "--level", over, count, point, model, params != 0);
        if (text == NULL) return false;
        if (text[0] != '\0') grown[(*argc)++] = text;
        else free(text);
    }
    grown[*argc] = NULL;
    return true;
}

char **jlt_study_arguments(const jlt_study *self, size_t piece, int *argc)
{
    size_t outer, first, count;
    int used = 0;
    char **argv = jlt_job_arguments(self->job, NULL, &used);

    points_of(&outer, &first, &count, self, piece);
    bool whole = argv != NULL && jlt_study_give(&argv, &used, self->over, self->over_count, outer, self->scene->model);
    if (whole && self->dealt < self->job->count) {
        char **option = &argv[(self->job->model != NULL ? 2 : 1) + self->dealt], *part = NULL;
        whole = asprintf(&part, "%s@%zu:%zu", *option, first, count) > 0;
        if (whole) {
            free(*option);
            *option = part;
        }
    }
    *argc = used;
    if (whole) return argv;
    jlt_command_free(argv, used);
    return NULL;
}

void jlt_study_place(char *place, const jlt_study *self, size_t piece)
{
    size_t outer, first, count;

    points_of(&outer, &first, &count, self, piece);
    const size_t used = jlt_grid_place(place, self->over, self->over_count, outer);
    if (self->dealt < self->job->count && used < JLT_GRID_PLACE_MAX)
        snprintf(place + used, JLT_GRID_PLACE_MAX - used, "%spoints %zu to %zu of the %s", used > 0 ? ", " : "", first,
                 first + count - 1,
                 self->job->options[self->dealt].name);
}
