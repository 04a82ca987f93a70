/** The comment header of CSV files: enough to repeat the run. */
#ifndef JLT_REPORT_CSV_H
#define JLT_REPORT_CSV_H

#include "kernel_abi.h"

#include <stdio.h>

/** What the header of a table tells. */
typedef struct {
    const char *command; /* as typed; NULL: not known */
    const jlt_descriptor *descriptor;
    const double *params; /* (param_count,), NaN for one that changes from row to row */
    const char *const *level_names; /* (level_count,) */
    const double *levels;           /* their values, (level_count,), NaN for one that changes from row to row */
    size_t level_count;
    const char *method;  /* of integration; NULL: none */
    double tolerance;    /* of the method */
    const char *unproved; /* claims on which the columns rest, and which are not proved; NULL: what the descriptor says of itself */
} jlt_csv_settings;

/** Write lines that begin with "# ": the command, the version, the kernel with the hash of its table, and the parameters
 *  with the digits that read back bit for bit; then the same as one object of JSON, whose keys are command, version, model,
 *  variant, time, elimination, table (SHA-256), generator, parameters, levels, method, tolerance, in this order, null where there
 *  is none, without parameters and levels that change from row to row. Failures show in ferror(stream); where memory is out there
 *  is no JSON. */
void jlt_csv_header(FILE *stream, const jlt_csv_settings *settings);

/** The line of the columns' names. */
typedef struct {
    FILE *file, *line;
    char *text; /* of the line; owned */
    size_t size;
} jlt_csv_names;

/** Returns the stream to which names are to be written, with commas between them and no newline; then write them to the file, and
 *  the newline. No two of them are alike: one that is there already, as where a table has a state called t, becomes NAME_2, as in
 *  arrays of NumPy. Where memory is out they are as they were given. */
FILE *jlt_csv_names_begin(jlt_csv_names *self, FILE *file);
void jlt_csv_names_end(jlt_csv_names *self);

/* Write a number that reads back bit for bit (jlt_digits_shortest); nothing for one that is not finite, so that a field is a number
 * or empty. */
void jlt_csv_value(FILE *stream, double value);

/* Write numbers, shape (count,), with commas between them and no newline. */
void jlt_csv_values(FILE *stream, const double *values, size_t count);

/* The same with a comma before each number, where a row goes on. */
void jlt_csv_more(FILE *stream, const double *values, size_t count);

/* Write a whole row: numbers with commas between them, and a newline. */
void jlt_csv_row(FILE *stream, const double *values, size_t count);

#endif
