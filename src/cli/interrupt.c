#include "cli/interrupt.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>

enum { SECONDS = 1, SECONDS_TO_DRAW = 10, FILES = 8 };

/* Handlers can use only globals. Handlers may run on several threads at once, as libraries start threads that receive signals too,
 * so that what they share is set atomically. */
static volatile sig_atomic_t raised; /* the first signal that asked the program to end; 0: none */
static volatile sig_atomic_t polled; /* a command looks at `raised` */
static volatile sig_atomic_t child;  /* the process to which signals are passed on; 0: none */
static double raised_at;
static int first;                    /* the same as `raised`, set atomically: decides which handler is the first */
static int phase;                    /* FREE, HELD while files change, ENDING for good; set atomically */
static int due;                      /* a signal that ends the program once files no longer change; set atomically */
static const jlt_file *files[FILES];

enum { FREE, HELD, ENDING };

static const int asking[] = { SIGINT, SIGTERM, SIGHUP };
static const int ending[] = { SIGPIPE, SIGQUIT, SIGXCPU, SIGALRM };

enum { ASKING = sizeof asking / sizeof *asking, ENDING_COUNT = sizeof ending / sizeof *ending };

static void say(const char *text)
{
    ssize_t written = write(STDERR_FILENO, text, strlen(text));
    (void)written; /* there is nowhere else to say it */
}

/* End by the signal itself, with its default action, so that the parent sees what ended the program. */
static void die(int signal_number)
{
    struct sigaction action = { .sa_handler = SIG_DFL };
    sigset_t only;

    sigemptyset(&action.sa_mask);
    sigaction(signal_number, &action, NULL);
    sigemptyset(&only);
    sigaddset(&only, signal_number);
    pthread_sigmask(SIG_UNBLOCK, &only, NULL);
    raise(signal_number);
    _exit(128 + signal_number);
}

/* Remove the files under way. late: the command was asked to end a second ago, so save the whole rows of each file instead. */
static void clear_away(bool late)
{
    for (int i = 0; i < FILES; i++) {
        const jlt_file *file = files[i];
        if (file == NULL || file->temporary == NULL) continue;
        const bool saved = late && jlt_file_commit_lines(file) == JLT_OK;
        if (!saved) unlink(file->temporary);
        say(saved ? "jellett: ended; the whole rows so far are saved in " : "jellett: ended; nothing is saved in ");
        say(file->target);
        say("\n");
    }
}

/* End the program at once, or, while files are held, at jlt_interrupt_release. */
static void end_now(int signal_number)
{
    int free_phase = FREE;

    __atomic_store_n(&due, signal_number, __ATOMIC_SEQ_CST);
    if (!__atomic_compare_exchange_n(&phase, &free_phase, ENDING, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST)) return;
    clear_away(signal_number == SIGALRM);
    if (signal_number != SIGPIPE) say("jellett: interrupted; what was not saved by now is lost\n");
    die(signal_number == SIGALRM && first != 0 ? first : signal_number);
}

double jlt_interrupt_clock(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void meet(int signal_number, siginfo_t *about, void *unused)
{
    const int reason = errno;
    int none = 0;

    (void)unused;
    /* A signal from the terminal (si_code > 0) reaches the child by itself, as it goes to the whole process group. */
    if (child > 0 && about->si_code <= 0) kill((pid_t)child, signal_number);
    if (__atomic_compare_exchange_n(&first, &none, signal_number, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST)) {
        raised_at = jlt_interrupt_clock();
        raised = signal_number;
        if (!polled) end_now(signal_number);
        else if (child == 0) alarm(SECONDS);
    } else if (raised != 0 && child == 0 && jlt_interrupt_clock() - raised_at >= SECONDS) {
        end_now(signal_number);
    }
    errno = reason;
}

static void end_by(int signal_number)
{
    const int reason = errno;

    end_now(signal_number);
    errno = reason;
}

static bool is_ignored(int signal_number)
{
    struct sigaction before;

    return sigaction(signal_number, NULL, &before) == 0 && before.sa_handler == SIG_IGN;
}

void jlt_interrupt_begin(void)
{
    struct sigaction ask = { .sa_flags = SA_SIGINFO | SA_RESTART }, end = { .sa_flags = SA_RESTART };

    ask.sa_sigaction = meet;
    end.sa_handler = end_by;
    sigemptyset(&ask.sa_mask);
    for (int i = 0; i < ASKING; i++) sigaddset(&ask.sa_mask, asking[i]);
    for (int i = 0; i < ENDING_COUNT; i++) sigaddset(&ask.sa_mask, ending[i]);
    end.sa_mask = ask.sa_mask;
    /* Leave ignored signals ignored: a shell starts background jobs with SIGINT ignored, and nohup its command with SIGHUP. */
    for (int i = 0; i < ASKING; i++)
        if (!is_ignored(asking[i])) sigaction(asking[i], &ask, NULL);
    for (int i = 0; i < ENDING_COUNT; i++) /* SIGALRM is this program's own clock */
        if (ending[i] == SIGALRM || !is_ignored(ending[i])) sigaction(ending[i], &end, NULL);
    signal(SIGXFSZ, SIG_IGN); /* so that the write fails, and is reported like any other failure */
    signal(SIGCHLD, SIG_DFL); /* where it is ignored, as some parents leave it, no child keeps its status to be waited for */
}

const volatile sig_atomic_t *jlt_interrupt_install(void)
{
    polled = 1;
    return &raised;
}

bool jlt_interrupt_asked(void) { return raised != 0; }

static void block_asking(sigset_t *before)
{
    sigset_t asked;

    sigemptyset(&asked);
    for (int i = 0; i < ASKING; i++) sigaddset(&asked, asking[i]);
    pthread_sigmask(SIG_BLOCK, &asked, before);
}

void jlt_interrupt_spare(size_t threads)
{
    sigset_t before, same;

    block_asking(&before);
#if defined(_OPENMP)
#pragma omp parallel num_threads((int)threads) private(same)
#endif
    block_asking(&same);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}

void jlt_interrupt_draw(void)
{
    if (raised != 0 && child == 0) alarm(SECONDS_TO_DRAW);
}

void jlt_interrupt_obey(void)
{
    if (raised != 0) jlt_interrupt_end(raised);
}

void jlt_interrupt_end(int signal_number)
{
    alarm(SECONDS); /* the flush may block on a pipe that nobody reads */
    fflush(stdout);
    fprintf(stderr, "jellett: ended by signal %d\n", signal_number);
    die(signal_number);
    _Exit(128 + signal_number);
}

void jlt_interrupt_hold(void)
{
    int free_phase = FREE;

    if (__atomic_compare_exchange_n(&phase, &free_phase, HELD, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST)) return;
    while (free_phase == ENDING) pause(); /* another thread ends the program */
}

void jlt_interrupt_release(void)
{
    __atomic_store_n(&phase, FREE, __ATOMIC_SEQ_CST);
    const int signal_number = __atomic_load_n(&due, __ATOMIC_SEQ_CST);
    if (signal_number != 0) end_now(signal_number);
}

void jlt_interrupt_remember(const jlt_file *file)
{
    for (int i = 0; i < FILES; i++)
        if (files[i] == NULL) {
            files[i] = file;
            return;
        }
}

void jlt_interrupt_forget(const jlt_file *file)
{
    for (int i = 0; i < FILES; i++)
        if (files[i] == file) files[i] = NULL;
}

void jlt_interrupt_abandon(void)
{
    clear_away(false);
}

pid_t jlt_interrupt_fork(void)
{
    sigset_t before;
    pid_t made;

    polled = 1;
    block_asking(&before);
    made = fork();
    if (made == 0) {
        prctl(PR_SET_PDEATHSIG, SIGTERM); /* end also if the parent is killed and can pass nothing on */
        polled = 0;
        raised = 0;
        first = due = 0;
        for (int i = 0; i < FILES; i++) files[i] = NULL; /* what the parent writes is not the child's to save or remove */
    } else if (made > 0) {
        child = (sig_atomic_t)made;
        if (raised != 0) kill(made, raised);
    }
    const int reason = errno;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = reason;
    return made;
}

int jlt_interrupt_alone(void)
{
    child = 0;
    return raised;
}
