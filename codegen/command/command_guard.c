/* Proofs within bounds: a worker process settles one claim after the other and sends each verdict through a pipe. Algebra can
 * outgrow any machine, and libraries end their process when memory is out: then the worker dies, its claim is not settled, by
 * name, and another worker goes on with the next. A worker that dies without a word of memory has a fault, which must not pass for
 * a bound. */
#include "command/command_guard.h"

#include "challenge/challenge.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { MEMORY_MIB = 1536, PATIENCE = 30, WORDS_SIZE = 200 };
enum { WITNESS_POINTS = 24, WITNESS_POINTS_OF_SOLVER = 100, WITNESS_SECONDS = 1, WITNESS_SIZE = 1 << 20 };

#ifdef JLT_SANITIZED
enum { ADDRESS_SPACE_IS_BOUNDED = 0 };
#else
enum { ADDRESS_SPACE_IS_BOUNDED = 1 };
#endif

/* A verdict in the pipe; its texts follow, without final zeros. SIZE_MAX stands for no text. */
typedef struct {
    size_t index;
    ttc_proof_status status;
    ttc_proof_ending ending;
    bool has_smooth_density, relies_on_solver;
    double seconds;
    size_t lengths[3];
} message;

/* When a claim is late: by processor time, so that other processes do not count; by the clock, if it only waits. */
typedef struct {
    clockid_t processor; /* of the worker */
    double processor_end, clock_end;
} bounds;

/* Seconds; 0 if the clock's process has ended. */
static double time_of(clockid_t clock)
{
    struct timespec time;
    return clock_gettime(clock, &time) == 0 ? (double)time.tv_sec + 1e-9 * (double)time.tv_nsec : 0;
}

/* Seconds before the worker can be late. */
static double left(const bounds *b)
{
    const double processor = b->processor_end - time_of(b->processor), clock = b->clock_end - time_of(CLOCK_MONOTONIC);
    return processor < clock ? processor : clock;
}

static bool write_all(int descriptor, const void *data, size_t size)
{
    const char *at = data;
    while (size > 0) {
        ssize_t written = write(descriptor, at, size);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        at += written;
        size -= (size_t)written;
    }
    return true;
}

static bool send_proof(int descriptor, size_t index, const ttc_proof *proof)
{
    const char *texts[3] = { proof->remainder, proof->point, proof->note };
    message m;
    memset(&m, 0, sizeof m);
    m.index = index;
    m.status = proof->status;
    m.ending = proof->ending;
    m.has_smooth_density = proof->has_smooth_density;
    m.relies_on_solver = proof->relies_on_solver;
    m.seconds = proof->seconds;
    for (int i = 0; i < 3; i++) m.lengths[i] = texts[i] == NULL ? SIZE_MAX : strlen(texts[i]);
    bool ok = write_all(descriptor, &m, sizeof m);
    for (int i = 0; i < 3 && ok; i++)
        if (texts[i] != NULL) ok = write_all(descriptor, texts[i], m.lengths[i]);
    return ok;
}

/* What this process may take of a resource, at most `most`. */
static rlim_t allowed(int resource, rlim_t most)
{
    struct rlimit own;
    return getrlimit(resource, &own) == 0 && own.rlim_cur < most ? own.rlim_cur : most;
}

static int table_seconds(int claim_seconds) { return 5 * claim_seconds / 2; }

unsigned ttc_guard_memory(void) { return (unsigned)(allowed(RLIMIT_AS, (rlim_t)MEMORY_MIB << 20) >> 20); }

unsigned ttc_guard_processor(int claim_seconds) { return (unsigned)allowed(RLIMIT_CPU, (rlim_t)table_seconds(claim_seconds)); }

/* Runs in the worker. What libraries print when they end it goes to `words`, and the parent reports it. */
static void work(ttc_proof_run *run, const bool *settled, int descriptor, int words)
{
    const rlim_t most = (rlim_t)ttc_guard_memory() << 20;
    const struct rlimit memory = { most, most }, core = { 0, 0 };
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* the worker ends with its parent */
    dup2(words, STDOUT_FILENO); /* FLINT 2 prints there, others on stderr */
    dup2(words, STDERR_FILENO);
    if (ADDRESS_SPACE_IS_BOUNDED) setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CORE, &core);
    for (size_t i = 0; i < ttc_proof_run_count(run); i++) {
        if (settled[i]) continue;
        ttc_proof_run_prove(run, i);
        if (!send_proof(descriptor, i, ttc_proof_run_proof(run, i))) break;
    }
}

typedef enum { READ_DONE, READ_END, READ_LATE } read_result;

static read_result read_all(int descriptor, void *data, size_t size, const bounds *b)
{
    char *at = data;
    while (size > 0) {
        struct pollfd poll_of = { .fd = descriptor, .events = POLLIN };
        const double wait = left(b);
        if (wait <= 0) return READ_LATE;
        int ready = poll(&poll_of, 1, (int)(1000 * wait) + 1);
        if (ready < 0 && errno != EINTR) return READ_END;
        if (ready <= 0) continue;
        ssize_t got = read(descriptor, at, size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return READ_END;
        at += got;
        size -= (size_t)got;
    }
    return READ_DONE;
}

static read_result receive_proof(int descriptor, ttc_proof_run *run, bool *settled, const bounds *b)
{
    message m;
    char *texts[3] = { NULL, NULL, NULL };
    read_result result = read_all(descriptor, &m, sizeof m, b);
    if (result == READ_DONE && m.index >= ttc_proof_run_count(run)) result = READ_END;
    for (int i = 0; i < 3 && result == READ_DONE; i++) {
        if (m.lengths[i] == SIZE_MAX) continue;
        texts[i] = calloc(m.lengths[i] + 1, 1);
        result = texts[i] == NULL ? READ_END : read_all(descriptor, texts[i], m.lengths[i], b);
    }
    if (result != READ_DONE) {
        for (int i = 0; i < 3; i++) free(texts[i]);
        return result;
    }
    ttc_proof verdict = { .status = m.status, .ending = m.ending, .remainder = texts[0], .point = texts[1], .note = texts[2],
                          .has_smooth_density = m.has_smooth_density, .relies_on_solver = m.relies_on_solver,
                          .seconds = m.seconds };
    ttc_proof_run_accept(run, m.index, &verdict);
    settled[m.index] = true;
    return READ_DONE;
}

static size_t first_open(const bool *settled, size_t count)
{
    size_t i = 0;
    while (i < count && settled[i]) i++;
    return i;
}

/* Words printed when an allocation fails or a number is too large to be stored, before the process ends: by FLINT and GMP, by C++,
 * by GMP, and by ttc (base/exhaustion.h). */
static bool speak_of_memory(const char *words)
{
    static const char *const signs[] = { "allocate", "bad_alloc", "overflow in mpz", "out of memory" };
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        if (strstr(words, signs[i]) != NULL) return true;
    return false;
}

/* Whether the system ended the worker: for memory, or for processor time that whoever called this program has bounded. */
static bool is_ended_by_system(int status)
{
    return WIFSIGNALED(status) && (WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGXCPU);
}

/* Why a worker that ended with this status did not send all. One that is late is killed by the parent. */
static ttc_proof_ending ending_of(read_result result, int status, const char *words)
{
    if (result == READ_LATE) return TTC_ENDED_LATE;
    if (is_ended_by_system(status)) return TTC_ENDED_BY_SYSTEM;
    return speak_of_memory(words) ? TTC_ENDED_OUT_OF_MEMORY : TTC_ENDED_BY_FAULT;
}

/* Of the seconds left for the table, those that one claim must leave to the other open claims, most of which need little. */
static double reserved(const bool *settled, size_t count, int claim_seconds, double seconds)
{
    double open = -1;
    for (size_t i = 0; i < count; i++) open += !settled[i];
    return fmin(open * claim_seconds / 40, seconds / 2);
}

static void give_up(ttc_proof_run *run, bool *settled, int claim_seconds, ttc_proof_ending ending, int status, const char *words)
{
    char text[WORDS_SIZE + 80];
    const size_t index = first_open(settled, ttc_proof_run_count(run));
    if (ending == TTC_ENDED_LATE)
        snprintf(text, sizeof text, "its proof passes the limit of %d s of processor time a claim, or of %d s a table",
                 claim_seconds, table_seconds(claim_seconds));
    else if (ending == TTC_ENDED_BY_SYSTEM)
        snprintf(text, sizeof text, TTC_GUARD_BY_SYSTEM);
    else if (ending == TTC_ENDED_OUT_OF_MEMORY)
        snprintf(text, sizeof text, "its proof passes the limit of %u MiB", ttc_guard_memory());
    else
        snprintf(text, sizeof text, "its proof fails, by %s %d%s%s", WIFSIGNALED(status) ? "signal" : "exit status",
                 WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status), words[0] != '\0' ? ": " : "", words);
    ttc_proof verdict = { .status = TTC_UNSETTLED, .ending = ending, .remainder = strdup(text) };
    ttc_proof_run_accept(run, index, &verdict);
    settled[index] = true;
}

/* Read what an ended worker printed first, as one line, shape (WORDS_SIZE,): FLINT 3 gives the reason in its second. */
static void read_words(int descriptor, char *words)
{
    ssize_t length = read(descriptor, words, WORDS_SIZE - 1);
    words[length > 0 ? length : 0] = '\0';
    for (char *c = words; *c != '\0'; c++)
        if (*c == '\n') *c = ' ';
}

/* Two pipes: for verdicts, and for last words, where a worker never waits for a reader. Returns false with none open. */
static bool open_pipes(int verdicts[2], int words[2])
{
    if (pipe(verdicts) != 0) return false;
    if (pipe(words) == 0) {
        if (fcntl(words[0], F_SETFL, O_NONBLOCK) == 0 && fcntl(words[1], F_SETFL, O_NONBLOCK) == 0) return true;
        close(words[0]);
        close(words[1]);
    }
    close(verdicts[0]);
    close(verdicts[1]);
    return false;
}

static double seconds_of(struct timeval time) { return (double)time.tv_sec + 1e-6 * (double)time.tv_usec; }

/* Processor time of all workers that have ended. */
static double spent(void)
{
    struct rusage used;
    return getrusage(RUSAGE_CHILDREN, &used) == 0 ? seconds_of(used.ru_utime) + seconds_of(used.ru_stime) : 0;
}

/* Run one worker until it is done, dead or late; its claim is then given up. In/out: *seconds, left for the table. Returns false
 * if no worker can be made. */
static bool employ(ttc_proof_run *run, bool *settled, int claim_seconds, double *seconds)
{
    int verdicts[2], words[2], status = 0;
    char said[WORDS_SIZE];
    bounds b;
    const double spent_before = spent();
    const size_t count = ttc_proof_run_count(run);
    read_result result = READ_DONE;
    if (!open_pipes(verdicts, words)) return false;
    fflush(NULL);
    pid_t worker = fork();
    if (worker == 0) {
        close(verdicts[0]);
        close(words[0]);
        work(run, settled, verdicts[1], words[1]);
        _exit(0);
    }
    close(verdicts[1]);
    close(words[1]);
    const bool ok = worker > 0 && clock_getcpuclockid(worker, &b.processor) == 0;
    while (ok && result == READ_DONE && first_open(settled, count) < count) {
        const double now = time_of(b.processor), left = *seconds - now;
        b.processor_end = now + fmin(claim_seconds, left - reserved(settled, count, claim_seconds, left));
        b.clock_end = time_of(CLOCK_MONOTONIC) + (double)PATIENCE * claim_seconds;
        result = receive_proof(verdicts[0], run, settled, &b);
    }
    if (worker > 0) {
        kill(worker, SIGKILL); /* a dead worker keeps its status */
        while (waitpid(worker, &status, 0) < 0 && errno == EINTR) continue;
        *seconds -= spent() - spent_before;
        read_words(words[0], said);
        if (result != READ_DONE) give_up(run, settled, claim_seconds, ending_of(result, status, said), status, said);
    }
    close(verdicts[0]);
    close(words[0]);
    return ok;
}

/* What a witness looks at. */
typedef struct {
    const ttc_model *model;
    ttc_resolver resolver;
    void *context;
} witness_context;

/* Looks for points at which a proved claim fails, which is an error of the prover, or of the solver, whose known errors concern
 * single points. Expressions so large that this would pass the worker's bounds are left alone. */
static char *challenge(void *context, const ttc_proof *proof)
{
    const witness_context *c = context;
    const ttc_challenge_extent extent = { .points = proof->relies_on_solver ? WITNESS_POINTS_OF_SOLVER : WITNESS_POINTS,
                                          .seed = 1, .seconds = WITNESS_SECONDS };
    ttc_challenge_result result;
    char *text = NULL;
    size_t size;
    if (ttc_graph_size(c->model->graph) * (c->model->state_count + 1) > WITNESS_SIZE) return NULL;
    if (!ttc_challenge_proof(c->model, proof, c->resolver, c->context, &extent, &result)) return NULL;
    FILE *stream = result.violated ? open_memstream(&text, &size) : NULL;
    if (stream != NULL) {
        fprintf(stream, "a point contradicts its proof, which is an error of this program: %s",
                result.text != NULL ? result.text : "");
        if (fclose(stream) != 0) text = NULL;
    }
    free(result.text);
    return text;
}

ttc_proof_report *ttc_prove_guarded(const ttc_model *model, int claim_seconds, ttc_resolver resolver, void *context)
{
    return ttc_prove_some_guarded(model, claim_seconds, NULL, NULL, resolver, context);
}

ttc_proof_report *ttc_prove_some_guarded(const ttc_model *model, int claim_seconds, ttc_proof_filter wanted, void *wanted_context,
                                         ttc_resolver resolver, void *context)
{
    ttc_proof_run *run = ttc_proof_run_create(model, resolver, context);
    ttc_proof_report *report = NULL;
    size_t count = run == NULL ? 0 : ttc_proof_run_count(run);
    bool *settled = calloc(count + 1, sizeof *settled), ok = run != NULL && settled != NULL;
    double seconds = table_seconds(claim_seconds);
    witness_context c = { model, resolver, context };
    if (ok) ttc_proof_run_set_witness(run, challenge, &c);
    for (size_t i = 0; ok && wanted != NULL && i < count; i++) settled[i] = !wanted(wanted_context, ttc_proof_run_proof(run, i));
    while (ok && first_open(settled, count) < count) {
        if (seconds <= 0) give_up(run, settled, claim_seconds, TTC_ENDED_LATE, 0, "");
        else ok = employ(run, settled, claim_seconds, &seconds);
    }
    if (ok) report = ttc_proof_run_report(run, count);
    free(settled);
    ttc_proof_run_destroy(run);
    return report;
}
