#include "cli/stream.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static jlt_exit cannot_write(const jlt_stream *self, int reason)
{
    errno = reason;
    return jlt_command_cannot_write(self->path);
}

jlt_exit jlt_stream_open(jlt_stream *self, const char *path)
{
    static const char suffix[] = ".XXXXXX";
    struct stat about;
    mode_t mask;
    int descriptor, reason;

    *self = (jlt_stream){ .path = path };
    if (path == NULL || strcmp(path, "-") == 0) {
        self->path = "standard output";
        self->file = stdout;
        return JLT_EXIT_DONE;
    }
    if (stat(path, &about) == 0 && !S_ISREG(about.st_mode)) {
        self->file = fopen(path, "w"); /* a device */
        return self->file != NULL ? JLT_EXIT_DONE : cannot_write(self, errno);
    }
    self->temporary = malloc(strlen(path) + sizeof suffix);
    if (self->temporary == NULL) return jlt_command_no_memory();
    strcpy(self->temporary, path);
    strcat(self->temporary, suffix);
    mask = umask(0);
    umask(mask);
    descriptor = mkstemp(self->temporary);
    if (descriptor >= 0) self->file = fdopen(descriptor, "w");
    if (self->file != NULL && fchmod(descriptor, 0666 & ~mask) == 0) return JLT_EXIT_DONE;
    reason = errno;
    if (descriptor >= 0) {
        unlink(self->temporary);
        if (self->file == NULL) close(descriptor);
    }
    jlt_stream_discard(self);
    return cannot_write(self, reason);
}

jlt_exit jlt_stream_close(jlt_stream *self)
{
    jlt_exit code = JLT_EXIT_DONE;

    errno = 0;
    if (fflush(self->file) != 0 || ferror(self->file)) {
        code = cannot_write(self, errno != 0 ? errno : EIO);
        clearerr(self->file);
    } else if (self->temporary != NULL) {
        if (fsync(fileno(self->file)) != 0 || rename(self->temporary, self->path) != 0) code = cannot_write(self, errno);
    }
    if (code == JLT_EXIT_DONE && self->temporary != NULL) {
        free(self->temporary);
        self->temporary = NULL;
    }
    jlt_stream_discard(self);
    return code;
}

void jlt_stream_discard(jlt_stream *self)
{
    if (self->file != NULL && self->file != stdout) fclose(self->file);
    if (self->temporary != NULL) unlink(self->temporary);
    free(self->temporary);
    *self = (jlt_stream){ .path = self->path };
}
