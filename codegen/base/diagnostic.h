/** Errors and warnings about tables, collected and printed in order of file and place, in one form:
 *
 *      FILE:LINE:COLUMN: error: what is wrong (what was expected)
 *          the line
 *             ^                                                                                              */
#ifndef TTC_DIAGNOSTIC_H
#define TTC_DIAGNOSTIC_H

#include "base/text.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* A file that cannot be read is an error without a place: `FILE: error: ...`. */
typedef enum { TTC_ERROR, TTC_WARNING, TTC_IO_ERROR } ttc_severity;

typedef struct {
    ttc_severity severity;
    uint32_t line, column; /* 1-based; column counts bytes */
    const char *file, *message;
} ttc_diagnostic;

typedef struct ttc_diagnostics ttc_diagnostics;

enum {
    TTC_DIAGNOSTIC_LIMIT = 50, /* errors and warnings kept of one file; the rest are counted */
    TTC_DIAGNOSTIC_LINE = 512  /* enough for one in a line, most often */
};

ttc_diagnostics *ttc_diagnostics_create(void); /* NULL when memory is out */
void ttc_diagnostics_destroy(ttc_diagnostics *diagnostics); /* legal on NULL */

/* The text that later places refer to; both borrowed, and used by the reports that follow only: they keep copies. */
void ttc_diagnostics_source(ttc_diagnostics *diagnostics, const char *file, const char *text, size_t length);

TTC_PRINTF(5, 6)
void ttc_report(ttc_diagnostics *diagnostics, ttc_severity severity, uint32_t line, uint32_t column, const char *format, ...);

/* Errors of all kinds, kept or not; those of them that are TTC_IO_ERROR; warnings. */
size_t ttc_error_count(const ttc_diagnostics *diagnostics);
size_t ttc_io_error_count(const ttc_diagnostics *diagnostics);
size_t ttc_warning_count(const ttc_diagnostics *diagnostics);

/* Those kept, in order. Strings live as long as `diagnostics`. */
size_t ttc_diagnostics_size(const ttc_diagnostics *diagnostics);
ttc_diagnostic ttc_diagnostics_at(const ttc_diagnostics *diagnostics, size_t index);

/* The first error in one line, `FILE:LINE:COLUMN: what is wrong`, for messages about what needs the file; "" when there is none. */
void ttc_diagnostics_first_error(const ttc_diagnostics *diagnostics, char *out, size_t size);

void ttc_diagnostics_print(const ttc_diagnostics *diagnostics, FILE *stream);

#endif
