/** Errors and warnings about a table, collected in order and printed in one form:
 *
 *      FILE:LINE:COLUMN: error: what is wrong (what was expected)
 *          the line
 *             ^                                                                                              */
#ifndef TTC_DIAGNOSTIC_H
#define TTC_DIAGNOSTIC_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef enum { TTC_ERROR, TTC_WARNING } ttc_severity;

typedef struct ttc_diagnostics ttc_diagnostics;

enum { TTC_DIAGNOSTIC_LIMIT = 50 }; /* errors kept; the rest are counted */

ttc_diagnostics *ttc_diagnostics_create(void); /* NULL when memory is out */
void ttc_diagnostics_destroy(ttc_diagnostics *diagnostics); /* legal on NULL */

/* The text that later places refer to; borrowed, must outlive the reports made about it. */
void ttc_diagnostics_source(ttc_diagnostics *diagnostics, const char *file, const char *text, size_t length);

#if defined(__GNUC__)
__attribute__((format(printf, 5, 6)))
#endif
void ttc_report(ttc_diagnostics *diagnostics, ttc_severity severity, uint32_t line, uint32_t column, const char *format,
                ...);

size_t ttc_error_count(const ttc_diagnostics *diagnostics);
size_t ttc_warning_count(const ttc_diagnostics *diagnostics);
void ttc_diagnostics_print(const ttc_diagnostics *diagnostics, FILE *stream);

#endif
