/* `jellett run`: runs the commands of a scene. */
#include <errno.h>
#include <stdbool.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/options.h"
#include "cli/common.h"
#include "cli/interrupt.h"
#include "cli/job.h"
#include "cli/table.h"
#include "core/memory.h"
#include "report/file.h"
#include "scene/scene.h"

typedef struct {
    const char *scene, *into;
    jlt_assign_list set;
    bool dry;
} options;

enum { DRY = 1000 };

static const struct argp_option option_table[] = {
    { "into", 'C', "FOLDER", 0, "Write the scene's files to FOLDER, which is made if need be; default the current folder", 0 },
    { "set", 's', "PARAM=VALUE,...", TTC_OPTIONS_REPEATED,
      "Values of parameters in place of the scene's, in all of its commands", 0 },
    { "dry-run", DRY, NULL, 0, "Show the commands, but run none", 0 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case 'C': o->into = value; return 0;
    case 's': jlt_common_list(&o->set, value, "--set"); return 0;
    case DRY: o->dry = true; return 0;
    case ARGP_KEY_ARG:
        if (o->scene != NULL) argp_error(state, "one scene at a time: '%s' is too many", value);
        o->scene = value;
        return 0;
    case ARGP_KEY_NO_ARGS: argp_error(state, "which scene?"); return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "SCENE",
    "Run the commands of a scene file one after the other, each with the scene's parameters and accuracy."
    "\vA scene is a text of this form (tools/scenes has more):\n\n"
    "  title = \"Poincare map of (5.1)\";\n"
    "  parameters = { a3 = 0.51; I1 = \"1/3\"; I3 = \"1/3\"; };\n"
    "  levels = { E = 2.15; G = -0.56; };\n"
    "  accuracy = { tolerance = 1e-12; };\n"
    "  compute = ( { what = \"section\"; grid = \"24x16\"; returns = 300;\n"
    "                output = \"map.csv\"; plot = \"map.svg\"; } );\n\n"
    "The keys of an entry are the options of its command; in place of --set, --level and --tol they are parameters, levels and "
    "tolerance. What stands above the entries holds for all of them. A key that is unknown, or a value of the wrong kind, is an "
    "error with its line (status 3), before anything is run. The first command that fails ends the run, with its status.",
    NULL, NULL, NULL,
};

static void show(const char *name, char **argv, int argc)
{
    JLT_FREED char *line = jlt_command_line(argc, argv);

    if (line != NULL) printf("jellett %s%s\n", name, line + strlen(argv[0]));
}

static bool is_one_file(const char *path, const char *other)
{
    return !jlt_command_is_standard_output(path) && !jlt_command_is_standard_output(other) && jlt_file_same(path, other);
}

/* Check, before anything is run, that no output file of a job is the scene itself, at scene_path, or the file of another option. */
static jlt_exit check_files(const jlt_scene *scene, const char *scene_path)
{
    for (size_t k = 0; k < scene->count; k++)
        for (size_t i = 0; i < scene->jobs[k].count; i++) {
            const jlt_scene_option *option = &scene->jobs[k].options[i];
            if (!option->is_file) continue;
            if (is_one_file(scene_path, option->value))
                return jlt_command_fail(JLT_EXIT_INPUT, "%s:%u: error: '%s' is the scene itself: %s", scene->file, option->line,
                                        option->name, option->value);
            for (size_t m = 0; m <= k; m++)
                for (size_t n = 0; n < (m == k ? i : scene->jobs[m].count); n++) {
                    const jlt_scene_option *before = &scene->jobs[m].options[n];
                    if (before->is_file && is_one_file(before->value, option->value))
                        return jlt_command_fail(JLT_EXIT_INPUT, "%s:%u: error: '%s' is the file of '%s' in line %u as well: %s",
                                                scene->file, option->line, option->name, before->name, before->line,
                                                option->value);
                }
        }
    return JLT_EXIT_DONE;
}

/* Make the paths of the user's own tables absolute, so that they still hold when jobs run in another folder. */
static jlt_exit fix_tables(jlt_scene *scene)
{
    for (size_t k = 0; k < scene->count; k++) {
        jlt_scene_job *job = &scene->jobs[k];
        if (job->model == NULL || !jlt_table_is_file(job->model)) continue;
        char *whole = realpath(job->model, NULL);
        if (whole == NULL) return jlt_command_fail(JLT_EXIT_IO, "%s: %s", job->model, strerror(errno));
        free(job->model);
        job->model = whole;
    }
    return JLT_EXIT_DONE;
}

static jlt_exit run_jobs(int *ending, const jlt_scene *scene, const options *o)
{
    JLT_FREED char *scene_path = realpath(o->scene, NULL);
    jlt_exit code = JLT_EXIT_DONE;

    if (o->into != NULL && !o->dry && ((mkdir(o->into, 0777) != 0 && errno != EEXIST) || chdir(o->into) != 0))
        code = jlt_command_fail(JLT_EXIT_IO, "--into %s: %s", o->into, strerror(errno));
    else if (!o->dry) code = check_files(scene, scene_path);
    for (size_t k = 0; code == JLT_EXIT_DONE && *ending == 0 && k < scene->count; k++) {
        const jlt_scene_job *job = &scene->jobs[k];
        const jlt_command *command = jlt_command_find(job->what);
        int argc = 0;
        char **argv = jlt_job_arguments(job, NULL, &argc);
        if (argv == NULL) return jlt_command_no_memory();
        if (o->dry) show(command->name, argv, argc);
        else {
            if (isatty(STDERR_FILENO))
                fprintf(stderr, "jellett: %s:%u: %s (%zu of %zu)\n", scene->file, job->line, job->what, k + 1, scene->count);
            code = jlt_job_run(ending, command, argv, argc);
            if (*ending != 0)
                fprintf(stderr, "jellett: %s:%u: %s was interrupted; of the scene's %zu commands the last %zu were not begun\n",
                        scene->file, job->line, job->what, scene->count, scene->count - k - 1);
            else if (code != JLT_EXIT_DONE)
                (void)jlt_command_fail(code, "%s:%u: error: %s ended with status %d", scene->file, job->line, job->what,
                                       (int)code);
        }
        jlt_command_free(argv, argc);
    }
    return code;
}

static jlt_exit run(int argc, char **argv)
{
    options o = { 0 };
    jlt_scene *scene = NULL;
    int ending = 0;

    ttc_options_parse(&parser, argc, argv, &o);
    jlt_exit code = jlt_job_open(&scene, o.scene);
    if (code == JLT_EXIT_DONE && scene->over != NULL)
        code = jlt_command_fail(JLT_EXIT_INPUT, "%s:%u: error: 'over' is of a study: type 'jellett sweep %s'", scene->file,
                                scene->over_line, o.scene);
    if (code == JLT_EXIT_DONE) code = jlt_job_set(scene, &o.set);
    if (code == JLT_EXIT_DONE && o.into != NULL) code = fix_tables(scene);
    if (code == JLT_EXIT_DONE) code = run_jobs(&ending, scene, &o);
    jlt_scene_destroy(scene);
    jlt_assign_clear(&o.set);
    if (ending != 0) jlt_interrupt_end(ending);
    return code;
}

const jlt_command jlt_command_run = { "run", "SCENE [OPTION...]", "Do what a scene file asks for", run, NULL, NULL };
