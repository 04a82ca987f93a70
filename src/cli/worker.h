/** Computes pieces of work, which are command lines, one after the other in a process of its own, and takes what they write. A
 *  crash or a signal ends that process alone, and the next piece begins a new one. */
#ifndef JLT_CLI_WORKER_H
#define JLT_CLI_WORKER_H

#include <signal.h>
#include <sys/types.h>

#include "cli/shelf.h"

typedef struct {
    const jlt_work *work;
    const volatile sig_atomic_t *interrupt; /* the signal that is to end this program, else 0 */
    int output, error;  /* files in memory that the commands write to */
    int line;           /* to the process: what it is to compute goes out, statuses come back; -1: there is none */
    pid_t process;
    size_t computed;    /* pieces by this process */
    size_t alone;       /* so many pieces more are computed by themselves: a process was ended, by one of those it had begun
                           together */
    char *rows, *words; /* what the last piece wrote, each ended by a NUL; owned */
    size_t rows_size, words_size;
} jlt_worker;

/** Open a worker; close it with jlt_worker_close, whatever is returned. `work` must outlive it. */
jlt_exit jlt_worker_open(jlt_worker *self, const jlt_work *work);
void jlt_worker_close(jlt_worker *self);

/** Compute a piece. Out: *status, of its command; *by, the signal that ended it, and then the status means nothing, else 0. What
 *  ends the process while pieces are computed together ends none but the one that does so by itself as well. Says what is wrong on
 *  this side. Cost: beside the command's own about 0.3 ms. */
jlt_exit jlt_worker_run(jlt_worker *self, jlt_exit *status, int *by, size_t piece);

#endif
