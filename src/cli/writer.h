/** Turns rows of a table into text on several threads, and writes them in the order in which they came. */
#ifndef JLT_CLI_WRITER_H
#define JLT_CLI_WRITER_H

#include <stddef.h>
#include <stdio.h>

#include "core/status.h"

/** A function that writes one row to the stream that it is given. With several threads it runs several times at once, each time
 *  with another stream. */
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

/** Open a writer of rows, `width` bytes each. room: how many rows are gathered before they are written; 1: each is written as it
 *  comes, by the caller's thread. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_writer_open(jlt_writer *self, FILE *stream, jlt_writer_text text, void *context, size_t width,
                                       size_t room, unsigned threads);
void jlt_writer_close(jlt_writer *self); /* rows that wait are lost; legal when zeroed */

/** Copy a row to those that wait, and write them when they are `room`; write those that wait. Errors: NOMEM; IO, as ferror(stream)
 *  tells. */
JLT_CHECKED jlt_status jlt_writer_put(jlt_writer *self, const void *row);
JLT_CHECKED jlt_status jlt_writer_flush(jlt_writer *self);

#endif
