#include "cli/stream.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/interrupt.h"

/* How much text is passed to an array at a time. */
enum { BUFFER = 1 << 18 };

static jlt_exit cannot_write(const jlt_stream *self, int reason)
{
    errno = reason;
    return jlt_command_cannot_write(self->file == stdout ? NULL : self->path);
}

/* The write function of an array's FILE. Signals are held meanwhile, since rows may be moved in the file. */
static ssize_t take(void *stream, const char *text, size_t size)
{
    jlt_stream *self = stream;

    if (self->array == NULL) return (ssize_t)size; /* the stream is being discarded */
    jlt_interrupt_hold();
    errno = EINVAL;
    const jlt_status st = jlt_npy_take(self->array, text, size);
    if (st == JLT_ERR_NOMEM) errno = ENOMEM;
    if (st != JLT_OK && self->reason == 0) self->reason = errno;
    jlt_interrupt_release();
    return st == JLT_OK ? (ssize_t)size : 0;
}

/* Open the FILE that takes the rows of a file that was begun. */
static jlt_status open_rows(jlt_stream *self)
{
    if (!jlt_stream_is_array(self->path)) {
        self->file = fdopen(self->place.descriptor, "w");
        return self->file != NULL ? JLT_OK : JLT_ERR_NOMEM;
    }
    const jlt_status st = jlt_npy_create(&self->array, &self->place);
    if (st == JLT_OK) self->file = fopencookie(self, "w", (cookie_io_functions_t){ .write = take });
    if (self->file == NULL) return st != JLT_OK ? st : JLT_ERR_NOMEM;
    self->buffer = malloc(BUFFER);
    return self->buffer != NULL && setvbuf(self->file, self->buffer, _IOFBF, BUFFER) == 0 ? JLT_OK : JLT_ERR_NOMEM;
}

bool jlt_stream_is_array(const char *path)
{
    return !jlt_command_is_standard_output(path) && jlt_file_ends(path, ".npy");
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
    if (st == JLT_OK) st = open_rows(self);
    if (st == JLT_OK) jlt_interrupt_remember(&self->place);
    else if (st == JLT_ERR_IO) code = cannot_write(self, errno);
    else if (st == JLT_ERR_UNSUPPORTED) code = jlt_command_fail(JLT_EXIT_IO, "cannot write '%s': arrays go to files alone", path);
    else code = jlt_command_no_memory();
    jlt_interrupt_release();
    if (st != JLT_OK) jlt_stream_discard(self);
    return code;
}

/* Save the whole rows of a file that could not be written completely. Returns the exit status, with a message. */
static jlt_exit save_rows(const jlt_stream *self, int reason)
{
    if (self->place.temporary == NULL || jlt_file_commit_lines(&self->place) != JLT_OK) return cannot_write(self, reason);
    return jlt_command_fail(JLT_EXIT_IO, "cannot write all rows to '%s': %s; the whole rows before are saved there", self->path,
                            strerror(reason));
}

/* The errno of an earlier failed write, which stdio does not keep: write one more byte to see. If it succeeds, the byte is cut off
 * with the incomplete row. */
static int reason_again(const jlt_stream *self)
{
    if (self->array != NULL) return EIO;
    return write(fileno(self->file), "", 1) < 0 ? errno : EIO;
}

jlt_exit jlt_stream_close(jlt_stream *self)
{
    jlt_exit code = JLT_EXIT_DONE;

    errno = 0;
    if (fflush(self->file) != 0 || ferror(self->file) || (self->array != NULL && self->place.whole == 0)) {
        const int reason = self->reason != 0 ? self->reason : errno != 0 ? errno : reason_again(self);
        jlt_interrupt_hold();
        code = save_rows(self, reason);
        clearerr(self->file);
    } else {
        jlt_interrupt_hold();
        if (jlt_interrupt_asked() && self->place.temporary != NULL && !jlt_file_has_row(&self->place))
            code = jlt_command_fail(JLT_EXIT_IO, "interrupted before the first row: nothing is saved in %s", self->path);
        else if (self->file != stdout && jlt_file_commit(&self->place) != JLT_OK) code = save_rows(self, errno);
    }
    jlt_interrupt_release();
    jlt_stream_discard(self);
    return code;
}

jlt_exit jlt_stream_deliver(jlt_command_output *output, const char *path)
{
    jlt_stream stream;
    jlt_exit code;

    if (!jlt_stream_is_array(path)) return jlt_command_deliver(output, path);
    code = jlt_command_close(output) == JLT_OK ? jlt_stream_open(&stream, path) : jlt_command_no_memory();
    if (code == JLT_EXIT_DONE) {
        fwrite(output->text, 1, output->size, stream.file);
        code = jlt_stream_close(&stream);
    }
    jlt_command_discard(output);
    return code;
}

void jlt_stream_discard(jlt_stream *self)
{
    jlt_interrupt_hold();
    jlt_npy_destroy(self->array);
    if (self->file != NULL && self->file != stdout) {
        if (self->array == NULL) self->place.descriptor = -1;
        self->array = NULL;
        fclose(self->file);
    }
    free(self->buffer);
    jlt_interrupt_forget(&self->place);
    jlt_file_end(&self->place);
    jlt_interrupt_release();
    *self = (jlt_stream){ .path = self->path };
}
