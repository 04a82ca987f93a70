/** Rows written as they come: to standard output, or to a file that appears under its name when it is closed. */
#ifndef JLT_CLI_STREAM_H
#define JLT_CLI_STREAM_H

#include <stdio.h>

#include "cli/command.h"
#include "report/file.h"

typedef struct {
    FILE *file;
    jlt_file place; /* zeroed for standard output */
    const char *path;
} jlt_stream;

/** path NULL or "-": standard output. Says what is wrong on standard error. The stream must not move after that. */
jlt_exit jlt_stream_open(jlt_stream *self, const char *path);

/** Flush, and give a file its name. Where not all could be written, a file takes the whole rows that were; says so. */
jlt_exit jlt_stream_close(jlt_stream *self);

/* Give up: remove the temporary file. Legal on a closed or zeroed stream. */
void jlt_stream_discard(jlt_stream *self);

#endif
