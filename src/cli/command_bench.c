/* `jellett bench`: replaces this program by jellett-bench, which measures speed against accuracy. */
#include "cli/program.h"

#include <errno.h>
#include <limits.h>
#include <string.h>
#include <unistd.h>

static jlt_exit run(int argc, char **argv)
{
    static const char *const places[] = { "jellett-bench", JLT_LIBEXEC "/jellett-bench" }; /* as built, as installed */
    char path[PATH_MAX];

    (void)argc;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        errno = ENOENT;
        if (jlt_program_beside(path, sizeof path, places[i])) execv(path, argv);
        if (errno != ENOENT) return jlt_command_fail(JLT_EXIT_IO, "cannot start '%s': %s", path, strerror(errno));
    }
    return jlt_command_fail(JLT_EXIT_IO, "jellett-bench, which measures, is neither beside this program nor in " JLT_LIBEXEC);
}

const jlt_command jlt_command_bench = {
    "bench", "KIND [OPTION...]", "Speed against accuracy: every method on the same question", run, NULL, NULL
};
