/** Writes rows as they come: to standard output, or to a file that appears under its name when it is closed; as text, or, if the
 *  name ends in .npy, as a NumPy array. */
#ifndef JLT_CLI_STREAM_H
#define JLT_CLI_STREAM_H

#include <stdio.h>

#include "cli/command.h"
#include "report/npy.h"

typedef struct {
    FILE *file;     /* callers write CSV here, also for an array */
    jlt_npy *array; /* NULL: the file is text */
    char *buffer;   /* of `file`, for an array */
    int reason;     /* errno of the first failure to write the array; 0: none */
    jlt_file place; /* all zeros for standard output */
    const char *path;
} jlt_stream;

/** Whether a file of this name is written as an array of NumPy. NULL is legal. */
bool jlt_stream_is_array(const char *path);

/** Open a stream to a file, or to standard output where path is NULL or "-". It must not move after that. */
jlt_exit jlt_stream_open(jlt_stream *self, const char *path);

/** Flush, and rename the file to its path. If not everything could be written, the file keeps the whole rows that could be, and the
 *  message says so. */
jlt_exit jlt_stream_close(jlt_stream *self);

/** Write a finished table, as jlt_command_deliver does, or as a NumPy array if the path ends in .npy. */
jlt_exit jlt_stream_deliver(jlt_command_output *output, const char *path);

/* Give up: remove the temporary file. Legal on a closed or zeroed stream. */
void jlt_stream_discard(jlt_stream *self);

#endif
