/** Writes files whole or not at all. */
#ifndef JLT_REPORT_FILE_H
#define JLT_REPORT_FILE_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>

/** A file that is being written: under a name of its own in the folder of its place, then moved there. */
typedef struct {
    int descriptor;  /* to write to; closed by jlt_file_end */
    char *target;    /* the place, symbolic links followed */
    char *temporary; /* NULL for a device such as /dev/stdout, which is written to directly, and once the file is in place */
    char *tail;      /* what is to follow the first `whole` bytes of a file that is no text, shape (tail_size,); NULL: it is text */
    size_t tail_size, whole;
} jlt_file;

/** Begin a file for `path`, in a folder that exists. A file that is there keeps its content and its permissions until the new
 *  one takes its place. On failure nothing is left. Errors: IO (errno says why), NOMEM. */
JLT_CHECKED jlt_status jlt_file_begin(jlt_file *self, const char *path);

/** Flush the file to the disk, and move it into place. Errors: IO (errno says why). */
JLT_CHECKED jlt_status jlt_file_commit(jlt_file *self);

/** Move into place what is whole: the lines that were written, without what follows the last newline; of a file that is no text its
 *  first `whole` bytes, and the tail as far as there is room on the disk. A signal handler may call it: it frees nothing, and the
 *  file still has to be ended.
 *  Errors: EMPTY, nothing is whole; IO. */
JLT_CHECKED jlt_status jlt_file_commit_lines(const jlt_file *self);

/** Write `size` bytes at an offset; read them back. Errors: IO (errno says why). */
JLT_CHECKED jlt_status jlt_file_put(const jlt_file *self, const char *data, size_t size, size_t offset);
JLT_CHECKED jlt_status jlt_file_get(const jlt_file *self, char *data, size_t size, size_t offset);

/** Close the file, and remove it where it was not moved into place. Legal when zeroed, and twice; keeps errno. */
void jlt_file_end(jlt_file *self);

/** Write a file of this content, whole or not at all. Errors: IO (errno says why; the old file is as it was), NOMEM. Cost: one
 *  fsync. */
JLT_CHECKED jlt_status jlt_file_write(const char *path, const char *data, size_t size);

/** Whether a file could begin at this path now: to be asked before work that takes long. Errors: IO (errno says why), NOMEM. */
JLT_CHECKED jlt_status jlt_file_reachable(const char *path);

/** Whether two paths lead to the same regular file, or would if it were there: by links, names of other folders, hard links.
 *  False when memory is out. */
bool jlt_file_same(const char *path, const char *other);

#endif
