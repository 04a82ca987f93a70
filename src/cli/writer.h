/** Turns rows of a table into text on several threads, and writes them in the order in which they came. */
#ifndef JLT_CLI_WRITER_H
#define JLT_CLI_WRITER_H

#include <stddef.h>
#include <stdio.h>

#include "core/status.h"

/** Write one row; several at once, each to a stream of its own, when there are several threads. */
typedef void (*jlt_writer_text)(FILE *stream, void *context, const void *row);

typedef struct {
    FILE *stream;
    jlt_writer_text text;
    void *context;
    size_t width; /* bytes of a row */
    unsigned threads;
    size_t room, count; /* rows that wait */
    char *rows;
} jlt_writer;

/** room: rows that are written together; 1: each as it comes, by the caller's thread alone. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_writer_open(jlt_writer *self, FILE *stream, jlt_writer_text text, void *context, size_t width,
                                       size_t room, unsigned threads);
void jlt_writer_close(jlt_writer *self); /* rows that wait are lost; legal when zeroed */

/** Errors: NOMEM; IO, as for ferror(stream). */
JLT_CHECKED jlt_status jlt_writer_put(jlt_writer *self, const void *row);
JLT_CHECKED jlt_status jlt_writer_flush(jlt_writer *self);

#endif
