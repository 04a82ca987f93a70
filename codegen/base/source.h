/* The text of a table: read within bounds, checked before any word is taken from it. */
#ifndef TTC_SOURCE_H
#define TTC_SOURCE_H

#include "base/diagnostic.h"

enum { TTC_SOURCE_LIMIT = 1 << 20 }; /* bytes of a table */

/* The whole file, NUL-terminated, for the caller to free; NULL after a report. One byte more than the limit is read at
 * most, so that a larger file is seen to be one. */
char *ttc_source_read(const char *path, size_t *length, ttc_diagnostics *diagnostics);

/* UTF-8, no NUL, no carriage return or other control character but tab and line feed, within the limit. */
bool ttc_source_check(const char *text, size_t length, ttc_diagnostics *diagnostics);

#endif
