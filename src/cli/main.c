#include "cli/program.h"
#include "top/top.h"

#include <string.h>

static const jlt_command *const commands[] = {
    &jlt_command_verify, &jlt_command_eigen, &jlt_command_measure, &jlt_command_models, &jlt_command_run,
    &jlt_command_plan, &jlt_command_simulate, &jlt_command_portrait, &jlt_command_rod, &jlt_command_section,
    &jlt_command_orbits, &jlt_command_fates, &jlt_command_manifolds, &jlt_command_continue, &jlt_command_lyapunov,
    &jlt_command_separation, &jlt_command_drift, &jlt_command_bench,
};
enum { COMMANDS = sizeof commands / sizeof *commands };

const jlt_command *jlt_command_find(const char *name)
{
    for (size_t i = 0; i < COMMANDS; i++)
        if (strcmp(commands[i]->name, name) == 0) return commands[i];
    return NULL;
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

int main(int argc, char **argv)
{
    const jlt_exit begun = jlt_program_begin();

    if (begun != JLT_EXIT_DONE) return (int)begun;
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
    if (command != NULL) return (int)jlt_program_run(command, argc - 1, argv + 1);
    fprintf(stderr, "jellett: there is no %s '%s'; 'jellett --help' lists what there is\n",
            argv[1][0] == '-' ? "option" : "command", argv[1]);
    return JLT_EXIT_USAGE;
}
