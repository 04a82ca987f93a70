#include "cli/job.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "cli/interrupt.h"
#include "cli/program.h"
#include "cli/table.h"

static const char *asked_for(const struct argp **options, size_t index)
{
    const jlt_command *command;

    for (size_t i = 0; (command = jlt_command_at(i)) != NULL; i++)
        if (command->parser != NULL && index-- == 0) break;
    if (command == NULL) return NULL;
    *options = command->parser;
    return command->name;
}

const jlt_scene_program jlt_job_program = { asked_for, jlt_table_of };

jlt_exit jlt_job_open(jlt_scene **scene, const char *path)
{
    char message[JLT_SCENE_MESSAGE_MAX];
    const jlt_status st = jlt_scene_read(scene, message, path, &jlt_job_program);
    const size_t length = strlen(path);

    if (st != JLT_OK && st != JLT_ERR_IO && length > 3 && strcmp(path + length - 3, ".tt") == 0)
        return jlt_command_fail(JLT_EXIT_INPUT,
                                "%s is a table, no scene: it is the model of a command, as in 'jellett simulate %s ...' or "
                                "'jellett plan simulate %s ...'", path, path, path);
    if (st != JLT_OK && message[0] != '\0') fprintf(stderr, "%s\n", message);
    return jlt_command_exit(st);
}

jlt_exit jlt_job_set(jlt_scene *scene, const jlt_assign_list *set)
{
    for (size_t i = 0; i < set->count; i++) {
        const jlt_status st = jlt_scene_set(scene, set->items[i].name, set->items[i].fraction);
        if (st == JLT_ERR_ARG)
            return jlt_command_fail(JLT_EXIT_INPUT, "--set: no command of %s has a parameter '%s'", scene->file,
                                    set->items[i].name);
        if (st != JLT_OK) return jlt_command_no_memory();
    }
    return JLT_EXIT_DONE;
}

char **jlt_job_arguments(const jlt_scene_job *job, const char *more, int *argc)
{
    char **argv = calloc(job->count + 5, sizeof *argv);
    int count = 0;
    bool whole = argv != NULL;

    if (whole) whole = (argv[count++] = strdup(job->what)) != NULL;
    if (whole && job->model != NULL) whole = (argv[count++] = strdup(job->model)) != NULL;
    for (size_t i = 0; whole && i < job->count; i++) {
        const jlt_scene_option *option = &job->options[i];
        const size_t length = strlen(option->name) + (option->value != NULL ? strlen(option->value) : 0) + 4;
        argv[count] = malloc(length);
        whole = argv[count] != NULL;
        if (whole)
            snprintf(argv[count++], length, "--%s%s%s", option->name, option->value != NULL ? "=" : "",
                     option->value != NULL ? option->value : "");
    }
    if (whole && more != NULL) whole = (argv[count++] = strdup(more)) != NULL;
    *argc = count;
    if (whole) return argv;
    jlt_command_free(argv, count);
    return NULL;
}

jlt_exit jlt_job_run(int *ending, const jlt_command *command, char **argv, int argc)
{
    int status = 0;
    pid_t child;

    fflush(stdout);
    child = jlt_interrupt_fork();
    if (child < 0)
        return jlt_command_fail(JLT_EXIT_NUMERICAL, "cannot start %s: %s", command->name, strerror(errno));
    if (child == 0) exit((int)jlt_program_run(command, argc, argv));
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    *ending = jlt_interrupt_alone();
    if (!WIFSIGNALED(status)) return (jlt_exit)WEXITSTATUS(status);
    const int by = WTERMSIG(status);
    if (by == SIGINT || by == SIGTERM || by == SIGHUP) *ending = by;
    else (void)jlt_command_fail(JLT_EXIT_NUMERICAL, "%s was ended by signal %d", command->name, by);
    return JLT_EXIT_NUMERICAL;
}
