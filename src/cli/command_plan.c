/* `jellett plan`: prints which model answers a command, or each entry of a scene, and why. */
#include <argp.h>
#include <stdlib.h>
#include <string.h>

#include "base/options.h"
#include "cli/common.h"
#include "cli/interrupt.h"
#include "cli/job.h"
#include "cli/program.h"
#include "cli/study.h"
#include "kernel/descriptor.h"
#include "scene/tier.h"
#include "top/top.h"

typedef struct {
    const char *scene;
    jlt_assign_list set;
} options;

static const struct argp_option option_table[] = {
    { "set", 's', "PARAM=VALUE,...", TTC_OPTIONS_REPEATED,
      "Values of parameters in place of the scene's, in all of its commands", 0 },
    { 0 },
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    options *o = state->input;

    switch (key) {
    case 's': jlt_common_list(&o->set, value, "--set"); return 0;
    case ARGP_KEY_ARG:
        if (o->scene != NULL) argp_error(state, "one scene at a time: '%s' is too many", value);
        o->scene = value;
        return 0;
    case ARGP_KEY_END:
        if (o->set.count > 0 && o->scene == NULL) argp_error(state, "--set is of a scene's commands: name a scene");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {
    option_table, parse, "[SCENE]\nCOMMAND OPTION...",
    "Show which model a command, or each part of a scene, gets, and why. Nothing else is computed. Without arguments: the tiers "
    "there are."
    "\vFor each question the plan lists the tiers from the smallest up; for each tier the most special kernel that fits the "
    "parameters, and the operations of one call of its right-hand side.\n\n"
    "On a section it also shows the levels, what is proved of them, where orbits start, and by which method they are followed. "
    "A start that would be refused is reported. The plan of a study is that of the first point of what it runs over.\n\n"
    "Examples:\n"
    "  jellett plan section --grid 24x16 --set a3=0\n"
    "  jellett plan continue --along a3=0.4:0.6\n"
    "  jellett plan tools/scenes/full.scene --set a3=0",
    NULL, NULL, NULL,
};

static void print_tiers(void)
{
    jlt_tier tiers[JLT_TIERS_MAX];
    const unsigned count = jlt_tier_list(tiers, jlt_descriptor_find(JLT_DEFAULT_MODEL, NULL, NULL, NULL), NULL);

    printf("%-14s %5s  %s\n", "tier", "dim", "what");
    for (unsigned i = 0; i < count; i++)
        printf("%-14s %5u  %s%s\n", tiers[i].name, tiers[i].dimension, tiers[i].meaning,
               tiers[i].by_name ? " (a comparison: by name only)" : "");
    printf("%-14s %5s  %s\n", "model", "-", "any model's own field, in t");
}

/* Whether this command follows no motion and does not have the common options, so that it has no plan. */
static bool is_still(const char *name)
{
    static const char *const still[] = { "verify", "models", "bench", "check", "merge" };

    for (size_t i = 0; i < sizeof still / sizeof *still; i++)
        if (strcmp(still[i], name) == 0) return true;
    return false;
}

/* Give a study's command the first values of what the study runs over, and say so. */
static jlt_exit give_over(char ***argv, int *argc, const jlt_study *study)
{
    char place[JLT_GRID_PLACE_MAX];

    if (!jlt_study_give(argv, argc, study->over, study->over_count, 0, study->scene->model)) return jlt_command_no_memory();
    (void)jlt_grid_place(place, study->over, study->over_count, 0);
    printf("at %s, the first of %zu points:\n", place, study->outer);
    return JLT_EXIT_DONE;
}

/* Print a command's plan in a child process, since argp may end the process on an error. study: NULL, or that of the scene. */
static jlt_exit plan_job(const jlt_scene *scene, const jlt_study *study, size_t index)
{
    const jlt_scene_job *job = &scene->jobs[index];
    const jlt_command *command = jlt_command_find(job->what);
    int argc = 0, ending = 0;
    char **argv = jlt_job_arguments(job, JLT_COMMON_PLAN, &argc);
    jlt_exit code = JLT_EXIT_DONE;

    printf("%zu. %s (%s:%u)\n", index + 1, job->what, scene->file, job->line);
    if (argv == NULL) return jlt_command_no_memory();
    if (study != NULL) code = give_over(&argv, &argc, study);
    if (code == JLT_EXIT_DONE) code = is_still(job->what) ? jlt_common_still() : jlt_job_run(&ending, command, argv, argc);
    jlt_command_free(argv, argc);
    if (ending != 0) jlt_interrupt_end(ending);
    if (code == JLT_EXIT_DONE || code == JLT_EXIT_PLANNED) return JLT_EXIT_DONE;
    return jlt_command_fail(code, "%s:%u: error: there is no plan for %s", scene->file, job->line, job->what);
}

/* `jellett plan COMMAND OPTION...` runs COMMAND with the hidden option JLT_COMMON_PLAN added. */
static jlt_exit plan_command(const jlt_command *command, int argc, char **argv)
{
    char **more = calloc((size_t)argc + 2, sizeof *more), plan[] = JLT_COMMON_PLAN;
    jlt_exit code;

    if (command == &jlt_command_run || command == &jlt_command_plan || command == &jlt_command_sweep) {
        free(more);
        return jlt_command_fail(JLT_EXIT_USAGE, "the plan of a scene is 'jellett plan SCENE', without '%s'", command->name);
    }
    if (more == NULL) return jlt_command_no_memory();
    more[0] = argv[0];
    more[1] = plan; /* first, since a "--" in the arguments would turn it into an operand */
    for (int i = 1; i < argc; i++) more[i + 1] = argv[i];
    if (is_still(command->name))
        code = jlt_command_fail(JLT_EXIT_USAGE, "%s follows no motion that could be planned", command->name);
    else code = jlt_program_run(command, argc + 1, more);
    free(more);
    return code;
}

static jlt_exit run(int argc, char **argv)
{
    options o = { .scene = NULL };
    jlt_scene *scene = NULL;
    jlt_study study;
    jlt_exit code;

    const jlt_command *command = argc > 1 ? jlt_command_find(argv[1]) : NULL;
    if (command != NULL) return plan_command(command, argc - 1, argv + 1);
    ttc_options_parse(&parser, argc, argv, &o);
    if (o.scene == NULL) {
        print_tiers();
        return JLT_EXIT_DONE;
    }
    const char *path = o.scene;
    code = jlt_job_open(&scene, path);
    if (code == JLT_EXIT_IO && strpbrk(path, "/.") == NULL) fprintf(stderr, "jellett: nor is there a command '%s'\n", path);
    const bool is_study = code == JLT_EXIT_DONE && scene->over != NULL;
    if (is_study) code = jlt_study_make(&study, scene, &o.set);
    else if (code == JLT_EXIT_DONE) code = jlt_job_set(scene, &o.set);
    if (code == JLT_EXIT_DONE && scene->title[0] != '\0') printf("%s\n", scene->title);
    for (size_t k = 0; code == JLT_EXIT_DONE && k < scene->count; k++) code = plan_job(scene, is_study ? &study : NULL, k);
    if (is_study) jlt_study_clear(&study);
    else jlt_scene_destroy(scene);
    jlt_assign_clear(&o.set);
    return code;
}

const jlt_command jlt_command_plan = {
    "plan", "[SCENE [--set PARAM=VALUE,...]]|COMMAND OPTION...",
    "Which model a command gets, or each part of a scene, and why", run, NULL, NULL
};
