#include "base/exhaustion.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "top/top.h"

#include <argp.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const jlt_command *const commands[] = {
    &jlt_command_verify,
    &jlt_command_eigen,
    &jlt_command_measure,
    &jlt_command_models,
    &jlt_command_run,
    &jlt_command_plan,
    &jlt_command_simulate,
    &jlt_command_portrait,
    &jlt_command_rod,
    &jlt_command_section,
    &jlt_command_orbits,
    &jlt_command_fates,
    &jlt_command_manifolds,
    &jlt_command_continue,
    &jlt_command_lyapunov,
    &jlt_command_separation,
    &jlt_command_drift,
    &jlt_command_bench,
};
enum { COMMANDS = sizeof commands / sizeof *commands };

const jlt_command *jlt_command_find(const char *name)
{
    for (size_t i = 0; i < COMMANDS; i++)
        if (strcmp(commands[i]->name, name) == 0) return commands[i];
    return NULL;
}

/* What standard output still holds must arrive, also after --help of a command, which ends the program by itself. */
static void close_output(void)
{
    const bool failed = ferror(stdout) != 0;

    if (fclose(stdout) != 0 || failed) {
        fprintf(stderr, "jellett: cannot write to standard output: %s\n", strerror(errno));
        _exit(JLT_EXIT_IO);
    }
}

/* A descriptor that was closed must not be given to a file that is opened later: what is written to it fails, as before. */
static bool open_standard(void)
{
    for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; descriptor++)
        if (fcntl(descriptor, F_GETFD) < 0
            && open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY) != descriptor) return false;
    return true;
}

static void print_help(FILE *stream)
{
    fputs("Usage: jellett COMMAND [MODEL] [OPTION...]\n"
          "Verify and study models of nonholonomic mechanics through proved kernels.\n\n"
          "Commands:\n",
          stream);
    for (size_t i = 0; i < COMMANDS; i++)
        fprintf(stream, "  %s %s\n        %s\n", commands[i]->name, commands[i]->arguments, commands[i]->summary);
    fputs("\nMODEL is " JLT_DEFAULT_MODEL " when none is named. Values are exact: 1/3, 0.51, 1e-3.\n\n"
          "  jellett COMMAND --help    options of a command, with examples\n"
          "  jellett --help            this page\n"
          "  jellett --version         the version\n\n"
          "Exit status: 0 done, 1 a claim or check failed, 2 wrong usage, 3 bad input, 4 a numerical method failed,\n"
          "5 a file cannot be read or written. An interrupted command ends by the signal (130 after Ctrl-C, 143 after\n"
          "kill, as shells count); one that writes rows as they come saves the whole ones, the others save nothing. All end\n"
          "within a second; a signal that comes later ends the program at once.\n",
          stream);
}

jlt_exit jlt_command_execute(const jlt_command *command, int argc, char **argv)
{
    char name[64], *first = argv[0];
    jlt_exit code;

    /* argp takes the name of the program from here. */
    snprintf(name, sizeof name, "jellett %s", command->name);
    argv[0] = name;
    code = command->run(argc, argv);
    argv[0] = first;
    jlt_interrupt_obey();
    return code == JLT_EXIT_PLANNED ? JLT_EXIT_DONE : code;
}

static void end_without_memory(void)
{
    static const char text[] = "jellett: out of memory\n";
    ssize_t written = write(STDERR_FILENO, text, sizeof text - 1);

    (void)written; /* there is nowhere else to say it */
    jlt_interrupt_abandon();
    _exit(JLT_EXIT_NUMERICAL);
}

int main(int argc, char **argv)
{
    if (!open_standard()) return JLT_EXIT_IO;
    jlt_interrupt_begin();
    ttc_exhaustion_handle(end_without_memory);
    if (atexit(close_output) != 0) return JLT_EXIT_NUMERICAL;
    argp_err_exit_status = JLT_EXIT_USAGE;
    if (argc < 2) {
        print_help(stderr);
        return JLT_EXIT_USAGE;
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        print_help(stdout);
        return JLT_EXIT_DONE;
    }
    if (strcmp(argv[1], "--version") == 0) {
        puts("jellett " JLT_VERSION);
        return JLT_EXIT_DONE;
    }
    const jlt_command *command = jlt_command_find(argv[1]);
    if (command != NULL) return (int)jlt_command_execute(command, argc - 1, argv + 1);
    fprintf(stderr, "jellett: there is no %s '%s'; 'jellett --help' lists what there is\n",
            argv[1][0] == '-' ? "option" : "command", argv[1]);
    return JLT_EXIT_USAGE;
}
