/** Doubles as decimal text for people: as short as reads back to the same double. */
#ifndef JLT_REPORT_DECIMAL_H
#define JLT_REPORT_DECIMAL_H

#include "kernel_abi.h"

#include <stddef.h>
#include <stdio.h>

enum { JLT_DECIMAL_SIZE = 32 };

/* Shape (JLT_DECIMAL_SIZE,). NaN and infinities as printf writes them. */
void jlt_decimal_text(char *text, double value);

/* " NAME=VALUE" for each that is not NaN. values: shape (count,). Errors of the stream are its own. */
void jlt_decimal_write_named(FILE *stream, const jlt_quantity *quantities, const double *values, size_t count);

#endif
