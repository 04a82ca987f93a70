#include "cli/worker.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/interrupt.h"

/* After this many pieces the child is replaced by a new one, so that resources that a command does not release cannot add up. */
enum { PIECES_MAX = 1024 };

jlt_exit jlt_worker_open(jlt_worker *self, const jlt_work *work)
{
    *self = (jlt_worker){ .work = work, .interrupt = jlt_interrupt_install(), .output = memfd_create("rows", MFD_CLOEXEC),
                          .error = memfd_create("words", MFD_CLOEXEC), .line = -1 };
    if (self->output >= 0 && self->error >= 0) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_IO, "a file in memory cannot be made: %s", strerror(errno));
}

static bool send_all(int line, const void *data, size_t size)
{
    ssize_t sent;

    do sent = send(line, data, size, MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    return sent == (ssize_t)size;
}

static bool receive_all(int line, void *data, size_t size)
{
    ssize_t got;

    do got = recv(line, data, size, MSG_WAITALL);
    while (got < 0 && errno == EINTR);
    return got == (ssize_t)size;
}

typedef struct {
    size_t piece;
    size_t alone; /* 0 or 1; a size_t, so that the structure has no padding */
} request;

/* The child: run pieces until the socket is closed. */
_Noreturn static void serve(const jlt_worker *self, int line)
{
    static jlt_shelf shelf;
    request wanted;

    shelf.count = shelf.taken = 0; /* of a sweep within a piece of a study: what the process above has begun stays its own */
    if (dup2(self->output, STDOUT_FILENO) < 0 || dup2(self->error, STDERR_FILENO) < 0) _exit(JLT_EXIT_IO);
    while (receive_all(line, &wanted, sizeof wanted)) {
        const int status = (int)jlt_shelf_run(&shelf, self->work, wanted.piece, wanted.alone != 0);
        if (jlt_command_lacked_memory() && fflush(stdout) == 0) _exit(JLT_EXIT_NUMERICAL); /* its rows are not all there */
        if (fflush(stdout) != 0 || !send_all(line, &status, sizeof status)) _exit(JLT_EXIT_IO);
    }
    _exit(JLT_EXIT_DONE);
}

static jlt_exit begin(jlt_worker *self)
{
    int lines[2];

    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, lines) != 0)
        return jlt_command_fail(JLT_EXIT_NUMERICAL, "cannot start %s: %s", self->work->command->name, strerror(errno));
    fflush(stdout);
    self->process = jlt_interrupt_fork();
    if (self->process == 0) {
        close(lines[0]);
        serve(self, lines[1]);
    }
    close(lines[1]);
    self->line = lines[0];
    self->computed = 0;
    if (self->process > 0) return JLT_EXIT_DONE;
    close(lines[0]);
    self->line = -1;
    return jlt_command_fail(JLT_EXIT_NUMERICAL, "cannot start %s: %s", self->work->command->name, strerror(errno));
}

/* End the child. Returns its wait status, as from waitpid; 0 if there was no child. */
static int end(jlt_worker *self)
{
    int status = 0;

    if (self->line < 0) return 0;
    close(self->line);
    self->line = -1;
    while (waitpid(self->process, &status, 0) < 0 && errno == EINTR) {}
    (void)jlt_interrupt_alone();
    return status;
}

void jlt_worker_close(jlt_worker *self)
{
    (void)end(self);
    if (self->output >= 0) close(self->output);
    if (self->error >= 0) close(self->error);
    free(self->rows);
    free(self->words);
    *self = (jlt_worker){ .output = -1, .error = -1, .line = -1 };
}

/* Take everything out of a file in memory, and empty it. Out: *text, ended by a NUL. */
static bool take(char **text, size_t *size, int descriptor)
{
    struct stat about;
    size_t used = 0;

    free(*text);
    *text = NULL;
    if (fstat(descriptor, &about) != 0 || (*text = malloc((size_t)about.st_size + 1)) == NULL) return false;
    while (used < (size_t)about.st_size) {
        const ssize_t got = pread(descriptor, *text + used, (size_t)about.st_size - used, (off_t)used);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        used += (size_t)got;
    }
    (*text)[used] = '\0';
    *size = used;
    return ftruncate(descriptor, 0) == 0 && lseek(descriptor, 0, SEEK_SET) == 0;
}

/* Have the child compute one piece; start a child if there is none. */
static jlt_exit ask(jlt_worker *self, jlt_exit *status, int *by, const request *wanted)
{
    int answer = 0;

    *by = 0;
    if (self->computed == PIECES_MAX) (void)end(self);
    if (self->line < 0) JLT_PASS(begin(self));
    self->computed++;
    if (!send_all(self->line, wanted, sizeof *wanted) || !receive_all(self->line, &answer, sizeof answer)) {
        const int ending = end(self); /* it ended by a signal, or by exit(), as argp does on wrong options */
        answer = WEXITSTATUS(ending);
        if (WIFSIGNALED(ending)) *by = WTERMSIG(ending);
        else if (answer == JLT_EXIT_NUMERICAL || answer == JLT_EXIT_FAILED) *by = JLT_WORKER_WITHOUT_MEANS;
    }
    *status = (jlt_exit)answer;
    return JLT_EXIT_DONE;
}

jlt_exit jlt_worker_run(jlt_worker *self, jlt_exit *status, int *by, size_t piece)
{
    const bool alone = self->work->command->together == NULL || self->alone > 0;
    jlt_exit code = ask(self, status, by, &(request){ .piece = piece, .alone = alone });

    if (self->alone > 0) self->alone--;
    if (code == JLT_EXIT_DONE && *by != 0 && !alone && *self->interrupt == 0) {
        self->alone = JLT_SHELF_RUNS;
        if (ftruncate(self->output, 0) == 0 && ftruncate(self->error, 0) == 0 && lseek(self->output, 0, SEEK_SET) == 0 &&
            lseek(self->error, 0, SEEK_SET) == 0)
            code = ask(self, status, by, &(request){ .piece = piece, .alone = 1 });
    }
    if (code != JLT_EXIT_DONE) return code;
    if (take(&self->rows, &self->rows_size, self->output) && take(&self->words, &self->words_size, self->error))
        return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_IO, "a file in memory cannot be read: %s", strerror(errno));
}
