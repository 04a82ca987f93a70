#include "cli/program.h"

#include "base/exhaustion.h"
#include "base/output.h"
#include "cli/interrupt.h"
#include "cli/shelf.h"

#include <argp.h>
#include <ctype.h>
#include <fenv.h>
#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static const size_t stack_usual = 8 << 20; /* what Linux allows by default; arrays of the widest fields take half of it */

static void end_without_memory(void)
{
    static const char text[] = "jellett: out of memory\n";
    ssize_t written = write(STDERR_FILENO, text, sizeof text - 1);

    (void)written; /* there is nowhere else to say it */
    jlt_interrupt_abandon();
    _exit(JLT_EXIT_NUMERICAL);
}

static bool returned; /* whether the last command has returned its status */

/* The runtime of OpenMP calls exit(1) where it cannot start threads; no check has failed there. */
static void end_without_threads(int status, void *unused)
{
    (void)unused;
    if (status != JLT_EXIT_FAILED || returned) return;
    jlt_interrupt_abandon();
    _exit(JLT_EXIT_NUMERICAL);
}

static void widen_stack(void)
{
    struct rlimit limit;

    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= stack_usual) return;
    limit.rlim_cur = limit.rlim_max < stack_usual ? limit.rlim_max : stack_usual;
    if (setrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur < stack_usual)
        fprintf(stderr, "jellett: the stack is limited to %ju KiB, with which commands may crash: allow %zu ('ulimit -s')\n",
                (uintmax_t)limit.rlim_max / 1024, stack_usual / 1024);
}

/* Threads have stacks as the limit was when the program began, or, without a limit, of 2 MiB. */
static void widen_stacks_of_threads(void)
{
    pthread_attr_t attributes;
    size_t size;

    if (pthread_getattr_default_np(&attributes) != 0) return;
    if (pthread_attr_getstacksize(&attributes, &size) == 0 && size < stack_usual
        && pthread_attr_setstacksize(&attributes, stack_usual) == 0)
        (void)pthread_setattr_default_np(&attributes);
    pthread_attr_destroy(&attributes);
}

/* OMP_STACKSIZE, or without it GOMP_STACKSIZE, is read before main, so that it can only be told of: a number, in KiB or in the unit
 * that follows. */
static void tell_of_small_stacks(void)
{
    const char *const name = getenv("OMP_STACKSIZE") != NULL ? "OMP_STACKSIZE" : "GOMP_STACKSIZE", *const text = getenv(name);
    int bits = 10;
    char *end;

    if (text == NULL) return;
    const unsigned long long number = strtoull(text, &end, 10);
    while (isspace((unsigned char)*end)) end++;
    switch (tolower((unsigned char)*end)) {
    case 'b': bits = 0; break;
    case 'm': bits = 20; break;
    case 'g': bits = 30; break;
    default: break;
    }
    if (number > 0 && number < stack_usual >> bits)
        fprintf(stderr, "jellett: %s=%s limits the stacks of threads, with which commands may crash: allow %zuK\n", name, text,
                stack_usual / 1024);
}

jlt_exit jlt_program_begin(void)
{
    if (!ttc_output_standard("jellett", JLT_EXIT_IO)) return JLT_EXIT_IO;
    (void)fesetenv(FE_DFL_ENV); /* a library that is loaded first may have changed how doubles are rounded */
    widen_stack();
    widen_stacks_of_threads();
    tell_of_small_stacks();
    jlt_interrupt_begin();
    ttc_exhaustion_handle(end_without_memory);
    (void)on_exit(end_without_threads, NULL);
    argp_err_exit_status = JLT_EXIT_USAGE;
    /* The column of descriptions is wide enough for --start=STATE=VALUE,...; argp's note on short options says nothing here. */
    setenv("ARGP_HELP_FMT", "opt-doc-col=30,no-dup-args-note", 0);
    return JLT_EXIT_DONE;
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

    returned = false;
    /* argp takes the program's name from argv[0]. */
    snprintf(name, sizeof name, "jellett %s", command->name);
    argv[0] = name;
    code = jlt_program_call(command, argc, argv);
    argv[0] = first;
    returned = true;
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
