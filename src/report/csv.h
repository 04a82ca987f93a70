/** CSV files: the comment header, from which a run can be repeated; column names; numbers. */
#ifndef JLT_REPORT_CSV_H
#define JLT_REPORT_CSV_H

#include "kernel_abi.h"

#include <stdio.h>

/** What the comment header of a table says. */
typedef struct {
    const char *command; /* the command line as typed; NULL: not known */
    const jlt_descriptor *descriptor;
    const jlt_quantity *quantities; /* (param_count,), the parameters; NULL: those of the descriptor, in its order and number */
    size_t param_count;
    const double *params; /* (param_count,), NaN for one that changes from row to row */
    const char *const *level_names; /* (level_count,) */
    const double *levels;           /* their values, (level_count,), NaN for one that changes from row to row */
    size_t level_count;
    const char *method;  /* of integration; NULL: none */
    double tolerance;    /* of the method */
    const char *unproved; /* names of the unproved claims on which the columns rest; NULL: those of the descriptor */
} jlt_csv_settings;

/** Write lines that begin with "# ": the command, the version, the kernel with the hash of its table, and the parameters with the
 *  digits that read back bit for bit; then the same as one JSON object. Its keys are command, version, model, variant, time,
 *  elimination, table (SHA-256), generator, parameters, levels, method, tolerance, in this order, null where there is no value, and
 *  `unproved` if any claim is. Parameters and levels that change from row to row are left out. Failures show in ferror(stream); the
 *  JSON is missing when memory is out. */
void jlt_csv_header(FILE *stream, const jlt_csv_settings *settings);

/** The line of column names, while it is being written. */
typedef struct {
    FILE *file, *line; /* where the names go; a stream in memory that collects them */
    char *text;        /* what `line` has collected; owned */
    size_t size;
} jlt_csv_names;

/** _begin returns a stream, to which the caller writes the names with commas between them and no newline; _end writes them to the
 *  file, and a newline. A name that occurs twice, as where a table has a state called t, becomes NAME_2, as in NumPy arrays. When
 *  memory is out the names are written as given. */
FILE *jlt_csv_names_begin(jlt_csv_names *self, FILE *file);
void jlt_csv_names_end(jlt_csv_names *self);

/* Write a number that reads back bit for bit (jlt_digits_shortest), except that -0 is written as 0; nothing for a value that is not
 * finite, so that a field is a number or empty. */
void jlt_csv_value(FILE *stream, double value);

/* Write numbers, shape (count,), with commas between them and no newline. */
void jlt_csv_values(FILE *stream, const double *values, size_t count);

/* The same for a stream whose text goes to jlt_npy_take alone: as bits (report/bits.h), a tenth of the time. */
void jlt_csv_bits(FILE *stream, const double *values, size_t count);

/* The same as jlt_csv_values with a comma before each number, to continue a row. */
void jlt_csv_more(FILE *stream, const double *values, size_t count);

/* Write a whole row: numbers with commas between them, and a newline. */
void jlt_csv_row(FILE *stream, const double *values, size_t count);

#endif
