#define _GNU_SOURCE /* sched_getaffinity, dladdr */
#include "build/compile.h"
#include "base/executable.h"

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* -O1, because on straight-line code the gain of -O2 is not worth twice the compile time. Results are the same bits at every level.
 * Files of ball arithmetic call Arb for every operation: -Og compiles them in half the time, and they run as fast. */
static const char *const flags[] = { "-std=c11", "-O1", "-fPIC", "-ffp-contract=off" };
static const char ball_flag[] = "-Og";
static const char without_lanes[] = "-DJLT_WITHOUT_LANES";

/* The file of kernels for one vector width, the options it is compiled with, and the macro that tells the other files that it is
 * the only such file. The caller makes sure that the processor has the instruction set. */
typedef struct {
    unsigned lanes;
    const char *file, *alone;
    const char *flags[6];
} lane_set;

static const lane_set sets[] = {
    { 2, "batch_baseline.c", "-DJLT_LANES_ALONE=2", { "-O2" } },
#if defined(__x86_64__)
    { 4, "batch_avx2.c", "-DJLT_LANES_ALONE=4", { "-O2", "-mavx2", "-mfma" } },
    { 8, "batch_avx512.c", "-DJLT_LANES_ALONE=8",
      { "-O2", "-mavx512f", "-mavx512dq", "-mavx512vl", "-mfma", "-mprefer-vector-width=512" } },
#endif
};
enum { SET_COUNT = sizeof sets / sizeof *sets, SET_FLAGS = 6 };

/* -Bsymbolic: a program that loads the object may itself contain kernels of the same names. */
static const char *const link_flags[] = { "-shared", "-Wl,-Bsymbolic" };

enum { FLAG_COUNT = sizeof flags / sizeof *flags, LINK_FLAG_COUNT = sizeof link_flags / sizeof *link_flags };

/* Path of the shared library that provides Arb to this program. Objects are linked with it, so that they can also be loaded by
 * programs that have no Arb, or do not export its symbols. NULL if Arb is linked statically. */
static const char *ball_library(void)
{
    void *function = dlsym(RTLD_DEFAULT, "arb_mul");
    Dl_info where;
    if (function == NULL || dladdr(function, &where) == 0 || strchr(where.dli_fname, '/') == NULL) return NULL;
    return strstr(where.dli_fname, ".so") != NULL ? where.dli_fname : NULL;
}

/* NULL if there are no kernels on vectors of this width. */
static const lane_set *set_of(unsigned lanes)
{
    for (size_t i = 0; i < SET_COUNT; i++)
        if (sets[i].lanes == lanes) return sets + i;
    return NULL;
}

void ttc_compiler_add_flags(ttc_text *text, unsigned lanes)
{
    const char *library = ball_library();
    const lane_set *set = set_of(lanes);
    for (size_t i = 0; i < FLAG_COUNT; i++) ttc_text_format(text, "%s ", flags[i]);
    ttc_text_format(text, "%s ", ball_flag);
    ttc_text_format(text, "%s ", set == NULL ? without_lanes : set->alone);
    for (size_t k = 0; set != NULL && k < SET_FLAGS && set->flags[k] != NULL; k++) ttc_text_format(text, "%s ", set->flags[k]);
    for (size_t i = 0; i < LINK_FLAG_COUNT; i++) ttc_text_format(text, "%s ", link_flags[i]);
    if (library != NULL) ttc_text_format(text, "%s ", library);
}

char *ttc_compiler_find(void)
{
    const char *named = getenv("CC");
    return ttc_executable_find(named != NULL && *named != '\0' ? named : "cc");
}

typedef struct {
    char **names;
    size_t count, capacity;
} file_list;

static bool add_file(file_list *list, char *name)
{
    if (name == NULL) return false;
    if (list->count + 1 >= list->capacity) {
        char **grown = realloc(list->names, (2 * list->capacity + 16) * sizeof *grown);
        if (grown == NULL) {
            free(name);
            return false;
        }
        list->names = grown;
        list->capacity = 2 * list->capacity + 16;
    }
    list->names[list->count++] = name;
    list->names[list->count] = NULL;
    return true;
}

static bool holds_lanes(const char *path)
{
    const char *slash = strrchr(path, '/');
    return strncmp(slash == NULL ? path : slash + 1, "batch_", 6) == 0;
}

static bool holds_balls(const char *path)
{
    static const char end[] = "_ball.c";
    const size_t length = strlen(path);
    return length >= sizeof end - 1 && strcmp(path + length - (sizeof end - 1), end) == 0;
}

/* Order for qsort: files that take longest to compile come first, so that none is left to run alone at the end. The file of vector
 * kernels, which includes all of them, takes as long as all others together; the others are ordered by size. */
static int in_turn(const void *a, const void *b)
{
    const char *left = *(char *const *)a, *right = *(char *const *)b;
    struct stat here = { 0 }, there = { 0 };
    const int order = holds_lanes(right) - holds_lanes(left);
    if (order != 0 || stat(left, &here) != 0 || stat(right, &there) != 0) return order;
    return (here.st_size < there.st_size) - (here.st_size > there.st_size);
}

/* Add the .c files of `folder`, and of its subfolders if `into`, to the list, except vector kernels of another width than that of
 * `set` (NULL: of any width), and files of ball arithmetic unless `balls`. */
static bool list_folder(file_list *list, const char *folder, bool into, const lane_set *set, bool balls)
{
    DIR *open = opendir(folder);
    bool ok = open != NULL;
    for (struct dirent *entry; ok && (entry = readdir(open)) != NULL;) {
        const size_t length = strlen(entry->d_name);
        struct stat kind;
        if (*entry->d_name == '.') continue;
        char *path = ttc_text_path(folder, entry->d_name, "");
        ok = path != NULL && stat(path, &kind) == 0;
        if (ok && into && S_ISDIR(kind.st_mode)) ok = list_folder(list, path, false, set, balls);
        else if (ok && length > 2 && strcmp(entry->d_name + length - 2, ".c") == 0
                 && (!holds_lanes(path) || (set != NULL && strcmp(entry->d_name, set->file) == 0))
                 && (balls || !holds_balls(path))) {
            ok = add_file(list, path);
            path = NULL;
        }
        free(path);
    }
    if (open != NULL) closedir(open);
    return ok;
}

static void free_list(file_list *list)
{
    for (size_t i = 0; i < list->count; i++) free(list->names[i]);
    free(list->names);
}

/* Start the compiler. Returns its process, or -1. in_silence: its messages are discarded. */
static pid_t start(const char *compiler, char *const *arguments, bool in_silence)
{
    const pid_t parent = getpid(), child = fork();
    if (child != 0) return child;
    prctl(PR_SET_PDEATHSIG, SIGTERM); /* when this program ends, so does the compiler */
    if (getppid() != parent) _exit(127);
    const int nowhere = open("/dev/null", O_WRONLY);
    if (nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
    if (nowhere >= 0 && in_silence) dup2(nowhere, STDERR_FILENO);
    execv(compiler, arguments);
    _exit(127);
}

static pid_t compile_one(const char *compiler, const char *include, const lane_set *set, bool balls, char *source, char *object)
{
    const char *arguments[FLAG_COUNT + SET_FLAGS + 10] = { compiler };
    size_t n = 1;
    for (size_t i = 0; i < FLAG_COUNT; i++) arguments[n++] = flags[i];
    arguments[n++] = set == NULL ? without_lanes : set->alone;
    for (size_t k = 0; set != NULL && holds_lanes(source) && k < SET_FLAGS && set->flags[k] != NULL; k++)
        arguments[n++] = set->flags[k];
    if (holds_balls(source)) arguments[n++] = ball_flag;
    if (!balls) arguments[n++] = "-DJLT_WITHOUT_BALLS";
    arguments[n++] = include;
    arguments[n++] = "-c";
    arguments[n++] = source;
    arguments[n++] = "-o";
    arguments[n++] = object;
    return start(compiler, (char *const *)arguments, false);
}

/* Wait for one child process. Returns false if it failed. */
static bool finish_one(void)
{
    int status = 0;
    pid_t child;
    do child = wait(&status);
    while (child < 0 && errno == EINTR);
    return child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static size_t processors(void)
{
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) == 0 ? (size_t)CPU_COUNT(&set) : 1;
}

/* Returns true if the compiler finds the headers of Arb, which the files of ball arithmetic include. */
static bool has_arb(const char *compiler, const char *folder)
{
    char *header = ttc_text_path(folder, "kernel_ball.h", "");
    const char *const arguments[] = { compiler, "-E", "-w", "-x", "c", header, NULL };
    const bool found = header != NULL && start(compiler, (char *const *)arguments, true) > 0 && finish_one();
    free(header);
    return found;
}

static bool compile_all(const char *compiler, const char *folder, const lane_set *set, bool balls, const file_list *sources,
                        const file_list *objects)
{
    const size_t most = processors();
    size_t running = 0;
    bool ok = true;
    ttc_text option = { 0 };
    ttc_text_format(&option, "-I%s", folder);
    for (size_t i = 0; ok && !option.failed && i < sources->count; i++) {
        if (running == most) {
            ok = finish_one();
            running--;
        }
        if (ok) ok = compile_one(compiler, option.bytes, set, balls, sources->names[i], objects->names[i]) > 0;
        if (ok) running++;
    }
    for (; running > 0; running--) ok = finish_one() && ok;
    ok = ok && !option.failed;
    ttc_text_clear(&option);
    return ok;
}

static bool link_all(const char *compiler, const file_list *objects, bool balls, const char *target)
{
    const char **arguments = calloc(objects->count + LINK_FLAG_COUNT + 6, sizeof *arguments);
    const char *library = balls ? ball_library() : NULL;
    size_t n = 0;
    if (arguments == NULL) return false;
    arguments[n++] = compiler;
    for (size_t i = 0; i < LINK_FLAG_COUNT; i++) arguments[n++] = link_flags[i];
    arguments[n++] = "-o";
    arguments[n++] = target;
    for (size_t i = 0; i < objects->count; i++) arguments[n++] = objects->names[i];
    if (library != NULL) arguments[n++] = library;
    arguments[n++] = "-lm";
    const bool ok = start(compiler, (char *const *)arguments, false) > 0 && finish_one() && access(target, R_OK) == 0;
    free(arguments);
    return ok;
}

bool ttc_compile_folder(const char *compiler, const char *folder, unsigned lanes, const char *target)
{
    file_list sources = { 0 }, objects = { 0 };
    const lane_set *set = set_of(lanes);
    const bool balls = has_arb(compiler, folder);
    bool ok = list_folder(&sources, folder, true, set, balls);
    if (ok) qsort(sources.names, sources.count, sizeof *sources.names, in_turn);
    for (size_t i = 0; ok && i < sources.count; i++) {
        char *object = strdup(sources.names[i]);
        if (object != NULL) object[strlen(object) - 1] = 'o';
        ok = add_file(&objects, object);
    }
    ok = ok && sources.count > 0 && compile_all(compiler, folder, set, balls, &sources, &objects)
         && link_all(compiler, &objects, balls, target);
    free_list(&objects);
    free_list(&sources);
    return ok;
}
