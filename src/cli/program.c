#include "cli/program.h"

#include "base/exhaustion.h"
#include "base/output.h"
#include "cli/interrupt.h"
#include "cli/shelf.h"

#include <argp.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Runs at exit: report a failure to write buffered standard output, also after --help, where argp ends the program. */
static void close_output(void)
{
    const bool failed = ferror(stdout) != 0;

    if (fclose(stdout) != 0 || failed) {
        fprintf(stderr, "jellett: cannot write to standard output: %s\n", strerror(errno));
        _exit(JLT_EXIT_IO);
    }
}

static void end_without_memory(void)
{
    static const char text[] = "jellett: out of memory\n";
    ssize_t written = write(STDERR_FILENO, text, sizeof text - 1);

    (void)written; /* there is nowhere else to say it */
    jlt_interrupt_abandon();
    _exit(JLT_EXIT_NUMERICAL);
}

jlt_exit jlt_program_begin(void)
{
    if (!ttc_output_standard()) return JLT_EXIT_IO;
    jlt_interrupt_begin();
    ttc_exhaustion_handle(end_without_memory);
    argp_err_exit_status = JLT_EXIT_USAGE;
    /* The column of descriptions is wide enough for --start=STATE=VALUE,...; argp's note on short options says nothing here. */
    setenv("ARGP_HELP_FMT", "opt-doc-col=30,no-dup-args-note", 0);
    return atexit(close_output) == 0 ? JLT_EXIT_DONE : JLT_EXIT_NUMERICAL;
}

jlt_exit jlt_program_call(const jlt_command *command, int argc, char **argv)
{
    jlt_exit code;

    if (command->run != NULL) return command->run(argc, argv);
    void *const run = command->together->begin(&code, argc, argv);
    if (run == NULL) return code;
    code = command->together->finish(run);
    command->together->drop(run);
    return code;
}

jlt_exit jlt_program_run(const jlt_command *command, int argc, char **argv)
{
    char name[64], *first = argv[0];
    jlt_exit code;

    /* argp takes the program's name from argv[0]. */
    snprintf(name, sizeof name, "jellett %s", command->name);
    argv[0] = name;
    code = jlt_program_call(command, argc, argv);
    argv[0] = first;
    jlt_interrupt_obey();
    return code == JLT_EXIT_PLANNED ? JLT_EXIT_DONE : code;
}

bool jlt_program_beside(char *path, size_t size, const char *name)
{
    const ssize_t length = readlink("/proc/self/exe", path, size - 1);

    if (length <= 0) return false;
    path[length] = '\0';
    char *const file = strrchr(path, '/') + 1;
    if ((size_t)(file - path) + strlen(name) >= size) return false;
    strcpy(file, name);
    return true;
}
