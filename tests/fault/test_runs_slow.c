/* Commands under random faults: signals, closed descriptors, limits on files, memory and descriptors, full disks. Whatever happens,
 * a command ends within two seconds of being asked, or ten more where rows are drawn (cli/interrupt.h), by a documented status or
 * the signal, says something when not all went well, and leaves files whole, old or absent, and nothing else.
 *
 *     fault.test_runs_slow [SEED [CASES [FIRST]]]
 *
 * Each case depends on the seed and its number alone. Needs jellett and ttc in PATH. Exit status 1 when an invariant broke. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "core/random.h"

enum { WORKERS = 2, WORDS = 40, PATIENCE_MS = 2000, DRAWING_MS = 10000, SIGNALS = 8 };

#define START "gamma3=0.2,v_nu=0.6,omega_tau=0.4,omega_n=1,omega3=0"
#define FALLING "gamma3=0.25,v_nu=0.8,omega_tau=-0.6,omega_n=1.1,omega3=-2.3"
#define BALANCED "gamma3=0.5,v_nu=0.8,omega_tau=0,omega_n=0,omega3=0.9"
#define MODELS JLT_SOURCE_DIR "/codegen/models/"

/* Words separated by blanks. Files are t.csv, c.csv, p.svg, k.gp, and the folder g. */
static const char *const commands[] = {
    "jellett section --grid 60x60 --returns 200 -o t.csv",
    "jellett section --grid 60x60 --returns 200",
    "jellett section --grid 6x6 --returns 20 -o t.csv --plot p.svg --keep k.gp",
    "jellett section --threads 2 --grid 100x100 --returns 500 -o t.csv --plot p.svg",
    "jellett section --grid 30x30 --returns 3000 -o t.csv",
    "jellett fates --grid 60x40 -o t.csv --plot p.svg",
    "jellett fates --grid 6x4 --sweep a3=0.1:0.7:40 -o t.csv --plot p.svg",
    "jellett orbits --period 3 -o t.csv --plot p.svg",
    "jellett manifolds --length 0.4 -o t.csv --crossings c.csv --plot p.svg",
    "jellett manifolds -o t.csv --crossings c.csv",
    "jellett continue --along E=0.8:2.2 --decreasing --branches -o t.csv --plot p.svg",
    "jellett lyapunov --start eta=0.02,gamma3=-0.61 --returns 20000 -o t.csv --plot p.svg",
    "jellett separation --grid 10x10 --returns 256 -o t.csv",
    "jellett drift --returns 3000 -o t.csv --plot p.svg",
    "jellett simulate --start " FALLING " --until 20 --every 1/50 --track -o t.csv --plot p.svg",
    "jellett simulate --start " FALLING " --until 1000 --every 1/50 -o t.csv",
    "jellett portrait --set I1=2/5,I3=1/4 --start " BALANCED " --orbits 20 -o t.csv --trajectories c.csv --plot p.svg",
    "jellett rod --start " START " --sweep omega_n=0.2:2:2000 -o t.csv --plot p.svg",
    "jellett rod --start " START " --sweep omega_n=0.2:2:200 --check -o t.csv",
    "jellett eigen --set a3=0 --at v_nu=0.7,omega3=1.1 --sweep gamma3=-0.99:0.99:801 -o t.csv --plot p.svg",
    "jellett eigen --set a3=0 --at gamma3=0.3,v_nu=0.7,omega3=1.1",
    "jellett measure --set I3=0 -o t.csv",
    "jellett models",
    "jellett verify chaplygin_sleigh",
    "jellett verify --samples 40000",
    "jellett plan s.scene",
    "jellett run s.scene",
    "jellett run s.scene",
    "jellett bench section --quick --form level --reference " JLT_SOURCE_DIR "/tests/reference/data/grid_regular_51.csv -o t.csv",
    "ttc generate " MODELS "lorenz.tt --out g",
    "ttc generate " MODELS "chaplygin_sleigh.tt --out g",
    "ttc prove " MODELS "spherical_top.tt",
    "ttc check " MODELS "spherical_top.tt",
    "ttc cost " MODELS "lorenz.tt",
    "ttc discover --when beta=2*sigma " MODELS "lorenz.tt",
};
enum { COMMANDS = sizeof commands / sizeof *commands };

static const char scene[] =
    "compute = ( { what = \"section\"; grid = \"10x10\"; returns = 100; output = \"t.csv\"; plot = \"p.svg\"; },\n"
    "            { what = \"verify\"; samples = 4000; },\n"
    "            { what = \"section\"; start = { eta = 0.1; gamma3 = -0.6; }; returns = 5; output = \"c.csv\"; } );\n";

typedef enum { ASKED, KILLED, CLOSED, FILE_SIZE, MEMORY, DESCRIPTORS, FULL, DISK, FAULTS } fault;
static const char *const fault_names[] = {
    "signals", "killed", "closed", "file size", "memory", "descriptors", "/dev/full", "disk"
};

typedef struct {
    unsigned long seed, number;
    jlt_random random;
    fault fault;
    const char *command;
    char folder[64];
    bool old;              /* files are there already */
    int signals[SIGNALS], count, gap_ms, delay_ms;
    bool group;            /* signals go to all processes */
    unsigned closed;       /* bits of descriptors */
    size_t limit;
    int status;            /* as waitpid tells */
    bool asked;            /* a signal was sent */
} trial;

static unsigned long broken;

static void complain(const trial *t, const char *what, const char *more)
{
    printf("seed %lu case %lu (%s, limit %zu, %d signals after %d ms, closed %u): %s\n    %s %s\n", t->seed, t->number,
           fault_names[t->fault], t->limit, t->count, t->delay_ms, t->closed, t->command, what, more);
    broken++;
}

static void pause_ms(long ms)
{
    struct timespec time = { ms / 1000, ms % 1000 * 1000000 };
    while (nanosleep(&time, &time) != 0 && errno == EINTR) continue;
}

static void put(const trial *t, const char *name, const char *text)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/d/%s", t->folder, name);
    FILE *file = fopen(path, "w");
    if (file == NULL) return;
    fputs(text, file);
    fclose(file);
}

static void shell(const char *format, const char *folder)
{
    char line[256];
    snprintf(line, sizeof line, format, folder);
    if (system(line) != 0) printf("cannot: %s\n", line);
}

/* ---- one run ---- */

static void limit_to(unsigned resource, size_t value)
{
    const struct rlimit both = { value, value };
    setrlimit(resource, &both);
}

static void become(const trial *t)
{
    static char text[1024];
    char *words[WORDS] = { NULL }, *rest = NULL;
    int count = 0;

    snprintf(text, sizeof text, "%s", t->command);
    for (char *word = strtok_r(text, " ", &rest); word != NULL; word = strtok_r(NULL, " ", &rest)) words[count++] = word;
    setpgid(0, 0);
    const int out = open(t->fault == FULL ? "/dev/full" : "out", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const int err = open("err", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    setenv("TMPDIR", "tmp", 1);
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    for (int i = 3; i < 20; i++) close(i);
    if (chdir("d") != 0) _exit(99);
    setenv("TMPDIR", "../tmp", 1);
    for (int i = 0; i < 3; i++)
        if (t->closed & 1u << i) close(i);
    if (t->fault == FILE_SIZE) limit_to(RLIMIT_FSIZE, t->limit);
    if (t->fault == MEMORY) limit_to(RLIMIT_AS, t->limit);
    if (t->fault == DESCRIPTORS) limit_to(RLIMIT_NOFILE, t->limit);
    limit_to(RLIMIT_CORE, 0);
    execvp(words[0], words);
    _exit(98);
}

/* True when it ended in time. */
static bool await(trial *t, pid_t child, long ms)
{
    for (long waited = 0;; waited += 5) {
        const pid_t ended = waitpid(child, &t->status, WNOHANG);
        if (ended == child) return true;
        if (waited >= ms) return false;
        pause_ms(5);
    }
}

static void run(trial *t)
{
    const pid_t child = fork();

    if (child == 0) {
        if (chdir(t->folder) != 0) _exit(97);
        become(t);
    }
    setpgid(child, child);
    bool ended = await(t, child, t->delay_ms);
    for (int i = 0; !ended && i < t->count; i++) {
        t->asked = true;
        kill(t->group ? -child : child, t->signals[i]);
        if (t->gap_ms > 0) ended = await(t, child, t->gap_ms);
    }
    const bool draws = strstr(t->command, "--plot") != NULL || strstr(t->command, "run ") != NULL;
    if (!ended) ended = await(t, child, PATIENCE_MS + (draws ? DRAWING_MS : 0));
    if (!ended) {
        complain(t, "goes on after the signals", "");
        kill(-child, SIGKILL);
        waitpid(child, &t->status, 0);
    }
    /* Workers and gnuplot end with it. */
    for (int i = 0; i < 400 && kill(-child, 0) == 0; i++) pause_ms(5);
    if (kill(-child, 0) == 0) {
        complain(t, "leaves a process behind", "");
        kill(-child, SIGKILL);
    }
}

/* ---- what it leaves ---- */

static char *read_file(const trial *t, const char *name, size_t *size)
{
    char path[PATH_MAX];
    struct stat about;
    snprintf(path, sizeof path, "%s/%s", t->folder, name);
    FILE *file = fopen(path, "rb");
    if (file == NULL || fstat(fileno(file), &about) != 0) return NULL;
    char *text = calloc((size_t)about.st_size + 1, 1);
    *size = text == NULL ? 0 : fread(text, 1, (size_t)about.st_size, file);
    fclose(file);
    return text;
}

static size_t commas(const char *line)
{
    size_t count = 0;
    for (; *line != '\0' && *line != '\n'; line++) count += *line == ',';
    return count;
}

/* Whole rows: as many fields in the last one as in the titles. Reports of eigen and measure are no tables. */
static bool is_whole_table(const char *text, size_t size)
{
    const char *titles = text, *last = text;
    if (size == 0 || text[size - 1] != '\n') return false;
    for (const char *line = text; line != NULL && *line != '\0'; line = strchr(line, '\n') + 1) {
        if (titles == line && *line == '#') titles = strchr(line, '\n') + 1;
        if (*line != '#') last = line;
    }
    return last < titles || commas(last) == commas(titles);
}

static void check_file(const trial *t, const char *name, bool is_table)
{
    char path[64];
    size_t size = 0;
    snprintf(path, sizeof path, "d/%s", name);
    char *text = read_file(t, path, &size);
    if (text == NULL) {
        if (t->old) complain(t, "an old file is gone:", name);
        return;
    }
    const bool is_old = t->old && strcmp(text, "old\n") == 0;
    const bool is_whole = is_table ? is_whole_table(text, size)
                                   : strcmp(name, "p.svg") != 0 || strstr(text, "</svg>") != NULL;
    if (!is_old && !is_whole) complain(t, "neither whole nor old:", name);
    free(text);
}

static void check_names(const trial *t, const char *folder)
{
    static const char *const known[] = { ".", "..", "t.csv", "c.csv", "p.svg", "k.gp", "g", "s.scene" };
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/%s", t->folder, folder);
    DIR *listing = opendir(path);
    struct dirent *entry;
    while (listing != NULL && (entry = readdir(listing)) != NULL) {
        bool is_known = t->fault == KILLED;
        for (size_t i = 0; i < sizeof known / sizeof *known; i++) is_known |= strcmp(entry->d_name, known[i]) == 0;
        if (!is_known) complain(t, "leaves", entry->d_name);
    }
    if (listing != NULL) closedir(listing);
}

static bool was_sent(const trial *t, int signal_number)
{
    for (int i = 0; i < t->count; i++)
        if (t->asked && t->signals[i] == signal_number) return true;
    return false;
}

static void check(const trial *t)
{
    const int code = WIFEXITED(t->status) ? WEXITSTATUS(t->status) : -1;
    /* Where the loader finds neither memory nor descriptors the program does not begin. */
    const bool not_begun = code == 127 && (t->fault == MEMORY || t->fault == DESCRIPTORS);
    char text[64];
    size_t size = 0;

    snprintf(text, sizeof text, "%d, signal %d", code, WIFSIGNALED(t->status) ? WTERMSIG(t->status) : 0);
    if (WIFSIGNALED(t->status) ? !was_sent(t, WTERMSIG(t->status)) : (code > 5 && !not_begun)) complain(t, "ends with", text);
    char *said = read_file(t, "err", &size);
    const bool is_mute = (t->closed & 4) != 0 || (t->fault == FILE_SIZE && t->limit == 0) || t->fault == KILLED;
    /* Before it takes signals over, a program ends by them without a word; ttc, which has nothing to save, always does. */
    const bool too_early = WIFSIGNALED(t->status) && (t->delay_ms < 100 || strncmp(t->command, "ttc", 3) == 0);
    if (t->status != 0 && size == 0 && !is_mute && !too_early) complain(t, "says nothing, and ends with", text);
    free(said);
    check_names(t, "d");
    check_names(t, "tmp");
    const bool is_report = strstr(t->command, "measure") != NULL || strstr(t->command, "eigen --set a3=0 --at gamma3") != NULL;
    check_file(t, "t.csv", !is_report);
    check_file(t, "c.csv", true);
    check_file(t, "p.svg", false);
    check_file(t, "k.gp", false);
}

/* ---- cases ---- */

static void choose(trial *t)
{
    static const int polite[] = { SIGINT, SIGTERM, SIGHUP };
    jlt_random *r = &t->random;

    t->command = commands[jlt_random_below(r, COMMANDS)];
    /* Half of all cases are signals. */
    t->fault = jlt_random_below(r, 2) == 0 ? ASKED : (fault)jlt_random_below(r, FAULTS);
    t->old = jlt_random_below(r, 2) == 0;
    t->group = jlt_random_below(r, 2) == 0;
    t->delay_ms = t->fault <= KILLED ? (int)jlt_random_below(r, 700) : 1500;
    t->count = t->fault == ASKED ? 1 + (int)jlt_random_below(r, jlt_random_below(r, 2) == 0 ? 2 : SIGNALS) : 1;
    /* Now and then one that comes after more than a second. */
    t->gap_ms = t->fault != ASKED ? 0 : jlt_random_below(r, 8) == 0 ? 1100 : (int)jlt_random_below(r, 30);
    if (t->gap_ms == 1100 && t->count > 2) t->count = 2;
    for (int i = 0; i < t->count; i++) t->signals[i] = t->fault == KILLED ? SIGKILL : polite[jlt_random_below(r, 3)];
    if (t->fault == CLOSED) t->closed = 1 + (unsigned)jlt_random_below(r, 7);
    if (t->fault == FILE_SIZE) t->limit = jlt_random_below(r, 4) == 0 ? 0 : (size_t)jlt_random_magnitude(r, 1, 6);
    if (t->fault == MEMORY) t->limit = (size_t)jlt_random_magnitude(r, 7.5, 9);
    if (t->fault == DESCRIPTORS) t->limit = 3 + (size_t)jlt_random_below(r, 10);
    if (t->fault == DISK) t->limit = 4096 * (8 + (size_t)jlt_random_below(r, 60)); /* the files that are there take six */
}

static void do_case(unsigned long seed, unsigned long number)
{
    static const char *const files[] = { "t.csv", "c.csv", "p.svg", "k.gp" };
    trial t = { .seed = seed, .number = number };
    char path[PATH_MAX], size[64];
    bool mounted = false;

    jlt_random_seed(&t.random, seed * 1000003 + number);
    choose(&t);
    snprintf(t.folder, sizeof t.folder, "/tmp/jellett_runs_%ld_%lu", (long)getpid(), number);
    shell("rm -rf %s", t.folder);
    mkdir(t.folder, 0755);
    snprintf(path, sizeof path, "%s/tmp", t.folder);
    mkdir(path, 0755);
    snprintf(path, sizeof path, "%s/d", t.folder);
    mkdir(path, 0755);
    snprintf(size, sizeof size, "size=%zu", t.limit);
    if (t.fault == DISK) {
        mounted = mount("none", path, "tmpfs", 0, size) == 0;
        if (!mounted) t.fault = FILE_SIZE; /* the next best where nothing may be mounted */
    }
    put(&t, "s.scene", scene);
    for (size_t i = 0; t.old && i < sizeof files / sizeof *files; i++) put(&t, files[i], "old\n");
    run(&t);
    check(&t);
    if (mounted) umount(path);
    shell("rm -rf %s", t.folder);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    const unsigned long seed = argc > 1 ? strtoul(argv[1], NULL, 10) : 1, cases = argc > 2 ? strtoul(argv[2], NULL, 10) : 500;
    const unsigned long first = argc > 3 ? strtoul(argv[3], NULL, 10) : 0;
    int status = 0, worst = 0;

    for (unsigned long k = 0; k < WORKERS; k++) {
        if (fork() != 0) continue;
        for (unsigned long i = first + k; i < first + cases; i += WORKERS) do_case(seed, i);
        return broken > 0;
    }
    while (wait(&status) > 0)
        if (status != 0) worst = 1;
    printf("%lu cases from seed %lu: %s\n", cases, seed, worst == 0 ? "all invariants hold" : "broken as above");
    return worst;
}
