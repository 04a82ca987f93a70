/** Whole files or none. */
#ifndef JLT_REPORT_FILE_H
#define JLT_REPORT_FILE_H

#include "core/status.h"

#include <stddef.h>

/** Write a file so that nobody ever sees half of it: into a temporary file beside it, flushed to the disk, then renamed.
 *  A file of that name is replaced, and stays as it was on failure; the temporary file is removed. Signals that end the
 *  program (INT, TERM, HUP) wait in this thread meanwhile, so none can leave the temporary file behind.
 *  In: path, in a folder that exists, or a device such as /dev/stdout, which is written to directly.
 *  Errors: IO (errno says why), NOMEM. Cost: one fsync. */
JLT_CHECKED jlt_status jlt_file_write(const char *path, const char *data, size_t size);

/** Whether jlt_file_write could begin at this path now: to be asked before work that takes long. Errors: IO (errno says why), NOMEM. */
JLT_CHECKED jlt_status jlt_file_reachable(const char *path);

#endif
