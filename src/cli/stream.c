#include "cli/stream.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/interrupt.h"

static jlt_exit cannot_write(const jlt_stream *self, int reason)
{
    errno = reason;
    return jlt_command_cannot_write(self->path);
}

jlt_exit jlt_stream_open(jlt_stream *self, const char *path)
{
    jlt_exit code = JLT_EXIT_DONE;
    jlt_status st;

    *self = (jlt_stream){ .path = path };
    if (jlt_command_is_standard_output(path)) {
        self->path = "standard output";
        self->file = stdout;
        return JLT_EXIT_DONE;
    }
    jlt_interrupt_hold();
    st = jlt_file_begin(&self->place, path);
    if (st == JLT_OK) self->file = fdopen(self->place.descriptor, "w");
    if (self->file != NULL) jlt_interrupt_remember(&self->place);
    else code = st == JLT_ERR_IO ? cannot_write(self, errno) : jlt_command_no_memory();
    if (self->file == NULL) jlt_file_end(&self->place);
    jlt_interrupt_release();
    return code;
}

/* What is on the disk of a file that could not be written to its end, or on its way through. */
static jlt_exit save_rows(const jlt_stream *self, int reason)
{
    if (self->place.temporary == NULL || jlt_file_commit_lines(&self->place) != JLT_OK) return cannot_write(self, reason);
    return jlt_command_fail(JLT_EXIT_IO, "cannot write all rows to '%s': %s; the whole rows before are saved there", self->path,
                            strerror(reason));
}

jlt_exit jlt_stream_close(jlt_stream *self)
{
    jlt_exit code = JLT_EXIT_DONE;

    errno = 0;
    if (fflush(self->file) != 0 || ferror(self->file)) {
        const int reason = errno != 0 ? errno : EIO;
        jlt_interrupt_hold();
        code = save_rows(self, reason);
        clearerr(self->file);
    } else {
        jlt_interrupt_hold();
        if (self->file != stdout && jlt_file_commit(&self->place) != JLT_OK) code = cannot_write(self, errno);
    }
    jlt_interrupt_release();
    jlt_stream_discard(self);
    return code;
}

void jlt_stream_discard(jlt_stream *self)
{
    if (self->file == NULL) return;
    jlt_interrupt_hold();
    if (self->file != stdout) fclose(self->file);
    self->place.descriptor = -1;
    jlt_interrupt_forget(&self->place);
    jlt_file_end(&self->place);
    jlt_interrupt_release();
    *self = (jlt_stream){ .path = self->path };
}
