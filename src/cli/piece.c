#include "cli/piece.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/interrupt.h"
#include "cli/program.h"

jlt_exit jlt_piece_open(jlt_piece *self)
{
    *self = (jlt_piece){ memfd_create("rows", MFD_CLOEXEC), memfd_create("words", MFD_CLOEXEC), NULL, NULL, 0, 0 };
    if (self->output >= 0 && self->error >= 0) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_IO, "a file in memory cannot be made: %s", strerror(errno));
}

void jlt_piece_close(jlt_piece *self)
{
    if (self->output >= 0) close(self->output);
    if (self->error >= 0) close(self->error);
    free(self->rows);
    free(self->words);
    *self = (jlt_piece){ -1, -1, NULL, NULL, 0, 0 };
}

/* All that is in the file, which is empty after. */
static jlt_exit take(char **text, size_t *size, int descriptor)
{
    struct stat about;
    size_t used = 0;

    free(*text);
    *text = NULL;
    *size = 0;
    if (fstat(descriptor, &about) != 0) return jlt_command_fail(JLT_EXIT_IO, "a file in memory: %s", strerror(errno));
    *text = malloc((size_t)about.st_size + 1);
    if (*text == NULL) return jlt_command_no_memory();
    while (used < (size_t)about.st_size) {
        const ssize_t got = pread(descriptor, *text + used, (size_t)about.st_size - used, (off_t)used);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return jlt_command_fail(JLT_EXIT_IO, "a file in memory: %s", strerror(errno));
        used += (size_t)got;
    }
    (*text)[used] = '\0';
    *size = used;
    if (ftruncate(descriptor, 0) == 0 && lseek(descriptor, 0, SEEK_SET) == 0) return JLT_EXIT_DONE;
    return jlt_command_fail(JLT_EXIT_IO, "a file in memory: %s", strerror(errno));
}

jlt_exit jlt_piece_run(jlt_piece *self, int *ending, int *by, const jlt_command *command, char **argv, int argc)
{
    int status = 0;
    pid_t child;
    jlt_exit code;

    *ending = *by = 0;
    fflush(stdout);
    child = jlt_interrupt_fork();
    if (child < 0) return jlt_command_fail(JLT_EXIT_NUMERICAL, "cannot start %s: %s", command->name, strerror(errno));
    if (child == 0) {
        if (dup2(self->output, STDOUT_FILENO) < 0 || dup2(self->error, STDERR_FILENO) < 0) _exit(JLT_EXIT_IO);
        exit((int)jlt_program_run(command, argc, argv));
    }
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    *ending = jlt_interrupt_alone();
    if (WIFSIGNALED(status)) {
        *by = WTERMSIG(status);
        if (*by == SIGINT || *by == SIGTERM || *by == SIGHUP) *ending = *by;
    }
    code = take(&self->rows, &self->rows_size, self->output);
    if (code == JLT_EXIT_DONE) code = take(&self->words, &self->words_size, self->error);
    return code != JLT_EXIT_DONE ? code : WIFEXITED(status) ? (jlt_exit)WEXITSTATUS(status) : JLT_EXIT_NUMERICAL;
}
