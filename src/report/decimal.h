/** Writes names with their values for readers: with the fewest digits that read back, or rounded. */
#ifndef JLT_REPORT_DECIMAL_H
#define JLT_REPORT_DECIMAL_H

#include "kernel_abi.h"

#include <stddef.h>
#include <stdio.h>

/* Write " NAME=VALUE" for each value that is not NaN. values: shape (count,). Errors show in ferror(stream). */
void jlt_decimal_write_named(FILE *stream, const jlt_quantity *quantities, const double *values, size_t count);

/* Write "NAME 0.12, NAME 3.4e-05, NAME unknown": values to three digits, unknown for a NaN. */
void jlt_decimal_write_rounded(FILE *stream, const jlt_quantity *quantities, const double *values, size_t count);

/* Write "error < 2.7e-15", two digits rounded up so that the text is a bound as well; "exactly" for an error of 0, "or near it" for
 * a NaN. */
void jlt_decimal_write_error(FILE *stream, double error);

#endif
