/** Errors and warnings about tables, collected, and printed in order of source, line and column, in one form:
 *
 *      FILE:LINE:COLUMN: error: what is wrong (what was expected)
 *          the line
 *             ^                                                                                              */
#ifndef TTC_DIAGNOSTIC_H
#define TTC_DIAGNOSTIC_H

#include "base/text.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* That a file cannot be read, or that memory is out while it is, is an error without a place: `FILE: error: ...`. */
typedef enum { TTC_ERROR, TTC_WARNING, TTC_IO_ERROR, TTC_MEMORY_ERROR } ttc_severity;

typedef struct {
    ttc_severity severity;
    uint32_t line, column; /* 1-based; column counts bytes */
    const char *file, *message;
} ttc_diagnostic;

typedef struct ttc_diagnostics ttc_diagnostics;

enum {
    TTC_DIAGNOSTIC_LIMIT = 50, /* errors and warnings kept of one source; the rest are counted */
    TTC_DIAGNOSTIC_LINE = 512  /* bytes of a buffer that holds most diagnostics as one line; longer ones are cut */
};

ttc_diagnostics *ttc_diagnostics_create(void); /* NULL when memory is out */
void ttc_diagnostics_destroy(ttc_diagnostics *diagnostics); /* legal on NULL */

/* Begin a new source: lines and columns of later reports refer to `text`. Both strings are borrowed, and must stay valid until the
 * last report about this source; reports keep copies of what they show. */
void ttc_diagnostics_source(ttc_diagnostics *diagnostics, const char *file, const char *text, size_t length);

/* Record one error or warning. line, column: 1-based, 0 for an error without a place. Messages longer than 511 bytes are cut. */
TTC_PRINTF(5, 6)
void ttc_report(ttc_diagnostics *diagnostics, ttc_severity severity, uint32_t line, uint32_t column, const char *format, ...);

/* Numbers of reports, including those beyond the limit: all errors; TTC_IO_ERROR alone; TTC_MEMORY_ERROR alone; warnings. */
size_t ttc_error_count(const ttc_diagnostics *diagnostics);
size_t ttc_io_error_count(const ttc_diagnostics *diagnostics);
size_t ttc_memory_error_count(const ttc_diagnostics *diagnostics);
size_t ttc_warning_count(const ttc_diagnostics *diagnostics);

/* The reports that were kept, in the order in which they are printed. Strings live as long as `diagnostics`. */
size_t ttc_diagnostics_size(const ttc_diagnostics *diagnostics);
ttc_diagnostic ttc_diagnostics_at(const ttc_diagnostics *diagnostics, size_t index);

/* Write the first error as one line, `FILE:LINE:COLUMN: what is wrong`, to out, which holds `size` bytes; "" when there is no
 * error. For messages of callers that need the file and cannot use it. */
void ttc_diagnostics_first_error(const ttc_diagnostics *diagnostics, char *out, size_t size);

void ttc_diagnostics_print(const ttc_diagnostics *diagnostics, FILE *stream);

#endif
