/** Formats rows of a table on several threads, and writes them in the order in which they came. */
#ifndef JLT_CLI_WRITER_H
#define JLT_CLI_WRITER_H

#include <stddef.h>
#include <stdio.h>

#include "core/status.h"

/** A function that writes one row to `stream`. Several threads may call it at once, each with its own stream. */
typedef void (*jlt_writer_text)(FILE *stream, void *context, const void *row);

/** A function that completes rows, *count of them one behind another, before they are written. In/out: count, less if the rows
 *  from there on are to be left out. */
typedef jlt_status (*jlt_writer_complete)(void *context, void *rows, size_t *count);

typedef struct {
    FILE *stream;
    jlt_writer_text text;
    jlt_writer_complete complete; /* NULL: rows come complete; may be set after the writer is opened */
    void *context;
    size_t width; /* bytes of a row */
    unsigned threads;
    size_t room, count; /* how many rows `rows` holds at most; how many wait in it */
    char *rows;
} jlt_writer;

/** Open a writer of rows, `width` bytes each. room: how many rows are collected before they are written; 1: the caller's thread
 *  writes each row at once. Errors: NOMEM. */
JLT_CHECKED jlt_status jlt_writer_open(jlt_writer *self, FILE *stream, jlt_writer_text text, void *context, size_t width,
                                       size_t room, unsigned threads);
void jlt_writer_close(jlt_writer *self); /* rows that wait are lost; legal when zeroed */

/** Put a row behind those that wait, and write all when they are `room`; write the rows that wait. Errors: NOMEM; IO, if
 *  ferror(stream) is set; those of `complete`. */
JLT_CHECKED jlt_status jlt_writer_put(jlt_writer *self, const void *row);
JLT_CHECKED jlt_status jlt_writer_flush(jlt_writer *self);

#endif
