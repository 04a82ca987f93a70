/** Computes pieces of work, command lines, one after the other in a process of its own, and takes what they write: whatever
 *  ends that process leaves this one alone, and it is begun again. */
#ifndef JLT_CLI_WORKER_H
#define JLT_CLI_WORKER_H

#include <signal.h>
#include <sys/types.h>

#include "cli/command.h"

typedef struct {
    const jlt_command *command;
    char **(*arguments)(const void *context, size_t piece, int *argc); /* of a piece; for jlt_command_free. NULL: no memory */
    const void *context;
} jlt_work;

typedef struct {
    const jlt_work *work;
    const volatile sig_atomic_t *interrupt; /* the signal that is to end this program, else 0 */
    int output, error;  /* files in memory that the commands write to */
    int line;           /* to the process: numbers of pieces go out, statuses come back; -1: there is none */
    pid_t process;
    size_t computed;    /* pieces by this process */
    char *rows, *words; /* what the last piece wrote, each ended by a NUL; owned */
    size_t rows_size, words_size;
} jlt_worker;

/** For jlt_worker_close, whatever is returned. The work must stay. Says what is wrong. */
jlt_exit jlt_worker_open(jlt_worker *self, const jlt_work *work);
void jlt_worker_close(jlt_worker *self);

/** Compute a piece. Out: *status, of its command; *by, the signal that ended it, else 0, and then the status means nothing. Says
 *  what is wrong on this side. Cost: beside the command's own about 0.3 ms. */
jlt_exit jlt_worker_run(jlt_worker *self, jlt_exit *status, int *by, size_t piece);

#endif
