/** The comment header of CSV files: enough to repeat the run. */
#ifndef JLT_REPORT_CSV_H
#define JLT_REPORT_CSV_H

#include "kernel_abi.h"

#include <stdio.h>

/** Write lines that begin with "# ": the command, the version, the kernel with the hash of its table, and the parameters
 *  with the digits that read back bit for bit. Failures show in ferror(stream).
 *  In: command, what was typed, or NULL; descriptor; params, shape (params,), NaN where one runs over the rows. */
void jlt_csv_header(FILE *stream, const char *command, const jlt_descriptor *descriptor, const double *params);

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
