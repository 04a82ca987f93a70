/** Computes pieces of work, each a command line, one after the other in a child process, and collects what they write. A crash or a
 *  signal ends the child alone, and the next piece starts a new one. */
#ifndef JLT_CLI_WORKER_H
#define JLT_CLI_WORKER_H

#include <signal.h>
#include <sys/types.h>

#include "cli/shelf.h"

typedef struct {
    const jlt_work *work;
    const volatile sig_atomic_t *interrupt; /* the signal that asked this program to end, else 0 */
    int output, error;  /* files in memory that are the child's standard output and standard error */
    int line;           /* socket to the child: requests go out, exit statuses come back; -1: there is no child */
    pid_t process;      /* the child */
    size_t computed;    /* pieces that this child was asked for */
    size_t alone;       /* how many of the next pieces to compute one at a time: any of them may have ended a child that was
                           computing several together */
    char *rows, *words; /* what the last piece wrote to standard output and standard error, each ended by a NUL; owned */
    size_t rows_size, words_size;
} jlt_worker;

/** Open a worker; call jlt_worker_close in the end, whatever is returned. `work` must outlive it. */
jlt_exit jlt_worker_open(jlt_worker *self, const jlt_work *work);
void jlt_worker_close(jlt_worker *self);

enum { JLT_WORKER_WITHOUT_MEANS = -1 };

/** Compute a piece. Out: *status, its command's exit status; *by, 0, or what ended the child before the command was done, and then
 *  *status means nothing: a signal, or JLT_WORKER_WITHOUT_MEANS, memory or threads that were not to be had; self->rows and
 *  self->words. If the child ends so while several pieces are under way, the piece is computed again by itself, so that a crash
 *  counts only for its cause. Returns another status than JLT_EXIT_DONE if the worker itself failed, and
 *  says why. Cost: about 0.3 ms besides the command's own. */
jlt_exit jlt_worker_run(jlt_worker *self, jlt_exit *status, int *by, size_t piece);

#endif
