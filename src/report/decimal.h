/** Writes names with their values for people, each with the fewest digits that read back. */
#ifndef JLT_REPORT_DECIMAL_H
#define JLT_REPORT_DECIMAL_H

#include "kernel_abi.h"

#include <stddef.h>
#include <stdio.h>

/* " NAME=VALUE" for each that is not NaN. values: shape (count,). Errors of the stream are its own. */
void jlt_decimal_write_named(FILE *stream, const jlt_quantity *quantities, const double *values, size_t count);

/* "NAME 0.12, NAME 3.4e-05, NAME unknown": to three digits, unknown where it is NaN. */
void jlt_decimal_write_rounded(FILE *stream, const jlt_quantity *quantities, const double *values, size_t count);

#endif
