/** The comment header of CSV files: enough to repeat the run. */
#ifndef JLT_REPORT_CSV_H
#define JLT_REPORT_CSV_H

#include "kernel_abi.h"

#include <stdio.h>

/** What a table's header tells. */
typedef struct {
    const char *command; /* as typed; NULL: not known */
    const jlt_descriptor *descriptor;
    const double *params; /* (params,), NaN where one runs over the rows */
    const char *const *level_names; /* (level_count,), and their values, NaN likewise */
    const double *levels;
    size_t level_count;
    const char *method;  /* of integration; NULL: none */
    double tolerance;    /* of it */
} jlt_csv_settings;

/** Write lines that begin with "# ": the command, the version, the kernel with the hash of its table, and the parameters
 *  with the digits that read back bit for bit; then the same as one object of JSON, whose keys are command, version, model, variant,
 *  time, elimination, table (SHA-256), generator, parameters, levels, method, tolerance, in this order, null where there is none,
 *  without what runs over the rows. Failures show in ferror(stream); where memory is out there is no JSON. */
void jlt_csv_header(FILE *stream, const jlt_csv_settings *settings);

/* A number that reads back bit for bit, see jlt_digits_shortest; nothing for one that is not finite, so that a field is a number or
 * empty. */
void jlt_csv_value(FILE *stream, double value);

/* Numbers as above with commas between them, and no newline. */
void jlt_csv_values(FILE *stream, const double *values, size_t count);

/* The same with a comma before each: the row goes on. */
void jlt_csv_more(FILE *stream, const double *values, size_t count);

/* Numbers with commas between them, ended by a newline. */
void jlt_csv_row(FILE *stream, const double *values, size_t count);

#endif
