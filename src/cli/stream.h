/** Rows written as they come: to standard output, or to a file that appears under its name when it is closed; as text, or, where the
 *  name ends in .npy, as an array of NumPy. */
#ifndef JLT_CLI_STREAM_H
#define JLT_CLI_STREAM_H

#include <stdio.h>

#include "cli/command.h"
#include "report/npy.h"

typedef struct {
    FILE *file;    /* takes text, whatever becomes of it */
    jlt_npy *array; /* NULL: none */
    int reason;     /* errno when the array failed first; 0: it did not */
    jlt_file place; /* zeroed for standard output */
    const char *path;
} jlt_stream;

/** Whether a file of this name is written as an array. */
bool jlt_stream_is_array(const char *path);

/** path NULL or "-": standard output. Says what is wrong on standard error. The stream must not move after that. */
jlt_exit jlt_stream_open(jlt_stream *self, const char *path);

/** Flush, and give a file its name. Where not all could be written, a file takes the whole rows that were; says so. */
jlt_exit jlt_stream_close(jlt_stream *self);

/** A table that is all there, as jlt_command_deliver. */
jlt_exit jlt_stream_deliver(jlt_command_output *output, const char *path);

/* Give up: remove the temporary file. Legal on a closed or zeroed stream. */
void jlt_stream_discard(jlt_stream *self);

#endif
