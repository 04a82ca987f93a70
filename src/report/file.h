/** Writes files whole or not at all. */
#ifndef JLT_REPORT_FILE_H
#define JLT_REPORT_FILE_H

#include "core/status.h"

#include <stdbool.h>
#include <stddef.h>

/** A file that is being written: first under a temporary name in the target's folder, then renamed to the target. */
typedef struct {
    int descriptor;  /* to write to; closed by jlt_file_end */
    char *target;    /* the path with symbolic links resolved; a device keeps its path */
    char *temporary; /* NULL for a device such as /dev/stdout, which is written to directly, and after the renaming */
    char *tail;      /* of a binary file: committing it keeps its first `whole` bytes and appends this, shape (tail_size,); NULL:
                        the file is text */
    size_t tail_size, whole, head; /* head: the bytes before its first row */
} jlt_file;

/** Begin a file for `path`, in an existing folder. A file that is already there keeps its content until the new one replaces it,
 *  which inherits its permissions. On failure nothing is left behind. Errors: IO (errno says why), NOMEM. */
JLT_CHECKED jlt_status jlt_file_begin(jlt_file *self, const char *path);

/** Flush the file to the disk, and rename it to its target. Does nothing for a device. Errors: IO (errno says why). */
JLT_CHECKED jlt_status jlt_file_commit(jlt_file *self);

/** Whether the file has a whole row: a line behind its comments and its line of names; of a binary file, bytes behind its head. A
 *  signal handler may call it. Returns false for a device. */
bool jlt_file_has_row(const jlt_file *self);

/** Save what is complete: cut a text file behind its last newline, a binary file to its first `whole` bytes and as much of the tail
 *  as the disk has room for, and rename it to its target. A signal handler may call it: it frees nothing, and jlt_file_end still
 *  has to be called. Errors: EMPTY, no row is complete; IO. */
JLT_CHECKED jlt_status jlt_file_commit_lines(const jlt_file *self);

/** Write `size` bytes at an offset; read `size` bytes at an offset. Errors: IO (errno says why). */
JLT_CHECKED jlt_status jlt_file_put(const jlt_file *self, const char *data, size_t size, size_t offset);
JLT_CHECKED jlt_status jlt_file_get(const jlt_file *self, char *data, size_t size, size_t offset);

/** Close the file, and remove it unless it was renamed to its target. Legal when zeroed, and twice; keeps errno. */
void jlt_file_end(jlt_file *self);

/** Write a file of this content, whole or not at all. Errors: IO (errno says why; the old file is unchanged), NOMEM. Cost: one
 *  fsync. */
JLT_CHECKED jlt_status jlt_file_write(const char *path, const char *data, size_t size);

/** Check, before long work, that jlt_file_begin could succeed for this path. Writes nothing. Errors: IO (errno says why), NOMEM. */
JLT_CHECKED jlt_status jlt_file_reachable(const char *path);

/** Whether a path ends in `ending`, such as ".npy", in small letters or capitals. */
bool jlt_file_ends(const char *path, const char *ending);

/** Whether two paths lead to the same regular file, existing or not: by symbolic or hard links, or by different names of its
 *  folder. Returns false when memory is out. */
bool jlt_file_same(const char *path, const char *other);

#endif
