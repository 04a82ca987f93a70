/* The program `jellett`: runs the command that is named. */
#include "base/text.h"
#include "cli/program.h"
#include "top/top.h"

#include <stdlib.h>
#include <string.h>

/* Threads that wait for others sleep, unless the environment says otherwise: those that ask again and again take a fifth of the
 * time of short regions, from whatever else runs on the processors. */
__attribute__((constructor(101))) static void wait_asleep(void) { setenv("OMP_WAIT_POLICY", "passive", 0); }

static void print_help(FILE *stream)
{
    const jlt_command *command;

    fputs("Usage: jellett COMMAND [MODEL] [OPTION...]\n"
          "Verify and study models of nonholonomic mechanics through proved kernels.\n\n"
          "Commands:\n",
          stream);
    for (size_t i = 0; (command = jlt_command_at(i)) != NULL; i++)
        fprintf(stream, "  %s %s\n        %s\n", command->name, command->arguments, command->summary);
    fputs("\nMODEL is " JLT_DEFAULT_MODEL " when none is named. Values are exact: 1/3, 0.51, 1e-3.\n\n"
          "  jellett section --grid 24x16 --plot map.svg -o map.csv\n"
          "                            a first picture: the Poincare map at (5.1)\n"
          "  jellett COMMAND --help    options of a command, with examples\n"
          "  jellett --help            this page\n"
          "  jellett --version         the version\n\n"
          "Exit status: 0 done, 1 a claim or check failed, 2 wrong usage, 3 bad input,\n"
          "4 a numerical method failed, 5 a file cannot be read or written. Where points\n"
          "of a sweep are refused, 3 is the status only if all are. An interrupted\n"
          "command ends by the signal (shells show 130 after Ctrl-C, 143 after kill),\n"
          "within a second, or ten more where it still draws --plot; a second later,\n"
          "another signal ends the program at once. A command that writes rows as they\n"
          "come saves those that are whole; other commands save nothing.\n",
          stream);
}

static bool is_one_of(const char *word, const char *const *words)
{
    while (*words != NULL && strcmp(*words, word) != 0) words++;
    return *words != NULL;
}

int main(int argc, char **argv)
{
    const jlt_exit begun = jlt_program_begin();

    if (begun != JLT_EXIT_DONE) return (int)begun;
    if (argc < 2) {
        print_help(stderr);
        return JLT_EXIT_USAGE;
    }
    if (argc > 2 && strcmp(argv[1], "help") == 0) {
        argv[1] = argv[2];
        argv[2] = "--help";
    }
    if (is_one_of(argv[1], (const char *const[]){ "--help", "-h", "-?", "help", NULL })) {
        print_help(stdout);
        return JLT_EXIT_DONE;
    }
    if (is_one_of(argv[1], (const char *const[]){ "--version", "-V", NULL })) {
        puts("jellett " JLT_VERSION);
        return JLT_EXIT_DONE;
    }
    const jlt_command *command = jlt_command_find(argv[1]);
    if (command != NULL) return (int)jlt_program_run(command, argc - 1, argv + 1);
    fprintf(stderr, "jellett: there is no %s '%s'", argv[1][0] == '-' ? "option" : "command", argv[1]);
    for (size_t i = 0; (command = jlt_command_at(i)) != NULL; i++)
        if (ttc_text_resembles(command->name, strlen(command->name), argv[1], strlen(argv[1])))
            fprintf(stderr, " (did you mean '%s'?)", command->name);
    fputs("; 'jellett --help' lists what there is\n", stderr);
    return JLT_EXIT_USAGE;
}
